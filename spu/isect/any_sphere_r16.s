# any_sphere_r16   which of sixteen rays one sphere blocks
#   C       unsigned any_sphere_r16(const struct rays *, const struct ball *);
#   In      $3 rays, $4 sphere; pointers 16-aligned
#   Out     $3 a bit a ray, 0x8000 of the first: hit between 0 and t. None for a ray whose t is not
#           above 0
#   Uses    $2-$67   Saves  -   Stack  0   Calls  -
#   Domain  |d| = 1 within 4 ulp; radius > 0; coordinates and radius below 2^62
#   Error   30 ulp of the larger of t and r: nearer to a hit, t may count as on its other side;
#           origin up to 30 radii from the centre, ray within 0.995 r of it
#   Twin    oracle/src/twin/ball.rs
#
# A word of bits, not four masks: a caller branches on it as it is, and makes masks of it on the odd
# pipe (fsm). No root is taken; the steps are in ball_tmpl.inc.
# Scheduled by spu schedule from any_sphere_r16.s

        .include "work_unit.inc"
        .include "macros.inc"
        .include "ball_tmpl.inc"

        .set    blocked,3
        .set    a_rays,3
        .set    a_ball,4
        # results
        .set    active,10
        .set    code,11
        # constants
        .set    m_x,12
        .set    m_y,13
        .set    m_z,14
        .set    m_radius2,15
        .set    m_even,16
        .set    m_gather,17
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
        .set    t_best,47
        .set    unblocked,51                            # its sign counts
        # temporaries
        .set    fx,55
        .set    fy,56
        .set    fz,57
        .set    b,58
        .set    disc,59
        .set    out,60
        .set    ahead,61
        .set    past,62
        .set    clear,63
        .set    either,64
        .set    first,65
        .set    second,66
        .set    zero,67

        ball_any_shuffles

function any_sphere_r16
        .set    fx_2,2
        .set    fx_3,4
        .set    fx_4,5
        .set    b_2,6
        .set    fy_2,7
        .set    fy_3,8
        .set    b_3,9
        .set    fy_4,10
        .set    b_4,11
        .set    fz_2,12
        .set    fz_3,13
        .set    fz_4,14
        .set    b_5,3
        .set    disc_2,2
        .set    disc_3,4
        .set    disc_4,5
        .set    fz_5,11
        .set    fz_6,7
        .set    fz_7,8
        .set    ahead_2,10
        .set    ahead_3,7
        .set    ahead_4,8
        .set    past_2,11
        .set    past_3,12
        .set    out_2,13
        .set    past_4,14
        .set    out_3,15
        .set    out_4,18
        .set    clear_2,10
        .set    either_2,2
        .set    clear_3,3
        .set    either_3,4
        .set    clear_4,6
        .set    either_4,5
        .set    clear_5,2
        .set    clear_6,4
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

        il      $zero,0                                 # 8e
        lqd     $oy+1,80($a_rays)                       # 8o

        nop     $127                                    # 9e pairing
        lqd     $dx+1,208($a_rays)                      # 9o

        fs      $fx,$cx,$ox                             # 10e
        lqd     $oy+2,96($a_rays)                       # 10o

        fs      $fx_2,$cx,$ox+1                         # 11e
        lqd     $dx+2,224($a_rays)                      # 11o

        fs      $fx_3,$cx,$ox+2                         # 12e
        lqd     $oy+3,112($a_rays)                      # 12o

        fs      $fx_4,$cx,$ox+3                         # 13e
        lqd     $dx+3,240($a_rays)                      # 13o

        shufb   $cy,$ball,$ball,$m_y                    # 14o
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
        lqa     $m_even,even_words                      # 33o

        fma     $b_5,$fz_2,$dz+1,$b_2                   # 34e
        lqa     $m_gather,gather                        # 34o

        fcgt    $unblocked,$t_best,$zero                # 35e
        hbr     any_sphere_r16_return,$lr               # 35o hint

        fma     $b_2,$fz_3,$dz+2,$b_3                   # 36e
        fcgt    $unblocked+1,$t_best+1,$zero            # 37e

        fma     $b_3,$fz_4,$dz+3,$b_4                   # 38e
        lnop                                            # 38o pairing

        fnms    $fx,$b,$dx,$fx                          # 39e
        shufb   $first,$unblocked,$unblocked+1,$m_even  # 39o

        fnms    $fx_2,$b_5,$dx+1,$fx_2                  # 40e
        fnms    $fy,$b,$dy,$fy                          # 41e

        fnms    $fx_3,$b_2,$dx+2,$fx_3                  # 42e
        fnms    $fy_2,$b_5,$dy+1,$fy_2                  # 43e

        fnms    $fx_4,$b_3,$dx+3,$fx_4                  # 44e
        fnms    $disc,$fx,$fx,$radius2                  # 45e

        fnms    $disc_2,$fx_2,$fx_2,$radius2            # 46e
        fnms    $fy_3,$b_2,$dy+2,$fy_3                  # 47e

        fnms    $disc_3,$fx_3,$fx_3,$radius2            # 48e
        fnms    $fy_4,$b_3,$dy+3,$fy_4                  # 49e

        fnms    $disc_4,$fx_4,$fx_4,$radius2            # 50e
        fnms    $fz,$b,$dz,$fz                          # 51e

        fnms    $disc,$fy,$fy,$disc                     # 52e
        fnms    $fz_5,$b_5,$dz+1,$fz_2                  # 53e

        fnms    $disc_2,$fy_2,$fy_2,$disc_2             # 54e
        fnms    $fz_6,$b_2,$dz+2,$fz_3                  # 55e

        fnms    $disc_3,$fy_3,$fy_3,$disc_3             # 56e
        fnms    $fz_7,$b_3,$dz+3,$fz_4                  # 57e

        fnms    $disc_4,$fy_4,$fy_4,$disc_4             # 58e
        fnms    $disc,$fz,$fz,$disc                     # 59e

        fs      $ahead,$t_best,$b                       # 60e
        fnms    $disc_2,$fz_5,$fz_5,$disc_2             # 61e

        fs      $ahead_2,$t_best+1,$b_5                 # 62e
        fnms    $disc_3,$fz_6,$fz_6,$disc_3             # 63e

        fs      $ahead_3,$t_best+2,$b_2                 # 64e
        fnms    $disc_4,$fz_7,$fz_7,$disc_4             # 65e

        fs      $ahead_4,$t_best+3,$b_3                 # 66e
        fms     $past,$ahead,$ahead,$disc               # 67e

        fms     $past_2,$ahead_2,$ahead_2,$disc_2       # 68e
        fms     $out,$b,$b,$disc                        # 69e

        fms     $past_3,$ahead_3,$ahead_3,$disc_3       # 70e
        fms     $out_2,$b_5,$b_5,$disc_2                # 71e

        fms     $past_4,$ahead_4,$ahead_4,$disc_4       # 72e
        fms     $out_3,$b_2,$b_2,$disc_3                # 73e

        fms     $out_4,$b_3,$b_3,$disc_4                # 74e
        andc    $clear,$ahead,$past                     # 75e

        or      $either,$disc,$b                        # 76e
        andc    $clear_2,$ahead_2,$past_2               # 77e

        or      $either_2,$disc_2,$b_5                  # 78e
        andc    $clear_3,$ahead_3,$past_3               # 79e

        or      $either_3,$disc_3,$b_2                  # 80e
        andc    $clear_4,$ahead_4,$past_4               # 81e

        or      $either_4,$disc_4,$b_3                  # 82e
        or      $clear,$clear,$either                   # 83e

        or      $clear_5,$clear_2,$either_2             # 84e
        or      $clear_3,$clear_3,$either_3             # 85e

        or      $clear_6,$clear_4,$either_4             # 86e
        fcgt    $unblocked+2,$t_best+2,$zero            # 87e

        fcgt    $unblocked+3,$t_best+3,$zero            # 88e
        selb    $clear,$clear,$past,$out                # 89e

        selb    $clear_5,$clear_5,$past_2,$out_2        # 90e
        shufb   $second,$unblocked+2,$unblocked+3,$m_even # 90o

        selb    $clear_3,$clear_3,$past_3,$out_3        # 91e
        selb    $clear_6,$clear_6,$past_4,$out_4        # 92e

        and     $unblocked,$unblocked,$clear            # 93e
        lnop                                            # 93o pairing

        and     $unblocked+1,$unblocked+1,$clear_5      # 94e
        shufb   $active,$first,$second,$m_gather        # 94o

        and     $unblocked+2,$unblocked+2,$clear_3      # 95e
        lnop                                            # 95o pairing

        and     $unblocked+3,$unblocked+3,$clear_6      # 96e
        shufb   $first,$unblocked,$unblocked+1,$m_even  # 96o

        shufb   $second,$unblocked+2,$unblocked+3,$m_even # 98o
        rotqbii $active,$active,1                       # 99o

        shufb   $code,$first,$second,$m_gather          # 102o
        gbb     $active,$active                         # 103o

        rotqbii $code,$code,1                           # 106o
        gbb     $code,$code                             # 110o

        xor     $a_rays,$active,$code                   # 114e
any_sphere_r16_return:
        bi      $lr                                     # 114o
endfunction any_sphere_r16
