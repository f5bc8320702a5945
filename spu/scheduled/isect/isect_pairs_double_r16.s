# isect_pairs_double_r16   nearest entries of primary rays into spheres, in double precision
#   C       void isect_pairs_double_r16(const struct pair *, int count);
#   In      $3 pairs, $4 count (0 is none); pointers 16-aligned
#   Out     the pairs' packets: t, object, where an entry is nearer than what was there
#   Uses    $2-$78   Saves  -   Stack  0   Calls  -
#   Domain  |d| = 1 within 4 ulp; radius > 0; centre and radius below 2^60; rounds to the nearest
#   Error   0.51 ulp of t, eye 1.5 to 1e6 radii from the centre, ray within 0.995 r of it
#   Twin    lab/twins/src/sphere/double.rs
#
# The steps are in sphere_tmpl.inc. An opaque sphere has no inside, so only the entry counts, and
# only if it is in front of the eye.
# Scheduled by spu schedule from isect_pairs_double_r16.s

        .include "sphere_eye.inc"
        .include "sphere_double.inc"

        eye_registers "k_one,k_half,k_tiny,m_high,m_rows,m_sign,k_halve,k_half_double", "radius2", "b,lx,ly,lz,disc,y,s,e,ex,ey,ez,x,near,w,cc,q,t_even,disc_even"
        merges_table
        double_table

function isect_pairs_double_r16
        .set dx_2,2; .set dx_3,5; .set dx_4,6; .set dy_2,7; .set ex_2,8; .set ey_2,9; .set lx_2,13
        .set ex_3,27; .set lx_3,28; .set cz_2,29; .set lx_4,32; .set ex_4,5; .set lx_5,33
        .set ex_5,2; .set lx_6,34; .set ex_6,35; .set lx_7,37; .set cy_2,38; .set b_2,39
        .set ly_2,40; .set ex_7,30; .set ly_3,41; .set ey_3,7; .set b_3,42; .set ly_4,45
        .set dz_2,46; .set ly_5,47; .set dy_3,48; .set b_4,49; .set b_5,50; .set ly_6,51
        .set ey_4,52; .set ly_7,53; .set ey_5,48; .set b_6,54; .set b_7,55; .set ly_8,56
        .set ey_6,31; .set ly_9,38; .set ex_8,6; .set b_8,57; .set lz_2,58; .set dz_3,59
        .set lz_3,60; .set dz_4,61; .set lz_4,62; .set dy_4,63; .set lz_5,64; .set dz_5,65
        .set lz_6,66; .set ez_2,67; .set lx_8,26; .set radius2_2,25; .set b_9,68; .set lz_7,69
        .set ez_3,70; .set lz_8,71; .set ez_4,72; .set disc_2,73; .set ez_5,61; .set disc_3,74
        .set ey_7,75; .set disc_4,76; .set ey_8,63; .set lz_9,29; .set ez_6,77; .set disc_5,78
        .set ez_7,59; .set e_2,8; .set e_3,43; .set e_4,27; .set e_5,2; .set disc_6,9; .set ez_8,37
        .set disc_7,52; .set ez_9,46; .set ez_10,34; .set e_6,30; .set e_7,31; .set disc_8,26
        .set t_best_2,32; .set e_8,5; .set disc_9,25; .set t_best_3,28; .set e_9,6; .set x_2,7
        .set x_3,13; .set near_2,7; .set x_4,29; .set y_2,34; .set x_5,35; .set x_6,36
        .set e_10,37; .set nearest_2,38; .set t_best_4,41; .set x_7,44; .set near_3,36
        .set nearest_3,45; .set near_4,35; .set nearest_4,48; .set near_5,46; .set nearest_5,51
        .set w_2,53; .set near_6,13; .set near_7,29; .set near_8,44; .set y_3,56; .set y_4,58
        .set w_3,59; .set y_5,60; .set e_11,61; .set y_6,62; .set y_7,63; .set y_8,64; .set e_12,65
        .set e_13,66; .set e_14,67; .set e_15,69; .set w_4,70; .set e_16,71; .set w_5,72
        .set w_6,37; .set e_17,40; .set w_7,71; .set e_18,75; .set y_9,37; .set w_8,63; .set w_9,40
        .set e_19,60; .set w_10,56; .set w_11,60; .set s_2,62; .set w_12,34; .set y_10,59
        .set s_3,60; .set s_4,61; .set s_5,70; .set s_6,72; .set w_13,64; .set s_7,67; .set w_14,43
        .set y_11,27; .set y_12,53; .set s_8,58; .set s_9,64; .set s_10,2; .set q_2,2; .set y_13,5
        .set s_11,31; .set s_12,5; .set q_3,31; .set s_13,34; .set q_4,5; .set x_8,6; .set s_14,27
        .set x_9,30; .set s_15,37; .set s_16,40; .set q_5,37; .set q_6,40; .set x_10,43
        .set q_7,34; .set x_11,8; .set s_17,53; .set x_12,58; .set x_13,59; .set q_8,27
        .set q_9,53; .set y_14,61; .set cc_2,9; .set x_14,63; .set x_15,64; .set y_15,65
        .set y_16,66; .set e_20,59; .set cc_3,25; .set y_17,67; .set cc_4,26; .set e_21,58
        .set x_16,61; .set w_15,58; .set cc_5,64; .set w_16,8; .set y_18,8; .set w_17,30
        .set cc_6,52; .set w_18,6; .set y_19,43; .set y_20,6; .set t_2,56; .set cc_7,62
        .set cc_8,65; .set e_22,63; .set t_3,66; .set w_19,61; .set y_21,30; .set t_4,67
        .set cc_9,69; .set t_5,70; .set t_6,65; .set t_7,71; .set t_8,72; .set e_23,25
        .set e_24,26; .set e_25,64; .set t_9,2; .set t_10,6; .set t_11,5; .set e_26,7
        .set t_even_2,9; .set t_12,25; .set t_even_3,26; .set disc_even_2,8; .set t_even_4,6
        .set hit_2,7; .set hit_3,13; .set disc_10,6; .set disc_11,8; .set disc_even_3,7
        .set hit_4,26; .set t_13,9; .set hit_5,6; .set hit_6,8; .set merge_2,8; .set merge_3,6
        .set merge_4,7; .set t_best_5,13; .set nearest_6,25; .set nearest_7,26; .set t_best_6,2
        .set nearest_8,6; .set t_best_7,5
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
        lqa     $k_half_double,doubles+64               # 5o
        iohl    $m_y,0x607                              # 6e
        iohl    $m_z,0xa0b                              # 7e
        iohl    $m_radius2,0xe0f                        # 8e
        ila     $a_merges,merges                        # 9e
        ilhu    $k_half,0x3f00                          # 10e
        ilhu    $k_one,0x3f80                           # 11e
        ilhu    $k_tiny,896                             # 12e
        lnop                                            # 12o pairing
next_pair:
        ai      $count,$count,-1                        # 0e
        lqd     $object,0($a_pair)                      # 0o
        ai      $a_pair,$a_pair,16                      # 1e
        lqd     $quad,0($object)                        # 6o
        rotqbyi $a_packet,$object,4                     # 7o
        shufb   $object,$object,$object,$m_x            # 8o
        lqd     $dx,32($a_packet)                       # 11o
        lqd     $dx_2,16($a_packet)                     # 12o
        lqd     $dx_3,0($a_packet)                      # 13o
        lqd     $dy,96($a_packet)                       # 14o
        lqd     $dx_4,48($a_packet)                     # 15o
        lqd     $dy_2,80($a_packet)                     # 16o
        rotqbyi $ex,$dx,0                               # 17o
        rotqbyi $ex_2,$dx_2,0                           # 18o
        shufb   $cx,$quad,$quad,$m_x                    # 19o
        rotqbyi $ey,$dy,0                               # 20o
        fesd    $ex,$ex                                 # 21e
        fesd    $cx,$cx                                 # 28e
        fesd    $ex_2,$ex_2                             # 35e
        lnop                                            # 42o pairing
        ori     $lx,$cx,0                               # 43e
        rotqbyi $ey_2,$dy_2,0                           # 43o
        ori     $lx_2,$cx,0                             # 44e
        rotqbyi $ex_3,$dx_3,0                           # 44o
        ori     $lx_3,$cx,0                             # 45e
        shufb   $cz_2,$quad,$quad,$m_z                  # 45o
        fesd    $ey,$ey                                 # 46e
        fesd    $ex_3,$ex_3                             # 53e
        ori     $lx_4,$cx,0                             # 60e
        rotqbyi $ex_4,$dx_3,4                           # 60o
        ori     $lx_5,$cx,0                             # 61e
        rotqbyi $ex_5,$dx_2,4                           # 61o
        ori     $lx_6,$cx,0                             # 62e
        rotqbyi $ex_6,$dx_4,4                           # 62o
        ori     $lx_7,$cx,0                             # 63e
        shufb   $cy_2,$quad,$quad,$m_y                  # 63o
        fesd    $ex_4,$ex_4                             # 64e
        fesd    $ex_5,$ex_5                             # 71e
        fesd    $cy_2,$cy_2                             # 78e
        dfm     $b_2,$lx_7,$ex                          # 85e
        ori     $ly_2,$cy_2,0                           # 92e
        rotqbyi $ex_7,$dx,4                             # 92o
        ori     $ly_3,$cy_2,0                           # 93e
        rotqbyi $ey_3,$dy_2,4                           # 93o
        dfm     $b_3,$lx_4,$ex_3                        # 94e
        fesd    $ey_3,$ey_3                             # 101e
        fesd    $ex_7,$ex_7                             # 108e
        lnop                                            # 115o pairing
        ori     $ly_4,$cy_2,0                           # 116e
        lqd     $dz_2,176($a_packet)                    # 116o
        ori     $ly_5,$cy_2,0                           # 117e
        lqd     $dy_3,64($a_packet)                     # 117o
        fesd    $ex_6,$ex_6                             # 118e
        dfm     $b_4,$lx_5,$ex_7                        # 125e
        fesd    $ey_2,$ey_2                             # 132e
        dfm     $b_5,$lx_6,$ex_5                        # 139e
        ori     $ly_6,$cy_2,0                           # 146e
        rotqbyi $ey_4,$dy_3,0                           # 146o
        ori     $ly_7,$cy_2,0                           # 147e
        rotqbyi $ey_5,$dy_3,4                           # 147o
        dfm     $b_6,$lx,$ex_4                          # 148e
        fesd    $ey_4,$ey_4                             # 155e
        fesd    $ey_5,$ey_5                             # 162e
        dfma    $b_3,$ly_4,$ey_4                        # 169e
        dfma    $b_6,$ly_3,$ey_5                        # 176e
        dfma    $b_5,$ly_7,$ey_3                        # 183e
        dfm     $b_7,$lx_3,$ex_2                        # 190e
        lnop                                            # 197o pairing
        ori     $ly_8,$cy_2,0                           # 198e
        rotqbyi $ey_6,$dy,4                             # 198o
        ori     $ly_9,$cy_2,0                           # 199e
        rotqbyi $ex_8,$dx_4,0                           # 199o
        fesd    $cz_2,$cz_2                             # 200e
        fesd    $ex_8,$ex_8                             # 207e
        dfma    $b_7,$ly_9,$ey_2                        # 214e
        dfm     $b_8,$lx_2,$ex_8                        # 221e
        fesd    $ey_6,$ey_6                             # 228e
        lnop                                            # 235o pairing
        ori     $lz_2,$cz_2,0                           # 236e
        lqd     $dz_3,144($a_packet)                    # 236o
        ori     $lz_3,$cz_2,0                           # 237e
        lqd     $dz_4,160($a_packet)                    # 237o
        ori     $lz_4,$cz_2,0                           # 238e
        lqd     $dy_4,112($a_packet)                    # 238o
        ori     $lz_5,$cz_2,0                           # 239e
        lqd     $dz_5,128($a_packet)                    # 239o
        ori     $lz_6,$cz_2,0                           # 240e
        rotqbyi $ez_2,$dz_2,0                           # 240o
        ori     $lx_8,$cx,0                             # 241e
        shufb   $radius2_2,$quad,$quad,$m_radius2       # 241o
        dfma    $b_4,$ly_2,$ey_6                        # 242e
        dfm     $b_9,$lx_8,$ex_6                        # 249e
        dfma    $b_2,$ly_8,$ey                          # 256e
        lnop                                            # 263o pairing
        ori     $lz_7,$cz_2,0                           # 264e
        rotqbyi $ez_3,$dz_4,4                           # 264o
        fesd    $ez_2,$ez_2                             # 265e
        fesd    $ez_3,$ez_3                             # 272e
        ori     $lz_8,$cz_2,0                           # 279e
        rotqbyi $ez_4,$dz_3,0                           # 279o
        fesd    $radius2_2,$radius2_2                   # 280e
        fesd    $ez_4,$ez_4                             # 287e
        dfma    $b_4,$lz_2,$ez_3                        # 294e
        dfma    $b_7,$lz_5,$ez_4                        # 301e
        ori     $disc_2,$radius2_2,0                    # 308e
        rotqbyi $ez_5,$dz_4,0                           # 308o
        ori     $disc_3,$radius2_2,0                    # 309e
        rotqbyi $ey_7,$dy_4,0                           # 309o
        dfnms   $lx_5,$b_4,$ex_7                        # 310e
        fesd    $ez_5,$ez_5                             # 317e
        fesd    $ey_7,$ey_7                             # 324e
        dfnms   $lx_3,$b_7,$ex_2                        # 331e
        dfma    $b_8,$ly_5,$ey_7                        # 338e
        dfnms   $ly_9,$b_7,$ey_2                        # 345e
        dfma    $b_2,$lz_6,$ez_5                        # 352e
        lnop                                            # 359o pairing
        ori     $disc_4,$radius2_2,0                    # 360e
        rotqbyi $ey_8,$dy_4,4                           # 360o
        ori     $lz_9,$cz_2,0                           # 361e
        rotqbyi $ez_6,$dz_5,0                           # 361o
        ori     $disc_5,$radius2_2,0                    # 362e
        rotqbyi $ez_7,$dz_3,4                           # 362o
        dfm     $e_2,$lx_3,$ex_2                        # 363e
        fesd    $ey_8,$ey_8                             # 370e
        fesd    $ez_6,$ez_6                             # 377e
        fesd    $ez_7,$ez_7                             # 384e
        dfma    $b_3,$lz_4,$ez_6                        # 391e
        dfnms   $lx_7,$b_2,$ex                          # 398e
        dfnms   $lx_4,$b_3,$ex_3                        # 405e
        dfma    $b_9,$ly_6,$ey_8                        # 412e
        dfma    $b_5,$lz_8,$ez_7                        # 419e
        dfm     $e_3,$lx_7,$ex                          # 426e
        dfnms   $ly_4,$b_3,$ey_4                        # 433e
        dfnms   $disc_4,$lx_7,$lx_7                     # 440e
        dfnms   $lx_6,$b_5,$ex_5                        # 447e
        dfm     $e_4,$lx_4,$ex_3                        # 454e
        dfm     $e_5,$lx_6,$ex_5                        # 461e
        dfnms   $lz_8,$b_5,$ez_7                        # 468e
        dfnms   $ly_8,$b_2,$ey                          # 475e
        dfnms   $lz_4,$b_3,$ez_6                        # 482e
        dfnms   $disc_4,$ly_8,$ly_8                     # 489e
        dfma    $e_4,$ly_4,$ey_4                        # 496e
        dfma    $e_2,$ly_9,$ey_2                        # 503e
        dfnms   $lz_6,$b_2,$ez_5                        # 510e
        dfma    $b_8,$lz_9,$ez_2                        # 517e
        lnop                                            # 524o pairing
        ori     $disc_6,$radius2_2,0                    # 525e
        rotqbyi $ez_8,$dz_5,4                           # 525o
        ori     $disc_7,$radius2_2,0                    # 526e
        rotqbyi $ez_9,$dz_2,4                           # 526o
        dfnms   $disc_2,$lx_6,$lx_6                     # 527e
        fesd    $ez_10,$ez_9                            # 534e
        fesd    $ez_8,$ez_8                             # 541e
        dfnms   $lx_2,$b_8,$ex_8                        # 548e
        dfma    $b_6,$lz_3,$ez_8                        # 555e
        dfma    $b_9,$lz_7,$ez_10                       # 562e
        dfnms   $lx,$b_6,$ex_4                          # 569e
        dfnms   $disc_7,$lx_2,$lx_2                     # 576e
        dfnms   $ly_5,$b_8,$ey_7                        # 583e
        dfnms   $ly_2,$b_4,$ey_6                        # 590e
        dfnms   $ly_3,$b_6,$ey_5                        # 597e
        dfm     $e_6,$lx_5,$ex_7                        # 604e
        dfnms   $disc_3,$lx_4,$lx_4                     # 611e
        dfma    $e_6,$ly_2,$ey_6                        # 618e
        dfnms   $lz_5,$b_7,$ez_4                        # 625e
        dfnms   $lz_3,$b_6,$ez_8                        # 632e
        dfnms   $lx_8,$b_9,$ex_6                        # 639e
        dfnms   $disc_3,$ly_4,$ly_4                     # 646e
        dfm     $e_7,$lx_8,$ex_6                        # 653e
        dfnms   $disc_5,$lx_8,$lx_8                     # 660e
        ori     $disc_8,$radius2_2,0                    # 667e
        lqd     $t_best_2,224($a_packet)                # 667o
        dfnms   $disc_6,$lx_3,$lx_3                     # 668e
        dfnms   $disc_8,$lx,$lx                         # 675e
        dfm     $e_8,$lx,$ex_4                          # 682e
        dfnms   $disc_8,$ly_3,$ly_3                     # 689e
        dfma    $e_8,$ly_3,$ey_5                        # 696e
        lnop                                            # 703o pairing
        ori     $disc_9,$radius2_2,0                    # 704e
        lqd     $t_best_3,208($a_packet)                # 704o
        dfnms   $disc_8,$lz_3,$lz_3                     # 705e
        dfnms   $disc_9,$lx_5,$lx_5                     # 712e
        dfnms   $ly_7,$b_5,$ey_3                        # 719e
        dfnms   $lz_9,$b_8,$ez_2                        # 726e
        dfnms   $disc_2,$ly_7,$ly_7                     # 733e
        dfm     $e_9,$lx_2,$ex_8                        # 740e
        dfma    $e_5,$ly_7,$ey_3                        # 747e
        dfnms   $ly_6,$b_9,$ey_8                        # 754e
        dfma    $e_4,$lz_4,$ez_6                        # 761e
        dfma    $e_7,$ly_6,$ey_8                        # 768e
        dfnms   $disc_6,$ly_9,$ly_9                     # 775e
        dfnms   $disc_9,$ly_2,$ly_2                     # 782e
        dfnms   $disc_7,$ly_5,$ly_5                     # 789e
        dfma    $e_3,$ly_8,$ey                          # 796e
        dfma    $e_5,$lz_8,$ez_7                        # 803e
        dfnms   $disc_3,$lz_4,$lz_4                     # 810e
        dfnms   $lz_2,$b_4,$ez_3                        # 817e
        dfma    $e_9,$ly_5,$ey_7                        # 824e
        dfma    $e_6,$lz_2,$ez_3                        # 831e
        dfnms   $disc_9,$lz_2,$lz_2                     # 838e
        dfnms   $disc_7,$lz_9,$lz_9                     # 845e
        dfnms   $disc_5,$ly_6,$ly_6                     # 852e
        dfnms   $disc_2,$lz_8,$lz_8                     # 859e
        dfnms   $lz_7,$b_9,$ez_10                       # 866e
        dfma    $disc_2,$e_5,$e_5                       # 873e
        dfma    $e_7,$lz_7,$ez_10                       # 880e
        dfnms   $disc_4,$lz_6,$lz_6                     # 887e
        frds    $x,$disc_2                              # 894e
        dfma    $disc_3,$e_4,$e_4                       # 901e
        dfma    $e_8,$lz_3,$ez_8                        # 908e
        dfma    $e_9,$lz_9,$ez_2                        # 915e
        dfma    $disc_8,$e_8,$e_8                       # 922e
        dfnms   $disc_6,$lz_5,$lz_5                     # 929e
        dfma    $e_3,$lz_6,$ez_5                        # 936e
        dfma    $e_2,$lz_5,$ez_4                        # 943e
        dfma    $disc_4,$e_3,$e_3                       # 950e
        dfnms   $disc_5,$lz_7,$lz_7                     # 957e
        dfma    $disc_6,$e_2,$e_2                       # 964e
        dfma    $disc_5,$e_7,$e_7                       # 971e
        frds    $x_2,$disc_6                            # 978e
        dfma    $disc_9,$e_6,$e_6                       # 985e
        lnop                                            # 992o pairing
        fa      $near,$x_2,$k_tiny                      # 993e
        lqd     $t_best,240($a_packet)                  # 993o
        frds    $x_2,$disc_4                            # 994e
        frds    $x_3,$disc_9                            # 1001e
        fa      $near_2,$x_2,$k_tiny                    # 1008e
        frsqest $y,$near                                # 1008o
        dfma    $disc_7,$e_9,$e_9                       # 1009e
        frds    $x_4,$disc_8                            # 1016e
        fi      $y,$near,$y                             # 1023e
        frsqest $y_2,$near_2                            # 1023o
        frds    $x_5,$disc_5                            # 1024e
        frds    $x_6,$disc_3                            # 1031e
        fm      $e_10,$near,$y                          # 1038e
        lqd     $nearest_2,288($a_packet)               # 1038o
        fi      $y_2,$near_2,$y_2                       # 1039e
        lqd     $t_best_4,192($a_packet)                # 1039o
        frds    $x_7,$disc_7                            # 1040e
        lnop                                            # 1047o pairing
        fa      $near_3,$x_6,$k_tiny                    # 1048e
        lqd     $nearest_3,304($a_packet)               # 1048o
        fa      $near_4,$x_5,$k_tiny                    # 1049e
        lqd     $nearest_4,272($a_packet)               # 1049o
        fa      $near_5,$x,$k_tiny                      # 1050e
        lqd     $nearest_5,256($a_packet)               # 1050o
        fm      $w_2,$y,$k_half                         # 1051e
        fa      $near_6,$x_3,$k_tiny                    # 1052e
        fa      $near_7,$x_4,$k_tiny                    # 1053e
        lnop                                            # 1053o pairing
        fa      $near_8,$x_7,$k_tiny                    # 1054e
        frsqest $y_3,$near_3                            # 1054o
        fnms    $e_10,$e_10,$y,$k_one                   # 1055e
        frsqest $y_4,$near_4                            # 1055o
        fm      $w_3,$y_2,$k_half                       # 1056e
        frsqest $y_5,$near_5                            # 1056o
        fm      $e_11,$near_2,$y_2                      # 1057e
        lnop                                            # 1057o pairing
        fi      $y_3,$near_3,$y_3                       # 1058e
        frsqest $y_6,$near_6                            # 1058o
        fi      $y_4,$near_4,$y_4                       # 1059e
        frsqest $y_7,$near_7                            # 1059o
        fi      $y_5,$near_5,$y_5                       # 1060e
        frsqest $y_8,$near_8                            # 1060o
        ori     $e_12,$disc_3,0                         # 1061e
        fi      $y_6,$near_6,$y_6                       # 1062e
        fi      $y_7,$near_7,$y_7                       # 1063e
        fi      $y_8,$near_8,$y_8                       # 1064e
        ori     $e_13,$disc_8,0                         # 1065e
        fm      $e_14,$near_3,$y_3                      # 1066e
        fm      $e_15,$near_5,$y_5                      # 1067e
        fnms    $e_11,$e_11,$y_2,$k_one                 # 1068e
        fm      $w_4,$y_5,$k_half                       # 1069e
        fm      $e_16,$near_7,$y_7                      # 1070e
        fm      $w_5,$y_7,$k_half                       # 1071e
        fnms    $e_14,$e_14,$y_3,$k_one                 # 1072e
        fma     $w_6,$e_10,$w_2,$y                      # 1073e
        fnms    $e_17,$e_15,$y_5,$k_one                 # 1074e
        fm      $w_2,$y_4,$k_half                       # 1075e
        fnms    $e_15,$e_16,$y_7,$k_one                 # 1076e
        fm      $w_7,$y_8,$k_half                       # 1077e
        fm      $e_18,$near_6,$y_6                      # 1078e
        fesd    $y_9,$w_6                               # 1079e
        fma     $w_8,$e_15,$w_5,$y_7                    # 1086e
        fma     $w_9,$e_17,$w_4,$y_5                    # 1087e
        fnms    $e_19,$e_18,$y_6,$k_one                 # 1088e
        fm      $e_15,$near_4,$y_4                      # 1089e
        fm      $w_4,$y_3,$k_half                       # 1090e
        fm      $w_5,$y_6,$k_half                       # 1091e
        fesd    $y_7,$w_8                               # 1092e
        fma     $w_10,$e_14,$w_4,$y_3                   # 1099e
        fma     $w_11,$e_19,$w_5,$y_6                   # 1100e
        fesd    $y,$w_9                                 # 1101e
        fesd    $y_3,$w_10                              # 1108e
        dfm     $s_2,$disc_8,$y_7                       # 1115e
        fma     $w_12,$e_11,$w_3,$y_2                   # 1122e
        fesd    $y_10,$w_11                             # 1123e
        fesd    $y_2,$w_12                              # 1130e
        dfm     $s_3,$disc_9,$y_10                      # 1137e
        dfm     $s_4,$disc_4,$y_2                       # 1144e
        fm      $e_14,$near_8,$y_8                      # 1151e
        dfm     $s_5,$disc_3,$y_3                       # 1152e
        fnms    $e_14,$e_14,$y_8,$k_one                 # 1159e
        dfm     $s_6,$disc_2,$y                         # 1160e
        dfnms   $e_12,$s_5,$s_5                         # 1167e
        fma     $w_13,$e_14,$w_7,$y_8                   # 1174e
        dfm     $s_7,$disc_6,$y_9                       # 1175e
        fnms    $e_15,$e_15,$y_4,$k_one                 # 1182e
        dfma    $b_2,$e_3,$k_half_double                # 1183e
        dfma    $b_7,$e_2,$k_half_double                # 1190e
        ori     $e_2,$disc_7,0                          # 1197e
        fma     $w_14,$e_15,$w_2,$y_4                   # 1198e
        dfma    $b_3,$e_4,$k_half_double                # 1199e
        fesd    $y_11,$w_14                             # 1206e
        ori     $e_3,$disc_4,0                          # 1213e
        fesd    $y_12,$w_13                             # 1214e
        dfm     $s_8,$disc_5,$y_11                      # 1221e
        dfm     $s_9,$disc_7,$y_12                      # 1228e
        ori     $e_15,$disc_2,0                         # 1235e
        dfnms   $e_3,$s_4,$s_4                          # 1236e
        a       $y_3,$y_3,$k_halve                      # 1243e
        dfma    $b_8,$e_9,$k_half_double                # 1244e
        ori     $e_9,$disc_6,0                          # 1251e
        dfnms   $e_13,$s_2,$s_2                         # 1252e
        dfnms   $e_9,$s_7,$s_7                          # 1259e
        ori     $e_16,$disc_9,0                         # 1266e
        a       $y_10,$y_10,$k_halve                    # 1267e
        dfnms   $e_16,$s_3,$s_3                         # 1268e
        dfma    $b_4,$e_6,$k_half_double                # 1275e
        dfma    $s_3,$e_16,$y_10                        # 1282e
        ori     $e_6,$disc_5,0                          # 1289e
        dfma    $b_5,$e_5,$k_half_double                # 1290e
        dfnms   $e_6,$s_8,$s_8                          # 1297e
        dfnms   $e_15,$s_6,$s_6                         # 1304e
        dfnms   $e_2,$s_9,$s_9                          # 1311e
        dfma    $b_9,$e_7,$k_half_double                # 1318e
        dfma    $s_5,$e_12,$y_3                         # 1325e
        dfma    $b_6,$e_8,$k_half_double                # 1332e
        selb    $s_10,$s_5,$b_3,$m_sign                 # 1339e
        a       $y,$y,$k_halve                          # 1340e
        dfa     $q_2,$b_3,$s_10                         # 1341e
        dfma    $s_6,$e_15,$y                           # 1348e
        a       $y,$y_7,$k_halve                        # 1355e
        a       $y_13,$y_2,$k_halve                     # 1356e
        dfma    $s_2,$e_13,$y                           # 1357e
        selb    $s_11,$s_6,$b_5,$m_sign                 # 1364e
        dfma    $s_4,$e_3,$y_13                         # 1365e
        selb    $s_12,$s_2,$b_6,$m_sign                 # 1372e
        dfa     $q_3,$b_5,$s_11                         # 1373e
        selb    $s_13,$s_4,$b_2,$m_sign                 # 1380e
        a       $y,$y_9,$k_halve                        # 1381e
        a       $y_11,$y_11,$k_halve                    # 1382e
        dfma    $s_7,$e_9,$y                            # 1383e
        dfa     $q_4,$b_6,$s_12                         # 1390e
        dfma    $s_8,$e_6,$y_11                         # 1397e
        frds    $x_8,$q_4                               # 1404e
        selb    $s_14,$s_8,$b_9,$m_sign                 # 1411e
        frds    $x_9,$q_3                               # 1412e
        selb    $s_15,$s_3,$b_4,$m_sign                 # 1419e
        selb    $s_16,$s_7,$b_7,$m_sign                 # 1420e
        dfa     $q_5,$b_4,$s_15                         # 1421e
        dfa     $q_6,$b_7,$s_16                         # 1428e
        frds    $x_10,$q_5                              # 1435e
        dfa     $q_7,$b_2,$s_13                         # 1442e
        a       $y_12,$y_12,$k_halve                    # 1449e
        fa      $x_8,$x_8,$k_tiny                       # 1450e
        dfma    $s_9,$e_2,$y_12                         # 1451e
        frds    $x_11,$q_2                              # 1458e
        selb    $s_17,$s_9,$b_8,$m_sign                 # 1465e
        frest   $y_3,$x_8                               # 1465o
        frds    $x_12,$q_7                              # 1466e
        fa      $x_11,$x_11,$k_tiny                     # 1473e
        fi      $y_3,$x_8,$y_3                          # 1474e
        frds    $x_13,$q_6                              # 1475e
        dfa     $q_8,$b_9,$s_14                         # 1482e
        lnop                                            # 1489o pairing
        fa      $x_13,$x_13,$k_tiny                     # 1490e
        frest   $y_5,$x_11                              # 1490o
        fa      $x_12,$x_12,$k_tiny                     # 1491e
        dfa     $q_9,$b_8,$s_17                         # 1492e
        fi      $y_5,$x_11,$y_5                         # 1499e
        frest   $y_14,$x_13                             # 1499o
        ori     $cc_2,$disc_6,0                         # 1500e
        frest   $y_6,$x_12                              # 1500o
        fa      $x_10,$x_10,$k_tiny                     # 1501e
        fa      $x_9,$x_9,$k_tiny                       # 1502e
        fi      $y_14,$x_13,$y_14                       # 1503e
        frds    $x_14,$q_8                              # 1504e
        frds    $x_15,$q_9                              # 1511e
        lnop                                            # 1518o pairing
        fa      $x_14,$x_14,$k_tiny                     # 1519e
        frest   $y_15,$x_9                              # 1519o
        fnms    $e_2,$x_11,$y_5,$k_one                  # 1520e
        frest   $y_16,$x_10                             # 1520o
        fnms    $e_20,$x_13,$y_14,$k_one                # 1521e
        ori     $cc_3,$disc_9,0                         # 1522e
        fi      $y_15,$x_9,$y_15                        # 1523e
        fi      $y_16,$x_10,$y_16                       # 1524e
        fi      $y_6,$x_12,$y_6                         # 1525e
        frest   $y_17,$x_14                             # 1525o
        dfms    $cc_3,$b_4,$b_4                         # 1526e
        fnms    $e_3,$x_10,$y_16,$k_one                 # 1533e
        fi      $y_17,$x_14,$y_17                       # 1534e
        ori     $cc_4,$disc_8,0                         # 1535e
        fma     $w_3,$e_20,$y_14,$y_14                  # 1536e
        fnms    $e_6,$x_9,$y_15,$k_one                  # 1537e
        fnms    $e_21,$x_12,$y_6,$k_one                 # 1538e
        fa      $x_16,$x_15,$k_tiny                     # 1539e
        fnms    $e_9,$x_8,$y_3,$k_one                   # 1540e
        dfms    $cc_2,$b_7,$b_7                         # 1541e
        fesd    $y_10,$w_3                              # 1548e
        lnop                                            # 1555o pairing
        fma     $w_15,$e_21,$y_6,$y_6                   # 1556e
        frest   $y_6,$x_16                              # 1556o
        ori     $cc_5,$disc_3,0                         # 1557e
        fma     $w_16,$e_2,$y_5,$y_5                    # 1558e
        dfms    $cc_4,$b_6,$b_6                         # 1559e
        fesd    $y_18,$w_16                             # 1566e
        fi      $y_5,$x_16,$y_6                         # 1573e
        fesd    $y_4,$w_15                              # 1574e
        fma     $w_14,$e_3,$y_16,$y_16                  # 1581e
        fma     $w_17,$e_6,$y_15,$y_15                  # 1582e
        ori     $cc_6,$disc_7,0                         # 1583e
        dfms    $cc_5,$b_3,$b_3                         # 1584e
        fma     $w_18,$e_9,$y_3,$y_3                    # 1591e
        fesd    $y_19,$w_14                             # 1592e
        fesd    $y_20,$w_18                             # 1599e
        dfm     $t_2,$cc_3,$y_19                        # 1606e
        ori     $cc_7,$disc_2,0                         # 1613e
        ori     $cc_8,$disc_4,0                         # 1614e
        dfms    $cc_7,$b_5,$b_5                         # 1615e
        dfms    $cc_8,$b_2,$b_2                         # 1622e
        fnms    $e_22,$x_14,$y_17,$k_one                # 1629e
        fnms    $e_11,$x_16,$y_5,$k_one                 # 1630e
        dfm     $t_3,$cc_2,$y_10                        # 1631e
        fma     $w_11,$e_11,$y_5,$y_5                   # 1638e
        fma     $w_19,$e_22,$y_17,$y_17                 # 1639e
        fesd    $y_21,$w_17                             # 1640e
        ori     $e_22,$cc_8,0                           # 1647e
        fesd    $y_5,$w_11                              # 1648e
        dfm     $t_4,$cc_7,$y_21                        # 1655e
        ori     $cc_9,$disc_5,0                         # 1662e
        dfm     $t_5,$cc_4,$y_20                        # 1663e
        dfms    $cc_9,$b_9,$b_9                         # 1670e
        dfms    $cc_6,$b_8,$b_8                         # 1677e
        dfm     $t_6,$cc_8,$y_4                         # 1684e
        dfm     $t_7,$cc_6,$y_5                         # 1691e
        dfm     $t_8,$cc_5,$y_18                        # 1698e
        fesd    $y_14,$w_19                             # 1705e
        ori     $e_23,$cc_3,0                           # 1712e
        ori     $e_24,$cc_4,0                           # 1713e
        ori     $e_25,$cc_5,0                           # 1714e
        dfnms   $e_24,$q_4,$t_5                         # 1715e
        dfnms   $e_25,$q_2,$t_8                         # 1722e
        dfm     $t_9,$cc_9,$y_14                        # 1729e
        dfma    $t_5,$e_24,$y_20                        # 1736e
        dfma    $t_8,$e_25,$y_18                        # 1743e
        ori     $e_8,$cc_2,0                            # 1750e
        dfnms   $e_23,$q_5,$t_2                         # 1751e
        dfnms   $e_8,$q_6,$t_3                          # 1758e
        dfma    $t_2,$e_23,$y_19                        # 1765e
        dfma    $t_3,$e_8,$y_10                         # 1772e
        ori     $e_8,$cc_7,0                            # 1779e
        frds    $t_10,$t_2                              # 1780e
        dfnms   $e_8,$q_3,$t_4                          # 1787e
        dfnms   $e_22,$q_7,$t_6                         # 1794e
        dfma    $t_4,$e_8,$y_21                         # 1801e
        dfma    $t_6,$e_22,$y_4                         # 1808e
        frds    $t_11,$t_5                              # 1815e
        ori     $e_2,$cc_6,0                            # 1822e
        or      $disc_even,$near_2,$b_2                 # 1823e
        ori     $e_26,$cc_9,0                           # 1824e
        frds    $t_even_2,$t_8                          # 1825e
        dfnms   $e_26,$q_8,$t_9                         # 1832e
        frds    $t_12,$t_4                              # 1839e
        dfnms   $e_2,$q_9,$t_7                          # 1846e
        frds    $t_even_3,$t_6                          # 1853e
        dfma    $t_7,$e_2,$y_5                          # 1860e
        or      $disc_even_2,$near,$b_7                 # 1867e
        shufb   $t,$t_even_3,$t_10,$m_rows              # 1867o
        dfma    $t_9,$e_26,$y_14                        # 1868e
        frds    $t_even_4,$t_7                          # 1875e
        frds    $t_9,$t_9                               # 1882e
        lnop                                            # 1889o pairing
        clgt    $hit_2,$t_best_2,$t                     # 1890e
        shufb   $t_11,$t_even_2,$t_11,$m_rows           # 1890o
        or      $disc,$near_6,$b_4                      # 1891e
        frds    $t_even_2,$t_3                          # 1892e
        clgt    $hit_3,$t_best_4,$t_11                  # 1899e
        shufb   $disc,$disc_even,$disc,$m_rows          # 1899o
        or      $disc_8,$near_5,$b_5                    # 1900e
        shufb   $t_9,$t_even_4,$t_9,$m_rows             # 1900o
        or      $disc_even,$near_8,$b_8                 # 1901e
        lnop                                            # 1901o pairing
        or      $disc_10,$near_7,$b_6                   # 1902e
        shufb   $disc_11,$disc_even_2,$disc_8,$m_rows   # 1902o
        andc    $hit,$hit_2,$disc                       # 1903e
        or      $disc_even_3,$near_3,$b_3               # 1904e
        clgt    $hit_4,$t_best,$t_9                     # 1905e
        shufb   $t_13,$t_even_2,$t_12,$m_rows           # 1905o
        or      $disc,$near_4,$b_9                      # 1906e
        shufb   $disc_10,$disc_even_3,$disc_10,$m_rows  # 1906o
        rotqbii $hit,$hit,1                             # 1907o
        shufb   $disc,$disc_even,$disc,$m_rows          # 1908o
        clgt    $hit_2,$t_best_3,$t_13                  # 1909e
        andc    $hit_5,$hit_3,$disc_10                  # 1910e
        andc    $hit_2,$hit_2,$disc_11                  # 1911e
        gb      $hit,$hit                               # 1911o
        andc    $hit_6,$hit_4,$disc                     # 1912e
        rotqbii $hit_5,$hit_5,1                         # 1912o
        rotqbii $hit_2,$hit_2,1                         # 1913o
        rotqbii $hit_6,$hit_6,1                         # 1914o
        shlqbii $hit,$hit,4                             # 1915o
        gb      $hit_5,$hit_5                           # 1916o
        gb      $hit_2,$hit_2                           # 1917o
        gb      $hit_6,$hit_6                           # 1918o
        lqx     $merge,$a_merges,$hit                   # 1919o
        shlqbii $hit,$hit_5,4                           # 1920o
        shlqbii $hit_5,$hit_2,4                         # 1921o
        shlqbii $hit_2,$hit_6,4                         # 1922o
        lqx     $merge_2,$a_merges,$hit                 # 1924o
        lqx     $merge_3,$a_merges,$hit_5               # 1925o
        shufb   $nearest,$nearest_2,$object,$merge      # 1926o
        lqx     $merge_4,$a_merges,$hit_2               # 1927o
        shufb   $t_best_5,$t_best_2,$t,$merge           # 1928o
        shufb   $nearest_6,$nearest_5,$object,$merge_2  # 1930o
        shufb   $nearest_7,$nearest_4,$object,$merge_3  # 1931o
        stqd    $t_best_5,224($a_packet)                # 1932o
        shufb   $t_best,$t_best,$t_9,$merge_4           # 1933o
        stqd    $nearest_6,256($a_packet)               # 1934o
        shufb   $t_best_6,$t_best_3,$t_13,$merge_3      # 1935o
        shufb   $nearest_8,$nearest_3,$object,$merge_4  # 1936o
        stqd    $nearest_7,272($a_packet)               # 1937o
        shufb   $t_best_7,$t_best_4,$t_11,$merge_2      # 1938o
        stqd    $t_best_6,208($a_packet)                # 1939o
        stqd    $nearest_8,304($a_packet)               # 1940o
        stqd    $nearest,288($a_packet)                 # 1941o
        stqd    $t_best_7,192($a_packet)                # 1942o
        hbrr    next_pair_back,next_pair                # 1943o hint
        stqd    $t_best,240($a_packet)                  # 1944o
        nop     $127                                    # 1945e pairing
next_pair_back:
        brnz    $count,next_pair                        # 1945o
        nop     $127                                    # 1946e pairing
        bi      $lr                                     # 1946o
endfunction isect_pairs_double_r16
