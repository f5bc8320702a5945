# bound_origins_r16   where the rays of packets are within whose directions are bounded already
#   C       void bound_origins_r16(const struct rays16 *, int count, struct bound *);
#   In      $3 RAYS16, one behind the other, $4 count (at least 1), $5 BOUNDs, as bound_fan_r16
#           makes them of any point; pointers 16-aligned
#   Out     the bounds' apexes and radii, those of the rays
#   Uses    $2-$79   Saves  -   Stack  0   Calls  -
#   Domain  origins below 2^60, of rays whose t has no sign; others are not there, and anything
#   Error   0: no origin is outside; apex and radius allow for the rounding of cull_nodes
#   Twin    lab/twins/src/bound.rs
#
# The apex is the mean of the origins. With the largest r = |origin - apex|,
#   radius = r (1 + 2^-18) + 2^-18 |apex|, where |apex| is the sum of its components' magnitudes.
# Without any ray, the radius is minus the largest single.
# Scheduled by spu schedule from bound_origins_r16.s

        .include "bound_tmpl.inc"
        .include "flat.inc"

        # constants
        .set    m_w,49
        .set    k_slack,50
        .set    k_grown,51
        .set    m_sign,52
        .set    m_limits,53
        # the packet
        .set    rays,54
        .set    apex,55
        .set    apex_x,56
        .set    apex_y,57
        .set    apex_z,58
        .set    top,59
        .set    radius,60
        .set    limits,61

        .section .rodata
        .align  4
sine_and_radius:
        .int    0x00010203,0x10111213,0x80808080,0x80808080

function bound_origins_r16
        .set count_2,79; .set a_packet_2,2; .set a_packet_3,6; .set t_2,7; .set t_3,8; .set vx_2,9
        .set t_4,19; .set vz_2,20; .set a_packet_4,21; .set vy_2,23; .set vy_3,24; .set there1_2,7
        .set there3_2,19; .set vx_3,25; .set weight1_2,29; .set vz_3,30; .set there2_2,8
        .set t_5,34; .set vy_4,9; .set vx_4,23; .set weight2_2,35; .set t_6,36; .set weight3_2,37
        .set vy_5,38; .set sum3_2,22; .set t_7,29; .set vx_5,28; .set vz_4,26; .set t_8,24
        .set t_e_2,35; .set vz_5,39; .set there_2,34; .set vy_6,40; .set there1_3,36; .set vx_6,41
        .set vy_7,30; .set vz_6,25; .set vx_7,27; .set vx_8,47; .set weight_2,35; .set vx_9,42
        .set weight1_3,37; .set vy_8,64; .set sum_2,23; .set vx_10,43; .set sum1_2,9
        .set t_words_2,44; .set sum2_2,20; .set t_words2_2,46; .set there3_3,24; .set t_words1_2,31
        .set there2_3,29; .set t_words3_2,32; .set weight3_3,22; .set vx_11,33; .set vy_9,48
        .set t_rows1_2,28; .set t_rows_2,31; .set weight2_3,26; .set t_rows3_2,38; .set sum3_3,35
        .set t_rows2_2,32; .set t_e_3,37; .set vz_7,44; .set t_rows_3,28; .set vy_10,62
        .set vz_8,31; .set vy_11,63; .set vz_9,38; .set vz_10,61; .set sum3_4,26; .set there_3,65
        .set there1_4,68; .set sum1_3,7; .set there2_4,66; .set t_rows_4,56; .set vx_12,8
        .set sum2_3,9; .set vx_13,18; .set sum_3,20; .set vx_14,21; .set vz_11,22; .set vz_12,23
        .set t_words1_3,40; .set t_words_3,7; .set none_2,69; .set t_y_2,9; .set vx_15,20
        .set t_rows1_3,25; .set t_rows3_3,26; .set t_y_3,27; .set t_rows_5,7; .set there3_4,67
        .set t_rows2_3,19; .set vy_12,25; .set vy_13,32; .set vz_13,46; .set vy_14,2
        .set there1_5,54; .set none_3,9; .set there_4,24; .set inverse_2,27; .set there2_5,34
        .set a_bound_2,40; .set a_bound_3,37; .set rays_2,28; .set apex_2,27; .set t_y_4,29
        .set t_y_5,45; .set apex_3,59; .set t_y_6,60; .set vx_16,29; .set vx_17,36; .set vx_18,39
        .set t_9,27; .set vy_15,35; .set t_10,43; .set vz_14,55; .set vy_16,41; .set t_11,56
        .set t_12,70; .set squared_2,36; .set vy_17,71; .set squared_3,39; .set vy_18,42
        .set vx_19,72; .set vz_15,73; .set vx_20,74; .set squared_4,33; .set vy_19,75
        .set squared_5,35; .set vy_20,76; .set vy_21,39; .set vz_16,57; .set vx_21,77
        .set vz_17,78; .set vx_22,31; .set vz_18,41; .set vy_22,79; .set t_e_4,44; .set there_5,27
        .set top_2,48; .set weight_3,58; .set squared_6,63; .set vz_19,35; .set c_greater_2,41
        .set squared_7,65; .set vz_20,29; .set top_3,66; .set t_e_5,28; .set c_greater_3,68
        .set squared_8,6; .set limits_2,36; .set top_4,33; .set sum1_4,27; .set c_greater_4,66
        .set sum_4,67; .set top_5,6; .set there1_6,33; .set sum2_4,43; .set t_13,55
        .set inverse_3,28; .set weight1_4,33; .set there2_6,45; .set c_greater_5,56; .set sum_5,71
        .set there3_5,56; .set apex_4,70; .set weight2_4,7; .set weight3_4,28; .set c_greater_6,45
        .set t_e_6,56; .set apex_x_2,45; .set t_y_7,55; .set sum_6,7; .set sum3_5,33; .set vx_23,71
        .set t_y_8,7; .set t_e_7,8; .set apex_5,56; .set t_y_9,28; .set squared_9,20
        .set t_words2_3,59; .set squared_10,60; .set t_words_4,31; .set vy_23,43
        .set squared_11,21; .set t_words1_4,27; .set squared_12,18; .set t_rows3_4,33
        .set t_y_10,71; .set t_rows1_4,72; .set t_e_8,73; .set squared_13,2; .set vz_21,21
        .set apex_6,7; .set squared_14,27; .set t_rows_6,25; .set t_rows2_4,30; .set squared_15,23
        .set t_14,6; .set t_e_9,6; .set apex_7,6; .set vz_22,24; .set vx_24,30; .set vx_25,37
        .set vy_24,26; .set squared_16,30; .set squared_17,37; .set squared_18,34
        .set squared_19,25; .set t_rows1_5,2; .set squared_20,26; .set squared_21,24
        .set t_rows_7,2; .set squared_22,22; .set none_4,2; .set a_bound_4,3; .set a_bound_5,4
        .set a_bound_6,6; .set a_bound_7,7; .set a_bound_8,12; .set apex_8,8; .set a_bound_9,13
        .set none_5,10; .set limits_3,9; .set apex_9,5; .set t_e_10,9; .set vx_26,13; .set vx_27,14
        .set squared_23,5; .set vz_23,5; .set top_6,13; .set vx_28,6; .set vy_25,8; .set vz_24,9
        .set vx_29,24; .set there2_7,7; .set weight2_5,30; .set vy_26,34; .set vx_30,35
        .set vz_25,27; .set vy_27,36; .set vz_26,37; .set t_words_5,2; .set t_words1_5,22
        .set t_words2_4,24; .set apex_10,2; .set vy_28,22; .set squared_24,8; .set squared_25,9
        ilhu    $m_x,1                                  # 0e
        lqa     $m_first,transpose_first                # 0o
        ilhu    $m_y,0x405                              # 1e
        lqa     $m_last,transpose_last                  # 1o
        ilhu    $m_z,0x809                              # 2e
        lqa     $m_limits,sine_and_radius               # 2o
        ilhu    $m_w,0xc0d                              # 3e
        ilhu    $k_grown,0x3f80                         # 4e 1 + 2^-18
        clgti   $count_2,$count,3                       # 5e at least as many passes as overlap
        ilhu    $k_one,0x3f80                           # 6e
        ilhu    $k_half,0x3f00                          # 7e
        iohl    $m_x,515                                # 8e
        iohl    $m_y,0x607                              # 9e
        iohl    $m_z,0xa0b                              # 10e
        ilhu    $k_weight,0x3f80                        # 11e
        iohl    $m_w,0xe0f                              # 12e
        ilhu    $k_slack,0x3680                         # 13e 2^-18
        iohl    $k_grown,32                             # 14e 1 + 2^-18
        ilhu    $m_sign,0x8000                          # 15e
        brz     $count_2,next_packet_short              # 15o too few passes
        ai      $a_packet_2,$a_packet,320               # 16e
        lqd     $t,384($a_packet)                       # 16o
        ai      $count,$count,-1                        # 17e
        lqd     $vy,64($a_packet)                       # 17o
        ai      $a_packet_2,$a_packet_2,320             # 18e
        lqd     $vx,0($a_packet)                        # 18o
        ai      $count,$count,-1                        # 19e
        lqd     $vz,128($a_packet)                      # 19o
        ai      $a_packet_3,$a_packet_2,320             # 20e
        lqd     $t_2,400($a_packet)                     # 20o
        ai      $count,$count,-1                        # 21e
        lqd     $t_3,416($a_packet)                     # 21o
        cgti    $there,$t,-1                            # 22e
        lqd     $vx_2,16($a_packet)                     # 22o
        ai      $a_packet_3,$a_packet_3,320             # 23e
        lqd     $t_4,432($a_packet)                     # 23o
        and     $weight,$there,$k_weight                # 24e
        lqd     $vz_2,144($a_packet)                    # 24o
        ai      $a_packet_4,$a_packet_3,320             # 25e
        lqd     $vy_2,80($a_packet)                     # 25o
        fm      $sum+2,$vz,$weight                      # 26e
        lqd     $vy_3,96($a_packet)                     # 26o
        fm      $sum+1,$vy,$weight                      # 27e
        lqd     $vz,160($a_packet)                      # 27o
        fm      $sum,$vx,$weight                        # 28e
        lqd     $vx,32($a_packet)                       # 28o
        cgti    $there1_2,$t_2,-1                       # 29e
        lqd     $vy,112($a_packet)                      # 29o
        cgti    $there3_2,$t_4,-1                       # 30e
        lqd     $vx_3,48($a_packet)                     # 30o
        and     $weight1_2,$there1_2,$k_weight          # 31e
        lqd     $vz_3,176($a_packet)                    # 31o
        cgti    $there2_2,$t_3,-1                       # 32e
        lqd     $t_5,384($a_packet_2)                   # 32o
        fma     $sum+2,$vz_2,$weight1_2,$sum+2          # 33e
        lqd     $vz_2,128($a_packet_2)                  # 33o
        fma     $sum,$vx_2,$weight1_2,$sum              # 34e
        lqd     $vy_4,64($a_packet_2)                   # 34o
        fma     $sum+1,$vy_2,$weight1_2,$sum+1          # 35e
        lqd     $vx_4,0($a_packet_2)                    # 35o
        and     $weight2_2,$there2_2,$k_weight          # 36e
        lqd     $t_6,400($a_packet_2)                   # 36o
        and     $weight3_2,$there3_2,$k_weight          # 37e
        lqd     $vy_5,80($a_packet_2)                   # 37o
        fa      $sum3_2,$weight,$weight1_2              # 38e
        lqd     $t_7,416($a_packet_2)                   # 38o
        fma     $sum+2,$vz,$weight2_2,$sum+2            # 39e
        lqd     $vx_5,16($a_packet_2)                   # 39o
        fma     $sum,$vx,$weight2_2,$sum                # 40e
        lqd     $vz_4,144($a_packet_2)                  # 40o
        fma     $sum+1,$vy_3,$weight2_2,$sum+1          # 41e
        lqd     $t_8,432($a_packet_2)                   # 41o
        fa      $t_e_2,$weight2_2,$weight3_2            # 42e
        lqd     $vz_5,160($a_packet_2)                  # 42o
        cgti    $there_2,$t_5,-1                        # 43e
        lqd     $vy_6,96($a_packet_2)                   # 43o
        cgti    $there1_3,$t_6,-1                       # 44e
        lqd     $vx_6,32($a_packet_2)                   # 44o
        fma     $sum+2,$vz_3,$weight3_2,$sum+2          # 45e
        lqd     $vy_7,112($a_packet_2)                  # 45o
        fma     $sum,$vx_3,$weight3_2,$sum              # 46e
        lqd     $vz_6,176($a_packet_2)                  # 46o
        fma     $sum+1,$vy,$weight3_2,$sum+1            # 47e
        lqd     $vx_7,48($a_packet_2)                   # 47o
        fa      $sum3_2,$sum3_2,$t_e_2                  # 48e
        lqd     $vx_8,16($a_packet)                     # 48o
        and     $weight_2,$there_2,$k_weight            # 49e
        lqd     $vx_9,0($a_packet)                      # 49o
        and     $weight1_3,$there1_3,$k_weight          # 50e
        lqd     $vy_8,80($a_packet)                     # 50o
        fm      $sum_2,$vx_4,$weight_2                  # 51e
        lqd     $vx_10,32($a_packet)                    # 51o
        fm      $sum1_2,$vy_4,$weight_2                 # 52e
        shufb   $t_words_2,$sum,$sum+2,$m_first         # 52o
        fm      $sum2_2,$vz_2,$weight_2                 # 53e
        shufb   $t_words2_2,$sum,$sum+2,$m_last         # 53o
        cgti    $there3_3,$t_8,-1                       # 54e
        shufb   $t_words1_2,$sum+1,$sum3_2,$m_first     # 54o
        cgti    $there2_3,$t_7,-1                       # 55e
        shufb   $t_words3_2,$sum+1,$sum3_2,$m_last      # 55o
        and     $weight3_3,$there3_3,$k_weight          # 56e
        lqd     $vx_11,48($a_packet)                    # 56o
        fma     $sum_2,$vx_5,$weight1_3,$sum_2          # 57e
        lqd     $vy_9,64($a_packet)                     # 57o
        fma     $sum1_2,$vy_5,$weight1_3,$sum1_2        # 58e
        shufb   $t_rows1_2,$t_words_2,$t_words1_2,$m_last # 58o
        fma     $sum2_2,$vz_4,$weight1_3,$sum2_2        # 59e
        shufb   $t_rows_2,$t_words_2,$t_words1_2,$m_first # 59o
        and     $weight2_3,$there2_3,$k_weight          # 60e
        shufb   $t_rows3_2,$t_words2_2,$t_words3_2,$m_last # 60o
        fa      $sum3_3,$weight_2,$weight1_3            # 61e
        shufb   $t_rows2_2,$t_words2_2,$t_words3_2,$m_first # 61o
        fa      $t_e_3,$weight2_3,$weight3_3            # 62e
        lqd     $vz_7,144($a_packet)                    # 62o
        fa      $t_rows_3,$t_rows_2,$t_rows1_2          # 63e
        lqd     $vy_10,96($a_packet)                    # 63o
        fma     $sum1_2,$vy_6,$weight2_3,$sum1_2        # 64e
        lqd     $vz_8,128($a_packet)                    # 64o
        fa      $t_rows2_2,$t_rows2_2,$t_rows3_2        # 65e
        lqd     $vy_11,112($a_packet)                   # 65o
        fma     $sum2_2,$vz_5,$weight2_3,$sum2_2        # 66e
        lqd     $vz_9,160($a_packet)                    # 66o
        fma     $sum_2,$vx_6,$weight2_3,$sum_2          # 67e
        lqd     $vz_10,176($a_packet)                   # 67o
        fa      $sum3_4,$sum3_3,$t_e_3                  # 68e
        shlqbyi $there_3,$there,0                       # 68o copy
        ai      $a_packet,$a_packet_4,320               # 69e
        shlqbyi $there1_4,$there1_2,0                   # 69o copy
        fma     $sum1_3,$vy_7,$weight3_3,$sum1_2        # 70e
        shlqbyi $there2_4,$there2_2,0                   # 70o copy
        fa      $t_rows_4,$t_rows_3,$t_rows2_2          # 71e
        lqd     $vx_12,0($a_packet_2)                   # 71o
        fma     $sum2_3,$vz_6,$weight3_3,$sum2_2        # 72e
        lqd     $vx_13,48($a_packet_2)                  # 72o
        fma     $sum_3,$vx_7,$weight3_3,$sum_2          # 73e
        lqd     $vx_14,16($a_packet_2)                  # 73o
        lqd     $vz_11,144($a_packet_2)                 # 74o
        lqd     $vz_12,176($a_packet_2)                 # 75o
        shufb   $t_words1_3,$sum1_3,$sum3_4,$m_first    # 76o
        shufb   $rays,$t_rows_4,$t_rows_4,$m_w          # 77o
        shufb   $t_words3_2,$sum1_3,$sum3_4,$m_last     # 78o
        shufb   $t_words_3,$sum_3,$sum2_3,$m_first      # 79o
        nop     $127                                    # 80e pairing
        shufb   $t_words2_2,$sum_3,$sum2_3,$m_last      # 80o
        ceqi    $none_2,$rays,0                         # 81e
        frest   $t_y_2,$rays                            # 81o
        lqd     $vx_15,32($a_packet_2)                  # 82o
        shufb   $t_rows1_3,$t_words_3,$t_words1_3,$m_last # 83o
        nop     $127                                    # 84e pairing
        shufb   $t_rows3_3,$t_words2_2,$t_words3_2,$m_last # 84o
        fi      $t_y_3,$rays,$t_y_2                     # 85e
        shufb   $t_rows2_2,$t_words2_2,$t_words3_2,$m_first # 85o
        shufb   $t_rows_5,$t_words_3,$t_words1_3,$m_first # 86o
        lqd     $vy_7,96($a_packet_2)                   # 87o
        nop     $127                                    # 88e pairing
        shlqbyi $there3_4,$there3_2,0                   # 88o copy
        fa      $t_rows2_3,$t_rows2_2,$t_rows3_3        # 89e
        lqd     $vz_4,160($a_packet_2)                  # 89o
        fa      $t_rows_5,$t_rows_5,$t_rows1_3          # 90e
        lqd     $vy_12,64($a_packet_2)                  # 90o
        nop     $127                                    # 91e pairing
        lqd     $vy_13,112($a_packet_2)                 # 91o
        fnms    $t_e,$rays,$t_y_3,$k_one                # 92e
        lqd     $vz_13,128($a_packet_2)                 # 92o
        lqd     $vy_14,80($a_packet_2)                  # 93o
        shlqbyi $there1_5,$there1_3,0                   # 94o copy
        nop     $127                                    # 95e pairing
        shlqbyi $none_3,$none_2,0                       # 95o copy
        fa      $t_rows_5,$t_rows_5,$t_rows2_3          # 96e
        shlqbyi $there3_2,$there3_3,0                   # 96o copy
        nop     $127                                    # 97e pairing
        shlqbyi $there_4,$there_2,0                     # 97o copy
        fma     $inverse_2,$t_e,$t_y_3,$t_y_3           # 98e
        shlqbyi $there2_5,$there2_3,0                   # 98o copy
        shlqbyi $a_bound_2,$a_bound,0                   # 99o copy
        shlqbyi $a_bound_3,$a_bound,0                   # 100o copy
        shufb   $rays_2,$t_rows_5,$t_rows_5,$m_w        # 102o
        fm      $apex_2,$t_rows_4,$inverse_2            # 104e
        ceqi    $none_2,$rays_2,0                       # 106e
        frest   $t_y_4,$rays_2                          # 106o
        fi      $t_y_5,$rays_2,$t_y_4                   # 110e
        shufb   $apex_x,$apex_2,$apex_2,$m_x            # 110o
        andc    $apex_3,$apex_2,$m_sign                 # 111e
        shufb   $apex_y,$apex_2,$apex_2,$m_y            # 111o
        shufb   $apex_z,$apex_2,$apex_2,$m_z            # 112o
        rotqbyi $t_y_6,$apex_3,4                        # 113o
        fs      $vx_16,$vx_9,$apex_x                    # 114e
        stqd    $apex_x,0($a_bound)                     # 114o
        fs      $vx_17,$vx_10,$apex_x                   # 115e
        stqd    $apex_2,160($a_bound)                   # 115o
        fs      $vx_18,$vx_8,$apex_x                    # 116e
        lqd     $t_9,384($a_packet_3)                   # 116o
        fs      $vy_15,$vy_9,$apex_y                    # 117e
        lqd     $t_10,400($a_packet_3)                  # 117o
        fs      $vx_11,$vx_11,$apex_x                   # 118e
        lqd     $vz_14,128($a_packet_3)                 # 118o
        fs      $vy_16,$vy_8,$apex_y                    # 119e
        lqd     $t_11,416($a_packet_3)                  # 119o
        fm      $squared,$vx_16,$vx_16                  # 120e
        lqd     $t_12,432($a_packet_3)                  # 120o
        fm      $squared_2,$vx_17,$vx_17                # 121e
        lqd     $vy_17,64($a_packet_3)                  # 121o
        fm      $squared_3,$vx_18,$vx_18                # 122e
        stqd    $apex_y,16($a_bound)                    # 122o
        fs      $vy_18,$vy_10,$apex_y                   # 123e
        stqd    $apex_z,32($a_bound)                    # 123o
        fs      $vz_8,$vz_8,$apex_z                     # 124e
        lqd     $vx_19,0($a_packet_3)                   # 124o
        fs      $vz_7,$vz_7,$apex_z                     # 125e
        lqd     $vz_15,144($a_packet_3)                 # 125o
        fma     $squared,$vy_15,$vy_15,$squared         # 126e
        lqd     $vx_20,16($a_packet_3)                  # 126o
        fm      $squared_4,$vx_11,$vx_11                # 127e
        lqd     $vy_19,80($a_packet_3)                  # 127o
        fma     $squared_5,$vy_16,$vy_16,$squared_3     # 128e
        lqd     $vy_20,96($a_packet_3)                  # 128o
        fs      $vy_21,$vy_11,$apex_y                   # 129e
        lqd     $vz_16,160($a_packet_3)                 # 129o
        fs      $vz_9,$vz_9,$apex_z                     # 130e
        lqd     $vx_21,32($a_packet_3)                  # 130o
        fma     $squared_2,$vy_18,$vy_18,$squared_2     # 131e
        lqd     $vz_17,176($a_packet_3)                 # 131o
        fma     $squared,$vz_8,$vz_8,$squared           # 132e
        lqd     $vx_22,48($a_packet_3)                  # 132o
        fs      $vz_18,$vz_10,$apex_z                   # 133e
        lqd     $vy_22,112($a_packet_3)                 # 133o
        fma     $squared_5,$vz_7,$vz_7,$squared_5       # 134e
        rotqbyi $t_e_4,$apex_3,8                        # 134o
        fma     $squared_4,$vy_21,$vy_21,$squared_4     # 135e
        lqd     $vx_18,32($a_packet_3)                  # 135o
        cgti    $there_5,$t_9,-1                        # 136e
        lqd     $vy_8,80($a_packet_3)                   # 136o
        fma     $squared_2,$vz_9,$vz_9,$squared_2       # 137e
        lqd     $vz_9,160($a_packet_3)                  # 137o
        and     $top_2,$squared,$there_3                # 138e
        lqd     $vx_9,0($a_packet_3)                    # 138o
        and     $weight_3,$there_5,$k_weight            # 139e
        lqd     $vx_8,16($a_packet_3)                   # 139o
        and     $squared_6,$squared_5,$there1_4         # 140e
        lqd     $vz_10,176($a_packet_3)                 # 140o
        fma     $squared_4,$vz_18,$vz_18,$squared_4     # 141e
        lqd     $vz_19,128($a_packet_3)                 # 141o
        fcgt    $c_greater_2,$top_2,$squared_6          # 142e
        lqd     $vy_10,96($a_packet_3)                  # 142o
        and     $squared_7,$squared_2,$there2_4         # 143e
        lqd     $vz_20,144($a_packet_3)                 # 143o
        selb    $top_3,$squared_6,$top_2,$c_greater_2   # 144e
        lqd     $vx_6,48($a_packet_3)                   # 144o
        fnms    $t_e_5,$rays_2,$t_y_5,$k_one            # 145e
        lqd     $vy_9,64($a_packet_3)                   # 145o
        fcgt    $c_greater_3,$top_3,$squared_7          # 146e
        lqd     $vy_11,112($a_packet_3)                 # 146o
        and     $squared_8,$squared_4,$there3_4         # 147e
        lqd     $limits_2,192($a_bound)                 # 147o
        selb    $top_4,$squared_7,$top_3,$c_greater_3   # 148e
        shlqbyi $there_3,$there_5,0                     # 148o copy
        fm      $sum1_4,$vy_17,$weight_3                # 149e
        fcgt    $c_greater_4,$top_4,$squared_8          # 150e
        fm      $sum_4,$vx_19,$weight_3                 # 151e
        selb    $top_5,$squared_8,$top_4,$c_greater_4   # 152e
        cgti    $there1_6,$t_10,-1                      # 153e
        lnop                                            # 153o pairing
        fm      $sum2_4,$vz_14,$weight_3                # 154e
        rotqbyi $t_13,$top_5,4                          # 154o
        fma     $inverse_3,$t_e_5,$t_y_5,$t_y_5         # 155e
        shlqbyi $there1_4,$there1_6,0                   # 155o copy
        and     $weight1_4,$there1_6,$k_weight          # 156e
        cgti    $there2_6,$t_11,-1                      # 157e
        fcgt    $c_greater_5,$top_5,$t_13               # 158e
        lnop                                            # 158o pairing
        fma     $sum_5,$vx_20,$weight1_4,$sum_4         # 159e
        shlqbyi $there2_4,$there2_6,0                   # 159o copy
        selb    $top_5,$t_13,$top_5,$c_greater_5        # 160e
        fma     $sum2_4,$vz_15,$weight1_4,$sum2_4       # 161e
        fma     $sum1_4,$vy_19,$weight1_4,$sum1_4       # 162e
        rotqbyi $t_13,$top_5,8                          # 162o
        cgti    $there3_5,$t_12,-1                      # 163e
        fm      $apex_4,$t_rows_5,$inverse_3            # 164e
        and     $weight2_4,$there2_6,$k_weight          # 165e
        shlqbyi $there3_4,$there3_5,0                   # 165o copy
        and     $weight3_4,$there3_5,$k_weight          # 166e
        fcgt    $c_greater_6,$top_5,$t_13               # 167e
        fa      $t_e_6,$weight2_4,$weight3_4            # 168e
        selb    $top_5,$t_13,$top_5,$c_greater_6        # 169e
        fma     $sum2_4,$vz_16,$weight2_4,$sum2_4       # 170e
        shufb   $apex_x_2,$apex_4,$apex_4,$m_x          # 170o
        fma     $sum1_4,$vy_20,$weight2_4,$sum1_4       # 171e
        frsqest $t_y_7,$top_5                           # 171o
        fma     $sum_6,$vx_21,$weight2_4,$sum_5         # 172e
        shufb   $apex_y,$apex_4,$apex_4,$m_y            # 172o
        fa      $sum3_5,$weight_3,$weight1_4            # 173e
        shufb   $apex_z,$apex_4,$apex_4,$m_z            # 173o
        fs      $vx_13,$vx_13,$apex_x_2                 # 174e
        fs      $vx_14,$vx_14,$apex_x_2                 # 175e
        fs      $vx_15,$vx_15,$apex_x_2                 # 176e
        fma     $sum2_4,$vz_17,$weight3_4,$sum2_4       # 177e
        fs      $vx_23,$vx_12,$apex_x_2                 # 178e
        fa      $sum3_5,$sum3_5,$t_e_6                  # 179e
        fma     $sum,$vx_22,$weight3_4,$sum_6           # 180e
        fi      $t_y_8,$top_5,$t_y_7                    # 181e
        andc    $apex,$apex_4,$m_sign                   # 182e
        fma     $sum1_4,$vy_22,$weight3_4,$sum1_4       # 183e
        fs      $vy_12,$vy_12,$apex_y                   # 184e
        rotqbyi $t_e_7,$apex,8                          # 184o
        fa      $apex_5,$apex_3,$t_y_6                  # 185e
        rotqbyi $t_y_9,$apex,4                          # 185o
        fm      $squared_9,$vx_15,$vx_15                # 186e
        shufb   $t_words2_3,$sum,$sum2_4,$m_last        # 186o
        fm      $squared_10,$vx_23,$vx_23               # 187e
        shufb   $t_words_4,$sum,$sum2_4,$m_first        # 187o
        fs      $vy_23,$vy_13,$apex_y                   # 188e
        lnop                                            # 188o pairing
        fm      $squared_11,$vx_14,$vx_14               # 189e
        shufb   $t_words3_2,$sum1_4,$sum3_5,$m_last     # 189o
        fs      $vy_14,$vy_14,$apex_y                   # 190e
        shufb   $t_words1_4,$sum1_4,$sum3_5,$m_first    # 190o
        fs      $vy_7,$vy_7,$apex_y                     # 191e
        fm      $squared_12,$vx_13,$vx_13               # 192e
        fs      $vz_11,$vz_11,$apex_z                   # 193e
        shufb   $t_rows3_4,$t_words2_3,$t_words3_2,$m_last # 193o
        fm      $t_y_10,$t_y_8,$k_half                  # 194e
        shufb   $t_rows1_4,$t_words_4,$t_words1_4,$m_last # 194o
        fm      $t_e_8,$top_5,$t_y_8                    # 195e
        shufb   $t_rows2_2,$t_words2_3,$t_words3_2,$m_first # 195o
        fma     $squared_13,$vy_14,$vy_14,$squared_11   # 196e
        shufb   $t_rows_2,$t_words_4,$t_words1_4,$m_first # 196o
        fs      $vz_21,$vz_13,$apex_z                   # 197e
        fma     $squared_12,$vy_23,$vy_23,$squared_12   # 198e
        fma     $squared_9,$vy_7,$vy_7,$squared_9       # 199e
        fa      $apex_6,$apex_5,$t_e_4                  # 200e in the first lane
        fs      $vz_12,$vz_12,$apex_z                   # 201e
        fs      $vz_4,$vz_4,$apex_z                     # 202e
        fma     $squared_14,$vy_12,$vy_12,$squared_10   # 203e
        hbrr    next_packet_back,next_packet            # 203o hint
        fa      $t_rows_6,$t_rows_2,$t_rows1_4          # 204e
        fa      $t_rows2_4,$t_rows2_2,$t_rows3_4        # 205e
        ai      $a_bound,$a_bound,208                   # 206e
        fnms    $radius,$t_e_8,$t_e_8,$top_5            # 207e
        fma     $squared_8,$vz_4,$vz_4,$squared_9       # 208e
        stqd    $apex_x_2,0($a_bound)                   # 208o
        fma     $squared_9,$vz_21,$vz_21,$squared_14    # 209e
        stqd    $apex_4,160($a_bound)                   # 209o
        fma     $squared_14,$vz_12,$vz_12,$squared_12   # 210e
        fma     $squared_15,$vz_11,$vz_11,$squared_13   # 211e
        fa      $t_rows_4,$t_rows_6,$t_rows2_4          # 212e
        fma     $radius,$radius,$t_y_10,$t_e_8          # 213e
        and     $squared_8,$squared_8,$there2_5         # 214e
        and     $top,$squared_9,$there_4                # 215e
        and     $squared_12,$squared_14,$there3_2       # 216e
        and     $squared_9,$squared_15,$there1_5        # 217e
next_packet:
        ai      $a_packet_2,$a_packet,320               # 0e
        lqd     $t,416($a_packet)                       # 0o
            fm      $radius,$radius,$k_grown            # 1e
            shufb   $rays,$t_rows_4,$t_rows_4,$m_w      # 1o
            fcgt    $c_greater,$top,$squared_9          # 2e
        ai      $count,$count,-1                        # 3e
            selb    $top,$squared_9,$top,$c_greater     # 4e
            lnop                                        # 4o pairing
            fa      $apex,$apex,$t_y_9                  # 5e
            frest   $t_y,$rays                          # 5o
            fcgt    $c_greater,$top,$squared_8          # 6e
            lnop                                        # 6o pairing
        cgti    $there+2,$t,-1                          # 7e
        lqd     $t,384($a_packet)                       # 7o
            selb    $top,$squared_8,$top,$c_greater     # 8e
            lnop                                        # 8o pairing
            fma     $radius,$apex_6,$k_slack,$radius    # 9e
        lqd     $t_14,400($a_packet)                    # 9o
            fcgt    $c_greater,$top,$squared_12         # 10e
            lnop                                        # 10o pairing
            fi      $t_y,$rays,$t_y                     # 11e
        lqd     $t_2,432($a_packet)                     # 11o
            selb    $top,$squared_12,$top,$c_greater    # 12e
            lnop                                        # 12o pairing
        cgti    $there,$t,-1                            # 13e
        lqd     $vz,128($a_packet)                      # 13o
        and     $weight+2,$there+2,$k_weight            # 14e
            rotqbyi $t,$top,4                           # 14o
        cgti    $there+1,$t_14,-1                       # 15e
        and     $weight,$there,$k_weight                # 16e
        cgti    $there+3,$t_2,-1                        # 17e
        lqd     $vy,64($a_packet)                       # 17o
            fcgt    $c_greater,$top,$t                  # 18e
            lnop                                        # 18o pairing
        fm      $sum+2,$vz,$weight                      # 19e
            shufb   $radius,$radius,$radius,$m_x        # 19o
            selb    $top,$t,$top,$c_greater             # 20e
            stqd    $apex_y,16($a_bound)                # 20o
            fnms    $t_e,$rays,$t_y,$k_one              # 21e
            stqd    $apex_z,32($a_bound)                # 21o
        and     $weight+1,$there+1,$k_weight            # 22e
            rotqbyi $t,$top,8                           # 22o
        fm      $sum+1,$vy,$weight                      # 23e
        lqd     $vx,0($a_packet)                        # 23o
        and     $weight+3,$there+3,$k_weight            # 24e
        lqd     $vz,144($a_packet)                      # 24o
        fa      $sum+3,$weight,$weight+1                # 25e
        lnop                                            # 25o pairing
        fa      $t_e_9,$weight+2,$weight+3              # 26e
        lqd     $vy,80($a_packet)                       # 26o
            fcgt    $c_greater,$top,$t                  # 27e
            fma     $inverse,$t_e,$t_y,$t_y             # 28e
        fm      $sum,$vx,$weight                        # 29e
        lqd     $vx,16($a_packet)                       # 29o
        fma     $sum+2,$vz,$weight+1,$sum+2             # 30e
        lqd     $vz,160($a_packet)                      # 30o
            selb    $top,$t,$top,$c_greater             # 31e
            lnop                                        # 31o pairing
        fma     $sum+1,$vy,$weight+1,$sum+1             # 32e
        lqd     $vy,96($a_packet)                       # 32o
        fa      $sum+3,$sum+3,$t_e_9                    # 33e
            frsqest $t_y,$top                           # 33o
            fm      $apex_7,$t_rows_4,$inverse          # 34e
            lnop                                        # 34o pairing
        fma     $sum,$vx,$weight+1,$sum                 # 35e
        lqd     $vx,32($a_packet)                       # 35o
        fma     $sum+2,$vz,$weight+2,$sum+2             # 36e
        lqd     $vz,176($a_packet)                      # 36o
            fa      $apex_6,$apex,$t_e_7                # 37e in the first lane
            lnop                                        # 37o pairing
        fma     $sum+1,$vy,$weight+2,$sum+1             # 38e
        lqd     $vy,112($a_packet)                      # 38o
            fi      $t_y,$top,$t_y                      # 39e
            lnop                                        # 39o pairing
            andc    $apex,$apex_7,$m_sign               # 40e
            shufb   $apex_z,$apex_7,$apex_7,$m_z        # 40o
        fma     $sum,$vx,$weight+2,$sum                 # 41e
        lnop                                            # 41o pairing
        fma     $sum+2,$vz,$weight+3,$sum+2             # 42e
            rotqbyi $t_e_7,$apex,8                      # 42o
            or      $radius,$radius,$none_3             # 43e all ones is the largest single below 0
            shlqbyi $none_3,$none_2,0                   # 43o copy
        fma     $sum+1,$vy,$weight+3,$sum+1             # 44e
            shufb   $apex_y,$apex_7,$apex_7,$m_y        # 44o
            fs      $vz,$vz_10,$apex_z                  # 45e
            stqd    $radius,128($a_bound_2)             # 45o
            fs      $vz_11,$vz_9,$apex_z                # 46e
            shufb   $apex_x,$apex_7,$apex_7,$m_x        # 46o
            fs      $vz_12,$vz_20,$apex_z               # 47e
            shufb   $limits,$limits_2,$radius,$m_limits # 47o
            fs      $vz_22,$vz_19,$apex_z               # 48e
        lqd     $vx,48($a_packet)                       # 48o
            fs      $vy,$vy_9,$apex_y                   # 49e
        lqd     $vz_20,144($a_packet)                   # 49o
            fs      $vx_24,$vx_6,$apex_x                # 50e
        lqd     $vz_19,128($a_packet)                   # 50o
            fs      $vx_17,$vx_18,$apex_x               # 51e
            stqd    $limits,192($a_bound_3)             # 51o
            fs      $vx_25,$vx_9,$apex_x                # 52e
        lqd     $vz_9,160($a_packet)                    # 52o
            fs      $vx_18,$vx_8,$apex_x                # 53e
        shufb   $t_words1_3,$sum+1,$sum+3,$m_first      # 53o
        fma     $sum,$vx,$weight+3,$sum                 # 54e
        lqd     $vx_6,48($a_packet)                     # 54o
            fs      $vy_12,$vy_8,$apex_y                # 55e
        lqd     $vx_9,0($a_packet)                      # 55o
            fs      $vy_24,$vy_10,$apex_y               # 56e
        lqd     $vx_8,16($a_packet)                     # 56o
            fm      $squared_16,$vx_24,$vx_24           # 57e
        lqd     $vy_9,64($a_packet)                     # 57o
            fm      $squared_17,$vx_25,$vx_25           # 58e
        lqd     $vz_10,176($a_packet)                   # 58o
            fs      $vy_23,$vy_11,$apex_y               # 59e
        shufb   $t_words3_2,$sum+1,$sum+3,$m_last       # 59o
            fm      $squared_18,$vx_18,$vx_18           # 60e
        lqd     $vx_18,32($a_packet)                    # 60o
            fm      $t_e,$top,$t_y                      # 61e
        lqd     $vy_10,96($a_packet)                    # 61o
            fm      $squared_2,$vx_17,$vx_17            # 62e
        shufb   $t_words2_2,$sum,$sum+2,$m_last         # 62o
            fm      $t_y,$t_y,$k_half                   # 63e
        shufb   $t_words_4,$sum,$sum+2,$m_first         # 63o
            fma     $squared_14,$vy,$vy,$squared_17     # 64e
        lqd     $vy_11,112($a_packet)                   # 64o
            fma     $squared_16,$vy_23,$vy_23,$squared_16 # 65e
        lqd     $vy_8,80($a_packet)                     # 65o
            fma     $squared_19,$vy_12,$vy_12,$squared_18 # 66e
        shufb   $t_rows3_4,$t_words2_2,$t_words3_2,$m_last # 66o
        ai      $a_packet,$a_packet_2,320               # 67e
        shufb   $t_rows1_5,$t_words_4,$t_words1_3,$m_last # 67o
            fma     $squared_20,$vy_24,$vy_24,$squared_2 # 68e
        shufb   $t_rows_2,$t_words_4,$t_words1_3,$m_first # 68o
            fnms    $radius,$t_e,$t_e,$top              # 69e
        shufb   $t_rows2_2,$t_words2_2,$t_words3_2,$m_first # 69o
            fma     $squared_21,$vz_22,$vz_22,$squared_14 # 70e
            lnop                                        # 70o pairing
            fma     $squared_14,$vz,$vz,$squared_16     # 71e
            rotqbyi $t_y_9,$apex,4                      # 71o
        fa      $t_rows_7,$t_rows_2,$t_rows1_5          # 72e
            lqd     $limits_2,192($a_bound)             # 72o
        fa      $t_rows2_4,$t_rows2_2,$t_rows3_4        # 73e
            shlqbyi $a_bound_3,$a_bound,0               # 73o copy
            fma     $squared_22,$vz_11,$vz_11,$squared_20 # 74e
            shlqbyi $a_bound_2,$a_bound,0               # 74o copy
            ai      $a_bound,$a_bound,208               # 75e
            fma     $squared_15,$vz_12,$vz_12,$squared_19 # 76e
            and     $top,$squared_21,$there_3           # 77e
        shlqbyi $there_3,$there,0                       # 77o copy
            fma     $radius,$radius,$t_y,$t_e           # 78e
            stqd    $apex_x,0($a_bound)                 # 78o
        fa      $t_rows_4,$t_rows_7,$t_rows2_4          # 79e
            stqd    $apex_7,160($a_bound)               # 79o
            and     $squared_8,$squared_22,$there2_4    # 80e
        shlqbyi $there2_4,$there+2,0                    # 80o copy
            and     $squared_12,$squared_14,$there3_4   # 81e
        shlqbyi $there3_4,$there+3,0                    # 81o copy
            and     $squared_9,$squared_15,$there1_4    # 82e
        shlqbyi $there1_4,$there+1,0                    # 82o copy
            ceqi    $none_2,$rays,0                     # 83e
next_packet_back:
        brnz    $count,next_packet                      # 83o
next_packet_drain:
        fcgt    $c_greater,$top,$squared_9              # 0e
        shufb   $rays,$t_rows_4,$t_rows_4,$m_w          # 0o
        fm      $radius,$radius,$k_grown                # 1e
        stqd    $apex_y,16($a_bound)                    # 1o
        selb    $top,$squared_9,$top,$c_greater         # 2e
        stqd    $apex_z,32($a_bound)                    # 2o
        fa      $apex,$apex,$t_y_9                      # 3e
        shlqbyi $none_4,$none_2,0                       # 3o copy
        fcgt    $c_greater,$top,$squared_8              # 4e
        frest   $t_y,$rays                              # 4o
        ai      $a_bound_4,$a_bound,208                 # 5e
        shlqbyi $a_bound_5,$a_bound,0                   # 5o copy
        selb    $top,$squared_8,$top,$c_greater         # 6e
        shlqbyi $a_bound_6,$a_bound,0                   # 6o copy
        fma     $radius,$apex_6,$k_slack,$radius        # 7e
        hbr     bound_origins_r16_return,$lr            # 7o hint
        fi      $t_y,$rays,$t_y                         # 8e
        shlqbyi $a_bound_7,$a_bound_4,0                 # 8o copy
        fcgt    $c_greater,$top,$squared_12             # 9e
        shlqbyi $a_bound_8,$a_bound_4,0                 # 9o copy
        fa      $apex_8,$apex,$t_e_7                    # 10e in the first lane
        selb    $top,$squared_12,$top,$c_greater        # 11e
        ceqi    $none_2,$rays,0                         # 12e
        lnop                                            # 12o pairing
        ai      $a_bound_9,$a_bound_4,208               # 13e
        rotqbyi $t,$top,4                               # 13o
        nop     $127                                    # 14e pairing
        shufb   $radius,$radius,$radius,$m_x            # 14o
        fnms    $t_e,$rays,$t_y,$k_one                  # 15e
        shlqbyi $none_5,$none_2,0                       # 15o copy
        fcgt    $c_greater,$top,$t                      # 17e
        or      $radius,$radius,$none_3                 # 18e all ones is the largest single below 0
        selb    $top,$t,$top,$c_greater                 # 19e
        shufb   $limits_3,$limits_2,$radius,$m_limits   # 20o
        fma     $inverse,$t_e,$t_y,$t_y                 # 21e
        rotqbyi $t,$top,8                               # 21o
        stqd    $radius,128($a_bound_2)                 # 22o
        stqd    $limits_3,192($a_bound_3)               # 24o
        fcgt    $c_greater,$top,$t                      # 25e
        lqd     $limits_2,192($a_bound)                 # 25o
        fm      $apex_9,$t_rows_4,$inverse              # 27e
        selb    $top,$t,$top,$c_greater                 # 28e
        nop     $127                                    # 29e pairing
        frsqest $t_y,$top                               # 30o
        andc    $apex,$apex_9,$m_sign                   # 33e
        shufb   $apex_x,$apex_9,$apex_9,$m_x            # 33o
        fi      $t_y,$top,$t_y                          # 34e
        shufb   $apex_y,$apex_9,$apex_9,$m_y            # 34o
        shufb   $apex_z,$apex_9,$apex_9,$m_z            # 35o
        rotqbyi $t_y_9,$apex,4                          # 36o
        fs      $vx_25,$vx_9,$apex_x                    # 37e
        rotqbyi $t_e_10,$apex,8                         # 37o
        fs      $vx_26,$vx_8,$apex_x                    # 38e
        stqd    $apex_x,0($a_bound_4)                   # 38o
        fs      $vx_27,$vx_18,$apex_x                   # 39e
        stqd    $apex_9,160($a_bound_4)                 # 39o
        fs      $vy,$vy_9,$apex_y                       # 40e
        stqd    $apex_y,16($a_bound_4)                  # 40o
        fs      $vy_12,$vy_8,$apex_y                    # 41e
        stqd    $apex_z,32($a_bound_4)                  # 41o
        fs      $vx_24,$vx_6,$apex_x                    # 42e
        fm      $squared_17,$vx_25,$vx_25               # 43e
        fm      $squared_18,$vx_26,$vx_26               # 44e
        fs      $vy_24,$vy_10,$apex_y                   # 45e
        fm      $squared_23,$vx_27,$vx_27               # 46e
        fs      $vz_12,$vz_20,$apex_z                   # 47e
        fs      $vz_22,$vz_19,$apex_z                   # 48e
        fma     $squared_14,$vy,$vy,$squared_17         # 49e
        fma     $squared_19,$vy_12,$vy_12,$squared_18   # 50e
        fm      $squared_16,$vx_24,$vx_24               # 51e
        fs      $vy_23,$vy_11,$apex_y                   # 52e
        fs      $vz_11,$vz_9,$apex_z                    # 53e
        fma     $squared_20,$vy_24,$vy_24,$squared_23   # 54e
        fma     $squared_21,$vz_22,$vz_22,$squared_14   # 55e
        fma     $squared_15,$vz_12,$vz_12,$squared_19   # 56e
        fs      $vz_23,$vz_10,$apex_z                   # 57e
        fma     $squared_16,$vy_23,$vy_23,$squared_16   # 58e
        fm      $t_e,$top,$t_y                          # 59e
        fma     $squared_22,$vz_11,$vz_11,$squared_20   # 60e
        and     $top_6,$squared_21,$there_3             # 61e
        and     $squared_9,$squared_15,$there1_4        # 62e
        fm      $t_y,$t_y,$k_half                       # 63e
        fma     $squared_14,$vz_23,$vz_23,$squared_16   # 64e
        fcgt    $c_greater,$top_6,$squared_9            # 65e
        and     $squared_23,$squared_22,$there2_4       # 66e
        selb    $top_6,$squared_9,$top_6,$c_greater     # 67e
        fnms    $radius,$t_e,$t_e,$top                  # 68e
        fcgt    $c_greater,$top_6,$squared_23           # 69e
        and     $squared_12,$squared_14,$there3_4       # 70e
        selb    $top,$squared_23,$top_6,$c_greater      # 71e
        fa      $apex,$apex,$t_y_9                      # 72e
        fcgt    $c_greater,$top,$squared_12             # 73e
        fma     $radius,$radius,$t_y,$t_e               # 74e
        selb    $top,$squared_12,$top,$c_greater        # 75e
        rotqbyi $t,$top,4                               # 77o
        fa      $apex_9,$apex,$t_e_10                   # 78e in the first lane
        fm      $radius,$radius,$k_grown                # 80e
        fcgt    $c_greater,$top,$t                      # 81e
        selb    $top,$t,$top,$c_greater                 # 83e
        rotqbyi $t,$top,8                               # 85o
        fma     $radius,$apex_8,$k_slack,$radius        # 86e
        fcgt    $c_greater,$top,$t                      # 89e
        selb    $top,$t,$top,$c_greater                 # 91e
        shufb   $radius,$radius,$radius,$m_x            # 92o
        frsqest $t_y,$top                               # 93o
        or      $radius,$radius,$none_4                 # 96e all ones is the largest single below 0
        fi      $t_y,$top,$t_y                          # 97e
        shufb   $limits,$limits_2,$radius,$m_limits     # 98o
        stqd    $radius,128($a_bound_5)                 # 99o
        stqd    $limits,192($a_bound_6)                 # 102o
        lqd     $limits_2,192($a_bound_4)               # 103o
        fm      $t_e,$top,$t_y                          # 104e
        fm      $t_y,$t_y,$k_half                       # 105e
        fnms    $radius,$t_e,$t_e,$top                  # 110e
        fma     $radius,$radius,$t_y,$t_e               # 116e
        fm      $radius,$radius,$k_grown                # 122e
        fma     $radius,$apex_9,$k_slack,$radius        # 128e
        shufb   $radius,$radius,$radius,$m_x            # 134o
        or      $radius,$radius,$none_5                 # 138e all ones is the largest single below
        shufb   $limits,$limits_2,$radius,$m_limits     # 140o
        stqd    $radius,128($a_bound_7)                 # 141o
        stqd    $limits,192($a_bound_8)                 # 144o
        nop     $127                                    # 145e pairing
bound_origins_r16_return:
        bi      $lr                                     # 145o
next_packet_short:
        ai      $count,$count,-1                        # 0e
        lqd     $t,384($a_packet)                       # 0o
        ai      $a_packet_2,$a_packet,320               # 1e
        lqd     $t_14,400($a_packet)                    # 1o
        lqd     $vx,0($a_packet)                        # 2o
        lqd     $vy,64($a_packet)                       # 3o
        lqd     $vz,128($a_packet)                      # 4o
        lqd     $t_2,416($a_packet)                     # 5o
        cgti    $there,$t,-1                            # 6e
        lqd     $t,432($a_packet)                       # 6o
        cgti    $there+1,$t_14,-1                       # 7e
        lqd     $vx_28,16($a_packet)                    # 7o
        and     $weight,$there,$k_weight                # 8e
        lqd     $vy_25,80($a_packet)                    # 8o
        and     $weight+1,$there+1,$k_weight            # 9e
        lqd     $vz_24,144($a_packet)                   # 9o
        fm      $sum,$vx,$weight                        # 10e
        lqd     $vz_2,160($a_packet)                    # 10o
        fm      $sum+2,$vz,$weight                      # 11e
        lqd     $vx,32($a_packet)                       # 11o
        fm      $sum+1,$vy,$weight                      # 12e
        lqd     $vy,96($a_packet)                       # 12o
        cgti    $there+3,$t,-1                          # 13e
        lqd     $vx_29,48($a_packet)                    # 13o
        cgti    $there2_7,$t_2,-1                       # 14e
        lqd     $vy_12,112($a_packet)                   # 14o
        and     $weight3_4,$there+3,$k_weight           # 15e
        lqd     $vz_20,176($a_packet)                   # 15o
        fma     $sum,$vx_28,$weight+1,$sum              # 16e
        lqd     $vx_28,16($a_packet)                    # 16o
        fma     $sum+2,$vz_24,$weight+1,$sum+2          # 17e
        lqd     $vx_2,0($a_packet)                      # 17o
        fma     $sum+1,$vy_25,$weight+1,$sum+1          # 18e
        lqd     $vx_12,32($a_packet)                    # 18o
        and     $weight2_5,$there2_7,$k_weight          # 19e
        lqd     $vy_26,80($a_packet)                    # 19o
        fa      $sum3_2,$weight,$weight+1               # 20e
        lqd     $vy_2,64($a_packet)                     # 20o
        fa      $t_e,$weight2_5,$weight3_4              # 21e
        lqd     $vx_30,48($a_packet)                    # 21o
        fma     $sum,$vx,$weight2_5,$sum                # 22e
        lqd     $vy_24,96($a_packet)                    # 22o
        fma     $sum+2,$vz_2,$weight2_5,$sum+2          # 23e
        lqd     $vz_2,128($a_packet)                    # 23o
        fma     $sum+1,$vy,$weight2_5,$sum+1            # 24e
        lqd     $vz_25,144($a_packet)                   # 24o
        lqd     $vz_3,160($a_packet)                    # 25o
        lqd     $vy_27,112($a_packet)                   # 26o
        fa      $sum3_2,$sum3_2,$t_e                    # 27e
        lqd     $vz_26,176($a_packet)                   # 27o
        fma     $sum,$vx_29,$weight3_4,$sum             # 28e
        lqd     $limits,192($a_bound)                   # 28o
        fma     $sum+2,$vz_20,$weight3_4,$sum+2         # 29e
        fma     $sum+1,$vy_12,$weight3_4,$sum+1         # 30e
        ai      $a_packet,$a_packet_2,320               # 31e
        shufb   $t_words_5,$sum,$sum+2,$m_first         # 35o
        shufb   $t_words+3,$sum+1,$sum3_2,$m_last       # 36o
        shufb   $t_words1_5,$sum+1,$sum3_2,$m_first     # 37o
        shufb   $t_words2_4,$sum,$sum+2,$m_last         # 38o
        shufb   $t_rows+1,$t_words_5,$t_words1_5,$m_last # 41o
        shufb   $t_rows+2,$t_words2_4,$t_words+3,$m_first # 42o
        shufb   $t_rows,$t_words_5,$t_words1_5,$m_first # 43o
        shufb   $t_rows+3,$t_words2_4,$t_words+3,$m_last # 44o
        fa      $t_rows,$t_rows,$t_rows+1               # 47e
        fa      $t_rows+2,$t_rows+2,$t_rows+3           # 48e
        fa      $t_rows,$t_rows,$t_rows+2               # 54e
        nop     $127                                    # 55e pairing
        shufb   $rays,$t_rows,$t_rows,$m_w              # 60o
        ceqi    $none,$rays,0                           # 64e
        frest   $t_y,$rays                              # 64o
        fi      $t_y,$rays,$t_y                         # 68e
        fnms    $t_e,$rays,$t_y,$k_one                  # 75e
        fma     $inverse,$t_e,$t_y,$t_y                 # 81e
        fm      $apex,$t_rows,$inverse                  # 87e
        andc    $apex_10,$apex,$m_sign                  # 93e
        shufb   $apex_x,$apex,$apex,$m_x                # 93o
        shufb   $apex_y,$apex,$apex,$m_y                # 94o
        shufb   $apex_z,$apex,$apex,$m_z                # 95o
        nop     $127                                    # 96e pairing
        rotqbyi $t_y,$apex_10,4                         # 96o
        fs      $vx_2,$vx_2,$apex_x                     # 97e
        rotqbyi $t_e,$apex_10,8                         # 97o
        fs      $vx_28,$vx_28,$apex_x                   # 98e
        stqd    $apex,160($a_bound)                     # 98o
        fs      $vy_28,$vy_2,$apex_y                    # 99e
        stqd    $apex_x,0($a_bound)                     # 99o
        fs      $vy_2,$vy_26,$apex_y                    # 100e
        stqd    $apex_y,16($a_bound)                    # 100o
        fs      $vx_12,$vx_12,$apex_x                   # 101e
        stqd    $apex_z,32($a_bound)                    # 101o
        fs      $vx_29,$vx_30,$apex_x                   # 102e
        fm      $squared,$vx_2,$vx_2                    # 103e
        fm      $squared_8,$vx_28,$vx_28                # 104e
        fs      $vy_4,$vy_24,$apex_y                    # 105e
        fs      $vz,$vz_2,$apex_z                       # 106e
        fm      $squared_24,$vx_12,$vx_12               # 107e
        fm      $squared_9,$vx_29,$vx_29                # 108e
        fma     $squared,$vy_28,$vy_28,$squared         # 109e
        fs      $vz_11,$vz_25,$apex_z                   # 110e
        fma     $squared_8,$vy_2,$vy_2,$squared_8       # 111e
        fs      $vy,$vy_27,$apex_y                      # 112e
        fs      $vz_12,$vz_3,$apex_z                    # 113e
        fma     $squared_24,$vy_4,$vy_4,$squared_24     # 114e
        fma     $squared,$vz,$vz,$squared               # 115e
        fs      $vz,$vz_26,$apex_z                      # 116e
        fma     $squared_8,$vz_11,$vz_11,$squared_8     # 117e
        fma     $squared_25,$vy,$vy,$squared_9          # 118e
        fa      $apex,$apex_10,$t_y                     # 119e
        fma     $squared_13,$vz_12,$vz_12,$squared_24   # 120e
        and     $top,$squared,$there                    # 121e
        and     $squared,$squared_8,$there+1            # 123e
        fma     $squared_8,$vz,$vz,$squared_25          # 124e
        fcgt    $c_greater,$top,$squared                # 125e
        and     $squared_13,$squared_13,$there2_7       # 126e
        selb    $top,$squared,$top,$c_greater           # 127e
        fa      $apex,$apex,$t_e                        # 128e in the first lane
        fcgt    $c_greater,$top,$squared_13             # 129e
        and     $squared,$squared_8,$there+3            # 130e
        selb    $top,$squared_13,$top,$c_greater        # 131e
        fcgt    $c_greater,$top,$squared                # 133e
        selb    $top,$squared,$top,$c_greater           # 135e
        rotqbyi $t,$top,4                               # 137o
        fcgt    $c_greater,$top,$t                      # 141e
        selb    $top,$t,$top,$c_greater                 # 143e
        rotqbyi $t,$top,8                               # 145o
        fcgt    $c_greater,$top,$t                      # 149e
        selb    $top,$t,$top,$c_greater                 # 151e
        frsqest $t_y,$top                               # 153o
        fi      $t_y,$top,$t_y                          # 157e
        fm      $t_e,$top,$t_y                          # 164e
        fm      $t_y,$t_y,$k_half                       # 165e
        fnms    $radius,$t_e,$t_e,$top                  # 170e
        fma     $radius,$radius,$t_y,$t_e               # 176e
        fm      $radius,$radius,$k_grown                # 182e
        fma     $radius,$apex,$k_slack,$radius          # 188e
        shufb   $radius,$radius,$radius,$m_x            # 194o
        or      $radius,$radius,$none                   # 198e all ones is the largest single below
        shufb   $limits,$limits,$radius,$m_limits       # 200o
        stqd    $radius,128($a_bound)                   # 201o
        stqd    $limits,192($a_bound)                   # 204o
        ai      $a_bound,$a_bound,208                   # 205e
        brnz    $count,next_packet_short                # 205o
        nop     $127                                    # 206e pairing
        bi      $lr                                     # 206o
endfunction bound_origins_r16
