# cull_spheres_p64   for each sphere, a tile's packets whose primary rays may enter it
#   C       void cull_spheres_p64(const struct packet middles[4], const struct pair *, int count,
#                                 unsigned (*masks)[4]);
#   In      $3 the middle directions of each sixteen packets, as a packet; $4 list whose entries'
#           first words are the addresses of spheres; $5 count (at least 1); $6 where masks go;
#           pointers 16-aligned
#   Out     four masks a sphere, one for each sixteen packets: 16 bits, the highest of the first
#   Uses    $4-$6, $10-$36   Saves  -   Stack  0   Calls  -
#   Domain  |d| = 1 within 4 ulp; limits as the PPU makes them
#   Error   0: no packet is left out a ray of which enters
#   Twin    lab/twins/src/cull.rs
#
# Like filter_spheres_r16, but with the cone of the sphere widened by that of a packet.

        .include "work_unit.inc"
        .include "macros.inc"

        .set    NEXT,3
        registers a_middles,a_list,count,a_masks
        # constants
        .set    NEXT,10
        registers m_x,m_y,m_z,m_limit
        registers m_signs                               # top bytes of two quadwords' words
        registers m_halves                              # packets 15, 0 to 14: see the rotation
        registers m_two                                 # first words of two quadwords
        registers m_four                                # first two words of two quadwords
        # the sphere
        registers a_sphere,quad,more,cx,cy,cz,limit
        # the middles of a row
        registers dx,dy,dz
        # temporaries
        registers s                                     # to 31
        .set    NEXT,32
        registers signs_low
        registers signs                                 # to 36, a group each

        .section .rodata
        .align  4
signs_of_two:
        .int    0x0004080c,0x1014181c,0x0004080c,0x1014181c
halves: .int    0x17000102,0x03040506,0x07101112,0x13141516
two:    .int    0x00010203,0x10111213,0x00010203,0x10111213
four:   .int    0x00010203,0x04050607,0x10111213,0x14151617

function cull_spheres_p64
        load_constant $m_x,0x00010203
        load_constant $m_y,0x04050607
        load_constant $m_z,0x08090a0b
        load_constant $m_limit,(SPHERE_packet_limit-16)*0x01010101+0x00010203
        lqa     $m_signs,signs_of_two
        lqa     $m_halves,halves
        lqa     $m_two,two
        lqa     $m_four,four
next_sphere:
        lqd     $a_sphere,0($a_list)
        lqd     $quad,0($a_sphere)
        lqd     $more,16($a_sphere)
        shufb   $cx,$quad,$quad,$m_x
        shufb   $cy,$quad,$quad,$m_y
        shufb   $cz,$quad,$quad,$m_z
        shufb   $limit,$more,$more,$m_limit
    .irp group, 0,1,2,3
    .irp row, 0,1,2,3
        lqd     $dx,PACKET_SIZE*\group+PACKET_direction_x+16*\row($a_middles)
        lqd     $dy,PACKET_SIZE*\group+PACKET_direction_y+16*\row($a_middles)
        lqd     $dz,PACKET_SIZE*\group+PACKET_direction_z+16*\row($a_middles)
        fnms    $s+\row,$cx,$dx,$limit
        fnms    $s+\row,$cy,$dy,$s+\row
        fnms    $s+\row,$cz,$dz,$s+\row
    .endr
        shufb   $signs+\group,$s,$s+1,$m_signs
        shufb   $signs_low,$s+2,$s+3,$m_signs
        shufb   $signs+\group,$signs+\group,$signs_low,$m_halves
        rotqbii $signs+\group,$signs+\group,1           # the sign of byte k to the end of byte k-1
        gbb     $signs+\group,$signs+\group
    .endr
        shufb   $signs,$signs,$signs+1,$m_two
        shufb   $signs+2,$signs+2,$signs+3,$m_two
        shufb   $signs,$signs,$signs+2,$m_four
        stqd    $signs,0($a_masks)
        ai      $a_list,$a_list,PAIR_SIZE
        ai      $a_masks,$a_masks,16
        ai      $count,$count,-1
        brnz    $count,next_sphere
        bi      $lr
endfunction cull_spheres_p64
