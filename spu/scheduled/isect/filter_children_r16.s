# filter_children_r16   of nodes' children, those that one of the packet's rays may meet
#   C       struct candidate *filter_children_r16(const struct candidate *, int count,
#                                                 struct candidate *);
#   In      $3 candidates as cull_nodes makes them with 4, $4 count (0 is none), $5 where the list
#           goes, which may be the same place; pointers 16-aligned
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

        .include "filter_tmpl.inc"

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

        filter_tables .rodata
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
        .set a_packet_2,7; .set ox_2,8; .set m_lane_2,22; .set ox_3,9; .set ox_4,23; .set fx_2,25
        .set dx_2,29; .set fx_3,9; .set dx_3,34; .set fx_4,8; .set turned_2,26; .set oy_2,30
        .set oy_3,23; .set oy_4,27; .set dy_2,43; .set b_2,26; .set dy_3,53; .set b_3,40
        .set cz_2,32; .set fy_2,31; .set oz_2,23; .set fy_3,33; .set dx_4,62; .set fy_4,36
        .set oz_3,35; .set fy_5,54; .set dy_4,28; .set oz_4,39; .set b_4,27; .set dy_5,30
        .set reach_2,21; .set turned_3,42; .set fz_2,37; .set a_bound_2,45; .set fz_3,55
        .set dz_2,56; .set fz_4,39; .set dz_3,46; .set dz_4,42; .set fz_5,61; .set extent_2,32
        .set dz_5,58; .set m_lane_3,23; .set b_5,35; .set b_6,50; .set turned_4,44; .set b_7,45
        .set cx_2,40; .set b_8,47; .set cy_2,48; .set reach_3,52; .set t1_2,21; .set t2_2,24
        .set extent_3,27; .set ox_5,29; .set fx_5,32; .set ox_6,25; .set ox_7,34; .set extent_4,38
        .set reach2_2,40; .set oy_5,44; .set turned_5,43; .set child_2,49; .set fx_6,51
        .set dx_5,57; .set fx_7,63; .set dx_6,64; .set t_2,29; .set disc2_2,32; .set t3_2,7
        .set disc1_2,59; .set oy_6,9; .set disc_2,8; .set cz_3,43; .set fy_6,28; .set disc3_2,41
        .set fy_7,30; .set fy_8,9; .set oz_5,40; .set fy_9,44; .set reach_4,54; .set any_2,21
        .set fz_6,42; .set cz_4,65; .set b_9,62; .set turned_6,66; .set b_10,67; .set oz_6,68
        .set fy_10,5; .set oz_7,29; .set disc_3,31; .set dy_6,69; .set b_11,36; .set child_3,8
        .set disc3_3,22; .set low_2,7; .set fz_7,24; .set t1_3,30; .set disc2_3,28; .set fz_8,29
        .set b_12,7; .set ahead2_2,6; .set oz_8,21; .set fz_9,32; .set reach_5,39; .set ahead3_2,41
        .set oy_7,45; .set dz_6,8; .set extent_5,28; .set t2_3,38; .set b_13,49; .set t_3,54
        .set t3_3,61; .set disc3_4,24; .set ahead1_2,66; .set low_3,6; .set ahead_2,35
        .set ox_8,22; .set low_4,39; .set any_3,24; .set b_14,30; .set low_5,28; .set signs_2,45
        .set reach2_3,48; .set fx_8,7; .set fx_9,31; .set any_4,6; .set fy_11,35; .set fx_10,2
        .set fz_10,6; .set ox_9,7; .set oy_8,8; .set dx_7,22; .set turned_7,29; .set oy_9,5
        .set fz_11,31; .set dy_7,41; .set reach_6,6; .set turned_8,21; .set b_15,39; .set t_4,42
        .set b_16,21; .set any_5,30; .set any_6,32; .set t2_4,31; .set t3_4,35; .set low_6,21
        .set fx_11,4; .set any_7,10; .set fz_12,2; .set fz_13,4; .set ox_10,2; .set ox_11,5
        .set ox_12,6; .set dx_8,7; .set fx_12,5; .set fx_13,6; .set dx_9,9; .set oy_10,22
        .set dx_10,27; .set oy_11,25; .set b_17,29; .set cz_5,30; .set b_18,31; .set dy_8,32
        .set fy_12,8; .set oz_9,33; .set fy_13,22; .set dy_9,35; .set fy_14,25; .set oz_10,28
        .set dy_10,40; .set oz_11,43; .set turned_9,45; .set dz_7,45; .set dz_8,47; .set dz_9,48
        .set fz_14,33; .set fz_15,28; .set child_4,21; .set b_19,23; .set b_20,24; .set entry_2,7
        .set disc_4,9; .set disc1_3,2; .set fy_15,21; .set disc2_4,5; .set fy_16,7; .set disc3_5,6
        .set fz_16,22; .set fz_17,25; .set any_8,2; .set low_7,5
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
        rotqbyi $a_packet_2,$candidate,4                # 19o
        shufb   $m_lane,$candidate,$candidate,$m_low    # 20o
        lqd     $cx,0($candidate)                       # 21o
        lqd     $turned,192($a_bound)                   # 22o
        nop     $127                                    # 23e pairing
        lqd     $extent,160($a_bound)                   # 23o
        andbi   $m_lane,$m_lane,15                      # 24e
        lqd     $ox,32($a_packet_2)                     # 24o
        nop     $127                                    # 25e pairing
        lqd     $ox_2,0($a_packet_2)                    # 25o
        a       $m_lane_2,$m_lane,$m_x                  # 26e
        lqd     $ox_3,16($a_packet_2)                   # 26o
        lqd     $cy,16($candidate)                      # 27o
        shufb   $cx,$cx,$cx,$m_lane_2                   # 28o
        shufb   $extent,$extent,$turned,$m_extent       # 29o
        lqd     $dx,192($a_packet_2)                    # 30o
        nop     $127                                    # 31e pairing
        lqd     $ox_4,48($a_packet_2)                   # 31o
        fs      $fx_2,$cx,$ox                           # 32e
        lqd     $dx_2,208($a_packet_2)                  # 32o
        andc    $extent,$extent,$k_sign                 # 33e
        shufb   $cy,$cy,$cy,$m_lane_2                   # 33o
        fs      $fx_3,$cx,$ox_3                         # 34e
        lqd     $dx_3,224($a_packet_2)                  # 34o
        fs      $fx_4,$cx,$ox_2                         # 35e
        rotqbyi $turned_2,$extent,8                     # 35o
        nop     $127                                    # 36e pairing
        lqd     $oy_2,112($a_packet_2)                  # 36o
        fs      $fx,$cx,$ox_4                           # 37e
        lqd     $oy_3,64($a_packet_2)                   # 37o
        nop     $127                                    # 38e pairing
        lqd     $oy_4,96($a_packet_2)                   # 38o
        fa      $extent,$extent,$turned_2               # 39e
        lqd     $oy,80($a_packet_2)                     # 39o
        fm      $b,$fx_3,$dx_2                          # 40e
        lqd     $dy_2,288($a_packet_2)                  # 40o
        fm      $b_2,$fx_4,$dx                          # 41e
        lqd     $dy_3,256($a_packet_2)                  # 41o
        fm      $b_3,$fx_2,$dx_3                        # 42e
        lqd     $cz_2,32($candidate)                    # 42o
        fs      $fy_2,$cy,$oy_3                         # 43e
        lqd     $oz_2,144($a_packet_2)                  # 43o
        fs      $fy_3,$cy,$oy_4                         # 44e
        lqd     $dx_4,240($a_packet_2)                  # 44o
        fs      $fy_4,$cy,$oy                           # 45e
        lqd     $oz_3,176($a_packet_2)                  # 45o
        fs      $fy_5,$cy,$oy_2                         # 46e
        lqd     $dy_4,272($a_packet_2)                  # 46o
        lqd     $oz,160($a_packet_2)                    # 47o
        lqd     $oz_4,128($a_packet_2)                  # 48o
        fma     $b_2,$fy_2,$dy_3,$b_2                   # 49e
        shufb   $cz_2,$cz_2,$cz_2,$m_lane_2             # 49o
        fm      $b_4,$fx,$dx_4                          # 50e
        lqd     $dy_5,304($a_packet_2)                  # 50o
        fma     $b_3,$fy_3,$dy_2,$b_3                   # 51e
        lqd     $reach_2,48($candidate)                 # 51o
        fma     $b,$fy_4,$dy_4,$b                       # 52e
        rotqbyi $turned_3,$extent,4                     # 52o
        fs      $fz_2,$cz_2,$oz                         # 53e
        rotqbyi $a_bound_2,$candidate_2,8               # 53o
        fs      $fz_3,$cz_2,$oz_4                       # 54e
        lqd     $dz_2,320($a_packet_2)                  # 54o
        fs      $fz_4,$cz_2,$oz_2                       # 55e
        lqd     $dz_3,336($a_packet_2)                  # 55o
        fa      $extent,$extent,$turned_3               # 56e
        lqd     $dz_4,352($a_packet_2)                  # 56o
        fs      $fz_5,$cz_2,$oz_3                       # 57e
        lqd     $extent_2,160($a_bound_2)               # 57o
        fma     $b_4,$fy_5,$dy_5,$b_4                   # 58e
        lqd     $dz_5,368($a_packet_2)                  # 58o
        nop     $127                                    # 59e pairing
        shufb   $m_lane_3,$candidate_2,$candidate_2,$m_low # 59o
        fma     $b_5,$fz_3,$dz_2,$b_2                   # 60e
        shufb   $reach_2,$reach_2,$reach_2,$m_lane_2    # 60o
        fma     $b_6,$fz_4,$dz_3,$b                     # 61e
        lqd     $turned_4,192($a_bound_2)               # 61o
        fma     $b_7,$fz_2,$dz_4,$b_3                   # 62e
        lqd     $cx_2,0($candidate_2)                   # 62o
        andbi   $m_lane,$m_lane_3,15                    # 63e
        rotqbyi $a_packet,$candidate_2,4                # 63o
        fma     $b_8,$fz_5,$dz_5,$b_4                   # 64e
        lqd     $cy_2,16($candidate_2)                  # 64o
        fma     $reach_3,$extent,$k_slack,$reach_2      # 65e
        lqd     $t1_2,400($a_packet_2)                  # 65o
        a       $m_lane,$m_lane,$m_x                    # 66e
        lqd     $t2_2,416($a_packet_2)                  # 66o
        fnms    $fx_3,$b_6,$dx_2,$fx_3                  # 67e
        shufb   $extent_3,$extent_2,$turned_4,$m_extent # 67o
        fnms    $fx_4,$b_5,$dx,$fx_4                    # 68e
        lqd     $ox_5,0($a_packet)                      # 68o
        fnms    $fx_5,$b_7,$dx_3,$fx_2                  # 69e
        lqd     $ox_6,16($a_packet)                     # 69o
        fnms    $fx,$b_8,$dx_4,$fx                      # 70e
        lqd     $ox_7,32($a_packet)                     # 70o
        andc    $extent_4,$extent_3,$k_sign             # 71e
        shufb   $cx,$cx_2,$cx_2,$m_lane                 # 71o
        fm      $reach2_2,$reach_3,$reach_3             # 72e
        lqd     $oy_5,80($a_packet)                     # 72o
        fnms    $fy_3,$b_7,$dy_2,$fy_3                  # 73e
        rotqbyi $turned_5,$extent_4,8                   # 73o
        fnms    $fy_2,$b_5,$dy_3,$fy_2                  # 74e
        lqd     $child_2,64($again_2)                   # 74o
        fs      $fx_6,$cx,$ox_5                         # 75e
        lqd     $dx_5,192($a_packet)                    # 75o
        fs      $fx_7,$cx,$ox_6                         # 76e
        lqd     $dx_6,208($a_packet)                    # 76o
        fs      $fx_2,$cx,$ox_7                         # 77e
        lqd     $t_2,384($a_packet_2)                   # 77o
        fnms    $disc2_2,$fx_5,$fx_5,$reach2_2          # 78e
        lqd     $t3_2,432($a_packet_2)                  # 78o
        fnms    $disc1_2,$fx_3,$fx_3,$reach2_2          # 79e
        lqd     $oy_6,64($a_packet)                     # 79o
        fnms    $disc_2,$fx_4,$fx_4,$reach2_2           # 80e
        shufb   $cy_2,$cy_2,$cy_2,$m_lane               # 80o
        fa      $extent_4,$extent_4,$turned_5           # 81e
        lqd     $cz_3,32($candidate_2)                  # 81o
        fnms    $fy_6,$b_6,$dy_4,$fy_4                  # 82e
        lqd     $oy,96($a_packet)                       # 82o
        fnms    $disc3_2,$fx,$fx,$reach2_2              # 83e
        lqd     $dx_3,224($a_packet)                    # 83o
        fnms    $fy_7,$b_8,$dy_5,$fy_5                  # 84e
        lqd     $dy_3,256($a_packet)                    # 84o
        fs      $fy_8,$cy_2,$oy_6                       # 85e
        lqd     $oz_5,128($a_packet)                    # 85o
        fs      $fy_9,$cy_2,$oy_5                       # 86e
        lqd     $reach_4,48($candidate_2)               # 86o
        fnms    $fz_2,$b_7,$dz_4,$fz_2                  # 87e
        shufb   $any_2,$t_2,$t1_2,$m_signs              # 87o
        fnms    $fz_6,$b_5,$dz_2,$fz_3                  # 88e
        shufb   $cz_4,$cz_3,$cz_3,$m_lane               # 88o
        fm      $b_9,$fx_6,$dx_5                        # 89e
        rotqbyi $turned_6,$extent_4,4                   # 89o
        fm      $b_10,$fx_7,$dx_6                       # 90e
        lqd     $oz_6,160($a_packet)                    # 90o
        fs      $fy_10,$cy_2,$oy                        # 91e
        lqd     $oz_7,144($a_packet)                    # 91o
        fnms    $disc_3,$fy_2,$fy_2,$disc_2             # 92e
        lqd     $dy_6,272($a_packet)                    # 92o
        fm      $b_11,$fx_2,$dx_3                       # 93e
        shufb   $child_3,$child_2,$child_2,$m_lane_2    # 93o
        fs      $fz_3,$cz_4,$oz_5                       # 94e
        lqd     $dz,336($a_packet)                      # 94o
        fnms    $disc3_3,$fy_7,$fy_7,$disc3_2           # 95e
        shufb   $low_2,$t2_2,$t3_2,$m_signs             # 95o
        fnms    $fz_7,$b_6,$dz_3,$fz_4                  # 96e
        lqd     $t1_3,400($a_packet)                    # 96o
        fnms    $disc+1,$fy_6,$fy_6,$disc1_2            # 97e
        lqd     $dy_2,288($a_packet)                    # 97o
        fnms    $disc2_3,$fy_3,$fy_3,$disc2_2           # 98e
        lqd     $dz_2,320($a_packet)                    # 98o
        fs      $fz_8,$cz_4,$oz_7                       # 99e
        shufb   $any,$any_2,$low_2,$m_halves            # 99o
        fma     $b_12,$fy_9,$dy_6,$b_10                 # 100e
        shufb   $entry,$child_3,$again_2,$m_entry       # 100o
        fa      $ahead2_2,$b_7,$reach_3                 # 101e
        lqd     $oz_8,176($a_packet)                    # 101o
        fnms    $fz_9,$b_8,$dz_5,$fz_5                  # 102e
        shufb   $reach_5,$reach_4,$reach_4,$m_lane      # 102o
        fa      $ahead3_2,$b_8,$reach_3                 # 103e
        lqd     $oy_7,112($a_packet)                    # 103o
        fnms    $disc+2,$fz_2,$fz_2,$disc2_3            # 104e
        lqd     $dz_6,352($a_packet)                    # 104o
        fa      $extent_5,$extent_4,$turned_6           # 105e
        lqd     $t2_3,416($a_packet)                    # 105o
        fma     $b_13,$fy_8,$dy_3,$b_9                  # 106e
        lqd     $t_3,384($a_packet)                     # 106o
        fnms    $disc+1,$fz_7,$fz_7,$disc+1             # 107e
        lqd     $t3_3,432($a_packet)                    # 107o
        fnms    $disc3_4,$fz_9,$fz_9,$disc3_3           # 108e
        lqd     $dx_4,240($a_packet)                    # 108o
        fa      $ahead1_2,$b_6,$reach_3                 # 109e
        lqd     $dz_5,368($a_packet)                    # 109o
        fs      $fz_2,$cz_4,$oz_6                       # 110e
        lqd     $child,64($again)                       # 110o
        fma     $b_11,$fy_10,$dy_2,$b_11                # 111e
        shufb   $low_3,$ahead2_2,$ahead3_2,$m_signs     # 111o
        fa      $ahead_2,$b_5,$reach_3                  # 112e
        lqd     $ox_8,48($a_packet)                     # 112o
        fnms    $disc_3,$fz_6,$fz_6,$disc_3             # 113e
        hbrr    next_child_back,next_child              # 113o hint
        fma     $reach_3,$extent_5,$k_slack,$reach_5    # 114e
        shufb   $low_4,$disc+2,$disc3_4,$m_signs        # 114o
        fma     $b_6,$fz_8,$dz,$b_12                    # 115e
        shufb   $any_3,$t_3,$t1_3,$m_signs              # 115o
        fma     $b_14,$fz_3,$dz_2,$b_13                 # 116e
        shufb   $low_5,$t2_3,$t3_3,$m_signs             # 116o
        fs      $fz_5,$cz_4,$oz_8                       # 117e
        lnop                                            # 117o pairing
        fma     $b_11,$fz_2,$dz_6,$b_11                 # 118e
        shufb   $any_2,$ahead_2,$ahead1_2,$m_signs      # 118o
        fs      $fy_5,$cy_2,$oy_7                       # 119e
        shufb   $signs_2,$disc_3,$disc+1,$m_signs       # 119o
        fm      $reach2_3,$reach_3,$reach_3             # 120e
        fnms    $fx_8,$b_6,$dx_6,$fx_7                  # 121e
        fnms    $fx_9,$b_14,$dx_5,$fx_6                 # 122e
        shufb   $any_4,$any_2,$low_3,$m_halves          # 122o
        fnms    $fy_11,$b_6,$dy_6,$fy_9                 # 123e
        shufb   $signs,$signs_2,$low_4,$m_halves        # 123o
next_child:
            fs      $fx,$cx,$ox_8                       # 0e
        lqd     $candidate,0($a_candidate)              # 0o
            or      $signs,$signs,$any_4                # 1e
            lqd     $dy,304($a_packet)                  # 1o
            fnms    $fy,$b_14,$dy_3,$fy_8               # 2e
            shufb   $child,$child,$child,$m_lane        # 2o
            or      $signs,$signs,$any                  # 3e
            shufb   $any,$any_3,$low_5,$m_halves        # 3o
            fnms    $disc+1,$fx_8,$fx_8,$reach2_3       # 4e
            stqx    $entry,$a_first,$offset_2           # 4o
            fa      $ahead,$b_14,$reach_3               # 5e
            rotqbii $signs,$signs,1                     # 5o signs to the bytes' last bits
            fnms    $fx_10,$b_11,$dx_3,$fx_2            # 6e
            shufb   $entry,$child,$again,$m_entry       # 6o
            fm      $b,$fx,$dx_4                        # 7e
            lnop                                        # 7o pairing
            fnms    $fy_10,$b_11,$dy_2,$fy_10           # 8e
        rotqbyi $a_bound,$candidate,8                   # 8o
            fnms    $fz,$b_6,$dz,$fz_8                  # 9e
            gbb     $signs,$signs                       # 9o
            fnms    $fz_10,$b_11,$dz_6,$fz_2            # 10e
        shufb   $m_lane,$candidate,$candidate,$m_low    # 10o
            fnms    $disc+1,$fy_11,$fy_11,$disc+1       # 11e
        rotqbyi $a_packet,$candidate,4                  # 11o
            fnms    $disc,$fx_9,$fx_9,$reach2_3         # 12e
        lqd     $cx,0($candidate)                       # 12o
            fma     $b,$fy_5,$dy,$b                     # 13e
        lqd     $turned,192($a_bound)                   # 13o
        andbi   $m_lane,$m_lane,15                      # 14e
        lqd     $extent,160($a_bound)                   # 14o
            fa      $ahead+2,$b_11,$reach_3             # 15e
            lnop                                        # 15o pairing
        a       $m_lane,$m_lane,$m_x                    # 16e
        lqd     $ox,0($a_packet)                        # 16o
            fa      $ahead+1,$b_6,$reach_3              # 17e
        lqd     $ox_9,16($a_packet)                     # 17o
            fnms    $disc,$fy,$fy,$disc                 # 18e
        shufb   $cx,$cx,$cx,$m_lane                     # 18o
            fma     $b,$fz_5,$dz_5,$b                   # 19e
        lqd     $again,0($a_candidate)                  # 19o
            fnms    $disc+1,$fz,$fz,$disc+1             # 20e
        shufb   $extent,$extent,$turned,$m_extent       # 20o
            fnms    $disc+2,$fx_10,$fx_10,$reach2_3     # 21e
        lqd     $cy,16($candidate)                      # 21o
            fnms    $fz,$b_14,$dz_2,$fz_3               # 22e
        lqd     $oy,80($a_packet)                       # 22o
        fs      $fx_10,$cx,$ox                          # 23e
        lqd     $ox,32($a_packet)                       # 23o
        fs      $fx_8,$cx,$ox_9                         # 24e
        lqd     $oy_8,112($a_packet)                    # 24o
        andc    $extent,$extent,$k_sign                 # 25e
        lqd     $dx,192($a_packet)                      # 25o
            fa      $ahead+3,$b,$reach_3                # 26e
        lqd     $oy_6,64($a_packet)                     # 26o
            fnms    $fy,$b,$dy,$fy_5                    # 27e
        shufb   $cy,$cy,$cy,$m_lane                     # 27o
            fnms    $fx,$b,$dx_4,$fx                    # 28e
        lqd     $dx_7,208($a_packet)                    # 28o
        fs      $fx_2,$cx,$ox                           # 29e
        rotqbyi $turned_7,$extent,8                     # 29o
            fnms    $disc+2,$fy_10,$fy_10,$disc+2       # 30e
        lqd     $oy_9,96($a_packet)                     # 30o
        fm      $b_14,$fx_10,$dx                        # 31e
        lqd     $t+1,400($a_packet)                     # 31o
            fnms    $fz_11,$b,$dz_5,$fz_5               # 32e
        lqd     $cz_2,32($candidate)                    # 32o
        fs      $fy_8,$cy,$oy_6                         # 33e
        lqd     $dx_3,224($a_packet)                    # 33o
        fm      $b,$fx_8,$dx_7                          # 34e
        lqd     $oz,160($a_packet)                      # 34o
        fa      $extent,$extent,$turned_7               # 35e
        lqd     $oz_7,144($a_packet)                    # 35o
        fs      $fy_10,$cy,$oy_9                        # 36e
        lqd     $oz_3,176($a_packet)                    # 36o
        fs      $fy_4,$cy,$oy                           # 37e
        lqd     $oz_4,128($a_packet)                    # 37o
            fnms    $disc,$fz,$fz,$disc                 # 38e
        shufb   $cz_2,$cz_2,$cz_2,$m_lane               # 38o
        fm      $b_3,$fx_2,$dx_3                        # 39e
        lqd     $dy_2,288($a_packet)                    # 39o
            fnms    $disc+3,$fx,$fx,$reach2_3           # 40e
        lqd     $dy_7,272($a_packet)                    # 40o
            fnms    $disc+2,$fz_10,$fz_10,$disc+2       # 41e
        lqd     $reach_6,48($candidate)                 # 41o
        fs      $fz_2,$cz_2,$oz                         # 42e
        lqd     $dy_3,256($a_packet)                    # 42o
        fs      $fz_8,$cz_2,$oz_7                       # 43e
        rotqbyi $turned_8,$extent,4                     # 43o
        fs      $fz_3,$cz_2,$oz_4                       # 44e
        lqd     $dz_2,320($a_packet)                    # 44o
        fma     $b_15,$fy_10,$dy_2,$b_3                 # 45e
        lqd     $dz,336($a_packet)                      # 45o
            fnms    $disc+3,$fy,$fy,$disc+3             # 46e
        lqd     $t_4,384($a_packet)                     # 46o
        fma     $b,$fy_4,$dy_7,$b                       # 47e
            shufb   $signs_2,$disc,$disc+1,$m_signs     # 47o
        fa      $extent,$extent,$turned_8               # 48e
        shufb   $reach_6,$reach_6,$reach_6,$m_lane      # 48o
        fma     $b_16,$fy_8,$dy_3,$b_14                 # 49e
            shufb   $low,$ahead+2,$ahead+3,$m_signs     # 49o
        fs      $fz_5,$cz_2,$oz_3                       # 50e
            shufb   $any_5,$ahead,$ahead+1,$m_signs     # 50o
            clgt    $any_6,$k_all,$signs                # 51e
        lqd     $dx_4,240($a_packet)                    # 51o
            fnms    $disc+3,$fz_11,$fz_11,$disc+3       # 52e
        lqd     $t2_4,416($a_packet)                    # 52o
        fma     $b_6,$fz_8,$dz,$b                       # 53e
        lqd     $t3_4,432($a_packet)                    # 53o
        fma     $reach_3,$extent,$k_slack,$reach_6      # 54e
            shufb   $any_4,$any_5,$low,$m_halves        # 54o
        fma     $b_14,$fz_3,$dz_2,$b_16                 # 55e
        shufb   $any_3,$t_4,$t+1,$m_signs               # 55o
        fs      $fy_5,$cy,$oy_8                         # 56e
        lqd     $dz_5,368($a_packet)                    # 56o
        ai      $a_candidate,$a_candidate,16            # 57e
        lqd     $dz_6,352($a_packet)                    # 57o
        ai      $count,$count,-1                        # 58e
            shufb   $low_6,$disc+2,$disc+3,$m_signs     # 58o
        fnms    $fx_8,$b_6,$dx_7,$fx_8                  # 59e
        lqd     $ox_8,48($a_packet)                     # 59o
            sf      $found,$any_6,$found                # 60e
        lqd     $child,64($again)                       # 60o
        fm      $reach2_3,$reach_3,$reach_3             # 61e
        shufb   $low_5,$t2_4,$t3_4,$m_signs             # 61o
        fnms    $fx_9,$b_14,$dx,$fx_10                  # 62e
            shufb   $signs,$signs_2,$low_6,$m_halves    # 62o
        fnms    $fy_11,$b_6,$dy_7,$fy_4                 # 63e
            shlqbii $offset_2,$found,4                  # 63o
        fma     $b_11,$fz_2,$dz_6,$b_15                 # 64e
next_child_back:
        brnz    $count,next_child                       # 64o
next_child_drain:
        fs      $fx,$cx,$ox_8                           # 0e
        lqd     $dy,304($a_packet)                      # 0o
        fnms    $fx_11,$b_11,$dx_3,$fx_2                # 1e
        shufb   $any_7,$any_3,$low_5,$m_halves          # 1o
        fnms    $fy,$b_14,$dy_3,$fy_8                   # 2e
        hbr     filter_children_r16_return,$lr          # 2o hint
        fnms    $disc+1,$fx_8,$fx_8,$reach2_3           # 3e
        shufb   $child,$child,$child,$m_lane            # 3o
        fnms    $fy_10,$b_11,$dy_2,$fy_10               # 4e
        stqx    $entry,$a_first,$offset_2               # 4o
        fnms    $disc,$fx_9,$fx_9,$reach2_3             # 5e
        fm      $b,$fx,$dx_4                            # 6e
        fnms    $disc+2,$fx_11,$fx_11,$reach2_3         # 7e
        shufb   $entry,$child,$again,$m_entry           # 7o
        fnms    $fz,$b_6,$dz,$fz_8                      # 8e
        fnms    $fz_12,$b_11,$dz_6,$fz_2                # 9e
        fnms    $disc+1,$fy_11,$fy_11,$disc+1           # 10e
        fnms    $disc,$fy,$fy,$disc                     # 11e
        fma     $b,$fy_5,$dy,$b                         # 12e
        fnms    $fz_13,$b_14,$dz_2,$fz_3                # 13e
        fnms    $disc+2,$fy_10,$fy_10,$disc+2           # 14e
        fa      $ahead,$b_14,$reach_3                   # 15e
        fa      $ahead+2,$b_11,$reach_3                 # 16e
        fa      $ahead+1,$b_6,$reach_3                  # 17e
        fma     $b,$fz_5,$dz_5,$b                       # 18e
        fnms    $disc+1,$fz,$fz,$disc+1                 # 19e
        fnms    $disc,$fz_13,$fz_13,$disc               # 20e
        fnms    $disc+2,$fz_12,$fz_12,$disc+2           # 21e
        or      $signs,$signs,$any_4                    # 22e
        shufb   $any_5,$ahead,$ahead+1,$m_signs         # 23o
        fnms    $fx,$b,$dx_4,$fx                        # 24e
        fnms    $fy,$b,$dy,$fy_5                        # 25e
        fnms    $fz_11,$b,$dz_5,$fz_5                   # 26e
        shufb   $signs_2,$disc,$disc+1,$m_signs         # 26o
        fa      $ahead+3,$b,$reach_3                    # 27e
        or      $signs,$signs,$any                      # 28e
        fnms    $disc+3,$fx,$fx,$reach2_3               # 30e
        rotqbii $signs,$signs,1                         # 30o signs to the bytes' last bits
        shufb   $low,$ahead+2,$ahead+3,$m_signs         # 33o
        gbb     $signs,$signs                           # 34o
        fnms    $disc+3,$fy,$fy,$disc+3                 # 36e
        shufb   $any_4,$any_5,$low,$m_halves            # 37o
        clgt    $any_6,$k_all,$signs                    # 38e
        sf      $found,$any_6,$found                    # 40e
        fnms    $disc+3,$fz_11,$fz_11,$disc+3           # 42e
        shlqbii $offset_2,$found,4                      # 42o
        stqx    $entry,$a_first,$offset_2               # 46o
        shufb   $low_6,$disc+2,$disc+3,$m_signs         # 48o
        shufb   $signs,$signs_2,$low_6,$m_halves        # 52o
        or      $signs,$signs,$any_4                    # 56e
        or      $signs,$signs,$any_7                    # 58e
        rotqbii $signs,$signs,1                         # 60o signs to the bytes' last bits
        gbb     $signs,$signs                           # 64o
        clgt    $any_6,$k_all,$signs                    # 68e
        sf      $found,$any_6,$found                    # 70e
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
        lqd     $ox_10,16($a_packet)                    # 13o
        lqd     $ox_11,32($a_packet)                    # 14o
        lqd     $ox_12,48($a_packet)                    # 15o
        shufb   $cx,$cx,$cx,$m_lane                     # 16o
        shufb   $extent,$extent,$turned,$m_extent       # 17o
        lqd     $cy,16($candidate)                      # 18o
        lqd     $dx,192($a_packet)                      # 19o
        fs      $fx,$cx,$ox                             # 20e
        lqd     $oy,64($a_packet)                       # 20o
        andc    $extent,$extent,$k_sign                 # 21e
        lqd     $dx_8,208($a_packet)                    # 21o
        fs      $fx_10,$cx,$ox_10                       # 22e
        lqd     $oy_8,80($a_packet)                     # 22o
        fs      $fx_12,$cx,$ox_11                       # 23e
        rotqbyi $turned,$extent,8                       # 23o
        fs      $fx_13,$cx,$ox_12                       # 24e
        lqd     $dx_9,224($a_packet)                    # 24o
        nop     $127                                    # 25e pairing
        lqd     $oy_10,96($a_packet)                    # 25o
        fm      $b,$fx,$dx                              # 26e
        lqd     $dx_10,240($a_packet)                   # 26o
        fa      $extent,$extent,$turned                 # 27e
        lqd     $oy_11,112($a_packet)                   # 27o
        fm      $b_17,$fx_10,$dx_8                      # 28e
        shufb   $cy,$cy,$cy,$m_lane                     # 28o
        nop     $127                                    # 29e pairing
        lqd     $cz_5,32($candidate)                    # 29o
        fm      $b_18,$fx_12,$dx_9                      # 30e
        lqd     $dy,256($a_packet)                      # 30o
        nop     $127                                    # 31e pairing
        lqd     $oz,128($a_packet)                      # 31o
        fs      $fy,$cy,$oy                             # 32e
        lqd     $dy_8,272($a_packet)                    # 32o
        fs      $fy_12,$cy,$oy_8                        # 33e
        lqd     $oz_9,144($a_packet)                    # 33o
        fs      $fy_13,$cy,$oy_10                       # 34e
        lqd     $dy_9,288($a_packet)                    # 34o
        fs      $fy_14,$cy,$oy_11                       # 35e
        lqd     $oz_10,160($a_packet)                   # 35o
        fm      $b_11,$fx_13,$dx_10                     # 36e
        lqd     $dy_10,304($a_packet)                   # 36o
        nop     $127                                    # 37e pairing
        lqd     $oz_11,176($a_packet)                   # 37o
        fma     $b,$fy,$dy,$b                           # 38e
        rotqbyi $turned_9,$extent,4                     # 38o
        fma     $b_17,$fy_12,$dy_8,$b_17                # 39e
        lqd     $reach_2,48($candidate)                 # 39o
        fma     $b_18,$fy_13,$dy_9,$b_18                # 40e
        shufb   $cz_5,$cz_5,$cz_5,$m_lane               # 40o
        nop     $127                                    # 41e pairing
        lqd     $dz_3,320($a_packet)                    # 41o
        fa      $extent,$extent,$turned_9               # 42e
        lqd     $dz_7,336($a_packet)                    # 42o
        fma     $b_11,$fy_14,$dy_10,$b_11               # 43e
        lqd     $dz_8,352($a_packet)                    # 43o
        fs      $fz_2,$cz_5,$oz                         # 44e
        lqd     $dz_9,368($a_packet)                    # 44o
        fs      $fz_14,$cz_5,$oz_9                      # 45e
        shufb   $reach_2,$reach_2,$reach_2,$m_lane      # 45o
        fs      $fz_15,$cz_5,$oz_10                     # 46e
        lqd     $t,384($a_packet)                       # 46o
        fs      $fz,$cz_5,$oz_11                        # 47e
        lqd     $t+1,400($a_packet)                     # 47o
        nop     $127                                    # 48e pairing
        lqd     $t+2,416($a_packet)                     # 48o
        fma     $reach,$extent,$k_slack,$reach_2        # 49e
        lqd     $t+3,432($a_packet)                     # 49o
        fma     $b,$fz_2,$dz_3,$b                       # 50e
        lqd     $child_4,64($again)                     # 50o
        fma     $b_19,$fz_14,$dz_7,$b_17                # 51e
        fma     $b_20,$fz_15,$dz_8,$b_18                # 52e
        fma     $b_17,$fz,$dz_9,$b_11                   # 53e
        shufb   $any,$t,$t+1,$m_signs                   # 53o
        fm      $reach2,$reach,$reach                   # 55e
        shufb   $low,$t+2,$t+3,$m_signs                 # 55o
        fnms    $fx,$b,$dx,$fx                          # 56e
        shufb   $child_4,$child_4,$child_4,$m_lane      # 56o
        fnms    $fx_10,$b_19,$dx_8,$fx_10               # 57e
        fnms    $fx_12,$b_20,$dx_9,$fx_12               # 58e
        fnms    $fx_13,$b_17,$dx_10,$fx_13              # 59e
        shufb   $any,$any,$low,$m_halves                # 59o
        fnms    $fy,$b,$dy,$fy                          # 60e
        shufb   $entry_2,$child_4,$again,$m_entry       # 60o
        fnms    $fy_12,$b_19,$dy_8,$fy_12               # 61e
        fnms    $disc_4,$fx,$fx,$reach2                 # 62e
        fnms    $disc1_3,$fx_10,$fx_10,$reach2          # 63e
        lnop                                            # 63o pairing
        fnms    $fy_15,$b_20,$dy_9,$fy_13               # 64e
        stqx    $entry_2,$a_first,$offset               # 64o
        fnms    $disc2_4,$fx_12,$fx_12,$reach2          # 65e
        fnms    $fy_16,$b_17,$dy_10,$fy_14              # 66e
        fnms    $disc3_5,$fx_13,$fx_13,$reach2          # 67e
        fnms    $fz_16,$b,$dz_3,$fz_2                   # 68e
        fnms    $disc_4,$fy,$fy,$disc_4                 # 69e
        fnms    $fz_17,$b_19,$dz_7,$fz_14               # 70e
        fnms    $disc+1,$fy_12,$fy_12,$disc1_3          # 71e
        fnms    $fz_12,$b_20,$dz_8,$fz_15               # 72e
        fnms    $disc+2,$fy_15,$fy_15,$disc2_4          # 73e
        fnms    $fz,$b_17,$dz_9,$fz                     # 74e
        fnms    $disc+3,$fy_16,$fy_16,$disc3_5          # 75e
        fa      $ahead,$b,$reach                        # 76e
        fnms    $disc,$fz_16,$fz_16,$disc_4             # 77e
        fa      $ahead+1,$b_19,$reach                   # 78e
        fnms    $disc+1,$fz_17,$fz_17,$disc+1           # 79e
        fa      $ahead+2,$b_20,$reach                   # 80e
        fnms    $disc+2,$fz_12,$fz_12,$disc+2           # 81e
        fa      $ahead+3,$b_17,$reach                   # 82e
        fnms    $disc+3,$fz,$fz,$disc+3                 # 83e
        shufb   $any_8,$ahead,$ahead+1,$m_signs         # 84o
        shufb   $signs,$disc,$disc+1,$m_signs           # 85o
        shufb   $low,$ahead+2,$ahead+3,$m_signs         # 88o
        shufb   $low_7,$disc+2,$disc+3,$m_signs         # 89o
        shufb   $any_8,$any_8,$low,$m_halves            # 92o
        shufb   $signs,$signs,$low_7,$m_halves          # 93o
        or      $signs,$signs,$any_8                    # 97e
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
