# cull_spheres_p64   for each sphere, a tile's packets whose primary rays may enter it
#   C       void cull_spheres_p64(const struct packet middles[4], const struct pair *, int count,
#                                 unsigned (*masks)[4]);
#   In      $3 the middle directions of each sixteen packets, as a packet; $4 list whose entries'
#           first words are the addresses of spheres; $5 count (at least 1); $6 where masks go;
#           pointers 16-aligned
#   Out     four masks a sphere, one for each sixteen packets: 16 bits, the highest of the first
#   Uses    $2-$55, $79   Saves  -   Stack  0   Calls  -
#   Domain  |d| = 1 within 4 ulp; limits as the PPU makes them
#   Error   0: no packet is left out a ray of which enters
#   Twin    lab/twins/src/cull.rs
#
# Like filter_spheres_r16, but with the cone of the sphere widened by that of a packet.
# Scheduled by spu schedule from cull_spheres_p64.s

        .include "work_unit.inc"
        .include "macros.inc"

        .set    NEXT,3
        registers a_middles,a_list,count,a_masks
        # constants
        .set    NEXT,10
        registers m_x,m_y,m_z,m_limit
        registers m_signs                               # top bytes of two quadwords' words
        registers m_halves                              # packets 15, 0 to 14: see the rotation
        registers m_two                                 # first words of two quadwords
        registers m_four                                # first two words of two quadwords
        # the sphere
        registers a_sphere,quad,more,cx,cy,cz,limit
        # the middles of a row
        registers dx,dy,dz
        # temporaries
        registers s                                     # to 31
        .set    NEXT,32
        registers signs_low
        registers signs                                 # to 36, a group each

        .section .rodata
        .align  4
signs_of_two:
        .int    0x0004080c,0x1014181c,0x0004080c,0x1014181c
halves: .int    0x17000102,0x03040506,0x07101112,0x13141516
two:    .int    0x00010203,0x10111213,0x00010203,0x10111213
four:   .int    0x00010203,0x04050607,0x10111213,0x14151617

function cull_spheres_p64
        .set count_2,79; .set a_list_2,2; .set dx_2,7; .set dx_3,8; .set dx_4,9; .set dx_5,19
        .set quad_2,20; .set more_2,18; .set dx_6,21; .set dx_7,22; .set dx_8,23; .set dx_9,24
        .set dx_10,27; .set dx_11,28; .set dx_12,29; .set dx_13,30; .set dx_14,31; .set dx_15,32
        .set dx_16,37; .set cx_2,26; .set limit_2,18; .set a_sphere_2,2; .set dy_2,33; .set dy_3,38
        .set s_2,9; .set dy_4,39; .set s2_2,19; .set dy_5,40; .set s1_2,25; .set dy_6,42
        .set s1_3,27; .set dy_7,43; .set s3_2,22; .set dy_8,44; .set dy_9,34; .set dy_10,45
        .set s3_3,32; .set dy_11,35; .set s_3,8; .set dy_12,48; .set s_4,23; .set dy_13,36
        .set s_5,21; .set dy_14,41; .set s1_4,37; .set dy_15,46; .set s3_4,7; .set dy_16,47
        .set dy_17,49; .set s2_3,24; .set cy_2,50; .set s2_4,18; .set quad_3,26; .set more_3,2
        .set dz_2,28; .set dz_3,33; .set dz_4,40; .set dz_5,44; .set dz_6,34; .set dz_7,38
        .set dz_8,43; .set dz_9,45; .set dz_10,48; .set dz_11,36; .set dz_12,42; .set dz_13,39
        .set dz_14,35; .set dz_15,41; .set dz_16,46; .set dz_17,47; .set cz_2,20; .set dx_17,49
        .set dx_18,50; .set dx_19,51; .set dx_20,40; .set dx_21,34; .set dx_22,33; .set dx_23,44
        .set cx_3,48; .set limit_3,2; .set dx_24,36; .set dx_25,42; .set dx_26,35; .set dx_27,39
        .set dx_28,43; .set dx_29,38; .set dy_18,20; .set s1_5,46; .set s3_5,40; .set s3_6,34
        .set dy_19,52; .set s_6,50; .set dy_20,53; .set s_7,51; .set cy_3,54; .set s1_6,33
        .set dy_21,55; .set s2_5,28; .set signs_low_2,19; .set s1_7,21; .set signs_low_3,7
        .set s3_7,30; .set signs1_2,23; .set s_8,25; .set signs_2,8; .set s1_8,9
        .set signs_low_4,18; .set s_9,20; .set s_10,33; .set s2_6,39; .set s_11,22; .set s2_7,2
        .set signs_3,7; .set signs1_3,8; .set s2_8,23; .set dz_18,18; .set cz_3,19; .set dz_19,26
        .set dy_22,32; .set s1_9,38; .set dz_20,9; .set s3_8,26; .set dz_21,31; .set s3_9,21
        .set signs3_2,20; .set signs_low_5,2; .set signs_low_6,9; .set signs2_2,49
        .set signs1_4,22; .set signs_4,50; .set dx_30,2; .set dx_31,18; .set cx_4,24
        .set limit_4,20; .set s2_9,9; .set cy_4,41; .set s_12,7; .set s_13,18; .set s3_10,2
        .set s2_10,20; .set signs_5,24; .set dz_22,24; .set a_masks_2,2; .set signs_low_7,3
        .set a_masks_3,4; .set dx_32,20; .set dy_23,31; .set s2_11,27; .set s1_10,28; .set s2_12,29
        .set s3_11,8; .set cy_5,37; .set s3_12,20; .set s_14,2; .set s_15,24; .set s3_13,18
        .set dy_24,25; .set dz_23,25; .set dz_24,37; .set signs_low_8,8
        ilhu    $m_x,1                                  # 0e
        lqa     $m_signs,signs_of_two                   # 0o
        ilhu    $m_y,0x405                              # 1e
        lqa     $m_halves,halves                        # 1o
        ilhu    $m_z,0x809                              # 2e
        lqa     $m_two,two                              # 2o
        ilhu    $m_limit,0x809                          # 3e
        lqa     $m_four,four                            # 3o
        clgti   $count_2,$count,2                       # 4e at least as many passes as overlap
        iohl    $m_x,515                                # 5e
        iohl    $m_y,0x607                              # 6e
        iohl    $m_z,0xa0b                              # 7e
        iohl    $m_limit,0xa0b                          # 8e
        brz     $count_2,next_sphere_short              # 8o too few passes
        ai      $a_list_2,$a_list,16                    # 9e
        lqd     $a_sphere,0($a_list)                    # 9o
        ai      $count,$count,-1                        # 10e
        lqd     $dx,336($a_middles)                     # 10o
        ai      $a_list,$a_list_2,16                    # 11e
        lqd     $dx_2,1008($a_middles)                  # 11o
        ai      $count,$count,-1                        # 12e
        lqd     $dx_3,640($a_middles)                   # 12o
        lqd     $dx_4,0($a_middles)                     # 13o
        lqd     $dx_5,32($a_middles)                    # 14o
        lqd     $quad_2,0($a_sphere)                    # 15o
        lqd     $more_2,16($a_sphere)                   # 16o
        lqd     $dx_6,960($a_middles)                   # 17o
        lqd     $dx_7,368($a_middles)                   # 18o
        lqd     $dx_8,320($a_middles)                   # 19o
        lqd     $dx_9,672($a_middles)                   # 20o
        lqd     $dx_10,16($a_middles)                   # 21o
        lqd     $dx_11,352($a_middles)                  # 22o
        lqd     $dx_12,656($a_middles)                  # 23o
        lqd     $dx_13,992($a_middles)                  # 24o
        lqd     $dx_14,48($a_middles)                   # 25o
        lqd     $dx_15,688($a_middles)                  # 26o
        lqd     $dx_16,976($a_middles)                  # 27o
        shufb   $cx_2,$quad_2,$quad_2,$m_x              # 28o
        shufb   $limit_2,$more_2,$more_2,$m_limit       # 29o
        lqd     $a_sphere_2,0($a_list_2)                # 30o
        lqd     $dy_2,96($a_middles)                    # 31o
        lqd     $dy_3,432($a_middles)                   # 32o
        fnms    $s_2,$cx_2,$dx_4,$limit_2               # 33e
        lqd     $dy_4,80($a_middles)                    # 33o
        fnms    $s2_2,$cx_2,$dx_5,$limit_2              # 34e
        lqd     $dy_5,0x420($a_middles)                 # 34o
        fnms    $s1_2,$cx_2,$dx,$limit_2                # 35e
        lqd     $dy_6,112($a_middles)                   # 35o
        fnms    $s1_3,$cx_2,$dx_10,$limit_2             # 36e
        lqd     $dy_7,0x430($a_middles)                 # 36o
        fnms    $s3_2,$cx_2,$dx_7,$limit_2              # 37e
        lqd     $dy_8,400($a_middles)                   # 37o
        fnms    $s+2,$cx_2,$dx_13,$limit_2              # 38e
        lqd     $dy_9,0x400($a_middles)                 # 38o
        fnms    $s+3,$cx_2,$dx_14,$limit_2              # 39e
        lqd     $dy_10,0x410($a_middles)                # 39o
        fnms    $s3_3,$cx_2,$dx_15,$limit_2             # 40e
        lqd     $dy_11,384($a_middles)                  # 40o
        fnms    $s_3,$cx_2,$dx_3,$limit_2               # 41e
        lqd     $dy_12,704($a_middles)                  # 41o
        fnms    $s_4,$cx_2,$dx_8,$limit_2               # 42e
        lqd     $dy_13,752($a_middles)                  # 42o
        fnms    $s_5,$cx_2,$dx_6,$limit_2               # 43e
        lqd     $dy_14,736($a_middles)                  # 43o
        fnms    $s1_4,$cx_2,$dx_16,$limit_2             # 44e
        lqd     $dy_15,720($a_middles)                  # 44o
        fnms    $s3_4,$cx_2,$dx_2,$limit_2              # 45e
        lqd     $dy_16,64($a_middles)                   # 45o
        fnms    $s+1,$cx_2,$dx_12,$limit_2              # 46e
        lqd     $dy_17,416($a_middles)                  # 46o
        fnms    $s2_3,$cx_2,$dx_9,$limit_2              # 47e
        shufb   $cy_2,$quad_2,$quad_2,$m_y              # 47o
        fnms    $s2_4,$cx_2,$dx_11,$limit_2             # 48e
        lqd     $quad_3,0($a_sphere_2)                  # 48o
        lqd     $more_3,16($a_sphere_2)                 # 49o
        lqd     $dz_2,144($a_middles)                   # 50o
        fnms    $s2_2,$cy_2,$dy_2,$s2_2                 # 51e
        lqd     $dz_3,176($a_middles)                   # 51o
        fnms    $s+2,$cy_2,$dy_5,$s+2                   # 52e
        lqd     $dz_4,0x440($a_middles)                 # 52o
        fnms    $s1_2,$cy_2,$dy_8,$s1_2                 # 53e
        lqd     $dz_5,0x450($a_middles)                 # 53o
        fnms    $s_5,$cy_2,$dy_9,$s_5                   # 54e
        lqd     $dz_6,768($a_middles)                   # 54o
        fnms    $s3_2,$cy_2,$dy_3,$s3_2                 # 55e
        lqd     $dz_7,0x460($a_middles)                 # 55o
        fnms    $s3_4,$cy_2,$dy_7,$s3_4                 # 56e
        lqd     $dz_8,160($a_middles)                   # 56o
        fnms    $s1_4,$cy_2,$dy_10,$s1_4                # 57e
        lqd     $dz_9,448($a_middles)                   # 57o
        fnms    $s_3,$cy_2,$dy_12,$s_3                  # 58e
        lqd     $dz_10,816($a_middles)                  # 58o
        fnms    $s3_3,$cy_2,$dy_13,$s3_3                # 59e
        lqd     $dz_11,464($a_middles)                  # 59o
        fnms    $s+3,$cy_2,$dy_6,$s+3                   # 60e
        lqd     $dz_12,496($a_middles)                  # 60o
        fnms    $s1_3,$cy_2,$dy_4,$s1_3                 # 61e
        lqd     $dz_13,800($a_middles)                  # 61o
        fnms    $s_4,$cy_2,$dy_11,$s_4                  # 62e
        lqd     $dz_14,0x470($a_middles)                # 62o
        fnms    $s2_3,$cy_2,$dy_14,$s2_3                # 63e
        lqd     $dz_15,784($a_middles)                  # 63o
        fnms    $s+1,$cy_2,$dy_15,$s+1                  # 64e
        lqd     $dz_16,128($a_middles)                  # 64o
        fnms    $s_2,$cy_2,$dy_16,$s_2                  # 65e
        lqd     $dz_17,480($a_middles)                  # 65o
        fnms    $s2_4,$cy_2,$dy_17,$s2_4                # 66e
        shufb   $cz_2,$quad_2,$quad_2,$m_z              # 66o
        lqd     $dx_17,336($a_middles)                  # 67o
        lqd     $dx_18,640($a_middles)                  # 68o
        nop     $127                                    # 69e pairing
        lqd     $dx_19,960($a_middles)                  # 69o
        fnms    $s_5,$cz_2,$dz_4,$s_5                   # 70e
        lqd     $dx_20,48($a_middles)                   # 70o
        fnms    $s_3,$cz_2,$dz_6,$s_3                   # 71e
        lqd     $dx_21,688($a_middles)                  # 71o
        fnms    $s+3,$cz_2,$dz_3,$s+3                   # 72e
        lqd     $dx_22,976($a_middles)                  # 72o
        fnms    $s1_4,$cz_2,$dz_5,$s1_4                 # 73e
        lqd     $dx_23,1008($a_middles)                 # 73o
        fnms    $s3_3,$cz_2,$dz_10,$s3_3                # 74e
        shufb   $cx_3,$quad_3,$quad_3,$m_x              # 74o
        fnms    $s1_2,$cz_2,$dz_11,$s1_2                # 75e
        shufb   $limit_3,$more_3,$more_3,$m_limit       # 75o
        fnms    $s1_3,$cz_2,$dz_2,$s1_3                 # 76e
        lqd     $dx_11,992($a_middles)                  # 76o
        fnms    $s2_2,$cz_2,$dz_8,$s2_2                 # 77e
        lqd     $dx_24,32($a_middles)                   # 77o
        fnms    $s3_2,$cz_2,$dz_12,$s3_2                # 78e
        lqd     $dx_25,368($a_middles)                  # 78o
        fnms    $s3_4,$cz_2,$dz_14,$s3_4                # 79e
        lqd     $dx_26,320($a_middles)                  # 79o
        fnms    $s2_3,$cz_2,$dz_13,$s2_3                # 80e
        lqd     $dx_27,672($a_middles)                  # 80o
        fnms    $s_4,$cz_2,$dz_9,$s_4                   # 81e
        lqd     $dx_28,16($a_middles)                   # 81o
        fnms    $s+2,$cz_2,$dz_7,$s+2                   # 82e
        lqd     $dx_29,656($a_middles)                  # 82o
        fnms    $s+1,$cz_2,$dz_15,$s+1                  # 83e
        lqd     $dy_14,112($a_middles)                  # 83o
        fnms    $s_2,$cz_2,$dz_16,$s_2                  # 84e
        lqd     $dy_10,400($a_middles)                  # 84o
        fnms    $s2_4,$cz_2,$dz_17,$s2_4                # 85e
        lqd     $dy_18,0x400($a_middles)                # 85o
        fnms    $s1_5,$cx_3,$dx_17,$limit_3             # 86e
        lqd     $dy_16,0x410($a_middles)                # 86o
        fnms    $s3_5,$cx_3,$dx_20,$limit_3             # 87e
        lqd     $dy_17,704($a_middles)                  # 87o
        fnms    $s3_6,$cx_3,$dx_21,$limit_3             # 88e
        lqd     $dy_19,752($a_middles)                  # 88o
        fnms    $s_6,$cx_3,$dx_18,$limit_3              # 89e
        lqd     $dy_20,0x420($a_middles)                # 89o
        fnms    $s_7,$cx_3,$dx_19,$limit_3              # 90e
        shufb   $cy_3,$quad_3,$quad_3,$m_y              # 90o
        fnms    $s1_6,$cx_3,$dx_22,$limit_3             # 91e
        lqd     $dy_21,0x430($a_middles)                # 91o
        fnms    $s2_5,$cx_3,$dx_11,$limit_3             # 92e
        shufb   $signs_low_2,$s2_2,$s+3,$m_signs        # 92o
        fnms    $s+3,$cx_3,$dx_23,$limit_3              # 93e
        shufb   $signs_low,$s2_3,$s3_3,$m_signs         # 93o
        fnms    $s2_3,$cx_3,$dx_24,$limit_3             # 94e
        shufb   $signs+3,$s_5,$s1_4,$m_signs            # 94o
        fnms    $s1_7,$cx_3,$dx_28,$limit_3             # 95e
        shufb   $signs_low_3,$s+2,$s3_4,$m_signs        # 95o
        fnms    $s3_7,$cx_3,$dx_25,$limit_3             # 96e
        shufb   $signs1_2,$s_4,$s1_2,$m_signs           # 96o
        fnms    $s_8,$cx_3,$dx_26,$limit_3              # 97e
        shufb   $signs+2,$s_3,$s+1,$m_signs             # 97o
        fnms    $s+1,$cx_3,$dx_29,$limit_3              # 98e
        shufb   $signs_2,$s_2,$s1_3,$m_signs            # 98o
        fnms    $s1_8,$cy_3,$dy_10,$s1_5                # 99e
        shufb   $signs_low_4,$s2_4,$s3_2,$m_signs       # 99o
        fnms    $s_9,$cy_3,$dy_18,$s_7                  # 100e
        lqd     $dx_7,0($a_middles)                     # 100o
        fnms    $s1_4,$cy_3,$dy_16,$s1_6                # 101e
        lqd     $dx_10,352($a_middles)                  # 101o
        fnms    $s_10,$cy_3,$dy_17,$s_6                 # 102e
        lqd     $dy_3,96($a_middles)                    # 102o
        fnms    $s3_6,$cy_3,$dy_19,$s3_6                # 103e
        lqd     $dy_6,432($a_middles)                   # 103o
        fnms    $s3_5,$cy_3,$dy_14,$s3_5                # 104e
        lqd     $dy_14,80($a_middles)                   # 104o
        fnms    $s2_6,$cx_3,$dx_27,$limit_3             # 105e
        lqd     $dz_17,176($a_middles)                  # 105o
        fnms    $s2_5,$cy_3,$dy_20,$s2_5                # 106e
        lqd     $dy_7,384($a_middles)                   # 106o
        fnms    $s+3,$cy_3,$dy_21,$s+3                  # 107e
        lqd     $dz_5,0x440($a_middles)                 # 107o
        fnms    $s_11,$cx_3,$dx_7,$limit_3              # 108e
        lqd     $dz_9,0x450($a_middles)                 # 108o
        fnms    $s2_7,$cx_3,$dx_10,$limit_3             # 109e
        lqd     $dz,768($a_middles)                     # 109o
        fnms    $s2_3,$cy_3,$dy_3,$s2_3                 # 110e
        lqd     $dz_7,816($a_middles)                   # 110o
        fnms    $s3_7,$cy_3,$dy_6,$s3_7                 # 111e
        lqd     $dz_12,464($a_middles)                  # 111o
        fnms    $s1_7,$cy_3,$dy_14,$s1_7                # 112e
        lqd     $dy_14,736($a_middles)                  # 112o
        fnms    $s_8,$cy_3,$dy_7,$s_8                   # 113e
        lqd     $dy_7,720($a_middles)                   # 113o
        shufb   $signs+3,$signs+3,$signs_low_3,$m_halves # 114o
        shufb   $signs+2,$signs+2,$signs_low,$m_halves  # 115o
        shufb   $signs_3,$signs_2,$signs_low_2,$m_halves # 116o
        shufb   $signs1_3,$signs1_2,$signs_low_4,$m_halves # 117o
        fnms    $s2_8,$cy_3,$dy_14,$s2_6                # 118e
        lqd     $dz_18,0x460($a_middles)                # 118o
        fnms    $s+1,$cy_3,$dy_7,$s+1                   # 119e
        shufb   $cz_3,$quad_3,$quad_3,$m_z              # 119o
        lqd     $dz_19,0x470($a_middles)                # 120o
        lqd     $dy_22,64($a_middles)                   # 121o
        nop     $127                                    # 122e pairing
        lqd     $dy_4,416($a_middles)                   # 122o
        fnms    $s_9,$cz_3,$dz_5,$s_9                   # 123e
        rotqbii $signs+3,$signs+3,1                     # 123o the sign of byte k to the end of byte
        fnms    $s_10,$cz_3,$dz,$s_10                   # 124e
        rotqbii $signs+2,$signs+2,1                     # 124o the sign of byte k to the end of byte
        fnms    $s3_5,$cz_3,$dz_17,$s3_5                # 125e
        lqd     $dz_16,144($a_middles)                  # 125o
        fnms    $s1_4,$cz_3,$dz_9,$s1_4                 # 126e
        lqd     $dz_10,160($a_middles)                  # 126o
        fnms    $s3_6,$cz_3,$dz_7,$s3_6                 # 127e
        lqd     $dz,448($a_middles)                     # 127o
        fnms    $s1_9,$cz_3,$dz_12,$s1_8                # 128e
        lqd     $dz_20,496($a_middles)                  # 128o
        fnms    $s3_8,$cz_3,$dz_19,$s+3                 # 129e
        lqd     $dz_8,800($a_middles)                   # 129o
        fnms    $s2_4,$cz_3,$dz_18,$s2_5                # 130e
        rotqbii $signs_3,$signs_3,1                     # 130o the sign of byte k to the end of byte
        fnms    $s_11,$cy_3,$dy_22,$s_11                # 131e
        rotqbii $signs1_3,$signs1_3,1                   # 131o the sign of byte k to the end of byte
        fnms    $s2_7,$cy_3,$dy_4,$s2_7                 # 132e
        hbrr    next_sphere_back,next_sphere            # 132o hint
        fnms    $s2_3,$cz_3,$dz_10,$s2_3                # 133e
        lqd     $dz_13,784($a_middles)                  # 133o
        fnms    $s_8,$cz_3,$dz,$s_8                     # 134e
        lqd     $dz_2,128($a_middles)                   # 134o
        fnms    $s2_8,$cz_3,$dz_8,$s2_8                 # 135e
        lqd     $dz_21,480($a_middles)                  # 135o
        fnms    $s1_3,$cz_3,$dz_16,$s1_7                # 136e
        gbb     $signs+2,$signs+2                       # 136o
        fnms    $s3_9,$cz_3,$dz_20,$s3_7                # 137e
        gbb     $signs+3,$signs+3                       # 137o
        nop     $127                                    # 138e pairing
        gbb     $signs1_3,$signs1_3                     # 138o
        fnms    $s+1,$cz_3,$dz_13,$s+1                  # 139e
        gbb     $signs_3,$signs_3                       # 139o
        fnms    $s,$cz_3,$dz_2,$s_11                    # 140e
        shufb   $signs3_2,$s_9,$s1_4,$m_signs           # 140o
        fnms    $s+2,$cz_3,$dz_21,$s2_7                 # 141e
        shufb   $signs_low_5,$s2_4,$s3_8,$m_signs       # 141o
        shufb   $signs_low_6,$s2_3,$s3_5,$m_signs       # 142o
        shufb   $signs2_2,$signs+2,$signs+3,$m_two      # 143o
        shufb   $signs_low,$s2_8,$s3_6,$m_signs         # 144o
        shufb   $signs1_4,$s_8,$s1_9,$m_signs           # 145o
        shufb   $signs_4,$signs_3,$signs1_3,$m_two      # 146o
        shufb   $signs+2,$s_10,$s+1,$m_signs            # 147o
        nop     $127                                    # 148e pairing
        shufb   $signs+3,$signs3_2,$signs_low_5,$m_halves # 148o
next_sphere:
        ai      $count,$count,-1                        # 0e
        lqd     $dy,96($a_middles)                      # 0o
            shufb   $signs+2,$signs+2,$signs_low,$m_halves # 1o
            shufb   $signs,$s,$s1_3,$m_signs            # 2o
            rotqbii $signs+3,$signs+3,1                 # 3o the sign of byte k to the end of byte
            shufb   $signs_low,$s+2,$s3_9,$m_signs      # 4o
        nop     $127                                    # 5e pairing
        lqd     $a_sphere,0($a_list)                    # 5o
        ai      $a_list,$a_list,16                      # 6e
            rotqbii $signs+2,$signs+2,1                 # 6o the sign of byte k to the end of byte
            shufb   $signs,$signs,$signs_low_6,$m_halves # 7o
            shufb   $signs+1,$signs1_4,$signs_low,$m_halves # 8o
        lqd     $dx,336($a_middles)                     # 9o
        lqd     $dx_30,1008($a_middles)                 # 10o
        lqd     $dx_2,640($a_middles)                   # 11o
        lqd     $dx_3,0($a_middles)                     # 12o
        lqd     $dx_4,32($a_middles)                    # 13o
        lqd     $quad,0($a_sphere)                      # 14o
        lqd     $more,16($a_sphere)                     # 15o
        lqd     $dx_31,960($a_middles)                  # 16o
        lqd     $dx_6,368($a_middles)                   # 17o
        lqd     $dx_7,320($a_middles)                   # 18o
        lqd     $dx_8,672($a_middles)                   # 19o
        shufb   $cx_4,$quad,$quad,$m_x                  # 20o
        lqd     $dx_10,16($a_middles)                   # 21o
        shufb   $limit_4,$more,$more,$m_limit           # 22o
        lqd     $dx_11,352($a_middles)                  # 23o
        lqd     $dx_12,656($a_middles)                  # 24o
        nop     $127                                    # 25e pairing
        lqd     $dx_13,992($a_middles)                  # 25o
        fnms    $s_3,$cx_4,$dx_3,$limit_4               # 26e
        lqd     $dx_14,48($a_middles)                   # 26o
        fnms    $s2_9,$cx_4,$dx_4,$limit_4              # 27e
        lqd     $dx_15,688($a_middles)                  # 27o
        fnms    $s1_2,$cx_4,$dx,$limit_4                # 28e
        lqd     $dx_16,976($a_middles)                  # 28o
        fnms    $s1_3,$cx_4,$dx_10,$limit_4             # 29e
        lqd     $dy_3,432($a_middles)                   # 29o
        fnms    $s3_9,$cx_4,$dx_6,$limit_4              # 30e
        lqd     $dy_4,80($a_middles)                    # 30o
        fnms    $s+2,$cx_4,$dx_13,$limit_4              # 31e
        lqd     $dy_5,0x420($a_middles)                 # 31o
        fnms    $s+3,$cx_4,$dx_14,$limit_4              # 32e
        shufb   $cy_4,$quad,$quad,$m_y                  # 32o
        fnms    $s3_3,$cx_4,$dx_15,$limit_4             # 33e
        lqd     $dy_6,112($a_middles)                   # 33o
        fnms    $s_12,$cx_4,$dx_2,$limit_4              # 34e
        lqd     $dy_7,0x430($a_middles)                 # 34o
        fnms    $s_11,$cx_4,$dx_7,$limit_4              # 35e
        lqd     $dy_8,400($a_middles)                   # 35o
        fnms    $s2_9,$cy_4,$dy,$s2_9                   # 36e
        lqd     $dy,0x400($a_middles)                   # 36o
        fnms    $s_13,$cx_4,$dx_31,$limit_4             # 37e
        lqd     $dy_10,0x410($a_middles)                # 37o
        fnms    $s1_4,$cx_4,$dx_16,$limit_4             # 38e
        lqd     $dz_16,144($a_middles)                  # 38o
        fnms    $s3_10,$cx_4,$dx_30,$limit_4            # 39e
        lqd     $dz_17,176($a_middles)                  # 39o
        fnms    $s+2,$cy_4,$dy_5,$s+2                   # 40e
        lqd     $dy_5,384($a_middles)                   # 40o
        fnms    $s+1,$cx_4,$dx_12,$limit_4              # 41e
        lqd     $dy_12,704($a_middles)                  # 41o
        fnms    $s1_2,$cy_4,$dy_8,$s1_2                 # 42e
        lqd     $dy_8,752($a_middles)                   # 42o
        fnms    $s_13,$cy_4,$dy,$s_13                   # 43e
        lqd     $dz_19,0x440($a_middles)                # 43o
        fnms    $s3_9,$cy_4,$dy_3,$s3_9                 # 44e
        lqd     $dz_7,0x450($a_middles)                 # 44o
        fnms    $s3_10,$cy_4,$dy_7,$s3_10               # 45e
        lqd     $dz_8,768($a_middles)                   # 45o
        fnms    $s1_4,$cy_4,$dy_10,$s1_4                # 46e
        lqd     $dz_9,0x460($a_middles)                 # 46o
        fnms    $s_12,$cy_4,$dy_12,$s_12                # 47e
        lqd     $dz_10,160($a_middles)                  # 47o
        fnms    $s3_3,$cy_4,$dy_8,$s3_3                 # 48e
        shufb   $cz_3,$quad,$quad,$m_z                  # 48o
        fnms    $s+3,$cy_4,$dy_6,$s+3                   # 49e
        lqd     $dz_12,448($a_middles)                  # 49o
        fnms    $s1_3,$cy_4,$dy_4,$s1_3                 # 50e
        lqd     $dz_13,816($a_middles)                  # 50o
        fnms    $s_11,$cy_4,$dy_5,$s_11                 # 51e
        lqd     $dz_4,464($a_middles)                   # 51o
        fnms    $s_13,$cz_3,$dz_19,$s_13                # 52e
        lqd     $dz_19,496($a_middles)                  # 52o
        fnms    $s2_8,$cx_4,$dx_8,$limit_4              # 53e
        lqd     $dy_8,736($a_middles)                   # 53o
        fnms    $s_12,$cz_3,$dz_8,$s_12                 # 54e
        lqd     $dz_8,800($a_middles)                   # 54o
        fnms    $s+3,$cz_3,$dz_17,$s+3                  # 55e
        lqd     $dz_17,0x470($a_middles)                # 55o
        fnms    $s1_4,$cz_3,$dz_7,$s1_4                 # 56e
            rotqbii $signs,$signs,1                     # 56o the sign of byte k to the end of byte
        fnms    $s3_3,$cz_3,$dz_13,$s3_3                # 57e
            rotqbii $signs+1,$signs+1,1                 # 57o the sign of byte k to the end of byte
        fnms    $s1_2,$cz_3,$dz_4,$s1_2                 # 58e
            gbb     $signs+2,$signs+2                   # 58o
        fnms    $s2_8,$cy_4,$dy_8,$s2_8                 # 59e
        lqd     $dy_3,720($a_middles)                   # 59o
        fnms    $s1_3,$cz_3,$dz_16,$s1_3                # 60e
        lqd     $dz_13,784($a_middles)                  # 60o
        fnms    $s2_9,$cz_3,$dz_10,$s2_9                # 61e
            gbb     $signs+3,$signs+3                   # 61o
        fnms    $s3_9,$cz_3,$dz_19,$s3_9                # 62e
            gbb     $signs+1,$signs+1                   # 62o
        fnms    $s2_10,$cx_4,$dx_11,$limit_4            # 63e
            shufb   $signs_5,$signs_4,$signs2_2,$m_four # 63o
        fnms    $s3_10,$cz_3,$dz_17,$s3_10              # 64e
        lqd     $dy,64($a_middles)                      # 64o
        fnms    $s+1,$cy_4,$dy_3,$s+1                   # 65e
        lqd     $dz_2,128($a_middles)                   # 65o
        fnms    $s2_8,$cz_3,$dz_8,$s2_8                 # 66e
        lqd     $dy_3,416($a_middles)                   # 66o
        fnms    $s_11,$cz_3,$dz_12,$s_11                # 67e
            stqd    $signs_5,0($a_masks)                # 67o
        fnms    $s+2,$cz_3,$dz_9,$s+2                   # 68e
        shufb   $signs_low_6,$s2_9,$s+3,$m_signs        # 68o
            ai      $a_masks,$a_masks,16                # 69e
            shufb   $signs2_2,$signs+2,$signs+3,$m_two  # 69o
        fnms    $s_3,$cy_4,$dy,$s_3                     # 70e
        lqd     $dz_22,480($a_middles)                  # 70o
        fnms    $s+1,$cz_3,$dz_13,$s+1                  # 71e
            gbb     $signs,$signs                       # 71o
        fnms    $s2_10,$cy_4,$dy_3,$s2_10               # 72e
        shufb   $signs_low,$s2_8,$s3_3,$m_signs         # 72o
        shufb   $signs+3,$s_13,$s1_4,$m_signs           # 73o
        shufb   $signs_low_5,$s+2,$s3_10,$m_signs       # 74o
        nop     $127                                    # 75e pairing
        shufb   $signs1_4,$s_11,$s1_2,$m_signs          # 75o
        fnms    $s,$cz_3,$dz_2,$s_3                     # 76e
            shufb   $signs_4,$signs,$signs+1,$m_two     # 76o
        nop     $127                                    # 77e pairing
        shufb   $signs+2,$s_12,$s+1,$m_signs            # 77o
        fnms    $s+2,$cz_3,$dz_22,$s2_10                # 78e
        shufb   $signs+3,$signs+3,$signs_low_5,$m_halves # 78o
        nop     $127                                    # 79e pairing
next_sphere_back:
        brnz    $count,next_sphere                      # 79o
next_sphere_drain:
        ai      $a_masks_2,$a_masks,16                  # 0e
        shufb   $signs,$s,$s1_3,$m_signs                # 0o
        nop     $127                                    # 1e pairing
        shufb   $signs_low_7,$s+2,$s3_9,$m_signs        # 1o
        ai      $a_masks_3,$a_masks_2,16                # 2e
        shufb   $signs+2,$signs+2,$signs_low,$m_halves  # 2o
        rotqbii $signs+3,$signs+3,1                     # 3o the sign of byte k to the end of byte
        shufb   $signs,$signs,$signs_low_6,$m_halves    # 4o
        shufb   $signs+1,$signs1_4,$signs_low_7,$m_halves # 5o
        rotqbii $signs+2,$signs+2,1                     # 6o the sign of byte k to the end of byte
        hbr     cull_spheres_p64_return,$lr             # 7o hint
        rotqbii $signs,$signs,1                         # 8o the sign of byte k to the end of byte
        rotqbii $signs+1,$signs+1,1                     # 9o the sign of byte k to the end of byte
        gbb     $signs+2,$signs+2                       # 10o
        gbb     $signs+3,$signs+3                       # 11o
        gbb     $signs,$signs                           # 12o
        gbb     $signs+1,$signs+1                       # 13o
        shufb   $signs_5,$signs_4,$signs2_2,$m_four     # 14o
        shufb   $signs2_2,$signs+2,$signs+3,$m_two      # 15o
        shufb   $signs_4,$signs,$signs+1,$m_two         # 17o
        stqd    $signs_5,0($a_masks)                    # 18o
        shufb   $signs_5,$signs_4,$signs2_2,$m_four     # 21o
        stqd    $signs_5,0($a_masks_2)                  # 25o
cull_spheres_p64_return:
        bi      $lr                                     # 26o
next_sphere_short:
        ai      $count,$count,-1                        # 0e
        lqd     $a_sphere,0($a_list)                    # 0o
        ai      $a_list,$a_list,16                      # 1e
        lqd     $dx,1008($a_middles)                    # 1o
        lqd     $dx_30,640($a_middles)                  # 2o
        lqd     $dx_2,0($a_middles)                     # 3o
        lqd     $dx_3,32($a_middles)                    # 4o
        lqd     $dx_4,336($a_middles)                   # 5o
        lqd     $quad,0($a_sphere)                      # 6o
        lqd     $dx_32,368($a_middles)                  # 7o
        lqd     $more_2,16($a_sphere)                   # 8o
        lqd     $dx_6,16($a_middles)                    # 9o
        lqd     $dx_7,320($a_middles)                   # 10o
        lqd     $dx_8,672($a_middles)                   # 11o
        lqd     $dx_9,960($a_middles)                   # 12o
        shufb   $cx_2,$quad,$quad,$m_x                  # 13o
        shufb   $limit_2,$more_2,$more_2,$m_limit       # 14o
        lqd     $dx_10,352($a_middles)                  # 15o
        lqd     $dx_11,656($a_middles)                  # 16o
        lqd     $dx_12,992($a_middles)                  # 17o
        fnms    $s+2,$cx_2,$dx_3,$limit_2               # 18e
        lqd     $dx_3,48($a_middles)                    # 18o
        fnms    $s1_8,$cx_2,$dx_4,$limit_2              # 19e
        lqd     $dy_23,720($a_middles)                  # 19o
        fnms    $s_12,$cx_2,$dx_2,$limit_2              # 20e
        lqd     $dx_15,688($a_middles)                  # 20o
        fnms    $s2_11,$cx_2,$dx_10,$limit_2            # 21e
        lqd     $dx_22,976($a_middles)                  # 21o
        fnms    $s1_10,$cx_2,$dx_11,$limit_2            # 22e
        lqd     $dy_9,432($a_middles)                   # 22o
        fnms    $s2_12,$cx_2,$dx_12,$limit_2            # 23e
        lqd     $dy_11,80($a_middles)                   # 23o
        fnms    $s3_11,$cx_2,$dx_3,$limit_2             # 24e
        lqd     $dy_13,0x420($a_middles)                # 24o
        fnms    $s1_7,$cx_2,$dx_6,$limit_2              # 25e
        shufb   $cy_5,$quad,$quad,$m_y                  # 25o
        fnms    $s3_3,$cx_2,$dx_15,$limit_2             # 26e
        lqd     $dy_3,112($a_middles)                   # 26o
        fnms    $s3_12,$cx_2,$dx_32,$limit_2            # 27e
        lqd     $dy_4,0x430($a_middles)                 # 27o
        fnms    $s_11,$cx_2,$dx_7,$limit_2              # 28e
        lqd     $dy_5,400($a_middles)                   # 28o
        fnms    $s_14,$cx_2,$dx_30,$limit_2             # 29e
        lqd     $dy_14,736($a_middles)                  # 29o
        fnms    $s2_8,$cx_2,$dx_8,$limit_2              # 30e
        lqd     $dy_6,0x400($a_middles)                 # 30o
        fnms    $s_15,$cx_2,$dx_9,$limit_2              # 31e
        lqd     $dy_7,0x410($a_middles)                 # 31o
        fnms    $s3_11,$cy_5,$dy_3,$s3_11               # 32e
        lqd     $dz_7,144($a_middles)                   # 32o
        fnms    $s1_6,$cx_2,$dx_22,$limit_2             # 33e
        lqd     $dz_5,176($a_middles)                   # 33o
        fnms    $s2_12,$cy_5,$dy_13,$s2_12              # 34e
        lqd     $dy_13,64($a_middles)                   # 34o
        fnms    $s3_13,$cx_2,$dx,$limit_2               # 35e
        lqd     $dy,96($a_middles)                      # 35o
        fnms    $s1_8,$cy_5,$dy_5,$s1_8                 # 36e
        lqd     $dy_24,384($a_middles)                  # 36o
        fnms    $s3_12,$cy_5,$dy_9,$s3_12               # 37e
        lqd     $dy_9,416($a_middles)                   # 37o
        fnms    $s_15,$cy_5,$dy_6,$s_15                 # 38e
        lqd     $dz_4,480($a_middles)                   # 38o
        fnms    $s1_6,$cy_5,$dy_7,$s1_6                 # 39e
        lqd     $dy_6,704($a_middles)                   # 39o
        fnms    $s1_7,$cy_5,$dy_11,$s1_7                # 40e
        lqd     $dy_11,752($a_middles)                  # 40o
        fnms    $s+2,$cy_5,$dy,$s+2                     # 41e
        lqd     $dz_19,0x440($a_middles)                # 41o
        fnms    $s3_13,$cy_5,$dy_4,$s3_13               # 42e
        lqd     $dz_13,0x450($a_middles)                # 42o
        fnms    $s_12,$cy_5,$dy_13,$s_12                # 43e
        lqd     $dz_11,128($a_middles)                  # 43o
        fnms    $s2_11,$cy_5,$dy_9,$s2_11               # 44e
        lqd     $dz_6,768($a_middles)                   # 44o
        fnms    $s_11,$cy_5,$dy_24,$s_11                # 45e
        lqd     $dz_23,0x460($a_middles)                # 45o
        fnms    $s3_3,$cy_5,$dy_11,$s3_3                # 46e
        lqd     $dz_14,160($a_middles)                  # 46o
        fnms    $s_14,$cy_5,$dy_6,$s_14                 # 47e
        shufb   $cz_3,$quad,$quad,$m_z                  # 47o
        fnms    $s1_10,$cy_5,$dy_23,$s1_10              # 48e
        lqd     $dz_21,448($a_middles)                  # 48o
        fnms    $s2_8,$cy_5,$dy_14,$s2_8                # 49e
        lqd     $dz_24,816($a_middles)                  # 49o
        nop     $127                                    # 50e pairing
        lqd     $dz_15,464($a_middles)                  # 50o
        fnms    $s1_6,$cz_3,$dz_13,$s1_6                # 51e
        lqd     $dz_13,496($a_middles)                  # 51o
        fnms    $s3_11,$cz_3,$dz_5,$s3_11               # 52e
        lqd     $dz_12,784($a_middles)                  # 52o
        fnms    $s_14,$cz_3,$dz_6,$s_14                 # 53e
        lqd     $dz_6,800($a_middles)                   # 53o
        fnms    $s_12,$cz_3,$dz_11,$s_12                # 54e
        lqd     $dz_11,0x470($a_middles)                # 54o
        fnms    $s3_3,$cz_3,$dz_24,$s3_3                # 55e
        fnms    $s1_8,$cz_3,$dz_15,$s1_8                # 56e
        fnms    $s1_7,$cz_3,$dz_7,$s1_7                 # 57e
        fnms    $s1_10,$cz_3,$dz_12,$s1_10              # 58e
        fnms    $s2_8,$cz_3,$dz_6,$s2_8                 # 59e
        fnms    $s3_13,$cz_3,$dz_11,$s3_13              # 60e
        fnms    $s+2,$cz_3,$dz_14,$s+2                  # 61e
        fnms    $s3_12,$cz_3,$dz_13,$s3_12              # 62e
        fnms    $s2_11,$cz_3,$dz_4,$s2_11               # 63e
        shufb   $signs_3,$s_12,$s1_7,$m_signs           # 63o
        fnms    $s_5,$cz_3,$dz_21,$s_11                 # 64e
        shufb   $signs+2,$s_14,$s1_10,$m_signs          # 64o
        fnms    $s,$cz_3,$dz_19,$s_15                   # 65e
        shufb   $signs_low,$s2_8,$s3_3,$m_signs         # 65o
        fnms    $s2_7,$cz_3,$dz_23,$s2_12               # 66e
        shufb   $signs_low_8,$s+2,$s3_11,$m_signs       # 67o
        shufb   $signs+2,$signs+2,$signs_low,$m_halves  # 69o
        shufb   $signs+1,$s_5,$s1_8,$m_signs            # 70o
        shufb   $signs+3,$s,$s1_6,$m_signs              # 71o
        shufb   $signs_low,$s2_7,$s3_13,$m_signs        # 72o
        shufb   $signs_low_5,$s2_11,$s3_12,$m_signs     # 73o
        shufb   $signs,$signs_3,$signs_low_8,$m_halves  # 74o
        rotqbii $signs+2,$signs+2,1                     # 75o the sign of byte k to the end of byte
        shufb   $signs+3,$signs+3,$signs_low,$m_halves  # 76o
        shufb   $signs+1,$signs+1,$signs_low_5,$m_halves # 77o
        rotqbii $signs,$signs,1                         # 78o the sign of byte k to the end of byte
        gbb     $signs+2,$signs+2                       # 79o
        rotqbii $signs+3,$signs+3,1                     # 80o the sign of byte k to the end of byte
        rotqbii $signs+1,$signs+1,1                     # 81o the sign of byte k to the end of byte
        gbb     $signs,$signs                           # 82o
        gbb     $signs+3,$signs+3                       # 84o
        gbb     $signs+1,$signs+1                       # 85o
        shufb   $signs+2,$signs+2,$signs+3,$m_two       # 88o
        shufb   $signs,$signs,$signs+1,$m_two           # 89o
        shufb   $signs,$signs,$signs+2,$m_four          # 93o
        stqd    $signs,0($a_masks)                      # 97o
        ai      $a_masks,$a_masks,16                    # 98e
        brnz    $count,next_sphere_short                # 98o
        nop     $127                                    # 99e pairing
        bi      $lr                                     # 99o
endfunction cull_spheres_p64
