# cull_nodes   of nodes under packets' bounds, the children that some ray of the packet may meet
#   C       struct candidate *cull_nodes(const struct candidate *, int count, struct candidate *,
#                                        int lanes);
#   In      $3 candidates whose objects are NODEs, $4 count (0 is none), $5 where the list goes, $6
#           0, or 4 if filter_children_r16 gets the list; pointers 16-aligned
#   Out     candidates of such children, node by node, children in order: object is the child, or
#           with 4 its node's address plus 4 times its lane, the rest the node's; one more quadword
#           may be written
#           $3 behind the list
#   Uses    $2-$55, $79   Saves  -   Stack  0   Calls  -
#   Domain  bounds as bound_fan_r16 makes them, or bound_origins_r16; the radius of a child's sphere
#           with a slack of 2^-18 (|c| + R), c its centre, R its radius; of a lane without a child,
#           -FARTHEST; distances from 2^-60 to 2^60
#   Error   0: no child is left out that a ray of the packet meets, from inside or within its t
#   Twin    lab/twins/src/cull_nodes.rs
#
# The four children are in the four lanes. Relative to the bound's apex, with v = c - apex:
#   a = v.axis                  along the cone
#   perp = |v - a axis|         across it
#   S = R + radius              shrinking the rays to the apex enlarges the sphere by as much
# A child is culled if one of these is below 0:
#   S - perp cosine + a sine    S minus the distance from the cone's side
#   S + a                       the whole sphere is behind the apex
#   S + farthest - a            the whole sphere is too far away
# The perpendicular keeps the digits for a distant sphere. 12 bits of its length are enough,
# because the bound's cosine is smaller by as much.
#
# The slack is 32 ulp, and the roundings add up to 24. Most of them truncate to the safe side: with
# a slack of only 2 ulp of R, none of the spheres in
# lab/kernels/tests/suite/rays/conservative.rs was lost. The first ones were lost with a slack of
# minus 2 ulp of |c| + R.
# Scheduled by spu schedule from cull_nodes.s

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
        registers rays_radius                             # the rays' radius
        registers farthest
        # the children
        registers vx,vy,vz
        registers reach                                 # S
        registers along,perp,t_y,beside,ahead,near
        registers step                                  # to 42
        .set    NEXT,43
        registers entry
        # the candidate, loaded again instead of being kept in a register for so long
        registers a_again,again
        # what the list gets of a child: its address, or its lane's
        registers m_of_child,m_of_node,k_lanes,c_address

        cull_tables .rodata

function cull_nodes
        .set count_2,79; .set m_of_child_2,2; .set a_candidate_2,2; .set again_2,5
        .set candidate_2,2; .set a_candidate_3,6; .set candidate_3,7; .set a_again_2,8
        .set a_bound_2,20; .set apex_x_2,27; .set apex_y_2,23; .set axis_x_2,41; .set axis_y_2,9
        .set apex_z_2,17; .set axis_z_2,47; .set vx_2,27; .set a_bound_3,18; .set vy_2,49
        .set vz_2,19; .set vz_3,42; .set apex_x_3,17; .set axis_x_3,21; .set axis_y_3,22
        .set apex_z_3,24; .set a_bound_4,26; .set vx_3,17; .set axis_z_3,28; .set reach_2,16
        .set vy_3,23; .set rays_radius_2,50; .set apex_x_4,24; .set reach_3,2; .set along_2,25
        .set axis_x_4,30; .set apex_y_3,31; .set farthest_2,32; .set sine_2,34; .set vx_4,24
        .set vy_4,29; .set farthest_3,35; .set cosine_2,20; .set vz_4,36; .set vy_5,9
        .set axis_y_4,39; .set vz_5,37; .set apex_z_4,38; .set along_3,40; .set axis_z_4,42
        .set along_4,43; .set child_2,25; .set near_2,32; .set reach_4,7; .set perp_2,27
        .set cosine_3,49; .set rays_radius_3,31; .set cosine_4,51; .set beside_2,34
        .set candidate_4,6; .set sine_3,18; .set vy_6,22; .set child_3,23; .set perp_3,9
        .set farthest_4,27; .set near_3,8; .set vy_7,52; .set perp_4,17; .set vz_6,28; .set vz_7,53
        .set perp_5,37; .set reach_5,21; .set ahead_2,7; .set apex_x_5,16; .set apex_z_5,33
        .set along_5,19; .set vx_5,54; .set child_4,6; .set ahead_3,22; .set child_5,17
        .set near_4,23; .set entry_2,38; .set ahead_4,55; .set entry_3,7; .set perp_6,8
        .set entry_4,9; .set near_5,27; .set child_6,28; .set beside_3,17; .set vx_6,2
        .set vz_8,24; .set perp_7,30; .set entry_5,6; .set ahead_5,40; .set cosine_5,18
        .set child_7,31; .set found_2,29; .set step1_2,5; .set step3_2,30; .set step2_2,36
        .set found_3,2; .set perp_8,5; .set child_8,2; .set vx_7,5; .set apex_z_6,16; .set perp_9,2
        .set cosine_6,4; .set found_4,5; .set entry_6,8; .set beside_4,14; .set entry_7,15
        .set found_5,16; .set a_again_3,5; .set again_3,6; .set found_6,7; .set child_9,16
        .set step1_3,17; .set beside_5,7; .set found_7,9; .set found_8,17; .set ahead_6,2
        .set entry_8,4; .set entry_9,5; .set step1_4,14; .set found_9,10; .set entry_10,11
        .set entry_11,2
        ori     $a_candidate,$a_first,0                 # 0e
        ori     $a_again,$a_first,0                     # 1e
        ori     $a_first,$a_list,0                      # 2e
        biz     $count,$lr                              # 2o
        ila     $m_of_child,0x10203                     # 3e
        lqa     $k_lanes,lane_numbers                   # 3o
        clgti   $count_2,$count,4                       # 4e at least as many passes as overlap
        lqa     $m_of_child_2,all_words                 # 4o
        il      $found,0                                # 5e
        shufb   $lanes,$lanes,$lanes,$m_of_child        # 5o
        lqa     $m_of_node,first_of_another             # 6o
        lqa     $m_child,children                       # 7o
        nop     $127                                    # 8e pairing
        lqa     $m_child+1,children+16                  # 8o
        mpyu    $k_lanes,$k_lanes,$lanes                # 9e
        lqa     $m_child+2,children+32                  # 9o
        ceqi    $c_address,$lanes,0                     # 10e
        lqa     $m_child+3,children+48                  # 10o
        selb    $m_of_child,$m_of_node,$m_of_child_2,$c_address # 12e
        brz     $count_2,next_node_short                # 12o too few passes
        ai      $a_candidate_2,$a_candidate,16          # 13e
        lqd     $candidate,0($a_candidate)              # 13o
        ai      $count,$count,-1                        # 14e
        lqd     $again_2,0($a_again)                    # 14o
        ai      $a_candidate,$a_candidate_2,16          # 15e
        lqd     $candidate_2,0($a_candidate_2)          # 15o
        ai      $count,$count,-1                        # 16e
        lnop                                            # 16o pairing
        ai      $a_candidate_3,$a_candidate,16          # 17e
        lqd     $candidate_3,0($a_candidate)            # 17o
        ai      $count,$count,-1                        # 18e
        lnop                                            # 18o pairing
        ai      $a_again_2,$a_again,16                  # 19e
        rotqbyi $a_bound_2,$candidate,8                 # 19o
        ai      $count,$count,-1                        # 20e
        lqd     $vx,0($candidate)                       # 20o
        ai      $a_candidate,$a_candidate_3,16          # 21e
        lqd     $vy,16($candidate)                      # 21o
        ai      $a_again,$a_again_2,16                  # 22e
        lqd     $vz,32($candidate)                      # 22o
        lqd     $apex_x_2,0($a_bound_2)                 # 23o
        lqd     $apex_y_2,16($a_bound_2)                # 24o
        lqd     $axis_x_2,48($a_bound_2)                # 25o
        lqd     $axis_y_2,64($a_bound_2)                # 26o
        lqd     $apex_z_2,32($a_bound_2)                # 27o
        lqd     $axis_z_2,80($a_bound_2)                # 28o
        fs      $vx_2,$vx,$apex_x_2                     # 29e
        rotqbyi $a_bound_3,$candidate_2,8               # 29o
        fs      $vy_2,$vy,$apex_y_2                     # 30e
        lqd     $vx,0($candidate_2)                     # 30o
        lqd     $vy,16($candidate_2)                    # 31o
        lqd     $vz_2,32($candidate_2)                  # 32o
        fs      $vz_3,$vz,$apex_z_2                     # 33e
        lqd     $apex_x_3,0($a_bound_3)                 # 33o
        nop     $127                                    # 34e pairing
        lqd     $axis_x_3,48($a_bound_3)                # 34o
        fm      $along,$vx_2,$axis_x_2                  # 35e
        lqd     $apex_y_2,16($a_bound_3)                # 35o
        lqd     $axis_y_3,64($a_bound_3)                # 36o
        lqd     $apex_z_3,32($a_bound_3)                # 37o
        nop     $127                                    # 38e pairing
        rotqbyi $a_bound_4,$candidate_3,8               # 38o
        fs      $vx_3,$vx,$apex_x_3                     # 39e
        lqd     $axis_z_3,80($a_bound_3)                # 39o
        nop     $127                                    # 40e pairing
        lqd     $reach_2,48($candidate)                 # 40o
        fma     $along,$vy_2,$axis_y_2,$along           # 41e
        lqd     $vx,0($candidate_3)                     # 41o
        fs      $vy_3,$vy,$apex_y_2                     # 42e
        lqd     $rays_radius_2,128($a_bound_2)          # 42o
        fs      $vz_2,$vz_2,$apex_z_3                   # 43e
        lqd     $apex_x_4,0($a_bound_4)                 # 43o
        nop     $127                                    # 44e pairing
        lqd     $reach_3,48($candidate_2)               # 44o
        fm      $along_2,$vx_3,$axis_x_3                # 45e
        lqd     $axis_x_4,48($a_bound_4)                # 45o
        nop     $127                                    # 46e pairing
        lqd     $apex_y_3,16($a_bound_4)                # 46o
        fma     $along,$vz_3,$axis_z_2,$along           # 47e
        lqd     $farthest_2,144($a_bound_2)             # 47o
        fa      $reach_2,$reach_2,$rays_radius_2        # 48e
        lqd     $sine_2,112($a_bound_2)                 # 48o
        fs      $vx_4,$vx,$apex_x_4                     # 49e
        lqd     $rays_radius_2,128($a_bound_3)          # 49o
        nop     $127                                    # 50e pairing
        lqd     $vy_4,16($candidate_3)                  # 50o
        fma     $along_2,$vy_3,$axis_y_3,$along_2       # 51e
        lqd     $farthest_3,144($a_bound_3)             # 51o
        nop     $127                                    # 52e pairing
        lqd     $cosine_2,96($a_bound_2)                # 52o
        fnms    $vx_2,$along,$axis_x_2,$vx_2            # 53e
        lqd     $vz_4,32($candidate_3)                  # 53o
        fnms    $vy_5,$along,$axis_y_2,$vy_2            # 54e
        lqd     $axis_y_4,64($a_bound_4)                # 54o
        fnms    $vz_5,$along,$axis_z_2,$vz_3            # 55e
        lqd     $apex_z_4,32($a_bound_4)                # 55o
        fm      $along_3,$vx_4,$axis_x_4                # 56e
        lqd     $axis_z_4,80($a_bound_4)                # 56o
        fma     $along_4,$vz_2,$axis_z_3,$along_2       # 57e
        lqd     $child_2,64($again_2)                   # 57o
        fa      $near_2,$reach_2,$farthest_2            # 58e
        lqd     $reach_4,48($candidate_3)               # 58o
        fm      $perp_2,$vx_2,$vx_2                     # 59e
        shlqbyi $cosine_3,$cosine_2,0                   # 59o copy
        fs      $vy_4,$vy_4,$apex_y_3                   # 60e
        lqd     $rays_radius_3,128($a_bound_4)          # 60o
        fa      $reach_3,$reach_3,$rays_radius_2        # 61e
        lqd     $cosine_4,96($a_bound_3)                # 61o
        fma     $beside_2,$along,$sine_2,$reach_2       # 62e
        lqd     $candidate_4,0($a_candidate_3)          # 62o
        fnms    $vx_3,$along_4,$axis_x_3,$vx_3          # 63e
        lqd     $sine_3,112($a_bound_3)                 # 63o
        fnms    $vy_6,$along_4,$axis_y_3,$vy_3          # 64e
        shufb   $child_3,$child_2,$again_2,$m_of_child  # 64o
        fma     $perp_3,$vy_5,$vy_5,$perp_2             # 65e
        lqd     $farthest_4,144($a_bound_4)             # 65o
        fma     $along_3,$vy_4,$axis_y_4,$along_3       # 66e
        lqd     $again,0($a_again_2)                    # 66o
        fs      $near_3,$near_2,$along                  # 67e
        lqd     $cosine,96($a_bound_4)                  # 67o
        fs      $vz_4,$vz_4,$apex_z_4                   # 68e
        lqd     $vy_7,16($candidate_4)                  # 68o
        fm      $perp_4,$vx_3,$vx_3                     # 69e
        rotqbyi $a_bound_2,$candidate_4,8               # 69o
        fnms    $vz_6,$along_4,$axis_z_3,$vz_2          # 70e
        lqd     $vz_7,32($candidate_4)                  # 70o
        fma     $perp_5,$vz_5,$vz_5,$perp_3             # 71e squared
        lqd     $reach_5,48($candidate_4)               # 71o
        fa      $reach,$reach_4,$rays_radius_3          # 72e
        lqd     $sine,112($a_bound_4)                   # 72o
        fa      $near,$reach_3,$farthest_3              # 73e
        lqd     $apex_y_3,16($a_bound_2)                # 73o
        fa      $ahead_2,$reach_2,$along                # 74e
        lqd     $apex_x_5,0($a_bound_2)                 # 74o
        fma     $perp_3,$vy_6,$vy_6,$perp_4             # 75e
        lqd     $apex_z_5,32($a_bound_2)                # 75o
        fma     $along_5,$vz_4,$axis_z_4,$along_3       # 76e
        lqd     $vx_5,0($candidate_4)                   # 76o
        a       $child_4,$child_3,$k_lanes              # 77e
        frsqest $t_y,$perp_5                            # 77o
        fa      $ahead_3,$reach_3,$along_4              # 78e
        lqd     $child_5,64($again)                     # 78o
        fs      $near_4,$near,$along_4                  # 79e
        shufb   $entry_2,$child_4,$again_2,$m_child     # 79o
        or      $ahead_4,$ahead_2,$near_3               # 80e
        hbrr    next_node_back,next_node                # 80o hint
        fi      $t_y,$perp_5,$t_y                       # 81e
        lqd     $axis_x_2,48($a_bound_2)                # 81o
        nop     $127                                    # 82e pairing
        shufb   $entry_3,$child_4,$again_2,$m_child+1   # 82o
        fma     $perp_6,$vz_6,$vz_6,$perp_3             # 83e squared
        shufb   $entry_4,$child_4,$again_2,$m_child+3   # 83o
        fa      $near_5,$reach,$farthest_4              # 84e
        shufb   $child_6,$child_5,$again,$m_of_child    # 84o
        fma     $beside_3,$along_4,$sine_3,$reach_3     # 85e
        lqd     $axis_z_2,80($a_bound_2)                # 85o
        fnms    $vx_6,$along_5,$axis_x_4,$vx_4          # 86e
        stqx    $entry_2,$a_first,$found                # 86o
        fnms    $vz_8,$along_5,$axis_z_4,$vz_4          # 87e
        lqd     $rays_radius_2,128($a_bound_2)          # 87o
        fm      $perp_7,$perp_5,$t_y                    # 88e
        shufb   $entry_5,$child_4,$again_2,$m_child+2   # 88o
        fa      $ahead_5,$reach,$along_5                # 89e
        frsqest $t_y,$perp_6                            # 89o
        fs      $near,$near_5,$along_5                  # 90e
        shlqbyi $cosine_5,$cosine_4,0                   # 90o copy
        or      $ahead,$ahead_3,$near_4                 # 91e
        fnms    $vy_6,$along_5,$axis_y_4,$vy_4          # 92e
        fs      $vz_3,$vz_7,$apex_z_5                   # 93e
        fnms    $beside,$perp_7,$cosine_3,$beside_2     # 94e
        fm      $perp,$vx_6,$vx_6                       # 95e
        fs      $vy_2,$vy_7,$apex_y_3                   # 96e
        fi      $t_y,$perp_6,$t_y                       # 97e
        a       $child_7,$child_6,$k_lanes              # 98e
        fs      $vx_2,$vx_5,$apex_x_5                   # 99e
        nor     $step,$beside,$ahead_4                  # 100e
        rotmi   $step,$step,-27                         # 102e
        andi    $step,$step,16                          # 106e
        a       $found_2,$found,$step                   # 108e
        rotqbyi $step1_2,$step,4                        # 108o
        rotqbyi $step3_2,$step,12                       # 109o
        rotqbyi $step2_2,$step,8                        # 110o
next_node:
            fma     $perp,$vy_6,$vy_6,$perp             # 0e
            lqd     $farthest,144($a_bound_2)           # 0o
        ai      $count,$count,-1                        # 1e
            lqd     $axis_y,64($a_bound_2)              # 1o
            fm      $along,$vx_2,$axis_x_2              # 2e
        lqd     $candidate,0($a_candidate)              # 2o
            a       $found_3,$found_2,$step1_2          # 3e
            stqx    $entry_3,$a_first,$found_2          # 3o
            fm      $perp_8,$perp_6,$t_y                # 4e
            shufb   $entry,$child_7,$again,$m_child     # 4o
            nop     $127                                # 5e pairing
            stqx    $entry_5,$a_first,$found_3          # 5o
        ai      $a_candidate,$a_candidate,16            # 6e
            shufb   $entry_5,$child_7,$again,$m_child+2 # 6o
            a       $found_3,$found_3,$step2_2          # 7e
            shufb   $entry_3,$child_7,$again,$m_child+1 # 7o
            fma     $along,$vy_2,$axis_y,$along         # 8e
        lqd     $vx,0($candidate)                       # 8o
            fma     $perp_6,$vz_8,$vz_8,$perp           # 9e squared
            stqx    $entry_4,$a_first,$found_3          # 9o
            fnms    $beside,$perp_8,$cosine_5,$beside_3 # 10e
            shufb   $entry_4,$child_7,$again,$m_child+3 # 10o
            fma     $beside_3,$along_5,$sine,$reach     # 11e
            lqd     $again,0($a_again)                  # 11o
            fa      $reach,$reach_5,$rays_radius_2      # 12e
        lqd     $vz,32($candidate)                      # 12o
            a       $found,$found_3,$step3_2            # 13e
            shlqbyi $cosine_5,$cosine,0                 # 13o copy
            fma     $along_5,$vz_3,$axis_z_2,$along     # 14e
            lqd     $cosine,96($a_bound_2)              # 14o
            ai      $a_again,$a_again,16                # 15e
            lqd     $sine,112($a_bound_2)               # 15o
            nor     $step,$beside,$ahead                # 16e
        rotqbyi $a_bound_2,$candidate,8                 # 16o
            or      $ahead,$ahead_5,$near               # 17e
        lqd     $reach_5,48($candidate)                 # 17o
            fa      $near,$reach,$farthest              # 18e
            lqd     $child_8,64($again)                 # 18o
            rotmi   $step,$step,-27                     # 19e
        lqd     $vy,16($candidate)                      # 19o
            fnms    $vx_7,$along_5,$axis_x_2,$vx_2      # 20e
        lqd     $apex_z_6,32($a_bound_2)                # 20o
            fnms    $vy_6,$along_5,$axis_y,$vy_2        # 21e
        lqd     $apex_y_2,16($a_bound_2)                # 21o
            fnms    $vz_8,$along_5,$axis_z_2,$vz_3      # 22e
            frsqest $t_y,$perp_6                        # 22o
            andi    $step,$step,16                      # 23e
        lqd     $apex_x_2,0($a_bound_2)                 # 23o
            fa      $ahead_5,$reach,$along_5            # 24e
        lqd     $axis_x_2,48($a_bound_2)                # 24o
            fs      $near,$near,$along_5                # 25e
            rotqbyi $step2_2,$step,8                    # 25o
        fs      $vz_3,$vz,$apex_z_6                     # 26e
        lqd     $axis_z_2,80($a_bound_2)                # 26o
            fm      $perp,$vx_7,$vx_7                   # 27e
            shufb   $child_8,$child_8,$again,$m_of_child # 27o
        fs      $vy_2,$vy,$apex_y_2                     # 28e
            rotqbyi $step1_2,$step,4                    # 28o
        fs      $vx_2,$vx,$apex_x_2                     # 29e
            rotqbyi $step3_2,$step,12                   # 29o
            fi      $t_y,$perp_6,$t_y                   # 30e
            stqx    $entry,$a_first,$found              # 30o
            a       $child_7,$child_8,$k_lanes          # 31e
        lqd     $rays_radius_2,128($a_bound_2)          # 31o
            a       $found_2,$found,$step               # 32e
next_node_back:
        brnz    $count,next_node                        # 32o
next_node_drain:
        fm      $along,$vx_2,$axis_x_2                  # 0e
        lqd     $axis_y,64($a_bound_2)                  # 0o
        fm      $perp_9,$perp_6,$t_y                    # 1e
        shufb   $entry,$child_7,$again,$m_child         # 1o
        fma     $perp,$vy_6,$vy_6,$perp                 # 2e
        shlqbyi $cosine_6,$cosine,0                     # 2o copy
        a       $found_4,$found_2,$step1_2              # 3e
        shufb   $entry_6,$child_7,$again,$m_child+3     # 3o
        fma     $beside_4,$along_5,$sine,$reach         # 4e
        shufb   $entry_7,$child_7,$again,$m_child+2     # 4o
        a       $found_5,$found_4,$step2_2              # 5e
        lqd     $farthest,144($a_bound_2)               # 5o
        fma     $along,$vy_2,$axis_y,$along             # 6e
        stqx    $entry_3,$a_first,$found_2              # 6o
        fnms    $beside,$perp_9,$cosine_5,$beside_3     # 7e
        stqx    $entry_5,$a_first,$found_4              # 7o
        fma     $perp_9,$vz_8,$vz_8,$perp               # 8e squared
        stqx    $entry_4,$a_first,$found_5              # 8o
        fa      $reach,$reach_5,$rays_radius_2          # 9e
        lqd     $sine,112($a_bound_2)                   # 9o
        ai      $a_again_3,$a_again,16                  # 10e
        lqd     $again_3,0($a_again)                    # 10o
        a       $found_6,$found_5,$step3_2              # 11e
        shufb   $entry_4,$child_7,$again,$m_child+1     # 11o
        fma     $along_5,$vz_3,$axis_z_2,$along         # 12e
        lqd     $cosine,96($a_bound_2)                  # 12o
        nor     $step,$beside,$ahead                    # 13e
        hbr     cull_nodes_return,$lr                   # 13o hint
        or      $ahead,$ahead_5,$near                   # 14e
        frsqest $t_y,$perp_9                            # 14o
        rotmi   $step,$step,-27                         # 15e
        lnop                                            # 15o pairing
        fa      $near,$reach,$farthest                  # 16e
        lqd     $child_9,64($again_3)                   # 16o
        ai      $a_again,$a_again_3,16                  # 17e
        stqx    $entry,$a_first,$found_6                # 17o
        fnms    $vx_3,$along_5,$axis_x_2,$vx_2          # 18e
        shlqbyi $cosine_5,$cosine,0                     # 18o copy
        fnms    $vy_6,$along_5,$axis_y,$vy_2            # 19e
        fnms    $vz_8,$along_5,$axis_z_2,$vz_3          # 20e
        fi      $t_y,$perp_9,$t_y                       # 21e
        lnop                                            # 21o pairing
        andi    $step,$step,16                          # 22e
        shufb   $child_9,$child_9,$again_3,$m_of_child  # 22o
        fa      $ahead_5,$reach,$along_5                # 23e
        lnop                                            # 23o pairing
        fm      $perp,$vx_3,$vx_3                       # 24e
        rotqbyi $step1_3,$step,4                        # 24o
        a       $found_2,$found_6,$step                 # 25e
        rotqbyi $step2_2,$step,8                        # 25o
        fma     $beside_5,$along_5,$sine,$reach         # 26e
        rotqbyi $step3_2,$step,12                       # 26o
        fs      $near,$near,$along_5                    # 27e
        stqx    $entry_4,$a_first,$found_2              # 27o
        fm      $perp_9,$perp_9,$t_y                    # 28e
        a       $found_7,$found_2,$step1_3              # 29e
        fma     $perp,$vy_6,$vy_6,$perp                 # 30e
        lnop                                            # 30o pairing
        a       $found_8,$found_7,$step2_2              # 31e
        stqx    $entry_7,$a_first,$found_7              # 31o
        a       $child_7,$child_9,$k_lanes              # 32e
        lnop                                            # 32o pairing
        a       $found,$found_8,$step3_2                # 33e
        stqx    $entry_6,$a_first,$found_8              # 33o
        fnms    $beside,$perp_9,$cosine_6,$beside_4     # 34e
        lqd     $again,0($a_again_3)                    # 34o
        or      $ahead_6,$ahead_5,$near                 # 35e
        shufb   $entry_4,$child_7,$again_3,$m_child+3   # 35o
        fma     $perp_6,$vz_8,$vz_8,$perp               # 36e squared
        shufb   $entry,$child_7,$again_3,$m_child       # 36o
        shufb   $entry_8,$child_7,$again_3,$m_child+2   # 37o
        shufb   $entry_9,$child_7,$again_3,$m_child+1   # 38o
        nor     $step,$beside,$ahead                    # 40e
        lqd     $child_4,64($again)                     # 40o
        nop     $127                                    # 41e pairing
        stqx    $entry,$a_first,$found                  # 41o
        rotmi   $step,$step,-27                         # 42e
        frsqest $t_y,$perp_6                            # 42o
        fi      $t_y,$perp_6,$t_y                       # 46e
        shufb   $child_4,$child_4,$again,$m_of_child    # 46o
        andi    $step,$step,16                          # 47e
        lnop                                            # 47o pairing
        a       $found_2,$found,$step                   # 49e
        rotqbyi $step1_4,$step,4                        # 49o
        a       $child_7,$child_4,$k_lanes              # 50e
        rotqbyi $step2_2,$step,8                        # 50o
        rotqbyi $step3_2,$step,12                       # 51o
        shufb   $entry_5,$child_7,$again,$m_child+1     # 52o
        fm      $perp_6,$perp_6,$t_y                    # 53e
        shufb   $entry,$child_7,$again,$m_child         # 53o
        a       $found_9,$found_2,$step1_4              # 54e
        shufb   $entry_10,$child_7,$again,$m_child+2    # 54o
        nop     $127                                    # 55e pairing
        stqx    $entry_9,$a_first,$found_2              # 55o
        a       $found_4,$found_9,$step2_2              # 56e
        stqx    $entry_8,$a_first,$found_9              # 56o
        nop     $127                                    # 57e pairing
        shufb   $entry_8,$child_7,$again,$m_child+3     # 57o
        a       $found,$found_4,$step3_2                # 58e
        stqx    $entry_4,$a_first,$found_4              # 58o
        fnms    $beside,$perp_6,$cosine_5,$beside_5     # 59e
        stqx    $entry,$a_first,$found                  # 60o
        nor     $step,$beside,$ahead_6                  # 65e
        rotmi   $step,$step,-27                         # 67e
        andi    $step,$step,16                          # 71e
        lnop                                            # 71o pairing
        a       $found_2,$found,$step                   # 73e
        rotqbyi $step1_2,$step,4                        # 73o
        rotqbyi $step2_2,$step,8                        # 74o
        stqx    $entry_5,$a_first,$found_2              # 75o
        rotqbyi $step3_2,$step,12                       # 76o
        a       $found_3,$found_2,$step1_2              # 77e
        a       $found_4,$found_3,$step2_2              # 79e
        stqx    $entry_10,$a_first,$found_3             # 79o
        a       $found,$found_4,$step3_2                # 81e
        stqx    $entry_8,$a_first,$found_4              # 81o
        a       $a_first,$a_first,$found                # 83e
cull_nodes_return:
        bi      $lr                                     # 83o
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
        lqd     $reach,48($candidate)                   # 16o
        nop     $127                                    # 17e pairing
        lqd     $rays_radius,128($a_bound)              # 17o
        fs      $vy,$vy,$apex_y                         # 18e
        lqd     $farthest,144($a_bound)                 # 18o
        nop     $127                                    # 19e pairing
        lqd     $sine,112($a_bound)                     # 19o
        fs      $vz,$vz,$apex_z                         # 20e
        lqd     $cosine,96($a_bound)                    # 20o
        lqd     $child,64($again)                       # 21o
        fm      $along,$vx,$axis_x                      # 22e
        fa      $reach,$reach,$rays_radius              # 23e
        shufb   $child,$child,$again,$m_of_child        # 27o
        fma     $along,$vy,$axis_y,$along               # 28e
        fa      $near,$reach,$farthest                  # 29e
        a       $child,$child,$k_lanes                  # 31e
        shufb   $entry,$child,$again,$m_child           # 33o
        fma     $along,$vz,$axis_z,$along               # 34e
        shufb   $entry_11,$child,$again,$m_child+1      # 34o
        shufb   $entry_9,$child,$again,$m_child+2       # 35o
        shufb   $entry_5,$child,$again,$m_child+3       # 36o
        stqx    $entry,$a_first,$found                  # 37o
        fnms    $vx,$along,$axis_x,$vx                  # 40e
        fnms    $vy,$along,$axis_y,$vy                  # 41e
        fnms    $vz,$along,$axis_z,$vz                  # 42e
        fma     $beside,$along,$sine,$reach             # 43e
        fa      $ahead,$reach,$along                    # 44e
        fs      $near,$near,$along                      # 45e
        fm      $perp,$vx,$vx                           # 46e
        or      $ahead,$ahead,$near                     # 51e
        fma     $perp,$vy,$vy,$perp                     # 52e
        fma     $perp,$vz,$vz,$perp                     # 58e squared
        frsqest $t_y,$perp                              # 64o
        fi      $t_y,$perp,$t_y                         # 68e
        fm      $perp,$perp,$t_y                        # 75e
        fnms    $beside,$perp,$cosine,$beside           # 81e
        nor     $step,$beside,$ahead                    # 87e
        rotmi   $step,$step,-27                         # 89e
        andi    $step,$step,16                          # 93e
        a       $found,$found,$step                     # 95e
        rotqbyi $step+1,$step,4                         # 95o
        rotqbyi $step+2,$step,8                         # 96o
        rotqbyi $step+3,$step,12                        # 97o
        stqx    $entry_11,$a_first,$found               # 98o
        a       $found,$found,$step+1                   # 99e
        a       $found_3,$found,$step+2                 # 101e
        stqx    $entry_9,$a_first,$found                # 101o
        a       $found,$found_3,$step+3                 # 103e
        stqx    $entry_5,$a_first,$found_3              # 103o
        nop     $127                                    # 104e pairing
        brnz    $count,next_node_short                  # 104o
        a       $a_first,$a_first,$found                # 105e
        bi      $lr                                     # 105o
endfunction cull_nodes
