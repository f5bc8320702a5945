# isect_sphere_pairs_interpolated_r16   nearest hit of packets' rays with spheres, by 12 bits of
# root
#   C       void isect_sphere_pairs_interpolated_r16(const struct candidate *, int count);
#   In      $3 candidates of objects that are spheres, $4 count (0 is none); pointers 16-aligned
#   Out     the candidates' packets: t, object, where a hit has 0 < t < what was there
#   Uses    $2-$69, $79   Saves  -   Stack  0   Calls  -
#   Domain  |d| = 1 within 4 ulp; coordinates and radius below 2^62, radius above 2^-40
#   Error   3000 ulp of the larger of t and r, origin up to 30 radii from the centre but not within
#           1/1000 of one from the surface, ray within 0.995 r of it
#   Twin    lab/twins/src/sphere/perpendicular.rs
#
# The steps are in sphere_tmpl.inc. The hit is the entry; with SIDES_EXIT it is the exit, and with
# SIDES_BOTH it is also the exit of a ray from inside.
# Scheduled by spu schedule from isect_sphere_pairs_interpolated_r16.s

        .include "sphere_general.inc"
        .include "sphere_interpolated.inc"

        general_registers "m_sign", "radius2", "out,y,s"
        sign_controls_table
        sides_tables 0x3f000000, 0x3f800000

function isect_sphere_pairs_interpolated_r16
        .set count_2,79; .set a_candidate_2,2; .set object_2,20; .set object_3,2; .set a_packet_2,6
        .set quad_2,8; .set quad_3,5; .set ox_2,19; .set dx_2,41; .set cx_2,18; .set oy_2,39
        .set ox_3,27; .set cy_2,40; .set fx_2,19; .set dx_3,33; .set dy_2,54; .set fy_2,39
        .set fx_3,7; .set oz_2,27; .set b_2,46; .set oy_3,28; .set fx_4,29; .set cz_2,8
        .set oz_3,48; .set fy_3,30; .set dx_4,34; .set b_3,49; .set dy_3,51; .set fz_2,27
        .set oy_4,42; .set fy_4,28; .set dy_4,43; .set dz_2,58; .set b_4,55; .set oz_4,9
        .set b_5,52; .set dy_5,50; .set fz_3,48; .set oz_5,53; .set fy_5,42; .set dz_3,57
        .set dz_4,18; .set radius2_2,44; .set fz_4,9; .set dz_5,56; .set fz_5,53
        .set a_packet_3,24; .set cx_3,8; .set t_best_2,60; .set ox_4,21; .set b_6,22; .set ox_5,23
        .set fy_6,26; .set ox_6,31; .set ox_7,36; .set disc_2,37; .set oy_5,33; .set dx_5,38
        .set oy_6,34; .set disc_3,19; .set oy_7,43; .set dx_6,45; .set disc_4,26; .set cy_3,37
        .set disc_5,7; .set oz_6,47; .set disc_6,29; .set t_best_3,44; .set oz_7,51; .set dy_6,30
        .set dy_7,27; .set oz_8,18; .set fz_6,28; .set t_best_4,52; .set sides_2,59; .set cz_3,25
        .set disc_7,5; .set y_2,29; .set m_by_side_2,9; .set fx_5,36; .set whole_2,53; .set dz_6,55
        .set y_3,56; .set disc_8,62; .set dz_7,28; .set out_2,57; .set dz_8,61; .set out_3,63
        .set y_4,5; .set sides_3,64; .set s_2,42; .set nearest_2,65; .set fx_6,21; .set y_5,66
        .set y_6,67; .set a_packet_4,5; .set nearest_3,57; .set out_4,68; .set radius2_3,69
        .set y_7,42; .set nearest_4,56; .set t_2,29; .set nearest_5,6; .set s_3,40; .set half_2,59
        .set fx_7,31; .set object_4,63; .set fx_8,2; .set t_3,8; .set y_8,23; .set control_2,40
        .set s_4,9; .set ahead_2,42; .set t_4,22; .set fy_7,23; .set y_9,9; .set b_7,34; .set t_5,9
        .set b_8,43; .set fy_8,33; .set control_3,26; .set b_9,37; .set control_4,53
        .set ahead_3,59; .set control_5,46; .set control_6,19; .set fz_7,47; .set ahead_4,40
        .set fz_8,18; .set b_10,59; .set fz_9,25; .set control_7,48; .set control_8,7
        .set nearest_6,26; .set b_11,48; .set control_9,29; .set radius2_4,37; .set fx_9,32
        .set t_best_5,8; .set fy_9,36; .set nearest_7,19; .set disc_9,31; .set disc_10,32
        .set whole_3,34; .set disc_11,2; .set m_by_side_3,41; .set control_10,27; .set nearest_8,21
        .set fz_10,29; .set t_best_6,7; .set fz_11,8; .set disc_12,18; .set disc_13,51
        .set nearest_9,61; .set disc_14,50; .set disc_15,52; .set out_5,2; .set out_6,6
        .set y_10,7; .set out_7,8; .set nearest_10,9; .set y_11,18; .set y_12,19; .set s_5,2
        .set t_best_7,22; .set s_6,6; .set t_best_8,23; .set y_13,2; .set t_6,2; .set y_14,6
        .set t_7,7; .set t_8,6; .set ahead_5,26; .set control_11,28; .set control_12,31
        .set ahead_6,33; .set control_13,38; .set fx_10,18; .set oz_9,40; .set dz_9,25
        .set fz_12,32; .set t_best_9,6; .set fx_11,23; .set fy_10,29; .set fy_11,7
        .set t_best_10,33; .set disc_16,23; .set nearest_11,38; .set ox_8,2; .set dx_7,5
        .set oy_8,6; .set oz_10,7; .set fy_12,6; .set dy_8,8; .set b_12,9; .set ox_9,20
        .set dz_10,24; .set fz_13,7; .set dx_8,26; .set oy_9,27; .set radius2_5,28; .set fx_12,20
        .set dx_9,31; .set oz_11,29; .set oz_12,35; .set dy_9,36; .set dy_10,41; .set dz_11,42
        .set dz_12,44; .set fy_13,22; .set b_13,27; .set t_best_11,45; .set t_best_12,46
        .set t_best_13,5; .set t_best_14,32; .set nearest_12,8; .set nearest_13,33; .set fz_14,23
        .set nearest_14,35; .set nearest_15,47; .set b_14,24; .set disc_17,6; .set whole_4,7
        .set m_by_side_4,21; .set disc_18,20; .set out_8,25; .set fz_15,26; .set s_7,22
        .set ahead_7,25; .set out_9,28; .set ahead_8,30; .set control_14,25; .set control_15,6
        .set control_16,2; .set s_8,7; .set t_9,21; .set ahead_9,23; .set control_17,24
        .set control_18,23; .set ahead_10,24; .set control_19,20; .set nearest_16,2
        .set control_20,9
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
        lqd     $quad_2,0($object_2)                    # 20o
        lqd     $sides,32($object_2)                    # 21o
        lqd     $quad_3,0($object_3)                    # 22o
        lqd     $ox,32($a_packet_2)                     # 23o
        lqd     $ox_2,0($a_packet_2)                    # 24o
        lqd     $dx_2,224($a_packet_2)                  # 25o
        shufb   $cx_2,$quad_2,$quad_2,$m_x              # 26o
        lqd     $oy_2,96($a_packet_2)                   # 27o
        lqd     $ox_3,48($a_packet_2)                   # 28o
        shufb   $cy_2,$quad_2,$quad_2,$m_y              # 29o
        fs      $fx,$cx_2,$ox                           # 30e
        lqd     $ox,16($a_packet_2)                     # 30o
        fs      $fx_2,$cx_2,$ox_2                       # 31e
        lqd     $dx_3,240($a_packet_2)                  # 31o
        nop     $127                                    # 32e pairing
        lqd     $dy_2,288($a_packet_2)                  # 32o
        fs      $fy_2,$cy_2,$oy_2                       # 33e
        lqd     $oy,64($a_packet_2)                     # 33o
        fs      $fx_3,$cx_2,$ox_3                       # 34e
        lqd     $dx,192($a_packet_2)                    # 34o
        nop     $127                                    # 35e pairing
        lqd     $oz_2,160($a_packet_2)                  # 35o
        fm      $b_2,$fx,$dx_2                          # 36e
        lqd     $oy_3,112($a_packet_2)                  # 36o
        fs      $fx_4,$cx_2,$ox                         # 37e
        shufb   $cz_2,$quad_2,$quad_2,$m_z              # 37o
        nop     $127                                    # 38e pairing
        lqd     $oz_3,128($a_packet_2)                  # 38o
        fs      $fy_3,$cy_2,$oy                         # 39e
        lqd     $dx_4,208($a_packet_2)                  # 39o
        fm      $b_3,$fx_2,$dx                          # 40e
        lqd     $dy_3,304($a_packet_2)                  # 40o
        fs      $fz_2,$cz_2,$oz_2                       # 41e
        lqd     $oy_4,80($a_packet_2)                   # 41o
        fs      $fy_4,$cy_2,$oy_3                       # 42e
        lqd     $dy_4,256($a_packet_2)                  # 42o
        fma     $b_2,$fy_2,$dy_2,$b_2                   # 43e
        lqd     $dz_2,352($a_packet_2)                  # 43o
        fm      $b_4,$fx_3,$dx_3                        # 44e
        lqd     $oz_4,176($a_packet_2)                  # 44o
        fm      $b_5,$fx_4,$dx_4                        # 45e
        lqd     $dy_5,272($a_packet_2)                  # 45o
        fs      $fz_3,$cz_2,$oz_3                       # 46e
        lqd     $oz_5,144($a_packet_2)                  # 46o
        fs      $fy_5,$cy_2,$oy_4                       # 47e
        lqd     $dz_3,320($a_packet_2)                  # 47o
        fma     $b_3,$fy_3,$dy_4,$b_3                   # 48e
        lqd     $dz_4,368($a_packet_2)                  # 48o
        fma     $b,$fz_2,$dz_2,$b_2                     # 49e
        shufb   $radius2_2,$sides,$sides,$m_x           # 49o
        fs      $fz_4,$cz_2,$oz_4                       # 50e
        lqd     $dz_5,336($a_packet_2)                  # 50o
        fma     $b_4,$fy_4,$dy_3,$b_4                   # 51e
        rotqbyi $sides,$sides,12                        # 51o
        fs      $fz_5,$cz_2,$oz_5                       # 52e
        rotqbyi $a_packet_3,$object_3,4                 # 52o
        fma     $b_5,$fy_5,$dy_5,$b_5                   # 53e
        shufb   $cx_3,$quad_3,$quad_3,$m_x              # 53o
        fma     $b_3,$fz_3,$dz_3,$b_3                   # 54e
        lqd     $t_best,416($a_packet_2)                # 54o
        fm      $radius2_2,$radius2_2,$radius2_2        # 55e
        lqd     $t_best_2,384($a_packet_2)              # 55o
        fnms    $fx,$b,$dx_2,$fx                        # 56e
        lqd     $ox_4,32($a_packet_3)                   # 56o
        fma     $b_6,$fz_4,$dz_4,$b_4                   # 57e
        lqd     $ox_5,16($a_packet_3)                   # 57o
        fnms    $fy_6,$b,$dy_2,$fy_2                    # 58e
        lqd     $ox_6,0($a_packet_3)                    # 58o
        fma     $b_2,$fz_5,$dz_5,$b_5                   # 59e
        lqd     $ox_7,48($a_packet_3)                   # 59o
        fnms    $fx_2,$b_3,$dx,$fx_2                    # 60e
        lqd     $dx,192($a_packet_3)                    # 60o
        fnms    $fy_3,$b_3,$dy_4,$fy_3                  # 61e
        lqd     $oy_2,96($a_packet_3)                   # 61o
        fnms    $disc_2,$fx,$fx,$radius2_2              # 62e
        lqd     $dx_2,224($a_packet_3)                  # 62o
        fnms    $fx_3,$b_6,$dx_3,$fx_3                  # 63e
        lqd     $oy_5,64($a_packet_3)                   # 63o
        fnms    $fy_4,$b_6,$dy_3,$fy_4                  # 64e
        lqd     $dx_5,208($a_packet_3)                  # 64o
        fnms    $fx_4,$b_2,$dx_4,$fx_4                  # 65e
        lqd     $oy_6,112($a_packet_3)                  # 65o
        fnms    $disc_3,$fx_2,$fx_2,$radius2_2          # 66e
        lqd     $oy_7,80($a_packet_3)                   # 66o
        fnms    $fz_2,$b,$dz_2,$fz_2                    # 67e
        lqd     $dx_6,240($a_packet_3)                  # 67o
        fnms    $disc_4,$fy_6,$fy_6,$disc_2             # 68e
        shufb   $cy_3,$quad_3,$quad_3,$m_y              # 68o
        fnms    $disc_5,$fx_3,$fx_3,$radius2_2          # 69e
        lqd     $oz_6,128($a_packet_3)                  # 69o
        fnms    $fy_5,$b_2,$dy_5,$fy_5                  # 70e
        lqd     $dy_5,272($a_packet_3)                  # 70o
        fnms    $disc_6,$fx_4,$fx_4,$radius2_2          # 71e
        lqd     $t_best_3,432($a_packet_2)              # 71o
        fnms    $fz_3,$b_3,$dz_3,$fz_3                  # 72e
        lqd     $oz_7,176($a_packet_3)                  # 72o
        fnms    $disc_3,$fy_3,$fy_3,$disc_3             # 73e
        lqd     $dy_6,256($a_packet_3)                  # 73o
        fnms    $disc_4,$fz_2,$fz_2,$disc_4             # 74e
        lqd     $dy_7,304($a_packet_3)                  # 74o
        fnms    $fz_4,$b_6,$dz_4,$fz_4                  # 75e
        lqd     $oz_8,144($a_packet_3)                  # 75o
        fnms    $disc_5,$fy_4,$fy_4,$disc_5             # 76e
        lqd     $dy_2,288($a_packet_3)                  # 76o
        fnms    $fz_6,$b_2,$dz_5,$fz_5                  # 77e
        lqd     $t_best_4,400($a_packet_2)              # 77o
        rotmi   $sides_2,$sides,-26                     # 78e
        shufb   $cz_3,$quad_3,$quad_3,$m_z              # 78o
        fnms    $disc_3,$fz_3,$fz_3,$disc_3             # 79e
        lqd     $oz_3,160($a_packet_3)                  # 79o
        fnms    $disc_7,$fy_5,$fy_5,$disc_6             # 80e
        frsqest $y_2,$disc_4                            # 80o
        fms     $out,$b,$b,$disc_4                      # 81e
        lqd     $dz_2,352($a_packet_3)                  # 81o
        fnms    $disc_5,$fz_4,$fz_4,$disc_5             # 82e
        lqx     $m_by_side_2,$a_by_side,$sides_2        # 82o
        fs      $fx_5,$cx_3,$ox_7                       # 83e
        lqx     $whole_2,$a_whole,$sides_2              # 83o
        fi      $y_2,$disc_4,$y_2                       # 84e
        lqd     $dz_6,368($a_packet_3)                  # 84o
        nop     $127                                    # 85e pairing
        frsqest $y_3,$disc_3                            # 85o
        fnms    $disc_8,$fz_6,$fz_6,$disc_7             # 86e
        lqd     $dz_7,336($a_packet_3)                  # 86o
        fms     $out_2,$b_3,$b_3,$disc_3                # 87e
        lqd     $dz_8,320($a_packet_3)                  # 87o
        fms     $out_3,$b_6,$b_6,$disc_5                # 88e
        frsqest $y_4,$disc_5                            # 88o
        fi      $y_3,$disc_3,$y_3                       # 89e
        lqd     $sides_3,32($object_3)                  # 89o
        selb    $s_2,$whole_2,$out,$m_by_side_2         # 90e
        lqd     $nearest_2,480($a_packet_2)             # 90o
        fs      $fx_6,$cx_3,$ox_4                       # 91e
        shufb   $object_2,$object_2,$object_2,$m_x      # 91o
        fi      $y_5,$disc_5,$y_4                       # 92e
        frsqest $y_6,$disc_8                            # 92o
        selb    $y_2,$y_2,$s_2,$m_sign                  # 93e
        shlqbyi $a_packet_4,$a_packet_2,0               # 93o copy
        selb    $s_2,$whole_2,$out_2,$m_by_side_2       # 94e
        lqd     $nearest_3,496($a_packet_2)             # 94o
        fms     $out_4,$b_2,$b_2,$disc_8                # 95e
        shufb   $radius2_3,$sides_3,$sides_3,$m_x       # 95o
        fi      $y_6,$disc_8,$y_6                       # 96e
        rotqbyi $sides_3,$sides_3,12                    # 96o
        selb    $y_7,$y_3,$s_2,$m_sign                  # 97e
        lqd     $nearest_4,448($a_packet_2)             # 97o
        fnms    $t_2,$disc_4,$y_2,$b                    # 98e
        lqd     $nearest_5,464($a_packet_2)             # 98o
        selb    $s_3,$whole_2,$out_3,$m_by_side_2       # 99e
        lqx     $half_2,$a_half,$sides_2                # 99o
        fs      $fx_7,$cx_3,$ox_6                       # 100e
        shufb   $object_4,$object_3,$object_3,$m_x      # 100o
        fs      $fx_8,$cx_3,$ox_5                       # 101e
        fnms    $t_3,$disc_3,$y_7,$b_3                  # 102e
        selb    $y_8,$y_5,$s_3,$m_sign                  # 103e
        cgt     $control_2,$t_best,$t_2                 # 104e
        selb    $s_4,$whole_2,$out_4,$m_by_side_2       # 105e
        cgti    $ahead_2,$t_2,0                         # 106e
        fm      $b_3,$fx_6,$dx_2                        # 107e
        and     $control_2,$control_2,$ahead_2          # 108e
        fs      $fy_5,$cy_3,$oy_7                       # 109e
        fs      $fy_2,$cy_3,$oy_2                       # 110e
        fnms    $t_4,$disc_5,$y_8,$b_6                  # 111e
        fs      $fy_7,$cy_3,$oy_6                       # 112e
        selb    $y_9,$y_6,$s_4,$m_sign                  # 113e
        fm      $b_7,$fx_7,$dx                          # 114e
        fnms    $t_5,$disc_8,$y_9,$b_2                  # 115e
        fm      $b_8,$fx_8,$dx_5                        # 116e
        fs      $fy_8,$cy_3,$oy_5                       # 117e
        andc    $control_3,$control_2,$disc_4           # 118e
        fm      $b_9,$fx_5,$dx_6                        # 119e
        lnop                                            # 119o pairing
        cgti    $ahead,$t_3,0                           # 120e
        rotqbii $control_3,$control_3,1                 # 120o
        cgt     $control_2,$t_best_2,$t_3               # 121e
        cgt     $control_4,$t_best_3,$t_4               # 122e
        fma     $b_7,$fy_8,$dy_6,$b_7                   # 123e
        lnop                                            # 123o pairing
        cgti    $ahead_3,$t_4,0                         # 124e
        gb      $control_3,$control_3                   # 124o
        and     $control_2,$control_2,$ahead            # 125e
        and     $control_5,$control_4,$ahead_3          # 126e
        andc    $control_6,$control_2,$disc_3           # 127e
        lnop                                            # 127o pairing
        fs      $fz_5,$cz_3,$oz_3                       # 128e
        shlqbii $control_3,$control_3,4                 # 128o
        fs      $fz_7,$cz_3,$oz_6                       # 129e
        rotqbii $control_6,$control_6,1                 # 129o
        fma     $b_9,$fy_7,$dy_7,$b_9                   # 130e
        cgti    $ahead_4,$t_5,0                         # 131e
        fs      $fz_8,$cz_3,$oz_8                       # 132e
        lqx     $control_3,$control_3,$a_controls       # 132o
        fma     $b_8,$fy_5,$dy_5,$b_8                   # 133e
        gb      $control_6,$control_6                   # 133o
        fma     $b_10,$fy_2,$dy_2,$b_3                  # 134e
        fs      $fz_9,$cz_3,$oz_7                       # 135e
        cgt     $control_7,$t_best_4,$t_5               # 136e
        lnop                                            # 136o pairing
        andc    $control_8,$control_5,$disc_5           # 137e
        shlqbii $control_6,$control_6,4                 # 137o
        and     $control_2,$control_7,$ahead_4          # 138e
        shufb   $t_best,$t_best,$t_2,$control_3         # 138o
        fma     $b_2,$fz_8,$dz_7,$b_8                   # 139e
        rotqbii $control_8,$control_8,1                 # 139o
        fma     $b_3,$fz_7,$dz_8,$b_7                   # 140e
        shufb   $nearest_6,$nearest_2,$object_2,$control_3 # 140o
        fma     $b_11,$fz_9,$dz_6,$b_9                  # 141e
        lqx     $control_6,$control_6,$a_controls       # 141o
        andc    $control_9,$control_2,$disc_8           # 142e
        lnop                                            # 142o pairing
        fma     $b,$fz_5,$dz_2,$b_10                    # 143e
        gb      $control_8,$control_8                   # 143o
        fm      $radius2_4,$radius2_3,$radius2_3        # 144e
        rotqbii $control_9,$control_9,1                 # 144o
        fnms    $fx_8,$b_2,$dx_5,$fx_8                  # 145e
        fnms    $fx_7,$b_3,$dx,$fx_7                    # 146e
        fnms    $fx_9,$b_11,$dx_6,$fx_5                 # 147e
        shlqbii $control_8,$control_8,4                 # 147o
        rotmi   $sides_2,$sides_3,-26                   # 148e
        gb      $control_9,$control_9                   # 148o
        fnms    $fx_6,$b,$dx_2,$fx_6                    # 149e
        shufb   $t_best_5,$t_best_2,$t_3,$control_6     # 149o
        fnms    $fy_9,$b,$dy_2,$fy_2                    # 150e
        shufb   $nearest_7,$nearest_4,$object_2,$control_6 # 150o
        fnms    $fy_3,$b_3,$dy_6,$fy_8                  # 151e
        lqx     $control_8,$control_8,$a_controls       # 151o
        fnms    $disc_9,$fx_7,$fx_7,$radius2_4          # 152e
        shlqbii $control_9,$control_9,4                 # 152o
        fnms    $disc_10,$fx_9,$fx_9,$radius2_4         # 153e
        lqx     $whole_3,$a_whole,$sides_2              # 153o
        fnms    $disc_11,$fx_8,$fx_8,$radius2_4         # 154e
        lqx     $m_by_side_3,$a_by_side,$sides_2        # 154o
        fnms    $fy_8,$b_2,$dy_5,$fy_5                  # 155e
        stqd    $t_best,416($a_packet_4)                # 155o
        fnms    $fy_7,$b_11,$dy_7,$fy_7                 # 156e
        lqx     $control_10,$control_9,$a_controls      # 156o
        fnms    $disc_2,$fx_6,$fx_6,$radius2_4          # 157e
        shufb   $nearest_8,$nearest_3,$object_2,$control_8 # 157o
        fnms    $fz_10,$b_3,$dz_8,$fz_7                 # 158e
        stqd    $nearest_6,480($a_packet_4)             # 158o
        fnms    $disc_4,$fy_3,$fy_3,$disc_9             # 159e
        shufb   $t_best_6,$t_best_3,$t_4,$control_8     # 159o
        fnms    $fz,$b_2,$dz_7,$fz_8                    # 160e
        stqd    $t_best_5,384($a_packet_4)              # 160o
        fnms    $fz_11,$b_11,$dz_6,$fz_9                # 161e
        lqd     $t_best_2,384($a_packet_3)              # 161o
        fnms    $disc_11,$fy_8,$fy_8,$disc_11           # 162e
        stqd    $nearest_8,496($a_packet_4)             # 162o
        fnms    $disc_12,$fy_9,$fy_9,$disc_2            # 163e
        stqd    $nearest_7,448($a_packet_4)             # 163o
        fnms    $fz_9,$b,$dz_2,$fz_5                    # 164e
        stqd    $t_best_6,432($a_packet_4)              # 164o
        fnms    $disc_5,$fy_7,$fy_7,$disc_10            # 165e
        shufb   $nearest,$nearest_5,$object_2,$control_10 # 165o
        fnms    $disc_13,$fz_10,$fz_10,$disc_4          # 166e
        lqd     $nearest_9,480($a_packet_3)             # 166o
        shufb   $t_best,$t_best_4,$t_5,$control_10      # 167o
        fnms    $disc_8,$fz,$fz,$disc_11                # 168e
        stqd    $nearest,464($a_packet_4)               # 169o
        fnms    $disc_14,$fz_9,$fz_9,$disc_12           # 170e
        fnms    $disc_15,$fz_11,$fz_11,$disc_5          # 171e
        lnop                                            # 171o pairing
next_ball:
        ai      $count,$count,-1                        # 0e
            lqd     $nearest,496($a_packet_3)           # 0o
            fms     $out,$b_3,$b_3,$disc_13             # 1e
            frsqest $y,$disc_13                         # 1o
            fms     $out_5,$b_2,$b_2,$disc_8            # 2e
            stqd    $t_best,400($a_packet_4)            # 2o
            nop     $127                                # 3e pairing
            shlqbyi $a_packet_4,$a_packet_3,0           # 3o copy
            fms     $out_6,$b,$b,$disc_14               # 4e
            frsqest $y_10,$disc_8                       # 4o
            fms     $out_7,$b_11,$b_11,$disc_15         # 5e
            lqd     $nearest_10,464($a_packet_3)        # 5o
            fi      $y,$disc_13,$y                      # 6e
            frsqest $y_11,$disc_14                      # 6o
            selb    $s,$whole_3,$out,$m_by_side_3       # 7e
            frsqest $y_12,$disc_15                      # 7o
            fi      $y_10,$disc_8,$y_10                 # 8e
        lqd     $object_2,0($a_candidate)               # 8o
            selb    $s_5,$whole_3,$out_5,$m_by_side_3   # 9e
            lqd     $nearest_8,448($a_packet_3)         # 9o
            fi      $y_11,$disc_14,$y_11                # 10e
            lqd     $t_best,416($a_packet_3)            # 10o
            fi      $y_12,$disc_15,$y_12                # 11e
            lqd     $t_best_7,400($a_packet_3)          # 11o
            selb    $s_6,$whole_3,$out_6,$m_by_side_3   # 12e
            lqd     $t_best_8,432($a_packet_3)          # 12o
            selb    $y,$y,$s,$m_sign                    # 13e
            lnop                                        # 13o pairing
            selb    $s,$whole_3,$out_7,$m_by_side_3     # 14e
        lqd     $quad_2,0($object_2)                    # 14o
            selb    $y_13,$y_10,$s_5,$m_sign            # 15e
        rotqbyi $a_packet_3,$object_2,4                 # 15o
            fnms    $t,$disc_13,$y,$b_3                 # 16e
            selb    $y,$y_11,$s_6,$m_sign               # 17e
            fnms    $t_6,$disc_8,$y_13,$b_2             # 18e
            lnop                                        # 18o pairing
            selb    $y_14,$y_12,$s,$m_sign              # 19e
        lqd     $ox,32($a_packet_3)                     # 19o
            fnms    $t_7,$disc_14,$y,$b                 # 20e
        shufb   $cx_2,$quad_2,$quad_2,$m_x              # 20o
            fnms    $t_8,$disc_15,$y_14,$b_11           # 21e
            lnop                                        # 21o pairing
            cgti    $ahead,$t,0                         # 22e
        lqd     $sides,32($object_2)                    # 22o
            cgt     $control,$t_best_2,$t               # 23e
        lqd     $ox_2,0($a_packet_3)                    # 23o
            cgti    $ahead_5,$t_6,0                     # 24e
        lqd     $ox_3,48($a_packet_3)                   # 24o
        fs      $fx,$cx_2,$ox                           # 25e
        lqd     $ox,16($a_packet_3)                     # 25o
            cgt     $control_11,$t_best_7,$t_6          # 26e
        lqd     $oy,64($a_packet_3)                     # 26o
            cgt     $control_12,$t_best_8,$t_8          # 27e
        lqd     $dx,192($a_packet_3)                    # 27o
            cgti    $ahead_6,$t_8,0                     # 28e
        lqd     $dx_4,208($a_packet_3)                  # 28o
            cgt     $control_13,$t_best,$t_7            # 29e
        lqd     $oy_2,96($a_packet_3)                   # 29o
            cgti    $ahead_4,$t_7,0                     # 30e
        lqd     $dx_2,224($a_packet_3)                  # 30o
            and     $control_3,$control_11,$ahead_5     # 31e
        lqd     $oy_3,112($a_packet_3)                  # 31o
            and     $control_13,$control_13,$ahead_4    # 32e
        shufb   $cy_2,$quad_2,$quad_2,$m_y              # 32o
            and     $control_12,$control_12,$ahead_6    # 33e
        lqd     $dx_3,240($a_packet_3)                  # 33o
            andc    $control_13,$control_13,$disc_14    # 34e
        lqd     $oy_4,80($a_packet_3)                   # 34o
        fs      $fx_2,$cx_2,$ox_2                       # 35e
        shufb   $cz_2,$quad_2,$quad_2,$m_z              # 35o
        fs      $fx_4,$cx_2,$ox                         # 36e
        lqd     $dy_4,256($a_packet_3)                  # 36o
        fs      $fx_10,$cx_2,$ox_3                      # 37e
        lqd     $oz_2,160($a_packet_3)                  # 37o
            and     $control,$control,$ahead            # 38e
        shufb   $radius2_2,$sides,$sides,$m_x           # 38o
        fm      $b_2,$fx,$dx_2                          # 39e
        rotqbyi $sides,$sides,12                        # 39o
            andc    $control_12,$control_12,$disc_15    # 40e
        lqd     $oz_3,128($a_packet_3)                  # 40o
        fm      $b_3,$fx_2,$dx                          # 41e
        lqd     $dy_5,272($a_packet_3)                  # 41o
            andc    $control,$control,$disc_13          # 42e
        lqd     $dy_3,304($a_packet_3)                  # 42o
        fm      $b_5,$fx_4,$dx_4                        # 43e
        lqd     $oz_5,144($a_packet_3)                  # 43o
        fs      $fy_3,$cy_2,$oy                         # 44e
            rotqbii $control,$control,1                 # 44o
        fs      $fy_5,$cy_2,$oy_4                       # 45e
            rotqbii $control_13,$control_13,1           # 45o
        fs      $fy_4,$cy_2,$oy_3                       # 46e
        lqd     $dy_2,288($a_packet_3)                  # 46o
        fs      $fy_2,$cy_2,$oy_2                       # 47e
        lqd     $oz_9,176($a_packet_3)                  # 47o
        fm      $b_4,$fx_10,$dx_3                       # 48e
            rotqbii $control_12,$control_12,1           # 48o
        fs      $fz_2,$cz_2,$oz_2                       # 49e
        lqd     $dz_5,336($a_packet_3)                  # 49o
        fma     $b_3,$fy_3,$dy_4,$b_3                   # 50e
        lqd     $dz_3,320($a_packet_3)                  # 50o
        fs      $fz_3,$cz_2,$oz_3                       # 51e
            gb      $control,$control                   # 51o
        fma     $b_5,$fy_5,$dy_5,$b_5                   # 52e
            gb      $control_12,$control_12             # 52o
        fma     $b_2,$fy_2,$dy_2,$b_2                   # 53e
        lqd     $dz_2,352($a_packet_3)                  # 53o
        fma     $b_4,$fy_4,$dy_3,$b_4                   # 54e
            gb      $control_13,$control_13             # 54o
        fs      $fz_5,$cz_2,$oz_5                       # 55e
            shlqbii $control,$control,4                 # 55o
        fm      $radius2_2,$radius2_2,$radius2_2        # 56e
            shlqbii $control_12,$control_12,4           # 56o
        fma     $b_3,$fz_3,$dz_3,$b_3                   # 57e
            lqx     $half_2,$a_half,$sides_2            # 57o
        rotmi   $sides_2,$sides,-26                     # 58e
        lqd     $dz_9,368($a_packet_3)                  # 58o
        fs      $fz_11,$cz_2,$oz_9                      # 59e
            shlqbii $control_13,$control_13,4           # 59o
        fma     $b,$fz_2,$dz_2,$b_2                     # 60e
            lqx     $control,$control,$a_controls       # 60o
        fma     $b_2,$fz_5,$dz_5,$b_5                   # 61e
            lqx     $control_12,$control_12,$a_controls # 61o
            andc    $control_3,$control_3,$disc_8       # 62e
            lnop                                        # 62o pairing
        fnms    $fx_2,$b_3,$dx,$fx_2                    # 63e
        hbrr    next_ball_back,next_ball                # 63o hint
        fnms    $fz_12,$b_3,$dz_3,$fz_3                 # 64e
            rotqbii $control_3,$control_3,1             # 64o
        fma     $b_11,$fz_11,$dz_9,$b_4                 # 65e
            lqx     $control_13,$control_13,$a_controls # 65o
        fnms    $fx,$b,$dx_2,$fx                        # 66e
        lqx     $m_by_side_3,$a_by_side,$sides_2        # 66o
        fnms    $fy_3,$b_3,$dy_4,$fy_3                  # 67e
            shufb   $t_best_9,$t_best_8,$t_8,$control_12 # 67o
        fnms    $fx_11,$b_2,$dx_4,$fx_4                 # 68e
            gb      $control_3,$control_3               # 68o
        fnms    $disc_3,$fx_2,$fx_2,$radius2_2          # 69e
            shufb   $nearest_8,$nearest_8,$object_4,$control # 69o
        fnms    $fy_10,$b,$dy_2,$fy_2                   # 70e
        lqx     $whole_3,$a_whole,$sides_2              # 70o
        fnms    $fx_10,$b_11,$dx_3,$fx_10               # 71e
            shufb   $t_best,$t_best,$t_7,$control_13    # 71o
        fnms    $fy_11,$b_2,$dy_5,$fy_5                 # 72e
            shlqbii $control_3,$control_3,4             # 72o
        fnms    $fy_4,$b_11,$dy_3,$fy_4                 # 73e
            shufb   $t_best_10,$t_best_2,$t,$control    # 73o
        fnms    $disc_16,$fx_11,$fx_11,$radius2_2       # 74e
            shufb   $nearest_11,$nearest_9,$object_4,$control_13 # 74o
        fnms    $disc_2,$fx,$fx,$radius2_2              # 75e
            stqd    $t_best,416($a_packet_4)            # 75o
        fnms    $disc_3,$fy_3,$fy_3,$disc_3             # 76e
            lqx     $control,$control_3,$a_controls     # 76o
        fnms    $disc_12,$fx_10,$fx_10,$radius2_2       # 77e
            shufb   $nearest,$nearest,$object_4,$control_12 # 77o
        fnms    $fz,$b_2,$dz_5,$fz_5                    # 78e
            stqd    $nearest_11,480($a_packet_4)        # 78o
        fnms    $fz_11,$b_11,$dz_9,$fz_11               # 79e
            stqd    $t_best_10,384($a_packet_4)         # 79o
        fnms    $disc_5,$fy_11,$fy_11,$disc_16          # 80e
        lqd     $t_best_2,384($a_packet_3)              # 80o
        fnms    $disc_16,$fy_10,$fy_10,$disc_2          # 81e
            stqd    $nearest,496($a_packet_4)           # 81o
        fnms    $fz_9,$b,$dz_2,$fz_2                    # 82e
            stqd    $nearest_8,448($a_packet_4)         # 82o
        fnms    $disc_12,$fy_4,$fy_4,$disc_12           # 83e
            stqd    $t_best_9,432($a_packet_4)          # 83o
        fnms    $disc_13,$fz_12,$fz_12,$disc_3          # 84e
            shufb   $nearest,$nearest_10,$object_4,$control # 84o
        ai      $a_candidate,$a_candidate,16            # 85e
        lqd     $nearest_9,480($a_packet_3)             # 85o
        fnms    $disc_8,$fz,$fz,$disc_5                 # 86e
        shufb   $object_4,$object_2,$object_2,$m_x      # 86o
            nop     $127                                # 87e pairing
            shufb   $t_best,$t_best_7,$t_6,$control     # 87o
        fnms    $disc_14,$fz_9,$fz_9,$disc_16           # 88e
            stqd    $nearest,464($a_packet_4)           # 88o
        fnms    $disc_15,$fz_11,$fz_11,$disc_12         # 89e
next_ball_back:
        brnz    $count,next_ball                        # 89o
next_ball_drain:
        fms     $out,$b_3,$b_3,$disc_13                 # 0e
        frsqest $y,$disc_13                             # 0o
        fms     $out_6,$b,$b,$disc_14                   # 1e
        frsqest $y_11,$disc_14                          # 1o
        fms     $out_5,$b_2,$b_2,$disc_8                # 2e
        frsqest $y_10,$disc_8                           # 2o
        fms     $out_7,$b_11,$b_11,$disc_15             # 3e
        frsqest $y_12,$disc_15                          # 3o
        fi      $y,$disc_13,$y                          # 4e
        lqd     $nearest,496($a_packet_3)               # 4o
        fi      $y_11,$disc_14,$y_11                    # 5e
        stqd    $t_best,400($a_packet_4)                # 5o
        fi      $y_10,$disc_8,$y_10                     # 6e
        lqd     $t_best,416($a_packet_3)                # 6o
        selb    $s,$whole_3,$out,$m_by_side_3           # 7e
        lqd     $t_best_8,432($a_packet_3)              # 7o
        selb    $s_6,$whole_3,$out_6,$m_by_side_3       # 8e
        lqd     $t_best_7,400($a_packet_3)              # 8o
        selb    $s_5,$whole_3,$out_5,$m_by_side_3       # 9e
        lqd     $nearest_8,448($a_packet_3)             # 9o
        fi      $y_12,$disc_15,$y_12                    # 10e
        shlqbyi $a_packet_4,$a_packet_3,0               # 10o copy
        selb    $y,$y,$s,$m_sign                        # 11e
        hbr     isect_sphere_pairs_interpolated_r16_return,$lr # 11o hint
        selb    $s,$whole_3,$out_7,$m_by_side_3         # 12e
        lqd     $nearest_10,464($a_packet_3)            # 12o
        fnms    $t,$disc_13,$y,$b_3                     # 13e
        lqx     $half_2,$a_half,$sides_2                # 13o
        selb    $y,$y_11,$s_6,$m_sign                   # 14e
        selb    $y_13,$y_10,$s_5,$m_sign                # 15e
        fnms    $t_7,$disc_14,$y,$b                     # 16e
        selb    $y_14,$y_12,$s,$m_sign                  # 17e
        fnms    $t_6,$disc_8,$y_13,$b_2                 # 18e
        fnms    $t_8,$disc_15,$y_14,$b_11               # 19e
        cgti    $ahead,$t,0                             # 20e
        cgt     $control,$t_best_2,$t                   # 21e
        cgt     $control_13,$t_best,$t_7                # 22e
        cgti    $ahead_4,$t_7,0                         # 23e
        and     $control,$control,$ahead                # 24e
        and     $control_13,$control_13,$ahead_4        # 25e
        cgt     $control_12,$t_best_8,$t_8              # 26e
        andc    $control_13,$control_13,$disc_14        # 27e
        cgti    $ahead_6,$t_8,0                         # 28e
        lnop                                            # 28o pairing
        andc    $control,$control,$disc_13              # 29e
        rotqbii $control_13,$control_13,1               # 29o
        and     $control_12,$control_12,$ahead_6        # 30e
        lnop                                            # 30o pairing
        cgti    $ahead_5,$t_6,0                         # 31e
        rotqbii $control,$control,1                     # 31o
        andc    $control_12,$control_12,$disc_15        # 32e
        lnop                                            # 32o pairing
        cgt     $control_11,$t_best_7,$t_6              # 33e
        gb      $control_13,$control_13                 # 33o
        nop     $127                                    # 34e pairing
        rotqbii $control_12,$control_12,1               # 34o
        and     $control_3,$control_11,$ahead_5         # 35e
        gb      $control,$control                       # 35o
        andc    $control_3,$control_3,$disc_8           # 37e
        shlqbii $control_13,$control_13,4               # 37o
        gb      $control_12,$control_12                 # 38o
        rotqbii $control_3,$control_3,1                 # 39o
        shlqbii $control,$control,4                     # 40o
        lqx     $control_13,$control_13,$a_controls     # 41o
        shlqbii $control_12,$control_12,4               # 42o
        gb      $control_3,$control_3                   # 43o
        lqx     $control,$control,$a_controls           # 44o
        lqx     $control_12,$control_12,$a_controls     # 46o
        shufb   $t_best,$t_best,$t_7,$control_13        # 47o
        shlqbii $control_3,$control_3,4                 # 48o
        shufb   $nearest_11,$nearest_9,$object_4,$control_13 # 49o
        shufb   $nearest_8,$nearest_8,$object_4,$control # 50o
        shufb   $t_best_10,$t_best_2,$t,$control        # 51o
        stqd    $t_best,416($a_packet_4)                # 52o
        lqx     $control,$control_3,$a_controls         # 53o
        shufb   $nearest,$nearest,$object_4,$control_12 # 54o
        stqd    $nearest_11,480($a_packet_4)            # 55o
        stqd    $t_best_10,384($a_packet_4)             # 56o
        shufb   $t_best_9,$t_best_8,$t_8,$control_12    # 57o
        stqd    $nearest,496($a_packet_4)               # 58o
        shufb   $nearest,$nearest_10,$object_4,$control # 59o
        shufb   $t_best,$t_best_7,$t_6,$control         # 60o
        stqd    $nearest_8,448($a_packet_4)             # 61o
        stqd    $t_best_9,432($a_packet_4)              # 62o
        stqd    $nearest,464($a_packet_4)               # 63o
        stqd    $t_best,400($a_packet_4)                # 64o
        nop     $127                                    # 65e pairing
isect_sphere_pairs_interpolated_r16_return:
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
        lqd     $ox_8,0($a_packet)                      # 11o
        lqd     $dx,208($a_packet)                      # 12o
        shufb   $cx,$quad,$quad,$m_x                    # 13o
        lqd     $oy,80($a_packet)                       # 14o
        lqd     $dx_7,192($a_packet)                    # 15o
        lqd     $oy_8,64($a_packet)                     # 16o
        fs      $fx,$cx,$ox_8                           # 17e
        shufb   $cy,$quad,$quad,$m_y                    # 17o
        fs      $fx_8,$cx,$ox                           # 18e
        lqd     $oz,128($a_packet)                      # 18o
        lqd     $dy,256($a_packet)                      # 19o
        shufb   $cz,$quad,$quad,$m_z                    # 20o
        fs      $fy,$cy,$oy                             # 21e
        lqd     $oz_10,144($a_packet)                   # 21o
        fs      $fy_12,$cy,$oy_8                        # 22e
        lqd     $dy_8,272($a_packet)                    # 22o
        fm      $b,$fx,$dx_7                            # 23e
        lqd     $ox,32($a_packet)                       # 23o
        fm      $b_12,$fx_8,$dx                         # 24e
        lqd     $ox_9,48($a_packet)                     # 24o
        fs      $fz,$cz,$oz                             # 25e
        lqd     $dz,320($a_packet)                      # 25o
        nop     $127                                    # 26e pairing
        lqd     $dz_10,336($a_packet)                   # 26o
        fs      $fz_13,$cz,$oz_10                       # 27e
        lqd     $oy,96($a_packet)                       # 27o
        nop     $127                                    # 28e pairing
        lqd     $dx_8,224($a_packet)                    # 28o
        fma     $b,$fy_12,$dy,$b                        # 29e
        lqd     $oy_9,112($a_packet)                    # 29o
        fma     $b_12,$fy,$dy_8,$b_12                   # 30e
        shufb   $radius2_5,$sides,$sides,$m_x           # 30o
        fs      $fx_12,$cx,$ox_9                        # 31e
        lqd     $dx_9,240($a_packet)                    # 31o
        fs      $fx_6,$cx,$ox                           # 32e
        lqd     $oz_11,176($a_packet)                   # 32o
        fs      $fy_3,$cy,$oy                           # 33e
        lqd     $oz_12,160($a_packet)                   # 33o
        fm      $radius2_5,$radius2_5,$radius2_5        # 34e
        lqd     $dy_9,288($a_packet)                    # 34o
        fma     $b,$fz,$dz,$b                           # 35e
        lqd     $dy_10,304($a_packet)                   # 35o
        fma     $b_12,$fz_13,$dz_10,$b_12               # 36e
        lqd     $dz_11,352($a_packet)                   # 36o
        fm      $b_8,$fx_12,$dx_9                       # 37e
        lqd     $dz_12,368($a_packet)                   # 37o
        fs      $fy_13,$cy,$oy_9                        # 38e
        rotqbyi $sides,$sides,12                        # 38o
        fm      $b_13,$fx_6,$dx_8                       # 39e
        lqd     $t_best_11,384($a_packet)               # 39o
        fs      $fz_10,$cz,$oz_11                       # 40e
        lqd     $t_best_12,400($a_packet)               # 40o
        fnms    $fx,$b,$dx_7,$fx                        # 41e
        lqd     $t_best_13,432($a_packet)               # 41o
        fnms    $fx_8,$b_12,$dx,$fx_8                   # 42e
        lqd     $t_best_14,416($a_packet)               # 42o
        fnms    $fy,$b_12,$dy_8,$fy                     # 43e
        lqd     $nearest_12,448($a_packet)              # 43o
        fnms    $fy_12,$b,$dy,$fy_12                    # 44e
        lqd     $nearest_13,464($a_packet)              # 44o
        fs      $fz_14,$cz,$oz_12                       # 45e
        lqd     $nearest_14,496($a_packet)              # 45o
        fma     $b_13,$fy_3,$dy_9,$b_13                 # 46e
        lqd     $nearest_15,480($a_packet)              # 46o
        fma     $b_8,$fy_13,$dy_10,$b_8                 # 47e
        fnms    $disc_11,$fx_8,$fx_8,$radius2_5         # 48e
        fnms    $disc_2,$fx,$fx,$radius2_5              # 49e
        fnms    $fz,$b,$dz,$fz                          # 50e
        fnms    $fz_13,$b_12,$dz_10,$fz_13              # 51e
        fma     $b_14,$fz_14,$dz_11,$b_13               # 52e
        fma     $b_13,$fz_10,$dz_12,$b_8                # 53e
        fnms    $disc_11,$fy,$fy,$disc_11               # 54e
        fnms    $disc_17,$fy_12,$fy_12,$disc_2          # 55e
        rotmi   $sides,$sides,-26                       # 56e
        fnms    $fx,$b_14,$dx_8,$fx_6                   # 58e
        fnms    $fx_12,$b_13,$dx_9,$fx_12               # 59e
        fnms    $disc_11,$fz_13,$fz_13,$disc_11         # 60e
        lqx     $whole_4,$a_whole,$sides                # 60o
        fnms    $disc_17,$fz,$fz,$disc_17               # 61e
        lqx     $m_by_side_4,$a_by_side,$sides          # 61o
        fnms    $fy,$b_14,$dy_9,$fy_3                   # 62e
        lqx     $half,$a_half,$sides                    # 62o
        fnms    $fy_13,$b_13,$dy_10,$fy_13              # 63e
        fnms    $disc,$fx,$fx,$radius2_5                # 64e
        fnms    $disc_18,$fx_12,$fx_12,$radius2_5       # 65e
        lnop                                            # 65o pairing
        fnms    $fz,$b_14,$dz_11,$fz_14                 # 66e
        frsqest $y,$disc_11                             # 66o
        fms     $out,$b,$b,$disc_17                     # 67e
        frsqest $y_8,$disc_17                           # 67o
        fms     $out_8,$b_12,$b_12,$disc_11             # 68e
        fnms    $fz_15,$b_13,$dz_12,$fz_10              # 69e
        fnms    $disc,$fy,$fy,$disc                     # 70e
        fi      $y_8,$disc_17,$y_8                      # 71e
        fi      $y,$disc_11,$y                          # 72e
        selb    $s,$whole_4,$out,$m_by_side_4           # 73e
        fnms    $disc_18,$fy_13,$fy_13,$disc_18         # 74e
        selb    $s_7,$whole_4,$out_8,$m_by_side_4       # 75e
        fnms    $disc,$fz,$fz,$disc                     # 76e
        selb    $y_8,$y_8,$s,$m_sign                    # 78e
        selb    $y,$y,$s_7,$m_sign                      # 79e
        fnms    $disc_18,$fz_15,$fz_15,$disc_18         # 80e
        fnms    $t_4,$disc_17,$y_8,$b                   # 81e
        lnop                                            # 81o pairing
        fnms    $t_5,$disc_11,$y,$b_12                  # 82e
        frsqest $y,$disc                                # 82o
        fms     $out,$b_14,$b_14,$disc                  # 83e
        lnop                                            # 83o pairing
        fi      $y,$disc,$y                             # 86e
        frsqest $y_8,$disc_18                           # 86o
        cgti    $ahead_7,$t_4,0                         # 87e
        cgt     $control_3,$t_best_12,$t_5              # 88e
        fms     $out_9,$b_13,$b_13,$disc_18             # 89e
        fi      $y_8,$disc_18,$y_8                      # 90e
        cgt     $control_9,$t_best_11,$t_4              # 91e
        cgti    $ahead_8,$t_5,0                         # 92e
        and     $control_14,$control_9,$ahead_7         # 93e
        and     $control_3,$control_3,$ahead_8          # 94e
        andc    $control_15,$control_14,$disc_17        # 95e
        andc    $control_16,$control_3,$disc_11         # 96e
        selb    $s,$whole_4,$out,$m_by_side_4           # 97e
        rotqbii $control_15,$control_15,1               # 97o
        selb    $s_8,$whole_4,$out_9,$m_by_side_4       # 98e
        rotqbii $control_16,$control_16,1               # 98o
        selb    $y,$y,$s,$m_sign                        # 99e
        selb    $y_10,$y_8,$s_8,$m_sign                 # 100e
        fnms    $t_9,$disc,$y,$b_14                     # 101e
        gb      $control_15,$control_15                 # 101o
        fnms    $t_7,$disc_18,$y_10,$b_13               # 102e
        gb      $control_16,$control_16                 # 102o
        shlqbii $control_15,$control_15,4               # 105o
        shlqbii $control_16,$control_16,4               # 106o
        cgti    $ahead_9,$t_9,0                         # 107e
        cgt     $control_17,$t_best_14,$t_9             # 108e
        cgt     $control_14,$t_best_13,$t_7             # 109e
        lqx     $control_15,$control_15,$a_controls     # 109o
        and     $control_18,$control_17,$ahead_9        # 110e
        lqx     $control_16,$control_16,$a_controls     # 110o
        cgti    $ahead_10,$t_7,0                        # 111e
        andc    $control_18,$control_18,$disc           # 112e
        and     $control_17,$control_14,$ahead_10       # 113e
        rotqbii $control_18,$control_18,1               # 114o
        andc    $control_19,$control_17,$disc_18        # 115e
        shufb   $t_best_7,$t_best_11,$t_4,$control_15   # 115o
        shufb   $nearest,$nearest_12,$object,$control_15 # 116o
        rotqbii $control_15,$control_19,1               # 117o
        shufb   $t_best_5,$t_best_12,$t_5,$control_16   # 118o
        shufb   $nearest_16,$nearest_13,$object,$control_16 # 119o
        gb      $control_20,$control_18                 # 120o
        gb      $control_15,$control_15                 # 121o
        stqd    $t_best_7,384($a_packet)                # 122o
        stqd    $t_best_5,400($a_packet)                # 123o
        stqd    $nearest_16,464($a_packet)              # 124o
        shlqbii $control_16,$control_15,4               # 125o
        stqd    $nearest,448($a_packet)                 # 126o
        hbrr    next_ball_short_back,next_ball_short    # 127o hint
        shlqbii $control_15,$control_20,4               # 128o
        lqx     $control_16,$control_16,$a_controls     # 129o
        lqx     $control_15,$control_15,$a_controls     # 132o
        shufb   $nearest,$nearest_14,$object,$control_16 # 135o
        shufb   $t_best,$t_best_13,$t_7,$control_16     # 136o
        shufb   $nearest_16,$nearest_15,$object,$control_15 # 138o
        shufb   $t_best_13,$t_best_14,$t_9,$control_15  # 139o
        stqd    $t_best,432($a_packet)                  # 140o
        stqd    $nearest,496($a_packet)                 # 141o
        stqd    $nearest_16,480($a_packet)              # 142o
        stqd    $t_best_13,416($a_packet)               # 143o
next_ball_short_back:
        brnz    $count,next_ball_short                  # 144o
        nop     $127                                    # 145e pairing
        bi      $lr                                     # 145o
endfunction isect_sphere_pairs_interpolated_r16
