# isect_ball_pairs_stable_r16   nearest hit of packets' rays with spheres, roots that don't cancel
#   C       void isect_ball_pairs_stable_r16(const struct candidate *, int count);
#   In      $3 candidates of objects that are spheres, $4 count (0 is none); pointers 16-aligned
#   Out     the candidates' packets: t, object, where a hit has 0 < t < what was there
#   Uses    $2-$70, $79   Saves  -   Stack  0   Calls  -
#   Domain  |d| = 1 within 4 ulp; coordinates and radius below 2^62, radius above 2^-40
#   Error   20 ulp of the larger of t and r, origin up to 30 radii from the centre, ray within
#           0.995 r of it
#   Twin    oracle/src/twin/sphere/stable.rs
#
# The steps are those of sphere_tmpl.inc: of the crossings the entry is asked for, with SIDES_EXIT the
# exit, and with SIDES_BOTH the exit of a ray from inside.
# Scheduled by spu schedule from isect_ball_pairs_stable_r16.s

        .include "work_unit.inc"
        .include "macros.inc"
        .include "pairs.inc"
        .include "sphere_tmpl.inc"
        .include "sphere_stable.inc"

        .set    a_candidate,3
        .set    count,4
        # constants
        .set    m_x,10
        .set    m_y,11
        .set    m_z,12
        .set    k_one,13
        .set    k_half,14
        .set    m_sign,15
        .set    a_controls,16
        .set    a_half,17
        .set    a_whole,18
        .set    a_by_side,19
        # the candidate
        .set    object,20
        .set    a_packet,21
        .set    quad,22
        .set    cx,23
        .set    cy,24
        .set    cz,25
        .set    radius2,26
        .set    sides,27
        .set    half,28                                 # 1/2, with the sign that the root gets
        .set    whole,29                                # 1 likewise
        .set    m_by_side,30                            # the sign's bit if a ray's side gives it
        # a row
        .set    ox,31
        .set    oy,32
        .set    oz,33
        .set    dx,34
        .set    dy,35
        .set    dz,36
        .set    t_best,37
        .set    nearest,38
        # temporaries
        .set    fx,39
        .set    fy,40
        .set    fz,41
        .set    lx,39                                   # f
        .set    ly,40
        .set    lz,41
        .set    b,42
        .set    outside,43                              # disc
        .set    disc,43
        .set    cc,44
        .set    y,45
        .set    s,46
        .set    e,47
        .set    q,48
        .set    t,49
        .set    ahead,50
        .set    control,51

        sign_controls_table
        sides_tables 0x3f000000, 0x3f800000

function isect_ball_pairs_stable_r16
        .set    count_2,79
        .set    object_2,62
        .set    ox_2,2
        .set    ox_3,6
        .set    oy_2,9
        .set    dx_2,28
        .set    lx_2,2
        .set    lx_3,6
        .set    oy_3,30
        .set    oz_2,35
        .set    oz_3,41
        .set    dy_2,43
        .set    ly_2,9
        .set    dy_3,29
        .set    dx_3,46
        .set    b_2,36
        .set    cz_2,22
        .set    ly_3,5
        .set    ox_4,7
        .set    dz_2,52
        .set    lz_2,35
        .set    dz_3,53
        .set    dy_4,55
        .set    dx_4,25
        .set    b_3,54
        .set    dz_4,48
        .set    lx_4,7
        .set    radius2_2,8
        .set    lz_3,33
        .set    dy_5,44
        .set    oz_4,30
        .set    dz_5,20
        .set    sides_2,23
        .set    b_4,47
        .set    nearest_2,61
        .set    b_5,31
        .set    t_best_2,63
        .set    ly_4,32
        .set    t_best_3,64
        .set    radius2_3,27
        .set    nearest_3,66
        .set    lx_5,28
        .set    nearest_4,69
        .set    lx_6,34
        .set    t_best_4,70
        .set    a_packet_2,65
        .set    lz_4,22
        .set    ly_5,43
        .set    ly_6,29
        .set    disc_2,34
        .set    disc_3,28
        .set    lx_7,46
        .set    lz_5,50
        .set    lz_6,52
        .set    disc_4,29
        .set    ly_7,34
        .set    disc_5,46
        .set    lx_8,25
        .set    lz_7,48
        .set    disc_6,57
        .set    ly_8,44
        .set    disc_7,25
        .set    lz_8,8
        .set    cc_2,7
        .set    cc_3,2
        .set    cc_4,26
        .set    y_2,20
        .set    disc_8,58
        .set    sides_3,56
        .set    y_3,23
        .set    cc_5,6
        .set    y_4,27
        .set    disc_9,59
        .set    s_2,8
        .set    e_2,25
        .set    s_3,24
        .set    s_4,2
        .set    y_5,5
        .set    e_3,23
        .set    e_4,9
        .set    s_5,5
        .set    e_5,2
        .set    q_2,24
        .set    cc_6,60
        .set    cc_7,8
        .set    s_6,20
        .set    y_6,2
        .set    cc_8,25
        .set    s_7,7
        .set    e_6,22
        .set    q_3,9
        .set    s_8,6
        .set    s_9,23
        .set    y_7,7
        .set    e_7,26
        .set    s_10,22
        .set    s_11,67
        .set    q_4,68
        .set    s_12,26
        .set    e_8,6
        .set    t_2,5
        .set    t_3,2
        .set    control_2,8
        .set    lx_9,23
        .set    ahead_2,26
        .set    control_3,29
        .set    control_4,26
        .set    ly_9,24
        .set    sides_4,48
        .set    half_2,54
        .set    dz_6,30
        .set    t_4,45
        .set    s_13,28
        .set    t_best_5,49
        .set    nearest_5,51
        .set    nearest_6,44
        .set    t_best_6,5
        .set    control_5,5
        .set    control_6,23
        .set    y_8,9
        .set    y_9,22
        .set    nearest_7,7
        .set    t_best_7,2
        .set    e_9,5
        .set    y_10,3
        .set    t_5,3
        .set    ahead_3,2
        .set    control_7,4
        .set    control_8,6
        .set    t_best_8,3
        .set    oy_4,5
        .set    dx_5,6
        .set    oz_5,7
        .set    dy_6,8
        .set    b_6,9
        .set    ox_5,22
        .set    dx_6,26
        .set    lz_9,7
        .set    oy_5,29
        .set    dx_7,31
        .set    lx_10,22
        .set    radius2_4,23
        .set    oz_6,37
        .set    dy_7,38
        .set    dz_7,43
        .set    b_7,44
        .set    dz_8,45
        .set    b_8,46
        .set    t_best_9,47
        .set    lz_10,37
        .set    t_best_10,48
        .set    t_best_11,50
        .set    nearest_8,52
        .set    lz_11,25
        .set    nearest_9,33
        .set    ly_10,35
        .set    nearest_10,53
        .set    disc_10,6
        .set    ly_11,8
        .set    lz_12,30
        .set    lz_13,36
        .set    lx_11,8
        .set    lx_12,26
        .set    ly_12,31
        .set    disc_11,8
        .set    disc_12,26
        .set    cc_9,36
        .set    y_11,38
        .set    y_12,26
        .set    cc_10,29
        .set    whole_2,5
        .set    s_14,30
        .set    m_by_side_2,31
        .set    s_15,35
        .set    half_3,27
        .set    cc_11,22
        .set    cc_12,23
        .set    y_13,28
        .set    e_10,29
        .set    s_16,36
        .set    s_17,38
        .set    q_5,28
        .set    s_18,29
        .set    e_11,30
        .set    e_12,27
        .set    e_13,24
        .set    y_14,30
        .set    q_6,27
        .set    e_14,32
        .set    e_15,35
        .set    y_15,25
        .set    y_16,36
        .set    s_19,37
        .set    y_17,32
        .set    t_6,7
        .set    e_16,31
        .set    ahead_4,25
        .set    control_9,28
        .set    ahead_5,29
        .set    control_10,25
        .set    t_7,22
        .set    t_8,9
        .set    ahead_6,9
        .set    control_11,24
        .set    control_12,9
        .set    nearest_11,2
        .set    t_best_12,6
        .set    control_13,7
        .set    control_14,2
        .set    nearest_12,5
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
        ilhu    $k_one,0x3f80                           # 12e

        ilhu    $k_half,0x3f00                          # 13e
        lnop                                            # 13o pairing

        ilhu    $m_sign,0x8000                          # 14e
        brz     $count_2,next_ball_short                # 14o too few passes

        ai      $count,$count,-1                        # 15e
        lqd     $object,0($a_candidate)                 # 15o

        ai      $a_candidate,$a_candidate,16            # 16e
        rotqbyi $a_packet,$object,4                     # 21o

        lqd     $quad,0($object)                        # 22o
        lqd     $sides,32($object)                      # 23o

        shufb   $object_2,$object,$object,$m_x          # 24o
        lqd     $ox,0($a_packet)                        # 25o

        lqd     $ox_2,32($a_packet)                     # 26o
        lqd     $ox_3,48($a_packet)                     # 27o

        shufb   $cx,$quad,$quad,$m_x                    # 28o
        lqd     $oy,64($a_packet)                       # 29o

        lqd     $oy_2,96($a_packet)                     # 30o
        lqd     $dx,192($a_packet)                      # 31o

        fs      $lx,$cx,$ox                             # 32e
        lqd     $dx_2,224($a_packet)                    # 32o

        fs      $lx_2,$cx,$ox_2                         # 33e
        shufb   $cy,$quad,$quad,$m_y                    # 33o

        fs      $lx_3,$cx,$ox_3                         # 34e
        lqd     $oy_3,112($a_packet)                    # 34o

        lqd     $oz_2,160($a_packet)                    # 35o
        lqd     $oz_3,128($a_packet)                    # 36o

        fs      $ly,$cy,$oy                             # 37e
        lqd     $dy_2,288($a_packet)                    # 37o

        fs      $ly_2,$cy,$oy_2                         # 38e
        lqd     $dy_3,256($a_packet)                    # 38o

        fm      $b,$lx,$dx                              # 39e
        lqd     $dx_3,240($a_packet)                    # 39o

        fm      $b_2,$lx_2,$dx_2                        # 40e
        shufb   $cz_2,$quad,$quad,$m_z                  # 40o

        fs      $ly_3,$cy,$oy_3                         # 41e
        lqd     $ox_4,16($a_packet)                     # 41o

        lqd     $oz,176($a_packet)                      # 42o
        lqd     $dz_2,352($a_packet)                    # 43o

        fs      $lz_2,$cz_2,$oz_2                       # 44e
        lqd     $dz_3,320($a_packet)                    # 44o

        fs      $lz,$cz_2,$oz_3                         # 45e
        lqd     $dy_4,304($a_packet)                    # 45o

        fma     $b_2,$ly_2,$dy_2,$b_2                   # 46e
        lqd     $dx_4,208($a_packet)                    # 46o

        fma     $b,$ly,$dy_3,$b                         # 47e
        lqd     $oy,80($a_packet)                       # 47o

        fm      $b_3,$lx_3,$dx_3                        # 48e
        lqd     $dz_4,368($a_packet)                    # 48o

        fs      $lx_4,$cx,$ox_4                         # 49e
        shufb   $radius2_2,$sides,$sides,$m_x           # 49o

        fs      $lz_3,$cz_2,$oz                         # 50e
        lqd     $dy_5,272($a_packet)                    # 50o

        nop     $127                                    # 51e pairing
        lqd     $oz_4,144($a_packet)                    # 51o

        fma     $b_2,$lz_2,$dz_2,$b_2                   # 52e
        lqd     $dz_5,336($a_packet)                    # 52o

        fma     $b,$lz,$dz_3,$b                         # 53e
        rotqbyi $sides_2,$sides,12                      # 53o

        fma     $b_4,$ly_3,$dy_4,$b_3                   # 54e
        lqd     $nearest_2,448($a_packet)               # 54o

        fm      $b_5,$lx_4,$dx_4                        # 55e
        lqd     $t_best_2,416($a_packet)                # 55o

        fs      $ly_4,$cy,$oy                           # 56e
        lqd     $t_best_3,384($a_packet)                # 56o

        fm      $radius2_3,$radius2_2,$radius2_2        # 57e
        lqd     $nearest_3,480($a_packet)               # 57o

        fnms    $lx_5,$b_2,$dx_2,$lx_2                  # 58e
        lqd     $nearest_4,496($a_packet)               # 58o

        fnms    $lx_6,$b,$dx,$lx                        # 59e
        lqd     $t_best_4,432($a_packet)                # 59o

        fma     $b_4,$lz_3,$dz_4,$b_4                   # 60e
        shlqbyi $a_packet_2,$a_packet,0                 # 60o copy

        fs      $lz_4,$cz_2,$oz_4                       # 61e
        fma     $b_5,$ly_4,$dy_5,$b_5                   # 62e

        fnms    $ly_5,$b_2,$dy_2,$ly_2                  # 63e
        fnms    $ly_6,$b,$dy_3,$ly                      # 64e

        fnms    $disc_2,$lx_6,$lx_6,$radius2_3          # 65e
        fnms    $disc_3,$lx_5,$lx_5,$radius2_3          # 66e

        fnms    $lx_7,$b_4,$dx_3,$lx_3                  # 67e
        fma     $b_5,$lz_4,$dz_5,$b_5                   # 68e

        fnms    $lz_5,$b_2,$dz_2,$lz_2                  # 69e
        fnms    $lz_6,$b,$dz_3,$lz                      # 70e

        fnms    $disc_4,$ly_6,$ly_6,$disc_2             # 71e
        fnms    $ly_7,$b_4,$dy_4,$ly_3                  # 72e

        fnms    $disc,$ly_5,$ly_5,$disc_3               # 73e
        fnms    $disc_5,$lx_7,$lx_7,$radius2_3          # 74e

        fnms    $lx_8,$b_5,$dx_4,$lx_4                  # 75e
        fnms    $lz_7,$b_4,$dz_4,$lz_3                  # 76e

        fnms    $disc_6,$lz_6,$lz_6,$disc_4             # 77e
        fnms    $ly_8,$b_5,$dy_5,$ly_4                  # 78e

        fnms    $disc,$lz_5,$lz_5,$disc                 # 79e
        fnms    $disc_3,$ly_7,$ly_7,$disc_5             # 80e

        fnms    $disc_7,$lx_8,$lx_8,$radius2_3          # 81e
        fnms    $lz_8,$b_5,$dz_5,$lz_4                  # 82e

        fms     $cc_2,$lx_4,$lx_4,$radius2_3            # 83e
        frsqest $y,$disc_6                              # 83o

        fms     $cc_3,$lx_2,$lx_2,$radius2_3            # 84e
        lnop                                            # 84o pairing

        fms     $cc_4,$lx,$lx,$radius2_3                # 85e
        frsqest $y_2,$disc                              # 85o

        fnms    $disc_8,$lz_7,$lz_7,$disc_3             # 86e
        fi      $y,$disc_6,$y                           # 87e

        rotmi   $sides_3,$sides_2,-26                   # 88e
        fi      $y_3,$disc,$y_2                         # 89e

        fnms    $disc_7,$ly_8,$ly_8,$disc_7             # 91e
        lnop                                            # 91o pairing

        fms     $cc_5,$lx_3,$lx_3,$radius2_3            # 92e
        frsqest $y_4,$disc_8                            # 92o

        fma     $cc_2,$ly_4,$ly_4,$cc_2                 # 93e
        lqx     $m_by_side,$a_by_side,$sides_3          # 93o

        fm      $s,$disc_6,$y                           # 94e
        lqx     $whole,$a_whole,$sides_3                # 94o

        fma     $cc_4,$ly,$ly,$cc_4                     # 95e
        fi      $y_2,$disc_8,$y_4                       # 96e

        fnms    $disc_9,$lz_8,$lz_8,$disc_7             # 98e
        fm      $s_2,$disc,$y_3                         # 99e

        fnms    $e_2,$s,$y,$k_one                       # 100e
        fma     $cc,$ly_2,$ly_2,$cc_3                   # 101e

        selb    $s_3,$s,$b,$m_sign                      # 102e
        fm      $s_4,$disc_8,$y_2                       # 103e

        fma     $cc_5,$ly_3,$ly_3,$cc_5                 # 104e
        frsqest $y_5,$disc_9                            # 104o

        fnms    $e_3,$s_2,$y_3,$k_one                   # 105e
        fma     $e_4,$e_2,$k_half,$k_one                # 106e

        selb    $s,$s_2,$b_2,$m_sign                    # 107e
        fi      $y,$disc_9,$y_5                         # 108e

        selb    $s_5,$s_4,$b_4,$m_sign                  # 109e
        fnms    $e_5,$s_4,$y_2,$k_one                   # 110e

        fma     $e_3,$e_3,$k_half,$k_one                # 111e
        fma     $q_2,$s_3,$e_4,$b                       # 112e

        fma     $cc_6,$lz_4,$lz_4,$cc_2                 # 113e
        fma     $cc_7,$lz,$lz,$cc_4                     # 114e

        fm      $s_6,$disc_9,$y                         # 115e
        fma     $e_4,$e_5,$k_half,$k_one                # 116e

        fma     $q,$s,$e_3,$b_2                         # 117e
        lnop                                            # 117o pairing

        fma     $cc,$lz_2,$lz_2,$cc                     # 118e
        frest   $y_6,$q_2                               # 118o

        fma     $cc_8,$lz_3,$lz_3,$cc_5                 # 119e
        selb    $s_7,$whole,$cc_7,$m_by_side            # 120e

        fnms    $e_6,$s_6,$y,$k_one                     # 121e
        fma     $q_3,$s_5,$e_4,$b_4                     # 122e

        selb    $s,$whole,$cc_6,$m_by_side              # 123e
        frest   $y_5,$q                                 # 123o

        selb    $s_8,$whole,$cc,$m_by_side              # 124e
        xor     $s_7,$s_7,$b                            # 125e

        xor     $s,$s,$b_5                              # 126e
        lnop                                            # 126o pairing

        xor     $s_8,$s_8,$b_2                          # 127e
        rotqbii $s_9,$s_7,1                             # 127o

        fi      $y_7,$q,$y_5                            # 128e
        rotqbii $s,$s,1                                 # 128o

        fi      $y_5,$q_2,$y_6                          # 129e
        rotqbii $s_8,$s_8,1                             # 129o

        selb    $s_4,$whole,$cc_8,$m_by_side            # 130e
        frest   $y,$q_3                                 # 130o

        fma     $e_7,$e_6,$k_half,$k_one                # 131e
        gb      $s_10,$s_9                              # 131o

        xor     $s_4,$s_4,$b_4                          # 132e
        gb      $s,$s                                   # 132o

        selb    $s_6,$s_6,$b_5,$m_sign                  # 133e
        gb      $s_8,$s_8                               # 133o

        fi      $y_4,$q_3,$y                            # 134e
        rotqbii $s_4,$s_4,1                             # 134o

        nop     $127                                    # 135e pairing
        shlqbii $s_9,$s_10,4                            # 135o

        fnms    $e_6,$q,$y_7,$k_one                     # 136e
        shlqbii $s_11,$s,4                              # 136o

        fma     $q_4,$s_6,$e_7,$b_5                     # 137e
        shlqbii $s_12,$s_8,4                            # 137o

        fnms    $e_8,$q_2,$y_5,$k_one                   # 138e
        gb      $s,$s_4                                 # 138o

next_ball:
        ai      $count,$count,-1                        # 0e
            shlqbii $s,$s,4                             # 0o

            fma     $y,$e_6,$y_7,$y_7                   # 1e
        lqd     $object,0($a_candidate)                 # 1o

        ai      $a_candidate,$a_candidate,16            # 2e
            frest   $y_6,$q_4                           # 2o

            nop     $127                                # 3e pairing
            lqd     $t_best,400($a_packet)              # 3o

            fnms    $e,$q_3,$y_4,$k_one                 # 4e
            lqd     $nearest,464($a_packet)             # 4o

            fma     $y_5,$e_8,$y_5,$y_5                 # 5e
            lqx     $s_8,$s_9,$a_controls               # 5o

            nop     $127                                # 6e pairing
            lqx     $s_7,$s_12,$a_controls              # 6o

            fm      $t,$cc,$y                           # 7e
        rotqbyi $a_packet,$object,4                     # 7o

            fi      $y,$q_4,$y_6                        # 8e
        lqd     $quad,0($object)                        # 8o

            fma     $y_6,$e,$y_4,$y_4                   # 10e
            lqx     $s,$s,$a_controls                   # 10o

            fm      $t_2,$cc_7,$y_5                     # 11e
        lqd     $ox,0($a_packet)                        # 11o

            nop     $127                                # 12e pairing
            shufb   $t,$t,$q,$s_7                       # 13o

            fnms    $e,$q_4,$y,$k_one                   # 15e
        shufb   $cx,$quad,$quad,$m_x                    # 15o

            fm      $t_3,$cc_8,$y_6                     # 16e
        lqd     $ox_4,16($a_packet)                     # 16o

            cgti    $ahead,$t,0                         # 17e
            shufb   $t_2,$t_2,$q_2,$s_8                 # 17o

            cgt     $control,$t_best_2,$t               # 18e
        lqd     $ox_3,48($a_packet)                     # 18o

        fs      $lx,$cx,$ox                             # 19e
        lqd     $ox,32($a_packet)                       # 19o

            and     $control,$control,$ahead            # 20e
        shufb   $cy,$quad,$quad,$m_y                    # 20o

            cgt     $control_2,$t_best_3,$t_2           # 21e
        lqd     $oy,64($a_packet)                       # 21o

            andc    $control,$control,$disc             # 22e
            shufb   $t_3,$t_3,$q_3,$s                   # 22o

            cgti    $ahead,$t_2,0                       # 23e
        lqd     $sides,32($object)                      # 23o

        fs      $lx_4,$cx,$ox_4                         # 24e
        lqd     $oy_2,96($a_packet)                     # 24o

        fs      $lx_3,$cx,$ox_3                         # 25e
        lqd     $dx,192($a_packet)                      # 25o

        fs      $lx_9,$cx,$ox                           # 26e
        lqd     $dx_4,208($a_packet)                    # 26o

            cgti    $ahead_2,$t_3,0                     # 27e
        lqd     $dx_2,224($a_packet)                    # 27o

        fs      $ly,$cy,$oy                             # 28e
        lqd     $oy,80($a_packet)                       # 28o

            cgt     $control_3,$t_best_4,$t_3           # 29e
        lqd     $oz,176($a_packet)                      # 29o

        fs      $ly_2,$cy,$oy_2                         # 30e
        shufb   $cz_2,$quad,$quad,$m_z                  # 30o

        fm      $b,$lx,$dx                              # 31e
        lqd     $oy_3,112($a_packet)                    # 31o

        fm      $b_5,$lx_4,$dx_4                        # 32e
        lqd     $oz_2,160($a_packet)                    # 32o

        fm      $b_2,$lx_9,$dx_2                        # 33e
        lqd     $oz_3,128($a_packet)                    # 33o

        fs      $ly_4,$cy,$oy                           # 34e
        lqd     $dy_2,288($a_packet)                    # 34o

            and     $control_4,$control_3,$ahead_2      # 35e
        lqd     $dy_3,256($a_packet)                    # 35o

        fs      $lz_3,$cz_2,$oz                         # 36e
        lqd     $dy_5,272($a_packet)                    # 36o

        fs      $ly_9,$cy,$oy_3                         # 37e
        lqd     $oz_4,144($a_packet)                    # 37o

        fs      $lz_2,$cz_2,$oz_2                       # 38e
        lqd     $dx_3,240($a_packet)                    # 38o

        fs      $lz,$cz_2,$oz_3                         # 39e
        rotqbyi $sides_4,$sides,12                      # 39o

        fma     $b_2,$ly_2,$dy_2,$b_2                   # 40e
        lqd     $dz_2,352($a_packet)                    # 40o

        fma     $b,$ly,$dy_3,$b                         # 41e
        lqd     $dz_3,320($a_packet)                    # 41o

        fma     $b_5,$ly_4,$dy_5,$b_5                   # 42e
            lqx     $half_2,$a_half,$sides_3            # 42o

        fs      $lz_4,$cz_2,$oz_4                       # 43e
        lqd     $dz_6,336($a_packet)                    # 43o

        fm      $b_3,$lx_3,$dx_3                        # 44e
        lqd     $dy_4,304($a_packet)                    # 44o

        rotmi   $sides_3,$sides_4,-26                   # 45e
        fma     $b_2,$lz_2,$dz_2,$b_2                   # 46e

        fma     $b,$lz,$dz_3,$b                         # 47e
            rotqbii $control,$control,1                 # 47o

            fma     $y,$e,$y,$y                         # 48e
        shufb   $radius2_3,$sides,$sides,$m_x           # 48o

        fma     $b_5,$lz_4,$dz_6,$b_5                   # 49e
        fma     $b_4,$ly_9,$dy_4,$b_3                   # 50e

            and     $control_2,$control_2,$ahead        # 51e
        lqd     $dz_4,368($a_packet)                    # 51o

        fnms    $lx_5,$b_2,$dx_2,$lx_9                  # 52e
            andc    $control_2,$control_2,$disc_6       # 53e

        fnms    $lx_6,$b,$dx,$lx                        # 54e
        lnop                                            # 54o pairing

        fm      $radius2_3,$radius2_3,$radius2_3        # 55e
            rotqbii $control_2,$control_2,1             # 55o

        fnms    $lx_8,$b_5,$dx_4,$lx_4                  # 56e
        lnop                                            # 56o pairing

        fma     $b_4,$lz_3,$dz_4,$b_4                   # 57e
            gb      $control,$control                   # 57o

        fnms    $ly_5,$b_2,$dy_2,$ly_2                  # 58e
        lnop                                            # 58o pairing

        fnms    $ly_8,$b_5,$dy_5,$ly_4                  # 59e
            gb      $control_2,$control_2               # 59o

        fnms    $ly_6,$b,$dy_3,$ly                      # 60e
        lnop                                            # 60o pairing

        fnms    $disc_2,$lx_6,$lx_6,$radius2_3          # 61e
            shlqbii $control,$control,4                 # 61o

        fnms    $disc_7,$lx_8,$lx_8,$radius2_3          # 62e
        lnop                                            # 62o pairing

        fnms    $lz_5,$b_2,$dz_2,$lz_2                  # 63e
            shlqbii $control_2,$control_2,4             # 63o

        fnms    $disc_3,$lx_5,$lx_5,$radius2_3          # 64e
        lnop                                            # 64o pairing

        fnms    $lx_7,$b_4,$dx_3,$lx_3                  # 65e
            lqx     $control,$control,$a_controls       # 65o

        fnms    $lz_6,$b,$dz_3,$lz                      # 66e
        lnop                                            # 66o pairing

            fm      $t_4,$cc_6,$y                       # 67e
            lqx     $control_2,$control_2,$a_controls   # 67o

        fnms    $disc_4,$ly_6,$ly_6,$disc_2             # 68e
        fnms    $ly_7,$b_4,$dy_4,$ly_9                  # 69e

        fnms    $disc,$ly_5,$ly_5,$disc_3               # 70e
            lqx     $s_13,$s_11,$a_controls             # 70o

        fnms    $disc_5,$lx_7,$lx_7,$radius2_3          # 71e
            shufb   $t_best_5,$t_best_2,$t,$control     # 71o

        fnms    $lz_7,$b_4,$dz_4,$lz_3                  # 72e
            shufb   $nearest_5,$nearest_3,$object_2,$control # 72o

        fnms    $disc_7,$ly_8,$ly_8,$disc_7             # 73e
            shufb   $nearest_6,$nearest_2,$object_2,$control_2 # 73o

        fnms    $disc_6,$lz_6,$lz_6,$disc_4             # 74e
            shufb   $t_best_6,$t_best_3,$t_2,$control_2 # 74o

        fnms    $lz_8,$b_5,$dz_6,$lz_4                  # 75e
            stqd    $t_best_5,416($a_packet_2)          # 75o

        fms     $cc_2,$lx_4,$lx_4,$radius2_3            # 76e
            shufb   $t,$t_4,$q_4,$s_13                  # 76o

        fnms    $disc,$lz_5,$lz_5,$disc                 # 77e
            stqd    $nearest_6,448($a_packet_2)         # 77o

        fnms    $disc_3,$ly_7,$ly_7,$disc_5             # 78e
            stqd    $t_best_6,384($a_packet_2)          # 78o

        fms     $cc,$lx_9,$lx_9,$radius2_3              # 79e
        lnop                                            # 79o pairing

            cgt     $control_5,$t_best,$t               # 80e
        frsqest $y,$disc_6                              # 80o

        fms     $cc_5,$lx_3,$lx_3,$radius2_3            # 81e
        fma     $cc_2,$ly_4,$ly_4,$cc_2                 # 82e

            andc    $control_6,$control_4,$disc_8       # 83e
            stqd    $nearest_5,480($a_packet_2)         # 83o

        fms     $cc_4,$lx,$lx,$radius2_3                # 84e
        frsqest $y_4,$disc                              # 84o

        fnms    $disc_8,$lz_7,$lz_7,$disc_3             # 85e
            rotqbii $control,$control_6,1               # 85o

        fi      $y,$disc_6,$y                           # 86e
            cgti    $ahead,$t,0                         # 87e

        fi      $y_3,$disc,$y_4                         # 88e
        lnop                                            # 88o pairing

            and     $control_5,$control_5,$ahead        # 89e
            gb      $control,$control                   # 89o

        fma     $cc_4,$ly,$ly,$cc_4                     # 90e
        lnop                                            # 90o pairing

            andc    $control_5,$control_5,$disc_9       # 91e
        frsqest $y_4,$disc_8                            # 91o

        fnms    $disc_9,$lz_8,$lz_8,$disc_7             # 92e
        lnop                                            # 92o pairing

        fma     $cc_5,$ly_9,$ly_9,$cc_5                 # 93e
            rotqbii $control_5,$control_5,1             # 93o

        fm      $s,$disc_6,$y                           # 94e
            shlqbii $control,$control,4                 # 94o

        fma     $cc_6,$lz_4,$lz_4,$cc_2                 # 95e
        fm      $s_7,$disc,$y_3                         # 96e

        fma     $cc,$ly_2,$ly_2,$cc                     # 97e
            gb      $control_5,$control_5               # 97o

        fma     $cc_7,$lz,$lz,$cc_4                     # 98e
            lqx     $control,$control,$a_controls       # 98o

        fi      $y_8,$disc_8,$y_4                       # 99e
        frsqest $y_9,$disc_9                            # 99o

        selb    $s_3,$s,$b,$m_sign                      # 100e
        lnop                                            # 100o pairing

        fnms    $e_2,$s,$y,$k_one                       # 101e
            shlqbii $control_5,$control_5,4             # 101o

        fnms    $e_3,$s_7,$y_3,$k_one                   # 102e
        lqx     $m_by_side,$a_by_side,$sides_3          # 102o

        fi      $y,$disc_9,$y_9                         # 103e
        lqx     $whole,$a_whole,$sides_3                # 103o

        selb    $s,$s_7,$b_2,$m_sign                    # 104e
            shufb   $nearest_7,$nearest_4,$object_2,$control # 104o

        fma     $cc,$lz_2,$lz_2,$cc                     # 105e
            shufb   $t_best_7,$t_best_4,$t_3,$control   # 105o

        fm      $s_10,$disc_8,$y_8                      # 106e
            lqx     $control,$control_5,$a_controls     # 106o

        fma     $e_9,$e_2,$k_half,$k_one                # 107e
        lnop                                            # 107o pairing

        fma     $e_3,$e_3,$k_half,$k_one                # 108e
            stqd    $nearest_7,496($a_packet_2)         # 108o

        fma     $cc_8,$lz_3,$lz_3,$cc_5                 # 109e
            stqd    $t_best_7,432($a_packet_2)          # 109o

        fm      $s_4,$disc_9,$y                         # 110e
        hbrr    next_ball_back,next_ball                # 110o hint

        selb    $s_8,$whole,$cc,$m_by_side              # 111e
        lqd     $nearest_2,448($a_packet)               # 111o

        selb    $s_7,$whole,$cc_7,$m_by_side            # 112e
            shufb   $nearest,$nearest,$object_2,$control # 112o

        fnms    $e_4,$s_10,$y_8,$k_one                  # 113e
            shufb   $t_best,$t_best,$t,$control         # 113o

        fma     $q,$s,$e_3,$b_2                         # 114e
        shufb   $object_2,$object,$object,$m_x          # 114o

        fma     $q_2,$s_3,$e_9,$b                       # 115e
        lqd     $t_best_2,416($a_packet)                # 115o

        selb    $s,$whole,$cc_6,$m_by_side              # 116e
            stqd    $nearest,464($a_packet_2)           # 116o

        xor     $s_5,$s_7,$b                            # 117e
            stqd    $t_best,400($a_packet_2)            # 117o

        selb    $s_7,$s_10,$b_4,$m_sign                 # 118e
        lqd     $t_best_3,384($a_packet)                # 118o

        fma     $e_4,$e_4,$k_half,$k_one                # 119e
        rotqbii $s_5,$s_5,1                             # 119o

        xor     $s,$s,$b_5                              # 120e
        frest   $y_2,$q                                 # 120o

        fnms    $e_6,$s_4,$y,$k_one                     # 121e
        frest   $y,$q_2                                 # 121o

        selb    $s_9,$whole,$cc_8,$m_by_side            # 122e
        rotqbii $s,$s,1                                 # 122o

        xor     $s_8,$s_8,$b_2                          # 123e
        gb      $s_5,$s_5                               # 123o

        selb    $s_4,$s_4,$b_5,$m_sign                  # 124e
        shlqbyi $a_packet_2,$a_packet,0                 # 124o copy

        fma     $q_3,$s_7,$e_4,$b_4                     # 125e
        rotqbii $s_8,$s_8,1                             # 125o

        fi      $y_7,$q,$y_2                            # 126e
        gb      $s,$s                                   # 126o

        xor     $s_6,$s_9,$b_4                          # 127e
        shlqbii $s_9,$s_5,4                             # 127o

        fma     $e,$e_6,$k_half,$k_one                  # 128e
        lqd     $nearest_3,480($a_packet)               # 128o

        fi      $y_5,$q_2,$y                            # 129e
        gb      $s_8,$s_8                               # 129o

        rotqbii $s_6,$s_6,1                             # 130o
        frest   $y,$q_3                                 # 131o

        nop     $127                                    # 132e pairing
        shlqbii $s_11,$s,4                              # 132o

        fnms    $e_6,$q,$y_7,$k_one                     # 133e
        shlqbii $s_12,$s_8,4                            # 133o

        fma     $q_4,$s_4,$e,$b_5                       # 134e
        gb      $s,$s_6                                 # 134o

        fi      $y_4,$q_3,$y                            # 135e
        lqd     $nearest_4,496($a_packet)               # 135o

        nop     $127                                    # 136e pairing
        lqd     $t_best_4,432($a_packet)                # 136o

        fnms    $e_8,$q_2,$y_5,$k_one                   # 137e
next_ball_back:
        brnz    $count,next_ball                        # 137o

next_ball_drain:
        fma     $y,$e_6,$y_7,$y_7                       # 0e
        frest   $y_6,$q_4                               # 0o

        fma     $y_5,$e_8,$y_5,$y_5                     # 1e
        lqx     $s_7,$s_12,$a_controls                  # 1o

        fnms    $e,$q_3,$y_4,$k_one                     # 2e
        lqx     $s_8,$s_9,$a_controls                   # 2o

        nop     $127                                    # 3e pairing
        shlqbii $s,$s,4                                 # 3o

        fi      $y_6,$q_4,$y_6                          # 4e
        lqx     $s_13,$s_11,$a_controls                 # 4o

        nop     $127                                    # 5e pairing
        lqd     $t_best,400($a_packet)                  # 5o

        fm      $t,$cc,$y                               # 6e
        lqd     $nearest,464($a_packet)                 # 6o

        fm      $t_2,$cc_7,$y_5                         # 7e
        lqx     $s,$s,$a_controls                       # 7o

        fma     $y_10,$e,$y_4,$y_4                      # 8e
        lqx     $half_2,$a_half,$sides_3                # 8o

        hbr     isect_ball_pairs_stable_r16_return,$lr  # 9o hint
        fnms    $e,$q_4,$y_6,$k_one                     # 11e

        shufb   $t,$t,$q,$s_7                           # 12o
        shufb   $t_2,$t_2,$q_2,$s_8                     # 13o

        fm      $t_5,$cc_8,$y_10                        # 14e
        cgti    $ahead,$t,0                             # 16e

        cgt     $control,$t_best_2,$t                   # 17e
        fma     $y,$e,$y_6,$y_6                         # 18e

        cgt     $control_2,$t_best_3,$t_2               # 19e
        lnop                                            # 19o pairing

        cgti    $ahead_3,$t_2,0                         # 20e
        shufb   $t_5,$t_5,$q_3,$s                       # 20o

        and     $control,$control,$ahead                # 21e
        and     $control_2,$control_2,$ahead_3          # 22e

        andc    $control,$control,$disc                 # 23e
        andc    $control_2,$control_2,$disc_6           # 24e

        fm      $t_4,$cc_6,$y                           # 25e
        rotqbii $control,$control,1                     # 25o

        cgti    $ahead_2,$t_5,0                         # 26e
        rotqbii $control_2,$control_2,1                 # 26o

        cgt     $control_3,$t_best_4,$t_5               # 27e
        lnop                                            # 27o pairing

        and     $control_4,$control_3,$ahead_2          # 29e
        gb      $control,$control                       # 29o

        nop     $127                                    # 30e pairing
        gb      $control_2,$control_2                   # 30o

        andc    $control_6,$control_4,$disc_8           # 31e
        shufb   $t_3,$t_4,$q_4,$s_13                    # 31o

        shlqbii $control,$control,4                     # 33o
        shlqbii $control_2,$control_2,4                 # 34o

        cgt     $control_7,$t_best,$t_3                 # 35e
        rotqbii $control_8,$control_6,1                 # 35o

        cgti    $ahead,$t_3,0                           # 36e
        lqx     $control,$control,$a_controls           # 37o

        and     $control_7,$control_7,$ahead            # 38e
        lqx     $control_2,$control_2,$a_controls       # 38o

        gb      $control_8,$control_8                   # 39o
        andc    $control_7,$control_7,$disc_9           # 40e

        rotqbii $control_7,$control_7,1                 # 42o
        shufb   $t_best_5,$t_best_2,$t,$control         # 43o

        shufb   $nearest_6,$nearest_2,$object_2,$control_2 # 44o
        shufb   $t_best_6,$t_best_3,$t_2,$control_2     # 45o

        gb      $control_7,$control_7                   # 46o
        shufb   $nearest_5,$nearest_3,$object_2,$control # 47o

        stqd    $t_best_5,416($a_packet_2)              # 48o
        shlqbii $control_8,$control_8,4                 # 49o

        stqd    $nearest_6,448($a_packet_2)             # 50o
        stqd    $t_best_6,384($a_packet_2)              # 51o

        shlqbii $control_5,$control_7,4                 # 52o
        stqd    $nearest_5,480($a_packet_2)             # 53o

        lqx     $control,$control_8,$a_controls         # 54o
        lqx     $control_7,$control_5,$a_controls       # 56o

        shufb   $nearest_7,$nearest_4,$object_2,$control # 60o
        shufb   $t_best_8,$t_best_4,$t_5,$control       # 61o

        shufb   $nearest,$nearest,$object_2,$control_7  # 62o
        shufb   $t_best,$t_best,$t_3,$control_7         # 63o

        stqd    $nearest_7,496($a_packet_2)             # 64o
        stqd    $t_best_8,432($a_packet_2)              # 65o

        stqd    $nearest,464($a_packet_2)               # 66o
        stqd    $t_best,400($a_packet_2)                # 67o

        nop     $127                                    # 68e pairing
isect_ball_pairs_stable_r16_return:
        bi      $lr                                     # 68o

next_ball_short:
        ai      $count,$count,-1                        # 0e
        lqd     $object,0($a_candidate)                 # 0o

        ai      $a_candidate,$a_candidate,16            # 1e
        rotqbyi $a_packet,$object,4                     # 6o

        lqd     $quad,0($object)                        # 7o
        lqd     $sides,32($object)                      # 8o

        shufb   $object,$object,$object,$m_x            # 9o
        lqd     $ox,16($a_packet)                       # 10o

        lqd     $ox_2,0($a_packet)                      # 11o
        lqd     $oy,80($a_packet)                       # 12o

        shufb   $cx,$quad,$quad,$m_x                    # 13o
        lqd     $dx,208($a_packet)                      # 14o

        lqd     $oy_4,64($a_packet)                     # 15o
        shufb   $cy,$quad,$quad,$m_y                    # 16o

        fs      $lx,$cx,$ox                             # 17e
        lqd     $dx_5,192($a_packet)                    # 17o

        fs      $lx_2,$cx,$ox_2                         # 18e
        lqd     $oz,128($a_packet)                      # 18o

        nop     $127                                    # 19e pairing
        lqd     $dy,272($a_packet)                      # 19o

        fs      $ly,$cy,$oy                             # 20e
        lqd     $oz_5,144($a_packet)                    # 20o

        fs      $ly_3,$cy,$oy_4                         # 21e
        shufb   $cz,$quad,$quad,$m_z                    # 21o

        nop     $127                                    # 22e pairing
        lqd     $ox,48($a_packet)                       # 22o

        fm      $b,$lx,$dx                              # 23e
        lqd     $dy_6,256($a_packet)                    # 23o

        fm      $b_6,$lx_2,$dx_5                        # 24e
        lqd     $ox_5,32($a_packet)                     # 24o

        fs      $lz,$cz,$oz                             # 25e
        lqd     $dx_6,224($a_packet)                    # 25o

        fs      $lz_9,$cz,$oz_5                         # 26e
        lqd     $oy,112($a_packet)                      # 26o

        nop     $127                                    # 27e pairing
        lqd     $dz,336($a_packet)                      # 27o

        fs      $lx_5,$cx,$ox                           # 28e
        lqd     $oy_5,96($a_packet)                     # 28o

        fma     $b,$ly,$dy,$b                           # 29e
        lqd     $dz_6,320($a_packet)                    # 29o

        fma     $b_6,$ly_3,$dy_6,$b_6                   # 30e
        lqd     $dx_7,240($a_packet)                    # 30o

        fs      $lx_10,$cx,$ox_5                        # 31e
        shufb   $radius2_4,$sides,$sides,$m_x           # 31o

        fs      $ly_4,$cy,$oy                           # 32e
        lqd     $oz,176($a_packet)                      # 32o

        nop     $127                                    # 33e pairing
        lqd     $oz_6,160($a_packet)                    # 33o

        fs      $ly_9,$cy,$oy_5                         # 34e
        lqd     $dy_3,304($a_packet)                    # 34o

        fma     $b,$lz_9,$dz,$b                         # 35e
        lqd     $dy_7,288($a_packet)                    # 35o

        fma     $b_6,$lz,$dz_6,$b_6                     # 36e
        lqd     $dz_7,352($a_packet)                    # 36o

        fm      $b_7,$lx_5,$dx_7                        # 37e
        lqd     $dz_8,368($a_packet)                    # 37o

        fm      $b_8,$lx_10,$dx_6                       # 38e
        rotqbyi $sides,$sides,12                        # 38o

        fm      $radius2_4,$radius2_4,$radius2_4        # 39e
        lqd     $t_best_9,384($a_packet)                # 39o

        fs      $lz_10,$cz,$oz_6                        # 40e
        lqd     $t_best_10,400($a_packet)               # 40o

        fnms    $lx_6,$b,$dx,$lx                        # 41e
        lqd     $t_best_5,432($a_packet)                # 41o

        fnms    $lx_3,$b_6,$dx_5,$lx_2                  # 42e
        lqd     $t_best_11,416($a_packet)               # 42o

        fma     $b_7,$ly_4,$dy_3,$b_7                   # 43e
        lqd     $nearest_5,448($a_packet)               # 43o

        fma     $b_8,$ly_9,$dy_7,$b_8                   # 44e
        lqd     $nearest_8,464($a_packet)               # 44o

        fs      $lz_11,$cz,$oz                          # 45e
        lqd     $nearest_9,480($a_packet)               # 45o

        fnms    $ly_10,$b,$dy,$ly                       # 46e
        lqd     $nearest_10,496($a_packet)              # 46o

        fnms    $disc_2,$lx_6,$lx_6,$radius2_4          # 47e
        fnms    $disc_10,$lx_3,$lx_3,$radius2_4         # 48e

        fnms    $ly_11,$b_6,$dy_6,$ly_3                 # 49e
        fma     $b_8,$lz_10,$dz_7,$b_8                  # 50e

        fma     $b_7,$lz_11,$dz_8,$b_7                  # 51e
        fnms    $lz_12,$b_6,$dz_6,$lz                   # 52e

        fnms    $lz_13,$b,$dz,$lz_9                     # 53e
        fnms    $disc_2,$ly_10,$ly_10,$disc_2           # 54e

        fnms    $disc_10,$ly_11,$ly_11,$disc_10         # 55e
        fnms    $lx_11,$b_8,$dx_6,$lx_10                # 56e

        fnms    $lx_12,$b_7,$dx_7,$lx_5                 # 57e
        fnms    $ly_12,$b_8,$dy_7,$ly_9                 # 58e

        fnms    $ly_6,$b_7,$dy_3,$ly_4                  # 59e
        fnms    $disc_2,$lz_13,$lz_13,$disc_2           # 60e

        fnms    $disc_10,$lz_12,$lz_12,$disc_10         # 61e
        fnms    $disc_11,$lx_11,$lx_11,$radius2_4       # 62e

        fnms    $disc_12,$lx_12,$lx_12,$radius2_4       # 63e
        fnms    $lz_12,$b_7,$dz_8,$lz_11                # 64e

        fnms    $lz_2,$b_8,$dz_7,$lz_10                 # 65e
        lnop                                            # 65o pairing

        fms     $cc_3,$lx_2,$lx_2,$radius2_4            # 66e
        frsqest $y,$disc_2                              # 66o

        fms     $cc_9,$lx,$lx,$radius2_4                # 67e
        frsqest $y_11,$disc_10                          # 67o

        fnms    $disc,$ly_12,$ly_12,$disc_11            # 68e
        fnms    $disc_11,$ly_6,$ly_6,$disc_12           # 69e

        fi      $y,$disc_2,$y                           # 70e
        fi      $y_12,$disc_10,$y_11                    # 71e

        rotmi   $sides,$sides,-26                       # 72e
        fma     $cc_10,$ly,$ly,$cc_9                    # 73e

        fnms    $disc,$lz_2,$lz_2,$disc                 # 74e
        fnms    $disc_11,$lz_12,$lz_12,$disc_11         # 75e

        fma     $cc_3,$ly_3,$ly_3,$cc_3                 # 76e
        lqx     $whole_2,$a_whole,$sides                # 76o

        fm      $s_14,$disc_2,$y                        # 77e
        lqx     $m_by_side_2,$a_by_side,$sides          # 77o

        fm      $s_15,$disc_10,$y_12                    # 78e
        lqx     $half_3,$a_half,$sides                  # 78o

        fma     $cc_2,$lz_9,$lz_9,$cc_10                # 79e
        lnop                                            # 79o pairing

        fms     $cc_11,$lx_10,$lx_10,$radius2_4         # 80e
        frsqest $y_4,$disc                              # 80o

        fms     $cc_12,$lx_5,$lx_5,$radius2_4           # 81e
        frsqest $y_13,$disc_11                          # 81o

        fma     $cc_3,$lz,$lz,$cc_3                     # 82e
        fnms    $e_10,$s_14,$y,$k_one                   # 83e

        fnms    $e_7,$s_15,$y_12,$k_one                 # 84e
        fi      $y,$disc,$y_4                           # 85e

        fi      $y_4,$disc_11,$y_13                     # 86e
        selb    $s_13,$s_14,$b,$m_sign                  # 87e

        selb    $s_14,$s_15,$b_6,$m_sign                # 88e
        fma     $e_10,$e_10,$k_half,$k_one              # 89e

        fma     $e_7,$e_7,$k_half,$k_one                # 90e
        selb    $s_15,$whole_2,$cc_3,$m_by_side_2       # 91e

        fm      $s_16,$disc,$y                          # 92e
        fm      $s_17,$disc_11,$y_4                     # 93e

        xor     $s_15,$s_15,$b_6                        # 94e
        fma     $q_5,$s_13,$e_10,$b                     # 95e

        fma     $q_3,$s_14,$e_7,$b_6                    # 96e
        rotqbii $s_12,$s_15,1                           # 96o

        selb    $s_18,$whole_2,$cc_2,$m_by_side_2       # 97e
        fnms    $e_11,$s_16,$y,$k_one                   # 98e

        fnms    $e_12,$s_17,$y_4,$k_one                 # 99e
        lnop                                            # 99o pairing

        selb    $s_15,$s_16,$b_8,$m_sign                # 100e
        gb      $s_12,$s_12                             # 100o

        selb    $s_16,$s_17,$b_7,$m_sign                # 101e
        frest   $y,$q_5                                 # 101o

        xor     $s_18,$s_18,$b                          # 102e
        frest   $y_11,$q_3                              # 102o

        fma     $cc_11,$ly_9,$ly_9,$cc_11               # 103e
        lnop                                            # 103o pairing

        fma     $e_13,$e_11,$k_half,$k_one              # 104e
        rotqbii $s_18,$s_18,1                           # 104o

        fma     $e_12,$e_12,$k_half,$k_one              # 105e
        shlqbii $s_12,$s_12,4                           # 105o

        fi      $y_14,$q_3,$y_11                        # 106e
        fi      $y,$q_5,$y                              # 107e

        nop     $127                                    # 108e pairing
        gb      $s_18,$s_18                             # 108o

        fma     $cc_12,$ly_4,$ly_4,$cc_12               # 109e
        lqx     $s_12,$s_12,$a_controls                 # 109o

        fma     $q_2,$s_15,$e_13,$b_8                   # 110e
        fma     $q_6,$s_16,$e_12,$b_7                   # 111e

        fma     $cc_11,$lz_10,$lz_10,$cc_11             # 112e
        shlqbii $s_18,$s_18,4                           # 112o

        fnms    $e_14,$q_3,$y_14,$k_one                 # 113e
        fnms    $e_15,$q_5,$y,$k_one                    # 114e

        fma     $cc_12,$lz_11,$lz_11,$cc_12             # 115e
        frest   $y_15,$q_2                              # 116o

        nop     $127                                    # 117e pairing
        frest   $y_16,$q_6                              # 117o

        selb    $s_19,$whole_2,$cc_11,$m_by_side_2      # 118e
        lqx     $s_18,$s_18,$a_controls                 # 118o

        fma     $y_14,$e_14,$y_14,$y_14                 # 119e
        fma     $y,$e_15,$y,$y                          # 120e

        fi      $y_15,$q_2,$y_15                        # 121e
        fi      $y_17,$q_6,$y_16                        # 122e

        selb    $s_5,$whole_2,$cc_12,$m_by_side_2       # 123e
        xor     $s,$s_19,$b_8                           # 124e

        fm      $t_3,$cc_3,$y_14                        # 125e
        lnop                                            # 125o pairing

        fm      $t_6,$cc_2,$y                           # 126e
        rotqbii $s,$s,1                                 # 126o

        xor     $s_5,$s_5,$b_7                          # 127e
        fnms    $e_11,$q_2,$y_15,$k_one                 # 128e

        fnms    $e_16,$q_6,$y_17,$k_one                 # 129e
        rotqbii $s_5,$s_5,1                             # 129o

        gb      $s,$s                                   # 130o
        shufb   $t_3,$t_3,$q_3,$s_12                    # 131o

        shufb   $t_6,$t_6,$q_5,$s_18                    # 132o
        gb      $s_5,$s_5                               # 133o

        fma     $y,$e_11,$y_15,$y_15                    # 134e
        shlqbii $s,$s,4                                 # 134o

        fma     $y_8,$e_16,$y_17,$y_17                  # 135e
        cgti    $ahead_4,$t_3,0                         # 136e

        cgt     $control_4,$t_best_10,$t_6              # 137e
        shlqbii $s_5,$s_5,4                             # 137o

        cgt     $control_9,$t_best_9,$t_3               # 138e
        lqx     $s,$s,$a_controls                       # 138o

        cgti    $ahead_5,$t_6,0                         # 139e
        and     $control_10,$control_9,$ahead_4         # 140e

        and     $control_4,$control_4,$ahead_5          # 141e
        lqx     $s_5,$s_5,$a_controls                   # 141o

        andc    $control_8,$control_10,$disc_10         # 142e
        fm      $t_7,$cc_11,$y                          # 143e

        andc    $control_10,$control_4,$disc_2          # 144e
        rotqbii $control_8,$control_8,1                 # 144o

        fm      $t_8,$cc_12,$y_8                        # 145e
        rotqbii $control_6,$control_10,1                # 146o

        gb      $control_8,$control_8                   # 148o
        shufb   $t_7,$t_7,$q_2,$s                       # 149o

        gb      $control_6,$control_6                   # 150o
        shufb   $t_2,$t_8,$q_6,$s_5                     # 151o

        shlqbii $control_8,$control_8,4                 # 152o
        cgti    $ahead_6,$t_7,0                         # 153e

        cgt     $control_11,$t_best_11,$t_7             # 154e
        shlqbii $control_6,$control_6,4                 # 154o

        cgt     $control_10,$t_best_5,$t_2              # 155e
        lnop                                            # 155o pairing

        cgti    $ahead_2,$t_2,0                         # 156e
        lqx     $control_8,$control_8,$a_controls       # 156o

        and     $control_12,$control_11,$ahead_6        # 157e
        lnop                                            # 157o pairing

        and     $control_11,$control_10,$ahead_2        # 158e
        lqx     $control_6,$control_6,$a_controls       # 158o

        andc    $control_12,$control_12,$disc           # 159e
        andc    $control_2,$control_11,$disc_11         # 160e

        rotqbii $control_12,$control_12,1               # 161o
        rotqbii $control_2,$control_2,1                 # 162o

        shufb   $t_best,$t_best_9,$t_3,$control_8       # 163o
        shufb   $nearest,$nearest_8,$object,$control_6  # 164o

        shufb   $nearest_11,$nearest_5,$object,$control_8 # 165o
        shufb   $t_best_12,$t_best_10,$t_6,$control_6   # 166o

        gb      $control,$control_12                    # 167o
        gb      $control_13,$control_2                  # 168o

        stqd    $t_best,384($a_packet)                  # 169o
        stqd    $nearest,464($a_packet)                 # 170o

        stqd    $nearest_11,448($a_packet)              # 171o
        shlqbii $control_14,$control_13,4               # 172o

        shlqbii $control,$control,4                     # 173o
        stqd    $t_best_12,400($a_packet)               # 174o

        hbrr    next_ball_short_back,next_ball_short    # 175o hint
        lqx     $control_14,$control_14,$a_controls     # 176o

        lqx     $control,$control,$a_controls           # 177o
        shufb   $nearest,$nearest_10,$object,$control_14 # 182o

        shufb   $t_best,$t_best_11,$t_7,$control        # 183o
        shufb   $t_best_7,$t_best_5,$t_2,$control_14    # 184o

        shufb   $nearest_12,$nearest_9,$object,$control # 185o
        stqd    $nearest,496($a_packet)                 # 186o

        stqd    $t_best,416($a_packet)                  # 187o
        stqd    $t_best_7,432($a_packet)                # 188o

        stqd    $nearest_12,480($a_packet)              # 189o
next_ball_short_back:
        brnz    $count,next_ball_short                  # 190o

        nop     $127                                    # 191e pairing
        bi      $lr                                     # 191o
endfunction isect_ball_pairs_stable_r16
