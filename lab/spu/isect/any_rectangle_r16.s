# any_rectangle_r16   which of sixteen rays a parallelogram blocks
#   C       unsigned any_rectangle_r16(const struct rays *, const struct rectangle *);
#   In      $3 rays, $4 rectangle; pointers 16-aligned
#   Out     $3 a bit a ray, 0x8000 of the first: hit with 0 < t < rays.t
#   Uses    $3, $10-$51   Saves  -   Stack  0   Calls  -
#   Domain  as isect_rectangle_r16
#   Error   no rounding of its own: blocks exactly what isect_rectangle_r16 hits
#   Twin    lab/twins/src/rectangle.rs

        .include "macros.inc"
        .include "rays.inc"
        .include "flat.inc"
        .include "rectangle_tmpl.inc"

        .set    code,3
        .set    NEXT,3
        registers a_rays,a_rectangle
        # constants
        .set    NEXT,10
        registers k_x,k_y,k_z,k_one,k_sign
        .set    NEXT,42
        registers n_far,outside,c_v
        registers blocked                               # a row each; the signs count
        .set    NEXT,49
        registers low,m_rows,m_code

        sign_gathers_table

function any_rectangle_r16
        rectangle_masks
        load_rectangle RECTANGLE_point, RECTANGLE_normal, RECTANGLE_dual_u, RECTANGLE_dual_v
        ilhu    $k_one,0x3f80
        ilhu    $k_sign,0x8000
        lqa     $m_rows,sign_gathers
        lqa     $m_code,sign_gathers+16
    .irp row, 0,1,2,3
        plane_row \row
        outside_rectangle
        lqd     $n_far,RAYS_t+16*\row($a_rays)
        xor     $n_far,$n_far,$k_sign
        cgt     $blocked+\row,$n_far,$n                 # 0 < t < t_far
        andc    $blocked+\row,$blocked+\row,$outside
    .endr
        code_of_signs $code,blocked,$low,$m_rows,$m_code
        bi      $lr
endfunction any_rectangle_r16
