# A tile with Whitted's model. Its primary rays are traced batch by batch, and their secondary rays
# as soon as there is a whole batch of them. Where a pixel has several samples,
# refine.s traces them afterwards.

        .include "work_unit.inc"
        .include "macros.inc"
        .include "driver.inc"
        .include "whitted.inc"

        .set    NEXT,10
        registers a_sum,zero,left,amount

# The address of the current tile's buffer.
.macro  tile_buffer out:req, t_base:req
        il      \out,TILE_BYTES
        mpyu    \out,\out,$g_parity
        ila     \t_base,tile_buffers
        a       \out,\out,\t_base
.endm

# whitted_tile   makes the current tile's pixels
#   Uses    $3-$79, the tile's and Whitted's driver registers
function whitted_tile
        enter
        phase_begins
        il      $zero,0
        ila     $a_sum,arena+PIXEL_SUMS
        il      $left,TILE_WIDTH*TILE_HEIGHT/8
clear:
        hbrr    cleared,clear
    .irp pixel, 0,1,2,3,4,5,6,7
        stqd    $zero,16*\pixel($a_sum)
    .endr
        ai      $a_sum,$a_sum,8*16
        ai      $left,$left,-1
cleared:
        brnz    $left,clear
        lqa     $left,contrast
        brz     $left,refine
        lqa     $left,cuts
        brz     $left,packets
        brsl    $lr,cuts_tile
packets:
        brsl    $lr,eye_places
        brsl    $lr,tile_rays
        brsl    $lr,tile_pack
        lqa     $left,contrast
        cgti    $left,$left,0
        brnz    $left,refine
        leave
refine:
        brsl    $lr,tile_refine
        leave
endfunction whitted_tile

        .section .bss
        .align  4
        .global of_cuts
of_cuts:                                # whether cuts have found the ground for this batch's rays
        .skip   16

# tile_rays   traces the listed packets of primary rays, and all rays that they send on
#   Uses    $3-$79, Whitted's driver registers
function tile_rays
        enter
next_batch:
        times_checked late,$left,$amount
in_time:
        lqa     $amount,queued
        lqa     $left,queue
        sf      $amount,$left,$amount
        shli    $left,$w_most,QUEUED_SIZE_LOG2
        cgt     $left,$left,$amount
        brz     $left,waiting
        lqa     $left,spilled
        brnz    $left,refill
        brnz    $w_eye_left,from_eye
        lqa     $left,refining
        brnz    $left,refined
unlisted:
        brz     $amount,traced
waiting:
        il      $w_depth,0
        stqa    $w_depth,of_cuts
        il      $w_depth,2
        brsl    $lr,queue_take
        br      trace
from_eye:
        il      $w_depth,1
        brsl    $lr,eye_take
trace:
        phase_ends $g_ticks_rays,$amount
        brsl    $lr,batch_trace
        br      next_batch
traced:
        leave

refill: brsl    $lr,queue_refill
        br      waiting
refined:
        brsl    $lr,samples_list
        brnz    $w_eye_left,from_eye
        lqa     $amount,queued
        lqa     $left,queue
        sf      $amount,$left,$amount
        br      unlisted

late:   brsl    $lr,times_add
        br      in_time
endfunction tile_rays

# tile_pack   converts the sums of the current tile to its pixels
#   Uses    $3-$79
function tile_pack
        enter
        lqa     $3,converting
        brnz    $3,convert
converted:
        ila     $3,arena+PIXEL_SUMS
        tile_buffer $4,$5
        if_whole pack,$amount
        # The other subtiles are in the buffer.
        ila     $4,arena+PIXEL_SUMS
pack:   ori     $5,$g_tile_height,0
        ori     $6,$g_row_bytes,0
        ila     $7,pixel_shuffle
        brsl    $lr,pack_sums
        if_whole packed,$amount
        il      $3,1<<TAG_TILE
        shl     $3,$3,$g_parity
        brsl    $lr,dma_wait
        brsl    $lr,subtiles_copy
packed: phase_ends $g_ticks_shade,$amount
        leave

convert:
        ila     $3,arena+PIXEL_SUMS
        shli    $4,$g_tile_height,TILE_WIDTH_LOG2
        brsl    $lr,light_convert
        br      converted
endfunction tile_pack

# subtiles_copy   copies the traced subtiles of the packed tile to its buffer
#   Uses    $10-$23
        .set    NEXT,10
        registers subtiles,a_from,a_to,t_c,rows,from
        # two quadwords of each row
        registers quad0,quad1,quad2,quad3,quad4,quad5,quad6,quad7

function subtiles_copy
        lqa     $subtiles,tile_subtiles
        ila     $a_from,arena+PIXEL_SUMS
        tile_buffer $a_to,$t_c
        il      $rows,0
next_subtile:
        andi    $t_c,$subtiles,1
        rotmi   $subtiles,$subtiles,-1
        brz     $t_c,subtile_kept
    .irp row, 0,1,2,3
        lqd     $quad0+2*\row,4*TILE_WIDTH*\row($a_from)
        lqd     $quad1+2*\row,4*TILE_WIDTH*\row+16($a_from)
    .endr
    .irp row, 0,1,2,3
        stqd    $quad0+2*\row,4*TILE_WIDTH*\row($a_to)
        stqd    $quad1+2*\row,4*TILE_WIDTH*\row+16($a_to)
    .endr
subtile_kept:
        biz     $subtiles,$lr
        # After the eighth subtile of a row, the next row of subtiles.
        ai      $rows,$rows,1
        andi    $t_c,$rows,7
        ceqi    $t_c,$t_c,0
        il      $from,(SUBTILE_HEIGHT-1)*4*TILE_WIDTH
        and     $from,$from,$t_c
        ai      $from,$from,4*SUBTILE_WIDTH
        a       $a_from,$a_from,$from
        a       $a_to,$a_to,$from
        br      next_subtile
endfunction subtiles_copy

# eye_places   lists the packets of the current tile's subtiles that are traced
#   Out     EYE_PLACES, w_eye_next, w_eye_left
#   Uses    $14-$36
#
# They are listed column by column, so that a batch's secondary rays come from pixels that are near
# each other. With a height field the columns have two rows: a batch that is wider than high meets
# fewer blocks. The rays' packets alternate with the places.
        .set    a_place,14
        .set    place,15
        .set    step,16
        .set    m_word,17
        .set    columns,18
        .set    rows,19
        .set    row,20
        .set    batch_end,21
        .set    batch_back,22
        .set    c_end,23
        .set    column,24
        .set    column_step,25
        .set    pair,26
        .set    passed,27
        .set    subtiles,28
        .set    listed,29
        .set    left_out,30
        .set    band,31                                 # its first place
        .set    rows_left,32                            # of packets, with those of the band
        .set    band_subtiles,33
        .set    most,34                                 # rows of packets in a band
        .set    left_columns,35
        .set    step_band,36

        quadword_constants
next_band_step:                         # two rows of packets
        .int    0,2*4*SUMS_PITCH,0,2*4
first_place:                            # without the packet
        .int    0,arena+PIXEL_SUMS,0,0
next_row_step:
        .int    RAYS16_SIZE,4*SUMS_PITCH,0,4
next_column_step:
        .int    0,4*16,4,0

function eye_places
        ila     $a_place,arena+EYE_PLACES
        ori     $w_eye_next,$a_place,0
        ai      $columns,$g_tile_width,3
        rotmi   $columns,$columns,-2
        ai      $rows,$g_tile_height,3
        rotmi   $rows,$rows,-2
        lqa     $place,first_place
        lqa     $batch_end,rays_at
        cwd     $m_word,0($sp)
        shufb   $place,$batch_end,$place,$m_word
        cwd     $m_word,8($sp)
        shufb   $place,$g_tile_x,$place,$m_word
        cwd     $m_word,12($sp)
        shufb   $place,$g_tile_y,$place,$m_word
        lqa     $step,next_row_step
        lqa     $column_step,next_column_step
        # A batch's packets and their end, only in the first word.
        fsmbi   $m_word,0xf000
        rotmi   $batch_back,$w_most,-4
        mpyi    $batch_back,$batch_back,RAYS16_SIZE/16
        shli    $batch_back,$batch_back,4
        and     $batch_back,$batch_back,$m_word
        a       $batch_end,$batch_end,$batch_back
        ori     $rows_left,$rows,0
        ori     $band,$place,0
        lqa     $most,streamed
        il      $c_end,FEATURE_HEIGHTS
        and     $most,$most,$c_end
        cgti    $most,$most,0
        shli    $most,$most,1
        ai      $most,$most,4
        lqa     $band_subtiles,tile_subtiles
next_band:
        minimum $rows,$rows_left,$most,$c_end
        sf      $rows_left,$rows,$rows_left
        selb    $place,$band,$place,$m_word
        ori     $column,$place,0
        il      $pair,1
        ori     $left_columns,$columns,0
next_column:
        ori     $row,$rows,0
        # The bits of this column's subtiles, of which two columns of packets have one.
        rotmai  $passed,$pair,-1
        rotm    $subtiles,$band_subtiles,$passed
next_row:
        hbrr    last_row,next_row
        stqd    $place,0($a_place)
        andi    $listed,$subtiles,1
        ceqi    $left_out,$listed,0
        shli    $listed,$listed,PLACE_SIZE_LOG2
        a       $a_place,$a_place,$listed
        # Only a listed place has a packet.
        and     $left_out,$left_out,$m_word
        andc    $left_out,$step,$left_out
        a       $place,$place,$left_out
        rotmi   $subtiles,$subtiles,-8
        ai      $row,$row,-1
        ceq     $c_end,$place,$batch_end
        and     $c_end,$c_end,$batch_back
        sf      $place,$c_end,$place
last_row:
        brnz    $row,next_row
        # The next column begins at the top, with the next packet.
        a       $column,$column,$column_step
        selb    $place,$column,$place,$m_word
        ai      $pair,$pair,-1
        ai      $left_columns,$left_columns,-1
        brnz    $left_columns,next_column
        lqa     $step_band,next_band_step
        rotmi   $band_subtiles,$band_subtiles,-16
        a       $band,$band,$step_band
        brnz    $rows_left,next_band
        sf      $w_eye_left,$w_eye_next,$a_place
        rotmi   $w_eye_left,$w_eye_left,-PLACE_SIZE_LOG2
        bi      $lr
endfunction eye_places

# eye_take   makes the next batch of primary rays, or of samples
#   Out     BATCH_RAYS, batch_rays, w_count
#   Uses    $3-$79, w_eye_next, w_eye_left
        .set    t_c,10
        .set    t_packets,11

function eye_take
        enter
        rotmi   $t_packets,$w_most,-4
        minimum $w_count,$t_packets,$w_eye_left,$t_c
        shli    $t_packets,$w_count,4
        stqa    $t_packets,batch_rays
        sf      $w_eye_left,$w_count,$w_eye_left
        ori     $3,$w_eye_next,0
        shli    $t_packets,$w_count,PLACE_SIZE_LOG2
        ori     $4,$w_count,0
        ila     $5,basis
        ila     $6,SCENE_ADDRESS
        lqa     $t_c,refining
        brnz    $t_c,samples
        a       $w_eye_next,$w_eye_next,$t_packets
        ori     $7,$g_width,0
        ori     $8,$g_height,0
        brsl    $lr,primary_rays_r16
        lqa     $3,cuts
        stqa    $3,of_cuts
        brz     $3,taken
        brsl    $lr,cuts_eye
taken:  leave
samples:
        il      $7,0
        stqa    $7,of_cuts
        shli    $t_packets,$t_packets,2                 # a place for each row
        a       $w_eye_next,$w_eye_next,$t_packets
        ila     $7,frame
        load_word $7,FRAME_samples,$7
        lqa     $8,rays_at
        brsl    $lr,sample_rays_r16
        leave
endfunction eye_take
