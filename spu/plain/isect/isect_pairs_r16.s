# isect_pairs_r16   nearest entry of the eye rays of packets into spheres, pair by pair
#   C       void isect_pairs_r16(const struct pair *, int count);
#   In      $3 pairs, $4 count (0 is none); pointers 16-aligned
#   Out     the pairs' packets: t, object, where an entry is nearer than what was there
#   Uses    $3-$4, $10-$39   Saves  -   Stack  0   Calls  -
#   Domain  |d| = 1 within 4 ulp; radius > 0; centre and radius below 2^62
#   Error   12 ulp of t, eye 1.5 to 30 radii from the centre, ray within 0.995 r of it
#   Twin    oracle/src/twin/isect_pairs.rs
#
# For the centre c as the eye sees it and the unit direction d:
#   b = c.d             where the ray passes the centre
#   l = c - b d         from there to the centre
#   disc = r^2 - l.l    below 0: the ray passes by
#   t = b - sqrt(disc)  the entry; behind the eye: no hit (an opaque sphere has no inside)
# The perpendicular l keeps the digits that the b^2 - c of a distant sphere loses (Hearn and Baker).
#   y = 1/sqrt(disc) to 12 bits, s = disc y, sqrt(disc) = s (1 + (1 - s y)/2)
#
# There is no NaN that a compare could fail on. As unsigned numbers, singles below 0 are larger than
# all others: so one unsigned compare asks for an entry that is ahead and nearer. Of its mask and
# disc only the signs count: they are brought into four bits, and these choose a shuffle that
# merges old and new, all on the odd pipe.

        .include "work_unit.inc"
        .include "macros.inc"

        .set    a_pair,3
        .set    count,4
        # constants
        .set    k_half,10
        .set    k_one,11
        .set    m_x,12
        .set    m_y,13
        .set    m_z,14
        .set    m_radius2,15
        .set    a_merges,16
        # the pair
        .set    object,17
        .set    a_packet,18
        .set    quad,19
        .set    cx,20
        .set    cy,21
        .set    cz,22
        .set    radius2,23
        # a row
        .set    dx,24
        .set    dy,25
        .set    dz,26
        .set    t_best,27
        .set    nearest,28
        # temporaries
        .set    b,29
        .set    lx,30
        .set    ly,31
        .set    lz,32
        .set    disc,33
        .set    y,34
        .set    s,35
        .set    e,36
        .set    t,37
        .set    hit,38
        .set    merge,39

        .section .rodata
        .align  4
# By four bits, of rows' lanes 1, 2, 3 and 0: words of A where the lane's bit is 0, else of B.
merges:
    .set    bits,0
    .rept   16
        .int    0x00010203+0x10101010*(bits&1)
        .int    0x04050607+0x10101010*(bits>>3&1)
        .int    0x08090a0b+0x10101010*(bits>>2&1)
        .int    0x0c0d0e0f+0x10101010*(bits>>1&1)
    .set    bits,bits+1
    .endr

function isect_pairs_r16
        biz     $count,$lr
        load_constant $m_x,0x00010203
        load_constant $m_y,0x04050607
        load_constant $m_z,0x08090a0b
        load_constant $m_radius2,0x0c0d0e0f
        ilhu    $k_half,0x3f00
        ilhu    $k_one,0x3f80
        ila     $a_merges,merges
next_pair:
        lqd     $object,0($a_pair)
        rotqbyi $a_packet,$object,PAIR_packet
        lqd     $quad,0($object)
        shufb   $object,$object,$object,$m_x
        shufb   $cx,$quad,$quad,$m_x
        shufb   $cy,$quad,$quad,$m_y
        shufb   $cz,$quad,$quad,$m_z
        shufb   $radius2,$quad,$quad,$m_radius2
    .irp row, 0,1,2,3
        lqd     $dx,PACKET_direction_x+16*\row($a_packet)
        lqd     $dy,PACKET_direction_y+16*\row($a_packet)
        lqd     $dz,PACKET_direction_z+16*\row($a_packet)
        fm      $b,$cx,$dx
        fma     $b,$cy,$dy,$b
        fma     $b,$cz,$dz,$b
        fnms    $lx,$b,$dx,$cx
        fnms    $ly,$b,$dy,$cy
        fnms    $lz,$b,$dz,$cz
        fnms    $disc,$lx,$lx,$radius2
        fnms    $disc,$ly,$ly,$disc
        fnms    $disc,$lz,$lz,$disc
        frsqest $y,$disc
        fi      $y,$disc,$y
        fm      $s,$disc,$y
        fnms    $e,$s,$y,$k_one                         # 1 - s y
        fma     $e,$e,$k_half,$k_one
        fnms    $t,$s,$e,$b
        lqd     $t_best,PACKET_t+16*\row($a_packet)
        lqd     $nearest,PACKET_object+16*\row($a_packet)
        clgt    $hit,$t_best,$t
        andc    $hit,$hit,$disc                         # its signs alone count
    .if \row == 0
        # The odd pipe has less room than the even one for the last of the four.
        rotmai  $hit,$hit,-31
        selb    $t_best,$t_best,$t,$hit
        selb    $nearest,$nearest,$object,$hit
    .else
        rotqbii $hit,$hit,1
        gb      $hit,$hit
        shlqbii $hit,$hit,4
        lqx     $merge,$a_merges,$hit
        shufb   $t_best,$t_best,$t,$merge
        shufb   $nearest,$nearest,$object,$merge
    .endif
        stqd    $t_best,PACKET_t+16*\row($a_packet)
        stqd    $nearest,PACKET_object+16*\row($a_packet)
    .endr
        ai      $a_pair,$a_pair,PAIR_SIZE
        ai      $count,$count,-1
        brnz    $count,next_pair
        bi      $lr
endfunction isect_pairs_r16
