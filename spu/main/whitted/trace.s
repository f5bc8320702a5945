# Finds the hits of packets of rays. For each kind of primitive, the tree is traversed level by
# level with all packets together, and then the primitives are tested. Where enough nodes pass that
# the lists might overflow, the tree is traversed again by as many packets as always fit.

        .include "work_unit.inc"
        .include "macros.inc"
        .include "driver.inc"
        .include "whitted.inc"

        # The lists of a tree's levels: the lowest level's is in OBJECT_LIST, the next one's in
        # NODE_LISTS, and so on in turn. The children of this many nodes always fit there.
        .set    NODE_LIST_NODES,(2*MAX_NODES+LIST_MARGIN)/4

# The plan for traversing a tree, made once a frame for every tree that isn't empty.
        .set    PLAN_candidates,0                       # the tree's top with BATCH_RAYS' packets
        .set    PLAN_at_once,4                          # packets whose candidates always fit
        .set    PLAN_levels,8
        .set    PLAN_test,12                            # the address of the kernel
        .set    PLAN_roots,16                           # how many nodes or objects are at the top
        .set    PLAN_objects,20
        .set    PLAN_flat,24                            # whether its objects are flat
        .set    PLAN_eye_test,28                        # the kernel for primary rays
        # cull_nodes' argument `lanes`: of scattered rays from surfaces, then of those to a light
        .set    PLAN_bounced,32
        .set    PLAN_shadow,36
        .set    PLAN_cull,48                            # the kernel for nodes and packets' bounds
        .set    PLAN_filter,52                          # the one for their children and the rays
        .set    PLAN_SIZE,64

        .section .bss
        .align  4
plans:  .skip   TREES*PLAN_SIZE
plans_end:                              # the address after the last plan
        .skip   16
sheared:                                # objects that need their packets' shears
        .skip   16
        .global of_eye
of_eye:                                 # whether the rays are primary rays
        .skip   16
along:                                  # the input of cull_faces
        .skip   16
any_deep:                               # whether scattered shadow rays are worth a test themselves
        .skip   16
lanes:                                  # the bytes that turn PLAN_bounced to these rays' argument
        .skip   16
level_list:                             # where the level's list is
        .skip   16
to_shear:                               # whether the packets' shears are still to be made
        .skip   16
held:   .skip   16                      # the count of candidates meanwhile
most_here:                              # how many packets may traverse the tree at once
        .skip   16
first_here:                             # the first packet that traverses it
        .skip   16
        .global generation
generation:                             # the address of these rays' counters
        .skip   16
rays_traced:
        .skip   16
        # The call's counts, until they are added up.
    .irp name, cull_tests,tests_made,tests_possible,blocks_used,blocks_fetched,ticks_block_wait
        .global \name
\name: .skip   16
    .endr

        .section .rodata
        .align  4
packet_step:
        .int    0,RAYS16_SIZE,BOUND_SIZE,SHEARS_SIZE
candidate_words:                        # of a packet's rays in the first, bounds and shears
        .int    0x80808080,0x00010203,0x10111213,0x80808080
shears_word:
        .int    0x00010203,0x04050607,0x08090a0b,0x10111213
eye:    .skip   LIGHT_SIZE                              # a LIGHT there
# For each sort of nodes, spheres and boxes: the kernels as in the plan, and the size of a node.
node_kernels:
        .int    cull_nodes,filter_children_r16,NODE_SIZE,0
        .int    cull_box_nodes,filter_box_children_r16,BOX_NODE_SIZE,0
# For each tree: the test, the size of an object, -1 if it is flat, the test for primary rays.
kernels:
        .int    isect_bounced_spheres,OBJECT_SIZE,0,isect_seen_spheres
        .int    isect_rectangle_pairs_r16,RECT_SIZE,-1,isect_rectangle_pairs_r16
        .int    isect_triangles,TRI_SIZE,-1,isect_triangles
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
        .set    candidate_count,17
        .set    zero,17                                 # reused, like the next five
        .set    c_rectangles,17
        .set    any,17
        .set    c_levels,17
        .set    node_sort,17
        .set    m_word,17
        .set    capacity,18
        .set    c_full,18                               # reused, like the next three
        .set    c_shadow,18
        .set    c_bounced,18
        .set    c_no_levels,18
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
        .set    boxes,34                                # from this tree on: the last bit is its own
        .set    node,35                                 # what it has in node_kernels
        .set    first_packet,36
        .set    first_shadow,37
        .set    lists_size,38

# Lists the top of the current tree with as many packets as a batch has, from this one on.
.macro  list_candidates first:req
        shufb   $packet,$tree,\first,$m_first
        ori     $packets_left,$most,0
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
        lqa     $boxes,frame+(FRAME_box_trees&~15)
        rotqbyi $boxes,$boxes,FRAME_box_trees&15
        ila     $a_plan,plans
        ila     $a_kernel,kernels
        lqa     $a_list,roots_at
        il      $bvhs_left,TREES
        il      $zero,0
        stqa    $zero,any_deep
        rotmi   $most,$w_most,-4
        cwd     $m_first,0($sp)
        lqa     $step,packet_step
        lqa     $first_packet,rays_at
        lqa     $first_shadow,shadow_rays_at
        lqa     $t_quad,bounds_at
        lqa     $t_mask,shears_at
        lqa     $packet,candidate_words
        lqa     $root,shears_word
        shufb   $first_packet,$first_packet,$t_quad,$packet
        shufb   $first_shadow,$first_shadow,$t_quad,$packet
        shufb   $first_packet,$first_packet,$t_mask,$root
        shufb   $first_shadow,$first_shadow,$t_mask,$root
        lqa     $lists_size,shadow_candidates
next_plan:
        lqd     $tree,0($a_tree)
        rotqbyi $objects,$tree,BVH_objects
        brz     $objects,not_there
        # As many packets at once as have candidates that always fit; those of one packet always do.
        # MAX_NODES is for a small batch.
        il      $at_once,1
        ori     $candidate_count,$objects,0
another:
        a       $candidate_count,$candidate_count,$objects
        lqa     $capacity,object_list_nodes
        shli    $capacity,$capacity,2
        cgt     $c_full,$candidate_count,$capacity
        brnz    $c_full,as_many
        cgti    $c_full,$at_once,SMALL_BATCH-1
        brnz    $c_full,as_many
        ai      $at_once,$at_once,1
        br      another
as_many:
        lqd     $test,0($a_kernel)
        rotqbyi $levels,$tree,BVH_levels
        # Where the children of scattered rays' nodes are tested with the rays: of shadow rays in
        # deep trees, unless their objects are as quickly tested; of others if a level above them
        # passes or the objects take long.
        cgti    $c_shadow,$levels,DEEP-1
        ila     $c_rectangles,isect_rectangle_pairs_r16
        ceq     $c_rectangles,$c_rectangles,$test
        andc    $c_shadow,$c_shadow,$c_rectangles
        lqa     $any,any_deep
        or      $any,$any,$c_shadow
        stqa    $any,any_deep
        andi    $c_shadow,$c_shadow,4
        store_word $c_shadow,PLAN_shadow,$a_plan,$t_quad,$t_mask
        cgti    $c_levels,$levels,1
        ila     $c_bounced,isect_cone_pairs_r16
        ceq     $c_bounced,$c_bounced,$test
        or      $c_bounced,$c_bounced,$c_levels
        andi    $c_bounced,$c_bounced,4
        store_word $c_bounced,PLAN_bounced,$a_plan,$t_quad,$t_mask
        il      $zero,0
        store_word $zero,PLAN_bounced+8,$a_plan,$t_quad,$t_mask
        andi    $node_sort,$boxes,1
        shli    $node_sort,$node_sort,4
        ila     $node,node_kernels
        lqx     $node,$node,$node_sort
        stqd    $node,PLAN_cull($a_plan)
        rotqbyi $node,$node,8
        rotqbyi $root_step,$test,4
        ceqi    $c_no_levels,$levels,0
        selb    $root_step,$node,$root_step,$c_no_levels
        fsmbi   $m_word,0xf000
        and     $root_step,$root_step,$m_word
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
        list_candidates $first_packet
        a       $a_out,$a_list,$lists_size
        list_candidates $first_shadow
        a       $a_list,$a_list,$lists_size
        a       $a_list,$a_list,$lists_size
        ai      $a_plan,$a_plan,PLAN_SIZE
not_there:
        rotmi   $boxes,$boxes,-1
        ai      $a_tree,$a_tree,BVH_SIZE
        ai      $a_kernel,$a_kernel,16
        ai      $bvhs_left,$bvhs_left,-1
        brnz    $bvhs_left,next_plan
        stqa    $a_plan,plans_end
        bi      $lr
endfunction bvhs_plan

        .set    NEXT,10
        registers amount,t_sum,t_add
        registers c_more,plan,sizes,kinds,counts,even,t_list,c_over,cull
        # at the end
        registers low_word,a_generation,possible
        # two counts each: those of this call, their sums and the carries
    .irp pair, 0,1,2,3,4
        registers first\pair,second\pair,sums\pair,carry\pair
    .endr

# The packets that are being traced.
.macro  packets_address out:req, t_other:req, t_first:req
        lqa     \out,rays_at
        lqa     \t_other,shadow_rays_at
        ceqi    \t_first,$w_packets,0
        selb    \out,\t_other,\out,\t_first
.endm

# The depth from which on rays are scattered: eye rays are not, but what curved surfaces send on is.
        .set    SCATTERED_DEPTH,2
# The levels of a tree from which on it pays to test scattered shadow rays themselves, unless its
# objects are parallelograms, which are as quickly tested.
        .set    DEEP,3

# packets_trace   finds the nearest hits of packets
#   In      $3 BATCH_RAYS or SHADOW_RAYS, $4 how many packets of these, at least 1, $5 through what
#           they all go: -1 is nothing, 0 the eye, from where they come, else the LIGHT to which
#           they go, $6 the number of rays, generation
#   Uses    $3-$79, w_packets, w_traced, w_plan, w_after, w_here, w_left
#
# The cones of scattered rays let through nearly everything. So the children of nodes that pass are
# tested with the rays themselves, if the tree has enough levels for that to pay.
#
# With so few packets for each call, mispredicted branches would matter. So calls are hinted, and
# where to go on after a call is computed before it: as an address in w_after, which is hinted when
# the call returns. If that is a kernel's address, the link register has been set for it.
function packets_trace
        hbrr    bound_call,bound_fan_r16
        enter
        ori     $w_packets,$3,0
        ori     $w_traced,$4,0
        stqa    $6,rays_traced
        lqa     $t_sum,any_deep
        lqa     $counts,rays_at
        cgti    $amount,$w_depth,SCATTERED_DEPTH-1
        ceq     $counts,$counts,$3
        or      $t_sum,$t_sum,$counts
        and     $amount,$amount,$t_sum
        # 0, or 4 for rays to a light, or 8 for those that aren't scattered.
        andi    $kinds,$counts,4
        sfi     $kinds,$kinds,4
        il      $t_add,8
        selb    $kinds,$t_add,$kinds,$amount
        stqa    $kinds,lanes
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
        ila     $w_after,bound_origins_r16
        ila     $amount,bounded
        selb    $w_after,$w_after,$amount,$counts
        ceqi    $counts,$5,0
        stqa    $counts,of_eye
        lqa     $5,bounds_at
        # The distance of these packets' lists from those for BATCH_RAYS.
        lqa     $w_packets,rays_at
        ceq     $w_packets,$w_packets,$3
        lqa     $w_left,shadow_candidates
        andc    $w_packets,$w_left,$w_packets
        ila     $w_plan,plans
        # Without trees nobody needs their bounds, unless the frame keeps paths.
        lqa     $c_more,plans_end
        lqa     $counts,keeps_paths
        ceq     $c_more,$c_more,$w_plan
        ceqi    $counts,$counts,0
        and     $c_more,$c_more,$counts
        selb    $w_after,$w_after,$amount,$c_more
        brnz    $c_more,no_trees
bound_call:
        brsl    $lr,bound_fan_r16
no_trees:
        hbr     fan_end,$w_after
        # Without a point that all rays go through, their origins are bounded, too.
        lqa     $c_more,sheared
        packets_address $3,$4,$5
        ori     $4,$w_traced,0
        lqa     $5,bounds_at
        ila     $lr,bounded
        il      $t_sum,0
    .irp name, cull_tests,tests_made,tests_possible,blocks_used,blocks_fetched,ticks_block_wait
        stqa    $t_sum,\name
    .endr
        stqa    $c_more,to_shear
fan_end:
        bi      $w_after
bounded:
        brz     $g_skip,open
next_tree:
        lqa     $c_more,plans_end
        lqd     $plan,0($w_plan)
        lqd     $sizes,PLAN_roots($w_plan)
        lqa     $t_sum,tests_possible
        stqa    $w_traced,most_here
        il      $amount,0
        stqa    $amount,first_here
        ceq     $c_more,$c_more,$w_plan
        a       $3,$plan,$w_packets
        mpyu    $4,$sizes,$w_traced                     # candidates
        rotqbyi $counts,$sizes,PLAN_objects-PLAN_roots
        rotqbyi $w_left,$plan,PLAN_levels
        mpyu    $counts,$counts,$w_traced
        ori     $w_here,$w_traced,0
        brnz    $c_more,traced
        a       $t_sum,$t_sum,$counts
        stqa    $t_sum,tests_possible
        brz     $w_left,at_objects
next_level:
        lqd     $cull,PLAN_cull($w_plan)
        lqd     $kinds,PLAN_bounced($w_plan)
        lqd     $sizes,PLAN_roots($w_plan)
        lqa     $counts,lanes
        lqa     $t_sum,cull_tests
        andi    $even,$w_left,1
        ila     $w_after,found
        ila     $t_list,flat
        rotqbyi $sizes,$sizes,PLAN_flat-PLAN_roots
        ceqi    $amount,$w_left,1
        ila     $5,arena+OBJECT_LIST
        hbr     cull_call,$cull
        ceqi    $even,$even,0
        selb    $t_list,$w_after,$t_list,$sizes
        ila     $w_after,next_level
        selb    $w_after,$w_after,$t_list,$amount
        ila     $t_list,arena+NODE_LISTS
        lqa     $c_over,object_list_nodes
        il      $amount,NODE_LIST_NODES
        selb    $5,$5,$t_list,$even
        selb    $c_over,$c_over,$amount,$even
        lnop
        rotqby  $6,$kinds,$counts
        stqa    $5,level_list
        a       $t_sum,$t_sum,$4
        cgt     $c_over,$4,$c_over
        stqa    $t_sum,cull_tests
        rotqbyi $t_list,$cull,PLAN_filter-PLAN_cull
        ceqi    $amount,$6,0
        brnz    $c_over,crowded
roomy:  selb    $w_after,$t_list,$w_after,$amount
cull_call:
        bisl    $lr,$cull
        hbr     level_end,$w_after
        lqa     $5,level_list
        ai      $w_left,$w_left,-1
        ila     $lr,filtered
        # A hint must be eight instructions before its branch.
        nop     $2
        lnop
        sf      $4,$5,$3
        ori     $3,$5,0
        rotmi   $4,$4,-CANDIDATE_SIZE_LOG2
level_end:
        bi      $w_after
filtered:
        lqd     $sizes,PLAN_roots($w_plan)
        lqa     $5,level_list
        rotqbyi $even,$sizes,PLAN_flat-PLAN_roots
        sf      $4,$5,$3
        ori     $3,$5,0
        rotmi   $4,$4,-CANDIDATE_SIZE_LOG2
        brnz    $w_left,next_level
        brnz    $even,flat
found:
        # From here on the candidates are objects.
        hbrr    tree_done,next_tree
        lqd     $sizes,PLAN_roots($w_plan)
        lqd     $plan,0($w_plan)
        lqa     $counts,of_eye
        lqa     $t_sum,tests_made
        brz     $4,none_found
        rotqbyi $amount,$sizes,PLAN_eye_test-PLAN_roots
        rotqbyi $plan,$plan,PLAN_test
        selb    $plan,$plan,$amount,$counts
        hbr     test_call,$plan
        a       $t_sum,$t_sum,$4
        stqa    $t_sum,tests_made
        phase_ends $g_ticks_cull,$amount
test_call:
        bisl    $lr,$plan
tests_done:
        hbrr    tree_done,next_tree
        phase_ends $g_ticks_isect,$amount
none_found:
        ceq     $c_more,$w_here,$w_traced
        ai      $w_plan,$w_plan,PLAN_SIZE
        brz     $c_more,in_parts
tree_done:
        br      next_tree

at_objects:
        rotqbyi $even,$sizes,PLAN_flat-PLAN_roots
        brnz    $even,flat
        br      found

crowded:
        lqd     $plan,0($w_plan)
        rotqbyi $plan,$plan,PLAN_at_once
        cgt     $c_more,$w_here,$plan
        brz     $c_more,roomy
        stqa    $plan,most_here
        br      next_packets

        # Some of the packets have traversed the tree.
in_parts:
        lqa     $amount,first_here
        a       $amount,$amount,$w_here
        stqa    $amount,first_here
        ceq     $c_more,$amount,$w_traced
        brnz    $c_more,next_tree
        ai      $w_plan,$w_plan,-PLAN_SIZE
next_packets:
        lqa     $amount,first_here
        lqa     $w_here,most_here
        lqd     $plan,0($w_plan)
        lqd     $sizes,PLAN_roots($w_plan)
        sf      $t_sum,$amount,$w_traced
        minimum $w_here,$w_here,$t_sum,$c_more
        rotqbyi $w_left,$plan,PLAN_levels
        mpyu    $4,$sizes,$w_here
        mpyu    $3,$sizes,$amount
        a       $plan,$plan,$w_packets
        shli    $3,$3,CANDIDATE_SIZE_LOG2
        a       $3,$3,$plan
        br      next_level

flat:   hbrr    tree_done,next_tree
        lqa     $t_sum,cull_tests
        lqa     $6,along
        ila     $5,arena+OBJECT_LIST
        nop     $2
        brz     $4,none_found
        hbrr    faces_call,cull_faces
        a       $t_sum,$t_sum,$4
        stqa    $t_sum,cull_tests
        # As far as a hint must be from its branch.
        nop     $2
        lnop
        nop     $2
        lnop
        nop     $2
        lnop
faces_call:
        brsl    $lr,cull_faces
        # The kernel for flat objects is the same for all rays.
        lqd     $plan,0($w_plan)
        lqa     $counts,to_shear
        ila     $5,arena+OBJECT_LIST
        ila     $amount,isect_triangles
        sf      $4,$5,$3
        lqa     $t_sum,tests_made
        rotqbyi $plan,$plan,PLAN_test
        hbr     flat_call,$plan
        rotmi   $4,$4,-CANDIDATE_SIZE_LOG2
        ceq     $amount,$amount,$plan
        and     $counts,$counts,$amount
        brz     $4,none_found
        brnz    $counts,shear
ready:  ori     $3,$5,0
        ila     $lr,tests_done
        a       $t_sum,$t_sum,$4
        stqa    $t_sum,tests_made
        phase_ends $g_ticks_cull,$amount
flat_call:
        bi      $plan

open:   brsl    $lr,bounds_open
        il      $counts,8
        stqa    $counts,lanes
        br      next_tree
        # Most batches meet no triangle, so shears are made only when there is one to test.
shear:  stqa    $4,held
        brsl    $lr,shears_make
        lqa     $4,held
        lqd     $plan,0($w_plan)
        lqa     $t_sum,tests_made
        ila     $5,arena+OBJECT_LIST
        rotqbyi $plan,$plan,PLAN_test
        br      ready
traced:
        lqa     $c_more,streamed
        brnz    $c_more,in_mesh
counted:
        # As leave does, but so early that the return can be hinted.
        lqd     $lr,32+16($sp)
        lqa     $a_generation,generation
        # All at once, so that none waits for itself.
        lqa     $first0,rays_traced
        lqa     $first1,cull_tests
        lqa     $first2,blocks_used
        lqa     $first3,lanes
        lqa     $first4,tests_possible
        hbr     return,$lr
        lqa     $second1,tests_made
        lqa     $second2,blocks_fetched
        lqa     $second3,ticks_block_wait
        ceqi    $first3,$first3,8
        fsmbi   $low_word,0x0f00
        rotqmbyi $second0,$w_traced,-12
        andc    $first3,$w_traced,$first3
        il      $second4,0
    .irp pair, 0,1,2,3,4
        rotqmbyi $first\pair,$first\pair,-4
    .endr
    .irp pair, 1,2,3
        rotqmbyi $second\pair,$second\pair,-12
    .endr
        lqd     $sums0,GENERATION_rays($a_generation)
        lqd     $sums1,GENERATION_cull_tests($a_generation)
        lqd     $sums2,GENERATION_blocks_used($a_generation)
        lqd     $sums3,GENERATION_packets_scattered($a_generation)
        lqa     $sums4,counters+COUNT_tests_possible
    .irp pair, 0,1,2,3,4
        selb    $first\pair,$second\pair,$first\pair,$low_word
    .endr
    .irp pair, 0,1,2,3,4
        cg      $carry\pair,$sums\pair,$first\pair
        a       $sums\pair,$sums\pair,$first\pair
        shlqbyi $carry\pair,$carry\pair,4
    .endr
    .irp pair, 0,1,2,3,4
        a       $sums\pair,$sums\pair,$carry\pair
    .endr
        stqd    $sums0,GENERATION_rays($a_generation)
        stqd    $sums1,GENERATION_cull_tests($a_generation)
        stqd    $sums2,GENERATION_blocks_used($a_generation)
        stqd    $sums3,GENERATION_packets_scattered($a_generation)
        stqa    $sums4,counters+COUNT_tests_possible
        ai      $sp,$sp,32
return: bi      $lr
in_mesh:
        packets_address $3,$4,$5
        ori     $4,$w_traced,0
        brsl    $lr,paths_before_mesh
        # Cuts have found the ground for the eye's rays, and there is nothing else.
        lqa     $c_more,of_cuts
        ceqi    $counts,$w_packets,0
        and     $c_more,$c_more,$counts
        brnz    $c_more,counted
        # Shadow rays need it only where it is unknown whether it is in its own shadow.
        lqa     $c_more,cuts
        andc    $c_more,$c_more,$counts
        brz     $c_more,unknown
        brsl    $lr,shades_look
        brz     $3,known
unknown:
        lqa     $c_more,to_shear
        brz     $c_more,have_shears
        brsl    $lr,shears_make
have_shears:
        brsl    $lr,mesh_trace
        lqa     $c_more,cuts
        brz     $c_more,counted
        brz     $w_packets,counted
known:  brsl    $lr,shades_end
        br      counted
endfunction packets_trace

# shears_make   makes the shears of the packets
#   Uses    $3-$79
function shears_make
        enter
        il      $3,0
        stqa    $3,to_shear
        packets_address $3,$4,$5
        ori     $4,$w_traced,0
        lqa     $5,shears_at
        brsl    $lr,shear_packets_r16
        leave
endfunction shears_make

# bounds_open   makes bounds that contain everything, so that every ray is tested with every object
#   Uses    $10-$13
        .set    a_bound,10
        .set    zero,11
        .set    largest,12
        .set    bounds_left,13

function bounds_open
        lqa     $a_bound,bounds_at
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
