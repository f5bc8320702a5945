# shader_checker   cubes of two colours in turn, in the scene's coordinates
#   C       void shader_checker(struct surfaces *, const struct rays16 *, const vec_uint4 *mask,
#                               const struct material *, const struct shading *);
#   In      $3 surfaces, $4 rays, $5 four quadwords of lanes to shade, $6 material, $7 shading;
#           pointers 16-aligned
#   Out     the colours of lanes in odd cubes
#   Uses    $2, $4-$55   Saves  -   Stack  0   Calls  -
#   Domain  s times a coordinate within -2^22 and 2^22
#   Error   none but where a point is within its own error of a cube's side
#   Twin    lab/twins/src/shader.rs
#
# A point is in an odd cube if floor(s x + 1/1024) + floor(s y + 1/1024) + floor(s z + 1/1024) is
# odd, where s is the fourth parameter. Its colour is then that of the first three parameters.
# Because of the 1/1024, a plane on a side of the cubes, at a multiple of 1/s, is in one layer of
# cubes, and rounding does not split it between two.
# Scheduled by spu schedule from shader_checker.s

        .include "work_unit.inc"
        .include "macros.inc"
        .include "shader.inc"

        .set    a_surfaces,3
        .set    NEXT,5
        registers a_mask,a_material,a_shading
        # constants
        .set    NEXT,10
        registers k_within,m_word,parameters,eye,red,green,blue,scale,eye_x,eye_y,eye_z
        # a row
        registers place,cell,whole,c_above,cells,odd,colour

        shader_entry checker

function shader_checker
        .set m_word_2,2; .set m_word_3,4; .set place_2,7; .set place_3,8; .set m_word_4,9
        .set place_4,10; .set k_within_2,6; .set place_5,14; .set place_6,15; .set cells_2,16
        .set place_7,17; .set place_8,19; .set eye_y_2,20; .set scale_2,4; .set place_9,18
        .set cells_3,22; .set place_10,23; .set place_11,24; .set place_12,26; .set eye_z_2,13
        .set red_2,11; .set green_2,2; .set blue_2,9; .set odd_2,12; .set odd_3,20; .set odd_4,27
        .set odd_5,5; .set place_13,13; .set colour_2,26; .set colour_3,28; .set colour_4,29
        .set colour_5,30; .set colour_6,31; .set cell_2,32; .set colour_7,33; .set cell_3,34
        .set colour_8,35; .set cell_4,36; .set colour_9,37; .set cell_5,38; .set colour_10,39
        .set cell_6,40; .set colour_11,41; .set cell_7,42; .set colour_12,43; .set cell_8,44
        .set colour_13,45; .set cell_9,46; .set whole_2,47; .set whole_3,48; .set whole_4,49
        .set whole_5,50; .set whole_6,51; .set whole_7,52; .set whole_8,53; .set whole_9,54
        .set cells_4,55; .set place_14,4; .set c_above_2,6; .set cell_10,13; .set cell_11,21
        .set cell_12,47; .set c_above_3,7; .set c_above_4,8; .set c_above_5,10; .set cells_5,34
        .set whole_10,36; .set whole_11,38; .set cells_6,6; .set cells_7,7; .set cells_8,8
        .set c_above_6,14; .set c_above_7,15; .set c_above_8,16; .set c_above_9,13
        .set c_above_10,4; .set cells_9,4; .set odd_6,8; .set odd_7,6; .set odd_8,7; .set odd_9,4
        .set colour_14,5; .set colour_15,8; .set colour_16,6; .set colour_17,2; .set colour_18,4
        ila     $m_word,0x10203                         # 0e
        lqd     $eye,0($a_shading)                      # 0o
        ilhu    $m_word_2,0x405                         # 1e
        lqd     $place,0($a_surfaces)                   # 1o
        ilhu    $m_word_3,0xc0d                         # 2e
        lqd     $place_2,16($a_surfaces)                # 2o
        iohl    $m_word_2,0x607                         # 3e
        lqd     $place_3,32($a_surfaces)                # 3o
        ilhu    $m_word_4,0x809                         # 4e
        lqd     $place_4,48($a_surfaces)                # 4o
        iohl    $m_word_3,0xe0f                         # 5e
        lqd     $parameters,64($a_material)             # 5o
        iohl    $m_word_4,0xa0b                         # 6e
        shufb   $eye_x,$eye,$eye,$m_word                # 6o
        ilhu    $k_within_2,0x3a80                      # 7e 1/1024
        lqd     $place_5,64($a_surfaces)                # 7o
        il      $cells,0                                # 8e
        lqd     $place_6,80($a_surfaces)                # 8o
        il      $cells_2,0                              # 9e
        lqd     $place_7,96($a_surfaces)                # 9o
        fa      $place,$place,$eye_x                    # 10e
        lqd     $place_8,112($a_surfaces)               # 10o
        fa      $place_2,$place_2,$eye_x                # 11e
        shufb   $eye_y_2,$eye,$eye,$m_word_2            # 11o
        fa      $place_3,$place_3,$eye_x                # 12e
        shufb   $scale_2,$parameters,$parameters,$m_word_3 # 12o
        fa      $place_4,$place_4,$eye_x                # 13e
        lqd     $place_9,128($a_surfaces)               # 13o
        il      $cells_3,0                              # 14e
        lqd     $place_10,144($a_surfaces)              # 14o
        fa      $place_5,$place_5,$eye_y_2              # 15e
        lqd     $place_11,160($a_surfaces)              # 15o
        fa      $place_6,$place_6,$eye_y_2              # 16e
        lqd     $place_12,176($a_surfaces)              # 16o
        fa      $place_7,$place_7,$eye_y_2              # 17e
        shufb   $eye_z_2,$eye,$eye,$m_word_4            # 17o
        fa      $place_8,$place_8,$eye_y_2              # 18e
        shufb   $red_2,$parameters,$parameters,$m_word  # 18o
        fma     $place,$place,$scale_2,$k_within_2      # 19e
        shufb   $green_2,$parameters,$parameters,$m_word_2 # 19o
        fma     $place_2,$place_2,$scale_2,$k_within_2  # 20e
        shufb   $blue_2,$parameters,$parameters,$m_word_4 # 20o
        fma     $place_3,$place_3,$scale_2,$k_within_2  # 21e
        hbr     shader_checker_return,$lr               # 21o hint
        fma     $place_4,$place_4,$scale_2,$k_within_2  # 22e
        lqd     $odd_2,0($a_mask)                       # 22o
        fa      $place_9,$place_9,$eye_z_2              # 23e
        lqd     $odd_3,16($a_mask)                      # 23o
        fa      $place_10,$place_10,$eye_z_2            # 24e
        lqd     $odd_4,32($a_mask)                      # 24o
        fa      $place_11,$place_11,$eye_z_2            # 25e
        lqd     $odd_5,48($a_mask)                      # 25o
        fa      $place_13,$place_12,$eye_z_2            # 26e
        lqd     $colour_2,640($a_surfaces)              # 26o
        fma     $place_5,$place_5,$scale_2,$k_within_2  # 27e
        lqd     $colour_3,704($a_surfaces)              # 27o
        fma     $place_6,$place_6,$scale_2,$k_within_2  # 28e
        lqd     $colour_4,768($a_surfaces)              # 28o
        fma     $place_7,$place_7,$scale_2,$k_within_2  # 29e
        lqd     $colour_5,656($a_surfaces)              # 29o
        fma     $place_8,$place_8,$scale_2,$k_within_2  # 30e
        lqd     $colour_6,720($a_surfaces)              # 30o
        cflts   $cell_2,$place,0                        # 31e
        lqd     $colour_7,784($a_surfaces)              # 31o
        cflts   $cell_3,$place_2,0                      # 32e
        lqd     $colour_8,672($a_surfaces)              # 32o
        cflts   $cell_4,$place_3,0                      # 33e
        lqd     $colour_9,736($a_surfaces)              # 33o
        cflts   $cell_5,$place_4,0                      # 34e
        lqd     $colour_10,800($a_surfaces)             # 34o
        cflts   $cell_6,$place_5,0                      # 35e
        lqd     $colour_11,688($a_surfaces)             # 35o
        cflts   $cell_7,$place_6,0                      # 36e
        lqd     $colour_12,752($a_surfaces)             # 36o
        cflts   $cell_8,$place_7,0                      # 37e
        lqd     $colour_13,816($a_surfaces)             # 37o
        cflts   $cell_9,$place_8,0                      # 38e
        csflt   $whole_2,$cell_2,0                      # 39e
        csflt   $whole_3,$cell_3,0                      # 40e
        csflt   $whole_4,$cell_4,0                      # 41e
        csflt   $whole_5,$cell_5,0                      # 42e
        csflt   $whole_6,$cell_6,0                      # 43e
        csflt   $whole_7,$cell_7,0                      # 44e
        csflt   $whole_8,$cell_8,0                      # 45e
        csflt   $whole_9,$cell_9,0                      # 46e
        il      $cells_4,0                              # 47e
        fma     $place_9,$place_9,$scale_2,$k_within_2  # 48e
        fma     $place_10,$place_10,$scale_2,$k_within_2 # 49e
        fma     $place_11,$place_11,$scale_2,$k_within_2 # 50e
        fma     $place_14,$place_13,$scale_2,$k_within_2 # 51e
        fcgt    $c_above_2,$whole_2,$place              # 52e below 0, towards 0 is upwards
        a       $cells,$cells,$cell_2                   # 53e
        cflts   $cell_10,$place_9,0                     # 54e
        cflts   $cell_11,$place_10,0                    # 55e
        cflts   $cell_2,$place_11,0                     # 56e
        cflts   $cell_12,$place_14,0                    # 57e
        fcgt    $c_above_3,$whole_3,$place_2            # 58e below 0, towards 0 is upwards
        a       $cells_2,$cells_2,$cell_3               # 59e
        fcgt    $c_above_4,$whole_4,$place_3            # 60e below 0, towards 0 is upwards
        a       $cells_3,$cells_3,$cell_4               # 61e
        fcgt    $c_above_5,$whole_5,$place_4            # 62e below 0, towards 0 is upwards
        a       $cells_5,$cells_4,$cell_5               # 63e
        csflt   $whole_10,$cell_10,0                    # 64e
        csflt   $whole_11,$cell_11,0                    # 65e
        csflt   $whole_3,$cell_2,0                      # 66e
        csflt   $whole_4,$cell_12,0                     # 67e
        a       $cells,$cells,$c_above_2                # 68e true is -1
        a       $cells_6,$cells_2,$c_above_3            # 69e true is -1
        a       $cells_7,$cells_3,$c_above_4            # 70e true is -1
        a       $cells_8,$cells_5,$c_above_5            # 71e true is -1
        fcgt    $c_above_5,$whole_6,$place_5            # 72e below 0, towards 0 is upwards
        a       $cells,$cells,$cell_6                   # 73e
        fcgt    $c_above_6,$whole_7,$place_6            # 74e below 0, towards 0 is upwards
        a       $cells_6,$cells_6,$cell_7               # 75e
        fcgt    $c_above_7,$whole_8,$place_7            # 76e below 0, towards 0 is upwards
        a       $cells_7,$cells_7,$cell_8               # 77e
        fcgt    $c_above_8,$whole_9,$place_8            # 78e below 0, towards 0 is upwards
        a       $cells_8,$cells_8,$cell_9               # 79e
        a       $cells,$cells,$c_above_5                # 80e true is -1
        a       $cells_6,$cells_6,$c_above_6            # 81e true is -1
        a       $cells_7,$cells_7,$c_above_7            # 82e true is -1
        a       $cells_8,$cells_8,$c_above_8            # 83e true is -1
        fcgt    $c_above_5,$whole_10,$place_9           # 84e below 0, towards 0 is upwards
        a       $cells,$cells,$cell_10                  # 85e
        fcgt    $c_above_9,$whole_11,$place_10          # 86e below 0, towards 0 is upwards
        a       $cells_6,$cells_6,$cell_11              # 87e
        fcgt    $c_above,$whole_3,$place_11             # 88e below 0, towards 0 is upwards
        a       $cells_7,$cells_7,$cell_2               # 89e
        fcgt    $c_above_10,$whole_4,$place_14          # 90e below 0, towards 0 is upwards
        a       $cells_8,$cells_8,$cell_12              # 91e
        a       $cells,$cells,$c_above_5                # 92e true is -1
        a       $cells_6,$cells_6,$c_above_9            # 93e true is -1
        a       $cells_7,$cells_7,$c_above              # 94e true is -1
        a       $cells_9,$cells_8,$c_above_10           # 95e true is -1
        andi    $cells,$cells,1                         # 96e
        andi    $cells_6,$cells_6,1                     # 97e
        andi    $cells_7,$cells_7,1                     # 98e
        andi    $cells_9,$cells_9,1                     # 99e
        ceqi    $cells,$cells,1                         # 100e
        ceqi    $cells_6,$cells_6,1                     # 101e
        ceqi    $cells_7,$cells_7,1                     # 102e
        ceqi    $cells_9,$cells_9,1                     # 103e
        and     $odd_6,$odd_2,$cells                    # 104e
        and     $odd_7,$odd_3,$cells_6                  # 105e
        and     $odd_8,$odd_4,$cells_7                  # 106e
        and     $odd_9,$odd_5,$cells_9                  # 107e
        selb    $colour,$colour_2,$red_2,$odd_6         # 108e
        selb    $colour_14,$colour_3,$green_2,$odd_6    # 109e
        selb    $colour_15,$colour_4,$blue_2,$odd_6     # 110e
        stqd    $colour,640($a_surfaces)                # 110o
        selb    $colour,$colour_5,$red_2,$odd_7         # 111e
        stqd    $colour_14,704($a_surfaces)             # 111o
        selb    $colour_14,$colour_6,$green_2,$odd_7    # 112e
        stqd    $colour_15,768($a_surfaces)             # 112o
        selb    $colour_16,$colour_7,$blue_2,$odd_7     # 113e
        stqd    $colour,656($a_surfaces)                # 113o
        selb    $colour,$colour_8,$red_2,$odd_8         # 114e
        stqd    $colour_14,720($a_surfaces)             # 114o
        selb    $colour_14,$colour_9,$green_2,$odd_8    # 115e
        stqd    $colour_16,784($a_surfaces)             # 115o
        selb    $colour_16,$colour_10,$blue_2,$odd_8    # 116e
        stqd    $colour,672($a_surfaces)                # 116o
        selb    $colour,$colour_11,$red_2,$odd_9        # 117e
        stqd    $colour_14,736($a_surfaces)             # 117o
        selb    $colour_17,$colour_12,$green_2,$odd_9   # 118e
        stqd    $colour_16,800($a_surfaces)             # 118o
        selb    $colour_18,$colour_13,$blue_2,$odd_9    # 119e
        stqd    $colour,688($a_surfaces)                # 119o
        stqd    $colour_17,752($a_surfaces)             # 120o
        stqd    $colour_18,816($a_surfaces)             # 121o
        nop     $127                                    # 122e pairing
shader_checker_return:
        bi      $lr                                     # 122o
endfunction shader_checker
