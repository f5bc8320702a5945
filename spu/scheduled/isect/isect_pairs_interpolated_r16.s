# isect_pairs_interpolated_r16   nearest entries of primary rays into spheres, 12 bits of root
#   C       void isect_pairs_interpolated_r16(const struct pair *, int count);
#   In      $3 pairs, $4 count (0 is none); pointers 16-aligned
#   Out     the pairs' packets: t, object, where an entry is nearer than what was there
#   Uses    $2-$62, $79   Saves  -   Stack  0   Calls  -
#   Domain  |d| = 1 within 4 ulp; radius > 0; centre and radius below 2^62
#   Error   6000 ulp of t, eye 1.5 to 30 radii from the centre, ray within 0.995 r of it
#   Twin    lab/twins/src/sphere/perpendicular.rs
#
# The steps are in sphere_tmpl.inc. An opaque sphere has no inside, so only the entry counts, and
# only if it is in front of the eye.
# Scheduled by spu schedule from isect_pairs_interpolated_r16.s

        .include "sphere_eye.inc"
        .include "sphere_interpolated.inc"

        eye_registers "", "radius2", "b,lx,ly,lz,disc,y"
        merges_table

function isect_pairs_interpolated_r16
        .set count_2,79; .set a_pair_2,2; .set object_2,22; .set a_pair_3,7; .set object_3,2
        .set a_packet_2,37; .set quad_2,30; .set object_4,5; .set a_packet_3,15; .set dx_2,41
        .set dx_3,42; .set dx_4,43; .set cx_2,44; .set cy_2,45; .set dx_5,46; .set dy_2,48
        .set b_2,49; .set cz_2,51; .set b_3,50; .set dy_3,53; .set b_4,52; .set dz_2,38
        .set dy_4,55; .set b_5,54; .set dy_5,6; .set dz_3,57; .set b_6,29; .set radius2_2,8
        .set dz_4,61; .set dz_5,9; .set b_7,31; .set a_packet_4,17; .set b_8,40; .set a_packet_5,18
        .set nearest_2,20; .set b_9,59; .set a_packet_6,22; .set t_best_2,35; .set t_best_3,36
        .set b_10,60; .set nearest_3,23; .set b_11,28; .set dx_6,29; .set lx_2,31; .set ly_2,16
        .set dx_7,32; .set lz_2,19; .set dx_8,34; .set lx_3,21; .set lz_3,24; .set cx_3,38
        .set ly_3,25; .set cy_3,39; .set cz_3,40; .set ly_4,33; .set lx_4,26; .set dz_6,37
        .set disc_2,21; .set ly_5,41; .set dy_6,49; .set lx_5,6; .set radius2_3,50; .set dz_7,46
        .set disc_3,43; .set dz_8,44; .set lz_4,47; .set a_packet_7,9; .set disc_4,8
        .set t_best_4,6; .set b_12,45; .set nearest_4,16; .set b_13,51; .set disc_5,52
        .set object_5,19; .set object_6,21; .set b_14,2; .set y_2,41; .set disc_6,33
        .set a_packet_8,24; .set b_15,43; .set y_3,51; .set disc_7,58; .set y_4,8; .set b_16,30
        .set t_2,41; .set disc_8,47; .set y_5,33; .set t_3,56; .set lx_6,8; .set hit_2,42
        .set ly_6,45; .set y_6,48; .set hit_3,31; .set lx_7,29; .set lz_5,51; .set ly_7,52
        .set disc_9,29; .set lz_6,37; .set y_7,45; .set y_8,23; .set t_best_5,5; .set disc_10,2
        .set t_4,5; .set b_17,23; .set hit_4,7; .set nearest_5,15; .set y_9,31; .set ly_8,39
        .set quad_3,42; .set lx_8,38; .set lz_7,52; .set dx_9,62; .set disc_11,28; .set disc_12,38
        .set t_5,39; .set hit_5,30; .set hit_6,28; .set merge_2,7; .set y_10,54; .set dz_9,42
        .set hit_7,2; .set merge_3,30; .set nearest_6,6; .set ly_9,7; .set disc_13,5; .set lz_8,8
        .set y_11,7; .set t_best_6,2; .set t_best_7,22; .set ly_10,31; .set y_12,39; .set lz_9,40
        .set y_13,3; .set b_18,4; .set b_19,5; .set nearest_7,7; .set t_6,3; .set ly_11,9
        .set t_best_8,11; .set disc_14,12; .set disc_15,6; .set a_packet_9,13; .set hit_8,17
        .set object_7,10; .set a_packet_10,8; .set hit_9,22; .set a_packet_11,23; .set object_8,27
        .set ly_12,30; .set lz_10,22; .set disc_16,9; .set hit_10,12; .set lz_11,15
        .set t_best_9,17; .set merge_4,6; .set nearest_8,11; .set t_7,4; .set hit_11,3
        .set dx_10,2; .set dy_7,5; .set dz_10,6; .set b_20,7; .set dx_11,8; .set dx_12,9
        .set dy_8,21; .set dy_9,25; .set radius2_4,17; .set dz_11,26; .set dz_12,29
        .set t_best_10,31; .set t_best_11,32; .set t_best_12,33; .set t_best_13,34
        .set nearest_9,35; .set nearest_10,36; .set nearest_11,37; .set nearest_12,38; .set lx_9,22
        .set lx_10,2; .set ly_13,23; .set ly_14,5; .set disc_17,22; .set lz_12,6; .set lx_11,9
        .set disc_18,18; .set ly_15,19; .set disc_19,17; .set lz_13,18; .set y_14,9; .set y_15,19
        .set t_8,8; .set t_9,7; .set y_16,18; .set hit_12,19; .set hit_13,20; .set t_10,9
        .set t_11,18; .set merge_5,17; .set merge_6,2; .set hit_14,5; .set hit_15,6
        .set t_best_14,7; .set t_best_15,8; .set nearest_13,2; .set nearest_14,5
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
        ai      $a_pair_3,$a_pair_2,16                  # 13e
        lqd     $object_3,0($a_pair_2)                  # 13o
        ai      $count,$count,-1                        # 14e
        ai      $a_pair,$a_pair_3,16                    # 15e
        ai      $count,$count,-1                        # 16e
        rotqbyi $a_packet_2,$object_2,4                 # 17o
        lqd     $quad_2,0($object_2)                    # 18o
        shufb   $object_4,$object_2,$object_2,$m_x      # 19o
        rotqbyi $a_packet_3,$object_3,4                 # 20o
        lqd     $dx_2,0($a_packet_2)                    # 21o
        lqd     $dx_3,16($a_packet_2)                   # 22o
        lqd     $dx_4,32($a_packet_2)                   # 23o
        shufb   $cx_2,$quad_2,$quad_2,$m_x              # 24o
        shufb   $cy_2,$quad_2,$quad_2,$m_y              # 25o
        lqd     $dx_5,48($a_packet_2)                   # 26o
        lqd     $dy_2,80($a_packet_2)                   # 27o
        fm      $b_2,$cx_2,$dx_3                        # 28e
        shufb   $cz_2,$quad_2,$quad_2,$m_z              # 28o
        fm      $b_3,$cx_2,$dx_2                        # 29e
        lqd     $dy_3,112($a_packet_2)                  # 29o
        fm      $b_4,$cx_2,$dx_4                        # 30e
        lqd     $dz_2,144($a_packet_2)                  # 30o
        nop     $127                                    # 31e pairing
        lqd     $dy_4,64($a_packet_2)                   # 31o
        fm      $b_5,$cx_2,$dx_5                        # 32e
        lqd     $dy_5,96($a_packet_2)                   # 32o
        nop     $127                                    # 33e pairing
        lqd     $dz_3,128($a_packet_2)                  # 33o
        fma     $b_6,$cy_2,$dy_2,$b_2                   # 34e
        shufb   $radius2_2,$quad_2,$quad_2,$m_radius2   # 34o
        lqd     $dz_4,176($a_packet_2)                  # 35o
        lqd     $dz_5,160($a_packet_2)                  # 36o
        fma     $b_7,$cy_2,$dy_4,$b_3                   # 37e
        shlqbyi $a_packet_4,$a_packet_2,0               # 37o copy
        fma     $b_8,$cy_2,$dy_3,$b_5                   # 38e
        shlqbyi $a_packet_5,$a_packet_2,0               # 38o copy
        fma     $b_4,$cy_2,$dy_5,$b_4                   # 39e
        lqd     $nearest_2,272($a_packet_2)             # 39o
        fma     $b_9,$cz_2,$dz_2,$b_6                   # 40e
        shlqbyi $a_packet_6,$a_packet_2,0               # 40o copy
        lqd     $t_best_2,208($a_packet_2)              # 41o
        lqd     $t_best_3,192($a_packet_2)              # 42o
        fma     $b_10,$cz_2,$dz_3,$b_7                  # 43e
        lqd     $nearest_3,256($a_packet_2)             # 43o
        fma     $b,$cz_2,$dz_4,$b_8                     # 44e
        lqd     $quad_2,0($object_3)                    # 44o
        fma     $b_11,$cz_2,$dz_5,$b_4                  # 45e
        lqd     $dx_6,0($a_packet_3)                    # 45o
        fnms    $lx_2,$b_9,$dx_3,$cx_2                  # 46e
        lqd     $dx_3,16($a_packet_3)                   # 46o
        fnms    $ly_2,$b_9,$dy_2,$cy_2                  # 47e
        lqd     $dx_7,32($a_packet_3)                   # 47o
        fnms    $lz_2,$b_9,$dz_2,$cz_2                  # 48e
        lqd     $dx_8,48($a_packet_3)                   # 48o
        fnms    $lx_3,$b_10,$dx_2,$cx_2                 # 49e
        lqd     $dy_2,80($a_packet_3)                   # 49o
        fnms    $lz_3,$b_10,$dz_3,$cz_2                 # 50e
        shufb   $cx_3,$quad_2,$quad_2,$m_x              # 50o
        fnms    $ly_3,$b_10,$dy_4,$cy_2                 # 51e
        shufb   $cy_3,$quad_2,$quad_2,$m_y              # 51o
        fnms    $disc,$lx_2,$lx_2,$radius2_2            # 52e
        shufb   $cz_3,$quad_2,$quad_2,$m_z              # 52o
        fnms    $ly_4,$b,$dy_3,$cy_2                    # 53e
        lqd     $dy_3,112($a_packet_3)                  # 53o
        fnms    $lx_4,$b,$dx_5,$cx_2                    # 54e
        lqd     $dz_6,144($a_packet_3)                  # 54o
        fnms    $disc_2,$lx_3,$lx_3,$radius2_2          # 55e
        lqd     $dy_4,64($a_packet_3)                   # 55o
        fnms    $ly_5,$b_11,$dy_5,$cy_2                 # 56e
        lqd     $dy_6,96($a_packet_3)                   # 56o
        fnms    $lx_5,$b_11,$dx_4,$cx_2                 # 57e
        lqd     $dz_3,128($a_packet_3)                  # 57o
        fnms    $disc,$ly_2,$ly_2,$disc                 # 58e
        shufb   $radius2_3,$quad_2,$quad_2,$m_radius2   # 58o
        fnms    $lz,$b_11,$dz_5,$cz_2                   # 59e
        lqd     $dz_7,176($a_packet_3)                  # 59o
        fnms    $disc_3,$lx_4,$lx_4,$radius2_2          # 60e
        lqd     $dz_8,160($a_packet_3)                  # 60o
        fnms    $disc_2,$ly_3,$ly_3,$disc_2             # 61e
        lqd     $nearest,288($a_packet_5)               # 61o
        fnms    $lz_4,$b,$dz_4,$cz_2                    # 62e
        shlqbyi $a_packet_7,$a_packet_4,0               # 62o copy
        fnms    $disc_4,$lx_5,$lx_5,$radius2_2          # 63e
        lqd     $t_best_4,240($a_packet_5)              # 63o
        fnms    $disc,$lz_2,$lz_2,$disc                 # 64e
        lqd     $t_best,224($a_packet_5)                # 64o
        fm      $b_12,$cx_3,$dx_3                       # 65e
        lqd     $nearest_4,304($a_packet_5)             # 65o
        fm      $b_13,$cx_3,$dx_6                       # 66e
        shlqbyi $a_packet_4,$a_packet_3,0               # 66o copy
        fnms    $disc_5,$lz_3,$lz_3,$disc_2             # 67e
        shlqbyi $a_packet_5,$a_packet_3,0               # 67o copy
        fm      $b_5,$cx_3,$dx_7                        # 68e
        shlqbyi $object_5,$object_4,0                   # 68o copy
        fnms    $disc_4,$ly_5,$ly_5,$disc_4             # 69e
        shufb   $object_6,$object_3,$object_3,$m_x      # 69o
        fm      $b_14,$cx_3,$dx_8                       # 70e
        frsqest $y_2,$disc                              # 70o
        fnms    $disc_6,$ly_4,$ly_4,$disc_3             # 71e
        shlqbyi $a_packet_8,$a_packet_3,0               # 71o copy
        fma     $b_15,$cy_3,$dy_2,$b_12                 # 72e
        lnop                                            # 72o pairing
        fma     $b_12,$cy_3,$dy_4,$b_13                 # 73e
        frsqest $y_3,$disc_5                            # 73o
        fi      $y_2,$disc,$y_2                         # 74e
        fnms    $disc_7,$lz,$lz,$disc_4                 # 76e
        fi      $y_4,$disc_5,$y_3                       # 77e
        fma     $b_14,$cy_3,$dy_3,$b_14                 # 79e
        fma     $b_16,$cz_3,$dz_6,$b_15                 # 80e
        fnms    $t_2,$disc,$y_2,$b_9                    # 81e
        fnms    $disc_8,$lz_4,$lz_4,$disc_6             # 82e
        frsqest $y_5,$disc_7                            # 82o
        fma     $b_15,$cy_3,$dy_6,$b_5                  # 83e
        fnms    $t_3,$disc_5,$y_4,$b_10                 # 84e
        fma     $b_10,$cz_3,$dz_3,$b_12                 # 85e
        fnms    $lx_6,$b_16,$dx_3,$cx_3                 # 86e
        clgt    $hit_2,$t_best_2,$t_2                   # 87e
        lnop                                            # 87o pairing
        fnms    $ly_6,$b_16,$dy_2,$cy_3                 # 88e
        frsqest $y_6,$disc_8                            # 88o
        andc    $hit_3,$hit_2,$disc                     # 89e
        clgt    $hit_2,$t_best_3,$t_3                   # 90e
        fnms    $lx_7,$b_10,$dx_6,$cx_3                 # 91e
        andc    $hit_2,$hit_2,$disc_5                   # 92e
        fnms    $disc_4,$lx_6,$lx_6,$radius2_3          # 93e
        rotmai  $hit_2,$hit_2,-31                       # 94e
        fnms    $lz_5,$b_10,$dz_3,$cz_3                 # 95e
        fnms    $ly_7,$b_10,$dy_4,$cy_3                 # 96e
        fnms    $disc_9,$lx_7,$lx_7,$radius2_3          # 97e
        fnms    $lz_6,$b_16,$dz_6,$cz_3                 # 98e
        fnms    $disc_4,$ly_6,$ly_6,$disc_4             # 99e
        fi      $y_7,$disc_8,$y_6                       # 100e
        selb    $nearest_3,$nearest_3,$object_4,$hit_2  # 101e
        rotmai  $hit_3,$hit_3,-31                       # 102e
        fnms    $disc_9,$ly_7,$ly_7,$disc_9             # 103e
        stqd    $nearest_3,256($a_packet_6)             # 103o
        fi      $y_8,$disc_7,$y_5                       # 104e
        selb    $t_best_3,$t_best_3,$t_3,$hit_2         # 105e
        selb    $nearest_2,$nearest_2,$object_4,$hit_3  # 106e
        selb    $t_best_5,$t_best_2,$t_2,$hit_3         # 107e
        fnms    $t,$disc_8,$y_7,$b                      # 108e
        stqd    $nearest_2,272($a_packet_6)             # 108o
        fma     $b,$cz_3,$dz_7,$b_14                    # 109e
        stqd    $t_best_3,192($a_packet_6)              # 109o
        fnms    $disc_10,$lz_5,$lz_5,$disc_9            # 110e
        stqd    $t_best_5,208($a_packet_6)              # 110o
        fnms    $t_4,$disc_7,$y_8,$b_11                 # 111e
        lqd     $object_2,0($a_pair_3)                  # 111o
        fma     $b_17,$cz_3,$dz_8,$b_15                 # 112e
        lqd     $nearest_2,272($a_packet_3)             # 112o
        fnms    $disc_4,$lz_6,$lz_6,$disc_4             # 113e
        lqd     $t_best_2,208($a_packet_3)              # 113o
        clgt    $hit_4,$t_best_4,$t                     # 114e
        lqd     $t_best_3,192($a_packet_3)              # 114o
        fnms    $ly,$b,$dy_3,$cy_3                      # 115e
        lqd     $nearest_5,256($a_packet_3)             # 115o
        fnms    $lx,$b,$dx_8,$cx_3                      # 116e
        frsqest $y_9,$disc_10                           # 116o
        clgt    $hit,$t_best,$t_4                       # 117e
        rotqbyi $a_packet_2,$object_2,4                 # 117o
        fnms    $ly_8,$b_17,$dy_6,$cy_3                 # 118e
        lqd     $quad_3,0($object_2)                    # 118o
        fnms    $lx_8,$b_17,$dx_7,$cx_3                 # 119e
        frsqest $y,$disc_4                              # 119o
        fnms    $lz_7,$b_17,$dz_8,$cz_3                 # 120e
        lnop                                            # 120o pairing
        fi      $y_9,$disc_10,$y_9                      # 121e
        lqd     $dx_2,0($a_packet_2)                    # 121o
        andc    $hit,$hit,$disc_7                       # 122e
        lqd     $dx_9,16($a_packet_2)                   # 122o
        fnms    $disc_11,$lx,$lx,$radius2_3             # 123e
        lqd     $dx_4,32($a_packet_2)                   # 123o
        fi      $y,$disc_4,$y                           # 124e
        shufb   $cx_2,$quad_3,$quad_3,$m_x              # 124o
        andc    $hit_4,$hit_4,$disc_8                   # 125e
        shufb   $cy_2,$quad_3,$quad_3,$m_y              # 125o
        fnms    $disc_12,$lx_8,$lx_8,$radius2_3         # 126e
        hbrr    next_pair_back,next_pair                # 126o hint
        fnms    $lz_4,$b,$dz_7,$cz_3                    # 127e
        lqd     $dx_5,48($a_packet_2)                   # 127o
        fm      $b_2,$cx_2,$dx_9                        # 128e
        lqd     $dy_2,80($a_packet_2)                   # 128o
        fm      $b_3,$cx_2,$dx_2                        # 129e
        rotqbii $hit,$hit,1                             # 129o
        fm      $b_5,$cx_2,$dx_4                        # 130e
        shufb   $cz_2,$quad_3,$quad_3,$m_z              # 130o
        fnms    $disc_11,$ly,$ly,$disc_11               # 131e
        lqd     $dy_3,112($a_packet_2)                  # 131o
        fnms    $disc_9,$ly_8,$ly_8,$disc_12            # 132e
        lqd     $dz_2,144($a_packet_2)                  # 132o
        fm      $b_8,$cx_2,$dx_5                        # 133e
        lqd     $dy_4,64($a_packet_2)                   # 133o
        fma     $b_9,$cy_2,$dy_2,$b_2                   # 134e
        rotqbii $hit_4,$hit_4,1                         # 134o
        fnms    $t_5,$disc_4,$y,$b_16                   # 135e
        gb      $hit_5,$hit                             # 135o
        fnms    $t_3,$disc_10,$y_9,$b_10                # 136e
        lqd     $dy_6,96($a_packet_2)                   # 136o
        fnms    $disc_8,$lz_4,$lz_4,$disc_11            # 137e
        lqd     $dz_3,128($a_packet_2)                  # 137o
        fnms    $disc_7,$lz_7,$lz_7,$disc_9             # 138e
        gb      $hit,$hit_4                             # 138o
        fma     $b_7,$cy_2,$dy_4,$b_3                   # 139e
        shlqbii $hit_4,$hit_5,4                         # 139o
        fma     $b_8,$cy_2,$dy_3,$b_8                   # 140e
        shufb   $radius2_3,$quad_3,$quad_3,$m_radius2   # 140o
        fma     $b_9,$cz_2,$dz_2,$b_9                   # 141e
        lqd     $dz_4,176($a_packet_2)                  # 141o
        fma     $b_4,$cy_2,$dy_6,$b_5                   # 142e
        shlqbii $hit,$hit,4                             # 142o
        clgt    $hit_6,$t_best_3,$t_3                   # 143e
        lqx     $merge_2,$a_merges,$hit_4               # 143o
        nop     $127                                    # 144e pairing
        frsqest $y_10,$disc_7                           # 144o
        fma     $b_10,$cz_2,$dz_3,$b_7                  # 145e
        lqd     $dz_9,160($a_packet_2)                  # 145o
        andc    $hit_7,$hit_6,$disc_10                  # 146e
        lqx     $merge_3,$a_merges,$hit                 # 146o
        fnms    $lx_2,$b_9,$dx_9,$cx_2                  # 147e
        lnop                                            # 147o pairing
next_pair:
            clgt    $hit,$t_best_2,$t_5                 # 0e
            shufb   $t_best,$t_best,$t_4,$merge_2       # 0o
            rotmai  $hit_7,$hit_7,-31                   # 1e
            shufb   $nearest,$nearest,$object_5,$merge_2 # 1o
            fnms    $lx,$b_10,$dx_2,$cx_2               # 2e
            frsqest $y,$disc_8                          # 2o
            fnms    $ly,$b_9,$dy_2,$cy_2                # 3e
            shufb   $t_best_5,$t_best_4,$t,$merge_3     # 3o
            fnms    $disc,$lx_2,$lx_2,$radius2_3        # 4e
            shufb   $nearest_6,$nearest_4,$object_5,$merge_3 # 4o
            fnms    $lz,$b_10,$dz_3,$cz_2               # 5e
            stqd    $t_best,224($a_packet_7)            # 5o
            fnms    $ly_9,$b_10,$dy_4,$cy_2             # 6e
            stqd    $nearest,288($a_packet_7)           # 6o
            andc    $hit,$hit,$disc_4                   # 7e
            stqd    $t_best_5,240($a_packet_7)          # 7o
            fnms    $disc_13,$lx,$lx,$radius2_3         # 8e
            lqd     $nearest,288($a_packet_5)           # 8o
            fnms    $lz_8,$b_9,$dz_2,$cz_2              # 9e
            stqd    $nearest_6,304($a_packet_7)         # 9o
            fnms    $disc,$ly,$ly,$disc                 # 10e
            shlqbyi $a_packet_7,$a_packet_4,0           # 10o copy
            fi      $y,$disc_8,$y                       # 11e
            lqd     $t_best_4,240($a_packet_5)          # 11o
            selb    $nearest_5,$nearest_5,$object_6,$hit_7 # 12e
            lqd     $t_best,224($a_packet_5)            # 12o
            rotmai  $hit,$hit,-31                       # 13e
            lqd     $nearest_4,304($a_packet_5)         # 13o
            fnms    $disc_13,$ly_9,$ly_9,$disc_13       # 14e
            shlqbyi $a_packet_4,$a_packet_2,0           # 14o copy
            fi      $y_11,$disc_7,$y_10                 # 15e
            shlqbyi $a_packet_5,$a_packet_2,0           # 15o copy
            selb    $t_best_6,$t_best_3,$t_3,$hit_7     # 16e
            shlqbyi $object_5,$object_6,0               # 16o copy
            selb    $nearest_2,$nearest_2,$object_6,$hit # 17e
            shufb   $object_6,$object_2,$object_2,$m_x  # 17o
            selb    $t_best_7,$t_best_2,$t_5,$hit       # 18e
            stqd    $nearest_5,256($a_packet_8)         # 18o
            fnms    $t,$disc_8,$y,$b                    # 19e
            stqd    $nearest_2,272($a_packet_8)         # 19o
            fma     $b,$cz_2,$dz_4,$b_8                 # 20e
            stqd    $t_best_6,192($a_packet_8)          # 20o
            fnms    $disc_10,$lz,$lz,$disc_13           # 21e
            stqd    $t_best_7,208($a_packet_8)          # 21o
            fnms    $t_4,$disc_7,$y_11,$b_17            # 22e
        lqd     $object_2,0($a_pair)                    # 22o
            fma     $b_17,$cz_2,$dz_9,$b_4              # 23e
            lqd     $nearest_2,272($a_packet_2)         # 23o
        ai      $a_pair,$a_pair,16                      # 24e
            shlqbyi $a_packet_8,$a_packet_2,0           # 24o copy
            fnms    $disc_4,$lz_8,$lz_8,$disc           # 25e
            lqd     $t_best_2,208($a_packet_2)          # 25o
            fnms    $ly,$b,$dy_3,$cy_2                  # 26e
            lqd     $t_best_3,192($a_packet_2)          # 26o
            fnms    $lx,$b,$dx_5,$cx_2                  # 27e
            lqd     $nearest_5,256($a_packet_2)         # 27o
            clgt    $hit,$t_best_4,$t                   # 28e
        rotqbyi $a_packet_2,$object_2,4                 # 28o
            clgt    $hit_4,$t_best,$t_4                 # 29e
        lqd     $quad_2,0($object_2)                    # 29o
            fnms    $ly_10,$b_17,$dy_6,$cy_2            # 30e
            frsqest $y,$disc_10                         # 30o
            fnms    $lx_8,$b_17,$dx_4,$cx_2             # 31e
            frsqest $y_12,$disc_4                       # 31o
            fnms    $lz_9,$b_17,$dz_9,$cz_2             # 32e
            lnop                                        # 32o pairing
            fnms    $disc_11,$lx,$lx,$radius2_3         # 33e
        lqd     $dx_2,0($a_packet_2)                    # 33o
            fi      $y,$disc_10,$y                      # 34e
        lqd     $dx_3,16($a_packet_2)                   # 34o
            fi      $y_12,$disc_4,$y_12                 # 35e
        lqd     $dx_4,32($a_packet_2)                   # 35o
            andc    $hit_4,$hit_4,$disc_7               # 36e
        shufb   $cx_2,$quad_2,$quad_2,$m_x              # 36o
            fnms    $disc_12,$lx_8,$lx_8,$radius2_3     # 37e
        shufb   $cy_2,$quad_2,$quad_2,$m_y              # 37o
            andc    $hit,$hit,$disc_8                   # 38e
        lqd     $dx_5,48($a_packet_2)                   # 38o
            fnms    $lz_4,$b,$dz_4,$cz_2                # 39e
        lqd     $dy_2,80($a_packet_2)                   # 39o
        fm      $b_2,$cx_2,$dx_3                        # 40e
            rotqbii $hit_4,$hit_4,1                     # 40o
        fm      $b_3,$cx_2,$dx_2                        # 41e
        shufb   $cz_2,$quad_2,$quad_2,$m_z              # 41o
        fm      $b_4,$cx_2,$dx_4                        # 42e
        lqd     $dy_3,112($a_packet_2)                  # 42o
            fnms    $disc,$ly_10,$ly_10,$disc_12        # 43e
        lqd     $dz_2,144($a_packet_2)                  # 43o
        fm      $b_5,$cx_2,$dx_5                        # 44e
        lqd     $dy_4,64($a_packet_2)                   # 44o
            fnms    $disc_11,$ly,$ly,$disc_11           # 45e
            rotqbii $hit,$hit,1                         # 45o
        fma     $b_6,$cy_2,$dy_2,$b_2                   # 46e
            gb      $hit_4,$hit_4                       # 46o
            fnms    $t_5,$disc_4,$y_12,$b_9             # 47e
        lqd     $dy_6,96($a_packet_2)                   # 47o
            fnms    $t_3,$disc_10,$y,$b_10              # 48e
        lqd     $dz_3,128($a_packet_2)                  # 48o
            fnms    $disc_7,$lz_9,$lz_9,$disc           # 49e
            gb      $hit,$hit                           # 49o
        fma     $b_7,$cy_2,$dy_4,$b_3                   # 50e
            shlqbii $hit_4,$hit_4,4                     # 50o
        fma     $b_8,$cy_2,$dy_3,$b_5                   # 51e
        shufb   $radius2_3,$quad_2,$quad_2,$m_radius2   # 51o
        fma     $b_9,$cz_2,$dz_2,$b_6                   # 52e
        lnop                                            # 52o pairing
            fnms    $disc_8,$lz_4,$lz_4,$disc_11        # 53e
            shlqbii $hit,$hit,4                         # 53o
        fma     $b_4,$cy_2,$dy_6,$b_4                   # 54e
            lqx     $merge_2,$a_merges,$hit_4           # 54o
            clgt    $hit_6,$t_best_3,$t_3               # 55e
            frsqest $y_10,$disc_7                       # 55o
        fma     $b_10,$cz_2,$dz_3,$b_7                  # 56e
        lqd     $dz_4,176($a_packet_2)                  # 56o
        ai      $count,$count,-1                        # 57e
            lqx     $merge_3,$a_merges,$hit             # 57o
        fnms    $lx_2,$b_9,$dx_3,$cx_2                  # 58e
        lqd     $dz_9,160($a_packet_2)                  # 58o
            andc    $hit_7,$hit_6,$disc_10              # 59e
next_pair_back:
        brnz    $count,next_pair                        # 59o
next_pair_drain:
        fi      $y_13,$disc_7,$y_10                     # 0e
        shufb   $t_best,$t_best,$t_4,$merge_2           # 0o
        clgt    $hit,$t_best_2,$t_5                     # 1e
        frsqest $y,$disc_8                              # 1o
        fma     $b_18,$cz_2,$dz_9,$b_4                  # 2e
        shufb   $nearest,$nearest,$object_5,$merge_2    # 2o
        fma     $b_19,$cz_2,$dz_4,$b_8                  # 3e
        shufb   $t_best_4,$t_best_4,$t,$merge_3         # 3o
        fnms    $lx,$b_10,$dx_2,$cx_2                   # 4e
        shufb   $nearest_7,$nearest_4,$object_5,$merge_3 # 4o
        fi      $y,$disc_8,$y                           # 5e
        stqd    $t_best,224($a_packet_7)                # 5o
        andc    $hit,$hit,$disc_4                       # 6e
        stqd    $nearest,288($a_packet_7)               # 6o
        fnms    $t_6,$disc_7,$y_13,$b_17                # 7e
        stqd    $t_best_4,240($a_packet_7)              # 7o
        fnms    $lx_5,$b_18,$dx_4,$cx_2                 # 8e
        lqd     $nearest,288($a_packet_5)               # 8o
        fnms    $lx_6,$b_19,$dx_5,$cx_2                 # 9e
        stqd    $nearest_7,304($a_packet_7)             # 9o
        fnms    $ly_9,$b_18,$dy_6,$cy_2                 # 10e
        lqd     $t_best,224($a_packet_5)                # 10o
        fnms    $ly_11,$b_10,$dy_4,$cy_2                # 11e
        lqd     $t_best_8,240($a_packet_5)              # 11o
        fnms    $t,$disc_8,$y,$b                        # 12e
        lqd     $nearest_4,304($a_packet_5)             # 12o
        fnms    $disc_14,$lx,$lx,$radius2_3             # 13e
        shlqbyi $object_5,$object_6,0                   # 13o copy
        fnms    $disc_15,$lx_5,$lx_5,$radius2_3         # 14e
        shlqbyi $a_packet_9,$a_packet_4,0               # 14o copy
        fnms    $ly,$b_19,$dy_3,$cy_2                   # 15e
        shlqbyi $a_packet_5,$a_packet_2,0               # 15o copy
        clgt    $hit_8,$t_best,$t_6                     # 16e
        shufb   $object_7,$object_2,$object_2,$m_x      # 16o
        fnms    $disc_11,$lx_6,$lx_6,$radius2_3         # 17e
        shlqbyi $a_packet_10,$a_packet_2,0              # 17o copy
        clgt    $hit_9,$t_best_8,$t                     # 18e
        hbr     isect_pairs_interpolated_r16_return,$lr # 18o hint
        andc    $hit_8,$hit_8,$disc_7                   # 19e
        shlqbyi $a_packet_11,$a_packet_2,0              # 19o copy
        andc    $hit_9,$hit_9,$disc_8                   # 20e
        shlqbyi $object_8,$object_7,0                   # 20o copy
        fnms    $ly_12,$b_9,$dy_2,$cy_2                 # 21e
        rotqbii $hit_8,$hit_8,1                         # 21o
        fnms    $disc,$lx_2,$lx_2,$radius2_3            # 22e
        rotqbii $hit_9,$hit_9,1                         # 22o
        rotmai  $hit_7,$hit_7,-31                       # 23e
        shlqbyi $a_packet_11,$a_packet_11,0             # 23o copy
        rotmai  $hit,$hit,-31                           # 24e
        lnop                                            # 24o pairing
        fnms    $lz_9,$b_18,$dz_9,$cz_2                 # 25e
        gb      $hit_8,$hit_8                           # 25o
        fnms    $disc_15,$ly_9,$ly_9,$disc_15           # 26e
        gb      $hit_4,$hit_9                           # 26o
        fnms    $lz_10,$b_10,$dz_3,$cz_2                # 27e
        selb    $nearest_5,$nearest_5,$object_6,$hit_7  # 28e
        fnms    $disc_16,$ly_11,$ly_11,$disc_14         # 29e
        shlqbii $hit_10,$hit_8,4                        # 29o
        fnms    $lz_4,$b_19,$dz_4,$cz_2                 # 30e
        stqd    $nearest_5,256($a_packet_8)             # 30o
        fnms    $disc_11,$ly,$ly,$disc_11               # 31e
        shlqbii $hit_4,$hit_4,4                         # 31o
        fnms    $lz_11,$b_9,$dz_2,$cz_2                 # 32e
        fnms    $disc,$ly_12,$ly_12,$disc               # 33e
        selb    $nearest_2,$nearest_2,$object_6,$hit    # 34e
        selb    $t_best_6,$t_best_3,$t_3,$hit_7         # 35e
        selb    $t_best_9,$t_best_2,$t_5,$hit           # 36e
        stqd    $nearest_2,272($a_packet_8)             # 36o
        fnms    $disc_7,$lz_9,$lz_9,$disc_15            # 37e
        stqd    $t_best_6,192($a_packet_8)              # 37o
        fnms    $disc_10,$lz_10,$lz_10,$disc_16         # 38e
        stqd    $t_best_9,208($a_packet_8)              # 38o
        fnms    $disc_8,$lz_4,$lz_4,$disc_11            # 39e
        lqx     $merge_4,$a_merges,$hit_10              # 39o
        fnms    $disc_16,$lz_11,$lz_11,$disc            # 40e
        lqx     $merge_3,$a_merges,$hit_4               # 40o
        lqd     $nearest_2,272($a_packet_2)             # 41o
        lqd     $t_best_2,208($a_packet_2)              # 42o
        frsqest $y_10,$disc_7                           # 43o
        frsqest $y,$disc_10                             # 44o
        shufb   $t_best,$t_best,$t_6,$merge_4           # 45o
        frsqest $y_13,$disc_8                           # 46o
        fi      $y_11,$disc_7,$y_10                     # 47e
        frsqest $y_12,$disc_16                          # 47o
        fi      $y,$disc_10,$y                          # 48e
        shufb   $nearest,$nearest,$object_5,$merge_4    # 48o
        nop     $127                                    # 49e pairing
        shufb   $t_best_4,$t_best_8,$t,$merge_3         # 49o
        fi      $y_13,$disc_8,$y_13                     # 50e
        lqd     $t_best_3,192($a_packet_2)              # 50o
        fi      $y_12,$disc_16,$y_12                    # 51e
        lqd     $nearest_5,256($a_packet_2)             # 51o
        shufb   $nearest_8,$nearest_4,$object_5,$merge_3 # 52o
        stqd    $t_best,224($a_packet_9)                # 53o
        fnms    $t_7,$disc_7,$y_11,$b_18                # 54e
        stqd    $nearest,288($a_packet_9)               # 54o
        fnms    $t_3,$disc_10,$y,$b_10                  # 55e
        stqd    $t_best_4,240($a_packet_9)              # 55o
        nop     $127                                    # 56e pairing
        lqd     $nearest,288($a_packet_5)               # 56o
        fnms    $t,$disc_8,$y_13,$b_19                  # 57e
        stqd    $nearest_8,304($a_packet_9)             # 57o
        fnms    $t_5,$disc_16,$y_12,$b_9                # 58e
        lqd     $t_best,224($a_packet_5)                # 58o
        lqd     $t_best_4,240($a_packet_5)              # 59o
        lqd     $nearest_4,304($a_packet_5)             # 60o
        clgt    $hit_6,$t_best_3,$t_3                   # 61e
        andc    $hit_7,$hit_6,$disc_10                  # 63e
        clgt    $hit_4,$t_best,$t_7                     # 64e
        clgt    $hit,$t_best_4,$t                       # 65e
        andc    $hit_4,$hit_4,$disc_7                   # 66e
        clgt    $hit_11,$t_best_2,$t_5                  # 67e
        andc    $hit,$hit,$disc_8                       # 68e
        rotqbii $hit_4,$hit_4,1                         # 68o
        andc    $hit_11,$hit_11,$disc_16                # 69e
        lnop                                            # 69o pairing
        rotmai  $hit_7,$hit_7,-31                       # 70e
        rotqbii $hit,$hit,1                             # 70o
        rotmai  $hit_11,$hit_11,-31                     # 71e
        gb      $hit_4,$hit_4                           # 72o
        selb    $nearest_5,$nearest_5,$object_7,$hit_7  # 74e
        gb      $hit,$hit                               # 74o
        selb    $nearest_2,$nearest_2,$object_7,$hit_11 # 75e
        lnop                                            # 75o pairing
        selb    $t_best_6,$t_best_3,$t_3,$hit_7         # 76e
        stqd    $nearest_5,256($a_packet_10)            # 76o
        selb    $t_best_7,$t_best_2,$t_5,$hit_11        # 77e
        shlqbii $hit_4,$hit_4,4                         # 77o
        stqd    $nearest_2,272($a_packet_10)            # 78o
        stqd    $t_best_6,192($a_packet_10)             # 79o
        shlqbii $hit,$hit,4                             # 80o
        stqd    $t_best_7,208($a_packet_10)             # 81o
        lqx     $merge_2,$a_merges,$hit_4               # 82o
        lqx     $merge_3,$a_merges,$hit                 # 84o
        shufb   $t_best,$t_best,$t_7,$merge_2           # 88o
        shufb   $nearest,$nearest,$object_8,$merge_2    # 89o
        shufb   $t_best_5,$t_best_4,$t,$merge_3         # 90o
        shufb   $nearest_6,$nearest_4,$object_8,$merge_3 # 91o
        stqd    $t_best,224($a_packet_11)               # 92o
        stqd    $nearest,288($a_packet_11)              # 93o
        stqd    $t_best_5,240($a_packet_11)             # 94o
        stqd    $nearest_6,304($a_packet_11)            # 95o
        nop     $127                                    # 96e pairing
isect_pairs_interpolated_r16_return:
        bi      $lr                                     # 96o
next_pair_short:
        ai      $count,$count,-1                        # 0e
        lqd     $object,0($a_pair)                      # 0o
        ai      $a_pair,$a_pair,16                      # 1e
        rotqbyi $a_packet,$object,4                     # 6o
        lqd     $quad,0($object)                        # 7o
        shufb   $object,$object,$object,$m_x            # 8o
        lqd     $dx,32($a_packet)                       # 10o
        lqd     $dx_10,48($a_packet)                    # 11o
        lqd     $dy,96($a_packet)                       # 12o
        shufb   $cx,$quad,$quad,$m_x                    # 13o
        lqd     $dy_7,112($a_packet)                    # 14o
        shufb   $cy,$quad,$quad,$m_y                    # 15o
        nop     $127                                    # 16e pairing
        lqd     $dz,160($a_packet)                      # 16o
        fm      $b,$cx,$dx                              # 17e
        lqd     $dz_10,176($a_packet)                   # 17o
        fm      $b_20,$cx,$dx_10                        # 18e
        shufb   $cz,$quad,$quad,$m_z                    # 18o
        lqd     $dx_11,0($a_packet)                     # 19o
        lqd     $dx_12,16($a_packet)                    # 20o
        lqd     $dy_8,64($a_packet)                     # 21o
        lqd     $dy_9,80($a_packet)                     # 22o
        fma     $b,$cy,$dy,$b                           # 23e
        shufb   $radius2_4,$quad,$quad,$m_radius2       # 23o
        fma     $b_20,$cy,$dy_7,$b_20                   # 24e
        lqd     $dz_11,128($a_packet)                   # 24o
        fm      $b_11,$cx,$dx_11                        # 25e
        lqd     $dz_12,144($a_packet)                   # 25o
        fm      $b_16,$cx,$dx_12                        # 26e
        lqd     $t_best_10,224($a_packet)               # 26o
        lqd     $t_best_11,240($a_packet)               # 27o
        lqd     $t_best_12,192($a_packet)               # 28o
        fma     $b,$cz,$dz,$b                           # 29e
        lqd     $t_best_13,208($a_packet)               # 29o
        fma     $b_20,$cz,$dz_10,$b_20                  # 30e
        lqd     $nearest_9,288($a_packet)               # 30o
        fma     $b_11,$cy,$dy_8,$b_11                   # 31e
        lqd     $nearest_10,304($a_packet)              # 31o
        fma     $b_16,$cy,$dy_9,$b_16                   # 32e
        lqd     $nearest_11,256($a_packet)              # 32o
        lqd     $nearest_12,272($a_packet)              # 33o
        fnms    $lx_9,$b,$dx,$cx                        # 35e
        fnms    $lx_10,$b_20,$dx_10,$cx                 # 36e
        fnms    $ly_13,$b,$dy,$cy                       # 37e
        fnms    $ly_14,$b_20,$dy_7,$cy                  # 38e
        fma     $b_11,$cz,$dz_11,$b_11                  # 39e
        fma     $b_16,$cz,$dz_12,$b_16                  # 40e
        fnms    $disc_17,$lx_9,$lx_9,$radius2_4         # 41e
        fnms    $disc_10,$lx_10,$lx_10,$radius2_4       # 42e
        fnms    $lz_3,$b,$dz,$cz                        # 43e
        fnms    $lz_12,$b_20,$dz_10,$cz                 # 44e
        fnms    $lx_6,$b_11,$dx_11,$cx                  # 45e
        fnms    $lx_11,$b_16,$dx_12,$cx                 # 46e
        fnms    $disc_18,$ly_13,$ly_13,$disc_17         # 47e
        fnms    $disc_10,$ly_14,$ly_14,$disc_10         # 48e
        fnms    $ly_14,$b_11,$dy_8,$cy                  # 49e
        fnms    $ly_15,$b_16,$dy_9,$cy                  # 50e
        fnms    $disc_4,$lx_6,$lx_6,$radius2_4          # 51e
        fnms    $disc_16,$lx_11,$lx_11,$radius2_4       # 52e
        fnms    $disc_19,$lz_3,$lz_3,$disc_18           # 53e
        fnms    $disc_10,$lz_12,$lz_12,$disc_10         # 54e
        fnms    $lz_12,$b_11,$dz_11,$cz                 # 55e
        fnms    $lz_13,$b_16,$dz_12,$cz                 # 56e
        fnms    $disc_13,$ly_14,$ly_14,$disc_4          # 57e
        fnms    $disc_4,$ly_15,$ly_15,$disc_16          # 58e
        frsqest $y_14,$disc_19                          # 59o
        frsqest $y_15,$disc_10                          # 60o
        fi      $y_14,$disc_19,$y_14                    # 63e
        fi      $y_15,$disc_10,$y_15                    # 64e
        fnms    $disc_13,$lz_12,$lz_12,$disc_13         # 66e
        fnms    $disc_15,$lz_13,$lz_13,$disc_4          # 67e
        fnms    $t_8,$disc_19,$y_14,$b                  # 70e
        fnms    $t_9,$disc_10,$y_15,$b_20               # 71e
        frsqest $y_14,$disc_13                          # 72o
        frsqest $y_16,$disc_15                          # 73o
        clgt    $hit_12,$t_best_10,$t_8                 # 76e
        clgt    $hit_13,$t_best_11,$t_9                 # 77e
        andc    $hit_8,$hit_12,$disc_19                 # 78e
        andc    $hit_7,$hit_13,$disc_10                 # 79e
        lnop                                            # 79o pairing
        fi      $y_14,$disc_13,$y_14                    # 80e
        rotqbii $hit_8,$hit_8,1                         # 80o
        fi      $y_16,$disc_15,$y_16                    # 81e
        rotqbii $hit_7,$hit_7,1                         # 81o
        gb      $hit_8,$hit_8                           # 84o
        gb      $hit_7,$hit_7                           # 85o
        fnms    $t_10,$disc_13,$y_14,$b_11              # 87e
        lnop                                            # 87o pairing
        fnms    $t_11,$disc_15,$y_16,$b_16              # 88e
        shlqbii $hit_8,$hit_8,4                         # 88o
        shlqbii $hit_7,$hit_7,4                         # 89o
        lqx     $merge_5,$a_merges,$hit_8               # 92o
        clgt    $hit_12,$t_best_12,$t_10                # 93e
        lqx     $merge_6,$a_merges,$hit_7               # 93o
        clgt    $hit_13,$t_best_13,$t_11                # 94e
        andc    $hit_14,$hit_12,$disc_13                # 95e
        andc    $hit_15,$hit_13,$disc_15                # 96e
        rotmai  $hit_14,$hit_14,-31                     # 97e
        rotmai  $hit_15,$hit_15,-31                     # 98e
        shufb   $t_best,$t_best_10,$t_8,$merge_5        # 98o
        shufb   $nearest,$nearest_9,$object,$merge_5    # 99o
        shufb   $t_best_14,$t_best_11,$t_9,$merge_6     # 100o
        selb    $t_best_15,$t_best_12,$t_10,$hit_14     # 101e
        shufb   $nearest_13,$nearest_10,$object,$merge_6 # 101o
        selb    $nearest_14,$nearest_11,$object,$hit_14 # 102e
        stqd    $t_best,224($a_packet)                  # 102o
        selb    $t_best,$t_best_13,$t_11,$hit_15        # 103e
        stqd    $t_best_15,192($a_packet)               # 103o
        selb    $nearest_6,$nearest_12,$object,$hit_15  # 104e
        stqd    $nearest_14,256($a_packet)              # 104o
        stqd    $t_best,208($a_packet)                  # 105o
        stqd    $nearest_6,272($a_packet)               # 106o
        stqd    $nearest,288($a_packet)                 # 107o
        stqd    $t_best_14,240($a_packet)               # 108o
        stqd    $nearest_13,304($a_packet)              # 109o
        brnz    $count,next_pair_short                  # 110o
        nop     $127                                    # 111e pairing
        bi      $lr                                     # 111o
endfunction isect_pairs_interpolated_r16
