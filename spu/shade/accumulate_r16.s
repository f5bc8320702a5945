# accumulate_r16   adds what rays have brought to the sums of their pixels
#   C       void accumulate_r16(const struct rays16 *, const struct surfaces *, int count);
#   In      $3 rays, $4 surfaces, $5 packets (at least 1); both one behind the other, 16-aligned
#   Out     the rays' pixels: sums of red, green, blue; the fourth word anything
#   Uses    $2-$49, $79   Saves  -   Stack  0   Calls  -
#   Domain  each lane's pixel is the address of a quadword, also of a ray that is not there; any lanes
#           may have the same one
#   Error   3 ulp of the largest sum, each addition
#   Twin    oracle/src/twin/accumulate.rs
#
#   pixel += weight lit
# Four rays' sums are loaded before the first is stored. A ray whose pixel an earlier one of the four
# has as well adds what that one adds too, and is stored behind it: the last one's sum is whole.
#
# Sums are addressed by one base and an index, so that the scheduler keeps these accesses in order, and
# no others behind them.
# Scheduled by spu schedule from accumulate_r16.s

        .include "work_unit.inc"
        .include "macros.inc"

        .set    a_rays,3
        .set    a_surfaces,4
        .set    count,5
        # constants
        .set    a_nothing,10                            # 0, the base of all sums
        .set    m_behind,11
        .set    m_first,12
        .set    m_second,13
        .set    m_third,14
        .set    m_fourth,15
        .set    m_lane0,16                              # words of a row of addresses
        .set    m_lane1,17
        .set    m_lane2,18
        .set    m_lane3,19
        .set    rays_step,43
        .set    surfaces_step,44
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

# more += the share of an earlier ray with the same pixel.
.macro  with_earlier lane:req, earlier:req
        ceq     $c_same,$pixel\lane,$pixel\earlier
        and     $c_same,$c_same,$share\earlier
        fa      $more\lane,$more\lane,$c_same
.endm

function accumulate_r16
        .set    count_2,79
        .set    weight_2,2
        .set    blue_2,6
        .set    red_2,7
        .set    green_2,8
        .set    pixel_2,9
        .set    green_3,2
        .set    pixel3_2,20
        .set    c_same_2,8
        .set    pixel0_2,24
        .set    low_2,25
        .set    high_2,21
        .set    c_same_3,6
        .set    c_same_4,26
        .set    c_same_5,32
        .set    c_same_6,21
        .set    share1_2,22
        .set    weight_3,25
        .set    pixel2_2,8
        .set    blue_3,34
        .set    pixel1_2,9
        .set    low_3,39
        .set    red_3,42
        .set    more1_2,45
        .set    green_4,48
        .set    share0_2,6
        .set    share1_3,39
        .set    high_3,7
        .set    pixel_3,23
        .set    c_same_7,22
        .set    pixel_4,32
        .set    more1_3,26
        .set    share3_2,45
        .set    share2_2,7
        .set    c_same_8,33
        .set    pixel0_3,21
        .set    more3_2,46
        .set    pixel3_3,22
        .set    pixel2_3,49
        .set    pixel1_3,23
        .set    pixel3_4,45
        .set    more3_3,26
        .set    pixel2_4,46
        .set    pixel0_4,47
        .set    c_same_9,31
        .set    pixel1_4,33
        .set    blue_4,27
        .set    more2_2,28
        .set    c_same_10,35
        .set    c_same_11,29
        .set    c_same_12,30
        .set    sum0_2,31
        .set    blue_5,26
        .set    red_4,27
        .set    more1_4,32
        .set    blue_6,35
        .set    red_5,34
        .set    green_5,25
        .set    green_6,40
        .set    more2_3,7
        .set    low_4,28
        .set    high_4,26
        .set    sum0_3,6
        .set    share0_3,32
        .set    share3_3,27
        .set    share2_3,26
        .set    share1_4,7
        .set    c_same_13,25
        .set    more3_4,27
        .set    more2_4,6
        .set    c_same_14,9
        .set    blue_7,8
        .set    more3_5,24
        .set    more2_5,20
        .set    red_6,25
        .set    c_same_15,7
        .set    share0_4,7
        .set    share2_4,9
        .set    share1_5,8
        .set    c_same_16,2
        .set    more3_6,6
        .set    more3_7,2
        .set    weight_4,24
        .set    pixel1_5,34
        .set    pixel0_5,6
        .set    red_7,9
        .set    share3_4,22
        .set    share0_5,21
        .set    c_same_17,23
        .set    pixel_5,42
        .set    pixel_6,33
        .set    more3_8,22
        .set    green_7,23
        .set    blue_8,25
        .set    weight_5,26
        .set    pixel0_6,31
        .set    c_same_18,39
        .set    pixel1_6,40
        .set    c_same_19,27
        .set    more2_6,24
        .set    c_same_20,28
        .set    red_8,29
        .set    pixel2_5,30
        .set    low_5,36
        .set    sum0_4,9
        .set    share3_5,37
        .set    share2_5,23
        .set    more3_9,25
        .set    more3_10,9
        .set    blue_9,21
        .set    c_same_21,24
        .set    red_9,6
        .set    more2_7,25
        .set    pixel0_7,8
        .set    c_same_22,20
        .set    pixel3_5,24
        .set    share2_6,21
        .set    sum0_5,34
        .set    red_10,20
        .set    pixel2_6,39
        .set    more1_5,42
        .set    green_8,45
        .set    pixel_7,6
        .set    low_6,46
        .set    weight_6,47
        .set    share0_6,33
        .set    share3_6,42
        .set    share1_6,2
        .set    pixel3_6,35
        .set    more3_11,42
        .set    red_11,46
        .set    pixel2_7,48
        .set    pixel1_7,6
        .set    green_9,34
        .set    c_same_23,40
        .set    more2_8,27
        .set    pixel0_8,28
        .set    pixel3_7,31
        .set    green_10,26
        .set    sum0_6,27
        .set    more1_6,29
        .set    pixel1_8,32
        .set    c_same_24,45
        .set    low_7,49
        .set    share0_7,20
        .set    more1_7,22
        .set    share3_7,29
        .set    sum0_7,26
        .set    red_12,8
        .set    sum0_8,24
        .set    low_8,26
        .set    high_5,8
        .set    share0_8,9
        .set    more3_12,7
        .set    sum0_9,8
        ilhu    $m_lane0,1                              # 0e
        lqa     $m_first,first                          # 0o

        ilhu    $m_lane1,0x405                          # 1e
        lqa     $m_second,second                        # 1o

        ilhu    $m_lane2,0x809                          # 2e
        lqa     $m_third,third                          # 2o

        ilhu    $m_lane3,0xc0d                          # 3e
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
        shufb   $pixel2,$pixel,$pixel,$m_lane2          # 24o

        fm      $red_2,$red_2,$weight_2                 # 25e
        rotqbyi $blue,$blue,8                           # 25o

        fm      $green_3,$green_2,$weight_2             # 26e
        shufb   $pixel1,$pixel,$pixel,$m_lane1          # 26o

        ceq     $c_same,$pixel3,$pixel0                 # 27e
        shufb   $pixel3_2,$pixel_2,$pixel_2,$m_lane3    # 27o

        ceq     $c_same_2,$pixel2,$pixel0               # 28e
        shufb   $pixel0_2,$pixel_2,$pixel_2,$m_lane0    # 28o

        selb    $low_2,$red,$blue,$m_behind             # 29e
        lqx     $sum0,$a_nothing,$pixel0                # 29o

        selb    $high_2,$blue,$red,$m_behind            # 30e
        rotqbyi $blue,$blue_2,8                         # 30o

        ceq     $c_same_3,$pixel3,$pixel1               # 31e
        shufb   $share0,$low_2,$green,$m_first          # 31o

        ceq     $c_same_4,$pixel1,$pixel0               # 32e
        shufb   $share3,$high_2,$green,$m_fourth        # 32o

        ceq     $c_same_5,$pixel2,$pixel1               # 33e
        shufb   $share2,$high_2,$green,$m_third         # 33o

        ceq     $c_same_6,$pixel3,$pixel2               # 34e
        shufb   $share1_2,$low_2,$green,$m_second       # 34o

        and     $c_same,$c_same,$share0                 # 35e
        lqx     $sum1,$a_nothing,$pixel1                # 35o

        ori     $more3,$share3,0                        # 36e
        lqx     $sum2,$a_nothing,$pixel2                # 36o

        ori     $more2,$share2,0                        # 37e
        lqx     $sum3,$a_nothing,$pixel3                # 37o

        fa      $more3,$more3,$c_same                   # 38e
        lqd     $weight_3,544($a_rays)                  # 38o

        and     $c_same,$c_same_2,$share0               # 39e
        shufb   $pixel2_2,$pixel_2,$pixel_2,$m_lane2    # 39o

        and     $c_same_3,$c_same_3,$share1_2           # 40e
        lqd     $blue_3,0x5e0($a_surfaces)              # 40o

        fa      $more2,$more2,$c_same                   # 41e
        shufb   $pixel1_2,$pixel_2,$pixel_2,$m_lane1    # 41o

        selb    $low_3,$red_2,$blue,$m_behind           # 42e
        lqd     $red_3,0x560($a_surfaces)               # 42o

        ori     $more1_2,$share1_2,0                    # 43e
        lqd     $green_4,0x5a0($a_surfaces)             # 43o

        fa      $more3,$more3,$c_same_3                 # 44e
        shufb   $share0_2,$low_3,$green_3,$m_first      # 44o

        and     $c_same_4,$c_same_4,$share0             # 45e
        shufb   $share1_3,$low_3,$green_3,$m_second     # 45o

        selb    $high_3,$blue,$red_2,$m_behind          # 46e
        lqd     $pixel_3,608($a_rays)                   # 46o

        and     $c_same_7,$c_same_5,$share1_2           # 47e
        lqd     $pixel_4,624($a_rays)                   # 47o

        fa      $more1_3,$more1_2,$c_same_4             # 48e
        shufb   $share3_2,$high_3,$green_3,$m_fourth    # 48o

        and     $c_same_6,$c_same_6,$share2             # 49e
        shufb   $share2_2,$high_3,$green_3,$m_third     # 49o

        fa      $more2,$more2,$c_same_7                 # 50e
        lqd     $weight_2,560($a_rays)                  # 50o

        ceq     $c_same_8,$pixel3_2,$pixel0_2           # 51e
        lnop                                            # 51o pairing

        fa      $more3,$more3,$c_same_6                 # 52e
        shufb   $pixel0_3,$pixel_3,$pixel_3,$m_lane0    # 52o

        ori     $more3_2,$share3_2,0                    # 53e
        shufb   $pixel3_3,$pixel_3,$pixel_3,$m_lane3    # 53o

        and     $c_same_8,$c_same_8,$share0_2           # 54e
        shufb   $pixel2_3,$pixel_3,$pixel_3,$m_lane2    # 54o

        fa      $sum0,$sum0,$share0                     # 55e
        shufb   $pixel1_3,$pixel_3,$pixel_3,$m_lane1    # 55o

        fa      $sum1,$sum1,$more1_3                    # 56e
        shufb   $pixel3_4,$pixel_4,$pixel_4,$m_lane3    # 56o

        fa      $more3_3,$more3_2,$c_same_8             # 57e
        shufb   $pixel2_4,$pixel_4,$pixel_4,$m_lane2    # 57o

        fa      $sum2,$sum2,$more2                      # 58e
        shufb   $pixel0_4,$pixel_4,$pixel_4,$m_lane0    # 58o

        ceq     $c_same_9,$pixel2_2,$pixel0_2           # 59e
        shufb   $pixel1_4,$pixel_4,$pixel_4,$m_lane1    # 59o

        fa      $sum3,$sum3,$more3                      # 60e
        lnop                                            # 60o pairing

        ceq     $c_same_5,$pixel3_2,$pixel1_2           # 61e
        stqx    $sum0,$a_nothing,$pixel0                # 61o

        fm      $blue_4,$blue_3,$weight_3               # 62e
        stqx    $sum1,$a_nothing,$pixel1                # 62o

        ori     $more2_2,$share2_2,0                    # 63e
        lnop                                            # 63o pairing

        and     $c_same_10,$c_same_9,$share0_2          # 64e
        stqx    $sum2,$a_nothing,$pixel2                # 64o

        and     $c_same_11,$c_same_5,$share1_3          # 65e
        lnop                                            # 65o pairing

        fa      $more2_2,$more2_2,$c_same_10            # 66e
        stqx    $sum3,$a_nothing,$pixel3                # 66o

        ceq     $c_same_12,$pixel1_2,$pixel0_2          # 67e
        lqx     $sum0_2,$a_nothing,$pixel0_2            # 67o

        fa      $more3,$more3_3,$c_same_11              # 68e
        rotqbyi $blue_5,$blue_4,8                       # 68o

        fm      $red_4,$red_3,$weight_3                 # 69e
        lqx     $sum1,$a_nothing,$pixel1_2              # 69o

        ceq     $c_same_11,$pixel2_2,$pixel1_2          # 70e
        lqx     $sum2,$a_nothing,$pixel2_2              # 70o

        ori     $more1_4,$share1_3,0                    # 71e
        lqx     $sum3,$a_nothing,$pixel3_2              # 71o

        and     $c_same,$c_same_12,$share0_2            # 72e
        lqd     $blue_6,0x5f0($a_surfaces)              # 72o

        ceq     $c_same_12,$pixel3_2,$pixel2_2          # 73e
        lqd     $red_5,0x570($a_surfaces)               # 73o

        fm      $green_5,$green_4,$weight_3             # 74e
        lqd     $green_6,0x5b0($a_surfaces)             # 74o

        and     $c_same_11,$c_same_11,$share1_3         # 75e
        fa      $more1,$more1_4,$c_same                 # 76e

        and     $c_same,$c_same_12,$share2_2            # 77e
        fa      $more2_3,$more2_2,$c_same_11            # 78e

        fa      $more3,$more3,$c_same                   # 79e
        selb    $low_4,$red_4,$blue_5,$m_behind         # 80e

        selb    $high_4,$blue_5,$red_4,$m_behind        # 81e
        lnop                                            # 81o pairing

        fa      $sum0_3,$sum0_2,$share0_2               # 82e
        shufb   $share0_3,$low_4,$green_5,$m_first      # 82o

        fa      $sum1,$sum1,$more1                      # 83e
        shufb   $share3_3,$high_4,$green_5,$m_fourth    # 83o

        ceq     $c_same,$pixel3_3,$pixel0_3             # 84e
        shufb   $share2_3,$high_4,$green_5,$m_third     # 84o

        fa      $sum2,$sum2,$more2_3                    # 85e
        shufb   $share1_4,$low_4,$green_5,$m_second     # 85o

        ceq     $c_same_13,$pixel2_3,$pixel0_3          # 86e
        fa      $sum3,$sum3,$more3                      # 87e

        ori     $more3_4,$share3_3,0                    # 88e
        stqx    $sum0_3,$a_nothing,$pixel0_2            # 88o

        and     $c_same,$c_same,$share0_3               # 89e
        stqx    $sum1,$a_nothing,$pixel1_2              # 89o

        ori     $more2_4,$share2_3,0                    # 90e
        lnop                                            # 90o pairing

        and     $c_same_14,$c_same_13,$share0_3         # 91e
        stqx    $sum2,$a_nothing,$pixel2_2              # 91o

        fm      $blue_7,$blue_6,$weight_2               # 92e
        lnop                                            # 92o pairing

        fa      $more3_5,$more3_4,$c_same               # 93e
        stqx    $sum3,$a_nothing,$pixel3_2              # 93o

        fa      $more2_5,$more2_4,$c_same_14            # 94e
        lqx     $sum0,$a_nothing,$pixel0_3              # 94o

        ceq     $c_same,$pixel1_3,$pixel0_3             # 95e
        lqx     $sum1,$a_nothing,$pixel1_3              # 95o

        ceq     $c_same_3,$pixel3_3,$pixel1_3           # 96e
        lqx     $sum2,$a_nothing,$pixel2_3              # 96o

        ceq     $c_same_14,$pixel2_3,$pixel1_3          # 97e
        lqx     $sum3,$a_nothing,$pixel3_3              # 97o

        ori     $more1,$share1_4,0                      # 98e
        rotqbyi $blue_7,$blue_7,8                       # 98o

        and     $c_same,$c_same,$share0_3               # 99e
        fm      $red_6,$red_5,$weight_2                 # 100e

        and     $c_same_3,$c_same_3,$share1_4           # 101e
        and     $c_same_15,$c_same_14,$share1_4         # 102e

        fa      $more1,$more1,$c_same                   # 103e
        fm      $green_3,$green_6,$weight_2             # 104e

        fa      $more3,$more3_5,$c_same_3               # 105e
        fa      $more2_4,$more2_5,$c_same_15            # 106e

        ceq     $c_same_14,$pixel3_3,$pixel2_3          # 107e
        selb    $low,$red_6,$blue_7,$m_behind           # 108e

        selb    $high,$blue_7,$red_6,$m_behind          # 109e
        lnop                                            # 109o pairing

        and     $c_same,$c_same_14,$share2_3            # 110e
        shufb   $share0_4,$low,$green_3,$m_first        # 110o

        fa      $sum0,$sum0,$share0_3                   # 111e
        shufb   $share3,$high,$green_3,$m_fourth        # 111o

        fa      $sum1,$sum1,$more1                      # 112e
        shufb   $share2_4,$high,$green_3,$m_third       # 112o

        fa      $more3,$more3,$c_same                   # 113e
        shufb   $share1_5,$low,$green_3,$m_second       # 113o

        fa      $sum2,$sum2,$more2_4                    # 114e
        ceq     $c_same,$pixel3_4,$pixel0_4             # 115e

        ceq     $c_same_16,$pixel2_4,$pixel0_4          # 116e
        lnop                                            # 116o pairing

        ori     $more3_6,$share3,0                      # 117e
        stqx    $sum0,$a_nothing,$pixel0_3              # 117o

        and     $c_same,$c_same,$share0_4               # 118e
        stqx    $sum1,$a_nothing,$pixel1_3              # 118o

        ori     $more2_5,$share2_4,0                    # 119e
        lnop                                            # 119o pairing

        and     $c_same_6,$c_same_16,$share0_4          # 120e
        stqx    $sum2,$a_nothing,$pixel2_3              # 120o

        fa      $more3_7,$more3_6,$c_same               # 121e
        fa      $sum3,$sum3,$more3                      # 122e

        fa      $more2,$more2_5,$c_same_6               # 123e
        ceq     $c_same_3,$pixel3_4,$pixel1_4           # 124e

        a       $a_rays,$a_rays,$rays_step              # 125e
        a       $a_surfaces,$a_surfaces,$surfaces_step  # 126e

        and     $c_same_3,$c_same_3,$share1_5           # 127e
        lnop                                            # 127o pairing

next_packet:
            ceq     $c_same,$pixel1_4,$pixel0_4         # 0e
            stqx    $sum3,$a_nothing,$pixel3_3          # 0o

            fa      $more3,$more3_7,$c_same_3           # 1e
            lqx     $sum3,$a_nothing,$pixel3_4          # 1o

            ceq     $c_same_16,$pixel2_4,$pixel1_4      # 2e
            lqx     $sum0,$a_nothing,$pixel0_4          # 2o

            ori     $more1,$share1_5,0                  # 3e
            lqx     $sum1,$a_nothing,$pixel1_4          # 3o

            and     $c_same,$c_same,$share0_4           # 4e
            lqx     $sum2,$a_nothing,$pixel2_4          # 4o

            ceq     $c_same_3,$pixel3_4,$pixel2_4       # 5e
        lqd     $weight,512($a_rays)                    # 5o

            and     $c_same_16,$c_same_16,$share1_5     # 6e
        lqd     $blue,0x5c0($a_surfaces)                # 6o

            fa      $more1,$more1,$c_same               # 7e
        lqd     $red,0x540($a_surfaces)                 # 7o

            and     $c_same,$c_same_3,$share2_4         # 8e
            lnop                                        # 8o pairing

            fa      $more2,$more2,$c_same_16            # 9e
        lqd     $pixel,576($a_rays)                     # 9o

            fa      $more3,$more3,$c_same               # 10e
        lqd     $weight_2,528($a_rays)                  # 10o

            fa      $sum0,$sum0,$share0_4               # 11e
        lqd     $blue_2,0x5d0($a_surfaces)              # 11o

        fm      $blue,$blue,$weight                     # 12e
        lqd     $red_2,0x550($a_surfaces)               # 12o

        fm      $red,$red,$weight                       # 13e
        lqd     $green,0x580($a_surfaces)               # 13o

            fa      $sum1,$sum1,$more1                  # 14e
        lqd     $green_2,0x590($a_surfaces)             # 14o

            fa      $sum2,$sum2,$more2                  # 15e
        lqd     $pixel_2,592($a_rays)                   # 15o

            fa      $sum3,$sum3,$more3                  # 16e
        shufb   $pixel0,$pixel,$pixel,$m_lane0          # 16o

        fm      $blue_2,$blue_2,$weight_2               # 17e
            stqx    $sum0,$a_nothing,$pixel0_4          # 17o

        fm      $red_2,$red_2,$weight_2                 # 18e
        shufb   $pixel3,$pixel,$pixel,$m_lane3          # 18o

        fm      $green,$green,$weight                   # 19e
        rotqbyi $blue,$blue,8                           # 19o

        fm      $green_3,$green_2,$weight_2             # 20e
        shufb   $pixel1,$pixel,$pixel,$m_lane1          # 20o

        ai      $count,$count,-1                        # 21e
        shufb   $pixel2,$pixel,$pixel,$m_lane2          # 21o

        ceq     $c_same,$pixel3,$pixel0                 # 22e
            stqx    $sum1,$a_nothing,$pixel1_4          # 22o

        selb    $low,$red,$blue,$m_behind               # 23e
            stqx    $sum2,$a_nothing,$pixel2_4          # 23o

        selb    $high,$blue,$red,$m_behind              # 24e
            stqx    $sum3,$a_nothing,$pixel3_4          # 24o

        ceq     $c_same_2,$pixel2,$pixel0               # 25e
        rotqbyi $blue,$blue_2,8                         # 25o

        ceq     $c_same_3,$pixel3,$pixel1               # 26e
        shufb   $pixel3_2,$pixel_2,$pixel_2,$m_lane3    # 26o

        ceq     $c_same_6,$pixel1,$pixel0               # 27e
        shufb   $share0,$low,$green,$m_first            # 27o

        ceq     $c_same_4,$pixel2,$pixel1               # 28e
        shufb   $share3,$high,$green,$m_fourth          # 28o

        ceq     $c_same_5,$pixel3,$pixel2               # 29e
        shufb   $share2,$high,$green,$m_third           # 29o

        selb    $low_2,$red_2,$blue,$m_behind           # 30e
        shufb   $share1_2,$low,$green,$m_second         # 30o

        and     $c_same,$c_same,$share0                 # 31e
        ori     $more3,$share3,0                        # 32e

        ori     $more2,$share2,0                        # 33e
        lqd     $weight_4,544($a_rays)                  # 33o

        fa      $more3,$more3,$c_same                   # 34e
        lqx     $sum0,$a_nothing,$pixel0                # 34o

        and     $c_same,$c_same_2,$share0               # 35e
        lqx     $sum1,$a_nothing,$pixel1                # 35o

        ori     $more1,$share1_2,0                      # 36e
        shufb   $pixel2_2,$pixel_2,$pixel_2,$m_lane2    # 36o

        and     $c_same_6,$c_same_6,$share0             # 37e
        shufb   $pixel1_5,$pixel_2,$pixel_2,$m_lane1    # 37o

        fa      $more2,$more2,$c_same                   # 38e
        lqx     $sum2,$a_nothing,$pixel2                # 38o

        and     $c_same,$c_same_3,$share1_2             # 39e
        shufb   $pixel0_5,$pixel_2,$pixel_2,$m_lane0    # 39o

        selb    $high_3,$blue,$red_2,$m_behind          # 40e
        lqx     $sum3,$a_nothing,$pixel3                # 40o

        fa      $more3,$more3,$c_same                   # 41e
        lqd     $red_7,0x560($a_surfaces)               # 41o

        and     $c_same,$c_same_4,$share1_2             # 42e
        shufb   $share3_4,$high_3,$green_3,$m_fourth    # 42o

        fa      $more1,$more1,$c_same_6                 # 43e
        shufb   $share0_5,$low_2,$green_3,$m_first      # 43o

        ceq     $c_same_17,$pixel3_2,$pixel0_5          # 44e
        lqd     $blue_5,0x5e0($a_surfaces)              # 44o

        fa      $more2,$more2,$c_same                   # 45e
        lqd     $pixel_5,608($a_rays)                   # 45o

        and     $c_same_5,$c_same_5,$share2             # 46e
        lqd     $pixel_6,624($a_rays)                   # 46o

        ori     $more3_8,$share3_4,0                    # 47e
        shufb   $share2_2,$high_3,$green_3,$m_third     # 47o

        fa      $more3,$more3,$c_same_5                 # 48e
        shufb   $share1,$low_2,$green_3,$m_second       # 48o

        and     $c_same_16,$c_same_17,$share0_5         # 49e
        lqd     $green_7,0x5a0($a_surfaces)             # 49o

        fm      $blue_8,$blue_5,$weight_4               # 50e
        lqd     $weight_5,560($a_rays)                  # 50o

        fa      $sum0,$sum0,$share0                     # 51e
        shufb   $pixel0_6,$pixel_5,$pixel_5,$m_lane0    # 51o

        fa      $sum1,$sum1,$more1                      # 52e
        shufb   $pixel3_4,$pixel_6,$pixel_6,$m_lane3    # 52o

        fa      $more3_7,$more3_8,$c_same_16            # 53e
        shufb   $pixel2_4,$pixel_6,$pixel_6,$m_lane2    # 53o

        fa      $sum2,$sum2,$more2                      # 54e
        shufb   $pixel3_3,$pixel_5,$pixel_5,$m_lane3    # 54o

        ceq     $c_same_18,$pixel2_2,$pixel0_5          # 55e
        shufb   $pixel1_6,$pixel_5,$pixel_5,$m_lane1    # 55o

        a       $a_rays,$a_rays,$rays_step              # 56e
        rotqbyi $blue_8,$blue_8,8                       # 56o

        fa      $sum3,$sum3,$more3                      # 57e
        stqx    $sum0,$a_nothing,$pixel0                # 57o

        ceq     $c_same_19,$pixel3_2,$pixel1_5          # 58e
        shufb   $pixel0_4,$pixel_6,$pixel_6,$m_lane0    # 58o

        fm      $red_7,$red_7,$weight_4                 # 59e
        stqx    $sum1,$a_nothing,$pixel1                # 59o

        ori     $more2_2,$share2_2,0                    # 60e
        shufb   $pixel1_4,$pixel_6,$pixel_6,$m_lane1    # 60o

        and     $c_same_10,$c_same_18,$share0_5         # 61e
        stqx    $sum2,$a_nothing,$pixel2                # 61o

        and     $c_same_19,$c_same_19,$share1           # 62e
        lnop                                            # 62o pairing

        fm      $green_7,$green_7,$weight_4             # 63e
        stqx    $sum3,$a_nothing,$pixel3                # 63o

        fa      $more2_6,$more2_2,$c_same_10            # 64e
        lnop                                            # 64o pairing

        ceq     $c_same_20,$pixel1_5,$pixel0_5          # 65e
        lqd     $red_8,0x570($a_surfaces)               # 65o

        fa      $more3,$more3_7,$c_same_19              # 66e
        lqd     $green_3,0x5b0($a_surfaces)             # 66o

        ceq     $c_same_19,$pixel2_2,$pixel1_5          # 67e
        shufb   $pixel2_5,$pixel_5,$pixel_5,$m_lane2    # 67o

        ori     $more1,$share1,0                        # 68e
        lqd     $blue_6,0x5f0($a_surfaces)              # 68o

        a       $a_surfaces,$a_surfaces,$surfaces_step  # 69e
        and     $c_same,$c_same_20,$share0_5            # 70e

        ceq     $c_same_20,$pixel3_2,$pixel2_2          # 71e
        selb    $low_5,$red_7,$blue_8,$m_behind         # 72e

        selb    $high,$blue_8,$red_7,$m_behind          # 73e
        lqx     $sum0_4,$a_nothing,$pixel0_5            # 73o

        and     $c_same_19,$c_same_19,$share1           # 74e
        shufb   $share0_3,$low_5,$green_7,$m_first      # 74o

        fa      $more1,$more1,$c_same                   # 75e
        shufb   $share3_5,$high,$green_7,$m_fourth      # 75o

        and     $c_same,$c_same_20,$share2_2            # 76e
        shufb   $share1_4,$low_5,$green_7,$m_second     # 76o

        fa      $more2_6,$more2_6,$c_same_19            # 77e
        shufb   $share2_5,$high,$green_7,$m_third       # 77o

        fa      $more3,$more3,$c_same                   # 78e
        lqx     $sum1,$a_nothing,$pixel1_5              # 78o

        ceq     $c_same,$pixel3_3,$pixel0_6             # 79e
        lnop                                            # 79o pairing

        ori     $more3_9,$share3_5,0                    # 80e
        lqx     $sum2,$a_nothing,$pixel2_2              # 80o

        and     $c_same,$c_same,$share0_3               # 81e
        lnop                                            # 81o pairing

        fm      $blue_4,$blue_6,$weight_5               # 82e
        lqx     $sum3,$a_nothing,$pixel3_2              # 82o

        fa      $sum0,$sum0_4,$share0_5                 # 83e
        fa      $sum1,$sum1,$more1                      # 84e

        fa      $more3_10,$more3_9,$c_same              # 85e
        fa      $sum2,$sum2,$more2_6                    # 86e

        ceq     $c_same,$pixel2_5,$pixel0_6             # 87e
        lnop                                            # 87o pairing

        fa      $sum3,$sum3,$more3                      # 88e
        rotqbyi $blue_9,$blue_4,8                       # 88o

        ceq     $c_same_21,$pixel3_3,$pixel1_6          # 89e
        stqx    $sum0,$a_nothing,$pixel0_5              # 89o

        fm      $red_9,$red_8,$weight_5                 # 90e
        stqx    $sum1,$a_nothing,$pixel1_5              # 90o

        ori     $more2_7,$share2_5,0                    # 91e
        lnop                                            # 91o pairing

        and     $c_same,$c_same,$share0_3               # 92e
        stqx    $sum2,$a_nothing,$pixel2_2              # 92o

        and     $c_same_2,$c_same_21,$share1_4          # 93e
        lnop                                            # 93o pairing

        fm      $green_3,$green_3,$weight_5             # 94e
        stqx    $sum3,$a_nothing,$pixel3_2              # 94o

        fa      $more2_5,$more2_7,$c_same               # 95e
        ceq     $c_same,$pixel1_6,$pixel0_6             # 96e

        fa      $more3,$more3_10,$c_same_2              # 97e
        ceq     $c_same_2,$pixel2_5,$pixel1_6           # 98e

        ori     $more1,$share1_4,0                      # 99e
        and     $c_same,$c_same,$share0_3               # 100e

        ceq     $c_same_14,$pixel3_3,$pixel2_5          # 101e
        hbrr    next_packet_back,next_packet            # 101o hint

        selb    $low,$red_9,$blue_9,$m_behind           # 102e
        lqx     $sum1,$a_nothing,$pixel1_6              # 102o

        selb    $high,$blue_9,$red_9,$m_behind          # 103e
        lqx     $sum0,$a_nothing,$pixel0_6              # 103o

        and     $c_same_3,$c_same_2,$share1_4           # 104e
        shufb   $share0_4,$low,$green_3,$m_first        # 104o

        fa      $more1,$more1,$c_same                   # 105e
        shufb   $share3,$high,$green_3,$m_fourth        # 105o

        and     $c_same,$c_same_14,$share2_5            # 106e
        shufb   $share1_5,$low,$green_3,$m_second       # 106o

        fa      $more2_4,$more2_5,$c_same_3             # 107e
        shufb   $share2_4,$high,$green_3,$m_third       # 107o

        fa      $more3,$more3,$c_same                   # 108e
        lnop                                            # 108o pairing

        ceq     $c_same,$pixel3_4,$pixel0_4             # 109e
        lqx     $sum2,$a_nothing,$pixel2_5              # 109o

        ori     $more3_7,$share3,0                      # 110e
        lnop                                            # 110o pairing

        and     $c_same,$c_same,$share0_4               # 111e
        lqx     $sum3,$a_nothing,$pixel3_3              # 111o

        fa      $sum0,$sum0,$share0_3                   # 112e
        fa      $sum1,$sum1,$more1                      # 113e

        fa      $more3_7,$more3_7,$c_same               # 114e
        fa      $sum2,$sum2,$more2_4                    # 115e

        ceq     $c_same,$pixel2_4,$pixel0_4             # 116e
        fa      $sum3,$sum3,$more3                      # 117e

        ceq     $c_same_3,$pixel3_4,$pixel1_4           # 118e
        stqx    $sum0,$a_nothing,$pixel0_6              # 118o

        ori     $more2_5,$share2_4,0                    # 119e
        stqx    $sum1,$a_nothing,$pixel1_6              # 119o

        and     $c_same,$c_same,$share0_4               # 120e
        lnop                                            # 120o pairing

        and     $c_same_3,$c_same_3,$share1_5           # 121e
        stqx    $sum2,$a_nothing,$pixel2_5              # 121o

        fa      $more2,$more2_5,$c_same                 # 122e
next_packet_back:
        brnz    $count,next_packet                      # 122o

next_packet_drain:
        ceq     $c_same,$pixel1_4,$pixel0_4             # 0e
        stqx    $sum3,$a_nothing,$pixel3_3              # 0o

        fa      $more3,$more3_7,$c_same_3               # 1e
        lqx     $sum0,$a_nothing,$pixel0_4              # 1o

        ceq     $c_same_16,$pixel2_4,$pixel1_4          # 2e
        lqx     $sum1,$a_nothing,$pixel1_4              # 2o

        ori     $more1,$share1_5,0                      # 3e
        hbr     accumulate_r16_return,$lr               # 3o hint

        and     $c_same,$c_same,$share0_4               # 4e
        lqx     $sum2,$a_nothing,$pixel2_4              # 4o

        ceq     $c_same_3,$pixel3_4,$pixel2_4           # 5e
        lqx     $sum3,$a_nothing,$pixel3_4              # 5o

        and     $c_same_16,$c_same_16,$share1_5         # 6e
        fa      $more1,$more1,$c_same                   # 7e

        and     $c_same,$c_same_3,$share2_4             # 8e
        fa      $more2,$more2,$c_same_16                # 9e

        fa      $more3,$more3,$c_same                   # 10e
        fa      $sum0,$sum0,$share0_4                   # 11e

        fa      $sum1,$sum1,$more1                      # 13e
        fa      $sum2,$sum2,$more2                      # 15e

        fa      $sum3,$sum3,$more3                      # 16e
        stqx    $sum0,$a_nothing,$pixel0_4              # 17o

        stqx    $sum1,$a_nothing,$pixel1_4              # 19o
        stqx    $sum2,$a_nothing,$pixel2_4              # 21o

        stqx    $sum3,$a_nothing,$pixel3_4              # 22o
accumulate_r16_return:
        bi      $lr                                     # 23o

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

        fm      $green_3,$green_2,$weight_2             # 14e
        shufb   $pixel1,$pixel,$pixel,$m_lane1          # 14o

        ceq     $c_same,$pixel3,$pixel0                 # 15e
        shufb   $pixel0_7,$pixel_2,$pixel_2,$m_lane0    # 15o

        ceq     $c_same_22,$pixel2,$pixel0              # 16e
        shufb   $pixel3_5,$pixel_2,$pixel_2,$m_lane3    # 16o

        selb    $low_2,$red,$blue,$m_behind             # 17e
        lqd     $weight_5,544($a_rays)                  # 17o

        selb    $high_2,$blue,$red,$m_behind            # 18e
        rotqbyi $blue,$blue_2,8                         # 18o

        ceq     $c_same_3,$pixel3,$pixel1               # 19e
        shufb   $share0,$low_2,$green,$m_first          # 19o

        ceq     $c_same_5,$pixel1,$pixel0               # 20e
        shufb   $share3,$high_2,$green,$m_fourth        # 20o

        ceq     $c_same_8,$pixel2,$pixel1               # 21e
        shufb   $share2_6,$high_2,$green,$m_third       # 21o

        ceq     $c_same_10,$pixel3,$pixel2              # 22e
        shufb   $share1_2,$low_2,$green,$m_second       # 22o

        and     $c_same,$c_same,$share0                 # 23e
        lqd     $blue_8,0x5e0($a_surfaces)              # 23o

        ori     $more3,$share3,0                        # 24e
        lqx     $sum0_5,$a_nothing,$pixel0              # 24o

        ori     $more2,$share2_6,0                      # 25e
        lqx     $sum1,$a_nothing,$pixel1                # 25o

        fa      $more3,$more3,$c_same                   # 26e
        lqx     $sum2,$a_nothing,$pixel2                # 26o

        and     $c_same,$c_same_22,$share0              # 27e
        lqx     $sum3,$a_nothing,$pixel3                # 27o

        and     $c_same_3,$c_same_3,$share1_2           # 28e
        lqd     $red_10,0x560($a_surfaces)              # 28o

        fa      $more2,$more2,$c_same                   # 29e
        shufb   $pixel2_6,$pixel_2,$pixel_2,$m_lane2    # 29o

        ori     $more1_5,$share1_2,0                    # 30e
        shufb   $pixel1_2,$pixel_2,$pixel_2,$m_lane1    # 30o

        and     $c_same_5,$c_same_5,$share0             # 31e
        lqd     $green_8,0x5a0($a_surfaces)             # 31o

        fa      $more3,$more3,$c_same_3                 # 32e
        lqd     $pixel_7,608($a_rays)                   # 32o

        selb    $low_6,$red_2,$blue,$m_behind           # 33e
        lqd     $weight_6,560($a_rays)                  # 33o

        selb    $high_3,$blue,$red_2,$m_behind          # 34e
        lqd     $blue,0x5f0($a_surfaces)                # 34o

        and     $c_same_7,$c_same_8,$share1_2           # 35e
        shufb   $share0_6,$low_6,$green_3,$m_first      # 35o

        fa      $more1_4,$more1_5,$c_same_5             # 36e
        shufb   $share3_6,$high_3,$green_3,$m_fourth    # 36o

        and     $c_same_6,$c_same_10,$share2_6          # 37e
        shufb   $share2_2,$high_3,$green_3,$m_third     # 37o

        fa      $more2,$more2,$c_same_7                 # 38e
        shufb   $share1_6,$low_6,$green_3,$m_second     # 38o

        fa      $more3,$more3,$c_same_6                 # 39e
        shufb   $pixel0_3,$pixel_7,$pixel_7,$m_lane0    # 39o

        ceq     $c_same_7,$pixel3_5,$pixel0_7           # 40e
        shufb   $pixel3_6,$pixel_7,$pixel_7,$m_lane3    # 40o

        ori     $more3_11,$share3_6,0                   # 41e
        lqd     $red_11,0x570($a_surfaces)              # 41o

        and     $c_same_7,$c_same_7,$share0_6           # 42e
        shufb   $pixel2_7,$pixel_7,$pixel_7,$m_lane2    # 42o

        fm      $blue_8,$blue_8,$weight_5               # 43e
        shufb   $pixel1_7,$pixel_7,$pixel_7,$m_lane1    # 43o

        fa      $sum0_2,$sum0_5,$share0                 # 44e
        lqd     $green_9,0x5b0($a_surfaces)             # 44o

        fa      $sum1,$sum1,$more1_4                    # 45e
        lqd     $pixel_4,624($a_rays)                   # 45o

        fa      $more3_8,$more3_11,$c_same_7            # 46e
        fa      $sum2,$sum2,$more2                      # 47e

        ceq     $c_same,$pixel2_6,$pixel0_7             # 48e
        lnop                                            # 48o pairing

        fa      $sum3,$sum3,$more3                      # 49e
        rotqbyi $blue_8,$blue_8,8                       # 49o

        ceq     $c_same_23,$pixel3_5,$pixel1_2          # 50e
        stqx    $sum0_2,$a_nothing,$pixel0              # 50o

        fm      $red_10,$red_10,$weight_5               # 51e
        stqx    $sum1,$a_nothing,$pixel1                # 51o

        ori     $more2_8,$share2_2,0                    # 52e
        shufb   $pixel0_8,$pixel_4,$pixel_4,$m_lane0    # 52o

        and     $c_same,$c_same,$share0_6               # 53e
        stqx    $sum2,$a_nothing,$pixel2                # 53o

        and     $c_same_11,$c_same_23,$share1_6         # 54e
        shufb   $pixel3_7,$pixel_4,$pixel_4,$m_lane3    # 54o

        fm      $green_10,$green_8,$weight_5            # 55e
        stqx    $sum3,$a_nothing,$pixel3                # 55o

        fa      $more2,$more2_8,$c_same                 # 56e
        lqx     $sum0_6,$a_nothing,$pixel0_7            # 56o

        ceq     $c_same,$pixel1_2,$pixel0_7             # 57e
        lqx     $sum1,$a_nothing,$pixel1_2              # 57o

        fa      $more3,$more3_8,$c_same_11              # 58e
        lqx     $sum2,$a_nothing,$pixel2_6              # 58o

        ceq     $c_same_7,$pixel2_6,$pixel1_2           # 59e
        lqx     $sum3,$a_nothing,$pixel3_5              # 59o

        ori     $more1_6,$share1_6,0                    # 60e
        shufb   $pixel2_5,$pixel_4,$pixel_4,$m_lane2    # 60o

        and     $c_same,$c_same,$share0_6               # 61e
        shufb   $pixel1_8,$pixel_4,$pixel_4,$m_lane1    # 61o

        ceq     $c_same_24,$pixel3_5,$pixel2_6          # 62e
        selb    $low_7,$red_10,$blue_8,$m_behind        # 63e

        selb    $high,$blue_8,$red_10,$m_behind         # 64e
        lnop                                            # 64o pairing

        and     $c_same_16,$c_same_7,$share1_6          # 65e
        shufb   $share0_7,$low_7,$green_10,$m_first     # 65o

        fa      $more1_7,$more1_6,$c_same               # 66e
        shufb   $share3_7,$high,$green_10,$m_fourth     # 66o

        and     $c_same,$c_same_24,$share2_2            # 67e
        shufb   $share2_2,$high,$green_10,$m_third      # 67o

        fa      $more2,$more2,$c_same_16                # 68e
        shufb   $share1_6,$low_7,$green_10,$m_second    # 68o

        fa      $more3,$more3,$c_same                   # 69e
        ceq     $c_same,$pixel3_6,$pixel0_3             # 70e

        ori     $more3_9,$share3_7,0                    # 71e
        and     $c_same,$c_same,$share0_7               # 72e

        fm      $blue,$blue,$weight_6                   # 73e
        fa      $sum0_7,$sum0_6,$share0_6               # 74e

        fa      $sum1,$sum1,$more1_7                    # 75e
        fa      $more3_8,$more3_9,$c_same               # 76e

        fa      $sum2,$sum2,$more2                      # 77e
        ceq     $c_same,$pixel2_7,$pixel0_3             # 78e

        fa      $sum3,$sum3,$more3                      # 79e
        rotqbyi $blue,$blue,8                           # 79o

        ceq     $c_same_13,$pixel3_6,$pixel1_7          # 80e
        stqx    $sum0_7,$a_nothing,$pixel0_7            # 80o

        fm      $red_12,$red_11,$weight_6               # 81e
        stqx    $sum1,$a_nothing,$pixel1_2              # 81o

        ori     $more2,$share2_2,0                      # 82e
        lnop                                            # 82o pairing

        and     $c_same,$c_same,$share0_7               # 83e
        stqx    $sum2,$a_nothing,$pixel2_6              # 83o

        and     $c_same_14,$c_same_13,$share1_6         # 84e
        lnop                                            # 84o pairing

        fm      $green_5,$green_9,$weight_6             # 85e
        stqx    $sum3,$a_nothing,$pixel3_5              # 85o

        fa      $more2,$more2,$c_same                   # 86e
        lqx     $sum0_8,$a_nothing,$pixel0_3            # 86o

        ceq     $c_same,$pixel1_7,$pixel0_3             # 87e
        lqx     $sum1,$a_nothing,$pixel1_7              # 87o

        fa      $more3,$more3_8,$c_same_14              # 88e
        lqx     $sum2,$a_nothing,$pixel2_7              # 88o

        ceq     $c_same_14,$pixel2_7,$pixel1_7          # 89e
        lqx     $sum3,$a_nothing,$pixel3_6              # 89o

        ori     $more1,$share1_6,0                      # 90e
        and     $c_same,$c_same,$share0_7               # 91e

        ceq     $c_same_7,$pixel3_6,$pixel2_7           # 92e
        selb    $low_8,$red_12,$blue,$m_behind          # 93e

        selb    $high_5,$blue,$red_12,$m_behind         # 94e
        lnop                                            # 94o pairing

        and     $c_same_16,$c_same_14,$share1_6         # 95e
        shufb   $share0_8,$low_8,$green_5,$m_first      # 95o

        fa      $more1,$more1,$c_same                   # 96e
        shufb   $share3,$high_5,$green_5,$m_fourth      # 96o

        and     $c_same,$c_same_7,$share2_2             # 97e
        shufb   $share2,$high_5,$green_5,$m_third       # 97o

        fa      $more2,$more2,$c_same_16                # 98e
        shufb   $share1_6,$low_8,$green_5,$m_second     # 98o

        fa      $more3,$more3,$c_same                   # 99e
        ceq     $c_same,$pixel3_7,$pixel0_8             # 100e

        ori     $more3_12,$share3,0                     # 101e
        and     $c_same,$c_same,$share0_8               # 102e

        fa      $sum0_9,$sum0_8,$share0_7               # 103e
        hbrr    next_packet_short_back,next_packet_short # 103o hint

        fa      $sum1,$sum1,$more1                      # 104e
        fa      $more3_12,$more3_12,$c_same             # 105e

        fa      $sum2,$sum2,$more2                      # 106e
        ceq     $c_same,$pixel2_5,$pixel0_8             # 107e

        fa      $sum3,$sum3,$more3                      # 108e
        lnop                                            # 108o pairing

        ceq     $c_same_22,$pixel3_7,$pixel1_8          # 109e
        stqx    $sum0_9,$a_nothing,$pixel0_3            # 109o

        ori     $more2,$share2,0                        # 110e
        stqx    $sum1,$a_nothing,$pixel1_7              # 110o

        and     $c_same,$c_same,$share0_8               # 111e
        lnop                                            # 111o pairing

        and     $c_same_3,$c_same_22,$share1_6          # 112e
        stqx    $sum2,$a_nothing,$pixel2_7              # 112o

        fa      $more2,$more2,$c_same                   # 113e
        lnop                                            # 113o pairing

        ceq     $c_same,$pixel1_8,$pixel0_8             # 114e
        stqx    $sum3,$a_nothing,$pixel3_6              # 114o

        fa      $more3,$more3_12,$c_same_3              # 115e
        lqx     $sum0,$a_nothing,$pixel0_8              # 115o

        ceq     $c_same_3,$pixel2_5,$pixel1_8           # 116e
        lqx     $sum1,$a_nothing,$pixel1_8              # 116o

        ori     $more1,$share1_6,0                      # 117e
        lqx     $sum2,$a_nothing,$pixel2_5              # 117o

        and     $c_same,$c_same,$share0_8               # 118e
        lqx     $sum3,$a_nothing,$pixel3_7              # 118o

        ceq     $c_same_15,$pixel3_7,$pixel2_5          # 119e
        and     $c_same_16,$c_same_3,$share1_6          # 120e

        fa      $more1,$more1,$c_same                   # 121e
        and     $c_same,$c_same_15,$share2              # 122e

        fa      $more2,$more2,$c_same_16                # 123e
        fa      $more3,$more3,$c_same                   # 124e

        fa      $sum0,$sum0,$share0_8                   # 125e
        a       $a_rays,$a_rays,$rays_step              # 126e

        fa      $sum1,$sum1,$more1                      # 127e
        a       $a_surfaces,$a_surfaces,$surfaces_step  # 128e

        fa      $sum2,$sum2,$more2                      # 129e
        fa      $sum3,$sum3,$more3                      # 130e

        stqx    $sum0,$a_nothing,$pixel0_8              # 131o
        stqx    $sum1,$a_nothing,$pixel1_8              # 133o

        stqx    $sum2,$a_nothing,$pixel2_5              # 135o
        stqx    $sum3,$a_nothing,$pixel3_7              # 136o

        nop     $127                                    # 137e pairing
next_packet_short_back:
        brnz    $count,next_packet_short                # 137o

        nop     $127                                    # 138e pairing
        bi      $lr                                     # 138o
endfunction accumulate_r16
