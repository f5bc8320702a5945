# isect_triangle_mt_pairs_r16   nearest hit of packets' rays and triangles, after Moeller, Trumbore
#   C       void isect_triangle_mt_pairs_r16(const struct candidate *, int count);
#   In      $3 candidates of objects that are triangles, their shears not looked at, $4 count (0 is
#           none); pointers 16-aligned
#   Out     the candidates' packets: t, object, where a hit has 0 < t < what was there
#   Uses    $3-$4, $10-$58   Saves  -   Stack  0   Calls  -
#   Domain  |direction| about 1; edges and distances from the vertices between 2^-30 and 2^30
#   Error   24 ulp of t, 2e-4 in barycentric coordinates; edges from 1/100 of the distance to all
#           of it, area across the ray above 1/20 of their square
#   Twin    lab/twins/src/triangle_mt_pairs.rs
#
# Moeller and Trumbore 1997. Let e1 and e2 be the edges from vertex a, and s the vector from a to
# the origin. With the determinant e1.(d x e2), u is s.(d x e2), v is d.(s x e1) and t is e2.(s x
# e1), each divided by the determinant. Both cross products are reversed, so that the determinant's
# sign is set if the vertices are in counter-clockwise order. The back of a triangle is hit
# only with SIDES_BOTH. A ray parallel to the plane gets a t that is 0 or beyond everything, so it
# misses.
#
# It is not watertight: each triangle computes a shared edge from its own vertex and its own edges,
# and a ray may be rounded out of both triangles. Of rays from inside a closed mesh that are aimed
# at its edges and vertices, one in 10 leaks. If vertices are on a lattice, whose products are
# exact more often, one in 40 does (lab/kernels/tests/suite/flat/leaks.rs, where none passes
# isect_triangle_pairs_r16).

        .include "work_unit.inc"
        .include "macros.inc"
        .include "pairs.inc"
        .include "vectors.inc"

        .set    NEXT,3
        registers a_candidate,count
        # constants
        .set    NEXT,10
        registers k_one,k_zero,k_sign,m_x,m_y,m_z,m_w,a_controls
        # the candidate
        registers object,a_packet,both,vertex,edge_1,edge_2,a_x,a_y,a_z,e1_x,e1_y,e1_z,e2_x,e2_y
        registers e2_z
        # temporaries
        registers s_x,s_y,s_z,d_x,d_y,d_z,p_x,p_y,p_z,q_x,q_y,q_z,det,inverse,t_y,t_e,u,v,w,n
        .set    NEXT,52
        registers ahead                                 # n
        registers outside,seen,t,t_best,nearest,control

        sign_controls_table

# out = component z of a x b, where x, y, z are in order.
.macro  cross_component out:req, a:req, b:req, x:req, y:req
        fm      \out,$\a\()_\y,$\b\()_\x
        fms     \out,$\a\()_\x,$\b\()_\y,\out
.endm

.macro  cross_f4 out:req, a:req, b:req
        cross_component $\out\()_x,\a,\b,y,z
        cross_component $\out\()_y,\a,\b,z,x
        cross_component $\out\()_z,\a,\b,x,y
.endm

# Loads a vector of the candidate, with each component in every lane.
.macro  splat_vector out:req, vector:req
    .irp axis, x,y,z
        shufb   $\out\()_\axis,\vector,\vector,$m_\axis
    .endr
.endm

function isect_triangle_mt_pairs_r16
        biz     $count,$lr
        splat_words
        load_constant $m_w,0x0c0d0e0f
        ilhu    $k_one,0x3f80
        il      $k_zero,0
        ilhu    $k_sign,0x8000
        ila     $a_controls,sign_controls
next_triangle:
        load_candidate
        load_both
        lqd     $vertex,TRI_a($object)
        lqd     $edge_1,TRI_b($object)
        lqd     $edge_2,TRI_c($object)
        splat   $object,$object,$m_x
        fs      $edge_1,$edge_1,$vertex
        fs      $edge_2,$edge_2,$vertex
        splat_vector a,$vertex
        splat_vector e1,$edge_1
        splat_vector e2,$edge_2
    .irp row, 0,1,2,3
    .irp axis, x,y,z
        lqd     $s_\axis,RAYS16_origin_\axis+16*\row($a_packet)
        lqd     $d_\axis,RAYS16_direction_\axis+16*\row($a_packet)
        fs      $s_\axis,$s_\axis,$a_\axis
    .endr
        cross_f4 p,e2,d
        dot_f4  $det,e1,p
        cross_f4 q,e1,s
        reciprocal_f4 $inverse,$det,$t_y,$t_e,$k_one
        dot_f4  $u,s,p
        dot_f4  $v,d,q
        fnms    $n,$e2_x,$q_x,$k_zero
        fnms    $n,$e2_y,$q_y,$n
        fnms    $n,$e2_z,$q_z,$n
        fm      $u,$u,$inverse
        fm      $v,$v,$inverse
        fm      $n,$n,$inverse                          # -t
        fs      $w,$k_one,$u
        fs      $w,$w,$v
        or      $outside,$u,$v
        or      $outside,$outside,$w
        outside_if_behind $det
        xor     $t,$n,$k_sign
        keep_nearer \row
    .endr
        next_candidate next_triangle
        bi      $lr
endfunction isect_triangle_mt_pairs_r16
