# isect_pairs_paper_r16   nearest entries of primary rays into spheres, by b^2 - 4ac
#   C       void isect_pairs_paper_r16(const struct pair *, int count);
#   In      $3 pairs, $4 count (0 is none); pointers 16-aligned
#   Out     the pairs' packets: t, object, where an entry is nearer than what was there
#   Uses    $2-$65, $79   Saves  -   Stack  0   Calls  -
#   Domain  |d| = 1 within 4 ulp; radius > 0; centre and radius below 2^62; eye 1.5 to 3 radii from
#           the centre
#   Error   80 ulp of t, eye 1.5 to 3 radii from the centre, ray within 0.995 r of it
#   Twin    lab/twins/src/sphere/paper.rs
#
# The steps are in sphere_tmpl.inc. An opaque sphere has no inside, so only the entry counts, and
# only if it is in front of the eye.
# Scheduled by spu schedule from isect_pairs_paper_r16.s

        .include "sphere_eye.inc"
        .include "sphere_paper.inc"

        eye_registers "k_one,half,whole", "radius2", "b,cc,disc,y,s,e"
        merges_table

function isect_pairs_paper_r16
        .set count_2,79; .set a_pair_2,2; .set object_2,55; .set a_pair_3,5; .set object_3,2
        .set a_packet_2,63; .set quad_2,38; .set quad_3,6; .set a_packet_3,8; .set dx_2,27
        .set dy_2,29; .set dz_2,28; .set dx_3,7; .set b_2,9; .set cz_2,36; .set cc_2,19
        .set dy_3,18; .set dx_4,20; .set cc_3,23; .set cc_4,24; .set dz_3,26; .set b_3,7
        .set dy_4,27; .set dz_4,35; .set dz_5,39; .set radius2_2,25; .set b_4,20; .set dx_5,21
        .set cx_2,18; .set dx_6,28; .set t_best_2,60; .set dy_5,32; .set cy_2,33; .set dx_7,29
        .set b_5,48; .set nearest_2,46; .set disc_2,51; .set dy_6,19; .set object_4,22; .set cc_5,7
        .set a_packet_4,23; .set b_6,64; .set cz_3,6; .set disc_3,54; .set dz_6,20
        .set a_packet_5,27; .set b_7,21; .set y_2,31; .set b_8,61; .set dx_8,30; .set cc_6,34
        .set dy_7,35; .set disc_4,36; .set nearest_3,40; .set y_3,37; .set t_best_3,42
        .set cc_7,38; .set nearest_4,41; .set disc_5,7; .set a_packet_6,57; .set y_4,24
        .set t_best_4,43; .set s_2,44; .set dy_8,52; .set b_9,28; .set dz_7,65; .set y_5,45
        .set a_packet_7,56; .set a_packet_8,47; .set s_3,53; .set object_5,49; .set object_6,50
        .set e_2,2; .set a_packet_9,62; .set s_4,32; .set e_3,24; .set cc_8,55; .set b_10,19
        .set b_11,45; .set cc_9,21; .set cc_10,26; .set t_2,34; .set s_5,9; .set e_4,25
        .set hit_2,38; .set t_3,44; .set b_12,2; .set e_5,18; .set t_best_5,19; .set cc_11,20
        .set e_6,19; .set t_best_6,53; .set e_7,5; .set nearest_5,52; .set t_4,58; .set t_5,59
        .set y_6,19; .set hit_3,39; .set hit_4,5; .set cc_12,18; .set hit_5,2; .set dx_9,5
        .set dx_10,6; .set s_6,8; .set dy_9,9; .set b_13,5; .set y_7,20; .set y_8,25; .set b_14,6
        .set e_8,33; .set merge_2,27; .set t_best_7,9; .set cc_13,2; .set dz_8,18
        .set nearest_6,23; .set merge_3,37; .set t_best_8,27; .set s_7,23; .set e_9,8
        .set disc_6,3; .set a_packet_10,4; .set cc_14,5; .set y_9,7; .set hit_6,6; .set cc_15,9
        .set cc_16,14; .set t_best_9,15; .set nearest_7,16; .set s_8,20; .set disc_7,14
        .set cc_17,15; .set y_10,16; .set a_packet_11,2; .set object_7,13; .set a_packet_12,15
        .set y_11,8; .set disc_8,9; .set e_10,22; .set cc_18,6; .set hit_7,3; .set disc_9,6
        .set hit_8,8; .set s_9,16; .set nearest_8,3; .set s_10,5; .set dx_11,2; .set dy_10,6
        .set dy_11,7; .set cc_19,8; .set dz_9,9; .set dz_10,23; .set cc_20,25; .set cz_4,20
        .set dz_11,7; .set t_best_10,29; .set t_best_11,6; .set t_best_12,32; .set nearest_9,33
        .set nearest_10,34; .set nearest_11,9; .set disc_10,28; .set disc_11,8; .set disc_12,25
        .set y_12,22; .set y_13,26; .set s_11,21; .set s_12,35; .set disc_13,31; .set e_11,26
        .set y_14,36; .set t_6,5; .set t_7,20; .set t_8,2; .set hit_9,22; .set merge_4,7
        .set merge_5,8; .set nearest_12,21; .set t_best_13,5; .set nearest_13,6; .set t_best_14,2
        .set nearest_14,5
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
        brz     $count_2,next_pair_short                # 15o too few passes
        ai      $a_pair_2,$a_pair,16                    # 16e
        lqd     $object_2,0($a_pair)                    # 16o
        ai      $count,$count,-1                        # 17e
        lnop                                            # 17o pairing
        ai      $a_pair_3,$a_pair_2,16                  # 18e
        lqd     $object_3,0($a_pair_2)                  # 18o
        ai      $count,$count,-1                        # 19e
        ai      $a_pair,$a_pair_3,16                    # 20e
        ai      $count,$count,-1                        # 21e
        rotqbyi $a_packet_2,$object_2,4                 # 22o
        lqd     $quad_2,0($object_2)                    # 23o
        lqd     $quad_3,0($object_3)                    # 24o
        rotqbyi $a_packet_3,$object_3,4                 # 25o
        lqd     $dx_2,0($a_packet_2)                    # 26o
        lqd     $dy_2,64($a_packet_2)                   # 27o
        lqd     $dz_2,128($a_packet_2)                  # 28o
        shufb   $cx,$quad_2,$quad_2,$m_x                # 29o
        shufb   $radius2,$quad_2,$quad_2,$m_radius2     # 30o
        shufb   $cy,$quad_2,$quad_2,$m_y                # 31o
        lqd     $dx_3,32($a_packet_2)                   # 32o
        fm      $b_2,$cx,$dx_2                          # 33e
        shufb   $cz_2,$quad_2,$quad_2,$m_z              # 33o
        fms     $cc_2,$cx,$cx,$radius2                  # 34e
        lqd     $dy_3,96($a_packet_2)                   # 34o
        fms     $cc,$cx,$cx,$radius2                    # 35e
        lqd     $dx_4,48($a_packet_2)                   # 35o
        fms     $cc_3,$cx,$cx,$radius2                  # 36e
        lqd     $dx,16($a_packet_2)                     # 36o
        fms     $cc_4,$cx,$cx,$radius2                  # 37e
        lqd     $dz_3,160($a_packet_2)                  # 37o
        fm      $b_3,$cx,$dx_3                          # 38e
        lqd     $dy_4,80($a_packet_2)                   # 38o
        fma     $b_2,$cy,$dy_2,$b_2                     # 39e
        lqd     $dy_2,112($a_packet_2)                  # 39o
        fma     $cc_2,$cy,$cy,$cc_2                     # 40e
        lqd     $dz_4,176($a_packet_2)                  # 40o
        fma     $cc,$cy,$cy,$cc                         # 41e
        lqd     $dz_5,144($a_packet_2)                  # 41o
        fm      $b,$cx,$dx                              # 42e
        shufb   $radius2_2,$quad_3,$quad_3,$m_radius2   # 42o
        fm      $b_4,$cx,$dx_4                          # 43e
        lqd     $dx_5,0($a_packet_3)                    # 43o
        fma     $b_3,$cy,$dy_3,$b_3                     # 44e
        shufb   $cx_2,$quad_3,$quad_3,$m_x              # 44o
        fma     $b_2,$cz_2,$dz_2,$b_2                   # 45e
        lqd     $dx_6,32($a_packet_3)                   # 45o
        fma     $cc_2,$cz_2,$cz_2,$cc_2                 # 46e
        lqd     $t_best_2,192($a_packet_2)              # 46o
        fma     $cc,$cz_2,$cz_2,$cc                     # 47e
        lqd     $dy_5,64($a_packet_3)                   # 47o
        fma     $cc_3,$cy,$cy,$cc_3                     # 48e
        shufb   $cy_2,$quad_3,$quad_3,$m_y              # 48o
        fma     $b_4,$cy,$dy_2,$b_4                     # 49e
        lqd     $dx_7,48($a_packet_3)                   # 49o
        fma     $b_5,$cz_2,$dz_3,$b_3                   # 50e
        lqd     $nearest_2,256($a_packet_2)             # 50o
        fma     $cc_4,$cy,$cy,$cc_4                     # 51e
        lqd     $dz_3,128($a_packet_3)                  # 51o
        fms     $disc_2,$b_2,$b_2,$cc_2                 # 52e
        lqd     $dy_6,96($a_packet_3)                   # 52o
        fma     $b,$cy,$dy_4,$b                         # 53e
        shufb   $object_4,$object_2,$object_2,$m_x      # 53o
        fma     $cc_5,$cz_2,$cz_2,$cc_3                 # 54e
        shlqbyi $a_packet_4,$a_packet_2,0               # 54o copy
        fma     $b_6,$cz_2,$dz_4,$b_4                   # 55e
        shufb   $cz_3,$quad_3,$quad_3,$m_z              # 55o
        fms     $disc_3,$b_5,$b_5,$cc                   # 56e
        lqd     $dz_6,160($a_packet_3)                  # 56o
        fma     $cc_4,$cz_2,$cz_2,$cc_4                 # 57e
        shlqbyi $a_packet_5,$a_packet_2,0               # 57o copy
        fm      $b_7,$cx_2,$dx_5                        # 58e
        frsqest $y_2,$disc_2                            # 58o
        fma     $b_8,$cz_2,$dz_5,$b                     # 59e
        lqd     $dx_8,16($a_packet_3)                   # 59o
        fms     $cc_6,$cx_2,$cx_2,$radius2_2            # 60e
        lqd     $dy_7,112($a_packet_3)                  # 60o
        fms     $disc_4,$b_6,$b_6,$cc_5                 # 61e
        lqd     $nearest_3,272($a_packet_4)             # 61o
        fi      $y_2,$disc_2,$y_2                       # 62e
        frsqest $y_3,$disc_3                            # 62o
        nop     $127                                    # 63e pairing
        lqd     $t_best_3,224($a_packet_4)              # 63o
        fms     $cc_7,$cx_2,$cx_2,$radius2_2            # 64e
        lqd     $nearest_4,288($a_packet_4)             # 64o
        fms     $disc_5,$b_8,$b_8,$cc_4                 # 65e
        shlqbyi $a_packet_6,$a_packet_2,0               # 65o copy
        fi      $y_4,$disc_3,$y_3                       # 66e
        lqd     $dz_5,144($a_packet_3)                  # 66o
        nop     $127                                    # 67e pairing
        frsqest $y_3,$disc_4                            # 67o
        fma     $cc_6,$cy_2,$cy_2,$cc_6                 # 68e
        lqd     $t_best_4,208($a_packet_4)              # 68o
        fm      $s_2,$disc_2,$y_2                       # 69e
        lqd     $dy_8,80($a_packet_3)                   # 69o
        fm      $b_9,$cx_2,$dx_6                        # 70e
        lqd     $dz_7,176($a_packet_3)                  # 70o
        fi      $y_3,$disc_4,$y_3                       # 71e
        frsqest $y_5,$disc_5                            # 71o
        ori     $a_packet_7,$a_packet_6,0               # 72e copy
        shlqbyi $a_packet_8,$a_packet_3,0               # 72o copy
        fm      $s_3,$disc_3,$y_4                       # 73e
        shlqbyi $object_5,$object_4,0                   # 73o copy
        fma     $b_7,$cy_2,$dy_5,$b_7                   # 74e
        shufb   $object_6,$object_3,$object_3,$m_x      # 74o
        fnms    $e_2,$s_2,$y_2,$k_one                   # 75e
        shlqbyi $a_packet_6,$a_packet_3,0               # 75o copy
        fi      $y_2,$disc_5,$y_5                       # 76e
        shlqbyi $a_packet_9,$a_packet_3,0               # 76o copy
        fm      $s_4,$disc_4,$y_3                       # 78e
        fnms    $e_3,$s_3,$y_4,$k_one                   # 79e
        fms     $cc_8,$cx_2,$cx_2,$radius2_2            # 80e
        fma     $e_2,$e_2,$half,$whole                  # 81e
        fma     $b_10,$cy_2,$dy_6,$b_9                  # 82e
        fm      $b_9,$cx_2,$dx_7                        # 83e
        fma     $b_11,$cz_3,$dz_3,$b_7                  # 84e
        fma     $cc_9,$cy_2,$cy_2,$cc_7                 # 85e
        fma     $cc_10,$cz_3,$cz_3,$cc_6                # 86e
        fnms    $t_2,$s_2,$e_2,$b_2                     # 87e
        fma     $e_2,$e_3,$half,$whole                  # 88e
        fm      $s_5,$disc_5,$y_2                       # 89e
        fms     $cc_4,$cx_2,$cx_2,$radius2_2            # 90e
        fnms    $e_4,$s_4,$y_3,$k_one                   # 91e
        fm      $b,$cx_2,$dx_8                          # 92e
        clgt    $hit_2,$t_best_2,$t_2                   # 93e
        fnms    $t_3,$s_3,$e_2,$b_5                     # 94e
        andc    $hit_2,$hit_2,$disc_2                   # 95e
        fma     $cc_4,$cy_2,$cy_2,$cc_4                 # 96e
        rotmai  $hit_2,$hit_2,-31                       # 97e
        fma     $b_5,$cz_3,$dz_6,$b_10                  # 98e
        fma     $b_12,$cy_2,$dy_7,$b_9                  # 99e
        fnms    $e_5,$s_5,$y_2,$k_one                   # 100e
        selb    $t_best_5,$t_best_2,$t_2,$hit_2         # 101e
        selb    $nearest,$nearest_2,$object_4,$hit_2    # 102e
        lnop                                            # 102o pairing
        fma     $cc_11,$cy_2,$cy_2,$cc_8                # 103e
        stqd    $t_best_5,192($a_packet_5)              # 103o
        fma     $e_6,$e_4,$half,$whole                  # 104e
        stqd    $nearest,256($a_packet_5)               # 104o
        fms     $disc_2,$b_11,$b_11,$cc_10              # 105e
        lqd     $object_2,0($a_pair_3)                  # 105o
        fma     $cc,$cz_3,$cz_3,$cc_9                   # 106e
        hbrr    next_pair_back,next_pair                # 106o hint
        clgt    $hit,$t_best_3,$t_3                     # 107e
        lqd     $t_best_6,240($a_packet_4)              # 107o
        fma     $e_7,$e_5,$half,$whole                  # 108e
        lqd     $nearest_2,256($a_packet_3)             # 108o
        fma     $b,$cy_2,$dy_8,$b                       # 109e
        lqd     $t_best_2,192($a_packet_3)              # 109o
        andc    $hit,$hit,$disc_3                       # 110e
        lqd     $nearest_5,304($a_packet_4)             # 110o
        fnms    $t_4,$s_4,$e_6,$b_6                     # 111e
        frsqest $y,$disc_2                              # 111o
        fms     $disc_3,$b_5,$b_5,$cc                   # 112e
        rotqbii $hit,$hit,1                             # 112o
        fma     $cc,$cz_3,$cz_3,$cc_11                  # 113e
        rotqbyi $a_packet_2,$object_2,4                 # 113o
        fnms    $t_5,$s_5,$e_7,$b_8                     # 114e
        lqd     $quad_2,0($object_2)                    # 114o
        fma     $b_8,$cz_3,$dz_5,$b                     # 115e
        lnop                                            # 115o pairing
        fi      $y_6,$disc_2,$y                         # 116e
        gb      $hit_3,$hit                             # 116o
        clgt    $hit_4,$t_best_6,$t_4                   # 117e
        lnop                                            # 117o pairing
        fma     $b_6,$cz_3,$dz_7,$b_12                  # 118e
        frsqest $y,$disc_3                              # 118o
        fma     $cc_12,$cz_3,$cz_3,$cc_4                # 119e
        andc    $hit_5,$hit_4,$disc_4                   # 120e
next_pair:
            clgt    $hit,$t_best_4,$t_5                 # 0e
            lqd     $dx,16($a_packet_2)                 # 0o
            fi      $y,$disc_3,$y                       # 1e
            rotqbii $hit_5,$hit_5,1                     # 1o
            andc    $hit,$hit,$disc_5                   # 2e
            shufb   $cx,$quad_2,$quad_2,$m_x            # 2o
        ai      $count,$count,-1                        # 3e
            lqd     $dx_9,32($a_packet_2)               # 3o
            fms     $disc,$b_6,$b_6,$cc                 # 4e
            shufb   $radius2,$quad_2,$quad_2,$m_radius2 # 4o
            fm      $s,$disc_2,$y_6                     # 5e
            lqd     $dx_10,48($a_packet_2)              # 5o
            fms     $disc_5,$b_8,$b_8,$cc_12            # 6e
            shufb   $cy,$quad_2,$quad_2,$m_y            # 6o
            fm      $b,$cx,$dx                          # 7e
            rotqbii $hit,$hit,1                         # 7o
            fm      $s_6,$disc_3,$y                     # 8e
            lqd     $dy,80($a_packet_2)                 # 8o
            fms     $cc,$cx,$cx,$radius2                # 9e
            lqd     $dy_9,112($a_packet_2)              # 9o
            fm      $b_13,$cx,$dx_9                     # 10e
            lqd     $dy_3,96($a_packet_2)               # 10o
            fnms    $e,$s,$y_6,$k_one                   # 11e
            gb      $hit,$hit                           # 11o
            fms     $cc_2,$cx,$cx,$radius2              # 12e
            frsqest $y_7,$disc_5                        # 12o
            fms     $cc_3,$cx,$cx,$radius2              # 13e
            frsqest $y_8,$disc                          # 13o
            fm      $b_14,$cx,$dx_10                    # 14e
            lqd     $dx_2,0($a_packet_2)                # 14o
            fms     $cc_4,$cx,$cx,$radius2              # 15e
            shlqbii $hit,$hit,4                         # 15o
            fma     $cc,$cy,$cy,$cc                     # 16e
            lqd     $dz_2,128($a_packet_2)              # 16o
            fma     $e,$e,$half,$whole                  # 17e
            lqd     $dy_2,64($a_packet_2)               # 17o
            fi      $y_7,$disc_5,$y_7                   # 18e
            shufb   $cz_2,$quad_2,$quad_2,$m_z          # 18o
            fi      $y_8,$disc,$y_8                     # 19e
            lqx     $merge,$a_merges,$hit               # 19o
            nop     $127                                # 20e pairing
            shlqbii $hit,$hit_3,4                       # 20o
            fma     $cc_2,$cy,$cy,$cc_2                 # 21e
            gb      $hit_5,$hit_5                       # 21o
            fnms    $e_8,$s_6,$y,$k_one                 # 22e
            lqd     $dz_5,144($a_packet_2)              # 22o
            fnms    $t_2,$s,$e,$b_11                    # 23e
            lqd     $dz_4,176($a_packet_2)              # 23o
            fm      $b_7,$cx,$dx_2                      # 24e
            lqx     $merge_2,$a_merges,$hit             # 24o
            fma     $b_14,$cy,$dy_9,$b_14               # 25e
            shufb   $t_best_7,$t_best_4,$t_5,$merge     # 25o
            fma     $b_13,$cy,$dy_3,$b_13               # 26e
            shlqbii $hit,$hit_5,4                       # 26o
            fma     $cc_13,$cz_2,$cz_2,$cc_2            # 27e
            lqd     $dz_8,160($a_packet_2)              # 27o
            fma     $cc_2,$cy,$cy,$cc_3                 # 28e
            shufb   $nearest_6,$nearest_3,$object_5,$merge # 28o
            clgt    $hit_2,$t_best_2,$t_2               # 29e
            stqd    $t_best_7,208($a_packet_7)          # 29o
            fm      $s_5,$disc,$y_8                     # 30e
            shufb   $nearest_3,$nearest_4,$object_5,$merge_2 # 30o
            andc    $hit_2,$hit_2,$disc_2               # 31e
            lqx     $merge_3,$a_merges,$hit             # 31o
            fma     $e_8,$e_8,$half,$whole              # 32e
            shufb   $t_best_8,$t_best_3,$t_3,$merge_2   # 32o
            rotmai  $hit_2,$hit_2,-31                   # 33e
            stqd    $nearest_6,272($a_packet_7)         # 33o
            fma     $b_7,$cy,$dy_2,$b_7                 # 34e
            stqd    $nearest_3,288($a_packet_7)         # 34o
            fm      $s_7,$disc_5,$y_7                   # 35e
            lqd     $nearest_3,272($a_packet_9)         # 35o
            fma     $cc,$cz_2,$cz_2,$cc                 # 36e
            stqd    $t_best_8,224($a_packet_7)          # 36o
            selb    $t_best_8,$t_best_2,$t_2,$hit_2     # 37e
            lqd     $nearest_4,288($a_packet_9)         # 37o
            selb    $nearest,$nearest_2,$object_6,$hit_2 # 38e
            lqd     $t_best_3,224($a_packet_9)          # 38o
            fnms    $e_4,$s_5,$y_8,$k_one               # 39e
            lqd     $t_best_4,208($a_packet_9)          # 39o
            fma     $cc_4,$cy,$cy,$cc_4                 # 40e
            stqd    $t_best_8,192($a_packet_8)          # 40o
            fnms    $t_3,$s_6,$e_8,$b_5                 # 41e
            stqd    $nearest,256($a_packet_8)           # 41o
            fma     $b_11,$cz_2,$dz_2,$b_7              # 42e
            lqd     $nearest_2,256($a_packet_2)         # 42o
            fnms    $e_9,$s_7,$y_7,$k_one               # 43e
            shlqbyi $a_packet_8,$a_packet_2,0           # 43o copy
            fma     $b_5,$cz_2,$dz_8,$b_13              # 44e
            shufb   $nearest,$nearest_5,$object_5,$merge_3 # 44o
            fma     $e_7,$e_4,$half,$whole              # 45e
            shufb   $t_best,$t_best_6,$t_4,$merge_3     # 45o
            fma     $cc_12,$cz_2,$cz_2,$cc_4            # 46e
            shlqbyi $object_5,$object_6,0               # 46o copy
            fma     $b,$cy,$dy,$b                       # 47e
            shufb   $object_6,$object_2,$object_2,$m_x  # 47o
            fms     $disc_2,$b_11,$b_11,$cc_13          # 48e
            stqd    $nearest,304($a_packet_7)           # 48o
            clgt    $hit,$t_best_3,$t_3                 # 49e
            lqd     $nearest_5,304($a_packet_9)         # 49o
            fma     $e_2,$e_9,$half,$whole              # 50e
            stqd    $t_best,240($a_packet_7)            # 50o
            andc    $hit,$hit,$disc_3                   # 51e
            lqd     $t_best_6,240($a_packet_9)          # 51o
            fms     $disc_3,$b_5,$b_5,$cc               # 52e
        lqd     $object_2,0($a_pair)                    # 52o
            ori     $a_packet_7,$a_packet_6,0           # 53e copy
            shlqbyi $a_packet_6,$a_packet_2,0           # 53o copy
            fnms    $t_4,$s_5,$e_7,$b_6                 # 54e
            rotqbii $hit,$hit,1                         # 54o
            fma     $cc,$cz_2,$cz_2,$cc_2               # 55e
            frsqest $y,$disc_2                          # 55o
            fnms    $t_5,$s_7,$e_2,$b_8                 # 56e
            lqd     $t_best_2,192($a_packet_2)          # 56o
            fma     $b_8,$cz_2,$dz_5,$b                 # 57e
            shlqbyi $a_packet_9,$a_packet_2,0           # 57o copy
        ai      $a_pair,$a_pair,16                      # 58e
        lqd     $quad_2,0($object_2)                    # 58o
            fi      $y_6,$disc_2,$y                     # 59e
        rotqbyi $a_packet_2,$object_2,4                 # 59o
            clgt    $hit_5,$t_best_6,$t_4               # 60e
            frsqest $y,$disc_3                          # 60o
            fma     $b_6,$cz_2,$dz_4,$b_14              # 61e
            gb      $hit_3,$hit                         # 61o
            andc    $hit_5,$hit_5,$disc                 # 62e
next_pair_back:
        brnz    $count,next_pair                        # 62o
next_pair_drain:
        fms     $disc_6,$b_8,$b_8,$cc_12                # 0e
        lqd     $dx_2,0($a_packet_2)                    # 0o
        clgt    $hit,$t_best_4,$t_5                     # 1e
        shufb   $cx,$quad_2,$quad_2,$m_x                # 1o
        fm      $s,$disc_2,$y_6                         # 2e
        shufb   $radius2,$quad_2,$quad_2,$m_radius2     # 2o
        andc    $hit,$hit,$disc_5                       # 3e
        lqd     $dy_2,64($a_packet_2)                   # 3o
        fms     $disc,$b_6,$b_6,$cc                     # 4e
        shufb   $cy,$quad_2,$quad_2,$m_y                # 4o
        fi      $y,$disc_3,$y                           # 5e
        rotqbii $hit,$hit,1                             # 5o
        ori     $a_packet_10,$a_packet_6,0              # 6e copy
        frsqest $y_7,$disc_6                            # 6o
        fms     $cc_14,$cx,$cx,$radius2                 # 7e
        lqd     $dx,16($a_packet_2)                     # 7o
        fm      $b_14,$cx,$dx_2                         # 8e
        lqd     $dz_2,128($a_packet_2)                  # 8o
        fnms    $e,$s,$y_6,$k_one                       # 9e
        gb      $hit,$hit                               # 9o
        fi      $y_7,$disc_6,$y_7                       # 10e
        frsqest $y_9,$disc                              # 10o
        nop     $127                                    # 11e pairing
        rotqbii $hit_5,$hit_5,1                         # 11o
        fm      $s_6,$disc_3,$y                         # 12e
        shufb   $cz_2,$quad_2,$quad_2,$m_z              # 12o
        fma     $cc_2,$cy,$cy,$cc_14                    # 13e
        shlqbii $hit,$hit,4                             # 13o
        fma     $b_13,$cy,$dy_2,$b_14                   # 14e
        shlqbii $hit_6,$hit_3,4                         # 14o
        fma     $e,$e,$half,$whole                      # 15e
        lqd     $dy,80($a_packet_2)                     # 15o
        fm      $b,$cx,$dx                              # 16e
        gb      $hit_5,$hit_5                           # 16o
        fm      $s_7,$disc_6,$y_7                       # 17e
        lqx     $merge,$a_merges,$hit                   # 17o
        fms     $cc_15,$cx,$cx,$radius2                 # 18e
        lqx     $merge_2,$a_merges,$hit_6               # 18o
        fi      $y_8,$disc,$y_9                         # 19e
        lqd     $dx_10,32($a_packet_2)                  # 19o
        nop     $127                                    # 20e pairing
        lqd     $dx_3,48($a_packet_2)                   # 20o
        fma     $cc_16,$cz_2,$cz_2,$cc_2                # 21e
        lqd     $dz_5,144($a_packet_2)                  # 21o
        fma     $b_13,$cz_2,$dz_2,$b_13                 # 22e
        shlqbii $hit,$hit_5,4                           # 22o
        fnms    $e_2,$s_7,$y_7,$k_one                   # 23e
        shufb   $t_best_9,$t_best_4,$t_5,$merge         # 23o
        fnms    $t_2,$s,$e,$b_11                        # 24e
        shufb   $nearest_7,$nearest_3,$object_5,$merge  # 24o
        fnms    $e_8,$s_6,$y,$k_one                     # 25e
        lqd     $dy_3,112($a_packet_2)                  # 25o
        fma     $cc_15,$cy,$cy,$cc_15                   # 26e
        lqd     $dy_6,96($a_packet_2)                   # 26o
        fma     $b,$cy,$dy,$b                           # 27e
        lqd     $dz_4,176($a_packet_2)                  # 27o
        fm      $s_8,$disc,$y_8                         # 28e
        lqd     $dz_3,160($a_packet_2)                  # 28o
        fms     $disc_7,$b_13,$b_13,$cc_16              # 29e
        shufb   $nearest_3,$nearest_4,$object_5,$merge_2 # 29o
        fms     $cc,$cx,$cx,$radius2                    # 30e
        stqd    $t_best_9,208($a_packet_7)              # 30o
        fm      $b_14,$cx,$dx_10                        # 31e
        lqx     $merge_3,$a_merges,$hit                 # 31o
        fma     $e_2,$e_2,$half,$whole                  # 32e
        shufb   $t_best_8,$t_best_3,$t_3,$merge_2       # 32o
        clgt    $hit_2,$t_best_2,$t_2                   # 33e
        stqd    $nearest_7,272($a_packet_7)             # 33o
        fms     $cc_17,$cx,$cx,$radius2                 # 34e
        stqd    $nearest_3,288($a_packet_7)             # 34o
        fm      $b_3,$cx,$dx_3                          # 35e
        lqd     $nearest_3,272($a_packet_9)             # 35o
        andc    $hit_2,$hit_2,$disc_2                   # 36e
        stqd    $t_best_8,224($a_packet_7)              # 36o
        fma     $e_8,$e_8,$half,$whole                  # 37e
        frsqest $y_10,$disc_7                           # 37o
        fma     $cc_15,$cz_2,$cz_2,$cc_15               # 38e
        lqd     $t_best_4,208($a_packet_9)              # 38o
        fma     $b_7,$cz_2,$dz_5,$b                     # 39e
        lqd     $t_best_3,224($a_packet_9)              # 39o
        rotmai  $hit_2,$hit_2,-31                       # 40e
        lqd     $nearest_4,288($a_packet_9)             # 40o
        fnms    $e_4,$s_8,$y_8,$k_one                   # 41e
        shufb   $nearest,$nearest_5,$object_5,$merge_3  # 41o
        fma     $cc,$cy,$cy,$cc                         # 42e
        shufb   $t_best,$t_best_6,$t_4,$merge_3         # 42o
        fma     $b_14,$cy,$dy_6,$b_14                   # 43e
        shlqbyi $object_5,$object_6,0                   # 43o copy
        fnms    $t_5,$s_7,$e_2,$b_8                     # 44e
        shlqbyi $a_packet_11,$a_packet_2,0              # 44o copy
        fma     $b_3,$cy,$dy_3,$b_3                     # 45e
        shufb   $object_7,$object_2,$object_2,$m_x      # 45o
        fma     $cc_2,$cy,$cy,$cc_17                    # 46e
        shlqbyi $a_packet_12,$a_packet_2,0              # 46o copy
        selb    $t_best_8,$t_best_2,$t_2,$hit_2         # 47e
        shlqbyi $a_packet_6,$a_packet_2,0               # 47o copy
        fnms    $t_3,$s_6,$e_8,$b_5                     # 48e
        hbr     isect_pairs_paper_r16_return,$lr        # 48o hint
        fi      $y_11,$disc_7,$y_10                     # 49e
        stqd    $t_best_8,192($a_packet_8)              # 49o
        selb    $nearest_7,$nearest_2,$object_6,$hit_2  # 50e
        shlqbyi $object,$object_7,0                     # 50o copy
        fms     $disc_8,$b_7,$b_7,$cc_15                # 51e
        lnop                                            # 51o pairing
        fma     $e_10,$e_4,$half,$whole                 # 52e
        stqd    $nearest_7,256($a_packet_8)             # 52o
        fma     $cc,$cz_2,$cz_2,$cc                     # 53e
        lqd     $nearest_2,256($a_packet_2)             # 53o
        fma     $b_5,$cz_2,$dz_3,$b_14                  # 54e
        stqd    $nearest,304($a_packet_7)               # 54o
        clgt    $hit,$t_best_4,$t_5                     # 55e
        lqd     $nearest_5,304($a_packet_9)             # 55o
        fma     $cc_18,$cz_2,$cz_2,$cc_2                # 56e
        stqd    $t_best,240($a_packet_7)                # 56o
        fma     $b_3,$cz_2,$dz_4,$b_3                   # 57e
        frsqest $y_10,$disc_8                           # 57o
        andc    $hit,$hit,$disc_6                       # 58e
        lqd     $t_best_6,240($a_packet_9)              # 58o
        clgt    $hit_7,$t_best_3,$t_3                   # 59e
        lqd     $t_best_2,192($a_packet_2)              # 59o
        fm      $s,$disc_7,$y_11                        # 60e
        rotqbii $hit,$hit,1                             # 60o
        andc    $hit_7,$hit_7,$disc_3                   # 61e
        fnms    $t_4,$s_8,$e_10,$b_6                    # 62e
        fms     $disc_3,$b_5,$b_5,$cc                   # 63e
        rotqbii $hit_7,$hit_7,1                         # 63o
        fi      $y_7,$disc_8,$y_10                      # 64e
        gb      $hit,$hit                               # 64o
        ori     $a_packet_7,$a_packet_6,0               # 65e copy
        fms     $disc_9,$b_3,$b_3,$cc_18                # 66e
        fnms    $e,$s,$y_11,$k_one                      # 67e
        gb      $hit_3,$hit_7                           # 67o
        clgt    $hit_7,$t_best_6,$t_4                   # 68e
        shlqbii $hit,$hit,4                             # 68o
        frsqest $y,$disc_3                              # 69o
        andc    $hit_7,$hit_7,$disc                     # 70e
        fm      $s_7,$disc_8,$y_7                       # 71e
        shlqbii $hit_8,$hit_3,4                         # 71o
        nop     $127                                    # 72e pairing
        frsqest $y_8,$disc_9                            # 72o
        fi      $y,$disc_3,$y                           # 73e
        rotqbii $hit_7,$hit_7,1                         # 73o
        nop     $127                                    # 74e pairing
        lqx     $merge,$a_merges,$hit                   # 74o
        fma     $e,$e,$half,$whole                      # 75e
        lqx     $merge_2,$a_merges,$hit_8               # 75o
        fi      $y_8,$disc_9,$y_8                       # 76e
        gb      $hit_7,$hit_7                           # 77o
        fnms    $e_9,$s_7,$y_7,$k_one                   # 78e
        lnop                                            # 78o pairing
        fm      $s_9,$disc_3,$y                         # 80e
        shufb   $t_best_5,$t_best_4,$t_5,$merge         # 80o
        fnms    $t_2,$s,$e,$b_13                        # 81e
        shlqbii $hit,$hit_7,4                           # 81o
        nop     $127                                    # 82e pairing
        shufb   $nearest_8,$nearest_3,$object_5,$merge  # 82o
        fm      $s_10,$disc_9,$y_8                      # 83e
        shufb   $nearest_3,$nearest_4,$object_5,$merge_2 # 83o
        fma     $e_9,$e_9,$half,$whole                  # 84e
        stqd    $t_best_5,208($a_packet_10)             # 84o
        nop     $127                                    # 85e pairing
        lqx     $merge_3,$a_merges,$hit                 # 85o
        fnms    $e_8,$s_9,$y,$k_one                     # 86e
        shufb   $t_best_8,$t_best_3,$t_3,$merge_2       # 86o
        clgt    $hit_2,$t_best_2,$t_2                   # 87e
        stqd    $nearest_8,272($a_packet_10)            # 87o
        nop     $127                                    # 88e pairing
        stqd    $nearest_3,288($a_packet_10)            # 88o
        andc    $hit_2,$hit_2,$disc_7                   # 89e
        lqd     $nearest_3,272($a_packet_11)            # 89o
        fnms    $e_4,$s_10,$y_8,$k_one                  # 90e
        stqd    $t_best_8,224($a_packet_10)             # 90o
        rotmai  $hit_2,$hit_2,-31                       # 91e
        lqd     $t_best_4,208($a_packet_11)             # 91o
        fnms    $t_5,$s_7,$e_9,$b_7                     # 92e
        shufb   $nearest,$nearest_5,$object_5,$merge_3  # 92o
        fma     $e_8,$e_8,$half,$whole                  # 93e
        lqd     $nearest_4,288($a_packet_11)            # 93o
        nop     $127                                    # 94e pairing
        lqd     $t_best_3,224($a_packet_11)             # 94o
        selb    $t_best_8,$t_best_2,$t_2,$hit_2         # 95e
        shufb   $t_best,$t_best_6,$t_4,$merge_3         # 95o
        selb    $nearest_8,$nearest_2,$object_7,$hit_2  # 96e
        lnop                                            # 96o pairing
        fma     $e_9,$e_4,$half,$whole                  # 97e
        stqd    $t_best_8,192($a_packet_12)             # 97o
        clgt    $hit,$t_best_4,$t_5                     # 98e
        stqd    $nearest_8,256($a_packet_12)            # 98o
        fnms    $t_3,$s_9,$e_8,$b_5                     # 99e
        stqd    $nearest,304($a_packet_10)              # 99o
        andc    $hit,$hit,$disc_8                       # 100e
        lqd     $nearest_5,304($a_packet_11)            # 100o
        stqd    $t_best,240($a_packet_10)               # 101o
        rotqbii $hit,$hit,1                             # 102o
        fnms    $t_4,$s_10,$e_9,$b_3                    # 103e
        lqd     $t_best_6,240($a_packet_11)             # 103o
        clgt    $hit_5,$t_best_3,$t_3                   # 105e
        gb      $hit,$hit                               # 106o
        andc    $hit_5,$hit_5,$disc_3                   # 107e
        lnop                                            # 107o pairing
        clgt    $hit_7,$t_best_6,$t_4                   # 109e
        rotqbii $hit_5,$hit_5,1                         # 109o
        shlqbii $hit,$hit,4                             # 110o
        andc    $hit_7,$hit_7,$disc_9                   # 111e
        rotqbii $hit_7,$hit_7,1                         # 113o
        lqx     $merge,$a_merges,$hit                   # 114o
        gb      $hit_3,$hit_5                           # 115o
        gb      $hit_5,$hit_7                           # 117o
        shlqbii $hit,$hit_3,4                           # 119o
        shufb   $t_best_7,$t_best_4,$t_5,$merge         # 120o
        shlqbii $hit_5,$hit_5,4                         # 121o
        shufb   $nearest_6,$nearest_3,$object,$merge    # 122o
        lqx     $merge_2,$a_merges,$hit                 # 123o
        stqd    $t_best_7,208($a_packet_7)              # 124o
        lqx     $merge_3,$a_merges,$hit_5               # 125o
        stqd    $nearest_6,272($a_packet_7)             # 126o
        shufb   $nearest_3,$nearest_4,$object,$merge_2  # 129o
        shufb   $t_best_8,$t_best_3,$t_3,$merge_2       # 130o
        shufb   $nearest,$nearest_5,$object,$merge_3    # 131o
        shufb   $t_best,$t_best_6,$t_4,$merge_3         # 132o
        stqd    $nearest_3,288($a_packet_7)             # 133o
        stqd    $t_best_8,224($a_packet_7)              # 134o
        stqd    $nearest,304($a_packet_7)               # 135o
        stqd    $t_best,240($a_packet_7)                # 136o
        nop     $127                                    # 137e pairing
isect_pairs_paper_r16_return:
        bi      $lr                                     # 137o
next_pair_short:
        ai      $count,$count,-1                        # 0e
        lqd     $object,0($a_pair)                      # 0o
        ai      $a_pair,$a_pair,16                      # 1e
        rotqbyi $a_packet,$object,4                     # 6o
        lqd     $quad,0($object)                        # 7o
        shufb   $object,$object,$object,$m_x            # 8o
        lqd     $dx,32($a_packet)                       # 10o
        lqd     $dx_11,48($a_packet)                    # 11o
        lqd     $dx_9,16($a_packet)                     # 12o
        shufb   $cx,$quad,$quad,$m_x                    # 13o
        shufb   $radius2,$quad,$quad,$m_radius2         # 14o
        lqd     $dy,96($a_packet)                       # 15o
        nop     $127                                    # 16e pairing
        lqd     $dy_10,112($a_packet)                   # 16o
        fm      $b,$cx,$dx                              # 17e
        lqd     $dy_11,80($a_packet)                    # 17o
        fms     $cc,$cx,$cx,$radius2                    # 18e
        shufb   $cy,$quad,$quad,$m_y                    # 18o
        fm      $b_13,$cx,$dx_9                         # 19e
        lqd     $dz,160($a_packet)                      # 19o
        fms     $cc_19,$cx,$cx,$radius2                 # 20e
        lqd     $dz_9,176($a_packet)                    # 20o
        fm      $b_12,$cx,$dx_11                        # 21e
        lqd     $dz_10,144($a_packet)                   # 21o
        fms     $cc_20,$cx,$cx,$radius2                 # 22e
        lqd     $dx_6,0($a_packet)                      # 22o
        fma     $b,$cy,$dy,$b                           # 23e
        shufb   $cz_4,$quad,$quad,$m_z                  # 23o
        fma     $cc,$cy,$cy,$cc                         # 24e
        lqd     $dy,64($a_packet)                       # 24o
        fma     $b_13,$cy,$dy_11,$b_13                  # 25e
        lqd     $dz_11,128($a_packet)                   # 25o
        fma     $cc_19,$cy,$cy,$cc_19                   # 26e
        lqd     $t_best_10,224($a_packet)               # 26o
        fma     $b_12,$cy,$dy_10,$b_12                  # 27e
        lqd     $t_best_11,208($a_packet)               # 27o
        fma     $cc_20,$cy,$cy,$cc_20                   # 28e
        lqd     $t_best_12,240($a_packet)               # 28o
        fma     $b,$cz_4,$dz,$b                         # 29e
        lqd     $t_best_8,192($a_packet)                # 29o
        fma     $cc,$cz_4,$cz_4,$cc                     # 30e
        lqd     $nearest_9,288($a_packet)               # 30o
        fma     $b_13,$cz_4,$dz_10,$b_13                # 31e
        lqd     $nearest_6,272($a_packet)               # 31o
        fma     $cc_19,$cz_4,$cz_4,$cc_19               # 32e
        lqd     $nearest_10,304($a_packet)              # 32o
        fma     $b_12,$cz_4,$dz_9,$b_12                 # 33e
        lqd     $nearest_11,256($a_packet)              # 33o
        fma     $cc_20,$cz_4,$cz_4,$cc_20               # 34e
        fms     $cc_4,$cx,$cx,$radius2                  # 35e
        fm      $b_7,$cx,$dx_6                          # 36e
        fms     $disc_10,$b_13,$b_13,$cc                # 37e
        fms     $disc_11,$b,$b,$cc_19                   # 38e
        fms     $disc_12,$b_12,$b_12,$cc_20             # 40e
        fma     $cc,$cy,$cy,$cc_4                       # 41e
        fma     $b_7,$cy,$dy,$b_7                       # 42e
        frsqest $y_12,$disc_10                          # 43o
        frsqest $y_4,$disc_11                           # 44o
        frsqest $y_13,$disc_12                          # 46o
        fi      $y_12,$disc_10,$y_12                    # 47e
        fi      $y_4,$disc_11,$y_4                      # 48e
        fma     $cc,$cz_4,$cz_4,$cc                     # 50e
        fi      $y_13,$disc_12,$y_13                    # 51e
        fma     $b_3,$cz_4,$dz_11,$b_7                  # 53e
        fm      $s_8,$disc_10,$y_12                     # 54e
        fm      $s_11,$disc_11,$y_4                     # 55e
        fm      $s_12,$disc_12,$y_13                    # 58e
        fms     $disc_13,$b_3,$b_3,$cc                  # 59e
        fnms    $e_10,$s_8,$y_12,$k_one                 # 60e
        fnms    $e_3,$s_11,$y_4,$k_one                  # 61e
        fnms    $e_11,$s_12,$y_13,$k_one                # 64e
        frsqest $y_14,$disc_13                          # 65o
        fma     $e_10,$e_10,$half,$whole                # 66e
        fma     $e_3,$e_3,$half,$whole                  # 67e
        fi      $y_14,$disc_13,$y_14                    # 69e
        fma     $e_11,$e_11,$half,$whole                # 71e
        fnms    $t_6,$s_8,$e_10,$b_13                   # 72e
        fnms    $t_7,$s_11,$e_3,$b                      # 73e
        fm      $s_11,$disc_13,$y_14                    # 76e
        fnms    $t_8,$s_12,$e_11,$b_12                  # 77e
        clgt    $hit,$t_best_11,$t_6                    # 78e
        clgt    $hit_9,$t_best_10,$t_7                  # 79e
        andc    $hit,$hit,$disc_10                      # 80e
        andc    $hit_8,$hit_9,$disc_11                  # 81e
        fnms    $e,$s_11,$y_14,$k_one                   # 82e
        rotqbii $hit,$hit,1                             # 82o
        clgt    $hit_9,$t_best_12,$t_8                  # 83e
        rotqbii $hit_8,$hit_8,1                         # 83o
        andc    $hit_9,$hit_9,$disc_12                  # 85e
        gb      $hit,$hit                               # 86o
        nop     $127                                    # 87e pairing
        rotqbii $hit_9,$hit_9,1                         # 87o
        fma     $e,$e,$half,$whole                      # 88e
        gb      $hit_8,$hit_8                           # 88o
        shlqbii $hit,$hit,4                             # 90o
        gb      $hit_9,$hit_9                           # 91o
        nop     $127                                    # 92e pairing
        shlqbii $hit_8,$hit_8,4                         # 92o
        fnms    $t,$s_11,$e,$b_3                        # 94e
        lqx     $merge,$a_merges,$hit                   # 94o
        shlqbii $hit,$hit_9,4                           # 95o
        lqx     $merge_4,$a_merges,$hit_8               # 96o
        nop     $127                                    # 97e pairing
        lqx     $merge_5,$a_merges,$hit                 # 99o
        clgt    $hit,$t_best_8,$t                       # 100e
        shufb   $nearest_12,$nearest_6,$object,$merge   # 100o
        nop     $127                                    # 101e pairing
        shufb   $t_best,$t_best_11,$t_6,$merge          # 101o
        andc    $hit,$hit,$disc_13                      # 102e
        shufb   $t_best_13,$t_best_10,$t_7,$merge_4     # 102o
        nop     $127                                    # 103e pairing
        shufb   $nearest,$nearest_9,$object,$merge_4    # 103o
        rotmai  $hit,$hit,-31                           # 104e
        stqd    $nearest_12,272($a_packet)              # 104o
        shufb   $nearest_13,$nearest_10,$object,$merge_5 # 105o
        shufb   $t_best_14,$t_best_12,$t_8,$merge_5     # 106o
        nop     $127                                    # 107e pairing
        stqd    $t_best,208($a_packet)                  # 107o
        selb    $t_best,$t_best_8,$t,$hit               # 108e
        stqd    $t_best_13,224($a_packet)               # 108o
        selb    $nearest_14,$nearest_11,$object,$hit    # 109e
        stqd    $nearest_13,304($a_packet)              # 109o
        stqd    $t_best_14,240($a_packet)               # 110o
        stqd    $t_best,192($a_packet)                  # 111o
        stqd    $nearest,288($a_packet)                 # 112o
        stqd    $nearest_14,256($a_packet)              # 113o
        nop     $127                                    # 114e pairing
        brnz    $count,next_pair_short                  # 114o
        nop     $127                                    # 115e pairing
        bi      $lr                                     # 115o
endfunction isect_pairs_paper_r16
