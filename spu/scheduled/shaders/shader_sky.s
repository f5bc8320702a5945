# shader_sky   a gradient from the horizon to the zenith, for what rays see that hit nothing
#   C       void shader_sky(struct surfaces *, const struct rays16 *, const vec_uint4 *mask,
#                           const struct material *, const struct shading *);
#   In      $3 surfaces, $4 rays, $5 four quadwords of lanes to shade, $6 material, $7 shading;
#           pointers 16-aligned
#   Out     lit colours
#   Uses    $2, $4-$35   Saves  -   Stack  0   Calls  -
#   Domain  any
#   Error   3 ulp of 1, each channel, of colours up to 1
#   Twin    lab/twins/src/shader.rs
#
#   lit += max(direction . up, 0) (colour - lit), where up is the first three parameters
# The background's material sends the colour at the horizon and has the zenith's as its own.
# Scheduled by spu schedule from shader_sky.s

        .include "work_unit.inc"
        .include "macros.inc"
        .include "shader.inc"

        .set    NEXT,3
        registers a_surfaces,a_rays,a_mask,a_material
        # constants
        .set    NEXT,10
        registers k_zero,m_word,parameters,up_x,up_y,up_z
        # a row
        registers mask,height,along_x,along_y,along_z,c_above
        registers red,green,blue,lit_red,lit_green,lit_blue

        shader_entry sky

function shader_sky
        .set m_word_2,2; .set m_word_3,6; .set along_x_2,7; .set along_x_3,8; .set along_x_4,9
        .set along_y_2,11; .set along_y_3,14; .set along_y_4,15; .set up_y_2,2; .set height_2,7
        .set height_3,8; .set along_z_2,16; .set height_4,9; .set along_z_3,13; .set along_z_4,4
        .set up_z_2,6; .set height_5,2; .set red_2,9; .set lit_red_2,11; .set green_2,12
        .set lit_green_2,4; .set blue_2,6; .set lit_blue_2,13; .set red_3,14; .set lit_red_3,15
        .set green_3,16; .set lit_green_3,18; .set c_above_2,19; .set blue_3,20; .set lit_blue_3,28
        .set c_above_3,29; .set red_4,30; .set lit_red_4,31; .set c_above_4,10; .set green_4,32
        .set lit_green_4,33; .set blue_4,21; .set lit_blue_4,34; .set red_5,19; .set mask_2,30
        .set mask_3,29; .set mask_4,35; .set mask_5,5; .set blue_5,10; .set red_6,7
        .set green_5,14; .set blue_6,8; .set red_7,16; .set green_6,17; .set blue_7,2
        ila     $m_word,0x10203                         # 0e
        lqd     $parameters,64($a_material)             # 0o
        ilhu    $m_word_2,0x405                         # 1e
        lqd     $along_x,192($a_rays)                   # 1o
        ilhu    $m_word_3,0x809                         # 2e
        lqd     $along_x_2,208($a_rays)                 # 2o
        iohl    $m_word_2,0x607                         # 3e
        lqd     $along_x_3,224($a_rays)                 # 3o
        iohl    $m_word_3,0xa0b                         # 4e
        lqd     $along_x_4,240($a_rays)                 # 4o
        il      $k_zero,0                               # 5e
        lqd     $along_y,256($a_rays)                   # 5o
        shufb   $up_x,$parameters,$parameters,$m_word   # 6o
        lqd     $along_y_2,272($a_rays)                 # 7o
        lqd     $along_y_3,288($a_rays)                 # 8o
        lqd     $along_y_4,304($a_rays)                 # 9o
        fm      $height,$along_x,$up_x                  # 10e
        shufb   $up_y_2,$parameters,$parameters,$m_word_2 # 10o
        fm      $height_2,$along_x_2,$up_x              # 11e
        lqd     $along_z,320($a_rays)                   # 11o
        fm      $height_3,$along_x_3,$up_x              # 12e
        lqd     $along_z_2,336($a_rays)                 # 12o
        fm      $height_4,$along_x_4,$up_x              # 13e
        lqd     $along_z_3,352($a_rays)                 # 13o
        lqd     $along_z_4,368($a_rays)                 # 14o
        shufb   $up_z_2,$parameters,$parameters,$m_word_3 # 15o
        fma     $height,$along_y,$up_y_2,$height        # 16e
        lqd     $red,640($a_surfaces)                   # 16o
        fma     $height_2,$along_y_2,$up_y_2,$height_2  # 17e
        lqd     $lit_red,0x540($a_surfaces)             # 17o
        fma     $height_3,$along_y_3,$up_y_2,$height_3  # 18e
        lqd     $green,704($a_surfaces)                 # 18o
        fma     $height_5,$along_y_4,$up_y_2,$height_4  # 19e
        lqd     $lit_green,0x580($a_surfaces)           # 19o
        lqd     $blue,768($a_surfaces)                  # 20o
        lqd     $lit_blue,0x5c0($a_surfaces)            # 21o
        fma     $height,$along_z,$up_z_2,$height        # 22e
        lqd     $red_2,656($a_surfaces)                 # 22o
        fma     $height_2,$along_z_2,$up_z_2,$height_2  # 23e
        lqd     $lit_red_2,0x550($a_surfaces)           # 23o
        fma     $height_3,$along_z_3,$up_z_2,$height_3  # 24e
        lqd     $green_2,720($a_surfaces)               # 24o
        fma     $height_5,$along_z_4,$up_z_2,$height_5  # 25e
        lqd     $lit_green_2,0x590($a_surfaces)         # 25o
        fs      $red,$red,$lit_red                      # 26e
        lqd     $blue_2,784($a_surfaces)                # 26o
        fs      $green,$green,$lit_green                # 27e
        lqd     $lit_blue_2,0x5d0($a_surfaces)          # 27o
        fs      $blue,$blue,$lit_blue                   # 28e
        lqd     $red_3,672($a_surfaces)                 # 28o
        fs      $red_2,$red_2,$lit_red_2                # 29e
        lqd     $lit_red_3,0x560($a_surfaces)           # 29o
        fcgt    $c_above,$height,$k_zero                # 30e
        lqd     $green_3,736($a_surfaces)               # 30o
        fs      $green_2,$green_2,$lit_green_2          # 31e
        lqd     $lit_green_3,0x5a0($a_surfaces)         # 31o
        fcgt    $c_above_2,$height_2,$k_zero            # 32e
        lqd     $blue_3,800($a_surfaces)                # 32o
        fs      $blue_2,$blue_2,$lit_blue_2             # 33e
        lqd     $lit_blue_3,0x5e0($a_surfaces)          # 33o
        fcgt    $c_above_3,$height_3,$k_zero            # 34e
        lqd     $red_4,688($a_surfaces)                 # 34o
        fs      $red_3,$red_3,$lit_red_3                # 35e
        lqd     $lit_red_4,0x570($a_surfaces)           # 35o
        fcgt    $c_above_4,$height_5,$k_zero            # 36e
        lqd     $green_4,752($a_surfaces)               # 36o
        fs      $green_3,$green_3,$lit_green_3          # 37e
        lqd     $lit_green_4,0x5b0($a_surfaces)         # 37o
        and     $height,$height,$c_above                # 38e
        lqd     $blue_4,816($a_surfaces)                # 38o
        fs      $blue_3,$blue_3,$lit_blue_3             # 39e
        lqd     $lit_blue_4,0x5f0($a_surfaces)          # 39o
        and     $height_2,$height_2,$c_above_2          # 40e
        hbr     shader_sky_return,$lr                   # 40o hint
        fs      $red_5,$red_4,$lit_red_4                # 41e
        lqd     $mask_2,0($a_mask)                      # 41o
        and     $height_3,$height_3,$c_above_3          # 42e
        lqd     $mask_3,16($a_mask)                     # 42o
        fs      $green_4,$green_4,$lit_green_4          # 43e
        lqd     $mask_4,32($a_mask)                     # 43o
        and     $height_5,$height_5,$c_above_4          # 44e
        lqd     $mask_5,48($a_mask)                     # 44o
        fs      $blue_5,$blue_4,$lit_blue_4             # 45e
        fma     $red,$height,$red,$lit_red              # 46e
        fma     $green,$height,$green,$lit_green        # 47e
        fma     $blue,$height,$blue,$lit_blue           # 48e
        fma     $red_2,$height_2,$red_2,$lit_red_2      # 49e
        fma     $green_2,$height_2,$green_2,$lit_green_2 # 50e
        fma     $blue_2,$height_2,$blue_2,$lit_blue_2   # 51e
        fma     $red_6,$height_3,$red_3,$lit_red_3      # 52e
        fma     $green_5,$height_3,$green_3,$lit_green_3 # 53e
        fma     $blue_6,$height_3,$blue_3,$lit_blue_3   # 54e
        fma     $red_7,$height_5,$red_5,$lit_red_4      # 55e
        fma     $green_6,$height_5,$green_4,$lit_green_4 # 56e
        fma     $blue_7,$height_5,$blue_5,$lit_blue_4   # 57e
        selb    $lit_red,$lit_red,$red,$mask_2          # 58e
        selb    $lit_green,$lit_green,$green,$mask_2    # 59e
        lnop                                            # 59o pairing
        selb    $lit_blue,$lit_blue,$blue,$mask_2       # 60e
        stqd    $lit_red,0x540($a_surfaces)             # 60o
        selb    $lit_red,$lit_red_2,$red_2,$mask_3      # 61e
        stqd    $lit_green,0x580($a_surfaces)           # 61o
        selb    $lit_green,$lit_green_2,$green_2,$mask_3 # 62e
        stqd    $lit_blue,0x5c0($a_surfaces)            # 62o
        selb    $lit_blue,$lit_blue_2,$blue_2,$mask_3   # 63e
        stqd    $lit_red,0x550($a_surfaces)             # 63o
        selb    $lit_red,$lit_red_3,$red_6,$mask_4      # 64e
        stqd    $lit_green,0x590($a_surfaces)           # 64o
        selb    $lit_green,$lit_green_3,$green_5,$mask_4 # 65e
        stqd    $lit_blue,0x5d0($a_surfaces)            # 65o
        selb    $lit_blue,$lit_blue_3,$blue_6,$mask_4   # 66e
        stqd    $lit_red,0x560($a_surfaces)             # 66o
        selb    $lit_red,$lit_red_4,$red_7,$mask_5      # 67e
        stqd    $lit_green,0x5a0($a_surfaces)           # 67o
        selb    $lit_green,$lit_green_4,$green_6,$mask_5 # 68e
        stqd    $lit_blue,0x5e0($a_surfaces)            # 68o
        selb    $lit_blue,$lit_blue_4,$blue_7,$mask_5   # 69e
        stqd    $lit_red,0x570($a_surfaces)             # 69o
        stqd    $lit_green,0x5b0($a_surfaces)           # 70o
        stqd    $lit_blue,0x5f0($a_surfaces)            # 71o
        nop     $127                                    # 72e pairing
shader_sky_return:
        bi      $lr                                     # 72o
endfunction shader_sky
