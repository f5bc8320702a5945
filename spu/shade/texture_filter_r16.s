# texture_filter_r16   multiplies the colours of sixteen surfaces by those of their texels
#   C       void texture_filter_r16(const struct texels *, struct surfaces *, int are_roots);
#   In      $3 texels, whose places are addresses of words; $4 surfaces; pointers 16-aligned;
#           $5 -1 if texels are square roots of light, 0 if they are light
#   Out     surfaces: red, green and blue, where the tile is not all ones
#   Uses    $3-$5, $10-$57   Saves  -   Stack  0   Calls  -
#   Domain  right and down from 0 to 1
#   Error   4e-7 of the largest texel, for a colour of 1
#   Twin    lab/twins/src/texture.rs
#
# The texel's colour is interpolated between the left and the right texels of both rows, and then
# between the rows. The texels are the words at the place, 4 bytes after it, and the same in the
# next row of the tile. Where pixels have sRGB's values, bytes are square roots of light: of light
# itself they would have too few steps in dark textures.
#
# The loop counts up, so that it isn't pipelined, which would double its size.

        .include "work_unit.inc"
        .include "macros.inc"

        .set    NEXT,3
        registers a_texels,a_surfaces,are_roots
        # constants
        .set    NEXT,10
        registers m_pair,m_pairs,k_byte,k_scale,k_light,k_square,rows
        # the lanes' addresses, and what is there
        registers address                               # to 20
        .set    quad,21                                 # to 24
        .set    NEXT,25
        registers low,high
        registers texel                                 # to 30: left and right, above and below
        .set    NEXT,texel+4
        registers part                                  # to 34
        .set    NEXT,part+4
        registers right,down,none,above,below,colour,old,factor
        # where the words of the other texels are
        registers beside                                # to 46
        .set    NEXT,beside+4

        .section .rodata.texture,"a",@progbits
        .align  4
# The first words of A and B; the first halves.
words:  .int    0x00010203,0x10111213,0x80808080,0x80808080
        .int    0x00010203,0x04050607,0x10111213,0x14151617

# Gathers the words at four addresses.
.macro  words_at out:req, from:req
    .irp lane, 0,1,2,3
        lqd     $quad+\lane,0($\from+\lane)
    .endr
    .irp lane, 0,1,2,3
        rotqby  $quad+\lane,$quad+\lane,$\from+\lane
    .endr
        shufb   $low,$quad,$quad+1,$m_pair
        shufb   $high,$quad+2,$quad+3,$m_pair
        shufb   $\out,$low,$high,$m_pairs
.endm

.macro  words_beside out:req, offset:req
    .irp lane, 0,1,2,3
        ai      $beside+\lane,$address+\lane,\offset
    .endr
        words_at \out,beside
.endm

# Filters a channel, whose byte is moved to the end, and multiplies the colour.
.macro  channel name:req, shift:req
    .irp place, 0,1,2,3
        rotmi   $part+\place,$texel+\place,-\shift
    .if \shift < 24
        and     $part+\place,$part+\place,$k_byte
    .endif
        csflt   $part+\place,$part+\place,0
        fma     $factor,$part+\place,$k_square,$k_light
        fm      $part+\place,$part+\place,$factor
    .endr
        fs      $above,$part+1,$part
        fs      $below,$part+3,$part+2
        fma     $above,$above,$right,$part
        fma     $below,$below,$right,$part+2
        fs      $below,$below,$above
        fma     $above,$below,$down,$above
        lqd     $old,SURFACES_\name($a_surfaces)
        fm      $above,$above,$k_scale
        fm      $colour,$above,$old
        selb    $colour,$colour,$old,$none
        stqd    $colour,SURFACES_\name($a_surfaces)
.endm

function texture_filter_r16
        lqa     $m_pair,words
        lqa     $m_pairs,words+16
        il      $k_byte,255
        load_constant $k_scale,0x3b808081               # 1 / 255
        load_constant $k_light,0x3f800000               # 1
        fsm     $are_roots,$are_roots
        and     $k_square,$k_scale,$are_roots
        andc    $k_light,$k_light,$are_roots
        il      $rows,-4
next_row:
        lqd     $address,TEXELS_place($a_texels)
        lqd     $none,TEXELS_tile($a_texels)
        lqd     $right,TEXELS_right($a_texels)
        lqd     $down,TEXELS_down($a_texels)
        rotqbyi $address+1,$address,4
        rotqbyi $address+2,$address,8
        rotqbyi $address+3,$address,12
        ceqi    $none,$none,-1
        words_at texel,address
        words_beside texel+1,4
        words_beside texel+2,4*TEXTURE_SIDE
        words_beside texel+3,4*TEXTURE_SIDE+4
        channel red,24
        channel green,16
        channel blue,8
        ai      $a_texels,$a_texels,16
        ai      $a_surfaces,$a_surfaces,16
        ai      $rows,$rows,1
        brnz    $rows,next_row
        bi      $lr
endfunction texture_filter_r16
