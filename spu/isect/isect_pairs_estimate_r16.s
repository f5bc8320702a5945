# isect_pairs_estimate_r16   nearest entry of packets' eye rays into spheres, by a root's estimate
#   C       void isect_pairs_estimate_r16(const struct pair *, int count);
#   In      $3 pairs, $4 count (0 is none); pointers 16-aligned
#   Out     the pairs' packets: t, object, where an entry is nearer than what was there
#   Uses    $2-$62, $79   Saves  -   Stack  0   Calls  -
#   Domain  |d| = 1 within 4 ulp; radius > 0; centre and radius below 2^62
#   Error   1000000 ulp of t, eye 1.5 to 30 radii from the centre, ray within 0.995 r of it
#   Twin    oracle/src/twin/sphere/perpendicular.rs
#
# The steps are those of sphere_tmpl.inc. An opaque sphere has no inside: only the entry counts, and
# behind the eye it is none.
# Scheduled by spu schedule from isect_pairs_estimate_r16.s

        .include "work_unit.inc"
        .include "macros.inc"
        .include "sphere_tmpl.inc"
        .include "sphere_estimate.inc"

        .set    a_pair,3
        .set    count,4
        # constants
        .set    m_x,10
        .set    m_y,11
        .set    m_z,12
        .set    m_radius2,13
        .set    a_merges,14
        # the pair
        .set    object,15
        .set    a_packet,16
        .set    quad,17
        .set    cx,18
        .set    cy,19
        .set    cz,20
        .set    fx,18                                   # c
        .set    fy,19
        .set    fz,20
        .set    radius2,21
        # a row
        .set    dx,22
        .set    dy,23
        .set    dz,24
        .set    t_best,25
        .set    nearest,26
        # temporaries
        .set    b,27
        .set    lx,28
        .set    ly,29
        .set    lz,30
        .set    disc,31
        .set    y,32
        .set    t,33
        .set    hit,34
        .set    merge,35

        merges_table

function isect_pairs_estimate_r16
        .set    count_2,79
        .set    a_pair_2,2
        .set    object_2,59
        .set    object_3,5
        .set    a_packet_2,6
        .set    quad_2,7
        .set    dx_2,8
        .set    dy_2,2
        .set    fx_2,9
        .set    fy_2,18
        .set    dy_3,21
        .set    dz_2,25
        .set    b_2,15
        .set    dx_3,26
        .set    b_3,33
        .set    fz_2,27
        .set    dz_3,28
        .set    dx_4,29
        .set    dy_4,31
        .set    dy_5,34
        .set    dz_4,35
        .set    radius2_2,17
        .set    b_4,23
        .set    dz_5,40
        .set    b_5,24
        .set    dx_5,41
        .set    fx_3,20
        .set    dx_6,46
        .set    b_6,42
        .set    dy_6,30
        .set    b_7,45
        .set    b_8,32
        .set    t_best_2,57
        .set    t_best_3,56
        .set    b_9,47
        .set    dx_7,15
        .set    b_10,54
        .set    dy_7,36
        .set    lx_2,22
        .set    dz_6,37
        .set    lx_3,8
        .set    fz_3,24
        .set    ly_2,39
        .set    dx_8,23
        .set    b_11,55
        .set    nearest_2,60
        .set    ly_3,21
        .set    dz_7,38
        .set    b_12,61
        .set    dy_8,43
        .set    disc_2,22
        .set    a_packet_3,52
        .set    disc_3,8
        .set    a_packet_4,53
        .set    lz_2,33
        .set    object_4,62
        .set    lx_4,26
        .set    a_packet_5,2
        .set    lz_3,28
        .set    nearest_3,6
        .set    lx_5,9
        .set    radius2_3,32
        .set    disc_4,7
        .set    dy_9,39
        .set    ly_4,8
        .set    t_best_4,44
        .set    disc_5,21
        .set    nearest_4,48
        .set    t_best_5,50
        .set    disc_6,9
        .set    nearest_5,51
        .set    disc_7,17
        .set    dz_8,33
        .set    a_packet_6,49
        .set    lz_4,18
        .set    lz_5,21
        .set    object_5,58
        .set    disc_8,28
        .set    b_13,9
        .set    y_2,5
        .set    b_14,8
        .set    y_3,22
        .set    b_15,26
        .set    t_2,18
        .set    t_3,5
        .set    b_16,40
        .set    y_4,9
        .set    hit_2,28
        .set    hit_3,35
        .set    y_5,17
        .set    hit_4,29
        .set    hit_5,22
        .set    nearest_6,8
        .set    t_4,47
        .set    t_5,41
        .set    t_best_6,5
        .set    nearest_7,54
        .set    t_best_7,9
        .set    disc_9,18
        .set    hit_6,5
        .set    object_6,46
        .set    hit_7,6
        .set    ly_5,5
        .set    ly_6,7
        .set    lz_6,9
        .set    disc_10,5
        .set    b_17,17
        .set    y_6,6
        .set    y_7,18
        .set    t_6,6
        .set    t_best_8,29
        .set    merge_2,34
        .set    y_8,41
        .set    nearest_8,9
        .set    t_best_9,31
        .set    y_9,33
        .set    hit_8,7
        .set    t_best_10,6
        .set    object_7,3
        .set    hit_9,4
        .set    t_7,4
        .set    nearest_9,11
        .set    t_best_11,12
        .set    a_packet_7,8
        .set    disc_11,10
        .set    nearest_10,10
        .set    nearest_11,3
        .set    t_best_12,4
        .set    t_best_13,3
        .set    nearest_12,2
        .set    dx_9,2
        .set    dy_10,5
        .set    dz_9,6
        .set    b_18,7
        .set    dx_10,9
        .set    dy_11,26
        .set    b_19,28
        .set    dz_10,29
        .set    b_20,30
        .set    t_best_14,32
        .set    t_best_15,33
        .set    nearest_13,34
        .set    t_best_16,35
        .set    nearest_14,36
        .set    nearest_15,37
        .set    nearest_16,38
        .set    lx_6,2
        .set    ly_7,23
        .set    lz_7,24
        .set    disc_12,2
        .set    lz_8,6
        .set    ly_8,18
        .set    lz_9,19
        .set    disc_13,6
        .set    lz_10,8
        .set    y_10,20
        .set    t_8,17
        .set    t_9,7
        .set    hit_10,9
        .set    hit_11,19
        .set    hit_12,2
        .set    t_10,9
        .set    hit_13,8
        .set    merge_3,2
        .set    merge_4,5
        .set    t_best_17,7
        .set    nearest_17,5
        .set    t_best_18,2
        nop     $127                                    # 0e pairing
        biz     $count,$lr                              # 0o

        ilhu    $m_x,1                                  # 1e
        ilhu    $m_y,0x405                              # 2e

        ilhu    $m_z,0x809                              # 3e
        ilhu    $m_radius2,0xc0d                        # 4e

        clgti   $count_2,$count,3                       # 5e at least as many passes as overlap
        iohl    $m_x,515                                # 6e

        iohl    $m_y,0x607                              # 7e
        iohl    $m_z,0xa0b                              # 8e

        iohl    $m_radius2,0xe0f                        # 9e
        lnop                                            # 9o pairing

        ila     $a_merges,merges                        # 10e
        brz     $count_2,next_pair_short                # 10o too few passes

        ai      $a_pair_2,$a_pair,16                    # 11e
        lqd     $object_2,0($a_pair)                    # 11o

        ai      $count,$count,-1                        # 12e
        lnop                                            # 12o pairing

        ai      $a_pair,$a_pair_2,16                    # 13e
        lqd     $object_3,0($a_pair_2)                  # 13o

        ai      $count,$count,-1                        # 14e
        ai      $count,$count,-1                        # 16e

        rotqbyi $a_packet_2,$object_2,4                 # 17o
        lqd     $quad,0($object_2)                      # 18o

        rotqbyi $a_packet,$object_3,4                   # 19o
        lqd     $quad_2,0($object_3)                    # 20o

        lqd     $dx,16($a_packet_2)                     # 21o
        lqd     $dx_2,0($a_packet_2)                    # 22o

        lqd     $dy_2,80($a_packet_2)                   # 23o
        shufb   $fx_2,$quad,$quad,$m_x                  # 24o

        shufb   $fy_2,$quad,$quad,$m_y                  # 25o
        lqd     $dy_3,64($a_packet_2)                   # 26o

        nop     $127                                    # 27e pairing
        lqd     $dz_2,144($a_packet_2)                  # 27o

        fm      $b_2,$fx_2,$dx                          # 28e
        lqd     $dx_3,32($a_packet_2)                   # 28o

        fm      $b_3,$fx_2,$dx_2                        # 29e
        shufb   $fz_2,$quad,$quad,$m_z                  # 29o

        lqd     $dz_3,128($a_packet_2)                  # 30o
        lqd     $dx_4,48($a_packet_2)                   # 31o

        lqd     $dy_4,96($a_packet_2)                   # 32o
        lqd     $dy_5,112($a_packet_2)                  # 33o

        fma     $b_2,$fy_2,$dy_2,$b_2                   # 34e
        lqd     $dz_4,160($a_packet_2)                  # 34o

        fma     $b_3,$fy_2,$dy_3,$b_3                   # 35e
        shufb   $radius2_2,$quad,$quad,$m_radius2       # 35o

        fm      $b_4,$fx_2,$dx_3                        # 36e
        lqd     $dz_5,176($a_packet_2)                  # 36o

        fm      $b_5,$fx_2,$dx_4                        # 37e
        lqd     $dx_5,16($a_packet)                     # 37o

        shufb   $fx_3,$quad_2,$quad_2,$m_x              # 38o
        lqd     $dx_6,0($a_packet)                      # 39o

        fma     $b_6,$fz_2,$dz_2,$b_2                   # 40e
        lqd     $dy_6,80($a_packet)                     # 40o

        fma     $b_7,$fz_2,$dz_3,$b_3                   # 41e
        shufb   $fy,$quad_2,$quad_2,$m_y                # 41o

        fma     $b_8,$fy_2,$dy_4,$b_4                   # 42e
        lqd     $t_best_2,208($a_packet_2)              # 42o

        fma     $b_3,$fy_2,$dy_5,$b_5                   # 43e
        lqd     $t_best_3,192($a_packet_2)              # 43o

        fm      $b_9,$fx_3,$dx_5                        # 44e
        lqd     $dx_7,32($a_packet)                     # 44o

        fm      $b_10,$fx_3,$dx_6                       # 45e
        lqd     $dy_7,64($a_packet)                     # 45o

        fnms    $lx_2,$b_6,$dx,$fx_2                    # 46e
        lqd     $dz_6,144($a_packet)                    # 46o

        fnms    $lx_3,$b_7,$dx_2,$fx_2                  # 47e
        shufb   $fz_3,$quad_2,$quad_2,$m_z              # 47o

        fnms    $ly_2,$b_6,$dy_2,$fy_2                  # 48e
        lqd     $dx_8,48($a_packet)                     # 48o

        fma     $b_11,$fz_2,$dz_4,$b_8                  # 49e
        lqd     $nearest_2,272($a_packet_2)             # 49o

        fnms    $ly_3,$b_7,$dy_3,$fy_2                  # 50e
        lqd     $dz_7,128($a_packet)                    # 50o

        fma     $b_12,$fz_2,$dz_5,$b_3                  # 51e
        lqd     $dy_8,96($a_packet)                     # 51o

        fnms    $disc_2,$lx_2,$lx_2,$radius2_2          # 52e
        shlqbyi $a_packet_3,$a_packet_2,0               # 52o copy

        fnms    $disc_3,$lx_3,$lx_3,$radius2_2          # 53e
        shlqbyi $a_packet_4,$a_packet_2,0               # 53o copy

        fnms    $lz_2,$b_6,$dz_2,$fz_2                  # 54e
        shufb   $object_4,$object_2,$object_2,$m_x      # 54o

        fnms    $lx_4,$b_11,$dx_3,$fx_2                 # 55e
        shlqbyi $a_packet_5,$a_packet_2,0               # 55o copy

        fnms    $lz_3,$b_7,$dz_3,$fz_2                  # 56e
        lqd     $nearest_3,256($a_packet_2)             # 56o

        fnms    $lx_5,$b_12,$dx_4,$fx_2                 # 57e
        lqd     $dz_2,160($a_packet)                    # 57o

        fnms    $disc_2,$ly_2,$ly_2,$disc_2             # 58e
        shufb   $radius2_3,$quad_2,$quad_2,$m_radius2   # 58o

        fnms    $disc_4,$ly_3,$ly_3,$disc_3             # 59e
        lqd     $dy_9,112($a_packet)                    # 59o

        fnms    $ly_4,$b_11,$dy_4,$fy_2                 # 60e
        lqd     $t_best_4,240($a_packet_3)              # 60o

        fnms    $disc_5,$lx_4,$lx_4,$radius2_2          # 61e
        lqd     $nearest_4,304($a_packet_3)             # 61o

        fnms    $ly,$b_12,$dy_5,$fy_2                   # 62e
        lqd     $t_best_5,224($a_packet_3)              # 62o

        fnms    $disc_6,$lx_5,$lx_5,$radius2_2          # 63e
        lqd     $nearest_5,288($a_packet_3)             # 63o

        fnms    $disc_7,$lz_2,$lz_2,$disc_2             # 64e
        lqd     $dz_8,176($a_packet)                    # 64o

        fnms    $disc,$lz_3,$lz_3,$disc_4               # 65e
        shlqbyi $a_packet_6,$a_packet_4,0               # 65o copy

        fnms    $lz_4,$b_11,$dz_4,$fz_2                 # 66e
        shlqbyi $a_packet_3,$a_packet,0                 # 66o copy

        fnms    $disc_4,$ly_4,$ly_4,$disc_5             # 67e
        shlqbyi $a_packet_4,$a_packet,0                 # 67o copy

        fnms    $lz_5,$b_12,$dz_5,$fz_2                 # 68e
        shufb   $object_5,$object_3,$object_3,$m_x      # 68o

        fnms    $disc_8,$ly,$ly,$disc_6                 # 69e
        lnop                                            # 69o pairing

        fma     $b_13,$fy,$dy_6,$b_9                    # 70e
        frsqest $y_2,$disc_7                            # 70o

        fm      $b_14,$fx_3,$dx_7                       # 71e
        frsqest $y_3,$disc                              # 71o

        fma     $b_15,$fy,$dy_7,$b_10                   # 72e
        fnms    $disc_4,$lz_4,$lz_4,$disc_4             # 73e

        fnms    $t_2,$disc_7,$y_2,$b_6                  # 74e
        fnms    $t_3,$disc,$y_3,$b_7                    # 75e

        fnms    $disc_5,$lz_5,$lz_5,$disc_8             # 76e
        fma     $b_6,$fz_3,$dz_6,$b_13                  # 77e

        fm      $b_16,$fx_3,$dx_8                       # 78e
        lnop                                            # 78o pairing

        fma     $b_7,$fz_3,$dz_7,$b_15                  # 79e
        frsqest $y_4,$disc_4                            # 79o

        clgt    $hit_2,$t_best_2,$t_2                   # 80e
        hbrr    next_pair_back,next_pair                # 80o hint

        clgt    $hit_3,$t_best_3,$t_3                   # 81e
        lnop                                            # 81o pairing

        andc    $hit,$hit_2,$disc_7                     # 82e
        frsqest $y_5,$disc_5                            # 82o

        andc    $hit_4,$hit_3,$disc                     # 83e
        rotmai  $hit,$hit,-31                           # 84e

        rotmai  $hit_5,$hit_4,-31                       # 85e
        fma     $b_15,$fy,$dy_8,$b_14                   # 86e

        fnms    $lx,$b_6,$dx_5,$fx_3                    # 87e
        selb    $nearest_6,$nearest_2,$object_4,$hit    # 88e

        fnms    $t_4,$disc_4,$y_4,$b_11                 # 89e
        lnop                                            # 89o pairing

        fnms    $t_5,$disc_5,$y_5,$b_12                 # 90e
        stqd    $nearest_6,272($a_packet_5)             # 90o

        selb    $t_best_6,$t_best_3,$t_3,$hit_5         # 91e
        lqd     $nearest_7,272($a_packet)               # 91o

        selb    $t_best_7,$t_best_2,$t_2,$hit           # 92e
        lnop                                            # 92o pairing

        fma     $b,$fy,$dy_9,$b_16                      # 93e
        stqd    $t_best_6,192($a_packet_5)              # 93o

        fnms    $lx_3,$b_7,$dx_6,$fx_3                  # 94e
        stqd    $t_best_7,208($a_packet_5)              # 94o

        fma     $b_11,$fz_3,$dz_2,$b_15                 # 95e
        lqd     $t_best_3,192($a_packet)                # 95o

        fnms    $disc_9,$lx,$lx,$radius2_3              # 96e
        lqd     $t_best_2,208($a_packet)                # 96o

        clgt    $hit,$t_best_5,$t_4                     # 97e
        lqd     $object_2,0($a_pair)                    # 97o

        clgt    $hit_6,$t_best_4,$t_5                   # 98e
        ori     $object_6,$object_4,0                   # 99e copy

        selb    $nearest,$nearest_3,$object_4,$hit_5    # 100e
        andc    $hit,$hit,$disc_4                       # 101e

        andc    $hit_7,$hit_6,$disc_5                   # 102e
        lnop                                            # 102o pairing

next_pair:
            fnms    $ly,$b_7,$dy_7,$fy                  # 0e
            stqd    $nearest,256($a_packet_5)           # 0o

            fnms    $disc,$lx_3,$lx_3,$radius2_3        # 1e
            shlqbyi $a_packet_5,$a_packet,0             # 1o copy

            fma     $b,$fz_3,$dz_8,$b                   # 2e
            lqd     $nearest,256($a_packet)             # 2o

            fnms    $lx,$b_11,$dx_7,$fx_3               # 3e
            rotqbii $hit,$hit,1                         # 3o

            fnms    $ly_5,$b_11,$dy_8,$fy               # 4e
            rotqbii $hit_7,$hit_7,1                     # 4o

            fnms    $ly_6,$b_6,$dy_6,$fy                # 5e
            rotqbyi $a_packet,$object_2,4               # 5o

            fnms    $lz,$b_6,$dz_6,$fz_3                # 6e
            lqd     $quad,0($object_2)                  # 6o

            ai      $a_pair,$a_pair,16                  # 7e
            gb      $hit,$hit                           # 7o

            fnms    $disc,$ly,$ly,$disc                 # 8e
            gb      $hit_7,$hit_7                       # 8o

            fnms    $disc_3,$lx,$lx,$radius2_3          # 9e
            lqd     $dx,16($a_packet)                   # 9o

            fnms    $lz_6,$b_7,$dz_7,$fz_3              # 10e
            lqd     $dx_7,32($a_packet)                 # 10o

            fnms    $ly,$b,$dy_9,$fy                    # 11e
            shlqbii $hit,$hit,4                         # 11o

            fnms    $disc_4,$ly_6,$ly_6,$disc_9         # 12e
            shlqbii $hit_7,$hit_7,4                     # 12o

            fnms    $lx,$b,$dx_8,$fx_3                  # 13e
            shufb   $fy,$quad,$quad,$m_y                # 13o

            fnms    $lz_4,$b_11,$dz_2,$fz_3             # 14e
            shufb   $fx_3,$quad,$quad,$m_x              # 14o

            fnms    $lz_5,$b,$dz_8,$fz_3                # 15e
            lqd     $dx_8,48($a_packet)                 # 15o

            fnms    $disc,$lz_6,$lz_6,$disc             # 16e
            shufb   $fz_3,$quad,$quad,$m_z              # 16o

            fnms    $disc_10,$ly_5,$ly_5,$disc_3        # 17e
            lqd     $dx_2,0($a_packet)                  # 17o

            fnms    $disc_4,$lz,$lz,$disc_4             # 18e
            lqd     $dz_2,160($a_packet)                # 18o

            fm      $b_13,$fx_3,$dx                     # 19e
            lqd     $dy_6,80($a_packet)                 # 19o

            fnms    $disc_8,$lx,$lx,$radius2_3          # 20e
            shufb   $radius2_3,$quad,$quad,$m_radius2   # 20o

            fm      $b_17,$fx_3,$dx_7                   # 21e
            lqx     $merge,$a_merges,$hit_7             # 21o

        ai      $count,$count,-1                        # 22e
            frsqest $y_6,$disc                          # 22o

            fm      $b_3,$fx_3,$dx_2                    # 23e
            lqd     $dy_7,64($a_packet)                 # 23o

            fnms    $disc_10,$lz_4,$lz_4,$disc_10       # 24e
            frsqest $y_7,$disc_4                        # 24o

            fma     $b_13,$fy,$dy_6,$b_13               # 25e
            lqd     $dz_6,144($a_packet)                # 25o

            fnms    $t_6,$disc,$y_6,$b_7                # 26e
            lqd     $dz_7,128($a_packet)                # 26o

            fnms    $disc_8,$ly,$ly,$disc_8             # 27e
            lqd     $dy_9,112($a_packet)                # 27o

            fnms    $t_2,$disc_4,$y_7,$b_6              # 28e
            shufb   $t_best_8,$t_best_4,$t_5,$merge     # 28o

            fma     $b_3,$fy,$dy_7,$b_3                 # 29e
            lqx     $merge_2,$a_merges,$hit             # 29o

            fm      $b_16,$fx_3,$dx_8                   # 30e
            frsqest $y_8,$disc_10                       # 30o

            fma     $b_6,$fz_3,$dz_6,$b_13              # 31e
            shufb   $nearest_8,$nearest_4,$object_6,$merge # 31o

            clgt    $hit_3,$t_best_3,$t_6               # 32e
            lqd     $dy_8,96($a_packet)                 # 32o

            fnms    $disc_5,$lz_5,$lz_5,$disc_8         # 33e
            stqd    $t_best_8,240($a_packet_6)          # 33o

            clgt    $hit_2,$t_best_2,$t_2               # 34e
            lqd     $t_best_4,240($a_packet_3)          # 34o

            andc    $hit_4,$hit_3,$disc                 # 35e
            stqd    $nearest_8,304($a_packet_6)         # 35o

            fma     $b_7,$fz_3,$dz_7,$b_3               # 36e
            shufb   $nearest_8,$nearest_5,$object_6,$merge_2 # 36o

            ori     $object_6,$object_5,0               # 37e copy
            shufb   $t_best_9,$t_best_5,$t_4,$merge_2   # 37o

            fnms    $t_4,$disc_10,$y_8,$b_11            # 38e
            lqd     $nearest_4,304($a_packet_3)         # 38o

            fma     $b_17,$fy,$dy_8,$b_17               # 39e
            frsqest $y_9,$disc_5                        # 39o

            andc    $hit,$hit_2,$disc_4                 # 40e
            stqd    $nearest_8,288($a_packet_6)         # 40o

            fnms    $lx,$b_6,$dx,$fx_3                  # 41e
            stqd    $t_best_9,224($a_packet_6)          # 41o

            rotmai  $hit,$hit,-31                       # 42e
            shlqbyi $a_packet_6,$a_packet_4,0           # 42o copy

            rotmai  $hit_8,$hit_4,-31                   # 43e
            lqd     $t_best_5,224($a_packet_3)          # 43o

            fnms    $t_5,$disc_5,$y_9,$b                # 44e
            lqd     $nearest_5,288($a_packet_3)         # 44o

            fma     $b,$fy,$dy_9,$b_16                  # 45e
            shlqbyi $a_packet_3,$a_packet,0             # 45o copy

            selb    $nearest_8,$nearest_7,$object_5,$hit # 46e
            shlqbyi $a_packet_4,$a_packet,0             # 46o copy

            fnms    $lx_3,$b_7,$dx_2,$fx_3              # 47e
            lqd     $dz_8,176($a_packet)                # 47o

            selb    $t_best_10,$t_best_3,$t_6,$hit_8    # 48e
            stqd    $nearest_8,272($a_packet_5)         # 48o

            selb    $t_best_7,$t_best_2,$t_2,$hit       # 49e
            lqd     $nearest_7,272($a_packet)           # 49o

            fma     $b_11,$fz_3,$dz_2,$b_17             # 50e
            stqd    $t_best_10,192($a_packet_5)         # 50o

            clgt    $hit,$t_best_5,$t_4                 # 51e
            stqd    $t_best_7,208($a_packet_5)          # 51o

            selb    $nearest,$nearest,$object_5,$hit_8  # 52e
            lqd     $t_best_3,192($a_packet)            # 52o

            clgt    $hit_7,$t_best_4,$t_5               # 53e
            lqd     $t_best_2,208($a_packet)            # 53o

            andc    $hit,$hit,$disc_10                  # 54e
            shufb   $object_5,$object_2,$object_2,$m_x  # 54o

            fnms    $disc_9,$lx,$lx,$radius2_3          # 55e
        lqd     $object_2,0($a_pair)                    # 55o

            andc    $hit_7,$hit_7,$disc_5               # 56e
next_pair_back:
        brnz    $count,next_pair                        # 56o

next_pair_drain:
        fnms    $ly,$b_7,$dy_7,$fy                      # 0e
        stqd    $nearest,256($a_packet_5)               # 0o

        fnms    $disc,$lx_3,$lx_3,$radius2_3            # 1e
        shlqbyi $a_packet_5,$a_packet,0                 # 1o copy

        fma     $b,$fz_3,$dz_8,$b                       # 2e
        lqd     $nearest,256($a_packet)                 # 2o

        fnms    $lx,$b_11,$dx_7,$fx_3                   # 3e
        rotqbii $hit,$hit,1                             # 3o

        fnms    $ly_5,$b_11,$dy_8,$fy                   # 4e
        rotqbii $hit_7,$hit_7,1                         # 4o

        fnms    $ly_6,$b_6,$dy_6,$fy                    # 5e
        rotqbyi $a_packet,$object_2,4                   # 5o

        fnms    $lz,$b_6,$dz_6,$fz_3                    # 6e
        lqd     $quad,0($object_2)                      # 6o

        ai      $a_pair,$a_pair,16                      # 7e
        gb      $hit,$hit                               # 7o

        fnms    $disc,$ly,$ly,$disc                     # 8e
        gb      $hit_7,$hit_7                           # 8o

        fnms    $disc_3,$lx,$lx,$radius2_3              # 9e
        lqd     $dx,16($a_packet)                       # 9o

        fnms    $lz_6,$b_7,$dz_7,$fz_3                  # 10e
        lqd     $dx_7,32($a_packet)                     # 10o

        fnms    $ly,$b,$dy_9,$fy                        # 11e
        shlqbii $hit,$hit,4                             # 11o

        fnms    $disc_4,$ly_6,$ly_6,$disc_9             # 12e
        shlqbii $hit_7,$hit_7,4                         # 12o

        fnms    $lx,$b,$dx_8,$fx_3                      # 13e
        shufb   $fy,$quad,$quad,$m_y                    # 13o

        fnms    $lz_4,$b_11,$dz_2,$fz_3                 # 14e
        shufb   $fx_3,$quad,$quad,$m_x                  # 14o

        fnms    $lz_5,$b,$dz_8,$fz_3                    # 15e
        lqd     $dx_8,48($a_packet)                     # 15o

        fnms    $disc,$lz_6,$lz_6,$disc                 # 16e
        shufb   $fz_3,$quad,$quad,$m_z                  # 16o

        fnms    $disc_10,$ly_5,$ly_5,$disc_3            # 17e
        lqd     $dx_2,0($a_packet)                      # 17o

        fnms    $disc_4,$lz,$lz,$disc_4                 # 18e
        lqd     $dz_2,160($a_packet)                    # 18o

        fm      $b_13,$fx_3,$dx                         # 19e
        lqd     $dy_6,80($a_packet)                     # 19o

        fnms    $disc_8,$lx,$lx,$radius2_3              # 20e
        shufb   $radius2_3,$quad,$quad,$m_radius2       # 20o

        fm      $b_17,$fx_3,$dx_7                       # 21e
        lqx     $merge,$a_merges,$hit_7                 # 21o

        fm      $b_16,$fx_3,$dx_8                       # 22e
        frsqest $y_6,$disc                              # 22o

        fm      $b_3,$fx_3,$dx_2                        # 23e
        lqd     $dy_7,64($a_packet)                     # 23o

        fnms    $disc_10,$lz_4,$lz_4,$disc_10           # 24e
        frsqest $y_7,$disc_4                            # 24o

        fma     $b_13,$fy,$dy_6,$b_13                   # 25e
        lqd     $dz_6,144($a_packet)                    # 25o

        fnms    $t_6,$disc,$y_6,$b_7                    # 26e
        hbr     isect_pairs_estimate_r16_return,$lr     # 26o hint

        fnms    $disc_8,$ly,$ly,$disc_8                 # 27e
        lqd     $dz_7,128($a_packet)                    # 27o

        fnms    $t_2,$disc_4,$y_7,$b_6                  # 28e
        lqd     $dy_9,112($a_packet)                    # 28o

        fma     $b_3,$fy,$dy_7,$b_3                     # 29e
        shufb   $t_best_8,$t_best_4,$t_5,$merge         # 29o

        ori     $object_7,$object_5,0                   # 30e copy
        lqx     $merge_2,$a_merges,$hit                 # 30o

        fma     $b_6,$fz_3,$dz_6,$b_13                  # 31e
        frsqest $y_8,$disc_10                           # 31o

        clgt    $hit_9,$t_best_3,$t_6                   # 32e
        shufb   $nearest_8,$nearest_4,$object_6,$merge  # 32o

        fnms    $disc_5,$lz_5,$lz_5,$disc_8             # 33e
        lqd     $dy_8,96($a_packet)                     # 33o

        clgt    $hit_2,$t_best_2,$t_2                   # 34e
        stqd    $t_best_8,240($a_packet_6)              # 34o

        andc    $hit_4,$hit_9,$disc                     # 35e
        lqd     $t_best_4,240($a_packet_3)              # 35o

        fma     $b_7,$fz_3,$dz_7,$b_3                   # 36e
        stqd    $nearest_8,304($a_packet_6)             # 36o

        fnms    $t_7,$disc_10,$y_8,$b_11                # 37e
        shufb   $nearest_8,$nearest_5,$object_6,$merge_2 # 37o

        andc    $hit_8,$hit_2,$disc_4                   # 38e
        shufb   $t_best_9,$t_best_5,$t_4,$merge_2       # 38o

        fma     $b_17,$fy,$dy_8,$b_17                   # 39e
        lqd     $nearest_4,304($a_packet_3)             # 39o

        fnms    $lx,$b_6,$dx,$fx_3                      # 40e
        frsqest $y_9,$disc_5                            # 40o

        rotmai  $hit,$hit_8,-31                         # 41e
        stqd    $nearest_8,288($a_packet_6)             # 41o

        rotmai  $hit_8,$hit_4,-31                       # 42e
        stqd    $t_best_9,224($a_packet_6)              # 42o

        fma     $b_13,$fy,$dy_9,$b_16                   # 43e
        shlqbyi $a_packet_6,$a_packet_4,0               # 43o copy

        fnms    $t_5,$disc_5,$y_9,$b                    # 44e
        lqd     $t_best_5,224($a_packet_3)              # 44o

        selb    $nearest_9,$nearest_7,$object_5,$hit    # 45e
        lqd     $nearest_5,288($a_packet_3)             # 45o

        fnms    $lx_3,$b_7,$dx_2,$fx_3                  # 46e
        shlqbyi $a_packet_3,$a_packet,0                 # 46o copy

        selb    $t_best_10,$t_best_3,$t_6,$hit_8        # 47e
        shlqbyi $a_packet_4,$a_packet,0                 # 47o copy

        selb    $t_best_11,$t_best_2,$t_2,$hit          # 48e
        lqd     $dz_8,176($a_packet)                    # 48o

        fma     $b_11,$fz_3,$dz_2,$b_17                 # 49e
        stqd    $nearest_9,272($a_packet_5)             # 49o

        clgt    $hit,$t_best_5,$t_7                     # 50e
        lqd     $nearest_7,272($a_packet)               # 50o

        selb    $nearest,$nearest,$object_5,$hit_8      # 51e
        stqd    $t_best_10,192($a_packet_5)             # 51o

        clgt    $hit_7,$t_best_4,$t_5                   # 52e
        stqd    $t_best_11,208($a_packet_5)             # 52o

        andc    $hit,$hit,$disc_10                      # 53e
        lqd     $t_best_3,192($a_packet)                # 53o

        fnms    $disc_9,$lx,$lx,$radius2_3              # 54e
        lqd     $t_best_2,208($a_packet)                # 54o

        andc    $hit_7,$hit_7,$disc_5                   # 55e
        shufb   $object_5,$object_2,$object_2,$m_x      # 55o

        fnms    $ly,$b_7,$dy_7,$fy                      # 56e
        stqd    $nearest,256($a_packet_5)               # 56o

        fnms    $disc,$lx_3,$lx_3,$radius2_3            # 57e
        shlqbyi $a_packet_5,$a_packet,0                 # 57o copy

        fma     $b,$fz_3,$dz_8,$b_13                    # 58e
        lqd     $nearest,256($a_packet)                 # 58o

        fnms    $lx,$b_11,$dx_7,$fx_3                   # 59e
        rotqbii $hit,$hit,1                             # 59o

        fnms    $ly_5,$b_11,$dy_8,$fy                   # 60e
        rotqbii $hit_7,$hit_7,1                         # 60o

        fnms    $ly_6,$b_6,$dy_6,$fy                    # 61e
        shlqbyi $a_packet_7,$a_packet_4,0               # 61o copy

        fnms    $lz,$b_6,$dz_6,$fz_3                    # 62e
        lnop                                            # 62o pairing

        fnms    $disc,$ly,$ly,$disc                     # 63e
        gb      $hit,$hit                               # 63o

        fnms    $lz_6,$b_7,$dz_7,$fz_3                  # 64e
        gb      $hit_7,$hit_7                           # 64o

        fnms    $disc_11,$lx,$lx,$radius2_3             # 65e
        fnms    $ly,$b,$dy_9,$fy                        # 66e

        fnms    $disc_4,$ly_6,$ly_6,$disc_9             # 67e
        shlqbii $hit,$hit,4                             # 67o

        fnms    $lx,$b,$dx_8,$fx_3                      # 68e
        shlqbii $hit_7,$hit_7,4                         # 68o

        fnms    $lz_4,$b_11,$dz_2,$fz_3                 # 69e
        fnms    $lz_5,$b,$dz_8,$fz_3                    # 70e

        fnms    $disc,$lz_6,$lz_6,$disc                 # 71e
        lqx     $merge_2,$a_merges,$hit                 # 71o

        fnms    $disc_10,$ly_5,$ly_5,$disc_11           # 72e
        lqx     $merge,$a_merges,$hit_7                 # 72o

        fnms    $disc_4,$lz,$lz,$disc_4                 # 73e
        fnms    $disc_8,$lx,$lx,$radius2_3              # 74e

        ori     $object_6,$object_5,0                   # 75e copy
        frsqest $y_6,$disc                              # 77o

        fnms    $disc_10,$lz_4,$lz_4,$disc_10           # 78e
        shufb   $t_best_7,$t_best_4,$t_5,$merge         # 78o

        nop     $127                                    # 79e pairing
        frsqest $y_7,$disc_4                            # 79o

        fnms    $disc_8,$ly,$ly,$disc_8                 # 80e
        shufb   $nearest_10,$nearest_4,$object_7,$merge # 80o

        fnms    $t_6,$disc,$y_6,$b_7                    # 81e
        shufb   $nearest_11,$nearest_5,$object_7,$merge_2 # 81o

        nop     $127                                    # 82e pairing
        stqd    $t_best_7,240($a_packet_6)              # 82o

        fnms    $t_2,$disc_4,$y_7,$b_6                  # 83e
        lqd     $t_best_4,240($a_packet_3)              # 83o

        frsqest $y_8,$disc_10                           # 84o
        stqd    $nearest_10,304($a_packet_6)            # 85o

        fnms    $disc_5,$lz_5,$lz_5,$disc_8             # 86e
        shufb   $t_best_12,$t_best_5,$t_7,$merge_2      # 86o

        clgt    $hit_3,$t_best_3,$t_6                   # 87e
        lqd     $nearest_4,304($a_packet_3)             # 87o

        fnms    $t_4,$disc_10,$y_8,$b_11                # 88e
        stqd    $nearest_11,288($a_packet_6)            # 88o

        clgt    $hit_2,$t_best_2,$t_2                   # 89e
        lnop                                            # 89o pairing

        andc    $hit_4,$hit_3,$disc                     # 90e
        stqd    $t_best_12,224($a_packet_6)             # 90o

        andc    $hit,$hit_2,$disc_4                     # 91e
        lqd     $t_best_5,224($a_packet_3)              # 91o

        rotmai  $hit_8,$hit_4,-31                       # 92e
        frsqest $y_9,$disc_5                            # 92o

        rotmai  $hit,$hit,-31                           # 93e
        lqd     $nearest_5,288($a_packet_3)             # 93o

        fnms    $t_5,$disc_5,$y_9,$b                    # 96e
        selb    $nearest_8,$nearest_7,$object_5,$hit    # 97e

        selb    $t_best_10,$t_best_3,$t_6,$hit_8        # 98e
        lnop                                            # 98o pairing

        selb    $t_best_13,$t_best_2,$t_2,$hit          # 99e
        stqd    $nearest_8,272($a_packet_5)             # 99o

        clgt    $hit,$t_best_5,$t_4                     # 100e
        stqd    $t_best_10,192($a_packet_5)             # 100o

        selb    $nearest,$nearest,$object_5,$hit_8      # 101e
        stqd    $t_best_13,208($a_packet_5)             # 101o

        clgt    $hit_7,$t_best_4,$t_5                   # 102e
        lnop                                            # 102o pairing

        andc    $hit,$hit,$disc_10                      # 103e
        stqd    $nearest,256($a_packet_5)               # 103o

        andc    $hit_7,$hit_7,$disc_5                   # 104e
        rotqbii $hit,$hit,1                             # 105o

        rotqbii $hit_7,$hit_7,1                         # 106o
        gb      $hit,$hit                               # 109o

        gb      $hit_7,$hit_7                           # 110o
        shlqbii $hit,$hit,4                             # 113o

        shlqbii $hit_7,$hit_7,4                         # 114o
        lqx     $merge_2,$a_merges,$hit                 # 117o

        lqx     $merge,$a_merges,$hit_7                 # 118o
        shufb   $nearest_8,$nearest_5,$object_6,$merge_2 # 123o

        shufb   $t_best_8,$t_best_4,$t_5,$merge         # 124o
        shufb   $nearest_12,$nearest_4,$object_6,$merge # 125o

        shufb   $t_best_9,$t_best_5,$t_4,$merge_2       # 126o
        stqd    $t_best_8,240($a_packet_7)              # 128o

        stqd    $nearest_12,304($a_packet_7)            # 129o
        stqd    $nearest_8,288($a_packet_7)             # 130o

        stqd    $t_best_9,224($a_packet_7)              # 131o
isect_pairs_estimate_r16_return:
        bi      $lr                                     # 132o

next_pair_short:
        ai      $count,$count,-1                        # 0e
        lqd     $object,0($a_pair)                      # 0o

        ai      $a_pair,$a_pair,16                      # 1e
        rotqbyi $a_packet,$object,4                     # 6o

        lqd     $quad,0($object)                        # 7o
        shufb   $object,$object,$object,$m_x            # 8o

        lqd     $dx,32($a_packet)                       # 10o
        lqd     $dx_9,48($a_packet)                     # 11o

        lqd     $dz,160($a_packet)                      # 12o
        shufb   $fx,$quad,$quad,$m_x                    # 13o

        shufb   $fy,$quad,$quad,$m_y                    # 14o
        lqd     $dy,112($a_packet)                      # 15o

        nop     $127                                    # 16e pairing
        lqd     $dy_10,96($a_packet)                    # 16o

        fm      $b,$fx,$dx_9                            # 17e
        lqd     $dz_9,176($a_packet)                    # 17o

        fm      $b_18,$fx,$dx                           # 18e
        lqd     $dx_2,0($a_packet)                      # 18o

        lqd     $dx_10,16($a_packet)                    # 19o
        shufb   $fz,$quad,$quad,$m_z                    # 20o

        lqd     $dy_3,80($a_packet)                     # 21o
        lqd     $dz_2,128($a_packet)                    # 22o

        fma     $b,$fy,$dy,$b                           # 23e
        lqd     $dy_11,64($a_packet)                    # 23o

        fma     $b_18,$fy,$dy_10,$b_18                  # 24e
        shufb   $radius2_2,$quad,$quad,$m_radius2       # 24o

        fm      $b_19,$fx,$dx_2                         # 25e
        lqd     $dz_10,144($a_packet)                   # 25o

        fm      $b_20,$fx,$dx_10                        # 26e
        lqd     $t_best_9,240($a_packet)                # 26o

        lqd     $t_best_14,224($a_packet)               # 27o
        lqd     $t_best_15,208($a_packet)               # 28o

        fma     $b,$fz,$dz_9,$b                         # 29e
        lqd     $nearest_13,304($a_packet)              # 29o

        fma     $b_18,$fz,$dz,$b_18                     # 30e
        lqd     $t_best_16,192($a_packet)               # 30o

        fma     $b_19,$fy,$dy_11,$b_19                  # 31e
        lqd     $nearest_14,256($a_packet)              # 31o

        fma     $b_20,$fy,$dy_3,$b_20                   # 32e
        lqd     $nearest_15,288($a_packet)              # 32o

        lqd     $nearest_16,272($a_packet)              # 33o
        fnms    $lx_6,$b,$dx_9,$fx                      # 35e

        fnms    $lx_2,$b_18,$dx,$fx                     # 36e
        fnms    $ly_7,$b,$dy,$fy                        # 37e

        fma     $b_20,$fz,$dz_10,$b_20                  # 38e
        fnms    $ly_5,$b_18,$dy_10,$fy                  # 39e

        fnms    $lz_7,$b_18,$dz,$fz                     # 40e
        fnms    $disc_12,$lx_6,$lx_6,$radius2_2         # 41e

        fnms    $disc_2,$lx_2,$lx_2,$radius2_2          # 42e
        fma     $b_19,$fz,$dz_2,$b_19                   # 43e

        fnms    $lx_5,$b_20,$dx_10,$fx                  # 44e
        fnms    $lz_8,$b,$dz_9,$fz                      # 45e

        fnms    $ly_3,$b_20,$dy_3,$fy                   # 46e
        fnms    $disc_12,$ly_7,$ly_7,$disc_12           # 47e

        fnms    $disc_10,$ly_5,$ly_5,$disc_2            # 48e
        fnms    $lx_3,$b_19,$dx_2,$fx                   # 49e

        fnms    $disc_6,$lx_5,$lx_5,$radius2_2          # 50e
        fnms    $ly_8,$b_19,$dy_11,$fy                  # 51e

        fnms    $lz_9,$b_19,$dz_2,$fz                   # 52e
        fnms    $disc_12,$lz_8,$lz_8,$disc_12           # 53e

        fnms    $disc_10,$lz_7,$lz_7,$disc_10           # 54e
        fnms    $disc_13,$lx_3,$lx_3,$radius2_2         # 55e

        fnms    $lz_10,$b_20,$dz_10,$fz                 # 56e
        fnms    $disc_6,$ly_3,$ly_3,$disc_6             # 57e

        frsqest $y_5,$disc_12                           # 59o
        frsqest $y_10,$disc_10                          # 60o

        fnms    $disc_13,$ly_8,$ly_8,$disc_13           # 61e
        fnms    $t_8,$disc_12,$y_5,$b                   # 63e

        fnms    $disc_3,$lz_10,$lz_10,$disc_6           # 64e
        fnms    $t_9,$disc_10,$y_10,$b_18               # 65e

        fnms    $disc_13,$lz_9,$lz_9,$disc_13           # 67e
        clgt    $hit_10,$t_best_9,$t_8                  # 69e

        frsqest $y_7,$disc_3                            # 70o
        clgt    $hit_11,$t_best_14,$t_9                 # 71e

        andc    $hit_12,$hit_10,$disc_12                # 72e
        lnop                                            # 72o pairing

        andc    $hit_6,$hit_11,$disc_10                 # 73e
        frsqest $y_4,$disc_13                           # 73o

        fnms    $t_2,$disc_3,$y_7,$b_20                 # 74e
        rotqbii $hit_12,$hit_12,1                       # 74o

        rotqbii $hit_6,$hit_6,1                         # 75o
        fnms    $t_10,$disc_13,$y_4,$b_19               # 77e

        gb      $hit_12,$hit_12                         # 78o
        gb      $hit_6,$hit_6                           # 79o

        clgt    $hit_11,$t_best_15,$t_2                 # 80e
        lnop                                            # 80o pairing

        andc    $hit_13,$hit_11,$disc_3                 # 82e
        shlqbii $hit_12,$hit_12,4                       # 82o

        clgt    $hit_11,$t_best_16,$t_10                # 83e
        shlqbii $hit_6,$hit_6,4                         # 83o

        rotmai  $hit_13,$hit_13,-31                     # 84e
        andc    $hit_7,$hit_11,$disc_13                 # 85e

        nop     $127                                    # 86e pairing
        lqx     $merge_3,$a_merges,$hit_12              # 86o

        rotmai  $hit_7,$hit_7,-31                       # 87e
        lqx     $merge_4,$a_merges,$hit_6               # 87o

        selb    $t_best,$t_best_15,$t_2,$hit_13         # 88e
        selb    $nearest,$nearest_16,$object,$hit_13    # 89e

        nop     $127                                    # 90e pairing
        stqd    $t_best,208($a_packet)                  # 90o

        selb    $t_best,$t_best_16,$t_10,$hit_7         # 91e
        stqd    $nearest,272($a_packet)                 # 91o

        selb    $nearest,$nearest_14,$object,$hit_7     # 92e
        shufb   $nearest_3,$nearest_13,$object,$merge_3 # 92o

        shufb   $t_best_17,$t_best_14,$t_9,$merge_4     # 93o
        shufb   $nearest_17,$nearest_15,$object,$merge_4 # 94o

        shufb   $t_best_18,$t_best_9,$t_8,$merge_3      # 95o
        stqd    $nearest_3,304($a_packet)               # 96o

        stqd    $t_best_17,224($a_packet)               # 97o
        stqd    $nearest_17,288($a_packet)              # 98o

        stqd    $t_best_18,240($a_packet)               # 99o
        stqd    $t_best,192($a_packet)                  # 100o

        stqd    $nearest,256($a_packet)                 # 101o
        brnz    $count,next_pair_short                  # 102o

        nop     $127                                    # 103e pairing
        bi      $lr                                     # 103o
endfunction isect_pairs_estimate_r16
