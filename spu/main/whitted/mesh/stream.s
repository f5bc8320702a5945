# Finds the hits of scattered rays with the mesh. The rays of a packet go every way, so it is not
# packets but rays that go through the blocks: each node is tested with those that meet its box.

        .include "work_unit.inc"
        .include "macros.inc"
        .include "driver.inc"
        .include "whitted.inc"
        .include "mesh.inc"

# Blocks that are fetched before they are needed, with the first of these.
        .set    PREFETCHED,3
# Up to FEW rays are tested with all of a leaf's lowest nodes. The children fit their list.
        .set    FEW,8
    .if FEW*64 > MESH_LIST_ENTRIES || FEW+LIST_MARGIN > MESH_MAX_NODES
        .error  "too many rays are few"
    .endif

        .section .data.mesh,"aw",@progbits
        .align  4
packet_and_step:                        # a candidate of the first packet, and what the next one adds
        .skip   16
        .int    0,RAYS16_SIZE,MESH_BOUND_SIZE,0
visits_left:                            # blocks: a tree has no more
        .skip   16
ray_tests:                              # of single rays with nodes
        .skip   16
have_bounds:                            # whether the packets have bounds, which name their shears
        .skip   16
together:                               # not 0 if the rays of the batch's packets stay together
        .skip   16

        .section .rodata.mesh,"a",@progbits
        .align  4
first_packets:                          # of BATCH_RAYS and SHADOW_RAYS
        .int    0,arena+BATCH_RAYS,arena+BATCH_BOUNDS,0
        .int    0,arena+SHADOW_RAYS,arena+BATCH_BOUNDS,0
entry_block:                            # without the number of the box
        .int    (1<<CHILD_SHIFT)-1,-1,-1,-1

        .set    NEXT,10
        registers t_sum,packet,shadow,m_word,bits,near,c_more,header,count
        registers first,last,place,left,offset
        registers box,old,new,c_of_block
        registers visit,rays,below,below_rays,c_end,a_end
        registers row                                   # to 46
        .set    NEXT,row+4
        registers all,any,one_way

# Where the packets are.
.macro  packets_address out:req
        lqa     $packet,packet_and_step
        rotqbyi \out,$packet,MESH_CANDIDATE_packet
.endm

# mesh_stream   finds the nearest hits of packets with the mesh, ray by ray
#   In      w_packets, w_traced as packets_trace has them; the packets' SHEARS
#   Out     $3 0, or something else if they must go as packets: their rays stay together, as those
#           that a flat mirror sends do, or the stack is too small for so deep a tree
#   Uses    $3-$79, w_plan, w_first, w_here, w_left
function mesh_stream
        hbrr    rays_call,mesh_rays_r16
        enter
        lqa     $packet,first_packets
        lqa     $shadow,first_packets+16
        ceqi    $c_more,$w_packets,0
        fsmbi   $m_word,0xffff
        splat_mask $m_word
        splat   $c_more,$c_more,$m_word
        selb    $packet,$shadow,$packet,$c_more
        stqa    $packet,packet_and_step
        rotqbyi $3,$packet,MESH_CANDIDATE_packet
        brnz    $w_packets,decided
        # A packet is scattered if its rays go up and down two axes at least. One of a full batch is
        # enough. Shadow rays start where the rays of the same batch end.
        ori     $place,$3,0
        ori     $left,$w_traced,0
        il      $count,0
next_packet:
        hbrr    last_packet,next_packet
        il      $one_way,0
    .irp axis, x,y,z
    .irp number, 0,1,2,3
        lqd     $row+\number,RAYS16_direction_\axis+16*\number($place)
    .endr
        and     $all,$row,$row+1
        or      $any,$row,$row+1
    .irp number, 2,3
        and     $all,$all,$row+\number
        or      $any,$any,$row+\number
    .endr
        rotmi   $all,$all,-31
        rotmi   $any,$any,-31
        gb      $all,$all
        gb      $any,$any
        ceqi    $all,$all,15
        ceqi    $any,$any,0
        or      $all,$all,$any
        a       $one_way,$one_way,$all
    .endr
        cgti    $one_way,$one_way,-2
        a       $count,$count,$one_way
    .rept   2                                           # ai reaches to 511
        ai      $place,$place,RAYS16_SIZE/2
    .endr
        ai      $left,$left,-1
last_packet:
        brnz    $left,next_packet
        shli    $count,$count,3
        a       $count,$count,$w_traced
        cgti    $count,$count,0                         # fewer than one of eight
        stqa    $count,together
decided:
        lqa     $count,together
        brnz    $count,as_packets
        ila     $left,arena+MESH_LIST
        stqa    $left,height_scratch
        ori     $4,$w_traced,0
        ila     $5,arena+MESH_RAYS
rays_call:
        brsl    $lr,mesh_rays_r16
        il      $count,0
        stqa    $count,ray_tests
        stqa    $count,have_bounds
        lqa     $count,frame+FRAME_mesh_blocks
        stqa    $count,visits_left
        # The first visit: block 0 and all rays.
        il      $visit,0
        il      $rays,-1
        ila     $m_top,arena+MESH_VISITS
        stqd    $visit,MESH_VISIT_child($m_top)
        stqd    $rays,MESH_VISIT_rays($m_top)
        ai      $m_top,$m_top,MESH_VISIT_SIZE

next_block:
        ila     $c_end,arena+MESH_VISITS
        ceq     $c_end,$c_end,$m_top
        brnz    $c_end,traced
        hbrr    alive_call,mesh_alive_r16
        ai      $m_top,$m_top,-MESH_VISIT_SIZE
        packets_address $3
        ori     $4,$w_traced,0
        lqd     $5,MESH_VISIT_child($m_top)
        lqd     $bits,MESH_VISIT_rays($m_top)
        rotqbyi $5,$5,MESH_VISIT_near
        ila     $6,arena+MESH_BITS
        stqa    $bits,arena+MESH_BITS
alive_call:
        brsl    $lr,mesh_alive_r16
        lqa     $bits,arena+MESH_BITS
        orx     $bits,$bits
        brz     $bits,next_block
        hbrr    block_call,mesh_block
        lqd     $3,MESH_VISIT_child($m_top)
        lqa     $left,visits_left
        brz     $left,bad_block
        ai      $left,$left,-1
        stqa    $left,visits_left
block_call:
        brsl    $lr,mesh_block
        ori     $m_block,$3,0
        ila     $c_end,arena+MESH_VISITS_END
        cgt     $c_end,$m_top,$c_end
        brnz    $c_end,too_deep
        # Few rays are tested with all of the lowest nodes of a leaf.
        lqa     $bits,arena+MESH_BITS
        lqd     $header,MESH_HEADER_magic($m_block)
        lqd     $box,MESH_HEADER_SIZE+BOXES_child($m_block)
        cntb    $bits,$bits
        rotqbyi $c_more,$header,MESH_HEADER_kind
        sumb    $bits,$bits,$bits
        ceqi    $box,$box,0
        rotmi   $bits,$bits,-16
        rotqbyi $left,$header,MESH_HEADER_levels
        gb      $box,$box
        rotqbyi $near,$bits,8
        cntb    $box,$box
        a       $bits,$bits,$near
        rotqbyi $near,$bits,4
        a       $count,$bits,$near
        cgti    $near,$count,FEW
        ceqi    $c_more,$c_more,MESH_INNER
        or      $c_more,$c_more,$near
        brz     $c_more,few
many:   hbrr    filter_call,mesh_filter_rays
        lqd     $4,MESH_HEADER_nodes($m_block)
        ai      $3,$m_block,MESH_HEADER_SIZE
        ila     $5,arena+MESH_BITS
        ori     $6,$m_top,0
        ila     $7,arena+MESH_RAYS
        packets_address $8
        ila     $9,arena+MESH_LIST
filter_call:
        brsl    $lr,mesh_filter_rays
        lqa     $t_sum,ray_tests
        a       $t_sum,$t_sum,$4
        stqa    $t_sum,ray_tests
        sf      $4,$m_top,$3
        brz     $4,next_block
        lqd     $header,MESH_HEADER_kind&~15($m_block)
        rotqbyi $header,$header,MESH_HEADER_kind&15
        brz     $header,inner

        # The packets whose rays meet the boxes of runs or objects are tested with these.
        hbrr    list_call,mesh_candidates
        rotmi   $4,$4,-5
        ori     $3,$m_top,0
        ila     $5,arena+MESH_LIST
        cgti    $6,$header,MESH_LEAF
        and     $6,$6,$m_block                          # the children are offsets of objects
        ila     $7,packet_and_step
list_call:
        brsl    $lr,mesh_candidates
listed:
        phase_ends $g_ticks_cull,$t_sum
        ila     $offset,arena+MESH_LIST
        sf      $4,$offset,$3
        ori     $3,$offset,0
        rotmi   $4,$4,-CANDIDATE_SIZE_LOG2
        lqd     $header,MESH_HEADER_kind&~15($m_block)
        rotqbyi $header,$header,MESH_HEADER_kind&15
        cgti    $c_more,$header,MESH_LEAF
        brz     $c_more,triangles
        tally   tests_made,$4
        tally   tests_possible,$4
        stqa    $header,met_round
        ceqi    $c_more,$header,MESH_CONES
        brnz    $c_more,cones
        brsl    $lr,isect_seen_spheres
objects_tested:
        # The rays' hits are addresses of objects in the block, which may leave the cache. They
        # get numbers, as triangles have: the offset in the block is in quadwords.
        brsl    $lr,of_packets
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
        rotmi   $c_of_block,$new,-MESH_BLOCK_LOG2
        rotmi   $new,$new,-4
        ceqi    $c_of_block,$c_of_block,0
        or      $new,$new,$header
        selb    $old,$old,$new,$c_of_block
        stqd    $old,RAYS16_object+16*\row($place)
    .endr
    .rept   2                                           # ai reaches to 511
        ai      $place,$place,RAYS16_SIZE/2
    .endr
        ai      $left,$left,-1
last_numbers:
        brnz    $left,next_numbers
tested: phase_ends $g_ticks_isect,$t_sum
        brz     $w_packets,next_block
        # A shadow ray that is blocked needs no more tests, so it stops to be one.
        brsl    $lr,of_packets
        brsl    $lr,mesh_drop_blocked
        br      next_block

cones:  brsl    $lr,isect_cone_pairs_r16
        br      objects_tested

few:    hbrr    few_call,mesh_few_rays
        # The nodes above them: the root, and its children if there are three levels.
        sfi     $box,$box,4
        cgti    $near,$left,2
        and     $box,$box,$near
        cgti    $near,$left,1
        sf      $box,$near,$box
        lqd     $4,MESH_HEADER_nodes($m_block)
        lqa     $t_sum,ray_tests
        sf      $4,$box,$4
        mpyi    $box,$box,BOXES_SIZE
        mpyu    $near,$4,$count
        a       $3,$m_block,$box
        a       $t_sum,$t_sum,$near
        ai      $3,$3,MESH_HEADER_SIZE
        stqa    $t_sum,ray_tests
        ila     $5,arena+MESH_BITS
        ila     $6,arena+MESH_LIST
        ila     $7,arena+MESH_RAYS
        ila     $8,packet_and_step
        rotqbyi $9,$header,MESH_HEADER_kind
        cgti    $9,$9,MESH_LEAF
        and     $9,$9,$m_block
        ila     $10,arena+MESH_BITS+16
few_call:
        brsl    $lr,mesh_few_rays
        ila     $offset,arena+MESH_LIST
        ceq     $offset,$offset,$3
        brnz    $offset,next_block
        br      listed

triangles:
        lqa     $c_more,have_bounds
        brz     $c_more,bound
bounded:
        ori     $5,$m_block,0
        brsl    $lr,isect_mesh_pairs_r16
        tally   tests_made,$3
        tally   tests_possible,$3
        br      tested

        # Only these tests need bounds.
bound:  stqa    $4,have_bounds
        packets_address $3
        ori     $4,$w_traced,0
        ila     $5,arena+BATCH_BOUNDS
        ila     $6,arena+BATCH_SHEARS
        brsl    $lr,mesh_bounds_r16
        lqa     $4,have_bounds
        ila     $3,arena+MESH_LIST
        br      bounded

        # The packets from the first one to the last one with rays in this block: $3 and $4.
of_packets:
        lqa     $bits,arena+MESH_BITS
        ceqhi   $bits,$bits,0
        gbh     $bits,$bits
        xori    $bits,$bits,255
        clz     $first,$bits
        ai      $first,$first,-(32-SMALL_BATCH)
        sfi     $last,$bits,0
        and     $last,$last,$bits
        clz     $last,$last
        ai      $last,$last,-(32-SMALL_BATCH)
        sf      $4,$first,$last
        ai      $4,$4,1
        il      $offset,RAYS16_SIZE
        mpyu    $offset,$offset,$first
        packets_address $3
        a       $3,$3,$offset
        bi      $lr

        # The nearest of the children goes to the top of the stack. Earlier entries stay below them.
inner:  ori     $a_end,$m_top,0
        ori     $place,$m_top,0
        ori     $c_end,$3,0
        lqa     $m_word,entry_block
next_visit:
        lqd     $visit,MESH_VISIT_child($m_top)
        lqd     $rays,MESH_VISIT_rays($m_top)
        and     $visit,$visit,$m_word
        rotqbyi $near,$visit,MESH_VISIT_near
        ori     $place,$m_top,0
higher: ceq     $old,$place,$a_end
        lqd     $below,MESH_VISIT_child-MESH_VISIT_SIZE($place)
        lqd     $below_rays,MESH_VISIT_rays-MESH_VISIT_SIZE($place)
        rotqbyi $c_more,$below,MESH_VISIT_near
        cgt     $c_more,$near,$c_more
        andc    $c_more,$c_more,$old
        brz     $c_more,here
        stqd    $below,MESH_VISIT_child($place)
        stqd    $below_rays,MESH_VISIT_rays($place)
        ai      $place,$place,-MESH_VISIT_SIZE
        br      higher
here:   stqd    $visit,MESH_VISIT_child($place)
        stqd    $rays,MESH_VISIT_rays($place)
        ai      $m_top,$m_top,MESH_VISIT_SIZE
        ceq     $old,$c_end,$m_top
        brz     $old,next_visit

        # The blocks that are needed next start to arrive.
        ori     $m_list,$m_top,0
        il      $m_levels,PREFETCHED
next_prefetch:
        ila     $c_end,arena+MESH_VISITS
        ceq     $c_end,$c_end,$m_list
        brnz    $c_end,next_block
        ai      $m_list,$m_list,-MESH_VISIT_SIZE
        lqd     $3,MESH_VISIT_child($m_list)
        brsl    $lr,mesh_prefetch
        ai      $m_levels,$m_levels,-1
        brnz    $m_levels,next_prefetch
        br      next_block

bad_block:
        shli    $3,$3,8
        ori     $3,$3,STATUS_MeshBlock
        br      give_up

too_deep:
        il      $3,1
        br      done
as_packets:
        ori     $3,$count,0
        leave
traced: il      $3,0
done:   ila     $left,arena+MATERIAL_FIRST
        stqa    $left,height_scratch
        lqa     $count,ray_tests
        rotmi   $count,$count,-4
        tally   cull_tests,$count
        leave
endfunction mesh_stream
