# isect_pairs_factored_r16   nearest entry of packets' eye rays into spheres, by (r - l)(r + l)
#   C       void isect_pairs_factored_r16(const struct pair *, int count);
#   In      $3 pairs, $4 count (0 is none); pointers 16-aligned
#   Out     the pairs' packets: t, object, where an entry is nearer than what was there
#   Uses    $2-$71, $79   Saves  -   Stack  0   Calls  -
#   Domain  |d| = 1 within 4 ulp; radius > 0; centre and radius below 2^62
#   Error   40 ulp of t, eye 1.5 to 30 radii from the centre, ray within 0.995 r of it
#   Twin    oracle/src/twin/sphere/factored.rs
#
# The steps are those of sphere_tmpl.inc. An opaque sphere has no inside: only the entry counts, and
# behind the eye it is none.
# Scheduled by spu schedule from isect_pairs_factored_r16.s

        .include "work_unit.inc"
        .include "macros.inc"
        .include "math.inc"
        .include "sphere_tmpl.inc"
        .include "sphere_factored.inc"

        .set    a_pair,3
        .set    count,4
        # constants
        .set    k_one,10
        .set    k_half,11
        .set    half,12
        .set    whole,13
        .set    m_x,14
        .set    m_y,15
        .set    m_z,16
        .set    m_radius2,17
        .set    a_merges,18
        # the pair
        .set    object,19
        .set    a_packet,20
        .set    quad,21
        .set    cx,22
        .set    cy,23
        .set    cz,24
        .set    fx,22                                   # c
        .set    fy,23
        .set    fz,24
        .set    radius2,25
        .set    radius,26
        # a row
        .set    dx,27
        .set    dy,28
        .set    dz,29
        .set    t_best,30
        .set    nearest,31
        # temporaries
        .set    b,32
        .set    lx,33
        .set    ly,34
        .set    lz,35
        .set    disc,36
        .set    y,37
        .set    s,38
        .set    e,39
        .set    t,40
        .set    hit,41
        .set    merge,42

        merges_table

function isect_pairs_factored_r16
        .set    count_2,79
        .set    object_2,43
        .set    a_packet_2,46
        .set    quad_2,37
        .set    object_3,41
        .set    dx_2,48
        .set    dx_3,59
        .set    dx_4,60
        .set    fx_2,32
        .set    dy_2,55
        .set    dy_3,54
        .set    dx_5,28
        .set    b_2,52
        .set    dy_4,19
        .set    b_3,64
        .set    fy_2,24
        .set    b_4,56
        .set    dz_2,61
        .set    dy_5,2
        .set    dz_3,66
        .set    b_5,34
        .set    radius2_2,42
        .set    fz_2,37
        .set    dz_4,57
        .set    b_6,51
        .set    dz_5,56
        .set    y_2,53
        .set    a_packet_3,44
        .set    a_packet_4,45
        .set    object_4,33
        .set    b_7,68
        .set    a_packet_5,40
        .set    b_8,70
        .set    t_best_2,27
        .set    lx_2,26
        .set    ly_2,9
        .set    b_9,49
        .set    nearest_2,22
        .set    lx_3,5
        .set    lx_4,20
        .set    b_10,47
        .set    lx_5,23
        .set    disc_2,19
        .set    b_11,50
        .set    lz_2,7
        .set    ly_3,2
        .set    b_12,63
        .set    disc_3,20
        .set    nearest_3,35
        .set    disc_4,23
        .set    lz_3,25
        .set    disc_5,9
        .set    ly_4,21
        .set    disc_6,5
        .set    disc_7,8
        .set    lz_4,26
        .set    disc_8,2
        .set    disc_9,25
        .set    lz_5,6
        .set    radius_2,19
        .set    y_3,9
        .set    disc_10,34
        .set    disc_11,29
        .set    disc_12,32
        .set    y_4,5
        .set    y_5,19
        .set    y_6,6
        .set    y_7,8
        .set    s_2,25
        .set    s_3,34
        .set    s_4,28
        .set    s_5,32
        .set    e_2,19
        .set    e_3,5
        .set    e_4,6
        .set    s_6,19
        .set    s_7,5
        .set    s_8,6
        .set    disc_13,67
        .set    disc_14,51
        .set    disc_15,65
        .set    disc_16,7
        .set    y_8,69
        .set    disc_17,62
        .set    disc_18,71
        .set    y_9,39
        .set    y_10,28
        .set    disc_19,64
        .set    y_11,24
        .set    t_best_3,21
        .set    nearest_4,20
        .set    y_12,2
        .set    y_13,7
        .set    t_best_4,29
        .set    s_9,23
        .set    s_10,24
        .set    e_5,8
        .set    e_6,9
        .set    e_7,7
        .set    s_11,36
        .set    t_2,8
        .set    t_3,9
        .set    t_4,5
        .set    e_8,2
        .set    hit_2,56
        .set    hit_3,58
        .set    hit_4,54
        .set    hit_5,38
        .set    hit_6,23
        .set    t_5,36
        .set    merge_2,23
        .set    hit_7,68
        .set    nearest_5,5
        .set    hit_8,34
        .set    merge_3,20
        .set    hit_9,6
        .set    hit_10,7
        .set    t_best_5,9
        .set    merge_4,6
        .set    hit_11,48
        .set    nearest_6,24
        .set    y_14,4
        .set    y_15,15
        .set    t_best_6,16
        .set    object_5,3
        .set    nearest_7,17
        .set    s_12,26
        .set    a_packet_6,29
        .set    a_packet_7,33
        .set    e_9,4
        .set    radius_3,9
        .set    b_13,5
        .set    b_14,17
        .set    b_15,19
        .set    b_16,14
        .set    e_10,36
        .set    t_6,7
        .set    object_6,24
        .set    t_7,2
        .set    s_13,4
        .set    e_11,23
        .set    disc_20,28
        .set    e_12,15
        .set    t_8,6
        .set    y_16,11
        .set    merge_5,26
        .set    hit_12,25
        .set    s_14,7
        .set    t_best_7,2
        .set    hit_13,21
        .set    merge_6,8
        .set    disc_21,4
        .set    hit_14,8
        .set    t_best_8,11
        .set    nearest_8,3
        .set    merge_7,2
        .set    dx_6,2
        .set    dy_6,5
        .set    dx_7,6
        .set    b_17,7
        .set    dy_7,8
        .set    dz_6,9
        .set    dy_8,24
        .set    b_18,25
        .set    fz_3,26
        .set    dx_8,30
        .set    dz_7,31
        .set    dz_8,33
        .set    radius2_3,21
        .set    t_best_9,34
        .set    t_best_10,35
        .set    b_19,36
        .set    t_best_11,37
        .set    y_17,38
        .set    t_best_12,39
        .set    nearest_9,40
        .set    nearest_10,41
        .set    nearest_11,42
        .set    nearest_12,43
        .set    lx_6,27
        .set    lx_7,2
        .set    lz_6,9
        .set    lz_7,29
        .set    ly_5,28
        .set    disc_22,27
        .set    ly_6,5
        .set    lx_8,6
        .set    ly_7,8
        .set    lx_9,22
        .set    ly_8,23
        .set    disc_23,6
        .set    lz_8,24
        .set    disc_24,22
        .set    y_18,27
        .set    y_19,22
        .set    y_20,23
        .set    y_21,26
        .set    s_15,2
        .set    y_22,21
        .set    e_13,22
        .set    s_16,8
        .set    e_14,21
        .set    disc_25,21
        .set    s_17,27
        .set    t_9,22
        .set    hit_15,2
        .set    hit_16,5
        .set    merge_8,5
        .set    t_best_13,6
        nop     $127                                    # 0e pairing
        biz     $count,$lr                              # 0o

        ilhu    $m_x,1                                  # 1e
        ilhu    $m_y,0x405                              # 2e

        ilhu    $m_z,0x809                              # 3e
        ilhu    $m_radius2,0xc0d                        # 4e

        ilhu    $half,0x3f00                            # 5e
        ilhu    $whole,0x3f80                           # 6e

        clgti   $count_2,$count,3                       # 7e at least as many passes as overlap
        iohl    $m_x,515                                # 8e

        iohl    $m_y,0x607                              # 9e
        iohl    $m_z,0xa0b                              # 10e

        iohl    $m_radius2,0xe0f                        # 11e
        ila     $a_merges,merges                        # 12e

        iohl    $half,0                                 # 13e
        iohl    $whole,0                                # 14e

        ilhu    $k_half,0x3f00                          # 15e
        lnop                                            # 15o pairing

        ilhu    $k_one,0x3f80                           # 16e
        brz     $count_2,next_pair_short                # 16o too few passes

        ai      $count,$count,-1                        # 17e
        lqd     $object_2,0($a_pair)                    # 17o

        ai      $a_pair,$a_pair,16                      # 18e
        ai      $count,$count,-1                        # 19e

        ai      $count,$count,-1                        # 21e
        rotqbyi $a_packet_2,$object_2,4                 # 23o

        lqd     $quad_2,0($object_2)                    # 24o
        shufb   $object_3,$object_2,$object_2,$m_x      # 25o

        nop     $127                                    # 26e pairing
        lqd     $object_2,0($a_pair)                    # 26o

        ai      $a_pair,$a_pair,16                      # 27e
        lqd     $dx_2,32($a_packet_2)                   # 27o

        lqd     $dx_3,48($a_packet_2)                   # 28o
        lqd     $dx_4,0($a_packet_2)                    # 29o

        shufb   $fx_2,$quad_2,$quad_2,$m_x              # 30o
        lqd     $dy_2,112($a_packet_2)                  # 31o

        lqd     $dy_3,64($a_packet_2)                   # 32o
        lqd     $dx_5,16($a_packet_2)                   # 33o

        fm      $b_2,$fx_2,$dx_2                        # 34e
        lqd     $dy_4,96($a_packet_2)                   # 34o

        fm      $b_3,$fx_2,$dx_4                        # 35e
        shufb   $fy_2,$quad_2,$quad_2,$m_y              # 35o

        fm      $b_4,$fx_2,$dx_3                        # 36e
        lqd     $dz_2,160($a_packet_2)                  # 36o

        lqd     $dy_5,80($a_packet_2)                   # 37o
        lqd     $dz_3,176($a_packet_2)                  # 38o

        fm      $b_5,$fx_2,$dx_5                        # 39e
        shufb   $radius2_2,$quad_2,$quad_2,$m_radius2   # 39o

        fma     $b_2,$fy_2,$dy_4,$b_2                   # 40e
        shufb   $fz_2,$quad_2,$quad_2,$m_z              # 40o

        fma     $b_3,$fy_2,$dy_3,$b_3                   # 41e
        lqd     $dz_4,128($a_packet_2)                  # 41o

        fma     $b_6,$fy_2,$dy_2,$b_4                   # 42e
        lqd     $dz_5,144($a_packet_2)                  # 42o

        frsqest $y_2,$radius2_2                         # 43o
        shlqbyi $a_packet_3,$a_packet_2,0               # 44o copy

        fma     $b_5,$fy_2,$dy_5,$b_5                   # 45e
        shlqbyi $a_packet_4,$a_packet_2,0               # 45o copy

        fma     $b_2,$fz_2,$dz_2,$b_2                   # 46e
        rotqbyi $a_packet_2,$object_2,4                 # 46o

        fi      $y_2,$radius2_2,$y_2                    # 47e
        shlqbyi $object_4,$object_3,0                   # 47o copy

        nop     $127                                    # 48e pairing
        shufb   $object_3,$object_2,$object_2,$m_x      # 48o

        fma     $b_7,$fz_2,$dz_3,$b_6                   # 49e
        lqd     $t_best,208($a_packet_3)                # 49o

        fma     $b_6,$fz_2,$dz_4,$b_3                   # 50e
        shlqbyi $a_packet_5,$a_packet_4,0               # 50o copy

        fma     $b_8,$fz_2,$dz_5,$b_5                   # 51e
        lqd     $t_best_2,240($a_packet_3)              # 51o

        fnms    $lx_2,$b_2,$dx_2,$fx_2                  # 52e
        lqd     $dx_2,32($a_packet_2)                   # 52o

        fnms    $ly_2,$b_2,$dy_4,$fy_2                  # 53e
        shlqbyi $b_9,$b_2,0                             # 53o copy

        fm      $s,$radius2_2,$y_2                      # 54e
        lqd     $nearest_2,288($a_packet_3)             # 54o

        fnms    $lx_3,$b_7,$dx_3,$fx_2                  # 55e
        lqd     $dx_3,48($a_packet_2)                   # 55o

        fnms    $lx_4,$b_6,$dx_4,$fx_2                  # 56e
        shlqbyi $b_10,$b_6,0                            # 56o copy

        fnms    $lx_5,$b_8,$dx_5,$fx_2                  # 57e
        lqd     $dx_4,0($a_packet_2)                    # 57o

        fnms    $ly,$b_6,$dy_3,$fy_2                    # 58e
        lqd     $dy_3,64($a_packet_2)                   # 58o

        fm      $disc_2,$lx_2,$lx_2                     # 59e
        shlqbyi $b_11,$b_8,0                            # 59o copy

        fnms    $lz_2,$b_6,$dz_4,$fz_2                  # 60e
        lqd     $dz_4,128($a_packet_2)                  # 60o

        fnms    $ly_3,$b_8,$dy_5,$fy_2                  # 61e
        shlqbyi $b_12,$b_7,0                            # 61o copy

        fm      $disc_3,$lx_4,$lx_4                     # 62e
        lqd     $nearest_3,304($a_packet_3)             # 62o

        fm      $disc_4,$lx_5,$lx_5                     # 63e
        lqd     $nearest,256($a_packet_3)               # 63o

        fnms    $lz_3,$b_2,$dz_2,$fz_2                  # 64e
        lqd     $dz_2,160($a_packet_2)                  # 64o

        fma     $disc_5,$ly_2,$ly_2,$disc_2             # 65e
        shlqbyi $a_packet_4,$a_packet_2,0               # 65o copy

        fnms    $ly_4,$b_7,$dy_2,$fy_2                  # 66e
        lqd     $dy_2,112($a_packet_2)                  # 66o

        fm      $disc_6,$lx_3,$lx_3                     # 67e
        fma     $disc_7,$ly,$ly,$disc_3                 # 68e

        fnms    $lz_4,$b_8,$dz_5,$fz_2                  # 69e
        fma     $disc_8,$ly_3,$ly_3,$disc_4             # 70e

        fma     $disc_9,$lz_3,$lz_3,$disc_5             # 71e
        lnop                                            # 71o pairing

        fnms    $lz_5,$b_7,$dz_3,$fz_2                  # 72e
        lqd     $quad_2,0($object_2)                    # 72o

        fma     $disc_6,$ly_4,$ly_4,$disc_6             # 73e
        lqd     $dz_3,176($a_packet_2)                  # 73o

        fnms    $radius_2,$s,$s,$radius2_2              # 74e
        lqd     $object_2,0($a_pair)                    # 74o

        fm      $y_3,$y_2,$k_half                       # 75e
        fma     $disc_10,$lz_2,$lz_2,$disc_7            # 76e

        fma     $disc_11,$lz_4,$lz_4,$disc_8            # 77e
        lqd     $dy_5,80($a_packet_2)                   # 77o

        nop     $127                                    # 78e pairing
        shufb   $fy_2,$quad_2,$quad_2,$m_y              # 78o

        fma     $disc_12,$lz_5,$lz_5,$disc_6            # 79e
        frsqest $y_4,$disc_9                            # 79o

        shufb   $radius2_2,$quad_2,$quad_2,$m_radius2   # 80o
        fma     $radius,$radius_2,$y_3,$s               # 81e

        nop     $127                                    # 82e pairing
        frsqest $y_5,$disc_10                           # 82o

        fi      $y_4,$disc_9,$y_4                       # 83e
        frsqest $y_6,$disc_11                           # 83o

        frsqest $y_2,$radius2_2                         # 84o
        frsqest $y_7,$disc_12                           # 85o

        fi      $y_5,$disc_10,$y_5                      # 86e
        fi      $y_6,$disc_11,$y_6                      # 87e

        fi      $y_2,$radius2_2,$y_2                    # 88e
        fi      $y_7,$disc_12,$y_7                      # 89e

        fm      $s_2,$disc_9,$y_4                       # 91e
        fm      $s_3,$disc_10,$y_5                      # 93e

        fm      $s_4,$disc_11,$y_6                      # 94e
        fm      $s_5,$disc_12,$y_7                      # 96e

        fnms    $e,$s_2,$y_4,$k_one                     # 97e
        fnms    $e_2,$s_3,$y_5,$k_one                   # 99e

        fnms    $e_3,$s_4,$y_6,$k_one                   # 100e
        fnms    $e_4,$s_5,$y_7,$k_one                   # 102e

        fma     $e,$e,$k_half,$k_one                    # 103e
        fma     $e_2,$e_2,$k_half,$k_one                # 105e

        fma     $e_3,$e_3,$k_half,$k_one                # 106e
        fma     $e_4,$e_4,$k_half,$k_one                # 108e

        fm      $s_2,$s_2,$e                            # 109e
        fm      $s_6,$s_3,$e_2                          # 111e

        fm      $s_7,$s_4,$e_3                          # 112e
        lqd     $dx_5,16($a_packet_2)                   # 112o

        fm      $s_8,$s_5,$e_4                          # 114e
        shufb   $fx_2,$quad_2,$quad_2,$m_x              # 114o

        fs      $disc_13,$radius,$s_2                   # 115e
        shufb   $fz_2,$quad_2,$quad_2,$m_z              # 115o

        fa      $s_2,$radius,$s_2                       # 116e
        fs      $disc_14,$radius,$s_6                   # 117e

        fa      $s_6,$radius,$s_6                       # 118e
        fm      $b_2,$fx_2,$dx_2                        # 119e

        fm      $b_4,$fx_2,$dx_3                        # 120e
        fm      $b_5,$fx_2,$dx_5                        # 121e

        fm      $b_3,$fx_2,$dx_4                        # 122e
        fs      $disc_4,$radius,$s_7                    # 123e

        fm      $disc_15,$disc_14,$s_6                  # 124e
        lqd     $dy_4,96($a_packet_2)                   # 124o

        fa      $s,$radius,$s_7                         # 125e
        lnop                                            # 125o pairing

        fma     $b_6,$fy_2,$dy_2,$b_4                   # 126e
        lqd     $dz_5,144($a_packet_2)                  # 126o

        fma     $b_5,$fy_2,$dy_5,$b_5                   # 127e
        fs      $disc_16,$radius,$s_8                   # 128e

        fa      $s_8,$radius,$s_8                       # 129e
        lnop                                            # 129o pairing

        fma     $b_2,$fy_2,$dy_4,$b_2                   # 130e
        frsqest $y_8,$disc_15                           # 130o

        fm      $disc_17,$disc_4,$s                     # 131e
        fma     $b_7,$fz_2,$dz_3,$b_6                   # 132e

        fma     $b_8,$fz_2,$dz_5,$b_5                   # 133e
        fma     $b_3,$fy_2,$dy_3,$b_3                   # 134e

        fm      $disc_18,$disc_16,$s_8                  # 135e
        fma     $b_2,$fz_2,$dz_2,$b_2                   # 136e

        fm      $s,$radius2_2,$y_2                      # 137e
        frsqest $y_9,$disc_17                           # 137o

        fnms    $lx_3,$b_7,$dx_3,$fx_2                  # 138e
        fnms    $lx_5,$b_8,$dx_5,$fx_2                  # 139e

        fma     $b_6,$fz_2,$dz_4,$b_3                   # 140e
        lnop                                            # 140o pairing

        fnms    $ly_3,$b_8,$dy_5,$fy_2                  # 141e
        frsqest $y_10,$disc_18                          # 141o

        fnms    $lx_2,$b_2,$dx_2,$fx_2                  # 142e
        fnms    $ly_2,$b_2,$dy_4,$fy_2                  # 143e

        fm      $disc_19,$disc_13,$s_2                  # 144e
        fm      $disc_4,$lx_5,$lx_5                     # 145e

        fnms    $lx_4,$b_6,$dx_4,$fx_2                  # 146e
        fnms    $lz_3,$b_2,$dz_2,$fz_2                  # 147e

        fm      $disc_2,$lx_2,$lx_2                     # 148e
        fnms    $lz_4,$b_8,$dz_5,$fz_2                  # 149e

        fnms    $ly_4,$b_7,$dy_2,$fy_2                  # 150e
        fma     $disc_8,$ly_3,$ly_3,$disc_4             # 151e

        fm      $disc_6,$lx_3,$lx_3                     # 152e
        lnop                                            # 152o pairing

        fnms    $ly,$b_6,$dy_3,$fy_2                    # 153e
        frsqest $y_11,$disc_19                          # 153o

        fma     $disc_5,$ly_2,$ly_2,$disc_2             # 154e
        fm      $disc_3,$lx_4,$lx_4                     # 155e

        fnms    $lz_5,$b_7,$dz_3,$fz_2                  # 156e
        fma     $disc_11,$lz_4,$lz_4,$disc_8            # 157e

        fma     $disc_6,$ly_4,$ly_4,$disc_6             # 158e
        lqd     $t_best_3,192($a_packet_3)              # 158o

        fnms    $lz_2,$b_6,$dz_4,$fz_2                  # 159e
        fma     $disc_9,$lz_3,$lz_3,$disc_5             # 160e

        fma     $disc_7,$ly,$ly,$disc_3                 # 161e
        lqd     $nearest_4,272($a_packet_3)             # 161o

        fnms    $radius_2,$s,$s,$radius2_2              # 162e
        fm      $y_3,$y_2,$k_half                       # 163e

        fma     $disc_12,$lz_5,$lz_5,$disc_6            # 164e
        frsqest $y_6,$disc_11                           # 164o

        fi      $y,$disc_19,$y_11                       # 165e
        lnop                                            # 165o pairing

        fi      $y_12,$disc_18,$y_10                    # 166e
        frsqest $y_4,$disc_9                            # 166o

        fma     $disc_10,$lz_2,$lz_2,$disc_7            # 168e
        fi      $y_6,$disc_11,$y_6                      # 169e

        fi      $y_4,$disc_9,$y_4                       # 170e
        frsqest $y_7,$disc_12                           # 170o

        fi      $y_13,$disc_17,$y_9                     # 171e
        fma     $radius,$radius_2,$y_3,$s               # 173e

        fi      $y_7,$disc_12,$y_7                      # 174e
        frsqest $y_5,$disc_10                           # 174o

        fi      $y_3,$disc_15,$y_8                      # 175e
        fm      $s_2,$disc_9,$y_4                       # 177e

        fm      $s_4,$disc_11,$y_6                      # 178e
        lqd     $t_best_4,224($a_packet_3)              # 178o

        fi      $y_5,$disc_10,$y_5                      # 179e
        shlqbyi $a_packet_3,$a_packet_2,0               # 179o copy

        rotqbyi $a_packet_2,$object_2,4                 # 180o
        fm      $s_5,$disc_12,$y_7                      # 181e

        fm      $s,$disc_19,$y                          # 182e
        fnms    $e,$s_2,$y_4,$k_one                     # 183e

        fm      $s_9,$disc_15,$y_3                      # 184e
        lqd     $dx_3,48($a_packet_2)                   # 184o

        fnms    $e_3,$s_4,$y_6,$k_one                   # 185e
        lqd     $dx_2,32($a_packet_2)                   # 185o

        fm      $s_10,$disc_17,$y_13                    # 186e
        lqd     $dx_4,0($a_packet_2)                    # 186o

        fnms    $e_4,$s_5,$y_7,$k_one                   # 187e
        lqd     $dy_2,112($a_packet_2)                  # 187o

        fnms    $e_5,$s,$y,$k_one                       # 188e
        lqd     $quad_2,0($object_2)                    # 188o

        fm      $s_3,$disc_10,$y_5                      # 189e
        lqd     $dz_4,128($a_packet_2)                  # 189o

        fnms    $e_6,$s_9,$y_3,$k_one                   # 190e
        lqd     $dz_2,160($a_packet_2)                  # 190o

        fma     $e_3,$e_3,$k_half,$k_one                # 191e
        lqd     $dz_3,176($a_packet_2)                  # 191o

        fnms    $e_7,$s_10,$y_13,$k_one                 # 192e
        fm      $s_11,$disc_18,$y_12                    # 193e

        fma     $e_5,$e_5,$half,$whole                  # 194e
        shufb   $radius2_2,$quad_2,$quad_2,$m_radius2   # 194o

        fnms    $e_2,$s_3,$y_5,$k_one                   # 195e
        fma     $e_6,$e_6,$half,$whole                  # 196e

        fm      $s_7,$s_4,$e_3                          # 197e
        lqd     $dx_5,16($a_packet_2)                   # 197o

        fma     $e_7,$e_7,$half,$whole                  # 198e
        frsqest $y_2,$radius2_2                         # 198o

        fma     $e_4,$e_4,$k_half,$k_one                # 199e
        lnop                                            # 199o pairing

        fnms    $t_2,$s,$e_5,$b_9                       # 200e
        shlqbyi $b_9,$b_2,0                             # 200o copy

        fma     $e_2,$e_2,$k_half,$k_one                # 201e
        lnop                                            # 201o pairing

        fnms    $t_3,$s_9,$e_6,$b_10                    # 202e
        shlqbyi $b_10,$b_6,0                            # 202o copy

        fs      $disc_4,$radius,$s_7                    # 203e
        fa      $s,$radius,$s_7                         # 204e

        fnms    $t_4,$s_10,$e_7,$b_11                   # 205e
        shufb   $fy_2,$quad_2,$quad_2,$m_y              # 205o

        fnms    $e_8,$s_11,$y_12,$k_one                 # 206e
        shlqbyi $b_11,$b_8,0                            # 206o copy

        fm      $s_6,$s_3,$e_2                          # 207e
        lnop                                            # 207o pairing

        fm      $s_8,$s_5,$e_4                          # 208e
        shufb   $fx_2,$quad_2,$quad_2,$m_x              # 208o

        clgt    $hit_2,$t_best_3,$t_3                   # 209e
        shufb   $fz_2,$quad_2,$quad_2,$m_z              # 209o

        clgt    $hit_3,$t_best_4,$t_2                   # 210e
        clgt    $hit_4,$t_best,$t_4                     # 211e

        fma     $e_8,$e_8,$half,$whole                  # 212e
        andc    $hit_4,$hit_4,$disc_17                  # 213e

        fm      $disc_17,$disc_4,$s                     # 214e
        lnop                                            # 214o pairing

        andc    $hit_5,$hit_2,$disc_15                  # 215e
        rotqbii $hit_6,$hit_4,1                         # 215o

        fm      $b_4,$fx_2,$dx_3                        # 216e
        lqd     $dy_3,64($a_packet_2)                   # 216o

        fs      $disc_14,$radius,$s_6                   # 217e
        rotqbii $hit_5,$hit_5,1                         # 217o

        fnms    $t_5,$s_11,$e_8,$b_12                   # 218e
        lqd     $dy_5,80($a_packet_2)                   # 218o

        fa      $s_6,$radius,$s_6                       # 219e
        gb      $hit_6,$hit_6                           # 219o

        fm      $b_5,$fx_2,$dx_5                        # 220e
        shlqbyi $b_12,$b_7,0                            # 220o copy

        fm      $b_2,$fx_2,$dx_2                        # 221e
        gb      $hit_5,$hit_5                           # 221o

        andc    $hit_3,$hit_3,$disc_19                  # 222e
        lnop                                            # 222o pairing

        fm      $b_3,$fx_2,$dx_4                        # 223e
        shlqbii $hit_6,$hit_6,4                         # 223o

        fma     $e,$e,$k_half,$k_one                    # 224e
        rotqbii $hit_3,$hit_3,1                         # 224o

        fm      $disc_15,$disc_14,$s_6                  # 225e
        lqd     $dy_4,96($a_packet_2)                   # 225o

        fma     $b_6,$fy_2,$dy_2,$b_4                   # 226e
        lqd     $dz_5,144($a_packet_2)                  # 226o

        fma     $b_5,$fy_2,$dy_5,$b_5                   # 227e
        lqx     $merge_2,$a_merges,$hit_6               # 227o

        clgt    $hit_7,$t_best_2,$t_5                   # 228e
        fma     $b_3,$fy_2,$dy_3,$b_3                   # 229e

        fs      $disc_16,$radius,$s_8                   # 230e
        lnop                                            # 230o pairing

        fma     $b_2,$fy_2,$dy_4,$b_2                   # 231e
        frsqest $y_8,$disc_15                           # 231o

        fm      $s_2,$s_2,$e                            # 232e
        frsqest $y_9,$disc_17                           # 232o

        fma     $b_8,$fz_2,$dz_5,$b_5                   # 233e
        shufb   $t_best,$t_best,$t_4,$merge_2           # 233o

        fa      $s_8,$radius,$s_8                       # 234e
        shufb   $nearest_5,$nearest_4,$object_4,$merge_2 # 234o

        fi      $y_2,$radius2_2,$y_2                    # 235e
        shlqbii $hit_8,$hit_5,4                         # 235o

        andc    $hit_5,$hit_7,$disc_18                  # 236e
        fma     $b_7,$fz_2,$dz_3,$b_6                   # 237e

        fma     $b_2,$fz_2,$dz_2,$b_2                   # 238e
        lnop                                            # 238o pairing

        fs      $disc_13,$radius,$s_2                   # 239e
        lqx     $merge_3,$a_merges,$hit_8               # 239o

        fm      $disc_18,$disc_16,$s_8                  # 240e
        gb      $hit_9,$hit_3                           # 240o

        fma     $b_6,$fz_2,$dz_4,$b_3                   # 241e
        stqd    $nearest_5,272($a_packet_5)             # 241o

        fnms    $lx_5,$b_8,$dx_5,$fx_2                  # 242e
        stqd    $t_best,208($a_packet_5)                # 242o

        fa      $s_2,$radius,$s_2                       # 243e
        rotqbii $hit_10,$hit_5,1                        # 243o

        fnms    $lx_2,$b_2,$dx_2,$fx_2                  # 244e
        shlqbii $hit_9,$hit_9,4                         # 244o

        fnms    $lx_3,$b_7,$dx_3,$fx_2                  # 245e
        shufb   $t_best_5,$t_best_3,$t_3,$merge_3       # 245o

        fnms    $ly_3,$b_8,$dy_5,$fy_2                  # 246e
        shufb   $nearest,$nearest,$object_4,$merge_3    # 246o

        fnms    $lx_4,$b_6,$dx_4,$fx_2                  # 247e
        gb      $hit_10,$hit_10                         # 247o

        fm      $disc_4,$lx_5,$lx_5                     # 248e
        frsqest $y_10,$disc_18                          # 248o

        fnms    $ly_4,$b_7,$dy_2,$fy_2                  # 249e
        stqd    $t_best_5,192($a_packet_5)              # 249o

        fnms    $ly_2,$b_2,$dy_4,$fy_2                  # 250e
        lqx     $merge_4,$a_merges,$hit_9               # 250o

        fm      $disc_6,$lx_3,$lx_3                     # 251e
        stqd    $nearest,256($a_packet_5)               # 251o

        fnms    $ly,$b_6,$dy_3,$fy_2                    # 252e
        shlqbii $hit_11,$hit_10,4                       # 252o

        fm      $disc_2,$lx_2,$lx_2                     # 253e
        fm      $disc_19,$disc_13,$s_2                  # 254e

        fm      $disc_3,$lx_4,$lx_4                     # 255e
        lnop                                            # 255o pairing

        fm      $s,$radius2_2,$y_2                      # 256e
        shufb   $nearest,$nearest_2,$object_4,$merge_4  # 256o

        fnms    $lz_4,$b_8,$dz_5,$fz_2                  # 257e
        shufb   $t_best,$t_best_4,$t_2,$merge_4         # 257o

        fnms    $lz_3,$b_2,$dz_2,$fz_2                  # 258e
        fma     $disc_5,$ly_2,$ly_2,$disc_2             # 259e

        fma     $disc_6,$ly_4,$ly_4,$disc_6             # 260e
        stqd    $nearest,288($a_packet_5)               # 260o

        fnms    $lz_5,$b_7,$dz_3,$fz_2                  # 261e
        stqd    $t_best,224($a_packet_5)                # 261o

        fnms    $lz_2,$b_6,$dz_4,$fz_2                  # 262e
        frsqest $y_11,$disc_19                          # 262o

        fma     $disc_7,$ly,$ly,$disc_3                 # 263e
        fma     $disc_8,$ly_3,$ly_3,$disc_4             # 264e

        fnms    $radius_2,$s,$s,$radius2_2              # 265e
        fma     $disc_9,$lz_3,$lz_3,$disc_5             # 266e

        fm      $y_3,$y_2,$k_half                       # 267e
        fma     $disc_12,$lz_5,$lz_5,$disc_6            # 268e

        fma     $disc_10,$lz_2,$lz_2,$disc_7            # 269e
        fma     $disc_11,$lz_4,$lz_4,$disc_8            # 270e

next_pair:
            fi      $y,$disc_19,$y_11                   # 0e
            lnop                                        # 0o pairing

            fi      $y_12,$disc_18,$y_10                # 1e
            frsqest $y_4,$disc_9                        # 1o

            ai      $a_pair,$a_pair,16                  # 2e
            lnop                                        # 2o pairing

            fma     $radius,$radius_2,$y_3,$s           # 3e
            frsqest $y_6,$disc_11                       # 3o

            fi      $y_13,$disc_17,$y_9                 # 4e
            frsqest $y_7,$disc_12                       # 4o

            fi      $y_3,$disc_15,$y_8                  # 5e
            frsqest $y_5,$disc_10                       # 5o

            fi      $y_4,$disc_9,$y_4                   # 6e
            lqx     $merge,$a_merges,$hit_11            # 6o

            fi      $y_6,$disc_11,$y_6                  # 7e
            lqd     $t_best,208($a_packet_3)            # 7o

            fi      $y_7,$disc_12,$y_7                  # 8e
            lqd     $nearest,256($a_packet_3)           # 8o

            fi      $y_5,$disc_10,$y_5                  # 9e
            lqd     $nearest_4,272($a_packet_3)         # 9o

        ai      $count,$count,-1                        # 10e
            lqd     $t_best_3,192($a_packet_3)          # 10o

            fm      $s,$disc_19,$y                      # 11e
            lqd     $nearest_2,288($a_packet_3)         # 11o

            fm      $s_9,$disc_15,$y_3                  # 12e
            shufb   $nearest_6,$nearest_3,$object_4,$merge # 12o

            fm      $s_2,$disc_9,$y_4                   # 13e
            shufb   $t_best_2,$t_best_2,$t_5,$merge     # 13o

            fm      $s_4,$disc_11,$y_6                  # 14e
            lqd     $t_best_4,224($a_packet_3)          # 14o

            fm      $s_5,$disc_12,$y_7                  # 15e
            shlqbyi $object_4,$object_3,0               # 15o copy

            fm      $s_3,$disc_10,$y_5                  # 16e
            stqd    $nearest_6,304($a_packet_5)         # 16o

            fm      $s_10,$disc_17,$y_13                # 17e
            lqd     $nearest_3,304($a_packet_3)         # 17o

            fm      $s_11,$disc_18,$y_12                # 18e
            stqd    $t_best_2,240($a_packet_5)          # 18o

            fnms    $e,$s_2,$y_4,$k_one                 # 19e
            lqd     $t_best_2,240($a_packet_3)          # 19o

            fnms    $e_3,$s_4,$y_6,$k_one               # 20e
            shlqbyi $a_packet_5,$a_packet_4,0           # 20o copy

            fnms    $e_4,$s_5,$y_7,$k_one               # 21e
            shufb   $object_3,$object_2,$object_2,$m_x  # 21o

            fnms    $e_5,$s,$y,$k_one                   # 22e
        lqd     $object_2,0($a_pair)                    # 22o

            fnms    $e_2,$s_3,$y_5,$k_one               # 23e
            shlqbyi $a_packet_3,$a_packet_2,0           # 23o copy

            fnms    $e_6,$s_9,$y_3,$k_one               # 24e
            shlqbyi $a_packet_4,$a_packet_2,0           # 24o copy

            fnms    $e_8,$s_11,$y_12,$k_one             # 25e
            fma     $e_3,$e_3,$k_half,$k_one            # 26e

            fma     $e_4,$e_4,$k_half,$k_one            # 27e
            lnop                                        # 27o pairing

            fnms    $e_7,$s_10,$y_13,$k_one             # 28e
        lqd     $quad_2,0($object_2)                    # 28o

            fma     $e_2,$e_2,$k_half,$k_one            # 29e
        rotqbyi $a_packet_2,$object_2,4                 # 29o

            fma     $e_6,$e_6,$half,$whole              # 30e
            fma     $e_5,$e_5,$half,$whole              # 31e

            fm      $s_7,$s_4,$e_3                      # 32e
            lnop                                        # 32o pairing

            fm      $s_8,$s_5,$e_4                      # 33e
        lqd     $dx_5,16($a_packet_2)                   # 33o

            fma     $e_7,$e_7,$half,$whole              # 34e
        shufb   $fx_2,$quad_2,$quad_2,$m_x              # 34o

            fma     $e_8,$e_8,$half,$whole              # 35e
        shufb   $radius2_2,$quad_2,$quad_2,$m_radius2   # 35o

            fm      $s_6,$s_3,$e_2                      # 36e
            lnop                                        # 36o pairing

            fnms    $t_3,$s_9,$e_6,$b_10                # 37e
            shlqbyi $b_10,$b_6,0                        # 37o copy

            fs      $disc_4,$radius,$s_7                # 38e
            lnop                                        # 38o pairing

        fm      $b_5,$fx_2,$dx_5                        # 39e
        lqd     $dx_2,32($a_packet_2)                   # 39o

            fnms    $t_2,$s,$e_5,$b_9                   # 40e
            shlqbyi $b_9,$b_2,0                         # 40o copy

            fa      $s,$radius,$s_7                     # 41e
            lnop                                        # 41o pairing

            fnms    $t_4,$s_10,$e_7,$b_11               # 42e
            shlqbyi $b_11,$b_8,0                        # 42o copy

            fs      $disc_16,$radius,$s_8               # 43e
        shufb   $fy_2,$quad_2,$quad_2,$m_y              # 43o

            fs      $disc_14,$radius,$s_6               # 44e
        shufb   $fz_2,$quad_2,$quad_2,$m_z              # 44o

            fma     $e,$e,$k_half,$k_one                # 45e
            lnop                                        # 45o pairing

        fm      $b_2,$fx_2,$dx_2                        # 46e
        frsqest $y_2,$radius2_2                         # 46o

            fa      $s_6,$radius,$s_6                   # 47e
            lnop                                        # 47o pairing

            clgt    $hit_4,$t_best,$t_4                 # 48e
        lqd     $dy_2,112($a_packet_2)                  # 48o

            clgt    $hit_2,$t_best_3,$t_3               # 49e
        lqd     $dz_4,128($a_packet_2)                  # 49o

            clgt    $hit_3,$t_best_4,$t_2               # 50e
        lqd     $dx_3,48($a_packet_2)                   # 50o

            andc    $hit_4,$hit_4,$disc_17              # 51e
        lqd     $dx_4,0($a_packet_2)                    # 51o

            andc    $hit_3,$hit_3,$disc_19              # 52e
        lqd     $dz_2,160($a_packet_2)                  # 52o

            fm      $disc_17,$disc_4,$s                 # 53e
            rotqbii $hit_6,$hit_4,1                     # 53o

            fnms    $t_5,$s_11,$e_8,$b_12               # 54e
        lqd     $dy_5,80($a_packet_2)                   # 54o

            andc    $hit_5,$hit_2,$disc_15              # 55e
        lqd     $dy_3,64($a_packet_2)                   # 55o

        fm      $b_4,$fx_2,$dx_3                        # 56e
            shlqbyi $b_12,$b_7,0                        # 56o copy

        fm      $b_3,$fx_2,$dx_4                        # 57e
            gb      $hit_6,$hit_6                       # 57o

            fm      $disc_15,$disc_14,$s_6              # 58e
        lqd     $dy_4,96($a_packet_2)                   # 58o

            fm      $s_2,$s_2,$e                        # 59e
            frsqest $y_9,$disc_17                       # 59o

        fma     $b_5,$fy_2,$dy_5,$b_5                   # 60e
            rotqbii $hit_5,$hit_5,1                     # 60o

            fa      $s_8,$radius,$s_8                   # 61e
            shlqbii $hit_6,$hit_6,4                     # 61o

        fma     $b_6,$fy_2,$dy_2,$b_4                   # 62e
        lqd     $dz_5,144($a_packet_2)                  # 62o

        fma     $b_3,$fy_2,$dy_3,$b_3                   # 63e
        lqd     $dz_3,176($a_packet_2)                  # 63o

        fma     $b_2,$fy_2,$dy_4,$b_2                   # 64e
            gb      $hit_5,$hit_5                       # 64o

            fs      $disc_13,$radius,$s_2               # 65e
            rotqbii $hit_3,$hit_3,1                     # 65o

        fi      $y_2,$radius2_2,$y_2                    # 66e
            lqx     $merge_2,$a_merges,$hit_6           # 66o

            clgt    $hit_7,$t_best_2,$t_5               # 67e
            frsqest $y_8,$disc_15                       # 67o

        fma     $b_8,$fz_2,$dz_5,$b_5                   # 68e
            shlqbii $hit_8,$hit_5,4                     # 68o

            andc    $hit_5,$hit_7,$disc_18              # 69e
            lnop                                        # 69o pairing

            fm      $disc_18,$disc_16,$s_8              # 70e
            gb      $hit_9,$hit_3                       # 70o

        fma     $b_2,$fz_2,$dz_2,$b_2                   # 71e
            rotqbii $hit_10,$hit_5,1                    # 71o

        fma     $b_7,$fz_2,$dz_3,$b_6                   # 72e
            shufb   $t_best,$t_best,$t_4,$merge_2       # 72o

        fma     $b_6,$fz_2,$dz_4,$b_3                   # 73e
            shufb   $nearest_5,$nearest_4,$object_4,$merge_2 # 73o

        fm      $s,$radius2_2,$y_2                      # 74e
            lqx     $merge_3,$a_merges,$hit_8           # 74o

        fnms    $lx_5,$b_8,$dx_5,$fx_2                  # 75e
            gb      $hit_10,$hit_10                     # 75o

            fa      $s_2,$radius,$s_2                   # 76e
            shlqbii $hit_9,$hit_9,4                     # 76o

        fnms    $lx_2,$b_2,$dx_2,$fx_2                  # 77e
            stqd    $nearest_5,272($a_packet_5)         # 77o

        fnms    $lx_3,$b_7,$dx_3,$fx_2                  # 78e
            frsqest $y_10,$disc_18                      # 78o

        fnms    $ly,$b_6,$dy_3,$fy_2                    # 79e
            shlqbii $hit_11,$hit_10,4                   # 79o

        fnms    $lz_2,$b_6,$dz_4,$fz_2                  # 80e
            shufb   $t_best_5,$t_best_3,$t_3,$merge_3   # 80o

        fnms    $ly_3,$b_8,$dy_5,$fy_2                  # 81e
            stqd    $t_best,208($a_packet_5)            # 81o

            fm      $disc_19,$disc_13,$s_2              # 82e
            shufb   $nearest,$nearest,$object_4,$merge_3 # 82o

        fnms    $lx_4,$b_6,$dx_4,$fx_2                  # 83e
        hbrr    next_pair_back,next_pair                # 83o hint

        fnms    $ly_4,$b_7,$dy_2,$fy_2                  # 84e
            stqd    $t_best_5,192($a_packet_5)          # 84o

        fnms    $ly_2,$b_2,$dy_4,$fy_2                  # 85e
            lqx     $merge_4,$a_merges,$hit_9           # 85o

        fm      $disc_2,$lx_2,$lx_2                     # 86e
            stqd    $nearest,256($a_packet_5)           # 86o

        fm      $disc_6,$lx_3,$lx_3                     # 87e
        lnop                                            # 87o pairing

        fm      $disc_4,$lx_5,$lx_5                     # 88e
            frsqest $y_11,$disc_19                      # 88o

        fm      $disc_3,$lx_4,$lx_4                     # 89e
        fnms    $lz_3,$b_2,$dz_2,$fz_2                  # 90e

        fnms    $lz_4,$b_8,$dz_5,$fz_2                  # 91e
            shufb   $nearest,$nearest_2,$object_4,$merge_4 # 91o

        fma     $disc_5,$ly_2,$ly_2,$disc_2             # 92e
            shufb   $t_best,$t_best_4,$t_2,$merge_4     # 92o

        fma     $disc_6,$ly_4,$ly_4,$disc_6             # 93e
        fma     $disc_8,$ly_3,$ly_3,$disc_4             # 94e

        fnms    $lz_5,$b_7,$dz_3,$fz_2                  # 95e
            stqd    $nearest,288($a_packet_5)           # 95o

        fma     $disc_7,$ly,$ly,$disc_3                 # 96e
            stqd    $t_best,224($a_packet_5)            # 96o

        fnms    $radius_2,$s,$s,$radius2_2              # 97e
        fma     $disc_9,$lz_3,$lz_3,$disc_5             # 98e

        fm      $y_3,$y_2,$k_half                       # 99e
        fma     $disc_11,$lz_4,$lz_4,$disc_8            # 100e

        fma     $disc_12,$lz_5,$lz_5,$disc_6            # 101e
        lnop                                            # 101o pairing

        fma     $disc_10,$lz_2,$lz_2,$disc_7            # 102e
next_pair_back:
        brnz    $count,next_pair                        # 102o

next_pair_drain:
        fi      $y_13,$disc_17,$y_9                     # 0e
        frsqest $y_6,$disc_11                           # 0o

        fi      $y_12,$disc_15,$y_8                     # 1e
        frsqest $y_14,$disc_10                          # 1o

        fi      $y,$disc_19,$y_11                       # 2e
        frsqest $y_4,$disc_9                            # 2o

        fi      $y_7,$disc_18,$y_10                     # 3e
        frsqest $y_15,$disc_12                          # 3o

        fi      $y_6,$disc_11,$y_6                      # 4e
        lqd     $t_best,208($a_packet_3)                # 4o

        fi      $y_14,$disc_10,$y_14                    # 5e
        lqd     $t_best_3,192($a_packet_3)              # 5o

        fi      $y_4,$disc_9,$y_4                       # 6e
        lqx     $merge,$a_merges,$hit_11                # 6o

        fi      $y_15,$disc_12,$y_15                    # 7e
        lqd     $t_best_6,224($a_packet_3)              # 7o

        ai      $a_pair,$a_pair,16                      # 8e
        lqd     $nearest,256($a_packet_3)               # 8o

        fm      $s_10,$disc_17,$y_13                    # 9e
        lqd     $nearest_4,272($a_packet_3)             # 9o

        fm      $s_9,$disc_15,$y_12                     # 10e
        lqd     $nearest_2,288($a_packet_3)             # 10o

        fm      $s_4,$disc_11,$y_6                      # 11e
        shlqbyi $object_5,$object_3,0                   # 11o copy

        fm      $s_3,$disc_10,$y_14                     # 12e
        shufb   $nearest_7,$nearest_3,$object_4,$merge  # 12o

        fm      $s_12,$disc_19,$y                       # 13e
        shufb   $t_best_2,$t_best_2,$t_5,$merge         # 13o

        fm      $s_2,$disc_9,$y_4                       # 14e
        shlqbyi $a_packet_6,$a_packet_4,0               # 14o copy

        fnms    $e_7,$s_10,$y_13,$k_one                 # 15e
        shlqbyi $a_packet_7,$a_packet_2,0               # 15o copy

        fnms    $e_8,$s_9,$y_12,$k_one                  # 16e
        stqd    $nearest_7,304($a_packet_5)             # 16o

        fnms    $e_4,$s_4,$y_6,$k_one                   # 17e
        lqd     $nearest_3,304($a_packet_3)             # 17o

        fnms    $e_9,$s_3,$y_14,$k_one                  # 18e
        stqd    $t_best_2,240($a_packet_5)              # 18o

        fma     $radius_3,$radius_2,$y_3,$s             # 19e
        lqd     $t_best_2,240($a_packet_3)              # 19o

        fnms    $e,$s_2,$y_4,$k_one                     # 20e
        shlqbyi $b_13,$b_8,0                            # 20o copy

        fma     $e_7,$e_7,$half,$whole                  # 21e
        shlqbyi $b_14,$b_6,0                            # 21o copy

        fma     $e_8,$e_8,$half,$whole                  # 22e
        shlqbyi $b_15,$b_2,0                            # 22o copy

        fma     $e_4,$e_4,$k_half,$k_one                # 23e
        shufb   $object_3,$object_2,$object_2,$m_x      # 23o

        fma     $e_9,$e_9,$k_half,$k_one                # 24e
        shlqbyi $b_16,$b_7,0                            # 24o copy

        fnms    $e_10,$s_12,$y,$k_one                   # 25e
        shlqbyi $a_packet_4,$a_packet_2,0               # 25o copy

        fm      $s_5,$disc_12,$y_15                     # 26e
        lnop                                            # 26o pairing

        fnms    $t_6,$s_10,$e_7,$b_11                   # 27e
        shlqbyi $object_6,$object_3,0                   # 27o copy

        fnms    $t_7,$s_9,$e_8,$b_10                    # 28e
        lnop                                            # 28o pairing

        fm      $s_8,$s_4,$e_4                          # 29e
        shlqbyi $a_packet_5,$a_packet_4,0               # 29o copy

        fm      $s_13,$s_3,$e_9                         # 30e
        fma     $e_11,$e_10,$half,$whole                # 31e

        fma     $e,$e,$k_half,$k_one                    # 32e
        clgt    $hit_4,$t_best,$t_6                     # 33e

        clgt    $hit_2,$t_best_3,$t_7                   # 34e
        fs      $disc_20,$radius_3,$s_8                 # 35e

        fa      $s,$radius_3,$s_8                       # 36e
        fs      $disc_14,$radius_3,$s_13                # 37e

        fa      $s_13,$radius_3,$s_13                   # 38e
        andc    $hit_4,$hit_4,$disc_17                  # 39e

        andc    $hit_9,$hit_2,$disc_15                  # 40e
        lnop                                            # 40o pairing

        fnms    $e_12,$s_5,$y_15,$k_one                 # 41e
        rotqbii $hit_8,$hit_4,1                         # 41o

        fm      $disc_17,$disc_20,$s                    # 42e
        rotqbii $hit_5,$hit_9,1                         # 42o

        fnms    $t_8,$s_12,$e_11,$b_9                   # 43e
        fm      $s_2,$s_2,$e                            # 44e

        fm      $disc_15,$disc_14,$s_13                 # 45e
        gb      $hit_6,$hit_8                           # 45o

        fm      $s_11,$disc_18,$y_7                     # 46e
        gb      $hit_5,$hit_5                           # 46o

        fma     $e_9,$e_12,$k_half,$k_one               # 47e
        hbr     isect_pairs_factored_r16_return,$lr     # 47o hint

        nop     $127                                    # 48e pairing
        frsqest $y_9,$disc_17                           # 48o

        clgt    $hit_3,$t_best_6,$t_8                   # 49e
        shlqbii $hit_6,$hit_6,4                         # 49o

        fs      $disc_13,$radius_3,$s_2                 # 50e
        shlqbii $hit_8,$hit_5,4                         # 50o

        fa      $s_2,$radius_3,$s_2                     # 51e
        frsqest $y_8,$disc_15                           # 51o

        andc    $hit_3,$hit_3,$disc_19                  # 52e
        lnop                                            # 52o pairing

        fnms    $e_5,$s_11,$y_7,$k_one                  # 53e
        lqx     $merge_2,$a_merges,$hit_6               # 53o

        fi      $y_16,$disc_17,$y_9                     # 54e
        rotqbii $hit_3,$hit_3,1                         # 54o

        fi      $y_15,$disc_15,$y_8                     # 55e
        lqx     $merge_5,$a_merges,$hit_8               # 55o

        fm      $s_13,$s_5,$e_9                         # 57e
        lnop                                            # 57o pairing

        fm      $disc_19,$disc_13,$s_2                  # 58e
        gb      $hit_12,$hit_3                          # 58o

        fma     $e_5,$e_5,$half,$whole                  # 59e
        shufb   $nearest_4,$nearest_4,$object_5,$merge_2 # 59o

        nop     $127                                    # 60e pairing
        shufb   $t_best,$t_best,$t_6,$merge_2           # 60o

        fm      $s_14,$disc_17,$y_16                    # 61e
        shufb   $t_best_7,$t_best_3,$t_7,$merge_5       # 61o

        fm      $s_9,$disc_15,$y_15                     # 62e
        shlqbii $hit_13,$hit_12,4                       # 62o

        fs      $disc_9,$radius_3,$s_13                 # 63e
        stqd    $nearest_4,272($a_packet_6)             # 63o

        fa      $s_13,$radius_3,$s_13                   # 64e
        frsqest $y_3,$disc_19                           # 64o

        fnms    $t_5,$s_11,$e_5,$b_12                   # 65e
        stqd    $t_best,208($a_packet_6)                # 65o

        nop     $127                                    # 66e pairing
        stqd    $t_best_7,192($a_packet_6)              # 66o

        fnms    $e_8,$s_14,$y_16,$k_one                 # 67e
        lqx     $merge_6,$a_merges,$hit_13              # 67o

        fi      $y,$disc_19,$y_3                        # 68e
        shufb   $nearest,$nearest,$object_5,$merge_5    # 68o

        fm      $disc_21,$disc_9,$s_13                  # 70e
        fnms    $e_6,$s_9,$y_15,$k_one                  # 71e

        clgt    $hit_7,$t_best_2,$t_5                   # 72e
        stqd    $nearest,256($a_packet_6)               # 72o

        fma     $e_8,$e_8,$half,$whole                  # 73e
        shufb   $nearest,$nearest_2,$object_5,$merge_6  # 73o

        andc    $hit_5,$hit_7,$disc_18                  # 74e
        shufb   $t_best,$t_best_6,$t_8,$merge_6         # 74o

        fm      $s_8,$disc_19,$y                        # 75e
        frsqest $y_10,$disc_21                          # 76o

        fma     $e_6,$e_6,$half,$whole                  # 77e
        rotqbii $hit_14,$hit_5,1                        # 77o

        nop     $127                                    # 78e pairing
        stqd    $nearest,288($a_packet_6)               # 78o

        fnms    $t_4,$s_14,$e_8,$b_13                   # 79e
        stqd    $t_best,224($a_packet_6)                # 79o

        fi      $y_12,$disc_21,$y_10                    # 80e
        lqd     $t_best,208($a_packet_7)                # 80o

        nop     $127                                    # 81e pairing
        gb      $hit_10,$hit_14                         # 81o

        fnms    $e_5,$s_8,$y,$k_one                     # 82e
        lqd     $t_best_3,192($a_packet_7)              # 82o

        fnms    $t_3,$s_9,$e_6,$b_14                    # 83e
        lqd     $t_best_8,224($a_packet_7)              # 83o

        lqd     $nearest,256($a_packet_7)               # 84o
        shlqbii $hit_11,$hit_10,4                       # 85o

        clgt    $hit_4,$t_best,$t_4                     # 86e
        lqd     $nearest_4,272($a_packet_7)             # 86o

        fm      $s_14,$disc_21,$y_12                    # 87e
        lqd     $nearest_2,288($a_packet_7)             # 87o

        fma     $e_5,$e_5,$half,$whole                  # 88e
        lnop                                            # 88o pairing

        clgt    $hit_2,$t_best_3,$t_3                   # 89e
        lqx     $merge,$a_merges,$hit_11                # 89o

        andc    $hit_4,$hit_4,$disc_17                  # 90e
        andc    $hit_5,$hit_2,$disc_15                  # 91e

        nop     $127                                    # 92e pairing
        rotqbii $hit_6,$hit_4,1                         # 92o

        fnms    $e_8,$s_14,$y_12,$k_one                 # 93e
        rotqbii $hit_5,$hit_5,1                         # 93o

        fnms    $t_2,$s_8,$e_5,$b_15                    # 94e
        shufb   $nearest_8,$nearest_3,$object_5,$merge  # 95o

        gb      $hit_6,$hit_6                           # 96o
        gb      $hit_5,$hit_5                           # 97o

        nop     $127                                    # 98e pairing
        shufb   $t_best_2,$t_best_2,$t_5,$merge         # 98o

        fma     $e_8,$e_8,$half,$whole                  # 99e
        stqd    $nearest_8,304($a_packet_6)             # 99o

        clgt    $hit_3,$t_best_8,$t_2                   # 100e
        shlqbii $hit_6,$hit_6,4                         # 100o

        nop     $127                                    # 101e pairing
        lqd     $nearest_3,304($a_packet_7)             # 101o

        andc    $hit_3,$hit_3,$disc_19                  # 102e
        shlqbii $hit_8,$hit_5,4                         # 102o

        stqd    $t_best_2,240($a_packet_6)              # 103o
        lqx     $merge_2,$a_merges,$hit_6               # 104o

        fnms    $t_5,$s_14,$e_8,$b_16                   # 105e
        rotqbii $hit_3,$hit_3,1                         # 105o

        lqx     $merge_7,$a_merges,$hit_8               # 106o
        lqd     $t_best_2,240($a_packet_7)              # 107o

        gb      $hit_9,$hit_3                           # 109o
        shufb   $nearest_8,$nearest_4,$object_6,$merge_2 # 110o

        shufb   $t_best,$t_best,$t_4,$merge_2           # 111o
        shufb   $t_best_5,$t_best_3,$t_3,$merge_7       # 112o

        clgt    $hit_7,$t_best_2,$t_5                   # 113e
        shlqbii $hit_9,$hit_9,4                         # 113o

        nop     $127                                    # 114e pairing
        stqd    $nearest_8,272($a_packet_5)             # 114o

        andc    $hit_5,$hit_7,$disc_21                  # 115e
        stqd    $t_best,208($a_packet_5)                # 115o

        stqd    $t_best_5,192($a_packet_5)              # 116o
        rotqbii $hit_10,$hit_5,1                        # 117o

        lqx     $merge_4,$a_merges,$hit_9               # 118o
        shufb   $nearest,$nearest,$object_6,$merge_7    # 119o

        gb      $hit_10,$hit_10                         # 121o
        stqd    $nearest,256($a_packet_5)               # 123o

        shufb   $nearest,$nearest_2,$object_6,$merge_4  # 124o
        shufb   $t_best,$t_best_8,$t_2,$merge_4         # 125o

        shlqbii $hit_11,$hit_10,4                       # 126o
        stqd    $nearest,288($a_packet_5)               # 128o

        stqd    $t_best,224($a_packet_5)                # 129o
        lqx     $merge,$a_merges,$hit_11                # 130o

        shufb   $nearest_6,$nearest_3,$object_6,$merge  # 136o
        shufb   $t_best_2,$t_best_2,$t_5,$merge         # 137o

        stqd    $nearest_6,304($a_packet_5)             # 140o
        stqd    $t_best_2,240($a_packet_5)              # 141o

        nop     $127                                    # 142e pairing
isect_pairs_factored_r16_return:
        bi      $lr                                     # 142o

next_pair_short:
        ai      $count,$count,-1                        # 0e
        lqd     $object,0($a_pair)                      # 0o

        ai      $a_pair,$a_pair,16                      # 1e
        rotqbyi $a_packet,$object,4                     # 6o

        lqd     $quad,0($object)                        # 7o
        shufb   $object,$object,$object,$m_x            # 8o

        lqd     $dx,16($a_packet)                       # 10o
        lqd     $dy,64($a_packet)                       # 11o

        lqd     $dx_6,0($a_packet)                      # 12o
        shufb   $fx,$quad,$quad,$m_x                    # 13o

        lqd     $dy_6,80($a_packet)                     # 14o
        lqd     $dx_7,48($a_packet)                     # 15o

        nop     $127                                    # 16e pairing
        lqd     $dz,144($a_packet)                      # 16o

        fm      $b,$fx,$dx                              # 17e
        shufb   $fy,$quad,$quad,$m_y                    # 17o

        fm      $b_17,$fx,$dx_6                         # 18e
        lqd     $dy_7,112($a_packet)                    # 18o

        lqd     $dz_6,128($a_packet)                    # 19o
        lqd     $dy_8,96($a_packet)                     # 20o

        fm      $b_18,$fx,$dx_7                         # 21e
        shufb   $fz_3,$quad,$quad,$m_z                  # 21o

        nop     $127                                    # 22e pairing
        lqd     $dx_8,32($a_packet)                     # 22o

        fma     $b,$fy,$dy_6,$b                         # 23e
        lqd     $dz_7,160($a_packet)                    # 23o

        fma     $b_17,$fy,$dy,$b_17                     # 24e
        lqd     $dz_8,176($a_packet)                    # 24o

        shufb   $radius2_3,$quad,$quad,$m_radius2       # 25o
        lqd     $t_best_9,192($a_packet)                # 26o

        fma     $b_18,$fy,$dy_7,$b_18                   # 27e
        lqd     $t_best_10,208($a_packet)               # 27o

        fm      $b_19,$fx,$dx_8                         # 28e
        lqd     $t_best_11,224($a_packet)               # 28o

        fma     $b,$fz_3,$dz,$b                         # 29e
        frsqest $y_17,$radius2_3                        # 29o

        fma     $b_17,$fz_3,$dz_6,$b_17                 # 30e
        lqd     $t_best_12,240($a_packet)               # 30o

        lqd     $nearest_9,256($a_packet)               # 31o
        lqd     $nearest_10,272($a_packet)              # 32o

        fma     $b_18,$fz_3,$dz_8,$b_18                 # 33e
        lqd     $nearest_11,288($a_packet)              # 33o

        fma     $b_19,$fy,$dy_8,$b_19                   # 34e
        lqd     $nearest_12,304($a_packet)              # 34o

        fnms    $lx_6,$b,$dx,$fx                        # 35e
        fnms    $lx_7,$b_17,$dx_6,$fx                   # 36e

        fnms    $lz_6,$b_17,$dz_6,$fz_3                 # 37e
        fnms    $lz_7,$b,$dz,$fz_3                      # 38e

        fnms    $ly_5,$b_17,$dy,$fy                     # 39e
        fma     $b_19,$fz_3,$dz_7,$b_19                 # 40e

        fm      $disc_22,$lx_6,$lx_6                    # 41e
        fm      $disc_8,$lx_7,$lx_7                     # 42e

        fnms    $ly_6,$b,$dy_6,$fy                      # 43e
        fnms    $lx_8,$b_18,$dx_7,$fx                   # 44e

        fnms    $ly_7,$b_18,$dy_7,$fy                   # 45e
        fnms    $lx_9,$b_19,$dx_8,$fx                   # 46e

        fnms    $ly_8,$b_19,$dy_8,$fy                   # 47e
        fma     $disc_8,$ly_5,$ly_5,$disc_8             # 48e

        fma     $disc_6,$ly_6,$ly_6,$disc_22            # 49e
        fm      $disc_23,$lx_8,$lx_8                    # 50e

        fnms    $lz_8,$b_18,$dz_8,$fz_3                 # 51e
        fm      $disc_24,$lx_9,$lx_9                    # 52e

        fi      $y_18,$radius2_3,$y_17                  # 53e
        fma     $disc_8,$lz_6,$lz_6,$disc_8             # 55e

        fma     $disc_6,$lz_7,$lz_7,$disc_6             # 56e
        fma     $disc_23,$ly_7,$ly_7,$disc_23           # 57e

        fma     $disc_7,$ly_8,$ly_8,$disc_24            # 58e
        fnms    $lz_6,$b_19,$dz_7,$fz_3                 # 59e

        fm      $s,$radius2_3,$y_18                     # 60e
        lnop                                            # 60o pairing

        fm      $y_19,$y_18,$k_half                     # 61e
        frsqest $y_20,$disc_8                           # 61o

        frsqest $y_21,$disc_6                           # 62o
        fma     $disc_23,$lz_8,$lz_8,$disc_23           # 63e

        fi      $y_20,$disc_8,$y_20                     # 65e
        fi      $y_11,$disc_6,$y_21                     # 66e

        fma     $disc_7,$lz_6,$lz_6,$disc_7             # 68e
        lnop                                            # 68o pairing

        fnms    $radius,$s,$s,$radius2_3                # 69e
        frsqest $y_3,$disc_23                           # 69o

        fm      $s_15,$disc_8,$y_20                     # 72e
        fm      $s_7,$disc_6,$y_11                      # 73e

        fi      $y_3,$disc_23,$y_3                      # 74e
        frsqest $y_22,$disc_7                           # 74o

        fma     $radius,$radius,$y_19,$s                # 76e
        fnms    $e_13,$s_15,$y_20,$k_one                # 78e

        fi      $y_22,$disc_7,$y_22                     # 79e
        fm      $s,$disc_23,$y_3                        # 81e

        fnms    $e_4,$s_7,$y_11,$k_one                  # 82e
        fma     $e_13,$e_13,$k_half,$k_one              # 84e

        fm      $s_16,$disc_7,$y_22                     # 86e
        fnms    $e_6,$s,$y_3,$k_one                     # 87e

        fma     $e_4,$e_4,$k_half,$k_one                # 88e
        fm      $s_15,$s_15,$e_13                       # 90e

        fnms    $e_14,$s_16,$y_22,$k_one                # 92e
        fma     $e_6,$e_6,$k_half,$k_one                # 93e

        fm      $s_7,$s_7,$e_4                          # 94e
        fa      $s_8,$radius,$s_15                      # 96e

        fs      $disc_8,$radius,$s_15                   # 97e
        fma     $e_14,$e_14,$k_half,$k_one              # 98e

        fm      $s,$s,$e_6                              # 99e
        fs      $disc_5,$radius,$s_7                    # 100e

        fa      $s_7,$radius,$s_7                       # 101e
        fm      $disc_8,$disc_8,$s_8                    # 103e

        fm      $s_8,$s_16,$e_14                        # 104e
        fa      $s_16,$radius,$s                        # 105e

        fs      $disc_25,$radius,$s                     # 106e
        fm      $disc_6,$disc_5,$s_7                    # 107e

        frsqest $y_3,$disc_8                            # 109o
        fs      $disc_24,$radius,$s_8                   # 110e

        fa      $s,$radius,$s_8                         # 111e
        fm      $disc_23,$disc_25,$s_16                 # 112e

        fi      $y_7,$disc_8,$y_3                       # 113e
        frsqest $y_3,$disc_6                            # 113o

        fm      $disc_25,$disc_24,$s                    # 117e
        lnop                                            # 117o pairing

        fi      $y_3,$disc_6,$y_3                       # 118e
        frsqest $y_19,$disc_23                          # 118o

        fm      $s,$disc_8,$y_7                         # 120e
        fi      $y_19,$disc_23,$y_19                    # 122e

        frsqest $y_20,$disc_25                          # 123o
        fm      $s_10,$disc_6,$y_3                      # 125e

        fnms    $e_5,$s,$y_7,$k_one                     # 126e
        fi      $y_20,$disc_25,$y_20                    # 127e

        fm      $s_12,$disc_23,$y_19                    # 129e
        fnms    $e_6,$s_10,$y_3,$k_one                  # 131e

        fma     $e_5,$e_5,$half,$whole                  # 132e
        fm      $s_17,$disc_25,$y_20                    # 134e

        fnms    $e_13,$s_12,$y_19,$k_one                # 135e
        fma     $e_6,$e_6,$half,$whole                  # 137e

        fnms    $t_6,$s,$e_5,$b_17                      # 138e
        fnms    $e_5,$s_17,$y_20,$k_one                 # 140e

        fma     $e_13,$e_13,$half,$whole                # 141e
        fnms    $t_3,$s_10,$e_6,$b                      # 143e

        clgt    $hit_6,$t_best_9,$t_6                   # 144e
        fma     $e_5,$e_5,$half,$whole                  # 146e

        fnms    $t_9,$s_12,$e_13,$b_18                  # 147e
        andc    $hit_15,$hit_6,$disc_8                  # 148e

        clgt    $hit_6,$t_best_10,$t_3                  # 149e
        rotqbii $hit_15,$hit_15,1                       # 150o

        andc    $hit_16,$hit_6,$disc_6                  # 151e
        fnms    $t_2,$s_17,$e_5,$b_19                   # 152e

        clgt    $hit_6,$t_best_12,$t_9                  # 153e
        rotqbii $hit_16,$hit_16,1                       # 153o

        gb      $hit_15,$hit_15                         # 154o
        andc    $hit_9,$hit_6,$disc_23                  # 155e

        nop     $127                                    # 156e pairing
        gb      $hit_16,$hit_16                         # 157o

        clgt    $hit_6,$t_best_11,$t_2                  # 158e
        shlqbii $hit_15,$hit_15,4                       # 158o

        rotqbii $hit_9,$hit_9,1                         # 159o
        andc    $hit_13,$hit_6,$disc_25                 # 160e

        shlqbii $hit_16,$hit_16,4                       # 161o
        lqx     $merge_7,$a_merges,$hit_15              # 162o

        rotqbii $hit_13,$hit_13,1                       # 163o
        gb      $hit_9,$hit_9                           # 164o

        lqx     $merge_8,$a_merges,$hit_16              # 165o
        gb      $hit_13,$hit_13                         # 167o

        shufb   $nearest,$nearest_9,$object,$merge_7    # 168o
        shufb   $t_best,$t_best_9,$t_6,$merge_7         # 169o

        shlqbii $hit_15,$hit_9,4                        # 170o
        shufb   $t_best_13,$t_best_10,$t_3,$merge_8     # 171o

        shlqbii $hit_10,$hit_13,4                       # 172o
        stqd    $t_best,192($a_packet)                  # 173o

        shufb   $nearest_5,$nearest_10,$object,$merge_8 # 174o
        stqd    $t_best_13,208($a_packet)               # 175o

        lqx     $merge_4,$a_merges,$hit_10              # 176o
        lqx     $merge_7,$a_merges,$hit_15              # 177o

        stqd    $nearest,256($a_packet)                 # 178o
        stqd    $nearest_5,272($a_packet)               # 179o

        hbrr    next_pair_short_back,next_pair_short    # 180o hint
        shufb   $nearest,$nearest_11,$object,$merge_4   # 182o

        shufb   $nearest_5,$nearest_12,$object,$merge_7 # 183o
        shufb   $t_best,$t_best_12,$t_9,$merge_7        # 184o

        shufb   $t_best_7,$t_best_11,$t_2,$merge_4      # 185o
        stqd    $nearest,288($a_packet)                 # 186o

        stqd    $nearest_5,304($a_packet)               # 187o
        stqd    $t_best,240($a_packet)                  # 188o

        stqd    $t_best_7,224($a_packet)                # 189o
next_pair_short_back:
        brnz    $count,next_pair_short                  # 195o

        nop     $127                                    # 191e pairing
        bi      $lr                                     # 191o
endfunction isect_pairs_factored_r16
