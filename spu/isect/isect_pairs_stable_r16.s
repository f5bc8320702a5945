# isect_pairs_stable_r16   nearest entry of packets' eye rays into spheres, roots that don't cancel
#   C       void isect_pairs_stable_r16(const struct pair *, int count);
#   In      $3 pairs, $4 count (0 is none); pointers 16-aligned
#   Out     the pairs' packets: t, object, where an entry is nearer than what was there
#   Uses    $2-$69, $79   Saves  -   Stack  0   Calls  -
#   Domain  |d| = 1 within 4 ulp; radius > 0; centre and radius below 2^62
#   Error   8 ulp of t, eye 1.5 to 30 radii from the centre, ray within 0.995 r of it
#   Twin    oracle/src/twin/sphere/stable.rs
#
# The steps are those of sphere_tmpl.inc. An opaque sphere has no inside: only the entry counts, and
# behind the eye it is none.
# Scheduled by spu schedule from isect_pairs_stable_r16.s

        .include "work_unit.inc"
        .include "macros.inc"
        .include "sphere_tmpl.inc"
        .include "sphere_stable.inc"

        .set    a_pair,3
        .set    count,4
        # constants
        .set    k_one,10
        .set    k_half,11
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
        .set    fx,20                                   # c
        .set    fy,21
        .set    fz,22
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
        .set    cc,37
        .set    q,38
        .set    t,39
        .set    hit,40
        .set    merge,41

        merges_table

function isect_pairs_stable_r16
        .set    count_2,79
        .set    a_pair_2,2
        .set    object_2,2
        .set    quad_2,5
        .set    a_packet_2,6
        .set    dy_2,31
        .set    dx_2,26
        .set    dz_2,45
        .set    radius2_2,7
        .set    dy_3,43
        .set    fy_2,32
        .set    b_2,42
        .set    dz_3,38
        .set    cc_2,49
        .set    fz_2,21
        .set    cc_3,36
        .set    dx_3,9
        .set    cc_4,53
        .set    dy_4,27
        .set    cc_5,48
        .set    dx_4,23
        .set    dx_5,8
        .set    dz_4,28
        .set    cc_6,19
        .set    dy_5,41
        .set    b_3,44
        .set    cc_7,34
        .set    dx_6,37
        .set    b_4,22
        .set    fz_3,35
        .set    b_5,39
        .set    dy_6,29
        .set    b_6,40
        .set    dy_7,46
        .set    dz_5,47
        .set    fx_2,49
        .set    fy_3,65
        .set    dx_7,53
        .set    dx_8,62
        .set    ly_2,30
        .set    dz_6,43
        .set    lx_2,26
        .set    dz_7,63
        .set    lz_2,33
        .set    a_packet_3,42
        .set    lx_3,24
        .set    radius2_3,5
        .set    b_7,45
        .set    dy_8,64
        .set    b_8,66
        .set    dz_8,67
        .set    lz_3,38
        .set    dz_9,68
        .set    disc_2,22
        .set    t_best_2,51
        .set    nearest_2,26
        .set    disc_3,24
        .set    t_best_3,69
        .set    lx_4,23
        .set    t_best_4,52
        .set    ly_3,27
        .set    t_best_5,58
        .set    b_9,50
        .set    a_packet_4,59
        .set    disc_4,18
        .set    nearest_3,54
        .set    b_10,30
        .set    nearest_4,22
        .set    object_3,61
        .set    disc_5,23
        .set    a_packet_5,57
        .set    lx_5,9
        .set    a_packet_6,60
        .set    ly_4,17
        .set    nearest_5,56
        .set    object_4,55
        .set    lz_4,20
        .set    disc_6,2
        .set    disc_7,6
        .set    lz_5,23
        .set    b_11,24
        .set    y_2,27
        .set    b_12,28
        .set    disc_8,9
        .set    y_3,7
        .set    y_4,20
        .set    disc_9,27
        .set    disc_10,38
        .set    y_5,17
        .set    s_2,18
        .set    s_3,2
        .set    disc_11,31
        .set    e_2,9
        .set    ly_5,20
        .set    s_4,6
        .set    e_3,7
        .set    y_6,24
        .set    lx_6,8
        .set    e_4,17
        .set    disc_12,30
        .set    disc_13,8
        .set    lz_6,28
        .set    lx_7,41
        .set    q_2,2
        .set    ly_6,7
        .set    lx_8,37
        .set    q_3,6
        .set    q_4,9
        .set    disc_14,17
        .set    lx_9,18
        .set    y_7,39
        .set    ly_7,25
        .set    disc_15,37
        .set    cc_8,41
        .set    y_8,32
        .set    y_9,40
        .set    disc_16,7
        .set    e_5,2
        .set    s_5,25
        .set    e_6,6
        .set    y_10,2
        .set    e_7,24
        .set    y_11,9
        .set    y_12,28
        .set    t_2,2
        .set    y_13,18
        .set    e_8,19
        .set    cc_9,64
        .set    hit_2,24
        .set    disc_17,62
        .set    q_5,19
        .set    hit_3,7
        .set    cc_10,20
        .set    lz_7,24
        .set    disc_18,25
        .set    y_14,46
        .set    disc_19,63
        .set    y_15,6
        .set    merge_2,7
        .set    y_16,43
        .set    s_6,23
        .set    cc_11,8
        .set    cc_12,17
        .set    e_9,18
        .set    nearest_6,19
        .set    y_17,5
        .set    t_best_6,2
        .set    s_7,24
        .set    t_3,53
        .set    s_8,32
        .set    cc_13,7
        .set    cc_14,21
        .set    s_9,26
        .set    hit_4,27
        .set    e_10,5
        .set    q_6,5
        .set    hit_5,21
        .set    y_18,22
        .set    y_19,25
        .set    b_13,36
        .set    e_11,38
        .set    radius2_4,19
        .set    merge_3,25
        .set    t_4,8
        .set    t_best_7,34
        .set    merge_4,21
        .set    nearest_7,40
        .set    nearest_8,25
        .set    hit_6,54
        .set    t_best_8,39
        .set    nearest_9,20
        .set    disc_20,19
        .set    ly_8,26
        .set    lz_8,27
        .set    disc_21,20
        .set    lz_9,18
        .set    lz_10,17
        .set    object_5,3
        .set    a_packet_7,4
        .set    cc_15,5
        .set    q_7,7
        .set    t_best_9,8
        .set    cc_16,9
        .set    nearest_10,11
        .set    merge_5,12
        .set    nearest_11,13
        .set    y_20,14
        .set    nearest_12,12
        .set    t_5,5
        .set    hit_7,2
        .set    t_6,6
        .set    hit_8,9
        .set    hit_9,5
        .set    dx_9,2
        .set    dy_9,5
        .set    dx_10,6
        .set    b_14,7
        .set    dz_10,8
        .set    b_15,23
        .set    dy_10,28
        .set    dz_11,30
        .set    b_16,31
        .set    dz_12,32
        .set    t_best_10,33
        .set    t_best_11,35
        .set    t_best_12,36
        .set    nearest_13,38
        .set    nearest_14,39
        .set    cc_17,40
        .set    nearest_15,41
        .set    nearest_16,42
        .set    lx_10,2
        .set    ly_9,5
        .set    lz_11,26
        .set    lx_11,6
        .set    lz_12,8
        .set    ly_10,28
        .set    lz_13,25
        .set    disc_22,5
        .set    cc_18,26
        .set    disc_23,28
        .set    s_10,8
        .set    y_21,30
        .set    disc_24,32
        .set    y_22,26
        .set    e_12,20
        .set    s_11,5
        .set    e_13,22
        .set    q_8,8
        .set    e_14,8
        .set    y_23,23
        .set    y_24,8
        .set    t_7,7
        .set    hit_10,8
        .set    hit_11,19
        .set    merge_6,20
        .set    merge_7,8
        .set    nearest_17,8
        .set    merge_8,2
        .set    nearest_18,2
        .set    t_best_13,5
        nop     $127                                    # 0e pairing
        biz     $count,$lr                              # 0o

        ilhu    $m_x,1                                  # 1e
        ilhu    $m_y,0x405                              # 2e

        ilhu    $m_z,0x809                              # 3e
        ilhu    $m_radius2,0xc0d                        # 4e

        clgti   $count_2,$count,2                       # 5e at least as many passes as overlap
        iohl    $m_x,515                                # 6e

        iohl    $m_y,0x607                              # 7e
        iohl    $m_z,0xa0b                              # 8e

        iohl    $m_radius2,0xe0f                        # 9e
        ila     $a_merges,merges                        # 10e

        ilhu    $k_one,0x3f80                           # 11e
        lnop                                            # 11o pairing

        ilhu    $k_half,0x3f00                          # 12e
        brz     $count_2,next_pair_short                # 12o too few passes

        ai      $a_pair_2,$a_pair,16                    # 13e
        lqd     $object,0($a_pair)                      # 13o

        ai      $count,$count,-1                        # 14e
        lnop                                            # 14o pairing

        ai      $a_pair,$a_pair_2,16                    # 15e
        lqd     $object_2,0($a_pair_2)                  # 15o

        ai      $count,$count,-1                        # 16e
        rotqbyi $a_packet,$object,4                     # 19o

        lqd     $quad,0($object)                        # 20o
        lqd     $quad_2,0($object_2)                    # 21o

        rotqbyi $a_packet_2,$object_2,4                 # 22o
        lqd     $dy_2,96($a_packet)                     # 23o

        lqd     $dx,32($a_packet)                       # 24o
        lqd     $dx_2,0($a_packet)                      # 25o

        shufb   $fx,$quad,$quad,$m_x                    # 26o
        lqd     $dz_2,160($a_packet)                    # 27o

        shufb   $radius2_2,$quad,$quad,$m_radius2       # 28o
        lqd     $dy_3,64($a_packet)                     # 29o

        fm      $b,$fx,$dx                              # 30e
        shufb   $fy_2,$quad,$quad,$m_y                  # 30o

        fm      $b_2,$fx,$dx_2                          # 31e
        lqd     $dz_3,128($a_packet)                    # 31o

        fms     $cc_2,$fx,$fx,$radius2_2                # 32e
        shufb   $fz_2,$quad,$quad,$m_z                  # 32o

        fms     $cc_3,$fx,$fx,$radius2_2                # 33e
        lqd     $dx_3,16($a_packet)                     # 33o

        fms     $cc_4,$fx,$fx,$radius2_2                # 34e
        lqd     $dy_4,112($a_packet)                    # 34o

        fms     $cc_5,$fx,$fx,$radius2_2                # 35e
        lqd     $dx_4,48($a_packet)                     # 35o

        fma     $b,$fy_2,$dy_2,$b                       # 36e
        lqd     $dx_5,48($a_packet_2)                   # 36o

        fma     $b_2,$fy_2,$dy_3,$b_2                   # 37e
        lqd     $dz_4,176($a_packet)                    # 37o

        fma     $cc_6,$fy_2,$fy_2,$cc_2                 # 38e
        lqd     $dy_5,80($a_packet)                     # 38o

        fm      $b_3,$fx,$dx_3                          # 39e
        lqd     $dy,96($a_packet_2)                     # 39o

        fma     $cc_7,$fy_2,$fy_2,$cc_4                 # 40e
        lqd     $dx_6,0($a_packet_2)                    # 40o

        fm      $b_4,$fx,$dx_4                          # 41e
        shufb   $fz_3,$quad_2,$quad_2,$m_z              # 41o

        fma     $b_5,$fz_2,$dz_2,$b                     # 42e
        lqd     $dy_6,112($a_packet_2)                  # 42o

        fma     $b_6,$fz_2,$dz_3,$b_2                   # 43e
        lqd     $dy_7,80($a_packet_2)                   # 43o

        fma     $cc_6,$fz_2,$fz_2,$cc_6                 # 44e
        lqd     $dz_5,144($a_packet)                    # 44o

        fma     $b_3,$fy_2,$dy_5,$b_3                   # 45e
        shufb   $fx_2,$quad_2,$quad_2,$m_x              # 45o

        fma     $cc_3,$fy_2,$fy_2,$cc_3                 # 46e
        shufb   $fy_3,$quad_2,$quad_2,$m_y              # 46o

        fma     $b_4,$fy_2,$dy_4,$b_4                   # 47e
        lqd     $dx_7,16($a_packet_2)                   # 47o

        fnms    $ly,$b_5,$dy_2,$fy_2                    # 48e
        lqd     $dx_8,32($a_packet_2)                   # 48o

        fnms    $ly_2,$b_6,$dy_3,$fy_2                  # 49e
        lqd     $dz_6,128($a_packet_2)                  # 49o

        fnms    $lx_2,$b_6,$dx_2,$fx                    # 50e
        lqd     $dz_7,160($a_packet_2)                  # 50o

        fnms    $lz_2,$b_5,$dz_2,$fz_2                  # 51e
        shlqbyi $a_packet_3,$a_packet,0                 # 51o copy

        fnms    $lx_3,$b_5,$dx,$fx                      # 52e
        shufb   $radius2_3,$quad_2,$quad_2,$m_radius2   # 52o

        fma     $b_7,$fz_2,$dz_4,$b_4                   # 53e
        lqd     $dy_8,64($a_packet_2)                   # 53o

        fma     $b_8,$fz_2,$dz_5,$b_3                   # 54e
        lqd     $dz_8,176($a_packet_2)                  # 54o

        fnms    $lz_3,$b_6,$dz_3,$fz_2                  # 55e
        lqd     $dz_9,144($a_packet_2)                  # 55o

        fnms    $disc_2,$lx_2,$lx_2,$radius2_2          # 56e
        lqd     $t_best_2,192($a_packet_3)              # 56o

        fm      $b_3,$fx_2,$dx_7                        # 57e
        lqd     $nearest_2,288($a_packet_3)             # 57o

        fnms    $disc_3,$lx_3,$lx_3,$radius2_2          # 58e
        lqd     $t_best_3,224($a_packet_3)              # 58o

        fnms    $lx_4,$b_7,$dx_4,$fx                    # 59e
        lqd     $t_best_4,240($a_packet_3)              # 59o

        fnms    $ly_3,$b_7,$dy_4,$fy_2                  # 60e
        lqd     $t_best_5,208($a_packet_3)              # 60o

        fm      $b_9,$fx_2,$dx_5                        # 61e
        shlqbyi $a_packet_4,$a_packet,0                 # 61o copy

        fnms    $disc_4,$ly_2,$ly_2,$disc_2             # 62e
        lqd     $nearest_3,304($a_packet_3)             # 62o

        fm      $b_10,$fx_2,$dx_6                       # 63e
        lqd     $nearest_4,256($a_packet_3)             # 63o

        fnms    $disc_3,$ly,$ly,$disc_3                 # 64e
        shufb   $object_3,$object,$object,$m_x          # 64o

        fnms    $disc_5,$lx_4,$lx_4,$radius2_2          # 65e
        shlqbyi $a_packet_5,$a_packet_4,0               # 65o copy

        fnms    $lx_5,$b_8,$dx_3,$fx                    # 66e
        shlqbyi $a_packet_6,$a_packet_2,0               # 66o copy

        fnms    $ly_4,$b_8,$dy_5,$fy_2                  # 67e
        lqd     $nearest_5,272($a_packet_3)             # 67o

        fnms    $disc_4,$lz_3,$lz_3,$disc_4             # 68e
        shlqbyi $object_4,$object_3,0                   # 68o copy

        fnms    $lz_4,$b_7,$dz_4,$fz_2                  # 69e
        shufb   $object_3,$object_2,$object_2,$m_x      # 69o

        fnms    $disc_6,$lz_2,$lz_2,$disc_3             # 70e
        shlqbyi $a_packet_4,$a_packet_2,0               # 70o copy

        fnms    $disc_7,$ly_3,$ly_3,$disc_5             # 71e
        fnms    $lz_5,$b_8,$dz_5,$fz_2                  # 72e

        fma     $b_3,$fy_3,$dy_7,$b_3                   # 73e
        lnop                                            # 73o pairing

        fm      $b_11,$fx_2,$dx_8                       # 74e
        frsqest $y_2,$disc_4                            # 74o

        fma     $b_12,$fy_3,$dy_6,$b_9                  # 75e
        lnop                                            # 75o pairing

        fnms    $disc_8,$lx_5,$lx_5,$radius2_2          # 76e
        frsqest $y_3,$disc_6                            # 76o

        fnms    $disc_7,$lz_4,$lz_4,$disc_7             # 77e
        fi      $y_4,$disc_4,$y_2                       # 78e

        or      $disc_9,$disc_6,$b_5                    # 79e
        fi      $y_3,$disc_6,$y_3                       # 80e

        or      $disc_10,$disc_4,$b_6                   # 81e
        fma     $b_11,$fy_3,$dy,$b_11                   # 82e

        fnms    $disc_8,$ly_4,$ly_4,$disc_8             # 83e
        frsqest $y_5,$disc_7                            # 83o

        fma     $b_3,$fz_3,$dz_9,$b_3                   # 84e
        fm      $s_2,$disc_4,$y_4                       # 85e

        fma     $b_9,$fz_3,$dz_8,$b_12                  # 86e
        fi      $y_5,$disc_7,$y_5                       # 87e

        or      $disc,$disc_7,$b_7                      # 88e
        fm      $s_3,$disc_6,$y_3                       # 89e

        fnms    $disc_11,$lz_5,$lz_5,$disc_8            # 90e
        fnms    $e_2,$s_2,$y_4,$k_one                   # 91e

        fnms    $lz_5,$b_9,$dz_8,$fz_3                  # 92e
        fnms    $ly_5,$b_9,$dy_6,$fy_3                  # 93e

        fm      $s_4,$disc_7,$y_5                       # 94e
        fnms    $e_3,$s_3,$y_3,$k_one                   # 95e

        fma     $b,$fz_3,$dz_7,$b_11                    # 96e
        frsqest $y_6,$disc_11                           # 96o

        fma     $e_2,$e_2,$k_half,$k_one                # 97e
        fma     $b_2,$fy_3,$dy_8,$b_10                  # 98e

        fnms    $lx_6,$b_9,$dx_5,$fx_2                  # 99e
        fnms    $e_4,$s_4,$y_5,$k_one                   # 100e

        fi      $y_6,$disc_11,$y_6                      # 101e
        or      $disc_12,$disc_11,$b_8                  # 102e

        fma     $e_3,$e_3,$k_half,$k_one                # 103e
        fma     $b_2,$fz_3,$dz_6,$b_2                   # 104e

        fnms    $disc_13,$lx_6,$lx_6,$radius2_3         # 105e
        fma     $e_4,$e_4,$k_half,$k_one                # 106e

        fnms    $lz_6,$b,$dz_7,$fz_3                    # 107e
        fnms    $lx_7,$b,$dx_8,$fx_2                    # 108e

        fma     $q_2,$s_3,$e_3,$b_5                     # 109e
        fnms    $ly_6,$b_2,$dy_8,$fy_3                  # 110e

        fnms    $lx_8,$b_2,$dx_6,$fx_2                  # 111e
        fma     $q_3,$s_4,$e_4,$b_7                     # 112e

        fma     $q_4,$s_2,$e_2,$b_6                     # 113e
        fnms    $disc_14,$lx_7,$lx_7,$radius2_3         # 114e

        fnms    $lx_9,$b_3,$dx_7,$fx_2                  # 115e
        frest   $y_7,$q_2                               # 115o

        fnms    $ly_7,$b,$dy,$fy_3                      # 116e
        fnms    $disc_15,$lx_8,$lx_8,$radius2_3         # 117e

        fma     $cc_8,$fy_2,$fy_2,$cc_5                 # 118e
        frest   $y_8,$q_3                               # 118o

        fi      $y_7,$q_2,$y_7                          # 119e
        frest   $y_9,$q_4                               # 119o

        fnms    $disc_13,$ly_5,$ly_5,$disc_13           # 121e
        fms     $cc_5,$fx_2,$fx_2,$radius2_3            # 122e

        fnms    $disc_16,$ly_6,$ly_6,$disc_15           # 123e
        fi      $y_4,$q_4,$y_9                          # 124e

        fi      $y_8,$q_3,$y_8                          # 125e
        fnms    $e_5,$q_2,$y_7,$k_one                   # 127e

        fnms    $disc_4,$lx_9,$lx_9,$radius2_3          # 128e
        fnms    $disc_14,$ly_7,$ly_7,$disc_14           # 129e

        fm      $s_5,$disc_11,$y_6                      # 130e
        fnms    $e_2,$q_4,$y_4,$k_one                   # 131e

        fnms    $e_6,$q_3,$y_8,$k_one                   # 132e
        fma     $y_10,$e_5,$y_7,$y_7                    # 133e

        fnms    $ly,$b_3,$dy_7,$fy_3                    # 134e
        fnms    $disc_14,$lz_6,$lz_6,$disc_14           # 135e

        fnms    $e_7,$s_5,$y_6,$k_one                   # 136e
        fma     $y_11,$e_2,$y_4,$y_4                    # 137e

        fma     $y_12,$e_6,$y_8,$y_8                    # 138e
        fm      $t_2,$cc_6,$y_10                        # 139e

        fnms    $disc_7,$ly,$ly,$disc_4                 # 140e
        lnop                                            # 140o pairing

        fms     $cc_4,$fx_2,$fx_2,$radius2_3            # 141e
        frsqest $y_13,$disc_14                          # 141o

        fma     $e_8,$e_7,$k_half,$k_one                # 142e
        fnms    $lz_4,$b_2,$dz_6,$fz_3                  # 143e

        fma     $cc_9,$fz_2,$fz_2,$cc_7                 # 144e
        clgt    $hit_2,$t_best_3,$t_2                   # 145e

        or      $disc_17,$disc_14,$b                    # 146e
        andc    $hit_2,$hit_2,$disc_9                   # 147e

        fma     $q_5,$s_5,$e_8,$b_8                     # 148e
        lnop                                            # 148o pairing

        fnms    $disc_9,$lz_4,$lz_4,$disc_16            # 149e
        rotqbii $hit_3,$hit_2,1                         # 149o

        fma     $cc_10,$fy_3,$fy_3,$cc_5                # 150e
        fnms    $lz_7,$b_3,$dz_9,$fz_3                  # 151e

        fnms    $disc_18,$lz_5,$lz_5,$disc_13           # 152e
        lnop                                            # 152o pairing

        fm      $t,$cc_9,$y_11                          # 153e
        gb      $hit_3,$hit_3                           # 153o

        fma     $cc,$fz_2,$fz_2,$cc_3                   # 154e
        frest   $y_14,$q_5                              # 154o

        fms     $cc_3,$fx_2,$fx_2,$radius2_3            # 155e
        frsqest $y,$disc_9                              # 155o

        fi      $y_8,$disc_14,$y_13                     # 156e
        lnop                                            # 156o pairing

        or      $disc_19,$disc_9,$b_2                   # 157e
        shlqbii $hit_3,$hit_3,4                         # 157o

        fnms    $disc_11,$lz_7,$lz_7,$disc_7            # 158e
        frsqest $y_15,$disc_18                          # 158o

        fi      $y,$disc_9,$y                           # 159e
        fi      $y_11,$q_5,$y_14                        # 160e

        clgt    $hit,$t_best_2,$t                       # 161e
        lqx     $merge_2,$a_merges,$hit_3               # 161o

        fi      $y_16,$disc_18,$y_15                    # 162e
        andc    $hit,$hit,$disc_10                      # 163e

        fm      $s_6,$disc_14,$y_8                      # 164e
        frsqest $y_15,$disc_11                          # 164o

        fma     $cc_11,$fy_3,$fy_3,$cc_4                # 165e
        rotqbii $hit,$hit,1                             # 165o

        fms     $cc_12,$fx_2,$fx_2,$radius2_3           # 166e
        lnop                                            # 166o pairing

        fnms    $e_9,$q_5,$y_11,$k_one                  # 167e
        shufb   $nearest_6,$nearest_2,$object_4,$merge_2 # 167o

        fi      $y_17,$disc_11,$y_15                    # 168e
        shufb   $t_best_6,$t_best_3,$t_2,$merge_2       # 168o

        gb      $hit,$hit                               # 169o
        fm      $s_7,$disc_18,$y_16                     # 170e

        fma     $cc_9,$fz_3,$fz_3,$cc_11                # 171e
        lnop                                            # 171o pairing

        fma     $cc_11,$fy_3,$fy_3,$cc_12               # 172e
        stqd    $t_best_6,224($a_packet_5)              # 172o

        fnms    $e_6,$s_6,$y_8,$k_one                   # 173e
        shlqbii $hit,$hit,4                             # 173o

        fm      $t_3,$cc,$y_12                          # 174e
        stqd    $nearest_6,288($a_packet_5)             # 174o

        fm      $s_8,$disc_11,$y_17                     # 175e
        fnms    $e_8,$s_7,$y_16,$k_one                  # 176e

        fma     $cc_13,$fz_2,$fz_2,$cc_8                # 177e
        fma     $cc_14,$fy_3,$fy_3,$cc_3                # 178e

        fm      $s_9,$disc_9,$y                         # 179e
        clgt    $hit_4,$t_best_4,$t_3                   # 180e

next_pair:
            fnms    $e,$s_9,$y,$k_one                   # 0e
        lqd     $object,0($a_pair)                      # 0o

            fma     $cc,$fz_3,$fz_3,$cc_11              # 1e
            lnop                                        # 1o pairing

            fnms    $e_5,$s_8,$y_17,$k_one              # 2e
            lqx     $merge,$a_merges,$hit               # 2o

            fma     $e_10,$e_6,$k_half,$k_one           # 3e
            fma     $e_6,$e_8,$k_half,$k_one            # 4e

            fma     $y,$e_9,$y_11,$y_11                 # 5e
            lnop                                        # 5o pairing

            andc    $hit,$hit_4,$disc                   # 6e
        rotqbyi $a_packet,$object,4                     # 6o

            fma     $e,$e,$k_half,$k_one                # 7e
        lqd     $quad,0($object)                        # 7o

            fma     $e_5,$e_5,$k_half,$k_one            # 8e
            shufb   $t_best,$t_best_2,$t,$merge         # 8o

            fma     $q,$s_6,$e_10,$b                    # 9e
            shufb   $nearest,$nearest_4,$object_4,$merge # 9o

            fma     $q_6,$s_7,$e_6,$b_9                 # 10e
            rotqbii $hit,$hit,1                         # 10o

            fm      $t,$cc_13,$y                        # 11e
            lnop                                        # 11o pairing

        ai      $a_pair,$a_pair,16                      # 12e
            stqd    $t_best,192($a_packet_5)            # 12o

            fma     $q_3,$s_9,$e,$b_2                   # 13e
            lnop                                        # 13o pairing

            fma     $cc_13,$fz_3,$fz_3,$cc_10           # 14e
        lqd     $dx,32($a_packet)                       # 14o

            fma     $cc_11,$fz_3,$fz_3,$cc_14           # 15e
        shufb   $fx,$quad,$quad,$m_x                    # 15o

            fma     $q_2,$s_8,$e_5,$b_3                 # 16e
        lqd     $dx_3,16($a_packet)                     # 16o

            clgt    $hit_5,$t_best_5,$t                 # 17e
            frest   $y,$q                               # 17o

            or      $disc,$disc_18,$b_9                 # 18e
            frest   $y_18,$q_6                          # 18o

            andc    $hit_5,$hit_5,$disc_12              # 19e
        lqd     $dx_4,48($a_packet)                     # 19o

        fm      $b,$fx,$dx                              # 20e
            frest   $y_19,$q_3                          # 20o

            fi      $y,$q,$y                            # 21e
        lqd     $dx_2,0($a_packet)                      # 21o

            fi      $y_18,$q_6,$y_18                    # 22e
        lqd     $dy_4,112($a_packet)                    # 22o

            or      $disc_12,$disc_11,$b_3              # 23e
        lqd     $dy_2,96($a_packet)                     # 23o

            fi      $y_19,$q_3,$y_19                    # 24e
        shufb   $fy_2,$quad,$quad,$m_y                  # 24o

        ai      $count,$count,-1                        # 25e
        shufb   $fz_3,$quad,$quad,$m_z                  # 25o

        fm      $b_13,$fx,$dx_4                         # 26e
        lqd     $dy_5,80($a_packet)                     # 26o

        fm      $b_2,$fx,$dx_2                          # 27e
        lqd     $dy_3,64($a_packet)                     # 27o

            fnms    $e_11,$q,$y,$k_one                  # 28e
        shufb   $radius2_4,$quad,$quad,$m_radius2       # 28o

        fm      $b_3,$fx,$dx_3                          # 29e
            stqd    $nearest,256($a_packet_5)           # 29o

        fma     $b,$fy_2,$dy_2,$b                       # 30e
        lqd     $dz_4,176($a_packet)                    # 30o

            fnms    $e_6,$q_3,$y_19,$k_one              # 31e
        lqd     $dz_2,160($a_packet)                    # 31o

            fnms    $e_10,$q_6,$y_18,$k_one             # 32e
            frest   $y_14,$q_2                          # 32o

        fma     $b_13,$fy_2,$dy_4,$b_13                 # 33e
            rotqbii $hit_5,$hit_5,1                     # 33o

            fma     $y,$e_11,$y,$y                      # 34e
        lqd     $dz_3,128($a_packet)                    # 34o

        fma     $b_2,$fy_2,$dy_3,$b_2                   # 35e
            gb      $hit,$hit                           # 35o

        fma     $b_3,$fy_2,$dy_5,$b_3                   # 36e
        lqd     $dz_5,144($a_packet)                    # 36o

        fma     $b,$fz_3,$dz_2,$b                       # 37e
            gb      $hit_5,$hit_5                       # 37o

        fms     $cc_5,$fx,$fx,$radius2_4                # 38e
        lnop                                            # 38o pairing

        fms     $cc_2,$fx,$fx,$radius2_4                # 39e
            shlqbii $hit,$hit,4                         # 39o

        fma     $b_9,$fz_3,$dz_4,$b_13                  # 40e
        lnop                                            # 40o pairing

        fma     $b_2,$fz_3,$dz_3,$b_2                   # 41e
            shlqbii $hit_5,$hit_5,4                     # 41o

            fma     $y_15,$e_6,$y_19,$y_19              # 42e
            lnop                                        # 42o pairing

        fma     $b_3,$fz_3,$dz_5,$b_3                   # 43e
            lqx     $merge_3,$a_merges,$hit             # 43o

            fm      $t_4,$cc_11,$y                      # 44e
            lqd     $t_best_7,224($a_packet_6)          # 44o

        fms     $cc_3,$fx,$fx,$radius2_4                # 45e
            lqx     $merge_4,$a_merges,$hit_5           # 45o

        fnms    $lx_3,$b,$dx,$fx                        # 46e
            lqd     $nearest_7,288($a_packet_6)         # 46o

            fma     $y_17,$e_10,$y_18,$y_18             # 47e
            lqd     $nearest_4,256($a_packet_6)         # 47o

        fnms    $lx_4,$b_9,$dx_4,$fx                    # 48e
            lqd     $t_best_2,192($a_packet_6)          # 48o

        fnms    $lx_2,$b_2,$dx_2,$fx                    # 49e
            shufb   $t_best_4,$t_best_4,$t_3,$merge_3   # 49o

        fms     $cc_4,$fx,$fx,$radius2_4                # 50e
            shufb   $nearest_8,$nearest_3,$object_4,$merge_3 # 50o

            clgt    $hit_6,$t_best_7,$t_4               # 51e
            shufb   $t_best_8,$t_best_5,$t,$merge_4     # 51o

        fnms    $lx_5,$b_3,$dx_3,$fx                    # 52e
            shufb   $nearest_9,$nearest_5,$object_4,$merge_4 # 52o

            andc    $hit_5,$hit_6,$disc_17              # 53e
            stqd    $t_best_4,240($a_packet_5)          # 53o

        fnms    $ly,$b,$dy_2,$fy_2                      # 54e
            stqd    $nearest_8,304($a_packet_5)         # 54o

        fnms    $disc_3,$lx_3,$lx_3,$radius2_4          # 55e
            lqd     $nearest_3,304($a_packet_6)         # 55o

        fnms    $disc_5,$lx_4,$lx_4,$radius2_4          # 56e
            shlqbyi $object_4,$object_3,0               # 56o copy

        fnms    $ly_7,$b_2,$dy_3,$fy_2                  # 57e
            stqd    $nearest_9,272($a_packet_5)         # 57o

        fnms    $ly_5,$b_9,$dy_4,$fy_2                  # 58e
            lqd     $t_best_4,240($a_packet_6)          # 58o

        fnms    $disc_8,$lx_5,$lx_5,$radius2_4          # 59e
            rotqbii $hit_5,$hit_5,1                     # 59o

        fnms    $disc_20,$lx_2,$lx_2,$radius2_4         # 60e
            lqd     $nearest_5,272($a_packet_6)         # 60o

        fnms    $ly_8,$b_3,$dy_5,$fy_2                  # 61e
            stqd    $t_best_8,208($a_packet_5)          # 61o

        fnms    $disc_3,$ly,$ly,$disc_3                 # 62e
            shlqbyi $a_packet_5,$a_packet_4,0           # 62o copy

        fnms    $lz_8,$b_9,$dz_4,$fz_3                  # 63e
            lqd     $t_best_5,208($a_packet_6)          # 63o

        fnms    $lz_6,$b,$dz_2,$fz_3                    # 64e
            gb      $hit_5,$hit_5                       # 64o

        fnms    $disc_21,$ly_5,$ly_5,$disc_5            # 65e
        shlqbyi $a_packet_4,$a_packet,0                 # 65o copy

        fnms    $disc_20,$ly_7,$ly_7,$disc_20           # 66e
        shlqbyi $a_packet_6,$a_packet,0                 # 66o copy

        fnms    $lz_9,$b_2,$dz_3,$fz_3                  # 67e
        shufb   $object_3,$object,$object,$m_x          # 67o

        fnms    $lz_10,$b_3,$dz_5,$fz_3                 # 68e
            shlqbii $hit_5,$hit_5,4                     # 68o

        fnms    $disc_8,$ly_8,$ly_8,$disc_8             # 69e
        fnms    $disc_5,$lz_6,$lz_6,$disc_3             # 70e

        fnms    $disc_18,$lz_8,$lz_8,$disc_21           # 71e
        lnop                                            # 71o pairing

        fma     $cc_10,$fy_2,$fy_2,$cc_5                # 72e
            lqx     $merge,$a_merges,$hit_5             # 72o

        fnms    $disc_4,$lz_9,$lz_9,$disc_20            # 73e
        fma     $cc_14,$fy_2,$fy_2,$cc_2                # 74e

        fnms    $disc_11,$lz_10,$lz_10,$disc_8          # 75e
        hbrr    next_pair_back,next_pair                # 75o hint

            fm      $t,$cc_9,$y_15                      # 76e
        frsqest $y_15,$disc_5                           # 76o

            fi      $y_11,$q_2,$y_14                    # 77e
        frsqest $y_5,$disc_18                           # 77o

        or      $disc_17,$disc_5,$b                     # 78e
            shufb   $t_best,$t_best_7,$t_4,$merge       # 78o

        fma     $cc_11,$fy_2,$fy_2,$cc_3                # 79e
            shufb   $nearest,$nearest_7,$object_4,$merge # 79o

        fma     $cc_6,$fy_2,$fy_2,$cc_4                 # 80e
        frsqest $y,$disc_4                              # 80o

            fm      $t_3,$cc,$y_17                      # 81e
        frsqest $y_17,$disc_11                          # 81o

        fi      $y_15,$disc_5,$y_15                     # 82e
            stqd    $t_best,224($a_packet_5)            # 82o

        fi      $y_5,$disc_18,$y_5                      # 83e
            stqd    $nearest,288($a_packet_5)           # 83o

            clgt    $hit,$t_best_2,$t                   # 84e
        fi      $y,$disc_4,$y                           # 85e

            andc    $hit,$hit,$disc_19                  # 86e
        fi      $y_17,$disc_11,$y_17                    # 87e

        or      $disc_19,$disc_4,$b_2                   # 88e
            rotqbii $hit,$hit,1                         # 88o

        fm      $s_6,$disc_5,$y_15                      # 89e
        fm      $s_7,$disc_18,$y_5                      # 90e

        fma     $cc_9,$fz_3,$fz_3,$cc_6                 # 91e
        lnop                                            # 91o pairing

        fm      $s_9,$disc_4,$y                         # 92e
            gb      $hit,$hit                           # 92o

            fnms    $e_9,$q_2,$y_11,$k_one              # 93e
        fm      $s_8,$disc_11,$y_17                     # 94e

        fnms    $e_6,$s_6,$y_15,$k_one                  # 95e
        lnop                                            # 95o pairing

        fnms    $e_8,$s_7,$y_5,$k_one                   # 96e
            shlqbii $hit,$hit,4                         # 96o

            clgt    $hit_4,$t_best_4,$t_3               # 97e
next_pair_back:
        brnz    $count,next_pair                        # 97o

next_pair_drain:
        fma     $e_5,$e_6,$k_half,$k_one                # 0e
        lqx     $merge,$a_merges,$hit                   # 0o

        fnms    $e,$s_9,$y,$k_one                       # 1e
        shlqbyi $object_5,$object_3,0                   # 1o copy

        fma     $y,$e_9,$y_11,$y_11                     # 2e
        shlqbyi $a_packet_7,$a_packet_4,0               # 2o copy

        fnms    $e_10,$s_8,$y_17,$k_one                 # 3e
        hbr     isect_pairs_stable_r16_return,$lr       # 3o hint

        fma     $e_6,$e_8,$k_half,$k_one                # 4e
        andc    $hit,$hit_4,$disc                       # 5e

        fma     $q,$s_6,$e_5,$b                         # 6e
        shufb   $t_best,$t_best_2,$t,$merge             # 6o

        fma     $e,$e,$k_half,$k_one                    # 7e
        rotqbii $hit,$hit,1                             # 7o

        fm      $t,$cc_13,$y                            # 8e
        shufb   $nearest,$nearest_4,$object_4,$merge    # 8o

        fma     $e_5,$e_10,$k_half,$k_one               # 9e
        lnop                                            # 9o pairing

        fma     $cc_15,$fz_3,$fz_3,$cc_14               # 10e
        stqd    $t_best,192($a_packet_5)                # 10o

        fma     $q_3,$s_7,$e_6,$b_9                     # 11e
        gb      $hit,$hit                               # 11o

        fma     $cc,$fz_3,$fz_3,$cc_11                  # 12e
        frest   $y,$q                                   # 12o

        fma     $q_7,$s_9,$e,$b_2                       # 13e
        stqd    $nearest,256($a_packet_5)               # 13o

        clgt    $hit_5,$t_best_5,$t                     # 14e
        lqd     $t_best_9,224($a_packet_6)              # 14o

        fma     $q_2,$s_8,$e_5,$b_3                     # 15e
        shlqbii $hit,$hit,4                             # 15o

        fi      $y,$q,$y                                # 16e
        lqd     $t_best_2,192($a_packet_6)              # 16o

        andc    $hit_5,$hit_5,$disc_12                  # 17e
        frest   $y_18,$q_3                              # 17o

        fma     $cc_16,$fz_3,$fz_3,$cc_10               # 18e
        lqd     $nearest_10,288($a_packet_6)            # 18o

        or      $disc,$disc_18,$b_9                     # 19e
        frest   $y_19,$q_7                              # 19o

        or      $disc_12,$disc_11,$b_3                  # 20e
        rotqbii $hit_5,$hit_5,1                         # 20o

        fi      $y_18,$q_3,$y_18                        # 21e
        frest   $y_14,$q_2                              # 21o

        nop     $127                                    # 22e pairing
        lqx     $merge_5,$a_merges,$hit                 # 22o

        fnms    $e_11,$q,$y,$k_one                      # 23e
        lqd     $nearest_11,256($a_packet_6)            # 23o

        fi      $y_19,$q_7,$y_19                        # 24e
        gb      $hit_5,$hit_5                           # 24o

        fi      $y_20,$q_2,$y_14                        # 25e
        lnop                                            # 25o pairing

        fnms    $e_6,$q_3,$y_18,$k_one                  # 28e
        shlqbii $hit_5,$hit_5,4                         # 28o

        fma     $y,$e_11,$y,$y                          # 29e
        shufb   $t_best_4,$t_best_4,$t_3,$merge_5       # 29o

        shufb   $nearest_12,$nearest_3,$object_4,$merge_5 # 30o
        fnms    $e_3,$q_7,$y_19,$k_one                  # 31e

        fnms    $e_9,$q_2,$y_20,$k_one                  # 32e
        lqx     $merge_4,$a_merges,$hit_5               # 32o

        nop     $127                                    # 33e pairing
        stqd    $t_best_4,240($a_packet_5)              # 33o

        fma     $y_10,$e_6,$y_18,$y_18                  # 34e
        stqd    $nearest_12,304($a_packet_5)            # 34o

        fm      $t_5,$cc_15,$y                          # 35e
        lqd     $nearest_3,304($a_packet_6)             # 35o

        fma     $y_15,$e_3,$y_19,$y_19                  # 37e
        lnop                                            # 37o pairing

        fma     $y,$e_9,$y_20,$y_20                     # 38e
        shufb   $nearest_9,$nearest_5,$object_4,$merge_4 # 38o

        shufb   $t_best_8,$t_best_5,$t,$merge_4         # 39o
        fm      $t_3,$cc,$y_10                          # 40e

        clgt    $hit_7,$t_best_9,$t_5                   # 41e
        stqd    $nearest_9,272($a_packet_5)             # 42o

        andc    $hit_5,$hit_7,$disc_17                  # 43e
        lqd     $t_best_4,240($a_packet_6)              # 43o

        fm      $t_2,$cc_9,$y_15                        # 44e
        lqd     $nearest_5,272($a_packet_6)             # 44o

        fm      $t_6,$cc_16,$y                          # 45e
        rotqbii $hit_5,$hit_5,1                         # 45o

        stqd    $t_best_8,208($a_packet_5)              # 46o
        lqd     $t_best_5,208($a_packet_6)              # 47o

        clgt    $hit_4,$t_best_4,$t_3                   # 49e
        gb      $hit_5,$hit_5                           # 49o

        clgt    $hit,$t_best_2,$t_2                     # 50e
        andc    $hit_3,$hit_4,$disc                     # 51e

        andc    $hit,$hit,$disc_19                      # 52e
        lnop                                            # 52o pairing

        clgt    $hit_8,$t_best_5,$t_6                   # 53e
        shlqbii $hit_5,$hit_5,4                         # 53o

        nop     $127                                    # 54e pairing
        rotqbii $hit,$hit,1                             # 54o

        andc    $hit_8,$hit_8,$disc_12                  # 55e
        rotqbii $hit_3,$hit_3,1                         # 55o

        lqx     $merge,$a_merges,$hit_5                 # 57o
        gb      $hit,$hit                               # 58o

        rotqbii $hit_5,$hit_8,1                         # 59o
        gb      $hit_3,$hit_3                           # 60o

        shlqbii $hit,$hit,4                             # 62o
        shufb   $t_best,$t_best_9,$t_5,$merge           # 63o

        shufb   $nearest,$nearest_10,$object_5,$merge   # 64o
        gb      $hit_5,$hit_5                           # 65o

        shlqbii $hit_9,$hit_3,4                         # 66o
        stqd    $t_best,224($a_packet_7)                # 67o

        stqd    $nearest,288($a_packet_7)               # 68o
        lqx     $merge,$a_merges,$hit                   # 69o

        shlqbii $hit_5,$hit_5,4                         # 70o
        shufb   $t_best,$t_best_2,$t_2,$merge           # 75o

        shufb   $nearest,$nearest_11,$object_5,$merge   # 76o
        stqd    $t_best,192($a_packet_7)                # 79o

        stqd    $nearest,256($a_packet_7)               # 80o
        lqx     $merge_3,$a_merges,$hit_9               # 81o

        lqx     $merge_4,$a_merges,$hit_5               # 82o
        shufb   $t_best_4,$t_best_4,$t_3,$merge_3       # 87o

        shufb   $nearest_8,$nearest_3,$object_5,$merge_3 # 88o
        shufb   $nearest_9,$nearest_5,$object_5,$merge_4 # 89o

        shufb   $t_best_8,$t_best_5,$t_6,$merge_4       # 90o
        stqd    $t_best_4,240($a_packet_7)              # 91o

        stqd    $nearest_8,304($a_packet_7)             # 92o
        stqd    $nearest_9,272($a_packet_7)             # 93o

        stqd    $t_best_8,208($a_packet_7)              # 94o
isect_pairs_stable_r16_return:
        bi      $lr                                     # 95o

next_pair_short:
        ai      $count,$count,-1                        # 0e
        lqd     $object,0($a_pair)                      # 0o

        ai      $a_pair,$a_pair,16                      # 1e
        lqd     $quad,0($object)                        # 6o

        rotqbyi $a_packet,$object,4                     # 7o
        shufb   $object,$object,$object,$m_x            # 8o

        lqd     $dx,0($a_packet)                        # 11o
        shufb   $fx,$quad,$quad,$m_x                    # 12o

        lqd     $dx_9,16($a_packet)                     # 13o
        lqd     $dy,64($a_packet)                       # 14o

        lqd     $dy_9,80($a_packet)                     # 15o
        lqd     $dx_10,32($a_packet)                    # 16o

        fm      $b,$fx,$dx                              # 17e
        shufb   $fy,$quad,$quad,$m_y                    # 17o

        nop     $127                                    # 18e pairing
        lqd     $dz,144($a_packet)                      # 18o

        fm      $b_14,$fx,$dx_9                         # 19e
        lqd     $dz_10,128($a_packet)                   # 19o

        lqd     $dx_3,48($a_packet)                     # 20o
        shufb   $fz,$quad,$quad,$m_z                    # 21o

        fm      $b_15,$fx,$dx_10                        # 22e
        lqd     $dy_4,96($a_packet)                     # 22o

        fma     $b,$fy,$dy,$b                           # 23e
        lqd     $dy_10,112($a_packet)                   # 23o

        nop     $127                                    # 24e pairing
        shufb   $radius2_4,$quad,$quad,$m_radius2       # 24o

        fma     $b_14,$fy,$dy_9,$b_14                   # 25e
        lqd     $dz_11,176($a_packet)                   # 25o

        fm      $b_16,$fx,$dx_3                         # 26e
        lqd     $dz_12,160($a_packet)                   # 26o

        nop     $127                                    # 27e pairing
        lqd     $t_best_10,192($a_packet)               # 27o

        fma     $b_15,$fy,$dy_4,$b_15                   # 28e
        lqd     $t_best_7,208($a_packet)                # 28o

        fma     $b,$fz,$dz_10,$b                        # 29e
        lqd     $t_best_11,224($a_packet)               # 29o

        fms     $cc,$fx,$fx,$radius2_4                  # 30e
        lqd     $t_best_12,240($a_packet)               # 30o

        fma     $b_14,$fz,$dz,$b_14                     # 31e
        lqd     $nearest_13,256($a_packet)              # 31o

        fma     $b_16,$fy,$dy_10,$b_16                  # 32e
        lqd     $nearest_14,272($a_packet)              # 32o

        fms     $cc_17,$fx,$fx,$radius2_4               # 33e
        lqd     $nearest_15,304($a_packet)              # 33o

        fma     $b_15,$fz,$dz_12,$b_15                  # 34e
        lqd     $nearest_16,288($a_packet)              # 34o

        fnms    $lx_3,$b,$dx,$fx                        # 35e
        fnms    $ly_7,$b,$dy,$fy                        # 36e

        fnms    $lx_10,$b_14,$dx_9,$fx                  # 37e
        fnms    $ly_9,$b_14,$dy_9,$fy                   # 38e

        fma     $b_16,$fz,$dz_11,$b_16                  # 39e
        fnms    $lz_11,$b_14,$dz,$fz                    # 40e

        fnms    $disc_3,$lx_3,$lx_3,$radius2_4          # 41e
        fnms    $lx_11,$b_15,$dx_10,$fx                 # 42e

        fnms    $disc_6,$lx_10,$lx_10,$radius2_4        # 43e
        fnms    $lz_12,$b,$dz_10,$fz                    # 44e

        fnms    $lx_5,$b_16,$dx_3,$fx                   # 45e
        fnms    $ly_10,$b_16,$dy_10,$fy                 # 46e

        fnms    $disc_3,$ly_7,$ly_7,$disc_3             # 47e
        fnms    $disc_7,$lx_11,$lx_11,$radius2_4        # 48e

        fnms    $disc_6,$ly_9,$ly_9,$disc_6             # 49e
        fnms    $ly_9,$b_15,$dy_4,$fy                   # 50e

        fnms    $disc_8,$lx_5,$lx_5,$radius2_4          # 51e
        fnms    $lz_13,$b_16,$dz_11,$fz                 # 52e

        fnms    $disc_13,$lz_12,$lz_12,$disc_3          # 53e
        fnms    $lz,$b_15,$dz_12,$fz                    # 54e

        fnms    $disc_6,$lz_11,$lz_11,$disc_6           # 55e
        fnms    $disc_22,$ly_9,$ly_9,$disc_7            # 56e

        fnms    $disc_7,$ly_10,$ly_10,$disc_8           # 57e
        fma     $cc,$fy,$fy,$cc                         # 58e

        fma     $cc_16,$fy,$fy,$cc_17                   # 59e
        frsqest $y_6,$disc_13                           # 59o

        fms     $cc_18,$fx,$fx,$radius2_4               # 60e
        lnop                                            # 60o pairing

        fms     $cc_6,$fx,$fx,$radius2_4                # 61e
        frsqest $y_4,$disc_6                            # 61o

        fnms    $disc_22,$lz,$lz,$disc_22               # 62e
        fi      $y_6,$disc_13,$y_6                      # 63e

        or      $disc_9,$disc_6,$b_14                   # 64e
        fi      $y_4,$disc_6,$y_4                       # 65e

        or      $disc_23,$disc_13,$b                    # 66e
        fnms    $disc_7,$lz_13,$lz_13,$disc_7           # 67e

        fma     $cc_16,$fz,$fz,$cc_16                   # 68e
        frsqest $y_19,$disc_22                          # 68o

        fma     $cc,$fz,$fz,$cc                         # 69e
        fm      $s_10,$disc_13,$y_6                     # 70e

        fma     $cc_6,$fy,$fy,$cc_6                     # 71e
        fm      $s_3,$disc_6,$y_4                       # 72e

        fi      $y_19,$disc_22,$y_19                    # 73e
        frsqest $y_21,$disc_7                           # 73o

        or      $disc_24,$disc_22,$b_15                 # 74e
        fma     $cc_14,$fy,$fy,$cc_18                   # 75e

        fnms    $e_7,$s_10,$y_6,$k_one                  # 76e
        fi      $y_22,$disc_7,$y_21                     # 77e

        or      $disc_12,$disc_7,$b_16                  # 78e
        fnms    $e_12,$s_3,$y_4,$k_one                  # 79e

        fm      $s_11,$disc_22,$y_19                    # 80e
        fma     $cc_6,$fz,$fz,$cc_6                     # 81e

        fma     $e_7,$e_7,$k_half,$k_one                # 82e
        fma     $cc_14,$fz,$fz,$cc_14                   # 83e

        fm      $s_4,$disc_7,$y_22                      # 84e
        fma     $e_12,$e_12,$k_half,$k_one              # 85e

        fnms    $e_13,$s_11,$y_19,$k_one                # 86e
        fma     $q_8,$s_10,$e_7,$b                      # 88e

        fnms    $e_7,$s_4,$y_22,$k_one                  # 90e
        fma     $q_2,$s_3,$e_12,$b_14                   # 91e

        fma     $e_3,$e_13,$k_half,$k_one               # 92e
        frest   $y_4,$q_8                               # 94o

        fma     $e_13,$e_7,$k_half,$k_one               # 96e
        frest   $y_6,$q_2                               # 97o

        fi      $y_4,$q_8,$y_4                          # 98e
        fma     $q_6,$s_11,$e_3,$b_15                   # 100e

        fi      $y_3,$q_2,$y_6                          # 101e
        fma     $q_3,$s_4,$e_13,$b_16                   # 103e

        fnms    $e_14,$q_8,$y_4,$k_one                  # 105e
        frest   $y_18,$q_6                              # 106o

        fnms    $e_5,$q_2,$y_3,$k_one                   # 108e
        frest   $y_23,$q_3                              # 109o

        fi      $y_18,$q_6,$y_18                        # 110e
        fma     $y_24,$e_14,$y_4,$y_4                   # 112e

        fi      $y_4,$q_3,$y_23                         # 113e
        fma     $y_10,$e_5,$y_3,$y_3                    # 115e

        fnms    $e_10,$q_6,$y_18,$k_one                 # 117e
        fm      $t_7,$cc_16,$y_24                       # 118e

        fnms    $e_6,$q_3,$y_4,$k_one                   # 120e
        fm      $t_2,$cc,$y_10                          # 121e

        fma     $y_17,$e_10,$y_18,$y_18                 # 123e
        clgt    $hit,$t_best_10,$t_7                    # 124e

        andc    $hit,$hit,$disc_23                      # 126e
        clgt    $hit_10,$t_best_7,$t_2                  # 127e

        fma     $y_15,$e_6,$y_4,$y_4                    # 128e
        rotqbii $hit,$hit,1                             # 128o

        andc    $hit_10,$hit_10,$disc_9                 # 129e
        fm      $t_5,$cc_6,$y_17                        # 130e

        rotqbii $hit_10,$hit_10,1                       # 131o
        gb      $hit,$hit                               # 132o

        fm      $t_6,$cc_14,$y_15                       # 134e
        gb      $hit_10,$hit_10                         # 135o

        clgt    $hit_8,$t_best_11,$t_5                  # 136e
        shlqbii $hit,$hit,4                             # 136o

        andc    $hit_8,$hit_8,$disc_24                  # 138e
        shlqbii $hit_10,$hit_10,4                       # 139o

        clgt    $hit_11,$t_best_12,$t_6                 # 140e
        lqx     $merge_6,$a_merges,$hit                 # 140o

        rotqbii $hit,$hit_8,1                           # 141o
        andc    $hit_8,$hit_11,$disc_12                 # 142e

        lqx     $merge_7,$a_merges,$hit_10              # 143o
        rotqbii $hit_8,$hit_8,1                         # 144o

        gb      $hit,$hit                               # 145o
        shufb   $nearest,$nearest_13,$object,$merge_6   # 146o

        shufb   $t_best,$t_best_10,$t_7,$merge_6        # 147o
        gb      $hit_3,$hit_8                           # 148o

        shufb   $t_best_6,$t_best_7,$t_2,$merge_7       # 149o
        shufb   $nearest_17,$nearest_14,$object,$merge_7 # 150o

        shlqbii $hit,$hit,4                             # 151o
        shlqbii $hit_3,$hit_3,4                         # 152o

        stqd    $t_best_6,208($a_packet)                # 153o
        stqd    $nearest_17,272($a_packet)              # 154o

        stqd    $nearest,256($a_packet)                 # 155o
        lqx     $merge_8,$a_merges,$hit_3               # 156o

        stqd    $t_best,192($a_packet)                  # 157o
        hbrr    next_pair_short_back,next_pair_short    # 158o hint

        lqx     $merge_2,$a_merges,$hit                 # 159o
        shufb   $nearest,$nearest_15,$object,$merge_8   # 162o

        shufb   $t_best,$t_best_12,$t_6,$merge_8        # 163o
        shufb   $nearest_18,$nearest_16,$object,$merge_2 # 165o

        shufb   $t_best_13,$t_best_11,$t_5,$merge_2     # 166o
        stqd    $t_best,240($a_packet)                  # 167o

        stqd    $nearest,304($a_packet)                 # 168o
        stqd    $nearest_18,288($a_packet)              # 169o

        stqd    $t_best_13,224($a_packet)               # 170o
next_pair_short_back:
        brnz    $count,next_pair_short                  # 173o

        nop     $127                                    # 172e pairing
        bi      $lr                                     # 172o
endfunction isect_pairs_stable_r16
