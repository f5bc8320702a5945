# filter_box_children_r16   of nodes' children, those whose boxes one of a packet's rays may meet
#   C       struct candidate *filter_box_children_r16(const struct candidate *, int count,
#                                                     struct candidate *);
#   In      $3 candidates as cull_box_nodes makes them with 4, $4 count (0 is none), $5 where the
#           list goes, which may be the same place; pointers 16-aligned
#   Out     candidates of such children, in order: object is the child, the rest the candidate's;
#           as many quadwords may be written as there are candidates
#           $3 behind the list
#   Uses    $2-$79   Saves  -   Stack  0   Calls  -
#   Domain  bounds as bound_origins_r16 makes them; |d| = 1 within 4 ulp; half sizes of a child's
#           box with a slack of 2^-18 (|c| + H), c its centre, H half its diagonal; distances from
#           2^-60 to 2^60
#   Error   0: no child is left out that a ray of the packet meets
#   Twin    lab/twins/src/cull_box_nodes.rs
#
# Separating axes, without a division. With f = c - origin and the box's half sizes h, a ray misses
# the box if along one of the axes' cross products with d it passes beside it,
#   |f.y d.z - f.z d.y| > h.y |d.z| + h.z |d.y|, and so on,
# or if the box is behind it: f.d + h.|d| < 0. The half sizes have a slack for the origin, 2^-18
# (|apex| + r), as in filter_children_r16. Both slacks together are 32 ulp of |f| along each axis,
# and the roundings of each comparison add up to less than 8 ulp of |f| (|d.y| + |d.z|).
# Scheduled by spu schedule from filter_box_children_r16.s

        .include "filter_tmpl.inc"

        .set    NEXT,3
        registers a_first                               # candidate
        registers count,a_list
        # constants
        .set    NEXT,10
        registers m_x,m_low,m_extent,m_entry,k_sign,k_slack
        # state
        registers a_candidate
        registers found                                 # children so far
        # the candidate
        registers candidate,a_bound,a_packet,extent,turned
        # the child
        registers m_lane                                # the shuffle that splats its word
        registers cx,cy,cz,half_x,half_y,half_z,child,entry,offset
        # the rays
        registers ox,oy,oz,dx,dy,dz,fx,fy,fz
        registers ax,ay,az                              # |d|
        registers cross_x,cross_y,cross_z,reach_x,reach_y,reach_z,ahead,t
        registers all_miss                              # signs
        registers any
        # the candidate, loaded again instead of being kept in a register for so long
        registers again

        filter_tables .rodata.boxes

function filter_box_children_r16
        .set count_2,79; .set offset_2,60; .set a_packet_2,2; .set ox_2,5; .set ox_3,6; .set fx_2,7
        .set dx_2,8; .set fx_3,19; .set dx_3,22; .set oy_2,6; .set fx_4,5; .set turned_2,30
        .set oy_3,20; .set ahead_2,27; .set ahead_3,29; .set dy_2,32; .set ax_2,49; .set ax_3,28
        .set oz_2,30; .set fx_5,9; .set fy_2,24; .set half_z_2,34; .set fy_3,31; .set oz_3,44
        .set ay_2,41; .set turned_3,47; .set fz_2,30; .set dz_2,33; .set fz_3,35; .set half_y_2,6
        .set dx_4,38; .set dy_3,46; .set fz_4,39; .set half_x_2,18; .set dz_3,44; .set oz_4,45
        .set ahead_4,48; .set dz_4,56; .set fy_4,50; .set dy_4,25; .set fz_5,26; .set dz_5,54
        .set half_y_3,57; .set child_2,6; .set az_2,58; .set ay_3,52; .set half_x_3,21
        .set ahead_5,18; .set child_3,23; .set cross_x_2,48; .set cross_y_2,53; .set az_3,59
        .set reach_x_2,62; .set entry_2,23; .set reach_y_2,55; .set reach_y_3,61; .set az_4,63
        .set cross_x_3,60; .set t_2,23; .set reach_y_4,67; .set t_3,64; .set t_4,20; .set t_5,6
        .set cross_y_3,2; .set cross_x_4,65; .set ay_4,45; .set cross_x_5,66; .set reach_x_3,68
        .set reach_z_2,69; .set cross_y_4,70; .set reach_x_4,71; .set ax_4,72; .set reach_z_3,73
        .set cross_x_6,44; .set cross_y_5,30; .set az_5,53; .set cross_z_2,48; .set reach_y_5,74
        .set cross_z_3,31; .set cross_y_6,35; .set cross_y_7,8; .set reach_y_6,36
        .set reach_x_5,55; .set reach_z_4,43; .set cross_x_7,33; .set cross_y_8,26
        .set reach_z_5,41; .set cross_x_8,40; .set cross_z_4,39; .set cross_z_5,8; .set ahead_6,24
        .set cross_x_9,18; .set cross_z_6,5; .set cross_x_10,22; .set cross_z_7,7
        .set reach_y_7,31; .set reach_x_6,19; .set reach_y_8,32; .set reach_z_6,56
        .set cross_y_9,7; .set cross_x_11,19; .set ahead_7,28; .set cross_x_12,2
        .set cross_x_13,27; .set cross_z_8,26; .set cross_x_14,7; .set cross_x_15,5
        .set reach_z_7,5; .set cross_x_16,6; .set oy_4,2; .set dx_5,7; .set fx_6,6; .set fy_5,2
        .set dx_6,19; .set oy_5,22; .set ax_5,24; .set ahead_8,33; .set fy_6,22; .set oz_5,38
        .set dz_6,48; .set fz_6,38; .set ax_6,47; .set child_4,50; .set cross_x_17,57; .set az_6,50
        .set reach_x_7,54; .set dz_7,55; .set reach_z_8,59; .set reach_z_9,61; .set cross_y_10,63
        .set cross_y_11,23; .set reach_y_9,64; .set cross_z_9,66; .set cross_z_10,68
        .set reach_x_8,69; .set cross_y_12,31; .set az_7,55; .set reach_y_10,50; .set reach_z_10,36
        .set cross_x_18,37; .set reach_x_9,40; .set cross_y_13,42; .set reach_x_10,26; .set t_6,30
        .set cross_y_14,5; .set cross_y_15,19; .set reach_z_11,4; .set cross_z_11,9
        .set cross_z_12,2; .set cross_x_19,4; .set ox_4,2; .set dx_7,2; .set oy_6,8; .set dx_8,9
        .set ahead_9,19; .set oz_6,22; .set fy_7,8; .set dx_9,24; .set oy_7,27; .set fy_8,28
        .set ax_7,31; .set dy_5,33; .set ax_8,34; .set half_x_4,38; .set ahead_10,41; .set fy_9,25
        .set half_z_3,27; .set dy_6,43; .set dy_7,45; .set fz_7,22; .set half_y_4,18; .set ay_5,46
        .set dz_8,47; .set ay_6,49; .set dz_9,50; .set t_7,53; .set t_8,54; .set ahead_11,21
        .set child_5,29; .set az_8,56; .set az_9,57; .set reach_y_11,58; .set cross_x_20,29
        .set reach_x_11,60; .set cross_y_16,55; .set reach_x_12,61; .set cross_y_17,62
        .set reach_y_12,63; .set ay_7,23; .set cross_x_21,32; .set cross_z_13,64
        .set cross_z_14,65; .set reach_z_12,66; .set reach_x_13,67; .set ax_9,68
        .set cross_x_22,70; .set ay_8,71; .set cross_y_18,72; .set reach_y_13,73; .set az_10,74
        .set cross_y_19,75; .set reach_z_13,76; .set cross_x_23,77; .set reach_y_14,78
        .set reach_y_15,22; .set cross_z_15,61; .set reach_y_16,42; .set reach_z_14,58
        .set cross_z_16,36; .set cross_x_24,8; .set reach_z_15,29; .set reach_z_16,33
        .set reach_x_14,37; .set reach_y_17,9; .set cross_x_25,30; .set reach_z_17,23
        .set cross_x_26,25; .set cross_y_20,18; .set cross_z_17,6; .set cross_y_21,22
        .set ahead_12,2; .set ahead_13,8; .set cross_z_18,21; .set cross_y_22,9
        ori     $a_candidate,$a_first,0                 # 0e
        lnop                                            # 0o pairing
        ori     $a_first,$a_list,0                      # 1e
        biz     $count,$lr                              # 1o
        ilhu    $m_x,1                                  # 2e
        lqa     $m_extent,extent_words                  # 2o
        ilhu    $m_low,771                              # 3e
        lqa     $m_entry,entry_words                    # 3o
        clgti   $count_2,$count,1                       # 4e at least as many passes as overlap
        il      $found,0                                # 5e
        ilhu    $k_sign,0x8000                          # 6e
        ilhu    $k_slack,0x3680                         # 7e 2^-18
        iohl    $m_x,515                                # 8e
        lnop                                            # 8o pairing
        iohl    $m_low,771                              # 9e
        brz     $count_2,next_child_short               # 9o too few passes
        ai      $count,$count,-1                        # 10e
        lqd     $candidate,0($a_candidate)              # 10o
        nop     $127                                    # 11e pairing
        lqd     $again,0($a_candidate)                  # 11o
        ai      $a_candidate,$a_candidate,16            # 12e
        shlqbii $offset_2,$found,4                      # 12o
        rotqbyi $a_bound,$candidate,8                   # 16o
        shufb   $m_lane,$candidate,$candidate,$m_low    # 17o
        rotqbyi $a_packet_2,$candidate,4                # 18o
        lqd     $cx,0($candidate)                       # 19o
        nop     $127                                    # 20e pairing
        lqd     $turned,192($a_bound)                   # 20o
        andbi   $m_lane,$m_lane,15                      # 21e
        lqd     $extent,160($a_bound)                   # 21o
        nop     $127                                    # 22e pairing
        lqd     $ox,16($a_packet_2)                     # 22o
        a       $m_lane,$m_lane,$m_x                    # 23e
        lqd     $ox_2,0($a_packet_2)                    # 23o
        lqd     $ox_3,32($a_packet_2)                   # 24o
        shufb   $cx,$cx,$cx,$m_lane                     # 25o
        lqd     $cy,16($candidate)                      # 26o
        shufb   $extent,$extent,$turned,$m_extent       # 27o
        nop     $127                                    # 28e pairing
        lqd     $dx,192($a_packet_2)                    # 28o
        fs      $fx_2,$cx,$ox                           # 29e
        lqd     $dx_2,208($a_packet_2)                  # 29o
        fs      $fx_3,$cx,$ox_3                         # 30e
        lqd     $dx_3,224($a_packet_2)                  # 30o
        andc    $extent,$extent,$k_sign                 # 31e
        lqd     $oy_2,80($a_packet_2)                   # 31o
        fs      $fx_4,$cx,$ox_2                         # 32e
        lqd     $oy,96($a_packet_2)                     # 32o
        nop     $127                                    # 33e pairing
        rotqbyi $turned_2,$extent,8                     # 33o
        andc    $ax,$dx,$k_sign                         # 34e
        lqd     $oy_3,64($a_packet_2)                   # 34o
        fm      $ahead_2,$fx_2,$dx_2                    # 35e
        lqd     $ox,48($a_packet_2)                     # 35o
        fm      $ahead_3,$fx_3,$dx_3                    # 36e
        lqd     $cz,32($candidate)                      # 36o
        fa      $extent,$extent,$turned_2               # 37e
        lqd     $dy_2,256($a_packet_2)                  # 37o
        fm      $ahead,$fx_4,$dx                        # 38e
        shufb   $cy,$cy,$cy,$m_lane                     # 38o
        andc    $ax_2,$dx_2,$k_sign                     # 39e
        lqd     $oz,144($a_packet_2)                    # 39o
        andc    $ax_3,$dx_3,$k_sign                     # 40e
        lqd     $oz_2,128($a_packet_2)                  # 40o
        fs      $fx_5,$cx,$ox                           # 41e
        lqd     $dy,272($a_packet_2)                    # 41o
        fs      $fy_2,$cy,$oy_2                         # 42e
        shufb   $cz,$cz,$cz,$m_lane                     # 42o
        fs      $fy,$cy,$oy                             # 43e
        lqd     $half_z_2,80($candidate)                # 43o
        fs      $fy_3,$cy,$oy_3                         # 44e
        lqd     $oz_3,160($a_packet_2)                  # 44o
        andc    $ay_2,$dy_2,$k_sign                     # 45e
        rotqbyi $turned_3,$extent,4                     # 45o
        fs      $fz_2,$cz,$oz_2                         # 46e
        lqd     $dz_2,336($a_packet_2)                  # 46o
        fs      $fz_3,$cz,$oz                           # 47e
        lqd     $half_y_2,64($candidate)                # 47o
        fma     $ahead_2,$fy_2,$dy,$ahead_2             # 48e
        lqd     $dx_4,240($a_packet_2)                  # 48o
        fa      $extent,$extent,$turned_3               # 49e
        lqd     $oy_3,112($a_packet_2)                  # 49o
        fma     $ahead,$fy_3,$dy_2,$ahead               # 50e
        lqd     $dy_3,288($a_packet_2)                  # 50o
        fs      $fz_4,$cz,$oz_3                         # 51e
        lqd     $half_x_2,48($candidate)                # 51o
        andc    $ay,$dy,$k_sign                         # 52e
        lqd     $dz_3,320($a_packet_2)                  # 52o
        fm      $cross_z,$fy_2,$dx_2                    # 53e
        lqd     $oz_4,176($a_packet_2)                  # 53o
        fm      $ahead_4,$fx_5,$dx_4                    # 54e
        lqd     $dz_4,352($a_packet_2)                  # 54o
        fs      $fy_4,$cy,$oy_3                         # 55e
        shufb   $half_y_2,$half_y_2,$half_y_2,$m_lane   # 55o
        fma     $ahead_3,$fy,$dy_3,$ahead_3             # 56e
        lqd     $dy_4,304($a_packet_2)                  # 56o
        fma     $ahead_2,$fz_3,$dz_2,$ahead_2           # 57e
        shufb   $half_x_2,$half_x_2,$half_x_2,$m_lane   # 57o
        fma     $ahead,$fz_2,$dz_3,$ahead               # 58e
        shufb   $half_z_2,$half_z_2,$half_z_2,$m_lane   # 58o
        fs      $fz_5,$cz,$oz_4                         # 59e
        lqd     $dz_5,368($a_packet_2)                  # 59o
        fma     $half_y_3,$extent,$k_slack,$half_y_2    # 60e
        lqd     $child_2,96($again)                     # 60o
        andc    $az_2,$dz_4,$k_sign                     # 61e
        fma     $ahead_3,$fz_4,$dz_4,$ahead_3           # 62e
        andc    $ay_3,$dy_3,$k_sign                     # 63e
        fma     $half_z_2,$extent,$k_slack,$half_z_2    # 64e
        fma     $half_x_3,$extent,$k_slack,$half_x_2    # 65e
        lnop                                            # 65o pairing
        fma     $ahead_5,$fy_4,$dy_4,$ahead_4           # 66e
        shufb   $child_3,$child_2,$child_2,$m_lane      # 66o
        fm      $cross_x_2,$fz_2,$dy_2                  # 67e
        fm      $cross_y_2,$fx_4,$dz_3                  # 68e
        andc    $az_3,$dz_3,$k_sign                     # 69e
        lnop                                            # 69o pairing
        fm      $reach_x_2,$half_z_2,$ay                # 70e
        shufb   $entry_2,$child_3,$again,$m_entry       # 70o
        fma     $ahead,$half_x_3,$ax,$ahead             # 71e
        fm      $reach_y_2,$half_x_3,$az_2              # 72e
        fm      $reach_y_3,$half_x_3,$az_3              # 73e
        lnop                                            # 73o pairing
        andc    $az_4,$dz_2,$k_sign                     # 74e
        stqx    $entry_2,$a_first,$offset_2             # 74o
        fm      $cross_x_3,$fz_5,$dy_4                  # 75e
        lqd     $t_2,416($a_packet_2)                   # 75o
        fm      $reach_y_4,$half_x_3,$az_4              # 76e
        lqd     $t_3,400($a_packet_2)                   # 76o
        fma     $ahead_2,$half_x_3,$ax_2,$ahead_2       # 77e
        lqd     $t_4,432($a_packet_2)                   # 77o
        fma     $ahead_3,$half_x_3,$ax_3,$ahead_3       # 78e
        lqd     $t_5,384($a_packet_2)                   # 78o
        fm      $cross_y_3,$fx_3,$dz_4                  # 79e
        fm      $cross_x_4,$fz_3,$dy                    # 80e
        andc    $ay_4,$dy_4,$k_sign                     # 81e
        fma     $ahead_5,$fz_5,$dz_5,$ahead_5           # 82e
        fma     $ahead_2,$half_y_3,$ay,$ahead_2         # 83e
        fm      $cross_x_5,$fz_4,$dy_3                  # 84e
        fm      $reach_x_3,$half_z_2,$ay_3              # 85e
        fm      $reach_z_2,$half_y_3,$ax                # 86e
        fm      $cross_y_4,$fx_2,$dz_2                  # 87e
        fma     $ahead_3,$half_y_3,$ay_3,$ahead_3       # 88e
        fm      $reach_x_4,$half_z_2,$ay_2              # 89e
        andc    $ax_4,$dx_4,$k_sign                     # 90e
        fma     $reach_x_3,$half_y_3,$az_2,$reach_x_3   # 91e
        fm      $reach_z_3,$half_y_3,$ax_2              # 92e
        fms     $cross_x_6,$fy_3,$dz_3,$cross_x_2       # 93e
        fms     $cross_y_5,$fz_2,$dx,$cross_y_2         # 94e
        andc    $az_5,$dz_5,$k_sign                     # 95e
        fm      $cross_z_2,$fy,$dx_3                    # 96e
        fm      $reach_y_5,$half_x_3,$az_5              # 97e
        fm      $cross_z_3,$fy_3,$dx                    # 98e
        fms     $cross_y_6,$fz_3,$dx_2,$cross_y_4       # 99e
        fm      $cross_y_7,$fx_5,$dz_5                  # 100e
        fma     $reach_y_6,$half_z_2,$ax_3,$reach_y_2   # 101e
        fma     $reach_x_2,$half_y_3,$az_4,$reach_x_2   # 102e
        fm      $reach_x_5,$half_z_2,$ay_4              # 103e
        fma     $ahead,$half_y_3,$ay_2,$ahead           # 104e
        fma     $reach_z_4,$half_x_3,$ay,$reach_z_3     # 105e
        fma     $ahead_5,$half_x_3,$ax_4,$ahead_5       # 106e
        fms     $cross_x_7,$fy_2,$dz_2,$cross_x_4       # 107e
        fms     $cross_y_8,$fz_5,$dx_4,$cross_y_7       # 108e
        fma     $reach_x_5,$half_y_3,$az_5,$reach_x_5   # 109e
        fma     $reach_z_5,$half_x_3,$ay_2,$reach_z_2   # 110e
        fma     $ahead,$half_z_2,$az_3,$ahead           # 111e
        fms     $cross_y_3,$fz_4,$dx_3,$cross_y_3       # 112e
        fms     $cross_x_8,$fy,$dz_4,$cross_x_5         # 113e
        fm      $cross_z_4,$fy_4,$dx_4                  # 114e
        fms     $cross_z_5,$fx_3,$dy_3,$cross_z_2       # 115e
        fma     $ahead_3,$half_z_2,$az_2,$ahead_3       # 116e
        fma     $reach_y,$half_z_2,$ax_2,$reach_y_4     # 117e
        fma     $ahead_6,$half_y_3,$ay_4,$ahead_5       # 118e
        fcmgt   $cross_x_9,$cross_x_8,$reach_x_3        # 119e
        fms     $cross_z_6,$fx_4,$dy_2,$cross_z_3       # 120e
        fms     $cross_x_10,$fy_4,$dz_5,$cross_x_3      # 121e
        fcmgt   $cross_y_3,$cross_y_3,$reach_y_6        # 122e
        fcmgt   $cross_y_6,$cross_y_6,$reach_y          # 123e
        fms     $cross_z_7,$fx_2,$dy,$cross_z           # 124e
        fma     $reach_y_7,$half_z_2,$ax,$reach_y_3     # 125e
        fma     $reach_x_6,$half_y_3,$az_3,$reach_x_4   # 126e
        fma     $reach_y_8,$half_z_2,$ax_4,$reach_y_5   # 127e
        fcmgt   $cross_z_6,$cross_z_6,$reach_z_5        # 128e
        fm      $reach_z_6,$half_y_3,$ax_3              # 129e
        fcmgt   $cross_z,$cross_z_7,$reach_z_4          # 130e
        fcmgt   $cross_y_9,$cross_y_5,$reach_y_7        # 131e
        fcmgt   $cross_x_11,$cross_x_6,$reach_x_6       # 132e
        fma     $ahead_7,$half_z_2,$az_4,$ahead_2       # 133e
        or      $cross_x_12,$cross_x_9,$cross_y_3       # 134e
        fcmgt   $cross_y,$cross_y_8,$reach_y_8          # 135e
        fm      $reach_z_5,$half_y_3,$ax_4              # 136e
        fcmgt   $cross_x_9,$cross_x_7,$reach_x_2        # 137e
        or      $cross_x_13,$cross_x_12,$t_2            # 138e
        or      $cross_x_12,$cross_x_9,$cross_y_6       # 139e
        or      $cross_z,$cross_z,$ahead_7              # 140e
        or      $cross_x_12,$cross_x_12,$t_3            # 141e
        or      $cross_z_8,$cross_z_6,$ahead            # 142e
        or      $cross_x_14,$cross_x_11,$cross_y_9      # 143e
        fcmgt   $cross_x_15,$cross_x_10,$reach_x_5      # 144e
next_child:
            fma     $reach_z,$half_x_3,$ay_4,$reach_z_5 # 0e
            lnop                                        # 0o pairing
            or      $cross_x,$cross_x_12,$cross_z       # 1e
        lqd     $candidate,0($a_candidate)              # 1o
            or      $cross_x_12,$cross_x_15,$cross_y    # 2e
            fma     $reach_z_7,$half_x_3,$ay_3,$reach_z_6 # 3e
            fma     $ahead,$half_z_2,$az_5,$ahead_6     # 4e
            fms     $cross_z,$fx_5,$dy_4,$cross_z_4     # 5e
            or      $cross_x_16,$cross_x_14,$t_5        # 6e
            lnop                                        # 6o pairing
            or      $cross_x_12,$cross_x_12,$t_4        # 7e
        rotqbyi $a_bound,$candidate,8                   # 7o
            or      $all_miss,$cross_x_16,$cross_z_8    # 8e
        rotqbyi $a_packet,$candidate,4                  # 8o
            fcmgt   $cross_z_6,$cross_z_5,$reach_z_7    # 9e
        shufb   $m_lane,$candidate,$candidate,$m_low    # 9o
            and     $all_miss,$all_miss,$cross_x        # 10e
        lqd     $again,0($a_candidate)                  # 10o
            or      $cross_z_6,$cross_z_6,$ahead_3      # 11e
        lqd     $extent,160($a_bound)                   # 11o
            fcmgt   $cross_z,$cross_z,$reach_z          # 12e
        lqd     $turned,192($a_bound)                   # 12o
        andbi   $m_lane,$m_lane,15                      # 13e
        lqd     $cx,0($candidate)                       # 13o
            or      $cross_z,$cross_z,$ahead            # 14e
        lqd     $oy,96($a_packet)                       # 14o
            or      $cross_x,$cross_x_13,$cross_z_6     # 15e
        lqd     $ox,16($a_packet)                       # 15o
            or      $cross_x_12,$cross_x_12,$cross_z    # 16e
        lqd     $cy,16($candidate)                      # 16o
        a       $m_lane,$m_lane,$m_x                    # 17e
        lqd     $ox_2,0($a_packet)                      # 17o
            and     $all_miss,$all_miss,$cross_x        # 18e
        shufb   $extent,$extent,$turned,$m_extent       # 18o
        ai      $count,$count,-1                        # 19e
        shufb   $cx,$cx,$cx,$m_lane                     # 19o
            and     $all_miss,$all_miss,$cross_x_12     # 20e
        lqd     $oy_4,80($a_packet)                     # 20o
        ai      $a_candidate,$a_candidate,16            # 21e
        lqd     $ox_3,32($a_packet)                     # 21o
            nor     $any,$all_miss,$all_miss            # 22e
        shufb   $cy,$cy,$cy,$m_lane                     # 22o
        andc    $extent,$extent,$k_sign                 # 23e
        lqd     $dx,192($a_packet)                      # 23o
        fs      $fx,$cx,$ox                             # 24e
        lqd     $ox,48($a_packet)                       # 24o
        fs      $fx_4,$cx,$ox_2                         # 25e
        lnop                                            # 25o pairing
        fs      $fy,$cy,$oy                             # 26e
        lqd     $dx_5,224($a_packet)                    # 26o
        fs      $fx_6,$cx,$ox_3                         # 27e
        lqd     $dx_2,208($a_packet)                    # 27o
        fs      $fy_5,$cy,$oy_4                         # 28e
        lqd     $half_y,64($candidate)                  # 28o
        andc    $ax,$dx,$k_sign                         # 29e
        lqd     $oy,64($a_packet)                       # 29o
        fs      $fx_5,$cx,$ox                           # 30e
        lqd     $dx_6,240($a_packet)                    # 30o
        fm      $ahead,$fx_4,$dx                        # 31e
        lqd     $oy_5,112($a_packet)                    # 31o
        andc    $ax_5,$dx_5,$k_sign                     # 32e
        lqd     $cz,32($candidate)                      # 32o
        fm      $ahead_2,$fx,$dx_2                      # 33e
        lqd     $dy,272($a_packet)                      # 33o
        fm      $ahead_3,$fx_6,$dx_5                    # 34e
        rotqbyi $turned_2,$extent,8                     # 34o
        fs      $fy_3,$cy,$oy                           # 35e
        lqd     $dy_2,256($a_packet)                    # 35o
        fm      $ahead_8,$fx_5,$dx_6                    # 36e
        lqd     $oz,144($a_packet)                      # 36o
        fs      $fy_6,$cy,$oy_5                         # 37e
        lqd     $dy_4,304($a_packet)                    # 37o
        fa      $extent,$extent,$turned_2               # 38e
        shufb   $cz,$cz,$cz,$m_lane                     # 38o
        fma     $ahead_2,$fy_5,$dy,$ahead_2             # 39e
        lqd     $oz_2,128($a_packet)                    # 39o
        andc    $ay,$dy,$k_sign                         # 40e
        lqd     $half_z_2,80($candidate)                # 40o
        fma     $ahead,$fy_3,$dy_2,$ahead               # 41e
        lqd     $oz_5,176($a_packet)                    # 41o
        andc    $ay_2,$dy_2,$k_sign                     # 42e
        lqd     $oz_3,160($a_packet)                    # 42o
        andc    $ay_4,$dy_4,$k_sign                     # 43e
        lqd     $dy_3,288($a_packet)                    # 43o
        fs      $fz_3,$cz,$oz                           # 44e
        rotqbyi $turned_3,$extent,4                     # 44o
        fs      $fz_2,$cz,$oz_2                         # 45e
        shufb   $half_y,$half_y,$half_y,$m_lane         # 45o
        fma     $ahead_8,$fy_6,$dy_4,$ahead_8           # 46e
        lqd     $dz_6,368($a_packet)                    # 46o
        andc    $ax_2,$dx_2,$k_sign                     # 47e
        lqd     $half_x_2,48($candidate)                # 47o
        fs      $fz_6,$cz,$oz_5                         # 48e
        shufb   $half_z_2,$half_z_2,$half_z_2,$m_lane   # 48o
        andc    $ay_3,$dy_3,$k_sign                     # 49e
        fs      $fz_5,$cz,$oz_3                         # 50e
        fa      $extent,$extent,$turned_3               # 51e
        lnop                                            # 51o pairing
        fma     $ahead_3,$fy,$dy_3,$ahead_3             # 52e
        lqd     $dz_3,336($a_packet)                    # 52o
        andc    $ax_6,$dx_6,$k_sign                     # 53e
        shufb   $half_x_2,$half_x_2,$half_x_2,$m_lane   # 53o
        fma     $ahead_8,$fz_6,$dz_6,$ahead_8           # 54e
        lqd     $child_4,96($again)                     # 54o
        andc    $az_5,$dz_6,$k_sign                     # 55e
        lqd     $dz_4,352($a_packet)                    # 55o
        fm      $cross_x_17,$fz_5,$dy_3                 # 56e
            rotmai  $any,$any,-31                       # 57e
        andc    $az_2,$dz_3,$k_sign                     # 58e
        fma     $half_z_2,$extent,$k_slack,$half_z_2    # 59e
        fma     $half_y,$extent,$k_slack,$half_y        # 60e
        shufb   $child_3,$child_4,$child_4,$m_lane      # 60o
        fma     $ahead_3,$fz_5,$dz_4,$ahead_3           # 61e
            orx     $any,$any                           # 61o all ones if a ray may meet the box
        fma     $half_x_3,$extent,$k_slack,$half_x_2    # 62e
        fm      $cross_x_9,$fz_2,$dy_2                  # 63e
        andc    $az_6,$dz_4,$k_sign                     # 64e
        lnop                                            # 64o pairing
            sf      $found,$any,$found                  # 65e
        shufb   $entry_2,$child_3,$again,$m_entry       # 65o
        fm      $reach_x_7,$half_z_2,$ay_3              # 66e
        lqd     $dz_7,320($a_packet)                    # 66o
        fm      $reach_z_8,$half_y,$ax                  # 67e
        shlqbii $offset_2,$found,4                      # 67o
        fm      $reach_z_9,$half_y,$ax_2                # 68e
        fm      $reach_x_2,$half_z_2,$ay                # 69e
        fma     $ahead_3,$half_x_3,$ax_5,$ahead_3       # 70e
        lnop                                            # 70o pairing
        fm      $cross_y_10,$fx,$dz_3                   # 71e
        stqx    $entry_2,$a_first,$offset_2             # 71o
        fma     $ahead,$fz_2,$dz_7,$ahead               # 72e
        fm      $cross_y_11,$fx_6,$dz_4                 # 73e
        fm      $cross_x_3,$fz_6,$dy_4                  # 74e
        fm      $reach_y_9,$half_x_3,$az_5              # 75e
        fm      $cross_x_4,$fz_3,$dy                    # 76e
        fm      $cross_z_9,$fy,$dx_5                    # 77e
        fma     $ahead_2,$fz_3,$dz_3,$ahead_2           # 78e
        fma     $ahead_3,$half_y,$ay_3,$ahead_3         # 79e
        fm      $reach_y_4,$half_x_3,$az_2              # 80e
        fm      $cross_z_10,$fy_3,$dx                   # 81e
        fma     $ahead,$half_x_3,$ax,$ahead             # 82e
        fma     $reach_x_2,$half_y,$az_2,$reach_x_2     # 83e
        fma     $ahead_2,$half_x_3,$ax_2,$ahead_2       # 84e
        fm      $reach_x_8,$half_z_2,$ay_4              # 85e
        fms     $cross_x_9,$fy_3,$dz_7,$cross_x_9       # 86e
        fm      $cross_y_12,$fx_4,$dz_7                 # 87e
        fma     $ahead_3,$half_z_2,$az_6,$ahead_3       # 88e
        fma     $reach_z_8,$half_x_3,$ay_2,$reach_z_8   # 89e
        fma     $reach_y,$half_z_2,$ax_2,$reach_y_4     # 90e
        fma     $ahead_2,$half_y,$ay,$ahead_2           # 91e
        fma     $reach_x_7,$half_y,$az_6,$reach_x_7     # 92e
        andc    $az_7,$dz_7,$k_sign                     # 93e
        fma     $ahead,$half_y,$ay_2,$ahead             # 94e
        fms     $cross_y_6,$fz_3,$dx_2,$cross_y_10      # 95e
        fm      $cross_z_5,$fy_5,$dx_2                  # 96e
        fms     $cross_x_8,$fy,$dz_4,$cross_x_17        # 97e
        fm      $reach_y_10,$half_x_3,$az_6             # 98e
        fm      $reach_z_6,$half_y,$ax_5                # 99e
        fms     $cross_y_5,$fz_2,$dx,$cross_y_12        # 100e
        fm      $reach_y_7,$half_x_3,$az_7              # 101e
        fms     $cross_z_5,$fx,$dy,$cross_z_5           # 102e
        fma     $reach_z_10,$half_x_3,$ay,$reach_z_9    # 103e
        fcmgt   $cross_x_18,$cross_x_8,$reach_x_7       # 104e
        fm      $cross_z_4,$fy_6,$dx_6                  # 105e
        fma     $ahead_8,$half_x_3,$ax_6,$ahead_8       # 106e
        fma     $ahead,$half_z_2,$az_7,$ahead           # 107e
        fma     $reach_y_7,$half_z_2,$ax,$reach_y_7     # 108e
        fm      $reach_x_9,$half_z_2,$ay_2              # 109e
        fm      $reach_z_5,$half_y,$ax_6                # 110e
        fm      $cross_y_13,$fx_5,$dz_6                 # 111e
        fcmgt   $cross_y_6,$cross_y_6,$reach_y          # 112e
        fms     $cross_y_9,$fz_5,$dx_5,$cross_y_11      # 113e
        fcmgt   $cross_y_11,$cross_y_5,$reach_y_7       # 114e
        fma     $reach_x_10,$half_y,$az_7,$reach_x_9    # 115e
        fms     $cross_x_12,$fy_5,$dz_3,$cross_x_4      # 116e
        fms     $cross_z_6,$fx_4,$dy_2,$cross_z_10      # 117e
        fma     $reach_y,$half_z_2,$ax_5,$reach_y_10    # 118e
        fma     $ahead_6,$half_y,$ay_4,$ahead_8         # 119e
        fms     $cross_x_10,$fy_6,$dz_6,$cross_x_3      # 120e
        lqd     $t_6,400($a_packet)                     # 120o
        fma     $reach_y_7,$half_z_2,$ax_6,$reach_y_9   # 121e
        lnop                                            # 121o pairing
        fcmgt   $cross_x_12,$cross_x_12,$reach_x_2      # 122e
        hbrr    next_child_back,next_child              # 122o hint
        fcmgt   $cross_x_9,$cross_x_9,$reach_x_10       # 123e
        or      $cross_x_12,$cross_x_12,$cross_y_6      # 124e
        fcmgt   $cross_z,$cross_z_6,$reach_z_8          # 125e
        or      $cross_x_12,$cross_x_12,$t_6            # 126e
        fcmgt   $cross_y_14,$cross_y_9,$reach_y         # 127e
        or      $cross_x_14,$cross_x_9,$cross_y_11      # 128e
        fma     $ahead_5,$half_z_2,$az_2,$ahead_2       # 129e
        or      $cross_x_15,$cross_x_18,$cross_y_14     # 130e
        fma     $reach_x,$half_y,$az_5,$reach_x_8       # 131e
        lqd     $t_2,416($a_packet)                     # 131o
        fms     $cross_y_15,$fz_6,$dx_6,$cross_y_13     # 132e
        or      $cross_z_8,$cross_z,$ahead              # 133e
        fcmgt   $cross_z,$cross_z_5,$reach_z_10         # 134e
        fms     $cross_z_5,$fx_6,$dy_3,$cross_z_9       # 135e
        or      $cross_z,$cross_z,$ahead_5              # 136e
        lnop                                            # 136o pairing
        or      $cross_x_13,$cross_x_15,$t_2            # 137e
        lqd     $t_5,384($a_packet)                     # 137o
        fcmgt   $cross_x_15,$cross_x_10,$reach_x        # 138e
        lqd     $t_4,432($a_packet)                     # 138o
        fcmgt   $cross_y,$cross_y_15,$reach_y_7         # 139e
next_child_back:
        brnz    $count,next_child                       # 139o
next_child_drain:
        fma     $reach_z_11,$half_x_3,$ay_3,$reach_z_6  # 0e
        hbr     filter_box_children_r16_return,$lr      # 0o hint
        fma     $reach_z,$half_x_3,$ay_4,$reach_z_5     # 1e
        fms     $cross_z_11,$fx_5,$dy_4,$cross_z_4      # 2e
        fma     $ahead,$half_z_2,$az_5,$ahead_6         # 3e
        or      $cross_x_16,$cross_x_14,$t_5            # 4e
        or      $cross_x,$cross_x_12,$cross_z           # 5e
        fcmgt   $cross_z_12,$cross_z_5,$reach_z_11      # 6e
        or      $cross_x_19,$cross_x_15,$cross_y        # 7e
        or      $all_miss,$cross_x_16,$cross_z_8        # 8e
        or      $cross_z_6,$cross_z_12,$ahead_3         # 9e
        fcmgt   $cross_z,$cross_z_11,$reach_z           # 10e
        or      $cross_x_12,$cross_x_19,$t_4            # 11e
        and     $all_miss,$all_miss,$cross_x            # 12e
        or      $cross_z,$cross_z,$ahead                # 13e
        or      $cross_x,$cross_x_13,$cross_z_6         # 14e
        or      $cross_x_12,$cross_x_12,$cross_z        # 15e
        and     $all_miss,$all_miss,$cross_x            # 16e
        and     $all_miss,$all_miss,$cross_x_12         # 18e
        nor     $any,$all_miss,$all_miss                # 20e
        rotmai  $any,$any,-31                           # 22e
        orx     $any,$any                               # 26o all ones if a ray may meet the box
        sf      $found,$any,$found                      # 30e
        shli    $found,$found,4                         # 32e
        a       $a_first,$a_first,$found                # 36e
filter_box_children_r16_return:
        bi      $lr                                     # 36o
next_child_short:
        ai      $count,$count,-1                        # 0e
        lqd     $candidate,0($a_candidate)              # 0o
        nop     $127                                    # 1e pairing
        lqd     $again,0($a_candidate)                  # 1o
        ai      $a_candidate,$a_candidate,16            # 2e
        shlqbii $offset,$found,4                        # 2o
        rotqbyi $a_bound,$candidate,8                   # 6o
        shufb   $m_lane,$candidate,$candidate,$m_low    # 7o
        rotqbyi $a_packet,$candidate,4                  # 8o
        lqd     $cx,0($candidate)                       # 9o
        nop     $127                                    # 10e pairing
        lqd     $turned,192($a_bound)                   # 10o
        andbi   $m_lane,$m_lane,15                      # 11e
        lqd     $extent,160($a_bound)                   # 11o
        nop     $127                                    # 12e pairing
        lqd     $ox,16($a_packet)                       # 12o
        a       $m_lane,$m_lane,$m_x                    # 13e
        lqd     $cy,16($candidate)                      # 13o
        lqd     $ox_4,0($a_packet)                      # 14o
        lqd     $ox_2,32($a_packet)                     # 15o
        shufb   $cx,$cx,$cx,$m_lane                     # 16o
        shufb   $extent,$extent,$turned,$m_extent       # 17o
        lqd     $ox_3,48($a_packet)                     # 18o
        lqd     $oy,64($a_packet)                       # 19o
        fs      $fx,$cx,$ox_4                           # 20e
        lqd     $dx,192($a_packet)                      # 20o
        andc    $extent,$extent,$k_sign                 # 21e
        lqd     $dx_7,208($a_packet)                    # 21o
        fs      $fx_2,$cx,$ox                           # 22e
        shufb   $cy,$cy,$cy,$m_lane                     # 22o
        fs      $fx_4,$cx,$ox_2                         # 23e
        rotqbyi $turned,$extent,8                       # 23o
        fs      $fx_6,$cx,$ox_3                         # 24e
        lqd     $oy_6,80($a_packet)                     # 24o
        nop     $127                                    # 25e pairing
        lqd     $cz,32($candidate)                      # 25o
        fs      $fy,$cy,$oy                             # 26e
        lqd     $oy,96($a_packet)                       # 26o
        fa      $extent,$extent,$turned                 # 27e
        lqd     $dx_8,224($a_packet)                    # 27o
        fm      $ahead,$fx,$dx                          # 28e
        lqd     $oz,128($a_packet)                      # 28o
        fm      $ahead_9,$fx_2,$dx_7                    # 29e
        lqd     $oz_6,144($a_packet)                    # 29o
        fs      $fy_7,$cy,$oy_6                         # 30e
        lqd     $dx_9,240($a_packet)                    # 30o
        andc    $ax,$dx,$k_sign                         # 31e
        lqd     $oy_7,112($a_packet)                    # 31o
        fs      $fy_8,$cy,$oy                           # 32e
        lqd     $dy,256($a_packet)                      # 32o
        fm      $ahead_3,$fx_4,$dx_8                    # 33e
        rotqbyi $turned_2,$extent,4                     # 33o
        andc    $ax_7,$dx_7,$k_sign                     # 34e
        lqd     $dy_5,272($a_packet)                    # 34o
        andc    $ax_8,$dx_8,$k_sign                     # 35e
        lqd     $half_x_4,48($candidate)                # 35o
        fm      $ahead_10,$fx_6,$dx_9                   # 36e
        shufb   $cz,$cz,$cz,$m_lane                     # 36o
        fs      $fy_9,$cy,$oy_7                         # 37e
        lqd     $half_z_3,80($candidate)                # 37o
        fma     $ahead,$fy,$dy,$ahead                   # 38e
        lqd     $dy_6,288($a_packet)                    # 38o
        fa      $extent,$extent,$turned_2               # 39e
        lqd     $oz_2,160($a_packet)                    # 39o
        fs      $fz_3,$cz,$oz                           # 40e
        lqd     $oz_3,176($a_packet)                    # 40o
        fma     $ahead_9,$fy_7,$dy_5,$ahead_9           # 41e
        lqd     $dy_7,304($a_packet)                    # 41o
        fs      $fz_7,$cz,$oz_6                         # 42e
        lqd     $half_y_4,64($candidate)                # 42o
        andc    $ay_5,$dy_5,$k_sign                     # 43e
        lqd     $dz_8,336($a_packet)                    # 43o
        fma     $ahead_3,$fy_8,$dy_6,$ahead_3           # 44e
        lqd     $dz_6,320($a_packet)                    # 44o
        fs      $fz_2,$cz,$oz_2                         # 45e
        shufb   $half_x_4,$half_x_4,$half_x_4,$m_lane   # 45o
        fs      $fz_5,$cz,$oz_3                         # 46e
        lqd     $dz_3,352($a_packet)                    # 46o
        fma     $ahead_10,$fy_9,$dy_7,$ahead_10         # 47e
        shufb   $half_z_3,$half_z_3,$half_z_3,$m_lane   # 47o
        andc    $ay_6,$dy,$k_sign                       # 48e
        lqd     $dz_9,368($a_packet)                    # 48o
        fma     $half_x_4,$extent,$k_slack,$half_x_4    # 49e
        shufb   $half_y_4,$half_y_4,$half_y_4,$m_lane   # 49o
        fma     $ahead,$fz_3,$dz_6,$ahead               # 50e
        lqd     $t,400($a_packet)                       # 50o
        fma     $ahead_9,$fz_7,$dz_8,$ahead_9           # 51e
        lqd     $t_7,384($a_packet)                     # 51o
        fma     $half_z_3,$extent,$k_slack,$half_z_3    # 52e
        lqd     $t_8,416($a_packet)                     # 52o
        fma     $half_y_4,$extent,$k_slack,$half_y_4    # 53e
        lqd     $t_4,432($a_packet)                     # 53o
        fma     $ahead_11,$fz_2,$dz_3,$ahead_3          # 54e
        lqd     $child_5,96($again)                     # 54o
        fma     $ahead_10,$fz_5,$dz_9,$ahead_10         # 55e
        andc    $az_8,$dz_8,$k_sign                     # 56e
        fma     $ahead_9,$half_x_4,$ax_7,$ahead_9       # 57e
        andc    $az_9,$dz_6,$k_sign                     # 58e
        fma     $ahead,$half_x_4,$ax,$ahead             # 59e
        lnop                                            # 59o pairing
        fm      $reach_y_11,$half_x_4,$az_9             # 60e
        shufb   $child_3,$child_5,$child_5,$m_lane      # 60o
        fm      $cross_x_20,$fz_7,$dy_5                 # 61e
        andc    $az_3,$dz_3,$k_sign                     # 62e
        fma     $ahead_11,$half_x_4,$ax_8,$ahead_11     # 63e
        lnop                                            # 63o pairing
        fm      $reach_x_11,$half_z_3,$ay_6             # 64e
        shufb   $entry_2,$child_3,$again,$m_entry       # 64o
        fm      $cross_y_16,$fx,$dz_6                   # 65e
        fm      $reach_x_12,$half_z_3,$ay_5             # 66e
        fm      $cross_y_17,$fx_2,$dz_8                 # 67e
        lnop                                            # 67o pairing
        fm      $reach_y_12,$half_x_4,$az_8             # 68e
        stqx    $entry_2,$a_first,$offset               # 68o
        andc    $ay_7,$dy_6,$k_sign                     # 69e
        fm      $cross_x_21,$fz_3,$dy                   # 70e
        fm      $cross_z_13,$fy,$dx                     # 71e
        fm      $cross_z_14,$fy_7,$dx_7                 # 72e
        fm      $reach_z_12,$half_y_4,$ax_7             # 73e
        fm      $reach_x_13,$half_z_3,$ay_7             # 74e
        andc    $ax_9,$dx_9,$k_sign                     # 75e
        fm      $reach_z_2,$half_y_4,$ax                # 76e
        fm      $cross_x_22,$fz_2,$dy_6                 # 77e
        andc    $ay_8,$dy_7,$k_sign                     # 78e
        fma     $ahead_10,$half_x_4,$ax_9,$ahead_10     # 79e
        fm      $cross_y_18,$fx_4,$dz_3                 # 80e
        fm      $reach_y_13,$half_x_4,$az_3             # 81e
        andc    $az_10,$dz_9,$k_sign                    # 82e
        fm      $cross_y_19,$fx_6,$dz_9                 # 83e
        fma     $ahead,$half_y_4,$ay_6,$ahead           # 84e
        fma     $ahead_9,$half_y_4,$ay_5,$ahead_9       # 85e
        fm      $reach_z_13,$half_y_4,$ax_8             # 86e
        fm      $cross_x_23,$fz_5,$dy_7                 # 87e
        fm      $reach_y_14,$half_x_4,$az_10            # 88e
        fms     $cross_x_21,$fy,$dz_6,$cross_x_21       # 89e
        fma     $reach_x,$half_y_4,$az_8,$reach_x_12    # 90e
        fms     $cross_y_3,$fz_7,$dx_7,$cross_y_17      # 91e
        fma     $reach_y_15,$half_z_3,$ax_7,$reach_y_12 # 92e
        fm      $cross_z_3,$fy_8,$dx_8                  # 93e
        fm      $reach_x_9,$half_z_3,$ay_8              # 94e
        fm      $cross_z_15,$fy_9,$dx_9                 # 95e
        fma     $reach_x_11,$half_y_4,$az_9,$reach_x_11 # 96e
        fma     $reach_y_16,$half_z_3,$ax,$reach_y_11   # 97e
        fm      $reach_z_14,$half_y_4,$ax_9             # 98e
        fms     $cross_y_6,$fz_3,$dx,$cross_y_16        # 99e
        fms     $cross_z_16,$fx,$dy,$cross_z_13         # 100e
        fms     $cross_x_24,$fy_7,$dz_8,$cross_x_20     # 101e
        fms     $cross_z,$fx_2,$dy_5,$cross_z_14        # 102e
        fms     $cross_x_14,$fy_8,$dz_3,$cross_x_22     # 103e
        fma     $ahead_11,$half_y_4,$ay_7,$ahead_11     # 104e
        fma     $ahead_7,$half_y_4,$ay_8,$ahead_10      # 105e
        fma     $reach_z_15,$half_x_4,$ay_6,$reach_z_2  # 106e
        fma     $reach_z_16,$half_x_4,$ay_5,$reach_z_12 # 107e
        fma     $reach_x_14,$half_y_4,$az_3,$reach_x_13 # 108e
        fms     $cross_y,$fz_2,$dx_8,$cross_y_18        # 109e
        fma     $reach_y,$half_z_3,$ax_8,$reach_y_13    # 110e
        fma     $ahead,$half_z_3,$az_9,$ahead           # 111e
        fma     $reach_y_17,$half_z_3,$ax_9,$reach_y_14 # 112e
        fcmgt   $cross_x_25,$cross_x_21,$reach_x_11     # 113e
        fcmgt   $cross_x_24,$cross_x_24,$reach_x        # 114e
        fma     $ahead_9,$half_z_3,$az_8,$ahead_9       # 115e
        fms     $cross_z_6,$fx_4,$dy_6,$cross_z_3       # 116e
        fma     $reach_z_17,$half_x_4,$ay_7,$reach_z_13 # 117e
        fms     $cross_x_26,$fy_9,$dz_9,$cross_x_23     # 118e
        fma     $reach_x,$half_y_4,$az_10,$reach_x_9    # 119e
        fms     $cross_y_20,$fz_5,$dx_9,$cross_y_19     # 120e
        fms     $cross_z_17,$fx_6,$dy_7,$cross_z_15     # 121e
        fcmgt   $cross_y_3,$cross_y_3,$reach_y_15       # 122e
        fma     $reach_z,$half_x_4,$ay_8,$reach_z_14    # 123e
        fcmgt   $cross_y_21,$cross_y_6,$reach_y_16      # 124e
        or      $cross_x,$cross_x_24,$cross_y_3         # 125e
        fma     $ahead_12,$half_z_3,$az_3,$ahead_11     # 126e
        fcmgt   $cross_x_14,$cross_x_14,$reach_x_14     # 127e
        fcmgt   $cross_y,$cross_y,$reach_y              # 128e
        fma     $ahead_13,$half_z_3,$az_10,$ahead_7     # 129e
        fcmgt   $cross_z_18,$cross_z_16,$reach_z_15     # 130e
        or      $cross_x_10,$cross_x_25,$cross_y_21     # 131e
        or      $cross_z_18,$cross_z_18,$ahead          # 132e
        fcmgt   $cross_z,$cross_z,$reach_z_16           # 133e
        fcmgt   $cross_y_22,$cross_y_20,$reach_y_17     # 134e
        or      $cross_z,$cross_z,$ahead_9              # 135e
        or      $cross_x_9,$cross_x_10,$t_7             # 136e
        fcmgt   $cross_z_6,$cross_z_6,$reach_z_17       # 137e
        or      $cross_x_14,$cross_x_14,$cross_y        # 138e
        or      $all_miss,$cross_x_9,$cross_z_18        # 139e
        or      $cross_x,$cross_x,$t                    # 140e
        or      $cross_z_12,$cross_z_6,$ahead_12        # 141e
        or      $cross_x_15,$cross_x_14,$t_8            # 142e
        fcmgt   $cross_x_14,$cross_x_26,$reach_x        # 143e
        fcmgt   $cross_z_17,$cross_z_17,$reach_z        # 144e
        or      $cross_x,$cross_x,$cross_z              # 145e
        or      $cross_x_12,$cross_x_15,$cross_z_12     # 146e
        or      $cross_x_15,$cross_x_14,$cross_y_22     # 147e
        lnop                                            # 147o pairing
        and     $all_miss,$all_miss,$cross_x            # 148e
        hbrr    next_child_short_back,next_child_short  # 148o hint
        or      $cross_x,$cross_x_15,$t_4               # 149e
        or      $cross_z,$cross_z_17,$ahead_13          # 150e
        and     $all_miss,$all_miss,$cross_x_12         # 151e
        or      $cross_x,$cross_x,$cross_z              # 152e
        and     $all_miss,$all_miss,$cross_x            # 154e
        nor     $any,$all_miss,$all_miss                # 156e
        rotmai  $any,$any,-31                           # 158e
        orx     $any,$any                               # 162o all ones if a ray may meet the box
        sf      $found,$any,$found                      # 166e
next_child_short_back:
        brnz    $count,next_child_short                 # 166o
        shli    $found,$found,4                         # 168e
        lnop                                            # 168o pairing
        a       $a_first,$a_first,$found                # 172e
        bi      $lr                                     # 172o
endfunction filter_box_children_r16
