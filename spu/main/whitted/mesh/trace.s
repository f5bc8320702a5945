# Finds the hits of packets of rays with the triangles, spheres and cones of the mesh. All packets
# of a batch go through the blocks together, so that each block is needed once for all of them.

        .include "work_unit.inc"
        .include "macros.inc"
        .include "driver.inc"
        .include "whitted.inc"
        .include "mesh.inc"

# Testing a packet's rays with a node's boxes takes as long as with two triangles, and spares about
# half of the runs. So a leaf's lowest nodes are tested if four triangles are to be tested for each:
# a leaf has up to this number by its runs.
        .set    FILTERED_TRIANGLES,4*16
# Blocks that are fetched before they are needed, with the first of these.
        .set    PREFETCHED,3

        .section .data.mesh,"aw",@progbits
        .align  4
first_candidate:                        # of the batch's first packet, but for the node
        .skip   16
farthest:                               # of each packet, as in its MESH_BOUND
        .skip   32
packets:                                # the current block's: a bit each, of weight 128 for the
        .skip   16                      # first packet
visits_left:                            # blocks: a tree has no more
        .skip   16
of_objects:                             # whether the current leaf has spheres or cones
        .skip   16
base:                                   # what is added to the children of the lowest nodes
        .skip   16
filters:                                # whether the lowest boxes may be tested with the rays
        .skip   16
nodes:  .skip   16                                      # the list of the level above
node_count:
        .skip   16
scattered:                              # whether packets' rays are far apart, as shadow rays are
        .skip   16
runs:                                   # of a leaf, from the eye: those that are still to be tested
        .skip   16
run_count:
        .skip   16
eye_way:                                # whether the rays have the way of those from the eye
        .skip   16
as_one:                                 # whether they go through inner blocks as one packet
        .skip   16
together:                               # its candidate, but for the node
        .int    0,0,0,0

        .section .rodata.mesh,"a",@progbits
        .align  4
# A packet's number is in the last bits of its address, which make no difference to loads.
batch_candidate:
        .int    0,arena+BATCH_RAYS,arena+BATCH_BOUNDS,0
shadow_candidate:
        .int    0,arena+SHADOW_RAYS,arena+BATCH_BOUNDS,0
next_candidate:
        .int    0,RAYS16_SIZE+1,MESH_BOUND_SIZE,0
no_entry:
        .int    0,0,FARTHEST,0
last_words:                             # of two quadwords
        .int    0x0c0d0e0f,0x1c1d1e1f,0x0c0d0e0f,0x1c1d1e1f
first_halves:
        .int    0x00010203,0x04050607,0x10111213,0x14151617
# Of a candidate and its packet's bit, an entry of the stack.
candidate_to_entry:
        .int    0x00010203,0x10111213,0x0c0d0e0f,0x80808080
entry_block:                            # without the number of the box
        .int    (1<<CHILD_SHIFT)-1,-1,-1,-1

# mesh_trace   finds the nearest hits of packets with the mesh, and makes the patches that rays of
#              a batch have hit
#   In      w_packets, w_traced as packets_trace has them; the packets' SHEARS
#   Uses    $3-$79, w_plan, w_first, w_here, w_left
        .set    NEXT,10
        registers t_sum
        registers entry,number,mask,near,beyond,m_word,c_end
        registers candidate,step,a_out,bit
        registers levels,other,a_list,header
        # the children of an inner block
        registers a_table,a_met,k_first_packet,m_entry,m_near,k_step
        registers box,packet,old,new,c_nearer,c_first,a_end
        # pushing them
        registers place,below,c_more,left
        registers last                                  # to 53: a quadword of each packet's bound
        .set    NEXT,last+8

# Keeps in one place how far each packet's rays count.
.macro  gather_farthest
    .irp packet, 0,1,2,3,4,5,6,7
        lqa     $last+\packet,arena+BATCH_BOUNDS+\packet*MESH_BOUND_SIZE+(MESH_BOUND_farthest&~15)
    .endr
        lqa     $m_word,last_words
    .irp packet, 0,2,4,6
        shufb   $last+\packet,$last+\packet,$last+\packet+1,$m_word
    .endr
        lqa     $m_word,first_halves
        shufb   $last,$last,$last+2,$m_word
        shufb   $last+4,$last+4,$last+6,$m_word
        stqa    $last,farthest
        stqa    $last+4,farthest+16
.endm

function mesh_trace
        hbrr    bounds_call,mesh_bounds_r16
        enter
        lqa     $candidate,batch_candidate
        lqa     $step,shadow_candidate
        ceqi    $mask,$w_packets,0
        fsmbi   $m_word,0xffff
        splat_mask $bit
        splat   $mask,$mask,$bit
        selb    $candidate,$step,$candidate,$mask
        stqa    $candidate,first_candidate
        rotqbyi $3,$candidate,MESH_CANDIDATE_packet
        ori     $4,$w_traced,0
        brnz    $w_packets,shadow_rays
unblocked:
        cgti    $mask,$w_depth,1
        brnz    $mask,one_by_one
in_packets:
        ori     $4,$w_traced,0
        lqa     $candidate,first_candidate
        rotqbyi $3,$candidate,MESH_CANDIDATE_packet
        ila     $5,arena+BATCH_BOUNDS
        ila     $6,arena+BATCH_SHEARS
        lqa     $mask,of_eye
        lqa     $c_end,streamed
        andi    $c_end,$c_end,FEATURE_TEXTURES
        ceqi    $c_end,$c_end,0
        and     $mask,$mask,$c_end
        # Cuts have the place of that code.
        lqa     $c_end,cuts
        andc    $mask,$mask,$c_end
        stqa    $mask,eye_way
        lqa     $other,streamed
        il      $bit,FEATURE_HEIGHTS
        and     $other,$other,$bit
        cgti    $other,$other,0
        and     $other,$other,$mask
        stqa    $other,as_one
        brnz    $mask,eye_bounds
bounds_call:
        brsl    $lr,mesh_bounds_r16
bounded:
        gather_farthest
        cgti    $mask,$w_depth,1
        or      $mask,$mask,$w_packets
        stqa    $mask,scattered
        lqa     $mask,frame+FRAME_mesh_blocks
        stqa    $mask,visits_left
        # No child of a block has been met yet.
        lqa     $entry,no_entry
        ila     $a_out,arena+MESH_CHILDREN
        il      $left,MESH_MAX_NODES/2
clear:  hbrr    cleared,clear
    .irp box, 0,1,2,3,4,5,6,7
        stqd    $entry,16*\box($a_out)
    .endr
        ai      $a_out,$a_out,128
        ai      $left,$left,-1
cleared:
        brnz    $left,clear
        # The first entry: block 0 and all packets.
        sfi     $left,$w_traced,SMALL_BATCH
        il      $mask,(1<<SMALL_BATCH)-1
        shl     $mask,$mask,$left
        andi    $mask,$mask,(1<<SMALL_BATCH)-1
        rotqmbyi $mask,$mask,-ENTRY_packets
        fsmbi   $m_word,0x0f00
        and     $entry,$mask,$m_word
        ila     $m_top,arena+MESH_STACK
        stqd    $entry,0($m_top)
        ai      $m_top,$m_top,CANDIDATE_SIZE

next_block:
        ila     $c_end,arena+MESH_STACK
        ceq     $c_end,$c_end,$m_top
        brnz    $c_end,traced
        ai      $m_top,$m_top,-CANDIDATE_SIZE
        lqd     $entry,0($m_top)
        hbrr    block_call,mesh_block
        # Packets whose rays all hit something nearer are left out.
        lqa     $last,farthest
        lqa     $last+1,farthest+16
        splat_mask $m_word
        rotqbyi $near,$entry,ENTRY_near
        splat   $near,$near,$m_word
        fcgt    $beyond,$near,$last
        fcgt    $near,$near,$last+1
        gb      $beyond,$beyond
        gb      $near,$near
        shli    $beyond,$beyond,4
        or      $beyond,$beyond,$near
        rotqbyi $mask,$entry,ENTRY_packets
        andc    $mask,$mask,$beyond
        brz     $mask,next_block
        stqa    $mask,packets
        lqa     $left,visits_left
        ori     $3,$entry,0
        brz     $left,bad_block
        ai      $left,$left,-1
        stqa    $left,visits_left
block_call:
        brsl    $lr,mesh_block
        ori     $m_block,$3,0
        lqd     $header,MESH_HEADER_kind&~15($m_block)
        lqa     $c_end,as_one
        rotqbyi $header,$header,MESH_HEADER_kind&15
        ceqi    $header,$header,MESH_INNER
        and     $c_end,$c_end,$header
        brnz    $c_end,height_together

        # The block's first node and its packets.
        lqa     $candidate,first_candidate
        lqa     $step,next_candidate
        lqa     $mask,packets
        ai      $box,$m_block,MESH_HEADER_SIZE
        cwd     $m_word,0($sp)
        shufb   $candidate,$box,$candidate,$m_word
        ila     $3,arena+MESH_FIRST
        ori     $a_out,$3,0
    .set    nth,0
    .rept   SMALL_BATCH
        andi    $last+nth,$mask,1<<(SMALL_BATCH-1-nth)
    .set    nth,nth+1
    .endr
    .set    nth,0
    .rept   SMALL_BATCH
        # From its bit to the size of a candidate.
    .if nth < SMALL_BATCH-1-CANDIDATE_SIZE_LOG2
        rotmi   $last+nth,$last+nth,-(SMALL_BATCH-1-CANDIDATE_SIZE_LOG2-nth)
    .else
        shli    $last+nth,$last+nth,nth-(SMALL_BATCH-1-CANDIDATE_SIZE_LOG2)
    .endif
    .set    nth,nth+1
    .endr
    .set    nth,0
    .rept   SMALL_BATCH
        stqd    $candidate,0($a_out)
        a       $candidate,$candidate,$step
        a       $a_out,$a_out,$last+nth
    .set    nth,nth+1
    .endr
        sf      $4,$3,$a_out
        rotmi   $4,$4,-CANDIDATE_SIZE_LOG2
first_node:
        lqd     $levels,MESH_HEADER_levels&~15($m_block)
        rotqbyi $m_levels,$levels,MESH_HEADER_levels&15
        tally   cull_tests,$4
        ai      $m_levels,$m_levels,-1
        brz     $m_levels,lowest
next_level:
        # From the nodes of one level to those of the next.
        hbrr    level_call,cull_boxes
        ila     $5,arena+MESH_SECOND
        ila     $other,arena+MESH_FIRST
        ceq     $c_end,$5,$3
        selb    $5,$5,$other,$c_end
        ori     $m_list,$5,0
        ori     $6,$m_block,0
        stqa    $3,nodes
        stqa    $4,node_count
level_call:
        brsl    $lr,cull_boxes
        sf      $4,$m_list,$3
        ori     $3,$m_list,0
        rotmi   $4,$4,-CANDIDATE_SIZE_LOG2
        brz     $4,next_block
        # Whether more than half of the children are left for rays that are far apart.
        lqa     $mask,scattered
        lqa     $number,node_count
        shli    $near,$number,1
        cgt     $near,$4,$near
        and     $mask,$mask,$near
        brnz    $mask,not_enough
level_met:
        tally   cull_tests,$4
        ai      $m_levels,$m_levels,-1
        brnz    $m_levels,next_level
lowest: hbrr    lowest_call,cull_boxes
        ila     $5,arena+MESH_LIST
        lqd     $header,MESH_HEADER_kind&~15($m_block)
        rotqbyi $header,$header,MESH_HEADER_kind&15
        cgti    $6,$header,MESH_LEAF
        lqa     $mask,scattered
        ceqi    $header,$header,MESH_SPHERES
        andc    $mask,$mask,$header                     # a test with a sphere is as quick
        and     $6,$6,$m_block                          # the children are offsets of objects
        stqa    $6,base
        stqa    $mask,filters
        stqa    $3,nodes
        stqa    $4,node_count
lowest_call:
        brsl    $lr,cull_boxes
        lqa     $mask,filters
        brnz    $mask,filter
met:    ila     $a_list,arena+MESH_LIST
        sf      $4,$a_list,$3
        ori     $3,$a_list,0
        rotmi   $4,$4,-CANDIDATE_SIZE_LOG2
        brz     $4,next_block
        lqd     $header,MESH_HEADER_kind&~15($m_block)
        rotqbyi $header,$header,MESH_HEADER_kind&15
        brz     $header,inner

        # The triangles, spheres or cones of a leaf.
        hbrr    isect_call,isect_mesh_pairs_r16
        phase_ends $g_ticks_cull,$t_sum
        cgti    $c_end,$header,MESH_LEAF
        lqa     $mask,eye_way
        brnz    $c_end,object_leaf
        brz     $w_packets,known_leaf
not_kept:
        brnz    $mask,eye_leaf
        ori     $5,$m_block,0
isect_call:
        brsl    $lr,isect_mesh_pairs_r16
        tally   tests_made,$3
        tally   tests_possible,$3
        il      $c_end,0
tested: stqa    $c_end,of_objects
        hbrr    farthest_call,mesh_farthest_r16
        phase_ends $g_ticks_isect,$t_sum
        lqa     $mask,packets
        clz     $near,$mask
        ai      $near,$near,-(32-SMALL_BATCH)             # the first packet
        sfi     $bit,$mask,0
        and     $bit,$bit,$mask
        clz     $bit,$bit
        ai      $bit,$bit,-(32-SMALL_BATCH)               # the last
        sf      $4,$near,$bit
        ai      $4,$4,1
        lqa     $candidate,first_candidate
        rotqbyi $3,$candidate,MESH_CANDIDATE_packet
        mpyi    $step,$near,MESH_BOUND_SIZE
        il      $bit,RAYS16_SIZE
        mpyu    $bit,$bit,$near
        a       $3,$3,$bit
        ila     $5,arena+BATCH_BOUNDS
        a       $5,$5,$step
        lqa     $c_end,of_objects
        brnz    $c_end,to_numbers
numbered:
        brnz    $w_packets,blocked
farthest_call:
        brsl    $lr,mesh_farthest_r16
        hbrr    leaf_done,next_block
        gather_farthest
leaf_done:
        br      next_block

        # The rays are from the eye.
eye_bounds:
        ila     $7,arena+MESH_WINDOWS
        brsl    $lr,mesh_eye_bounds_r16
        mpyi    $step,$w_traced,MESH_WINDOW_SIZE
        ila     $other,arena+MESH_WINDOWS
        lqa     $candidate,together
        a       $step,$step,$other
        cwd     $m_word,MESH_CANDIDATE_bound($sp)
        shufb   $candidate,$step,$candidate,$m_word
        stqa    $candidate,together
        br      bounded

        # The place of a flat leaf, or of a height field's, is kept for mesh_hits.
known_leaf:
        lqd     $header,MESH_HEADER_magic($m_block)
        lqd     $last,MESH_HEADER_nodes&~15($m_block)
        rotqbyi $header,$header,MESH_HEADER_number
        leaf_place $box,$header
        lqa     $other,kept_from
        clgt    $other,$other,$header
        mpyi    $near,$last,BOXES_SIZE
        rotqbyi $below,$last,MESH_HEADER_vertices&15
        rotqbyi $last,$last,MESH_HEADER_sides&15
        ilhu    $number,(SIDES_SMOOTH|SIDES_TEXTURED|SIDES_WIDE|SIDES_COLOURED)>>16
        and     $number,$number,$last
        and     $number,$number,$other
        brnz    $number,not_kept
        a       $near,$near,$m_block
        ai      $near,$near,MESH_HEADER_SIZE
        shli    $below,$below,4
        a       $below,$below,$near
        cwd     $m_word,MESH_LEAVES_vertices($sp)
        shufb   $header,$near,$header,$m_word
        cwd     $m_word,MESH_LEAVES_faces($sp)
        shufb   $header,$below,$header,$m_word
        cwd     $m_word,MESH_LEAVES_sides($sp)
        shufb   $header,$last,$header,$m_word
        ila     $number,mesh_leaves
        stqx    $header,$number,$box
        br      not_kept

        # Few rows of rays hit a small triangle, so these are found first.
eye_leaf:
        hbrr    filter_call,filter_triangles_r16
        il      $number,MESH_RUNS_AT_ONCE
        cgt     $c_more,$4,$number
        selb    $number,$4,$number,$c_more
        sf      $left,$number,$4
        shli    $step,$number,CANDIDATE_SIZE_LOG2
        a       $step,$step,$3
        stqa    $left,run_count
        stqa    $step,runs
        ori     $4,$number,0
        ori     $5,$m_block,0
        ila     $6,arena+MESH_ROW_LIST
        ila     $7,arena+MESH_WINDOWS
filter_call:
        brsl    $lr,filter_triangles_r16
        hbrr    rows_call,isect_mesh_rows_r4
        rotqbyi $number,$3,8
        rotqbyi $4,$3,4
        tally   tests_made,$number
        tally   tests_possible,$number
        ila     $3,arena+MESH_ROW_LIST
        ori     $5,$m_block,0
rows_call:
        brsl    $lr,isect_mesh_rows_r4
        lqa     $4,run_count
        lqa     $3,runs
        il      $c_end,0
        brz     $4,tested
        br      eye_leaf

        # Where it pays, the packets' rays are tested with the children that are left.
filter: ila     $5,arena+MESH_LIST
        lqa     $4,node_count
        sf      $near,$5,$3
        rotmi   $near,$near,-CANDIDATE_SIZE_LOG2
        lqd     $header,MESH_HEADER_triangles&~15($m_block)
        rotqbyi $header,$header,MESH_HEADER_triangles&15
        il      $left,FILTERED_TRIANGLES
        ceqi    $mask,$header,0                         # an inner block, of which one child counts
        selb    $header,$header,$left,$mask
        mpyu    $near,$near,$header
        mpyu    $left,$left,$4
        cgt     $near,$near,$left
        brz     $near,met
        lqa     $3,nodes
        lqa     $6,base
        brsl    $lr,filter_boxes_r16
        br      met

        # The packets' rays are tested with the children.
not_enough:
        lqa     $3,nodes
        ori     $4,$number,0
        ori     $5,$m_list,0
        ori     $6,$m_block,0
        brsl    $lr,filter_boxes_r16
        sf      $4,$m_list,$3
        ori     $3,$m_list,0
        rotmi   $4,$4,-CANDIDATE_SIZE_LOG2
        brz     $4,next_block
        br      level_met

object_leaf:
        tally   tests_made,$4
        tally   tests_possible,$4
        stqa    $header,met_round
        ceqi    $c_end,$header,MESH_CONES
        brnz    $c_end,cones
        brsl    $lr,isect_seen_spheres
objects_tested:
        il      $c_end,-1
        br      tested
cones:  brsl    $lr,isect_cone_pairs_r16
        br      objects_tested

        # The rays' hits are addresses of objects in the block, which may leave the cache. They
        # get numbers, as triangles have: the offset in the block is in quadwords.
to_numbers:
        splat_mask $m_word
        splat   $box,$m_block,$m_word
        lqd     $header,MESH_HEADER_number&~15($m_block)
        rotqbyi $header,$header,MESH_HEADER_number&15
        shli    $header,$header,7
        ilhu    $t_sum,MESH_HIT>>16
        or      $header,$header,$t_sum
        splat   $header,$header,$m_word
        ori     $place,$3,0
        ori     $left,$4,0
next_numbers:
        hbrr    last_numbers,next_numbers
    .irp row, 0,1,2,3
        lqd     $old,RAYS16_object+16*\row($place)
        sf      $new,$box,$old
        rotmi   $c_first,$new,-MESH_BLOCK_LOG2
        rotmi   $new,$new,-4
        ceqi    $c_first,$c_first,0
        or      $new,$new,$header
        selb    $old,$old,$new,$c_first
        stqd    $old,RAYS16_object+16*\row($place)
    .endr
    .rept   2                                           # ai reaches to 511
        ai      $place,$place,RAYS16_SIZE/2
    .endr
        ai      $left,$left,-1
last_numbers:
        brnz    $left,next_numbers
        br      numbered

        # Secondary rays of curved surfaces are incoherent.
one_by_one:
        brsl    $lr,mesh_stream
        brz     $3,traced
        br      in_packets

        # A shadow ray that is blocked needs no more tests, so it stops to be one.
shadow_rays:
        brsl    $lr,mesh_drop_blocked
        br      unblocked
blocked:
        brsl    $lr,mesh_drop_blocked
        br      farthest_call

inner:
        # Each child once, with all packets that may meet it, and the nearest of their distances.
        ila     $a_table,arena+MESH_CHILDREN
        ila     $a_met,arena+MESH_MET
        il      $k_first_packet,1<<(SMALL_BATCH-1)
        lqa     $mask,as_one
        lqa     $step,packets
        selb    $k_first_packet,$k_first_packet,$step,$mask
        lqa     $m_entry,candidate_to_entry
        fsmbi   $m_near,0x00f0
        il      $k_step,CANDIDATE_SIZE
        lqd     $candidate,0($3)
next_child:
        hbrr    last_child,next_child
        # Instructions without waits are placed between those that wait.
        rotmi   $box,$candidate,CANDIDATE_SIZE_LOG2-CHILD_SHIFT
        rotqbyi $packet,$candidate,MESH_CANDIDATE_packet
        ai      $3,$3,CANDIDATE_SIZE
        lqd     $beyond,0($3)
        ai      $4,$4,-1
        andi    $box,$box,-CANDIDATE_SIZE
        andi    $packet,$packet,SMALL_BATCH-1
        lqx     $old,$a_table,$box
        sfi     $packet,$packet,0
        rotm    $packet,$k_first_packet,$packet
        stqd    $box,0($a_met)
        shufb   $new,$candidate,$packet,$m_entry
        ceqi    $c_first,$old,0
        rotqbyi $c_first,$c_first,ENTRY_packets
        ori     $candidate,$beyond,0
        cgt     $c_nearer,$old,$new
        selb    $c_nearer,$old,$new,$c_nearer
        or      $new,$old,$new
        and     $c_first,$c_first,$k_step
        selb    $new,$new,$c_nearer,$m_near
        a       $a_met,$a_met,$c_first
        stqx    $new,$a_table,$box
last_child:
        brnz    $4,next_child

        # They go to the stack, the nearest of them last. Earlier entries stay below them.
        ila     $a_end,arena+MESH_MET
        sf      $step,$a_end,$a_met
        a       $step,$step,$m_top
        ila     $c_end,arena+MESH_STACK_END
        cgt     $c_end,$step,$c_end
        lqd     $3,MESH_HEADER_number&~15($m_block)
        rotqbyi $3,$3,MESH_HEADER_number&15
        brnz    $c_end,bad_block
        lqa     $m_entry,entry_block
        lqa     $old,no_entry
        ori     $a_end,$m_top,0
next_met:
        hbrr    pushed,next_met
        ai      $a_met,$a_met,-CANDIDATE_SIZE
        lqd     $box,0($a_met)
        lqx     $new,$a_table,$box
        stqx    $old,$a_table,$box
        ori     $place,$m_top,0
        and     $new,$new,$m_entry
        rotqbyi $near,$new,ENTRY_near
higher: hbrr    not_yet,higher
        ceq     $c_end,$place,$a_end
        lqd     $below,-CANDIDATE_SIZE($place)
        rotqbyi $c_more,$below,ENTRY_near
        cgt     $c_more,$near,$c_more
        andc    $c_more,$c_more,$c_end
        brz     $c_more,here
        stqd    $below,0($place)
        ai      $place,$place,-CANDIDATE_SIZE
not_yet:
        br      higher
here:   stqd    $new,0($place)
        ai      $m_top,$m_top,CANDIDATE_SIZE
        ceq     $c_end,$step,$m_top
pushed: brz     $c_end,next_met

        # The blocks that are needed next start to arrive.
        ori     $place,$m_top,0
        il      $left,PREFETCHED
next_prefetch:
        ila     $c_end,arena+MESH_STACK
        ceq     $c_end,$c_end,$place
        brnz    $c_end,next_block
        ai      $place,$place,-CANDIDATE_SIZE
        lqd     $3,ENTRY_block($place)
        brsl    $lr,mesh_prefetch
        ai      $left,$left,-1
        brnz    $left,next_prefetch
        br      next_block

bad_block:
        shli    $3,$3,8
        ori     $3,$3,STATUS_MeshBlock
        br      give_up

traced: phase_ends $g_ticks_cull,$t_sum
        brnz    $w_packets,seen
        brsl    $lr,mesh_hits
seen:   leave
endfunction mesh_trace

# height_together   makes one candidate of all the eye's packets and an inner block's first node
#   Out     $3, $4 1
#   Uses    $c_end, $last, $candidate, $other, $step, $m_word, $box
#
# Above a height field, these packets go through inner blocks as if they were one. They are beside
# each other, so one bound leaves out about as many children as all of theirs. Triangles that are
# small and apart, as in tetra:9, would take a tenth more time with it.
function height_together
        lqa     $last,farthest
        lqa     $last+1,farthest+16
        lqa     $candidate,together
        ila     $3,arena+MESH_FIRST
        fcgt    $c_end,$last+1,$last
        selb    $last,$last,$last+1,$c_end
        rotqbyi $other,$candidate,MESH_CANDIDATE_bound
        rotqbyi $last+1,$last,8
        lqd     $step,MESH_BOUND_farthest&~15($other)
        fcgt    $c_end,$last+1,$last
        selb    $last,$last,$last+1,$c_end
        cwd     $m_word,MESH_BOUND_farthest&15($sp)
        rotqbyi $last+1,$last,4
        fcgt    $c_end,$last+1,$last
        selb    $last,$last,$last+1,$c_end
        shufb   $step,$last,$step,$m_word
        stqd    $step,MESH_BOUND_farthest&~15($other)
        ai      $box,$m_block,MESH_HEADER_SIZE
        cwd     $m_word,0($sp)
        shufb   $candidate,$box,$candidate,$m_word
        stqd    $candidate,0($3)
        il      $4,1
        br      first_node
endfunction height_together

# mesh_drop_blocked   takes the shadow rays that have hit something out of packets
#   In      $3 packets, $4 how many
#   Out     t of these rays: -1
#   Uses    $10-$25
        .set    NEXT,10
        registers a_packet,packets_left,k_no_ray,background
        registers row_t                                 # to row_t+3, like the next two
        .set    row_object,row_t+4
        .set    c_lit,row_t+8

function mesh_drop_blocked
        ori     $a_packet,$3,0
        ori     $packets_left,$4,0
        ilhu    $k_no_ray,0xbf80                        # -1
        ila     $background,SCENE_ADDRESS
next_blocked:
        hbrr    last_blocked,next_blocked
    .irp row, 0,1,2,3
        lqd     $row_t+\row,RAYS16_t+16*\row($a_packet)
        lqd     $row_object+\row,RAYS16_object+16*\row($a_packet)
    .endr
    .irp row, 0,1,2,3
        ceq     $c_lit+\row,$row_object+\row,$background
    .endr
    .irp row, 0,1,2,3
        selb    $row_t+\row,$k_no_ray,$row_t+\row,$c_lit+\row
    .endr
    .irp row, 0,1,2,3
        stqd    $row_t+\row,RAYS16_t+16*\row($a_packet)
    .endr
    .rept   2                                           # ai reaches to 511
        ai      $a_packet,$a_packet,RAYS16_SIZE/2
    .endr
        ai      $packets_left,$packets_left,-1
last_blocked:
        brnz    $packets_left,next_blocked
        bi      $lr
endfunction mesh_drop_blocked
