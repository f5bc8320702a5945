# isect_pairs_newton2_r16   nearest entry of packets' eye rays into spheres, two steps for the root
#   C       void isect_pairs_newton2_r16(const struct pair *, int count);
#   In      $3 pairs, $4 count (0 is none); pointers 16-aligned
#   Out     the pairs' packets: t, object, where an entry is nearer than what was there
#   Uses    $2-$71, $79   Saves  -   Stack  0   Calls  -
#   Domain  |d| = 1 within 4 ulp; radius > 0; centre and radius below 2^62
#   Error   12 ulp of t, eye 1.5 to 30 radii from the centre, ray within 0.995 r of it
#   Twin    oracle/src/twin/sphere/newton2.rs
#
# The steps are those of sphere_tmpl.inc. An opaque sphere has no inside: only the entry counts, and
# behind the eye it is none.
# Scheduled by spu schedule from isect_pairs_newton2_r16.s

        .include "work_unit.inc"
        .include "macros.inc"
        .include "sphere_tmpl.inc"
        .include "sphere_newton2.inc"

        .set    a_pair,3
        .set    count,4
        # constants
        .set    k_half,10
        .set    m_x,11
        .set    m_y,12
        .set    m_z,13
        .set    m_radius2,14
        .set    a_merges,15
        # the pair
        .set    object,16
        .set    a_packet,17
        .set    quad,18
        .set    cx,19
        .set    cy,20
        .set    cz,21
        .set    fx,19                                   # c
        .set    fy,20
        .set    fz,21
        .set    radius2,22
        # a row
        .set    dx,23
        .set    dy,24
        .set    dz,25
        .set    t_best,26
        .set    nearest,27
        # temporaries
        .set    b,28
        .set    lx,29
        .set    ly,30
        .set    lz,31
        .set    disc,32
        .set    y,33
        .set    s,34
        .set    e,35
        .set    t,36
        .set    hit,37
        .set    merge,38

        merges_table

function isect_pairs_newton2_r16
        .set    count_2,79
        .set    a_pair_2,2
        .set    object_2,2
        .set    a_packet_2,5
        .set    quad_2,21
        .set    a_packet_3,20
        .set    quad_3,6
        .set    dx_2,24
        .set    dx_3,26
        .set    dx_4,27
        .set    fx_2,30
        .set    dy_2,31
        .set    dy_3,36
        .set    dy_4,38
        .set    b_2,44
        .set    fy_2,40
        .set    b_3,39
        .set    dx_5,29
        .set    b_4,47
        .set    dz_2,42
        .set    dz_3,43
        .set    dz_4,35
        .set    fz_2,32
        .set    dy_5,46
        .set    dz_5,45
        .set    radius2_2,21
        .set    b_5,50
        .set    dx_6,9
        .set    dx_7,17
        .set    dx_8,18
        .set    b_6,37
        .set    dx_9,22
        .set    b_7,49
        .set    dy_6,25
        .set    dy_7,28
        .set    b_8,7
        .set    dy_8,33
        .set    fy_3,34
        .set    lx_2,24
        .set    dy_9,48
        .set    lx_3,27
        .set    dz_6,51
        .set    lx_4,26
        .set    dz_7,53
        .set    b_9,41
        .set    dz_8,50
        .set    ly_2,36
        .set    fz_3,62
        .set    ly_3,8
        .set    dz_9,38
        .set    ly_4,23
        .set    radius2_3,6
        .set    disc_2,24
        .set    object_3,67
        .set    disc_3,16
        .set    a_packet_4,26
        .set    disc_4,27
        .set    b_10,31
        .set    b_11,30
        .set    lz_2,42
        .set    b_12,57
        .set    lz_3,39
        .set    a_packet_5,71
        .set    lz_4,5
        .set    b_13,35
        .set    disc_5,23
        .set    nearest_2,52
        .set    nearest_3,55
        .set    disc_6,8
        .set    nearest_4,56
        .set    ly_5,24
        .set    t_best_2,58
        .set    disc_7,21
        .set    object_4,59
        .set    lz_5,27
        .set    t_best_3,63
        .set    disc_8,29
        .set    t_best_4,65
        .set    disc_9,64
        .set    t_best_5,66
        .set    disc_10,5
        .set    nearest_5,60
        .set    a_packet_6,61
        .set    b_14,2
        .set    y_2,16
        .set    y_3,21
        .set    y_4,23
        .set    b_15,24
        .set    disc_11,70
        .set    disc_12,7
        .set    disc_13,39
        .set    y_5,26
        .set    y_6,27
        .set    s_2,32
        .set    s_3,36
        .set    s_4,37
        .set    e_2,40
        .set    e_3,41
        .set    e_4,42
        .set    s_5,43
        .set    b_16,69
        .set    lx_5,2
        .set    lx_6,9
        .set    e_5,17
        .set    e_6,5
        .set    e_7,29
        .set    lx_7,18
        .set    s_6,40
        .set    lx_8,19
        .set    ly_6,22
        .set    ly_7,25
        .set    disc_14,2
        .set    disc_15,9
        .set    s_7,16
        .set    s_8,17
        .set    s_9,5
        .set    ly_8,21
        .set    disc_16,18
        .set    e_8,47
        .set    ly_9,26
        .set    disc_17,6
        .set    lz_6,19
        .set    t_2,53
        .set    t_3,54
        .set    t_4,57
        .set    lz_7,22
        .set    disc_18,62
        .set    disc_19,51
        .set    hit_2,2
        .set    t_5,68
        .set    y_7,9
        .set    hit_3,5
        .set    y_8,17
        .set    y_9,6
        .set    y_10,7
        .set    b_17,17
        .set    a_packet_7,18
        .set    hit_4,19
        .set    b_18,22
        .set    s_10,23
        .set    s_11,25
        .set    s_12,28
        .set    e_9,32
        .set    e_10,39
        .set    b_19,48
        .set    e_11,49
        .set    e_12,51
        .set    s_13,9
        .set    merge_2,5
        .set    merge_3,33
        .set    merge_4,2
        .set    merge_5,19
        .set    nearest_6,50
        .set    nearest_7,51
        .set    t_best_6,33
        .set    t_best_7,5
        .set    ly_10,38
        .set    nearest_8,31
        .set    t_best_8,19
        .set    disc_20,22
        .set    lz_8,2
        .set    disc_21,19
        .set    y_11,3
        .set    merge_6,3
        .set    nearest_9,4
        .set    t_best_9,3
        .set    s_14,3
        .set    dx_10,2
        .set    dx_11,5
        .set    dx_12,6
        .set    dy_10,7
        .set    dy_11,8
        .set    dy_12,9
        .set    b_20,20
        .set    fy_4,21
        .set    b_21,26
        .set    dz_10,27
        .set    dz_11,29
        .set    dz_12,30
        .set    fz_4,31
        .set    radius2_4,18
        .set    t_best_10,32
        .set    t_best_11,34
        .set    t_best_12,35
        .set    nearest_10,36
        .set    nearest_11,37
        .set    nearest_12,38
        .set    nearest_13,39
        .set    lx_9,23
        .set    lx_10,5
        .set    lx_11,6
        .set    ly_11,19
        .set    ly_12,7
        .set    ly_13,9
        .set    lz_9,18
        .set    lz_10,21
        .set    lz_11,7
        .set    y_12,18
        .set    y_13,19
        .set    s_15,21
        .set    s_16,24
        .set    e_13,27
        .set    e_14,30
        .set    e_15,31
        .set    s_17,7
        .set    s_18,18
        .set    s_19,19
        .set    t_6,7
        .set    t_7,9
        .set    t_8,18
        .set    t_9,19
        .set    hit_5,20
        .set    hit_6,21
        .set    hit_7,8
        .set    hit_8,6
        .set    merge_7,8
        .set    merge_8,6
        .set    t_best_13,7
        .set    nearest_14,2
        .set    t_best_14,8
        .set    nearest_15,5
        .set    t_best_15,9
        .set    nearest_16,6
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

        ilhu    $k_half,0x3f00                          # 11e
        brz     $count_2,next_pair_short                # 11o too few passes

        ai      $a_pair_2,$a_pair,16                    # 12e
        lqd     $object,0($a_pair)                      # 12o

        ai      $count,$count,-1                        # 13e
        lnop                                            # 13o pairing

        ai      $a_pair,$a_pair_2,16                    # 14e
        lqd     $object_2,0($a_pair_2)                  # 14o

        ai      $count,$count,-1                        # 15e
        rotqbyi $a_packet_2,$object,4                   # 18o

        lqd     $quad_2,0($object)                      # 19o
        rotqbyi $a_packet_3,$object_2,4                 # 20o

        lqd     $quad_3,0($object_2)                    # 21o
        lqd     $dx_2,0($a_packet_2)                    # 22o

        lqd     $dx_3,16($a_packet_2)                   # 23o
        lqd     $dx_4,32($a_packet_2)                   # 24o

        shufb   $fx_2,$quad_2,$quad_2,$m_x              # 25o
        lqd     $dy_2,64($a_packet_2)                   # 26o

        lqd     $dy_3,80($a_packet_2)                   # 27o
        lqd     $dy_4,96($a_packet_2)                   # 28o

        fm      $b_2,$fx_2,$dx_2                        # 29e
        shufb   $fy_2,$quad_2,$quad_2,$m_y              # 29o

        fm      $b_3,$fx_2,$dx_4                        # 30e
        lqd     $dx_5,48($a_packet_2)                   # 30o

        fm      $b_4,$fx_2,$dx_3                        # 31e
        lqd     $dz_2,128($a_packet_2)                  # 31o

        lqd     $dz_3,144($a_packet_2)                  # 32o
        lqd     $dz_4,160($a_packet_2)                  # 33o

        nop     $127                                    # 34e pairing
        shufb   $fz_2,$quad_2,$quad_2,$m_z              # 34o

        fma     $b_2,$fy_2,$dy_2,$b_2                   # 35e
        lqd     $dy_5,112($a_packet_2)                  # 35o

        fma     $b_3,$fy_2,$dy_4,$b_3                   # 36e
        lqd     $dz_5,176($a_packet_2)                  # 36o

        fma     $b_4,$fy_2,$dy_3,$b_4                   # 37e
        shufb   $radius2_2,$quad_2,$quad_2,$m_radius2   # 37o

        fm      $b_5,$fx_2,$dx_5                        # 38e
        lqd     $dx_6,0($a_packet_3)                    # 38o

        lqd     $dx_7,16($a_packet_3)                   # 39o
        lqd     $dx_8,32($a_packet_3)                   # 40o

        fma     $b_2,$fz_2,$dz_2,$b_2                   # 41e
        shufb   $fx,$quad_3,$quad_3,$m_x                # 41o

        fma     $b_6,$fz_2,$dz_4,$b_3                   # 42e
        lqd     $dx_9,48($a_packet_3)                   # 42o

        fma     $b_7,$fz_2,$dz_3,$b_4                   # 43e
        lqd     $dy_6,64($a_packet_3)                   # 43o

        fma     $b_5,$fy_2,$dy_5,$b_5                   # 44e
        lqd     $dy_7,80($a_packet_3)                   # 44o

        fm      $b_8,$fx,$dx_6                          # 45e
        lqd     $dy_8,96($a_packet_3)                   # 45o

        fm      $b_4,$fx,$dx_7                          # 46e
        shufb   $fy_3,$quad_3,$quad_3,$m_y              # 46o

        fnms    $lx_2,$b_2,$dx_2,$fx_2                  # 47e
        lqd     $dy_9,112($a_packet_3)                  # 47o

        fnms    $lx_3,$b_6,$dx_4,$fx_2                  # 48e
        lqd     $dz_6,128($a_packet_3)                  # 48o

        fnms    $lx_4,$b_7,$dx_3,$fx_2                  # 49e
        lqd     $dz_7,144($a_packet_3)                  # 49o

        fma     $b_9,$fz_2,$dz_5,$b_5                   # 50e
        lqd     $dz_8,160($a_packet_3)                  # 50o

        fnms    $ly_2,$b_7,$dy_3,$fy_2                  # 51e
        shufb   $fz_3,$quad_3,$quad_3,$m_z              # 51o

        fnms    $ly_3,$b_6,$dy_4,$fy_2                  # 52e
        lqd     $dz_9,176($a_packet_3)                  # 52o

        fnms    $ly_4,$b_2,$dy_2,$fy_2                  # 53e
        shufb   $radius2_3,$quad_3,$quad_3,$m_radius2   # 53o

        fnms    $disc_2,$lx_2,$lx_2,$radius2_2          # 54e
        shufb   $object_3,$object,$object,$m_x          # 54o

        fnms    $disc_3,$lx_4,$lx_4,$radius2_2          # 55e
        shlqbyi $a_packet_4,$a_packet_2,0               # 55o copy

        fnms    $disc_4,$lx_3,$lx_3,$radius2_2          # 56e
        shlqbyi $b_10,$b_6,0                            # 56o copy

        fnms    $lx,$b_9,$dx_5,$fx_2                    # 57e
        shlqbyi $b_11,$b_2,0                            # 57o copy

        fnms    $lz_2,$b_2,$dz_2,$fz_2                  # 58e
        shlqbyi $b_12,$b_7,0                            # 58o copy

        fnms    $lz_3,$b_7,$dz_3,$fz_2                  # 59e
        shlqbyi $a_packet_5,$a_packet_2,0               # 59o copy

        fnms    $lz_4,$b_6,$dz_4,$fz_2                  # 60e
        shlqbyi $b_13,$b_9,0                            # 60o copy

        fnms    $disc_5,$ly_4,$ly_4,$disc_2             # 61e
        lqd     $nearest_2,288($a_packet_4)             # 61o

        fnms    $disc_3,$ly_2,$ly_2,$disc_3             # 62e
        lqd     $nearest_3,304($a_packet_4)             # 62o

        fnms    $disc_6,$ly_3,$ly_3,$disc_4             # 63e
        lqd     $nearest_4,256($a_packet_4)             # 63o

        fnms    $ly_5,$b_9,$dy_5,$fy_2                  # 64e
        lqd     $t_best_2,240($a_packet_4)              # 64o

        fnms    $disc_7,$lx,$lx,$radius2_2              # 65e
        shlqbyi $object_4,$object_3,0                   # 65o copy

        fnms    $lz_5,$b_9,$dz_5,$fz_2                  # 66e
        lqd     $t_best_3,208($a_packet_4)              # 66o

        fnms    $disc_8,$lz_2,$lz_2,$disc_5             # 67e
        lqd     $t_best_4,224($a_packet_4)              # 67o

        fnms    $disc_9,$lz_3,$lz_3,$disc_3             # 68e
        lqd     $t_best_5,192($a_packet_4)              # 68o

        fnms    $disc_10,$lz_4,$lz_4,$disc_6            # 69e
        lqd     $nearest_5,272($a_packet_4)             # 69o

        fm      $b_3,$fx,$dx_8                          # 70e
        shlqbyi $a_packet_6,$a_packet_5,0               # 70o copy

        fnms    $disc,$ly_5,$ly_5,$disc_7               # 71e
        shufb   $object_3,$object_2,$object_2,$m_x      # 71o

        fm      $b_14,$fx,$dx_9                         # 72e
        shlqbyi $a_packet_5,$a_packet_3,0               # 72o copy

        fma     $b_2,$fy_3,$dy_6,$b_8                   # 73e
        frsqest $y_2,$disc_8                            # 73o

        fma     $b_4,$fy_3,$dy_7,$b_4                   # 74e
        frsqest $y_3,$disc_9                            # 74o

        nop     $127                                    # 75e pairing
        frsqest $y_4,$disc_10                           # 75o

        fma     $b_15,$fy_3,$dy_8,$b_3                  # 76e
        shlqbyi $disc_6,$disc_10,0                      # 76o copy

        fnms    $disc_11,$lz_5,$lz_5,$disc              # 77e
        shlqbyi $disc_12,$disc_8,0                      # 77o copy

        fi      $y_2,$disc_8,$y_2                       # 78e
        shlqbyi $disc_13,$disc_9,0                      # 78o copy

        fi      $y_3,$disc_9,$y_3                       # 79e
        fi      $y_5,$disc_10,$y_4                      # 80e

        fma     $b_14,$fy_3,$dy_9,$b_14                 # 82e
        lnop                                            # 82o pairing

        fma     $b_2,$fz_3,$dz_6,$b_2                   # 83e
        frsqest $y_6,$disc_11                           # 83o

        fma     $b_7,$fz_3,$dz_7,$b_4                   # 84e
        shlqbyi $disc_5,$disc_11,0                      # 84o copy

        fm      $s_2,$disc_8,$y_2                       # 85e
        fm      $s_3,$disc_9,$y_3                       # 86e

        fm      $s_4,$disc_10,$y_5                      # 87e
        fi      $y_6,$disc_11,$y_6                      # 88e

        fm      $y_2,$y_2,$k_half                       # 90e
        fm      $y_3,$y_3,$k_half                       # 91e

        fnms    $e_2,$s_2,$s_2,$disc_8                  # 92e
        fnms    $e_3,$s_3,$s_3,$disc_9                  # 93e

        fm      $y_5,$y_5,$k_half                       # 94e
        fnms    $e_4,$s_4,$s_4,$disc_10                 # 95e

        fm      $s_5,$disc_11,$y_6                      # 96e
        fma     $b_15,$fz_3,$dz_8,$b_15                 # 97e

        fma     $s_2,$e_2,$y_2,$s_2                     # 98e
        fma     $s_3,$e_3,$y_3,$s_3                     # 99e

        fm      $y_6,$y_6,$k_half                       # 100e
        fma     $s_4,$e_4,$y_5,$s_4                     # 101e

        fnms    $e_2,$s_5,$s_5,$disc_11                 # 102e
        lnop                                            # 102o pairing

        fma     $b_9,$fz_3,$dz_9,$b_14                  # 103e
        shlqbyi $b_16,$b_15,0                           # 103o copy

        fnms    $lx_5,$b_2,$dx_6,$fx                    # 104e
        fnms    $lx_6,$b_7,$dx_7,$fx                    # 105e

        fnms    $e_5,$s_2,$s_2,$disc_8                  # 106e
        fnms    $e_6,$s_4,$s_4,$disc_10                 # 107e

        fnms    $e_7,$s_3,$s_3,$disc_9                  # 108e
        fnms    $lx_7,$b_15,$dx_8,$fx                   # 109e

        fma     $s_6,$e_2,$y_6,$s_5                     # 110e
        fnms    $lx_8,$b_9,$dx_9,$fx                    # 111e

        fnms    $ly_6,$b_7,$dy_7,$fy_3                  # 112e
        fnms    $ly_7,$b_2,$dy_6,$fy_3                  # 113e

        fnms    $disc_14,$lx_5,$lx_5,$radius2_3         # 114e
        fnms    $disc_15,$lx_6,$lx_6,$radius2_3         # 115e

        fma     $s_7,$e_5,$y_2,$s_2                     # 116e
        fma     $s_8,$e_7,$y_3,$s_3                     # 117e

        fma     $s_9,$e_6,$y_5,$s_4                     # 118e
        fnms    $ly_8,$b_15,$dy_8,$fy_3                 # 119e

        fnms    $disc_16,$lx_7,$lx_7,$radius2_3         # 120e
        fnms    $e_8,$s_6,$s_6,$disc_11                 # 121e

        fnms    $ly_9,$b_9,$dy_9,$fy_3                  # 122e
        fnms    $disc_17,$lx_8,$lx_8,$radius2_3         # 123e

        fnms    $lz_2,$b_2,$dz_6,$fz_3                  # 124e
        fnms    $lz_6,$b_7,$dz_7,$fz_3                  # 125e

        fnms    $disc_14,$ly_7,$ly_7,$disc_14           # 126e
        fnms    $disc_15,$ly_6,$ly_6,$disc_15           # 127e

        fs      $t_2,$b_10,$s_9                         # 128e
        fs      $t_3,$b_11,$s_7                         # 129e

        fnms    $lz_4,$b_15,$dz_8,$fz_3                 # 130e
        fs      $t_4,$b_12,$s_8                         # 131e

        fnms    $disc_3,$ly_8,$ly_8,$disc_16            # 132e
        hbrr    next_pair_back,next_pair                # 132o hint

        fnms    $lz_7,$b_9,$dz_9,$fz_3                  # 133e
        fma     $s,$e_8,$y_6,$s_6                       # 134e

        fnms    $disc,$ly_9,$ly_9,$disc_17              # 135e
        fnms    $disc_18,$lz_2,$lz_2,$disc_14           # 136e

        fnms    $disc_9,$lz_6,$lz_6,$disc_15            # 137e
        fnms    $disc_19,$lz_4,$lz_4,$disc_3            # 138e

        clgt    $hit_2,$t_best_3,$t_4                   # 139e
        fs      $t_5,$b_13,$s                           # 140e

        fnms    $disc_11,$lz_7,$lz_7,$disc              # 141e
        lnop                                            # 141o pairing

        clgt    $hit,$t_best_4,$t_2                     # 142e
        frsqest $y_7,$disc_18                           # 142o

        clgt    $hit_3,$t_best_5,$t_3                   # 143e
        frsqest $y_8,$disc_9                            # 143o

next_pair:
            andc    $hit,$hit,$disc_6                   # 0e
            frsqest $y,$disc_19                         # 0o

            andc    $hit_2,$hit_2,$disc_13              # 1e
        lqd     $object,0($a_pair)                      # 1o

            andc    $hit_3,$hit_3,$disc_12              # 2e
            frsqest $y_9,$disc_11                       # 2o

            fi      $y_10,$disc_18,$y_7                 # 3e
            shlqbyi $disc_6,$disc_19,0                  # 3o copy

            fi      $y_7,$disc_9,$y_8                   # 4e
            shlqbyi $b_17,$b_9,0                        # 4o copy

            fi      $y,$disc_19,$y                      # 5e
            shlqbyi $a_packet_7,$a_packet_3,0           # 5o copy

            clgt    $hit_4,$t_best_2,$t_5               # 6e
            rotqbii $hit_3,$hit_3,1                     # 6o

            fi      $y_9,$disc_11,$y_9                  # 7e
        rotqbyi $a_packet_3,$object,4                   # 7o

            andc    $hit_4,$hit_4,$disc_5               # 8e
        lqd     $quad_2,0($object)                      # 8o

        ai      $a_pair,$a_pair,16                      # 9e
            rotqbii $hit_2,$hit_2,1                     # 9o

            fm      $s,$disc_18,$y_10                   # 10e
            shlqbyi $b_18,$b_2,0                        # 10o copy

            fm      $s_10,$disc_9,$y_7                  # 11e
        lqd     $dx_2,0($a_packet_3)                    # 11o

            fm      $s_11,$disc_19,$y                   # 12e
        lqd     $dx_3,16($a_packet_3)                   # 12o

            fm      $y_10,$y_10,$k_half                 # 13e
        lqd     $dx_4,32($a_packet_3)                   # 13o

            fm      $s_12,$disc_11,$y_9                 # 14e
        lqd     $dx_5,48($a_packet_3)                   # 14o

            fm      $y_7,$y_7,$k_half                   # 15e
        shufb   $fx_2,$quad_2,$quad_2,$m_x              # 15o

            fnms    $e,$s,$s,$disc_18                   # 16e
        lqd     $dy_2,64($a_packet_3)                   # 16o

            fnms    $e_9,$s_10,$s_10,$disc_9            # 17e
        lqd     $dy_3,80($a_packet_3)                   # 17o

            fm      $y,$y,$k_half                       # 18e
        lqd     $dy_4,96($a_packet_3)                   # 18o

            fnms    $e_10,$s_11,$s_11,$disc_19          # 19e
        shufb   $fy_2,$quad_2,$quad_2,$m_y              # 19o

            fnms    $e_3,$s_12,$s_12,$disc_11           # 20e
        lqd     $dz_2,128($a_packet_3)                  # 20o

            fm      $y_9,$y_9,$k_half                   # 21e
        lqd     $dz_3,144($a_packet_3)                  # 21o

            fma     $s,$e,$y_10,$s                      # 22e
        lqd     $dz_4,160($a_packet_3)                  # 22o

        fm      $b_2,$fx_2,$dx_2                        # 23e
        lqd     $dz_5,176($a_packet_3)                  # 23o

            fma     $s_10,$e_9,$y_7,$s_10               # 24e
        shufb   $fz_2,$quad_2,$quad_2,$m_z              # 24o

            fma     $s_11,$e_10,$y,$s_11                # 25e
        shufb   $radius2_2,$quad_2,$quad_2,$m_radius2   # 25o

        fm      $b_3,$fx_2,$dx_4                        # 26e
        lqd     $dy_5,112($a_packet_3)                  # 26o

        fm      $b_4,$fx_2,$dx_3                        # 27e
            shlqbyi $b_19,$b_7,0                        # 27o copy

            fnms    $e_11,$s,$s,$disc_18                # 28e
            rotqbii $hit,$hit,1                         # 28o

        fm      $b_5,$fx_2,$dx_5                        # 29e
            rotqbii $hit_4,$hit_4,1                     # 29o

        fma     $b_2,$fy_2,$dy_2,$b_2                   # 30e
            gb      $hit_3,$hit_3                       # 30o

            fma     $s_12,$e_3,$y_9,$s_12               # 31e
            gb      $hit_2,$hit_2                       # 31o

            fnms    $e_3,$s_11,$s_11,$disc_19           # 32e
            gb      $hit,$hit                           # 32o

            fnms    $e_12,$s_10,$s_10,$disc_9           # 33e
            gb      $hit_4,$hit_4                       # 33o

        fma     $b_4,$fy_2,$dy_3,$b_4                   # 34e
            shlqbii $hit_3,$hit_3,4                     # 34o

        fma     $b_3,$fy_2,$dy_4,$b_3                   # 35e
            shlqbii $hit_2,$hit_2,4                     # 35o

        fma     $b_5,$fy_2,$dy_5,$b_5                   # 36e
            shlqbii $hit,$hit,4                         # 36o

        fma     $b_2,$fz_2,$dz_2,$b_2                   # 37e
            shlqbii $hit_4,$hit_4,4                     # 37o

            fma     $s,$e_11,$y_10,$s                   # 38e
            shlqbyi $disc_12,$disc_18,0                 # 38o copy

            fma     $s_13,$e_12,$y_7,$s_10              # 39e
            shlqbyi $disc_5,$disc_11,0                  # 39o copy

        fma     $b_7,$fz_2,$dz_3,$b_4                   # 40e
            lqx     $merge_2,$a_merges,$hit_3           # 40o

            fma     $s_11,$e_3,$y,$s_11                 # 41e
            lqx     $merge_3,$a_merges,$hit             # 41o

        fma     $b_6,$fz_2,$dz_4,$b_3                   # 42e
            shlqbyi $disc_13,$disc_9,0                  # 42o copy

        fma     $b_9,$fz_2,$dz_5,$b_5                   # 43e
        lnop                                            # 43o pairing

        fnms    $lz_2,$b_2,$dz_2,$fz_2                  # 44e
            lqx     $merge_4,$a_merges,$hit_2           # 44o

            fnms    $e_8,$s_12,$s_12,$disc_11           # 45e
            lqx     $merge_5,$a_merges,$hit_4           # 45o

        fnms    $lx_2,$b_2,$dx_2,$fx_2                  # 46e
            shufb   $nearest_6,$nearest_4,$object_4,$merge_2 # 46o

        fnms    $ly_2,$b_7,$dy_3,$fy_2                  # 47e
            shufb   $nearest_7,$nearest_2,$object_4,$merge_3 # 47o

        fnms    $lx_4,$b_7,$dx_3,$fx_2                  # 48e
            shufb   $t_best_6,$t_best_4,$t_2,$merge_3   # 48o

        fnms    $lx_3,$b_6,$dx_4,$fx_2                  # 49e
            shufb   $t_best_7,$t_best_5,$t_3,$merge_2   # 49o

        fnms    $lx,$b_9,$dx_5,$fx_2                    # 50e
            stqd    $nearest_6,256($a_packet_6)         # 50o

        fnms    $ly,$b_6,$dy_4,$fy_2                    # 51e
            stqd    $nearest_7,288($a_packet_6)         # 51o

        fnms    $ly_10,$b_9,$dy_5,$fy_2                 # 52e
            lqd     $nearest_2,288($a_packet_7)         # 52o

            fs      $t_2,$b_16,$s_11                    # 53e
            stqd    $t_best_6,224($a_packet_6)          # 53o

        fnms    $ly_7,$b_2,$dy_2,$fy_2                  # 54e
            shufb   $nearest_8,$nearest_3,$object_4,$merge_5 # 54o

        fnms    $disc_2,$lx_2,$lx_2,$radius2_2          # 55e
            shufb   $t_best_6,$t_best_3,$t_4,$merge_4   # 55o

            fs      $t_3,$b_18,$s                       # 56e
            shufb   $t_best_8,$t_best_2,$t_5,$merge_5   # 56o

        fnms    $disc_20,$lx_4,$lx_4,$radius2_2         # 57e
            stqd    $t_best_7,192($a_packet_6)          # 57o

        fnms    $disc_10,$lx_3,$lx_3,$radius2_2         # 58e
            stqd    $nearest_8,304($a_packet_6)         # 58o

        fnms    $disc_7,$lx,$lx,$radius2_2              # 59e
            shufb   $nearest,$nearest_5,$object_4,$merge_4 # 59o

        fnms    $lz,$b_7,$dz_3,$fz_2                    # 60e
            lqd     $nearest_3,304($a_packet_7)         # 60o

        fnms    $lz_8,$b_6,$dz_4,$fz_2                  # 61e
            stqd    $t_best_8,240($a_packet_6)          # 61o

        fnms    $disc_21,$ly_7,$ly_7,$disc_2            # 62e
            lqd     $nearest_4,256($a_packet_7)         # 62o

            fs      $t_4,$b_19,$s_13                    # 63e
            lqd     $t_best_2,240($a_packet_7)          # 63o

        fnms    $disc_15,$ly_2,$ly_2,$disc_20           # 64e
            stqd    $nearest,272($a_packet_6)           # 64o

        fnms    $disc_10,$ly,$ly,$disc_10               # 65e
            shlqbyi $object_4,$object_3,0               # 65o copy

        fnms    $lz_7,$b_9,$dz_5,$fz_2                  # 66e
            lqd     $nearest_5,272($a_packet_7)         # 66o

            fma     $s,$e_8,$y_9,$s_12                  # 67e
            stqd    $t_best_6,208($a_packet_6)          # 67o

        fnms    $disc,$ly_10,$ly_10,$disc_7             # 68e
            shlqbyi $a_packet_6,$a_packet_5,0           # 68o copy

        fnms    $disc_18,$lz_2,$lz_2,$disc_21           # 69e
            lqd     $t_best_3,208($a_packet_7)          # 69o

        fnms    $disc_9,$lz,$lz,$disc_15                # 70e
            lqd     $t_best_4,224($a_packet_7)          # 70o

        fnms    $disc_19,$lz_8,$lz_8,$disc_10           # 71e
            lqd     $t_best_5,192($a_packet_7)          # 71o

        ai      $count,$count,-1                        # 72e
        shufb   $object_3,$object,$object,$m_x          # 72o

            fs      $t_5,$b_17,$s                       # 73e
        shlqbyi $b_16,$b_6,0                            # 73o copy

        fnms    $disc_11,$lz_7,$lz_7,$disc              # 74e
        shlqbyi $a_packet_5,$a_packet_3,0               # 74o copy

            clgt    $hit_2,$t_best_3,$t_4               # 75e
        frsqest $y_7,$disc_18                           # 75o

            clgt    $hit,$t_best_4,$t_2                 # 76e
        frsqest $y_8,$disc_9                            # 76o

            clgt    $hit_3,$t_best_5,$t_3               # 77e
next_pair_back:
        brnz    $count,next_pair                        # 77o

next_pair_drain:
        fi      $y_11,$disc_18,$y_7                     # 0e
        frsqest $y,$disc_19                             # 0o

        andc    $hit_3,$hit_3,$disc_12                  # 1e
        frsqest $y_9,$disc_11                           # 1o

        andc    $hit,$hit,$disc_6                       # 2e
        shlqbyi $a_packet_7,$a_packet_3,0               # 2o copy

        clgt    $hit_4,$t_best_2,$t_5                   # 3e
        rotqbii $hit_3,$hit_3,1                         # 3o

        fi      $y,$disc_19,$y                          # 4e
        rotqbii $hit,$hit,1                             # 4o

        fi      $y_7,$disc_9,$y_8                       # 5e
        shlqbyi $b_18,$b_2,0                            # 5o copy

        fi      $y_9,$disc_11,$y_9                      # 6e
        shlqbyi $b_17,$b_9,0                            # 6o copy

        andc    $hit_4,$hit_4,$disc_5                   # 7e
        gb      $hit_3,$hit_3                           # 7o

        fm      $s,$disc_18,$y_11                       # 8e
        gb      $hit,$hit                               # 8o

        andc    $hit_2,$hit_2,$disc_13                  # 9e
        rotqbii $hit_4,$hit_4,1                         # 9o

        fm      $y_10,$y_11,$k_half                     # 10e
        shlqbyi $b_19,$b_7,0                            # 10o copy

        fm      $s_11,$disc_19,$y                       # 11e
        shlqbii $hit_3,$hit_3,4                         # 11o

        fm      $s_10,$disc_9,$y_7                      # 12e
        rotqbii $hit_2,$hit_2,1                         # 12o

        fm      $s_12,$disc_11,$y_9                     # 13e
        gb      $hit_4,$hit_4                           # 13o

        fnms    $e,$s,$s,$disc_18                       # 14e
        shlqbii $hit,$hit,4                             # 14o

        fm      $y,$y,$k_half                           # 15e
        lqx     $merge_2,$a_merges,$hit_3               # 15o

        fm      $y_7,$y_7,$k_half                       # 16e
        gb      $hit_2,$hit_2                           # 16o

        fnms    $e_10,$s_11,$s_11,$disc_19              # 17e
        shlqbii $hit_4,$hit_4,4                         # 17o

        fm      $y_9,$y_9,$k_half                       # 18e
        lqx     $merge_6,$a_merges,$hit                 # 18o

        fnms    $e_3,$s_12,$s_12,$disc_11               # 19e
        shlqbyi $disc_6,$disc_19,0                      # 19o copy

        fnms    $e_9,$s_10,$s_10,$disc_9                # 20e
        shlqbii $hit_2,$hit_2,4                         # 20o

        fma     $s,$e,$y_10,$s                          # 21e
        lqx     $merge_5,$a_merges,$hit_4               # 21o

        nop     $127                                    # 22e pairing
        shufb   $nearest_6,$nearest_4,$object_4,$merge_2 # 22o

        fma     $s_11,$e_10,$y,$s_11                    # 23e
        shufb   $t_best_7,$t_best_5,$t_3,$merge_2       # 23o

        nop     $127                                    # 24e pairing
        shufb   $nearest_9,$nearest_2,$object_4,$merge_6 # 24o

        fma     $s_12,$e_3,$y_9,$s_12                   # 25e
        shufb   $t_best_9,$t_best_4,$t_2,$merge_6       # 25o

        fma     $s_10,$e_9,$y_7,$s_10                   # 26e
        lqx     $merge_4,$a_merges,$hit_2               # 26o

        fnms    $e_11,$s,$s,$disc_18                    # 27e
        stqd    $nearest_6,256($a_packet_6)             # 27o

        nop     $127                                    # 28e pairing
        stqd    $nearest_9,288($a_packet_6)             # 28o

        fnms    $e_3,$s_11,$s_11,$disc_19               # 29e
        shufb   $nearest_8,$nearest_3,$object_4,$merge_5 # 29o

        nop     $127                                    # 30e pairing
        lqd     $nearest_2,288($a_packet_7)             # 30o

        fnms    $e_8,$s_12,$s_12,$disc_11               # 31e
        stqd    $t_best_9,224($a_packet_6)              # 31o

        fnms    $e_12,$s_10,$s_10,$disc_9               # 32e
        shufb   $t_best_8,$t_best_2,$t_5,$merge_5       # 32o

        fma     $s,$e_11,$y_10,$s                       # 33e
        shufb   $nearest,$nearest_5,$object_4,$merge_4  # 33o

        nop     $127                                    # 34e pairing
        stqd    $t_best_7,192($a_packet_6)              # 34o

        fma     $s_11,$e_3,$y,$s_11                     # 35e
        stqd    $nearest_8,304($a_packet_6)             # 35o

        nop     $127                                    # 36e pairing
        lqd     $nearest_3,304($a_packet_7)             # 36o

        fma     $s_14,$e_8,$y_9,$s_12                   # 37e
        shufb   $t_best_6,$t_best_3,$t_4,$merge_4       # 37o

        fma     $s_13,$e_12,$y_7,$s_10                  # 38e
        stqd    $t_best_8,240($a_packet_6)              # 38o

        fs      $t_3,$b_18,$s                           # 39e
        lqd     $t_best_2,240($a_packet_7)              # 39o

        nop     $127                                    # 40e pairing
        lqd     $nearest_4,256($a_packet_7)             # 40o

        fs      $t_2,$b_16,$s_11                        # 41e
        stqd    $nearest,272($a_packet_6)               # 41o

        nop     $127                                    # 42e pairing
        lqd     $nearest_5,272($a_packet_7)             # 42o

        fs      $t_5,$b_17,$s_14                        # 43e
        stqd    $t_best_6,208($a_packet_6)              # 43o

        fs      $t_4,$b_19,$s_13                        # 44e
        lqd     $t_best_5,192($a_packet_7)              # 44o

        lqd     $t_best_4,224($a_packet_7)              # 45o
        shlqbyi $disc_12,$disc_18,0                     # 46o copy

        lqd     $t_best_3,208($a_packet_7)              # 47o
        shlqbyi $disc_5,$disc_11,0                      # 48o copy

        clgt    $hit_4,$t_best_2,$t_5                   # 49e
        shlqbyi $disc_13,$disc_9,0                      # 49o copy

        clgt    $hit_3,$t_best_5,$t_3                   # 50e
        shlqbyi $object_4,$object_3,0                   # 50o copy

        clgt    $hit,$t_best_4,$t_2                     # 51e
        hbr     isect_pairs_newton2_r16_return,$lr      # 51o hint

        andc    $hit_3,$hit_3,$disc_12                  # 52e
        shlqbyi $a_packet_6,$a_packet_5,0               # 52o copy

        andc    $hit,$hit,$disc_6                       # 53e
        lnop                                            # 53o pairing

        clgt    $hit_2,$t_best_3,$t_4                   # 54e
        rotqbii $hit_3,$hit_3,1                         # 54o

        andc    $hit_4,$hit_4,$disc_5                   # 55e
        rotqbii $hit,$hit,1                             # 55o

        andc    $hit_2,$hit_2,$disc_13                  # 56e
        rotqbii $hit_4,$hit_4,1                         # 57o

        gb      $hit_3,$hit_3                           # 58o
        rotqbii $hit_2,$hit_2,1                         # 59o

        gb      $hit,$hit                               # 60o
        gb      $hit_4,$hit_4                           # 61o

        shlqbii $hit_3,$hit_3,4                         # 62o
        gb      $hit_2,$hit_2                           # 63o

        shlqbii $hit,$hit,4                             # 64o
        shlqbii $hit_4,$hit_4,4                         # 65o

        lqx     $merge_2,$a_merges,$hit_3               # 66o
        shlqbii $hit_2,$hit_2,4                         # 67o

        lqx     $merge_3,$a_merges,$hit                 # 68o
        lqx     $merge_5,$a_merges,$hit_4               # 69o

        lqx     $merge_4,$a_merges,$hit_2               # 71o
        shufb   $nearest_6,$nearest_4,$object_4,$merge_2 # 72o

        shufb   $t_best_7,$t_best_5,$t_3,$merge_2       # 73o
        shufb   $nearest_7,$nearest_2,$object_4,$merge_3 # 74o

        shufb   $t_best_6,$t_best_4,$t_2,$merge_3       # 75o
        stqd    $nearest_6,256($a_packet_6)             # 76o

        shufb   $nearest_8,$nearest_3,$object_4,$merge_5 # 77o
        stqd    $nearest_7,288($a_packet_6)             # 78o

        stqd    $t_best_6,224($a_packet_6)              # 79o
        shufb   $t_best_8,$t_best_2,$t_5,$merge_5       # 80o

        shufb   $nearest,$nearest_5,$object_4,$merge_4  # 81o
        shufb   $t_best_6,$t_best_3,$t_4,$merge_4       # 82o

        stqd    $t_best_7,192($a_packet_6)              # 83o
        stqd    $nearest_8,304($a_packet_6)             # 84o

        stqd    $t_best_8,240($a_packet_6)              # 85o
        stqd    $nearest,272($a_packet_6)               # 86o

        stqd    $t_best_6,208($a_packet_6)              # 87o
isect_pairs_newton2_r16_return:
        bi      $lr                                     # 88o

next_pair_short:
        ai      $count,$count,-1                        # 0e
        lqd     $object,0($a_pair)                      # 0o

        ai      $a_pair,$a_pair,16                      # 1e
        rotqbyi $a_packet,$object,4                     # 6o

        lqd     $quad,0($object)                        # 7o
        shufb   $object,$object,$object,$m_x            # 8o

        lqd     $dx,0($a_packet)                        # 10o
        lqd     $dx_10,16($a_packet)                    # 11o

        lqd     $dx_11,32($a_packet)                    # 12o
        lqd     $dx_12,48($a_packet)                    # 13o

        shufb   $fx,$quad,$quad,$m_x                    # 14o
        lqd     $dy,64($a_packet)                       # 15o

        lqd     $dy_10,80($a_packet)                    # 16o
        lqd     $dy_11,96($a_packet)                    # 17o

        fm      $b,$fx,$dx                              # 18e
        lqd     $dy_12,112($a_packet)                   # 18o

        fm      $b_20,$fx,$dx_10                        # 19e
        shufb   $fy_4,$quad,$quad,$m_y                  # 19o

        fm      $b_18,$fx,$dx_11                        # 20e
        lqd     $dz,128($a_packet)                      # 20o

        fm      $b_21,$fx,$dx_12                        # 21e
        lqd     $dz_10,144($a_packet)                   # 21o

        lqd     $dz_11,160($a_packet)                   # 22o
        lqd     $dz_12,176($a_packet)                   # 23o

        fma     $b,$fy_4,$dy,$b                         # 24e
        shufb   $fz_4,$quad,$quad,$m_z                  # 24o

        fma     $b_20,$fy_4,$dy_10,$b_20                # 25e
        shufb   $radius2_4,$quad,$quad,$m_radius2       # 25o

        fma     $b_18,$fy_4,$dy_11,$b_18                # 26e
        lqd     $t_best_10,192($a_packet)               # 26o

        fma     $b_21,$fy_4,$dy_12,$b_21                # 27e
        lqd     $t_best_6,208($a_packet)                # 27o

        lqd     $t_best_11,224($a_packet)               # 28o
        lqd     $t_best_12,240($a_packet)               # 29o

        fma     $b,$fz_4,$dz,$b                         # 30e
        lqd     $nearest_10,256($a_packet)              # 30o

        fma     $b_20,$fz_4,$dz_10,$b_20                # 31e
        lqd     $nearest_11,272($a_packet)              # 31o

        fma     $b_18,$fz_4,$dz_11,$b_18                # 32e
        lqd     $nearest_12,288($a_packet)              # 32o

        fma     $b_21,$fz_4,$dz_12,$b_21                # 33e
        lqd     $nearest_13,304($a_packet)              # 33o

        fnms    $lx_9,$b,$dx,$fx                        # 36e
        fnms    $lx_5,$b_20,$dx_10,$fx                  # 37e

        fnms    $lx_10,$b_18,$dx_11,$fx                 # 38e
        fnms    $lx_11,$b_21,$dx_12,$fx                 # 39e

        fnms    $ly_11,$b,$dy,$fy_4                     # 40e
        fnms    $ly_12,$b_20,$dy_10,$fy_4               # 41e

        fnms    $disc_5,$lx_9,$lx_9,$radius2_4          # 42e
        fnms    $disc_14,$lx_5,$lx_5,$radius2_4         # 43e

        fnms    $ly_3,$b_18,$dy_11,$fy_4                # 44e
        fnms    $disc_10,$lx_10,$lx_10,$radius2_4       # 45e

        fnms    $ly_13,$b_21,$dy_12,$fy_4               # 46e
        fnms    $disc_17,$lx_11,$lx_11,$radius2_4       # 47e

        fnms    $lz_9,$b,$dz,$fz_4                      # 48e
        fnms    $disc_21,$ly_11,$ly_11,$disc_5          # 49e

        fnms    $lz_10,$b_20,$dz_10,$fz_4               # 50e
        fnms    $disc_14,$ly_12,$ly_12,$disc_14         # 51e

        fnms    $lz_11,$b_18,$dz_11,$fz_4               # 52e
        fnms    $disc_10,$ly_3,$ly_3,$disc_10           # 53e

        fnms    $lz,$b_21,$dz_12,$fz_4                  # 54e
        fnms    $disc_17,$ly_13,$ly_13,$disc_17         # 55e

        fnms    $disc_6,$lz_9,$lz_9,$disc_21            # 56e
        fnms    $disc_14,$lz_10,$lz_10,$disc_14         # 57e

        fnms    $disc_10,$lz_11,$lz_11,$disc_10         # 59e
        fnms    $disc_17,$lz,$lz,$disc_17               # 61e

        frsqest $y_10,$disc_6                           # 62o
        frsqest $y_7,$disc_14                           # 63o

        frsqest $y_12,$disc_10                          # 65o
        fi      $y_10,$disc_6,$y_10                     # 66e

        fi      $y_7,$disc_14,$y_7                      # 67e
        frsqest $y_13,$disc_17                          # 67o

        fi      $y_12,$disc_10,$y_12                    # 69e
        fi      $y_13,$disc_17,$y_13                    # 71e

        fm      $s_15,$disc_6,$y_10                     # 73e
        fm      $s_10,$disc_14,$y_7                     # 74e

        fm      $y_10,$y_10,$k_half                     # 75e
        fm      $s_16,$disc_10,$y_12                    # 76e

        fm      $y_7,$y_7,$k_half                       # 77e
        fm      $s_11,$disc_17,$y_13                    # 78e

        fnms    $e_13,$s_15,$s_15,$disc_6               # 79e
        fnms    $e_7,$s_10,$s_10,$disc_14               # 80e

        fm      $y_12,$y_12,$k_half                     # 81e
        fnms    $e_14,$s_16,$s_16,$disc_10              # 82e

        fm      $y_13,$y_13,$k_half                     # 83e
        fnms    $e_15,$s_11,$s_11,$disc_17              # 84e

        fma     $s_15,$e_13,$y_10,$s_15                 # 85e
        fma     $s_10,$e_7,$y_7,$s_10                   # 86e

        fma     $s_16,$e_14,$y_12,$s_16                 # 88e
        fma     $s_11,$e_15,$y_13,$s_11                 # 90e

        fnms    $e_13,$s_15,$s_15,$disc_6               # 91e
        fnms    $e_7,$s_10,$s_10,$disc_14               # 92e

        fnms    $e_14,$s_16,$s_16,$disc_10              # 94e
        fnms    $e_15,$s_11,$s_11,$disc_17              # 96e

        fma     $s_17,$e_13,$y_10,$s_15                 # 97e
        fma     $s_13,$e_7,$y_7,$s_10                   # 98e

        fma     $s_18,$e_14,$y_12,$s_16                 # 100e
        fma     $s_19,$e_15,$y_13,$s_11                 # 102e

        fs      $t_6,$b,$s_17                           # 103e
        fs      $t_7,$b_20,$s_13                        # 104e

        fs      $t_8,$b_18,$s_18                        # 106e
        fs      $t_9,$b_21,$s_19                        # 108e

        clgt    $hit_5,$t_best_10,$t_6                  # 109e
        clgt    $hit_6,$t_best_6,$t_7                   # 110e

        andc    $hit_7,$hit_5,$disc_6                   # 111e
        clgt    $hit_5,$t_best_11,$t_8                  # 112e

        andc    $hit_2,$hit_6,$disc_14                  # 113e
        rotqbii $hit_7,$hit_7,1                         # 113o

        clgt    $hit_6,$t_best_12,$t_9                  # 114e
        lnop                                            # 114o pairing

        andc    $hit_3,$hit_5,$disc_10                  # 115e
        rotqbii $hit_2,$hit_2,1                         # 115o

        andc    $hit_8,$hit_6,$disc_17                  # 116e
        rotqbii $hit_3,$hit_3,1                         # 117o

        rotqbii $hit_8,$hit_8,1                         # 118o
        gb      $hit_7,$hit_7                           # 119o

        gb      $hit_2,$hit_2                           # 120o
        gb      $hit_3,$hit_3                           # 121o

        gb      $hit_8,$hit_8                           # 122o
        shlqbii $hit_7,$hit_7,4                         # 123o

        shlqbii $hit_2,$hit_2,4                         # 124o
        shlqbii $hit_3,$hit_3,4                         # 125o

        shlqbii $hit_8,$hit_8,4                         # 126o
        lqx     $merge_7,$a_merges,$hit_7               # 127o

        lqx     $merge_4,$a_merges,$hit_2               # 128o
        lqx     $merge_2,$a_merges,$hit_3               # 129o

        lqx     $merge_8,$a_merges,$hit_8               # 130o
        shufb   $t_best,$t_best_10,$t_6,$merge_7        # 133o

        shufb   $nearest,$nearest_10,$object,$merge_7   # 134o
        shufb   $t_best_13,$t_best_6,$t_7,$merge_4      # 135o

        shufb   $nearest_14,$nearest_11,$object,$merge_4 # 136o
        shufb   $t_best_14,$t_best_11,$t_8,$merge_2     # 137o

        shufb   $nearest_15,$nearest_12,$object,$merge_2 # 138o
        shufb   $t_best_15,$t_best_12,$t_9,$merge_8     # 139o

        shufb   $nearest_16,$nearest_13,$object,$merge_8 # 140o
        stqd    $t_best,192($a_packet)                  # 141o

        stqd    $nearest,256($a_packet)                 # 142o
        stqd    $t_best_13,208($a_packet)               # 143o

        stqd    $nearest_14,272($a_packet)              # 144o
        stqd    $t_best_14,224($a_packet)               # 145o

        stqd    $nearest_15,288($a_packet)              # 146o
        stqd    $t_best_15,240($a_packet)               # 147o

        stqd    $nearest_16,304($a_packet)              # 148o
        brnz    $count,next_pair_short                  # 149o

        nop     $127                                    # 150e pairing
        bi      $lr                                     # 150o
endfunction isect_pairs_newton2_r16
