# isect_ball_pairs_newton2_r16   nearest hit of packets' rays with spheres, two steps for the root
#   C       void isect_ball_pairs_newton2_r16(const struct candidate *, int count);
#   In      $3 candidates of objects that are spheres, $4 count (0 is none); pointers 16-aligned
#   Out     the candidates' packets: t, object, where a hit has 0 < t < what was there
#   Uses    $2-$76, $79   Saves  -   Stack  0   Calls  -
#   Domain  |d| = 1 within 4 ulp; coordinates and radius below 2^62, radius above 2^-40
#   Error   25 ulp of the larger of t and r, origin up to 30 radii from the centre, ray within
#           0.995 r of it
#   Twin    oracle/src/twin/sphere/newton2.rs
#
# The steps are those of sphere_tmpl.inc: of the crossings the entry is asked for, with SIDES_EXIT the
# exit, and with SIDES_BOTH the exit of a ray from inside.
# Scheduled by spu schedule from isect_ball_pairs_newton2_r16.s

        .include "work_unit.inc"
        .include "macros.inc"
        .include "pairs.inc"
        .include "sphere_tmpl.inc"
        .include "sphere_newton2.inc"

        .set    a_candidate,3
        .set    count,4
        # constants
        .set    m_x,10
        .set    m_y,11
        .set    m_z,12
        .set    k_half,13
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
        .set    t,46
        .set    ahead,47
        .set    control,48

        sign_controls_table
        sides_tables 0x3f000000, 0x3f800000

function isect_ball_pairs_newton2_r16
        .set    count_2,79
        .set    a_candidate_2,2
        .set    object_2,5
        .set    object_3,22
        .set    a_packet_2,2
        .set    quad_2,26
        .set    sides_2,24
        .set    a_packet_3,25
        .set    ox_2,6
        .set    cx_2,8
        .set    cy_2,29
        .set    ox_3,7
        .set    dy_2,40
        .set    lx_2,6
        .set    oz_2,44
        .set    ly_2,30
        .set    cz_2,26
        .set    ox_4,27
        .set    oy_2,33
        .set    lx_3,7
        .set    dz_2,57
        .set    dx_2,9
        .set    b_2,41
        .set    ox_5,18
        .set    lz_2,44
        .set    dx_3,28
        .set    lx_4,19
        .set    oy_3,27
        .set    ly_3,33
        .set    oz_3,47
        .set    dy_3,42
        .set    b_3,49
        .set    radius2_2,59
        .set    oz_4,50
        .set    oy_4,34
        .set    ly_4,27
        .set    dx_4,39
        .set    radius2_3,8
        .set    dy_4,52
        .set    b_4,53
        .set    dz_3,18
        .set    lz_3,47
        .set    oz_5,54
        .set    b_5,31
        .set    dy_5,56
        .set    dz_4,58
        .set    b_6,55
        .set    dz_5,20
        .set    ly_5,29
        .set    quad_3,21
        .set    ox_6,23
        .set    lz_4,50
        .set    ox_7,34
        .set    b_7,38
        .set    ox_8,36
        .set    oy_5,40
        .set    lz_5,26
        .set    cx_3,41
        .set    cy_3,43
        .set    b_8,45
        .set    oy_6,46
        .set    disc_2,6
        .set    dx_5,48
        .set    lz_6,35
        .set    dx_6,44
        .set    ox_9,9
        .set    b_9,51
        .set    oz_6,49
        .set    oy_7,28
        .set    cz_3,30
        .set    disc_3,7
        .set    oy_8,52
        .set    lz_7,18
        .set    dy_6,47
        .set    disc_4,19
        .set    oz_7,53
        .set    lz_8,21
        .set    sides_3,50
        .set    disc_5,8
        .set    oz_8,27
        .set    lz_9,20
        .set    y_2,26
        .set    dz_6,56
        .set    disc_6,62
        .set    dy_7,59
        .set    radius2_4,34
        .set    y_3,18
        .set    t_best_2,64
        .set    sides_4,60
        .set    dz_7,24
        .set    disc_7,26
        .set    t_best_3,21
        .set    y_4,23
        .set    m_by_side_2,61
        .set    lx_5,55
        .set    whole_2,63
        .set    s_2,65
        .set    t_best_4,19
        .set    nearest_2,66
        .set    y_5,67
        .set    y_6,36
        .set    y_7,68
        .set    object_4,20
        .set    a_packet_4,23
        .set    b_10,5
        .set    nearest_3,18
        .set    e_2,69
        .set    y_8,70
        .set    y_9,71
        .set    half_2,60
        .set    ly_6,46
        .set    s_3,72
        .set    nearest_4,2
        .set    s_4,50
        .set    b_11,73
        .set    lx_6,9
        .set    e_3,41
        .set    e_4,74
        .set    ly_7,28
        .set    lz_10,75
        .set    s_5,76
        .set    out_2,49
        .set    s_6,67
        .set    ly_8,43
        .set    lz_11,52
        .set    y_10,40
        .set    lz_12,54
        .set    b_12,71
        .set    b_13,72
        .set    e_5,73
        .set    lx_7,5
        .set    t_2,32
        .set    lz_13,27
        .set    e_6,30
        .set    s_7,37
        .set    out_3,31
        .set    lx_8,44
        .set    disc_8,5
        .set    ahead_2,67
        .set    e_7,42
        .set    s_8,30
        .set    out_4,65
        .set    s_9,31
        .set    disc_9,50
        .set    ly_9,6
        .set    disc_10,9
        .set    out_5,29
        .set    t_3,31
        .set    s_10,33
        .set    disc_11,37
        .set    t_4,7
        .set    control_2,45
        .set    ly_10,9
        .set    disc_12,28
        .set    lz_14,30
        .set    lz_15,40
        .set    disc_13,34
        .set    t_best_5,46
        .set    ahead_3,5
        .set    nearest_5,32
        .set    t_5,38
        .set    control_3,43
        .set    lz_16,5
        .set    y_11,24
        .set    whole_3,50
        .set    disc_14,61
        .set    m_by_side_3,39
        .set    control_4,6
        .set    nearest_6,65
        .set    control_5,51
        .set    control_6,24
        .set    y_12,27
        .set    disc_15,63
        .set    control_7,5
        .set    y_13,6
        .set    control_8,8
        .set    y_14,9
        .set    out_6,27
        .set    out_7,40
        .set    control_9,37
        .set    s_11,28
        .set    nearest_7,5
        .set    y_15,32
        .set    control_10,30
        .set    e_8,29
        .set    control_11,2
        .set    s_12,2
        .set    e_9,5
        .set    s_13,6
        .set    t_best_6,7
        .set    y_16,8
        .set    e_10,9
        .set    s_14,5
        .set    e_11,21
        .set    out_8,7
        .set    nearest_8,9
        .set    e_12,24
        .set    ox_10,5
        .set    dx_7,2
        .set    lx_9,8
        .set    dz_8,54
        .set    lx_10,2
        .set    disc_16,2
        .set    disc_17,24
        .set    ahead_4,28
        .set    lz_17,6
        .set    s_15,3
        .set    e_13,4
        .set    s_16,4
        .set    out_9,2
        .set    control_12,3
        .set    ox_11,2
        .set    dx_8,5
        .set    dy_8,2
        .set    oy_9,7
        .set    oz_9,8
        .set    b_14,20
        .set    ly_11,7
        .set    dx_9,26
        .set    lz_18,8
        .set    lx_11,27
        .set    oz_10,30
        .set    dx_10,35
        .set    dz_9,21
        .set    dy_9,36
        .set    lz_19,31
        .set    radius2_5,41
        .set    b_15,42
        .set    dz_10,43
        .set    ly_12,22
        .set    dy_10,28
        .set    b_16,44
        .set    t_best_7,45
        .set    t_best_8,47
        .set    lz_20,23
        .set    t_best_9,30
        .set    nearest_9,48
        .set    nearest_10,6
        .set    nearest_11,49
        .set    ly_13,2
        .set    nearest_12,7
        .set    b_17,32
        .set    b_18,33
        .set    out_10,9
        .set    y_17,21
        .set    y_18,22
        .set    s_17,23
        .set    out_11,24
        .set    y_19,25
        .set    out_12,26
        .set    e_14,31
        .set    s_18,29
        .set    s_19,34
        .set    e_15,35
        .set    e_16,36
        .set    e_17,37
        .set    s_20,22
        .set    t_6,20
        .set    t_7,23
        .set    ahead_5,34
        .set    control_13,35
        .set    s_21,9
        .set    control_14,21
        .set    control_15,22
        .set    ahead_6,25
        .set    t_8,9
        .set    t_9,21
        .set    ahead_7,22
        .set    t_best_10,5
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

        ilhu    $k_half,0x3f00                          # 12e
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
        lqd     $sides_2,32($object_2)                  # 21o

        rotqbyi $a_packet_3,$object_3,4                 # 22o
        lqd     $ox_2,0($a_packet_2)                    # 23o

        lqd     $dx,192($a_packet_2)                    # 24o
        lqd     $oy,64($a_packet_2)                     # 25o

        shufb   $cx_2,$quad_2,$quad_2,$m_x              # 26o
        shufb   $cy_2,$quad_2,$quad_2,$m_y              # 27o

        lqd     $ox_3,16($a_packet_2)                   # 28o
        lqd     $dy_2,256($a_packet_2)                  # 29o

        fs      $lx_2,$cx_2,$ox_2                       # 30e
        lqd     $oz_2,128($a_packet_2)                  # 30o

        fs      $ly_2,$cy_2,$oy                         # 31e
        shufb   $cz_2,$quad_2,$quad_2,$m_z              # 31o

        lqd     $ox_4,32($a_packet_2)                   # 32o
        lqd     $oy_2,80($a_packet_2)                   # 33o

        fs      $lx_3,$cx_2,$ox_3                       # 34e
        lqd     $dz_2,320($a_packet_2)                  # 34o

        nop     $127                                    # 35e pairing
        lqd     $dx_2,208($a_packet_2)                  # 35o

        fm      $b_2,$lx_2,$dx                          # 36e
        lqd     $ox_5,48($a_packet_2)                   # 36o

        fs      $lz_2,$cz_2,$oz_2                       # 37e
        lqd     $dx_3,224($a_packet_2)                  # 37o

        fs      $lx_4,$cx_2,$ox_4                       # 38e
        lqd     $oy_3,96($a_packet_2)                   # 38o

        fs      $ly_3,$cy_2,$oy_2                       # 39e
        lqd     $oz_3,144($a_packet_2)                  # 39o

        nop     $127                                    # 40e pairing
        lqd     $dy_3,272($a_packet_2)                  # 40o

        fm      $b_3,$lx_3,$dx_2                        # 41e
        shufb   $radius2_2,$sides_2,$sides_2,$m_x       # 41o

        fma     $b_2,$ly_2,$dy_2,$b_2                   # 42e
        lqd     $oz_4,160($a_packet_2)                  # 42o

        fs      $lx,$cx_2,$ox_5                         # 43e
        lqd     $oy_4,112($a_packet_2)                  # 43o

        fs      $ly_4,$cy_2,$oy_3                       # 44e
        lqd     $dx_4,240($a_packet_2)                  # 44o

        fm      $radius2_3,$radius2_2,$radius2_2        # 45e
        lqd     $dy_4,288($a_packet_2)                  # 45o

        fm      $b_4,$lx_4,$dx_3                        # 46e
        lqd     $dz_3,336($a_packet_2)                  # 46o

        fs      $lz_3,$cz_2,$oz_3                       # 47e
        lqd     $oz_5,176($a_packet_2)                  # 47o

        fma     $b_5,$lz_2,$dz_2,$b_2                   # 48e
        lqd     $dy_5,304($a_packet_2)                  # 48o

        fma     $b_3,$ly_3,$dy_3,$b_3                   # 49e
        lqd     $dz_4,352($a_packet_2)                  # 49o

        fm      $b_6,$lx,$dx_4                          # 50e
        lqd     $dz_5,368($a_packet_2)                  # 50o

        fs      $ly_5,$cy_2,$oy_4                       # 51e
        lqd     $quad_3,0($object_3)                    # 51o

        fma     $b_4,$ly_4,$dy_4,$b_4                   # 52e
        lqd     $ox_6,0($a_packet_3)                    # 52o

        fs      $lz_4,$cz_2,$oz_4                       # 53e
        lqd     $ox_7,16($a_packet_3)                   # 53o

        fnms    $lx_2,$b_5,$dx,$lx_2                    # 54e
        lqd     $dx,192($a_packet_3)                    # 54o

        fma     $b_7,$lz_3,$dz_3,$b_3                   # 55e
        lqd     $ox_8,32($a_packet_3)                   # 55o

        fnms    $ly_2,$b_5,$dy_2,$ly_2                  # 56e
        lqd     $oy_5,64($a_packet_3)                   # 56o

        fs      $lz_5,$cz_2,$oz_5                       # 57e
        shufb   $cx_3,$quad_3,$quad_3,$m_x              # 57o

        fma     $b_6,$ly_5,$dy_5,$b_6                   # 58e
        shufb   $cy_3,$quad_3,$quad_3,$m_y              # 58o

        fma     $b_8,$lz_4,$dz_4,$b_4                   # 59e
        lqd     $oy_6,96($a_packet_3)                   # 59o

        fnms    $disc_2,$lx_2,$lx_2,$radius2_3          # 60e
        lqd     $dx_5,224($a_packet_3)                  # 60o

        fnms    $lz_6,$b_5,$dz_2,$lz_2                  # 61e
        lqd     $dx_6,208($a_packet_3)                  # 61o

        fnms    $lx_3,$b_7,$dx_2,$lx_3                  # 62e
        lqd     $ox_9,48($a_packet_3)                   # 62o

        fnms    $ly_3,$b_7,$dy_3,$ly_3                  # 63e
        lqd     $dy_3,256($a_packet_3)                  # 63o

        fma     $b_9,$lz_5,$dz_5,$b_6                   # 64e
        lqd     $oz_6,128($a_packet_3)                  # 64o

        fnms    $lx_4,$b_8,$dx_3,$lx_4                  # 65e
        lqd     $oy_7,80($a_packet_3)                   # 65o

        fnms    $disc_2,$ly_2,$ly_2,$disc_2             # 66e
        shufb   $cz_3,$quad_3,$quad_3,$m_z              # 66o

        fnms    $ly_4,$b_8,$dy_4,$ly_4                  # 67e
        rotqbyi $sides_2,$sides_2,12                    # 67o

        fnms    $disc_3,$lx_3,$lx_3,$radius2_3          # 68e
        lqd     $oy_8,112($a_packet_3)                  # 68o

        fnms    $lz_7,$b_7,$dz_3,$lz_3                  # 69e
        lqd     $dy_6,272($a_packet_3)                  # 69o

        fnms    $lx,$b_9,$dx_4,$lx                      # 70e
        lqd     $dz_2,320($a_packet_3)                  # 70o

        fnms    $disc_4,$lx_4,$lx_4,$radius2_3          # 71e
        lqd     $dx_4,240($a_packet_3)                  # 71o

        fnms    $disc_2,$lz_6,$lz_6,$disc_2             # 72e
        lqd     $oz_7,144($a_packet_3)                  # 72o

        fnms    $ly_5,$b_9,$dy_5,$ly_5                  # 73e
        lqd     $oz_5,160($a_packet_3)                  # 73o

        fnms    $disc_3,$ly_3,$ly_3,$disc_3             # 74e
        lqd     $dy,288($a_packet_3)                    # 74o

        fnms    $lz_8,$b_8,$dz_4,$lz_4                  # 75e
        lqd     $sides_3,32($object_3)                  # 75o

        fnms    $disc_5,$lx,$lx,$radius2_3              # 76e
        lqd     $dz_4,352($a_packet_3)                  # 76o

        fnms    $disc_4,$ly_4,$ly_4,$disc_4             # 77e
        lqd     $oz_8,176($a_packet_3)                  # 77o

        fnms    $lz_9,$b_9,$dz_5,$lz_5                  # 78e
        frsqest $y_2,$disc_2                            # 78o

        fs      $lx,$cx_3,$ox_6                         # 79e
        lqd     $dz_6,336($a_packet_3)                  # 79o

        fnms    $disc_6,$lz_7,$lz_7,$disc_3             # 80e
        lqd     $dy_7,304($a_packet_3)                  # 80o

        fs      $lx_3,$cx_3,$ox_7                       # 81e
        shufb   $radius2_4,$sides_3,$sides_3,$m_x       # 81o

        fi      $y_3,$disc_2,$y_2                       # 82e
        lqd     $t_best_2,384($a_packet_2)              # 82o

        rotmi   $sides_4,$sides_2,-26                   # 83e
        lqd     $dz_7,368($a_packet_3)                  # 83o

        fnms    $disc_5,$ly_5,$ly_5,$disc_5             # 84e
        lqd     $t_best,400($a_packet_2)                # 84o

        fnms    $disc_7,$lz_8,$lz_8,$disc_4             # 85e
        lqd     $t_best_3,416($a_packet_2)              # 85o

        fs      $ly_5,$cy_3,$oy_5                       # 86e
        frsqest $y_4,$disc_6                            # 86o

        fm      $b,$lx,$dx                              # 87e
        lqx     $m_by_side_2,$a_by_side,$sides_4        # 87o

        fs      $lx_5,$cx_3,$ox_8                       # 88e
        lqx     $whole_2,$a_whole,$sides_4              # 88o

        fm      $s_2,$disc_2,$y_3                       # 89e
        lqd     $t_best_4,432($a_packet_2)              # 89o

        fnms    $disc_5,$lz_9,$lz_9,$disc_5             # 90e
        lqd     $nearest_2,448($a_packet_2)             # 90o

        fm      $y_5,$y_3,$k_half                       # 91e
        frsqest $y_6,$disc_7                            # 91o

        fi      $y_7,$disc_6,$y_4                       # 92e
        shufb   $object_4,$object_2,$object_2,$m_x      # 92o

        nop     $127                                    # 93e pairing
        shlqbyi $a_packet_4,$a_packet_2,0               # 93o copy

        fm      $b_10,$lx_3,$dx_6                       # 94e
        lqd     $nearest_3,496($a_packet_2)             # 94o

        fnms    $e_2,$s_2,$s_2,$disc_2                  # 95e
        rotqbyi $sides_3,$sides_3,12                    # 95o

        fi      $y_8,$disc_7,$y_6                       # 96e
        frsqest $y_9,$disc_5                            # 96o

        nop     $127                                    # 97e pairing
        lqx     $half_2,$a_half,$sides_4                # 97o

        fs      $ly_6,$cy_3,$oy_6                       # 98e
        lqd     $nearest,480($a_packet_2)               # 98o

        fm      $s_3,$disc_6,$y_7                       # 99e
        lqd     $nearest_4,464($a_packet_2)             # 99o

        fi      $y_9,$disc_5,$y_9                       # 100e
        rotmi   $sides_4,$sides_3,-26                   # 101e

        fma     $s_4,$e_2,$y_5,$s_2                     # 102e
        fm      $s_2,$disc_7,$y_8                       # 103e

        fm      $y_7,$y_7,$k_half                       # 104e
        fnms    $e_2,$s_3,$s_3,$disc_6                  # 105e

        fm      $b_11,$lx_5,$dx_5                       # 106e
        fs      $lx_6,$cx_3,$ox_9                       # 107e

        fnms    $e_3,$s_4,$s_4,$disc_2                  # 108e
        fm      $y_8,$y_8,$k_half                       # 109e

        fnms    $e_4,$s_2,$s_2,$disc_7                  # 110e
        fs      $ly_7,$cy_3,$oy_7                       # 111e

        fma     $b,$ly_5,$dy_3,$b                       # 112e
        fs      $lz_10,$cz_3,$oz_6                      # 113e

        fm      $s_5,$disc_5,$y_9                       # 114e
        fms     $out_2,$b_5,$b_5,$disc_2                # 115e

        fma     $s_4,$e_3,$y_5,$s_4                     # 116e
        fma     $s_6,$e_2,$y_7,$s_3                     # 117e

        fs      $ly_8,$cy_3,$oy_8                       # 118e
        fma     $b_10,$ly_7,$dy_6,$b_10                 # 119e

        fs      $lz_11,$cz_3,$oz_7                      # 120e
        fma     $b_2,$lz_10,$dz_2,$b                    # 121e

        fm      $y_10,$y_9,$k_half                      # 122e
        fnms    $e_2,$s_5,$s_5,$disc_5                  # 123e

        fm      $b_4,$lx_6,$dx_4                        # 124e
        fs      $lz_12,$cz_3,$oz_5                      # 125e

        fma     $b_12,$ly_6,$dy,$b_11                   # 126e
        fma     $s_2,$e_4,$y_8,$s_2                     # 127e

        fm      $radius2_4,$radius2_4,$radius2_4        # 128e
        selb    $s_4,$s_4,$out_2,$m_by_side_2           # 129e

        fma     $b_13,$ly_8,$dy_7,$b_4                  # 130e
        fnms    $e_5,$s_6,$s_6,$disc_6                  # 131e

        fma     $b_4,$lz_12,$dz_4,$b_12                 # 132e
        fma     $b_3,$lz_11,$dz_6,$b_10                 # 133e

        fnms    $lx_7,$b_2,$dx,$lx                      # 134e
        fnms    $t_2,$s_4,$whole_2,$b_5                 # 135e

        fs      $lz_13,$cz_3,$oz_8                      # 136e
        fnms    $e_6,$s_2,$s_2,$disc_7                  # 137e

        fma     $s_7,$e_2,$y_10,$s_5                    # 138e
        fms     $out_3,$b_7,$b_7,$disc_6                # 139e

        fma     $s_4,$e_5,$y_7,$s_6                     # 140e
        fnms    $lx_3,$b_3,$dx_6,$lx_3                  # 141e

        fnms    $lx_8,$b_4,$dx_5,$lx_5                  # 142e
        fnms    $disc_8,$lx_7,$lx_7,$radius2_4          # 143e

        cgt     $control,$t_best_2,$t_2                 # 144e
        cgti    $ahead_2,$t_2,0                         # 145e

        fma     $b_6,$lz_13,$dz_7,$b_13                 # 146e
        fnms    $ly_5,$b_2,$dy_3,$ly_5                  # 147e

        fnms    $e_7,$s_7,$s_7,$disc_5                  # 148e
        fma     $s_8,$e_6,$y_8,$s_2                     # 149e

        and     $control,$control,$ahead_2              # 150e
        fms     $out_4,$b_8,$b_8,$disc_7                # 151e

        selb    $s_9,$s_4,$out_3,$m_by_side_2           # 152e
        fnms    $disc_9,$lx_3,$lx_3,$radius2_4          # 153e

        andc    $control,$control,$disc_2               # 154e
        fnms    $ly_9,$b_4,$dy,$ly_6                    # 155e

        fnms    $ly_7,$b_3,$dy_6,$ly_7                  # 156e
        rotqbii $control,$control,1                     # 156o

        fnms    $lx_3,$b_6,$dx_4,$lx_6                  # 157e
        fnms    $lz,$b_2,$dz_2,$lz_10                   # 158e

        fnms    $disc_10,$lx_8,$lx_8,$radius2_4         # 159e
        lnop                                            # 159o pairing

        fnms    $disc_8,$ly_5,$ly_5,$disc_8             # 160e
        gb      $control,$control                       # 160o

        fms     $out_5,$b_9,$b_9,$disc_5                # 161e
        fnms    $t_3,$s_9,$whole_2,$b_7                 # 162e

        fma     $s_10,$e_7,$y_10,$s_7                   # 163e
        lnop                                            # 163o pairing

        selb    $s_8,$s_8,$out_4,$m_by_side_2           # 164e
        shlqbii $control,$control,4                     # 164o

        fnms    $disc_11,$lx_3,$lx_3,$radius2_4         # 165e
        fnms    $t_4,$s_8,$whole_2,$b_8                 # 166e

        fnms    $disc_2,$ly_9,$ly_9,$disc_10            # 167e
        lnop                                            # 167o pairing

        cgt     $control_2,$t_best,$t_3                 # 168e
        lqx     $control,$control,$a_controls           # 168o

        fnms    $ly_10,$b_6,$dy_7,$ly_8                 # 169e
        fnms    $disc_12,$ly_7,$ly_7,$disc_9            # 170e

        fnms    $lz_14,$b_3,$dz_6,$lz_11                # 171e
        fnms    $lz_15,$b_4,$dz_4,$lz_12                # 172e

        fnms    $disc_13,$lz,$lz,$disc_8                # 173e
        lnop                                            # 173o pairing

        selb    $s,$s_10,$out_5,$m_by_side_2            # 174e
        shufb   $t_best_5,$t_best_2,$t_2,$control       # 174o

        cgti    $ahead_3,$t_3,0                         # 175e
        shufb   $nearest_5,$nearest_2,$object_4,$control # 175o

        fnms    $t_5,$s,$whole_2,$b_9                   # 176e
        cgt     $control_3,$t_best_3,$t_4               # 177e

        and     $control,$control_2,$ahead_3            # 178e
        stqd    $t_best_5,384($a_packet_4)              # 178o

        fnms    $lz_16,$b_6,$dz_7,$lz_13                # 179e
        frsqest $y_11,$disc_13                          # 179o

        fnms    $disc_10,$ly_10,$ly_10,$disc_11         # 180e
        stqd    $nearest_5,448($a_packet_4)             # 180o

        andc    $control,$control,$disc_6               # 181e
        lqd     $t_best_2,384($a_packet_3)              # 181o

        fnms    $disc_6,$lz_14,$lz_14,$disc_12          # 182e
        lqx     $whole_3,$a_whole,$sides_4              # 182o

        cgti    $ahead,$t_4,0                           # 183e
        rotqbii $control,$control,1                     # 183o

        fnms    $disc_14,$lz_15,$lz_15,$disc_2          # 184e
        lqx     $m_by_side_3,$a_by_side,$sides_4        # 184o

        and     $control_4,$control_3,$ahead            # 185e
        lqd     $nearest_6,448($a_packet_3)             # 185o

        cgt     $control_5,$t_best_4,$t_5               # 186e
        lnop                                            # 186o pairing

        andc    $control_4,$control_4,$disc_7           # 187e
        gb      $control,$control                       # 187o

        cgti    $ahead,$t_5,0                           # 188e
        frsqest $y_2,$disc_6                            # 188o

        fi      $y,$disc_13,$y_11                       # 189e
        rotqbii $control_6,$control_4,1                 # 189o

        and     $control_4,$control_5,$ahead            # 190e
        frsqest $y_12,$disc_14                          # 190o

        fnms    $disc_15,$lz_16,$lz_16,$disc_10         # 191e
        shlqbii $control,$control,4                     # 191o

        andc    $control_7,$control_4,$disc_5           # 192e
        lnop                                            # 192o pairing

        fi      $y_13,$disc_6,$y_2                      # 193e
        gb      $control_8,$control_6                   # 193o

        fi      $y_14,$disc_14,$y_12                    # 194e
        rotqbii $control_7,$control_7,1                 # 194o

        lqx     $control,$control,$a_controls           # 195o
        fm      $s,$disc_13,$y                          # 196e

        fm      $y_2,$y,$k_half                         # 197e
        frsqest $y_11,$disc_15                          # 197o

        fms     $out_6,$b_3,$b_3,$disc_6                # 198e
        shlqbii $control_8,$control_8,4                 # 198o

        fms     $out_7,$b_6,$b_6,$disc_15               # 199e
        gb      $control_9,$control_7                   # 199o

        fm      $s_10,$disc_6,$y_13                     # 200e
        lnop                                            # 200o pairing

        fm      $s_11,$disc_14,$y_14                    # 201e
        shufb   $nearest_7,$nearest_4,$object_4,$control # 201o

        fm      $y_15,$y_14,$k_half                     # 202e
        lqx     $control_10,$control_8,$a_controls      # 202o

        fnms    $e_8,$s,$s,$disc_13                     # 203e
        shlqbii $control_11,$control_9,4                # 203o

        fi      $y_11,$disc_15,$y_11                    # 204e
        lnop                                            # 204o pairing

next_ball:
            fnms    $e,$s_11,$s_11,$disc_14             # 0e
            shufb   $t_best,$t_best,$t_3,$control       # 0o

            fma     $s,$e_8,$y_2,$s                     # 1e
            lqx     $control,$control_11,$a_controls    # 1o

            fm      $y,$y_13,$k_half                    # 2e
            stqd    $nearest_7,464($a_packet_4)         # 2o

            fm      $s_12,$disc_15,$y_11                # 3e
            shufb   $nearest,$nearest,$object_4,$control_10 # 3o

            fms     $out,$b_2,$b_2,$disc_13             # 4e
            stqd    $t_best,400($a_packet_4)            # 4o

            fnms    $e_9,$s_10,$s_10,$disc_6            # 5e
            lqd     $t_best,400($a_packet_3)            # 5o

            fma     $s_13,$e,$y_15,$s_11                # 6e
            shufb   $t_best_6,$t_best_3,$t_4,$control_10 # 6o

            fnms    $e,$s,$s,$disc_13                   # 7e
            stqd    $nearest,480($a_packet_4)           # 7o

            fm      $y_16,$y_11,$k_half                 # 8e
            lqd     $nearest,480($a_packet_3)           # 8o

            fnms    $e_10,$s_12,$s_12,$disc_15          # 9e
            shufb   $nearest_3,$nearest_3,$object_4,$control # 9o

        ai      $count,$count,-1                        # 10e
            shufb   $t_best_4,$t_best_4,$t_5,$control   # 10o

            fma     $s_14,$e_9,$y,$s_10                 # 11e
            shufb   $object_4,$object_3,$object_3,$m_x  # 11o

            fnms    $e_11,$s_13,$s_13,$disc_14          # 12e
            stqd    $t_best_6,416($a_packet_4)          # 12o

            fma     $s,$e,$y_2,$s                       # 13e
            stqd    $nearest_3,496($a_packet_4)         # 13o

        nop     $127                                    # 14e pairing
        lqd     $object_3,0($a_candidate)               # 14o

            fma     $s_12,$e_10,$y_16,$s_12             # 15e
            stqd    $t_best_4,432($a_packet_4)          # 15o

            fms     $out_8,$b_4,$b_4,$disc_14           # 16e
            shlqbyi $a_packet_4,$a_packet_3,0           # 16o copy

            fnms    $e,$s_14,$s_14,$disc_6              # 17e
            lqd     $t_best_4,432($a_packet_3)          # 17o

            fma     $s_13,$e_11,$y_15,$s_13             # 18e
            lqd     $nearest_8,464($a_packet_3)         # 18o

            selb    $s,$s,$out,$m_by_side_3             # 19e
            lqd     $nearest_3,496($a_packet_3)         # 19o

        ai      $a_candidate,$a_candidate,16            # 20e
            lqd     $t_best_3,416($a_packet_3)          # 20o

            fnms    $e_12,$s_12,$s_12,$disc_15          # 21e
        rotqbyi $a_packet_3,$object_3,4                 # 21o

            fnms    $t,$s,$whole_3,$b_2                 # 22e
        lqd     $quad_2,0($object_3)                    # 22o

            fma     $s,$e,$y,$s_14                      # 23e
            selb    $s_14,$s_13,$out_8,$m_by_side_3     # 24e

        nop     $127                                    # 25e pairing
        lqd     $ox,48($a_packet_3)                     # 25o

            fnms    $t_4,$s_14,$whole_3,$b_4            # 26e
        lqd     $ox_10,0($a_packet_3)                   # 26o

            fma     $s_12,$e_12,$y_16,$s_12             # 27e
        lqd     $ox_2,16($a_packet_3)                   # 27o

            cgt     $control,$t_best_2,$t               # 28e
        shufb   $cx_2,$quad_2,$quad_2,$m_x              # 28o

            cgti    $ahead,$t,0                         # 29e
        lqd     $sides_2,32($object_3)                  # 29o

            selb    $s,$s,$out_6,$m_by_side_3           # 30e
        lqd     $ox_4,32($a_packet_3)                   # 30o

            and     $control,$control,$ahead            # 31e
        lqd     $dx,192($a_packet_3)                    # 31o

        fs      $lx,$cx_2,$ox                           # 32e
        lqd     $dx_3,224($a_packet_3)                  # 32o

        fs      $lx_7,$cx_2,$ox_10                      # 33e
        shufb   $cy_2,$quad_2,$quad_2,$m_y              # 33o

        fs      $lx_2,$cx_2,$ox_2                       # 34e
        lqd     $oy,64($a_packet_3)                     # 34o

            fnms    $t_3,$s,$whole_3,$b_3               # 35e
        lqd     $oy_2,80($a_packet_3)                   # 35o

            selb    $s,$s_12,$out_7,$m_by_side_3        # 36e
        lqd     $dx_7,208($a_packet_3)                  # 36o

        fs      $lx_9,$cx_2,$ox_4                       # 37e
        lqd     $oy_3,96($a_packet_3)                   # 37o

            andc    $control,$control,$disc_13          # 38e
        lqd     $oy_4,112($a_packet_3)                  # 38o

            fnms    $t_5,$s,$whole_3,$b_6               # 39e
        lqd     $dx_4,240($a_packet_3)                  # 39o

        fs      $ly_2,$cy_2,$oy                         # 40e
        lqd     $dy_2,256($a_packet_3)                  # 40o

        fm      $b_2,$lx_7,$dx                          # 41e
        lqd     $dy_3,272($a_packet_3)                  # 41o

            cgt     $control_3,$t_best_3,$t_4           # 42e
        lqd     $oz_2,128($a_packet_3)                  # 42o

            cgt     $control_2,$t_best,$t_3             # 43e
        lqd     $oz_3,144($a_packet_3)                  # 43o

        fm      $b_3,$lx_2,$dx_7                        # 44e
        shufb   $cz_2,$quad_2,$quad_2,$m_z              # 44o

        fs      $ly_3,$cy_2,$oy_2                       # 45e
            rotqbii $control,$control,1                 # 45o

        fs      $ly_4,$cy_2,$oy_3                       # 46e
        lqd     $oz_4,160($a_packet_3)                  # 46o

            cgt     $control_5,$t_best_4,$t_5           # 47e
        lqd     $dy_4,288($a_packet_3)                  # 47o

        fm      $b_4,$lx_9,$dx_3                        # 48e
        lqd     $oz_5,176($a_packet_3)                  # 48o

        fm      $b_6,$lx,$dx_4                          # 49e
        lqd     $dy_5,304($a_packet_3)                  # 49o

        fma     $b_2,$ly_2,$dy_2,$b_2                   # 50e
            gb      $control,$control                   # 50o

        fs      $ly_5,$cy_2,$oy_4                       # 51e
        lqd     $dz,336($a_packet_3)                    # 51o

        fma     $b_3,$ly_3,$dy_3,$b_3                   # 52e
        lqd     $dz_2,320($a_packet_3)                  # 52o

        fs      $lz_2,$cz_2,$oz_2                       # 53e
        lqd     $dz_4,352($a_packet_3)                  # 53o

        fs      $lz_3,$cz_2,$oz_3                       # 54e
            shlqbii $control,$control,4                 # 54o

        fs      $lz_4,$cz_2,$oz_4                       # 55e
        shufb   $radius2_2,$sides_2,$sides_2,$m_x       # 55o

        fma     $b_4,$ly_4,$dy_4,$b_4                   # 56e
        rotqbyi $sides_2,$sides_2,12                    # 56o

        fs      $lz_5,$cz_2,$oz_5                       # 57e
        lqd     $dz_8,368($a_packet_3)                  # 57o

        fma     $b_6,$ly_5,$dy_5,$b_6                   # 58e
            lqx     $control,$control,$a_controls       # 58o

        fma     $b_2,$lz_2,$dz_2,$b_2                   # 59e
        lnop                                            # 59o pairing

        fma     $b_3,$lz_3,$dz,$b_3                     # 60e
            lqx     $half_2,$a_half,$sides_4            # 60o

        rotmi   $sides_4,$sides_2,-26                   # 61e
        fma     $b_4,$lz_4,$dz_4,$b_4                   # 62e

        fm      $radius2,$radius2_2,$radius2_2          # 63e
        lnop                                            # 63o pairing

        fma     $b_6,$lz_5,$dz_8,$b_6                   # 64e
            shufb   $t_best_5,$t_best_2,$t,$control     # 64o

        fnms    $lx_7,$b_2,$dx,$lx_7                    # 65e
            shufb   $nearest_5,$nearest_6,$object_4,$control # 65o

        fnms    $lx_10,$b_3,$dx_7,$lx_2                 # 66e
        fnms    $ly_9,$b_3,$dy_3,$ly_3                  # 67e

        fnms    $lx_9,$b_4,$dx_3,$lx_9                  # 68e
            stqd    $t_best_5,384($a_packet_4)          # 68o

        fnms    $ly_4,$b_4,$dy_4,$ly_4                  # 69e
            stqd    $nearest_5,448($a_packet_4)         # 69o

        fnms    $lx,$b_6,$dx_4,$lx                      # 70e
        fnms    $disc_8,$lx_7,$lx_7,$radius2            # 71e

        fnms    $ly_7,$b_2,$dy_2,$ly_2                  # 72e
        fnms    $disc_16,$lx_10,$lx_10,$radius2         # 73e

        fnms    $lz,$b_2,$dz_2,$lz_2                    # 74e
        fnms    $disc_5,$lx_9,$lx_9,$radius2            # 75e

        fnms    $ly_5,$b_6,$dy_5,$ly_5                  # 76e
        fnms    $disc_17,$lx,$lx,$radius2               # 77e

        fnms    $disc_8,$ly_7,$ly_7,$disc_8             # 78e
            cgti    $ahead_4,$t_3,0                     # 79e

        fnms    $disc_16,$ly_9,$ly_9,$disc_16           # 80e
        fnms    $lz_17,$b_6,$dz_8,$lz_5                 # 81e

        fnms    $disc_5,$ly_4,$ly_4,$disc_5             # 82e
        fnms    $lz_5,$b_3,$dz,$lz_3                    # 83e

        fnms    $lz_13,$b_4,$dz_4,$lz_4                 # 84e
        fnms    $disc_13,$lz,$lz,$disc_8                # 85e

            cgti    $ahead,$t_4,0                       # 86e
            and     $control,$control_2,$ahead_4        # 87e

            and     $control_7,$control_3,$ahead        # 88e
        fnms    $disc_17,$ly_5,$ly_5,$disc_17           # 89e

            andc    $control_7,$control_7,$disc_14      # 90e
            lnop                                        # 90o pairing

        fnms    $disc_14,$lz_13,$lz_13,$disc_5          # 91e
        frsqest $y,$disc_13                             # 91o

            andc    $control,$control,$disc_6           # 92e
            rotqbii $control_7,$control_7,1             # 92o

        fnms    $disc_6,$lz_5,$lz_5,$disc_16            # 93e
        lnop                                            # 93o pairing

            cgti    $ahead,$t_5,0                       # 94e
            rotqbii $control,$control,1                 # 94o

        fi      $y,$disc_13,$y                          # 95e
        hbrr    next_ball_back,next_ball                # 95o hint

            and     $control_11,$control_5,$ahead       # 96e
            gb      $control_7,$control_7               # 96o

        nop     $127                                    # 97e pairing
        frsqest $y_16,$disc_14                          # 97o

            andc    $control_11,$control_11,$disc_15    # 98e
            gb      $control,$control                   # 98o

        fnms    $disc_15,$lz_17,$lz_17,$disc_17         # 99e
        frsqest $y_13,$disc_6                           # 99o

        fms     $out_6,$b_3,$b_3,$disc_6                # 100e
            rotqbii $control_11,$control_11,1           # 100o

        fi      $y_16,$disc_14,$y_16                    # 101e
            shlqbii $control_7,$control_7,4             # 101o

            nop     $127                                # 102e pairing
            shlqbii $control,$control,4                 # 102o

        fm      $s,$disc_13,$y                          # 103e
        lqx     $m_by_side_3,$a_by_side,$sides_4        # 103o

        fi      $y_13,$disc_6,$y_13                     # 104e
            gb      $control_11,$control_11             # 104o

        nop     $127                                    # 105e pairing
        frsqest $y_11,$disc_15                          # 105o

        fms     $out_7,$b_6,$b_6,$disc_15               # 106e
            lqx     $control,$control,$a_controls       # 106o

        fm      $y_2,$y,$k_half                         # 107e
        lqd     $t_best_2,384($a_packet_3)              # 107o

        fm      $s_11,$disc_14,$y_16                    # 108e
            shlqbii $control_11,$control_11,4           # 108o

        fnms    $e_8,$s,$s,$disc_13                     # 109e
        lqd     $nearest_6,448($a_packet_3)             # 109o

        fi      $y_11,$disc_15,$y_11                    # 110e
        lqx     $whole_3,$a_whole,$sides_4              # 110o

            nop     $127                                # 111e pairing
            lqx     $control_10,$control_7,$a_controls  # 111o

        fm      $y_15,$y_16,$k_half                     # 112e
            shufb   $nearest_7,$nearest_8,$object_4,$control # 112o

        fm      $s_10,$disc_6,$y_13                     # 113e
next_ball_back:
        brnz    $count,next_ball                        # 113o

next_ball_drain:
        fma     $s,$e_8,$y_2,$s                         # 0e
        lqx     $control_11,$control_11,$a_controls     # 0o

        fm      $s_15,$disc_15,$y_11                    # 1e
        shufb   $t_best,$t_best,$t_3,$control           # 1o

        fm      $y,$y_13,$k_half                        # 2e
        shufb   $nearest,$nearest,$object_4,$control_10 # 2o

        fnms    $e_13,$s_10,$s_10,$disc_6               # 3e
        stqd    $nearest_7,464($a_packet_4)             # 3o

        fnms    $e,$s_11,$s_11,$disc_14                 # 4e
        shufb   $t_best_6,$t_best_3,$t_4,$control_10    # 4o

        fm      $y_16,$y_11,$k_half                     # 5e
        stqd    $t_best,400($a_packet_4)                # 5o

        fnms    $e_9,$s,$s,$disc_13                     # 6e
        lqd     $t_best,400($a_packet_3)                # 6o

        fnms    $e_10,$s_15,$s_15,$disc_15              # 7e
        shufb   $nearest_3,$nearest_3,$object_4,$control_11 # 7o

        fms     $out,$b_2,$b_2,$disc_13                 # 8e
        stqd    $nearest,480($a_packet_4)               # 8o

        fma     $s_16,$e_13,$y,$s_10                    # 9e
        shufb   $t_best_4,$t_best_4,$t_5,$control_11    # 9o

        fma     $s_13,$e,$y_15,$s_11                    # 10e
        lqd     $nearest,480($a_packet_3)               # 10o

        fms     $out_9,$b_4,$b_4,$disc_14               # 11e
        stqd    $t_best_6,416($a_packet_4)              # 11o

        fma     $s,$e_9,$y_2,$s                         # 12e
        stqd    $nearest_3,496($a_packet_4)             # 12o

        fma     $s_15,$e_10,$y_16,$s_15                 # 13e
        stqd    $t_best_4,432($a_packet_4)              # 13o

        nop     $127                                    # 14e pairing
        lqd     $t_best_3,416($a_packet_3)              # 14o

        fnms    $e,$s_16,$s_16,$disc_6                  # 15e
        lqd     $t_best_4,432($a_packet_3)              # 15o

        fnms    $e_9,$s_13,$s_13,$disc_14               # 16e
        shufb   $object_4,$object_3,$object_3,$m_x      # 16o

        nop     $127                                    # 17e pairing
        shlqbyi $a_packet_4,$a_packet_3,0               # 17o copy

        selb    $s,$s,$out,$m_by_side_3                 # 18e
        lqd     $nearest_8,464($a_packet_3)             # 18o

        fnms    $e_12,$s_15,$s_15,$disc_15              # 19e
        lqd     $nearest_3,496($a_packet_3)             # 19o

        fnms    $t,$s,$whole_3,$b_2                     # 20e
        lqx     $half_2,$a_half,$sides_4                # 20o

        fma     $s,$e,$y,$s_16                          # 21e
        hbr     isect_ball_pairs_newton2_r16_return,$lr # 21o hint

        fma     $s_13,$e_9,$y_15,$s_13                  # 22e
        fma     $s_15,$e_12,$y_16,$s_15                 # 25e

        cgt     $control,$t_best_2,$t                   # 26e
        cgti    $ahead,$t,0                             # 27e

        selb    $s,$s,$out_6,$m_by_side_3               # 28e
        and     $control,$control,$ahead                # 29e

        selb    $s_14,$s_13,$out_9,$m_by_side_3         # 30e
        andc    $control,$control,$disc_13              # 31e

        fnms    $t_3,$s,$whole_3,$b_3                   # 32e
        lnop                                            # 32o pairing

        fnms    $t_4,$s_14,$whole_3,$b_4                # 33e
        rotqbii $control,$control,1                     # 33o

        selb    $s,$s_15,$out_7,$m_by_side_3            # 34e
        fnms    $t_5,$s,$whole_3,$b_6                   # 36e

        gb      $control,$control                       # 37o
        cgt     $control_2,$t_best,$t_3                 # 38e

        cgti    $ahead_4,$t_3,0                         # 39e
        cgt     $control_3,$t_best_3,$t_4               # 40e

        cgti    $ahead,$t_4,0                           # 41e
        shlqbii $control,$control,4                     # 41o

        and     $control_11,$control_2,$ahead_4         # 42e
        cgt     $control_5,$t_best_4,$t_5               # 43e

        and     $control_7,$control_3,$ahead            # 44e
        lnop                                            # 44o pairing

        andc    $control_11,$control_11,$disc_6         # 45e
        lqx     $control,$control,$a_controls           # 45o

        cgti    $ahead,$t_5,0                           # 46e
        lnop                                            # 46o pairing

        andc    $control_7,$control_7,$disc_14          # 47e
        rotqbii $control_11,$control_11,1               # 47o

        and     $control_12,$control_5,$ahead           # 48e
        rotqbii $control_7,$control_7,1                 # 49o

        andc    $control_12,$control_12,$disc_15        # 50e
        gb      $control_11,$control_11                 # 51o

        rotqbii $control_12,$control_12,1               # 52o
        shufb   $t_best_5,$t_best_2,$t,$control         # 53o

        gb      $control_7,$control_7                   # 54o
        shufb   $nearest_5,$nearest_6,$object_4,$control # 55o

        shlqbii $control,$control_11,4                  # 56o
        gb      $control_11,$control_12                 # 57o

        stqd    $t_best_5,384($a_packet_4)              # 58o
        shlqbii $control_7,$control_7,4                 # 59o

        stqd    $nearest_5,448($a_packet_4)             # 60o
        lqx     $control,$control,$a_controls           # 61o

        shlqbii $control_11,$control_11,4               # 62o
        lqx     $control_10,$control_7,$a_controls      # 63o

        lqx     $control_11,$control_11,$a_controls     # 66o
        shufb   $nearest_7,$nearest_8,$object_4,$control # 67o

        shufb   $t_best,$t_best,$t_3,$control           # 68o
        shufb   $nearest,$nearest,$object_4,$control_10 # 69o

        shufb   $t_best_6,$t_best_3,$t_4,$control_10    # 70o
        stqd    $nearest_7,464($a_packet_4)             # 71o

        shufb   $nearest_3,$nearest_3,$object_4,$control_11 # 72o
        stqd    $t_best,400($a_packet_4)                # 73o

        shufb   $t_best_4,$t_best_4,$t_5,$control_11    # 74o
        stqd    $nearest,480($a_packet_4)               # 75o

        stqd    $t_best_6,416($a_packet_4)              # 76o
        stqd    $nearest_3,496($a_packet_4)             # 77o

        stqd    $t_best_4,432($a_packet_4)              # 78o
isect_ball_pairs_newton2_r16_return:
        bi      $lr                                     # 79o

next_ball_short:
        ai      $count,$count,-1                        # 0e
        lqd     $object,0($a_candidate)                 # 0o

        ai      $a_candidate,$a_candidate,16            # 1e
        lqd     $quad,0($object)                        # 6o

        rotqbyi $a_packet,$object,4                     # 7o
        lqd     $sides,32($object)                      # 8o

        shufb   $object,$object,$object,$m_x            # 9o
        lqd     $ox,16($a_packet)                       # 11o

        lqd     $ox_11,0($a_packet)                     # 12o
        lqd     $dx,192($a_packet)                      # 13o

        lqd     $oy,80($a_packet)                       # 14o
        lqd     $oz,144($a_packet)                      # 15o

        shufb   $cx,$quad,$quad,$m_x                    # 16o
        lqd     $dx_8,208($a_packet)                    # 17o

        lqd     $dy,272($a_packet)                      # 18o
        shufb   $cy,$quad,$quad,$m_y                    # 19o

        fs      $lx,$cx,$ox_11                          # 20e
        lqd     $dy_8,256($a_packet)                    # 20o

        fs      $lx_2,$cx,$ox                           # 21e
        lqd     $oy_9,64($a_packet)                     # 21o

        nop     $127                                    # 22e pairing
        shufb   $cz,$quad,$quad,$m_z                    # 22o

        fs      $ly,$cy,$oy                             # 23e
        lqd     $ox,48($a_packet)                       # 23o

        lqd     $oz_9,128($a_packet)                    # 24o
        lqd     $ox_9,32($a_packet)                     # 25o

        fm      $b,$lx,$dx                              # 26e
        lqd     $oy,96($a_packet)                       # 26o

        fm      $b_14,$lx_2,$dx_8                       # 27e
        lqd     $dz,320($a_packet)                      # 27o

        fs      $lz,$cz,$oz                             # 28e
        lqd     $dz_7,336($a_packet)                    # 28o

        fs      $ly_11,$cy,$oy_9                        # 29e
        lqd     $dx_9,240($a_packet)                    # 29o

        fs      $lz_18,$cz,$oz_9                        # 30e
        lqd     $oz,160($a_packet)                      # 30o

        fs      $lx_11,$cx,$ox                          # 31e
        lqd     $oy_7,112($a_packet)                    # 31o

        fs      $ly_5,$cy,$oy                           # 32e
        lqd     $oz_10,176($a_packet)                   # 32o

        fma     $b_14,$ly,$dy,$b_14                     # 33e
        lqd     $dx_10,224($a_packet)                   # 33o

        fs      $lx_6,$cx,$ox_9                         # 34e
        lqd     $dz_9,352($a_packet)                    # 34o

        fma     $b,$ly_11,$dy_8,$b                      # 35e
        lqd     $dy_9,304($a_packet)                    # 35o

        fs      $lz_19,$cz,$oz                          # 36e
        shufb   $radius2_5,$sides,$sides,$m_x           # 36o

        fm      $b_15,$lx_11,$dx_9                      # 37e
        lqd     $dz_10,368($a_packet)                   # 37o

        fs      $ly_12,$cy,$oy_7                        # 38e
        lqd     $dy_10,288($a_packet)                   # 38o

        fma     $b_14,$lz,$dz_7,$b_14                   # 39e
        rotqbyi $sides,$sides,12                        # 39o

        fm      $b_16,$lx_6,$dx_10                      # 40e
        lqd     $t_best_7,400($a_packet)                # 40o

        fma     $b,$lz_18,$dz,$b                        # 41e
        lqd     $t_best_5,384($a_packet)                # 41o

        fm      $radius2_5,$radius2_5,$radius2_5        # 42e
        lqd     $t_best_8,432($a_packet)                # 42o

        fs      $lz_20,$cz,$oz_10                       # 43e
        lqd     $t_best_9,416($a_packet)                # 43o

        fma     $b_15,$ly_12,$dy_9,$b_15                # 44e
        lqd     $nearest_9,448($a_packet)               # 44o

        fnms    $lx_7,$b_14,$dx_8,$lx_2                 # 45e
        lqd     $nearest_10,464($a_packet)              # 45o

        fma     $b_16,$ly_5,$dy_10,$b_16                # 46e
        lqd     $nearest_11,496($a_packet)              # 46o

        fnms    $ly_13,$b,$dy_8,$ly_11                  # 47e
        lqd     $nearest_12,480($a_packet)              # 47o

        fnms    $lx,$b,$dx,$lx                          # 48e
        fnms    $ly,$b_14,$dy,$ly                       # 49e

        fma     $b_17,$lz_20,$dz_10,$b_15               # 50e
        fnms    $disc_8,$lx_7,$lx_7,$radius2_5          # 51e

        fma     $b_18,$lz_19,$dz_9,$b_16                # 52e
        fnms    $lz,$b_14,$dz_7,$lz                     # 53e

        fnms    $disc_17,$lx,$lx,$radius2_5             # 54e
        fnms    $lz_18,$b,$dz,$lz_18                    # 55e

        fnms    $lx,$b_17,$dx_9,$lx_11                  # 56e
        fnms    $disc_8,$ly,$ly,$disc_8                 # 57e

        fnms    $lx_6,$b_18,$dx_10,$lx_6                # 58e
        fnms    $ly,$b_18,$dy_10,$ly_5                  # 59e

        fnms    $disc_16,$ly_13,$ly_13,$disc_17         # 60e
        fnms    $lz_20,$b_17,$dz_10,$lz_20              # 61e

        fnms    $disc_17,$lx,$lx,$radius2_5             # 62e
        fnms    $disc_8,$lz,$lz,$disc_8                 # 63e

        fnms    $disc,$lx_6,$lx_6,$radius2_5            # 64e
        fnms    $ly_10,$b_17,$dy_9,$ly_12               # 65e

        fnms    $disc_16,$lz_18,$lz_18,$disc_16         # 66e
        fnms    $lz,$b_18,$dz_9,$lz_19                  # 67e

        rotmi   $sides,$sides,-26                       # 68e
        lnop                                            # 68o pairing

        fms     $out,$b_14,$b_14,$disc_8                # 69e
        frsqest $y,$disc_8                              # 69o

        fnms    $disc,$ly,$ly,$disc                     # 70e
        fnms    $disc_5,$ly_10,$ly_10,$disc_17          # 71e

        fms     $out_10,$b,$b,$disc_16                  # 72e
        frsqest $y_17,$disc_16                          # 72o

        fi      $y,$disc_8,$y                           # 73e
        lqx     $m_by_side,$a_by_side,$sides            # 73o

        lqx     $whole,$a_whole,$sides                  # 74o
        lqx     $half,$a_half,$sides                    # 75o

        fi      $y_17,$disc_16,$y_17                    # 76e
        fnms    $disc_5,$lz_20,$lz_20,$disc_5           # 78e

        fnms    $disc,$lz,$lz,$disc                     # 79e
        fm      $y_18,$y,$k_half                        # 80e

        fm      $s,$disc_8,$y                           # 81e
        fm      $s_17,$disc_16,$y_17                    # 83e

        fm      $y,$y_17,$k_half                        # 84e
        frsqest $y_17,$disc_5                           # 84o

        fms     $out_11,$b_17,$b_17,$disc_5             # 85e
        frsqest $y_19,$disc                             # 85o

        fms     $out_12,$b_18,$b_18,$disc               # 86e
        fnms    $e_8,$s,$s,$disc_8                      # 87e

        fi      $y_17,$disc_5,$y_17                     # 88e
        fi      $y_19,$disc,$y_19                       # 89e

        fnms    $e_14,$s_17,$s_17,$disc_16              # 91e
        fma     $s,$e_8,$y_18,$s                        # 93e

        fm      $s_18,$disc_5,$y_17                     # 95e
        fm      $s_19,$disc,$y_19                       # 96e

        fma     $s_17,$e_14,$y,$s_17                    # 97e
        fm      $y_19,$y_19,$k_half                     # 98e

        fnms    $e_14,$s,$s,$disc_8                     # 99e
        fm      $y_17,$y_17,$k_half                     # 100e

        fnms    $e_15,$s_18,$s_18,$disc_5               # 101e
        fnms    $e_16,$s_19,$s_19,$disc                 # 102e

        fnms    $e_17,$s_17,$s_17,$disc_16              # 103e
        fma     $s,$e_14,$y_18,$s                       # 105e

        fma     $s_20,$e_15,$y_17,$s_18                 # 107e
        fma     $s_18,$e_16,$y_19,$s_19                 # 108e

        fma     $s_17,$e_17,$y,$s_17                    # 109e
        selb    $s,$s,$out,$m_by_side                   # 111e

        fnms    $t_6,$s,$whole,$b_14                    # 113e
        fnms    $e_14,$s_20,$s_20,$disc_5               # 114e

        selb    $s,$s_17,$out_10,$m_by_side             # 115e
        fnms    $e_10,$s_18,$s_18,$disc                 # 116e

        fnms    $t_7,$s,$whole,$b                       # 117e
        cgti    $ahead_5,$t_6,0                         # 119e

        cgt     $control_13,$t_best_7,$t_6              # 120e
        fma     $s,$e_14,$y_17,$s_20                    # 121e

        fma     $s_21,$e_10,$y_19,$s_18                 # 122e
        cgt     $control_14,$t_best_5,$t_7              # 123e

        and     $control_15,$control_13,$ahead_5        # 124e
        cgti    $ahead_6,$t_7,0                         # 125e

        andc    $control_7,$control_15,$disc_8          # 126e
        and     $control_14,$control_14,$ahead_6        # 127e

        selb    $s_21,$s_21,$out_12,$m_by_side          # 128e
        rotqbii $control_7,$control_7,1                 # 128o

        andc    $control_11,$control_14,$disc_16        # 129e
        fnms    $t_8,$s_21,$whole,$b_18                 # 130e

        selb    $s,$s,$out_11,$m_by_side                # 131e
        rotqbii $control_11,$control_11,1               # 131o

        gb      $control_7,$control_7                   # 132o
        fnms    $t_9,$s,$whole,$b_17                    # 133e

        nop     $127                                    # 134e pairing
        gb      $control_11,$control_11                 # 135o

        cgti    $ahead_7,$t_8,0                         # 136e
        shlqbii $control_7,$control_7,4                 # 136o

        cgt     $control_6,$t_best_9,$t_8               # 137e
        lnop                                            # 137o pairing

        cgti    $ahead_6,$t_9,0                         # 139e
        shlqbii $control_11,$control_11,4               # 139o

        and     $control_15,$control_6,$ahead_7         # 140e
        lqx     $control_7,$control_7,$a_controls       # 140o

        cgt     $control_6,$t_best_8,$t_9               # 141e
        andc    $control_15,$control_15,$disc           # 142e

        and     $control_6,$control_6,$ahead_6          # 143e
        lqx     $control_11,$control_11,$a_controls     # 143o

        rotqbii $control_15,$control_15,1               # 144o
        andc    $control_8,$control_6,$disc_5           # 145e

        shufb   $nearest,$nearest_10,$object,$control_7 # 146o
        rotqbii $control_4,$control_8,1                 # 147o

        gb      $control_8,$control_15                  # 148o
        shufb   $t_best,$t_best_7,$t_6,$control_7       # 149o

        stqd    $nearest,464($a_packet)                 # 150o
        gb      $control_7,$control_4                   # 151o

        shlqbii $control_4,$control_8,4                 # 152o
        stqd    $t_best,400($a_packet)                  # 153o

        shufb   $t_best,$t_best_5,$t_7,$control_11      # 154o
        shlqbii $control_7,$control_7,4                 # 155o

        shufb   $nearest,$nearest_9,$object,$control_11 # 156o
        lqx     $control,$control_4,$a_controls         # 157o

        stqd    $t_best,384($a_packet)                  # 158o
        lqx     $control_11,$control_7,$a_controls      # 159o

        stqd    $nearest,448($a_packet)                 # 160o
        hbrr    next_ball_short_back,next_ball_short    # 161o hint

        shufb   $t_best,$t_best_9,$t_8,$control         # 163o
        shufb   $nearest,$nearest_12,$object,$control   # 164o

        shufb   $t_best_10,$t_best_8,$t_9,$control_11   # 165o
        shufb   $nearest_4,$nearest_11,$object,$control_11 # 166o

        stqd    $t_best,416($a_packet)                  # 167o
        stqd    $nearest,480($a_packet)                 # 168o

        stqd    $t_best_10,432($a_packet)               # 169o
        stqd    $nearest_4,496($a_packet)               # 170o

        nop     $127                                    # 171e pairing
next_ball_short_back:
        brnz    $count,next_ball_short                  # 176o

        nop     $127                                    # 172e pairing
        bi      $lr                                     # 172o
endfunction isect_ball_pairs_newton2_r16
