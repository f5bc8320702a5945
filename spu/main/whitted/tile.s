# A tile by Whitted's model: its eye rays are traced batch by batch, and what they send on as soon as
# there is a whole batch of it.

        .include "work_unit.inc"
        .include "macros.inc"
        .include "driver.inc"
        .include "whitted.inc"

        .section .rodata
        .align  4
        # places out of the sum's address and x, and y
place_of_sum_and_x:
        .int    0x80808080,0x00010203,0x10111213,0x80808080
place_with_y:
        .int    0x00010203,0x04050607,0x08090a0b,0x10111213

        .set    a_sum,10
        .set    zero,11
        .set    left,12
        .set    amount,13

# whitted_tile   makes the pixels of the tile at hand
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
        brsl    $lr,eye_places
next_batch:
        brsl    $lr,queue_full
        brnz    $3,waiting
        brnz    $w_eye_left,from_eye
        brsl    $lr,queue_rest
        brz     $3,traced
waiting:
        ori     $w_depth,$3,0
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
        ila     $3,arena+PIXEL_SUMS
        il      $4,TILE_BYTES
        mpyu    $4,$4,$g_parity
        ila     $5,tile_buffers
        a       $4,$4,$5
        ori     $5,$g_tile_height,0
        ori     $6,$g_row_bytes,0
        ila     $7,pixel_shuffle
        brsl    $lr,pack_sums
        phase_ends $g_ticks_shade,$amount
        leave
endfunction whitted_tile

# eye_places   lists the packets of the tile at hand
#   Out     EYE_PLACES, w_eye_next, w_eye_left
#   Uses    $10-$27
#
# Column by column, so that what a batch sends on comes from pixels that are near one another. The
# rays' packets take turns with the places.
        .set    a_place,14
        .set    place,15
        .set    a_rays,16
        .set    x,17
        .set    y,18
        .set    column,19
        .set    columns,20
        .set    row,21
        .set    rows,22
        .set    step,23
        .set    m_sum_x,24
        .set    m_y,25
        .set    m_rays,26
        .set    c_end,27

function eye_places
        ila     $a_place,arena+EYE_PLACES
        ori     $w_eye_next,$a_place,0
        ila     $a_rays,arena+BATCH_RAYS
        lqa     $m_sum_x,place_of_sum_and_x
        lqa     $m_y,place_with_y
        cwd     $m_rays,0($sp)
        ai      $columns,$g_tile_width,3
        rotmi   $columns,$columns,-2
        ai      $rows,$g_tile_height,3
        rotmi   $rows,$rows,-2
        mpyu    $w_eye_left,$columns,$rows
        ori     $x,$g_tile_x,0
        il      $column,0
next_column:
        ila     $a_sum,arena+PIXEL_SUMS
        shli    $step,$column,6
        a       $a_sum,$a_sum,$step
        ori     $y,$g_tile_y,0
        il      $row,0
next_row:
        shufb   $place,$a_sum,$x,$m_sum_x
        shufb   $place,$place,$y,$m_y
        shufb   $place,$a_rays,$place,$m_rays
        stqd    $place,0($a_place)
        ai      $a_place,$a_place,PLACE_SIZE
        # The packets are those of whole batches.
        il      $step,RAYS16_SIZE
        a       $a_rays,$a_rays,$step
        rotmi   $step,$w_most,-4
        mpyi    $step,$step,RAYS16_SIZE/16
        shli    $step,$step,4
        ila     $c_end,arena+BATCH_RAYS
        a       $step,$step,$c_end
        ceq     $step,$step,$a_rays
        selb    $a_rays,$a_rays,$c_end,$step
        il      $step,4*SUMS_PITCH
        a       $a_sum,$a_sum,$step
        ai      $y,$y,4
        ai      $row,$row,1
        ceq     $c_end,$row,$rows
        brz     $c_end,next_row
        ai      $x,$x,4
        ai      $column,$column,1
        ceq     $c_end,$column,$columns
        brz     $c_end,next_column
        bi      $lr
endfunction eye_places

# eye_take   makes the next batch of eye rays
#   Out     BATCH_RAYS, w_count
#   Uses    $3-$79, w_eye_next, w_eye_left
        .set    t_c,10
        .set    t_packets,11

function eye_take
        enter
        rotmi   $t_packets,$w_most,-4
        minimum $w_count,$t_packets,$w_eye_left,$t_c
        sf      $w_eye_left,$w_count,$w_eye_left
        ori     $3,$w_eye_next,0
        shli    $4,$w_count,PLACE_SIZE_LOG2
        a       $w_eye_next,$w_eye_next,$4
        ori     $4,$w_count,0
        ila     $5,basis
        ila     $6,SCENE_ADDRESS
        ori     $7,$g_width,0
        ori     $8,$g_height,0
        brsl    $lr,eye_rays_r16
        leave
endfunction eye_take
