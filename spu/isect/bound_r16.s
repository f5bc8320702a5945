# bound_r16   what the rays of packets are within: a ball moved along a cone
#   C       void bound_r16(const struct rays16 *, int count, struct bound *);
#   In      $3 RAYS16, one behind the other, $4 count (at least 1), $5 BOUNDs; pointers 16-aligned
#   Out     the packets' bounds, one behind the other
#   Uses    $2-$79   Saves  -   Stack  0   Calls  -
#   Domain  |d| = 1 within 4 ulp and origins below 2^60, of rays whose t has no sign; others are not
#           there, and anything
#   Error   0: no ray is outside; apex, axis, cosine and sine allow for the rounding of cull_nodes
#   Twin    oracle/src/twin/bound.rs
#
# The apex is the mean of the origins, the axis that of the directions at length 1. Of the rays
#   n = -d.axis, l = d + n axis   so |l| is the sine of d's angle with the axis
#   r = origin - apex
# the largest n, l^2, r^2, t are looked for, and of these
#   cosine = -n (1 - 2^-12)       for cull_nodes takes a length in 12 bits
#   sine = |l| + 2^-18            l is right to some 2^-20
#   radius = |r| (1 + 2^-18) + 2^-18 |apex|, in the sum of the components' magnitudes
# With a direction more than 79 degrees from the axis the cone is of little use, and near a right
# angle sine^2 + cosine^2 would exceed 1, where cull_nodes relies on less: then axis, cosine and sine
# are all 0. The radius is less the largest single if no ray is there.
# Scheduled by spu schedule from bound_r16.s

        .include "work_unit.inc"
        .include "macros.inc"
        .include "math.inc"
        .include "rays.inc"
        .include "flat.inc"
        .include "transpose.inc"

        .set    a_packet,3
        .set    count,4
        .set    a_bound,5
        # constants
        .set    k_one,10
        .set    k_half,11
        .set    k_zero,12
        .set    k_minus_one,13
        .set    k_wide,14
        .set    k_slack,15
        .set    k_grown,16
        .set    k_shrunk,17
        .set    m_sign,18
        .set    m_first,19
        .set    m_last,20
        .set    m_x,21
        .set    m_y,22
        .set    m_z,23
        .set    m_w,24
        # rows of rays
        .set    there,25                                # to 28: masks
        .set    weight,29                               # to 32: 1 or 0
        .set    ox,33
        .set    oy,34
        .set    oz,35
        .set    dx,36
        .set    dy,37
        .set    dz,38
        # sums, then those of all lanes in the lanes
        .set    sum,39                                  # to 42: x, y, z, rays
        .set    t_words,43                              # to 46
        .set    t_rows,47                               # to 50
        # the packet
        .set    rays,51
        .set    inverse,52
        .set    apex_x,53
        .set    apex_y,54
        .set    apex_z,55
        .set    axis_x,56
        .set    axis_y,57
        .set    axis_z,58
        .set    length,59
        .set    t_y,60
        .set    t_e,61
        # largest so far
        .set    top,62                                  # to 65: n, l^2, r^2, t
        .set    n,66
        .set    l2,67
        .set    r2,68
        .set    t,69
        .set    c_greater,70
        # the bound
        .set    root,71
        .set    sine,72
        .set    cosine,73
        .set    radius,74
        .set    farthest,75
        .set    c_wide,76
        .set    none,77

        .set    WIDE,0xbe40                             # -3/16
        .set    SLACK,0x3680                            # 2^-18

.macro  maximum out:req, a:req, b:req
        fcgt    $c_greater,\a,\b
        selb    \out,\b,\a,$c_greater
.endm

# The sums over four rows of rays, in $sum to $sum+3, to one vector of the sums over all.
.macro  sum_lanes
        transpose t_rows,sum,t_words,$m_first,$m_last
        fa      $t_rows,$t_rows,$t_rows+1
        fa      $t_rows+2,$t_rows+2,$t_rows+3
        fa      $t_rows,$t_rows,$t_rows+2
.endm

# Of three fields, the sums over four rows of the rays that are there.
.macro  sum_rows field:req
    .irp row, 0,1,2,3
        lqd     $ox,RAYS16_\field\()_x+16*\row($a_packet)
        lqd     $oy,RAYS16_\field\()_y+16*\row($a_packet)
        lqd     $oz,RAYS16_\field\()_z+16*\row($a_packet)
    .ifc \row,0
        fm      $sum,$ox,$weight
        fm      $sum+1,$oy,$weight
        fm      $sum+2,$oz,$weight
    .else
        fma     $sum,$ox,$weight+\row,$sum
        fma     $sum+1,$oy,$weight+\row,$sum+1
        fma     $sum+2,$oz,$weight+\row,$sum+2
    .endif
    .endr
        sum_lanes
.endm

        transpose_table

function bound_r16
        .set    count_2,79
        .set    a_packet_2,2
        .set    t_2,7
        .set    t_3,8
        .set    ox_2,7
        .set    oz_2,6
        .set    oy_2,26
        .set    there1_2,47
        .set    ox_3,8
        .set    oy_3,46
        .set    ox_4,9
        .set    oy_4,30
        .set    weight1_2,51
        .set    oz_3,44
        .set    sum_2,8
        .set    oz_4,32
        .set    oy_5,49
        .set    oz_5,50
        .set    sum1_2,46
        .set    ox_5,52
        .set    oz_6,42
        .set    oy_6,53
        .set    ox_6,54
        .set    sum2_2,44
        .set    oz_7,56
        .set    weight3_2,35
        .set    oy_7,6
        .set    dx_2,32
        .set    sum3_2,55
        .set    ox_7,48
        .set    dy_2,60
        .set    oz_8,51
        .set    dz_2,52
        .set    dx_3,57
        .set    ox_8,50
        .set    ox_9,34
        .set    dz_3,42
        .set    dy_3,29
        .set    t_words2_2,54
        .set    t_words_2,39
        .set    t_words1_2,41
        .set    t_words3_2,26
        .set    sum_3,7
        .set    oz_9,8
        .set    sum2_3,35
        .set    t_rows_2,43
        .set    t_rows1_2,39
        .set    t_rows3_2,37
        .set    t_rows2_2,26
        .set    t_rows_3,39
        .set    t_rows2_3,7
        .set    oy_8,40
        .set    t_rows1_3,38
        .set    t_rows3_3,36
        .set    t_rows2_4,35
        .set    t_rows_4,37
        .set    t_rows_5,7
        .set    t_4,39
        .set    top3_2,36
        .set    oz_10,38
        .set    oz_11,46
        .set    dx_4,9
        .set    axis_y_2,41
        .set    dx_5,58
        .set    t_rows_6,35
        .set    axis_z_2,37
        .set    length_2,7
        .set    dy_4,30
        .set    dz_4,49
        .set    dz_5,59
        .set    dy_5,33
        .set    ox_10,31
        .set    there1_3,65
        .set    there_2,68
        .set    none_2,79
        .set    t_y_2,39
        .set    top3_3,71
        .set    t_y_3,2
        .set    t_y_4,36
        .set    inverse_2,2
        .set    inverse_3,43
        .set    apex_x_2,39
        .set    inverse_4,36
        .set    oy_9,2
        .set    axis_x_2,72
        .set    axis_y_3,74
        .set    axis_z_3,77
        .set    r2_2,7
        .set    r2_3,31
        .set    n_2,41
        .set    ox_11,45
        .set    r2_4,34
        .set    r2_5,8
        .set    r2_6,6
        .set    dy_6,26
        .set    l2_2,9
        .set    ox_12,40
        .set    dz_6,34
        .set    n_3,36
        .set    r2_7,26
        .set    l2_3,8
        .set    oz_12,30
        .set    oy_10,43
        .set    r2_8,2
        .set    oz_13,43
        .set    l2_4,73
        .set    n_4,37
        .set    ox_13,78
        .set    n_5,63
        .set    n_6,75
        .set    l2_5,76
        .set    n_7,6
        .set    n_8,43
        .set    dz_7,45
        .set    dx_6,48
        .set    l2_6,36
        .set    c_greater_2,7
        .set    t_words3_3,54
        .set    t_words1_3,2
        .set    top3_4,45
        .set    axis_z_4,7
        .set    t_y_5,35
        .set    axis_y_4,7
        .set    axis_x_3,2
        .set    root_2,45
        .set    root_3,35
        .set    radius_2,33
        .set    sine_2,32
        .set    radius_3,31
        .set    radius_4,9
        .set    sine_3,26
        .set    sine_4,6
        .set    n_9,2
        .set    a_bound_2,3
        .set    c_greater_3,2
        .set    axis_y_5,2
        .set    axis_x_4,3
        .set    t_5,6
        .set    oy_11,8
        .set    oz_14,9
        .set    oy_12,27
        .set    oy_13,31
        .set    there2_2,36
        .set    oz_15,37
        .set    oy_14,7
        .set    weight2_2,38
        .set    ox_14,43
        .set    oy_15,44
        .set    oy_16,45
        .set    oz_16,27
        .set    sum_4,43
        .set    sum2_4,37
        .set    ox_15,47
        .set    dx_7,31
        .set    dy_7,35
        .set    dx_8,33
        .set    sum_5,34
        .set    sum1_3,7
        .set    sum2_5,9
        .set    t_words1_4,49
        .set    t_words3_4,40
        .set    t_words2_3,50
        .set    t_words_3,34
        .set    dz_8,9
        .set    t_rows2_5,27
        .set    dx_9,7
        .set    dz_9,27
        .set    ox_16,39
        .set    ox_17,44
        .set    dz_10,6
        .set    t_words_4,8
        .set    ox_18,32
        .set    oy_17,41
        .set    oy_18,42
        .set    t_rows2_6,50
        .set    t_rows3_4,40
        .set    t_rows1_4,8
        .set    oz_17,49
        .set    t_rows2_7,40
        .set    t_6,52
        .set    rays_2,2
        .set    t_y_6,8
        .set    t_e_2,2
        .set    n_10,8
        .set    n_11,40
        .set    dx_10,44
        .set    l2_7,33
        .set    l2_8,31
        .set    r2_9,43
        .set    l2_9,7
        .set    r2_10,35
        .set    oz_18,39
        .set    l2_10,29
        .set    r2_11,33
        .set    r2_12,30
        .set    r2_13,27
        .set    l2_11,6
        .set    r2_14,25
        .set    c_greater_4,9
        .set    c_greater_5,8
        .set    r2_15,9
        ilhu    $k_grown,0x3f80                         # 0e 1 + 2^-18
        lqa     $m_first,transpose_first                # 0o

        ilhu    $k_shrunk,0xbf7f                        # 1e -(1 - 2^-12)
        lqa     $m_last,transpose_last                  # 1o

        ilhu    $m_x,1                                  # 2e
        ilhu    $m_y,0x405                              # 3e

        ilhu    $m_z,0x809                              # 4e
        ilhu    $m_w,0xc0d                              # 5e

        clgti   $count_2,$count,1                       # 6e at least as many passes as overlap
        ilhu    $k_one,0x3f80                           # 7e

        ilhu    $k_half,0x3f00                          # 8e
        il      $k_zero,0                               # 9e

        ilhu    $k_minus_one,0xbf80                     # 10e
        ilhu    $k_wide,0xbe40                          # 11e

        ilhu    $k_slack,0x3680                         # 12e
        iohl    $k_grown,32                             # 13e 1 + 2^-18

        iohl    $k_shrunk,0xf000                        # 14e -(1 - 2^-12)
        ilhu    $m_sign,0x8000                          # 15e

        iohl    $m_x,515                                # 16e
        iohl    $m_y,0x607                              # 17e

        iohl    $m_z,0xa0b                              # 18e
        lnop                                            # 18o pairing

        iohl    $m_w,0xe0f                              # 19e
        brz     $count_2,next_packet_short              # 19o too few passes

        ai      $a_packet_2,$a_packet,320               # 20e
        lqd     $t_2,384($a_packet)                     # 20o

        ai      $count,$count,-1                        # 21e
        lqd     $ox,192($a_packet)                      # 21o

        lqd     $oz,320($a_packet)                      # 22o
        lqd     $t_3,400($a_packet)                     # 23o

        lqd     $t,416($a_packet)                       # 24o
        lqd     $oy,256($a_packet)                      # 25o

        cgti    $there,$t_2,-1                          # 26e
        lqd     $ox_2,208($a_packet)                    # 26o

        nop     $127                                    # 27e pairing
        lqd     $oz_2,336($a_packet)                    # 27o

        and     $weight,$there,$k_one                   # 28e
        lqd     $oy_2,272($a_packet)                    # 28o

        cgti    $there1_2,$t_3,-1                       # 29e
        lqd     $ox_3,0($a_packet)                      # 29o

        fm      $sum,$ox,$weight                        # 30e
        lqd     $oy_3,64($a_packet)                     # 30o

        fm      $sum+2,$oz,$weight                      # 31e
        lqd     $ox_4,224($a_packet)                    # 31o

        fm      $sum+1,$oy,$weight                      # 32e
        lqd     $oy_4,288($a_packet)                    # 32o

        and     $weight1_2,$there1_2,$k_one             # 33e
        lqd     $oz_3,128($a_packet)                    # 33o

        cgti    $there+2,$t,-1                          # 34e
        lqd     $t,432($a_packet)                       # 34o

        fm      $sum_2,$ox_3,$weight                    # 35e
        lqd     $oz_4,352($a_packet)                    # 35o

        fma     $sum,$ox_2,$weight1_2,$sum              # 36e
        lqd     $oy_5,80($a_packet)                     # 36o

        fma     $sum+2,$oz_2,$weight1_2,$sum+2          # 37e
        lqd     $oz_5,144($a_packet)                    # 37o

        fm      $sum1_2,$oy_3,$weight                   # 38e
        lqd     $ox,240($a_packet)                      # 38o

        fma     $sum+1,$oy_2,$weight1_2,$sum+1          # 39e
        lqd     $ox_5,16($a_packet)                     # 39o

        and     $weight+2,$there+2,$k_one               # 40e
        lqd     $oz_6,368($a_packet)                    # 40o

        cgti    $there+3,$t,-1                          # 41e
        lqd     $oy_6,96($a_packet)                     # 41o

        fma     $sum,$ox_4,$weight+2,$sum               # 42e
        lqd     $oy,304($a_packet)                      # 42o

        fma     $sum+2,$oz_4,$weight+2,$sum+2           # 43e
        lqd     $ox_6,32($a_packet)                     # 43o

        fm      $sum2_2,$oz_3,$weight                   # 44e
        lqd     $oz_7,160($a_packet)                    # 44o

        and     $weight3_2,$there+3,$k_one              # 45e
        lqd     $oy_7,112($a_packet)                    # 45o

        fma     $sum+1,$oy_4,$weight+2,$sum+1           # 46e
        lqd     $ox_2,48($a_packet)                     # 46o

        fa      $t_e,$weight+2,$weight3_2               # 47e
        lqd     $t,400($a_packet)                       # 47o

        fma     $sum1_2,$oy_5,$weight1_2,$sum1_2        # 48e
        lqd     $dx_2,224($a_packet)                    # 48o

        fa      $sum3_2,$weight,$weight1_2              # 49e
        lqd     $ox_7,32($a_packet)                     # 49o

        fma     $sum2_2,$oz_5,$weight1_2,$sum2_2        # 50e
        lqd     $dy_2,272($a_packet)                    # 50o

        fma     $sum_2,$ox_5,$weight1_2,$sum_2          # 51e
        lqd     $oz_8,176($a_packet)                    # 51o

        fma     $sum,$ox,$weight3_2,$sum                # 52e
        lqd     $dz_2,336($a_packet)                    # 52o

        fma     $sum+2,$oz_6,$weight3_2,$sum+2          # 53e
        lqd     $dx_3,208($a_packet)                    # 53o

        fma     $sum+1,$oy,$weight3_2,$sum+1            # 54e
        lqd     $ox_8,48($a_packet)                     # 54o

        fa      $sum3_2,$sum3_2,$t_e                    # 55e
        lqd     $ox_9,0($a_packet)                      # 55o

        fma     $sum1_2,$oy_6,$weight+2,$sum1_2         # 56e
        lqd     $dz_3,368($a_packet)                    # 56o

        fma     $sum_2,$ox_6,$weight+2,$sum_2           # 57e
        lqd     $oy_6,80($a_packet)                     # 57o

        fma     $sum2_2,$oz_7,$weight+2,$sum2_2         # 58e
        lqd     $dy_3,256($a_packet)                    # 58o

        shufb   $t_words2_2,$sum,$sum+2,$m_last         # 59o
        shufb   $t_words_2,$sum,$sum+2,$m_first         # 60o

        shufb   $t_words1_2,$sum+1,$sum3_2,$m_first     # 61o
        shufb   $t_words3_2,$sum+1,$sum3_2,$m_last      # 62o

        fma     $sum+1,$oy_7,$weight3_2,$sum1_2         # 63e
        lqd     $oy_7,96($a_packet)                     # 63o

        fma     $sum_3,$ox_2,$weight3_2,$sum_2          # 64e
        lqd     $oz_9,144($a_packet)                    # 64o

        fma     $sum2_3,$oz_8,$weight3_2,$sum2_2        # 65e
        shufb   $t_rows_2,$t_words_2,$t_words1_2,$m_first # 65o

        shufb   $t_rows1_2,$t_words_2,$t_words1_2,$m_last # 66o
        shufb   $t_rows3_2,$t_words2_2,$t_words3_2,$m_last # 67o

        shufb   $t_rows2_2,$t_words2_2,$t_words3_2,$m_first # 68o
        shufb   $t_words+3,$sum+1,$sum3_2,$m_last       # 69o

        fa      $t_rows_3,$t_rows_2,$t_rows1_2          # 70e
        shufb   $t_words+1,$sum+1,$sum3_2,$m_first      # 70o

        shufb   $t_words,$sum_3,$sum2_3,$m_first        # 71o
        shufb   $t_words+2,$sum_3,$sum2_3,$m_last       # 72o

        fa      $t_rows2_3,$t_rows2_2,$t_rows3_2        # 73e
        lqd     $oy_2,64($a_packet)                     # 73o

        lqd     $oy_8,112($a_packet)                    # 74o
        shufb   $t_rows1_3,$t_words,$t_words+1,$m_last  # 75o

        shufb   $t_rows3_3,$t_words+2,$t_words+3,$m_last # 76o
        shufb   $t_rows2_4,$t_words+2,$t_words+3,$m_first # 77o

        nop     $127                                    # 78e pairing
        shufb   $t_rows_4,$t_words,$t_words+1,$m_first  # 78o

        fa      $t_rows_5,$t_rows_3,$t_rows2_3          # 79e
        lqd     $t_4,416($a_packet)                     # 79o

        nop     $127                                    # 80e pairing
        lqd     $oz_3,176($a_packet)                    # 80o

        fa      $t_rows2_4,$t_rows2_4,$t_rows3_3        # 81e
        lqd     $top3_2,384($a_packet)                  # 81o

        fa      $t_rows_4,$t_rows_4,$t_rows1_3          # 82e
        lqd     $oz_10,128($a_packet)                   # 82o

        lqd     $oz_11,160($a_packet)                   # 83o
        lqd     $dx_4,240($a_packet)                    # 84o

        shufb   $axis_x,$t_rows_5,$t_rows_5,$m_x        # 85o
        shufb   $axis_y_2,$t_rows_5,$t_rows_5,$m_y      # 86o

        fcgt    $c_greater,$top3_2,$t                   # 87e
        lqd     $dx_5,192($a_packet)                    # 87o

        fa      $t_rows_6,$t_rows_4,$t_rows2_4          # 88e
        shufb   $axis_z_2,$t_rows_5,$t_rows_5,$m_z      # 88o

        fm      $length_2,$axis_x,$axis_x               # 89e
        lqd     $dy_4,304($a_packet)                    # 89o

        selb    $top3_2,$t,$top3_2,$c_greater           # 90e
        lqd     $t,432($a_packet)                       # 90o

        nop     $127                                    # 91e pairing
        lqd     $dz_4,320($a_packet)                    # 91o

        fcgt    $c_greater,$top3_2,$t_4                 # 92e
        lqd     $dz_5,352($a_packet)                    # 92o

        nop     $127                                    # 93e pairing
        lqd     $dy_5,288($a_packet)                    # 93o

        selb    $top3_2,$t_4,$top3_2,$c_greater         # 94e
        shufb   $rays,$t_rows_6,$t_rows_6,$m_w          # 94o

        fma     $length_2,$axis_y_2,$axis_y_2,$length_2 # 95e
        lqd     $ox_10,16($a_packet)                    # 95o

        ai      $a_packet,$a_packet_2,320               # 96e
        shlqbyi $there1_3,$there1_2,0                   # 96o copy

        fcgt    $c_greater,$top3_2,$t                   # 97e
        shlqbyi $there_2,$there,0                       # 97o copy

        ceqi    $none_2,$rays,0                         # 98e
        frest   $t_y_2,$rays                            # 98o

        selb    $top3_3,$t,$top3_2,$c_greater           # 99e
        fma     $length_2,$axis_z_2,$axis_z_2,$length_2 # 101e squared

        fi      $t_y_3,$rays,$t_y_2                     # 102e
        frsqest $t_y_4,$length_2                        # 107o

        fnms    $t_e,$rays,$t_y_3,$k_one                # 109e
        fi      $t_y_4,$length_2,$t_y_4                 # 111e

        fma     $inverse_2,$t_e,$t_y_3,$t_y_3           # 115e
        fm      $t_e,$length_2,$t_y_4                   # 118e

        fm      $inverse_3,$t_y_4,$k_half               # 119e
        fm      $inverse_2,$t_rows_6,$inverse_2         # 121e

        fnms    $t_e,$t_e,$t_y_4,$k_one                 # 124e
        shufb   $apex_x_2,$inverse_2,$inverse_2,$m_x    # 127o

        shufb   $apex_y,$inverse_2,$inverse_2,$m_y      # 128o
        shufb   $apex_z,$inverse_2,$inverse_2,$m_z      # 129o

        fma     $inverse_4,$t_e,$inverse_3,$t_y_4       # 130e
        lnop                                            # 130o pairing

        fs      $ox_2,$ox_9,$apex_x_2                   # 131e
        stqd    $apex_x_2,0($a_bound)                   # 131o

        fs      $ox_10,$ox_10,$apex_x_2                 # 132e
        stqd    $apex_y,16($a_bound)                    # 132o

        fs      $oy_2,$oy_2,$apex_y                     # 133e
        stqd    $apex_z,32($a_bound)                    # 133o

        fs      $oy_9,$oy_8,$apex_y                     # 134e
        fs      $oy_8,$oy_6,$apex_y                     # 135e

        fm      $axis_x_2,$axis_x,$inverse_4            # 136e
        fm      $axis_y_3,$axis_y_2,$inverse_4          # 137e

        fm      $axis_z_3,$axis_z_2,$inverse_4          # 138e
        fm      $r2_2,$ox_2,$ox_2                       # 139e

        fm      $r2_3,$ox_10,$ox_10                     # 140e
        fs      $ox_9,$ox_7,$apex_x_2                   # 141e

        fnms    $n,$dx_2,$axis_x_2,$k_zero              # 142e
        fnms    $n_2,$dx_4,$axis_x_2,$k_zero            # 143e

        fs      $oz_10,$oz_10,$apex_z                   # 144e
        fma     $r2_2,$oy_2,$oy_2,$r2_2                 # 145e

        fma     $r2_3,$oy_8,$oy_8,$r2_3                 # 146e
        fs      $oz_9,$oz_9,$apex_z                     # 147e

        fnms    $n,$dy_5,$axis_y_3,$n                   # 148e
        fnms    $n_2,$dy_4,$axis_y_3,$n_2               # 149e

        fs      $ox_11,$ox_8,$apex_x_2                  # 150e
        fm      $r2_4,$ox_9,$ox_9                       # 151e

        fs      $oy_7,$oy_7,$apex_y                     # 152e
        fma     $r2_2,$oz_10,$oz_10,$r2_2               # 153e

        fnms    $n,$dz_5,$axis_z_3,$n                   # 154e
        fnms    $n_2,$dz_3,$axis_z_3,$n_2               # 155e

        fma     $r2_5,$oz_9,$oz_9,$r2_3                 # 156e
        fs      $oz,$oz_11,$apex_z                      # 157e

        fma     $r2_6,$oy_7,$oy_7,$r2_4                 # 158e
        and     $top+2,$r2_2,$there                     # 159e

        fma     $dx_2,$n,$axis_x_2,$dx_2                # 160e
        fma     $dx_4,$n_2,$axis_x_2,$dx_4              # 161e

        fma     $dy_6,$n,$axis_y_3,$dy_5                # 162e
        fma     $dz,$n,$axis_z_3,$dz_5                  # 163e

        fma     $dy_4,$n_2,$axis_y_3,$dy_4              # 164e
        and     $r2_2,$r2_5,$there1_2                   # 165e

        fm      $l2,$dx_2,$dx_2                         # 166e
        fm      $l2_2,$dx_4,$dx_4                       # 167e

        fma     $r2_6,$oz,$oz,$r2_6                     # 168e
        andc    $ox_12,$apex_x_2,$m_sign                # 169e

        fma     $dz_6,$n_2,$axis_z_3,$dz_3              # 170e
        fnms    $n_3,$dx_5,$axis_x_2,$k_zero            # 171e

        fma     $l2,$dy_6,$dy_6,$l2                     # 172e
        fm      $r2_7,$ox_11,$ox_11                     # 173e

        fma     $l2_3,$dy_4,$dy_4,$l2_2                 # 174e
        fs      $oz_12,$oz_3,$apex_z                    # 175e

        andc    $oy_10,$apex_y,$m_sign                  # 176e
        fcgt    $c_greater,$top+2,$r2_2                 # 177e

        fma     $l2,$dz,$dz,$l2                         # 178e
        fma     $r2_8,$oy_9,$oy_9,$r2_7                 # 179e

        fa      $ox_12,$ox_12,$oy_10                    # 180e
        and     $r2_6,$r2_6,$there+2                    # 181e

        andc    $oz_13,$apex_z,$m_sign                  # 182e
        fnms    $n_3,$dy_3,$axis_y_3,$n_3               # 183e

        selb    $top+2,$r2_2,$top+2,$c_greater          # 184e
        fma     $r2_8,$oz_12,$oz_12,$r2_8               # 185e

        and     $l2_4,$l2,$there+2                      # 186e
        fma     $l2,$dz_6,$dz_6,$l2_3                   # 187e

        fnms    $n_4,$dx_3,$axis_x_2,$k_zero            # 188e
        fcgt    $c_greater,$top+2,$r2_6                 # 189e

        fa      $ox_13,$ox_12,$oz_13                    # 190e
        selb    $top+2,$r2_6,$top+2,$c_greater          # 191e

        and     $r2_6,$r2_8,$there+3                    # 192e
        selb    $n_5,$k_minus_one,$n,$there+2           # 193e

        fcgt    $c_greater,$top+2,$r2_6                 # 194e
        selb    $n_6,$k_minus_one,$n_2,$there+3         # 195e

        and     $l2_5,$l2,$there+3                      # 196e
        lnop                                            # 196o pairing

next_packet:
        ai      $a_packet_2,$a_packet,320               # 0e
        lqd     $t,416($a_packet)                       # 0o

            fnms    $n,$dz_4,$axis_z_3,$n_3             # 1e
        ai      $count,$count,-1                        # 2e

            selb    $top+2,$r2_6,$top+2,$c_greater      # 3e
            lnop                                        # 3o pairing

            fnms    $n_7,$dy_2,$axis_y_3,$n_4           # 4e
        lqd     $t_2,384($a_packet)                     # 4o

        cgti    $there+2,$t,-1                          # 6e
        lqd     $ox,192($a_packet)                      # 6o

            selb    $top,$k_minus_one,$n,$there         # 7e
        lqd     $oz,320($a_packet)                      # 7o

            fma     $dz,$n,$axis_z_3,$dz_4              # 8e
        lqd     $oy,256($a_packet)                      # 8o

            fma     $dy,$n,$axis_y_3,$dy_3              # 9e
        lqd     $t,432($a_packet)                       # 9o

            fma     $dx,$n,$axis_x_2,$dx_5              # 10e
        lqd     $t_3,400($a_packet)                     # 10o

        cgti    $there,$t_2,-1                          # 11e
        lqd     $ox_2,208($a_packet)                    # 11o

        and     $weight+2,$there+2,$k_one               # 12e
        lqd     $ox_4,224($a_packet)                    # 12o

        and     $weight,$there,$k_one                   # 13e
        lqd     $oy_2,272($a_packet)                    # 13o

            fnms    $n,$dz_2,$axis_z_3,$n_7             # 14e
        lqd     $oz_2,336($a_packet)                    # 14o

        cgti    $there+3,$t,-1                          # 15e
        lqd     $oy_4,288($a_packet)                    # 15o

        fm      $sum,$ox,$weight                        # 16e
        lqd     $ox,240($a_packet)                      # 16o

        fm      $sum+1,$oy,$weight                      # 17e
        lqd     $oz_4,352($a_packet)                    # 17o

        fm      $sum+2,$oz,$weight                      # 18e
        lqd     $oy,304($a_packet)                      # 18o

        and     $weight3_2,$there+3,$k_one              # 19e
        lqd     $oz_6,368($a_packet)                    # 19o

            selb    $n_8,$k_minus_one,$n,$there1_2      # 20e
        lqd     $oz_3,128($a_packet)                    # 20o

            fma     $dz_7,$n,$axis_z_3,$dz_2            # 21e
        lqd     $oy_3,64($a_packet)                     # 21o

        cgti    $there1_2,$t_3,-1                       # 22e
        lqd     $ox_3,0($a_packet)                      # 22o

            fma     $dx_6,$n,$axis_x_2,$dx_3            # 23e
        lqd     $oy_5,80($a_packet)                     # 23o

        fa      $t_e,$weight+2,$weight3_2               # 24e
        lqd     $oz_5,144($a_packet)                    # 24o

        and     $weight1_2,$there1_2,$k_one             # 25e
        lqd     $ox_5,16($a_packet)                     # 25o

        fm      $sum2_2,$oz_3,$weight                   # 26e
        lqd     $oy_6,96($a_packet)                     # 26o

        fm      $sum1_2,$oy_3,$weight                   # 27e
        lqd     $ox_6,32($a_packet)                     # 27o

        fa      $sum3_2,$weight,$weight1_2              # 28e
        lqd     $oz_7,160($a_packet)                    # 28o

        fma     $sum,$ox_2,$weight1_2,$sum              # 29e
        lqd     $ox_2,48($a_packet)                     # 29o

        fma     $sum+2,$oz_2,$weight1_2,$sum+2          # 30e
        lqd     $oy_7,112($a_packet)                    # 30o

        fma     $sum+1,$oy_2,$weight1_2,$sum+1          # 31e
        lqd     $dx_3,208($a_packet)                    # 31o

            fma     $dy_6,$n,$axis_y_3,$dy_2            # 32e
        lqd     $dx_5,192($a_packet)                    # 32o

        fm      $sum_2,$ox_3,$weight                    # 33e
        lqd     $dy_3,256($a_packet)                    # 33o

        fma     $sum2_2,$oz_5,$weight1_2,$sum2_2        # 34e
        lqd     $ox_8,48($a_packet)                     # 34o

        fma     $sum,$ox_4,$weight+2,$sum               # 35e
        lqd     $dx_4,240($a_packet)                    # 35o

        fma     $sum+2,$oz_4,$weight+2,$sum+2           # 36e
        lqd     $dx_2,224($a_packet)                    # 36o

        fma     $sum+1,$oy_4,$weight+2,$sum+1           # 37e
        lqd     $dy_4,304($a_packet)                    # 37o

        fma     $sum1_2,$oy_5,$weight1_2,$sum1_2        # 38e
        lqd     $dz_4,320($a_packet)                    # 38o

        fa      $sum3_2,$sum3_2,$t_e                    # 39e
        lqd     $dz_5,352($a_packet)                    # 39o

        fma     $sum_2,$ox_5,$weight1_2,$sum_2          # 40e
        lqd     $oz_8,176($a_packet)                    # 40o

        fma     $sum,$ox,$weight3_2,$sum                # 41e
        lqd     $dz_2,336($a_packet)                    # 41o

        fma     $sum+2,$oz_6,$weight3_2,$sum+2          # 42e
        lqd     $dy_5,288($a_packet)                    # 42o

        fma     $sum+1,$oy,$weight3_2,$sum+1            # 43e
        lqd     $ox_9,0($a_packet)                      # 43o

            fm      $l2,$dx_6,$dx_6                     # 44e
        lqd     $dz_3,368($a_packet)                    # 44o

        fma     $sum1_2,$oy_6,$weight+2,$sum1_2         # 45e
        lqd     $ox_7,32($a_packet)                     # 45o

        fma     $sum2_2,$oz_7,$weight+2,$sum2_2         # 46e
        lqd     $oy_6,80($a_packet)                     # 46o

        fma     $sum_2,$ox_6,$weight+2,$sum_2           # 47e
        lqd     $ox_10,16($a_packet)                    # 47o

            fcgt    $c_greater,$top,$n_8                # 48e
        shufb   $t_words2_2,$sum,$sum+2,$m_last         # 48o

            fm      $l2_6,$dx,$dx                       # 49e
        shufb   $t_words_2,$sum,$sum+2,$m_first         # 49o

            selb    $top,$n_8,$top,$c_greater           # 50e
        shufb   $t_words1_2,$sum+1,$sum3_2,$m_first     # 50o

            fma     $l2,$dy_6,$dy_6,$l2                 # 51e
        shufb   $t_words3_2,$sum+1,$sum3_2,$m_last      # 51o

        fma     $sum+1,$oy_7,$weight3_2,$sum1_2         # 52e
        lqd     $oy_7,96($a_packet)                     # 52o

        fma     $sum_3,$ox_2,$weight3_2,$sum_2          # 53e
        lqd     $oz_9,144($a_packet)                    # 53o

        fma     $sum2_3,$oz_8,$weight3_2,$sum2_2        # 54e
        shufb   $t_rows_2,$t_words_2,$t_words1_2,$m_first # 54o

            fma     $l2_6,$dy,$dy,$l2_6                 # 55e
        shufb   $t_rows3_2,$t_words2_2,$t_words3_2,$m_last # 55o

            fcgt    $c_greater,$top,$n_5                # 56e
        shufb   $t_rows1_2,$t_words_2,$t_words1_2,$m_last # 56o

            fma     $l2,$dz_7,$dz_7,$l2                 # 57e
        shufb   $t_rows2_2,$t_words2_2,$t_words3_2,$m_first # 57o

            selb    $top,$n_5,$top,$c_greater           # 58e
        shufb   $t_words+3,$sum+1,$sum3_2,$m_last       # 58o

        nop     $127                                    # 59e pairing
        shufb   $t_words+1,$sum+1,$sum3_2,$m_first      # 59o

        fa      $t_rows_3,$t_rows_2,$t_rows1_2          # 60e
        shufb   $t_words+2,$sum_3,$sum2_3,$m_last       # 60o

            fma     $l2_6,$dz,$dz,$l2_6                 # 61e
        shufb   $t_words,$sum_3,$sum2_3,$m_first        # 61o

            fcgt    $c_greater,$top,$n_6                # 62e
        lqd     $dy_2,272($a_packet)                    # 62o

        fa      $t_rows2_3,$t_rows2_2,$t_rows3_2        # 63e
        lqd     $oy_2,64($a_packet)                     # 63o

            and     $l2,$l2,$there1_3                   # 64e
        shufb   $t_rows2_4,$t_words+2,$t_words+3,$m_first # 64o

            selb    $top,$n_6,$top,$c_greater           # 65e
        shufb   $t_rows_4,$t_words,$t_words+1,$m_first  # 65o

        nop     $127                                    # 66e pairing
        shufb   $t_rows1_3,$t_words,$t_words+1,$m_last  # 66o

            and     $top+1,$l2_6,$there_2               # 67e
        shufb   $t_rows3_3,$t_words+2,$t_words+3,$m_last # 67o

        nop     $127                                    # 68e pairing
        lqd     $oy_8,112($a_packet)                    # 68o

        fa      $t_rows_5,$t_rows_3,$t_rows2_3          # 69e
        shlqbyi $there1_3,$there1_2,0                   # 69o copy

        fa      $t_rows_4,$t_rows_4,$t_rows1_3          # 70e
            shufb   $t_words+2,$top,$top+2,$m_last      # 70o

        fa      $t_rows2_4,$t_rows2_4,$t_rows3_3        # 71e
            shufb   $t_words,$top,$top+2,$m_first       # 71o

            fcgt    $c_greater,$top+1,$l2               # 72e
        lqd     $t,400($a_packet)                       # 72o

        nop     $127                                    # 73e pairing
        lqd     $top3_2,384($a_packet)                  # 73o

            selb    $top+1,$l2,$top+1,$c_greater        # 74e
        shlqbyi $there_2,$there,0                       # 74o copy

        nop     $127                                    # 75e pairing
        lqd     $oz_10,128($a_packet)                   # 75o

            fcgt    $c_greater,$top+1,$l2_4             # 76e
        lqd     $t_4,416($a_packet)                     # 76o

        fa      $t_rows_6,$t_rows_4,$t_rows2_4          # 77e
        shufb   $axis_z_2,$t_rows_5,$t_rows_5,$m_z      # 77o

            selb    $top+1,$l2_4,$top+1,$c_greater      # 78e
        shufb   $axis_y_2,$t_rows_5,$t_rows_5,$m_y      # 78o

        fcgt    $c_greater,$top3_2,$t                   # 79e
        shufb   $axis_x,$t_rows_5,$t_rows_5,$m_x        # 79o

            fcgt    $c_greater_2,$top+1,$l2_5           # 80e
        lqd     $oz_3,176($a_packet)                    # 80o

        selb    $top3_2,$t,$top3_2,$c_greater           # 81e
        lqd     $oz_11,160($a_packet)                   # 81o

            selb    $top+1,$l2_5,$top+1,$c_greater_2    # 82e
        lqd     $t,432($a_packet)                       # 82o

        fm      $length_2,$axis_x,$axis_x               # 83e
        shufb   $rays,$t_rows_6,$t_rows_6,$m_w          # 83o

        fcgt    $c_greater,$top3_2,$t_4                 # 84e
            shufb   $t_words3_3,$top+1,$top3_3,$m_last  # 84o

        ai      $a_packet,$a_packet_2,320               # 85e
            shufb   $t_words1_3,$top+1,$top3_3,$m_first # 85o

        selb    $top3_2,$t_4,$top3_2,$c_greater         # 86e
        frest   $t_y_2,$rays                            # 87o

            nop     $127                                # 88e pairing
            shufb   $top+2,$t_words+2,$t_words3_3,$m_first # 88o

        fcgt    $c_greater,$top3_2,$t                   # 89e
            shufb   $top3_4,$t_words+2,$t_words3_3,$m_last # 89o

        fma     $length_2,$axis_y_2,$axis_y_2,$length_2 # 90e
            shufb   $top+1,$t_words,$t_words1_3,$m_last # 90o

        selb    $top3_3,$t,$top3_2,$c_greater           # 91e
            shufb   $top,$t_words,$t_words1_3,$m_first  # 91o

        fi      $t_y_3,$rays,$t_y_2                     # 92e
            fcgt    $c_greater,$top+2,$top3_4           # 93e

            selb    $top+2,$top3_4,$top+2,$c_greater    # 95e
        fma     $length_2,$axis_z_2,$axis_z_2,$length_2 # 96e squared

            fcgt    $c_greater,$top,$top+1              # 97e
        fnms    $t_e,$rays,$t_y_3,$k_one                # 99e

            selb    $top,$top+1,$top,$c_greater         # 100e
            lnop                                        # 100o pairing

            fcgt    $c_greater,$top,$top+2              # 102e
        frsqest $t_y_4,$length_2                        # 102o

            selb    $top,$top+2,$top,$c_greater         # 104e
        fma     $inverse_2,$t_e,$t_y_3,$t_y_3           # 105e

        fi      $t_y_4,$length_2,$t_y_4                 # 106e
            shufb   $n,$top,$top,$m_x                   # 106o

            frsqest $t_y_2,$top                         # 107o
            shufb   $farthest,$top,$top,$m_w            # 108o

            fm      $cosine,$n,$k_shrunk                # 110e
        fm      $inverse_2,$t_rows_6,$inverse_2         # 111e

            fcgt    $c_wide,$n,$k_wide                  # 112e
            stqd    $farthest,144($a_bound)             # 112o

        fm      $t_e,$length_2,$t_y_4                   # 113e
            andc    $axis_z_4,$axis_z_3,$c_wide         # 114e

            fi      $t_y_5,$top,$t_y_2                  # 115e
            lnop                                        # 115o pairing

            andc    $cosine,$cosine,$c_wide             # 116e
            stqd    $axis_z_4,80($a_bound)              # 116o

            andc    $axis_y_4,$axis_y_3,$c_wide         # 117e
        shufb   $apex_x_2,$inverse_2,$inverse_2,$m_x    # 117o

        fm      $inverse_3,$t_y_4,$k_half               # 118e
        shufb   $apex_z,$inverse_2,$inverse_2,$m_z      # 118o

        fnms    $t_e,$t_e,$t_y_4,$k_one                 # 119e
        shufb   $apex_y,$inverse_2,$inverse_2,$m_y      # 119o

            andc    $axis_x_3,$axis_x_2,$c_wide         # 120e
            stqd    $axis_y_4,64($a_bound)              # 120o

        fs      $ox_2,$ox_9,$apex_x_2                   # 121e
            stqd    $cosine,96($a_bound)                # 121o

        fs      $ox_10,$ox_10,$apex_x_2                 # 122e
        fs      $ox_9,$ox_7,$apex_x_2                   # 123e

        fs      $oy_2,$oy_2,$apex_y                     # 124e
        lnop                                            # 124o pairing

        fma     $inverse_4,$t_e,$inverse_3,$t_y_4       # 125e
            stqd    $axis_x_3,48($a_bound)              # 125o

        fs      $oy_9,$oy_8,$apex_y                     # 126e
        fs      $oy_7,$oy_7,$apex_y                     # 127e

        fs      $oz_10,$oz_10,$apex_z                   # 128e
        fm      $r2_4,$ox_9,$ox_9                       # 129e

        fs      $oy_8,$oy_6,$apex_y                     # 130e
        fm      $axis_x_2,$axis_x,$inverse_4            # 131e

        fm      $axis_y_3,$axis_y_2,$inverse_4          # 132e
        fs      $oz_9,$oz_9,$apex_z                     # 133e

        fm      $r2_2,$ox_2,$ox_2                       # 134e
        fm      $r2_3,$ox_10,$ox_10                     # 135e

        fm      $axis_z_3,$axis_z_2,$inverse_4          # 136e
        fnms    $n,$dx_2,$axis_x_2,$k_zero              # 137e

        fnms    $n_3,$dx_5,$axis_x_2,$k_zero            # 138e
        fnms    $n_4,$dx_3,$axis_x_2,$k_zero            # 139e

        fnms    $n_2,$dx_4,$axis_x_2,$k_zero            # 140e
        fma     $r2_3,$oy_8,$oy_8,$r2_3                 # 141e

            fm      $t_e,$top,$t_y_5                    # 142e
        fnms    $n,$dy_5,$axis_y_3,$n                   # 143e

            fm      $t_y_5,$t_y_5,$k_half               # 144e
        andc    $ox_12,$apex_x_2,$m_sign                # 145e

        fnms    $n_2,$dy_4,$axis_y_3,$n_2               # 146e
        andc    $oy_10,$apex_y,$m_sign                  # 147e

            fnms    $root_2,$t_e,$t_e,$top              # 148e
        fnms    $n,$dz_5,$axis_z_3,$n                   # 149e

        fa      $ox_12,$ox_12,$oy_10                    # 150e
        andc    $oz_13,$apex_z,$m_sign                  # 151e

        fnms    $n_2,$dz_3,$axis_z_3,$n_2               # 152e
        fnms    $n_3,$dy_3,$axis_y_3,$n_3               # 153e

            fma     $root_3,$root_2,$t_y_5,$t_e         # 154e
        fma     $dx_2,$n,$axis_x_2,$dx_2                # 155e

        fs      $ox_11,$ox_8,$apex_x_2                  # 156e
        fma     $r2_2,$oy_2,$oy_2,$r2_2                 # 157e

        fma     $dx_4,$n_2,$axis_x_2,$dx_4              # 158e
        selb    $n_5,$k_minus_one,$n,$there+2           # 159e

        fma     $dy_6,$n,$axis_y_3,$dy_5                # 160e
            shufb   $radius_2,$root_3,$root_3,$m_z      # 160o

        fm      $l2,$dx_2,$dx_2                         # 161e
            shufb   $sine_2,$root_3,$root_3,$m_y        # 161o

        fma     $r2_2,$oz_10,$oz_10,$r2_2               # 163e
        fma     $r2_6,$oy_7,$oy_7,$r2_4                 # 164e

        fma     $dz,$n,$axis_z_3,$dz_5                  # 165e
        fm      $l2_2,$dx_4,$dx_4                       # 166e

        fma     $dz_6,$n_2,$axis_z_3,$dz_3              # 167e
        fma     $r2_5,$oz_9,$oz_9,$r2_3                 # 168e

        fma     $dy_4,$n_2,$axis_y_3,$dy_4              # 169e
        fma     $l2,$dy_6,$dy_6,$l2                     # 170e

        fm      $r2_7,$ox_11,$ox_11                     # 171e
            fm      $radius_3,$radius_2,$k_grown        # 172e

        fs      $oz,$oz_11,$apex_z                      # 173e
        and     $top+2,$r2_2,$there                     # 174e

        and     $r2_2,$r2_5,$there1_2                   # 175e
        fma     $l2_3,$dy_4,$dy_4,$l2_2                 # 176e

        fcgt    $c_greater,$top+2,$r2_2                 # 177e
            fma     $radius_4,$ox_13,$k_slack,$radius_3 # 178e

        fs      $oz_12,$oz_3,$apex_z                    # 179e
        fma     $r2_6,$oz,$oz,$r2_6                     # 180e

        fma     $l2,$dz,$dz,$l2                         # 181e
        fa      $ox_13,$ox_12,$oz_13                    # 182e

        fma     $r2_8,$oy_9,$oy_9,$r2_7                 # 183e
            or      $radius_4,$radius_4,$none_2         # 184e all ones is the largest single below

            fa      $sine_3,$sine_2,$k_slack            # 185e
        hbrr    next_packet_back,next_packet            # 185o hint

        and     $r2_6,$r2_6,$there+2                    # 186e
            stqd    $radius_4,128($a_bound)             # 186o

        selb    $top+2,$r2_2,$top+2,$c_greater          # 187e
        ceqi    $none_2,$rays,0                         # 188e

        fcgt    $c_greater,$top+2,$r2_6                 # 189e
        and     $l2_4,$l2,$there+2                      # 190e

        fma     $r2_8,$oz_12,$oz_12,$r2_8               # 191e
        selb    $top+2,$r2_6,$top+2,$c_greater          # 192e

        fma     $l2,$dz_6,$dz_6,$l2_3                   # 193e
            andc    $sine_4,$sine_3,$c_wide             # 194e

        selb    $n_6,$k_minus_one,$n_2,$there+3         # 195e
            stqd    $sine_4,112($a_bound)               # 196o

            ai      $a_bound,$a_bound,160               # 197e
        and     $r2_6,$r2_8,$there+3                    # 198e

        and     $l2_5,$l2,$there+3                      # 199e
        stqd    $apex_x_2,0($a_bound)                   # 199o

        fcgt    $c_greater,$top+2,$r2_6                 # 200e
        stqd    $apex_y,16($a_bound)                    # 200o

        stqd    $apex_z,32($a_bound)                    # 201o
next_packet_back:
        brnz    $count,next_packet                      # 202o

next_packet_drain:
        fnms    $n_9,$dy_2,$axis_y_3,$n_4               # 0e
        hbr     bound_r16_return,$lr                    # 0o hint

        fnms    $n,$dz_4,$axis_z_3,$n_3                 # 1e
        selb    $top+2,$r2_6,$top+2,$c_greater          # 2e

        ai      $a_bound_2,$a_bound,160                 # 3e
        fnms    $n_9,$dz_2,$axis_z_3,$n_9               # 6e

        fma     $dx,$n,$axis_x_2,$dx_5                  # 7e
        fma     $dy,$n,$axis_y_3,$dy_3                  # 8e

        fma     $dz,$n,$axis_z_3,$dz_4                  # 9e
        selb    $top,$k_minus_one,$n,$there             # 10e

        fma     $dx_6,$n_9,$axis_x_2,$dx_3              # 12e
        fma     $dy_6,$n_9,$axis_y_3,$dy_2              # 13e

        fm      $l2_6,$dx,$dx                           # 14e
        fma     $dz_7,$n_9,$axis_z_3,$dz_2              # 15e

        selb    $n_8,$k_minus_one,$n_9,$there1_2        # 16e
        fm      $l2,$dx_6,$dx_6                         # 18e

        fcgt    $c_greater,$top,$n_8                    # 19e
        fma     $l2_6,$dy,$dy,$l2_6                     # 20e

        selb    $top,$n_8,$top,$c_greater               # 21e
        fcgt    $c_greater,$top,$n_5                    # 23e

        fma     $l2,$dy_6,$dy_6,$l2                     # 24e
        selb    $top,$n_5,$top,$c_greater               # 25e

        fma     $l2_6,$dz,$dz,$l2_6                     # 26e
        fcgt    $c_greater,$top,$n_6                    # 27e

        selb    $top,$n_6,$top,$c_greater               # 29e
        fma     $l2,$dz_7,$dz_7,$l2                     # 30e

        nop     $127                                    # 31e pairing
        shufb   $t_words+2,$top,$top+2,$m_last          # 31o

        and     $top+1,$l2_6,$there_2                   # 32e
        shufb   $t_words,$top,$top+2,$m_first           # 32o

        and     $l2,$l2,$there1_3                       # 36e
        fcgt    $c_greater,$top+1,$l2                   # 38e

        selb    $top+1,$l2,$top+1,$c_greater            # 40e
        fcgt    $c_greater,$top+1,$l2_4                 # 42e

        selb    $top+1,$l2_4,$top+1,$c_greater          # 44e
        fcgt    $c_greater_2,$top+1,$l2_5               # 46e

        selb    $top+1,$l2_5,$top+1,$c_greater_2        # 48e
        shufb   $t_words3_3,$top+1,$top3_3,$m_last      # 50o

        shufb   $t_words1_3,$top+1,$top3_3,$m_first     # 51o
        shufb   $top+2,$t_words+2,$t_words3_3,$m_first  # 54o

        shufb   $top3_4,$t_words+2,$t_words3_3,$m_last  # 55o
        shufb   $top+1,$t_words,$t_words1_3,$m_last     # 56o

        shufb   $top,$t_words,$t_words1_3,$m_first      # 57o
        fcgt    $c_greater,$top+2,$top3_4               # 59e

        fcgt    $c_greater_3,$top,$top+1                # 61e
        selb    $top+2,$top3_4,$top+2,$c_greater        # 62e

        selb    $top,$top+1,$top,$c_greater_3           # 63e
        fcgt    $c_greater,$top,$top+2                  # 65e

        selb    $top,$top+2,$top,$c_greater             # 67e
        frsqest $t_y_2,$top                             # 69o

        shufb   $n,$top,$top,$m_x                       # 70o
        shufb   $farthest,$top,$top,$m_w                # 71o

        fi      $t_y_5,$top,$t_y_2                      # 73e
        fcgt    $c_wide,$n,$k_wide                      # 74e

        fm      $cosine,$n,$k_shrunk                    # 75e
        stqd    $farthest,144($a_bound)                 # 75o

        andc    $axis_z_4,$axis_z_3,$c_wide             # 76e
        andc    $axis_y_5,$axis_y_3,$c_wide             # 77e

        andc    $axis_x_4,$axis_x_2,$c_wide             # 78e
        stqd    $axis_z_4,80($a_bound)                  # 78o

        stqd    $axis_y_5,64($a_bound)                  # 79o
        fm      $t_e,$top,$t_y_5                        # 80e

        fm      $t_y_5,$t_y_5,$k_half                   # 81e
        andc    $cosine,$cosine,$c_wide                 # 82e

        stqd    $cosine,96($a_bound)                    # 84o
        stqd    $axis_x_4,48($a_bound)                  # 85o

        fnms    $root_2,$t_e,$t_e,$top                  # 86e
        fma     $root_3,$root_2,$t_y_5,$t_e             # 92e

        shufb   $radius_2,$root_3,$root_3,$m_z          # 98o
        shufb   $sine_2,$root_3,$root_3,$m_y            # 99o

        fm      $radius_3,$radius_2,$k_grown            # 102e
        fa      $sine_3,$sine_2,$k_slack                # 103e

        fma     $radius_4,$ox_13,$k_slack,$radius_3     # 108e
        andc    $sine_4,$sine_3,$c_wide                 # 109e

        or      $radius_4,$radius_4,$none_2             # 114e all ones is the largest single below
        stqd    $radius_4,128($a_bound)                 # 116o

        stqd    $sine_4,112($a_bound)                   # 117o
bound_r16_return:
        bi      $lr                                     # 118o

next_packet_short:
        ai      $count,$count,-1                        # 0e
        lqd     $t,400($a_packet)                       # 0o

        ai      $a_packet_2,$a_packet,320               # 1e
        lqd     $t_5,384($a_packet)                     # 1o

        lqd     $oy,272($a_packet)                      # 2o
        lqd     $t_2,432($a_packet)                     # 3o

        lqd     $oy_11,256($a_packet)                   # 4o
        lqd     $oz,320($a_packet)                      # 5o

        cgti    $there+1,$t,-1                          # 6e
        lqd     $ox,192($a_packet)                      # 6o

        cgti    $there,$t_5,-1                          # 7e
        lqd     $oz_2,352($a_packet)                    # 7o

        and     $weight+1,$there+1,$k_one               # 8e
        lqd     $t,416($a_packet)                       # 8o

        and     $weight,$there,$k_one                   # 9e
        lqd     $oz_14,336($a_packet)                   # 9o

        cgti    $there+3,$t_2,-1                        # 10e
        lqd     $ox_2,208($a_packet)                    # 10o

        fm      $sum+1,$oy_11,$weight                   # 11e
        lqd     $ox_3,224($a_packet)                    # 11o

        fm      $sum+2,$oz,$weight                      # 12e
        lqd     $oy_12,288($a_packet)                   # 12o

        fm      $sum,$ox,$weight                        # 13e
        lqd     $ox,240($a_packet)                      # 13o

        and     $weight+3,$there+3,$k_one               # 14e
        lqd     $oy_13,304($a_packet)                   # 14o

        fa      $sum+3,$weight,$weight+1                # 15e
        lqd     $oz,368($a_packet)                      # 15o

        cgti    $there2_2,$t,-1                         # 16e
        lqd     $oz_15,128($a_packet)                   # 16o

        fma     $sum+1,$oy,$weight+1,$sum+1             # 17e
        lqd     $ox_9,16($a_packet)                     # 17o

        fma     $sum+2,$oz_14,$weight+1,$sum+2          # 18e
        lqd     $oz_14,144($a_packet)                   # 18o

        fma     $sum,$ox_2,$weight+1,$sum               # 19e
        lqd     $oy_14,64($a_packet)                    # 19o

        and     $weight2_2,$there2_2,$k_one             # 20e
        lqd     $ox_14,0($a_packet)                     # 20o

        nop     $127                                    # 21e pairing
        lqd     $oy_15,80($a_packet)                    # 21o

        fa      $t_e,$weight2_2,$weight+3               # 22e
        lqd     $oy_16,96($a_packet)                    # 22o

        fma     $sum+1,$oy_12,$weight2_2,$sum+1         # 23e
        lqd     $oz_16,160($a_packet)                   # 23o

        fma     $sum+2,$oz_2,$weight2_2,$sum+2          # 24e
        lqd     $oy_7,112($a_packet)                    # 24o

        fma     $sum,$ox_3,$weight2_2,$sum              # 25e
        lqd     $ox_3,32($a_packet)                     # 25o

        fm      $sum_4,$ox_14,$weight                   # 26e
        lqd     $oz_11,176($a_packet)                   # 26o

        fm      $sum2_4,$oz_15,$weight                  # 27e
        lqd     $ox_15,48($a_packet)                    # 27o

        fa      $sum+3,$sum+3,$t_e                      # 28e
        lqd     $dx_6,208($a_packet)                    # 28o

        fma     $sum+1,$oy_13,$weight+3,$sum+1          # 29e
        lqd     $dx_7,224($a_packet)                    # 29o

        fma     $sum+2,$oz,$weight+3,$sum+2             # 30e
        lqd     $dy_7,256($a_packet)                    # 30o

        fma     $sum,$ox,$weight+3,$sum                 # 31e
        lqd     $dx_8,192($a_packet)                    # 31o

        fma     $sum_5,$ox_9,$weight+1,$sum_4           # 32e
        lqd     $ox_14,16($a_packet)                    # 32o

        fm      $sum1_3,$oy_14,$weight                  # 33e
        lqd     $dy_3,272($a_packet)                    # 33o

        fma     $sum2_5,$oz_14,$weight+1,$sum2_4        # 34e
        lqd     $dy,288($a_packet)                      # 34o

        shufb   $t_words1_4,$sum+1,$sum+3,$m_first      # 35o
        shufb   $t_words3_4,$sum+1,$sum+3,$m_last       # 36o

        nop     $127                                    # 37e pairing
        shufb   $t_words2_3,$sum,$sum+2,$m_last         # 37o

        fma     $sum_2,$ox_3,$weight2_2,$sum_5          # 38e
        shufb   $t_words_3,$sum,$sum+2,$m_first         # 38o

        fma     $sum1_3,$oy_15,$weight+1,$sum1_3        # 39e
        lqd     $dy_4,304($a_packet)                    # 39o

        fma     $sum+2,$oz_16,$weight2_2,$sum2_5        # 40e
        lqd     $dz_8,336($a_packet)                    # 40o

        shufb   $t_rows2_5,$t_words2_3,$t_words3_4,$m_first # 41o
        shufb   $t_rows1_2,$t_words_3,$t_words1_4,$m_last # 42o

        nop     $127                                    # 43e pairing
        shufb   $t_rows+3,$t_words2_3,$t_words3_4,$m_last # 43o

        fma     $sum_2,$ox_15,$weight+3,$sum_2          # 44e
        shufb   $t_rows,$t_words_3,$t_words1_4,$m_first # 44o

        fma     $sum+1,$oy_16,$weight2_2,$sum1_3        # 45e
        lqd     $dx_9,240($a_packet)                    # 45o

        fma     $sum+2,$oz_11,$weight+3,$sum+2          # 46e
        lqd     $dz,352($a_packet)                      # 46o

        fa      $t_rows+2,$t_rows2_5,$t_rows+3          # 47e
        lqd     $dz_9,320($a_packet)                    # 47o

        fa      $t_rows,$t_rows,$t_rows1_2              # 48e
        lqd     $oy,80($a_packet)                       # 48o

        lqd     $ox_16,32($a_packet)                    # 49o
        lqd     $ox_17,0($a_packet)                     # 50o

        fma     $sum+1,$oy_7,$weight+3,$sum+1           # 51e
        lqd     $dz_10,368($a_packet)                   # 51o

        shufb   $t_words+2,$sum_2,$sum+2,$m_last        # 52o
        shufb   $t_words_4,$sum_2,$sum+2,$m_first       # 53o

        fa      $t_rows,$t_rows,$t_rows+2               # 54e
        lqd     $ox_18,48($a_packet)                    # 54o

        lqd     $oy_17,112($a_packet)                   # 55o
        lqd     $oz_11,144($a_packet)                   # 56o

        shufb   $t_words1_4,$sum+1,$sum+3,$m_first      # 57o
        shufb   $t_words3_4,$sum+1,$sum+3,$m_last       # 58o

        lqd     $oy_18,64($a_packet)                    # 59o
        shufb   $axis_x,$t_rows,$t_rows,$m_x            # 60o

        shufb   $axis_y,$t_rows,$t_rows,$m_y            # 61o
        shufb   $axis_z,$t_rows,$t_rows,$m_z            # 62o

        nop     $127                                    # 63e pairing
        shufb   $t_rows,$t_words_4,$t_words1_4,$m_first # 63o

        fm      $length,$axis_x,$axis_x                 # 64e
        shufb   $t_rows2_6,$t_words+2,$t_words3_4,$m_first # 64o

        shufb   $t_rows3_4,$t_words+2,$t_words3_4,$m_last # 65o
        shufb   $t_rows1_4,$t_words_4,$t_words1_4,$m_last # 66o

        lqd     $oy_16,96($a_packet)                    # 67o
        lqd     $oz_17,128($a_packet)                   # 68o

        fa      $t_rows2_7,$t_rows2_6,$t_rows3_4        # 69e
        lqd     $oz_5,160($a_packet)                    # 69o

        fma     $length,$axis_y,$axis_y,$length         # 70e
        lqd     $oz_8,176($a_packet)                    # 70o

        fa      $t_rows,$t_rows,$t_rows1_4              # 71e
        lqd     $t,400($a_packet)                       # 71o

        lqd     $t_3,416($a_packet)                     # 72o
        lqd     $t_6,432($a_packet)                     # 73o

        lqd     $top+3,384($a_packet)                   # 74o
        ai      $a_packet,$a_packet_2,320               # 75e

        fma     $length,$axis_z,$axis_z,$length         # 76e squared
        fa      $t_rows,$t_rows,$t_rows2_7              # 77e

        fcgt    $c_greater,$top+3,$t                    # 80e
        lnop                                            # 80o pairing

        selb    $top+3,$t,$top+3,$c_greater             # 82e
        frsqest $t_y,$length                            # 82o

        shufb   $rays_2,$t_rows,$t_rows,$m_w            # 83o
        fcgt    $c_greater,$top+3,$t_3                  # 84e

        fi      $t_y,$length,$t_y                       # 86e
        lnop                                            # 86o pairing

        selb    $top+3,$t_3,$top+3,$c_greater           # 87e
        frest   $t_y_6,$rays_2                          # 87o

        ceqi    $none,$rays_2,0                         # 88e
        fcgt    $c_greater,$top+3,$t_6                  # 89e

        fi      $t_y_6,$rays_2,$t_y_6                   # 91e
        selb    $top+3,$t_6,$top+3,$c_greater           # 92e

        fm      $t_e,$length,$t_y                       # 93e
        fm      $inverse,$t_y,$k_half                   # 94e

        fnms    $t_e_2,$rays_2,$t_y_6,$k_one            # 98e
        fnms    $t_e,$t_e,$t_y,$k_one                   # 99e

        fma     $inverse_2,$t_e_2,$t_y_6,$t_y_6         # 104e
        fma     $inverse,$t_e,$inverse,$t_y             # 105e

        fm      $inverse_2,$t_rows,$inverse_2           # 110e
        fm      $axis_x,$axis_x,$inverse                # 111e

        fm      $axis_y,$axis_y,$inverse                # 112e
        fm      $axis_z,$axis_z,$inverse                # 113e

        nop     $127                                    # 114e pairing
        shufb   $apex_x,$inverse_2,$inverse_2,$m_x      # 116o

        fnms    $n,$dx_8,$axis_x,$k_zero                # 117e
        shufb   $apex_y,$inverse_2,$inverse_2,$m_y      # 117o

        fnms    $n_10,$dx_6,$axis_x,$k_zero             # 118e
        shufb   $apex_z,$inverse_2,$inverse_2,$m_z      # 118o

        fnms    $n_9,$dx_7,$axis_x,$k_zero              # 119e
        lnop                                            # 119o pairing

        fnms    $n_11,$dx_9,$axis_x,$k_zero             # 120e
        stqd    $apex_x,0($a_bound)                     # 120o

        fs      $oy,$oy,$apex_y                         # 121e
        stqd    $apex_y,16($a_bound)                    # 121o

        fs      $ox_17,$ox_17,$apex_x                   # 122e
        stqd    $apex_z,32($a_bound)                    # 122o

        fnms    $n,$dy_7,$axis_y,$n                     # 123e
        fnms    $n_10,$dy_3,$axis_y,$n_10               # 124e

        fnms    $n_9,$dy,$axis_y,$n_9                   # 125e
        fnms    $n_11,$dy_4,$axis_y,$n_11               # 126e

        fs      $ox_14,$ox_14,$apex_x                   # 127e
        fm      $r2,$ox_17,$ox_17                       # 128e

        fnms    $n,$dz_9,$axis_z,$n                     # 129e
        fnms    $n_10,$dz_8,$axis_z,$n_10               # 130e

        fs      $ox_16,$ox_16,$apex_x                   # 131e
        fnms    $n_9,$dz,$axis_z,$n_9                   # 132e

        fnms    $n_11,$dz_10,$axis_z,$n_11              # 133e
        fs      $oy_18,$oy_18,$apex_y                   # 134e

        fma     $dx_8,$n,$axis_x,$dx_8                  # 135e
        fma     $dx_10,$n_10,$axis_x,$dx_6              # 136e

        fma     $dy_7,$n,$axis_y,$dy_7                  # 137e
        fma     $dx_7,$n_9,$axis_x,$dx_7                # 138e

        fma     $dx_9,$n_11,$axis_x,$dx_9               # 139e
        fs      $oy_16,$oy_16,$apex_y                   # 140e

        fm      $l2,$dx_8,$dx_8                         # 141e
        fm      $l2_7,$dx_10,$dx_10                     # 142e

        fs      $oz_3,$oz_17,$apex_z                    # 143e
        fs      $oy_17,$oy_17,$apex_y                   # 144e

        fm      $l2_8,$dx_7,$dx_7                       # 145e
        fs      $oz_11,$oz_11,$apex_z                   # 146e

        fm      $r2_9,$ox_14,$ox_14                     # 147e
        fma     $dy_3,$n_10,$axis_y,$dy_3               # 148e

        fma     $dy,$n_9,$axis_y,$dy                    # 149e
        fma     $dz_8,$n_10,$axis_z,$dz_8               # 150e

        fs      $ox_18,$ox_18,$apex_x                   # 151e
        fm      $l2_9,$dx_9,$dx_9                       # 152e

        fma     $l2,$dy_7,$dy_7,$l2                     # 153e
        fm      $r2_10,$ox_16,$ox_16                    # 154e

        fs      $oz_18,$oz_8,$apex_z                    # 155e
        fma     $dz_10,$n_11,$axis_z,$dz_10             # 156e

        fma     $dz_9,$n,$axis_z,$dz_9                  # 157e
        fma     $l2_10,$dy_3,$dy_3,$l2_7                # 158e

        fma     $dy_4,$n_11,$axis_y,$dy_4               # 159e
        fma     $r2_11,$oy_16,$oy_16,$r2_10             # 160e

        fma     $r2_4,$oy,$oy,$r2_9                     # 161e
        fs      $oz,$oz_5,$apex_z                       # 162e

        fma     $r2,$oy_18,$oy_18,$r2                   # 163e
        fma     $l2_2,$dz_8,$dz_8,$l2_10                # 164e

        fma     $l2_10,$dy,$dy,$l2_8                    # 165e
        selb    $n_10,$k_minus_one,$n_10,$there+1       # 166e

        fma     $l2_9,$dy_4,$dy_4,$l2_9                 # 167e
        fm      $r2_12,$ox_18,$ox_18                    # 168e

        fma     $r2,$oz_3,$oz_3,$r2                     # 169e
        selb    $top,$k_minus_one,$n,$there             # 170e

        fma     $dz,$n_9,$axis_z,$dz                    # 171e
        fma     $r2_3,$oz_11,$oz_11,$r2_4               # 172e

        fma     $l2,$dz_9,$dz_9,$l2                     # 173e
        fma     $r2_13,$oy_17,$oy_17,$r2_12             # 174e

        and     $top+2,$r2,$there                       # 175e
        fma     $l2_11,$dz_10,$dz_10,$l2_9              # 176e

        fma     $l2_9,$dz,$dz,$l2_10                    # 177e
        and     $r2,$r2_3,$there+1                      # 178e

        and     $top+1,$l2,$there                       # 179e
        fma     $r2_14,$oz_18,$oz_18,$r2_13             # 180e

        fcgt    $c_greater,$top+2,$r2                   # 181e
        and     $l2,$l2_2,$there+1                      # 182e

        selb    $top+2,$r2,$top+2,$c_greater            # 183e
        fcgt    $c_greater,$top+1,$l2                   # 184e

        fma     $r2,$oz,$oz,$r2_11                      # 185e
        and     $l2_9,$l2_9,$there2_2                   # 186e

        selb    $n,$k_minus_one,$n_11,$there+3          # 187e
        selb    $n_9,$k_minus_one,$n_9,$there2_2        # 188e

        fcgt    $c_greater_4,$top,$n_10                 # 189e
        selb    $top+1,$l2,$top+1,$c_greater            # 190e

        selb    $top,$n_10,$top,$c_greater_4            # 191e
        and     $r2,$r2,$there2_2                       # 192e

        fcgt    $c_greater,$top+1,$l2_9                 # 193e
        fcgt    $c_greater_5,$top+2,$r2                 # 194e

        and     $r2_15,$r2_14,$there+3                  # 195e
        selb    $top+2,$r2,$top+2,$c_greater_5          # 196e

        fcgt    $c_greater_5,$top,$n_9                  # 197e
        selb    $top+1,$l2_9,$top+1,$c_greater          # 198e

        selb    $top,$n_9,$top,$c_greater_5             # 199e
        hbrr    next_packet_short_back,next_packet_short # 199o hint

        and     $l2,$l2_11,$there+3                     # 200e
        fcgt    $c_greater,$top,$n                      # 201e

        fcgt    $c_greater_3,$top+1,$l2                 # 202e
        selb    $top,$n,$top,$c_greater                 # 203e

        fcgt    $c_greater,$top+2,$r2_15                # 204e
        selb    $top+1,$l2,$top+1,$c_greater_3          # 205e

        selb    $top+2,$r2_15,$top+2,$c_greater         # 206e
        lnop                                            # 206o pairing

        andc    $oy,$apex_y,$m_sign                     # 207e
        shufb   $t_words+1,$top+1,$top+3,$m_first       # 207o

        andc    $ox,$apex_x,$m_sign                     # 208e
        shufb   $t_words,$top,$top+2,$m_first           # 208o

        andc    $oz,$apex_z,$m_sign                     # 209e
        shufb   $t_words+2,$top,$top+2,$m_last          # 209o

        fa      $ox,$ox,$oy                             # 210e
        shufb   $t_words+3,$top+1,$top+3,$m_last        # 210o

        shufb   $top+1,$t_words,$t_words+1,$m_last      # 212o
        shufb   $top,$t_words,$t_words+1,$m_first       # 213o

        shufb   $top+2,$t_words+2,$t_words+3,$m_first   # 214o
        shufb   $top+3,$t_words+2,$t_words+3,$m_last    # 215o

        fa      $ox,$ox,$oz                             # 216e
        fcgt    $c_greater,$top,$top+1                  # 217e

        fcgt    $c_greater_3,$top+2,$top+3              # 219e
        selb    $top,$top+1,$top,$c_greater             # 220e

        selb    $top+2,$top+3,$top+2,$c_greater_3       # 221e
        fcgt    $c_greater,$top,$top+2                  # 223e

        selb    $top,$top+2,$top,$c_greater             # 225e
        frsqest $t_y,$top                               # 227o

        shufb   $n,$top,$top,$m_x                       # 228o
        shufb   $farthest,$top,$top,$m_w                # 229o

        fi      $t_y,$top,$t_y                          # 231e
        fcgt    $c_wide,$n,$k_wide                      # 232e

        fm      $cosine,$n,$k_shrunk                    # 233e
        stqd    $farthest,144($a_bound)                 # 233o

        andc    $axis_y,$axis_y,$c_wide                 # 234e
        andc    $axis_x,$axis_x,$c_wide                 # 235e

        andc    $axis_z,$axis_z,$c_wide                 # 236e
        stqd    $axis_y,64($a_bound)                    # 236o

        nop     $127                                    # 237e pairing
        stqd    $axis_x,48($a_bound)                    # 237o

        fm      $t_e,$top,$t_y                          # 238e
        stqd    $axis_z,80($a_bound)                    # 238o

        fm      $t_y,$t_y,$k_half                       # 239e
        andc    $cosine,$cosine,$c_wide                 # 240e

        stqd    $cosine,96($a_bound)                    # 242o
        fnms    $root,$t_e,$t_e,$top                    # 244e

        fma     $root,$root,$t_y,$t_e                   # 250e
        shufb   $radius,$root,$root,$m_z                # 256o

        shufb   $sine,$root,$root,$m_y                  # 257o
        fm      $radius,$radius,$k_grown                # 260e

        fa      $sine,$sine,$k_slack                    # 261e
        fma     $radius,$ox,$k_slack,$radius            # 266e

        andc    $sine,$sine,$c_wide                     # 267e
        stqd    $sine,112($a_bound)                     # 269o

        or      $radius,$radius,$none                   # 272e all ones is the largest single below
        stqd    $radius,128($a_bound)                   # 274o

        ai      $a_bound,$a_bound,160                   # 275e
next_packet_short_back:
        brnz    $count,next_packet_short                # 275o

        nop     $127                                    # 276e pairing
        bi      $lr                                     # 276o
endfunction bound_r16
