# cull_boxes   of nodes of a mesh, the children whose boxes some ray of a packet may meet
#   C       struct mesh_candidate *cull_boxes(const struct mesh_candidate *, int count,
#                                             struct mesh_candidate *, int base);
#   In      $3 candidates whose objects are BOXES, $4 count (0 is none), $5 where the list goes,
#           which may not be among the candidates, $6 what is added to each child's word; pointers
#           16-aligned
#   Out     candidates of such children, node by node, children in order: object is the child's
#           word plus $6, near is when a ray can meet its box, the rest the node's; three more
#           quadwords may be written
#           $3 end of the list
#   Uses    $3-$6, $10-$69   Saves  -   Stack  0   Calls  -
#   Domain  bounds as mesh_bounds_r16 makes them; boxes with a slack of 2^-19 of the largest
#           magnitude of their coordinates; distances from 2^-60 to 2^60
#   Error   0: no child is left out that a ray of the packet enters before it ends
#   Twin    lab/twins/src/mesh.rs
#
# The four children are in the four lanes. The times at which the packet's rays can be in a box are
# from
#   the latest of near_scale near + near_shift, of the three axes, and of 0
# to
#   the earliest of far_scale far + far_shift, and of the farthest hit.
# Where rays go up and down an axis, nothing is known of the last time. But they meet the box only
# from outside: those that go up after they meet its lower plane, the others after its upper plane.
# So the second product is then another bound of the first time. That is so where near_scale is
# above far_scale as an integer, because only then their signs differ: mesh_bounds_r16 makes
# near_scale smaller than far_scale in magnitude.
#
# The slacks of the boxes and of the bound's origins are 2^-19 of the coordinates each. The rounding
# of each product is below 2^-22 of them.

        .include "work_unit.inc"
        .include "macros.inc"
        .include "extremes.inc"

        .set    NEXT,3
        registers a_first                               # candidate
        registers count,a_list,base
        # constants
        .set    NEXT,10
        registers m_entry                               # to 13: the child's word and near
        .set    NEXT,14
        registers m_between,m_farthest,k_far_planes,k_zero,k_step
        # state
        registers a_candidate
        registers found                                 # bytes of the list so far
        # the candidate
        registers candidate,a_bound,child
        # the bound
        registers near_x,near_y,near_z                  # offsets of planes
        registers far_x,far_y,far_z
        registers farthest
        # planes, then when they are met
        registers near_time_x,near_time_y,near_time_z
        registers far_time_x,far_time_y,far_time_z
        registers near_scale_x,near_scale_y,near_scale_z
        registers far_scale_x,far_scale_y,far_scale_z
        registers near_shift_x,near_shift_y,near_shift_z
        registers far_shift_x,far_shift_y,far_shift_z
        registers both_x,both_y,both_z                  # the axis is gone up and down
        registers entry_x,entry_y,entry_z
        registers c_greater
        registers near
        registers step                                  # to 63
        .set    NEXT,step+4
        registers entry
        # the candidate, loaded again instead of being kept in a register for so long
        registers a_again,again

        .section .rodata.mesh,"a",@progbits
        .align  4
# An entry of the list is made by two shuffles. The first one takes the child's word and its near
# distance to where they belong; the second one puts the packet and the bound between them.
child_and_near:
    .irp child, 0,1,2,3
        .int    0x00010203+0x04040404*\child,0x80808080,0x80808080,0x10111213+0x04040404*\child
    .endr
packet_between:
        .int    0x00010203,0x14151617,0x18191a1b,0x0c0d0e0f
far_planes:                                             # sums of both planes' offsets
        .int    48,80<<16|112,0,0

function cull_boxes
        ori     $a_candidate,$a_first,0
        ori     $a_again,$a_first,0
        ori     $3,$a_list,0
        biz     $count,$lr
        il      $found,0
        il      $k_zero,0
        il      $k_step,MESH_CANDIDATE_SIZE
        load_constant $m_farthest,0x0c0d0e0f
        ila     $c_greater,0x10203
        shufb   $base,$base,$base,$c_greater
        lqa     $m_between,packet_between
        lqa     $k_far_planes,far_planes
    .irp child, 0,1,2,3
        lqa     $m_entry+\child,child_and_near+16*\child
    .endr
next_boxes:
        lqd     $candidate,0($a_candidate)
        rotqbyi $a_bound,$candidate,MESH_CANDIDATE_bound
        lqd     $near_x,MESH_BOUND_slack($a_bound)
        shufb   $farthest,$near_x,$near_x,$m_farthest
        sf      $far_x,$near_x,$k_far_planes
        # The two bits before an offset are 0. Those before these make no difference to an address.
        rotqbyi $near_y,$near_x,(MESH_BOUND_near_plane_y-2)&15
        rotqbyi $near_z,$near_x,(MESH_BOUND_near_plane_z-2)&15
        rotqbyi $far_y,$far_x,(MESH_BOUND_near_plane_y-2)&15
        rotqbyi $far_z,$far_x,(MESH_BOUND_near_plane_z-2)&15
    .irp axis, x,y,z
        lqd     $near_scale_\axis,MESH_BOUND_near_scale_\axis($a_bound)
        lqd     $near_shift_\axis,MESH_BOUND_near_shift_\axis($a_bound)
        lqd     $far_scale_\axis,MESH_BOUND_far_scale_\axis($a_bound)
        lqd     $far_shift_\axis,MESH_BOUND_far_shift_\axis($a_bound)
        lqx     $near_time_\axis,$candidate,$near_\axis
        lqx     $far_time_\axis,$candidate,$far_\axis
        fma     $near_time_\axis,$near_time_\axis,$near_scale_\axis,$near_shift_\axis
        fma     $far_time_\axis,$far_time_\axis,$far_scale_\axis,$far_shift_\axis
        cgt     $both_\axis,$near_scale_\axis,$far_scale_\axis
        and     $entry_\axis,$far_time_\axis,$both_\axis
        selb    $far_time_\axis,$far_time_\axis,$farthest,$both_\axis
    .endr
        maximum $near_time_x,$near_time_y,$c_greater
        maximum $near_time_z,$entry_z,$c_greater
        maximum $entry_x,$entry_y,$c_greater
        maximum $near_time_x,$near_time_z,$c_greater
        maximum $entry_x,$k_zero,$c_greater
        maximum $near_time_x,$entry_x,$c_greater
        minimum_f4 $far_time_x,$far_time_y,$c_greater
        minimum_f4 $far_time_z,$farthest,$c_greater
        minimum_f4 $far_time_x,$far_time_z,$c_greater
        fcgt    $step,$near_time_x,$far_time_x
        andc    $step,$k_step,$step
    .irp child, 1,2,3
        rotqbyi $step+\child,$step,4*\child
    .endr
        lqd     $again,0($a_again)
        lqd     $child,BOXES_child($again)
        a       $child,$child,$base
    .irp child, 0,1,2,3
        shufb   $entry,$child,$near_time_x,$m_entry+\child
        shufb   $entry,$entry,$again,$m_between
        stqx    $entry,$3,$found
        a       $found,$found,$step+\child
    .endr
        ai      $a_candidate,$a_candidate,MESH_CANDIDATE_SIZE
        ai      $a_again,$a_again,MESH_CANDIDATE_SIZE
        ai      $count,$count,-1
        brnz    $count,next_boxes
        a       $3,$3,$found
        bi      $lr
endfunction cull_boxes
