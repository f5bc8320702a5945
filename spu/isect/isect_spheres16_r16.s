# isect_spheres16_r16   nearest hit of sixteen rays with sixteen spheres
#   C       void isect_spheres16_r16(struct rays *, const struct ball *, int first_object);
#   In      $3 rays, $4 sixteen spheres, $5 object number of the first; pointers 16-aligned
#   Out     rays: t, object, where a hit is at 0 < t < the t that was there
#   Uses    $2, $4-$79   Saves  -   Stack  0   Calls  -
#   Domain  |d| = 1 within 4 ulp; radius > 0; coordinates and radius below 2^62; t not below 0 (0
#           leaves the ray alone)
#   Error   40 ulp of the larger of t and r, origin up to 30 radii from the centre, ray within
#           0.995 r of it
#   Twin    oracle/src/twin/ball.rs
#
# Of equal hits the first counts. The rays stay in registers; the steps are in ball_tmpl.inc.
# Scheduled by spu schedule from isect_spheres16_r16.s

        .include "work_unit.inc"
        .include "macros.inc"
        .include "ball_tmpl.inc"

        .set    a_rays,3
        .set    a_ball,4
        .set    object,5
        # loop
        .set    count,10
        # constants
        .set    m_x,11
        .set    m_y,12
        .set    m_z,13
        .set    m_radius2,14
        .set    k_half,15
        .set    k_one,16
        .set    m_sign,17
        .set    a_merges,18
        # the sphere
        .set    ball,19
        .set    cx,20
        .set    cy,21
        .set    cz,22
        .set    radius2,23
        # the rays: rows 0 to 3
        .set    ox,24
        .set    oy,28
        .set    oz,32
        .set    dx,36
        .set    dy,40
        .set    dz,44
        .set    t_best,48                               # of the nearest hit so far: -t
        .set    nearest,52
        # temporaries
        .set    fx,56
        .set    fy,57
        .set    fz,58
        .set    b,59
        .set    disc,60
        .set    out,61
        .set    y,62
        .set    s,63
        .set    e,64
        .set    t,65
        .set    hit,66
        .set    merge,67

        ball_merges

function isect_spheres16_r16
        .set    count_2,79
        .set    a_ball_2,2
        .set    ball_2,2
        .set    radius2_2,6
        .set    cy_2,7
        .set    fy_2,68
        .set    cz_2,8
        .set    cx_2,9
        .set    fx_2,19
        .set    fx_3,2
        .set    fx_4,20
        .set    fy_3,58
        .set    fy_4,21
        .set    b_2,61
        .set    fz_2,67
        .set    b_3,66
        .set    fz_3,69
        .set    fz_4,70
        .set    b_4,60
        .set    fz_5,22
        .set    fx_5,62
        .set    b_5,73
        .set    b_6,72
        .set    b_7,74
        .set    fx_6,61
        .set    fx_7,65
        .set    disc_2,56
        .set    disc_3,19
        .set    fz_6,60
        .set    disc_4,20
        .set    fz_7,63
        .set    fz_8,64
        .set    fx_8,21
        .set    disc_5,75
        .set    disc_6,77
        .set    disc_7,76
        .set    fy_5,2
        .set    out_2,9
        .set    y_2,19
        .set    out_3,70
        .set    y_3,20
        .set    out_4,69
        .set    y_4,6
        .set    s_2,2
        .set    fy_6,22
        .set    s_3,56
        .set    b_8,58
        .set    e_2,19
        .set    s_4,9
        .set    e_3,6
        .set    b_9,56
        .set    fy_7,7
        .set    t_2,71
        .set    t_3,2
        .set    t_4,9
        .set    hit_2,20
        .set    disc_8,21
        .set    fz_9,62
        .set    merge_2,57
        .set    disc_9,22
        .set    disc_10,7
        .set    b_10,21
        .set    hit_3,2
        .set    b_11,6
        .set    y_5,7
        .set    t_5,78
        .set    y_6,2
        .set    hit_4,7
        .set    merge_3,8
        .set    s_5,7
        .set    s_6,8
        .set    e_4,2
        .set    fx_9,7
        .set    fy_8,20
        .set    t_6,6
        .set    fx_10,8
        .set    fy_9,19
        .set    disc_11,2
        .set    disc_12,8
        .set    fz_10,56
        .set    fz_11,57
        .set    b_12,20
        .set    hit_5,6
        .set    y_7,4
        .set    object_2,2
        .set    e_5,4
        .set    object_3,7
        .set    t_7,5
        .set    t_8,4
        .set    merge_4,7
        .set    fx_11,6
        .set    fy_10,8
        .set    b_13,9
        .set    fz_12,61
        .set    disc_13,6
        .set    fz_13,23
        .set    fz_14,8
        .set    fz_15,19
        .set    out_5,8
        .set    out_6,21
        .set    y_8,22
        .set    y_9,23
        .set    out_7,57
        .set    s_7,64
        .set    s_8,65
        .set    e_6,62
        .set    e_7,22
        .set    e_8,23
        .set    e_9,56
        .set    s_9,21
        .set    s_10,22
        .set    t_9,8
        .set    t_10,19
        .set    hit_6,21
        .set    merge_5,2
        .set    merge_6,6
        ilhu    $m_x,1                                  # 0e
        lqd     $t_best,384($a_rays)                    # 0o

        il      $count,16                               # 1e
        lqd     $t_best+1,400($a_rays)                  # 1o

        iohl    $m_x,515                                # 2e
        lqd     $t_best+2,416($a_rays)                  # 2o

        ilhu    $m_y,0x405                              # 3e
        lqd     $t_best+3,432($a_rays)                  # 3o

        ilhu    $m_z,0x809                              # 4e
        lqd     $ox,0($a_rays)                          # 4o

        ilhu    $m_radius2,0xc0d                        # 5e
        lqd     $oy,64($a_rays)                         # 5o

        ilhu    $m_sign,0x8000                          # 6e
        lqd     $oz,128($a_rays)                        # 6o

        clgti   $count_2,$count,2                       # 7e at least as many passes as overlap
        lqd     $dx,192($a_rays)                        # 7o

        iohl    $m_y,0x607                              # 8e
        lqd     $dy,256($a_rays)                        # 8o

        iohl    $m_z,0xa0b                              # 9e
        lqd     $dz,320($a_rays)                        # 9o

        iohl    $m_radius2,0xe0f                        # 10e
        lqd     $ox+1,16($a_rays)                       # 10o

        ilhu    $k_half,0x3f00                          # 11e
        lqd     $oy+1,80($a_rays)                       # 11o

        ilhu    $k_one,0x3f80                           # 12e
        lqd     $oz+1,144($a_rays)                      # 12o

        ila     $a_merges,merges                        # 13e
        lqd     $dx+1,208($a_rays)                      # 13o

        xor     $t_best,$t_best,$m_sign                 # 14e
        lqd     $dy+1,272($a_rays)                      # 14o

        xor     $t_best+1,$t_best+1,$m_sign             # 15e
        lqd     $dz+1,336($a_rays)                      # 15o

        xor     $t_best+2,$t_best+2,$m_sign             # 16e
        lqd     $ox+2,32($a_rays)                       # 16o

        xor     $t_best+3,$t_best+3,$m_sign             # 17e
        lqd     $oy+2,96($a_rays)                       # 17o

        lqd     $oz+2,160($a_rays)                      # 18o
        lqd     $dx+2,224($a_rays)                      # 19o

        lqd     $dy+2,288($a_rays)                      # 20o
        lqd     $dz+2,352($a_rays)                      # 21o

        lqd     $ox+3,48($a_rays)                       # 22o
        lqd     $oy+3,112($a_rays)                      # 23o

        lqd     $oz+3,176($a_rays)                      # 24o
        lqd     $dx+3,240($a_rays)                      # 25o

        lqd     $dy+3,304($a_rays)                      # 26o
        lqd     $dz+3,368($a_rays)                      # 27o

        lqd     $nearest,448($a_rays)                   # 28o
        lqd     $nearest+1,464($a_rays)                 # 29o

        lqd     $nearest+2,480($a_rays)                 # 30o
        lqd     $nearest+3,496($a_rays)                 # 31o

        shufb   $object,$object,$object,$m_x            # 32o
        brz     $count_2,next_ball_short                # 33o too few passes

        ai      $count,$count,-1                        # 34e
        lqd     $ball,0($a_ball)                        # 34o

        ai      $a_ball_2,$a_ball,16                    # 35e
        ai      $count,$count,-1                        # 36e

        ai      $a_ball,$a_ball_2,16                    # 37e
        lqd     $ball_2,0($a_ball_2)                    # 37o

        shufb   $cy,$ball,$ball,$m_y                    # 40o
        shufb   $cz,$ball,$ball,$m_z                    # 41o

        shufb   $cx,$ball,$ball,$m_x                    # 42o
        shufb   $radius2_2,$ball,$ball,$m_radius2       # 43o

        fs      $fy,$cy,$oy+2                           # 44e
        shufb   $cy_2,$ball_2,$ball_2,$m_y              # 44o

        fs      $fy_2,$cy,$oy                           # 45e
        shufb   $cz_2,$ball_2,$ball_2,$m_z              # 45o

        fs      $fx,$cx,$ox+1                           # 46e
        shufb   $cx_2,$ball_2,$ball_2,$m_x              # 46o

        fs      $fx_2,$cx,$ox+2                         # 47e
        shufb   $radius2,$ball_2,$ball_2,$m_radius2     # 47o

        fs      $fx_3,$cx,$ox                           # 48e
        fs      $fx_4,$cx,$ox+3                         # 49e

        fs      $fy_3,$cy,$oy+1                         # 50e
        fs      $fy_4,$cy,$oy+3                         # 51e

        fm      $b_2,$fx,$dx+1                          # 52e
        fm      $b,$fx_2,$dx+2                          # 53e

        fs      $fz_2,$cz,$oz+1                         # 54e
        fm      $b_3,$fx_4,$dx+3                        # 55e

        fs      $fz_3,$cz,$oz+2                         # 56e
        fs      $fz_4,$cz,$oz+3                         # 57e

        fma     $b_2,$fy_3,$dy+1,$b_2                   # 58e
        fma     $b,$fy,$dy+2,$b                         # 59e

        fm      $b_4,$fx_3,$dx                          # 60e
        fma     $b_3,$fy_4,$dy+3,$b_3                   # 61e

        fs      $fz_5,$cz,$oz                           # 62e
        fs      $fx_5,$cx_2,$ox+1                       # 63e

        fma     $b_5,$fz_2,$dz+1,$b_2                   # 64e
        fma     $b_6,$fz_3,$dz+2,$b                     # 65e

        fma     $b,$fy_2,$dy,$b_4                       # 66e
        fma     $b_7,$fz_4,$dz+3,$b_3                   # 67e

        fs      $fx_6,$cx_2,$ox+2                       # 68e
        fs      $fx_7,$cx_2,$ox                         # 69e

        fnms    $fx,$b_5,$dx+1,$fx                      # 70e
        fnms    $fx_2,$b_6,$dx+2,$fx_2                  # 71e

        fnms    $fy,$b_6,$dy+2,$fy                      # 72e
        fnms    $fx_4,$b_7,$dx+3,$fx_4                  # 73e

        fnms    $fy_3,$b_5,$dy+1,$fy_3                  # 74e
        fnms    $fy_4,$b_7,$dy+3,$fy_4                  # 75e

        fnms    $disc_2,$fx,$fx,$radius2_2              # 76e
        fnms    $disc_3,$fx_2,$fx_2,$radius2_2          # 77e

        fnms    $fz_6,$b_6,$dz+2,$fz_3                  # 78e
        fnms    $disc_4,$fx_4,$fx_4,$radius2_2          # 79e

        fnms    $fz_7,$b_7,$dz+3,$fz_4                  # 80e
        fnms    $fz_8,$b_5,$dz+1,$fz_2                  # 81e

        fnms    $disc_2,$fy_3,$fy_3,$disc_2             # 82e
        fnms    $disc_3,$fy,$fy,$disc_3                 # 83e

        fma     $b,$fz_5,$dz,$b                         # 84e
        fnms    $disc_4,$fy_4,$fy_4,$disc_4             # 85e

        fs      $fx_8,$cx_2,$ox+3                       # 86e
        fs      $fy,$cy_2,$oy+2                         # 87e

        fnms    $disc_5,$fz_8,$fz_8,$disc_2             # 88e
        fnms    $disc_6,$fz_6,$fz_6,$disc_3             # 89e

        fnms    $fx,$b,$dx,$fx_3                        # 90e
        fnms    $disc_7,$fz_7,$fz_7,$disc_4             # 91e

        fnms    $fz,$b,$dz,$fz_5                        # 92e
        fnms    $fy_5,$b,$dy,$fy_2                      # 93e

        fms     $out_2,$b_5,$b_5,$disc_5                # 94e
        frsqest $y_2,$disc_5                            # 94o

        fms     $out_3,$b_6,$b_6,$disc_6                # 95e
        frsqest $y_3,$disc_6                            # 95o

        fnms    $disc,$fx,$fx,$radius2_2                # 96e
        lnop                                            # 96o pairing

        fms     $out_4,$b_7,$b_7,$disc_7                # 97e
        frsqest $y_4,$disc_7                            # 97o

        fi      $y_2,$disc_5,$y_2                       # 98e
        fi      $y_3,$disc_6,$y_3                       # 99e

        fi      $y_4,$disc_7,$y_4                       # 101e
        fnms    $disc,$fy_5,$fy_5,$disc                 # 103e

        fs      $fy_2,$cy_2,$oy                         # 104e
        fm      $s,$disc_5,$y_2                         # 105e

        fm      $s_2,$disc_6,$y_3                       # 106e
        fs      $fy_6,$cy_2,$oy+1                       # 107e

        fm      $s_3,$disc_7,$y_4                       # 108e
        fnms    $disc,$fz,$fz,$disc                     # 109e

        fm      $b_8,$fx_6,$dx+2                        # 110e
        fnms    $e,$s,$y_2,$k_one                       # 111e

        fnms    $e_2,$s_2,$y_3,$k_one                   # 112e
        selb    $s,$s,$out_2,$m_sign                    # 113e

        selb    $s_4,$s_3,$out_4,$m_sign                # 114e
        lnop                                            # 114o pairing

        fnms    $e_3,$s_3,$y_4,$k_one                   # 115e
        frsqest $y_3,$disc                              # 115o

        selb    $s_2,$s_2,$out_3,$m_sign                # 116e
        fma     $e,$e,$k_half,$k_one                    # 117e

        fma     $e_2,$e_2,$k_half,$k_one                # 118e
        fm      $b_9,$fx_5,$dx+1                        # 119e

        fs      $fy_7,$cy_2,$oy+3                       # 120e
        fma     $e_3,$e_3,$k_half,$k_one                # 121e

        fm      $b_3,$fx_8,$dx+3                        # 122e
        fs      $fz_2,$cz_2,$oz+1                       # 123e

        fs      $fz_3,$cz_2,$oz+2                       # 124e
        fma     $b_8,$fy,$dy+2,$b_8                     # 125e

        fma     $b_9,$fy_6,$dy+1,$b_9                   # 126e
        fs      $fz_4,$cz_2,$oz+3                       # 127e

        fma     $b_3,$fy_7,$dy+3,$b_3                   # 128e
        fms     $t_2,$s_2,$e_2,$b_6                     # 129e

        fms     $t_3,$s,$e,$b_5                         # 130e
        fma     $b_6,$fz_3,$dz+2,$b_8                   # 131e

        fms     $t_4,$s_4,$e_3,$b_7                     # 132e
        fma     $b_5,$fz_2,$dz+1,$b_9                   # 133e

        fma     $b_7,$fz_4,$dz+3,$b_3                   # 134e
        fi      $y_4,$disc,$y_3                         # 135e

        cgt     $hit,$t_best+1,$t_3                     # 136e
        fnms    $fx_2,$b_6,$dx+2,$fx_6                  # 137e

        andc    $hit,$hit,$disc_5                       # 138e
        cgt     $hit_2,$t_best+3,$t_4                   # 139e

        fnms    $fy,$b_6,$dy+2,$fy                      # 140e
        rotqbii $hit,$hit,1                             # 140o

        fnms    $fx,$b_5,$dx+1,$fx_5                    # 141e
        fnms    $fx_8,$b_7,$dx+3,$fx_8                  # 142e

        fms     $out,$b,$b,$disc                        # 143e
        hbrr    next_ball_back,next_ball                # 143o hint

        fnms    $fy_6,$b_5,$dy+1,$fy_6                  # 144e
        gb      $hit,$hit                               # 144o

        fnms    $fy_7,$b_7,$dy+3,$fy_7                  # 145e
        fnms    $disc_3,$fx_2,$fx_2,$radius2            # 146e

        fm      $s,$disc,$y_4                           # 147e
        lnop                                            # 147o pairing

        fnms    $disc_2,$fx,$fx,$radius2                # 148e
        shlqbii $hit,$hit,4                             # 148o

        fnms    $disc_8,$fx_8,$fx_8,$radius2            # 149e
        fnms    $fz,$b_6,$dz+2,$fz_3                    # 150e

        fnms    $fz_9,$b_7,$dz+3,$fz_4                  # 151e
        lnop                                            # 151o pairing

        fnms    $disc_3,$fy,$fy,$disc_3                 # 152e
        lqx     $merge_2,$a_merges,$hit                 # 152o

        fnms    $fz_8,$b_5,$dz+1,$fz_2                  # 153e
        fnms    $disc_9,$fy_6,$fy_6,$disc_2             # 154e

        fnms    $disc_10,$fy_7,$fy_7,$disc_8            # 155e
        andc    $hit,$hit_2,$disc_7                     # 156e

        fnms    $e_3,$s,$y_4,$k_one                     # 157e
        lnop                                            # 157o pairing

        cgt     $hit_2,$t_best+2,$t_2                   # 158e
        rotqbii $hit,$hit,1                             # 158o

        fm      $b_10,$fx_7,$dx                         # 159e
        shufb   $t_best+1,$t_best+1,$t_3,$merge_2       # 159o

        andc    $hit_3,$hit_2,$disc_6                   # 160e
        shufb   $nearest+1,$nearest+1,$object,$merge_2  # 160o

        fnms    $disc_5,$fz_8,$fz_8,$disc_9             # 161e
        lnop                                            # 161o pairing

        fnms    $disc_7,$fz_9,$fz_9,$disc_10            # 162e
        gb      $hit,$hit                               # 162o

        fnms    $disc_6,$fz,$fz,$disc_3                 # 163e
        rotqbii $hit_3,$hit_3,1                         # 163o

        fma     $e,$e_3,$k_half,$k_one                  # 164e
        fs      $fz,$cz_2,$oz                           # 165e

        fma     $b_11,$fy_2,$dy,$b_10                   # 166e
        shlqbii $hit,$hit,4                             # 166o

        selb    $s,$s,$out,$m_sign                      # 167e
        gb      $hit_3,$hit_3                           # 167o

        fms     $out_4,$b_7,$b_7,$disc_7                # 168e
        frsqest $y,$disc_5                              # 168o

        fms     $out_3,$b_6,$b_6,$disc_6                # 169e
        frsqest $y_5,$disc_7                            # 169o

        fms     $t_5,$s,$e,$b                           # 170e
        lnop                                            # 170o pairing

next_ball:
        ai      $count,$count,-1                        # 0e
            lqx     $merge,$a_merges,$hit               # 0o

            fma     $b,$fz,$dz,$b_11                    # 1e
            shlqbii $hit,$hit_3,4                       # 1o

            fi      $y,$disc_5,$y                       # 2e
        lqd     $ball,0($a_ball)                        # 2o

            fi      $y_6,$disc_7,$y_5                   # 3e
            frsqest $y_4,$disc_6                        # 3o

        ai      $a_ball,$a_ball,16                      # 4e
        lnop                                            # 4o pairing

            cgt     $hit_4,$t_best,$t_5                 # 5e
            lqx     $merge_3,$a_merges,$hit             # 5o

            fms     $out,$b_5,$b_5,$disc_5              # 6e
            shufb   $nearest+3,$nearest+3,$object,$merge # 6o

            fi      $y_4,$disc_6,$y_4                   # 7e
            shufb   $t_best+3,$t_best+3,$t_4,$merge     # 7o

            andc    $hit,$hit_4,$disc                   # 8e
        shufb   $cy,$ball,$ball,$m_y                    # 8o

            fm      $s,$disc_5,$y                       # 9e
        shufb   $cz,$ball,$ball,$m_z                    # 9o

            fm      $s_5,$disc_7,$y_6                   # 10e
            lnop                                        # 10o pairing

            fnms    $fx,$b,$dx,$fx_7                    # 11e
        shufb   $cx,$ball,$ball,$m_x                    # 11o

            fnms    $fz,$b,$dz,$fz                      # 12e
            rotqbii $hit,$hit,1                         # 12o

            fnms    $fy,$b,$dy,$fy_2                    # 13e
            shufb   $nearest+2,$nearest+2,$object,$merge_3 # 13o

            fm      $s_4,$disc_6,$y_4                   # 14e
            shufb   $t_best+2,$t_best+2,$t_2,$merge_3   # 14o

            fnms    $e,$s,$y,$k_one                     # 15e
            lnop                                        # 15o pairing

            selb    $s_6,$s_5,$out_4,$m_sign            # 16e
            gb      $hit,$hit                           # 16o

            fnms    $disc,$fx,$fx,$radius2              # 17e
        shufb   $radius2,$ball,$ball,$m_radius2         # 17o

            fnms    $e_4,$s_5,$y_6,$k_one               # 18e
        fs      $fx,$cx,$ox+1                           # 19e

        fs      $fx_9,$cx,$ox+2                         # 20e
            shlqbii $hit,$hit,4                         # 20o

        fs      $fx_7,$cx,$ox                           # 21e
            fnms    $e_3,$s_4,$y_4,$k_one               # 22e

            fnms    $disc,$fy,$fy,$disc                 # 23e
            lnop                                        # 23o pairing

            selb    $s,$s,$out,$m_sign                  # 24e
            lqx     $merge,$a_merges,$hit               # 24o

            fma     $e,$e,$k_half,$k_one                # 25e
        fs      $fx_2,$cx,$ox+3                         # 26e

            fma     $e_4,$e_4,$k_half,$k_one            # 27e
        fs      $fy,$cy,$oy+2                           # 28e

            fma     $e_3,$e_3,$k_half,$k_one            # 29e
            lnop                                        # 29o pairing

            fnms    $disc,$fz,$fz,$disc                 # 30e
            shufb   $t_best,$t_best,$t_5,$merge         # 30o

        fs      $fy_2,$cy,$oy                           # 31e
            shufb   $nearest,$nearest,$object,$merge    # 31o

        fs      $fy_8,$cy,$oy+1                         # 32e
            ai      $object,$object,1                   # 33e

            selb    $s_4,$s_4,$out_3,$m_sign            # 34e
        fm      $b_8,$fx_9,$dx+2                        # 35e

        fm      $b_2,$fx,$dx+1                          # 36e
            frsqest $y,$disc                            # 36o

        fs      $fy_4,$cy,$oy+3                         # 37e
        fm      $b_3,$fx_2,$dx+3                        # 38e

        fs      $fz_2,$cz,$oz+1                         # 39e
        fs      $fz_3,$cz,$oz+2                         # 40e

        fma     $b_8,$fy,$dy+2,$b_8                     # 41e
        fma     $b_2,$fy_8,$dy+1,$b_2                   # 42e

        fs      $fz_4,$cz,$oz+3                         # 43e
        fma     $b_3,$fy_4,$dy+3,$b_3                   # 44e

            fms     $t_2,$s_4,$e_3,$b_6                 # 45e
            fms     $t_6,$s,$e,$b_5                     # 46e

        fma     $b_6,$fz_3,$dz+2,$b_8                   # 47e
            fms     $t_4,$s_6,$e_4,$b_7                 # 48e

        fma     $b_5,$fz_2,$dz+1,$b_2                   # 49e
        fma     $b_7,$fz_4,$dz+3,$b_3                   # 50e

            fi      $y,$disc,$y                         # 51e
            cgt     $hit,$t_best+1,$t_6                 # 52e

        fnms    $fx_3,$b_6,$dx+2,$fx_9                  # 53e
            andc    $hit,$hit,$disc_5                   # 54e

            cgt     $hit_4,$t_best+3,$t_4               # 55e
            lnop                                        # 55o pairing

        fnms    $fy,$b_6,$dy+2,$fy                      # 56e
            rotqbii $hit,$hit,1                         # 56o

        fnms    $fx,$b_5,$dx+1,$fx                      # 57e
        fnms    $fx_10,$b_7,$dx+3,$fx_2                 # 58e

            fms     $out,$b,$b,$disc                    # 59e
            lnop                                        # 59o pairing

        fnms    $fy_9,$b_5,$dy+1,$fy_8                  # 60e
            gb      $hit,$hit                           # 60o

        fnms    $fy_8,$b_7,$dy+3,$fy_4                  # 61e
        fnms    $disc_11,$fx_3,$fx_3,$radius2           # 62e

            fm      $s,$disc,$y                         # 63e
            lnop                                        # 63o pairing

        fnms    $disc_8,$fx,$fx,$radius2                # 64e
            shlqbii $hit,$hit,4                         # 64o

        fnms    $disc_12,$fx_10,$fx_10,$radius2         # 65e
        fnms    $fz,$b_6,$dz+2,$fz_3                    # 66e

        fnms    $fz_10,$b_7,$dz+3,$fz_4                 # 67e
        fnms    $disc_11,$fy,$fy,$disc_11               # 68e

        fnms    $fz_11,$b_5,$dz+1,$fz_2                 # 69e
            lqx     $merge,$a_merges,$hit               # 69o

        fnms    $disc_3,$fy_9,$fy_9,$disc_8             # 70e
        fnms    $disc_12,$fy_8,$fy_8,$disc_12           # 71e

            andc    $hit,$hit_4,$disc_7                 # 72e
            fnms    $e,$s,$y,$k_one                     # 73e

            cgt     $hit_4,$t_best+2,$t_2               # 74e
            rotqbii $hit,$hit,1                         # 74o

        fm      $b_12,$fx_7,$dx                         # 75e
            shufb   $t_best+1,$t_best+1,$t_6,$merge     # 75o

            andc    $hit_5,$hit_4,$disc_6               # 76e
            shufb   $nearest+1,$nearest+1,$object,$merge # 76o

        fnms    $disc_5,$fz_11,$fz_11,$disc_3           # 77e
        lnop                                            # 77o pairing

        fnms    $disc_7,$fz_10,$fz_10,$disc_12          # 78e
            gb      $hit,$hit                           # 78o

        fnms    $disc_6,$fz,$fz,$disc_11                # 79e
            rotqbii $hit_3,$hit_5,1                     # 79o

            fma     $e,$e,$k_half,$k_one                # 80e
        fs      $fz,$cz,$oz                             # 81e

        fma     $b_11,$fy_2,$dy,$b_12                   # 82e
            shlqbii $hit,$hit,4                         # 82o

            selb    $s,$s,$out,$m_sign                  # 83e
            gb      $hit_3,$hit_3                       # 83o

        fms     $out_4,$b_7,$b_7,$disc_7                # 84e
        frsqest $y,$disc_5                              # 84o

        fms     $out_3,$b_6,$b_6,$disc_6                # 85e
        frsqest $y_5,$disc_7                            # 85o

            fms     $t_5,$s,$e,$b                       # 86e
next_ball_back:
        brnz    $count,next_ball                        # 86o

next_ball_drain:
        fma     $b,$fz,$dz,$b_11                        # 0e
        frsqest $y_4,$disc_6                            # 0o

        fi      $y,$disc_5,$y                           # 1e
        shlqbii $hit_3,$hit_3,4                         # 1o

        fi      $y_7,$disc_7,$y_5                       # 2e
        lqx     $merge,$a_merges,$hit                   # 2o

        cgt     $hit_4,$t_best,$t_5                     # 3e
        hbr     isect_spheres16_r16_return,$lr          # 3o hint

        fi      $y_4,$disc_6,$y_4                       # 4e
        lnop                                            # 4o pairing

        andc    $hit,$hit_4,$disc                       # 5e
        lqx     $merge_3,$a_merges,$hit_3               # 5o

        fnms    $fx,$b,$dx,$fx_7                        # 6e
        lnop                                            # 6o pairing

        fnms    $fy,$b,$dy,$fy_2                        # 7e
        rotqbii $hit,$hit,1                             # 7o

        fnms    $fz,$b,$dz,$fz                          # 8e
        shufb   $t_best+3,$t_best+3,$t_4,$merge         # 8o

        fm      $s,$disc_5,$y                           # 9e
        shufb   $nearest+3,$nearest+3,$object,$merge    # 9o

        fm      $s_5,$disc_7,$y_7                       # 10e
        lnop                                            # 10o pairing

        fm      $s_4,$disc_6,$y_4                       # 11e
        gb      $hit,$hit                               # 11o

        fnms    $disc,$fx,$fx,$radius2                  # 12e
        shufb   $t_best+2,$t_best+2,$t_2,$merge_3       # 12o

        fms     $out,$b_5,$b_5,$disc_5                  # 13e
        shufb   $nearest+2,$nearest+2,$object,$merge_3  # 13o

        ai      $object_2,$object,1                     # 14e
        lnop                                            # 14o pairing

        fnms    $e,$s,$y,$k_one                         # 15e
        shlqbii $hit,$hit,4                             # 15o

        fnms    $e_5,$s_5,$y_7,$k_one                   # 16e
        fnms    $e_3,$s_4,$y_4,$k_one                   # 17e

        fnms    $disc,$fy,$fy,$disc                     # 18e
        lnop                                            # 18o pairing

        selb    $s_6,$s_5,$out_4,$m_sign                # 19e
        lqx     $merge,$a_merges,$hit                   # 19o

        selb    $s,$s,$out,$m_sign                      # 20e
        fma     $e,$e,$k_half,$k_one                    # 21e

        fma     $e_5,$e_5,$k_half,$k_one                # 22e
        fma     $e_3,$e_3,$k_half,$k_one                # 23e

        fnms    $disc,$fz,$fz,$disc                     # 24e
        lnop                                            # 24o pairing

        selb    $s_4,$s_4,$out_3,$m_sign                # 25e
        shufb   $t_best,$t_best,$t_5,$merge             # 25o

        ai      $object_3,$object_2,1                   # 26e
        shufb   $nearest,$nearest,$object,$merge        # 26o

        fms     $t_7,$s,$e,$b_5                         # 27e
        fms     $t_8,$s_6,$e_5,$b_7                     # 28e

        fms     $t_2,$s_4,$e_3,$b_6                     # 29e
        lnop                                            # 29o pairing

        fms     $out,$b,$b,$disc                        # 30e
        frsqest $y,$disc                                # 30o

        cgt     $hit,$t_best+1,$t_7                     # 33e
        fi      $y,$disc,$y                             # 34e

        cgt     $hit_4,$t_best+3,$t_8                   # 35e
        cgt     $hit_5,$t_best+2,$t_2                   # 36e

        andc    $hit,$hit,$disc_5                       # 37e
        andc    $hit_4,$hit_4,$disc_7                   # 38e

        andc    $hit_5,$hit_5,$disc_6                   # 39e
        rotqbii $hit,$hit,1                             # 39o

        nop     $127                                    # 40e pairing
        rotqbii $hit_4,$hit_4,1                         # 40o

        fm      $s,$disc,$y                             # 41e
        rotqbii $hit_5,$hit_5,1                         # 41o

        gb      $hit,$hit                               # 43o
        gb      $hit_4,$hit_4                           # 44o

        nop     $127                                    # 45e pairing
        gb      $hit_5,$hit_5                           # 45o

        fnms    $e,$s,$y,$k_one                         # 47e
        shlqbii $hit,$hit,4                             # 47o

        selb    $s,$s,$out,$m_sign                      # 48e
        shlqbii $hit_4,$hit_4,4                         # 48o

        shlqbii $hit_5,$hit_5,4                         # 49o
        lqx     $merge,$a_merges,$hit                   # 51o

        nop     $127                                    # 52e pairing
        lqx     $merge_4,$a_merges,$hit_4               # 52o

        fma     $e,$e,$k_half,$k_one                    # 53e
        lqx     $merge_3,$a_merges,$hit_5               # 53o

        shufb   $t_best+1,$t_best+1,$t_7,$merge         # 57o
        shufb   $t_best+3,$t_best+3,$t_8,$merge_4       # 58o

        fms     $t_5,$s,$e,$b                           # 59e
        shufb   $t_best+2,$t_best+2,$t_2,$merge_3       # 59o

        nop     $127                                    # 60e pairing
        shufb   $nearest+1,$nearest+1,$object_2,$merge  # 60o

        xor     $t_best+1,$t_best+1,$m_sign             # 61e
        shufb   $nearest+3,$nearest+3,$object_2,$merge_4 # 61o

        xor     $t_best+3,$t_best+3,$m_sign             # 62e
        shufb   $nearest+2,$nearest+2,$object_2,$merge_3 # 62o

        xor     $t_best+2,$t_best+2,$m_sign             # 63e
        cgt     $hit_4,$t_best,$t_5                     # 65e

        andc    $hit,$hit_4,$disc                       # 67e
        rotqbii $hit,$hit,1                             # 69o

        gb      $hit,$hit                               # 73o
        shlqbii $hit,$hit,4                             # 77o

        lqx     $merge,$a_merges,$hit                   # 81o
        stqd    $t_best+1,400($a_rays)                  # 82o

        stqd    $nearest+1,464($a_rays)                 # 83o
        stqd    $t_best+2,416($a_rays)                  # 84o

        stqd    $nearest+2,480($a_rays)                 # 85o
        stqd    $t_best+3,432($a_rays)                  # 86o

        shufb   $t_best,$t_best,$t_5,$merge             # 87o
        shufb   $nearest,$nearest,$object_2,$merge      # 88o

        stqd    $nearest+3,496($a_rays)                 # 89o
        xor     $t_best,$t_best,$m_sign                 # 91e

        stqd    $nearest,448($a_rays)                   # 92o
        stqd    $t_best,384($a_rays)                    # 93o

        nop     $127                                    # 94e pairing
isect_spheres16_r16_return:
        bi      $lr                                     # 94o

next_ball_short:
        ai      $count,$count,-1                        # 0e
        lqd     $ball,0($a_ball)                        # 0o

        ai      $a_ball,$a_ball,16                      # 1e
        shufb   $cx,$ball,$ball,$m_x                    # 6o

        shufb   $cy,$ball,$ball,$m_y                    # 7o
        shufb   $cz,$ball,$ball,$m_z                    # 8o

        shufb   $radius2,$ball,$ball,$m_radius2         # 9o
        fs      $fx,$cx,$ox                             # 10e

        fs      $fx_3,$cx,$ox+1                         # 11e
        fs      $fx_11,$cx,$ox+2                        # 12e

        fs      $fx_9,$cx,$ox+3                         # 13e
        fs      $fy,$cy,$oy                             # 14e

        fs      $fy_10,$cy,$oy+1                        # 15e
        fm      $b,$fx,$dx                              # 16e

        fm      $b_13,$fx_3,$dx+1                       # 17e
        fs      $fy_9,$cy,$oy+2                         # 18e

        fm      $b_12,$fx_11,$dx+2                      # 19e
        fs      $fy_4,$cy,$oy+3                         # 20e

        fm      $b_8,$fx_9,$dx+3                        # 21e
        fs      $fz_6,$cz,$oz                           # 22e

        fma     $b,$fy,$dy,$b                           # 23e
        fs      $fz_12,$cz,$oz+1                        # 24e

        fma     $b_13,$fy_10,$dy+1,$b_13                # 25e
        fs      $fz_9,$cz,$oz+2                         # 26e

        fma     $b_12,$fy_9,$dy+2,$b_12                 # 27e
        fs      $fz_5,$cz,$oz+3                         # 28e

        fma     $b_8,$fy_4,$dy+3,$b_8                   # 29e
        fma     $b,$fz_6,$dz,$b                         # 30e

        fma     $b_13,$fz_12,$dz+1,$b_13                # 31e
        fma     $b_12,$fz_9,$dz+2,$b_12                 # 33e

        fma     $b_8,$fz_5,$dz+3,$b_8                   # 35e
        fnms    $fx,$b,$dx,$fx                          # 36e

        fnms    $fx_3,$b_13,$dx+1,$fx_3                 # 37e
        fnms    $fy,$b,$dy,$fy                          # 38e

        fnms    $fx_11,$b_12,$dx+2,$fx_11               # 39e
        fnms    $fy_10,$b_13,$dy+1,$fy_10               # 40e

        fnms    $fx_9,$b_8,$dx+3,$fx_9                  # 41e
        fnms    $disc_2,$fx,$fx,$radius2                # 42e

        fnms    $disc_11,$fx_3,$fx_3,$radius2           # 43e
        fnms    $fy_9,$b_12,$dy+2,$fy_9                 # 44e

        fnms    $disc_13,$fx_11,$fx_11,$radius2         # 45e
        fnms    $fy_4,$b_8,$dy+3,$fy_4                  # 46e

        fnms    $disc_10,$fx_9,$fx_9,$radius2           # 47e
        fnms    $fz_13,$b,$dz,$fz_6                     # 48e

        fnms    $disc,$fy,$fy,$disc_2                   # 49e
        fnms    $fz_10,$b_13,$dz+1,$fz_12               # 50e

        fnms    $disc_11,$fy_10,$fy_10,$disc_11         # 51e
        fnms    $fz_14,$b_12,$dz+2,$fz_9                # 52e

        fnms    $disc_13,$fy_9,$fy_9,$disc_13           # 53e
        fnms    $fz_15,$b_8,$dz+3,$fz_5                 # 54e

        fnms    $disc_10,$fy_4,$fy_4,$disc_10           # 55e
        fnms    $disc,$fz_13,$fz_13,$disc               # 56e

        fnms    $disc_11,$fz_10,$fz_10,$disc_11         # 57e
        fnms    $disc_13,$fz_14,$fz_14,$disc_13         # 59e

        fnms    $disc_10,$fz_15,$fz_15,$disc_10         # 61e
        lnop                                            # 61o pairing

        fms     $out,$b,$b,$disc                        # 62e
        frsqest $y,$disc                                # 62o

        fms     $out_5,$b_13,$b_13,$disc_11             # 63e
        frsqest $y_2,$disc_11                           # 63o

        fms     $out_6,$b_12,$b_12,$disc_13             # 65e
        frsqest $y_8,$disc_13                           # 65o

        fi      $y,$disc,$y                             # 66e
        lnop                                            # 66o pairing

        fi      $y_2,$disc_11,$y_2                      # 67e
        frsqest $y_9,$disc_10                           # 67o

        fi      $y_8,$disc_13,$y_8                      # 69e
        fi      $y_9,$disc_10,$y_9                      # 71e

        fm      $s,$disc,$y                             # 73e
        fm      $s_3,$disc_11,$y_2                      # 74e

        fms     $out_7,$b_8,$b_8,$disc_10               # 75e
        fm      $s_7,$disc_13,$y_8                      # 76e

        fm      $s_8,$disc_10,$y_9                      # 78e
        fnms    $e_6,$s,$y,$k_one                       # 79e

        fnms    $e_2,$s_3,$y_2,$k_one                   # 80e
        selb    $s,$s,$out,$m_sign                      # 81e

        fnms    $e_7,$s_7,$y_8,$k_one                   # 82e
        selb    $s_6,$s_3,$out_5,$m_sign                # 83e

        fnms    $e_8,$s_8,$y_9,$k_one                   # 84e
        fma     $e_9,$e_6,$k_half,$k_one                # 85e

        fma     $e_2,$e_2,$k_half,$k_one                # 86e
        selb    $s_9,$s_7,$out_6,$m_sign                # 87e

        fma     $e,$e_7,$k_half,$k_one                  # 88e
        selb    $s_10,$s_8,$out_7,$m_sign               # 89e

        fma     $e_8,$e_8,$k_half,$k_one                # 90e
        fms     $t,$s,$e_9,$b                           # 91e

        fms     $t_9,$s_6,$e_2,$b_13                    # 92e
        fms     $t_4,$s_9,$e,$b_12                      # 94e

        fms     $t_10,$s_10,$e_8,$b_8                   # 96e
        cgt     $hit,$t_best,$t                         # 97e

        cgt     $hit_2,$t_best+1,$t_9                   # 98e
        andc    $hit,$hit,$disc                         # 99e

        cgt     $hit_6,$t_best+2,$t_4                   # 100e
        lnop                                            # 100o pairing

        andc    $hit_3,$hit_2,$disc_11                  # 101e
        rotqbii $hit,$hit,1                             # 101o

        cgt     $hit_2,$t_best+3,$t_10                  # 102e
        lnop                                            # 102o pairing

        andc    $hit_5,$hit_6,$disc_13                  # 103e
        rotqbii $hit_3,$hit_3,1                         # 103o

        andc    $hit_4,$hit_2,$disc_10                  # 104e
        rotqbii $hit_5,$hit_5,1                         # 105o

        rotqbii $hit_4,$hit_4,1                         # 106o
        gb      $hit,$hit                               # 107o

        gb      $hit_3,$hit_3                           # 108o
        gb      $hit_5,$hit_5                           # 109o

        gb      $hit_4,$hit_4                           # 110o
        shlqbii $hit,$hit,4                             # 111o

        shlqbii $hit_3,$hit_3,4                         # 112o
        shlqbii $hit_5,$hit_5,4                         # 113o

        shlqbii $hit_4,$hit_4,4                         # 114o
        lqx     $merge,$a_merges,$hit                   # 115o

        lqx     $merge_5,$a_merges,$hit_3               # 116o
        lqx     $merge_6,$a_merges,$hit_5               # 117o

        lqx     $merge_4,$a_merges,$hit_4               # 118o
        shufb   $t_best,$t_best,$t,$merge               # 121o

        shufb   $nearest,$nearest,$object,$merge        # 122o
        shufb   $t_best+1,$t_best+1,$t_9,$merge_5       # 123o

        shufb   $nearest+1,$nearest+1,$object,$merge_5  # 124o
        shufb   $t_best+2,$t_best+2,$t_4,$merge_6       # 125o

        shufb   $nearest+2,$nearest+2,$object,$merge_6  # 126o
        shufb   $t_best+3,$t_best+3,$t_10,$merge_4      # 127o

        nop     $127                                    # 128e pairing
        shufb   $nearest+3,$nearest+3,$object,$merge_4  # 128o

        ai      $object,$object,1                       # 129e
        brnz    $count,next_ball_short                  # 129o

        xor     $t_best,$t_best,$m_sign                 # 130e
        hbr     isect_spheres16_r16_return_2,$lr        # 130o hint

        xor     $t_best+1,$t_best+1,$m_sign             # 131e
        stqd    $nearest,448($a_rays)                   # 131o

        xor     $t_best+2,$t_best+2,$m_sign             # 132e
        stqd    $t_best,384($a_rays)                    # 132o

        xor     $t_best+3,$t_best+3,$m_sign             # 133e
        stqd    $t_best+1,400($a_rays)                  # 133o

        stqd    $nearest+1,464($a_rays)                 # 134o
        stqd    $t_best+2,416($a_rays)                  # 135o

        stqd    $nearest+2,480($a_rays)                 # 136o
        stqd    $t_best+3,432($a_rays)                  # 137o

        stqd    $nearest+3,496($a_rays)                 # 138o
isect_spheres16_r16_return_2:
        bi      $lr                                     # 139o
endfunction isect_spheres16_r16
