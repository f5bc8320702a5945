# lambert_r16   what a light adds to surfaces without a highlight
#   C       void lambert_r16(const struct site *, int count, const struct light *,
#                            const struct object *background);
#   In      $3 sites, $4 count (at least 1), $5 light, $6 the background's object; pointers
#           16-aligned
#   Out     the sites' surfaces: lit, in lanes whose shadow ray is there (t >= 0) and has met
#           nothing
#   Uses    $2-$36, $79   Saves  -   Stack  0   Calls  -
#   Domain  N.L > 0 where there is a shadow ray; shares from 0 to 1
#   Error   4 ulp of the brightness
#   Twin    lab/twins/src/light.rs
#
#   lit += brightness diffuse (N.L) colour
# The result has the same bits as that of light_r16 with a highlight of 0.
# Scheduled by spu schedule from lambert_r16.s

        .include "light_tmpl.inc"

function lambert_r16
        .set m_lane_2,2; .set m_lane_3,5; .set count_2,79; .set a_surfaces_2,28; .set normal_x_2,13
        .set normal_x_3,15; .set normal_y_2,25; .set to_x_2,5; .set to_x_3,16; .set to_y_2,18
        .set to_y_3,2; .set normal_y_3,26; .set to_x_4,22; .set t_c_2,5; .set normal_x_4,23
        .set t_c_3,13; .set to_z_2,14; .set to_z_3,15; .set normal_z_2,11; .set normal_z_3,17
        .set normal_x_5,16; .set to_x_5,24; .set t_c_4,22; .set normal_y_4,23; .set diffuse_2,13
        .set reached_2,18; .set t_c_5,14; .set reached_3,11; .set t_c_6,15; .set t_c_7,16
        .set t_c_8,17; .set normal_y_5,27; .set reached_4,21; .set diffuse_3,5; .set to_z_4,18
        .set reached_5,22; .set reached_6,23; .set t_c_9,24; .set t_c_10,2; .set colour_2,15
        .set colour_3,17; .set colour_4,19; .set colour_5,26; .set colour_6,23; .set t_c_11,36
        .set reached_7,12; .set colour_7,14; .set colour_8,27; .set colour_9,29; .set lit_2,11
        .set colour_10,12; .set lit_3,19; .set colour_11,25; .set lit_4,34; .set lit_5,33
        .set lit_6,20; .set colour_12,5; .set colour_13,30; .set lit_7,23; .set lit_8,31
        .set lit_9,12; .set lit_10,32; .set lit_11,26; .set lit_12,14; .set lit_13,15
        .set lit_14,17; .set lit_15,35; .set reached_8,19; .set lit_16,36; .set normal_z_4,20
        .set diffuse_4,22; .set diffuse_5,24; .set colour_14,18; .set colour_15,2
        .set colour_16,11; .set colour_17,20; .set lit_17,2; .set to_y_4,16; .set lit_18,21
        .set to_y_5,17; .set t_c_12,11; .set reached_9,14; .set diffuse_6,15; .set t_c_13,19
        .set t_c_14,12; .set colour_18,24; .set lit_19,18; .set lit_20,3; .set normal_x_6,2
        .set normal_x_7,5; .set to_x_6,11; .set to_x_7,13; .set to_x_8,15; .set normal_y_6,14
        .set to_y_6,11; .set normal_y_7,13; .set normal_y_8,16; .set to_y_7,19; .set to_z_5,13
        .set normal_z_5,16; .set to_z_6,17; .set diffuse_7,14; .set diffuse_8,16
        .set reached_10,17; .set diffuse_9,2; .set diffuse_10,11; .set reached_11,16
        .set colour_19,22; .set reached_12,15; .set lit_21,16; .set lit_22,13; .set lit_23,28
        .set lit_24,29; .set lit_25,30; .set lit_26,25; .set lit_27,5
        ilhu    $m_lane,1                               # 0e
        lqd     $light,16($a_light)                     # 0o
        ilhu    $m_lane_2,0x405                         # 1e
        ilhu    $m_lane_3,0x809                         # 2e
        iohl    $m_lane,515                             # 3e
        iohl    $m_lane_2,0x607                         # 4e
        iohl    $m_lane_3,0xa0b                         # 5e
        shufb   $background,$background,$background,$m_lane # 5o
        clgti   $count_2,$count,1                       # 6e at least as many passes as overlap
        shufb   $bright_red,$light,$light,$m_lane       # 6o
        shufb   $bright_green,$light,$light,$m_lane_2   # 7o
        shufb   $bright_blue,$light,$light,$m_lane_3    # 8o
        nop     $127                                    # 9e pairing
        brz     $count_2,next_site_short                # 9o too few passes
        ai      $count,$count,-1                        # 10e
        lqd     $a_surfaces,0($a_site)                  # 10o
        ai      $a_site,$a_site,16                      # 11e
        lnop                                            # 11o pairing
        ori     $a_surfaces_2,$a_surfaces,0             # 16e copy
        rotqbyi $a_shadow,$a_surfaces,8                 # 16o
        lqd     $normal_x_2,192($a_surfaces)            # 17o
        lqd     $normal_x_3,224($a_surfaces)            # 18o
        lqd     $normal_y_2,256($a_surfaces)            # 19o
        lqd     $to_x_2,224($a_shadow)                  # 20o
        lqd     $to_x_3,192($a_shadow)                  # 21o
        lqd     $to_y_2,288($a_shadow)                  # 22o
        lqd     $to_y_3,256($a_shadow)                  # 23o
        lqd     $normal_y_3,288($a_surfaces)            # 24o
        nop     $127                                    # 25e pairing
        lqd     $to_x_4,208($a_shadow)                  # 25o
        fm      $t_c_2,$normal_x_3,$to_x_2              # 26e
        lqd     $normal_x_4,208($a_surfaces)            # 26o
        fm      $t_c_3,$normal_x_2,$to_x_3              # 27e
        lqd     $to_z_2,352($a_shadow)                  # 27o
        lqd     $to_z_3,320($a_shadow)                  # 28o
        lqd     $normal_z_2,320($a_surfaces)            # 29o
        lqd     $normal_z_3,352($a_surfaces)            # 30o
        lqd     $normal_x_5,240($a_surfaces)            # 31o
        fma     $t_c_2,$normal_y_3,$to_y_2,$t_c_2       # 32e
        lqd     $to_x_5,240($a_shadow)                  # 32o
        fma     $t_c,$normal_y_2,$to_y_3,$t_c_3         # 33e
        lqd     $to_y_3,272($a_shadow)                  # 33o
        fm      $t_c_4,$normal_x_4,$to_x_4              # 34e
        lqd     $normal_y_4,272($a_surfaces)            # 34o
        lqd     $diffuse,832($a_surfaces)               # 35o
        lqd     $diffuse_2,864($a_surfaces)             # 36o
        nop     $127                                    # 37e pairing
        lqd     $reached_2,416($a_shadow)               # 37o
        fma     $t_c_2,$normal_z_3,$to_z_2,$t_c_2       # 38e
        lqd     $t_c_5,480($a_shadow)                   # 38o
        fma     $t_c,$normal_z_2,$to_z_3,$t_c           # 39e
        lqd     $reached_3,384($a_shadow)               # 39o
        fm      $t_c_6,$normal_x_5,$to_x_5              # 40e
        lqd     $t_c_7,448($a_shadow)                   # 40o
        fma     $t_c_8,$normal_y_4,$to_y_3,$t_c_4       # 41e
        lqd     $normal_y_5,304($a_surfaces)            # 41o
        nop     $127                                    # 42e pairing
        lqd     $to_y_3,304($a_shadow)                  # 42o
        cgti    $reached_4,$reached_2,-1                # 43e
        lqd     $normal_z,336($a_surfaces)              # 43o
        fm      $diffuse_3,$diffuse_2,$t_c_2            # 44e
        lqd     $to_z_4,336($a_shadow)                  # 44o
        fm      $diffuse,$diffuse,$t_c                  # 45e
        lqd     $reached_5,400($a_shadow)               # 45o
        ceq     $t_c_5,$t_c_5,$background               # 46e
        lqd     $reached_6,432($a_shadow)               # 46o
        cgti    $reached_3,$reached_3,-1                # 47e
        lqd     $t_c_9,464($a_shadow)                   # 47o
        ceq     $t_c,$t_c_7,$background                 # 48e
        lqd     $t_c_7,496($a_shadow)                   # 48o
        fma     $t_c_10,$normal_y_5,$to_y_3,$t_c_6      # 49e
        lqd     $colour_2,800($a_surfaces)              # 49o
        fma     $t_c_3,$normal_z,$to_z_4,$t_c_8         # 50e
        lqd     $colour_3,704($a_surfaces)              # 50o
        cgti    $reached_2,$reached_5,-1                # 51e
        lqd     $colour_4,640($a_surfaces)              # 51o
        cgti    $reached_5,$reached_6,-1                # 52e
        lqd     $colour_5,768($a_surfaces)              # 52o
        ceq     $t_c_9,$t_c_9,$background               # 53e
        lqd     $colour_6,672($a_surfaces)              # 53o
        ceq     $t_c_11,$t_c_7,$background              # 54e
        lqd     $to_z,368($a_shadow)                    # 54o
        and     $reached_7,$reached_4,$t_c_5            # 55e
        lqd     $colour_7,736($a_surfaces)              # 55o
        and     $reached_3,$reached_3,$t_c              # 56e
        lqd     $colour_8,720($a_surfaces)              # 56o
        and     $diffuse_3,$diffuse_3,$reached_7        # 57e
        lqd     $colour_9,688($a_surfaces)              # 57o
        and     $diffuse,$diffuse,$reached_3            # 58e
        hbrr    next_site_back,next_site                # 58o hint
        fm      $colour,$colour_6,$diffuse_3            # 59e
        lqd     $lit_2,0x560($a_surfaces)               # 59o
        fm      $colour_10,$colour_4,$diffuse           # 60e
        lqd     $lit_3,0x540($a_surfaces)               # 60o
        fm      $colour_11,$colour_5,$diffuse           # 61e
        lqd     $lit_4,0x580($a_surfaces)               # 61o
        fm      $colour_2,$colour_2,$diffuse_3          # 62e
        lqd     $lit_5,0x5e0($a_surfaces)               # 62o
        fm      $colour_3,$colour_3,$diffuse            # 63e
        lqd     $lit_6,0x5c0($a_surfaces)               # 63o
        fm      $colour_12,$colour_7,$diffuse_3         # 64e
        lqd     $colour_13,816($a_surfaces)             # 64o
        fma     $lit_7,$bright_red,$colour,$lit_2       # 65e
        lqd     $lit_8,0x570($a_surfaces)               # 65o
        fma     $lit_9,$bright_red,$colour_10,$lit_3    # 66e
        lqd     $lit_10,0x5a0($a_surfaces)              # 66o
        and     $reached_3,$reached_2,$t_c_9            # 67e
        lqd     $lit_11,0x550($a_surfaces)              # 67o
        fma     $lit_12,$bright_blue,$colour_2,$lit_5   # 68e
        lqd     $lit_5,0x5d0($a_surfaces)               # 68o
        fma     $lit_13,$bright_green,$colour_3,$lit_4  # 69e
        lqd     $lit_4,0x5b0($a_surfaces)               # 69o
        fma     $lit_14,$bright_blue,$colour_11,$lit_6  # 70e
        lqd     $lit_15,0x590($a_surfaces)              # 70o
        and     $reached_8,$reached_5,$t_c_11           # 71e
        lqd     $lit_16,0x5f0($a_surfaces)              # 71o
        lqd     $normal_z_4,368($a_surfaces)            # 72o
        lqd     $diffuse_4,848($a_surfaces)             # 73o
        lqd     $diffuse_5,880($a_surfaces)             # 74o
        lqd     $colour_14,784($a_surfaces)             # 75o
next_site:
            nop     $127                                # 0e pairing
            lqd     $colour,752($a_surfaces)            # 0o
            fma     $t_c,$normal_z_4,$to_z,$t_c_10      # 1e
            lqd     $colour_15,656($a_surfaces)         # 1o
            fm      $diffuse,$diffuse_4,$t_c_3          # 2e
        lqd     $a_surfaces,0($a_site)                  # 2o
            fma     $lit,$bright_green,$colour_12,$lit_10 # 3e
            stqd    $lit_12,0x5e0($a_surfaces_2)        # 3o
        ai      $count,$count,-1                        # 4e
            stqd    $lit_9,0x540($a_surfaces_2)         # 4o
        ai      $a_site,$a_site,16                      # 5e
            stqd    $lit_14,0x5c0($a_surfaces_2)        # 5o
            nop     $127                                # 6e pairing
            stqd    $lit_13,0x580($a_surfaces_2)        # 6o
            fm      $diffuse_3,$diffuse_5,$t_c          # 7e
            stqd    $lit_7,0x560($a_surfaces_2)         # 7o
            and     $diffuse,$diffuse,$reached_3        # 8e
        rotqbyi $a_shadow,$a_surfaces,8                 # 8o
            nop     $127                                # 9e pairing
            stqd    $lit,0x5a0($a_surfaces_2)           # 9o
            fm      $colour_16,$colour_14,$diffuse      # 10e
        lqd     $normal_x,240($a_surfaces)              # 10o
            fm      $colour_15,$colour_15,$diffuse      # 11e
        lqd     $normal_x_2,192($a_surfaces)            # 11o
            fm      $colour_7,$colour_8,$diffuse        # 12e
        lqd     $normal_x_3,224($a_surfaces)            # 12o
            and     $diffuse,$diffuse_3,$reached_8      # 13e
        lqd     $to_x_2,224($a_shadow)                  # 13o
        nop     $127                                    # 14e pairing
        lqd     $to_x_3,192($a_shadow)                  # 14o
            fm      $colour,$colour,$diffuse            # 15e
        lqd     $to_y_2,288($a_shadow)                  # 15o
            fm      $colour_4,$colour_9,$diffuse        # 16e
        lqd     $to_x_4,208($a_shadow)                  # 16o
            fma     $lit_2,$bright_blue,$colour_16,$lit_5 # 17e
        lqd     $normal_x_4,208($a_surfaces)            # 17o
            fm      $colour_17,$colour_13,$diffuse      # 18e
        lqd     $to_x_5,240($a_shadow)                  # 18o
            fma     $lit_17,$bright_red,$colour_15,$lit_11 # 19e
        lqd     $normal_y_2,256($a_surfaces)            # 19o
        fm      $t_c_2,$normal_x_3,$to_x_2              # 20e
        lqd     $to_y,272($a_shadow)                    # 20o
        fm      $t_c_3,$normal_x_2,$to_x_3              # 21e
        lqd     $to_y_4,256($a_shadow)                  # 21o
            fma     $lit_18,$bright_green,$colour,$lit_4 # 22e
        lqd     $normal_y_3,288($a_surfaces)            # 22o
            fma     $lit_3,$bright_red,$colour_4,$lit_8 # 23e
        lqd     $normal_y_5,304($a_surfaces)            # 23o
        fm      $t_c_4,$normal_x_4,$to_x_4              # 24e
        lqd     $normal_y_4,272($a_surfaces)            # 24o
            fma     $lit_12,$bright_green,$colour_7,$lit_15 # 25e
            stqd    $lit_17,0x550($a_surfaces_2)        # 25o
        fm      $t_c_10,$normal_x,$to_x_5               # 26e
            stqd    $lit_2,0x5d0($a_surfaces_2)         # 26o
            fma     $lit_2,$bright_blue,$colour_17,$lit_16 # 27e
        lqd     $to_y_5,304($a_shadow)                  # 27o
        fma     $t_c,$normal_y_2,$to_y_4,$t_c_3         # 28e
            stqd    $lit_18,0x5b0($a_surfaces_2)        # 28o
        fma     $t_c_2,$normal_y_3,$to_y_2,$t_c_2       # 29e
            stqd    $lit_3,0x570($a_surfaces_2)         # 29o
        fma     $t_c_3,$normal_y_4,$to_y,$t_c_4         # 30e
        lqd     $to_z,368($a_shadow)                    # 30o
        lqd     $normal_z,336($a_surfaces)              # 31o
            stqd    $lit_12,0x590($a_surfaces_2)        # 32o
        lqd     $to_z_2,352($a_shadow)                  # 33o
        lqd     $to_z_3,320($a_shadow)                  # 34o
        fma     $t_c_10,$normal_y_5,$to_y_5,$t_c_10     # 35e
            stqd    $lit_2,0x5f0($a_surfaces_2)         # 35o
        ori     $a_surfaces_2,$a_surfaces,0             # 36e copy
        lqd     $normal_z_2,320($a_surfaces)            # 36o
        lqd     $normal_z_3,352($a_surfaces)            # 37o
        lqd     $to_z_4,336($a_shadow)                  # 38o
        lqd     $diffuse,832($a_surfaces)               # 39o
        lqd     $reached_4,400($a_shadow)               # 40o
        nop     $127                                    # 41e pairing
        lqd     $reached_5,416($a_shadow)               # 41o
        fma     $t_c,$normal_z_2,$to_z_3,$t_c           # 42e
        lqd     $t_c_12,480($a_shadow)                  # 42o
        fma     $t_c_2,$normal_z_3,$to_z_2,$t_c_2       # 43e
        lqd     $reached_9,432($a_shadow)               # 43o
        fma     $t_c_3,$normal_z,$to_z_4,$t_c_3         # 44e
        lqd     $diffuse_6,864($a_surfaces)             # 44o
        nop     $127                                    # 45e pairing
        lqd     $t_c_8,464($a_shadow)                   # 45o
        cgti    $reached_2,$reached_4,-1                # 46e
        lqd     $t_c_13,496($a_shadow)                  # 46o
        cgti    $reached_4,$reached_5,-1                # 47e
        lqd     $reached_5,384($a_shadow)               # 47o
        ceq     $t_c_12,$t_c_12,$background             # 48e
        lqd     $t_c_14,448($a_shadow)                  # 48o
        fm      $diffuse,$diffuse,$t_c                  # 49e
        lqd     $colour_6,736($a_surfaces)              # 49o
        cgti    $reached_9,$reached_9,-1                # 50e
        lqd     $colour_18,800($a_surfaces)             # 50o
        fm      $diffuse_3,$diffuse_6,$t_c_2            # 51e
        lqd     $colour_2,704($a_surfaces)              # 51o
        ceq     $t_c,$t_c_8,$background                 # 52e
        lqd     $colour_3,640($a_surfaces)              # 52o
        ceq     $t_c_13,$t_c_13,$background             # 53e
        lqd     $colour_5,768($a_surfaces)              # 53o
        cgti    $reached_5,$reached_5,-1                # 54e
        lqd     $colour_8,720($a_surfaces)              # 54o
        ceq     $t_c_14,$t_c_14,$background             # 55e
        lqd     $colour_9,688($a_surfaces)              # 55o
        and     $reached_3,$reached_4,$t_c_12           # 56e
        lqd     $colour,672($a_surfaces)                # 56o
        and     $reached_7,$reached_5,$t_c_14           # 57e
        lqd     $colour_13,816($a_surfaces)             # 57o
        and     $diffuse_3,$diffuse_3,$reached_3        # 58e
        lqd     $lit,0x560($a_surfaces)                 # 58o
        and     $diffuse,$diffuse,$reached_7            # 59e
        lqd     $lit_8,0x570($a_surfaces)               # 59o
        and     $reached_3,$reached_2,$t_c              # 60e
        lqd     $lit_9,0x540($a_surfaces)               # 60o
        fm      $colour_3,$colour_3,$diffuse            # 61e
        lqd     $lit_19,0x580($a_surfaces)              # 61o
        fm      $colour,$colour,$diffuse_3              # 62e
        lqd     $lit_10,0x5a0($a_surfaces)              # 62o
        fm      $colour_11,$colour_5,$diffuse           # 63e
        lqd     $lit_11,0x550($a_surfaces)              # 63o
        fm      $colour_18,$colour_18,$diffuse_3        # 64e
        lqd     $lit_5,0x5d0($a_surfaces)               # 64o
        and     $reached_8,$reached_9,$t_c_13           # 65e
        lqd     $lit_12,0x5e0($a_surfaces)              # 65o
        fm      $colour_2,$colour_2,$diffuse            # 66e
        lqd     $lit_4,0x5b0($a_surfaces)               # 66o
        fma     $lit_9,$bright_red,$colour_3,$lit_9     # 67e
        lqd     $lit_14,0x5c0($a_surfaces)              # 67o
        nop     $127                                    # 68e pairing
        lqd     $lit_15,0x590($a_surfaces)              # 68o
        fm      $colour_12,$colour_6,$diffuse_3         # 69e
        lqd     $lit_16,0x5f0($a_surfaces)              # 69o
        nop     $127                                    # 70e pairing
        lqd     $normal_z_4,368($a_surfaces)            # 70o
        fma     $lit_7,$bright_red,$colour,$lit         # 71e
        lqd     $diffuse_4,848($a_surfaces)             # 71o
        fma     $lit_12,$bright_blue,$colour_18,$lit_12 # 72e
        lqd     $diffuse_5,880($a_surfaces)             # 72o
        fma     $lit_13,$bright_green,$colour_2,$lit_19 # 73e
        lqd     $colour_14,784($a_surfaces)             # 73o
        fma     $lit_14,$bright_blue,$colour_11,$lit_14 # 74e
next_site_back:
        brnz    $count,next_site                        # 74o
next_site_drain:
        fma     $t_c,$normal_z_4,$to_z,$t_c_10          # 0e
        lqd     $colour_15,656($a_surfaces)             # 0o
        fm      $diffuse,$diffuse_4,$t_c_3              # 1e
        lqd     $colour,752($a_surfaces)                # 1o
        fma     $lit,$bright_green,$colour_12,$lit_10   # 2e
        hbr     lambert_r16_return,$lr                  # 2o hint
        stqd    $lit_12,0x5e0($a_surfaces_2)            # 3o
        stqd    $lit_9,0x540($a_surfaces_2)             # 4o
        nop     $127                                    # 5e pairing
        stqd    $lit_14,0x5c0($a_surfaces_2)            # 5o
        fm      $diffuse_3,$diffuse_5,$t_c              # 6e
        stqd    $lit_13,0x580($a_surfaces_2)            # 6o
        and     $diffuse,$diffuse,$reached_3            # 7e
        stqd    $lit_7,0x560($a_surfaces_2)             # 7o
        stqd    $lit,0x5a0($a_surfaces_2)               # 8o
        fm      $colour_15,$colour_15,$diffuse          # 9e
        fm      $colour_16,$colour_14,$diffuse          # 10e
        fm      $colour_7,$colour_8,$diffuse            # 11e
        and     $diffuse,$diffuse_3,$reached_8          # 12e
        fm      $colour,$colour,$diffuse                # 14e
        fm      $colour_4,$colour_9,$diffuse            # 15e
        fm      $colour_17,$colour_13,$diffuse          # 16e
        fma     $lit_17,$bright_red,$colour_15,$lit_11  # 17e
        fma     $lit_2,$bright_blue,$colour_16,$lit_5   # 18e
        fma     $lit_12,$bright_green,$colour_7,$lit_15 # 19e
        fma     $lit_18,$bright_green,$colour,$lit_4    # 20e
        fma     $lit_3,$bright_red,$colour_4,$lit_8     # 21e
        fma     $lit_20,$bright_blue,$colour_17,$lit_16 # 22e
        stqd    $lit_17,0x550($a_surfaces_2)            # 23o
        stqd    $lit_2,0x5d0($a_surfaces_2)             # 24o
        stqd    $lit_18,0x5b0($a_surfaces_2)            # 26o
        stqd    $lit_3,0x570($a_surfaces_2)             # 27o
        stqd    $lit_12,0x590($a_surfaces_2)            # 28o
        stqd    $lit_20,0x5f0($a_surfaces_2)            # 29o
        nop     $127                                    # 30e pairing
lambert_r16_return:
        bi      $lr                                     # 30o
next_site_short:
        ai      $count,$count,-1                        # 0e
        lqd     $a_surfaces,0($a_site)                  # 0o
        ai      $a_site,$a_site,16                      # 1e
        rotqbyi $a_shadow,$a_surfaces,8                 # 6o
        lqd     $normal_x,192($a_surfaces)              # 7o
        lqd     $normal_x_6,208($a_surfaces)            # 8o
        lqd     $normal_x_7,224($a_surfaces)            # 9o
        lqd     $to_x,192($a_shadow)                    # 10o
        lqd     $to_x_6,208($a_shadow)                  # 11o
        lqd     $to_x_7,224($a_shadow)                  # 12o
        lqd     $to_x_8,240($a_shadow)                  # 13o
        lqd     $normal_x_5,240($a_surfaces)            # 14o
        nop     $127                                    # 15e pairing
        lqd     $to_y_2,256($a_shadow)                  # 15o
        fm      $t_c,$normal_x,$to_x                    # 16e
        lqd     $normal_y_6,256($a_surfaces)            # 16o
        fm      $t_c_10,$normal_x_6,$to_x_6             # 17e
        lqd     $to_y_6,272($a_shadow)                  # 17o
        fm      $t_c_2,$normal_x_7,$to_x_7              # 18e
        lqd     $normal_y_7,272($a_surfaces)            # 18o
        nop     $127                                    # 19e pairing
        lqd     $to_y_5,288($a_shadow)                  # 19o
        fm      $t_c_6,$normal_x_5,$to_x_8              # 20e
        lqd     $normal_y_8,288($a_surfaces)            # 20o
        nop     $127                                    # 21e pairing
        lqd     $to_y_7,304($a_shadow)                  # 21o
        fma     $t_c,$normal_y_6,$to_y_2,$t_c           # 22e
        lqd     $normal_y,304($a_surfaces)              # 22o
        nop     $127                                    # 23e pairing
        lqd     $to_z_2,320($a_shadow)                  # 23o
        fma     $t_c_10,$normal_y_7,$to_y_6,$t_c_10     # 24e
        lqd     $normal_z_2,320($a_surfaces)            # 24o
        nop     $127                                    # 25e pairing
        lqd     $to_z_5,336($a_shadow)                  # 25o
        fma     $t_c_2,$normal_y_8,$to_y_5,$t_c_2       # 26e
        lqd     $normal_z_5,336($a_surfaces)            # 26o
        nop     $127                                    # 27e pairing
        lqd     $to_z_6,352($a_shadow)                  # 27o
        fma     $t_c_6,$normal_y,$to_y_7,$t_c_6         # 28e
        lqd     $normal_z,352($a_surfaces)              # 28o
        nop     $127                                    # 29e pairing
        lqd     $to_z_4,368($a_shadow)                  # 29o
        fma     $t_c,$normal_z_2,$to_z_2,$t_c           # 30e
        lqd     $normal_z_2,368($a_surfaces)            # 30o
        nop     $127                                    # 31e pairing
        lqd     $diffuse,832($a_surfaces)               # 31o
        fma     $t_c_10,$normal_z_5,$to_z_5,$t_c_10     # 32e
        lqd     $diffuse_2,848($a_surfaces)             # 32o
        nop     $127                                    # 33e pairing
        lqd     $diffuse_7,864($a_surfaces)             # 33o
        fma     $t_c_2,$normal_z,$to_z_6,$t_c_2         # 34e
        lqd     $diffuse_8,880($a_surfaces)             # 34o
        nop     $127                                    # 35e pairing
        lqd     $reached_10,384($a_shadow)              # 35o
        fma     $t_c_12,$normal_z_2,$to_z_4,$t_c_6      # 36e
        lqd     $t_c_6,448($a_shadow)                   # 36o
        fm      $diffuse,$diffuse,$t_c                  # 37e
        lqd     $reached_2,400($a_shadow)               # 37o
        fm      $diffuse_9,$diffuse_2,$t_c_10           # 38e
        lqd     $t_c,464($a_shadow)                     # 38o
        nop     $127                                    # 39e pairing
        lqd     $reached,416($a_shadow)                 # 39o
        fm      $diffuse_3,$diffuse_7,$t_c_2            # 40e
        lqd     $t_c_5,480($a_shadow)                   # 40o
        cgti    $reached_10,$reached_10,-1              # 41e
        lqd     $reached_8,432($a_shadow)               # 41o
        fm      $diffuse_10,$diffuse_8,$t_c_12          # 42e
        lqd     $t_c_14,496($a_shadow)                  # 42o
        ceq     $t_c_6,$t_c_6,$background               # 43e
        lqd     $colour,640($a_surfaces)                # 43o
        cgti    $reached_11,$reached_2,-1               # 44e
        lqd     $colour_14,704($a_surfaces)             # 44o
        ceq     $t_c,$t_c,$background                   # 45e
        lqd     $colour_19,768($a_surfaces)             # 45o
        cgti    $reached,$reached,-1                    # 46e
        lqd     $colour_6,656($a_surfaces)              # 46o
        ceq     $t_c_5,$t_c_5,$background               # 47e
        lqd     $colour_18,720($a_surfaces)             # 47o
        cgti    $reached_8,$reached_8,-1                # 48e
        lqd     $colour_5,784($a_surfaces)              # 48o
        ceq     $t_c_14,$t_c_14,$background             # 49e
        lqd     $colour_8,672($a_surfaces)              # 49o
        and     $reached_12,$reached_10,$t_c_6          # 50e
        lqd     $colour_3,736($a_surfaces)              # 50o
        and     $reached_11,$reached_11,$t_c            # 51e
        lqd     $colour_11,800($a_surfaces)             # 51o
        and     $reached,$reached,$t_c_5                # 52e
        lqd     $colour_7,688($a_surfaces)              # 52o
        and     $reached_7,$reached_8,$t_c_14           # 53e
        lqd     $colour_4,752($a_surfaces)              # 53o
        and     $diffuse,$diffuse,$reached_12           # 54e
        lqd     $colour_2,816($a_surfaces)              # 54o
        and     $diffuse_9,$diffuse_9,$reached_11       # 55e
        lqd     $lit_21,0x540($a_surfaces)              # 55o
        and     $diffuse_3,$diffuse_3,$reached          # 56e
        lqd     $lit_22,0x580($a_surfaces)              # 56o
        and     $diffuse_10,$diffuse_10,$reached_7      # 57e
        lqd     $lit_9,0x5c0($a_surfaces)               # 57o
        fm      $colour,$colour,$diffuse                # 58e
        lqd     $lit_23,0x550($a_surfaces)              # 58o
        fm      $colour_14,$colour_14,$diffuse          # 59e
        lqd     $lit_24,0x590($a_surfaces)              # 59o
        fm      $colour_17,$colour_19,$diffuse          # 60e
        lqd     $lit,0x5d0($a_surfaces)                 # 60o
        fm      $colour_6,$colour_6,$diffuse_9          # 61e
        lqd     $lit_25,0x560($a_surfaces)              # 61o
        fm      $colour_18,$colour_18,$diffuse_9        # 62e
        lqd     $lit_8,0x5a0($a_surfaces)               # 62o
        fm      $colour_15,$colour_5,$diffuse_9         # 63e
        lqd     $lit_11,0x5e0($a_surfaces)              # 63o
        fm      $colour_8,$colour_8,$diffuse_3          # 64e
        lqd     $lit_10,0x570($a_surfaces)              # 64o
        fm      $colour_3,$colour_3,$diffuse_3          # 65e
        lqd     $lit_5,0x5b0($a_surfaces)               # 65o
        fm      $colour_12,$colour_11,$diffuse_3        # 66e
        lqd     $lit_26,0x5f0($a_surfaces)              # 66o
        fm      $colour_7,$colour_7,$diffuse_10         # 67e
        fm      $colour_4,$colour_4,$diffuse_10         # 68e
        fm      $colour_16,$colour_2,$diffuse_10        # 69e
        fma     $lit_13,$bright_red,$colour,$lit_21     # 70e
        fma     $lit_22,$bright_green,$colour_14,$lit_22 # 71e
        fma     $lit_9,$bright_blue,$colour_17,$lit_9   # 72e
        fma     $lit_21,$bright_red,$colour_6,$lit_23   # 73e
        fma     $lit_19,$bright_green,$colour_18,$lit_24 # 74e
        fma     $lit,$bright_blue,$colour_15,$lit       # 75e
        lnop                                            # 75o pairing
        fma     $lit_17,$bright_red,$colour_8,$lit_25   # 76e
        stqd    $lit_13,0x540($a_surfaces)              # 76o
        fma     $lit_13,$bright_green,$colour_3,$lit_8  # 77e
        stqd    $lit_22,0x580($a_surfaces)              # 77o
        fma     $lit_27,$bright_blue,$colour_12,$lit_11 # 78e
        stqd    $lit_9,0x5c0($a_surfaces)               # 78o
        fma     $lit_9,$bright_red,$colour_7,$lit_10    # 79e
        stqd    $lit_21,0x550($a_surfaces)              # 79o
        fma     $lit_22,$bright_green,$colour_4,$lit_5  # 80e
        stqd    $lit_19,0x590($a_surfaces)              # 80o
        fma     $lit_2,$bright_blue,$colour_16,$lit_26  # 81e
        stqd    $lit,0x5d0($a_surfaces)                 # 81o
        stqd    $lit_17,0x560($a_surfaces)              # 82o
        stqd    $lit_13,0x5a0($a_surfaces)              # 83o
        stqd    $lit_27,0x5e0($a_surfaces)              # 84o
        stqd    $lit_9,0x570($a_surfaces)               # 85o
        stqd    $lit_22,0x5b0($a_surfaces)              # 86o
        stqd    $lit_2,0x5f0($a_surfaces)               # 87o
        nop     $127                                    # 88e pairing
        brnz    $count,next_site_short                  # 88o
        nop     $127                                    # 89e pairing
        bi      $lr                                     # 89o
endfunction lambert_r16
