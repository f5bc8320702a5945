# sample_rays_r16   primary rays through the samples of pixels, as packets of rays from anywhere
#   C       void sample_rays_r16(const struct place *, int count, const struct basis *,
#                                unsigned background, int samples, struct rays16 *);
#   In      $3 places of pixels, four a packet, $4 count of packets (at least 1), $5 basis,
#           $6 address of the background's OBJECT, $7 samples of a pixel: 4 or 16, $8 packets;
#           pointers 16-aligned
#   Out     RAYS16, consecutive, all of their words
#   Uses    $3-$8, $10-$63   Saves  -   Stack  0   Calls  -
#   Domain  the direction through each sample is not 0 and below 2^63 in length; pixels below 2^18;
#           a place's pixels: the sum of the pixel
#   Error   2 ulp of 1, each component of a direction
#   Twin    lab/twins/src/sample_rays.rs
#
# Each place makes a row of four rays. Of 4 samples these are all, of 16 the row's number selects
# the sample. A place whose x is below 0 makes rays that are absent: t is -1, the weight is 0.
#
# Samples are a regular grid of n by n, turned so far that all have another x and another y:
#   x = i/n + j/n^2, y = j/n - i/n^2, from the first sample on, i and j from 0 to n - 1
# Edges that are nearly upright or level then have n^2 + 1 shades, not n + 1.
#
# The loop counts up, so that it isn't pipelined, which would double its size. The four rows of a
# packet fill one another's waits.

        .include "work_unit.inc"
        .include "macros.inc"
        .include "math.inc"
        .include "primary_ray_tmpl.inc"

        .set    NEXT,3
        registers a_place,count,a_basis,background,samples,a_packet
        # constants
        .set    NEXT,12
        registers k_far,m_x,m_y,m_pixels,k_zero
        .set    k_column,44                             # to 47: the x of a row's samples
        .set    k_absent,48
        # the row
        .set    place,26
        .set    NEXT,49
        registers x,y,pixels,c_absent,t,weight,a_pattern

        .section .rodata
        .align  4
        # x of the four rows' samples, then y, from the pixel's centre
samples_4:
    .rept   4
        .float  -0.375,0.125,-0.125,0.375
    .endr
    .rept   4
        .float  -0.125,-0.375,0.375,0.125
    .endr
samples_16:
        .float  -0.46875,-0.21875,0.03125,0.28125
        .float  -0.40625,-0.15625,0.09375,0.34375
        .float  -0.34375,-0.09375,0.15625,0.40625
        .float  -0.28125,-0.03125,0.21875,0.46875
        .float  -0.28125,-0.34375,-0.40625,-0.46875
        .float  -0.03125,-0.09375,-0.15625,-0.21875
        .float  0.21875,0.15625,0.09375,0.03125
        .float  0.46875,0.40625,0.34375,0.28125

function sample_rays_r16
        splat_mask $m_x
        splat   $background,$background,$m_x
        load_constant $m_pixels,PLACE_pixels*0x01010101+0x00010203
        load_constant $m_x,PLACE_x*0x01010101+0x00010203
        load_constant $m_y,PLACE_y*0x01010101+0x00010203
        ilhu    $k_far,FARTHEST>>16
        ilhu    $k_absent,0xbf80
        il      $k_zero,0
        load_camera $a_basis
        ila     $a_pattern,samples_4
        ceqi    $samples,$samples,16
        andi    $samples,$samples,samples_16-samples_4
        a       $a_pattern,$a_pattern,$samples
    .irp row, 0,1,2,3
        lqd     $k_column+\row,16*\row($a_pattern)
        lqd     $k_row+\row,64+16*\row($a_pattern)
    .endr
        sfi     $count,$count,0
next_packet:
    .irp row, 0,1,2,3
        lqd     $place,PLACE_SIZE*\row($a_place)
        shufb   $pixels,$place,$place,$m_pixels
        shufb   $x,$place,$place,$m_x
        shufb   $y,$place,$place,$m_y
        csflt   $fx,$x,0
        csflt   $fy,$y,0
        fa      $fx,$fx,$k_column+\row
        primary_ray_columns
        primary_ray_row \row
        stqd    $k_zero,RAYS16_origin_x+16*\row($a_packet)
        stqd    $k_zero,RAYS16_origin_y+16*\row($a_packet)
        stqd    $k_zero,RAYS16_origin_z+16*\row($a_packet)
        stqd    $dx,RAYS16_direction_x+16*\row($a_packet)
        stqd    $dy,RAYS16_direction_y+16*\row($a_packet)
        stqd    $dz,RAYS16_direction_z+16*\row($a_packet)
        stqd    $background,RAYS16_object+16*\row($a_packet)
        cgt     $c_absent,$k_zero,$x
        selb    $t,$k_far,$k_absent,$c_absent
        andc    $weight,$k_one,$c_absent
        stqd    $t,RAYS16_t+16*\row($a_packet)
        stqd    $weight,RAYS16_weight+16*\row($a_packet)
        stqd    $pixels,RAYS16_pixel+16*\row($a_packet)
    .endr
        ai      $a_place,$a_place,4*PLACE_SIZE
        ai      $a_packet,$a_packet,RAYS16_SIZE/2
        ai      $a_packet,$a_packet,RAYS16_SIZE/2
        ai      $count,$count,1
        brnz    $count,next_packet
        bi      $lr
endfunction sample_rays_r16
