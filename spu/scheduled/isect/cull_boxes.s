# cull_boxes   of nodes of a mesh, the children whose boxes some ray of a packet may meet
#   C       struct mesh_candidate *cull_boxes(const struct mesh_candidate *, int count,
#                                             struct mesh_candidate *, int base);
#   In      $3 candidates whose objects are BOXES, $4 count (0 is none), $5 where the list goes,
#           which may not be among the candidates, $6 what is added to each child's word; pointers
#           16-aligned
#   Out     candidates of such children, node by node, children in order: object is the child's
#           word plus $6, near is when a ray can meet its box, the rest the node's; three more
#           quadwords may be written
#           $3 behind the list
#   Uses    $2-$55, $57-$63, $79   Saves  -   Stack  0   Calls  -
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
# Scheduled by spu schedule from cull_boxes.s

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
        .set count_2,79; .set a_candidate_2,2; .set candidate_2,2; .set a_bound_2,5
        .set near_time_x_2,7; .set near_time_x_3,9; .set near_x_2,7; .set c_greater_2,8
        .set c_greater_3,21; .set near_time_x_4,22; .set c_greater_4,9; .set far_time_x_2,24
        .set far_time_y_2,8; .set far_time_z_2,2; .set c_greater_5,7; .set far_time_x_3,5
        .set entry_2,7; .set entry_3,21; .set entry_4,5; .set entry_5,8; .set found_2,25
        .set found_3,2; .set c_greater_6,5; .set near_time_x_5,5; .set again_2,2
        .set far_time_z_3,4; .set found_4,4; .set found_5,9; .set entry_6,10; .set entry_7,4
        .set found_6,10; .set entry_8,2; .set c_greater_7,2; .set found_7,8
        ori     $a_candidate,$a_first,0                 # 0e
        ori     $a_again,$a_first,0                     # 1e
        ori     $a_first,$a_list,0                      # 2e
        biz     $count,$lr                              # 2o
        ila     $c_greater,0x10203                      # 3e
        lqa     $m_between,packet_between               # 3o
        ilhu    $m_farthest,0xc0d                       # 4e
        lqa     $k_far_planes,far_planes                # 4o
        clgti   $count_2,$count,2                       # 5e at least as many passes as overlap
        lqa     $m_entry,child_and_near                 # 5o
        il      $found,0                                # 6e
        lqa     $m_entry+1,child_and_near+16            # 6o
        il      $k_zero,0                               # 7e
        lqa     $m_entry+2,child_and_near+32            # 7o
        il      $k_step,16                              # 8e
        lqa     $m_entry+3,child_and_near+48            # 8o
        iohl    $m_farthest,0xe0f                       # 9e
        shufb   $base,$base,$base,$c_greater            # 9o
        nop     $127                                    # 10e pairing
        brz     $count_2,next_boxes_short               # 10o too few passes
        ai      $a_candidate_2,$a_candidate,16          # 11e
        lqd     $candidate,0($a_candidate)              # 11o
        ai      $count,$count,-1                        # 12e
        lqd     $again,0($a_again)                      # 12o
        ai      $a_candidate,$a_candidate_2,16          # 13e
        lqd     $candidate_2,0($a_candidate_2)          # 13o
        ai      $count,$count,-1                        # 14e
        ai      $a_again,$a_again,16                    # 15e
        rotqbyi $a_bound,$candidate,8                   # 17o
        lqd     $child,96($again)                       # 18o
        rotqbyi $a_bound_2,$candidate_2,8               # 19o
        lqd     $near_x,192($a_bound)                   # 21o
        lqd     $far_shift_x,144($a_bound)              # 22o
        lqd     $far_scale_y,112($a_bound)              # 23o
        a       $child,$child,$base                     # 24e
        lqd     $far_shift_y,160($a_bound)              # 24o
        lqd     $far_scale_z,128($a_bound)              # 25o
        lqd     $far_scale_x,96($a_bound)               # 26o
        sf      $far_x,$near_x,$k_far_planes            # 27e
        rotqbyi $near_z,$near_x,4                       # 27o
        rotqbyi $near_y,$near_x,2                       # 28o
        rotqbyi $far_y,$far_x,2                         # 29o
        rotqbyi $far_z,$far_x,4                         # 30o
        lqd     $far_shift_z,176($a_bound)              # 31o
        lqx     $far_time_x,$candidate,$far_x           # 32o
        lqx     $far_time_y,$candidate,$far_y           # 33o
        lqx     $far_time_z,$candidate,$far_z           # 34o
        lqd     $near_scale_x,0($a_bound)               # 35o
        lqd     $near_shift_x,48($a_bound)              # 36o
        lqx     $near_time_x_2,$candidate,$near_x       # 37o
        fma     $far_time_x,$far_time_x,$far_scale_x,$far_shift_x # 38e
        lqd     $near_scale_y,16($a_bound)              # 38o
        fma     $far_time_y,$far_time_y,$far_scale_y,$far_shift_y # 39e
        lqd     $near_shift_y,64($a_bound)              # 39o
        fma     $far_time_z,$far_time_z,$far_scale_z,$far_shift_z # 40e
        lqx     $near_time_z,$candidate,$near_z         # 40o
        cgt     $both_x,$near_scale_x,$far_scale_x      # 41e
        lqd     $near_scale_z,32($a_bound)              # 41o
        nop     $127                                    # 42e pairing
        lqx     $near_time_y,$candidate,$near_y         # 42o
        fma     $near_time_x_3,$near_time_x_2,$near_scale_x,$near_shift_x # 43e
        lqd     $near_shift_z,80($a_bound)              # 43o
        cgt     $both_y,$near_scale_y,$far_scale_y      # 44e
        lqd     $near_x_2,192($a_bound_2)               # 44o
        and     $entry_x,$far_time_x,$both_x            # 45e
        shufb   $farthest,$near_x,$near_x,$m_farthest   # 45o
        and     $entry_y,$far_time_y,$both_y            # 46e
        lqd     $far_shift_x,144($a_bound_2)            # 46o
        cgt     $both_z,$near_scale_z,$far_scale_z      # 47e
        lqd     $far_scale_y,112($a_bound_2)            # 47o
        fma     $near_time_y,$near_time_y,$near_scale_y,$near_shift_y # 48e
        lqd     $far_scale_x,96($a_bound_2)             # 48o
        fma     $near_time_z,$near_time_z,$near_scale_z,$near_shift_z # 49e
        lqd     $far_shift_y,160($a_bound_2)            # 49o
        and     $entry_z,$far_time_z,$both_z            # 50e
        rotqbyi $near_y,$near_x_2,2                     # 50o
        fcgt    $c_greater_2,$entry_y,$entry_x          # 51e
        lqd     $far_scale_z,128($a_bound_2)            # 51o
        selb    $far_time_x,$far_time_x,$farthest,$both_x # 52e
        lqd     $far_shift_z,176($a_bound_2)            # 52o
        selb    $far_time_z,$far_time_z,$farthest,$both_z # 53e
        lqd     $near_scale_x,0($a_bound_2)             # 53o
        fcgt    $c_greater,$near_time_y,$near_time_x_3  # 54e
        lqd     $near_shift_x,48($a_bound_2)            # 54o
        fcgt    $c_greater_3,$entry_z,$near_time_z      # 55e
        lqx     $near_time_x_4,$candidate_2,$near_x_2   # 55o
        selb    $far_time_y,$far_time_y,$farthest,$both_y # 56e
        lqd     $near_scale_y,16($a_bound_2)            # 56o
        selb    $near_time_x,$near_time_x_3,$near_time_y,$c_greater # 57e
        lqd     $near_shift_y,64($a_bound_2)            # 57o
        selb    $near_time_z,$near_time_z,$entry_z,$c_greater_3 # 58e
        lqx     $near_time_y,$candidate_2,$near_y       # 58o
        selb    $entry_x,$entry_x,$entry_y,$c_greater_2 # 59e
        hbrr    next_boxes_back,next_boxes              # 59o hint
        sf      $far_x,$near_x_2,$k_far_planes          # 60e
        rotqbyi $near_z,$near_x_2,4                     # 60o
        fcgt    $c_greater,$near_time_z,$near_time_x    # 61e
        lqd     $near_scale_z,32($a_bound_2)            # 61o
        fcgt    $c_greater_2,$k_zero,$entry_x           # 62e
        rotqbyi $far_y,$far_x,2                         # 62o
        fcgt    $c_greater_4,$far_time_x,$far_time_y    # 63e
        rotqbyi $far_z,$far_x,4                         # 63o
        fcgt    $c_greater_3,$far_time_z,$farthest      # 64e
        lqx     $far_time_x_2,$candidate_2,$far_x       # 64o
        selb    $near_time_x,$near_time_x,$near_time_z,$c_greater # 65e
        lqx     $near_time_z,$candidate_2,$near_z       # 65o
        selb    $entry_x,$entry_x,$k_zero,$c_greater_2  # 66e
        lqx     $far_time_y_2,$candidate_2,$far_y       # 66o
        selb    $far_time_x,$far_time_x,$far_time_y,$c_greater_4 # 67e
        lqx     $far_time_z_2,$candidate_2,$far_z       # 67o
        selb    $far_time_z,$far_time_z,$farthest,$c_greater_3 # 68e
        lqd     $near_shift_z,80($a_bound_2)            # 68o
        fcgt    $c_greater,$entry_x,$near_time_x        # 69e
        shufb   $farthest,$near_x_2,$near_x_2,$m_farthest # 69o
        fcgt    $c_greater_5,$far_time_x,$far_time_z    # 70e
        selb    $near_time_x,$near_time_x,$entry_x,$c_greater # 71e
        selb    $far_time_x_3,$far_time_x,$far_time_z,$c_greater_5 # 72e
        lnop                                            # 72o pairing
        fma     $far_time_x,$far_time_x_2,$far_scale_x,$far_shift_x # 73e
        shufb   $entry_2,$child,$near_time_x,$m_entry+1 # 73o
        fcgt    $step,$near_time_x,$far_time_x_3        # 74e
        shufb   $entry_3,$child,$near_time_x,$m_entry   # 74o
        fma     $near_time_x_3,$near_time_x_4,$near_scale_x,$near_shift_x # 75e
        shufb   $entry,$child,$near_time_x,$m_entry+3   # 75o
        andc    $step,$k_step,$step                     # 76e
        shufb   $entry_4,$child,$near_time_x,$m_entry+2 # 76o
        fma     $far_time_y,$far_time_y_2,$far_scale_y,$far_shift_y # 77e
        shufb   $entry_2,$entry_2,$again,$m_between     # 77o
        fma     $far_time_z,$far_time_z_2,$far_scale_z,$far_shift_z # 78e
        shufb   $entry_5,$entry_3,$again,$m_between     # 78o
        fma     $near_time_y,$near_time_y,$near_scale_y,$near_shift_y # 79e
        rotqbyi $step+1,$step,4                         # 79o
        cgt     $both_x,$near_scale_x,$far_scale_x      # 80e
        cgt     $both_y,$near_scale_y,$far_scale_y      # 81e
        a       $found_2,$found,$step                   # 82e
        and     $entry_x,$far_time_x,$both_x            # 83e
next_boxes:
            cgt     $both_z,$near_scale_z,$far_scale_z  # 0e
            shufb   $entry,$entry,$again,$m_between     # 0o
            and     $entry_y,$far_time_y,$both_y        # 1e
        lqd     $candidate,0($a_candidate)              # 1o
            a       $found_3,$found_2,$step+1           # 2e
            shufb   $entry_4,$entry_4,$again,$m_between # 2o
            selb    $far_time_x,$far_time_x,$farthest,$both_x # 3e
            lqd     $again,0($a_again)                  # 3o
            fma     $near_time_z,$near_time_z,$near_scale_z,$near_shift_z # 4e
            rotqbyi $step+3,$step,12                    # 4o
            fcgt    $c_greater,$near_time_y,$near_time_x_3 # 5e
            rotqbyi $step+2,$step,8                     # 5o
            and     $entry_z,$far_time_z,$both_z        # 6e
            stqx    $entry_5,$a_first,$found            # 6o
            selb    $far_time_z,$far_time_z,$farthest,$both_z # 7e
        rotqbyi $a_bound,$candidate,8                   # 7o
            selb    $far_time_y,$far_time_y,$farthest,$both_y # 8e
            stqx    $entry_2,$a_first,$found_2          # 8o
            fcgt    $c_greater_5,$entry_y,$entry_x      # 9e
            lqd     $child,96($again)                   # 9o
            fcgt    $c_greater_2,$entry_z,$near_time_z  # 10e
            stqx    $entry_4,$a_first,$found_3          # 10o
            selb    $near_time_x,$near_time_x_3,$near_time_y,$c_greater # 11e
        lqd     $near_x,192($a_bound)                   # 11o
            selb    $near_time_z,$near_time_z,$entry_z,$c_greater_2 # 12e
        lqd     $far_shift_x,144($a_bound)              # 12o
            selb    $entry_x,$entry_x,$entry_y,$c_greater_5 # 13e
        lqd     $far_scale_y,112($a_bound)              # 13o
            fcgt    $c_greater,$near_time_z,$near_time_x # 14e
        lqd     $far_shift_y,160($a_bound)              # 14o
            a       $child,$child,$base                 # 15e
        lqd     $far_scale_z,128($a_bound)              # 15o
            fcgt    $c_greater_6,$k_zero,$entry_x       # 16e
        lqd     $far_scale_x,96($a_bound)               # 16o
            fcgt    $c_greater_5,$far_time_x,$far_time_y # 17e
        rotqbyi $near_z,$near_x,4                       # 17o
            fcgt    $c_greater_2,$far_time_z,$farthest  # 18e
        lqd     $far_shift_z,176($a_bound)              # 18o
            selb    $near_time_x,$near_time_x,$near_time_z,$c_greater # 19e
        lqd     $near_scale_x,0($a_bound)               # 19o
            selb    $entry_x,$entry_x,$k_zero,$c_greater_6 # 20e
        lqd     $near_shift_x,48($a_bound)              # 20o
            selb    $far_time_x,$far_time_x,$far_time_y,$c_greater_5 # 21e
        lqx     $near_time_x_5,$candidate,$near_x       # 21o
            selb    $far_time_z,$far_time_z,$farthest,$c_greater_2 # 22e
        lqd     $near_scale_y,16($a_bound)              # 22o
            fcgt    $c_greater,$entry_x,$near_time_x    # 23e
        lqd     $near_shift_y,64($a_bound)              # 23o
            fcgt    $c_greater_5,$far_time_x,$far_time_z # 24e
        lqx     $near_time_z,$candidate,$near_z         # 24o
        sf      $far_x,$near_x,$k_far_planes            # 25e
        rotqbyi $near_y,$near_x,2                       # 25o
            selb    $near_time_x,$near_time_x,$entry_x,$c_greater # 26e
        lqd     $near_scale_z,32($a_bound)              # 26o
            selb    $far_time_x,$far_time_x,$far_time_z,$c_greater_5 # 27e
        rotqbyi $far_y,$far_x,2                         # 27o
        cgt     $both_x,$near_scale_x,$far_scale_x      # 28e
            shufb   $entry_2,$child,$near_time_x,$m_entry+1 # 28o
            fcgt    $step,$near_time_x,$far_time_x      # 29e
            shufb   $entry_5,$child,$near_time_x,$m_entry # 29o
        fma     $near_time_x_3,$near_time_x_5,$near_scale_x,$near_shift_x # 30e
        lqx     $far_time_x,$candidate,$far_x           # 30o
            andc    $step,$k_step,$step                 # 31e
        rotqbyi $far_z,$far_x,4                         # 31o
        cgt     $both_y,$near_scale_y,$far_scale_y      # 32e
        lqx     $far_time_y,$candidate,$far_y           # 32o
        ai      $count,$count,-1                        # 33e
            shufb   $entry_5,$entry_5,$again,$m_between # 33o
        ai      $a_candidate,$a_candidate,16            # 34e
            shufb   $entry_2,$entry_2,$again,$m_between # 34o
            a       $found_3,$found_3,$step+2           # 35e
        lqx     $far_time_z,$candidate,$far_z           # 35o
        fma     $far_time_x,$far_time_x,$far_scale_x,$far_shift_x # 36e
        lqx     $near_time_y,$candidate,$near_y         # 36o
            a       $found,$found_3,$step+3             # 37e
            stqx    $entry,$a_first,$found_3            # 37o
        fma     $far_time_y,$far_time_y,$far_scale_y,$far_shift_y # 38e
        lqd     $near_shift_z,80($a_bound)              # 38o
            a       $found_2,$found,$step               # 39e
            shufb   $entry,$child,$near_time_x,$m_entry+3 # 39o
            ai      $a_again,$a_again,16                # 40e
        shufb   $farthest,$near_x,$near_x,$m_farthest   # 40o
        fma     $far_time_z,$far_time_z,$far_scale_z,$far_shift_z # 41e
            shufb   $entry_4,$child,$near_time_x,$m_entry+2 # 41o
        fma     $near_time_y,$near_time_y,$near_scale_y,$near_shift_y # 42e
            rotqbyi $step+1,$step,4                     # 42o
        and     $entry_x,$far_time_x,$both_x            # 43e
next_boxes_back:
        brnz    $count,next_boxes                       # 43o
next_boxes_drain:
        fma     $near_time_z,$near_time_z,$near_scale_z,$near_shift_z # 0e
        lqd     $again_2,0($a_again)                    # 0o
        cgt     $both_z,$near_scale_z,$far_scale_z      # 1e
        stqx    $entry_5,$a_first,$found                # 1o
        and     $entry_y,$far_time_y,$both_y            # 2e
        stqx    $entry_2,$a_first,$found_2              # 2o
        selb    $far_time_x,$far_time_x,$farthest,$both_x # 3e
        hbr     cull_boxes_return,$lr                   # 3o hint
        selb    $far_time_z_3,$far_time_z,$farthest,$both_z # 4e
        rotqbyi $step+2,$step,8                         # 4o
        fcgt    $c_greater,$near_time_y,$near_time_x_3  # 5e
        shufb   $entry,$entry,$again,$m_between         # 5o
        fcgt    $c_greater_2,$far_time_z_3,$farthest    # 6e
        lqd     $child,96($again_2)                     # 6o
        fcgt    $c_greater_5,$entry_y,$entry_x          # 7e
        rotqbyi $step+3,$step,12                        # 7o
        and     $entry_z,$far_time_z,$both_z            # 8e
        shufb   $entry_4,$entry_4,$again,$m_between     # 8o
        selb    $entry_x,$entry_x,$entry_y,$c_greater_5 # 9e
        fcgt    $c_greater_5,$entry_z,$near_time_z      # 10e
        selb    $near_time_x,$near_time_x_3,$near_time_y,$c_greater # 11e
        selb    $near_time_z,$near_time_z,$entry_z,$c_greater_5 # 12e
        selb    $far_time_y,$far_time_y,$farthest,$both_y # 13e
        fcgt    $c_greater_5,$k_zero,$entry_x           # 14e
        fcgt    $c_greater,$near_time_z,$near_time_x    # 15e
        selb    $entry_x,$entry_x,$k_zero,$c_greater_5  # 16e
        selb    $near_time_x,$near_time_x,$near_time_z,$c_greater # 17e
        fcgt    $c_greater_5,$far_time_x,$far_time_y    # 18e
        fcgt    $c_greater,$entry_x,$near_time_x        # 19e
        selb    $far_time_x,$far_time_x,$far_time_y,$c_greater_5 # 20e
        selb    $near_time_x,$near_time_x,$entry_x,$c_greater # 21e
        selb    $far_time_z,$far_time_z_3,$farthest,$c_greater_2 # 22e
        a       $child,$child,$base                     # 23e
        fcgt    $c_greater_5,$far_time_x,$far_time_z    # 24e
        a       $found_4,$found_2,$step+1               # 25e
        shufb   $entry_5,$child,$near_time_x,$m_entry   # 25o
        selb    $far_time_x,$far_time_x,$far_time_z,$c_greater_5 # 26e
        shufb   $entry_2,$child,$near_time_x,$m_entry+1 # 26o
        a       $found_5,$found_4,$step+2               # 27e
        shufb   $entry_6,$child,$near_time_x,$m_entry+2 # 27o
        fcgt    $step,$near_time_x,$far_time_x          # 28e
        stqx    $entry_4,$a_first,$found_4              # 28o
        a       $found,$found_5,$step+3                 # 29e
        shufb   $entry_5,$entry_5,$again_2,$m_between   # 29o
        andc    $step,$k_step,$step                     # 30e
        shufb   $entry_7,$child,$near_time_x,$m_entry+3 # 30o
        ai      $a_again,$a_again,16                    # 31e
        shufb   $entry_4,$entry_6,$again_2,$m_between   # 31o
        a       $found_2,$found,$step                   # 32e
        rotqbyi $step+1,$step,4                         # 32o
        rotqbyi $step+2,$step,8                         # 33o
        rotqbyi $step+3,$step,12                        # 34o
        nop     $127                                    # 35e pairing
        shufb   $entry_2,$entry_2,$again_2,$m_between   # 35o
        a       $found_6,$found_2,$step+1               # 36e
        shufb   $entry_8,$entry_7,$again_2,$m_between   # 36o
        nop     $127                                    # 37e pairing
        stqx    $entry,$a_first,$found_5                # 37o
        a       $found_4,$found_6,$step+2               # 38e
        stqx    $entry_5,$a_first,$found                # 38o
        nop     $127                                    # 39e pairing
        stqx    $entry_2,$a_first,$found_2              # 39o
        a       $found,$found_4,$step+3                 # 40e
        stqx    $entry_4,$a_first,$found_6              # 40o
        nop     $127                                    # 41e pairing
        stqx    $entry_8,$a_first,$found_4              # 41o
        a       $a_first,$a_first,$found                # 42e
cull_boxes_return:
        bi      $lr                                     # 42o
next_boxes_short:
        ai      $count,$count,-1                        # 0e
        lqd     $candidate,0($a_candidate)              # 0o
        ai      $a_candidate,$a_candidate,16            # 1e
        lqd     $again,0($a_again)                      # 1o
        ai      $a_again,$a_again,16                    # 2e
        rotqbyi $a_bound,$candidate,8                   # 6o
        lqd     $child,96($again)                       # 7o
        lqd     $near_x,192($a_bound)                   # 10o
        lqd     $far_scale_x,96($a_bound)               # 11o
        lqd     $far_shift_x,144($a_bound)              # 12o
        a       $child,$child,$base                     # 13e
        lqd     $far_scale_y,112($a_bound)              # 13o
        lqd     $far_shift_y,160($a_bound)              # 14o
        lqd     $far_scale_z,128($a_bound)              # 15o
        sf      $far_x,$near_x,$k_far_planes            # 16e
        rotqbyi $near_y,$near_x,2                       # 16o
        rotqbyi $near_z,$near_x,4                       # 17o
        rotqbyi $far_y,$far_x,2                         # 18o
        rotqbyi $far_z,$far_x,4                         # 19o
        lqx     $far_time_x,$candidate,$far_x           # 20o
        lqd     $far_shift_z,176($a_bound)              # 21o
        lqx     $far_time_y,$candidate,$far_y           # 22o
        lqx     $far_time_z,$candidate,$far_z           # 23o
        lqd     $near_scale_x,0($a_bound)               # 24o
        nop     $127                                    # 25e pairing
        lqd     $near_shift_x,48($a_bound)              # 25o
        fma     $far_time_x,$far_time_x,$far_scale_x,$far_shift_x # 26e
        lqx     $near_time_x,$candidate,$near_x         # 26o
        nop     $127                                    # 27e pairing
        lqd     $near_scale_y,16($a_bound)              # 27o
        fma     $far_time_y,$far_time_y,$far_scale_y,$far_shift_y # 28e
        lqd     $near_shift_y,64($a_bound)              # 28o
        fma     $far_time_z,$far_time_z,$far_scale_z,$far_shift_z # 29e
        lqx     $near_time_y,$candidate,$near_y         # 29o
        cgt     $both_x,$near_scale_x,$far_scale_x      # 30e
        lqd     $near_scale_z,32($a_bound)              # 30o
        nop     $127                                    # 31e pairing
        lqd     $near_shift_z,80($a_bound)              # 31o
        fma     $near_time_x,$near_time_x,$near_scale_x,$near_shift_x # 32e
        lqx     $near_time_z,$candidate,$near_z         # 32o
        cgt     $both_y,$near_scale_y,$far_scale_y      # 33e
        shufb   $farthest,$near_x,$near_x,$m_farthest   # 33o
        and     $entry_x,$far_time_x,$both_x            # 34e
        fma     $near_time_y,$near_time_y,$near_scale_y,$near_shift_y # 35e
        cgt     $both_z,$near_scale_z,$far_scale_z      # 36e
        and     $entry_y,$far_time_y,$both_y            # 37e
        fma     $near_time_z,$near_time_z,$near_scale_z,$near_shift_z # 38e
        and     $entry_z,$far_time_z,$both_z            # 39e
        fcgt    $c_greater,$entry_y,$entry_x            # 40e
        fcgt    $c_greater_7,$near_time_y,$near_time_x  # 41e
        selb    $far_time_x,$far_time_x,$farthest,$both_x # 42e
        selb    $far_time_y,$far_time_y,$farthest,$both_y # 43e
        fcgt    $c_greater_6,$entry_z,$near_time_z      # 44e
        selb    $far_time_z,$far_time_z,$farthest,$both_z # 45e
        selb    $near_time_x,$near_time_x,$near_time_y,$c_greater_7 # 46e
        selb    $near_time_z,$near_time_z,$entry_z,$c_greater_6 # 47e
        selb    $entry_x,$entry_x,$entry_y,$c_greater   # 48e
        fcgt    $c_greater,$near_time_z,$near_time_x    # 49e
        fcgt    $c_greater_7,$k_zero,$entry_x           # 50e
        fcgt    $c_greater_6,$far_time_x,$far_time_y    # 51e
        fcgt    $c_greater_5,$far_time_z,$farthest      # 52e
        selb    $near_time_x,$near_time_x,$near_time_z,$c_greater # 53e
        selb    $entry_x,$entry_x,$k_zero,$c_greater_7  # 54e
        selb    $far_time_x,$far_time_x,$far_time_y,$c_greater_6 # 55e
        selb    $far_time_z,$far_time_z,$farthest,$c_greater_5 # 56e
        fcgt    $c_greater,$entry_x,$near_time_x        # 57e
        fcgt    $c_greater_7,$far_time_x,$far_time_z    # 58e
        selb    $near_time_x,$near_time_x,$entry_x,$c_greater # 59e
        selb    $far_time_x,$far_time_x,$far_time_z,$c_greater_7 # 60e
        shufb   $entry,$child,$near_time_x,$m_entry     # 61o
        fcgt    $step,$near_time_x,$far_time_x          # 62e
        shufb   $entry_8,$child,$near_time_x,$m_entry+1 # 62o
        nop     $127                                    # 63e pairing
        shufb   $entry_4,$child,$near_time_x,$m_entry+2 # 63o
        andc    $step,$k_step,$step                     # 64e
        shufb   $entry_2,$child,$near_time_x,$m_entry+3 # 64o
        nop     $127                                    # 65e pairing
        shufb   $entry,$entry,$again,$m_between         # 65o
        a       $found_7,$found,$step                   # 66e
        rotqbyi $step+1,$step,4                         # 66o
        rotqbyi $step+2,$step,8                         # 67o
        shufb   $entry_8,$entry_8,$again,$m_between     # 68o
        nop     $127                                    # 69e pairing
        shufb   $entry_4,$entry_4,$again,$m_between     # 69o
        a       $found_5,$found_7,$step+1               # 70e
        shufb   $entry_2,$entry_2,$again,$m_between     # 70o
        nop     $127                                    # 71e pairing
        stqx    $entry,$a_first,$found                  # 71o
        a       $found,$found_5,$step+2                 # 72e
        rotqbyi $step+3,$step,12                        # 72o
        stqx    $entry_8,$a_first,$found_7              # 73o
        stqx    $entry_4,$a_first,$found_5              # 74o
        nop     $127                                    # 75e pairing
        stqx    $entry_2,$a_first,$found                # 75o
        a       $found,$found,$step+3                   # 76e
        brnz    $count,next_boxes_short                 # 76o
        a       $a_first,$a_first,$found                # 78e
        bi      $lr                                     # 78o
endfunction cull_boxes
