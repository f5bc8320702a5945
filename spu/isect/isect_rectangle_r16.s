# isect_rectangle_r16   nearest hit of sixteen rays with a parallelogram, from both sides
#   C       void isect_rectangle_r16(struct rays *, const struct rectangle *, int object);
#   In      $3 rays, $4 rectangle, $5 object number; pointers 16-aligned
#   Out     rays: t, object, u, v, where a hit has 0 < t < what was there
#   Uses    $2, $4-$62   Saves  -   Stack  0   Calls  -
#   Domain  rays.t >= 0; |direction| and |normal| about 1; distances from the origin below 2^60
#   Error   20 ulp of t, 5e-4 in u and v; edges from 1/100 of the distance to all of it, 30 degrees
#           or more apart; incidence within 84 degrees of the normal
#   Twin    oracle/src/twin/rectangle.rs
#
# For the point p, the unit normal m, the origin o and the direction d:
#   -t = m.(o - p) / m.d
#   h = o - p + t d     in the rectangle's own space
#   u = h.dual_u, v = h.dual_v; the edges, 0 and 1, belong to the rectangle
# A ray along the plane gets a t that is 0 or beyond everything: no hit.
# Scheduled by spu schedule from isect_rectangle_r16.s

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
        .set    outside,47
        .set    c_v,48

        sign_controls_table

function isect_rectangle_r16
        .set    record_2,2
        .set    direction_x_2,6
        .set    direction_x_3,7
        .set    direction_x_4,8
        .set    along_2,9
        .set    direction_y_2,16
        .set    direction_y_3,17
        .set    a_controls1_2,18
        .set    along_3,22
        .set    direction_y_4,23
        .set    along_4,24
        .set    direction_z_2,25
        .set    point_y_2,26
        .set    direction_z_3,27
        .set    direction_z_4,28
        .set    point_z_2,2
        .set    beside_x_2,36
        .set    beside_x_3,37
        .set    beside_x_4,38
        .set    beside_y_2,40
        .set    beside_y_3,41
        .set    t_y_2,42
        .set    beside_y_4,43
        .set    beside_z_2,44
        .set    beside_z_3,45
        .set    beside_z_4,46
        .set    t_y_3,47
        .set    record_3,48
        .set    t_y_4,49
        .set    beside_x_5,18
        .set    record_4,4
        .set    n_best_2,50
        .set    t_e_2,35
        .set    n_best_3,51
        .set    dual_v_x_2,52
        .set    dual_v_y_2,53
        .set    dual_v_z_2,48
        .set    dual_u_x_2,54
        .set    dual_u_y_2,11
        .set    inverse_2,35
        .set    dual_u_z_2,4
        .set    n_2,12
        .set    n_3,55
        .set    n_best_4,56
        .set    n_4,19
        .set    beside_y_5,10
        .set    nearest_2,26
        .set    t_e_3,24
        .set    u_best_2,41
        .set    v_best_2,35
        .set    nearest_3,57
        .set    u_best_3,58
        .set    v_best_3,59
        .set    t_e_4,9
        .set    v_best_4,60
        .set    t_e_5,22
        .set    v_best_5,61
        .set    u_best_4,62
        .set    beside_z_5,2
        .set    nearest_4,44
        .set    u_best_5,20
        .set    nearest_5,32
        .set    inverse_3,9
        .set    n_5,37
        .set    inverse_4,22
        .set    v_2,33
        .set    inverse_5,24
        .set    u_2,21
        .set    v_3,22
        .set    n_6,24
        .set    n_7,9
        .set    u_3,12
        .set    v_4,7
        .set    beside_x_6,8
        .set    beside_x_7,6
        .set    u_4,17
        .set    beside_y_6,16
        .set    v_5,18
        .set    v_6,21
        .set    v_7,6
        .set    u_5,8
        .set    control_2,22
        .set    c_v_2,23
        .set    beside_z_6,23
        .set    u_6,10
        .set    v_8,11
        .set    v_9,16
        .set    v_10,2
        .set    n_best_5,4
        .set    c_v_3,6
        .set    c_v_4,17
        .set    outside_2,6
        .set    n_best_6,18
        .set    outside_3,13
        .set    control_3,7
        .set    u_best_6,12
        .set    n_best_7,21
        .set    control_4,6
        .set    n_best_8,12
        .set    u_best_7,9
        .set    u_best_8,10
        .set    u_best_9,8
        .set    v_best_6,11
        .set    v_best_7,2
        .set    nearest_6,7
        .set    nearest_7,5
        ila     $k_x,0x10203                            # 0e
        lqd     $record,16($a_rectangle)                # 0o

        ilhu    $k_y,0x405                              # 1e
        lqd     $direction_x,192($a_rays)               # 1o

        ilhu    $k_z,0x809                              # 2e
        lqd     $direction_y,256($a_rays)               # 2o

        iohl    $k_y,0x607                              # 3e
        lqd     $direction_z,320($a_rays)               # 3o

        iohl    $k_z,0xa0b                              # 4e
        lqd     $record_2,0($a_rectangle)               # 4o

        ilhu    $k_one,0x3f80                           # 5e
        lqd     $direction_x_2,224($a_rays)             # 5o

        ilhu    $k_sign,0x8000                          # 6e
        shufb   $normal_x,$record,$record,$k_x          # 6o

        ila     $a_controls,sign_controls               # 7e
        shufb   $normal_y,$record,$record,$k_y          # 7o

        shufb   $normal_z,$record,$record,$k_z          # 8o
        lqd     $direction_x_3,240($a_rays)             # 9o

        fm      $along,$normal_x,$direction_x           # 10e
        lqd     $direction_x_4,208($a_rays)             # 10o

        fm      $along_2,$normal_x,$direction_x_2       # 11e
        lqd     $beside_x,0($a_rays)                    # 11o

        lqd     $direction_y_2,272($a_rays)             # 12o
        lqd     $direction_y_3,304($a_rays)             # 13o

        nop     $127                                    # 14e pairing
        shufb   $a_controls1_2,$record_2,$record_2,$k_x # 14o

        fm      $along_3,$normal_x,$direction_x_3       # 15e
        lqd     $beside_y,64($a_rays)                   # 15o

        fma     $along,$normal_y,$direction_y,$along    # 16e
        lqd     $direction_y_4,288($a_rays)             # 16o

        fm      $along_4,$normal_x,$direction_x_4       # 17e
        lqd     $direction_z_2,368($a_rays)             # 17o

        fs      $beside_x,$beside_x,$a_controls1_2      # 18e
        shufb   $point_y_2,$record_2,$record_2,$k_y     # 18o

        lqd     $direction_z_3,336($a_rays)             # 19o
        lqd     $direction_z_4,352($a_rays)             # 20o

        fma     $along_3,$normal_y,$direction_y_3,$along_3 # 21e
        shufb   $point_z_2,$record_2,$record_2,$k_z     # 21o

        fma     $along,$normal_z,$direction_z,$along    # 22e
        lqd     $beside_z,128($a_rays)                  # 22o

        fma     $along_4,$normal_y,$direction_y_2,$along_4 # 23e
        lqd     $beside_x_2,16($a_rays)                 # 23o

        fma     $along_2,$normal_y,$direction_y_4,$along_2 # 24e
        lqd     $beside_x_3,32($a_rays)                 # 24o

        fm      $n,$normal_x,$beside_x                  # 25e
        lqd     $beside_x_4,48($a_rays)                 # 25o

        fs      $beside_y,$beside_y,$point_y_2          # 26e
        lqd     $beside_y_2,80($a_rays)                 # 26o

        fma     $along_3,$normal_z,$direction_z_2,$along_3 # 27e
        lqd     $beside_y_3,96($a_rays)                 # 27o

        fs      $beside_z,$beside_z,$point_z_2          # 28e
        frest   $t_y_2,$along                           # 28o

        fma     $along_4,$normal_z,$direction_z_3,$along_4 # 29e
        lqd     $beside_y_4,112($a_rays)                # 29o

        fma     $along_2,$normal_z,$direction_z_4,$along_2 # 30e
        lqd     $beside_z_2,160($a_rays)                # 30o

        fs      $beside_x_4,$beside_x_4,$a_controls1_2  # 31e
        lqd     $beside_z_3,176($a_rays)                # 31o

        fi      $t_y_2,$along,$t_y_2                    # 32e
        lqd     $beside_z_4,144($a_rays)                # 32o

        nop     $127                                    # 33e pairing
        frest   $t_y_3,$along_3                         # 33o

        fma     $n,$normal_y,$beside_y,$n               # 34e
        lqd     $record_3,48($a_rectangle)              # 34o

        fs      $beside_x_2,$beside_x_2,$a_controls1_2  # 35e
        frest   $t_y_4,$along_4                         # 35o

        fs      $beside_x_5,$beside_x_3,$a_controls1_2  # 36e
        frest   $t_y,$along_2                           # 36o

        fs      $beside_y_2,$beside_y_2,$point_y_2      # 37e
        lqd     $record_4,32($a_rectangle)              # 37o

        fs      $beside_y_4,$beside_y_4,$point_y_2      # 38e
        lqd     $n_best_2,384($a_rays)                  # 38o

        fnms    $t_e_2,$along,$t_y_2,$k_one             # 39e
        lqd     $n_best_3,416($a_rays)                  # 39o

        fma     $n,$normal_z,$beside_z,$n               # 40e
        shufb   $dual_v_x_2,$record_3,$record_3,$k_x    # 40o

        fi      $t_y_4,$along_4,$t_y_4                  # 41e
        shufb   $dual_v_y_2,$record_3,$record_3,$k_y    # 41o

        fi      $t_y,$along_2,$t_y                      # 42e
        shufb   $dual_v_z_2,$record_3,$record_3,$k_z    # 42o

        fi      $t_y_3,$along_3,$t_y_3                  # 43e
        shufb   $dual_u_x_2,$record_4,$record_4,$k_x    # 43o

        xor     $n_best_2,$n_best_2,$k_sign             # 44e
        shufb   $dual_u_y_2,$record_4,$record_4,$k_y    # 44o

        fma     $inverse_2,$t_e_2,$t_y_2,$t_y_2         # 45e
        shufb   $dual_u_z_2,$record_4,$record_4,$k_z    # 45o

        fm      $n_2,$normal_x,$beside_x_5              # 46e
        lqd     $n_best,400($a_rays)                    # 46o

        fm      $n_3,$normal_x,$beside_x_2              # 47e
        lqd     $n_best_4,432($a_rays)                  # 47o

        fm      $n_4,$normal_x,$beside_x_4              # 48e
        shufb   $object,$object,$object,$k_x            # 48o

        fs      $beside_y_5,$beside_y_3,$point_y_2      # 49e
        lqd     $nearest_2,448($a_rays)                 # 49o

        fnms    $t_e_3,$along_4,$t_y_4,$k_one           # 50e
        lqd     $u_best_2,512($a_rays)                  # 50o

        fm      $n,$n,$inverse_2                        # 51e
        lqd     $v_best_2,576($a_rays)                  # 51o

        fs      $beside_z_4,$beside_z_4,$point_z_2      # 52e
        lqd     $nearest_3,464($a_rays)                 # 52o

        fs      $beside_z_3,$beside_z_3,$point_z_2      # 53e
        lqd     $u_best_3,528($a_rays)                  # 53o

        fma     $n_4,$normal_y,$beside_y_4,$n_4         # 54e
        lqd     $v_best_3,608($a_rays)                  # 54o

        fnms    $t_e_4,$along_2,$t_y,$k_one             # 55e
        lqd     $v_best_4,624($a_rays)                  # 55o

        fnms    $t_e_5,$along_3,$t_y_3,$k_one           # 56e
        lqd     $v_best_5,592($a_rays)                  # 56o

        fma     $n_3,$normal_y,$beside_y_2,$n_3         # 57e
        lqd     $u_best_4,544($a_rays)                  # 57o

        fs      $beside_z_5,$beside_z_2,$point_z_2      # 58e
        lqd     $nearest_4,496($a_rays)                 # 58o

        fma     $n_2,$normal_y,$beside_y_5,$n_2         # 59e
        lqd     $u_best_5,560($a_rays)                  # 59o

        fnms    $beside_x,$n,$direction_x,$beside_x     # 60e
        lqd     $nearest_5,480($a_rays)                 # 60o

        fma     $n_4,$normal_z,$beside_z_3,$n_4         # 61e
        fma     $inverse_3,$t_e_4,$t_y,$t_y             # 62e

        fma     $n_5,$normal_z,$beside_z_4,$n_3         # 63e
        fma     $inverse_4,$t_e_5,$t_y_3,$t_y_3         # 64e

        fnms    $beside_y,$n,$direction_y,$beside_y     # 65e
        fm      $v_2,$dual_v_x_2,$beside_x              # 66e

        fma     $inverse_5,$t_e_3,$t_y_4,$t_y_4         # 67e
        fma     $n_2,$normal_z,$beside_z_5,$n_2         # 68e

        fm      $u_2,$dual_u_x_2,$beside_x              # 69e
        fm      $n_4,$n_4,$inverse_4                    # 70e

        fnms    $beside_z,$n,$direction_z,$beside_z     # 71e
        fma     $v_3,$dual_v_y_2,$beside_y,$v_2         # 72e

        fm      $n_6,$n_5,$inverse_5                    # 73e
        fm      $n_7,$n_2,$inverse_3                    # 74e

        fma     $u_3,$dual_u_y_2,$beside_y,$u_2         # 75e
        fnms    $beside_x,$n_4,$direction_x_3,$beside_x_4 # 76e

        fnms    $beside_y,$n_4,$direction_y_3,$beside_y_4 # 77e
        fma     $v_4,$dual_v_z_2,$beside_z,$v_3         # 78e

        fnms    $beside_x_6,$n_6,$direction_x_4,$beside_x_2 # 79e
        fnms    $beside_x_7,$n_7,$direction_x_2,$beside_x_5 # 80e

        fma     $u_3,$dual_u_z_2,$beside_z,$u_3         # 81e
        fm      $u_4,$dual_u_x_2,$beside_x              # 82e

        fnms    $beside_y_6,$n_6,$direction_y_2,$beside_y_2 # 83e
        fnms    $beside_y_5,$n_7,$direction_y_4,$beside_y_5 # 84e

        fm      $v_5,$dual_v_x_2,$beside_x_6            # 85e
        fm      $v_6,$dual_v_x_2,$beside_x_7            # 86e

        fm      $u,$dual_u_x_2,$beside_x_7              # 87e
        fm      $v_7,$dual_v_x_2,$beside_x              # 88e

        fm      $u_5,$dual_u_x_2,$beside_x_6            # 89e
        clgt    $outside,$u_3,$k_one                    # 90e

        fma     $u_4,$dual_u_y_2,$beside_y,$u_4         # 91e
        cgt     $control_2,$n_best_2,$n                 # 92e 0 < t < t_best

        clgt    $c_v_2,$v_4,$k_one                      # 93e
        fma     $v_6,$dual_v_y_2,$beside_y_5,$v_6       # 94e

        or      $outside,$outside,$c_v_2                # 95e
        fnms    $beside_z,$n_4,$direction_z_2,$beside_z_3 # 96e

        andc    $control_2,$control_2,$outside          # 97e
        fma     $v_5,$dual_v_y_2,$beside_y_6,$v_5       # 98e

        fnms    $beside_z_6,$n_6,$direction_z_3,$beside_z_4 # 99e
        rotqbii $control,$control_2,1                   # 99o

        fma     $u_5,$dual_u_y_2,$beside_y_6,$u_5       # 100e
        fnms    $beside_z_5,$n_7,$direction_z_4,$beside_z_5 # 101e

        fma     $u,$dual_u_y_2,$beside_y_5,$u           # 102e
        lnop                                            # 102o pairing

        fma     $v_7,$dual_v_y_2,$beside_y,$v_7         # 103e
        gb      $control,$control                       # 103o

        fma     $u_6,$dual_u_z_2,$beside_z,$u_4         # 104e
        fma     $v_8,$dual_v_z_2,$beside_z_6,$v_5       # 105e

        fma     $u_5,$dual_u_z_2,$beside_z_6,$u_5       # 106e
        lnop                                            # 106o pairing

        fma     $v_9,$dual_v_z_2,$beside_z_5,$v_6       # 107e
        shlqbii $control,$control,4                     # 107o

        fma     $u,$dual_u_z_2,$beside_z_5,$u           # 108e
        fma     $v_10,$dual_v_z_2,$beside_z,$v_7        # 109e

        xor     $n_best,$n_best,$k_sign                 # 110e
        lnop                                            # 110o pairing

        clgt    $c_v,$v_8,$k_one                        # 111e
        lqx     $control,$control,$a_controls           # 111o

        xor     $n_best_5,$n_best_3,$k_sign             # 112e
        clgt    $c_v_3,$v_9,$k_one                      # 113e

        clgt    $outside,$u,$k_one                      # 114e
        clgt    $c_v_4,$v_10,$k_one                     # 115e

        or      $outside,$outside,$c_v_3                # 116e
        lnop                                            # 116o pairing

        clgt    $outside_2,$u_6,$k_one                  # 117e
        shufb   $n_best_6,$n_best_2,$n,$control         # 117o

        clgt    $outside_3,$u_5,$k_one                  # 118e
        shufb   $v_best,$v_best_2,$v_4,$control         # 118o

        cgt     $control_3,$n_best,$n_6                 # 119e 0 < t < t_best
        shufb   $u_best_6,$u_best_2,$u_3,$control       # 119o

        xor     $n_best_7,$n_best_4,$k_sign             # 120e
        shufb   $nearest,$nearest_2,$object,$control    # 120o

        cgt     $control,$n_best_5,$n_7                 # 121e 0 < t < t_best
        lnop                                            # 121o pairing

        or      $outside_3,$outside_3,$c_v              # 122e
        stqd    $v_best,576($a_rays)                    # 122o

        andc    $control,$control,$outside              # 123e
        stqd    $u_best_6,512($a_rays)                  # 123o

        andc    $control_3,$control_3,$outside_3        # 124e
        stqd    $nearest,448($a_rays)                   # 124o

        or      $outside,$outside_2,$c_v_4              # 125e
        rotqbii $control,$control,1                     # 125o

        cgt     $control_4,$n_best_7,$n_4               # 126e 0 < t < t_best
        rotqbii $control_3,$control_3,1                 # 126o

        xor     $n_best_8,$n_best_6,$k_sign             # 127e
        andc    $control_4,$control_4,$outside          # 128e

        gb      $control,$control                       # 129o
        rotqbii $control_4,$control_4,1                 # 130o

        gb      $control_3,$control_3                   # 131o
        stqd    $n_best_8,384($a_rays)                  # 132o

        shlqbii $control,$control,4                     # 133o
        gb      $control_4,$control_4                   # 134o

        shlqbii $control_3,$control_3,4                 # 135o
        hbr     isect_rectangle_r16_return,$lr          # 136o hint

        lqx     $control,$control,$a_controls           # 137o
        shlqbii $control_4,$control_4,4                 # 138o

        lqx     $control_3,$control_3,$a_controls       # 139o
        lqx     $control_4,$control_4,$a_controls       # 142o

        shufb   $nearest,$nearest_5,$object,$control    # 143o
        shufb   $v_best,$v_best_3,$v_9,$control         # 144o

        shufb   $n_best,$n_best,$n_6,$control_3         # 145o
        shufb   $n_best_5,$n_best_5,$n_7,$control       # 146o

        shufb   $u_best_7,$u_best_4,$u,$control         # 147o
        shufb   $n_best_8,$n_best_7,$n_4,$control_4     # 148o

        xor     $n_best,$n_best,$k_sign                 # 149e
        shufb   $u_best_8,$u_best_5,$u_6,$control_4     # 149o

        xor     $n_best_5,$n_best_5,$k_sign             # 150e
        shufb   $u_best_9,$u_best_3,$u_5,$control_3     # 150o

        nop     $127                                    # 151e pairing
        shufb   $v_best_6,$v_best_5,$v_8,$control_3     # 151o

        xor     $n_best_8,$n_best_8,$k_sign             # 152e
        shufb   $v_best_7,$v_best_4,$v_10,$control_4    # 152o

        stqd    $u_best_8,560($a_rays)                  # 153o
        shufb   $nearest_6,$nearest_3,$object,$control_3 # 154o

        shufb   $nearest_7,$nearest_4,$object,$control_4 # 155o
        stqd    $n_best_8,432($a_rays)                  # 156o

        stqd    $n_best_5,416($a_rays)                  # 157o
        stqd    $v_best,608($a_rays)                    # 158o

        stqd    $v_best_7,624($a_rays)                  # 159o
        stqd    $nearest,480($a_rays)                   # 160o

        stqd    $u_best_7,544($a_rays)                  # 161o
        stqd    $nearest_7,496($a_rays)                 # 162o

        stqd    $nearest_6,464($a_rays)                 # 163o
        stqd    $u_best_9,528($a_rays)                  # 164o

        stqd    $n_best,400($a_rays)                    # 165o
        stqd    $v_best_6,592($a_rays)                  # 166o

        nop     $127                                    # 167e pairing
isect_rectangle_r16_return:
        bi      $lr                                     # 167o
endfunction isect_rectangle_r16
