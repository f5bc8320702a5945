# Builds the leaf blocks of a mesh: sorts chunks of its triangles by their codes, then packs ranges
# of codes into blocks, which build.s refits around their vertices. Spheres and cones are sorted as
# triangles are, and have blocks of their own.

        .include "work_unit.inc"
        .include "macros.inc"
        .include "driver.inc"
        .include "mesh_block.inc"
        .include "build.inc"

        .set    NEXT,60                                 # kernels for lists leave these
        registers bad,value,limit,a_build,high,low,size,offset,tag,command,t_carry,nodes
        registers fours,first

    .if BUILD_CHUNK != 1<<12
        .error  "the limit of triangles is not the one that this code checks"
    .endif

# Writes elements after those of the unit: kernels take them in fours, and at least two of these.
# \value is in all words.
.macro  pad value:req, t:req
        shli    \t,$g_remaining,4
        ila     $offset,A_ELEMENTS
        a       \t,\t,$offset
    .irp of, 0,1,2,3,4,5,6
        stqd    \value,16*\of(\t)
    .endr
.endm

# The fours of triangles that are left from a batch on: none, or from two to those of a batch.
.macro  fours_of out:req, batch:req, t:req
        ai      \out,$g_remaining,3
        rotmi   \out,\out,-2
        shli    \t,\batch,5
        sf      \out,\t,\out
        il      \t,FOURS
        minimum \out,\out,\t,$value
        ceqi    \t,\out,1
        sf      \out,\t,\out
.endm

# Sorts all elements of the unit.
.macro  sort_unit
        il      $value,-1
        pad     $value,$limit
        ila     $3,A_ELEMENTS
        ai      $4,$g_remaining,3
        rotmi   $4,$4,-2
        ila     $5,A_OTHER
        ila     $6,A_TABLE
        brsl    $lr,sort_elements
.endm

# sort_count   reads the number of a unit's triangles
#   In      g_a_unit
#   Out     g_remaining; $3 0, or something else if there are none or too many
#   Uses    $3
function sort_count
        load_word $g_remaining,BUILD_UNIT_triangles,$g_a_unit
        ai      $3,$g_remaining,-1                           # 0 becomes the largest
        rotmi   $3,$3,-12
        bi      $lr
endfunction sort_count

# sort_chunk   gives the triangles of a unit their codes, and sorts them
#   In      g_a_unit, g_first
#   Out     $3 0, or something else if the unit or a triangle is damaged
#   Uses    $3-$79
function sort_chunk
        enter
        brsl    $lr,sort_count
        ila     $a_build,A_BUILD
        load_word $limit,BUILD_triangle_count,$a_build
        clgt    $bad,$g_first,$limit
        or      $3,$3,$bad
        sf      $limit,$g_first,$limit
        clgt    $bad,$g_remaining,$limit
        or      $3,$3,$bad
        brnz    $3,damaged
        load_word $4,BUILD_triangles,$a_build
        load_word $5,BUILD_triangles+4,$a_build
        shli    $value,$g_first,4
        add_effective $4,$5,$value,$t_carry
        ila     $3,A_ELEMENTS
        shli    $6,$g_remaining,4
        il      $7,TAG_SOURCES
        brsl    $lr,dma_get
        await_sources
        # The first vertex exists.
        il      $value,0
        pad     $value,$limit
        il      $g_step,0

        # The corners of a batch are fetched while the one before it gets its codes.
next_batch:
        fours_of $fours,$g_step,$limit
        cgti    $value,$fours,0
        brz     $value,all_fetched
        andi    $g_slot,$g_step,1
        shli    $3,$g_step,11
        ila     $value,A_ELEMENTS
        a       $3,$3,$value
        shli    $4,$fours,1
        mpyi    $5,$g_slot,96
        shli    $5,$5,5
        ila     $value,A_CORNER_LISTS
        a       $5,$5,$value
        ori     $low,$5,0
        ori     $6,$g_vertices_low,0
        ori     $7,$g_vertex_count,0
        mpyi    $size,$fours,96
        brsl    $lr,sort_corners
        brnz    $3,damaged
        ila     $a_build,A_BUILD
        load_word $high,BUILD_vertices,$a_build
        mpyi    $first,$g_slot,192
        shli    $first,$first,5
        ila     $value,A_CORNERS
        a       $first,$first,$value
        ai      $tag,$g_slot,TAG_SLOT
        il      $command,MFC_GETL
        mfc_command $first,$high,$low,$size,$tag,$command
all_fetched:
        brz     $g_step,batch_done
        ai      $first,$g_step,-1
        andi    $g_slot,$first,1
        await_slot $g_slot
        fours_of $4,$first,$limit
        shli    $3,$first,11
        ila     $value,A_ELEMENTS
        a       $3,$3,$value
        mpyi    $5,$g_slot,192
        shli    $5,$5,5
        ila     $value,A_CORNERS
        a       $5,$5,$value
        ila     $6,A_BUILD
        brsl    $lr,sort_codes
batch_done:
        ai      $g_step,$g_step,1
        ai      $first,$g_step,-1
        fours_of $fours,$first,$limit
        cgti    $value,$fours,0
        brnz    $value,next_batch

        sort_unit
        ila     $a_build,A_BUILD
        load_word $4,BUILD_sorted,$a_build
        load_word $5,BUILD_sorted+4,$a_build
        shli    $value,$g_first,4
        add_effective $4,$5,$value,$t_carry
        ila     $3,A_ELEMENTS
        shli    $6,$g_remaining,4
        il      $7,TAG_SOURCES
        brsl    $lr,dma_put
        await_sources
        il      $3,0
        leave
damaged:
        il      $3,1
        leave
endfunction sort_chunk

# sort_range   packs the triangles or objects of a range of codes into leaf blocks
#   In      g_a_unit, g_first
#   Out     $3 0, or something else if the unit or a triangle is damaged
#   Uses    $3-$79
function sort_range
        enter
        brsl    $lr,sort_count
        load_word $g_count,BUILD_UNIT_count,$g_a_unit
        blocks_are_bad $bad,255,$limit
        or      $3,$3,$bad
        brnz    $3,unfit
        il      $3,512
        brsl    $lr,build_sources
        brnz    $3,unfit
        await_sources
        ila     $a_build,A_BUILD
        ori     $3,$g_source,0
        sf      $size,$g_source,$g_sources_end
        rotmi   $4,$size,-4
        ila     $5,A_LISTS
        load_word $6,BUILD_sorted+4,$a_build
        load_word $7,BUILD_triangle_count,$a_build
        ori     $8,$g_remaining,0
        shli    $size,$size,1
        load_word $high,BUILD_sorted,$a_build
        brsl    $lr,build_list
        brnz    $3,unfit
        ila     $first,A_ELEMENTS
        ila     $low,A_LISTS
        il      $tag,TAG_SOURCES
        il      $command,MFC_GETL
        mfc_command $first,$high,$low,$size,$tag,$command
        await_sources
        sort_unit
        ila     $first,A_PACK
        il      $value,0
        il      $size,512/8
next_clear:
    .irp of, 0,1,2,3,4,5,6,7
        stqd    $value,16*\of($first)
    .endr
        ai      $first,$first,8*16
        ai      $size,$size,-1
        brnz    $size,next_clear
        ila     $g_source,A_ELEMENTS
        il      $g_step,0

next_leaf:
        brz     $g_remaining,all_packed
        clgt    $value,$g_count,$g_step
        brz     $value,unfit
        slot_of $g_slot,0
        await_slot $g_slot                              # what was sent from there has gone
        ori     $3,$g_source,0
        ori     $4,$g_remaining,0
        of_slot $5,A_BLOCKS,MESH_BLOCK_LOG2,$value
        andi    $6,$g_slot,LISTS-1
        shli    $6,$6,11
        ila     $value,A_LISTS
        a       $6,$6,$value
        ila     $a_build,A_BUILD
        load_word $value,BUILD_task,$a_build
        ceqi    $value,$value,BUILD_PACK
        brz     $value,objects
        ila     $7,A_PACK
        ori     $8,$g_vertices_low,0
        ori     $9,$g_vertex_count,0
        a       $10,$g_first,$g_step
        ai      $11,$g_step,1
        brsl    $lr,sort_pack
        of_slot $first,A_BLOCKS,MESH_BLOCK_LOG2,$value
        load_word $size,MESH_HEADER_vertices,$first
        br      packed
objects:
        ori     $7,$g_vertices_low,0
        ori     $8,$g_vertex_count,0
        a       $9,$g_first,$g_step
        brsl    $lr,objects_pack
        of_slot $first,A_BLOCKS,MESH_BLOCK_LOG2,$value
        ori     $size,$3,0
packed: brz     $3,unfit
        sf      $g_remaining,$3,$g_remaining
        shli    $3,$3,4
        a       $g_source,$g_source,$3
        load_word $nodes,MESH_HEADER_nodes,$first
        mpyi    $nodes,$nodes,BOXES_SIZE
        a       $first,$first,$nodes
        ai      $first,$first,MESH_HEADER_SIZE
        shli    $size,$size,3
        andi    $low,$g_slot,LISTS-1
        shli    $low,$low,11
        ila     $value,A_LISTS
        a       $low,$low,$value
        ila     $a_build,A_BUILD
        load_word $high,BUILD_vertices,$a_build
        ai      $tag,$g_slot,TAG_SLOT
        il      $command,MFC_GETL
        mfc_command $first,$high,$low,$size,$tag,$command
        brz     $g_step,no_leaf_before
        slot_of $g_slot,1
        brsl    $lr,build_finish
no_leaf_before:
        ai      $g_step,$g_step,1
        br      next_leaf
all_packed:
        slot_of $g_slot,1
        brsl    $lr,build_finish
        il      $3,ALL_TAGS
        brsl    $lr,dma_wait
        il      $3,0
        leave
unfit:
        il      $3,1
        leave
endfunction sort_range
