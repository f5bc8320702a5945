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

        .set    NEXT,3
        registers a_rays,a_shear,a_triangle,count,object
        # constants
        .set    NEXT,10
        registers k_above_one,k_sign,m_splat,a_controls
        # -t, carried from triangle to triangle. The rest of a hit is kept in the rays' record, so
        # that the pipelined loop has enough registers.
        registers n_best
        .set    NEXT,18
        registers best
        # the triangle
        registers vertex_a,vertex_b,vertex_c
        # temporaries
        registers xa,ya,za,xb,yb,zb,xc,yc,zc,axis,origin,slope
        .set    p,31                                    # reused
        .set    q,32                                    # reused
        registers u,v,w,det,inverse,t_y,t_e,n,outside
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
