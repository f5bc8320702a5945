# isect_pairs_double_r16   nearest entries of primary rays into spheres, in double precision
#   C       void isect_pairs_double_r16(const struct pair *, int count);
#   In      $3 pairs, $4 count (0 is none); pointers 16-aligned
#   Out     the pairs' packets: t, object, where an entry is nearer than what was there
#   Uses    $2-$76   Saves  -   Stack  0   Calls  -
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
        .set dx_2,2; .set dx_3,5; .set dx_4,6; .set ex_2,7; .set ex_3,8; .set lx_2,9; .set ex_4,13
        .set lx_3,27; .set ex_5,28; .set lx_4,29; .set cy_2,30; .set b_2,32; .set cz_2,33
        .set ly_2,34; .set ex_6,2; .set lx_5,38; .set lx_6,39; .set dz_2,40; .set b_3,41
        .set b_4,42; .set b_5,45; .set lz_2,46; .set ex_7,5; .set lz_3,47; .set ex_8,6
        .set lx_7,48; .set ey_2,31; .set b_6,49; .set b_7,50; .set ly_3,51; .set dy_2,52
        .set ly_4,53; .set dy_3,54; .set ly_5,55; .set ez_2,56; .set lz_4,57; .set dz_3,58
        .set lz_5,59; .set ey_3,60; .set ly_6,61; .set ey_4,62; .set ly_7,63; .set ez_3,64
        .set lx_8,26; .set ey_5,54; .set lz_6,65; .set ey_6,52; .set lz_7,66; .set dy_4,67
        .set b_8,68; .set lz_8,69; .set ey_7,70; .set ly_8,30; .set ey_8,67; .set lz_9,33
        .set ez_4,58; .set e_2,7; .set e_3,8; .set e_4,43; .set dz_4,31; .set ez_5,40
        .set radius2_2,25; .set dz_5,44; .set t_best_2,56; .set disc_2,58; .set ez_6,60
        .set disc_3,64; .set ez_7,71; .set disc_4,72; .set ez_8,31; .set disc_5,73; .set ez_9,44
        .set e_5,28; .set e_6,2; .set e_7,6; .set disc_6,62; .set t_best_3,74; .set t_best_4,9
        .set disc_7,29; .set nearest_2,36; .set e_8,5; .set disc_8,25; .set t_best_5,37
        .set e_9,13; .set x_2,7; .set x_3,8; .set x_4,26; .set x_5,27; .set x_6,30; .set near_2,27
        .set near_3,8; .set nearest_3,31; .set near_4,33; .set nearest_4,38; .set y_2,43
        .set e_10,44; .set y_3,48; .set near_5,26; .set y_4,51; .set near_6,30; .set e_11,52
        .set e_12,53; .set y_5,54; .set w_2,55; .set y_6,57; .set near_7,46; .set e_13,59
        .set w_3,60; .set e_14,61; .set y_7,63; .set e_15,65; .set e_16,66; .set e_17,67
        .set w_4,69; .set e_18,70; .set e_19,71; .set w_5,75; .set w_6,43; .set near_8,7
        .set w_7,40; .set e_20,55; .set w_8,65; .set w_9,51; .set y_8,53; .set y_9,55; .set w_10,57
        .set s_2,71; .set s_3,75; .set w_11,54; .set s_4,60; .set s_5,66; .set s_6,76; .set w_12,53
        .set s_7,57; .set w_13,59; .set y_10,59; .set s_8,28; .set s_9,63; .set e_21,69
        .set y_11,5; .set s_10,2; .set s_11,44; .set s_12,40; .set q_2,5; .set q_3,40; .set y_12,44
        .set s_13,13; .set s_14,6; .set x_7,44; .set q_4,28; .set q_5,2; .set x_8,48; .set x_9,51
        .set s_15,52; .set q_6,6; .set q_7,52; .set x_10,54; .set x_11,43; .set x_12,53
        .set q_8,13; .set q_9,57; .set x_13,59; .set x_14,60; .set y_13,61; .set cc_2,63
        .set e_22,51; .set y_14,64; .set y_15,65; .set cc_3,66; .set y_16,67; .set y_17,69
        .set y_18,70; .set y_19,71; .set cc_4,39; .set e_23,48; .set cc_5,58; .set e_24,54
        .set w_14,44; .set cc_6,55; .set e_25,60; .set t_2,62; .set cc_7,29; .set y_20,60
        .set cc_8,61; .set t_3,64; .set t_4,61; .set cc_9,25; .set t_5,67; .set t_6,69; .set t_7,70
        .set e_26,29; .set e_27,63; .set e_28,39; .set t_8,6; .set e_29,25; .set t_9,28
        .set t_10,29; .set t_11,5; .set t_even_2,2; .set t_12,2; .set disc_even_2,8; .set hit_2,13
        .set disc_9,26; .set disc_10,8; .set hit_3,25; .set disc_11,7; .set hit_4,8; .set hit_5,7
        .set merge_2,8; .set merge_3,7; .set nearest_5,8; .set nearest_6,13; .set t_best_6,6
        .set t_best_7,5
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
        lqd     $dx,16($a_packet)                       # 11o
        lqd     $dx_2,0($a_packet)                      # 12o
        lqd     $dx_3,32($a_packet)                     # 13o
        lqd     $dy,80($a_packet)                       # 14o
        shufb   $cx,$quad,$quad,$m_x                    # 15o
        lqd     $dx_4,48($a_packet)                     # 16o
        rotqbyi $ex,$dx,0                               # 17o
        rotqbyi $ex_2,$dx_2,0                           # 18o
        fesd    $cx,$cx                                 # 19e
        fesd    $ex_2,$ex_2                             # 26e
        fesd    $ex,$ex                                 # 33e
        lnop                                            # 40o pairing
        ori     $lx,$cx,0                               # 41e
        rotqbyi $ex_3,$dx,4                             # 41o
        ori     $lx_2,$cx,0                             # 42e
        rotqbyi $ex_4,$dx_4,0                           # 42o
        ori     $lx_3,$cx,0                             # 43e
        rotqbyi $ex_5,$dx_3,0                           # 43o
        ori     $lx_4,$cx,0                             # 44e
        shufb   $cy_2,$quad,$quad,$m_y                  # 44o
        fesd    $ex_3,$ex_3                             # 45e
        fesd    $ex_5,$ex_5                             # 52e
        dfm     $b,$lx_4,$ex                            # 59e
        fesd    $cy_2,$cy_2                             # 66e
        dfm     $b_2,$lx,$ex_5                          # 73e
        lnop                                            # 80o pairing
        ori     $ly,$cy_2,0                             # 81e
        shufb   $cz_2,$quad,$quad,$m_z                  # 81o
        ori     $ly_2,$cy_2,0                           # 82e
        rotqbyi $ex_6,$dx_2,4                           # 82o
        ori     $lx_5,$cx,0                             # 83e
        rotqbyi $ey,$dy,4                               # 83o
        ori     $lx_6,$cx,0                             # 84e
        lqd     $dz_2,128($a_packet)                    # 84o
        fesd    $cz_2,$cz_2                             # 85e
        dfm     $b_3,$lx_6,$ex_2                        # 92e
        fesd    $ex_6,$ex_6                             # 99e
        fesd    $ey,$ey                                 # 106e
        dfm     $b_4,$lx_5,$ex_3                        # 113e
        dfm     $b_5,$lx_2,$ex_6                        # 120e
        ori     $lz_2,$cz_2,0                           # 127e
        rotqbyi $ex_7,$dx_3,4                           # 127o
        ori     $lz_3,$cz_2,0                           # 128e
        rotqbyi $ex_8,$dx_4,4                           # 128o
        ori     $lx_7,$cx,0                             # 129e
        rotqbyi $ey_2,$dy,0                             # 129o
        fesd    $ex_4,$ex_4                             # 130e
        fesd    $ex_7,$ex_7                             # 137e
        fesd    $ey_2,$ey_2                             # 144e
        fesd    $ex_8,$ex_8                             # 151e
        dfm     $b_6,$lx_3,$ex_4                        # 158e
        dfm     $b_7,$lx_7,$ex_7                        # 165e
        ori     $ly_3,$cy_2,0                           # 172e
        lqd     $dy_2,96($a_packet)                     # 172o
        ori     $ly_4,$cy_2,0                           # 173e
        lqd     $dy_3,64($a_packet)                     # 173o
        ori     $ly_5,$cy_2,0                           # 174e
        rotqbyi $ez_2,$dz_2,0                           # 174o
        ori     $lz_4,$cz_2,0                           # 175e
        lqd     $dz_3,144($a_packet)                    # 175o
        dfma    $b,$ly_5,$ey_2                          # 176e
        fesd    $ez_2,$ez_2                             # 183e
        ori     $lz_5,$cz_2,0                           # 190e
        rotqbyi $ey_3,$dy_3,0                           # 190o
        ori     $ly_6,$cy_2,0                           # 191e
        rotqbyi $ey_4,$dy_2,0                           # 191o
        ori     $ly_7,$cy_2,0                           # 192e
        rotqbyi $ez_3,$dz_3,4                           # 192o
        dfma    $b_4,$ly_6,$ey                          # 193e
        fesd    $ey_4,$ey_4                             # 200e
        fesd    $ey_3,$ey_3                             # 207e
        fesd    $ez_3,$ez_3                             # 214e
        dfma    $b_3,$ly_2,$ey_3                        # 221e
        dfma    $b_4,$lz_3,$ez_3                        # 228e
        dfma    $b_2,$ly,$ey_4                          # 235e
        lnop                                            # 242o pairing
        ori     $lx_8,$cx,0                             # 243e
        rotqbyi $ey_5,$dy_3,4                           # 243o
        ori     $lz_6,$cz_2,0                           # 244e
        rotqbyi $ey_6,$dy_2,4                           # 244o
        ori     $lz_7,$cz_2,0                           # 245e
        lqd     $dy_4,112($a_packet)                    # 245o
        dfm     $b_8,$lx_8,$ex_8                        # 246e
        fesd    $ey_5,$ey_5                             # 253e
        fesd    $ey_6,$ey_6                             # 260e
        dfma    $b_5,$ly_4,$ey_5                        # 267e
        dfma    $b_7,$ly_7,$ey_6                        # 274e
        dfnms   $lx_5,$b_4,$ex_3                        # 281e
        ori     $lz_8,$cz_2,0                           # 288e
        rotqbyi $ey_7,$dy_4,4                           # 288o
        ori     $ly_8,$cy_2,0                           # 289e
        rotqbyi $ey_8,$dy_4,0                           # 289o
        dfma    $b_3,$lz_6,$ez_2                        # 290e
        fesd    $ey_8,$ey_8                             # 297e
        fesd    $ey_7,$ey_7                             # 304e
        dfnms   $lx_6,$b_3,$ex_2                        # 311e
        dfma    $b_8,$ly_3,$ey_7                        # 318e
        dfma    $b_6,$ly_8,$ey_8                        # 325e
        ori     $lz_9,$cz_2,0                           # 332e
        rotqbyi $ez_4,$dz_3,0                           # 332o
        dfnms   $ly_2,$b_3,$ey_3                        # 333e
        fesd    $ez_4,$ez_4                             # 340e
        dfnms   $ly_6,$b_4,$ey                          # 347e
        dfma    $b,$lz_5,$ez_4                          # 354e
        dfm     $e_2,$lx_6,$ex_2                        # 361e
        dfnms   $lx_4,$b,$ex                            # 368e
        dfm     $e_3,$lx_5,$ex_3                        # 375e
        dfnms   $ly_5,$b,$ey_2                          # 382e
        dfm     $e_4,$lx_4,$ex                          # 389e
        dfma    $e_3,$ly_6,$ey                          # 396e
        dfma    $e_4,$ly_5,$ey_2                        # 403e
        dfma    $e_2,$ly_2,$ey_3                        # 410e
        dfnms   $lz_3,$b_4,$ez_3                        # 417e
        dfnms   $lz_5,$b,$ez_4                          # 424e
        dfnms   $lz_6,$b_3,$ez_2                        # 431e
        dfma    $e_3,$lz_3,$ez_3                        # 438e
        dfma    $e_2,$lz_6,$ez_2                        # 445e
        dfma    $e_4,$lz_5,$ez_4                        # 452e
        dfma    $b_3,$e_2,$k_half_double                # 459e
        dfma    $b,$e_4,$k_half_double                  # 466e
        dfma    $b_4,$e_3,$k_half_double                # 473e
        lqd     $dz_4,160($a_packet)                    # 480o
        rotqbyi $ez_5,$dz_2,4                           # 481o
        shufb   $radius2_2,$quad,$quad,$m_radius2       # 482o
        lqd     $dz_5,176($a_packet)                    # 483o
        lqd     $t_best_2,208($a_packet)                # 484o
        fesd    $ez_5,$ez_5                             # 485e
        fesd    $radius2_2,$radius2_2                   # 492e
        dfma    $b_5,$lz_2,$ez_5                        # 499e
        lnop                                            # 506o pairing
        ori     $disc_2,$radius2_2,0                    # 507e
        rotqbyi $ez_6,$dz_4,4                           # 507o
        ori     $disc_3,$radius2_2,0                    # 508e
        rotqbyi $ez_7,$dz_5,0                           # 508o
        ori     $disc_4,$radius2_2,0                    # 509e
        rotqbyi $ez_8,$dz_4,0                           # 509o
        ori     $disc_5,$radius2_2,0                    # 510e
        rotqbyi $ez_9,$dz_5,4                           # 510o
        fesd    $ez_6,$ez_6                             # 511e
        fesd    $ez_8,$ez_8                             # 518e
        dfma    $b_7,$lz_8,$ez_6                        # 525e
        dfma    $b_2,$lz_4,$ez_8                        # 532e
        fesd    $ez_7,$ez_7                             # 539e
        dfnms   $lx_7,$b_7,$ex_7                        # 546e
        fesd    $ez_9,$ez_9                             # 553e
        dfnms   $lx_2,$b_5,$ex_6                        # 560e
        dfma    $b_8,$lz_7,$ez_9                        # 567e
        dfnms   $lx,$b_2,$ex_5                          # 574e
        dfma    $b_6,$lz_9,$ez_7                        # 581e
        dfnms   $ly,$b_2,$ey_4                          # 588e
        dfm     $e_5,$lx,$ex_5                          # 595e
        dfm     $e_6,$lx_2,$ex_6                        # 602e
        dfnms   $ly_3,$b_8,$ey_7                        # 609e
        dfnms   $lx_8,$b_8,$ex_8                        # 616e
        dfma    $e_5,$ly,$ey_4                          # 623e
        dfm     $e_7,$lx_8,$ex_8                        # 630e
        ori     $disc_6,$radius2_2,0                    # 637e
        lqd     $t_best_3,240($a_packet)                # 637o
        dfnms   $disc_4,$lx_6,$lx_6                     # 638e
        dfnms   $ly_4,$b_5,$ey_5                        # 645e
        dfnms   $disc_2,$lx_2,$lx_2                     # 652e
        dfnms   $disc_5,$lx_4,$lx_4                     # 659e
        ori     $disc,$radius2_2,0                      # 666e
        lqd     $t_best_4,224($a_packet)                # 666o
        dfnms   $ly_7,$b_7,$ey_6                        # 667e
        dfnms   $disc,$lx,$lx                           # 674e
        dfnms   $disc_3,$lx_5,$lx_5                     # 681e
        dfnms   $disc,$ly,$ly                           # 688e
        ori     $disc_7,$radius2_2,0                    # 695e
        lqd     $nearest_2,272($a_packet)               # 695o
        dfnms   $ly_8,$b_6,$ey_8                        # 696e
        dfnms   $disc_7,$lx_7,$lx_7                     # 703e
        dfnms   $lz_4,$b_2,$ez_8                        # 710e
        dfm     $e_8,$lx_7,$ex_7                        # 717e
        dfnms   $lx_3,$b_6,$ex_4                        # 724e
        dfma    $e_8,$ly_7,$ey_6                        # 731e
        ori     $disc_8,$radius2_2,0                    # 738e
        lqd     $t_best_5,192($a_packet)                # 738o
        dfnms   $disc_7,$ly_7,$ly_7                     # 739e
        dfnms   $disc_8,$lx_8,$lx_8                     # 746e
        dfnms   $lz_8,$b_7,$ez_6                        # 753e
        dfnms   $disc_8,$ly_3,$ly_3                     # 760e
        dfnms   $disc_4,$ly_2,$ly_2                     # 767e
        dfnms   $disc_3,$ly_6,$ly_6                     # 774e
        dfnms   $disc_6,$lx_3,$lx_3                     # 781e
        dfnms   $disc_3,$lz_3,$lz_3                     # 788e
        dfnms   $disc_2,$ly_4,$ly_4                     # 795e
        dfma    $e_7,$ly_3,$ey_7                        # 802e
        dfnms   $lz_2,$b_5,$ez_5                        # 809e
        dfnms   $disc_5,$ly_5,$ly_5                     # 816e
        dfnms   $disc_2,$lz_2,$lz_2                     # 823e
        dfnms   $disc_5,$lz_5,$lz_5                     # 830e
        dfma    $e_6,$ly_4,$ey_5                        # 837e
        dfnms   $disc_7,$lz_8,$lz_8                     # 844e
        dfma    $e_6,$lz_2,$ez_5                        # 851e
        dfnms   $disc_6,$ly_8,$ly_8                     # 858e
        dfm     $e_9,$lx_3,$ex_4                        # 865e
        dfnms   $disc,$lz_4,$lz_4                       # 872e
        dfma    $e_9,$ly_8,$ey_8                        # 879e
        dfnms   $lz_9,$b_6,$ez_7                        # 886e
        dfnms   $lz_7,$b_8,$ez_9                        # 893e
        dfma    $e_5,$lz_4,$ez_8                        # 900e
        dfma    $e_7,$lz_7,$ez_9                        # 907e
        dfma    $disc,$e_5,$e_5                         # 914e
        dfnms   $disc_4,$lz_6,$lz_6                     # 921e
        dfma    $e_8,$lz_8,$ez_6                        # 928e
        dfma    $disc_4,$e_2,$e_2                       # 935e
        dfma    $disc_7,$e_8,$e_8                       # 942e
        dfnms   $disc_8,$lz_7,$lz_7                     # 949e
        dfma    $disc_2,$e_6,$e_6                       # 956e
        dfnms   $disc_6,$lz_9,$lz_9                     # 963e
        dfma    $e_9,$lz_9,$ez_7                        # 970e
        dfma    $disc_3,$e_3,$e_3                       # 977e
        dfma    $disc_6,$e_9,$e_9                       # 984e
        dfma    $disc_5,$e_4,$e_4                       # 991e
        dfma    $disc_8,$e_7,$e_7                       # 998e
        frds    $x,$disc_2                              # 1005e
        frds    $x_2,$disc_8                            # 1012e
        frds    $x_3,$disc_5                            # 1019e
        frds    $x_4,$disc_4                            # 1026e
        fa      $near,$x_3,$k_tiny                      # 1033e
        lqd     $nearest,256($a_packet)                 # 1033o
        frds    $x_3,$disc_3                            # 1034e
        frds    $x_5,$disc_7                            # 1041e
        frds    $x_6,$disc                              # 1048e
        lnop                                            # 1055o pairing
        fa      $near_2,$x_5,$k_tiny                    # 1056e
        frsqest $y,$near                                # 1056o
        fa      $near_3,$x_3,$k_tiny                    # 1057e
        lqd     $nearest_3,288($a_packet)               # 1057o
        fa      $near_4,$x,$k_tiny                      # 1058e
        lqd     $nearest_4,304($a_packet)               # 1058o
        frds    $x,$disc_6                              # 1059e
        lnop                                            # 1066o pairing
        fi      $y,$near,$y                             # 1067e
        frsqest $y_2,$near_2                            # 1067o
        ori     $e_10,$disc_2,0                         # 1068e
        frsqest $y_3,$near_3                            # 1068o
        fa      $near_5,$x_4,$k_tiny                    # 1069e
        frsqest $y_4,$near_4                            # 1069o
        fa      $near_6,$x_6,$k_tiny                    # 1070e
        fi      $y_2,$near_2,$y_2                       # 1071e
        fi      $y_3,$near_3,$y_3                       # 1072e
        fi      $y_4,$near_4,$y_4                       # 1073e
        ori     $e_11,$disc_3,0                         # 1074e
        lnop                                            # 1074o pairing
        fm      $e_12,$near,$y                          # 1075e
        frsqest $y_5,$near_5                            # 1075o
        fm      $w_2,$y,$k_half                         # 1076e
        frsqest $y_6,$near_6                            # 1076o
        fa      $near_7,$x,$k_tiny                      # 1077e
        fm      $e_13,$near_2,$y_2                      # 1078e
        fm      $w_3,$y_2,$k_half                       # 1079e
        fi      $y_6,$near_6,$y_6                       # 1080e
        fi      $y_5,$near_5,$y_5                       # 1081e
        ori     $e_14,$disc,0                           # 1082e
        fnms    $e_12,$e_12,$y,$k_one                   # 1083e
        frsqest $y_7,$near_7                            # 1083o
        fnms    $e_13,$e_13,$y_2,$k_one                 # 1084e
        fm      $e_15,$near_4,$y_4                      # 1085e
        fm      $e_16,$near_3,$y_3                      # 1086e
        fi      $y_7,$near_7,$y_7                       # 1087e
        ori     $e_17,$disc_7,0                         # 1088e
        fm      $w_4,$y_5,$k_half                       # 1089e
        fm      $e_18,$near_5,$y_5                      # 1090e
        fm      $e_19,$near_6,$y_6                      # 1091e
        fm      $w_5,$y_6,$k_half                       # 1092e
        fma     $w_6,$e_13,$w_3,$y_2                    # 1093e
        fm      $e_13,$near_7,$y_7                      # 1094e
        fm      $w_3,$y_3,$k_half                       # 1095e
        fnms    $e_18,$e_18,$y_5,$k_one                 # 1096e
        fa      $near_8,$x_2,$k_tiny                    # 1097e
        fma     $w_7,$e_12,$w_2,$y                      # 1098e
        fnms    $e_12,$e_15,$y_4,$k_one                 # 1099e
        fnms    $e_20,$e_19,$y_6,$k_one                 # 1100e
        fm      $w_8,$y_4,$k_half                       # 1101e
        fnms    $e_16,$e_16,$y_3,$k_one                 # 1102e
        fesd    $y_2,$w_6                               # 1103e
        fma     $w_9,$e_12,$w_8,$y_4                    # 1110e
        frsqest $y_8,$near_8                            # 1110o
        fma     $w_2,$e_20,$w_5,$y_6                    # 1111e
        fesd    $y,$w_7                                 # 1112e
        fi      $y_8,$near_8,$y_8                       # 1119e
        fesd    $y_9,$w_2                               # 1120e
        fm      $w_10,$y_8,$k_half                      # 1127e
        fm      $e_15,$near_8,$y_8                      # 1128e
        dfm     $s_2,$disc_7,$y_2                       # 1129e
        dfm     $s_3,$disc,$y_9                         # 1136e
        fesd    $y_4,$w_9                               # 1143e
        fma     $w,$e_16,$w_3,$y_3                      # 1150e
        fnms    $e_13,$e_13,$y_7,$k_one                 # 1151e
        fma     $w_11,$e_18,$w_4,$y_5                   # 1152e
        dfnms   $e_14,$s_3,$s_3                         # 1153e
        fesd    $y_3,$w                                 # 1160e
        dfm     $s_4,$disc_2,$y_4                       # 1167e
        dfm     $s_5,$disc_3,$y_3                       # 1174e
        fesd    $y_5,$w_11                              # 1181e
        fm      $w_4,$y_7,$k_half                       # 1188e
        fnms    $e_15,$e_15,$y_8,$k_one                 # 1189e
        ori     $e_18,$disc_6,0                         # 1190e
        dfm     $s_6,$disc_5,$y                         # 1191e
        fma     $w_12,$e_15,$w_10,$y_8                  # 1198e
        dfm     $s_7,$disc_4,$y_5                       # 1199e
        fma     $w_13,$e_13,$w_4,$y_7                   # 1206e
        fesd    $y_8,$w_12                              # 1207e
        fesd    $y_10,$w_13                             # 1214e
        dfma    $b_2,$e_5,$k_half_double                # 1221e
        dfm     $s_8,$disc_6,$y_10                      # 1228e
        dfm     $s_9,$disc_8,$y_8                       # 1235e
        dfnms   $e_17,$s_2,$s_2                         # 1242e
        a       $y_9,$y_9,$k_halve                      # 1249e
        ori     $e_15,$disc_5,0                         # 1250e
        dfnms   $e_10,$s_4,$s_4                         # 1251e
        a       $y_4,$y_4,$k_halve                      # 1258e
        a       $y,$y,$k_halve                          # 1259e
        ori     $e_21,$disc_4,0                         # 1260e
        a       $y_5,$y_5,$k_halve                      # 1261e
        dfnms   $e_21,$s_7,$s_7                         # 1262e
        dfma    $s_4,$e_10,$y_4                         # 1269e
        dfnms   $e_18,$s_8,$s_8                         # 1276e
        dfnms   $e_15,$s_6,$s_6                         # 1283e
        dfnms   $e_11,$s_5,$s_5                         # 1290e
        a       $y_2,$y_2,$k_halve                      # 1297e
        dfma    $b_7,$e_8,$k_half_double                # 1298e
        dfma    $s_2,$e_17,$y_2                         # 1305e
        a       $y_11,$y_10,$k_halve                    # 1312e
        ori     $e_4,$disc_8,0                          # 1313e
        dfma    $b_5,$e_6,$k_half_double                # 1314e
        selb    $s_10,$s_2,$b_7,$m_sign                 # 1321e
        dfnms   $e_4,$s_9,$s_9                          # 1322e
        selb    $s_11,$s_4,$b_5,$m_sign                 # 1329e
        dfma    $s_7,$e_21,$y_5                         # 1330e
        dfma    $s_6,$e_15,$y                           # 1337e
        selb    $s_12,$s_7,$b_3,$m_sign                 # 1344e
        dfma    $s_8,$e_18,$y_11                        # 1345e
        dfa     $q_2,$b_3,$s_12                         # 1352e
        dfa     $q_3,$b_5,$s_11                         # 1359e
        a       $y_12,$y_3,$k_halve                     # 1366e
        dfma    $b_6,$e_9,$k_half_double                # 1367e
        dfma    $s_5,$e_11,$y_12                        # 1374e
        selb    $s_13,$s_8,$b_6,$m_sign                 # 1381e
        dfma    $s_3,$e_14,$y_9                         # 1382e
        dfma    $b_8,$e_7,$k_half_double                # 1389e
        selb    $s_14,$s_3,$b_2,$m_sign                 # 1396e
        selb    $s_8,$s_6,$b,$m_sign                    # 1397e
        frds    $x_7,$q_2                               # 1398e
        dfa     $q_4,$b,$s_8                            # 1405e
        dfa     $q_5,$b_7,$s_10                         # 1412e
        frds    $x_8,$q_4                               # 1419e
        frds    $x_9,$q_5                               # 1426e
        selb    $s_15,$s_5,$b_4,$m_sign                 # 1433e
        dfa     $q_6,$b_2,$s_14                         # 1434e
        fa      $x_9,$x_9,$k_tiny                       # 1441e
        a       $y_8,$y_8,$k_halve                      # 1442e
        dfa     $q_7,$b_4,$s_15                         # 1443e
        frds    $x_10,$q_6                              # 1450e
        dfma    $s_9,$e_4,$y_8                          # 1457e
        frds    $x_11,$q_3                              # 1464e
        frds    $x_12,$q_7                              # 1471e
        lnop                                            # 1478o pairing
        fa      $x_10,$x_10,$k_tiny                     # 1479e
        frest   $y_9,$x_9                               # 1479o
        selb    $s_7,$s_9,$b_8,$m_sign                  # 1480e
        dfa     $q_8,$b_6,$s_13                         # 1481e
        dfa     $q_9,$b_8,$s_7                          # 1488e
        frds    $x_13,$q_8                              # 1495e
        frds    $x_14,$q_9                              # 1502e
        lnop                                            # 1509o pairing
        fi      $y_9,$x_9,$y_9                          # 1510e
        frest   $y_13,$x_10                             # 1510o
        ori     $cc_2,$disc_3,0                         # 1511e
        fa      $x_12,$x_12,$k_tiny                     # 1512e
        fa      $x_7,$x_7,$k_tiny                       # 1513e
        fa      $x_11,$x_11,$k_tiny                     # 1514e
        fa      $x_8,$x_8,$k_tiny                       # 1515e
        fa      $x_13,$x_13,$k_tiny                     # 1516e
        fnms    $e_22,$x_9,$y_9,$k_one                  # 1517e
        lnop                                            # 1517o pairing
        fa      $x_14,$x_14,$k_tiny                     # 1518e
        frest   $y_14,$x_12                             # 1518o
        fi      $y_13,$x_10,$y_13                       # 1519e
        frest   $y_15,$x_7                              # 1519o
        ori     $cc_3,$disc_4,0                         # 1520e
        frest   $y_16,$x_11                             # 1520o
        dfms    $cc_2,$b_4,$b_4                         # 1521e
        lnop                                            # 1528o pairing
        fi      $y_15,$x_7,$y_15                        # 1529e
        frest   $y_17,$x_14                             # 1529o
        fi      $y_16,$x_11,$y_16                       # 1530e
        frest   $y_18,$x_8                              # 1530o
        fi      $y_14,$x_12,$y_14                       # 1531e
        frest   $y_19,$x_13                             # 1531o
        ori     $cc_4,$disc,0                           # 1532e
        fma     $w_9,$e_22,$y_9,$y_9                    # 1533e
        fi      $y_9,$x_8,$y_18                         # 1534e
        fi      $y_18,$x_13,$y_19                       # 1535e
        dfms    $cc_4,$b_2,$b_2                         # 1536e
        fnms    $e_4,$x_11,$y_16,$k_one                 # 1543e
        fnms    $e_13,$x_13,$y_18,$k_one                # 1544e
        fnms    $e_10,$x_7,$y_15,$k_one                 # 1545e
        fnms    $e_23,$x_8,$y_9,$k_one                  # 1546e
        ori     $cc_5,$disc_2,0                         # 1547e
        fnms    $e_24,$x_10,$y_13,$k_one                # 1548e
        fma     $w_6,$e_4,$y_16,$y_16                   # 1549e
        dfms    $cc_5,$b_5,$b_5                         # 1550e
        fma     $w_14,$e_10,$y_15,$y_15                 # 1557e
        fma     $w,$e_23,$y_9,$y_9                      # 1558e
        fma     $w_11,$e_24,$y_13,$y_13                 # 1559e
        ori     $cc_6,$disc_6,0                         # 1560e
        fnms    $e_12,$x_12,$y_14,$k_one                # 1561e
        dfms    $cc_6,$b_6,$b_6                         # 1562e
        fesd    $y_12,$w_14                             # 1569e
        fesd    $y_3,$w                                 # 1576e
        fma     $w_12,$e_12,$y_14,$y_14                 # 1583e
        fi      $y_13,$x_14,$y_17                       # 1584e
        dfms    $cc_3,$b_3,$b_3                         # 1585e
        fnms    $e_25,$x_14,$y_13,$k_one                # 1592e
        fesd    $y_8,$w_12                              # 1593e
        dfm     $t_2,$cc_3,$y_12                        # 1600e
        fma     $w_3,$e_25,$y_13,$y_13                  # 1607e
        ori     $cc_7,$disc_7,0                         # 1608e
        fesd    $y_4,$w_9                               # 1609e
        dfms    $cc_7,$b_7,$b_7                         # 1616e
        fma     $w_13,$e_13,$y_18,$y_18                 # 1623e
        fesd    $y_20,$w_3                              # 1624e
        ori     $cc_8,$disc_5,0                         # 1631e
        fesd    $y_2,$w_6                               # 1632e
        dfms    $cc_8,$b,$b                             # 1639e
        dfm     $t_3,$cc_2,$y_8                         # 1646e
        ori     $e_15,$cc_8,0                           # 1653e
        dfm     $t_4,$cc_8,$y_3                         # 1654e
        fesd    $y_5,$w_11                              # 1661e
        ori     $cc_9,$disc_8,0                         # 1668e
        dfm     $t_5,$cc_7,$y_4                         # 1669e
        dfm     $t_6,$cc_4,$y_5                         # 1676e
        dfm     $t_7,$cc_5,$y_2                         # 1683e
        ori     $e_26,$cc_7,0                           # 1690e
        fesd    $y_10,$w_13                             # 1691e
        ori     $e_27,$cc_2,0                           # 1698e
        ori     $e_28,$cc_4,0                           # 1699e
        dfnms   $e_27,$q_7,$t_3                         # 1700e
        dfnms   $e_28,$q_6,$t_6                         # 1707e
        dfms    $cc_9,$b_8,$b_8                         # 1714e
        dfnms   $e_15,$q_4,$t_4                         # 1721e
        dfm     $t_8,$cc_9,$y_20                        # 1728e
        ori     $e_29,$cc_9,0                           # 1735e
        dfnms   $e_26,$q_5,$t_5                         # 1736e
        dfnms   $e_29,$q_9,$t_8                         # 1743e
        dfma    $t_5,$e_26,$y_4                         # 1750e
        ori     $e_6,$cc_5,0                            # 1757e
        dfma    $t_6,$e_28,$y_5                         # 1758e
        dfnms   $e_6,$q_3,$t_7                          # 1765e
        dfm     $t_9,$cc_6,$y_10                        # 1772e
        dfma    $t_7,$e_6,$y_2                          # 1779e
        ori     $e_6,$cc_3,0                            # 1786e
        frds    $t_10,$t_5                              # 1787e
        dfnms   $e_6,$q_2,$t_2                          # 1794e
        frds    $t_11,$t_7                              # 1801e
        dfma    $t_2,$e_6,$y_12                         # 1808e
        ori     $e_6,$cc_6,0                            # 1815e
        dfma    $t_8,$e_29,$y_20                        # 1816e
        dfnms   $e_6,$q_8,$t_9                          # 1823e
        frds    $t_even,$t_2                            # 1830e
        dfma    $t_9,$e_6,$y_10                         # 1837e
        dfma    $t_4,$e_15,$y_3                         # 1844e
        dfma    $t_3,$e_27,$y_8                         # 1851e
        frds    $t_even_2,$t_4                          # 1858e
        frds    $t,$t_3                                 # 1865e
        or      $disc_even,$near,$b                     # 1872e
        shufb   $t_11,$t_even,$t_11,$m_rows             # 1872o
        frds    $t_even,$t_6                            # 1873e
        lnop                                            # 1880o pairing
        clgt    $hit,$t_best_5,$t_11                    # 1881e
        shufb   $t,$t_even_2,$t,$m_rows                 # 1881o
        frds    $t_12,$t_8                              # 1882e
        lnop                                            # 1889o pairing
        or      $disc,$near_3,$b_4                      # 1890e
        shufb   $t_8,$t_even,$t_10,$m_rows              # 1890o
        or      $disc_even_2,$near_5,$b_3               # 1891e
        frds    $t_even,$t_9                            # 1892e
        clgt    $hit_2,$t_best_4,$t_8                   # 1899e
        shufb   $disc,$disc_even,$disc,$m_rows          # 1899o
        or      $disc_8,$near_4,$b_5                    # 1900e
        or      $disc_9,$near_2,$b_7                    # 1901e
        or      $disc_even,$near_6,$b_2                 # 1902e
        shufb   $disc_10,$disc_even_2,$disc_8,$m_rows   # 1902o
        clgt    $hit_3,$t_best_2,$t                     # 1903e
        lnop                                            # 1903o pairing
        or      $disc_11,$near_8,$b_8                   # 1904e
        shufb   $disc_9,$disc_even,$disc_9,$m_rows      # 1904o
        andc    $hit_3,$hit_3,$disc                     # 1905e
        shufb   $t_12,$t_even,$t_12,$m_rows             # 1905o
        andc    $hit,$hit,$disc_10                      # 1906e
        lnop                                            # 1906o pairing
        or      $disc_even,$near_7,$b_6                 # 1907e
        rotqbii $hit_4,$hit_3,1                         # 1907o
        andc    $hit_2,$hit_2,$disc_9                   # 1908e
        rotqbii $hit,$hit,1                             # 1908o
        clgt    $hit_3,$t_best_3,$t_12                  # 1909e
        shufb   $disc,$disc_even,$disc_11,$m_rows       # 1909o
        rotqbii $hit_5,$hit_2,1                         # 1910o
        gb      $hit_4,$hit_4                           # 1911o
        gb      $hit,$hit                               # 1912o
        andc    $hit_2,$hit_3,$disc                     # 1913e
        gb      $hit_5,$hit_5                           # 1914o
        rotqbii $hit_2,$hit_2,1                         # 1915o
        shlqbii $hit,$hit,4                             # 1916o
        shlqbii $hit_4,$hit_4,4                         # 1917o
        shlqbii $hit_5,$hit_5,4                         # 1918o
        gb      $hit_2,$hit_2                           # 1919o
        lqx     $merge,$a_merges,$hit                   # 1920o
        lqx     $merge_2,$a_merges,$hit_4               # 1921o
        lqx     $merge_3,$a_merges,$hit_5               # 1922o
        shlqbii $hit,$hit_2,4                           # 1923o
        shufb   $nearest,$nearest,$object,$merge        # 1926o
        shufb   $t_best,$t_best_2,$t,$merge_2           # 1927o
        shufb   $nearest_5,$nearest_2,$object,$merge_2  # 1928o
        shufb   $nearest_6,$nearest_3,$object,$merge_3  # 1929o
        stqd    $nearest,256($a_packet)                 # 1930o
        shufb   $t_best_6,$t_best_4,$t_8,$merge_3       # 1931o
        shufb   $t_best_7,$t_best_5,$t_11,$merge        # 1932o
        stqd    $t_best,208($a_packet)                  # 1933o
        lqx     $merge,$a_merges,$hit                   # 1934o
        stqd    $t_best_6,224($a_packet)                # 1935o
        stqd    $t_best_7,192($a_packet)                # 1936o
        stqd    $nearest_6,288($a_packet)               # 1937o
        stqd    $nearest_5,272($a_packet)               # 1938o
        hbrr    next_pair_back,next_pair                # 1939o hint
        shufb   $t_best,$t_best_3,$t_12,$merge          # 1940o
        shufb   $nearest,$nearest_4,$object,$merge      # 1941o
        stqd    $t_best,240($a_packet)                  # 1944o
        stqd    $nearest,304($a_packet)                 # 1945o
        nop     $127                                    # 1946e pairing
next_pair_back:
        brnz    $count,next_pair                        # 1946o
        nop     $127                                    # 1947e pairing
        bi      $lr                                     # 1947o
endfunction isect_pairs_double_r16
