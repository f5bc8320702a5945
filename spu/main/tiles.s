# A tile: its position, the spheres in its frustum, and the transfer of its pixels.

        .include "work_unit.inc"
        .include "macros.inc"
        .include "driver.inc"
        .include "whitted.inc"

        # The pixels of a subtile.
        .set    SUBTILE_PIXELS_LOG2,5
    .if SUBTILE_WIDTH*SUBTILE_HEIGHT != 1<<SUBTILE_PIXELS_LOG2
        .error  "a subtile has other pixels"
    .endif

        quadword_constants
        # words of two quadwords A and B
pair:   .int    0x00010203,0x10111213,0x00010203,0x10111213 # A0 B0 A0 B0
second: .int    0x00010203,0x04050607,0x08090a0b,0x10111213 # A0 A1 A2 B0

        .section .bss
        .align  7
        .global tile_buffers
# Double buffering: a tile is traced into one buffer while the MFC puts the other.
tile_buffers:
        .skip   2*TILE_BYTES
tile_lists:                             # two lists, then EMPTY_LISTS for empty tiles
        .skip   (2+EMPTY_LISTS)*LIST_BYTES

        .set    across,10
        .set    q,11
        .set    c_over,12
        .set    limit,13

# tile_place   computes a tile's position
#   In      $3 its number, within the picture
#   Out     g_tile_x to g_row_bytes
#   Uses    $3, $10-$13
function tile_place
        # The quotient by the number of tiles across may be too small or too large by one.
        csflt   $q,$3,0
        lqa     $limit,inverse_across
        fm      $q,$q,$limit
        cflts   $q,$q,0
        mpyu    $across,$q,$g_across
        sf      $g_tile_x,$across,$3
        cgti    $c_over,$g_tile_x,-1
        nor     $c_over,$c_over,$c_over                 # -1 if one too large
        a       $q,$q,$c_over
        and     $across,$g_across,$c_over
        a       $g_tile_x,$g_tile_x,$across
        clgt    $c_over,$g_across,$g_tile_x
        nor     $c_over,$c_over,$c_over                 # -1 if one too small
        sf      $q,$c_over,$q
        and     $across,$g_across,$c_over
        sf      $g_tile_x,$across,$g_tile_x
        shli    $g_tile_x,$g_tile_x,TILE_WIDTH_LOG2
        shli    $g_tile_y,$q,TILE_HEIGHT_LOG2
        sf      $g_tile_width,$g_tile_x,$g_width
        il      $limit,TILE_WIDTH
        minimum $g_tile_width,$g_tile_width,$limit,$c_over
        sf      $g_tile_height,$g_tile_y,$g_height
        il      $limit,TILE_HEIGHT
        minimum $g_tile_height,$g_tile_height,$limit,$c_over
        ai      $g_row_bytes,$g_tile_width,3
        andi    $g_row_bytes,$g_row_bytes,-4
        shli    $g_row_bytes,$g_row_bytes,2
        bi      $lr
endfunction tile_place

# tile_trace   makes the current tile's pixels, and starts to send them
#   Out     $3 the flags for its cost
#   Uses    $3-$79, the tile's and the groups' driver registers
        .set    amount,10
        .set    t_sum,11
        .set    t_add,12
        .set    t_carry,13
        .set    packets_down,14
        .set    one,15
        .set    was,16
        .set    kept,17

.macro  packets_of_tile out:req, t_down:req
        ai      \out,$g_tile_width,3
        rotmi   \out,\out,-2
        ai      \t_down,$g_tile_height,3
        rotmi   \t_down,\t_down,-2
        mpyu    \out,\out,\t_down
.endm

# Counts the current tile, its rays and its packets, less those of kept pixels.
.macro  count_traced
        il      $one,1
        count   tiles,$one,$t_sum,$t_add,$t_carry
        mpyu    $amount,$g_tile_width,$g_tile_height
        sf      $amount,$kept,$amount
        count   primary_rays,$amount,$t_sum,$t_add,$t_carry
        packets_of_tile $amount,$packets_down
        rotmi   $kept,$kept,-4
        sf      $amount,$kept,$amount
        count   packets,$amount,$t_sum,$t_add,$t_carry
.endm

function tile_trace
        enter
        lqa     $one,frame
        rotqbyi $one,$one,FRAME_features
        andi    $one,$one,FEATURE_WHITTED
        brnz    $one,whitted
        il      $kept,0
        count_traced
        brz     $g_spheres,empty
        brz     $g_skip,trace
        phase_begins
        count   cull_tests,$g_spheres,$t_sum,$t_add,$t_carry
        brsl    $lr,tile_planes
        ila     $3,frustum
        ila     $4,spheres
        ori     $5,$g_spheres,0
        ila     $6,active
        brsl    $lr,frustum_spheres
        ila     $g_active,active
        sf      $g_active,$g_active,$3
        rotmi   $g_active,$g_active,-PAIR_SIZE_LOG2
        phase_ends $g_ticks_cull,$amount
        brz     $g_active,empty
trace:
        # The buffer is free when its rows of two tiles ago have been sent.
        il      $3,1<<TAG_TILE
        shl     $3,$3,$g_parity
        brsl    $lr,dma_wait
        brsl    $lr,tile_pixels
        brz     $3,empty
        lqa     $one,contrast
        cgti    $one,$one,-1
        brnz    $one,samples
send:   ori     $3,$g_parity,0
        ori     $4,$g_parity,0
        xori    $g_parity,$g_parity,1
        brsl    $lr,tile_put
        il      $3,0
        leave

samples:
        brsl    $lr,tile_samples
        br      send

whitted:
        brsl    $lr,paths_begin
        # How many of the subtiles are kept, and their pixels.
        nor     $kept,$3,$3
        cntb    $kept,$kept
        sumb    $kept,$kept,$kept
        andi    $kept,$kept,0x3f
        shli    $kept,$kept,SUBTILE_PIXELS_LOG2
        mpyu    $amount,$g_tile_width,$g_tile_height
        minimum $kept,$kept,$amount,$t_sum
        count   pixels_kept,$kept,$t_sum,$t_add,$t_carry
        brz     $3,nothing
        count_traced
        il      $3,1<<TAG_TILE
        shl     $3,$3,$g_parity
        brsl    $lr,dma_wait
        if_whole whole,$kept
        # The subtiles that are kept are in the framebuffer.
        ori     $3,$g_parity,0
        ori     $4,$g_parity,0
        il      $5,MFC_GETL
        brsl    $lr,tile_move
whole:  brsl    $lr,whitted_tile
        ori     $3,$g_parity,0
        ori     $4,$g_parity,0
        xori    $g_parity,$g_parity,1
        brsl    $lr,tile_put
        brsl    $lr,paths_end
        if_whole ended,$kept
        ilhu    $one,TILE_KEPT>>16
        or      $3,$3,$one
ended:  leave
nothing:
        il      $one,1
        count   tiles_kept,$one,$t_sum,$t_add,$t_carry
        ilhu    $3,(TILE_KEPT|TILE_HAS_PATHS)>>16
        leave

empty:
        il      $one,1
        count   tiles_empty,$one,$t_sum,$t_add,$t_carry
        packets_of_tile $amount,$packets_down
        count   packets_empty,$amount,$t_sum,$t_add,$t_carry
        lqa     $was,tile_flags
        rotmi   $was,$was,-31
        brnz    $was,blank
        il      $3,1<<TAG_EMPTY
        shl     $3,$3,$g_empty_turn
        brsl    $lr,dma_wait
        ai      $4,$g_empty_turn,2
        ai      $g_empty_turn,$g_empty_turn,1
        andi    $g_empty_turn,$g_empty_turn,EMPTY_LISTS-1
        brsl    $lr,tile_put
        br      is_blank
blank:
        count   tiles_blank,$one,$t_sum,$t_add,$t_carry
is_blank:
        ilhu    $3,TILE_BLANK>>16
        leave
endfunction tile_trace

# tile_put   starts to send the current tile to the framebuffer
#   In      $4 which of the lists and tags, $3 which of the tile buffers; of the first two lists
#   Uses    $3-$5, $10-$31
#
# tile_move   does the same, or fetches it
#   In      as tile_put, $5 MFC_PUTL or MFC_GETL
#   Uses    the same
#
# One list command moves all rows. A list's elements share the high word of the address, so a tile
# that crosses a multiple of 4 GB is moved row by row instead.
        .set    a_buffer,3
        .set    list,4
        .set    way,5
        .set    offset,11
        .set    high,12
        .set    low,13
        .set    t_carry,14
        .set    rows,15
        .set    last,16
        .set    c_across,17
        .set    tag,18
        .set    command,19
        .set    a_list,20
        .set    elements,21
        .set    step,22
        .set    m_pair,23
        .set    m_second,24
        .set    bytes,25
        .set    low_next,26

function tile_put
        il      $way,MFC_PUTL
tile_move:
        il      $offset,TILE_BYTES
        mpyu    $offset,$offset,$a_buffer
        ila     $a_buffer,tile_buffers
        a       $a_buffer,$a_buffer,$offset
        ai      $tag,$list,TAG_TILE
        cgti    $c_across,$list,1
        ila     $offset,empty_tile
        selb    $a_buffer,$a_buffer,$offset,$c_across
        ai      $offset,$list,TAG_EMPTY-2
        selb    $tag,$tag,$offset,$c_across
        mpyu    $offset,$g_tile_y,$g_stride
        ori     $high,$g_buffer_high,0
        ori     $low,$g_buffer_low,0
        add_effective $high,$low,$offset,$t_carry
        shli    $offset,$g_tile_x,2
        add_effective $high,$low,$offset,$t_carry

        ai      $rows,$g_tile_height,-1
        mpyu    $last,$rows,$g_stride
        a       $last,$last,$g_row_bytes
        ai      $last,$last,-1
        a       $last,$last,$low
        clgt    $c_across,$low,$last
        brnz    $c_across,row_by_row

        # A quadword has two elements: bytes, address, and bytes, address of the next row.
        il      $offset,LIST_BYTES
        mpyu    $offset,$offset,$list
        ila     $a_list,tile_lists
        a       $a_list,$a_list,$offset
        a       $low_next,$low,$g_stride
        lqa     $m_pair,pair
        lqa     $m_second,second
        shufb   $elements,$g_row_bytes,$low,$m_pair
        shufb   $elements,$elements,$low_next,$m_second
        shli    $step,$g_stride,1
        il      $offset,0
        shufb   $step,$offset,$step,$m_pair
    .irp line, 0,1,2,3,4,5,6,7
        stqd    $elements,16*\line($a_list)
        a       $elements,$elements,$step
    .endr
    .if LIST_BYTES != 8*16
        .error  "the list above is of other tiles"
    .endif
        shli    $bytes,$g_tile_height,3
        ori     $command,$way,0
        mfc_command $a_buffer,$high,$a_list,$bytes,$tag,$command
        bi      $lr

row_by_row:
        ai      $command,$way,MFC_PUT-MFC_PUTL
next_put:
        mfc_command $a_buffer,$high,$low,$g_row_bytes,$tag,$command
        biz     $rows,$lr
        a       $a_buffer,$a_buffer,$g_row_bytes
        add_effective $high,$low,$g_stride,$t_carry
        ai      $rows,$rows,-1
        br      next_put
endfunction tile_put
