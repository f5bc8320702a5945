# isect_triangle_pairs_r16   nearest hit of packets' rays with triangles, candidate by candidate
#   C       void isect_triangle_pairs_r16(const struct candidate *, int count);
#   In      $3 candidates of objects that are triangles, and of shears of their packets, $4 count
#           (0 is none); pointers 16-aligned
#   Out     the candidates' packets: t, object, where a hit has 0 < t < what was there
#   Uses    $3-$4, $10-$46   Saves  -   Stack  0   Calls  -
#   Domain  distances from the origin below 2^60; triangles higher than 2^-50 across the ray
#   Error   6 ulp of t, 8e-5 in barycentric coordinates; edges from 1/100 of the distance to all of
#           it, area across the ray above 1/20 of their square
#   Twin    lab/twins/src/triangle_pairs.rs
#
# As watertight as isect_triangles_r16, with the same steps. But from the back, where the vertices
# are in clockwise order, a triangle is hit only with SIDES_BOTH. The order is counter-clockwise if
# the sum of u, v and w has the sign of direction z.

        .include "work_unit.inc"
        .include "macros.inc"
        .include "pairs.inc"
        .include "triangle_tmpl.inc"

        .set    NEXT,3
        registers a_candidate,count
        # constants
        .set    NEXT,10
        registers k_above_one,k_sign,m_splat,m_w,a_controls
        # the candidate
        registers object,a_packet,a_shear,both,vertex_a,vertex_b,vertex_c
        # temporaries
        registers xa,ya,za,xb,yb,zb,xc,yc,zc,axis,origin,slope
        .set    p,31                                    # reused
        .set    q,32                                    # reused
        registers u,v,w,det,inverse,t_y,t_e,n
        .set    NEXT,41
        registers ahead                                 # n
        registers outside,seen,t,t_best,nearest
        .set    control,43                              # reused

        sign_controls_table

function isect_triangle_pairs_r16
        biz     $count,$lr
        splat_mask $m_splat
        load_constant $m_w,0x0c0d0e0f
        load_above_one $k_above_one
        ilhu    $k_sign,0x8000
        ila     $a_controls,sign_controls
next_triangle:
        load_candidate
        load_both
        rotqbyi $a_shear,$object,CANDIDATE_shear
        lqd     $vertex_a,TRI_a($object)
        lqd     $vertex_b,TRI_b($object)
        lqd     $vertex_c,TRI_c($object)
        splat   $object,$object,$m_splat
    .irp row, 0,1,2,3
        triangle_row \row
        xor     $seen,$det,$slope                       # of -1 / direction z
        outside_if_behind $seen
        xor     $t,$n,$k_sign
        keep_nearer \row
    .endr
        next_candidate next_triangle
        bi      $lr
endfunction isect_triangle_pairs_r16
