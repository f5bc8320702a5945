# ambient_r16   what light from everywhere adds to surfaces
#   C       void ambient_r16(struct surfaces *, int count, const float *brightness);
#   In      $3 surfaces, one behind the other, $4 packets (at least 1), $5 red, green, blue,
#           anything; pointers 16-aligned
#   Out     the surfaces: lit
#   Uses    $2-$26   Saves  -   Stack  0   Calls  -
#   Domain  shares from 0 to 1
#   Error   3 ulp of the brightness
#   Twin    lab/twins/src/light.rs
#
#   lit += brightness diffuse colour
# Scheduled by spu schedule from ambient_r16.s

        .include "work_unit.inc"
        .include "macros.inc"

        .set    NEXT,3
        registers a_surfaces,count,a_bright
        # constants
        registers step,bright_red,bright_green,bright_blue
        # a row
        registers diffuse,colour,lit
        # temporaries
        registers bright,m_lane

function ambient_r16
        .set m_lane_2,2; .set m_lane_3,5; .set a_surfaces_2,2; .set colour_2,5; .set colour_3,12
        .set diffuse_2,13; .set colour_4,14; .set colour_5,15; .set colour_6,16; .set diffuse_3,17
        .set colour_7,10; .set colour_8,18; .set colour_9,19; .set diffuse_4,20; .set colour_10,13
        .set colour_11,21; .set colour_12,22; .set lit_2,23; .set colour_13,17; .set lit_3,19
        .set lit_4,24; .set lit_5,25; .set lit_6,26; .set colour_14,20; .set lit_7,22
        .set lit_8,11; .set lit_9,5; .set lit_10,10; .set lit_11,14; .set lit_12,15; .set lit_13,13
        ilhu    $m_lane,1                               # 0e
        lqd     $bright,0($a_bright)                    # 0o
        ilhu    $m_lane_2,0x405                         # 1e
        hbrr    next_packet_back,next_packet            # 1o hint
        iohl    $m_lane,515                             # 2e
        iohl    $m_lane_2,0x607                         # 3e
        ilhu    $m_lane_3,0x809                         # 4e
        il      $step,0x650                             # 5e
        iohl    $m_lane_3,0xa0b                         # 6e
        shufb   $bright_red,$bright,$bright,$m_lane     # 6o
        shufb   $bright_green,$bright,$bright,$m_lane_2 # 7o
        shufb   $bright_blue,$bright,$bright,$m_lane_3  # 8o
next_packet:
        ori     $a_surfaces_2,$a_surfaces,0             # 0e copy
        lqd     $diffuse,832($a_surfaces)               # 0o
        ai      $count,$count,-1                        # 1e
        lqd     $colour,640($a_surfaces)                # 1o
        lqd     $colour_2,704($a_surfaces)              # 2o
        lqd     $colour_3,768($a_surfaces)              # 3o
        lqd     $diffuse_2,848($a_surfaces)             # 4o
        lqd     $colour_4,656($a_surfaces)              # 5o
        nop     $127                                    # 6e pairing
        lqd     $colour_5,720($a_surfaces)              # 6o
        fm      $colour,$colour,$diffuse                # 7e
        lqd     $colour_6,784($a_surfaces)              # 7o
        fm      $colour_2,$colour_2,$diffuse            # 8e
        lqd     $diffuse_3,864($a_surfaces)             # 8o
        fm      $colour_7,$colour_3,$diffuse            # 9e
        lqd     $colour_3,672($a_surfaces)              # 9o
        nop     $127                                    # 10e pairing
        lqd     $colour_8,736($a_surfaces)              # 10o
        fm      $colour_4,$colour_4,$diffuse_2          # 11e
        lqd     $colour_9,800($a_surfaces)              # 11o
        fm      $colour_5,$colour_5,$diffuse_2          # 12e
        lqd     $diffuse_4,880($a_surfaces)             # 12o
        fm      $colour_10,$colour_6,$diffuse_2         # 13e
        lqd     $colour_6,688($a_surfaces)              # 13o
        nop     $127                                    # 14e pairing
        lqd     $colour_11,752($a_surfaces)             # 14o
        fm      $colour_3,$colour_3,$diffuse_3          # 15e
        lqd     $colour_12,816($a_surfaces)             # 15o
        fm      $colour_8,$colour_8,$diffuse_3          # 16e
        lqd     $lit_2,0x540($a_surfaces)               # 16o
        fm      $colour_13,$colour_9,$diffuse_3         # 17e
        lqd     $lit_3,0x580($a_surfaces)               # 17o
        nop     $127                                    # 18e pairing
        lqd     $lit_4,0x5c0($a_surfaces)               # 18o
        fm      $colour_6,$colour_6,$diffuse_4          # 19e
        lqd     $lit_5,0x550($a_surfaces)               # 19o
        fm      $colour_11,$colour_11,$diffuse_4        # 20e
        lqd     $lit_6,0x590($a_surfaces)               # 20o
        fm      $colour_14,$colour_12,$diffuse_4        # 21e
        lqd     $lit_7,0x5d0($a_surfaces)               # 21o
        fma     $lit_8,$bright_red,$colour,$lit_2       # 22e
        lqd     $lit_2,0x560($a_surfaces)               # 22o
        fma     $lit_9,$bright_green,$colour_2,$lit_3   # 23e
        lqd     $lit_3,0x5a0($a_surfaces)               # 23o
        fma     $lit_10,$bright_blue,$colour_7,$lit_4   # 24e
        lqd     $lit_4,0x5e0($a_surfaces)               # 24o
        fma     $lit_11,$bright_red,$colour_4,$lit_5    # 25e
        lqd     $lit_5,0x570($a_surfaces)               # 25o
        fma     $lit_12,$bright_green,$colour_5,$lit_6  # 26e
        lqd     $lit_6,0x5b0($a_surfaces)               # 26o
        fma     $lit_13,$bright_blue,$colour_10,$lit_7  # 27e
        lqd     $lit_7,0x5f0($a_surfaces)               # 27o
        fma     $lit,$bright_red,$colour_3,$lit_2       # 28e
        stqd    $lit_8,0x540($a_surfaces_2)             # 28o
        fma     $lit_8,$bright_green,$colour_8,$lit_3   # 29e
        stqd    $lit_9,0x580($a_surfaces_2)             # 29o
        fma     $lit_9,$bright_blue,$colour_13,$lit_4   # 30e
        stqd    $lit_10,0x5c0($a_surfaces_2)            # 30o
        fma     $lit_10,$bright_red,$colour_6,$lit_5    # 31e
        stqd    $lit_11,0x550($a_surfaces_2)            # 31o
        fma     $lit_11,$bright_green,$colour_11,$lit_6 # 32e
        stqd    $lit_12,0x590($a_surfaces_2)            # 32o
        fma     $lit_12,$bright_blue,$colour_14,$lit_7  # 33e
        stqd    $lit_13,0x5d0($a_surfaces_2)            # 33o
        a       $a_surfaces,$a_surfaces,$step           # 34e
        stqd    $lit,0x560($a_surfaces_2)               # 34o
        stqd    $lit_8,0x5a0($a_surfaces_2)             # 35o
        stqd    $lit_9,0x5e0($a_surfaces_2)             # 36o
        stqd    $lit_10,0x570($a_surfaces_2)            # 37o
        stqd    $lit_11,0x5b0($a_surfaces_2)            # 38o
        stqd    $lit_12,0x5f0($a_surfaces_2)            # 39o
next_packet_back:
        brnz    $count,next_packet                      # 40o
        nop     $127                                    # 41e pairing
        bi      $lr                                     # 41o
endfunction ambient_r16
