# isect_ball_pairs_double_r16   nearest hit of packets' rays with spheres, in double precision
#   C       void isect_ball_pairs_double_r16(const struct candidate *, int count);
#   In      $3 candidates of objects that are spheres, $4 count (0 is none); pointers 16-aligned
#   Out     the candidates' packets: t, object, where a hit has 0 < t < what was there
#   Uses    $2-$69   Saves  -   Stack  0   Calls  -
#   Domain  |d| = 1 within 4 ulp; coordinates and radius below 2^60, radius above 2^-40; rounds to
#           the nearest
#   Error   0.51 ulp of the larger of t and r, origin up to 30 radii from the centre and beyond
#           1e-5 of one from the surface, ray within 0.995 r of it
#   Twin    lab/twins/src/sphere/double.rs
#
# The steps are those of sphere_tmpl.inc: of the crossings the entry is asked for, with SIDES_EXIT the
# exit, and with SIDES_BOTH the exit of a ray from inside.
# Scheduled by spu schedule from isect_ball_pairs_double_r16.s

        .include "sphere_general.inc"
        .include "sphere_double.inc"

        general_registers "k_one,k_half,k_tiny,m_high,m_rows,m_sign,k_halve,k_half_double", "radius2", "cc,y,s,e,ex,ey,ez,x,near,w,q,t_even,disc_even"
        sign_controls_table
        sides_tables 0x3f000000, 0x3f800000
        double_table

function isect_ball_pairs_double_r16
        .set    b1_2,2
        .set    b1_3,5
        .set    b1_4,6
        .set    b1_5,7
        .set    b1_6,8
        .set    b1_7,9
        .set    b1_8,27
        .set    nearest1_2,31
        .set    nearest2_2,32
        .set    nearest3_2,33
        .set    ex_2,36
        .set    e_2,32
        .set    ox_2,33
        .set    e_3,36
        .set    b_2,36
        .set    s_2,48
        .set    nearest2_3,56
        .set    nearest3_3,50
        .set    x_2,47
        .set    x_3,31
        .set    y_2,45
        .set    cc_2,46
        .set    nearest2_4,48
        .set    e_4,47
        .set    nearest1_3,33
        .set    nearest2_5,31
        .set    nearest2_6,37
        .set    nearest3_4,38
        .set    ex_3,39
        .set    b1_9,56
        .set    ey_2,40
        .set    ez_2,41
        .set    y_3,58
        .set    e_5,57
        .set    t_best_2,60
        .set    w_2,61
        .set    nearest_2,62
        .set    ox_3,63
        .set    t_2,49
        .set    w_3,45
        .set    oy_2,57
        .set    y_4,32
        .set    t_3,45
        .set    oz_2,49
        .set    t_even_2,45
        .set    y_5,2
        .set    dx_2,32
        .set    b_3,58
        .set    dy_2,2
        .set    x_4,36
        .set    dz_2,51
        .set    x_5,33
        .set    cc_3,37
        .set    nearest1_4,53
        .set    nearest2_7,54
        .set    nearest3_5,55
        .set    near_2,33
        .set    ex_4,61
        .set    w_4,36
        .set    e_6,64
        .set    ey_3,65
        .set    s_3,66
        .set    ez_3,67
        .set    disc_even_2,68
        .set    nearest1_5,63
        .set    nearest2_8,57
        .set    nearest3_6,49
        .set    y_6,36
        .set    e_7,33
        .set    ex_5,32
        .set    w_5,69
        .set    ey_4,2
        .set    ez_4,51
        .set    t_4,46
        .set    w_6,33
        .set    t_best_3,50
        .set    y_7,33
        .set    t_5,36
        .set    nearest_3,46
        .set    s_4,5
        .set    ahead_2,45
        .set    ox_4,47
        .set    control_2,48
        .set    oy_3,59
        .set    control_3,45
        .set    oz_3,48
        .set    b_4,69
        .set    dx_3,56
        .set    control_4,33
        .set    nearest1_6,45
        .set    q_2,5
        .set    x_6,52
        .set    e_8,39
        .set    e_9,38
        .set    cc_4,39
        .set    y_8,40
        .set    near_3,31
        .set    s_5,33
        .set    b1_10,40
        .set    dy_3,41
        .set    dz_3,42
        .set    nearest3_7,43
        .set    y_9,53
        .set    nearest1_7,54
        .set    t_6,37
        .set    e_10,31
        .set    nearest2_9,55
        .set    nearest3_8,68
        .set    ez_5,31
        .set    t_7,5
        .set    ey_5,36
        .set    y_10,37
        .set    t_even_3,5
        .set    s_6,6
        .set    ez_6,58
        .set    b_5,64
        .set    nearest1_8,37
        .set    nearest1_9,38
        .set    q_3,6
        .set    nearest2_10,59
        .set    e_11,61
        .set    y_11,43
        .set    cc_5,45
        .set    nearest3_9,48
        .set    ex_6,56
        .set    ey_6,41
        .set    ez_7,42
        .set    w_7,43
        .set    y_12,47
        .set    t_best_4,63
        .set    s_7,65
        .set    nearest_4,66
        .set    disc_even_3,67
        .set    t_8,39
        .set    w_8,31
        .set    y_13,31
        .set    t_9,6
        .set    s_8,7
        .set    ez_8,6
        .set    ahead_3,33
        .set    control_5,39
        .set    control_6,7
        .set    q_4,33
        .set    x_7,38
        .set    x_8,2
        .set    y_14,6
        .set    nearest2_11,7
        .set    t_best_5,5
        .set    nearest2_12,2
        .set    w_9,6
        .set    e_12,5
        .set    y_15,7
        .set    b1_11,31
        .set    nearest3_10,32
        .set    w_10,39
        .set    b_6,8
        .set    nearest1_10,7
        .set    cc_6,28
        .set    e_13,7
        .set    s_9,29
        .set    nearest3_11,36
        .set    nearest3_12,30
        .set    ahead_4,5
        .set    x_9,5
        .set    e_14,6
        .set    s_10,2
        .set    e_15,2
        .set    ahead_5,2
        nop     $127                                    # 0e pairing
        biz     $count,$lr                              # 0o

        ilhu    $m_x,1                                  # 1e
        lqa     $k_tiny+1,doubles                       # 1o

        ilhu    $m_y,0x405                              # 2e
        lqa     $m_rows,doubles+16                      # 2o

        ilhu    $m_z,0x809                              # 3e
        lqa     $m_sign,doubles+32                      # 3o

        iohl    $m_x,515                                # 4e
        lqa     $k_halve,doubles+48                     # 4o

        iohl    $m_y,0x607                              # 5e
        lqa     $k_half_double,doubles+64               # 5o

        iohl    $m_z,0xa0b                              # 6e
        ila     $a_controls,sign_controls               # 7e

        ila     $a_half,half_by_sides                   # 8e
        ila     $a_whole,whole_by_sides                 # 9e

        ila     $a_by_side,m_by_sides                   # 10e
        ilhu    $k_half,0x3f00                          # 11e

        ilhu    $k_one,0x3f80                           # 12e
        ilhu    $k_tiny,896                             # 13e

next_ball:
        ai      $count,$count,-1                        # 0e
        lqd     $object,0($a_candidate)                 # 0o

        ai      $a_candidate,$a_candidate,16            # 1e
        rotqbyi $a_packet,$object,4                     # 6o

        lqd     $quad,0($object)                        # 7o
        lqd     $sides,32($object)                      # 8o

        shufb   $object,$object,$object,$m_x            # 9o
        lqd     $ox,0($a_packet)                        # 10o

        lqd     $oy,64($a_packet)                       # 11o
        lqd     $oz,128($a_packet)                      # 12o

        shufb   $cx,$quad,$quad,$m_x                    # 13o
        shufb   $cy,$quad,$quad,$m_y                    # 14o

        shufb   $cz,$quad,$quad,$m_z                    # 15o
        shufb   $radius2,$sides,$sides,$m_x             # 16o

        fesd    $cx,$cx                                 # 17e
        fesd    $cy,$cy                                 # 24e

        fesd    $cz,$cz                                 # 31e
        fesd    $radius2,$radius2                       # 38e

        rotqbyi $sides,$sides,12                        # 45o
        lqd     $dx,192($a_packet)                      # 46o

        lqd     $dy,256($a_packet)                      # 47o
        lqd     $dz,320($a_packet)                      # 48o

        rotmi   $sides,$sides,-26                       # 49e
        rotqbyi $nearest+1,$ox,0                        # 49o

        rotqbyi $nearest+2,$oy,0                        # 50o
        dfm     $radius2,$radius2,$radius2              # 51e

        fesd    $nearest+1,$nearest+1                   # 58e
        fesd    $nearest+2,$nearest+2                   # 65e

        dfs     $nearest+1,$cx,$nearest+1               # 72e
        dfs     $nearest+2,$cy,$nearest+2               # 79e

        ori     $b+1,$radius2,0                         # 86e
        lqx     $half,$a_half,$sides                    # 86o

        ori     $b1_2,$radius2,0                        # 87e
        lqx     $whole,$a_whole,$sides                  # 87o

        ori     $b1_3,$radius2,0                        # 88e
        lqx     $m_by_side,$a_by_side,$sides            # 88o

        ori     $b1_4,$radius2,0                        # 89e
        rotqbyi $nearest+3,$oz,0                        # 89o

        ori     $b1_5,$radius2,0                        # 90e
        rotqbyi $ex,$dx,0                               # 90o

        ori     $b1_6,$radius2,0                        # 91e
        rotqbyi $ey,$dy,0                               # 91o

        ori     $b1_7,$radius2,0                        # 92e
        rotqbyi $ez,$dz,0                               # 92o

        fesd    $nearest+3,$nearest+3                   # 93e
        fesd    $ex,$ex                                 # 100e

        dfs     $nearest+3,$cz,$nearest+3               # 107e
        fesd    $ey,$ey                                 # 114e

        fesd    $ez,$ez                                 # 121e
        dfm     $b,$nearest+1,$ex                       # 128e

        ori     $b1_8,$radius2,0                        # 135e
        rotqbyi $nearest1_2,$ox,4                       # 135o

        rotqbyi $nearest2_2,$oy,4                       # 136o
        rotqbyi $nearest3_2,$oz,4                       # 137o

        rotqbyi $ex_2,$dx,4                             # 138o
        fesd    $nearest1_2,$nearest1_2                 # 139e

        dfma    $b,$nearest+2,$ey                       # 146e
        dfs     $nearest1_2,$cx,$nearest1_2             # 153e

        dfma    $b,$nearest+3,$ez                       # 160e
        fesd    $nearest2_2,$nearest2_2                 # 167e

        dfnms   $nearest+1,$b,$ex                       # 174e
        dfnms   $nearest+2,$b,$ey                       # 181e

        dfnms   $nearest+3,$b,$ez                       # 188e
        dfm     $e,$nearest+1,$ex                       # 195e

        dfnms   $b+1,$nearest+1,$nearest+1              # 202e
        dfma    $e,$nearest+2,$ey                       # 209e

        dfnms   $b+1,$nearest+2,$nearest+2              # 216e
        dfma    $e,$nearest+3,$ez                       # 223e

        dfnms   $b+1,$nearest+3,$nearest+3              # 230e
        dfma    $b,$e,$k_half_double                    # 237e

        dfma    $b+1,$e,$e                              # 244e
        dfs     $nearest+2,$cy,$nearest2_2              # 251e

        frds    $x,$b+1                                 # 258e
        lnop                                            # 265o pairing

        ori     $e,$b+1,0                               # 266e
        rotqbyi $ey,$dy,4                               # 266o

        ori     $cc,$b+1,0                              # 267e
        rotqbyi $ez,$dz,4                               # 267o

        fesd    $nearest+3,$nearest3_2                  # 268e
        lnop                                            # 275o pairing

        fa      $near,$x,$k_tiny                        # 276e
        lqd     $t_best,384($a_packet)                  # 276o

        dfms    $cc,$b,$b                               # 277e
        lnop                                            # 284o pairing

        ori     $disc_even,$near,0                      # 285e
        frsqest $y,$near                                # 285o

        dfs     $nearest+3,$cz,$nearest+3               # 286e
        lnop                                            # 293o pairing

        fi      $y,$near,$y                             # 294e
        lqd     $nearest,448($a_packet)                 # 294o

        ori     $e_2,$cc,0                              # 295e
        lqd     $ox_2,16($a_packet)                     # 295o

        selb    $s,$whole,$cc,$m_by_side                # 296e
        lqd     $oy,80($a_packet)                       # 296o

        fesd    $ex,$ex_2                               # 297e
        lnop                                            # 304o pairing

        fm      $e_3,$near,$y                           # 305e
        lqd     $oz,144($a_packet)                      # 305o

        fm      $w,$y,$k_half                           # 306e
        lqd     $dx,208($a_packet)                      # 306o

        xor     $s,$s,$b                                # 307e
        lqd     $dy,272($a_packet)                      # 307o

        fesd    $ey,$ey                                 # 308e
        lnop                                            # 315o pairing

        fnms    $e_3,$e_3,$y,$k_one                     # 316e
        lqd     $dz,336($a_packet)                      # 316o

        rotmai  $s,$s,-31                               # 317e
        rotqbyi $nearest+1,$ox_2,0                      # 317o

        fesd    $ez,$ez                                 # 318e
        lnop                                            # 325o pairing

        fma     $w,$e_3,$w,$y                           # 326e
        shufb   $s,$s,$s,$k_tiny+1                      # 326o

        dfm     $b_2,$nearest1_2,$ex                    # 327e
        fesd    $y,$w                                   # 334e

        dfma    $b_2,$nearest+2,$ey                     # 341e
        dfm     $s_2,$b+1,$y                            # 348e

        a       $y,$y,$k_halve                          # 355e
        rotqbyi $nearest2_3,$oy,0                       # 355o

        dfma    $b_2,$nearest+3,$ez                     # 356e
        dfnms   $e,$s_2,$s_2                            # 363e

        dfnms   $nearest1_2,$b_2,$ex                    # 370e
        dfma    $s_2,$e,$y                              # 377e

        dfnms   $nearest+2,$b_2,$ey                     # 384e
        lnop                                            # 391o pairing

        selb    $s_2,$s_2,$b,$m_sign                    # 392e
        rotqbyi $nearest3_3,$oz,0                       # 392o

        dfnms   $nearest+3,$b_2,$ez                     # 393e
        dfa     $q,$b,$s_2                              # 400e

        dfm     $e,$nearest1_2,$ex                      # 407e
        frds    $x_2,$q                                 # 414e

        dfma    $e,$nearest+2,$ey                       # 421e
        lnop                                            # 428o pairing

        fa      $x_2,$x_2,$k_tiny                       # 429e
        rotqbyi $ex,$dx,0                               # 429o

        dfnms   $b1_2,$nearest1_2,$nearest1_2           # 430e
        dfma    $e,$nearest+3,$ez                       # 437e

        dfnms   $b1_2,$nearest+2,$nearest+2             # 444e
        dfma    $b_2,$e,$k_half_double                  # 451e

        dfnms   $b1_2,$nearest+3,$nearest+3             # 458e
        fesd    $nearest+1,$nearest+1                   # 465e

        dfma    $b1_2,$e,$e                             # 472e
        dfs     $nearest+1,$cx,$nearest+1               # 479e

        frds    $x_3,$b1_2                              # 486e
        lnop                                            # 493o pairing

        ori     $e,$b1_2,0                              # 494e
        frest   $y_2,$x_2                               # 494o

        ori     $cc_2,$b1_2,0                           # 495e
        rotqbyi $ey,$dy,0                               # 495o

        fesd    $nearest2_4,$nearest2_3                 # 496e
        lnop                                            # 503o pairing

        fi      $y_2,$x_2,$y_2                          # 504e
        rotqbyi $ez,$dz,0                               # 504o

        dfms    $cc_2,$b_2,$b_2                         # 505e
        lnop                                            # 512o pairing

        fnms    $e_4,$x_2,$y_2,$k_one                   # 513e
        rotqbyi $nearest1_3,$ox_2,4                     # 513o

        fa      $near,$x_3,$k_tiny                      # 514e
        rotqbyi $nearest2_5,$oy,4                       # 514o

        dfs     $nearest2_6,$cy,$nearest2_4             # 515e
        lnop                                            # 522o pairing

        fma     $w,$e_4,$y_2,$y_2                       # 523e
        frsqest $y_2,$near                              # 523o

        ori     $e_4,$cc_2,0                            # 524e
        rotqbyi $nearest3_4,$oz,4                       # 524o

        selb    $s_2,$whole,$cc_2,$m_by_side            # 525e
        rotqbyi $ex_3,$dx,4                             # 525o

        ori     $b1_9,$near,0                           # 526e
        rotqbyi $ey_2,$dy,4                             # 526o

        fi      $y_2,$near,$y_2                         # 527e
        rotqbyi $ez_2,$dz,4                             # 527o

        xor     $s_2,$s_2,$b_2                          # 528e
        shufb   $b1_9,$disc_even,$b1_9,$m_rows          # 528o

        fesd    $y_3,$w                                 # 529e
        lnop                                            # 536o pairing

        fm      $e_5,$near,$y_2                         # 537e
        lqd     $t_best_2,400($a_packet)                # 537o

        fm      $w_2,$y_2,$k_half                       # 538e
        lqd     $nearest_2,464($a_packet)               # 538o

        rotmai  $s_2,$s_2,-31                           # 539e
        lqd     $ox_3,32($a_packet)                     # 539o

        fesd    $nearest3_3,$nearest3_3                 # 540e
        dfm     $t_2,$cc,$y_3                           # 547e

        fnms    $e_5,$e_5,$y_2,$k_one                   # 554e
        shufb   $s_2,$s_2,$s_2,$k_tiny+1                # 554o

        dfs     $nearest3_3,$cz,$nearest3_3             # 555e
        dfnms   $e_2,$q,$t_2                            # 562e

        fma     $w_3,$e_5,$w_2,$y_2                     # 569e
        lqd     $oy_2,96($a_packet)                     # 569o

        fesd    $ex,$ex                                 # 570e
        dfma    $t_2,$e_2,$y_3                          # 577e

        fesd    $y_4,$w_3                               # 584e
        lnop                                            # 591o pairing

        selb    $t_3,$t_2,$q,$s                         # 592e
        lqd     $oz_2,160($a_packet)                    # 592o

        fesd    $ey,$ey                                 # 593e
        frds    $t_even_2,$t_3                          # 600e

        dfm     $s,$b1_2,$y_4                           # 607e
        lnop                                            # 614o pairing

        a       $y_5,$y_4,$k_halve                      # 615e
        lqd     $dx_2,224($a_packet)                    # 615o

        fesd    $ez,$ez                                 # 616e
        dfnms   $e,$s,$s                                # 623e

        dfm     $b_3,$nearest+1,$ex                     # 630e
        dfma    $s,$e,$y_5                              # 637e

        dfma    $b_3,$nearest2_6,$ey                    # 644e
        lnop                                            # 651o pairing

        selb    $s,$s,$b_2,$m_sign                      # 652e
        lqd     $dy_2,288($a_packet)                    # 652o

        fesd    $nearest1_3,$nearest1_3                 # 653e
        dfa     $q,$b_2,$s                              # 660e

        dfma    $b_3,$nearest3_3,$ez                    # 667e
        frds    $x_4,$q                                 # 674e

        dfnms   $nearest+1,$b_3,$ex                     # 681e
        lnop                                            # 688o pairing

        fa      $x_4,$x_4,$k_tiny                       # 689e
        lqd     $dz_2,352($a_packet)                    # 689o

        dfnms   $nearest2_6,$b_3,$ey                    # 690e
        dfnms   $nearest3_3,$b_3,$ez                    # 697e

        dfm     $e,$nearest+1,$ex                       # 704e
        dfnms   $b1_3,$nearest+1,$nearest+1             # 711e

        dfma    $e,$nearest2_6,$ey                      # 718e
        dfnms   $b1_3,$nearest2_6,$nearest2_6           # 725e

        dfma    $e,$nearest3_3,$ez                      # 732e
        dfnms   $b1_3,$nearest3_3,$nearest3_3           # 739e

        dfma    $b_3,$e,$k_half_double                  # 746e
        dfma    $b1_3,$e,$e                             # 753e

        dfs     $nearest+1,$cx,$nearest1_3              # 760e
        frds    $x_5,$b1_3                              # 767e

        ori     $e,$b1_3,0                              # 774e
        frest   $y,$x_4                                 # 774o

        ori     $cc_3,$b1_3,0                           # 775e
        rotqbyi $nearest1_4,$ox_3,0                     # 775o

        fesd    $nearest2_5,$nearest2_5                 # 776e
        lnop                                            # 783o pairing

        fi      $y,$x_4,$y                              # 784e
        rotqbyi $nearest2_7,$oy_2,0                     # 784o

        dfms    $cc_3,$b_3,$b_3                         # 785e
        lnop                                            # 792o pairing

        fnms    $e_3,$x_4,$y,$k_one                     # 793e
        rotqbyi $nearest3_5,$oz_2,0                     # 793o

        fa      $near_2,$x_5,$k_tiny                    # 794e
        rotqbyi $ex_4,$dx_2,0                           # 794o

        dfs     $nearest2_5,$cy,$nearest2_5             # 795e
        lnop                                            # 802o pairing

        fma     $w_4,$e_3,$y,$y                         # 803e
        frsqest $y,$near_2                              # 803o

        ori     $e_6,$cc_3,0                            # 804e
        rotqbyi $ey_3,$dy_2,0                           # 804o

        selb    $s_3,$whole,$cc_3,$m_by_side            # 805e
        rotqbyi $ez_3,$dz_2,0                           # 805o

        ori     $disc_even_2,$near_2,0                  # 806e
        rotqbyi $nearest1_5,$ox_3,4                     # 806o

        fi      $y,$near_2,$y                           # 807e
        rotqbyi $nearest2_8,$oy_2,4                     # 807o

        xor     $s_3,$s_3,$b_3                          # 808e
        rotqbyi $nearest3_6,$oz_2,4                     # 808o

        fesd    $y_6,$w_4                               # 809e
        lnop                                            # 816o pairing

        fm      $e_7,$near_2,$y                         # 817e
        rotqbyi $ex_5,$dx_2,4                           # 817o

        fm      $w_5,$y,$k_half                         # 818e
        rotqbyi $ey_4,$dy_2,4                           # 818o

        rotmai  $s_3,$s_3,-31                           # 819e
        rotqbyi $ez_4,$dz_2,4                           # 819o

        fesd    $nearest3_4,$nearest3_4                 # 820e
        dfm     $t_4,$cc_2,$y_6                         # 827e

        fnms    $e_7,$e_7,$y,$k_one                     # 834e
        shufb   $s_3,$s_3,$s_3,$k_tiny+1                # 834o

        dfs     $nearest3_4,$cz,$nearest3_4             # 835e
        dfnms   $e_4,$q,$t_4                            # 842e

        fma     $w_6,$e_7,$w_5,$y                       # 849e
        lqd     $t_best_3,416($a_packet)                # 849o

        fesd    $ex_3,$ex_3                             # 850e
        dfma    $t_4,$e_4,$y_6                          # 857e

        fesd    $y_7,$w_6                               # 864e
        lnop                                            # 871o pairing

        selb    $t_5,$t_4,$q,$s_2                       # 872e
        lqd     $nearest_3,480($a_packet)               # 872o

        fesd    $ey_2,$ey_2                             # 873e
        frds    $t_5,$t_5                               # 880e

        dfm     $s_4,$b1_3,$y_7                         # 887e
        lnop                                            # 894o pairing

        a       $y_7,$y_7,$k_halve                      # 895e
        shufb   $t_5,$t_even_2,$t_5,$m_rows             # 895o

        fesd    $ez_2,$ez_2                             # 896e
        lnop                                            # 903o pairing

        cgti    $ahead_2,$t_5,0                         # 904e
        lqd     $ox_4,48($a_packet)                     # 904o

        cgt     $control_2,$t_best,$t_5                 # 905e
        lqd     $oy_3,112($a_packet)                    # 905o

        dfnms   $e,$s_4,$s_4                            # 906e
        lnop                                            # 913o pairing

        and     $control_3,$control_2,$ahead_2          # 914e
        lqd     $oz_3,176($a_packet)                    # 914o

        dfm     $b_4,$nearest+1,$ex_3                   # 915e
        lnop                                            # 922o pairing

        andc    $control_3,$control_3,$b1_9             # 923e
        lqd     $dx_3,240($a_packet)                    # 923o

        dfma    $s_4,$e,$y_7                            # 924e
        dfma    $b_4,$nearest2_5,$ey_2                  # 931e

        selb    $s_4,$s_4,$b_3,$m_sign                  # 938e
        rotqbii $control_4,$control_3,1                 # 938o

        fesd    $nearest1_6,$nearest1_4                 # 939e
        dfa     $q_2,$b_3,$s_4                          # 946e

        dfma    $b_4,$nearest3_4,$ez_2                  # 953e
        frds    $x_6,$q_2                               # 960e

        dfnms   $nearest+1,$b_4,$ex_3                   # 967e
        lnop                                            # 974o pairing

        fa      $x_6,$x_6,$k_tiny                       # 975e
        gb      $control_4,$control_4                   # 975o

        dfnms   $nearest2_5,$b_4,$ey_2                  # 976e
        dfnms   $nearest3_4,$b_4,$ez_2                  # 983e

        dfm     $e_8,$nearest+1,$ex_3                   # 990e
        dfnms   $b1_4,$nearest+1,$nearest+1             # 997e

        dfma    $e_8,$nearest2_5,$ey_2                  # 1004e
        dfnms   $b1_4,$nearest2_5,$nearest2_5           # 1011e

        dfma    $e_8,$nearest3_4,$ez_2                  # 1018e
        dfnms   $b1_4,$nearest3_4,$nearest3_4           # 1025e

        dfma    $b_4,$e_8,$k_half_double                # 1032e
        dfma    $b1_4,$e_8,$e_8                         # 1039e

        dfs     $nearest+1,$cx,$nearest1_6              # 1046e
        frds    $x_3,$b1_4                              # 1053e

        ori     $e_9,$b1_4,0                            # 1060e
        shlqbii $control_4,$control_4,4                 # 1060o

        ori     $cc_4,$b1_4,0                           # 1061e
        frest   $y_8,$x_6                               # 1061o

        fesd    $nearest+2,$nearest2_7                  # 1062e
        lnop                                            # 1069o pairing

        fi      $y_8,$x_6,$y_8                          # 1070e
        lqx     $control_4,$control_4,$a_controls       # 1070o

        dfms    $cc_4,$b_4,$b_4                         # 1071e
        lnop                                            # 1078o pairing

        fnms    $e,$x_6,$y_8,$k_one                     # 1079e
        shufb   $t_best,$t_best,$t_5,$control_4         # 1079o

        fa      $near_3,$x_3,$k_tiny                    # 1080e
        shufb   $nearest,$nearest,$object,$control_4    # 1080o

        dfs     $nearest+2,$cy,$nearest+2               # 1081e
        lnop                                            # 1088o pairing

        fma     $w,$e,$y_8,$y_8                         # 1089e
        stqd    $t_best,384($a_packet)                  # 1089o

        ori     $e,$cc_4,0                              # 1090e
        stqd    $nearest,448($a_packet)                 # 1090o

        selb    $s_5,$whole,$cc_4,$m_by_side            # 1091e
        frsqest $y_6,$near_3                            # 1091o

        ori     $b1_10,$near_3,0                        # 1092e
        lqd     $dy_3,304($a_packet)                    # 1092o

        xor     $s_5,$s_5,$b_4                          # 1093e
        lqd     $dz_3,368($a_packet)                    # 1093o

        fesd    $nearest3_7,$nearest3_5                 # 1094e
        fesd    $y_9,$w                                 # 1101e

        fi      $y_6,$near_3,$y_6                       # 1108e
        shufb   $b1_10,$disc_even_2,$b1_10,$m_rows      # 1108o

        rotmai  $s_5,$s_5,-31                           # 1109e
        rotqbyi $nearest1_7,$ox_4,0                     # 1109o

        dfs     $nearest3_7,$cz,$nearest3_7             # 1110e
        dfm     $t_6,$cc_3,$y_9                         # 1117e

        fm      $e_10,$near_3,$y_6                      # 1124e
        shufb   $s_5,$s_5,$s_5,$k_tiny+1                # 1124o

        fm      $w,$y_6,$k_half                         # 1125e
        rotqbyi $nearest2_9,$oy_3,0                     # 1125o

        fesd    $ex_4,$ex_4                             # 1126e
        dfnms   $e_6,$q_2,$t_6                          # 1133e

        fnms    $e_10,$e_10,$y_6,$k_one                 # 1140e
        rotqbyi $nearest3_8,$oz_3,0                     # 1140o

        fesd    $ey_3,$ey_3                             # 1141e
        dfma    $t_6,$e_6,$y_9                          # 1148e

        fma     $w,$e_10,$w,$y_6                        # 1155e
        rotqbyi $ex,$dx_3,0                             # 1155o

        fesd    $ez_5,$ez_3                             # 1156e
        lnop                                            # 1163o pairing

        selb    $t_7,$t_6,$q_2,$s_3                     # 1164e
        rotqbyi $ey_5,$dy_3,0                           # 1164o

        fesd    $y_10,$w                                # 1165e
        frds    $t_even_3,$t_7                          # 1172e

        dfm     $s_6,$b1_4,$y_10                        # 1179e
        lnop                                            # 1186o pairing

        a       $y_10,$y_10,$k_halve                    # 1187e
        rotqbyi $ez_6,$dz_3,0                           # 1187o

        dfm     $b_5,$nearest+1,$ex_4                   # 1188e
        dfnms   $e_9,$s_6,$s_6                          # 1195e

        dfma    $b_5,$nearest+2,$ey_3                   # 1202e
        dfma    $s_6,$e_9,$y_10                         # 1209e

        dfma    $b_5,$nearest3_7,$ez_5                  # 1216e
        lnop                                            # 1223o pairing

        selb    $s_6,$s_6,$b_4,$m_sign                  # 1224e
        rotqbyi $nearest1_8,$ox_4,4                     # 1224o

        fesd    $nearest1_9,$nearest1_5                 # 1225e
        dfa     $q_3,$b_4,$s_6                          # 1232e

        dfnms   $nearest+1,$b_5,$ex_4                   # 1239e
        frds    $x_2,$q_3                               # 1246e

        dfnms   $nearest+2,$b_5,$ey_3                   # 1253e
        lnop                                            # 1260o pairing

        fa      $x_2,$x_2,$k_tiny                       # 1261e
        rotqbyi $nearest2_10,$oy_3,4                    # 1261o

        dfnms   $nearest3_7,$b_5,$ez_5                  # 1262e
        dfm     $e_11,$nearest+1,$ex_4                  # 1269e

        dfnms   $b1_5,$nearest+1,$nearest+1             # 1276e
        dfma    $e_11,$nearest+2,$ey_3                  # 1283e

        dfnms   $b1_5,$nearest+2,$nearest+2             # 1290e
        dfma    $e_11,$nearest3_7,$ez_5                 # 1297e

        dfnms   $b1_5,$nearest3_7,$nearest3_7           # 1304e
        dfma    $b_5,$e_11,$k_half_double               # 1311e

        dfma    $b1_5,$e_11,$e_11                       # 1318e
        dfs     $nearest+1,$cx,$nearest1_9              # 1325e

        frds    $x_3,$b1_5                              # 1332e
        lnop                                            # 1339o pairing

        ori     $e_9,$b1_5,0                            # 1340e
        frest   $y_11,$x_2                              # 1340o

        ori     $cc_5,$b1_5,0                           # 1341e
        rotqbyi $nearest3_9,$oz_3,4                     # 1341o

        fesd    $nearest2_8,$nearest2_8                 # 1342e
        lnop                                            # 1349o pairing

        fi      $y_11,$x_2,$y_11                        # 1350e
        rotqbyi $ex_6,$dx_3,4                           # 1350o

        dfms    $cc_5,$b_5,$b_5                         # 1351e
        lnop                                            # 1358o pairing

        fnms    $e_4,$x_2,$y_11,$k_one                  # 1359e
        rotqbyi $ey_6,$dy_3,4                           # 1359o

        fa      $near_3,$x_3,$k_tiny                    # 1360e
        rotqbyi $ez_7,$dz_3,4                           # 1360o

        dfs     $nearest2_8,$cy,$nearest2_8             # 1361e
        lnop                                            # 1368o pairing

        fma     $w_7,$e_4,$y_11,$y_11                   # 1369e
        frsqest $y_12,$near_3                           # 1369o

        ori     $e_11,$cc_5,0                           # 1370e
        lqd     $t_best_4,432($a_packet)                # 1370o

        selb    $s_7,$whole,$cc_5,$m_by_side            # 1371e
        lqd     $nearest_4,496($a_packet)               # 1371o

        ori     $disc_even_3,$near_3,0                  # 1372e
        fi      $y_12,$near_3,$y_12                     # 1373e

        xor     $s_7,$s_7,$b_5                          # 1374e
        fesd    $y_11,$w_7                              # 1375e

        fm      $e_10,$near_3,$y_12                     # 1382e
        fm      $w_5,$y_12,$k_half                      # 1383e

        rotmai  $s_7,$s_7,-31                           # 1384e
        fesd    $nearest3_6,$nearest3_6                 # 1385e

        dfm     $t_8,$cc_4,$y_11                        # 1392e
        lnop                                            # 1399o pairing

        fnms    $e_10,$e_10,$y_12,$k_one                # 1400e
        shufb   $s_7,$s_7,$s_7,$k_tiny+1                # 1400o

        dfs     $nearest3_6,$cz,$nearest3_6             # 1401e
        dfnms   $e,$q_3,$t_8                            # 1408e

        fma     $w_8,$e_10,$w_5,$y_12                   # 1415e
        fesd    $ex_5,$ex_5                             # 1416e

        dfma    $t_8,$e,$y_11                           # 1423e
        fesd    $y_13,$w_8                              # 1430e

        selb    $t_9,$t_8,$q_3,$s_5                     # 1437e
        fesd    $ey_4,$ey_4                             # 1438e

        frds    $t_9,$t_9                               # 1445e
        dfm     $s_8,$b1_5,$y_13                        # 1452e

        a       $y_13,$y_13,$k_halve                    # 1459e
        shufb   $t_7,$t_even_3,$t_9,$m_rows             # 1459o

        fesd    $ez_8,$ez_4                             # 1460e
        cgti    $ahead_3,$t_7,0                         # 1467e

        cgt     $control_5,$t_best_2,$t_7               # 1468e
        dfnms   $e_9,$s_8,$s_8                          # 1469e

        and     $control_4,$control_5,$ahead_3          # 1476e
        dfm     $b,$nearest+1,$ex_5                     # 1477e

        andc    $control_4,$control_4,$b1_10            # 1484e
        dfma    $s_8,$e_9,$y_13                         # 1485e

        dfma    $b,$nearest2_8,$ey_4                    # 1492e
        lnop                                            # 1499o pairing

        selb    $s,$s_8,$b_5,$m_sign                    # 1500e
        rotqbii $control_6,$control_4,1                 # 1500o

        fesd    $nearest1_2,$nearest1_7                 # 1501e
        dfa     $q_4,$b_5,$s                            # 1508e

        dfma    $b,$nearest3_6,$ez_8                    # 1515e
        frds    $x_7,$q_4                               # 1522e

        dfnms   $nearest+1,$b,$ex_5                     # 1529e
        lnop                                            # 1536o pairing

        fa      $x_7,$x_7,$k_tiny                       # 1537e
        gb      $control,$control_6                     # 1537o

        dfnms   $nearest2_8,$b,$ey_4                    # 1538e
        dfnms   $nearest3_6,$b,$ez_8                    # 1545e

        dfm     $e,$nearest+1,$ex_5                     # 1552e
        dfnms   $b1_6,$nearest+1,$nearest+1             # 1559e

        dfma    $e,$nearest2_8,$ey_4                    # 1566e
        dfnms   $b1_6,$nearest2_8,$nearest2_8           # 1573e

        dfma    $e,$nearest3_6,$ez_8                    # 1580e
        dfnms   $b1_6,$nearest3_6,$nearest3_6           # 1587e

        dfma    $b,$e,$k_half_double                    # 1594e
        dfma    $b1_6,$e,$e                             # 1601e

        dfs     $nearest+1,$cx,$nearest1_2              # 1608e
        frds    $x_8,$b1_6                              # 1615e

        ori     $e,$b1_6,0                              # 1622e
        shlqbii $control,$control,4                     # 1622o

        ori     $cc,$b1_6,0                             # 1623e
        frest   $y_14,$x_7                              # 1623o

        fesd    $nearest2_11,$nearest2_9                # 1624e
        lnop                                            # 1631o pairing

        fi      $y_14,$x_7,$y_14                        # 1632e
        lqx     $control,$control,$a_controls           # 1632o

        dfms    $cc,$b,$b                               # 1633e
        lnop                                            # 1640o pairing

        fnms    $e_10,$x_7,$y_14,$k_one                 # 1641e
        shufb   $t_best_5,$t_best_2,$t_7,$control       # 1641o

        fa      $near,$x_8,$k_tiny                      # 1642e
        shufb   $nearest,$nearest_2,$object,$control    # 1642o

        dfs     $nearest2_12,$cy,$nearest2_11           # 1643e
        lnop                                            # 1650o pairing

        fma     $w_9,$e_10,$y_14,$y_14                  # 1651e
        stqd    $t_best_5,400($a_packet)                # 1651o

        ori     $e_12,$cc,0                             # 1652e
        stqd    $nearest,464($a_packet)                 # 1652o

        selb    $s,$whole,$cc,$m_by_side                # 1653e
        frsqest $y_15,$near                             # 1653o

        ori     $b1_11,$near,0                          # 1654e
        xor     $s,$s,$b                                # 1655e

        fesd    $nearest3_10,$nearest3_8                # 1656e
        fesd    $y_14,$w_9                              # 1663e

        fi      $y_15,$near,$y_15                       # 1670e
        shufb   $b1_11,$disc_even_3,$b1_11,$m_rows      # 1670o

        rotmai  $s,$s,-31                               # 1671e
        dfs     $nearest3_10,$cz,$nearest3_10           # 1672e

        dfm     $t,$cc_5,$y_14                          # 1679e
        lnop                                            # 1686o pairing

        fm      $e_9,$near,$y_15                        # 1687e
        shufb   $s,$s,$s,$k_tiny+1                      # 1687o

        fm      $w_10,$y_15,$k_half                     # 1688e
        fesd    $ex,$ex                                 # 1689e

        dfnms   $e_11,$q_4,$t                           # 1696e
        fnms    $e_9,$e_9,$y_15,$k_one                  # 1703e

        fesd    $ey,$ey_5                               # 1704e
        dfma    $t,$e_11,$y_14                          # 1711e

        fma     $w_9,$e_9,$w_10,$y_15                   # 1718e
        fesd    $ez,$ez_6                               # 1719e

        selb    $t,$t,$q_4,$s_7                         # 1726e
        fesd    $y_14,$w_9                              # 1727e

        frds    $t_even,$t                              # 1734e
        dfm     $s_8,$b1_6,$y_14                        # 1741e

        a       $y_14,$y_14,$k_halve                    # 1748e
        dfm     $b_6,$nearest+1,$ex                     # 1749e

        dfnms   $e,$s_8,$s_8                            # 1756e
        dfma    $b_6,$nearest2_12,$ey                   # 1763e

        dfma    $s_8,$e,$y_14                           # 1770e
        dfma    $b_6,$nearest3_10,$ez                   # 1777e

        selb    $s_6,$s_8,$b,$m_sign                    # 1784e
        fesd    $nearest1_10,$nearest1_8                # 1785e

        dfa     $q_3,$b,$s_6                            # 1792e
        dfnms   $nearest+1,$b_6,$ex                     # 1799e

        frds    $x_5,$q_3                               # 1806e
        dfnms   $nearest2_12,$b_6,$ey                   # 1813e

        fa      $x_5,$x_5,$k_tiny                       # 1820e
        dfnms   $nearest3_10,$b_6,$ez                   # 1821e

        dfm     $e,$nearest+1,$ex                       # 1828e
        dfnms   $b1_7,$nearest+1,$nearest+1             # 1835e

        dfma    $e,$nearest2_12,$ey                     # 1842e
        dfnms   $b1_7,$nearest2_12,$nearest2_12         # 1849e

        dfma    $e,$nearest3_10,$ez                     # 1856e
        dfnms   $b1_7,$nearest3_10,$nearest3_10         # 1863e

        dfma    $b_6,$e,$k_half_double                  # 1870e
        dfma    $b1_7,$e,$e                             # 1877e

        dfs     $nearest+1,$cx,$nearest1_10             # 1884e
        frds    $x_8,$b1_7                              # 1891e

        ori     $e,$b1_7,0                              # 1898e
        frest   $y_15,$x_5                              # 1898o

        ori     $cc_6,$b1_7,0                           # 1899e
        fesd    $nearest+2,$nearest2_10                 # 1900e

        fi      $y_15,$x_5,$y_15                        # 1907e
        dfms    $cc_6,$b_6,$b_6                         # 1908e

        fnms    $e_2,$x_5,$y_15,$k_one                  # 1915e
        fa      $near,$x_8,$k_tiny                      # 1916e

        dfs     $nearest+2,$cy,$nearest+2               # 1917e
        lnop                                            # 1924o pairing

        fma     $w,$e_2,$y_15,$y_15                     # 1925e
        frsqest $y_5,$near                              # 1925o

        ori     $e_13,$cc_6,0                           # 1926e
        selb    $s_9,$whole,$cc_6,$m_by_side            # 1927e

        ori     $disc_even,$near,0                      # 1928e
        fi      $y_5,$near,$y_5                         # 1929e

        xor     $s_9,$s_9,$b_6                          # 1930e
        fesd    $y_4,$w                                 # 1931e

        fm      $e_7,$near,$y_5                         # 1938e
        fm      $w,$y_5,$k_half                         # 1939e

        rotmai  $s_9,$s_9,-31                           # 1940e
        fesd    $nearest3_11,$nearest3_9                # 1941e

        dfm     $t,$cc,$y_4                             # 1948e
        lnop                                            # 1955o pairing

        fnms    $e_7,$e_7,$y_5,$k_one                   # 1956e
        shufb   $s_9,$s_9,$s_9,$k_tiny+1                # 1956o

        dfs     $nearest3_12,$cz,$nearest3_11           # 1957e
        dfnms   $e_12,$q_3,$t                           # 1964e

        fma     $w,$e_7,$w,$y_5                         # 1971e
        fesd    $ex,$ex_6                               # 1972e

        dfma    $t,$e_12,$y_4                           # 1979e
        fesd    $y_5,$w                                 # 1986e

        selb    $t,$t,$q_3,$s                           # 1993e
        fesd    $ey,$ey_6                               # 1994e

        frds    $t,$t                                   # 2001e
        dfm     $s,$b1_7,$y_5                           # 2008e

        a       $y_5,$y_5,$k_halve                      # 2015e
        shufb   $t,$t_even,$t,$m_rows                   # 2015o

        fesd    $ez,$ez_7                               # 2016e
        cgti    $ahead_4,$t,0                           # 2023e

        cgt     $control,$t_best_3,$t                   # 2024e
        dfnms   $e,$s,$s                                # 2025e

        and     $control,$control,$ahead_4              # 2032e
        dfm     $b,$nearest+1,$ex                       # 2033e

        andc    $control,$control,$b1_11                # 2040e
        dfma    $s,$e,$y_5                              # 2041e

        dfma    $b,$nearest+2,$ey                       # 2048e
        lnop                                            # 2055o pairing

        selb    $s,$s,$b_6,$m_sign                      # 2056e
        rotqbii $control,$control,1                     # 2056o

        dfa     $q,$b_6,$s                              # 2058e
        dfma    $b,$nearest3_12,$ez                     # 2065e

        frds    $x,$q                                   # 2072e
        dfnms   $nearest+1,$b,$ex                       # 2079e

        fa      $x,$x,$k_tiny                           # 2086e
        gb      $control,$control                       # 2086o

        dfnms   $nearest+2,$b,$ey                       # 2087e
        dfnms   $nearest3_12,$b,$ez                     # 2094e

        dfm     $e,$nearest+1,$ex                       # 2101e
        dfnms   $b1_8,$nearest+1,$nearest+1             # 2108e

        dfma    $e,$nearest+2,$ey                       # 2115e
        dfnms   $b1_8,$nearest+2,$nearest+2             # 2122e

        dfma    $e,$nearest3_12,$ez                     # 2129e
        dfnms   $b1_8,$nearest3_12,$nearest3_12         # 2136e

        dfma    $b,$e,$k_half_double                    # 2143e
        dfma    $b1_8,$e,$e                             # 2150e

        shlqbii $control,$control,4                     # 2157o
        frest   $y_5,$x                                 # 2158o

        lqx     $control,$control,$a_controls           # 2161o
        fi      $y_5,$x,$y_5                            # 2162e

        frds    $x_9,$b1_8                              # 2163e
        lnop                                            # 2170o pairing

        fnms    $e,$x,$y_5,$k_one                       # 2171e
        shufb   $t_best,$t_best_3,$t,$control           # 2171o

        ori     $e_14,$b1_8,0                           # 2172e
        shufb   $nearest,$nearest_3,$object,$control    # 2172o

        ori     $cc,$b1_8,0                             # 2173e
        dfms    $cc,$b,$b                               # 2175e

        fma     $w,$e,$y_5,$y_5                         # 2182e
        stqd    $t_best,416($a_packet)                  # 2182o

        fa      $near,$x_9,$k_tiny                      # 2183e
        stqd    $nearest,480($a_packet)                 # 2183o

        fesd    $y,$w                                   # 2188e
        lnop                                            # 2195o pairing

        ori     $e,$cc,0                                # 2196e
        frsqest $y_5,$near                              # 2196o

        selb    $s,$whole,$cc,$m_by_side                # 2197e
        ori     $b+1,$near,0                            # 2198e

        xor     $s,$s,$b                                # 2199e
        lnop                                            # 2199o pairing

        fi      $y_5,$near,$y_5                         # 2200e
        shufb   $b+1,$disc_even,$b+1,$m_rows            # 2200o

        rotmai  $s,$s,-31                               # 2201e
        dfm     $t,$cc_6,$y                             # 2202e

        fm      $e_12,$near,$y_5                        # 2209e
        shufb   $s,$s,$s,$k_tiny+1                      # 2209o

        fm      $w,$y_5,$k_half                         # 2210e
        dfnms   $e_13,$q,$t                             # 2215e

        fnms    $e_12,$e_12,$y_5,$k_one                 # 2222e
        dfma    $t,$e_13,$y                             # 2228e

        fma     $w,$e_12,$w,$y_5                        # 2235e
        selb    $t,$t,$q,$s_9                           # 2241e

        fesd    $y,$w                                   # 2242e
        frds    $t_even,$t                              # 2249e

        dfm     $s_10,$b1_8,$y                          # 2256e
        lnop                                            # 2263o pairing

        a       $y,$y,$k_halve                          # 2264e
        hbrr    next_ball_back,next_ball                # 2264o hint

        dfnms   $e_14,$s_10,$s_10                       # 2269e
        dfma    $s_10,$e_14,$y                          # 2282e

        selb    $s_10,$s_10,$b,$m_sign                  # 2295e
        dfa     $q,$b,$s_10                             # 2297e

        frds    $x,$q                                   # 2310e
        fa      $x,$x,$k_tiny                           # 2323e

        frest   $y,$x                                   # 2329o
        fi      $y,$x,$y                                # 2333e

        fnms    $e_15,$x,$y,$k_one                      # 2340e
        fma     $w,$e_15,$y,$y                          # 2346e

        fesd    $y,$w                                   # 2352e
        dfm     $t,$cc,$y                               # 2365e

        dfnms   $e,$q,$t                                # 2378e
        dfma    $t,$e,$y                                # 2391e

        selb    $t,$t,$q,$s                             # 2404e
        frds    $t,$t                                   # 2406e

        shufb   $t,$t_even,$t,$m_rows                   # 2419o
        cgti    $ahead_5,$t,0                           # 2423e

        cgt     $control,$t_best_4,$t                   # 2424e
        and     $control,$control,$ahead_5              # 2426e

        andc    $control,$control,$b+1                  # 2428e
        rotqbii $control,$control,1                     # 2430o

        gb      $control,$control                       # 2434o
        shlqbii $control,$control,4                     # 2438o

        lqx     $control,$control,$a_controls           # 2442o
        shufb   $t_best,$t_best_4,$t,$control           # 2448o

        shufb   $nearest,$nearest_4,$object,$control    # 2449o
        stqd    $t_best,432($a_packet)                  # 2452o

        stqd    $nearest,496($a_packet)                 # 2453o
next_ball_back:
        brnz    $count,next_ball                        # 2454o

        nop     $127                                    # 2455e pairing
        bi      $lr                                     # 2455o
endfunction isect_ball_pairs_double_r16
