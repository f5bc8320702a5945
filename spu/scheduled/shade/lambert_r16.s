# lambert_r16   what a light adds to surfaces without a highlight
#   C       void lambert_r16(const struct site *, int count, const struct light *,
#                            const struct object *background, const struct ray_packet *);
#   In      $3 sites, $4 count (at least 1), $5 light, $6 the background's object, $7 the
#           sites' packets of shadow rays, one behind the other; pointers 16-aligned
#   Out     the sites' surfaces: lit, in lanes whose shadow ray is there (t >= 0) and has met
#           nothing
#   Uses    $2-$39, $79   Saves  -   Stack  0   Calls  -
#   Domain  N.L >= 0 where there is a shadow ray; shares from 0 to 1
#   Error   4 ulp of the brightness
#   Twin    lab/twins/src/light.rs
#
#   lit += brightness diffuse (N.L) colour
# The result has the same bits as that of light_r16 with a highlight of 0.
# Scheduled by spu schedule from lambert_r16.s

        .include "light_tmpl.inc"

function lambert_r16
        .set m_lane_2,2; .set m_lane_3,5; .set count_2,79; .set to_x_2,17; .set to_x_3,13
        .set to_y_2,16; .set to_y_3,2; .set to_z_2,14; .set a_surfaces_2,28; .set normal_x_2,21
        .set normal_x_3,5; .set normal_y_2,27; .set normal_y_3,20; .set normal_z_2,15
        .set to_x_4,11; .set t_c_2,17; .set normal_x_4,23; .set t_c_3,5; .set to_z_3,13
        .set diffuse_2,18; .set reached_2,21; .set t_c_4,22; .set t_c_5,16; .set t_c_6,2
        .set normal_x_5,24; .set normal_y_4,25; .set to_y_4,11; .set reached_3,20
        .set diffuse_3,21; .set reached_4,23; .set t_c_7,14; .set t_c_8,15; .set colour_2,27
        .set t_c_9,13; .set to_y_5,19; .set reached_5,16; .set normal_y_5,17; .set reached_6,5
        .set reached_7,11; .set t_c_10,23; .set colour_3,29; .set diffuse_4,2; .set normal_z_3,21
        .set to_z_4,15; .set reached_8,22; .set lit_2,18; .set to_z_5,19; .set colour_4,14
        .set colour_5,24; .set colour_6,30; .set lit_3,15; .set reached_9,31; .set colour_7,22
        .set lit_4,23; .set lit_5,5; .set lit_6,36; .set lit_7,11; .set lit_8,32; .set colour_8,2
        .set diffuse_5,29; .set lit_9,33; .set lit_10,34; .set lit_11,27; .set lit_12,19
        .set lit_13,35; .set reached_10,17; .set colour_9,37; .set colour_10,38; .set diffuse_6,11
        .set colour_11,13; .set lit_14,39; .set to_x_5,5; .set colour_12,15; .set colour_13,16
        .set colour_14,18; .set colour_15,11; .set normal_x_6,2; .set lit_15,20; .set lit_16,16
        .set to_y_6,13; .set normal_y_6,11; .set to_z_6,20; .set t_c_11,11; .set reached_11,18
        .set diffuse_7,19; .set reached_12,15; .set t_c_12,21; .set colour_16,19; .set colour_17,5
        .set lit_17,31; .set lit_18,21; .set reached_13,14; .set lit_19,14; .set lit_20,29
        .set colour_18,20; .set normal_z_4,22; .set diffuse_8,36; .set diffuse_9,5
        .set colour_19,3; .set lit_21,2; .set lit_22,3; .set to_x_6,2; .set normal_x_7,13
        .set normal_x_8,16; .set normal_x_9,18; .set normal_y_7,19; .set to_y_7,20
        .set normal_y_8,14; .set normal_y_9,16; .set to_y_8,17; .set to_z_7,21; .set normal_z_5,13
        .set to_z_8,17; .set diffuse_10,13; .set diffuse_11,14; .set diffuse_12,15
        .set reached_14,19; .set colour_20,23; .set colour_21,28; .set colour_22,17
        .set colour_23,25; .set lit_23,13; .set lit_24,30; .set lit_25,28; .set lit_26,25
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
        il      $step,640                               # 7e
        shufb   $bright_green,$light,$light,$m_lane_2   # 7o
        shufb   $bright_blue,$light,$light,$m_lane_3    # 8o
        brz     $count_2,next_site_short                # 9o too few passes
        ai      $count,$count,-1                        # 10e
        lqd     $a_surfaces,0($a_site)                  # 10o
        ai      $a_site,$a_site,16                      # 11e
        lqd     $to_x_2,224($a_shadow)                  # 11o
        lqd     $to_x_3,192($a_shadow)                  # 12o
        lqd     $to_y_2,288($a_shadow)                  # 13o
        lqd     $to_y_3,256($a_shadow)                  # 14o
        lqd     $to_z_2,352($a_shadow)                  # 15o
        ori     $a_surfaces_2,$a_surfaces,0             # 16e copy
        lqd     $normal_x_2,224($a_surfaces)            # 16o
        lqd     $normal_x_3,192($a_surfaces)            # 17o
        lqd     $normal_y_2,288($a_surfaces)            # 18o
        lqd     $normal_y_3,256($a_surfaces)            # 19o
        lqd     $normal_z_2,352($a_surfaces)            # 20o
        nop     $127                                    # 21e pairing
        lqd     $to_x_4,240($a_shadow)                  # 21o
        fm      $t_c_2,$normal_x_2,$to_x_2              # 22e
        lqd     $normal_x_4,240($a_surfaces)            # 22o
        fm      $t_c_3,$normal_x_3,$to_x_3              # 23e
        lqd     $to_z_3,320($a_shadow)                  # 23o
        lqd     $normal_z,320($a_surfaces)              # 24o
        lqd     $diffuse_2,864($a_surfaces)             # 25o
        lqd     $reached_2,416($a_shadow)               # 26o
        lqd     $t_c_4,480($a_shadow)                   # 27o
        fma     $t_c_5,$normal_y_2,$to_y_2,$t_c_2       # 28e
        lqd     $to_x_2,208($a_shadow)                  # 28o
        fma     $t_c_6,$normal_y_3,$to_y_3,$t_c_3       # 29e
        lqd     $normal_x_5,208($a_surfaces)            # 29o
        fm      $t_c_3,$normal_x_4,$to_x_4              # 30e
        lqd     $normal_y_4,304($a_surfaces)            # 30o
        nop     $127                                    # 31e pairing
        lqd     $to_y_4,304($a_shadow)                  # 31o
        cgti    $reached_3,$reached_2,-1                # 32e
        lqd     $diffuse_3,832($a_surfaces)             # 32o
        ceq     $t_c_4,$t_c_4,$background               # 33e
        lqd     $reached_4,384($a_shadow)               # 33o
        fma     $t_c_7,$normal_z_2,$to_z_2,$t_c_5       # 34e
        lqd     $t_c_8,448($a_shadow)                   # 34o
        fma     $t_c_6,$normal_z,$to_z_3,$t_c_6         # 35e
        lqd     $colour_2,672($a_surfaces)              # 35o
        fm      $t_c_9,$normal_x_5,$to_x_2              # 36e
        lqd     $to_y_5,272($a_shadow)                  # 36o
        and     $reached_5,$reached_3,$t_c_4            # 37e
        lqd     $normal_y_5,272($a_surfaces)            # 37o
        fma     $t_c,$normal_y_4,$to_y_4,$t_c_3         # 38e
        lqd     $reached_6,432($a_shadow)               # 38o
        cgti    $reached_7,$reached_4,-1                # 39e
        lqd     $t_c_10,496($a_shadow)                  # 39o
        fm      $diffuse,$diffuse_2,$t_c_7              # 40e
        lqd     $colour_3,736($a_surfaces)              # 40o
        fm      $diffuse_4,$diffuse_3,$t_c_6            # 41e
        lqd     $normal_z_3,368($a_surfaces)            # 41o
        ceq     $t_c_7,$t_c_8,$background               # 42e
        lqd     $to_z_4,368($a_shadow)                  # 42o
        fma     $t_c_9,$normal_y_5,$to_y_5,$t_c_9       # 43e
        lqd     $t_c_2,464($a_shadow)                   # 43o
        cgti    $reached_6,$reached_6,-1                # 44e
        lqd     $reached_8,400($a_shadow)               # 44o
        ceq     $t_c_10,$t_c_10,$background             # 45e
        lqd     $lit_2,0x560($a_surfaces)               # 45o
        and     $diffuse,$diffuse,$reached_5            # 46e
        lqd     $to_z_5,336($a_shadow)                  # 46o
        and     $reached_7,$reached_7,$t_c_7            # 47e
        lqd     $colour_4,768($a_surfaces)              # 47o
        fm      $colour_5,$colour_2,$diffuse            # 48e
        lqd     $colour_2,640($a_surfaces)              # 48o
        fm      $colour_3,$colour_3,$diffuse            # 49e
        lqd     $colour_6,704($a_surfaces)              # 49o
        fma     $t_c,$normal_z_3,$to_z_4,$t_c           # 50e
        lqd     $lit_3,0x5a0($a_surfaces)               # 50o
        ceq     $t_c_2,$t_c_2,$background               # 51e
        lqd     $normal_z_3,336($a_surfaces)            # 51o
        cgti    $reached_9,$reached_8,-1                # 52e
        lqd     $colour_7,800($a_surfaces)              # 52o
        and     $reached_5,$reached_6,$t_c_10           # 53e
        lqd     $lit_4,0x540($a_surfaces)               # 53o
        and     $diffuse_4,$diffuse_4,$reached_7        # 54e
        lqd     $lit_5,0x580($a_surfaces)               # 54o
        fma     $lit_6,$bright_red,$colour_5,$lit_2     # 55e
        lqd     $lit_2,0x5e0($a_surfaces)               # 55o
        fm      $colour_5,$colour_6,$diffuse_4          # 56e
        lqd     $lit_7,0x5c0($a_surfaces)               # 56o
        fm      $colour_4,$colour_4,$diffuse_4          # 57e
        lqd     $lit_8,0x5d0($a_surfaces)               # 57o
        fm      $colour_8,$colour_2,$diffuse_4          # 58e
        hbrr    next_site_back,next_site                # 58o hint
        fma     $lit_3,$bright_green,$colour_3,$lit_3   # 59e
        lqd     $diffuse_5,848($a_surfaces)             # 59o
        fma     $t_c_9,$normal_z_3,$to_z_5,$t_c_9       # 60e
        lqd     $diffuse_3,880($a_surfaces)             # 60o
        fm      $colour_6,$colour_7,$diffuse            # 61e
        lqd     $lit_9,0x570($a_surfaces)               # 61o
        fma     $lit,$bright_green,$colour_5,$lit_5     # 62e
        lqd     $lit_10,0x590($a_surfaces)              # 62o
        fma     $lit_5,$bright_blue,$colour_4,$lit_7    # 63e
        lqd     $lit_11,0x5f0($a_surfaces)              # 63o
        fma     $lit_12,$bright_red,$colour_8,$lit_4    # 64e
        lqd     $lit_13,0x5b0($a_surfaces)              # 64o
        and     $reached_10,$reached_9,$t_c_2           # 65e
        lqd     $colour_9,720($a_surfaces)              # 65o
        fm      $diffuse,$diffuse_3,$t_c                # 66e
        lqd     $colour_10,656($a_surfaces)             # 66o
        fm      $diffuse_6,$diffuse_5,$t_c_9            # 67e
        lqd     $colour_3,784($a_surfaces)              # 67o
        a       $a_shadow,$a_shadow,$step               # 68e
        lqd     $colour_11,688($a_surfaces)             # 68o
        lqd     $colour_5,752($a_surfaces)              # 69o
        lqd     $colour,816($a_surfaces)                # 70o
        lqd     $lit_14,0x550($a_surfaces)              # 71o
        stqd    $lit_6,0x560($a_surfaces_2)             # 72o
        nop     $127                                    # 73e pairing
        stqd    $lit_3,0x5a0($a_surfaces_2)             # 73o
next_site:
        ai      $count,$count,-1                        # 0e
            stqd    $lit,0x580($a_surfaces_2)           # 0o
            and     $diffuse,$diffuse,$reached_5        # 1e
        lqd     $a_surfaces,0($a_site)                  # 1o
            fma     $lit,$bright_blue,$colour_6,$lit_2  # 2e
            stqd    $lit_5,0x5c0($a_surfaces_2)         # 2o
            fm      $colour,$colour,$diffuse            # 3e
        lqd     $to_x,208($a_shadow)                    # 3o
            fm      $colour_8,$colour_11,$diffuse       # 4e
        lqd     $to_x_5,240($a_shadow)                  # 4o
            and     $diffuse_6,$diffuse_6,$reached_10   # 5e
        lqd     $to_x_3,192($a_shadow)                  # 5o
            fm      $colour_12,$colour_5,$diffuse       # 6e
            stqd    $lit_12,0x540($a_surfaces_2)        # 6o
            fm      $colour_13,$colour_9,$diffuse_6     # 7e
        lqd     $to_x_2,224($a_shadow)                  # 7o
            fm      $colour_14,$colour_3,$diffuse_6     # 8e
            stqd    $lit,0x5e0($a_surfaces_2)           # 8o
            fm      $colour_15,$colour_10,$diffuse_6    # 9e
        lqd     $to_y_5,272($a_shadow)                  # 9o
            fma     $lit,$bright_red,$colour_8,$lit_9   # 10e
        lqd     $normal_x_6,192($a_surfaces)            # 10o
            fma     $lit_15,$bright_blue,$colour,$lit_11 # 11e
        lqd     $normal_x_2,224($a_surfaces)            # 11o
            fma     $lit_3,$bright_green,$colour_12,$lit_13 # 12e
        lqd     $normal_x_4,240($a_surfaces)            # 12o
            fma     $lit_16,$bright_green,$colour_13,$lit_10 # 13e
        lqd     $normal_x_5,208($a_surfaces)            # 13o
        ai      $a_site,$a_site,16                      # 14e
        lqd     $normal_y_4,304($a_surfaces)            # 14o
            fma     $lit_2,$bright_blue,$colour_14,$lit_8 # 15e
        lqd     $normal_y_2,288($a_surfaces)            # 15o
        fm      $t_c_6,$normal_x_6,$to_x_3              # 16e
        lqd     $to_y_6,256($a_shadow)                  # 16o
        fm      $t_c_2,$normal_x_2,$to_x_2              # 17e
            stqd    $lit_15,0x5f0($a_surfaces_2)        # 17o
        fm      $t_c_3,$normal_x_4,$to_x_5              # 18e
            stqd    $lit,0x570($a_surfaces_2)           # 18o
        fm      $t_c_7,$normal_x_5,$to_x                # 19e
        lqd     $normal_y_3,256($a_surfaces)            # 19o
            fma     $lit,$bright_red,$colour_15,$lit_14 # 20e
            stqd    $lit_3,0x5b0($a_surfaces_2)         # 20o
            stqd    $lit_16,0x590($a_surfaces_2)        # 21o
        lqd     $normal_y_6,272($a_surfaces)            # 22o
        lqd     $to_y,304($a_shadow)                    # 23o
        lqd     $to_y_2,288($a_shadow)                  # 24o
        fma     $t_c_6,$normal_y_3,$to_y_6,$t_c_6       # 25e
        lqd     $to_z_3,336($a_shadow)                  # 25o
        lqd     $to_z_6,320($a_shadow)                  # 26o
        lqd     $normal_z_3,368($a_surfaces)            # 27o
        fma     $t_c_11,$normal_y_6,$to_y_5,$t_c_7      # 28e
        lqd     $normal_z,320($a_surfaces)              # 28o
        fma     $t_c,$normal_y_4,$to_y,$t_c_3           # 29e
            stqd    $lit,0x550($a_surfaces_2)           # 29o
            nop     $127                                # 30e pairing
            stqd    $lit_2,0x5d0($a_surfaces_2)         # 30o
        fma     $t_c_3,$normal_y_2,$to_y_2,$t_c_2       # 31e
        lqd     $to_z,368($a_shadow)                    # 31o
        ori     $a_surfaces_2,$a_surfaces,0             # 32e copy
        lqd     $to_z_2,352($a_shadow)                  # 32o
        nop     $127                                    # 33e pairing
        lqd     $normal_z_2,352($a_surfaces)            # 33o
        fma     $t_c_6,$normal_z,$to_z_6,$t_c_6         # 34e
        lqd     $diffuse,864($a_surfaces)               # 34o
        lqd     $t_c_2,464($a_shadow)                   # 35o
        lqd     $reached_11,416($a_shadow)              # 36o
        fma     $t_c,$normal_z_3,$to_z,$t_c             # 37e
        lqd     $reached_5,432($a_shadow)               # 37o
        nop     $127                                    # 38e pairing
        lqd     $diffuse_7,832($a_surfaces)             # 38o
        fma     $t_c_3,$normal_z_2,$to_z_2,$t_c_3       # 39e
        lqd     $t_c_7,480($a_shadow)                   # 39o
        nop     $127                                    # 40e pairing
        lqd     $reached_12,384($a_shadow)              # 40o
        ceq     $t_c_2,$t_c_2,$background               # 41e
        lqd     $t_c_12,448($a_shadow)                  # 41o
        cgti    $reached_11,$reached_11,-1              # 42e
        lqd     $reached_8,400($a_shadow)               # 42o
        cgti    $reached_5,$reached_5,-1                # 43e
        lqd     $t_c_10,496($a_shadow)                  # 43o
        fm      $diffuse_4,$diffuse_7,$t_c_6            # 44e
        lqd     $colour_16,768($a_surfaces)             # 44o
        fm      $diffuse,$diffuse,$t_c_3                # 45e
        lqd     $colour_17,640($a_surfaces)             # 45o
        cgti    $reached_12,$reached_12,-1              # 46e
        lqd     $colour_5,704($a_surfaces)              # 46o
        ceq     $t_c_12,$t_c_12,$background             # 47e
        lqd     $colour_2,672($a_surfaces)              # 47o
        cgti    $reached_8,$reached_8,-1                # 48e
        lqd     $colour_3,736($a_surfaces)              # 48o
        ceq     $t_c_7,$t_c_7,$background               # 49e
        lqd     $colour_6,800($a_surfaces)              # 49o
        ceq     $t_c_10,$t_c_10,$background             # 50e
        lqd     $lit_17,0x540($a_surfaces)              # 50o
        and     $reached_12,$reached_12,$t_c_12         # 51e
        lqd     $lit_18,0x580($a_surfaces)              # 51o
        and     $reached_13,$reached_11,$t_c_7          # 52e
        lqd     $lit_2,0x5e0($a_surfaces)               # 52o
        and     $reached_5,$reached_5,$t_c_10           # 53e
        lqd     $lit_4,0x5c0($a_surfaces)               # 53o
        and     $diffuse,$diffuse,$reached_13           # 54e
        lqd     $lit_8,0x5d0($a_surfaces)               # 54o
        and     $diffuse_4,$diffuse_4,$reached_12       # 55e
        lqd     $lit_19,0x560($a_surfaces)              # 55o
        fm      $colour_12,$colour_3,$diffuse           # 56e
        lqd     $lit_20,0x5a0($a_surfaces)              # 56o
        fm      $colour_6,$colour_6,$diffuse            # 57e
        lqd     $lit_9,0x570($a_surfaces)               # 57o
        fm      $colour_5,$colour_5,$diffuse_4          # 58e
        lqd     $lit_10,0x590($a_surfaces)              # 58o
        fm      $colour_18,$colour_2,$diffuse           # 59e
        lqd     $lit_11,0x5f0($a_surfaces)              # 59o
        and     $reached_10,$reached_8,$t_c_2           # 60e
        lqd     $lit_13,0x5b0($a_surfaces)              # 60o
        fm      $colour_16,$colour_16,$diffuse_4        # 61e
        lqd     $normal_z_4,336($a_surfaces)            # 61o
        a       $a_shadow,$a_shadow,$step               # 62e
        lqd     $diffuse_8,848($a_surfaces)             # 62o
        fm      $colour_8,$colour_17,$diffuse_4         # 63e
        lqd     $diffuse_9,880($a_surfaces)             # 63o
        nop     $127                                    # 64e pairing
        lqd     $colour_9,720($a_surfaces)              # 64o
        fma     $lit_19,$bright_red,$colour_18,$lit_19  # 65e
        lqd     $colour_10,656($a_surfaces)             # 65o
        fma     $lit_3,$bright_green,$colour_12,$lit_20 # 66e
        lqd     $colour_3,784($a_surfaces)              # 66o
        fma     $t_c_11,$normal_z_4,$to_z_3,$t_c_11     # 67e
        lqd     $colour_11,688($a_surfaces)             # 67o
        fma     $lit,$bright_green,$colour_5,$lit_18    # 68e
        lqd     $colour_5,752($a_surfaces)              # 68o
        fm      $diffuse,$diffuse_9,$t_c                # 69e
        lqd     $colour,816($a_surfaces)                # 69o
        fma     $lit_5,$bright_blue,$colour_16,$lit_4   # 70e
        lqd     $lit_14,0x550($a_surfaces)              # 70o
        nop     $127                                    # 71e pairing
        stqd    $lit_19,0x560($a_surfaces_2)            # 71o
        fma     $lit_12,$bright_red,$colour_8,$lit_17   # 72e
        stqd    $lit_3,0x5a0($a_surfaces_2)             # 72o
        fm      $diffuse_6,$diffuse_8,$t_c_11           # 73e
next_site_back:
        brnz    $count,next_site                        # 73o
next_site_drain:
        and     $diffuse,$diffuse,$reached_5            # 0e
        hbr     lambert_r16_return,$lr                  # 0o hint
        and     $diffuse_6,$diffuse_6,$reached_10       # 1e
        stqd    $lit,0x580($a_surfaces_2)               # 1o
        fm      $colour,$colour,$diffuse                # 2e
        stqd    $lit_5,0x5c0($a_surfaces_2)             # 2o
        fm      $colour_8,$colour_11,$diffuse           # 3e
        stqd    $lit_12,0x540($a_surfaces_2)            # 3o
        fm      $colour_12,$colour_5,$diffuse           # 4e
        fm      $colour_13,$colour_9,$diffuse_6         # 5e
        fm      $colour_19,$colour_10,$diffuse_6        # 6e
        fma     $lit,$bright_blue,$colour_6,$lit_2      # 7e
        fm      $colour_14,$colour_3,$diffuse_6         # 8e
        fma     $lit_15,$bright_blue,$colour,$lit_11    # 9e
        fma     $lit_21,$bright_red,$colour_8,$lit_9    # 10e
        fma     $lit_3,$bright_green,$colour_12,$lit_13 # 11e
        fma     $lit_16,$bright_green,$colour_13,$lit_10 # 12e
        lnop                                            # 12o pairing
        fma     $lit_22,$bright_red,$colour_19,$lit_14  # 13e
        stqd    $lit,0x5e0($a_surfaces_2)               # 13o
        fma     $lit_2,$bright_blue,$colour_14,$lit_8   # 14e
        stqd    $lit_15,0x5f0($a_surfaces_2)            # 15o
        stqd    $lit_21,0x570($a_surfaces_2)            # 16o
        stqd    $lit_3,0x5b0($a_surfaces_2)             # 17o
        stqd    $lit_16,0x590($a_surfaces_2)            # 18o
        stqd    $lit_22,0x550($a_surfaces_2)            # 19o
        stqd    $lit_2,0x5d0($a_surfaces_2)             # 20o
lambert_r16_return:
        bi      $lr                                     # 21o
next_site_short:
        ai      $count,$count,-1                        # 0e
        lqd     $a_surfaces,0($a_site)                  # 0o
        ai      $a_site,$a_site,16                      # 1e
        lqd     $to_x,192($a_shadow)                    # 1o
        lqd     $to_x_6,208($a_shadow)                  # 2o
        lqd     $to_x_5,224($a_shadow)                  # 3o
        lqd     $to_x_4,240($a_shadow)                  # 4o
        lqd     $to_y,256($a_shadow)                    # 5o
        lqd     $normal_x,192($a_surfaces)              # 6o
        lqd     $normal_x_7,208($a_surfaces)            # 7o
        lqd     $normal_x_8,224($a_surfaces)            # 8o
        lqd     $normal_x_9,240($a_surfaces)            # 9o
        lqd     $normal_y_7,256($a_surfaces)            # 10o
        lqd     $to_y_7,272($a_shadow)                  # 11o
        fm      $t_c,$normal_x,$to_x                    # 12e
        lqd     $normal_y_8,272($a_surfaces)            # 12o
        fm      $t_c_6,$normal_x_7,$to_x_6              # 13e
        lqd     $to_y_6,288($a_shadow)                  # 13o
        fm      $t_c_3,$normal_x_8,$to_x_5              # 14e
        lqd     $normal_y_9,288($a_surfaces)            # 14o
        fm      $t_c_11,$normal_x_9,$to_x_4             # 15e
        lqd     $to_y_8,304($a_shadow)                  # 15o
        lqd     $normal_y,304($a_surfaces)              # 16o
        lqd     $to_z_7,320($a_shadow)                  # 17o
        fma     $t_c,$normal_y_7,$to_y,$t_c             # 18e
        lqd     $normal_z,320($a_surfaces)              # 18o
        fma     $t_c_6,$normal_y_8,$to_y_7,$t_c_6       # 19e
        lqd     $to_z_2,336($a_shadow)                  # 19o
        fma     $t_c_3,$normal_y_9,$to_y_6,$t_c_3       # 20e
        lqd     $normal_z_5,336($a_surfaces)            # 20o
        nop     $127                                    # 21e pairing
        lqd     $to_z,352($a_shadow)                    # 21o
        fma     $t_c_11,$normal_y,$to_y_8,$t_c_11       # 22e
        lqd     $normal_z_2,352($a_surfaces)            # 22o
        nop     $127                                    # 23e pairing
        lqd     $to_z_8,368($a_shadow)                  # 23o
        fma     $t_c,$normal_z,$to_z_7,$t_c             # 24e
        lqd     $normal_z,368($a_surfaces)              # 24o
        nop     $127                                    # 25e pairing
        lqd     $diffuse,832($a_surfaces)               # 25o
        fma     $t_c_6,$normal_z_5,$to_z_2,$t_c_6       # 26e
        lqd     $diffuse_10,848($a_surfaces)            # 26o
        nop     $127                                    # 27e pairing
        lqd     $diffuse_11,864($a_surfaces)            # 27o
        fma     $t_c_3,$normal_z_2,$to_z,$t_c_3         # 28e
        lqd     $diffuse_12,880($a_surfaces)            # 28o
        nop     $127                                    # 29e pairing
        lqd     $reached_5,384($a_shadow)               # 29o
        fma     $t_c_11,$normal_z,$to_z_8,$t_c_11       # 30e
        lqd     $t_c_2,448($a_shadow)                   # 30o
        fm      $diffuse,$diffuse,$t_c                  # 31e
        lqd     $reached_11,400($a_shadow)              # 31o
        fm      $diffuse_4,$diffuse_10,$t_c_6           # 32e
        lqd     $t_c,464($a_shadow)                     # 32o
        nop     $127                                    # 33e pairing
        lqd     $reached,416($a_shadow)                 # 33o
        fm      $diffuse_9,$diffuse_11,$t_c_3           # 34e
        lqd     $t_c_7,480($a_shadow)                   # 34o
        cgti    $reached_5,$reached_5,-1                # 35e
        lqd     $reached_14,432($a_shadow)              # 35o
        fm      $diffuse_6,$diffuse_12,$t_c_11          # 36e
        lqd     $t_c_8,496($a_shadow)                   # 36o
        ceq     $t_c_2,$t_c_2,$background               # 37e
        lqd     $colour,640($a_surfaces)                # 37o
        cgti    $reached_11,$reached_11,-1              # 38e
        lqd     $colour_7,704($a_surfaces)              # 38o
        ceq     $t_c,$t_c,$background                   # 39e
        lqd     $colour_20,768($a_surfaces)             # 39o
        cgti    $reached,$reached,-1                    # 40e
        lqd     $colour_5,656($a_surfaces)              # 40o
        ceq     $t_c_7,$t_c_7,$background               # 41e
        lqd     $colour_2,720($a_surfaces)              # 41o
        cgti    $reached_14,$reached_14,-1              # 42e
        lqd     $colour_21,784($a_surfaces)             # 42o
        ceq     $t_c_8,$t_c_8,$background               # 43e
        lqd     $colour_3,672($a_surfaces)              # 43o
        and     $reached_5,$reached_5,$t_c_2            # 44e
        lqd     $colour_22,736($a_surfaces)             # 44o
        and     $reached_11,$reached_11,$t_c            # 45e
        lqd     $colour_23,800($a_surfaces)             # 45o
        and     $reached,$reached,$t_c_7                # 46e
        lqd     $colour_4,688($a_surfaces)              # 46o
        and     $reached_12,$reached_14,$t_c_8          # 47e
        lqd     $colour_16,752($a_surfaces)             # 47o
        and     $diffuse,$diffuse,$reached_5            # 48e
        lqd     $colour_13,816($a_surfaces)             # 48o
        and     $diffuse_4,$diffuse_4,$reached_11       # 49e
        lqd     $lit_2,0x540($a_surfaces)               # 49o
        and     $diffuse_9,$diffuse_9,$reached          # 50e
        lqd     $lit_23,0x580($a_surfaces)              # 50o
        and     $diffuse_6,$diffuse_6,$reached_12       # 51e
        lqd     $lit_3,0x5c0($a_surfaces)               # 51o
        fm      $colour,$colour,$diffuse                # 52e
        lqd     $lit_24,0x550($a_surfaces)              # 52o
        fm      $colour_7,$colour_7,$diffuse            # 53e
        lqd     $lit_17,0x590($a_surfaces)              # 53o
        fm      $colour_18,$colour_20,$diffuse          # 54e
        lqd     $lit_4,0x5d0($a_surfaces)               # 54o
        fm      $colour_5,$colour_5,$diffuse_4          # 55e
        lqd     $lit_8,0x560($a_surfaces)               # 55o
        fm      $colour_2,$colour_2,$diffuse_4          # 56e
        lqd     $lit_9,0x5a0($a_surfaces)               # 56o
        fm      $colour_8,$colour_21,$diffuse_4         # 57e
        lqd     $lit_25,0x5e0($a_surfaces)              # 57o
        fm      $colour_3,$colour_3,$diffuse_9          # 58e
        lqd     $lit_10,0x570($a_surfaces)              # 58o
        fm      $colour_22,$colour_22,$diffuse_9        # 59e
        lqd     $lit_13,0x5b0($a_surfaces)              # 59o
        fm      $colour_17,$colour_23,$diffuse_9        # 60e
        lqd     $lit_26,0x5f0($a_surfaces)              # 60o
        fm      $colour_4,$colour_4,$diffuse_6          # 61e
        fm      $colour_16,$colour_16,$diffuse_6        # 62e
        fm      $colour_15,$colour_13,$diffuse_6        # 63e
        fma     $lit_16,$bright_red,$colour,$lit_2      # 64e
        fma     $lit,$bright_green,$colour_7,$lit_23    # 65e
        fma     $lit_23,$bright_blue,$colour_18,$lit_3  # 66e
        fma     $lit_3,$bright_red,$colour_5,$lit_24    # 67e
        fma     $lit_2,$bright_green,$colour_2,$lit_17  # 68e
        fma     $lit_21,$bright_blue,$colour_8,$lit_4   # 69e
        lnop                                            # 69o pairing
        fma     $lit_15,$bright_red,$colour_3,$lit_8    # 70e
        stqd    $lit_16,0x540($a_surfaces)              # 70o
        fma     $lit_16,$bright_green,$colour_22,$lit_9 # 71e
        stqd    $lit,0x580($a_surfaces)                 # 71o
        fma     $lit,$bright_blue,$colour_17,$lit_25    # 72e
        stqd    $lit_23,0x5c0($a_surfaces)              # 72o
        fma     $lit_5,$bright_red,$colour_4,$lit_10    # 73e
        stqd    $lit_3,0x550($a_surfaces)               # 73o
        fma     $lit_23,$bright_green,$colour_16,$lit_13 # 74e
        stqd    $lit_2,0x590($a_surfaces)               # 74o
        fma     $lit_7,$bright_blue,$colour_15,$lit_26  # 75e
        stqd    $lit_21,0x5d0($a_surfaces)              # 75o
        a       $a_shadow,$a_shadow,$step               # 76e
        stqd    $lit_15,0x560($a_surfaces)              # 76o
        stqd    $lit_16,0x5a0($a_surfaces)              # 77o
        stqd    $lit,0x5e0($a_surfaces)                 # 78o
        stqd    $lit_5,0x570($a_surfaces)               # 79o
        stqd    $lit_23,0x5b0($a_surfaces)              # 80o
        stqd    $lit_7,0x5f0($a_surfaces)               # 81o
        brnz    $count,next_site_short                  # 82o
        nop     $127                                    # 83e pairing
        bi      $lr                                     # 83o
endfunction lambert_r16
