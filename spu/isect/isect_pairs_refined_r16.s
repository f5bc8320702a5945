# isect_pairs_refined_r16   nearest entry of packets' eye rays into spheres, to the last digits
#   C       void isect_pairs_refined_r16(const struct pair *, int count);
#   In      $3 pairs, $4 count (0 is none); pointers 16-aligned
#   Out     the pairs' packets: t, object, where an entry is nearer than what was there
#   Uses    $2-$79   Saves  -   Stack  0   Calls  -
#   Domain  |d| = 1 within 4 ulp; radius > 0; centre and radius below 2^62 and from 2^-38 on
#   Error   3.5 ulp of t, eye 2 to 1e6 radii from the centre, ray within 0.9 r of it; from 30 radii
#           on 2
#   Twin    oracle/src/twin/sphere/refined.rs
#
# The steps are those of sphere_tmpl.inc. An opaque sphere has no inside: only the entry counts, and
# behind the eye it is none.
# Scheduled by spu schedule from isect_pairs_refined_r16.s

        .include "work_unit.inc"
        .include "macros.inc"
        .include "sphere_tmpl.inc"
        .include "sphere_refined.inc"

        .set    a_pair,3
        .set    count,4
        # constants
        .set    k_one,10
        .set    k_two,11
        .set    k_scales,12
        .set    half,13
        .set    whole,14
        .set    m_x,15
        .set    m_y,16
        .set    m_z,17
        .set    m_radius2,18
        .set    a_merges,19
        # the pair
        .set    object,20
        .set    a_packet,21
        .set    quad,22
        .set    cx,23
        .set    cy,24
        .set    cz,25
        .set    fx,23                                   # c
        .set    fy,24
        .set    fz,25
        .set    radius2,26
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
        .set    rest,40
        .set    t,41
        .set    hit,42
        .set    merge,43

        merges_table
# Lengths halved, and the radius squared with them.
scales:
        .int    0x3f000000,0x3f000000,0x3f000000,0x3e800000

function isect_pairs_refined_r16
        .set    count_2,79
        .set    a_pair_2,2
        .set    object_2,2
        .set    quad_2,25
        .set    a_packet_2,5
        .set    a_packet_3,23
        .set    quad_3,6
        .set    object_3,77
        .set    dx_2,7
        .set    dy_2,8
        .set    dx_3,29
        .set    dx_4,9
        .set    dz_2,20
        .set    dx_5,35
        .set    dz_3,21
        .set    fy_2,27
        .set    fx_2,30
        .set    fz_2,26
        .set    dy_3,31
        .set    b_2,24
        .set    dz_4,32
        .set    b_3,34
        .set    dy_4,36
        .set    b_4,39
        .set    radius2_2,22
        .set    b_5,51
        .set    dz_5,37
        .set    dx_6,40
        .set    dx_7,25
        .set    fx_3,42
        .set    dx_8,47
        .set    b_6,33
        .set    dx_9,79
        .set    dy_5,54
        .set    dy_6,56
        .set    b_7,41
        .set    dy_7,43
        .set    b_8,38
        .set    dz_6,52
        .set    dz_7,58
        .set    b_9,62
        .set    fz_3,24
        .set    dy_8,50
        .set    b_10,49
        .set    dz_8,60
        .set    b_11,57
        .set    fy_3,78
        .set    lx_2,65
        .set    dz_9,55
        .set    ly_2,33
        .set    a_packet_4,44
        .set    lz_2,53
        .set    lx_3,46
        .set    b_12,67
        .set    ly_3,38
        .set    radius2_3,6
        .set    lx_4,59
        .set    t_best_2,45
        .set    disc_2,48
        .set    nearest_2,72
        .set    rest_2,7
        .set    nearest_3,66
        .set    lx_5,30
        .set    a_packet_5,74
        .set    rest_3,29
        .set    object_4,71
        .set    disc_3,5
        .set    disc_4,2
        .set    t_best_3,69
        .set    disc_5,46
        .set    t_best_4,75
        .set    nearest_4,61
        .set    ly_4,8
        .set    nearest_5,76
        .set    rest_4,28
        .set    b_13,48
        .set    ly_5,64
        .set    t_best_5,65
        .set    disc_6,27
        .set    b_14,46
        .set    disc_7,20
        .set    rest_5,9
        .set    lz_3,22
        .set    rest_6,73
        .set    disc_8,35
        .set    lz_4,27
        .set    rest_7,21
        .set    y_2,26
        .set    rest_8,32
        .set    disc_9,38
        .set    y_3,5
        .set    rest_9,44
        .set    disc_10,53
        .set    disc_11,26
        .set    y_4,2
        .set    b_15,36
        .set    s_2,8
        .set    y_5,9
        .set    disc_12,57
        .set    b_16,31
        .set    e_2,37
        .set    s_3,59
        .set    e_3,20
        .set    y_6,39
        .set    lx_6,5
        .set    e_4,2
        .set    lz_5,49
        .set    rest_10,8
        .set    lx_7,7
        .set    s_4,63
        .set    s_5,68
        .set    ly_6,27
        .set    rest_11,26
        .set    e_5,70
        .set    disc_13,21
        .set    ly_7,67
        .set    ly_8,47
        .set    disc_14,78
        .set    disc_15,8
        .set    lz_6,2
        .set    a_packet_6,6
        .set    disc_16,7
        .set    lz_7,8
        .set    disc_17,9
        .set    b_17,21
        .set    rest_12,22
        .set    rest_13,24
        .set    rest_14,27
        .set    dx_10,2
        .set    e_6,24
        .set    rest_15,25
        .set    t_2,7
        .set    s_6,45
        .set    y_7,47
        .set    t_3,40
        .set    hit_2,49
        .set    hit_3,36
        .set    hit_4,26
        .set    y_8,61
        .set    lx_8,49
        .set    merge_2,42
        .set    merge_3,36
        .set    merge_4,26
        .set    e_7,47
        .set    t_best_6,41
        .set    t_best_7,7
        .set    nearest_6,36
        .set    nearest_7,42
        .set    t_best_8,8
        .set    b_18,3
        .set    b_19,4
        .set    lz_8,5
        .set    b_20,7
        .set    a_packet_7,12
        .set    rest_16,2
        .set    object_5,15
        .set    e_8,16
        .set    e_9,17
        .set    rest_17,18
        .set    rest_18,5
        .set    rest_19,17
        .set    t_4,16
        .set    disc_18,22
        .set    s_7,23
        .set    y_9,24
        .set    t_5,2
        .set    e_10,10
        .set    t_best_9,13
        .set    hit_5,14
        .set    hit_6,9
        .set    t_6,3
        .set    t_best_10,10
        .set    hit_7,4
        .set    dy_9,5
        .set    dx_11,6
        .set    dz_10,8
        .set    dy_10,9
        .set    b_21,26
        .set    dy_11,30
        .set    dz_11,34
        .set    dz_12,35
        .set    t_best_11,36
        .set    t_best_12,37
        .set    t_best_13,38
        .set    t_best_14,39
        .set    nearest_8,40
        .set    nearest_9,41
        .set    nearest_10,43
        .set    lx_9,44
        .set    lx_10,45
        .set    ly_9,46
        .set    lz_9,48
        .set    disc_19,50
        .set    disc_20,44
        .set    lx_11,23
        .set    lz_10,45
        .set    disc_21,28
        .set    ly_10,5
        .set    rest_20,6
        .set    ly_11,24
        .set    disc_22,23
        .set    lz_11,28
        .set    disc_23,29
        .set    lz_12,6
        .set    y_10,22
        .set    disc_24,24
        .set    y_11,7
        .set    s_8,25
        .set    y_12,28
        .set    s_9,29
        .set    y_13,30
        .set    e_11,22
        .set    e_12,7
        .set    s_10,34
        .set    s_11,35
        .set    e_13,28
        .set    e_14,25
        .set    t_7,22
        .set    hit_8,7
        .set    hit_9,8
        .set    t_8,5
        .set    t_9,6
        .set    hit_10,23
        .set    hit_11,24
        .set    merge_5,7
        .set    merge_6,8
        .set    hit_12,2
        .set    merge_7,2
        .set    t_best_15,5
        .set    nearest_11,2
        nop     $127                                    # 0e pairing
        biz     $count,$lr                              # 0o

        ilhu    $m_x,1                                  # 1e
        lqa     $k_scales,scales                        # 1o

        ilhu    $m_y,0x405                              # 2e
        ilhu    $m_z,0x809                              # 3e

        ilhu    $m_radius2,0xc0d                        # 4e
        ilhu    $half,0x3f80                            # 5e

        ilhu    $whole,0x4000                           # 6e
        ilhu    $k_one,0x3f80                           # 7e

        ilhu    $k_two,0x4000                           # 8e
        clgti   $count_2,$count,2                       # 9e at least as many passes as overlap

        iohl    $m_x,515                                # 10e
        iohl    $m_y,0x607                              # 11e

        iohl    $m_z,0xa0b                              # 12e
        iohl    $m_radius2,0xe0f                        # 13e

        ila     $a_merges,merges                        # 14e
        iohl    $half,0                                 # 15e

        iohl    $whole,2                                # 16e
        iohl    $k_one,1                                # 17e

        iohl    $k_two,1                                # 18e
        brz     $count_2,next_pair_short                # 18o too few passes

        ai      $a_pair_2,$a_pair,16                    # 19e
        lqd     $object,0($a_pair)                      # 19o

        ai      $count,$count,-1                        # 20e
        lnop                                            # 20o pairing

        ai      $a_pair,$a_pair_2,16                    # 21e
        lqd     $object_2,0($a_pair_2)                  # 21o

        ai      $count,$count,-1                        # 22e
        lqd     $quad_2,0($object)                      # 25o

        rotqbyi $a_packet_2,$object,4                   # 26o
        rotqbyi $a_packet_3,$object_2,4                 # 27o

        lqd     $quad_3,0($object_2)                    # 28o
        shufb   $object_3,$object,$object,$m_x          # 29o

        nop     $127                                    # 30e pairing
        lqd     $dx_2,0($a_packet_2)                    # 30o

        fm      $quad,$quad_2,$k_scales                 # 31e
        lqd     $dy_2,64($a_packet_2)                   # 31o

        lqd     $dx_3,32($a_packet_2)                   # 32o
        lqd     $dx_4,48($a_packet_2)                   # 33o

        fm      $quad_3,$quad_3,$k_scales               # 34e
        lqd     $dz_2,128($a_packet_2)                  # 34o

        lqd     $dx_5,16($a_packet_2)                   # 35o
        lqd     $dz_3,160($a_packet_2)                  # 36o

        shufb   $fy_2,$quad,$quad,$m_y                  # 37o
        shufb   $fx_2,$quad,$quad,$m_x                  # 38o

        shufb   $fz_2,$quad,$quad,$m_z                  # 39o
        lqd     $dy,96($a_packet_2)                     # 40o

        nop     $127                                    # 41e pairing
        lqd     $dy_3,112($a_packet_2)                  # 41o

        fm      $b_2,$fx_2,$dx_2                        # 42e
        lqd     $dz_4,176($a_packet_2)                  # 42o

        fm      $b_3,$fx_2,$dx_3                        # 43e
        lqd     $dy_4,80($a_packet_2)                   # 43o

        fm      $b_4,$fx_2,$dx_5                        # 44e
        shufb   $radius2_2,$quad,$quad,$m_radius2       # 44o

        fm      $b_5,$fx_2,$dx_4                        # 45e
        lqd     $dz_5,144($a_packet_2)                  # 45o

        lqd     $dx_6,0($a_packet_3)                    # 46o
        lqd     $dx_7,48($a_packet_3)                   # 47o

        fma     $b_2,$fy_2,$dy_2,$b_2                   # 48e
        shufb   $fx_3,$quad_3,$quad_3,$m_x              # 48o

        fma     $b_3,$fy_2,$dy,$b_3                     # 49e
        lqd     $dx_8,16($a_packet_3)                   # 49o

        fma     $b_6,$fy_2,$dy_4,$b_4                   # 50e
        lqd     $dx_9,32($a_packet_3)                   # 50o

        fma     $b_5,$fy_2,$dy_3,$b_5                   # 51e
        lqd     $dy_5,80($a_packet_3)                   # 51o

        fm      $b_4,$fx_3,$dx_6                        # 52e
        lqd     $dy_6,112($a_packet_3)                  # 52o

        fm      $b_7,$fx_3,$dx_7                        # 53e
        lqd     $dy_7,96($a_packet_3)                   # 53o

        fma     $b_8,$fz_2,$dz_2,$b_2                   # 54e
        lqd     $dz_6,128($a_packet_3)                  # 54o

        fma     $b_3,$fz_2,$dz_3,$b_3                   # 55e
        lqd     $dz_7,144($a_packet_3)                  # 55o

        fma     $b_9,$fz_2,$dz_5,$b_6                   # 56e
        shufb   $fz_3,$quad_3,$quad_3,$m_z              # 56o

        fma     $b_5,$fz_2,$dz_4,$b_5                   # 57e
        lqd     $dy_8,64($a_packet_3)                   # 57o

        fm      $b_10,$fx_3,$dx_8                       # 58e
        lqd     $dz_8,176($a_packet_3)                  # 58o

        fm      $b_11,$fx_3,$dx_9                       # 59e
        shufb   $fy_3,$quad_3,$quad_3,$m_y              # 59o

        fnms    $lx_2,$b_8,$dx_2,$fx_2                  # 60e
        lqd     $dz_9,160($a_packet_3)                  # 60o

        fnms    $ly_2,$b_8,$dy_2,$fy_2                  # 61e
        shlqbyi $a_packet_4,$a_packet_2,0               # 61o copy

        fnms    $lz_2,$b_8,$dz_2,$fz_2                  # 62e
        shlqbyi $a_packet_2,$a_packet_2,0               # 62o copy

        fnms    $lx_3,$b_3,$dx_3,$fx_2                  # 63e
        shlqbyi $b_12,$b_8,0                            # 63o copy

        fnms    $ly_3,$b_3,$dy,$fy_2                    # 64e
        shufb   $radius2_3,$quad_3,$quad_3,$m_radius2   # 64o

        fnms    $lx_4,$b_5,$dx_4,$fx_2                  # 65e
        lqd     $t_best_2,192($a_packet_4)              # 65o

        fnms    $disc_2,$lx_2,$lx_2,$radius2_2          # 66e
        lqd     $nearest_2,304($a_packet_4)             # 66o

        fm      $rest_2,$lx_2,$dx_2                     # 67e
        lqd     $nearest_3,272($a_packet_4)             # 67o

        fnms    $lx_5,$b_9,$dx_5,$fx_2                  # 68e
        shlqbyi $a_packet_5,$a_packet_2,0               # 68o copy

        fm      $rest_3,$lx_3,$dx_3                     # 69e
        shlqbyi $object_4,$object_3,0                   # 69o copy

        fnms    $disc_3,$lx_3,$lx_3,$radius2_2          # 70e
        shufb   $object_3,$object_2,$object_2,$m_x      # 70o

        fnms    $disc_4,$lx_4,$lx_4,$radius2_2          # 71e
        lqd     $t_best_3,240($a_packet_4)              # 71o

        fnms    $disc_5,$ly_2,$ly_2,$disc_2             # 72e
        lqd     $t_best_4,208($a_packet_4)              # 72o

        fma     $rest_2,$ly_2,$dy_2,$rest_2             # 73e
        lqd     $nearest_4,256($a_packet_4)             # 73o

        fnms    $ly_4,$b_9,$dy_4,$fy_2                  # 74e
        lqd     $nearest_5,288($a_packet_4)             # 74o

        fma     $rest_4,$ly_3,$dy,$rest_3               # 75e
        shlqbyi $b_6,$b_3,0                             # 75o copy

        fnms    $disc_3,$ly_3,$ly_3,$disc_3             # 76e
        shlqbyi $b_13,$b_9,0                            # 76o copy

        fnms    $ly_5,$b_5,$dy_3,$fy_2                  # 77e
        lqd     $t_best_5,224($a_packet_4)              # 77o

        fnms    $disc_6,$lz_2,$lz_2,$disc_5             # 78e
        shlqbyi $b_14,$b_5,0                            # 78o copy

        fma     $rest_2,$lz_2,$dz_2,$rest_2             # 79e
        fnms    $disc_7,$lx_5,$lx_5,$radius2_2          # 80e

        fm      $rest_5,$lx_4,$dx_4                     # 81e
        fnms    $lz_3,$b_3,$dz_3,$fz_2                  # 82e

        fnms    $disc_4,$ly_5,$ly_5,$disc_4             # 83e
        fm      $rest_6,$lx_5,$dx_5                     # 84e

        fma     $disc_8,$rest_2,$rest_2,$disc_6         # 85e
        fnms    $lz_4,$b_5,$dz_4,$fz_2                  # 86e

        fma     $rest_5,$ly_5,$dy_3,$rest_5             # 87e
        fma     $rest_4,$lz_3,$dz_3,$rest_4             # 88e

        fnms    $disc_3,$lz_3,$lz_3,$disc_3             # 89e
        fma     $rest_7,$ly_4,$dy_4,$rest_6             # 90e

        fnms    $lz_3,$b_9,$dz_5,$fz_2                  # 91e
        frsqest $y_2,$disc_8                            # 91o

        fnms    $disc,$lz_4,$lz_4,$disc_4               # 92e
        fma     $rest_8,$lz_4,$dz_4,$rest_5             # 93e

        fnms    $disc_4,$ly_4,$ly_4,$disc_7             # 94e
        fma     $disc_9,$rest_4,$rest_4,$disc_3         # 95e

        fi      $y_3,$disc_8,$y_2                       # 96e
        fma     $rest_9,$lz_3,$dz_5,$rest_7             # 98e

        fma     $disc_10,$rest_8,$rest_8,$disc          # 99e
        fnms    $disc_11,$lz_3,$lz_3,$disc_4            # 100e

        fma     $b_3,$fy_3,$dy_7,$b_11                  # 101e
        frsqest $y_4,$disc_9                            # 101o

        fma     $b_15,$fy_3,$dy_5,$b_10                 # 102e
        fm      $s_2,$disc_8,$y_3                       # 103e

        fma     $b_5,$fy_3,$dy_6,$b_7                   # 104e
        lnop                                            # 104o pairing

        fi      $y_4,$disc_9,$y_4                       # 105e
        frsqest $y_5,$disc_10                           # 105o

        fma     $disc_12,$rest_9,$rest_9,$disc_11       # 107e
        fma     $b_16,$fy_3,$dy_8,$b_4                  # 108e

        fnms    $e_2,$s_2,$y_3,$k_one                   # 109e
        fma     $b_5,$fz_3,$dz_8,$b_5                   # 110e

        fma     $b_9,$fz_3,$dz_7,$b_15                  # 111e
        fm      $s_3,$disc_9,$y_4                       # 112e

        fma     $b_3,$fz_3,$dz_9,$b_3                   # 113e
        frsqest $y_3,$disc_12                           # 113o

        fma     $b_16,$fz_3,$dz_6,$b_16                 # 114e
        fma     $e_3,$e_2,$half,$whole                  # 115e

        fnms    $ly_5,$b_5,$dy_6,$fy_3                  # 116e
        fi      $y,$disc_12,$y_3                        # 117e

        fi      $y_6,$disc_10,$y_5                      # 118e
        fnms    $lx_6,$b_9,$dx_8,$fx_3                  # 120e

        fnms    $e_4,$s_3,$y_4,$k_one                   # 121e
        fnms    $lz_5,$b_9,$dz_7,$fz_3                  # 122e

        fnms    $rest_10,$s_2,$e_3,$rest_2              # 123e
        fnms    $lx_7,$b_16,$dx_6,$fx_3                 # 124e

        fm      $s_4,$disc_10,$y_6                      # 125e
        fnms    $lx_5,$b_5,$dx_7,$fx_3                  # 126e

        fm      $s_5,$disc_12,$y                        # 127e
        fnms    $ly_6,$b_16,$dy_8,$fy_3                 # 128e

        fma     $t,$b_12,$k_two,$rest_10                # 129e
        fm      $rest_11,$lx_7,$dx_6                    # 130e

        fnms    $e_5,$s_4,$y_6,$k_one                   # 131e
        fnms    $disc_13,$lx_7,$lx_7,$radius2_3         # 132e

        fm      $rest_6,$lx_6,$dx_8                     # 133e
        fnms    $disc,$lx_5,$lx_5,$radius2_3            # 134e

        fnms    $lx_7,$b_3,$dx_9,$fx_3                  # 135e
        fnms    $ly_7,$b_3,$dy_7,$fy_3                  # 136e

        fma     $e,$e_4,$half,$whole                    # 137e
        fnms    $ly_8,$b_9,$dy_5,$fy_3                  # 138e

        fnms    $disc_14,$lx_6,$lx_6,$radius2_3         # 139e
        clgt    $hit,$t_best_2,$t                       # 140e

        fm      $rest_3,$lx_7,$dx_9                     # 141e
        fnms    $disc_15,$lx_7,$lx_7,$radius2_3         # 142e

        andc    $hit,$hit,$disc_8                       # 143e
        lnop                                            # 143o pairing

next_pair:
            fm      $rest,$lx_5,$dx_7                   # 0e
            rotqbii $hit,$hit,1                         # 0o

            fnms    $lz,$b_5,$dz_8,$fz_3                # 1e
        lqd     $object,0($a_pair)                      # 1o

            fnms    $lz_6,$b_3,$dz_9,$fz_3              # 2e
            shlqbyi $a_packet_2,$a_packet_3,0           # 2o copy

            fnms    $disc,$ly_5,$ly_5,$disc             # 3e
            shlqbyi $a_packet_6,$a_packet_3,0           # 3o copy

            fnms    $disc_16,$ly_7,$ly_7,$disc_15       # 4e
            gb      $hit,$hit                           # 4o

            fnms    $lz_7,$b_16,$dz_6,$fz_3             # 5e
            lnop                                        # 5o pairing

            fnms    $disc_17,$ly_6,$ly_6,$disc_13       # 6e
            shlqbyi $b_17,$b_16,0                       # 6o copy

            fma     $rest_12,$ly_6,$dy_8,$rest_11       # 7e
        rotqbyi $a_packet_3,$object,4                   # 7o

            fma     $rest_13,$ly_7,$dy_7,$rest_3        # 8e
            shlqbii $hit,$hit,4                         # 8o

            fma     $rest,$ly_5,$dy_6,$rest             # 9e
        lqd     $quad_2,0($object)                      # 9o

            fnms    $disc_16,$lz_6,$lz_6,$disc_16       # 10e
            fnms    $disc_11,$ly_8,$ly_8,$disc_14       # 11e

            fnms    $disc_17,$lz_7,$lz_7,$disc_17       # 12e
            lqx     $merge,$a_merges,$hit               # 12o

            fnms    $rest_14,$s_3,$e,$rest_4            # 13e
            fma     $rest_10,$lz_7,$dz_6,$rest_12       # 14e

        fm      $quad,$quad_2,$k_scales                 # 15e
            fma     $rest_4,$lz_6,$dz_9,$rest_13        # 16e

            fnms    $e,$s_5,$y,$k_one                   # 17e
        lqd     $dx_10,0($a_packet_3)                   # 17o

            fma     $e_6,$e_5,$half,$whole              # 18e
            shufb   $t_best,$t_best_2,$t,$merge         # 18o

            fma     $rest_15,$ly_8,$dy_5,$rest_6        # 19e
            shufb   $nearest,$nearest_4,$object_4,$merge # 19o

            fma     $disc_17,$rest_10,$rest_10,$disc_17 # 20e
        lqd     $dx_3,32($a_packet_3)                   # 20o

            fma     $t,$b_6,$k_two,$rest_14             # 21e
        shufb   $fy_2,$quad,$quad,$m_y                  # 21o

            fnms    $disc,$lz,$lz,$disc                 # 22e
            stqd    $t_best,192($a_packet_5)            # 22o

            fnms    $disc_11,$lz_5,$lz_5,$disc_11       # 23e
            stqd    $nearest,256($a_packet_5)           # 23o

            fnms    $rest_13,$s_4,$e_6,$rest_8          # 24e
        shufb   $fx_2,$quad,$quad,$m_x                  # 24o

            fma     $rest_8,$lz,$dz_8,$rest             # 25e
            lnop                                        # 25o pairing

            fma     $e,$e,$half,$whole                  # 26e
            frsqest $y,$disc_17                         # 26o

            clgt    $hit,$t_best_5,$t                   # 27e
            lnop                                        # 27o pairing

        fm      $b_16,$fx_2,$dx_10                      # 28e
            shlqbyi $b_6,$b_3,0                         # 28o copy

        fm      $b_3,$fx_2,$dx_3                        # 29e
        lnop                                            # 29o pairing

            fi      $y,$disc_17,$y                      # 30e
        lqd     $dx_5,16($a_packet_3)                   # 30o

            andc    $hit,$hit,$disc_9                   # 31e
            lnop                                        # 31o pairing

            fma     $disc_9,$rest_4,$rest_4,$disc_16    # 32e
        lqd     $dy_7,96($a_packet_3)                   # 32o

            fnms    $rest,$s_5,$e,$rest_9               # 33e
            rotqbii $hit,$hit,1                         # 33o

            fma     $t_2,$b_14,$k_two,$rest_13          # 34e
        shufb   $fz_3,$quad,$quad,$m_z                  # 34o

            fma     $rest_9,$lz_5,$dz_7,$rest_15        # 35e
        lqd     $dx_7,48($a_packet_3)                   # 35o

        fm      $b_4,$fx_2,$dx_5                        # 36e
        shufb   $radius2_2,$quad,$quad,$m_radius2       # 36o

            fm      $s_6,$disc_17,$y                    # 37e
            shlqbyi $b_14,$b_5,0                        # 37o copy

        fma     $b_3,$fy_2,$dy_7,$b_3                   # 38e
            frsqest $y_7,$disc_9                        # 38o

            fma     $t_3,$b_13,$k_two,$rest             # 39e
            shlqbyi $b_13,$b_9,0                        # 39o copy

            clgt    $hit_2,$t_best_3,$t_2               # 40e
        lqd     $dy_8,64($a_packet_3)                   # 40o

        fm      $b_5,$fx_2,$dx_7                        # 41e
            gb      $hit,$hit                           # 41o

            fi      $y_7,$disc_9,$y_7                   # 42e
            lnop                                        # 42o pairing

            andc    $hit_2,$hit_2,$disc_10              # 43e
        lqd     $dz_6,128($a_packet_3)                  # 43o

            fma     $disc_10,$rest_8,$rest_8,$disc      # 44e
        lqd     $dy_5,80($a_packet_3)                   # 44o

            clgt    $hit_3,$t_best_4,$t_3               # 45e
        lqd     $dz_9,160($a_packet_3)                  # 45o

        fma     $b_16,$fy_2,$dy_8,$b_16                 # 46e
        lqd     $dy_6,112($a_packet_3)                  # 46o

            andc    $hit_3,$hit_3,$disc_12              # 47e
            rotqbii $hit_2,$hit_2,1                     # 47o

            fnms    $e_2,$s_6,$y,$k_one                 # 48e
            shlqbii $hit,$hit,4                         # 48o

            fma     $disc_12,$rest_9,$rest_9,$disc_11   # 49e
            rotqbii $hit_4,$hit_3,1                     # 49o

        fma     $b_15,$fy_2,$dy_5,$b_4                  # 50e
        lqd     $dz_7,144($a_packet_3)                  # 50o

        fma     $b_3,$fz_3,$dz_9,$b_3                   # 51e
            frsqest $y_6,$disc_10                       # 51o

            fm      $s_3,$disc_9,$y_7                   # 52e
            gb      $hit_2,$hit_2                       # 52o

        fma     $b_5,$fy_2,$dy_6,$b_5                   # 53e
            gb      $hit_4,$hit_4                       # 53o

        fma     $b_16,$fz_3,$dz_6,$b_16                 # 54e
        lqd     $dz_8,176($a_packet_3)                  # 54o

            fma     $e_2,$e_2,$half,$whole              # 55e
            frsqest $y_8,$disc_12                       # 55o

        fma     $b_9,$fz_3,$dz_7,$b_15                  # 56e
            shlqbii $hit_3,$hit_2,4                     # 56o

            fi      $y_6,$disc_10,$y_6                  # 57e
            shlqbii $hit_4,$hit_4,4                     # 57o

        ai      $a_pair,$a_pair,16                      # 58e
        lnop                                            # 58o pairing

        fnms    $lx_8,$b_3,$dx_3,$fx_2                  # 59e
            lqx     $merge_2,$a_merges,$hit             # 59o

        fma     $b_5,$fz_3,$dz_8,$b_5                   # 60e
            lqx     $merge_3,$a_merges,$hit_3           # 60o

            fnms    $rest_10,$s_6,$e_2,$rest_10         # 61e
        hbrr    next_pair_back,next_pair                # 61o hint

            fi      $y,$disc_12,$y_8                    # 62e
            lqx     $merge_4,$a_merges,$hit_4           # 62o

        ai      $count,$count,-1                        # 63e
            lqd     $t_best_2,192($a_packet_6)          # 63o

            fnms    $e_7,$s_3,$y_7,$k_one               # 64e
            lqd     $nearest_4,256($a_packet_6)         # 64o

            fm      $s_4,$disc_10,$y_6                  # 65e
            shufb   $t_best_6,$t_best_5,$t,$merge_2     # 65o

        fm      $rest_3,$lx_8,$dx_3                     # 66e
            shufb   $t_best_7,$t_best_3,$t_2,$merge_3   # 66o

        fnms    $ly_5,$b_5,$dy_6,$fy_2                  # 67e
            shufb   $nearest_6,$nearest_2,$object_4,$merge_3 # 67o

        fnms    $lx_2,$b_16,$dx_10,$fx_2                # 68e
            shufb   $nearest_3,$nearest_3,$object_4,$merge_4 # 68o

        fnms    $ly_7,$b_3,$dy_7,$fy_2                  # 69e
            shufb   $nearest_7,$nearest_5,$object_4,$merge_2 # 69o

            fm      $s_5,$disc_12,$y                    # 70e
            stqd    $t_best_7,240($a_packet_5)          # 70o

        fnms    $lx_7,$b_9,$dx_5,$fx_2                  # 71e
            stqd    $nearest_6,304($a_packet_5)         # 71o

        fnms    $lx_5,$b_5,$dx_7,$fx_2                  # 72e
            stqd    $t_best_6,224($a_packet_5)          # 72o

            fma     $t,$b_17,$k_two,$rest_10            # 73e
            lqd     $t_best_3,240($a_packet_6)          # 73o

            fnms    $e_5,$s_4,$y_6,$k_one               # 74e
            shufb   $t_best_8,$t_best_4,$t_3,$merge_4   # 74o

            fma     $e,$e_7,$half,$whole                # 75e
            stqd    $nearest_7,288($a_packet_5)         # 75o

        fm      $rest_11,$lx_2,$dx_10                   # 76e
            shlqbyi $object_4,$object_3,0               # 76o copy

        fnms    $ly_8,$b_9,$dy_5,$fy_2                  # 77e
            lqd     $nearest_2,304($a_packet_6)         # 77o

        fnms    $ly_6,$b_16,$dy_8,$fy_2                 # 78e
            stqd    $nearest_3,272($a_packet_5)         # 78o

        fnms    $disc_13,$lx_2,$lx_2,$radius2_2         # 79e
            lqd     $nearest_3,272($a_packet_6)         # 79o

            clgt    $hit,$t_best_2,$t                   # 80e
            lqd     $t_best_5,224($a_packet_6)          # 80o

        fm      $rest_6,$lx_7,$dx_5                     # 81e
            stqd    $t_best_8,208($a_packet_5)          # 81o

            andc    $hit,$hit,$disc_17                  # 82e
            shlqbyi $a_packet_5,$a_packet_2,0           # 82o copy

        fnms    $disc,$lx_5,$lx_5,$radius2_2            # 83e
            lqd     $t_best_4,208($a_packet_6)          # 83o

        fnms    $disc_15,$lx_8,$lx_8,$radius2_2         # 84e
            lqd     $nearest_5,288($a_packet_6)         # 84o

        fnms    $lz_5,$b_9,$dz_7,$fz_3                  # 85e
        shufb   $object_3,$object,$object,$m_x          # 85o

        fnms    $disc_14,$lx_7,$lx_7,$radius2_2         # 86e
next_pair_back:
        brnz    $count,next_pair                        # 86o

next_pair_drain:
        fnms    $lz_6,$b_16,$dz_6,$fz_3                 # 0e
        rotqbii $hit,$hit,1                             # 0o

        fnms    $disc_17,$ly_6,$ly_6,$disc_13           # 1e
        shlqbyi $a_packet_6,$a_packet_3,0               # 1o copy

        fma     $rest_12,$ly_6,$dy_8,$rest_11           # 2e
        shlqbyi $b_17,$b_16,0                           # 2o copy

        fm      $rest,$lx_5,$dx_7                       # 3e
        shlqbyi $b_18,$b_5,0                            # 3o copy

        fnms    $lz,$b_5,$dz_8,$fz_3                    # 4e
        gb      $hit,$hit                               # 4o

        fnms    $disc,$ly_5,$ly_5,$disc                 # 5e
        shlqbyi $b_19,$b_3,0                            # 5o copy

        fnms    $lz_8,$b_3,$dz_9,$fz_3                  # 6e
        shlqbyi $b_20,$b_9,0                            # 6o copy

        fnms    $disc_17,$lz_6,$lz_6,$disc_17           # 7e
        shlqbyi $a_packet_7,$a_packet_3,0               # 7o copy

        fma     $rest_16,$lz_6,$dz_6,$rest_12           # 8e
        shlqbii $hit,$hit,4                             # 8o

        fma     $rest,$ly_5,$dy_6,$rest                 # 9e
        shlqbyi $object_5,$object_3,0                   # 9o copy

        fnms    $disc_15,$ly_7,$ly_7,$disc_15           # 10e
        hbr     isect_pairs_refined_r16_return,$lr      # 10o hint

        fma     $rest_13,$ly_7,$dy_7,$rest_3            # 11e
        shlqbyi $a_packet_7,$a_packet_7,0               # 11o copy

        fnms    $disc_11,$ly_8,$ly_8,$disc_14           # 12e
        lqx     $merge,$a_merges,$hit                   # 12o

        fnms    $e_8,$s_5,$y,$k_one                     # 13e
        fma     $disc_17,$rest_16,$rest_16,$disc_17     # 14e

        fma     $e_9,$e_5,$half,$whole                  # 15e
        fma     $rest_15,$ly_8,$dy_5,$rest_6            # 16e

        fnms    $disc,$lz,$lz,$disc                     # 17e
        lnop                                            # 17o pairing

        fma     $rest_17,$lz,$dz_8,$rest                # 18e
        shufb   $t_best,$t_best_2,$t,$merge             # 18o

        fnms    $disc_15,$lz_8,$lz_8,$disc_15           # 19e
        shufb   $nearest,$nearest_4,$object_4,$merge    # 19o

        fma     $rest_18,$lz_8,$dz_9,$rest_13           # 20e
        frsqest $y,$disc_17                             # 20o

        fnms    $disc_11,$lz_5,$lz_5,$disc_11           # 21e
        lnop                                            # 21o pairing

        fnms    $rest_13,$s_4,$e_9,$rest_8              # 22e
        stqd    $t_best,192($a_packet_5)                # 22o

        fma     $e_8,$e_8,$half,$whole                  # 23e
        stqd    $nearest,256($a_packet_5)               # 23o

        fi      $y,$disc_17,$y                          # 24e
        lqd     $t_best_2,192($a_packet_6)              # 24o

        lqd     $nearest_4,256($a_packet_6)             # 25o
        fma     $rest_19,$lz_5,$dz_7,$rest_15           # 26e

        fnms    $rest_14,$s_3,$e,$rest_4                # 27e
        fma     $disc_7,$rest_17,$rest_17,$disc         # 28e

        fma     $disc_15,$rest_18,$rest_18,$disc_15     # 29e
        fnms    $rest,$s_5,$e_8,$rest_9                 # 30e

        fma     $t_4,$b_14,$k_two,$rest_13              # 31e
        fma     $disc_18,$rest_19,$rest_19,$disc_11     # 32e

        fm      $s_7,$disc_17,$y                        # 33e
        lnop                                            # 33o pairing

        fma     $t,$b_6,$k_two,$rest_14                 # 34e
        frsqest $y_6,$disc_7                            # 34o

        frsqest $y_7,$disc_15                           # 35o
        fma     $t_3,$b_13,$k_two,$rest                 # 36e

        clgt    $hit_2,$t_best_3,$t_4                   # 37e
        lnop                                            # 37o pairing

        fi      $y_6,$disc_7,$y_6                       # 38e
        frsqest $y_9,$disc_18                           # 38o

        fi      $y_7,$disc_15,$y_7                      # 39e
        clgt    $hit,$t_best_5,$t                       # 40e

        fnms    $e_2,$s_7,$y,$k_one                     # 41e
        andc    $hit_2,$hit_2,$disc_10                  # 42e

        andc    $hit,$hit,$disc_9                       # 43e
        lnop                                            # 43o pairing

        fi      $y_9,$disc_18,$y_9                      # 44e
        rotqbii $hit_2,$hit_2,1                         # 44o

        clgt    $hit_3,$t_best_4,$t_3                   # 45e
        rotqbii $hit,$hit,1                             # 45o

        fm      $s_4,$disc_7,$y_6                       # 46e
        fma     $e_2,$e_2,$half,$whole                  # 47e

        andc    $hit_3,$hit_3,$disc_12                  # 48e
        gb      $hit_2,$hit_2                           # 48o

        fm      $s_3,$disc_15,$y_7                      # 49e
        gb      $hit,$hit                               # 49o

        rotqbii $hit_4,$hit_3,1                         # 50o
        fm      $s_5,$disc_18,$y_9                      # 51e

        fnms    $e_5,$s_4,$y_6,$k_one                   # 52e
        shlqbii $hit_3,$hit_2,4                         # 52o

        fnms    $rest_16,$s_7,$e_2,$rest_16             # 53e
        shlqbii $hit,$hit,4                             # 53o

        gb      $hit_4,$hit_4                           # 54o
        fnms    $e_7,$s_3,$y_7,$k_one                   # 55e

        nop     $127                                    # 56e pairing
        lqx     $merge_3,$a_merges,$hit_3               # 56o

        fnms    $e,$s_5,$y_9,$k_one                     # 57e
        lqx     $merge_2,$a_merges,$hit                 # 57o

        fma     $e_6,$e_5,$half,$whole                  # 58e
        shlqbii $hit_4,$hit_4,4                         # 58o

        fma     $t_5,$b_17,$k_two,$rest_16              # 59e
        fma     $e_10,$e_7,$half,$whole                 # 61e

        nop     $127                                    # 62e pairing
        lqx     $merge_4,$a_merges,$hit_4               # 62o

        fma     $e,$e,$half,$whole                      # 63e
        shufb   $t_best_9,$t_best_3,$t_4,$merge_3       # 63o

        fnms    $rest_13,$s_4,$e_6,$rest_17             # 64e
        shufb   $nearest_6,$nearest_2,$object_4,$merge_3 # 64o

        clgt    $hit_5,$t_best_2,$t_5                   # 65e
        shufb   $t_best_6,$t_best_5,$t,$merge_2         # 65o

        nop     $127                                    # 66e pairing
        shufb   $nearest_7,$nearest_5,$object_4,$merge_2 # 66o

        andc    $hit_6,$hit_5,$disc_17                  # 67e
        stqd    $t_best_9,240($a_packet_5)              # 67o

        fnms    $rest_14,$s_3,$e_10,$rest_18            # 68e
        stqd    $nearest_6,304($a_packet_5)             # 68o

        fnms    $rest_18,$s_5,$e,$rest_19               # 69e
        shufb   $nearest_3,$nearest_3,$object_4,$merge_4 # 69o

        fma     $t_6,$b_18,$k_two,$rest_13              # 70e
        stqd    $t_best_6,224($a_packet_5)              # 70o

        lqd     $t_best_3,240($a_packet_6)              # 71o
        rotqbii $hit_6,$hit_6,1                         # 72o

        nop     $127                                    # 73e pairing
        shufb   $t_best_10,$t_best_4,$t_3,$merge_4      # 73o

        fma     $t,$b_19,$k_two,$rest_14                # 74e
        stqd    $nearest_7,288($a_packet_5)             # 74o

        fma     $t_3,$b_20,$k_two,$rest_18              # 75e
        lqd     $nearest_2,304($a_packet_6)             # 75o

        nop     $127                                    # 76e pairing
        stqd    $nearest_3,272($a_packet_5)             # 76o

        clgt    $hit_2,$t_best_3,$t_6                   # 77e
        lqd     $nearest_3,272($a_packet_6)             # 77o

        nop     $127                                    # 78e pairing
        lqd     $t_best_5,224($a_packet_6)              # 78o

        andc    $hit_2,$hit_2,$disc_7                   # 79e
        gb      $hit,$hit_6                             # 79o

        stqd    $t_best_10,208($a_packet_5)             # 80o
        lqd     $t_best_4,208($a_packet_6)              # 81o

        rotqbii $hit_2,$hit_2,1                         # 82o
        shlqbii $hit,$hit,4                             # 83o

        clgt    $hit_7,$t_best_5,$t                     # 84e
        lqd     $nearest_5,288($a_packet_6)             # 84o

        andc    $hit_7,$hit_7,$disc_15                  # 86e
        gb      $hit_2,$hit_2                           # 86o

        clgt    $hit_3,$t_best_4,$t_3                   # 87e
        lqx     $merge,$a_merges,$hit                   # 87o

        rotqbii $hit,$hit_7,1                           # 88o
        andc    $hit_3,$hit_3,$disc_18                  # 89e

        shlqbii $hit_7,$hit_2,4                         # 90o
        rotqbii $hit_4,$hit_3,1                         # 91o

        gb      $hit,$hit                               # 92o
        shufb   $t_best,$t_best_2,$t_5,$merge           # 93o

        shufb   $nearest,$nearest_4,$object_5,$merge    # 94o
        gb      $hit_4,$hit_4                           # 95o

        shlqbii $hit,$hit,4                             # 96o
        stqd    $t_best,192($a_packet_7)                # 97o

        stqd    $nearest,256($a_packet_7)               # 98o
        shlqbii $hit_4,$hit_4,4                         # 99o

        lqx     $merge_3,$a_merges,$hit_7               # 100o
        lqx     $merge_2,$a_merges,$hit                 # 101o

        lqx     $merge_4,$a_merges,$hit_4               # 103o
        shufb   $t_best_7,$t_best_3,$t_6,$merge_3       # 106o

        shufb   $nearest_6,$nearest_2,$object_5,$merge_3 # 107o
        shufb   $t_best_6,$t_best_5,$t,$merge_2         # 108o

        shufb   $nearest_7,$nearest_5,$object_5,$merge_2 # 109o
        shufb   $nearest_3,$nearest_3,$object_5,$merge_4 # 110o

        stqd    $t_best_7,240($a_packet_7)              # 111o
        stqd    $nearest_6,304($a_packet_7)             # 112o

        shufb   $t_best_8,$t_best_4,$t_3,$merge_4       # 113o
        stqd    $t_best_6,224($a_packet_7)              # 114o

        stqd    $nearest_7,288($a_packet_7)             # 115o
        stqd    $nearest_3,272($a_packet_7)             # 116o

        stqd    $t_best_8,208($a_packet_7)              # 117o
isect_pairs_refined_r16_return:
        bi      $lr                                     # 118o

next_pair_short:
        ai      $count,$count,-1                        # 0e
        lqd     $object,0($a_pair)                      # 0o

        ai      $a_pair,$a_pair,16                      # 1e
        lqd     $quad,0($object)                        # 6o

        rotqbyi $a_packet,$object,4                     # 7o
        shufb   $object,$object,$object,$m_x            # 8o

        nop     $127                                    # 9e pairing
        lqd     $dx,0($a_packet)                        # 11o

        fm      $quad,$quad,$k_scales                   # 12e
        lqd     $dx_10,16($a_packet)                    # 12o

        lqd     $dy,64($a_packet)                       # 13o
        lqd     $dy_9,80($a_packet)                     # 14o

        lqd     $dz,128($a_packet)                      # 15o
        lqd     $dx_11,32($a_packet)                    # 16o

        lqd     $dx_2,48($a_packet)                     # 17o
        shufb   $fx,$quad,$quad,$m_x                    # 18o

        shufb   $fy,$quad,$quad,$m_y                    # 19o
        shufb   $fz,$quad,$quad,$m_z                    # 20o

        nop     $127                                    # 21e pairing
        lqd     $dz_10,144($a_packet)                   # 21o

        fm      $b,$fx,$dx                              # 22e
        lqd     $dy_10,96($a_packet)                    # 22o

        fm      $b_21,$fx,$dx_10                        # 23e
        lqd     $dy_11,112($a_packet)                   # 23o

        fm      $b_16,$fx,$dx_11                        # 24e
        shufb   $radius2_2,$quad,$quad,$m_radius2       # 24o

        fm      $b_6,$fx,$dx_2                          # 25e
        lqd     $dz_11,160($a_packet)                   # 25o

        lqd     $dz_12,176($a_packet)                   # 26o
        lqd     $t_best_11,192($a_packet)               # 27o

        fma     $b,$fy,$dy,$b                           # 28e
        lqd     $t_best_12,208($a_packet)               # 28o

        fma     $b_21,$fy,$dy_9,$b_21                   # 29e
        lqd     $t_best_13,224($a_packet)               # 29o

        fma     $b_16,$fy,$dy_10,$b_16                  # 30e
        lqd     $t_best_14,240($a_packet)               # 30o

        fma     $b_6,$fy,$dy_11,$b_6                    # 31e
        lqd     $nearest_8,256($a_packet)               # 31o

        lqd     $nearest_9,272($a_packet)               # 32o
        lqd     $nearest_7,288($a_packet)               # 33o

        fma     $b,$fz,$dz,$b                           # 34e
        lqd     $nearest_10,304($a_packet)              # 34o

        fma     $b_21,$fz,$dz_10,$b_21                  # 35e
        fma     $b_16,$fz,$dz_11,$b_16                  # 36e

        fma     $b_6,$fz,$dz_12,$b_6                    # 37e
        fnms    $lx_9,$b,$dx,$fx                        # 40e

        fnms    $lx_10,$b_21,$dx_10,$fx                 # 41e
        fnms    $ly_9,$b,$dy,$fy                        # 42e

        fnms    $ly_8,$b_21,$dy_9,$fy                   # 43e
        fnms    $lz_9,$b,$dz,$fz                        # 44e

        fnms    $lx_8,$b_16,$dx_11,$fx                  # 45e
        fnms    $disc_19,$lx_9,$lx_9,$radius2_2         # 46e

        fm      $rest_14,$lx_9,$dx                      # 47e
        fnms    $disc_20,$lx_10,$lx_10,$radius2_2       # 48e

        fm      $rest_16,$lx_10,$dx_10                  # 49e
        fnms    $lx_11,$b_6,$dx_2,$fx                   # 50e

        fnms    $lz_10,$b_21,$dz_10,$fz                 # 51e
        fnms    $disc_19,$ly_9,$ly_9,$disc_19           # 52e

        fma     $rest_14,$ly_9,$dy,$rest_14             # 53e
        fnms    $disc_21,$ly_8,$ly_8,$disc_20           # 54e

        fma     $rest_16,$ly_8,$dy_9,$rest_16           # 55e
        fnms    $ly_10,$b_16,$dy_10,$fy                 # 56e

        fnms    $disc_20,$lx_8,$lx_8,$radius2_2         # 57e
        fnms    $disc_5,$lz_9,$lz_9,$disc_19            # 58e

        fma     $rest_14,$lz_9,$dz,$rest_14             # 59e
        fm      $rest_20,$lx_8,$dx_11                   # 60e

        fnms    $ly_11,$b_6,$dy_11,$fy                  # 61e
        fnms    $disc_18,$lx_11,$lx_11,$radius2_2       # 62e

        fm      $rest_2,$lx_11,$dx_2                    # 63e
        fnms    $disc_22,$lz_10,$lz_10,$disc_21         # 64e

        fma     $rest_16,$lz_10,$dz_10,$rest_16         # 65e
        fma     $disc_15,$rest_14,$rest_14,$disc_5      # 66e

        fnms    $lz_11,$b_16,$dz_11,$fz                 # 67e
        fnms    $disc_23,$ly_10,$ly_10,$disc_20         # 68e

        fma     $rest_18,$ly_10,$dy_10,$rest_20         # 69e
        fnms    $lz_12,$b_6,$dz_12,$fz                  # 70e

        fnms    $disc_17,$ly_11,$ly_11,$disc_18         # 71e
        lnop                                            # 71o pairing

        fma     $rest_2,$ly_11,$dy_11,$rest_2           # 72e
        frsqest $y_10,$disc_15                          # 72o

        fma     $disc_22,$rest_16,$rest_16,$disc_22     # 73e
        fnms    $disc_24,$lz_11,$lz_11,$disc_23         # 74e

        fma     $rest_18,$lz_11,$dz_11,$rest_18         # 75e
        fi      $y_10,$disc_15,$y_10                    # 76e

        fnms    $disc_17,$lz_12,$lz_12,$disc_17         # 78e
        lnop                                            # 78o pairing

        fma     $rest_20,$lz_12,$dz_12,$rest_2          # 79e
        frsqest $y_11,$disc_22                          # 79o

        fma     $disc_24,$rest_18,$rest_18,$disc_24     # 81e
        fi      $y_11,$disc_22,$y_11                    # 83e

        fma     $disc_17,$rest_20,$rest_20,$disc_17     # 85e
        fm      $s_8,$disc_15,$y_10                     # 86e

        frsqest $y_12,$disc_24                          # 87o
        fm      $s_9,$disc_22,$y_11                     # 90e

        fi      $y_12,$disc_24,$y_12                    # 91e
        frsqest $y_13,$disc_17                          # 91o

        fnms    $e_11,$s_8,$y_10,$k_one                 # 93e
        fi      $y_13,$disc_17,$y_13                    # 95e

        fnms    $e_12,$s_9,$y_11,$k_one                 # 97e
        fm      $s_10,$disc_24,$y_12                    # 98e

        fma     $e_11,$e_11,$half,$whole                # 99e
        fm      $s_11,$disc_17,$y_13                    # 102e

        fma     $e_12,$e_12,$half,$whole                # 103e
        fnms    $e_13,$s_10,$y_12,$k_one                # 104e

        fnms    $rest_12,$s_8,$e_11,$rest_14            # 105e
        fnms    $e_14,$s_11,$y_13,$k_one                # 108e

        fnms    $rest_16,$s_9,$e_12,$rest_16            # 109e
        fma     $e_12,$e_13,$half,$whole                # 110e

        fma     $t_7,$b,$k_two,$rest_12                 # 111e
        fma     $e_14,$e_14,$half,$whole                # 114e

        fma     $t_5,$b_21,$k_two,$rest_16              # 115e
        fnms    $rest_18,$s_10,$e_12,$rest_18           # 116e

        clgt    $hit_8,$t_best_11,$t_7                  # 117e
        andc    $hit_8,$hit_8,$disc_15                  # 119e

        fnms    $rest_20,$s_11,$e_14,$rest_20           # 120e
        lnop                                            # 120o pairing

        clgt    $hit_9,$t_best_12,$t_5                  # 121e
        rotqbii $hit_8,$hit_8,1                         # 121o

        fma     $t_8,$b_16,$k_two,$rest_18              # 122e
        andc    $hit_9,$hit_9,$disc_22                  # 123e

        nop     $127                                    # 124e pairing
        gb      $hit_8,$hit_8                           # 125o

        fma     $t_9,$b_6,$k_two,$rest_20               # 126e
        rotqbii $hit_9,$hit_9,1                         # 126o

        clgt    $hit_10,$t_best_13,$t_8                 # 128e
        shlqbii $hit_8,$hit_8,4                         # 129o

        andc    $hit_10,$hit_10,$disc_24                # 130e
        gb      $hit_9,$hit_9                           # 130o

        clgt    $hit_11,$t_best_14,$t_9                 # 132e
        rotqbii $hit_10,$hit_10,1                       # 132o

        nop     $127                                    # 133e pairing
        lqx     $merge_5,$a_merges,$hit_8               # 133o

        andc    $hit_6,$hit_11,$disc_17                 # 134e
        shlqbii $hit_9,$hit_9,4                         # 134o

        rotqbii $hit_6,$hit_6,1                         # 136o
        gb      $hit_10,$hit_10                         # 137o

        lqx     $merge_6,$a_merges,$hit_9               # 138o
        shufb   $t_best,$t_best_11,$t_7,$merge_5        # 139o

        shufb   $nearest,$nearest_8,$object,$merge_5    # 140o
        gb      $hit_8,$hit_6                           # 141o

        shlqbii $hit_6,$hit_10,4                        # 142o
        stqd    $t_best,192($a_packet)                  # 143o

        stqd    $nearest,256($a_packet)                 # 144o
        shufb   $t_best,$t_best_12,$t_5,$merge_6        # 145o

        shufb   $nearest,$nearest_9,$object,$merge_6    # 146o
        shlqbii $hit_12,$hit_8,4                        # 147o

        hbrr    next_pair_short_back,next_pair_short    # 148o hint
        lqx     $merge_5,$a_merges,$hit_6               # 149o

        stqd    $t_best,208($a_packet)                  # 150o
        lqx     $merge_7,$a_merges,$hit_12              # 151o

        stqd    $nearest,272($a_packet)                 # 152o
        shufb   $t_best,$t_best_13,$t_8,$merge_5        # 155o

        shufb   $nearest,$nearest_7,$object,$merge_5    # 156o
        shufb   $t_best_15,$t_best_14,$t_9,$merge_7     # 157o

        shufb   $nearest_11,$nearest_10,$object,$merge_7 # 158o
        stqd    $t_best,224($a_packet)                  # 159o

        stqd    $nearest,288($a_packet)                 # 160o
        stqd    $t_best_15,240($a_packet)               # 161o

        stqd    $nearest_11,304($a_packet)              # 162o
next_pair_short_back:
        brnz    $count,next_pair_short                  # 163o

        nop     $127                                    # 164e pairing
        bi      $lr                                     # 164o
endfunction isect_pairs_refined_r16
