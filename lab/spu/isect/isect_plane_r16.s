# isect_plane_r16   nearest hit of sixteen rays with a plane, from both sides
#   C       void isect_plane_r16(struct rays *, const struct rectangle *, int object);
#   In      $3 rays, $4 rectangle in the plane, $5 object number; pointers 16-aligned
#   Out     rays: t, object, u, v, where a hit has 0 < t < what was there
#   Uses    $5, $10-$46   Saves  -   Stack  0   Calls  -
#   Domain  as isect_rectangle_r16
#   Error   20 ulp of t, 5e-4 in u and v; edges from 1/100 of the distance to all of it, 30 degrees
#           or more apart; incidence within 84 degrees of the normal; u and v from
#           -0.5 to 1.5
#   Twin    lab/twins/src/rectangle.rs
#
# Like isect_rectangle_r16, but with any u and v. Its remark about rays parallel to the plane holds
# here too.

        .include "macros.inc"
        .include "rays.inc"
        .include "flat.inc"
        .include "rectangle_tmpl.inc"

        .set    NEXT,3
        registers a_rays,a_rectangle,object
        # constants
        .set    NEXT,10
        registers k_x,k_y,k_z,k_one,k_sign,a_controls
        .set    NEXT,42
        registers n_best,nearest,u_best,v_best,control

        sign_controls_table

function isect_plane_r16
        rectangle_masks
        load_rectangle RECTANGLE_point, RECTANGLE_normal, RECTANGLE_dual_u, RECTANGLE_dual_v
        splat   $object,$object,$k_x
        ilhu    $k_one,0x3f80
        ilhu    $k_sign,0x8000
        ila     $a_controls,sign_controls
    .irp row, 0,1,2,3
        plane_row \row
        lqd     $n_best,RAYS_t+16*\row($a_rays)
        lqd     $nearest,RAYS_object+16*\row($a_rays)
        lqd     $u_best,RAYS_u+16*\row($a_rays)
        lqd     $v_best,RAYS_v+16*\row($a_rays)
        xor     $n_best,$n_best,$k_sign
        cgt     $control,$n_best,$n                     # 0 < t < t_best
        sign_control $control,$control,$a_controls
        shufb   $n_best,$n_best,$n,$control
        shufb   $nearest,$nearest,$object,$control
        shufb   $u_best,$u_best,$u,$control
        shufb   $v_best,$v_best,$v,$control
        xor     $n_best,$n_best,$k_sign
        stqd    $n_best,RAYS_t+16*\row($a_rays)
        stqd    $nearest,RAYS_object+16*\row($a_rays)
        stqd    $u_best,RAYS_u+16*\row($a_rays)
        stqd    $v_best,RAYS_v+16*\row($a_rays)
    .endr
        bi      $lr
endfunction isect_plane_r16
