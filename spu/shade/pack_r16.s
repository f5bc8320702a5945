# pack_r16   colours of 4x4 pixels to the framebuffer's 32-bit words
#   C       void pack_r16(const struct colours *, const struct shifts *, unsigned *rows, int pitch);
#   In      $3 colours, $4 shifts, $5 first of four rows of pixels, $6 bytes from row to row;
#           all multiples of 16
#   Out     four quadwords of pixels
#   Uses    $5, $10-$21   Saves  -   Stack  0   Calls  -
#   Domain  any colour: below 0 is 0, above 1 is 1; shifts 0 to 24
#   Error   0.50001 of 255, each channel
#   Twin    oracle/src/twin/pack.rs
#
#   channel = floor(min(c, 1) 255 + 1/2), placed by its shift

        .include "work_unit.inc"
        .include "macros.inc"

        .set    a_colours,3
        .set    a_shifts,4
        .set    a_row,5
        .set    pitch,6
        # constants
        .set    k_one,10
        .set    k_half,11
        .set    k_255,12
        .set    shift_red,13
        .set    shift_green,14
        .set    shift_blue,15
        # a row
        .set    red,16
        .set    green,17
        .set    blue,18
        .set    pixels,19
        .set    c_over,20

.macro  channel name:req, row:req
        lqd     $\name,COLOURS_\name+16*\row($a_colours)
        fcgt    $c_over,$\name,$k_one
        selb    $\name,$\name,$k_one,$c_over
        fma     $\name,$\name,$k_255,$k_half
        cfltu   $\name,$\name,0                         # what is below 0 becomes 0
        shl     $\name,$\name,$shift_\name
.endm

function pack_r16
        ilhu    $k_one,0x3f80
        ilhu    $k_half,0x3f00
        ilhu    $k_255,0x437f
        lqd     $shift_red,SHIFTS_red($a_shifts)
        lqd     $shift_green,SHIFTS_green($a_shifts)
        lqd     $shift_blue,SHIFTS_blue($a_shifts)
    .irp row, 0,1,2,3
        channel red,\row
        channel green,\row
        channel blue,\row
        or      $pixels,$red,$green
        or      $pixels,$pixels,$blue
        stqd    $pixels,0($a_row)
        a       $a_row,$a_row,$pitch
    .endr
        bi      $lr
endfunction pack_r16
