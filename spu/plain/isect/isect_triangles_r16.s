# isect_triangles_r16   nearest hit of sixteen rays with the triangles of an array, from both sides
#   C       void isect_triangles_r16(struct rays *, const struct shear *,
#                                    const struct triangle *, int count, int object);
#   In      $3 rays, $4 what shear_r16 made of them, $5 triangles, $6 count (0 is none), $7 object
#           number of the first; pointers 16-aligned
#   Out     rays: t, object, u, v, where a hit has 0 < t < what was there
#   Uses    $5-$7, $10-$53   Saves  -   Stack  0   Calls  -
#   Domain  rays.t >= 0; distances from the origin below 2^60; triangles higher than 2^-60 across
#           the ray
#   Error   5 ulp of t, 5e-5 in u and v; edges from 1/100 of the distance to all of it, area across
#           the ray above 1/20 of their square
#   Twin    oracle/src/twin/triangle.rs

        .include "macros.inc"
        .include "rays.inc"
        .include "flat.inc"
        .include "triangle_tmpl.inc"

        .set    a_rays,3
        .set    a_shear,4
        .set    a_triangle,5
        .set    count,6
        .set    object,7
        # constants
        .set    k_above_one,10
        .set    k_sign,11
        .set    m_splat,12
        .set    a_controls,13
        # results, carried from triangle to triangle
        .set    n_best,14
        .set    nearest,18
        .set    u_best,22
        .set    v_best,26
        # the triangle
        .set    vertex_a,30
        .set    vertex_b,31
        .set    vertex_c,32
        # temporaries
        .set    xa,33
        .set    ya,34
        .set    za,35
        .set    xb,36
        .set    yb,37
        .set    zb,38
        .set    xc,39
        .set    yc,40
        .set    zc,41
        .set    axis,42
        .set    origin,43
        .set    slope,44
        .set    p,42                                    # reused
        .set    q,43                                    # reused
        .set    u,45
        .set    v,46
        .set    w,47
        .set    det,48
        .set    inverse,49
        .set    t_y,50
        .set    t_e,51
        .set    n,52
        .set    outside,53
        .set    control,48                              # reused

        sign_controls_table

function isect_triangles_r16
        biz     $count,$lr
        splat_mask $m_splat
        splat   $object,$object,$m_splat
        load_above_one $k_above_one
        ilhu    $k_sign,0x8000
        ila     $a_controls,sign_controls
    .irp row, 0,1,2,3
        lqd     $n_best+\row,RAYS_t+16*\row($a_rays)
        lqd     $nearest+\row,RAYS_object+16*\row($a_rays)
        lqd     $u_best+\row,RAYS_u+16*\row($a_rays)
        lqd     $v_best+\row,RAYS_v+16*\row($a_rays)
        xor     $n_best+\row,$n_best+\row,$k_sign
    .endr
next_triangle:
        lqd     $vertex_a,TRIANGLE_a($a_triangle)
        lqd     $vertex_b,TRIANGLE_b($a_triangle)
        lqd     $vertex_c,TRIANGLE_c($a_triangle)
    .irp row, 0,1,2,3
        triangle_row \row
        cgt     $control,$n_best+\row,$n                # 0 < t < t_best
        andc    $control,$control,$outside
        sign_control $control,$control,$a_controls
        shufb   $n_best+\row,$n_best+\row,$n,$control
        shufb   $nearest+\row,$nearest+\row,$object,$control
        shufb   $u_best+\row,$u_best+\row,$u,$control
        shufb   $v_best+\row,$v_best+\row,$v,$control
    .endr
        ai      $object,$object,1
        ai      $a_triangle,$a_triangle,TRIANGLE_SIZE
        ai      $count,$count,-1
        brnz    $count,next_triangle
    .irp row, 0,1,2,3
        xor     $n_best+\row,$n_best+\row,$k_sign
        stqd    $n_best+\row,RAYS_t+16*\row($a_rays)
        stqd    $nearest+\row,RAYS_object+16*\row($a_rays)
        stqd    $u_best+\row,RAYS_u+16*\row($a_rays)
        stqd    $v_best+\row,RAYS_v+16*\row($a_rays)
    .endr
        bi      $lr
endfunction isect_triangles_r16
