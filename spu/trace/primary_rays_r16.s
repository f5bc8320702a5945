# primary_rays_r16   primary rays through the centres of pixels, as packets of rays from anywhere
#   C       void primary_rays_r16(const struct place *, int count, const struct basis *,
#                             unsigned background, int width, int height);
#   In      $3 places, $4 count (at least 1), $5 basis, $6 address of the background's OBJECT,
#           $7 width and $8 height of the picture; pointers 16-aligned
#   Out     the places' RAYS16, all of their words
#   Uses    $3-$8, $10-$63   Saves  -   Stack  0   Calls  -
#   Domain  the direction through each pixel is not 0 and below 2^63 in length; pixels below 2^23;
#           a place's pixels: the sum of its top left pixel, rows of TILE_WIDTH sums
#   Error   2 ulp of 1, each component of a direction
#   Twin    lab/twins/src/primary_rays.rs
#
# Rays beyond the right and lower edges of the picture are absent: t is -1, the weight is 0.

        .include "work_unit.inc"
        .include "macros.inc"
        .include "math.inc"
        .include "primary_ray_tmpl.inc"

        .set    NEXT,3
        registers a_place,count,a_basis,background,width
        registers height                                # of the picture
        # constants
        .set    NEXT,12
        registers k_lanes,k_far,m_splat,m_x,m_y
        .set    NEXT,44
        registers m_pixels,k_zero,k_absent
        registers k_offset                              # to 50: from the sum of the top left pixel
        .set    k_below,51                              # to 54: rows of the picture below this one
        .set    NEXT,55
        registers k_pitch
        # the packet
        .set    place,26
        .set    a_packet,27
        registers x,y,pixels,c_column
        # the row
        registers c_within,t,weight,pixel

        .set    SUM_SIZE,16

        quadword_constants
lanes:  .int    0,1,2,3

function primary_rays_r16
        splat_mask $m_splat
        splat   $background,$background,$m_splat
        splat   $width,$width,$m_splat
        splat   $k_below,$height,$m_splat
        load_constant $m_pixels,PLACE_pixels*0x01010101+0x00010203
        load_constant $m_x,PLACE_x*0x01010101+0x00010203
        load_constant $m_y,PLACE_y*0x01010101+0x00010203
        ilhu    $k_far,FARTHEST>>16
        ilhu    $k_absent,0xbf80
        il      $k_zero,0
        lqa     $k_lanes,lanes
        mpyi    $k_offset,$k_lanes,SUM_SIZE
        il      $k_pitch,SUM_SIZE*TILE_WIDTH
    .irp row, 1,2,3
        a       $k_offset+\row,$k_offset+\row-1,$k_pitch
        ai      $k_below+\row,$k_below,-\row
    .endr
        load_camera $a_basis
next_packet:
        lqd     $place,0($a_place)
        rotqbyi $a_packet,$place,PLACE_packet
        shufb   $pixels,$place,$place,$m_pixels
        shufb   $x,$place,$place,$m_x
        shufb   $y,$place,$place,$m_y
        a       $x,$x,$k_lanes
        cgt     $c_column,$width,$x
        csflt   $fx,$x,0
        csflt   $fy,$y,0
        primary_ray_columns
    .irp row, 0,1,2,3
        primary_ray_row \row
        stqd    $k_zero,RAYS16_origin_x+16*\row($a_packet)
        stqd    $k_zero,RAYS16_origin_y+16*\row($a_packet)
        stqd    $k_zero,RAYS16_origin_z+16*\row($a_packet)
        stqd    $dx,RAYS16_direction_x+16*\row($a_packet)
        stqd    $dy,RAYS16_direction_y+16*\row($a_packet)
        stqd    $dz,RAYS16_direction_z+16*\row($a_packet)
        stqd    $background,RAYS16_object+16*\row($a_packet)
        cgt     $c_within,$k_below+\row,$y
        and     $c_within,$c_within,$c_column
        selb    $t,$k_absent,$k_far,$c_within
        and     $weight,$c_within,$k_one
        a       $pixel,$pixels,$k_offset+\row
        stqd    $t,RAYS16_t+16*\row($a_packet)
        stqd    $weight,RAYS16_weight+16*\row($a_packet)
        stqd    $pixel,RAYS16_pixel+16*\row($a_packet)
    .endr
        ai      $a_place,$a_place,PLACE_SIZE
        ai      $count,$count,-1
        brnz    $count,next_packet
        bi      $lr
endfunction primary_rays_r16
