# Blocks of a height field: fetches the inner blocks above them, or their samples, and makes
# triangles of these when they have arrived.
#
# This file and its kernel are in local store only in frames with FEATURE_HEIGHTS, at HEIGHT_CODE.

        .include "work_unit.inc"
        .include "macros.inc"
        .include "driver.inc"
        .include "checks.inc"
        .include "height.inc"

        .section .data.height,"aw",@progbits
        .align  4
        .global field
field:  .skip   HEIGHTS_SIZE

        .set    status,3
        .set    NEXT,15
        registers a_frame,value,limit,bad,a_field

# height_begin   fetches the height field and checks it; gives up if it or the mesh's cache is wrong
#   Uses    $3-$7, $10-$19
function height_begin
        enter
        ila     $a_frame,frame
        load_word $value,FRAME_mesh_slots,$a_frame
        shli    $value,$value,MESH_BLOCK_LOG2
        load_word $limit,FRAME_mesh_cache,$a_frame
        a       $value,$value,$limit
        ila     $limit,HEIGHT_CODE
        clgt    $bad,$value,$limit
        refuse_if $bad,MeshCache
        require_aligned heights,LINE,Heights
        ila     $3,field
        load_word $4,FRAME_heights,$a_frame
        load_word $5,FRAME_heights+4,$a_frame
        il      $6,HEIGHTS_SIZE
        il      $7,TAG_FRAME
        brsl    $lr,dma_get
        il      $3,1<<TAG_FRAME
        brsl    $lr,dma_wait
        ila     $a_field,field
        load_word $value,HEIGHTS_levels,$a_field
        ai      $bad,$value,-1
        clgti   $bad,$bad,HEIGHT_LEVELS-1
        refuse_if $bad,Heights
        # No more blocks than there are have to be visited, and any number may be a block's.
        ila     $a_frame,frame
        load_word $limit,HEIGHTS_blocks,$a_field
        lqd     $value,FRAME_mesh_blocks($a_frame)
        a       $limit,$value,$limit
        cwd     $bad,0($sp)
        shufb   $value,$limit,$value,$bad
        stqd    $value,FRAME_mesh_blocks($a_frame)
        ilhu    $limit,MESH_BLOCKS>>16
        stqa    $limit,block_limit
        # mesh_materials wants all hits to be made one by one.
        lqa     $value,streamed
        andi    $value,$value,FEATURE_MATERIALS
        brnz    $value,none_kept
        ilhu    $limit,HEIGHT_BLOCK>>16
        stqa    $limit,kept_from
none_kept:
        load_word $value,FRAME_features,$a_frame
        il      $limit,FEATURE_CUTS
        and     $value,$value,$limit
        brz     $value,begun
        lqa     $bad,streamed
        andi    $bad,$bad,FEATURE_MATERIALS
        refuse_if $bad,Cuts
        require_from_one cut_fours,MAX_CUT_FOURS,Cuts
        il      $value,-1
        stqa    $value,cuts
        require_aligned cut_code,LINE,Cuts
        require_at_most cut_code_bytes,CUTS_CODE_CAPACITY,Cuts
        andi    $bad,$value,15
        refuse_if $bad,Cuts
        ori     $6,$value,0
        ila     $3,TEXTURE_CODE
        load_word $4,FRAME_cut_code,$a_frame
        load_word $5,FRAME_cut_code+4,$a_frame
        il      $7,TAG_FRAME
        brsl    $lr,dma_get
        il      $3,1<<TAG_FRAME
        brsl    $lr,dma_wait
        sync
        brsl    $lr,cuts_begin
begun:  leave
refused:
        br      give_up
endfunction height_begin

        .set    NEXT,10
        registers t_carry,kind,level,row,column,a_level,word
        registers high,low,size,command,a_list,left,rest,element,stride,m_size,m_place
        .set    number,3
        .set    slot,4
        .set    tag,5

# height_fetch   starts to fetch a block of the height field
#   In      $3 number, $4 address of its slot, $5 tag
#   Uses    $10-$27
#
# The samples' rows are elements of a list, which is at the slot's beginning until they are there.
function height_fetch
        rotmi   $kind,$number,-22
        ila     $a_level,field
        andi    $size,$kind,2
        brnz    $size,samples
        brz     $kind,damaged
        # An inner block.
        ilhu    $word,(HEIGHT_TREE-1)>>16
        iohl    $word,(HEIGHT_TREE-1)&0xffff
        and     $word,$word,$number
        load_word $left,HEIGHTS_tree_blocks,$a_level
        clgt    $left,$left,$word
        brz     $left,damaged
        load_word $high,HEIGHTS_tree,$a_level
        load_word $low,HEIGHTS_tree+4,$a_level
        rotmi   $rest,$word,MESH_BLOCK_LOG2-32
        a       $high,$high,$rest
        shli    $word,$word,MESH_BLOCK_LOG2
        add_effective $high,$low,$word,$t_carry
        il      $size,MESH_BLOCK
        il      $command,MFC_GET
        mfc_command $slot,$high,$low,$size,$tag,$command
        bi      $lr

samples:
        rotmi   $level,$number,-19
        andi    $level,$level,15
        load_word $left,HEIGHTS_levels,$a_level
        clgt    $left,$left,$level
        brz     $left,damaged
        load_word $high,HEIGHTS_samples,$a_level
        load_word $low,HEIGHTS_samples+4,$a_level
        shli    $row,$number,32-19
        rotmi   $row,$row,-(32-10)
        andi    $column,$number,511
        shli    $level,$level,5
        a       $a_level,$a_level,$level
        load_word $left,HEIGHTS_levels_of+HEIGHT_LEVEL_across,$a_level
        clgt    $left,$left,$column
        brz     $left,damaged
        load_word $left,HEIGHTS_levels_of+HEIGHT_LEVEL_down,$a_level
        clgt    $left,$left,$row
        brz     $left,damaged
        fsmbi   $m_size,0xf000
        # Seven rows of its own level, and five of the next.
        ori     $a_list,$slot,0
        shli    $row,$row,2
        shli    $column,$column,5
        il      $size,HEIGHT_PITCH
        il      $left,-7
next_level:
        load_word $stride,HEIGHTS_levels_of+HEIGHT_LEVEL_stride,$a_level
        load_word $word,HEIGHTS_levels_of+HEIGHT_LEVEL_offset,$a_level
        # The product of a row and a stride, which may have more than 16 bits.
        mpyh    $rest,$stride,$row
        mpyu    $element,$stride,$row
        a       $word,$word,$column
        a       $element,$element,$rest
        a       $word,$word,$low
        a       $element,$element,$word
next_element:
        hbrr    last_element,next_element
        lqd     $word,0($a_list)
        rotqmbyi $rest,$element,-4
        selb    $rest,$rest,$size,$m_size
        cdd     $m_place,0($a_list)
        shufb   $word,$rest,$word,$m_place
        stqd    $word,0($a_list)
        a       $element,$element,$stride
        ai      $a_list,$a_list,8
        ai      $left,$left,1
last_element:
        brnz    $left,next_element
        ai      $rest,$size,-HEIGHT_PITCH
        ai      $a_level,$a_level,HEIGHT_LEVEL_SIZE
        rotmi   $row,$row,-1
        rotmi   $column,$column,-1
        il      $size,COARSE_PITCH
        il      $left,-5
        brz     $rest,next_level
        il      $rest,HEIGHT_SAMPLES
        a       $rest,$rest,$slot
        il      $size,12*8
        il      $command,MFC_GETL
        mfc_command $rest,$high,$slot,$size,$tag,$command
        bi      $lr

damaged:
        shli    $3,$number,8
        ori     $3,$3,STATUS_MeshBlock
        br      give_up
endfunction height_fetch

# height_arrive   makes triangles of a block's samples
#   In      $3 address, $4 number
#   Uses    $3-$79
function height_arrive
        ori     $5,$4,0
        ila     $4,field
        lqa     $6,height_scratch
        br      height_block
endfunction height_arrive
