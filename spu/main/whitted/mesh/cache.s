# The blocks of the mesh that are in local store. A block that has arrived is checked, and its
# positions become relative to the eye. The cache is emptied at each frame's beginning, since the
# eye moves.

        .include "work_unit.inc"
        .include "macros.inc"
        .include "driver.inc"
        .include "whitted.inc"
        .include "mesh_block.inc"

        .section .data.mesh,"aw",@progbits
        .align  4
numbers:                                # of the blocks in the slots; no block has all ones
    .rept   MESH_MAX_SLOTS
        .int    -1
    .endr
next_slot:                              # the slot that is filled next: the oldest block leaves
        .int    0,0,0,0
        .global mesh_leaves
mesh_leaves:                            # of the slots, but few blocks with the same last bits
    .rept   MESH_LEAF_PLACES
        .int    -1,-1,-1,-1
    .endr
arriving:                               # a bit for each slot whose block is on its way
        .int    0,0,0,0
wanted: .skip   16
a_wanted:                               # its address
        .skip   16
waited: .skip   16
fetched:                                # the slot plus 1
        .skip   16

        .section .rodata.mesh,"a",@progbits
        .align  4
slots_and_1:
    .set    slot,1
    .rept   MESH_MAX_SLOTS
        .int    slot
    .set    slot,slot+1
    .endr

        .set    NEXT,10
        registers t_sum,t_carry,m_splat
        registers number,in_slot,slot_and_1
        registers found                                 # the slot plus 1, or 0
        registers slot,bit,bits,address,mask
        registers slots,high,low,offset,size,tag,command,c_end

# Looks for the block $3 in the cache. $found is its slot plus 1, or 0.
.macro  find_block
        splat_mask $m_splat
        splat   $number,$3,$m_splat
        il      $found,0
    .set    quad,0
    .rept   MESH_MAX_SLOTS/4
        lqa     $in_slot,numbers+quad
        lqa     $slot_and_1,slots_and_1+quad
        ceq     $in_slot,$in_slot,$number
        and     $in_slot,$in_slot,$slot_and_1
        or      $found,$found,$in_slot
    .set    quad,quad+16
    .endr
        orx     $found,$found
.endm

# mesh_prefetch   starts to fetch a block, unless it is in the cache or on its way
#   In      $3 number
#   Uses    $3-$5, $10-$30
function mesh_prefetch
        hbr     known,$lr
        find_block
known:  binz    $found,$lr
        br      mesh_fetch
endfunction mesh_prefetch

# mesh_fetch   starts to fetch a block to the next slot
#   In      $3 number
#   Out     $16 slot plus 1
#   Uses    $3-$5, $10-$30
function mesh_fetch
        enter
        stqa    $3,wanted
        il      $mask,1
        tally   blocks_fetched,$mask
        lqa     $slot,next_slot
        ila     $slots,frame
        load_word $slots,FRAME_mesh_slots,$slots
        ai      $found,$slot,1
        ceq     $c_end,$found,$slots
        andc    $c_end,$found,$c_end
        stqa    $c_end,next_slot
        # A block that was fetched to this slot before, but never used, must have arrived.
        il      $bit,1
        shl     $bit,$bit,$slot
        lqa     $bits,arriving
        and     $mask,$bits,$bit
        or      $bits,$bits,$bit
        stqa    $bits,arriving
        brnz    $mask,unused
ready:  ila     $slots,numbers
        shli    $offset,$slot,2
        a       $offset,$offset,$slots
        lqd     $in_slot,0($offset)
        cwd     $mask,0($offset)
        lqa     $number,wanted
        rotqby  $size,$in_slot,$offset
        shufb   $in_slot,$number,$in_slot,$mask
        stqd    $in_slot,0($offset)
        # The block that leaves is no known leaf any more.
        leaf_place $address,$size
        ila     $size,mesh_leaves
        il      $high,-1
        stqx    $high,$address,$size

        ila     $slots,frame
        load_word $address,FRAME_mesh_cache,$slots
        shli    $offset,$slot,MESH_BLOCK_LOG2
        a       $address,$address,$offset
        andi    $tag,$slot,MESH_TAGS-1
        ai      $tag,$tag,TAG_MESH
        lqa     $bits,own_blocks
        clgt    $bits,$bits,$number
        brz     $bits,other
        load_word $high,FRAME_mesh,$slots
        load_word $low,FRAME_mesh+4,$slots
        rotmi   $offset,$number,MESH_BLOCK_LOG2-32
        a       $high,$high,$offset
        shli    $offset,$number,MESH_BLOCK_LOG2
        add_effective $high,$low,$offset,$t_carry
        il      $size,MESH_BLOCK
        il      $command,MFC_GET
        mfc_command $address,$high,$low,$size,$tag,$command
        leave

        # A block of a height field.
other:  lqa     $bits,block_limit
        ori     $4,$number,0
        clgt    $bits,$bits,$number
        brz     $bits,bad_block
        stqa    $found,fetched
        ori     $3,$number,0
        ori     $4,$address,0
        ori     $5,$tag,0
        brsl    $lr,height_fetch
        lqa     $found,fetched
        leave

unused: andi    $tag,$slot,MESH_TAGS-1
        il      $3,1<<TAG_MESH
        shl     $3,$3,$tag
        brsl    $lr,dma_wait
        br      ready
endfunction mesh_fetch

# mesh_block   finds a block, and waits for it if it is not in the cache
#   In      $3 number
#   Out     $3 address
#   Uses    $3-$79
function mesh_block
        hbr     in_cache,$lr
        enter
        stqa    $3,wanted
        il      $mask,1
        tally   blocks_used,$mask
        find_block
        brz     $found,missing
found_it:
        ai      $slot,$found,-1
        ila     $slots,frame
        load_word $address,FRAME_mesh_cache,$slots
        shli    $offset,$slot,MESH_BLOCK_LOG2
        a       $address,$address,$offset
        il      $bit,1
        shl     $bit,$bit,$slot
        lqa     $bits,arriving
        and     $mask,$bits,$bit
        brnz    $mask,wait
        ori     $3,$address,0
        ai      $sp,$sp,32
        lqd     $lr,16($sp)
in_cache:
        bi      $lr

missing:
        brsl    $lr,mesh_fetch
        br      found_it

wait:   hbrr    wait_call,dma_wait
        andc    $bits,$bits,$bit
        stqa    $bits,arriving
        stqa    $address,a_wanted
        stqa    $g_dma_wait,waited
        phase_ends $g_ticks_cull,$t_sum
        andi    $tag,$slot,MESH_TAGS-1
        il      $3,1
        ai      $tag,$tag,TAG_MESH
        shl     $3,$3,$tag
wait_call:
        brsl    $lr,dma_wait
        hbrr    arrive_call,mesh_arrive
        phase_begins
        lqa     $size,waited
        sf      $size,$size,$g_dma_wait
        tally   ticks_block_wait,$size
        lqa     $3,a_wanted
        lqa     $4,wanted
arrive_call:
        brsl    $lr,mesh_arrive
        lqa     $3,a_wanted
        leave
endfunction mesh_block
