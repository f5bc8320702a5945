# accumulate_r16   adds what rays have brought to the sums of their pixels
#   C       void accumulate_r16(const struct rays16 *, const struct surfaces *, int count);
#   In      $3 rays, $4 surfaces, $5 packets (at least 1); both consecutive, 16-aligned
#   Out     the rays' pixels: sums of red, green, blue; the fourth word anything
#   Uses    $3-$5, $10-$50   Saves  -   Stack  0   Calls  -
#   Domain  each lane's pixel has the address of a quadword in its last three bytes, also of a ray
#           that is not there; any lanes may have the same one
#   Error   1.5 ulp of the sum, each addition, shares not below 0
#   Twin    lab/twins/src/accumulate.rs
#
#   pixel += weight lit
# Four rays' sums are loaded before the first is stored. If an earlier one of the four has the same
# pixel, a ray adds that one's share as well and is stored later. The last sum stored for a pixel
# is therefore complete.
#
# Sums are addressed through one base and an index, so that the scheduler keeps these accesses in
# order, but no others.

        .include "work_unit.inc"
        .include "macros.inc"

        .set    NEXT,3
        registers a_rays,a_surfaces,count
        # constants
        .set    NEXT,10
        registers a_nothing                             # 0, the base of all sums
        registers m_behind,m_first,m_second,m_third,m_fourth
        registers m_lane0                               # addresses of a row of pixels
        registers m_lane1,m_lane2,m_lane3
        .set    NEXT,43
        registers rays_step,surfaces_step
        # a row
        .set    weight,20
        .set    red,21
        .set    green,22
        .set    blue,23
        .set    low,24
        .set    high,25
        .set    pixel,26
        .set    pixel0,27
        .set    pixel1,28
        .set    pixel2,29
        .set    pixel3,30
        .set    share0,31
        .set    share1,32
        .set    share2,33
        .set    share3,34
        .set    sum0,35
        .set    sum1,36
        .set    sum2,37
        .set    sum3,38
        .set    more1,39
        .set    more2,40
        .set    more3,41
        .set    c_same,42

        quadword_constants
        # words of two quadwords P and Q
first:  .int    0x00010203,0x10111213,0x08090a0b,0x00010203 # P0 Q0 P2
second: .int    0x04050607,0x14151617,0x0c0d0e0f,0x04050607 # P1 Q1 P3
third:  .int    0x08090a0b,0x18191a1b,0x00010203,0x08090a0b # P2 Q2 P0
fourth: .int    0x0c0d0e0f,0x1c1d1e1f,0x04050607,0x0c0d0e0f # P3 Q3 P1

# out = more + the share of an earlier ray, if it has the same pixel.
.macro  with_earlier out:req, more:req, lane:req, earlier:req
        ceq     $c_same,$pixel\lane,$pixel\earlier
        and     $c_same,$c_same,$share\earlier
        fa      \out,\more,$c_same
.endm

function accumulate_r16
        lqa     $m_first,first
        lqa     $m_second,second
        lqa     $m_third,third
        lqa     $m_fourth,fourth
        fsmbi   $m_behind,0x00ff
        load_constant $m_lane0,0x80010203
        load_constant $m_lane1,0x80050607
        load_constant $m_lane2,0x80090a0b
        load_constant $m_lane3,0x800d0e0f
        il      $a_nothing,0
        il      $rays_step,RAYS16_SIZE
        il      $surfaces_step,SURFACES_SIZE
next_packet:
    .irp row, 0,1,2,3
        lqd     $weight,RAYS16_weight+16*\row($a_rays)
    .irp channel, red,green,blue
        lqd     $\channel,SURFACES_lit_\channel+16*\row($a_surfaces)
        fm      $\channel,$\channel,$weight
    .endr
        # Rows of red (A), green (B), blue (C), to A0 A1 C0 C1 and C2 C3 A2 A3, and on to the
        # lanes.
        rotqbyi $blue,$blue,8
        selb    $low,$red,$blue,$m_behind
        selb    $high,$blue,$red,$m_behind
        shufb   $share0,$low,$green,$m_first
        shufb   $share1,$low,$green,$m_second
        shufb   $share2,$high,$green,$m_third
        shufb   $share3,$high,$green,$m_fourth

        lqd     $pixel,RAYS16_pixel+16*\row($a_rays)
    .irp lane, 0,1,2,3
        splat   $pixel\lane,$pixel,$m_lane\lane
        lqx     $sum\lane,$a_nothing,$pixel\lane
    .endr
        fa      $sum0,$sum0,$share0
        with_earlier $more1,$share1,1,0
        with_earlier $more2,$share2,2,0
        with_earlier $more2,$more2,2,1
        with_earlier $more3,$share3,3,0
        with_earlier $more3,$more3,3,1
        with_earlier $more3,$more3,3,2
        stqx    $sum0,$a_nothing,$pixel0
    .irp lane, 1,2,3
        fa      $sum\lane,$sum\lane,$more\lane
        stqx    $sum\lane,$a_nothing,$pixel\lane
    .endr
    .endr
        a       $a_rays,$a_rays,$rays_step
        a       $a_surfaces,$a_surfaces,$surfaces_step
        ai      $count,$count,-1
        brnz    $count,next_packet
        bi      $lr
endfunction accumulate_r16
