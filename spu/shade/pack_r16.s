# pack_r16   colours of 4x4 pixels to the framebuffer's 32-bit words
#   C       void pack_r16(const struct place *, int count, const struct colours *,
#                         const struct pixel_shuffle *, int pitch);
#   In      $3 places, $4 count (at least 1), $5 their colours, in order, $6 shuffle, $7 bytes from
#           row to row of the tile buffer; pointers and pitch multiples of 16
#   Out     the places' pixels, four rows of a quadword each
#   Uses    $3-$5, $10-$27   Saves  -   Stack  0   Calls  -
#   Domain  any colour: below 0 is 0, above 1 is 1
#   Error   0.50001 of 255, each channel
#   Twin    lab/twins/src/pack.rs
#
#   channel = floor(min(c, 1) 255 + 1/2)
# The conversion to an unsigned integer saturates, so after scaling by 2^32 / 256 it also clamps.
# The channel is the highest byte of floor((c 255/256 + 1/512) 2^32).

        .include "work_unit.inc"
        .include "macros.inc"

        .set    NEXT,3
        registers a_place,count,a_colours,a_shuffle,pitch
        # constants
        .set    NEXT,10
        registers k_scale,k_half,m_red_green,m_blue
        # a row
        .set    NEXT,15
        registers a_row,red,green,blue,pixels

.macro  channel name:req, row:req
        lqd     $\name,COLOURS_\name+16*\row($a_colours)
        fma     $\name,$\name,$k_scale,$k_half
        cfltu   $\name,$\name,32
.endm

function pack_r16
        ilhu    $k_scale,0x3f7f                         # 255/256
        ilhu    $k_half,0x3b00                          # 1/512
        lqd     $m_red_green,PIXELS_red_green($a_shuffle)
        lqd     $m_blue,PIXELS_blue($a_shuffle)
next_packet:
        lqd     $a_row,0($a_place)
        rotqbyi $a_row,$a_row,PLACE_pixels
    .irp row, 0,1,2,3
        channel red,\row
        channel green,\row
        channel blue,\row
        shufb   $pixels,$red,$green,$m_red_green
        shufb   $pixels,$pixels,$blue,$m_blue
        stqd    $pixels,0($a_row)
    .ifne \row-3
        a       $a_row,$a_row,$pitch
    .endif
    .endr
        ai      $a_place,$a_place,PLACE_SIZE
        ai      $a_colours,$a_colours,COLOURS_SIZE
        ai      $count,$count,-1
        brnz    $count,next_packet
        bi      $lr
endfunction pack_r16
