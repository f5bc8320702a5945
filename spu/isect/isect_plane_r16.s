# isect_plane_r16   nearest hit of sixteen rays with a plane, from both sides
#   C       void isect_plane_r16(struct rays *, const struct rectangle *, int object);
#   In      $3 rays, $4 rectangle in the plane, $5 object number; pointers 16-aligned
#   Out     rays: t, object, u, v, where a hit has 0 < t < what was there
#   Uses    $2, $4-$62   Saves  -   Stack  0   Calls  -
#   Domain  as isect_rectangle_r16
#   Error   20 ulp of t, 5e-4 in u and v; edges from 1/100 of the distance to all of it, 30 degrees
#           or more apart; incidence within 84 degrees of the normal; u and v from
#           -0.5 to 1.5
#   Twin    oracle/src/twin/rectangle.rs
#
# As isect_rectangle_r16, but u and v may be any; what it says of a ray along the plane holds.
# Scheduled by spu schedule from isect_plane_r16.s

        .include "macros.inc"
        .include "rays.inc"
        .include "flat.inc"
        .include "rectangle_tmpl.inc"

        .set    a_rays,3
        .set    a_rectangle,4
        .set    object,5
        # constants
        .set    k_x,10
        .set    k_y,11
        .set    k_z,12
        .set    k_one,13
        .set    k_sign,14
        .set    a_controls,15
        .set    n_best,42
        .set    nearest,43
        .set    u_best,44
        .set    v_best,45
        .set    control,46

        sign_controls_table

function isect_plane_r16
        .set    record_2,2
        .set    direction_x_2,6
        .set    direction_x_3,7
        .set    direction_y_2,8
        .set    along_2,9
        .set    beside_y_2,16
        .set    direction_x_4,17
        .set    along_3,21
        .set    direction_y_3,22
        .set    a_controls1_2,23
        .set    direction_y_4,24
        .set    beside_x_2,25
        .set    along_4,26
        .set    direction_z_2,27
        .set    direction_z_3,31
        .set    normal_z_2,28
        .set    beside_y_3,36
        .set    beside_z_2,37
        .set    point_y_2,2
        .set    direction_z_4,38
        .set    beside_x_3,39
        .set    beside_z_3,40
        .set    beside_x_4,41
        .set    beside_z_4,42
        .set    beside_y_4,43
        .set    n_best_2,44
        .set    t_y_2,45
        .set    t_y_3,46
        .set    n_best_3,47
        .set    beside_z_5,48
        .set    n_best_4,49
        .set    t_y_4,50
        .set    record_3,51
        .set    n_2,52
        .set    t_y_5,53
        .set    beside_x_5,23
        .set    record_4,4
        .set    beside_z_6,41
        .set    n_best_5,48
        .set    v_best_2,54
        .set    nearest_2,55
        .set    dual_u_x_2,56
        .set    t_e_2,21
        .set    dual_u_y_2,57
        .set    dual_v_y_2,11
        .set    n_3,58
        .set    dual_u_z_2,51
        .set    dual_v_x_2,59
        .set    t_e_3,26
        .set    v_best_3,60
        .set    t_e_4,35
        .set    dual_v_z_2,4
        .set    inverse_2,12
        .set    n_4,21
        .set    v_best_4,61
        .set    nearest_3,62
        .set    beside_z_7,18
        .set    n_5,10
        .set    nearest_4,19
        .set    inverse_3,35
        .set    u_best_2,37
        .set    beside_y_5,2
        .set    u_best_3,43
        .set    u_best_4,46
        .set    n_6,12
        .set    nearest_5,52
        .set    t_e_5,9
        .set    u_best_5,13
        .set    inverse_4,26
        .set    n_7,20
        .set    control_2,50
        .set    control_3,22
        .set    inverse_5,9
        .set    beside_x_6,7
        .set    beside_z_8,27
        .set    n_8,9
        .set    control_4,20
        .set    u_2,21
        .set    v_2,7
        .set    beside_y_6,8
        .set    control_5,16
        .set    control_6,26
        .set    control_7,17
        .set    beside_y_7,26
        .set    nearest_6,28
        .set    beside_x_7,6
        .set    u_3,23
        .set    v_3,24
        .set    beside_z_9,28
        .set    n_best_6,12
        .set    u_4,25
        .set    u_best_6,7
        .set    v_4,23
        .set    control_8,15
        .set    v_5,6
        .set    u_5,20
        .set    n_best_7,24
        .set    nearest_7,26
        .set    v_6,18
        .set    nearest_8,5
        .set    n_best_8,10
        .set    u_6,2
        .set    v_best_5,16
        .set    n_best_9,7
        .set    n_best_10,8
        .set    v_best_6,4
        .set    v_best_7,5
        .set    u_best_7,2
        ila     $k_x,0x10203                            # 0e
        lqd     $record,16($a_rectangle)                # 0o

        ilhu    $k_z,0x809                              # 1e
        lqd     $direction_x,208($a_rays)               # 1o

        ilhu    $k_y,0x405                              # 2e
        lqd     $record_2,0($a_rectangle)               # 2o

        iohl    $k_z,0xa0b                              # 3e
        lqd     $direction_y,288($a_rays)               # 3o

        iohl    $k_y,0x607                              # 4e
        lqd     $direction_x_2,240($a_rays)             # 4o

        ilhu    $k_one,0x3f80                           # 5e
        lqd     $beside_x,32($a_rays)                   # 5o

        ilhu    $k_sign,0x8000                          # 6e
        shufb   $normal_y,$record,$record,$k_y          # 6o

        ila     $a_controls,sign_controls               # 7e
        shufb   $normal_x,$record,$record,$k_x          # 7o

        lqd     $direction_x_3,192($a_rays)             # 8o
        lqd     $beside_y,64($a_rays)                   # 9o

        nop     $127                                    # 10e pairing
        lqd     $direction_y_2,272($a_rays)             # 10o

        fm      $along,$normal_x,$direction_x           # 11e
        shufb   $point_z,$record_2,$record_2,$k_z       # 11o

        fm      $along_2,$normal_x,$direction_x_2       # 12e
        lqd     $beside_y_2,80($a_rays)                 # 12o

        nop     $127                                    # 13e pairing
        lqd     $direction_x_4,224($a_rays)             # 13o

        fm      $along_3,$normal_x,$direction_x_3       # 14e
        lqd     $direction_y_3,256($a_rays)             # 14o

        shufb   $a_controls1_2,$record_2,$record_2,$k_x # 15o
        lqd     $direction_y_4,304($a_rays)             # 16o

        fma     $along,$normal_y,$direction_y_2,$along  # 17e
        lqd     $beside_x_2,16($a_rays)                 # 17o

        nop     $127                                    # 18e pairing
        lqd     $direction_z,352($a_rays)               # 18o

        fm      $along_4,$normal_x,$direction_x_4       # 19e
        lqd     $direction_z_2,320($a_rays)             # 19o

        fma     $along_3,$normal_y,$direction_y_3,$along_3 # 20e
        lqd     $direction_z_3,336($a_rays)             # 20o

        fs      $beside_x,$beside_x,$a_controls1_2      # 21e
        shufb   $normal_z_2,$record,$record,$k_z        # 21o

        fma     $along_2,$normal_y,$direction_y_4,$along_2 # 22e
        lqd     $beside_y_3,96($a_rays)                 # 22o

        fs      $beside_x_2,$beside_x_2,$a_controls1_2  # 23e
        lqd     $beside_z_2,160($a_rays)                # 23o

        nop     $127                                    # 24e pairing
        shufb   $point_y_2,$record_2,$record_2,$k_y     # 24o

        fma     $along_4,$normal_y,$direction_y,$along_4 # 25e
        lqd     $direction_z_4,368($a_rays)             # 25o

        fma     $along_3,$normal_z_2,$direction_z_2,$along_3 # 26e
        lqd     $beside_x_3,0($a_rays)                  # 26o

        fma     $along,$normal_z_2,$direction_z_3,$along # 27e
        lqd     $beside_z_3,144($a_rays)                # 27o

        fs      $beside_y,$beside_y,$point_y_2          # 28e
        lqd     $beside_x_4,48($a_rays)                 # 28o

        fs      $beside_y_2,$beside_y_2,$point_y_2      # 29e
        lqd     $beside_z_4,128($a_rays)                # 29o

        fs      $beside_y_3,$beside_y_3,$point_y_2      # 30e
        lqd     $beside_y_4,112($a_rays)                # 30o

        fma     $along_4,$normal_z_2,$direction_z,$along_4 # 31e
        lqd     $n_best_2,400($a_rays)                  # 31o

        fs      $beside_x_3,$beside_x_3,$a_controls1_2  # 32e
        frest   $t_y_2,$along_3                         # 32o

        fma     $along_2,$normal_z_2,$direction_z_4,$along_2 # 33e
        frest   $t_y_3,$along                           # 33o

        fs      $beside_z_3,$beside_z_3,$point_z        # 34e
        lqd     $n_best_3,416($a_rays)                  # 34o

        fs      $beside_z_4,$beside_z_4,$point_z        # 35e
        lqd     $beside_z_5,176($a_rays)                # 35o

        fi      $t_y_2,$along_3,$t_y_2                  # 36e
        lqd     $n_best_4,432($a_rays)                  # 36o

        fi      $t_y_3,$along,$t_y_3                    # 37e
        frest   $t_y_4,$along_4                         # 37o

        xor     $n_best_2,$n_best_2,$k_sign             # 38e
        lqd     $record_3,32($a_rectangle)              # 38o

        fm      $n_2,$normal_x,$beside_x_3              # 39e
        frest   $t_y_5,$along_2                         # 39o

        fs      $beside_x_5,$beside_x_4,$a_controls1_2  # 40e
        lqd     $record_4,48($a_rectangle)              # 40o

        fs      $beside_z_6,$beside_z_5,$point_z        # 41e
        lqd     $n_best_5,384($a_rays)                  # 41o

        fi      $t_y_4,$along_4,$t_y_4                  # 42e
        lqd     $v_best_2,576($a_rays)                  # 42o

        fi      $t_y_5,$along_2,$t_y_5                  # 43e
        lqd     $nearest_2,448($a_rays)                 # 43o

        xor     $n_best_4,$n_best_4,$k_sign             # 44e
        shufb   $dual_u_x_2,$record_3,$record_3,$k_x    # 44o

        fnms    $t_e_2,$along_3,$t_y_2,$k_one           # 45e
        shufb   $dual_u_y_2,$record_3,$record_3,$k_y    # 45o

        fma     $n_2,$normal_y,$beside_y,$n_2           # 46e
        shufb   $dual_v_y_2,$record_4,$record_4,$k_y    # 46o

        fm      $n_3,$normal_x,$beside_x_5              # 47e
        shufb   $dual_u_z_2,$record_3,$record_3,$k_z    # 47o

        xor     $n_best_5,$n_best_5,$k_sign             # 48e
        shufb   $dual_v_x_2,$record_4,$record_4,$k_x    # 48o

        fnms    $t_e_3,$along_4,$t_y_4,$k_one           # 49e
        lqd     $v_best_3,608($a_rays)                  # 49o

        fnms    $t_e_4,$along,$t_y_3,$k_one             # 50e
        shufb   $dual_v_z_2,$record_4,$record_4,$k_z    # 50o

        fma     $inverse_2,$t_e_2,$t_y_2,$t_y_2         # 51e
        lqd     $v_best,592($a_rays)                    # 51o

        fm      $n_4,$normal_x,$beside_x_2              # 52e
        lqd     $v_best_4,624($a_rays)                  # 52o

        fma     $n_2,$normal_z_2,$beside_z_4,$n_2       # 53e
        lqd     $nearest_3,480($a_rays)                 # 53o

        fs      $beside_z_7,$beside_z_2,$point_z        # 54e
        shufb   $object,$object,$object,$k_x            # 54o

        fm      $n_5,$normal_x,$beside_x                # 55e
        lqd     $nearest_4,496($a_rays)                 # 55o

        fma     $inverse_3,$t_e_4,$t_y_3,$t_y_3         # 56e
        lqd     $u_best_2,512($a_rays)                  # 56o

        fs      $beside_y_5,$beside_y_4,$point_y_2      # 57e
        lqd     $u_best_3,544($a_rays)                  # 57o

        fma     $n_4,$normal_y,$beside_y_2,$n_4         # 58e
        lqd     $u_best_4,528($a_rays)                  # 58o

        fm      $n_6,$n_2,$inverse_2                    # 59e
        lqd     $nearest_5,464($a_rays)                 # 59o

        fnms    $t_e_5,$along_2,$t_y_5,$k_one           # 60e
        lqd     $u_best_5,560($a_rays)                  # 60o

        fma     $n_5,$normal_y,$beside_y_3,$n_5         # 61e
        fma     $inverse_4,$t_e_3,$t_y_4,$t_y_4         # 62e

        fma     $n_7,$normal_y,$beside_y_5,$n_3         # 63e
        fma     $n_4,$normal_z_2,$beside_z_3,$n_4       # 64e

        cgt     $control_2,$n_best_5,$n_6               # 65e 0 < t < t_best
        fnms    $beside_y,$n_6,$direction_y_3,$beside_y # 66e

        fma     $n_5,$normal_z_2,$beside_z_7,$n_5       # 67e
        rotqbii $control_3,$control_2,1                 # 67o

        fma     $inverse_5,$t_e_5,$t_y_5,$t_y_5         # 68e
        fma     $n_7,$normal_z_2,$beside_z_6,$n_7       # 69e

        fnms    $beside_x_6,$n_6,$direction_x_3,$beside_x_3 # 70e
        lnop                                            # 70o pairing

        fnms    $beside_z_8,$n_6,$direction_z_2,$beside_z_4 # 71e
        gb      $control_3,$control_3                   # 71o

        fm      $n,$n_4,$inverse_3                      # 72e
        fm      $n_5,$n_5,$inverse_4                    # 73e

        xor     $n_best,$n_best_3,$k_sign               # 74e
        lnop                                            # 74o pairing

        fm      $n_8,$n_7,$inverse_5                    # 75e
        shlqbii $control_4,$control_3,4                 # 75o

        fm      $u_2,$dual_u_x_2,$beside_x_6            # 76e
        fm      $v_2,$dual_v_x_2,$beside_x_6            # 77e

        cgt     $control_3,$n_best_2,$n                 # 78e 0 < t < t_best
        lnop                                            # 78o pairing

        fnms    $beside_y_6,$n,$direction_y_2,$beside_y_2 # 79e
        lqx     $control_5,$control_4,$a_controls       # 79o

        cgt     $control_4,$n_best,$n_5                 # 80e 0 < t < t_best
        rotqbii $control_3,$control_3,1                 # 80o

        cgt     $control_6,$n_best_4,$n_8               # 81e 0 < t < t_best
        lnop                                            # 81o pairing

        fma     $u_2,$dual_u_y_2,$beside_y,$u_2         # 82e
        rotqbii $control_4,$control_4,1                 # 82o

        fnms    $beside_x,$n_5,$direction_x_4,$beside_x # 83e
        rotqbii $control_7,$control_6,1                 # 83o

        fnms    $beside_z_7,$n_5,$direction_z,$beside_z_7 # 84e
        gb      $control_3,$control_3                   # 84o

        fnms    $beside_y_7,$n_5,$direction_y,$beside_y_3 # 85e
        shufb   $nearest_6,$nearest_2,$object,$control_5 # 85o

        fnms    $beside_y_5,$n_8,$direction_y_4,$beside_y_5 # 86e
        gb      $control_4,$control_4                   # 86o

        fnms    $beside_x_7,$n_8,$direction_x_2,$beside_x_5 # 87e
        gb      $control_7,$control_7                   # 87o

        fma     $u_2,$dual_u_z_2,$beside_z_8,$u_2       # 88e
        shlqbii $control_3,$control_3,4                 # 88o

        fm      $u_3,$dual_u_x_2,$beside_x              # 89e
        stqd    $nearest_6,448($a_rays)                 # 89o

        fm      $v_3,$dual_v_x_2,$beside_x              # 90e
        shlqbii $control_4,$control_4,4                 # 90o

        fnms    $beside_z_9,$n_8,$direction_z_4,$beside_z_6 # 91e
        shlqbii $control_7,$control_7,4                 # 91o

        fnms    $beside_x,$n,$direction_x,$beside_x_2   # 92e
        shufb   $n_best_6,$n_best_5,$n_6,$control_5     # 92o

        fm      $u_4,$dual_u_x_2,$beside_x_7            # 93e
        lqx     $control_3,$control_3,$a_controls       # 93o

        fma     $v,$dual_v_y_2,$beside_y,$v_2           # 94e
        shufb   $u_best_6,$u_best_2,$u_2,$control_5     # 94o

        fma     $u_2,$dual_u_y_2,$beside_y_7,$u_3       # 95e
        lqx     $control_7,$control_7,$a_controls       # 95o

        fma     $v_4,$dual_v_y_2,$beside_y_7,$v_3       # 96e
        lqx     $control_8,$control_4,$a_controls       # 96o

        fm      $v_5,$dual_v_x_2,$beside_x_7            # 97e
        lnop                                            # 97o pairing

        fm      $u_5,$dual_u_x_2,$beside_x              # 98e
        stqd    $u_best_6,512($a_rays)                  # 98o

        fm      $v_2,$dual_v_x_2,$beside_x              # 99e
        shufb   $n_best_7,$n_best_2,$n,$control_3       # 99o

        fma     $v,$dual_v_z_2,$beside_z_8,$v           # 100e
        shufb   $nearest_7,$nearest_5,$object,$control_3 # 100o

        fma     $u_2,$dual_u_z_2,$beside_z_7,$u_2       # 101e
        shufb   $nearest_4,$nearest_4,$object,$control_7 # 101o

        fma     $v_6,$dual_v_z_2,$beside_z_7,$v_4       # 102e
        shufb   $nearest_8,$nearest_3,$object,$control_8 # 102o

        fma     $v_5,$dual_v_y_2,$beside_y_5,$v_5       # 103e
        shufb   $n_best,$n_best,$n_5,$control_8         # 103o

        xor     $n_best_8,$n_best_7,$k_sign             # 104e
        stqd    $nearest_7,464($a_rays)                 # 104o

        fma     $u_5,$dual_u_y_2,$beside_y_6,$u_5       # 105e
        stqd    $nearest_4,496($a_rays)                 # 105o

        fma     $u_6,$dual_u_y_2,$beside_y_5,$u_4       # 106e
        shufb   $v_best_5,$v_best_2,$v,$control_5       # 106o

        fnms    $beside_z,$n,$direction_z_3,$beside_z_3 # 107e
        shufb   $u_best,$u_best_3,$u_2,$control_8       # 107o

        fma     $v,$dual_v_y_2,$beside_y_6,$v_2         # 108e
        hbr     isect_plane_r16_return,$lr              # 108o hint

        fma     $v_5,$dual_v_z_2,$beside_z_9,$v_5       # 109e
        shufb   $n_best_9,$n_best_4,$n_8,$control_7     # 109o

        xor     $n_best,$n_best,$k_sign                 # 110e
        stqd    $v_best_5,576($a_rays)                  # 110o

        xor     $n_best_10,$n_best_6,$k_sign            # 111e
        stqd    $u_best,544($a_rays)                    # 111o

        fma     $u,$dual_u_z_2,$beside_z_9,$u_6         # 112e
        stqd    $n_best,416($a_rays)                    # 112o

        fma     $u_6,$dual_u_z_2,$beside_z,$u_5         # 113e
        stqd    $n_best_10,384($a_rays)                 # 113o

        fma     $v,$dual_v_z_2,$beside_z,$v             # 114e
        stqd    $nearest_8,480($a_rays)                 # 114o

        xor     $n_best,$n_best_9,$k_sign               # 115e
        shufb   $v_best_6,$v_best_4,$v_5,$control_7     # 115o

        shufb   $v_best_7,$v_best_3,$v_6,$control_8     # 116o
        stqd    $n_best_8,400($a_rays)                  # 117o

        shufb   $u_best,$u_best_5,$u,$control_7         # 118o
        shufb   $u_best_7,$u_best_4,$u_6,$control_3     # 119o

        stqd    $v_best_7,608($a_rays)                  # 120o
        stqd    $v_best_6,624($a_rays)                  # 121o

        shufb   $v_best,$v_best,$v,$control_3           # 122o
        stqd    $u_best_7,528($a_rays)                  # 123o

        stqd    $u_best,560($a_rays)                    # 124o
        stqd    $n_best,432($a_rays)                    # 125o

        stqd    $v_best,592($a_rays)                    # 126o
isect_plane_r16_return:
        bi      $lr                                     # 127o
endfunction isect_plane_r16
