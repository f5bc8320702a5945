# isect_sphere_pairs_paper_r16   nearest hit of packets' rays with spheres, by b^2 - 4ac
#   C       void isect_sphere_pairs_paper_r16(const struct candidate *, int count);
#   In      $3 candidates of objects that are spheres, $4 count (0 is none); pointers 16-aligned
#   Out     the candidates' packets: t, object, where a hit has 0 < t < what was there
#   Uses    $2-$77, $79   Saves  -   Stack  0   Calls  -
#   Domain  |d| = 1 within 4 ulp; coordinates and radius below 2^62, radius above 2^-40; origin up
#           to 3 radii from the centre
#   Error   80 ulp of the larger of t and r, origin up to 3 radii from the centre, ray within 0.995
#           r of it
#   Twin    lab/twins/src/sphere/paper.rs
#
# The steps are in sphere_tmpl.inc. The hit is the entry; with SIDES_EXIT it is the exit, and with
# SIDES_BOTH it is also the exit of a ray from inside.
# Scheduled by spu schedule from isect_sphere_pairs_paper_r16.s

        .include "sphere_general.inc"
        .include "sphere_paper.inc"

        general_registers "k_one", "radius2", "out,y,s,e"
        .set    cc,out                                  # only its sign is used
        sign_controls_table
        sides_tables 0x3f000000, 0x3f800000

function isect_sphere_pairs_paper_r16
        .set count_2,79; .set a_candidate_2,2; .set object_2,5; .set object_3,19; .set a_packet_2,2
        .set quad_2,23; .set sides_2,6; .set ox_2,34; .set dx_2,38; .set cx_2,30; .set radius2_2,32
        .set cy_2,26; .set oy_2,24; .set fx_2,7; .set dx_3,43; .set oy_3,29; .set dy_2,8
        .set dy_3,9; .set fy_2,24; .set oz_2,45; .set b_2,18; .set ox_3,27; .set fy_3,29
        .set oz_3,20; .set cc_2,47; .set ox_4,21; .set cc_3,41; .set dz_2,38; .set b_3,37
        .set dz_3,39; .set fz_2,44; .set oy_4,36; .set fx_3,27; .set dx_4,7; .set fz_3,20
        .set oy_5,28; .set cc_4,22; .set dx_5,34; .set cc_5,31; .set oz_4,33; .set b_4,8
        .set dy_4,24; .set fx_4,21; .set dy_5,30; .set b_5,9; .set oz_5,18; .set cc_6,29
        .set dz_4,35; .set cc_7,37; .set dz_5,40; .set b_6,38; .set a_packet_3,22; .set b_7,7
        .set quad_3,8; .set b_8,34; .set radius2_3,27; .set fy_4,36; .set t_best_2,52; .set fy_5,26
        .set b_9,32; .set ox_5,9; .set cx_3,33; .set disc_2,39; .set cy_3,41; .set fz_4,18
        .set ox_6,23; .set disc_3,44; .set dx_6,46; .set b_10,26; .set y_2,24; .set cz_2,8
        .set y_3,47; .set whole_2,48; .set half_2,7; .set m_by_side_2,25; .set y_4,18; .set dy_6,47
        .set t_best_3,50; .set dx_7,49; .set s_2,20; .set dz_6,51; .set disc_4,53; .set dx_8,54
        .set disc_5,55; .set dy_7,56; .set oz_6,57; .set s_3,35; .set oy_6,58; .set fy_6,28
        .set dy_8,59; .set e_2,24; .set oz_7,60; .set fx_5,23; .set y_5,61; .set fx_6,62
        .set y_6,9; .set b_11,43; .set oz_8,63; .set e_3,18; .set dz_7,64; .set dy_9,65
        .set y_7,66; .set dz_8,67; .set s_4,31; .set t_best_4,9; .set cc_8,68; .set dz_9,69
        .set e_4,70; .set nearest_2,71; .set cc_9,72; .set nearest_3,73; .set s_5,74
        .set sides_3,75; .set s_6,76; .set s_7,5; .set a_packet_4,20; .set fy_7,30
        .set nearest_4,6; .set t_2,77; .set nearest_5,21; .set fy_8,2; .set b_12,5; .set b_13,36
        .set t_3,31; .set fx_7,24; .set e_5,32; .set control_2,33; .set cc_10,28; .set e_6,34
        .set fz_5,43; .set b_14,23; .set b_15,45; .set fy_9,41; .set ahead_2,38; .set cc_11,2
        .set control_3,36; .set cc_12,27; .set control_4,24; .set e_7,7; .set fz_6,32
        .set cc_13,24; .set b_16,28; .set cc_14,33; .set control_5,23; .set fz_7,36; .set s_8,29
        .set fz_8,8; .set control_6,25; .set b_17,30; .set t_4,5; .set cc_15,23; .set disc_6,37
        .set control_7,2; .set b_18,25; .set t_5,7; .set t_best_5,26; .set control_8,29
        .set nearest_6,32; .set t_best_6,28; .set ahead_3,31; .set nearest_7,2; .set ahead_4,33
        .set disc_7,49; .set control_9,31; .set y_8,28; .set control_10,8; .set nearest_8,54
        .set y_9,29; .set y_10,8; .set sides_4,31; .set disc_8,51; .set nearest_9,53; .set s_9,33
        .set half_3,28; .set s_10,39; .set y_11,36; .set whole_3,32; .set e_8,43
        .set control_11,34; .set y_12,31; .set s_11,2; .set t_best_7,5; .set e_9,6; .set s_12,8
        .set e_10,9; .set e_11,5; .set t_6,8; .set ox_7,24; .set ahead_5,26; .set control_12,28
        .set dx_9,29; .set fx_8,30; .set oy_7,39; .set dy_10,44; .set dy_11,38; .set fy_10,39
        .set dy_12,26; .set dy_13,43; .set oz_9,32; .set oz_10,34; .set oz_11,37; .set fz_9,34
        .set fz_10,23; .set dz_10,37; .set dz_11,36; .set t_best_8,41; .set t_best_9,8
        .set nearest_10,29; .set nearest_11,28; .set e_12,2; .set s_13,3; .set nearest_12,4
        .set t_best_10,4; .set control_13,3; .set control_14,6; .set ox_8,2; .set dx_10,5
        .set ox_9,6; .set fx_9,2; .set oy_8,8; .set fx_10,6; .set oy_9,9; .set oy_10,23
        .set dy_14,5; .set oz_12,27; .set cz_3,20; .set fy_11,9; .set oz_13,28; .set ox_10,30
        .set b_19,6; .set dz_12,7; .set fy_12,8; .set dx_11,31; .set fz_11,28; .set dy_15,36
        .set fz_12,5; .set dz_13,9; .set t_best_11,32; .set t_best_12,21; .set t_best_13,22
        .set nearest_13,23; .set t_best_14,7; .set nearest_14,27; .set nearest_15,30; .set b_20,31
        .set cc_16,8; .set b_21,29; .set disc_9,31; .set cc_17,9; .set y_13,20; .set whole_4,24
        .set half_4,29; .set disc_10,33; .set disc_11,34; .set y_14,35; .set s_14,36; .set y_15,37
        .set s_15,38; .set e_13,35; .set s_16,9; .set t_7,2; .set e_14,20; .set t_8,6
        .set control_15,9; .set ahead_6,20; .set control_16,20
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
        rotqbyi $a_packet_2,$object_2,4                 # 19o
        lqd     $quad_2,0($object_2)                    # 20o
        lqd     $sides,32($object_2)                    # 21o
        lqd     $sides_2,32($object_3)                  # 22o
        lqd     $ox,16($a_packet_2)                     # 23o
        lqd     $ox_2,32($a_packet_2)                   # 24o
        lqd     $dx_2,224($a_packet_2)                  # 25o
        shufb   $cx_2,$quad_2,$quad_2,$m_x              # 26o
        shufb   $radius2_2,$sides,$sides,$m_x           # 27o
        shufb   $cy_2,$quad_2,$quad_2,$m_y              # 28o
        lqd     $oy_2,80($a_packet_2)                   # 29o
        fs      $fx_2,$cx_2,$ox_2                       # 30e
        lqd     $dx_3,208($a_packet_2)                  # 30o
        fs      $fx,$cx_2,$ox                           # 31e
        lqd     $oy_3,96($a_packet_2)                   # 31o
        fm      $radius2_2,$radius2_2,$radius2_2        # 32e
        lqd     $dy_2,272($a_packet_2)                  # 32o
        shufb   $cz,$quad_2,$quad_2,$m_z                # 33o
        lqd     $dy_3,288($a_packet_2)                  # 34o
        fs      $fy_2,$cy_2,$oy_2                       # 35e
        lqd     $oz_2,144($a_packet_2)                  # 35o
        fm      $b_2,$fx_2,$dx_2                        # 36e
        lqd     $ox_3,48($a_packet_2)                   # 36o
        fs      $fy_3,$cy_2,$oy_3                       # 37e
        lqd     $oz_3,160($a_packet_2)                  # 37o
        fms     $cc_2,$fx,$fx,$radius2_2                # 38e
        lqd     $ox_4,0($a_packet_2)                    # 38o
        fms     $cc_3,$fx_2,$fx_2,$radius2_2            # 39e
        lqd     $dz_2,336($a_packet_2)                  # 39o
        fm      $b_3,$fx,$dx_3                          # 40e
        lqd     $dz_3,352($a_packet_2)                  # 40o
        fs      $fz_2,$cz,$oz_2                         # 41e
        lqd     $oy_4,64($a_packet_2)                   # 41o
        fs      $fx_3,$cx_2,$ox_3                       # 42e
        lqd     $dx_4,192($a_packet_2)                  # 42o
        fs      $fz_3,$cz,$oz_3                         # 43e
        lqd     $oy_5,112($a_packet_2)                  # 43o
        fma     $cc_4,$fy_2,$fy_2,$cc_2                 # 44e
        lqd     $dx_5,240($a_packet_2)                  # 44o
        fma     $cc_5,$fy_3,$fy_3,$cc_3                 # 45e
        lqd     $oz_4,176($a_packet_2)                  # 45o
        fma     $b_4,$fy_2,$dy_2,$b_3                   # 46e
        lqd     $dy_4,256($a_packet_2)                  # 46o
        fs      $fx_4,$cx_2,$ox_4                       # 47e
        lqd     $dy_5,304($a_packet_2)                  # 47o
        fma     $b_5,$fy_3,$dy_3,$b_2                   # 48e
        lqd     $oz_5,128($a_packet_2)                  # 48o
        fms     $cc_6,$fx_3,$fx_3,$radius2_2            # 49e
        lqd     $dz_4,368($a_packet_2)                  # 49o
        fma     $cc_7,$fz_2,$fz_2,$cc_4                 # 50e
        lqd     $dz_5,320($a_packet_2)                  # 50o
        fma     $cc_5,$fz_3,$fz_3,$cc_5                 # 51e
        rotqbyi $sides,$sides,12                        # 51o
        fma     $b_6,$fz_2,$dz_2,$b_4                   # 52e
        rotqbyi $a_packet_3,$object_3,4                 # 52o
        fm      $b_7,$fx_4,$dx_4                        # 53e
        lqd     $quad_3,0($object_3)                    # 53o
        fm      $b_8,$fx_3,$dx_5                        # 54e
        shufb   $radius2_3,$sides_2,$sides_2,$m_x       # 54o
        fs      $fy_4,$cy_2,$oy_4                       # 55e
        lqd     $t_best_2,400($a_packet_2)              # 55o
        fms     $cc,$fx_4,$fx_4,$radius2_2              # 56e
        lqd     $ox_4,16($a_packet_3)                   # 56o
        fs      $fy_5,$cy_2,$oy_5                       # 57e
        lqd     $oy_5,80($a_packet_3)                   # 57o
        fma     $b_9,$fz_3,$dz_3,$b_5                   # 58e
        lqd     $ox_5,32($a_packet_3)                   # 58o
        fs      $fz_3,$cz,$oz_4                         # 59e
        shufb   $cx_3,$quad_3,$quad_3,$m_x              # 59o
        fms     $disc_2,$b_6,$b_6,$cc_7                 # 60e
        shufb   $cy_3,$quad_3,$quad_3,$m_y              # 60o
        fs      $fz_4,$cz,$oz_5                         # 61e
        lqd     $ox_6,0($a_packet_3)                    # 61o
        fma     $cc,$fy_4,$fy_4,$cc                     # 62e
        lqd     $dx_3,208($a_packet_3)                  # 62o
        fma     $cc_6,$fy_5,$fy_5,$cc_6                 # 63e
        lqd     $oz_2,144($a_packet_3)                  # 63o
        fms     $disc_3,$b_9,$b_9,$cc_5                 # 64e
        lqd     $dx_6,192($a_packet_3)                  # 64o
        fma     $b_10,$fy_5,$dy_5,$b_8                  # 65e
        lqd     $oy,64($a_packet_3)                     # 65o
        fma     $b_7,$fy_4,$dy_4,$b_7                   # 66e
        frsqest $y_2,$disc_2                            # 66o
        rotmi   $sides,$sides,-26                       # 67e
        shufb   $cz_2,$quad_3,$quad_3,$m_z              # 67o
        fma     $cc,$fz_4,$fz_4,$cc                     # 68e
        lqd     $ox_2,48($a_packet_3)                   # 68o
        fma     $cc_6,$fz_3,$fz_3,$cc_6                 # 69e
        lqd     $oy_4,96($a_packet_3)                   # 69o
        fi      $y_2,$disc_2,$y_2                       # 70e
        frsqest $y_3,$disc_3                            # 70o
        nop     $127                                    # 71e pairing
        lqx     $whole_2,$a_whole,$sides                # 71o
        fma     $b,$fz_4,$dz_5,$b_7                     # 72e
        lqx     $half_2,$a_half,$sides                  # 72o
        fma     $b_10,$fz_3,$dz_4,$b_10                 # 73e
        lqx     $m_by_side_2,$a_by_side,$sides          # 73o
        fi      $y_4,$disc_3,$y_3                       # 74e
        lqd     $dy_6,272($a_packet_3)                  # 74o
        nop     $127                                    # 75e pairing
        lqd     $t_best_3,416($a_packet_2)              # 75o
        fm      $radius2_3,$radius2_3,$radius2_3        # 76e
        lqd     $dx_7,224($a_packet_3)                  # 76o
        fm      $s_2,$disc_2,$y_2                       # 77e
        lqd     $dz_6,336($a_packet_3)                  # 77o
        fms     $disc_4,$b,$b,$cc                       # 78e
        lqd     $dx_8,240($a_packet_3)                  # 78o
        fms     $disc_5,$b_10,$b_10,$cc_6               # 79e
        lqd     $dy_7,256($a_packet_3)                  # 79o
        fs      $fx_4,$cx_3,$ox_4                       # 80e
        lqd     $oz_6,128($a_packet_3)                  # 80o
        fm      $s_3,$disc_3,$y_4                       # 81e
        lqd     $oy_6,112($a_packet_3)                  # 81o
        fs      $fy_6,$cy_3,$oy_5                       # 82e
        lqd     $dy_8,288($a_packet_3)                  # 82o
        fnms    $e_2,$s_2,$y_2,$k_one                   # 83e
        lqd     $oz_7,160($a_packet_3)                  # 83o
        fs      $fx_5,$cx_3,$ox_6                       # 84e
        frsqest $y_5,$disc_4                            # 84o
        fs      $fx_6,$cx_3,$ox_5                       # 85e
        frsqest $y_6,$disc_5                            # 85o
        fm      $b_11,$fx_4,$dx_3                       # 86e
        lqd     $oz_8,176($a_packet_3)                  # 86o
        fnms    $e_3,$s_3,$y_4,$k_one                   # 87e
        lqd     $dz_7,320($a_packet_3)                  # 87o
        fi      $y_5,$disc_4,$y_5                       # 88e
        lqd     $dy_9,304($a_packet_3)                  # 88o
        fi      $y_7,$disc_5,$y_6                       # 89e
        lqd     $dz_8,352($a_packet_3)                  # 89o
        selb    $s_4,$s_3,$cc_5,$m_by_side_2            # 90e
        lqd     $t_best_4,432($a_packet_2)              # 90o
        fma     $e_2,$e_2,$half_2,$whole_2              # 91e
        lqd     $t_best,384($a_packet_2)                # 91o
        fms     $cc_8,$fx_6,$fx_6,$radius2_3            # 92e
        lqd     $dz_9,368($a_packet_3)                  # 92o
        fma     $e_4,$e_3,$half_2,$whole_2              # 93e
        lqd     $nearest_2,480($a_packet_2)             # 93o
        fms     $cc_9,$fx_4,$fx_4,$radius2_3            # 94e
        lqd     $nearest_3,464($a_packet_2)             # 94o
        fm      $s_5,$disc_4,$y_5                       # 95e
        rotqbyi $sides_3,$sides_2,12                    # 95o
        fm      $s_6,$disc_5,$y_7                       # 96e
        shufb   $object,$object_2,$object_2,$m_x        # 96o
        selb    $s_7,$s_2,$cc_7,$m_by_side_2            # 97e
        shlqbyi $a_packet_4,$a_packet_2,0               # 97o copy
        fs      $fy_7,$cy_3,$oy                         # 98e
        lqd     $nearest_4,448($a_packet_2)             # 98o
        fnms    $t_2,$s_7,$e_2,$b_6                     # 99e
        lqd     $nearest_5,496($a_packet_2)             # 99o
        fs      $fy_8,$cy_3,$oy_4                       # 100e
        fm      $b_12,$fx_6,$dx_7                       # 101e
        fma     $b_13,$fy_6,$dy_6,$b_11                 # 102e
        fnms    $t_3,$s_4,$e_4,$b_9                     # 103e
        fs      $fx_7,$cx_3,$ox_2                       # 104e
        fnms    $e_5,$s_5,$y_5,$k_one                   # 105e
        cgt     $control_2,$t_best_2,$t_2               # 106e
        fma     $cc_10,$fy_6,$fy_6,$cc_9                # 107e
        fnms    $e_6,$s_6,$y_7,$k_one                   # 108e
        fms     $cc_7,$fx_5,$fx_5,$radius2_3            # 109e
        fs      $fz_5,$cz_2,$oz_2                       # 110e
        cgti    $ahead,$t_3,0                           # 111e
        fm      $b_14,$fx_5,$dx_6                       # 112e
        fm      $b_15,$fx_7,$dx_8                       # 113e
        fs      $fy_9,$cy_3,$oy_6                       # 114e
        cgti    $ahead_2,$t_2,0                         # 115e
        fma     $b_12,$fy_8,$dy_8,$b_12                 # 116e
        and     $control_2,$control_2,$ahead_2          # 117e
        fma     $cc_11,$fy_8,$fy_8,$cc_8                # 118e
        fma     $b_6,$fz_5,$dz_6,$b_13                  # 119e
        fma     $e_6,$e_6,$half_2,$whole_2              # 120e
        cgt     $control_3,$t_best_3,$t_3               # 121e
        andc    $control_2,$control_2,$disc_2           # 122e
        and     $control_3,$control_3,$ahead            # 123e
        fms     $cc_12,$fx_7,$fx_7,$radius2_3           # 124e
        rotqbii $control_2,$control_2,1                 # 124o
        andc    $control_4,$control_3,$disc_3           # 125e
        fma     $e_7,$e_5,$half_2,$whole_2              # 126e
        fs      $fz_6,$cz_2,$oz_7                       # 127e
        rotqbii $control_3,$control_4,1                 # 127o
        fma     $cc_13,$fz_5,$fz_5,$cc_10               # 128e
        gb      $control,$control_2                     # 128o
        fma     $b_16,$fy_7,$dy_7,$b_14                 # 129e
        fma     $cc_14,$fy_7,$fy_7,$cc_7                # 130e
        fma     $cc_12,$fy_9,$fy_9,$cc_12               # 131e
        gb      $control_5,$control_3                   # 131o
        fs      $fz_7,$cz_2,$oz_6                       # 132e
        shlqbii $control,$control,4                     # 132o
        selb    $s_8,$s_6,$cc_6,$m_by_side_2            # 133e
        selb    $s,$s_5,$cc,$m_by_side_2                # 134e
        fs      $fz_8,$cz_2,$oz_8                       # 135e
        shlqbii $control_6,$control_5,4                 # 135o
        fma     $b_17,$fz_6,$dz_8,$b_12                 # 136e
        lqx     $control,$control,$a_controls           # 136o
        fnms    $t_4,$s,$e_7,$b                         # 137e
        fma     $cc_15,$fz_6,$fz_6,$cc_11               # 138e
        fms     $disc_6,$b_6,$b_6,$cc_13                # 139e
        lqx     $control_7,$control_6,$a_controls       # 139o
        fma     $b_18,$fy_9,$dy_9,$b_15                 # 140e
        fma     $cc,$fz_7,$fz_7,$cc_14                  # 141e
        fnms    $t_5,$s_8,$e_6,$b_10                    # 142e
        shufb   $t_best_5,$t_best_2,$t_2,$control       # 142o
        cgt     $control_8,$t_best,$t_4                 # 143e
        shufb   $nearest_6,$nearest_3,$object,$control  # 143o
        fma     $b,$fz_7,$dz_7,$b_16                    # 144e
        lnop                                            # 144o pairing
        fms     $disc,$b_17,$b_17,$cc_15                # 145e
        frsqest $y,$disc_6                              # 145o
        fma     $cc_12,$fz_8,$fz_8,$cc_12               # 146e
        shufb   $t_best_6,$t_best_3,$t_3,$control_7     # 146o
        cgti    $ahead_3,$t_4,0                         # 147e
        shufb   $nearest_7,$nearest_2,$object,$control_7 # 147o
        cgti    $ahead_4,$t_5,0                         # 148e
        stqd    $t_best_5,400($a_packet_4)              # 148o
        and     $control_8,$control_8,$ahead_3          # 149e
        lnop                                            # 149o pairing
        fms     $disc_7,$b,$b,$cc                       # 150e
        stqd    $t_best_6,416($a_packet_4)              # 150o
        cgt     $control_9,$t_best_4,$t_5               # 151e
        frsqest $y_8,$disc                              # 151o
        fma     $b_10,$fz_8,$dz_9,$b_18                 # 152e
        stqd    $nearest_6,464($a_packet_4)             # 152o
        and     $control_10,$control_9,$ahead_4         # 153e
        stqd    $nearest_7,480($a_packet_4)             # 153o
        andc    $control,$control_8,$disc_4             # 154e
        lqd     $t_best_2,400($a_packet_3)              # 154o
        andc    $control_7,$control_10,$disc_5          # 155e
        lqd     $nearest_8,480($a_packet_3)             # 155o
        fi      $y,$disc_6,$y                           # 156e
        frsqest $y_9,$disc_7                            # 156o
        fi      $y_10,$disc,$y_8                        # 157e
        rotqbii $control,$control,1                     # 157o
        rotmi   $sides_4,$sides_3,-26                   # 158e
        rotqbii $control_7,$control_7,1                 # 158o
        fms     $disc_8,$b_10,$b_10,$cc_12              # 159e
        lqd     $nearest_9,464($a_packet_3)             # 159o
        fi      $y_9,$disc_7,$y_9                       # 160e
        lqd     $t_best_3,416($a_packet_3)              # 160o
        gb      $control,$control                       # 161o
        gb      $control_7,$control_7                   # 162o
        fm      $s,$disc_6,$y                           # 163e
        lqx     $m_by_side_2,$a_by_side,$sides_4        # 163o
        fm      $s_9,$disc,$y_10                        # 164e
        lqx     $half_3,$a_half,$sides_4                # 164o
        shlqbii $control,$control,4                     # 165o
        shlqbii $control_7,$control_7,4                 # 166o
        fm      $s_10,$disc_7,$y_9                      # 167e
        frsqest $y_11,$disc_8                           # 167o
        nop     $127                                    # 168e pairing
        lqx     $whole_3,$a_whole,$sides_4              # 168o
        fnms    $e_8,$s,$y,$k_one                       # 169e
        lqx     $control,$control,$a_controls           # 169o
        lqx     $control_11,$control_7,$a_controls      # 170o
        fi      $y_12,$disc_8,$y_11                     # 171e
next_ball:
            selb    $s,$s,$cc_13,$m_by_side_2           # 0e
            shufb   $t_best,$t_best,$t_4,$control       # 0o
            fm      $s_11,$disc_8,$y_12                 # 1e
            shufb   $nearest,$nearest_4,$object,$control # 1o
        ai      $count,$count,-1                        # 2e
        lnop                                            # 2o pairing
            fnms    $e,$s_9,$y_10,$k_one                # 3e
            shufb   $t_best_7,$t_best_4,$t_5,$control_11 # 3o
            fnms    $e_9,$s_10,$y_9,$k_one              # 4e
            stqd    $t_best,384($a_packet_4)            # 4o
            fma     $e_7,$e_8,$half_3,$whole_3          # 5e
            lqd     $t_best,384($a_packet_3)            # 5o
            selb    $s_12,$s_9,$cc_15,$m_by_side_2      # 6e
            stqd    $nearest,448($a_packet_4)           # 6o
            fnms    $e_10,$s_11,$y_12,$k_one            # 7e
            stqd    $t_best_7,432($a_packet_4)          # 7o
            selb    $s_11,$s_11,$cc_12,$m_by_side_2     # 8e
            shufb   $nearest,$nearest_5,$object,$control_11 # 8o
            fma     $e,$e,$half_3,$whole_3              # 9e
            shufb   $object,$object_3,$object_3,$m_x    # 9o
            fma     $e_11,$e_9,$half_3,$whole_3         # 10e
        lqd     $object_3,0($a_candidate)               # 10o
            fnms    $t,$s,$e_7,$b_6                     # 11e
            lqd     $nearest_4,448($a_packet_3)         # 11o
            selb    $s,$s_10,$cc,$m_by_side_2           # 12e
            stqd    $nearest,496($a_packet_4)           # 12o
            fma     $e_7,$e_10,$half_3,$whole_3         # 13e
            lqd     $t_best_4,432($a_packet_3)          # 13o
        ai      $a_candidate,$a_candidate,16            # 14e
            shlqbyi $a_packet_4,$a_packet_3,0           # 14o copy
            fnms    $t_6,$s_12,$e,$b_17                 # 15e
            lqd     $nearest_5,496($a_packet_3)         # 15o
            fnms    $t_4,$s,$e_11,$b                    # 16e
        rotqbyi $a_packet_3,$object_3,4                 # 16o
            cgti    $ahead,$t,0                         # 17e
            lnop                                        # 17o pairing
            cgt     $control,$t_best_2,$t               # 18e
        lqd     $quad_2,0($object_3)                    # 18o
            fnms    $t_5,$s_11,$e_7,$b_10               # 19e
        lqd     $sides,32($object_3)                    # 19o
            and     $control,$control,$ahead            # 20e
            lnop                                        # 20o pairing
            cgti    $ahead,$t_6,0                       # 21e
        lqd     $ox,16($a_packet_3)                     # 21o
            cgt     $control_7,$t_best,$t_4             # 22e
        lqd     $ox_7,0($a_packet_3)                    # 22o
            cgti    $ahead_5,$t_4,0                     # 23e
        lqd     $ox_3,48($a_packet_3)                   # 23o
            cgt     $control_12,$t_best_3,$t_6          # 24e
        shufb   $cx_2,$quad_2,$quad_2,$m_x              # 24o
            cgt     $control_9,$t_best_4,$t_5           # 25e
        shufb   $radius2_2,$sides,$sides,$m_x           # 25o
            cgti    $ahead_4,$t_5,0                     # 26e
        lqd     $ox_2,32($a_packet_3)                   # 26o
            andc    $control,$control,$disc_6           # 27e
        fs      $fx,$cx_2,$ox                           # 28e
        fs      $fx_7,$cx_2,$ox_7                       # 29e
        lqd     $dx_9,192($a_packet_3)                  # 29o
        fm      $radius2_2,$radius2_2,$radius2_2        # 30e
        lnop                                            # 30o pairing
        fs      $fx_3,$cx_2,$ox_3                       # 31e
        lqd     $oy_4,64($a_packet_3)                   # 31o
        fs      $fx_8,$cx_2,$ox_2                       # 32e
        lqd     $dx_5,240($a_packet_3)                  # 32o
            and     $control_12,$control_12,$ahead      # 33e
        lqd     $dx_2,224($a_packet_3)                  # 33o
            and     $control_7,$control_7,$ahead_5      # 34e
        shufb   $cy_2,$quad_2,$quad_2,$m_y              # 34o
        fm      $b,$fx_7,$dx_9                          # 35e
        lqd     $oy_3,96($a_packet_3)                   # 35o
            andc    $control_12,$control_12,$disc       # 36e
        lqd     $oy_7,112($a_packet_3)                  # 36o
        fms     $cc,$fx_7,$fx_7,$radius2_2              # 37e
        lqd     $oy_2,80($a_packet_3)                   # 37o
        fm      $b_8,$fx_3,$dx_5                        # 38e
        shufb   $cz,$quad_2,$quad_2,$m_z                # 38o
        fms     $cc_3,$fx_8,$fx_8,$radius2_2            # 39e
        lqd     $dx_3,208($a_packet_3)                  # 39o
        fs      $fy_4,$cy_2,$oy_4                       # 40e
        rotqbyi $sides,$sides,12                        # 40o
        fs      $fy_3,$cy_2,$oy_3                       # 41e
        lqd     $dy_10,256($a_packet_3)                 # 41o
        fm      $b_17,$fx_8,$dx_2                       # 42e
        lqd     $dy_11,272($a_packet_3)                 # 42o
        fs      $fy_10,$cy_2,$oy_7                      # 43e
        lqd     $oz_2,144($a_packet_3)                  # 43o
        fs      $fy_2,$cy_2,$oy_2                       # 44e
        lqd     $dy_12,304($a_packet_3)                 # 44o
        fms     $cc_2,$fx,$fx,$radius2_2                # 45e
            rotqbii $control,$control,1                 # 45o
        fm      $b_3,$fx,$dx_3                          # 46e
            rotqbii $control_12,$control_12,1           # 46o
        fma     $b,$fy_4,$dy_10,$b                      # 47e
        lqd     $dy_13,288($a_packet_3)                 # 47o
        fms     $cc_12,$fx_3,$fx_3,$radius2_2           # 48e
        lqd     $oz_9,176($a_packet_3)                  # 48o
        fs      $fz_2,$cz,$oz_2                         # 49e
            gb      $control,$control                   # 49o
        fma     $cc,$fy_4,$fy_4,$cc                     # 50e
            gb      $control_12,$control_12             # 50o
        fma     $b_10,$fy_10,$dy_12,$b_8                # 51e
        lqd     $oz_10,128($a_packet_3)                 # 51o
        fma     $b_13,$fy_2,$dy_11,$b_3                 # 52e
        lqd     $oz_11,160($a_packet_3)                 # 52o
        fma     $cc_13,$fy_2,$fy_2,$cc_2                # 53e
            shlqbii $control,$control,4                 # 53o
        fma     $b_17,$fy_3,$dy_13,$b_17                # 54e
            shlqbii $control_12,$control_12,4           # 54o
        fs      $fz_6,$cz,$oz_9                         # 55e
        lqd     $dz_2,336($a_packet_3)                  # 55o
        fma     $cc_12,$fy_10,$fy_10,$cc_12             # 56e
        lqd     $dz_3,352($a_packet_3)                  # 56o
        fs      $fz_9,$cz,$oz_10                        # 57e
            lqx     $control,$control,$a_controls       # 57o
        fs      $fz_10,$cz,$oz_11                       # 58e
            lqx     $control_12,$control_12,$a_controls # 58o
        fma     $cc_6,$fy_3,$fy_3,$cc_3                 # 59e
        lnop                                            # 59o pairing
        fma     $cc_13,$fz_2,$fz_2,$cc_13               # 60e
        lqd     $dz_10,320($a_packet_3)                 # 60o
        fma     $b_6,$fz_2,$dz_2,$b_13                  # 61e
        lnop                                            # 61o pairing
        fma     $cc_12,$fz_6,$fz_6,$cc_12               # 62e
        lqd     $dz_11,368($a_packet_3)                 # 62o
        fma     $cc,$fz_9,$fz_9,$cc                     # 63e
            shufb   $t_best_8,$t_best_2,$t,$control     # 63o
        fma     $b_17,$fz_10,$dz_3,$b_17                # 64e
            shufb   $t_best_9,$t_best_3,$t_6,$control_12 # 64o
        fma     $cc_15,$fz_10,$fz_10,$cc_6              # 65e
            shufb   $nearest_10,$nearest_9,$object,$control # 65o
        fma     $b,$fz_9,$dz_10,$b                      # 66e
            shufb   $nearest_11,$nearest_8,$object,$control_12 # 66o
        fms     $disc_6,$b_6,$b_6,$cc_13                # 67e
            stqd    $t_best_8,400($a_packet_4)          # 67o
        fma     $b_10,$fz_6,$dz_11,$b_10                # 68e
            stqd    $t_best_9,416($a_packet_4)          # 68o
            andc    $control,$control_7,$disc_7         # 69e
            stqd    $nearest_10,464($a_packet_4)        # 69o
        rotmi   $sides,$sides,-26                       # 70e
            stqd    $nearest_11,480($a_packet_4)        # 70o
        fms     $disc,$b_17,$b_17,$cc_15                # 71e
            rotqbii $control,$control,1                 # 71o
        fms     $disc_7,$b,$b,$cc                       # 72e
        hbrr    next_ball_back,next_ball                # 72o hint
            and     $control_7,$control_9,$ahead_4      # 73e
        frsqest $y,$disc_6                              # 73o
        nop     $127                                    # 74e pairing
        lqd     $t_best_3,416($a_packet_3)              # 74o
            andc    $control_7,$control_7,$disc_8       # 75e
            gb      $control,$control                   # 75o
        fms     $disc_8,$b_10,$b_10,$cc_12              # 76e
        lqx     $half_3,$a_half,$sides                  # 76o
        fi      $y,$disc_6,$y                           # 77e
            rotqbii $control_7,$control_7,1             # 77o
        frsqest $y_10,$disc                             # 78o
        frsqest $y_9,$disc_7                            # 79o
            shlqbii $control,$control,4                 # 80o
            gb      $control_7,$control_7               # 81o
        fi      $y_10,$disc,$y_10                       # 82e
        frsqest $y_12,$disc_8                           # 82o
        fi      $y_9,$disc_7,$y_9                       # 83e
        lqx     $whole_3,$a_whole,$sides                # 83o
        nop     $127                                    # 84e pairing
        lqx     $m_by_side_2,$a_by_side,$sides          # 84o
        fm      $s,$disc_6,$y                           # 85e
            shlqbii $control_7,$control_7,4             # 85o
        fi      $y_12,$disc_8,$y_12                     # 86e
            lqx     $control,$control,$a_controls       # 86o
        lqd     $t_best_2,400($a_packet_3)              # 87o
        lqd     $nearest_9,464($a_packet_3)             # 88o
        fm      $s_9,$disc,$y_10                        # 89e
            lqx     $control_11,$control_7,$a_controls  # 89o
        fm      $s_10,$disc_7,$y_9                      # 90e
        lqd     $nearest_8,480($a_packet_3)             # 90o
        fnms    $e_8,$s,$y,$k_one                       # 91e
next_ball_back:
        brnz    $count,next_ball                        # 91o
next_ball_drain:
        fnms    $e,$s_9,$y_10,$k_one                    # 0e
        shufb   $t_best,$t_best,$t_4,$control           # 0o
        fma     $e_12,$e_8,$half_3,$whole_3             # 1e
        shufb   $nearest,$nearest_4,$object,$control    # 1o
        selb    $s,$s,$cc_13,$m_by_side_2               # 2e
        shufb   $t_best_7,$t_best_4,$t_5,$control_11    # 2o
        fm      $s_13,$disc_8,$y_12                     # 3e
        shufb   $nearest_12,$nearest_5,$object,$control_11 # 3o
        selb    $s_12,$s_9,$cc_15,$m_by_side_2          # 4e
        stqd    $t_best,384($a_packet_4)                # 4o
        fnms    $e_9,$s_10,$y_9,$k_one                  # 5e
        lqd     $t_best,384($a_packet_3)                # 5o
        fma     $e,$e,$half_3,$whole_3                  # 6e
        stqd    $nearest,448($a_packet_4)               # 6o
        fnms    $t,$s,$e_12,$b_6                        # 7e
        stqd    $t_best_7,432($a_packet_4)              # 7o
        selb    $s,$s_10,$cc,$m_by_side_2               # 8e
        lqd     $nearest_7,448($a_packet_3)             # 8o
        fnms    $e_10,$s_13,$y_12,$k_one                # 9e
        stqd    $nearest_12,496($a_packet_4)            # 9o
        selb    $s_13,$s_13,$cc_12,$m_by_side_2         # 10e
        lqd     $t_best_10,432($a_packet_3)             # 10o
        fma     $e_11,$e_9,$half_3,$whole_3             # 11e
        shufb   $object,$object_3,$object_3,$m_x        # 11o
        fnms    $t_6,$s_12,$e,$b_17                     # 12e
        shlqbyi $a_packet_4,$a_packet_3,0               # 12o copy
        cgti    $ahead,$t,0                             # 13e
        lqd     $nearest_5,496($a_packet_3)             # 13o
        cgt     $control,$t_best_2,$t                   # 14e
        hbr     isect_sphere_pairs_paper_r16_return,$lr # 14o hint
        fma     $e_7,$e_10,$half_3,$whole_3             # 15e
        and     $control,$control,$ahead                # 16e
        fnms    $t_4,$s,$e_11,$b                        # 17e
        cgti    $ahead,$t_6,0                           # 18e
        cgt     $control_12,$t_best_3,$t_6              # 19e
        andc    $control,$control,$disc_6               # 20e
        and     $control_12,$control_12,$ahead          # 21e
        lnop                                            # 21o pairing
        fnms    $t_5,$s_13,$e_7,$b_10                   # 22e
        rotqbii $control,$control,1                     # 22o
        andc    $control_12,$control_12,$disc           # 23e
        cgt     $control_13,$t_best,$t_4                # 24e
        cgti    $ahead_5,$t_4,0                         # 25e
        rotqbii $control_12,$control_12,1               # 25o
        gb      $control,$control                       # 26o
        and     $control_13,$control_13,$ahead_5        # 27e
        cgt     $control_9,$t_best_10,$t_5              # 28e
        lnop                                            # 28o pairing
        cgti    $ahead_4,$t_5,0                         # 29e
        gb      $control_12,$control_12                 # 29o
        andc    $control_13,$control_13,$disc_7         # 30e
        shlqbii $control,$control,4                     # 30o
        and     $control_14,$control_9,$ahead_4         # 31e
        rotqbii $control_13,$control_13,1               # 32o
        andc    $control_14,$control_14,$disc_8         # 33e
        shlqbii $control_12,$control_12,4               # 33o
        lqx     $control,$control,$a_controls           # 34o
        rotqbii $control_14,$control_14,1               # 35o
        gb      $control_13,$control_13                 # 36o
        lqx     $control_12,$control_12,$a_controls     # 37o
        gb      $control_14,$control_14                 # 39o
        shufb   $t_best_8,$t_best_2,$t,$control         # 40o
        shufb   $nearest_10,$nearest_9,$object,$control # 41o
        shlqbii $control,$control_13,4                  # 42o
        shufb   $t_best_9,$t_best_3,$t_6,$control_12    # 43o
        shufb   $nearest_11,$nearest_8,$object,$control_12 # 44o
        stqd    $t_best_8,400($a_packet_4)              # 45o
        shlqbii $control_13,$control_14,4               # 46o
        stqd    $t_best_9,416($a_packet_4)              # 47o
        stqd    $nearest_10,464($a_packet_4)            # 48o
        stqd    $nearest_11,480($a_packet_4)            # 49o
        lqx     $control,$control,$a_controls           # 50o
        lqx     $control_11,$control_13,$a_controls     # 51o
        shufb   $t_best,$t_best,$t_4,$control           # 56o
        shufb   $nearest,$nearest_7,$object,$control    # 57o
        shufb   $t_best_7,$t_best_10,$t_5,$control_11   # 58o
        shufb   $nearest_7,$nearest_5,$object,$control_11 # 59o
        stqd    $t_best,384($a_packet_4)                # 60o
        stqd    $nearest,448($a_packet_4)               # 61o
        stqd    $t_best_7,432($a_packet_4)              # 62o
        stqd    $nearest_7,496($a_packet_4)             # 63o
isect_sphere_pairs_paper_r16_return:
        bi      $lr                                     # 64o
next_ball_short:
        ai      $count,$count,-1                        # 0e
        lqd     $object,0($a_candidate)                 # 0o
        ai      $a_candidate,$a_candidate,16            # 1e
        rotqbyi $a_packet,$object,4                     # 6o
        lqd     $sides,32($object)                      # 7o
        lqd     $quad,0($object)                        # 8o
        shufb   $object,$object,$object,$m_x            # 9o
        lqd     $ox,0($a_packet)                        # 10o
        lqd     $ox_8,16($a_packet)                     # 11o
        lqd     $dx,208($a_packet)                      # 12o
        shufb   $radius2,$sides,$sides,$m_x             # 13o
        shufb   $cx,$quad,$quad,$m_x                    # 14o
        lqd     $dx_10,192($a_packet)                   # 15o
        lqd     $dy,272($a_packet)                      # 16o
        fm      $radius2,$radius2,$radius2              # 17e
        lqd     $ox_9,48($a_packet)                     # 17o
        fs      $fx,$cx,$ox                             # 18e
        shufb   $cy,$quad,$quad,$m_y                    # 18o
        fs      $fx_9,$cx,$ox_8                         # 19e
        lqd     $oz,144($a_packet)                      # 19o
        lqd     $oy,80($a_packet)                       # 20o
        lqd     $dx_4,240($a_packet)                    # 21o
        nop     $127                                    # 22e pairing
        lqd     $oy_8,112($a_packet)                    # 22o
        fs      $fx_10,$cx,$ox_9                        # 23e
        lqd     $oy_9,64($a_packet)                     # 23o
        fms     $cc,$fx,$fx,$radius2                    # 24e
        lqd     $oy_10,96($a_packet)                    # 24o
        fm      $b,$fx,$dx_10                           # 25e
        lqd     $dy_14,256($a_packet)                   # 25o
        fm      $b_10,$fx_9,$dx                         # 26e
        lqd     $dz,336($a_packet)                      # 26o
        fms     $cc_11,$fx_9,$fx_9,$radius2             # 27e
        lqd     $oz_12,176($a_packet)                   # 27o
        fs      $fy,$cy,$oy                             # 28e
        shufb   $cz_3,$quad,$quad,$m_z                  # 28o
        fs      $fy_11,$cy,$oy_9                        # 29e
        lqd     $oz_13,128($a_packet)                   # 29o
        fms     $cc_6,$fx_10,$fx_10,$radius2            # 30e
        lqd     $ox_10,32($a_packet)                    # 30o
        fm      $b_19,$fx_10,$dx_4                      # 31e
        lqd     $dz_12,320($a_packet)                   # 31o
        fs      $fy_12,$cy,$oy_8                        # 32e
        lqd     $oz_9,160($a_packet)                    # 32o
        fs      $fz,$cz_3,$oz                           # 33e
        lqd     $dx_11,224($a_packet)                   # 33o
        fma     $b_10,$fy,$dy,$b_10                     # 34e
        lqd     $dy,288($a_packet)                      # 34o
        fs      $fz_11,$cz_3,$oz_13                     # 35e
        lqd     $dz_4,352($a_packet)                    # 35o
        fma     $cc,$fy_11,$fy_11,$cc                   # 36e
        lqd     $dy_15,304($a_packet)                   # 36o
        fma     $b,$fy_11,$dy_14,$b                     # 37e
        rotqbyi $sides,$sides,12                        # 37o
        fs      $fz_12,$cz_3,$oz_9                      # 38e
        lqd     $dz_13,368($a_packet)                   # 38o
        fma     $cc_11,$fy,$fy,$cc_11                   # 39e
        lqd     $t_best_11,400($a_packet)               # 39o
        fs      $fx,$cx,$ox_10                          # 40e
        lqd     $t_best_12,416($a_packet)               # 40o
        fs      $fy,$cy,$oy_10                          # 41e
        lqd     $t_best_13,384($a_packet)               # 41o
        fs      $fz_3,$cz_3,$oz_12                      # 42e
        lqd     $nearest_13,448($a_packet)              # 42o
        fma     $b,$fz_11,$dz_12,$b                     # 43e
        lqd     $t_best_14,432($a_packet)               # 43o
        fma     $b_10,$fz,$dz,$b_10                     # 44e
        lqd     $nearest_14,464($a_packet)              # 44o
        fma     $cc,$fz_11,$fz_11,$cc                   # 45e
        lqd     $nearest_11,496($a_packet)              # 45o
        fms     $cc_13,$fx,$fx,$radius2                 # 46e
        lqd     $nearest_15,480($a_packet)              # 46o
        fm      $b_20,$fx,$dx_11                        # 47e
        fma     $cc_11,$fz,$fz,$cc_11                   # 48e
        fma     $b_19,$fy_12,$dy_15,$b_19               # 49e
        fma     $cc_16,$fy_12,$fy_12,$cc_6              # 50e
        fms     $disc,$b,$b,$cc                         # 51e
        fma     $cc_13,$fy,$fy,$cc_13                   # 52e
        fma     $b_21,$fy,$dy,$b_20                     # 53e
        fms     $disc_9,$b_10,$b_10,$cc_11              # 54e
        fma     $b_19,$fz_3,$dz_13,$b_19                # 55e
        fma     $cc_16,$fz_3,$fz_3,$cc_16               # 56e
        rotmi   $sides,$sides,-26                       # 57e
        frsqest $y,$disc                                # 57o
        fma     $cc_17,$fz_12,$fz_12,$cc_13             # 58e
        fma     $b_12,$fz_12,$dz_4,$b_21                # 59e
        nop     $127                                    # 60e pairing
        frsqest $y_13,$disc_9                           # 60o
        fi      $y,$disc,$y                             # 61e
        lqx     $whole_4,$a_whole,$sides                # 61o
        nop     $127                                    # 62e pairing
        lqx     $half_4,$a_half,$sides                  # 62o
        fms     $disc_10,$b_19,$b_19,$cc_16             # 63e
        lqx     $m_by_side_2,$a_by_side,$sides          # 63o
        fi      $y_13,$disc_9,$y_13                     # 64e
        fms     $disc_11,$b_12,$b_12,$cc_17             # 66e
        fm      $s,$disc,$y                             # 68e
        frsqest $y_14,$disc_10                          # 69o
        fm      $s_14,$disc_9,$y_13                     # 71e
        frsqest $y_15,$disc_11                          # 72o
        fi      $y_14,$disc_10,$y_14                    # 73e
        selb    $s_15,$s,$cc,$m_by_side_2               # 74e
        fnms    $e,$s,$y,$k_one                         # 75e
        fi      $y,$disc_11,$y_15                       # 76e
        selb    $s,$s_14,$cc_11,$m_by_side_2            # 77e
        fnms    $e_12,$s_14,$y_13,$k_one                # 78e
        fm      $s_2,$disc_10,$y_14                     # 80e
        fma     $e,$e,$half_4,$whole_4                  # 81e
        fm      $s_14,$disc_11,$y                       # 83e
        fma     $e_12,$e_12,$half_4,$whole_4            # 84e
        fnms    $e_13,$s_2,$y_14,$k_one                 # 86e
        fnms    $t,$s_15,$e,$b                          # 87e
        selb    $s_12,$s_2,$cc_16,$m_by_side_2          # 88e
        selb    $s_16,$s_14,$cc_17,$m_by_side_2         # 89e
        fnms    $t_7,$s,$e_12,$b_10                     # 90e
        fnms    $e,$s_14,$y,$k_one                      # 91e
        fma     $e_14,$e_13,$half_4,$whole_4            # 92e
        cgti    $ahead,$t,0                             # 93e
        cgt     $control,$t_best_13,$t                  # 94e
        and     $control,$control,$ahead                # 96e
        fma     $e,$e,$half_4,$whole_4                  # 97e
        andc    $control,$control,$disc                 # 98e
        cgt     $control_4,$t_best_11,$t_7              # 99e
        lnop                                            # 99o pairing
        cgti    $ahead,$t_7,0                           # 100e
        rotqbii $control,$control,1                     # 100o
        fnms    $t_8,$s_12,$e_14,$b_19                  # 101e
        and     $control_10,$control_4,$ahead           # 102e
        fnms    $t_4,$s_16,$e,$b_12                     # 103e
        lnop                                            # 103o pairing
        andc    $control_10,$control_10,$disc_9         # 104e
        gb      $control,$control                       # 104o
        rotqbii $control_10,$control_10,1               # 106o
        cgt     $control_15,$t_best_14,$t_8             # 107e
        cgti    $ahead,$t_8,0                           # 108e
        shlqbii $control,$control,4                     # 108o
        cgti    $ahead_6,$t_4,0                         # 109e
        lnop                                            # 109o pairing
        and     $control_15,$control_15,$ahead          # 110e
        gb      $control_10,$control_10                 # 110o
        cgt     $control_4,$t_best_12,$t_4              # 111e
        lnop                                            # 111o pairing
        andc    $control_15,$control_15,$disc_10        # 112e
        lqx     $control,$control,$a_controls           # 112o
        and     $control_16,$control_4,$ahead_6         # 113e
        shlqbii $control_10,$control_10,4               # 114o
        andc    $control_16,$control_16,$disc_11        # 115e
        rotqbii $control_15,$control_15,1               # 115o
        rotqbii $control_16,$control_16,1               # 117o
        shufb   $t_best,$t_best_13,$t,$control          # 118o
        lqx     $control_10,$control_10,$a_controls     # 119o
        shufb   $nearest,$nearest_13,$object,$control   # 120o
        gb      $control,$control_15                    # 121o
        stqd    $t_best,384($a_packet)                  # 122o
        gb      $control_15,$control_16                 # 123o
        stqd    $nearest,448($a_packet)                 # 124o
        shufb   $nearest,$nearest_14,$object,$control_10 # 125o
        shlqbii $control,$control,4                     # 126o
        shlqbii $control_15,$control_15,4               # 127o
        shufb   $t_best,$t_best_11,$t_7,$control_10     # 128o
        stqd    $nearest,464($a_packet)                 # 129o
        lqx     $control,$control,$a_controls           # 130o
        lqx     $control_7,$control_15,$a_controls      # 131o
        stqd    $t_best,400($a_packet)                  # 132o
        hbrr    next_ball_short_back,next_ball_short    # 133o hint
        shufb   $t_best,$t_best_14,$t_8,$control        # 136o
        shufb   $t_best_7,$t_best_12,$t_4,$control_7    # 137o
        shufb   $nearest,$nearest_11,$object,$control   # 138o
        shufb   $nearest_7,$nearest_15,$object,$control_7 # 139o
        stqd    $t_best,432($a_packet)                  # 140o
        stqd    $t_best_7,416($a_packet)                # 141o
        stqd    $nearest,496($a_packet)                 # 142o
        stqd    $nearest_7,480($a_packet)               # 143o
next_ball_short_back:
        brnz    $count,next_ball_short                  # 149o
        nop     $127                                    # 145e pairing
        bi      $lr                                     # 145o
endfunction isect_sphere_pairs_paper_r16
