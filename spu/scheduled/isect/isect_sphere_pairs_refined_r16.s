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
        .set dy_4,59; .set fx_3,20; .set oy_4,35; .set oz_4,53; .set fy_4,32; .set dy_5,57
        .set oz_5,48; .set fx_4,23; .set dz_4,31; .set dz_5,62; .set fy_5,35; .set b_4,60
        .set ox_6,33; .set b_5,34; .set ox_7,36; .set b_6,54; .set dx_6,37; .set fz_4,27
        .set ox_8,38; .set fz_5,53; .set oy_5,22; .set ox_9,40; .set oy_6,48; .set dx_7,49
        .set fz_6,24; .set dx_8,45; .set cy_3,51; .set oz_6,52; .set rest_2,25; .set oy_7,42
        .set dx_9,64; .set rest_3,28; .set oz_7,44; .set disc_2,29; .set oz_8,39; .set dy_6,65
        .set b_7,66; .set oy_8,60; .set dy_7,9; .set dz_6,67; .set dz_7,68; .set rest_4,8
        .set dy_8,21; .set sides_3,69; .set rest_5,63; .set cz_3,7; .set dz_8,70; .set b_8,71
        .set t_best_2,72; .set disc_3,24; .set dz_9,73; .set radius2_3,54; .set disc_4,61
        .set t_best_3,74; .set nearest_2,75; .set object_4,25; .set rest_6,5; .set a_packet_4,29
        .set disc_5,20; .set nearest_3,46; .set nearest_4,24; .set fz_7,76; .set nearest_5,28
        .set y_2,77; .set disc_6,55; .set t_best_4,27; .set rest_7,47; .set rest_8,32; .set y_3,5
        .set y_4,59; .set t_best_5,23; .set sides_4,2; .set fz_8,6; .set disc_7,53; .set sides_5,55
        .set half_2,69; .set whole_2,31; .set s_2,77; .set m_by_side_2,2; .set rest_9,35
        .set out_2,47; .set fx_5,36; .set fx_6,33; .set disc_8,57; .set e_2,59; .set fx_7,38
        .set s_3,61; .set disc_9,6; .set e_3,57; .set fy_6,22; .set e_4,5; .set s_4,47
        .set fx_8,40; .set fy_7,41; .set y_5,48; .set b_9,59; .set b_10,62; .set fy_8,42
        .set fy_9,51; .set fz_9,44; .set b_11,57; .set out_3,59; .set b_12,63; .set y_6,76
        .set s_5,59; .set b_13,61; .set t_2,47; .set fz_10,63; .set fz_11,39; .set fz_12,7
        .set control_2,8; .set s_6,50; .set s_7,57; .set ahead_2,59; .set t_3,5; .set radius2_4,34
        .set e_5,48; .set out_4,43; .set rest_10,49; .set disc_10,33; .set e_6,62; .set disc_11,76
        .set rest_11,37; .set out_5,38; .set s_8,43; .set rest_12,31; .set fy_10,43
        .set t_best_6,45; .set nearest_6,8; .set disc_12,34; .set disc_13,45; .set whole_3,36
        .set m_by_side_3,40; .set control_3,20; .set fy_11,8; .set disc_14,22; .set s_9,2
        .set fz_13,20; .set t_4,31; .set disc_15,42; .set disc_16,2; .set rest_13,38
        .set disc_17,21; .set t_5,33; .set disc_18,7; .set rest_14,34; .set disc_19,9
        .set nearest_7,22; .set ahead_3,39; .set control_4,64; .set control_5,5; .set rest_15,39
        .set half_3,42; .set disc_20,65; .set control_6,2; .set disc_21,66; .set out_6,41
        .set y_7,6; .set out_7,8; .set y_8,7; .set y_9,21; .set out_8,48; .set y_10,22; .set s_10,5
        .set s_11,6; .set nearest_8,7; .set t_best_7,8; .set s_12,9; .set nearest_9,20; .set e_7,21
        .set t_best_8,2; .set e_8,22; .set e_9,20; .set rest_16,2; .set t_6,2; .set sides_6,5
        .set ox_10,6; .set ahead_4,34; .set control_7,36; .set ahead_5,40; .set ox_11,45
        .set fx_9,6; .set fx_10,41; .set dy_9,34; .set fz_14,22; .set dz_10,48; .set disc_22,49
        .set rest_17,41; .set rest_18,9; .set control_8,7; .set t_best_9,3; .set object_5,4
        .set a_packet_5,8; .set control_9,6; .set control_10,9; .set ox_12,2; .set dx_10,5
        .set oy_9,7; .set dx_11,8; .set fx_11,2; .set dx_12,9; .set dy_10,22; .set fy_12,7
        .set oz_9,28; .set dy_11,29; .set b_14,30; .set oy_10,31; .set dz_11,33; .set fz_15,28
        .set dy_12,37; .set b_15,38; .set oz_10,43; .set dz_12,45; .set dz_13,46; .set fy_13,24
        .set b_16,31; .set t_best_10,47; .set fz_16,43; .set t_best_11,48; .set t_best_12,49
        .set nearest_10,50; .set fz_17,25; .set t_best_13,44; .set nearest_11,51
        .set nearest_12,52; .set nearest_13,53; .set half_4,54; .set whole_4,55
        .set m_by_side_4,27; .set disc_23,39; .set rest_19,7; .set disc_24,23; .set out_9,24
        .set y_11,25; .set out_10,26; .set y_12,28; .set s_13,25; .set out_11,28; .set y_13,29
        .set out_12,32; .set y_14,33; .set e_10,34; .set y_15,26; .set e_11,24; .set s_14,29
        .set s_15,33; .set t_7,7; .set control_11,26; .set ahead_6,27; .set control_12,22
        .set ahead_7,24; .set control_13,24; .set t_8,8; .set t_9,9; .set ahead_8,23
        .set ahead_9,25; .set control_14,23; .set nearest_14,5
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
        lqd     $dy_4,256($a_packet_2)                  # 49o
        fnms    $fx_3,$ox_4,$k_half,$cx_2               # 50e
        lqd     $oy_4,80($a_packet_2)                   # 50o
        fma     $b_2,$fy_2,$dy_2,$b_2                   # 51e
        lqd     $oz_4,144($a_packet_2)                  # 51o
        fnms    $fy_4,$oy,$k_half,$cy_2                 # 52e
        lqd     $dy_5,272($a_packet_2)                  # 52o
        fma     $b_3,$fy_3,$dy_3,$b_3                   # 53e
        lqd     $oz_5,128($a_packet_2)                  # 53o
        fnms    $fx_4,$ox_5,$k_half,$cx_2               # 54e
        lqd     $dz_4,320($a_packet_2)                  # 54o
        nop     $127                                    # 55e pairing
        lqd     $dz_5,336($a_packet_2)                  # 55o
        fnms    $fy_5,$oy_4,$k_half,$cy_2               # 56e
        rotqbyi $sides_2,$sides_2,12                    # 56o
        fma     $b_2,$fz_2,$dz_2,$b_2                   # 57e
        shufb   $cx_2,$quad_2,$quad_2,$m_x              # 57o
        fm      $b_4,$fx_3,$dx_4                        # 58e
        lqd     $ox_6,0($a_packet_3)                    # 58o
        fma     $b_5,$fz_3,$dz_3,$b_3                   # 59e
        lqd     $ox_7,48($a_packet_3)                   # 59o
        fm      $b_6,$fx_4,$dx_5                        # 60e
        lqd     $dx_6,224($a_packet_3)                  # 60o
        fnms    $fz_4,$oz_5,$k_half,$cz_2               # 61e
        lqd     $ox_8,32($a_packet_3)                   # 61o
        fnms    $fz_5,$oz_4,$k_half,$cz_2               # 62e
        lqd     $oy_5,64($a_packet_3)                   # 62o
        fnms    $fx_2,$b_2,$dx_2,$fx_2                  # 63e
        lqd     $ox_9,16($a_packet_3)                   # 63o
        fnms    $fy_2,$b_2,$dy_2,$fy_2                  # 64e
        lqd     $oy_6,96($a_packet_3)                   # 64o
        fnms    $fx,$b_5,$dx_3,$fx                      # 65e
        lqd     $dx_7,192($a_packet_3)                  # 65o
        fnms    $fz_6,$b_2,$dz_2,$fz_2                  # 66e
        lqd     $dx_8,208($a_packet_3)                  # 66o
        fma     $b_4,$fy_4,$dy_4,$b_4                   # 67e
        shufb   $cy_3,$quad_2,$quad_2,$m_y              # 67o
        fnms    $fy_3,$b_5,$dy_3,$fy_3                  # 68e
        lqd     $oz_6,160($a_packet_3)                  # 68o
        fm      $rest_2,$fx_2,$dx_2                     # 69e
        lqd     $oy_7,112($a_packet_3)                  # 69o
        fnms    $disc,$fx_2,$fx_2,$radius2_2            # 70e
        lqd     $dx_9,240($a_packet_3)                  # 70o
        fm      $rest_3,$fx,$dx_3                       # 71e
        lqd     $oz_7,128($a_packet_3)                  # 71o
        fnms    $disc_2,$fx,$fx,$radius2_2              # 72e
        lqd     $oz_8,176($a_packet_3)                  # 72o
        fma     $b_6,$fy_5,$dy_5,$b_6                   # 73e
        lqd     $dy_6,304($a_packet_3)                  # 73o
        fma     $b_7,$fz_4,$dz_4,$b_4                   # 74e
        lqd     $oy_8,80($a_packet_3)                   # 74o
        fma     $rest_2,$fy_2,$dy_2,$rest_2             # 75e
        lqd     $dy_2,288($a_packet_3)                  # 75o
        fnms    $disc,$fy_2,$fy_2,$disc                 # 76e
        lqd     $dy_7,256($a_packet_3)                  # 76o
        fnms    $fz_3,$b_5,$dz_3,$fz_3                  # 77e
        lqd     $dz_6,352($a_packet_3)                  # 77o
        fnms    $disc_2,$fy_3,$fy_3,$disc_2             # 78e
        lqd     $dz_7,368($a_packet_3)                  # 78o
        fma     $rest_4,$fy_3,$dy_3,$rest_3             # 79e
        lqd     $dy_8,272($a_packet_3)                  # 79o
        fnms    $fx_3,$b_7,$dx_4,$fx_3                  # 80e
        lqd     $sides_3,32($object_3)                  # 80o
        fma     $rest_5,$fz_6,$dz_2,$rest_2             # 81e
        shufb   $cz_3,$quad_2,$quad_2,$m_z              # 81o
        fnms    $disc,$fz_6,$fz_6,$disc                 # 82e
        lqd     $dz_8,320($a_packet_3)                  # 82o
        fma     $b_8,$fz_5,$dz_5,$b_6                   # 83e
        lqd     $t_best_2,416($a_packet_2)              # 83o
        fnms    $disc_3,$fz_3,$fz_3,$disc_2             # 84e
        lqd     $dz_9,336($a_packet_3)                  # 84o
        fma     $rest_4,$fz_3,$dz_3,$rest_4             # 85e
        lqd     $oz_3,144($a_packet_3)                  # 85o
        fnms    $fy_4,$b_7,$dy_4,$fy_4                  # 86e
        shufb   $radius2_3,$sides_3,$sides_3,$m_x       # 86o
        fnms    $disc_4,$fx_3,$fx_3,$radius2_2          # 87e
        lqd     $t_best_3,432($a_packet_2)              # 87o
        fma     $disc,$rest_5,$rest_5,$disc             # 88e
        lqd     $nearest_2,480($a_packet_2)             # 88o
        fnms    $fx_4,$b_8,$dx_5,$fx_4                  # 89e
        shufb   $object_4,$object_2,$object_2,$m_x      # 89o
        fm      $rest_6,$fx_3,$dx_4                     # 90e
        shlqbyi $a_packet_4,$a_packet_2,0               # 90o copy
        fma     $disc_5,$rest_4,$rest_4,$disc_3         # 91e
        lqd     $nearest_3,496($a_packet_2)             # 91o
        fnms    $fy_5,$b_8,$dy_5,$fy_5                  # 92e
        lqd     $nearest_4,448($a_packet_2)             # 92o
        fnms    $fz_7,$b_7,$dz_4,$fz_4                  # 93e
        lqd     $nearest_5,464($a_packet_2)             # 93o
        fnms    $disc_4,$fy_4,$fy_4,$disc_4             # 94e
        frsqest $y_2,$disc                              # 94o
        fnms    $disc_6,$fx_4,$fx_4,$radius2_2          # 95e
        lqd     $t_best_4,384($a_packet_2)              # 95o
        fm      $rest_7,$fx_4,$dx_5                     # 96e
        rotqbyi $sides_3,$sides_3,12                    # 96o
        fma     $rest_8,$fy_4,$dy_4,$rest_6             # 97e
        frsqest $y_3,$disc_5                            # 97o
        fi      $y_4,$disc,$y_2                         # 98e
        lqd     $t_best_5,400($a_packet_2)              # 98o
        rotmi   $sides_4,$sides_2,-26                   # 99e
        fnms    $fz_8,$b_8,$dz_5,$fz_5                  # 100e
        fnms    $disc_7,$fy_5,$fy_5,$disc_6             # 101e
        fi      $y_3,$disc_5,$y_3                       # 102e
        rotmi   $sides_5,$sides_3,-26                   # 103e
        lqx     $half_2,$a_half,$sides_4                # 103o
        fma     $rest_8,$fz_7,$dz_4,$rest_8             # 104e
        lqx     $whole_2,$a_whole,$sides_4              # 104o
        fm      $s_2,$disc,$y_4                         # 105e
        lqx     $m_by_side_2,$a_by_side,$sides_4        # 105o
        fma     $rest_9,$fy_5,$dy_5,$rest_7             # 106e
        fms     $out_2,$b_2,$b_2,$disc                  # 107e
        fnms    $fx_5,$ox_7,$k_half,$cx_2               # 108e
        fnms    $fx_6,$ox_6,$k_half,$cx_2               # 109e
        fnms    $disc_8,$fz_7,$fz_7,$disc_4             # 110e
        fnms    $e_2,$s_2,$y_4,$k_one                   # 111e
        fnms    $fx_7,$ox_8,$k_half,$cx_2               # 112e
        fm      $s_3,$disc_5,$y_3                       # 113e
        fma     $rest_9,$fz_8,$dz_5,$rest_9             # 114e
        fnms    $disc_9,$fz_8,$fz_8,$disc_7             # 115e
        fma     $disc_7,$rest_8,$rest_8,$disc_8         # 116e
        fma     $e_3,$e_2,$half_2,$whole_2              # 117e
        fnms    $fy_6,$oy_5,$k_half,$cy_3               # 118e
        fnms    $e_4,$s_3,$y_3,$k_one                   # 119e
        selb    $s_4,$s_2,$out_2,$m_by_side_2           # 120e
        fnms    $fx_8,$ox_9,$k_half,$cx_2               # 121e
        fnms    $fy_7,$oy_6,$k_half,$cy_3               # 122e
        frsqest $y_5,$disc_7                            # 122o
        fm      $b_9,$fx_7,$dx_6                        # 123e
        fm      $b_10,$fx_5,$dx_9                       # 124e
        fnms    $rest_7,$s_4,$e_3,$rest_5               # 125e
        fi      $y_5,$disc_7,$y_5                       # 126e
        fnms    $fy_8,$oy_7,$k_half,$cy_3               # 128e
        fma     $disc_9,$rest_9,$rest_9,$disc_9         # 129e
        fnms    $fy_9,$oy_8,$k_half,$cy_3               # 130e
        fm      $b_4,$fx_6,$dx_7                        # 131e
        fnms    $fz_9,$oz_7,$k_half,$cz_3               # 132e
        fma     $b_11,$fy_7,$dy_2,$b_9                  # 133e
        fms     $out_3,$b_5,$b_5,$disc_5                # 134e
        lnop                                            # 134o pairing
        fm      $b_12,$fx_8,$dx_8                       # 135e
        frsqest $y_6,$disc_9                            # 135o
        fma     $e_4,$e_4,$half_2,$whole_2              # 136e
        fma     $b_10,$fy_8,$dy_6,$b_10                 # 137e
        fma     $b_4,$fy_6,$dy_7,$b_4                   # 138e
        fi      $y_6,$disc_9,$y_6                       # 139e
        selb    $s_5,$s_3,$out_3,$m_by_side_2           # 140e
        fma     $b_13,$fy_9,$dy_8,$b_12                 # 141e
        fma     $t_2,$b_2,$k_two,$rest_7                # 142e
        fnms    $fz_10,$oz_6,$k_half,$cz_3              # 143e
        fnms    $fz_11,$oz_8,$k_half,$cz_3              # 144e
        fm      $radius2_3,$radius2_3,$k_half           # 145e
        fnms    $rest_6,$s_5,$e_4,$rest_4               # 146e
        fnms    $fz_12,$oz_3,$k_half,$cz_3              # 147e
        cgt     $control_2,$t_best_2,$t_2               # 148e
        fma     $b_2,$fz_10,$dz_6,$b_11                 # 149e
        fm      $s_6,$disc_9,$y_6                       # 150e
        fm      $s_7,$disc_7,$y_5                       # 151e
        cgti    $ahead_2,$t_2,0                         # 152e
        fma     $b_3,$fz_11,$dz_7,$b_10                 # 153e
        and     $control_2,$control_2,$ahead_2          # 154e
        fma     $t_3,$b_5,$k_two,$rest_6                # 155e
        fma     $b_4,$fz_9,$dz_8,$b_4                   # 156e
        fm      $radius2_4,$radius2_3,$radius2_3        # 157e
        fnms    $fx_7,$b_2,$dx_6,$fx_7                  # 158e
        fnms    $e_5,$s_7,$y_5,$k_one                   # 159e
        andc    $control_2,$control_2,$disc             # 160e
        fnms    $fx_5,$b_3,$dx_9,$fx_5                  # 161e
        fnms    $fx_6,$b_4,$dx_7,$fx_6                  # 162e
        rotqbii $control_2,$control_2,1                 # 162o
        fma     $b_6,$fz_12,$dz_9,$b_13                 # 163e
        fms     $out_4,$b_7,$b_7,$disc_7                # 164e
        cgti    $ahead_2,$t_3,0                         # 165e
        lnop                                            # 165o pairing
        fnms    $disc_4,$fx_7,$fx_7,$radius2_4          # 166e
        gb      $control_2,$control_2                   # 166o
        fma     $e_5,$e_5,$half_2,$whole_2              # 167e
        fm      $rest_10,$fx_6,$dx_7                    # 168e
        fnms    $disc_10,$fx_6,$fx_6,$radius2_4         # 169e
        lnop                                            # 169o pairing
        fnms    $fx_8,$b_6,$dx_8,$fx_8                  # 170e
        shlqbii $control_2,$control_2,4                 # 170o
        fnms    $e_6,$s_6,$y_6,$k_one                   # 171e
        fnms    $disc_11,$fx_5,$fx_5,$radius2_4         # 172e
        fm      $rest_11,$fx_7,$dx_6                    # 173e
        lnop                                            # 173o pairing
        fms     $out_5,$b_8,$b_8,$disc_9                # 174e
        lqx     $control_2,$control_2,$a_controls       # 174o
        selb    $s_8,$s_7,$out_4,$m_by_side_2           # 175e
        fnms    $fy_8,$b_3,$dy_6,$fy_8                  # 176e
        fma     $e_3,$e_6,$half_2,$whole_2              # 177e
        fnms    $rest_12,$s_8,$e_5,$rest_8              # 178e
        fm      $rest_8,$fx_8,$dx_8                     # 179e
        lnop                                            # 179o pairing
        fnms    $fy_10,$b_6,$dy_8,$fy_9                 # 180e
        shufb   $t_best_6,$t_best_2,$t_2,$control_2     # 180o
        fnms    $fy_7,$b_2,$dy_2,$fy_7                  # 181e
        shufb   $nearest_6,$nearest_2,$object_4,$control_2 # 181o
        fnms    $disc_12,$fx_8,$fx_8,$radius2_4         # 182e
        fm      $rest_7,$fx_5,$dx_9                     # 183e
        fnms    $fz_9,$b_4,$dz_8,$fz_9                  # 184e
        lnop                                            # 184o pairing
        fnms    $fz_11,$b_3,$dz_7,$fz_11                # 185e
        stqd    $nearest_6,480($a_packet_4)             # 185o
        cgt     $control_2,$t_best_3,$t_3               # 186e
        stqd    $t_best_6,416($a_packet_4)              # 186o
        fnms    $disc_13,$fy_7,$fy_7,$disc_4            # 187e
        lqx     $whole_3,$a_whole,$sides_5              # 187o
        and     $control_2,$control_2,$ahead_2          # 188e
        lqx     $m_by_side_3,$a_by_side,$sides_5        # 188o
        fma     $rest_7,$fy_8,$dy_6,$rest_7             # 189e
        andc    $control_3,$control_2,$disc_5           # 190e
        fnms    $fy_11,$b_4,$dy_7,$fy_6                 # 191e
        lnop                                            # 191o pairing
        fnms    $disc_14,$fy_8,$fy_8,$disc_11           # 192e
        rotqbii $control,$control_3,1                   # 192o
        selb    $s_9,$s_6,$out_5,$m_by_side_2           # 193e
        fnms    $fz_13,$b_2,$dz_6,$fz_10                # 194e
        fma     $rest_11,$fy_7,$dy_2,$rest_11           # 195e
        lnop                                            # 195o pairing
        fma     $t_4,$b_7,$k_two,$rest_12               # 196e
        gb      $control,$control                       # 196o
        fnms    $disc_15,$fy_11,$fy_11,$disc_10         # 197e
        fma     $rest_4,$fy_11,$dy_7,$rest_10           # 198e
        fnms    $rest,$s_9,$e_3,$rest_9                 # 199e
        lnop                                            # 199o pairing
        fnms    $disc_16,$fz_13,$fz_13,$disc_13         # 200e
        shlqbii $control,$control,4                     # 200o
        fma     $rest_9,$fz_13,$dz_6,$rest_11           # 201e
        fma     $rest_13,$fy_10,$dy_8,$rest_8           # 202e
        fnms    $disc_17,$fz_9,$fz_9,$disc_15           # 203e
        lnop                                            # 203o pairing
        fma     $rest_8,$fz_9,$dz_8,$rest_4             # 204e
        lqx     $control,$control,$a_controls           # 204o
        fma     $t_5,$b_8,$k_two,$rest                  # 205e
        cgt     $control_2,$t_best_4,$t_4               # 206e
        fnms    $fz_13,$b_6,$dz_9,$fz_12                # 207e
        fnms    $disc_18,$fy_10,$fy_10,$disc_12         # 208e
        fma     $rest_14,$fz_11,$dz_7,$rest_7           # 209e
        lnop                                            # 209o pairing
        fnms    $disc_19,$fz_11,$fz_11,$disc_14         # 210e
        shufb   $nearest_7,$nearest_3,$object_4,$control # 210o
        cgti    $ahead_3,$t_4,0                         # 211e
        shufb   $t_best,$t_best_3,$t_3,$control         # 211o
        cgt     $control_4,$t_best_5,$t_5               # 212e
        and     $control_5,$control_2,$ahead_3          # 213e
        fnms    $disc_18,$fz_13,$fz_13,$disc_18         # 214e
        stqd    $nearest_7,496($a_packet_4)             # 214o
        fma     $rest_15,$fz_13,$dz_9,$rest_13          # 215e
        lqx     $half_3,$a_half,$sides_5                # 215o
        fma     $disc,$rest_14,$rest_14,$disc_19        # 216e
        andc    $control_5,$control_5,$disc_7           # 217e
        fma     $disc_20,$rest_8,$rest_8,$disc_17       # 218e
        lnop                                            # 218o pairing
        fma     $disc_7,$rest_9,$rest_9,$disc_16        # 219e
        rotqbii $control_6,$control_5,1                 # 219o
        cgti    $ahead,$t_5,0                           # 220e
        fma     $disc_21,$rest_15,$rest_15,$disc_18     # 221e
        and     $control,$control_4,$ahead              # 222e
        frsqest $y_3,$disc                              # 222o
        fms     $out_6,$b_3,$b_3,$disc                  # 223e
        gb      $control_6,$control_6                   # 223o
        andc    $control,$control,$disc_9               # 224e
        frsqest $y_7,$disc_20                           # 224o
        fms     $out_7,$b_2,$b_2,$disc_7                # 225e
        frsqest $y_8,$disc_7                            # 225o
        fi      $y_9,$disc,$y_3                         # 226e
        rotqbii $control,$control,1                     # 226o
        nop     $127                                    # 227e pairing
        shlqbii $control_6,$control_6,4                 # 227o
        fms     $out_8,$b_6,$b_6,$disc_21               # 228e
        frsqest $y,$disc_21                             # 228o
        fi      $y_10,$disc_20,$y_7                     # 229e
        lnop                                            # 229o pairing
        fi      $y_8,$disc_7,$y_8                       # 230e
        gb      $control,$control                       # 230o
next_ball:
            fm      $s,$disc_7,$y_8                     # 0e
            shlqbii $control,$control,4                 # 0o
            fi      $y,$disc_21,$y                      # 1e
            stqd    $t_best,432($a_packet_4)            # 1o
        ai      $count,$count,-1                        # 2e
            lqx     $control_6,$control_6,$a_controls   # 2o
            fm      $s_10,$disc,$y_9                    # 3e
            lqd     $t_best,416($a_packet_3)            # 3o
            fm      $s_11,$disc_20,$y_10                # 4e
            lqx     $control,$control,$a_controls       # 4o
            fms     $out,$b_4,$b_4,$disc_20             # 5e
            lqd     $nearest,480($a_packet_3)           # 5o
            fnms    $e,$s,$y_8,$k_one                   # 6e
            lqd     $nearest_8,496($a_packet_3)         # 6o
            selb    $s,$s,$out_7,$m_by_side_3           # 7e
            lqd     $t_best_7,432($a_packet_3)          # 7o
            fm      $s_12,$disc_21,$y                   # 8e
            shufb   $nearest_9,$nearest_4,$object_4,$control_6 # 8o
            fnms    $e_7,$s_10,$y_9,$k_one              # 9e
            shufb   $t_best_8,$t_best_4,$t_4,$control_6 # 9o
            fnms    $e_8,$s_11,$y_10,$k_one             # 10e
            shufb   $t_best_5,$t_best_5,$t_5,$control   # 10o
            selb    $s_10,$s_10,$out_6,$m_by_side_3     # 11e
            shufb   $nearest_4,$nearest_5,$object_4,$control # 11o
            fma     $e,$e,$half_3,$whole_3              # 12e
            shufb   $object_4,$object_3,$object_3,$m_x  # 12o
            selb    $s_11,$s_11,$out,$m_by_side_3       # 13e
            stqd    $nearest_9,448($a_packet_4)         # 13o
            fnms    $e_9,$s_12,$y,$k_one                # 14e
            stqd    $t_best_5,400($a_packet_4)          # 14o
            fma     $e_7,$e_7,$half_3,$whole_3          # 15e
        lqd     $object_3,0($a_candidate)               # 15o
            fma     $e_8,$e_8,$half_3,$whole_3          # 16e
            stqd    $nearest_4,464($a_packet_4)         # 16o
            selb    $s_12,$s_12,$out_8,$m_by_side_3     # 17e
            stqd    $t_best_8,384($a_packet_4)          # 17o
            fnms    $rest,$s,$e,$rest_9                 # 18e
            lqd     $t_best_5,400($a_packet_3)          # 18o
        ai      $a_candidate,$a_candidate,16            # 19e
            lqd     $nearest_4,448($a_packet_3)         # 19o
            fma     $e,$e_9,$half_3,$whole_3            # 20e
            lqd     $t_best_4,384($a_packet_3)          # 20o
            fnms    $rest_16,$s_10,$e_7,$rest_14        # 21e
            lqd     $nearest_5,464($a_packet_3)         # 21o
            fnms    $rest_6,$s_11,$e_8,$rest_8          # 22e
            shlqbyi $a_packet_4,$a_packet_3,0           # 22o copy
        nop     $127                                    # 23e pairing
        lqd     $quad,0($object_3)                      # 23o
            fma     $t,$b_2,$k_two,$rest                # 24e
        rotqbyi $a_packet_3,$object_3,4                 # 24o
            fnms    $rest,$s_12,$e,$rest_15             # 26e
            fma     $t_6,$b_3,$k_two,$rest_16           # 27e
            fma     $t_4,$b_4,$k_two,$rest_6            # 28e
            lnop                                        # 28o pairing
        fm      $quad,$quad,$k_half                     # 29e
        lqd     $sides_6,32($object_3)                  # 29o
            cgti    $ahead,$t,0                         # 30e
        lqd     $oy,64($a_packet_3)                     # 30o
            cgt     $control,$t_best,$t                 # 31e
        lqd     $ox_10,16($a_packet_3)                  # 31o
            fma     $t_5,$b_6,$k_two,$rest              # 32e
        lqd     $oy_2,96($a_packet_3)                   # 32o
            cgt     $control_3,$t_best_7,$t_6           # 33e
        lqd     $oy_3,112($a_packet_3)                  # 33o
            cgti    $ahead_4,$t_6,0                     # 34e
        lqd     $oy_4,80($a_packet_3)                   # 34o
            cgt     $control_7,$t_best_4,$t_4           # 35e
        lqd     $ox_3,48($a_packet_3)                   # 35o
            and     $control_3,$control_3,$ahead_4      # 36e
        shufb   $cy_2,$quad,$quad,$m_y                  # 36o
            cgti    $ahead_5,$t_4,0                     # 37e
        shufb   $cx_2,$quad,$quad,$m_x                  # 37o
            and     $control,$control,$ahead            # 38e
        lqd     $dx_2,224($a_packet_3)                  # 38o
            andc    $control_3,$control_3,$disc         # 39e
        lqd     $ox_2,32($a_packet_3)                   # 39o
            andc    $control,$control,$disc_7           # 40e
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
        lqd     $dy_9,304($a_packet_3)                  # 49o
        fm      $b_6,$fx_9,$dx_5                        # 50e
        shufb   $radius2_2,$sides_6,$sides_6,$m_x       # 50o
        fm      $b_2,$fx_2,$dx_2                        # 51e
        lqd     $dy_5,272($a_packet_3)                  # 51o
        fnms    $fz_3,$oz_3,$k_half,$cz_2               # 52e
        lqd     $dy_2,288($a_packet_3)                  # 52o
        fnms    $fz_2,$oz_2,$k_half,$cz_2               # 53e
            rotqbii $control,$control,1                 # 53o
        fnms    $fz_5,$oz_4,$k_half,$cz_2               # 54e
        lqd     $dy_4,256($a_packet_3)                  # 54o
        fm      $b_4,$fx_10,$dx_4                       # 55e
        rotqbyi $sides_6,$sides_6,12                    # 55o
        fma     $b_3,$fy_3,$dy_9,$b_3                   # 56e
        lqd     $dz_3,368($a_packet_3)                  # 56o
        fma     $b_6,$fy_5,$dy_5,$b_6                   # 57e
            gb      $control,$control                   # 57o
        fma     $b_2,$fy_2,$dy_2,$b_2                   # 58e
        lqd     $dz_5,336($a_packet_3)                  # 58o
        fm      $radius2_2,$radius2_2,$k_half           # 59e
        lqd     $dz_2,352($a_packet_3)                  # 59o
        fnms    $fz_14,$oz_5,$k_half,$cz_2              # 60e
        lqd     $dz_10,320($a_packet_3)                 # 60o
        fma     $b_4,$fy_4,$dy_4,$b_4                   # 61e
            shlqbii $control,$control,4                 # 61o
        rotmi   $sides_6,$sides_6,-26                   # 62e
        fma     $b_3,$fz_3,$dz_3,$b_3                   # 63e
        fma     $b_6,$fz_5,$dz_5,$b_6                   # 64e
        lnop                                            # 64o pairing
        fma     $b_2,$fz_2,$dz_2,$b_2                   # 65e
            lqx     $control,$control,$a_controls       # 65o
        fm      $radius2_2,$radius2_2,$radius2_2        # 66e
        fma     $b_4,$fz_14,$dz_10,$b_4                 # 67e
            cgt     $control_4,$t_best_5,$t_5           # 68e
        fnms    $fx,$b_3,$dx_3,$fx                      # 69e
        fnms    $fx_9,$b_6,$dx_5,$fx_9                  # 70e
        lnop                                            # 70o pairing
        fnms    $fx_2,$b_2,$dx_2,$fx_2                  # 71e
            shufb   $nearest,$nearest,$object_4,$control # 71o
        fnms    $fy_5,$b_6,$dy_5,$fy_5                  # 72e
            shufb   $t_best,$t_best,$t,$control         # 72o
        fnms    $fy_3,$b_3,$dy_9,$fy_3                  # 73e
        fnms    $fx_10,$b_4,$dx_4,$fx_10                # 74e
        fnms    $disc_22,$fx,$fx,$radius2_2             # 75e
            stqd    $nearest,480($a_packet_4)           # 75o
        fm      $rest_13,$fx_9,$dx_5                    # 76e
            stqd    $t_best,416($a_packet_4)            # 76o
        fm      $rest_11,$fx_2,$dx_2                    # 77e
        fnms    $disc,$fx_2,$fx_2,$radius2_2            # 78e
        fnms    $fy_4,$b_4,$dy_4,$fy_4                  # 79e
        fnms    $disc_15,$fx_10,$fx_10,$radius2_2       # 80e
        fnms    $fy_2,$b_2,$dy_2,$fy_2                  # 81e
        fnms    $disc_9,$fx_9,$fx_9,$radius2_2          # 82e
        fm      $rest_15,$fx,$dx_3                      # 83e
        fnms    $fz_14,$b_4,$dz_10,$fz_14               # 84e
        fm      $rest_17,$fx_10,$dx_4                   # 85e
        fnms    $disc_15,$fy_4,$fy_4,$disc_15           # 86e
        fma     $rest_13,$fy_5,$dy_5,$rest_13           # 87e
        fnms    $disc,$fy_2,$fy_2,$disc                 # 88e
        fnms    $fz_9,$b_2,$dz_2,$fz_2                  # 89e
        lnop                                            # 89o pairing
        fnms    $disc_9,$fy_5,$fy_5,$disc_9             # 90e
            rotqbii $control,$control_3,1               # 90o
        fma     $rest_18,$fy_2,$dy_2,$rest_11           # 91e
        fnms    $fz_13,$b_6,$dz_5,$fz_5                 # 92e
        fma     $rest_8,$fy_4,$dy_4,$rest_17            # 93e
        lnop                                            # 93o pairing
        fma     $rest_14,$fy_3,$dy_9,$rest_15           # 94e
            gb      $control,$control                   # 94o
        fnms    $fz,$b_3,$dz_3,$fz_3                    # 95e
        fnms    $disc_17,$fy_3,$fy_3,$disc_22           # 96e
        fma     $rest_9,$fz_9,$dz_2,$rest_18            # 97e
        lnop                                            # 97o pairing
        fma     $rest_15,$fz_13,$dz_5,$rest_13          # 98e
            shlqbii $control,$control,4                 # 98o
        fma     $rest_8,$fz_14,$dz_10,$rest_8           # 99e
        fnms    $disc,$fz_9,$fz_9,$disc                 # 100e
        fma     $rest_14,$fz,$dz_3,$rest_14             # 101e
        lnop                                            # 101o pairing
        fnms    $disc_19,$fz,$fz,$disc_17               # 102e
            lqx     $control,$control,$a_controls       # 102o
        fnms    $disc_17,$fz_14,$fz_14,$disc_15         # 103e
            cgti    $ahead,$t_5,0                       # 104e
        fnms    $disc_9,$fz_13,$fz_13,$disc_9           # 105e
        hbrr    next_ball_back,next_ball                # 105o hint
        fma     $disc_7,$rest_9,$rest_9,$disc           # 106e
        lnop                                            # 106o pairing
            and     $control_3,$control_7,$ahead_5      # 107e
        lqx     $whole_3,$a_whole,$sides_6              # 107o
        fma     $disc,$rest_14,$rest_14,$disc_19        # 108e
            shufb   $nearest,$nearest_8,$object_4,$control # 108o
            andc    $control_8,$control_3,$disc_20      # 109e
            shufb   $t_best,$t_best_7,$t_6,$control     # 109o
        fma     $disc_20,$rest_8,$rest_8,$disc_17       # 110e
        lqx     $m_by_side_3,$a_by_side,$sides_6        # 110o
            and     $control,$control_4,$ahead          # 111e
            rotqbii $control_6,$control_8,1             # 111o
        fms     $out_7,$b_2,$b_2,$disc_7                # 112e
        frsqest $y,$disc_7                              # 112o
            andc    $control,$control,$disc_21          # 113e
            stqd    $nearest,496($a_packet_4)           # 113o
        fma     $disc_21,$rest_15,$rest_15,$disc_9      # 114e
        frsqest $y_7,$disc                              # 114o
        fms     $out_6,$b_3,$b_3,$disc                  # 115e
            rotqbii $control,$control,1                 # 115o
        fi      $y_8,$disc_7,$y                         # 116e
        frsqest $y,$disc_20                             # 116o
            nop     $127                                # 117e pairing
            gb      $control_6,$control_6               # 117o
        fi      $y_9,$disc,$y_7                         # 118e
        lqx     $half_3,$a_half,$sides_6                # 118o
            nop     $127                                # 119e pairing
            gb      $control,$control                   # 119o
        fi      $y_10,$disc_20,$y                       # 120e
        frsqest $y,$disc_21                             # 120o
            nop     $127                                # 121e pairing
            shlqbii $control_6,$control_6,4             # 121o
        fms     $out_8,$b_6,$b_6,$disc_21               # 122e
next_ball_back:
        brnz    $count,next_ball                        # 122o
next_ball_drain:
        fm      $s,$disc_7,$y_8                         # 0e
        stqd    $t_best,432($a_packet_4)                # 0o
        fm      $s_10,$disc,$y_9                        # 1e
        lqd     $t_best,416($a_packet_3)                # 1o
        fi      $y,$disc_21,$y                          # 2e
        shlqbii $control,$control,4                     # 2o
        nop     $127                                    # 3e pairing
        lqx     $control_6,$control_6,$a_controls       # 3o
        fm      $s_11,$disc_20,$y_10                    # 4e
        lqd     $t_best_9,432($a_packet_3)              # 4o
        fms     $out,$b_4,$b_4,$disc_20                 # 5e
        lqd     $nearest,480($a_packet_3)               # 5o
        fnms    $e,$s,$y_8,$k_one                       # 6e
        lqx     $control,$control,$a_controls           # 6o
        selb    $s,$s,$out_7,$m_by_side_3               # 7e
        lqd     $nearest_8,496($a_packet_3)             # 7o
        fnms    $e_7,$s_10,$y_9,$k_one                  # 8e
        shufb   $object_5,$object_3,$object_3,$m_x      # 8o
        fm      $s_12,$disc_21,$y                       # 9e
        shufb   $nearest_9,$nearest_4,$object_4,$control_6 # 9o
        selb    $s_10,$s_10,$out_6,$m_by_side_3         # 10e
        shufb   $t_best_8,$t_best_4,$t_4,$control_6     # 10o
        fnms    $e_8,$s_11,$y_10,$k_one                 # 11e
        shlqbyi $a_packet_5,$a_packet_3,0               # 11o copy
        fma     $e,$e,$half_3,$whole_3                  # 12e
        shufb   $t_best_5,$t_best_5,$t_5,$control       # 12o
        selb    $s_11,$s_11,$out,$m_by_side_3           # 13e
        shufb   $nearest_4,$nearest_5,$object_4,$control # 13o
        fma     $e_7,$e_7,$half_3,$whole_3              # 14e
        stqd    $nearest_9,448($a_packet_4)             # 14o
        fnms    $e_9,$s_12,$y,$k_one                    # 15e
        hbr     isect_sphere_pairs_refined_r16_return,$lr # 15o hint
        selb    $s_12,$s_12,$out_8,$m_by_side_3         # 16e
        stqd    $t_best_5,400($a_packet_4)              # 16o
        fma     $e_8,$e_8,$half_3,$whole_3              # 17e
        stqd    $nearest_4,464($a_packet_4)             # 17o
        fnms    $rest,$s,$e,$rest_9                     # 18e
        stqd    $t_best_8,384($a_packet_4)              # 18o
        nop     $127                                    # 19e pairing
        lqd     $t_best_4,384($a_packet_3)              # 19o
        fnms    $rest_16,$s_10,$e_7,$rest_14            # 20e
        lqd     $t_best_5,400($a_packet_3)              # 20o
        fma     $e,$e_9,$half_3,$whole_3                # 21e
        lqd     $nearest_4,448($a_packet_3)             # 21o
        lqd     $nearest_5,464($a_packet_3)             # 22o
        fnms    $rest_6,$s_11,$e_8,$rest_8              # 23e
        fma     $t,$b_2,$k_two,$rest                    # 24e
        fma     $t_6,$b_3,$k_two,$rest_16               # 26e
        fnms    $rest,$s_12,$e,$rest_15                 # 27e
        fma     $t_4,$b_4,$k_two,$rest_6                # 29e
        cgti    $ahead,$t,0                             # 30e
        cgt     $control,$t_best,$t                     # 31e
        cgt     $control_3,$t_best_9,$t_6               # 32e
        and     $control,$control,$ahead                # 33e
        cgti    $ahead_4,$t_6,0                         # 34e
        andc    $control,$control,$disc_7               # 35e
        and     $control_3,$control_3,$ahead_4          # 36e
        lnop                                            # 36o pairing
        fma     $t_5,$b_6,$k_two,$rest                  # 37e
        rotqbii $control,$control,1                     # 37o
        andc    $control_3,$control_3,$disc             # 38e
        cgt     $control_7,$t_best_4,$t_4               # 39e
        cgti    $ahead_5,$t_4,0                         # 40e
        rotqbii $control_5,$control_3,1                 # 40o
        gb      $control,$control                       # 41o
        and     $control_3,$control_7,$ahead_5          # 42e
        cgt     $control_4,$t_best_5,$t_5               # 43e
        lnop                                            # 43o pairing
        cgti    $ahead,$t_5,0                           # 44e
        gb      $control_5,$control_5                   # 44o
        andc    $control_9,$control_3,$disc_20          # 45e
        shlqbii $control,$control,4                     # 45o
        and     $control_10,$control_4,$ahead           # 46e
        rotqbii $control_9,$control_9,1                 # 47o
        andc    $control_10,$control_10,$disc_21        # 48e
        shlqbii $control_5,$control_5,4                 # 48o
        lqx     $control,$control,$a_controls           # 49o
        rotqbii $control_10,$control_10,1               # 50o
        gb      $control_9,$control_9                   # 51o
        gb      $control_10,$control_10                 # 54o
        shufb   $nearest,$nearest,$object_5,$control    # 55o
        shufb   $t_best,$t_best,$t,$control             # 56o
        shlqbii $control_9,$control_9,4                 # 57o
        shlqbii $control,$control_10,4                  # 58o
        stqd    $nearest,480($a_packet_5)               # 59o
        stqd    $t_best,416($a_packet_5)                # 60o
        lqx     $control_5,$control_5,$a_controls       # 61o
        shufb   $nearest,$nearest_8,$object_5,$control_5 # 67o
        shufb   $t_best,$t_best_9,$t_6,$control_5       # 68o
        stqd    $nearest,496($a_packet_5)               # 71o
        stqd    $t_best,432($a_packet_5)                # 72o
        lqx     $control_6,$control_9,$a_controls       # 73o
        lqx     $control,$control,$a_controls           # 74o
        shufb   $nearest_9,$nearest_4,$object_5,$control_6 # 79o
        shufb   $t_best_5,$t_best_5,$t_5,$control       # 80o
        shufb   $nearest_4,$nearest_5,$object_5,$control # 81o
        shufb   $t_best_8,$t_best_4,$t_4,$control_6     # 82o
        stqd    $nearest_9,448($a_packet_5)             # 83o
        stqd    $t_best_5,400($a_packet_5)              # 84o
        stqd    $nearest_4,464($a_packet_5)             # 85o
        stqd    $t_best_8,384($a_packet_5)              # 86o
isect_sphere_pairs_refined_r16_return:
        bi      $lr                                     # 87o
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
        lqd     $ox_12,0($a_packet)                     # 13o
        lqd     $dx_10,208($a_packet)                   # 14o
        lqd     $ox_10,48($a_packet)                    # 15o
        lqd     $oy_9,64($a_packet)                     # 16o
        shufb   $radius2,$sides,$sides,$m_x             # 17o
        lqd     $dy,256($a_packet)                      # 18o
        shufb   $cx,$quad,$quad,$m_x                    # 19o
        nop     $127                                    # 20e pairing
        shufb   $cy,$quad,$quad,$m_y                    # 20o
        fm      $radius2,$radius2,$k_half               # 21e
        shufb   $cz,$quad,$quad,$m_z                    # 21o
        nop     $127                                    # 22e pairing
        lqd     $dx_11,224($a_packet)                   # 22o
        fnms    $fx,$ox_12,$k_half,$cx                  # 23e
        lqd     $oz,128($a_packet)                      # 23o
        fnms    $fx_11,$ox,$k_half,$cx                  # 24e
        lqd     $dx_12,240($a_packet)                   # 24o
        fnms    $fy,$oy,$k_half,$cy                     # 25e
        lqd     $ox,32($a_packet)                       # 25o
        fnms    $fx_9,$ox_10,$k_half,$cx                # 26e
        lqd     $dy_10,272($a_packet)                   # 26o
        fnms    $fy_12,$oy_9,$k_half,$cy                # 27e
        lqd     $oz_9,144($a_packet)                    # 27o
        fm      $radius2,$radius2,$radius2              # 28e
        lqd     $dy_11,288($a_packet)                   # 28o
        fm      $b,$fx,$dx                              # 29e
        lqd     $dz,336($a_packet)                      # 29o
        fm      $b_14,$fx_11,$dx_10                     # 30e
        lqd     $oy,96($a_packet)                       # 30o
        fnms    $fx_4,$ox,$k_half,$cx                   # 31e
        lqd     $oy_10,112($a_packet)                   # 31o
        fnms    $fz,$oz,$k_half,$cz                     # 32e
        lqd     $dz_11,320($a_packet)                   # 32o
        fnms    $fz_15,$oz_9,$k_half,$cz                # 33e
        lqd     $dy_12,304($a_packet)                   # 33o
        fm      $b_15,$fx_9,$dx_12                      # 34e
        lqd     $oz_10,176($a_packet)                   # 34o
        fma     $b,$fy_12,$dy,$b                        # 35e
        lqd     $oz_7,160($a_packet)                    # 35o
        fma     $b_14,$fy,$dy_10,$b_14                  # 36e
        lqd     $dz_12,368($a_packet)                   # 36o
        fnms    $fy_4,$oy,$k_half,$cy                   # 37e
        lqd     $dz_13,352($a_packet)                   # 37o
        fnms    $fy_13,$oy_10,$k_half,$cy               # 38e
        rotqbyi $sides,$sides,12                        # 38o
        fm      $b_16,$fx_4,$dx_11                      # 39e
        lqd     $t_best_10,400($a_packet)               # 39o
        fnms    $fz_16,$oz_10,$k_half,$cz               # 40e
        lqd     $t_best_11,384($a_packet)               # 40o
        fma     $b,$fz,$dz_11,$b                        # 41e
        lqd     $t_best_12,432($a_packet)               # 41o
        fma     $b_14,$fz_15,$dz,$b_14                  # 42e
        lqd     $nearest_10,464($a_packet)              # 42o
        fnms    $fz_17,$oz_7,$k_half,$cz                # 43e
        lqd     $t_best_13,416($a_packet)               # 43o
        fma     $b_15,$fy_13,$dy_12,$b_15               # 44e
        lqd     $nearest_11,448($a_packet)              # 44o
        fma     $b_16,$fy_4,$dy_11,$b_16                # 45e
        lqd     $nearest_12,496($a_packet)              # 45o
        rotmi   $sides,$sides,-26                       # 46e
        lqd     $nearest_13,480($a_packet)              # 46o
        fnms    $fx,$b,$dx,$fx                          # 47e
        fnms    $fy_12,$b,$dy,$fy_12                    # 48e
        fnms    $fy,$b_14,$dy_10,$fy                    # 49e
        lnop                                            # 49o pairing
        fma     $b_15,$fz_16,$dz_12,$b_15               # 50e
        lqx     $half_4,$a_half,$sides                  # 50o
        fnms    $fz_15,$b_14,$dz,$fz_15                 # 51e
        lqx     $whole_4,$a_whole,$sides                # 51o
        fnms    $fx_11,$b_14,$dx_10,$fx_11              # 52e
        lqx     $m_by_side_4,$a_by_side,$sides          # 52o
        fm      $rest_14,$fx,$dx                        # 53e
        fnms    $disc_23,$fx,$fx,$radius2               # 54e
        fnms    $fz,$b,$dz_11,$fz                       # 55e
        fnms    $fx_9,$b_15,$dx_12,$fx_9                # 56e
        fma     $b_16,$fz_17,$dz_13,$b_16               # 57e
        fm      $rest_6,$fx_11,$dx_10                   # 58e
        fnms    $disc_16,$fx_11,$fx_11,$radius2         # 59e
        fnms    $disc_23,$fy_12,$fy_12,$disc_23         # 60e
        fma     $rest_19,$fy_12,$dy,$rest_14            # 61e
        fm      $rest_18,$fx_9,$dx_12                   # 62e
        fnms    $fx_4,$b_16,$dx_11,$fx_4                # 63e
        fnms    $fy_4,$b_16,$dy_11,$fy_4                # 64e
        fnms    $disc_16,$fy,$fy,$disc_16               # 65e
        fma     $rest_6,$fy,$dy_10,$rest_6              # 66e
        fma     $rest_19,$fz,$dz_11,$rest_19            # 67e
        fnms    $disc_9,$fx_9,$fx_9,$radius2            # 68e
        fm      $rest_4,$fx_4,$dx_11                    # 69e
        fnms    $disc_14,$fx_4,$fx_4,$radius2           # 70e
        fnms    $disc_16,$fz_15,$fz_15,$disc_16         # 71e
        fma     $rest_6,$fz_15,$dz,$rest_6              # 72e
        fnms    $disc_24,$fz,$fz,$disc_23               # 73e
        fnms    $fz,$b_15,$dz_12,$fz_16                 # 74e
        fnms    $fy,$b_15,$dy_12,$fy_13                 # 75e
        fnms    $disc,$fy_4,$fy_4,$disc_14              # 76e
        fnms    $fz_14,$b_16,$dz_13,$fz_17              # 77e
        fma     $disc_16,$rest_6,$rest_6,$disc_16       # 78e
        fma     $disc_24,$rest_19,$rest_19,$disc_24     # 79e
        fma     $rest_4,$fy_4,$dy_11,$rest_4            # 80e
        fma     $rest_18,$fy,$dy_12,$rest_18            # 81e
        fnms    $disc_9,$fy,$fy,$disc_9                 # 82e
        fnms    $disc,$fz_14,$fz_14,$disc               # 83e
        lnop                                            # 83o pairing
        fms     $out_9,$b_14,$b_14,$disc_16             # 84e
        frsqest $y_11,$disc_16                          # 84o
        fms     $out_10,$b,$b,$disc_24                  # 85e
        frsqest $y_12,$disc_24                          # 85o
        fma     $rest_4,$fz_14,$dz_13,$rest_4           # 86e
        fma     $rest_18,$fz,$dz_12,$rest_18            # 87e
        fnms    $disc_9,$fz,$fz,$disc_9                 # 88e
        fi      $y,$disc_16,$y_11                       # 89e
        fi      $y_10,$disc_24,$y_12                    # 90e
        fma     $disc,$rest_4,$rest_4,$disc             # 92e
        fma     $disc_9,$rest_18,$rest_18,$disc_9       # 94e
        fm      $s,$disc_16,$y                          # 96e
        fm      $s_13,$disc_24,$y_10                    # 97e
        lnop                                            # 97o pairing
        fms     $out_11,$b_16,$b_16,$disc               # 98e
        frsqest $y_13,$disc                             # 98o
        fms     $out_12,$b_15,$b_15,$disc_9             # 100e
        frsqest $y_14,$disc_9                           # 100o
        fnms    $e_10,$s,$y,$k_one                      # 102e
        fnms    $e_8,$s_13,$y_10,$k_one                 # 103e
        fi      $y,$disc,$y_13                          # 104e
        selb    $s_13,$s_13,$out_10,$m_by_side_4        # 105e
        fi      $y_15,$disc_9,$y_14                     # 106e
        selb    $s,$s,$out_9,$m_by_side_4               # 107e
        fma     $e_11,$e_10,$half_4,$whole_4            # 108e
        fma     $e_8,$e_8,$half_4,$whole_4              # 109e
        fm      $s_14,$disc,$y                          # 111e
        fm      $s_15,$disc_9,$y_15                     # 113e
        fnms    $rest_6,$s,$e_11,$rest_6                # 114e
        fnms    $rest_19,$s_13,$e_8,$rest_19            # 115e
        fnms    $e_8,$s_14,$y,$k_one                    # 117e
        selb    $s,$s_14,$out_11,$m_by_side_4           # 118e
        fnms    $e_11,$s_15,$y_15,$k_one                # 119e
        selb    $s_13,$s_15,$out_12,$m_by_side_4        # 120e
        fma     $t_7,$b,$k_two,$rest_19                 # 121e
        fma     $t_3,$b_14,$k_two,$rest_6               # 122e
        fma     $e_8,$e_8,$half_4,$whole_4              # 123e
        fma     $e_11,$e_11,$half_4,$whole_4            # 125e
        cgt     $control_11,$t_best_11,$t_7             # 127e
        cgti    $ahead_6,$t_3,0                         # 128e
        fnms    $rest_4,$s,$e_8,$rest_4                 # 129e
        cgt     $control_12,$t_best_10,$t_3             # 130e
        fnms    $rest_18,$s_13,$e_11,$rest_18           # 131e
        cgti    $ahead_7,$t_7,0                         # 132e
        and     $control_12,$control_12,$ahead_6        # 133e
        and     $control_13,$control_11,$ahead_7        # 134e
        andc    $control_6,$control_12,$disc_16         # 135e
        fma     $t_8,$b_16,$k_two,$rest_4               # 136e
        fma     $t_9,$b_15,$k_two,$rest_18              # 137e
        rotqbii $control_6,$control_6,1                 # 137o
        andc    $control_12,$control_13,$disc_24        # 138e
        rotqbii $control_12,$control_12,1               # 140o
        gb      $control_6,$control_6                   # 141o
        cgti    $ahead_8,$t_8,0                         # 142e
        cgt     $control_13,$t_best_12,$t_9             # 143e
        lnop                                            # 143o pairing
        cgti    $ahead_9,$t_9,0                         # 144e
        gb      $control_12,$control_12                 # 144o
        cgt     $control_11,$t_best_13,$t_8             # 145e
        shlqbii $control_6,$control_6,4                 # 145o
        and     $control_13,$control_13,$ahead_9        # 146e
        and     $control_14,$control_11,$ahead_8        # 147e
        andc    $control_9,$control_13,$disc_9          # 148e
        shlqbii $control_12,$control_12,4               # 148o
        andc    $control_14,$control_14,$disc           # 149e
        lqx     $control_6,$control_6,$a_controls       # 149o
        rotqbii $control_9,$control_9,1                 # 150o
        rotqbii $control_14,$control_14,1               # 151o
        lqx     $control_12,$control_12,$a_controls     # 152o
        gb      $control_9,$control_9                   # 154o
        shufb   $nearest,$nearest_10,$object,$control_6 # 155o
        gb      $control_14,$control_14                 # 156o
        shufb   $t_best,$t_best_10,$t_3,$control_6      # 157o
        shufb   $t_best_8,$t_best_11,$t_7,$control_12   # 158o
        stqd    $nearest,464($a_packet)                 # 159o
        shlqbii $control_5,$control_14,4                # 160o
        stqd    $t_best,400($a_packet)                  # 161o
        stqd    $t_best_8,384($a_packet)                # 162o
        shlqbii $control_6,$control_9,4                 # 163o
        shufb   $nearest,$nearest_11,$object,$control_12 # 164o
        lqx     $control,$control_5,$a_controls         # 165o
        lqx     $control_6,$control_6,$a_controls       # 167o
        stqd    $nearest,448($a_packet)                 # 168o
        hbrr    next_ball_short_back,next_ball_short    # 169o hint
        shufb   $nearest,$nearest_13,$object,$control   # 171o
        shufb   $t_best,$t_best_13,$t_8,$control        # 172o
        shufb   $nearest_14,$nearest_12,$object,$control_6 # 173o
        shufb   $t_best_8,$t_best_12,$t_9,$control_6    # 174o
        stqd    $nearest,480($a_packet)                 # 175o
        stqd    $t_best,416($a_packet)                  # 176o
        stqd    $nearest_14,496($a_packet)              # 177o
        stqd    $t_best_8,432($a_packet)                # 178o
        nop     $127                                    # 179e pairing
next_ball_short_back:
        brnz    $count,next_ball_short                  # 185o
        nop     $127                                    # 180e pairing
        bi      $lr                                     # 180o
endfunction isect_sphere_pairs_refined_r16
