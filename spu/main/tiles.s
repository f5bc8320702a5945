# Tiles: taken one after the other, traced packet by packet, sent to the framebuffer.

        .include "work_unit.inc"
        .include "macros.inc"
        .include "driver.inc"

        .section .rodata
        .align  4
lanes:  .int    0,1,2,3
        # words of two quadwords A and B
pair:   .int    0x00010203,0x10111213,0x00010203,0x10111213 # A0 B0 A0 B0
second: .int    0x00010203,0x04050607,0x08090a0b,0x10111213 # A0 A1 A2 B0

        .section .bss
        .align  7
tile_buffers:
        .skip   2*TILE_BYTES
tile_lists:
        .skip   2*LIST_BYTES
counter:
        .skip   COUNTER_SIZE
        .global packet, colours
packet: .skip   PACKET_SIZE
colours:
        .skip   COLOURS_SIZE

# tiles_trace   traces this SPU's share of the frame; all pixels are in main memory at its end
#   Uses    $3-$7, $10-$49, the tile's driver registers
function tiles_trace
        enter
        .set    tiles_down,10
        .set    c_end,12
        .set    mask,13

        ai      $g_across,$g_width,TILE_WIDTH-1
        rotmi   $g_across,$g_across,-6
        ai      $tiles_down,$g_height,TILE_HEIGHT-1
        rotmi   $tiles_down,$tiles_down,-4
    .if TILE_WIDTH != 1<<6 || TILE_HEIGHT != 1<<4
        .error  "the shifts above are of other tiles"
    .endif
        mpyu    $g_tiles,$g_across,$tiles_down
        il      $g_row_first,0
        il      $g_tile_y,0
        il      $g_parity,0
        brsl    $lr,tile_first
next_tile:
        clgt    $c_end,$g_tiles,$g_tile
        brz     $c_end,no_more
        brsl    $lr,tile_place

        # The buffer is free when the rows that it held two tiles ago have gone.
        il      $mask,1<<TAG_TILE
        shl     $3,$mask,$g_parity
        brsl    $lr,dma_wait
        brsl    $lr,tile_trace
        brsl    $lr,tile_put
        xori    $g_parity,$g_parity,1
        ai      $g_n_tiles,$g_n_tiles,1
        brsl    $lr,tile_next
        br      next_tile
no_more:
        il      $3,ALL_TAGS
        brsl    $lr,dma_wait
        leave
endfunction tiles_trace

# tile_first   the first tile of this SPU: of its slice, or from the shared counter
#   Out     g_tile, g_tile_end
#   Uses    $10-$19
function tile_first
        .set    a_slice,10
        .set    a_frame,11
        brz     $g_split,tile_next
        ila     $a_frame,frame
        shli    $a_slice,$g_number,2
        ai      $a_slice,$a_slice,FRAME_slices
        lqx     $g_tile,$a_frame,$a_slice
        rotqby  $g_tile,$g_tile,$a_slice
        ai      $a_slice,$a_slice,4
        lqx     $g_tile_end,$a_frame,$a_slice
        rotqby  $g_tile_end,$g_tile_end,$a_slice
        br      slice_check
endfunction tile_first

# tile_next   the next tile; g_tiles or more if there is none
#   Out     g_tile
#   Uses    $10-$19
function tile_next
        .set    low,11
        .set    high,12
        .set    a_counter,13
        .set    command,14
        .set    result,15
        .set    c_more,16
        .set    raised,17
        .set    line,18
        .set    m_word,19
        brnz    $g_split,slice_next
        ila     $a_counter,frame
        load_word $high,FRAME_tile_counter,$a_counter
        load_word $low,FRAME_tile_counter+4,$a_counter
        ila     $a_counter,counter
take:
        # The line is fetched with a reservation, and stored only if nobody has stored it since.
        # Size and tag do not count for these two commands.
        il      $command,MFC_GETLLAR
        mfc_command $a_counter,$high,$low,$command,$command,$command
        rdch    $result,$MFC_RdAtomicStat
        load_word $g_tile,COUNTER_next,$a_counter
        clgt    $c_more,$g_tiles,$g_tile
        biz     $c_more,$lr
        ai      $raised,$g_tile,1
        store_word $raised,COUNTER_next,$a_counter,$line,$m_word
        il      $command,MFC_PUTLLC
        mfc_command $a_counter,$high,$low,$command,$command,$command
        rdch    $result,$MFC_RdAtomicStat
        andi    $result,$result,PUTLLC_FAILED
        brnz    $result,take
        bi      $lr

slice_next:
        ai      $g_tile,$g_tile,1
slice_check:
        clgt    $c_more,$g_tile_end,$g_tile
        binz    $c_more,$lr
        ori     $g_tile,$g_tiles,0
        bi      $lr
endfunction tile_next

# tile_place   where the tile at hand lies; tiles come in rising order, so stepping finds its row
#   Uses    $10-$12
function tile_place
        .set    row_end,10
        .set    c_reached,11
        .set    limit,12
step_row:
        a       $row_end,$g_row_first,$g_across
        clgt    $c_reached,$row_end,$g_tile
        brnz    $c_reached,in_row
        ori     $g_row_first,$row_end,0
        ai      $g_tile_y,$g_tile_y,TILE_HEIGHT
        br      step_row
in_row:
        sf      $g_tile_x,$g_row_first,$g_tile
        shli    $g_tile_x,$g_tile_x,6
        sf      $g_tile_width,$g_tile_x,$g_width
        il      $limit,TILE_WIDTH
        minimum $g_tile_width,$g_tile_width,$limit,$c_reached
        sf      $g_tile_height,$g_tile_y,$g_height
        il      $limit,TILE_HEIGHT
        minimum $g_tile_height,$g_tile_height,$limit,$c_reached
        ai      $g_row_bytes,$g_tile_width,3
        andi    $g_row_bytes,$g_row_bytes,-4
        shli    $g_row_bytes,$g_row_bytes,2
        mpyu    $limit,$g_tile_width,$g_tile_height
        a       $g_n_rays,$g_n_rays,$limit
        bi      $lr
endfunction tile_place

# tile_trace   traces the packets of the tile at hand into its buffer
#   Uses    $3-$7, $10-$49
function tile_trace
        .set    columns_left,10
        .set    rows_left,11
        .set    inside,12
        .set    row_inside,13
        .set    object,14
        .set    c_none,15
        .set    m_splat,16
        .set    a_packet,17
        .set    offset,19
        .set    c_more,20
        .set    t_carry,21
        enter
        il      $g_py,0
next_row:
        il      $g_px,0
next_packet:
        ila     $3,basis
        a       $4,$g_tile_x,$g_px
        a       $5,$g_tile_y,$g_py
        ila     $6,packet
        brsl    $lr,ray_setup_r16

        ila     $3,packet
        ila     $4,eye_spheres
        ori     $5,$g_spheres,0
        il      $6,1
        brsl    $lr,isect_spheres_r16

        ila     $3,packet
        ila     $4,colour_table
        ila     $5,depth
        ila     $6,colours
        brsl    $lr,shade_depth_r16

        # Row py of the tile, column px: the rows of a tile stand one behind the other.
        brsl    $lr,tile_buffer
        mpyu    $offset,$g_py,$g_row_bytes
        a       $5,$3,$offset
        shli    $offset,$g_px,2
        a       $5,$5,$offset
        ila     $3,colours
        ila     $4,shifts
        ori     $6,$g_row_bytes,0
        brsl    $lr,pack_r16

        # Hits are counted in the lanes that lie within the picture.
        splat_mask $m_splat
        sf      $columns_left,$g_px,$g_tile_width
        splat   $columns_left,$columns_left,$m_splat
        lqa     $inside,lanes
        cgt     $inside,$columns_left,$inside
        sf      $rows_left,$g_py,$g_tile_height
        splat   $rows_left,$rows_left,$m_splat
        ila     $a_packet,packet
    .irp row, 0,1,2,3
        cgti    $row_inside,$rows_left,\row
        and     $row_inside,$row_inside,$inside
        lqd     $object,PACKET_object+16*\row($a_packet)
        ceqi    $c_none,$object,0
        andc    $row_inside,$row_inside,$c_none
        sf      $g_n_hits,$row_inside,$g_n_hits         # true is -1
    .endr
        ai      $g_n_packets,$g_n_packets,1
        add_effective $g_tests_high,$g_tests_low,$g_spheres,$t_carry

        ai      $g_px,$g_px,4
        cgt     $c_more,$g_tile_width,$g_px
        brnz    $c_more,next_packet
        ai      $g_py,$g_py,4
        cgt     $c_more,$g_tile_height,$g_py
        brnz    $c_more,next_row
        leave
endfunction tile_trace

# tile_buffer   the buffer of the tile at hand
#   Out     $3
#   Uses    $3, $10
function tile_buffer
        .set    a_buffer,3
        .set    offset,10
        il      $offset,TILE_BYTES
        mpyu    $offset,$offset,$g_parity
        ila     $a_buffer,tile_buffers
        a       $a_buffer,$a_buffer,$offset
        bi      $lr
endfunction tile_buffer

# tile_put   starts the transfer of the tile at hand; the two buffers take turns
#   Uses    $3, $10-$31
#
# One list command for all rows. The high word of the address is shared by a list's elements: a tile
# that lies across a multiple of 4 GB goes row by row instead.
function tile_put
        .set    a_buffer,3
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
        enter
        brsl    $lr,tile_buffer
        mpyu    $offset,$g_tile_y,$g_stride
        ori     $high,$g_buffer_high,0
        ori     $low,$g_buffer_low,0
        add_effective $high,$low,$offset,$t_carry
        shli    $offset,$g_tile_x,2
        add_effective $high,$low,$offset,$t_carry
        ai      $tag,$g_parity,TAG_TILE

        ai      $rows,$g_tile_height,-1
        mpyu    $last,$rows,$g_stride
        a       $last,$last,$g_row_bytes
        ai      $last,$last,-1
        a       $last,$last,$low
        clgt    $c_across,$low,$last
        brnz    $c_across,row_by_row

        # Two elements a quadword: bytes, address, bytes, address of the next row.
        il      $offset,LIST_BYTES
        mpyu    $offset,$offset,$g_parity
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
        il      $command,MFC_PUTL
        mfc_command $a_buffer,$high,$a_list,$bytes,$tag,$command
        leave

row_by_row:
        il      $command,MFC_PUT
next_put:
        mfc_command $a_buffer,$high,$low,$g_row_bytes,$tag,$command
        brz     $rows,all_put
        a       $a_buffer,$a_buffer,$g_row_bytes
        add_effective $high,$low,$g_stride,$t_carry
        ai      $rows,$rows,-1
        br      next_put
all_put:
        leave
endfunction tile_put
