# Work units. Each is taken before the previous one is traced, so that its tiles' numbers have
# arrived when they are needed. The tiles' costs are sent back.

        .include "work_unit.inc"
        .include "macros.inc"
        .include "driver.inc"

        .section .bss
        .align  7
        # There are two of each, which are used in turn.
        .global units
units:  .skip   2*UNIT_SIZE
costs:  .skip   2*COST_SIZE
counter:
        .skip   COUNTER_SIZE
        .global tile_flags
tile_flags:                             # TILE_BLANK and TILE_HAS_PATHS, for the current tile
        .skip   16
        .global tile_number
tile_number:                            # its number in the picture
        .skip   16

        .set    a_unit,10
        .set    tiles,11
        .set    bad,12
        .set    a_word,13
        .set    ticks,14
        .set    quad,15
        .set    mask,16
        .set    blank,17

# units_trace   traces this SPU's share of the frame; at its end all pixels are in main memory
#   Out     $3 STATUS_ value
#   Uses    $3-$79, the units' and tiles' driver registers
function units_trace
        enter
        il      $g_turn,0
        il      $g_parity,0
        il      $g_empty_turn,0
        brsl    $lr,unit_first
        brsl    $lr,unit_request
        brsl    $lr,refine_prepare
        lqa     $bad,frame
        rotqbyi $bad,$bad,FRAME_features
        andi    $bad,$bad,FEATURE_WHITTED
        brnz    $bad,whitted
        brsl    $lr,planes_prepare
        # The code for depth shading comes with the scene.
        il      $3,1<<TAG_FRAME
        brsl    $lr,dma_wait
        sync
        brsl    $lr,pixels_prepare
        br      prepared
whitted:
        brsl    $lr,queue_prepare
        brsl    $lr,batch_place
        brsl    $lr,bvhs_plan
        brsl    $lr,shading_prepare
        brsl    $lr,paths_prepare
prepared:
        phase_ends $g_ticks_fetch,$bad
        il      $3,1<<TAG_FRAME
        brsl    $lr,dma_wait
        sync                                            # there may be code with the scene
        lqa     $bad,frame
        rotqbyi $bad,$bad,FRAME_features
        andi    $bad,$bad,FEATURE_WHITTED
        brz     $bad,next_unit
        lqa     $bad,streamed
        brz     $bad,next_unit
        brsl    $lr,mesh_begin

next_unit:
        take_unit all_traced,$a_unit
        load_word $tiles,UNIT_count,$g_a_unit
        ai      $bad,$tiles,-1                          # 0 becomes the largest
        clgti   $bad,$bad,UNIT_TILES-1
        brnz    $bad,refuse
        store_word $tiles,2*UNIT_SIZE+COST_count,$g_a_unit,$quad,$mask
        il      $g_index,0
        rdch    $g_tile_began,$SPU_RdDec
next_tile:
        shli    $a_word,$g_index,2
        ai      $a_word,$a_word,UNIT_tiles
        lqx     $3,$g_a_unit,$a_word
        rotqby  $3,$3,$a_word
        ilhu    $blank,(TILE_BLANK|TILE_HAS_PATHS)>>16
        and     $blank,$3,$blank
        stqa    $blank,tile_flags
        xor     $3,$3,$blank
        stqa    $3,tile_number
        clgt    $bad,$g_tiles,$3
        brz     $bad,refuse
        brsl    $lr,tile_place
        brsl    $lr,tile_trace
        times_checked tile_late,$ticks,$bad
tile_timed:
        sf      $bad,$ticks,$g_tile_began               # it counts down
        ori     $g_tile_began,$ticks,0
        or      $bad,$bad,$3
        shli    $a_word,$g_index,2
        ai      $a_word,$a_word,2*UNIT_SIZE+COST_ticks
        a       $a_unit,$g_a_unit,$a_word
        lqd     $quad,0($a_unit)
        cwd     $mask,0($a_unit)
        shufb   $quad,$bad,$quad,$mask
        stqd    $quad,0($a_unit)
        ai      $g_index,$g_index,1
        load_word $tiles,UNIT_count,$g_a_unit
        cgt     $bad,$tiles,$g_index
        brnz    $bad,next_tile
        brsl    $lr,costs_put
        br      next_unit

tile_late:
        brsl    $lr,times_add
        rdch    $ticks,$SPU_RdDec
        br      tile_timed

refuse: il      $g_unit,STATUS_Tile
        br      settle
all_traced:
        il      $g_unit,STATUS_Done
settle: il      $3,ALL_TAGS
        brsl    $lr,dma_wait
        ori     $3,$g_unit,0
        leave
endfunction units_trace

# unit_first   finds the number of this SPU's first unit: of its slice, or from the shared counter
#   Out     g_unit_next, g_unit_end
#   Uses    $10-$19
        .set    a_slice,10
        .set    a_frame,11

function unit_first
        brz     $g_split,unit_next
        ila     $a_frame,frame
        shli    $a_slice,$g_number,2
        ai      $a_slice,$a_slice,FRAME_slices
        lqx     $g_unit_next,$a_frame,$a_slice
        rotqby  $g_unit_next,$g_unit_next,$a_slice
        ai      $a_slice,$a_slice,4
        lqx     $g_unit_end,$a_frame,$a_slice
        rotqby  $g_unit_end,$g_unit_end,$a_slice
        br      slice_check
endfunction unit_first

# unit_next   finds the number of the next unit; g_units or more if there is none
#   Out     g_unit_next
#   Uses    $10-$19
        .set    low,11
        .set    high,12
        .set    a_counter,13
        .set    command,14
        .set    result,15
        .set    c_more,16
        .set    raised,17
        .set    line,18
        .set    m_word,19

function unit_next
        brnz    $g_split,slice_next
        ila     $a_counter,frame
        load_word $high,FRAME_unit_counter,$a_counter
        load_word $low,FRAME_unit_counter+4,$a_counter
        ila     $a_counter,counter
        rdch    $raised,$SPU_RdDec
        a       $g_dma_wait,$g_dma_wait,$raised
take:
        # The line is fetched with a reservation, and stored only if no other SPU has stored it
        # since. These two commands ignore size and tag.
        il      $command,MFC_GETLLAR
        mfc_command $a_counter,$high,$low,$command,$command,$command
        rdch    $result,$MFC_RdAtomicStat
        load_word $g_unit_next,COUNTER_next,$a_counter
        clgt    $c_more,$g_units,$g_unit_next
        brz     $c_more,taken
        ai      $raised,$g_unit_next,1
        store_word $raised,COUNTER_next,$a_counter,$line,$m_word
        il      $command,MFC_PUTLLC
        mfc_command $a_counter,$high,$low,$command,$command,$command
        rdch    $result,$MFC_RdAtomicStat
        andi    $result,$result,PUTLLC_FAILED
        brnz    $result,take
taken:
        rdch    $raised,$SPU_RdDec
        sf      $g_dma_wait,$raised,$g_dma_wait
        bi      $lr

slice_next:
        ai      $g_unit_next,$g_unit_next,1
slice_check:
        clgt    $c_more,$g_unit_end,$g_unit_next
        binz    $c_more,$lr
        ori     $g_unit_next,$g_units,0
        bi      $lr
endfunction unit_next

# unit_request   starts to fetch the unit of g_unit_next, if there is one
#   Uses    $10-$19
        .set    offset,10
        .set    a_frame,13
        .set    size,15
        .set    tag,17
        .set    t_carry,18

function unit_request
        clgt    $c_more,$g_units,$g_unit_next
        biz     $c_more,$lr
        ila     $a_frame,frame
        load_word $high,FRAME_units,$a_frame
        load_word $low,FRAME_units+4,$a_frame
        shli    $offset,$g_unit_next,UNIT_SIZE_LOG2
        add_effective $high,$low,$offset,$t_carry
        shli    $offset,$g_turn,UNIT_SIZE_LOG2
        ila     $a_frame,units
        a       $a_frame,$a_frame,$offset
        il      $size,UNIT_SIZE
        il      $tag,TAG_UNIT
        il      $command,MFC_GET
        mfc_command $a_frame,$high,$low,$size,$tag,$command
        bi      $lr
endfunction unit_request

# costs_put   starts to send the costs of the current unit's tiles
#   Uses    $10-$19
        .set    a_costs,16

function costs_put
        ila     $a_frame,frame
        load_word $high,FRAME_costs,$a_frame
        load_word $low,FRAME_costs+4,$a_frame
        shli    $offset,$g_unit,COST_SIZE_LOG2
        add_effective $high,$low,$offset,$t_carry
        ai      $a_costs,$g_a_unit,2*UNIT_SIZE
        xori    $tag,$g_turn,1
        ai      $tag,$tag,TAG_COST
        il      $size,COST_SIZE
        il      $command,MFC_PUT
        mfc_command $a_costs,$high,$low,$size,$tag,$command
        bi      $lr
endfunction costs_put
