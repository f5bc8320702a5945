# isect_sphere_pairs_r16   nearest hit of packets' rays with spheres, candidate by candidate
#   C       void isect_sphere_pairs_r16(const struct candidate *, int count);
#   In      $3 candidates of objects that are spheres, $4 count (0 is none); pointers 16-aligned
#   Out     the candidates' packets: t, object, where a hit has 0 < t < what was there
#   Uses    $2-$74, $79   Saves  -   Stack  0   Calls  -
#   Domain  |d| = 1 within 4 ulp; coordinates and radius below 2^62, radius above 2^-40
#   Error   25 ulp of the larger of t and r, origin up to 30 radii from the centre, ray within
#           0.995 r of it
#   Twin    lab/twins/src/sphere/perpendicular.rs
#
# The steps are in sphere_tmpl.inc. The hit is the entry; with SIDES_EXIT it is the exit, and with
# SIDES_BOTH it is also the exit of a ray from inside.
# Scheduled by spu schedule from isect_sphere_pairs_r16.s

        .include "sphere_general.inc"
        .include "sphere_perpendicular.inc"

        general_registers "k_one", "radius2", "out,y,s,e"
        sign_controls_table
        sides_tables 0x3f000000, 0x3f800000

function isect_sphere_pairs_r16
        .set count_2,79; .set a_candidate_2,2; .set object_2,5; .set object_3,6; .set ox_2,8
        .set ox_3,24; .set cx_2,22; .set ox_4,27; .set oy_2,28; .set cy_2,31; .set fx_2,24
        .set fx_3,8; .set oy_3,29; .set fx_4,22; .set dx_2,33; .set fy_2,30; .set dx_3,27
        .set dx_4,28; .set oy_4,26; .set oz_2,34; .set fy_3,29; .set dy_2,39; .set cz_2,20
        .set b_2,41; .set oz_3,42; .set b_3,43; .set oz_4,44; .set b_4,45; .set oz_5,47
        .set fz_2,34; .set dy_3,49; .set fy_4,26; .set dy_4,31; .set dy_5,50; .set fz_3,42
        .set radius2_2,51; .set fz_4,44; .set fz_5,20; .set dz_2,47; .set dz_3,52; .set dz_4,53
        .set dz_5,54; .set nearest_2,58; .set nearest_3,59; .set t_best_2,60; .set t_best_3,61
        .set b_5,55; .set t_best_4,62; .set half_2,2; .set m_by_side_2,5; .set whole_2,7
        .set nearest_4,63; .set fz_6,33; .set a_packet_2,9; .set fy_5,27; .set quad_2,21
        .set disc_2,24; .set disc_3,22; .set disc_4,28; .set ox_5,23; .set disc_5,8; .set ox_6,32
        .set cx_3,37; .set ox_7,31; .set oy_5,27; .set oy_6,34; .set cy_3,44; .set dx_5,26
        .set dx_6,45; .set dx_7,38; .set fx_5,29; .set oy_7,46; .set disc_6,56; .set oz_6,8
        .set disc_7,54; .set fx_6,20; .set cz_3,21; .set out_2,22; .set y_2,32; .set disc_8,57
        .set fx_7,23; .set oz_7,28; .set out_3,47; .set y_3,48; .set y_4,49; .set oz_8,50
        .set out_4,51; .set dy_6,52; .set y_5,53; .set dy_7,64; .set dy_8,65; .set out_5,66
        .set radius2_3,67; .set s_2,68; .set dz_6,69; .set dz_7,70; .set s_3,71; .set dz_8,72
        .set s_4,73; .set dz_9,74; .set fx_8,31; .set e_2,32; .set s_5,22; .set s_6,37; .set e_3,48
        .set s_7,47; .set e_4,49; .set s_8,51; .set e_5,53; .set s_9,5; .set e_6,37; .set t_2,22
        .set fy_6,32; .set e_7,2; .set t_3,34; .set t_4,37; .set t_5,7; .set control_2,2
        .set ahead_2,5; .set control_3,40; .set control_4,5; .set fy_7,24; .set b_6,30; .set fz_7,8
        .set fy_8,44; .set fz_8,28; .set fz_9,21; .set t_best_5,22; .set nearest_5,46
        .set ahead_3,30; .set fx_9,26; .set disc_9,20; .set fy_9,31; .set disc_10,26
        .set disc_11,29; .set disc_12,23; .set nearest_6,33; .set t_best_6,5; .set nearest_7,23
        .set disc_13,31; .set t_best_7,2; .set y_6,8; .set out_6,2; .set y_7,20; .set y_8,5
        .set out_7,21; .set y_9,22; .set s_10,23; .set out_8,24; .set s_11,25; .set s_12,29
        .set s_13,8; .set e_8,20; .set e_9,30; .set e_10,5; .set s_14,7; .set e_11,8; .set t_6,5
        .set t_7,2; .set control_5,21; .set ahead_4,23; .set control_6,26; .set control_7,23
        .set ahead_5,45; .set t_best_8,26; .set nearest_8,27; .set fz_10,29; .set nearest_9,30
        .set nearest_10,24; .set a_packet_3,3; .set e_12,4; .set ahead_6,4; .set control_8,4
        .set ox_8,2; .set dx_8,5; .set oy_8,6; .set fx_10,2; .set dx_9,7; .set dy_9,9; .set fy_10,6
        .set b_7,24; .set dz_10,27; .set radius2_4,28; .set dx_10,29; .set fx_11,21; .set oz_9,23
        .set oy_9,35; .set dz_11,36; .set dy_10,42; .set dy_11,43; .set b_8,44; .set dz_12,45
        .set fz_11,23; .set fy_11,22; .set t_best_9,46; .set t_best_10,47; .set t_best_11,48
        .set nearest_11,49; .set nearest_12,31; .set nearest_13,50; .set nearest_14,9; .set b_9,5
        .set b_10,32; .set disc_14,2; .set fy_12,7; .set fz_12,6; .set disc_15,21; .set fz_13,22
        .set disc_16,7; .set out_9,20; .set y_10,21; .set disc_17,6; .set y_11,7; .set y_12,25
        .set out_10,29; .set s_15,20; .set e_13,7; .set e_14,22; .set s_16,21; .set t_8,24
        .set ahead_7,20; .set control_9,20; .set t_9,21; .set control_10,22; .set ahead_8,22
        .set control_11,25; .set control_12,6; .set control_13,8; .set t_best_12,20
        .set nearest_15,6
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
        ai      $a_candidate_2,$a_candidate,16          # 13e
        lqd     $object_2,0($a_candidate)               # 13o
        ai      $count,$count,-1                        # 14e
        lnop                                            # 14o pairing
        ai      $a_candidate,$a_candidate_2,16          # 15e
        lqd     $object_3,0($a_candidate_2)             # 15o
        ai      $count,$count,-1                        # 16e
        rotqbyi $a_packet,$object_2,4                   # 19o
        lqd     $quad,0($object_2)                      # 20o
        lqd     $sides,32($object_2)                    # 21o
        shufb   $object,$object_2,$object_2,$m_x        # 22o
        lqd     $ox,32($a_packet)                       # 23o
        lqd     $ox_2,48($a_packet)                     # 24o
        lqd     $ox_3,0($a_packet)                      # 25o
        shufb   $cx_2,$quad,$quad,$m_x                  # 26o
        lqd     $ox_4,16($a_packet)                     # 27o
        lqd     $oy,80($a_packet)                       # 28o
        lqd     $oy_2,96($a_packet)                     # 29o
        fs      $fx,$cx_2,$ox                           # 30e
        shufb   $cy_2,$quad,$quad,$m_y                  # 30o
        fs      $fx_2,$cx_2,$ox_3                       # 31e
        lqd     $dx,208($a_packet)                      # 31o
        fs      $fx_3,$cx_2,$ox_2                       # 32e
        lqd     $oy_3,64($a_packet)                     # 32o
        fs      $fx_4,$cx_2,$ox_4                       # 33e
        lqd     $dx_2,192($a_packet)                    # 33o
        fs      $fy_2,$cy_2,$oy                         # 34e
        lqd     $dx_3,224($a_packet)                    # 34o
        fs      $fy,$cy_2,$oy_2                         # 35e
        lqd     $dx_4,240($a_packet)                    # 35o
        lqd     $oy_4,112($a_packet)                    # 36o
        lqd     $oz_2,176($a_packet)                    # 37o
        fs      $fy_3,$cy_2,$oy_3                       # 38e
        lqd     $dy_2,256($a_packet)                    # 38o
        fm      $b,$fx_2,$dx_2                          # 39e
        shufb   $cz_2,$quad,$quad,$m_z                  # 39o
        fm      $b_2,$fx_4,$dx                          # 40e
        lqd     $oz_3,160($a_packet)                    # 40o
        fm      $b_3,$fx_3,$dx_4                        # 41e
        lqd     $oz_4,128($a_packet)                    # 41o
        fm      $b_4,$fx,$dx_3                          # 42e
        lqd     $oz_5,144($a_packet)                    # 42o
        fs      $fz_2,$cz_2,$oz_2                       # 43e
        lqd     $dy_3,272($a_packet)                    # 43o
        fs      $fy_4,$cy_2,$oy_4                       # 44e
        lqd     $dy_4,288($a_packet)                    # 44o
        fma     $b,$fy_3,$dy_2,$b                       # 45e
        lqd     $dy_5,304($a_packet)                    # 45o
        fs      $fz_3,$cz_2,$oz_3                       # 46e
        shufb   $radius2_2,$sides,$sides,$m_x           # 46o
        fs      $fz_4,$cz_2,$oz_4                       # 47e
        rotqbyi $sides,$sides,12                        # 47o
        fs      $fz_5,$cz_2,$oz_5                       # 48e
        lqd     $dz_2,320($a_packet)                    # 48o
        fma     $b_2,$fy_2,$dy_3,$b_2                   # 49e
        lqd     $dz_3,336($a_packet)                    # 49o
        fma     $b_4,$fy,$dy_4,$b_4                     # 50e
        lqd     $dz_4,352($a_packet)                    # 50o
        fma     $b_3,$fy_4,$dy_5,$b_3                   # 51e
        lqd     $dz_5,368($a_packet)                    # 51o
        fm      $radius2_2,$radius2_2,$radius2_2        # 52e
        lqd     $nearest_2,464($a_packet)               # 52o
        rotmi   $sides,$sides,-26                       # 53e
        lqd     $nearest_3,496($a_packet)               # 53o
        fma     $b,$fz_4,$dz_2,$b                       # 54e
        lqd     $t_best_2,384($a_packet)                # 54o
        fma     $b_2,$fz_5,$dz_3,$b_2                   # 55e
        lqd     $t_best_3,432($a_packet)                # 55o
        fma     $b_5,$fz_3,$dz_4,$b_4                   # 56e
        lqd     $t_best_4,400($a_packet)                # 56o
        fma     $b_3,$fz_2,$dz_5,$b_3                   # 57e
        lqx     $half_2,$a_half,$sides                  # 57o
        lqx     $m_by_side_2,$a_by_side,$sides          # 58o
        lqx     $whole_2,$a_whole,$sides                # 59o
        fnms    $fx_2,$b,$dx_2,$fx_2                    # 60e
        lqd     $nearest_4,448($a_packet)               # 60o
        fnms    $fz_6,$b,$dz_2,$fz_4                    # 61e
        lqd     $t_best,416($a_packet)                  # 61o
        fnms    $fx_4,$b_2,$dx,$fx_4                    # 62e
        shlqbyi $a_packet_2,$a_packet,0                 # 62o copy
        fnms    $fx,$b_5,$dx_3,$fx                      # 63e
        lqd     $nearest,480($a_packet)                 # 63o
        fnms    $fx_3,$b_3,$dx_4,$fx_3                  # 64e
        rotqbyi $a_packet,$object_3,4                   # 64o
        fnms    $fy_5,$b,$dy_2,$fy_3                    # 65e
        lqd     $quad_2,0($object_3)                    # 65o
        fnms    $disc_2,$fx_2,$fx_2,$radius2_2          # 66e
        lqd     $sides,32($object_3)                    # 66o
        fnms    $fy_4,$b_3,$dy_5,$fy_4                  # 67e
        lnop                                            # 67o pairing
        fnms    $disc_3,$fx_4,$fx_4,$radius2_2          # 68e
        lqd     $ox,32($a_packet)                       # 68o
        fnms    $disc_4,$fx,$fx,$radius2_2              # 69e
        lqd     $ox_5,48($a_packet)                     # 69o
        fnms    $disc_5,$fx_3,$fx_3,$radius2_2          # 70e
        lqd     $ox_6,0($a_packet)                      # 70o
        fnms    $fy_2,$b_2,$dy_3,$fy_2                  # 71e
        shufb   $cx_3,$quad_2,$quad_2,$m_x              # 71o
        fnms    $fy,$b_5,$dy_4,$fy                      # 72e
        lqd     $ox_7,16($a_packet)                     # 72o
        fnms    $disc_2,$fy_5,$fy_5,$disc_2             # 73e
        lqd     $oy_5,80($a_packet)                     # 73o
        fnms    $fz,$b_3,$dz_5,$fz_2                    # 74e
        lqd     $oy_6,96($a_packet)                     # 74o
        fnms    $fz_5,$b_2,$dz_3,$fz_5                  # 75e
        shufb   $cy_3,$quad_2,$quad_2,$m_y              # 75o
        fnms    $disc_5,$fy_4,$fy_4,$disc_5             # 76e
        lqd     $dx_5,208($a_packet)                    # 76o
        fnms    $disc_3,$fy_2,$fy_2,$disc_3             # 77e
        lqd     $oy,64($a_packet)                       # 77o
        fnms    $fz_3,$b_5,$dz_4,$fz_3                  # 78e
        lqd     $dx_6,192($a_packet)                    # 78o
        fnms    $disc_2,$fz_6,$fz_6,$disc_2             # 79e
        lqd     $dx_2,224($a_packet)                    # 79o
        fnms    $disc_4,$fy,$fy,$disc_4                 # 80e
        lqd     $dx_7,240($a_packet)                    # 80o
        fs      $fx_5,$cx_3,$ox                         # 81e
        lqd     $oy_7,112($a_packet)                    # 81o
        fnms    $disc_6,$fz,$fz,$disc_5                 # 82e
        lqd     $oz_6,176($a_packet)                    # 82o
        fnms    $disc_7,$fz_5,$fz_5,$disc_3             # 83e
        lqd     $dy_2,256($a_packet)                    # 83o
        fs      $fx_6,$cx_3,$ox_6                       # 84e
        shufb   $cz_3,$quad_2,$quad_2,$m_z              # 84o
        fms     $out_2,$b,$b,$disc_2                    # 85e
        frsqest $y_2,$disc_2                            # 85o
        fnms    $disc_8,$fz_3,$fz_3,$disc_4             # 86e
        lqd     $oz_3,160($a_packet)                    # 86o
        fs      $fx_7,$cx_3,$ox_5                       # 87e
        lqd     $oz_7,128($a_packet)                    # 87o
        fms     $out_3,$b_3,$b_3,$disc_6                # 88e
        frsqest $y_3,$disc_6                            # 88o
        fi      $y_2,$disc_2,$y_2                       # 89e
        frsqest $y_4,$disc_7                            # 89o
        nop     $127                                    # 90e pairing
        lqd     $oz_8,144($a_packet)                    # 90o
        fms     $out_4,$b_2,$b_2,$disc_7                # 91e
        lqd     $dy_6,272($a_packet)                    # 91o
        fi      $y_3,$disc_6,$y_3                       # 92e
        frsqest $y_5,$disc_8                            # 92o
        fi      $y_4,$disc_7,$y_4                       # 93e
        lqd     $dy_7,288($a_packet)                    # 93o
        nop     $127                                    # 94e pairing
        lqd     $dy_8,304($a_packet)                    # 94o
        fms     $out_5,$b_5,$b_5,$disc_8                # 95e
        shufb   $radius2_3,$sides,$sides,$m_x           # 95o
        fm      $s_2,$disc_2,$y_2                       # 96e
        rotqbyi $sides,$sides,12                        # 96o
        fi      $y_5,$disc_8,$y_5                       # 97e
        lqd     $dz_6,320($a_packet)                    # 97o
        nop     $127                                    # 98e pairing
        lqd     $dz_7,336($a_packet)                    # 98o
        fm      $s_3,$disc_6,$y_3                       # 99e
        lqd     $dz_8,352($a_packet)                    # 99o
        fm      $s_4,$disc_7,$y_4                       # 100e
        lqd     $dz_9,368($a_packet)                    # 100o
        fs      $fx_8,$cx_3,$ox_7                       # 101e
        fnms    $e_2,$s_2,$y_2,$k_one                   # 102e
        selb    $s_5,$s_2,$out_2,$m_by_side_2           # 103e
        fm      $s_6,$disc_8,$y_5                       # 104e
        fnms    $e_3,$s_3,$y_3,$k_one                   # 105e
        selb    $s_7,$s_3,$out_3,$m_by_side_2           # 106e
        fnms    $e_4,$s_4,$y_4,$k_one                   # 107e
        fma     $e_2,$e_2,$half_2,$whole_2              # 108e
        selb    $s_8,$s_4,$out_4,$m_by_side_2           # 109e
        fnms    $e_5,$s_6,$y_5,$k_one                   # 110e
        fma     $e_3,$e_3,$half_2,$whole_2              # 111e
        selb    $s_9,$s_6,$out_5,$m_by_side_2           # 112e
        fma     $e_6,$e_4,$half_2,$whole_2              # 113e
        fnms    $t_2,$s_5,$e_2,$b                       # 114e
        fs      $fy_6,$cy_3,$oy_6                       # 115e
        fma     $e_7,$e_5,$half_2,$whole_2              # 116e
        fnms    $t_3,$s_7,$e_3,$b_3                     # 117e
        fs      $fy_5,$cy_3,$oy_5                       # 118e
        fnms    $t_4,$s_8,$e_6,$b_2                     # 119e
        cgt     $control,$t_best_2,$t_2                 # 120e
        cgti    $ahead,$t_2,0                           # 121e
        fnms    $t_5,$s_9,$e_7,$b_5                     # 122e
        and     $control,$control,$ahead                # 123e
        cgti    $ahead,$t_3,0                           # 124e
        cgt     $control_2,$t_best_3,$t_3               # 125e
        cgti    $ahead_2,$t_4,0                         # 126e
        cgt     $control_3,$t_best_4,$t_4               # 127e
        andc    $control,$control,$disc_2               # 128e
        and     $control_2,$control_2,$ahead            # 129e
        lnop                                            # 129o pairing
        and     $control_4,$control_3,$ahead_2          # 130e
        rotqbii $control,$control,1                     # 130o
        fs      $fy_7,$cy_3,$oy                         # 131e
        fm      $b,$fx_6,$dx_6                          # 132e
        fm      $b_2,$fx_8,$dx_5                        # 133e
        lnop                                            # 133o pairing
        fm      $b_3,$fx_7,$dx_7                        # 134e
        gb      $control,$control                       # 134o
        fm      $b_6,$fx_5,$dx_2                        # 135e
        fs      $fz_7,$cz_3,$oz_6                       # 136e
        fs      $fy_8,$cy_3,$oy_7                       # 137e
        lnop                                            # 137o pairing
        fma     $b,$fy_7,$dy_2,$b                       # 138e
        shlqbii $control,$control,4                     # 138o
        fs      $fz_3,$cz_3,$oz_3                       # 139e
        fs      $fz_8,$cz_3,$oz_7                       # 140e
        fs      $fz_9,$cz_3,$oz_8                       # 141e
        lnop                                            # 141o pairing
        fma     $b_2,$fy_5,$dy_6,$b_2                   # 142e
        lqx     $control,$control,$a_controls           # 142o
        fma     $b_6,$fy_6,$dy_7,$b_6                   # 143e
        fma     $b_3,$fy_8,$dy_8,$b_3                   # 144e
        andc    $control_4,$control_4,$disc_7           # 145e
        fm      $radius2_2,$radius2_3,$radius2_3        # 146e
        fma     $b,$fz_8,$dz_6,$b                       # 147e
        rotqbii $control_4,$control_4,1                 # 147o
        rotmi   $sides,$sides,-26                       # 148e
        shufb   $t_best_5,$t_best_2,$t_2,$control       # 148o
        fma     $b_2,$fz_9,$dz_7,$b_2                   # 149e
        shufb   $nearest_5,$nearest_4,$object,$control  # 149o
        fma     $b_5,$fz_3,$dz_8,$b_6                   # 150e
        lnop                                            # 150o pairing
        fma     $b_3,$fz_7,$dz_9,$b_3                   # 151e
        gb      $control_4,$control_4                   # 151o
        andc    $control_2,$control_2,$disc_6           # 152e
        cgti    $ahead_3,$t_5,0                         # 153e
        fnms    $fx_6,$b,$dx_6,$fx_6                    # 154e
        rotqbii $control_2,$control_2,1                 # 154o
        fnms    $fz_8,$b,$dz_6,$fz_8                    # 155e
        shlqbii $control_4,$control_4,4                 # 155o
        fnms    $fx_9,$b_2,$dx_5,$fx_8                  # 156e
        fnms    $fx_5,$b_5,$dx_2,$fx_5                  # 157e
        fnms    $fx_7,$b_3,$dx_7,$fx_7                  # 158e
        gb      $control_2,$control_2                   # 158o
        fnms    $fy_7,$b,$dy_2,$fy_7                    # 159e
        lqx     $control_4,$control_4,$a_controls       # 159o
        fnms    $disc_9,$fx_6,$fx_6,$radius2_2          # 160e
        fnms    $fy_9,$b_3,$dy_8,$fy_8                  # 161e
        fnms    $disc_10,$fx_9,$fx_9,$radius2_2         # 162e
        shlqbii $control_2,$control_2,4                 # 162o
        fnms    $disc_11,$fx_5,$fx_5,$radius2_2         # 163e
        fnms    $disc_12,$fx_7,$fx_7,$radius2_2         # 164e
        fnms    $fy_5,$b_2,$dy_6,$fy_5                  # 165e
        shufb   $nearest_6,$nearest_2,$object,$control_4 # 165o
        fnms    $fy,$b_5,$dy_7,$fy_6                    # 166e
        lqx     $control_2,$control_2,$a_controls       # 166o
        fnms    $disc_2,$fy_7,$fy_7,$disc_9             # 167e
        stqd    $t_best_5,384($a_packet_2)              # 167o
        fnms    $fz,$b_3,$dz_9,$fz_7                    # 168e
        shufb   $t_best_6,$t_best_4,$t_4,$control_4     # 168o
        fnms    $fz_5,$b_2,$dz_7,$fz_9                  # 169e
        stqd    $nearest_5,448($a_packet_2)             # 169o
        fnms    $disc_5,$fy_9,$fy_9,$disc_12            # 170e
        fnms    $disc_3,$fy_5,$fy_5,$disc_10            # 171e
        fnms    $fz_9,$b_5,$dz_8,$fz_3                  # 172e
        shufb   $nearest_7,$nearest_3,$object,$control_2 # 172o
        fnms    $disc_13,$fz_8,$fz_8,$disc_2            # 173e
        shufb   $t_best_7,$t_best_3,$t_3,$control_2     # 173o
        fnms    $disc_4,$fy,$fy,$disc_11                # 174e
        cgt     $control,$t_best,$t_5                   # 175e
        fnms    $disc_6,$fz,$fz,$disc_5                 # 176e
        stqd    $nearest_7,496($a_packet_2)             # 176o
        and     $control,$control,$ahead_3              # 177e
        stqd    $t_best_6,400($a_packet_2)              # 177o
        fnms    $disc_7,$fz_5,$fz_5,$disc_3             # 178e
        stqd    $t_best_7,432($a_packet_2)              # 178o
        andc    $control,$control,$disc_8               # 179e
        frsqest $y_6,$disc_13                           # 179o
        fnms    $disc_8,$fz_9,$fz_9,$disc_4             # 180e
        stqd    $nearest_6,464($a_packet_2)             # 180o
        fms     $out,$b,$b,$disc_13                     # 181e
        rotqbii $control,$control,1                     # 181o
        fms     $out_6,$b_3,$b_3,$disc_6                # 182e
        frsqest $y_7,$disc_6                            # 182o
        fi      $y_6,$disc_13,$y_6                      # 183e
        lqx     $half,$a_half,$sides                    # 183o
        nop     $127                                    # 184e pairing
        frsqest $y_8,$disc_7                            # 184o
        fms     $out_7,$b_2,$b_2,$disc_7                # 185e
        gb      $control,$control                       # 185o
        fi      $y_7,$disc_6,$y_7                       # 186e
        frsqest $y_9,$disc_8                            # 186o
        nop     $127                                    # 187e pairing
        lqx     $m_by_side,$a_by_side,$sides            # 187o
        fi      $y_8,$disc_7,$y_8                       # 188e
        lqx     $whole,$a_whole,$sides                  # 188o
        nop     $127                                    # 189e pairing
        shlqbii $control,$control,4                     # 189o
        fm      $s,$disc_13,$y_6                        # 190e
        lqd     $nearest_2,464($a_packet)               # 190o
        fi      $y_9,$disc_8,$y_9                       # 191e
        lqd     $nearest_3,496($a_packet)               # 191o
        nop     $127                                    # 192e pairing
        lqd     $t_best_2,384($a_packet)                # 192o
        fm      $s_10,$disc_6,$y_7                      # 193e
        lqx     $control,$control,$a_controls           # 193o
        fms     $out_8,$b_5,$b_5,$disc_8                # 194e
        lqd     $t_best_3,432($a_packet)                # 194o
        fm      $s_11,$disc_7,$y_8                      # 195e
        lqd     $t_best_4,400($a_packet)                # 195o
        fnms    $e,$s,$y_6,$k_one                       # 196e
        lqd     $nearest_4,448($a_packet)               # 196o
        selb    $s_12,$s,$out,$m_by_side                # 197e
        fm      $s_13,$disc_8,$y_9                      # 198e
        fnms    $e_8,$s_10,$y_7,$k_one                  # 199e
        shufb   $nearest,$nearest,$object,$control      # 199o
        selb    $s_10,$s_10,$out_6,$m_by_side           # 200e
        fnms    $e_9,$s_11,$y_8,$k_one                  # 201e
next_ball:
            fma     $e,$e,$half,$whole                  # 0e
            shufb   $t_best,$t_best,$t_5,$control       # 0o
            selb    $s,$s_11,$out_7,$m_by_side          # 1e
            shufb   $object,$object_3,$object_3,$m_x    # 1o
            fnms    $e_7,$s_13,$y_9,$k_one              # 2e
            stqd    $nearest,480($a_packet_2)           # 2o
            fma     $e_10,$e_8,$half,$whole             # 3e
        lqd     $object_3,0($a_candidate)               # 3o
            selb    $s_14,$s_13,$out_8,$m_by_side       # 4e
            stqd    $t_best,416($a_packet_2)            # 4o
            fma     $e_11,$e_9,$half,$whole             # 5e
            lqd     $t_best,416($a_packet)              # 5o
            fnms    $t,$s_12,$e,$b                      # 6e
            shlqbyi $a_packet_2,$a_packet,0             # 6o copy
        ai      $a_candidate,$a_candidate,16            # 7e
        lnop                                            # 7o pairing
        ai      $count,$count,-1                        # 8e
            lqd     $nearest,480($a_packet)             # 8o
            fnms    $t_6,$s_10,$e_10,$b_3               # 9e
            lnop                                        # 9o pairing
            fma     $e,$e_7,$half,$whole                # 10e
        rotqbyi $a_packet,$object_3,4                   # 10o
            fnms    $t_7,$s,$e_11,$b_2                  # 11e
        lqd     $quad,0($object_3)                      # 11o
            cgt     $control,$t_best_2,$t               # 12e
            cgti    $ahead,$t,0                         # 13e
        nop     $127                                    # 14e pairing
        lqd     $sides,32($object_3)                    # 14o
            and     $control,$control,$ahead            # 15e
        lqd     $ox,32($a_packet)                       # 15o
            cgti    $ahead,$t_6,0                       # 16e
        lqd     $ox_2,48($a_packet)                     # 16o
            cgt     $control_5,$t_best_3,$t_6           # 17e
        shufb   $cx_2,$quad,$quad,$m_x                  # 17o
            cgti    $ahead_4,$t_7,0                     # 18e
        lqd     $ox_3,0($a_packet)                      # 18o
            cgt     $control_6,$t_best_4,$t_7           # 19e
        lqd     $ox_4,16($a_packet)                     # 19o
            fnms    $t_5,$s_14,$e,$b_5                  # 20e
        lqd     $oy,80($a_packet)                       # 20o
            andc    $control,$control,$disc_13          # 21e
        lqd     $oy_2,96($a_packet)                     # 21o
            and     $control_5,$control_5,$ahead        # 22e
        shufb   $cy_2,$quad,$quad,$m_y                  # 22o
        fs      $fx,$cx_2,$ox                           # 23e
        lqd     $dx,208($a_packet)                      # 23o
        fs      $fx_2,$cx_2,$ox_3                       # 24e
        lqd     $oy_3,64($a_packet)                     # 24o
        fs      $fx_3,$cx_2,$ox_2                       # 25e
        lqd     $dx_2,192($a_packet)                    # 25o
        fs      $fx_4,$cx_2,$ox_4                       # 26e
        lqd     $dx_3,224($a_packet)                    # 26o
        fs      $fy,$cy_2,$oy_2                         # 27e
        lqd     $dx_4,240($a_packet)                    # 27o
            and     $control_7,$control_6,$ahead_4      # 28e
        lqd     $oy_4,112($a_packet)                    # 28o
        fs      $fy_2,$cy_2,$oy                         # 29e
        lqd     $oz_2,176($a_packet)                    # 29o
        fs      $fy_3,$cy_2,$oy_3                       # 30e
        lqd     $dy_2,256($a_packet)                    # 30o
        fm      $b,$fx_2,$dx_2                          # 31e
        shufb   $cz_2,$quad,$quad,$m_z                  # 31o
        fm      $b_2,$fx_4,$dx                          # 32e
        lqd     $oz_3,160($a_packet)                    # 32o
        fm      $b_3,$fx_3,$dx_4                        # 33e
        lqd     $oz_4,128($a_packet)                    # 33o
        fm      $b_4,$fx,$dx_3                          # 34e
        lqd     $oz_5,144($a_packet)                    # 34o
        fs      $fz_2,$cz_2,$oz_2                       # 35e
        lqd     $dy_3,272($a_packet)                    # 35o
        fs      $fy_4,$cy_2,$oy_4                       # 36e
        lqd     $dy_4,288($a_packet)                    # 36o
        fma     $b,$fy_3,$dy_2,$b                       # 37e
        lqd     $dy_5,304($a_packet)                    # 37o
        fs      $fz_3,$cz_2,$oz_3                       # 38e
        shufb   $radius2_2,$sides,$sides,$m_x           # 38o
        fs      $fz_4,$cz_2,$oz_4                       # 39e
        rotqbyi $sides,$sides,12                        # 39o
        fs      $fz_5,$cz_2,$oz_5                       # 40e
        lqd     $dz_2,320($a_packet)                    # 40o
        fma     $b_2,$fy_2,$dy_3,$b_2                   # 41e
        lnop                                            # 41o pairing
        fma     $b_4,$fy,$dy_4,$b_4                     # 42e
        lqd     $dz_3,336($a_packet)                    # 42o
        fma     $b_3,$fy_4,$dy_5,$b_3                   # 43e
        lqd     $dz_4,352($a_packet)                    # 43o
            andc    $control_7,$control_7,$disc_7       # 44e
        lqd     $dz_5,368($a_packet)                    # 44o
        fm      $radius2_2,$radius2_2,$radius2_2        # 45e
        lnop                                            # 45o pairing
        fma     $b,$fz_4,$dz_2,$b                       # 46e
            rotqbii $control_7,$control_7,1             # 46o
        rotmi   $sides,$sides,-26                       # 47e
            rotqbii $control,$control,1                 # 47o
        fma     $b_2,$fz_5,$dz_3,$b_2                   # 48e
        fma     $b_5,$fz_3,$dz_4,$b_4                   # 49e
        fma     $b_3,$fz_2,$dz_5,$b_3                   # 50e
            andc    $control_5,$control_5,$disc_6       # 51e
            cgti    $ahead_5,$t_5,0                     # 52e
        fnms    $fx_2,$b,$dx_2,$fx_2                    # 53e
        fnms    $fz_6,$b,$dz_2,$fz_4                    # 54e
            rotqbii $control_5,$control_5,1             # 54o
        fnms    $fx_4,$b_2,$dx,$fx_4                    # 55e
            gb      $control,$control                   # 55o
        fnms    $fx,$b_5,$dx_3,$fx                      # 56e
            gb      $control_7,$control_7               # 56o
        fnms    $fx_3,$b_3,$dx_4,$fx_3                  # 57e
        lnop                                            # 57o pairing
        fnms    $fy_5,$b,$dy_2,$fy_3                    # 58e
            gb      $control_5,$control_5               # 58o
        fnms    $disc_2,$fx_2,$fx_2,$radius2_2          # 59e
            shlqbii $control,$control,4                 # 59o
        fnms    $fy_4,$b_3,$dy_5,$fy_4                  # 60e
            shlqbii $control_7,$control_7,4             # 60o
        fnms    $disc_3,$fx_4,$fx_4,$radius2_2          # 61e
        lnop                                            # 61o pairing
        fnms    $disc_4,$fx,$fx,$radius2_2              # 62e
            shlqbii $control_5,$control_5,4             # 62o
        fnms    $disc_5,$fx_3,$fx_3,$radius2_2          # 63e
            lqx     $control,$control,$a_controls       # 63o
        fnms    $fy_3,$b_2,$dy_3,$fy_2                  # 64e
        lnop                                            # 64o pairing
        fnms    $fy,$b_5,$dy_4,$fy                      # 65e
            lqx     $control_7,$control_7,$a_controls   # 65o
        fnms    $disc_2,$fy_5,$fy_5,$disc_2             # 66e
            lqx     $control_5,$control_5,$a_controls   # 66o
        fnms    $fz,$b_3,$dz_5,$fz_2                    # 67e
        lnop                                            # 67o pairing
        fnms    $fz_5,$b_2,$dz_3,$fz_5                  # 68e
        hbrr    next_ball_back,next_ball                # 68o hint
        fnms    $disc_5,$fy_4,$fy_4,$disc_5             # 69e
            shufb   $t_best_8,$t_best_2,$t,$control     # 69o
        fnms    $disc_3,$fy_3,$fy_3,$disc_3             # 70e
            shufb   $nearest_8,$nearest_4,$object,$control # 70o
        fnms    $fz_10,$b_5,$dz_4,$fz_3                 # 71e
            shufb   $nearest_9,$nearest_2,$object,$control_7 # 71o
        fnms    $disc_13,$fz_6,$fz_6,$disc_2            # 72e
            shufb   $nearest_10,$nearest_3,$object,$control_5 # 72o
        fnms    $disc_4,$fy,$fy,$disc_4                 # 73e
            stqd    $t_best_8,384($a_packet_2)          # 73o
            cgt     $control,$t_best,$t_5               # 74e
            shufb   $t_best_7,$t_best_4,$t_7,$control_7 # 74o
        fnms    $disc_6,$fz,$fz,$disc_5                 # 75e
            stqd    $nearest_8,448($a_packet_2)         # 75o
            and     $control,$control,$ahead_5          # 76e
            shufb   $t_best_6,$t_best_3,$t_6,$control_5 # 76o
        fnms    $disc_7,$fz_5,$fz_5,$disc_3             # 77e
            stqd    $nearest_10,496($a_packet_2)        # 77o
            andc    $control,$control,$disc_8           # 78e
        frsqest $y_6,$disc_13                           # 78o
        fnms    $disc_8,$fz_10,$fz_10,$disc_4           # 79e
            stqd    $t_best_7,400($a_packet_2)          # 79o
        fms     $out,$b,$b,$disc_13                     # 80e
            rotqbii $control,$control,1                 # 80o
        fms     $out_6,$b_3,$b_3,$disc_6                # 81e
        frsqest $y_7,$disc_6                            # 81o
        fi      $y_6,$disc_13,$y_6                      # 82e
            stqd    $t_best_6,432($a_packet_2)          # 82o
        nop     $127                                    # 83e pairing
        frsqest $y_8,$disc_7                            # 83o
        fms     $out_7,$b_2,$b_2,$disc_7                # 84e
            stqd    $nearest_9,464($a_packet_2)         # 84o
        fi      $y_7,$disc_6,$y_7                       # 85e
            gb      $control,$control                   # 85o
        frsqest $y_9,$disc_8                            # 86o
        fi      $y_8,$disc_7,$y_8                       # 87e
        nop     $127                                    # 88e pairing
        lqx     $half,$a_half,$sides                    # 88o
        fm      $s,$disc_13,$y_6                        # 89e
            shlqbii $control,$control,4                 # 89o
        fi      $y_9,$disc_8,$y_9                       # 90e
        lqx     $m_by_side,$a_by_side,$sides            # 90o
        nop     $127                                    # 91e pairing
        lqx     $whole,$a_whole,$sides                  # 91o
        fm      $s_10,$disc_6,$y_7                      # 92e
        lqd     $nearest_2,464($a_packet)               # 92o
        fms     $out_8,$b_5,$b_5,$disc_8                # 93e
            lqx     $control,$control,$a_controls       # 93o
        fm      $s_11,$disc_7,$y_8                      # 94e
        lqd     $nearest_3,496($a_packet)               # 94o
        fnms    $e,$s,$y_6,$k_one                       # 95e
        lqd     $t_best_2,384($a_packet)                # 95o
        selb    $s_12,$s,$out,$m_by_side                # 96e
        lqd     $t_best_3,432($a_packet)                # 96o
        fm      $s_13,$disc_8,$y_9                      # 97e
        lqd     $t_best_4,400($a_packet)                # 97o
        fnms    $e_8,$s_10,$y_7,$k_one                  # 98e
        lqd     $nearest_4,448($a_packet)               # 98o
        selb    $s_10,$s_10,$out_6,$m_by_side           # 99e
            shufb   $nearest,$nearest,$object,$control  # 99o
        fnms    $e_9,$s_11,$y_8,$k_one                  # 100e
next_ball_back:
        brnz    $count,next_ball                        # 100o
next_ball_drain:
        fma     $e,$e,$half,$whole                      # 0e
        shufb   $t_best,$t_best,$t_5,$control           # 0o
        fma     $e_10,$e_8,$half,$whole                 # 1e
        stqd    $nearest,480($a_packet_2)               # 1o
        fma     $e_7,$e_9,$half,$whole                  # 2e
        shufb   $object,$object_3,$object_3,$m_x        # 2o
        selb    $s,$s_11,$out_7,$m_by_side              # 3e
        shlqbyi $a_packet_3,$a_packet,0                 # 3o copy
        fnms    $e_12,$s_13,$y_9,$k_one                 # 4e
        stqd    $t_best,416($a_packet_2)                # 4o
        selb    $s_14,$s_13,$out_8,$m_by_side           # 5e
        lqd     $t_best,416($a_packet)                  # 5o
        fnms    $t,$s_12,$e,$b                          # 6e
        lqd     $nearest,480($a_packet)                 # 6o
        fnms    $t_6,$s_10,$e_10,$b_3                   # 7e
        hbr     isect_sphere_pairs_r16_return,$lr       # 7o hint
        fnms    $t_7,$s,$e_7,$b_2                       # 8e
        fma     $e,$e_12,$half,$whole                   # 10e
        cgti    $ahead,$t,0                             # 12e
        cgti    $ahead_6,$t_6,0                         # 13e
        cgti    $ahead_4,$t_7,0                         # 14e
        cgt     $control,$t_best_2,$t                   # 15e
        cgt     $control_6,$t_best_4,$t_7               # 16e
        and     $control,$control,$ahead                # 17e
        cgt     $control_5,$t_best_3,$t_6               # 18e
        andc    $control,$control,$disc_13              # 19e
        and     $control_7,$control_6,$ahead_4          # 20e
        lnop                                            # 20o pairing
        and     $control_5,$control_5,$ahead_6          # 21e
        rotqbii $control,$control,1                     # 21o
        andc    $control_7,$control_7,$disc_7           # 22e
        andc    $control_5,$control_5,$disc_6           # 23e
        fnms    $t_5,$s_14,$e,$b_5                      # 24e
        rotqbii $control_7,$control_7,1                 # 24o
        gb      $control,$control                       # 25o
        rotqbii $control_5,$control_5,1                 # 26o
        gb      $control_7,$control_7                   # 28o
        shlqbii $control,$control,4                     # 29o
        cgti    $ahead_5,$t_5,0                         # 30e
        gb      $control_5,$control_5                   # 30o
        cgt     $control_8,$t_best,$t_5                 # 31e
        shlqbii $control_7,$control_7,4                 # 32o
        and     $control_8,$control_8,$ahead_5          # 33e
        lqx     $control,$control,$a_controls           # 33o
        shlqbii $control_5,$control_5,4                 # 34o
        andc    $control_8,$control_8,$disc_8           # 35e
        lqx     $control_7,$control_7,$a_controls       # 36o
        rotqbii $control_8,$control_8,1                 # 37o
        lqx     $control_5,$control_5,$a_controls       # 38o
        shufb   $t_best_8,$t_best_2,$t,$control         # 39o
        shufb   $nearest_8,$nearest_4,$object,$control  # 40o
        gb      $control,$control_8                     # 41o
        shufb   $nearest_9,$nearest_2,$object,$control_7 # 42o
        shufb   $t_best_7,$t_best_4,$t_7,$control_7     # 43o
        shufb   $nearest_10,$nearest_3,$object,$control_5 # 44o
        shufb   $t_best_6,$t_best_3,$t_6,$control_5     # 45o
        shlqbii $control,$control,4                     # 46o
        stqd    $t_best_8,384($a_packet_3)              # 47o
        stqd    $nearest_8,448($a_packet_3)             # 48o
        stqd    $nearest_10,496($a_packet_3)            # 49o
        stqd    $t_best_7,400($a_packet_3)              # 50o
        stqd    $t_best_6,432($a_packet_3)              # 51o
        stqd    $nearest_9,464($a_packet_3)             # 52o
        lqx     $control,$control,$a_controls           # 53o
        shufb   $nearest,$nearest,$object,$control      # 59o
        shufb   $t_best,$t_best,$t_5,$control           # 60o
        stqd    $nearest,480($a_packet_3)               # 63o
        stqd    $t_best,416($a_packet_3)                # 64o
        nop     $127                                    # 65e pairing
isect_sphere_pairs_r16_return:
        bi      $lr                                     # 65o
next_ball_short:
        ai      $count,$count,-1                        # 0e
        lqd     $object,0($a_candidate)                 # 0o
        ai      $a_candidate,$a_candidate,16            # 1e
        rotqbyi $a_packet,$object,4                     # 6o
        lqd     $quad,0($object)                        # 7o
        lqd     $sides,32($object)                      # 8o
        shufb   $object,$object,$object,$m_x            # 9o
        lqd     $ox,16($a_packet)                       # 10o
        lqd     $dx,208($a_packet)                      # 11o
        lqd     $oz,128($a_packet)                      # 12o
        shufb   $cx,$quad,$quad,$m_x                    # 13o
        lqd     $dy,272($a_packet)                      # 14o
        lqd     $ox_8,0($a_packet)                      # 15o
        shufb   $cy,$quad,$quad,$m_y                    # 16o
        fs      $fx,$cx,$ox                             # 17e
        lqd     $oy,64($a_packet)                       # 17o
        lqd     $dx_8,192($a_packet)                    # 18o
        lqd     $oy_8,80($a_packet)                     # 19o
        nop     $127                                    # 20e pairing
        lqd     $dz,320($a_packet)                      # 20o
        fs      $fx_10,$cx,$ox_8                        # 21e
        lqd     $ox,48($a_packet)                       # 21o
        nop     $127                                    # 22e pairing
        lqd     $dx_9,240($a_packet)                    # 22o
        fs      $fy,$cy,$oy                             # 23e
        lqd     $oz_6,144($a_packet)                    # 23o
        fm      $b,$fx,$dx                              # 24e
        lqd     $dy_9,256($a_packet)                    # 24o
        fs      $fy_10,$cy,$oy_8                        # 25e
        lqd     $ox_5,32($a_packet)                     # 25o
        nop     $127                                    # 26e pairing
        shufb   $cz_2,$quad,$quad,$m_z                  # 26o
        fm      $b_7,$fx_10,$dx_8                       # 27e
        lqd     $oy,96($a_packet)                       # 27o
        fs      $fx_9,$cx,$ox                           # 28e
        lqd     $dz_10,336($a_packet)                   # 28o
        nop     $127                                    # 29e pairing
        shufb   $radius2_4,$sides,$sides,$m_x           # 29o
        fs      $fz,$cz_2,$oz                           # 30e
        lqd     $dx_10,224($a_packet)                   # 30o
        fs      $fx_11,$cx,$ox_5                        # 31e
        lqd     $oz,176($a_packet)                      # 31o
        fma     $b,$fy_10,$dy,$b                        # 32e
        lqd     $oz_9,160($a_packet)                    # 32o
        fma     $b_7,$fy,$dy_9,$b_7                     # 33e
        lqd     $oy_9,112($a_packet)                    # 33o
        fs      $fy_2,$cy,$oy                           # 34e
        lqd     $dz_11,352($a_packet)                   # 34o
        fm      $b_2,$fx_9,$dx_9                        # 35e
        lqd     $dy_10,288($a_packet)                   # 35o
        fs      $fz_7,$cz_2,$oz_6                       # 36e
        lqd     $dy_11,304($a_packet)                   # 36o
        fm      $b_8,$fx_11,$dx_10                      # 37e
        lqd     $dz_12,368($a_packet)                   # 37o
        fs      $fz_11,$cz_2,$oz_9                      # 38e
        rotqbyi $sides,$sides,12                        # 38o
        fs      $fy_11,$cy,$oy_9                        # 39e
        lqd     $t_best,400($a_packet)                  # 39o
        fma     $b_7,$fz,$dz,$b_7                       # 40e
        lqd     $t_best_9,384($a_packet)                # 40o
        fm      $radius2_4,$radius2_4,$radius2_4        # 41e
        lqd     $t_best_10,416($a_packet)               # 41o
        fma     $b,$fz_7,$dz_10,$b                      # 42e
        lqd     $t_best_11,432($a_packet)               # 42o
        fma     $b_8,$fy_2,$dy_10,$b_8                  # 43e
        lqd     $nearest_11,448($a_packet)              # 43o
        fs      $fz_5,$cz_2,$oz                         # 44e
        lqd     $nearest_12,464($a_packet)              # 44o
        fma     $b_2,$fy_11,$dy_11,$b_2                 # 45e
        lqd     $nearest_13,480($a_packet)              # 45o
        fnms    $fy,$b_7,$dy_9,$fy                      # 46e
        lqd     $nearest_14,496($a_packet)              # 46o
        fnms    $fx_10,$b_7,$dx_8,$fx_10                # 47e
        fnms    $fx,$b,$dx,$fx                          # 48e
        fma     $b_9,$fz_11,$dz_11,$b_8                 # 49e
        fnms    $fz,$b_7,$dz,$fz                        # 50e
        fma     $b_10,$fz_5,$dz_12,$b_2                 # 51e
        fnms    $fy_10,$b,$dy,$fy_10                    # 52e
        fnms    $disc,$fx_10,$fx_10,$radius2_4          # 53e
        fnms    $disc_14,$fx,$fx,$radius2_4             # 54e
        fnms    $fy_2,$b_9,$dy_10,$fy_2                 # 55e
        fnms    $fz_7,$b,$dz_10,$fz_7                   # 56e
        fnms    $fx,$b_10,$dx_9,$fx_9                   # 57e
        fnms    $fy_12,$b_10,$dy_11,$fy_11              # 58e
        fnms    $disc,$fy,$fy,$disc                     # 59e
        fnms    $disc_14,$fy_10,$fy_10,$disc_14         # 60e
        fnms    $fz_12,$b_10,$dz_12,$fz_5               # 61e
        fnms    $fx_6,$b_9,$dx_10,$fx_11                # 62e
        fnms    $disc_15,$fx,$fx,$radius2_4             # 63e
        fnms    $fz_13,$b_9,$dz_11,$fz_11               # 64e
        fnms    $disc,$fz,$fz,$disc                     # 65e
        fnms    $disc_14,$fz_7,$fz_7,$disc_14           # 66e
        rotmi   $sides,$sides,-26                       # 67e
        fnms    $disc_5,$fx_6,$fx_6,$radius2_4          # 68e
        fnms    $disc_16,$fy_12,$fy_12,$disc_15         # 69e
        lnop                                            # 69o pairing
        fms     $out,$b_7,$b_7,$disc                    # 71e
        frsqest $y,$disc                                # 71o
        fms     $out_9,$b,$b,$disc_14                   # 72e
        frsqest $y_10,$disc_14                          # 72o
        nop     $127                                    # 73e pairing
        lqx     $half,$a_half,$sides                    # 73o
        fnms    $disc_5,$fy_2,$fy_2,$disc_5             # 74e
        lqx     $m_by_side,$a_by_side,$sides            # 74o
        fnms    $disc_17,$fz_12,$fz_12,$disc_16         # 75e
        lqx     $whole,$a_whole,$sides                  # 75o
        fi      $y,$disc,$y                             # 76e
        fi      $y_11,$disc_14,$y_10                    # 77e
        fnms    $disc_5,$fz_13,$fz_13,$disc_5           # 80e
        lnop                                            # 80o pairing
        fms     $out_7,$b_10,$b_10,$disc_17             # 81e
        frsqest $y_9,$disc_17                           # 81o
        fm      $s,$disc,$y                             # 83e
        fm      $s_10,$disc_14,$y_11                    # 84e
        fi      $y_9,$disc_17,$y_9                      # 85e
        frsqest $y_12,$disc_5                           # 86o
        fms     $out_10,$b_9,$b_9,$disc_5               # 87e
        fnms    $e,$s,$y,$k_one                         # 89e
        fi      $y,$disc_5,$y_12                        # 90e
        selb    $s_15,$s_10,$out_9,$m_by_side           # 91e
        fm      $s_11,$disc_17,$y_9                     # 92e
        fnms    $e_13,$s_10,$y_11,$k_one                # 93e
        selb    $s,$s,$out,$m_by_side                   # 94e
        fma     $e,$e,$half,$whole                      # 95e
        fm      $s_10,$disc_5,$y                        # 97e
        fnms    $e_14,$s_11,$y_9,$k_one                 # 98e
        fma     $e_13,$e_13,$half,$whole                # 99e
        selb    $s_16,$s_11,$out_7,$m_by_side           # 100e
        fnms    $t_8,$s,$e,$b_7                         # 101e
        fnms    $e,$s_10,$y,$k_one                      # 103e
        fma     $e_14,$e_14,$half,$whole                # 104e
        fnms    $t_5,$s_15,$e_13,$b                     # 105e
        selb    $s,$s_10,$out_10,$m_by_side             # 106e
        cgti    $ahead_7,$t_8,0                         # 107e
        cgt     $control_7,$t_best_9,$t_8               # 108e
        fma     $e,$e,$half,$whole                      # 109e
        and     $control_9,$control_7,$ahead_7          # 110e
        cgti    $ahead_4,$t_5,0                         # 111e
        andc    $control_9,$control_9,$disc             # 112e
        fnms    $t_9,$s_16,$e_14,$b_10                  # 113e
        cgt     $control_10,$t_best,$t_5                # 114e
        rotqbii $control_9,$control_9,1                 # 114o
        fnms    $t_6,$s,$e,$b_9                         # 115e
        and     $control_10,$control_10,$ahead_4        # 116e
        andc    $control_2,$control_10,$disc_14         # 118e
        gb      $control_9,$control_9                   # 118o
        cgti    $ahead_8,$t_9,0                         # 119e
        lnop                                            # 119o pairing
        cgt     $control_7,$t_best_11,$t_9              # 120e
        rotqbii $control_2,$control_2,1                 # 120o
        cgt     $control_11,$t_best_10,$t_6             # 121e
        lnop                                            # 121o pairing
        and     $control_10,$control_7,$ahead_8         # 122e
        shlqbii $control_9,$control_9,4                 # 122o
        cgti    $ahead_4,$t_6,0                         # 123e
        lnop                                            # 123o pairing
        andc    $control_12,$control_10,$disc_17        # 124e
        gb      $control_2,$control_2                   # 124o
        and     $control_10,$control_11,$ahead_4        # 125e
        rotqbii $control_12,$control_12,1               # 126o
        andc    $control_13,$control_10,$disc_5         # 127e
        lqx     $control_9,$control_9,$a_controls       # 127o
        shlqbii $control_2,$control_2,4                 # 128o
        rotqbii $control_13,$control_13,1               # 129o
        gb      $control_12,$control_12                 # 130o
        lqx     $control_2,$control_2,$a_controls       # 132o
        shufb   $nearest,$nearest_11,$object,$control_9 # 133o
        gb      $control_13,$control_13                 # 134o
        shufb   $t_best_12,$t_best_9,$t_8,$control_9    # 135o
        shlqbii $control_12,$control_12,4               # 136o
        stqd    $nearest,448($a_packet)                 # 137o
        shlqbii $control_13,$control_13,4               # 138o
        stqd    $t_best_12,384($a_packet)               # 139o
        shufb   $t_best,$t_best,$t_5,$control_2         # 140o
        shufb   $nearest,$nearest_12,$object,$control_2 # 141o
        lqx     $control_2,$control_13,$a_controls      # 142o
        lqx     $control_12,$control_12,$a_controls     # 143o
        stqd    $t_best,400($a_packet)                  # 144o
        stqd    $nearest,464($a_packet)                 # 145o
        hbrr    next_ball_short_back,next_ball_short    # 146o hint
        shufb   $nearest,$nearest_13,$object,$control_2 # 148o
        shufb   $t_best,$t_best_11,$t_9,$control_12     # 149o
        shufb   $nearest_15,$nearest_14,$object,$control_12 # 150o
        shufb   $t_best_7,$t_best_10,$t_6,$control_2    # 151o
        stqd    $nearest,480($a_packet)                 # 152o
        stqd    $t_best,432($a_packet)                  # 153o
        stqd    $nearest_15,496($a_packet)              # 154o
        stqd    $t_best_7,416($a_packet)                # 155o
        nop     $127                                    # 156e pairing
next_ball_short_back:
        brnz    $count,next_ball_short                  # 162o
        nop     $127                                    # 157e pairing
        bi      $lr                                     # 157o
endfunction isect_sphere_pairs_r16
