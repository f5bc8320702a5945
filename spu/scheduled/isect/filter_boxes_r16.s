# filter_boxes_r16   of nodes of a mesh, the children whose boxes one of a packet's rays may meet
#   C       struct mesh_candidate *filter_boxes_r16(const struct mesh_candidate *, int count,
#                                                   struct mesh_candidate *, int base);
#   In      $3 candidates whose objects are BOXES, $4 count (0 is none), $5 where the list goes,
#           which may not be among the candidates, $6 what is added to each child's word; pointers
#           16-aligned
#   Out     candidates of such children, node by node, children in order: object is the child's
#           word plus $6, the rest the node's; three more quadwords may be written
#           $3 behind the list
#   Uses    $2-$75   Saves  -   Stack  0   Calls  -
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
# Each pass of the loop tests a row of rays. The loop counts up, so that it isn't pipelined.
# Pipelined it would take 143 cycles a row instead of 169, but 2.8 KB of local store instead of 1.
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
        .set row_2,2; .set lower_2,4; .set upper_2,5; .set v_2,2; .set v_3,7; .set v_4,8
        .set v_5,9; .set c_greater_2,4; .set v_6,5; .set t_y_2,4; .set t_y_3,28; .set last_2,29
        .set end_2,30; .set end_3,33; .set end_4,40; .set t_e_2,2; .set entry_2,44
        .set half_z_2,41; .set entry_3,42; .set entry_4,31; .set t_e_3,7; .set inverse_x_2,45
        .set inverse_y_2,2; .set half_z_3,4; .set inverse_2,7; .set inverse_3,8; .set inverse_4,9
        .set inverse_5,5; .set inverse_6,28; .set shift_2,29; .set shift_3,32; .set shift_4,41
        .set shift_5,53; .set shift_6,7; .set shift_7,8; .set shift_8,9; .set shift_9,5
        .set shift_10,28; .set magnitude_2,29; .set inverse_7,41; .set inverse_8,2
        .set magnitude_3,35; .set shift_11,2; .set near_x_2,36; .set magnitude_4,41; .set far_x_2,8
        .set near_y_2,45; .set magnitude_5,50; .set far_y_2,9; .set inverse_9,35; .set shift_12,46
        .set magnitude_6,51; .set magnitude_7,5; .set near_x_3,41; .set magnitude_8,47
        .set far_x_3,28; .set near_y_3,48; .set magnitude_9,49; .set far_y_3,32; .set shift_13,35
        .set c_greater_3,37; .set near_z_2,46; .set far_z_2,29; .set near_x_4,50; .set far_x_4,5
        .set near_y_4,38; .set far_y_4,2; .set near_z_3,39; .set far_z_3,7; .set c_greater_4,47
        .set c_greater_5,51; .set c_greater_6,9; .set near_z_4,37; .set far_z_4,4
        .set c_greater_7,35; .set c_greater_8,45; .set far_x_5,9; .set c_greater_9,28
        .set near_x_5,32; .set c_greater_10,29; .set far_x_6,2; .set end_5,5; .set misses_2,28
        .set far_x_7,7; .set misses_3,29; .set end_6,4; .set misses_4,8; .set misses_5,5
        .set end_7,7; .set misses_6,2; .set found_2,2
        ori     $a_candidate,$a_first,0                 # 0e
        ori     $a_again,$a_first,0                     # 1e
        ori     $a_first,$a_list,0                      # 2e
        biz     $count,$lr                              # 2o
        ilhu    $m_lane,1                               # 3e
        lqa     $m_entry,child_of_node                  # 3o
        shli    $passes,$count,2                        # 4e
        lqa     $m_entry+1,child_of_node+16             # 4o
        iohl    $m_lane,515                             # 5e
        lqa     $m_entry+2,child_of_node+32             # 5o
        ilhu    $m_slack,1                              # 6e the upper half of the first word
        lqa     $m_entry+3,child_of_node+48             # 6o
        ilhu    $m_lane+1,0x405                         # 7e
        shufb   $base,$base,$base,$m_lane               # 7o
        ilhu    $m_lane+2,0x809                         # 8e
        ilhu    $m_lane+3,0xc0d                         # 9e
        il      $found,0                                # 10e
        il      $row,0                                  # 11e
        sfi     $passes,$passes,0                       # 12e
        il      $k_zero,0                               # 13e
        ilhu    $m_sign,0x8000                          # 14e
        ilhu    $k_half,0x3f00                          # 15e
        ilhu    $k_one,0x3f80                           # 16e
        ilhu    $k_tiny,0x2180                          # 17e 2^-60
        iohl    $m_slack,0x8080                         # 18e the upper half of the first word
        iohl    $m_lane+1,0x607                         # 19e
        iohl    $m_lane+2,0xa0b                         # 20e
        iohl    $m_lane+3,0xe0f                         # 21e
next_row:
        ceqi    $first,$row,0                           # 0e
        lqd     $candidate,0($a_candidate)              # 0o
        ai      $row_2,$row,16                          # 1e
        lqd     $again,0($a_again)                      # 1o
        or      $all_miss,$all_miss,$first              # 2e
        ai      $passes,$passes,1                       # 3e
        rotqbyi $a_packet,$candidate,4                  # 6o
        lqd     $lower,0($candidate)                    # 7o
        lqd     $upper,48($candidate)                   # 8o
        lqd     $lower_2,16($candidate)                 # 9o
        a       $a_packet,$a_packet,$row                # 10e
        lqd     $upper_2,64($candidate)                 # 10o
        andi    $row,$row_2,48                          # 11e
        rotqbyi $a_bound,$candidate,8                   # 11o
        nop     $127                                    # 12e pairing
        lqd     $v,192($a_packet)                       # 12o
        ceqi    $last,$row,0                            # 13e
        lqd     $v_2,256($a_packet)                     # 13o
        fa      $middle_x,$lower,$upper                 # 14e
        lqd     $v_3,320($a_packet)                     # 14o
        fs      $half_x,$upper,$lower                   # 15e
        lqd     $v_4,0($a_packet)                       # 15o
        fa      $middle_y,$lower_2,$upper_2             # 16e
        lqd     $v_5,64($a_packet)                      # 16o
        fs      $half_y,$upper_2,$lower_2               # 17e
        lqd     $lower,32($candidate)                   # 17o
        fcmgt   $c_greater,$k_tiny,$v                   # 18e
        lqd     $upper,80($candidate)                   # 18o
        fcmgt   $c_greater_2,$k_tiny,$v_2               # 19e
        lqd     $v_6,128($a_packet)                     # 19o
        selb    $v,$v,$k_tiny,$c_greater                # 20e
        lqd     $slack,192($a_bound)                    # 20o
        selb    $v_2,$v_2,$k_tiny,$c_greater_2          # 21e
        lqd     $t,384($a_packet)                       # 21o
        fcmgt   $c_greater,$k_tiny,$v_3                 # 22e
        frest   $t_y,$v                                 # 22o
        fm      $middle_x,$middle_x,$k_half             # 23e
        frest   $t_y_2,$v_2                             # 23o
        selb    $v_3,$v_3,$k_tiny,$c_greater            # 24e
        lqd     $child,96($again)                       # 24o
        fa      $middle_z,$lower,$upper                 # 25e
        lnop                                            # 25o pairing
        fi      $t_y,$v,$t_y                            # 26e
        frest   $t_y_3,$v_3                             # 26o
        fi      $t_y_2,$v_2,$t_y_2                      # 27e
        shufb   $slack,$slack,$slack,$m_slack           # 27o
        andi    $last_2,$last,16                        # 28e
        shufb   $end,$t,$t,$m_lane                      # 28o
        fm      $middle_y,$middle_y,$k_half             # 29e
        shufb   $end_2,$t,$t,$m_lane+1                  # 29o
        fi      $t_y_3,$v_3,$t_y_3                      # 30e
        shufb   $end_3,$t,$t,$m_lane+2                  # 30o
        a       $child,$child,$base                     # 31e
        shufb   $end_4,$t,$t,$m_lane+3                  # 31o
        fm      $middle_z,$middle_z,$k_half             # 32e
        lnop                                            # 32o pairing
        fnms    $t_e,$v,$t_y,$k_one                     # 33e
        shufb   $entry,$child,$again,$m_entry           # 33o
        fnms    $t_e_2,$v_2,$t_y_2,$k_one               # 34e
        shufb   $entry_2,$child,$again,$m_entry+1       # 34o
        fs      $half_z_2,$upper,$lower                 # 35e
        shufb   $entry_3,$child,$again,$m_entry+2       # 35o
        fma     $half_x,$half_x,$k_half,$slack          # 36e
        shufb   $entry_4,$child,$again,$m_entry+3       # 36o
        fnms    $t_e_3,$v_3,$t_y_3,$k_one               # 37e
        stqx    $entry,$a_first,$found                  # 37o
        fma     $half_y,$half_y,$k_half,$slack          # 38e
        fma     $inverse_x_2,$t_e,$t_y,$t_y             # 39e
        fma     $inverse_y_2,$t_e_2,$t_y_2,$t_y_2       # 40e
        fma     $half_z_3,$half_z_2,$k_half,$slack      # 41e
        a       $a_candidate,$a_candidate,$last_2       # 42e
        fma     $inverse_z,$t_e_3,$t_y_3,$t_y_3         # 43e
        a       $a_again,$a_again,$last_2               # 44e
        lnop                                            # 44o pairing
        fnms    $shift_x,$v_4,$inverse_x_2,$k_zero      # 45e
        shufb   $inverse,$inverse_x_2,$inverse_x_2,$m_lane # 45o
        fnms    $shift_y,$v_5,$inverse_y_2,$k_zero      # 46e
        shufb   $inverse_2,$inverse_y_2,$inverse_y_2,$m_lane # 46o
        andc    $magnitude_x,$inverse_x_2,$m_sign       # 47e
        shufb   $inverse_3,$inverse_x_2,$inverse_x_2,$m_lane+1 # 47o
        andc    $magnitude_y,$inverse_y_2,$m_sign       # 48e
        shufb   $inverse_4,$inverse_y_2,$inverse_y_2,$m_lane+1 # 48o
        fnms    $shift_z,$v_6,$inverse_z,$k_zero        # 49e
        shufb   $inverse_5,$inverse_z,$inverse_z,$m_lane # 49o
        andc    $magnitude_z,$inverse_z,$m_sign         # 50e
        shufb   $inverse_6,$inverse_x_2,$inverse_x_2,$m_lane+2 # 50o
        shufb   $shift,$shift_x,$shift_x,$m_lane        # 51o
        shufb   $shift_2,$shift_y,$shift_y,$m_lane      # 52o
        shufb   $shift_3,$shift_x,$shift_x,$m_lane+1    # 53o
        shufb   $shift_4,$shift_y,$shift_y,$m_lane+1    # 54o
        fma     $shift,$middle_x,$inverse,$shift        # 55e
        shufb   $shift_5,$shift_z,$shift_z,$m_lane      # 55o
        fma     $shift_6,$middle_y,$inverse_2,$shift_2  # 56e
        shufb   $shift_2,$shift_x,$shift_x,$m_lane+2    # 56o
        fma     $shift_7,$middle_x,$inverse_3,$shift_3  # 57e
        shufb   $inverse,$inverse_y_2,$inverse_y_2,$m_lane+2 # 57o
        fma     $shift_8,$middle_y,$inverse_4,$shift_4  # 58e
        shufb   $shift_3,$shift_y,$shift_y,$m_lane+2    # 58o
        fma     $shift_9,$middle_z,$inverse_5,$shift_5  # 59e
        shufb   $magnitude,$magnitude_x,$magnitude_x,$m_lane # 59o
        fma     $shift_10,$middle_x,$inverse_6,$shift_2 # 60e
        shufb   $magnitude_2,$magnitude_y,$magnitude_y,$m_lane # 60o
        nop     $127                                    # 61e pairing
        shufb   $inverse_7,$inverse_z,$inverse_z,$m_lane+1 # 61o
        fma     $shift_3,$middle_y,$inverse,$shift_3    # 62e
        shufb   $shift_5,$shift_z,$shift_z,$m_lane+1    # 62o
        fnms    $near_x,$half_x,$magnitude,$shift       # 63e
        shufb   $inverse,$inverse_x_2,$inverse_x_2,$m_lane+3 # 63o
        fma     $far_x,$half_x,$magnitude,$shift        # 64e
        shufb   $shift,$shift_x,$shift_x,$m_lane+3      # 64o
        fnms    $near_y,$half_y,$magnitude_2,$shift_6   # 65e
        shufb   $inverse_8,$inverse_y_2,$inverse_y_2,$m_lane+3 # 65o
        fma     $far_y,$half_y,$magnitude_2,$shift_6    # 66e
        shufb   $shift_6,$shift_y,$shift_y,$m_lane+3    # 66o
        fma     $shift_2,$middle_z,$inverse_7,$shift_5  # 67e
        shufb   $magnitude,$magnitude_x,$magnitude_x,$m_lane+1 # 67o
        fma     $shift,$middle_x,$inverse,$shift        # 68e
        shufb   $magnitude_3,$magnitude_y,$magnitude_y,$m_lane+1 # 68o
        nop     $127                                    # 69e pairing
        shufb   $inverse,$inverse_z,$inverse_z,$m_lane+2 # 69o
        fma     $shift_11,$middle_y,$inverse_8,$shift_6 # 70e
        shufb   $shift_6,$shift_z,$shift_z,$m_lane+2    # 70o
        fnms    $near_x_2,$half_x,$magnitude,$shift_7   # 71e
        shufb   $magnitude_4,$magnitude_z,$magnitude_z,$m_lane # 71o
        fma     $far_x_2,$half_x,$magnitude,$shift_7    # 72e
        shufb   $magnitude,$magnitude_x,$magnitude_x,$m_lane+2 # 72o
        fnms    $near_y_2,$half_y,$magnitude_3,$shift_8 # 73e
        shufb   $magnitude_5,$magnitude_y,$magnitude_y,$m_lane+2 # 73o
        fma     $far_y_2,$half_y,$magnitude_3,$shift_8  # 74e
        shufb   $inverse_9,$inverse_z,$inverse_z,$m_lane+3 # 74o
        fma     $shift_6,$middle_z,$inverse,$shift_6    # 75e
        shufb   $shift_12,$shift_z,$shift_z,$m_lane+3   # 75o
        fnms    $near_z,$half_z_3,$magnitude_4,$shift_9 # 76e
        shufb   $magnitude_6,$magnitude_z,$magnitude_z,$m_lane+1 # 76o
        fma     $far_z,$half_z_3,$magnitude_4,$shift_9  # 77e
        shufb   $magnitude_7,$magnitude_x,$magnitude_x,$m_lane+3 # 77o
        fnms    $near_x_3,$half_x,$magnitude,$shift_10  # 78e
        shufb   $magnitude_8,$magnitude_y,$magnitude_y,$m_lane+3 # 78o
        fma     $far_x_3,$half_x,$magnitude,$shift_10   # 79e
        shufb   $magnitude,$magnitude_z,$magnitude_z,$m_lane+2 # 79o
        fnms    $near_y_3,$half_y,$magnitude_5,$shift_3 # 80e
        shufb   $magnitude_9,$magnitude_z,$magnitude_z,$m_lane+3 # 80o
        fma     $far_y_3,$half_y,$magnitude_5,$shift_3  # 81e
        fma     $shift_13,$middle_z,$inverse_9,$shift_12 # 82e
        fcgt    $c_greater,$near_y,$near_x              # 83e
        fcgt    $c_greater_3,$far_x,$far_y              # 84e
        fnms    $near_z_2,$half_z_3,$magnitude_6,$shift_2 # 85e
        fma     $far_z_2,$half_z_3,$magnitude_6,$shift_2 # 86e
        fnms    $near_x_4,$half_x,$magnitude_7,$shift   # 87e
        fma     $far_x_4,$half_x,$magnitude_7,$shift    # 88e
        fnms    $near_y_4,$half_y,$magnitude_8,$shift_11 # 89e
        fma     $far_y_4,$half_y,$magnitude_8,$shift_11 # 90e
        selb    $near_x,$near_x,$near_y,$c_greater      # 91e
        selb    $far_x,$far_x,$far_y,$c_greater_3       # 92e
        fcgt    $c_greater,$near_y_2,$near_x_2          # 93e
        fcgt    $c_greater_3,$far_x_2,$far_y_2          # 94e
        fnms    $near_z_3,$half_z_3,$magnitude,$shift_6 # 95e
        fma     $far_z_3,$half_z_3,$magnitude,$shift_6  # 96e
        fcgt    $c_greater_4,$near_z,$near_x            # 97e
        fcgt    $c_greater_5,$far_x,$far_z              # 98e
        selb    $near_x_2,$near_x_2,$near_y_2,$c_greater # 99e
        selb    $far_x_2,$far_x_2,$far_y_2,$c_greater_3 # 100e
        fcgt    $c_greater,$near_y_3,$near_x_3          # 101e
        fcgt    $c_greater_6,$far_x_3,$far_y_3          # 102e
        fnms    $near_z_4,$half_z_3,$magnitude_9,$shift_13 # 103e
        fma     $far_z_4,$half_z_3,$magnitude_9,$shift_13 # 104e
        selb    $near_x,$near_x,$near_z,$c_greater_4    # 105e
        selb    $far_x,$far_x,$far_z,$c_greater_5       # 106e
        fcgt    $c_greater_7,$near_z_2,$near_x_2        # 107e
        fcgt    $c_greater_8,$far_x_2,$far_z_2          # 108e
        selb    $near_x_3,$near_x_3,$near_y_3,$c_greater # 109e
        selb    $far_x_5,$far_x_3,$far_y_3,$c_greater_6 # 110e
        fcgt    $c_greater,$near_y_4,$near_x_4          # 111e
        fcgt    $c_greater_9,$far_x_4,$far_y_4          # 112e
        fs      $misses,$far_x,$near_x                  # 113e
        selb    $near_x_5,$near_x_2,$near_z_2,$c_greater_7 # 114e
        selb    $far_x_2,$far_x_2,$far_z_2,$c_greater_8 # 115e
        fcgt    $c_greater_10,$near_z_3,$near_x_3       # 116e
        fcgt    $c_greater_7,$far_x_5,$far_z_3          # 117e
        selb    $near_x_2,$near_x_4,$near_y_4,$c_greater # 118e
        selb    $far_x_6,$far_x_4,$far_y_4,$c_greater_9 # 119e
        fs      $end_5,$end,$near_x                     # 120e
        fs      $misses_2,$far_x_2,$near_x_5            # 121e
        selb    $near_x,$near_x_3,$near_z_3,$c_greater_10 # 122e
        selb    $far_x_7,$far_x_5,$far_z_3,$c_greater_7 # 123e
        fcgt    $c_greater,$near_z_4,$near_x_2          # 124e
        fcgt    $c_greater_6,$far_x_6,$far_z_4          # 125e
        or      $far_x,$far_x,$end                      # 126e
        fs      $end,$end_2,$near_x_5                   # 127e
        fs      $misses_3,$far_x_7,$near_x              # 128e
        selb    $near_x_5,$near_x_2,$near_z_4,$c_greater # 129e
        selb    $far_x_6,$far_x_6,$far_z_4,$c_greater_6 # 130e
        or      $misses,$misses,$far_x                  # 131e
        or      $far_x,$far_x_2,$end_2                  # 132e
        fs      $end_6,$end_3,$near_x                   # 133e
        fs      $misses_4,$far_x_6,$near_x_5            # 134e
        or      $misses,$misses,$end_5                  # 135e
        or      $misses_5,$misses_2,$far_x              # 136e
        or      $far_x,$far_x_7,$end_3                  # 137e
        fs      $end_7,$end_4,$near_x_5                 # 138e
        and     $all_miss,$all_miss,$misses             # 139e
        or      $misses,$misses_5,$end                  # 140e
        or      $misses_5,$misses_3,$far_x              # 141e
        or      $far_x,$far_x_6,$end_4                  # 142e
        and     $all_miss,$all_miss,$misses             # 143e
        hbrr    next_row_back,next_row                  # 143o hint
        or      $misses,$misses_5,$end_6                # 144e
        or      $misses_6,$misses_4,$far_x              # 145e
        and     $all_miss,$all_miss,$misses             # 146e
        or      $misses,$misses_6,$end_7                # 147e
        and     $all_miss,$all_miss,$misses             # 149e
        andc    $step,$last,$all_miss                   # 151e sign set: the child stays
        rotmi   $step,$step,-27                         # 153e
        andi    $step,$step,16                          # 157e
        a       $found,$found,$step                     # 159e
        rotqbyi $step+1,$step,4                         # 159o
        rotqbyi $step+2,$step,8                         # 160o
        rotqbyi $step+3,$step,12                        # 161o
        stqx    $entry_2,$a_first,$found                # 162o
        a       $found,$found,$step+1                   # 163e
        a       $found_2,$found,$step+2                 # 165e
        stqx    $entry_3,$a_first,$found                # 165o
        a       $found,$found_2,$step+3                 # 167e
        stqx    $entry_4,$a_first,$found_2              # 167o
        nop     $127                                    # 168e pairing
next_row_back:
        brnz    $passes,next_row                        # 168o
        a       $a_first,$a_first,$found                # 169e
        bi      $lr                                     # 169o
endfunction filter_boxes_r16
