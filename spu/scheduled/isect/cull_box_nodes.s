# cull_box_nodes   of nodes under packets' bounds, the children whose boxes a ray may meet
#   C       struct candidate *cull_box_nodes(const struct candidate *, int count,
#                                            struct candidate *, int lanes);
#   In      $3 candidates whose objects are BOX_NODEs, $4 count (0 is none), $5 where the list
#           goes, $6 0, or 4 if filter_box_children_r16 gets the list; pointers 16-aligned
#   Out     candidates of such children, node by node, children in order: object is the child, or
#           with 4 its node's address plus 4 times its lane, the rest the node's; one more quadword
#           may be written
#           $3 behind the list
#   Uses    $2-$66, $79   Saves  -   Stack  0   Calls  -
#   Domain  bounds as bound_fan_r16 makes them, or bound_origins_r16; half sizes of a child's box
#           with a slack of 2^-18 (|c| + H), c its centre, H half its diagonal; of a lane without a
#           child, -FARTHEST; distances from 2^-60 to 2^60
#   Error   0: no child is left out that a ray of the packet meets, from inside or within its t
#   Twin    lab/twins/src/cull_box_nodes.rs
#
# As cull_nodes, with boxes instead of spheres. Their reach depends on the direction: in the
# direction w it is R + sum of half |w|, R the radius of the bound. The cone's side is replaced by
# the plane that touches it towards the box's centre, whose normal is
#   w = cosine (v - a axis) / perp - sine axis
# so that v.w = perp cosine - a sine. No ray goes beyond that plane by more than R, because all
# directions are within the cone. A child is culled if one of these is below 0:
#   R + half.|w| - v.w            the whole box is beyond the plane
#   R + half.|axis| + a           it is behind the apex
#   R + half.|axis| + farthest - a   it is too far away
# A bound that is open has axis, cosine and sine 0, and so w = 0, and nothing is culled.
# Scheduled by spu schedule from cull_box_nodes.s

        .include "cull_tmpl.inc"

        .set    NEXT,3
        registers a_first                               # candidate
        registers count,a_list,lanes
        # constants
        .set    m_child,10                              # to 13: a word of one and three of another
        # state
        .set    NEXT,14
        registers a_candidate
        registers found                                 # bytes of the list so far
        # the candidate
        registers candidate,a_bound,child
        # the bound
        registers apex_x,apex_y,apex_z,axis_x,axis_y,axis_z,cosine,sine
        registers rays_radius                           # the rays' radius
        registers farthest
        # the children
        registers vx,vy,vz
        registers half_x,half_y,half_z
        registers along,perp,t_y,beside,ahead,near
        registers side_x,side_y,side_z                  # w
        registers step                                  # four of them
        .set    NEXT,step+4
        registers entry
        # the candidate, loaded again instead of being kept in a register for so long
        registers a_again,again
        # what the list gets of a child: its address, or its lane's
        registers m_of_child,m_of_node,k_lanes,c_address,m_sign

        cull_tables .rodata.boxes

function cull_box_nodes
        .set count_2,79; .set m_of_child_2,2; .set a_candidate_2,2; .set candidate_2,5
        .set again_2,7; .set a_candidate_3,6; .set candidate_3,2; .set vx_2,9; .set vy_2,20
        .set vz_2,21; .set apex_x_2,26; .set apex_y_2,23; .set axis_y_2,37; .set apex_z_2,6
        .set axis_z_2,36; .set a_bound_2,8; .set axis_x_2,46; .set vx_3,18; .set vy_3,19
        .set vz_3,24; .set apex_y_3,6; .set axis_z_3,47; .set along_2,41; .set axis_x_3,25
        .set axis_y_3,28; .set apex_z_3,27; .set rays_radius_2,31; .set vy_4,6; .set cosine_2,33
        .set sine_2,56; .set axis_z_4,19; .set axis_x_4,26; .set half_x_2,34; .set half_y_2,29
        .set axis_y_4,30; .set farthest_2,38; .set half_z_2,39; .set side_x_2,42; .set half_y_3,40
        .set ahead_2,5; .set half_y_4,43; .set side_y_2,44; .set vx_4,46; .set side_z_2,59
        .set child_2,45; .set half_z_3,60; .set vx_5,61; .set sine_3,48; .set vy_5,62; .set vz_4,63
        .set sine_4,64; .set ahead_3,9; .set ahead_4,21; .set along_3,65; .set along_4,26
        .set apex_x_3,23; .set half_z_4,2; .set side_y_3,5; .set child_3,41; .set axis_z_5,45
        .set farthest_3,50; .set cosine_3,8; .set apex_y_4,39; .set perp_2,6; .set vz_5,18
        .set near_2,28; .set again_3,58; .set ahead_5,38; .set apex_z_4,47; .set ahead_6,57
        .set sine_5,45; .set perp_3,66; .set along_5,52; .set perp_4,21; .set half_y_5,6
        .set half_z_5,40; .set side_x_3,2; .set near_3,23; .set t_y_2,25; .set ahead_7,28
        .set side_z_3,38; .set perp_5,19; .set near_4,39; .set t_y_3,24; .set entry_2,54
        .set entry_3,50; .set ahead_8,26; .set entry_4,57; .set side_z_4,7; .set perp_6,33
        .set beside_2,24; .set t_y_4,26; .set beside_3,8; .set side_z_5,24; .set ahead_9,7
        .set perp_7,8; .set side_z_6,19; .set apex_z_5,22; .set found_2,24; .set step1_2,33
        .set step2_2,34; .set step3_2,8; .set rays_radius_3,4; .set half_x_3,5; .set side_y_4,7
        .set sine_6,8; .set along_6,9; .set half_y_6,14; .set half_z_6,16; .set ahead_10,17
        .set side_z_7,20; .set step1_3,6; .set step2_3,21; .set step3_3,15; .set found_3,6
        .set perp_8,20; .set again_4,6; .set entry_5,2; .set perp_9,7; .set entry_6,10
        .set entry_7,6; .set step3_4,4; .set found_4,5; .set found_5,2; .set axis_x_5,2
        .set axis_y_5,5; .set axis_z_6,6; .set entry_8,5
        ori     $a_candidate,$a_first,0                 # 0e
        ori     $a_again,$a_first,0                     # 1e
        ori     $a_first,$a_list,0                      # 2e
        biz     $count,$lr                              # 2o
        ila     $m_of_child,0x10203                     # 3e
        lqa     $k_lanes,lane_numbers                   # 3o
        clgti   $count_2,$count,3                       # 4e at least as many passes as overlap
        lqa     $m_of_child_2,all_words                 # 4o
        il      $found,0                                # 5e
        shufb   $lanes,$lanes,$lanes,$m_of_child        # 5o
        ilhu    $m_sign,0x8000                          # 6e
        lqa     $m_of_node,first_of_another             # 6o
        lqa     $m_child,children                       # 7o
        lqa     $m_child+1,children+16                  # 8o
        mpyu    $k_lanes,$k_lanes,$lanes                # 9e
        lqa     $m_child+2,children+32                  # 9o
        ceqi    $c_address,$lanes,0                     # 10e
        lqa     $m_child+3,children+48                  # 10o
        selb    $m_of_child,$m_of_node,$m_of_child_2,$c_address # 12e
        brz     $count_2,next_node_short                # 12o too few passes
        ai      $a_candidate_2,$a_candidate,16          # 13e
        lqd     $candidate_2,0($a_candidate)            # 13o
        ai      $count,$count,-1                        # 14e
        lqd     $again_2,0($a_again)                    # 14o
        ai      $a_candidate_3,$a_candidate_2,16        # 15e
        lqd     $candidate_3,0($a_candidate_2)          # 15o
        ai      $count,$count,-1                        # 16e
        lnop                                            # 16o pairing
        ai      $a_candidate,$a_candidate_3,16          # 17e
        lqd     $candidate,0($a_candidate_3)            # 17o
        ai      $a_again,$a_again,16                    # 18e
        lnop                                            # 18o pairing
        ai      $count,$count,-1                        # 19e
        rotqbyi $a_bound,$candidate_2,8                 # 19o
        lqd     $vx_2,0($candidate_2)                   # 20o
        lqd     $vy_2,16($candidate_2)                  # 21o
        lqd     $vz_2,32($candidate_2)                  # 22o
        lqd     $apex_x_2,0($a_bound)                   # 23o
        lqd     $axis_x,48($a_bound)                    # 24o
        lqd     $apex_y_2,16($a_bound)                  # 25o
        lqd     $axis_y_2,64($a_bound)                  # 26o
        lqd     $apex_z_2,32($a_bound)                  # 27o
        nop     $127                                    # 28e pairing
        lqd     $axis_z_2,80($a_bound)                  # 28o
        fs      $vx_2,$vx_2,$apex_x_2                   # 29e
        rotqbyi $a_bound_2,$candidate_3,8               # 29o
        andc    $axis_x_2,$axis_x,$m_sign               # 30e
        lqd     $vx_3,0($candidate_3)                   # 30o
        fs      $vy_2,$vy_2,$apex_y_2                   # 31e
        lqd     $vy_3,16($candidate_3)                  # 31o
        andc    $axis_y,$axis_y_2,$m_sign               # 32e
        lqd     $vz_3,32($candidate_3)                  # 32o
        fs      $vz_2,$vz_2,$apex_z_2                   # 33e
        lqd     $apex_y_3,16($a_bound_2)                # 33o
        andc    $axis_z_3,$axis_z_2,$m_sign             # 34e
        lqd     $apex_x_2,0($a_bound_2)                 # 34o
        fm      $along_2,$vx_2,$axis_x                  # 35e
        lqd     $axis_x_3,48($a_bound_2)                # 35o
        lqd     $axis_y_3,64($a_bound_2)                # 36o
        lqd     $apex_z_3,32($a_bound_2)                # 37o
        nop     $127                                    # 38e pairing
        lqd     $rays_radius_2,128($a_bound)            # 38o
        fs      $vy_4,$vy_3,$apex_y_3                   # 39e
        lqd     $cosine_2,96($a_bound)                  # 39o
        fs      $vx_3,$vx_3,$apex_x_2                   # 40e
        lqd     $sine_2,112($a_bound)                   # 40o
        fma     $along,$vy_2,$axis_y_2,$along_2         # 41e
        lqd     $axis_z_4,80($a_bound_2)                # 41o
        andc    $axis_x_4,$axis_x_3,$m_sign             # 42e
        lqd     $half_x_2,48($candidate_2)              # 42o
        fs      $vz_3,$vz_3,$apex_z_3                   # 43e
        lqd     $half_y_2,64($candidate_2)              # 43o
        andc    $axis_y_4,$axis_y_3,$m_sign             # 44e
        lqd     $farthest_2,144($a_bound)               # 44o
        nop     $127                                    # 45e pairing
        lqd     $half_x,48($candidate_3)                # 45o
        fm      $along_2,$vx_3,$axis_x_3                # 46e
        lqd     $half_z_2,80($candidate_2)              # 46o
        fma     $along,$vz_2,$axis_z_2,$along           # 47e
        lqd     $rays_radius,128($a_bound_2)            # 47o
        fm      $side_x_2,$axis_x,$sine_2               # 48e
        lqd     $half_y_3,64($candidate_3)              # 48o
        fma     $ahead_2,$half_x_2,$axis_x_2,$rays_radius_2 # 49e
        shlqbyi $half_y_4,$half_y_2,0                   # 49o copy
        fm      $side_y_2,$axis_y_2,$sine_2             # 50e
        lqd     $vx_4,0($candidate)                     # 50o
        fm      $side_z_2,$axis_z_2,$sine_2             # 51e
        lqd     $child_2,96($again_2)                   # 51o
        fma     $along_2,$vy_4,$axis_y_3,$along_2       # 52e
        shlqbyi $half_z_3,$half_z_2,0                   # 52o copy
        fnms    $vx_5,$along,$axis_x,$vx_2              # 53e
        lqd     $sine_3,112($a_bound_2)                 # 53o
        fnms    $vy_5,$along,$axis_y_2,$vy_2            # 54e
        rotqbyi $a_bound,$candidate,8                   # 54o
        fnms    $vz_4,$along,$axis_z_2,$vz_2            # 55e
        shlqbyi $sine_4,$sine_2,0                       # 55o copy
        fma     $ahead_3,$half_y_2,$axis_y,$ahead_2     # 56e
        lqd     $vy_2,16($candidate)                    # 56o
        fma     $ahead_4,$half_x,$axis_x_4,$rays_radius # 57e
        shlqbyi $along_3,$along,0                       # 57o copy
        fma     $along_4,$vz_3,$axis_z_4,$along_2       # 58e
        lqd     $apex_x_3,0($a_bound)                   # 58o
        fm      $perp,$vx_5,$vx_5                       # 59e
        lqd     $half_z_4,80($candidate_3)              # 59o
        fm      $side_y_3,$axis_y_3,$sine_3             # 60e
        shufb   $child_3,$child_2,$again_2,$m_of_child  # 60o
        andc    $axis_z_5,$axis_z_4,$m_sign             # 61e
        lqd     $farthest_3,144($a_bound_2)             # 61o
        fma     $ahead_3,$half_z_2,$axis_z_3,$ahead_3   # 62e
        lqd     $cosine_3,96($a_bound_2)                # 62o
        fma     $ahead_4,$half_y_3,$axis_y_4,$ahead_4   # 63e
        lqd     $apex_y_4,16($a_bound)                  # 63o
        fnms    $vy,$along_4,$axis_y_3,$vy_4            # 64e
        lqd     $axis_x,48($a_bound)                    # 64o
        fma     $perp_2,$vy_5,$vy_5,$perp               # 65e
        lqd     $axis_y_2,64($a_bound)                  # 65o
        fnms    $vx,$along_4,$axis_x_3,$vx_3            # 66e
        lqd     $axis_z_2,80($a_bound)                  # 66o
        fnms    $vz_5,$along_4,$axis_z_4,$vz_3          # 67e
        lqd     $vz_3,32($candidate)                    # 67o
        fa      $near_2,$ahead_3,$farthest_2            # 68e
        lqd     $again_3,0($a_again)                    # 68o
        fa      $ahead_5,$ahead_3,$along                # 69e
        lqd     $apex_z_4,32($a_bound)                  # 69o
        fma     $ahead_6,$half_z_4,$axis_z_5,$ahead_4   # 70e
        shlqbyi $sine_5,$sine_3,0                       # 70o copy
        fma     $perp_3,$vz_4,$vz_4,$perp_2             # 71e squared
        shlqbyi $along_5,$along_4,0                     # 71o copy
        fm      $perp_4,$vx,$vx                         # 72e
        shlqbyi $half_y_5,$half_y_3,0                   # 72o copy
        fs      $vx_2,$vx_4,$apex_x_3                   # 73e
        shlqbyi $half_z_5,$half_z_4,0                   # 73o copy
        fs      $near_2,$near_2,$along                  # 74e
        lqd     $sine_2,112($a_bound)                   # 74o
        fm      $side_x_3,$axis_x_3,$sine_3             # 75e
        fs      $vy_2,$vy_2,$apex_y_4                   # 76e
        fa      $near_3,$ahead_6,$farthest_3            # 77e
        frsqest $t_y_2,$perp_3                          # 77o
        fma     $perp_4,$vy,$vy,$perp_4                 # 78e
        fm      $along,$vx_2,$axis_x                    # 79e
        or      $ahead,$ahead_5,$near_2                 # 80e
        fi      $t_y_2,$perp_3,$t_y_2                   # 81e
        or      $ahead_7,$ahead,$half_x_2               # 82e below 0 without a child
        fm      $side_z_3,$axis_z_4,$sine_3             # 83e
        fma     $perp_5,$vz_5,$vz_5,$perp_4             # 84e squared
        fs      $near_4,$near_3,$along_4                # 85e
        a       $child_3,$child_3,$k_lanes              # 86e
        fs      $vz_2,$vz_3,$apex_z_4                   # 87e
        fm      $t_y_3,$t_y_2,$cosine_2                 # 88e
        shufb   $entry,$child_3,$again_2,$m_child       # 88o
        fma     $along,$vy_2,$axis_y_2,$along           # 89e
        shufb   $entry_2,$child_3,$again_2,$m_child+2   # 89o
        andc    $axis_y,$axis_y_2,$m_sign               # 90e
        frsqest $t_y_2,$perp_5                          # 90o
        andc    $axis_z_3,$axis_z_2,$m_sign             # 91e
        shufb   $entry_3,$child_3,$again_2,$m_child+1   # 91o
        fa      $ahead_8,$ahead_6,$along_4              # 92e
        shufb   $entry_4,$child_3,$again_2,$m_child+3   # 92o
        andc    $axis_x_2,$axis_x,$m_sign               # 93e
        fms     $side_x,$vx_5,$t_y_3,$side_x_2          # 94e
        fms     $side_y,$vy_5,$t_y_3,$side_y_2          # 95e
        fms     $side_z_4,$vz_4,$t_y_3,$side_z_2        # 96e
        fi      $t_y_2,$perp_5,$t_y_2                   # 97e
        or      $ahead,$ahead_8,$near_4                 # 98e
        fm      $perp_6,$perp_3,$t_y_3                  # 99e perp cosine
        andc    $side_x,$side_x,$m_sign                 # 100e
        andc    $side_y,$side_y,$m_sign                 # 101e
        lnop                                            # 101o pairing
        fma     $beside_2,$half_x_2,$side_x,$rays_radius_2 # 102e
        hbrr    next_node_back,next_node                # 102o hint
        andc    $side_z_4,$side_z_4,$m_sign             # 103e
        fm      $t_y_4,$t_y_2,$cosine_3                 # 104e
        fma     $beside_3,$half_y_4,$side_y,$beside_2   # 108e
        fms     $side_z_5,$vz_5,$t_y_4,$side_z_3        # 110e
        fma     $beside,$half_z_3,$side_z_4,$beside_3   # 114e
        fma     $beside,$along_3,$sine_4,$beside        # 120e
        fs      $beside,$beside,$perp_6                 # 126e
        nor     $step,$beside,$ahead_7                  # 132e
        rotmi   $step,$step,-27                         # 134e
        lnop                                            # 134o pairing
next_node:
            fms     $side_y,$vy,$t_y_4,$side_y_3        # 0e
            stqx    $entry,$a_first,$found              # 0o
            fms     $side_x,$vx,$t_y_4,$side_x_3        # 1e
            fma     $along,$vz_2,$axis_z_2,$along       # 2e
            fm      $side_z,$axis_z_2,$sine_2           # 3e
            fm      $side_x_3,$axis_x,$sine_2           # 4e
            fm      $side_y_3,$axis_y_2,$sine_2         # 5e
            lnop                                        # 5o pairing
            andc    $side_y,$side_y,$m_sign             # 6e
            lqd     $child,96($again_3)                 # 6o
            andc    $side_x,$side_x,$m_sign             # 7e
            lqd     $half_z,80($candidate)              # 7o
            fnms    $vx,$along,$axis_x,$vx_2            # 8e
            lqd     $half_y,64($candidate)              # 8o
            fma     $beside,$half_x,$side_x,$rays_radius # 9e
            lqd     $rays_radius,128($a_bound)          # 9o
            or      $ahead,$ahead,$half_x               # 10e below 0 without a child
            lqd     $half_x,48($candidate)              # 10o
            fnms    $vy,$along,$axis_y_2,$vy_2          # 11e
        lqd     $candidate,0($a_candidate)              # 11o
        ai      $a_candidate,$a_candidate,16            # 12e
            shufb   $child,$child,$again_3,$m_of_child  # 12o
            fnms    $vz,$along,$axis_z_2,$vz_2          # 13e
            lnop                                        # 13o pairing
            fm      $perp,$vx,$vx                       # 14e
            lqd     $farthest,144($a_bound)             # 14o
            fma     $beside,$half_y_5,$side_y,$beside   # 15e
            shlqbyi $half_y_5,$half_y,0                 # 15o copy
            fma     $ahead_9,$half_x,$axis_x_2,$rays_radius # 16e
            lqd     $cosine,96($a_bound)                # 16o
            fm      $perp_7,$perp_5,$t_y_4              # 17e perp cosine
        rotqbyi $a_bound,$candidate,8                   # 17o
            andi    $step,$step,16                      # 18e
        lqd     $vx_2,0($candidate)                     # 18o
            andc    $side_z_6,$side_z_5,$m_sign         # 19e
        lqd     $vy_2,16($candidate)                    # 19o
            fma     $perp,$vy,$vy,$perp                 # 20e
        lqd     $vz_2,32($candidate)                    # 20o
            a       $child,$child,$k_lanes              # 21e
        lqd     $apex_z_5,32($a_bound)                  # 21o
            fma     $ahead_9,$half_y,$axis_y,$ahead_9   # 22e
        lqd     $apex_y_2,16($a_bound)                  # 22o
            a       $found_2,$found,$step               # 23e
        lqd     $apex_x_2,0($a_bound)                   # 23o
        ai      $count,$count,-1                        # 24e
        lqd     $axis_y_2,64($a_bound)                  # 24o
            fma     $beside,$half_z_5,$side_z_6,$beside # 25e
            stqx    $entry_3,$a_first,$found_2          # 25o
            fma     $perp_5,$vz,$vz,$perp               # 26e squared
            shlqbyi $half_z_5,$half_z,0                 # 26o copy
        fs      $vz_2,$vz_2,$apex_z_5                   # 27e
        lnop                                            # 27o pairing
            fma     $ahead_9,$half_z,$axis_z_3,$ahead_9 # 28e
        lqd     $axis_x,48($a_bound)                    # 28o
        fs      $vy_2,$vy_2,$apex_y_2                   # 29e
        lnop                                            # 29o pairing
        andc    $axis_y,$axis_y_2,$m_sign               # 30e
        lqd     $axis_z_2,80($a_bound)                  # 30o
            fma     $beside,$along_5,$sine_5,$beside    # 31e
            shlqbyi $sine_5,$sine_2,0                   # 31o copy
        fs      $vx_2,$vx_2,$apex_x_2                   # 32e
            frsqest $t_y_4,$perp_5                      # 32o
            ai      $a_again,$a_again,16                # 33e
            lnop                                        # 33o pairing
        andc    $axis_x_2,$axis_x,$m_sign               # 34e
            rotqbyi $step1_2,$step,4                    # 34o
            fa      $near_2,$ahead_9,$farthest          # 35e
            shufb   $entry,$child,$again_3,$m_child     # 35o
            fi      $t_y_4,$perp_5,$t_y_4               # 36e
            lnop                                        # 36o pairing
        andc    $axis_z_3,$axis_z_2,$m_sign             # 37e
            rotqbyi $step2_2,$step,8                    # 37o
        fm      $along_2,$vx_2,$axis_x                  # 38e
            shufb   $entry_3,$child,$again_3,$m_child+1 # 38o
            fa      $ahead_9,$ahead_9,$along            # 39e
            lnop                                        # 39o pairing
            fs      $beside,$beside,$perp_7             # 40e
            rotqbyi $step3_2,$step,12                   # 40o
            fs      $near_2,$near_2,$along              # 41e
            shlqbyi $along_5,$along,0                   # 41o copy
            a       $found_2,$found_2,$step1_2          # 42e
            fm      $t_y_4,$t_y_4,$cosine               # 43e
        fma     $along,$vy_2,$axis_y_2,$along_2         # 44e
            stqx    $entry_2,$a_first,$found_2          # 44o
            a       $found_2,$found_2,$step2_2          # 45e
            shufb   $entry_2,$child,$again_3,$m_child+2 # 45o
            nor     $step,$beside,$ahead                # 46e
        lqd     $sine_2,112($a_bound)                   # 46o
            a       $found,$found_2,$step3_2            # 47e
            stqx    $entry_4,$a_first,$found_2          # 47o
            or      $ahead,$ahead_9,$near_2             # 48e
            shufb   $entry_4,$child,$again_3,$m_child+3 # 48o
            rotmi   $step,$step,-27                     # 49e
            lqd     $again_3,0($a_again)                # 49o
            fms     $side_z_5,$vz,$t_y_4,$side_z        # 50e
next_node_back:
        brnz    $count,next_node                        # 50o
next_node_drain:
        fma     $along,$vz_2,$axis_z_2,$along           # 0e
        stqx    $entry,$a_first,$found                  # 0o
        fms     $side_x,$vx,$t_y_4,$side_x_3            # 1e
        lqd     $cosine,96($a_bound)                    # 1o
        fm      $side_x_3,$axis_x,$sine_2               # 2e
        lqd     $rays_radius_3,128($a_bound)            # 2o
        fms     $side_y,$vy,$t_y_4,$side_y_3            # 3e
        lqd     $half_x_3,48($candidate)                # 3o
        fm      $side_y_4,$axis_y_2,$sine_2             # 4e
        lqd     $half_y,64($candidate)                  # 4o
        fm      $side_z,$axis_z_2,$sine_2               # 5e
        lqd     $half_z,80($candidate)                  # 5o
        fnms    $vx,$along,$axis_x,$vx_2                # 6e
        lqd     $farthest,144($a_bound)                 # 6o
        fnms    $vy,$along,$axis_y_2,$vy_2              # 7e
        lqd     $child,96($again_3)                     # 7o
        fnms    $vz,$along,$axis_z_2,$vz_2              # 8e
        shlqbyi $sine_6,$sine_2,0                       # 8o copy
        andc    $side_x,$side_x,$m_sign                 # 9e
        shlqbyi $along_6,$along,0                       # 9o copy
        andc    $side_y,$side_y,$m_sign                 # 10e
        shlqbyi $half_y_6,$half_y,0                     # 10o copy
        fma     $beside,$half_x,$side_x,$rays_radius    # 11e
        shlqbyi $half_z_6,$half_z,0                     # 11o copy
        fm      $perp,$vx,$vx                           # 12e
        hbr     cull_box_nodes_return,$lr               # 12o hint
        fma     $ahead_10,$half_x_3,$axis_x_2,$rays_radius_3 # 13e
        shufb   $child,$child,$again_3,$m_of_child      # 13o
        andc    $side_z_7,$side_z_5,$m_sign             # 14e
        fm      $perp_5,$perp_5,$t_y_4                  # 15e perp cosine
        andi    $step,$step,16                          # 16e
        fma     $beside,$half_y_5,$side_y,$beside       # 17e
        fma     $perp,$vy,$vy,$perp                     # 18e
        rotqbyi $step1_3,$step,4                        # 18o
        fma     $ahead_10,$half_y,$axis_y,$ahead_10     # 19e
        rotqbyi $step2_3,$step,8                        # 19o
        a       $found_2,$found,$step                   # 20e
        rotqbyi $step3_3,$step,12                       # 20o
        ai      $a_again,$a_again,16                    # 21e
        lnop                                            # 21o pairing
        a       $found_3,$found_2,$step1_3              # 22e
        stqx    $entry_3,$a_first,$found_2              # 22o
        fma     $beside,$half_z_5,$side_z_7,$beside     # 23e
        lnop                                            # 23o pairing
        fma     $perp_8,$vz,$vz,$perp                   # 24e squared
        stqx    $entry_2,$a_first,$found_3              # 24o
        fma     $ahead_10,$half_z,$axis_z_3,$ahead_10   # 25e
        a       $found_2,$found_3,$step2_3              # 26e
        or      $ahead,$ahead,$half_x                   # 27e below 0 without a child
        lnop                                            # 27o pairing
        a       $child,$child,$k_lanes                  # 28e
        stqx    $entry_4,$a_first,$found_2              # 28o
        fma     $beside,$along_5,$sine_5,$beside        # 29e
        lqd     $again_4,0($a_again)                    # 29o
        a       $found,$found_2,$step3_3                # 30e
        frsqest $t_y_4,$perp_8                          # 30o
        fa      $near_2,$ahead_10,$farthest             # 31e
        shufb   $entry,$child,$again_3,$m_child         # 31o
        fa      $ahead_10,$ahead_10,$along              # 32e
        shufb   $entry_3,$child,$again_3,$m_child+1     # 32o
        ai      $a_again,$a_again,16                    # 33e
        shufb   $entry_2,$child,$again_3,$m_child+2     # 33o
        fi      $t_y_4,$perp_8,$t_y_4                   # 34e
        shufb   $entry_4,$child,$again_3,$m_child+3     # 34o
        nop     $127                                    # 35e pairing
        stqx    $entry,$a_first,$found                  # 35o
        fs      $beside,$beside,$perp_5                 # 36e
        lqd     $child,96($again_4)                     # 36o
        fs      $near_2,$near_2,$along                  # 37e
        fm      $t_y_4,$t_y_4,$cosine                   # 41e
        nor     $step,$beside,$ahead                    # 42e
        shufb   $child,$child,$again_4,$m_of_child      # 42o
        or      $ahead,$ahead_10,$near_2                # 43e
        rotmi   $step,$step,-27                         # 44e
        or      $ahead,$ahead,$half_x_3                 # 45e below 0 without a child
        a       $child,$child,$k_lanes                  # 46e
        fms     $side_x,$vx,$t_y_4,$side_x_3            # 47e
        lnop                                            # 47o pairing
        fms     $side_y,$vy,$t_y_4,$side_y_4            # 48e
        shufb   $entry,$child,$again_4,$m_child         # 48o
        fms     $side_z_5,$vz,$t_y_4,$side_z            # 49e
        shufb   $entry_5,$child,$again_4,$m_child+1     # 49o
        fm      $perp_9,$perp_8,$t_y_4                  # 50e perp cosine
        shufb   $entry_6,$child,$again_4,$m_child+2     # 50o
        andi    $step,$step,16                          # 51e
        shufb   $entry_7,$child,$again_4,$m_child+3     # 51o
        andc    $side_x,$side_x,$m_sign                 # 53e
        rotqbyi $step1_2,$step,4                        # 53o
        andc    $side_y,$side_y,$m_sign                 # 54e
        rotqbyi $step2_2,$step,8                        # 54o
        fma     $beside,$half_x_3,$side_x,$rays_radius_3 # 55e
        rotqbyi $step3_4,$step,12                       # 55o
        andc    $side_z_6,$side_z_5,$m_sign             # 56e
        a       $found_2,$found,$step                   # 57e
        a       $found_4,$found_2,$step1_2              # 59e
        stqx    $entry_3,$a_first,$found_2              # 59o
        fma     $beside,$half_y_6,$side_y,$beside       # 61e
        stqx    $entry_2,$a_first,$found_4              # 61o
        a       $found_2,$found_4,$step2_2              # 62e
        lnop                                            # 62o pairing
        a       $found,$found_2,$step3_4                # 64e
        stqx    $entry_4,$a_first,$found_2              # 64o
        stqx    $entry,$a_first,$found                  # 66o
        fma     $beside,$half_z_6,$side_z_6,$beside     # 67e
        fma     $beside,$along_6,$sine_6,$beside        # 73e
        fs      $beside,$beside,$perp_9                 # 79e
        nor     $step,$beside,$ahead                    # 85e
        rotmi   $step,$step,-27                         # 87e
        andi    $step,$step,16                          # 91e
        lnop                                            # 91o pairing
        a       $found_2,$found,$step                   # 93e
        rotqbyi $step1_2,$step,4                        # 93o
        rotqbyi $step2_2,$step,8                        # 94o
        rotqbyi $step3_2,$step,12                       # 95o
        stqx    $entry_5,$a_first,$found_2              # 96o
        a       $found_2,$found_2,$step1_2              # 97e
        a       $found_5,$found_2,$step2_2              # 99e
        stqx    $entry_6,$a_first,$found_2              # 99o
        a       $found,$found_5,$step3_2                # 101e
        stqx    $entry_7,$a_first,$found_5              # 101o
        a       $a_first,$a_first,$found                # 103e
cull_box_nodes_return:
        bi      $lr                                     # 103o
next_node_short:
        ai      $count,$count,-1                        # 0e
        lqd     $candidate,0($a_candidate)              # 0o
        ai      $a_candidate,$a_candidate,16            # 1e
        lqd     $again,0($a_again)                      # 1o
        ai      $a_again,$a_again,16                    # 2e
        rotqbyi $a_bound,$candidate,8                   # 6o
        lqd     $vx,0($candidate)                       # 7o
        lqd     $vy,16($candidate)                      # 8o
        lqd     $vz,32($candidate)                      # 9o
        lqd     $apex_x,0($a_bound)                     # 10o
        lqd     $axis_x,48($a_bound)                    # 11o
        lqd     $apex_y,16($a_bound)                    # 12o
        lqd     $axis_y,64($a_bound)                    # 13o
        lqd     $apex_z,32($a_bound)                    # 14o
        nop     $127                                    # 15e pairing
        lqd     $axis_z,80($a_bound)                    # 15o
        fs      $vx,$vx,$apex_x                         # 16e
        lqd     $cosine,96($a_bound)                    # 16o
        andc    $axis_x_5,$axis_x,$m_sign               # 17e
        lqd     $sine,112($a_bound)                     # 17o
        fs      $vy,$vy,$apex_y                         # 18e
        lqd     $rays_radius,128($a_bound)              # 18o
        andc    $axis_y_5,$axis_y,$m_sign               # 19e
        lqd     $half_x,48($candidate)                  # 19o
        fs      $vz,$vz,$apex_z                         # 20e
        lqd     $half_y,64($candidate)                  # 20o
        andc    $axis_z_6,$axis_z,$m_sign               # 21e
        lqd     $half_z,80($candidate)                  # 21o
        fm      $along,$vx,$axis_x                      # 22e
        lqd     $farthest,144($a_bound)                 # 22o
        fm      $side_x,$axis_x,$sine                   # 23e
        lqd     $child,96($again)                       # 23o
        fm      $side_y,$axis_y,$sine                   # 24e
        fma     $ahead,$half_x,$axis_x_5,$rays_radius   # 25e
        fm      $side_z,$axis_z,$sine                   # 26e
        fma     $along,$vy,$axis_y,$along               # 28e
        shufb   $child,$child,$again,$m_of_child        # 29o
        fma     $ahead,$half_y,$axis_y_5,$ahead         # 31e
        a       $child,$child,$k_lanes                  # 33e
        fma     $along,$vz,$axis_z,$along               # 34e
        shufb   $entry,$child,$again,$m_child           # 35o
        shufb   $entry_5,$child,$again,$m_child+1       # 36o
        fma     $ahead,$half_z,$axis_z_6,$ahead         # 37e
        shufb   $entry_8,$child,$again,$m_child+2       # 37o
        shufb   $entry_7,$child,$again,$m_child+3       # 38o
        stqx    $entry,$a_first,$found                  # 39o
        fnms    $vx,$along,$axis_x,$vx                  # 40e
        fnms    $vy,$along,$axis_y,$vy                  # 41e
        fnms    $vz,$along,$axis_z,$vz                  # 42e
        fa      $near,$ahead,$farthest                  # 43e
        fa      $ahead,$ahead,$along                    # 44e
        fm      $perp,$vx,$vx                           # 46e
        fs      $near,$near,$along                      # 49e
        fma     $perp,$vy,$vy,$perp                     # 52e
        or      $ahead,$ahead,$near                     # 55e
        or      $ahead,$ahead,$half_x                   # 57e below 0 without a child
        fma     $perp,$vz,$vz,$perp                     # 58e squared
        frsqest $t_y,$perp                              # 64o
        fi      $t_y,$perp,$t_y                         # 68e
        fm      $t_y,$t_y,$cosine                       # 75e
        fms     $side_x,$vx,$t_y,$side_x                # 81e
        fms     $side_y,$vy,$t_y,$side_y                # 82e
        fms     $side_z,$vz,$t_y,$side_z                # 83e
        fm      $perp,$perp,$t_y                        # 84e perp cosine
        andc    $side_x,$side_x,$m_sign                 # 87e
        andc    $side_y,$side_y,$m_sign                 # 88e
        fma     $beside,$half_x,$side_x,$rays_radius    # 89e
        andc    $side_z,$side_z,$m_sign                 # 90e
        fma     $beside,$half_y,$side_y,$beside         # 95e
        fma     $beside,$half_z,$side_z,$beside         # 101e
        fma     $beside,$along,$sine,$beside            # 107e
        fs      $beside,$beside,$perp                   # 113e
        nor     $step,$beside,$ahead                    # 119e
        rotmi   $step,$step,-27                         # 121e
        andi    $step,$step,16                          # 125e
        lnop                                            # 125o pairing
        a       $found,$found,$step                     # 127e
        rotqbyi $step+1,$step,4                         # 127o
        rotqbyi $step+2,$step,8                         # 128o
        rotqbyi $step+3,$step,12                        # 129o
        stqx    $entry_5,$a_first,$found                # 130o
        a       $found,$found,$step+1                   # 131e
        a       $found_5,$found,$step+2                 # 133e
        stqx    $entry_8,$a_first,$found                # 133o
        a       $found,$found_5,$step+3                 # 135e
        stqx    $entry_7,$a_first,$found_5              # 135o
        nop     $127                                    # 136e pairing
        brnz    $count,next_node_short                  # 136o
        a       $a_first,$a_first,$found                # 137e
        bi      $lr                                     # 137o
endfunction cull_box_nodes
