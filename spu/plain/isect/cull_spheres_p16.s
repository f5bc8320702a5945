# cull_spheres_p16   which of sixteen packets some eye ray may enter a sphere from, sphere by sphere
#   C       void cull_spheres_p16(const struct packet *, const struct pair *, int count,
#                                 unsigned *);
#   In      $3 the middle directions of sixteen packets, as a packet; $4 list whose entries' first
#           words are the addresses of spheres; $5 count (at least 1); $6 where masks go, a word in
#           every fourth; the other pointers 16-aligned
#   Out     a mask a sphere: 16 bits, the highest of packet 0
#   Uses    $4-$6, $10-$61   Saves  -   Stack  0   Calls  -
#   Domain  |d| = 1 within 4 ulp; limits as the PPU makes them
#   Error   0: no packet is left out a ray of which enters
#   Twin    oracle/src/twin/cull.rs
#
# As filter_spheres_r16, with the cone of the sphere widened by that of a packet.

        .include "work_unit.inc"
        .include "macros.inc"

        .set    a_middles,3
        .set    a_list,4
        .set    count,5
        .set    a_mask,6
        # constants
        .set    m_x,10
        .set    m_y,11
        .set    m_z,12
        .set    m_limit,13
        .set    m_signs,14                              # top bytes of two quadwords' words
        .set    m_halves,15                             # packets 15, 0 to 14: see the rotation
        .set    m_word,16
        # the middles
        .set    dx,20
        .set    dy,24
        .set    dz,28
        # the sphere
        .set    a_sphere,34
        .set    quad,35
        .set    more,36
        .set    cx,37
        .set    cy,38
        .set    cz,39
        .set    limit,40
        # temporaries
        .set    s,41                                    # to 44
        .set    signs,45
        .set    signs_low,46
        .set    masks,47

        .section .rodata
        .align  4
signs_of_two:
        .int    0x0004080c,0x1014181c,0x0004080c,0x1014181c
halves: .int    0x17000102,0x03040506,0x07101112,0x13141516

function cull_spheres_p16
        load_constant $m_x,0x00010203
        load_constant $m_y,0x04050607
        load_constant $m_z,0x08090a0b
        load_constant $m_limit,(SPHERE_packet_limit-16)*0x01010101+0x00010203
        cwd     $m_word,0($a_mask)
        lqa     $m_signs,signs_of_two
        lqa     $m_halves,halves
    .irp row, 0,1,2,3
        lqd     $dx+\row,PACKET_direction_x+16*\row($a_middles)
        lqd     $dy+\row,PACKET_direction_y+16*\row($a_middles)
        lqd     $dz+\row,PACKET_direction_z+16*\row($a_middles)
    .endr
next_sphere:
        lqd     $a_sphere,0($a_list)
        lqd     $quad,0($a_sphere)
        lqd     $more,16($a_sphere)
        shufb   $cx,$quad,$quad,$m_x
        shufb   $cy,$quad,$quad,$m_y
        shufb   $cz,$quad,$quad,$m_z
        shufb   $limit,$more,$more,$m_limit
    .irp row, 0,1,2,3
        fnms    $s+\row,$cx,$dx+\row,$limit
        fnms    $s+\row,$cy,$dy+\row,$s+\row
        fnms    $s+\row,$cz,$dz+\row,$s+\row
    .endr
        shufb   $signs,$s,$s+1,$m_signs
        shufb   $signs_low,$s+2,$s+3,$m_signs
        shufb   $signs,$signs,$signs_low,$m_halves
        rotqbii $signs,$signs,1                         # the sign of byte k to the end of byte k-1
        gbb     $signs,$signs
        lqd     $masks,0($a_mask)
        shufb   $masks,$signs,$masks,$m_word
        stqd    $masks,0($a_mask)
        ai      $a_list,$a_list,PAIR_SIZE
        ai      $a_mask,$a_mask,16
        ai      $count,$count,-1
        brnz    $count,next_sphere
        bi      $lr
endfunction cull_spheres_p16
