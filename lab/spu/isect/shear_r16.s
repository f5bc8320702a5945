# shear_r16   the shears of sixteen rays for isect_triangles_r16 and any_triangles_r16
#   C       void shear_r16(const struct rays *, struct shear *);
#   In      $3 rays, $4 shear; pointers 16-aligned
#   Out     shear
#   Uses    $10-$37   Saves  -   Stack  0   Calls  -
#   Domain  the longest component of a direction is from 2^-62 to 2^62
#   Error   1.5 ulp: of 1 in the slopes, of itself in 1 / direction z
#   Twin    lab/twins/src/triangle.rs
#
# The longest component of the direction becomes z, and the next two in cyclic order become x and
# y. A point (x, y, z) relative to the origin is then beside the ray by x - slope_x z and y -
# slope_y z, and its t is z / direction z. Slopes are at most 1.

        .include "work_unit.inc"
        .include "macros.inc"
        .include "rays.inc"
        .include "flat.inc"
        .include "shear_tmpl.inc"

        .set    NEXT,3
        registers a_rays,a_shear
        # constants
        .set    NEXT,10
        registers k_x,k_y,k_z,k_one,k_sign
        # the rays
        registers origin_x,origin_y,origin_z,direction_x,direction_y,direction_z
        # results
        registers axis_x,axis_y,axis_z
        registers own_x                                 # the origin in the ray's permuted axes
        registers own_y,own_z,slope_x,slope_y,minus_per_z
        # temporaries
        registers x,y,z,inverse,t_y,t_e,c_y,c_z

function shear_r16
        shear_constants
    .irp row, 0,1,2,3
        shear_packet_row \row, RAYS
    .endr
        bi      $lr
endfunction shear_r16
