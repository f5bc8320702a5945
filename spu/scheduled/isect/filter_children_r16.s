# filter_children_r16   of nodes' children, those that one of the packet's rays may meet
#   C       struct candidate *filter_children_r16(const struct candidate *, int count,
#                                                 struct candidate *);
#   In      $3 candidates as cull_nodes makes them with 4, $4 count (0 is none), $5 where the list goes,
#           which may be the same place; pointers 16-aligned
#   Out     candidates of such children, in order: object is the child, the rest the candidate's;
#           as many quadwords may be written as there are candidates
#           $3 behind the list
#   Uses    $2-$69, $79   Saves  -   Stack  0   Calls  -
#   Domain  bounds as bound_origins_r16 makes them; |d| = 1 within 4 ulp; the radius of a child's
#           sphere with a slack of 2^-18 (|c| + R), c its centre, R its radius; of a lane without a
#           child, -FARTHEST; distances from 2^-60 to 2^60
#   Error   0: no child is left out that a ray of the packet meets
#   Twin    lab/twins/src/cull_nodes.rs
#
# For rays that go every way, whose cone lets through nearly everything. With f = c - origin, for
# each ray:
#   b = f.d                     along the ray
#   l = f - b d                 across it
# The ray misses if one of these is below 0:
#   S^2 - l.l                   it passes the sphere
#   S + b                       the sphere is behind it
# S is the radius and a slack for the origin, 2^-18 (|apex| + r), where |apex| is the sum of the
# components' magnitudes and r the radius of the packet's bound. Both slacks together are 32 ulp
# of |f|. The roundings add up to 16, half of them because of the length of d.
# Scheduled by spu schedule from filter_children_r16.s

        .include "work_unit.inc"
        .include "macros.inc"

        .set    NEXT,3
        registers a_first                               # candidate
        registers count,a_list
        # constants
        .set    NEXT,10
        registers m_x,m_low,m_extent,m_entry,m_signs,m_halves,k_sign,k_slack,k_all
        # state
        registers a_candidate
        registers found                                 # children so far
        # the candidate
        registers candidate,a_bound,a_packet,extent,turned
        # the child
        registers m_lane                                # the shuffle that splats its word
        registers cx,cy,cz,reach,reach2,child,entry,offset
        # the rays
        registers ox,oy,oz,dx,dy,dz,fx,fy,fz,b
        registers disc                                  # to 48
        .set    NEXT,disc+4
        registers ahead                                 # to 52
        .set    NEXT,ahead+4
        registers t                                     # to 56
        .set    NEXT,t+4
        registers signs,low,any
        # the candidate, loaded again instead of being kept in a register for so long
        registers again

        .section .rodata
        .align  4
extent_words:                                           # x, y, z, and the second word of another
        .int    0x00010203,0x04050607,0x08090a0b,0x14151617
entry_words:
        .int    0x00010203,0x14151617,0x18191a1b,0x1c1d1e1f
signs_of_two:
        .int    0x0004080c,0x1014181c,0x0004080c,0x1014181c
halves: .int    0x00010203,0x04050607,0x18191a1b,0x1c1d1e1f

# The top bytes of sixteen words.
.macro  top_bytes out:req, words:req
        shufb   \out,$\words,$\words+1,$m_signs
        shufb   $low,$\words+2,$\words+3,$m_signs
        shufb   \out,\out,$low,$m_halves
.endm

function filter_children_r16
        .set count_2,79; .set a_candidate_2,2; .set again_2,6; .set candidate_2,5; .set offset_2,2
        .set a_packet_2,7; .set m_lane_2,8; .set ox_2,9; .set ox_3,22; .set ox_4,23; .set fx_2,25
        .set oy_2,26; .set fx_3,9; .set dx_2,29; .set fx_4,22; .set turned_2,30; .set oy_3,23
        .set dx_3,34; .set b_2,27; .set oy_4,31; .set dx_4,62; .set cz_2,32; .set b_3,40
        .set oz_2,30; .set fy_2,33; .set oz_3,39; .set fy_3,35; .set dy_2,43; .set fy_4,36
        .set dy_3,42; .set fy_5,54; .set dy_4,53; .set b_4,23; .set oz_4,26; .set dy_5,28
        .set b_5,31; .set reach_2,21; .set turned_3,40; .set a_bound_2,45; .set fz_2,37
        .set dz_2,56; .set fz_3,30; .set dz_3,46; .set fz_4,55; .set dz_4,39; .set dz_5,58
        .set fz_5,61; .set turned_4,26; .set b_6,32; .set extent_2,40; .set b_7,50
        .set m_lane_3,44; .set b_8,45; .set reach_3,52; .set cy_2,21; .set m_lane_4,24
        .set ox_5,32; .set ox_6,24; .set ox_7,29; .set reach2_2,48; .set oy_5,47; .set turned_5,38
        .set dx_5,49; .set oy_6,51; .set fx_5,57; .set dx_6,63; .set fx_6,64; .set oy_7,38
        .set disc1_2,33; .set t1_2,40; .set t_2,59; .set disc_2,62; .set t2_2,65; .set disc2_2,22
        .set t3_2,7; .set child_2,29; .set fy_6,28; .set oz_5,54; .set oz_6,41; .set b_9,66
        .set dy_6,67; .set fy_7,9; .set b_10,51; .set cz_3,68; .set fy_8,47; .set reach_4,32
        .set turned_6,46; .set disc1_3,36; .set disc_3,42; .set any_2,33; .set fz_6,69
        .set low_2,7; .set disc2_3,35; .set child_3,8; .set fy_9,5; .set b_11,38; .set fz_7,29
        .set oy_8,6; .set b_12,7; .set extent_3,28; .set reach_5,46; .set dz_6,8; .set ahead_2,45
        .set t_3,24; .set ahead2_2,31; .set t3_3,66; .set disc1_4,30; .set disc_4,36; .set any_3,24
        .set b_13,39; .set any_4,38; .set signs_2,45; .set b_14,30; .set low_3,28; .set any_5,6
        .set b_15,36; .set low_4,21; .set fx_7,7; .set fx_8,31; .set fx_9,2; .set fz_8,6
        .set ox_8,7; .set oy_9,8; .set oy_10,9; .set dx_7,22; .set turned_7,29; .set oy_11,5
        .set fz_9,31; .set oz_7,29; .set oz_8,35; .set dy_7,41; .set reach_6,6; .set turned_8,21
        .set t_4,42; .set b_16,21; .set any_6,30; .set any_7,32; .set t2_3,31; .set t3_4,35
        .set fx_10,4; .set any_8,10; .set fz_10,2; .set fz_11,4; .set ox_9,2; .set ox_10,5
        .set ox_11,6; .set dx_8,7; .set fx_11,5; .set fx_12,6; .set dx_9,9; .set oy_12,22
        .set dx_10,27; .set oy_13,25; .set b_17,29; .set cz_4,30; .set dy_8,32; .set fy_10,8
        .set oz_9,33; .set fy_11,22; .set dy_9,35; .set fy_12,25; .set oz_10,28; .set dy_10,40
        .set oz_11,43; .set turned_9,45; .set dz_7,45; .set dz_8,47; .set dz_9,48; .set fz_12,33
        .set fz_13,28; .set child_4,21; .set b_18,24; .set entry_2,7; .set disc_5,9; .set disc1_5,2
        .set fy_13,21; .set disc2_4,5; .set fy_14,7; .set disc3_2,6; .set fz_14,22; .set fz_15,25
        .set any_9,2; .set low_5,5
        ori     $a_candidate,$a_first,0                 # 0e
        lnop                                            # 0o pairing
        ori     $a_first,$a_list,0                      # 1e
        biz     $count,$lr                              # 1o
        ilhu    $k_all,0                                # 2e
        lqa     $m_extent,extent_words                  # 2o
        ilhu    $m_x,1                                  # 3e
        lqa     $m_entry,entry_words                    # 3o
        ilhu    $m_low,771                              # 4e
        lqa     $m_signs,signs_of_two                   # 4o
        clgti   $count_2,$count,2                       # 5e at least as many passes as overlap
        lqa     $m_halves,halves                        # 5o
        il      $found,0                                # 6e
        ilhu    $k_sign,0x8000                          # 7e
        ilhu    $k_slack,0x3680                         # 8e 2^-18
        iohl    $k_all,0xffff                           # 9e
        iohl    $m_x,515                                # 10e
        lnop                                            # 10o pairing
        iohl    $m_low,771                              # 11e
        brz     $count_2,next_child_short               # 11o too few passes
        ai      $a_candidate_2,$a_candidate,16          # 12e
        lqd     $candidate,0($a_candidate)              # 12o
        ai      $count,$count,-1                        # 13e
        lqd     $again_2,0($a_candidate)                # 13o
        ai      $a_candidate,$a_candidate_2,16          # 14e
        lqd     $candidate_2,0($a_candidate_2)          # 14o
        ai      $count,$count,-1                        # 15e
        lqd     $again,0($a_candidate_2)                # 15o
        shlqbii $offset_2,$found,4                      # 16o
        rotqbyi $a_bound,$candidate,8                   # 18o
        shufb   $m_lane,$candidate,$candidate,$m_low    # 19o
        rotqbyi $a_packet_2,$candidate,4                # 20o
        lqd     $cx,0($candidate)                       # 21o
        lqd     $turned,192($a_bound)                   # 22o
        andbi   $m_lane,$m_lane,15                      # 23e
        lqd     $extent,160($a_bound)                   # 23o
        nop     $127                                    # 24e pairing
        lqd     $ox,0($a_packet_2)                      # 24o
        a       $m_lane_2,$m_lane,$m_x                  # 25e
        lqd     $ox_2,16($a_packet_2)                   # 25o
        lqd     $ox_3,32($a_packet_2)                   # 26o
        lqd     $ox_4,48($a_packet_2)                   # 27o
        shufb   $cx,$cx,$cx,$m_lane_2                   # 28o
        shufb   $extent,$extent,$turned,$m_extent       # 29o
        lqd     $cy,16($candidate)                      # 30o
        lqd     $oy,80($a_packet_2)                     # 31o
        fs      $fx_2,$cx,$ox                           # 32e
        lqd     $dx,192($a_packet_2)                    # 32o
        andc    $extent,$extent,$k_sign                 # 33e
        lqd     $oy_2,64($a_packet_2)                   # 33o
        fs      $fx_3,$cx,$ox_2                         # 34e
        lqd     $dx_2,208($a_packet_2)                  # 34o
        fs      $fx_4,$cx,$ox_3                         # 35e
        rotqbyi $turned_2,$extent,8                     # 35o
        fs      $fx,$cx,$ox_4                           # 36e
        lqd     $oy_3,96($a_packet_2)                   # 36o
        nop     $127                                    # 37e pairing
        lqd     $dx_3,224($a_packet_2)                  # 37o
        fm      $b_2,$fx_2,$dx                          # 38e
        lqd     $oy_4,112($a_packet_2)                  # 38o
        fa      $extent,$extent,$turned_2               # 39e
        lqd     $dx_4,240($a_packet_2)                  # 39o
        fm      $b,$fx_3,$dx_2                          # 40e
        shufb   $cy,$cy,$cy,$m_lane_2                   # 40o
        lqd     $cz_2,32($candidate)                    # 41o
        lqd     $oz,160($a_packet_2)                    # 42o
        fm      $b_3,$fx_4,$dx_3                        # 43e
        lqd     $oz_2,144($a_packet_2)                  # 43o
        fs      $fy_2,$cy,$oy_2                         # 44e
        lqd     $oz_3,128($a_packet_2)                  # 44o
        fs      $fy_3,$cy,$oy_3                         # 45e
        lqd     $dy_2,288($a_packet_2)                  # 45o
        fs      $fy_4,$cy,$oy                           # 46e
        lqd     $dy_3,272($a_packet_2)                  # 46o
        fs      $fy_5,$cy,$oy_4                         # 47e
        lqd     $dy_4,256($a_packet_2)                  # 47o
        fm      $b_4,$fx,$dx_4                          # 48e
        lqd     $oz_4,176($a_packet_2)                  # 48o
        lqd     $dy_5,304($a_packet_2)                  # 49o
        shufb   $cz_2,$cz_2,$cz_2,$m_lane_2             # 50o
        fma     $b_5,$fy_3,$dy_2,$b_3                   # 51e
        lqd     $reach_2,48($candidate)                 # 51o
        fma     $b,$fy_4,$dy_3,$b                       # 52e
        rotqbyi $turned_3,$extent,4                     # 52o
        fma     $b_2,$fy_2,$dy_4,$b_2                   # 53e
        rotqbyi $a_bound_2,$candidate_2,8               # 53o
        fs      $fz_2,$cz_2,$oz                         # 54e
        lqd     $dz_2,320($a_packet_2)                  # 54o
        fs      $fz_3,$cz_2,$oz_2                       # 55e
        lqd     $dz_3,336($a_packet_2)                  # 55o
        fs      $fz_4,$cz_2,$oz_3                       # 56e
        lqd     $dz_4,352($a_packet_2)                  # 56o
        fa      $extent,$extent,$turned_3               # 57e
        lqd     $dz_5,368($a_packet_2)                  # 57o
        fs      $fz_5,$cz_2,$oz_4                       # 58e
        lqd     $turned_4,192($a_bound_2)               # 58o
        fma     $b_6,$fy_5,$dy_5,$b_4                   # 59e
        lqd     $extent_2,160($a_bound_2)               # 59o
        nop     $127                                    # 60e pairing
        shufb   $reach_2,$reach_2,$reach_2,$m_lane_2    # 60o
        fma     $b_7,$fz_3,$dz_3,$b                     # 61e
        shufb   $m_lane_3,$candidate_2,$candidate_2,$m_low # 61o
        fma     $b_8,$fz_4,$dz_2,$b_2                   # 62e
        rotqbyi $a_packet,$candidate_2,4                # 62o
        fma     $b_5,$fz_2,$dz_4,$b_5                   # 63e
        lqd     $cx,0($candidate_2)                     # 63o
        fma     $reach_3,$extent,$k_slack,$reach_2      # 64e
        lqd     $cy_2,16($candidate_2)                  # 64o
        andbi   $m_lane_4,$m_lane_3,15                  # 65e
        shufb   $extent_2,$extent_2,$turned_4,$m_extent # 65o
        fma     $b,$fz_5,$dz_5,$b_6                     # 66e
        lqd     $ox_5,0($a_packet)                      # 66o
        a       $m_lane,$m_lane_4,$m_x                  # 67e
        lqd     $ox_6,16($a_packet)                     # 67o
        fnms    $fx_3,$b_7,$dx_2,$fx_3                  # 68e
        lqd     $ox_7,32($a_packet)                     # 68o
        andc    $extent_2,$extent_2,$k_sign             # 69e
        shufb   $cx,$cx,$cx,$m_lane                     # 69o
        fm      $reach2_2,$reach_3,$reach_3             # 70e
        lqd     $oy_5,80($a_packet)                     # 70o
        fnms    $fx_2,$b_8,$dx,$fx_2                    # 71e
        rotqbyi $turned_5,$extent_2,8                   # 71o
        fnms    $fx_4,$b_5,$dx_3,$fx_4                  # 72e
        lqd     $dx_5,192($a_packet)                    # 72o
        fnms    $fx,$b,$dx_4,$fx                        # 73e
        lqd     $oy_6,64($a_packet)                     # 73o
        fs      $fx_5,$cx,$ox_5                         # 74e
        lqd     $dx_6,208($a_packet)                    # 74o
        fs      $fx_6,$cx,$ox_6                         # 75e
        shufb   $cy_2,$cy_2,$cy_2,$m_lane               # 75o
        fa      $extent,$extent_2,$turned_5             # 76e
        lqd     $cz_2,32($candidate_2)                  # 76o
        fnms    $fy_4,$b_7,$dy_3,$fy_4                  # 77e
        lqd     $oy_7,96($a_packet)                     # 77o
        fnms    $fy,$b_8,$dy_4,$fy_2                    # 78e
        lqd     $dx_3,224($a_packet)                    # 78o
        fnms    $disc1_2,$fx_3,$fx_3,$reach2_2          # 79e
        lqd     $t1_2,400($a_packet_2)                  # 79o
        fnms    $fy_3,$b_5,$dy_2,$fy_3                  # 80e
        lqd     $t_2,384($a_packet_2)                   # 80o
        fnms    $disc_2,$fx_2,$fx_2,$reach2_2           # 81e
        lqd     $t2_2,416($a_packet_2)                  # 81o
        fnms    $disc2_2,$fx_4,$fx_4,$reach2_2          # 82e
        lqd     $t3_2,432($a_packet_2)                  # 82o
        fs      $fx_2,$cx,$ox_7                         # 83e
        lqd     $child_2,64($again_2)                   # 83o
        fnms    $fy_6,$b,$dy_5,$fy_5                    # 84e
        lqd     $oz_5,144($a_packet)                    # 84o
        fnms    $disc+3,$fx,$fx,$reach2_2               # 85e
        lqd     $oz_6,128($a_packet)                    # 85o
        fm      $b_9,$fx_5,$dx_5                        # 86e
        lqd     $dy_6,272($a_packet)                    # 86o
        fs      $fy_7,$cy_2,$oy_6                       # 87e
        lqd     $dy_4,256($a_packet)                    # 87o
        fm      $b_10,$fx_6,$dx_6                       # 88e
        shufb   $cz_3,$cz_2,$cz_2,$m_lane               # 88o
        fs      $fy_8,$cy_2,$oy_5                       # 89e
        lqd     $reach_4,48($candidate_2)               # 89o
        fnms    $fz_3,$b_7,$dz_3,$fz_3                  # 90e
        rotqbyi $turned_6,$extent,4                     # 90o
        fnms    $fz_2,$b_5,$dz_4,$fz_2                  # 91e
        lqd     $oz_3,160($a_packet)                    # 91o
        fnms    $disc1_3,$fy_4,$fy_4,$disc1_2           # 92e
        lqd     $dy_2,288($a_packet)                    # 92o
        fnms    $disc_3,$fy,$fy,$disc_2                 # 93e
        shufb   $any_2,$t_2,$t1_2,$m_signs              # 93o
        fnms    $fz_6,$b_8,$dz_2,$fz_4                  # 94e
        shufb   $low_2,$t2_2,$t3_2,$m_signs             # 94o
        fnms    $disc2_3,$fy_3,$fy_3,$disc2_2           # 95e
        shufb   $child_3,$child_2,$child_2,$m_lane_2    # 95o
        fs      $fy_9,$cy_2,$oy_7                       # 96e
        lqd     $dz_2,320($a_packet)                    # 96o
        fm      $b_11,$fx_2,$dx_3                       # 97e
        lqd     $dz,336($a_packet)                      # 97o
        fnms    $fz_5,$b,$dz_5,$fz_5                    # 98e
        shufb   $any,$any_2,$low_2,$m_halves            # 98o
        fnms    $disc+3,$fy_6,$fy_6,$disc+3             # 99e
        shufb   $entry,$child_3,$again_2,$m_entry       # 99o
        fs      $fz_7,$cz_3,$oz_5                       # 100e
        lqd     $oy_8,112($a_packet)                    # 100o
        fs      $fz_4,$cz_3,$oz_6                       # 101e
        lqd     $t+1,400($a_packet)                     # 101o
        fma     $b_12,$fy_8,$dy_6,$b_10                 # 102e
        lqd     $oz_6,176($a_packet)                    # 102o
        fa      $extent_3,$extent,$turned_6             # 103e
        shufb   $reach_5,$reach_4,$reach_4,$m_lane      # 103o
        fma     $b_10,$fy_7,$dy_4,$b_9                  # 104e
        lqd     $dz_6,352($a_packet)                    # 104o
        fa      $ahead_2,$b_8,$reach_3                  # 105e
        lqd     $t_3,384($a_packet)                     # 105o
        fa      $ahead2_2,$b_5,$reach_3                 # 106e
        lqd     $t2_2,416($a_packet)                    # 106o
        fa      $ahead+1,$b_7,$reach_3                  # 107e
        lqd     $t3_3,432($a_packet)                    # 107o
        fnms    $disc1_4,$fz_3,$fz_3,$disc1_3           # 108e
        lqd     $dx_4,240($a_packet)                    # 108o
        fa      $ahead+3,$b,$reach_3                    # 109e
        lqd     $dz_5,368($a_packet)                    # 109o
        fnms    $disc_4,$fz_6,$fz_6,$disc_3             # 110e
        lqd     $ox_3,48($a_packet)                     # 110o
        fnms    $disc2_3,$fz_2,$fz_2,$disc2_3           # 111e
        lqd     $child,64($again)                       # 111o
        fs      $fz_2,$cz_3,$oz_3                       # 112e
        shufb   $any_3,$t_3,$t+1,$m_signs               # 112o
        fma     $b_13,$fy_9,$dy_2,$b_11                 # 113e
        hbrr    next_child_back,next_child              # 113o hint
        fnms    $disc+3,$fz_5,$fz_5,$disc+3             # 114e
        shufb   $any_4,$ahead_2,$ahead+1,$m_signs       # 114o
        fma     $b_7,$fz_7,$dz,$b_12                    # 115e
        shufb   $low_2,$ahead2_2,$ahead+3,$m_signs      # 115o
        fma     $reach_3,$extent_3,$k_slack,$reach_5    # 116e
        shufb   $signs_2,$disc_4,$disc1_4,$m_signs      # 116o
        fma     $b_14,$fz_4,$dz_2,$b_10                 # 117e
        shufb   $low_3,$t2_2,$t3_3,$m_signs             # 117o
        fs      $fz_5,$cz_3,$oz_6                       # 118e
        lnop                                            # 118o pairing
        fs      $fy_5,$cy_2,$oy_8                       # 119e
        shufb   $any_5,$any_4,$low_2,$m_halves          # 119o
        fma     $b_15,$fz_2,$dz_6,$b_13                 # 120e
        shufb   $low_4,$disc2_3,$disc+3,$m_signs        # 120o
        fnms    $fx_7,$b_7,$dx_6,$fx_6                  # 121e
        fm      $reach2_2,$reach_3,$reach_3             # 122e
        fnms    $fx_8,$b_14,$dx_5,$fx_5                 # 123e
        lnop                                            # 123o pairing
        fnms    $fy_3,$b_7,$dy_6,$fy_8                  # 124e
        shufb   $signs,$signs_2,$low_4,$m_halves        # 124o
next_child:
            fs      $fx,$cx,$ox_3                       # 0e
        lqd     $candidate,0($a_candidate)              # 0o
            or      $signs,$signs,$any_5                # 1e
            lqd     $dy,304($a_packet)                  # 1o
            fnms    $fy,$b_14,$dy_4,$fy_7               # 2e
            shufb   $child,$child,$child,$m_lane        # 2o
            or      $signs,$signs,$any                  # 3e
            shufb   $any,$any_3,$low_3,$m_halves        # 3o
            fnms    $disc+1,$fx_7,$fx_7,$reach2_2       # 4e
            stqx    $entry,$a_first,$offset_2           # 4o
            fa      $ahead,$b_14,$reach_3               # 5e
            rotqbii $signs,$signs,1                     # 5o signs to the bytes' last bits
            fnms    $fx_9,$b_15,$dx_3,$fx_2             # 6e
            shufb   $entry,$child,$again,$m_entry       # 6o
            fm      $b,$fx,$dx_4                        # 7e
            lnop                                        # 7o pairing
            fnms    $fy_9,$b_15,$dy_2,$fy_9             # 8e
        rotqbyi $a_bound,$candidate,8                   # 8o
            fnms    $fz,$b_7,$dz,$fz_7                  # 9e
            gbb     $signs,$signs                       # 9o
            fnms    $fz_8,$b_15,$dz_6,$fz_2             # 10e
        shufb   $m_lane,$candidate,$candidate,$m_low    # 10o
            fnms    $disc+1,$fy_3,$fy_3,$disc+1         # 11e
        rotqbyi $a_packet,$candidate,4                  # 11o
            fnms    $disc,$fx_8,$fx_8,$reach2_2         # 12e
        lqd     $cx,0($candidate)                       # 12o
            fma     $b,$fy_5,$dy,$b                     # 13e
        lqd     $turned,192($a_bound)                   # 13o
        andbi   $m_lane,$m_lane,15                      # 14e
        lqd     $extent,160($a_bound)                   # 14o
            fa      $ahead+2,$b_15,$reach_3             # 15e
            lnop                                        # 15o pairing
        a       $m_lane,$m_lane,$m_x                    # 16e
        lqd     $ox,0($a_packet)                        # 16o
            fa      $ahead+1,$b_7,$reach_3              # 17e
        lqd     $ox_8,16($a_packet)                     # 17o
            fnms    $disc,$fy,$fy,$disc                 # 18e
        shufb   $cx,$cx,$cx,$m_lane                     # 18o
            fma     $b,$fz_5,$dz_5,$b                   # 19e
        lqd     $again,0($a_candidate)                  # 19o
            fnms    $disc+1,$fz,$fz,$disc+1             # 20e
        shufb   $extent,$extent,$turned,$m_extent       # 20o
            fnms    $disc+2,$fx_9,$fx_9,$reach2_2       # 21e
        lqd     $cy,16($candidate)                      # 21o
            fnms    $fz,$b_14,$dz_2,$fz_4               # 22e
        lqd     $oy,80($a_packet)                       # 22o
        fs      $fx_9,$cx,$ox                           # 23e
        lqd     $ox,32($a_packet)                       # 23o
        fs      $fx_7,$cx,$ox_8                         # 24e
        lqd     $oy_9,112($a_packet)                    # 24o
        andc    $extent,$extent,$k_sign                 # 25e
        lqd     $dx,192($a_packet)                      # 25o
            fa      $ahead+3,$b,$reach_3                # 26e
        lqd     $oy_10,64($a_packet)                    # 26o
            fnms    $fy,$b,$dy,$fy_5                    # 27e
        shufb   $cy,$cy,$cy,$m_lane                     # 27o
            fnms    $fx,$b,$dx_4,$fx                    # 28e
        lqd     $dx_7,208($a_packet)                    # 28o
        fs      $fx_2,$cx,$ox                           # 29e
        rotqbyi $turned_7,$extent,8                     # 29o
            fnms    $disc+2,$fy_9,$fy_9,$disc+2         # 30e
        lqd     $oy_11,96($a_packet)                    # 30o
        fm      $b_14,$fx_9,$dx                         # 31e
        lqd     $t+1,400($a_packet)                     # 31o
            fnms    $fz_9,$b,$dz_5,$fz_5                # 32e
        lqd     $cz_2,32($candidate)                    # 32o
        fs      $fy_7,$cy,$oy_10                        # 33e
        lqd     $dx_3,224($a_packet)                    # 33o
        fm      $b,$fx_7,$dx_7                          # 34e
        lqd     $oz,160($a_packet)                      # 34o
        fa      $extent,$extent,$turned_7               # 35e
        lqd     $oz_7,144($a_packet)                    # 35o
        fs      $fy_9,$cy,$oy_11                        # 36e
        lqd     $oz_8,176($a_packet)                    # 36o
        fs      $fy_4,$cy,$oy                           # 37e
        lqd     $oz_3,128($a_packet)                    # 37o
            fnms    $disc,$fz,$fz,$disc                 # 38e
        shufb   $cz_2,$cz_2,$cz_2,$m_lane               # 38o
        fm      $b_3,$fx_2,$dx_3                        # 39e
        lqd     $dy_2,288($a_packet)                    # 39o
            fnms    $disc+3,$fx,$fx,$reach2_2           # 40e
        lqd     $dy_7,272($a_packet)                    # 40o
            fnms    $disc+2,$fz_8,$fz_8,$disc+2         # 41e
        lqd     $reach_6,48($candidate)                 # 41o
        fs      $fz_2,$cz_2,$oz                         # 42e
        lqd     $dy_4,256($a_packet)                    # 42o
        fs      $fz_7,$cz_2,$oz_7                       # 43e
        rotqbyi $turned_8,$extent,4                     # 43o
        fs      $fz_4,$cz_2,$oz_3                       # 44e
        lqd     $dz_2,320($a_packet)                    # 44o
        fma     $b_13,$fy_9,$dy_2,$b_3                  # 45e
        lqd     $dz,336($a_packet)                      # 45o
            fnms    $disc+3,$fy,$fy,$disc+3             # 46e
        lqd     $t_4,384($a_packet)                     # 46o
        fma     $b,$fy_4,$dy_7,$b                       # 47e
            shufb   $signs_2,$disc,$disc+1,$m_signs     # 47o
        fa      $extent,$extent,$turned_8               # 48e
        shufb   $reach_6,$reach_6,$reach_6,$m_lane      # 48o
        fma     $b_16,$fy_7,$dy_4,$b_14                 # 49e
            shufb   $low,$ahead+2,$ahead+3,$m_signs     # 49o
        fs      $fz_5,$cz_2,$oz_8                       # 50e
            shufb   $any_6,$ahead,$ahead+1,$m_signs     # 50o
            clgt    $any_7,$k_all,$signs                # 51e
        lqd     $dx_4,240($a_packet)                    # 51o
            fnms    $disc+3,$fz_9,$fz_9,$disc+3         # 52e
        lqd     $t2_3,416($a_packet)                    # 52o
        fma     $b_7,$fz_7,$dz,$b                       # 53e
        lqd     $t3_4,432($a_packet)                    # 53o
        fma     $reach_3,$extent,$k_slack,$reach_6      # 54e
            shufb   $any_5,$any_6,$low,$m_halves        # 54o
        fma     $b_14,$fz_4,$dz_2,$b_16                 # 55e
        shufb   $any_3,$t_4,$t+1,$m_signs               # 55o
        fs      $fy_5,$cy,$oy_9                         # 56e
        lqd     $dz_5,368($a_packet)                    # 56o
        ai      $a_candidate,$a_candidate,16            # 57e
        lqd     $dz_6,352($a_packet)                    # 57o
        ai      $count,$count,-1                        # 58e
            shufb   $low_4,$disc+2,$disc+3,$m_signs     # 58o
        fnms    $fx_7,$b_7,$dx_7,$fx_7                  # 59e
        lqd     $ox_3,48($a_packet)                     # 59o
            sf      $found,$any_7,$found                # 60e
        lqd     $child,64($again)                       # 60o
        fm      $reach2_2,$reach_3,$reach_3             # 61e
        shufb   $low_3,$t2_3,$t3_4,$m_signs             # 61o
        fnms    $fx_8,$b_14,$dx,$fx_9                   # 62e
            shufb   $signs,$signs_2,$low_4,$m_halves    # 62o
        fnms    $fy_3,$b_7,$dy_7,$fy_4                  # 63e
            shlqbii $offset_2,$found,4                  # 63o
        fma     $b_15,$fz_2,$dz_6,$b_13                 # 64e
next_child_back:
        brnz    $count,next_child                       # 64o
next_child_drain:
        fs      $fx,$cx,$ox_3                           # 0e
        lqd     $dy,304($a_packet)                      # 0o
        fnms    $fx_10,$b_15,$dx_3,$fx_2                # 1e
        shufb   $any_8,$any_3,$low_3,$m_halves          # 1o
        fnms    $fy,$b_14,$dy_4,$fy_7                   # 2e
        hbr     filter_children_r16_return,$lr          # 2o hint
        fnms    $disc+1,$fx_7,$fx_7,$reach2_2           # 3e
        shufb   $child,$child,$child,$m_lane            # 3o
        fnms    $fy_9,$b_15,$dy_2,$fy_9                 # 4e
        stqx    $entry,$a_first,$offset_2               # 4o
        fnms    $disc,$fx_8,$fx_8,$reach2_2             # 5e
        fm      $b,$fx,$dx_4                            # 6e
        fnms    $disc+2,$fx_10,$fx_10,$reach2_2         # 7e
        shufb   $entry,$child,$again,$m_entry           # 7o
        fnms    $fz,$b_7,$dz,$fz_7                      # 8e
        fnms    $fz_10,$b_15,$dz_6,$fz_2                # 9e
        fnms    $disc+1,$fy_3,$fy_3,$disc+1             # 10e
        fnms    $disc,$fy,$fy,$disc                     # 11e
        fma     $b,$fy_5,$dy,$b                         # 12e
        fnms    $fz_11,$b_14,$dz_2,$fz_4                # 13e
        fnms    $disc+2,$fy_9,$fy_9,$disc+2             # 14e
        fa      $ahead,$b_14,$reach_3                   # 15e
        fa      $ahead+2,$b_15,$reach_3                 # 16e
        fa      $ahead+1,$b_7,$reach_3                  # 17e
        fma     $b,$fz_5,$dz_5,$b                       # 18e
        fnms    $disc+1,$fz,$fz,$disc+1                 # 19e
        fnms    $disc,$fz_11,$fz_11,$disc               # 20e
        fnms    $disc+2,$fz_10,$fz_10,$disc+2           # 21e
        or      $signs,$signs,$any_5                    # 22e
        shufb   $any_6,$ahead,$ahead+1,$m_signs         # 23o
        fnms    $fx,$b,$dx_4,$fx                        # 24e
        fnms    $fy,$b,$dy,$fy_5                        # 25e
        fnms    $fz_9,$b,$dz_5,$fz_5                    # 26e
        shufb   $signs_2,$disc,$disc+1,$m_signs         # 26o
        fa      $ahead+3,$b,$reach_3                    # 27e
        or      $signs,$signs,$any                      # 28e
        fnms    $disc+3,$fx,$fx,$reach2_2               # 30e
        rotqbii $signs,$signs,1                         # 30o signs to the bytes' last bits
        shufb   $low,$ahead+2,$ahead+3,$m_signs         # 33o
        gbb     $signs,$signs                           # 34o
        fnms    $disc+3,$fy,$fy,$disc+3                 # 36e
        shufb   $any_5,$any_6,$low,$m_halves            # 37o
        clgt    $any_7,$k_all,$signs                    # 38e
        sf      $found,$any_7,$found                    # 40e
        fnms    $disc+3,$fz_9,$fz_9,$disc+3             # 42e
        shlqbii $offset_2,$found,4                      # 42o
        stqx    $entry,$a_first,$offset_2               # 46o
        shufb   $low_4,$disc+2,$disc+3,$m_signs         # 48o
        shufb   $signs,$signs_2,$low_4,$m_halves        # 52o
        or      $signs,$signs,$any_5                    # 56e
        or      $signs,$signs,$any_8                    # 58e
        rotqbii $signs,$signs,1                         # 60o signs to the bytes' last bits
        gbb     $signs,$signs                           # 64o
        clgt    $any_7,$k_all,$signs                    # 68e
        sf      $found,$any_7,$found                    # 70e
        shli    $found,$found,4                         # 72e
        a       $a_first,$a_first,$found                # 76e
filter_children_r16_return:
        bi      $lr                                     # 76o
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
        lqd     $extent,160($a_bound)                   # 10o
        andbi   $m_lane,$m_lane,15                      # 11e
        lqd     $turned,192($a_bound)                   # 11o
        nop     $127                                    # 12e pairing
        lqd     $ox,0($a_packet)                        # 12o
        a       $m_lane,$m_lane,$m_x                    # 13e
        lqd     $ox_9,16($a_packet)                     # 13o
        lqd     $ox_10,32($a_packet)                    # 14o
        lqd     $ox_11,48($a_packet)                    # 15o
        shufb   $cx,$cx,$cx,$m_lane                     # 16o
        shufb   $extent,$extent,$turned,$m_extent       # 17o
        lqd     $cy,16($candidate)                      # 18o
        lqd     $dx,192($a_packet)                      # 19o
        fs      $fx,$cx,$ox                             # 20e
        lqd     $oy,64($a_packet)                       # 20o
        andc    $extent,$extent,$k_sign                 # 21e
        lqd     $dx_8,208($a_packet)                    # 21o
        fs      $fx_9,$cx,$ox_9                         # 22e
        lqd     $oy_9,80($a_packet)                     # 22o
        fs      $fx_11,$cx,$ox_10                       # 23e
        rotqbyi $turned,$extent,8                       # 23o
        fs      $fx_12,$cx,$ox_11                       # 24e
        lqd     $dx_9,224($a_packet)                    # 24o
        nop     $127                                    # 25e pairing
        lqd     $oy_12,96($a_packet)                    # 25o
        fm      $b,$fx,$dx                              # 26e
        lqd     $dx_10,240($a_packet)                   # 26o
        fa      $extent,$extent,$turned                 # 27e
        lqd     $oy_13,112($a_packet)                   # 27o
        fm      $b_17,$fx_9,$dx_8                       # 28e
        shufb   $cy,$cy,$cy,$m_lane                     # 28o
        nop     $127                                    # 29e pairing
        lqd     $cz_4,32($candidate)                    # 29o
        fm      $b_5,$fx_11,$dx_9                       # 30e
        lqd     $dy,256($a_packet)                      # 30o
        nop     $127                                    # 31e pairing
        lqd     $oz,128($a_packet)                      # 31o
        fs      $fy,$cy,$oy                             # 32e
        lqd     $dy_8,272($a_packet)                    # 32o
        fs      $fy_10,$cy,$oy_9                        # 33e
        lqd     $oz_9,144($a_packet)                    # 33o
        fs      $fy_11,$cy,$oy_12                       # 34e
        lqd     $dy_9,288($a_packet)                    # 34o
        fs      $fy_12,$cy,$oy_13                       # 35e
        lqd     $oz_10,160($a_packet)                   # 35o
        fm      $b_15,$fx_12,$dx_10                     # 36e
        lqd     $dy_10,304($a_packet)                   # 36o
        nop     $127                                    # 37e pairing
        lqd     $oz_11,176($a_packet)                   # 37o
        fma     $b,$fy,$dy,$b                           # 38e
        rotqbyi $turned_9,$extent,4                     # 38o
        fma     $b_17,$fy_10,$dy_8,$b_17                # 39e
        lqd     $reach_2,48($candidate)                 # 39o
        fma     $b_5,$fy_11,$dy_9,$b_5                  # 40e
        shufb   $cz_4,$cz_4,$cz_4,$m_lane               # 40o
        nop     $127                                    # 41e pairing
        lqd     $dz_3,320($a_packet)                    # 41o
        fa      $extent,$extent,$turned_9               # 42e
        lqd     $dz_7,336($a_packet)                    # 42o
        fma     $b_15,$fy_12,$dy_10,$b_15               # 43e
        lqd     $dz_8,352($a_packet)                    # 43o
        fs      $fz_2,$cz_4,$oz                         # 44e
        lqd     $dz_9,368($a_packet)                    # 44o
        fs      $fz_12,$cz_4,$oz_9                      # 45e
        shufb   $reach_2,$reach_2,$reach_2,$m_lane      # 45o
        fs      $fz_13,$cz_4,$oz_10                     # 46e
        lqd     $t,384($a_packet)                       # 46o
        fs      $fz,$cz_4,$oz_11                        # 47e
        lqd     $t+1,400($a_packet)                     # 47o
        nop     $127                                    # 48e pairing
        lqd     $t+2,416($a_packet)                     # 48o
        fma     $reach,$extent,$k_slack,$reach_2        # 49e
        lqd     $t+3,432($a_packet)                     # 49o
        fma     $b,$fz_2,$dz_3,$b                       # 50e
        lqd     $child_4,64($again)                     # 50o
        fma     $b_4,$fz_12,$dz_7,$b_17                 # 51e
        fma     $b_18,$fz_13,$dz_8,$b_5                 # 52e
        fma     $b_17,$fz,$dz_9,$b_15                   # 53e
        shufb   $any,$t,$t+1,$m_signs                   # 53o
        fm      $reach2,$reach,$reach                   # 55e
        shufb   $low,$t+2,$t+3,$m_signs                 # 55o
        fnms    $fx,$b,$dx,$fx                          # 56e
        shufb   $child_4,$child_4,$child_4,$m_lane      # 56o
        fnms    $fx_9,$b_4,$dx_8,$fx_9                  # 57e
        fnms    $fx_11,$b_18,$dx_9,$fx_11               # 58e
        fnms    $fx_12,$b_17,$dx_10,$fx_12              # 59e
        shufb   $any,$any,$low,$m_halves                # 59o
        fnms    $fy,$b,$dy,$fy                          # 60e
        shufb   $entry_2,$child_4,$again,$m_entry       # 60o
        fnms    $fy_10,$b_4,$dy_8,$fy_10                # 61e
        fnms    $disc_5,$fx,$fx,$reach2                 # 62e
        fnms    $disc1_5,$fx_9,$fx_9,$reach2            # 63e
        lnop                                            # 63o pairing
        fnms    $fy_13,$b_18,$dy_9,$fy_11               # 64e
        stqx    $entry_2,$a_first,$offset               # 64o
        fnms    $disc2_4,$fx_11,$fx_11,$reach2          # 65e
        fnms    $fy_14,$b_17,$dy_10,$fy_12              # 66e
        fnms    $disc3_2,$fx_12,$fx_12,$reach2          # 67e
        fnms    $fz_14,$b,$dz_3,$fz_2                   # 68e
        fnms    $disc_5,$fy,$fy,$disc_5                 # 69e
        fnms    $fz_15,$b_4,$dz_7,$fz_12                # 70e
        fnms    $disc+1,$fy_10,$fy_10,$disc1_5          # 71e
        fnms    $fz_10,$b_18,$dz_8,$fz_13               # 72e
        fnms    $disc+2,$fy_13,$fy_13,$disc2_4          # 73e
        fnms    $fz,$b_17,$dz_9,$fz                     # 74e
        fnms    $disc+3,$fy_14,$fy_14,$disc3_2          # 75e
        fa      $ahead,$b,$reach                        # 76e
        fnms    $disc,$fz_14,$fz_14,$disc_5             # 77e
        fa      $ahead+1,$b_4,$reach                    # 78e
        fnms    $disc+1,$fz_15,$fz_15,$disc+1           # 79e
        fa      $ahead+2,$b_18,$reach                   # 80e
        fnms    $disc+2,$fz_10,$fz_10,$disc+2           # 81e
        fa      $ahead+3,$b_17,$reach                   # 82e
        fnms    $disc+3,$fz,$fz,$disc+3                 # 83e
        shufb   $any_9,$ahead,$ahead+1,$m_signs         # 84o
        shufb   $signs,$disc,$disc+1,$m_signs           # 85o
        shufb   $low,$ahead+2,$ahead+3,$m_signs         # 88o
        shufb   $low_5,$disc+2,$disc+3,$m_signs         # 89o
        shufb   $any_9,$any_9,$low,$m_halves            # 92o
        shufb   $signs,$signs,$low_5,$m_halves          # 93o
        or      $signs,$signs,$any_9                    # 97e
        or      $signs,$signs,$any                      # 99e
        rotqbii $signs,$signs,1                         # 101o signs to the bytes' last bits
        gbb     $signs,$signs                           # 105o
        clgt    $any,$k_all,$signs                      # 109e
        sf      $found,$any,$found                      # 111e
        brnz    $count,next_child_short                 # 111o
        shli    $found,$found,4                         # 113e
        lnop                                            # 113o pairing
        a       $a_first,$a_first,$found                # 117e
        bi      $lr                                     # 117o
endfunction filter_children_r16
