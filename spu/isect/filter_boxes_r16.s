# filter_boxes_r16   of nodes of a mesh, the children whose boxes one of a packet's rays may meet
#   C       struct mesh_candidate *filter_boxes_r16(const struct mesh_candidate *, int count,
#                                                   struct mesh_candidate *, int base);
#   In      $3 candidates whose objects are BOXES, $4 count (0 is none), $5 where the list goes,
#           which may not be among the candidates, $6 what is added to each child's word; pointers
#           16-aligned
#   Out     candidates of such children, node by node, children in order: object is the child's
#           word plus $6, the rest the node's; three more quadwords may be written
#           $3 end of the list
#   Uses    $3-$6, $10-$69   Saves  -   Stack  0   Calls  -
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
        ori     $a_candidate,$a_first,0
        ori     $a_again,$a_first,0
        ori     $3,$a_list,0
        biz     $count,$lr
        il      $found,0
        il      $row,0
        shli    $passes,$count,2
        il      $k_zero,0
        ilhu    $m_sign,0x8000
        ilhu    $k_half,0x3f00
        ilhu    $k_one,0x3f80
        ilhu    $k_tiny,0x2180                          # 2^-60
        load_constant $m_slack,0x00018080               # the upper half of the first word
        load_constant $m_lane,0x00010203
        load_constant $m_lane+1,0x04050607
        load_constant $m_lane+2,0x08090a0b
        load_constant $m_lane+3,0x0c0d0e0f
        shufb   $base,$base,$base,$m_lane
    .irp child, 0,1,2,3
        lqa     $m_entry+\child,child_of_node+16*\child
    .endr
next_row:
        lqd     $candidate,0($a_candidate)
        rotqbyi $a_bound,$candidate,MESH_CANDIDATE_bound
        rotqbyi $a_packet,$candidate,MESH_CANDIDATE_packet
        a       $a_packet,$a_packet,$row
        lqd     $slack,MESH_BOUND_slack($a_bound)
        shufb   $slack,$slack,$slack,$m_slack
    .irp axis, x,y,z
        lqd     $lower,BOXES_lo_\axis($candidate)
        lqd     $upper,BOXES_hi_\axis($candidate)
        fa      $middle_\axis,$lower,$upper
        fm      $middle_\axis,$middle_\axis,$k_half
        fs      $half_\axis,$upper,$lower
        fma     $half_\axis,$half_\axis,$k_half,$slack
    .endr
        lqd     $t,RAYS16_t($a_packet)
    .irp axis, x,y,z
        lqd     $v,RAYS16_direction_\axis($a_packet)
        fcmgt   $c_greater,$k_tiny,$v
        selb    $v,$v,$k_tiny,$c_greater
        reciprocal_f4 $inverse_\axis,$v,$t_y,$t_e,$k_one
        andc    $magnitude_\axis,$inverse_\axis,$m_sign
        lqd     $v,RAYS16_origin_\axis($a_packet)
        fnms    $shift_\axis,$v,$inverse_\axis,$k_zero
    .endr
        ceqi    $first,$row,0
        or      $all_miss,$all_miss,$first
        ai      $row,$row,16
        andi    $row,$row,48
        ceqi    $last,$row,0
    .irp lane, 0,1,2,3
    .irp axis, x,y,z
        shufb   $inverse,$inverse_\axis,$inverse_\axis,$m_lane+\lane
        shufb   $magnitude,$magnitude_\axis,$magnitude_\axis,$m_lane+\lane
        shufb   $shift,$shift_\axis,$shift_\axis,$m_lane+\lane
        fma     $shift,$middle_\axis,$inverse,$shift
        fnms    $near_\axis,$half_\axis,$magnitude,$shift
        fma     $far_\axis,$half_\axis,$magnitude,$shift
    .endr
        shufb   $end,$t,$t,$m_lane+\lane
        maximum $near_x,$near_y,$c_greater
        maximum $near_x,$near_z,$c_greater
        minimum_f4 $far_x,$far_y,$c_greater
        minimum_f4 $far_x,$far_z,$c_greater
        fs      $misses,$far_x,$near_x
        or      $far_x,$far_x,$end
        fs      $end,$end,$near_x
        or      $misses,$misses,$far_x
        or      $misses,$misses,$end
        and     $all_miss,$all_miss,$misses
    .endr
        # The list grows after the last row only, and then the next candidate follows.
        andc    $step,$last,$all_miss                   # sign set: the child stays
        rotmi   $step,$step,4-31
        andi    $step,$step,MESH_CANDIDATE_SIZE
    .irp child, 1,2,3
        rotqbyi $step+\child,$step,4*\child
    .endr
        lqd     $again,0($a_again)
        lqd     $child,BOXES_child($again)
        a       $child,$child,$base
    .irp child, 0,1,2,3
        shufb   $entry,$child,$again,$m_entry+\child
        stqx    $entry,$3,$found
        a       $found,$found,$step+\child
    .endr
        andi    $last,$last,MESH_CANDIDATE_SIZE
        a       $a_candidate,$a_candidate,$last
        a       $a_again,$a_again,$last
        ai      $passes,$passes,-1
        brnz    $passes,next_row
        a       $3,$3,$found
        bi      $lr
endfunction filter_boxes_r16
