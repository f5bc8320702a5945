# filter_spheres_r16   of an array of spheres, those that some of sixteen eye rays may enter
#   C       struct pair *filter_spheres_r16(const struct packet *, const struct sphere *, int fours,
#                                           struct pair *);
#   In      $3 packet, $4 spheres, $5 spheres in fours (at least 1), $6 where pairs go;
#           pointers 16-aligned
#   Out     a pair for each such sphere, in order; one more quadword may be written
#           $3 behind the last pair
#   Uses    $3-$6, $10-$61   Saves  -   Stack  0   Calls  -
#   Domain  |d| = 1 within 4 ulp; limits as the PPU makes them
#   Error   0: no sphere is left out that a ray enters
#   Twin    oracle/src/twin/cull.rs
#
# A unit direction d enters the sphere around c if c.d is above the cosine of the sphere's cone times
# |c|. The limit is a little less than that, so that rounding lets no sphere slip through: what
# passes here is tested exactly by isect_pairs_r16. Per ray
#   s = limit - c.d, negative if it may be entered
# and the signs of all sixteen are brought together on the odd pipe.

        .include "work_unit.inc"
        .include "macros.inc"

        .set    a_packet,3
        .set    a_sphere,4
        .set    fours,5
        .set    a_pairs,6
        # constants
        .set    m_x,10
        .set    m_y,11
        .set    m_z,12
        .set    m_limit,13
        .set    m_signs,14                              # top bytes of two quadwords' words
        .set    m_halves,15                             # the first half of one, the last of another
        .set    m_pair,16
        .set    k_next,17
        .set    k_all,18
        # the rays: rows 0 to 3 of the packet
        .set    dx,20
        .set    dy,24
        .set    dz,28
        # state: the pair of the sphere at hand, whose first word is the sphere's address; pairs so far
        .set    pair,32
        .set    found,33
        # the sphere
        .set    quad,34
        .set    more,35
        .set    cx,36
        .set    cy,37
        .set    cz,38
        .set    limit,39
        # temporaries
        .set    s,40                                    # to 43
        .set    signs,44
        .set    signs_low,45
        .set    c_any,46
        .set    offset,47

        .section .rodata
        .align  4
signs_of_two:
        .int    0x0004080c,0x1014181c,0x0004080c,0x1014181c
halves: .int    0x00010203,0x04050607,0x18191a1b,0x1c1d1e1f

function filter_spheres_r16
        load_constant $m_x,0x00010203
        load_constant $m_y,0x04050607
        load_constant $m_z,0x08090a0b
        load_constant $m_limit,(SPHERE_ray_limit-16)*0x01010101+0x00010203
        lqa     $m_signs,signs_of_two
        lqa     $m_halves,halves
        il      $k_all,-1
        il      $k_next,SPHERE_SIZE
        fsmbi   $m_pair,0xf000
        and     $k_next,$k_next,$m_pair                 # of the first word alone
        rotqmbyi $pair,$a_packet,-PAIR_packet
        selb    $pair,$pair,$a_sphere,$m_pair
        il      $found,0
    .irp row, 0,1,2,3
        lqd     $dx+\row,PACKET_direction_x+16*\row($a_packet)
        lqd     $dy+\row,PACKET_direction_y+16*\row($a_packet)
        lqd     $dz+\row,PACKET_direction_z+16*\row($a_packet)
    .endr
next_four:
    .irp sphere, 0,1,2,3
        lqd     $quad,0($pair)
        lqd     $more,16($pair)
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
        rotqbii $signs,$signs,1                         # signs to the bytes' last bits
        gbb     $signs,$signs
        shlqbii $offset,$found,4
        stqx    $pair,$a_pairs,$offset
        cg      $c_any,$signs,$k_all                    # 1 if any, else 0
        a       $found,$found,$c_any
        a       $pair,$pair,$k_next
    .endr
        ai      $fours,$fours,-1
        brnz    $fours,next_four
        shli    $found,$found,4
        a       $3,$a_pairs,$found
        bi      $lr
endfunction filter_spheres_r16
