# isect_pairs_unnormalised_r16   nearest entry of packets' eye rays into spheres, rays of any length
#   C       void isect_pairs_unnormalised_r16(const struct pair *, int count);
#   In      $3 pairs, $4 count (0 is none); pointers 16-aligned
#   Out     the pairs' packets: t, object, where an entry is nearer than what was there
#   Uses    $2-$73, $79   Saves  -   Stack  0   Calls  -
#   Domain  direction of a length from 2^-20 to 2^20; radius > 0; centre and radius from 2^-20 to
#           2^40; t in parts of the direction's length
#   Error   12 ulp of t, eye 1.5 to 30 radii from the centre, ray within 0.995 r of it
#   Twin    oracle/src/twin/sphere/unnormalised.rs
#
# The steps are those of sphere_tmpl.inc. An opaque sphere has no inside: only the entry counts, and
# behind the eye it is none.
# Scheduled by spu schedule from isect_pairs_unnormalised_r16.s

        .include "work_unit.inc"
        .include "macros.inc"
        .include "sphere_tmpl.inc"
        .include "sphere_unnormalised.inc"

        .set    a_pair,3
        .set    count,4
        # constants
        .set    k_one,10
        .set    half,11
        .set    whole,12
        .set    m_x,13
        .set    m_y,14
        .set    m_z,15
        .set    m_radius2,16
        .set    a_merges,17
        # the pair
        .set    object,18
        .set    a_packet,19
        .set    quad,20
        .set    cx,21
        .set    cy,22
        .set    cz,23
        .set    fx,21                                   # c
        .set    fy,22
        .set    fz,23
        .set    radius2,24
        # a row
        .set    dx,25
        .set    dy,26
        .set    dz,27
        .set    t_best,28
        .set    nearest,29
        # temporaries
        .set    b,30
        .set    lx,31
        .set    ly,32
        .set    lz,33
        .set    disc,34
        .set    y,35
        .set    s,36
        .set    e,37
        .set    over_a,38
        .set    t,39
        .set    hit,40
        .set    merge,41

        merges_table

function isect_pairs_unnormalised_r16
        .set    count_2,79
        .set    a_pair_2,2
        .set    object_2,2
        .set    object_3,66
        .set    a_packet_2,5
        .set    dx_2,7
        .set    dx_3,22
        .set    dx_4,23
        .set    dx_5,8
        .set    dy_2,9
        .set    dy_3,24
        .set    dy_4,28
        .set    e_2,21
        .set    dy_5,18
        .set    e_3,27
        .set    dz_2,29
        .set    e_4,6
        .set    dz_3,30
        .set    dz_4,31
        .set    fx_2,33
        .set    dz_5,34
        .set    fy_2,35
        .set    fz_2,40
        .set    radius2_2,20
        .set    b_2,32
        .set    a_packet_3,64
        .set    b_3,41
        .set    a_packet_4,65
        .set    quad_2,19
        .set    dx_6,48
        .set    e_5,42
        .set    dx_7,47
        .set    b_4,46
        .set    dx_8,6
        .set    b_5,38
        .set    y_2,50
        .set    b_6,44
        .set    y_3,51
        .set    e_6,52
        .set    y_4,32
        .set    e_7,53
        .set    y_5,36
        .set    dy_6,71
        .set    dy_7,72
        .set    y_6,58
        .set    dy_8,68
        .set    y_7,59
        .set    dz_6,73
        .set    dz_7,32
        .set    dz_8,36
        .set    b_7,55
        .set    fx_3,38
        .set    s_2,37
        .set    dz_9,39
        .set    s_3,21
        .set    fy_3,43
        .set    s_4,27
        .set    t_best_2,45
        .set    s_5,42
        .set    t_best_3,49
        .set    fz_3,54
        .set    b_8,67
        .set    radius2_3,55
        .set    b_9,19
        .set    nearest_2,56
        .set    over_a_2,21
        .set    nearest_3,57
        .set    over_a_3,27
        .set    t_best_4,58
        .set    nearest_4,60
        .set    over_a_4,51
        .set    t_best_5,61
        .set    over_a_5,50
        .set    object_4,62
        .set    a_packet_5,63
        .set    b_10,69
        .set    nearest_5,59
        .set    b_11,70
        .set    b_12,2
        .set    e_8,5
        .set    ly_2,28
        .set    ly_3,18
        .set    lx_2,23
        .set    lz_2,29
        .set    lx_3,22
        .set    ly_4,24
        .set    lx_4,8
        .set    lz_3,30
        .set    disc_2,23
        .set    lx_5,7
        .set    disc_3,22
        .set    lz_4,31
        .set    disc_4,8
        .set    ly_5,9
        .set    disc_5,18
        .set    disc_6,7
        .set    disc_7,20
        .set    lz_5,22
        .set    e_9,23
        .set    disc_8,9
        .set    e_10,18
        .set    e_11,20
        .set    disc_9,35
        .set    b_13,29
        .set    y_8,31
        .set    disc_10,42
        .set    y_9,33
        .set    e_12,9
        .set    y_10,44
        .set    b_14,5
        .set    y_11,7
        .set    y_12,52
        .set    y_13,53
        .set    s_6,20
        .set    e_13,31
        .set    s_7,9
        .set    s_8,40
        .set    b_15,18
        .set    b_16,22
        .set    over_a_6,46
        .set    e_14,44
        .set    b_17,23
        .set    t_2,44
        .set    s_9,19
        .set    t_3,9
        .set    ly_6,5
        .set    e_15,7
        .set    t_4,68
        .set    hit_2,20
        .set    hit_3,8
        .set    hit_4,23
        .set    hit_5,7
        .set    lz_6,21
        .set    ly_7,47
        .set    ly_8,22
        .set    t_5,71
        .set    hit_6,2
        .set    disc_11,5
        .set    merge_2,6
        .set    lx_6,2
        .set    lz_7,8
        .set    t_best_6,9
        .set    nearest_6,6
        .set    disc_12,2
        .set    hit_7,9
        .set    dy_9,5
        .set    dz_10,8
        .set    e_16,29
        .set    y_14,47
        .set    b_18,48
        .set    merge_3,40
        .set    merge_4,2
        .set    nearest_7,40
        .set    t_best_7,2
        .set    y_15,21
        .set    s_10,47
        .set    e_17,19
        .set    s_11,18
        .set    lz_8,3
        .set    a_packet_6,4
        .set    lz_9,13
        .set    hit_8,6
        .set    hit_9,3
        .set    disc_13,6
        .set    merge_5,3
        .set    t_best_8,5
        .set    s_12,3
        .set    t_6,5
        .set    e_18,3
        .set    merge_6,5
        .set    dx_9,2
        .set    dx_10,5
        .set    dy_10,6
        .set    dz_11,7
        .set    e_19,8
        .set    dx_11,21
        .set    e_20,22
        .set    dz_12,23
        .set    fx_4,24
        .set    dz_13,28
        .set    dy_11,29
        .set    fy_4,30
        .set    fz_4,32
        .set    b_19,33
        .set    b_20,34
        .set    t_best_9,35
        .set    b_21,36
        .set    t_best_10,38
        .set    t_best_11,39
        .set    t_best_12,40
        .set    nearest_8,41
        .set    nearest_9,42
        .set    nearest_10,43
        .set    nearest_11,44
        .set    y_16,45
        .set    y_17,48
        .set    y_18,49
        .set    s_13,8
        .set    over_a_7,37
        .set    b_22,45
        .set    s_14,22
        .set    s_15,31
        .set    over_a_8,8
        .set    over_a_9,22
        .set    over_a_10,31
        .set    ly_9,26
        .set    lx_7,25
        .set    ly_10,6
        .set    lz_10,7
        .set    disc_14,25
        .set    ly_11,29
        .set    lx_8,21
        .set    lz_11,27
        .set    lx_9,5
        .set    disc_15,21
        .set    lz_12,6
        .set    lz_13,23
        .set    disc_16,24
        .set    y_19,8
        .set    y_20,9
        .set    y_21,20
        .set    y_22,22
        .set    s_16,23
        .set    s_17,24
        .set    t_7,21
        .set    t_8,8
        .set    t_9,20
        .set    merge_7,7
        .set    hit_10,22
        .set    hit_11,5
        .set    nearest_12,2
        nop     $127                                    # 0e pairing
        biz     $count,$lr                              # 0o

        ilhu    $m_x,1                                  # 1e
        ilhu    $m_y,0x405                              # 2e

        ilhu    $m_z,0x809                              # 3e
        ilhu    $m_radius2,0xc0d                        # 4e

        ilhu    $half,0x3f00                            # 5e
        ilhu    $whole,0x3f80                           # 6e

        clgti   $count_2,$count,2                       # 7e at least as many passes as overlap
        iohl    $m_x,515                                # 8e

        iohl    $m_y,0x607                              # 9e
        iohl    $m_z,0xa0b                              # 10e

        iohl    $m_radius2,0xe0f                        # 11e
        ila     $a_merges,merges                        # 12e

        iohl    $half,0                                 # 13e
        iohl    $whole,0                                # 14e

        ilhu    $k_one,0x3f80                           # 15e
        brz     $count_2,next_pair_short                # 15o too few passes

        ai      $a_pair_2,$a_pair,16                    # 16e
        lqd     $object,0($a_pair)                      # 16o

        ai      $count,$count,-1                        # 17e
        lnop                                            # 17o pairing

        ai      $a_pair,$a_pair_2,16                    # 18e
        lqd     $object_2,0($a_pair_2)                  # 18o

        ai      $count,$count,-1                        # 19e
        rotqbyi $a_packet,$object,4                     # 22o

        lqd     $quad,0($object)                        # 23o
        shufb   $object_3,$object,$object,$m_x          # 24o

        rotqbyi $a_packet_2,$object_2,4                 # 25o
        lqd     $dx_2,16($a_packet)                     # 26o

        lqd     $dx_3,48($a_packet)                     # 27o
        lqd     $dx_4,0($a_packet)                      # 28o

        lqd     $dx_5,32($a_packet)                     # 29o
        lqd     $dy_2,80($a_packet)                     # 30o

        nop     $127                                    # 31e pairing
        lqd     $dy_3,96($a_packet)                     # 31o

        fm      $e,$dx_2,$dx_2                          # 32e
        lqd     $dy_4,112($a_packet)                    # 32o

        fm      $e_2,$dx_3,$dx_3                        # 33e
        lqd     $dy_5,64($a_packet)                     # 33o

        fm      $e_3,$dx_4,$dx_4                        # 34e
        lqd     $dz_2,128($a_packet)                    # 34o

        fm      $e_4,$dx_5,$dx_5                        # 35e
        lqd     $dz_3,176($a_packet)                    # 35o

        lqd     $dz_4,144($a_packet)                    # 36o
        shufb   $fx_2,$quad,$quad,$m_x                  # 37o

        fma     $e,$dy_2,$dy_2,$e                       # 38e
        lqd     $dz_5,160($a_packet)                    # 38o

        fma     $e_2,$dy_4,$dy_4,$e_2                   # 39e
        shufb   $fy_2,$quad,$quad,$m_y                  # 39o

        fma     $e_3,$dy_5,$dy_5,$e_3                   # 40e
        shufb   $fz_2,$quad,$quad,$m_z                  # 40o

        fma     $e_4,$dy_3,$dy_3,$e_4                   # 41e
        shufb   $radius2_2,$quad,$quad,$m_radius2       # 41o

        fm      $b_2,$fx_2,$dx_4                        # 42e
        shlqbyi $a_packet_3,$a_packet,0                 # 42o copy

        fm      $b_3,$fx_2,$dx_2                        # 43e
        shlqbyi $a_packet_4,$a_packet,0                 # 43o copy

        fma     $e,$dz_4,$dz_4,$e                       # 44e
        lqd     $quad_2,0($object_2)                    # 44o

        fma     $e_2,$dz_3,$dz_3,$e_2                   # 45e
        lqd     $dx,16($a_packet_2)                     # 45o

        fma     $e_3,$dz_2,$dz_2,$e_3                   # 46e
        lqd     $dx_6,48($a_packet_2)                   # 46o

        fma     $e_5,$dz_5,$dz_5,$e_4                   # 47e
        lqd     $dx_7,0($a_packet_2)                    # 47o

        fm      $b_4,$fx_2,$dx_3                        # 48e
        lqd     $dx_8,32($a_packet_2)                   # 48o

        fma     $b_3,$fy_2,$dy_2,$b_3                   # 49e
        lqd     $dy,80($a_packet_2)                     # 49o

        fm      $b_5,$fx_2,$dx_5                        # 50e
        frest   $y_2,$e                                 # 50o

        fma     $b_6,$fy_2,$dy_5,$b_2                   # 51e
        frest   $y_3,$e_2                               # 51o

        fm      $e_6,$dx,$dx                            # 52e
        frest   $y_4,$e_3                               # 52o

        fm      $e_7,$dx_6,$dx_6                        # 53e
        frest   $y_5,$e_5                               # 53o

        fi      $y_2,$e,$y_2                            # 54e
        lqd     $dy_6,96($a_packet_2)                   # 54o

        fi      $y_3,$e_2,$y_3                          # 55e
        lqd     $dy_7,112($a_packet_2)                  # 55o

        fi      $y_6,$e_3,$y_4                          # 56e
        lqd     $dy_8,64($a_packet_2)                   # 56o

        fi      $y_7,$e_5,$y_5                          # 57e
        lqd     $dz_6,128($a_packet_2)                  # 57o

        nop     $127                                    # 58e pairing
        lqd     $dz_7,176($a_packet_2)                  # 58o

        fma     $b_4,$fy_2,$dy_4,$b_4                   # 59e
        lqd     $dz_8,144($a_packet_2)                  # 59o

        fma     $b_7,$fy_2,$dy_3,$b_5                   # 60e
        shufb   $fx_3,$quad_2,$quad_2,$m_x              # 60o

        fnms    $s_2,$e,$y_2,$k_one                     # 61e
        lqd     $dz_9,160($a_packet_2)                  # 61o

        fnms    $s_3,$e_2,$y_3,$k_one                   # 62e
        shufb   $fy_3,$quad_2,$quad_2,$m_y              # 62o

        fnms    $s_4,$e_3,$y_6,$k_one                   # 63e
        lqd     $t_best_2,192($a_packet_4)              # 63o

        fnms    $s_5,$e_5,$y_7,$k_one                   # 64e
        lqd     $t_best_3,224($a_packet_4)              # 64o

        fma     $b_4,$fz_2,$dz_3,$b_4                   # 65e
        shufb   $fz_3,$quad_2,$quad_2,$m_z              # 65o

        fma     $b_8,$fz_2,$dz_5,$b_7                   # 66e
        shufb   $radius2_3,$quad_2,$quad_2,$m_radius2   # 66o

        fma     $b_9,$fz_2,$dz_2,$b_6                   # 67e
        lqd     $nearest_2,256($a_packet_4)             # 67o

        fma     $over_a_2,$s_3,$y_3,$y_3                # 68e
        lqd     $nearest_3,288($a_packet_4)             # 68o

        fma     $over_a_3,$s_4,$y_6,$y_6                # 69e
        lqd     $t_best_4,208($a_packet_4)              # 69o

        fma     $b_3,$fz_2,$dz_4,$b_3                   # 70e
        lqd     $nearest_4,272($a_packet_4)             # 70o

        fma     $over_a_4,$s_5,$y_7,$y_7                # 71e
        lqd     $t_best_5,240($a_packet_4)              # 71o

        fma     $over_a_5,$s_2,$y_2,$y_2                # 72e
        shlqbyi $object_4,$object_3,0                   # 72o copy

        fm      $e,$dx_7,$dx_7                          # 73e
        shlqbyi $a_packet_5,$a_packet_3,0               # 73o copy

        fm      $b_10,$b_4,$over_a_2                    # 74e
        lqd     $nearest_5,304($a_packet_4)             # 74o

        fm      $b_9,$b_9,$over_a_3                     # 75e
        shlqbyi $a_packet_3,$a_packet_2,0               # 75o copy

        fm      $e_5,$dx_8,$dx_8                        # 76e
        shlqbyi $a_packet_4,$a_packet_2,0               # 76o copy

        fm      $b_11,$b_8,$over_a_4                    # 77e
        shufb   $object_3,$object_2,$object_2,$m_x      # 77o

        fm      $b_12,$b_3,$over_a_5                    # 78e
        fma     $e_8,$dy,$dy,$e_6                       # 79e

        fnms    $ly_2,$b_10,$dy_4,$fy_2                 # 80e
        fnms    $ly_3,$b_9,$dy_5,$fy_2                  # 81e

        fnms    $lx_2,$b_9,$dx_4,$fx_2                  # 82e
        fnms    $lz_2,$b_9,$dz_2,$fz_2                  # 83e

        fnms    $lx_3,$b_10,$dx_3,$fx_2                 # 84e
        fnms    $ly_4,$b_11,$dy_3,$fy_2                 # 85e

        fnms    $lx_4,$b_11,$dx_5,$fx_2                 # 86e
        fnms    $lz_3,$b_10,$dz_3,$fz_2                 # 87e

        fnms    $disc_2,$lx_2,$lx_2,$radius2_2          # 88e
        fnms    $lx_5,$b_12,$dx_2,$fx_2                 # 89e

        fnms    $disc_3,$lx_3,$lx_3,$radius2_2          # 90e
        fnms    $lz_4,$b_12,$dz_4,$fz_2                 # 91e

        fnms    $disc_4,$lx_4,$lx_4,$radius2_2          # 92e
        fnms    $ly_5,$b_12,$dy_2,$fy_2                 # 93e

        fnms    $disc_5,$ly_3,$ly_3,$disc_2             # 94e
        fnms    $disc_6,$lx_5,$lx_5,$radius2_2          # 95e

        fnms    $disc_7,$ly_2,$ly_2,$disc_3             # 96e
        fnms    $lz_5,$b_11,$dz_5,$fz_2                 # 97e

        fnms    $disc_4,$ly_4,$ly_4,$disc_4             # 98e
        fma     $e_9,$dy_7,$dy_7,$e_7                   # 99e

        fnms    $disc,$lz_2,$lz_2,$disc_5               # 100e
        fnms    $disc_6,$ly_5,$ly_5,$disc_6             # 101e

        fnms    $disc_8,$lz_3,$lz_3,$disc_7             # 102e
        fma     $e_10,$dy_8,$dy_8,$e                    # 103e

        fnms    $disc_4,$lz_5,$lz_5,$disc_4             # 104e
        fma     $e_11,$dy_6,$dy_6,$e_5                  # 105e

        fm      $disc,$disc,$over_a_3                   # 106e
        fnms    $disc_6,$lz_4,$lz_4,$disc_6             # 107e

        fm      $disc_9,$disc_8,$over_a_2               # 108e
        fm      $b_13,$fx_3,$dx_7                       # 109e

        fm      $disc_4,$disc_4,$over_a_4               # 110e
        fm      $b_3,$fx_3,$dx                          # 111e

        fma     $e,$dz_8,$dz_8,$e_8                     # 112e
        frsqest $y_8,$disc                              # 112o

        fm      $disc_10,$disc_6,$over_a_5              # 113e
        lnop                                            # 113o pairing

        fma     $e_2,$dz_7,$dz_7,$e_9                   # 114e
        frsqest $y_9,$disc_9                            # 114o

        fma     $e_3,$dz_6,$dz_6,$e_10                  # 115e
        lnop                                            # 115o pairing

        fma     $e_12,$dz_9,$dz_9,$e_11                 # 116e
        frsqest $y_10,$disc_4                           # 116o

        fm      $b_4,$fx_3,$dx_6                        # 117e
        lnop                                            # 117o pairing

        fma     $b_3,$fy_3,$dy,$b_3                     # 118e
        frest   $y_2,$e                                 # 118o

        fm      $b_14,$fx_3,$dx_8                       # 119e
        frsqest $y_11,$disc_10                          # 119o

        fma     $b_13,$fy_3,$dy_8,$b_13                 # 120e
        frest   $y_3,$e_2                               # 120o

        fi      $y_8,$disc,$y_8                         # 121e
        frest   $y_12,$e_3                              # 121o

        fi      $y_9,$disc_9,$y_9                       # 122e
        frest   $y_13,$e_12                             # 122o

        fi      $y_10,$disc_4,$y_10                     # 123e
        fi      $y_2,$e,$y_2                            # 124e

        fi      $y_3,$e_2,$y_3                          # 125e
        fi      $y_12,$e_3,$y_12                        # 126e

        fi      $y_13,$e_12,$y_13                       # 127e
        fi      $y_11,$disc_10,$y_11                    # 128e

        fm      $s_6,$disc,$y_8                         # 130e
        fma     $b_4,$fy_3,$dy_7,$b_4                   # 131e

        fma     $b_14,$fy_3,$dy_6,$b_14                 # 132e
        fnms    $s_2,$e,$y_2,$k_one                     # 133e

        fnms    $s_4,$e_3,$y_12,$k_one                  # 134e
        fnms    $s_3,$e_2,$y_3,$k_one                   # 135e

        fnms    $e_13,$s_6,$y_8,$k_one                  # 136e
        fnms    $s_7,$e_12,$y_13,$k_one                 # 137e

        fm      $s_8,$disc_4,$y_10                      # 138e
        fma     $b_15,$fz_3,$dz_9,$b_14                 # 139e

        fma     $b_16,$fz_3,$dz_7,$b_4                  # 140e
        fma     $over_a_6,$s_3,$y_3,$y_3                # 141e

        fma     $over_a_3,$s_4,$y_12,$y_12              # 142e
        fm      $s_3,$disc_9,$y_9                       # 143e

        fnms    $e_14,$s_8,$y_10,$k_one                 # 144e
        fma     $e_8,$e_13,$half,$whole                 # 145e

        fma     $b_17,$fz_3,$dz_6,$b_13                 # 146e
        fma     $b_13,$fz_3,$dz_8,$b_3                  # 147e

        fma     $over_a_4,$s_7,$y_13,$y_13              # 148e
        fnms    $e_12,$s_3,$y_9,$k_one                  # 149e

        fma     $e_13,$e_14,$half,$whole                # 150e
        fnms    $t_2,$s_6,$e_8,$b_9                     # 151e

        fm      $b_8,$b_17,$over_a_3                    # 152e
        fm      $s_9,$disc_10,$y_11                     # 153e

        fma     $over_a_5,$s_2,$y_2,$y_2                # 154e
        fma     $e,$e_12,$half,$whole                   # 155e

        fnms    $t_3,$s_8,$e_13,$b_11                   # 156e
        clgt    $hit,$t_best_2,$t_2                     # 157e

        fnms    $ly_6,$b_8,$dy_8,$fy_3                  # 158e
        andc    $hit,$hit,$disc                         # 159e

        fnms    $e_15,$s_9,$y_11,$k_one                 # 160e
        lnop                                            # 160o pairing

        fnms    $lx,$b_8,$dx_7,$fx_3                    # 161e
        rotqbii $hit,$hit,1                             # 161o

        fnms    $t_4,$s_3,$e,$b_10                      # 162e
        clgt    $hit_2,$t_best_3,$t_3                   # 163e

        fm      $b_10,$b_16,$over_a_6                   # 164e
        lnop                                            # 164o pairing

        andc    $hit_3,$hit_2,$disc_4                   # 165e
        gb      $hit,$hit                               # 165o

        fm      $b_11,$b_15,$over_a_4                   # 166e
        lnop                                            # 166o pairing

        fma     $e,$e_15,$half,$whole                   # 167e
        rotqbii $hit_3,$hit_3,1                         # 167o

        fnms    $disc,$lx,$lx,$radius2_3                # 168e
        lnop                                            # 168o pairing

        clgt    $hit_4,$t_best_5,$t_4                   # 169e
        shlqbii $hit_5,$hit,4                           # 169o

        fnms    $lz_6,$b_8,$dz_6,$fz_3                  # 170e
        lnop                                            # 170o pairing

        fnms    $ly_7,$b_10,$dy_7,$fy_3                 # 171e
        gb      $hit,$hit_3                             # 171o

        fnms    $lx_4,$b_10,$dx_6,$fx_3                 # 172e
        fnms    $ly_8,$b_11,$dy_6,$fy_3                 # 173e

        fnms    $t_5,$s_9,$e,$b_12                      # 174e
        lnop                                            # 174o pairing

next_pair:
            fm      $b,$b_13,$over_a_5                  # 0e
            lnop                                        # 0o pairing

            fnms    $disc,$ly_6,$ly_6,$disc             # 1e
        lqd     $object,0($a_pair)                      # 1o

            fnms    $lx,$b_11,$dx_8,$fx_3               # 2e
            shlqbii $hit,$hit,4                         # 2o

            fnms    $lz,$b_10,$dz_7,$fz_3               # 3e
            lqx     $merge,$a_merges,$hit_5             # 3o

        ai      $a_pair,$a_pair,16                      # 4e
            clgt    $hit_6,$t_best_4,$t_5               # 5e

            fnms    $disc_11,$lx_4,$lx_4,$radius2_3     # 6e
            lqx     $merge_2,$a_merges,$hit             # 6o

            andc    $hit,$hit_6,$disc_10                # 7e
        rotqbyi $a_packet,$object,4                     # 7o

            fnms    $lx_6,$b,$dx,$fx_3                  # 8e
        lqd     $quad,0($object)                        # 8o

            fnms    $disc_6,$lx,$lx,$radius2_3          # 9e
            shufb   $nearest,$nearest_2,$object_4,$merge # 9o

            fnms    $lz_7,$b,$dz_8,$fz_3                # 10e
            shufb   $t_best,$t_best_2,$t_2,$merge       # 10o

            fnms    $disc,$lz_6,$lz_6,$disc             # 11e
            rotqbii $hit,$hit,1                         # 11o

            fnms    $disc_11,$ly_7,$ly_7,$disc_11       # 12e
            shufb   $t_best_6,$t_best_3,$t_3,$merge_2   # 12o

            fnms    $ly,$b,$dy,$fy_3                    # 13e
            shufb   $nearest_6,$nearest_3,$object_4,$merge_2 # 13o

            fnms    $disc_12,$lx_6,$lx_6,$radius2_3     # 14e
            stqd    $t_best,192($a_packet_5)            # 14o

            fnms    $lz_6,$b_11,$dz_9,$fz_3             # 15e
        lqd     $dx,16($a_packet)                       # 15o

            fnms    $disc_6,$ly_8,$ly_8,$disc_6         # 16e
            stqd    $t_best_6,224($a_packet_5)          # 16o

            andc    $hit_7,$hit_4,$disc_9               # 17e
        lqd     $dx_3,48($a_packet)                     # 17o

            fm      $disc,$disc,$over_a_3               # 18e
        lqd     $dx_4,0($a_packet)                      # 18o

            fnms    $disc_11,$lz,$lz,$disc_11           # 19e
            stqd    $nearest_6,288($a_packet_5)         # 19o

            fnms    $disc_12,$ly,$ly,$disc_12           # 20e
            stqd    $nearest,256($a_packet_5)           # 20o

        fm      $e,$dx,$dx                              # 21e
        lqd     $dx_8,32($a_packet)                     # 21o

            fnms    $disc_6,$lz_6,$lz_6,$disc_6         # 22e
        lqd     $dy,80($a_packet)                       # 22o

        fm      $e_2,$dx_3,$dx_3                        # 23e
        lqd     $dy_3,96($a_packet)                     # 23o

        fm      $e_3,$dx_4,$dx_4                        # 24e
        lqd     $dy_4,112($a_packet)                    # 24o

            fm      $disc_9,$disc_11,$over_a_6          # 25e
        lqd     $dy_9,64($a_packet)                     # 25o

            fnms    $disc_12,$lz_7,$lz_7,$disc_12       # 26e
        lqd     $dz_10,128($a_packet)                   # 26o

        fm      $e_16,$dx_8,$dx_8                       # 27e
        lqd     $dz_7,176($a_packet)                    # 27o

        fma     $e,$dy,$dy,$e                           # 28e
        lqd     $dz_8,144($a_packet)                    # 28o

            fm      $disc_6,$disc_6,$over_a_4           # 29e
        shufb   $fx_3,$quad,$quad,$m_x                  # 29o

        fma     $e_2,$dy_4,$dy_4,$e_2                   # 30e
        lqd     $dz_9,160($a_packet)                    # 30o

        fma     $e_3,$dy_9,$dy_9,$e_3                   # 31e
            frsqest $y_8,$disc                          # 31o

            fm      $disc_10,$disc_12,$over_a_5         # 32e
            rotqbii $hit_6,$hit_7,1                     # 32o

        fma     $e_12,$dy_3,$dy_3,$e_16                 # 33e
            gb      $hit,$hit                           # 33o

        fm      $b_13,$fx_3,$dx_4                       # 34e
            frsqest $y_9,$disc_9                        # 34o

        fm      $b_3,$fx_3,$dx                          # 35e
        shufb   $fy_3,$quad,$quad,$m_y                  # 35o

        fma     $e,$dz_8,$dz_8,$e                       # 36e
            gb      $hit_6,$hit_6                       # 36o

        fma     $e_2,$dz_7,$dz_7,$e_2                   # 37e
            shlqbii $hit,$hit,4                         # 37o

        fma     $e_3,$dz_10,$dz_10,$e_3                 # 38e
            frsqest $y_10,$disc_6                       # 38o

        fma     $e_12,$dz_9,$dz_9,$e_12                 # 39e
            lqd     $t_best_2,192($a_packet_4)          # 39o

        fm      $b_4,$fx_3,$dx_3                        # 40e
            frsqest $y_14,$disc_10                      # 40o

        fma     $b_3,$fy_3,$dy,$b_3                     # 41e
            shlqbii $hit_6,$hit_6,4                     # 41o

        fm      $b_18,$fx_3,$dx_8                       # 42e
            lqd     $t_best_3,224($a_packet_4)          # 42o

        fma     $b_13,$fy_3,$dy_9,$b_13                 # 43e
        frest   $y_2,$e                                 # 43o

            fi      $y_8,$disc,$y_8                     # 44e
        frest   $y_3,$e_2                               # 44o

            fi      $y_9,$disc_9,$y_9                   # 45e
        frest   $y_12,$e_3                              # 45o

            fi      $y_10,$disc_6,$y_10                 # 46e
        frest   $y_13,$e_12                             # 46o

        fi      $y_2,$e,$y_2                            # 47e
            lqx     $merge_3,$a_merges,$hit             # 47o

        fi      $y_3,$e_2,$y_3                          # 48e
            lqx     $merge_4,$a_merges,$hit_6           # 48o

        fi      $y_12,$e_3,$y_12                        # 49e
        shufb   $fz_3,$quad,$quad,$m_z                  # 49o

        fi      $y_13,$e_12,$y_13                       # 50e
        shufb   $radius2_3,$quad,$quad,$m_radius2       # 50o

        ai      $count,$count,-1                        # 51e
            lqd     $nearest_2,256($a_packet_4)         # 51o

            fm      $s_6,$disc,$y_8                     # 52e
            lqd     $nearest_3,288($a_packet_4)         # 52o

        fma     $b_4,$fy_3,$dy_4,$b_4                   # 53e
            shufb   $t_best_4,$t_best_4,$t_5,$merge_3   # 53o

        fma     $b_18,$fy_3,$dy_3,$b_18                 # 54e
            shufb   $nearest_7,$nearest_4,$object_4,$merge_3 # 54o

        fnms    $s_2,$e,$y_2,$k_one                     # 55e
            shufb   $nearest_5,$nearest_5,$object_4,$merge_4 # 55o

        fnms    $s_4,$e_3,$y_12,$k_one                  # 56e
            shufb   $t_best_7,$t_best_5,$t_4,$merge_4   # 56o

        fnms    $s_3,$e_2,$y_3,$k_one                   # 57e
            stqd    $t_best_4,208($a_packet_5)          # 57o

            fnms    $e_13,$s_6,$y_8,$k_one              # 58e
            lqd     $t_best_4,208($a_packet_4)          # 58o

        fnms    $s_7,$e_12,$y_13,$k_one                 # 59e
            stqd    $nearest_7,272($a_packet_5)         # 59o

            fm      $s_8,$disc_6,$y_10                  # 60e
            lqd     $nearest_4,272($a_packet_4)         # 60o

        fma     $b_18,$fz_3,$dz_9,$b_18                 # 61e
            stqd    $t_best_7,240($a_packet_5)          # 61o

        fma     $b_12,$fz_3,$dz_7,$b_4                  # 62e
            lqd     $t_best_5,240($a_packet_4)          # 62o

        fma     $over_a_6,$s_3,$y_3,$y_3                # 63e
            shlqbyi $object_4,$object_3,0               # 63o copy

        fma     $over_a_3,$s_4,$y_12,$y_12              # 64e
            stqd    $nearest_5,304($a_packet_5)         # 64o

            fi      $y_15,$disc_10,$y_14                # 65e
            shlqbyi $a_packet_5,$a_packet_3,0           # 65o copy

            nop     $127                                # 66e pairing
            lqd     $nearest_5,304($a_packet_4)         # 66o

            fm      $s_10,$disc_9,$y_9                  # 67e
        shlqbyi $a_packet_3,$a_packet,0                 # 67o copy

            fnms    $e_14,$s_8,$y_10,$k_one             # 68e
        shlqbyi $a_packet_4,$a_packet,0                 # 68o copy

            fma     $e_17,$e_13,$half,$whole            # 69e
        shufb   $object_3,$object,$object,$m_x          # 69o

        fma     $b_15,$fz_3,$dz_10,$b_13                # 70e
        fma     $b_13,$fz_3,$dz_8,$b_3                  # 71e

        fma     $over_a_4,$s_7,$y_13,$y_13              # 72e
            fnms    $e_12,$s_10,$y_9,$k_one             # 73e

            fma     $e_13,$e_14,$half,$whole            # 74e
            fnms    $t_2,$s_6,$e_17,$b_8                # 75e

        fm      $b_8,$b_15,$over_a_3                    # 76e
            fm      $s_11,$disc_10,$y_15                # 77e

        fma     $over_a_5,$s_2,$y_2,$y_2                # 78e
            fma     $e,$e_12,$half,$whole               # 79e

            fnms    $t_3,$s_8,$e_13,$b_11               # 80e
            clgt    $hit,$t_best_2,$t_2                 # 81e

        fnms    $ly_6,$b_8,$dy_9,$fy_3                  # 82e
        hbrr    next_pair_back,next_pair                # 82o hint

            andc    $hit,$hit,$disc                     # 83e
            fnms    $e_17,$s_11,$y_15,$k_one            # 84e

        fnms    $lx,$b_8,$dx_4,$fx_3                    # 85e
            rotqbii $hit,$hit,1                         # 85o

            fnms    $t_4,$s_10,$e,$b_10                 # 86e
            clgt    $hit_2,$t_best_3,$t_3               # 87e

        fm      $b_10,$b_12,$over_a_6                   # 88e
        lnop                                            # 88o pairing

            andc    $hit_6,$hit_2,$disc_6               # 89e
            gb      $hit,$hit                           # 89o

        fm      $b_11,$b_18,$over_a_4                   # 90e
        lnop                                            # 90o pairing

            fma     $e,$e_17,$half,$whole               # 91e
            rotqbii $hit_6,$hit_6,1                     # 91o

        fnms    $disc,$lx,$lx,$radius2_3                # 92e
            clgt    $hit_4,$t_best_5,$t_4               # 93e

        fnms    $lz_6,$b_8,$dz_10,$fz_3                 # 94e
            shlqbii $hit_5,$hit,4                       # 94o

        fnms    $ly_7,$b_10,$dy_4,$fy_3                 # 95e
            gb      $hit,$hit_6                         # 95o

        fnms    $lx_4,$b_10,$dx_3,$fx_3                 # 96e
        fnms    $ly_8,$b_11,$dy_3,$fy_3                 # 97e

            fnms    $t_5,$s_11,$e,$b                    # 98e
next_pair_back:
        brnz    $count,next_pair                        # 98o

next_pair_drain:
        fnms    $lx,$b_11,$dx_8,$fx_3                   # 0e
        shlqbii $hit,$hit,4                             # 0o

        fm      $b,$b_13,$over_a_5                      # 1e
        lqx     $merge,$a_merges,$hit_5                 # 1o

        fnms    $disc,$ly_6,$ly_6,$disc                 # 2e
        shlqbyi $object_2,$object_3,0                   # 2o copy

        fnms    $lz_8,$b_11,$dz_9,$fz_3                 # 3e
        shlqbyi $a_packet_6,$a_packet_3,0               # 3o copy

        fnms    $disc_11,$lx_4,$lx_4,$radius2_3         # 4e
        lqx     $merge_2,$a_merges,$hit                 # 4o

        fnms    $lz,$b_10,$dz_7,$fz_3                   # 5e
        hbr     isect_pairs_unnormalised_r16_return,$lr # 5o hint

        fnms    $disc_6,$lx,$lx,$radius2_3              # 6e
        lnop                                            # 6o pairing

        fnms    $lx_4,$b,$dx,$fx_3                      # 7e
        shufb   $t_best,$t_best_2,$t_2,$merge           # 7o

        fnms    $disc,$lz_6,$lz_6,$disc                 # 8e
        shufb   $nearest,$nearest_2,$object_4,$merge    # 8o

        fnms    $ly,$b,$dy,$fy_3                        # 9e
        lnop                                            # 9o pairing

        fnms    $lz_9,$b,$dz_8,$fz_3                    # 10e
        shufb   $t_best_6,$t_best_3,$t_3,$merge_2       # 10o

        fnms    $disc_11,$ly_7,$ly_7,$disc_11           # 11e
        shufb   $nearest_6,$nearest_3,$object_4,$merge_2 # 11o

        fnms    $disc_6,$ly_8,$ly_8,$disc_6             # 12e
        stqd    $t_best,192($a_packet_5)                # 12o

        fnms    $disc_4,$lx_4,$lx_4,$radius2_3          # 13e
        lnop                                            # 13o pairing

        fm      $disc,$disc,$over_a_3                   # 14e
        stqd    $t_best_6,224($a_packet_5)              # 14o

        clgt    $hit_7,$t_best_4,$t_5                   # 15e
        stqd    $nearest_6,288($a_packet_5)             # 15o

        andc    $hit_8,$hit_4,$disc_9                   # 16e
        stqd    $nearest,256($a_packet_5)               # 16o

        fnms    $disc_11,$lz,$lz,$disc_11               # 17e
        lqd     $t_best_2,192($a_packet_4)              # 17o

        fnms    $disc_6,$lz_8,$lz_8,$disc_6             # 18e
        rotqbii $hit_9,$hit_8,1                         # 18o

        fnms    $disc_13,$ly,$ly,$disc_4                # 19e
        lqd     $t_best_3,224($a_packet_4)              # 19o

        andc    $hit,$hit_7,$disc_10                    # 20e
        frsqest $y_8,$disc                              # 20o

        lqd     $nearest_2,256($a_packet_4)             # 21o
        rotqbii $hit,$hit,1                             # 22o

        fm      $disc_9,$disc_11,$over_a_6              # 23e
        gb      $hit_9,$hit_9                           # 23o

        fm      $disc_6,$disc_6,$over_a_4               # 24e
        lqd     $nearest_3,288($a_packet_4)             # 24o

        fnms    $disc_11,$lz_9,$lz_9,$disc_13           # 25e
        lnop                                            # 25o pairing

        fi      $y_8,$disc,$y_8                         # 26e
        gb      $hit,$hit                               # 26o

        shlqbii $hit_9,$hit_9,4                         # 27o
        frsqest $y_9,$disc_9                            # 29o

        nop     $127                                    # 30e pairing
        frsqest $y_10,$disc_6                           # 30o

        fm      $disc_10,$disc_11,$over_a_5             # 31e
        shlqbii $hit,$hit,4                             # 31o

        lqx     $merge_5,$a_merges,$hit_9               # 32o
        fm      $s_6,$disc,$y_8                         # 33e

        fi      $y_10,$disc_6,$y_10                     # 34e
        lnop                                            # 34o pairing

        fi      $y_9,$disc_9,$y_9                       # 35e
        lqx     $merge_3,$a_merges,$hit                 # 35o

        frsqest $y_14,$disc_10                          # 37o
        shufb   $t_best_8,$t_best_5,$t_4,$merge_5       # 38o

        fnms    $e_13,$s_6,$y_8,$k_one                  # 39e
        shufb   $nearest_5,$nearest_5,$object_4,$merge_5 # 39o

        fm      $s_12,$disc_6,$y_10                     # 41e
        shufb   $t_best_4,$t_best_4,$t_5,$merge_3       # 41o

        fi      $y_15,$disc_10,$y_14                    # 42e
        shufb   $nearest_7,$nearest_4,$object_4,$merge_3 # 42o

        fm      $s_10,$disc_9,$y_9                      # 44e
        lnop                                            # 44o pairing

        fma     $e_17,$e_13,$half,$whole                # 45e
        stqd    $t_best_4,208($a_packet_5)              # 45o

        nop     $127                                    # 46e pairing
        lqd     $t_best_4,208($a_packet_4)              # 46o

        fnms    $e_14,$s_12,$y_10,$k_one                # 47e
        stqd    $nearest_7,272($a_packet_5)             # 47o

        nop     $127                                    # 48e pairing
        lqd     $nearest_4,272($a_packet_4)             # 48o

        fm      $s_11,$disc_10,$y_15                    # 49e
        stqd    $t_best_8,240($a_packet_5)              # 49o

        fnms    $e_12,$s_10,$y_9,$k_one                 # 50e
        lqd     $t_best_5,240($a_packet_4)              # 50o

        fnms    $t_6,$s_6,$e_17,$b_8                    # 51e
        stqd    $nearest_5,304($a_packet_5)             # 51o

        lqd     $nearest_5,304($a_packet_4)             # 52o
        fma     $e_13,$e_14,$half,$whole                # 53e

        fnms    $e_17,$s_11,$y_15,$k_one                # 55e
        fma     $e,$e_12,$half,$whole                   # 56e

        clgt    $hit,$t_best_2,$t_6                     # 57e
        fnms    $t_3,$s_12,$e_13,$b_11                  # 59e

        andc    $hit,$hit,$disc                         # 60e
        fma     $e_18,$e_17,$half,$whole                # 61e

        fnms    $t_4,$s_10,$e,$b_10                     # 62e
        rotqbii $hit,$hit,1                             # 62o

        clgt    $hit_2,$t_best_3,$t_3                   # 65e
        gb      $hit,$hit                               # 66o

        andc    $hit_8,$hit_2,$disc_6                   # 67e
        fnms    $t_5,$s_11,$e_18,$b                     # 68e

        clgt    $hit_4,$t_best_5,$t_4                   # 69e
        rotqbii $hit_9,$hit_8,1                         # 69o

        shlqbii $hit_5,$hit,4                           # 70o
        andc    $hit_8,$hit_4,$disc_9                   # 71e

        nop     $127                                    # 72e pairing
        gb      $hit,$hit_9                             # 73o

        clgt    $hit_9,$t_best_4,$t_5                   # 74e
        lqx     $merge,$a_merges,$hit_5                 # 74o

        rotqbii $hit_8,$hit_8,1                         # 75o
        andc    $hit_9,$hit_9,$disc_10                  # 76e

        shlqbii $hit,$hit,4                             # 77o
        rotqbii $hit_9,$hit_9,1                         # 78o

        gb      $hit_8,$hit_8                           # 79o
        shufb   $t_best,$t_best_2,$t_6,$merge           # 80o

        lqx     $merge_6,$a_merges,$hit                 # 81o
        gb      $hit,$hit_9                             # 82o

        shufb   $nearest,$nearest_2,$object_2,$merge    # 83o
        stqd    $t_best,192($a_packet_6)                # 84o

        shlqbii $hit_9,$hit_8,4                         # 85o
        shlqbii $hit,$hit,4                             # 86o

        shufb   $t_best_6,$t_best_3,$t_3,$merge_6       # 87o
        shufb   $nearest_6,$nearest_3,$object_2,$merge_6 # 88o

        stqd    $t_best_6,224($a_packet_6)              # 91o
        stqd    $nearest_6,288($a_packet_6)             # 92o

        stqd    $nearest,256($a_packet_6)               # 93o
        lqx     $merge_3,$a_merges,$hit                 # 94o

        lqx     $merge_5,$a_merges,$hit_9               # 95o
        shufb   $t_best_4,$t_best_4,$t_5,$merge_3       # 100o

        shufb   $nearest_7,$nearest_4,$object_2,$merge_3 # 101o
        shufb   $t_best_8,$t_best_5,$t_4,$merge_5       # 102o

        shufb   $nearest_5,$nearest_5,$object_2,$merge_5 # 103o
        stqd    $t_best_4,208($a_packet_6)              # 104o

        stqd    $nearest_7,272($a_packet_6)             # 105o
        stqd    $t_best_8,240($a_packet_6)              # 106o

        stqd    $nearest_5,304($a_packet_6)             # 107o
isect_pairs_unnormalised_r16_return:
        bi      $lr                                     # 108o

next_pair_short:
        ai      $count,$count,-1                        # 0e
        lqd     $object,0($a_pair)                      # 0o

        ai      $a_pair,$a_pair,16                      # 1e
        rotqbyi $a_packet,$object,4                     # 6o

        lqd     $quad,0($object)                        # 7o
        shufb   $object,$object,$object,$m_x            # 8o

        lqd     $dx,0($a_packet)                        # 10o
        lqd     $dx_9,16($a_packet)                     # 11o

        lqd     $dy,64($a_packet)                       # 12o
        lqd     $dx_10,48($a_packet)                    # 13o

        lqd     $dy_10,80($a_packet)                    # 14o
        lqd     $dz,128($a_packet)                      # 15o

        fm      $e,$dx,$dx                              # 16e
        lqd     $dz_11,144($a_packet)                   # 16o

        fm      $e_19,$dx_9,$dx_9                       # 17e
        lqd     $dy_2,96($a_packet)                     # 17o

        nop     $127                                    # 18e pairing
        lqd     $dx_11,32($a_packet)                    # 18o

        fm      $e_20,$dx_10,$dx_10                     # 19e
        lqd     $dz_12,160($a_packet)                   # 19o

        shufb   $fx_4,$quad,$quad,$m_x                  # 20o
        lqd     $dz_13,176($a_packet)                   # 21o

        fma     $e,$dy,$dy,$e                           # 22e
        lqd     $dy_11,112($a_packet)                   # 22o

        fma     $e_19,$dy_10,$dy_10,$e_19               # 23e
        shufb   $fy_4,$quad,$quad,$m_y                  # 23o

        fm      $e_13,$dx_11,$dx_11                     # 24e
        shufb   $fz_4,$quad,$quad,$m_z                  # 24o

        fm      $b_19,$fx_4,$dx_9                       # 25e
        shufb   $radius2_2,$quad,$quad,$m_radius2       # 25o

        fm      $b_20,$fx_4,$dx                         # 26e
        lqd     $t_best_9,192($a_packet)                # 26o

        fm      $b_21,$fx_4,$dx_10                      # 27e
        lqd     $t_best_10,208($a_packet)               # 27o

        fma     $e,$dz,$dz,$e                           # 28e
        lqd     $t_best_11,240($a_packet)               # 28o

        fma     $e_20,$dy_11,$dy_11,$e_20               # 29e
        lqd     $t_best_12,224($a_packet)               # 29o

        fma     $e_19,$dz_11,$dz_11,$e_19               # 30e
        lqd     $nearest_8,272($a_packet)               # 30o

        fma     $e_13,$dy_2,$dy_2,$e_13                 # 31e
        lqd     $nearest_9,256($a_packet)               # 31o

        fma     $b_19,$fy_4,$dy_10,$b_19                # 32e
        lqd     $nearest_10,304($a_packet)              # 32o

        fma     $b_20,$fy_4,$dy,$b_20                   # 33e
        lqd     $nearest_11,288($a_packet)              # 33o

        fma     $b_21,$fy_4,$dy_11,$b_21                # 34e
        frest   $y_16,$e                                # 34o

        fma     $e_20,$dz_13,$dz_13,$e_20               # 35e
        lnop                                            # 35o pairing

        fm      $b_4,$fx_4,$dx_11                       # 36e
        frest   $y_14,$e_19                             # 36o

        fma     $e_13,$dz_12,$dz_12,$e_13               # 37e
        fi      $y_16,$e,$y_16                          # 38e

        fi      $y_14,$e_19,$y_14                       # 40e
        frest   $y_17,$e_20                             # 41o

        fma     $b_20,$fz_4,$dz,$b_20                   # 42e
        lnop                                            # 42o pairing

        fma     $b_19,$fz_4,$dz_11,$b_19                # 43e
        frest   $y_18,$e_13                             # 43o

        fma     $b_4,$fy_4,$dy_2,$b_4                   # 44e
        fnms    $s_2,$e,$y_16,$k_one                    # 45e

        fi      $y_17,$e_20,$y_17                       # 46e
        fi      $y_18,$e_13,$y_18                       # 47e

        fnms    $s_13,$e_19,$y_14,$k_one                # 49e
        fma     $b_21,$fz_4,$dz_13,$b_21                # 50e

        fma     $over_a_7,$s_2,$y_16,$y_16              # 51e
        fma     $b_22,$fz_4,$dz_12,$b_4                 # 52e

        fnms    $s_14,$e_20,$y_17,$k_one                # 53e
        fnms    $s_15,$e_13,$y_18,$k_one                # 54e

        fma     $over_a_8,$s_13,$y_14,$y_14             # 55e
        fm      $b_20,$b_20,$over_a_7                   # 57e

        fma     $over_a_9,$s_14,$y_17,$y_17             # 59e
        fma     $over_a_10,$s_15,$y_18,$y_18            # 60e

        fm      $b_19,$b_19,$over_a_8                   # 61e
        fnms    $ly_9,$b_20,$dy,$fy_4                   # 63e

        fnms    $lx_7,$b_20,$dx,$fx_4                   # 64e
        fm      $b_21,$b_21,$over_a_9                   # 65e

        fm      $b_22,$b_22,$over_a_10                  # 66e
        fnms    $lx_6,$b_19,$dx_9,$fx_4                 # 67e

        fnms    $ly_10,$b_19,$dy_10,$fy_4               # 68e
        fnms    $lz_10,$b_19,$dz_11,$fz_4               # 69e

        fnms    $disc_14,$lx_7,$lx_7,$radius2_2         # 70e
        fnms    $ly_11,$b_21,$dy_11,$fy_4               # 71e

        fnms    $lx_8,$b_22,$dx_11,$fx_4                # 72e
        fnms    $disc_12,$lx_6,$lx_6,$radius2_2         # 73e

        fnms    $ly_5,$b_22,$dy_2,$fy_4                 # 74e
        fnms    $lz_11,$b_20,$dz,$fz_4                  # 75e

        fnms    $disc_14,$ly_9,$ly_9,$disc_14           # 76e
        fnms    $lx_9,$b_21,$dx_10,$fx_4                # 77e

        fnms    $disc_15,$lx_8,$lx_8,$radius2_2         # 78e
        fnms    $disc_12,$ly_10,$ly_10,$disc_12         # 79e

        fnms    $lz_12,$b_22,$dz_12,$fz_4               # 80e
        fnms    $lz_13,$b_21,$dz_13,$fz_4               # 81e

        fnms    $disc_16,$lz_11,$lz_11,$disc_14         # 82e
        fnms    $disc_11,$lx_9,$lx_9,$radius2_2         # 83e

        fnms    $disc_8,$ly_5,$ly_5,$disc_15            # 84e
        fnms    $disc_12,$lz_10,$lz_10,$disc_12         # 85e

        fm      $disc_6,$disc_16,$over_a_7              # 88e
        fnms    $disc_11,$ly_11,$ly_11,$disc_11         # 89e

        fnms    $disc_13,$lz_12,$lz_12,$disc_8          # 90e
        fm      $disc_12,$disc_12,$over_a_8             # 91e

        frsqest $y_19,$disc_6                           # 94o
        fnms    $disc_11,$lz_13,$lz_13,$disc_11         # 95e

        fm      $disc_13,$disc_13,$over_a_10            # 96e
        frsqest $y_20,$disc_12                          # 97o

        fi      $y_19,$disc_6,$y_19                     # 98e
        fm      $disc_11,$disc_11,$over_a_9             # 101e

        fi      $y_20,$disc_12,$y_20                    # 102e
        frsqest $y_21,$disc_13                          # 102o

        fm      $s_3,$disc_6,$y_19                      # 105e
        fi      $y_21,$disc_13,$y_21                    # 106e

        frsqest $y_22,$disc_11                          # 107o
        fm      $s_16,$disc_12,$y_20                    # 109e

        fnms    $e,$s_3,$y_19,$k_one                    # 111e
        fi      $y_19,$disc_11,$y_22                    # 112e

        fm      $s_14,$disc_13,$y_21                    # 114e
        fnms    $e_12,$s_16,$y_20,$k_one                # 115e

        fma     $e,$e,$half,$whole                      # 117e
        fm      $s_17,$disc_11,$y_19                    # 119e

        fnms    $e_11,$s_14,$y_21,$k_one                # 120e
        fma     $e_12,$e_12,$half,$whole                # 121e

        fnms    $t_7,$s_3,$e,$b_20                      # 123e
        fnms    $e,$s_17,$y_19,$k_one                   # 125e

        fma     $e_19,$e_11,$half,$whole                # 126e
        fnms    $t_3,$s_16,$e_12,$b_19                  # 127e

        clgt    $hit_2,$t_best_9,$t_7                   # 129e
        andc    $hit_5,$hit_2,$disc_6                   # 131e

        fnms    $t_8,$s_14,$e_19,$b_22                  # 132e
        lnop                                            # 132o pairing

        clgt    $hit_2,$t_best_10,$t_3                  # 133e
        rotqbii $hit_5,$hit_5,1                         # 133o

        fma     $e,$e,$half,$whole                      # 134e
        andc    $hit_6,$hit_2,$disc_12                  # 135e

        nop     $127                                    # 136e pairing
        rotqbii $hit_6,$hit_6,1                         # 137o

        clgt    $hit_2,$t_best_12,$t_8                  # 138e
        gb      $hit_5,$hit_5                           # 138o

        andc    $hit_8,$hit_2,$disc_13                  # 140e
        lnop                                            # 140o pairing

        fnms    $t_9,$s_17,$e,$b_21                     # 141e
        gb      $hit_6,$hit_6                           # 141o

        shlqbii $hit_5,$hit_5,4                         # 142o
        rotqbii $hit_8,$hit_8,1                         # 143o

        shlqbii $hit_6,$hit_6,4                         # 145o
        lqx     $merge_7,$a_merges,$hit_5               # 146o

        clgt    $hit_10,$t_best_11,$t_9                 # 147e
        gb      $hit_8,$hit_8                           # 147o

        andc    $hit_11,$hit_10,$disc_11                # 149e
        lqx     $merge_4,$a_merges,$hit_6               # 149o

        rotqbii $hit_11,$hit_11,1                       # 151o
        shufb   $nearest,$nearest_9,$object,$merge_7    # 152o

        shufb   $t_best,$t_best_9,$t_7,$merge_7         # 153o
        shlqbii $hit_8,$hit_8,4                         # 154o

        gb      $hit_11,$hit_11                         # 155o
        stqd    $nearest,256($a_packet)                 # 156o

        stqd    $t_best,192($a_packet)                  # 157o
        shufb   $nearest,$nearest_8,$object,$merge_4    # 158o

        shlqbii $hit_11,$hit_11,4                       # 159o
        shufb   $t_best,$t_best_10,$t_3,$merge_4        # 160o

        lqx     $merge,$a_merges,$hit_8                 # 161o
        stqd    $nearest,272($a_packet)                 # 162o

        lqx     $merge_4,$a_merges,$hit_11              # 163o
        stqd    $t_best,208($a_packet)                  # 164o

        hbrr    next_pair_short_back,next_pair_short    # 165o hint
        shufb   $nearest,$nearest_11,$object,$merge     # 167o

        shufb   $t_best,$t_best_12,$t_8,$merge          # 168o
        shufb   $t_best_8,$t_best_11,$t_9,$merge_4      # 169o

        shufb   $nearest_12,$nearest_10,$object,$merge_4 # 170o
        stqd    $nearest,288($a_packet)                 # 171o

        stqd    $t_best,224($a_packet)                  # 172o
        stqd    $t_best_8,240($a_packet)                # 173o

        stqd    $nearest_12,304($a_packet)              # 174o
next_pair_short_back:
        brnz    $count,next_pair_short                  # 180o

        nop     $127                                    # 176e pairing
        bi      $lr                                     # 176o
endfunction isect_pairs_unnormalised_r16
