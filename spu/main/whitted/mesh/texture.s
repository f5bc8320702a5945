# Textures of the mesh: multiplies the colours of surfaces by those of their texels. Tiles of
# textures are fetched into a cache, in which the oldest one leaves.
#
# This file and its kernels are in local store only in frames with FEATURE_TEXTURES, at
# TEXTURE_CODE, and the tiles after them, at TEXTURE_CACHE.

        .include "work_unit.inc"
        .include "macros.inc"
        .include "driver.inc"
        .include "checks.inc"
        .include "whitted.inc"
        .include "flat_light.inc"

        # The bounds' shears are made again before they are needed.
        .set    TEXEL_BUFFER,BATCH_SHEARS

        .section .data.texture,"aw",@progbits
        .align  4
tiles:                                  # of the textures in the slots; no tile has all ones
    .rept   TEXTURE_SLOTS
        .int    -1
    .endr
next_slot:                              # the slot that is filled next, unless the packet needs it
        .int    0,0,0,0
surfaces:
        .skip   16
rays:   .skip   16

        .section .rodata.texture,"a",@progbits
        .align  4
slots_and_1:
    .set    slot_and_1,1
    .rept   TEXTURE_SLOTS
        .int    slot_and_1
    .set    slot_and_1,slot_and_1+1
    .endr

        .set    status,3
        .set    NEXT,15
        registers a_frame,value,limit,bad,table,levels,count,left,record,rows,first,material

# texture_begin   checks the textures' fields in the frame; gives up if any is wrong
#   Uses    $3, $15-$27
function texture_begin
        ila     $a_frame,frame
        ila     $value,texture_packet
        stqa    $value,surface_way
        require_aligned textures,LINE,Textures
        require_from_one texture_tiles,TEXTURE_TILES,Textures
        # The mesh's cache ends before this code.
        load_word $value,FRAME_mesh_slots,$a_frame
        shli    $value,$value,MESH_BLOCK_LOG2
        load_word $limit,FRAME_mesh_cache,$a_frame
        a       $value,$value,$limit
        ila     $limit,TEXTURE_CODE
        clgt    $bad,$value,$limit
        refuse_if $bad,MeshCache

        # The table of textures and levels.
        require_from_one texture_count,MESH_TEXTURES,TextureRecords
        ori     $count,$value,0
        require_from_one texture_level_count,TEXTURE_LEVELS,TextureRecords
        load_word $table,FRAME_texture_records,$a_frame
        ila     $limit,SCENE_ADDRESS
        sf      $limit,$limit,$table
        andi    $bad,$limit,15
        refuse_if $bad,TextureRecords
        load_word $left,FRAME_scene_bytes,$a_frame
        clgt    $bad,$limit,$left
        refuse_if $bad,TextureRecords
        a       $value,$value,$count
        shli    $value,$value,4
        a       $limit,$limit,$value
        clgt    $bad,$limit,$left                       # where it ends
        refuse_if $bad,TextureRecords

        # Each texture has some of the levels.
        shli    $levels,$count,4
        a       $levels,$levels,$table
        ori     $left,$count,0
        load_word $count,FRAME_texture_level_count,$a_frame
next_texture:
        lqd     $record,0($table)
        sf      $value,$levels,$record
        andi    $bad,$value,15
        brnz    $bad,wrong
        rotmi   $value,$value,-4
        rotqbyi $limit,$record,TEXTURE_last
        clgt    $bad,$count,$limit                      # so that the sum is no larger than 2^31
        brz     $bad,wrong
        a       $limit,$limit,$value
        clgt    $bad,$count,$limit
        brz     $bad,wrong
        ai      $table,$table,TEXTURE_SIZE
        ai      $left,$left,-1
        brnz    $left,next_texture

        # Each level has some of the tiles. Where a texture's begin is checked with each tile.
        ori     $left,$count,0
        load_word $count,FRAME_texture_tiles,$a_frame
next_level:
        lqd     $record,0($levels)
        cflts   $value,$record,0
        ai      $bad,$value,-1
        il      $limit,MAX_TEXTURE_SIDE-1
        clgt    $bad,$bad,$limit
        brnz    $bad,wrong
        rotqbyi $rows,$record,LEVEL_height
        cflts   $rows,$rows,0
        ai      $bad,$rows,-1
        clgt    $bad,$bad,$limit
        brnz    $bad,wrong
        rotmi   $value,$value,-3
        ai      $value,$value,1
        rotqbyi $limit,$record,LEVEL_across
        ceq     $bad,$value,$limit
        brz     $bad,wrong
        rotmi   $rows,$rows,-3
        ai      $rows,$rows,1
        mpyu    $rows,$rows,$value
        rotqbyi $first,$record,LEVEL_first
        clgt    $bad,$first,$count
        brnz    $bad,wrong
        a       $first,$first,$rows
        clgt    $bad,$first,$count
        brnz    $bad,wrong
        ai      $levels,$levels,LEVEL_SIZE
        ai      $left,$left,-1
        brnz    $left,next_level

        # Each material of the mesh has one of the textures, or none. In main memory they may have
        # anything, since nothing but tiles is ever fetched.
        lqa     $value,streamed
        andi    $value,$value,FEATURE_MATERIALS
        binz    $value,$lr
        load_word $table,FRAME_texture_records,$a_frame
        load_word $count,FRAME_texture_count,$a_frame
        load_word $material,FRAME_mesh_materials,$a_frame
        load_word $left,FRAME_mesh_material_count,$a_frame
next_material:
        load_word $value,MATERIAL_texture,$material
        brz     $value,has_none
        sf      $value,$table,$value
        andi    $bad,$value,15
        brnz    $bad,wrong
        rotmi   $value,$value,-4
        clgt    $bad,$count,$value
        brz     $bad,wrong
has_none:
        ai      $material,$material,MATERIAL_SIZE
        ai      $left,$left,-1
        brnz    $left,next_material
        bi      $lr
wrong:  il      $status,STATUS_Texture
refused:
        br      give_up
endfunction texture_begin

# texture_packet   multiplies the colours of a packet's surfaces by those of their texels
#   In      $3 rays, $4 surfaces
#   Out     $3 and $4 the same, $14 the surfaces' flags
#   Uses    $3-$79
        .set    NEXT,10
        registers tile                                  # to 13: the rays' tiles, later all ones
        .set    NEXT,tile+4
        registers place                                 # to 17
        .set    NEXT,place+4
        registers most,other,c_more,same,m_splat
        registers used                                  # a bit for each slot that the packet needs
        registers fetched                               # whether a tile is on its way
        registers found,slot,in_slot,slot_and_1,bit,mask,address
        registers high,low,offset,size,tag,command,t_carry,slots

# most = the larger one of most and other, signed.
.macro  larger
        cgt     $c_more,$other,$most
        selb    $most,$most,$other,$c_more
.endm

function texture_packet
        hbrr    places_call,texture_places_r16
        enter
        stqa    $3,rays
        stqa    $4,surfaces
        ila     $5,arena+TEXEL_BUFFER
        ila     $6,frame
        load_word $6,FRAME_pixel_angle,$6
places_call:
        brsl    $lr,texture_places_r16
        ila     $3,arena+TEXEL_BUFFER
    .irp row, 0,1,2,3
        lqd     $tile+\row,TEXELS_tile+16*\row($3)
        lqd     $place+\row,TEXELS_place+16*\row($3)
    .endr
        il      $used,0
        il      $fetched,0
        splat_mask $m_splat
next_tile:
        # The largest number of a tile that has no address yet, in all lanes.
        ori     $most,$tile,0
    .irp row, 1,2,3
        ori     $other,$tile+\row,0
        larger
    .endr
        rotqbyi $other,$most,8
        larger
        rotqbyi $other,$most,4
        larger
        rotmi   $c_more,$most,-31
        brnz    $c_more,all_found
        il      $found,0
    .set    quad,0
    .rept   TEXTURE_SLOTS/4
        lqa     $in_slot,tiles+quad
        lqa     $slot_and_1,slots_and_1+quad
        ceq     $in_slot,$in_slot,$most
        and     $in_slot,$in_slot,$slot_and_1
        or      $found,$found,$in_slot
    .set    quad,quad+16
    .endr
        orx     $found,$found
        ai      $slot,$found,-1
        brz     $found,missing
in_cache:
        il      $bit,1
        count   texture_tiles_used,$bit,$high,$low,$t_carry
        shl     $bit,$bit,$slot
        or      $used,$used,$bit
        mpyi    $address,$slot,TEXTURE_TILE
        ila     $offset,TEXTURE_CACHE
        a       $address,$address,$offset
        splat   $address,$address,$m_splat
    .irp row, 0,1,2,3
        ceq     $same,$tile+\row,$most
        and     $other,$address,$same
        a       $place+\row,$place+\row,$other
        or      $tile+\row,$tile+\row,$same
    .endr
        br      next_tile

all_found:
        ila     $3,arena+TEXEL_BUFFER
    .irp row, 0,1,2,3
        stqd    $place+\row,TEXELS_place+16*\row($3)
    .endr
        brnz    $fetched,wait
filter: hbrr    filter_call,texture_filter_r16
        lqa     $4,surfaces
        # Texels are square roots of light where pixels have sRGB's values.
        ila     $3,frame
        load_word $5,FRAME_features,$3
        andi    $5,$5,FEATURE_SRGB
        ceqi    $5,$5,0
        nor     $5,$5,$5
        ila     $3,arena+TEXEL_BUFFER
filter_call:
        brsl    $lr,texture_filter_r16
        lqa     $3,rays
        lqa     $4,surfaces
        lqd     $14,SURFACES_flags($4)
        # As leave does, but the test waits for nothing else.
        ai      $sp,$sp,32
        lqd     $lr,16($sp)
        andi    $same,$14,MATERIAL_FLAT
        brnz    $same,texture_flat
        bi      $lr

wait:   phase_ends $g_ticks_shade,$same
        load_constant $3,1<<TAG_TEXTURE
        brsl    $lr,dma_wait
        phase_begins
        br      filter

        # A packet needs no more tiles than there are slots, so one is always free.
missing:
        lqa     $slot,next_slot
taken:  il      $bit,1
        shl     $bit,$bit,$slot
        and     $mask,$used,$bit
        ai      $found,$slot,1
        andi    $found,$found,TEXTURE_SLOTS-1
        brz     $mask,free
        ori     $slot,$found,0
        br      taken
free:   stqa    $found,next_slot
        # With any contents of the records, only tiles are fetched.
        ila     $slots,frame
        load_word $size,FRAME_texture_tiles,$slots
        clgt    $mask,$size,$most
        brz     $mask,no_tile
        shli    $offset,$slot,2
        ila     $address,tiles
        a       $offset,$offset,$address
        lqd     $in_slot,0($offset)
        cwd     $mask,0($offset)
        shufb   $in_slot,$most,$in_slot,$mask
        stqd    $in_slot,0($offset)
        load_word $high,FRAME_textures,$slots
        load_word $low,FRAME_textures+4,$slots
        # Three lines: there are at most 2^20 tiles, so the product is less than 2^32.
        shli    $offset,$most,7
        add_effective $high,$low,$offset,$t_carry
        shli    $offset,$most,8
        add_effective $high,$low,$offset,$t_carry
        mpyi    $address,$slot,TEXTURE_TILE
        ila     $offset,TEXTURE_CACHE
        a       $address,$address,$offset
        il      $size,TEXTURE_TILE
        il      $tag,TAG_TEXTURE
        il      $command,MFC_GET
        mfc_command $address,$high,$low,$size,$tag,$command
        il      $fetched,1
        count   texture_tiles_fetched,$fetched,$high,$low,$t_carry
        br      in_cache

no_tile:
        il      $3,STATUS_Texture
        br      give_up
endfunction texture_packet

        transpose_table .rodata.texture
        flat_light texture_flat
