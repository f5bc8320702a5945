# shear_r16   what isect_triangles_r16 and any_triangles_r16 need to know of sixteen rays
#   C       void shear_r16(const struct rays *, struct shear *);
#   In      $3 rays, $4 shear; pointers 16-aligned
#   Out     shear
#   Uses    $10-$37   Saves  -   Stack  0   Calls  -
#   Domain  the longest component of a direction is from 2^-62 to 2^62
#   Error   1.5 ulp: of 1 in the slopes, of itself in 1 / direction z
#   Twin    lab/twins/src/triangle.rs
#
# The longest component of the direction becomes z, the two after it, in cyclic order, x and y. A
# point (x, y, z), less the origin, then lies beside the ray by x - slope_x z and y - slope_y z, and
# its t is z / direction z. Slopes are at most 1.

        .include "work_unit.inc"
        .include "macros.inc"
        .include "rays.inc"
        .include "flat.inc"
        .include "shear_tmpl.inc"

        .set    a_rays,3
        .set    a_shear,4
        # constants
        .set    k_x,10
        .set    k_y,11
        .set    k_z,12
        .set    k_one,13
        .set    k_sign,14
        # the rays
        .set    origin_x,15
        .set    origin_y,16
        .set    origin_z,17
        .set    direction_x,18
        .set    direction_y,19
        .set    direction_z,20
        # results
        .set    axis_x,21
        .set    axis_y,22
        .set    axis_z,23
        .set    own_x,24                                # the origin in the ray's own order
        .set    own_y,25
        .set    own_z,26
        .set    slope_x,27
        .set    slope_y,28
        .set    minus_per_z,29
        # temporaries
        .set    x,30
        .set    y,31
        .set    z,32
        .set    inverse,33
        .set    t_y,34
        .set    t_e,35
        .set    c_y,36
        .set    c_z,37

function shear_r16
        shear_constants
    .irp row, 0,1,2,3
        shear_packet_row \row, RAYS
    .endr
        bi      $lr
endfunction shear_r16
