# isect_triangles_r16   nearest hit of sixteen rays with the triangles of an array, from both sides
#   C       void isect_triangles_r16(struct rays *, const struct shear *,
#                                    const struct triangle *, int count, int object);
#   In      $3 rays, $4 what shear_r16 made of them, $5 triangles, $6 count (0 is none), $7 object
#           number of the first; pointers 16-aligned
#   Out     rays: t, object, u, v, where a hit has 0 < t < what was there
#   Uses    $5-$7, $10-$42   Saves  -   Stack  0   Calls  -
#   Domain  rays.t >= 0; distances from the origin below 2^60; triangles higher than 2^-50 across
#           the ray
#   Error   6 ulp of t, 8e-5 in u and v; edges from 1/100 of the distance to all of it, area across
#           the ray above 1/20 of their square
#   Twin    lab/twins/src/triangle.rs

        .include "work_unit.inc"
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
        # -t, carried from triangle to triangle; the rest of a hit waits in the rays, so that the
        # pipelined loop has registers enough
        .set    n_best,14
        .set    best,18
        # the triangle
        .set    vertex_a,19
        .set    vertex_b,20
        .set    vertex_c,21
        # temporaries
        .set    xa,22
        .set    ya,23
        .set    za,24
        .set    xb,25
        .set    yb,26
        .set    zb,27
        .set    xc,28
        .set    yc,29
        .set    zc,30
        .set    axis,31
        .set    origin,32
        .set    slope,33
        .set    p,31                                    # reused
        .set    q,32                                    # reused
        .set    u,34
        .set    v,35
        .set    w,36
        .set    det,37
        .set    inverse,38
        .set    t_y,39
        .set    t_e,40
        .set    n,41
        .set    outside,42
        .set    control,37                              # reused

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
    .irp field, object,u,v
        lqd     $best,RAYS_\field+16*\row($a_rays)
        shufb   $best,$best,$\field,$control
        stqd    $best,RAYS_\field+16*\row($a_rays)
    .endr
    .endr
        ai      $object,$object,1
        ai      $a_triangle,$a_triangle,TRIANGLE_SIZE
        ai      $count,$count,-1
        brnz    $count,next_triangle
    .irp row, 0,1,2,3
        xor     $n_best+\row,$n_best+\row,$k_sign
        stqd    $n_best+\row,RAYS_t+16*\row($a_rays)
    .endr
        bi      $lr
endfunction isect_triangles_r16
