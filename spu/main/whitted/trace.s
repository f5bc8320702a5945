# Finds the hits of packets of rays. For each kind of primitive, the tree is traversed level by
# level with all packets together, and then the primitives are tested.

        .include "work_unit.inc"
        .include "macros.inc"
        .include "driver.inc"
        .include "whitted.inc"

        .set    NODE_LIST_BYTES,(MAX_NODES+LIST_MARGIN)*CANDIDATE_SIZE

# The plan for traversing a tree, made once a frame for every tree that isn't empty.
        .set    PLAN_candidates,0                       # the tree's top with BATCH_RAYS' packets
        .set    PLAN_at_once,4                          # packets whose candidates fit the lists
        .set    PLAN_levels,8
        .set    PLAN_test,12                            # the address of the kernel
        .set    PLAN_roots,16                           # how many nodes or objects are at the top
        .set    PLAN_objects,20
        .set    PLAN_flat,24                            # whether its objects are flat
        .set    PLAN_eye_test,28                        # the kernel for primary rays
        .set    PLAN_SIZE,32
# After these come the candidates with the packets of SHADOW_RAYS.
        .set    SHADOW_CANDIDATES,MAX_BATCH*MAX_ROOTS*CANDIDATE_SIZE

        .section .bss
        .align  4
plans:  .skip   TREES*PLAN_SIZE
plans_end:                              # the address after the last plan
        .skip   16
sheared:                                # objects that need their packets' shears
        .skip   16
next_list:
        .skip   16
fan:                                    # whether all rays go through one point
        .skip   16
of_eye:                                 # whether the rays are primary rays
        .skip   16
along:                                  # the input of cull_faces
        .skip   16
any_deep:                               # whether scattered shadow rays are worth a test themselves
        .skip   16
scattered:                              # whether the rays go every way
        .skip   16
filtered:                               # whether this tree's children are tested with the rays
        .skip   16

        .section .rodata
        .align  4
packet_step:
        .int    0,RAYS16_SIZE,BOUND_SIZE,SHEARS_SIZE
first_candidate:
        .int    0,arena+BATCH_RAYS,arena+BATCH_BOUNDS,arena+BATCH_SHEARS
first_shadow:
        .int    0,arena+SHADOW_RAYS,arena+BATCH_BOUNDS,arena+BATCH_SHEARS
eye:    .skip   LIGHT_SIZE                              # a LIGHT there
# For each tree: the test, the size of an object, whether it is flat, the test for primary rays.
kernels:
        .int    isect_bounced_spheres,OBJECT_SIZE,0,isect_seen_spheres
        .int    isect_rectangle_pairs_r16,RECT_SIZE,1,isect_rectangle_pairs_r16
        .int    isect_triangles,TRI_SIZE,1,isect_triangles
        .int    isect_cone_pairs_r16,CONE_SIZE,0,isect_cone_pairs_r16

# bvhs_plan   makes the plans for the frame's trees
#   Uses    $10-$38
        .set    a_tree,10
        .set    a_plan,11
        .set    a_kernel,12
        .set    bvhs_left,13
        .set    tree,14
        .set    objects,15
        .set    at_once,16
        .set    room,17
        .set    c_room,18
        .set    test,19
        .set    levels,20
        .set    roots,21
        .set    root_step,22
        .set    t_quad,23
        .set    t_mask,24
        .set    most,25
        .set    a_list,26
        .set    a_out,27
        .set    packet,28
        .set    packets_left,29
        .set    root,30
        .set    roots_left,31
        .set    step,32
        .set    m_first,33

# Lists the top of the current tree with MAX_BATCH packets, from one of the templates on.
.macro  list_candidates template:req
        lqa     $packet,\template
        shufb   $packet,$tree,$packet,$m_first
        il      $packets_left,MAX_BATCH
packet_\@:
        ori     $root,$packet,0
        ori     $roots_left,$roots,0
root_\@:
        stqd    $root,0($a_out)
        ai      $a_out,$a_out,CANDIDATE_SIZE
        a       $root,$root,$root_step
        ai      $roots_left,$roots_left,-1
        brnz    $roots_left,root_\@
        a       $packet,$packet,$step
        ai      $packets_left,$packets_left,-1
        brnz    $packets_left,packet_\@
.endm

function bvhs_plan
        ila     $a_tree,frame
        ai      $a_tree,$a_tree,FRAME_trees
        lqd     $tree,BVH_SIZE*BVH_TRIANGLES($a_tree)
        rotqbyi $tree,$tree,BVH_objects
        lqa     $objects,streamed
        or      $tree,$tree,$objects
        stqa    $tree,sheared
        ila     $a_plan,plans
        ila     $a_kernel,kernels
        ila     $a_list,arena+ROOT_LISTS
        il      $bvhs_left,TREES
        il      $room,0
        stqa    $room,any_deep
        rotmi   $most,$w_most,-4
        cwd     $m_first,0($sp)
        lqa     $step,packet_step
next_plan:
        lqd     $tree,0($a_tree)
        rotqbyi $objects,$tree,BVH_objects
        brz     $objects,not_there
        # As many packets at once as always have room for their candidates; one packet always has.
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
        rotqbyi $levels,$tree,BVH_levels
        cgti    $c_room,$levels,DEEP-1
        ila     $room,isect_rectangle_pairs_r16
        ceq     $room,$room,$test
        andc    $c_room,$c_room,$room
        lqa     $room,any_deep
        or      $room,$room,$c_room
        stqa    $room,any_deep
        rotqbyi $root_step,$test,4
        ceqi    $c_room,$levels,0
        il      $room,NODE_SIZE
        selb    $root_step,$room,$root_step,$c_room
        fsmbi   $room,0xf000
        and     $root_step,$root_step,$room
        rotqbyi $roots,$tree,BVH_root_count
        store_word $a_list,PLAN_candidates,$a_plan,$t_quad,$t_mask
        store_word $at_once,PLAN_at_once,$a_plan,$t_quad,$t_mask
        store_word $levels,PLAN_levels,$a_plan,$t_quad,$t_mask
        store_word $test,PLAN_test,$a_plan,$t_quad,$t_mask
        store_word $roots,PLAN_roots,$a_plan,$t_quad,$t_mask
        store_word $objects,PLAN_objects,$a_plan,$t_quad,$t_mask
        rotqbyi $test,$test,8
        store_word $test,PLAN_flat,$a_plan,$t_quad,$t_mask
        rotqbyi $test,$test,4
        store_word $test,PLAN_eye_test,$a_plan,$t_quad,$t_mask
        ori     $a_out,$a_list,0
        list_candidates first_candidate
        il      $room,SHADOW_CANDIDATES
        a       $a_out,$a_list,$room
        list_candidates first_shadow
        shli    $room,$room,1
        a       $a_list,$a_list,$room
        ai      $a_plan,$a_plan,PLAN_SIZE
not_there:
        ai      $a_tree,$a_tree,BVH_SIZE
        ai      $a_kernel,$a_kernel,16
        ai      $bvhs_left,$bvhs_left,-1
        brnz    $bvhs_left,next_plan
        stqa    $a_plan,plans_end
        bi      $lr
endfunction bvhs_plan

        .set    amount,10
        .set    t_sum,11
        .set    t_add,12
        .set    t_carry,13
        .set    c_more,14
        .set    plan,15
        .set    sizes,16
        .set    counts,17
        .set    cull,18
        .set    c_filtered,19

# The depth from which on rays are scattered: eye rays are not, but what curved surfaces send on is.
        .set    SCATTERED_DEPTH,2
# The levels of a tree from which on it pays to test scattered shadow rays themselves, unless its
# objects are parallelograms, which are as quickly tested.
        .set    DEEP,3

# packets_trace   finds the nearest hits of packets
#   In      $3 BATCH_RAYS or SHADOW_RAYS, $4 how many packets of these, at least 1, $5 through what
#           they all go: -1 is nothing, 0 the eye, from where they come, else the LIGHT to which
#           they go
#   Uses    $3-$79, w_packets, w_traced, w_plan, w_first, w_here, w_left
#
# The cones of scattered rays let through nearly everything. So the children of nodes that pass are
# tested with the rays themselves, if the tree has enough levels for that to pay.
#
# Calls are hinted, because with so few packets for each call, mispredictions would matter.
function packets_trace
        hbrr    bound_call,bound_fan_r16
        enter
        ori     $w_packets,$3,0
        ori     $w_traced,$4,0
        lqa     $t_sum,any_deep
        ila     $counts,arena+BATCH_RAYS
        cgti    $amount,$w_depth,SCATTERED_DEPTH-1
        ceq     $counts,$counts,$3
        or      $t_sum,$t_sum,$counts
        and     $amount,$amount,$t_sum
        stqa    $amount,scattered
        or      $5,$5,$amount
        ori     $6,$5,0
        ilhu    $7,0x3f80
        cgti    $counts,$6,0
        ilhu    $amount,0x8000
        and     $amount,$amount,$counts
        or      $7,$7,$amount                           # -1 if to a light
        stqa    $7,along
        ila     $amount,eye
        selb    $6,$amount,$6,$counts
        cgti    $counts,$5,-1
        stqa    $counts,fan
        ceqi    $counts,$5,0
        stqa    $counts,of_eye
        ila     $5,arena+BATCH_BOUNDS
        # The distance of these packets' lists from those for BATCH_RAYS.
        ila     $w_packets,arena+BATCH_RAYS
        ceq     $w_packets,$w_packets,$3
        il      $w_left,SHADOW_CANDIDATES
        andc    $w_packets,$w_left,$w_packets
        ila     $w_plan,plans
bound_call:
        brsl    $lr,bound_fan_r16
        lqa     $counts,fan
        brz     $counts,from_all_over
spheres: brz     $g_skip,open
bounded:
        lqa     $c_more,sheared
        brnz    $c_more,shear
next_tree:
        lqa     $c_more,plans_end
        ceq     $c_more,$c_more,$w_plan
        brnz    $c_more,traced
        il      $w_first,0
next_packets:
        hbrr    cull_call,cull_nodes
        lqd     $plan,0($w_plan)
        lqd     $sizes,PLAN_roots($w_plan)
        lqa     $c_filtered,scattered
        sf      $w_here,$w_first,$w_traced
        ila     $cull,isect_rectangle_pairs_r16
        ceqi    $t_sum,$w_packets,0
        rotqbyi $amount,$plan,PLAN_at_once
        rotqbyi $w_left,$plan,PLAN_levels
        rotqbyi $t_add,$plan,PLAN_test
        minimum $w_here,$w_here,$amount,$c_more
        cgti    $t_carry,$w_left,DEEP-1
        ceq     $t_add,$t_add,$cull
        mpyu    $4,$sizes,$w_here                       # candidates
        mpyu    $3,$sizes,$w_first
        andc    $t_carry,$t_carry,$t_add
        or      $t_carry,$t_carry,$t_sum
        cgti    $t_sum,$w_left,1
        and     $c_filtered,$c_filtered,$t_carry
        and     $c_filtered,$c_filtered,$t_sum
        ila     $5,arena+OBJECT_LIST
        shli    $3,$3,CANDIDATE_SIZE_LOG2
        andi    $6,$c_filtered,4
        stqa    $c_filtered,filtered
        a       $3,$3,$plan
        a       $3,$3,$w_packets
        brz     $w_left,found
        count   cull_tests,$4,$t_sum,$t_add,$t_carry
        cgti    $c_more,$w_left,1
        brnz    $c_more,high_level
cull_call:
        brsl    $lr,cull_nodes
        lqa     $c_filtered,filtered
        ila     $5,arena+OBJECT_LIST
        sf      $4,$5,$3
        ori     $3,$5,0
        rotmi   $4,$4,-CANDIDATE_SIZE_LOG2
        brnz    $c_filtered,filter
found:
        # From here on the candidates are objects.
        lqd     $sizes,PLAN_roots($w_plan)
        rotqbyi $plan,$sizes,PLAN_flat-PLAN_roots
        brnz    $plan,flat
seen:   lqd     $plan,0($w_plan)
        lqd     $sizes,PLAN_roots($w_plan)
        lqa     $counts,of_eye
        rotqbyi $plan,$plan,PLAN_test
        rotqbyi $amount,$sizes,PLAN_eye_test-PLAN_roots
        selb    $plan,$plan,$amount,$counts
        hbr     test_call,$plan
        phase_ends $g_ticks_cull,$amount
        count   tests_made,$4,$t_sum,$t_add,$t_carry
        rotqbyi $counts,$sizes,PLAN_objects-PLAN_roots
        mpyu    $counts,$counts,$w_here
        count   tests_possible,$counts,$t_sum,$t_add,$t_carry
test_call:
        bisl    $lr,$plan
        phase_ends $g_ticks_isect,$amount
        a       $w_first,$w_first,$w_here
        cgt     $c_more,$w_traced,$w_first
        brnz    $c_more,next_packets
        ai      $w_plan,$w_plan,PLAN_SIZE
        br      next_tree

high_level:
        # Candidates of nodes above other nodes go from one list to the other.
        ila     $5,arena+NODE_LISTS
        ila     $t_sum,arena+NODE_LISTS+NODE_LIST_BYTES
        ceq     $t_add,$5,$3
        selb    $5,$5,$t_sum,$t_add
        stqa    $5,next_list
        lqa     $c_filtered,filtered
        andi    $6,$c_filtered,4
        brsl    $lr,cull_nodes
        lqa     $5,next_list
        sf      $4,$5,$3
        ori     $3,$5,0
        rotmi   $4,$4,-CANDIDATE_SIZE_LOG2
        lqa     $c_filtered,filtered
        brnz    $c_filtered,high_filter
high_found:
        ai      $w_left,$w_left,-1
        count   cull_tests,$4,$t_sum,$t_add,$t_carry
        ila     $5,arena+OBJECT_LIST
        cgti    $c_more,$w_left,1
        brnz    $c_more,high_level
        lqa     $c_filtered,filtered
        andi    $6,$c_filtered,4
        br      cull_call

high_filter:
        brsl    $lr,filter_children_r16
        lqa     $5,next_list
        sf      $4,$5,$3
        ori     $3,$5,0
        rotmi   $4,$4,-CANDIDATE_SIZE_LOG2
        br      high_found

filter: brsl    $lr,filter_children_r16
        ila     $5,arena+OBJECT_LIST
        sf      $4,$5,$3
        ori     $3,$5,0
        rotmi   $4,$4,-CANDIDATE_SIZE_LOG2
        br      found

flat:   hbrr    faces_call,cull_faces
        count   cull_tests,$4,$t_sum,$t_add,$t_carry
        ila     $5,arena+OBJECT_LIST
        lqa     $6,along
faces_call:
        brsl    $lr,cull_faces
        hbrr    faces_done,seen
        ila     $5,arena+OBJECT_LIST
        sf      $4,$5,$3
        ori     $3,$5,0
        rotmi   $4,$4,-CANDIDATE_SIZE_LOG2
faces_done:
        br      seen

from_all_over:
        ila     $3,arena+BATCH_RAYS
        ila     $4,arena+SHADOW_RAYS
        ceqi    $5,$w_packets,0
        selb    $3,$4,$3,$5
        ori     $4,$w_traced,0
        ila     $5,arena+BATCH_BOUNDS
        brsl    $lr,bound_origins_r16
        br      spheres
open:   brsl    $lr,bounds_open
        il      $cull,0
        stqa    $cull,scattered
        br      bounded
shear:  ila     $3,arena+BATCH_RAYS
        ila     $4,arena+SHADOW_RAYS
        ceqi    $5,$w_packets,0
        selb    $3,$4,$3,$5
        ori     $4,$w_traced,0
        ila     $5,arena+BATCH_SHEARS
        brsl    $lr,shear_packets_r16
        br      next_tree
traced: lqa     $c_more,streamed
        brnz    $c_more,in_mesh
        leave
in_mesh:
        brsl    $lr,mesh_trace
        leave
endfunction packets_trace

# bounds_open   makes bounds that contain everything, so that every ray is tested with every object
#   Uses    $10-$13
        .set    a_bound,10
        .set    zero,11
        .set    largest,12
        .set    bounds_left,13

function bounds_open
        ila     $a_bound,arena+BATCH_BOUNDS
        il      $zero,0
        ilhu    $largest,0x5e00                         # 2^61: above every distance
        ori     $bounds_left,$w_traced,0
next_bound:
    .irp field, axis_x,axis_y,axis_z,cosine,sine
        stqd    $zero,BOUND_\field($a_bound)
    .endr
    .irp field, axis,apex
        stqd    $zero,BOUND_\field($a_bound)
    .endr
    .irp field, radius,farthest,limits
        stqd    $largest,BOUND_\field($a_bound)
    .endr
        ai      $a_bound,$a_bound,BOUND_SIZE
        ai      $bounds_left,$bounds_left,-1
        brnz    $bounds_left,next_bound
        bi      $lr
endfunction bounds_open
