# isect_ball_pairs_factored_r16   nearest hit of packets' rays with spheres, by (r - l)(r + l)
#   C       void isect_ball_pairs_factored_r16(const struct candidate *, int count);
#   In      $3 candidates of objects that are spheres, $4 count (0 is none); pointers 16-aligned
#   Out     the candidates' packets: t, object, where a hit has 0 < t < what was there
#   Uses    $2-$67, $79   Saves  -   Stack  0   Calls  -
#   Domain  |d| = 1 within 4 ulp; coordinates and radius below 2^62, radius above 2^-40
#   Error   60 ulp of the larger of t and r, origin up to 30 radii from the centre, ray within
#           0.995 r of it
#   Twin    oracle/src/twin/sphere/factored.rs
#
# The steps are those of sphere_tmpl.inc: of the crossings the entry is asked for, with SIDES_EXIT the
# exit, and with SIDES_BOTH the exit of a ray from inside.
# Scheduled by spu schedule from isect_ball_pairs_factored_r16.s

        .include "work_unit.inc"
        .include "macros.inc"
        .include "pairs.inc"
        .include "sphere_tmpl.inc"
        .include "sphere_factored.inc"

        .set    a_candidate,3
        .set    count,4
        # constants
        .set    m_x,10
        .set    m_y,11
        .set    m_z,12
        .set    k_one,13
        .set    k_half,14
        .set    a_controls,15
        .set    a_half,16
        .set    a_whole,17
        .set    a_by_side,18
        # the candidate
        .set    object,19
        .set    a_packet,20
        .set    quad,21
        .set    cx,22
        .set    cy,23
        .set    cz,24
        .set    radius,25
        .set    sides,26
        .set    half,27                                 # 1/2, with the sign that the root gets
        .set    whole,28                                # 1 likewise
        .set    m_by_side,29                            # the sign's bit if a ray's side gives it
        # a row
        .set    ox,30
        .set    oy,31
        .set    oz,32
        .set    dx,33
        .set    dy,34
        .set    dz,35
        .set    t_best,36
        .set    nearest,37
        # temporaries
        .set    fx,38
        .set    fy,39
        .set    fz,40
        .set    lx,38                                   # f
        .set    ly,39
        .set    lz,40
        .set    b,41
        .set    outside,42                              # disc
        .set    disc,42
        .set    out,43
        .set    y,44
        .set    s,45
        .set    e,46
        .set    t,47
        .set    ahead,48
        .set    control,49

        sign_controls_table
        sides_tables 0x3f000000, 0x3f800000

function isect_ball_pairs_factored_r16
        .set    count_2,79
        .set    quad_2,22
        .set    sides_2,29
        .set    object_2,64
        .set    ox_2,27
        .set    ox_3,26
        .set    ox_4,28
        .set    cx_2,25
        .set    oy_2,6
        .set    lx_2,27
        .set    oy_3,21
        .set    cy_2,30
        .set    lx_3,26
        .set    dx_2,23
        .set    lx_4,24
        .set    oy_4,25
        .set    dx_3,28
        .set    dx_4,31
        .set    ly_2,6
        .set    dy_2,42
        .set    ly_3,21
        .set    oz_2,34
        .set    ly_4,25
        .set    dy_3,43
        .set    b_2,44
        .set    cz_2,22
        .set    b_3,50
        .set    oz_3,30
        .set    b_4,52
        .set    dy_4,48
        .set    oz_4,53
        .set    lz_2,32
        .set    dy_5,54
        .set    lz_3,34
        .set    dz_2,55
        .set    dz_3,56
        .set    lz_4,30
        .set    dz_4,57
        .set    radius_2,51
        .set    lz_5,22
        .set    dz_5,53
        .set    b_5,58
        .set    t_best_2,65
        .set    t_best_3,66
        .set    nearest_2,67
        .set    a_packet_2,61
        .set    lx_5,23
        .set    half_2,31
        .set    disc_2,26
        .set    disc_3,23
        .set    disc_4,24
        .set    lz_6,27
        .set    disc_5,25
        .set    disc_6,6
        .set    lz_7,26
        .set    disc_7,21
        .set    y_2,25
        .set    y_3,27
        .set    y_4,22
        .set    y_5,28
        .set    s_2,28
        .set    s_3,23
        .set    s_4,6
        .set    s_5,21
        .set    e_2,22
        .set    m_by_side_2,27
        .set    e_3,30
        .set    e_4,25
        .set    s_6,25
        .set    disc_8,8
        .set    disc_9,9
        .set    s_7,5
        .set    s_8,7
        .set    disc_10,59
        .set    disc_11,60
        .set    disc_12,62
        .set    disc_13,63
        .set    out_2,24
        .set    out_3,25
        .set    y_6,2
        .set    out_4,30
        .set    y_7,23
        .set    y_8,26
        .set    nearest_3,5
        .set    nearest_4,7
        .set    t_best_4,8
        .set    s_9,9
        .set    e_5,23
        .set    e_6,24
        .set    e_7,2
        .set    t_2,9
        .set    t_3,2
        .set    control_2,35
        .set    control_3,40
        .set    t_4,45
        .set    ahead_2,44
        .set    control_4,46
        .set    ahead_3,24
        .set    ahead_4,22
        .set    control_5,26
        .set    control_6,24
        .set    control_7,30
        .set    control_8,27
        .set    nearest_5,31
        .set    control_9,22
        .set    t_best_5,23
        .set    t_best_6,2
        .set    t_best_7,3
        .set    ox_5,2
        .set    oy_5,5
        .set    lx_6,2
        .set    dx_5,6
        .set    ox_6,7
        .set    oz_5,8
        .set    ly_5,5
        .set    b_6,9
        .set    dy_6,21
        .set    lx_7,25
        .set    lx_8,7
        .set    dz_6,8
        .set    oy_6,27
        .set    dx_6,29
        .set    dy_7,30
        .set    ly_6,31
        .set    dy_8,36
        .set    ly_7,23
        .set    dz_7,27
        .set    b_7,37
        .set    oz_6,42
        .set    b_8,43
        .set    dz_8,44
        .set    radius_3,45
        .set    t_best_8,46
        .set    t_best_9,47
        .set    t_best_10,48
        .set    t_best_11,49
        .set    nearest_6,34
        .set    nearest_7,33
        .set    nearest_8,21
        .set    nearest_9,6
        .set    lz_8,24
        .set    lz_9,8
        .set    disc_14,2
        .set    b_9,22
        .set    ly_8,7
        .set    lx_9,5
        .set    disc_15,5
        .set    disc_16,7
        .set    y_9,8
        .set    half_3,23
        .set    s_10,24
        .set    s_11,2
        .set    e_8,27
        .set    e_9,8
        .set    e_10,26
        .set    s_12,8
        .set    s_13,26
        .set    out_5,26
        .set    y_10,31
        .set    e_11,32
        .set    s_14,31
        .set    s_15,32
        .set    t_5,25
        .set    e_12,35
        .set    t_6,8
        .set    control_10,9
        .set    ahead_5,26
        .set    ahead_6,30
        .set    control_11,32
        .set    control_12,2
        .set    t_7,22
        .set    t_8,23
        .set    ahead_7,27
        .set    control_13,28
        .set    control_14,5
        .set    control_15,7
        .set    nearest_10,8
        nop     $127                                    # 0e pairing
        biz     $count,$lr                              # 0o

        ilhu    $m_x,1                                  # 1e
        ilhu    $m_y,0x405                              # 2e

        ilhu    $m_z,0x809                              # 3e
        clgti   $count_2,$count,1                       # 4e at least as many passes as overlap

        iohl    $m_x,515                                # 5e
        iohl    $m_y,0x607                              # 6e

        iohl    $m_z,0xa0b                              # 7e
        ila     $a_controls,sign_controls               # 8e

        ila     $a_half,half_by_sides                   # 9e
        ila     $a_whole,whole_by_sides                 # 10e

        ila     $a_by_side,m_by_sides                   # 11e
        ilhu    $k_half,0x3f00                          # 12e

        ilhu    $k_one,0x3f80                           # 13e
        brz     $count_2,next_ball_short                # 13o too few passes

        ai      $count,$count,-1                        # 14e
        lqd     $object,0($a_candidate)                 # 14o

        ai      $a_candidate,$a_candidate,16            # 15e
        rotqbyi $a_packet,$object,4                     # 20o

        lqd     $quad_2,0($object)                      # 21o
        lqd     $sides_2,32($object)                    # 22o

        shufb   $object_2,$object,$object,$m_x          # 23o
        lqd     $ox_2,0($a_packet)                      # 24o

        lqd     $ox,16($a_packet)                       # 25o
        lqd     $ox_3,48($a_packet)                     # 26o

        lqd     $ox_4,32($a_packet)                     # 27o
        shufb   $cx_2,$quad_2,$quad_2,$m_x              # 28o

        lqd     $oy,64($a_packet)                       # 29o
        lqd     $dx,192($a_packet)                      # 30o

        nop     $127                                    # 31e pairing
        lqd     $oy_2,96($a_packet)                     # 31o

        fs      $lx_2,$cx_2,$ox_2                       # 32e
        lqd     $oy_3,112($a_packet)                    # 32o

        fs      $lx,$cx_2,$ox                           # 33e
        shufb   $cy_2,$quad_2,$quad_2,$m_y              # 33o

        fs      $lx_3,$cx_2,$ox_3                       # 34e
        lqd     $dx_2,224($a_packet)                    # 34o

        fs      $lx_4,$cx_2,$ox_4                       # 35e
        lqd     $oy_4,80($a_packet)                     # 35o

        nop     $127                                    # 36e pairing
        lqd     $dx_3,208($a_packet)                    # 36o

        fs      $ly,$cy_2,$oy                           # 37e
        lqd     $dx_4,240($a_packet)                    # 37o

        fm      $b,$lx_2,$dx                            # 38e
        lqd     $oz,128($a_packet)                      # 38o

        fs      $ly_2,$cy_2,$oy_2                       # 39e
        lqd     $dy_2,256($a_packet)                    # 39o

        fs      $ly_3,$cy_2,$oy_3                       # 40e
        lqd     $oz_2,144($a_packet)                    # 40o

        fs      $ly_4,$cy_2,$oy_4                       # 41e
        lqd     $dy_3,272($a_packet)                    # 41o

        fm      $b_2,$lx,$dx_3                          # 42e
        shufb   $cz_2,$quad_2,$quad_2,$m_z              # 42o

        fm      $b_3,$lx_4,$dx_2                        # 43e
        lqd     $oz_3,176($a_packet)                    # 43o

        fm      $b_4,$lx_3,$dx_4                        # 44e
        lqd     $dy_4,288($a_packet)                    # 44o

        fma     $b,$ly,$dy_2,$b                         # 45e
        lqd     $oz_4,160($a_packet)                    # 45o

        fs      $lz_2,$cz_2,$oz                         # 46e
        lqd     $dy_5,304($a_packet)                    # 46o

        fs      $lz_3,$cz_2,$oz_2                       # 47e
        lqd     $dz_2,320($a_packet)                    # 47o

        fma     $b_2,$ly_4,$dy_3,$b_2                   # 48e
        lqd     $dz_3,336($a_packet)                    # 48o

        fs      $lz_4,$cz_2,$oz_3                       # 49e
        lqd     $dz_4,368($a_packet)                    # 49o

        fma     $b_3,$ly_2,$dy_4,$b_3                   # 50e
        shufb   $radius_2,$sides_2,$sides_2,$m_x        # 50o

        fs      $lz_5,$cz_2,$oz_4                       # 51e
        lqd     $dz_5,352($a_packet)                    # 51o

        fma     $b_4,$ly_3,$dy_5,$b_4                   # 52e
        rotqbyi $sides_2,$sides_2,12                    # 52o

        fma     $b_5,$lz_2,$dz_2,$b                     # 53e
        lqd     $t_best_2,432($a_packet)                # 53o

        fma     $b,$lz_3,$dz_3,$b_2                     # 54e
        lqd     $t_best_3,400($a_packet)                # 54o

        nop     $127                                    # 55e pairing
        lqd     $nearest_2,448($a_packet)               # 55o

        rotmi   $sides_2,$sides_2,-26                   # 56e
        shlqbyi $a_packet_2,$a_packet,0                 # 56o copy

        fma     $b_3,$lz_5,$dz_5,$b_3                   # 57e
        fma     $b_4,$lz_4,$dz_4,$b_4                   # 58e

        fnms    $lx_2,$b_5,$dx,$lx_2                    # 59e
        fnms    $lx,$b,$dx_3,$lx                        # 60e

        fnms    $ly,$b_5,$dy_2,$ly                      # 61e
        fnms    $ly_4,$b,$dy_3,$ly_4                    # 62e

        fnms    $lx_5,$b_3,$dx_2,$lx_4                  # 63e
        lnop                                            # 63o pairing

        fnms    $lx_4,$b_4,$dx_4,$lx_3                  # 64e
        lqx     $half_2,$a_half,$sides_2                # 64o

        fm      $disc,$lx_2,$lx_2                       # 65e
        fm      $disc_2,$lx,$lx                         # 66e

        fnms    $ly_2,$b_3,$dy_4,$ly_2                  # 67e
        fnms    $lz_2,$b_5,$dz_2,$lz_2                  # 68e

        fm      $disc_3,$lx_5,$lx_5                     # 69e
        fnms    $ly_3,$b_4,$dy_5,$ly_3                  # 70e

        fm      $disc_4,$lx_4,$lx_4                     # 71e
        fma     $disc,$ly,$ly,$disc                     # 72e

        fnms    $lz_6,$b,$dz_3,$lz_3                    # 73e
        fma     $disc_5,$ly_4,$ly_4,$disc_2             # 74e

        fnms    $lz_5,$b_3,$dz_5,$lz_5                  # 75e
        fma     $disc_6,$ly_2,$ly_2,$disc_3             # 76e

        fnms    $lz_7,$b_4,$dz_4,$lz_4                  # 77e
        fma     $disc_7,$ly_3,$ly_3,$disc_4             # 78e

        fma     $disc,$lz_2,$lz_2,$disc                 # 79e
        fma     $disc_3,$lz_6,$lz_6,$disc_5             # 80e

        fma     $disc_6,$lz_5,$lz_5,$disc_6             # 82e
        fma     $disc_7,$lz_7,$lz_7,$disc_7             # 84e

        frsqest $y_2,$disc                              # 85o
        frsqest $y_3,$disc_3                            # 86o

        fi      $y_4,$disc,$y_2                         # 89e
        frsqest $y_2,$disc_6                            # 89o

        fi      $y_3,$disc_3,$y_3                       # 90e
        frsqest $y_5,$disc_7                            # 90o

        fi      $y,$disc_6,$y_2                         # 93e
        fi      $y_2,$disc_7,$y_5                       # 94e

        fm      $s_2,$disc,$y_4                         # 96e
        fm      $s_3,$disc_3,$y_3                       # 97e

        fm      $s_4,$disc_6,$y                         # 100e
        fm      $s_5,$disc_7,$y_2                       # 101e

        fnms    $e,$s_2,$y_4,$k_one                     # 102e
        lnop                                            # 102o pairing

        fnms    $e_2,$s_3,$y_3,$k_one                   # 103e
        lqx     $m_by_side_2,$a_by_side,$sides_2        # 103o

        fnms    $e_3,$s_4,$y,$k_one                     # 106e
        fnms    $e_4,$s_5,$y_2,$k_one                   # 107e

        fma     $e,$e,$k_half,$k_one                    # 108e
        fma     $e_2,$e_2,$k_half,$k_one                # 109e

        fma     $e_3,$e_3,$k_half,$k_one                # 112e
        fma     $e_4,$e_4,$k_half,$k_one                # 113e

        fm      $s_2,$s_2,$e                            # 114e
        fm      $s,$s_3,$e_2                            # 115e

        fm      $s_4,$s_4,$e_3                          # 118e
        fm      $s_5,$s_5,$e_4                          # 119e

        fa      $s_6,$radius_2,$s_2                     # 120e
        fs      $disc_8,$radius_2,$s                    # 121e

        fs      $disc,$radius_2,$s_2                    # 122e
        fa      $s,$radius_2,$s                         # 123e

        fs      $disc_9,$radius_2,$s_4                  # 124e
        fa      $s_7,$radius_2,$s_4                     # 125e

        fa      $s_8,$radius_2,$s_5                     # 126e
        fs      $disc_6,$radius_2,$s_5                  # 127e

        fm      $disc_10,$disc,$s_6                     # 128e
        fm      $disc_11,$disc_8,$s                     # 129e

        fm      $disc_12,$disc_9,$s_7                   # 131e
        fm      $disc_13,$disc_6,$s_8                   # 133e

        fms     $out_2,$b_5,$b_5,$disc_10               # 134e
        frsqest $y,$disc_10                             # 134o

        fms     $out_3,$b,$b,$disc_11                   # 135e
        frsqest $y_6,$disc_11                           # 135o

        fms     $out_4,$b_3,$b_3,$disc_12               # 137e
        lnop                                            # 137o pairing

        fi      $y_7,$disc_10,$y                        # 138e
        frsqest $y,$disc_12                             # 138o

        fi      $y_8,$disc_11,$y_6                      # 139e
        frsqest $y_6,$disc_13                           # 139o

next_ball:
            fi      $y,$disc_12,$y                      # 0e
        lqd     $object,0($a_candidate)                 # 0o

            fi      $y_6,$disc_13,$y_6                  # 1e
            lqd     $nearest,496($a_packet)             # 1o

        ai      $a_candidate,$a_candidate,16            # 2e
            lqd     $t_best,384($a_packet)              # 2o

            fm      $s,$disc_10,$y_7                    # 3e
            lqd     $nearest_3,480($a_packet)           # 3o

            fm      $s_4,$disc_11,$y_8                  # 4e
            lqd     $nearest_4,464($a_packet)           # 4o

            fms     $out,$b_4,$b_4,$disc_13             # 5e
            lqd     $t_best_4,416($a_packet)            # 5o

        ai      $count,$count,-1                        # 6e
        rotqbyi $a_packet,$object,4                     # 6o

            fm      $s_9,$disc_12,$y                    # 7e
            lnop                                        # 7o pairing

            fm      $s_5,$disc_13,$y_6                  # 8e
        lqd     $quad_2,0($object)                      # 8o

            fnms    $e,$s,$y_7,$k_one                   # 9e
            lqx     $whole,$a_whole,$sides_2            # 9o

            fnms    $e_5,$s_4,$y_8,$k_one               # 10e
            selb    $s,$s,$out_2,$m_by_side_2           # 11e

            selb    $s_4,$s_4,$out_3,$m_by_side_2       # 12e
            fnms    $e_6,$s_9,$y,$k_one                 # 13e

            fnms    $e_7,$s_5,$y_6,$k_one               # 14e
        shufb   $cx_2,$quad_2,$quad_2,$m_x              # 14o

            selb    $s_9,$s_9,$out_4,$m_by_side_2       # 15e
        lqd     $ox,16($a_packet)                       # 15o

            fma     $e,$e,$half_2,$whole                # 16e
        lqd     $ox_3,48($a_packet)                     # 16o

            selb    $s_5,$s_5,$out,$m_by_side_2         # 17e
        lqd     $ox_2,0($a_packet)                      # 17o

            fma     $e_5,$e_5,$half_2,$whole            # 18e
            lnop                                        # 18o pairing

            fma     $e_6,$e_6,$half_2,$whole            # 19e
        lqd     $sides_2,32($object)                    # 19o

            fma     $e_7,$e_7,$half_2,$whole            # 20e
        lqd     $ox_4,32($a_packet)                     # 20o

        fs      $lx,$cx_2,$ox                           # 21e
        lqd     $oy,64($a_packet)                       # 21o

        fs      $lx_3,$cx_2,$ox_3                       # 22e
        lqd     $dx,192($a_packet)                      # 22o

        fs      $lx_2,$cx_2,$ox_2                       # 23e
        shufb   $cy_2,$quad_2,$quad_2,$m_y              # 23o

            fnms    $t,$s_4,$e_5,$b                     # 24e
        lqd     $oy_2,96($a_packet)                     # 24o

            fnms    $t_2,$s_9,$e_6,$b_3                 # 25e
        lqd     $dx_2,224($a_packet)                    # 25o

            fnms    $t_3,$s_5,$e_7,$b_4                 # 26e
        lqd     $oy_3,112($a_packet)                    # 26o

        fs      $lx_4,$cx_2,$ox_4                       # 27e
        lqd     $oy_4,80($a_packet)                     # 27o

        fs      $ly,$cy_2,$oy                           # 28e
        lqd     $dx_3,208($a_packet)                    # 28o

        fm      $b,$lx_2,$dx                            # 29e
        lqd     $dx_4,240($a_packet)                    # 29o

        fs      $ly_2,$cy_2,$oy_2                       # 30e
        lqd     $oz,128($a_packet)                      # 30o

            cgt     $control,$t_best_3,$t               # 31e
        lqd     $oz_2,144($a_packet)                    # 31o

            cgt     $control_2,$t_best_4,$t_2           # 32e
        shufb   $cz_2,$quad_2,$quad_2,$m_z              # 32o

            cgt     $control_3,$t_best_2,$t_3           # 33e
        lqd     $dy_2,256($a_packet)                    # 33o

        fs      $ly_3,$cy_2,$oy_3                       # 34e
        lqd     $dy_3,272($a_packet)                    # 34o

        fs      $ly_4,$cy_2,$oy_4                       # 35e
        lqd     $oz_3,176($a_packet)                    # 35o

        fm      $b_2,$lx,$dx_3                          # 36e
        lqd     $dy_4,288($a_packet)                    # 36o

        fm      $b_3,$lx_4,$dx_2                        # 37e
        shufb   $radius_2,$sides_2,$sides_2,$m_x        # 37o

        fm      $b_4,$lx_3,$dx_4                        # 38e
        rotqbyi $sides_2,$sides_2,12                    # 38o

        fma     $b,$ly,$dy_2,$b                         # 39e
        lqd     $oz_4,160($a_packet)                    # 39o

        fs      $lz_3,$cz_2,$oz_2                       # 40e
        lqd     $dy_5,304($a_packet)                    # 40o

        fs      $lz_4,$cz_2,$oz_3                       # 41e
        fs      $lz_2,$cz_2,$oz                         # 42e

        fma     $b_3,$ly_2,$dy_4,$b_3                   # 43e
        lqd     $dz_2,320($a_packet)                    # 43o

        fma     $b_2,$ly_4,$dy_3,$b_2                   # 44e
        lqd     $dz_3,336($a_packet)                    # 44o

        fs      $lz_5,$cz_2,$oz_4                       # 45e
        lqd     $dz_5,352($a_packet)                    # 45o

        fma     $b_4,$ly_3,$dy_5,$b_4                   # 46e
        lqd     $dz_4,368($a_packet)                    # 46o

        rotmi   $sides_2,$sides_2,-26                   # 47e
            fnms    $t_4,$s,$e,$b_5                     # 48e

        fma     $b_5,$lz_2,$dz_2,$b                     # 49e
        fma     $b,$lz_3,$dz_3,$b_2                     # 50e

        fma     $b_3,$lz_5,$dz_5,$b_3                   # 51e
        fma     $b_4,$lz_4,$dz_4,$b_4                   # 52e

            cgti    $ahead_2,$t_3,0                     # 53e
            cgt     $control_4,$t_best,$t_4             # 54e

        fnms    $lx_2,$b_5,$dx,$lx_2                    # 55e
        fnms    $lz_2,$b_5,$dz_2,$lz_2                  # 56e

        fnms    $lx,$b,$dx_3,$lx                        # 57e
        fnms    $lx_5,$b_3,$dx_2,$lx_4                  # 58e

        fnms    $lx_4,$b_4,$dx_4,$lx_3                  # 59e
        fnms    $ly,$b_5,$dy_2,$ly                      # 60e

        fm      $disc,$lx_2,$lx_2                       # 61e
        fnms    $ly_3,$b_4,$dy_5,$ly_3                  # 62e

        fm      $disc_2,$lx,$lx                         # 63e
        fnms    $ly_4,$b,$dy_3,$ly_4                    # 64e

        fm      $disc_4,$lx_4,$lx_4                     # 65e
        fnms    $ly_2,$b_3,$dy_4,$ly_2                  # 66e

        fm      $disc_3,$lx_5,$lx_5                     # 67e
        fma     $disc,$ly,$ly,$disc                     # 68e

        fnms    $lz_6,$b,$dz_3,$lz_3                    # 69e
        fma     $disc_5,$ly_4,$ly_4,$disc_2             # 70e

        fnms    $lz_5,$b_3,$dz_5,$lz_5                  # 71e
        fnms    $lz_7,$b_4,$dz_4,$lz_4                  # 72e

        fma     $disc_6,$ly_2,$ly_2,$disc_3             # 73e
        fma     $disc_7,$ly_3,$ly_3,$disc_4             # 74e

        fma     $disc,$lz_2,$lz_2,$disc                 # 75e
        fma     $disc_3,$lz_6,$lz_6,$disc_5             # 76e

            cgti    $ahead,$t_4,0                       # 77e
            cgti    $ahead_3,$t_2,0                     # 78e

        fma     $disc_6,$lz_5,$lz_5,$disc_6             # 79e
        fma     $disc_7,$lz_7,$lz_7,$disc_7             # 80e

            cgti    $ahead_4,$t,0                       # 81e
        frsqest $y_2,$disc                              # 81o

            and     $control_5,$control_4,$ahead        # 82e
        frsqest $y_3,$disc_3                            # 82o

            and     $control_6,$control_2,$ahead_3      # 83e
            and     $control,$control,$ahead_4          # 84e

        fi      $y_4,$disc,$y_2                         # 85e
        frsqest $y_2,$disc_6                            # 85o

        fi      $y_3,$disc_3,$y_3                       # 86e
        frsqest $y_5,$disc_7                            # 86o

            and     $control_7,$control_3,$ahead_2      # 87e
            andc    $control_5,$control_5,$disc_10      # 88e

        fi      $y,$disc_6,$y_2                         # 89e
        lnop                                            # 89o pairing

        fi      $y_2,$disc_7,$y_5                       # 90e
            rotqbii $control_5,$control_5,1             # 90o

            andc    $control,$control,$disc_11          # 91e
        fm      $s_2,$disc,$y_4                         # 92e

        fm      $s_3,$disc_3,$y_3                       # 93e
            rotqbii $control,$control,1                 # 93o

            andc    $control_6,$control_6,$disc_12      # 94e
            gb      $control_5,$control_5               # 94o

            andc    $control_7,$control_7,$disc_13      # 95e
            lnop                                        # 95o pairing

        fm      $s_4,$disc_6,$y                         # 96e
            rotqbii $control_6,$control_6,1             # 96o

        fm      $s_5,$disc_7,$y_2                       # 97e
            rotqbii $control_7,$control_7,1             # 97o

        fnms    $e,$s_2,$y_4,$k_one                     # 98e
            gb      $control,$control                   # 98o

        fnms    $e_2,$s_3,$y_3,$k_one                   # 99e
            shlqbii $control_5,$control_5,4             # 99o

            gb      $control_6,$control_6               # 100o
            gb      $control_8,$control_7               # 101o

        fnms    $e_3,$s_4,$y,$k_one                     # 102e
            shlqbii $control,$control,4                 # 102o

        fnms    $e_4,$s_5,$y_2,$k_one                   # 103e
            lqx     $control_5,$control_5,$a_controls   # 103o

        fma     $e,$e,$k_half,$k_one                    # 104e
            shlqbii $control_6,$control_6,4             # 104o

        fma     $e_2,$e_2,$k_half,$k_one                # 105e
            shlqbii $control_8,$control_8,4             # 105o

            lqx     $control,$control,$a_controls       # 106o
        hbrr    next_ball_back,next_ball                # 107o hint

        fma     $e_3,$e_3,$k_half,$k_one                # 108e
            lqx     $control_6,$control_6,$a_controls   # 108o

        fma     $e_4,$e_4,$k_half,$k_one                # 109e
            shufb   $nearest_5,$nearest_2,$object_2,$control_5 # 109o

        fm      $s_2,$s_2,$e                            # 110e
            shufb   $t_best,$t_best,$t_4,$control_5     # 110o

        fm      $s,$s_3,$e_2                            # 111e
            lqx     $control_9,$control_8,$a_controls   # 111o

            shufb   $nearest_4,$nearest_4,$object_2,$control # 112o
            stqd    $nearest_5,448($a_packet_2)         # 113o

        fm      $s_4,$s_4,$e_3                          # 114e
            shufb   $t_best_5,$t_best_3,$t,$control     # 114o

        fm      $s_5,$s_5,$e_4                          # 115e
            stqd    $t_best,384($a_packet_2)            # 115o

        fa      $s_6,$radius_2,$s_2                     # 116e
            shufb   $nearest_3,$nearest_3,$object_2,$control_6 # 116o

        fs      $disc,$radius_2,$s_2                    # 117e
            shufb   $t_best,$t_best_4,$t_2,$control_6   # 117o

        fs      $disc_8,$radius_2,$s                    # 118e
            stqd    $t_best_5,400($a_packet_2)          # 118o

        fa      $s,$radius_2,$s                         # 119e
            shufb   $t_best_6,$t_best_2,$t_3,$control_9 # 119o

        fs      $disc_9,$radius_2,$s_4                  # 120e
            stqd    $nearest_4,464($a_packet_2)         # 120o

        fa      $s_8,$radius_2,$s_5                     # 121e
            stqd    $nearest_3,480($a_packet_2)         # 121o

        fa      $s_7,$radius_2,$s_4                     # 122e
            shufb   $nearest,$nearest,$object_2,$control_9 # 122o

        fs      $disc_6,$radius_2,$s_5                  # 123e
            stqd    $t_best,416($a_packet_2)            # 123o

        fm      $disc_10,$disc,$s_6                     # 124e
            stqd    $t_best_6,432($a_packet_2)          # 124o

        fm      $disc_11,$disc_8,$s                     # 125e
        lqx     $half_2,$a_half,$sides_2                # 125o

            stqd    $nearest,496($a_packet_2)           # 126o
        shlqbyi $a_packet_2,$a_packet,0                 # 127o copy

        fm      $disc_12,$disc_9,$s_7                   # 128e
        lqx     $m_by_side_2,$a_by_side,$sides_2        # 128o

        fm      $disc_13,$disc_6,$s_8                   # 129e
        shufb   $object_2,$object,$object,$m_x          # 129o

        fms     $out_2,$b_5,$b_5,$disc_10               # 130e
        frsqest $y,$disc_10                             # 130o

        fms     $out_3,$b,$b,$disc_11                   # 131e
        frsqest $y_6,$disc_11                           # 131o

        lqd     $t_best_2,432($a_packet)                # 132o
        lqd     $t_best_3,400($a_packet)                # 133o

        fi      $y_7,$disc_10,$y                        # 134e
        frsqest $y,$disc_12                             # 134o

        fi      $y_8,$disc_11,$y_6                      # 135e
        frsqest $y_6,$disc_13                           # 135o

        nop     $127                                    # 136e pairing
        lqd     $nearest_2,448($a_packet)               # 136o

        fms     $out_4,$b_3,$b_3,$disc_12               # 137e
next_ball_back:
        brnz    $count,next_ball                        # 137o

next_ball_drain:
        fm      $s,$disc_10,$y_7                        # 0e
        lqd     $t_best,384($a_packet)                  # 0o

        fi      $y,$disc_12,$y                          # 1e
        lqd     $t_best_4,416($a_packet)                # 1o

        fi      $y_6,$disc_13,$y_6                      # 2e
        lqx     $whole,$a_whole,$sides_2                # 2o

        nop     $127                                    # 3e pairing
        hbr     isect_ball_pairs_factored_r16_return,$lr # 3o hint

        fms     $out,$b_4,$b_4,$disc_13                 # 4e
        lqd     $nearest_3,480($a_packet)               # 4o

        fm      $s_4,$disc_11,$y_8                      # 5e
        lqd     $nearest_4,464($a_packet)               # 5o

        fnms    $e,$s,$y_7,$k_one                       # 6e
        lqd     $nearest,496($a_packet)                 # 6o

        selb    $s,$s,$out_2,$m_by_side_2               # 7e
        fm      $s_9,$disc_12,$y                        # 8e

        fm      $s_5,$disc_13,$y_6                      # 9e
        fnms    $e_5,$s_4,$y_8,$k_one                   # 11e

        fma     $e,$e,$half_2,$whole                    # 12e
        selb    $s_4,$s_4,$out_3,$m_by_side_2           # 13e

        fnms    $e_6,$s_9,$y,$k_one                     # 14e
        fnms    $e_7,$s_5,$y_6,$k_one                   # 15e

        selb    $s_9,$s_9,$out_4,$m_by_side_2           # 16e
        fma     $e_5,$e_5,$half_2,$whole                # 17e

        fnms    $t_4,$s,$e,$b_5                         # 18e
        selb    $s_5,$s_5,$out,$m_by_side_2             # 19e

        fma     $e_6,$e_6,$half_2,$whole                # 20e
        fma     $e_7,$e_7,$half_2,$whole                # 21e

        fnms    $t,$s_4,$e_5,$b                         # 23e
        cgti    $ahead,$t_4,0                           # 24e

        cgt     $control_4,$t_best,$t_4                 # 25e
        fnms    $t_2,$s_9,$e_6,$b_3                     # 26e

        and     $control_5,$control_4,$ahead            # 27e
        fnms    $t_3,$s_5,$e_7,$b_4                     # 28e

        cgt     $control,$t_best_3,$t                   # 29e
        andc    $control_5,$control_5,$disc_10          # 30e

        cgti    $ahead_4,$t,0                           # 31e
        lnop                                            # 31o pairing

        cgt     $control_2,$t_best_4,$t_2               # 32e
        rotqbii $control_5,$control_5,1                 # 32o

        cgti    $ahead_3,$t_2,0                         # 33e
        cgt     $control_3,$t_best_2,$t_3               # 34e

        and     $control_6,$control_2,$ahead_3          # 35e
        lnop                                            # 35o pairing

        cgti    $ahead_2,$t_3,0                         # 36e
        gb      $control_5,$control_5                   # 36o

        and     $control,$control,$ahead_4              # 37e
        and     $control_7,$control_3,$ahead_2          # 38e

        andc    $control,$control,$disc_11              # 39e
        lnop                                            # 39o pairing

        andc    $control_7,$control_7,$disc_13          # 40e
        shlqbii $control_5,$control_5,4                 # 40o

        andc    $control_6,$control_6,$disc_12          # 41e
        rotqbii $control,$control,1                     # 41o

        rotqbii $control_7,$control_7,1                 # 42o
        rotqbii $control_6,$control_6,1                 # 43o

        lqx     $control_5,$control_5,$a_controls       # 44o
        gb      $control,$control                       # 45o

        gb      $control_8,$control_7                   # 46o
        gb      $control_6,$control_6                   # 47o

        shlqbii $control,$control,4                     # 49o
        shufb   $t_best,$t_best,$t_4,$control_5         # 50o

        shlqbii $control_8,$control_8,4                 # 51o
        shlqbii $control_6,$control_6,4                 # 52o

        lqx     $control,$control,$a_controls           # 53o
        shufb   $nearest_5,$nearest_2,$object_2,$control_5 # 54o

        lqx     $control_9,$control_8,$a_controls       # 55o
        lqx     $control_6,$control_6,$a_controls       # 56o

        stqd    $nearest_5,448($a_packet_2)             # 58o
        shufb   $nearest_4,$nearest_4,$object_2,$control # 59o

        shufb   $t_best_5,$t_best_3,$t,$control         # 60o
        shufb   $nearest,$nearest,$object_2,$control_9  # 61o

        shufb   $t_best_7,$t_best_4,$t_2,$control_6     # 62o
        shufb   $nearest_3,$nearest_3,$object_2,$control_6 # 63o

        shufb   $t_best_6,$t_best_2,$t_3,$control_9     # 64o
        stqd    $t_best,384($a_packet_2)                # 65o

        stqd    $t_best_5,400($a_packet_2)              # 66o
        stqd    $nearest_4,464($a_packet_2)             # 67o

        stqd    $nearest_3,480($a_packet_2)             # 68o
        stqd    $t_best_7,416($a_packet_2)              # 69o

        stqd    $t_best_6,432($a_packet_2)              # 70o
        stqd    $nearest,496($a_packet_2)               # 71o

        nop     $127                                    # 72e pairing
isect_ball_pairs_factored_r16_return:
        bi      $lr                                     # 72o

next_ball_short:
        ai      $count,$count,-1                        # 0e
        lqd     $object,0($a_candidate)                 # 0o

        ai      $a_candidate,$a_candidate,16            # 1e
        rotqbyi $a_packet,$object,4                     # 6o

        lqd     $quad,0($object)                        # 7o
        lqd     $sides,32($object)                      # 8o

        shufb   $object,$object,$object,$m_x            # 9o
        lqd     $ox,0($a_packet)                        # 10o

        lqd     $ox_5,16($a_packet)                     # 11o
        lqd     $oy,64($a_packet)                       # 12o

        shufb   $cx,$quad,$quad,$m_x                    # 13o
        shufb   $cy,$quad,$quad,$m_y                    # 14o

        lqd     $dx,192($a_packet)                      # 15o
        lqd     $oy_5,80($a_packet)                     # 16o

        fs      $lx,$cx,$ox                             # 17e
        lqd     $oz,144($a_packet)                      # 17o

        fs      $lx_6,$cx,$ox_5                         # 18e
        lqd     $dx_5,208($a_packet)                    # 18o

        fs      $ly,$cy,$oy                             # 19e
        lqd     $ox,32($a_packet)                       # 19o

        lqd     $ox_6,48($a_packet)                     # 20o
        lqd     $oz_5,128($a_packet)                    # 21o

        fs      $ly_5,$cy,$oy_5                         # 22e
        lqd     $dy,272($a_packet)                      # 22o

        fm      $b,$lx,$dx                              # 23e
        shufb   $cz,$quad,$quad,$m_z                    # 23o

        fm      $b_6,$lx_6,$dx_5                        # 24e
        lqd     $dy_6,256($a_packet)                    # 24o

        fs      $lx_7,$cx,$ox                           # 25e
        lqd     $dz,320($a_packet)                      # 25o

        fs      $lx_8,$cx,$ox_6                         # 26e
        lqd     $oy,112($a_packet)                      # 26o

        fs      $lz,$cz,$oz_5                           # 27e
        lqd     $dz_6,336($a_packet)                    # 27o

        fs      $lz_5,$cz,$oz                           # 28e
        lqd     $oy_6,96($a_packet)                     # 28o

        nop     $127                                    # 29e pairing
        lqd     $dx_3,240($a_packet)                    # 29o

        fma     $b,$ly,$dy_6,$b                         # 30e
        lqd     $dx_6,224($a_packet)                    # 30o

        fma     $b_6,$ly_5,$dy,$b_6                     # 31e
        lqd     $dy_7,288($a_packet)                    # 31o

        fs      $ly_6,$cy,$oy                           # 32e
        lqd     $oz,176($a_packet)                      # 32o

        nop     $127                                    # 33e pairing
        lqd     $dy_8,304($a_packet)                    # 33o

        fs      $ly_7,$cy,$oy_6                         # 34e
        lqd     $dz_7,368($a_packet)                    # 34o

        fm      $b_7,$lx_8,$dx_3                        # 35e
        lqd     $oz_6,160($a_packet)                    # 35o

        fm      $b_8,$lx_7,$dx_6                        # 36e
        lqd     $dz_8,352($a_packet)                    # 36o

        fma     $b_6,$lz_5,$dz_6,$b_6                   # 37e
        shufb   $radius_3,$sides,$sides,$m_x            # 37o

        fma     $b,$lz,$dz,$b                           # 38e
        rotqbyi $sides,$sides,12                        # 38o

        fs      $lz_2,$cz,$oz                           # 39e
        lqd     $t_best_8,384($a_packet)                # 39o

        nop     $127                                    # 40e pairing
        lqd     $t_best_9,400($a_packet)                # 40o

        fma     $b_7,$ly_6,$dy_8,$b_7                   # 41e
        lqd     $t_best_10,416($a_packet)               # 41o

        fma     $b_8,$ly_7,$dy_7,$b_8                   # 42e
        lqd     $t_best_11,432($a_packet)               # 42o

        fnms    $ly_5,$b_6,$dy,$ly_5                    # 43e
        lqd     $nearest_6,448($a_packet)               # 43o

        fnms    $lx,$b,$dx,$lx                          # 44e
        lqd     $nearest_7,464($a_packet)               # 44o

        fnms    $ly,$b,$dy_6,$ly                        # 45e
        lqd     $nearest_8,496($a_packet)               # 45o

        fnms    $lx_6,$b_6,$dx_5,$lx_6                  # 46e
        lqd     $nearest_9,480($a_packet)               # 46o

        fs      $lz_8,$cz,$oz_6                         # 47e
        fma     $b_7,$lz_2,$dz_7,$b_7                   # 48e

        fnms    $lz,$b,$dz,$lz                          # 49e
        fm      $disc,$lx,$lx                           # 50e

        fnms    $lz_9,$b_6,$dz_6,$lz_5                  # 51e
        fm      $disc_14,$lx_6,$lx_6                    # 52e

        fma     $b_9,$lz_8,$dz_8,$b_8                   # 53e
        fnms    $lx,$b_7,$dx_3,$lx_8                    # 54e

        fnms    $ly_8,$b_7,$dy_8,$ly_6                  # 55e
        fma     $disc,$ly,$ly,$disc                     # 56e

        fnms    $lz_6,$b_7,$dz_7,$lz_2                  # 57e
        fma     $disc_14,$ly_5,$ly_5,$disc_14           # 58e

        fnms    $lx_9,$b_9,$dx_6,$lx_7                  # 59e
        fnms    $ly,$b_9,$dy_7,$ly_7                    # 60e

        fm      $disc_3,$lx,$lx                         # 61e
        fma     $disc,$lz,$lz,$disc                     # 62e

        fnms    $lz,$b_9,$dz_8,$lz_8                    # 63e
        fma     $disc_14,$lz_9,$lz_9,$disc_14           # 64e

        fm      $disc_15,$lx_9,$lx_9                    # 65e
        rotmi   $sides,$sides,-26                       # 66e

        fma     $disc_16,$ly_8,$ly_8,$disc_3            # 67e
        frsqest $y,$disc                                # 68o

        nop     $127                                    # 69e pairing
        frsqest $y_9,$disc_14                           # 70o

        fma     $disc_15,$ly,$ly,$disc_15               # 71e
        lqx     $half_3,$a_half,$sides                  # 71o

        fi      $y,$disc,$y                             # 72e
        lqx     $whole,$a_whole,$sides                  # 72o

        lqx     $m_by_side,$a_by_side,$sides            # 73o
        fi      $y_9,$disc_14,$y_9                      # 74e

        fma     $disc_16,$lz_6,$lz_6,$disc_16           # 76e
        fma     $disc_15,$lz,$lz,$disc_15               # 77e

        fm      $s_10,$disc,$y                          # 79e
        fm      $s_11,$disc_14,$y_9                     # 81e

        frsqest $y_2,$disc_16                           # 82o
        frsqest $y_8,$disc_15                           # 83o

        fnms    $e_8,$s_10,$y,$k_one                    # 85e
        fi      $y,$disc_16,$y_2                        # 86e

        fi      $y_2,$disc_15,$y_8                      # 87e
        fnms    $e_9,$s_11,$y_9,$k_one                  # 89e

        fma     $e_10,$e_8,$k_half,$k_one               # 91e
        fm      $s_8,$disc_16,$y                        # 93e

        fm      $s_7,$disc_15,$y_2                      # 94e
        fma     $e_9,$e_9,$k_half,$k_one                # 95e

        fm      $s_10,$s_10,$e_10                       # 97e
        fnms    $e_10,$s_8,$y,$k_one                    # 99e

        fnms    $e_4,$s_7,$y_2,$k_one                   # 100e
        fm      $s_11,$s_11,$e_9                        # 101e

        fa      $s_12,$radius_3,$s_10                   # 103e
        fs      $disc,$radius_3,$s_10                   # 104e

        fma     $e_6,$e_10,$k_half,$k_one               # 105e
        fma     $e_4,$e_4,$k_half,$k_one                # 106e

        fa      $s_13,$radius_3,$s_11                   # 107e
        fs      $disc_14,$radius_3,$s_11                # 108e

        fm      $disc,$disc,$s_12                       # 110e
        fm      $s_8,$s_8,$e_6                          # 111e

        fm      $s_7,$s_7,$e_4                          # 112e
        fm      $disc_14,$disc_14,$s_13                 # 114e

        fms     $out,$b,$b,$disc                        # 116e
        frsqest $y,$disc                                # 116o

        fa      $s_12,$radius_3,$s_8                    # 117e
        fa      $s_10,$radius_3,$s_7                    # 118e

        fs      $disc_15,$radius_3,$s_7                 # 119e
        lnop                                            # 119o pairing

        fs      $disc_16,$radius_3,$s_8                 # 120e
        frsqest $y_2,$disc_14                           # 120o

        fi      $y,$disc,$y                             # 121e
        fms     $out_5,$b_6,$b_6,$disc_14               # 123e

        fi      $y_2,$disc_14,$y_2                      # 124e
        fm      $disc_15,$disc_15,$s_10                 # 126e

        fm      $disc_16,$disc_16,$s_12                 # 127e
        fm      $s,$disc,$y                             # 128e

        fm      $s_12,$disc_14,$y_2                     # 131e
        lnop                                            # 131o pairing

        fms     $out_2,$b_9,$b_9,$disc_15               # 132e
        frsqest $y_3,$disc_15                           # 132o

        fms     $out_4,$b_7,$b_7,$disc_16               # 133e
        frsqest $y_10,$disc_16                          # 133o

        fnms    $e_11,$s,$y,$k_one                      # 134e
        selb    $s,$s,$out,$m_by_side                   # 135e

        fi      $y,$disc_15,$y_3                        # 136e
        fi      $y_3,$disc_16,$y_10                     # 137e

        selb    $s_13,$s_12,$out_5,$m_by_side           # 138e
        fnms    $e_9,$s_12,$y_2,$k_one                  # 139e

        fma     $e_4,$e_11,$half_3,$whole               # 140e
        fm      $s_14,$disc_15,$y                       # 143e

        fm      $s_15,$disc_16,$y_3                     # 144e
        fma     $e_9,$e_9,$half_3,$whole                # 145e

        fnms    $t_5,$s,$e_4,$b                         # 146e
        fnms    $e_12,$s_14,$y,$k_one                   # 149e

        fnms    $e_8,$s_15,$y_3,$k_one                  # 150e
        fnms    $t_6,$s_13,$e_9,$b_6                    # 151e

        cgt     $control_10,$t_best_8,$t_5              # 152e
        cgti    $ahead_5,$t_5,0                         # 153e

        selb    $s,$s_15,$out_4,$m_by_side              # 154e
        and     $control_10,$control_10,$ahead_5        # 155e

        fma     $e_10,$e_12,$half_3,$whole              # 156e
        cgti    $ahead_6,$t_6,0                         # 157e

        cgt     $control_11,$t_best_9,$t_6              # 158e
        andc    $control_10,$control_10,$disc           # 159e

        and     $control_7,$control_11,$ahead_6         # 160e
        lnop                                            # 160o pairing

        fma     $e_5,$e_8,$half_3,$whole                # 161e
        rotqbii $control_10,$control_10,1               # 161o

        andc    $control_12,$control_7,$disc_14         # 162e
        selb    $s_10,$s_14,$out_2,$m_by_side           # 163e

        nop     $127                                    # 164e pairing
        rotqbii $control_12,$control_12,1               # 164o

        fnms    $t_7,$s_10,$e_10,$b_9                   # 165e
        gb      $control_10,$control_10                 # 165o

        fnms    $t_8,$s,$e_5,$b_7                       # 167e
        gb      $control_12,$control_12                 # 168o

        shlqbii $control_10,$control_10,4               # 169o
        cgti    $ahead_3,$t_7,0                         # 171e

        cgt     $control_5,$t_best_10,$t_7              # 172e
        shlqbii $control_12,$control_12,4               # 172o

        cgti    $ahead_7,$t_8,0                         # 173e
        lqx     $control_10,$control_10,$a_controls     # 173o

        cgt     $control_13,$t_best_11,$t_8             # 174e
        and     $control_6,$control_5,$ahead_3          # 175e

        and     $control_5,$control_13,$ahead_7         # 176e
        lqx     $control_12,$control_12,$a_controls     # 176o

        andc    $control_14,$control_6,$disc_15         # 177e
        andc    $control_15,$control_5,$disc_16         # 178e

        rotqbii $control_14,$control_14,1               # 179o
        rotqbii $control_15,$control_15,1               # 180o

        shufb   $t_best,$t_best_8,$t_5,$control_10      # 181o
        shufb   $nearest,$nearest_7,$object,$control_12 # 182o

        gb      $control_14,$control_14                 # 183o
        shufb   $t_best_6,$t_best_9,$t_6,$control_12    # 184o

        gb      $control_15,$control_15                 # 185o
        shufb   $nearest_10,$nearest_6,$object,$control_10 # 186o

        shlqbii $control_14,$control_14,4               # 187o
        stqd    $t_best_6,400($a_packet)                # 188o

        shlqbii $control_12,$control_15,4               # 189o
        stqd    $nearest_10,448($a_packet)              # 190o

        lqx     $control_14,$control_14,$a_controls     # 191o
        stqd    $t_best,384($a_packet)                  # 192o

        lqx     $control_12,$control_12,$a_controls     # 193o
        stqd    $nearest,464($a_packet)                 # 194o

        hbrr    next_ball_short_back,next_ball_short    # 195o hint
        shufb   $t_best,$t_best_10,$t_7,$control_14     # 197o

        shufb   $nearest,$nearest_9,$object,$control_14 # 198o
        shufb   $nearest_3,$nearest_8,$object,$control_12 # 199o

        shufb   $t_best_6,$t_best_11,$t_8,$control_12   # 200o
        stqd    $t_best,416($a_packet)                  # 201o

        stqd    $nearest,480($a_packet)                 # 202o
        stqd    $nearest_3,496($a_packet)               # 203o

        stqd    $t_best_6,432($a_packet)                # 204o
next_ball_short_back:
        brnz    $count,next_ball_short                  # 210o

        nop     $127                                    # 206e pairing
        bi      $lr                                     # 206o
endfunction isect_ball_pairs_factored_r16
