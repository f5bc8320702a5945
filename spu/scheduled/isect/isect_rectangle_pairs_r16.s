# isect_rectangle_pairs_r16   nearest hit of packets' rays with parallelograms, by candidates
#   C       void isect_rectangle_pairs_r16(const struct candidate *, int count);
#   In      $3 candidates of objects that are rectangles, $4 count (0 is none); pointers 16-aligned
#   Out     the candidates' packets: t, object, where a hit has 0 < t < what was there
#   Uses    $2-$77, $79   Saves  -   Stack  0   Calls  -
#   Domain  |direction| and |axis| about 1; distances from the corner below 2^60
#   Error   20 ulp of t, 5e-4 in u and v; edges from 1/100 of the distance to all of it, 30 degrees
#           or more apart; incidence within 84 degrees of the normal
#   Twin    lab/twins/src/rectangle_pairs.rs
#
# Like isect_rectangle_r16. But from behind, where the direction goes with the axis, it is hit only
# with SIDES_BOTH. A ray parallel to the plane gets a t that is 0 or beyond everything, so it
# misses.
# Scheduled by spu schedule from isect_rectangle_pairs_r16.s

        .include "work_unit.inc"
        .include "macros.inc"
        .include "pairs.inc"
        .include "rectangle_tmpl.inc"

        .set    NEXT,3
        registers a_candidate,count
        # constants
        .set    NEXT,10
        registers k_x,k_y,k_z,m_w,k_one,k_sign
        .set    NEXT,42
        registers a_controls
        # the candidate
        registers object
        .set    NEXT,43
        registers a_rectangle,a_packet
        .set    NEXT,44
        registers a_rays,both
        # temporaries
        registers outside,c_v
        .set    NEXT,47
        registers seen                                  # reused
        registers t,t_best,nearest
        .set    control,47                              # reused
        .set    ahead,39                                # n

        sign_controls_table

function isect_rectangle_pairs_r16
        .set count_2,79; .set record_2,16; .set record_3,19; .set direction_x_2,23
        .set direction_x_3,9; .set direction_x_4,25; .set normal_x_2,24; .set direction_y_2,27
        .set direction_y_3,30; .set direction_y_4,40; .set along_2,29; .set normal_y_2,26
        .set along_3,31; .set along_4,37; .set direction_z_2,36; .set direction_z_3,38
        .set direction_z_4,56; .set normal_z_2,16; .set beside_x_2,39; .set beside_x_3,41
        .set beside_x_4,47; .set beside_x_5,46; .set point_x_2,45; .set beside_y_2,51
        .set beside_y_3,52; .set beside_y_4,54; .set beside_y_5,55; .set point_y_2,53
        .set beside_x_6,2; .set beside_z_2,57; .set t_y_2,5; .set beside_x_7,45; .set t_y_3,58
        .set t_y_4,70; .set t_y_5,63; .set t_y_6,47; .set beside_z_3,60; .set beside_z_4,61
        .set beside_z_5,68; .set point_z_2,19; .set record_4,17; .set ahead_2,59
        .set dual_u_x_2,62; .set ahead_3,21; .set dual_u_y_2,64; .set both_2,66; .set beside_y_6,53
        .set dual_u_z_2,28; .set ahead_4,67; .set nearest_2,75; .set ahead_5,24; .set dual_v_x_2,5
        .set dual_v_y_2,55; .set dual_v_z_2,65; .set t_best_2,76; .set t_e_2,69; .set nearest_3,77
        .set beside_z_6,19; .set a_packet_2,73; .set t_e_3,68; .set a_rectangle_2,74
        .set ahead_6,26; .set t_e_4,67; .set t_e_5,6; .set inverse_2,58; .set inverse_3,47
        .set inverse_4,63; .set ahead_7,16; .set inverse_5,6; .set control_2,67; .set ahead_8,31
        .set control_3,21; .set ahead_9,58; .set control_4,16; .set beside_x_8,23
        .set beside_y_7,22; .set beside_x_9,18; .set beside_y_8,6; .set v_2,7; .set u_2,8
        .set u_3,20; .set beside_y_9,9; .set u_4,23; .set v_3,17; .set v_4,2; .set beside_z_7,5
        .set u_5,18; .set beside_z_8,20; .set u_6,22; .set beside_z_9,23; .set beside_z_10,9
        .set v_5,6; .set u_7,17; .set u_8,19; .set v_6,18; .set v_7,5; .set t_2,71; .set t_3,72
        .set outside_2,2; .set control_5,6; .set outside_3,40; .set outside_4,7; .set t_best_3,5
        .set outside_5,6; .set t_best_4,7; .set nearest_4,8; .set control_6,9; .set control_7,18
        .set t_4,20; .set control_8,22; .set control_9,2; .set dual_v_x_3,17; .set t_e_6,26
        .set nearest_5,18; .set beside_y_10,5; .set nearest_6,2; .set beside_z_11,7; .set v_8,9
        .set beside_y_11,18; .set beside_z_12,18; .set control_10,3; .set outside_6,3
        .set control_11,4; .set outside_7,4; .set t_best_5,3; .set record_5,2; .set record_6,5
        .set direction_x_5,6; .set direction_y_5,7; .set direction_z_5,8; .set along_5,9
        .set direction_x_6,16; .set direction_x_7,17; .set point_x_3,18; .set beside_x_10,21
        .set normal_z_3,22; .set along_6,23; .set direction_y_6,24; .set along_7,25
        .set direction_y_7,26; .set point_y_3,27; .set direction_z_6,28; .set beside_y_12,31
        .set beside_z_13,36; .set direction_z_7,37; .set beside_z_14,38; .set point_z_3,2
        .set beside_x_11,40; .set ahead_10,41; .set t_y_7,45; .set t_y_8,46; .set beside_y_13,48
        .set beside_y_14,49; .set beside_z_15,50; .set beside_z_16,51; .set record_7,52
        .set dual_u_x_3,53; .set both_3,54; .set dual_u_z_3,55; .set t_e_7,56; .set dual_u_y_3,5
        .set t_e_8,57; .set t_best_6,58; .set t_y_9,59; .set dual_v_x_4,40; .set t_y_10,60
        .set dual_v_y_3,61; .set inverse_6,45; .set dual_v_z_3,52; .set inverse_7,46
        .set t_y_11,56; .set t_best_7,57; .set t_best_8,60; .set t_best_9,62; .set ahead_11,63
        .set ahead_12,19; .set nearest_7,64; .set beside_y_15,27; .set nearest_8,48
        .set nearest_9,65; .set t_e_9,66; .set nearest_10,67; .set beside_z_17,2; .set t_e_10,45
        .set ahead_13,20; .set beside_x_12,6; .set inverse_8,7; .set beside_y_16,21; .set v_9,22
        .set u_9,6; .set v_10,8; .set ahead_14,7; .set beside_z_18,29; .set beside_x_13,16
        .set beside_x_14,17; .set v_11,19; .set u_10,21; .set v_12,16; .set t_5,22
        .set beside_y_17,24; .set u_11,26; .set control_12,19; .set t_6,18; .set u_12,5
        .set beside_z_19,6; .set t_7,5; .set control_13,8; .set t_8,6; .set outside_8,17
        .set control_14,23; .set control_15,20; .set outside_9,8; .set control_16,7
        .set t_best_10,8
        nop     $127                                    # 0e pairing
        biz     $count,$lr                              # 0o
        ilhu    $k_y,0x405                              # 1e
        ilhu    $k_z,0x809                              # 2e
        ilhu    $m_w,0xc0d                              # 3e
        clgti   $count_2,$count,1                       # 4e at least as many passes as overlap
        ila     $k_x,0x10203                            # 5e
        iohl    $k_y,0x607                              # 6e
        iohl    $k_z,0xa0b                              # 7e
        iohl    $m_w,0xe0f                              # 8e
        ilhu    $k_one,0x3f80                           # 9e
        ilhu    $k_sign,0x8000                          # 10e
        ila     $a_controls,sign_controls               # 11e
        brz     $count_2,next_rectangle_short           # 11o too few passes
        ai      $count,$count,-1                        # 12e
        lqd     $a_rectangle,0($a_candidate)            # 12o
        ai      $a_candidate,$a_candidate,16            # 13e
        rotqbyi $a_packet,$a_rectangle,4                # 18o
        lqd     $record_2,16($a_rectangle)              # 19o
        lqd     $record_3,0($a_rectangle)               # 20o
        lqd     $record,48($a_rectangle)                # 21o
        lqd     $direction_x,192($a_packet)             # 22o
        lqd     $direction_x_2,208($a_packet)           # 23o
        lqd     $direction_x_3,224($a_packet)           # 24o
        lqd     $direction_x_4,240($a_packet)           # 25o
        shufb   $normal_x_2,$record_2,$record_2,$k_x    # 26o
        lqd     $direction_y,256($a_packet)             # 27o
        lqd     $direction_y_2,272($a_packet)           # 28o
        nop     $127                                    # 29e pairing
        lqd     $direction_y_3,288($a_packet)           # 29o
        fm      $along,$normal_x_2,$direction_x         # 30e
        lqd     $direction_y_4,304($a_packet)           # 30o
        fm      $along_2,$normal_x_2,$direction_x_2     # 31e
        shufb   $normal_y_2,$record_2,$record_2,$k_y    # 31o
        fm      $along_3,$normal_x_2,$direction_x_3     # 32e
        lqd     $direction_z,320($a_packet)             # 32o
        fm      $along_4,$normal_x_2,$direction_x_4     # 33e
        lqd     $direction_z_2,368($a_packet)           # 33o
        lqd     $direction_z_3,336($a_packet)           # 34o
        lqd     $direction_z_4,352($a_packet)           # 35o
        fma     $along,$normal_y_2,$direction_y,$along  # 36e
        shufb   $normal_z_2,$record_2,$record_2,$k_z    # 36o
        fma     $along_2,$normal_y_2,$direction_y_2,$along_2 # 37e
        lqd     $beside_x_2,48($a_packet)               # 37o
        fma     $along_3,$normal_y_2,$direction_y_3,$along_3 # 38e
        lqd     $beside_x_3,32($a_packet)               # 38o
        fma     $along_4,$normal_y_2,$direction_y_4,$along_4 # 39e
        lqd     $beside_x_4,16($a_packet)               # 39o
        lqd     $beside_x_5,0($a_packet)                # 40o
        shufb   $point_x_2,$record_3,$record_3,$k_x     # 41o
        fma     $along,$normal_z_2,$direction_z,$along  # 42e
        lqd     $beside_y_2,96($a_packet)               # 42o
        fma     $along_2,$normal_z_2,$direction_z_3,$along_2 # 43e
        lqd     $beside_y_3,80($a_packet)               # 43o
        fma     $along_3,$normal_z_2,$direction_z_4,$along_3 # 44e
        lqd     $beside_y_4,112($a_packet)              # 44o
        fma     $along_4,$normal_z_2,$direction_z_2,$along_4 # 45e
        lqd     $beside_y_5,64($a_packet)               # 45o
        fs      $beside_x_3,$beside_x_3,$point_x_2      # 46e
        shufb   $point_y_2,$record_3,$record_3,$k_y     # 46o
        fs      $beside_x_6,$beside_x_2,$point_x_2      # 47e
        lqd     $beside_z_2,128($a_packet)              # 47o
        fs      $beside_x_5,$beside_x_5,$point_x_2      # 48e
        frest   $t_y_2,$along                           # 48o
        fs      $beside_x_7,$beside_x_4,$point_x_2      # 49e
        frest   $t_y_3,$along_2                         # 49o
        fs      $beside_y_3,$beside_y_3,$point_y_2      # 50e
        frest   $t_y_4,$along_3                         # 50o
        fs      $beside_y_2,$beside_y_2,$point_y_2      # 51e
        frest   $t_y_5,$along_4                         # 51o
        fi      $t_y_6,$along,$t_y_2                    # 52e
        lqd     $beside_z_3,160($a_packet)              # 52o
        fi      $t_y_3,$along_2,$t_y_3                  # 53e
        lqd     $beside_z_4,176($a_packet)              # 53o
        fi      $t_y_4,$along_3,$t_y_4                  # 54e
        lqd     $beside_z_5,144($a_packet)              # 54o
        fi      $t_y_5,$along_4,$t_y_5                  # 55e
        shufb   $point_z_2,$record_3,$record_3,$k_z     # 55o
        nop     $127                                    # 56e pairing
        lqd     $record_4,64($a_rectangle)              # 56o
        fm      $ahead_2,$normal_x_2,$beside_x_3        # 57e
        shufb   $dual_u_x_2,$record,$record,$k_x        # 57o
        fm      $ahead_3,$normal_x_2,$beside_x_5        # 58e
        shufb   $dual_u_y_2,$record,$record,$k_y        # 58o
        fs      $beside_y_4,$beside_y_4,$point_y_2      # 59e
        lqd     $both_2,32($a_rectangle)                # 59o
        fs      $beside_y_6,$beside_y_5,$point_y_2      # 60e
        shufb   $dual_u_z_2,$record,$record,$k_z        # 60o
        fm      $ahead_4,$normal_x_2,$beside_x_6        # 61e
        lqd     $nearest_2,464($a_packet)               # 61o
        fm      $ahead_5,$normal_x_2,$beside_x_7        # 62e
        shufb   $dual_v_x_2,$record_4,$record_4,$k_x    # 62o
        fs      $beside_z_2,$beside_z_2,$point_z_2      # 63e
        shufb   $dual_v_y_2,$record_4,$record_4,$k_y    # 63o
        fs      $beside_z_4,$beside_z_4,$point_z_2      # 64e
        shufb   $dual_v_z_2,$record_4,$record_4,$k_z    # 64o
        fs      $beside_z_3,$beside_z_3,$point_z_2      # 65e
        shufb   $both_2,$both_2,$both_2,$m_w            # 65o
        fma     $ahead_3,$normal_y_2,$beside_y_6,$ahead_3 # 66e
        lqd     $t_best_2,400($a_packet)                # 66o
        fnms    $t_e_2,$along,$t_y_6,$k_one             # 67e
        lqd     $nearest_3,480($a_packet)               # 67o
        fs      $beside_z_6,$beside_z_5,$point_z_2      # 68e
        shlqbyi $a_packet_2,$a_packet,0                 # 68o copy
        fnms    $t_e_3,$along_2,$t_y_3,$k_one           # 69e
        rotqbii $both_2,$both_2,1                       # 69o
        fma     $ahead_2,$normal_y_2,$beside_y_2,$ahead_2 # 70e
        shufb   $a_rectangle_2,$a_rectangle,$a_rectangle,$k_x # 70o
        fma     $ahead_5,$normal_y_2,$beside_y_3,$ahead_5 # 71e
        fma     $ahead_6,$normal_y_2,$beside_y_4,$ahead_4 # 72e
        fnms    $t_e_4,$along_4,$t_y_5,$k_one           # 73e
        fnms    $t_e_5,$along_3,$t_y_4,$k_one           # 74e
        fma     $ahead_3,$normal_z_2,$beside_z_2,$ahead_3 # 75e
        fma     $ahead_2,$normal_z_2,$beside_z_3,$ahead_2 # 76e
        fma     $inverse_2,$t_e_3,$t_y_3,$t_y_3         # 77e
        fma     $ahead_5,$normal_z_2,$beside_z_6,$ahead_5 # 78e
        fma     $inverse_3,$t_e_2,$t_y_6,$t_y_6         # 79e
        fma     $inverse_4,$t_e_4,$t_y_5,$t_y_5         # 80e
        fma     $ahead_7,$normal_z_2,$beside_z_4,$ahead_6 # 81e
        fma     $inverse_5,$t_e_5,$t_y_4,$t_y_4         # 82e
        or      $control_2,$along_3,$both_2             # 83e
        fm      $ahead_5,$ahead_5,$inverse_2            # 84e
        fm      $ahead_8,$ahead_3,$inverse_3            # 85e
        or      $control_3,$along_2,$both_2             # 86e
        fm      $ahead_9,$ahead_7,$inverse_4            # 87e
        fm      $ahead,$ahead_2,$inverse_5              # 88e
        or      $control_4,$along_4,$both_2             # 89e
        fnms    $beside_x,$ahead_5,$direction_x_2,$beside_x_7 # 90e
        fnms    $beside_x_8,$ahead_8,$direction_x,$beside_x_5 # 91e
        fnms    $beside_y_7,$ahead_5,$direction_y_2,$beside_y_3 # 92e
        fnms    $beside_x_9,$ahead_9,$direction_x_4,$beside_x_6 # 93e
        fnms    $beside_x_6,$ahead,$direction_x_3,$beside_x_3 # 94e
        fnms    $beside_y_8,$ahead_9,$direction_y_4,$beside_y_4 # 95e
        fm      $u,$dual_u_x_2,$beside_x                # 96e
        fm      $v_2,$dual_v_x_2,$beside_x_8            # 97e
        fm      $u_2,$dual_u_x_2,$beside_x_8            # 98e
        fm      $u_3,$dual_u_x_2,$beside_x_9            # 99e
        fm      $v,$dual_v_x_2,$beside_x                # 100e
        fnms    $beside_y_9,$ahead_8,$direction_y,$beside_y_6 # 101e
        fnms    $beside_y,$ahead,$direction_y_3,$beside_y_2 # 102e
        fm      $u_4,$dual_u_x_2,$beside_x_6            # 103e
        fm      $v_3,$dual_v_x_2,$beside_x_9            # 104e
        fm      $v_4,$dual_v_x_2,$beside_x_6            # 105e
        fnms    $beside_z_7,$ahead_9,$direction_z_2,$beside_z_4 # 106e
        fma     $u,$dual_u_y_2,$beside_y_7,$u           # 107e
        fma     $u_5,$dual_u_y_2,$beside_y_8,$u_3       # 108e
        fma     $v_2,$dual_v_y_2,$beside_y_9,$v_2       # 109e
        fma     $v,$dual_v_y_2,$beside_y_7,$v           # 110e
        fnms    $beside_z_8,$ahead,$direction_z_4,$beside_z_3 # 111e
        fma     $u_6,$dual_u_y_2,$beside_y,$u_4         # 112e
        fnms    $beside_z_9,$ahead_8,$direction_z,$beside_z_2 # 113e
        fma     $u_2,$dual_u_y_2,$beside_y_9,$u_2       # 114e
        fnms    $beside_z_10,$ahead_5,$direction_z_3,$beside_z_6 # 115e
        fma     $v_4,$dual_v_y_2,$beside_y,$v_4         # 116e
        fma     $v_5,$dual_v_y_2,$beside_y_8,$v_3       # 117e
        fma     $u_7,$dual_u_z_2,$beside_z_7,$u_5       # 118e
        fma     $u_8,$dual_u_z_2,$beside_z_8,$u_6       # 119e
        fma     $v_2,$dual_v_z_2,$beside_z_9,$v_2       # 120e
        fma     $u_2,$dual_u_z_2,$beside_z_9,$u_2       # 121e
        fma     $u,$dual_u_z_2,$beside_z_10,$u          # 122e
        fma     $v,$dual_v_z_2,$beside_z_10,$v          # 123e
        fma     $v_6,$dual_v_z_2,$beside_z_8,$v_4       # 124e
        fma     $v_7,$dual_v_z_2,$beside_z_7,$v_5       # 125e
        xor     $t_2,$ahead_9,$k_sign                   # 126e
        xor     $t_3,$ahead_5,$k_sign                   # 127e
        clgt    $control,$v_2,$k_one                    # 128e
        clgt    $outside,$u_2,$k_one                    # 129e
        clgt    $outside_2,$u,$k_one                    # 130e
        clgt    $control_5,$v,$k_one                    # 131e
        clgt    $outside_3,$u_8,$k_one                  # 132e
        clgt    $outside_4,$u_7,$k_one                  # 133e
        lnop                                            # 133o pairing
next_rectangle:
            or      $outside,$outside,$control          # 0e
        lqd     $a_rectangle,0($a_candidate)            # 0o
            or      $outside_2,$outside_2,$control_5    # 1e
            lqd     $t_best,432($a_packet)              # 1o
            clgt    $control,$v_7,$k_one                # 2e
            lqd     $t_best_3,416($a_packet)            # 2o
            orc     $outside_2,$outside_2,$control_3    # 3e
            lqd     $nearest,496($a_packet)             # 3o
            or      $outside_5,$outside_4,$control      # 4e
            lqd     $t_best_4,384($a_packet)            # 4o
            or      $control,$along,$both_2             # 5e
            lqd     $nearest_4,448($a_packet)           # 5o
            xor     $t,$ahead,$k_sign                   # 6e
            lnop                                        # 6o pairing
            cgt     $control_6,$t_best_2,$t_3           # 7e
        rotqbyi $a_packet,$a_rectangle,4                # 7o
            orc     $outside_5,$outside_5,$control_4    # 8e
        lqd     $record,48($a_rectangle)                # 8o
            orc     $outside,$outside,$control          # 9e
        lqd     $record_2,16($a_rectangle)              # 9o
            clgt    $control,$v_6,$k_one                # 10e
        lqd     $record_4,64($a_rectangle)              # 10o
            cgt     $control_7,$t_best_3,$t             # 11e
        lqd     $record_3,0($a_rectangle)               # 11o
            xor     $t_4,$ahead_8,$k_sign               # 12e
        lqd     $direction_z,320($a_packet)             # 12o
            cgt     $control_3,$t_best,$t_2             # 13e
        lqd     $direction_x,192($a_packet)             # 13o
            cgt     $control_8,$t_best_4,$t_4           # 14e
        lqd     $direction_x_2,208($a_packet)           # 14o
            and     $control_6,$control_6,$ahead_5      # 15e
        shufb   $normal_x_2,$record_2,$record_2,$k_x    # 15o
            and     $control_8,$control_8,$ahead_8      # 16e
        lqd     $direction_y,256($a_packet)             # 16o
            andc    $control_9,$control_6,$outside_2    # 17e
        lqd     $direction_x_3,224($a_packet)           # 17o
            andc    $control_8,$control_8,$outside      # 18e
        lqd     $direction_x_4,240($a_packet)           # 18o
        fm      $along,$normal_x_2,$direction_x         # 19e
        shufb   $normal_y_2,$record_2,$record_2,$k_y    # 19o
            and     $control_7,$control_7,$ahead        # 20e
        lqd     $direction_y_2,272($a_packet)           # 20o
        fm      $along_2,$normal_x_2,$direction_x_2     # 21e
        lqd     $direction_y_3,288($a_packet)           # 21o
            and     $control_3,$control_3,$ahead_9      # 22e
        shufb   $normal_z_2,$record_2,$record_2,$k_z    # 22o
        fm      $along_3,$normal_x_2,$direction_x_3     # 23e
        lqd     $direction_z_2,368($a_packet)           # 23o
        fm      $along_4,$normal_x_2,$direction_x_4     # 24e
        lqd     $direction_z_3,336($a_packet)           # 24o
        fma     $along,$normal_y_2,$direction_y,$along  # 25e
        lqd     $beside_x_2,48($a_packet)               # 25o
            or      $outside,$outside_3,$control        # 26e
        lqd     $direction_y_4,304($a_packet)           # 26o
        fma     $along_2,$normal_y_2,$direction_y_2,$along_2 # 27e
        lqd     $beside_x_3,32($a_packet)               # 27o
            orc     $outside,$outside,$control_2        # 28e
        shufb   $point_x_2,$record_3,$record_3,$k_x     # 28o
        fma     $along_3,$normal_y_2,$direction_y_3,$along_3 # 29e
        lqd     $beside_x_4,16($a_packet)               # 29o
            andc    $control_7,$control_7,$outside      # 30e
        lqd     $beside_x_5,0($a_packet)                # 30o
        fma     $along,$normal_z_2,$direction_z,$along  # 31e
        lqd     $beside_y_2,96($a_packet)               # 31o
        fma     $along_4,$normal_y_2,$direction_y_4,$along_4 # 32e
        lqd     $beside_y_3,80($a_packet)               # 32o
        fma     $along_2,$normal_z_2,$direction_z_3,$along_2 # 33e
        shufb   $point_y_2,$record_3,$record_3,$k_y     # 33o
        fs      $beside_x_3,$beside_x_3,$point_x_2      # 34e
        lqd     $beside_y_4,112($a_packet)              # 34o
        fs      $beside_x_2,$beside_x_2,$point_x_2      # 35e
        lqd     $beside_y_5,64($a_packet)               # 35o
        fs      $beside_x_5,$beside_x_5,$point_x_2      # 36e
        lqd     $direction_z_4,352($a_packet)           # 36o
        fs      $beside_x_7,$beside_x_4,$point_x_2      # 37e
        frest   $t_y_6,$along                           # 37o
        fma     $along_4,$normal_z_2,$direction_z_2,$along_4 # 38e
        lqd     $beside_z_2,128($a_packet)              # 38o
        fs      $beside_y_3,$beside_y_3,$point_y_2      # 39e
        frest   $t_y_3,$along_2                         # 39o
        fm      $ahead_2,$normal_x_2,$beside_x_3        # 40e
        lqd     $beside_z_3,160($a_packet)              # 40o
        fi      $t_y_6,$along,$t_y_6                    # 41e
        lqd     $beside_z_4,176($a_packet)              # 41o
            andc    $control_5,$control_3,$outside_5    # 42e
        shufb   $point_z_2,$record_3,$record_3,$k_z     # 42o
        fm      $ahead_3,$normal_x_2,$beside_x_5        # 43e
        shufb   $dual_u_x_2,$record,$record,$k_x        # 43o
        fs      $beside_y_2,$beside_y_2,$point_y_2      # 44e
            rotqbii $control_5,$control_5,1             # 44o
        fs      $beside_y_4,$beside_y_4,$point_y_2      # 45e
        frest   $t_y_5,$along_4                         # 45o
        fs      $beside_z_2,$beside_z_2,$point_z_2      # 46e
        shufb   $dual_u_y_2,$record,$record,$k_y        # 46o
        fs      $beside_y_6,$beside_y_5,$point_y_2      # 47e
        shufb   $dual_v_y_2,$record_4,$record_4,$k_y    # 47o
        fi      $t_y_3,$along_2,$t_y_3                  # 48e
        shufb   $dual_u_z_2,$record,$record,$k_z        # 48o
        fi      $t_y_5,$along_4,$t_y_5                  # 49e
        shufb   $dual_v_z_2,$record_4,$record_4,$k_z    # 49o
        ai      $count,$count,-1                        # 50e
        lqd     $both_2,32($a_rectangle)                # 50o
        fma     $along_3,$normal_z_2,$direction_z_4,$along_3 # 51e
        lnop                                            # 51o pairing
        fm      $ahead_4,$normal_x_2,$beside_x_2        # 52e
        lqd     $beside_z_5,144($a_packet)              # 52o
        fm      $ahead_5,$normal_x_2,$beside_x_7        # 53e
        fs      $beside_z_4,$beside_z_4,$point_z_2      # 54e
        fs      $beside_z_3,$beside_z_3,$point_z_2      # 55e
            rotqbii $control_7,$control_7,1             # 55o
        fma     $ahead_3,$normal_y_2,$beside_y_6,$ahead_3 # 56e
        shufb   $both_2,$both_2,$both_2,$m_w            # 56o
        fnms    $t_e_2,$along,$t_y_6,$k_one             # 57e
        frest   $t_y_4,$along_3                         # 57o
        fs      $beside_z_6,$beside_z_5,$point_z_2      # 58e
            rotqbii $control_9,$control_9,1             # 58o
        fnms    $t_e_3,$along_2,$t_y_3,$k_one           # 59e
            rotqbii $control_8,$control_8,1             # 59o
        fma     $ahead_2,$normal_y_2,$beside_y_2,$ahead_2 # 60e
        rotqbii $both_2,$both_2,1                       # 60o
        fi      $t_y_4,$along_3,$t_y_4                  # 61e
        shufb   $dual_v_x_3,$record_4,$record_4,$k_x    # 61o
        ai      $a_candidate,$a_candidate,16            # 62e
            gb      $control_9,$control_9               # 62o
        fma     $ahead_5,$normal_y_2,$beside_y_3,$ahead_5 # 63e
            gb      $control_5,$control_5               # 63o
        fma     $ahead_6,$normal_y_2,$beside_y_4,$ahead_4 # 64e
            gb      $control_8,$control_8               # 64o
        fnms    $t_e_4,$along_4,$t_y_5,$k_one           # 65e
        lnop                                            # 65o pairing
        fma     $ahead_3,$normal_z_2,$beside_z_2,$ahead_3 # 66e
            gb      $control_7,$control_7               # 66o
        fma     $ahead_2,$normal_z_2,$beside_z_3,$ahead_2 # 67e
            shlqbii $control_5,$control_5,4             # 67o
        fma     $inverse_2,$t_e_3,$t_y_3,$t_y_3         # 68e
            shlqbii $control_8,$control_8,4             # 68o
        fma     $ahead_5,$normal_z_2,$beside_z_6,$ahead_5 # 69e
        lnop                                            # 69o pairing
        fma     $inverse_3,$t_e_2,$t_y_6,$t_y_6         # 70e
            shlqbii $control_7,$control_7,4             # 70o
        fma     $inverse_4,$t_e_4,$t_y_5,$t_y_5         # 71e
            shlqbii $control_9,$control_9,4             # 71o
        fma     $ahead_7,$normal_z_2,$beside_z_4,$ahead_6 # 72e
            lqx     $control_5,$control_5,$a_controls   # 72o
        or      $control_2,$along_3,$both_2             # 73e
        lnop                                            # 73o pairing
        fnms    $t_e_6,$along_3,$t_y_4,$k_one           # 74e
            lqx     $control_7,$control_7,$a_controls   # 74o
        fm      $ahead_5,$ahead_5,$inverse_2            # 75e
        lnop                                            # 75o pairing
        fm      $ahead_8,$ahead_3,$inverse_3            # 76e
            lqx     $control,$control_8,$a_controls     # 76o
        or      $control_3,$along_2,$both_2             # 77e
            lqx     $control_9,$control_9,$a_controls   # 77o
        fm      $ahead_9,$ahead_7,$inverse_4            # 78e
            shufb   $nearest,$nearest,$a_rectangle_2,$control_5 # 78o
        or      $control_4,$along_4,$both_2             # 79e
            shufb   $t_best,$t_best,$t_2,$control_5     # 79o
        fma     $inverse_5,$t_e_6,$t_y_4,$t_y_4         # 80e
            shufb   $t_best_3,$t_best_3,$t,$control_7   # 80o
        fnms    $beside_y_7,$ahead_5,$direction_y_2,$beside_y_3 # 81e
            shufb   $nearest_5,$nearest_3,$a_rectangle_2,$control_7 # 81o
        fnms    $beside_x,$ahead_5,$direction_x_2,$beside_x_7 # 82e
            stqd    $nearest,496($a_packet_2)           # 82o
        fnms    $beside_x_8,$ahead_8,$direction_x,$beside_x_5 # 83e
            stqd    $t_best,432($a_packet_2)            # 83o
        xor     $t_2,$ahead_9,$k_sign                   # 84e
            stqd    $t_best_3,416($a_packet_2)          # 84o
        fnms    $beside_y_10,$ahead_9,$direction_y_4,$beside_y_4 # 85e
            stqd    $nearest_5,480($a_packet_2)         # 85o
        fnms    $beside_x_9,$ahead_9,$direction_x_4,$beside_x_2 # 86e
            shufb   $t_best,$t_best_2,$t_3,$control_9   # 86o
        xor     $t_3,$ahead_5,$k_sign                   # 87e
            shufb   $t_best_4,$t_best_4,$t_4,$control   # 87o
        fm      $ahead,$ahead_2,$inverse_5              # 88e
            shufb   $nearest,$nearest_4,$a_rectangle_2,$control # 88o
        fm      $u,$dual_u_x_2,$beside_x                # 89e
            shufb   $nearest_6,$nearest_2,$a_rectangle_2,$control_9 # 89o
        fm      $v_5,$dual_v_x_3,$beside_x_8            # 90e
            stqd    $t_best,400($a_packet_2)            # 90o
        fm      $u_2,$dual_u_x_2,$beside_x_8            # 91e
            stqd    $t_best_4,384($a_packet_2)          # 91o
        fnms    $beside_z_11,$ahead_9,$direction_z_2,$beside_z_4 # 92e
            stqd    $nearest,448($a_packet_2)           # 92o
        fm      $u_3,$dual_u_x_2,$beside_x_9            # 93e
            stqd    $nearest_6,464($a_packet_2)         # 93o
        fnms    $beside_x_6,$ahead,$direction_x_3,$beside_x_3 # 94e
        fm      $v,$dual_v_x_3,$beside_x                # 95e
        fm      $v_8,$dual_v_x_3,$beside_x_9            # 96e
        fnms    $beside_y_11,$ahead_8,$direction_y,$beside_y_6 # 97e
        fnms    $beside_y,$ahead,$direction_y_3,$beside_y_2 # 98e
        fma     $u,$dual_u_y_2,$beside_y_7,$u           # 99e
        fm      $u_4,$dual_u_x_2,$beside_x_6            # 100e
        lnop                                            # 100o pairing
        fm      $v_4,$dual_v_x_3,$beside_x_6            # 101e
        shlqbyi $a_packet_2,$a_packet,0                 # 101o copy
        fma     $u_7,$dual_u_y_2,$beside_y_10,$u_3      # 102e
        lnop                                            # 102o pairing
        fma     $v_5,$dual_v_y_2,$beside_y_11,$v_5      # 103e
        shufb   $a_rectangle_2,$a_rectangle,$a_rectangle,$k_x # 103o
        fma     $v,$dual_v_y_2,$beside_y_7,$v           # 104e
        fnms    $beside_z_8,$ahead,$direction_z_4,$beside_z_3 # 105e
        fma     $u_6,$dual_u_y_2,$beside_y,$u_4         # 106e
        fma     $v_4,$dual_v_y_2,$beside_y,$v_4         # 107e
        fnms    $beside_z_9,$ahead_8,$direction_z,$beside_z_2 # 108e
        hbrr    next_rectangle_back,next_rectangle      # 108o hint
        fma     $u_2,$dual_u_y_2,$beside_y_11,$u_2      # 109e
        fnms    $beside_z_12,$ahead_5,$direction_z_3,$beside_z_6 # 110e
        fma     $u_7,$dual_u_z_2,$beside_z_11,$u_7      # 111e
        fma     $u_8,$dual_u_z_2,$beside_z_8,$u_6       # 112e
        fma     $v_7,$dual_v_y_2,$beside_y_10,$v_8      # 113e
        fma     $v_5,$dual_v_z_2,$beside_z_9,$v_5       # 114e
        fma     $u_2,$dual_u_z_2,$beside_z_9,$u_2       # 115e
        fma     $u,$dual_u_z_2,$beside_z_12,$u          # 116e
        fma     $v,$dual_v_z_2,$beside_z_12,$v          # 117e
        fma     $v_6,$dual_v_z_2,$beside_z_8,$v_4       # 118e
        fma     $v_7,$dual_v_z_2,$beside_z_11,$v_7      # 119e
        clgt    $control,$v_5,$k_one                    # 120e
        clgt    $outside,$u_2,$k_one                    # 121e
        lnop                                            # 121o pairing
        clgt    $outside_2,$u,$k_one                    # 122e
        lqd     $nearest_2,464($a_packet)               # 122o
        clgt    $control_5,$v,$k_one                    # 123e
        lqd     $t_best_2,400($a_packet)                # 123o
        clgt    $outside_3,$u_8,$k_one                  # 124e
        lqd     $nearest_3,480($a_packet)               # 124o
        clgt    $outside_4,$u_7,$k_one                  # 125e
next_rectangle_back:
        brnz    $count,next_rectangle                   # 125o
next_rectangle_drain:
        clgt    $control_10,$v_7,$k_one                 # 0e
        lqd     $t_best,432($a_packet)                  # 0o
        xor     $t,$ahead,$k_sign                       # 1e
        lqd     $t_best_3,416($a_packet)                # 1o
        or      $outside_6,$outside_4,$control_10       # 2e
        lqd     $t_best_4,384($a_packet)                # 2o
        clgt    $control_11,$v_6,$k_one                 # 3e
        lqd     $nearest,496($a_packet)                 # 3o
        orc     $outside_6,$outside_6,$control_4        # 4e
        hbr     isect_rectangle_pairs_r16_return,$lr    # 4o hint
        or      $outside_7,$outside_3,$control_11       # 5e
        lqd     $nearest_4,448($a_packet)               # 5o
        cgt     $control_6,$t_best,$t_2                 # 6e
        cgt     $control_7,$t_best_3,$t                 # 7e
        and     $control_6,$control_6,$ahead_9          # 8e
        xor     $t_4,$ahead_8,$k_sign                   # 9e
        or      $outside_2,$outside_2,$control_5        # 10e
        cgt     $control_5,$t_best_2,$t_3               # 11e
        and     $control_7,$control_7,$ahead            # 12e
        orc     $outside_7,$outside_7,$control_2        # 13e
        andc    $control_10,$control_6,$outside_6       # 14e
        or      $outside,$outside,$control              # 15e
        or      $control,$along,$both_2                 # 16e
        rotqbii $control_10,$control_10,1               # 16o
        cgt     $control_8,$t_best_4,$t_4               # 17e
        orc     $outside_2,$outside_2,$control_3        # 18e
        and     $control_6,$control_5,$ahead_5          # 19e
        lnop                                            # 19o pairing
        andc    $control_7,$control_7,$outside_7        # 20e
        gb      $control_5,$control_10                  # 20o
        orc     $outside,$outside,$control              # 21e
        lnop                                            # 21o pairing
        and     $control_8,$control_8,$ahead_8          # 22e
        rotqbii $control_7,$control_7,1                 # 22o
        andc    $control_9,$control_6,$outside_2        # 23e
        lnop                                            # 23o pairing
        andc    $control_8,$control_8,$outside          # 24e
        shlqbii $control_5,$control_5,4                 # 24o
        rotqbii $control_9,$control_9,1                 # 25o
        rotqbii $control_8,$control_8,1                 # 26o
        gb      $control_7,$control_7                   # 27o
        lqx     $control_5,$control_5,$a_controls       # 28o
        gb      $control_9,$control_9                   # 29o
        gb      $control_8,$control_8                   # 30o
        shlqbii $control_7,$control_7,4                 # 31o
        shlqbii $control_9,$control_9,4                 # 33o
        shlqbii $control_8,$control_8,4                 # 34o
        lqx     $control_7,$control_7,$a_controls       # 35o
        shufb   $nearest,$nearest,$a_rectangle_2,$control_5 # 36o
        lqx     $control_9,$control_9,$a_controls       # 37o
        lqx     $control,$control_8,$a_controls         # 38o
        shufb   $t_best,$t_best,$t_2,$control_5         # 39o
        stqd    $nearest,496($a_packet_2)               # 40o
        shufb   $t_best_3,$t_best_3,$t,$control_7       # 41o
        shufb   $nearest_5,$nearest_3,$a_rectangle_2,$control_7 # 42o
        shufb   $t_best_5,$t_best_2,$t_3,$control_9     # 43o
        stqd    $t_best,432($a_packet_2)                # 44o
        shufb   $t_best_4,$t_best_4,$t_4,$control       # 45o
        stqd    $t_best_3,416($a_packet_2)              # 46o
        shufb   $nearest,$nearest_4,$a_rectangle_2,$control # 47o
        stqd    $nearest_5,480($a_packet_2)             # 48o
        shufb   $nearest_6,$nearest_2,$a_rectangle_2,$control_9 # 49o
        stqd    $t_best_5,400($a_packet_2)              # 50o
        stqd    $t_best_4,384($a_packet_2)              # 51o
        stqd    $nearest,448($a_packet_2)               # 52o
        stqd    $nearest_6,464($a_packet_2)             # 53o
        nop     $127                                    # 54e pairing
isect_rectangle_pairs_r16_return:
        bi      $lr                                     # 54o
next_rectangle_short:
        ai      $count,$count,-1                        # 0e
        lqd     $a_rectangle,0($a_candidate)            # 0o
        ai      $a_candidate,$a_candidate,16            # 1e
        rotqbyi $a_packet,$a_rectangle,4                # 6o
        lqd     $record,16($a_rectangle)                # 7o
        lqd     $record_5,0($a_rectangle)               # 8o
        lqd     $record_6,48($a_rectangle)              # 9o
        lqd     $direction_x,192($a_packet)             # 10o
        lqd     $direction_x_5,208($a_packet)           # 11o
        lqd     $direction_y,256($a_packet)             # 12o
        shufb   $normal_x,$record,$record,$k_x          # 13o
        shufb   $normal_y,$record,$record,$k_y          # 14o
        lqd     $direction_y_5,272($a_packet)           # 15o
        lqd     $direction_z,336($a_packet)             # 16o
        fm      $along,$normal_x,$direction_x           # 17e
        lqd     $direction_z_5,320($a_packet)           # 17o
        fm      $along_5,$normal_x,$direction_x_5       # 18e
        lqd     $direction_x_6,240($a_packet)           # 18o
        lqd     $direction_x_7,224($a_packet)           # 19o
        lqd     $beside_x,0($a_packet)                  # 20o
        shufb   $point_x_3,$record_5,$record_5,$k_x     # 21o
        lqd     $beside_x_10,16($a_packet)              # 22o
        fma     $along,$normal_y,$direction_y,$along    # 23e
        shufb   $normal_z_3,$record,$record,$k_z        # 23o
        fma     $along_5,$normal_y,$direction_y_5,$along_5 # 24e
        lqd     $beside_y,80($a_packet)                 # 24o
        fm      $along_6,$normal_x,$direction_x_7       # 25e
        lqd     $direction_y_6,304($a_packet)           # 25o
        fm      $along_7,$normal_x,$direction_x_6       # 26e
        lqd     $direction_y_7,288($a_packet)           # 26o
        fs      $beside_x,$beside_x,$point_x_3          # 27e
        shufb   $point_y_3,$record_5,$record_5,$k_y     # 27o
        fs      $beside_x_10,$beside_x_10,$point_x_3    # 28e
        lqd     $direction_z_6,352($a_packet)           # 28o
        fma     $along,$normal_z_3,$direction_z_5,$along # 29e
        lqd     $beside_y_12,64($a_packet)              # 29o
        fma     $along_5,$normal_z_3,$direction_z,$along_5 # 30e
        lqd     $beside_z_13,128($a_packet)             # 30o
        fs      $beside_y,$beside_y,$point_y_3          # 31e
        lqd     $direction_z_7,368($a_packet)           # 31o
        fma     $along_6,$normal_y,$direction_y_7,$along_6 # 32e
        lqd     $beside_z_14,144($a_packet)             # 32o
        fma     $along_7,$normal_y,$direction_y_6,$along_7 # 33e
        shufb   $point_z_3,$record_5,$record_5,$k_z     # 33o
        fm      $ahead,$normal_x,$beside_x_10           # 34e
        lqd     $beside_x_11,48($a_packet)              # 34o
        fm      $ahead_10,$normal_x,$beside_x           # 35e
        frest   $t_y_7,$along                           # 35o
        fs      $beside_y_12,$beside_y_12,$point_y_3    # 36e
        frest   $t_y_8,$along_5                         # 36o
        fs      $beside_z_13,$beside_z_13,$point_z_3    # 37e
        lqd     $beside_x_4,32($a_packet)               # 37o
        fs      $beside_z_14,$beside_z_14,$point_z_3    # 38e
        lqd     $beside_y_13,112($a_packet)             # 38o
        fi      $t_y_7,$along,$t_y_7                    # 39e
        lqd     $beside_y_14,96($a_packet)              # 39o
        fi      $t_y_8,$along_5,$t_y_8                  # 40e
        lqd     $beside_z_15,176($a_packet)             # 40o
        nop     $127                                    # 41e pairing
        lqd     $beside_z_16,160($a_packet)             # 41o
        fma     $along_7,$normal_z_3,$direction_z_7,$along_7 # 42e
        lqd     $record_7,64($a_rectangle)              # 42o
        fma     $ahead,$normal_y,$beside_y,$ahead       # 43e
        shufb   $dual_u_x_3,$record_6,$record_6,$k_x    # 43o
        fma     $along_6,$normal_z_3,$direction_z_6,$along_6 # 44e
        lqd     $both_3,32($a_rectangle)                # 44o
        fma     $ahead_10,$normal_y,$beside_y_12,$ahead_10 # 45e
        shufb   $dual_u_z_3,$record_6,$record_6,$k_z    # 45o
        fnms    $t_e_7,$along,$t_y_7,$k_one             # 46e
        shufb   $dual_u_y_3,$record_6,$record_6,$k_y    # 46o
        fnms    $t_e_8,$along_5,$t_y_8,$k_one           # 47e
        lqd     $t_best_6,400($a_packet)                # 47o
        fs      $beside_x_4,$beside_x_4,$point_x_3      # 48e
        frest   $t_y_9,$along_7                         # 48o
        fs      $beside_x_9,$beside_x_11,$point_x_3     # 49e
        shufb   $dual_v_x_4,$record_7,$record_7,$k_x    # 49o
        fs      $beside_y_14,$beside_y_14,$point_y_3    # 50e
        frest   $t_y_10,$along_6                        # 50o
        fma     $ahead_10,$normal_z_3,$beside_z_13,$ahead_10 # 51e
        shufb   $dual_v_y_3,$record_7,$record_7,$k_y    # 51o
        fma     $inverse_6,$t_e_7,$t_y_7,$t_y_7         # 52e
        shufb   $dual_v_z_3,$record_7,$record_7,$k_z    # 52o
        fma     $inverse_7,$t_e_8,$t_y_8,$t_y_8         # 53e
        shufb   $both_3,$both_3,$both_3,$m_w            # 53o
        fi      $t_y_11,$along_6,$t_y_10                # 54e
        lqd     $t_best_7,384($a_packet)                # 54o
        fi      $t_y_9,$along_7,$t_y_9                  # 55e
        lqd     $t_best_8,416($a_packet)                # 55o
        nop     $127                                    # 56e pairing
        lqd     $t_best_9,432($a_packet)                # 56o
        fm      $ahead_11,$normal_x,$beside_x_9         # 57e
        rotqbii $both_3,$both_3,1                       # 57o
        fm      $ahead_12,$normal_x,$beside_x_4         # 58e
        lqd     $nearest_7,448($a_packet)               # 58o
        fma     $ahead,$normal_z_3,$beside_z_14,$ahead  # 59e
        shufb   $a_rectangle,$a_rectangle,$a_rectangle,$k_x # 59o
        fs      $beside_y_15,$beside_y_13,$point_y_3    # 60e
        lqd     $nearest_8,464($a_packet)               # 60o
        fs      $beside_z_15,$beside_z_15,$point_z_3    # 61e
        lqd     $nearest_9,480($a_packet)               # 61o
        fnms    $t_e_9,$along_7,$t_y_9,$k_one           # 62e
        lqd     $nearest_10,496($a_packet)              # 62o
        fm      $ahead_10,$ahead_10,$inverse_6          # 63e
        fma     $ahead_12,$normal_y,$beside_y_14,$ahead_12 # 64e
        fm      $ahead,$ahead,$inverse_7                # 65e
        fs      $beside_z_17,$beside_z_16,$point_z_3    # 66e
        fnms    $t_e_10,$along_6,$t_y_11,$k_one         # 67e
        fma     $inverse_7,$t_e_9,$t_y_9,$t_y_9         # 68e
        fma     $ahead_13,$normal_y,$beside_y_15,$ahead_11 # 69e
        fnms    $beside_x,$ahead_10,$direction_x,$beside_x # 70e
        fnms    $beside_x_12,$ahead,$direction_x_5,$beside_x_10 # 71e
        fma     $ahead_12,$normal_z_3,$beside_z_17,$ahead_12 # 72e
        fnms    $beside_y,$ahead,$direction_y_5,$beside_y # 73e
        fma     $inverse_8,$t_e_10,$t_y_11,$t_y_11      # 74e
        fma     $ahead_13,$normal_z_3,$beside_z_15,$ahead_13 # 75e
        fnms    $beside_y_16,$ahead_10,$direction_y,$beside_y_12 # 76e
        fm      $v_9,$dual_v_x_4,$beside_x_12           # 77e
        fm      $u_9,$dual_u_x_3,$beside_x_12           # 78e
        fnms    $beside_z,$ahead_10,$direction_z_5,$beside_z_13 # 79e
        fm      $v_10,$dual_v_x_4,$beside_x             # 80e
        fm      $ahead_13,$ahead_13,$inverse_7          # 81e
        fm      $ahead_14,$ahead_12,$inverse_8          # 82e
        fm      $u_8,$dual_u_x_3,$beside_x              # 83e
        fnms    $beside_z_18,$ahead,$direction_z,$beside_z_14 # 84e
        fma     $u_9,$dual_u_y_3,$beside_y,$u_9         # 85e
        fma     $v_10,$dual_v_y_3,$beside_y_16,$v_10    # 86e
        fnms    $beside_x_13,$ahead_13,$direction_x_6,$beside_x_9 # 87e
        fnms    $beside_x_14,$ahead_14,$direction_x_7,$beside_x_4 # 88e
        fma     $u_5,$dual_u_y_3,$beside_y_16,$u_8      # 89e
        fma     $v_11,$dual_v_y_3,$beside_y,$v_9        # 90e
        fma     $u_9,$dual_u_z_3,$beside_z_18,$u_9      # 91e
        fma     $v_10,$dual_v_z_3,$beside_z,$v_10       # 92e
        fm      $u_10,$dual_u_x_3,$beside_x_13          # 93e
        fm      $v_12,$dual_v_x_4,$beside_x_13          # 94e
        fnms    $beside_y,$ahead_13,$direction_y_6,$beside_y_15 # 95e
        fma     $u_5,$dual_u_z_3,$beside_z,$u_5         # 96e
        fma     $v_11,$dual_v_z_3,$beside_z_18,$v_11    # 97e
        xor     $t_5,$ahead,$k_sign                     # 98e
        fnms    $beside_y_17,$ahead_14,$direction_y_7,$beside_y_14 # 99e
        or      $control,$along,$both_3                 # 100e
        or      $control_6,$along_5,$both_3             # 101e
        fm      $u_11,$dual_u_x_3,$beside_x_14          # 102e
        clgt    $control_12,$v_11,$k_one                # 103e
        fma     $u_10,$dual_u_y_3,$beside_y,$u_10       # 104e
        clgt    $outside,$u_5,$k_one                    # 105e
        xor     $t_6,$ahead_10,$k_sign                  # 106e
        clgt    $outside_5,$u_9,$k_one                  # 107e
        fma     $u_12,$dual_u_y_3,$beside_y_17,$u_11    # 108e
        or      $outside_5,$outside_5,$control_12       # 109e
        fm      $v_3,$dual_v_x_4,$beside_x_14           # 110e
        orc     $outside_5,$outside_5,$control_6        # 111e
        fma     $v_8,$dual_v_y_3,$beside_y,$v_12        # 112e
        cgt     $control_4,$t_best_6,$t_5               # 113e
        fnms    $beside_z,$ahead_14,$direction_z_6,$beside_z_17 # 114e
        clgt    $control_9,$v_10,$k_one                 # 115e
        fma     $v_10,$dual_v_y_3,$beside_y_17,$v_3     # 116e
        or      $outside,$outside,$control_9            # 117e
        cgt     $control_9,$t_best_7,$t_6               # 118e
        orc     $outside,$outside,$control              # 119e
        and     $control,$control_9,$ahead_10           # 120e
        and     $control_9,$control_4,$ahead            # 121e
        fma     $v,$dual_v_z_3,$beside_z,$v_10          # 122e
        andc    $control_9,$control_9,$outside_5        # 123e
        fnms    $beside_z_19,$ahead_13,$direction_z_7,$beside_z_15 # 124e
        fma     $u,$dual_u_z_3,$beside_z,$u_12          # 125e
        rotqbii $control_9,$control_9,1                 # 125o
        andc    $control,$control,$outside              # 126e
        xor     $t_7,$ahead_13,$k_sign                  # 127e
        clgt    $control_13,$v,$k_one                   # 128e
        rotqbii $control,$control,1                     # 128o
        or      $control_4,$along_7,$both_3             # 129e
        gb      $control_9,$control_9                   # 129o
        fma     $u_7,$dual_u_z_3,$beside_z_19,$u_10     # 130e
        clgt    $outside,$u,$k_one                      # 131e
        fma     $v,$dual_v_z_3,$beside_z_19,$v_8        # 132e
        gb      $control,$control                       # 132o
        xor     $t_8,$ahead_14,$k_sign                  # 133e
        shlqbii $control_9,$control_9,4                 # 133o
        or      $control_6,$along_6,$both_3             # 134e
        cgt     $control_12,$t_best_8,$t_8              # 135e
        clgt    $outside_8,$u_7,$k_one                  # 136e
        shlqbii $control,$control,4                     # 136o
        cgt     $control_3,$t_best_9,$t_7               # 137e
        lqx     $control_9,$control_9,$a_controls       # 137o
        clgt    $control_14,$v,$k_one                   # 138e
        and     $control_15,$control_3,$ahead_13        # 139e
        or      $outside_8,$outside_8,$control_14       # 140e
        lqx     $control,$control,$a_controls           # 140o
        or      $outside,$outside,$control_13           # 141e
        orc     $outside_9,$outside_8,$control_4        # 142e
        orc     $outside,$outside,$control_6            # 143e
        shufb   $t_best,$t_best_6,$t_5,$control_9       # 143o
        and     $control_16,$control_12,$ahead_14       # 144e
        shufb   $nearest,$nearest_8,$a_rectangle,$control_9 # 144o
        andc    $control_9,$control_15,$outside_9       # 145e
        lnop                                            # 145o pairing
        andc    $control_16,$control_16,$outside        # 146e
        shufb   $t_best_10,$t_best_7,$t_6,$control      # 146o
        rotqbii $control_9,$control_9,1                 # 147o
        rotqbii $control_16,$control_16,1               # 148o
        stqd    $nearest,464($a_packet)                 # 149o
        shufb   $nearest,$nearest_7,$a_rectangle,$control # 150o
        gb      $control,$control_9                     # 151o
        gb      $control_9,$control_16                  # 152o
        stqd    $t_best_10,384($a_packet)               # 153o
        stqd    $nearest,448($a_packet)                 # 154o
        shlqbii $control,$control,4                     # 155o
        shlqbii $control_9,$control_9,4                 # 156o
        stqd    $t_best,400($a_packet)                  # 157o
        hbrr    next_rectangle_short_back,next_rectangle_short # 158o hint
        lqx     $control,$control,$a_controls           # 159o
        lqx     $control_9,$control_9,$a_controls       # 160o
        shufb   $t_best,$t_best_9,$t_7,$control         # 165o
        shufb   $nearest,$nearest_10,$a_rectangle,$control # 166o
        shufb   $t_best_3,$t_best_8,$t_8,$control_9     # 167o
        shufb   $nearest_6,$nearest_9,$a_rectangle,$control_9 # 168o
        stqd    $t_best,432($a_packet)                  # 169o
        stqd    $nearest,496($a_packet)                 # 170o
        stqd    $t_best_3,416($a_packet)                # 171o
        stqd    $nearest_6,480($a_packet)               # 172o
        nop     $127                                    # 173e pairing
next_rectangle_short_back:
        brnz    $count,next_rectangle_short             # 174o
        nop     $127                                    # 174e pairing
        bi      $lr                                     # 174o
endfunction isect_rectangle_pairs_r16
