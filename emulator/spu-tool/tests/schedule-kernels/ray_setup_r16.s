# ray_setup_r16   sixteen unit primary rays through the centres of 4x4 pixels, nothing hit yet
#   C       void ray_setup_r16(const struct basis *, int x, int y, struct packet *);
#   In      $3 basis, $4 x and $5 y of the top left pixel, $6 packet; pointers 16-aligned
#   Out     packet: direction, t, object
#   Uses    $10-$35   Saves  -   Stack  0   Calls  -
#
# Register k of each direction component holds row k of the 4x4 pixels, a pixel a lane:
#   d = corner + fx right + fy down, over its length

        .include "kernel.inc"

        .set    a_basis,3
        .set    x,4
        .set    y,5
        .set    a_packet,6
        # constants
        .set    k_half,10
        .set    k_one,11
        .set    m_splat,12
        .set    down_x,13
        .set    down_y,14
        .set    down_z,15
        # the top row's directions, without down
        .set    base_x,16
        .set    base_y,17
        .set    base_z,18
        # temporaries
        .set    fx,19
        .set    fy,20
        .set    right,21
        .set    dx,22
        .set    dy,23
        .set    dz,24
        .set    length,25
        .set    inverse,26
        .set    t_y,27
        .set    t_e,28
        .set    k_far,29
        .set    k_none,30

        .section .rodata
        .align  4
lanes:  .int    0,1,2,3

function ray_setup_r16
        splat_mask $m_splat
        splat   $x,$x,$m_splat
        lqa     $fx,lanes
        a       $fx,$x,$fx
        csflt   $fx,$fx,0
        splat   $y,$y,$m_splat
        ilhu    $k_half,0x3f00
        ilhu    $k_one,0x3f80
        load_constant $k_far,0x7fffffff
        il      $k_none,0
    .irp axis, x,y,z
        .ifc    \axis,x
        .set    offset,0
        .else
        .set    offset,offset+16
        .endif
        lqd     $base_\axis,BASIS_corner+offset($a_basis)
        lqd     $right,BASIS_right+offset($a_basis)
        lqd     $down_\axis,BASIS_down+offset($a_basis)
        fma     $base_\axis,$fx,$right,$base_\axis
    .endr
    .irp row, 0,1,2,3
        ai      $fy,$y,\row
        csflt   $fy,$fy,0
        fma     $dx,$fy,$down_x,$base_x
        fma     $dy,$fy,$down_y,$base_y
        fma     $dz,$fy,$down_z,$base_z
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
        stqd    $k_none,PACKET_object+16*\row($a_packet)
    .endr
        bi      $lr
endfunction ray_setup_r16
