# shader_depth   the material's colour alone, which fades to black with the distance
#   C       void shader_depth(struct surfaces *, const struct rays16 *, const vec_uint4 *mask,
#                             const struct material *, const struct shading *);
#   In      $3 surfaces, $4 rays, $5 four quadwords of lanes to shade, $6 material, $7 shading;
#           pointers 16-aligned
#   Out     lit colours; no share of light, mirror or transmittance is left
#   Uses    $2, $4-$44   Saves  -   Stack  0   Calls  -
#   Domain  any
#   Error   2 ulp of 1, each channel of a colour up to 1
#   Twin    lab/twins/src/shader.rs
#
#   lit = colour clamp((far - t) scale, 0, 1), where far and scale are the first two parameters
# Scheduled by spu schedule from shader_depth.s

        .include "work_unit.inc"
        .include "macros.inc"
        .include "shader.inc"

        .set    NEXT,3
        registers a_surfaces,a_rays,a_mask,a_material
        # constants
        .set    NEXT,10
        registers k_zero,k_one,k_far,k_scale,m_second,parameters
        # a row
        registers mask,bright,c_over,colour,lit,part

        shader_entry depth

function shader_depth
        .set m_second_2,2; .set bright_2,6; .set bright_3,7; .set bright_4,4; .set colour_2,2
        .set colour_3,8; .set colour_4,9; .set colour_5,14; .set colour_6,12; .set colour_7,15
        .set colour_8,16; .set colour_9,18; .set colour_10,20; .set colour_11,21; .set colour_12,13
        .set mask_2,22; .set lit_2,23; .set c_over_2,24; .set lit_3,25; .set c_over_3,26
        .set lit_4,27; .set c_over_4,28; .set part_2,29; .set c_over_5,30; .set part_3,31
        .set part_4,24; .set part_5,26; .set mask_3,28; .set lit_5,10; .set lit_6,32
        .set c_over_6,33; .set lit_7,34; .set c_over_7,35; .set part_6,36; .set c_over_8,37
        .set part_7,38; .set part_8,30; .set part_9,33; .set mask_4,35; .set lit_8,11
        .set lit_9,37; .set lit_10,39; .set part_10,17; .set part_11,40; .set part_12,41
        .set colour_13,6; .set part_13,12; .set mask_5,5; .set lit_11,42; .set colour_14,7
        .set lit_12,18; .set lit_13,43; .set part_14,44; .set colour_15,4; .set part_15,13
        .set lit_14,19; .set part_16,23; .set lit_15,2; .set part_17,25; .set lit_16,8
        .set part_18,19; .set part_19,2; .set part_20,8; .set lit_17,6; .set part_21,6
        .set part_22,7; .set lit_18,4; .set part_23,4
        ila     $m_second,0x10203                       # 0e
        lqd     $parameters,64($a_material)             # 0o
        ilhu    $m_second_2,0x405                       # 1e
        lqd     $bright,384($a_rays)                    # 1o
        il      $k_zero,0                               # 2e
        lqd     $bright_2,400($a_rays)                  # 2o
        iohl    $m_second_2,0x607                       # 3e
        lqd     $bright_3,416($a_rays)                  # 3o
        ilhu    $k_one,0x3f80                           # 4e
        lqd     $bright_4,432($a_rays)                  # 4o
        hbr     shader_depth_return,$lr                 # 5o hint
        shufb   $k_far,$parameters,$parameters,$m_second # 6o
        shufb   $k_scale,$parameters,$parameters,$m_second_2 # 7o
        lqd     $colour,640($a_surfaces)                # 8o
        nop     $127                                    # 9e pairing
        lqd     $colour_2,704($a_surfaces)              # 9o
        fs      $bright,$k_far,$bright                  # 10e
        lqd     $colour_3,768($a_surfaces)              # 10o
        fs      $bright_2,$k_far,$bright_2              # 11e
        lqd     $colour_4,656($a_surfaces)              # 11o
        fs      $bright_3,$k_far,$bright_3              # 12e
        lqd     $colour_5,720($a_surfaces)              # 12o
        fs      $bright_4,$k_far,$bright_4              # 13e
        lqd     $colour_6,784($a_surfaces)              # 13o
        lqd     $colour_7,672($a_surfaces)              # 14o
        lqd     $colour_8,736($a_surfaces)              # 15o
        fm      $bright,$bright,$k_scale                # 16e
        lqd     $colour_9,800($a_surfaces)              # 16o
        fm      $bright_2,$bright_2,$k_scale            # 17e
        lqd     $colour_10,688($a_surfaces)             # 17o
        fm      $bright_3,$bright_3,$k_scale            # 18e
        lqd     $colour_11,752($a_surfaces)             # 18o
        fm      $bright_4,$bright_4,$k_scale            # 19e
        lqd     $colour_12,816($a_surfaces)             # 19o
        lqd     $mask_2,0($a_mask)                      # 20o
        lqd     $lit_2,0x540($a_surfaces)               # 21o
        fcgt    $c_over_2,$k_zero,$bright               # 22e
        lqd     $lit_3,0x580($a_surfaces)               # 22o
        fcgt    $c_over_3,$k_zero,$bright_2             # 23e
        lqd     $lit_4,0x5c0($a_surfaces)               # 23o
        fcgt    $c_over_4,$k_zero,$bright_3             # 24e
        lqd     $part_2,832($a_surfaces)                # 24o
        fcgt    $c_over_5,$k_zero,$bright_4             # 25e
        lqd     $part_3,896($a_surfaces)                # 25o
        selb    $bright,$bright,$k_zero,$c_over_2       # 26e
        lqd     $part_4,0x400($a_surfaces)              # 26o
        selb    $bright_2,$bright_2,$k_zero,$c_over_3   # 27e
        lqd     $part_5,0x440($a_surfaces)              # 27o
        selb    $bright_3,$bright_3,$k_zero,$c_over_4   # 28e
        lqd     $mask_3,16($a_mask)                     # 28o
        selb    $bright_4,$bright_4,$k_zero,$c_over_5   # 29e
        lqd     $lit_5,0x550($a_surfaces)               # 29o
        fcgt    $c_over_5,$bright,$k_one                # 30e
        lqd     $lit_6,0x590($a_surfaces)               # 30o
        fcgt    $c_over_6,$bright_2,$k_one              # 31e
        lqd     $lit_7,0x5d0($a_surfaces)               # 31o
        fcgt    $c_over_7,$bright_3,$k_one              # 32e
        lqd     $part_6,848($a_surfaces)                # 32o
        fcgt    $c_over_8,$bright_4,$k_one              # 33e
        lqd     $part_7,912($a_surfaces)                # 33o
        selb    $bright,$bright,$k_one,$c_over_5        # 34e
        lqd     $part_8,0x410($a_surfaces)              # 34o
        selb    $bright_2,$bright_2,$k_one,$c_over_6    # 35e
        lqd     $part_9,0x450($a_surfaces)              # 35o
        selb    $bright_3,$bright_3,$k_one,$c_over_7    # 36e
        lqd     $mask_4,32($a_mask)                     # 36o
        selb    $bright_4,$bright_4,$k_one,$c_over_8    # 37e
        lqd     $lit_8,0x560($a_surfaces)               # 37o
        fm      $colour,$colour,$bright                 # 38e
        lqd     $lit_9,0x5a0($a_surfaces)               # 38o
        fm      $colour_2,$colour_2,$bright             # 39e
        lqd     $lit_10,0x5e0($a_surfaces)              # 39o
        fm      $colour_3,$colour_3,$bright             # 40e
        lqd     $part_10,864($a_surfaces)               # 40o
        fm      $colour_4,$colour_4,$bright_2           # 41e
        lqd     $part_11,928($a_surfaces)               # 41o
        fm      $colour_5,$colour_5,$bright_2           # 42e
        lqd     $part_12,0x420($a_surfaces)             # 42o
        fm      $colour_13,$colour_6,$bright_2          # 43e
        lqd     $part_13,0x460($a_surfaces)             # 43o
        fm      $colour_7,$colour_7,$bright_3           # 44e
        lqd     $mask_5,48($a_mask)                     # 44o
        fm      $colour_8,$colour_8,$bright_3           # 45e
        lqd     $lit_11,0x570($a_surfaces)              # 45o
        fm      $colour_14,$colour_9,$bright_3          # 46e
        lqd     $lit_12,0x5b0($a_surfaces)              # 46o
        fm      $colour_10,$colour_10,$bright_4         # 47e
        lqd     $lit_13,0x5f0($a_surfaces)              # 47o
        fm      $colour_11,$colour_11,$bright_4         # 48e
        lqd     $part_14,880($a_surfaces)               # 48o
        fm      $colour_15,$colour_12,$bright_4         # 49e
        lqd     $part_15,944($a_surfaces)               # 49o
        selb    $lit_14,$lit_2,$colour,$mask_2          # 50e
        lqd     $part_16,0x430($a_surfaces)             # 50o
        selb    $lit_15,$lit_3,$colour_2,$mask_2        # 51e
        lqd     $part_17,0x470($a_surfaces)             # 51o
        selb    $lit_16,$lit_4,$colour_3,$mask_2        # 52e
        stqd    $lit_14,0x540($a_surfaces)              # 52o
        andc    $part_18,$part_2,$mask_2                # 53e
        stqd    $lit_15,0x580($a_surfaces)              # 53o
        andc    $part_19,$part_3,$mask_2                # 54e
        stqd    $lit_16,0x5c0($a_surfaces)              # 54o
        andc    $part_20,$part_4,$mask_2                # 55e
        stqd    $part_18,832($a_surfaces)               # 55o
        andc    $part_18,$part_5,$mask_2                # 56e
        stqd    $part_19,896($a_surfaces)               # 56o
        selb    $lit_15,$lit_5,$colour_4,$mask_3        # 57e
        stqd    $part_20,0x400($a_surfaces)             # 57o
        selb    $lit_16,$lit_6,$colour_5,$mask_3        # 58e
        stqd    $part_18,0x440($a_surfaces)             # 58o
        selb    $lit_17,$lit_7,$colour_13,$mask_3       # 59e
        stqd    $lit_15,0x550($a_surfaces)              # 59o
        andc    $part_19,$part_6,$mask_3                # 60e
        stqd    $lit_16,0x590($a_surfaces)              # 60o
        andc    $part_20,$part_7,$mask_3                # 61e
        stqd    $lit_17,0x5d0($a_surfaces)              # 61o
        andc    $part_21,$part_8,$mask_3                # 62e
        stqd    $part_19,848($a_surfaces)               # 62o
        andc    $part_19,$part_9,$mask_3                # 63e
        stqd    $part_20,912($a_surfaces)               # 63o
        selb    $lit_16,$lit_8,$colour_7,$mask_4        # 64e
        stqd    $part_21,0x410($a_surfaces)             # 64o
        selb    $lit_17,$lit_9,$colour_8,$mask_4        # 65e
        stqd    $part_19,0x450($a_surfaces)             # 65o
        selb    $lit_15,$lit_10,$colour_14,$mask_4      # 66e
        stqd    $lit_16,0x560($a_surfaces)              # 66o
        andc    $part_22,$part_10,$mask_4               # 67e
        stqd    $lit_17,0x5a0($a_surfaces)              # 67o
        andc    $part_21,$part_11,$mask_4               # 68e
        stqd    $lit_15,0x5e0($a_surfaces)              # 68o
        andc    $part_19,$part_12,$mask_4               # 69e
        stqd    $part_22,864($a_surfaces)               # 69o
        andc    $part_22,$part_13,$mask_4               # 70e
        stqd    $part_21,928($a_surfaces)               # 70o
        selb    $lit,$lit_11,$colour_10,$mask_5         # 71e
        stqd    $part_19,0x420($a_surfaces)             # 71o
        selb    $lit_15,$lit_12,$colour_11,$mask_5      # 72e
        stqd    $part_22,0x460($a_surfaces)             # 72o
        selb    $lit_18,$lit_13,$colour_15,$mask_5      # 73e
        stqd    $lit,0x570($a_surfaces)                 # 73o
        andc    $part,$part_14,$mask_5                  # 74e
        stqd    $lit_15,0x5b0($a_surfaces)              # 74o
        andc    $part_19,$part_15,$mask_5               # 75e
        stqd    $lit_18,0x5f0($a_surfaces)              # 75o
        andc    $part_23,$part_16,$mask_5               # 76e
        stqd    $part,880($a_surfaces)                  # 76o
        andc    $part,$part_17,$mask_5                  # 77e
        stqd    $part_19,944($a_surfaces)               # 77o
        stqd    $part_23,0x430($a_surfaces)             # 78o
        stqd    $part,0x470($a_surfaces)                # 79o
        nop     $127                                    # 80e pairing
shader_depth_return:
        bi      $lr                                     # 80o
endfunction shader_depth
