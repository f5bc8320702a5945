# isect_sphere_pairs_refined_r16   nearest hit of packets' rays with spheres, to the last digits
#   C       void isect_sphere_pairs_refined_r16(const struct candidate *, int count);
#   In      $3 candidates of objects that are spheres, $4 count (0 is none); pointers 16-aligned
#   Out     the candidates' packets: t, object, where a hit has 0 < t < what was there
#   Uses    $2-$75, $79   Saves  -   Stack  0   Calls  -
#   Domain  |d| = 1 within 4 ulp; coordinates and radius below 2^62, radius above 2^-38
#   Error   8 ulp of the larger of t and r, origin up to 30 radii from the centre, ray within 0.9 r
#           of it
#   Twin    lab/twins/src/sphere/refined.rs
#
# The steps are in sphere_tmpl.inc. The hit is the entry; with SIDES_EXIT it is the exit, and with
# SIDES_BOTH it is also the exit of a ray from inside.
# Scheduled by spu schedule from isect_sphere_pairs_refined_r16.s

        .include "sphere_general.inc"
        .include "sphere_refined.inc"

        general_registers "k_one,k_two,k_half", "radius2", "out,y,s,e,rest"
        sign_controls_table
        sides_tables REFINED_STEP, REFINED_ROOT

function isect_sphere_pairs_refined_r16
        .set count_2,79; .set a_candidate_2,2; .set object_2,7; .set object_3,58; .set quad_2,8
        .set a_packet_2,2; .set sides_2,5; .set quad_3,6; .set sides_3,9; .set ox_2,20
        .set dx_2,22; .set quad_4,21; .set oy_2,6; .set ox_3,23; .set cx_2,35; .set cy_2,37
        .set ox_4,24; .set dy_2,25; .set fx_2,27; .set cz_2,29; .set oz_2,8; .set fy_2,70
        .set fx_3,6; .set dy_3,30; .set fx_4,20; .set dx_3,23; .set b_2,26; .set oy_3,24
        .set radius2_2,28; .set dx_4,31; .set fz_2,67; .set fy_3,8; .set b_3,32; .set oz_3,35
        .set dy_4,38; .set fy_4,24; .set dy_5,43; .set dz_2,44; .set dz_3,46; .set b_4,47
        .set dz_4,49; .set fz_3,68; .set radius2_3,33; .set sides_4,50; .set fz_4,71
        .set a_packet_3,64; .set b_5,45; .set radius2_4,72; .set b_6,28; .set b_7,5; .set oz_4,42
        .set oz_5,32; .set oz_6,47; .set oy_4,51; .set nearest_2,54; .set nearest_3,55; .set b_8,52
        .set t_best_2,56; .set disc_2,5; .set nearest_4,59; .set t_best_3,61; .set fy_5,22
        .set t_best_4,53; .set disc_3,27; .set nearest_5,63; .set fx_5,65; .set ox_5,6
        .set t_best_5,62; .set disc_4,66; .set ox_6,5; .set rest_2,21; .set object_4,57
        .set fz_5,7; .set a_packet_4,60; .set rest_3,2; .set disc_5,23; .set rest_4,24
        .set disc_6,25; .set disc_7,20; .set fz_6,22; .set disc_8,8; .set disc_9,30; .set rest_5,25
        .set y_2,7; .set rest_6,27; .set disc_10,2; .set y_3,34; .set sides_5,69; .set disc_11,65
        .set m_by_side_2,44; .set out_2,2; .set whole_2,50; .set half_2,22; .set out_3,30
        .set y_4,31; .set out_4,8; .set y_5,21; .set y_6,20; .set s_2,7; .set out_5,9; .set s_3,32
        .set fx_6,2; .set s_4,5; .set e_2,6; .set s_5,8; .set e_3,5; .set ox_7,9; .set dx_5,21
        .set fx_7,9; .set rest_7,6; .set rest_8,5; .set b_9,7; .set t_2,8; .set t_3,6; .set t_4,5
        .set control_2,25; .set control_3,27; .set ahead_2,29; .set control_4,31; .set dy_6,33
        .set control_5,29; .set fy_6,31; .set dy_7,32; .set dz_5,37; .set dz_6,38; .set dz_7,43
        .set t_best_6,42; .set nearest_6,7; .set control_6,7; .set fy_7,25; .set disc_12,29
        .set fz_7,20; .set fz_8,42; .set t_best_7,5; .set nearest_7,46; .set disc_13,7
        .set rest_9,23; .set nearest_8,29; .set disc_14,9; .set t_best_8,6; .set t_best_9,8
        .set rest_10,8; .set y_7,6; .set quad_5,5; .set sides_6,7; .set oz_7,9; .set oz_8,20
        .set radius2_5,21; .set y_8,33; .set ox_8,3; .set oy_5,4; .set dx_6,5; .set s_6,6
        .set dy_8,11; .set e_4,12; .set fx_8,3; .set oy_6,34; .set ox_9,4; .set dy_9,7; .set e_5,21
        .set dx_7,29; .set b_10,33; .set oy_7,38; .set dx_8,47; .set fy_8,34; .set fx_9,4
        .set t_5,26; .set dy_10,48; .set dz_8,51; .set fy_9,15; .set b_11,38; .set m_by_side_3,19
        .set object_5,10; .set a_packet_5,58; .set b_12,73; .set ahead_3,74; .set control_7,75
        .set control_8,74; .set e_6,20; .set disc_15,75; .set rest_11,3; .set fy_10,5
        .set rest_12,31; .set control_9,23; .set disc_16,34; .set control_10,11; .set rest_13,7
        .set fz_9,23; .set disc_17,31; .set rest_14,15; .set disc_18,4; .set fy_11,29
        .set rest_15,34; .set t_best_10,26; .set nearest_9,11; .set y_9,5; .set whole_3,11
        .set disc_19,18; .set half_3,17; .set y_10,22; .set s_7,23; .set rest_16,20; .set t_6,12
        .set out_6,18; .set s_8,22; .set y_11,23; .set s_9,18; .set e_7,3; .set control_11,18
        .set out_7,21; .set out_8,24; .set nearest_10,25; .set s_10,21; .set e_8,13
        .set control_12,6; .set t_best_11,7; .set e_9,8; .set s_11,9; .set t_7,3; .set t_best_12,11
        .set s_12,12; .set nearest_11,13; .set rest_17,9; .set nearest_12,2; .set ox_10,2
        .set oy_8,7; .set dx_9,8; .set dx_10,9; .set dy_11,22; .set fy_12,7; .set oz_9,28
        .set dy_12,29; .set b_13,30; .set fx_10,23; .set oy_9,31; .set dz_9,33; .set fz_10,28
        .set dy_13,37; .set oz_10,43; .set oz_11,44; .set dz_10,45; .set fy_13,32; .set b_14,31
        .set t_best_13,47; .set fz_11,43; .set t_best_14,48; .set t_best_15,49; .set nearest_13,50
        .set fz_12,25; .set t_best_16,44; .set nearest_14,51; .set nearest_15,52
        .set nearest_16,53; .set half_4,54; .set whole_4,55; .set m_by_side_4,27; .set disc_20,39
        .set disc_21,6; .set disc_22,22; .set y_12,25; .set out_9,26; .set y_13,28; .set s_13,25
        .set out_10,28; .set y_14,29; .set out_11,32; .set e_10,34; .set e_11,22; .set y_15,26
        .set e_12,24; .set s_14,29; .set s_15,33; .set t_8,7; .set control_13,26; .set ahead_4,27
        .set control_14,22; .set ahead_5,24; .set control_15,24; .set control_16,2; .set t_9,9
        .set ahead_6,23; .set ahead_7,25; .set t_best_17,2; .set control_17,5; .set nearest_17,5
        nop     $127                                    # 0e pairing
        biz     $count,$lr                              # 0o
        ilhu    $m_x,1                                  # 1e
        ilhu    $m_y,0x405                              # 2e
        ilhu    $m_z,0x809                              # 3e
        ilhu    $k_one,0x3f80                           # 4e
        ilhu    $k_two,0x4000                           # 5e
        clgti   $count_2,$count,2                       # 6e at least as many passes as overlap
        iohl    $m_x,515                                # 7e
        iohl    $m_y,0x607                              # 8e
        iohl    $m_z,0xa0b                              # 9e
        ila     $a_controls,sign_controls               # 10e
        ila     $a_half,half_by_sides                   # 11e
        ila     $a_whole,whole_by_sides                 # 12e
        ila     $a_by_side,m_by_sides                   # 13e
        iohl    $k_one,1                                # 14e
        iohl    $k_two,1                                # 15e
        lnop                                            # 15o pairing
        ilhu    $k_half,0x3f00                          # 16e
        brz     $count_2,next_ball_short                # 16o too few passes
        ai      $a_candidate_2,$a_candidate,16          # 17e
        lqd     $object_2,0($a_candidate)               # 17o
        ai      $count,$count,-1                        # 18e
        lnop                                            # 18o pairing
        ai      $a_candidate,$a_candidate_2,16          # 19e
        lqd     $object_3,0($a_candidate_2)             # 19o
        ai      $count,$count,-1                        # 20e
        lqd     $quad_2,0($object_2)                    # 23o
        rotqbyi $a_packet_2,$object_2,4                 # 24o
        lqd     $sides_2,32($object_2)                  # 25o
        lqd     $quad_3,0($object_3)                    # 26o
        lqd     $sides_3,32($object_3)                  # 27o
        nop     $127                                    # 28e pairing
        lqd     $ox,48($a_packet_2)                     # 28o
        fm      $quad_2,$quad_2,$k_half                 # 29e
        lqd     $oy,112($a_packet_2)                    # 29o
        lqd     $ox_2,32($a_packet_2)                   # 30o
        lqd     $dx_2,240($a_packet_2)                  # 31o
        fm      $quad_4,$quad_3,$k_half                 # 32e
        lqd     $oy_2,96($a_packet_2)                   # 32o
        lqd     $dx,224($a_packet_2)                    # 33o
        lqd     $ox_3,16($a_packet_2)                   # 34o
        shufb   $cx_2,$quad_2,$quad_2,$m_x              # 35o
        shufb   $cy_2,$quad_2,$quad_2,$m_y              # 36o
        lqd     $ox_4,0($a_packet_2)                    # 37o
        lqd     $dy_2,304($a_packet_2)                  # 38o
        fnms    $fx_2,$ox,$k_half,$cx_2                 # 39e
        shufb   $cz_2,$quad_2,$quad_2,$m_z              # 39o
        fnms    $fy,$oy,$k_half,$cy_2                   # 40e
        lqd     $oz,176($a_packet_2)                    # 40o
        fnms    $fx,$ox_2,$k_half,$cx_2                 # 41e
        lqd     $oz_2,160($a_packet_2)                  # 41o
        fnms    $fy_2,$oy_2,$k_half,$cy_2               # 42e
        lqd     $oy,80($a_packet_2)                     # 42o
        fnms    $fx_3,$ox_4,$k_half,$cx_2               # 43e
        lqd     $dy_3,288($a_packet_2)                  # 43o
        fnms    $fx_4,$ox_3,$k_half,$cx_2               # 44e
        lqd     $dx_3,208($a_packet_2)                  # 44o
        fm      $b_2,$fx_2,$dx_2                        # 45e
        lqd     $oy_3,64($a_packet_2)                   # 45o
        fnms    $fz,$oz,$k_half,$cz_2                   # 46e
        shufb   $radius2_2,$sides_2,$sides_2,$m_x       # 46o
        fm      $b,$fx,$dx                              # 47e
        lqd     $dx_4,192($a_packet_2)                  # 47o
        fnms    $fz_2,$oz_2,$k_half,$cz_2               # 48e
        lqd     $dz,368($a_packet_2)                    # 48o
        fnms    $fy_3,$oy,$k_half,$cy_2                 # 49e
        lqd     $oz,144($a_packet_2)                    # 49o
        fm      $b_3,$fx_4,$dx_3                        # 50e
        lqd     $oz_3,128($a_packet_2)                  # 50o
        fma     $b_2,$fy,$dy_2,$b_2                     # 51e
        lqd     $dy_4,272($a_packet_2)                  # 51o
        fnms    $fy_4,$oy_3,$k_half,$cy_2               # 52e
        lqd     $dy_5,256($a_packet_2)                  # 52o
        fma     $b,$fy_2,$dy_3,$b                       # 53e
        lqd     $dz_2,352($a_packet_2)                  # 53o
        fm      $radius2_2,$radius2_2,$k_half           # 54e
        lqd     $dz_3,320($a_packet_2)                  # 54o
        fm      $b_4,$fx_3,$dx_4                        # 55e
        lqd     $dz_4,336($a_packet_2)                  # 55o
        fnms    $fz_3,$oz,$k_half,$cz_2                 # 56e
        shufb   $radius2_3,$sides_3,$sides_3,$m_x       # 56o
        fma     $b_2,$fz,$dz,$b_2                       # 57e
        rotqbyi $sides_4,$sides_2,12                    # 57o
        fnms    $fz_4,$oz_3,$k_half,$cz_2               # 58e
        rotqbyi $a_packet_3,$object_3,4                 # 58o
        fma     $b_5,$fz_2,$dz_2,$b                     # 59e
        shufb   $cy_2,$quad_4,$quad_4,$m_y              # 59o
        fm      $radius2_4,$radius2_2,$radius2_2        # 60e
        shufb   $cz_2,$quad_4,$quad_4,$m_z              # 60o
        fma     $b_6,$fy_4,$dy_5,$b_4                   # 61e
        rotqbyi $sides_3,$sides_3,12                    # 61o
        fma     $b_7,$fy_3,$dy_4,$b_3                   # 62e
        lqd     $oz_4,128($a_packet_3)                  # 62o
        fnms    $fx_2,$b_2,$dx_2,$fx_2                  # 63e
        lqd     $oz_5,144($a_packet_3)                  # 63o
        fnms    $fy,$b_2,$dy_2,$fy                      # 64e
        lqd     $oz_6,160($a_packet_3)                  # 64o
        fnms    $fx,$b_5,$dx,$fx                        # 65e
        lqd     $oy_4,96($a_packet_3)                   # 65o
        fnms    $fz,$b_2,$dz,$fz                        # 66e
        lqd     $nearest_2,496($a_packet_2)             # 66o
        fma     $b_6,$fz_4,$dz_3,$b_6                   # 67e
        lqd     $nearest_3,448($a_packet_2)             # 67o
        fma     $b_8,$fz_3,$dz_4,$b_7                   # 68e
        lqd     $t_best_2,384($a_packet_2)              # 68o
        fnms    $disc_2,$fx_2,$fx_2,$radius2_4          # 69e
        lqd     $nearest_4,480($a_packet_2)             # 69o
        fm      $rest,$fx_2,$dx_2                       # 70e
        lqd     $t_best_3,400($a_packet_2)              # 70o
        fnms    $fy_5,$b_5,$dy_3,$fy_2                  # 71e
        lqd     $t_best_4,432($a_packet_2)              # 71o
        fnms    $disc_3,$fx,$fx,$radius2_4              # 72e
        lqd     $nearest_5,464($a_packet_2)             # 72o
        fnms    $fx_5,$b_6,$dx_4,$fx_3                  # 73e
        lqd     $ox_5,0($a_packet_3)                    # 73o
        fnms    $fx_4,$b_8,$dx_3,$fx_4                  # 74e
        lqd     $t_best_5,416($a_packet_2)              # 74o
        fnms    $disc_4,$fy,$fy,$disc_2                 # 75e
        shufb   $cx_2,$quad_4,$quad_4,$m_x              # 75o
        fma     $rest,$fy,$dy_2,$rest                   # 76e
        lqd     $ox_6,32($a_packet_3)                   # 76o
        fm      $rest_2,$fx,$dx                         # 77e
        shufb   $object_4,$object_2,$object_2,$m_x      # 77o
        fnms    $fz_5,$b_5,$dz_2,$fz_2                  # 78e
        shlqbyi $a_packet_4,$a_packet_2,0               # 78o copy
        fnms    $fy,$b_6,$dy_5,$fy_4                    # 79e
        fm      $rest_3,$fx_4,$dx_3                     # 80e
        fnms    $disc_5,$fz,$fz,$disc_4                 # 81e
        fma     $rest,$fz,$dz,$rest                     # 82e
        fm      $rest_4,$fx_5,$dx_4                     # 83e
        fnms    $disc_6,$fx_5,$fx_5,$radius2_4          # 84e
        fnms    $disc_7,$fx_4,$fx_4,$radius2_4          # 85e
        fnms    $disc_3,$fy_5,$fy_5,$disc_3             # 86e
        fnms    $fy_3,$b_8,$dy_4,$fy_3                  # 87e
        fma     $rest_2,$fy_5,$dy_3,$rest_2             # 88e
        fnms    $fz_6,$b_8,$dz_4,$fz_3                  # 89e
        fnms    $fz,$b_6,$dz_3,$fz_4                    # 90e
        fma     $disc_5,$rest,$rest,$disc_5             # 91e
        fma     $rest_4,$fy,$dy_5,$rest_4               # 92e
        fma     $rest_3,$fy_3,$dy_4,$rest_3             # 93e
        fnms    $disc_8,$fy_3,$fy_3,$disc_7             # 94e
        fnms    $disc_7,$fy,$fy,$disc_6                 # 95e
        fnms    $disc_9,$fz_5,$fz_5,$disc_3             # 96e
        fma     $rest_5,$fz_5,$dz_2,$rest_2             # 97e
        frsqest $y_2,$disc_5                            # 97o
        fma     $rest_6,$fz,$dz_3,$rest_4               # 98e
        fma     $rest_4,$fz_6,$dz_4,$rest_3             # 99e
        fnms    $disc_10,$fz_6,$fz_6,$disc_8            # 100e
        fnms    $disc,$fz,$fz,$disc_7                   # 101e
        fi      $y_3,$disc_5,$y_2                       # 102e
        rotmi   $sides_5,$sides_4,-26                   # 103e
        fma     $disc_4,$rest_5,$rest_5,$disc_9         # 104e
        fm      $radius2_3,$radius2_3,$k_half           # 105e
        fma     $disc_11,$rest_4,$rest_4,$disc_10       # 106e
        lnop                                            # 106o pairing
        fma     $disc,$rest_6,$rest_6,$disc             # 107e
        lqx     $m_by_side_2,$a_by_side,$sides_5        # 107o
        fms     $out_2,$b_2,$b_2,$disc_5                # 108e
        lqx     $whole_2,$a_whole,$sides_5              # 108o
        fm      $s,$disc_5,$y_3                         # 109e
        lqx     $half_2,$a_half,$sides_5                # 109o
        fms     $out_3,$b_5,$b_5,$disc_4                # 110e
        frsqest $y_4,$disc_4                            # 110o
        fnms    $fz_3,$oz_5,$k_half,$cz_2               # 111e
        lnop                                            # 111o pairing
        fms     $out_4,$b_8,$b_8,$disc_11               # 112e
        frsqest $y_2,$disc_11                           # 112o
        fnms    $fz_2,$oz_6,$k_half,$cz_2               # 113e
        frsqest $y_5,$disc                              # 113o
        fi      $y_4,$disc_4,$y_4                       # 114e
        rotmi   $sides_5,$sides_3,-26                   # 115e
        fi      $y_6,$disc_11,$y_2                      # 116e
        fi      $y_5,$disc,$y_5                         # 117e
        selb    $s_2,$s,$out_2,$m_by_side_2             # 118e
        fms     $out_5,$b_6,$b_6,$disc                  # 119e
        fnms    $fy_2,$oy_4,$k_half,$cy_2               # 120e
        fm      $s_3,$disc_4,$y_4                       # 121e
        fnms    $e,$s,$y_3,$k_one                       # 122e
        fnms    $fz_4,$oz_4,$k_half,$cz_2               # 123e
        fm      $radius2_4,$radius2_3,$radius2_3        # 124e
        lnop                                            # 124o pairing
next_ball:
            fnms    $fx,$ox_6,$k_half,$cx_2             # 0e
            lqd     $dx,224($a_packet_3)                # 0o
            fma     $e,$e,$half_2,$whole_2              # 1e
            fnms    $fx_6,$ox_5,$k_half,$cx_2           # 2e
            fm      $s,$disc_11,$y_6                    # 3e
            fm      $s_4,$disc,$y_5                     # 4e
            fnms    $e_2,$s_3,$y_4,$k_one               # 5e
            fm      $b,$fx,$dx                          # 6e
            fnms    $rest,$s_2,$e,$rest                 # 7e
            selb    $s_2,$s_3,$out_3,$m_by_side_2       # 8e
            selb    $s_5,$s,$out_4,$m_by_side_2         # 9e
            lqd     $ox,48($a_packet_3)                 # 9o
            fnms    $e,$s,$y_6,$k_one                   # 10e
            lnop                                        # 10o pairing
            selb    $s,$s_4,$out_5,$m_by_side_2         # 11e
            lqd     $oy,112($a_packet_3)                # 11o
            fnms    $e_3,$s_4,$y_5,$k_one               # 12e
            lnop                                        # 12o pairing
            fma     $e_2,$e_2,$half_2,$whole_2          # 13e
            lqd     $ox_7,16($a_packet_3)               # 13o
            fma     $t,$b_2,$k_two,$rest                # 14e
            fnms    $fx_4,$ox,$k_half,$cx_2             # 15e
            fma     $e,$e,$half_2,$whole_2              # 16e
            fnms    $fy,$oy,$k_half,$cy_2               # 17e
            fma     $e_3,$e_3,$half_2,$whole_2          # 18e
            lqd     $dx_5,208($a_packet_3)              # 18o
            fnms    $fx_7,$ox_7,$k_half,$cx_2           # 19e
            lqd     $oz,176($a_packet_3)                # 19o
            cgti    $ahead,$t,0                         # 20e
            fnms    $rest,$s_2,$e_2,$rest_5             # 21e
            fnms    $rest_7,$s_5,$e,$rest_4             # 22e
            cgt     $control,$t_best_4,$t               # 23e
            fnms    $rest_8,$s,$e_3,$rest_6             # 24e
            fm      $b_9,$fx_7,$dx_5                    # 25e
            fnms    $fz,$oz,$k_half,$cz_2               # 26e
            lqd     $oy,80($a_packet_3)                 # 26o
            fma     $t_2,$b_5,$k_two,$rest              # 27e
            lnop                                        # 27o pairing
            fma     $t_3,$b_8,$k_two,$rest_7            # 28e
            lqd     $dx_2,240($a_packet_3)              # 28o
            and     $control,$control,$ahead            # 29e
            fma     $t_4,$b_6,$k_two,$rest_8            # 30e
            andc    $control,$control,$disc_5           # 31e
            lqd     $dx_3,192($a_packet_3)              # 31o
            fnms    $fy_4,$oy,$k_half,$cy_2             # 32e
            lnop                                        # 32o pairing
            cgt     $control_2,$t_best_5,$t_2           # 33e
            rotqbii $control,$control,1                 # 33o
            fm      $b_2,$fx_4,$dx_2                    # 34e
            lnop                                        # 34o pairing
            cgti    $ahead,$t_3,0                       # 35e
            lqd     $dy,304($a_packet_3)                # 35o
            cgt     $control_3,$t_best_3,$t_3           # 36e
            lqd     $oy,64($a_packet_3)                 # 36o
            fm      $b_6,$fx_6,$dx_3                    # 37e
            gb      $control,$control                   # 37o
            cgti    $ahead_2,$t_4,0                     # 38e
            lqd     $dz,368($a_packet_3)                # 38o
            and     $control_3,$control_3,$ahead        # 39e
            lqd     $dy_3,288($a_packet_3)              # 39o
            cgt     $control_4,$t_best_2,$t_4           # 40e
            lqd     $dy_6,272($a_packet_3)              # 40o
            fma     $b_2,$fy,$dy,$b_2                   # 41e
            shlqbii $control,$control,4                 # 41o
            and     $control_5,$control_4,$ahead_2      # 42e
            lnop                                        # 42o pairing
            fnms    $fy_6,$oy,$k_half,$cy_2             # 43e
            lqd     $dy_7,256($a_packet_3)              # 43o
            andc    $control_5,$control_5,$disc         # 44e
            lqd     $dz_5,352($a_packet_3)              # 44o
            fma     $b,$fy_2,$dy_3,$b                   # 45e
            lqx     $control,$control,$a_controls       # 45o
            fma     $b_9,$fy_4,$dy_6,$b_9               # 46e
            rotqbii $control_5,$control_5,1             # 46o
            fma     $b_2,$fz,$dz,$b_2                   # 47e
            lqd     $dz_6,336($a_packet_3)              # 47o
            andc    $control_3,$control_3,$disc_11      # 48e
            lqd     $dz_7,320($a_packet_3)              # 48o
            fma     $b_6,$fy_6,$dy_7,$b_6               # 49e
            lqx     $m_by_side_2,$a_by_side,$sides_5    # 49o
            cgti    $ahead,$t_2,0                       # 50e
            gb      $control_5,$control_5               # 50o
            fma     $b_5,$fz_2,$dz_5,$b                 # 51e
            rotqbii $control_3,$control_3,1             # 51o
            and     $control_2,$control_2,$ahead        # 52e
            shufb   $t_best_6,$t_best_4,$t,$control     # 52o
            fma     $b_8,$fz_3,$dz_6,$b_9               # 53e
            shufb   $nearest_6,$nearest_2,$object_4,$control # 53o
            fnms    $fx_4,$b_2,$dx_2,$fx_4              # 54e
            shlqbii $control,$control_5,4               # 54o
            andc    $control_2,$control_2,$disc_4       # 55e
            gb      $control_3,$control_3               # 55o
            fma     $b_6,$fz_4,$dz_7,$b_6               # 56e
            stqd    $t_best_6,432($a_packet_4)          # 56o
            fnms    $fy,$b_2,$dy,$fy                    # 57e
            stqd    $nearest_6,496($a_packet_4)         # 57o
            fnms    $fz,$b_2,$dz,$fz                    # 58e
            rotqbii $control_6,$control_2,1             # 58o
            fnms    $fx,$b_5,$dx,$fx                    # 59e
            lqx     $control,$control,$a_controls       # 59o
            fnms    $fy_7,$b_5,$dy_3,$fy_2              # 60e
            shlqbii $control_3,$control_3,4             # 60o
            fnms    $disc_12,$fx_4,$fx_4,$radius2_4     # 61e
            lqx     $whole_2,$a_whole,$sides_5          # 61o
            fm      $rest,$fx_4,$dx_2                   # 62e
            lqx     $half_2,$a_half,$sides_5            # 62o
            fnms    $fx_6,$b_6,$dx_3,$fx_6              # 63e
            gb      $control_6,$control_6               # 63o
            fnms    $fz_7,$b_5,$dz_5,$fz_2              # 64e
            lqx     $control_3,$control_3,$a_controls   # 64o
            fnms    $fz_8,$b_8,$dz_6,$fz_3              # 65e
            shufb   $t_best_7,$t_best_2,$t_4,$control   # 65o
            fnms    $fx_7,$b_8,$dx_5,$fx_7              # 66e
            shufb   $nearest_7,$nearest_3,$object_4,$control # 66o
            fnms    $fy_4,$b_8,$dy_6,$fy_4              # 67e
            shlqbii $control,$control_6,4               # 67o
            fnms    $disc_13,$fy,$fy,$disc_12           # 68e
            lqd     $t_best_4,432($a_packet_3)          # 68o
            fma     $rest,$fy,$dy,$rest                 # 69e
            stqd    $t_best_7,384($a_packet_4)          # 69o
            fnms    $disc_2,$fx,$fx,$radius2_4          # 70e
            stqd    $nearest_7,448($a_packet_4)         # 70o
            fm      $rest_9,$fx_6,$dx_3                 # 71e
            lqd     $nearest_2,496($a_packet_3)         # 71o
            fnms    $disc_10,$fx_6,$fx_6,$radius2_4     # 72e
            lqx     $control,$control,$a_controls       # 72o
            fm      $rest_2,$fx_7,$dx_5                 # 73e
            shufb   $nearest_8,$nearest_5,$object_4,$control_3 # 73o
            fnms    $disc_14,$fx_7,$fx_7,$radius2_4     # 74e
            shufb   $t_best_8,$t_best_3,$t_3,$control_3 # 74o
            fnms    $disc_13,$fz,$fz,$disc_13           # 75e
            lqd     $nearest_3,448($a_packet_3)         # 75o
            fnms    $fy,$b_6,$dy_7,$fy_6                # 76e
            lqd     $t_best_2,384($a_packet_3)          # 76o
            fm      $rest_6,$fx,$dx                     # 77e
            stqd    $nearest_8,464($a_packet_4)         # 77o
            fma     $rest,$fz,$dz,$rest                 # 78e
            shufb   $t_best_9,$t_best_5,$t_2,$control   # 78o
            fma     $rest_2,$fy_4,$dy_6,$rest_2         # 79e
            shufb   $nearest_8,$nearest_4,$object_4,$control # 79o
            fnms    $disc_14,$fy_4,$fy_4,$disc_14       # 80e
            shufb   $object_4,$object_3,$object_3,$m_x  # 80o
            fnms    $disc_2,$fy_7,$fy_7,$disc_2         # 81e
            stqd    $t_best_8,400($a_packet_4)          # 81o
            fma     $rest_7,$fy,$dy_7,$rest_9           # 82e
            stqd    $t_best_9,416($a_packet_4)          # 82o
            fnms    $fz,$b_6,$dz_7,$fz_4                # 83e
        lqd     $object_3,0($a_candidate)               # 83o
            fma     $rest_10,$fy_7,$dy_3,$rest_6        # 84e
            stqd    $nearest_8,480($a_packet_4)         # 84o
            fma     $disc_5,$rest,$rest,$disc_13        # 85e
            lqd     $nearest_4,480($a_packet_3)         # 85o
            fnms    $disc_10,$fy,$fy,$disc_10           # 86e
            shlqbyi $a_packet_4,$a_packet_3,0           # 86o copy
            fma     $rest_4,$fz_8,$dz_6,$rest_2         # 87e
            lqd     $t_best_3,400($a_packet_3)          # 87o
            fnms    $disc_13,$fz_8,$fz_8,$disc_14       # 88e
            lqd     $t_best_5,416($a_packet_3)          # 88o
            fnms    $disc_2,$fz_7,$fz_7,$disc_2         # 89e
            lqd     $nearest_5,464($a_packet_3)         # 89o
            fma     $rest_5,$fz_7,$dz_5,$rest_10        # 90e
        rotqbyi $a_packet_3,$object_3,4                 # 90o
        ai      $a_candidate,$a_candidate,16            # 91e
        lqd     $quad_2,0($object_3)                    # 91o
            fma     $rest_6,$fz,$dz_7,$rest_7           # 92e
            frsqest $y_7,$disc_5                        # 92o
            fnms    $disc,$fz,$fz,$disc_10              # 93e
            fma     $disc_11,$rest_4,$rest_4,$disc_13   # 94e
            fms     $out_2,$b_2,$b_2,$disc_5            # 95e
            fma     $disc_4,$rest_5,$rest_5,$disc_2     # 96e
        fm      $quad_5,$quad_2,$k_half                 # 97e
        hbrr    next_ball_back,next_ball                # 97o hint
            fi      $y_7,$disc_5,$y_7                   # 98e
        lqd     $sides_6,32($object_3)                  # 98o
        ai      $count,$count,-1                        # 99e
        lqd     $oz,144($a_packet_3)                    # 99o
            fms     $out_4,$b_8,$b_8,$disc_11           # 100e
        lqd     $oz_7,160($a_packet_3)                  # 100o
            fma     $disc,$rest_6,$rest_6,$disc         # 101e
        lqd     $oy,96($a_packet_3)                     # 101o
        lqd     $oz_8,128($a_packet_3)                  # 102o
        shufb   $cz_2,$quad_5,$quad_5,$m_z              # 103o
        nop     $127                                    # 104e pairing
        shufb   $radius2_5,$sides_6,$sides_6,$m_x       # 104o
            fms     $out_3,$b_5,$b_5,$disc_4            # 105e
            frsqest $y_4,$disc_4                        # 105o
            fm      $s,$disc_5,$y_7                     # 106e
        shufb   $cy_2,$quad_5,$quad_5,$m_y              # 106o
        fnms    $fz_2,$oz_7,$k_half,$cz_2               # 107e
        rotqbyi $sides_6,$sides_6,12                    # 107o
            fms     $out_5,$b_6,$b_6,$disc              # 108e
            frsqest $y_3,$disc_11                       # 108o
        fnms    $fz_3,$oz,$k_half,$cz_2                 # 109e
            frsqest $y_8,$disc                          # 109o
        fm      $radius2_5,$radius2_5,$k_half           # 110e
        shufb   $cx_2,$quad_5,$quad_5,$m_x              # 110o
            fi      $y_4,$disc_4,$y_4                   # 111e
        rotmi   $sides_5,$sides_6,-26                   # 112e
        fnms    $fy_2,$oy,$k_half,$cy_2                 # 113e
            fnms    $e,$s,$y_7,$k_one                   # 114e
        fnms    $fz_4,$oz_8,$k_half,$cz_2               # 115e
        lqd     $ox_6,32($a_packet_3)                   # 115o
        fm      $radius2_4,$radius2_5,$radius2_5        # 116e
        lnop                                            # 116o pairing
            fi      $y_6,$disc_11,$y_3                  # 117e
        lqd     $ox_5,0($a_packet_3)                    # 117o
            fi      $y_5,$disc,$y_8                     # 118e
            selb    $s_2,$s,$out_2,$m_by_side_2         # 119e
            fm      $s_3,$disc_4,$y_4                   # 120e
next_ball_back:
        brnz    $count,next_ball                        # 120o
next_ball_drain:
        fnms    $fx_6,$ox_5,$k_half,$cx_2               # 0e
        lqd     $ox_8,48($a_packet_3)                   # 0o
        fma     $e,$e,$half_2,$whole_2                  # 1e
        lqd     $oy_5,112($a_packet_3)                  # 1o
        fnms    $fx,$ox_6,$k_half,$cx_2                 # 2e
        lqd     $dx_6,240($a_packet_3)                  # 2o
        fm      $s_6,$disc,$y_5                         # 3e
        lqd     $oz,176($a_packet_3)                    # 3o
        fm      $s,$disc_11,$y_6                        # 4e
        lqd     $dy_8,304($a_packet_3)                  # 4o
        fnms    $e_4,$s_3,$y_4,$k_one                   # 5e
        lqd     $dx_4,192($a_packet_3)                  # 5o
        fnms    $fx_8,$ox_8,$k_half,$cx_2               # 6e
        lqd     $oy_6,64($a_packet_3)                   # 6o
        fnms    $fy,$oy_5,$k_half,$cy_2                 # 7e
        lqd     $dz,368($a_packet_3)                    # 7o
        fnms    $rest,$s_2,$e,$rest                     # 8e
        lqd     $ox_9,16($a_packet_3)                   # 8o
        fnms    $fz,$oz,$k_half,$cz_2                   # 9e
        lqd     $dy_9,256($a_packet_3)                  # 9o
        fnms    $e_5,$s_6,$y_5,$k_one                   # 10e
        lqd     $dx_7,208($a_packet_3)                  # 10o
        fm      $b_10,$fx_6,$dx_4                       # 11e
        lqd     $oy_7,80($a_packet_3)                   # 11o
        fm      $b,$fx_8,$dx_6                          # 12e
        lqd     $dx_8,224($a_packet_3)                  # 12o
        fnms    $fy_8,$oy_6,$k_half,$cy_2               # 13e
        lqd     $dz_4,320($a_packet_3)                  # 13o
        fnms    $fx_9,$ox_9,$k_half,$cx_2               # 14e
        lqd     $dy,272($a_packet_3)                    # 14o
        fma     $t_5,$b_2,$k_two,$rest                  # 15e
        lqd     $dy_10,288($a_packet_3)                 # 15o
        fma     $e_5,$e_5,$half_2,$whole_2              # 16e
        lqd     $dz_8,336($a_packet_3)                  # 16o
        fnms    $fy_9,$oy_7,$k_half,$cy_2               # 17e
        lqd     $dz_5,352($a_packet_3)                  # 17o
        fma     $b_11,$fy,$dy_8,$b                      # 18e
        lqx     $m_by_side_3,$a_by_side,$sides_5        # 18o
        fma     $b_10,$fy_8,$dy_9,$b_10                 # 19e
        shufb   $object_5,$object_3,$object_3,$m_x      # 19o
        fm      $b,$fx_9,$dx_7                          # 20e
        shlqbyi $a_packet_5,$a_packet_3,0               # 20o copy
        fm      $b_12,$fx,$dx_8                         # 21e
        cgti    $ahead_3,$t_5,0                         # 22e
        cgt     $control_7,$t_best_4,$t_5               # 23e
        fma     $b_11,$fz,$dz,$b_11                     # 24e
        fma     $b_10,$fz_4,$dz_4,$b_10                 # 25e
        fma     $b,$fy_9,$dy,$b                         # 26e
        fma     $b_12,$fy_2,$dy_10,$b_12                # 27e
        and     $control_8,$control_7,$ahead_3          # 28e
        fnms    $e_6,$s,$y_6,$k_one                     # 29e
        fnms    $fx_8,$b_11,$dx_6,$fx_8                 # 30e
        fnms    $fy,$b_11,$dy_8,$fy                     # 31e
        fnms    $fz,$b_11,$dz,$fz                       # 32e
        fnms    $fx_6,$b_10,$dx_4,$fx_6                 # 33e
        fma     $b,$fz_3,$dz_8,$b                       # 34e
        fma     $b_12,$fz_2,$dz_5,$b_12                 # 35e
        fnms    $disc_15,$fx_8,$fx_8,$radius2_4         # 36e
        fm      $rest_11,$fx_8,$dx_6                    # 37e
        fnms    $fy_10,$b_10,$dy_9,$fy_8                # 38e
        fm      $rest_12,$fx_6,$dx_4                    # 39e
        fnms    $disc_10,$fx_6,$fx_6,$radius2_4         # 40e
        andc    $control_9,$control_8,$disc_5           # 41e
        fnms    $disc_16,$fy,$fy,$disc_15               # 42e
        fma     $rest_11,$fy,$dy_8,$rest_11             # 43e
        rotqbii $control_10,$control_9,1                # 43o
        fnms    $fx_9,$b,$dx_7,$fx_9                    # 44e
        fnms    $fx,$b_12,$dx_8,$fx                     # 45e
        fma     $rest_13,$fy_10,$dy_9,$rest_12          # 46e
        lnop                                            # 46o pairing
        fnms    $fz_9,$b_10,$dz_4,$fz_4                 # 47e
        gb      $control_10,$control_10                 # 47o
        fnms    $disc_17,$fz,$fz,$disc_16               # 48e
        fma     $rest_11,$fz,$dz,$rest_11               # 49e
        fnms    $disc_10,$fy_10,$fy_10,$disc_10         # 50e
        lnop                                            # 50o pairing
        fnms    $fy_10,$b,$dy,$fy_9                     # 51e
        shlqbii $control_10,$control_10,4               # 51o
        fm      $rest_14,$fx_9,$dx_7                    # 52e
        fnms    $disc_18,$fx_9,$fx_9,$radius2_4         # 53e
        selb    $s_6,$s_6,$out_5,$m_by_side_2           # 54e
        lnop                                            # 54o pairing
        fma     $disc_14,$rest_11,$rest_11,$disc_17     # 55e
        lqx     $control_10,$control_10,$a_controls     # 55o
        fnms    $fy_11,$b_12,$dy_10,$fy_2               # 56e
        fnms    $disc_17,$fx,$fx,$radius2_4             # 57e
        fm      $rest_15,$fx,$dx_8                      # 58e
        fma     $rest_13,$fz_9,$dz_4,$rest_13           # 59e
        fnms    $disc_10,$fz_9,$fz_9,$disc_10           # 60e
        lnop                                            # 60o pairing
        fnms    $rest_7,$s_6,$e_5,$rest_6               # 61e
        frsqest $y_5,$disc_14                           # 61o
        fnms    $fz_9,$b,$dz_8,$fz_3                    # 62e
        shufb   $t_best_10,$t_best_4,$t_5,$control_10   # 62o
        fma     $rest_14,$fy_10,$dy,$rest_14            # 63e
        shufb   $nearest_9,$nearest_2,$object_4,$control_10 # 63o
        fnms    $disc_18,$fy_10,$fy_10,$disc_18         # 64e
        fi      $y_9,$disc_14,$y_5                      # 65e
        selb    $s_5,$s,$out_4,$m_by_side_2             # 66e
        stqd    $t_best_10,432($a_packet_4)             # 66o
        fma     $e,$e_6,$half_2,$whole_2                # 67e
        stqd    $nearest_9,496($a_packet_4)             # 67o
        fnms    $fz_7,$b_12,$dz_5,$fz_2                 # 68e
        lqx     $whole_3,$a_whole,$sides_5              # 68o
        fnms    $disc_19,$fy_11,$fy_11,$disc_17         # 69e
        lqx     $half_3,$a_half,$sides_5                # 69o
        fma     $rest_2,$fy_11,$dy_10,$rest_15          # 70e
        lqd     $t_best_4,432($a_packet_3)              # 70o
        fma     $disc_10,$rest_13,$rest_13,$disc_10     # 71e
        fma     $e_4,$e_4,$half_2,$whole_2              # 72e
        fma     $t_3,$b_6,$k_two,$rest_7                # 73e
        fma     $rest_14,$fz_9,$dz_8,$rest_14           # 74e
        fnms    $disc_18,$fz_9,$fz_9,$disc_18           # 75e
        fnms    $rest_10,$s_5,$e,$rest_4                # 76e
        fm      $s,$disc_14,$y_9                        # 77e
        frsqest $y_10,$disc_10                          # 77o
        selb    $s_7,$s_3,$out_3,$m_by_side_2           # 78e
        fnms    $disc_19,$fz_7,$fz_7,$disc_19           # 79e
        fma     $rest_16,$fz_7,$dz_5,$rest_2            # 80e
        fnms    $rest,$s_7,$e_4,$rest_5                 # 81e
        cgti    $ahead_2,$t_3,0                         # 82e
        cgt     $control_4,$t_best_2,$t_3               # 83e
        fma     $disc_18,$rest_14,$rest_14,$disc_18     # 84e
        and     $control_5,$control_4,$ahead_2          # 85e
        fi      $y_5,$disc_10,$y_10                     # 86e
        andc    $control_5,$control_5,$disc             # 87e
        fma     $t_2,$b_8,$k_two,$rest_10               # 88e
        lnop                                            # 88o pairing
        fnms    $e,$s,$y_9,$k_one                       # 89e
        rotqbii $control_5,$control_5,1                 # 89o
        fma     $disc_2,$rest_16,$rest_16,$disc_19      # 90e
        frsqest $y_3,$disc_18                           # 90o
        fma     $t_6,$b_5,$k_two,$rest                  # 91e
        fms     $out_6,$b_11,$b_11,$disc_14             # 92e
        fm      $s_8,$disc_10,$y_5                      # 93e
        gb      $control_5,$control_5                   # 93o
        cgti    $ahead,$t_2,0                           # 94e
        cgt     $control_3,$t_best_3,$t_2               # 95e
        fma     $e,$e,$half_3,$whole_3                  # 96e
        frsqest $y_4,$disc_2                            # 96o
        and     $control_3,$control_3,$ahead            # 97e
        shlqbii $control,$control_5,4                   # 97o
        fi      $y_11,$disc_18,$y_3                     # 98e
        cgt     $control_2,$t_best_5,$t_6               # 99e
        cgti    $ahead,$t_6,0                           # 100e
        lnop                                            # 100o pairing
        andc    $control_3,$control_3,$disc_11          # 101e
        lqx     $control,$control,$a_controls           # 101o
        selb    $s_9,$s,$out_6,$m_by_side_3             # 102e
        lnop                                            # 102o pairing
        and     $control_2,$control_2,$ahead            # 103e
        rotqbii $control_3,$control_3,1                 # 103o
        fi      $y_4,$disc_2,$y_4                       # 104e
        andc    $control_2,$control_2,$disc_4           # 105e
        fnms    $rest,$s_9,$e,$rest_11                  # 106e
        lnop                                            # 106o pairing
        fnms    $e_7,$s_8,$y_5,$k_one                   # 107e
        rotqbii $control_11,$control_2,1                # 107o
        fm      $s,$disc_18,$y_11                       # 108e
        gb      $control_3,$control_3                   # 108o
        fms     $out_7,$b_10,$b_10,$disc_10             # 109e
        shufb   $t_best_8,$t_best_2,$t_3,$control       # 109o
        fms     $out_8,$b,$b,$disc_18                   # 110e
        shufb   $nearest_10,$nearest_3,$object_4,$control # 110o
        fm      $s_3,$disc_2,$y_4                       # 111e
        gb      $control_11,$control_11                 # 111o
        fma     $t,$b_11,$k_two,$rest                   # 112e
        shlqbii $control_3,$control_3,4                 # 112o
        fma     $e_7,$e_7,$half_3,$whole_3              # 113e
        hbr     isect_sphere_pairs_refined_r16_return,$lr # 113o hint
        fnms    $e,$s,$y_11,$k_one                      # 114e
        lnop                                            # 114o pairing
        selb    $s_10,$s_8,$out_7,$m_by_side_3          # 115e
        shlqbii $control,$control_11,4                  # 115o
        fms     $out_3,$b_12,$b_12,$disc_2              # 116e
        lqx     $control_3,$control_3,$a_controls       # 116o
        fnms    $e_8,$s_3,$y_4,$k_one                   # 117e
        stqd    $t_best_8,384($a_packet_4)              # 117o
        cgti    $ahead,$t,0                             # 118e
        stqd    $nearest_10,448($a_packet_4)            # 118o
        cgt     $control_12,$t_best_4,$t                # 119e
        lqx     $control,$control,$a_controls           # 119o
        fnms    $rest_11,$s_10,$e_7,$rest_13            # 120e
        lqd     $t_best_2,384($a_packet_3)              # 120o
        and     $control_12,$control_12,$ahead          # 121e
        lqd     $nearest_2,496($a_packet_3)             # 121o
        fma     $e,$e,$half_3,$whole_3                  # 122e
        shufb   $nearest_8,$nearest_5,$object_4,$control_3 # 122o
        andc    $control_12,$control_12,$disc_14        # 123e
        shufb   $t_best_11,$t_best_3,$t_2,$control_3    # 123o
        fma     $e_9,$e_8,$half_3,$whole_3              # 124e
        lqd     $nearest_3,448($a_packet_3)             # 124o
        selb    $s_11,$s,$out_8,$m_by_side_3            # 125e
        rotqbii $control_12,$control_12,1               # 125o
        fma     $t_7,$b_10,$k_two,$rest_11              # 126e
        shufb   $t_best_12,$t_best_5,$t_6,$control      # 126o
        selb    $s_12,$s_3,$out_3,$m_by_side_3          # 127e
        shufb   $nearest_11,$nearest_4,$object_4,$control # 127o
        fnms    $rest_17,$s_11,$e,$rest_14              # 128e
        stqd    $nearest_8,464($a_packet_4)             # 128o
        nop     $127                                    # 129e pairing
        gb      $control,$control_12                    # 129o
        fnms    $rest,$s_12,$e_9,$rest_16               # 130e
        stqd    $t_best_11,400($a_packet_4)             # 130o
        nop     $127                                    # 131e pairing
        stqd    $t_best_12,416($a_packet_4)             # 131o
        cgti    $ahead_2,$t_7,0                         # 132e
        stqd    $nearest_11,480($a_packet_4)            # 132o
        cgt     $control_4,$t_best_2,$t_7               # 133e
        shlqbii $control,$control,4                     # 133o
        fma     $t_3,$b,$k_two,$rest_17                 # 134e
        lqd     $t_best_3,400($a_packet_3)              # 134o
        and     $control_5,$control_4,$ahead_2          # 135e
        lqd     $t_best_5,416($a_packet_3)              # 135o
        fma     $t_2,$b_12,$k_two,$rest                 # 136e
        lqd     $nearest_4,480($a_packet_3)             # 136o
        andc    $control_5,$control_5,$disc_10          # 137e
        lqx     $control,$control,$a_controls           # 137o
        lqd     $nearest_5,464($a_packet_3)             # 138o
        rotqbii $control_5,$control_5,1                 # 139o
        cgti    $ahead,$t_3,0                           # 140e
        cgt     $control_3,$t_best_3,$t_3               # 141e
        cgt     $control_2,$t_best_5,$t_2               # 142e
        lnop                                            # 142o pairing
        and     $control_3,$control_3,$ahead            # 143e
        gb      $control_5,$control_5                   # 143o
        cgti    $ahead,$t_2,0                           # 144e
        shufb   $t_best_6,$t_best_4,$t,$control         # 144o
        andc    $control_3,$control_3,$disc_18          # 145e
        shufb   $nearest_6,$nearest_2,$object_5,$control # 145o
        and     $control_2,$control_2,$ahead            # 146e
        shlqbii $control,$control_5,4                   # 147o
        andc    $control_2,$control_2,$disc_2           # 148e
        rotqbii $control_3,$control_3,1                 # 148o
        stqd    $t_best_6,432($a_packet_5)              # 149o
        stqd    $nearest_6,496($a_packet_5)             # 150o
        rotqbii $control_6,$control_2,1                 # 151o
        lqx     $control,$control,$a_controls           # 152o
        gb      $control_3,$control_3                   # 153o
        gb      $control_6,$control_6                   # 155o
        shlqbii $control_3,$control_3,4                 # 157o
        shufb   $t_best_7,$t_best_2,$t_7,$control       # 158o
        shufb   $nearest_7,$nearest_3,$object_5,$control # 159o
        shlqbii $control,$control_6,4                   # 160o
        lqx     $control_3,$control_3,$a_controls       # 161o
        stqd    $t_best_7,384($a_packet_5)              # 162o
        stqd    $nearest_7,448($a_packet_5)             # 163o
        lqx     $control,$control,$a_controls           # 164o
        shufb   $nearest_8,$nearest_5,$object_5,$control_3 # 167o
        shufb   $t_best_8,$t_best_3,$t_3,$control_3     # 168o
        shufb   $t_best_9,$t_best_5,$t_2,$control       # 170o
        shufb   $nearest_12,$nearest_4,$object_5,$control # 171o
        stqd    $nearest_8,464($a_packet_5)             # 172o
        stqd    $t_best_8,400($a_packet_5)              # 173o
        stqd    $t_best_9,416($a_packet_5)              # 174o
        stqd    $nearest_12,480($a_packet_5)            # 175o
        nop     $127                                    # 176e pairing
isect_sphere_pairs_refined_r16_return:
        bi      $lr                                     # 176o
next_ball_short:
        ai      $count,$count,-1                        # 0e
        lqd     $object,0($a_candidate)                 # 0o
        ai      $a_candidate,$a_candidate,16            # 1e
        rotqbyi $a_packet,$object,4                     # 6o
        lqd     $quad,0($object)                        # 7o
        lqd     $sides,32($object)                      # 8o
        shufb   $object,$object,$object,$m_x            # 9o
        lqd     $ox,16($a_packet)                       # 10o
        lqd     $oy,80($a_packet)                       # 11o
        lqd     $dx,192($a_packet)                      # 12o
        fm      $quad,$quad,$k_half                     # 13e
        lqd     $ox_10,0($a_packet)                     # 13o
        lqd     $dx_6,208($a_packet)                    # 14o
        lqd     $ox_5,48($a_packet)                     # 15o
        lqd     $oy_8,64($a_packet)                     # 16o
        shufb   $radius2,$sides,$sides,$m_x             # 17o
        lqd     $dy,256($a_packet)                      # 18o
        shufb   $cx,$quad,$quad,$m_x                    # 19o
        nop     $127                                    # 20e pairing
        shufb   $cy,$quad,$quad,$m_y                    # 20o
        fm      $radius2,$radius2,$k_half               # 21e
        shufb   $cz,$quad,$quad,$m_z                    # 21o
        nop     $127                                    # 22e pairing
        lqd     $dx_9,224($a_packet)                    # 22o
        fnms    $fx,$ox_10,$k_half,$cx                  # 23e
        lqd     $oz,128($a_packet)                      # 23o
        fnms    $fx_6,$ox,$k_half,$cx                   # 24e
        lqd     $dx_10,240($a_packet)                   # 24o
        fnms    $fy,$oy,$k_half,$cy                     # 25e
        lqd     $ox,32($a_packet)                       # 25o
        fnms    $fx_3,$ox_5,$k_half,$cx                 # 26e
        lqd     $dy_11,272($a_packet)                   # 26o
        fnms    $fy_12,$oy_8,$k_half,$cy                # 27e
        lqd     $oz_9,144($a_packet)                    # 27o
        fm      $radius2,$radius2,$radius2              # 28e
        lqd     $dy_12,288($a_packet)                   # 28o
        fm      $b,$fx,$dx                              # 29e
        lqd     $dz,336($a_packet)                      # 29o
        fm      $b_13,$fx_6,$dx_6                       # 30e
        lqd     $oy,96($a_packet)                       # 30o
        fnms    $fx_10,$ox,$k_half,$cx                  # 31e
        lqd     $oy_9,112($a_packet)                    # 31o
        fnms    $fz,$oz,$k_half,$cz                     # 32e
        lqd     $dz_9,320($a_packet)                    # 32o
        fnms    $fz_10,$oz_9,$k_half,$cz                # 33e
        lqd     $dy_13,304($a_packet)                   # 33o
        fm      $b_11,$fx_3,$dx_10                      # 34e
        lqd     $oz_10,176($a_packet)                   # 34o
        fma     $b,$fy_12,$dy,$b                        # 35e
        lqd     $oz_11,160($a_packet)                   # 35o
        fma     $b_13,$fy,$dy_11,$b_13                  # 36e
        lqd     $dz_10,368($a_packet)                   # 36o
        fnms    $fy_13,$oy,$k_half,$cy                  # 37e
        lqd     $dz_3,352($a_packet)                    # 37o
        fnms    $fy_4,$oy_9,$k_half,$cy                 # 38e
        rotqbyi $sides,$sides,12                        # 38o
        fm      $b_14,$fx_10,$dx_9                      # 39e
        lqd     $t_best_13,400($a_packet)               # 39o
        fnms    $fz_11,$oz_10,$k_half,$cz               # 40e
        lqd     $t_best_14,384($a_packet)               # 40o
        fma     $b,$fz,$dz_9,$b                         # 41e
        lqd     $t_best_15,432($a_packet)               # 41o
        fma     $b_13,$fz_10,$dz,$b_13                  # 42e
        lqd     $nearest_13,464($a_packet)              # 42o
        fnms    $fz_12,$oz_11,$k_half,$cz               # 43e
        lqd     $t_best_16,416($a_packet)               # 43o
        fma     $b_11,$fy_4,$dy_13,$b_11                # 44e
        lqd     $nearest_14,448($a_packet)              # 44o
        fma     $b_14,$fy_13,$dy_12,$b_14               # 45e
        lqd     $nearest_15,496($a_packet)              # 45o
        rotmi   $sides,$sides,-26                       # 46e
        lqd     $nearest_16,480($a_packet)              # 46o
        fnms    $fx,$b,$dx,$fx                          # 47e
        fnms    $fy_12,$b,$dy,$fy_12                    # 48e
        fnms    $fy,$b_13,$dy_11,$fy                    # 49e
        lnop                                            # 49o pairing
        fma     $b_11,$fz_11,$dz_10,$b_11               # 50e
        lqx     $half_4,$a_half,$sides                  # 50o
        fnms    $fz_10,$b_13,$dz,$fz_10                 # 51e
        lqx     $whole_4,$a_whole,$sides                # 51o
        fnms    $fx_6,$b_13,$dx_6,$fx_6                 # 52e
        lqx     $m_by_side_4,$a_by_side,$sides          # 52o
        fm      $rest_15,$fx,$dx                        # 53e
        fnms    $disc_20,$fx,$fx,$radius2               # 54e
        fnms    $fz,$b,$dz_9,$fz                        # 55e
        fnms    $fx_3,$b_11,$dx_10,$fx_3                # 56e
        fma     $b_14,$fz_12,$dz_3,$b_14                # 57e
        fm      $rest_8,$fx_6,$dx_6                     # 58e
        fnms    $disc_10,$fx_6,$fx_6,$radius2           # 59e
        fnms    $disc_20,$fy_12,$fy_12,$disc_20         # 60e
        fma     $rest_13,$fy_12,$dy,$rest_15            # 61e
        fm      $rest_17,$fx_3,$dx_10                   # 62e
        fnms    $fx_10,$b_14,$dx_9,$fx_10               # 63e
        fnms    $fy_13,$b_14,$dy_12,$fy_13              # 64e
        fnms    $disc_10,$fy,$fy,$disc_10               # 65e
        fma     $rest_8,$fy,$dy_11,$rest_8              # 66e
        fma     $rest_13,$fz,$dz_9,$rest_13             # 67e
        fnms    $disc_21,$fx_3,$fx_3,$radius2           # 68e
        fm      $rest_10,$fx_10,$dx_9                   # 69e
        fnms    $disc_22,$fx_10,$fx_10,$radius2         # 70e
        fnms    $disc_10,$fz_10,$fz_10,$disc_10         # 71e
        fma     $rest_8,$fz_10,$dz,$rest_8              # 72e
        fnms    $disc_5,$fz,$fz,$disc_20                # 73e
        fnms    $fz,$b_11,$dz_10,$fz_11                 # 74e
        fnms    $fy,$b_11,$dy_13,$fy_4                  # 75e
        fnms    $disc,$fy_13,$fy_13,$disc_22            # 76e
        fnms    $fz_6,$b_14,$dz_3,$fz_12                # 77e
        fma     $disc_10,$rest_8,$rest_8,$disc_10       # 78e
        fma     $disc_5,$rest_13,$rest_13,$disc_5       # 79e
        fma     $rest_10,$fy_13,$dy_12,$rest_10         # 80e
        fma     $rest_17,$fy,$dy_13,$rest_17            # 81e
        fnms    $disc_21,$fy,$fy,$disc_21               # 82e
        fnms    $disc,$fz_6,$fz_6,$disc                 # 83e
        lnop                                            # 83o pairing
        fms     $out_8,$b_13,$b_13,$disc_10             # 84e
        frsqest $y_12,$disc_10                          # 84o
        fms     $out_9,$b,$b,$disc_5                    # 85e
        frsqest $y_13,$disc_5                           # 85o
        fma     $rest_10,$fz_6,$dz_3,$rest_10           # 86e
        fma     $rest_17,$fz,$dz_10,$rest_17            # 87e
        fnms    $disc_21,$fz,$fz,$disc_21               # 88e
        fi      $y,$disc_10,$y_12                       # 89e
        fi      $y_10,$disc_5,$y_13                     # 90e
        fma     $disc,$rest_10,$rest_10,$disc           # 92e
        fma     $disc_21,$rest_17,$rest_17,$disc_21     # 94e
        fm      $s,$disc_10,$y                          # 96e
        fm      $s_13,$disc_5,$y_10                     # 97e
        lnop                                            # 97o pairing
        fms     $out_10,$b_14,$b_14,$disc               # 98e
        frsqest $y_14,$disc                             # 98o
        fms     $out_11,$b_11,$b_11,$disc_21            # 100e
        frsqest $y_8,$disc_21                           # 100o
        fnms    $e_10,$s,$y,$k_one                      # 102e
        fnms    $e_11,$s_13,$y_10,$k_one                # 103e
        fi      $y,$disc,$y_14                          # 104e
        selb    $s_13,$s_13,$out_9,$m_by_side_4         # 105e
        fi      $y_15,$disc_21,$y_8                     # 106e
        selb    $s,$s,$out_8,$m_by_side_4               # 107e
        fma     $e_12,$e_10,$half_4,$whole_4            # 108e
        fma     $e_11,$e_11,$half_4,$whole_4            # 109e
        fm      $s_14,$disc,$y                          # 111e
        fm      $s_15,$disc_21,$y_15                    # 113e
        fnms    $rest_8,$s,$e_12,$rest_8                # 114e
        fnms    $rest_13,$s_13,$e_11,$rest_13           # 115e
        fnms    $e_11,$s_14,$y,$k_one                   # 117e
        selb    $s,$s_14,$out_10,$m_by_side_4           # 118e
        fnms    $e_12,$s_15,$y_15,$k_one                # 119e
        selb    $s_13,$s_15,$out_11,$m_by_side_4        # 120e
        fma     $t_8,$b,$k_two,$rest_13                 # 121e
        fma     $t_4,$b_13,$k_two,$rest_8               # 122e
        fma     $e_11,$e_11,$half_4,$whole_4            # 123e
        fma     $e_12,$e_12,$half_4,$whole_4            # 125e
        cgt     $control_13,$t_best_14,$t_8             # 127e
        cgti    $ahead_4,$t_4,0                         # 128e
        fnms    $rest_10,$s,$e_11,$rest_10              # 129e
        cgt     $control_14,$t_best_13,$t_4             # 130e
        fnms    $rest_17,$s_13,$e_12,$rest_17           # 131e
        cgti    $ahead_5,$t_8,0                         # 132e
        and     $control_14,$control_14,$ahead_4        # 133e
        and     $control_15,$control_13,$ahead_5        # 134e
        andc    $control_16,$control_14,$disc_10        # 135e
        fma     $t_2,$b_14,$k_two,$rest_10              # 136e
        fma     $t_9,$b_11,$k_two,$rest_17              # 137e
        rotqbii $control_16,$control_16,1               # 137o
        andc    $control_14,$control_15,$disc_5         # 138e
        rotqbii $control_14,$control_14,1               # 140o
        gb      $control_16,$control_16                 # 141o
        cgti    $ahead_6,$t_2,0                         # 142e
        cgt     $control_15,$t_best_15,$t_9             # 143e
        lnop                                            # 143o pairing
        cgti    $ahead_7,$t_9,0                         # 144e
        gb      $control_14,$control_14                 # 144o
        cgt     $control_13,$t_best_16,$t_2             # 145e
        shlqbii $control_16,$control_16,4               # 145o
        and     $control_15,$control_15,$ahead_7        # 146e
        and     $control_9,$control_13,$ahead_6         # 147e
        andc    $control_12,$control_15,$disc_21        # 148e
        shlqbii $control_14,$control_14,4               # 148o
        andc    $control_9,$control_9,$disc             # 149e
        lqx     $control_16,$control_16,$a_controls     # 149o
        rotqbii $control_12,$control_12,1               # 150o
        rotqbii $control_9,$control_9,1                 # 151o
        lqx     $control_14,$control_14,$a_controls     # 152o
        gb      $control_12,$control_12                 # 154o
        shufb   $nearest,$nearest_13,$object,$control_16 # 155o
        gb      $control_9,$control_9                   # 156o
        shufb   $t_best,$t_best_13,$t_4,$control_16     # 157o
        shufb   $t_best_17,$t_best_14,$t_8,$control_14  # 158o
        stqd    $nearest,464($a_packet)                 # 159o
        shlqbii $control_17,$control_9,4                # 160o
        stqd    $t_best,400($a_packet)                  # 161o
        stqd    $t_best_17,384($a_packet)               # 162o
        shlqbii $control_16,$control_12,4               # 163o
        shufb   $nearest,$nearest_14,$object,$control_14 # 164o
        lqx     $control,$control_17,$a_controls        # 165o
        lqx     $control_16,$control_16,$a_controls     # 167o
        stqd    $nearest,448($a_packet)                 # 168o
        hbrr    next_ball_short_back,next_ball_short    # 169o hint
        shufb   $nearest,$nearest_16,$object,$control   # 171o
        shufb   $t_best,$t_best_16,$t_2,$control        # 172o
        shufb   $nearest_17,$nearest_15,$object,$control_16 # 173o
        shufb   $t_best_17,$t_best_15,$t_9,$control_16  # 174o
        stqd    $nearest,480($a_packet)                 # 175o
        stqd    $t_best,416($a_packet)                  # 176o
        stqd    $nearest_17,496($a_packet)              # 177o
        stqd    $t_best_17,432($a_packet)               # 178o
        nop     $127                                    # 179e pairing
next_ball_short_back:
        brnz    $count,next_ball_short                  # 185o
        nop     $127                                    # 180e pairing
        bi      $lr                                     # 180o
endfunction isect_sphere_pairs_refined_r16
