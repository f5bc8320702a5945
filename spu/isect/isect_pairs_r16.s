# isect_pairs_r16   nearest entry of packets' eye rays into spheres, pair by pair
#   C       void isect_pairs_r16(const struct pair *, int count);
#   In      $3 pairs, $4 count (0 is none); pointers 16-aligned
#   Out     the pairs' packets: t, object, where an entry is nearer than what was there
#   Uses    $2-$69, $79   Saves  -   Stack  0   Calls  -
#   Domain  |d| = 1 within 4 ulp; radius > 0; centre and radius below 2^62
#   Error   12 ulp of t, eye 1.5 to 30 radii from the centre, ray within 0.995 r of it
#   Twin    oracle/src/twin/sphere/perpendicular.rs
#
# The steps are those of sphere_tmpl.inc. An opaque sphere has no inside: only the entry counts, and
# behind the eye it is none.
# Scheduled by spu schedule from isect_pairs_r16.s

        .include "work_unit.inc"
        .include "macros.inc"
        .include "sphere_tmpl.inc"
        .include "sphere_perpendicular.inc"

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
        .set    t,38
        .set    hit,39
        .set    merge,40

        merges_table

function isect_pairs_r16
        .set    count_2,79
        .set    a_pair_2,2
        .set    object_2,5
        .set    object_3,21
        .set    a_packet_2,2
        .set    quad_2,25
        .set    a_packet_3,24
        .set    quad_3,6
        .set    dx_2,29
        .set    dy_2,49
        .set    dz_2,51
        .set    fx_2,7
        .set    fy_2,50
        .set    dx_3,35
        .set    fz_2,8
        .set    b_2,43
        .set    dy_3,18
        .set    dz_3,44
        .set    radius2_2,27
        .set    dx_4,19
        .set    b_3,48
        .set    dx_5,23
        .set    dy_4,47
        .set    b_4,36
        .set    dy_5,46
        .set    dz_4,56
        .set    dz_5,28
        .set    b_5,45
        .set    dx_6,33
        .set    b_6,37
        .set    fx_3,32
        .set    b_7,52
        .set    dx_7,34
        .set    dy_6,39
        .set    fy_3,65
        .set    dy_7,66
        .set    dz_6,67
        .set    fz_3,43
        .set    dx_8,41
        .set    lx_2,29
        .set    b_8,40
        .set    ly_2,49
        .set    a_packet_4,9
        .set    lz_2,36
        .set    dx_9,31
        .set    lx_3,35
        .set    dy_8,68
        .set    ly_3,18
        .set    t_best_2,26
        .set    disc_2,29
        .set    dy_9,69
        .set    lz_3,44
        .set    radius2_3,25
        .set    b_9,58
        .set    dz_7,48
        .set    lx_4,30
        .set    disc_3,35
        .set    dz_8,52
        .set    b_10,42
        .set    a_packet_5,6
        .set    object_4,20
        .set    ly_4,47
        .set    a_packet_6,22
        .set    lx_5,5
        .set    t_best_3,19
        .set    disc_4,7
        .set    nearest_2,23
        .set    disc_5,2
        .set    b_11,18
        .set    b_12,57
        .set    nearest_3,38
        .set    nearest_4,61
        .set    ly_5,46
        .set    nearest_5,62
        .set    lz_4,49
        .set    t_best_4,64
        .set    object_5,63
        .set    disc_6,5
        .set    lz_5,8
        .set    y_2,27
        .set    disc_7,42
        .set    y_3,7
        .set    b_13,59
        .set    b_14,27
        .set    s_2,28
        .set    y_4,44
        .set    lx_6,33
        .set    s_3,46
        .set    disc_8,53
        .set    e_2,5
        .set    b_15,8
        .set    b_16,60
        .set    e_3,7
        .set    y_5,54
        .set    lx_7,34
        .set    disc_9,33
        .set    t_2,27
        .set    s_4,55
        .set    t_3,40
        .set    hit_2,5
        .set    ly_6,7
        .set    disc_10,8
        .set    s_5,51
        .set    disc_11,65
        .set    hit_3,52
        .set    hit_4,34
        .set    merge_2,35
        .set    t_best_5,7
        .set    nearest_6,8
        .set    t_best_6,18
        .set    lx_8,19
        .set    t_4,5
        .set    y_6,8
        .set    disc_12,18
        .set    hit_5,27
        .set    s_6,40
        .set    dy_10,7
        .set    e_4,8
        .set    hit_6,18
        .set    y_7,33
        .set    hit_7,55
        .set    merge_3,8
        .set    merge_4,18
        .set    nearest_7,51
        .set    t_best_7,8
        .set    y_8,2
        .set    lx_9,3
        .set    a_packet_7,4
        .set    t_best_8,6
        .set    b_17,14
        .set    b_18,3
        .set    object_6,13
        .set    a_packet_8,15
        .set    a_packet_9,5
        .set    object_7,16
        .set    t_5,7
        .set    nearest_8,20
        .set    y_9,20
        .set    y_10,6
        .set    hit_8,21
        .set    merge_5,22
        .set    e_5,6
        .set    e_6,21
        .set    nearest_9,24
        .set    t_best_9,10
        .set    nearest_10,22
        .set    t_6,3
        .set    hit_9,4
        .set    hit_10,2
        .set    nearest_11,2
        .set    dx_10,2
        .set    dx_11,5
        .set    dy_11,6
        .set    b_19,9
        .set    dz_9,23
        .set    dz_10,24
        .set    fz_4,28
        .set    dy_12,31
        .set    radius2_4,20
        .set    dz_11,32
        .set    t_best_10,33
        .set    t_best_11,34
        .set    b_20,35
        .set    t_best_12,36
        .set    t_best_13,37
        .set    nearest_12,39
        .set    nearest_13,40
        .set    nearest_14,41
        .set    lx_10,25
        .set    lx_11,2
        .set    ly_7,26
        .set    ly_8,6
        .set    disc_13,25
        .set    lz_6,27
        .set    lz_7,23
        .set    lz_8,6
        .set    lx_12,7
        .set    ly_9,21
        .set    disc_14,22
        .set    disc_15,6
        .set    y_11,24
        .set    y_12,21
        .set    s_7,23
        .set    s_8,24
        .set    s_9,25
        .set    y_13,26
        .set    e_7,20
        .set    s_10,27
        .set    t_7,8
        .set    t_8,9
        .set    hit_11,23
        .set    hit_12,24
        .set    t_9,20
        .set    merge_6,21
        .set    hit_13,22
        .set    merge_7,2
        .set    merge_8,5
        .set    hit_14,6
        .set    nearest_15,6
        .set    t_best_14,9
        .set    nearest_16,5
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
        lqd     $object_2,0($a_pair)                    # 16o

        ai      $count,$count,-1                        # 17e
        lnop                                            # 17o pairing

        ai      $a_pair,$a_pair_2,16                    # 18e
        lqd     $object_3,0($a_pair_2)                  # 18o

        ai      $count,$count,-1                        # 19e
        rotqbyi $a_packet_2,$object_2,4                 # 22o

        lqd     $quad_2,0($object_2)                    # 23o
        rotqbyi $a_packet_3,$object_3,4                 # 24o

        lqd     $quad_3,0($object_3)                    # 25o
        lqd     $dx_2,48($a_packet_2)                   # 26o

        lqd     $dy_2,112($a_packet_2)                  # 27o
        lqd     $dz_2,176($a_packet_2)                  # 28o

        shufb   $fx_2,$quad_2,$quad_2,$m_x              # 29o
        shufb   $fy_2,$quad_2,$quad_2,$m_y              # 30o

        lqd     $dx_3,0($a_packet_2)                    # 31o
        shufb   $fz_2,$quad_2,$quad_2,$m_z              # 32o

        fm      $b_2,$fx_2,$dx_2                        # 33e
        lqd     $dy_3,64($a_packet_2)                   # 33o

        lqd     $dz_3,128($a_packet_2)                  # 34o
        shufb   $radius2_2,$quad_2,$quad_2,$m_radius2   # 35o

        nop     $127                                    # 36e pairing
        lqd     $dx_4,16($a_packet_2)                   # 36o

        fm      $b_3,$fx_2,$dx_3                        # 37e
        lqd     $dx_5,32($a_packet_2)                   # 37o

        nop     $127                                    # 38e pairing
        lqd     $dy_4,80($a_packet_2)                   # 38o

        fma     $b_4,$fy_2,$dy_2,$b_2                   # 39e
        lqd     $dy_5,96($a_packet_2)                   # 39o

        lqd     $dz_4,144($a_packet_2)                  # 40o
        lqd     $dz_5,160($a_packet_2)                  # 41o

        fm      $b_5,$fx_2,$dx_4                        # 42e
        lqd     $dx_6,48($a_packet_3)                   # 42o

        fma     $b_6,$fy_2,$dy_3,$b_3                   # 43e
        shufb   $fx_3,$quad_3,$quad_3,$m_x              # 43o

        fm      $b_7,$fx_2,$dx_5                        # 44e
        lqd     $dx_7,0($a_packet_3)                    # 44o

        fma     $b_4,$fz_2,$dz_2,$b_4                   # 45e
        lqd     $dy_6,112($a_packet_3)                  # 45o

        shufb   $fy_3,$quad_3,$quad_3,$m_y              # 46o
        lqd     $dy_7,64($a_packet_3)                   # 47o

        fma     $b_5,$fy_2,$dy_4,$b_5                   # 48e
        lqd     $dz_6,176($a_packet_3)                  # 48o

        fma     $b_6,$fz_2,$dz_3,$b_6                   # 49e
        shufb   $fz_3,$quad_3,$quad_3,$m_z              # 49o

        fma     $b_7,$fy_2,$dy_5,$b_7                   # 50e
        lqd     $dx_8,32($a_packet_3)                   # 50o

        fnms    $lx_2,$b_4,$dx_2,$fx_2                  # 51e
        shlqbyi $b_8,$b_4,0                             # 51o copy

        fnms    $ly_2,$b_4,$dy_2,$fy_2                  # 52e
        shlqbyi $a_packet_4,$a_packet_2,0               # 52o copy

        fnms    $lz_2,$b_4,$dz_2,$fz_2                  # 53e
        lqd     $dx_9,16($a_packet_3)                   # 53o

        fma     $b_5,$fz_2,$dz_4,$b_5                   # 54e
        lqd     $dz_2,128($a_packet_3)                  # 54o

        fnms    $lx_3,$b_6,$dx_3,$fx_2                  # 55e
        lqd     $dy_8,96($a_packet_3)                   # 55o

        fnms    $ly_3,$b_6,$dy_3,$fy_2                  # 56e
        lqd     $t_best_2,240($a_packet_4)              # 56o

        fnms    $disc_2,$lx_2,$lx_2,$radius2_2          # 57e
        lqd     $dy_9,80($a_packet_3)                   # 57o

        fnms    $lz_3,$b_6,$dz_3,$fz_2                  # 58e
        shufb   $radius2_3,$quad_3,$quad_3,$m_radius2   # 58o

        fma     $b_9,$fz_2,$dz_5,$b_7                   # 59e
        lqd     $dz_7,160($a_packet_3)                  # 59o

        fnms    $lx_4,$b_5,$dx_4,$fx_2                  # 60e
        shlqbyi $b_6,$b_6,0                             # 60o copy

        fnms    $disc_3,$lx_3,$lx_3,$radius2_2          # 61e
        lqd     $dz_8,144($a_packet_3)                  # 61o

        fm      $b_10,$fx_3,$dx_6                       # 62e
        shlqbyi $a_packet_5,$a_packet_2,0               # 62o copy

        fnms    $disc_2,$ly_2,$ly_2,$disc_2             # 63e
        shufb   $object_4,$object_2,$object_2,$m_x      # 63o

        fnms    $ly_4,$b_5,$dy_4,$fy_2                  # 64e
        shlqbyi $a_packet_6,$a_packet_2,0               # 64o copy

        fnms    $lx_5,$b_9,$dx_5,$fx_2                  # 65e
        lqd     $t_best_3,192($a_packet_2)              # 65o

        fnms    $disc_4,$lx_4,$lx_4,$radius2_2          # 66e
        lqd     $nearest_2,256($a_packet_2)             # 66o

        fnms    $disc_5,$ly_3,$ly_3,$disc_3             # 67e
        shlqbyi $b,$b_5,0                               # 67o copy

        fm      $b_11,$fx_3,$dx_7                       # 68e
        shlqbyi $b_12,$b_9,0                            # 68o copy

        fnms    $disc_2,$lz_2,$lz_2,$disc_2             # 69e
        lqd     $nearest_3,304($a_packet_4)             # 69o

        fma     $b_4,$fy_3,$dy_6,$b_10                  # 70e
        lqd     $nearest_4,272($a_packet_4)             # 70o

        fnms    $ly_5,$b_9,$dy_5,$fy_2                  # 71e
        lqd     $nearest_5,288($a_packet_4)             # 71o

        fnms    $lz_4,$b_5,$dz_4,$fz_2                  # 72e
        lqd     $t_best_4,208($a_packet_4)              # 72o

        fnms    $disc_5,$lz_3,$lz_3,$disc_5             # 73e
        shlqbyi $object_5,$object_4,0                   # 73o copy

        fnms    $disc_6,$lx_5,$lx_5,$radius2_2          # 74e
        lnop                                            # 74o pairing

        fnms    $disc_4,$ly_4,$ly_4,$disc_4             # 75e
        frsqest $y,$disc_2                              # 75o

        fma     $b_11,$fy_3,$dy_7,$b_11                 # 76e
        fma     $b_4,$fz_3,$dz_6,$b_4                   # 77e

        fnms    $lz_5,$b_9,$dz_5,$fz_2                  # 78e
        lnop                                            # 78o pairing

        fi      $y,$disc_2,$y                           # 79e
        frsqest $y_2,$disc_5                            # 79o

        fnms    $disc_6,$ly_5,$ly_5,$disc_6             # 81e
        fnms    $disc_7,$lz_4,$lz_4,$disc_4             # 82e

        fi      $y_3,$disc_5,$y_2                       # 83e
        shlqbyi $b_13,$b_4,0                            # 83o copy

        fm      $b_14,$fx_3,$dx_8                       # 85e
        fm      $s_2,$disc_2,$y                         # 86e

        fm      $b_5,$fx_3,$dx_9                        # 87e
        lnop                                            # 87o pairing

        fma     $b_11,$fz_3,$dz_2,$b_11                 # 88e
        frsqest $y_4,$disc_7                            # 88o

        fnms    $lx_6,$b_4,$dx_6,$fx_3                  # 89e
        fm      $s_3,$disc_5,$y_3                       # 90e

        fnms    $disc_8,$lz_5,$lz_5,$disc_6             # 91e
        fnms    $e_2,$s_2,$y,$k_one                     # 92e

        fma     $b_15,$fy_3,$dy_8,$b_14                 # 93e
        lnop                                            # 93o pairing

        fi      $y,$disc_7,$y_4                         # 94e
        shlqbyi $b_16,$b_11,0                           # 94o copy

        fnms    $e_3,$s_3,$y_3,$k_one                   # 96e
        lnop                                            # 96o pairing

        fma     $b_5,$fy_3,$dy_9,$b_5                   # 97e
        frsqest $y_5,$disc_8                            # 97o

        fma     $e_2,$e_2,$half,$whole                  # 98e
        fnms    $ly_2,$b_4,$dy_6,$fy_3                  # 99e

        fnms    $lx_7,$b_11,$dx_7,$fx_3                 # 100e
        fnms    $disc_9,$lx_6,$lx_6,$radius2_3          # 101e

        fma     $e_3,$e_3,$half,$whole                  # 102e
        fma     $b_9,$fz_3,$dz_7,$b_15                  # 103e

        fnms    $t_2,$s_2,$e_2,$b_8                     # 104e
        fi      $y_5,$disc_8,$y_5                       # 105e

        fm      $s_4,$disc_7,$y                         # 107e
        fnms    $t_3,$s_3,$e_3,$b_6                     # 108e

        fma     $b_5,$fz_3,$dz_8,$b_5                   # 109e
        clgt    $hit_2,$t_best_2,$t_2                   # 110e

        fnms    $ly_6,$b_11,$dy_7,$fy_3                 # 111e
        andc    $hit_2,$hit_2,$disc_2                   # 112e

        fnms    $lz_2,$b_4,$dz_6,$fz_3                  # 113e
        lnop                                            # 113o pairing

        fnms    $disc_10,$lx_7,$lx_7,$radius2_3         # 114e
        rotqbii $hit_2,$hit_2,1                         # 114o

        fnms    $disc_2,$ly_2,$ly_2,$disc_9             # 115e
        hbrr    next_pair_back,next_pair                # 115o hint

        fnms    $lz_3,$b_11,$dz_2,$fz_3                 # 116e
        fnms    $ly_5,$b_9,$dy_8,$fy_3                  # 117e

        fnms    $lz_4,$b_5,$dz_8,$fz_3                  # 118e
        gb      $hit,$hit_2                             # 118o

        fm      $s_5,$disc_8,$y_5                       # 119e
        fnms    $e_2,$s_4,$y,$k_one                     # 120e

        fnms    $ly_4,$b_5,$dy_9,$fy_3                  # 121e
        lnop                                            # 121o pairing

        fnms    $disc_4,$ly_6,$ly_6,$disc_10            # 122e
        shlqbii $hit,$hit,4                             # 122o

        fnms    $disc_11,$lz_2,$lz_2,$disc_2            # 123e
        clgt    $hit_3,$t_best_3,$t_3                   # 124e

        andc    $hit_4,$hit_3,$disc_5                   # 126e
        lqx     $merge_2,$a_merges,$hit                 # 126o

next_pair:
            rotmai  $hit,$hit_4,-31                     # 0e
            shlqbyi $a_packet_2,$a_packet_5,0           # 0o copy

            fnms    $e,$s_5,$y_5,$k_one                 # 1e
            lqd     $t_best,224($a_packet_4)            # 1o

            fma     $e_2,$e_2,$half,$whole              # 2e
            shlqbyi $a_packet_5,$a_packet_3,0           # 2o copy

            fnms    $lx,$b_5,$dx_9,$fx_3                # 3e
            shufb   $nearest,$nearest_3,$object_5,$merge_2 # 3o

            fnms    $disc,$lz_3,$lz_3,$disc_4           # 4e
            shufb   $t_best_5,$t_best_2,$t_2,$merge_2   # 4o

            selb    $nearest_6,$nearest_2,$object_4,$hit # 5e
            shlqbyi $a_packet_4,$a_packet_3,0           # 5o copy

            selb    $t_best_6,$t_best_3,$t_3,$hit       # 6e
            frsqest $y,$disc_11                         # 6o

            fnms    $lx_8,$b_9,$dx_8,$fx_3              # 7e
            shufb   $object_4,$object_3,$object_3,$m_x  # 7o

            fma     $e,$e,$half,$whole                  # 8e
            stqd    $nearest_6,256($a_packet_6)         # 8o

            fnms    $lz,$b_9,$dz_7,$fz_3                # 9e
            stqd    $nearest,304($a_packet_2)           # 9o

            fi      $y,$disc_11,$y                      # 10e
        lqd     $object_3,0($a_pair)                    # 10o

        ai      $a_pair,$a_pair,16                      # 11e
            stqd    $t_best_5,240($a_packet_2)          # 11o

            fnms    $disc_4,$lx,$lx,$radius2_3          # 12e
            stqd    $t_best_6,192($a_packet_6)          # 12o

            fnms    $t,$s_4,$e_2,$b                     # 13e
            shlqbyi $a_packet_6,$a_packet_3,0           # 13o copy

            fnms    $t_4,$s_5,$e,$b_12                  # 14e
            frsqest $y_6,$disc                          # 14o

            fnms    $disc_12,$lx_8,$lx_8,$radius2_3     # 15e
            lqd     $t_best_3,192($a_packet_3)          # 15o

            nop     $127                                # 16e pairing
            lqd     $nearest_2,256($a_packet_3)         # 16o

            fm      $s,$disc_11,$y                      # 17e
        rotqbyi $a_packet_3,$object_3,4                 # 17o

            fi      $y_6,$disc,$y_6                     # 18e
        lqd     $quad_2,0($object_3)                    # 18o

            clgt    $hit,$t_best_4,$t                   # 19e
            lqd     $t_best_2,240($a_packet_4)          # 19o

            clgt    $hit_5,$t_best,$t_4                 # 20e
            shlqbyi $b,$b_5,0                           # 20o copy

            fnms    $disc_4,$ly_4,$ly_4,$disc_4         # 21e
            lnop                                        # 21o pairing

            andc    $hit_5,$hit_5,$disc_8               # 22e
        lqd     $dx_2,48($a_packet_3)                   # 22o

            fnms    $e,$s,$y,$k_one                     # 23e
        lqd     $dx_9,16($a_packet_3)                   # 23o

            fnms    $disc_12,$ly_5,$ly_5,$disc_12       # 24e
        shufb   $fx_3,$quad_2,$quad_2,$m_x              # 24o

            andc    $hit,$hit,$disc_7                   # 25e
        lqd     $dx_3,0($a_packet_3)                    # 25o

            fm      $s_6,$disc,$y_6                     # 26e
        lqd     $dx_8,32($a_packet_3)                   # 26o

            fnms    $disc_7,$lz_4,$lz_4,$disc_4         # 27e
        lqd     $dy_10,64($a_packet_3)                  # 27o

        fm      $b_2,$fx_3,$dx_2                        # 28e
        lqd     $dz_3,128($a_packet_3)                  # 28o

        fm      $b_5,$fx_3,$dx_9                        # 29e
        lqd     $dy_5,96($a_packet_3)                   # 29o

            fma     $e,$e,$half,$whole                  # 30e
        lqd     $dy_4,80($a_packet_3)                   # 30o

        fm      $b_3,$fx_3,$dx_3                        # 31e
        lqd     $dy_2,112($a_packet_3)                  # 31o

            fnms    $e_4,$s_6,$y_6,$k_one               # 32e
        shufb   $fy_2,$quad_2,$quad_2,$m_y              # 32o

        ai      $count,$count,-1                        # 33e
        lqd     $dz_2,176($a_packet_3)                  # 33o

        fm      $b_7,$fx_3,$dx_8                        # 34e
            rotqbii $hit,$hit,1                         # 34o

            fnms    $disc_8,$lz,$lz,$disc_12            # 35e
            rotqbii $hit_6,$hit_5,1                     # 35o

            fnms    $t_2,$s,$e,$b_13                    # 36e
            frsqest $y_7,$disc_7                        # 36o

        fma     $b_4,$fy_2,$dy_2,$b_2                   # 37e
        shufb   $fz_3,$quad_2,$quad_2,$m_z              # 37o

        fma     $b_6,$fy_2,$dy_10,$b_3                  # 38e
        lqd     $dz_7,160($a_packet_3)                  # 38o

            fma     $e_4,$e_4,$half,$whole              # 39e
            gb      $hit,$hit                           # 39o

        fma     $b_5,$fy_2,$dy_4,$b_5                   # 40e
            gb      $hit_6,$hit_6                       # 40o

        fma     $b_7,$fy_2,$dy_5,$b_7                   # 41e
            frsqest $y_5,$disc_8                        # 41o

            fi      $y_7,$disc_7,$y_7                   # 42e
        shufb   $radius2_3,$quad_2,$quad_2,$m_radius2   # 42o

            clgt    $hit_7,$t_best_2,$t_2               # 43e
        lqd     $dz_4,144($a_packet_3)                  # 43o

        fma     $b_4,$fz_3,$dz_2,$b_4                   # 44e
            shlqbii $hit,$hit,4                         # 44o

            andc    $hit_7,$hit_7,$disc_11              # 45e
            shlqbii $hit_6,$hit_6,4                     # 45o

        fma     $b_6,$fz_3,$dz_3,$b_6                   # 46e
            shlqbyi $b_12,$b_9,0                        # 46o copy

        fma     $b_9,$fz_3,$dz_7,$b_7                   # 47e
            rotqbii $hit_3,$hit_7,1                     # 47o

            fnms    $t_3,$s_6,$e_4,$b_16                # 48e
            lqx     $merge_3,$a_merges,$hit             # 48o

            fm      $s_4,$disc_7,$y_7                   # 49e
            lnop                                        # 49o pairing

        fnms    $lx_2,$b_4,$dx_2,$fx_3                  # 50e
        shlqbyi $b_13,$b_4,0                            # 50o copy

        fma     $b_5,$fz_3,$dz_4,$b_5                   # 51e
            gb      $hit,$hit_3                         # 51o

        fnms    $ly_6,$b_6,$dy_10,$fy_2                 # 52e
            lqx     $merge_4,$a_merges,$hit_6           # 52o

        fnms    $ly_2,$b_4,$dy_2,$fy_2                  # 53e
        shlqbyi $b_16,$b_6,0                            # 53o copy

        fnms    $lz_2,$b_4,$dz_2,$fz_3                  # 54e
            shufb   $nearest_7,$nearest_4,$object_5,$merge_3 # 54o

            clgt    $hit_3,$t_best_3,$t_3               # 55e
            shlqbii $hit,$hit,4                         # 55o

        fnms    $lx_3,$b_6,$dx_3,$fx_3                  # 56e
            shufb   $t_best_7,$t_best_4,$t,$merge_3     # 56o

        fnms    $disc_2,$lx_2,$lx_2,$radius2_3          # 57e
            lqd     $nearest_3,304($a_packet_4)         # 57o

            fi      $y_5,$disc_8,$y_5                   # 58e
            stqd    $nearest_7,272($a_packet_2)         # 58o

            andc    $hit_4,$hit_3,$disc                 # 59e
            shufb   $nearest_7,$nearest_5,$object_5,$merge_4 # 59o

        fnms    $lz_3,$b_6,$dz_3,$fz_3                  # 60e
            lqd     $nearest_4,272($a_packet_4)         # 60o

        fnms    $ly_5,$b_9,$dy_5,$fy_2                  # 61e
            stqd    $t_best_7,208($a_packet_2)          # 61o

        fnms    $disc_10,$lx_3,$lx_3,$radius2_3         # 62e
            lqx     $merge_2,$a_merges,$hit             # 62o

        fnms    $disc_2,$ly_2,$ly_2,$disc_2             # 63e
            shufb   $t_best,$t_best,$t_4,$merge_4       # 63o

        fnms    $lz_4,$b_5,$dz_4,$fz_3                  # 64e
            stqd    $nearest_7,288($a_packet_2)         # 64o

            fm      $s_5,$disc_8,$y_5                   # 65e
            lqd     $nearest_5,288($a_packet_4)         # 65o

            fnms    $e_2,$s_4,$y_7,$k_one               # 66e
            shlqbyi $object_5,$object_4,0               # 66o copy

        fnms    $ly_4,$b_5,$dy_4,$fy_2                  # 67e
            lqd     $t_best_4,208($a_packet_4)          # 67o

        fnms    $disc_4,$ly_6,$ly_6,$disc_10            # 68e
            stqd    $t_best,224($a_packet_2)            # 68o

        fnms    $disc_11,$lz_2,$lz_2,$disc_2            # 69e
next_pair_back:
        brnz    $count,next_pair                        # 69o

next_pair_drain:
        fnms    $lx,$b_5,$dx_9,$fx_3                    # 0e
        frsqest $y_8,$disc_11                           # 0o

        fnms    $lx_9,$b_9,$dx_8,$fx_3                  # 1e
        lqd     $t_best,224($a_packet_4)                # 1o

        fnms    $e,$s_5,$y_5,$k_one                     # 2e
        shufb   $nearest,$nearest_3,$object_5,$merge_2  # 2o

        fma     $e_2,$e_2,$half,$whole                  # 3e
        shlqbyi $a_packet_7,$a_packet_5,0               # 3o copy

        fi      $y_8,$disc_11,$y_8                      # 4e
        shufb   $t_best_8,$t_best_2,$t_2,$merge_2       # 4o

        rotmai  $hit,$hit_4,-31                         # 5e
        shlqbyi $a_packet_4,$a_packet_3,0               # 5o copy

        fnms    $disc_10,$lx,$lx,$radius2_3             # 6e
        shlqbyi $b_17,$b_5,0                            # 6o copy

        fnms    $disc_12,$lx_9,$lx_9,$radius2_3         # 7e
        shlqbyi $b_18,$b_9,0                            # 7o copy

        fnms    $lz,$b_9,$dz_7,$fz_3                    # 8e
        shufb   $object_6,$object_3,$object_3,$m_x      # 8o

        fma     $e,$e,$half,$whole                      # 9e
        shlqbyi $a_packet_8,$a_packet_3,0               # 9o copy

        fnms    $t,$s_4,$e_2,$b                         # 10e
        shlqbyi $a_packet_9,$a_packet_3,0               # 10o copy

        fm      $s,$disc_11,$y_8                        # 11e
        hbr     isect_pairs_r16_return,$lr              # 11o hint

        fnms    $disc_10,$ly_4,$ly_4,$disc_10           # 12e
        shlqbyi $object_7,$object_6,0                   # 12o copy

        fnms    $disc_12,$ly_5,$ly_5,$disc_12           # 13e
        shlqbyi $a_packet_8,$a_packet_8,0               # 13o copy

        fnms    $disc,$lz_3,$lz_3,$disc_4               # 14e
        fnms    $t_5,$s_5,$e,$b_12                      # 15e

        selb    $nearest_8,$nearest_2,$object_4,$hit    # 16e
        fnms    $e,$s,$y_8,$k_one                       # 17e

        fnms    $disc_5,$lz_4,$lz_4,$disc_10            # 18e
        stqd    $nearest_8,256($a_packet_6)             # 18o

        fnms    $disc_10,$lz,$lz,$disc_12               # 19e
        stqd    $nearest,304($a_packet_7)               # 19o

        clgt    $hit_6,$t_best_4,$t                     # 20e
        frsqest $y_9,$disc                              # 20o

        selb    $t_best_3,$t_best_3,$t_3,$hit           # 21e
        stqd    $t_best_8,240($a_packet_7)              # 21o

        andc    $hit,$hit_6,$disc_7                     # 22e
        lnop                                            # 22o pairing

        fma     $e,$e,$half,$whole                      # 23e
        stqd    $t_best_3,192($a_packet_6)              # 23o

        clgt    $hit_5,$t_best,$t_5                     # 24e
        frsqest $y_7,$disc_5                            # 24o

        fi      $y_10,$disc,$y_9                        # 25e
        rotqbii $hit,$hit,1                             # 25o

        andc    $hit_5,$hit_5,$disc_8                   # 26e
        frsqest $y_5,$disc_10                           # 26o

        nop     $127                                    # 27e pairing
        lqd     $t_best_2,240($a_packet_4)              # 27o

        fi      $y_7,$disc_5,$y_7                       # 28e
        rotqbii $hit_6,$hit_5,1                         # 28o

        nop     $127                                    # 29e pairing
        gb      $hit,$hit                               # 29o

        fnms    $t_2,$s,$e,$b_13                        # 30e
        lqd     $nearest_2,256($a_packet_3)             # 30o

        fi      $y_5,$disc_10,$y_5                      # 31e
        lqd     $t_best_3,192($a_packet_3)              # 31o

        nop     $127                                    # 32e pairing
        gb      $hit_6,$hit_6                           # 32o

        fm      $s_6,$disc,$y_10                        # 33e
        shlqbii $hit,$hit,4                             # 33o

        lqd     $nearest_8,304($a_packet_4)             # 34o
        fm      $s_4,$disc_5,$y_7                       # 35e

        clgt    $hit_8,$t_best_2,$t_2                   # 36e
        shlqbii $hit_6,$hit_6,4                         # 36o

        lqx     $merge_5,$a_merges,$hit                 # 37o
        andc    $hit_8,$hit_8,$disc_11                  # 38e

        fm      $s_5,$disc_10,$y_5                      # 39e
        lnop                                            # 39o pairing

        fnms    $e_5,$s_6,$y_10,$k_one                  # 40e
        rotqbii $hit_3,$hit_8,1                         # 40o

        fnms    $e_6,$s_4,$y_7,$k_one                   # 41e
        lqx     $merge_4,$a_merges,$hit_6               # 41o

        shufb   $nearest_9,$nearest_4,$object_5,$merge_5 # 43o
        gb      $hit,$hit_3                             # 44o

        fnms    $e,$s_5,$y_5,$k_one                     # 45e
        shufb   $t_best_9,$t_best_4,$t,$merge_5         # 45o

        fma     $e_5,$e_5,$half,$whole                  # 46e
        lnop                                            # 46o pairing

        fma     $e_6,$e_6,$half,$whole                  # 47e
        stqd    $nearest_9,272($a_packet_7)             # 47o

        shlqbii $hit,$hit,4                             # 48o
        shufb   $nearest_10,$nearest_5,$object_5,$merge_4 # 49o

        nop     $127                                    # 50e pairing
        shufb   $t_best,$t_best,$t_5,$merge_4           # 50o

        fma     $e,$e,$half,$whole                      # 51e
        lqd     $nearest_4,272($a_packet_4)             # 51o

        fnms    $t_3,$s_6,$e_5,$b_16                    # 52e
        stqd    $t_best_9,208($a_packet_7)              # 52o

        fnms    $t,$s_4,$e_6,$b_17                      # 53e
        lqx     $merge_2,$a_merges,$hit                 # 53o

        stqd    $nearest_10,288($a_packet_7)            # 54o
        lqd     $nearest_5,288($a_packet_4)             # 55o

        nop     $127                                    # 56e pairing
        lqd     $t_best_4,208($a_packet_4)              # 56o

        fnms    $t_6,$s_5,$e,$b_18                      # 57e
        stqd    $t_best,224($a_packet_7)                # 57o

        clgt    $hit_3,$t_best_3,$t_3                   # 58e
        lqd     $t_best,224($a_packet_4)                # 58o

        nop     $127                                    # 59e pairing
        shufb   $nearest,$nearest_8,$object_7,$merge_2  # 59o

        andc    $hit_4,$hit_3,$disc                     # 60e
        shufb   $t_best_5,$t_best_2,$t_2,$merge_2       # 60o

        clgt    $hit,$t_best_4,$t                       # 62e
        rotmai  $hit_9,$hit_4,-31                       # 63e

        clgt    $hit_5,$t_best,$t_6                     # 64e
        andc    $hit,$hit,$disc_5                       # 65e

        andc    $hit_5,$hit_5,$disc_10                  # 66e
        lnop                                            # 66o pairing

        selb    $nearest_6,$nearest_2,$object_6,$hit_9  # 67e
        rotqbii $hit,$hit,1                             # 67o

        selb    $t_best_6,$t_best_3,$t_3,$hit_9         # 68e
        rotqbii $hit_10,$hit_5,1                        # 68o

        stqd    $nearest_6,256($a_packet_9)             # 69o
        stqd    $nearest,304($a_packet_8)               # 70o

        gb      $hit,$hit                               # 71o
        gb      $hit_10,$hit_10                         # 72o

        stqd    $t_best_5,240($a_packet_8)              # 73o
        stqd    $t_best_6,192($a_packet_9)              # 74o

        shlqbii $hit,$hit,4                             # 75o
        shlqbii $hit_6,$hit_10,4                        # 76o

        lqx     $merge_3,$a_merges,$hit                 # 79o
        lqx     $merge_4,$a_merges,$hit_6               # 80o

        shufb   $nearest_7,$nearest_4,$object_7,$merge_3 # 85o
        shufb   $t_best_7,$t_best_4,$t,$merge_3         # 86o

        shufb   $nearest_11,$nearest_5,$object_7,$merge_4 # 87o
        shufb   $t_best,$t_best,$t_6,$merge_4           # 88o

        stqd    $nearest_7,272($a_packet_8)             # 89o
        stqd    $t_best_7,208($a_packet_8)              # 90o

        stqd    $nearest_11,288($a_packet_8)            # 91o
        stqd    $t_best,224($a_packet_8)                # 92o

        nop     $127                                    # 93e pairing
isect_pairs_r16_return:
        bi      $lr                                     # 93o

next_pair_short:
        ai      $count,$count,-1                        # 0e
        lqd     $object,0($a_pair)                      # 0o

        ai      $a_pair,$a_pair,16                      # 1e
        rotqbyi $a_packet,$object,4                     # 6o

        lqd     $quad,0($object)                        # 7o
        shufb   $object,$object,$object,$m_x            # 8o

        lqd     $dx,16($a_packet)                       # 10o
        lqd     $dx_10,32($a_packet)                    # 11o

        lqd     $dx_11,48($a_packet)                    # 12o
        shufb   $fx,$quad,$quad,$m_x                    # 13o

        lqd     $dy,80($a_packet)                       # 14o
        lqd     $dy_11,96($a_packet)                    # 15o

        nop     $127                                    # 16e pairing
        lqd     $dy_10,112($a_packet)                   # 16o

        fm      $b,$fx,$dx                              # 17e
        shufb   $fy,$quad,$quad,$m_y                    # 17o

        fm      $b_15,$fx,$dx_10                        # 18e
        lqd     $dz,144($a_packet)                      # 18o

        fm      $b_19,$fx,$dx_11                        # 19e
        lqd     $dz_9,160($a_packet)                    # 19o

        lqd     $dz_10,176($a_packet)                   # 20o
        shufb   $fz_4,$quad,$quad,$m_z                  # 21o

        nop     $127                                    # 22e pairing
        lqd     $dx_2,0($a_packet)                      # 22o

        fma     $b,$fy,$dy,$b                           # 23e
        lqd     $dy_12,64($a_packet)                    # 23o

        fma     $b_15,$fy,$dy_11,$b_15                  # 24e
        shufb   $radius2_4,$quad,$quad,$m_radius2       # 24o

        fma     $b_19,$fy,$dy_10,$b_19                  # 25e
        lqd     $dz_11,128($a_packet)                   # 25o

        lqd     $t_best_10,208($a_packet)               # 26o
        lqd     $t_best_11,224($a_packet)               # 27o

        fm      $b_20,$fx,$dx_2                         # 28e
        lqd     $t_best_12,240($a_packet)               # 28o

        fma     $b,$fz_4,$dz,$b                         # 29e
        lqd     $t_best_13,192($a_packet)               # 29o

        fma     $b_15,$fz_4,$dz_9,$b_15                 # 30e
        lqd     $nearest_3,272($a_packet)               # 30o

        fma     $b_19,$fz_4,$dz_10,$b_19                # 31e
        lqd     $nearest_12,288($a_packet)              # 31o

        lqd     $nearest_13,304($a_packet)              # 32o
        lqd     $nearest_14,256($a_packet)              # 33o

        fma     $b_20,$fy,$dy_12,$b_20                  # 34e
        fnms    $lx_10,$b,$dx,$fx                       # 35e

        fnms    $lx_11,$b_15,$dx_10,$fx                 # 36e
        fnms    $lx_5,$b_19,$dx_11,$fx                  # 37e

        fnms    $ly_7,$b,$dy,$fy                        # 38e
        fnms    $ly_8,$b_15,$dy_11,$fy                  # 39e

        fnms    $ly_6,$b_19,$dy_10,$fy                  # 40e
        fnms    $disc_13,$lx_10,$lx_10,$radius2_4       # 41e

        fnms    $disc_5,$lx_11,$lx_11,$radius2_4        # 42e
        fnms    $disc_6,$lx_5,$lx_5,$radius2_4          # 43e

        fma     $b_20,$fz_4,$dz_11,$b_20                # 44e
        fnms    $lz_6,$b,$dz,$fz_4                      # 45e

        fnms    $lz_7,$b_15,$dz_9,$fz_4                 # 46e
        fnms    $disc_13,$ly_7,$ly_7,$disc_13           # 47e

        fnms    $disc_5,$ly_8,$ly_8,$disc_5             # 48e
        fnms    $lz_8,$b_19,$dz_10,$fz_4                # 49e

        fnms    $disc_6,$ly_6,$ly_6,$disc_6             # 50e
        fnms    $lx_12,$b_20,$dx_2,$fx                  # 51e

        fnms    $ly_9,$b_20,$dy_12,$fy                  # 52e
        fnms    $disc_14,$lz_6,$lz_6,$disc_13           # 53e

        fnms    $disc_5,$lz_7,$lz_7,$disc_5             # 54e
        fnms    $lz_7,$b_20,$dz_11,$fz_4                # 55e

        fnms    $disc_6,$lz_8,$lz_8,$disc_6             # 56e
        fnms    $disc_15,$lx_12,$lx_12,$radius2_4       # 57e

        frsqest $y_3,$disc_14                           # 59o
        frsqest $y_9,$disc_5                            # 60o

        frsqest $y_11,$disc_6                           # 62o
        fnms    $disc_15,$ly_9,$ly_9,$disc_15           # 63e

        fi      $y_3,$disc_14,$y_3                      # 64e
        fi      $y_9,$disc_5,$y_9                       # 65e

        fi      $y_12,$disc_6,$y_11                     # 66e
        fnms    $disc_15,$lz_7,$lz_7,$disc_15           # 69e

        fm      $s_7,$disc_14,$y_3                      # 71e
        fm      $s_8,$disc_5,$y_9                       # 72e

        fm      $s_9,$disc_6,$y_12                      # 73e
        frsqest $y_13,$disc_15                          # 75o

        fnms    $e_3,$s_7,$y_3,$k_one                   # 77e
        fnms    $e_7,$s_8,$y_9,$k_one                   # 78e

        fnms    $e_6,$s_9,$y_12,$k_one                  # 79e
        fi      $y_13,$disc_15,$y_13                    # 80e

        fma     $e_3,$e_3,$half,$whole                  # 83e
        fma     $e_7,$e_7,$half,$whole                  # 84e

        fma     $e_6,$e_6,$half,$whole                  # 85e
        fm      $s_10,$disc_15,$y_13                    # 87e

        fnms    $t_5,$s_7,$e_3,$b                       # 89e
        fnms    $t_7,$s_8,$e_7,$b_15                    # 90e

        fnms    $t_8,$s_9,$e_6,$b_19                    # 91e
        fnms    $e_7,$s_10,$y_13,$k_one                 # 93e

        clgt    $hit_8,$t_best_10,$t_5                  # 95e
        clgt    $hit_11,$t_best_11,$t_7                 # 96e

        clgt    $hit_12,$t_best_12,$t_8                 # 97e
        andc    $hit_8,$hit_8,$disc_14                  # 98e

        andc    $hit_10,$hit_11,$disc_5                 # 99e
        lnop                                            # 99o pairing

        andc    $hit_2,$hit_12,$disc_6                  # 100e
        rotqbii $hit_8,$hit_8,1                         # 100o

        fma     $e_7,$e_7,$half,$whole                  # 101e
        rotqbii $hit_10,$hit_10,1                       # 101o

        rotqbii $hit_2,$hit_2,1                         # 102o
        gb      $hit_8,$hit_8                           # 104o

        gb      $hit_10,$hit_10                         # 105o
        gb      $hit_2,$hit_2                           # 106o

        fnms    $t_9,$s_10,$e_7,$b_20                   # 107e
        shlqbii $hit_8,$hit_8,4                         # 108o

        shlqbii $hit_10,$hit_10,4                       # 109o
        shlqbii $hit_2,$hit_2,4                         # 110o

        nop     $127                                    # 111e pairing
        lqx     $merge_6,$a_merges,$hit_8               # 112o

        clgt    $hit_13,$t_best_13,$t_9                 # 113e
        lqx     $merge_7,$a_merges,$hit_10              # 113o

        lqx     $merge_8,$a_merges,$hit_2               # 114o
        andc    $hit_14,$hit_13,$disc_15                # 115e

        rotmai  $hit_14,$hit_14,-31                     # 117e
        shufb   $t_best,$t_best_10,$t_5,$merge_6        # 118o

        shufb   $nearest,$nearest_3,$object,$merge_6    # 119o
        shufb   $t_best_5,$t_best_11,$t_7,$merge_7      # 120o

        selb    $t_best_7,$t_best_13,$t_9,$hit_14       # 121e
        shufb   $nearest_11,$nearest_12,$object,$merge_7 # 121o

        selb    $nearest_15,$nearest_14,$object,$hit_14 # 122e
        shufb   $t_best_14,$t_best_12,$t_8,$merge_8     # 122o

        shufb   $nearest_16,$nearest_13,$object,$merge_8 # 123o
        stqd    $t_best_7,192($a_packet)                # 124o

        stqd    $nearest_15,256($a_packet)              # 125o
        stqd    $t_best,208($a_packet)                  # 126o

        stqd    $nearest,272($a_packet)                 # 127o
        stqd    $t_best_5,224($a_packet)                # 128o

        stqd    $nearest_11,288($a_packet)              # 129o
        stqd    $t_best_14,240($a_packet)               # 130o

        stqd    $nearest_16,304($a_packet)              # 131o
        brnz    $count,next_pair_short                  # 132o

        nop     $127                                    # 133e pairing
        bi      $lr                                     # 133o
endfunction isect_pairs_r16
