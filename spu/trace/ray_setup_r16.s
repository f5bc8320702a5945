# ray_setup_r16   unit primary rays through the centres of the pixels of packets, nothing hit yet
#   C       void ray_setup_r16(const struct basis *, const struct place *, int count,
#                              unsigned background);
#   In      $3 basis, $4 places, $5 count (at least 1), $6 address of the background's record;
#           pointers 16-aligned
#   Out     the places' packets: direction, t, object
#   Uses    $4-$6, $10-$43   Saves  -   Stack  0   Calls  -
#   Domain  the direction through each pixel is not 0 and below 2^63 in length; pixels below 2^23
#   Error   1.5 ulp of 1, each component
#   Twin    lab/twins/src/ray_setup.rs

        .include "work_unit.inc"
        .include "macros.inc"
        .include "math.inc"
        .include "primary_ray_tmpl.inc"

        .set    NEXT,3
        registers a_basis,a_place,count,background
        # constants
        .set    NEXT,12
        registers k_lanes,k_far,m_packet,m_x,m_y
        # the packet
        .set    NEXT,26
        registers place,a_packet

        quadword_constants
lanes:  .float  0,1,2,3

function ray_setup_r16
        splat_mask $m_packet
        splat   $background,$background,$m_packet
        load_constant $m_x,0x08090a0b
        load_constant $m_y,0x0c0d0e0f
        lqa     $k_lanes,lanes
        ilhu    $k_far,FARTHEST>>16
        load_camera $a_basis
next_packet:
        lqd     $place,0($a_place)
        rotqbyi $a_packet,$place,PLACE_packet
        csflt   $fx,$place,0                            # its words x and y
        shufb   $fy,$fx,$fx,$m_y
        shufb   $fx,$fx,$fx,$m_x
        fa      $fx,$fx,$k_lanes
        primary_ray_columns
    .irp row, 0,1,2,3
        primary_ray_row \row
        stqd    $dx,PACKET_direction_x+16*\row($a_packet)
        stqd    $dy,PACKET_direction_y+16*\row($a_packet)
        stqd    $dz,PACKET_direction_z+16*\row($a_packet)
        stqd    $k_far,PACKET_t+16*\row($a_packet)
        stqd    $background,PACKET_object+16*\row($a_packet)
    .endr
        ai      $a_place,$a_place,PLACE_SIZE
        ai      $count,$count,-1
        brnz    $count,next_packet
        bi      $lr
endfunction ray_setup_r16
