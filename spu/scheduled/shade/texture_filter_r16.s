# texture_filter_r16   multiplies the colours of sixteen surfaces by those of their texels
#   C       void texture_filter_r16(const struct texels *, struct surfaces *, int are_roots);
#   In      $3 texels, whose places are addresses of words; $4 surfaces; pointers 16-aligned;
#           $5 -1 if texels are square roots of light, 0 if they are light
#   Out     surfaces: red, green and blue, where the tile is not all ones
#   Uses    $2-$46   Saves  -   Stack  0   Calls  -
#   Domain  right and down from 0 to 1
#   Error   4e-7 of the greatest texel, for a colour of 1
#   Twin    lab/twins/src/texture.rs
#
# The texel's colour is interpolated between the left and the right texels of both rows, and then
# between the rows. The texels are the words at the place, 4 bytes after it, and the same in the
# next row of the tile. Where pixels have sRGB's values, bytes are square roots of light: of light
# itself they would have too few steps in dark textures.
#
# The loop counts up, so that it isn't pipelined, which would take as much room again.
# Scheduled by spu schedule from texture_filter_r16.s

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
        .set old_2,2; .set beside_2,5; .set beside_3,6; .set quad_2,7; .set beside1_2,8
        .set quad_3,9; .set beside3_2,23; .set quad1_2,24; .set quad2_2,25; .set beside2_2,26
        .set quad3_2,27; .set beside3_3,28; .set quad2_3,29; .set beside1_3,30; .set quad2_4,31
        .set beside2_3,32; .set quad3_3,33; .set quad1_3,34; .set quad3_4,17; .set quad2_5,19
        .set quad3_5,25; .set quad_4,27; .set quad1_4,38; .set quad3_6,39; .set quad1_5,18
        .set quad2_6,24; .set quad3_7,20; .set quad_5,6; .set quad1_6,8; .set quad3_8,9
        .set quad2_7,18; .set high_2,5; .set part_2,7; .set part_3,8; .set high_3,9
        .set quad1_7,17; .set low_2,18; .set old_3,19; .set part_4,6; .set part1_2,5
        .set part1_3,8; .set part3_2,9; .set part2_2,17; .set part2_3,18; .set part3_3,20
        .set factor_2,21; .set factor_3,22; .set factor_4,23; .set factor_5,24; .set factor_6,25
        .set factor_7,26; .set above_2,8; .set above_3,5; .set below_2,9; .set below_3,20
        .set above_4,7; .set below_4,6; .set below_5,8; .set above_5,6; .set colour_2,5
        .set colour_3,6; .set colour_4,2
        ilhu    $k_scale,0x3b80                         # 0e 1 / 255
        lqa     $m_pair,words                           # 0o
        ilhu    $k_light,0x3f80                         # 1e 1
        lqa     $m_pairs,words+16                       # 1o
        iohl    $k_scale,0x8081                         # 2e 1 / 255
        fsm     $are_roots,$are_roots                   # 2o
        iohl    $k_light,0                              # 3e 1
        il      $k_byte,255                             # 4e
        il      $rows,-4                                # 5e
        and     $k_square,$k_scale,$are_roots           # 6e
        andc    $k_light,$k_light,$are_roots            # 7e
        lnop                                            # 7o pairing
next_row:
        ai      $rows,$rows,1                           # 0e
        lqd     $address,64($a_texels)                  # 0o
        lqd     $down,192($a_texels)                    # 1o
        lqd     $right,128($a_texels)                   # 2o
        lqd     $old,768($a_surfaces)                   # 3o
        lqd     $none,0($a_texels)                      # 4o
        ai      $a_texels,$a_texels,16                  # 5e
        lqd     $old_2,704($a_surfaces)                 # 5o
        ai      $beside,$address,4                      # 6e
        rotqbyi $address+1,$address,4                   # 6o
        ai      $beside_2,$address,40                   # 7e
        lqd     $quad,0($address)                       # 7o
        ai      $beside_3,$address,36                   # 8e
        rotqbyi $address+3,$address,12                  # 8o
        nop     $127                                    # 9e pairing
        lqd     $quad_2,0($beside_2)                    # 9o
        ai      $beside+1,$address+1,40                 # 10e
        rotqbyi $address+2,$address,8                   # 10o
        ai      $beside1_2,$address+1,4                 # 11e
        lqd     $quad_3,0($beside_3)                    # 11o
        ai      $beside+3,$address+3,4                  # 12e
        lqd     $quad+1,0($beside+1)                    # 12o
        ai      $beside3_2,$address+3,40                # 13e
        lqd     $quad1_2,0($address+1)                  # 13o
        ai      $beside+2,$address+2,40                 # 14e
        lqd     $quad2_2,0($address+2)                  # 14o
        ai      $beside2_2,$address+2,36                # 15e
        lqd     $quad3_2,0($beside+3)                   # 15o
        ai      $beside3_3,$address+3,36                # 16e
        lqd     $quad2_3,0($beside+2)                   # 16o
        ai      $beside1_3,$address+1,36                # 17e
        lqd     $quad2_4,0($beside2_2)                  # 17o
        ai      $beside2_3,$address+2,4                 # 18e
        lqd     $quad3_3,0($beside3_3)                  # 18o
        ceqi    $none,$none,-1                          # 19e
        lqd     $quad1_3,0($beside1_3)                  # 19o
        rotqby  $quad,$quad,$address                    # 20o
        rotqby  $quad3_4,$quad3_2,$beside+3             # 21o
        rotqby  $quad2_5,$quad2_2,$address+2            # 22o
        lqd     $quad3_5,0($address+3)                  # 23o
        lqd     $quad_4,0($beside)                      # 24o
        lqd     $quad1_4,0($beside1_2)                  # 25o
        lqd     $quad3_6,0($beside3_2)                  # 26o
        rotqby  $quad1_5,$quad1_2,$address+1            # 27o
        rotqby  $quad2_6,$quad2_4,$beside2_2            # 28o
        rotqby  $quad3_7,$quad3_5,$address+3            # 29o
        rotqby  $quad_5,$quad_3,$beside_3               # 30o
        rotqby  $quad1_6,$quad1_4,$beside1_2            # 31o
        shufb   $low,$quad,$quad1_5,$m_pair             # 32o
        rotqby  $quad3_8,$quad3_6,$beside3_2            # 33o
        rotqby  $quad+2,$quad2_3,$beside+2              # 34o
        lqd     $quad2_7,0($beside2_3)                  # 35o
        shufb   $high,$quad2_5,$quad3_7,$m_pair         # 36o
        rotqby  $quad,$quad_2,$beside_2                 # 37o
        shufb   $high_2,$quad+2,$quad3_8,$m_pair        # 38o
        rotqby  $quad_2,$quad_4,$beside                 # 39o
        shufb   $texel,$low,$high,$m_pairs              # 40o
        rotqby  $quad+2,$quad2_7,$beside2_3             # 41o
        rotqby  $quad3_8,$quad3_3,$beside3_3            # 42o
        shufb   $low,$quad_2,$quad1_6,$m_pair           # 43o
        rotmi   $part,$texel,-8                         # 44e
        rotqby  $quad+1,$quad+1,$beside+1               # 44o
        rotmi   $part_2,$texel,-24                      # 45e
        shufb   $high,$quad+2,$quad3_4,$m_pair          # 45o
        rotmi   $part_3,$texel,-16                      # 46e
        shufb   $high_3,$quad2_6,$quad3_8,$m_pair       # 46o
        nop     $127                                    # 47e pairing
        rotqby  $quad1_7,$quad1_3,$beside1_3            # 47o
        and     $part,$part,$k_byte                     # 48e
        shufb   $low_2,$quad,$quad+1,$m_pair            # 48o
        csflt   $part_2,$part_2,0                       # 49e
        shufb   $texel+1,$low,$high,$m_pairs            # 49o
        and     $part_3,$part_3,$k_byte                 # 50e
        lqd     $old_3,640($a_surfaces)                 # 50o
        csflt   $part,$part,0                           # 51e
        shufb   $low,$quad_5,$quad1_7,$m_pair           # 51o
        csflt   $part_4,$part_3,0                       # 52e
        shufb   $texel+3,$low_2,$high_2,$m_pairs        # 52o
        rotmi   $part+1,$texel+1,-8                     # 53e
        rotmi   $part1_2,$texel+1,-16                   # 54e
        rotmi   $part1_3,$texel+1,-24                   # 55e
        shufb   $texel+2,$low,$high_3,$m_pairs          # 55o
        rotmi   $part+3,$texel+3,-16                    # 56e
        and     $part+1,$part+1,$k_byte                 # 57e
        fma     $factor,$part,$k_square,$k_light        # 58e
        rotmi   $part+2,$texel+2,-8                     # 59e
        rotmi   $part3_2,$texel+3,-24                   # 60e
        rotmi   $part2_2,$texel+2,-16                   # 61e
        and     $part1_2,$part1_2,$k_byte               # 62e
        and     $part+2,$part+2,$k_byte                 # 63e
        csflt   $part3_2,$part3_2,0                     # 64e
        csflt   $part+2,$part+2,0                       # 65e
        and     $part2_2,$part2_2,$k_byte               # 66e
        rotmi   $part2_3,$texel+2,-24                   # 67e
        and     $part+3,$part+3,$k_byte                 # 68e
        rotmi   $part3_3,$texel+3,-8                    # 69e
        csflt   $part+3,$part+3,0                       # 70e
        csflt   $part2_3,$part2_3,0                     # 71e
        csflt   $part1_3,$part1_3,0                     # 72e
        and     $part3_3,$part3_3,$k_byte               # 73e
        csflt   $part1_2,$part1_2,0                     # 74e
        csflt   $part3_3,$part3_3,0                     # 75e
        csflt   $part+1,$part+1,0                       # 76e
        csflt   $part2_2,$part2_2,0                     # 77e
        fma     $factor_2,$part2_3,$k_square,$k_light   # 79e
        fma     $factor_3,$part_2,$k_square,$k_light    # 80e
        fma     $factor_4,$part1_2,$k_square,$k_light   # 81e
        fma     $factor_5,$part3_3,$k_square,$k_light   # 82e
        fma     $factor_6,$part+1,$k_square,$k_light    # 83e
        fma     $factor_7,$part+2,$k_square,$k_light    # 84e
        fm      $part2_3,$part2_3,$factor_2             # 85e
        fma     $factor_2,$part2_2,$k_square,$k_light   # 86e
        fm      $part1_2,$part1_2,$factor_4             # 87e
        fm      $part3_3,$part3_3,$factor_5             # 88e
        fm      $part+1,$part+1,$factor_6               # 89e
        fma     $factor_4,$part1_3,$k_square,$k_light   # 90e
        fma     $factor_5,$part3_2,$k_square,$k_light   # 91e
        fm      $part2_2,$part2_2,$factor_2             # 92e
        fma     $factor_2,$part_4,$k_square,$k_light    # 93e
        fma     $factor_6,$part+3,$k_square,$k_light    # 94e
        fm      $part_2,$part_2,$factor_3               # 95e
        fm      $part1_3,$part1_3,$factor_4             # 96e
        fm      $part3_2,$part3_2,$factor_5             # 97e
        fm      $part,$part,$factor                     # 98e
        fm      $part_4,$part_4,$factor_2               # 99e
        fm      $part+3,$part+3,$factor_6               # 100e
        fm      $part+2,$part+2,$factor_7               # 101e
        fs      $above,$part1_3,$part_2                 # 102e
        fs      $below,$part3_2,$part2_3                # 103e
        hbrr    next_row_back,next_row                  # 103o hint
        fs      $above_2,$part+1,$part                  # 104e
        fs      $above_3,$part1_2,$part_4               # 105e
        fs      $below_2,$part+3,$part2_2               # 106e
        fs      $below_3,$part3_3,$part+2               # 107e
        fma     $above,$above,$right,$part_2            # 108e
        fma     $below,$below,$right,$part2_3           # 109e
        fma     $above_4,$above_2,$right,$part          # 110e
        fma     $above_3,$above_3,$right,$part_4        # 111e
        fma     $below_4,$below_2,$right,$part2_2       # 112e
        fma     $below_5,$below_3,$right,$part+2        # 113e
        fs      $below,$below,$above                    # 115e
        fs      $below_4,$below_4,$above_3              # 118e
        fs      $below_5,$below_5,$above_4              # 119e
        fma     $above,$below,$down,$above              # 121e
        fma     $above_3,$below_4,$down,$above_3        # 124e
        fma     $above_5,$below_5,$down,$above_4        # 125e
        fm      $above,$above,$k_scale                  # 127e
        fm      $above_3,$above_3,$k_scale              # 130e
        fm      $above_5,$above_5,$k_scale              # 131e
        fm      $colour,$above,$old_3                   # 133e
        fm      $colour_2,$above_3,$old_2               # 136e
        fm      $colour_3,$above_5,$old                 # 137e
        selb    $colour,$colour,$old_3,$none            # 139e
        stqd    $colour,640($a_surfaces)                # 141o
        selb    $colour,$colour_2,$old_2,$none          # 142e
        selb    $colour_4,$colour_3,$old,$none          # 143e
        stqd    $colour,704($a_surfaces)                # 144o
        stqd    $colour_4,768($a_surfaces)              # 145o
        ai      $a_surfaces,$a_surfaces,16              # 146e
next_row_back:
        brnz    $rows,next_row                          # 146o
        nop     $127                                    # 147e pairing
        bi      $lr                                     # 147o
endfunction texture_filter_r16
