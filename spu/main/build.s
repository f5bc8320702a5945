# Refits a mesh, a unit of leaf blocks after the other, or builds one (sort.s). This code is there
# only in frames with FEATURE_BUILD.
#
# Three blocks are in work at a time: one is fetched, the vertices of the one before it are fetched
# by a list, and the one before that is refitted. A block and its bounds are sent from where they
# were made.

        .include "work_unit.inc"
        .include "macros.inc"
        .include "driver.inc"
        .include "mesh_block.inc"
        .include "build.inc"

        .set    NEXT,28
        registers bad,value,limit,a_build,a_frame,nodes,vertices,a_block,number
        registers offset,high,low,size,tag,command,t_carry

# Adds a block's offset to the address in $high and $low.
.macro  add_block number:req
        shli    $offset,\number,MESH_BLOCK_LOG2
        add_effective $high,$low,$offset,$t_carry
        rotmi   $offset,\number,MESH_BLOCK_LOG2-32
        a       $high,$high,$offset
.endm

.macro  refuse_build_if bad:req
        brnz    \bad,refused
.endm

# build_blocks   does this SPU's share of the task; at its end all that it makes is in main memory
#   Out     $3 STATUS_ value
#   Uses    $3-$79, the units' and tiles' driver registers
function build_blocks
        enter
        il      $g_turn,0
        brsl    $lr,unit_first
        brsl    $lr,unit_request
        ila     $a_frame,frame
        ila     $3,A_BUILD
        load_word $4,FRAME_scene,$a_frame
        load_word $5,FRAME_scene+4,$a_frame
        andi    $bad,$5,LINE-1
        refuse_build_if $bad
        il      $6,BUILD_SIZE
        il      $7,TAG_FRAME
        brsl    $lr,dma_get
        il      $3,1<<TAG_FRAME
        brsl    $lr,dma_wait
        ila     $a_build,A_BUILD
        il      $bad,0
    .irp field, blocks,vertices,sources,bounds,triangles,sorted
        load_word $value,BUILD_\field+4,$a_build
        or      $bad,$bad,$value
    .endr
        ila     $a_frame,frame
        load_word $value,FRAME_mesh+4,$a_frame
        or      $bad,$bad,$value
        andi    $bad,$bad,LINE-1
        refuse_build_if $bad
        load_word $g_blocks,FRAME_mesh_blocks,$a_frame
        load_constant $limit,MESH_BLOCKS
        clgt    $bad,$g_blocks,$limit
        refuse_build_if $bad
        # The elements of a list have only the low word of an address.
        load_word $g_vertices_low,BUILD_vertices+4,$a_build
        load_word $g_vertex_count,BUILD_vertex_count,$a_build
        ilhu    $limit,1<<(24-16)
        clgt    $bad,$g_vertex_count,$limit
        refuse_build_if $bad
        shli    $value,$g_vertex_count,4
        ai      $value,$value,-1
        cg      $bad,$g_vertices_low,$value
        refuse_build_if $bad
        load_word $value,BUILD_task,$a_build
        clgti   $bad,$value,BUILD_PACK_OBJECTS
        refuse_build_if $bad
        load_word $value,BUILD_triangle_count,$a_build
        clgt    $bad,$value,$limit
        refuse_build_if $bad
        load_word $limit,BUILD_sorted+4,$a_build
        shli    $value,$value,4
        ai      $value,$value,-1
        cg      $bad,$limit,$value
        refuse_build_if $bad

next_unit:
        take_unit all_built,$value
        ila     $a_build,A_BUILD
        load_word $value,BUILD_task,$a_build
        load_word $g_first,BUILD_UNIT_first,$g_a_unit
        brz     $value,refit
        ceqi    $value,$value,BUILD_SORT
        brnz    $value,sort
        brsl    $lr,sort_range
        brz     $3,next_unit
refused:
        il      $g_unit,STATUS_Build
        br      settle
all_built:
        il      $g_unit,STATUS_Done
settle: il      $3,ALL_TAGS
        brsl    $lr,dma_wait
        ori     $3,$g_unit,0
        leave
refit:  brsl    $lr,build_unit
        brz     $3,next_unit
        br      refused
sort:   brsl    $lr,sort_chunk
        brz     $3,next_unit
        br      refused
endfunction build_blocks

# build_unit   refits the blocks of a unit
#   In      g_a_unit
#   Out     $3 0, or something else if it or a block is damaged
#   Uses    $3-$79
function build_unit
        enter
        load_word $g_count,BUILD_UNIT_count,$g_a_unit
        blocks_are_bad $bad,BUILD_LEAVES,$limit
        brnz    $bad,damaged
        load_constant $3,MAX_SOURCES
        brsl    $lr,build_sources
        brnz    $3,damaged
        il      $g_step,0

next_step:
        clgt    $value,$g_count,$g_step
        brz     $value,all_fetched
        slot_of $g_slot,0
        await_slot $g_slot                              # what was sent from there has gone
        a       $number,$g_first,$g_step
        ila     $a_frame,frame
        load_word $high,FRAME_mesh,$a_frame
        load_word $low,FRAME_mesh+4,$a_frame
        add_block $number
        of_slot $a_block,A_BLOCKS,MESH_BLOCK_LOG2,$value
        il      $size,MESH_BLOCK
        ai      $tag,$g_slot,TAG_SLOT
        il      $command,MFC_GET
        mfc_command $a_block,$high,$low,$size,$tag,$command
all_fetched:
        ai      $value,$g_step,-1
        clgt    $value,$g_count,$value
        brz     $value,no_vertices
        slot_of $g_slot,1
        await_slot $g_slot
        brsl    $lr,build_vertices
        brnz    $3,damaged
no_vertices:
        ai      $value,$g_step,-2
        clgt    $value,$g_count,$value
        brz     $value,step_done
        slot_of $g_slot,2
        brsl    $lr,build_finish
step_done:
        ai      $g_step,$g_step,1
        ai      $value,$g_count,2
        ceq     $value,$value,$g_step
        brz     $value,next_step
        il      $3,0
        leave
damaged:
        il      $3,1
        leave
endfunction build_unit

# build_sources   starts to fetch the words that list what a unit's blocks consist of
#   In      g_a_unit, $3 the most words
#   Out     $3 0, or something else if there are more, none, or others than there should be
#   Uses    $3-$7, $10-$43
function build_sources
        enter
        ila     $a_build,A_BUILD
        load_word $value,BUILD_UNIT_source,$g_a_unit
        load_word $size,BUILD_UNIT_source_count,$g_a_unit
        ai      $bad,$size,-1                           # 0 becomes the largest
        clgt    $bad,$bad,$3
        clgt    $limit,$size,$3
        or      $bad,$bad,$limit
        load_word $limit,BUILD_source_count,$a_build
        clgt    $offset,$value,$limit
        or      $bad,$bad,$offset
        sf      $limit,$value,$limit                    # words from there on
        clgt    $limit,$size,$limit
        or      $bad,$bad,$limit
        or      $limit,$value,$size
        andi    $limit,$limit,3
        or      $bad,$bad,$limit
        rotmi   $limit,$value,-30
        or      $3,$bad,$limit
        brnz    $3,unfit
        load_word $4,BUILD_sources,$a_build
        load_word $5,BUILD_sources+4,$a_build
        shli    $value,$value,2
        add_effective $4,$5,$value,$t_carry
        ila     $3,A_SOURCES
        ori     $g_source,$3,0
        shli    $6,$size,2
        a       $g_sources_end,$g_source,$6
        il      $7,TAG_SOURCES
        brsl    $lr,dma_get
        il      $3,0
unfit:  leave
endfunction build_sources

# build_finish   makes the boxes of a block whose vertices or objects are on their way, and sends it
#   In      g_slot
#   Uses    $3-$79
function build_finish
        enter
        await_slot $g_slot
        of_slot $3,A_BLOCKS,MESH_BLOCK_LOG2,$value
        of_slot $4,A_BOUNDS,5,$value
        ila     $5,A_MEMORY
        load_word $value,MESH_HEADER_kind,$3
        cgti    $value,$value,MESH_LEAF
        brnz    $value,of_objects
        brsl    $lr,build_leaf
        br      has_boxes
of_objects:
        brsl    $lr,objects_boxes
has_boxes:
        ila     $a_build,A_BUILD
        of_slot $a_block,A_BLOCKS,MESH_BLOCK_LOG2,$value
        load_word $number,MESH_HEADER_number,$a_block
        load_word $high,BUILD_blocks,$a_build
        load_word $low,BUILD_blocks+4,$a_build
        add_block $number
        il      $size,MESH_BLOCK
        ai      $tag,$g_slot,TAG_SLOT
        il      $command,MFC_PUT
        mfc_command $a_block,$high,$low,$size,$tag,$command
        load_word $high,BUILD_bounds,$a_build
        load_word $low,BUILD_bounds+4,$a_build
        shli    $offset,$number,5
        add_effective $high,$low,$offset,$t_carry
        of_slot $a_block,A_BOUNDS,5,$value
        il      $size,BUILD_BOUNDS_SIZE
        mfc_command $a_block,$high,$low,$size,$tag,$command
        leave
endfunction build_finish

# build_vertices   checks the header of a block, and starts to fetch the block's vertices
#   In      g_slot; the block has arrived
#   Out     $3 0, or something else if the block is damaged
#   Uses    $3-$8, $10-$43
function build_vertices
        enter
        # The list arrives with the unit's first block.
        await_sources
        of_slot $a_block,A_BLOCKS,MESH_BLOCK_LOG2,$value
        ai      $number,$g_step,-1
        a       $number,$number,$g_first
        lqd     $bad,MESH_HEADER_number&~15($a_block)
        rotqbyi $value,$bad,MESH_HEADER_number&15
        ceq     $number,$number,$value
        rotqbyi $value,$bad,MESH_HEADER_kind&15
        ceqi    $value,$value,MESH_LEAF
        nand    $bad,$number,$value
        load_word $nodes,MESH_HEADER_nodes,$a_block
        ai      $value,$nodes,-1
        clgti   $value,$value,MESH_MAX_NODES-1
        or      $bad,$bad,$value
        load_word $vertices,MESH_HEADER_vertices,$a_block
        ai      $value,$vertices,-1
        clgti   $value,$value,MESH_VERTICES-1
        or      $bad,$bad,$value
        load_word $limit,MESH_HEADER_triangles,$a_block
        ai      $value,$limit,-1
        clgti   $value,$value,MESH_FACES-1
        or      $bad,$bad,$value
        # The vertices and faces must be within the block, and the list of vertices within the
        # unit's.
        mpyi    $nodes,$nodes,BOXES_SIZE
        ai      $nodes,$nodes,MESH_HEADER_SIZE
        shli    $value,$vertices,4
        a       $value,$value,$nodes
        shli    $limit,$limit,2
        a       $limit,$limit,$value
        il      $value,MESH_BLOCK
        clgt    $limit,$limit,$value
        or      $bad,$bad,$limit
        load_word $value,0,$g_source                    # runs
        clgti   $limit,$value,MESH_VERTICES
        or      $bad,$bad,$limit
        ai      $value,$value,4                         # with their number, and filled up
        rotmi   $4,$value,-2
        shli    $size,$4,4
        ori     $3,$g_source,0
        a       $g_source,$g_source,$size
        clgt    $limit,$g_source,$g_sources_end
        or      $bad,$bad,$limit
        brnz    $bad,wrong
        andi    $5,$g_slot,LISTS-1
        shli    $5,$5,11
        ila     $value,A_LISTS
        a       $5,$5,$value
        ori     $6,$g_vertices_low,0
        ori     $7,$g_vertex_count,0
        ori     $8,$vertices,0
        a       $a_block,$a_block,$nodes
        shli    $size,$size,1
        ori     $low,$5,0
        brsl    $lr,build_list
        brnz    $3,wrong
        ila     $a_build,A_BUILD
        load_word $high,BUILD_vertices,$a_build
        ai      $tag,$g_slot,TAG_SLOT
        il      $command,MFC_GETL
        mfc_command $a_block,$high,$low,$size,$tag,$command
        leave
wrong:  il      $3,1
        leave
endfunction build_vertices
