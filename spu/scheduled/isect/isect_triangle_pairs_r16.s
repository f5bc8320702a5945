# isect_triangle_pairs_r16   nearest hit of packets' rays with triangles, candidate by candidate
#   C       void isect_triangle_pairs_r16(const struct candidate *, int count);
#   In      $3 candidates of objects that are triangles, and of shears of their packets, $4 count
#           (0 is none); pointers 16-aligned
#   Out     the candidates' packets: t, object, where a hit has 0 < t < what was there
#   Uses    $2-$76, $79   Saves  -   Stack  0   Calls  -
#   Domain  distances from the origin below 2^60; triangles higher than 2^-50 across the ray
#   Error   6 ulp of t, 8e-5 in barycentric coordinates; edges from 1/100 of the distance to all of
#           it, area across the ray above 1/20 of their square
#   Twin    lab/twins/src/triangle_pairs.rs
#
# As watertight as isect_triangles_r16, with the same steps. But from behind, where the vertices
# are in clockwise order, a triangle is hit only with SIDES_BOTH. The order is counter-clockwise if
# the sum of u, v and w has the sign of direction z.
# Scheduled by spu schedule from isect_triangle_pairs_r16.s

        .include "work_unit.inc"
        .include "macros.inc"
        .include "pairs.inc"
        .include "triangle_tmpl.inc"

        .set    NEXT,3
        registers a_candidate,count
        # constants
        .set    NEXT,10
        registers k_above_one,k_sign,m_splat,m_w,a_controls
        # the candidate
        registers object,a_packet,a_shear,both,vertex_a,vertex_b,vertex_c
        # temporaries
        registers xa,ya,za,xb,yb,zb,xc,yc,zc,axis,origin,slope
        .set    p,31                                    # reused
        .set    q,32                                    # reused
        registers u,v,w,det,inverse,t_y,t_e,n
        .set    NEXT,41
        registers ahead                                 # n
        registers outside,seen,t,t_best,nearest
        .set    control,43                              # reused

        sign_controls_table

function isect_triangle_pairs_r16
        .set count_2,79; .set vertex_b_2,22; .set p_2,51; .set p_3,34; .set p_4,38; .set q_2,62
        .set q_3,25; .set p_5,36; .set q_4,26; .set xc_2,60; .set za_2,2; .set p_6,5; .set p_7,29
        .set zc_2,56; .set yc_2,6; .set p_8,28; .set p_9,30; .set p_10,49; .set p_11,53
        .set xb_2,7; .set p_12,41; .set zb_2,69; .set ya_2,39; .set q_5,24; .set q_6,73
        .set q_7,55; .set zc_3,57; .set q_8,61; .set yc_3,27; .set xc_3,70; .set slope_2,68
        .set yb_2,34; .set yc_4,8; .set slope_3,9; .set q_9,16; .set ya_3,18; .set xc_4,20
        .set q_10,46; .set q_11,23; .set xc_5,54; .set xa_2,58; .set ya_4,62; .set zb_3,26
        .set za_3,65; .set zc_4,66; .set zb_4,52; .set zb_5,36; .set xb_3,27; .set za_4,26
        .set p_13,72; .set xb_4,28; .set zb_6,61; .set zb_7,48; .set xb_5,33; .set ya_5,59
        .set za_5,27; .set xc_6,63; .set xb_6,38; .set za_6,64; .set yc_5,26; .set yc_6,21
        .set xb_7,32; .set yc_7,63; .set slope_4,26; .set slope_5,23; .set slope_6,35
        .set slope_7,71; .set yb_3,29; .set p_14,68; .set xa_3,36; .set ya_6,37; .set slope_8,51
        .set slope_9,41; .set yb_4,42; .set yb_5,5; .set xa_4,67; .set yb_6,22; .set xa_5,19
        .set both_2,60; .set slope_10,29; .set slope_11,31; .set slope_12,40; .set slope_13,38
        .set xb_8,17; .set a_packet_2,76; .set yb_7,32; .set object_2,75; .set xc_7,46; .set ya_7,9
        .set xa_6,15; .set xa_7,16; .set yb_8,18; .set u_2,19; .set v_2,74; .set xa_8,51
        .set q_12,20; .set p_15,24; .set p_16,45; .set p_17,67; .set p_18,55; .set p_19,70
        .set p_20,73; .set q_13,36; .set w_2,6; .set v_3,7; .set q_14,35; .set u_3,26; .set q_15,21
        .set p_21,58; .set v_4,20; .set u_4,39; .set v_5,8; .set q_16,19; .set v_6,41; .set u_5,46
        .set w_3,25; .set v_7,24; .set u_6,23; .set u_7,21; .set q_17,37; .set v_8,32; .set det_2,5
        .set q_18,8; .set v_9,55; .set w_4,7; .set det_3,22; .set det_4,9; .set w_5,28
        .set det_5,15; .set w_6,8; .set control_2,19; .set control_3,35; .set t_y_2,17
        .set control_4,46; .set control_5,42; .set t_y_3,41; .set t_y_4,7; .set control_6,49
        .set t_e_2,5; .set t_y_5,18; .set control_7,15; .set t_e_3,22; .set inverse_2,16
        .set control_8,58; .set t_e_4,35; .set t_e_5,9; .set inverse_3,17; .set v_10,22
        .set inverse_4,5; .set inverse_5,9; .set w_7,37; .set u_8,6; .set v_11,18; .set ahead_2,20
        .set w_8,59; .set u_9,54; .set v_12,53; .set ahead_3,2; .set t_best_2,5; .set t_best_3,7
        .set ahead_4,8; .set t_best_4,9; .set outside_2,16; .set ahead_5,18; .set outside_3,20
        .set ahead_6,6; .set p_22,27; .set t_2,35; .set yb_9,37; .set control_9,38; .set t_3,40
        .set t_4,47; .set control_10,2; .set control_11,50; .set outside_4,52; .set control_12,54
        .set control_13,6; .set xb_9,51; .set yc_8,51; .set zb_8,41; .set q_19,68; .set yc_9,24
        .set ya_8,31; .set xb_10,8; .set xa_9,32; .set yc_10,36; .set xb_11,20; .set slope_14,53
        .set xb_12,72; .set za_7,38; .set xc_8,41; .set slope_15,46; .set slope_16,62
        .set nearest_2,71; .set nearest_3,33; .set v_13,62; .set p_23,40; .set q_20,2
        .set nearest_4,6; .set q_21,33; .set p_24,9; .set q_22,6; .set u_10,28; .set v_14,2
        .set w_9,38; .set v_15,33; .set det_6,40; .set u_11,25; .set det_7,20; .set control_14,18
        .set control_15,16; .set t_y_6,32; .set t_e_6,20; .set nearest_5,35; .set nearest_6,41
        .set inverse_6,20; .set control_16,5; .set nearest_7,16; .set nearest_8,2; .set ahead_7,3
        .set t_best_5,4; .set w_10,5; .set t_best_6,2; .set nearest_9,3; .set p_25,2; .set p_26,6
        .set p_27,7; .set p_28,8; .set p_29,18; .set q_23,22; .set p_30,23; .set xb_13,30
        .set q_24,34; .set xb_14,37; .set yc_11,39; .set zb_9,40; .set q_25,41; .set xc_9,42
        .set zc_5,7; .set xc_10,43; .set ya_9,44; .set zc_6,45; .set slope_17,36; .set ya_10,46
        .set ya_11,47; .set yb_10,9; .set za_8,48; .set zc_7,6; .set slope_18,49; .set yc_12,32
        .set zb_10,18; .set slope_19,34; .set yb_11,31; .set slope_20,50; .set xa_10,2
        .set xa_11,5; .set xa_12,8; .set yb_12,23; .set p_31,52; .set q_26,53; .set q_27,54
        .set za_9,41; .set zc_8,55; .set xc_11,5; .set ya_12,56; .set zb_11,49; .set p_32,57
        .set yb_13,20; .set slope_21,59; .set a_packet_3,60; .set both_3,54; .set slope_22,17
        .set t_best_7,61; .set t_best_8,50; .set p_33,62; .set t_best_9,63; .set p_34,64
        .set v_16,65; .set t_best_10,66; .set nearest_10,67; .set q_28,58; .set nearest_11,68
        .set v_17,69; .set u_12,42; .set nearest_12,70; .set p_35,71; .set nearest_13,72
        .set p_36,74; .set ya_13,19; .set q_29,39; .set u_13,52; .set u_14,56; .set q_30,43
        .set q_31,29; .set q_32,28; .set w_11,9; .set u_15,29; .set u_16,30; .set v_18,28
        .set v_19,31; .set w_12,23; .set p_37,26; .set w_13,22; .set v_20,9; .set det_8,23
        .set det_9,32; .set t_y_7,5; .set t_y_8,19; .set control_17,20; .set t_y_9,21
        .set control_18,26; .set det_10,16; .set t_e_7,23; .set t_e_8,32; .set t_e_9,33
        .set inverse_7,19; .set control_19,21; .set t_y_10,23; .set u_17,32; .set v_21,30
        .set ahead_8,31; .set ahead_9,24; .set ahead_10,37; .set ahead_11,16; .set ahead_12,22
        .set w_14,19; .set ahead_13,7; .set outside_5,18; .set outside_6,2; .set t_5,19
        .set t_6,22; .set control_20,23; .set outside_7,8; .set control_21,7; .set outside_8,7
        .set t_7,6; .set t_best_11,8; .set nearest_14,9
        nop     $127                                    # 0e pairing
        biz     $count,$lr                              # 0o
        ilhu    $m_w,0xc0d                              # 1e
        ilhu    $k_above_one,0x3f80                     # 2e
        clgti   $count_2,$count,1                       # 3e at least as many passes as overlap
        ila     $m_splat,0x10203                        # 4e
        iohl    $m_w,0xe0f                              # 5e
        iohl    $k_above_one,2                          # 6e
        ilhu    $k_sign,0x8000                          # 7e
        lnop                                            # 7o pairing
        ila     $a_controls,sign_controls               # 8e
        brz     $count_2,next_triangle_short            # 8o too few passes
        ai      $count,$count,-1                        # 9e
        lqd     $object,0($a_candidate)                 # 9o
        ai      $a_candidate,$a_candidate,16            # 10e
        rotqbyi $a_shear,$object,12                     # 15o
        lqd     $vertex_a,48($object)                   # 16o
        lqd     $vertex_c,80($object)                   # 17o
        lqd     $vertex_b_2,64($object)                 # 18o
        lqd     $p_2,16($a_shear)                       # 19o
        lqd     $p_3,80($a_shear)                       # 20o
        lqd     $p_4,144($a_shear)                      # 21o
        lqd     $q_2,272($a_shear)                      # 22o
        lqd     $q_3,208($a_shear)                      # 23o
        lqd     $p_5,128($a_shear)                      # 24o
        lqd     $q_4,336($a_shear)                      # 25o
        shufb   $xc_2,$vertex_c,$vertex_c,$p_2          # 26o
        shufb   $za_2,$vertex_a,$vertex_a,$p_4          # 27o
        lqd     $p_6,112($a_shear)                      # 28o
        lqd     $p_7,64($a_shear)                       # 29o
        fs      $xc_2,$xc_2,$q_3                        # 30e
        shufb   $zc_2,$vertex_c,$vertex_c,$p_4          # 30o
        fs      $za_2,$za_2,$q_4                        # 31e
        shufb   $yc_2,$vertex_c,$vertex_c,$p_3          # 31o
        lqd     $p,48($a_shear)                         # 32o
        lqd     $p_8,176($a_shear)                      # 33o
        fs      $zc_2,$zc_2,$q_4                        # 34e
        lqd     $p_9,160($a_shear)                      # 34o
        fs      $yc_2,$yc_2,$q_2                        # 35e
        lqd     $p_10,96($a_shear)                      # 35o
        lqd     $p_11,32($a_shear)                      # 36o
        shufb   $xb_2,$vertex_b_2,$vertex_b_2,$p_2      # 37o
        lqd     $p_12,0($a_shear)                       # 38o
        shufb   $zb_2,$vertex_b_2,$vertex_b_2,$p_4      # 39o
        nop     $127                                    # 40e pairing
        shufb   $ya_2,$vertex_a,$vertex_a,$p_3          # 40o
        fs      $xb_2,$xb_2,$q_3                        # 41e
        lqd     $q_5,304($a_shear)                      # 41o
        nop     $127                                    # 42e pairing
        lqd     $q_6,192($a_shear)                      # 42o
        fs      $zb_2,$zb_2,$q_4                        # 43e
        lqd     $q_7,288($a_shear)                      # 43o
        fs      $ya_2,$ya_2,$q_2                        # 44e
        shufb   $zc_3,$vertex_c,$vertex_c,$p_8          # 44o
        lqd     $q_8,320($a_shear)                      # 45o
        shufb   $yc_3,$vertex_c,$vertex_c,$p_6          # 46o
        shufb   $xc_3,$vertex_c,$vertex_c,$p_12         # 47o
        lqd     $slope_2,400($a_shear)                  # 48o
        nop     $127                                    # 49e pairing
        shufb   $yb_2,$vertex_b_2,$vertex_b_2,$p_3      # 49o
        fs      $yc_4,$yc_3,$q_5                        # 50e
        lqd     $slope_3,464($a_shear)                  # 50o
        fs      $xc_3,$xc_3,$q_6                        # 51e
        lqd     $q,368($a_shear)                        # 51o
        nop     $127                                    # 52e pairing
        lqd     $q_9,240($a_shear)                      # 52o
        fs      $yb_2,$yb_2,$q_2                        # 53e
        shufb   $ya_3,$vertex_a,$vertex_a,$p_6          # 53o
        fnms    $xc_4,$slope_2,$zc_2,$xc_2              # 54e
        lqd     $q_10,256($a_shear)                     # 54o
        fnms    $xb_2,$slope_2,$zb_2,$xb_2              # 55e
        lqd     $q_11,352($a_shear)                     # 55o
        fnms    $ya_2,$slope_3,$za_2,$ya_2              # 56e
        shufb   $xc_5,$vertex_c,$vertex_c,$p            # 56o
        fnms    $yc_2,$slope_3,$zc_2,$yc_2              # 57e
        shufb   $xa_2,$vertex_a,$vertex_a,$p_2          # 57o
        fs      $ya_3,$ya_3,$q_5                        # 58e
        shufb   $ya_4,$vertex_a,$vertex_a,$p_10         # 58o
        fs      $zc_3,$zc_3,$q                          # 59e
        shufb   $zb_3,$vertex_b_2,$vertex_b_2,$p_8      # 59o
        fs      $xc_5,$xc_5,$q_9                        # 60e
        shufb   $za_3,$vertex_a,$vertex_a,$p_5          # 60o
        fs      $xa_2,$xa_2,$q_3                        # 61e
        shufb   $zc_4,$vertex_c,$vertex_c,$p_5          # 61o
        fs      $ya_4,$ya_4,$q_7                        # 62e
        lqd     $q_3,224($a_shear)                      # 62o
        fs      $zb_4,$zb_3,$q                          # 63e
        shufb   $zb_5,$vertex_b_2,$vertex_b_2,$p_5      # 63o
        fs      $za_3,$za_3,$q_8                        # 64e
        shufb   $xb_3,$vertex_b_2,$vertex_b_2,$p        # 64o
        fs      $zc_4,$zc_4,$q_8                        # 65e
        shufb   $za_4,$vertex_a,$vertex_a,$p_8          # 65o
        fm      $p_13,$ya_2,$xc_4                       # 66e
        shufb   $xb_4,$vertex_b_2,$vertex_b_2,$p_12     # 66o
        fs      $zb_6,$zb_5,$q_8                        # 67e
        shufb   $zb_7,$vertex_b_2,$vertex_b_2,$p_9      # 67o
        fs      $xb_5,$xb_3,$q_9                        # 68e
        shufb   $ya_5,$vertex_a,$vertex_a,$p_7          # 68o
        fs      $za_5,$za_4,$q                          # 69e
        shufb   $xc_6,$vertex_c,$vertex_c,$p_11         # 69o
        fs      $xb_6,$xb_4,$q_6                        # 70e
        shufb   $za_6,$vertex_a,$vertex_a,$p_9          # 70o
        fs      $zb_7,$zb_7,$q_11                       # 71e
        shufb   $yc_5,$vertex_c,$vertex_c,$p_10         # 71o
        fs      $ya_5,$ya_5,$q_10                       # 72e
        shufb   $zc,$vertex_c,$vertex_c,$p_9            # 72o
        fs      $xc,$xc_6,$q_3                          # 73e
        shufb   $yc_6,$vertex_c,$vertex_c,$p_7          # 73o
        fs      $za_6,$za_6,$q_11                       # 74e
        shufb   $xb_7,$vertex_b_2,$vertex_b_2,$p_11     # 74o
        fs      $yc_7,$yc_5,$q_7                        # 75e
        lqd     $slope_4,480($a_shear)                  # 75o
        fs      $zc,$zc,$q_11                           # 76e
        lqd     $slope_5,496($a_shear)                  # 76o
        fs      $yc_6,$yc_6,$q_10                       # 77e
        lqd     $slope_6,448($a_shear)                  # 77o
        fs      $xb_7,$xb_7,$q_3                        # 78e
        lqd     $slope_7,416($a_shear)                  # 78o
        fnms    $xa_2,$slope_2,$za_2,$xa_2              # 79e
        shufb   $yb_3,$vertex_b_2,$vertex_b_2,$p_7      # 79o
        fm      $p_14,$yc_2,$xb_2                       # 80e
        shufb   $xa_3,$vertex_a,$vertex_a,$p_12         # 80o
        fnms    $ya_6,$slope_4,$za_6,$ya_4              # 81e
        lqd     $slope_8,432($a_shear)                  # 81o
        fnms    $yc_4,$slope_5,$zc_3,$yc_4              # 82e
        lqd     $slope_9,384($a_shear)                  # 82o
        fnms    $ya_5,$slope_6,$za_3,$ya_5              # 83e
        shufb   $yb_4,$vertex_b_2,$vertex_b_2,$p_10     # 83o
        fnms    $xc,$slope_7,$zc,$xc                    # 84e
        shufb   $yb_5,$vertex_b_2,$vertex_b_2,$p_6      # 84o
        fnms    $yc_7,$slope_4,$zc,$yc_7                # 85e
        shufb   $xa_4,$vertex_a,$vertex_a,$p            # 85o
        fs      $yb_6,$yb_3,$q_10                       # 86e
        shufb   $xa_5,$vertex_a,$vertex_a,$p_11         # 86o
        fnms    $xc_5,$slope_8,$zc_3,$xc_5              # 87e
        lqd     $both_2,32($object)                     # 87o
        fs      $xa_3,$xa_3,$q_6                        # 88e
        lqd     $slope_10,512($a_shear)                 # 88o
        fnms    $xb_5,$slope_8,$zb_4,$xb_5              # 89e
        lqd     $slope_11,544($a_shear)                 # 89o
        fs      $xa_5,$xa_5,$q_3                        # 90e
        lqd     $slope_12,528($a_shear)                 # 90o
        fnms    $xb,$slope_9,$zb_6,$xb_6                # 91e
        lqd     $slope_13,560($a_shear)                 # 91o
        fnms    $xb_8,$slope_7,$zb_7,$xb_7              # 92e
        rotqbyi $a_packet_2,$object,4                   # 92o
        fs      $yb_7,$yb_4,$q_7                        # 93e
        shufb   $both_2,$both_2,$both_2,$m_w            # 93o
        fs      $xa_4,$xa_4,$q_9                        # 94e
        shufb   $object_2,$object,$object,$m_splat      # 94o
        fnms    $xc_7,$slope_9,$zc_4,$xc_3              # 95e
        fnms    $yb_2,$slope_3,$zb_2,$yb_2              # 96e
        fs      $yb_5,$yb_5,$q_5                        # 97e
        rotqbii $both_2,$both_2,1                       # 97o
        fnms    $ya_7,$slope_5,$za_5,$ya_3              # 98e
        fnms    $yc_6,$slope_6,$zc_4,$yc_6              # 99e
        fnms    $xa_6,$slope_9,$za_3,$xa_3              # 100e
        fnms    $xa_7,$slope_7,$za_6,$xa_5              # 101e
        fnms    $yb_8,$slope_4,$zb_7,$yb_7              # 102e
        fms     $u_2,$xc_4,$yb_2,$p_14                  # 103e
        fnms    $yb_6,$slope_6,$zb_6,$yb_6              # 104e
        fms     $v_2,$xa_2,$yc_2,$p_13                  # 105e
        fnms    $xa_8,$slope_8,$za_5,$xa_4              # 106e
        fms     $q_12,$ya_2,$xc_4,$p_13                 # 107e
        fm      $p_15,$yb_2,$xa_2                       # 108e
        fm      $p_16,$ya_7,$xc_5                       # 109e
        fm      $p_17,$yc_6,$xb                         # 110e
        fnms    $yb_5,$slope_5,$zb_4,$yb_5              # 111e
        fm      $p_10,$yc_4,$xb_5                       # 112e
        fm      $p_18,$ya_5,$xc_7                       # 113e
        fm      $p_19,$ya_6,$xc                         # 114e
        fm      $p_20,$yc_7,$xb_8                       # 115e
        fms     $q_13,$yc_2,$xb_2,$p_14                 # 116e
        fms     $q_2,$ya_7,$xc_5,$p_16                  # 117e
        fms     $w_2,$xb_2,$ya_2,$p_15                  # 118e
        fms     $v_3,$xa_6,$yc_6,$p_18                  # 119e
        fms     $q_14,$yc_4,$xb_5,$p_10                 # 120e
        fms     $q_11,$yc_7,$xb_8,$p_20                 # 121e
        fms     $u_3,$xc,$yb_8,$p_20                    # 122e
        fms     $q_15,$yc_6,$xb,$p_17                   # 123e
        fm      $p_11,$yb_6,$xa_6                       # 124e
        fms     $q_7,$ya_5,$xc_7,$p_18                  # 125e
        fms     $q_5,$yb_2,$xa_2,$p_15                  # 126e
        fm      $p_21,$yb_5,$xa_8                       # 127e
        fs      $v_4,$v_2,$q_12                         # 128e
        fs      $u,$u_2,$q_13                           # 129e
        fms     $u_4,$xc_5,$yb_5,$p_10                  # 130e
        fms     $v_5,$xa_8,$yc_4,$p_16                  # 131e
        fms     $q_16,$ya_6,$xc,$p_19                   # 132e
        fm      $p_8,$yb_8,$xa_7                        # 133e
        fms     $v_6,$xa_7,$yc_7,$p_19                  # 134e
        fms     $u_5,$xc_7,$yb_6,$p_17                  # 135e
        fms     $w_3,$xb,$ya_5,$p_11                    # 136e
        fs      $w_2,$w_2,$q_5                          # 137e
        fs      $v_7,$v_5,$q_2                          # 138e
        fms     $w,$xb_8,$ya_6,$p_8                     # 139e
        fs      $u_6,$u_3,$q_11                         # 140e
        fs      $u_7,$u_5,$q_15                         # 141e
        fs      $u_3,$u_4,$q_14                         # 142e
        fms     $q_17,$yb_5,$xa_8,$p_21                 # 143e
        fs      $v_8,$v_6,$q_16                         # 144e
        fa      $det_2,$u,$v_4                          # 145e
        fms     $q_18,$yb_8,$xa_7,$p_8                  # 146e
        fms     $q_16,$yb_6,$xa_6,$p_11                 # 147e
        fs      $v_9,$v_3,$q_7                          # 148e
        fms     $w_4,$xb_5,$ya_7,$p_21                  # 149e
        fa      $det_3,$u_6,$v_8                        # 150e
        fa      $det_4,$u_3,$v_7                        # 151e
        fs      $w_5,$w,$q_18                           # 152e
        fa      $det_2,$det_2,$w_2                      # 153e
        fa      $det_5,$u_7,$v_9                        # 154e
        fs      $w_6,$w_4,$q_17                         # 155e
        fs      $w,$w_3,$q_16                           # 156e
        fa      $det_3,$det_3,$w_5                      # 158e
        xor     $control_2,$det_2,$slope_12             # 159e of -1 / direction z
        frest   $t_y,$det_2                             # 159o
        fa      $det,$det_4,$w_6                        # 161e
        fa      $det_4,$det_5,$w                        # 162e
        fi      $t_y,$det_2,$t_y                        # 163e
        lnop                                            # 163o pairing
        xor     $control_3,$det_3,$slope_11             # 164e of -1 / direction z
        frest   $t_y_2,$det_3                           # 164o
        or      $control_2,$control_2,$both_2           # 165e
        or      $control_4,$control_3,$both_2           # 166e
        xor     $control_5,$det,$slope_13               # 167e of -1 / direction z
        frest   $t_y_3,$det                             # 167o
        fi      $t_y_2,$det_3,$t_y_2                    # 168e
        frest   $t_y_4,$det_4                           # 168o
        or      $control_6,$control_5,$both_2           # 169e
        fnms    $t_e_2,$det_2,$t_y,$k_above_one         # 170e
        fi      $t_y_5,$det,$t_y_3                      # 171e
        fi      $t_y_4,$det_4,$t_y_4                    # 172e
        xor     $control_7,$det_4,$slope_10             # 173e of -1 / direction z
        fnms    $t_e_3,$det_3,$t_y_2,$k_above_one       # 175e
        fma     $inverse_2,$t_e_2,$t_y,$t_y             # 176e
        or      $control_8,$control_7,$both_2           # 177e
        fnms    $t_e_4,$det,$t_y_5,$k_above_one         # 178e
        fnms    $t_e_5,$det_4,$t_y_4,$k_above_one       # 179e
        fma     $inverse_3,$t_e_3,$t_y_2,$t_y_2         # 181e
        fm      $u,$u,$inverse_2                        # 182e
        fm      $v_10,$v_4,$inverse_2                   # 183e
        fma     $inverse_4,$t_e_4,$t_y_5,$t_y_5         # 184e
        fma     $inverse_5,$t_e_5,$t_y_4,$t_y_4         # 185e
        fm      $w_7,$w_2,$inverse_2                    # 186e
        fm      $u_8,$u_6,$inverse_3                    # 187e
        fm      $v_11,$v_8,$inverse_3                   # 188e
        fm      $ahead_2,$u,$za_2                       # 189e
        fm      $u_6,$u_3,$inverse_4                    # 190e
        fm      $w_8,$w,$inverse_5                      # 191e
        fm      $u_9,$u_7,$inverse_5                    # 192e
        fm      $v_12,$v_9,$inverse_5                   # 193e
        lnop                                            # 193o pairing
next_triangle:
            or      $outside,$u_8,$v_11                 # 0e
            lnop                                        # 0o pairing
            fm      $v,$v_7,$inverse_4                  # 1e
        lqd     $object,0($a_candidate)                 # 1o
            fm      $ahead,$u_8,$za_6                   # 2e
            lnop                                        # 2o pairing
            fm      $w,$w_6,$inverse_4                  # 3e
            lqd     $t_best,432($a_packet_2)            # 3o
            fm      $ahead_3,$u_6,$za_5                 # 4e
            lqd     $t_best_2,416($a_packet_2)          # 4o
            fm      $w_2,$w_5,$inverse_3                # 5e
            lqd     $t_best_3,400($a_packet_2)          # 5o
            fm      $ahead_4,$u_9,$za_3                 # 6e
            lqd     $t_best_4,384($a_packet_2)          # 6o
            or      $outside_2,$u,$v_10                 # 7e
        rotqbyi $a_shear,$object,12                     # 7o
            fma     $ahead,$v_11,$zb_7,$ahead           # 8e
            fma     $ahead_5,$v_10,$zb_2,$ahead_2       # 9e
            fma     $ahead_3,$v,$zb_4,$ahead_3          # 10e
            or      $outside_2,$outside_2,$w_7          # 11e
            fma     $ahead_4,$v_12,$zb_6,$ahead_4       # 12e
        lqd     $vertex_c,80($object)                   # 12o
            orc     $outside_2,$outside_2,$control_2    # 13e
        lqd     $vertex_a,48($object)                   # 13o
            or      $outside_3,$u_6,$v                  # 14e
        lqd     $vertex_b_2,64($object)                 # 14o
            fma     $ahead,$w_2,$zc,$ahead              # 15e
        lqd     $slope,480($a_shear)                    # 15o
            fma     $ahead_3,$w,$zc_3,$ahead_3          # 16e
        lqd     $slope_5,496($a_shear)                  # 16o
            or      $outside,$outside,$w_2              # 17e
        lqd     $q,368($a_shear)                        # 17o
            fma     $ahead_6,$w_8,$zc_4,$ahead_4        # 18e
        lqd     $q_18,240($a_shear)                     # 18o
            or      $outside_3,$outside_3,$w            # 19e
        lqd     $q_5,304($a_shear)                      # 19o
            fma     $ahead_5,$w_7,$zc_2,$ahead_5        # 20e
        lqd     $q_3,208($a_shear)                      # 20o
            fm      $ahead,$ahead,$slope_11             # 21e
        lqd     $q_4,336($a_shear)                      # 21o
            fm      $ahead_3,$ahead_3,$slope_13         # 22e
        lqd     $p,48($a_shear)                         # 22o
            orc     $outside,$outside,$control_4        # 23e
        lqd     $p_22,112($a_shear)                     # 23o
            orc     $outside_3,$outside_3,$control_6    # 24e
        lqd     $p_8,176($a_shear)                      # 24o
            fm      $ahead_6,$ahead_6,$slope_10         # 25e
        lqd     $p_7,64($a_shear)                       # 25o
            fm      $ahead_5,$ahead_5,$slope_12         # 26e
        lqd     $p_9,160($a_shear)                      # 26o
            xor     $t,$ahead,$k_sign                   # 27e
        lqd     $p_3,80($a_shear)                       # 27o
            xor     $t_2,$ahead_3,$k_sign               # 28e
        lqd     $p_5,128($a_shear)                      # 28o
            cgt     $control,$t_best_2,$t               # 29e
        shufb   $yb_9,$vertex_b_2,$vertex_b_2,$p_22     # 29o
            cgt     $control_9,$t_best,$t_2             # 30e
        shufb   $ya_2,$vertex_a,$vertex_a,$p_22         # 30o
            xor     $t_3,$ahead_6,$k_sign               # 31e
        lqd     $q_10,256($a_shear)                     # 31o
            xor     $t_4,$ahead_5,$k_sign               # 32e
        shufb   $zb_7,$vertex_b_2,$vertex_b_2,$p_9      # 32o
            and     $control_10,$control_9,$ahead_3     # 33e
        lqd     $p_4,144($a_shear)                      # 33o
        fs      $yb_9,$yb_9,$q_5                        # 34e
        lqd     $p_10,96($a_shear)                      # 34o
            cgt     $control_11,$t_best_3,$t_4          # 35e
        lqd     $p_2,16($a_shear)                       # 35o
            andc    $control_10,$control_10,$outside_3  # 36e
        lqd     $q_12,352($a_shear)                     # 36o
            or      $outside_4,$u_9,$v_12               # 37e
        lqd     $p_11,32($a_shear)                      # 37o
            cgt     $control_12,$t_best_4,$t_3          # 38e
        lqd     $q_7,288($a_shear)                      # 38o
            or      $outside_4,$outside_4,$w_8          # 39e
        shufb   $zc_2,$vertex_c,$vertex_c,$p_4          # 39o
            and     $control_13,$control_12,$ahead_6    # 40e
        shufb   $xc_5,$vertex_c,$vertex_c,$p            # 40o
            orc     $outside_4,$outside_4,$control_8    # 41e
        shufb   $zc_3,$vertex_c,$vertex_c,$p_8          # 41o
        fs      $zb_7,$zb_7,$q_12                       # 42e
        shufb   $xa_2,$vertex_a,$vertex_a,$p_2          # 42o
        fs      $ya_2,$ya_2,$q_5                        # 43e
        shufb   $ya_5,$vertex_a,$vertex_a,$p_7          # 43o
        fs      $xc_5,$xc_5,$q_18                       # 44e
        shufb   $xc_2,$vertex_c,$vertex_c,$p_2          # 44o
        fs      $zc_2,$zc_2,$q_4                        # 45e
        shufb   $xb_9,$vertex_b_2,$vertex_b_2,$p_2      # 45o
        fs      $zc_3,$zc_3,$q                          # 46e
        lqd     $q_8,320($a_shear)                      # 46o
        fs      $xa_2,$xa_2,$q_3                        # 47e
        shufb   $ya_4,$vertex_a,$vertex_a,$p_10         # 47o
        fs      $xc_2,$xc_2,$q_3                        # 48e
        shufb   $xc_6,$vertex_c,$vertex_c,$p_11         # 48o
        fs      $ya_5,$ya_5,$q_10                       # 49e
        shufb   $za_6,$vertex_a,$vertex_a,$p_9          # 49o
        fs      $xb,$xb_9,$q_3                          # 50e
        shufb   $yc_8,$vertex_c,$vertex_c,$p_3          # 50o
            and     $control,$control,$ahead            # 51e
        shufb   $zb_8,$vertex_b_2,$vertex_b_2,$p_8      # 51o
        fs      $ya_4,$ya_4,$q_7                        # 52e
        shufb   $za_3,$vertex_a,$vertex_a,$p_5          # 52o
        fs      $za_6,$za_6,$q_12                       # 53e
        shufb   $zc_4,$vertex_c,$vertex_c,$p_5          # 53o
            andc    $control_13,$control_13,$outside_4  # 54e
        shufb   $yc_3,$vertex_c,$vertex_c,$p_22         # 54o
        fs      $zb_4,$zb_8,$q                          # 55e
        lqd     $p_12,0($a_shear)                       # 55o
        fs      $za_3,$za_3,$q_8                        # 56e
        shufb   $xa_4,$vertex_a,$vertex_a,$p            # 56o
        fs      $zc_4,$zc_4,$q_8                        # 57e
        lqd     $q_19,224($a_shear)                     # 57o
        fs      $yc_9,$yc_3,$q_5                        # 58e
        shufb   $xb_3,$vertex_b_2,$vertex_b_2,$p        # 58o
        fnms    $ya_8,$slope,$za_6,$ya_4                # 59e
        lqd     $q_2,272($a_shear)                      # 59o
        fs      $xa_4,$xa_4,$q_18                       # 60e
        shufb   $zb_2,$vertex_b_2,$vertex_b_2,$p_4      # 60o
        fnms    $yb_9,$slope_5,$zb_4,$yb_9              # 61e
        shufb   $zb_5,$vertex_b_2,$vertex_b_2,$p_5      # 61o
        fs      $xb_10,$xb_3,$q_18                      # 62e
        shufb   $za_5,$vertex_a,$vertex_a,$p_8          # 62o
        fs      $xc,$xc_6,$q_19                         # 63e
        shufb   $yc_7,$vertex_c,$vertex_c,$p_10         # 63o
        fs      $zb_2,$zb_2,$q_4                        # 64e
        shufb   $xc_3,$vertex_c,$vertex_c,$p_12         # 64o
        fs      $zb_6,$zb_5,$q_8                        # 65e
        shufb   $zc,$vertex_c,$vertex_c,$p_9            # 65o
        fs      $za_5,$za_5,$q                          # 66e
        shufb   $xa_9,$vertex_a,$vertex_a,$p_11         # 66o
        fs      $yc_10,$yc_8,$q_2                       # 67e
        lqd     $slope_8,432($a_shear)                  # 67o
        fs      $yc_7,$yc_7,$q_7                        # 68e
        shufb   $yc_6,$vertex_c,$vertex_c,$p_7          # 68o
        fs      $zc,$zc,$q_12                           # 69e
        shufb   $xb_11,$vertex_b_2,$vertex_b_2,$p_11    # 69o
        fnms    $yc_9,$slope_5,$zc_3,$yc_9              # 70e
        lqd     $slope_14,448($a_shear)                 # 70o
        fs      $xa_9,$xa_9,$q_19                       # 71e
        lqd     $slope_7,416($a_shear)                  # 71o
        fs      $yc_6,$yc_6,$q_10                       # 72e
        shufb   $xb_12,$vertex_b_2,$vertex_b_2,$p_12    # 72o
        fs      $xb_11,$xb_11,$q_19                     # 73e
        lqd     $slope_2,400($a_shear)                  # 73o
        fnms    $xb_10,$slope_8,$zb_4,$xb_10            # 74e
        lqd     $q_6,192($a_shear)                      # 74o
        fnms    $xc_5,$slope_8,$zc_3,$xc_5              # 75e
        shufb   $yb_3,$vertex_b_2,$vertex_b_2,$p_7      # 75o
        fnms    $ya,$slope_5,$za_5,$ya_2                # 76e
        shufb   $ya_2,$vertex_a,$vertex_a,$p_3          # 76o
        fnms    $xc,$slope_7,$zc,$xc                    # 77e
        shufb   $za_7,$vertex_a,$vertex_a,$p_4          # 77o
        fnms    $ya_5,$slope_14,$za_3,$ya_5             # 78e
        shufb   $yb_2,$vertex_b_2,$vertex_b_2,$p_3      # 78o
        fnms    $yc_7,$slope,$zc,$yc_7                  # 79e
        shufb   $xa_5,$vertex_a,$vertex_a,$p_12         # 79o
        fnms    $xc_8,$slope_2,$zc_2,$xc_2              # 80e
        lqd     $both_2,32($object)                     # 80o
        fs      $yb_3,$yb_3,$q_10                       # 81e
        fs      $za_4,$za_7,$q_4                        # 82e
        fs      $yb_2,$yb_2,$q_2                        # 83e
        lnop                                            # 83o pairing
        fs      $xb_6,$xb_12,$q_6                       # 84e
        lqd     $slope_15,384($a_shear)                 # 84o
        fs      $ya_2,$ya_2,$q_2                        # 85e
        lqd     $slope_16,464($a_shear)                 # 85o
        fs      $xa_5,$xa_5,$q_6                        # 86e
        shufb   $both_2,$both_2,$both_2,$m_w            # 86o
        fs      $xc_3,$xc_3,$q_6                        # 87e
            rotqbii $control_13,$control_13,1           # 87o
        fnms    $yb_3,$slope_14,$zb_6,$yb_3             # 88e
        fnms    $xb,$slope_2,$zb_2,$xb                  # 89e
        fnms    $xa_2,$slope_2,$za_4,$xa_2              # 90e
        fnms    $xb_6,$slope_15,$zb_6,$xb_6             # 91e
        fnms    $ya_2,$slope_16,$za_4,$ya_2             # 92e
        rotqbii $both_2,$both_2,1                       # 92o
        fnms    $xa_5,$slope_15,$za_3,$xa_5             # 93e
            rotqbii $control_10,$control_10,1           # 93o
        fnms    $yc_6,$slope_14,$zc_4,$yc_6             # 94e
        lnop                                            # 94o pairing
        fnms    $xc_7,$slope_15,$zc_4,$xc_3             # 95e
        shufb   $yb_6,$vertex_b_2,$vertex_b_2,$p_10     # 95o
        fm      $p_10,$yc_9,$xb_10                      # 96e
        lnop                                            # 96o pairing
        fnms    $yc_10,$slope_16,$zc_2,$yc_10           # 97e
            gb      $control_10,$control_10             # 97o
        fnms    $xa_9,$slope_7,$za_6,$xa_9              # 98e
            gb      $control_13,$control_13             # 98o
        fm      $p_11,$yb_3,$xa_5                       # 99e
        fnms    $xb_11,$slope_7,$zb_7,$xb_11            # 100e
        fs      $yb_6,$yb_6,$q_7                        # 101e
            shlqbii $control_10,$control_10,4           # 101o
        fm      $p_18,$ya_5,$xc_7                       # 102e
            shlqbii $control_13,$control_13,4           # 102o
        fm      $p_14,$yc_10,$xb                        # 103e
        lnop                                            # 103o pairing
        fm      $p_19,$ya_8,$xc                         # 104e
            lqd     $nearest_2,496($a_packet_2)         # 104o
        fm      $p_13,$ya_2,$xc_8                       # 105e
            lqx     $control_10,$control_10,$a_controls # 105o
        fm      $p_20,$yc_7,$xb_11                      # 106e
            lqx     $control_13,$control_13,$a_controls # 106o
        fnms    $yb_2,$slope_16,$zb_2,$yb_2             # 107e
        lnop                                            # 107o pairing
        fnms    $yb_6,$slope,$zb_7,$yb_6                # 108e
            lqd     $nearest_3,448($a_packet_2)         # 108o
        fms     $v_13,$xa_5,$yc_6,$p_18                 # 109e
        fms     $q_7,$ya_5,$xc_7,$p_18                  # 110e
        fms     $v_2,$xa_2,$yc_10,$p_13                 # 111e
            shufb   $nearest_2,$nearest_2,$object_2,$control_10 # 111o
        fnms    $xa_8,$slope_8,$za_5,$xa_4              # 112e
            shufb   $t_best_4,$t_best_4,$t_3,$control_13 # 112o
        fm      $p_23,$yb_2,$xa_2                       # 113e
            shufb   $t_best,$t_best,$t_2,$control_10    # 113o
        fms     $q_20,$ya_2,$xc_8,$p_13                 # 114e
            shufb   $nearest_4,$nearest_3,$object_2,$control_13 # 114o
        fms     $q_21,$ya_8,$xc,$p_19                   # 115e
            stqd    $nearest_2,496($a_packet_2)         # 115o
        fms     $q_14,$yc_9,$xb_10,$p_10                # 116e
            stqd    $t_best_4,384($a_packet_2)          # 116o
        fm      $p_24,$yb_6,$xa_9                       # 117e
            stqd    $t_best,432($a_packet_2)            # 117o
        fm      $p_16,$ya,$xc_5                         # 118e
            stqd    $nearest_4,448($a_packet_2)         # 118o
        fms     $q_22,$yb_2,$xa_2,$p_23                 # 119e
        fm      $p_21,$yb_9,$xa_8                       # 120e
        fms     $u_10,$xc,$yb_6,$p_20                   # 121e
        fs      $v_14,$v_2,$q_20                        # 122e
        fm      $p_17,$yc_6,$xb_6                       # 123e
        fms     $u,$xc_8,$yb_2,$p_14                    # 124e
        fms     $q_13,$yc_10,$xb,$p_14                  # 125e
        fms     $v_6,$xa_9,$yc_7,$p_19                  # 126e
        fs      $v_9,$v_13,$q_7                         # 127e
        fms     $q_2,$ya,$xc_5,$p_16                    # 128e
        fms     $q_15,$yc_6,$xb_6,$p_17                 # 129e
        fms     $u_5,$xc_7,$yb_3,$p_17                  # 130e
        fms     $w_3,$xb,$ya_2,$p_23                    # 131e
        fs      $u,$u,$q_13                             # 132e
        fms     $q_13,$yc_7,$xb_11,$p_20                # 133e
        fms     $w_9,$xb_6,$ya_5,$p_11                  # 134e
        fms     $u_4,$xc_5,$yb_9,$p_10                  # 135e
        fms     $q_17,$yb_9,$xa_8,$p_21                 # 136e
        fs      $v_15,$v_6,$q_21                        # 137e
        fa      $det_6,$u,$v_14                         # 138e
        fs      $u_7,$u_5,$q_15                         # 139e
        fs      $w_2,$w_3,$q_22                         # 140e
        fms     $v_7,$xa_8,$yc_9,$p_16                  # 141e
        fs      $u_11,$u_10,$q_13                       # 142e
        fms     $q,$yb_6,$xa_9,$p_24                    # 143e
        fms     $w,$xb_11,$ya_8,$p_24                   # 144e
        fa      $det_4,$u_7,$v_9                        # 145e
        fa      $det_7,$det_6,$w_2                      # 146e
        fms     $q_16,$yb_3,$xa_5,$p_11                 # 147e
        lnop                                            # 147o pairing
        fa      $det_3,$u_11,$v_15                      # 148e
        lqd     $slope_12,528($a_shear)                 # 148o
        fs      $v_7,$v_7,$q_2                          # 149e
        fms     $w_6,$xb_10,$ya,$p_21                   # 150e
        fs      $u_6,$u_4,$q_14                         # 151e
        lnop                                            # 151o pairing
        fs      $w_5,$w,$q                              # 152e
        frest   $t_y,$det_7                             # 152o
        fs      $w,$w_9,$q_16                           # 153e
        xor     $control_2,$det_7,$slope_12             # 154e of -1 / direction z
            andc    $control,$control,$outside          # 155e
        fs      $w_6,$w_6,$q_17                         # 156e
        fa      $det,$u_6,$v_7                          # 157e
            rotqbii $control,$control,1                 # 157o
        fa      $det_3,$det_3,$w_5                      # 158e
        lnop                                            # 158o pairing
        fa      $det_4,$det_4,$w                        # 159e
        lqd     $slope_10,512($a_shear)                 # 159o
        fi      $t_y,$det_7,$t_y                        # 160e
        lqd     $slope_11,544($a_shear)                 # 160o
        or      $control_2,$control_2,$both_2           # 161e
            gb      $control,$control                   # 161o
            and     $control_14,$control_11,$ahead_5    # 162e
            lnop                                        # 162o pairing
        fa      $det,$det,$w_6                          # 163e
        lqd     $slope_13,560($a_shear)                 # 163o
            andc    $control_15,$control_14,$outside_2  # 164e
        frest   $t_y_2,$det_3                           # 164o
        xor     $control_14,$det_4,$slope_10            # 165e of -1 / direction z
        frest   $t_y_6,$det_4                           # 165o
        xor     $control_3,$det_3,$slope_11             # 166e of -1 / direction z
            rotqbii $control_15,$control_15,1           # 166o
        fnms    $t_e_6,$det_7,$t_y,$k_above_one         # 167e
            shlqbii $control,$control,4                 # 167o
        fi      $t_y_2,$det_3,$t_y_2                    # 168e
        lnop                                            # 168o pairing
        fi      $t_y_6,$det_4,$t_y_6                    # 169e
        frest   $t_y_3,$det                             # 169o
        xor     $control_5,$det,$slope_13               # 170e of -1 / direction z
            gb      $control_15,$control_15             # 170o
        or      $control_4,$control_3,$both_2           # 171e
            lqx     $control,$control,$a_controls       # 171o
        or      $control_8,$control_14,$both_2          # 172e
        lnop                                            # 172o pairing
        fi      $t_y_5,$det,$t_y_3                      # 173e
            lqd     $nearest_5,480($a_packet_2)         # 173o
        or      $control_6,$control_5,$both_2           # 174e
            shlqbii $control_15,$control_15,4           # 174o
        fnms    $t_e_3,$det_3,$t_y_2,$k_above_one       # 175e
        hbrr    next_triangle_back,next_triangle        # 175o hint
        fnms    $t_e_5,$det_4,$t_y_6,$k_above_one       # 176e
            lqd     $nearest_6,464($a_packet_2)         # 176o
        fma     $inverse_6,$t_e_6,$t_y,$t_y             # 177e
            shufb   $t_best,$t_best_2,$t,$control       # 177o
        ai      $a_candidate,$a_candidate,16            # 178e
            lqx     $control_16,$control_15,$a_controls # 178o
        ai      $count,$count,-1                        # 179e
            shufb   $nearest_7,$nearest_5,$object_2,$control # 179o
        fnms    $t_e_4,$det,$t_y_5,$k_above_one         # 180e
        lnop                                            # 180o pairing
        fma     $inverse_3,$t_e_3,$t_y_2,$t_y_2         # 181e
            stqd    $t_best,416($a_packet_2)            # 181o
        fma     $inverse_5,$t_e_5,$t_y_6,$t_y_6         # 182e
        lnop                                            # 182o pairing
        fm      $u,$u,$inverse_6                        # 183e
            stqd    $nearest_7,480($a_packet_2)         # 183o
        fm      $v_10,$v_14,$inverse_6                  # 184e
            shufb   $nearest_8,$nearest_6,$object_2,$control_16 # 184o
        fm      $w_7,$w_2,$inverse_6                    # 185e
            shufb   $t_best,$t_best_3,$t_4,$control_16  # 185o
        fma     $inverse_4,$t_e_4,$t_y_5,$t_y_5         # 186e
        shufb   $object_2,$object,$object,$m_splat      # 186o
        fm      $u_8,$u_11,$inverse_3                   # 187e
        lnop                                            # 187o pairing
        fm      $v_11,$v_15,$inverse_3                  # 188e
            stqd    $nearest_8,464($a_packet_2)         # 188o
        fm      $ahead_2,$u,$za_4                       # 189e
            stqd    $t_best,400($a_packet_2)            # 189o
        fm      $w_8,$w,$inverse_5                      # 190e
        rotqbyi $a_packet_2,$object,4                   # 190o
        fm      $v_12,$v_9,$inverse_5                   # 191e
        fm      $u_6,$u_6,$inverse_4                    # 192e
        fm      $u_9,$u_7,$inverse_5                    # 193e
next_triangle_back:
        brnz    $count,next_triangle                    # 193o
next_triangle_drain:
        fm      $v,$v_7,$inverse_4                      # 0e
        lqd     $t_best,432($a_packet_2)                # 0o
        fm      $ahead_3,$u_6,$za_5                     # 1e
        lqd     $t_best_4,384($a_packet_2)              # 1o
        fm      $ahead_7,$u_9,$za_3                     # 2e
        lqd     $t_best_5,416($a_packet_2)              # 2o
        fm      $w,$w_6,$inverse_4                      # 3e
        lqd     $t_best_3,400($a_packet_2)              # 3o
        fm      $ahead,$u_8,$za_6                       # 4e
        lqd     $nearest_2,496($a_packet_2)             # 4o
        fm      $w_10,$w_5,$inverse_3                   # 5e
        lqd     $nearest_3,448($a_packet_2)             # 5o
        fma     $ahead_4,$v_10,$zb_2,$ahead_2           # 6e
        hbr     isect_triangle_pairs_r16_return,$lr     # 6o hint
        fma     $ahead_3,$v,$zb_4,$ahead_3              # 7e
        fma     $ahead_7,$v_12,$zb_6,$ahead_7           # 8e
        or      $outside_3,$u_6,$v                      # 9e
        fma     $ahead,$v_11,$zb_7,$ahead               # 10e
        or      $outside_3,$outside_3,$w                # 11e
        or      $outside_4,$u_9,$v_12                   # 12e
        fma     $ahead_3,$w,$zc_3,$ahead_3              # 13e
        fma     $ahead_7,$w_8,$zc_4,$ahead_7            # 14e
        or      $outside_4,$outside_4,$w_8              # 15e
        fma     $ahead,$w_10,$zc,$ahead                 # 16e
        fma     $ahead_4,$w_7,$zc_2,$ahead_4            # 17e
        orc     $outside_3,$outside_3,$control_6        # 18e
        fm      $ahead_3,$ahead_3,$slope_13             # 19e
        fm      $ahead_7,$ahead_7,$slope_10             # 20e
        orc     $outside_4,$outside_4,$control_8        # 21e
        fm      $ahead,$ahead,$slope_11                 # 22e
        fm      $ahead_4,$ahead_4,$slope_12             # 23e
        or      $outside,$u_8,$v_11                     # 24e
        xor     $t_2,$ahead_3,$k_sign                   # 25e
        xor     $t_3,$ahead_7,$k_sign                   # 26e
        cgt     $control_9,$t_best,$t_2                 # 27e
        cgt     $control_12,$t_best_4,$t_3              # 28e
        and     $control_10,$control_9,$ahead_3         # 29e
        and     $control_13,$control_12,$ahead_7        # 30e
        andc    $control_10,$control_10,$outside_3      # 31e
        andc    $control_13,$control_13,$outside_4      # 32e
        xor     $t,$ahead,$k_sign                       # 33e
        rotqbii $control_10,$control_10,1               # 33o
        or      $outside_2,$u,$v_10                     # 34e
        rotqbii $control_13,$control_13,1               # 34o
        xor     $t_4,$ahead_4,$k_sign                   # 35e
        cgt     $control,$t_best_5,$t                   # 36e
        or      $outside,$outside,$w_10                 # 37e
        gb      $control_10,$control_10                 # 37o
        cgt     $control_11,$t_best_3,$t_4              # 38e
        gb      $control_13,$control_13                 # 38o
        or      $outside_2,$outside_2,$w_7              # 39e
        and     $control,$control,$ahead                # 40e
        orc     $outside,$outside,$control_4            # 41e
        shlqbii $control_10,$control_10,4               # 41o
        and     $control_14,$control_11,$ahead_4        # 42e
        shlqbii $control_13,$control_13,4               # 42o
        andc    $control,$control,$outside              # 43e
        orc     $outside_2,$outside_2,$control_2        # 44e
        nop     $127                                    # 45e pairing
        lqx     $control_10,$control_10,$a_controls     # 45o
        andc    $control_15,$control_14,$outside_2      # 46e
        rotqbii $control,$control,1                     # 46o
        lqx     $control_13,$control_13,$a_controls     # 47o
        rotqbii $control_15,$control_15,1               # 48o
        gb      $control,$control                       # 50o
        shufb   $nearest_2,$nearest_2,$object_2,$control_10 # 51o
        gb      $control_15,$control_15                 # 52o
        shufb   $t_best_4,$t_best_4,$t_3,$control_13    # 53o
        shufb   $t_best,$t_best,$t_2,$control_10        # 54o
        shufb   $nearest_4,$nearest_3,$object_2,$control_13 # 55o
        stqd    $nearest_2,496($a_packet_2)             # 56o
        shlqbii $control,$control,4                     # 57o
        stqd    $t_best_4,384($a_packet_2)              # 58o
        stqd    $t_best,432($a_packet_2)                # 59o
        shlqbii $control_15,$control_15,4               # 60o
        stqd    $nearest_4,448($a_packet_2)             # 61o
        lqx     $control,$control,$a_controls           # 62o
        lqd     $nearest_5,480($a_packet_2)             # 63o
        lqx     $control_16,$control_15,$a_controls     # 64o
        lqd     $nearest_6,464($a_packet_2)             # 65o
        shufb   $t_best,$t_best_5,$t,$control           # 68o
        shufb   $nearest_7,$nearest_5,$object_2,$control # 69o
        shufb   $t_best_6,$t_best_3,$t_4,$control_16    # 70o
        shufb   $nearest_9,$nearest_6,$object_2,$control_16 # 71o
        stqd    $t_best,416($a_packet_2)                # 72o
        stqd    $nearest_7,480($a_packet_2)             # 73o
        stqd    $nearest_9,464($a_packet_2)             # 75o
        stqd    $t_best_6,400($a_packet_2)              # 76o
        nop     $127                                    # 77e pairing
isect_triangle_pairs_r16_return:
        bi      $lr                                     # 77o
next_triangle_short:
        ai      $count,$count,-1                        # 0e
        lqd     $object,0($a_candidate)                 # 0o
        ai      $a_candidate,$a_candidate,16            # 1e
        rotqbyi $a_shear,$object,12                     # 6o
        lqd     $vertex_a,48($object)                   # 7o
        lqd     $vertex_c,80($object)                   # 8o
        lqd     $vertex_b,64($object)                   # 9o
        lqd     $p,64($a_shear)                         # 10o
        lqd     $p_25,32($a_shear)                      # 11o
        lqd     $p_6,0($a_shear)                        # 12o
        lqd     $p_26,144($a_shear)                     # 13o
        lqd     $p_27,128($a_shear)                     # 14o
        lqd     $p_28,16($a_shear)                      # 15o
        lqd     $p_24,80($a_shear)                      # 16o
        lqd     $q,272($a_shear)                        # 17o
        lqd     $q_9,224($a_shear)                      # 18o
        lqd     $p_29,160($a_shear)                     # 19o
        lqd     $q_23,192($a_shear)                     # 20o
        shufb   $zb,$vertex_b,$vertex_b,$p_27           # 21o
        lqd     $p_30,96($a_shear)                      # 22o
        shufb   $yc,$vertex_c,$vertex_c,$p              # 23o
        shufb   $xc,$vertex_c,$vertex_c,$p_28           # 24o
        shufb   $xb,$vertex_b,$vertex_b,$p_25           # 25o
        shufb   $za,$vertex_a,$vertex_a,$p_29           # 26o
        lqd     $q_4,256($a_shear)                      # 27o
        shufb   $xb_13,$vertex_b,$vertex_b,$p_28        # 28o
        fs      $xb,$xb,$q_9                            # 29e
        lqd     $q_21,208($a_shear)                     # 29o
        lqd     $q_24,336($a_shear)                     # 30o
        lqd     $q_14,352($a_shear)                     # 31o
        nop     $127                                    # 32e pairing
        lqd     $q_13,320($a_shear)                     # 32o
        fs      $yc,$yc,$q_4                            # 33e
        shufb   $xb_14,$vertex_b,$vertex_b,$p_6         # 33o
        nop     $127                                    # 34e pairing
        shufb   $za_7,$vertex_a,$vertex_a,$p_27         # 34o
        fs      $xc,$xc,$q_21                           # 35e
        shufb   $yc_11,$vertex_c,$vertex_c,$p_24        # 35o
        fs      $xb_13,$xb_13,$q_21                     # 36e
        shufb   $zb_9,$vertex_b,$vertex_b,$p_26         # 36o
        fs      $za,$za,$q_14                           # 37e
        lqd     $q_25,288($a_shear)                     # 37o
        fs      $xb_14,$xb_14,$q_23                     # 38e
        shufb   $xc_9,$vertex_c,$vertex_c,$p_6          # 38o
        fs      $za_7,$za_7,$q_13                       # 39e
        shufb   $zc_5,$vertex_c,$vertex_c,$p_27         # 39o
        fs      $yc_11,$yc_11,$q                        # 40e
        shufb   $xc_10,$vertex_c,$vertex_c,$p_25        # 40o
        fs      $zb,$zb,$q_13                           # 41e
        shufb   $ya_9,$vertex_a,$vertex_a,$p_30         # 41o
        fs      $xc_9,$xc_9,$q_23                       # 42e
        shufb   $zc_6,$vertex_c,$vertex_c,$p_29         # 42o
        fs      $zc_5,$zc_5,$q_13                       # 43e
        lqd     $slope_17,480($a_shear)                 # 43o
        fs      $xc_10,$xc_10,$q_9                      # 44e
        shufb   $ya_10,$vertex_a,$vertex_a,$p           # 44o
        fs      $ya_9,$ya_9,$q_25                       # 45e
        shufb   $ya_11,$vertex_a,$vertex_a,$p_24        # 45o
        fs      $zb_9,$zb_9,$q_24                       # 46e
        shufb   $yb_10,$vertex_b,$vertex_b,$p_24        # 46o
        fs      $zc_6,$zc_6,$q_14                       # 47e
        shufb   $za_8,$vertex_a,$vertex_a,$p_26         # 47o
        fs      $ya_10,$ya_10,$q_4                      # 48e
        shufb   $zc_7,$vertex_c,$vertex_c,$p_26         # 48o
        fs      $ya_11,$ya_11,$q                        # 49e
        lqd     $slope_18,464($a_shear)                 # 49o
        fs      $yb_10,$yb_10,$q                        # 50e
        shufb   $yc_12,$vertex_c,$vertex_c,$p_30        # 50o
        fs      $za_8,$za_8,$q_24                       # 51e
        shufb   $zb_10,$vertex_b,$vertex_b,$p_29        # 51o
        fs      $zc_7,$zc_7,$q_24                       # 52e
        lqd     $slope_19,416($a_shear)                 # 52o
        fnms    $ya_9,$slope_17,$za,$ya_9               # 53e
        shufb   $yb_11,$vertex_b,$vertex_b,$p           # 53o
        fs      $yc_12,$yc_12,$q_25                     # 54e
        lqd     $slope_20,448($a_shear)                 # 54o
        fs      $zb_10,$zb_10,$q_14                     # 55e
        lqd     $slope_6,400($a_shear)                  # 55o
        fnms    $yb_10,$slope_18,$zb_9,$yb_10           # 56e
        shufb   $xa_10,$vertex_a,$vertex_a,$p_25        # 56o
        fs      $yb,$yb_11,$q_4                         # 57e
        lqd     $slope_11,384($a_shear)                 # 57o
        fnms    $ya_11,$slope_18,$za_8,$ya_11           # 58e
        shufb   $xa_11,$vertex_a,$vertex_a,$p_6         # 58o
        fnms    $yc_11,$slope_18,$zc_7,$yc_11           # 59e
        lqd     $p_10,176($a_shear)                     # 59o
        fnms    $ya_10,$slope_20,$za_7,$ya_10           # 60e
        shufb   $xa_12,$vertex_a,$vertex_a,$p_28        # 60o
        fnms    $yc,$slope_20,$zc_5,$yc                 # 61e
        shufb   $yb_12,$vertex_b,$vertex_b,$p_30        # 61o
        fs      $xa_10,$xa_10,$q_9                      # 62e
        lqd     $q_9,240($a_shear)                      # 62o
        fnms    $xb_14,$slope_11,$zb,$xb_14             # 63e
        lqd     $p_2,48($a_shear)                       # 63o
        fnms    $xc,$slope_6,$zc_7,$xc                  # 64e
        lqd     $p_31,112($a_shear)                     # 64o
        fnms    $xb,$slope_19,$zb_10,$xb                # 65e
        lqd     $q_26,304($a_shear)                     # 65o
        fnms    $xb_13,$slope_6,$zb_9,$xb_13            # 66e
        lqd     $q_27,368($a_shear)                     # 66o
        fs      $yb_12,$yb_12,$q_25                     # 67e
        shufb   $za_9,$vertex_a,$vertex_a,$p_10         # 67o
        fnms    $xc_10,$slope_19,$zc_6,$xc_10           # 68e
        shufb   $zc_8,$vertex_c,$vertex_c,$p_10         # 68o
        fs      $xa,$xa_11,$q_23                        # 69e
        shufb   $xc_11,$vertex_c,$vertex_c,$p_2         # 69o
        fnms    $xc_9,$slope_11,$zc_5,$xc_9             # 70e
        shufb   $ya_12,$vertex_a,$vertex_a,$p_31        # 70o
        fs      $xa_12,$xa_12,$q_21                     # 71e
        shufb   $xb_5,$vertex_b,$vertex_b,$p_2          # 71o
        fnms    $yc_12,$slope_17,$zc_6,$yc_12           # 72e
        shufb   $zb_11,$vertex_b,$vertex_b,$p_10        # 72o
        fnms    $yb_12,$slope_17,$zb_10,$yb_12          # 73e
        lqd     $slope_17,432($a_shear)                 # 73o
        fnms    $xa_10,$slope_19,$za,$xa_10             # 74e
        lqd     $slope_19,496($a_shear)                 # 74o
        fm      $p_32,$ya_9,$xc_10                      # 75e
        shufb   $yc_6,$vertex_c,$vertex_c,$p_31         # 75o
        fm      $p_21,$ya_10,$xc_9                      # 76e
        shufb   $yb_13,$vertex_b,$vertex_b,$p_31        # 76o
        fm      $p_31,$yc_11,$xb_13                     # 77e
        shufb   $xa_5,$vertex_a,$vertex_a,$p_2          # 77o
        fs      $za_9,$za_9,$q_27                       # 78e
        lqd     $slope_8,512($a_shear)                  # 78o
        fs      $zc_8,$zc_8,$q_27                       # 79e
        lqd     $slope_21,528($a_shear)                 # 79o
        fnms    $xa_12,$slope_6,$za_8,$xa_12            # 80e
        lqd     $slope_6,544($a_shear)                  # 80o
        fs      $xc_11,$xc_11,$q_9                      # 81e
        rotqbyi $a_packet_3,$object,4                   # 81o
        fs      $zb_11,$zb_11,$q_27                     # 82e
        lqd     $both_3,32($object)                     # 82o
        fnms    $xa,$slope_11,$za_7,$xa                 # 83e
        lqd     $slope_22,560($a_shear)                 # 83o
        fm      $p,$ya_11,$xc                           # 84e
        shufb   $object,$object,$object,$m_splat        # 84o
        fs      $yc_6,$yc_6,$q_26                       # 85e
        lqd     $t_best_7,400($a_packet_3)              # 85o
        fnms    $yb,$slope_20,$zb,$yb                   # 86e
        lqd     $t_best_8,416($a_packet_3)              # 86o
        fm      $p_33,$yc,$xb_14                        # 87e
        lqd     $t_best_9,384($a_packet_3)              # 87o
        fm      $p_34,$yc_12,$xb                        # 88e
        shufb   $both_3,$both_3,$both_3,$m_w            # 88o
        fms     $v_16,$xa,$yc,$p_21                     # 89e
        lqd     $t_best_10,432($a_packet_3)             # 89o
        fs      $xb_5,$xb_5,$q_9                        # 90e
        lqd     $nearest_10,448($a_packet_3)            # 90o
        fms     $q_28,$ya_10,$xc_9,$p_21                # 91e
        lqd     $nearest_11,480($a_packet_3)            # 91o
        fms     $v_17,$xa_12,$yc_11,$p                  # 92e
        rotqbii $both_3,$both_3,1                       # 92o
        fms     $u_12,$xc_9,$yb,$p_33                   # 93e
        lqd     $nearest_12,464($a_packet_3)            # 93o
        fm      $p_35,$yb_10,$xa_12                     # 94e
        lqd     $nearest_13,496($a_packet_3)            # 94o
        fms     $q_6,$yc_12,$xb,$p_34                   # 95e
        fm      $p_36,$yb_12,$xa_10                     # 96e
        fs      $xa_7,$xa_5,$q_9                        # 97e
        fs      $ya_13,$ya_12,$q_26                     # 98e
        fnms    $xc_11,$slope_17,$zc_8,$xc_11           # 99e
        fms     $v_8,$xa_10,$yc_12,$p_32                # 100e
        fms     $q_29,$yc_11,$xb_13,$p_31               # 101e
        fms     $u_13,$xc,$yb_10,$p_31                  # 102e
        fms     $u_14,$xc_10,$yb_12,$p_34               # 103e
        fnms    $ya_13,$slope_19,$za_9,$ya_13           # 104e
        fms     $q_30,$ya_9,$xc_10,$p_32                # 105e
        fnms    $xb_5,$slope_17,$zb_11,$xb_5            # 106e
        fms     $q_31,$yc,$xb_14,$p_33                  # 107e
        fm      $p_32,$yb,$xa                           # 108e
        fs      $u_4,$u_13,$q_29                        # 109e
        fms     $q_32,$ya_11,$xc,$p                     # 110e
        fms     $q_18,$yb_10,$xa_12,$p_35               # 111e
        fms     $w_11,$xb_13,$ya_11,$p_35               # 112e
        fs      $u_15,$u_12,$q_31                       # 113e
        fnms    $yc_6,$slope_19,$zc_8,$yc_6             # 114e
        fs      $u_16,$u_14,$q_6                        # 115e
        fs      $v_18,$v_17,$q_32                       # 116e
        fs      $v_19,$v_8,$q_30                        # 117e
        fs      $yb_13,$yb_13,$q_26                     # 118e
        fms     $q,$yb_12,$xa_10,$p_36                  # 119e
        fs      $v_14,$v_16,$q_28                       # 120e
        fms     $w_12,$xb_14,$ya_10,$p_32               # 121e
        fms     $w_3,$xb,$ya_9,$p_36                    # 122e
        fms     $q_23,$yb,$xa,$p_32                     # 123e
        fnms    $xa_7,$slope_17,$za_9,$xa_7             # 124e
        fa      $det,$u_16,$v_19                        # 125e
        fm      $p_37,$ya_13,$xc_11                     # 126e
        fm      $p_5,$yc_6,$xb_5                        # 127e
        fs      $w_3,$w_3,$q                            # 128e
        fs      $w_13,$w_12,$q_23                       # 129e
        fnms    $yb_13,$slope_19,$zb_11,$yb_13          # 130e
        fs      $w_6,$w_11,$q_18                        # 131e
        fms     $v_20,$xa_7,$yc_6,$p_37                 # 132e
        fa      $det_8,$u_15,$v_14                      # 133e
        fa      $det_9,$u_4,$v_18                       # 134e
        fms     $q_4,$ya_13,$xc_11,$p_37                # 135e
        fms     $u,$xc_11,$yb_13,$p_5                   # 136e
        fm      $p_6,$yb_13,$xa_7                       # 137e
        fms     $q_15,$yc_6,$xb_5,$p_5                  # 138e
        fa      $det_8,$det_8,$w_13                     # 139e
        fa      $det_9,$det_9,$w_6                      # 140e
        fa      $det,$det,$w_3                          # 141e
        fs      $v_20,$v_20,$q_4                        # 142e
        fms     $q_9,$yb_13,$xa_7,$p_6                  # 143e
        fs      $u,$u,$q_15                             # 144e
        fms     $w,$xb_5,$ya_13,$p_6                    # 145e
        frest   $t_y_7,$det_8                           # 145o
        xor     $control,$det_9,$slope_21               # 146e of -1 / direction z
        frest   $t_y_8,$det_9                           # 146o
        xor     $control_17,$det,$slope_6               # 147e of -1 / direction z
        frest   $t_y_9,$det                             # 147o
        xor     $control_18,$det_8,$slope_8             # 148e of -1 / direction z
        fi      $t_y_7,$det_8,$t_y_7                    # 149e
        fi      $t_y_8,$det_9,$t_y_8                    # 150e
        fi      $t_y_9,$det,$t_y_9                      # 151e
        or      $control_18,$control_18,$both_3         # 152e
        fs      $w,$w,$q_9                              # 153e
        fa      $det_10,$u,$v_20                        # 154e
        or      $control,$control,$both_3               # 155e
        fnms    $t_e_7,$det_8,$t_y_7,$k_above_one       # 156e
        fnms    $t_e_8,$det_9,$t_y_8,$k_above_one       # 157e
        fnms    $t_e_9,$det,$t_y_9,$k_above_one         # 158e
        or      $control_17,$control_17,$both_3         # 159e
        fa      $det,$det_10,$w                         # 160e
        fma     $inverse_4,$t_e_7,$t_y_7,$t_y_7         # 162e
        fma     $inverse_2,$t_e_8,$t_y_8,$t_y_8         # 163e
        fma     $inverse_7,$t_e_9,$t_y_9,$t_y_9         # 164e
        xor     $control_19,$det,$slope_22              # 166e of -1 / direction z
        frest   $t_y_10,$det                            # 166o
        fm      $u_15,$u_15,$inverse_4                  # 168e
        fm      $u_17,$u_4,$inverse_2                   # 169e
        fi      $t_y,$det,$t_y_10                       # 170e
        or      $control_19,$control_19,$both_3         # 171e
        fm      $u_6,$u_16,$inverse_7                   # 172e
        fm      $v_14,$v_14,$inverse_4                  # 173e
        fm      $v_18,$v_18,$inverse_2                  # 174e
        fm      $v_21,$v_19,$inverse_7                  # 175e
        fm      $ahead_8,$u_15,$za_7                    # 176e
        fnms    $t_e_9,$det,$t_y,$k_above_one           # 177e
        fm      $ahead_9,$u_6,$za                       # 178e
        fm      $ahead_10,$u_17,$za_8                   # 179e
        fm      $w_10,$w_13,$inverse_4                  # 180e
        fm      $w_6,$w_6,$inverse_2                    # 181e
        fma     $ahead_11,$v_14,$zb,$ahead_8            # 182e
        fma     $inverse,$t_e_9,$t_y,$t_y               # 183e
        fma     $ahead_5,$v_21,$zb_10,$ahead_9          # 184e
        fma     $ahead_12,$v_18,$zb_9,$ahead_10         # 185e
        fm      $w_14,$w_3,$inverse_7                   # 186e
        or      $outside,$u_6,$v_21                     # 187e
        fma     $ahead_13,$w_10,$zc_5,$ahead_11         # 188e
        fm      $u,$u,$inverse                          # 189e
        fm      $v_20,$v_20,$inverse                    # 190e
        fma     $ahead_6,$w_6,$zc_7,$ahead_12           # 191e
        fma     $ahead_11,$w_14,$zc_6,$ahead_5          # 192e
        fm      $w,$w,$inverse                          # 193e
        fm      $ahead_13,$ahead_13,$slope_8            # 194e
        fm      $ahead,$u,$za_9                         # 195e
        or      $outside_5,$u_17,$v_18                  # 196e
        fm      $ahead_6,$ahead_6,$slope_21             # 197e
        fm      $ahead_11,$ahead_11,$slope_6            # 198e
        or      $outside,$outside,$w_14                 # 199e
        xor     $t,$ahead_13,$k_sign                    # 200e
        fma     $ahead,$v_20,$zb_11,$ahead              # 201e
        or      $outside_6,$u_15,$v_14                  # 202e
        xor     $t_5,$ahead_6,$k_sign                   # 203e
        or      $outside_6,$outside_6,$w_10             # 204e
        cgt     $control_16,$t_best_7,$t_5              # 205e
        xor     $t_6,$ahead_11,$k_sign                  # 206e
        and     $control_16,$control_16,$ahead_6        # 207e
        cgt     $control_13,$t_best_8,$t_6              # 208e
        orc     $outside_6,$outside_6,$control_18       # 209e
        cgt     $control_20,$t_best_9,$t                # 210e
        or      $outside_7,$outside_5,$w_6              # 211e
        and     $control_21,$control_20,$ahead_13       # 212e
        and     $control_13,$control_13,$ahead_11       # 213e
        andc    $control_10,$control_21,$outside_6      # 214e
        fma     $ahead,$w,$zc_8,$ahead                  # 215e
        orc     $outside_8,$outside_7,$control          # 216e
        rotqbii $control,$control_10,1                  # 216o
        orc     $outside,$outside,$control_17           # 217e
        andc    $control_10,$control_16,$outside_8      # 218e
        andc    $control_16,$control_13,$outside        # 219e
        lnop                                            # 219o pairing
        or      $outside,$u,$v_20                       # 220e
        rotqbii $control_10,$control_10,1               # 220o
        fm      $ahead,$ahead,$slope_22                 # 221e
        rotqbii $control_16,$control_16,1               # 221o
        or      $outside,$outside,$w                    # 222e
        gb      $control,$control                       # 222o
        orc     $outside,$outside,$control_19           # 224e
        gb      $control_10,$control_10                 # 224o
        gb      $control_16,$control_16                 # 225o
        shlqbii $control,$control,4                     # 226o
        xor     $t_7,$ahead,$k_sign                     # 227e
        shlqbii $control_10,$control_10,4               # 228o
        cgt     $control_21,$t_best_10,$t_7             # 229e
        shlqbii $control_16,$control_16,4               # 229o
        lqx     $control,$control,$a_controls           # 230o
        and     $control_21,$control_21,$ahead          # 231e
        nop     $127                                    # 232e pairing
        lqx     $control_10,$control_10,$a_controls     # 232o
        andc    $control_21,$control_21,$outside        # 233e
        lqx     $control_16,$control_16,$a_controls     # 233o
        rotqbii $control_21,$control_21,1               # 235o
        shufb   $t_best,$t_best_9,$t,$control           # 236o
        shufb   $nearest,$nearest_10,$object,$control   # 237o
        shufb   $t_best_11,$t_best_7,$t_5,$control_10   # 238o
        shufb   $nearest_14,$nearest_11,$object,$control_16 # 239o
        shufb   $t_best_2,$t_best_8,$t_6,$control_16    # 240o
        gb      $control,$control_21                    # 241o
        stqd    $t_best_11,400($a_packet_3)             # 242o
        stqd    $t_best,384($a_packet_3)                # 243o
        stqd    $nearest,448($a_packet_3)               # 244o
        shlqbii $control,$control,4                     # 245o
        shufb   $nearest,$nearest_12,$object,$control_10 # 246o
        stqd    $nearest_14,480($a_packet_3)            # 247o
        stqd    $t_best_2,416($a_packet_3)              # 248o
        lqx     $control,$control,$a_controls           # 249o
        stqd    $nearest,464($a_packet_3)               # 250o
        hbrr    next_triangle_short_back,next_triangle_short # 251o hint
        shufb   $t_best,$t_best_10,$t_7,$control        # 255o
        shufb   $nearest,$nearest_13,$object,$control   # 256o
        stqd    $t_best,432($a_packet_3)                # 259o
        stqd    $nearest,496($a_packet_3)               # 260o
next_triangle_short_back:
        brnz    $count,next_triangle_short              # 261o
        nop     $127                                    # 262e pairing
        bi      $lr                                     # 262o
endfunction isect_triangle_pairs_r16
