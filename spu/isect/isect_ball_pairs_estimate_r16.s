# isect_ball_pairs_estimate_r16   nearest hit of packets' rays with spheres, by a root's estimate
#   C       void isect_ball_pairs_estimate_r16(const struct candidate *, int count);
#   In      $3 candidates of objects that are spheres, $4 count (0 is none); pointers 16-aligned
#   Out     the candidates' packets: t, object, where a hit has 0 < t < what was there
#   Uses    $2-$70, $79   Saves  -   Stack  0   Calls  -
#   Domain  |d| = 1 within 4 ulp; coordinates and radius below 2^62, radius above 2^-40
#   Error   500000 ulp of the larger of t and r, origin up to 30 radii from the centre but not
#           within a tenth of one from the surface, ray within 0.995 r of it
#   Twin    oracle/src/twin/sphere/perpendicular.rs
#
# The steps are those of sphere_tmpl.inc: of the crossings the entry is asked for, with SIDES_EXIT the
# exit, and with SIDES_BOTH the exit of a ray from inside.
# Scheduled by spu schedule from isect_ball_pairs_estimate_r16.s

        .include "work_unit.inc"
        .include "macros.inc"
        .include "pairs.inc"
        .include "sphere_tmpl.inc"
        .include "sphere_estimate.inc"

        .set    a_candidate,3
        .set    count,4
        # constants
        .set    m_x,10
        .set    m_y,11
        .set    m_z,12
        .set    m_sign,13
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
        .set    t,45
        .set    ahead,46
        .set    control,47

        sign_controls_table
        sides_tables 0x3f000000, 0x3f800000

function isect_ball_pairs_estimate_r16
        .set    count_2,79
        .set    a_candidate_2,2
        .set    object_2,5
        .set    object_3,9
        .set    a_packet_2,2
        .set    a_packet_3,22
        .set    ox_2,8
        .set    dx_2,46
        .set    cx_2,6
        .set    cy_2,26
        .set    ox_3,32
        .set    oy_2,40
        .set    dy_2,55
        .set    lx_2,32
        .set    dx_3,7
        .set    lx_3,8
        .set    dx_4,49
        .set    b_2,56
        .set    dz_2,44
        .set    ly_2,18
        .set    oy_3,34
        .set    lz_2,19
        .set    oz_2,42
        .set    ox_4,30
        .set    b_3,48
        .set    dy_3,20
        .set    b_4,57
        .set    oy_4,33
        .set    b_5,53
        .set    oz_3,29
        .set    ly_3,34
        .set    dy_4,40
        .set    lz_3,42
        .set    dz_3,51
        .set    lx_4,6
        .set    dx_5,28
        .set    radius2_2,27
        .set    ly_4,33
        .set    dy_5,41
        .set    b_6,21
        .set    dz_4,58
        .set    dz_5,52
        .set    b_7,54
        .set    b_8,24
        .set    quad_2,26
        .set    t_best_2,62
        .set    oy_5,29
        .set    lz_4,23
        .set    dx_6,31
        .set    b_9,36
        .set    dy_6,43
        .set    cx_3,45
        .set    lx_5,7
        .set    cy_3,32
        .set    disc_2,35
        .set    ox_5,37
        .set    t_best_3,63
        .set    oz_4,20
        .set    ox_6,44
        .set    ox_7,46
        .set    disc_3,7
        .set    cz_2,26
        .set    oy_6,38
        .set    dx_7,40
        .set    sides_2,50
        .set    t_best_4,64
        .set    disc_4,8
        .set    oy_7,25
        .set    disc_5,19
        .set    m_by_side_2,56
        .set    whole_2,47
        .set    sides_3,51
        .set    disc_6,6
        .set    dz_6,27
        .set    out_2,33
        .set    y_2,41
        .set    disc_7,42
        .set    oz_5,53
        .set    lz_5,7
        .set    oz_6,23
        .set    dy_7,39
        .set    lx_6,30
        .set    dy_8,54
        .set    oz_7,52
        .set    s_2,18
        .set    y_3,57
        .set    y_4,18
        .set    radius2_3,41
        .set    out_3,58
        .set    y_5,59
        .set    t_2,60
        .set    dz_7,65
        .set    dz_8,66
        .set    b_10,61
        .set    nearest_2,67
        .set    s_3,7
        .set    dz_9,68
        .set    y_6,5
        .set    sides_4,29
        .set    s_4,21
        .set    a_packet_4,7
        .set    ahead_2,51
        .set    half_2,50
        .set    t_3,5
        .set    nearest_3,69
        .set    control_2,48
        .set    nearest_4,70
        .set    y_7,50
        .set    nearest_5,21
        .set    control_3,2
        .set    lx_7,44
        .set    t_4,19
        .set    lx_8,36
        .set    b_11,37
        .set    ahead_3,48
        .set    lx_9,46
        .set    lz_6,20
        .set    s_5,45
        .set    y_8,45
        .set    b_12,59
        .set    control_4,24
        .set    ly_5,2
        .set    control_5,37
        .set    control_6,38
        .set    ly_6,25
        .set    ahead_4,32
        .set    t_best_5,42
        .set    control_7,32
        .set    nearest_6,24
        .set    ahead_5,37
        .set    lz_7,51
        .set    control_8,8
        .set    b_13,32
        .set    lz_8,26
        .set    control_9,6
        .set    b_14,52
        .set    ly_7,8
        .set    whole_3,31
        .set    b_15,33
        .set    disc_8,29
        .set    lx_10,27
        .set    lx_11,24
        .set    nearest_7,28
        .set    t_best_6,5
        .set    nearest_8,60
        .set    disc_9,24
        .set    nearest_9,61
        .set    disc_10,27
        .set    t_best_7,29
        .set    disc_11,30
        .set    disc_12,28
        .set    lz_9,5
        .set    disc_13,20
        .set    disc_14,2
        .set    disc_15,5
        .set    nearest_10,6
        .set    out_4,6
        .set    out_5,8
        .set    y_9,19
        .set    y_10,20
        .set    s_6,6
        .set    y_11,6
        .set    t_5,6
        .set    cx_4,20
        .set    control_10,28
        .set    ahead_6,31
        .set    lx_12,20
        .set    dy_9,30
        .set    dx_8,29
        .set    b_16,44
        .set    t_6,43
        .set    ly_8,26
        .set    lz_10,25
        .set    control_11,53
        .set    ahead_7,54
        .set    control_12,31
        .set    control_13,5
        .set    ly_9,28
        .set    t_best_8,19
        .set    lx_13,29
        .set    nearest_11,20
        .set    t_best_9,2
        .set    ly_10,6
        .set    out_6,3
        .set    y_12,4
        .set    ahead_8,3
        .set    control_14,4
        .set    control_15,3
        .set    t_best_10,3
        .set    ox_8,2
        .set    dx_9,5
        .set    ox_9,6
        .set    lx_14,2
        .set    oy_8,8
        .set    oy_9,9
        .set    oy_10,23
        .set    radius2_4,26
        .set    dy_10,27
        .set    oz_8,28
        .set    b_17,29
        .set    ly_11,23
        .set    cz_3,20
        .set    ly_12,9
        .set    oz_9,22
        .set    dz_10,35
        .set    oz_10,36
        .set    lx_15,21
        .set    dz_11,41
        .set    lz_11,22
        .set    dy_11,42
        .set    lz_12,28
        .set    dz_12,36
        .set    t_best_11,43
        .set    t_best_12,45
        .set    t_best_13,46
        .set    nearest_12,47
        .set    t_best_14,48
        .set    nearest_13,49
        .set    whole_4,32
        .set    m_by_side_3,50
        .set    nearest_14,33
        .set    half_3,5
        .set    ly_13,5
        .set    nearest_15,23
        .set    b_18,25
        .set    b_19,27
        .set    y_13,9
        .set    y_14,7
        .set    t_7,7
        .set    y_15,8
        .set    t_8,8
        .set    control_16,20
        .set    ahead_9,21
        .set    out_7,22
        .set    y_16,24
        .set    ahead_10,26
        .set    t_9,9
        .set    y_17,21
        .set    t_10,21
        .set    ahead_11,22
        .set    control_17,22
        .set    t_best_15,6
        .set    nearest_16,5
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

        lqd     $quad,0($object_2)                      # 20o
        lqd     $sides,32($object_2)                    # 21o

        rotqbyi $a_packet_3,$object_3,4                 # 22o
        lqd     $ox_2,16($a_packet_2)                   # 23o

        lqd     $oy,80($a_packet_2)                     # 24o
        lqd     $dx_2,208($a_packet_2)                  # 25o

        shufb   $cx_2,$quad,$quad,$m_x                  # 26o
        shufb   $cy_2,$quad,$quad,$m_y                  # 27o

        lqd     $ox_3,32($a_packet_2)                   # 28o
        lqd     $ox,0($a_packet_2)                      # 29o

        fs      $lx,$cx_2,$ox_2                         # 30e
        shufb   $cz,$quad,$quad,$m_z                    # 30o

        fs      $ly,$cy_2,$oy                           # 31e
        lqd     $oy_2,96($a_packet_2)                   # 31o

        lqd     $oz,144($a_packet_2)                    # 32o
        lqd     $dy_2,272($a_packet_2)                  # 33o

        fs      $lx_2,$cx_2,$ox_3                       # 34e
        lqd     $dx_3,224($a_packet_2)                  # 34o

        fs      $lx_3,$cx_2,$ox                         # 35e
        lqd     $dx_4,192($a_packet_2)                  # 35o

        fm      $b_2,$lx,$dx_2                          # 36e
        lqd     $dz_2,336($a_packet_2)                  # 36o

        fs      $ly_2,$cy_2,$oy_2                       # 37e
        lqd     $oy_3,64($a_packet_2)                   # 37o

        fs      $lz_2,$cz,$oz                           # 38e
        lqd     $oz_2,160($a_packet_2)                  # 38o

        nop     $127                                    # 39e pairing
        lqd     $ox_4,48($a_packet_2)                   # 39o

        fm      $b_3,$lx_2,$dx_3                        # 40e
        lqd     $dy_3,288($a_packet_2)                  # 40o

        fm      $b_4,$lx_3,$dx_4                        # 41e
        lqd     $oy_4,112($a_packet_2)                  # 41o

        fma     $b_5,$ly,$dy_2,$b_2                     # 42e
        lqd     $oz_3,128($a_packet_2)                  # 42o

        fs      $ly_3,$cy_2,$oy_3                       # 43e
        lqd     $dy_4,256($a_packet_2)                  # 43o

        fs      $lz_3,$cz,$oz_2                         # 44e
        lqd     $dz_3,352($a_packet_2)                  # 44o

        fs      $lx_4,$cx_2,$ox_4                       # 45e
        lqd     $dx_5,240($a_packet_2)                  # 45o

        fma     $b_3,$ly_2,$dy_3,$b_3                   # 46e
        shufb   $radius2_2,$sides,$sides,$m_x           # 46o

        fs      $ly_4,$cy_2,$oy_4                       # 47e
        lqd     $dy_5,304($a_packet_2)                  # 47o

        fma     $b_6,$lz_2,$dz_2,$b_5                   # 48e
        lqd     $dz_4,320($a_packet_2)                  # 48o

        fs      $lz,$cz,$oz_3                           # 49e
        lqd     $oz,176($a_packet_2)                    # 49o

        fm      $radius2_2,$radius2_2,$radius2_2        # 50e
        lqd     $dz_5,368($a_packet_2)                  # 50o

        fma     $b_7,$ly_3,$dy_4,$b_4                   # 51e
        rotqbyi $sides,$sides,12                        # 51o

        fm      $b_8,$lx_4,$dx_5                        # 52e
        lqd     $quad_2,0($object_3)                    # 52o

        fma     $b_3,$lz_3,$dz_3,$b_3                   # 53e
        lqd     $ox_4,48($a_packet_3)                   # 53o

        fnms    $lx,$b_6,$dx_2,$lx                      # 54e
        lqd     $t_best_2,400($a_packet_2)              # 54o

        fnms    $ly,$b_6,$dy_2,$ly                      # 55e
        lqd     $oy_5,112($a_packet_3)                  # 55o

        fs      $lz_4,$cz,$oz                           # 56e
        lqd     $dx_6,240($a_packet_3)                  # 56o

        fma     $b_9,$lz,$dz_4,$b_7                     # 57e
        lqd     $dy_6,304($a_packet_3)                  # 57o

        fma     $b_8,$ly_4,$dy_5,$b_8                   # 58e
        shufb   $cx_3,$quad_2,$quad_2,$m_x              # 58o

        fnms    $lx_5,$b_3,$dx_3,$lx_2                  # 59e
        shufb   $cy_3,$quad_2,$quad_2,$m_y              # 59o

        fnms    $disc_2,$lx,$lx,$radius2_2              # 60e
        lqd     $ox_5,0($a_packet_3)                    # 60o

        fnms    $ly_2,$b_3,$dy_3,$ly_2                  # 61e
        lqd     $t_best_3,416($a_packet_2)              # 61o

        fnms    $lz_2,$b_6,$dz_2,$lz_2                  # 62e
        lqd     $oz_4,176($a_packet_3)                  # 62o

        fnms    $lx_3,$b_9,$dx_4,$lx_3                  # 63e
        lqd     $ox_6,16($a_packet_3)                   # 63o

        fma     $b_8,$lz_4,$dz_5,$b_8                   # 64e
        lqd     $ox_7,32($a_packet_3)                   # 64o

        fnms    $disc_3,$lx_5,$lx_5,$radius2_2          # 65e
        shufb   $cz_2,$quad_2,$quad_2,$m_z              # 65o

        fnms    $disc_2,$ly,$ly,$disc_2                 # 66e
        lqd     $oy_6,96($a_packet_3)                   # 66o

        fnms    $ly_3,$b_9,$dy_4,$ly_3                  # 67e
        lqd     $dx_7,208($a_packet_3)                  # 67o

        rotmi   $sides_2,$sides,-26                     # 68e
        lqd     $t_best_4,384($a_packet_2)              # 68o

        fnms    $disc_4,$lx_3,$lx_3,$radius2_2          # 69e
        lqd     $oy_7,64($a_packet_3)                   # 69o

        fnms    $lx_4,$b_8,$dx_5,$lx_4                  # 70e
        lqd     $dx_5,224($a_packet_3)                  # 70o

        fnms    $lz_3,$b_3,$dz_3,$lz_3                  # 71e
        lqd     $dx_4,192($a_packet_3)                  # 71o

        fnms    $disc_5,$lz_2,$lz_2,$disc_2             # 72e
        lqx     $m_by_side_2,$a_by_side,$sides_2        # 72o

        fnms    $disc_3,$ly_2,$ly_2,$disc_3             # 73e
        lqx     $whole_2,$a_whole,$sides_2              # 73o

        fnms    $lz,$b_9,$dz_4,$lz                      # 74e
        lqd     $sides_3,32($object_3)                  # 74o

        fnms    $disc_4,$ly_3,$ly_3,$disc_4             # 75e
        lqd     $oy_3,80($a_packet_3)                   # 75o

        fnms    $disc_6,$lx_4,$lx_4,$radius2_2          # 76e
        lqd     $dz_6,368($a_packet_3)                  # 76o

        fnms    $ly_2,$b_8,$dy_5,$ly_4                  # 77e
        lqd     $dy_2,272($a_packet_3)                  # 77o

        fms     $out_2,$b_6,$b_6,$disc_5                # 78e
        frsqest $y_2,$disc_5                            # 78o

        fnms    $disc_7,$lz_3,$lz_3,$disc_3             # 79e
        lqd     $oz_5,144($a_packet_3)                  # 79o

        fnms    $lz_5,$b_8,$dz_5,$lz_4                  # 80e
        lqd     $oz_6,128($a_packet_3)                  # 80o

        fnms    $disc_4,$lz,$lz,$disc_4                 # 81e
        lqd     $dy_7,288($a_packet_3)                  # 81o

        fs      $lx_6,$cx_3,$ox_4                       # 82e
        lqd     $dy_8,256($a_packet_3)                  # 82o

        fnms    $disc_6,$ly_2,$ly_2,$disc_6             # 83e
        lqd     $oz_7,160($a_packet_3)                  # 83o

        selb    $s_2,$whole_2,$out_2,$m_by_side_2       # 84e
        lqd     $t_best,432($a_packet_2)                # 84o

        fms     $out_2,$b_3,$b_3,$disc_7                # 85e
        frsqest $y_3,$disc_7                            # 85o

        selb    $y_4,$y_2,$s_2,$m_sign                  # 86e
        shufb   $radius2_3,$sides_3,$sides_3,$m_x       # 86o

        fms     $out_3,$b_9,$b_9,$disc_4                # 87e
        frsqest $y_5,$disc_4                            # 87o

        fnms    $t_2,$disc_5,$y_4,$b_6                  # 88e
        lqd     $dz_7,352($a_packet_3)                  # 88o

        fnms    $disc_6,$lz_5,$lz_5,$disc_6             # 89e
        lqd     $dz_8,336($a_packet_3)                  # 89o

        fm      $b_10,$lx_6,$dx_6                       # 90e
        lqd     $nearest_2,464($a_packet_2)             # 90o

        selb    $s_3,$whole_2,$out_2,$m_by_side_2       # 91e
        lqd     $dz_9,320($a_packet_3)                  # 91o

        fs      $ly_4,$cy_3,$oy_5                       # 92e
        shufb   $object,$object_2,$object_2,$m_x        # 92o

        selb    $y_6,$y_3,$s_3,$m_sign                  # 93e
        rotqbyi $sides_4,$sides_3,12                    # 93o

        selb    $s_4,$whole_2,$out_3,$m_by_side_2       # 94e
        shlqbyi $a_packet_4,$a_packet_2,0               # 94o copy

        cgti    $ahead_2,$t_2,0                         # 95e
        frsqest $y_3,$disc_6                            # 95o

        fms     $out_3,$b_8,$b_8,$disc_6                # 96e
        lqx     $half_2,$a_half,$sides_2                # 96o

        fnms    $t_3,$disc_7,$y_6,$b_3                  # 97e
        lqd     $nearest_3,480($a_packet_2)             # 97o

        cgt     $control_2,$t_best_2,$t_2               # 98e
        lqd     $nearest_4,448($a_packet_2)             # 98o

        selb    $y_7,$y_5,$s_4,$m_sign                  # 99e
        lqd     $nearest_5,496($a_packet_2)             # 99o

        and     $control_3,$control_2,$ahead_2          # 100e
        fs      $lx_7,$cx_3,$ox_6                       # 101e

        andc    $control_3,$control_3,$disc_5           # 102e
        fnms    $t_4,$disc_4,$y_7,$b_9                  # 103e

        fs      $lx_8,$cx_3,$ox_5                       # 104e
        rotqbii $control_3,$control_3,1                 # 104o

        fma     $b_11,$ly_4,$dy_6,$b_10                 # 105e
        cgti    $ahead_3,$t_3,0                         # 106e

        fs      $lx_9,$cx_3,$ox_7                       # 107e
        lnop                                            # 107o pairing

        fs      $lz_6,$cz_2,$oz_4                       # 108e
        gb      $control_3,$control_3                   # 108o

        selb    $s_5,$whole_2,$out_3,$m_by_side_2       # 109e
        cgt     $control,$t_best_3,$t_3                 # 110e

        selb    $y_8,$y_3,$s_5,$m_sign                  # 111e
        lnop                                            # 111o pairing

        and     $control,$control,$ahead_3              # 112e
        shlqbii $control_3,$control_3,4                 # 112o

        fs      $ly_3,$cy_3,$oy_3                       # 113e
        fm      $b_4,$lx_8,$dx_4                        # 114e

        fma     $b_12,$lz_6,$dz_6,$b_11                 # 115e
        lnop                                            # 115o pairing

        fnms    $t,$disc_6,$y_8,$b_8                    # 116e
        lqx     $control_4,$control_3,$a_controls       # 116o

        fm      $b_3,$lx_9,$dx_5                        # 117e
        fs      $ly_5,$cy_3,$oy_6                       # 118e

        cgt     $control_5,$t_best_4,$t_4               # 119e
        andc    $control_6,$control,$disc_7             # 120e

        fs      $ly_6,$cy_3,$oy_7                       # 121e
        lnop                                            # 121o pairing

        cgti    $ahead_4,$t_4,0                         # 122e
        rotqbii $control_6,$control_6,1                 # 122o

        fm      $b_2,$lx_7,$dx_7                        # 123e
        shufb   $t_best_5,$t_best_2,$t_2,$control_4     # 123o

        and     $control_7,$control_5,$ahead_4          # 124e
        shufb   $nearest_6,$nearest_2,$object,$control_4 # 124o

        cgti    $ahead_5,$t,0                           # 125e
        lnop                                            # 125o pairing

        fs      $lz_4,$cz_2,$oz_6                       # 126e
        gb      $control_6,$control_6                   # 126o

        fs      $lz_7,$cz_2,$oz_5                       # 127e
        andc    $control_8,$control_7,$disc_4           # 128e

        fma     $b_5,$ly_3,$dy_2,$b_2                   # 129e
        lnop                                            # 129o pairing

        fma     $b_13,$ly_6,$dy_8,$b_4                  # 130e
        rotqbii $control_8,$control_8,1                 # 130o

        cgt     $control,$t_best,$t                     # 131e
        shlqbii $control_6,$control_6,4                 # 131o

        fs      $lz_8,$cz_2,$oz_7                       # 132e
        fm      $radius2_3,$radius2_3,$radius2_3        # 133e

        fma     $b_3,$ly_5,$dy_7,$b_3                   # 134e
        gb      $control_8,$control_8                   # 134o

        fnms    $lx_6,$b_12,$dx_6,$lx_6                 # 135e
        lqx     $control_6,$control_6,$a_controls       # 135o

        and     $control,$control,$ahead_5              # 136e
        rotmi   $sides_2,$sides_4,-26                   # 137e

        andc    $control,$control,$disc_6               # 138e
        shlqbii $control_9,$control_8,4                 # 138o

        fma     $b_14,$lz_4,$dz_9,$b_13                 # 139e
        lnop                                            # 139o pairing

        fma     $b_3,$lz_8,$dz_7,$b_3                   # 140e
        rotqbii $control,$control,1                     # 140o

        fnms    $ly_7,$b_12,$dy_6,$ly_4                 # 141e
        lqx     $whole_3,$a_whole,$sides_2              # 141o

        fma     $b_15,$lz_7,$dz_8,$b_5                  # 142e
        lqx     $m_by_side_2,$a_by_side,$sides_2        # 142o

        fnms    $disc_8,$lx_6,$lx_6,$radius2_3          # 143e
        stqd    $t_best_5,400($a_packet_4)              # 143o

        fnms    $lz_6,$b_12,$dz_6,$lz_6                 # 144e
        gb      $control,$control                       # 144o

        fnms    $lx_10,$b_14,$dx_4,$lx_8                # 145e
        stqd    $nearest_6,464($a_packet_4)             # 145o

        fnms    $lx_11,$b_3,$dx_5,$lx_9                 # 146e
        shufb   $nearest_7,$nearest_3,$object,$control_6 # 146o

        fnms    $ly_5,$b_3,$dy_7,$ly_5                  # 147e
        lqx     $control_9,$control_9,$a_controls       # 147o

        fnms    $lx,$b_15,$dx_7,$lx_7                   # 148e
        shlqbii $control,$control,4                     # 148o

        fnms    $disc_4,$ly_7,$ly_7,$disc_8             # 149e
        shufb   $t_best_6,$t_best_3,$t_3,$control_6     # 149o

        fnms    $ly,$b_15,$dy_2,$ly_3                   # 150e
        lqd     $nearest_8,464($a_packet_3)             # 150o

        fnms    $ly_6,$b_14,$dy_8,$ly_6                 # 151e
        stqd    $nearest_7,480($a_packet_4)             # 151o

        fnms    $disc_9,$lx_11,$lx_11,$radius2_3        # 152e
        lqd     $nearest_9,480($a_packet_3)             # 152o

        fnms    $disc_10,$lx_10,$lx_10,$radius2_3       # 153e
        shufb   $t_best_7,$t_best_4,$t_4,$control_9     # 153o

        fnms    $disc_11,$lx,$lx,$radius2_3             # 154e
        lqx     $control,$control,$a_controls           # 154o

        fnms    $disc_12,$lz_6,$lz_6,$disc_4            # 155e
        stqd    $t_best_6,416($a_packet_4)              # 155o

        fnms    $lz_9,$b_15,$dz_8,$lz_7                 # 156e
        shufb   $nearest,$nearest_4,$object,$control_9  # 156o

        fnms    $lz_2,$b_3,$dz_7,$lz_8                  # 157e
        lqd     $t_best_2,400($a_packet_3)              # 157o

        fnms    $disc_13,$ly_5,$ly_5,$disc_9            # 158e
        lqd     $t_best_3,416($a_packet_3)              # 158o

        fnms    $disc_6,$ly_6,$ly_6,$disc_10            # 159e
        stqd    $t_best_7,384($a_packet_4)              # 159o

        fnms    $lz,$b_14,$dz_9,$lz_4                   # 160e
        lqd     $t_best_4,384($a_packet_3)              # 160o

        fnms    $disc,$ly,$ly,$disc_11                  # 161e
        stqd    $nearest,448($a_packet_4)               # 161o

        fms     $out,$b_12,$b_12,$disc_12               # 162e
        lnop                                            # 162o pairing

next_ball:
        ai      $count,$count,-1                        # 0e
        lnop                                            # 0o pairing

            fnms    $disc,$lz_9,$lz_9,$disc             # 1e
            lqd     $nearest,448($a_packet_3)           # 1o

            fnms    $disc_14,$lz_2,$lz_2,$disc_13       # 2e
            shufb   $t_best,$t_best,$t,$control         # 2o

            fnms    $disc_15,$lz,$lz,$disc_6            # 3e
            shufb   $nearest_10,$nearest_5,$object,$control # 3o

            nop     $127                                # 4e pairing
            shufb   $object,$object_3,$object_3,$m_x    # 4o

            selb    $s,$whole_3,$out,$m_by_side_2       # 5e
            frsqest $y,$disc_12                         # 5o

            nop     $127                                # 6e pairing
            stqd    $t_best,432($a_packet_4)            # 6o

            fms     $out,$b_15,$b_15,$disc              # 7e
            stqd    $nearest_10,496($a_packet_4)        # 7o

            fms     $out_4,$b_3,$b_3,$disc_14           # 8e
            shlqbyi $a_packet_4,$a_packet_3,0           # 8o copy

            fms     $out_5,$b_14,$b_14,$disc_15         # 9e
        lqd     $object_3,0($a_candidate)               # 9o

            selb    $y,$y,$s,$m_sign                    # 10e
            frsqest $y_9,$disc                          # 10o

        ai      $a_candidate,$a_candidate,16            # 11e
            frsqest $y_10,$disc_14                      # 11o

            fnms    $t,$disc_12,$y,$b_12                # 12e
            lqd     $nearest_5,496($a_packet_3)         # 12o

            selb    $s,$whole_3,$out,$m_by_side_2       # 13e
            frsqest $y,$disc_15                         # 13o

            selb    $s_6,$whole_3,$out_4,$m_by_side_2   # 14e
            lqd     $t_best,432($a_packet_3)            # 14o

            selb    $y_9,$y_9,$s,$m_sign                # 15e
        rotqbyi $a_packet_3,$object_3,4                 # 15o

            selb    $y_11,$y_10,$s_6,$m_sign            # 16e
        lqd     $quad,0($object_3)                      # 16o

            fnms    $t_4,$disc,$y_9,$b_15               # 17e
        lqd     $sides,32($object_3)                    # 17o

            fnms    $t_5,$disc_14,$y_11,$b_3            # 18e
            lqx     $half,$a_half,$sides_2              # 18o

            cgti    $ahead,$t,0                         # 19e
        lqd     $ox,0($a_packet_3)                      # 19o

            cgt     $control,$t_best,$t                 # 20e
        lqd     $oy,80($a_packet_3)                     # 20o

            selb    $s,$whole_3,$out_5,$m_by_side_2     # 21e
        lqd     $ox_2,16($a_packet_3)                   # 21o

            and     $control,$control,$ahead            # 22e
        shufb   $cz,$quad,$quad,$m_z                    # 22o

            cgt     $control_4,$t_best_2,$t_4           # 23e
        shufb   $cy_2,$quad,$quad,$m_y                  # 23o

            cgti    $ahead,$t_5,0                       # 24e
        shufb   $radius2_2,$sides,$sides,$m_x           # 24o

            andc    $control,$control,$disc_12          # 25e
        shufb   $cx_4,$quad,$quad,$m_x                  # 25o

            cgt     $control_10,$t_best_3,$t_5          # 26e
            lnop                                        # 26o pairing

            cgti    $ahead_6,$t_4,0                     # 27e
        lqd     $ox_3,32($a_packet_3)                   # 27o

        fs      $ly,$cy_2,$oy                           # 28e
        lnop                                            # 28o pairing

        fm      $radius2_2,$radius2_2,$radius2_2        # 29e
        lqd     $ox_4,48($a_packet_3)                   # 29o

        fs      $lx,$cx_4,$ox_2                         # 30e
        hbrr    next_ball_back,next_ball                # 30o hint

        fs      $lx_3,$cx_4,$ox                         # 31e
        lqd     $oz_3,128($a_packet_3)                  # 31o

            and     $control_10,$control_10,$ahead      # 32e
        lqd     $oy_4,112($a_packet_3)                  # 32o

        fs      $lx_2,$cx_4,$ox_3                       # 33e
        lqd     $oy_3,64($a_packet_3)                   # 33o

            andc    $control_3,$control_10,$disc_14     # 34e
        lqd     $dx_5,240($a_packet_3)                  # 34o

        fs      $lx_12,$cx_4,$ox_4                      # 35e
        lqd     $dy_9,288($a_packet_3)                  # 35o

            and     $control_4,$control_4,$ahead_6      # 36e
        lqd     $oz,176($a_packet_3)                    # 36o

        fs      $lz,$cz,$oz_3                           # 37e
        lqd     $dx_8,224($a_packet_3)                  # 37o

            andc    $control_4,$control_4,$disc         # 38e
        lqd     $oy_2,96($a_packet_3)                   # 38o

        fs      $ly_4,$cy_2,$oy_4                       # 39e
        rotqbyi $sides,$sides,12                        # 39o

        fs      $ly_3,$cy_2,$oy_3                       # 40e
        lqd     $dy_5,304($a_packet_3)                  # 40o

            selb    $y,$y,$s,$m_sign                    # 41e
        lqd     $oz_2,160($a_packet_3)                  # 41o

        fm      $b_16,$lx_12,$dx_5                      # 42e
            rotqbii $control_4,$control_4,1             # 42o

            fnms    $t_6,$disc_15,$y,$b_14              # 43e
        lqd     $dx_2,208($a_packet_3)                  # 43o

        fm      $b_3,$lx_2,$dx_8                        # 44e
        lqd     $dx_4,192($a_packet_3)                  # 44o

        fs      $ly_8,$cy_2,$oy_2                       # 45e
        lqd     $dy_4,256($a_packet_3)                  # 45o

        rotmi   $sides_2,$sides,-26                     # 46e
            gb      $control_4,$control_4               # 46o

        fs      $lz_10,$cz,$oz                          # 47e
        lqd     $oz,144($a_packet_3)                    # 47o

        fs      $lz_3,$cz,$oz_2                         # 48e
        lqd     $dz_3,352($a_packet_3)                  # 48o

        fma     $b_16,$ly_4,$dy_5,$b_16                 # 49e
        lqd     $dz_5,368($a_packet_3)                  # 49o

            cgt     $control_11,$t_best_4,$t_6          # 50e
            rotqbii $control_3,$control_3,1             # 50o

            cgti    $ahead_7,$t_6,0                     # 51e
        lqd     $dy_2,272($a_packet_3)                  # 51o

        fm      $b_2,$lx,$dx_2                          # 52e
            shlqbii $control_4,$control_4,4             # 52o

        fm      $b_4,$lx_3,$dx_4                        # 53e
        lqd     $dz_4,320($a_packet_3)                  # 53o

        fma     $b_3,$ly_8,$dy_9,$b_3                   # 54e
            gb      $control_3,$control_3               # 54o

        fma     $b_12,$lz_10,$dz_5,$b_16                # 55e
        lqd     $dz_2,336($a_packet_3)                  # 55o

        fs      $lz_4,$cz,$oz                           # 56e
            lqx     $control_4,$control_4,$a_controls   # 56o

            and     $control_12,$control_11,$ahead_7    # 57e
            rotqbii $control,$control,1                 # 57o

        fma     $b_5,$ly,$dy_2,$b_2                     # 58e
            shlqbii $control_3,$control_3,4             # 58o

            andc    $control_13,$control_12,$disc_15    # 59e
        lqx     $whole_3,$a_whole,$sides_2              # 59o

        fma     $b_7,$ly_3,$dy_4,$b_4                   # 60e
        lqx     $m_by_side_2,$a_by_side,$sides_2        # 60o

        fma     $b_3,$lz_3,$dz_3,$b_3                   # 61e
            rotqbii $control_13,$control_13,1           # 61o

        fnms    $lx_12,$b_12,$dx_5,$lx_12               # 62e
            lqx     $control_3,$control_3,$a_controls   # 62o

        fnms    $ly_9,$b_12,$dy_5,$ly_4                 # 63e
            shufb   $t_best_8,$t_best_2,$t_4,$control_4 # 63o

        fma     $b_15,$lz_4,$dz_2,$b_5                  # 64e
            gb      $control,$control                   # 64o

        fnms    $lz_10,$b_12,$dz_5,$lz_10               # 65e
            gb      $control_13,$control_13             # 65o

        fma     $b_14,$lz,$dz_4,$b_7                    # 66e
            shufb   $nearest_6,$nearest_8,$object,$control_4 # 66o

        fnms    $lx_13,$b_3,$dx_8,$lx_2                 # 67e
            stqd    $t_best_8,400($a_packet_4)          # 67o

        fnms    $disc,$lx_12,$lx_12,$radius2_2          # 68e
            shlqbii $control,$control,4                 # 68o

        fnms    $lz_2,$b_3,$dz_3,$lz_3                  # 69e
            shlqbii $control_13,$control_13,4           # 69o

        fnms    $lx,$b_15,$dx_2,$lx                     # 70e
            shufb   $nearest_11,$nearest_9,$object,$control_3 # 70o

        fnms    $ly_8,$b_3,$dy_9,$ly_8                  # 71e
            stqd    $nearest_6,464($a_packet_4)         # 71o

        fnms    $lx_3,$b_14,$dx_4,$lx_3                 # 72e
        lqd     $nearest_8,464($a_packet_3)             # 72o

        fnms    $ly,$b_15,$dy_2,$ly                     # 73e
            lqx     $control_13,$control_13,$a_controls # 73o

        fnms    $disc,$ly_9,$ly_9,$disc                 # 74e
            shufb   $t_best_9,$t_best_3,$t_5,$control_3 # 74o

        fnms    $ly_10,$b_14,$dy_4,$ly_3                # 75e
            stqd    $nearest_11,480($a_packet_4)        # 75o

        fnms    $disc_13,$lx,$lx,$radius2_2             # 76e
            lqx     $control,$control,$a_controls       # 76o

        fnms    $disc_9,$lx_13,$lx_13,$radius2_2        # 77e
        lqd     $nearest_9,480($a_packet_3)             # 77o

        fnms    $disc_4,$lx_3,$lx_3,$radius2_2          # 78e
            stqd    $t_best_9,416($a_packet_4)          # 78o

        fnms    $lz,$b_14,$dz_4,$lz                     # 79e
            shufb   $t_best_9,$t_best_4,$t_6,$control_13 # 79o

        fnms    $disc_12,$lz_10,$lz_10,$disc            # 80e
            shufb   $nearest,$nearest,$object,$control_13 # 80o

        fnms    $lz_9,$b_15,$dz_2,$lz_4                 # 81e
        lqd     $t_best_2,400($a_packet_3)              # 81o

        fnms    $disc,$ly,$ly,$disc_13                  # 82e
        lqd     $t_best_3,416($a_packet_3)              # 82o

        fnms    $disc_13,$ly_8,$ly_8,$disc_9            # 83e
            stqd    $t_best_9,384($a_packet_4)          # 83o

        fnms    $disc_6,$ly_10,$ly_10,$disc_4           # 84e
        lqd     $t_best_4,384($a_packet_3)              # 84o

            nop     $127                                # 85e pairing
            stqd    $nearest,448($a_packet_4)           # 85o

        fms     $out,$b_12,$b_12,$disc_12               # 86e
next_ball_back:
        brnz    $count,next_ball                        # 86o

next_ball_drain:
        fnms    $disc,$lz_9,$lz_9,$disc                 # 0e
        shufb   $t_best,$t_best,$t,$control             # 0o

        fnms    $disc_14,$lz_2,$lz_2,$disc_13           # 1e
        frsqest $y,$disc_12                             # 1o

        fnms    $disc_15,$lz,$lz,$disc_6                # 2e
        shufb   $nearest_10,$nearest_5,$object,$control # 2o

        selb    $s,$whole_3,$out,$m_by_side_2           # 3e
        lqd     $nearest,448($a_packet_3)               # 3o

        nop     $127                                    # 4e pairing
        stqd    $t_best,432($a_packet_4)                # 4o

        selb    $y,$y,$s,$m_sign                        # 5e
        shufb   $object,$object_3,$object_3,$m_x        # 5o

        fms     $out,$b_15,$b_15,$disc                  # 6e
        frsqest $y_9,$disc                              # 6o

        fms     $out_6,$b_3,$b_3,$disc_14               # 7e
        frsqest $y_10,$disc_14                          # 7o

        fms     $out_5,$b_14,$b_14,$disc_15             # 8e
        frsqest $y_12,$disc_15                          # 8o

        fnms    $t,$disc_12,$y,$b_12                    # 9e
        stqd    $nearest_10,496($a_packet_4)            # 9o

        lqd     $t_best,432($a_packet_3)                # 10o
        shlqbyi $a_packet_4,$a_packet_3,0               # 11o copy

        selb    $s,$whole_3,$out,$m_by_side_2           # 12e
        lqd     $nearest_5,496($a_packet_3)             # 12o

        selb    $s_6,$whole_3,$out_6,$m_by_side_2       # 13e
        lqx     $half,$a_half,$sides_2                  # 13o

        selb    $y_9,$y_9,$s,$m_sign                    # 14e
        hbr     isect_ball_pairs_estimate_r16_return,$lr # 14o hint

        selb    $y_11,$y_10,$s_6,$m_sign                # 15e
        fnms    $t_4,$disc,$y_9,$b_15                   # 16e

        fnms    $t_5,$disc_14,$y_11,$b_3                # 17e
        selb    $s,$whole_3,$out_5,$m_by_side_2         # 18e

        cgti    $ahead,$t,0                             # 19e
        selb    $y,$y_12,$s,$m_sign                     # 20e

        cgt     $control,$t_best,$t                     # 21e
        cgt     $control_4,$t_best_2,$t_4               # 22e

        cgti    $ahead_6,$t_4,0                         # 23e
        cgti    $ahead_8,$t_5,0                         # 24e

        and     $control_4,$control_4,$ahead_6          # 25e
        cgt     $control_14,$t_best_3,$t_5              # 26e

        andc    $control_4,$control_4,$disc             # 27e
        and     $control_15,$control_14,$ahead_8        # 28e

        fnms    $t_6,$disc_15,$y,$b_14                  # 29e
        rotqbii $control_4,$control_4,1                 # 29o

        andc    $control_3,$control_15,$disc_14         # 30e
        and     $control,$control,$ahead                # 31e

        nop     $127                                    # 32e pairing
        rotqbii $control_3,$control_3,1                 # 32o

        andc    $control,$control,$disc_12              # 33e
        gb      $control_4,$control_4                   # 33o

        cgt     $control_11,$t_best_4,$t_6              # 35e
        rotqbii $control,$control,1                     # 35o

        cgti    $ahead_7,$t_6,0                         # 36e
        gb      $control_3,$control_3                   # 36o

        shlqbii $control_4,$control_4,4                 # 37o
        and     $control_12,$control_11,$ahead_7        # 38e

        nop     $127                                    # 39e pairing
        gb      $control,$control                       # 39o

        andc    $control_13,$control_12,$disc_15        # 40e
        shlqbii $control_3,$control_3,4                 # 40o

        lqx     $control_4,$control_4,$a_controls       # 41o
        rotqbii $control_13,$control_13,1               # 42o

        shlqbii $control,$control,4                     # 43o
        lqx     $control_3,$control_3,$a_controls       # 44o

        gb      $control_13,$control_13                 # 46o
        shufb   $t_best_8,$t_best_2,$t_4,$control_4     # 47o

        shufb   $nearest_6,$nearest_8,$object,$control_4 # 48o
        shlqbii $control_13,$control_13,4               # 50o

        shufb   $nearest_11,$nearest_9,$object,$control_3 # 51o
        stqd    $t_best_8,400($a_packet_4)              # 52o

        stqd    $nearest_6,464($a_packet_4)             # 53o
        lqx     $control_13,$control_13,$a_controls     # 54o

        stqd    $nearest_11,480($a_packet_4)            # 55o
        lqx     $control,$control,$a_controls           # 56o

        shufb   $t_best_9,$t_best_3,$t_5,$control_3     # 57o
        shufb   $t_best_10,$t_best_4,$t_6,$control_13   # 60o

        shufb   $nearest,$nearest,$object,$control_13   # 61o
        shufb   $t_best,$t_best,$t,$control             # 62o

        stqd    $t_best_9,416($a_packet_4)              # 63o
        shufb   $nearest_10,$nearest_5,$object,$control # 64o

        stqd    $t_best_10,384($a_packet_4)             # 65o
        stqd    $nearest,448($a_packet_4)               # 66o

        stqd    $t_best,432($a_packet_4)                # 67o
        stqd    $nearest_10,496($a_packet_4)            # 68o

        nop     $127                                    # 69e pairing
isect_ball_pairs_estimate_r16_return:
        bi      $lr                                     # 69o

next_ball_short:
        ai      $count,$count,-1                        # 0e
        lqd     $object,0($a_candidate)                 # 0o

        ai      $a_candidate,$a_candidate,16            # 1e
        rotqbyi $a_packet,$object,4                     # 6o

        lqd     $quad,0($object)                        # 7o
        lqd     $sides,32($object)                      # 8o

        shufb   $object,$object,$object,$m_x            # 9o
        lqd     $ox,0($a_packet)                        # 10o

        lqd     $ox_8,16($a_packet)                     # 11o
        lqd     $dx,208($a_packet)                      # 12o

        shufb   $cx,$quad,$quad,$m_x                    # 13o
        lqd     $dx_9,192($a_packet)                    # 14o

        lqd     $dy,272($a_packet)                      # 15o
        lqd     $ox_9,48($a_packet)                     # 16o

        fs      $lx,$cx,$ox                             # 17e
        shufb   $cy,$quad,$quad,$m_y                    # 17o

        fs      $lx_14,$cx,$ox_8                        # 18e
        lqd     $oz,144($a_packet)                      # 18o

        lqd     $oy,80($a_packet)                       # 19o
        lqd     $dx_3,240($a_packet)                    # 20o

        nop     $127                                    # 21e pairing
        lqd     $oy_8,112($a_packet)                    # 21o

        fs      $lx_4,$cx,$ox_9                         # 22e
        lqd     $oy_9,96($a_packet)                     # 22o

        fm      $b,$lx,$dx_9                            # 23e
        lqd     $oy_10,64($a_packet)                    # 23o

        fm      $b_8,$lx_14,$dx                         # 24e
        shufb   $radius2_4,$sides,$sides,$m_x           # 24o

        fs      $ly,$cy,$oy                             # 25e
        lqd     $dy_10,256($a_packet)                   # 25o

        nop     $127                                    # 26e pairing
        lqd     $dz,336($a_packet)                      # 26o

        fs      $ly_7,$cy,$oy_8                         # 27e
        lqd     $oz_8,176($a_packet)                    # 27o

        fm      $b_17,$lx_4,$dx_3                       # 28e
        lqd     $ox_4,32($a_packet)                     # 28o

        fs      $ly_11,$cy,$oy_10                       # 29e
        shufb   $cz_3,$quad,$quad,$m_z                  # 29o

        fs      $ly_12,$cy,$oy_9                        # 30e
        lqd     $oz_9,128($a_packet)                    # 30o

        fma     $b_8,$ly,$dy,$b_8                       # 31e
        lqd     $dz_10,320($a_packet)                   # 31o

        fm      $radius2_4,$radius2_4,$radius2_4        # 32e
        lqd     $oz_10,160($a_packet)                   # 32o

        fs      $lz,$cz_3,$oz                           # 33e
        lqd     $dx_6,224($a_packet)                    # 33o

        fs      $lx_15,$cx,$ox_4                        # 34e
        lqd     $dy_9,288($a_packet)                    # 34o

        fma     $b,$ly_11,$dy_10,$b                     # 35e
        lqd     $dz_11,352($a_packet)                   # 35o

        fs      $lz_11,$cz_3,$oz_9                      # 36e
        lqd     $dy_11,304($a_packet)                   # 36o

        fs      $lz_12,$cz_3,$oz_8                      # 37e
        rotqbyi $sides,$sides,12                        # 37o

        fs      $lz_6,$cz_3,$oz_10                      # 38e
        lqd     $dz_12,368($a_packet)                   # 38o

        fma     $b_8,$lz,$dz,$b_8                       # 39e
        lqd     $t_best_11,400($a_packet)               # 39o

        fm      $b_16,$lx_15,$dx_6                      # 40e
        lqd     $t_best_12,416($a_packet)               # 40o

        rotmi   $sides,$sides,-26                       # 41e
        lqd     $t_best_13,384($a_packet)               # 41o

        fma     $b,$lz_11,$dz_10,$b                     # 42e
        lqd     $nearest_12,448($a_packet)              # 42o

        fma     $b_17,$ly_7,$dy_11,$b_17                # 43e
        lqd     $t_best_14,432($a_packet)               # 43o

        nop     $127                                    # 44e pairing
        lqd     $nearest_13,464($a_packet)              # 44o

        fnms    $lx_14,$b_8,$dx,$lx_14                  # 45e
        lqx     $whole_4,$a_whole,$sides                # 45o

        fma     $b_16,$ly_12,$dy_9,$b_16                # 46e
        lqx     $m_by_side_3,$a_by_side,$sides          # 46o

        fnms    $ly,$b_8,$dy,$ly                        # 47e
        lqd     $nearest_14,496($a_packet)              # 47o

        fnms    $lx,$b,$dx_9,$lx                        # 48e
        lqx     $half_3,$a_half,$sides                  # 48o

        fnms    $ly_13,$b,$dy_10,$ly_11                 # 49e
        lqd     $nearest_15,480($a_packet)              # 49o

        fma     $b_18,$lz_12,$dz_12,$b_17               # 50e
        fnms    $disc_14,$lx_14,$lx_14,$radius2_4       # 51e

        fma     $b_19,$lz_6,$dz_11,$b_16                # 52e
        fnms    $lz_11,$b,$dz_10,$lz_11                 # 53e

        fnms    $disc_8,$lx,$lx,$radius2_4              # 54e
        fnms    $lz,$b_8,$dz,$lz                        # 55e

        fnms    $lx,$b_18,$dx_3,$lx_4                   # 56e
        fnms    $disc_14,$ly,$ly,$disc_14               # 57e

        fnms    $lx_4,$b_19,$dx_6,$lx_15                # 58e
        fnms    $lz_5,$b_19,$dz_11,$lz_6                # 59e

        fnms    $disc,$ly_13,$ly_13,$disc_8             # 60e
        fnms    $ly,$b_18,$dy_11,$ly_7                  # 61e

        fnms    $ly_13,$b_19,$dy_9,$ly_12               # 62e
        fnms    $disc_14,$lz,$lz,$disc_14               # 63e

        fnms    $disc_6,$lx_4,$lx_4,$radius2_4          # 64e
        fnms    $disc_4,$lx,$lx,$radius2_4              # 65e

        fnms    $disc,$lz_11,$lz_11,$disc               # 66e
        fnms    $lz,$b_18,$dz_12,$lz_12                 # 67e

        fms     $out,$b_8,$b_8,$disc_14                 # 69e
        frsqest $y_13,$disc_14                          # 69o

        fnms    $disc_15,$ly_13,$ly_13,$disc_6          # 70e
        fnms    $disc_6,$ly,$ly,$disc_4                 # 71e

        fms     $out_5,$b,$b,$disc                      # 72e
        frsqest $y_10,$disc                             # 72o

        selb    $s,$whole_4,$out,$m_by_side_3           # 75e
        fnms    $disc_15,$lz_5,$lz_5,$disc_15           # 76e

        selb    $y_14,$y_13,$s,$m_sign                  # 77e
        selb    $s,$whole_4,$out_5,$m_by_side_3         # 78e

        fnms    $t_7,$disc_14,$y_14,$b_8                # 79e
        selb    $y_15,$y_10,$s,$m_sign                  # 80e

        fnms    $disc_6,$lz,$lz,$disc_6                 # 81e
        lnop                                            # 81o pairing

        fnms    $t_8,$disc,$y_15,$b                     # 82e
        frsqest $y_13,$disc_15                          # 82o

        fms     $out,$b_19,$b_19,$disc_15               # 83e
        cgt     $control_16,$t_best_11,$t_7             # 85e

        cgti    $ahead_9,$t_7,0                         # 86e
        lnop                                            # 86o pairing

        fms     $out_7,$b_18,$b_18,$disc_6              # 87e
        frsqest $y_16,$disc_6                           # 87o

        cgti    $ahead_10,$t_8,0                        # 88e
        and     $control_16,$control_16,$ahead_9        # 89e

        selb    $s,$whole_4,$out,$m_by_side_3           # 90e
        andc    $control_3,$control_16,$disc_14         # 91e

        selb    $y_13,$y_13,$s,$m_sign                  # 92e
        lnop                                            # 92o pairing

        selb    $s,$whole_4,$out_7,$m_by_side_3         # 93e
        rotqbii $control_3,$control_3,1                 # 93o

        fnms    $t_9,$disc_15,$y_13,$b_19               # 94e
        cgt     $control_16,$t_best_13,$t_8             # 95e

        selb    $y_17,$y_16,$s,$m_sign                  # 96e
        lnop                                            # 96o pairing

        and     $control_16,$control_16,$ahead_10       # 97e
        gb      $control_3,$control_3                   # 97o

        fnms    $t_10,$disc_6,$y_17,$b_18               # 98e
        andc    $control_16,$control_16,$disc           # 99e

        cgti    $ahead_11,$t_9,0                        # 100e
        lnop                                            # 100o pairing

        cgt     $control_4,$t_best_12,$t_9              # 101e
        rotqbii $control_16,$control_16,1               # 101o

        shlqbii $control_3,$control_3,4                 # 102o
        and     $control_17,$control_4,$ahead_11        # 103e

        cgt     $control_4,$t_best_14,$t_10             # 104e
        lnop                                            # 104o pairing

        andc    $control_13,$control_17,$disc_15        # 105e
        gb      $control_16,$control_16                 # 105o

        cgti    $ahead_11,$t_10,0                       # 106e
        lqx     $control_3,$control_3,$a_controls       # 106o

        rotqbii $control_13,$control_13,1               # 107o
        and     $control_17,$control_4,$ahead_11        # 108e

        shlqbii $control_16,$control_16,4               # 109o
        andc    $control_9,$control_17,$disc_6          # 110e

        gb      $control_13,$control_13                 # 111o
        rotqbii $control_9,$control_9,1                 # 112o

        lqx     $control_16,$control_16,$a_controls     # 113o
        shufb   $nearest,$nearest_13,$object,$control_3 # 114o

        shlqbii $control_13,$control_13,4               # 115o
        shufb   $t_best,$t_best_11,$t_7,$control_3      # 116o

        gb      $control_3,$control_9                   # 117o
        stqd    $nearest,464($a_packet)                 # 118o

        shufb   $t_best_15,$t_best_13,$t_8,$control_16  # 119o
        lqx     $control_13,$control_13,$a_controls     # 120o

        shlqbii $control_3,$control_3,4                 # 121o
        shufb   $nearest,$nearest_12,$object,$control_16 # 122o

        stqd    $t_best_15,384($a_packet)               # 123o
        stqd    $t_best,400($a_packet)                  # 124o

        lqx     $control,$control_3,$a_controls         # 125o
        stqd    $nearest,448($a_packet)                 # 126o

        shufb   $t_best,$t_best_12,$t_9,$control_13     # 127o
        hbrr    next_ball_short_back,next_ball_short    # 128o hint

        shufb   $nearest,$nearest_15,$object,$control_13 # 129o
        shufb   $t_best_9,$t_best_14,$t_10,$control     # 131o

        stqd    $t_best,416($a_packet)                  # 132o
        shufb   $nearest_16,$nearest_14,$object,$control # 133o

        stqd    $nearest,480($a_packet)                 # 134o
        stqd    $t_best_9,432($a_packet)                # 135o

        stqd    $nearest_16,496($a_packet)              # 137o
next_ball_short_back:
        brnz    $count,next_ball_short                  # 138o

        nop     $127                                    # 139e pairing
        bi      $lr                                     # 139o
endfunction isect_ball_pairs_estimate_r16
