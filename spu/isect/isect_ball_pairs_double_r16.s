# isect_ball_pairs_double_r16   nearest hit of packets' rays with spheres, in double precision
#   C       void isect_ball_pairs_double_r16(const struct candidate *, int count);
#   In      $3 candidates of objects that are spheres, $4 count (0 is none); pointers 16-aligned
#   Out     the candidates' packets: t, object, where a hit has 0 < t < what was there
#   Uses    $2-$78   Saves  -   Stack  0   Calls  -
#   Domain  |d| = 1 within 4 ulp; coordinates and radius below 2^60, radius above 2^-40; rounds to
#           the nearest
#   Error   0.51 ulp of the larger of t and r, origin up to 30 radii from the centre and beyond
#           1e-5 of one from the surface, ray within 0.995 r of it
#   Twin    oracle/src/twin/sphere/double.rs
#
# The steps are those of sphere_tmpl.inc: of the crossings the entry is asked for, with SIDES_EXIT the
# exit, and with SIDES_BOTH the exit of a ray from inside.
# Scheduled by spu schedule from isect_ball_pairs_double_r16.s

        .include "work_unit.inc"
        .include "macros.inc"
        .include "pairs.inc"
        .include "math.inc"
        .include "sphere_tmpl.inc"
        .include "sphere_double.inc"

        .set    a_candidate,3
        .set    count,4
        # constants
        .set    m_x,10
        .set    m_y,11
        .set    m_z,12
        .set    k_one,13
        .set    k_half,14
        .set    k_tiny,15
        .set    m_high,16
        .set    m_rows,17
        .set    m_sign,18
        .set    k_halve,19
        .set    a_controls,20
        .set    a_half,21
        .set    a_whole,22
        .set    a_by_side,23
        # the candidate
        .set    object,24
        .set    a_packet,25
        .set    quad,26
        .set    cx,27
        .set    cy,28
        .set    cz,29
        .set    radius2,30
        .set    sides,31
        .set    half,32                                 # 1/2, with the sign that the root gets
        .set    whole,33                                # 1 likewise
        .set    m_by_side,34                            # the sign's bit if a ray's side gives it
        # a row
        .set    ox,35
        .set    oy,36
        .set    oz,37
        .set    dx,38
        .set    dy,39
        .set    dz,40
        .set    t_best,41
        .set    nearest,42
        # temporaries
        .set    lx,43                                   # f, then l
        .set    ly,44
        .set    lz,45
        .set    b,46
        .set    outside,47                              # disc
        .set    disc,47
        .set    cc,48
        .set    y,49
        .set    s,50
        .set    e,51
        .set    ex,52
        .set    ey,53
        .set    ez,54
        .set    x,55
        .set    near,56
        .set    w,57
        .set    q,58
        .set    t_even,59
        .set    disc_even,60
        .set    t,61
        .set    ahead,62
        .set    control,63

        sign_controls_table
        sides_tables 0x3f000000, 0x3f800000
        double_table

function isect_ball_pairs_double_r16
        .set    dx_2,2
        .set    ox_2,5
        .set    ox_3,6
        .set    ex_2,7
        .set    lx_2,8
        .set    lx_3,9
        .set    lx_4,5
        .set    ox_4,27
        .set    lx_5,29
        .set    lx_6,6
        .set    cx_2,30
        .set    b_2,32
        .set    oy_2,33
        .set    lx_7,34
        .set    ex_3,35
        .set    b_3,37
        .set    ly_2,41
        .set    ly_3,33
        .set    ex_4,42
        .set    b_4,45
        .set    ex_5,38
        .set    ex_6,2
        .set    ey_2,39
        .set    oy_3,47
        .set    b_5,48
        .set    dy_2,49
        .set    oz_2,50
        .set    oz_3,51
        .set    dx_3,54
        .set    cz_2,26
        .set    ly_4,55
        .set    ey_3,56
        .set    lz_2,57
        .set    ex_7,58
        .set    ex_8,54
        .set    lx_8,27
        .set    lz_3,59
        .set    b_6,60
        .set    b_7,61
        .set    lz_4,30
        .set    b_8,59
        .set    ly_5,36
        .set    oz_4,62
        .set    ly_6,47
        .set    ez_2,63
        .set    lz_5,64
        .set    dz_2,65
        .set    radius2_2,66
        .set    oz_5,67
        .set    lz_6,68
        .set    lz_7,50
        .set    lz_8,51
        .set    ey_4,49
        .set    disc_2,69
        .set    dy_3,70
        .set    disc_3,71
        .set    dy_4,72
        .set    disc_4,73
        .set    dz_3,74
        .set    disc_5,75
        .set    lz_9,62
        .set    disc_6,76
        .set    oy_4,77
        .set    disc_7,78
        .set    lz_10,67
        .set    lz_11,52
        .set    lz_12,26
        .set    disc_8,53
        .set    ly_7,62
        .set    disc_9,63
        .set    ez_3,66
        .set    ey_5,67
        .set    ez_4,9
        .set    ey_6,66
        .set    ez_5,41
        .set    ly_8,74
        .set    ey_7,72
        .set    ly_9,28
        .set    x_2,9
        .set    x_3,29
        .set    x_4,36
        .set    near_2,29
        .set    near_3,9
        .set    e_2,41
        .set    ez_6,43
        .set    e_3,44
        .set    ey_8,50
        .set    ez_7,35
        .set    x_5,6
        .set    near_4,6
        .set    near_5,26
        .set    ez_8,33
        .set    e_4,34
        .set    e_5,36
        .set    y_2,39
        .set    x_6,2
        .set    y_3,5
        .set    x_7,7
        .set    near_6,2
        .set    y_4,8
        .set    near_7,27
        .set    y_5,28
        .set    y_6,30
        .set    t_best_2,33
        .set    t_best_3,35
        .set    y_7,38
        .set    near_8,7
        .set    e_6,40
        .set    nearest_2,43
        .set    t_best_4,47
        .set    t_best_5,50
        .set    nearest_3,52
        .set    e_7,54
        .set    nearest_4,55
        .set    e_8,58
        .set    y_8,62
        .set    w_2,64
        .set    e_9,65
        .set    e_10,66
        .set    w_3,67
        .set    e_11,68
        .set    e_12,70
        .set    e_13,72
        .set    w_4,28
        .set    w_5,58
        .set    e_14,64
        .set    w_6,70
        .set    e_15,74
        .set    w_7,77
        .set    w_8,8
        .set    w_9,5
        .set    e_16,30
        .set    w_10,30
        .set    e_17,38
        .set    y_9,57
        .set    s_2,58
        .set    s_3,65
        .set    s_4,66
        .set    w_11,40
        .set    w_12,49
        .set    s_5,67
        .set    y_10,40
        .set    s_6,62
        .set    w_13,38
        .set    s_7,39
        .set    s_8,64
        .set    s_9,68
        .set    s_10,5
        .set    q_2,5
        .set    s_11,36
        .set    s_12,38
        .set    q_3,28
        .set    s_13,34
        .set    q_4,34
        .set    x_8,8
        .set    q_5,38
        .set    q_6,39
        .set    x_9,40
        .set    x_10,41
        .set    x_11,30
        .set    s_14,41
        .set    q_7,41
        .set    s_15,44
        .set    x_12,54
        .set    q_8,44
        .set    x_13,57
        .set    x_14,62
        .set    x_15,51
        .set    y_11,64
        .set    y_12,65
        .set    cc_2,66
        .set    y_13,67
        .set    y_14,68
        .set    cc_3,53
        .set    cc_4,69
        .set    cc_5,70
        .set    y_15,71
        .set    e_18,57
        .set    e_19,62
        .set    t_2,71
        .set    cc_6,62
        .set    w_14,51
        .set    w_15,54
        .set    cc_7,64
        .set    y_16,54
        .set    y_17,51
        .set    t_3,74
        .set    w_16,36
        .set    cc_8,63
        .set    cc_9,67
        .set    y_18,36
        .set    e_20,73
        .set    t_4,75
        .set    t_5,76
        .set    e_21,77
        .set    t_6,65
        .set    t_7,78
        .set    t_8,73
        .set    t_9,36
        .set    disc_even_2,8
        .set    m_by_side_2,9
        .set    disc_10,26
        .set    whole_2,30
        .set    disc_even_3,2
        .set    half_2,31
        .set    s_16,31
        .set    disc_11,8
        .set    s_17,26
        .set    s_18,40
        .set    s_19,49
        .set    s_20,51
        .set    s_21,46
        .set    s_22,37
        .set    t_10,26
        .set    s_23,32
        .set    t_11,39
        .set    s_24,9
        .set    s_25,30
        .set    t_12,28
        .set    t_13,5
        .set    t_even_2,5
        .set    t_14,6
        .set    disc_12,28
        .set    t_15,30
        .set    disc_13,2
        .set    disc_even_4,27
        .set    t_16,9
        .set    control_2,29
        .set    ahead_2,30
        .set    control_3,9
        .set    ahead_3,29
        .set    control_4,2
        .set    disc_14,7
        .set    control_5,8
        .set    nearest_5,27
        .set    control_6,7
        .set    t_best_6,7
        .set    t_best_7,6
        nop     $127                                    # 0e pairing
        biz     $count,$lr                              # 0o

        ilhu    $m_x,1                                  # 1e
        lqa     $m_high,doubles                         # 1o

        ilhu    $m_y,0x405                              # 2e
        lqa     $m_rows,doubles+16                      # 2o

        ilhu    $m_z,0x809                              # 3e
        lqa     $m_sign,doubles+32                      # 3o

        iohl    $m_x,515                                # 4e
        lqa     $k_halve,doubles+48                     # 4o

        iohl    $m_y,0x607                              # 5e
        iohl    $m_z,0xa0b                              # 6e

        ila     $a_controls,sign_controls               # 7e
        ila     $a_half,half_by_sides                   # 8e

        ila     $a_whole,whole_by_sides                 # 9e
        ila     $a_by_side,m_by_sides                   # 10e

        ilhu    $k_half,0x3f00                          # 11e
        ilhu    $k_one,0x3f80                           # 12e

        ilhu    $k_tiny,896                             # 13e
        lnop                                            # 13o pairing

next_ball:
        ai      $count,$count,-1                        # 0e
        lqd     $object,0($a_candidate)                 # 0o

        ai      $a_candidate,$a_candidate,16            # 1e
        rotqbyi $a_packet,$object,4                     # 6o

        lqd     $quad,0($object)                        # 7o
        lqd     $sides,32($object)                      # 8o

        shufb   $object,$object,$object,$m_x            # 9o
        lqd     $dx,208($a_packet)                      # 10o

        lqd     $dx_2,224($a_packet)                    # 11o
        lqd     $ox,0($a_packet)                        # 12o

        lqd     $ox_2,32($a_packet)                     # 13o
        lqd     $ox_3,16($a_packet)                     # 14o

        lqd     $oy,64($a_packet)                       # 15o
        rotqbyi $ex,$dx,4                               # 16o

        rotqbyi $ex_2,$dx_2,4                           # 17o
        rotqbyi $lx,$ox,4                               # 18o

        rotqbyi $lx_2,$ox_2,0                           # 19o
        fesd    $ex,$ex                                 # 20e

        fesd    $lx,$lx                                 # 27e
        fesd    $lx_2,$lx_2                             # 34e

        fesd    $ex_2,$ex_2                             # 41e
        rotqbyi $lx_3,$ox_3,4                           # 48o

        rotqbyi $lx_4,$ox_2,4                           # 49o
        lqd     $ox_4,48($a_packet)                     # 50o

        shufb   $cy,$quad,$quad,$m_y                    # 51o
        fesd    $lx_3,$lx_3                             # 52e

        fesd    $lx_4,$lx_4                             # 59e
        fesd    $cy,$cy                                 # 66e

        rotqbyi $lx_5,$ox,0                             # 73o
        rotqbyi $ly,$oy,0                               # 74o

        rotqbyi $lx_6,$ox_3,0                           # 75o
        shufb   $cx_2,$quad,$quad,$m_x                  # 76o

        fesd    $lx_5,$lx_5                             # 77e
        fesd    $ly,$ly                                 # 84e

        fesd    $cx_2,$cx_2                             # 91e
        fesd    $lx_6,$lx_6                             # 98e

        dfs     $lx,$cx_2,$lx                           # 105e
        dfs     $lx_4,$cx_2,$lx_4                       # 112e

        dfs     $lx_6,$cx_2,$lx_6                       # 119e
        dfs     $lx_5,$cx_2,$lx_5                       # 126e

        dfs     $lx_2,$cx_2,$lx_2                       # 133e
        dfs     $lx_3,$cx_2,$lx_3                       # 140e

        dfm     $b,$lx_4,$ex_2                          # 147e
        dfs     $ly,$cy,$ly                             # 154e

        dfm     $b_2,$lx_3,$ex                          # 161e
        lqd     $oy_2,80($a_packet)                     # 168o

        lqd     $dz,336($a_packet)                      # 169o
        rotqbyi $lx_7,$ox_4,0                           # 170o

        rotqbyi $ex_3,$dx,0                             # 171o
        lqd     $dx,240($a_packet)                      # 172o

        lqd     $dy,272($a_packet)                      # 173o
        fesd    $lx_7,$lx_7                             # 174e

        fesd    $ex_3,$ex_3                             # 181e
        dfs     $lx_7,$cx_2,$lx_7                       # 188e

        dfm     $b_3,$lx_6,$ex_3                        # 195e
        rotqbyi $ly_2,$oy_2,4                           # 202o

        rotqbyi $ly_3,$oy_2,0                           # 203o
        rotqbyi $ey,$dy,4                               # 204o

        rotqbyi $ex_4,$dx,0                             # 205o
        fesd    $ly_2,$ly_2                             # 206e

        fesd    $ly_3,$ly_3                             # 213e
        dfs     $ly_2,$cy,$ly_2                         # 220e

        fesd    $ey,$ey                                 # 227e
        dfs     $ly_3,$cy,$ly_3                         # 234e

        fesd    $ex_4,$ex_4                             # 241e
        dfma    $b_2,$ly_2,$ey                          # 248e

        dfm     $b_4,$lx_7,$ex_4                        # 255e
        rotqbyi $ex_5,$dx,4                             # 262o

        rotqbyi $ex_6,$dx_2,0                           # 263o
        rotqbyi $ey_2,$dy,0                             # 264o

        lqd     $oy_3,96($a_packet)                     # 265o
        fesd    $ex_5,$ex_5                             # 266e

        fesd    $ex_6,$ex_6                             # 273e
        fesd    $ey_2,$ey_2                             # 280e

        dfm     $b_5,$lx_2,$ex_6                        # 287e
        dfma    $b_3,$ly_3,$ey_2                        # 294e

        lqd     $dy_2,288($a_packet)                    # 301o
        lqd     $oz_2,128($a_packet)                    # 302o

        lqd     $oz_3,160($a_packet)                    # 303o
        lqd     $dx_3,192($a_packet)                    # 304o

        shufb   $cz_2,$quad,$quad,$m_z                  # 305o
        rotqbyi $ly_4,$oy_3,0                           # 306o

        rotqbyi $ey_3,$dy_2,0                           # 307o
        rotqbyi $lz_2,$oz_2,0                           # 308o

        fesd    $cz_2,$cz_2                             # 309e
        fesd    $lz_2,$lz_2                             # 316e

        fesd    $ly_4,$ly_4                             # 323e
        dfs     $lz_2,$cz_2,$lz_2                       # 330e

        dfs     $ly_4,$cy,$ly_4                         # 337e
        fesd    $ey_3,$ey_3                             # 344e

        rotqbyi $ex_7,$dx_3,0                           # 351o
        rotqbyi $ex_8,$dx_3,4                           # 352o

        rotqbyi $lx_8,$ox_4,4                           # 353o
        rotqbyi $lz_3,$oz_3,0                           # 354o

        fesd    $ex_7,$ex_7                             # 355e
        fesd    $lz_3,$lz_3                             # 362e

        dfm     $b_6,$lx_5,$ex_7                        # 369e
        fesd    $ex_8,$ex_8                             # 376e

        fesd    $lx_8,$lx_8                             # 383e
        dfm     $b_7,$lx,$ex_8                          # 390e

        dfs     $lx_8,$cx_2,$lx_8                       # 397e
        dfs     $lz_4,$cz_2,$lz_3                       # 404e

        dfm     $b_8,$lx_8,$ex_5                        # 411e
        dfma    $b_5,$ly_4,$ey_3                        # 418e

        rotqbyi $ly_5,$oy,4                             # 425o
        lqd     $oz_4,176($a_packet)                    # 426o

        rotqbyi $ly_6,$oy_3,4                           # 427o
        rotqbyi $ez_2,$dz,4                             # 428o

        fesd    $ly_5,$ly_5                             # 429e
        fesd    $ly_6,$ly_6                             # 436e

        dfs     $ly_5,$cy,$ly_5                         # 443e
        dfs     $ly_6,$cy,$ly_6                         # 450e

        fesd    $ez_2,$ez_2                             # 457e
        rotqbyi $lz_5,$oz_4,4                           # 464o

        lqd     $dz_2,368($a_packet)                    # 465o
        shufb   $radius2_2,$sides,$sides,$m_x           # 466o

        lqd     $oz_5,144($a_packet)                    # 467o
        fesd    $lz_5,$lz_5                             # 468e

        fesd    $radius2_2,$radius2_2                   # 475e
        dfs     $lz_5,$cz_2,$lz_5                       # 482e

        dfm     $radius2_2,$radius2_2,$radius2_2        # 489e
        rotqbyi $lz_6,$oz_5,4                           # 496o

        rotqbyi $lz_7,$oz_2,4                           # 497o
        rotqbyi $lz_8,$oz_3,4                           # 498o

        rotqbyi $ey_4,$dy_2,4                           # 499o
        fesd    $lz_6,$lz_6                             # 500e

        fesd    $lz_8,$lz_8                             # 507e
        fesd    $ey_4,$ey_4                             # 514e

        dfs     $lz_8,$cz_2,$lz_8                       # 521e
        fesd    $lz_7,$lz_7                             # 528e

        dfma    $b,$ly_6,$ey_4                          # 535e
        dfs     $lz_6,$cz_2,$lz_6                       # 542e

        dfs     $lz_7,$cz_2,$lz_7                       # 549e
        dfma    $b_2,$lz_6,$ez_2                        # 556e

        ori     $disc_2,$radius2_2,0                    # 563e
        lqd     $dy_3,304($a_packet)                    # 563o

        ori     $disc_3,$radius2_2,0                    # 564e
        lqd     $dy_4,256($a_packet)                    # 564o

        ori     $disc_4,$radius2_2,0                    # 565e
        lqd     $dz_3,320($a_packet)                    # 565o

        ori     $disc_5,$radius2_2,0                    # 566e
        rotqbyi $lz_9,$oz_4,0                           # 566o

        ori     $disc_6,$radius2_2,0                    # 567e
        lqd     $oy_4,112($a_packet)                    # 567o

        ori     $disc_7,$radius2_2,0                    # 568e
        rotqbyi $lz_10,$oz_5,0                          # 568o

        dfnms   $lx_3,$b_2,$ex                          # 569e
        fesd    $lz_11,$lz_10                           # 576e

        fesd    $lz_9,$lz_9                             # 583e
        dfs     $lz_11,$cz_2,$lz_11                     # 590e

        dfs     $lz_12,$cz_2,$lz_9                      # 597e
        dfnms   $ly_2,$b_2,$ey                          # 604e

        ori     $disc_8,$radius2_2,0                    # 611e
        rotqbyi $ly_7,$oy_4,0                           # 611o

        dfnms   $lz_6,$b_2,$ez_2                        # 612e
        fesd    $ly_7,$ly_7                             # 619e

        ori     $disc_9,$radius2_2,0                    # 626e
        rotqbyi $ez_3,$dz_3,0                           # 626o

        rotqbyi $ey_5,$dy_4,4                           # 627o
        dfnms   $disc_9,$lx_3,$lx_3                     # 628e

        fesd    $ez_4,$ez_3                             # 635e
        fesd    $ey_6,$ey_5                             # 642e

        dfs     $ly_7,$cy,$ly_7                         # 649e
        dfma    $b_7,$ly_5,$ey_6                        # 656e

        dfnms   $disc_9,$ly_2,$ly_2                     # 663e
        rotqbyi $ez_5,$dz_3,4                           # 670o

        rotqbyi $ey_5,$dy_3,4                           # 671o
        rotqbyi $ly_8,$oy_4,4                           # 672o

        rotqbyi $ey_7,$dy_4,0                           # 673o
        fesd    $ez_5,$ez_5                             # 674e

        fesd    $ey_7,$ey_7                             # 681e
        fesd    $ly_8,$ly_8                             # 688e

        dfma    $b_6,$ly,$ey_7                          # 695e
        fesd    $ey_5,$ey_5                             # 702e

        dfma    $b_6,$lz_2,$ez_4                        # 709e
        dfma    $b_7,$lz_7,$ez_5                        # 716e

        dfs     $ly_9,$cy,$ly_8                         # 723e
        dfnms   $lx,$b_7,$ex_8                          # 730e

        dfma    $b_8,$ly_9,$ey_5                        # 737e
        dfnms   $ly_5,$b_7,$ey_6                        # 744e

        dfnms   $lz_7,$b_7,$ez_5                        # 751e
        dfnms   $lx_5,$b_6,$ex_7                        # 758e

        dfnms   $lz_2,$b_6,$ez_4                        # 765e
        dfnms   $ly,$b_6,$ey_7                          # 772e

        dfnms   $disc_5,$lx_5,$lx_5                     # 779e
        dfnms   $disc_6,$lx,$lx                         # 786e

        dfnms   $disc_5,$ly,$ly                         # 793e
        dfnms   $disc_6,$ly_5,$ly_5                     # 800e

        dfnms   $disc_5,$lz_2,$lz_2                     # 807e
        dfnms   $disc_6,$lz_7,$lz_7                     # 814e

        dfnms   $disc_9,$lz_6,$lz_6                     # 821e
        frds    $x_2,$disc_5                            # 828e

        frds    $x_3,$disc_9                            # 835e
        frds    $x_4,$disc_6                            # 842e

        fa      $near_2,$x_3,$k_tiny                    # 849e
        rotqbyi $ez,$dz,0                               # 849o

        fa      $near_3,$x_2,$k_tiny                    # 850e
        lqd     $dz,352($a_packet)                      # 850o

        ori     $e_2,$disc_6,0                          # 851e
        rotqbyi $ez_6,$dz_2,0                           # 851o

        ori     $e_3,$disc_9,0                          # 852e
        rotqbyi $ey_8,$dy_3,0                           # 852o

        fesd    $ez,$ez                                 # 853e
        fesd    $ey_8,$ey_8                             # 860e

        dfma    $b_3,$lz_11,$ez                         # 867e
        dfma    $b_4,$ly_7,$ey_8                        # 874e

        dfnms   $lx_6,$b_3,$ex_3                        # 881e
        fesd    $ez_7,$ez_6                             # 888e

        dfnms   $ly_3,$b_3,$ey_2                        # 895e
        dfma    $b_4,$lz_12,$ez_7                       # 902e

        dfnms   $disc_7,$lx_6,$lx_6                     # 909e
        dfnms   $lz_12,$b_4,$ez_7                       # 916e

        dfnms   $lx_7,$b_4,$ex_4                        # 923e
        dfnms   $disc_7,$ly_3,$ly_3                     # 930e

        dfnms   $disc_3,$lx_7,$lx_7                     # 937e
        dfnms   $lz_11,$b_3,$ez                         # 944e

        dfnms   $ly_7,$b_4,$ey_8                        # 951e
        dfnms   $disc_7,$lz_11,$lz_11                   # 958e

        dfnms   $disc_3,$ly_7,$ly_7                     # 965e
        frds    $x_5,$disc_7                            # 972e

        dfnms   $disc_3,$lz_12,$lz_12                   # 979e
        lnop                                            # 986o pairing

        fa      $near_4,$x_5,$k_tiny                    # 987e
        rotqbyi $ez,$dz,4                               # 987o

        fa      $near_5,$x_4,$k_tiny                    # 988e
        rotqbyi $ez_8,$dz,0                             # 988o

        ori     $e_4,$disc_7,0                          # 989e
        rotqbyi $ez_7,$dz_2,4                           # 989o

        ori     $e_5,$disc_5,0                          # 990e
        frsqest $y_2,$near_3                            # 990o

        fesd    $ez,$ez                                 # 991e
        fesd    $ez_8,$ez_8                             # 998e

        dfma    $b,$lz_8,$ez                            # 1005e
        dfma    $b_5,$lz_4,$ez_8                        # 1012e

        fesd    $ez_7,$ez_7                             # 1019e
        dfnms   $lx_2,$b_5,$ex_6                        # 1026e

        dfma    $b_8,$lz_5,$ez_7                        # 1033e
        dfnms   $ly_4,$b_5,$ey_3                        # 1040e

        dfnms   $lx_4,$b,$ex_2                          # 1047e
        dfnms   $lx_8,$b_8,$ex_5                        # 1054e

        dfnms   $ly_6,$b,$ey_4                          # 1061e
        dfnms   $lz_8,$b,$ez                            # 1068e

        dfnms   $disc_2,$lx_4,$lx_4                     # 1075e
        dfnms   $ly_9,$b_8,$ey_5                        # 1082e

        dfnms   $disc_2,$ly_6,$ly_6                     # 1089e
        dfnms   $disc_4,$lx_2,$lx_2                     # 1096e

        dfnms   $disc_2,$lz_8,$lz_8                     # 1103e
        dfnms   $disc_8,$lx_8,$lx_8                     # 1110e

        dfnms   $disc_4,$ly_4,$ly_4                     # 1117e
        dfnms   $disc_8,$ly_9,$ly_9                     # 1124e

        dfnms   $lz_5,$b_8,$ez_7                        # 1131e
        dfnms   $lz_4,$b_5,$ez_8                        # 1138e

        dfnms   $disc_8,$lz_5,$lz_5                     # 1145e
        dfnms   $disc_4,$lz_4,$lz_4                     # 1152e

        frds    $x,$disc_2                              # 1159e
        frds    $x_6,$disc_4                            # 1166e

        fa      $near,$x,$k_tiny                        # 1173e
        frsqest $y,$near_5                              # 1173o

        frds    $x,$disc_3                              # 1174e
        lnop                                            # 1181o pairing

        fi      $y,$near_5,$y                           # 1182e
        frsqest $y_3,$near                              # 1182o

        frds    $x_7,$disc_8                            # 1183e
        lnop                                            # 1190o pairing

        fa      $near_6,$x_6,$k_tiny                    # 1191e
        frsqest $y_4,$near_2                            # 1191o

        fa      $near_7,$x,$k_tiny                      # 1192e
        frsqest $y_5,$near_4                            # 1192o

        fi      $y_3,$near,$y_3                         # 1193e
        rotqbyi $sides,$sides,12                        # 1193o

        fi      $y_6,$near_3,$y_2                       # 1194e
        lqd     $t_best_2,400($a_packet)                # 1194o

        fi      $y_4,$near_2,$y_4                       # 1195e
        lqd     $t_best_3,432($a_packet)                # 1195o

        fi      $y_5,$near_4,$y_5                       # 1196e
        lqd     $nearest,464($a_packet)                 # 1196o

        ori     $e,$disc_4,0                            # 1197e
        frsqest $y_7,$near_6                            # 1197o

        fa      $near_8,$x_7,$k_tiny                    # 1198e
        frsqest $y_2,$near_7                            # 1198o

        fm      $e_6,$near_5,$y                         # 1199e
        lqd     $nearest_2,448($a_packet)               # 1199o

        fm      $w,$y_3,$k_half                         # 1200e
        lqd     $t_best_4,384($a_packet)                # 1200o

        fi      $y_7,$near_6,$y_7                       # 1201e
        lqd     $t_best_5,416($a_packet)                # 1201o

        fi      $y_2,$near_7,$y_2                       # 1202e
        lqd     $nearest_3,496($a_packet)               # 1202o

        ori     $e_7,$disc_3,0                          # 1203e
        lqd     $nearest_4,480($a_packet)               # 1203o

        fm      $e_8,$near_4,$y_5                       # 1204e
        frsqest $y_8,$near_8                            # 1204o

        fm      $w_2,$y_5,$k_half                       # 1205e
        fm      $e_9,$near_2,$y_4                       # 1206e

        fnms    $e_6,$e_6,$y,$k_one                     # 1207e
        fm      $e_10,$near_6,$y_7                      # 1208e

        fm      $w_3,$y_7,$k_half                       # 1209e
        fm      $e_11,$near_3,$y_6                      # 1210e

        fnms    $e_8,$e_8,$y_5,$k_one                   # 1211e
        fnms    $e_9,$e_9,$y_4,$k_one                   # 1212e

        fm      $e_12,$near,$y_3                        # 1213e
        fi      $y_8,$near_8,$y_8                       # 1214e

        ori     $e_13,$disc_8,0                         # 1215e
        fnms    $e_11,$e_11,$y_6,$k_one                 # 1216e

        fma     $w_4,$e_8,$w_2,$y_5                     # 1217e
        fm      $w_5,$y_6,$k_half                       # 1218e

        fnms    $e_14,$e_12,$y_3,$k_one                 # 1219e
        fm      $w_6,$y,$k_half                         # 1220e

        fm      $e_15,$near_8,$y_8                      # 1221e
        fm      $w_7,$y_4,$k_half                       # 1222e

        fesd    $y_5,$w_4                               # 1223e
        fma     $w_8,$e_9,$w_7,$y_4                     # 1230e

        fma     $w,$e_14,$w,$y_3                        # 1231e
        fma     $w_9,$e_11,$w_5,$y_6                    # 1232e

        fnms    $e_16,$e_10,$y_7,$k_one                 # 1233e
        fm      $e_8,$near_7,$y_2                       # 1234e

        fnms    $e_14,$e_15,$y_8,$k_one                 # 1235e
        fesd    $y_4,$w_8                               # 1236e

        fesd    $y_3,$w_9                               # 1243e
        fma     $w_10,$e_16,$w_3,$y_7                   # 1250e

        fnms    $e_17,$e_8,$y_2,$k_one                  # 1251e
        fesd    $y_9,$w                                 # 1252e

        fesd    $y_6,$w_10                              # 1259e
        dfm     $s_2,$disc_5,$y_3                       # 1266e

        dfm     $s_3,$disc_4,$y_6                       # 1273e
        dfm     $s_4,$disc_2,$y_9                       # 1280e

        dfnms   $e,$s_3,$s_3                            # 1287e
        fma     $w_11,$e_6,$w_6,$y                      # 1294e

        fm      $w_12,$y_8,$k_half                      # 1295e
        a       $y_9,$y_9,$k_halve                      # 1296e

        dfm     $s_5,$disc_7,$y_5                       # 1297e
        fesd    $y_10,$w_11                             # 1304e

        fma     $w_12,$e_14,$w_12,$y_8                  # 1311e
        dfnms   $e_4,$s_5,$s_5                          # 1312e

        dfm     $s_6,$disc_6,$y_10                      # 1319e
        fm      $w_2,$y_2,$k_half                       # 1326e

        fesd    $y,$w_12                                # 1327e
        fma     $w_13,$e_17,$w_2,$y_2                   # 1334e

        dfm     $s_7,$disc_9,$y_4                       # 1335e
        fesd    $y_7,$w_13                              # 1342e

        dfnms   $e_3,$s_7,$s_7                          # 1349e
        dfm     $s_8,$disc_8,$y                         # 1356e

        dfm     $s_9,$disc_3,$y_7                       # 1363e
        dfnms   $e_2,$s_6,$s_6                          # 1370e

        a       $y,$y,$k_halve                          # 1377e
        a       $y_6,$y_6,$k_halve                      # 1378e

        a       $y_3,$y_3,$k_halve                      # 1379e
        dfnms   $e_5,$s_2,$s_2                          # 1380e

        a       $y_4,$y_4,$k_halve                      # 1387e
        dfma    $s_3,$e,$y_6                            # 1388e

        dfma    $s_2,$e_5,$y_3                          # 1395e
        selb    $s_10,$s_3,$b_5,$m_sign                 # 1402e

        a       $y_6,$y_7,$k_halve                      # 1403e
        ori     $e,$disc_2,0                            # 1404e

        dfa     $q_2,$b_5,$s_10                         # 1405e
        dfnms   $e,$s_4,$s_4                            # 1412e

        selb    $s_11,$s_2,$b_6,$m_sign                 # 1419e
        a       $y_7,$y_10,$k_halve                     # 1420e

        dfa     $q,$b_6,$s_11                           # 1421e
        dfma    $s_4,$e,$y_9                            # 1428e

        frds    $x_4,$q                                 # 1435e
        dfma    $s_6,$e_2,$y_7                          # 1442e

        a       $y_5,$y_5,$k_halve                      # 1449e
        dfnms   $e_7,$s_9,$s_9                          # 1450e

        selb    $s_12,$s_6,$b_7,$m_sign                 # 1457e
        dfma    $s_5,$e_4,$y_5                          # 1458e

        dfa     $q_3,$b_7,$s_12                         # 1465e
        selb    $s_13,$s_5,$b_3,$m_sign                 # 1472e

        dfnms   $e_13,$s_8,$s_8                         # 1473e
        dfa     $q_4,$b_3,$s_13                         # 1480e

        dfma    $s_8,$e_13,$y                           # 1487e
        dfma    $s_7,$e_3,$y_4                          # 1494e

        fa      $x_8,$x_4,$k_tiny                       # 1501e
        frds    $x_4,$q_2                               # 1502e

        selb    $s_12,$s_7,$b_2,$m_sign                 # 1509e
        frest   $y,$x_8                                 # 1509o

        selb    $s_7,$s_4,$b,$m_sign                    # 1510e
        dfa     $q_5,$b_2,$s_12                         # 1511e

        dfa     $q_6,$b,$s_7                            # 1518e
        frds    $x_9,$q_5                               # 1525e

        frds    $x_10,$q_6                              # 1532e
        dfma    $s_9,$e_7,$y_6                          # 1539e

        fa      $x_11,$x_10,$k_tiny                     # 1546e
        selb    $s_14,$s_8,$b_8,$m_sign                 # 1547e

        fi      $y,$x_8,$y                              # 1548e
        dfa     $q_7,$b_8,$s_14                         # 1549e

        fnms    $e,$x_8,$y,$k_one                       # 1556e
        frest   $y_4,$x_11                              # 1556o

        selb    $s_15,$s_9,$b_4,$m_sign                 # 1557e
        frds    $x_12,$q_3                              # 1558e

        dfa     $q_8,$b_4,$s_15                         # 1565e
        fi      $y_4,$x_11,$y_4                         # 1572e

        frds    $x_13,$q_7                              # 1573e
        frds    $x_14,$q_8                              # 1580e

        fa      $x_12,$x_12,$k_tiny                     # 1587e
        fma     $w_12,$e,$y,$y                          # 1588e

        frds    $x_15,$q_4                              # 1589e
        lnop                                            # 1596o pairing

        fa      $x_9,$x_9,$k_tiny                       # 1597e
        frest   $y_11,$x_12                             # 1597o

        fesd    $y,$w_12                                # 1598e
        lnop                                            # 1605o pairing

        fi      $y_11,$x_12,$y_11                       # 1606e
        frest   $y_12,$x_9                              # 1606o

        ori     $cc_2,$disc_3,0                         # 1607e
        fa      $x_15,$x_15,$k_tiny                     # 1608e

        fa      $x_4,$x_4,$k_tiny                       # 1609e
        fi      $y_12,$x_9,$y_12                        # 1610e

        dfms    $cc_2,$b_4,$b_4                         # 1611e
        lnop                                            # 1618o pairing

        fnms    $e_6,$x_9,$y_12,$k_one                  # 1619e
        frest   $y_13,$x_4                              # 1619o

        fnms    $e_7,$x_12,$y_11,$k_one                 # 1620e
        frest   $y_14,$x_15                             # 1620o

        fa      $x_14,$x_14,$k_tiny                     # 1621e
        ori     $cc_3,$disc_8,0                         # 1622e

        fa      $x_13,$x_13,$k_tiny                     # 1623e
        fi      $y_13,$x_4,$y_13                        # 1624e

        ori     $cc_4,$disc_2,0                         # 1625e
        fma     $w_11,$e_6,$y_12,$y_12                  # 1626e

        fnms    $e_16,$x_11,$y_4,$k_one                 # 1627e
        frest   $y_12,$x_14                             # 1627o

        fi      $y_14,$x_15,$y_14                       # 1628e
        lnop                                            # 1628o pairing

        ori     $cc_5,$disc_5,0                         # 1629e
        frest   $y_15,$x_13                             # 1629o

        dfms    $cc_4,$b,$b                             # 1630e
        fma     $w_8,$e_16,$y_4,$y_4                    # 1637e

        dfms    $cc_5,$b_6,$b_6                         # 1638e
        fi      $y_6,$x_14,$y_12                        # 1645e

        fi      $y_12,$x_13,$y_15                       # 1646e
        fesd    $y_4,$w_8                               # 1647e

        fnms    $e_18,$x_13,$y_12,$k_one                # 1654e
        fnms    $e_5,$x_4,$y_13,$k_one                  # 1655e

        fnms    $e_19,$x_14,$y_6,$k_one                 # 1656e
        fesd    $y_10,$w_11                             # 1657e

        dfm     $t_2,$cc_4,$y_4                         # 1664e
        fma     $w_10,$e_19,$y_6,$y_6                   # 1671e

        ori     $cc_6,$disc_6,0                         # 1672e
        fnms    $e,$x_15,$y_14,$k_one                   # 1673e

        dfms    $cc_6,$b_7,$b_7                         # 1674e
        fma     $w_14,$e,$y_14,$y_14                    # 1681e

        fma     $w_15,$e_7,$y_11,$y_11                  # 1682e
        ori     $cc_7,$disc_7,0                         # 1683e

        ori     $e_11,$cc_4,0                           # 1684e
        dfms    $cc_7,$b_3,$b_3                         # 1685e

        fesd    $y_16,$w_15                             # 1692e
        fesd    $y_17,$w_14                             # 1699e

        ori     $e_13,$cc_6,0                           # 1706e
        fesd    $y_6,$w_10                              # 1707e

        dfm     $t_3,$cc_7,$y_17                        # 1714e
        fma     $w_16,$e_5,$y_13,$y_13                  # 1721e

        ori     $cc_8,$disc_9,0                         # 1722e
        ori     $cc_9,$disc_4,0                         # 1723e

        dfms    $cc_8,$b_2,$b_2                         # 1724e
        dfms    $cc_9,$b_5,$b_5                         # 1731e

        fesd    $y_18,$w_16                             # 1738e
        ori     $e_20,$cc_9,0                           # 1745e

        dfm     $t_4,$cc_8,$y_10                        # 1746e
        dfm     $t_5,$cc_9,$y_18                        # 1753e

        ori     $e_21,$cc_8,0                           # 1760e
        fma     $w,$e_18,$y_12,$y_12                    # 1761e

        dfm     $t_6,$cc_5,$y                           # 1762e
        fesd    $y_9,$w                                 # 1769e

        dfm     $t_7,$cc_6,$y_16                        # 1776e
        dfnms   $e_21,$q_5,$t_4                         # 1783e

        dfnms   $e_20,$q_2,$t_5                         # 1790e
        dfma    $t_4,$e_21,$y_10                        # 1797e

        dfnms   $e_11,$q_6,$t_2                         # 1804e
        dfma    $t_5,$e_20,$y_18                        # 1811e

        dfms    $cc_3,$b_8,$b_8                         # 1818e
        ori     $e_5,$cc_7,0                            # 1825e

        ori     $e_6,$cc_2,0                            # 1826e
        dfnms   $e_5,$q_4,$t_3                          # 1827e

        dfm     $t_8,$cc_3,$y_9                         # 1834e
        ori     $e_21,$cc_3,0                           # 1841e

        dfma    $t_3,$e_5,$y_17                         # 1842e
        dfnms   $e_13,$q_3,$t_7                         # 1849e

        ori     $e,$cc_5,0                              # 1856e
        rotmi   $sides,$sides,-26                       # 1857e

        dfnms   $e,$q,$t_6                              # 1858e
        dfma    $t_7,$e_13,$y_16                        # 1865e

        dfm     $t_9,$cc_2,$y_6                         # 1872e
        dfma    $t_6,$e,$y                              # 1879e

        dfnms   $e_6,$q_8,$t_9                          # 1886e
        dfma    $t_2,$e_11,$y_4                         # 1893e

        dfma    $t_9,$e_6,$y_6                          # 1900e
        lnop                                            # 1907o pairing

        ori     $disc_even_2,$near_3,0                  # 1908e
        lqx     $m_by_side_2,$a_by_side,$sides          # 1908o

        ori     $disc_10,$near_5,0                      # 1909e
        lqx     $whole_2,$a_whole,$sides                # 1909o

        ori     $disc_even_3,$near_6,0                  # 1910e
        lqx     $half_2,$a_half,$sides                  # 1910o

        dfnms   $e_21,$q_7,$t_8                         # 1911e
        lnop                                            # 1918o pairing

        selb    $s_16,$whole_2,$cc_9,$m_by_side_2       # 1919e
        shufb   $disc_11,$disc_even_2,$disc_10,$m_rows  # 1919o

        selb    $s_17,$whole_2,$cc_4,$m_by_side_2       # 1920e
        selb    $s_18,$whole_2,$cc_5,$m_by_side_2       # 1921e

        selb    $s_19,$whole_2,$cc_3,$m_by_side_2       # 1922e
        xor     $s_18,$s_18,$b_6                        # 1923e

        selb    $s_20,$whole_2,$cc_8,$m_by_side_2       # 1924e
        xor     $s_17,$s_17,$b                          # 1925e

        selb    $s_21,$whole_2,$cc_7,$m_by_side_2       # 1926e
        rotmai  $s_17,$s_17,-31                         # 1927e

        xor     $s_22,$s_21,$b_3                        # 1928e
        rotmai  $s_18,$s_18,-31                         # 1929e

        rotmai  $s_22,$s_22,-31                         # 1930e
        lnop                                            # 1930o pairing

        xor     $s_21,$s_19,$b_8                        # 1931e
        shufb   $s_17,$s_17,$s_17,$m_high               # 1931o

        dfma    $t_8,$e_21,$y_9                         # 1932e
        lnop                                            # 1939o pairing

        selb    $t_10,$t_2,$q_6,$s_17                   # 1940e
        shufb   $s_7,$s_18,$s_18,$m_high                # 1940o

        xor     $s_23,$s_20,$b_2                        # 1941e
        shufb   $s_22,$s_22,$s_22,$m_high               # 1941o

        xor     $s_16,$s_16,$b_5                        # 1942e
        rotmai  $s_23,$s_23,-31                         # 1943e

        selb    $t_11,$t_6,$q,$s_7                      # 1944e
        selb    $s_18,$whole_2,$cc_6,$m_by_side_2       # 1945e

        frds    $t_even,$t_11                           # 1946e
        lnop                                            # 1953o pairing

        xor     $s_7,$s_18,$b_7                         # 1954e
        shufb   $s_23,$s_23,$s_23,$m_high               # 1954o

        rotmai  $s_16,$s_16,-31                         # 1955e
        rotmai  $s_7,$s_7,-31                           # 1956e

        frds    $t,$t_10                                # 1957e
        lnop                                            # 1964o pairing

        selb    $t_10,$t_4,$q_5,$s_23                   # 1965e
        shufb   $s_23,$s_7,$s_7,$m_high                 # 1965o

        selb    $s_24,$whole_2,$cc_2,$m_by_side_2       # 1966e
        shufb   $s_25,$s_16,$s_16,$m_high               # 1966o

        frds    $t_10,$t_10                             # 1967e
        xor     $s_24,$s_24,$b_4                        # 1974e

        selb    $t_12,$t_7,$q_3,$s_23                   # 1975e
        selb    $t_13,$t_5,$q_2,$s_25                   # 1976e

        frds    $t_12,$t_12                             # 1977e
        frds    $t_even_2,$t_13                         # 1984e

        ori     $disc_even,$near_4,0                    # 1991e
        shufb   $t_14,$t_even,$t_12,$m_rows             # 1991o

        ori     $disc_12,$near,0                        # 1992e
        rotmai  $s_24,$s_24,-31                         # 1993e

        selb    $t_15,$t_3,$q_4,$s_22                   # 1994e
        shufb   $disc_13,$disc_even_3,$disc_12,$m_rows  # 1994o

        cgt     $control,$t_best_4,$t_14                # 1995e
        frds    $t_even,$t_15                           # 1996e

        cgti    $ahead,$t_14,0                          # 2003e
        shufb   $s_24,$s_24,$s_24,$m_high               # 2003o

        ori     $disc_even_4,$near_7,0                  # 2004e
        shufb   $t,$t_even_2,$t,$m_rows                 # 2004o

        rotmai  $s_10,$s_21,-31                         # 2005e
        ori     $disc_12,$near_2,0                      # 2006e

        selb    $t_16,$t_9,$q_8,$s_24                   # 2007e
        lnop                                            # 2007o pairing

        cgt     $control_2,$t_best_5,$t                 # 2008e
        shufb   $disc_12,$disc_even,$disc_12,$m_rows    # 2008o

        cgti    $ahead_2,$t,0                           # 2009e
        shufb   $t_10,$t_even,$t_10,$m_rows             # 2009o

        frds    $t_even,$t_16                           # 2010e
        lnop                                            # 2017o pairing

        and     $control_3,$control_2,$ahead_2          # 2018e
        shufb   $s_10,$s_10,$s_10,$m_high               # 2018o

        cgti    $ahead_3,$t_10,0                        # 2019e
        andc    $control_4,$control_3,$disc_13          # 2020e

        cgt     $control_3,$t_best_2,$t_10              # 2021e
        lnop                                            # 2021o pairing

        selb    $t_13,$t_8,$q_7,$s_10                   # 2022e
        rotqbii $control_4,$control_4,1                 # 2022o

        and     $control_3,$control_3,$ahead_3          # 2023e
        frds    $t_13,$t_13                             # 2024e

        andc    $control_3,$control_3,$disc_12          # 2031e
        gb      $control_4,$control_4                   # 2031o

        and     $control,$control,$ahead                # 2032e
        lnop                                            # 2032o pairing

        ori     $disc_14,$near_8,0                      # 2033e
        rotqbii $control_3,$control_3,1                 # 2033o

        andc    $control,$control,$disc_11              # 2034e
        shlqbii $control_4,$control_4,4                 # 2035o

        rotqbii $control,$control,1                     # 2036o
        gb      $control_5,$control_3                   # 2037o

        shufb   $t_13,$t_even,$t_13,$m_rows             # 2038o
        lqx     $control_4,$control_4,$a_controls       # 2039o

        gb      $control,$control                       # 2040o
        shlqbii $control_5,$control_5,4                 # 2041o

        cgti    $ahead,$t_13,0                          # 2042e
        shufb   $disc_14,$disc_even_4,$disc_14,$m_rows  # 2042o

        cgt     $control_3,$t_best_3,$t_13              # 2043e
        shlqbii $control,$control,4                     # 2044o

        and     $control_3,$control_3,$ahead            # 2045e
        lqx     $control_5,$control_5,$a_controls       # 2045o

        nop     $127                                    # 2046e pairing
        shufb   $nearest_5,$nearest_4,$object,$control_4 # 2046o

        andc    $control_6,$control_3,$disc_14          # 2047e
        shufb   $t_best,$t_best_5,$t,$control_4         # 2047o

        lqx     $control,$control,$a_controls           # 2048o
        rotqbii $control_4,$control_6,1                 # 2049o

        stqd    $nearest_5,480($a_packet)               # 2050o
        shufb   $nearest,$nearest,$object,$control_5    # 2051o

        shufb   $t_best_6,$t_best_2,$t_10,$control_5    # 2052o
        gb      $control_4,$control_4                   # 2053o

        shufb   $t_best_7,$t_best_4,$t_14,$control      # 2054o
        stqd    $nearest,464($a_packet)                 # 2055o

        stqd    $t_best_6,400($a_packet)                # 2056o
        shufb   $nearest,$nearest_2,$object,$control    # 2057o

        stqd    $t_best_7,384($a_packet)                # 2058o
        stqd    $t_best,416($a_packet)                  # 2059o

        shlqbii $control,$control_4,4                   # 2060o
        stqd    $nearest,448($a_packet)                 # 2061o

        hbrr    next_ball_back,next_ball                # 2062o hint
        lqx     $control,$control,$a_controls           # 2064o

        shufb   $t_best,$t_best_3,$t_13,$control        # 2070o
        shufb   $nearest,$nearest_3,$object,$control    # 2071o

        stqd    $t_best,432($a_packet)                  # 2074o
        stqd    $nearest,496($a_packet)                 # 2075o

        nop     $127                                    # 2076e pairing
next_ball_back:
        brnz    $count,next_ball                        # 2076o

        nop     $127                                    # 2077e pairing
        bi      $lr                                     # 2077o
endfunction isect_ball_pairs_double_r16
