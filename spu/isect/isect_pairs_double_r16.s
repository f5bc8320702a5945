# isect_pairs_double_r16   nearest entry of packets' eye rays into spheres, in double precision
#   C       void isect_pairs_double_r16(const struct pair *, int count);
#   In      $3 pairs, $4 count (0 is none); pointers 16-aligned
#   Out     the pairs' packets: t, object, where an entry is nearer than what was there
#   Uses    $2-$71   Saves  -   Stack  0   Calls  -
#   Domain  |d| = 1 within 4 ulp; radius > 0; centre and radius below 2^60; rounds to the nearest
#   Error   0.51 ulp of t, eye 1.5 to 1e6 radii from the centre, ray within 0.995 r of it
#   Twin    oracle/src/twin/sphere/double.rs
#
# The steps are those of sphere_tmpl.inc. An opaque sphere has no inside: only the entry counts, and
# behind the eye it is none.
# Scheduled by spu schedule from isect_pairs_double_r16.s

        .include "work_unit.inc"
        .include "macros.inc"
        .include "math.inc"
        .include "sphere_tmpl.inc"
        .include "sphere_double.inc"

        .set    a_pair,3
        .set    count,4
        # constants
        .set    k_one,10
        .set    k_half,11
        .set    k_tiny,12
        .set    m_high,13
        .set    m_rows,14
        .set    m_sign,15
        .set    k_halve,16
        .set    m_x,17
        .set    m_y,18
        .set    m_z,19
        .set    m_radius2,20
        .set    a_merges,21
        # the pair
        .set    object,22
        .set    a_packet,23
        .set    quad,24
        .set    cx,25
        .set    cy,26
        .set    cz,27
        .set    radius2,28
        # a row
        .set    dx,29
        .set    dy,30
        .set    dz,31
        .set    t_best,32
        .set    nearest,33
        # temporaries
        .set    b,34
        .set    lx,35
        .set    ly,36
        .set    lz,37
        .set    disc,38
        .set    y,39
        .set    s,40
        .set    e,41
        .set    ex,42
        .set    ey,43
        .set    ez,44
        .set    x,45
        .set    near,46
        .set    w,47
        .set    cc,48
        .set    q,49
        .set    t_even,50
        .set    disc_even,51
        .set    t,52
        .set    hit,53
        .set    merge,54

        merges_table
        double_table

function isect_pairs_double_r16
        .set    dy_2,2
        .set    dx_2,5
        .set    dx_3,6
        .set    ex_2,7
        .set    ex_3,8
        .set    lx_2,9
        .set    ey_2,13
        .set    lx_3,27
        .set    ex_4,28
        .set    lx_4,29
        .set    dy_3,32
        .set    ey_3,33
        .set    lx_5,37
        .set    dx_4,38
        .set    lx_6,39
        .set    ex_5,40
        .set    ly_2,41
        .set    ex_6,38
        .set    ly_3,44
        .set    ex_7,5
        .set    b_2,45
        .set    b_3,46
        .set    b_4,47
        .set    b_5,48
        .set    lx_7,49
        .set    ex_8,6
        .set    ly_4,50
        .set    dz_2,51
        .set    b_6,52
        .set    b_7,53
        .set    ly_5,54
        .set    cz_2,55
        .set    lx_8,25
        .set    ey_4,2
        .set    ly_6,56
        .set    ez_2,57
        .set    ly_7,58
        .set    ey_5,30
        .set    lz_2,59
        .set    ez_3,60
        .set    lz_3,61
        .set    ey_6,32
        .set    lz_4,62
        .set    dz_3,63
        .set    lz_5,64
        .set    dy_4,65
        .set    lz_6,66
        .set    ez_4,67
        .set    lz_7,68
        .set    ey_7,69
        .set    ly_8,26
        .set    ez_5,63
        .set    b_8,70
        .set    lz_8,38
        .set    ez_6,51
        .set    ez_7,5
        .set    lz_9,42
        .set    ey_8,51
        .set    ez_8,2
        .set    radius2_2,5
        .set    disc_2,6
        .set    ez_9,13
        .set    disc_3,24
        .set    ez_10,30
        .set    disc_4,31
        .set    t_best_2,40
        .set    disc_5,2
        .set    nearest_2,7
        .set    disc_6,8
        .set    t_best_3,37
        .set    disc_7,9
        .set    nearest_3,26
        .set    disc_8,27
        .set    t_best_4,29
        .set    disc_9,5
        .set    nearest_4,35
        .set    x_2,13
        .set    x_3,25
        .set    near_2,13
        .set    x_4,28
        .set    x_5,30
        .set    x_6,36
        .set    near_3,28
        .set    near_4,30
        .set    x_7,38
        .set    x_8,41
        .set    y_2,42
        .set    y_3,43
        .set    e_2,44
        .set    near_5,36
        .set    near_6,25
        .set    e_3,49
        .set    x_9,50
        .set    e_4,51
        .set    y_4,54
        .set    near_7,41
        .set    y_5,55
        .set    w_2,56
        .set    w_3,57
        .set    e_5,58
        .set    near_8,50
        .set    y_6,59
        .set    e_6,60
        .set    near_9,38
        .set    e_7,61
        .set    e_8,62
        .set    w_4,63
        .set    y_7,64
        .set    e_9,65
        .set    y_8,66
        .set    w_5,67
        .set    e_10,68
        .set    w_6,69
        .set    w_7,71
        .set    w_8,39
        .set    w_9,43
        .set    e_11,57
        .set    y_9,60
        .set    y_10,61
        .set    w_10,64
        .set    w_11,66
        .set    e_12,67
        .set    w_12,54
        .set    w_13,42
        .set    e_13,56
        .set    s_2,67
        .set    w_14,60
        .set    w_15,51
        .set    s_3,59
        .set    y_11,57
        .set    w_16,55
        .set    s_4,56
        .set    s_5,61
        .set    s_6,63
        .set    s_7,64
        .set    y_12,51
        .set    s_8,65
        .set    s_9,66
        .set    e_14,69
        .set    e_15,71
        .set    s_10,39
        .set    s_11,44
        .set    q_2,39
        .set    s_12,42
        .set    x_10,43
        .set    q_3,42
        .set    s_13,54
        .set    q_4,54
        .set    s_14,51
        .set    q_5,51
        .set    q_6,44
        .set    s_15,55
        .set    x_11,56
        .set    q_7,55
        .set    x_12,57
        .set    x_13,58
        .set    x_14,59
        .set    s_16,60
        .set    q_8,60
        .set    x_15,61
        .set    x_16,62
        .set    y_13,63
        .set    cc_2,27
        .set    x_17,65
        .set    cc_3,31
        .set    y_14,67
        .set    y_15,68
        .set    cc_4,24
        .set    y_16,69
        .set    y_17,71
        .set    cc_5,2
        .set    cc_6,6
        .set    e_16,59
        .set    e_17,43
        .set    w_17,59
        .set    w_18,61
        .set    cc_7,9
        .set    cc_8,5
        .set    w_19,58
        .set    y_18,56
        .set    t_2,64
        .set    y_19,58
        .set    cc_9,8
        .set    t_3,67
        .set    w_20,62
        .set    y_20,62
        .set    t_4,65
        .set    e_18,66
        .set    t_5,68
        .set    t_6,2
        .set    t_7,42
        .set    e_19,31
        .set    t_8,27
        .set    e_20,24
        .set    t_9,31
        .set    e_21,6
        .set    e_22,9
        .set    e_23,5
        .set    t_even_2,8
        .set    t_10,24
        .set    t_even_3,27
        .set    t_11,8
        .set    t_12,9
        .set    t_even_4,6
        .set    t_even_5,5
        .set    disc_even_2,13
        .set    disc_even_3,25
        .set    hit_2,27
        .set    hit_3,5
        .set    disc_10,13
        .set    t_13,6
        .set    hit_4,25
        .set    hit_5,13
        .set    hit_6,9
        .set    merge_2,9
        .set    merge_3,5
        .set    merge_4,13
        .set    nearest_5,24
        .set    nearest_6,25
        .set    t_best_5,2
        nop     $127                                    # 0e pairing
        biz     $count,$lr                              # 0o

        ilhu    $m_x,1                                  # 1e
        lqa     $m_high,doubles                         # 1o

        ilhu    $m_y,0x405                              # 2e
        lqa     $m_rows,doubles+16                      # 2o

        ilhu    $m_z,0x809                              # 3e
        lqa     $m_sign,doubles+32                      # 3o

        ilhu    $m_radius2,0xc0d                        # 4e
        lqa     $k_halve,doubles+48                     # 4o

        iohl    $m_x,515                                # 5e
        iohl    $m_y,0x607                              # 6e

        iohl    $m_z,0xa0b                              # 7e
        iohl    $m_radius2,0xe0f                        # 8e

        ila     $a_merges,merges                        # 9e
        ilhu    $k_half,0x3f00                          # 10e

        ilhu    $k_one,0x3f80                           # 11e
        ilhu    $k_tiny,896                             # 12e

next_pair:
        ai      $count,$count,-1                        # 0e
        lqd     $object,0($a_pair)                      # 0o

        ai      $a_pair,$a_pair,16                      # 1e
        lqd     $quad,0($object)                        # 6o

        rotqbyi $a_packet,$object,4                     # 7o
        shufb   $object,$object,$object,$m_x            # 8o

        lqd     $dx,48($a_packet)                       # 11o
        lqd     $dy,64($a_packet)                       # 12o

        lqd     $dy_2,96($a_packet)                     # 13o
        shufb   $cx,$quad,$quad,$m_x                    # 14o

        lqd     $dx_2,16($a_packet)                     # 15o
        lqd     $dz,144($a_packet)                      # 16o

        lqd     $dx_3,32($a_packet)                     # 17o
        fesd    $cx,$cx                                 # 18e

        rotqbyi $ex,$dx_3,4                             # 25o
        rotqbyi $ex_2,$dx_2,0                           # 26o

        rotqbyi $ey,$dy_2,4                             # 27o
        rotqbyi $ex_3,$dx,0                             # 28o

        fesd    $ex,$ex                                 # 29e
        fesd    $ex_2,$ex_2                             # 36e

        ori     $lx,$cx,0                               # 43e
        shufb   $cy,$quad,$quad,$m_y                    # 43o

        ori     $lx_2,$cx,0                             # 44e
        rotqbyi $ey_2,$dy,4                             # 44o

        ori     $lx_3,$cx,0                             # 45e
        rotqbyi $ex_4,$dx,4                             # 45o

        dfm     $b,$lx_2,$ex                            # 46e
        fesd    $ey_2,$ey_2                             # 53e

        fesd    $cy,$cy                                 # 60e
        lnop                                            # 67o pairing

        ori     $lx_4,$cx,0                             # 68e
        lqd     $dy_3,80($a_packet)                     # 68o

        fesd    $ex_4,$ex_4                             # 69e
        lnop                                            # 76o pairing

        ori     $ly,$cy,0                               # 77e
        rotqbyi $ey_3,$dy_3,0                           # 77o

        ori     $lx_5,$cx,0                             # 78e
        lqd     $dx_4,0($a_packet)                      # 78o

        fesd    $ey,$ey                                 # 79e
        fesd    $ey_3,$ey_3                             # 86e

        ori     $lx_6,$cx,0                             # 93e
        rotqbyi $ex_5,$dx_4,0                           # 93o

        ori     $ly_2,$cy,0                             # 94e
        rotqbyi $ex_6,$dx_4,4                           # 94o

        ori     $ly_3,$cy,0                             # 95e
        rotqbyi $ex_7,$dx_2,4                           # 95o

        fesd    $ex_3,$ex_3                             # 96e
        fesd    $ex_5,$ex_5                             # 103e

        fesd    $ex_7,$ex_7                             # 110e
        fesd    $ex_6,$ex_6                             # 117e

        dfm     $b_2,$lx_4,$ex_3                        # 124e
        dfm     $b_3,$lx_6,$ex_6                        # 131e

        dfm     $b_4,$lx,$ex_7                          # 138e
        dfm     $b_5,$lx_3,$ex_5                        # 145e

        ori     $lx_7,$cx,0                             # 152e
        rotqbyi $ex_8,$dx_3,0                           # 152o

        ori     $ly_4,$cy,0                             # 153e
        lqd     $dz_2,160($a_packet)                    # 153o

        dfm     $b_6,$lx_7,$ex_2                        # 154e
        fesd    $ex_8,$ex_8                             # 161e

        dfma    $b_6,$ly,$ey_3                          # 168e
        dfm     $b_7,$lx_5,$ex_8                        # 175e

        dfma    $b_3,$ly_4,$ey_2                        # 182e
        lnop                                            # 189o pairing

        ori     $ly_5,$cy,0                             # 190e
        shufb   $cz_2,$quad,$quad,$m_z                  # 190o

        ori     $lx_8,$cx,0                             # 191e
        rotqbyi $ey_4,$dy_2,0                           # 191o

        ori     $ly_6,$cy,0                             # 192e
        rotqbyi $ez_2,$dz_2,4                           # 192o

        ori     $ly_7,$cy,0                             # 193e
        rotqbyi $ey_5,$dy,0                             # 193o

        fesd    $cz_2,$cz_2                             # 194e
        fesd    $ey_4,$ey_4                             # 201e

        fesd    $ez_2,$ez_2                             # 208e
        fesd    $ey_5,$ey_5                             # 215e

        ori     $lz_2,$cz_2,0                           # 222e
        rotqbyi $ez_3,$dz,4                             # 222o

        ori     $lz_3,$cz_2,0                           # 223e
        rotqbyi $ey_6,$dy_3,4                           # 223o

        ori     $lz_4,$cz_2,0                           # 224e
        lqd     $dz_3,128($a_packet)                    # 224o

        ori     $lz_5,$cz_2,0                           # 225e
        lqd     $dy_4,112($a_packet)                    # 225o

        fesd    $ez_3,$ez_3                             # 226e
        fesd    $ey_6,$ey_6                             # 233e

        ori     $lz_6,$cz_2,0                           # 240e
        rotqbyi $ez_4,$dz_3,4                           # 240o

        ori     $lz_7,$cz_2,0                           # 241e
        rotqbyi $ey_7,$dy_4,0                           # 241o

        ori     $ly_8,$cy,0                             # 242e
        rotqbyi $ez_5,$dz_3,0                           # 242o

        dfm     $b_8,$lx_8,$ex_4                        # 243e
        fesd    $ez_5,$ez_5                             # 250e

        dfma    $b,$ly_8,$ey                            # 257e
        fesd    $ey_7,$ey_7                             # 264e

        fesd    $ez_4,$ez_4                             # 271e
        dfma    $b_2,$ly_7,$ey_7                        # 278e

        dfma    $b_3,$lz_7,$ez_4                        # 285e
        dfma    $b_4,$ly_5,$ey_6                        # 292e

        dfma    $b,$lz_3,$ez_2                          # 299e
        dfma    $b_4,$lz_5,$ez_3                        # 306e

        dfma    $b_5,$ly_2,$ey_5                        # 313e
        dfnms   $lx_6,$b_3,$ex_6                        # 320e

        dfma    $b_7,$ly_6,$ey_4                        # 327e
        lnop                                            # 334o pairing

        ori     $lz_8,$cz_2,0                           # 335e
        rotqbyi $ez_6,$dz_2,0                           # 335o

        dfnms   $lx,$b_4,$ex_7                          # 336e
        fesd    $ez_7,$ez_6                             # 343e

        dfnms   $lx_2,$b,$ex                            # 350e
        dfma    $b_7,$lz_4,$ez_7                        # 357e

        ori     $lz_9,$cz_2,0                           # 364e
        rotqbyi $ey_8,$dy_4,4                           # 364o

        dfnms   $ly_8,$b,$ey                            # 365e
        fesd    $ey,$ey_8                               # 372e

        dfma    $b_5,$lz_9,$ez_5                        # 379e
        dfma    $b_8,$ly_3,$ey                          # 386e

        dfnms   $lx_3,$b_5,$ex_5                        # 393e
        dfnms   $ly_2,$b_5,$ey_5                        # 400e

        dfnms   $ly_6,$b_7,$ey_4                        # 407e
        dfnms   $lx_5,$b_7,$ex_8                        # 414e

        dfnms   $lz_7,$b_3,$ez_4                        # 421e
        dfnms   $ly_5,$b_4,$ey_6                        # 428e

        dfnms   $ly_4,$b_3,$ey_2                        # 435e
        dfnms   $lz_4,$b_7,$ez_7                        # 442e

        dfnms   $lz_3,$b,$ez_2                          # 449e
        dfnms   $lz_5,$b_4,$ez_3                        # 456e

        dfnms   $lz_9,$b_5,$ez_5                        # 463e
        rotqbyi $ez_8,$dz,0                             # 470o

        lqd     $dz,176($a_packet)                      # 471o
        shufb   $radius2_2,$quad,$quad,$m_radius2       # 472o

        lqd     $t_best,208($a_packet)                  # 473o
        fesd    $ez_8,$ez_8                             # 474e

        fesd    $radius2_2,$radius2_2                   # 481e
        dfma    $b_6,$lz_2,$ez_8                        # 488e

        ori     $disc_2,$radius2_2,0                    # 495e
        rotqbyi $ez_9,$dz,0                             # 495o

        ori     $disc_3,$radius2_2,0                    # 496e
        rotqbyi $ez_10,$dz,4                            # 496o

        ori     $disc_4,$radius2_2,0                    # 497e
        lqd     $t_best_2,240($a_packet)                # 497o

        dfnms   $disc_2,$lx_5,$lx_5                     # 498e
        fesd    $ez_10,$ez_10                           # 505e

        fesd    $ez_9,$ez_9                             # 512e
        dfnms   $lx_7,$b_6,$ex_2                        # 519e

        dfma    $b_2,$lz_8,$ez_9                        # 526e
        dfma    $b_8,$lz_6,$ez_10                       # 533e

        dfnms   $lx_4,$b_2,$ex_3                        # 540e
        dfnms   $ly_7,$b_2,$ey_7                        # 547e

        dfnms   $lz_2,$b_6,$ez_8                        # 554e
        dfnms   $disc_2,$ly_6,$ly_6                     # 561e

        ori     $disc_5,$radius2_2,0                    # 568e
        lqd     $nearest_2,272($a_packet)               # 568o

        ori     $disc_6,$radius2_2,0                    # 569e
        lqd     $t_best_3,192($a_packet)                # 569o

        dfnms   $disc_4,$lx_6,$lx_6                     # 570e
        dfnms   $disc_6,$lx_4,$lx_4                     # 577e

        dfnms   $disc_5,$lx_2,$lx_2                     # 584e
        dfnms   $disc_2,$lz_4,$lz_4                     # 591e

        dfnms   $disc_5,$ly_8,$ly_8                     # 598e
        dfnms   $ly_3,$b_8,$ey                          # 605e

        dfnms   $disc_3,$lx_3,$lx_3                     # 612e
        lnop                                            # 619o pairing

        ori     $disc_7,$radius2_2,0                    # 620e
        lqd     $nearest_3,288($a_packet)               # 620o

        dfnms   $disc_6,$ly_7,$ly_7                     # 621e
        dfnms   $disc_7,$lx,$lx                         # 628e

        dfnms   $disc_3,$ly_2,$ly_2                     # 635e
        dfnms   $disc_7,$ly_5,$ly_5                     # 642e

        ori     $disc_8,$radius2_2,0                    # 649e
        lqd     $t_best_4,224($a_packet)                # 649o

        ori     $disc_9,$radius2_2,0                    # 650e
        lqd     $nearest_4,304($a_packet)               # 650o

        dfnms   $disc_8,$lx_7,$lx_7                     # 651e
        dfnms   $disc_7,$lz_5,$lz_5                     # 658e

        dfnms   $ly,$b_6,$ey_3                          # 665e
        dfnms   $lx_8,$b_8,$ex_4                        # 672e

        dfnms   $disc_8,$ly,$ly                         # 679e
        dfnms   $disc_9,$lx_8,$lx_8                     # 686e

        dfnms   $lz_8,$b_2,$ez_9                        # 693e
        dfnms   $disc_9,$ly_3,$ly_3                     # 700e

        dfnms   $disc_5,$lz_3,$lz_3                     # 707e
        dfnms   $disc_3,$lz_9,$lz_9                     # 714e

        dfnms   $disc_4,$ly_4,$ly_4                     # 721e
        dfnms   $disc_8,$lz_2,$lz_2                     # 728e

        dfnms   $lz_6,$b_8,$ez_10                       # 735e
        frds    $x_2,$disc_8                            # 742e

        frds    $x_3,$disc_7                            # 749e
        dfnms   $disc_6,$lz_8,$lz_8                     # 756e

        fa      $near_2,$x_2,$k_tiny                    # 763e
        lqd     $nearest,256($a_packet)                 # 763o

        frds    $x_4,$disc_5                            # 764e
        frds    $x_5,$disc_2                            # 771e

        frds    $x_6,$disc_3                            # 778e
        dfnms   $disc_4,$lz_7,$lz_7                     # 785e

        fa      $near_3,$x_4,$k_tiny                    # 792e
        frsqest $y,$near_2                              # 792o

        fa      $near_4,$x_5,$k_tiny                    # 793e
        frds    $x_7,$disc_6                            # 794e

        frds    $x_8,$disc_4                            # 801e
        lnop                                            # 808o pairing

        fi      $y,$near_2,$y                           # 809e
        frsqest $y_2,$near_4                            # 809o

        dfnms   $disc_9,$lz_6,$lz_6                     # 810e
        lnop                                            # 817o pairing

        fi      $y_2,$near_4,$y_2                       # 818e
        frsqest $y_3,$near_3                            # 818o

        ori     $e_2,$disc_8,0                          # 819e
        fa      $near_5,$x_6,$k_tiny                    # 820e

        fa      $near_6,$x_3,$k_tiny                    # 821e
        fi      $y_3,$near_3,$y_3                       # 822e

        ori     $e_3,$disc_4,0                          # 823e
        frds    $x_9,$disc_9                            # 824e

        fm      $e_4,$near_4,$y_2                       # 831e
        frsqest $y_4,$near_6                            # 831o

        fa      $near_7,$x_8,$k_tiny                    # 832e
        frsqest $y_5,$near_5                            # 832o

        fm      $w_2,$y_2,$k_half                       # 833e
        fm      $w_3,$y,$k_half                         # 834e

        fi      $y_4,$near_6,$y_4                       # 835e
        fi      $y_5,$near_5,$y_5                       # 836e

        ori     $e_5,$disc_3,0                          # 837e
        lnop                                            # 837o pairing

        fa      $near_8,$x_9,$k_tiny                    # 838e
        frsqest $y_6,$near_7                            # 838o

        fm      $e_6,$near_3,$y_3                       # 839e
        fa      $near_9,$x_7,$k_tiny                    # 840e

        fm      $e_7,$near_2,$y                         # 841e
        fi      $y_6,$near_7,$y_6                       # 842e

        ori     $e_8,$disc_9,0                          # 843e
        lnop                                            # 843o pairing

        fm      $w_4,$y_5,$k_half                       # 844e
        frsqest $y_7,$near_8                            # 844o

        fnms    $e_6,$e_6,$y_3,$k_one                   # 845e
        lnop                                            # 845o pairing

        fm      $e_9,$near_6,$y_4                       # 846e
        frsqest $y_8,$near_9                            # 846o

        fnms    $e_7,$e_7,$y,$k_one                     # 847e
        fm      $w_5,$y_3,$k_half                       # 848e

        fm      $e_10,$near_7,$y_6                      # 849e
        fm      $w_6,$y_6,$k_half                       # 850e

        fm      $w_7,$y_4,$k_half                       # 851e
        fnms    $e_9,$e_9,$y_4,$k_one                   # 852e

        fma     $w_8,$e_7,$w_3,$y                       # 853e
        fma     $w_9,$e_6,$w_5,$y_3                     # 854e

        fm      $e_11,$near_5,$y_5                      # 855e
        fnms    $e_4,$e_4,$y_2,$k_one                   # 856e

        fi      $y_9,$near_8,$y_7                       # 857e
        fi      $y_10,$near_9,$y_8                      # 858e

        fesd    $y,$w_8                                 # 859e
        fm      $w_10,$y_9,$k_half                      # 866e

        fm      $w_11,$y_10,$k_half                     # 867e
        fesd    $y_3,$w_9                               # 868e

        fm      $e_12,$near_8,$y_9                      # 875e
        fma     $w_12,$e_9,$w_7,$y_4                    # 876e

        fma     $w_13,$e_4,$w_2,$y_2                    # 877e
        fm      $e_4,$near_9,$y_10                      # 878e

        fnms    $e_13,$e_11,$y_5,$k_one                 # 879e
        fnms    $e_11,$e_10,$y_6,$k_one                 # 880e

        fnms    $e_9,$e_12,$y_9,$k_one                  # 881e
        dfm     $s_2,$disc_8,$y                         # 882e

        fma     $w_14,$e_9,$w_10,$y_9                   # 889e
        fma     $w_3,$e_11,$w_6,$y_6                    # 890e

        fnms    $e_4,$e_4,$y_10,$k_one                  # 891e
        fesd    $y_4,$w_12                              # 892e

        fma     $w_15,$e_4,$w_11,$y_10                  # 899e
        dfm     $s_3,$disc_5,$y_3                       # 900e

        fesd    $y_11,$w_3                              # 907e
        fesd    $y_2,$w_13                              # 914e

        fma     $w_16,$e_13,$w_4,$y_5                   # 921e
        dfm     $s_4,$disc_7,$y_4                       # 922e

        fesd    $y_5,$w_16                              # 929e
        dfm     $s_5,$disc_2,$y_2                       # 936e

        dfm     $s_6,$disc_3,$y_5                       # 943e
        fesd    $y_9,$w_14                              # 950e

        dfnms   $e_5,$s_6,$s_6                          # 957e
        dfm     $s_7,$disc_4,$y_11                      # 964e

        fesd    $y_12,$w_15                             # 971e
        dfnms   $e_2,$s_2,$s_2                          # 978e

        dfm     $s_8,$disc_6,$y_12                      # 985e
        a       $y_4,$y_4,$k_halve                      # 992e

        dfm     $s_9,$disc_9,$y_9                       # 993e
        a       $y_3,$y_3,$k_halve                      # 1000e

        ori     $e_10,$disc_6,0                         # 1001e
        ori     $e_14,$disc_2,0                         # 1002e

        dfnms   $e_10,$s_8,$s_8                         # 1003e
        dfnms   $e_14,$s_5,$s_5                         # 1010e

        a       $y_2,$y_2,$k_halve                      # 1017e
        dfnms   $e_3,$s_7,$s_7                          # 1018e

        ori     $e_15,$disc_5,0                         # 1025e
        a       $y_11,$y_11,$k_halve                    # 1026e

        dfnms   $e_15,$s_3,$s_3                         # 1027e
        dfma    $s_7,$e_3,$y_11                         # 1034e

        ori     $e_3,$disc_7,0                          # 1041e
        a       $y,$y,$k_halve                          # 1042e

        dfnms   $e_3,$s_4,$s_4                          # 1043e
        dfma    $s_2,$e_2,$y                            # 1050e

        dfma    $s_4,$e_3,$y_4                          # 1057e
        selb    $s_10,$s_7,$b_3,$m_sign                 # 1064e

        selb    $s_11,$s_2,$b_6,$m_sign                 # 1065e
        dfa     $q,$b_3,$s_10                           # 1066e

        dfa     $q_2,$b_6,$s_11                         # 1073e
        dfma    $s_5,$e_14,$y_2                         # 1080e

        a       $y_2,$y_5,$k_halve                      # 1087e
        dfma    $s_3,$e_15,$y_3                         # 1088e

        dfma    $s_6,$e_5,$y_2                          # 1095e
        selb    $s_12,$s_3,$b,$m_sign                   # 1102e

        frds    $x_10,$q                                # 1103e
        selb    $s_11,$s_6,$b_5,$m_sign                 # 1110e

        dfa     $q_3,$b,$s_12                           # 1111e
        selb    $s_13,$s_5,$b_7,$m_sign                 # 1118e

        a       $y_12,$y_12,$k_halve                    # 1119e
        dfa     $q_4,$b_7,$s_13                         # 1120e

        dfma    $s_8,$e_10,$y_12                        # 1127e
        dfnms   $e_8,$s_9,$s_9                          # 1134e

        selb    $s_14,$s_4,$b_4,$m_sign                 # 1141e
        a       $y_5,$y_9,$k_halve                      # 1142e

        dfa     $q_5,$b_4,$s_14                         # 1143e
        dfma    $s_9,$e_8,$y_5                          # 1150e

        dfa     $q_6,$b_5,$s_11                         # 1157e
        selb    $s_15,$s_9,$b_8,$m_sign                 # 1164e

        frds    $x_11,$q_2                              # 1165e
        dfa     $q_7,$b_8,$s_15                         # 1172e

        frds    $x_12,$q_6                              # 1179e
        frds    $x_13,$q_4                              # 1186e

        frds    $x_14,$q_5                              # 1193e
        fa      $x_13,$x_13,$k_tiny                     # 1200e

        selb    $s_16,$s_8,$b_2,$m_sign                 # 1201e
        fa      $x_11,$x_11,$k_tiny                     # 1202e

        dfa     $q_8,$b_2,$s_16                         # 1203e
        frds    $x_15,$q_3                              # 1210e

        frds    $x_16,$q_8                              # 1217e
        lnop                                            # 1224o pairing

        fa      $x_15,$x_15,$k_tiny                     # 1225e
        frest   $y_13,$x_11                             # 1225o

        fa      $x_10,$x_10,$k_tiny                     # 1226e
        frest   $y_7,$x_13                              # 1226o

        fa      $x_14,$x_14,$k_tiny                     # 1227e
        ori     $cc_2,$disc_8,0                         # 1228e

        fa      $x_12,$x_12,$k_tiny                     # 1229e
        fi      $y_7,$x_13,$y_7                         # 1230e

        frds    $x_17,$q_7                              # 1231e
        lnop                                            # 1238o pairing

        fa      $x_16,$x_16,$k_tiny                     # 1239e
        frest   $y_8,$x_12                              # 1239o

        ori     $cc_3,$disc_4,0                         # 1240e
        frest   $y_14,$x_14                             # 1240o

        fi      $y_13,$x_11,$y_13                       # 1241e
        frest   $y_15,$x_10                             # 1241o

        ori     $cc_4,$disc_3,0                         # 1242e
        frest   $y_16,$x_15                             # 1242o

        fi      $y_8,$x_12,$y_8                         # 1243e
        fi      $y_14,$x_14,$y_14                       # 1244e

        fi      $y_15,$x_10,$y_15                       # 1245e
        frest   $y_17,$x_16                             # 1245o

        fi      $y_16,$x_15,$y_16                       # 1246e
        ori     $cc_5,$disc_5,0                         # 1247e

        ori     $cc_6,$disc_2,0                         # 1248e
        dfms    $cc_5,$b,$b                             # 1249e

        fnms    $e_16,$x_14,$y_14,$k_one                # 1256e
        fnms    $e_11,$x_12,$y_8,$k_one                 # 1257e

        fnms    $e_7,$x_15,$y_16,$k_one                 # 1258e
        fnms    $e_17,$x_10,$y_15,$k_one                # 1259e

        dfms    $cc_4,$b_5,$b_5                         # 1260e
        fma     $w_17,$e_16,$y_14,$y_14                 # 1267e

        fma     $w_18,$e_7,$y_16,$y_16                  # 1268e
        fma     $w_3,$e_11,$y_8,$y_8                    # 1269e

        fma     $w_9,$e_17,$y_15,$y_15                  # 1270e
        fnms    $e_13,$x_11,$y_13,$k_one                # 1271e

        ori     $cc_7,$disc_7,0                         # 1272e
        ori     $cc_8,$disc_9,0                         # 1273e

        dfms    $cc_7,$b_4,$b_4                         # 1274e
        fesd    $y_11,$w_3                              # 1281e

        fa      $x_17,$x_17,$k_tiny                     # 1288e
        fma     $w_2,$e_13,$y_13,$y_13                  # 1289e

        fnms    $e_5,$x_13,$y_7,$k_one                  # 1290e
        fesd    $y_6,$w_17                              # 1291e

        fma     $w_19,$e_5,$y_7,$y_7                    # 1298e
        frest   $y_13,$x_17                             # 1298o

        fesd    $y_18,$w_2                              # 1299e
        fi      $y_13,$x_17,$y_13                       # 1306e

        dfm     $t_2,$cc_4,$y_11                        # 1307e
        fesd    $y_19,$w_19                             # 1314e

        dfms    $cc_8,$b_8,$b_8                         # 1321e
        dfms    $cc_3,$b_3,$b_3                         # 1328e

        fesd    $y_3,$w_9                               # 1335e
        ori     $cc_9,$disc_6,0                         # 1342e

        fi      $y_8,$x_16,$y_17                        # 1343e
        dfms    $cc_9,$b_2,$b_2                         # 1344e

        fnms    $e_8,$x_16,$y_8,$k_one                  # 1351e
        dfm     $t_3,$cc_3,$y_3                         # 1352e

        fma     $w_20,$e_8,$y_8,$y_8                    # 1359e
        fnms    $e_9,$x_17,$y_13,$k_one                 # 1360e

        dfms    $cc_2,$b_6,$b_6                         # 1361e
        fma     $w_4,$e_9,$y_13,$y_13                   # 1368e

        fesd    $y_20,$w_20                             # 1369e
        dfms    $cc_6,$b_7,$b_7                         # 1376e

        fesd    $y_10,$w_18                             # 1383e
        dfm     $t_4,$cc_6,$y_19                        # 1390e

        ori     $e_18,$cc_5,0                           # 1397e
        dfm     $t_5,$cc_7,$y_6                         # 1398e

        dfm     $t_6,$cc_5,$y_10                        # 1405e
        fesd    $y_13,$w_4                              # 1412e

        dfnms   $e_18,$q_3,$t_6                         # 1419e
        dfm     $t_7,$cc_8,$y_13                        # 1426e

        ori     $e_19,$cc_3,0                           # 1433e
        ori     $e_14,$cc_2,0                           # 1434e

        dfnms   $e_19,$q,$t_3                           # 1435e
        dfm     $t_8,$cc_2,$y_18                        # 1442e

        dfma    $t_3,$e_19,$y_3                         # 1449e
        dfnms   $e_14,$q_2,$t_8                         # 1456e

        ori     $e_20,$cc_4,0                           # 1463e
        dfm     $t_9,$cc_9,$y_20                        # 1464e

        dfnms   $e_20,$q_6,$t_2                         # 1471e
        dfma    $t_8,$e_14,$y_18                        # 1478e

        ori     $e_21,$cc_6,0                           # 1485e
        ori     $e_22,$cc_7,0                           # 1486e

        dfnms   $e_21,$q_4,$t_4                         # 1487e
        dfnms   $e_22,$q_5,$t_5                         # 1494e

        dfma    $t_4,$e_21,$y_19                        # 1501e
        ori     $e_21,$cc_9,0                           # 1508e

        ori     $e_23,$cc_8,0                           # 1509e
        dfma    $t_2,$e_20,$y_11                        # 1510e

        dfnms   $e_21,$q_8,$t_9                         # 1517e
        frds    $t_even_2,$t_2                          # 1524e

        dfnms   $e_23,$q_7,$t_7                         # 1531e
        frds    $t_10,$t_3                              # 1538e

        frds    $t_even_3,$t_8                          # 1545e
        dfma    $t_5,$e_22,$y_6                         # 1552e

        or      $disc_even,$near_4,$b_7                 # 1559e
        shufb   $t_11,$t_even_2,$t_10,$m_rows           # 1559o

        dfma    $t_6,$e_18,$y_10                        # 1560e
        clgt    $hit,$t_best_3,$t_11                    # 1567e

        frds    $t_12,$t_5                              # 1568e
        dfma    $t_9,$e_21,$y_20                        # 1575e

        frds    $t_6,$t_6                               # 1582e
        frds    $t_even_4,$t_9                          # 1589e

        dfma    $t_7,$e_23,$y_13                        # 1596e
        frds    $t_even_5,$t_4                          # 1603e

        frds    $t_10,$t_7                              # 1610e
        lnop                                            # 1617o pairing

        or      $disc_even_2,$near_2,$b_6               # 1618e
        shufb   $t,$t_even_3,$t_12,$m_rows              # 1618o

        or      $disc_7,$near_7,$b_3                    # 1619e
        shufb   $t_6,$t_even_5,$t_6,$m_rows             # 1619o

        or      $disc_9,$near_6,$b_4                    # 1620e
        or      $disc_even_3,$near_9,$b_2               # 1621e

        clgt    $hit_2,$t_best,$t                       # 1622e
        shufb   $disc,$disc_even_2,$disc_9,$m_rows      # 1622o

        clgt    $hit_3,$t_best_4,$t_6                   # 1623e
        lnop                                            # 1623o pairing

        or      $disc_10,$near_8,$b_8                   # 1624e
        shufb   $t_13,$t_even_4,$t_10,$m_rows           # 1624o

        or      $disc_3,$near_3,$b                      # 1625e
        lnop                                            # 1625o pairing

        andc    $hit_2,$hit_2,$disc                     # 1626e
        shufb   $disc,$disc_even_3,$disc_10,$m_rows     # 1626o

        or      $disc_even_2,$near_5,$b_5               # 1627e
        shufb   $disc_3,$disc_even,$disc_3,$m_rows      # 1627o

        clgt    $hit_4,$t_best_2,$t_13                  # 1628e
        rotqbii $hit_2,$hit_2,1                         # 1628o

        shufb   $disc_7,$disc_even_2,$disc_7,$m_rows    # 1629o
        andc    $hit_5,$hit_4,$disc                     # 1630e

        andc    $hit_3,$hit_3,$disc_3                   # 1631e
        rotqbii $hit_5,$hit_5,1                         # 1632o

        andc    $hit,$hit,$disc_7                       # 1633e
        rotqbii $hit_3,$hit_3,1                         # 1633o

        gb      $hit_6,$hit_2                           # 1634o
        rotqbii $hit,$hit,1                             # 1635o

        gb      $hit_5,$hit_5                           # 1636o
        gb      $hit_3,$hit_3                           # 1637o

        shlqbii $hit_6,$hit_6,4                         # 1638o
        gb      $hit,$hit                               # 1639o

        shlqbii $hit_5,$hit_5,4                         # 1640o
        shlqbii $hit_3,$hit_3,4                         # 1641o

        lqx     $merge,$a_merges,$hit_6                 # 1642o
        shlqbii $hit,$hit,4                             # 1643o

        lqx     $merge_2,$a_merges,$hit_5               # 1644o
        lqx     $merge_3,$a_merges,$hit_3               # 1645o

        lqx     $merge_4,$a_merges,$hit                 # 1647o
        shufb   $t_best,$t_best,$t,$merge               # 1648o

        shufb   $nearest_2,$nearest_2,$object,$merge    # 1649o
        shufb   $nearest_5,$nearest_4,$object,$merge_2  # 1650o

        shufb   $nearest_6,$nearest_3,$object,$merge_3  # 1651o
        shufb   $t_best_5,$t_best_4,$t_6,$merge_3       # 1652o

        shufb   $nearest,$nearest,$object,$merge_4      # 1653o
        stqd    $nearest_2,272($a_packet)               # 1654o

        stqd    $nearest_6,288($a_packet)               # 1655o
        stqd    $t_best_5,224($a_packet)                # 1656o

        stqd    $t_best,208($a_packet)                  # 1657o
        shufb   $t_best,$t_best_3,$t_11,$merge_4        # 1658o

        stqd    $nearest,256($a_packet)                 # 1659o
        shufb   $t_best_5,$t_best_2,$t_13,$merge_2      # 1660o

        stqd    $nearest_5,304($a_packet)               # 1661o
        stqd    $t_best,192($a_packet)                  # 1662o

        hbrr    next_pair_back,next_pair                # 1663o hint
        stqd    $t_best_5,240($a_packet)                # 1664o

        nop     $127                                    # 1665e pairing
next_pair_back:
        brnz    $count,next_pair                        # 1665o

        nop     $127                                    # 1666e pairing
        bi      $lr                                     # 1666o
endfunction isect_pairs_double_r16
