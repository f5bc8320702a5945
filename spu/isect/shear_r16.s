# shear_r16   what isect_triangles_r16 and any_triangles_r16 need to know of sixteen rays
#   C       void shear_r16(const struct rays *, struct shear *);
#   In      $3 rays, $4 shear; pointers 16-aligned
#   Out     shear
#   Uses    $2-$3, $5-$54   Saves  -   Stack  0   Calls  -
#   Domain  the longest component of a direction is from 2^-62 to 2^62
#   Error   1.5 ulp: of 1 in the slopes, of itself in 1 / direction z
#   Twin    oracle/src/twin/triangle.rs
#
# The longest component of the direction becomes z, the two after it, in cyclic order, x and y. A
# point (x, y, z), less the origin, then lies beside the ray by x - slope_x z and y - slope_y z, and
# its t is z / direction z. Slopes are at most 1.
# Scheduled by spu schedule from shear_r16.s

        .include "work_unit.inc"
        .include "macros.inc"
        .include "rays.inc"
        .include "flat.inc"
        .include "shear_tmpl.inc"

        .set    a_rays,3
        .set    a_shear,4
        # constants
        .set    k_x,10
        .set    k_y,11
        .set    k_z,12
        .set    k_one,13
        .set    k_sign,14
        # the rays
        .set    origin_x,15
        .set    origin_y,16
        .set    origin_z,17
        .set    direction_x,18
        .set    direction_y,19
        .set    direction_z,20
        # results
        .set    axis_x,21
        .set    axis_y,22
        .set    axis_z,23
        .set    own_x,24                                # the origin in the ray's own order
        .set    own_y,25
        .set    own_z,26
        .set    slope_x,27
        .set    slope_y,28
        .set    minus_per_z,29
        # temporaries
        .set    x,30
        .set    y,31
        .set    z,32
        .set    inverse,33
        .set    t_y,34
        .set    t_e,35
        .set    c_y,36
        .set    c_z,37

function shear_r16
        .set    direction_x_2,2
        .set    direction_y_2,5
        .set    direction_x_3,6
        .set    direction_y_3,7
        .set    direction_x_4,8
        .set    direction_y_4,9
        .set    direction_z_2,15
        .set    c_y_2,16
        .set    direction_z_3,17
        .set    direction_z_4,21
        .set    c_y_3,22
        .set    origin_x_2,23
        .set    origin_y_2,24
        .set    c_y_4,25
        .set    origin_z_2,26
        .set    z_2,27
        .set    z_3,28
        .set    origin_x_3,29
        .set    z_4,30
        .set    origin_y_3,31
        .set    c_z_2,33
        .set    origin_z_3,35
        .set    c_z_3,38
        .set    origin_x_4,39
        .set    c_z_4,40
        .set    origin_y_4,41
        .set    origin_z_4,42
        .set    origin_x_5,43
        .set    origin_y_5,44
        .set    t_y_2,45
        .set    x_2,46
        .set    t_y_3,47
        .set    y_2,20
        .set    t_y_4,48
        .set    x_3,18
        .set    origin_z_5,3
        .set    t_e_2,46
        .set    y_3,19
        .set    x_4,20
        .set    inverse_2,34
        .set    y_4,15
        .set    t_e_3,49
        .set    t_e_4,13
        .set    x_5,50
        .set    slope_x_2,51
        .set    slope_y_2,52
        .set    inverse_3,45
        .set    inverse_4,46
        .set    inverse_5,13
        .set    y_5,17
        .set    x_6,47
        .set    y_6,21
        .set    x_7,2
        .set    y_7,5
        .set    x_8,6
        .set    y_8,7
        .set    x_9,8
        .set    y_9,9
        .set    t_e_5,15
        .set    t_e_6,17
        .set    slope_x_3,18
        .set    slope_y_3,19
        .set    slope_x_4,20
        .set    slope_y_4,21
        .set    slope_x_5,32
        .set    slope_y_5,47
        .set    axis_x_2,48
        .set    axis_y_2,49
        .set    axis_z_2,50
        .set    own_x_2,53
        .set    own_y_2,54
        .set    slope_x_6,15
        .set    slope_y_6,17
        .set    minus_per_z_2,34
        .set    axis_z_3,34
        .set    own_x_3,48
        .set    own_y_3,49
        .set    t_e_7,2
        .set    t_e_8,5
        .set    t_e_9,6
        .set    t_e_10,7
        .set    t_e_11,8
        .set    t_e_12,9
        .set    slope_x_7,2
        .set    slope_y_7,5
        .set    slope_x_8,6
        .set    slope_y_8,7
        .set    own_z_2,8
        .set    axis_y_3,9
        .set    own_y_4,2
        .set    own_z_3,5
        .set    axis_x_3,6
        .set    axis_y_4,7
        .set    axis_z_4,15
        .set    own_x_4,16
        .set    own_y_5,17
        .set    own_z_4,18
        .set    axis_x_4,19
        .set    axis_z_5,20
        .set    own_x_5,27
        .set    own_y_6,28
        .set    own_z_5,25
        .set    minus_per_z_3,8
        .set    axis_y_5,2
        ilhu    $k_one,0x3f80                           # 0e
        lqd     $direction_x,192($a_rays)               # 0o

        ilhu    $k_y,0x405                              # 1e
        lqd     $direction_y,256($a_rays)               # 1o

        ilhu    $k_z,0x809                              # 2e
        lqd     $direction_z,320($a_rays)               # 2o

        ila     $k_x,0x10203                            # 3e
        lqd     $direction_x_2,208($a_rays)             # 3o

        iohl    $k_y,0x607                              # 4e
        lqd     $direction_y_2,272($a_rays)             # 4o

        iohl    $k_z,0xa0b                              # 5e
        lqd     $direction_x_3,224($a_rays)             # 5o

        ilhu    $k_sign,0x8000                          # 6e
        lqd     $direction_y_3,288($a_rays)             # 6o

        fcmgt   $c_y,$direction_y,$direction_x          # 7e
        lqd     $direction_x_4,240($a_rays)             # 7o

        nop     $127                                    # 8e pairing
        lqd     $direction_y_4,304($a_rays)             # 8o

        selb    $z,$direction_x,$direction_y,$c_y       # 9e
        lqd     $direction_z_2,336($a_rays)             # 9o

        fcmgt   $c_y_2,$direction_y_2,$direction_x_2    # 10e
        lqd     $direction_z_3,352($a_rays)             # 10o

        fcmgt   $c_z,$direction_z,$z                    # 11e
        lqd     $direction_z_4,368($a_rays)             # 11o

        fcmgt   $c_y_3,$direction_y_3,$direction_x_3    # 12e
        lqd     $origin_x_2,0($a_rays)                  # 12o

        selb    $z,$z,$direction_z,$c_z                 # 13e
        lqd     $origin_y_2,64($a_rays)                 # 13o

        fcmgt   $c_y_4,$direction_y_4,$direction_x_4    # 14e
        lqd     $origin_z_2,128($a_rays)                # 14o

        selb    $z_2,$direction_x_2,$direction_y_2,$c_y_2 # 15e
        frest   $t_y,$z                                 # 15o

        selb    $z_3,$direction_x_3,$direction_y_3,$c_y_3 # 16e
        lqd     $origin_x_3,16($a_rays)                 # 16o

        selb    $z_4,$direction_x_4,$direction_y_4,$c_y_4 # 17e
        lqd     $origin_y_3,80($a_rays)                 # 17o

        fcmgt   $c_z_2,$direction_z_2,$z_2              # 18e
        lqd     $origin_z_3,144($a_rays)                # 18o

        fcmgt   $c_z_3,$direction_z_3,$z_3              # 19e
        lqd     $origin_x_4,32($a_rays)                 # 19o

        fcmgt   $c_z_4,$direction_z_4,$z_4              # 20e
        lqd     $origin_y_4,96($a_rays)                 # 20o

        fi      $t_y,$z,$t_y                            # 21e
        lqd     $origin_z_4,160($a_rays)                # 21o

        selb    $z_2,$z_2,$direction_z_2,$c_z_2         # 22e
        lqd     $origin_x_5,48($a_rays)                 # 22o

        selb    $z_3,$z_3,$direction_z_3,$c_z_3         # 23e
        lqd     $origin_y_5,112($a_rays)                # 23o

        selb    $z_4,$z_4,$direction_z_4,$c_z_4         # 24e
        frest   $t_y_2,$z_2                             # 24o

        selb    $x_2,$direction_y,$direction_z,$c_y     # 25e
        frest   $t_y_3,$z_3                             # 25o

        selb    $y_2,$direction_z,$direction_x,$c_y     # 26e
        frest   $t_y_4,$z_4                             # 26o

        selb    $x_3,$x_2,$direction_x,$c_z             # 27e
        lqd     $origin_z_5,176($a_rays)                # 27o

        fnms    $t_e_2,$z,$t_y,$k_one                   # 28e
        fi      $t_y_2,$z_2,$t_y_2                      # 29e

        fi      $t_y_3,$z_3,$t_y_3                      # 30e
        fi      $t_y_4,$z_4,$t_y_4                      # 31e

        selb    $y_3,$y_2,$direction_y,$c_z             # 32e
        selb    $x_4,$direction_y_2,$direction_z_2,$c_y_2 # 33e

        fma     $inverse_2,$t_e_2,$t_y,$t_y             # 34e
        selb    $y_4,$direction_z_2,$direction_x_2,$c_y_2 # 35e

        fnms    $t_e_2,$z_2,$t_y_2,$k_one               # 36e
        fnms    $t_e_3,$z_3,$t_y_3,$k_one               # 37e

        fnms    $t_e_4,$z_4,$t_y_4,$k_one               # 38e
        selb    $x_5,$direction_y_3,$direction_z_3,$c_y_3 # 39e

        fm      $slope_x_2,$x_3,$inverse_2              # 40e
        fm      $slope_y_2,$y_3,$inverse_2              # 41e

        fma     $inverse_3,$t_e_2,$t_y_2,$t_y_2         # 42e
        fma     $inverse_4,$t_e_3,$t_y_3,$t_y_3         # 43e

        fma     $inverse_5,$t_e_4,$t_y_4,$t_y_4         # 44e
        selb    $y_5,$direction_z_3,$direction_x_3,$c_y_3 # 45e

        selb    $x_6,$direction_y_4,$direction_z_4,$c_y_4 # 46e
        selb    $y_6,$direction_z_4,$direction_x_4,$c_y_4 # 47e

        selb    $x_7,$x_4,$direction_x_2,$c_z_2         # 48e
        selb    $y_7,$y_4,$direction_y_2,$c_z_2         # 49e

        selb    $x_8,$x_5,$direction_x_3,$c_z_3         # 50e
        selb    $y_8,$y_5,$direction_y_3,$c_z_3         # 51e

        selb    $x_9,$x_6,$direction_x_4,$c_z_4         # 52e
        selb    $y_9,$y_6,$direction_y_4,$c_z_4         # 53e

        fnms    $t_e_5,$slope_x_2,$z,$x_3               # 54e
        fnms    $t_e_6,$slope_y_2,$z,$y_3               # 55e

        fm      $slope_x_3,$x_7,$inverse_3              # 56e
        fm      $slope_y_3,$y_7,$inverse_3              # 57e

        fm      $slope_x_4,$x_8,$inverse_4              # 58e
        fm      $slope_y_4,$y_8,$inverse_4              # 59e

        fm      $slope_x_5,$x_9,$inverse_5              # 60e
        fm      $slope_y_5,$y_9,$inverse_5              # 61e

        selb    $axis_x_2,$k_y,$k_z,$c_y                # 62e
        selb    $axis_y_2,$k_z,$k_x,$c_y                # 63e

        selb    $axis_z_2,$k_x,$k_y,$c_y                # 64e
        selb    $own_x_2,$origin_y_2,$origin_z_2,$c_y   # 65e

        selb    $own_y_2,$origin_z_2,$origin_x_2,$c_y   # 66e
        fma     $slope_x_6,$t_e_5,$inverse_2,$slope_x_2 # 67e

        fma     $slope_y_6,$t_e_6,$inverse_2,$slope_y_2 # 68e
        xor     $minus_per_z_2,$inverse_2,$k_sign       # 69e

        selb    $axis_x_2,$axis_x_2,$k_x,$c_z           # 70e
        lnop                                            # 70o pairing

        selb    $axis_y_2,$axis_y_2,$k_y,$c_z           # 71e
        stqd    $minus_per_z_2,512($a_shear)            # 71o

        selb    $axis_z_3,$axis_z_2,$k_z,$c_z           # 72e
        stqd    $axis_x_2,0($a_shear)                   # 72o

        selb    $own_x_3,$own_x_2,$origin_x_2,$c_z      # 73e
        stqd    $axis_y_2,64($a_shear)                  # 73o

        selb    $own_y_3,$own_y_2,$origin_y_2,$c_z      # 74e
        hbr     shear_r16_return,$lr                    # 74o hint

        fnms    $t_e_7,$slope_x_3,$z_2,$x_7             # 75e
        stqd    $own_x_3,192($a_shear)                  # 75o

        fnms    $t_e_8,$slope_y_3,$z_2,$y_7             # 76e
        stqd    $own_y_3,256($a_shear)                  # 76o

        fnms    $t_e_9,$slope_x_4,$z_3,$x_8             # 77e
        stqd    $axis_z_3,128($a_shear)                 # 77o

        fnms    $t_e_10,$slope_y_4,$z_3,$y_8            # 78e
        stqd    $slope_x_6,384($a_shear)                # 78o

        fnms    $t_e_11,$slope_x_5,$z_4,$x_9            # 79e
        stqd    $slope_y_6,448($a_shear)                # 79o

        fnms    $t_e_12,$slope_y_5,$z_4,$y_9            # 80e
        fma     $slope_x,$t_e_7,$inverse_3,$slope_x_3   # 81e

        fma     $slope_y,$t_e_8,$inverse_3,$slope_y_3   # 82e
        fma     $slope_x_7,$t_e_9,$inverse_4,$slope_x_4 # 83e

        fma     $slope_y_7,$t_e_10,$inverse_4,$slope_y_4 # 84e
        fma     $slope_x_8,$t_e_11,$inverse_5,$slope_x_5 # 85e

        fma     $slope_y_8,$t_e_12,$inverse_5,$slope_y_5 # 86e
        lnop                                            # 86o pairing

        selb    $own_z_2,$origin_x_2,$origin_y_2,$c_y   # 87e
        stqd    $slope_x,400($a_shear)                  # 87o

        selb    $axis_x,$k_y,$k_z,$c_y_2                # 88e
        stqd    $slope_y,464($a_shear)                  # 88o

        selb    $axis_y_3,$k_z,$k_x,$c_y_2              # 89e
        stqd    $slope_x_7,416($a_shear)                # 89o

        selb    $axis_z,$k_x,$k_y,$c_y_2                # 90e
        stqd    $slope_y_7,480($a_shear)                # 90o

        selb    $own_x,$origin_y_3,$origin_z_3,$c_y_2   # 91e
        stqd    $slope_x_8,432($a_shear)                # 91o

        selb    $own_y_4,$origin_z_3,$origin_x_3,$c_y_2 # 92e
        stqd    $slope_y_8,496($a_shear)                # 92o

        selb    $own_z_3,$origin_x_3,$origin_y_3,$c_y_2 # 93e
        selb    $axis_x_3,$k_y,$k_z,$c_y_3              # 94e

        selb    $axis_y_4,$k_z,$k_x,$c_y_3              # 95e
        selb    $axis_z_4,$k_x,$k_y,$c_y_3              # 96e

        selb    $own_x_4,$origin_y_4,$origin_z_4,$c_y_3 # 97e
        selb    $own_y_5,$origin_z_4,$origin_x_4,$c_y_3 # 98e

        selb    $own_z_4,$origin_x_4,$origin_y_4,$c_y_3 # 99e
        selb    $axis_x_4,$k_y,$k_z,$c_y_4              # 100e

        selb    $axis_y,$k_z,$k_x,$c_y_4                # 101e
        selb    $axis_z_5,$k_x,$k_y,$c_y_4              # 102e

        selb    $own_x_5,$origin_y_5,$origin_z_5,$c_y_4 # 103e
        selb    $own_y_6,$origin_z_5,$origin_x_5,$c_y_4 # 104e

        selb    $own_z_5,$origin_x_5,$origin_y_5,$c_y_4 # 105e
        selb    $own_z,$own_z_2,$origin_z_2,$c_z        # 106e

        xor     $minus_per_z_3,$inverse_3,$k_sign       # 107e
        lnop                                            # 107o pairing

        selb    $axis_x,$axis_x,$k_x,$c_z_2             # 108e
        stqd    $own_z,320($a_shear)                    # 108o

        selb    $axis_y_3,$axis_y_3,$k_y,$c_z_2         # 109e
        stqd    $minus_per_z_3,528($a_shear)            # 109o

        selb    $axis_z,$axis_z,$k_z,$c_z_2             # 110e
        stqd    $axis_x,16($a_shear)                    # 110o

        selb    $own_x,$own_x,$origin_x_3,$c_z_2        # 111e
        stqd    $axis_y_3,80($a_shear)                  # 111o

        selb    $own_y_4,$own_y_4,$origin_y_3,$c_z_2    # 112e
        stqd    $axis_z,144($a_shear)                   # 112o

        selb    $own_z,$own_z_3,$origin_z_3,$c_z_2      # 113e
        stqd    $own_x,208($a_shear)                    # 113o

        xor     $minus_per_z,$inverse_4,$k_sign         # 114e
        stqd    $own_y_4,272($a_shear)                  # 114o

        selb    $axis_x,$axis_x_3,$k_x,$c_z_3           # 115e
        stqd    $own_z,336($a_shear)                    # 115o

        selb    $axis_y_5,$axis_y_4,$k_y,$c_z_3         # 116e
        stqd    $minus_per_z,544($a_shear)              # 116o

        selb    $axis_z,$axis_z_4,$k_z,$c_z_3           # 117e
        stqd    $axis_x,32($a_shear)                    # 117o

        selb    $own_x,$own_x_4,$origin_x_4,$c_z_3      # 118e
        stqd    $axis_y_5,96($a_shear)                  # 118o

        selb    $own_y_4,$own_y_5,$origin_y_4,$c_z_3    # 119e
        stqd    $axis_z,160($a_shear)                   # 119o

        selb    $own_z,$own_z_4,$origin_z_4,$c_z_3      # 120e
        stqd    $own_x,224($a_shear)                    # 120o

        xor     $minus_per_z,$inverse_5,$k_sign         # 121e
        stqd    $own_y_4,288($a_shear)                  # 121o

        selb    $axis_x,$axis_x_4,$k_x,$c_z_4           # 122e
        stqd    $own_z,352($a_shear)                    # 122o

        selb    $axis_y,$axis_y,$k_y,$c_z_4             # 123e
        stqd    $minus_per_z,560($a_shear)              # 123o

        selb    $axis_z,$axis_z_5,$k_z,$c_z_4           # 124e
        stqd    $axis_x,48($a_shear)                    # 124o

        selb    $own_x,$own_x_5,$origin_x_5,$c_z_4      # 125e
        stqd    $axis_y,112($a_shear)                   # 125o

        selb    $own_y_4,$own_y_6,$origin_y_5,$c_z_4    # 126e
        stqd    $axis_z,176($a_shear)                   # 126o

        selb    $own_z,$own_z_5,$origin_z_5,$c_z_4      # 127e
        stqd    $own_x,240($a_shear)                    # 127o

        stqd    $own_y_4,304($a_shear)                  # 128o
        stqd    $own_z,368($a_shear)                    # 129o

        nop     $127                                    # 130e pairing
shear_r16_return:
        bi      $lr                                     # 130o
endfunction shear_r16
