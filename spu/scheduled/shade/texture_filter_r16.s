# texture_filter_r16   multiplies the colours of sixteen surfaces by those of their texels
#   C       void texture_filter_r16(const struct texels *, struct surfaces *);
#   In      $3 texels, whose places are addresses of words; $4 surfaces; pointers 16-aligned
#   Out     surfaces: red, green and blue, where the tile is not all ones
#   Uses    $2-$43   Saves  -   Stack  0   Calls  -
#   Domain  right and down from 0 to 1
#   Error   4e-7 of the greatest texel, for a colour of 1
#   Twin    lab/twins/src/texture.rs
#
# The texel's colour is interpolated between the left and the right texels of both rows, and then
# between the rows. The texels are the words at the place, 4 bytes after it, and the same in the
# next row of the tile.
#
# The loop counts up, so that it isn't pipelined, which would take as much room again.
# Scheduled by spu schedule from texture_filter_r16.s

        .include "work_unit.inc"
        .include "macros.inc"

        .set    NEXT,3
        registers a_texels,a_surfaces
        # constants
        .set    NEXT,10
        registers m_pair,m_pairs,k_byte,k_scale,rows
        # the lanes' addresses, and what is there
        registers address                               # to 18
        .set    quad,19                                 # to 22
        .set    NEXT,23
        registers low,high
        registers texel                                 # to 28: left and right, above and below
        .set    NEXT,texel+4
        registers part                                  # to 32
        .set    NEXT,part+4
        registers right,down,none,above,below,colour,old
        # where the words of the other texels are
        registers beside                                # to 43
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
        .set old_2,2; .set beside_2,5; .set beside_3,6; .set beside1_2,7; .set quad_2,8
        .set beside2_2,9; .set quad1_2,23; .set beside3_2,24; .set beside1_3,15; .set beside2_3,16
        .set beside3_3,17; .set quad2_2,18; .set low_2,19; .set quad3_2,20; .set high_2,21
        .set quad1_3,22; .set quad3_3,19; .set part_2,21; .set high_3,18; .set part_3,19
        .set quad2_3,22; .set quad3_4,25; .set quad_3,26; .set texel1_2,18; .set quad_4,5
        .set part_4,8; .set part_5,7; .set part1_2,9; .set quad1_4,19; .set part1_3,18
        .set quad2_4,5; .set quad_5,6; .set part1_4,15; .set old_3,5; .set part2_2,6
        .set above_2,9; .set part2_3,16; .set above_3,8; .set part2_4,9; .set part3_2,16
        .set part3_3,17; .set above_4,15; .set above_5,7; .set below_2,15; .set below_3,16
        .set below_4,6; .set below_5,9; .set above_6,6; .set colour_2,6; .set colour_3,7
        .set colour_4,2
        ilhu    $k_scale,0x3b80                         # 0e 1 / 255
        hbrr    next_row_back,next_row                  # 0o hint
        il      $k_byte,255                             # 1e
        lqa     $m_pair,words                           # 1o
        iohl    $k_scale,0x8081                         # 2e 1 / 255
        lqa     $m_pairs,words+16                       # 2o
        il      $rows,-4                                # 3e
        lnop                                            # 3o pairing
next_row:
        ai      $rows,$rows,1                           # 0e
        lqd     $address,64($a_texels)                  # 0o
        lqd     $none,0($a_texels)                      # 1o
        lqd     $right,128($a_texels)                   # 2o
        nop     $127                                    # 3e pairing
        lqd     $down,192($a_texels)                    # 3o
        ai      $a_texels,$a_texels,16                  # 4e
        lqd     $old,640($a_surfaces)                   # 4o
        nop     $127                                    # 5e pairing
        lqd     $old_2,704($a_surfaces)                 # 5o
        ai      $beside,$address,4                      # 6e
        rotqbyi $address+1,$address,4                   # 6o
        ceqi    $none,$none,-1                          # 7e
        rotqbyi $address+2,$address,8                   # 7o
        ai      $beside_2,$address,36                   # 8e
        rotqbyi $address+3,$address,12                  # 8o
        ai      $beside_3,$address,40                   # 9e
        lqd     $quad,0($address)                       # 9o
        ai      $beside+1,$address+1,4                  # 10e
        lqd     $quad+1,0($address+1)                   # 10o
        ai      $beside+2,$address+2,4                  # 11e
        lqd     $quad+2,0($address+2)                   # 11o
        ai      $beside+3,$address+3,4                  # 12e
        lqd     $quad+3,0($address+3)                   # 12o
        ai      $beside1_2,$address+1,36                # 13e
        lqd     $quad_2,0($beside)                      # 13o
        ai      $beside2_2,$address+2,36                # 14e
        lqd     $quad1_2,0($beside+1)                   # 14o
        ai      $beside3_2,$address+3,36                # 15e
        rotqby  $quad,$quad,$address                    # 15o
        ai      $beside1_3,$address+1,40                # 16e
        rotqby  $quad+1,$quad+1,$address+1              # 16o
        ai      $beside2_3,$address+2,40                # 17e
        rotqby  $quad+2,$quad+2,$address+2              # 17o
        ai      $beside3_3,$address+3,40                # 18e
        rotqby  $quad+3,$quad+3,$address+3              # 18o
        lqd     $quad2_2,0($beside+2)                   # 19o
        shufb   $low_2,$quad,$quad+1,$m_pair            # 20o
        lqd     $quad3_2,0($beside+3)                   # 21o
        shufb   $high_2,$quad+2,$quad+3,$m_pair         # 22o
        rotqby  $quad_2,$quad_2,$beside                 # 23o
        rotqby  $quad1_3,$quad1_2,$beside+1             # 24o
        rotqby  $quad2_2,$quad2_2,$beside+2             # 25o
        shufb   $texel,$low_2,$high_2,$m_pairs          # 26o
        rotqby  $quad3_3,$quad3_2,$beside+3             # 27o
        shufb   $low,$quad_2,$quad1_3,$m_pair           # 28o
        nop     $127                                    # 29e pairing
        lqd     $quad_2,0($beside_2)                    # 29o
        rotmi   $part,$texel,-24                        # 30e
        lqd     $quad+1,0($beside1_2)                   # 30o
        rotmi   $part_2,$texel,-16                      # 31e
        shufb   $high_3,$quad2_2,$quad3_3,$m_pair       # 31o
        rotmi   $part_3,$texel,-8                       # 32e
        lqd     $quad2_3,0($beside2_2)                  # 32o
        nop     $127                                    # 33e pairing
        lqd     $quad3_4,0($beside3_2)                  # 33o
        csflt   $part,$part,0                           # 34e
        lqd     $quad_3,0($beside_3)                    # 34o
        and     $part_2,$part_2,$k_byte                 # 35e
        shufb   $texel1_2,$low,$high_3,$m_pairs         # 35o
        and     $part_3,$part_3,$k_byte                 # 36e
        rotqby  $quad_4,$quad_2,$beside_2               # 36o
        csflt   $part_4,$part_2,0                       # 37e
        rotqby  $quad+1,$quad+1,$beside1_2              # 37o
        csflt   $part_5,$part_3,0                       # 38e
        rotqby  $quad+2,$quad2_3,$beside2_2             # 38o
        rotmi   $part+1,$texel1_2,-24                   # 39e
        rotqby  $quad+3,$quad3_4,$beside3_2             # 39o
        rotmi   $part1_2,$texel1_2,-16                  # 40e
        lqd     $quad1_4,0($beside1_3)                  # 40o
        rotmi   $part1_3,$texel1_2,-8                   # 41e
        shufb   $low,$quad_4,$quad+1,$m_pair            # 41o
        nop     $127                                    # 42e pairing
        lqd     $quad2_4,0($beside2_3)                  # 42o
        csflt   $part+1,$part+1,0                       # 43e
        shufb   $high,$quad+2,$quad+3,$m_pair           # 43o
        and     $part1_2,$part1_2,$k_byte               # 44e
        lqd     $quad+3,0($beside3_3)                   # 44o
        and     $part1_3,$part1_3,$k_byte               # 45e
        rotqby  $quad_5,$quad_3,$beside_3               # 45o
        csflt   $part1_2,$part1_2,0                     # 46e
        rotqby  $quad+1,$quad1_4,$beside1_3             # 46o
        csflt   $part1_4,$part1_3,0                     # 47e
        shufb   $texel+2,$low,$high,$m_pairs            # 47o
        rotqby  $quad+2,$quad2_4,$beside2_3             # 48o
        lqd     $old_3,768($a_surfaces)                 # 49o
        fs      $above,$part+1,$part                    # 50e
        rotqby  $quad+3,$quad+3,$beside3_3              # 50o
        rotmi   $part+2,$texel+2,-24                    # 51e
        shufb   $low,$quad_5,$quad+1,$m_pair            # 51o
        rotmi   $part2_2,$texel+2,-16                   # 52e
        fs      $above_2,$part1_2,$part_4               # 53e
        rotmi   $part2_3,$texel+2,-8                    # 54e
        shufb   $high,$quad+2,$quad+3,$m_pair           # 54o
        csflt   $part+2,$part+2,0                       # 55e
        and     $part2_2,$part2_2,$k_byte               # 56e
        fma     $above,$above,$right,$part              # 57e
        lnop                                            # 57o pairing
        csflt   $part2_2,$part2_2,0                     # 58e
        shufb   $texel+3,$low,$high,$m_pairs            # 58o
        and     $part2_3,$part2_3,$k_byte               # 59e
        fma     $above_3,$above_2,$right,$part_4        # 60e
        csflt   $part2_4,$part2_3,0                     # 61e
        rotmi   $part+3,$texel+3,-24                    # 62e
        rotmi   $part3_2,$texel+3,-16                   # 63e
        rotmi   $part3_3,$texel+3,-8                    # 64e
        fs      $above_4,$part1_4,$part_5               # 65e
        csflt   $part+3,$part+3,0                       # 66e
        and     $part3_2,$part3_2,$k_byte               # 67e
        and     $part3_3,$part3_3,$k_byte               # 68e
        csflt   $part3_2,$part3_2,0                     # 69e
        csflt   $part3_3,$part3_3,0                     # 70e
        fma     $above_5,$above_4,$right,$part_5        # 72e
        fs      $below,$part+3,$part+2                  # 73e
        fs      $below_2,$part3_2,$part2_2              # 76e
        fs      $below_3,$part3_3,$part2_4              # 77e
        fma     $below,$below,$right,$part+2            # 79e
        fma     $below_4,$below_2,$right,$part2_2       # 82e
        fma     $below_5,$below_3,$right,$part2_4       # 83e
        fs      $below,$below,$above                    # 85e
        fs      $below_4,$below_4,$above_3              # 88e
        fs      $below_5,$below_5,$above_5              # 89e
        fma     $above,$below,$down,$above              # 91e
        fma     $above_6,$below_4,$down,$above_3        # 94e
        fma     $above_5,$below_5,$down,$above_5        # 95e
        fm      $above,$above,$k_scale                  # 97e
        fm      $above_6,$above_6,$k_scale              # 100e
        fm      $above_5,$above_5,$k_scale              # 101e
        fm      $colour,$above,$old                     # 103e
        fm      $colour_2,$above_6,$old_2               # 106e
        fm      $colour_3,$above_5,$old_3               # 107e
        selb    $colour,$colour,$old,$none              # 109e
        stqd    $colour,640($a_surfaces)                # 111o
        selb    $colour,$colour_2,$old_2,$none          # 112e
        selb    $colour_4,$colour_3,$old_3,$none        # 113e
        stqd    $colour,704($a_surfaces)                # 114o
        nop     $127                                    # 115e pairing
        stqd    $colour_4,768($a_surfaces)              # 115o
        ai      $a_surfaces,$a_surfaces,16              # 116e
next_row_back:
        brnz    $rows,next_row                          # 116o
        nop     $127                                    # 117e pairing
        bi      $lr                                     # 117o
endfunction texture_filter_r16
