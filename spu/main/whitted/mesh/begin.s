# Checks the mesh's fields in the frame. The code that traces meshes has just arrived, and this is
# the first of it that runs.

        .include "work_unit.inc"
        .include "macros.inc"
        .include "driver.inc"
        .include "checks.inc"

        .set    status,3
        .set    NEXT,15
        registers a_frame,value,limit,bad,end,k_sides,k_more

        .section .data.mesh,"aw",@progbits
        .align  4
        .global sides_known, own_blocks, block_limit, kept_from
sides_known:                            # the bits of `sides` that blocks may have
        .skip   16
own_blocks:                             # how many blocks the mesh has
        .skip   16
block_limit:                            # children of inner blocks have numbers below this
        .skip   16
kept_from:                              # the first leaf of a height field, if they are kept
        .int    -1,-1,-1,-1

# mesh_begin   checks the fields, and those of the textures; gives up if one of them is wrong
#   Out     sides_known
#   Uses    $3-$7, $10-$27
function mesh_begin
        load_constant $k_sides,SIDES_BOTH|SIDES_SMOOTH
        ila     $a_frame,frame
        require_aligned mesh,LINE,Mesh
        require_from_one mesh_blocks,MESH_BLOCKS,Mesh
        stqa    $value,own_blocks
        stqa    $value,block_limit
        lqa     $value,streamed
        andi    $value,$value,FEATURE_MATERIALS
        brnz    $value,in_main_memory
        require_from_one mesh_material_count,MESH_MATERIALS,MeshMaterials
        mpyi    $limit,$value,MATERIAL_SIZE
        load_word $value,FRAME_mesh_materials,$a_frame
        ila     $end,SCENE_ADDRESS
        sf      $value,$end,$value
        andi    $bad,$value,15
        refuse_if $bad,MeshMaterials
        load_word $end,FRAME_scene_bytes,$a_frame
        clgt    $bad,$value,$end
        refuse_if $bad,MeshMaterials
        a       $limit,$limit,$value
        clgt    $bad,$limit,$end                        # where they end
        refuse_if $bad,MeshMaterials

materials_checked:
        # The cache comes after the queues.
        queue_size $value,$limit
        a       $end,$end,$value
        ila     $value,SCENE_ADDRESS
        a       $end,$end,$value
        load_word $value,FRAME_mesh_cache,$a_frame
        clgt    $bad,$end,$value
        refuse_if $bad,MeshCache
        andi    $bad,$value,LINE-1
        refuse_if $bad,MeshCache
        ila     $limit,EYE_CODE
        clgt    $bad,$value,$limit
        refuse_if $bad,MeshCache
        load_word $end,FRAME_mesh_slots,$a_frame
        ai      $bad,$end,-MESH_MIN_SLOTS
        clgti   $bad,$bad,MESH_MAX_SLOTS-MESH_MIN_SLOTS
        refuse_if $bad,MeshCache
        shli    $end,$end,MESH_BLOCK_LOG2
        a       $end,$end,$value
        clgt    $bad,$end,$limit
        refuse_if $bad,MeshCache
        stqa    $k_sides,sides_known
        lqa     $value,streamed
        il      $limit,FEATURE_TEXTURES|FEATURE_COLOURS
        and     $value,$value,$limit
        biz     $value,$lr
        enter
        andi    $value,$value,FEATURE_TEXTURES
        brz     $value,no_textures

        # The code for textures is fetched now, in front of this code.
        ilhu    $k_more,SIDES_TEXTURED>>16
        or      $k_sides,$k_sides,$k_more
        stqa    $k_sides,sides_known
        require_aligned texture_code,LINE,TextureCode
        require_at_most texture_code_bytes,TEXTURE_CODE_CAPACITY,TextureCode
        andi    $bad,$value,15
        refuse_if $bad,TextureCode
        ori     $6,$value,0
        ila     $3,TEXTURE_CODE
        load_word $4,FRAME_texture_code,$a_frame
        load_word $5,FRAME_texture_code+4,$a_frame
        il      $7,TAG_FRAME
        brsl    $lr,dma_get
        il      $3,1<<TAG_FRAME
        brsl    $lr,dma_wait
        brsl    $lr,texture_begin
no_textures:
        lqa     $value,streamed
        il      $limit,FEATURE_COLOURS
        and     $value,$value,$limit
        brz     $value,begun
        lqa     $k_sides,sides_known
        ilhu    $k_more,(SIDES_COLOURED|SIDES_VISIBILITY)>>16
        or      $k_sides,$k_sides,$k_more
        stqa    $k_sides,sides_known
        ila     $a_frame,frame
        require_aligned colour_code,LINE,ColourCode
        # In front of it is that for a height field.
        lqa     $value,streamed
        il      $limit,FEATURE_HEIGHTS
        and     $value,$value,$limit
        ceqi    $value,$value,0
        il      $6,HEIGHT_CODE_CAPACITY
        andc    $6,$6,$value
        ila     $3,COLOUR_CODE
        sf      $3,$6,$3
        load_word $4,FRAME_colour_code,$a_frame
        load_word $5,FRAME_colour_code+4,$a_frame
        il      $7,COLOUR_CODE_CAPACITY
        a       $6,$6,$7
        il      $7,TAG_FRAME
        brsl    $lr,dma_get
        il      $3,1<<TAG_FRAME
        brsl    $lr,dma_wait
        sync
        brsl    $lr,colour_begin
        lqa     $value,streamed
        il      $limit,FEATURE_HEIGHTS
        and     $value,$value,$limit
        brz     $value,begun
        brsl    $lr,height_begin
begun:  leave

        # A number is right if its upper byte is, so that mesh_prepare needs no other check.
in_main_memory:
        require_aligned materials,LINE,MeshMaterials
        require_from_one mesh_material_count,STREAMED_MATERIALS,MeshMaterials
        andi    $bad,$value,MESH_MATERIALS-1
        refuse_if $bad,MeshMaterials
        ila     $value,mesh_materials
        stqa    $value,after_hits
        ilhu    $k_more,SIDES_WIDE>>16
        or      $k_sides,$k_sides,$k_more
        load_word $end,FRAME_scene_bytes,$a_frame
        br      materials_checked
refused:
        br      give_up
endfunction mesh_begin
