# ray_setup_r16   unit eye rays through the centres of the pixels of packets, nothing hit yet
#   C       void ray_setup_r16(const struct basis *, const struct place *, int count,
#                              unsigned background);
#   In      $3 basis, $4 places, $5 count (at least 1), $6 address of the background's record;
#           pointers 16-aligned
#   Out     the places' packets: direction, t, object
#   Uses    $4-$6, $10-$43   Saves  -   Stack  0   Calls  -
#   Domain  the direction through each pixel is not 0 and below 2^63 in length; pixels below 2^23
#   Error   1.5 ulp of 1, each component
#   Twin    oracle/src/twin/ray_setup.rs
#
# Register k of each direction component holds row k of the 4x4 pixels, a pixel a lane:
#   d = corner + fx right + fy down, over its length

        .include "work_unit.inc"
        .include "macros.inc"
        .include "math.inc"

        .set    a_basis,3
        .set    a_place,4
        .set    count,5
        .set    background,6
        # constants
        .set    k_half,10
        .set    k_one,11
        .set    k_lanes,12
        .set    k_far,13
        .set    m_packet,14
        .set    m_x,15
        .set    m_y,16
        .set    corner_x,17
        .set    corner_y,18
        .set    corner_z,19
        .set    right_x,20
        .set    right_y,21
        .set    right_z,22
        .set    down_x,23
        .set    down_y,24
        .set    down_z,25
        # the packet
        .set    place,26
        .set    a_packet,27
        .set    fx,28
        .set    fy,29
        .set    k_row,40                                # to 43: the row's number
        # the top row's directions, without down
        .set    base_x,30
        .set    base_y,31
        .set    base_z,32
        # temporaries
        .set    dx,33
        .set    dy,34
        .set    dz,35
        .set    length,36
        .set    inverse,37
        .set    t_y,38
        .set    t_e,39

        .section .rodata
        .align  4
lanes:  .float  0,1,2,3

function ray_setup_r16
        splat_mask $m_packet
        splat   $background,$background,$m_packet
        load_constant $m_x,0x08090a0b
        load_constant $m_y,0x0c0d0e0f
        lqa     $k_lanes,lanes
        ilhu    $k_half,0x3f00
        ilhu    $k_one,0x3f80
        load_constant $k_far,0x7fffffff
        il      $k_row,0
        ilhu    $k_row+1,0x3f80
        ilhu    $k_row+2,0x4000
        ilhu    $k_row+3,0x4040
    .irp axis, x,y,z
        .ifc    \axis,x
        .set    offset,0
        .else
        .set    offset,offset+16
        .endif
        lqd     $corner_\axis,BASIS_corner+offset($a_basis)
        lqd     $right_\axis,BASIS_right+offset($a_basis)
        lqd     $down_\axis,BASIS_down+offset($a_basis)
    .endr
next_packet:
        lqd     $place,0($a_place)
        rotqbyi $a_packet,$place,PLACE_packet
        csflt   $fx,$place,0                            # its words x and y
        shufb   $fy,$fx,$fx,$m_y
        shufb   $fx,$fx,$fx,$m_x
        fa      $fx,$fx,$k_lanes
        fma     $base_x,$fx,$right_x,$corner_x
        fma     $base_y,$fx,$right_y,$corner_y
        fma     $base_z,$fx,$right_z,$corner_z
    .irp row, 0,1,2,3
        fa      $t_y,$fy,$k_row+\row
        fma     $dx,$t_y,$down_x,$base_x
        fma     $dy,$t_y,$down_y,$base_y
        fma     $dz,$t_y,$down_z,$base_z
        fm      $length,$dx,$dx
        fma     $length,$dy,$dy,$length
        fma     $length,$dz,$dz,$length                 # squared
        rsqrt_f4 $inverse,$length,$t_y,$t_e,$k_half,$k_one
        fm      $dx,$dx,$inverse
        fm      $dy,$dy,$inverse
        fm      $dz,$dz,$inverse
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
