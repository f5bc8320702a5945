# isect_sphere_r16   nearest hit of sixteen rays with one sphere
#   C       void isect_sphere_r16(struct rays *, const struct ball *, int object);
#   In      $3 rays, $4 sphere, $5 object number; pointers 16-aligned
#   Out     rays: t, object, where a hit is at 0 < t < the t that was there
#   Uses    $2, $4-$66   Saves  -   Stack  0   Calls  -
#   Domain  |d| = 1 within 4 ulp; radius > 0; coordinates and radius below 2^62; t not below 0 (0
#           leaves the ray alone)
#   Error   40 ulp of the larger of t and r, origin up to 30 radii from the centre, ray within
#           0.995 r of it
#   Twin    oracle/src/twin/ball.rs
#
# The entry, or the exit of a ray from inside; a ray that leaves the surface outwards from 6 ulp
# of r above it does not meet it again. The steps are in ball_tmpl.inc.
# Scheduled by spu schedule from isect_sphere_r16.s

        .include "work_unit.inc"
        .include "macros.inc"
        .include "ball_tmpl.inc"

        .set    a_rays,3
        .set    a_ball,4
        .set    object,5
        # constants
        .set    m_x,10
        .set    m_y,11
        .set    m_z,12
        .set    m_radius2,13
        .set    k_half,14
        .set    k_one,15
        .set    m_sign,16
        .set    a_merges,17
        # the sphere
        .set    ball,18
        .set    cx,19
        .set    cy,20
        .set    cz,21
        .set    radius2,22
        # the rays: rows 0 to 3
        .set    ox,23
        .set    oy,27
        .set    oz,31
        .set    dx,35
        .set    dy,39
        .set    dz,43
        .set    t_best,47                               # of the nearest hit so far: -t
        .set    nearest,51
        # temporaries
        .set    fx,55
        .set    fy,56
        .set    fz,57
        .set    b,58
        .set    disc,59
        .set    out,60
        .set    y,61
        .set    s,62
        .set    e,63
        .set    t,64
        .set    hit,65
        .set    merge,66

        ball_merges

function isect_sphere_r16
        .set    fx_2,2
        .set    fx_3,4
        .set    fx_4,6
        .set    b_2,7
        .set    fy_2,8
        .set    fy_3,9
        .set    b_3,11
        .set    fy_4,19
        .set    b_4,20
        .set    fz_2,12
        .set    fz_3,13
        .set    fz_4,18
        .set    b_5,10
        .set    disc_2,2
        .set    disc_3,4
        .set    disc_4,6
        .set    fz_5,8
        .set    fz_6,9
        .set    out_2,8
        .set    y_2,9
        .set    out_3,12
        .set    y_3,13
        .set    y_4,18
        .set    s_2,19
        .set    out_4,20
        .set    s_3,21
        .set    s_4,22
        .set    e_2,9
        .set    e_3,13
        .set    s_5,8
        .set    e_4,18
        .set    s_6,12
        .set    e_5,14
        .set    t_2,7
        .set    t_3,8
        .set    t_4,9
        .set    hit_2,10
        .set    hit_3,11
        .set    hit_4,2
        .set    hit_5,4
        .set    hit_6,6
        .set    merge_2,2
        .set    merge_3,4
        .set    merge_4,6
        ilhu    $m_x,1                                  # 0e
        lqd     $ball,0($a_ball)                        # 0o

        ilhu    $m_y,0x405                              # 1e
        lqd     $ox,0($a_rays)                          # 1o

        iohl    $m_x,515                                # 2e
        lqd     $ox+1,16($a_rays)                       # 2o

        iohl    $m_y,0x607                              # 3e
        lqd     $ox+2,32($a_rays)                       # 3o

        ilhu    $m_z,0x809                              # 4e
        lqd     $ox+3,48($a_rays)                       # 4o

        ilhu    $m_radius2,0xc0d                        # 5e
        lqd     $oy,64($a_rays)                         # 5o

        iohl    $m_z,0xa0b                              # 6e
        shufb   $cx,$ball,$ball,$m_x                    # 6o

        iohl    $m_radius2,0xe0f                        # 7e
        lqd     $dx,192($a_rays)                        # 7o

        ilhu    $k_one,0x3f80                           # 8e
        lqd     $oy+1,80($a_rays)                       # 8o

        ilhu    $k_half,0x3f00                          # 9e
        lqd     $dx+1,208($a_rays)                      # 9o

        fs      $fx,$cx,$ox                             # 10e
        lqd     $oy+2,96($a_rays)                       # 10o

        fs      $fx_2,$cx,$ox+1                         # 11e
        lqd     $dx+2,224($a_rays)                      # 11o

        fs      $fx_3,$cx,$ox+2                         # 12e
        lqd     $oy+3,112($a_rays)                      # 12o

        fs      $fx_4,$cx,$ox+3                         # 13e
        lqd     $dx+3,240($a_rays)                      # 13o

        ilhu    $m_sign,0x8000                          # 14e
        shufb   $cy,$ball,$ball,$m_y                    # 14o

        ila     $a_merges,merges                        # 15e
        lqd     $oz,128($a_rays)                        # 15o

        fm      $b,$fx,$dx                              # 16e
        lqd     $dy,256($a_rays)                        # 16o

        fm      $b_2,$fx_2,$dx+1                        # 17e
        lqd     $oz+1,144($a_rays)                      # 17o

        fs      $fy,$cy,$oy                             # 18e
        lqd     $dy+1,272($a_rays)                      # 18o

        fs      $fy_2,$cy,$oy+1                         # 19e
        lqd     $oz+2,160($a_rays)                      # 19o

        fs      $fy_3,$cy,$oy+2                         # 20e
        lqd     $dy+2,288($a_rays)                      # 20o

        fm      $b_3,$fx_3,$dx+2                        # 21e
        lqd     $oz+3,176($a_rays)                      # 21o

        fs      $fy_4,$cy,$oy+3                         # 22e
        lqd     $dy+3,304($a_rays)                      # 22o

        fm      $b_4,$fx_4,$dx+3                        # 23e
        shufb   $cz,$ball,$ball,$m_z                    # 23o

        fma     $b,$fy,$dy,$b                           # 24e
        lqd     $dz,320($a_rays)                        # 24o

        fma     $b_2,$fy_2,$dy+1,$b_2                   # 25e
        lqd     $dz+1,336($a_rays)                      # 25o

        nop     $127                                    # 26e pairing
        lqd     $dz+2,352($a_rays)                      # 26o

        fs      $fz,$cz,$oz                             # 27e
        lqd     $dz+3,368($a_rays)                      # 27o

        fs      $fz_2,$cz,$oz+1                         # 28e
        shufb   $radius2,$ball,$ball,$m_radius2         # 28o

        fs      $fz_3,$cz,$oz+2                         # 29e
        lqd     $t_best,384($a_rays)                    # 29o

        fma     $b_3,$fy_3,$dy+2,$b_3                   # 30e
        lqd     $t_best+1,400($a_rays)                  # 30o

        fs      $fz_4,$cz,$oz+3                         # 31e
        lqd     $t_best+2,416($a_rays)                  # 31o

        fma     $b_4,$fy_4,$dy+3,$b_4                   # 32e
        lqd     $t_best+3,432($a_rays)                  # 32o

        fma     $b,$fz,$dz,$b                           # 33e
        shufb   $object,$object,$object,$m_x            # 33o

        fma     $b_2,$fz_2,$dz+1,$b_2                   # 34e
        hbr     isect_sphere_r16_return,$lr             # 34o hint

        xor     $t_best,$t_best,$m_sign                 # 35e
        lqd     $nearest,448($a_rays)                   # 35o

        fma     $b_5,$fz_3,$dz+2,$b_3                   # 36e
        lqd     $nearest+1,464($a_rays)                 # 36o

        xor     $t_best+1,$t_best+1,$m_sign             # 37e
        lqd     $nearest+2,480($a_rays)                 # 37o

        fma     $b_3,$fz_4,$dz+3,$b_4                   # 38e
        lqd     $nearest+3,496($a_rays)                 # 38o

        fnms    $fx,$b,$dx,$fx                          # 39e
        fnms    $fx_2,$b_2,$dx+1,$fx_2                  # 40e

        fnms    $fy,$b,$dy,$fy                          # 41e
        fnms    $fx_3,$b_5,$dx+2,$fx_3                  # 42e

        fnms    $fy_2,$b_2,$dy+1,$fy_2                  # 43e
        fnms    $fx_4,$b_3,$dx+3,$fx_4                  # 44e

        fnms    $disc,$fx,$fx,$radius2                  # 45e
        fnms    $disc_2,$fx_2,$fx_2,$radius2            # 46e

        fnms    $fy_3,$b_5,$dy+2,$fy_3                  # 47e
        fnms    $disc_3,$fx_3,$fx_3,$radius2            # 48e

        fnms    $fy_4,$b_3,$dy+3,$fy_4                  # 49e
        fnms    $disc_4,$fx_4,$fx_4,$radius2            # 50e

        fnms    $fz,$b,$dz,$fz                          # 51e
        fnms    $disc,$fy,$fy,$disc                     # 52e

        fnms    $fz_2,$b_2,$dz+1,$fz_2                  # 53e
        fnms    $disc_2,$fy_2,$fy_2,$disc_2             # 54e

        fnms    $fz_5,$b_5,$dz+2,$fz_3                  # 55e
        fnms    $disc_3,$fy_3,$fy_3,$disc_3             # 56e

        fnms    $fz_6,$b_3,$dz+3,$fz_4                  # 57e
        fnms    $disc_4,$fy_4,$fy_4,$disc_4             # 58e

        fnms    $disc,$fz,$fz,$disc                     # 59e
        fnms    $disc_2,$fz_2,$fz_2,$disc_2             # 60e

        xor     $t_best+2,$t_best+2,$m_sign             # 61e
        fnms    $disc_3,$fz_5,$fz_5,$disc_3             # 62e

        xor     $t_best+3,$t_best+3,$m_sign             # 63e
        fnms    $disc_4,$fz_6,$fz_6,$disc_4             # 64e

        fms     $out,$b,$b,$disc                        # 65e
        frsqest $y,$disc                                # 65o

        fms     $out_2,$b_2,$b_2,$disc_2                # 66e
        frsqest $y_2,$disc_2                            # 66o

        fms     $out_3,$b_5,$b_5,$disc_3                # 68e
        frsqest $y_3,$disc_3                            # 68o

        fi      $y,$disc,$y                             # 69e
        lnop                                            # 69o pairing

        fi      $y_2,$disc_2,$y_2                       # 70e
        frsqest $y_4,$disc_4                            # 70o

        fi      $y_3,$disc_3,$y_3                       # 72e
        fi      $y_4,$disc_4,$y_4                       # 74e

        fm      $s,$disc,$y                             # 76e
        fm      $s_2,$disc_2,$y_2                       # 77e

        fms     $out_4,$b_3,$b_3,$disc_4                # 78e
        fm      $s_3,$disc_3,$y_3                       # 79e

        fm      $s_4,$disc_4,$y_4                       # 81e
        fnms    $e,$s,$y,$k_one                         # 82e

        fnms    $e_2,$s_2,$y_2,$k_one                   # 83e
        selb    $s,$s,$out,$m_sign                      # 84e

        fnms    $e_3,$s_3,$y_3,$k_one                   # 85e
        selb    $s_5,$s_2,$out_2,$m_sign                # 86e

        fnms    $e_4,$s_4,$y_4,$k_one                   # 87e
        fma     $e,$e,$k_half,$k_one                    # 88e

        fma     $e_2,$e_2,$k_half,$k_one                # 89e
        selb    $s_6,$s_3,$out_3,$m_sign                # 90e

        fma     $e_3,$e_3,$k_half,$k_one                # 91e
        selb    $s_2,$s_4,$out_4,$m_sign                # 92e

        fma     $e_5,$e_4,$k_half,$k_one                # 93e
        fms     $t,$s,$e,$b                             # 94e

        fms     $t_2,$s_5,$e_2,$b_2                     # 95e
        fms     $t_3,$s_6,$e_3,$b_5                     # 97e

        fms     $t_4,$s_2,$e_5,$b_3                     # 99e
        cgt     $hit,$t_best,$t                         # 100e

        cgt     $hit_2,$t_best+1,$t_2                   # 101e
        andc    $hit,$hit,$disc                         # 102e

        cgt     $hit_3,$t_best+2,$t_3                   # 103e
        lnop                                            # 103o pairing

        andc    $hit_4,$hit_2,$disc_2                   # 104e
        rotqbii $hit,$hit,1                             # 104o

        cgt     $hit_2,$t_best+3,$t_4                   # 105e
        lnop                                            # 105o pairing

        andc    $hit_5,$hit_3,$disc_3                   # 106e
        rotqbii $hit_4,$hit_4,1                         # 106o

        andc    $hit_6,$hit_2,$disc_4                   # 107e
        rotqbii $hit_5,$hit_5,1                         # 108o

        rotqbii $hit_6,$hit_6,1                         # 109o
        gb      $hit,$hit                               # 110o

        gb      $hit_4,$hit_4                           # 111o
        gb      $hit_5,$hit_5                           # 112o

        gb      $hit_6,$hit_6                           # 113o
        shlqbii $hit,$hit,4                             # 114o

        shlqbii $hit_4,$hit_4,4                         # 115o
        shlqbii $hit_5,$hit_5,4                         # 116o

        shlqbii $hit_6,$hit_6,4                         # 117o
        lqx     $merge,$a_merges,$hit                   # 118o

        lqx     $merge_2,$a_merges,$hit_4               # 119o
        lqx     $merge_3,$a_merges,$hit_5               # 120o

        lqx     $merge_4,$a_merges,$hit_6               # 121o
        shufb   $t_best,$t_best,$t,$merge               # 124o

        shufb   $t_best+1,$t_best+1,$t_2,$merge_2       # 125o
        shufb   $t_best+2,$t_best+2,$t_3,$merge_3       # 126o

        nop     $127                                    # 127e pairing
        shufb   $t_best+3,$t_best+3,$t_4,$merge_4       # 127o

        xor     $t_best,$t_best,$m_sign                 # 128e
        shufb   $nearest,$nearest,$object,$merge        # 128o

        xor     $t_best+1,$t_best+1,$m_sign             # 129e
        shufb   $nearest+1,$nearest+1,$object,$merge_2  # 129o

        xor     $t_best+2,$t_best+2,$m_sign             # 130e
        shufb   $nearest+2,$nearest+2,$object,$merge_3  # 130o

        xor     $t_best+3,$t_best+3,$m_sign             # 131e
        shufb   $nearest+3,$nearest+3,$object,$merge_4  # 131o

        stqd    $t_best,384($a_rays)                    # 132o
        stqd    $nearest,448($a_rays)                   # 133o

        stqd    $t_best+1,400($a_rays)                  # 134o
        stqd    $nearest+1,464($a_rays)                 # 135o

        stqd    $t_best+2,416($a_rays)                  # 136o
        stqd    $nearest+2,480($a_rays)                 # 137o

        stqd    $t_best+3,432($a_rays)                  # 138o
        stqd    $nearest+3,496($a_rays)                 # 139o

        nop     $127                                    # 140e pairing
isect_sphere_r16_return:
        bi      $lr                                     # 140o
endfunction isect_sphere_r16
