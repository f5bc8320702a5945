# filter_boxes_r16   of nodes of a mesh, the children whose boxes one of a packet's rays may meet
#   C       struct mesh_candidate *filter_boxes_r16(const struct mesh_candidate *, int count,
#                                                   struct mesh_candidate *, int base);
#   In      $3 candidates whose objects are BOXES, $4 count (0 is none), $5 where the list goes,
#           which may not be among the candidates, $6 what is added to each child's word; pointers
#           16-aligned
#   Out     candidates of such children, node by node, children in order: object is the child's
#           word plus $6, the rest the node's; three more quadwords may be written
#           $3 behind the list
#   Uses    $2-$77, $79   Saves  -   Stack  0   Calls  -
#   Domain  bounds as mesh_bounds_r16 makes them; boxes with a slack of 2^-19 of the largest
#           magnitude of their coordinates; distances from 2^-60 to 2^60
#   Error   0: no child is left out that a ray of the packet enters before it ends
#   Twin    lab/twins/src/mesh.rs
#
# For rays that go every way, whose common bound lets through nearly everything. The four children
# are in the four lanes, and each ray in turn is in all of them. Along each axis the ray is in the
# box from at - half |1/d| to at + half |1/d|, where at is the time at which it is in the middle of
# the box. A ray misses it if one of these is below 0:
#   the first end - the last start
#   t - the last start
#   the first end
#   t, of a lane without a ray
# A component of a direction below 2^-60 becomes 2^-60. That moves the ray by less than the slacks.
#
# Each pass of the loop tests a row of rays, of which each takes 143 cycles. Without pipelining
# it would be 169, and 1.8 KB less of local store.
# Scheduled by spu schedule from filter_boxes_r16.s

        .include "work_unit.inc"
        .include "macros.inc"
        .include "reciprocal.inc"
        .include "extremes.inc"

        .set    NEXT,3
        registers a_first                               # candidate
        registers count,a_list,base
        # constants
        .set    NEXT,10
        registers m_lane                                # to 13: splat a word
        .set    NEXT,m_lane+4
        registers m_entry                               # to 17: the child's word
        .set    NEXT,m_entry+4
        registers m_slack,k_half,k_one,k_tiny,k_zero,m_sign
        # state
        registers a_candidate
        registers found                                 # bytes of the list so far
        registers row                                   # its offset in the rays
        registers all_miss                              # signs: so far all rays miss the child
        # the candidate
        registers candidate,a_bound,a_packet,child,slack,first,last
        # the boxes
        registers middle_x,middle_y,middle_z,half_x,half_y,half_z
        registers lower,upper,passes
        # a row of rays
        registers inverse_x,inverse_y,inverse_z
        registers magnitude_x,magnitude_y,magnitude_z
        registers shift_x,shift_y,shift_z
        registers t,v,t_y,t_e
        # a ray
        registers inverse,magnitude,shift,end
        registers near_x,near_y,near_z
        registers far_x,far_y,far_z
        registers c_greater,misses
        registers step                                  # four of them
        .set    NEXT,step+4
        registers entry
        # the candidate, loaded again instead of being kept in a register for so long
        registers a_again,again

        .section .rodata.mesh,"a",@progbits
        .align  4
child_of_node:
    .irp child, 0,1,2,3
        .int    0x00010203+0x04040404*\child,0x14151617,0x18191a1b,0x1c1d1e1f
    .endr

function filter_boxes_r16
        .set passes_2,79; .set row_2,7; .set all_miss_2,50; .set upper_2,4; .set lower_2,8
        .set last_2,62; .set v_2,9; .set v_3,2; .set v_4,5; .set v_5,34; .set upper_3,31
        .set c_greater_2,4; .set c_greater_3,32; .set v_6,7; .set slack_2,29; .set t_y_2,4
        .set child_2,28; .set t_y_3,39; .set last_3,61; .set end_2,32; .set end_3,40; .set end_4,44
        .set half_y_2,8; .set entry_2,46; .set t_e_2,9; .set half_z_2,31; .set entry_3,76
        .set entry_4,77; .set t_e_3,2; .set inverse_x_2,9; .set shift_x_2,2; .set inverse_2,34
        .set inverse_3,29; .set inverse_4,30; .set shift_z_2,4; .set inverse_5,41
        .set inverse_6,53; .set shift_2,5; .set shift_3,7; .set shift_4,27; .set shift_5,28
        .set shift_6,34; .set shift_7,30; .set magnitude_2,53; .set magnitude_3,54
        .set inverse_7,42; .set shift_8,29; .set inverse_8,52; .set near_y_2,56; .set shift_9,63
        .set far_x_2,66; .set inverse_9,39; .set near_x_2,5; .set shift_10,42; .set shift_11,2
        .set magnitude_4,33; .set shift_12,55; .set far_z_2,41; .set magnitude_5,57
        .set near_z_2,34; .set magnitude_6,45; .set near_y_3,51; .set magnitude_7,52
        .set shift_13,39; .set inverse_10,9; .set near_x_3,36; .set inverse_11,46; .set near_y_4,53
        .set shift_14,4; .set far_y_2,29; .set shift_15,9; .set magnitude_8,67; .set far_x_3,2
        .set magnitude_9,59; .set near_x_4,28; .set magnitude_10,47; .set c_greater_4,35
        .set magnitude_11,49; .set c_greater_5,45; .set shift_16,37; .set far_x_4,4
        .set far_z_3,45; .set near_z_3,30; .set far_y_3,27; .set far_x_5,7; .set far_y_4,33
        .set c_greater_6,46; .set c_greater_7,48; .set far_x_6,52; .set c_greater_8,55
        .set far_x_7,29; .set far_x_8,41; .set near_x_5,2; .set far_z_4,28; .set c_greater_9,34
        .set c_greater_10,42; .set near_x_6,4; .set end_5,30; .set far_x_9,5; .set near_z_4,69
        .set near_x_7,35; .set far_x_10,27; .set near_y_5,9; .set end_6,8; .set misses_2,7
        .set far_x_11,31; .set far_x_12,46; .set misses_3,29; .set misses_4,4; .set all_miss_3,5
        .set misses_5,2; .set v_7,4; .set c_greater_11,28; .set t_y_4,34; .set end_7,41
        .set t_e_4,4; .set shift_17,41; .set found_2,64; .set shift_18,51; .set inverse_12,45
        .set near_x_8,30; .set magnitude_12,48; .set far_y_5,63; .set near_y_6,2; .set far_z_5,33
        .set far_x_13,53; .set near_x_9,7; .set shift_19,36; .set found_3,51; .set far_y_6,9
        .set found_4,55; .set c_greater_12,51; .set far_x_14,28; .set near_y_7,37; .set far_x_15,36
        .set far_z_6,42; .set near_z_5,4; .set near_x_10,29; .set near_z_6,31; .set c_greater_13,7
        .set far_x_16,34; .set c_greater_14,36; .set c_greater_15,38; .set far_x_17,30
        .set far_x_18,9; .set row_3,2; .set lower_3,4; .set upper_4,5; .set v_8,8; .set t_y_5,28
        .set last_4,29; .set end_8,33; .set entry_5,44; .set half_z_3,41; .set entry_6,42
        .set entry_7,31; .set t_e_5,7; .set inverse_x_3,45; .set inverse_y_2,2; .set half_z_4,4
        .set inverse_13,7; .set inverse_14,8; .set inverse_15,5; .set inverse_16,28
        .set shift_20,32; .set shift_21,53; .set shift_22,8; .set magnitude_13,29
        .set inverse_17,2; .set magnitude_14,35; .set magnitude_15,41; .set far_x_19,8
        .set near_y_8,45; .set magnitude_16,50; .set inverse_18,35; .set shift_23,46
        .set magnitude_17,51; .set magnitude_18,5; .set near_x_11,41; .set near_y_9,48
        .set far_y_7,32; .set shift_24,35; .set c_greater_16,37; .set near_z_7,46; .set far_z_7,29
        .set near_x_12,50; .set near_y_10,38; .set far_y_8,2; .set near_z_8,39; .set far_z_8,7
        .set c_greater_17,47; .set c_greater_18,9; .set near_z_9,37; .set far_z_9,4
        .set near_x_13,32; .set c_greater_19,29; .set end_9,5; .set misses_6,28; .set end_10,4
        .set misses_7,8; .set misses_8,5; .set end_11,7; .set found_5,2
        ori     $a_candidate,$a_first,0                 # 0e
        ori     $a_again,$a_first,0                     # 1e
        ori     $a_first,$a_list,0                      # 2e
        biz     $count,$lr                              # 2o
        shli    $passes,$count,2                        # 3e
        lqa     $m_entry,child_of_node                  # 3o
        ilhu    $m_lane,1                               # 4e
        lqa     $m_entry+1,child_of_node+16             # 4o
        ilhu    $m_slack,1                              # 5e the upper half of the first word
        lqa     $m_entry+2,child_of_node+32             # 5o
        iohl    $m_lane,515                             # 6e
        lqa     $m_entry+3,child_of_node+48             # 6o
        ilhu    $m_lane+1,0x405                         # 7e
        lnop                                            # 7o pairing
        ilhu    $m_lane+2,0x809                         # 8e
        shufb   $base,$base,$base,$m_lane               # 8o
        ilhu    $m_lane+3,0xc0d                         # 9e
        clgti   $passes_2,$passes,1                     # 10e at least as many passes as overlap
        il      $found,0                                # 11e
        il      $row,0                                  # 12e
        il      $k_zero,0                               # 13e
        ilhu    $m_sign,0x8000                          # 14e
        ilhu    $k_half,0x3f00                          # 15e
        ilhu    $k_one,0x3f80                           # 16e
        ilhu    $k_tiny,0x2180                          # 17e 2^-60
        iohl    $m_slack,0x8080                         # 18e the upper half of the first word
        iohl    $m_lane+1,0x607                         # 19e
        iohl    $m_lane+2,0xa0b                         # 20e
        iohl    $m_lane+3,0xe0f                         # 21e
        brz     $passes_2,next_row_short                # 21o too few passes
        ai      $row_2,$row,16                          # 22e
        lqd     $candidate,0($a_candidate)              # 22o
        ceqi    $first,$row,0                           # 23e
        lqd     $again,0($a_again)                      # 23o
        ai      $passes,$passes,-1                      # 24e
        or      $all_miss_2,$all_miss,$first            # 25e
        rotqbyi $a_packet,$candidate,4                  # 28o
        lqd     $lower,0($candidate)                    # 29o
        lqd     $upper,64($candidate)                   # 30o
        lqd     $upper_2,48($candidate)                 # 31o
        a       $a_packet,$a_packet,$row                # 32e
        lqd     $lower_2,16($candidate)                 # 32o
        andi    $row,$row_2,48                          # 33e
        rotqbyi $a_bound,$candidate,8                   # 33o
        nop     $127                                    # 34e pairing
        lqd     $v,256($a_packet)                       # 34o
        ceqi    $last_2,$row,0                          # 35e
        lqd     $v_2,192($a_packet)                     # 35o
        nop     $127                                    # 36e pairing
        lqd     $v_3,320($a_packet)                     # 36o
        fa      $middle_x,$lower,$upper_2               # 37e
        lqd     $v_4,64($a_packet)                      # 37o
        fa      $middle_y,$lower_2,$upper               # 38e
        lqd     $v_5,0($a_packet)                       # 38o
        fs      $half_x,$upper_2,$lower                 # 39e
        lqd     $upper_3,80($candidate)                 # 39o
        fcmgt   $c_greater_2,$k_tiny,$v                 # 40e
        lqd     $lower,32($candidate)                   # 40o
        fcmgt   $c_greater_3,$k_tiny,$v_2               # 41e
        lqd     $v_6,128($a_packet)                     # 41o
        selb    $v,$v,$k_tiny,$c_greater_2              # 42e
        lqd     $slack_2,192($a_bound)                  # 42o
        selb    $v_2,$v_2,$k_tiny,$c_greater_3          # 43e
        lqd     $t,384($a_packet)                       # 43o
        fcmgt   $c_greater_3,$k_tiny,$v_3               # 44e
        frest   $t_y,$v                                 # 44o
        fm      $middle_y,$middle_y,$k_half             # 45e
        frest   $t_y_2,$v_2                             # 45o
        selb    $v_3,$v_3,$k_tiny,$c_greater_3          # 46e
        lqd     $child_2,96($again)                     # 46o
        fa      $middle_z,$lower,$upper_3               # 47e
        lnop                                            # 47o pairing
        fi      $t_y,$v,$t_y                            # 48e
        frest   $t_y_3,$v_3                             # 48o
        fi      $t_y_2,$v_2,$t_y_2                      # 49e
        shufb   $slack_2,$slack_2,$slack_2,$m_slack     # 49o
        andi    $last_3,$last_2,16                      # 50e
        shufb   $end,$t,$t,$m_lane                      # 50o
        fm      $middle_x,$middle_x,$k_half             # 51e
        shufb   $end_2,$t,$t,$m_lane+1                  # 51o
        fi      $t_y_3,$v_3,$t_y_3                      # 52e
        shufb   $end_3,$t,$t,$m_lane+3                  # 52o
        a       $child_2,$child_2,$base                 # 53e
        shufb   $end_4,$t,$t,$m_lane+2                  # 53o
        fs      $half_y_2,$upper,$lower_2               # 54e
        lnop                                            # 54o pairing
        fnms    $t_e,$v,$t_y,$k_one                     # 55e
        shufb   $entry_2,$child_2,$again,$m_entry       # 55o
        fnms    $t_e_2,$v_2,$t_y_2,$k_one               # 56e
        shufb   $entry,$child_2,$again,$m_entry+1       # 56o
        fs      $half_z_2,$upper_3,$lower               # 57e
        shufb   $entry_3,$child_2,$again,$m_entry+2     # 57o
        fm      $middle_z,$middle_z,$k_half             # 58e
        shufb   $entry_4,$child_2,$again,$m_entry+3     # 58o
        fnms    $t_e_3,$v_3,$t_y_3,$k_one               # 59e
        stqx    $entry_2,$a_first,$found                # 59o
        fma     $half_y_2,$half_y_2,$k_half,$slack_2    # 60e
        fma     $inverse_y,$t_e,$t_y,$t_y               # 61e
        fma     $inverse_x_2,$t_e_2,$t_y_2,$t_y_2       # 62e
        fma     $half_x,$half_x,$k_half,$slack_2        # 63e
        fma     $half_z_2,$half_z_2,$k_half,$slack_2    # 64e
        fma     $inverse_z,$t_e_3,$t_y_3,$t_y_3         # 65e
        a       $a_again,$a_again,$last_3               # 66e
        lnop                                            # 66o pairing
        fnms    $shift_y,$v_4,$inverse_y,$k_zero        # 67e
        shufb   $inverse,$inverse_y,$inverse_y,$m_lane  # 67o
        fnms    $shift_x_2,$v_5,$inverse_x_2,$k_zero    # 68e
        shufb   $inverse_2,$inverse_x_2,$inverse_x_2,$m_lane # 68o
        andc    $magnitude_x,$inverse_x_2,$m_sign       # 69e
        shufb   $inverse_3,$inverse_y,$inverse_y,$m_lane+1 # 69o
        andc    $magnitude_y,$inverse_y,$m_sign         # 70e
        shufb   $inverse_4,$inverse_x_2,$inverse_x_2,$m_lane+1 # 70o
        fnms    $shift_z_2,$v_6,$inverse_z,$k_zero      # 71e
        shufb   $inverse_5,$inverse_z,$inverse_z,$m_lane # 71o
        andc    $magnitude_z,$inverse_z,$m_sign         # 72e
        shufb   $inverse_6,$inverse_x_2,$inverse_x_2,$m_lane+3 # 72o
        shufb   $shift,$shift_y,$shift_y,$m_lane        # 73o
        shufb   $shift_2,$shift_x_2,$shift_x_2,$m_lane  # 74o
        shufb   $shift_3,$shift_x_2,$shift_x_2,$m_lane+1 # 75o
        shufb   $shift_4,$shift_y,$shift_y,$m_lane+1    # 76o
        fma     $shift,$middle_y,$inverse,$shift        # 77e
        shufb   $shift_5,$shift_x_2,$shift_x_2,$m_lane+3 # 77o
        fma     $shift_2,$middle_x,$inverse_2,$shift_2  # 78e
        shufb   $shift_6,$shift_z_2,$shift_z_2,$m_lane  # 78o
        fma     $shift_3,$middle_x,$inverse_4,$shift_3  # 79e
        shufb   $shift_7,$shift_y,$shift_y,$m_lane+3    # 79o
        fma     $shift_4,$middle_y,$inverse_3,$shift_4  # 80e
        shufb   $inverse_3,$inverse_y,$inverse_y,$m_lane+3 # 80o
        fma     $shift_5,$middle_x,$inverse_6,$shift_5  # 81e
        shufb   $magnitude_2,$magnitude_y,$magnitude_y,$m_lane # 81o
        fma     $shift_6,$middle_z,$inverse_5,$shift_6  # 82e
        shufb   $magnitude_3,$magnitude_x,$magnitude_x,$m_lane # 82o
        nop     $127                                    # 83e pairing
        shufb   $inverse_7,$inverse_z,$inverse_z,$m_lane+1 # 83o
        fma     $shift_8,$middle_y,$inverse_3,$shift_7  # 84e
        shufb   $inverse_8,$inverse_z,$inverse_z,$m_lane+3 # 84o
        fnms    $near_y_2,$half_y_2,$magnitude_2,$shift # 85e
        shufb   $shift_9,$shift_z_2,$shift_z_2,$m_lane+1 # 85o
        fma     $far_y,$half_y_2,$magnitude_2,$shift    # 86e
        shufb   $shift_7,$shift_z_2,$shift_z_2,$m_lane+3 # 86o
        fma     $far_x_2,$half_x,$magnitude_3,$shift_2  # 87e
        shufb   $inverse_9,$inverse_y,$inverse_y,$m_lane+2 # 87o
        fnms    $near_x_2,$half_x,$magnitude_3,$shift_2 # 88e
        shufb   $magnitude,$magnitude_z,$magnitude_z,$m_lane # 88o
        fma     $shift_10,$middle_z,$inverse_7,$shift_9 # 89e
        shufb   $shift_11,$shift_x_2,$shift_x_2,$m_lane+2 # 89o
        fma     $shift_7,$middle_z,$inverse_8,$shift_7  # 90e
        shufb   $magnitude_4,$magnitude_y,$magnitude_y,$m_lane+1 # 90o
        nop     $127                                    # 91e pairing
        shufb   $shift_12,$shift_y,$shift_y,$m_lane+2   # 91o
        fma     $far_z_2,$half_z_2,$magnitude,$shift_6  # 92e
        shufb   $magnitude_5,$magnitude_x,$magnitude_x,$m_lane+1 # 92o
        fnms    $near_z_2,$half_z_2,$magnitude,$shift_6 # 93e
        shufb   $magnitude_6,$magnitude_y,$magnitude_y,$m_lane+3 # 93o
        fnms    $near_y_3,$half_y_2,$magnitude_4,$shift_4 # 94e
        shufb   $magnitude_7,$magnitude_x,$magnitude_x,$m_lane+3 # 94o
        fma     $shift_13,$middle_y,$inverse_9,$shift_12 # 95e
        shufb   $inverse_10,$inverse_x_2,$inverse_x_2,$m_lane+2 # 95o
        fnms    $near_x_3,$half_x,$magnitude_5,$shift_3 # 96e
        shufb   $inverse_11,$inverse_z,$inverse_z,$m_lane+2 # 96o
        fnms    $near_y_4,$half_y_2,$magnitude_6,$shift_8 # 97e
        shufb   $shift_14,$shift_z_2,$shift_z_2,$m_lane+2 # 97o
        fma     $far_y_2,$half_y_2,$magnitude_6,$shift_8 # 98e
        shufb   $magnitude_3,$magnitude_z,$magnitude_z,$m_lane+1 # 98o
        fma     $shift_15,$middle_x,$inverse_10,$shift_11 # 99e
        shufb   $magnitude_8,$magnitude_z,$magnitude_z,$m_lane+3 # 99o
        fma     $far_x_3,$half_x,$magnitude_7,$shift_5  # 100e
        shufb   $magnitude_9,$magnitude_y,$magnitude_y,$m_lane+2 # 100o
        fnms    $near_x_4,$half_x,$magnitude_7,$shift_5 # 101e
        shufb   $magnitude_10,$magnitude_x,$magnitude_x,$m_lane+2 # 101o
        fcgt    $c_greater_4,$near_y_2,$near_x_2        # 102e
        shufb   $magnitude_11,$magnitude_z,$magnitude_z,$m_lane+2 # 102o
        fcgt    $c_greater_5,$far_x_2,$far_y            # 103e
        fma     $shift_16,$middle_z,$inverse_11,$shift_14 # 104e
        selb    $far_x_4,$far_x_2,$far_y,$c_greater_5   # 105e
        fnms    $near_z,$half_z_2,$magnitude_3,$shift_10 # 106e
        fma     $far_z_3,$half_z_2,$magnitude_8,$shift_7 # 107e
        fnms    $near_z_3,$half_z_2,$magnitude_8,$shift_7 # 108e
        selb    $near_x_2,$near_x_2,$near_y_2,$c_greater_4 # 109e
        fma     $far_y_3,$half_y_2,$magnitude_4,$shift_4 # 110e
        fma     $far_x_5,$half_x,$magnitude_5,$shift_3  # 111e
        fma     $far_y_4,$half_y_2,$magnitude_9,$shift_13 # 112e
        fcgt    $c_greater_6,$near_y_3,$near_x_3        # 113e
        fcgt    $c_greater,$far_x_4,$far_z_2            # 114e
        fcgt    $c_greater_4,$far_x_3,$far_y_2          # 115e
        fcgt    $c_greater_7,$near_y_4,$near_x_4        # 116e
        fma     $far_x_6,$half_x,$magnitude_10,$shift_15 # 117e
        fcgt    $c_greater_8,$near_z_2,$near_x_2        # 118e
        selb    $near_x_3,$near_x_3,$near_y_3,$c_greater_6 # 119e
        selb    $far_x_7,$far_x_3,$far_y_2,$c_greater_4 # 120e
        selb    $far_x_8,$far_x_4,$far_z_2,$c_greater   # 121e
        selb    $near_x_5,$near_x_4,$near_y_4,$c_greater_7 # 122e
        selb    $near_x_2,$near_x_2,$near_z_2,$c_greater_8 # 123e
        fma     $far_z,$half_z_2,$magnitude_3,$shift_10 # 124e
        fma     $far_z_4,$half_z_2,$magnitude_11,$shift_16 # 125e
        fcgt    $c_greater_9,$far_x_7,$far_z_3          # 126e
        fcgt    $c_greater_6,$near_z,$near_x_3          # 127e
        fcgt    $c_greater,$near_z_3,$near_x_5          # 128e
        fs      $misses,$far_x_8,$near_x_2              # 129e
        fcgt    $c_greater_8,$far_x_5,$far_y_3          # 130e
        fcgt    $c_greater_10,$far_x_6,$far_y_4         # 131e
        selb    $near_x_6,$near_x_5,$near_z_3,$c_greater # 132e
        fs      $end_5,$end,$near_x_2                   # 133e
        selb    $near_x_5,$near_x_3,$near_z,$c_greater_6 # 134e
        selb    $far_x_9,$far_x_7,$far_z_3,$c_greater_9 # 135e
        fnms    $near_z_4,$half_z_2,$magnitude_11,$shift_16 # 136e
        selb    $far_x,$far_x_5,$far_y_3,$c_greater_8   # 137e
        fnms    $near_x_7,$half_x,$magnitude_10,$shift_15 # 138e
        or      $far_x_10,$far_x_8,$end                 # 139e
        selb    $far_x_7,$far_x_6,$far_y_4,$c_greater_10 # 140e
        fnms    $near_y_5,$half_y_2,$magnitude_9,$shift_13 # 141e
        fs      $end_6,$end_2,$near_x_5                 # 142e
        fs      $misses_2,$far_x_9,$near_x_6            # 143e
        fcgt    $c_greater_5,$far_x,$far_z              # 144e
        fcgt    $c_greater,$far_x_7,$far_z_4            # 145e
        or      $misses,$misses,$far_x_10               # 146e
        selb    $far_x_11,$far_x,$far_z,$c_greater_5    # 147e
        selb    $far_x_12,$far_x_7,$far_z_4,$c_greater  # 148e
        or      $misses_3,$misses,$end_5                # 149e
        lnop                                            # 149o pairing
next_row:
            a       $a_candidate,$a_candidate,$last_3   # 0e
            fs      $end,$end_3,$near_x_6               # 1e
            or      $far_x,$far_x_9,$end_3              # 2e
        lqd     $candidate,0($a_candidate)              # 2o
            fs      $misses,$far_x_11,$near_x_5         # 3e
            or      $far_x_3,$far_x_11,$end_2           # 4e
            or      $misses_4,$misses_2,$far_x          # 5e
        ceqi    $first,$row,0                           # 6e
            and     $all_miss_3,$all_miss_2,$misses_3   # 7e
            lnop                                        # 7o pairing
        ai      $row_2,$row,16                          # 8e
        rotqbyi $a_packet,$candidate,4                  # 8o
            or      $misses,$misses,$far_x_3            # 9e
        lqd     $lower,0($candidate)                    # 9o
            or      $misses_5,$misses_4,$end            # 10e
        lqd     $upper,64($candidate)                   # 10o
            fcgt    $c_greater,$near_y_5,$near_x_7      # 11e
        lqd     $upper_2,48($candidate)                 # 11o
            or      $misses,$misses,$end_6              # 12e
        lqd     $lower_2,16($candidate)                 # 12o
        a       $a_packet,$a_packet,$row                # 13e
        rotqbyi $a_bound,$candidate,8                   # 13o
            and     $all_miss_3,$all_miss_3,$misses     # 14e
            lnop                                        # 14o pairing
            selb    $near_x,$near_x_7,$near_y_5,$c_greater # 15e
        lqd     $v,256($a_packet)                       # 15o
            or      $far_x,$far_x_12,$end_4             # 16e
        lqd     $v_2,192($a_packet)                     # 16o
        fa      $middle_x,$lower,$upper_2               # 17e
        lqd     $again,0($a_again)                      # 17o
        fa      $middle_y,$lower_2,$upper               # 18e
        lqd     $upper_3,80($candidate)                 # 18o
        fs      $half_x,$upper_2,$lower                 # 19e
        lqd     $v_7,320($a_packet)                     # 19o
            fcgt    $c_greater,$near_z_4,$near_x        # 20e
        lqd     $lower,32($candidate)                   # 20o
        fcmgt   $c_greater_11,$k_tiny,$v                # 21e
        lqd     $t,384($a_packet)                       # 21o
        fcmgt   $c_greater_3,$k_tiny,$v_2               # 22e
        lqd     $slack_2,192($a_bound)                  # 22o
        selb    $v,$v,$k_tiny,$c_greater_11             # 23e
        lnop                                            # 23o pairing
        selb    $v_2,$v_2,$k_tiny,$c_greater_3          # 24e
        lqd     $child_2,96($again)                     # 24o
        fcmgt   $c_greater_3,$k_tiny,$v_7               # 25e
        frest   $t_y,$v                                 # 25o
        fm      $middle_y,$middle_y,$k_half             # 26e
        frest   $t_y_4,$v_2                             # 26o
        selb    $v_7,$v_7,$k_tiny,$c_greater_3          # 27e
        shufb   $end_2,$t,$t,$m_lane+1                  # 27o
        fa      $middle_z,$lower,$upper_3               # 28e
        shufb   $slack_2,$slack_2,$slack_2,$m_slack     # 28o
        fi      $t_y,$v,$t_y                            # 29e
        shufb   $end,$t,$t,$m_lane                      # 29o
        fi      $t_y_4,$v_2,$t_y_4                      # 30e
        frest   $t_y_3,$v_7                             # 30o
            selb    $near_x,$near_x,$near_z_4,$c_greater # 31e
        shufb   $end_3,$t,$t,$m_lane+3                  # 31o
        fm      $middle_x,$middle_x,$k_half             # 32e
        fs      $half_z_2,$upper_3,$lower               # 33e
            fs      $end_7,$end_4,$near_x               # 34e
        shufb   $end_4,$t,$t,$m_lane+2                  # 34o
        fi      $t_y_3,$v_7,$t_y_3                      # 35e
        a       $child_2,$child_2,$base                 # 36e
        fnms    $t_e,$v,$t_y,$k_one                     # 37e
        fnms    $t_e_2,$v_2,$t_y_4,$k_one               # 38e
        fs      $half_y_2,$upper,$lower_2               # 39e
        fma     $half_z_2,$half_z_2,$k_half,$slack_2    # 40e
        fm      $middle_z,$middle_z,$k_half             # 41e
        fnms    $t_e_4,$v_7,$t_y_3,$k_one               # 42e
        fma     $inverse_y,$t_e,$t_y,$t_y               # 43e
        lqd     $v,64($a_packet)                        # 43o
        fma     $inverse_x_2,$t_e_2,$t_y_4,$t_y_4       # 44e
        lqd     $v_5,0($a_packet)                       # 44o
        fma     $half_y_2,$half_y_2,$k_half,$slack_2    # 45e
            fs      $misses,$far_x_12,$near_x           # 46e
        fma     $half_x,$half_x,$k_half,$slack_2        # 47e
        lnop                                            # 47o pairing
        fma     $inverse_z,$t_e_4,$t_y_3,$t_y_3         # 48e
        lqd     $v_7,128($a_packet)                     # 48o
        fnms    $shift_y,$v,$inverse_y,$k_zero          # 49e
        shufb   $inverse,$inverse_y,$inverse_y,$m_lane  # 49o
        fnms    $shift_x,$v_5,$inverse_x_2,$k_zero      # 50e
        shufb   $inverse_3,$inverse_y,$inverse_y,$m_lane+1 # 50o
        andc    $magnitude_x,$inverse_x_2,$m_sign       # 51e
        shufb   $inverse_4,$inverse_x_2,$inverse_x_2,$m_lane+1 # 51o
        andc    $magnitude_y,$inverse_y,$m_sign         # 52e
        shufb   $inverse_2,$inverse_x_2,$inverse_x_2,$m_lane # 52o
            or      $misses,$misses,$far_x              # 53e
        shufb   $inverse_9,$inverse_y,$inverse_y,$m_lane+2 # 53o
        andc    $magnitude_z,$inverse_z,$m_sign         # 54e
        shufb   $inverse_7,$inverse_z,$inverse_z,$m_lane+1 # 54o
            or      $misses,$misses,$end_7              # 55e
        shufb   $inverse_5,$inverse_z,$inverse_z,$m_lane # 55o
        ai      $passes,$passes,-1                      # 56e
        shufb   $inverse_8,$inverse_z,$inverse_z,$m_lane+3 # 56o
            and     $all_miss_3,$all_miss_3,$misses     # 57e
        shufb   $shift,$shift_y,$shift_y,$m_lane        # 57o
        andi    $row,$row_2,48                          # 58e
        shufb   $shift_3,$shift_x,$shift_x,$m_lane+1    # 58o
            and     $all_miss,$all_miss_3,$misses_5     # 59e
        shufb   $shift_11,$shift_y,$shift_y,$m_lane+1   # 59o
        fnms    $shift_z_2,$v_7,$inverse_z,$k_zero      # 60e
        shufb   $magnitude,$magnitude_z,$magnitude_z,$m_lane # 60o
        fma     $shift,$middle_y,$inverse,$shift        # 61e
        shufb   $shift_2,$shift_x,$shift_x,$m_lane+2    # 61o
        fma     $shift_3,$middle_x,$inverse_4,$shift_3  # 62e
        shufb   $shift_7,$shift_x,$shift_x,$m_lane      # 62o
        fma     $shift_11,$middle_y,$inverse_3,$shift_11 # 63e
        shufb   $shift_8,$shift_x,$shift_x,$m_lane+3    # 63o
        or      $all_miss_2,$all_miss,$first            # 64e
        shufb   $magnitude_4,$magnitude_y,$magnitude_y,$m_lane+1 # 64o
            andc    $step,$last_2,$all_miss             # 65e sign set: the child stays
        shufb   $magnitude_2,$magnitude_y,$magnitude_y,$m_lane # 65o
        fma     $shift_7,$middle_x,$inverse_2,$shift_7  # 66e
        shufb   $shift_6,$shift_z_2,$shift_z_2,$m_lane  # 66o
            rotmi   $step,$step,-27                     # 67e
        shufb   $magnitude_3,$magnitude_x,$magnitude_x,$m_lane # 67o
        ceqi    $last_2,$row,0                          # 68e
        shufb   $shift_12,$shift_y,$shift_y,$m_lane+2   # 68o
        fnms    $near_y_2,$half_y_2,$magnitude_2,$shift # 69e
        shufb   $magnitude_5,$magnitude_x,$magnitude_x,$m_lane+1 # 69o
        andi    $last_3,$last_2,16                      # 70e
        shufb   $shift_9,$shift_z_2,$shift_z_2,$m_lane+1 # 70o
        fma     $far_y,$half_y_2,$magnitude_2,$shift    # 71e
        shufb   $inverse_6,$inverse_x_2,$inverse_x_2,$m_lane+3 # 71o
        a       $a_again,$a_again,$last_3               # 72e
        shufb   $magnitude_9,$magnitude_y,$magnitude_y,$m_lane+2 # 72o
            andi    $step,$step,16                      # 73e
        shufb   $inverse_11,$inverse_z,$inverse_z,$m_lane+2 # 73o
        fma     $shift_6,$middle_z,$inverse_5,$shift_6  # 74e
        shufb   $shift_17,$shift_z_2,$shift_z_2,$m_lane+2 # 74o
            a       $found_2,$found,$step               # 75e
        shufb   $shift_18,$shift_y,$shift_y,$m_lane+3   # 75o
        fma     $far_x_2,$half_x,$magnitude_3,$shift_7  # 76e
        shufb   $inverse_12,$inverse_y,$inverse_y,$m_lane+3 # 76o
        fnms    $near_x_8,$half_x,$magnitude_3,$shift_7 # 77e
        shufb   $magnitude_12,$magnitude_y,$magnitude_y,$m_lane+3 # 77o
        fma     $shift_10,$middle_z,$inverse_7,$shift_9 # 78e
        shufb   $magnitude_3,$magnitude_z,$magnitude_z,$m_lane+1 # 78o
        fma     $far_y_5,$half_y_2,$magnitude_4,$shift_11 # 79e
        shufb   $magnitude_8,$magnitude_z,$magnitude_z,$m_lane+3 # 79o
        fma     $shift_8,$middle_x,$inverse_6,$shift_8  # 80e
        shufb   $magnitude_11,$magnitude_z,$magnitude_z,$m_lane+2 # 80o
        fma     $shift_13,$middle_y,$inverse_9,$shift_12 # 81e
            stqx    $entry,$a_first,$found_2            # 81o
        fnms    $near_y_6,$half_y_2,$magnitude_4,$shift_11 # 82e
            rotqbyi $step+1,$step,4                     # 82o
        fma     $far_z_5,$half_z_2,$magnitude,$shift_6  # 83e
            rotqbyi $step+2,$step,8                     # 83o
        fma     $far_x_13,$half_x,$magnitude_5,$shift_3 # 84e
        shufb   $entry,$child_2,$again,$m_entry+1       # 84o
        fma     $shift_17,$middle_z,$inverse_11,$shift_17 # 85e
            rotqbyi $step+3,$step,12                    # 85o
        fnms    $near_x_9,$half_x,$magnitude_5,$shift_3 # 86e
        shufb   $entry_2,$child_2,$again,$m_entry       # 86o
        fma     $shift_19,$middle_y,$inverse_12,$shift_18 # 87e
        shufb   $magnitude_6,$magnitude_x,$magnitude_x,$m_lane+3 # 87o
            a       $found_3,$found_2,$step+1           # 88e
        shufb   $inverse,$inverse_x_2,$inverse_x_2,$m_lane+2 # 88o
        fma     $far_y_6,$half_y_2,$magnitude_9,$shift_13 # 89e
        lnop                                            # 89o pairing
            a       $found_4,$found_3,$step+2           # 90e
            stqx    $entry_3,$a_first,$found_3          # 90o
        fcgt    $c_greater_12,$near_y_2,$near_x_8       # 91e
        shufb   $entry_3,$child_2,$again,$m_entry+2     # 91o
            a       $found,$found_4,$step+3             # 92e
            stqx    $entry_4,$a_first,$found_4          # 92o
        fcgt    $c_greater_8,$far_x_13,$far_y_5         # 93e
        shufb   $magnitude_10,$magnitude_x,$magnitude_x,$m_lane+2 # 93o
        fnms    $near_z_4,$half_z_2,$magnitude_11,$shift_17 # 94e
        shufb   $shift_14,$shift_z_2,$shift_z_2,$m_lane+3 # 94o
        selb    $far_x,$far_x_13,$far_y_5,$c_greater_8  # 95e
        stqx    $entry_2,$a_first,$found                # 95o
        fcgt    $c_greater_6,$near_y_6,$near_x_9        # 96e
        shufb   $entry_4,$child_2,$again,$m_entry+3     # 96o
        fma     $shift_2,$middle_x,$inverse,$shift_2    # 97e
        fcgt    $c_greater_11,$far_x_2,$far_y           # 98e
        fma     $shift_14,$middle_z,$inverse_8,$shift_14 # 99e
        selb    $far_x_14,$far_x_2,$far_y,$c_greater_11 # 100e
        fnms    $near_z,$half_z_2,$magnitude_3,$shift_10 # 101e
        fma     $far_z,$half_z_2,$magnitude_3,$shift_10 # 102e
        fnms    $near_x_7,$half_x,$magnitude_10,$shift_2 # 103e
        fnms    $near_y_7,$half_y_2,$magnitude_12,$shift_19 # 104e
        fma     $far_z_2,$half_z_2,$magnitude_11,$shift_17 # 105e
        fma     $far_y,$half_y_2,$magnitude_12,$shift_19 # 106e
        fma     $far_x_15,$half_x,$magnitude_6,$shift_8 # 107e
        fma     $far_z_6,$half_z_2,$magnitude_8,$shift_14 # 108e
        fnms    $near_z_5,$half_z_2,$magnitude_8,$shift_14 # 109e
        fcgt    $c_greater,$far_x_14,$far_z_5           # 110e
        fnms    $near_x_10,$half_x,$magnitude_6,$shift_8 # 111e
        fnms    $near_z_6,$half_z_2,$magnitude,$shift_6 # 112e
        fcgt    $c_greater_9,$far_x_15,$far_y           # 113e
        fcgt    $c_greater_5,$far_x,$far_z              # 114e
        selb    $near_x_8,$near_x_8,$near_y_2,$c_greater_12 # 115e
        selb    $near_x_5,$near_x_9,$near_y_6,$c_greater_6 # 116e
        fcgt    $c_greater_13,$near_y_7,$near_x_10      # 117e
        fma     $far_x_9,$half_x,$magnitude_10,$shift_2 # 118e
        selb    $far_x_16,$far_x_15,$far_y,$c_greater_9 # 119e
        fcgt    $c_greater_14,$near_z_6,$near_x_8       # 120e
        fcgt    $c_greater_15,$far_x_16,$far_z_6        # 121e
        fcgt    $c_greater_6,$near_z,$near_x_5          # 122e
        selb    $far_x_14,$far_x_14,$far_z_5,$c_greater # 123e
        selb    $near_x_9,$near_x_10,$near_y_7,$c_greater_13 # 124e
        selb    $near_x_10,$near_x_8,$near_z_6,$c_greater_14 # 125e
        hbrr    next_row_back,next_row                  # 125o hint
        fcgt    $c_greater,$near_z_5,$near_x_9          # 126e
        or      $far_x_17,$far_x_14,$end                # 127e
        fs      $misses,$far_x_14,$near_x_10            # 128e
        selb    $far_x_11,$far_x,$far_z,$c_greater_5    # 129e
        fcgt    $c_greater_11,$far_x_9,$far_y_6         # 130e
        selb    $near_x_6,$near_x_9,$near_z_5,$c_greater # 131e
        selb    $far_x,$far_x_9,$far_y_6,$c_greater_11  # 132e
        fs      $end,$end,$near_x_10                    # 133e
        selb    $near_x_5,$near_x_5,$near_z,$c_greater_6 # 134e
        selb    $far_x_9,$far_x_16,$far_z_6,$c_greater_15 # 135e
        fnms    $near_y_5,$half_y_2,$magnitude_9,$shift_13 # 136e
        fs      $end_6,$end_2,$near_x_5                 # 137e
        fs      $misses_2,$far_x_9,$near_x_6            # 138e
        fcgt    $c_greater,$far_x,$far_z_2              # 139e
        or      $misses,$misses,$far_x_17               # 140e
        selb    $far_x_12,$far_x,$far_z_2,$c_greater    # 141e
        or      $misses_3,$misses,$end                  # 142e
next_row_back:
        brnz    $passes,next_row                        # 142o
next_row_drain:
        fcgt    $c_greater,$near_y_5,$near_x_7          # 0e
        hbr     filter_boxes_r16_return,$lr             # 0o hint
        fs      $misses,$far_x_11,$near_x_5             # 1e
        selb    $near_x_5,$near_x_7,$near_y_5,$c_greater # 2e
        or      $far_x_18,$far_x_11,$end_2              # 3e
        fcgt    $c_greater,$near_z_4,$near_x_5          # 4e
        fs      $end,$end_3,$near_x_6                   # 5e
        selb    $near_x_5,$near_x_5,$near_z_4,$c_greater # 6e
        or      $misses,$misses,$far_x_18               # 7e
        fs      $misses_4,$far_x_12,$near_x_5           # 8e
        fs      $end_7,$end_4,$near_x_5                 # 9e
        or      $far_x,$far_x_12,$end_4                 # 10e
        or      $far_x_3,$far_x_9,$end_3                # 11e
        and     $all_miss_3,$all_miss_2,$misses_3       # 12e
        or      $misses,$misses,$end_6                  # 13e
        or      $misses_4,$misses_4,$far_x              # 14e
        or      $misses_5,$misses_2,$far_x_3            # 15e
        and     $all_miss_3,$all_miss_3,$misses         # 16e
        or      $misses,$misses_4,$end_7                # 17e
        or      $misses_5,$misses_5,$end                # 18e
        and     $all_miss_3,$all_miss_3,$misses         # 19e
        a       $a_candidate,$a_candidate,$last_3       # 20e
        and     $all_miss,$all_miss_3,$misses_5         # 21e
        andc    $step,$last_2,$all_miss                 # 23e sign set: the child stays
        rotmi   $step,$step,-27                         # 25e
        andi    $step,$step,16                          # 29e
        a       $found_2,$found,$step                   # 31e
        rotqbyi $step+1,$step,4                         # 31o
        rotqbyi $step+2,$step,8                         # 32o
        rotqbyi $step+3,$step,12                        # 33o
        stqx    $entry,$a_first,$found_2                # 34o
        a       $found_3,$found_2,$step+1               # 35e
        a       $found_4,$found_3,$step+2               # 37e
        stqx    $entry_3,$a_first,$found_3              # 37o
        a       $found,$found_4,$step+3                 # 39e
        stqx    $entry_4,$a_first,$found_4              # 39o
        a       $a_first,$a_first,$found                # 41e
filter_boxes_r16_return:
        bi      $lr                                     # 41o
next_row_short:
        ceqi    $first,$row,0                           # 0e
        lqd     $candidate,0($a_candidate)              # 0o
        ai      $row_3,$row,16                          # 1e
        lqd     $again,0($a_again)                      # 1o
        or      $all_miss,$all_miss,$first              # 2e
        ai      $passes,$passes,-1                      # 3e
        rotqbyi $a_packet,$candidate,4                  # 6o
        lqd     $lower,0($candidate)                    # 7o
        lqd     $upper,48($candidate)                   # 8o
        lqd     $lower_3,16($candidate)                 # 9o
        a       $a_packet,$a_packet,$row                # 10e
        lqd     $upper_4,64($candidate)                 # 10o
        andi    $row,$row_3,48                          # 11e
        rotqbyi $a_bound,$candidate,8                   # 11o
        nop     $127                                    # 12e pairing
        lqd     $v,192($a_packet)                       # 12o
        ceqi    $last,$row,0                            # 13e
        lqd     $v_3,256($a_packet)                     # 13o
        fa      $middle_x,$lower,$upper                 # 14e
        lqd     $v_6,320($a_packet)                     # 14o
        fs      $half_x,$upper,$lower                   # 15e
        lqd     $v_8,0($a_packet)                       # 15o
        fa      $middle_y,$lower_3,$upper_4             # 16e
        lqd     $v_2,64($a_packet)                      # 16o
        fs      $half_y,$upper_4,$lower_3               # 17e
        lqd     $lower,32($candidate)                   # 17o
        fcmgt   $c_greater,$k_tiny,$v                   # 18e
        lqd     $upper,80($candidate)                   # 18o
        fcmgt   $c_greater_2,$k_tiny,$v_3               # 19e
        lqd     $v_4,128($a_packet)                     # 19o
        selb    $v,$v,$k_tiny,$c_greater                # 20e
        lqd     $slack,192($a_bound)                    # 20o
        selb    $v_3,$v_3,$k_tiny,$c_greater_2          # 21e
        lqd     $t,384($a_packet)                       # 21o
        fcmgt   $c_greater,$k_tiny,$v_6                 # 22e
        frest   $t_y,$v                                 # 22o
        fm      $middle_x,$middle_x,$k_half             # 23e
        frest   $t_y_2,$v_3                             # 23o
        selb    $v_6,$v_6,$k_tiny,$c_greater            # 24e
        lqd     $child,96($again)                       # 24o
        fa      $middle_z,$lower,$upper                 # 25e
        lnop                                            # 25o pairing
        fi      $t_y,$v,$t_y                            # 26e
        frest   $t_y_5,$v_6                             # 26o
        fi      $t_y_2,$v_3,$t_y_2                      # 27e
        shufb   $slack,$slack,$slack,$m_slack           # 27o
        andi    $last_4,$last,16                        # 28e
        shufb   $end,$t,$t,$m_lane                      # 28o
        fm      $middle_y,$middle_y,$k_half             # 29e
        shufb   $end_5,$t,$t,$m_lane+1                  # 29o
        fi      $t_y_5,$v_6,$t_y_5                      # 30e
        shufb   $end_8,$t,$t,$m_lane+2                  # 30o
        a       $child,$child,$base                     # 31e
        shufb   $end_3,$t,$t,$m_lane+3                  # 31o
        fm      $middle_z,$middle_z,$k_half             # 32e
        lnop                                            # 32o pairing
        fnms    $t_e,$v,$t_y,$k_one                     # 33e
        shufb   $entry,$child,$again,$m_entry           # 33o
        fnms    $t_e_3,$v_3,$t_y_2,$k_one               # 34e
        shufb   $entry_5,$child,$again,$m_entry+1       # 34o
        fs      $half_z_3,$upper,$lower                 # 35e
        shufb   $entry_6,$child,$again,$m_entry+2       # 35o
        fma     $half_x,$half_x,$k_half,$slack          # 36e
        shufb   $entry_7,$child,$again,$m_entry+3       # 36o
        fnms    $t_e_5,$v_6,$t_y_5,$k_one               # 37e
        stqx    $entry,$a_first,$found                  # 37o
        fma     $half_y,$half_y,$k_half,$slack          # 38e
        fma     $inverse_x_3,$t_e,$t_y,$t_y             # 39e
        fma     $inverse_y_2,$t_e_3,$t_y_2,$t_y_2       # 40e
        fma     $half_z_4,$half_z_3,$k_half,$slack      # 41e
        a       $a_candidate,$a_candidate,$last_4       # 42e
        fma     $inverse_z,$t_e_5,$t_y_5,$t_y_5         # 43e
        a       $a_again,$a_again,$last_4               # 44e
        lnop                                            # 44o pairing
        fnms    $shift_x,$v_8,$inverse_x_3,$k_zero      # 45e
        shufb   $inverse,$inverse_x_3,$inverse_x_3,$m_lane # 45o
        fnms    $shift_y,$v_2,$inverse_y_2,$k_zero      # 46e
        shufb   $inverse_13,$inverse_y_2,$inverse_y_2,$m_lane # 46o
        andc    $magnitude_x,$inverse_x_3,$m_sign       # 47e
        shufb   $inverse_14,$inverse_x_3,$inverse_x_3,$m_lane+1 # 47o
        andc    $magnitude_y,$inverse_y_2,$m_sign       # 48e
        shufb   $inverse_10,$inverse_y_2,$inverse_y_2,$m_lane+1 # 48o
        fnms    $shift_z,$v_4,$inverse_z,$k_zero        # 49e
        shufb   $inverse_15,$inverse_z,$inverse_z,$m_lane # 49o
        andc    $magnitude_z,$inverse_z,$m_sign         # 50e
        shufb   $inverse_16,$inverse_x_3,$inverse_x_3,$m_lane+2 # 50o
        shufb   $shift,$shift_x,$shift_x,$m_lane        # 51o
        shufb   $shift_8,$shift_y,$shift_y,$m_lane      # 52o
        shufb   $shift_20,$shift_x,$shift_x,$m_lane+1   # 53o
        shufb   $shift_17,$shift_y,$shift_y,$m_lane+1   # 54o
        fma     $shift,$middle_x,$inverse,$shift        # 55e
        shufb   $shift_21,$shift_z,$shift_z,$m_lane     # 55o
        fma     $shift_3,$middle_y,$inverse_13,$shift_8 # 56e
        shufb   $shift_8,$shift_x,$shift_x,$m_lane+2    # 56o
        fma     $shift_22,$middle_x,$inverse_14,$shift_20 # 57e
        shufb   $inverse,$inverse_y_2,$inverse_y_2,$m_lane+2 # 57o
        fma     $shift_15,$middle_y,$inverse_10,$shift_17 # 58e
        shufb   $shift_20,$shift_y,$shift_y,$m_lane+2   # 58o
        fma     $shift_2,$middle_z,$inverse_15,$shift_21 # 59e
        shufb   $magnitude,$magnitude_x,$magnitude_x,$m_lane # 59o
        fma     $shift_5,$middle_x,$inverse_16,$shift_8 # 60e
        shufb   $magnitude_13,$magnitude_y,$magnitude_y,$m_lane # 60o
        nop     $127                                    # 61e pairing
        shufb   $inverse_5,$inverse_z,$inverse_z,$m_lane+1 # 61o
        fma     $shift_20,$middle_y,$inverse,$shift_20  # 62e
        shufb   $shift_21,$shift_z,$shift_z,$m_lane+1   # 62o
        fnms    $near_x,$half_x,$magnitude,$shift       # 63e
        shufb   $inverse,$inverse_x_3,$inverse_x_3,$m_lane+3 # 63o
        fma     $far_x,$half_x,$magnitude,$shift        # 64e
        shufb   $shift,$shift_x,$shift_x,$m_lane+3      # 64o
        fnms    $near_y,$half_y,$magnitude_13,$shift_3  # 65e
        shufb   $inverse_17,$inverse_y_2,$inverse_y_2,$m_lane+3 # 65o
        fma     $far_y,$half_y,$magnitude_13,$shift_3   # 66e
        shufb   $shift_3,$shift_y,$shift_y,$m_lane+3    # 66o
        fma     $shift_8,$middle_z,$inverse_5,$shift_21 # 67e
        shufb   $magnitude,$magnitude_x,$magnitude_x,$m_lane+1 # 67o
        fma     $shift,$middle_x,$inverse,$shift        # 68e
        shufb   $magnitude_14,$magnitude_y,$magnitude_y,$m_lane+1 # 68o
        nop     $127                                    # 69e pairing
        shufb   $inverse,$inverse_z,$inverse_z,$m_lane+2 # 69o
        fma     $shift_11,$middle_y,$inverse_17,$shift_3 # 70e
        shufb   $shift_3,$shift_z,$shift_z,$m_lane+2    # 70o
        fnms    $near_x_3,$half_x,$magnitude,$shift_22  # 71e
        shufb   $magnitude_15,$magnitude_z,$magnitude_z,$m_lane # 71o
        fma     $far_x_19,$half_x,$magnitude,$shift_22  # 72e
        shufb   $magnitude,$magnitude_x,$magnitude_x,$m_lane+2 # 72o
        fnms    $near_y_8,$half_y,$magnitude_14,$shift_15 # 73e
        shufb   $magnitude_16,$magnitude_y,$magnitude_y,$m_lane+2 # 73o
        fma     $far_y_6,$half_y,$magnitude_14,$shift_15 # 74e
        shufb   $inverse_18,$inverse_z,$inverse_z,$m_lane+3 # 74o
        fma     $shift_3,$middle_z,$inverse,$shift_3    # 75e
        shufb   $shift_23,$shift_z,$shift_z,$m_lane+3   # 75o
        fnms    $near_z,$half_z_4,$magnitude_15,$shift_2 # 76e
        shufb   $magnitude_17,$magnitude_z,$magnitude_z,$m_lane+1 # 76o
        fma     $far_z,$half_z_4,$magnitude_15,$shift_2 # 77e
        shufb   $magnitude_18,$magnitude_x,$magnitude_x,$m_lane+3 # 77o
        fnms    $near_x_11,$half_x,$magnitude,$shift_5  # 78e
        shufb   $magnitude_10,$magnitude_y,$magnitude_y,$m_lane+3 # 78o
        fma     $far_x_14,$half_x,$magnitude,$shift_5   # 79e
        shufb   $magnitude,$magnitude_z,$magnitude_z,$m_lane+2 # 79o
        fnms    $near_y_9,$half_y,$magnitude_16,$shift_20 # 80e
        shufb   $magnitude_11,$magnitude_z,$magnitude_z,$m_lane+3 # 80o
        fma     $far_y_7,$half_y,$magnitude_16,$shift_20 # 81e
        fma     $shift_24,$middle_z,$inverse_18,$shift_23 # 82e
        fcgt    $c_greater,$near_y,$near_x              # 83e
        fcgt    $c_greater_16,$far_x,$far_y             # 84e
        fnms    $near_z_7,$half_z_4,$magnitude_17,$shift_8 # 85e
        fma     $far_z_7,$half_z_4,$magnitude_17,$shift_8 # 86e
        fnms    $near_x_12,$half_x,$magnitude_18,$shift # 87e
        fma     $far_x_9,$half_x,$magnitude_18,$shift   # 88e
        fnms    $near_y_10,$half_y,$magnitude_10,$shift_11 # 89e
        fma     $far_y_8,$half_y,$magnitude_10,$shift_11 # 90e
        selb    $near_x,$near_x,$near_y,$c_greater      # 91e
        selb    $far_x,$far_x,$far_y,$c_greater_16      # 92e
        fcgt    $c_greater,$near_y_8,$near_x_3          # 93e
        fcgt    $c_greater_16,$far_x_19,$far_y_6        # 94e
        fnms    $near_z_8,$half_z_4,$magnitude,$shift_3 # 95e
        fma     $far_z_8,$half_z_4,$magnitude,$shift_3  # 96e
        fcgt    $c_greater_17,$near_z,$near_x           # 97e
        fcgt    $c_greater_12,$far_x,$far_z             # 98e
        selb    $near_x_3,$near_x_3,$near_y_8,$c_greater # 99e
        selb    $far_x_19,$far_x_19,$far_y_6,$c_greater_16 # 100e
        fcgt    $c_greater,$near_y_9,$near_x_11         # 101e
        fcgt    $c_greater_18,$far_x_14,$far_y_7        # 102e
        fnms    $near_z_9,$half_z_4,$magnitude_11,$shift_24 # 103e
        fma     $far_z_9,$half_z_4,$magnitude_11,$shift_24 # 104e
        selb    $near_x,$near_x,$near_z,$c_greater_17   # 105e
        selb    $far_x,$far_x,$far_z,$c_greater_12      # 106e
        fcgt    $c_greater_4,$near_z_7,$near_x_3        # 107e
        fcgt    $c_greater_5,$far_x_19,$far_z_7         # 108e
        selb    $near_x_11,$near_x_11,$near_y_9,$c_greater # 109e
        selb    $far_x_18,$far_x_14,$far_y_7,$c_greater_18 # 110e
        fcgt    $c_greater,$near_y_10,$near_x_12        # 111e
        fcgt    $c_greater_11,$far_x_9,$far_y_8         # 112e
        fs      $misses,$far_x,$near_x                  # 113e
        selb    $near_x_13,$near_x_3,$near_z_7,$c_greater_4 # 114e
        selb    $far_x_19,$far_x_19,$far_z_7,$c_greater_5 # 115e
        fcgt    $c_greater_19,$near_z_8,$near_x_11      # 116e
        fcgt    $c_greater_4,$far_x_18,$far_z_8         # 117e
        selb    $near_x_3,$near_x_12,$near_y_10,$c_greater # 118e
        selb    $far_x_3,$far_x_9,$far_y_8,$c_greater_11 # 119e
        fs      $end_9,$end,$near_x                     # 120e
        fs      $misses_6,$far_x_19,$near_x_13          # 121e
        selb    $near_x,$near_x_11,$near_z_8,$c_greater_19 # 122e
        selb    $far_x_5,$far_x_18,$far_z_8,$c_greater_4 # 123e
        fcgt    $c_greater,$near_z_9,$near_x_3          # 124e
        fcgt    $c_greater_18,$far_x_3,$far_z_9         # 125e
        or      $far_x,$far_x,$end                      # 126e
        fs      $end,$end_5,$near_x_13                  # 127e
        fs      $misses_3,$far_x_5,$near_x              # 128e
        selb    $near_x_13,$near_x_3,$near_z_9,$c_greater # 129e
        selb    $far_x_3,$far_x_3,$far_z_9,$c_greater_18 # 130e
        or      $misses,$misses,$far_x                  # 131e
        or      $far_x,$far_x_19,$end_5                 # 132e
        fs      $end_10,$end_8,$near_x                  # 133e
        fs      $misses_7,$far_x_3,$near_x_13           # 134e
        or      $misses,$misses,$end_9                  # 135e
        or      $misses_8,$misses_6,$far_x              # 136e
        or      $far_x,$far_x_5,$end_8                  # 137e
        fs      $end_11,$end_3,$near_x_13               # 138e
        and     $all_miss,$all_miss,$misses             # 139e
        or      $misses,$misses_8,$end                  # 140e
        or      $misses_8,$misses_3,$far_x              # 141e
        or      $far_x,$far_x_3,$end_3                  # 142e
        and     $all_miss,$all_miss,$misses             # 143e
        hbrr    next_row_short_back,next_row_short      # 143o hint
        or      $misses,$misses_8,$end_10               # 144e
        or      $misses_5,$misses_7,$far_x              # 145e
        and     $all_miss,$all_miss,$misses             # 146e
        or      $misses,$misses_5,$end_11               # 147e
        and     $all_miss,$all_miss,$misses             # 149e
        andc    $step,$last,$all_miss                   # 151e sign set: the child stays
        rotmi   $step,$step,-27                         # 153e
        andi    $step,$step,16                          # 157e
        a       $found,$found,$step                     # 159e
        rotqbyi $step+1,$step,4                         # 159o
        rotqbyi $step+2,$step,8                         # 160o
        rotqbyi $step+3,$step,12                        # 161o
        stqx    $entry_5,$a_first,$found                # 162o
        a       $found,$found,$step+1                   # 163e
        a       $found_5,$found,$step+2                 # 165e
        stqx    $entry_6,$a_first,$found                # 165o
        a       $found,$found_5,$step+3                 # 167e
        stqx    $entry_7,$a_first,$found_5              # 167o
        nop     $127                                    # 168e pairing
next_row_short_back:
        brnz    $passes,next_row_short                  # 168o
        a       $a_first,$a_first,$found                # 169e
        bi      $lr                                     # 169o
endfunction filter_boxes_r16
