# any_rectangle_r16   which of sixteen rays a parallelogram blocks
#   C       unsigned any_rectangle_r16(const struct rays *, const struct rectangle *);
#   In      $3 rays, $4 rectangle; pointers 16-aligned
#   Out     $3 a bit a ray, 0x8000 of the first: hit with 0 < t < rays.t
#   Uses    $2-$54   Saves  -   Stack  0   Calls  -
#   Domain  as isect_rectangle_r16
#   Error   none of its own: blocks exactly what isect_rectangle_r16 hits
#   Twin    oracle/src/twin/rectangle.rs
# Scheduled by spu schedule from any_rectangle_r16.s

        .include "macros.inc"
        .include "rays.inc"
        .include "flat.inc"
        .include "rectangle_tmpl.inc"

        .set    code,3
        .set    a_rays,3
        .set    a_rectangle,4
        # constants
        .set    k_x,10
        .set    k_y,11
        .set    k_z,12
        .set    k_one,13
        .set    k_sign,14
        .set    n_far,42
        .set    outside,43
        .set    c_v,44
        .set    blocked,45                              # a row each; the signs count
        .set    low,49
        .set    m_rows,50
        .set    m_code,51

        sign_gathers_table

function any_rectangle_r16
        .set    direction_x_2,2
        .set    direction_x_3,5
        .set    direction_x_4,6
        .set    direction_y_2,7
        .set    direction_y_3,8
        .set    direction_y_4,9
        .set    along_2,15
        .set    along_3,16
        .set    direction_z_2,17
        .set    along_4,18
        .set    direction_z_3,21
        .set    direction_z_4,22
        .set    record_2,23
        .set    normal_z_2,24
        .set    beside_x_2,25
        .set    beside_x_3,26
        .set    beside_x_4,27
        .set    point_x_2,28
        .set    beside_y_2,31
        .set    beside_y_3,36
        .set    beside_y_4,37
        .set    point_y_2,38
        .set    beside_z_2,39
        .set    t_y_2,40
        .set    t_y_3,28
        .set    t_y_4,41
        .set    t_y_5,42
        .set    beside_z_3,43
        .set    beside_z_4,44
        .set    beside_z_5,45
        .set    point_z_2,23
        .set    record_3,46
        .set    n_2,47
        .set    record_4,4
        .set    n_3,48
        .set    n_far_2,49
        .set    n_far_3,50
        .set    n_4,51
        .set    n_far_4,52
        .set    n_far_5,3
        .set    n_5,19
        .set    dual_u_x_2,38
        .set    dual_v_x_2,10
        .set    dual_u_y_2,53
        .set    t_e_2,35
        .set    dual_v_y_2,11
        .set    dual_u_z_2,46
        .set    dual_v_z_2,4
        .set    t_e_3,12
        .set    m_rows_2,15
        .set    m_code_2,54
        .set    t_e_4,16
        .set    beside_z_6,23
        .set    t_e_5,18
        .set    n_6,20
        .set    inverse_2,35
        .set    n_7,40
        .set    inverse_3,12
        .set    n_8,28
        .set    inverse_4,16
        .set    inverse_5,18
        .set    n_9,12
        .set    n_10,16
        .set    n_far_6,24
        .set    n_11,18
        .set    beside_x_5,2
        .set    beside_x_6,5
        .set    beside_y_5,7
        .set    beside_x_7,6
        .set    u_2,19
        .set    v_2,2
        .set    beside_y_6,8
        .set    u_3,25
        .set    v_3,5
        .set    beside_y_7,9
        .set    u_4,26
        .set    v_4,6
        .set    beside_z_7,10
        .set    u_5,17
        .set    beside_z_8,7
        .set    beside_z_9,8
        .set    u_6,21
        .set    u_7,9
        .set    u_8,10
        .set    u_9,7
        .set    v_5,4
        .set    outside_2,6
        .set    c_v_2,2
        .set    outside_3,8
        .set    c_v_3,5
        .set    n_far_7,9
        .set    outside_4,7
        .set    c_v_4,4
        .set    outside_5,2
        .set    outside_6,5
        .set    outside_7,4
        ila     $k_x,0x10203                            # 0e
        lqd     $record,16($a_rectangle)                # 0o

        ilhu    $k_y,0x405                              # 1e
        lqd     $direction_x,192($a_rays)               # 1o

        ilhu    $k_z,0x809                              # 2e
        lqd     $direction_x_2,208($a_rays)             # 2o

        iohl    $k_y,0x607                              # 3e
        lqd     $direction_x_3,224($a_rays)             # 3o

        iohl    $k_z,0xa0b                              # 4e
        lqd     $direction_x_4,240($a_rays)             # 4o

        ilhu    $k_one,0x3f80                           # 5e
        lqd     $direction_y,256($a_rays)               # 5o

        ilhu    $k_sign,0x8000                          # 6e
        shufb   $normal_x,$record,$record,$k_x          # 6o

        lqd     $direction_y_2,272($a_rays)             # 7o
        lqd     $direction_y_3,288($a_rays)             # 8o

        nop     $127                                    # 9e pairing
        lqd     $direction_y_4,304($a_rays)             # 9o

        fm      $along,$normal_x,$direction_x           # 10e
        shufb   $normal_y,$record,$record,$k_y          # 10o

        fm      $along_2,$normal_x,$direction_x_2       # 11e
        lqd     $direction_z,320($a_rays)               # 11o

        fm      $along_3,$normal_x,$direction_x_3       # 12e
        lqd     $direction_z_2,336($a_rays)             # 12o

        fm      $along_4,$normal_x,$direction_x_4       # 13e
        lqd     $direction_z_3,352($a_rays)             # 13o

        lqd     $direction_z_4,368($a_rays)             # 14o
        lqd     $record_2,0($a_rectangle)               # 15o

        fma     $along,$normal_y,$direction_y,$along    # 16e
        shufb   $normal_z_2,$record,$record,$k_z        # 16o

        fma     $along_2,$normal_y,$direction_y_2,$along_2 # 17e
        lqd     $beside_x,0($a_rays)                    # 17o

        fma     $along_3,$normal_y,$direction_y_3,$along_3 # 18e
        lqd     $beside_x_2,16($a_rays)                 # 18o

        fma     $along_4,$normal_y,$direction_y_4,$along_4 # 19e
        lqd     $beside_x_3,32($a_rays)                 # 19o

        lqd     $beside_x_4,48($a_rays)                 # 20o
        shufb   $point_x_2,$record_2,$record_2,$k_x     # 21o

        fma     $along,$normal_z_2,$direction_z,$along  # 22e
        lqd     $beside_y,64($a_rays)                   # 22o

        fma     $along_2,$normal_z_2,$direction_z_2,$along_2 # 23e
        lqd     $beside_y_2,80($a_rays)                 # 23o

        fma     $along_3,$normal_z_2,$direction_z_3,$along_3 # 24e
        lqd     $beside_y_3,96($a_rays)                 # 24o

        fma     $along_4,$normal_z_2,$direction_z_4,$along_4 # 25e
        lqd     $beside_y_4,112($a_rays)                # 25o

        fs      $beside_x,$beside_x,$point_x_2          # 26e
        shufb   $point_y_2,$record_2,$record_2,$k_y     # 26o

        fs      $beside_x_2,$beside_x_2,$point_x_2      # 27e
        lqd     $beside_z_2,128($a_rays)                # 27o

        fs      $beside_x_3,$beside_x_3,$point_x_2      # 28e
        frest   $t_y_2,$along                           # 28o

        fs      $beside_x_4,$beside_x_4,$point_x_2      # 29e
        frest   $t_y_3,$along_2                         # 29o

        fs      $beside_y,$beside_y,$point_y_2          # 30e
        frest   $t_y_4,$along_3                         # 30o

        fs      $beside_y_2,$beside_y_2,$point_y_2      # 31e
        frest   $t_y_5,$along_4                         # 31o

        fi      $t_y_2,$along,$t_y_2                    # 32e
        lqd     $beside_z_3,144($a_rays)                # 32o

        fi      $t_y_3,$along_2,$t_y_3                  # 33e
        lqd     $beside_z_4,160($a_rays)                # 33o

        fi      $t_y_4,$along_3,$t_y_4                  # 34e
        lqd     $beside_z_5,176($a_rays)                # 34o

        fi      $t_y_5,$along_4,$t_y_5                  # 35e
        shufb   $point_z_2,$record_2,$record_2,$k_z     # 35o

        nop     $127                                    # 36e pairing
        lqd     $record_3,32($a_rectangle)              # 36o

        fm      $n_2,$normal_x,$beside_x                # 37e
        lqd     $record_4,48($a_rectangle)              # 37o

        fm      $n_3,$normal_x,$beside_x_2              # 38e
        lqd     $n_far_2,384($a_rays)                   # 38o

        fs      $beside_y_3,$beside_y_3,$point_y_2      # 39e
        lqd     $n_far_3,400($a_rays)                   # 39o

        fm      $n_4,$normal_x,$beside_x_3              # 40e
        lqd     $n_far_4,416($a_rays)                   # 40o

        fs      $beside_y_4,$beside_y_4,$point_y_2      # 41e
        lqd     $n_far_5,432($a_rays)                   # 41o

        fm      $n_5,$normal_x,$beside_x_4              # 42e
        shufb   $dual_u_x_2,$record_3,$record_3,$k_x    # 42o

        fs      $beside_z_2,$beside_z_2,$point_z_2      # 43e
        shufb   $dual_v_x_2,$record_4,$record_4,$k_x    # 43o

        fma     $n_2,$normal_y,$beside_y,$n_2           # 44e
        shufb   $dual_u_y_2,$record_3,$record_3,$k_y    # 44o

        fnms    $t_e_2,$along,$t_y_2,$k_one             # 45e
        shufb   $dual_v_y_2,$record_4,$record_4,$k_y    # 45o

        fs      $beside_z_3,$beside_z_3,$point_z_2      # 46e
        shufb   $dual_u_z_2,$record_3,$record_3,$k_z    # 46o

        fma     $n_3,$normal_y,$beside_y_2,$n_3         # 47e
        shufb   $dual_v_z_2,$record_4,$record_4,$k_z    # 47o

        fnms    $t_e_3,$along_2,$t_y_3,$k_one           # 48e
        lqa     $m_rows_2,sign_gathers                  # 48o

        fs      $beside_z_4,$beside_z_4,$point_z_2      # 49e
        lqa     $m_code_2,sign_gathers+16               # 49o

        fma     $n_4,$normal_y,$beside_y_3,$n_4         # 50e
        hbr     any_rectangle_r16_return,$lr            # 50o hint

        fnms    $t_e_4,$along_3,$t_y_4,$k_one           # 51e
        fs      $beside_z_6,$beside_z_5,$point_z_2      # 52e

        fma     $n_5,$normal_y,$beside_y_4,$n_5         # 53e
        fnms    $t_e_5,$along_4,$t_y_5,$k_one           # 54e

        fma     $n_6,$normal_z_2,$beside_z_2,$n_2       # 55e
        fma     $inverse_2,$t_e_2,$t_y_2,$t_y_2         # 56e

        fma     $n_7,$normal_z_2,$beside_z_3,$n_3       # 57e
        fma     $inverse_3,$t_e_3,$t_y_3,$t_y_3         # 58e

        fma     $n_8,$normal_z_2,$beside_z_4,$n_4       # 59e
        fma     $inverse_4,$t_e_4,$t_y_4,$t_y_4         # 60e

        fma     $n_5,$normal_z_2,$beside_z_6,$n_5       # 61e
        fma     $inverse_5,$t_e_5,$t_y_5,$t_y_5         # 62e

        fm      $n_6,$n_6,$inverse_2                    # 63e
        fm      $n_9,$n_7,$inverse_3                    # 64e

        xor     $n_far,$n_far_2,$k_sign                 # 65e
        fm      $n_10,$n_8,$inverse_4                   # 66e

        xor     $n_far_6,$n_far_3,$k_sign               # 67e
        fm      $n_11,$n_5,$inverse_5                   # 68e

        fnms    $beside_x,$n_6,$direction_x,$beside_x   # 69e
        fnms    $beside_x_5,$n_9,$direction_x_2,$beside_x_2 # 70e

        fnms    $beside_y,$n_6,$direction_y,$beside_y   # 71e
        fnms    $beside_x_6,$n_10,$direction_x_3,$beside_x_3 # 72e

        fnms    $beside_y_5,$n_9,$direction_y_2,$beside_y_2 # 73e
        fnms    $beside_x_7,$n_11,$direction_x_4,$beside_x_4 # 74e

        fm      $u,$dual_u_x_2,$beside_x                # 75e
        fm      $v,$dual_v_x_2,$beside_x                # 76e

        fm      $u_2,$dual_u_x_2,$beside_x_5            # 77e
        fm      $v_2,$dual_v_x_2,$beside_x_5            # 78e

        fnms    $beside_y_6,$n_10,$direction_y_3,$beside_y_3 # 79e
        fm      $u_3,$dual_u_x_2,$beside_x_6            # 80e

        fm      $v_3,$dual_v_x_2,$beside_x_6            # 81e
        fnms    $beside_y_7,$n_11,$direction_y_4,$beside_y_4 # 82e

        fm      $u_4,$dual_u_x_2,$beside_x_7            # 83e
        fm      $v_4,$dual_v_x_2,$beside_x_7            # 84e

        fnms    $beside_z,$n_6,$direction_z,$beside_z_2 # 85e
        fma     $u,$dual_u_y_2,$beside_y,$u             # 86e

        fma     $v,$dual_v_y_2,$beside_y,$v             # 87e
        fnms    $beside_z_7,$n_9,$direction_z_2,$beside_z_3 # 88e

        fma     $u_5,$dual_u_y_2,$beside_y_5,$u_2       # 89e
        fma     $v_2,$dual_v_y_2,$beside_y_5,$v_2       # 90e

        fnms    $beside_z_8,$n_10,$direction_z_3,$beside_z_4 # 91e
        fma     $u_2,$dual_u_y_2,$beside_y_6,$u_3       # 92e

        fma     $v_3,$dual_v_y_2,$beside_y_6,$v_3       # 93e
        fnms    $beside_z_9,$n_11,$direction_z_4,$beside_z_6 # 94e

        fma     $u_6,$dual_u_y_2,$beside_y_7,$u_4       # 95e
        fma     $v_4,$dual_v_y_2,$beside_y_7,$v_4       # 96e

        fma     $u,$dual_u_z_2,$beside_z,$u             # 97e
        fma     $v,$dual_v_z_2,$beside_z,$v             # 98e

        fma     $u_7,$dual_u_z_2,$beside_z_7,$u_5       # 99e
        fma     $v_2,$dual_v_z_2,$beside_z_7,$v_2       # 100e

        fma     $u_8,$dual_u_z_2,$beside_z_8,$u_2       # 101e
        fma     $v_3,$dual_v_z_2,$beside_z_8,$v_3       # 102e

        fma     $u_9,$dual_u_z_2,$beside_z_9,$u_6       # 103e
        fma     $v_5,$dual_v_z_2,$beside_z_9,$v_4       # 104e

        clgt    $outside,$u,$k_one                      # 105e
        clgt    $c_v,$v,$k_one                          # 106e

        clgt    $outside_2,$u_7,$k_one                  # 107e
        clgt    $c_v_2,$v_2,$k_one                      # 108e

        clgt    $outside_3,$u_8,$k_one                  # 109e
        clgt    $c_v_3,$v_3,$k_one                      # 110e

        xor     $n_far_7,$n_far_4,$k_sign               # 111e
        clgt    $outside_4,$u_9,$k_one                  # 112e

        clgt    $c_v_4,$v_5,$k_one                      # 113e
        xor     $n_far_5,$n_far_5,$k_sign               # 114e

        or      $outside,$outside,$c_v                  # 115e
        cgt     $blocked,$n_far,$n_6                    # 116e 0 < t < t_far

        or      $outside_5,$outside_2,$c_v_2            # 117e
        cgt     $blocked+1,$n_far_6,$n_9                # 118e 0 < t < t_far

        or      $outside_6,$outside_3,$c_v_3            # 119e
        cgt     $blocked+2,$n_far_7,$n_10               # 120e 0 < t < t_far

        or      $outside_7,$outside_4,$c_v_4            # 121e
        cgt     $blocked+3,$n_far_5,$n_11               # 122e 0 < t < t_far

        andc    $blocked,$blocked,$outside              # 123e
        andc    $blocked+1,$blocked+1,$outside_5        # 124e

        andc    $blocked+2,$blocked+2,$outside_6        # 125e
        lnop                                            # 125o pairing

        andc    $blocked+3,$blocked+3,$outside_7        # 126e
        shufb   $a_rays,$blocked,$blocked+1,$m_rows_2   # 126o

        shufb   $low,$blocked+2,$blocked+3,$m_rows_2    # 128o
        shufb   $a_rays,$a_rays,$low,$m_code_2          # 132o

        rotqbii $a_rays,$a_rays,1                       # 136o
        gbb     $a_rays,$a_rays                         # 140o

        nop     $127                                    # 141e pairing
any_rectangle_r16_return:
        bi      $lr                                     # 141o
endfunction any_rectangle_r16
