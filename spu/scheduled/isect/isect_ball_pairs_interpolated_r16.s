# isect_ball_pairs_interpolated_r16   nearest hit of packets' rays with spheres, by 12 bits of root
#   C       void isect_ball_pairs_interpolated_r16(const struct candidate *, int count);
#   In      $3 candidates of objects that are spheres, $4 count (0 is none); pointers 16-aligned
#   Out     the candidates' packets: t, object, where a hit has 0 < t < what was there
#   Uses    $2-$69, $79   Saves  -   Stack  0   Calls  -
#   Domain  |d| = 1 within 4 ulp; coordinates and radius below 2^62, radius above 2^-40
#   Error   3000 ulp of the larger of t and r, origin up to 30 radii from the centre but not within
#           1/1000 of one from the surface, ray within 0.995 r of it
#   Twin    lab/twins/src/sphere/perpendicular.rs
#
# The steps are those of sphere_tmpl.inc: of the crossings the entry is asked for, with SIDES_EXIT the
# exit, and with SIDES_BOTH the exit of a ray from inside.
# Scheduled by spu schedule from isect_ball_pairs_interpolated_r16.s

        .include "sphere_general.inc"
        .include "sphere_interpolated.inc"

        general_registers "m_sign", "radius2", "out,y,s"
        sign_controls_table
        sides_tables 0x3f000000, 0x3f800000

function isect_ball_pairs_interpolated_r16
        .set    count_2,79
        .set    a_candidate_2,2
        .set    object_2,20
        .set    object_3,2
        .set    a_packet_2,6
        .set    quad_2,8
        .set    quad_3,5
        .set    ox_2,19
        .set    dx_2,41
        .set    cx_2,18
        .set    oy_2,39
        .set    ox_3,27
        .set    cy_2,40
        .set    nearest1_2,19
        .set    dx_3,33
        .set    dy_2,54
        .set    nearest2_2,39
        .set    nearest1_3,7
        .set    oz_2,27
        .set    b_2,46
        .set    oy_3,28
        .set    nearest1_4,29
        .set    cz_2,8
        .set    oz_3,48
        .set    nearest2_3,30
        .set    dx_4,34
        .set    b_3,49
        .set    dy_3,51
        .set    nearest3_2,27
        .set    oy_4,42
        .set    nearest2_4,28
        .set    dy_4,43
        .set    dz_2,58
        .set    b_4,55
        .set    oz_4,9
        .set    b_5,52
        .set    dy_5,50
        .set    nearest3_3,48
        .set    oz_5,53
        .set    nearest2_5,42
        .set    dz_3,57
        .set    dz_4,18
        .set    radius2_2,44
        .set    nearest3_4,9
        .set    dz_5,56
        .set    nearest3_5,53
        .set    a_packet_3,24
        .set    cx_3,8
        .set    t_best_2,60
        .set    ox_4,21
        .set    b_6,22
        .set    ox_5,23
        .set    nearest2_6,26
        .set    ox_6,31
        .set    ox_7,36
        .set    b1_2,37
        .set    oy_5,33
        .set    dx_5,38
        .set    oy_6,34
        .set    b1_3,19
        .set    oy_7,43
        .set    dx_6,45
        .set    b1_4,26
        .set    cy_3,37
        .set    b1_5,7
        .set    oz_6,47
        .set    b1_6,29
        .set    t_best_3,44
        .set    oz_7,51
        .set    dy_6,30
        .set    dy_7,27
        .set    oz_8,18
        .set    nearest3_6,28
        .set    t_best_4,52
        .set    sides_2,59
        .set    cz_3,25
        .set    b1_7,5
        .set    y_2,29
        .set    m_by_side_2,9
        .set    nearest1_5,36
        .set    whole_2,53
        .set    dz_6,55
        .set    y_3,56
        .set    b1_8,62
        .set    dz_7,28
        .set    out_2,57
        .set    dz_8,61
        .set    out_3,63
        .set    y_4,5
        .set    sides_3,64
        .set    s_2,42
        .set    nearest_2,65
        .set    nearest1_6,21
        .set    y_5,66
        .set    y_6,67
        .set    a_packet_4,5
        .set    nearest_3,57
        .set    out_4,68
        .set    radius2_3,69
        .set    y_7,42
        .set    nearest_4,56
        .set    t_2,29
        .set    nearest_5,6
        .set    s_3,40
        .set    half_2,59
        .set    nearest1_7,31
        .set    object_4,63
        .set    nearest1_8,2
        .set    t_3,8
        .set    y_8,23
        .set    control_2,40
        .set    s_4,9
        .set    ahead_2,42
        .set    t_4,22
        .set    nearest2_7,23
        .set    y_9,9
        .set    b_7,34
        .set    t_5,9
        .set    b_8,43
        .set    nearest2_8,33
        .set    control_3,26
        .set    b_9,37
        .set    control_4,53
        .set    ahead_3,59
        .set    control_5,46
        .set    control_6,19
        .set    nearest3_7,47
        .set    ahead_4,40
        .set    nearest3_8,18
        .set    b_10,59
        .set    nearest3_9,25
        .set    control_7,48
        .set    control_8,7
        .set    nearest_6,26
        .set    b_11,48
        .set    control_9,29
        .set    radius2_4,37
        .set    nearest1_9,32
        .set    t_best_5,8
        .set    nearest2_9,36
        .set    nearest_7,19
        .set    b1_9,31
        .set    b1_10,32
        .set    whole_3,34
        .set    b1_11,2
        .set    m_by_side_3,41
        .set    control_10,27
        .set    nearest_8,21
        .set    nearest3_10,29
        .set    t_best_6,7
        .set    nearest3_11,8
        .set    b1_12,18
        .set    b1_13,51
        .set    nearest_9,61
        .set    b1_14,50
        .set    b1_15,52
        .set    out_5,2
        .set    out_6,6
        .set    y_10,7
        .set    out_7,8
        .set    nearest_10,9
        .set    y_11,18
        .set    y_12,19
        .set    s_5,2
        .set    t_best_7,22
        .set    s_6,6
        .set    t_best_8,23
        .set    y_13,2
        .set    t_6,2
        .set    y_14,6
        .set    t_7,7
        .set    t_8,6
        .set    ahead_5,26
        .set    control_11,28
        .set    control_12,31
        .set    ahead_6,33
        .set    control_13,38
        .set    nearest1_10,18
        .set    oz_9,40
        .set    dz_9,25
        .set    nearest3_12,32
        .set    t_best_9,6
        .set    nearest1_11,23
        .set    nearest2_10,29
        .set    nearest2_11,7
        .set    t_best_10,33
        .set    b1_16,23
        .set    nearest_11,38
        .set    ox_8,2
        .set    dx_7,5
        .set    oy_8,6
        .set    nearest2_12,6
        .set    oz_10,7
        .set    dy_8,8
        .set    b_12,9
        .set    ox_9,20
        .set    nearest1_12,24
        .set    dz_10,26
        .set    nearest3_13,7
        .set    dx_8,27
        .set    dx_9,29
        .set    nearest1_13,20
        .set    radius2_5,21
        .set    oz_11,35
        .set    b_13,36
        .set    dy_9,41
        .set    dy_10,42
        .set    dz_11,43
        .set    b_14,44
        .set    dz_12,45
        .set    nearest2_13,22
        .set    t_best_11,28
        .set    nearest3_14,31
        .set    t_best_12,46
        .set    t_best_13,5
        .set    t_best_14,32
        .set    nearest_12,8
        .set    nearest3_15,23
        .set    nearest_13,35
        .set    nearest_14,47
        .set    nearest_15,48
        .set    b1_17,33
        .set    b1_18,6
        .set    m_by_side_4,6
        .set    b1_19,22
        .set    b1_20,20
        .set    out_8,21
        .set    nearest3_16,24
        .set    y_15,20
        .set    s_7,21
        .set    ahead_7,23
        .set    control_14,24
        .set    control_15,25
        .set    control_16,23
        .set    control_17,21
        .set    control_18,2
        .set    control_19,20
        .set    t_9,21
        .set    ahead_8,25
        .set    control_20,22
        .set    t_best_15,9
        .set    nearest_16,5
        .set    t_best_16,2
        nop     $127                                    # 0e pairing
        biz     $count,$lr                              # 0o

        ilhu    $m_x,1                                  # 1e
        ilhu    $m_y,0x405                              # 2e

        ilhu    $m_z,0x809                              # 3e
        clgti   $count_2,$count,2                       # 4e at least as many passes as overlap

        iohl    $m_x,515                                # 5e
        iohl    $m_y,0x607                              # 6e

        iohl    $m_z,0xa0b                              # 7e
        ila     $a_controls,sign_controls               # 8e

        ila     $a_half,half_by_sides                   # 9e
        ila     $a_half+1,whole_by_sides                # 10e

        ila     $a_by_side,m_by_sides                   # 11e
        lnop                                            # 11o pairing

        ilhu    $m_sign,0x8000                          # 12e
        brz     $count_2,next_ball_short                # 12o too few passes

        ai      $a_candidate_2,$a_candidate,16          # 13e
        lqd     $object_2,0($a_candidate)               # 13o

        ai      $count,$count,-1                        # 14e
        lnop                                            # 14o pairing

        ai      $a_candidate,$a_candidate_2,16          # 15e
        lqd     $object_3,0($a_candidate_2)             # 15o

        ai      $count,$count,-1                        # 16e
        rotqbyi $a_packet_2,$object_2,4                 # 19o

        lqd     $quad_2,0($object_2)                    # 20o
        lqd     $sides,32($object_2)                    # 21o

        lqd     $quad_3,0($object_3)                    # 22o
        lqd     $ox,32($a_packet_2)                     # 23o

        lqd     $ox_2,0($a_packet_2)                    # 24o
        lqd     $dx_2,224($a_packet_2)                  # 25o

        shufb   $cx_2,$quad_2,$quad_2,$m_x              # 26o
        lqd     $oy_2,96($a_packet_2)                   # 27o

        lqd     $ox_3,48($a_packet_2)                   # 28o
        shufb   $cy_2,$quad_2,$quad_2,$m_y              # 29o

        fs      $nearest+1,$cx_2,$ox                    # 30e
        lqd     $ox,16($a_packet_2)                     # 30o

        fs      $nearest1_2,$cx_2,$ox_2                 # 31e
        lqd     $dx_3,240($a_packet_2)                  # 31o

        nop     $127                                    # 32e pairing
        lqd     $dy_2,288($a_packet_2)                  # 32o

        fs      $nearest2_2,$cy_2,$oy_2                 # 33e
        lqd     $oy,64($a_packet_2)                     # 33o

        fs      $nearest1_3,$cx_2,$ox_3                 # 34e
        lqd     $dx,192($a_packet_2)                    # 34o

        nop     $127                                    # 35e pairing
        lqd     $oz_2,160($a_packet_2)                  # 35o

        fm      $b_2,$nearest+1,$dx_2                   # 36e
        lqd     $oy_3,112($a_packet_2)                  # 36o

        fs      $nearest1_4,$cx_2,$ox                   # 37e
        shufb   $cz_2,$quad_2,$quad_2,$m_z              # 37o

        nop     $127                                    # 38e pairing
        lqd     $oz_3,128($a_packet_2)                  # 38o

        fs      $nearest2_3,$cy_2,$oy                   # 39e
        lqd     $dx_4,208($a_packet_2)                  # 39o

        fm      $b_3,$nearest1_2,$dx                    # 40e
        lqd     $dy_3,304($a_packet_2)                  # 40o

        fs      $nearest3_2,$cz_2,$oz_2                 # 41e
        lqd     $oy_4,80($a_packet_2)                   # 41o

        fs      $nearest2_4,$cy_2,$oy_3                 # 42e
        lqd     $dy_4,256($a_packet_2)                  # 42o

        fma     $b_2,$nearest2_2,$dy_2,$b_2             # 43e
        lqd     $dz_2,352($a_packet_2)                  # 43o

        fm      $b_4,$nearest1_3,$dx_3                  # 44e
        lqd     $oz_4,176($a_packet_2)                  # 44o

        fm      $b_5,$nearest1_4,$dx_4                  # 45e
        lqd     $dy_5,272($a_packet_2)                  # 45o

        fs      $nearest3_3,$cz_2,$oz_3                 # 46e
        lqd     $oz_5,144($a_packet_2)                  # 46o

        fs      $nearest2_5,$cy_2,$oy_4                 # 47e
        lqd     $dz_3,320($a_packet_2)                  # 47o

        fma     $b_3,$nearest2_3,$dy_4,$b_3             # 48e
        lqd     $dz_4,368($a_packet_2)                  # 48o

        fma     $b,$nearest3_2,$dz_2,$b_2               # 49e
        shufb   $radius2_2,$sides,$sides,$m_x           # 49o

        fs      $nearest3_4,$cz_2,$oz_4                 # 50e
        lqd     $dz_5,336($a_packet_2)                  # 50o

        fma     $b_4,$nearest2_4,$dy_3,$b_4             # 51e
        rotqbyi $sides,$sides,12                        # 51o

        fs      $nearest3_5,$cz_2,$oz_5                 # 52e
        rotqbyi $a_packet_3,$object_3,4                 # 52o

        fma     $b_5,$nearest2_5,$dy_5,$b_5             # 53e
        shufb   $cx_3,$quad_3,$quad_3,$m_x              # 53o

        fma     $b_3,$nearest3_3,$dz_3,$b_3             # 54e
        lqd     $t_best,416($a_packet_2)                # 54o

        fm      $radius2_2,$radius2_2,$radius2_2        # 55e
        lqd     $t_best_2,384($a_packet_2)              # 55o

        fnms    $nearest+1,$b,$dx_2,$nearest+1          # 56e
        lqd     $ox_4,32($a_packet_3)                   # 56o

        fma     $b_6,$nearest3_4,$dz_4,$b_4             # 57e
        lqd     $ox_5,16($a_packet_3)                   # 57o

        fnms    $nearest2_6,$b,$dy_2,$nearest2_2        # 58e
        lqd     $ox_6,0($a_packet_3)                    # 58o

        fma     $b_2,$nearest3_5,$dz_5,$b_5             # 59e
        lqd     $ox_7,48($a_packet_3)                   # 59o

        fnms    $nearest1_2,$b_3,$dx,$nearest1_2        # 60e
        lqd     $dx,192($a_packet_3)                    # 60o

        fnms    $nearest2_3,$b_3,$dy_4,$nearest2_3      # 61e
        lqd     $oy_2,96($a_packet_3)                   # 61o

        fnms    $b1_2,$nearest+1,$nearest+1,$radius2_2  # 62e
        lqd     $dx_2,224($a_packet_3)                  # 62o

        fnms    $nearest1_3,$b_6,$dx_3,$nearest1_3      # 63e
        lqd     $oy_5,64($a_packet_3)                   # 63o

        fnms    $nearest2_4,$b_6,$dy_3,$nearest2_4      # 64e
        lqd     $dx_5,208($a_packet_3)                  # 64o

        fnms    $nearest1_4,$b_2,$dx_4,$nearest1_4      # 65e
        lqd     $oy_6,112($a_packet_3)                  # 65o

        fnms    $b1_3,$nearest1_2,$nearest1_2,$radius2_2 # 66e
        lqd     $oy_7,80($a_packet_3)                   # 66o

        fnms    $nearest3_2,$b,$dz_2,$nearest3_2        # 67e
        lqd     $dx_6,240($a_packet_3)                  # 67o

        fnms    $b1_4,$nearest2_6,$nearest2_6,$b1_2     # 68e
        shufb   $cy_3,$quad_3,$quad_3,$m_y              # 68o

        fnms    $b1_5,$nearest1_3,$nearest1_3,$radius2_2 # 69e
        lqd     $oz_6,128($a_packet_3)                  # 69o

        fnms    $nearest2_5,$b_2,$dy_5,$nearest2_5      # 70e
        lqd     $dy_5,272($a_packet_3)                  # 70o

        fnms    $b1_6,$nearest1_4,$nearest1_4,$radius2_2 # 71e
        lqd     $t_best_3,432($a_packet_2)              # 71o

        fnms    $nearest3_3,$b_3,$dz_3,$nearest3_3      # 72e
        lqd     $oz_7,176($a_packet_3)                  # 72o

        fnms    $b1_3,$nearest2_3,$nearest2_3,$b1_3     # 73e
        lqd     $dy_6,256($a_packet_3)                  # 73o

        fnms    $b1_4,$nearest3_2,$nearest3_2,$b1_4     # 74e
        lqd     $dy_7,304($a_packet_3)                  # 74o

        fnms    $nearest3_4,$b_6,$dz_4,$nearest3_4      # 75e
        lqd     $oz_8,144($a_packet_3)                  # 75o

        fnms    $b1_5,$nearest2_4,$nearest2_4,$b1_5     # 76e
        lqd     $dy_2,288($a_packet_3)                  # 76o

        fnms    $nearest3_6,$b_2,$dz_5,$nearest3_5      # 77e
        lqd     $t_best_4,400($a_packet_2)              # 77o

        rotmi   $sides_2,$sides,-26                     # 78e
        shufb   $cz_3,$quad_3,$quad_3,$m_z              # 78o

        fnms    $b1_3,$nearest3_3,$nearest3_3,$b1_3     # 79e
        lqd     $oz_3,160($a_packet_3)                  # 79o

        fnms    $b1_7,$nearest2_5,$nearest2_5,$b1_6     # 80e
        frsqest $y_2,$b1_4                              # 80o

        fms     $out,$b,$b,$b1_4                        # 81e
        lqd     $dz_2,352($a_packet_3)                  # 81o

        fnms    $b1_5,$nearest3_4,$nearest3_4,$b1_5     # 82e
        lqx     $m_by_side_2,$a_by_side,$sides_2        # 82o

        fs      $nearest1_5,$cx_3,$ox_7                 # 83e
        lqx     $whole_2,$a_half+1,$sides_2             # 83o

        fi      $y_2,$b1_4,$y_2                         # 84e
        lqd     $dz_6,368($a_packet_3)                  # 84o

        nop     $127                                    # 85e pairing
        frsqest $y_3,$b1_3                              # 85o

        fnms    $b1_8,$nearest3_6,$nearest3_6,$b1_7     # 86e
        lqd     $dz_7,336($a_packet_3)                  # 86o

        fms     $out_2,$b_3,$b_3,$b1_3                  # 87e
        lqd     $dz_8,320($a_packet_3)                  # 87o

        fms     $out_3,$b_6,$b_6,$b1_5                  # 88e
        frsqest $y_4,$b1_5                              # 88o

        fi      $y_3,$b1_3,$y_3                         # 89e
        lqd     $sides_3,32($object_3)                  # 89o

        selb    $s_2,$whole_2,$out,$m_by_side_2         # 90e
        lqd     $nearest_2,480($a_packet_2)             # 90o

        fs      $nearest1_6,$cx_3,$ox_4                 # 91e
        shufb   $object_2,$object_2,$object_2,$m_x      # 91o

        fi      $y_5,$b1_5,$y_4                         # 92e
        frsqest $y_6,$b1_8                              # 92o

        selb    $y_2,$y_2,$s_2,$m_sign                  # 93e
        shlqbyi $a_packet_4,$a_packet_2,0               # 93o copy

        selb    $s_2,$whole_2,$out_2,$m_by_side_2       # 94e
        lqd     $nearest_3,496($a_packet_2)             # 94o

        fms     $out_4,$b_2,$b_2,$b1_8                  # 95e
        shufb   $radius2_3,$sides_3,$sides_3,$m_x       # 95o

        fi      $y_6,$b1_8,$y_6                         # 96e
        rotqbyi $sides_3,$sides_3,12                    # 96o

        selb    $y_7,$y_3,$s_2,$m_sign                  # 97e
        lqd     $nearest_4,448($a_packet_2)             # 97o

        fnms    $t_2,$b1_4,$y_2,$b                      # 98e
        lqd     $nearest_5,464($a_packet_2)             # 98o

        selb    $s_3,$whole_2,$out_3,$m_by_side_2       # 99e
        lqx     $half_2,$a_half,$sides_2                # 99o

        fs      $nearest1_7,$cx_3,$ox_6                 # 100e
        shufb   $object_4,$object_3,$object_3,$m_x      # 100o

        fs      $nearest1_8,$cx_3,$ox_5                 # 101e
        fnms    $t_3,$b1_3,$y_7,$b_3                    # 102e

        selb    $y_8,$y_5,$s_3,$m_sign                  # 103e
        cgt     $control_2,$t_best,$t_2                 # 104e

        selb    $s_4,$whole_2,$out_4,$m_by_side_2       # 105e
        cgti    $ahead_2,$t_2,0                         # 106e

        fm      $b_3,$nearest1_6,$dx_2                  # 107e
        and     $control_2,$control_2,$ahead_2          # 108e

        fs      $nearest2_5,$cy_3,$oy_7                 # 109e
        fs      $nearest2_2,$cy_3,$oy_2                 # 110e

        fnms    $t_4,$b1_5,$y_8,$b_6                    # 111e
        fs      $nearest2_7,$cy_3,$oy_6                 # 112e

        selb    $y_9,$y_6,$s_4,$m_sign                  # 113e
        fm      $b_7,$nearest1_7,$dx                    # 114e

        fnms    $t_5,$b1_8,$y_9,$b_2                    # 115e
        fm      $b_8,$nearest1_8,$dx_5                  # 116e

        fs      $nearest2_8,$cy_3,$oy_5                 # 117e
        andc    $control_3,$control_2,$b1_4             # 118e

        fm      $b_9,$nearest1_5,$dx_6                  # 119e
        lnop                                            # 119o pairing

        cgti    $ahead,$t_3,0                           # 120e
        rotqbii $control_3,$control_3,1                 # 120o

        cgt     $control_2,$t_best_2,$t_3               # 121e
        cgt     $control_4,$t_best_3,$t_4               # 122e

        fma     $b_7,$nearest2_8,$dy_6,$b_7             # 123e
        lnop                                            # 123o pairing

        cgti    $ahead_3,$t_4,0                         # 124e
        gb      $control_3,$control_3                   # 124o

        and     $control_2,$control_2,$ahead            # 125e
        and     $control_5,$control_4,$ahead_3          # 126e

        andc    $control_6,$control_2,$b1_3             # 127e
        lnop                                            # 127o pairing

        fs      $nearest3_5,$cz_3,$oz_3                 # 128e
        shlqbii $control_3,$control_3,4                 # 128o

        fs      $nearest3_7,$cz_3,$oz_6                 # 129e
        rotqbii $control_6,$control_6,1                 # 129o

        fma     $b_9,$nearest2_7,$dy_7,$b_9             # 130e
        cgti    $ahead_4,$t_5,0                         # 131e

        fs      $nearest3_8,$cz_3,$oz_8                 # 132e
        lqx     $control_3,$control_3,$a_controls       # 132o

        fma     $b_8,$nearest2_5,$dy_5,$b_8             # 133e
        gb      $control_6,$control_6                   # 133o

        fma     $b_10,$nearest2_2,$dy_2,$b_3            # 134e
        fs      $nearest3_9,$cz_3,$oz_7                 # 135e

        cgt     $control_7,$t_best_4,$t_5               # 136e
        lnop                                            # 136o pairing

        andc    $control_8,$control_5,$b1_5             # 137e
        shlqbii $control_6,$control_6,4                 # 137o

        and     $control_2,$control_7,$ahead_4          # 138e
        shufb   $t_best,$t_best,$t_2,$control_3         # 138o

        fma     $b_2,$nearest3_8,$dz_7,$b_8             # 139e
        rotqbii $control_8,$control_8,1                 # 139o

        fma     $b_3,$nearest3_7,$dz_8,$b_7             # 140e
        shufb   $nearest_6,$nearest_2,$object_2,$control_3 # 140o

        fma     $b_11,$nearest3_9,$dz_6,$b_9            # 141e
        lqx     $control_6,$control_6,$a_controls       # 141o

        andc    $control_9,$control_2,$b1_8             # 142e
        lnop                                            # 142o pairing

        fma     $b,$nearest3_5,$dz_2,$b_10              # 143e
        gb      $control_8,$control_8                   # 143o

        fm      $radius2_4,$radius2_3,$radius2_3        # 144e
        rotqbii $control_9,$control_9,1                 # 144o

        fnms    $nearest1_8,$b_2,$dx_5,$nearest1_8      # 145e
        fnms    $nearest1_7,$b_3,$dx,$nearest1_7        # 146e

        fnms    $nearest1_9,$b_11,$dx_6,$nearest1_5     # 147e
        shlqbii $control_8,$control_8,4                 # 147o

        rotmi   $sides_2,$sides_3,-26                   # 148e
        gb      $control_9,$control_9                   # 148o

        fnms    $nearest1_6,$b,$dx_2,$nearest1_6        # 149e
        shufb   $t_best_5,$t_best_2,$t_3,$control_6     # 149o

        fnms    $nearest2_9,$b,$dy_2,$nearest2_2        # 150e
        shufb   $nearest_7,$nearest_4,$object_2,$control_6 # 150o

        fnms    $nearest2_3,$b_3,$dy_6,$nearest2_8      # 151e
        lqx     $control_8,$control_8,$a_controls       # 151o

        fnms    $b1_9,$nearest1_7,$nearest1_7,$radius2_4 # 152e
        shlqbii $control_9,$control_9,4                 # 152o

        fnms    $b1_10,$nearest1_9,$nearest1_9,$radius2_4 # 153e
        lqx     $whole_3,$a_half+1,$sides_2             # 153o

        fnms    $b1_11,$nearest1_8,$nearest1_8,$radius2_4 # 154e
        lqx     $m_by_side_3,$a_by_side,$sides_2        # 154o

        fnms    $nearest2_8,$b_2,$dy_5,$nearest2_5      # 155e
        stqd    $t_best,416($a_packet_4)                # 155o

        fnms    $nearest2_7,$b_11,$dy_7,$nearest2_7     # 156e
        lqx     $control_10,$control_9,$a_controls      # 156o

        fnms    $b1_2,$nearest1_6,$nearest1_6,$radius2_4 # 157e
        shufb   $nearest_8,$nearest_3,$object_2,$control_8 # 157o

        fnms    $nearest3_10,$b_3,$dz_8,$nearest3_7     # 158e
        stqd    $nearest_6,480($a_packet_4)             # 158o

        fnms    $b1_4,$nearest2_3,$nearest2_3,$b1_9     # 159e
        shufb   $t_best_6,$t_best_3,$t_4,$control_8     # 159o

        fnms    $nearest+3,$b_2,$dz_7,$nearest3_8       # 160e
        stqd    $t_best_5,384($a_packet_4)              # 160o

        fnms    $nearest3_11,$b_11,$dz_6,$nearest3_9    # 161e
        lqd     $t_best_2,384($a_packet_3)              # 161o

        fnms    $b1_11,$nearest2_8,$nearest2_8,$b1_11   # 162e
        stqd    $nearest_8,496($a_packet_4)             # 162o

        fnms    $b1_12,$nearest2_9,$nearest2_9,$b1_2    # 163e
        stqd    $nearest_7,448($a_packet_4)             # 163o

        fnms    $nearest3_9,$b,$dz_2,$nearest3_5        # 164e
        stqd    $t_best_6,432($a_packet_4)              # 164o

        fnms    $b1_5,$nearest2_7,$nearest2_7,$b1_10    # 165e
        shufb   $nearest,$nearest_5,$object_2,$control_10 # 165o

        fnms    $b1_13,$nearest3_10,$nearest3_10,$b1_4  # 166e
        lqd     $nearest_9,480($a_packet_3)             # 166o

        shufb   $t_best,$t_best_4,$t_5,$control_10      # 167o
        fnms    $b1_8,$nearest+3,$nearest+3,$b1_11      # 168e

        stqd    $nearest,464($a_packet_4)               # 169o
        fnms    $b1_14,$nearest3_9,$nearest3_9,$b1_12   # 170e

        fnms    $b1_15,$nearest3_11,$nearest3_11,$b1_5  # 171e
        lnop                                            # 171o pairing

next_ball:
        ai      $count,$count,-1                        # 0e
            lqd     $nearest,496($a_packet_3)           # 0o

            fms     $out,$b_3,$b_3,$b1_13               # 1e
            frsqest $y,$b1_13                           # 1o

            fms     $out_5,$b_2,$b_2,$b1_8              # 2e
            stqd    $t_best,400($a_packet_4)            # 2o

            nop     $127                                # 3e pairing
            shlqbyi $a_packet_4,$a_packet_3,0           # 3o copy

            fms     $out_6,$b,$b,$b1_14                 # 4e
            frsqest $y_10,$b1_8                         # 4o

            fms     $out_7,$b_11,$b_11,$b1_15           # 5e
            lqd     $nearest_10,464($a_packet_3)        # 5o

            fi      $y,$b1_13,$y                        # 6e
            frsqest $y_11,$b1_14                        # 6o

            selb    $s,$whole_3,$out,$m_by_side_3       # 7e
            frsqest $y_12,$b1_15                        # 7o

            fi      $y_10,$b1_8,$y_10                   # 8e
        lqd     $object_2,0($a_candidate)               # 8o

            selb    $s_5,$whole_3,$out_5,$m_by_side_3   # 9e
            lqd     $nearest_8,448($a_packet_3)         # 9o

            fi      $y_11,$b1_14,$y_11                  # 10e
            lqd     $t_best,416($a_packet_3)            # 10o

            fi      $y_12,$b1_15,$y_12                  # 11e
            lqd     $t_best_7,400($a_packet_3)          # 11o

            selb    $s_6,$whole_3,$out_6,$m_by_side_3   # 12e
            lqd     $t_best_8,432($a_packet_3)          # 12o

            selb    $y,$y,$s,$m_sign                    # 13e
            lnop                                        # 13o pairing

            selb    $s,$whole_3,$out_7,$m_by_side_3     # 14e
        lqd     $quad_2,0($object_2)                    # 14o

            selb    $y_13,$y_10,$s_5,$m_sign            # 15e
        rotqbyi $a_packet_3,$object_2,4                 # 15o

            fnms    $t,$b1_13,$y,$b_3                   # 16e
            selb    $y,$y_11,$s_6,$m_sign               # 17e

            fnms    $t_6,$b1_8,$y_13,$b_2               # 18e
            lnop                                        # 18o pairing

            selb    $y_14,$y_12,$s,$m_sign              # 19e
        lqd     $ox,32($a_packet_3)                     # 19o

            fnms    $t_7,$b1_14,$y,$b                   # 20e
        shufb   $cx_2,$quad_2,$quad_2,$m_x              # 20o

            fnms    $t_8,$b1_15,$y_14,$b_11             # 21e
            lnop                                        # 21o pairing

            cgti    $ahead,$t,0                         # 22e
        lqd     $sides,32($object_2)                    # 22o

            cgt     $control,$t_best_2,$t               # 23e
        lqd     $ox_2,0($a_packet_3)                    # 23o

            cgti    $ahead_5,$t_6,0                     # 24e
        lqd     $ox_3,48($a_packet_3)                   # 24o

        fs      $nearest+1,$cx_2,$ox                    # 25e
        lqd     $ox,16($a_packet_3)                     # 25o

            cgt     $control_11,$t_best_7,$t_6          # 26e
        lqd     $oy,64($a_packet_3)                     # 26o

            cgt     $control_12,$t_best_8,$t_8          # 27e
        lqd     $dx,192($a_packet_3)                    # 27o

            cgti    $ahead_6,$t_8,0                     # 28e
        lqd     $dx_4,208($a_packet_3)                  # 28o

            cgt     $control_13,$t_best,$t_7            # 29e
        lqd     $oy_2,96($a_packet_3)                   # 29o

            cgti    $ahead_4,$t_7,0                     # 30e
        lqd     $dx_2,224($a_packet_3)                  # 30o

            and     $control_3,$control_11,$ahead_5     # 31e
        lqd     $oy_3,112($a_packet_3)                  # 31o

            and     $control_13,$control_13,$ahead_4    # 32e
        shufb   $cy_2,$quad_2,$quad_2,$m_y              # 32o

            and     $control_12,$control_12,$ahead_6    # 33e
        lqd     $dx_3,240($a_packet_3)                  # 33o

            andc    $control_13,$control_13,$b1_14      # 34e
        lqd     $oy_4,80($a_packet_3)                   # 34o

        fs      $nearest1_2,$cx_2,$ox_2                 # 35e
        shufb   $cz_2,$quad_2,$quad_2,$m_z              # 35o

        fs      $nearest1_4,$cx_2,$ox                   # 36e
        lqd     $dy_4,256($a_packet_3)                  # 36o

        fs      $nearest1_10,$cx_2,$ox_3                # 37e
        lqd     $oz_2,160($a_packet_3)                  # 37o

            and     $control,$control,$ahead            # 38e
        shufb   $radius2_2,$sides,$sides,$m_x           # 38o

        fm      $b_2,$nearest+1,$dx_2                   # 39e
        rotqbyi $sides,$sides,12                        # 39o

            andc    $control_12,$control_12,$b1_15      # 40e
        lqd     $oz_3,128($a_packet_3)                  # 40o

        fm      $b_3,$nearest1_2,$dx                    # 41e
        lqd     $dy_5,272($a_packet_3)                  # 41o

            andc    $control,$control,$b1_13            # 42e
        lqd     $dy_3,304($a_packet_3)                  # 42o

        fm      $b_5,$nearest1_4,$dx_4                  # 43e
        lqd     $oz_5,144($a_packet_3)                  # 43o

        fs      $nearest2_3,$cy_2,$oy                   # 44e
            rotqbii $control,$control,1                 # 44o

        fs      $nearest2_5,$cy_2,$oy_4                 # 45e
            rotqbii $control_13,$control_13,1           # 45o

        fs      $nearest2_4,$cy_2,$oy_3                 # 46e
        lqd     $dy_2,288($a_packet_3)                  # 46o

        fs      $nearest2_2,$cy_2,$oy_2                 # 47e
        lqd     $oz_9,176($a_packet_3)                  # 47o

        fm      $b_4,$nearest1_10,$dx_3                 # 48e
            rotqbii $control_12,$control_12,1           # 48o

        fs      $nearest3_2,$cz_2,$oz_2                 # 49e
        lqd     $dz_5,336($a_packet_3)                  # 49o

        fma     $b_3,$nearest2_3,$dy_4,$b_3             # 50e
        lqd     $dz_3,320($a_packet_3)                  # 50o

        fs      $nearest3_3,$cz_2,$oz_3                 # 51e
            gb      $control,$control                   # 51o

        fma     $b_5,$nearest2_5,$dy_5,$b_5             # 52e
            gb      $control_12,$control_12             # 52o

        fma     $b_2,$nearest2_2,$dy_2,$b_2             # 53e
        lqd     $dz_2,352($a_packet_3)                  # 53o

        fma     $b_4,$nearest2_4,$dy_3,$b_4             # 54e
            gb      $control_13,$control_13             # 54o

        fs      $nearest3_5,$cz_2,$oz_5                 # 55e
            shlqbii $control,$control,4                 # 55o

        fm      $radius2_2,$radius2_2,$radius2_2        # 56e
            shlqbii $control_12,$control_12,4           # 56o

        fma     $b_3,$nearest3_3,$dz_3,$b_3             # 57e
            lqx     $half_2,$a_half,$sides_2            # 57o

        rotmi   $sides_2,$sides,-26                     # 58e
        lqd     $dz_9,368($a_packet_3)                  # 58o

        fs      $nearest3_11,$cz_2,$oz_9                # 59e
            shlqbii $control_13,$control_13,4           # 59o

        fma     $b,$nearest3_2,$dz_2,$b_2               # 60e
            lqx     $control,$control,$a_controls       # 60o

        fma     $b_2,$nearest3_5,$dz_5,$b_5             # 61e
            lqx     $control_12,$control_12,$a_controls # 61o

            andc    $control_3,$control_3,$b1_8         # 62e
            lnop                                        # 62o pairing

        fnms    $nearest1_2,$b_3,$dx,$nearest1_2        # 63e
        hbrr    next_ball_back,next_ball                # 63o hint

        fnms    $nearest3_12,$b_3,$dz_3,$nearest3_3     # 64e
            rotqbii $control_3,$control_3,1             # 64o

        fma     $b_11,$nearest3_11,$dz_9,$b_4           # 65e
            lqx     $control_13,$control_13,$a_controls # 65o

        fnms    $nearest+1,$b,$dx_2,$nearest+1          # 66e
        lqx     $m_by_side_3,$a_by_side,$sides_2        # 66o

        fnms    $nearest2_3,$b_3,$dy_4,$nearest2_3      # 67e
            shufb   $t_best_9,$t_best_8,$t_8,$control_12 # 67o

        fnms    $nearest1_11,$b_2,$dx_4,$nearest1_4     # 68e
            gb      $control_3,$control_3               # 68o

        fnms    $b1_3,$nearest1_2,$nearest1_2,$radius2_2 # 69e
            shufb   $nearest_8,$nearest_8,$object_4,$control # 69o

        fnms    $nearest2_10,$b,$dy_2,$nearest2_2       # 70e
        lqx     $whole_3,$a_half+1,$sides_2             # 70o

        fnms    $nearest1_10,$b_11,$dx_3,$nearest1_10   # 71e
            shufb   $t_best,$t_best,$t_7,$control_13    # 71o

        fnms    $nearest2_11,$b_2,$dy_5,$nearest2_5     # 72e
            shlqbii $control_3,$control_3,4             # 72o

        fnms    $nearest2_4,$b_11,$dy_3,$nearest2_4     # 73e
            shufb   $t_best_10,$t_best_2,$t,$control    # 73o

        fnms    $b1_16,$nearest1_11,$nearest1_11,$radius2_2 # 74e
            shufb   $nearest_11,$nearest_9,$object_4,$control_13 # 74o

        fnms    $b1_2,$nearest+1,$nearest+1,$radius2_2  # 75e
            stqd    $t_best,416($a_packet_4)            # 75o

        fnms    $b1_3,$nearest2_3,$nearest2_3,$b1_3     # 76e
            lqx     $control,$control_3,$a_controls     # 76o

        fnms    $b1_12,$nearest1_10,$nearest1_10,$radius2_2 # 77e
            shufb   $nearest,$nearest,$object_4,$control_12 # 77o

        fnms    $nearest+3,$b_2,$dz_5,$nearest3_5       # 78e
            stqd    $nearest_11,480($a_packet_4)        # 78o

        fnms    $nearest3_11,$b_11,$dz_9,$nearest3_11   # 79e
            stqd    $t_best_10,384($a_packet_4)         # 79o

        fnms    $b1_5,$nearest2_11,$nearest2_11,$b1_16  # 80e
        lqd     $t_best_2,384($a_packet_3)              # 80o

        fnms    $b1_16,$nearest2_10,$nearest2_10,$b1_2  # 81e
            stqd    $nearest,496($a_packet_4)           # 81o

        fnms    $nearest3_9,$b,$dz_2,$nearest3_2        # 82e
            stqd    $nearest_8,448($a_packet_4)         # 82o

        fnms    $b1_12,$nearest2_4,$nearest2_4,$b1_12   # 83e
            stqd    $t_best_9,432($a_packet_4)          # 83o

        fnms    $b1_13,$nearest3_12,$nearest3_12,$b1_3  # 84e
            shufb   $nearest,$nearest_10,$object_4,$control # 84o

        ai      $a_candidate,$a_candidate,16            # 85e
        lqd     $nearest_9,480($a_packet_3)             # 85o

        fnms    $b1_8,$nearest+3,$nearest+3,$b1_5       # 86e
        shufb   $object_4,$object_2,$object_2,$m_x      # 86o

            nop     $127                                # 87e pairing
            shufb   $t_best,$t_best_7,$t_6,$control     # 87o

        fnms    $b1_14,$nearest3_9,$nearest3_9,$b1_16   # 88e
            stqd    $nearest,464($a_packet_4)           # 88o

        fnms    $b1_15,$nearest3_11,$nearest3_11,$b1_12 # 89e
next_ball_back:
        brnz    $count,next_ball                        # 89o

next_ball_drain:
        fms     $out,$b_3,$b_3,$b1_13                   # 0e
        frsqest $y,$b1_13                               # 0o

        fms     $out_6,$b,$b,$b1_14                     # 1e
        frsqest $y_11,$b1_14                            # 1o

        fms     $out_5,$b_2,$b_2,$b1_8                  # 2e
        frsqest $y_10,$b1_8                             # 2o

        fms     $out_7,$b_11,$b_11,$b1_15               # 3e
        frsqest $y_12,$b1_15                            # 3o

        fi      $y,$b1_13,$y                            # 4e
        lqd     $nearest,496($a_packet_3)               # 4o

        fi      $y_11,$b1_14,$y_11                      # 5e
        stqd    $t_best,400($a_packet_4)                # 5o

        fi      $y_10,$b1_8,$y_10                       # 6e
        lqd     $t_best,416($a_packet_3)                # 6o

        selb    $s,$whole_3,$out,$m_by_side_3           # 7e
        lqd     $t_best_8,432($a_packet_3)              # 7o

        selb    $s_6,$whole_3,$out_6,$m_by_side_3       # 8e
        lqd     $t_best_7,400($a_packet_3)              # 8o

        selb    $s_5,$whole_3,$out_5,$m_by_side_3       # 9e
        lqd     $nearest_8,448($a_packet_3)             # 9o

        fi      $y_12,$b1_15,$y_12                      # 10e
        shlqbyi $a_packet_4,$a_packet_3,0               # 10o copy

        selb    $y,$y,$s,$m_sign                        # 11e
        hbr     isect_ball_pairs_interpolated_r16_return,$lr # 11o hint

        selb    $s,$whole_3,$out_7,$m_by_side_3         # 12e
        lqd     $nearest_10,464($a_packet_3)            # 12o

        fnms    $t,$b1_13,$y,$b_3                       # 13e
        lqx     $half_2,$a_half,$sides_2                # 13o

        selb    $y,$y_11,$s_6,$m_sign                   # 14e
        selb    $y_13,$y_10,$s_5,$m_sign                # 15e

        fnms    $t_7,$b1_14,$y,$b                       # 16e
        selb    $y_14,$y_12,$s,$m_sign                  # 17e

        fnms    $t_6,$b1_8,$y_13,$b_2                   # 18e
        fnms    $t_8,$b1_15,$y_14,$b_11                 # 19e

        cgti    $ahead,$t,0                             # 20e
        cgt     $control,$t_best_2,$t                   # 21e

        cgt     $control_13,$t_best,$t_7                # 22e
        cgti    $ahead_4,$t_7,0                         # 23e

        and     $control,$control,$ahead                # 24e
        and     $control_13,$control_13,$ahead_4        # 25e

        cgt     $control_12,$t_best_8,$t_8              # 26e
        andc    $control_13,$control_13,$b1_14          # 27e

        cgti    $ahead_6,$t_8,0                         # 28e
        lnop                                            # 28o pairing

        andc    $control,$control,$b1_13                # 29e
        rotqbii $control_13,$control_13,1               # 29o

        and     $control_12,$control_12,$ahead_6        # 30e
        lnop                                            # 30o pairing

        cgti    $ahead_5,$t_6,0                         # 31e
        rotqbii $control,$control,1                     # 31o

        andc    $control_12,$control_12,$b1_15          # 32e
        lnop                                            # 32o pairing

        cgt     $control_11,$t_best_7,$t_6              # 33e
        gb      $control_13,$control_13                 # 33o

        nop     $127                                    # 34e pairing
        rotqbii $control_12,$control_12,1               # 34o

        and     $control_3,$control_11,$ahead_5         # 35e
        gb      $control,$control                       # 35o

        andc    $control_3,$control_3,$b1_8             # 37e
        shlqbii $control_13,$control_13,4               # 37o

        gb      $control_12,$control_12                 # 38o
        rotqbii $control_3,$control_3,1                 # 39o

        shlqbii $control,$control,4                     # 40o
        lqx     $control_13,$control_13,$a_controls     # 41o

        shlqbii $control_12,$control_12,4               # 42o
        gb      $control_3,$control_3                   # 43o

        lqx     $control,$control,$a_controls           # 44o
        lqx     $control_12,$control_12,$a_controls     # 46o

        shufb   $t_best,$t_best,$t_7,$control_13        # 47o
        shlqbii $control_3,$control_3,4                 # 48o

        shufb   $nearest_11,$nearest_9,$object_4,$control_13 # 49o
        shufb   $nearest_8,$nearest_8,$object_4,$control # 50o

        shufb   $t_best_10,$t_best_2,$t,$control        # 51o
        stqd    $t_best,416($a_packet_4)                # 52o

        lqx     $control,$control_3,$a_controls         # 53o
        shufb   $nearest,$nearest,$object_4,$control_12 # 54o

        stqd    $nearest_11,480($a_packet_4)            # 55o
        stqd    $t_best_10,384($a_packet_4)             # 56o

        shufb   $t_best_9,$t_best_8,$t_8,$control_12    # 57o
        stqd    $nearest,496($a_packet_4)               # 58o

        shufb   $nearest,$nearest_10,$object_4,$control # 59o
        shufb   $t_best,$t_best_7,$t_6,$control         # 60o

        stqd    $nearest_8,448($a_packet_4)             # 61o
        stqd    $t_best_9,432($a_packet_4)              # 62o

        stqd    $nearest,464($a_packet_4)               # 63o
        stqd    $t_best,400($a_packet_4)                # 64o

        nop     $127                                    # 65e pairing
isect_ball_pairs_interpolated_r16_return:
        bi      $lr                                     # 65o

next_ball_short:
        ai      $count,$count,-1                        # 0e
        lqd     $object,0($a_candidate)                 # 0o

        ai      $a_candidate,$a_candidate,16            # 1e
        rotqbyi $a_packet,$object,4                     # 6o

        lqd     $quad,0($object)                        # 7o
        lqd     $sides,32($object)                      # 8o

        shufb   $object,$object,$object,$m_x            # 9o
        lqd     $ox,16($a_packet)                       # 10o

        lqd     $ox_8,0($a_packet)                      # 11o
        lqd     $dx,208($a_packet)                      # 12o

        shufb   $cx,$quad,$quad,$m_x                    # 13o
        lqd     $oy,80($a_packet)                       # 14o

        lqd     $dx_7,192($a_packet)                    # 15o
        lqd     $oy_8,64($a_packet)                     # 16o

        fs      $nearest+1,$cx,$ox_8                    # 17e
        shufb   $cy,$quad,$quad,$m_y                    # 17o

        fs      $nearest1_8,$cx,$ox                     # 18e
        lqd     $oz,128($a_packet)                      # 18o

        lqd     $dy,256($a_packet)                      # 19o
        lqd     $ox,32($a_packet)                       # 20o

        fs      $nearest+2,$cy,$oy                      # 21e
        shufb   $cz,$quad,$quad,$m_z                    # 21o

        fs      $nearest2_12,$cy,$oy_8                  # 22e
        lqd     $oz_10,144($a_packet)                   # 22o

        fm      $b,$nearest+1,$dx_7                     # 23e
        lqd     $dy_8,272($a_packet)                    # 23o

        fm      $b_12,$nearest1_8,$dx                   # 24e
        lqd     $ox_9,48($a_packet)                     # 24o

        fs      $nearest+3,$cz,$oz                      # 25e
        lqd     $dz,320($a_packet)                      # 25o

        fs      $nearest1_12,$cx,$ox                    # 26e
        lqd     $dz_10,336($a_packet)                   # 26o

        nop     $127                                    # 27e pairing
        lqd     $oy,96($a_packet)                       # 27o

        fs      $nearest3_13,$cz,$oz_10                 # 28e
        lqd     $dx_8,224($a_packet)                    # 28o

        fma     $b,$nearest2_12,$dy,$b                  # 29e
        lqd     $oy_3,112($a_packet)                    # 29o

        fma     $b_12,$nearest+2,$dy_8,$b_12            # 30e
        lqd     $dx_9,240($a_packet)                    # 30o

        fs      $nearest1_13,$cx,$ox_9                  # 31e
        shufb   $radius2_5,$sides,$sides,$m_x           # 31o

        nop     $127                                    # 32e pairing
        lqd     $oz,176($a_packet)                      # 32o

        fs      $nearest2_3,$cy,$oy                     # 33e
        lqd     $oz_11,160($a_packet)                   # 33o

        fm      $b_13,$nearest1_12,$dx_8                # 34e
        lqd     $dy_9,288($a_packet)                    # 34o

        fma     $b,$nearest+3,$dz,$b                    # 35e
        lqd     $dy_10,304($a_packet)                   # 35o

        fma     $b_12,$nearest3_13,$dz_10,$b_12         # 36e
        lqd     $dz_11,352($a_packet)                   # 36o

        fm      $b_14,$nearest1_13,$dx_9                # 37e
        lqd     $dz_12,368($a_packet)                   # 37o

        fs      $nearest2_13,$cy,$oy_3                  # 38e
        rotqbyi $sides,$sides,12                        # 38o

        fm      $radius2_5,$radius2_5,$radius2_5        # 39e
        lqd     $t_best_11,384($a_packet)               # 39o

        fs      $nearest3_14,$cz,$oz                    # 40e
        lqd     $t_best_12,400($a_packet)               # 40o

        fnms    $nearest+1,$b,$dx_7,$nearest+1          # 41e
        lqd     $t_best_13,432($a_packet)               # 41o

        fnms    $nearest1_8,$b_12,$dx,$nearest1_8       # 42e
        lqd     $t_best_14,416($a_packet)               # 42o

        fnms    $nearest+2,$b_12,$dy_8,$nearest+2       # 43e
        lqd     $nearest_12,448($a_packet)              # 43o

        fs      $nearest3_15,$cz,$oz_11                 # 44e
        lqd     $nearest_13,464($a_packet)              # 44o

        fma     $b_13,$nearest2_3,$dy_9,$b_13           # 45e
        lqd     $nearest_14,496($a_packet)              # 45o

        fma     $b_14,$nearest2_13,$dy_10,$b_14         # 46e
        lqd     $nearest_15,480($a_packet)              # 46o

        fnms    $nearest2_12,$b,$dy,$nearest2_12        # 47e
        fnms    $b1_11,$nearest1_8,$nearest1_8,$radius2_5 # 48e

        fnms    $b1_17,$nearest+1,$nearest+1,$radius2_5 # 49e
        fnms    $nearest+3,$b,$dz,$nearest+3            # 50e

        fma     $b_7,$nearest3_15,$dz_11,$b_13          # 51e
        fma     $b_13,$nearest3_14,$dz_12,$b_14         # 52e

        fnms    $nearest3_13,$b_12,$dz_10,$nearest3_13  # 53e
        fnms    $b1_11,$nearest+2,$nearest+2,$b1_11     # 54e

        fnms    $b1_18,$nearest2_12,$nearest2_12,$b1_17 # 55e
        rotmi   $sides,$sides,-26                       # 56e

        fnms    $nearest+1,$b_7,$dx_8,$nearest1_12      # 57e
        fnms    $nearest1_13,$b_13,$dx_9,$nearest1_13   # 58e

        fnms    $nearest+2,$b_7,$dy_9,$nearest2_3       # 59e
        lnop                                            # 59o pairing

        fnms    $b+1,$nearest3_13,$nearest3_13,$b1_11   # 60e
        lqx     $whole,$a_half+1,$sides                 # 60o

        fnms    $b1_11,$nearest+3,$nearest+3,$b1_18     # 61e
        lqx     $m_by_side_4,$a_by_side,$sides          # 61o

        fnms    $nearest2_11,$b_13,$dy_10,$nearest2_13  # 62e
        lqx     $half,$a_half,$sides                    # 62o

        fnms    $b1_19,$nearest+1,$nearest+1,$radius2_5 # 63e
        fnms    $b1_20,$nearest1_13,$nearest1_13,$radius2_5 # 64e

        fnms    $nearest+3,$b_7,$dz_11,$nearest3_15     # 65e
        lnop                                            # 65o pairing

        fms     $out,$b_12,$b_12,$b+1                   # 66e
        frsqest $y,$b+1                                 # 66o

        fms     $out_8,$b,$b,$b1_11                     # 67e
        frsqest $y_8,$b1_11                             # 67o

        fnms    $nearest3_16,$b_13,$dz_12,$nearest3_14  # 68e
        fnms    $b1_19,$nearest+2,$nearest+2,$b1_19     # 69e

        fnms    $b1_5,$nearest2_11,$nearest2_11,$b1_20  # 70e
        fi      $y_15,$b1_11,$y_8                       # 71e

        fi      $y,$b+1,$y                              # 72e
        selb    $s,$whole,$out_8,$m_by_side_4           # 73e

        selb    $s_7,$whole,$out,$m_by_side_4           # 74e
        fnms    $b1_19,$nearest+3,$nearest+3,$b1_19     # 75e

        fnms    $b1_5,$nearest3_16,$nearest3_16,$b1_5   # 76e
        selb    $y_15,$y_15,$s,$m_sign                  # 78e

        selb    $y,$y,$s_7,$m_sign                      # 79e
        fnms    $t,$b1_11,$y_15,$b                      # 80e

        fnms    $t_5,$b+1,$y,$b_12                      # 81e
        frsqest $y,$b1_19                               # 81o

        fms     $out,$b_13,$b_13,$b1_5                  # 82e
        frsqest $y_15,$b1_5                             # 82o

        fms     $out_8,$b_7,$b_7,$b1_19                 # 83e
        fi      $y,$b1_19,$y                            # 85e

        cgti    $ahead_7,$t,0                           # 86e
        cgt     $control_14,$t_best_12,$t_5             # 87e

        fi      $y_15,$b1_5,$y_15                       # 88e
        cgt     $control_15,$t_best_11,$t               # 89e

        cgti    $ahead_5,$t_5,0                         # 90e
        and     $control_16,$control_15,$ahead_7        # 91e

        and     $control_14,$control_14,$ahead_5        # 92e
        selb    $s,$whole,$out_8,$m_by_side_4           # 93e

        andc    $control_17,$control_14,$b+1            # 94e
        andc    $control_18,$control_16,$b1_11          # 95e

        selb    $y,$y,$s,$m_sign                        # 96e
        rotqbii $control_17,$control_17,1               # 96o

        selb    $s,$whole,$out,$m_by_side_4             # 97e
        rotqbii $control_18,$control_18,1               # 97o

        fnms    $t_8,$b1_19,$y,$b_7                     # 98e
        selb    $y,$y_15,$s,$m_sign                     # 99e

        nop     $127                                    # 100e pairing
        gb      $control_19,$control_17                 # 100o

        fnms    $t_9,$b1_5,$y,$b_13                     # 101e
        gb      $control_18,$control_18                 # 101o

        cgti    $ahead_7,$t_8,0                         # 104e
        shlqbii $control_19,$control_19,4               # 104o

        cgt     $control_14,$t_best_14,$t_8             # 105e
        shlqbii $control_18,$control_18,4               # 105o

        and     $control_16,$control_14,$ahead_7        # 107e
        lnop                                            # 107o pairing

        cgt     $control_14,$t_best_13,$t_9             # 108e
        lqx     $control_19,$control_19,$a_controls     # 108o

        cgti    $ahead_8,$t_9,0                         # 109e
        lqx     $control_18,$control_18,$a_controls     # 109o

        andc    $control_20,$control_16,$b1_19          # 110e
        and     $control_16,$control_14,$ahead_8        # 111e

        rotqbii $control_20,$control_20,1               # 112o
        andc    $control_8,$control_16,$b1_5            # 113e

        shufb   $t_best_15,$t_best_12,$t_5,$control_19  # 114o
        rotqbii $control_8,$control_8,1                 # 115o

        shufb   $t_best_8,$t_best_11,$t,$control_18     # 116o
        shufb   $nearest,$nearest_12,$object,$control_18 # 117o

        gb      $control_18,$control_20                 # 118o
        gb      $control_8,$control_8                   # 119o

        shufb   $nearest_12,$nearest_13,$object,$control_19 # 120o
        stqd    $t_best_8,384($a_packet)                # 121o

        stqd    $t_best_15,400($a_packet)               # 122o
        shlqbii $control_8,$control_8,4                 # 123o

        stqd    $nearest_12,464($a_packet)              # 124o
        shlqbii $control_18,$control_18,4               # 125o

        stqd    $nearest,448($a_packet)                 # 126o
        hbrr    next_ball_short_back,next_ball_short    # 127o hint

        lqx     $control_8,$control_8,$a_controls       # 128o
        lqx     $control_18,$control_18,$a_controls     # 129o

        shufb   $nearest,$nearest_14,$object,$control_8 # 134o
        shufb   $t_best,$t_best_13,$t_9,$control_8      # 135o

        shufb   $nearest_16,$nearest_15,$object,$control_18 # 136o
        shufb   $t_best_16,$t_best_14,$t_8,$control_18  # 137o

        stqd    $nearest,496($a_packet)                 # 138o
        stqd    $t_best,432($a_packet)                  # 139o

        stqd    $nearest_16,480($a_packet)              # 140o
        stqd    $t_best_16,416($a_packet)               # 141o

        nop     $127                                    # 142e pairing
next_ball_short_back:
        brnz    $count,next_ball_short                  # 142o

        nop     $127                                    # 143e pairing
        bi      $lr                                     # 143o
endfunction isect_ball_pairs_interpolated_r16
