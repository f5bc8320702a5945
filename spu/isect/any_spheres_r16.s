# any_spheres_r16   which of sixteen rays any sphere of an array blocks
#   C       unsigned any_spheres_r16(const struct rays *, const struct ball *, int count);
#   In      $3 rays, $4 spheres, $5 count (0 is none); pointers 16-aligned
#   Out     $3 a bit a ray, 0x8000 of the first: hit between 0 and t. None for a ray whose t is not
#           above 0
#   Uses    $2-$69, $79   Saves  -   Stack  0   Calls  -
#   Domain  |d| = 1 within 4 ulp; radius > 0; coordinates and radius below 2^62
#   Error   30 ulp of the larger of t and r: nearer to a hit, t may count as on its other side;
#           origin up to 30 radii from the centre, ray within 0.995 r of it
#   Twin    oracle/src/twin/ball.rs
#
# Leaves between chunks of CHUNK spheres as soon as no ray is left unblocked. Within a chunk the
# loop is free of exits, as a pipelined one must be: to drain it, look and fill it again costs
# about as much as a sphere. The steps are in ball_tmpl.inc.
# Scheduled by spu schedule from any_spheres_r16.s

        .include "work_unit.inc"
        .include "macros.inc"
        .include "ball_tmpl.inc"

        .set    CHUNK,8

        .set    blocked,3
        .set    a_rays,3
        .set    a_ball,4
        .set    count,5
        # results
        .set    active,10
        .set    code,11
        # the chunk
        .set    chunk,12
        .set    c_short,13
        # constants
        .set    m_x,14
        .set    m_y,15
        .set    m_z,16
        .set    m_radius2,17
        .set    m_even,18
        .set    m_gather,19
        # the sphere
        .set    ball,20
        .set    cx,21
        .set    cy,22
        .set    cz,23
        .set    radius2,24
        # the rays: rows 0 to 3
        .set    ox,25
        .set    oy,29
        .set    oz,33
        .set    dx,37
        .set    dy,41
        .set    dz,45
        .set    t_best,49
        .set    unblocked,53                            # its sign counts
        # temporaries
        .set    fx,57
        .set    fy,58
        .set    fz,59
        .set    b,60
        .set    disc,61
        .set    out,62
        .set    ahead,63
        .set    past,64
        .set    clear,65
        .set    either,66
        .set    first,67
        .set    second,68
        .set    zero,69

        ball_any_shuffles

function any_spheres_r16
        .set    chunk_2,79
        .set    fx_2,3
        .set    fx_3,6
        .set    fx_4,7
        .set    fy_2,8
        .set    b_2,9
        .set    fy_3,11
        .set    b_3,13
        .set    fy_4,20
        .set    b_4,21
        .set    fz_2,22
        .set    fz_3,61
        .set    fz_4,23
        .set    b_5,2
        .set    disc_2,21
        .set    disc_3,3
        .set    disc_4,6
        .set    disc_5,7
        .set    fz_5,8
        .set    fz_6,6
        .set    disc_6,11
        .set    ahead_2,20
        .set    ahead_3,8
        .set    ahead_4,7
        .set    past_2,21
        .set    past_3,22
        .set    out_2,23
        .set    past_4,24
        .set    out_3,57
        .set    out_4,58
        .set    clear_2,11
        .set    either_2,3
        .set    clear_3,8
        .set    either_3,2
        .set    clear_4,7
        .set    either_4,6
        .set    clear_5,9
        .set    clear_6,2
        .set    clear_7,3
        .set    clear_8,6
        .set    fx_5,2
        .set    fy_5,7
        .set    b_6,8
        .set    fy_6,9
        .set    b_7,11
        .set    fy_7,13
        .set    b_8,20
        .set    fz_7,21
        .set    disc_7,2
        .set    fz_8,7
        .set    fz_9,9
        .set    ahead_5,13
        .set    ahead_6,9
        .set    clear_9,13
        il      $zero,0                                 # 0e
        lqd     $t_best,384($a_rays)                    # 0o

        ilhu    $m_x,1                                  # 1e
        lqd     $t_best+1,400($a_rays)                  # 1o

        ilhu    $m_radius2,0xc0d                        # 2e
        lqd     $t_best+2,416($a_rays)                  # 2o

        ilhu    $m_y,0x405                              # 3e
        lqd     $t_best+3,432($a_rays)                  # 3o

        iohl    $m_x,515                                # 4e
        lqa     $m_even,even_words                      # 4o

        iohl    $m_y,0x607                              # 5e
        lqa     $m_gather,gather                        # 5o

        fcgt    $unblocked,$t_best,$zero                # 6e
        lqd     $oy,64($a_rays)                         # 6o

        fcgt    $unblocked+1,$t_best+1,$zero            # 7e
        lqd     $dx+1,208($a_rays)                      # 7o

        fcgt    $unblocked+2,$t_best+2,$zero            # 8e
        lqd     $dx+3,240($a_rays)                      # 8o

        fcgt    $unblocked+3,$t_best+3,$zero            # 9e
        lqd     $dy+3,304($a_rays)                      # 9o

        ilhu    $m_z,0x809                              # 10e
        shufb   $first,$unblocked,$unblocked+1,$m_even  # 10o

        iohl    $m_radius2,0xe0f                        # 11e
        shufb   $second,$unblocked+2,$unblocked+3,$m_even # 11o

        iohl    $m_z,0xa0b                              # 12e
        lqd     $dz+1,336($a_rays)                      # 12o

        lqd     $ox+3,48($a_rays)                       # 13o
        lqd     $oz+3,176($a_rays)                      # 14o

        shufb   $active,$first,$second,$m_gather        # 15o
        lqd     $dz+3,368($a_rays)                      # 16o

        lqd     $oz,128($a_rays)                        # 17o
        lqd     $dz,320($a_rays)                        # 18o

        rotqbii $active,$active,1                       # 19o
        lqd     $ox+1,16($a_rays)                       # 20o

        lqd     $dy+2,288($a_rays)                      # 21o
        lqd     $oy+3,112($a_rays)                      # 22o

        gbb     $active,$active                         # 23o
        lqd     $ox,0($a_rays)                          # 24o

        lqd     $dx,192($a_rays)                        # 25o
        lqd     $dy,256($a_rays)                        # 26o

        ori     $code,$active,0                         # 27e
        lqd     $oy+1,80($a_rays)                       # 27o

        lqd     $oz+1,144($a_rays)                      # 28o
        lqd     $dy+1,272($a_rays)                      # 29o

        lqd     $ox+2,32($a_rays)                       # 30o
        lqd     $oy+2,96($a_rays)                       # 31o

        lqd     $oz+2,160($a_rays)                      # 32o
        lqd     $dx+2,224($a_rays)                      # 33o

        nop     $127                                    # 34e pairing
        lqd     $dz+2,352($a_rays)                      # 34o

next_chunk:
        nop     $127                                    # 0e pairing
        brz     $code,done                              # 0o

        nop     $127                                    # 1e pairing
        brz     $count,done                             # 1o

        il      $chunk,8                                # 2e
        cgt     $c_short,$chunk,$count                  # 4e

        selb    $chunk,$chunk,$count,$c_short           # 6e
        clgti   $chunk_2,$chunk,1                       # 8e at least as many passes as overlap

        sf      $count,$chunk,$count                    # 9e
        brz     $chunk_2,next_ball_short                # 10o too few passes

        ai      $chunk,$chunk,-1                        # 11e
        lqd     $ball,0($a_ball)                        # 11o

        ai      $a_ball,$a_ball,16                      # 12e
        shufb   $cx,$ball,$ball,$m_x                    # 17o

        shufb   $cy,$ball,$ball,$m_y                    # 18o
        shufb   $cz,$ball,$ball,$m_z                    # 19o

        shufb   $radius2,$ball,$ball,$m_radius2         # 20o
        fs      $fx,$cx,$ox                             # 21e

        fs      $fx_2,$cx,$ox+1                         # 22e
        fs      $fx_3,$cx,$ox+2                         # 23e

        fs      $fx_4,$cx,$ox+3                         # 24e
        fs      $fy,$cy,$oy                             # 25e

        fs      $fy_2,$cy,$oy+1                         # 26e
        fm      $b,$fx,$dx                              # 27e

        fm      $b_2,$fx_2,$dx+1                        # 28e
        fs      $fy_3,$cy,$oy+2                         # 29e

        fm      $b_3,$fx_3,$dx+2                        # 30e
        fs      $fy_4,$cy,$oy+3                         # 31e

        fm      $b_4,$fx_4,$dx+3                        # 32e
        fs      $fz,$cz,$oz                             # 33e

        fma     $b,$fy,$dy,$b                           # 34e
        lnop                                            # 34o pairing

        fs      $fz_2,$cz,$oz+1                         # 35e
        hbrr    next_ball_back,next_ball                # 35o hint

        fma     $b_2,$fy_2,$dy+1,$b_2                   # 36e
        fs      $fz_3,$cz,$oz+2                         # 37e

        fma     $b_3,$fy_3,$dy+2,$b_3                   # 38e
        fs      $fz_4,$cz,$oz+3                         # 39e

        fma     $b_4,$fy_4,$dy+3,$b_4                   # 40e
        fma     $b,$fz,$dz,$b                           # 41e

        fma     $b_2,$fz_2,$dz+1,$b_2                   # 42e
        fma     $b_5,$fz_3,$dz+2,$b_3                   # 44e

        fma     $b_3,$fz_4,$dz+3,$b_4                   # 46e
        fnms    $fx,$b,$dx,$fx                          # 47e

        fnms    $fx_2,$b_2,$dx+1,$fx_2                  # 48e
        fnms    $fy,$b,$dy,$fy                          # 49e

        fnms    $fx_3,$b_5,$dx+2,$fx_3                  # 50e
        fnms    $fy_2,$b_2,$dy+1,$fy_2                  # 51e

        fnms    $fx_4,$b_3,$dx+3,$fx_4                  # 52e
        fnms    $disc_2,$fx,$fx,$radius2                # 53e

        fnms    $disc_3,$fx_2,$fx_2,$radius2            # 54e
        fnms    $fy_3,$b_5,$dy+2,$fy_3                  # 55e

        fnms    $disc_4,$fx_3,$fx_3,$radius2            # 56e
        fnms    $fy_4,$b_3,$dy+3,$fy_4                  # 57e

        fnms    $disc_5,$fx_4,$fx_4,$radius2            # 58e
        fnms    $fz,$b,$dz,$fz                          # 59e

        fnms    $disc_2,$fy,$fy,$disc_2                 # 60e
        fnms    $fz_2,$b_2,$dz+1,$fz_2                  # 61e

        fnms    $disc_3,$fy_2,$fy_2,$disc_3             # 62e
        fnms    $fz_5,$b_5,$dz+2,$fz_3                  # 63e

        fnms    $disc,$fy_3,$fy_3,$disc_4               # 64e
        fnms    $fz_6,$b_3,$dz+3,$fz_4                  # 65e

        fnms    $disc_5,$fy_4,$fy_4,$disc_5             # 66e
        fnms    $disc_6,$fz,$fz,$disc_2                 # 67e

        fs      $ahead,$t_best,$b                       # 68e
        fnms    $disc_3,$fz_2,$fz_2,$disc_3             # 69e

        fs      $ahead_2,$t_best+1,$b_2                 # 70e
        fnms    $disc,$fz_5,$fz_5,$disc                 # 71e

        fs      $ahead_3,$t_best+2,$b_5                 # 72e
        fnms    $disc_4,$fz_6,$fz_6,$disc_5             # 73e

        fs      $ahead_4,$t_best+3,$b_3                 # 74e
        fms     $past,$ahead,$ahead,$disc_6             # 75e

        fms     $past_2,$ahead_2,$ahead_2,$disc_3       # 76e
        fms     $out,$b,$b,$disc_6                      # 77e

        fms     $past_3,$ahead_3,$ahead_3,$disc         # 78e
        fms     $out_2,$b_2,$b_2,$disc_3                # 79e

        fms     $past_4,$ahead_4,$ahead_4,$disc_4       # 80e
        fms     $out_3,$b_5,$b_5,$disc                  # 81e

        fms     $out_4,$b_3,$b_3,$disc_4                # 82e
        andc    $clear,$ahead,$past                     # 83e

        or      $either,$disc_6,$b                      # 84e
        andc    $clear_2,$ahead_2,$past_2               # 85e

        or      $either_2,$disc_3,$b_2                  # 86e
        andc    $clear_3,$ahead_3,$past_3               # 87e

        or      $either_3,$disc,$b_5                    # 88e
        andc    $clear_4,$ahead_4,$past_4               # 89e

        or      $either_4,$disc_4,$b_3                  # 90e
        or      $clear_5,$clear,$either                 # 91e

        or      $clear_2,$clear_2,$either_2             # 92e
        lnop                                            # 92o pairing

next_ball:
            or      $clear,$clear_3,$either_3           # 0e
        lqd     $ball,0($a_ball)                        # 0o

            or      $clear_6,$clear_4,$either_4         # 1e
            selb    $clear_7,$clear_5,$past,$out        # 2e

            selb    $clear_8,$clear_2,$past_2,$out_2    # 3e
            selb    $clear,$clear,$past_3,$out_3        # 4e

            selb    $clear_6,$clear_6,$past_4,$out_4    # 5e
            lnop                                        # 5o pairing

        ai      $chunk,$chunk,-1                        # 6e
        shufb   $cx,$ball,$ball,$m_x                    # 6o

            and     $unblocked,$unblocked,$clear_7      # 7e
        shufb   $cy,$ball,$ball,$m_y                    # 7o

            and     $unblocked+1,$unblocked+1,$clear_8  # 8e
        shufb   $cz,$ball,$ball,$m_z                    # 8o

            and     $unblocked+2,$unblocked+2,$clear    # 9e
        shufb   $radius2,$ball,$ball,$m_radius2         # 9o

        fs      $fx,$cx,$ox                             # 10e
        fs      $fx_2,$cx,$ox+1                         # 11e

        fs      $fx_3,$cx,$ox+2                         # 12e
        fs      $fx_4,$cx,$ox+3                         # 13e

        fs      $fy,$cy,$oy                             # 14e
        fs      $fy_2,$cy,$oy+1                         # 15e

        fm      $b,$fx,$dx                              # 16e
        fm      $b_2,$fx_2,$dx+1                        # 17e

        fs      $fy_3,$cy,$oy+2                         # 18e
        fm      $b_3,$fx_3,$dx+2                        # 19e

        fs      $fy_4,$cy,$oy+3                         # 20e
        fm      $b_4,$fx_4,$dx+3                        # 21e

        fs      $fz,$cz,$oz                             # 22e
        fma     $b,$fy,$dy,$b                           # 23e

        fs      $fz_2,$cz,$oz+1                         # 24e
        fma     $b_2,$fy_2,$dy+1,$b_2                   # 25e

        fs      $fz_3,$cz,$oz+2                         # 26e
        fma     $b_3,$fy_3,$dy+2,$b_3                   # 27e

        fs      $fz_4,$cz,$oz+3                         # 28e
        fma     $b_4,$fy_4,$dy+3,$b_4                   # 29e

        fma     $b,$fz,$dz,$b                           # 30e
        fma     $b_2,$fz_2,$dz+1,$b_2                   # 31e

            and     $unblocked+3,$unblocked+3,$clear_6  # 32e
        fma     $b_5,$fz_3,$dz+2,$b_3                   # 33e

        ai      $a_ball,$a_ball,16                      # 34e
        fma     $b_3,$fz_4,$dz+3,$b_4                   # 35e

        fnms    $fx,$b,$dx,$fx                          # 36e
        fnms    $fx_2,$b_2,$dx+1,$fx_2                  # 37e

        fnms    $fy,$b,$dy,$fy                          # 38e
        fnms    $fx_3,$b_5,$dx+2,$fx_3                  # 39e

        fnms    $fy_2,$b_2,$dy+1,$fy_2                  # 40e
        fnms    $fx_4,$b_3,$dx+3,$fx_4                  # 41e

        fnms    $disc_2,$fx,$fx,$radius2                # 42e
        fnms    $disc_3,$fx_2,$fx_2,$radius2            # 43e

        fnms    $fy_3,$b_5,$dy+2,$fy_3                  # 44e
        fnms    $disc_4,$fx_3,$fx_3,$radius2            # 45e

        fnms    $fy_4,$b_3,$dy+3,$fy_4                  # 46e
        fnms    $disc_5,$fx_4,$fx_4,$radius2            # 47e

        fnms    $fz,$b,$dz,$fz                          # 48e
        fnms    $disc_2,$fy,$fy,$disc_2                 # 49e

        fnms    $fz_2,$b_2,$dz+1,$fz_2                  # 50e
        fnms    $disc_3,$fy_2,$fy_2,$disc_3             # 51e

        fnms    $fz_5,$b_5,$dz+2,$fz_3                  # 52e
        fnms    $disc,$fy_3,$fy_3,$disc_4               # 53e

        fnms    $fz_6,$b_3,$dz+3,$fz_4                  # 54e
        fnms    $disc_5,$fy_4,$fy_4,$disc_5             # 55e

        fnms    $disc_6,$fz,$fz,$disc_2                 # 56e
        fs      $ahead,$t_best,$b                       # 57e

        fnms    $disc_3,$fz_2,$fz_2,$disc_3             # 58e
        fs      $ahead_2,$t_best+1,$b_2                 # 59e

        fnms    $disc,$fz_5,$fz_5,$disc                 # 60e
        fs      $ahead_3,$t_best+2,$b_5                 # 61e

        fnms    $disc_4,$fz_6,$fz_6,$disc_5             # 62e
        fs      $ahead_4,$t_best+3,$b_3                 # 63e

        fms     $past,$ahead,$ahead,$disc_6             # 64e
        fms     $past_2,$ahead_2,$ahead_2,$disc_3       # 65e

        fms     $out,$b,$b,$disc_6                      # 66e
        fms     $past_3,$ahead_3,$ahead_3,$disc         # 67e

        fms     $out_2,$b_2,$b_2,$disc_3                # 68e
        fms     $past_4,$ahead_4,$ahead_4,$disc_4       # 69e

        fms     $out_3,$b_5,$b_5,$disc                  # 70e
        fms     $out_4,$b_3,$b_3,$disc_4                # 71e

        andc    $clear,$ahead,$past                     # 72e
        or      $either,$disc_6,$b                      # 73e

        andc    $clear_2,$ahead_2,$past_2               # 74e
        or      $either_2,$disc_3,$b_2                  # 75e

        andc    $clear_3,$ahead_3,$past_3               # 76e
        or      $either_3,$disc,$b_5                    # 77e

        andc    $clear_4,$ahead_4,$past_4               # 78e
        or      $either_4,$disc_4,$b_3                  # 79e

        or      $clear_5,$clear,$either                 # 80e
        lnop                                            # 80o pairing

        or      $clear_2,$clear_2,$either_2             # 81e
next_ball_back:
        brnz    $chunk,next_ball                        # 81o

next_ball_drain:
        or      $clear,$clear_3,$either_3               # 0e
        or      $clear_6,$clear_4,$either_4             # 1e

        selb    $clear_7,$clear_5,$past,$out            # 2e
        selb    $clear_8,$clear_2,$past_2,$out_2        # 3e

        selb    $clear,$clear,$past_3,$out_3            # 4e
        selb    $clear_6,$clear_6,$past_4,$out_4        # 5e

        and     $unblocked,$unblocked,$clear_7          # 6e
        and     $unblocked+1,$unblocked+1,$clear_8      # 7e

        and     $unblocked+2,$unblocked+2,$clear        # 8e
        lnop                                            # 8o pairing

        and     $unblocked+3,$unblocked+3,$clear_6      # 9e
        shufb   $first,$unblocked,$unblocked+1,$m_even  # 9o

        shufb   $second,$unblocked+2,$unblocked+3,$m_even # 11o
        shufb   $code,$first,$second,$m_gather          # 15o

        rotqbii $code,$code,1                           # 19o
        gbb     $code,$code                             # 23o

        nop     $127                                    # 24e pairing
        br      next_chunk                              # 24o

done:
        xor     $a_rays,$active,$code                   # 0e
        bi      $lr                                     # 0o

next_ball_short:
        ai      $chunk,$chunk,-1                        # 0e
        lqd     $ball,0($a_ball)                        # 0o

        ai      $a_ball,$a_ball,16                      # 1e
        shufb   $cx,$ball,$ball,$m_x                    # 6o

        shufb   $cy,$ball,$ball,$m_y                    # 7o
        shufb   $cz,$ball,$ball,$m_z                    # 8o

        shufb   $radius2,$ball,$ball,$m_radius2         # 9o
        fs      $fx,$cx,$ox                             # 10e

        fs      $fx_5,$cx,$ox+1                         # 11e
        fs      $fx_2,$cx,$ox+2                         # 12e

        fs      $fx_3,$cx,$ox+3                         # 13e
        fs      $fy,$cy,$oy                             # 14e

        fs      $fy_5,$cy,$oy+1                         # 15e
        fm      $b,$fx,$dx                              # 16e

        fm      $b_6,$fx_5,$dx+1                        # 17e
        fs      $fy_6,$cy,$oy+2                         # 18e

        fm      $b_7,$fx_2,$dx+2                        # 19e
        fs      $fy_7,$cy,$oy+3                         # 20e

        fm      $b_8,$fx_3,$dx+3                        # 21e
        fs      $fz,$cz,$oz                             # 22e

        fma     $b,$fy,$dy,$b                           # 23e
        fs      $fz_7,$cz,$oz+1                         # 24e

        fma     $b_6,$fy_5,$dy+1,$b_6                   # 25e
        fs      $fz_2,$cz,$oz+2                         # 26e

        fma     $b_7,$fy_6,$dy+2,$b_7                   # 27e
        fs      $fz_4,$cz,$oz+3                         # 28e

        fma     $b_8,$fy_7,$dy+3,$b_8                   # 29e
        fma     $b,$fz,$dz,$b                           # 30e

        fma     $b_6,$fz_7,$dz+1,$b_6                   # 31e
        fma     $b_7,$fz_2,$dz+2,$b_7                   # 33e

        fma     $b_8,$fz_4,$dz+3,$b_8                   # 35e
        fnms    $fx,$b,$dx,$fx                          # 36e

        fnms    $fx_5,$b_6,$dx+1,$fx_5                  # 37e
        fnms    $fy,$b,$dy,$fy                          # 38e

        fnms    $fx_2,$b_7,$dx+2,$fx_2                  # 39e
        fnms    $fy_5,$b_6,$dy+1,$fy_5                  # 40e

        fnms    $fx_3,$b_8,$dx+3,$fx_3                  # 41e
        fnms    $disc,$fx,$fx,$radius2                  # 42e

        fnms    $disc_7,$fx_5,$fx_5,$radius2            # 43e
        fnms    $fy_6,$b_7,$dy+2,$fy_6                  # 44e

        fnms    $disc_3,$fx_2,$fx_2,$radius2            # 45e
        fnms    $fy_7,$b_8,$dy+3,$fy_7                  # 46e

        fnms    $disc_4,$fx_3,$fx_3,$radius2            # 47e
        fnms    $fz,$b,$dz,$fz                          # 48e

        fnms    $disc,$fy,$fy,$disc                     # 49e
        fnms    $fz_7,$b_6,$dz+1,$fz_7                  # 50e

        fnms    $disc_7,$fy_5,$fy_5,$disc_7             # 51e
        fnms    $fz_8,$b_7,$dz+2,$fz_2                  # 52e

        fnms    $disc_3,$fy_6,$fy_6,$disc_3             # 53e
        fnms    $fz_9,$b_8,$dz+3,$fz_4                  # 54e

        fnms    $disc_4,$fy_7,$fy_7,$disc_4             # 55e
        fnms    $disc,$fz,$fz,$disc                     # 56e

        fs      $ahead,$t_best,$b                       # 57e
        fnms    $disc_7,$fz_7,$fz_7,$disc_7             # 58e

        fs      $ahead_5,$t_best+1,$b_6                 # 59e
        fnms    $disc_3,$fz_8,$fz_8,$disc_3             # 60e

        fs      $ahead_4,$t_best+2,$b_7                 # 61e
        fnms    $disc_4,$fz_9,$fz_9,$disc_4             # 62e

        fs      $ahead_6,$t_best+3,$b_8                 # 63e
        fms     $past,$ahead,$ahead,$disc               # 64e

        fms     $past_2,$ahead_5,$ahead_5,$disc_7       # 65e
        fms     $out,$b,$b,$disc                        # 66e

        fms     $past_3,$ahead_4,$ahead_4,$disc_3       # 67e
        fms     $out_2,$b_6,$b_6,$disc_7                # 68e

        fms     $past_4,$ahead_6,$ahead_6,$disc_4       # 69e
        fms     $out_3,$b_7,$b_7,$disc_3                # 70e

        fms     $out_4,$b_8,$b_8,$disc_4                # 71e
        andc    $clear,$ahead,$past                     # 72e

        or      $either,$disc,$b                        # 73e
        andc    $clear_9,$ahead_5,$past_2               # 74e

        or      $either_3,$disc_7,$b_6                  # 75e
        andc    $clear_4,$ahead_4,$past_3               # 76e

        or      $either_2,$disc_3,$b_7                  # 77e
        andc    $clear_3,$ahead_6,$past_4               # 78e

        or      $either_4,$disc_4,$b_8                  # 79e
        or      $clear,$clear,$either                   # 80e

        or      $clear_6,$clear_9,$either_3             # 81e
        or      $clear_7,$clear_4,$either_2             # 82e

        or      $clear_8,$clear_3,$either_4             # 83e
        selb    $clear,$clear,$past,$out                # 84e

        selb    $clear_6,$clear_6,$past_2,$out_2        # 85e
        selb    $clear_7,$clear_7,$past_3,$out_3        # 86e

        selb    $clear_8,$clear_8,$past_4,$out_4        # 87e
        and     $unblocked,$unblocked,$clear            # 88e

        and     $unblocked+1,$unblocked+1,$clear_6      # 89e
        and     $unblocked+2,$unblocked+2,$clear_7      # 90e

        and     $unblocked+3,$unblocked+3,$clear_8      # 91e
        brnz    $chunk,next_ball_short                  # 91o

        shufb   $first,$unblocked,$unblocked+1,$m_even  # 92o
        shufb   $second,$unblocked+2,$unblocked+3,$m_even # 93o

        shufb   $code,$first,$second,$m_gather          # 97o
        rotqbii $code,$code,1                           # 101o

        gbb     $code,$code                             # 105o
        br      next_chunk                              # 106o
endfunction any_spheres_r16
