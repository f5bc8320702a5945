# accumulate_r16   adds what rays have brought to the sums of their pixels
#   C       void accumulate_r16(const struct rays16 *, const struct surfaces *, int count);
#   In      $3 rays, $4 surfaces, $5 packets (at least 1); both one behind the other, 16-aligned
#   Out     the rays' pixels: sums of red, green, blue; the fourth word anything
#   Uses    $2-$48, $79   Saves  -   Stack  0   Calls  -
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
# Scheduled by spu schedule from accumulate_r16.s

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

        .section .rodata
        .align  4
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
        .set count_2,79; .set weight_2,2; .set blue_2,6; .set red_2,7; .set green_2,8
        .set pixel_2,9; .set pixel2_2,20; .set pixel3_2,2; .set c_same_2,24; .set pixel0_2,25
        .set low_2,26; .set sum0_2,36; .set high_2,21; .set c_same_3,6; .set c_same_4,29
        .set c_same_5,32; .set share1_2,26; .set c_same_6,33; .set share2_2,22; .set sum1_2,21
        .set weight_3,35; .set blue_3,34; .set pixel2_3,39; .set pixel1_2,9; .set red_3,32
        .set share0_2,6; .set more1_2,26; .set share1_3,42; .set high_3,7; .set green_3,46
        .set c_same_7,22; .set pixel_3,23; .set share3_2,24; .set pixel_4,7; .set c_same_8,8
        .set sum0_3,31; .set pixel0_3,21; .set more3_2,26; .set pixel3_3,22; .set blue_4,8
        .set pixel2_4,24; .set pixel1_3,23; .set c_same_9,34; .set pixel3_4,29; .set c_same_10,40
        .set c_same_11,27; .set weight_4,34; .set c_same_12,28; .set pixel0_4,45; .set c_same_13,20
        .set sum0_4,26; .set green_4,27; .set sum3_2,30; .set c_same_14,31; .set blue_5,35
        .set c_same_15,38; .set red_4,46; .set more1_3,20; .set green_5,42; .set low_3,47
        .set pixel2_5,31; .set share0_3,33; .set share1_4,8; .set sum0_5,6; .set share3_3,26
        .set share2_3,7; .set sum3_3,27; .set blue_6,30; .set more3_3,20; .set c_same_16,9
        .set red_5,25; .set c_same_17,2; .set blue_7,9; .set share0_4,7; .set more3_4,6
        .set red_6,2; .set pixel3_5,7; .set c_same_18,21; .set c_same_19,26; .set share1_5,24
        .set low_4,33; .set weight_5,25; .set pixel2_6,35; .set pixel1_4,34; .set pixel0_5,9
        .set blue_8,20; .set sum1_3,24; .set high_4,2; .set blue_9,2; .set pixel0_6,8
        .set sum0_6,20; .set pixel_5,31; .set green_6,39; .set weight_6,27; .set green_7,25
        .set blue_10,26; .set c_same_20,30; .set low_5,36; .set green_8,38; .set red_7,39
        .set more1_4,32; .set share0_5,42; .set share1_6,33; .set sum0_7,21; .set share3_4,20
        .set share2_4,2; .set blue_11,25; .set sum3_4,26; .set red_8,6; .set c_same_21,7
        .set low_6,21; .set c_same_22,3; .set green_9,2; .set pixel3_6,24; .set low_7,25
        .set weight_7,26; .set share1_7,25; .set c_same_23,35; .set share2_5,21; .set blue_12,22
        .set sum1_4,34; .set red_9,20; .set low_8,32; .set more1_5,6; .set weight_8,33
        .set share3_5,45; .set blue_13,21; .set red_10,35; .set pixel0_7,36; .set sum1_5,6
        .set pixel3_7,34; .set more3_5,7; .set pixel2_7,45; .set c_same_24,41; .set pixel_6,27
        .set sum1_6,7; .set pixel0_8,30; .set low_9,31; .set pixel3_8,47; .set pixel2_8,48
        .set share0_6,32; .set share1_8,29; .set high_5,20; .set pixel1_5,22; .set share3_6,2
        .set share2_6,20; .set c_same_25,25; .set more3_6,2; .set blue_14,7; .set red_11,8
        .set green_10,9; .set sum1_7,2; .set share1_9,20; .set share3_7,6
        ilhu    $m_lane0,0x8001                         # 0e
        lqa     $m_first,first                          # 0o
        ilhu    $m_lane1,0x8005                         # 1e
        lqa     $m_second,second                        # 1o
        ilhu    $m_lane2,0x8009                         # 2e
        lqa     $m_third,third                          # 2o
        ilhu    $m_lane3,0x800d                         # 3e
        lqa     $m_fourth,fourth                        # 3o
        clgti   $count_2,$count,1                       # 4e at least as many passes as overlap
        fsmbi   $m_behind,255                           # 4o
        iohl    $m_lane0,515                            # 5e
        iohl    $m_lane1,0x607                          # 6e
        iohl    $m_lane2,0xa0b                          # 7e
        iohl    $m_lane3,0xe0f                          # 8e
        il      $a_nothing,0                            # 9e
        il      $rays_step,640                          # 10e
        il      $surfaces_step,0x650                    # 11e
        brz     $count_2,next_packet_short              # 11o too few passes
        ai      $count,$count,-1                        # 12e
        lqd     $weight,512($a_rays)                    # 12o
        lqd     $blue,0x5c0($a_surfaces)                # 13o
        lqd     $red,0x540($a_surfaces)                 # 14o
        lqd     $green,0x580($a_surfaces)               # 15o
        lqd     $pixel,576($a_rays)                     # 16o
        lqd     $weight_2,528($a_rays)                  # 17o
        lqd     $blue_2,0x5d0($a_surfaces)              # 18o
        fm      $blue,$blue,$weight                     # 19e
        lqd     $red_2,0x550($a_surfaces)               # 19o
        fm      $red,$red,$weight                       # 20e
        lqd     $green_2,0x590($a_surfaces)             # 20o
        fm      $green,$green,$weight                   # 21e
        lqd     $pixel_2,592($a_rays)                   # 21o
        shufb   $pixel0,$pixel,$pixel,$m_lane0          # 22o
        shufb   $pixel3,$pixel,$pixel,$m_lane3          # 23o
        fm      $blue_2,$blue_2,$weight_2               # 24e
        shufb   $pixel2_2,$pixel,$pixel,$m_lane2        # 24o
        fm      $red_2,$red_2,$weight_2                 # 25e
        rotqbyi $blue,$blue,8                           # 25o
        fm      $green_2,$green_2,$weight_2             # 26e
        shufb   $pixel1,$pixel,$pixel,$m_lane1          # 26o
        ceq     $c_same,$pixel3,$pixel0                 # 27e
        shufb   $pixel3_2,$pixel_2,$pixel_2,$m_lane3    # 27o
        ceq     $c_same_2,$pixel2_2,$pixel0             # 28e
        shufb   $pixel0_2,$pixel_2,$pixel_2,$m_lane0    # 28o
        selb    $low_2,$red,$blue,$m_behind             # 29e
        lqx     $sum0_2,$a_nothing,$pixel0              # 29o
        selb    $high_2,$blue,$red,$m_behind            # 30e
        rotqbyi $blue,$blue_2,8                         # 30o
        ceq     $c_same_3,$pixel3,$pixel1               # 31e
        shufb   $share0,$low_2,$green,$m_first          # 31o
        ceq     $c_same_4,$pixel1,$pixel0               # 32e
        shufb   $share3,$high_2,$green,$m_fourth        # 32o
        ceq     $c_same_5,$pixel2_2,$pixel1             # 33e
        shufb   $share1_2,$low_2,$green,$m_second       # 33o
        ceq     $c_same_6,$pixel3,$pixel2_2             # 34e
        shufb   $share2_2,$high_2,$green,$m_third       # 34o
        and     $c_same,$c_same,$share0                 # 35e
        lqx     $sum1_2,$a_nothing,$pixel1              # 35o
        and     $c_same_2,$c_same_2,$share0             # 36e
        lqd     $weight_3,544($a_rays)                  # 36o
        fa      $more3,$share3,$c_same                  # 37e
        lqd     $blue_3,0x5e0($a_surfaces)              # 37o
        and     $c_same_3,$c_same_3,$share1_2           # 38e
        lqx     $sum2,$a_nothing,$pixel2_2              # 38o
        fa      $more2,$share2_2,$c_same_2              # 39e
        lqx     $sum3,$a_nothing,$pixel3                # 39o
        and     $c_same,$c_same_4,$share0               # 40e
        shufb   $pixel2_3,$pixel_2,$pixel_2,$m_lane2    # 40o
        selb    $low,$red_2,$blue,$m_behind             # 41e
        shufb   $pixel1_2,$pixel_2,$pixel_2,$m_lane1    # 41o
        and     $c_same_4,$c_same_5,$share1_2           # 42e
        lqd     $red_3,0x560($a_surfaces)               # 42o
        fa      $more3,$more3,$c_same_3                 # 43e
        shufb   $share0_2,$low,$green_2,$m_first        # 43o
        fa      $more1_2,$share1_2,$c_same              # 44e
        shufb   $share1_3,$low,$green_2,$m_second       # 44o
        selb    $high_3,$blue,$red_2,$m_behind          # 45e
        lqd     $green_3,0x5a0($a_surfaces)             # 45o
        and     $c_same_7,$c_same_6,$share2_2           # 46e
        lqd     $pixel_3,608($a_rays)                   # 46o
        fa      $more2,$more2,$c_same_4                 # 47e
        shufb   $share3_2,$high_3,$green_2,$m_fourth    # 47o
        ceq     $c_same_4,$pixel3_2,$pixel0_2           # 48e
        shufb   $share2,$high_3,$green_2,$m_third       # 48o
        fa      $more3,$more3,$c_same_7                 # 49e
        lqd     $pixel_4,624($a_rays)                   # 49o
        and     $c_same_8,$c_same_4,$share0_2           # 50e
        fa      $sum0_3,$sum0_2,$share0                 # 51e
        fa      $sum1,$sum1_2,$more1_2                  # 52e
        shufb   $pixel0_3,$pixel_3,$pixel_3,$m_lane0    # 52o
        fa      $more3_2,$share3_2,$c_same_8            # 53e
        shufb   $pixel3_3,$pixel_3,$pixel_3,$m_lane3    # 53o
        fm      $blue_4,$blue_3,$weight_3               # 54e
        shufb   $pixel2_4,$pixel_3,$pixel_3,$m_lane2    # 54o
        fa      $sum2,$sum2,$more2                      # 55e
        shufb   $pixel1_3,$pixel_3,$pixel_3,$m_lane1    # 55o
        ceq     $c_same_9,$pixel2_3,$pixel0_2           # 56e
        shufb   $pixel3_4,$pixel_4,$pixel_4,$m_lane3    # 56o
        fa      $sum3,$sum3,$more3                      # 57e
        stqx    $sum0_3,$a_nothing,$pixel0              # 57o
        ceq     $c_same_10,$pixel3_2,$pixel1_2          # 58e
        stqx    $sum1,$a_nothing,$pixel1                # 58o
        and     $c_same_11,$c_same_9,$share0_2          # 59e
        lqd     $weight_4,560($a_rays)                  # 59o
        and     $c_same_12,$c_same_10,$share1_3         # 60e
        rotqbyi $blue_4,$blue_4,8                       # 60o
        fm      $red_3,$red_3,$weight_3                 # 61e
        stqx    $sum2,$a_nothing,$pixel2_2              # 61o
        fa      $more2,$share2,$c_same_11               # 62e
        shufb   $pixel0_4,$pixel_4,$pixel_4,$m_lane0    # 62o
        ceq     $c_same_13,$pixel1_2,$pixel0_2          # 63e
        stqx    $sum3,$a_nothing,$pixel3                # 63o
        fa      $more3,$more3_2,$c_same_12              # 64e
        lqx     $sum0_4,$a_nothing,$pixel0_2            # 64o
        fm      $green_4,$green_3,$weight_3             # 65e
        lqx     $sum1,$a_nothing,$pixel1_2              # 65o
        ceq     $c_same_12,$pixel2_3,$pixel1_2          # 66e
        lqx     $sum2,$a_nothing,$pixel2_3              # 66o
        and     $c_same_13,$c_same_13,$share0_2         # 67e
        lqx     $sum3_2,$a_nothing,$pixel3_2            # 67o
        ceq     $c_same_14,$pixel3_2,$pixel2_3          # 68e
        lqd     $blue_5,0x5f0($a_surfaces)              # 68o
        and     $c_same_15,$c_same_12,$share1_3         # 69e
        lqd     $red_4,0x570($a_surfaces)               # 69o
        fa      $more1_3,$share1_3,$c_same_13           # 70e
        lqd     $green_5,0x5b0($a_surfaces)             # 70o
        and     $c_same_6,$c_same_14,$share2            # 71e
        shufb   $pixel1,$pixel_4,$pixel_4,$m_lane1      # 71o
        selb    $low_3,$red_3,$blue_4,$m_behind         # 72e
        shufb   $pixel2_5,$pixel_4,$pixel_4,$m_lane2    # 72o
        fa      $more2,$more2,$c_same_15                # 73e
        lnop                                            # 73o pairing
        fa      $more3,$more3,$c_same_6                 # 74e
        shufb   $share0_3,$low_3,$green_4,$m_first      # 74o
        selb    $high_3,$blue_4,$red_3,$m_behind        # 75e
        shufb   $share1_4,$low_3,$green_4,$m_second     # 75o
        ceq     $c_same_5,$pixel3_3,$pixel0_3           # 76e
        lnop                                            # 76o pairing
        fa      $sum0_5,$sum0_4,$share0_2               # 77e
        shufb   $share3_3,$high_3,$green_4,$m_fourth    # 77o
        fa      $sum1,$sum1,$more1_3                    # 78e
        shufb   $share2_3,$high_3,$green_4,$m_third     # 78o
        and     $c_same_13,$c_same_5,$share0_3          # 79e
        fa      $sum2,$sum2,$more2                      # 80e
        fa      $sum3_3,$sum3_2,$more3                  # 81e
        fm      $blue_6,$blue_5,$weight_4               # 82e
        fa      $more3_3,$share3_3,$c_same_13           # 83e
        stqx    $sum0_5,$a_nothing,$pixel0_2            # 83o
        ceq     $c_same_3,$pixel2_4,$pixel0_3           # 84e
        stqx    $sum1,$a_nothing,$pixel1_2              # 84o
        ceq     $c_same_16,$pixel3_3,$pixel1_3          # 85e
        lnop                                            # 85o pairing
        fm      $red_5,$red_4,$weight_4                 # 86e
        stqx    $sum2,$a_nothing,$pixel2_3              # 86o
        and     $c_same_3,$c_same_3,$share0_3           # 87e
        stqx    $sum3_3,$a_nothing,$pixel3_2            # 87o
        and     $c_same_17,$c_same_16,$share1_4         # 88e
        rotqbyi $blue_7,$blue_6,8                       # 88o
        fm      $green_4,$green_5,$weight_4             # 89e
        lqx     $sum0,$a_nothing,$pixel0_3              # 89o
        fa      $more2,$share2_3,$c_same_3              # 90e
        lqx     $sum1,$a_nothing,$pixel1_3              # 90o
        fa      $more3,$more3_3,$c_same_17              # 91e
        lqx     $sum2,$a_nothing,$pixel2_4              # 91o
        ceq     $c_same_17,$pixel1_3,$pixel0_3          # 92e
        lqx     $sum3,$a_nothing,$pixel3_3              # 92o
        ceq     $c_same_3,$pixel2_4,$pixel1_3           # 93e
        ceq     $c_same_13,$pixel3_3,$pixel2_4          # 94e
        and     $c_same_17,$c_same_17,$share0_3         # 95e
        selb    $low_2,$red_5,$blue_7,$m_behind         # 96e
        and     $c_same_3,$c_same_3,$share1_4           # 97e
        lnop                                            # 97o pairing
        and     $c_same_13,$c_same_13,$share2_3         # 98e
        shufb   $share0_4,$low_2,$green_4,$m_first      # 98o
        fa      $more1,$share1_4,$c_same_17             # 99e
        shufb   $share1,$low_2,$green_4,$m_second       # 99o
        selb    $high,$blue_7,$red_5,$m_behind          # 100e
        fa      $more2,$more2,$c_same_3                 # 101e
        fa      $more3,$more3,$c_same_13                # 102e
        shufb   $share3,$high,$green_4,$m_fourth        # 102o
        fa      $sum0,$sum0,$share0_3                   # 103e
        shufb   $share2,$high,$green_4,$m_third         # 103o
        ceq     $c_same_17,$pixel3_4,$pixel0_4          # 104e
        fa      $sum1,$sum1,$more1                      # 105e
        and     $c_same,$c_same_17,$share0_4            # 106e
        fa      $sum2,$sum2,$more2                      # 107e
        fa      $more3_4,$share3,$c_same                # 108e
        lnop                                            # 108o pairing
        fa      $sum3,$sum3,$more3                      # 109e
        stqx    $sum0,$a_nothing,$pixel0_3              # 109o
        a       $a_rays,$a_rays,$rays_step              # 110e
        a       $a_surfaces,$a_surfaces,$surfaces_step  # 111e
        ceq     $c_same,$pixel2_5,$pixel0_4             # 112e
        ceq     $c_same_17,$pixel3_4,$pixel1            # 113e
next_packet:
            and     $c_same,$c_same,$share0_4           # 0e
            stqx    $sum1,$a_nothing,$pixel1_3          # 0o
            and     $c_same_17,$c_same_17,$share1       # 1e
        lqd     $weight,512($a_rays)                    # 1o
            fa      $more2,$share2,$c_same              # 2e
            stqx    $sum2,$a_nothing,$pixel2_4          # 2o
            ceq     $c_same,$pixel1,$pixel0_4           # 3e
        lqd     $blue,0x5c0($a_surfaces)                # 3o
            fa      $more3,$more3_4,$c_same_17          # 4e
            stqx    $sum3,$a_nothing,$pixel3_3          # 4o
            ceq     $c_same_17,$pixel2_5,$pixel1        # 5e
            lqx     $sum0,$a_nothing,$pixel0_4          # 5o
            and     $c_same,$c_same,$share0_4           # 6e
            lqx     $sum2,$a_nothing,$pixel2_5          # 6o
            ceq     $c_same_3,$pixel3_4,$pixel2_5       # 7e
            lqx     $sum3,$a_nothing,$pixel3_4          # 7o
            fa      $more1,$share1,$c_same              # 8e
            lqx     $sum1,$a_nothing,$pixel1            # 8o
            and     $c_same,$c_same_17,$share1          # 9e
        lqd     $red,0x540($a_surfaces)                 # 9o
            and     $c_same_17,$c_same_3,$share2        # 10e
        lqd     $green,0x580($a_surfaces)               # 10o
            fa      $more2,$more2,$c_same               # 11e
        lqd     $pixel,576($a_rays)                     # 11o
            fa      $more3,$more3,$c_same_17            # 12e
        lqd     $weight_2,528($a_rays)                  # 12o
            fa      $sum0,$sum0,$share0_4               # 13e
        lqd     $blue_2,0x5d0($a_surfaces)              # 13o
            fa      $sum1,$sum1,$more1                  # 14e
        lqd     $red_2,0x550($a_surfaces)               # 14o
        fm      $blue,$blue,$weight                     # 15e
        lqd     $green_2,0x590($a_surfaces)             # 15o
        fm      $red,$red,$weight                       # 16e
        lqd     $pixel_2,592($a_rays)                   # 16o
            fa      $sum2,$sum2,$more2                  # 17e
        shufb   $pixel0,$pixel,$pixel,$m_lane0          # 17o
            fa      $sum3,$sum3,$more3                  # 18e
        shufb   $pixel3,$pixel,$pixel,$m_lane3          # 18o
        fm      $blue_2,$blue_2,$weight_2               # 19e
            stqx    $sum0,$a_nothing,$pixel0_4          # 19o
        fm      $green,$green,$weight                   # 20e
            stqx    $sum1,$a_nothing,$pixel1            # 20o
        fm      $green_2,$green_2,$weight_2             # 21e
        rotqbyi $blue,$blue,8                           # 21o
        fm      $red_6,$red_2,$weight_2                 # 22e
        shufb   $pixel1,$pixel,$pixel,$m_lane1          # 22o
        ai      $count,$count,-1                        # 23e
            stqx    $sum2,$a_nothing,$pixel2_5          # 23o
        ceq     $c_same,$pixel3,$pixel0                 # 24e
            stqx    $sum3,$a_nothing,$pixel3_4          # 24o
        selb    $low,$red,$blue,$m_behind               # 25e
        shufb   $pixel2,$pixel,$pixel,$m_lane2          # 25o
        selb    $high,$blue,$red,$m_behind              # 26e
        shufb   $pixel3_5,$pixel_2,$pixel_2,$m_lane3    # 26o
        ceq     $c_same_13,$pixel3,$pixel1              # 27e
        rotqbyi $blue,$blue_2,8                         # 27o
        ceq     $c_same_3,$pixel1,$pixel0               # 28e
        lnop                                            # 28o pairing
        ceq     $c_same_18,$pixel2,$pixel0              # 29e
        shufb   $share0,$low,$green,$m_first            # 29o
        ceq     $c_same_19,$pixel2,$pixel1              # 30e
        shufb   $share3,$high,$green,$m_fourth          # 30o
        ceq     $c_same_5,$pixel3,$pixel2               # 31e
        shufb   $share1_5,$low,$green,$m_second         # 31o
        selb    $low_4,$red_6,$blue,$m_behind           # 32e
        shufb   $share2_2,$high,$green,$m_third         # 32o
        and     $c_same,$c_same,$share0                 # 33e
        lqd     $weight_5,544($a_rays)                  # 33o
        and     $c_same_18,$c_same_18,$share0           # 34e
        shufb   $pixel2_6,$pixel_2,$pixel_2,$m_lane2    # 34o
        fa      $more3,$share3,$c_same                  # 35e
        shufb   $pixel1_4,$pixel_2,$pixel_2,$m_lane1    # 35o
        fa      $more2,$share2_2,$c_same_18             # 36e
        shufb   $pixel0_5,$pixel_2,$pixel_2,$m_lane0    # 36o
        and     $c_same,$c_same_3,$share0               # 37e
        lqd     $red,0x560($a_surfaces)                 # 37o
        and     $c_same_3,$c_same_13,$share1_5          # 38e
        lqd     $blue_8,0x5e0($a_surfaces)              # 38o
        and     $c_same_19,$c_same_19,$share1_5         # 39e
        lqx     $sum0_2,$a_nothing,$pixel0              # 39o
        fa      $more1,$share1_5,$c_same                # 40e
        lqx     $sum1_3,$a_nothing,$pixel1              # 40o
        fa      $more3,$more3,$c_same_3                 # 41e
        shufb   $share0_2,$low_4,$green_2,$m_first      # 41o
        selb    $high_4,$blue,$red_6,$m_behind          # 42e
        lqd     $pixel_3,608($a_rays)                   # 42o
        fa      $more2,$more2,$c_same_19                # 43e
        lqx     $sum2,$a_nothing,$pixel2                # 43o
        ceq     $c_same,$pixel3_5,$pixel0_5             # 44e
        shufb   $share3_3,$high_4,$green_2,$m_fourth    # 44o
        and     $c_same_7,$c_same_5,$share2_2           # 45e
        shufb   $share1,$low_4,$green_2,$m_second       # 45o
        and     $c_same,$c_same,$share0_2               # 46e
        shufb   $share2,$high_4,$green_2,$m_third       # 46o
        fa      $more3,$more3,$c_same_7                 # 47e
        lqx     $sum3,$a_nothing,$pixel3                # 47o
        fm      $blue_9,$blue_8,$weight_5               # 48e
        shufb   $pixel0_6,$pixel_3,$pixel_3,$m_lane0    # 48o
        fa      $sum0_6,$sum0_2,$share0                 # 49e
        shufb   $pixel3_3,$pixel_3,$pixel_3,$m_lane3    # 49o
        fa      $sum1,$sum1_3,$more1                    # 50e
        shufb   $pixel2_4,$pixel_3,$pixel_3,$m_lane2    # 50o
        fa      $more3_2,$share3_3,$c_same              # 51e
        shufb   $pixel1_3,$pixel_3,$pixel_3,$m_lane1    # 51o
        fa      $sum2,$sum2,$more2                      # 52e
        lqd     $pixel_5,624($a_rays)                   # 52o
        ceq     $c_same,$pixel2_6,$pixel0_5             # 53e
        lqd     $green_6,0x5a0($a_surfaces)             # 53o
        fa      $sum3,$sum3,$more3                      # 54e
        rotqbyi $blue_9,$blue_9,8                       # 54o
        ceq     $c_same_10,$pixel3_5,$pixel1_4          # 55e
        stqx    $sum0_6,$a_nothing,$pixel0              # 55o
        fm      $red,$red,$weight_5                     # 56e
        lnop                                            # 56o pairing
        and     $c_same,$c_same,$share0_2               # 57e
        stqx    $sum1,$a_nothing,$pixel1                # 57o
        and     $c_same_13,$c_same_10,$share1           # 58e
        lqd     $weight_6,560($a_rays)                  # 58o
        fm      $green_7,$green_6,$weight_5             # 59e
        stqx    $sum2,$a_nothing,$pixel2                # 59o
        a       $a_rays,$a_rays,$rays_step              # 60e
        stqx    $sum3,$a_nothing,$pixel3                # 60o
        fa      $more2,$share2,$c_same                  # 61e
        shufb   $pixel1,$pixel_5,$pixel_5,$m_lane1      # 61o
        ceq     $c_same,$pixel1_4,$pixel0_5             # 62e
        lnop                                            # 62o pairing
        fa      $more3,$more3_2,$c_same_13              # 63e
        shufb   $pixel3_4,$pixel_5,$pixel_5,$m_lane3    # 63o
        ceq     $c_same_13,$pixel2_6,$pixel1_4          # 64e
        lqd     $blue_10,0x5f0($a_surfaces)             # 64o
        and     $c_same,$c_same,$share0_2               # 65e
        shufb   $pixel0_4,$pixel_5,$pixel_5,$m_lane0    # 65o
        ceq     $c_same_20,$pixel3_5,$pixel2_6          # 66e
        lqx     $sum2,$a_nothing,$pixel2_6              # 66o
        selb    $low_5,$red,$blue_9,$m_behind           # 67e
        lqd     $green_8,0x5b0($a_surfaces)             # 67o
        and     $c_same_13,$c_same_13,$share1           # 68e
        lqd     $red_7,0x570($a_surfaces)               # 68o
        fa      $more1_4,$share1,$c_same                # 69e
        shufb   $share0_5,$low_5,$green_7,$m_first      # 69o
        and     $c_same_20,$c_same_20,$share2           # 70e
        shufb   $share1_6,$low_5,$green_7,$m_second     # 70o
        a       $a_surfaces,$a_surfaces,$surfaces_step  # 71e
        shufb   $pixel2_5,$pixel_5,$pixel_5,$m_lane2    # 71o
        selb    $high_4,$blue_9,$red,$m_behind          # 72e
        lqx     $sum0_7,$a_nothing,$pixel0_5            # 72o
        fa      $more2,$more2,$c_same_13                # 73e
        lqx     $sum1,$a_nothing,$pixel1_4              # 73o
        fa      $more3,$more3,$c_same_20                # 74e
        shufb   $share3_4,$high_4,$green_7,$m_fourth    # 74o
        ceq     $c_same_20,$pixel3_3,$pixel0_6          # 75e
        shufb   $share2_4,$high_4,$green_7,$m_third     # 75o
        fm      $blue_11,$blue_10,$weight_6             # 76e
        lnop                                            # 76o pairing
        and     $c_same_19,$c_same_20,$share0_5         # 77e
        lqx     $sum3_2,$a_nothing,$pixel3_5            # 77o
        fa      $sum0_5,$sum0_7,$share0_2               # 78e
        fa      $sum1,$sum1,$more1_4                    # 79e
        fa      $more3_3,$share3_4,$c_same_19           # 80e
        fa      $sum2,$sum2,$more2                      # 81e
        ceq     $c_same_18,$pixel2_4,$pixel0_6          # 82e
        rotqbyi $blue_11,$blue_11,8                     # 82o
        fa      $sum3_4,$sum3_2,$more3                  # 83e
        lnop                                            # 83o pairing
        ceq     $c_same_20,$pixel3_3,$pixel1_3          # 84e
        stqx    $sum0_5,$a_nothing,$pixel0_5            # 84o
        fm      $red_8,$red_7,$weight_6                 # 85e
        stqx    $sum1,$a_nothing,$pixel1_4              # 85o
        and     $c_same_16,$c_same_18,$share0_5         # 86e
        lnop                                            # 86o pairing
        and     $c_same_18,$c_same_20,$share1_6         # 87e
        stqx    $sum2,$a_nothing,$pixel2_6              # 87o
        fm      $green_4,$green_8,$weight_6             # 88e
        lnop                                            # 88o pairing
        fa      $more2,$share2_4,$c_same_16             # 89e
        stqx    $sum3_4,$a_nothing,$pixel3_5            # 89o
        ceq     $c_same_21,$pixel1_3,$pixel0_6          # 90e
        fa      $more3,$more3_3,$c_same_18              # 91e
        ceq     $c_same_16,$pixel2_4,$pixel1_3          # 92e
        lnop                                            # 92o pairing
        and     $c_same_21,$c_same_21,$share0_5         # 93e
        hbrr    next_packet_back,next_packet            # 93o hint
        ceq     $c_same_13,$pixel3_3,$pixel2_4          # 94e
        selb    $low_6,$red_8,$blue_11,$m_behind        # 95e
        and     $c_same_16,$c_same_16,$share1_6         # 96e
        lqx     $sum0,$a_nothing,$pixel0_6              # 96o
        fa      $more1,$share1_6,$c_same_21             # 97e
        shufb   $share1,$low_6,$green_4,$m_second       # 97o
        and     $c_same_17,$c_same_13,$share2_4         # 98e
        shufb   $share0_4,$low_6,$green_4,$m_first      # 98o
        selb    $high,$blue_11,$red_8,$m_behind         # 99e
        lqx     $sum1,$a_nothing,$pixel1_3              # 99o
        fa      $more2,$more2,$c_same_16                # 100e
        lqx     $sum2,$a_nothing,$pixel2_4              # 100o
        fa      $more3,$more3,$c_same_17                # 101e
        shufb   $share3,$high,$green_4,$m_fourth        # 101o
        ceq     $c_same_17,$pixel3_4,$pixel0_4          # 102e
        shufb   $share2,$high,$green_4,$m_third         # 102o
        fa      $sum0,$sum0,$share0_5                   # 103e
        lqx     $sum3,$a_nothing,$pixel3_3              # 103o
        and     $c_same,$c_same_17,$share0_4            # 104e
        fa      $sum1,$sum1,$more1                      # 105e
        fa      $more3_4,$share3,$c_same                # 106e
        fa      $sum2,$sum2,$more2                      # 107e
        ceq     $c_same,$pixel2_5,$pixel0_4             # 108e
        lnop                                            # 108o pairing
        fa      $sum3,$sum3,$more3                      # 109e
        stqx    $sum0,$a_nothing,$pixel0_6              # 109o
        ceq     $c_same_17,$pixel3_4,$pixel1            # 110e
next_packet_back:
        brnz    $count,next_packet                      # 110o
next_packet_drain:
        and     $c_same,$c_same,$share0_4               # 0e
        stqx    $sum1,$a_nothing,$pixel1_3              # 0o
        and     $c_same_17,$c_same_17,$share1           # 1e
        stqx    $sum2,$a_nothing,$pixel2_4              # 1o
        fa      $more2,$share2,$c_same                  # 2e
        stqx    $sum3,$a_nothing,$pixel3_3              # 2o
        ceq     $c_same,$pixel1,$pixel0_4               # 3e
        lqx     $sum0,$a_nothing,$pixel0_4              # 3o
        fa      $more3,$more3_4,$c_same_17              # 4e
        hbr     accumulate_r16_return,$lr               # 4o hint
        ceq     $c_same_17,$pixel2_5,$pixel1            # 5e
        lqx     $sum1,$a_nothing,$pixel1                # 5o
        and     $c_same,$c_same,$share0_4               # 6e
        lqx     $sum2,$a_nothing,$pixel2_5              # 6o
        ceq     $c_same_3,$pixel3_4,$pixel2_5           # 7e
        lqx     $sum3,$a_nothing,$pixel3_4              # 7o
        and     $c_same_17,$c_same_17,$share1           # 8e
        fa      $more1,$share1,$c_same                  # 9e
        and     $c_same_22,$c_same_3,$share2            # 10e
        fa      $more2,$more2,$c_same_17                # 11e
        fa      $more3,$more3,$c_same_22                # 12e
        fa      $sum0,$sum0,$share0_4                   # 13e
        fa      $sum1,$sum1,$more1                      # 15e
        fa      $sum2,$sum2,$more2                      # 17e
        fa      $sum3,$sum3,$more3                      # 18e
        stqx    $sum0,$a_nothing,$pixel0_4              # 19o
        stqx    $sum1,$a_nothing,$pixel1                # 21o
        stqx    $sum2,$a_nothing,$pixel2_5              # 23o
        stqx    $sum3,$a_nothing,$pixel3_4              # 24o
accumulate_r16_return:
        bi      $lr                                     # 25o
next_packet_short:
        ai      $count,$count,-1                        # 0e
        lqd     $weight,512($a_rays)                    # 0o
        lqd     $blue,0x5c0($a_surfaces)                # 1o
        lqd     $red,0x540($a_surfaces)                 # 2o
        lqd     $green,0x580($a_surfaces)               # 3o
        lqd     $pixel,576($a_rays)                     # 4o
        lqd     $weight_2,528($a_rays)                  # 5o
        lqd     $blue_2,0x5d0($a_surfaces)              # 6o
        fm      $blue,$blue,$weight                     # 7e
        lqd     $red_2,0x550($a_surfaces)               # 7o
        fm      $red,$red,$weight                       # 8e
        lqd     $green_2,0x590($a_surfaces)             # 8o
        fm      $green,$green,$weight                   # 9e
        lqd     $pixel_2,592($a_rays)                   # 9o
        shufb   $pixel0,$pixel,$pixel,$m_lane0          # 10o
        shufb   $pixel3,$pixel,$pixel,$m_lane3          # 11o
        fm      $blue_2,$blue_2,$weight_2               # 12e
        shufb   $pixel2,$pixel,$pixel,$m_lane2          # 12o
        fm      $red_2,$red_2,$weight_2                 # 13e
        rotqbyi $blue,$blue,8                           # 13o
        fm      $green_9,$green_2,$weight_2             # 14e
        shufb   $pixel1,$pixel,$pixel,$m_lane1          # 14o
        ceq     $c_same,$pixel3,$pixel0                 # 15e
        shufb   $pixel0_6,$pixel_2,$pixel_2,$m_lane0    # 15o
        ceq     $c_same_13,$pixel2,$pixel0              # 16e
        shufb   $pixel3_6,$pixel_2,$pixel_2,$m_lane3    # 16o
        selb    $low_7,$red,$blue,$m_behind             # 17e
        lqd     $weight_7,544($a_rays)                  # 17o
        selb    $high_2,$blue,$red,$m_behind            # 18e
        rotqbyi $blue,$blue_2,8                         # 18o
        ceq     $c_same_3,$pixel3,$pixel1               # 19e
        shufb   $share0,$low_7,$green,$m_first          # 19o
        ceq     $c_same_5,$pixel1,$pixel0               # 20e
        shufb   $share3,$high_2,$green,$m_fourth        # 20o
        ceq     $c_same_6,$pixel2,$pixel1               # 21e
        shufb   $share1_7,$low_7,$green,$m_second       # 21o
        ceq     $c_same_23,$pixel3,$pixel2              # 22e
        shufb   $share2_5,$high_2,$green,$m_third       # 22o
        and     $c_same,$c_same,$share0                 # 23e
        lqd     $blue_12,0x5e0($a_surfaces)             # 23o
        and     $c_same_13,$c_same_13,$share0           # 24e
        lqx     $sum0_2,$a_nothing,$pixel0              # 24o
        fa      $more3,$share3,$c_same                  # 25e
        lqx     $sum1_4,$a_nothing,$pixel1              # 25o
        and     $c_same,$c_same_3,$share1_7             # 26e
        lqx     $sum2,$a_nothing,$pixel2                # 26o
        fa      $more2,$share2_5,$c_same_13             # 27e
        lqx     $sum3,$a_nothing,$pixel3                # 27o
        and     $c_same_3,$c_same_5,$share0             # 28e
        lqd     $red_9,0x560($a_surfaces)               # 28o
        selb    $low_8,$red_2,$blue,$m_behind           # 29e
        shufb   $pixel2_3,$pixel_2,$pixel_2,$m_lane2    # 29o
        and     $c_same_6,$c_same_6,$share1_7           # 30e
        shufb   $pixel1_2,$pixel_2,$pixel_2,$m_lane1    # 30o
        fa      $more3,$more3,$c_same                   # 31e
        shufb   $share0_5,$low_8,$green_9,$m_first      # 31o
        fa      $more1_5,$share1_7,$c_same_3            # 32e
        lqd     $green_7,0x5a0($a_surfaces)             # 32o
        and     $c_same_18,$c_same_23,$share2_5         # 33e
        shufb   $share1,$low_8,$green_9,$m_second       # 33o
        selb    $high_3,$blue,$red_2,$m_behind          # 34e
        lqd     $pixel_3,608($a_rays)                   # 34o
        fa      $more2,$more2,$c_same_6                 # 35e
        lqd     $weight_8,560($a_rays)                  # 35o
        ceq     $c_same_23,$pixel3_6,$pixel0_6          # 36e
        shufb   $share3_5,$high_3,$green_9,$m_fourth    # 36o
        fa      $more3,$more3,$c_same_18                # 37e
        shufb   $share2_4,$high_3,$green_9,$m_third     # 37o
        and     $c_same_21,$c_same_23,$share0_5         # 38e
        lqd     $blue_13,0x5f0($a_surfaces)             # 38o
        fm      $blue_12,$blue_12,$weight_7             # 39e
        lqd     $red_10,0x570($a_surfaces)              # 39o
        fa      $sum0_3,$sum0_2,$share0                 # 40e
        shufb   $pixel0_7,$pixel_3,$pixel_3,$m_lane0    # 40o
        fa      $sum1_5,$sum1_4,$more1_5                # 41e
        shufb   $pixel3_7,$pixel_3,$pixel_3,$m_lane3    # 41o
        fa      $more3_5,$share3_5,$c_same_21           # 42e
        shufb   $pixel2_7,$pixel_3,$pixel_3,$m_lane2    # 42o
        fa      $sum2,$sum2,$more2                      # 43e
        shufb   $pixel1_3,$pixel_3,$pixel_3,$m_lane1    # 43o
        ceq     $c_same_10,$pixel2_3,$pixel0_6          # 44e
        lqd     $green_3,0x5b0($a_surfaces)             # 44o
        fa      $sum3,$sum3,$more3                      # 45e
        rotqbyi $blue_12,$blue_12,8                     # 45o
        ceq     $c_same_24,$pixel3_6,$pixel1_2          # 46e
        stqx    $sum0_3,$a_nothing,$pixel0              # 46o
        fm      $red_9,$red_9,$weight_7                 # 47e
        stqx    $sum1_5,$a_nothing,$pixel1              # 47o
        and     $c_same_3,$c_same_10,$share0_5          # 48e
        lqd     $pixel_6,624($a_rays)                   # 48o
        and     $c_same_12,$c_same_24,$share1           # 49e
        stqx    $sum2,$a_nothing,$pixel2                # 49o
        fm      $green_7,$green_7,$weight_7             # 50e
        lnop                                            # 50o pairing
        fa      $more2,$share2_4,$c_same_3              # 51e
        stqx    $sum3,$a_nothing,$pixel3                # 51o
        ceq     $c_same_3,$pixel1_2,$pixel0_6           # 52e
        lqx     $sum0_4,$a_nothing,$pixel0_6            # 52o
        fa      $more3,$more3_5,$c_same_12              # 53e
        lqx     $sum1_6,$a_nothing,$pixel1_2            # 53o
        ceq     $c_same_12,$pixel2_3,$pixel1_2          # 54e
        lqx     $sum2,$a_nothing,$pixel2_3              # 54o
        and     $c_same_3,$c_same_3,$share0_5           # 55e
        lqx     $sum3,$a_nothing,$pixel3_6              # 55o
        ceq     $c_same_4,$pixel3_6,$pixel2_3           # 56e
        shufb   $pixel0_8,$pixel_6,$pixel_6,$m_lane0    # 56o
        selb    $low_9,$red_9,$blue_12,$m_behind        # 57e
        shufb   $pixel3_8,$pixel_6,$pixel_6,$m_lane3    # 57o
        and     $c_same_12,$c_same_12,$share1           # 58e
        shufb   $pixel2_8,$pixel_6,$pixel_6,$m_lane2    # 58o
        fa      $more1_5,$share1,$c_same_3              # 59e
        shufb   $share0_6,$low_9,$green_7,$m_first      # 59o
        and     $c_same_17,$c_same_4,$share2_4          # 60e
        shufb   $share1_8,$low_9,$green_7,$m_second     # 60o
        selb    $high_5,$blue_12,$red_9,$m_behind       # 61e
        shufb   $pixel1_5,$pixel_6,$pixel_6,$m_lane1    # 61o
        fa      $more2,$more2,$c_same_12                # 62e
        lnop                                            # 62o pairing
        fa      $more3,$more3,$c_same_17                # 63e
        shufb   $share3_6,$high_5,$green_7,$m_fourth    # 63o
        ceq     $c_same_11,$pixel3_7,$pixel0_7          # 64e
        shufb   $share2_6,$high_5,$green_7,$m_third     # 64o
        fm      $blue_13,$blue_13,$weight_8             # 65e
        and     $c_same_25,$c_same_11,$share0_6         # 66e
        fa      $sum0_4,$sum0_4,$share0_5               # 67e
        fa      $sum1_5,$sum1_6,$more1_5                # 68e
        fa      $more3_6,$share3_6,$c_same_25           # 69e
        fa      $sum2,$sum2,$more2                      # 70e
        ceq     $c_same,$pixel2_7,$pixel0_7             # 71e
        rotqbyi $blue_14,$blue_13,8                     # 71o
        fa      $sum3,$sum3,$more3                      # 72e
        lnop                                            # 72o pairing
        ceq     $c_same_18,$pixel3_7,$pixel1_3          # 73e
        stqx    $sum0_4,$a_nothing,$pixel0_6            # 73o
        fm      $red_11,$red_10,$weight_8               # 74e
        stqx    $sum1_5,$a_nothing,$pixel1_2            # 74o
        and     $c_same,$c_same,$share0_6               # 75e
        lnop                                            # 75o pairing
        and     $c_same_3,$c_same_18,$share1_8          # 76e
        stqx    $sum2,$a_nothing,$pixel2_3              # 76o
        fm      $green_10,$green_3,$weight_8            # 77e
        lnop                                            # 77o pairing
        fa      $more2,$share2_6,$c_same                # 78e
        stqx    $sum3,$a_nothing,$pixel3_6              # 78o
        ceq     $c_same,$pixel1_3,$pixel0_7             # 79e
        lqx     $sum0,$a_nothing,$pixel0_7              # 79o
        fa      $more3,$more3_6,$c_same_3               # 80e
        lqx     $sum1_7,$a_nothing,$pixel1_3            # 80o
        ceq     $c_same_3,$pixel2_7,$pixel1_3           # 81e
        lqx     $sum2,$a_nothing,$pixel2_7              # 81o
        and     $c_same,$c_same,$share0_6               # 82e
        lqx     $sum3,$a_nothing,$pixel3_7              # 82o
        ceq     $c_same_18,$pixel3_7,$pixel2_7          # 83e
        selb    $low,$red_11,$blue_14,$m_behind         # 84e
        and     $c_same_3,$c_same_3,$share1_8           # 85e
        lnop                                            # 85o pairing
        fa      $more1,$share1_8,$c_same                # 86e
        shufb   $share0,$low,$green_10,$m_first         # 86o
        and     $c_same,$c_same_18,$share2_6            # 87e
        shufb   $share1_9,$low,$green_10,$m_second      # 87o
        selb    $high,$blue_14,$red_11,$m_behind        # 88e
        fa      $more2,$more2,$c_same_3                 # 89e
        fa      $more3,$more3,$c_same                   # 90e
        shufb   $share3_7,$high,$green_10,$m_fourth     # 90o
        ceq     $c_same,$pixel3_8,$pixel0_8             # 91e
        shufb   $share2,$high,$green_10,$m_third        # 91o
        fa      $sum0,$sum0,$share0_6                   # 92e
        hbrr    next_packet_short_back,next_packet_short # 92o hint
        and     $c_same,$c_same,$share0                 # 93e
        fa      $sum1_7,$sum1_7,$more1                  # 94e
        fa      $more3_4,$share3_7,$c_same              # 95e
        fa      $sum2,$sum2,$more2                      # 96e
        ceq     $c_same,$pixel2_8,$pixel0_8             # 97e
        lnop                                            # 97o pairing
        fa      $sum3,$sum3,$more3                      # 98e
        stqx    $sum0,$a_nothing,$pixel0_7              # 98o
        ceq     $c_same_21,$pixel3_8,$pixel1_5          # 99e
        lnop                                            # 99o pairing
        and     $c_same,$c_same,$share0                 # 100e
        stqx    $sum1_7,$a_nothing,$pixel1_3            # 100o
        and     $c_same_17,$c_same_21,$share1_9         # 101e
        lnop                                            # 101o pairing
        fa      $more2,$share2,$c_same                  # 102e
        stqx    $sum2,$a_nothing,$pixel2_7              # 102o
        ceq     $c_same,$pixel1_5,$pixel0_8             # 103e
        lnop                                            # 103o pairing
        fa      $more3,$more3_4,$c_same_17              # 104e
        stqx    $sum3,$a_nothing,$pixel3_7              # 104o
        ceq     $c_same_17,$pixel2_8,$pixel1_5          # 105e
        lqx     $sum0,$a_nothing,$pixel0_8              # 105o
        and     $c_same,$c_same,$share0                 # 106e
        lqx     $sum1,$a_nothing,$pixel1_5              # 106o
        ceq     $c_same_3,$pixel3_8,$pixel2_8           # 107e
        lqx     $sum2,$a_nothing,$pixel2_8              # 107o
        and     $c_same_17,$c_same_17,$share1_9         # 108e
        lqx     $sum3,$a_nothing,$pixel3_8              # 108o
        fa      $more1,$share1_9,$c_same                # 109e
        and     $c_same,$c_same_3,$share2               # 110e
        fa      $more2,$more2,$c_same_17                # 111e
        fa      $more3,$more3,$c_same                   # 112e
        fa      $sum0,$sum0,$share0                     # 113e
        a       $a_rays,$a_rays,$rays_step              # 114e
        fa      $sum1,$sum1,$more1                      # 115e
        a       $a_surfaces,$a_surfaces,$surfaces_step  # 116e
        fa      $sum2,$sum2,$more2                      # 117e
        fa      $sum3,$sum3,$more3                      # 118e
        stqx    $sum0,$a_nothing,$pixel0_8              # 119o
        stqx    $sum1,$a_nothing,$pixel1_5              # 121o
        stqx    $sum2,$a_nothing,$pixel2_8              # 123o
        stqx    $sum3,$a_nothing,$pixel3_8              # 124o
        nop     $127                                    # 125e pairing
next_packet_short_back:
        brnz    $count,next_packet_short                # 125o
        nop     $127                                    # 126e pairing
        bi      $lr                                     # 126o
endfunction accumulate_r16
