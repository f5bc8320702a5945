# cull_nodes   of nodes under packets' bounds, the children that some ray of the packet may meet
#   C       struct candidate *cull_nodes(const struct candidate *, int count, struct candidate *);
#   In      $3 candidates whose objects are NODEs, $4 count (0 is none), $5 where the list goes;
#           pointers 16-aligned
#   Out     candidates of such children, node by node, children in order: object is the child, the
#           rest the node's; one more quadword may be written
#           $3 behind the list
#   Uses    $2-$50, $79   Saves  -   Stack  0   Calls  -
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
# a slack of only 2 ulp of R, none of the spheres in kernels/tests/rays/conservative.rs was lost.
# The first ones were lost with a slack of minus 2 ulp of |c| + R.
# Scheduled by spu schedule from cull_nodes.s

        .include "work_unit.inc"
        .include "macros.inc"

        .set    NEXT,3
        registers a_first                               # candidate
        registers count,a_list
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

        .section .rodata
        .align  4
children:
    .irp child, 0,1,2,3
        .int    0x00010203+0x04040404*\child,0x14151617,0x18191a1b,0x1c1d1e1f
    .endr

function cull_nodes
        .set count_2,79; .set a_candidate_2,2; .set a_candidate_3,5; .set candidate_2,2
        .set candidate_3,5; .set a_bound_2,6; .set axis_y_2,7; .set axis_z_2,36; .set vx_2,9
        .set a_bound_3,8; .set vy_2,23; .set vz_2,24; .set along_2,17; .set axis_x_2,18
        .set axis_y_3,26; .set axis_z_3,27; .set vx_3,19; .set rays_radius_2,25; .set vy_3,20
        .set rays_radius_3,16; .set vz_3,29; .set reach_2,2; .set along_3,21; .set sine_2,30
        .set reach_3,49; .set farthest_2,25; .set vx_4,31; .set apex_x_2,16; .set cosine_2,6
        .set sine_3,32; .set vz_4,34; .set vy_4,35; .set vy_5,7; .set apex_y_2,23; .set apex_z_2,37
        .set beside_2,30; .set along_4,39; .set rays_radius_4,40; .set near_2,41; .set reach_4,5
        .set perp_2,42; .set cosine_3,50; .set child_2,6; .set near_3,16; .set ahead_2,31
        .set vx_5,18; .set vy_6,26; .set axis_y_4,21; .set perp_3,7; .set vz_5,8; .set entry_2,19
        .set entry_3,46; .set perp_4,18; .set entry_4,48; .set ahead_3,20; .set perp_5,27
        .set along_5,7; .set beside_3,47; .set perp_6,6; .set beside_4,5; .set cosine_4,2
        .set found_2,5; .set vx_6,6; .set found_3,16; .set a_again_2,4; .set cosine_5,4
        .set entry_5,9; .set entry_6,14; .set ahead_4,7; .set beside_5,2; .set entry_7,2
        .set found_4,6; .set entry_8,5; .set entry_9,6; .set found_5,2
        ori     $a_candidate,$a_first,0                 # 0e
        ori     $a_again,$a_first,0                     # 1e
        ori     $a_first,$a_list,0                      # 2e
        biz     $count,$lr                              # 2o
        clgti   $count_2,$count,3                       # 3e at least as many passes as overlap
        lqa     $m_child,children                       # 3o
        il      $found,0                                # 4e
        lqa     $m_child+1,children+16                  # 4o
        lqa     $m_child+2,children+32                  # 5o
        lqa     $m_child+3,children+48                  # 6o
        nop     $127                                    # 7e pairing
        brz     $count_2,next_node_short                # 7o too few passes
        ai      $a_candidate_2,$a_candidate,16          # 8e
        lqd     $candidate,0($a_candidate)              # 8o
        ai      $count,$count,-1                        # 9e
        lqd     $again,0($a_again)                      # 9o
        ai      $a_candidate_3,$a_candidate_2,16        # 10e
        lqd     $candidate_2,0($a_candidate_2)          # 10o
        ai      $count,$count,-1                        # 11e
        lnop                                            # 11o pairing
        ai      $a_candidate,$a_candidate_3,16          # 12e
        lqd     $candidate_3,0($a_candidate_3)          # 12o
        ai      $count,$count,-1                        # 13e
        lnop                                            # 13o pairing
        ai      $a_again,$a_again,16                    # 14e
        rotqbyi $a_bound_2,$candidate,8                 # 14o
        lqd     $vx,0($candidate)                       # 15o
        lqd     $vy,16($candidate)                      # 16o
        lqd     $vz,32($candidate)                      # 17o
        lqd     $apex_x,0($a_bound_2)                   # 18o
        lqd     $apex_y,16($a_bound_2)                  # 19o
        lqd     $axis_x,48($a_bound_2)                  # 20o
        lqd     $apex_z,32($a_bound_2)                  # 21o
        lqd     $axis_y_2,64($a_bound_2)                # 22o
        nop     $127                                    # 23e pairing
        lqd     $axis_z_2,80($a_bound_2)                # 23o
        fs      $vx_2,$vx,$apex_x                       # 24e
        rotqbyi $a_bound_3,$candidate_2,8               # 24o
        fs      $vy_2,$vy,$apex_y                       # 25e
        lqd     $vx,0($candidate_2)                     # 25o
        nop     $127                                    # 26e pairing
        lqd     $vy,16($candidate_2)                    # 26o
        fs      $vz_2,$vz,$apex_z                       # 27e
        lqd     $vz,32($candidate_2)                    # 27o
        lqd     $apex_x,0($a_bound_3)                   # 28o
        lqd     $apex_y,16($a_bound_3)                  # 29o
        fm      $along_2,$vx_2,$axis_x                  # 30e
        lqd     $axis_x_2,48($a_bound_3)                # 30o
        lqd     $apex_z,32($a_bound_3)                  # 31o
        lqd     $axis_y_3,64($a_bound_3)                # 32o
        nop     $127                                    # 33e pairing
        lqd     $axis_z_3,80($a_bound_3)                # 33o
        fs      $vx_3,$vx,$apex_x                       # 34e
        lqd     $rays_radius_2,128($a_bound_2)          # 34o
        fs      $vy_3,$vy,$apex_y                       # 35e
        lqd     $reach,48($candidate)                   # 35o
        fma     $along,$vy_2,$axis_y_2,$along_2         # 36e
        lqd     $rays_radius_3,128($a_bound_3)          # 36o
        fs      $vz_3,$vz,$apex_z                       # 37e
        lqd     $reach_2,48($candidate_2)               # 37o
        lqd     $farthest,144($a_bound_2)               # 38o
        rotqbyi $a_bound,$candidate_3,8                 # 39o
        fm      $along_3,$vx_3,$axis_x_2                # 40e
        lqd     $sine_2,112($a_bound_2)                 # 40o
        fa      $reach_3,$reach,$rays_radius_2          # 41e
        lqd     $farthest_2,144($a_bound_3)             # 41o
        fma     $along,$vz_2,$axis_z_2,$along           # 42e
        lqd     $vx_4,0($candidate_3)                   # 42o
        fa      $reach_2,$reach_2,$rays_radius_3        # 43e
        lqd     $apex_x_2,0($a_bound)                   # 43o
        lqd     $cosine_2,96($a_bound_2)                # 44o
        lqd     $sine_3,112($a_bound_3)                 # 45o
        fma     $along_3,$vy_3,$axis_y_3,$along_3       # 46e
        lqd     $vz_4,32($candidate_3)                  # 46o
        fa      $near,$reach_3,$farthest                # 47e
        lqd     $vy_4,16($candidate_3)                  # 47o
        fnms    $vx_2,$along,$axis_x,$vx_2              # 48e
        hbrr    next_node_back,next_node                # 48o hint
        fnms    $vy_5,$along,$axis_y_2,$vy_2            # 49e
        lqd     $apex_y_2,16($a_bound)                  # 49o
        fnms    $vz_2,$along,$axis_z_2,$vz_2            # 50e
        lqd     $apex_z_2,32($a_bound)                  # 50o
        fma     $beside_2,$along,$sine_2,$reach_3       # 51e
        lqd     $axis_x,48($a_bound)                    # 51o
        fma     $along_4,$vz_3,$axis_z_3,$along_3       # 52e
        lqd     $rays_radius_4,128($a_bound)            # 52o
        fa      $near_2,$reach_2,$farthest_2            # 53e
        lqd     $reach_4,48($candidate_3)               # 53o
        fm      $perp_2,$vx_2,$vx_2                     # 54e
        shlqbyi $cosine_3,$cosine_2,0                   # 54o copy
        fs      $vx_2,$vx_4,$apex_x_2                   # 55e
        lqd     $child_2,64($again)                     # 55o
        fs      $near_3,$near,$along                    # 56e
        lqd     $cosine,96($a_bound_3)                  # 56o
        fa      $ahead_2,$reach_3,$along                # 57e
        lqd     $farthest,144($a_bound)                 # 57o
        fnms    $vx_5,$along_4,$axis_x_2,$vx_3          # 58e
        lqd     $axis_z_2,80($a_bound)                  # 58o
        fnms    $vy_6,$along_4,$axis_y_3,$vy_3          # 59e
        lqd     $axis_y_4,64($a_bound)                  # 59o
        fma     $perp_3,$vy_5,$vy_5,$perp_2             # 60e
        lnop                                            # 60o pairing
        fnms    $vz_5,$along_4,$axis_z_3,$vz_3          # 61e
        shufb   $entry,$child_2,$again,$m_child+1       # 61o
        fs      $near,$near_2,$along_4                  # 62e
        shufb   $entry_2,$child_2,$again,$m_child       # 62o
        fs      $vy_2,$vy_4,$apex_y_2                   # 63e
        shufb   $entry_3,$child_2,$again,$m_child+2     # 63o
        fm      $perp_4,$vx_5,$vx_5                     # 64e
        shufb   $entry_4,$child_2,$again,$m_child+3     # 64o
        fa      $ahead_3,$reach_2,$along_4              # 65e
        fma     $perp_5,$vz_2,$vz_2,$perp_3             # 66e squared
        fs      $vz_2,$vz_4,$apex_z_2                   # 67e
        fm      $along_5,$vx_2,$axis_x                  # 68e
        fma     $beside_3,$along_4,$sine_3,$reach_2     # 69e
        fma     $perp_6,$vy_6,$vy_6,$perp_4             # 70e
        fa      $reach_3,$reach_4,$rays_radius_4        # 71e
        lnop                                            # 71o pairing
        or      $ahead,$ahead_2,$near_3                 # 72e
        frsqest $t_y,$perp_5                            # 72o
        fi      $t_y,$perp_5,$t_y                       # 76e
        fm      $perp,$perp_5,$t_y                      # 83e
        fnms    $beside_4,$perp,$cosine_3,$beside_2     # 89e
        lnop                                            # 89o pairing
next_node:
            fma     $perp,$vz_5,$vz_5,$perp_6           # 0e squared
            lqd     $again,0($a_again)                  # 0o
            fma     $along,$vy_2,$axis_y_4,$along_5     # 1e
            shlqbyi $cosine_4,$cosine,0                 # 1o copy
            nor     $step,$beside_4,$ahead              # 2e sign set: the child stays
        lqd     $candidate,0($a_candidate)              # 2o
            or      $ahead,$ahead_3,$near               # 3e
            lqd     $cosine,96($a_bound)                # 3o
        ai      $a_candidate,$a_candidate,16            # 4e
            stqx    $entry_2,$a_first,$found            # 4o
            rotmi   $step,$step,-27                     # 5e
            lqd     $sine,112($a_bound)                 # 5o
            fa      $near,$reach_3,$farthest            # 6e
            frsqest $t_y,$perp                          # 6o
            fma     $along,$vz_2,$axis_z_2,$along       # 7e
            lqd     $child,64($again)                   # 7o
        ai      $count,$count,-1                        # 8e
        rotqbyi $a_bound,$candidate,8                   # 8o
            ai      $a_again,$a_again,16                # 9e
        lqd     $vz,32($candidate)                      # 9o
            andi    $step,$step,16                      # 10e
        lqd     $vx,0($candidate)                       # 10o
            fi      $t_y,$perp,$t_y                     # 11e
        lqd     $vy,16($candidate)                      # 11o
            a       $found_2,$found,$step               # 12e
        lqd     $apex_x,0($a_bound)                     # 12o
            fnms    $vx_6,$along,$axis_x,$vx_2          # 13e
        lqd     $apex_y,16($a_bound)                    # 13o
            fnms    $vy_5,$along,$axis_y_4,$vy_2        # 14e
        lqd     $apex_z,32($a_bound)                    # 14o
            fnms    $vz_5,$along,$axis_z_2,$vz_2        # 15e
        lqd     $axis_x,48($a_bound)                    # 15o
            fs      $near,$near,$along                  # 16e
            stqx    $entry,$a_first,$found_2            # 16o
            nop     $127                                # 17e pairing
            shufb   $entry,$child,$again,$m_child+1     # 17o
        fs      $vx_2,$vx,$apex_x                       # 18e
            shufb   $entry_2,$child,$again,$m_child     # 18o
            fm      $perp_6,$vx_6,$vx_6                 # 19e
        lqd     $rays_radius,128($a_bound)              # 19o
        fs      $vy_2,$vy,$apex_y                       # 20e
            rotqbyi $step+1,$step,4                     # 20o
            fa      $ahead_3,$reach_3,$along            # 21e
            rotqbyi $step+2,$step,8                     # 21o
            fm      $perp,$perp,$t_y                    # 22e
            rotqbyi $step+3,$step,12                    # 22o
        fs      $vz_2,$vz,$apex_z                       # 23e
        lqd     $reach,48($candidate)                   # 23o
            a       $found_2,$found_2,$step+1           # 24e
        lqd     $farthest,144($a_bound)                 # 24o
            fma     $perp_6,$vy_5,$vy_5,$perp_6         # 25e
        lqd     $axis_z_2,80($a_bound)                  # 25o
        fm      $along_5,$vx_2,$axis_x                  # 26e
        lqd     $axis_y_4,64($a_bound)                  # 26o
            a       $found_3,$found_2,$step+2           # 27e
            stqx    $entry_3,$a_first,$found_2          # 27o
            fnms    $beside_4,$perp,$cosine_4,$beside_3 # 28e
            shufb   $entry_3,$child,$again,$m_child+2   # 28o
            a       $found,$found_3,$step+3             # 29e
            stqx    $entry_4,$a_first,$found_3          # 29o
            fma     $beside_3,$along,$sine,$reach_3     # 30e
            shufb   $entry_4,$child,$again,$m_child+3   # 30o
        fa      $reach_3,$reach,$rays_radius            # 31e
next_node_back:
        brnz    $count,next_node                        # 31o
next_node_drain:
        fma     $along,$vy_2,$axis_y_4,$along_5         # 0e
        shlqbyi $cosine_4,$cosine,0                     # 0o copy
        nor     $step,$beside_4,$ahead                  # 1e sign set: the child stays
        lqd     $again,0($a_again)                      # 1o
        fma     $perp,$vz_5,$vz_5,$perp_6               # 2e squared
        lqd     $cosine,96($a_bound)                    # 2o
        rotmi   $step,$step,-27                         # 3e
        stqx    $entry_2,$a_first,$found                # 3o
        or      $ahead,$ahead_3,$near                   # 4e
        lqd     $sine,112($a_bound)                     # 4o
        fa      $near,$reach_3,$farthest                # 5e
        hbr     cull_nodes_return,$lr                   # 5o hint
        fma     $along,$vz_2,$axis_z_2,$along           # 6e
        lnop                                            # 6o pairing
        andi    $step,$step,16                          # 7e
        lqd     $child,64($again)                       # 7o
        ai      $a_again,$a_again,16                    # 8e
        frsqest $t_y,$perp                              # 8o
        a       $found_2,$found,$step                   # 9e
        rotqbyi $step+1,$step,4                         # 9o
        ai      $a_again_2,$a_again,16                  # 10e
        shlqbyi $cosine_5,$cosine,0                     # 10o copy
        nop     $127                                    # 11e pairing
        rotqbyi $step+3,$step,12                        # 11o
        fnms    $vx_6,$along,$axis_x,$vx_2              # 12e
        stqx    $entry,$a_first,$found_2                # 12o
        fnms    $vy_5,$along,$axis_y_4,$vy_2            # 13e
        shufb   $entry_2,$child,$again,$m_child         # 13o
        fnms    $vz_5,$along,$axis_z_2,$vz_2            # 14e
        shufb   $entry_5,$child,$again,$m_child+2       # 14o
        fi      $t_y,$perp,$t_y                         # 15e
        shufb   $entry,$child,$again,$m_child+1         # 15o
        a       $found_2,$found_2,$step+1               # 16e
        rotqbyi $step+2,$step,8                         # 16o
        fa      $ahead_3,$reach_3,$along                # 17e
        shufb   $entry_6,$child,$again,$m_child+3       # 17o
        fm      $perp_6,$vx_6,$vx_6                     # 18e
        stqx    $entry_3,$a_first,$found_2              # 18o
        fs      $near,$near,$along                      # 19e
        a       $found_3,$found_2,$step+2               # 20e
        fma     $beside_4,$along,$sine,$reach_3         # 21e
        lnop                                            # 21o pairing
        fm      $perp,$perp,$t_y                        # 22e
        stqx    $entry_4,$a_first,$found_3              # 22o
        a       $found,$found_3,$step+3                 # 23e
        lqd     $again,0($a_again)                      # 23o
        fma     $perp_6,$vy_5,$vy_5,$perp_6             # 24e
        lnop                                            # 24o pairing
        or      $ahead_4,$ahead_3,$near                 # 25e
        stqx    $entry_2,$a_first,$found                # 25o
        fnms    $beside_5,$perp,$cosine_4,$beside_3     # 28e
        lqd     $child,64($again)                       # 29o
        fma     $perp,$vz_5,$vz_5,$perp_6               # 30e squared
        nor     $step,$beside_5,$ahead                  # 34e sign set: the child stays
        nop     $127                                    # 35e pairing
        shufb   $entry_7,$child,$again,$m_child+1       # 35o
        rotmi   $step,$step,-27                         # 36e
        frsqest $t_y,$perp                              # 36o
        shufb   $entry_2,$child,$again,$m_child         # 37o
        shufb   $entry_3,$child,$again,$m_child+2       # 38o
        shufb   $entry_4,$child,$again,$m_child+3       # 39o
        fi      $t_y,$perp,$t_y                         # 40e
        andi    $step,$step,16                          # 41e
        lnop                                            # 41o pairing
        a       $found_4,$found,$step                   # 43e
        rotqbyi $step+2,$step,8                         # 43o
        rotqbyi $step+1,$step,4                         # 44o
        stqx    $entry,$a_first,$found_4                # 45o
        rotqbyi $step+3,$step,12                        # 46o
        fm      $perp,$perp,$t_y                        # 47e
        a       $found_4,$found_4,$step+1               # 48e
        lnop                                            # 48o pairing
        a       $found_3,$found_4,$step+2               # 50e
        stqx    $entry_5,$a_first,$found_4              # 50o
        a       $found,$found_3,$step+3                 # 52e
        stqx    $entry_6,$a_first,$found_3              # 52o
        fnms    $beside_4,$perp,$cosine_5,$beside_4     # 53e
        stqx    $entry_2,$a_first,$found                # 54o
        nor     $step,$beside_4,$ahead_4                # 59e sign set: the child stays
        rotmi   $step,$step,-27                         # 61e
        andi    $step,$step,16                          # 65e
        lnop                                            # 65o pairing
        a       $found_2,$found,$step                   # 67e
        rotqbyi $step+1,$step,4                         # 67o
        rotqbyi $step+3,$step,12                        # 68o
        rotqbyi $step+2,$step,8                         # 69o
        stqx    $entry_7,$a_first,$found_2              # 70o
        a       $found_2,$found_2,$step+1               # 71e
        a       $found_3,$found_2,$step+2               # 73e
        stqx    $entry_3,$a_first,$found_2              # 73o
        a       $found,$found_3,$step+3                 # 75e
        stqx    $entry_4,$a_first,$found_3              # 75o
        a       $a_first,$a_first,$found                # 77e
cull_nodes_return:
        bi      $lr                                     # 77o
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
        shufb   $entry,$child,$again,$m_child           # 27o
        fma     $along,$vy,$axis_y,$along               # 28e
        shufb   $entry_7,$child,$again,$m_child+1       # 28o
        fa      $near,$reach,$farthest                  # 29e
        shufb   $entry_8,$child,$again,$m_child+2       # 29o
        shufb   $entry_9,$child,$again,$m_child+3       # 30o
        stqx    $entry,$a_first,$found                  # 31o
        fma     $along,$vz,$axis_z,$along               # 34e
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
        nor     $step,$beside,$ahead                    # 87e sign set: the child stays
        rotmi   $step,$step,-27                         # 89e
        andi    $step,$step,16                          # 93e
        a       $found,$found,$step                     # 95e
        rotqbyi $step+1,$step,4                         # 95o
        rotqbyi $step+2,$step,8                         # 96o
        rotqbyi $step+3,$step,12                        # 97o
        stqx    $entry_7,$a_first,$found                # 98o
        a       $found,$found,$step+1                   # 99e
        a       $found_5,$found,$step+2                 # 101e
        stqx    $entry_8,$a_first,$found                # 101o
        a       $found,$found_5,$step+3                 # 103e
        stqx    $entry_9,$a_first,$found_5              # 103o
        nop     $127                                    # 104e pairing
        brnz    $count,next_node_short                  # 104o
        a       $a_first,$a_first,$found                # 105e
        bi      $lr                                     # 105o
endfunction cull_nodes
