# shear_packets_r16   the rays' values that isect_triangle_pairs_r16 uses
#   C       void shear_packets_r16(const struct ray_packet *, int count, struct shear *);
#   In      $3 packets, consecutive, $4 count (0 is none), $5 shears likewise; pointers
#           16-aligned
#   Out     shears
#   Uses    $3-$5, $10-$37   Saves  -   Stack  0   Calls  -
#   Domain  the longest component of a direction is from 2^-62 to 2^62
#   Error   1.5 ulp: of 1 in the slopes, of itself in 1 / direction z
#   Twin    lab/twins/src/triangle.rs
#
# The shears are those of shear_r16.

        .include "work_unit.inc"
        .include "macros.inc"
        .include "flat.inc"
        .include "shear_tmpl.inc"

        .set    NEXT,3
        registers a_rays,count,a_shear
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

function shear_packets_r16
        biz     $count,$lr
        shear_constants
next_packet:
    .irp row, 0,1,2,3
        shear_packet_row \row, RAYS16
    .endr
    .rept   2                                           # ai reaches to 511
        ai      $a_rays,$a_rays,RAYS16_SIZE/2
        ai      $a_shear,$a_shear,SHEARS_SIZE/2
    .endr
        ai      $count,$count,-1
        brnz    $count,next_packet
        bi      $lr
endfunction shear_packets_r16
