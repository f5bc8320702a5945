# shear_packets_r16   what isect_triangle_pairs_r16 needs to know of packets' rays
#   C       void shear_packets_r16(const struct ray_packet *, int count, struct shear *);
#   In      $3 packets, one behind the other, $4 count (0 is none), $5 shears likewise; pointers
#           16-aligned
#   Out     shears
#   Uses    $3-$5, $10-$37   Saves  -   Stack  0   Calls  -
#   Domain  the longest component of a direction is from 2^-62 to 2^62
#   Error   1.5 ulp: of 1 in the slopes, of itself in 1 / direction z
#   Twin    lab/twins/src/triangle.rs
#
# Each as shear_r16 makes it.

        .include "work_unit.inc"
        .include "macros.inc"
        .include "flat.inc"
        .include "shear_tmpl.inc"

        .set    a_rays,3
        .set    count,4
        .set    a_shear,5
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
