# isect_triangle_r1   nearest hit of one ray with one triangle, from both sides
#   C       void isect_triangle_r1(struct ray *, const struct triangle *, int object);
#   In      $3 ray, $4 triangle, $5 object number; pointers 16-aligned
#   Out     ray: t, object, u, v, if a hit has 0 < t < what was there
#   Uses    $5, $10-$68   Saves  -   Stack  0   Calls  -
#   Domain  as isect_triangles_r16; direction as shear_r16
#   Error   no rounding of its own: the bits of shear_r16 and isect_triangles_r16
#   Twin    lab/twins/src/triangle.rs
#
# The vertices, and then the edges, are in lanes 0 to 2, while isect_triangles_r16 has a ray in
# each lane.

        .include "macros.inc"
        .include "rays.inc"
        .include "flat.inc"
        .include "shear_tmpl.inc"
        .include "triangle_tmpl.inc"

        .set    NEXT,3
        registers a_ray,a_triangle,object
        # constants; k_x, k_y, k_z take word 0, 1, 2 into every lane
        .set    NEXT,10
        registers k_x,k_y,k_z,k_one,k_above_one,k_sign,m_pair_xy,m_pair_z,m_third_x,m_third_y
        registers m_third_z,m_next,m_last
        # the ray
        registers ray_origin,ray_direction,origin_x,origin_y,origin_z,direction_x,direction_y
        registers direction_z,n_best,nearest,u_best,v_best
        # its shear
        registers c_y,c_z,slope_x,slope_y,minus_per_z,x,y,z,inverse,t_y,t_e
        # the triangle: a vertex a register, then a vertex a lane
        registers vertex_a,vertex_b,vertex_c,all_x,all_y,all_z,own_x,own_y,own_z,za,zb,zc
        # the edges opposite to a, b and c
        registers p,q,last_x,last_y,next_x,next_y,edges,u,v,w,det
        .set    n,58                                    # reused
        .set    outside,59                              # reused
        .set    hit,64                                  # reused

        .section .rodata
        .align  4
# From vertices to coordinates: those of a and b, then those of c next to them.
pair_xy:
        .int    0x00010203,0x10111213,0x04050607,0x14151617
pair_z: .int    0x08090a0b,0x18191a1b,0x80808080,0x80808080
third_x:
        .int    0x00010203,0x04050607,0x10111213,0x80808080
third_y:
        .int    0x08090a0b,0x0c0d0e0f,0x14151617,0x80808080
third_z:
        .int    0x00010203,0x04050607,0x18191a1b,0x80808080
# The lane after and the lane before, of three.
next:   .int    0x04050607,0x08090a0b,0x00010203,0x80808080
last:   .int    0x08090a0b,0x00010203,0x04050607,0x80808080

function isect_triangle_r1
        lqd     $ray_direction,RAY_direction($a_ray)
        lqd     $ray_origin,RAY_origin($a_ray)
        lqd     $vertex_a,TRIANGLE_a($a_triangle)
        lqd     $vertex_b,TRIANGLE_b($a_triangle)
        lqd     $vertex_c,TRIANGLE_c($a_triangle)
    .irp mask, pair_xy,pair_z,third_x,third_y,third_z,next,last
        lqa     $m_\mask,\mask
    .endr
        ila     $k_x,0x10203
        load_constant $k_y,0x04050607
        load_constant $k_z,0x08090a0b
        ilhu    $k_one,0x3f80
        load_above_one $k_above_one
        ilhu    $k_sign,0x8000
        splat   $object,$object,$k_x
        lqd     $n_best,RAY_t($a_ray)
        lqd     $nearest,RAY_object($a_ray)
        lqd     $u_best,RAY_u($a_ray)
        lqd     $v_best,RAY_v($a_ray)
        xor     $n_best,$n_best,$k_sign
    .irp axis, x,y,z
        splat   $direction_\axis,$ray_direction,$k_\axis
        splat   $origin_\axis,$ray_origin,$k_\axis
    .endr
        shear_row
        shufb   $p,$vertex_a,$vertex_b,$m_pair_xy
        shufb   $q,$vertex_a,$vertex_b,$m_pair_z
        shufb   $all_x,$p,$vertex_c,$m_third_x
        shufb   $all_y,$p,$vertex_c,$m_third_y
        shufb   $all_z,$q,$vertex_c,$m_third_z
    .irp axis, x,y,z
        fs      $all_\axis,$all_\axis,$origin_\axis
    .endr
        by_longest $own_x,$all_y,$all_z,$all_x
        by_longest $own_y,$all_z,$all_x,$all_y
        by_longest $own_z,$all_x,$all_y,$all_z
        fnms    $own_x,$slope_x,$own_z,$own_x
        fnms    $own_y,$slope_y,$own_z,$own_y
        # Lane k gets the edge between the vertices before and after k.
        shufb   $last_x,$own_x,$own_x,$m_last
        shufb   $last_y,$own_y,$own_y,$m_last
        shufb   $next_x,$own_x,$own_x,$m_next
        shufb   $next_y,$own_y,$own_y,$m_next
        side_of_edge $edges,$last_x,$next_y,$last_y,$next_x,$p,$q
        splat   $u,$edges,$k_x
        splat   $v,$edges,$k_y
        splat   $w,$edges,$k_z
        splat   $za,$own_z,$k_x
        splat   $zb,$own_z,$k_y
        splat   $zc,$own_z,$k_z
        fa      $det,$u,$v
        fa      $det,$det,$w
        reciprocal_f4 $inverse,$det,$t_y,$t_e,$k_above_one
        fm      $u,$u,$inverse
        fm      $v,$v,$inverse
        fm      $w,$w,$inverse
        fm      $n,$u,$za
        fma     $n,$v,$zb,$n
        fma     $n,$w,$zc,$n
        fm      $n,$n,$minus_per_z
        or      $outside,$u,$v
        or      $outside,$outside,$w
        cgt     $hit,$n_best,$n                         # 0 < t < t_best
        andc    $hit,$hit,$outside
        rotmai  $hit,$hit,-31                           # the sign's mask
        selb    $n_best,$n_best,$n,$hit
        selb    $nearest,$nearest,$object,$hit
        selb    $u_best,$u_best,$u,$hit
        selb    $v_best,$v_best,$v,$hit
        xor     $n_best,$n_best,$k_sign
        stqd    $n_best,RAY_t($a_ray)
        stqd    $nearest,RAY_object($a_ray)
        stqd    $u_best,RAY_u($a_ray)
        stqd    $v_best,RAY_v($a_ray)
        bi      $lr
endfunction isect_triangle_r1
