# What packets of rays hit: for each shape its tree is gone down level by level with all packets
# together, then the objects are tested.

        .include "work_unit.inc"
        .include "macros.inc"
        .include "driver.inc"
        .include "whitted.inc"

        .set    NODE_LIST_BYTES,(MAX_NODES+LIST_MARGIN)*CANDIDATE_SIZE

# How a tree is gone through: worked out once a frame, for trees that hold anything.
        .set    PLAN_roots,0                            # address of the first
        .set    PLAN_at_once,4                          # packets whose candidates have room
        .set    PLAN_levels,8
        .set    PLAN_test,12                            # address of the kernel
        .set    PLAN_root_bytes,16                      # of a packet's candidates
        .set    PLAN_objects,20
        .set    PLAN_step,24                            # bytes from root to root
        .set    PLAN_SIZE,32

        .section .bss
        .align  4
plans:  .skip   TREES*PLAN_SIZE
plans_end:                              # address behind the last
        .skip   16
sheared:                                # objects that want their packets' shears
        .skip   16
next_list:
        .skip   16

        .section .rodata
        .align  4
candidate_step:
        .int    0,RAYS16_SIZE,BOUND_SIZE,SHEARS_SIZE
first_candidate:
        .int    0,0,arena+BATCH_BOUNDS,arena+BATCH_SHEARS
kernels:                                # by tree: the test, the size of an object
        .int    isect_ball_pairs_r16,OBJECT_SIZE,0,0
        .int    isect_rectangle_pairs_r16,RECT_SIZE,0,0
        .int    isect_triangle_pairs_r16,TRI_SIZE,0,0
        .int    isect_cone_pairs_r16,CONE_SIZE,0,0

# trees_plan   makes the plans of the frame's trees
#   Uses    $10-$29
        .set    a_tree,10
        .set    a_plan,11
        .set    a_kernel,12
        .set    left,13
        .set    tree,14
        .set    objects,15
        .set    at_once,16
        .set    room,17
        .set    c_room,18
        .set    test,19
        .set    levels,20
        .set    roots,21
        .set    step,22
        .set    t_quad,23
        .set    t_mask,24
        .set    most,25

function trees_plan
        ila     $a_tree,frame
        ai      $a_tree,$a_tree,FRAME_trees
        lqd     $tree,TREE_SIZE*TREE_TRIANGLES($a_tree)
        rotqbyi $tree,$tree,TREE_objects
        stqa    $tree,sheared
        ila     $a_plan,plans
        ila     $a_kernel,kernels
        il      $left,TREES
        rotmi   $most,$w_most,-4
next_plan:
        lqd     $tree,0($a_tree)
        rotqbyi $objects,$tree,TREE_objects
        brz     $objects,not_there
        # So many packets at once that their candidates have room whatever is seen: one has.
        il      $at_once,1
        ori     $room,$objects,0
another:
        a       $room,$room,$objects
        il      $c_room,MAX_CANDIDATES
        cgt     $c_room,$room,$c_room
        brnz    $c_room,as_many
        ceq     $c_room,$at_once,$most
        brnz    $c_room,as_many
        ai      $at_once,$at_once,1
        br      another
as_many:
        lqd     $test,0($a_kernel)
        rotqbyi $levels,$tree,TREE_levels
        rotqbyi $step,$test,4
        ceqi    $c_room,$levels,0
        il      $room,NODE_SIZE
        selb    $step,$room,$step,$c_room
        rotqbyi $roots,$tree,TREE_root_count
        shli    $roots,$roots,CANDIDATE_SIZE_LOG2
        store_word $tree,PLAN_roots,$a_plan,$t_quad,$t_mask
        store_word $at_once,PLAN_at_once,$a_plan,$t_quad,$t_mask
        store_word $levels,PLAN_levels,$a_plan,$t_quad,$t_mask
        store_word $test,PLAN_test,$a_plan,$t_quad,$t_mask
        store_word $roots,PLAN_root_bytes,$a_plan,$t_quad,$t_mask
        store_word $objects,PLAN_objects,$a_plan,$t_quad,$t_mask
        store_word $step,PLAN_step,$a_plan,$t_quad,$t_mask
        ai      $a_plan,$a_plan,PLAN_SIZE
not_there:
        ai      $a_tree,$a_tree,TREE_SIZE
        ai      $a_kernel,$a_kernel,16
        ai      $left,$left,-1
        brnz    $left,next_plan
        stqa    $a_plan,plans_end
        bi      $lr
endfunction trees_plan

        .set    amount,10
        .set    t_sum,11
        .set    t_add,12
        .set    t_carry,13
        .set    c_more,14
        .set    plan,15
        .set    counts,16

# packets_trace   finds the nearest hits of packets
#   In      $3 packets (RAYS16, one after the other), $4 count, at least 1
#   Uses    $3-$79, w_packets, w_traced, w_plan, w_first, w_here, w_left
function packets_trace
        enter
        ori     $w_packets,$3,0
        ori     $w_traced,$4,0
        ila     $5,arena+BATCH_BOUNDS
        brsl    $lr,bound_r16
        brnz    $g_skip,bounded
        brsl    $lr,bounds_open
bounded:
        lqa     $c_more,sheared
        brz     $c_more,unsheared
        ori     $3,$w_packets,0
        ori     $4,$w_traced,0
        ila     $5,arena+BATCH_SHEARS
        brsl    $lr,shear_packets_r16
unsheared:
        ila     $w_plan,plans
next_tree:
        lqa     $c_more,plans_end
        ceq     $c_more,$c_more,$w_plan
        brnz    $c_more,traced
        il      $w_first,0
next_packets:
        lqd     $plan,0($w_plan)
        sf      $w_here,$w_first,$w_traced
        rotqbyi $amount,$plan,PLAN_at_once
        minimum $w_here,$w_here,$amount,$c_more
        brsl    $lr,tree_candidates
        brz     $w_left,found
next_level:
        sf      $4,$3,$5
        rotmi   $4,$4,-CANDIDATE_SIZE_LOG2
        count   cull_tests,$4,$t_sum,$t_add,$t_carry
        ai      $w_left,$w_left,-1
        ila     $5,arena+OBJECT_LIST
        brz     $w_left,last_level
        # The other of the two lists.
        ila     $5,arena+NODE_LISTS
        ila     $t_sum,arena+NODE_LISTS+NODE_LIST_BYTES
        ceq     $t_add,$5,$3
        selb    $5,$5,$t_sum,$t_add
        stqa    $5,next_list
        brsl    $lr,cull_nodes
        ori     $5,$3,0
        lqa     $3,next_list
        br      next_level
last_level:
        brsl    $lr,cull_nodes
        ori     $5,$3,0
        ila     $3,arena+OBJECT_LIST
found:
        # Candidates are objects now.
        phase_ends $g_ticks_cull,$amount
        sf      $4,$3,$5
        rotmi   $4,$4,-CANDIDATE_SIZE_LOG2
        count   tests_made,$4,$t_sum,$t_add,$t_carry
        lqd     $counts,16($w_plan)
        rotqbyi $counts,$counts,PLAN_objects-16
        mpyu    $counts,$counts,$w_here
        count   tests_possible,$counts,$t_sum,$t_add,$t_carry
        lqd     $plan,0($w_plan)
        rotqbyi $plan,$plan,PLAN_test
        bisl    $lr,$plan
        phase_ends $g_ticks_isect,$amount
        a       $w_first,$w_first,$w_here
        cgt     $c_more,$w_traced,$w_first
        brnz    $c_more,next_packets
        ai      $w_plan,$w_plan,PLAN_SIZE
        br      next_tree
traced:
        leave
endfunction packets_trace

# tree_candidates   what is at the top of the tree at hand, with each of the packets
#   In      w_plan, w_first, w_here
#   Out     $3 the list, $5 its end; w_left levels
#   Uses    $3, $5, $10-$37
#
# For every packet as many are written as a tree may have at the top, and the next packet's over those
# that it has not.
        .set    a_list,3
        .set    a_out,5
        .set    candidate,12
        .set    sizes,13
        .set    packets_left,14                         # 15 is the plan
        .set    root_bytes,16
        .set    packet_step,17
        .set    c_direct,18
        .set    node_step,19
        .set    steps,20                                # to 27: to the roots
        .set    nodes,28                                # to 35
        .set    m_word,36

function tree_candidates
        lqd     $plan,0($w_plan)
        lqd     $sizes,16($w_plan)
        cwd     $m_word,0($sp)
        ila     $a_list,arena+NODE_LISTS
        ila     $a_out,arena+OBJECT_LIST
        rotqbyi $w_left,$plan,PLAN_levels
        ceqi    $c_direct,$w_left,0
        selb    $a_list,$a_list,$a_out,$c_direct
        ori     $a_out,$a_list,0
        ori     $root_bytes,$sizes,0
        fsmbi   $node_step,0xf000
        rotqbyi $steps+1,$sizes,PLAN_step-16
        and     $steps+1,$steps+1,$node_step
        il      $steps,0
    .irp root, 2,3,4,5,6,7
        a       $steps+\root,$steps+\root-1,$steps+1
    .endr
        # The first packet's: root, packet, bound, shear.
        lqa     $packet_step,candidate_step
        lqa     $candidate,first_candidate
        shufb   $candidate,$plan,$candidate,$m_word
        cwd     $m_word,4($sp)
        shufb   $candidate,$w_packets,$candidate,$m_word
        ori     $packets_left,$w_first,0
        brz     $w_first,first_there
skip_packet:
        a       $candidate,$candidate,$packet_step
        ai      $packets_left,$packets_left,-1
        brnz    $packets_left,skip_packet
first_there:
        ori     $packets_left,$w_here,0
next_packet:
        hbrr    last_packet,next_packet
    .irp root, 0,1,2,3,4,5,6,7
        a       $nodes+\root,$candidate,$steps+\root
    .endr
        ai      $packets_left,$packets_left,-1
    .irp root, 0,1,2,3,4,5,6,7
        stqd    $nodes+\root,16*\root($a_out)
    .endr
        a       $a_out,$a_out,$root_bytes
        a       $candidate,$candidate,$packet_step
last_packet:
        brnz    $packets_left,next_packet
        bi      $lr
endfunction tree_candidates

# bounds_open   bounds that hold everything, so that every ray is tested with every object
#   Uses    $10-$13
        .set    a_bound,10
        .set    zero,11
        .set    largest,12
        .set    bounds_left,13

function bounds_open
        ila     $a_bound,arena+BATCH_BOUNDS
        il      $zero,0
        ilhu    $largest,0x7e00
        ori     $bounds_left,$w_traced,0
next_bound:
    .irp field, axis_x,axis_y,axis_z,cosine,sine
        stqd    $zero,BOUND_\field($a_bound)
    .endr
    .irp field, radius,farthest
        stqd    $largest,BOUND_\field($a_bound)
    .endr
        ai      $a_bound,$a_bound,BOUND_SIZE
        ai      $bounds_left,$bounds_left,-1
        brnz    $bounds_left,next_bound
        bi      $lr
endfunction bounds_open
