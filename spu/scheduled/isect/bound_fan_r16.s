# bound_fan_r16   what the rays of packets are within that all go through one point, or end there
#   C       void bound_fan_r16(const struct rays16 *, int count, struct bound *,
#                              const struct light *, float along);
#   In      $3 RAYS16, one behind the other, $4 count (at least 1), $5 BOUNDs, $6 LIGHT, whose
#           position is the point, $7 1 if the rays start there, -1 if they end there; pointers
#           16-aligned
#   Out     the packets' bounds, one behind the other: of rays that end there, as if they came from
#           there
#   Uses    $2-$74, $79   Saves  -   Stack  0   Calls  -
#   Domain  |d| = 1 within 4 ulp, of rays whose t has no sign; others are not there, and anything.
#           The rays' ends at the point are within LIGHT_near of it, the rounding of cull_nodes
#           included
#   Error   0: no ray is outside; axis, cosine and sine allow for the rounding of cull_nodes
#   Twin    lab/twins/src/bound.rs
#
# The apex is the point, and the radius is LIGHT_near: a ray that ends there is the same segment,
# by its t, as one that comes from there. The axis is the normalised mean of the directions. For
# unit vectors, the square of the chord is c = |d - axis|^2 = 2 - 2 cos. With the largest chord,
#   cosine = (1 - c/2) (1 - 2^-12)        because cull_nodes computes a length to 12 bits
#   sine = sqrt(c - c^2/4) + 2^-18        because the relative error of c is about 2^-20
# If a direction is more than 79 degrees from the axis, the cone is of little use. Near a right
# angle, sine^2 + cosine^2 would exceed 1, but cull_nodes relies on it being less. Then axis,
# cosine and sine are all 0. The same holds if the sum of the directions is too short for such a
# cone, which has at least 3/16 in length, and might be 0. Without any ray, sine and radius are
# minus the largest single.
#
# Tried: axes and chords in one loop. It takes 101 cycles a packet instead of 106, but has five
# stages. The code is 0.4 KB larger, and a call takes correspondingly longer until the stages are
# full.
# Scheduled by spu schedule from bound_fan_r16.s

        .include "bound_tmpl.inc"

        .set    a_light,6
        .set    along,7
        # constants
        .set    k_along,12                              # the weight: 1, or -1 to reverse the rays
        .set    k_short,8
        .set    k_wide,9
        .set    k_cosine,49
        .set    k_chord,50
        .set    k_quarter,51                            # by lanes: chord, t
        .set    k_sine,52                               # the same: 1, 0
        .set    k_least,53                              # the same: least sine, radius
        .set    m_even,54
        .set    m_odd,55
        # of all packets
        .set    apex,56
        .set    apex_x,57
        .set    apex_y,58
        .set    apex_z,59
        # before the loops
        .set    light,60
        .set    m_least,61
        .set    packets,62
        .set    a_first,63
        # the axis
        .set    axis,64
        .set    axis_x,65
        .set    axis_y,66
        .set    axis_z,67
        .set    length,68                               # squared
        .set    c_short,69
        # the cone
        .set    top,31                                  # chord^2, t; the sums are no longer needed
        .set    top_t,32
        .set    most,33                                 # of all lanes: chord^2, t
        .set    t_odd,34
        .set    root,70
        .set    cosine,71
        .set    c_wide,72
        .set    limits,73
        .set    a_first_bound,74

        .section .rodata
        .align  4
quarter_by_lane:
        .float  0.25,0,0,0
sine_by_lane:
        .float  1,0,0,0
least_by_lane:                                          # 2^-18
        .int    0x36800000,0,0,0
# The even-numbered words of two quadwords, and the odd-numbered ones.
even_words:
        .int    0x00010203,0x10111213,0x08090a0b,0x18191a1b
odd_words:
        .int    0x04050607,0x14151617,0x0c0d0e0f,0x1c1d1e1f
# The least sine, and the light's distance of the rays from it.
least_and_near:
        .int    0x00010203,0x1c1d1e1f,0x80808080,0x80808080

function bound_fan_r16
        .set count_2,79; .set a_packet_2,2; .set t_2,18; .set vz_2,7; .set a_packet_3,6
        .set vx_2,19; .set vy_2,22; .set weight_2,18; .set t_3,20; .set a_packet_4,21; .set vx_3,23
        .set top_t_2,27; .set vz_3,24; .set top_2,26; .set vy_3,25; .set most_2,7; .set there1_2,29
        .set vz_4,30; .set vy_4,31; .set weight1_2,29; .set vx_4,3; .set weight2_2,20; .set t_4,32
        .set top_t_3,22; .set vz_5,27; .set top_3,19; .set vy_5,26; .set vx_5,7; .set there3_2,18
        .set t_5,28; .set vz_6,29; .set weight3_2,18; .set vx_6,35; .set t_6,23; .set vx_7,20
        .set there_2,24; .set vz_7,32; .set there1_3,28; .set vy_6,36; .set weight_3,24
        .set t_7,37; .set t_8,31; .set top_4,3; .set vz_8,19; .set vy_7,18; .set top_t_4,26
        .set vx_8,30; .set top_5,7; .set vz_9,38; .set most_3,24; .set weight1_3,28
        .set t_words3_2,39; .set there2_2,23; .set t_words1_2,22; .set there_3,37
        .set t_words2_2,40; .set top_t_5,25; .set t_words_2,3; .set vx_9,2; .set t_9,24
        .set weight2_3,23; .set there3_3,26; .set t_rows1_2,28; .set weight_4,29; .set t_rows_2,3
        .set vz_10,20; .set t_rows_3,37; .set vy_8,3; .set t_10,25; .set weight3_3,26
        .set vx_10,28; .set top_t_6,18; .set vz_11,31; .set top_6,30; .set vy_9,32; .set most_4,19
        .set t_11,29; .set t_12,27; .set t_rows_4,35; .set vz_12,36; .set top_7,2; .set vy_10,7
        .set vx_11,6; .set there1_4,24; .set vz_13,26; .set there2_3,25; .set vy_11,37
        .set weight1_4,24; .set length_2,39; .set top_t_7,3; .set vx_12,18; .set top_8,23
        .set t_words2_3,30; .set t_words_3,2; .set there3_4,25; .set vz_14,33; .set there_4,27
        .set t_y_2,29; .set t_e_2,3; .set t_rows_5,2; .set vx_13,24; .set vz_15,23; .set most_5,6
        .set top_t_8,19; .set top_9,18; .set most_6,22; .set t_13,26; .set there1_5,20
        .set weight1_5,2; .set t_words_4,6; .set vy_12,30; .set length_3,19; .set t_rows_6,18
        .set vx_14,31; .set top_10,6; .set t_y_3,7; .set t_e_3,20; .set t_14,6; .set vz_16,21
        .set vy_13,20; .set there1_6,23; .set t_words_5,18; .set a_bound_2,3; .set t_rows_7,4
        .set a_bound_3,6; .set a_bound_4,7; .set a_bound_5,14; .set t_y_4,13; .set length_4,13
        .set length_5,5; .set t_y_5,5; .set inverse_2,14; .set c_short_2,2; .set inverse_3,3
        .set axis_2,20; .set vx_15,13; .set vx_16,48; .set vy_14,14; .set a_packet_5,8
        .set vx_17,10; .set vz_17,25; .set vz_18,35; .set t_15,13; .set there_5,61
        .set there1_7,39; .set vz_19,18; .set squared_2,19; .set vy_15,60; .set squared_3,6
        .set squared_4,22; .set vy_16,10; .set vy_17,24; .set vz_20,45; .set axis_3,14
        .set vz_21,68; .set vz_22,10; .set top_t_9,24; .set there2_4,42; .set top_t_10,30
        .set t_16,10; .set vz_23,39; .set c_greater_2,34; .set vy_18,6; .set there3_5,62
        .set c_greater_3,2; .set top_t_11,28; .set a_bound_6,30; .set a_bound_7,29
        .set c_greater_4,19; .set top_t_12,63; .set a_bound_8,13; .set a_bound_9,37
        .set a_bound_10,38; .set vx_18,22; .set t_odd_2,23; .set most_7,28; .set a_bound_11,41
        .set vy_19,5; .set a_bound_12,2; .set axis_4,18; .set c_greater_5,14; .set a_bound_13,34
        .set squared_5,42; .set a_bound_14,36; .set most_8,14; .set squared_6,26
        .set a_bound_15,40; .set a_bound_16,43; .set a_bound_17,19; .set squared_7,5
        .set squared_8,14; .set t_y_6,22; .set squared_9,3; .set t_17,22; .set vx_19,46
        .set vx_20,63; .set vy_20,64; .set c_wide_2,6; .set vx_21,44; .set t_y_7,35; .set t_18,42
        .set t_y_8,28; .set top_11,5; .set c_greater_6,33; .set out_2,39; .set there2_5,47
        .set t_e_4,32; .set out_3,20; .set c_greater_7,60; .set top_t_13,33; .set t_19,70
        .set squared_10,24; .set out_4,14; .set c_greater_8,31; .set c_greater_9,20; .set root_2,13
        .set top_t_14,14; .set c_greater_10,22; .set top_t_15,7; .set vy_21,8; .set c_greater_11,10
        .set top_t_16,10; .set t_odd_3,22; .set c_greater_12,7; .set vz_24,22; .set t_odd_4,7
        .set a_packet_6,7; .set t_y_9,8; .set squared_11,20; .set out_5,21; .set t_20,8
        .set t_y_10,31; .set top_t_17,8; .set vy_22,28; .set axis_5,4; .set squared_12,10
        .set a_bound_18,20; .set a_bound_19,21; .set a_bound_20,12; .set a_bound_21,23
        .set a_bound_22,8; .set squared_13,7; .set t_y_11,14; .set a_bound_23,24
        .set a_bound_24,25; .set a_bound_25,22; .set t_21,14; .set top_12,10; .set out_6,18
        .set t_y_12,3; .set limits_2,7; .set t_odd_5,10; .set t_y_13,2; .set none_2,3
        .set limits_3,5; .set t_22,2; .set limits_4,4; .set out_7,5; .set limits_5,2
        .set there1_8,6; .set there2_6,22; .set weight1_6,6; .set weight2_4,22; .set there3_6,6
        .set vy_23,13; .set vz_25,14; .set t_23,21; .set t_24,3; .set squared_14,8
        .set c_greater_13,6; .set there3_7,7; .set out_8,2; .set out_9,6; .set out_10,7
        ilhu    $m_x,1                                  # 0e
        lqa     $k_least,least_by_lane                  # 0o
        ilhu    $m_y,0x405                              # 1e
        lqa     $m_least,least_and_near                 # 1o
        ilhu    $m_z,0x809                              # 2e
        lqd     $light,16($a_light)                     # 2o
        iohl    $m_x,515                                # 3e
        lqd     $apex,0($a_light)                       # 3o
        iohl    $m_y,0x607                              # 4e
        lqa     $m_first,transpose_first                # 4o
        iohl    $m_z,0xa0b                              # 5e
        lqa     $m_last,transpose_last                  # 5o
        ilhu    $k_cosine,0x3f7f                        # 6e 1 - 2^-12
        lqa     $k_quarter,quarter_by_lane              # 6o
        ilhu    $k_chord,0x3eff                         # 7e half of it
        lqa     $k_sine,sine_by_lane                    # 7o
        clgti   $count_2,$count,4                       # 8e at least as many passes as overlap
        lqa     $m_even,even_words                      # 8o
        ilhu    $k_one,0x3f80                           # 9e
        lqa     $m_odd,odd_words                        # 9o
        ilhu    $k_half,0x3f00                          # 10e
        shufb   $k_along,$along,$along,$m_x             # 10o
        ilhu    $k_short,0x3d00                         # 11e 1/32, less than (3/16)^2
        shufb   $k_least,$k_least,$light,$m_least       # 11o
        ilhu    $k_wide,0x3fd0                          # 12e 2 - 2 (3/16)
        shufb   $apex_x,$apex,$apex,$m_x                # 12o
        iohl    $k_cosine,0xf000                        # 13e 1 - 2^-12
        shufb   $apex_y,$apex,$apex,$m_y                # 13o
        iohl    $k_chord,0xf000                         # 14e half of it
        shufb   $apex_z,$apex,$apex,$m_z                # 14o
        ori     $packets,$count,0                       # 15e
        ori     $a_first,$a_packet,0                    # 16e
        ori     $a_first_bound,$a_bound,0               # 17e
        lnop                                            # 17o pairing
        il      $t_odd,0                                # 18e
        brz     $count_2,next_axis_short                # 18o too few passes
        ai      $a_packet_2,$a_packet,320               # 19e
        lqd     $t_2,384($a_packet)                     # 19o
        ai      $count,$count,-1                        # 20e
        lqd     $vz_2,320($a_packet)                    # 20o
        ai      $a_packet_2,$a_packet_2,320             # 21e
        lqd     $vy,256($a_packet)                      # 21o
        ai      $count,$count,-1                        # 22e
        lqd     $vx,192($a_packet)                      # 22o
        ai      $a_packet_3,$a_packet_2,320             # 23e
        lqd     $t,400($a_packet)                       # 23o
        ai      $count,$count,-1                        # 24e
        lqd     $vz,336($a_packet)                      # 24o
        cgti    $there,$t_2,-1                          # 25e
        lqd     $vx_2,208($a_packet)                    # 25o
        ai      $a_packet_3,$a_packet_3,320             # 26e
        lqd     $vy_2,272($a_packet)                    # 26o
        and     $weight_2,$there,$k_along               # 27e
        lqd     $t_3,416($a_packet)                     # 27o
        ai      $a_packet_4,$a_packet_3,320             # 28e
        lqd     $vx_3,224($a_packet)                    # 28o
        fm      $top_t_2,$vy,$weight_2                  # 29e
        lqd     $vz_3,352($a_packet)                    # 29o
        fm      $top_2,$vx,$weight_2                    # 30e
        lqd     $vy_3,288($a_packet)                    # 30o
        fm      $most_2,$vz_2,$weight_2                 # 31e
        lqd     $t_2,432($a_packet)                     # 31o
        cgti    $there1_2,$t,-1                         # 32e
        lqd     $vz_4,368($a_packet)                    # 32o
        cgti    $there+2,$t_3,-1                        # 33e
        lqd     $vy_4,304($a_packet)                    # 33o
        and     $weight1_2,$there1_2,$k_along           # 34e
        lqd     $vx_4,240($a_packet)                    # 34o
        and     $weight2_2,$there+2,$k_along            # 35e
        lqd     $t_4,384($a_packet_2)                   # 35o
        fma     $top_t_3,$vy_2,$weight1_2,$top_t_2      # 36e
        lqd     $vz_5,320($a_packet_2)                  # 36o
        fma     $top_3,$vx_2,$weight1_2,$top_2          # 37e
        lqd     $vy_5,256($a_packet_2)                  # 37o
        fma     $most,$vz,$weight1_2,$most_2            # 38e
        lqd     $vx_5,192($a_packet_2)                  # 38o
        cgti    $there3_2,$t_2,-1                       # 39e
        lqd     $t_5,400($a_packet_2)                   # 39o
        ai      $a_packet_4,$a_packet_4,320             # 40e
        lqd     $vz_6,336($a_packet_2)                  # 40o
        and     $weight3_2,$there3_2,$k_along           # 41e
        lqd     $vx_6,208($a_packet_2)                  # 41o
        fma     $top_t_3,$vy_3,$weight2_2,$top_t_3      # 42e
        lqd     $vy_3,272($a_packet_2)                  # 42o
        fma     $top_3,$vx_3,$weight2_2,$top_3          # 43e
        lqd     $t_6,416($a_packet_2)                   # 43o
        fma     $most,$vz_3,$weight2_2,$most            # 44e
        lqd     $vx_7,224($a_packet_2)                  # 44o
        cgti    $there_2,$t_4,-1                        # 45e
        lqd     $vz_7,352($a_packet_2)                  # 45o
        cgti    $there1_3,$t_5,-1                       # 46e
        lqd     $vy_6,288($a_packet_2)                  # 46o
        and     $weight_3,$there_2,$k_along             # 47e
        lqd     $t_7,384($a_packet_3)                   # 47o
        fma     $top_t_3,$vy_4,$weight3_2,$top_t_3      # 48e
        lqd     $t_8,432($a_packet_2)                   # 48o
        fma     $top_4,$vx_4,$weight3_2,$top_3          # 49e
        lqd     $vz_8,320($a_packet_3)                  # 49o
        fma     $most,$vz_4,$weight3_2,$most            # 50e
        lqd     $vy_7,256($a_packet_3)                  # 50o
        fm      $top_t_4,$vy_5,$weight_3                # 51e
        lqd     $vx_8,192($a_packet_3)                  # 51o
        fm      $top_5,$vx_5,$weight_3                  # 52e
        lqd     $vz_9,368($a_packet_2)                  # 52o
        fm      $most_3,$vz_5,$weight_3                 # 53e
        lqd     $vy,304($a_packet_2)                    # 53o
        and     $weight1_3,$there1_3,$k_along           # 54e
        shufb   $t_words3_2,$top_t_3,$t_odd,$m_last     # 54o
        cgti    $there2_2,$t_6,-1                       # 55e
        shufb   $t_words1_2,$top_t_3,$t_odd,$m_first    # 55o
        cgti    $there_3,$t_7,-1                        # 56e
        shufb   $t_words2_2,$top_4,$most,$m_last        # 56o
        fma     $top_t_5,$vy_3,$weight1_3,$top_t_4      # 57e
        shufb   $t_words_2,$top_4,$most,$m_first        # 57o
        fma     $top_5,$vx_6,$weight1_3,$top_5          # 58e
        lqd     $vx_9,240($a_packet_2)                  # 58o
        fma     $most,$vz_6,$weight1_3,$most_3          # 59e
        lqd     $t_9,400($a_packet_3)                   # 59o
        and     $weight2_3,$there2_2,$k_along           # 60e
        shufb   $t_rows+3,$t_words2_2,$t_words3_2,$m_last # 60o
        cgti    $there3_3,$t_8,-1                       # 61e
        shufb   $t_rows1_2,$t_words_2,$t_words1_2,$m_last # 61o
        and     $weight_4,$there_3,$k_along             # 62e
        shufb   $t_rows_2,$t_words_2,$t_words1_2,$m_first # 62o
        fma     $top_t_3,$vy_6,$weight2_3,$top_t_5      # 63e
        shufb   $t_rows+2,$t_words2_2,$t_words3_2,$m_first # 63o
        fma     $top_5,$vx_7,$weight2_3,$top_5          # 64e
        lqd     $vz_10,336($a_packet_3)                 # 64o
        fma     $most,$vz_7,$weight2_3,$most            # 65e
        lqd     $vx_3,208($a_packet_3)                  # 65o
        fa      $t_rows_3,$t_rows_2,$t_rows1_2          # 66e
        lqd     $vy_8,272($a_packet_3)                  # 66o
        fa      $t_rows+2,$t_rows+2,$t_rows+3           # 67e
        lqd     $t_10,416($a_packet_3)                  # 67o
        and     $weight3_3,$there3_3,$k_along           # 68e
        lqd     $vx_10,224($a_packet_3)                 # 68o
        fm      $top_t_6,$vy_7,$weight_4                # 69e
        lqd     $vz_11,352($a_packet_3)                 # 69o
        fm      $top_6,$vx_8,$weight_4                  # 70e
        lqd     $vy_9,288($a_packet_3)                  # 70o
        fm      $most_4,$vz_8,$weight_4                 # 71e
        lqd     $t_11,432($a_packet_3)                  # 71o
        fma     $top_t_3,$vy,$weight3_3,$top_t_3        # 72e
        lqd     $t_12,384($a_packet_4)                  # 72o
        fa      $t_rows_4,$t_rows_3,$t_rows+2           # 73e
        lqd     $vz_12,368($a_packet_3)                 # 73o
        fma     $top_7,$vx_9,$weight3_3,$top_5          # 74e
        lqd     $vy_10,304($a_packet_3)                 # 74o
        fma     $most,$vz_9,$weight3_3,$most            # 75e
        lqd     $vx_11,240($a_packet_3)                 # 75o
        cgti    $there1_4,$t_9,-1                       # 76e
        lqd     $vz_13,320($a_packet_4)                 # 76o
        cgti    $there2_3,$t_10,-1                      # 77e
        lqd     $vy_11,256($a_packet_4)                 # 77o
        and     $weight1_4,$there1_4,$k_along           # 78e
        shufb   $t_words+3,$top_t_3,$t_odd,$m_last      # 78o
        fm      $length_2,$t_rows_4,$t_rows_4           # 79e
        shufb   $t_words1_2,$top_t_3,$t_odd,$m_first    # 79o
        fma     $top_t_7,$vy_8,$weight1_4,$top_t_6      # 80e
        lqd     $vx_12,192($a_packet_4)                 # 80o
        fma     $top_8,$vx_3,$weight1_4,$top_6          # 81e
        shufb   $t_words2_3,$top_7,$most,$m_last        # 81o
        fma     $most_4,$vz_10,$weight1_4,$most_4       # 82e
        shufb   $t_words_3,$top_7,$most,$m_first        # 82o
        and     $weight+2,$there2_3,$k_along            # 83e
        lqd     $t_3,400($a_packet_4)                   # 83o
        cgti    $there3_4,$t_11,-1                      # 84e
        lqd     $vz_14,336($a_packet_4)                 # 84o
        cgti    $there_4,$t_12,-1                       # 85e
        rotqbyi $t_y_2,$length_2,4                      # 85o
        fma     $top_t,$vy_9,$weight+2,$top_t_7         # 86e
        rotqbyi $t_e_2,$length_2,8                      # 86o
        fma     $top_8,$vx_10,$weight+2,$top_8          # 87e
        shufb   $t_rows+3,$t_words2_3,$t_words+3,$m_last # 87o
        fma     $most_4,$vz_11,$weight+2,$most_4        # 88e
        shufb   $t_rows+1,$t_words_3,$t_words1_2,$m_last # 88o
        fa      $length,$length_2,$t_y_2                # 89e
        shufb   $t_rows_5,$t_words_3,$t_words1_2,$m_first # 89o
        and     $weight+3,$there3_4,$k_along            # 90e
        shufb   $t_rows+2,$t_words2_3,$t_words+3,$m_first # 90o
        and     $weight,$there_4,$k_along               # 91e
        lqd     $vx_13,208($a_packet_4)                 # 91o
        fma     $top_t,$vy_10,$weight+3,$top_t          # 92e
        lqd     $vy_10,272($a_packet_4)                 # 92o
        fa      $t_rows_5,$t_rows_5,$t_rows+1           # 93e
        hbrr    next_axis_back,next_axis                # 93o hint
        fa      $t_rows+2,$t_rows+2,$t_rows+3           # 94e
        lqd     $t_12,416($a_packet_4)                  # 94o
        fa      $length,$length,$t_e_2                  # 95e
        lqd     $vx_4,224($a_packet_4)                  # 95o
        fma     $top,$vx_11,$weight+3,$top_8            # 96e
        lqd     $vz_15,352($a_packet_4)                 # 96o
        fma     $most_5,$vz_12,$weight+3,$most_4        # 97e
        lqd     $vy_3,288($a_packet_4)                  # 97o
        fm      $top_t_8,$vy_11,$weight                 # 98e
        shufb   $t_words+3,$top_t,$t_odd,$m_last        # 98o
        fm      $top_9,$vx_12,$weight                   # 99e
        shufb   $t_words+1,$top_t,$t_odd,$m_first       # 99o
        fm      $most_6,$vz_13,$weight                  # 100e
        lqd     $t_13,432($a_packet_4)                  # 100o
        cgti    $there1_5,$t_3,-1                       # 101e
        shufb   $length,$length,$length,$m_x            # 101o
        fa      $t_rows,$t_rows_5,$t_rows+2             # 102e
        lqd     $vz_6,368($a_packet_4)                  # 102o
        and     $weight1_5,$there1_5,$k_along           # 103e
        shufb   $t_words+2,$top,$most_5,$m_last         # 103o
        cgti    $there+2,$t_12,-1                       # 104e
        shufb   $t_words_4,$top,$most_5,$m_first        # 104o
        fma     $top_t,$vy_10,$weight1_5,$top_t_8       # 105e
        frsqest $t_y,$length                            # 105o
        fma     $top_5,$vx_13,$weight1_5,$top_9         # 106e
        lqd     $vy_12,304($a_packet_4)                 # 106o
        fma     $most,$vz_14,$weight1_5,$most_6         # 107e
        shufb   $t_rows+3,$t_words+2,$t_words+3,$m_last # 107o
        fm      $length_3,$t_rows,$t_rows               # 108e
        shufb   $t_rows+1,$t_words_4,$t_words+1,$m_last # 108o
        fi      $t_y,$length,$t_y                       # 109e
        shufb   $t_rows_6,$t_words_4,$t_words+1,$m_first # 109o
        and     $weight+2,$there+2,$k_along             # 110e
        shufb   $t_rows+2,$t_words+2,$t_words+3,$m_first # 110o
        fcgt    $c_short,$k_short,$length               # 111e
        lqd     $vx_14,240($a_packet_4)                 # 111o
        fma     $top_t,$vy_3,$weight+2,$top_t           # 112e
        shlqbyi $t_rows_4,$t_rows_4,0                   # 112o copy
        fma     $top_10,$vx_4,$weight+2,$top_5          # 113e
        stqd    $c_short,192($a_bound)                  # 113o
        fa      $t_rows_3,$t_rows_6,$t_rows+1           # 114e
        rotqbyi $t_y_3,$length_3,4                      # 114o
        fma     $most,$vz_15,$weight+2,$most            # 115e
        rotqbyi $t_e_3,$length_3,8                      # 115o
        fa      $t_rows+2,$t_rows+2,$t_rows+3           # 116e
        fm      $t_e,$length,$t_y                       # 117e
        ai      $a_packet_2,$a_packet_4,320             # 118e
        cgti    $there+3,$t_13,-1                       # 119e
        ai      $a_packet,$a_packet_2,320               # 120e
        and     $weight+3,$there+3,$k_along             # 121e
        ai      $count,$count,-1                        # 122e
        lnop                                            # 122o pairing
next_axis:
            fma     $top_t,$vy_12,$weight+3,$top_t      # 0e
            lnop                                        # 0o pairing
        ai      $a_packet_2,$a_packet,320               # 1e
        lqd     $t,432($a_packet)                       # 1o
            fa      $length,$length_3,$t_y_3            # 2e
        lqd     $vz,336($a_packet)                      # 2o
            fma     $top,$vx_14,$weight+3,$top_10       # 3e
        lqd     $t_14,416($a_packet)                    # 3o
            fma     $most,$vz_6,$weight+3,$most         # 4e
        lqd     $vz_2,320($a_packet)                    # 4o
            fm      $inverse,$t_y,$k_half               # 5e
        lqd     $t_2,384($a_packet)                     # 5o
            fnms    $t_e,$t_e,$t_y,$k_one               # 6e
        lqd     $vy,256($a_packet)                      # 6o
        cgti    $there+3,$t,-1                          # 7e
        lqd     $vx,192($a_packet)                      # 7o
            fa      $length,$length,$t_e_3              # 8e
        lqd     $t,400($a_packet)                       # 8o
        cgti    $there+2,$t_14,-1                       # 9e
        lqd     $vx_11,224($a_packet)                   # 9o
        and     $weight+3,$there+3,$k_along             # 10e
        lqd     $vx_2,208($a_packet)                    # 10o
        cgti    $there,$t_2,-1                          # 11e
        lqd     $vz_16,352($a_packet)                   # 11o
            fma     $inverse,$t_e,$inverse,$t_y         # 12e
        lqd     $vy_2,272($a_packet)                    # 12o
        and     $weight+2,$there+2,$k_along             # 13e
        lqd     $vy_13,288($a_packet)                   # 13o
        and     $weight_2,$there,$k_along               # 14e
            shufb   $length,$length,$length,$m_x        # 14o
        cgti    $there1_6,$t,-1                         # 15e
        lqd     $vz_6,368($a_packet)                    # 15o
        fm      $top_t_2,$vy,$weight_2                  # 16e
        lqd     $vy_12,304($a_packet)                   # 16o
        fm      $top_2,$vx,$weight_2                    # 17e
            shufb   $t_words+3,$top_t,$t_odd,$m_last    # 17o
            fcgt    $c_short,$k_short,$length           # 18e
            shufb   $t_words+1,$top_t,$t_odd,$m_first   # 18o
            fm      $axis,$t_rows_4,$inverse            # 19e
            shlqbyi $t_rows_4,$t_rows,0                 # 19o copy
            fa      $t_rows,$t_rows_3,$t_rows+2         # 20e
            shufb   $t_words+2,$top,$most,$m_last       # 20o
        fm      $most_2,$vz_2,$weight_2                 # 21e
            shufb   $t_words_5,$top,$most,$m_first      # 21o
        and     $weight+1,$there1_6,$k_along            # 22e
        lqd     $vx_14,240($a_packet)                   # 22o
        ai      $a_packet,$a_packet_2,320               # 23e
            frsqest $t_y,$length                        # 23o
        fma     $top_t,$vy_2,$weight+1,$top_t_2         # 24e
            shufb   $t_rows+3,$t_words+2,$t_words+3,$m_last # 24o
        fma     $top_7,$vx_2,$weight+1,$top_2           # 25e
            stqd    $axis,176($a_bound)                 # 25o
            ai      $a_bound,$a_bound,208               # 26e
            shufb   $t_rows+1,$t_words_5,$t_words+1,$m_last # 26o
            fm      $length_3,$t_rows,$t_rows           # 27e
            shufb   $t_rows_6,$t_words_5,$t_words+1,$m_first # 27o
        fma     $most,$vz,$weight+1,$most_2             # 28e
            shufb   $t_rows+2,$t_words+2,$t_words+3,$m_first # 28o
            fi      $t_y,$length,$t_y                   # 29e
            stqd    $c_short,192($a_bound)              # 29o
        ai      $count,$count,-1                        # 30e
        fma     $top_t,$vy_13,$weight+2,$top_t          # 31e
        fma     $top_10,$vx_11,$weight+2,$top_7         # 32e
        lnop                                            # 32o pairing
            fa      $t_rows_3,$t_rows_6,$t_rows+1       # 33e
            rotqbyi $t_y_3,$length_3,4                  # 33o
        fma     $most,$vz_16,$weight+2,$most            # 34e
            rotqbyi $t_e_3,$length_3,8                  # 34o
            fa      $t_rows+2,$t_rows+2,$t_rows+3       # 35e
            lnop                                        # 35o pairing
            fm      $t_e,$length,$t_y                   # 36e
next_axis_back:
        brnz    $count,next_axis                        # 36o
next_axis_drain:
        fma     $top_t,$vy_12,$weight+3,$top_t          # 0e
        shlqbyi $t_rows_5,$t_rows,0                     # 0o copy
        fma     $top,$vx_14,$weight+3,$top_10           # 1e
        fma     $most,$vz_6,$weight+3,$most             # 2e
        fa      $t_rows,$t_rows_3,$t_rows+2             # 3e
        fa      $length,$length_3,$t_y_3                # 4e
        fnms    $t_e,$t_e,$t_y,$k_one                   # 5e
        lnop                                            # 5o pairing
        fm      $inverse,$t_y,$k_half                   # 6e
        shufb   $t_words+3,$top_t,$t_odd,$m_last        # 6o
        ai      $a_bound_2,$a_bound,208                 # 7e
        shufb   $t_words+1,$top_t,$t_odd,$m_first       # 7o
        nop     $127                                    # 8e pairing
        shufb   $t_words_5,$top,$most,$m_first          # 8o
        fm      $length_3,$t_rows,$t_rows               # 9e
        shufb   $t_words+2,$top,$most,$m_last           # 9o
        fa      $length,$length,$t_e_3                  # 10e
        shlqbyi $t_rows_7,$t_rows,0                     # 10o copy
        ai      $a_bound_3,$a_bound_2,208               # 11e
        lnop                                            # 11o pairing
        fma     $inverse,$t_e,$inverse,$t_y             # 12e
        shufb   $t_rows+1,$t_words_5,$t_words+1,$m_last # 12o
        ai      $a_bound_4,$a_bound_3,208               # 13e
        shufb   $t_rows+2,$t_words+2,$t_words+3,$m_first # 13o
        nop     $127                                    # 14e pairing
        shufb   $t_rows+3,$t_words+2,$t_words+3,$m_last # 14o
        ai      $a_bound_5,$a_bound_4,208               # 15e
        shufb   $t_rows_6,$t_words_5,$t_words+1,$m_first # 15o
        rotqbyi $t_y_4,$length_3,4                      # 16o
        shufb   $length,$length,$length,$m_x            # 17o
        fa      $t_rows+2,$t_rows+2,$t_rows+3           # 18e
        rotqbyi $t_e_3,$length_3,8                      # 18o
        fa      $t_rows_3,$t_rows_6,$t_rows+1           # 19e
        fa      $length_4,$length_3,$t_y_4              # 20e
        fm      $axis,$t_rows_4,$inverse                # 21e
        frsqest $t_y,$length                            # 21o
        fcgt    $c_short,$k_short,$length               # 22e
        fa      $t_rows,$t_rows_3,$t_rows+2             # 25e
        fi      $t_y,$length,$t_y                       # 26e
        stqd    $axis,176($a_bound)                     # 27o
        fa      $length_5,$length_4,$t_e_3              # 28e
        stqd    $c_short,192($a_bound_2)                # 28o
        fm      $length_3,$t_rows,$t_rows               # 31e
        shlqbyi $t_rows_4,$t_rows,0                     # 31o copy
        fm      $t_e,$length,$t_y                       # 33e
        lnop                                            # 33o pairing
        fm      $inverse,$t_y,$k_half                   # 34e
        shufb   $length,$length_5,$length_5,$m_x        # 34o
        nop     $127                                    # 35e pairing
        rotqbyi $t_y_5,$length_3,4                      # 37o
        fcgt    $c_short,$k_short,$length               # 38e
        rotqbyi $t_e_3,$length_3,8                      # 38o
        fnms    $t_e,$t_e,$t_y,$k_one                   # 39e
        frsqest $t_y_4,$length                          # 39o
        fa      $length_5,$length_3,$t_y_5              # 41e
        fi      $t_y_4,$length,$t_y_4                   # 43e
        fma     $inverse,$t_e,$inverse,$t_y             # 45e
        fa      $length_5,$length_5,$t_e_3              # 47e
        fm      $t_e,$length,$t_y_4                     # 50e
        fm      $inverse_2,$t_y_4,$k_half               # 51e
        fm      $axis,$t_rows_5,$inverse                # 52e
        shufb   $length,$length_5,$length_5,$m_x        # 53o
        fnms    $t_e,$t_e,$t_y_4,$k_one                 # 56e
        lnop                                            # 56o pairing
        fcgt    $c_short_2,$k_short,$length             # 57e
        frsqest $t_y,$length                            # 57o
        stqd    $axis,176($a_bound_2)                   # 58o
        stqd    $c_short,192($a_bound_3)                # 59o
        fi      $t_y,$length,$t_y                       # 61e
        fma     $inverse,$t_e,$inverse_2,$t_y_4         # 63e
        fm      $t_e,$length,$t_y                       # 68e
        fm      $inverse_3,$t_y,$k_half                 # 69e
        fm      $axis,$t_rows_7,$inverse                # 70e
        fnms    $t_e,$t_e,$t_y,$k_one                   # 74e
        stqd    $axis,176($a_bound_3)                   # 76o
        stqd    $c_short_2,192($a_bound_4)              # 77o
        fma     $inverse,$t_e,$inverse_3,$t_y           # 80e
        fm      $axis,$t_rows_4,$inverse                # 86e
        nop     $127                                    # 87e pairing
        stqd    $axis,176($a_bound_4)                   # 92o
bound_fan_r16_block:
        ori     $count,$packets,0                       # 0e
        ori     $a_packet,$a_first,0                    # 1e
        clgti   $count_2,$count,3                       # 2e at least as many passes as overlap
        ori     $a_bound,$a_first_bound,0               # 3e
        nop     $127                                    # 4e pairing
        brz     $count_2,next_cone_short                # 4o too few passes
        ai      $a_bound_4,$a_bound,208                 # 5e
        lqd     $axis_2,176($a_bound)                   # 5o
        ai      $a_packet_2,$a_packet,320               # 6e
        lqd     $vx_15,192($a_packet)                   # 6o
        ai      $count,$count,-1                        # 7e
        lqd     $vx_16,208($a_packet)                   # 7o
        ai      $a_packet_2,$a_packet_2,320             # 8e
        lqd     $vx,224($a_packet)                      # 8o
        ai      $count,$count,-1                        # 9e
        lqd     $vy,272($a_packet)                      # 9o
        ai      $a_packet_3,$a_packet_2,320             # 10e
        lqd     $vy_14,256($a_packet)                   # 10o
        ai      $count,$count,-1                        # 11e
        shufb   $axis_x,$axis_2,$axis_2,$m_x            # 11o
        ai      $a_packet_5,$a_packet_3,320             # 12e
        lqd     $vx_17,240($a_packet)                   # 12o
        nop     $127                                    # 13e pairing
        lqd     $top_t,384($a_packet)                   # 13o
        ai      $a_packet_4,$a_packet_5,320             # 14e
        lqd     $t,400($a_packet)                       # 14o
        fms     $vx_13,$vx_15,$k_along,$axis_x          # 15e
        lqd     $vz_15,320($a_packet)                   # 15o
        fms     $vx_11,$vx_16,$k_along,$axis_x          # 16e
        lqd     $vz_17,352($a_packet)                   # 16o
        fms     $vx,$vx,$k_along,$axis_x                # 17e
        lqd     $vz_18,368($a_packet)                   # 17o
        fms     $vx_17,$vx_17,$k_along,$axis_x          # 18e
        lqd     $t_15,432($a_packet)                    # 18o
        cgti    $there_5,$top_t,-1                      # 19e
        lqd     $t_5,416($a_packet)                     # 19o
        cgti    $there1_7,$t,-1                         # 20e
        lqd     $vz_19,336($a_packet)                   # 20o
        fm      $squared_2,$vx_13,$vx_13                # 21e
        lqd     $vy_15,304($a_packet)                   # 21o
        fm      $squared_3,$vx_11,$vx_11                # 22e
        shufb   $axis_y,$axis_2,$axis_2,$m_y            # 22o
        fm      $squared,$vx,$vx                        # 23e
        stqd    $apex_y,16($a_bound)                    # 23o
        fm      $squared_4,$vx_17,$vx_17                # 24e
        lqd     $vy_8,288($a_packet)                    # 24o
        fcgt    $c_greater,$top_t,$t                    # 25e
        shufb   $axis_z,$axis_2,$axis_2,$m_z            # 25o
        fms     $vy_4,$vy,$k_along,$axis_y              # 26e
        stqd    $apex_z,32($a_bound)                    # 26o
        fms     $vy_16,$vy_14,$k_along,$axis_y          # 27e
        stqd    $apex,160($a_bound)                     # 27o
        fms     $vy_17,$vy_15,$k_along,$axis_y          # 28e
        stqd    $apex_x,0($a_bound)                     # 28o
        fms     $vz_20,$vz_15,$k_along,$axis_z          # 29e
        lqd     $axis_3,176($a_bound_4)                 # 29o
        fms     $vy_8,$vy_8,$k_along,$axis_y            # 30e
        lqd     $vx_3,192($a_packet_2)                  # 30o
        fms     $vz_21,$vz_19,$k_along,$axis_z          # 31e
        lqd     $vx_16,208($a_packet_2)                 # 31o
        fma     $squared_3,$vy_4,$vy_4,$squared_3       # 32e
        lqd     $vx,224($a_packet_2)                    # 32o
        fma     $squared_2,$vy_16,$vy_16,$squared_2     # 33e
        lqd     $vy,272($a_packet_2)                    # 33o
        fms     $vz_22,$vz_17,$k_along,$axis_z          # 34e
        lqd     $vy_7,256($a_packet_2)                  # 34o
        fms     $vz_17,$vz_18,$k_along,$axis_z          # 35e
        shufb   $axis_x,$axis_3,$axis_3,$m_x            # 35o
        fma     $squared,$vy_8,$vy_8,$squared           # 36e
        lqd     $vx_4,240($a_packet_2)                  # 36o
        fma     $squared_4,$vy_17,$vy_17,$squared_4     # 37e
        lqd     $top_t_9,384($a_packet_2)               # 37o
        fma     $squared_3,$vz_21,$vz_21,$squared_3     # 38e
        lqd     $t_8,400($a_packet_2)                   # 38o
        fma     $squared_2,$vz_20,$vz_20,$squared_2     # 39e
        lqd     $vz_14,320($a_packet_2)                 # 39o
        cgti    $there2_4,$t_5,-1                       # 40e
        lqd     $vz_18,352($a_packet_2)                 # 40o
        selb    $top_t_10,$t,$top_t,$c_greater          # 41e
        lqd     $vz_7,368($a_packet_2)                  # 41o
        fma     $squared,$vz_22,$vz_22,$squared         # 42e
        lqd     $t_16,432($a_packet_2)                  # 42o
        fma     $squared_4,$vz_17,$vz_17,$squared_4     # 43e
        lqd     $t_10,416($a_packet_2)                  # 43o
        and     $squared_3,$squared_3,$there1_7         # 44e
        lqd     $vz_23,336($a_packet_2)                 # 44o
        and     $top_3,$squared_2,$there_5              # 45e
        lqd     $c_short,192($a_bound)                  # 45o
        fcgt    $c_greater,$top_t_10,$t_5               # 46e
        lqd     $vy_15,304($a_packet_2)                 # 46o
        fcgt    $c_greater_2,$top_3,$squared_3          # 47e
        shufb   $axis_y,$axis_3,$axis_3,$m_y            # 47o
        and     $squared,$squared,$there2_4             # 48e
        stqd    $apex_y,16($a_bound_4)                  # 48o
        selb    $top_3,$squared_3,$top_3,$c_greater_2   # 49e
        lqd     $vy_18,288($a_packet_2)                 # 49o
        cgti    $there3_5,$t_15,-1                      # 50e
        shufb   $axis_z,$axis_3,$axis_3,$m_z            # 50o
        fcgt    $c_greater_3,$top_3,$squared            # 51e
        shlqbyi $axis_2,$axis_2,0                       # 51o copy
        selb    $top_t_11,$t_5,$top_t_10,$c_greater     # 52e
        shlqbyi $a_bound_6,$a_bound,0                   # 52o copy
        and     $squared_4,$squared_4,$there3_5         # 53e
        stqd    $apex_z,32($a_bound_4)                  # 53o
        selb    $top_7,$squared,$top_3,$c_greater_3     # 54e
        shlqbyi $a_bound_7,$a_bound,0                   # 54o copy
        fcgt    $c_greater,$top_t_11,$t_15              # 55e
        stqd    $apex,160($a_bound_4)                   # 55o
        fcgt    $c_greater_4,$top_7,$squared_4          # 56e
        stqd    $apex_x,0($a_bound_4)                   # 56o
        selb    $top_t_12,$t_15,$top_t_11,$c_greater    # 57e
        shlqbyi $a_bound_8,$a_bound,0                   # 57o copy
        selb    $top_7,$squared_4,$top_7,$c_greater_4   # 58e
        shlqbyi $a_bound_9,$a_bound,0                   # 58o copy
        fms     $vx_2,$vx_3,$k_along,$axis_x            # 59e
        shlqbyi $a_bound_10,$a_bound,0                  # 59o copy
        fms     $vx_18,$vx_16,$k_along,$axis_x          # 60e
        shufb   $t_odd_2,$top_7,$top_t_12,$m_odd        # 60o
        fms     $vx,$vx,$k_along,$axis_x                # 61e
        shufb   $most_7,$top_7,$top_t_12,$m_even        # 61o
        fms     $vy,$vy,$k_along,$axis_y                # 62e
        shlqbyi $a_bound_11,$a_bound,0                  # 62o copy
        fms     $vy_19,$vy_7,$k_along,$axis_y           # 63e
        shlqbyi $a_bound_12,$a_bound_10,0               # 63o copy
        fms     $vx_4,$vx_4,$k_along,$axis_x            # 64e
        shlqbyi $axis_4,$axis_3,0                       # 64o copy
        fcgt    $c_greater_5,$most_7,$t_odd_2           # 65e
        shlqbyi $a_bound_13,$a_bound_4,0                # 65o copy
        fm      $squared_5,$vx_2,$vx_2                  # 66e
        shlqbyi $a_bound_14,$a_bound_9,0                # 66o copy
        selb    $most_8,$t_odd_2,$most_7,$c_greater_5   # 67e
        shlqbyi $a_bound_9,$a_bound_4,0                 # 67o copy
        fm      $squared_4,$vx_18,$vx_18                # 68e
        shlqbyi $a_bound_10,$a_bound_4,0                # 68o copy
        fms     $vy_18,$vy_18,$k_along,$axis_y          # 69e
        rotqbyi $t_odd_2,$most_8,8                      # 69o
        fm      $squared_6,$vx,$vx                      # 70e
        shlqbyi $a_bound_15,$a_bound_11,0               # 70o copy
        fms     $vz_20,$vz_14,$k_along,$axis_z          # 71e
        shlqbyi $a_bound_11,$a_bound_4,0                # 71o copy
        fms     $vz_21,$vz_23,$k_along,$axis_z          # 72e
        shlqbyi $a_bound_16,$a_bound_4,0                # 72o copy
        fcgt    $c_greater,$most_8,$t_odd_2             # 73e
        shlqbyi $a_bound_17,$a_bound_4,0                # 73o copy
        fma     $squared_7,$vy_19,$vy_19,$squared_5     # 74e
        selb    $most,$t_odd_2,$most_8,$c_greater       # 75e
        fma     $squared_8,$vy,$vy,$squared_4           # 76e
        lnop                                            # 76o pairing
        fm      $t_y_6,$most,$k_quarter                 # 77e
        shufb   $t_6,$most,$most,$m_y                   # 77o
        fm      $squared_9,$vx_4,$vx_4                  # 78e
        fms     $vy,$vy_15,$k_along,$axis_y             # 79e
        fcgt    $c_wide,$most,$k_wide                   # 80e
        lnop                                            # 80o pairing
        fms     $vz,$vz_18,$k_along,$axis_z             # 81e
        stqd    $t_6,144($a_bound_6)                    # 81o
        fma     $squared_6,$vy_18,$vy_18,$squared_6     # 82e
        lqd     $vy_12,272($a_packet_5)                 # 82o
        fnms    $t_17,$t_y_6,$most,$most                # 83e
        lqd     $vx_19,240($a_packet_5)                 # 83o
        or      $c_wide,$c_wide,$c_short                # 84e
        lqd     $vx_20,192($a_packet_5)                 # 84o
        fma     $squared_7,$vz_20,$vz_20,$squared_7     # 85e
        lqd     $vy_20,256($a_packet_5)                 # 85o
        fma     $squared_8,$vz_21,$vz_21,$squared_8     # 86e
        shufb   $c_wide_2,$c_wide,$c_wide,$m_x          # 86o
        fms     $vz_7,$vz_7,$k_along,$axis_z            # 87e
        lqd     $vx_21,224($a_packet_5)                 # 87o
        fma     $squared_9,$vy,$vy,$squared_9           # 88e
        lqd     $top_t_2,384($a_packet_5)               # 88o
        cgti    $there1_7,$t_8,-1                       # 89e
        frsqest $t_y_7,$t_17                            # 89o
        cgti    $there_5,$top_t_9,-1                    # 90e
        lqd     $t_18,400($a_packet_5)                  # 90o
        fnms    $cosine,$most,$k_chord,$k_cosine        # 91e
        lqd     $vz_20,320($a_packet_5)                 # 91o
        fma     $squared_6,$vz,$vz,$squared_6           # 92e
        fi      $t_y_8,$t_17,$t_y_7                     # 93e
        andc    $axis_2,$axis_2,$c_wide_2               # 94e
        and     $top_11,$squared_7,$there_5             # 95e
        and     $squared_8,$squared_8,$there1_7         # 96e
        shufb   $out,$axis_2,$axis_2,$m_y               # 96o
        fcgt    $c_greater_6,$top_t_9,$t_8              # 97e
        shufb   $out_2,$axis_2,$axis_2,$m_x             # 97o
        cgti    $there2_5,$t_10,-1                      # 98e
        stqd    $axis_2,176($a_bound_7)                 # 98o
        fma     $squared_9,$vz_7,$vz_7,$squared_9       # 99e
        lqd     $vz_6,352($a_packet_5)                  # 99o
        fm      $t_e_4,$t_17,$t_y_8                     # 100e
        shufb   $out_3,$axis_2,$axis_2,$m_z             # 100o
        fcgt    $c_greater_7,$top_11,$squared_8         # 101e
        stqd    $out,64($a_bound_8)                     # 101o
        selb    $top_t_13,$t_8,$top_t_9,$c_greater_6    # 102e
        lqd     $vz_18,368($a_packet_5)                 # 102o
        andc    $cosine,$cosine,$c_wide_2               # 103e
        lqd     $t_19,432($a_packet_5)                  # 103o
        and     $squared_10,$squared_6,$there2_5        # 104e
        lqd     $t_13,416($a_packet_5)                  # 104o
        selb    $top_11,$squared_8,$top_11,$c_greater_7 # 105e
        shufb   $out_4,$cosine,$cosine,$m_x             # 105o
        fcgt    $c_greater_8,$top_t_13,$t_10            # 106e
        stqd    $out_2,48($a_bound_8)                   # 106o
        cgti    $there3_5,$t_16,-1                      # 107e
        stqd    $out_3,80($a_bound_8)                   # 107o
        fm      $t_y_8,$t_y_8,$k_half                   # 108e
        lqd     $vz_21,336($a_packet_5)                 # 108o
        fcgt    $c_greater_9,$top_11,$squared_10        # 109e
        stqd    $out_4,96($a_bound_8)                   # 109o
        fnms    $root_2,$t_e_4,$t_e_4,$t_17             # 110e
        lqd     $c_short,192($a_bound_4)                # 110o
        selb    $top_t_14,$t_10,$top_t_13,$c_greater_8  # 111e
        lqd     $vx_16,208($a_packet_5)                 # 111o
        fcgt    $c_greater_10,$top_t_2,$t_18            # 112e
        lqd     $vy_15,304($a_packet_5)                 # 112o
        and     $squared_9,$squared_9,$there3_5         # 113e
        selb    $top,$squared_10,$top_11,$c_greater_9   # 114e
        fcgt    $c_greater_9,$top_t_14,$t_16            # 115e
        selb    $top_t_13,$t_18,$top_t_2,$c_greater_10  # 116e
        fcgt    $c_greater_10,$top,$squared_9           # 117e
        ai      $a_bound,$a_bound_4,208                 # 118e
        selb    $top_t_15,$t_16,$top_t_14,$c_greater_9  # 119e
        lnop                                            # 119o pairing
        rotmai  $none,$t_6,-31                          # 120e
        lqd     $axis_2,176($a_bound)                   # 120o
        cgti    $there1_7,$t_18,-1                      # 121e
        stqd    $apex_y,16($a_bound)                    # 121o
        cgti    $there2_4,$t_13,-1                      # 122e
        lqd     $vy_21,288($a_packet_5)                 # 122o
        fcgt    $c_greater_11,$top_t_13,$t_13           # 123e
        hbrr    next_cone_back,next_cone                # 123o hint
        selb    $top,$squared_9,$top,$c_greater_10      # 124e
        stqd    $apex_z,32($a_bound)                    # 124o
        fma     $root_2,$root_2,$t_y_8,$t_e_4           # 125e
        stqd    $apex,160($a_bound)                     # 125o
        selb    $top_t_16,$t_13,$top_t_13,$c_greater_11 # 126e
        shufb   $t_odd_3,$top,$top_t_15,$m_odd          # 126o
        cgti    $there_5,$top_t_2,-1                    # 127e
        shufb   $most,$top,$top_t_15,$m_even            # 127o
        fcgt    $c_greater_5,$top_t_16,$t_19            # 128e
        shufb   $axis_z,$axis_2,$axis_2,$m_z            # 128o
        cgti    $there3_5,$t_19,-1                      # 129e
        shufb   $axis_y,$axis_2,$axis_2,$m_y            # 129o
        ai      $a_packet,$a_packet_4,320               # 130e
        shufb   $axis_x,$axis_2,$axis_2,$m_x            # 130o
        fcgt    $c_greater_12,$most,$t_odd_3            # 131e
        stqd    $apex_x,0($a_bound)                     # 131o
        fma     $limits,$root_2,$k_sine,$k_least        # 132e
        selb    $most,$t_odd_3,$most,$c_greater_12      # 133e
        fms     $vz_24,$vz_6,$k_along,$axis_z           # 134e
        lnop                                            # 134o pairing
        fms     $vz_20,$vz_20,$k_along,$axis_z          # 135e
        rotqbyi $t_odd_4,$most,8                        # 135o
        fms     $vy_21,$vy_21,$k_along,$axis_y          # 136e
        fms     $vy_4,$vy_12,$k_along,$axis_y           # 137e
        fms     $vx,$vx_21,$k_along,$axis_x             # 138e
        shufb   $t_y,$limits,$limits,$m_y               # 138o
        fms     $vx_3,$vx_19,$k_along,$axis_x           # 139e
        fms     $vx_13,$vx_20,$k_along,$axis_x          # 140e
        fms     $vy_3,$vy_20,$k_along,$axis_y           # 141e
        fms     $vz_21,$vz_21,$k_along,$axis_z          # 142e
        selb    $top_t_12,$t_19,$top_t_16,$c_greater_5  # 143e
        fcgt    $c_greater,$most,$t_odd_4               # 144e
next_cone:
            fm      $squared,$vx,$vx                    # 0e
            selb    $most,$t_odd_4,$most,$c_greater     # 1e
            or      $t_y,$t_y,$none                     # 2e all ones is the largest single below 0
            lnop                                        # 2o pairing
            fms     $vz,$vz_18,$k_along,$axis_z         # 3e
            shufb   $t,$most,$most,$m_y                 # 3o
            fcgt    $c_wide,$most,$k_wide               # 4e
            stqd    $t_y,128($a_bound_12)               # 4o
            andc    $limits,$limits,$c_wide_2           # 5e
            shlqbyi $a_bound_12,$a_bound_10,0           # 5o copy
            or      $c_wide,$c_wide,$c_short            # 6e
            lnop                                        # 6o pairing
            fma     $squared,$vy_21,$vy_21,$squared     # 7e
            stqd    $t,144($a_bound_17)                 # 7o
            fms     $vx,$vx_16,$k_along,$axis_x         # 8e
            shufb   $c_wide_2,$c_wide,$c_wide,$m_x      # 8o
        ai      $a_packet_6,$a_packet,320               # 9e
        lqd     $vy,272($a_packet)                      # 9o
            fm      $t_y_9,$most,$k_quarter             # 10e
        lqd     $vx_17,240($a_packet)                   # 10o
            or      $limits,$limits,$none               # 11e
        lqd     $vx_15,192($a_packet)                   # 11o
            andc    $axis,$axis_4,$c_wide_2             # 12e
        lqd     $vy_14,256($a_packet)                   # 12o
            fnms    $cosine,$most,$k_chord,$k_cosine    # 13e
            shlqbyi $axis_4,$axis_2,0                   # 13o copy
            fm      $squared_2,$vx_13,$vx_13            # 14e
            shufb   $out,$axis,$axis,$m_y               # 14o
            fm      $squared_11,$vx,$vx                 # 15e
            shufb   $out_5,$axis,$axis,$m_x             # 15o
            fnms    $t_20,$t_y_9,$most,$most            # 16e
        lqd     $vx,224($a_packet)                      # 16o
            rotmai  $none,$t,-31                        # 17e
        lqd     $top_t,384($a_packet)                   # 17o
            fma     $squared,$vz_24,$vz_24,$squared     # 18e
        lqd     $t,400($a_packet)                       # 18o
            fm      $squared_4,$vx_3,$vx_3              # 19e
        lqd     $vz_15,320($a_packet)                   # 19o
            fma     $squared_2,$vy_3,$vy_3,$squared_2   # 20e
            stqd    $axis,176($a_bound_13)              # 20o
            fms     $vy_17,$vy_15,$k_along,$axis_y      # 21e
        lqd     $vz_17,352($a_packet)                   # 21o
            fma     $squared_11,$vy_4,$vy_4,$squared_11 # 22e
            frsqest $t_y_10,$t_20                       # 22o
            andc    $cosine,$cosine,$c_wide_2           # 23e
            shlqbyi $a_bound_13,$a_bound,0              # 23o copy
        fcgt    $c_greater,$top_t,$t                    # 24e
            shufb   $limits,$limits,$limits,$m_x        # 24o
        ai      $count,$count,-1                        # 25e
            stqd    $out,64($a_bound_16)                # 25o
            fma     $squared_2,$vz_20,$vz_20,$squared_2 # 26e
        lqd     $vz_18,368($a_packet)                   # 26o
            fma     $squared_4,$vy_17,$vy_17,$squared_4 # 27e
        lqd     $t_9,432($a_packet)                     # 27o
            fma     $squared_11,$vz_21,$vz_21,$squared_11 # 28e
            stqd    $limits,112($a_bound_14)            # 28o
            fi      $t_y_10,$t_20,$t_y_10               # 29e
            shlqbyi $a_bound_14,$a_bound_9,0            # 29o copy
            and     $squared,$squared,$there2_4         # 30e
            shlqbyi $a_bound_9,$a_bound,0               # 30o copy
        selb    $top_t_13,$t,$top_t,$c_greater          # 31e
            shufb   $limits,$limits,$t_y,$m_even        # 31o
            and     $top_3,$squared_2,$there_5          # 32e
            shlqbyi $a_bound_10,$a_bound,0              # 32o copy
            fma     $squared_4,$vz,$vz,$squared_4       # 33e
            shufb   $out,$axis,$axis,$m_z               # 33o
            and     $squared_11,$squared_11,$there1_7   # 34e
        lqd     $t_5,416($a_packet)                     # 34o
        cgti    $there1_7,$t,-1                         # 35e
            stqd    $limits,192($a_bound_15)            # 35o
            fcgt    $c_greater,$top_3,$squared_11       # 36e
            shlqbyi $a_bound_15,$a_bound_11,0           # 36o copy
            fm      $t_e,$t_20,$t_y_10                  # 37e
            shlqbyi $a_bound_11,$a_bound,0              # 37o copy
            selb    $top_3,$squared_11,$top_3,$c_greater # 38e
            shufb   $out_3,$cosine,$cosine,$m_x         # 38o
            and     $squared_4,$squared_4,$there3_5     # 39e
            stqd    $out_5,48($a_bound_16)              # 39o
            fm      $t_y,$t_y_10,$k_half                # 40e
            stqd    $out,80($a_bound_16)                # 40o
            fcgt    $c_greater,$top_3,$squared          # 41e
        lqd     $vz_16,336($a_packet)                   # 41o
        cgti    $there2_4,$t_5,-1                       # 42e
            stqd    $out_3,96($a_bound_16)              # 42o
            selb    $top,$squared,$top_3,$c_greater     # 43e
            shlqbyi $a_bound_16,$a_bound,0              # 43o copy
        fcgt    $c_greater,$top_t_13,$t_5               # 44e
            shlqbyi $a_bound_17,$a_bound,0              # 44o copy
            fcgt    $c_greater_9,$top,$squared_4        # 45e
            lqd     $c_short,192($a_bound)              # 45o
            ai      $a_bound,$a_bound,208               # 46e
        lqd     $vx_16,208($a_packet)                   # 46o
            selb    $top,$squared_4,$top,$c_greater_9   # 47e
        lqd     $vy_15,304($a_packet)                   # 47o
            fnms    $root,$t_e,$t_e,$t_20               # 48e
        lqd     $axis_2,176($a_bound)                   # 48o
        selb    $top_t_17,$t_5,$top_t_13,$c_greater     # 49e
            shufb   $t_odd_3,$top,$top_t_12,$m_odd      # 49o
        cgti    $there_5,$top_t,-1                      # 50e
            shufb   $most,$top,$top_t_12,$m_even        # 50o
        cgti    $there3_5,$t_9,-1                       # 51e
        stqd    $apex_y,16($a_bound)                    # 51o
        fcgt    $c_greater,$top_t_17,$t_9               # 52e
        lqd     $vy_22,288($a_packet)                   # 52o
        ai      $a_packet,$a_packet_6,320               # 53e
        lnop                                            # 53o pairing
            fcgt    $c_greater_12,$most,$t_odd_3        # 54e
        shufb   $axis_z,$axis_2,$axis_2,$m_z            # 54o
            fma     $root,$root,$t_y,$t_e               # 55e
        shufb   $axis_y,$axis_2,$axis_2,$m_y            # 55o
            selb    $most,$t_odd_3,$most,$c_greater_12  # 56e
            lnop                                        # 56o pairing
        selb    $top_t_12,$t_9,$top_t_17,$c_greater     # 57e
        shufb   $axis_x,$axis_2,$axis_2,$m_x            # 57o
        fms     $vz_24,$vz_17,$k_along,$axis_z          # 58e
            rotqbyi $t_odd_4,$most,8                    # 58o
        fms     $vz_20,$vz_15,$k_along,$axis_z          # 59e
        stqd    $apex_z,32($a_bound)                    # 59o
        fms     $vy_21,$vy_22,$k_along,$axis_y          # 60e
        stqd    $apex,160($a_bound)                     # 60o
            fma     $limits,$root,$k_sine,$k_least      # 61e
        stqd    $apex_x,0($a_bound)                     # 61o
        fms     $vy_4,$vy,$k_along,$axis_y              # 62e
        fms     $vx,$vx,$k_along,$axis_x                # 63e
        fms     $vx_3,$vx_17,$k_along,$axis_x           # 64e
        fms     $vx_13,$vx_15,$k_along,$axis_x          # 65e
        fms     $vy_3,$vy_14,$k_along,$axis_y           # 66e
        lnop                                            # 66o pairing
        fms     $vz_21,$vz_16,$k_along,$axis_z          # 67e
            shufb   $t_y,$limits,$limits,$m_y           # 67o
            fcgt    $c_greater,$most,$t_odd_4           # 68e
next_cone_back:
        brnz    $count,next_cone                        # 68o
next_cone_drain:
        fms     $vx_4,$vx_16,$k_along,$axis_x           # 0e
        shlqbyi $axis_5,$axis_2,0                       # 0o copy
        fm      $squared_12,$vx_13,$vx_13               # 1e
        shlqbyi $a_bound_8,$a_bound_10,0                # 1o copy
        fm      $squared,$vx,$vx                        # 2e
        hbr     bound_fan_r16_return,$lr                # 2o hint
        fm      $squared_8,$vx_3,$vx_3                  # 3e
        shlqbyi $a_bound_18,$a_bound,0                  # 3o copy
        fms     $vy_17,$vy_15,$k_along,$axis_y          # 4e
        shlqbyi $a_bound_19,$a_bound,0                  # 4o copy
        fms     $vz,$vz_18,$k_along,$axis_z             # 5e
        shlqbyi $a_bound_20,$a_bound,0                  # 5o copy
        fm      $squared_9,$vx_4,$vx_4                  # 6e
        shlqbyi $a_bound_21,$a_bound_9,0                # 6o copy
        fma     $squared_12,$vy_3,$vy_3,$squared_12     # 7e
        shlqbyi $a_bound_10,$a_bound,0                  # 7o copy
        fma     $squared,$vy_21,$vy_21,$squared         # 8e
        shlqbyi $a_bound_22,$a_bound_11,0               # 8o copy
        selb    $most,$t_odd_4,$most,$c_greater         # 9e
        shlqbyi $a_bound_9,$a_bound,0                   # 9o copy
        fma     $squared_13,$vy_17,$vy_17,$squared_8    # 10e
        shlqbyi $a_bound_11,$a_bound,0                  # 10o copy
        fm      $t_y_11,$most,$k_quarter                # 11e
        shufb   $t,$most,$most,$m_y                     # 11o
        fma     $squared_9,$vy_4,$vy_4,$squared_9       # 12e
        shlqbyi $a_bound_23,$a_bound_10,0               # 12o copy
        fma     $squared_12,$vz_20,$vz_20,$squared_12   # 13e
        shlqbyi $a_bound_24,$a_bound_9,0                # 13o copy
        fma     $squared,$vz_24,$vz_24,$squared         # 14e
        shlqbyi $a_bound_25,$a_bound_11,0               # 14o copy
        fcgt    $c_wide,$most,$k_wide                   # 15e
        fma     $squared_13,$vz,$vz,$squared_13         # 16e
        fnms    $t_21,$t_y_11,$most,$most               # 17e
        fma     $squared_9,$vz_21,$vz_21,$squared_9     # 18e
        and     $top_12,$squared_12,$there_5            # 19e
        and     $squared,$squared,$there2_4             # 20e
        or      $c_wide,$c_wide,$c_short                # 21e
        and     $squared_13,$squared_13,$there3_5       # 22e
        andc    $limits,$limits,$c_wide_2               # 23e
        frsqest $t_y_10,$t_21                           # 23o
        and     $squared_9,$squared_9,$there1_7         # 24e
        shufb   $c_wide_2,$c_wide,$c_wide,$m_x          # 24o
        or      $limits,$limits,$none                   # 25e
        fcgt    $c_greater,$top_12,$squared_9           # 26e
        fi      $t_y_10,$t_21,$t_y_10                   # 27e
        shufb   $limits,$limits,$limits,$m_x            # 27o
        selb    $top_4,$squared_9,$top_12,$c_greater    # 28e
        fnms    $cosine,$most,$k_chord,$k_cosine        # 29e
        fcgt    $c_greater,$top_4,$squared              # 30e
        andc    $axis,$axis_4,$c_wide_2                 # 31e
        selb    $top_4,$squared,$top_4,$c_greater       # 32e
        lnop                                            # 32o pairing
        or      $t_y,$t_y,$none                         # 33e all ones is the largest single below 0
        shufb   $out,$axis,$axis,$m_y                   # 33o
        fcgt    $c_greater_11,$top_4,$squared_13        # 34e
        shufb   $out_6,$axis,$axis,$m_x                 # 34o
        fm      $t_e,$t_21,$t_y_10                      # 35e
        stqd    $t_y,128($a_bound_12)                   # 35o
        selb    $top_7,$squared_13,$top_4,$c_greater_11 # 36e
        stqd    $t,144($a_bound_17)                     # 36o
        fm      $t_y_12,$t_y_10,$k_half                 # 37e
        shufb   $limits_2,$limits,$t_y,$m_even          # 37o
        andc    $cosine,$cosine,$c_wide_2               # 38e
        shufb   $t_odd_5,$top_7,$top_t_12,$m_odd        # 38o
        rotmai  $none,$t,-31                            # 39e
        shufb   $most,$top_7,$top_t_12,$m_even          # 39o
        ai      $a_bound_12,$a_bound,208                # 40e
        stqd    $axis,176($a_bound_13)                  # 40o
        fnms    $root,$t_e,$t_e,$t_21                   # 41e
        stqd    $out,64($a_bound_16)                    # 41o
        nop     $127                                    # 42e pairing
        shufb   $out,$axis,$axis,$m_z                   # 42o
        fcgt    $c_greater_3,$most,$t_odd_5             # 43e
        stqd    $limits,112($a_bound_14)                # 43o
        nop     $127                                    # 44e pairing
        shufb   $out_4,$cosine,$cosine,$m_x             # 44o
        selb    $most,$t_odd_5,$most,$c_greater_3       # 45e
        stqd    $limits_2,192($a_bound_15)              # 45o
        nop     $127                                    # 46e pairing
        stqd    $out_6,48($a_bound_16)                  # 46o
        fma     $root,$root,$t_y_12,$t_e                # 47e
        rotqbyi $t_odd_4,$most,8                        # 47o
        stqd    $out,80($a_bound_16)                    # 48o
        stqd    $out_4,96($a_bound_16)                  # 49o
        lqd     $c_short,192($a_bound)                  # 50o
        fcgt    $c_greater,$most,$t_odd_4               # 51e
        selb    $most,$t_odd_4,$most,$c_greater         # 53e
        fma     $limits,$root,$k_sine,$k_least          # 54e
        fm      $t_y_13,$most,$k_quarter                # 55e
        shufb   $t,$most,$most,$m_y                     # 55o
        fcgt    $c_wide,$most,$k_wide                   # 56e
        fnms    $cosine,$most,$k_chord,$k_cosine        # 57e
        or      $c_wide,$c_wide,$c_short                # 58e
        rotmai  $none_2,$t,-31                          # 59e
        andc    $limits_3,$limits,$c_wide_2             # 60e
        shufb   $c_wide_2,$c_wide,$c_wide,$m_x          # 60o
        fnms    $t_22,$t_y_13,$most,$most               # 61e
        shufb   $t_y,$limits,$limits,$m_y               # 61o
        or      $limits,$limits_3,$none                 # 62e
        lnop                                            # 62o pairing
        andc    $axis,$axis_5,$c_wide_2                 # 64e
        shufb   $limits,$limits,$limits,$m_x            # 64o
        or      $t_y,$t_y,$none                         # 65e all ones is the largest single below 0
        lnop                                            # 65o pairing
        andc    $cosine,$cosine,$c_wide_2               # 66e
        shufb   $out,$axis,$axis,$m_y                   # 66o
        frsqest $t_y_10,$t_22                           # 67o
        stqd    $t_y,128($a_bound_8)                    # 68o
        stqd    $t,144($a_bound_18)                     # 69o
        shufb   $limits_4,$limits,$t_y,$m_even          # 70o
        fi      $t_y_10,$t_22,$t_y_10                   # 71e
        shufb   $out_7,$axis,$axis,$m_x                 # 71o
        stqd    $axis,176($a_bound_19)                  # 72o
        stqd    $out,64($a_bound_20)                    # 73o
        shufb   $out,$axis,$axis,$m_z                   # 74o
        stqd    $limits,112($a_bound_21)                # 75o
        shufb   $out_3,$cosine,$cosine,$m_x             # 76o
        stqd    $limits_4,192($a_bound_22)              # 77o
        fm      $t_e,$t_22,$t_y_10                      # 78e
        stqd    $out_7,48($a_bound_20)                  # 78o
        fm      $t_y,$t_y_10,$k_half                    # 79e
        stqd    $out,80($a_bound_20)                    # 79o
        stqd    $out_3,96($a_bound_20)                  # 80o
        fnms    $root,$t_e,$t_e,$t_22                   # 84e
        fma     $root,$root,$t_y,$t_e                   # 90e
        fma     $limits,$root,$k_sine,$k_least          # 96e
        andc    $limits_5,$limits,$c_wide_2             # 102e
        shufb   $t_y,$limits,$limits,$m_y               # 102o
        or      $limits,$limits_5,$none_2               # 104e
        lnop                                            # 104o pairing
        or      $t_y,$t_y,$none_2                       # 106e all ones is the largest single below
        shufb   $limits,$limits,$limits,$m_x            # 106o
        stqd    $t_y,128($a_bound_23)                   # 108o
        shufb   $limits_5,$limits,$t_y,$m_even          # 110o
        stqd    $limits,112($a_bound_24)                # 111o
        stqd    $limits_5,192($a_bound_25)              # 114o
        nop     $127                                    # 115e pairing
bound_fan_r16_return:
        bi      $lr                                     # 115o
next_axis_short:
        ai      $count,$count,-1                        # 0e
        lqd     $t,384($a_packet)                       # 0o
        ai      $a_packet_2,$a_packet,320               # 1e
        lqd     $vz,320($a_packet)                      # 1o
        lqd     $vy,256($a_packet)                      # 2o
        lqd     $t_14,400($a_packet)                    # 3o
        lqd     $vx,192($a_packet)                      # 4o
        lqd     $vx_5,208($a_packet)                    # 5o
        cgti    $there,$t,-1                            # 6e
        lqd     $vz_8,336($a_packet)                    # 6o
        nop     $127                                    # 7e pairing
        lqd     $t,416($a_packet)                       # 7o
        and     $weight,$there,$k_along                 # 8e
        lqd     $vy_7,272($a_packet)                    # 8o
        cgti    $there1_8,$t_14,-1                      # 9e
        lqd     $vy_13,288($a_packet)                   # 9o
        fm      $top_t,$vy,$weight                      # 10e
        lqd     $vz_16,352($a_packet)                   # 10o
        fm      $most,$vz,$weight                       # 11e
        lqd     $t_6,432($a_packet)                     # 11o
        fm      $top,$vx,$weight                        # 12e
        lqd     $vx,224($a_packet)                      # 12o
        cgti    $there2_6,$t,-1                         # 13e
        lqd     $vx_13,240($a_packet)                   # 13o
        and     $weight1_6,$there1_8,$k_along           # 14e
        lqd     $vy,304($a_packet)                      # 14o
        and     $weight2_4,$there2_6,$k_along           # 15e
        lqd     $vz,368($a_packet)                      # 15o
        fma     $top_t,$vy_7,$weight1_6,$top_t          # 16e
        fma     $most,$vz_8,$weight1_6,$most            # 17e
        fma     $top,$vx_5,$weight1_6,$top              # 18e
        cgti    $there3_6,$t_6,-1                       # 19e
        ai      $a_packet,$a_packet_2,320               # 20e
        and     $weight+3,$there3_6,$k_along            # 21e
        fma     $top_t,$vy_13,$weight2_4,$top_t         # 22e
        fma     $most,$vz_16,$weight2_4,$most           # 23e
        fma     $top,$vx,$weight2_4,$top                # 24e
        fma     $top_t,$vy,$weight+3,$top_t             # 28e
        fma     $most,$vz,$weight+3,$most               # 29e
        fma     $top,$vx_13,$weight+3,$top              # 30e
        shufb   $t_words+1,$top_t,$t_odd,$m_first       # 34o
        shufb   $t_words+3,$top_t,$t_odd,$m_last        # 35o
        shufb   $t_words+2,$top,$most,$m_last           # 36o
        shufb   $t_words,$top,$most,$m_first            # 37o
        shufb   $t_rows+3,$t_words+2,$t_words+3,$m_last # 40o
        shufb   $t_rows,$t_words,$t_words+1,$m_first    # 41o
        shufb   $t_rows+1,$t_words,$t_words+1,$m_last   # 42o
        shufb   $t_rows+2,$t_words+2,$t_words+3,$m_first # 43o
        fa      $t_rows,$t_rows,$t_rows+1               # 46e
        fa      $t_rows+2,$t_rows+2,$t_rows+3           # 47e
        fa      $t_rows,$t_rows,$t_rows+2               # 53e
        fm      $length,$t_rows,$t_rows                 # 59e
        rotqbyi $t_y,$length,4                          # 65o
        rotqbyi $t_e,$length,8                          # 66o
        fa      $length,$length,$t_y                    # 69e
        fa      $length,$length,$t_e                    # 75e
        nop     $127                                    # 76e pairing
        shufb   $length,$length,$length,$m_x            # 81o
        fcgt    $c_short,$k_short,$length               # 85e
        frsqest $t_y,$length                            # 85o
        stqd    $c_short,192($a_bound)                  # 87o
        fi      $t_y,$length,$t_y                       # 89e
        fm      $t_e,$length,$t_y                       # 96e
        fm      $inverse,$t_y,$k_half                   # 97e
        fnms    $t_e,$t_e,$t_y,$k_one                   # 102e
        fma     $inverse,$t_e,$inverse,$t_y             # 108e
        fm      $axis,$t_rows,$inverse                  # 114e
        stqd    $axis,176($a_bound)                     # 120o
        ai      $a_bound,$a_bound,208                   # 121e
        brnz    $count,next_axis_short                  # 121o
        nop     $127                                    # 122e pairing
        br      bound_fan_r16_block                     # 122o
next_cone_short:
        ai      $a_packet_2,$a_packet,320               # 0e
        lqd     $axis,176($a_bound)                     # 0o
        ai      $count,$count,-1                        # 1e
        lqd     $vx,192($a_packet)                      # 1o
        lqd     $vx_11,208($a_packet)                   # 2o
        lqd     $vx_5,224($a_packet)                    # 3o
        lqd     $vy,256($a_packet)                      # 4o
        lqd     $vy_21,272($a_packet)                   # 5o
        shufb   $axis_x,$axis,$axis,$m_x                # 6o
        shufb   $axis_y,$axis,$axis,$m_y                # 7o
        lqd     $vx_17,240($a_packet)                   # 8o
        lqd     $vy_23,288($a_packet)                   # 9o
        fms     $vx,$vx,$k_along,$axis_x                # 10e
        lqd     $vz,320($a_packet)                      # 10o
        fms     $vx_11,$vx_11,$k_along,$axis_x          # 11e
        lqd     $vz_25,336($a_packet)                   # 11o
        fms     $vx_5,$vx_5,$k_along,$axis_x            # 12e
        shufb   $axis_z,$axis,$axis,$m_z                # 12o
        fms     $vy,$vy,$k_along,$axis_y                # 13e
        lqd     $vy_7,304($a_packet)                    # 13o
        fms     $vy_21,$vy_21,$k_along,$axis_y          # 14e
        lqd     $vz_8,352($a_packet)                    # 14o
        fms     $vx_17,$vx_17,$k_along,$axis_x          # 15e
        lqd     $vz_10,368($a_packet)                   # 15o
        fm      $squared,$vx,$vx                        # 16e
        lqd     $top_t,384($a_packet)                   # 16o
        fm      $squared_3,$vx_11,$vx_11                # 17e
        lqd     $t,400($a_packet)                       # 17o
        fms     $vy_23,$vy_23,$k_along,$axis_y          # 18e
        lqd     $t_23,416($a_packet)                    # 18o
        fm      $squared_13,$vx_5,$vx_5                 # 19e
        lqd     $t_24,432($a_packet)                    # 19o
        fms     $vz,$vz,$k_along,$axis_z                # 20e
        lqd     $c_short,192($a_bound)                  # 20o
        fms     $vz_25,$vz_25,$k_along,$axis_z          # 21e
        stqd    $apex,160($a_bound)                     # 21o
        fma     $squared,$vy,$vy,$squared               # 22e
        stqd    $apex_x,0($a_bound)                     # 22o
        fma     $squared_3,$vy_21,$vy_21,$squared_3     # 23e
        stqd    $apex_y,16($a_bound)                    # 23o
        fms     $vy,$vy_7,$k_along,$axis_y              # 24e
        stqd    $apex_z,32($a_bound)                    # 24o
        fm      $squared_14,$vx_17,$vx_17               # 25e
        fms     $vz_22,$vz_8,$k_along,$axis_z           # 26e
        fma     $squared_13,$vy_23,$vy_23,$squared_13   # 27e
        fma     $squared,$vz,$vz,$squared               # 28e
        fma     $squared_3,$vz_25,$vz_25,$squared_3     # 29e
        fms     $vz,$vz_10,$k_along,$axis_z             # 30e
        fma     $squared_14,$vy,$vy,$squared_14         # 31e
        cgti    $there,$top_t,-1                        # 32e
        cgti    $there+1,$t,-1                          # 33e
        fma     $squared_13,$vz_22,$vz_22,$squared_13   # 34e
        and     $top,$squared,$there                    # 35e
        and     $squared,$squared_3,$there+1            # 36e
        fcgt    $c_greater,$top_t,$t                    # 37e
        fcgt    $c_greater_13,$top,$squared             # 38e
        cgti    $there+2,$t_23,-1                       # 39e
        fma     $squared_14,$vz,$vz,$squared_14         # 40e
        selb    $top,$squared,$top,$c_greater_13        # 41e
        selb    $top_t,$t,$top_t,$c_greater             # 42e
        and     $squared,$squared_13,$there+2           # 43e
        fcgt    $c_greater,$top_t,$t_23                 # 44e
        fcgt    $c_greater_13,$top,$squared             # 45e
        cgti    $there3_7,$t_24,-1                      # 46e
        selb    $top,$squared,$top,$c_greater_13        # 47e
        selb    $top_t,$t_23,$top_t,$c_greater          # 48e
        and     $squared,$squared_14,$there3_7          # 49e
        fcgt    $c_greater,$top_t,$t_24                 # 50e
        fcgt    $c_greater_13,$top,$squared             # 51e
        selb    $top_t,$t_24,$top_t,$c_greater          # 52e
        selb    $top,$squared,$top,$c_greater_13        # 53e
        ai      $a_packet,$a_packet_2,320               # 54e
        shufb   $most,$top,$top_t,$m_even               # 55o
        shufb   $t_odd,$top,$top_t,$m_odd               # 56o
        fcgt    $c_greater,$most,$t_odd                 # 60e
        selb    $most,$t_odd,$most,$c_greater           # 62e
        rotqbyi $t_odd,$most,8                          # 64o
        fcgt    $c_greater,$most,$t_odd                 # 68e
        selb    $most,$t_odd,$most,$c_greater           # 70e
        lnop                                            # 70o pairing
        fm      $t_y,$most,$k_quarter                   # 72e
        shufb   $t,$most,$most,$m_y                     # 72o
        fcgt    $c_wide,$most,$k_wide                   # 73e
        fnms    $cosine,$most,$k_chord,$k_cosine        # 74e
        or      $c_wide,$c_wide,$c_short                # 75e
        lnop                                            # 75o pairing
        rotmai  $none,$t,-31                            # 76e
        stqd    $t,144($a_bound)                        # 76o
        shufb   $c_wide,$c_wide,$c_wide,$m_x            # 77o
        fnms    $t,$t_y,$most,$most                     # 78e
        andc    $cosine,$cosine,$c_wide                 # 81e
        andc    $axis,$axis,$c_wide                     # 82e
        shufb   $out,$cosine,$cosine,$m_x               # 83o
        frsqest $t_y,$t                                 # 84o
        shufb   $out_8,$axis,$axis,$m_x                 # 85o
        shufb   $out_9,$axis,$axis,$m_y                 # 86o
        nop     $127                                    # 87e pairing
        shufb   $out_10,$axis,$axis,$m_z                # 87o
        fi      $t_y,$t,$t_y                            # 88e
        stqd    $out,96($a_bound)                       # 88o
        stqd    $out_8,48($a_bound)                     # 89o
        stqd    $out_9,64($a_bound)                     # 90o
        stqd    $out_10,80($a_bound)                    # 91o
        stqd    $axis,176($a_bound)                     # 92o
        fm      $t_e,$t,$t_y                            # 95e
        fm      $t_y,$t_y,$k_half                       # 96e
        fnms    $root,$t_e,$t_e,$t                      # 101e
        fma     $root,$root,$t_y,$t_e                   # 107e
        fma     $limits,$root,$k_sine,$k_least          # 113e
        lnop                                            # 113o pairing
        andc    $limits_5,$limits,$c_wide               # 119e
        shufb   $t_y,$limits,$limits,$m_y               # 119o
        or      $limits,$limits_5,$none                 # 121e
        lnop                                            # 121o pairing
        or      $t_y,$t_y,$none                         # 123e all ones is the largest single below
        shufb   $limits,$limits,$limits,$m_x            # 123o
        stqd    $t_y,128($a_bound)                      # 125o
        shufb   $limits_5,$limits,$t_y,$m_even          # 127o
        stqd    $limits,112($a_bound)                   # 128o
        stqd    $limits_5,192($a_bound)                 # 131o
        ai      $a_bound,$a_bound,208                   # 132e
        brnz    $count,next_cone_short                  # 132o
        nop     $127                                    # 133e pairing
        bi      $lr                                     # 133o
endfunction bound_fan_r16
