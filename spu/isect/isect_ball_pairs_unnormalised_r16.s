# isect_ball_pairs_unnormalised_r16   nearest hit of packets' rays with spheres, rays of any length
#   C       void isect_ball_pairs_unnormalised_r16(const struct candidate *, int count);
#   In      $3 candidates of objects that are spheres, $4 count (0 is none); pointers 16-aligned
#   Out     the candidates' packets: t, object, where a hit has 0 < t < what was there
#   Uses    $2-$79   Saves  -   Stack  0   Calls  -
#   Domain  direction of a length from 2^-20 to 2^20; coordinates and radius below 2^40, radius
#           above 2^-20; t in parts of the direction's length
#   Error   25 ulp of the larger of t and r, origin up to 30 radii from the centre, ray within
#           0.995 r of it
#   Twin    oracle/src/twin/sphere/unnormalised.rs
#
# The steps are those of sphere_tmpl.inc: of the crossings the entry is asked for, with SIDES_EXIT the
# exit, and with SIDES_BOTH the exit of a ray from inside.
# Scheduled by spu schedule from isect_ball_pairs_unnormalised_r16.s

        .include "work_unit.inc"
        .include "macros.inc"
        .include "pairs.inc"
        .include "sphere_tmpl.inc"
        .include "sphere_unnormalised.inc"

        .set    a_candidate,3
        .set    count,4
        # constants
        .set    m_x,10
        .set    m_y,11
        .set    m_z,12
        .set    k_one,13
        .set    a_controls,14
        .set    a_half,15
        .set    a_whole,16
        .set    a_by_side,17
        # the candidate
        .set    object,18
        .set    a_packet,19
        .set    quad,20
        .set    cx,21
        .set    cy,22
        .set    cz,23
        .set    radius2,24
        .set    sides,25
        .set    half,26                                 # 1/2, with the sign that the root gets
        .set    whole,27                                # 1 likewise
        .set    m_by_side,28                            # the sign's bit if a ray's side gives it
        # a row
        .set    ox,29
        .set    oy,30
        .set    oz,31
        .set    dx,32
        .set    dy,33
        .set    dz,34
        .set    t_best,35
        .set    nearest,36
        # temporaries
        .set    fx,37
        .set    fy,38
        .set    fz,39
        .set    lx,37                                   # f
        .set    ly,38
        .set    lz,39
        .set    b,40
        .set    outside,41                              # disc
        .set    disc,41
        .set    out,42
        .set    y,43
        .set    s,44
        .set    e,45
        .set    over_a,46
        .set    t,47
        .set    ahead,48
        .set    control,49

        sign_controls_table
        sides_tables 0x3f000000, 0x3f800000

function isect_ball_pairs_unnormalised_r16
        .set    count_2,79
        .set    object_2,51
        .set    a_packet_2,58
        .set    quad_2,9
        .set    object_3,50
        .set    dx_2,59
        .set    dy_2,61
        .set    dx_3,60
        .set    cx_2,20
        .set    dz_2,76
        .set    oz_2,22
        .set    lx_2,63
        .set    e_2,26
        .set    cz_2,27
        .set    dx_4,66
        .set    dx_5,74
        .set    dy_3,71
        .set    lz_2,68
        .set    ox_2,7
        .set    lx_3,73
        .set    e_3,2
        .set    dy_4,8
        .set    e_4,22
        .set    dz_3,75
        .set    e_5,79
        .set    oz_3,23
        .set    cy_2,28
        .set    lx_4,64
        .set    dz_4,20
        .set    e_6,18
        .set    oy_2,5
        .set    lz_3,70
        .set    oy_3,7
        .set    y_2,23
        .set    b_2,46
        .set    sides_2,9
        .set    lz_4,62
        .set    e_7,78
        .set    t_best_2,52
        .set    ly_2,65
        .set    ly_3,72
        .set    y_3,19
        .set    y_4,22
        .set    radius2_2,67
        .set    t_best_3,55
        .set    b_3,23
        .set    y_5,25
        .set    nearest_2,32
        .set    a_packet_3,54
        .set    nearest_3,56
        .set    nearest_4,57
        .set    nearest_5,53
        .set    ly_4,69
        .set    sides_3,7
        .set    t_best_4,41
        .set    b_4,24
        .set    s_2,27
        .set    b_5,28
        .set    s_3,26
        .set    b_6,19
        .set    b_7,6
        .set    over_a_2,18
        .set    b_8,22
        .set    over_a_3,23
        .set    over_a_4,24
        .set    b_9,25
        .set    sides_4,77
        .set    radius2_3,7
        .set    b_10,21
        .set    m_by_side_2,33
        .set    lx_5,5
        .set    lx_6,6
        .set    ly_5,9
        .set    lx_7,27
        .set    disc_2,28
        .set    ly_6,8
        .set    disc_3,5
        .set    disc_4,2
        .set    lz_5,6
        .set    disc_5,7
        .set    ly_7,26
        .set    lz_6,20
        .set    disc_6,8
        .set    lz_7,22
        .set    disc_7,6
        .set    disc_8,31
        .set    disc_9,36
        .set    disc_10,39
        .set    half_2,24
        .set    disc_11,38
        .set    y_6,6
        .set    y_7,5
        .set    y_8,8
        .set    y_9,18
        .set    y_10,7
        .set    whole_2,23
        .set    s_4,30
        .set    s_5,48
        .set    s_6,9
        .set    e_8,34
        .set    s_7,7
        .set    out_2,6
        .set    out_3,2
        .set    e_9,5
        .set    e_10,6
        .set    e_11,7
        .set    out_4,8
        .set    s_8,8
        .set    s_9,2
        .set    t_2,6
        .set    t_3,5
        .set    t_4,2
        .set    control_2,7
        .set    control_3,9
        .set    ahead_2,19
        .set    control_4,21
        .set    ahead_3,22
        .set    ahead_4,24
        .set    t_best_5,21
        .set    control_5,6
        .set    t_best_6,5
        .set    nearest_6,9
        .set    t_best_7,2
        .set    b_11,2
        .set    dy_5,3
        .set    b_12,4
        .set    dy_6,11
        .set    e_12,8
        .set    dz_5,12
        .set    dz_6,5
        .set    oy_4,26
        .set    oz_4,37
        .set    object_4,10
        .set    a_packet_4,42
        .set    lx_8,20
        .set    s_10,29
        .set    s_11,47
        .set    y_11,49
        .set    y_12,51
        .set    b_13,78
        .set    y_13,28
        .set    over_a_5,29
        .set    over_a_6,6
        .set    b_14,43
        .set    t_5,8
        .set    lz_8,27
        .set    out_5,22
        .set    b_15,37
        .set    lx_9,28
        .set    b_16,34
        .set    radius2_4,37
        .set    lx_10,43
        .set    out_6,45
        .set    over_a_7,44
        .set    s_12,22
        .set    t_6,7
        .set    disc_12,22
        .set    ly_8,23
        .set    ly_9,24
        .set    t_7,18
        .set    lz_9,21
        .set    control_6,30
        .set    ahead_5,31
        .set    control_7,23
        .set    lx_11,30
        .set    disc_13,24
        .set    nearest_7,28
        .set    control_8,31
        .set    lz_10,8
        .set    ahead_6,9
        .set    disc_14,21
        .set    control_9,3
        .set    disc_15,20
        .set    ly_10,11
        .set    t_best_8,12
        .set    lz_11,5
        .set    disc_16,3
        .set    out_7,11
        .set    t_best_9,7
        .set    out_8,5
        .set    y_14,12
        .set    y_15,20
        .set    nearest_8,12
        .set    t_best_10,3
        .set    y_16,9
        .set    s_13,12
        .set    out_9,18
        .set    y_17,21
        .set    e_13,3
        .set    s_14,5
        .set    s_15,3
        .set    control_10,4
        .set    ahead_7,6
        .set    t_8,3
        .set    nearest_9,2
        .set    dx_6,2
        .set    dy_7,5
        .set    dz_7,6
        .set    dx_7,7
        .set    dx_8,9
        .set    ox_3,22
        .set    dy_8,23
        .set    dy_9,24
        .set    oy_5,27
        .set    e_14,28
        .set    cy_3,31
        .set    dz_8,29
        .set    lx_12,22
        .set    dz_9,35
        .set    oz_5,36
        .set    oz_6,38
        .set    cz_3,20
        .set    ox_4,39
        .set    ox_5,41
        .set    b_17,42
        .set    oy_6,43
        .set    ly_11,30
        .set    y_18,44
        .set    ly_12,27
        .set    y_19,46
        .set    oy_7,47
        .set    oz_7,48
        .set    oz_8,49
        .set    radius2_5,50
        .set    lz_12,38
        .set    t_best_11,51
        .set    y_20,52
        .set    lz_13,36
        .set    y_21,53
        .set    t_best_12,54
        .set    s_16,45
        .set    t_best_13,56
        .set    lx_13,41
        .set    lx_14,21
        .set    nearest_10,39
        .set    nearest_11,58
        .set    nearest_12,59
        .set    y_22,45
        .set    ly_13,31
        .set    b_18,47
        .set    b_19,52
        .set    half_3,53
        .set    whole_3,60
        .set    lz_14,48
        .set    m_by_side_3,25
        .set    s_17,28
        .set    radius2_6,49
        .set    lx_15,2
        .set    over_a_8,22
        .set    over_a_9,26
        .set    b_20,32
        .set    ly_14,5
        .set    disc_17,27
        .set    lz_15,33
        .set    lx_16,7
        .set    lz_16,7
        .set    lz_17,9
        .set    out_10,20
        .set    out_11,21
        .set    out_12,23
        .set    y_23,24
        .set    s_18,20
        .set    e_15,9
        .set    control_11,8
        .set    control_12,2
        .set    t_9,20
        .set    ahead_8,21
        .set    control_13,22
        .set    control_14,5
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
        ila     $a_whole,whole_by_sides                 # 10e

        ila     $a_by_side,m_by_sides                   # 11e
        lnop                                            # 11o pairing

        ilhu    $k_one,0x3f80                           # 12e
        brz     $count_2,next_ball_short                # 12o too few passes

        ai      $count,$count,-1                        # 13e
        lqd     $object_2,0($a_candidate)               # 13o

        ai      $a_candidate,$a_candidate,16            # 14e
        ai      $count,$count,-1                        # 15e

        rotqbyi $a_packet_2,$object_2,4                 # 19o
        lqd     $quad_2,0($object_2)                    # 20o

        shufb   $object_3,$object_2,$object_2,$m_x      # 21o
        lqd     $dx_2,208($a_packet_2)                  # 23o

        lqd     $dy_2,272($a_packet_2)                  # 24o
        lqd     $ox,0($a_packet_2)                      # 25o

        lqd     $dx_3,240($a_packet_2)                  # 26o
        shufb   $cx_2,$quad_2,$quad_2,$m_x              # 27o

        nop     $127                                    # 28e pairing
        lqd     $dy,304($a_packet_2)                    # 28o

        fm      $e,$dx_2,$dx_2                          # 29e
        lqd     $dz_2,336($a_packet_2)                  # 29o

        nop     $127                                    # 30e pairing
        lqd     $oz_2,128($a_packet_2)                  # 30o

        fs      $lx_2,$cx_2,$ox                         # 31e
        lqd     $ox,16($a_packet_2)                     # 31o

        fm      $e_2,$dx_3,$dx_3                        # 32e
        shufb   $cz_2,$quad_2,$quad_2,$m_z              # 32o

        lqd     $dx_4,192($a_packet_2)                  # 33o
        lqd     $dx_5,224($a_packet_2)                  # 34o

        fma     $e,$dy_2,$dy_2,$e                       # 35e
        lqd     $dy_3,256($a_packet_2)                  # 35o

        fs      $lz_2,$cz_2,$oz_2                       # 36e
        lqd     $ox_2,32($a_packet_2)                   # 36o

        fs      $lx_3,$cx_2,$ox                         # 37e
        lqd     $dz,368($a_packet_2)                    # 37o

        nop     $127                                    # 38e pairing
        lqd     $ox,48($a_packet_2)                     # 38o

        fm      $e_3,$dx_4,$dx_4                        # 39e
        lqd     $dy_4,288($a_packet_2)                  # 39o

        fm      $e_4,$dx_5,$dx_5                        # 40e
        lqd     $dz_3,320($a_packet_2)                  # 40o

        fma     $e_5,$dz_2,$dz_2,$e                     # 41e
        lqd     $oz_3,160($a_packet_2)                  # 41o

        fma     $e,$dy,$dy,$e_2                         # 42e
        shufb   $cy_2,$quad_2,$quad_2,$m_y              # 42o

        fs      $lx_4,$cx_2,$ox_2                       # 43e
        lqd     $oz,144($a_packet_2)                    # 43o

        fs      $lx,$cx_2,$ox                           # 44e
        lqd     $dz_4,352($a_packet_2)                  # 44o

        fma     $e_3,$dy_3,$dy_3,$e_3                   # 45e
        lqd     $oy,64($a_packet_2)                     # 45o

        fma     $e_6,$dy_4,$dy_4,$e_4                   # 46e
        lqd     $oy_2,96($a_packet_2)                   # 46o

        fs      $lz_3,$cz_2,$oz_3                       # 47e
        lqd     $oy_3,80($a_packet_2)                   # 47o

        fma     $e,$dz,$dz,$e                           # 48e
        frest   $y_2,$e_5                               # 48o

        fm      $b_2,$lx_4,$dx_5                        # 49e
        lqd     $sides_2,32($object_2)                  # 49o

        fs      $lz_4,$cz_2,$oz                         # 50e
        lqd     $oz,176($a_packet_2)                    # 50o

        fma     $e_7,$dz_3,$dz_3,$e_3                   # 51e
        lqd     $object_2,0($a_candidate)               # 51o

        fma     $e_6,$dz_4,$dz_4,$e_6                   # 52e
        lqd     $t_best_2,432($a_packet_2)              # 52o

        fs      $ly_2,$cy_2,$oy                         # 53e
        lqd     $oy,112($a_packet_2)                    # 53o

        fs      $ly_3,$cy_2,$oy_2                       # 54e
        frest   $y_3,$e                                 # 54o

        fi      $y_4,$e_5,$y_2                          # 55e
        shufb   $radius2_2,$sides_2,$sides_2,$m_x       # 55o

        ai      $a_candidate,$a_candidate,16            # 56e
        lqd     $t_best_3,416($a_packet_2)              # 56o

        fm      $b_3,$lx,$dx_3                          # 57e
        frest   $y,$e_7                                 # 57o

        fi      $y_3,$e,$y_3                            # 58e
        frest   $y_5,$e_6                               # 58o

        nop     $127                                    # 59e pairing
        lqd     $nearest_2,448($a_packet_2)             # 59o

        fs      $ly,$cy_2,$oy                           # 60e
        shlqbyi $a_packet_3,$a_packet_2,0               # 60o copy

        fi      $y,$e_7,$y                              # 61e
        lqd     $nearest_3,496($a_packet_2)             # 61o

        fi      $y_5,$e_6,$y_5                          # 62e
        lqd     $nearest_4,480($a_packet_2)             # 62o

        nop     $127                                    # 63e pairing
        lqd     $nearest_5,464($a_packet_2)             # 63o

        fs      $ly_4,$cy_2,$oy_3                       # 64e
        rotqbyi $sides_3,$sides_2,12                    # 64o

        fnms    $s,$e,$y_3,$k_one                       # 65e
        lqd     $t_best,384($a_packet_2)                # 65o

        fm      $b,$lx_2,$dx_4                          # 66e
        lqd     $t_best_4,400($a_packet_2)              # 66o

        fma     $b_3,$ly,$dy,$b_3                       # 67e
        rotqbyi $a_packet_2,$object_2,4                 # 67o

        fm      $b_4,$lx_3,$dx_2                        # 68e
        fs      $lz,$cz_2,$oz                           # 69e

        fnms    $s_2,$e_5,$y_4,$k_one                   # 70e
        lnop                                            # 70o pairing

        fma     $b_5,$ly_3,$dy_4,$b_2                   # 71e
        lqd     $oz,144($a_packet_2)                    # 71o

        fma     $over_a,$s,$y_3,$y_3                    # 72e
        lqd     $oy,64($a_packet_2)                     # 72o

        fnms    $s,$e_6,$y_5,$k_one                     # 73e
        lqd     $ox,0($a_packet_2)                      # 73o

        fma     $b,$ly_2,$dy_3,$b                       # 74e
        fnms    $s_3,$e_7,$y,$k_one                     # 75e

        fma     $b_6,$ly_4,$dy_2,$b_4                   # 76e
        fma     $b_7,$lz,$dz,$b_3                       # 77e

        fma     $over_a_2,$s_2,$y_4,$y_4                # 78e
        fma     $b_8,$lz_3,$dz_4,$b_5                   # 79e

        fma     $b,$lz_2,$dz_3,$b                       # 80e
        fma     $over_a_3,$s_3,$y,$y                    # 81e

        fma     $over_a_4,$s,$y_5,$y_5                  # 82e
        fma     $b_6,$lz_4,$dz_2,$b_6                   # 83e

        fm      $b_9,$b_7,$over_a                       # 84e
        rotmi   $sides_4,$sides_3,-26                   # 85e

        fm      $radius2_3,$radius2_2,$radius2_2        # 86e
        fm      $b,$b,$over_a_3                         # 87e

        fm      $b_10,$b_8,$over_a_4                    # 88e
        fm      $b_6,$b_6,$over_a_2                     # 89e

        fnms    $lx,$b_9,$dx_3,$lx                      # 90e
        lqd     $dx_3,240($a_packet_2)                  # 90o

        fnms    $ly,$b_9,$dy,$ly                        # 91e
        lqx     $m_by_side_2,$a_by_side,$sides_4        # 91o

        fnms    $lz,$b_9,$dz,$lz                        # 92e
        lnop                                            # 92o pairing

        fnms    $lx_5,$b,$dx_4,$lx_2                    # 93e
        lqd     $dx_4,192($a_packet_2)                  # 93o

        fnms    $lx_6,$b_10,$dx_5,$lx_4                 # 94e
        lqd     $dx_5,224($a_packet_2)                  # 94o

        fnms    $ly_5,$b,$dy_3,$ly_2                    # 95e
        lqd     $dy_3,256($a_packet_2)                  # 95o

        fnms    $lx_7,$b_6,$dx_2,$lx_3                  # 96e
        lqd     $dx_2,208($a_packet_2)                  # 96o

        fnms    $disc_2,$lx,$lx,$radius2_3              # 97e
        fnms    $ly_6,$b_10,$dy_4,$ly_3                 # 98e

        fnms    $disc_3,$lx_5,$lx_5,$radius2_3          # 99e
        fnms    $disc_4,$lx_6,$lx_6,$radius2_3          # 100e

        fnms    $lz_5,$b,$dz_3,$lz_2                    # 101e
        lqd     $dz_3,320($a_packet_2)                  # 101o

        fnms    $disc_5,$lx_7,$lx_7,$radius2_3          # 102e
        lnop                                            # 102o pairing

        fnms    $ly_7,$b_6,$dy_2,$ly_4                  # 103e
        lqd     $dy_2,272($a_packet_2)                  # 103o

        fnms    $lz_6,$b_10,$dz_4,$lz_3                 # 104e
        lnop                                            # 104o pairing

        fnms    $disc_3,$ly_5,$ly_5,$disc_3             # 105e
        lqd     $quad_2,0($object_2)                    # 105o

        fnms    $disc_4,$ly_6,$ly_6,$disc_4             # 106e
        fnms    $disc_6,$ly,$ly,$disc_2                 # 107e

        fnms    $lz_7,$b_6,$dz_2,$lz_4                  # 108e
        lqd     $dz_2,336($a_packet_2)                  # 108o

        fnms    $disc_5,$ly_7,$ly_7,$disc_5             # 109e
        fm      $e,$dx_2,$dx_2                          # 110e

        fnms    $disc_3,$lz_5,$lz_5,$disc_3             # 111e
        shufb   $cz_2,$quad_2,$quad_2,$m_z              # 111o

        fnms    $disc_4,$lz_6,$lz_6,$disc_4             # 112e
        shufb   $cx_2,$quad_2,$quad_2,$m_x              # 112o

        fnms    $disc_6,$lz,$lz,$disc_6                 # 113e
        shufb   $cy_2,$quad_2,$quad_2,$m_y              # 113o

        fm      $e_2,$dx_3,$dx_3                        # 114e
        lqd     $sides_2,32($object_2)                  # 114o

        fnms    $disc_7,$lz_7,$lz_7,$disc_5             # 115e
        lqd     $ox_2,32($a_packet_2)                   # 115o

        fs      $lz_4,$cz_2,$oz                         # 116e
        lqd     $oz_2,128($a_packet_2)                  # 116o

        fm      $disc_8,$disc_3,$over_a_3               # 117e
        lqd     $oy_2,96($a_packet_2)                   # 117o

        fm      $disc_9,$disc_4,$over_a_4               # 118e
        lqd     $oz_3,160($a_packet_2)                  # 118o

        fm      $disc_10,$disc_6,$over_a                # 119e
        lqx     $half_2,$a_half,$sides_4                # 119o

        fm      $e_3,$dx_4,$dx_4                        # 120e
        shufb   $radius2_2,$sides_2,$sides_2,$m_x       # 120o

        fm      $disc_11,$disc_7,$over_a_2              # 121e
        lnop                                            # 121o pairing

        fs      $lx_4,$cx_2,$ox_2                       # 122e
        lqd     $oy_3,80($a_packet_2)                   # 122o

        fs      $ly_3,$cy_2,$oy_2                       # 123e
        frsqest $y,$disc_8                              # 123o

        fs      $ly_2,$cy_2,$oy                         # 124e
        frsqest $y_6,$disc_9                            # 124o

        fma     $e,$dy_2,$dy_2,$e                       # 125e
        frsqest $y_7,$disc_10                           # 125o

        fma     $e_3,$dy_3,$dy_3,$e_3                   # 126e
        fi      $y_8,$disc_8,$y                         # 127e

        fi      $y_9,$disc_9,$y_6                       # 128e
        fi      $y,$disc_10,$y_7                        # 129e

        fs      $ly_4,$cy_2,$oy_3                       # 131e
        frsqest $y_10,$disc_11                          # 131o

        fs      $lx_2,$cx_2,$ox                         # 132e
        lqd     $ox,16($a_packet_2)                     # 132o

        fs      $lz_2,$cz_2,$oz_2                       # 133e
        lnop                                            # 133o pairing

        fs      $lz_3,$cz_2,$oz_3                       # 134e
        lqx     $whole_2,$a_whole,$sides_4              # 134o

        fi      $y_7,$disc_11,$y_10                     # 135e
        rotqbyi $sides_3,$sides_2,12                    # 135o

        fm      $s_4,$disc_10,$y                        # 137e
        fm      $b_2,$lx_4,$dx_5                        # 138e

        rotmi   $sides_4,$sides_3,-26                   # 139e
        fma     $e_7,$dz_3,$dz_3,$e_3                   # 140e

        fm      $s_5,$disc_9,$y_9                       # 141e
        fm      $s_6,$disc_11,$y_7                      # 142e

        fnms    $e_8,$s_4,$y,$k_one                     # 143e
        fm      $s_7,$disc_8,$y_8                       # 144e

        fs      $lx_3,$cx_2,$ox                         # 145e
        fms     $out_2,$b,$b,$disc_8                    # 146e

        fma     $e_5,$dz_2,$dz_2,$e                     # 147e
        fm      $e_4,$dx_5,$dx_5                        # 148e

next_ball:
            fms     $out,$b_6,$b_6,$disc_11             # 0e
            frest   $y,$e_7                             # 0o

            fnms    $e,$s_6,$y_7,$k_one                 # 1e
            lnop                                        # 1o pairing

            fms     $out_3,$b_10,$b_10,$disc_9          # 2e
            lqd     $ox,48($a_packet_2)                 # 2o

            selb    $s,$s_7,$out_2,$m_by_side_2         # 3e
            fma     $e_9,$e_8,$half_2,$whole_2          # 4e

            fnms    $e_10,$s_7,$y_8,$k_one              # 5e
            fnms    $e_11,$s_5,$y_9,$k_one              # 6e

            fma     $e,$e,$half_2,$whole_2              # 7e
            fs      $lx,$cx_2,$ox                       # 8e

            fms     $out_4,$b_9,$b_9,$disc_10           # 9e
            selb    $s_6,$s_6,$out,$m_by_side_2         # 10e

            fma     $e_10,$e_10,$half_2,$whole_2        # 11e
            fma     $e_11,$e_11,$half_2,$whole_2        # 12e

            fnms    $t,$s_6,$e,$b_6                     # 13e
            fi      $y,$e_7,$y                          # 14e

            selb    $s_8,$s_4,$out_4,$m_by_side_2       # 15e
            lnop                                        # 15o pairing

            selb    $s_9,$s_5,$out_3,$m_by_side_2       # 16e
            lqd     $dy,304($a_packet_2)                # 16o

            fnms    $t_2,$s,$e_10,$b                    # 17e
            fnms    $t_3,$s_8,$e_9,$b_9                 # 18e

            cgt     $control,$t_best_4,$t               # 19e
            lqd     $dy_4,288($a_packet_2)              # 19o

            cgti    $ahead,$t,0                         # 20e
            fnms    $t_4,$s_9,$e_11,$b_10               # 21e

            fma     $e,$dy,$dy,$e_2                     # 22e
            cgt     $control_2,$t_best,$t_2             # 23e

            cgt     $control_3,$t_best_2,$t_3           # 24e
            lnop                                        # 24o pairing

            fma     $e_6,$dy_4,$dy_4,$e_4               # 25e
            lqd     $dz,368($a_packet_2)                # 25o

            cgti    $ahead_2,$t_2,0                     # 26e
            lqd     $dz_4,352($a_packet_2)              # 26o

            cgt     $control_4,$t_best_3,$t_4           # 27e
            lnop                                        # 27o pairing

            cgti    $ahead_3,$t_4,0                     # 28e
            frest   $y_2,$e_5                           # 28o

            cgti    $ahead_4,$t_3,0                     # 29e
            and     $control_4,$control_4,$ahead_3      # 30e

            fma     $e,$dz,$dz,$e                       # 31e
            lqd     $oy,112($a_packet_2)                # 31o

            fma     $e_6,$dz_4,$dz_4,$e_6               # 32e
            fi      $y_4,$e_5,$y_2                      # 33e

            and     $control_2,$control_2,$ahead_2      # 34e
            and     $control,$control,$ahead            # 35e

            andc    $control_2,$control_2,$disc_8       # 36e
            lnop                                        # 36o pairing

            andc    $control,$control,$disc_11          # 37e
            frest   $y_3,$e                             # 37o

            fs      $ly,$cy_2,$oy                       # 38e
            rotqbii $control_2,$control_2,1             # 38o

            fm      $b,$lx_2,$dx_4                      # 39e
            rotqbii $control,$control,1                 # 39o

            fm      $b_3,$lx,$dx_3                      # 40e
            frest   $y_5,$e_6                           # 40o

            fi      $y_3,$e,$y_3                        # 41e
            lnop                                        # 41o pairing

            and     $control_3,$control_3,$ahead_4      # 42e
            gb      $control_2,$control_2               # 42o

            fm      $b_4,$lx_3,$dx_2                    # 43e
            gb      $control,$control                   # 43o

            andc    $control_3,$control_3,$disc_10      # 44e
            lnop                                        # 44o pairing

            fi      $y_5,$e_6,$y_5                      # 45e
            lqd     $oz,176($a_packet_2)                # 45o

            andc    $control_4,$control_4,$disc_9       # 46e
            shlqbii $control_2,$control_2,4             # 46o

            fma     $b,$ly_2,$dy_3,$b                   # 47e
            rotqbii $control_3,$control_3,1             # 47o

            fnms    $s,$e,$y_3,$k_one                   # 48e
            rotqbii $control_4,$control_4,1             # 48o

            fnms    $s_3,$e_7,$y,$k_one                 # 49e
            shlqbii $control,$control,4                 # 49o

            fma     $b_3,$ly,$dy,$b_3                   # 50e
            lqx     $control_2,$control_2,$a_controls   # 50o

            fs      $lz,$cz_2,$oz                       # 51e
            gb      $control_3,$control_3               # 51o

            fnms    $s_2,$e_5,$y_4,$k_one               # 52e
            gb      $control_4,$control_4               # 52o

            fma     $b,$lz_2,$dz_3,$b                   # 53e
            lqx     $control,$control,$a_controls       # 53o

            fma     $b_5,$ly_3,$dy_4,$b_2               # 54e
            lnop                                        # 54o pairing

            fma     $over_a,$s,$y_3,$y_3                # 55e
            shlqbii $control_3,$control_3,4             # 55o

            fma     $b_6,$ly_4,$dy_2,$b_4               # 56e
            shufb   $nearest,$nearest_2,$object_3,$control_2 # 56o

            fnms    $s,$e_6,$y_5,$k_one                 # 57e
            shufb   $t_best,$t_best,$t_2,$control_2     # 57o

            fma     $b_7,$lz,$dz,$b_3                   # 58e
            shlqbii $control_2,$control_4,4             # 58o

            fma     $over_a_2,$s_2,$y_4,$y_4            # 59e
            shufb   $t_best_5,$t_best_4,$t,$control     # 59o

            fma     $b_8,$lz_3,$dz_4,$b_5               # 60e
            stqd    $nearest,448($a_packet_3)           # 60o

            fma     $over_a_3,$s_3,$y,$y                # 61e
            lqx     $control_3,$control_3,$a_controls   # 61o

            fma     $b_6,$lz_4,$dz_2,$b_6               # 62e
            stqd    $t_best,384($a_packet_3)            # 62o

            fma     $over_a_4,$s,$y_5,$y_5              # 63e
            lqd     $t_best,384($a_packet_2)            # 63o

            fm      $b_9,$b_7,$over_a                   # 64e
            stqd    $t_best_5,400($a_packet_3)          # 64o

        ai      $count,$count,-1                        # 65e
            lqx     $control_5,$control_2,$a_controls   # 65o

            fm      $radius2_3,$radius2_2,$radius2_2    # 66e
            shufb   $nearest,$nearest_5,$object_3,$control # 66o

            fm      $b,$b,$over_a_3                     # 67e
            shufb   $t_best_6,$t_best_2,$t_3,$control_3 # 67o

            fm      $b_6,$b_6,$over_a_2                 # 68e
            lqd     $nearest_2,448($a_packet_2)         # 68o

            fm      $b_10,$b_8,$over_a_4                # 69e
            lqd     $t_best_4,400($a_packet_2)          # 69o

            fnms    $ly,$b_9,$dy,$ly                    # 70e
            stqd    $nearest,464($a_packet_3)           # 70o

            fnms    $lx,$b_9,$dx_3,$lx                  # 71e
            stqd    $t_best_6,432($a_packet_3)          # 71o

            nop     $127                                # 72e pairing
            shufb   $nearest,$nearest_3,$object_3,$control_3 # 72o

            fnms    $lx_5,$b,$dx_4,$lx_2                # 73e
            shufb   $nearest_6,$nearest_4,$object_3,$control_5 # 73o

            fnms    $lz_7,$b_6,$dz_2,$lz_4              # 74e
            shufb   $object_3,$object_2,$object_2,$m_x  # 74o

            fnms    $ly_7,$b_6,$dy_2,$ly_4              # 75e
            shufb   $t_best_7,$t_best_3,$t_4,$control_5 # 75o

            fnms    $lx_6,$b_10,$dx_5,$lx_4             # 76e
            stqd    $nearest,496($a_packet_3)           # 76o

            fnms    $lx_7,$b_6,$dx_2,$lx_3              # 77e
        lqd     $object_2,0($a_candidate)               # 77o

            fnms    $disc_2,$lx,$lx,$radius2_3          # 78e
            stqd    $nearest_6,480($a_packet_3)         # 78o

            fnms    $disc_3,$lx_5,$lx_5,$radius2_3      # 79e
            lqd     $t_best_2,432($a_packet_2)          # 79o

            fnms    $ly_6,$b_10,$dy_4,$ly_3             # 80e
            lqd     $nearest_5,464($a_packet_2)         # 80o

            fnms    $ly_5,$b,$dy_3,$ly_2                # 81e
            stqd    $t_best_7,416($a_packet_3)          # 81o

            fnms    $disc_4,$lx_6,$lx_6,$radius2_3      # 82e
            shlqbyi $a_packet_3,$a_packet_2,0           # 82o copy

            fnms    $lz,$b_9,$dz,$lz                    # 83e
            lqd     $t_best_3,416($a_packet_2)          # 83o

            fnms    $lz_5,$b,$dz_3,$lz_2                # 84e
            lqd     $nearest_3,496($a_packet_2)         # 84o

            fnms    $lz_6,$b_10,$dz_4,$lz_3             # 85e
            lqd     $nearest_4,480($a_packet_2)         # 85o

            fnms    $disc_5,$lx_7,$lx_7,$radius2_3      # 86e
        rotqbyi $a_packet_2,$object_2,4                 # 86o

            fnms    $disc_3,$ly_5,$ly_5,$disc_3         # 87e
        lqd     $quad_2,0($object_2)                    # 87o

            fnms    $disc_4,$ly_6,$ly_6,$disc_4         # 88e
        ai      $a_candidate,$a_candidate,16            # 89e

            fnms    $disc_6,$ly,$ly,$disc_2             # 90e
        lqd     $dx_2,208($a_packet_2)                  # 90o

            fnms    $disc_5,$ly_7,$ly_7,$disc_5         # 92e
        lqd     $dx_3,240($a_packet_2)                  # 92o

            fnms    $disc_3,$lz_5,$lz_5,$disc_3         # 93e
        shufb   $cz_2,$quad_2,$quad_2,$m_z              # 93o

        nop     $127                                    # 94e pairing
        lqd     $oz,144($a_packet_2)                    # 94o

        fm      $e,$dx_2,$dx_2                          # 96e
        lqd     $dy_2,272($a_packet_2)                  # 96o

            fnms    $disc_4,$lz_6,$lz_6,$disc_4         # 97e
        shufb   $cx_2,$quad_2,$quad_2,$m_x              # 97o

        fm      $e_2,$dx_3,$dx_3                        # 98e
        lqd     $ox,0($a_packet_2)                      # 98o

            fnms    $disc_7,$lz_7,$lz_7,$disc_5         # 99e
        lqd     $ox_2,32($a_packet_2)                   # 99o

        fs      $lz_4,$cz_2,$oz                         # 100e
        lqd     $oy,64($a_packet_2)                     # 100o

            fnms    $disc_6,$lz,$lz,$disc_6             # 101e
        shufb   $cy_2,$quad_2,$quad_2,$m_y              # 101o

        fma     $e,$dy_2,$dy_2,$e                       # 102e
        lqd     $sides_2,32($object_2)                  # 102o

            fm      $disc_8,$disc_3,$over_a_3           # 103e
        lqd     $oy_2,96($a_packet_2)                   # 103o

        fs      $lx_2,$cx_2,$ox                         # 104e
        lqd     $oz_2,128($a_packet_2)                  # 104o

        fs      $lx_4,$cx_2,$ox_2                       # 105e
        lqd     $oy_3,80($a_packet_2)                   # 105o

        fs      $ly_2,$cy_2,$oy                         # 106e
        lqd     $oz_3,160($a_packet_2)                  # 106o

            fm      $disc_9,$disc_4,$over_a_4           # 107e
        lqd     $dx_4,192($a_packet_2)                  # 107o

            fm      $disc_10,$disc_6,$over_a            # 108e
        shufb   $radius2_2,$sides_2,$sides_2,$m_x       # 108o

            fm      $disc_11,$disc_7,$over_a_2          # 109e
        lqd     $ox,16($a_packet_2)                     # 109o

        fs      $lz_2,$cz_2,$oz_2                       # 110e
        lnop                                            # 110o pairing

        fs      $ly_4,$cy_2,$oy_3                       # 111e
            frsqest $y,$disc_8                          # 111o

        fs      $lz_3,$cz_2,$oz_3                       # 112e
        lqd     $dy_3,256($a_packet_2)                  # 112o

        fm      $e_3,$dx_4,$dx_4                        # 113e
            frsqest $y_6,$disc_9                        # 113o

        fs      $ly_3,$cy_2,$oy_2                       # 114e
            frsqest $y_7,$disc_10                       # 114o

        fs      $lx_3,$cx_2,$ox                         # 115e
            frsqest $y_10,$disc_11                      # 115o

            fi      $y_8,$disc_8,$y                     # 116e
        hbrr    next_ball_back,next_ball                # 116o hint

            fi      $y_9,$disc_9,$y_6                   # 117e
        lqd     $dx_5,224($a_packet_2)                  # 117o

            fi      $y,$disc_10,$y_7                    # 118e
            fi      $y_7,$disc_11,$y_10                 # 119e

        nop     $127                                    # 120e pairing
        lqd     $dz_3,320($a_packet_2)                  # 120o

        fma     $e_3,$dy_3,$dy_3,$e_3                   # 121e
        lqd     $dz_2,336($a_packet_2)                  # 121o

            fms     $out_2,$b,$b,$disc_8                # 122e
        rotqbyi $sides_3,$sides_2,12                    # 122o

        fm      $e_4,$dx_5,$dx_5                        # 123e
            lqx     $whole_2,$a_whole,$sides_4          # 123o

        fm      $b_2,$lx_4,$dx_5                        # 124e
            lqx     $half_2,$a_half,$sides_4            # 124o

            fm      $s_4,$disc_10,$y                    # 125e
            lqx     $m_by_side_2,$a_by_side,$sides_4    # 125o

        rotmi   $sides_4,$sides_3,-26                   # 126e
        fma     $e_7,$dz_3,$dz_3,$e_3                   # 127e

            fm      $s_6,$disc_11,$y_7                  # 128e
        fma     $e_5,$dz_2,$dz_2,$e                     # 129e

            fm      $s_7,$disc_8,$y_8                   # 130e
            fnms    $e_8,$s_4,$y,$k_one                 # 131e

            fm      $s_5,$disc_9,$y_9                   # 132e
next_ball_back:
        brnz    $count,next_ball                        # 132o

next_ball_drain:
        fm      $b_11,$lx_2,$dx_4                       # 0e
        lqd     $dy_5,304($a_packet_2)                  # 0o

        fm      $b_12,$lx_3,$dx_2                       # 1e
        lqd     $dy_6,288($a_packet_2)                  # 1o

        fnms    $e_12,$s_7,$y_8,$k_one                  # 2e
        lqd     $dz_5,368($a_packet_2)                  # 2o

        fnms    $e,$s_6,$y_7,$k_one                     # 3e
        frest   $y,$e_7                                 # 3o

        fms     $out,$b_6,$b_6,$disc_11                 # 4e
        lqd     $dz_6,352($a_packet_2)                  # 4o

        selb    $s,$s_7,$out_2,$m_by_side_2             # 5e
        frest   $y_6,$e_5                               # 5o

        fma     $e_11,$dy_5,$dy_5,$e_2                  # 6e
        lqd     $ox,48($a_packet_2)                     # 6o

        fma     $e_4,$dy_6,$dy_6,$e_4                   # 7e
        lqd     $oy_4,112($a_packet_2)                  # 7o

        fi      $y,$e_7,$y                              # 8e
        lqd     $oz_4,176($a_packet_2)                  # 8o

        fi      $y_6,$e_5,$y_6                          # 9e
        shufb   $object_4,$object_2,$object_2,$m_x      # 9o

        selb    $s_6,$s_6,$out,$m_by_side_2             # 10e
        shlqbyi $a_packet_4,$a_packet_2,0               # 10o copy

        fma     $b_11,$ly_2,$dy_3,$b_11                 # 11e
        fma     $e_11,$dz_5,$dz_5,$e_11                 # 12e

        fma     $e_4,$dz_6,$dz_6,$e_4                   # 13e
        fs      $lx_8,$cx_2,$ox                         # 14e

        fnms    $s_10,$e_7,$y,$k_one                    # 15e
        fnms    $s_11,$e_5,$y_6,$k_one                  # 16e

        fma     $b_12,$ly_4,$dy_2,$b_12                 # 17e
        lnop                                            # 17o pairing

        fma     $b_11,$lz_2,$dz_3,$b_11                 # 18e
        frest   $y_11,$e_11                             # 18o

        fma     $e_12,$e_12,$half_2,$whole_2            # 19e
        frest   $y_12,$e_4                              # 19o

        fm      $b_13,$lx_8,$dx_3                       # 20e
        fs      $ly_7,$cy_2,$oy_4                       # 21e

        fi      $y_13,$e_11,$y_11                       # 22e
        fi      $y_11,$e_4,$y_12                        # 23e

        fma     $over_a_5,$s_10,$y,$y                   # 25e
        fma     $over_a_6,$s_11,$y_6,$y_6               # 26e

        fma     $b_12,$lz_4,$dz_2,$b_12                 # 27e
        fma     $e,$e,$half_2,$whole_2                  # 28e

        fma     $b_14,$ly_7,$dy_5,$b_13                 # 29e
        fnms    $s_7,$e_11,$y_13,$k_one                 # 30e

        fm      $b_11,$b_11,$over_a_5                   # 31e
        fnms    $t_5,$s,$e_12,$b                        # 32e

        fs      $lz_8,$cz_2,$oz_4                       # 33e
        fnms    $s,$e_4,$y_11,$k_one                    # 34e

        fnms    $e_6,$s_5,$y_9,$k_one                   # 35e
        fms     $out_5,$b_9,$b_9,$disc_10               # 36e

        fma     $b_15,$ly_3,$dy_6,$b_2                  # 37e
        fm      $b_12,$b_12,$over_a_6                   # 38e

        fma     $b,$lz_8,$dz_5,$b_14                    # 39e
        fma     $over_a,$s_7,$y_13,$y_13                # 40e

        fma     $e_11,$e_8,$half_2,$whole_2             # 41e
        fnms    $t,$s_6,$e,$b_6                         # 42e

        cgt     $control_3,$t_best,$t_5                 # 43e
        cgti    $ahead_2,$t_5,0                         # 44e

        fnms    $lx_9,$b_11,$dx_4,$lx_2                 # 45e
        fma     $b_16,$lz_3,$dz_6,$b_15                 # 46e

        fm      $radius2_4,$radius2_2,$radius2_2        # 47e
        fnms    $lx_10,$b_12,$dx_2,$lx_3                # 48e

        fms     $out_6,$b_10,$b_10,$disc_9              # 49e
        fma     $over_a_7,$s,$y_11,$y_11                # 50e

        selb    $s_12,$s_4,$out_5,$m_by_side_2          # 51e
        and     $control_3,$control_3,$ahead_2          # 52e

        fma     $e_6,$e_6,$half_2,$whole_2              # 53e
        cgti    $ahead_2,$t,0                           # 54e

        andc    $control_3,$control_3,$disc_8           # 55e
        fnms    $t_6,$s_12,$e_11,$b_9                   # 56e

        cgt     $control,$t_best_4,$t                   # 57e
        rotqbii $control_3,$control_3,1                 # 57o

        fm      $b_9,$b,$over_a                         # 58e
        and     $control,$control,$ahead_2              # 59e

        fm      $b_6,$b_16,$over_a_7                    # 60e
        lnop                                            # 60o pairing

        fnms    $disc_12,$lx_9,$lx_9,$radius2_4         # 61e
        gb      $control_3,$control_3                   # 61o

        fnms    $ly_8,$b_11,$dy_3,$ly_2                 # 62e
        fnms    $ly_9,$b_12,$dy_2,$ly_4                 # 63e

        fnms    $disc_2,$lx_10,$lx_10,$radius2_4        # 64e
        lnop                                            # 64o pairing

        selb    $s_4,$s_5,$out_6,$m_by_side_2           # 65e
        shlqbii $control_3,$control_3,4                 # 65o

        andc    $control,$control,$disc_11              # 66e
        fnms    $t_7,$s_4,$e_6,$b_10                    # 67e

        fnms    $lx_8,$b_9,$dx_3,$lx_8                  # 68e
        rotqbii $control,$control,1                     # 68o

        fnms    $lz_9,$b_11,$dz_3,$lz_2                 # 69e
        lqx     $control_3,$control_3,$a_controls       # 69o

        cgt     $control_6,$t_best_2,$t_6               # 70e
        cgti    $ahead_5,$t_6,0                         # 71e

        fnms    $disc_12,$ly_8,$ly_8,$disc_12           # 72e
        gb      $control,$control                       # 72o

        and     $control_7,$control_6,$ahead_5          # 73e
        fnms    $lx_11,$b_6,$dx_5,$lx_4                 # 74e

        fnms    $disc_13,$ly_9,$ly_9,$disc_2            # 75e
        shufb   $nearest_7,$nearest_2,$object_3,$control_3 # 75o

        cgt     $control_8,$t_best_3,$t_7               # 76e
        shlqbii $control,$control,4                     # 76o

        andc    $control_7,$control_7,$disc_10          # 77e
        shufb   $t_best,$t_best,$t_5,$control_3         # 77o

        fnms    $lz_10,$b_12,$dz_2,$lz_4                # 78e
        lnop                                            # 78o pairing

        cgti    $ahead_6,$t_7,0                         # 79e
        rotqbii $control_7,$control_7,1                 # 79o

        fnms    $disc_14,$lz_9,$lz_9,$disc_12           # 80e
        lqx     $control,$control,$a_controls           # 80o

        and     $control_3,$control_8,$ahead_6          # 81e
        stqd    $nearest_7,448($a_packet_3)             # 81o

        fnms    $ly,$b_9,$dy_5,$ly_7                    # 82e
        lnop                                            # 82o pairing

        fnms    $disc_2,$lx_8,$lx_8,$radius2_4          # 83e
        gb      $control_9,$control_7                   # 83o

        andc    $control_3,$control_3,$disc_9           # 84e
        fnms    $disc_15,$lx_11,$lx_11,$radius2_4       # 85e

        fnms    $ly_10,$b_6,$dy_6,$ly_3                 # 86e
        rotqbii $control_3,$control_3,1                 # 86o

        fnms    $disc_6,$lz_10,$lz_10,$disc_13          # 87e
        shlqbii $control_9,$control_9,4                 # 87o

        fnms    $lz,$b_9,$dz_5,$lz_8                    # 88e
        shufb   $t_best_8,$t_best_4,$t,$control         # 88o

        fnms    $disc_12,$ly,$ly,$disc_2                # 89e
        shufb   $nearest,$nearest_5,$object_3,$control  # 89o

        fm      $disc_8,$disc_14,$over_a_5              # 90e
        gb      $control_4,$control_3                   # 90o

        fnms    $lz_11,$b_6,$dz_6,$lz_3                 # 91e
        lqx     $control_3,$control_9,$a_controls       # 91o

        fnms    $disc_16,$ly_10,$ly_10,$disc_15         # 92e
        stqd    $t_best,384($a_packet_3)                # 92o

        fm      $disc_11,$disc_6,$over_a_6              # 93e
        lqd     $t_best,384($a_packet_2)                # 93o

        nop     $127                                    # 94e pairing
        shlqbii $control_5,$control_4,4                 # 94o

        fnms    $disc_6,$lz,$lz,$disc_12                # 95e
        stqd    $t_best_8,400($a_packet_3)              # 95o

        fms     $out_7,$b_11,$b_11,$disc_8              # 96e
        frsqest $y,$disc_8                              # 96o

        nop     $127                                    # 97e pairing
        shufb   $t_best_9,$t_best_2,$t_6,$control_3     # 97o

        fnms    $disc_16,$lz_11,$lz_11,$disc_16         # 98e
        lqx     $control_5,$control_5,$a_controls       # 98o

        fms     $out_8,$b_12,$b_12,$disc_11             # 99e
        frsqest $y_14,$disc_11                          # 99o

        fi      $y_15,$disc_8,$y                        # 100e
        lqd     $nearest_2,448($a_packet_2)             # 100o

        nop     $127                                    # 101e pairing
        shufb   $nearest_6,$nearest_3,$object_3,$control_3 # 101o

        fm      $disc_10,$disc_6,$over_a                # 102e
        lqd     $t_best_4,400($a_packet_2)              # 102o

        fi      $y_8,$disc_11,$y_14                     # 103e
        stqd    $nearest,464($a_packet_3)               # 103o

        nop     $127                                    # 104e pairing
        shufb   $nearest_8,$nearest_4,$object_3,$control_5 # 104o

        fm      $disc_9,$disc_16,$over_a_7              # 105e
        shufb   $t_best_10,$t_best_3,$t_7,$control_5    # 105o

        nop     $127                                    # 106e pairing
        stqd    $t_best_9,432($a_packet_3)              # 106o

        fm      $s_7,$disc_8,$y_15                      # 107e
        stqd    $nearest_6,496($a_packet_3)             # 107o

        fms     $out_2,$b_9,$b_9,$disc_10               # 108e
        frsqest $y_16,$disc_10                          # 108o

        nop     $127                                    # 109e pairing
        stqd    $nearest_8,480($a_packet_3)             # 109o

        fm      $s_13,$disc_11,$y_8                     # 110e
        lqd     $t_best_2,432($a_packet_2)              # 110o

        fms     $out_9,$b_6,$b_6,$disc_9                # 111e
        frsqest $y_17,$disc_9                           # 111o

        fi      $y,$disc_10,$y_16                       # 112e
        lqd     $nearest_5,464($a_packet_2)             # 112o

        nop     $127                                    # 113e pairing
        stqd    $t_best_10,416($a_packet_3)             # 113o

        fnms    $e_13,$s_7,$y_15,$k_one                 # 114e
        lqx     $whole_2,$a_whole,$sides_4              # 114o

        fi      $y_16,$disc_9,$y_17                     # 115e
        lqx     $half_2,$a_half,$sides_4                # 115o

        nop     $127                                    # 116e pairing
        lqx     $m_by_side_2,$a_by_side,$sides_4        # 116o

        fnms    $e,$s_13,$y_8,$k_one                    # 117e
        lqd     $t_best_3,416($a_packet_2)              # 117o

        nop     $127                                    # 118e pairing
        lqd     $nearest_3,496($a_packet_2)             # 118o

        fm      $s_4,$disc_10,$y                        # 119e
        lqd     $nearest_4,480($a_packet_2)             # 119o

        hbr     isect_ball_pairs_unnormalised_r16_return,$lr # 120o hint
        fma     $e_13,$e_13,$half_2,$whole_2            # 121e

        fm      $s_5,$disc_9,$y_16                      # 122e
        fma     $e,$e,$half_2,$whole_2                  # 123e

        selb    $s,$s_7,$out_7,$m_by_side_2             # 124e
        fnms    $e_8,$s_4,$y,$k_one                     # 125e

        selb    $s_14,$s_13,$out_8,$m_by_side_2         # 126e
        fnms    $t_4,$s,$e_13,$b_11                     # 127e

        fnms    $e_11,$s_5,$y_16,$k_one                 # 128e
        fnms    $t,$s_14,$e,$b_12                       # 129e

        selb    $s_8,$s_4,$out_2,$m_by_side_2           # 130e
        fma     $e_9,$e_8,$half_2,$whole_2              # 131e

        selb    $s_15,$s_5,$out_9,$m_by_side_2          # 132e
        cgt     $control_10,$t_best,$t_4                # 133e

        cgti    $ahead_7,$t_4,0                         # 134e
        fma     $e_11,$e_11,$half_2,$whole_2            # 135e

        and     $control_10,$control_10,$ahead_7        # 136e
        cgt     $control,$t_best_4,$t                   # 137e

        cgti    $ahead,$t,0                             # 138e
        andc    $control_10,$control_10,$disc_8         # 139e

        fnms    $t_3,$s_8,$e_9,$b_9                     # 140e
        lnop                                            # 140o pairing

        and     $control,$control,$ahead                # 141e
        rotqbii $control_10,$control_10,1               # 141o

        fnms    $t_8,$s_15,$e_11,$b_6                   # 142e
        andc    $control,$control,$disc_11              # 143e

        nop     $127                                    # 144e pairing
        rotqbii $control,$control,1                     # 145o

        cgt     $control_3,$t_best_2,$t_3               # 146e
        gb      $control_2,$control_10                  # 146o

        cgti    $ahead_4,$t_3,0                         # 147e
        cgt     $control_4,$t_best_3,$t_8               # 148e

        cgti    $ahead_3,$t_8,0                         # 149e
        gb      $control,$control                       # 149o

        and     $control_3,$control_3,$ahead_4          # 150e
        shlqbii $control_2,$control_2,4                 # 150o

        and     $control_4,$control_4,$ahead_3          # 151e
        andc    $control_3,$control_3,$disc_10          # 152e

        andc    $control_4,$control_4,$disc_9           # 153e
        shlqbii $control,$control,4                     # 153o

        lqx     $control_2,$control_2,$a_controls       # 154o
        rotqbii $control_3,$control_3,1                 # 155o

        rotqbii $control_4,$control_4,1                 # 156o
        lqx     $control,$control,$a_controls           # 157o

        gb      $control_3,$control_3                   # 159o
        gb      $control_4,$control_4                   # 160o

        shufb   $nearest,$nearest_2,$object_4,$control_2 # 161o
        shufb   $t_best,$t_best,$t_4,$control_2         # 162o

        shlqbii $control_3,$control_3,4                 # 163o
        shufb   $t_best_7,$t_best_4,$t,$control         # 164o

        shlqbii $control_2,$control_4,4                 # 165o
        stqd    $nearest,448($a_packet_4)               # 166o

        lqx     $control_3,$control_3,$a_controls       # 167o
        stqd    $t_best,384($a_packet_4)                # 168o

        stqd    $t_best_7,400($a_packet_4)              # 169o
        lqx     $control_5,$control_2,$a_controls       # 170o

        shufb   $nearest,$nearest_5,$object_4,$control  # 171o
        shufb   $t_best_6,$t_best_2,$t_3,$control_3     # 173o

        shufb   $nearest_9,$nearest_3,$object_4,$control_3 # 174o
        stqd    $nearest,464($a_packet_4)               # 175o

        shufb   $nearest_6,$nearest_4,$object_4,$control_5 # 176o
        shufb   $t_best_10,$t_best_3,$t_8,$control_5    # 177o

        stqd    $t_best_6,432($a_packet_4)              # 178o
        stqd    $nearest_9,496($a_packet_4)             # 179o

        stqd    $nearest_6,480($a_packet_4)             # 180o
        stqd    $t_best_10,416($a_packet_4)             # 181o

        nop     $127                                    # 182e pairing
isect_ball_pairs_unnormalised_r16_return:
        bi      $lr                                     # 182o

next_ball_short:
        ai      $count,$count,-1                        # 0e
        lqd     $object,0($a_candidate)                 # 0o

        ai      $a_candidate,$a_candidate,16            # 1e
        rotqbyi $a_packet,$object,4                     # 6o

        lqd     $quad,0($object)                        # 7o
        lqd     $sides,32($object)                      # 8o

        shufb   $object,$object,$object,$m_x            # 9o
        lqd     $dx,208($a_packet)                      # 10o

        lqd     $dx_6,192($a_packet)                    # 11o
        lqd     $dy,256($a_packet)                      # 12o

        lqd     $dy_7,272($a_packet)                    # 13o
        lqd     $dz,320($a_packet)                      # 14o

        nop     $127                                    # 15e pairing
        lqd     $dz_7,336($a_packet)                    # 15o

        fm      $e,$dx,$dx                              # 16e
        lqd     $dx_7,224($a_packet)                    # 16o

        fm      $e_12,$dx_6,$dx_6                       # 17e
        lqd     $dx_8,240($a_packet)                    # 17o

        lqd     $ox,16($a_packet)                       # 18o
        shufb   $cx,$quad,$quad,$m_x                    # 19o

        lqd     $ox_3,0($a_packet)                      # 20o
        lqd     $dy_8,288($a_packet)                    # 21o

        fma     $e,$dy_7,$dy_7,$e                       # 22e
        lqd     $dy_9,304($a_packet)                    # 22o

        fma     $e_12,$dy,$dy,$e_12                     # 23e
        lqd     $oy,64($a_packet)                       # 23o

        fm      $e_2,$dx_8,$dx_8                        # 24e
        lqd     $oy_5,80($a_packet)                     # 24o

        fm      $e_14,$dx_7,$dx_7                       # 25e
        shufb   $cy_3,$quad,$quad,$m_y                  # 25o

        fs      $lx,$cx,$ox                             # 26e
        lqd     $dz_8,352($a_packet)                    # 26o

        fs      $lx_12,$cx,$ox_3                        # 27e
        lqd     $dz_9,368($a_packet)                    # 27o

        fma     $e,$dz_7,$dz_7,$e                       # 28e
        lqd     $oz_5,144($a_packet)                    # 28o

        fma     $e_12,$dz,$dz,$e_12                     # 29e
        lqd     $oz_6,128($a_packet)                    # 29o

        fma     $e_2,$dy_9,$dy_9,$e_2                   # 30e
        shufb   $cz_3,$quad,$quad,$m_z                  # 30o

        fma     $e_14,$dy_8,$dy_8,$e_14                 # 31e
        lqd     $ox_4,48($a_packet)                     # 31o

        fm      $b,$lx,$dx                              # 32e
        lqd     $ox_5,32($a_packet)                     # 32o

        fm      $b_17,$lx_12,$dx_6                      # 33e
        lqd     $oy_6,96($a_packet)                     # 33o

        fs      $ly_11,$cy_3,$oy                        # 34e
        frest   $y_18,$e                                # 34o

        fs      $ly_12,$cy_3,$oy_5                      # 35e
        frest   $y_19,$e_12                             # 35o

        fma     $e_2,$dz_9,$dz_9,$e_2                   # 36e
        lqd     $oy_7,112($a_packet)                    # 36o

        fma     $e_14,$dz_8,$dz_8,$e_14                 # 37e
        lqd     $oz_7,160($a_packet)                    # 37o

        fi      $y_18,$e,$y_18                          # 38e
        lqd     $oz_8,176($a_packet)                    # 38o

        fi      $y_19,$e_12,$y_19                       # 39e
        shufb   $radius2_5,$sides,$sides,$m_x           # 39o

        nop     $127                                    # 40e pairing
        rotqbyi $sides,$sides,12                        # 40o

        fs      $lz_12,$cz_3,$oz_6                      # 41e
        lqd     $t_best_11,384($a_packet)               # 41o

        fma     $b_17,$ly_11,$dy,$b_17                  # 42e
        frest   $y_20,$e_2                              # 42o

        fs      $lz_13,$cz_3,$oz_5                      # 43e
        frest   $y_21,$e_14                             # 43o

        fma     $b,$ly_12,$dy_7,$b                      # 44e
        lqd     $t_best_12,400($a_packet)               # 44o

        fnms    $s_16,$e,$y_18,$k_one                   # 45e
        lqd     $t_best_3,432($a_packet)                # 45o

        fnms    $s_8,$e_12,$y_19,$k_one                 # 46e
        lqd     $t_best_13,416($a_packet)               # 46o

        fs      $lx_13,$cx,$ox_5                        # 47e
        lqd     $nearest_4,464($a_packet)               # 47o

        fs      $lx_14,$cx,$ox_4                        # 48e
        lqd     $nearest_10,448($a_packet)              # 48o

        fma     $b_17,$lz_12,$dz,$b_17                  # 49e
        lqd     $nearest_11,496($a_packet)              # 49o

        fma     $b,$lz_13,$dz_7,$b                      # 50e
        lqd     $nearest_12,480($a_packet)              # 50o

        fma     $over_a_7,$s_16,$y_18,$y_18             # 51e
        fma     $over_a,$s_8,$y_19,$y_19                # 52e

        fs      $ly_6,$cy_3,$oy_6                       # 53e
        fi      $y,$e_14,$y_21                          # 54e

        fi      $y_22,$e_2,$y_20                        # 55e
        rotmi   $sides,$sides,-26                       # 56e

        fs      $ly_13,$cy_3,$oy_7                      # 57e
        fm      $b_18,$lx_14,$dx_8                      # 58e

        fm      $b_19,$lx_13,$dx_7                      # 59e
        lnop                                            # 59o pairing

        fm      $b,$b,$over_a_7                         # 60e
        lqx     $half_3,$a_half,$sides                  # 60o

        fm      $b_17,$b_17,$over_a                     # 61e
        lqx     $whole_3,$a_whole,$sides                # 61o

        fs      $lz_14,$cz_3,$oz_7                      # 62e
        lqx     $m_by_side_3,$a_by_side,$sides          # 62o

        fnms    $s_3,$e_2,$y_22,$k_one                  # 63e
        fnms    $s_17,$e_14,$y,$k_one                   # 64e

        fma     $b_19,$ly_6,$dy_8,$b_19                 # 65e
        fs      $lz_6,$cz_3,$oz_8                       # 66e

        fma     $b_18,$ly_13,$dy_9,$b_18                # 67e
        fm      $radius2_6,$radius2_5,$radius2_5        # 68e

        fnms    $lx_15,$b_17,$dx_6,$lx_12               # 69e
        fnms    $lx,$b,$dx,$lx                          # 70e

        fma     $over_a_8,$s_3,$y_22,$y_22              # 71e
        fma     $over_a_9,$s_17,$y,$y                   # 72e

        fma     $b_5,$lz_6,$dz_9,$b_18                  # 73e
        fma     $b_20,$lz_14,$dz_8,$b_19                # 74e

        fnms    $ly_14,$b,$dy_7,$ly_12                  # 75e
        fnms    $disc_17,$lx,$lx,$radius2_6             # 76e

        fnms    $ly_11,$b_17,$dy,$ly_11                 # 77e
        fnms    $disc_4,$lx_15,$lx_15,$radius2_6        # 78e

        fm      $b_5,$b_5,$over_a_8                     # 79e
        fm      $b_20,$b_20,$over_a_9                   # 80e

        fnms    $lz_15,$b_17,$dz,$lz_12                 # 81e
        fnms    $disc_3,$ly_14,$ly_14,$disc_17          # 82e

        fnms    $lz_5,$b,$dz_7,$lz_13                   # 83e
        fnms    $disc_4,$ly_11,$ly_11,$disc_4           # 84e

        fnms    $lx,$b_5,$dx_8,$lx_14                   # 85e
        fnms    $lx_16,$b_20,$dx_7,$lx_13               # 86e

        fnms    $ly,$b_20,$dy_8,$ly_6                   # 87e
        fnms    $ly_6,$b_5,$dy_9,$ly_13                 # 88e

        fnms    $disc,$lz_5,$lz_5,$disc_3               # 89e
        fnms    $disc_4,$lz_15,$lz_15,$disc_4           # 90e

        fnms    $disc_3,$lx,$lx,$radius2_6              # 91e
        fnms    $disc_7,$lx_16,$lx_16,$radius2_6        # 92e

        fnms    $lz_16,$b_5,$dz_9,$lz_6                 # 93e
        fnms    $lz_17,$b_20,$dz_8,$lz_14               # 94e

        fm      $disc,$disc,$over_a_7                   # 95e
        fm      $disc_4,$disc_4,$over_a                 # 96e

        fnms    $disc_3,$ly_6,$ly_6,$disc_3             # 97e
        fnms    $disc_7,$ly,$ly,$disc_7                 # 98e

        fms     $out_4,$b,$b,$disc                      # 101e
        frsqest $y,$disc                                # 101o

        fms     $out_10,$b_17,$b_17,$disc_4             # 102e
        frsqest $y_17,$disc_4                           # 102o

        fnms    $disc_3,$lz_16,$lz_16,$disc_3           # 103e
        fnms    $disc_7,$lz_17,$lz_17,$disc_7           # 104e

        fi      $y,$disc,$y                             # 105e
        fi      $y_10,$disc_4,$y_17                     # 106e

        fm      $disc_3,$disc_3,$over_a_8               # 109e
        fm      $disc_7,$disc_7,$over_a_9               # 110e

        fm      $s,$disc,$y                             # 112e
        fm      $s_6,$disc_4,$y_10                      # 113e

        fms     $out_11,$b_5,$b_5,$disc_3               # 115e
        frsqest $y_4,$disc_3                            # 115o

        fms     $out_12,$b_20,$b_20,$disc_7             # 116e
        frsqest $y_23,$disc_7                           # 116o

        fnms    $e,$s,$y,$k_one                         # 118e
        fnms    $e_11,$s_6,$y_10,$k_one                 # 119e

        fi      $y,$disc_7,$y_23                        # 120e
        fi      $y_4,$disc_3,$y_4                       # 121e

        selb    $s_6,$s_6,$out_10,$m_by_side_3          # 122e
        selb    $s,$s,$out_4,$m_by_side_3               # 123e

        fma     $e,$e,$half_3,$whole_3                  # 124e
        fma     $e_11,$e_11,$half_3,$whole_3            # 125e

        fm      $s_8,$disc_7,$y                         # 127e
        fm      $s_18,$disc_3,$y_4                      # 128e

        fnms    $t,$s,$e,$b                             # 130e
        fnms    $t_6,$s_6,$e_11,$b_17                   # 131e

        fnms    $e,$s_8,$y,$k_one                       # 133e
        fnms    $e_15,$s_18,$y_4,$k_one                 # 134e

        selb    $s,$s_8,$out_12,$m_by_side_3            # 135e
        cgt     $control,$t_best_12,$t                  # 136e

        cgti    $ahead,$t_6,0                           # 137e
        cgt     $control_11,$t_best_11,$t_6             # 138e

        cgti    $ahead_3,$t,0                           # 139e
        and     $control_11,$control_11,$ahead          # 140e

        fma     $e,$e,$half_3,$whole_3                  # 141e
        fma     $e_15,$e_15,$half_3,$whole_3            # 142e

        and     $control,$control,$ahead_3              # 143e
        andc    $control_12,$control_11,$disc_4         # 144e

        andc    $control,$control,$disc                 # 145e
        lnop                                            # 145o pairing

        selb    $s_8,$s_18,$out_11,$m_by_side_3         # 146e
        rotqbii $control_12,$control_12,1               # 146o

        fnms    $t_9,$s,$e,$b_20                        # 147e
        rotqbii $control,$control,1                     # 147o

        fnms    $t_5,$s_8,$e_15,$b_5                    # 148e
        gb      $control_12,$control_12                 # 150o

        gb      $control,$control                       # 151o
        cgt     $control_3,$t_best_13,$t_9              # 153e

        cgti    $ahead,$t_5,0                           # 154e
        shlqbii $control_12,$control_12,4               # 154o

        cgti    $ahead_8,$t_9,0                         # 155e
        shlqbii $control,$control,4                     # 155o

        cgt     $control_13,$t_best_3,$t_5              # 156e
        and     $control_3,$control_3,$ahead_8          # 157e

        and     $control_4,$control_13,$ahead           # 158e
        lqx     $control_12,$control_12,$a_controls     # 158o

        andc    $control_5,$control_3,$disc_7           # 159e
        lqx     $control,$control,$a_controls           # 159o

        andc    $control_14,$control_4,$disc_3          # 160e
        rotqbii $control_5,$control_5,1                 # 161o

        rotqbii $control_14,$control_14,1               # 162o
        shufb   $nearest,$nearest_10,$object,$control_12 # 164o

        shufb   $nearest_6,$nearest_4,$object,$control  # 165o
        gb      $control_5,$control_5                   # 166o

        shufb   $t_best,$t_best_11,$t_6,$control_12     # 167o
        shufb   $t_best_7,$t_best_12,$t,$control        # 168o

        gb      $control,$control_14                    # 169o
        stqd    $nearest,448($a_packet)                 # 170o

        stqd    $t_best,384($a_packet)                  # 171o
        stqd    $t_best_7,400($a_packet)                # 172o

        shlqbii $control,$control,4                     # 173o
        stqd    $nearest_6,464($a_packet)               # 174o

        shlqbii $control_12,$control_5,4                # 175o
        hbrr    next_ball_short_back,next_ball_short    # 176o hint

        lqx     $control,$control,$a_controls           # 177o
        lqx     $control_12,$control_12,$a_controls     # 179o

        shufb   $t_best,$t_best_3,$t_5,$control         # 183o
        shufb   $nearest,$nearest_11,$object,$control   # 184o

        shufb   $t_best_6,$t_best_13,$t_9,$control_12   # 185o
        shufb   $nearest_9,$nearest_12,$object,$control_12 # 186o

        stqd    $t_best,432($a_packet)                  # 187o
        stqd    $nearest,496($a_packet)                 # 188o

        stqd    $t_best_6,416($a_packet)                # 189o
        stqd    $nearest_9,480($a_packet)               # 190o

        nop     $127                                    # 191e pairing
next_ball_short_back:
        brnz    $count,next_ball_short                  # 191o

        nop     $127                                    # 192e pairing
        bi      $lr                                     # 192o
endfunction isect_ball_pairs_unnormalised_r16
