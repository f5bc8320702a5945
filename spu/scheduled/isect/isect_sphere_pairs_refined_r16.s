# isect_sphere_pairs_refined_r16   nearest hit of packets' rays with spheres, to the last digits
#   C       void isect_sphere_pairs_refined_r16(const struct candidate *, int count);
#   In      $3 candidates of objects that are spheres, $4 count (0 is none); pointers 16-aligned
#   Out     the candidates' packets: t, object, where a hit has 0 < t < what was there
#   Uses    $2-$77, $79   Saves  -   Stack  0   Calls  -
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
        .set count_2,79; .set a_candidate_2,2; .set object_2,5; .set object_3,26; .set a_packet_2,2
        .set sides_2,6; .set a_packet_3,30; .set quad_2,7; .set ox_2,43; .set oy_2,9; .set dx_2,42
        .set dy_2,58; .set oz_2,45; .set dz_2,63; .set ox_3,39; .set cx_2,41; .set cy_2,34
        .set radius2_2,55; .set cz_2,22; .set fx_2,43; .set oy_3,21; .set fy_2,9; .set dx_3,44
        .set dy_3,8; .set fz_2,45; .set oz_3,50; .set ox_4,20; .set b_2,56; .set ox_5,23
        .set fy_3,21; .set dz_3,61; .set b_3,52; .set dx_4,46; .set fz_3,50; .set dx_5,47
        .set oy_4,35; .set fx_3,20; .set oz_4,53; .set dy_4,57; .set fy_4,32; .set oz_5,48
        .set dy_5,60; .set fx_4,23; .set dz_4,31; .set fy_5,35; .set dz_5,62; .set b_4,59
        .set fz_4,27; .set ox_6,33; .set b_5,34; .set ox_7,36; .set b_6,54; .set dx_6,37
        .set fz_5,53; .set ox_8,22; .set oy_5,38; .set ox_9,40; .set oy_6,48; .set dx_7,49
        .set fz_6,24; .set dx_8,45; .set cy_3,51; .set oz_6,52; .set rest_2,25; .set oy_7,42
        .set dx_9,64; .set rest_3,28; .set oz_7,44; .set disc_2,29; .set oz_8,39; .set b_7,65
        .set dy_6,66; .set dy_7,67; .set oy_8,58; .set dy_8,9; .set rest_4,8; .set dz_6,68
        .set disc_3,21; .set dz_7,69; .set dy_9,70; .set b_8,71; .set sides_3,54; .set rest_5,59
        .set cz_3,7; .set t_best_2,61; .set dz_8,50; .set oz_9,72; .set radius2_3,73
        .set disc_4,74; .set t_best_3,75; .set nearest_2,76; .set rest_6,20; .set object_4,25
        .set disc_5,5; .set a_packet_4,29; .set nearest_3,21; .set disc_6,46; .set nearest_4,24
        .set rest_7,47; .set nearest_5,28; .set fz_7,55; .set y_2,77; .set t_best_4,27
        .set disc_7,32; .set y_3,60; .set t_best_5,23; .set y_4,2; .set y_5,31; .set sides_4,60
        .set half_2,74; .set rest_8,35; .set whole_2,47; .set s_2,54; .set m_by_side_2,6
        .set out_2,57; .set fx_5,36; .set fx_6,33; .set fx_7,22; .set e_2,2; .set s_3,55
        .set disc_8,53; .set e_3,31; .set s_4,38; .set fx_8,40; .set fy_6,41; .set y_6,48
        .set b_9,57; .set rest_9,2; .set y_7,38; .set fy_7,42; .set fy_8,48; .set fz_8,44
        .set b_10,51; .set out_3,54; .set b_11,58; .set y_8,62; .set b_12,55; .set t_2,2
        .set fz_9,58; .set fz_10,39; .set fz_11,7; .set control_2,31; .set s_5,51; .set s_6,72
        .set ahead_2,54; .set t_3,8; .set radius2_4,34; .set e_4,38; .set out_4,43; .set ahead_3,55
        .set disc_9,57; .set rest_10,49; .set disc_10,33; .set e_5,62; .set disc_11,73
        .set rest_11,37; .set out_5,22; .set s_7,43; .set rest_12,38; .set fy_9,43; .set t_best_6,2
        .set nearest_6,31; .set disc_12,34; .set rest_13,45; .set disc_13,2; .set whole_3,36
        .set m_by_side_3,40; .set control_3,5; .set disc_14,42; .set s_8,6; .set fz_12,22
        .set rest_14,9; .set t_4,31; .set rest_15,32; .set t_5,33; .set control_4,6; .set fz_13,20
        .set disc_15,7; .set rest_16,34; .set disc_16,9; .set ahead_4,22; .set control_5,64
        .set rest_17,39; .set half_3,42; .set disc_17,65; .set control_6,2; .set disc_18,66
        .set y_9,6; .set out_6,41; .set y_10,5; .set out_7,8; .set y_11,7; .set y_12,21
        .set out_8,48; .set y_13,22; .set s_9,5; .set nearest_7,7; .set t_best_7,8; .set s_10,9
        .set nearest_8,20; .set e_6,21; .set e_7,22; .set e_8,20; .set rest_18,5; .set sides_5,5
        .set ox_10,6; .set control_7,20; .set ahead_5,34; .set control_8,36; .set ahead_6,40
        .set ox_11,45; .set fx_9,6; .set fx_10,41; .set dy_10,34; .set dz_9,48; .set disc_19,49
        .set disc_20,6; .set rest_19,41; .set control_9,7; .set t_best_8,3; .set object_5,4
        .set a_packet_5,8; .set control_10,9; .set ox_12,2; .set ox_13,5; .set oy_9,6; .set dx_10,7
        .set fx_11,2; .set fx_12,5; .set oz_10,9; .set fy_10,6; .set oy_10,22; .set b_13,28
        .set dz_10,9; .set fz_14,29; .set dx_11,30; .set dy_11,31; .set dx_12,33; .set dy_12,37
        .set oz_11,38; .set oz_12,43; .set b_14,44; .set dz_11,45; .set fy_11,22; .set dz_12,24
        .set b_15,46; .set t_best_9,47; .set t_best_10,48; .set t_best_11,49; .set fz_15,38
        .set t_best_12,50; .set nearest_9,51; .set nearest_10,52; .set nearest_11,53
        .set nearest_12,54; .set fz_16,25; .set disc_21,55; .set rest_20,7; .set b_16,39
        .set disc_22,44; .set rest_21,6; .set fx_13,8; .set rest_22,23; .set rest_23,29
        .set disc_23,8; .set rest_24,22; .set fz_17,23; .set y_14,25; .set rest_25,26; .set y_15,24
        .set half_4,24; .set out_9,23; .set s_11,26; .set out_10,27; .set e_9,23; .set s_12,32
        .set s_13,23; .set e_10,26; .set t_6,6; .set ahead_7,27; .set control_11,28; .set e_11,24
        .set control_12,26; .set control_13,22; .set t_7,9; .set t_8,23; .set control_14,24
        .set ahead_8,25; .set control_15,8; .set t_best_13,6; .set nearest_13,5
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
        lqd     $quad,0($object_2)                      # 23o
        rotqbyi $a_packet_2,$object_2,4                 # 24o
        lqd     $sides_2,32($object_2)                  # 25o
        rotqbyi $a_packet_3,$object_3,4                 # 26o
        lqd     $quad_2,0($object_3)                    # 27o
        nop     $127                                    # 28e pairing
        lqd     $ox_2,32($a_packet_2)                   # 28o
        fm      $quad,$quad,$k_half                     # 29e
        lqd     $oy_2,96($a_packet_2)                   # 29o
        lqd     $dx_2,224($a_packet_2)                  # 30o
        lqd     $dy_2,288($a_packet_2)                  # 31o
        nop     $127                                    # 32e pairing
        lqd     $oz_2,160($a_packet_2)                  # 32o
        fm      $quad_2,$quad_2,$k_half                 # 33e
        lqd     $dz_2,352($a_packet_2)                  # 33o
        lqd     $ox_3,48($a_packet_2)                   # 34o
        shufb   $cx_2,$quad,$quad,$m_x                  # 35o
        shufb   $cy_2,$quad,$quad,$m_y                  # 36o
        shufb   $radius2_2,$sides_2,$sides_2,$m_x       # 37o
        nop     $127                                    # 38e pairing
        shufb   $cz_2,$quad,$quad,$m_z                  # 38o
        fnms    $fx_2,$ox_2,$k_half,$cx_2               # 39e
        lqd     $oy_3,112($a_packet_2)                  # 39o
        fnms    $fy_2,$oy_2,$k_half,$cy_2               # 40e
        lqd     $dx_3,240($a_packet_2)                  # 40o
        fnms    $fx,$ox_3,$k_half,$cx_2                 # 41e
        lqd     $dy_3,304($a_packet_2)                  # 41o
        fnms    $fz_2,$oz_2,$k_half,$cz_2               # 42e
        lqd     $oz_3,176($a_packet_2)                  # 42o
        fm      $radius2_2,$radius2_2,$k_half           # 43e
        lqd     $ox_4,0($a_packet_2)                    # 43o
        nop     $127                                    # 44e pairing
        lqd     $oy,64($a_packet_2)                     # 44o
        fm      $b_2,$fx_2,$dx_2                        # 45e
        lqd     $ox_5,16($a_packet_2)                   # 45o
        fnms    $fy_3,$oy_3,$k_half,$cy_2               # 46e
        lqd     $dz_3,368($a_packet_2)                  # 46o
        fm      $b_3,$fx,$dx_3                          # 47e
        lqd     $dx_4,192($a_packet_2)                  # 47o
        fnms    $fz_3,$oz_3,$k_half,$cz_2               # 48e
        lqd     $dx_5,208($a_packet_2)                  # 48o
        fm      $radius2_2,$radius2_2,$radius2_2        # 49e
        lqd     $oy_4,80($a_packet_2)                   # 49o
        fnms    $fx_3,$ox_4,$k_half,$cx_2               # 50e
        lqd     $oz_4,144($a_packet_2)                  # 50o
        fma     $b_2,$fy_2,$dy_2,$b_2                   # 51e
        lqd     $dy_4,272($a_packet_2)                  # 51o
        fnms    $fy_4,$oy,$k_half,$cy_2                 # 52e
        lqd     $oz_5,128($a_packet_2)                  # 52o
        fma     $b_3,$fy_3,$dy_3,$b_3                   # 53e
        lqd     $dy_5,256($a_packet_2)                  # 53o
        fnms    $fx_4,$ox_5,$k_half,$cx_2               # 54e
        lqd     $dz_4,320($a_packet_2)                  # 54o
        fnms    $fy_5,$oy_4,$k_half,$cy_2               # 55e
        lqd     $dz_5,336($a_packet_2)                  # 55o
        fm      $b_4,$fx_3,$dx_4                        # 56e
        rotqbyi $sides_2,$sides_2,12                    # 56o
        fma     $b_2,$fz_2,$dz_2,$b_2                   # 57e
        shufb   $cx_2,$quad_2,$quad_2,$m_x              # 57o
        fnms    $fz_4,$oz_5,$k_half,$cz_2               # 58e
        lqd     $ox_6,0($a_packet_3)                    # 58o
        fma     $b_5,$fz_3,$dz_3,$b_3                   # 59e
        lqd     $ox_7,48($a_packet_3)                   # 59o
        fm      $b_6,$fx_4,$dx_5                        # 60e
        lqd     $dx_6,224($a_packet_3)                  # 60o
        fnms    $fz_5,$oz_4,$k_half,$cz_2               # 61e
        lqd     $ox_8,32($a_packet_3)                   # 61o
        fma     $b_4,$fy_4,$dy_5,$b_4                   # 62e
        lqd     $oy_5,64($a_packet_3)                   # 62o
        fnms    $fx_2,$b_2,$dx_2,$fx_2                  # 63e
        lqd     $ox_9,16($a_packet_3)                   # 63o
        fnms    $fy_2,$b_2,$dy_2,$fy_2                  # 64e
        lqd     $oy_6,96($a_packet_3)                   # 64o
        fnms    $fx,$b_5,$dx_3,$fx                      # 65e
        lqd     $dx_7,192($a_packet_3)                  # 65o
        fnms    $fz_6,$b_2,$dz_2,$fz_2                  # 66e
        lqd     $dx_8,208($a_packet_3)                  # 66o
        fnms    $fy_3,$b_5,$dy_3,$fy_3                  # 67e
        shufb   $cy_3,$quad_2,$quad_2,$m_y              # 67o
        fma     $b_6,$fy_5,$dy_4,$b_6                   # 68e
        lqd     $oz_6,160($a_packet_3)                  # 68o
        fm      $rest_2,$fx_2,$dx_2                     # 69e
        lqd     $oy_7,112($a_packet_3)                  # 69o
        fnms    $disc,$fx_2,$fx_2,$radius2_2            # 70e
        lqd     $dx_9,240($a_packet_3)                  # 70o
        fm      $rest_3,$fx,$dx_3                       # 71e
        lqd     $oz_7,128($a_packet_3)                  # 71o
        fnms    $disc_2,$fx,$fx,$radius2_2              # 72e
        lqd     $oz_8,176($a_packet_3)                  # 72o
        fma     $b_7,$fz_4,$dz_4,$b_4                   # 73e
        lqd     $dy_6,256($a_packet_3)                  # 73o
        fnms    $fz_3,$b_5,$dz_3,$fz_3                  # 74e
        lqd     $dy_7,304($a_packet_3)                  # 74o
        fma     $rest_2,$fy_2,$dy_2,$rest_2             # 75e
        lqd     $oy_8,80($a_packet_3)                   # 75o
        fnms    $disc,$fy_2,$fy_2,$disc                 # 76e
        lqd     $dy_8,288($a_packet_3)                  # 76o
        fma     $rest_4,$fy_3,$dy_3,$rest_3             # 77e
        lqd     $dz_6,352($a_packet_3)                  # 77o
        fnms    $disc_3,$fy_3,$fy_3,$disc_2             # 78e
        lqd     $dz_7,368($a_packet_3)                  # 78o
        fnms    $fx_3,$b_7,$dx_4,$fx_3                  # 79e
        lqd     $dy_9,272($a_packet_3)                  # 79o
        fma     $b_8,$fz_5,$dz_5,$b_6                   # 80e
        lqd     $sides_3,32($object_3)                  # 80o
        fma     $rest_5,$fz_6,$dz_2,$rest_2             # 81e
        shufb   $cz_3,$quad_2,$quad_2,$m_z              # 81o
        fnms    $disc,$fz_6,$fz_6,$disc                 # 82e
        lqd     $dz_2,320($a_packet_3)                  # 82o
        fma     $rest_4,$fz_3,$dz_3,$rest_4             # 83e
        lqd     $t_best_2,416($a_packet_2)              # 83o
        fnms    $disc_3,$fz_3,$fz_3,$disc_3             # 84e
        lqd     $dz_8,336($a_packet_3)                  # 84o
        fnms    $fy_4,$b_7,$dy_5,$fy_4                  # 85e
        lqd     $oz_9,144($a_packet_3)                  # 85o
        fnms    $fx_4,$b_8,$dx_5,$fx_4                  # 86e
        shufb   $radius2_3,$sides_3,$sides_3,$m_x       # 86o
        fnms    $disc_4,$fx_3,$fx_3,$radius2_2          # 87e
        lqd     $t_best_3,432($a_packet_2)              # 87o
        fma     $disc,$rest_5,$rest_5,$disc             # 88e
        lqd     $nearest_2,480($a_packet_2)             # 88o
        fm      $rest_6,$fx_3,$dx_4                     # 89e
        shufb   $object_4,$object_2,$object_2,$m_x      # 89o
        fma     $disc_5,$rest_4,$rest_4,$disc_3         # 90e
        shlqbyi $a_packet_4,$a_packet_2,0               # 90o copy
        fnms    $fy_5,$b_8,$dy_4,$fy_5                  # 91e
        lqd     $nearest_3,496($a_packet_2)             # 91o
        fnms    $disc_6,$fx_4,$fx_4,$radius2_2          # 92e
        lqd     $nearest_4,448($a_packet_2)             # 92o
        fm      $rest_7,$fx_4,$dx_5                     # 93e
        lqd     $nearest_5,464($a_packet_2)             # 93o
        fnms    $fz_7,$b_7,$dz_4,$fz_4                  # 94e
        frsqest $y_2,$disc                              # 94o
        fma     $rest_6,$fy_4,$dy_5,$rest_6             # 95e
        lqd     $t_best_4,384($a_packet_2)              # 95o
        fnms    $disc_7,$fy_4,$fy_4,$disc_4             # 96e
        frsqest $y_3,$disc_5                            # 96o
        fnms    $fz_5,$b_8,$dz_5,$fz_5                  # 97e
        lqd     $t_best_5,400($a_packet_2)              # 97o
        fi      $y_4,$disc,$y_2                         # 98e
        rotqbyi $sides_3,$sides_3,12                    # 98o
        rotmi   $sides_2,$sides_2,-26                   # 99e
        fnms    $disc_6,$fy_5,$fy_5,$disc_6             # 100e
        fma     $rest_6,$fz_7,$dz_4,$rest_6             # 101e
        fi      $y_5,$disc_5,$y_3                       # 102e
        rotmi   $sides_4,$sides_3,-26                   # 103e
        lqx     $half_2,$a_half,$sides_2                # 103o
        fma     $rest_8,$fy_5,$dy_4,$rest_7             # 104e
        lqx     $whole_2,$a_whole,$sides_2              # 104o
        fm      $s_2,$disc,$y_4                         # 105e
        lqx     $m_by_side_2,$a_by_side,$sides_2        # 105o
        fms     $out_2,$b_2,$b_2,$disc                  # 106e
        fnms    $fx_5,$ox_7,$k_half,$cx_2               # 107e
        fnms    $fx_6,$ox_6,$k_half,$cx_2               # 108e
        fnms    $disc_7,$fz_7,$fz_7,$disc_7             # 109e
        fnms    $fx_7,$ox_8,$k_half,$cx_2               # 110e
        fnms    $e_2,$s_2,$y_4,$k_one                   # 111e
        fm      $s_3,$disc_5,$y_5                       # 112e
        fma     $rest_8,$fz_5,$dz_5,$rest_8             # 113e
        fnms    $disc_6,$fz_5,$fz_5,$disc_6             # 114e
        fma     $disc_8,$rest_6,$rest_6,$disc_7         # 115e
        fnms    $fy_4,$oy_5,$k_half,$cy_3               # 116e
        fma     $e_2,$e_2,$half_2,$whole_2              # 117e
        fnms    $e_3,$s_3,$y_5,$k_one                   # 118e
        selb    $s_4,$s_2,$out_2,$m_by_side_2           # 119e
        fnms    $fx_8,$ox_9,$k_half,$cx_2               # 120e
        lnop                                            # 120o pairing
        fnms    $fy_6,$oy_6,$k_half,$cy_3               # 121e
        frsqest $y_6,$disc_8                            # 121o
        fm      $b_6,$fx_7,$dx_6                        # 122e
        fm      $b_9,$fx_5,$dx_9                        # 123e
        fnms    $rest_9,$s_4,$e_2,$rest_5               # 124e
        fi      $y_7,$disc_8,$y_6                       # 125e
        fnms    $fy_7,$oy_7,$k_half,$cy_3               # 127e
        fma     $disc_6,$rest_8,$rest_8,$disc_6         # 128e
        fnms    $fy_8,$oy_8,$k_half,$cy_3               # 129e
        fm      $b_4,$fx_6,$dx_7                        # 130e
        fnms    $fz_8,$oz_7,$k_half,$cz_3               # 131e
        fma     $b_10,$fy_6,$dy_8,$b_6                  # 132e
        fms     $out_3,$b_5,$b_5,$disc_5                # 133e
        lnop                                            # 133o pairing
        fm      $b_11,$fx_8,$dx_8                       # 134e
        frsqest $y_8,$disc_6                            # 134o
        fma     $e_3,$e_3,$half_2,$whole_2              # 135e
        fma     $b_9,$fy_7,$dy_7,$b_9                   # 136e
        fma     $b_4,$fy_4,$dy_6,$b_4                   # 137e
        fi      $y_8,$disc_6,$y_8                       # 138e
        selb    $s_2,$s_3,$out_3,$m_by_side_2           # 139e
        fma     $b_12,$fy_8,$dy_9,$b_11                 # 140e
        fma     $t_2,$b_2,$k_two,$rest_9                # 141e
        fnms    $fz_9,$oz_6,$k_half,$cz_3               # 142e
        fnms    $fz_10,$oz_8,$k_half,$cz_3              # 143e
        fm      $radius2_3,$radius2_3,$k_half           # 144e
        fnms    $rest_4,$s_2,$e_3,$rest_4               # 145e
        fnms    $fz_11,$oz_9,$k_half,$cz_3              # 146e
        cgt     $control_2,$t_best_2,$t_2               # 147e
        fma     $b_2,$fz_9,$dz_6,$b_10                  # 148e
        fm      $s_5,$disc_6,$y_8                       # 149e
        fm      $s_6,$disc_8,$y_7                       # 150e
        cgti    $ahead_2,$t_2,0                         # 151e
        fma     $b_3,$fz_10,$dz_7,$b_9                  # 152e
        and     $control_2,$control_2,$ahead_2          # 153e
        fma     $t_3,$b_5,$k_two,$rest_4                # 154e
        fma     $b_4,$fz_8,$dz_2,$b_4                   # 155e
        fm      $radius2_4,$radius2_3,$radius2_3        # 156e
        fnms    $fx_7,$b_2,$dx_6,$fx_7                  # 157e
        fnms    $e_4,$s_6,$y_7,$k_one                   # 158e
        andc    $control_2,$control_2,$disc             # 159e
        fnms    $fx_5,$b_3,$dx_9,$fx_5                  # 160e
        fnms    $fx_6,$b_4,$dx_7,$fx_6                  # 161e
        rotqbii $control_2,$control_2,1                 # 161o
        fma     $b_6,$fz_11,$dz_8,$b_12                 # 162e
        fms     $out_4,$b_7,$b_7,$disc_8                # 163e
        cgti    $ahead_3,$t_3,0                         # 164e
        lnop                                            # 164o pairing
        fnms    $disc_9,$fx_7,$fx_7,$radius2_4          # 165e
        gb      $control_2,$control_2                   # 165o
        fma     $e_4,$e_4,$half_2,$whole_2              # 166e
        fm      $rest_10,$fx_6,$dx_7                    # 167e
        fnms    $disc_10,$fx_6,$fx_6,$radius2_4         # 168e
        lnop                                            # 168o pairing
        fnms    $fx_8,$b_6,$dx_8,$fx_8                  # 169e
        shlqbii $control_2,$control_2,4                 # 169o
        fnms    $e_5,$s_5,$y_8,$k_one                   # 170e
        fnms    $disc_11,$fx_5,$fx_5,$radius2_4         # 171e
        fm      $rest_11,$fx_7,$dx_6                    # 172e
        lnop                                            # 172o pairing
        fms     $out_5,$b_8,$b_8,$disc_6                # 173e
        lqx     $control_2,$control_2,$a_controls       # 173o
        selb    $s_7,$s_6,$out_4,$m_by_side_2           # 174e
        fnms    $fy_7,$b_3,$dy_7,$fy_7                  # 175e
        fma     $e,$e_5,$half_2,$whole_2                # 176e
        fnms    $rest_6,$s_7,$e_4,$rest_6               # 177e
        fm      $rest_12,$fx_8,$dx_8                    # 178e
        lnop                                            # 178o pairing
        fnms    $fy_9,$b_6,$dy_9,$fy_8                  # 179e
        shufb   $t_best_6,$t_best_2,$t_2,$control_2     # 179o
        fnms    $fy_6,$b_2,$dy_8,$fy_6                  # 180e
        shufb   $nearest_6,$nearest_2,$object_4,$control_2 # 180o
        fnms    $disc_12,$fx_8,$fx_8,$radius2_4         # 181e
        fm      $rest_13,$fx_5,$dx_9                    # 182e
        fnms    $fz_8,$b_4,$dz_2,$fz_8                  # 183e
        lnop                                            # 183o pairing
        fnms    $fz_10,$b_3,$dz_7,$fz_10                # 184e
        stqd    $nearest_6,480($a_packet_4)             # 184o
        cgt     $control_2,$t_best_3,$t_3               # 185e
        stqd    $t_best_6,416($a_packet_4)              # 185o
        fnms    $disc_13,$fy_6,$fy_6,$disc_9            # 186e
        lqx     $whole_3,$a_whole,$sides_4              # 186o
        and     $control_2,$control_2,$ahead_3          # 187e
        lqx     $m_by_side_3,$a_by_side,$sides_4        # 187o
        fma     $rest_13,$fy_7,$dy_7,$rest_13           # 188e
        andc    $control_3,$control_2,$disc_5           # 189e
        fnms    $fy_4,$b_4,$dy_6,$fy_4                  # 190e
        lnop                                            # 190o pairing
        fnms    $disc_14,$fy_7,$fy_7,$disc_11           # 191e
        rotqbii $control_3,$control_3,1                 # 191o
        selb    $s_8,$s_5,$out_5,$m_by_side_2           # 192e
        fnms    $fz_12,$b_2,$dz_6,$fz_9                 # 193e
        fma     $rest_14,$fy_6,$dy_8,$rest_11           # 194e
        lnop                                            # 194o pairing
        fma     $t_4,$b_7,$k_two,$rest_6                # 195e
        gb      $control,$control_3                     # 195o
        fnms    $disc_5,$fy_4,$fy_4,$disc_10            # 196e
        fma     $rest_15,$fy_4,$dy_6,$rest_10           # 197e
        fnms    $rest,$s_8,$e,$rest_8                   # 198e
        lnop                                            # 198o pairing
        fnms    $disc_13,$fz_12,$fz_12,$disc_13         # 199e
        shlqbii $control,$control,4                     # 199o
        fma     $rest_8,$fz_12,$dz_6,$rest_14           # 200e
        fma     $rest_12,$fy_9,$dy_9,$rest_12           # 201e
        fnms    $disc_5,$fz_8,$fz_8,$disc_5             # 202e
        lnop                                            # 202o pairing
        fma     $rest_15,$fz_8,$dz_2,$rest_15           # 203e
        lqx     $control,$control,$a_controls           # 203o
        fma     $t_5,$b_8,$k_two,$rest                  # 204e
        cgt     $control_4,$t_best_4,$t_4               # 205e
        fnms    $fz_13,$b_6,$dz_8,$fz_11                # 206e
        fnms    $disc_15,$fy_9,$fy_9,$disc_12           # 207e
        fma     $rest_16,$fz_10,$dz_7,$rest_13          # 208e
        lnop                                            # 208o pairing
        fnms    $disc_16,$fz_10,$fz_10,$disc_14         # 209e
        shufb   $nearest_3,$nearest_3,$object_4,$control # 209o
        cgti    $ahead_4,$t_4,0                         # 210e
        shufb   $t_best,$t_best_3,$t_3,$control         # 210o
        cgt     $control_5,$t_best_5,$t_5               # 211e
        and     $control_4,$control_4,$ahead_4          # 212e
        fnms    $disc_15,$fz_13,$fz_13,$disc_15         # 213e
        stqd    $nearest_3,496($a_packet_4)             # 213o
        fma     $rest_17,$fz_13,$dz_8,$rest_12          # 214e
        lqx     $half_3,$a_half,$sides_4                # 214o
        fma     $disc,$rest_16,$rest_16,$disc_16        # 215e
        andc    $control_4,$control_4,$disc_8           # 216e
        fma     $disc_17,$rest_15,$rest_15,$disc_5      # 217e
        lnop                                            # 217o pairing
        fma     $disc_8,$rest_8,$rest_8,$disc_13        # 218e
        rotqbii $control_6,$control_4,1                 # 218o
        cgti    $ahead,$t_5,0                           # 219e
        fma     $disc_18,$rest_17,$rest_17,$disc_15     # 220e
        and     $control,$control_5,$ahead              # 221e
        frsqest $y_9,$disc                              # 221o
        fms     $out_6,$b_3,$b_3,$disc                  # 222e
        gb      $control_6,$control_6                   # 222o
        andc    $control,$control,$disc_6               # 223e
        frsqest $y_10,$disc_17                          # 223o
        fms     $out_7,$b_2,$b_2,$disc_8                # 224e
        frsqest $y_11,$disc_8                           # 224o
        fi      $y_12,$disc,$y_9                        # 225e
        rotqbii $control,$control,1                     # 225o
        nop     $127                                    # 226e pairing
        shlqbii $control_6,$control_6,4                 # 226o
        fms     $out_8,$b_6,$b_6,$disc_18               # 227e
        frsqest $y,$disc_18                             # 227o
        fi      $y_13,$disc_17,$y_10                    # 228e
        lnop                                            # 228o pairing
        fi      $y_11,$disc_8,$y_11                     # 229e
        gb      $control,$control                       # 229o
next_ball:
            fm      $s,$disc_8,$y_11                    # 0e
            shlqbii $control,$control,4                 # 0o
            fi      $y,$disc_18,$y                      # 1e
            stqd    $t_best,432($a_packet_4)            # 1o
        ai      $count,$count,-1                        # 2e
            lqx     $control_6,$control_6,$a_controls   # 2o
            fm      $s_9,$disc,$y_12                    # 3e
            lqd     $t_best,416($a_packet_3)            # 3o
            fm      $s_8,$disc_17,$y_13                 # 4e
            lqx     $control,$control,$a_controls       # 4o
            fms     $out,$b_4,$b_4,$disc_17             # 5e
            lqd     $nearest,480($a_packet_3)           # 5o
            fnms    $e,$s,$y_11,$k_one                  # 6e
            lqd     $nearest_7,496($a_packet_3)         # 6o
            selb    $s,$s,$out_7,$m_by_side_3           # 7e
            lqd     $t_best_7,432($a_packet_3)          # 7o
            fm      $s_10,$disc_18,$y                   # 8e
            shufb   $nearest_8,$nearest_4,$object_4,$control_6 # 8o
            fnms    $e_6,$s_9,$y_12,$k_one              # 9e
            shufb   $t_best_6,$t_best_4,$t_4,$control_6 # 9o
            fnms    $e_7,$s_8,$y_13,$k_one              # 10e
            shufb   $t_best_5,$t_best_5,$t_5,$control   # 10o
            selb    $s_9,$s_9,$out_6,$m_by_side_3       # 11e
            shufb   $nearest_4,$nearest_5,$object_4,$control # 11o
            fma     $e,$e,$half_3,$whole_3              # 12e
            shufb   $object_4,$object_3,$object_3,$m_x  # 12o
            selb    $s_8,$s_8,$out,$m_by_side_3         # 13e
            stqd    $nearest_8,448($a_packet_4)         # 13o
            fnms    $e_8,$s_10,$y,$k_one                # 14e
            stqd    $t_best_5,400($a_packet_4)          # 14o
            fma     $e_6,$e_6,$half_3,$whole_3          # 15e
        lqd     $object_3,0($a_candidate)               # 15o
            fma     $e_7,$e_7,$half_3,$whole_3          # 16e
            stqd    $nearest_4,464($a_packet_4)         # 16o
            selb    $s_10,$s_10,$out_8,$m_by_side_3     # 17e
            stqd    $t_best_6,384($a_packet_4)          # 17o
            fnms    $rest,$s,$e,$rest_8                 # 18e
            lqd     $t_best_5,400($a_packet_3)          # 18o
        ai      $a_candidate,$a_candidate,16            # 19e
            lqd     $nearest_4,448($a_packet_3)         # 19o
            fma     $e,$e_8,$half_3,$whole_3            # 20e
            lqd     $t_best_4,384($a_packet_3)          # 20o
            fnms    $rest_9,$s_9,$e_6,$rest_16          # 21e
            lqd     $nearest_5,464($a_packet_3)         # 21o
            fnms    $rest_18,$s_8,$e_7,$rest_15         # 22e
            shlqbyi $a_packet_4,$a_packet_3,0           # 22o copy
        nop     $127                                    # 23e pairing
        lqd     $quad,0($object_3)                      # 23o
            fma     $t,$b_2,$k_two,$rest                # 24e
        rotqbyi $a_packet_3,$object_3,4                 # 24o
            fnms    $rest,$s_10,$e,$rest_17             # 26e
            fma     $t_2,$b_3,$k_two,$rest_9            # 27e
            fma     $t_4,$b_4,$k_two,$rest_18           # 28e
            lnop                                        # 28o pairing
        fm      $quad,$quad,$k_half                     # 29e
        lqd     $sides_5,32($object_3)                  # 29o
            cgti    $ahead,$t,0                         # 30e
        lqd     $oy,64($a_packet_3)                     # 30o
            cgt     $control,$t_best,$t                 # 31e
        lqd     $ox_10,16($a_packet_3)                  # 31o
            fma     $t_5,$b_6,$k_two,$rest              # 32e
        lqd     $oy_2,96($a_packet_3)                   # 32o
            cgt     $control_7,$t_best_7,$t_2           # 33e
        lqd     $oy_3,112($a_packet_3)                  # 33o
            cgti    $ahead_5,$t_2,0                     # 34e
        lqd     $oy_4,80($a_packet_3)                   # 34o
            cgt     $control_8,$t_best_4,$t_4           # 35e
        lqd     $ox_3,48($a_packet_3)                   # 35o
            and     $control_7,$control_7,$ahead_5      # 36e
        shufb   $cy_2,$quad,$quad,$m_y                  # 36o
            cgti    $ahead_6,$t_4,0                     # 37e
        shufb   $cx_2,$quad,$quad,$m_x                  # 37o
            and     $control,$control,$ahead            # 38e
        lqd     $dx_2,224($a_packet_3)                  # 38o
            andc    $control_7,$control_7,$disc         # 39e
        lqd     $ox_2,32($a_packet_3)                   # 39o
            andc    $control,$control,$disc_8           # 40e
        lqd     $dx_3,240($a_packet_3)                  # 40o
        fnms    $fy_3,$oy_3,$k_half,$cy_2               # 41e
        lqd     $ox_11,0($a_packet_3)                   # 41o
        fnms    $fx,$ox_3,$k_half,$cx_2                 # 42e
        lqd     $dx_4,192($a_packet_3)                  # 42o
        fnms    $fy_4,$oy,$k_half,$cy_2                 # 43e
        lqd     $dx_5,208($a_packet_3)                  # 43o
        fnms    $fx_9,$ox_10,$k_half,$cx_2              # 44e
        lqd     $oz_5,128($a_packet_3)                  # 44o
        fnms    $fx_2,$ox_2,$k_half,$cx_2               # 45e
        shufb   $cz_2,$quad,$quad,$m_z                  # 45o
        fnms    $fy_5,$oy_4,$k_half,$cy_2               # 46e
        lqd     $oz_3,176($a_packet_3)                  # 46o
        fnms    $fx_10,$ox_11,$k_half,$cx_2             # 47e
        lqd     $oz_2,160($a_packet_3)                  # 47o
        fm      $b_3,$fx,$dx_3                          # 48e
        lqd     $oz_4,144($a_packet_3)                  # 48o
        fnms    $fy_2,$oy_2,$k_half,$cy_2               # 49e
        lqd     $dy_10,304($a_packet_3)                 # 49o
        fm      $b_6,$fx_9,$dx_5                        # 50e
        shufb   $radius2_2,$sides_5,$sides_5,$m_x       # 50o
        fm      $b_2,$fx_2,$dx_2                        # 51e
        lqd     $dy_4,272($a_packet_3)                  # 51o
        fnms    $fz_3,$oz_3,$k_half,$cz_2               # 52e
        lqd     $dy_2,288($a_packet_3)                  # 52o
        fnms    $fz_2,$oz_2,$k_half,$cz_2               # 53e
            rotqbii $control,$control,1                 # 53o
        fnms    $fz_5,$oz_4,$k_half,$cz_2               # 54e
        rotqbyi $sides_5,$sides_5,12                    # 54o
        fm      $b_4,$fx_10,$dx_4                       # 55e
        lqd     $dy_5,256($a_packet_3)                  # 55o
        fma     $b_3,$fy_3,$dy_10,$b_3                  # 56e
        lqd     $dz_3,368($a_packet_3)                  # 56o
        fma     $b_6,$fy_5,$dy_4,$b_6                   # 57e
            gb      $control,$control                   # 57o
        fma     $b_2,$fy_2,$dy_2,$b_2                   # 58e
        lqd     $dz_5,336($a_packet_3)                  # 58o
        fm      $radius2_2,$radius2_2,$k_half           # 59e
        lqd     $dz_2,352($a_packet_3)                  # 59o
        fnms    $fz_12,$oz_5,$k_half,$cz_2              # 60e
        lqd     $dz_9,320($a_packet_3)                  # 60o
        fma     $b_4,$fy_4,$dy_5,$b_4                   # 61e
            shlqbii $control,$control,4                 # 61o
        rotmi   $sides_5,$sides_5,-26                   # 62e
        fma     $b_3,$fz_3,$dz_3,$b_3                   # 63e
        fma     $b_6,$fz_5,$dz_5,$b_6                   # 64e
        lnop                                            # 64o pairing
        fma     $b_2,$fz_2,$dz_2,$b_2                   # 65e
            lqx     $control,$control,$a_controls       # 65o
        fm      $radius2_2,$radius2_2,$radius2_2        # 66e
        fma     $b_4,$fz_12,$dz_9,$b_4                  # 67e
            cgt     $control_5,$t_best_5,$t_5           # 68e
        fnms    $fx,$b_3,$dx_3,$fx                      # 69e
        fnms    $fx_9,$b_6,$dx_5,$fx_9                  # 70e
        lnop                                            # 70o pairing
        fnms    $fx_2,$b_2,$dx_2,$fx_2                  # 71e
            shufb   $nearest,$nearest,$object_4,$control # 71o
        fnms    $fy_5,$b_6,$dy_4,$fy_5                  # 72e
            shufb   $t_best,$t_best,$t,$control         # 72o
        fnms    $fy_3,$b_3,$dy_10,$fy_3                 # 73e
        fnms    $fx_10,$b_4,$dx_4,$fx_10                # 74e
        fnms    $disc_19,$fx,$fx,$radius2_2             # 75e
            stqd    $nearest,480($a_packet_4)           # 75o
        fm      $rest_12,$fx_9,$dx_5                    # 76e
            stqd    $t_best,416($a_packet_4)            # 76o
        fm      $rest_11,$fx_2,$dx_2                    # 77e
        fnms    $disc,$fx_2,$fx_2,$radius2_2            # 78e
        fnms    $fy_4,$b_4,$dy_5,$fy_4                  # 79e
        fnms    $disc_14,$fx_10,$fx_10,$radius2_2       # 80e
        fnms    $fy_2,$b_2,$dy_2,$fy_2                  # 81e
        fnms    $disc_20,$fx_9,$fx_9,$radius2_2         # 82e
        fm      $rest_17,$fx,$dx_3                      # 83e
        fnms    $fz_12,$b_4,$dz_9,$fz_12                # 84e
        fm      $rest_19,$fx_10,$dx_4                   # 85e
        fnms    $disc_14,$fy_4,$fy_4,$disc_14           # 86e
        fma     $rest_12,$fy_5,$dy_4,$rest_12           # 87e
        fnms    $disc,$fy_2,$fy_2,$disc                 # 88e
        fnms    $fz_8,$b_2,$dz_2,$fz_2                  # 89e
        lnop                                            # 89o pairing
        fnms    $disc_20,$fy_5,$fy_5,$disc_20           # 90e
            rotqbii $control,$control_7,1               # 90o
        fma     $rest_14,$fy_2,$dy_2,$rest_11           # 91e
        fnms    $fz_13,$b_6,$dz_5,$fz_5                 # 92e
        fma     $rest_15,$fy_4,$dy_5,$rest_19           # 93e
        lnop                                            # 93o pairing
        fma     $rest_16,$fy_3,$dy_10,$rest_17          # 94e
            gb      $control,$control                   # 94o
        fnms    $fz,$b_3,$dz_3,$fz_3                    # 95e
        fnms    $disc_3,$fy_3,$fy_3,$disc_19            # 96e
        fma     $rest_8,$fz_8,$dz_2,$rest_14            # 97e
        lnop                                            # 97o pairing
        fma     $rest_17,$fz_13,$dz_5,$rest_12          # 98e
            shlqbii $control,$control,4                 # 98o
        fma     $rest_15,$fz_12,$dz_9,$rest_15          # 99e
        fnms    $disc,$fz_8,$fz_8,$disc                 # 100e
        fma     $rest_16,$fz,$dz_3,$rest_16             # 101e
        lnop                                            # 101o pairing
        fnms    $disc_16,$fz,$fz,$disc_3                # 102e
            lqx     $control,$control,$a_controls       # 102o
        fnms    $disc_3,$fz_12,$fz_12,$disc_14          # 103e
            cgti    $ahead,$t_5,0                       # 104e
        fnms    $disc_20,$fz_13,$fz_13,$disc_20         # 105e
        lnop                                            # 105o pairing
        fma     $disc_8,$rest_8,$rest_8,$disc           # 106e
        hbrr    next_ball_back,next_ball                # 106o hint
            and     $control_7,$control_8,$ahead_6      # 107e
        lqx     $whole_3,$a_whole,$sides_5              # 107o
        fma     $disc,$rest_16,$rest_16,$disc_16        # 108e
            shufb   $nearest,$nearest_7,$object_4,$control # 108o
            andc    $control_9,$control_7,$disc_17      # 109e
            shufb   $t_best,$t_best_7,$t_2,$control     # 109o
        fma     $disc_17,$rest_15,$rest_15,$disc_3      # 110e
        lqx     $m_by_side_3,$a_by_side,$sides_5        # 110o
            and     $control,$control_5,$ahead          # 111e
            rotqbii $control_6,$control_9,1             # 111o
        fms     $out_7,$b_2,$b_2,$disc_8                # 112e
        frsqest $y,$disc_8                              # 112o
            andc    $control,$control,$disc_18          # 113e
            stqd    $nearest,496($a_packet_4)           # 113o
        fma     $disc_18,$rest_17,$rest_17,$disc_20     # 114e
        frsqest $y_9,$disc                              # 114o
        fms     $out_6,$b_3,$b_3,$disc                  # 115e
            rotqbii $control,$control,1                 # 115o
        fi      $y_11,$disc_8,$y                        # 116e
        frsqest $y,$disc_17                             # 116o
            nop     $127                                # 117e pairing
            gb      $control_6,$control_6               # 117o
        fi      $y_12,$disc,$y_9                        # 118e
        lqx     $half_3,$a_half,$sides_5                # 118o
            nop     $127                                # 119e pairing
            gb      $control,$control                   # 119o
        fi      $y_13,$disc_17,$y                       # 120e
        frsqest $y,$disc_18                             # 120o
            nop     $127                                # 121e pairing
            shlqbii $control_6,$control_6,4             # 121o
        fms     $out_8,$b_6,$b_6,$disc_18               # 122e
next_ball_back:
        brnz    $count,next_ball                        # 122o
next_ball_drain:
        fm      $s,$disc_8,$y_11                        # 0e
        stqd    $t_best,432($a_packet_4)                # 0o
        fm      $s_9,$disc,$y_12                        # 1e
        lqd     $t_best,416($a_packet_3)                # 1o
        fi      $y,$disc_18,$y                          # 2e
        shlqbii $control,$control,4                     # 2o
        nop     $127                                    # 3e pairing
        lqx     $control_6,$control_6,$a_controls       # 3o
        fm      $s_8,$disc_17,$y_13                     # 4e
        lqd     $t_best_8,432($a_packet_3)              # 4o
        fms     $out,$b_4,$b_4,$disc_17                 # 5e
        lqd     $nearest,480($a_packet_3)               # 5o
        fnms    $e,$s,$y_11,$k_one                      # 6e
        lqx     $control,$control,$a_controls           # 6o
        selb    $s,$s,$out_7,$m_by_side_3               # 7e
        lqd     $nearest_7,496($a_packet_3)             # 7o
        fnms    $e_6,$s_9,$y_12,$k_one                  # 8e
        shufb   $object_5,$object_3,$object_3,$m_x      # 8o
        fm      $s_10,$disc_18,$y                       # 9e
        shufb   $nearest_8,$nearest_4,$object_4,$control_6 # 9o
        selb    $s_9,$s_9,$out_6,$m_by_side_3           # 10e
        shufb   $t_best_6,$t_best_4,$t_4,$control_6     # 10o
        fnms    $e_7,$s_8,$y_13,$k_one                  # 11e
        shlqbyi $a_packet_5,$a_packet_3,0               # 11o copy
        fma     $e,$e,$half_3,$whole_3                  # 12e
        shufb   $t_best_5,$t_best_5,$t_5,$control       # 12o
        selb    $s_8,$s_8,$out,$m_by_side_3             # 13e
        shufb   $nearest_4,$nearest_5,$object_4,$control # 13o
        fma     $e_6,$e_6,$half_3,$whole_3              # 14e
        stqd    $nearest_8,448($a_packet_4)             # 14o
        fnms    $e_8,$s_10,$y,$k_one                    # 15e
        hbr     isect_sphere_pairs_refined_r16_return,$lr # 15o hint
        selb    $s_10,$s_10,$out_8,$m_by_side_3         # 16e
        stqd    $t_best_5,400($a_packet_4)              # 16o
        fma     $e_7,$e_7,$half_3,$whole_3              # 17e
        stqd    $nearest_4,464($a_packet_4)             # 17o
        fnms    $rest,$s,$e,$rest_8                     # 18e
        stqd    $t_best_6,384($a_packet_4)              # 18o
        nop     $127                                    # 19e pairing
        lqd     $t_best_4,384($a_packet_3)              # 19o
        fnms    $rest_9,$s_9,$e_6,$rest_16              # 20e
        lqd     $t_best_5,400($a_packet_3)              # 20o
        fma     $e,$e_8,$half_3,$whole_3                # 21e
        lqd     $nearest_4,448($a_packet_3)             # 21o
        lqd     $nearest_5,464($a_packet_3)             # 22o
        fnms    $rest_18,$s_8,$e_7,$rest_15             # 23e
        fma     $t,$b_2,$k_two,$rest                    # 24e
        fma     $t_2,$b_3,$k_two,$rest_9                # 26e
        fnms    $rest,$s_10,$e,$rest_17                 # 27e
        fma     $t_4,$b_4,$k_two,$rest_18               # 29e
        cgti    $ahead,$t,0                             # 30e
        cgt     $control,$t_best,$t                     # 31e
        cgt     $control_7,$t_best_8,$t_2               # 32e
        and     $control,$control,$ahead                # 33e
        cgti    $ahead_5,$t_2,0                         # 34e
        andc    $control,$control,$disc_8               # 35e
        and     $control_7,$control_7,$ahead_5          # 36e
        lnop                                            # 36o pairing
        fma     $t_5,$b_6,$k_two,$rest                  # 37e
        rotqbii $control,$control,1                     # 37o
        andc    $control_7,$control_7,$disc             # 38e
        cgt     $control_8,$t_best_4,$t_4               # 39e
        cgti    $ahead_6,$t_4,0                         # 40e
        rotqbii $control_3,$control_7,1                 # 40o
        gb      $control,$control                       # 41o
        and     $control_7,$control_8,$ahead_6          # 42e
        cgt     $control_5,$t_best_5,$t_5               # 43e
        lnop                                            # 43o pairing
        cgti    $ahead,$t_5,0                           # 44e
        gb      $control_3,$control_3                   # 44o
        andc    $control_4,$control_7,$disc_17          # 45e
        shlqbii $control,$control,4                     # 45o
        and     $control_10,$control_5,$ahead           # 46e
        rotqbii $control_4,$control_4,1                 # 47o
        andc    $control_10,$control_10,$disc_18        # 48e
        shlqbii $control_3,$control_3,4                 # 48o
        lqx     $control,$control,$a_controls           # 49o
        rotqbii $control_10,$control_10,1               # 50o
        gb      $control_4,$control_4                   # 51o
        gb      $control_10,$control_10                 # 54o
        shufb   $nearest,$nearest,$object_5,$control    # 55o
        shufb   $t_best,$t_best,$t,$control             # 56o
        shlqbii $control_4,$control_4,4                 # 57o
        shlqbii $control,$control_10,4                  # 58o
        stqd    $nearest,480($a_packet_5)               # 59o
        stqd    $t_best,416($a_packet_5)                # 60o
        lqx     $control_3,$control_3,$a_controls       # 61o
        shufb   $nearest,$nearest_7,$object_5,$control_3 # 67o
        shufb   $t_best,$t_best_8,$t_2,$control_3       # 68o
        stqd    $nearest,496($a_packet_5)               # 71o
        stqd    $t_best,432($a_packet_5)                # 72o
        lqx     $control_6,$control_4,$a_controls       # 73o
        lqx     $control,$control,$a_controls           # 74o
        shufb   $nearest_8,$nearest_4,$object_5,$control_6 # 79o
        shufb   $t_best_5,$t_best_5,$t_5,$control       # 80o
        shufb   $nearest_4,$nearest_5,$object_5,$control # 81o
        shufb   $t_best_6,$t_best_4,$t_4,$control_6     # 82o
        stqd    $nearest_8,448($a_packet_5)             # 83o
        stqd    $t_best_5,400($a_packet_5)              # 84o
        stqd    $nearest_4,464($a_packet_5)             # 85o
        stqd    $t_best_6,384($a_packet_5)              # 86o
isect_sphere_pairs_refined_r16_return:
        bi      $lr                                     # 87o
next_ball_short:
        ai      $count,$count,-1                        # 0e
        lqd     $object,0($a_candidate)                 # 0o
        ai      $a_candidate,$a_candidate,16            # 1e
        lqd     $quad,0($object)                        # 6o
        rotqbyi $a_packet,$object,4                     # 7o
        lqd     $sides,32($object)                      # 8o
        shufb   $object,$object,$object,$m_x            # 9o
        lqd     $ox,0($a_packet)                        # 11o
        fm      $quad,$quad,$k_half                     # 12e
        lqd     $ox_12,16($a_packet)                    # 12o
        lqd     $dx,192($a_packet)                      # 13o
        lqd     $oy,64($a_packet)                       # 14o
        lqd     $oz,128($a_packet)                      # 15o
        lqd     $dy,272($a_packet)                      # 16o
        lqd     $ox_13,48($a_packet)                    # 17o
        shufb   $cx,$quad,$quad,$m_x                    # 18o
        lqd     $oy_9,80($a_packet)                     # 19o
        lqd     $dx_10,208($a_packet)                   # 20o
        nop     $127                                    # 21e pairing
        shufb   $cy,$quad,$quad,$m_y                    # 21o
        fnms    $fx,$ox,$k_half,$cx                     # 22e
        lqd     $dy_3,256($a_packet)                    # 22o
        fnms    $fx_11,$ox_12,$k_half,$cx               # 23e
        lqd     $ox,32($a_packet)                       # 23o
        fnms    $fx_12,$ox_13,$k_half,$cx               # 24e
        lqd     $oz_10,144($a_packet)                   # 24o
        fnms    $fy,$oy,$k_half,$cy                     # 25e
        lqd     $oy,96($a_packet)                       # 25o
        fnms    $fy_10,$oy_9,$k_half,$cy                # 26e
        shufb   $cz,$quad,$quad,$m_z                    # 26o
        nop     $127                                    # 27e pairing
        shufb   $radius2,$sides,$sides,$m_x             # 27o
        fm      $b,$fx,$dx                              # 28e
        lqd     $oy_10,112($a_packet)                   # 28o
        fm      $b_13,$fx_11,$dx_10                     # 29e
        lqd     $dz,320($a_packet)                      # 29o
        fnms    $fz,$oz_10,$k_half,$cz                  # 30e
        lqd     $dz_10,336($a_packet)                   # 30o
        fnms    $fz_14,$oz,$k_half,$cz                  # 31e
        lqd     $dx_11,240($a_packet)                   # 31o
        fnms    $fx_4,$ox,$k_half,$cx                   # 32e
        lqd     $dy_11,288($a_packet)                   # 32o
        fnms    $fy_4,$oy,$k_half,$cy                   # 33e
        lqd     $dx_12,224($a_packet)                   # 33o
        fma     $b,$fy,$dy_3,$b                         # 34e
        lqd     $dy_12,304($a_packet)                   # 34o
        fma     $b_13,$fy_10,$dy,$b_13                  # 35e
        lqd     $oz_11,160($a_packet)                   # 35o
        fm      $radius2,$radius2,$k_half               # 36e
        lqd     $oz_12,176($a_packet)                   # 36o
        fm      $b_14,$fx_12,$dx_11                     # 37e
        lqd     $dz_11,368($a_packet)                   # 37o
        fnms    $fy_11,$oy_10,$k_half,$cy               # 38e
        lqd     $dz_12,352($a_packet)                   # 38o
        fm      $b_15,$fx_4,$dx_12                      # 39e
        rotqbyi $sides,$sides,12                        # 39o
        fma     $b,$fz_14,$dz,$b                        # 40e
        lqd     $t_best_9,384($a_packet)                # 40o
        fma     $b_13,$fz,$dz_10,$b_13                  # 41e
        lqd     $t_best_10,400($a_packet)               # 41o
        fm      $radius2,$radius2,$radius2              # 42e
        lqd     $t_best_11,416($a_packet)               # 42o
        fnms    $fz_15,$oz_11,$k_half,$cz               # 43e
        lqd     $t_best_12,432($a_packet)               # 43o
        fma     $b_14,$fy_11,$dy_12,$b_14               # 44e
        lqd     $nearest_9,464($a_packet)               # 44o
        fma     $b_15,$fy_4,$dy_11,$b_15                # 45e
        lqd     $nearest_10,448($a_packet)              # 45o
        fnms    $fx,$b,$dx,$fx                          # 46e
        lqd     $nearest_11,480($a_packet)              # 46o
        fnms    $fx_11,$b_13,$dx_10,$fx_11              # 47e
        lqd     $nearest_12,496($a_packet)              # 47o
        fnms    $fy,$b,$dy_3,$fy                        # 48e
        fnms    $fy_10,$b_13,$dy,$fy_10                 # 49e
        fnms    $fz_16,$oz_12,$k_half,$cz               # 50e
        fnms    $fz,$b_13,$dz_10,$fz                    # 51e
        fnms    $disc,$fx,$fx,$radius2                  # 52e
        fnms    $disc_21,$fx_11,$fx_11,$radius2         # 53e
        fm      $rest_9,$fx_11,$dx_10                   # 54e
        fm      $rest_20,$fx,$dx                        # 55e
        fma     $b_5,$fz_16,$dz_11,$b_14                # 56e
        fma     $b_16,$fz_15,$dz_12,$b_15               # 57e
        fnms    $disc,$fy,$fy,$disc                     # 58e
        fnms    $disc_22,$fy_10,$fy_10,$disc_21         # 59e
        fma     $rest_9,$fy_10,$dy,$rest_9              # 60e
        fma     $rest_21,$fy,$dy_3,$rest_20             # 61e
        fnms    $fz_11,$b,$dz,$fz_14                    # 62e
        fnms    $fx_13,$b_16,$dx_12,$fx_4               # 63e
        fnms    $fx_12,$b_5,$dx_11,$fx_12               # 64e
        fnms    $fy,$b_16,$dy_11,$fy_4                  # 65e
        fma     $rest_9,$fz,$dz_10,$rest_9              # 66e
        fnms    $disc_16,$fz,$fz,$disc_22               # 67e
        fnms    $disc,$fz_11,$fz_11,$disc               # 68e
        fm      $rest_22,$fx_13,$dx_12                  # 69e
        fm      $rest_23,$fx_12,$dx_11                  # 70e
        fnms    $disc_5,$fx_12,$fx_12,$radius2          # 71e
        fma     $rest_21,$fz_11,$dz,$rest_21            # 72e
        fma     $disc_15,$rest_9,$rest_9,$disc_16       # 73e
        fnms    $fy_2,$b_5,$dy_12,$fy_11                # 74e
        fnms    $disc_23,$fx_13,$fx_13,$radius2         # 75e
        fnms    $fz,$b_16,$dz_12,$fz_15                 # 76e
        fma     $rest_24,$fy,$dy_11,$rest_22            # 77e
        fma     $disc,$rest_21,$rest_21,$disc           # 78e
        lnop                                            # 78o pairing
        fnms    $fz_17,$b_5,$dz_11,$fz_16               # 79e
        frsqest $y_14,$disc_15                          # 79o
        fma     $rest_25,$fy_2,$dy_12,$rest_23          # 80e
        fnms    $disc_23,$fy,$fy,$disc_23               # 81e
        fnms    $disc_5,$fy_2,$fy_2,$disc_5             # 82e
        fma     $rest_14,$fz,$dz_12,$rest_24            # 83e
        fi      $y_13,$disc_15,$y_14                    # 84e
        frsqest $y_15,$disc                             # 84o
        rotmi   $sides,$sides,-26                       # 85e
        fma     $rest_2,$fz_17,$dz_11,$rest_25          # 86e
        fnms    $disc_23,$fz,$fz,$disc_23               # 87e
        fi      $y,$disc,$y_15                          # 88e
        nop     $127                                    # 89e pairing
        lqx     $half_4,$a_half,$sides                  # 89o
        fnms    $disc_5,$fz_17,$fz_17,$disc_5           # 90e
        lqx     $whole,$a_whole,$sides                  # 90o
        fm      $s,$disc_15,$y_13                       # 91e
        lqx     $m_by_side,$a_by_side,$sides            # 91o
        fms     $out,$b,$b,$disc                        # 92e
        fma     $disc_23,$rest_14,$rest_14,$disc_23     # 93e
        fms     $out_9,$b_13,$b_13,$disc_15             # 94e
        fm      $s_11,$disc,$y                          # 95e
        fma     $disc_5,$rest_2,$rest_2,$disc_5         # 96e
        fnms    $e_7,$s,$y_13,$k_one                    # 97e
        fms     $out_10,$b_16,$b_16,$disc_23            # 99e
        frsqest $y_5,$disc_23                           # 99o
        selb    $s,$s,$out_9,$m_by_side                 # 100e
        fnms    $e_9,$s_11,$y,$k_one                    # 101e
        selb    $s_11,$s_11,$out,$m_by_side             # 102e
        frsqest $y,$disc_5                              # 102o
        fi      $y_5,$disc_23,$y_5                      # 103e
        fma     $e_7,$e_7,$half_4,$whole                # 105e
        fi      $y,$disc_5,$y                           # 106e
        fma     $e_9,$e_9,$half_4,$whole                # 108e
        fms     $out,$b_5,$b_5,$disc_5                  # 109e
        fm      $s_12,$disc_23,$y_5                     # 110e
        fnms    $rest_9,$s,$e_7,$rest_9                 # 111e
        fm      $s,$disc_5,$y                           # 113e
        fnms    $rest_21,$s_11,$e_9,$rest_21            # 114e
        fnms    $e_7,$s_12,$y_5,$k_one                  # 116e
        fma     $t_2,$b_13,$k_two,$rest_9               # 117e
        selb    $s_13,$s_12,$out_10,$m_by_side          # 118e
        fnms    $e_10,$s,$y,$k_one                      # 119e
        fma     $t_6,$b,$k_two,$rest_21                 # 120e
        selb    $s,$s,$out,$m_by_side                   # 121e
        fma     $e_7,$e_7,$half_4,$whole                # 122e
        cgti    $ahead_7,$t_2,0                         # 123e
        cgt     $control_11,$t_best_10,$t_2             # 124e
        fma     $e_11,$e_10,$half_4,$whole              # 125e
        and     $control_12,$control_11,$ahead_7        # 126e
        cgti    $ahead_7,$t_6,0                         # 127e
        fnms    $rest_14,$s_13,$e_7,$rest_14            # 128e
        cgt     $control_13,$t_best_9,$t_6              # 129e
        andc    $control_9,$control_12,$disc_15         # 130e
        and     $control_13,$control_13,$ahead_7        # 131e
        lnop                                            # 131o pairing
        fnms    $rest_22,$s,$e_11,$rest_2               # 132e
        rotqbii $control_9,$control_9,1                 # 132o
        andc    $control_13,$control_13,$disc           # 133e
        fma     $t_7,$b_16,$k_two,$rest_14              # 134e
        rotqbii $control_13,$control_13,1               # 135o
        gb      $control_9,$control_9                   # 136o
        fma     $t_8,$b_5,$k_two,$rest_22               # 138e
        gb      $control_13,$control_13                 # 139o
        cgt     $control_14,$t_best_11,$t_7             # 140e
        shlqbii $control_9,$control_9,4                 # 140o
        cgti    $ahead_8,$t_7,0                         # 141e
        lnop                                            # 141o pairing
        and     $control_14,$control_14,$ahead_8        # 143e
        shlqbii $control_13,$control_13,4               # 143o
        cgti    $ahead_8,$t_8,0                         # 144e
        lqx     $control_9,$control_9,$a_controls       # 144o
        cgt     $control_12,$t_best_12,$t_8             # 145e
        andc    $control_15,$control_14,$disc_23        # 146e
        and     $control_14,$control_12,$ahead_8        # 147e
        lqx     $control_13,$control_13,$a_controls     # 147o
        rotqbii $control_15,$control_15,1               # 148o
        andc    $control_3,$control_14,$disc_5          # 149e
        shufb   $t_best,$t_best_10,$t_2,$control_9      # 150o
        rotqbii $control_6,$control_3,1                 # 151o
        gb      $control_3,$control_15                  # 152o
        shufb   $nearest,$nearest_10,$object,$control_13 # 153o
        shufb   $t_best_13,$t_best_9,$t_6,$control_13   # 154o
        shufb   $nearest_7,$nearest_9,$object,$control_9 # 155o
        gb      $control,$control_6                     # 156o
        stqd    $nearest,448($a_packet)                 # 157o
        stqd    $t_best_13,384($a_packet)               # 158o
        stqd    $nearest_7,464($a_packet)               # 159o
        shlqbii $control,$control,4                     # 160o
        shlqbii $control_6,$control_3,4                 # 161o
        stqd    $t_best,400($a_packet)                  # 162o
        hbrr    next_ball_short_back,next_ball_short    # 163o hint
        lqx     $control,$control,$a_controls           # 164o
        lqx     $control_6,$control_6,$a_controls       # 165o
        shufb   $nearest,$nearest_12,$object,$control   # 170o
        shufb   $nearest_13,$nearest_11,$object,$control_6 # 171o
        shufb   $t_best,$t_best_11,$t_7,$control_6      # 172o
        shufb   $t_best_6,$t_best_12,$t_8,$control      # 173o
        stqd    $nearest,496($a_packet)                 # 174o
        stqd    $nearest_13,480($a_packet)              # 175o
        stqd    $t_best,416($a_packet)                  # 176o
        stqd    $t_best_6,432($a_packet)                # 177o
        nop     $127                                    # 178e pairing
next_ball_short_back:
        brnz    $count,next_ball_short                  # 178o
        nop     $127                                    # 179e pairing
        bi      $lr                                     # 179o
endfunction isect_sphere_pairs_refined_r16
