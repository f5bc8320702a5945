# isect_pairs_constants_r16   nearest entries of primary rays into spheres, by their direction
#   C       void isect_pairs_constants_r16(const struct pair *, int count);
#   In      $3 pairs, $4 count (0 is none); pointers 16-aligned
#   Out     the pairs' packets: t, object, where an entry is nearer than what was there
#   Uses    $2-$61, $79   Saves  -   Stack  0   Calls  -
#   Domain  |d| and |axis| = 1 within 4 ulp; distance and radius from 2^-40 to 2^62
#   Error   3.5 ulp of t, eye 2 to 1e6 radii from the centre, ray within 0.9 r of it
#   Twin    lab/twins/src/sphere/constants.rs
#
# The steps are in sphere_tmpl.inc. An opaque sphere has no inside, so only the entry counts, and
# only if it is in front of the eye. The record has the unit direction in place of the centre, and
# the squared radius relative to the square of the distance.
# Scheduled by spu schedule from isect_pairs_constants_r16.s

        .include "sphere_eye.inc"
        .include "sphere_constants.inc"

        eye_registers "k_one,k_quarter,half,whole", "radius2,distance", "lx,ly,lz,chord,disc,y,s,e"
        merges_table

function isect_pairs_constants_r16
        .set count_2,79; .set a_pair_2,2; .set object_2,6; .set object_3,5; .set a_packet_2,2
        .set quad_2,22; .set quad_3,7; .set a_packet_3,24; .set dy_2,33; .set dx_2,21; .set cy_2,30
        .set cz_2,44; .set cx_2,23; .set dy_3,38; .set dx_3,34; .set dz_2,35; .set lx_2,21
        .set lx_3,27; .set radius2_2,8; .set dx_4,9; .set ly_2,38; .set dy_4,19; .set lx_4,34
        .set dz_3,20; .set lz_2,35; .set dy_5,41; .set chord_2,21; .set dz_4,43; .set chord_3,22
        .set dx_5,25; .set lz_3,29; .set dy_6,27; .set lx_5,9; .set chord_4,34; .set dx_6,26
        .set ly_3,28; .set cz_3,39; .set cy_3,41; .set dx_7,33; .set ly_4,19; .set dz_5,30
        .set chord_5,9; .set dz_6,32; .set lz_4,20; .set lz_5,43; .set a_packet_4,36
        .set a_packet_5,21; .set radius2_3,45; .set quad_4,19; .set dy_7,29; .set lx_6,28
        .set t_best_2,47; .set lx_7,25; .set nearest_2,44; .set disc_2,37; .set a_packet_6,7
        .set disc_3,40; .set chord_6,20; .set chord_7,46; .set dz_7,42; .set chord_8,6
        .set t_best_3,9; .set disc_4,2; .set disc_5,58; .set dy_8,35; .set disc_6,28
        .set a_packet_7,57; .set dx_8,40; .set chord_9,25; .set object_4,51; .set nearest_3,48
        .set ly_5,27; .set y_2,49; .set lz_6,52; .set y_3,53; .set nearest_4,54; .set disc_7,32
        .set t_best_4,55; .set t_best_5,50; .set y_4,8; .set a_packet_8,56; .set a_packet_9,53
        .set y_5,25; .set lz_7,27; .set y_6,30; .set s_2,36; .set s_3,49; .set y_7,59; .set e_2,37
        .set e_3,8; .set lx_8,60; .set disc_8,33; .set s_4,25; .set lx_9,23; .set s_5,61
        .set disc_9,52; .set e_4,33; .set chord_10,36; .set e_5,34; .set t_2,49; .set lz_8,33
        .set disc_10,38; .set hit_2,8; .set hit_3,2; .set e_6,20; .set hit_4,29; .set ly_6,23
        .set hit_5,21; .set hit_6,27; .set chord_11,2; .set y_8,6; .set t_3,8; .set disc_11,23
        .set nearest_5,25; .set hit_7,6; .set s_6,42; .set e_7,27; .set y_9,46; .set merge_2,6
        .set dz_8,33; .set dy_9,21; .set t_best_6,6; .set s_7,8; .set merge_3,38; .set disc_12,6
        .set ly_7,21; .set hit_8,48; .set nearest_6,50; .set t_best_7,29; .set hit_9,20
        .set e_8,38; .set lx_10,6; .set disc_13,27; .set a_packet_10,4; .set hit_10,7
        .set quad_5,20; .set chord_12,27; .set dx_9,29; .set cx_3,30; .set e_9,6; .set merge_4,3
        .set dy_10,7; .set chord_13,23; .set dz_9,36; .set t_best_8,3; .set cy_4,8; .set merge_5,15
        .set ly_8,22; .set ly_9,3; .set dx_10,7; .set t_4,6; .set lx_11,7; .set nearest_7,16
        .set nearest_8,20; .set hit_11,22; .set ly_10,8; .set chord_14,7; .set disc_14,15
        .set e_10,23; .set a_packet_11,29; .set distance_2,15; .set a_packet_12,3; .set disc_15,14
        .set hit_12,17; .set y_10,21; .set e_11,25; .set object_5,33; .set t_5,17; .set hit_13,11
        .set chord_15,4; .set e_12,7; .set chord_16,11; .set e_13,4; .set t_best_9,2; .set t_6,4
        .set t_7,2; .set t_best_10,7; .set quad_6,2; .set dx_11,5; .set dx_12,6; .set dy_11,8
        .set lx_12,5; .set dz_10,9; .set dz_11,24; .set cz_4,25; .set chord_17,5; .set dz_12,26
        .set ly_11,7; .set radius2_4,21; .set distance_3,2; .set lz_9,9; .set t_best_11,31
        .set lz_10,24; .set t_best_12,32; .set nearest_9,8; .set nearest_10,7; .set lx_13,22
        .set nearest_11,27; .set nearest_12,23; .set lz_11,25; .set disc_16,22; .set disc_17,24
        .set chord_18,26; .set chord_19,28; .set disc_18,5; .set y_11,22; .set y_12,24
        .set disc_19,25; .set chord_20,33; .set disc_20,9; .set s_8,21; .set y_13,34; .set e_14,22
        .set e_15,24; .set s_9,34; .set e_16,21; .set t_8,21; .set t_9,22; .set hit_14,24
        .set hit_15,25; .set hit_16,5; .set merge_6,5; .set nearest_13,9; .set nearest_14,19
        nop     $127                                    # 0e pairing
        biz     $count,$lr                              # 0o
        ilhu    $m_x,1                                  # 1e
        ilhu    $m_y,0x405                              # 2e
        ilhu    $m_z,0x809                              # 3e
        ilhu    $m_radius2,0xc0d                        # 4e
        ilhu    $half,0x3f00                            # 5e
        ilhu    $whole,0x3f80                           # 6e
        clgti   $count_2,$count,3                       # 7e at least as many passes as overlap
        iohl    $m_x,515                                # 8e
        iohl    $m_y,0x607                              # 9e
        iohl    $m_z,0xa0b                              # 10e
        iohl    $m_radius2,0xe0f                        # 11e
        ila     $a_merges,merges                        # 12e
        iohl    $half,0                                 # 13e
        iohl    $whole,0                                # 14e
        ilhu    $k_one,0x3f80                           # 15e
        lnop                                            # 15o pairing
        ilhu    $k_quarter,0x3e80                       # 16e
        brz     $count_2,next_pair_short                # 16o too few passes
        ai      $a_pair_2,$a_pair,16                    # 17e
        lqd     $object_2,0($a_pair)                    # 17o
        ai      $count,$count,-1                        # 18e
        lnop                                            # 18o pairing
        ai      $a_pair,$a_pair_2,16                    # 19e
        lqd     $object_3,0($a_pair_2)                  # 19o
        ai      $count,$count,-1                        # 20e
        ai      $count,$count,-1                        # 22e
        rotqbyi $a_packet_2,$object_2,4                 # 23o
        lqd     $quad_2,0($object_2)                    # 24o
        lqd     $quad_3,0($object_3)                    # 25o
        rotqbyi $a_packet_3,$object_3,4                 # 26o
        lqd     $dy_2,96($a_packet_2)                   # 27o
        lqd     $dx_2,32($a_packet_2)                   # 28o
        lqd     $dx,0($a_packet_2)                      # 29o
        shufb   $cy_2,$quad_2,$quad_2,$m_y              # 30o
        shufb   $cz_2,$quad_2,$quad_2,$m_z              # 31o
        shufb   $cx_2,$quad_2,$quad_2,$m_x              # 32o
        nop     $127                                    # 33e pairing
        lqd     $dy_3,64($a_packet_2)                   # 33o
        fs      $ly,$dy_2,$cy_2                         # 34e
        lqd     $dx_3,16($a_packet_2)                   # 34o
        nop     $127                                    # 35e pairing
        lqd     $dz_2,160($a_packet_2)                  # 35o
        fs      $lx_2,$dx_2,$cx_2                       # 36e
        lqd     $dz,128($a_packet_2)                    # 36o
        fs      $lx_3,$dx,$cx_2                         # 37e
        shufb   $radius2_2,$quad_2,$quad_2,$m_radius2   # 37o
        nop     $127                                    # 38e pairing
        lqd     $dx_4,48($a_packet_2)                   # 38o
        fs      $ly_2,$dy_3,$cy_2                       # 39e
        lqd     $dy_4,80($a_packet_2)                   # 39o
        fs      $lx_4,$dx_3,$cx_2                       # 40e
        lqd     $dz_3,144($a_packet_2)                  # 40o
        fs      $lz_2,$dz_2,$cz_2                       # 41e
        lqd     $dy_5,112($a_packet_2)                  # 41o
        fm      $chord_2,$lx_2,$lx_2                    # 42e
        lqd     $dz_4,176($a_packet_2)                  # 42o
        fm      $chord_3,$lx_3,$lx_3                    # 43e
        lqd     $dx_5,32($a_packet_3)                   # 43o
        fs      $lz_3,$dz,$cz_2                         # 44e
        lqd     $dy_6,96($a_packet_3)                   # 44o
        fs      $lx_5,$dx_4,$cx_2                       # 45e
        shufb   $cx_2,$quad_3,$quad_3,$m_x              # 45o
        fm      $chord_4,$lx_4,$lx_4                    # 46e
        lqd     $dx_6,0($a_packet_3)                    # 46o
        fs      $ly_3,$dy_5,$cy_2                       # 47e
        shufb   $cz_3,$quad_3,$quad_3,$m_z              # 47o
        fma     $chord_2,$ly,$ly,$chord_2               # 48e
        shufb   $cy_3,$quad_3,$quad_3,$m_y              # 48o
        fma     $chord_3,$ly_2,$ly_2,$chord_3           # 49e
        lqd     $dx_7,16($a_packet_3)                   # 49o
        fs      $ly_4,$dy_4,$cy_2                       # 50e
        lqd     $dz_5,128($a_packet_3)                  # 50o
        fm      $chord_5,$lx_5,$lx_5                    # 51e
        lqd     $dz_6,160($a_packet_3)                  # 51o
        fs      $lz_4,$dz_3,$cz_2                       # 52e
        lqd     $dy_3,64($a_packet_3)                   # 52o
        fs      $lz_5,$dz_4,$cz_2                       # 53e
        shlqbyi $a_packet_4,$a_packet_2,0               # 53o copy
        fma     $chord,$lz_2,$lz_2,$chord_2             # 54e
        shlqbyi $a_packet_5,$a_packet_2,0               # 54o copy
        fma     $chord_3,$lz_3,$lz_3,$chord_3           # 55e
        shufb   $radius2_3,$quad_3,$quad_3,$m_radius2   # 55o
        fma     $chord_4,$ly_4,$ly_4,$chord_4           # 56e
        lqd     $quad_4,32($object_2)                   # 56o
        fma     $chord_5,$ly_3,$ly_3,$chord_5           # 57e
        lqd     $dy_7,80($a_packet_3)                   # 57o
        fs      $lx_6,$dx_6,$cx_2                       # 58e
        lqd     $t_best_2,224($a_packet_5)              # 58o
        fs      $lx_7,$dx_5,$cx_2                       # 59e
        lqd     $nearest_2,288($a_packet_5)             # 59o
        fms     $disc_2,$chord,$k_quarter,$k_one        # 60e
        shlqbyi $a_packet_6,$a_packet_2,0               # 60o copy
        fms     $disc_3,$chord_3,$k_quarter,$k_one      # 61e
        lqd     $nearest,256($a_packet_2)               # 61o
        fma     $chord_6,$lz_4,$lz_4,$chord_4           # 62e
        shufb   $distance,$quad_4,$quad_4,$m_radius2    # 62o
        fma     $chord_4,$lz_5,$lz_5,$chord_5           # 63e
        shufb   $object,$object_2,$object_2,$m_x        # 63o
        fm      $chord_7,$chord,$half                   # 64e
        lqd     $dz_7,144($a_packet_3)                  # 64o
        fm      $chord_8,$lx_6,$lx_6                    # 65e
        lqd     $t_best_3,192($a_packet_2)              # 65o
        fma     $disc_4,$chord,$disc_2,$radius2_2       # 66e
        lqd     $dz_4,176($a_packet_3)                  # 66o
        fma     $disc_5,$chord_3,$disc_3,$radius2_2     # 67e
        lqd     $dy_8,112($a_packet_3)                  # 67o
        fms     $disc_6,$chord_6,$k_quarter,$k_one      # 68e
        shlqbyi $a_packet_7,$a_packet_3,0               # 68o copy
        fms     $disc_2,$chord_4,$k_quarter,$k_one      # 69e
        lqd     $dx_8,48($a_packet_3)                   # 69o
        fm      $chord_9,$lx_7,$lx_7                    # 70e
        shlqbyi $object_4,$object,0                     # 70o copy
        fs      $ly_2,$dy_3,$cy_3                       # 71e
        lqd     $nearest_3,304($a_packet_5)             # 71o
        fs      $ly_5,$dy_6,$cy_3                       # 72e
        frsqest $y_2,$disc_4                            # 72o
        fs      $lz_6,$dz_6,$cz_3                       # 73e
        frsqest $y_3,$disc_5                            # 73o
        fma     $disc_6,$chord_6,$disc_6,$radius2_2     # 74e
        lqd     $nearest_4,272($a_packet_5)             # 74o
        fma     $disc_7,$chord_4,$disc_2,$radius2_2     # 75e
        lqd     $t_best_4,208($a_packet_5)              # 75o
        fi      $y,$disc_4,$y_2                         # 76e
        lqd     $t_best_5,240($a_packet_5)              # 76o
        fi      $y_4,$disc_5,$y_3                       # 77e
        shlqbyi $a_packet_8,$a_packet_3,0               # 77o copy
        shlqbyi $a_packet_9,$a_packet_4,0               # 78o copy
        fma     $chord_2,$ly_5,$ly_5,$chord_9           # 79e
        fm      $chord_3,$chord_3,$half                 # 80e
        frsqest $y_5,$disc_6                            # 80o
        fs      $lz_7,$dz_5,$cz_3                       # 81e
        frsqest $y_6,$disc_7                            # 81o
        fm      $chord_6,$chord_6,$half                 # 82e
        fm      $s_2,$disc_4,$y                         # 83e
        fm      $s_3,$disc_5,$y_4                       # 84e
        fma     $chord_2,$lz_6,$lz_6,$chord_2           # 85e
        fi      $y_7,$disc_6,$y_5                       # 86e
        fi      $y_6,$disc_7,$y_6                       # 87e
        fnms    $e_2,$s_2,$y,$k_one                     # 89e
        fnms    $e_3,$s_3,$y_4,$k_one                   # 90e
        fs      $lx_8,$dx_7,$cx_2                       # 91e
        fs      $lz_5,$dz_4,$cz_3                       # 92e
        fms     $disc_8,$chord_2,$k_quarter,$k_one      # 93e
        fm      $s_4,$disc_7,$y_6                       # 94e
        fma     $e_2,$e_2,$half,$whole                  # 95e
        fma     $e_3,$e_3,$half,$whole                  # 96e
        fs      $lx_9,$dx_8,$cx_2                       # 97e
        fm      $s_5,$disc_6,$y_7                       # 98e
        fma     $chord_8,$ly_2,$ly_2,$chord_8           # 99e
        fma     $disc_9,$chord_2,$disc_8,$radius2_3     # 100e
        fma     $e_4,$s_2,$e_2,$chord_7                 # 101e
        fma     $e_3,$s_3,$e_3,$chord_3                 # 102e
        fm      $chord_10,$chord_4,$half                # 103e
        fnms    $e_5,$s_5,$y_7,$k_one                   # 104e
        fma     $chord_3,$lz_7,$lz_7,$chord_8           # 105e
        lnop                                            # 105o pairing
        fm      $chord_8,$lx_9,$lx_9                    # 106e
        frsqest $y,$disc_9                              # 106o
        fnms    $t_2,$distance,$e_4,$distance           # 107e
        fnms    $t,$distance,$e_3,$distance             # 108e
        fs      $lz_8,$dz_7,$cz_3                       # 109e
        fma     $e,$e_5,$half,$whole                    # 110e
        fms     $disc_10,$chord_3,$k_quarter,$k_one     # 111e
        fs      $ly_5,$dy_7,$cy_3                       # 112e
        clgt    $hit_2,$t_best_2,$t_2                   # 113e
        lnop                                            # 113o pairing
        fm      $chord_4,$lx_8,$lx_8                    # 114e
        hbrr    next_pair_back,next_pair                # 114o hint
        andc    $hit_3,$hit_2,$disc_4                   # 115e
        fma     $e_3,$s_5,$e,$chord_6                   # 116e
        fnms    $e_6,$s_4,$y_6,$k_one                   # 117e
        rotqbii $hit_3,$hit_3,1                         # 117o
        clgt    $hit_4,$t_best_3,$t                     # 118e
        fs      $ly_6,$dy_8,$cy_3                       # 119e
        fma     $chord_4,$ly_5,$ly_5,$chord_4           # 120e
        lnop                                            # 120o pairing
        fm      $chord_7,$chord_2,$half                 # 121e
        gb      $hit,$hit_3                             # 121o
        andc    $hit_5,$hit_4,$disc_5                   # 122e
        fma     $e_6,$e_6,$half,$whole                  # 123e
        rotmai  $hit_6,$hit_5,-31                       # 124e
        lnop                                            # 124o pairing
        fma     $disc_5,$chord_3,$disc_10,$radius2_3    # 125e
        shlqbii $hit,$hit,4                             # 125o
next_pair:
            fma     $chord,$ly_6,$ly_6,$chord_8         # 0e
            lnop                                        # 0o pairing
            fi      $y,$disc_9,$y                       # 1e
            lqd     $quad,32($object_3)                 # 1o
            selb    $t_best,$t_best_3,$t,$hit_6         # 2e
            lqx     $merge,$a_merges,$hit               # 2o
            selb    $nearest,$nearest,$object,$hit_6    # 3e
            shufb   $object,$object_3,$object_3,$m_x    # 3o
            fma     $e,$s_4,$e_6,$chord_10              # 4e
            stqd    $t_best,192($a_packet_6)            # 4o
            fma     $chord_11,$lz_8,$lz_8,$chord_4      # 5e
            stqd    $nearest,256($a_packet_6)           # 5o
            fnms    $t,$distance,$e_3,$distance         # 6e
            lqd     $object_3,0($a_pair)                # 6o
            fma     $chord,$lz_5,$lz_5,$chord           # 7e
            frsqest $y_8,$disc_5                        # 7o
            fm      $s,$disc_9,$y                       # 8e
            shlqbyi $a_packet_6,$a_packet_3,0           # 8o copy
            ai      $a_pair,$a_pair,16                  # 9e
            shufb   $t_best,$t_best_2,$t_2,$merge       # 9o
            fnms    $t_3,$distance,$e,$distance         # 10e
            lqd     $nearest,256($a_packet_3)           # 10o
            fms     $disc,$chord_11,$k_quarter,$k_one   # 11e
            lqd     $t_best_3,192($a_packet_3)          # 11o
            fm      $chord_6,$chord_3,$half             # 12e
            lqd     $quad_2,0($object_3)                # 12o
            fms     $disc_11,$chord,$k_quarter,$k_one   # 13e
            rotqbyi $a_packet_3,$object_3,4             # 13o
            clgt    $hit,$t_best_4,$t                   # 14e
            stqd    $t_best,224($a_packet_9)            # 14o
            fnms    $e,$s,$y,$k_one                     # 15e
            shufb   $nearest_5,$nearest_2,$object_4,$merge # 15o
            fi      $y,$disc_5,$y_8                     # 16e
            shufb   $distance,$quad,$quad,$m_radius2    # 16o
            andc    $hit,$hit,$disc_6                   # 17e
            lqd     $dz,128($a_packet_3)                # 17o
            clgt    $hit_7,$t_best_5,$t_3               # 18e
            lqd     $dx,0($a_packet_3)                  # 18o
            fma     $disc_6,$chord_11,$disc,$radius2_3  # 19e
            lqd     $dx_2,32($a_packet_3)               # 19o
            andc    $hit_7,$hit_7,$disc_7               # 20e
            shufb   $cy_2,$quad_2,$quad_2,$m_y          # 20o
            fma     $disc_7,$chord,$disc_11,$radius2_3  # 21e
            shufb   $cx_2,$quad_2,$quad_2,$m_x          # 21o
            fm      $chord_11,$chord_11,$half           # 22e
            lqd     $dy_2,96($a_packet_3)               # 22o
            fma     $e,$e,$half,$whole                  # 23e
            lqd     $dx_3,16($a_packet_3)               # 23o
            fm      $chord_10,$chord,$half              # 24e
            rotqbii $hit_7,$hit_7,1                     # 24o
            fs      $lx_2,$dx_2,$cx_2                   # 25e
            lqd     $dz_2,160($a_packet_3)              # 25o
            fs      $lx_3,$dx,$cx_2                     # 26e
            rotqbii $hit,$hit,1                         # 26o
            fm      $s_6,$disc_5,$y                     # 27e
            lqd     $dz_4,176($a_packet_3)              # 27o
            fs      $ly,$dy_2,$cy_2                     # 28e
            gb      $hit_7,$hit_7                       # 28o
            fs      $lx_4,$dx_3,$cx_2                   # 29e
            shufb   $cz_2,$quad_2,$quad_2,$m_z          # 29o
            fma     $e,$s,$e,$chord_7                   # 30e
            lqd     $dy_3,64($a_packet_3)               # 30o
            fm      $chord_2,$lx_2,$lx_2                # 31e
            shufb   $radius2_3,$quad_2,$quad_2,$m_radius2 # 31o
            fm      $chord_3,$lx_3,$lx_3                # 32e
            shlqbii $hit_7,$hit_7,4                     # 32o
            fnms    $e_7,$s_6,$y,$k_one                 # 33e
            frsqest $y,$disc_6                          # 33o
            fs      $lz_2,$dz_2,$cz_2                   # 34e
            frsqest $y_9,$disc_7                        # 34o
            fs      $lz_5,$dz_4,$cz_2                   # 35e
            gb      $hit,$hit                           # 35o
            fm      $chord_4,$lx_4,$lx_4                # 36e
            lqx     $merge_2,$a_merges,$hit_7           # 36o
            fma     $chord_2,$ly,$ly,$chord_2           # 37e
            lqd     $dz_8,144($a_packet_3)              # 37o
            fi      $y,$disc_6,$y                       # 38e
            lqd     $t_best_2,224($a_packet_7)          # 38o
            fi      $y_9,$disc_7,$y_9                   # 39e
            shlqbii $hit,$hit,4                         # 39o
        ai      $count,$count,-1                        # 40e
            fs      $ly_2,$dy_3,$cy_2                   # 41e
            fs      $lz_3,$dz,$cz_2                     # 42e
            shufb   $nearest_3,$nearest_3,$object_4,$merge_2 # 42o
            fma     $chord,$lz_2,$lz_2,$chord_2         # 43e
            lnop                                        # 43o pairing
            fnms    $t_2,$distance,$e,$distance         # 44e
            lqd     $dy_9,80($a_packet_3)               # 44o
            fs      $lz_8,$dz_8,$cz_2                   # 45e
            shufb   $t_best_6,$t_best_5,$t_3,$merge_2   # 45o
            fm      $s_7,$disc_6,$y                     # 46e
            stqd    $nearest_3,304($a_packet_9)         # 46o
            fma     $chord_3,$ly_2,$ly_2,$chord_3       # 47e
            lqx     $merge_3,$a_merges,$hit             # 47o
            fma     $e,$e_7,$half,$whole                # 48e
            stqd    $nearest_5,288($a_packet_9)         # 48o
            fm      $s_4,$disc_7,$y_9                   # 49e
            stqd    $t_best_6,240($a_packet_9)          # 49o
            fms     $disc_12,$chord,$k_quarter,$k_one   # 50e
            lqd     $dx,48($a_packet_3)                 # 50o
            fs      $ly_7,$dy_9,$cy_2                   # 51e
            lqd     $dy_5,112($a_packet_3)              # 51o
            fnms    $e_2,$s_7,$y,$k_one                 # 52e
            lqd     $nearest_2,288($a_packet_7)         # 52o
            clgt    $hit_8,$t_best_2,$t_2               # 53e
            shufb   $nearest_6,$nearest_4,$object_4,$merge_3 # 53o
            fma     $chord_3,$lz_3,$lz_3,$chord_3       # 54e
            shufb   $t_best_7,$t_best_4,$t,$merge_3     # 54o
            fma     $e,$s_6,$e,$chord_6                 # 55e
            shlqbyi $object_4,$object,0                 # 55o copy
            andc    $hit_9,$hit_8,$disc_9               # 56e
            lqd     $nearest_3,304($a_packet_7)         # 56o
            fnms    $e_8,$s_4,$y_9,$k_one               # 57e
            stqd    $nearest_6,272($a_packet_9)         # 57o
            fma     $disc_9,$chord,$disc_12,$radius2_3  # 58e
            lqd     $t_best_5,240($a_packet_7)          # 58o
            fs      $lx_10,$dx,$cx_2                    # 59e
            stqd    $t_best_7,208($a_packet_9)          # 59o
            fs      $ly_6,$dy_5,$cy_2                   # 60e
            shlqbyi $a_packet_9,$a_packet_8,0           # 60o copy
            fnms    $t,$distance,$e,$distance           # 61e
            lqd     $nearest_4,272($a_packet_7)         # 61o
            fms     $disc_13,$chord_3,$k_quarter,$k_one # 62e
            rotqbii $hit,$hit_9,1                       # 62o
            fma     $e,$e_2,$half,$whole                # 63e
            lqd     $t_best_4,208($a_packet_7)          # 63o
            fma     $e_6,$e_8,$half,$whole              # 64e
            shlqbyi $a_packet_8,$a_packet_3,0           # 64o copy
            fm      $chord_8,$lx_10,$lx_10              # 65e
            shlqbyi $a_packet_7,$a_packet_3,0           # 65o copy
            fm      $chord_7,$chord,$half               # 66e
            gb      $hit,$hit                           # 66o
            clgt    $hit_4,$t_best_3,$t                 # 67e
            frsqest $y,$disc_9                          # 67o
            fma     $chord_4,$ly_7,$ly_7,$chord_4       # 68e
            andc    $hit_5,$hit_4,$disc_5               # 69e
            fma     $disc_5,$chord_3,$disc_13,$radius2_3 # 70e
            shlqbii $hit,$hit,4                         # 70o
            rotmai  $hit_6,$hit_5,-31                   # 71e
            lnop                                        # 71o pairing
            fma     $e_3,$s_7,$e,$chord_11              # 72e
next_pair_back:
        brnz    $count,next_pair                        # 72o
next_pair_drain:
        fma     $e,$s_4,$e_6,$chord_10                  # 0e
        lqd     $quad,32($object_3)                     # 0o
        selb    $t_best,$t_best_3,$t,$hit_6             # 1e
        lqx     $merge,$a_merges,$hit                   # 1o
        fma     $chord,$ly_6,$ly_6,$chord_8             # 2e
        frsqest $y_8,$disc_5                            # 2o
        fnms    $t,$distance,$e_3,$distance             # 3e
        stqd    $t_best,192($a_packet_6)                # 3o
        selb    $nearest,$nearest,$object,$hit_6        # 4e
        shufb   $object,$object_3,$object_3,$m_x        # 4o
        fma     $chord_11,$lz_8,$lz_8,$chord_4          # 5e
        shlqbyi $a_packet_10,$a_packet_3,0              # 5o copy
        fnms    $t_3,$distance,$e,$distance             # 6e
        stqd    $nearest,256($a_packet_6)               # 6o
        fi      $y,$disc_9,$y                           # 7e
        lqd     $object_3,0($a_pair)                    # 7o
        fi      $y_8,$disc_5,$y_8                       # 8e
        shufb   $t_best,$t_best_2,$t_2,$merge           # 8o
        clgt    $hit,$t_best_4,$t                       # 9e
        lqd     $nearest,256($a_packet_3)               # 9o
        fma     $chord,$lz_5,$lz_5,$chord               # 10e
        lqd     $t_best_3,192($a_packet_3)              # 10o
        andc    $hit,$hit,$disc_6                       # 11e
        shufb   $nearest_5,$nearest_2,$object_4,$merge  # 11o
        clgt    $hit_10,$t_best_5,$t_3                  # 12e
        shufb   $distance,$quad,$quad,$m_radius2        # 12o
        fms     $disc,$chord_11,$k_quarter,$k_one       # 13e
        rotqbyi $a_packet_3,$object_3,4                 # 13o
        andc    $hit_10,$hit_10,$disc_7                 # 14e
        lqd     $quad_5,0($object_3)                    # 14o
        fm      $s,$disc_9,$y                           # 15e
        stqd    $t_best,224($a_packet_9)                # 15o
        fms     $disc_11,$chord,$k_quarter,$k_one       # 16e
        rotqbii $hit_10,$hit_10,1                       # 16o
        fm      $s_6,$disc_5,$y_8                       # 17e
        lqd     $dx_2,32($a_packet_3)                   # 17o
        fm      $chord_12,$chord,$half                  # 18e
        rotqbii $hit,$hit,1                             # 18o
        fma     $disc_6,$chord_11,$disc,$radius2_3      # 19e
        lqd     $dx_9,0($a_packet_3)                    # 19o
        fm      $chord_3,$chord_3,$half                 # 20e
        gb      $hit_10,$hit_10                         # 20o
        fnms    $e,$s,$y,$k_one                         # 21e
        shufb   $cx_3,$quad_5,$quad_5,$m_x              # 21o
        fma     $disc_7,$chord,$disc_11,$radius2_3      # 22e
        gb      $hit,$hit                               # 22o
        fnms    $e_9,$s_6,$y_8,$k_one                   # 23e
        lqd     $dx_3,16($a_packet_3)                   # 23o
        fm      $chord_11,$chord_11,$half               # 24e
        shlqbii $hit_10,$hit_10,4                       # 24o
        fs      $lx_2,$dx_2,$cx_3                       # 25e
        lqd     $dz_8,144($a_packet_3)                  # 25o
        fs      $lx_9,$dx_9,$cx_3                       # 26e
        lqd     $dz_4,176($a_packet_3)                  # 26o
        fma     $e,$e,$half,$whole                      # 27e
        lqd     $dy_7,96($a_packet_3)                   # 27o
        ai      $a_pair,$a_pair,16                      # 28e
        lqx     $merge_4,$a_merges,$hit_10              # 28o
        fs      $lx_4,$dx_3,$cx_3                       # 29e
        lqd     $dz_2,160($a_packet_3)                  # 29o
        fma     $e_9,$e_9,$half,$whole                  # 30e
        shlqbii $hit,$hit,4                             # 30o
        fm      $chord_2,$lx_2,$lx_2                    # 31e
        lqd     $dy_10,80($a_packet_3)                  # 31o
        fm      $chord_13,$lx_9,$lx_9                   # 32e
        lqd     $dz_9,128($a_packet_3)                  # 32o
        fma     $e,$s,$e,$chord_7                       # 33e
        lqd     $t_best_2,224($a_packet_7)              # 33o
        nop     $127                                    # 34e pairing
        shufb   $nearest_3,$nearest_3,$object_4,$merge_4 # 34o
        fm      $chord_4,$lx_4,$lx_4                    # 35e
        shufb   $t_best_8,$t_best_5,$t_3,$merge_4       # 35o
        fma     $e_9,$s_6,$e_9,$chord_3                 # 36e
        lqd     $dy_3,64($a_packet_3)                   # 36o
        shufb   $cy_4,$quad_5,$quad_5,$m_y              # 37o
        stqd    $nearest_3,304($a_packet_9)             # 38o
        fnms    $t_2,$distance,$e,$distance             # 39e
        lqx     $merge_5,$a_merges,$hit                 # 39o
        nop     $127                                    # 40e pairing
        stqd    $nearest_5,288($a_packet_9)             # 40o
        fs      $ly_8,$dy_7,$cy_4                       # 41e
        frsqest $y_9,$disc_7                            # 41o
        fs      $ly_2,$dy_3,$cy_4                       # 42e
        stqd    $t_best_8,240($a_packet_9)              # 42o
        fs      $ly_9,$dy_10,$cy_4                      # 43e
        lqd     $dx_10,48($a_packet_3)                  # 43o
        fnms    $t_4,$distance,$e_9,$distance           # 44e
        shufb   $cz_2,$quad_5,$quad_5,$m_z              # 44o
        fi      $y_9,$disc_7,$y_9                       # 45e
        lqd     $dy_5,112($a_packet_3)                  # 45o
        clgt    $hit_8,$t_best_2,$t_2                   # 46e
        frsqest $y,$disc_6                              # 46o
        fma     $chord_2,$ly_8,$ly_8,$chord_2           # 47e
        shufb   $radius2_3,$quad_5,$quad_5,$m_radius2   # 47o
        fs      $lz_2,$dz_2,$cz_2                       # 48e
        shufb   $nearest_6,$nearest_4,$object_4,$merge_5 # 48o
        fs      $lx_11,$dx_10,$cx_3                     # 49e
        lqd     $nearest_7,304($a_packet_7)             # 49o
        fi      $y,$disc_6,$y                           # 50e
        lqd     $nearest_8,288($a_packet_7)             # 50o
        andc    $hit_11,$hit_8,$disc_9                  # 51e
        shufb   $t_best_7,$t_best_4,$t,$merge_5         # 51o
        fs      $ly_10,$dy_5,$cy_4                      # 52e
        stqd    $nearest_6,272($a_packet_9)             # 52o
        fm      $s_4,$disc_7,$y_9                       # 53e
        lqd     $t_best_5,240($a_packet_7)              # 53o
        fma     $chord,$lz_2,$lz_2,$chord_2             # 54e
        rotqbii $hit,$hit_11,1                          # 54o
        fm      $chord_14,$lx_11,$lx_11                 # 55e
        stqd    $t_best_7,208($a_packet_9)              # 55o
        fs      $lz_3,$dz_9,$cz_2                       # 56e
        lqd     $t_best_4,208($a_packet_7)              # 56o
        fs      $lz_5,$dz_4,$cz_2                       # 57e
        shlqbyi $a_packet_9,$a_packet_8,0               # 57o copy
        fma     $chord_3,$ly_2,$ly_2,$chord_13          # 58e
        gb      $hit,$hit                               # 58o
        fnms    $e_8,$s_4,$y_9,$k_one                   # 59e
        lqd     $nearest_4,272($a_packet_7)             # 59o
        fms     $disc_14,$chord,$k_quarter,$k_one       # 60e
        lqd     $quad,32($object_3)                     # 60o
        fma     $chord_14,$ly_10,$ly_10,$chord_14       # 61e
        shlqbyi $object_4,$object,0                     # 61o copy
        fm      $s_7,$disc_6,$y                         # 62e
        shlqbii $hit,$hit,4                             # 62o
        fs      $lz_8,$dz_8,$cz_2                       # 63e
        shlqbyi $a_packet_7,$a_packet_3,0               # 63o copy
        fma     $chord_3,$lz_3,$lz_3,$chord_3           # 64e
        shlqbyi $a_packet_8,$a_packet_3,0               # 64o copy
        fma     $e_10,$e_8,$half,$whole                 # 65e
        shlqbyi $a_packet_11,$a_packet_3,0              # 65o copy
        fma     $disc_9,$chord,$disc_14,$radius2_3      # 66e
        lqx     $merge,$a_merges,$hit                   # 66o
        fma     $chord_14,$lz_5,$lz_5,$chord_14         # 67e
        shufb   $distance_2,$quad,$quad,$m_radius2      # 67o
        fnms    $e_2,$s_7,$y,$k_one                     # 68e
        shufb   $object_3,$object_3,$object_3,$m_x      # 68o
        fma     $chord_4,$ly_9,$ly_9,$chord_4           # 69e
        shlqbyi $a_packet_12,$a_packet_8,0              # 69o copy
        fms     $disc_15,$chord_3,$k_quarter,$k_one     # 70e
        hbr     isect_pairs_constants_r16_return,$lr    # 70o hint
        fma     $e,$s_4,$e_10,$chord_12                 # 71e
        lnop                                            # 71o pairing
        clgt    $hit_12,$t_best_3,$t_4                  # 72e
        frsqest $y_10,$disc_9                           # 72o
        fms     $disc_11,$chord_14,$k_quarter,$k_one    # 73e
        shufb   $t_best,$t_best_2,$t_2,$merge           # 73o
        fma     $e_11,$e_2,$half,$whole                 # 74e
        shufb   $nearest_8,$nearest_8,$object_4,$merge  # 74o
        fma     $chord_12,$lz_8,$lz_8,$chord_4          # 75e
        shlqbyi $object_5,$object_3,0                   # 75o copy
        fi      $y,$disc_9,$y_10                        # 76e
        andc    $hit_5,$hit_12,$disc_5                  # 77e
        fnms    $t_5,$distance,$e,$distance             # 78e
        fma     $disc_11,$chord_14,$disc_11,$radius2_3  # 79e
        fma     $e_3,$s_7,$e_11,$chord_11               # 80e
        fma     $disc_5,$chord_3,$disc_15,$radius2_3    # 81e
        fms     $disc,$chord_12,$k_quarter,$k_one       # 82e
        rotmai  $hit_3,$hit_5,-31                       # 83e
        clgt    $hit_13,$t_best_5,$t_5                  # 84e
        lnop                                            # 84o pairing
        fm      $s,$disc_9,$y                           # 85e
        frsqest $y_9,$disc_11                           # 85o
        andc    $hit_13,$hit_13,$disc_7                 # 86e
        lnop                                            # 86o pairing
        fnms    $t,$distance,$e_3,$distance             # 87e
        frsqest $y_4,$disc_5                            # 87o
        fma     $disc_15,$chord_12,$disc,$radius2_3     # 88e
        rotqbii $hit_13,$hit_13,1                       # 88o
        fi      $y_9,$disc_11,$y_9                      # 89e
        selb    $t_best_6,$t_best_3,$t_4,$hit_3         # 90e
        fi      $y_4,$disc_5,$y_4                       # 91e
        lnop                                            # 91o pairing
        selb    $nearest,$nearest,$object,$hit_3        # 92e
        gb      $hit_3,$hit_13                          # 92o
        clgt    $hit,$t_best_4,$t                       # 93e
        stqd    $t_best_6,192($a_packet_10)             # 93o
        fnms    $e,$s,$y,$k_one                         # 94e
        stqd    $nearest,256($a_packet_10)              # 94o
        andc    $hit,$hit,$disc_6                       # 95e
        lqd     $nearest,256($a_packet_3)               # 95o
        fm      $s_4,$disc_11,$y_9                      # 96e
        lqd     $t_best_3,192($a_packet_3)              # 96o
        fm      $chord_15,$chord,$half                  # 97e
        rotqbii $hit,$hit,1                             # 97o
        fm      $s_6,$disc_5,$y_4                       # 98e
        shlqbii $hit_7,$hit_3,4                         # 98o
        fm      $chord_10,$chord_14,$half               # 99e
        stqd    $t_best,224($a_packet_9)                # 99o
        fma     $e,$e,$half,$whole                      # 100e
        frsqest $y,$disc_15                             # 100o
        fm      $chord_11,$chord_3,$half                # 101e
        gb      $hit,$hit                               # 101o
        fnms    $e_12,$s_4,$y_9,$k_one                  # 102e
        lqx     $merge_2,$a_merges,$hit_7               # 102o
        fm      $chord_16,$chord_12,$half               # 103e
        lqd     $t_best_2,224($a_packet_7)              # 103o
        fi      $y,$disc_15,$y                          # 104e
        shlqbii $hit,$hit,4                             # 105o
        fma     $e,$s,$e,$chord_15                      # 106e
        fnms    $e_7,$s_6,$y_4,$k_one                   # 107e
        fma     $e_13,$e_12,$half,$whole                # 108e
        shufb   $nearest_3,$nearest_7,$object_4,$merge_2 # 108o
        shufb   $t_best_6,$t_best_5,$t_5,$merge_2       # 109o
        fm      $s_7,$disc_15,$y                        # 111e
        fnms    $t_2,$distance_2,$e,$distance_2         # 112e
        stqd    $nearest_3,304($a_packet_9)             # 112o
        fma     $e,$e_7,$half,$whole                    # 113e
        lqx     $merge_3,$a_merges,$hit                 # 113o
        fma     $e_13,$s_4,$e_13,$chord_10              # 114e
        stqd    $nearest_8,288($a_packet_9)             # 114o
        stqd    $t_best_6,240($a_packet_9)              # 115o
        lqd     $nearest_2,288($a_packet_7)             # 116o
        fnms    $e_2,$s_7,$y,$k_one                     # 117e
        lqd     $nearest_3,304($a_packet_7)             # 117o
        clgt    $hit_7,$t_best_2,$t_2                   # 118e
        lnop                                            # 118o pairing
        fma     $e,$s_6,$e,$chord_11                    # 119e
        shufb   $nearest_6,$nearest_4,$object_4,$merge_3 # 119o
        andc    $hit_9,$hit_7,$disc_9                   # 120e
        shufb   $t_best_9,$t_best_4,$t,$merge_3         # 120o
        fnms    $t_6,$distance_2,$e_13,$distance_2      # 121e
        rotqbii $hit,$hit_9,1                           # 122o
        fma     $e_9,$e_2,$half,$whole                  # 123e
        stqd    $nearest_6,272($a_packet_9)             # 123o
        nop     $127                                    # 124e pairing
        lqd     $t_best_5,240($a_packet_7)              # 124o
        fnms    $t,$distance_2,$e,$distance_2           # 125e
        stqd    $t_best_9,208($a_packet_9)              # 125o
        gb      $hit,$hit                               # 126o
        lqd     $t_best_4,208($a_packet_7)              # 127o
        lqd     $nearest_4,272($a_packet_7)             # 128o
        fma     $e_3,$s_7,$e_9,$chord_16                # 129e
        clgt    $hit_7,$t_best_5,$t_6                   # 130e
        shlqbii $hit,$hit,4                             # 130o
        clgt    $hit_3,$t_best_3,$t                     # 131e
        andc    $hit_7,$hit_7,$disc_11                  # 132e
        andc    $hit_5,$hit_3,$disc_5                   # 133e
        lqx     $merge,$a_merges,$hit                   # 134o
        fnms    $t_7,$distance_2,$e_3,$distance_2       # 135e
        rotqbii $hit_7,$hit_7,1                         # 135o
        rotmai  $hit_6,$hit_5,-31                       # 136e
        gb      $hit_7,$hit_7                           # 139o
        selb    $t_best,$t_best_3,$t,$hit_6             # 140e
        shufb   $t_best_10,$t_best_2,$t_2,$merge        # 140o
        clgt    $hit,$t_best_4,$t_7                     # 141e
        shufb   $nearest_5,$nearest_2,$object_5,$merge  # 141o
        selb    $nearest,$nearest,$object_3,$hit_6      # 142e
        stqd    $t_best,192($a_packet_11)               # 142o
        andc    $hit,$hit,$disc_15                      # 143e
        shlqbii $hit_7,$hit_7,4                         # 143o
        stqd    $nearest,256($a_packet_11)              # 144o
        stqd    $t_best_10,224($a_packet_12)            # 145o
        rotqbii $hit,$hit,1                             # 146o
        lqx     $merge_2,$a_merges,$hit_7               # 147o
        gb      $hit,$hit                               # 150o
        shufb   $nearest_3,$nearest_3,$object_5,$merge_2 # 153o
        shlqbii $hit,$hit,4                             # 154o
        shufb   $t_best_6,$t_best_5,$t_6,$merge_2       # 155o
        stqd    $nearest_3,304($a_packet_12)            # 157o
        lqx     $merge_3,$a_merges,$hit                 # 158o
        stqd    $nearest_5,288($a_packet_12)            # 159o
        stqd    $t_best_6,240($a_packet_12)             # 160o
        shufb   $nearest_6,$nearest_4,$object_5,$merge_3 # 164o
        shufb   $t_best_7,$t_best_4,$t_7,$merge_3       # 165o
        stqd    $nearest_6,272($a_packet_12)            # 168o
        stqd    $t_best_7,208($a_packet_12)             # 169o
        nop     $127                                    # 170e pairing
isect_pairs_constants_r16_return:
        bi      $lr                                     # 170o
next_pair_short:
        ai      $count,$count,-1                        # 0e
        lqd     $object,0($a_pair)                      # 0o
        ai      $a_pair,$a_pair,16                      # 1e
        rotqbyi $a_packet,$object,4                     # 6o
        lqd     $quad,0($object)                        # 7o
        lqd     $quad_6,32($object)                     # 8o
        shufb   $object,$object,$object,$m_x            # 9o
        lqd     $dx,32($a_packet)                       # 10o
        lqd     $dx_11,16($a_packet)                    # 11o
        lqd     $dx_12,48($a_packet)                    # 12o
        shufb   $cx,$quad,$quad,$m_x                    # 13o
        lqd     $dy,80($a_packet)                       # 14o
        lqd     $dy_10,112($a_packet)                   # 15o
        lqd     $dy_11,96($a_packet)                    # 16o
        fs      $lx,$dx_11,$cx                          # 17e
        shufb   $cy,$quad,$quad,$m_y                    # 17o
        fs      $lx_12,$dx,$cx                          # 18e
        lqd     $dz,160($a_packet)                      # 18o
        fs      $lx_10,$dx_12,$cx                       # 19e
        lqd     $dz_10,176($a_packet)                   # 19o
        nop     $127                                    # 20e pairing
        lqd     $dz_11,144($a_packet)                   # 20o
        fs      $ly,$dy,$cy                             # 21e
        shufb   $cz_4,$quad,$quad,$m_z                  # 21o
        fs      $ly_10,$dy_11,$cy                       # 22e
        lqd     $dx,0($a_packet)                        # 22o
        fm      $chord,$lx,$lx                          # 23e
        lqd     $dy,64($a_packet)                       # 23o
        fm      $chord_17,$lx_12,$lx_12                 # 24e
        lqd     $dz_12,128($a_packet)                   # 24o
        fs      $ly_11,$dy_10,$cy                       # 25e
        shufb   $radius2_4,$quad,$quad,$m_radius2       # 25o
        fm      $chord_8,$lx_10,$lx_10                  # 26e
        shufb   $distance_3,$quad_6,$quad_6,$m_radius2  # 26o
        fs      $lz,$dz,$cz_4                           # 27e
        lqd     $t_best,208($a_packet)                  # 27o
        fs      $lz_9,$dz_10,$cz_4                      # 28e
        lqd     $t_best_7,240($a_packet)                # 28o
        fma     $chord,$ly,$ly,$chord                   # 29e
        lqd     $t_best_11,224($a_packet)               # 29o
        fs      $lz_10,$dz_11,$cz_4                     # 30e
        lqd     $t_best_12,192($a_packet)               # 30o
        fma     $chord_17,$ly_10,$ly_10,$chord_17       # 31e
        lqd     $nearest_9,272($a_packet)               # 31o
        fma     $chord_8,$ly_11,$ly_11,$chord_8         # 32e
        lqd     $nearest_10,288($a_packet)              # 32o
        fs      $lx_13,$dx,$cx                          # 33e
        lqd     $nearest_11,304($a_packet)              # 33o
        fs      $ly,$dy,$cy                             # 34e
        lqd     $nearest_12,256($a_packet)              # 34o
        fs      $lz_11,$dz_12,$cz_4                     # 35e
        fma     $chord,$lz_10,$lz_10,$chord             # 36e
        fma     $chord_17,$lz,$lz,$chord_17             # 37e
        fma     $chord_8,$lz_9,$lz_9,$chord_8           # 38e
        fm      $chord_5,$lx_13,$lx_13                  # 39e
        fms     $disc,$chord,$k_quarter,$k_one          # 42e
        fms     $disc_16,$chord_17,$k_quarter,$k_one    # 43e
        fms     $disc_17,$chord_8,$k_quarter,$k_one     # 44e
        fma     $chord_5,$ly,$ly,$chord_5               # 45e
        fm      $chord_18,$chord_17,$half               # 46e
        fm      $chord_19,$chord_8,$half                # 47e
        fma     $disc,$chord,$disc,$radius2_4           # 48e
        fma     $disc_18,$chord_17,$disc_16,$radius2_4  # 49e
        fma     $disc_12,$chord_8,$disc_17,$radius2_4   # 50e
        fma     $chord_5,$lz_11,$lz_11,$chord_5         # 51e
        fm      $chord,$chord,$half                     # 52e
        frsqest $y,$disc                                # 54o
        frsqest $y_11,$disc_18                          # 55o
        frsqest $y_12,$disc_12                          # 56o
        fms     $disc_19,$chord_5,$k_quarter,$k_one     # 57e
        fi      $y,$disc,$y                             # 58e
        fi      $y_11,$disc_18,$y_11                    # 59e
        fi      $y_12,$disc_12,$y_12                    # 60e
        fm      $chord_20,$chord_5,$half                # 62e
        fma     $disc_20,$chord_5,$disc_19,$radius2_4   # 63e
        fm      $s,$disc,$y                             # 65e
        fm      $s_8,$disc_18,$y_11                     # 66e
        fm      $s_4,$disc_12,$y_12                     # 67e
        frsqest $y_13,$disc_20                          # 69o
        fnms    $e,$s,$y,$k_one                         # 71e
        fnms    $e_14,$s_8,$y_11,$k_one                 # 72e
        fnms    $e_15,$s_4,$y_12,$k_one                 # 73e
        fi      $y,$disc_20,$y_13                       # 74e
        fma     $e,$e,$half,$whole                      # 77e
        fma     $e_14,$e_14,$half,$whole                # 78e
        fma     $e_15,$e_15,$half,$whole                # 79e
        fm      $s_9,$disc_20,$y                        # 81e
        fma     $e,$s,$e,$chord                         # 83e
        fma     $e_16,$s_8,$e_14,$chord_18              # 84e
        fma     $e_14,$s_4,$e_15,$chord_19              # 85e
        fnms    $e_15,$s_9,$y,$k_one                    # 87e
        fnms    $t,$distance_3,$e,$distance_3           # 89e
        fnms    $t_8,$distance_3,$e_16,$distance_3      # 90e
        fnms    $t_9,$distance_3,$e_14,$distance_3      # 91e
        fma     $e,$e_15,$half,$whole                   # 93e
        clgt    $hit,$t_best,$t                         # 95e
        clgt    $hit_14,$t_best_11,$t_8                 # 96e
        andc    $hit,$hit,$disc                         # 97e
        clgt    $hit_15,$t_best_7,$t_9                  # 98e
        lnop                                            # 98o pairing
        andc    $hit_16,$hit_14,$disc_18                # 99e
        rotqbii $hit,$hit,1                             # 99o
        andc    $hit_7,$hit_15,$disc_12                 # 100e
        lnop                                            # 100o pairing
        fma     $e,$s_9,$e,$chord_20                    # 101e
        rotqbii $hit_16,$hit_16,1                       # 101o
        rotqbii $hit_7,$hit_7,1                         # 102o
        gb      $hit,$hit                               # 103o
        gb      $hit_16,$hit_16                         # 105o
        gb      $hit_7,$hit_7                           # 106o
        fnms    $t_7,$distance_3,$e,$distance_3         # 107e
        shlqbii $hit,$hit,4                             # 107o
        shlqbii $hit_16,$hit_16,4                       # 109o
        shlqbii $hit_7,$hit_7,4                         # 110o
        nop     $127                                    # 111e pairing
        lqx     $merge,$a_merges,$hit                   # 111o
        clgt    $hit,$t_best_12,$t_7                    # 113e
        lqx     $merge_6,$a_merges,$hit_16              # 113o
        lqx     $merge_2,$a_merges,$hit_7               # 114o
        andc    $hit,$hit,$disc_20                      # 115e
        rotmai  $hit,$hit,-31                           # 117e
        shufb   $nearest_9,$nearest_9,$object,$merge    # 117o
        shufb   $t_best,$t_best,$t,$merge               # 118o
        shufb   $nearest_10,$nearest_10,$object,$merge_6 # 119o
        nop     $127                                    # 120e pairing
        shufb   $nearest_13,$nearest_11,$object,$merge_2 # 120o
        selb    $t_best_9,$t_best_12,$t_7,$hit          # 121e
        shufb   $t_best_6,$t_best_7,$t_9,$merge_2       # 121o
        selb    $nearest_14,$nearest_12,$object,$hit    # 122e
        stqd    $t_best,208($a_packet)                  # 122o
        stqd    $t_best_9,192($a_packet)                # 123o
        stqd    $nearest_10,288($a_packet)              # 124o
        stqd    $t_best_6,240($a_packet)                # 125o
        shufb   $t_best,$t_best_11,$t_8,$merge_6        # 126o
        stqd    $nearest_14,256($a_packet)              # 127o
        stqd    $nearest_13,304($a_packet)              # 128o
        stqd    $nearest_9,272($a_packet)               # 129o
        stqd    $t_best,224($a_packet)                  # 130o
        nop     $127                                    # 131e pairing
        brnz    $count,next_pair_short                  # 131o
        nop     $127                                    # 132e pairing
        bi      $lr                                     # 132o
endfunction isect_pairs_constants_r16
