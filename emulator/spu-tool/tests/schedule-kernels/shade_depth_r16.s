# shade_depth_r16   the paper's shader: colours that fade to black with the distance of the hit
#   C       void shade_depth_r16(const struct packet *, const float (*table)[4],
#                                const struct depth *, struct colours *);
#   In      $3 packet, $4 colour table (entry 0 the background), $5 depth, $6 colours; 16-aligned
#   Out     colours
#   Uses    $10-$38   Saves  -   Stack  0   Calls  -
#
#   brightness = clamp((far - t) scale, 0, 1), 1 where nothing was hit
#   colour = table[object] brightness

        .include "kernel.inc"

        .set    a_packet,3
        .set    a_table,4
        .set    a_depth,5
        .set    a_colours,6
        # constants
        .set    k_zero,10
        .set    k_one,11
        .set    k_far,12
        .set    k_scale,13
        .set    m_interleave,14
        .set    m_low,15
        .set    m_high,16
        .set    m_third,17
        # a row
        .set    object,18
        .set    bright,19
        .set    c_none,20
        .set    c_over,21
        .set    offset0,22
        .set    offset1,23
        .set    offset2,24
        .set    offset3,25
        .set    entry0,26
        .set    entry1,27
        .set    entry2,28
        .set    entry3,29
        .set    rg01,30
        .set    rg23,31
        .set    b01,32
        .set    b23,33
        .set    red,34
        .set    green,35
        .set    blue,36
        .set    t,37

        .section .rodata
        .align  4
        # words of two quadwords A and B
interleave:
        .int    0x00010203,0x10111213,0x04050607,0x14151617 # A0 B0 A1 B1
low:    .int    0x00010203,0x04050607,0x10111213,0x14151617 # A0 A1 B0 B1
high:   .int    0x08090a0b,0x0c0d0e0f,0x18191a1b,0x1c1d1e1f # A2 A3 B2 B3
third:  .int    0x08090a0b,0x18191a1b,0x08090a0b,0x18191a1b # A2 B2 A2 B2

function shade_depth_r16
        lqa     $m_interleave,interleave
        lqa     $m_low,low
        lqa     $m_high,high
        lqa     $m_third,third
        lqd     $k_far,DEPTH_far($a_depth)
        lqd     $k_scale,DEPTH_scale($a_depth)
        il      $k_zero,0
        ilhu    $k_one,0x3f80
    .irp row, 0,1,2,3
        lqd     $object,PACKET_object+16*\row($a_packet)
        lqd     $t,PACKET_t+16*\row($a_packet)

        fs      $bright,$k_far,$t
        fm      $bright,$bright,$k_scale
        fcgt    $c_over,$k_zero,$bright
        selb    $bright,$bright,$k_zero,$c_over
        fcgt    $c_over,$bright,$k_one
        selb    $bright,$bright,$k_one,$c_over
        ceqi    $c_none,$object,0
        selb    $bright,$bright,$k_one,$c_none

        # Four table entries, one a lane, turned into lanes of red, green and blue.
        shli    $offset0,$object,4
        rotqbyi $offset1,$offset0,4
        rotqbyi $offset2,$offset0,8
        rotqbyi $offset3,$offset0,12
        lqx     $entry0,$a_table,$offset0
        lqx     $entry1,$a_table,$offset1
        lqx     $entry2,$a_table,$offset2
        lqx     $entry3,$a_table,$offset3
        shufb   $rg01,$entry0,$entry1,$m_interleave
        shufb   $rg23,$entry2,$entry3,$m_interleave
        shufb   $b01,$entry0,$entry1,$m_third
        shufb   $b23,$entry2,$entry3,$m_third
        shufb   $red,$rg01,$rg23,$m_low
        shufb   $green,$rg01,$rg23,$m_high
        shufb   $blue,$b01,$b23,$m_low

        fm      $red,$red,$bright
        fm      $green,$green,$bright
        fm      $blue,$blue,$bright
        stqd    $red,COLOURS_red+16*\row($a_colours)
        stqd    $green,COLOURS_green+16*\row($a_colours)
        stqd    $blue,COLOURS_blue+16*\row($a_colours)
    .endr
        bi      $lr
endfunction shade_depth_r16
