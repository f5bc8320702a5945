# isect_triangle_pairs_r16   nearest hit of packets' rays with triangles, candidate by candidate
#   C       void isect_triangle_pairs_r16(const struct candidate *, int count);
#   In      $3 candidates of objects that are triangles, and of shears of their packets, $4 count
#           (0 is none); pointers 16-aligned
#   Out     the candidates' packets: t, object, where a hit has 0 < t < what was there
#   Uses    $2-$79   Saves  -   Stack  0   Calls  -
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
        .set count_2,79; .set a_shear_2,18; .set vertex_a_2,20; .set vertex_c_2,22
        .set vertex_b_2,21; .set p_2,25; .set p_3,24; .set q_2,55; .set q_3,40; .set p_4,26
        .set p_5,28; .set p_6,30; .set p_7,2; .set p_8,34; .set q_4,46; .set xc_2,65; .set za_2,5
        .set p_9,29; .set p_10,6; .set ya_2,66; .set za_3,7; .set xb_2,36; .set p_11,35
        .set p_12,5; .set zb_2,49; .set zc_2,52; .set yc_2,67; .set q_5,48; .set q_6,8; .set q_7,51
        .set q_8,41; .set q_9,57; .set slope_2,77; .set q_10,27; .set q_11,53; .set q_12,23
        .set q_13,50; .set ya_3,58; .set za_4,54; .set xc_3,9; .set zc_3,33; .set xc_4,72
        .set xc_5,73; .set xc_6,55; .set slope_3,16; .set xa_2,31; .set xc_7,17; .set xb_3,56
        .set yc_3,59; .set za_5,63; .set zc_4,38; .set zc_5,19; .set ya_4,42; .set xb_4,68
        .set yc_4,69; .set yc_5,22; .set zc_6,71; .set za_6,60; .set ya_5,61; .set zb_3,62
        .set yc_6,2; .set zb_4,64; .set xb_5,70; .set zb_5,5; .set ya_6,74; .set yb_2,24
        .set slope_4,75; .set zb_6,50; .set slope_5,76; .set slope_6,41; .set slope_7,5
        .set yc_7,6; .set slope_8,8; .set yb_3,19; .set yb_4,22; .set xb_6,66; .set slope_9,35
        .set xa_3,26; .set xa_4,29; .set xa_5,20; .set xc_8,16; .set yb_5,21; .set both_2,28
        .set yc_8,32; .set slope_10,34; .set slope_11,30; .set slope_12,44; .set ya_7,56
        .set slope_13,46; .set a_packet_2,78; .set both_3,27; .set object_2,79; .set yb_6,28
        .set yb_7,23; .set xb_7,15; .set ya_8,18; .set p_13,61; .set p_14,67; .set p_15,69
        .set p_16,70; .set p_17,65; .set p_18,19; .set p_19,41; .set v_2,51; .set p_20,68
        .set q_14,6; .set u_2,40; .set q_15,72; .set q_16,22; .set v_3,59; .set v_4,8; .set q_17,24
        .set u_3,35; .set u_4,65; .set q_18,73; .set q_19,45; .set u_5,19; .set q_20,2; .set v_5,57
        .set v_6,48; .set u_6,31; .set q_21,20; .set q_22,21; .set q_23,28; .set w_2,5
        .set det_2,6; .set v_7,23; .set w_3,26; .set w_4,29; .set u_7,22; .set w_5,24; .set det_3,2
        .set det_4,9; .set det_5,5; .set w_6,21; .set det_6,20; .set det_7,17; .set det_8,18
        .set control_2,28; .set t_y_2,29; .set control_3,53; .set t_y_3,2; .set control_4,42
        .set t_y_4,45; .set t_y_5,6; .set control_5,32; .set t_y_6,41; .set control_6,57
        .set control_7,56; .set t_e_2,20; .set control_8,51; .set t_e_3,17; .set t_e_4,18
        .set control_9,58; .set t_e_5,5; .set inverse_2,20; .set inverse_3,17; .set inverse_4,18
        .set inverse_5,5; .set u_8,32; .set v_8,37; .set u_9,27; .set u_10,39; .set ahead_2,19
        .set v_9,43; .set ahead_3,7; .set ahead_4,6; .set ahead_5,22; .set w_7,2; .set t_best_2,6
        .set t_best_3,8; .set w_8,9; .set t_best_4,16; .set ahead_6,17; .set outside_2,23
        .set outside_3,27; .set outside_4,32; .set p_21,33; .set t_2,37; .set p_22,38; .set t_3,39
        .set t_4,47; .set q_24,36; .set outside_5,9; .set control_10,49; .set control_11,52
        .set outside_6,5; .set control_12,54; .set control_13,7; .set control_14,19
        .set control_15,17; .set zc_7,36; .set za_7,25; .set zb_7,2; .set xc_9,22; .set slope_14,73
        .set slope_15,68; .set yb_8,30; .set yb_9,34; .set xc_10,30; .set xc_11,40; .set both_4,46
        .set yc_9,51; .set slope_16,48; .set xb_8,53; .set yc_10,57; .set xb_9,34; .set ya_9,46
        .set nearest_2,48; .set p_23,44; .set nearest_3,19; .set q_25,30; .set v_10,2; .set w_9,34
        .set det_9,30; .set det_10,28; .set det_11,29; .set control_16,9; .set t_y_7,28
        .set nearest_4,55; .set nearest_5,32; .set nearest_6,27; .set nearest_7,28
        .set nearest_8,29; .set nearest_9,6; .set p_24,7; .set p_25,8; .set p_26,9; .set p_27,16
        .set q_26,18; .set p_28,22; .set q_27,26; .set xb_10,27; .set ya_10,33; .set yc_11,34
        .set q_28,35; .set xc_12,36; .set q_29,37; .set q_30,38; .set q_31,39; .set xb_11,40
        .set q_32,42; .set za_8,43; .set zb_8,44; .set yc_12,45; .set zb_9,46; .set zb_10,47
        .set xc_13,48; .set ya_11,49; .set slope_17,50; .set zc_8,7; .set zc_9,6; .set slope_18,51
        .set za_9,16; .set yb_10,9; .set xa_6,2; .set ya_12,35; .set slope_19,42; .set slope_20,32
        .set xa_7,8; .set slope_21,18; .set xa_8,5; .set yb_11,31; .set p_29,37; .set q_33,49
        .set p_30,52; .set p_31,53; .set q_34,54; .set zc_10,56; .set zb_11,26; .set xb_12,57
        .set ya_13,38; .set xc_14,39; .set za_10,37; .set p_32,58; .set yc_13,21; .set p_33,59
        .set slope_22,60; .set yb_12,20; .set p_34,50; .set xa_9,19; .set xb_13,52
        .set slope_23,53; .set slope_24,57; .set slope_25,61; .set a_packet_3,41; .set both_5,51
        .set slope_26,17; .set p_35,18; .set t_best_5,62; .set t_best_6,63; .set t_best_7,32
        .set p_36,64; .set t_best_8,66; .set v_11,67; .set nearest_10,68; .set q_35,59
        .set v_12,69; .set nearest_11,70; .set u_11,36; .set nearest_12,71; .set p_37,72
        .set p_38,74; .set v_13,45; .set q_36,29; .set u_12,50; .set q_37,34; .set p_39,54
        .set u_13,29; .set u_14,23; .set v_14,18; .set v_15,28; .set v_16,22; .set w_10,25
        .set q_38,5; .set det_12,27; .set yb_13,5; .set w_11,8; .set q_39,25; .set p_40,39
        .set control_17,25; .set t_y_8,31; .set control_18,33; .set t_y_9,38; .set control_19,40
        .set det_13,21; .set t_e_6,9; .set t_e_7,27; .set inverse_6,9; .set control_20,27
        .set ahead_7,24; .set t_e_8,21; .set ahead_8,16; .set ahead_9,31; .set ahead_10,9
        .set ahead_11,21; .set u_15,9; .set outside_7,18; .set ahead_12,2; .set outside_8,19
        .set t_5,20; .set t_6,21; .set control_21,6; .set control_22,22; .set outside_9,8
        .set control_23,5; .set t_7,7; .set control_24,8; .set control_25,2; .set t_best_9,5
        .set nearest_13,8
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
        rotqbyi $a_shear_2,$object,12                   # 15o
        lqd     $vertex_a_2,48($object)                 # 16o
        lqd     $vertex_c_2,80($object)                 # 17o
        lqd     $vertex_b_2,64($object)                 # 18o
        lqd     $p,0($a_shear_2)                        # 19o
        lqd     $p_2,128($a_shear_2)                    # 20o
        lqd     $p_3,64($a_shear_2)                     # 21o
        lqd     $q_2,320($a_shear_2)                    # 22o
        lqd     $q_3,192($a_shear_2)                    # 23o
        lqd     $p_4,16($a_shear_2)                     # 24o
        lqd     $p_5,80($a_shear_2)                     # 25o
        lqd     $p_6,96($a_shear_2)                     # 26o
        lqd     $p_7,160($a_shear_2)                    # 27o
        lqd     $p_8,48($a_shear_2)                     # 28o
        lqd     $q_4,256($a_shear_2)                    # 29o
        shufb   $xc_2,$vertex_c_2,$vertex_c_2,$p        # 30o
        shufb   $za_2,$vertex_a_2,$vertex_a_2,$p_2      # 31o
        lqd     $p_9,32($a_shear_2)                     # 32o
        lqd     $p_10,176($a_shear_2)                   # 33o
        fs      $xc_2,$xc_2,$q_3                        # 34e
        shufb   $ya_2,$vertex_a_2,$vertex_a_2,$p_3      # 34o
        fs      $za_3,$za_2,$q_2                        # 35e
        shufb   $xb_2,$vertex_b_2,$vertex_b_2,$p        # 35o
        lqd     $p_11,112($a_shear_2)                   # 36o
        lqd     $p_12,144($a_shear_2)                   # 37o
        fs      $ya_2,$ya_2,$q_4                        # 38e
        shufb   $zb_2,$vertex_b_2,$vertex_b_2,$p_2      # 38o
        fs      $xb_2,$xb_2,$q_3                        # 39e
        shufb   $zc_2,$vertex_c_2,$vertex_c_2,$p_2      # 39o
        shufb   $yc_2,$vertex_c_2,$vertex_c_2,$p_3      # 40o
        lqd     $q_5,208($a_shear_2)                    # 41o
        fs      $zb_2,$zb_2,$q_2                        # 42e
        lqd     $q_6,352($a_shear_2)                    # 42o
        fs      $zc_2,$zc_2,$q_2                        # 43e
        lqd     $q_7,224($a_shear_2)                    # 43o
        fs      $yc_2,$yc_2,$q_4                        # 44e
        lqd     $q_8,368($a_shear_2)                    # 44o
        lqd     $q_9,272($a_shear_2)                    # 45o
        lqd     $slope_2,384($a_shear_2)                # 46o
        lqd     $q_10,240($a_shear_2)                   # 47o
        lqd     $q_11,288($a_shear_2)                   # 48o
        lqd     $q_12,304($a_shear_2)                   # 49o
        lqd     $q_13,336($a_shear_2)                   # 50o
        nop     $127                                    # 51e pairing
        shufb   $ya_3,$vertex_a_2,$vertex_a_2,$p_5      # 51o
        fnms    $xb_2,$slope_2,$zb_2,$xb_2              # 52e
        shufb   $za_4,$vertex_a_2,$vertex_a_2,$p_7      # 52o
        fnms    $xc_3,$slope_2,$zc_2,$xc_2              # 53e
        shufb   $zc_3,$vertex_c_2,$vertex_c_2,$p_7      # 53o
        nop     $127                                    # 54e pairing
        shufb   $xc_4,$vertex_c_2,$vertex_c_2,$p_4      # 54o
        fs      $ya_3,$ya_3,$q_9                        # 55e
        shufb   $xc_5,$vertex_c_2,$vertex_c_2,$p_9      # 55o
        fs      $za_4,$za_4,$q_6                        # 56e
        shufb   $xc_6,$vertex_c_2,$vertex_c_2,$p_8      # 56o
        fs      $zc_3,$zc_3,$q_6                        # 57e
        lqd     $slope_3,448($a_shear_2)                # 57o
        fs      $xc_4,$xc_4,$q_5                        # 58e
        shufb   $xa_2,$vertex_a_2,$vertex_a_2,$p        # 58o
        fs      $xc_7,$xc_5,$q_7                        # 59e
        shufb   $xb_3,$vertex_b_2,$vertex_b_2,$p_4      # 59o
        fs      $xc_6,$xc_6,$q_10                       # 60e
        shufb   $yc_3,$vertex_c_2,$vertex_c_2,$p_5      # 60o
        nop     $127                                    # 61e pairing
        shufb   $za_5,$vertex_a_2,$vertex_a_2,$p_10     # 61o
        fs      $xa_2,$xa_2,$q_3                        # 62e
        shufb   $zc_4,$vertex_c_2,$vertex_c_2,$p_10     # 62o
        fs      $xb_3,$xb_3,$q_5                        # 63e
        shufb   $zc_5,$vertex_c_2,$vertex_c_2,$p_12     # 63o
        fnms    $ya_4,$slope_3,$za_3,$ya_2              # 64e
        shufb   $xb_4,$vertex_b_2,$vertex_b_2,$p_9      # 64o
        fs      $za_5,$za_5,$q_8                        # 65e
        shufb   $yc_4,$vertex_c_2,$vertex_c_2,$p_6      # 65o
        fs      $zc_4,$zc_4,$q_8                        # 66e
        shufb   $yc_5,$vertex_c_2,$vertex_c_2,$p_11     # 66o
        fs      $zc_6,$zc_5,$q_13                       # 67e
        shufb   $za_6,$vertex_a_2,$vertex_a_2,$p_12     # 67o
        fs      $xb_4,$xb_4,$q_7                        # 68e
        shufb   $ya_5,$vertex_a_2,$vertex_a_2,$p_6      # 68o
        fs      $yc_4,$yc_4,$q_11                       # 69e
        shufb   $zb_3,$vertex_b_2,$vertex_b_2,$p_7      # 69o
        fs      $yc_6,$yc_5,$q_12                       # 70e
        shufb   $zb_4,$vertex_b_2,$vertex_b_2,$p_10     # 70o
        fs      $za_6,$za_6,$q_13                       # 71e
        shufb   $xb_5,$vertex_b_2,$vertex_b_2,$p_8      # 71o
        fs      $ya_5,$ya_5,$q_11                       # 72e
        shufb   $zb_5,$vertex_b_2,$vertex_b_2,$p_12     # 72o
        fs      $zb_3,$zb_3,$q_6                        # 73e
        shufb   $ya_6,$vertex_a_2,$vertex_a_2,$p_11     # 73o
        fs      $zb_4,$zb_4,$q_8                        # 74e
        shufb   $yb_2,$vertex_b_2,$vertex_b_2,$p_3      # 74o
        fs      $xb_5,$xb_5,$q_10                       # 75e
        lqd     $slope_4,464($a_shear_2)                # 75o
        fs      $zb_6,$zb_5,$q_13                       # 76e
        lqd     $slope_5,416($a_shear_2)                # 76o
        fs      $ya_6,$ya_6,$q_12                       # 77e
        lqd     $slope_6,432($a_shear_2)                # 77o
        fs      $yb_2,$yb_2,$q_4                        # 78e
        lqd     $slope_7,400($a_shear_2)                # 78o
        fnms    $yc_7,$slope_3,$zc_2,$yc_2              # 79e
        lqd     $slope_8,496($a_shear_2)                # 79o
        fs      $yc_3,$yc_3,$q_9                        # 80e
        shufb   $yb_3,$vertex_b_2,$vertex_b_2,$p_6      # 80o
        fnms    $ya_3,$slope_4,$za_6,$ya_3              # 81e
        shufb   $yb_4,$vertex_b_2,$vertex_b_2,$p_11     # 81o
        fnms    $xb_6,$slope_5,$zb_3,$xb_4              # 82e
        lqd     $slope_9,480($a_shear_2)                # 82o
        fnms    $xc_6,$slope_6,$zc_4,$xc_6              # 83e
        shufb   $xa_3,$vertex_a_2,$vertex_a_2,$p_4      # 83o
        fnms    $xb,$slope_7,$zb_6,$xb_3                # 84e
        shufb   $xa_4,$vertex_a_2,$vertex_a_2,$p_9      # 84o
        fnms    $yb_2,$slope_3,$zb_2,$yb_2              # 85e
        shufb   $xa_5,$vertex_a_2,$vertex_a_2,$p_8      # 85o
        fnms    $xc_8,$slope_7,$zc_6,$xc_4              # 86e
        shufb   $yb_5,$vertex_b_2,$vertex_b_2,$p_5      # 86o
        fs      $xa_3,$xa_3,$q_5                        # 87e
        lqd     $both_2,32($object)                     # 87o
        fnms    $yc_8,$slope_9,$zc_3,$yc_4              # 88e
        lqd     $slope_10,512($a_shear_2)               # 88o
        fs      $xa_5,$xa_5,$q_10                       # 89e
        lqd     $slope_11,560($a_shear_2)               # 89o
        fs      $yb_5,$yb_5,$q_9                        # 90e
        lqd     $slope_12,528($a_shear_2)               # 90o
        fnms    $ya_7,$slope_9,$za_4,$ya_5              # 91e
        lqd     $slope_13,544($a_shear_2)               # 91o
        fnms    $yc_3,$slope_4,$zc_6,$yc_3              # 92e
        rotqbyi $a_packet_2,$object,4                   # 92o
        fnms    $xc_7,$slope_5,$zc_3,$xc_7              # 93e
        shufb   $both_3,$both_2,$both_2,$m_w            # 93o
        fs      $xa_4,$xa_4,$q_7                        # 94e
        shufb   $object_2,$object,$object,$m_splat      # 94o
        fs      $yb_6,$yb_3,$q_11                       # 95e
        fs      $yb_7,$yb_4,$q_12                       # 96e
        fnms    $xb_7,$slope_6,$zb_4,$xb_5              # 97e
        rotqbii $both_3,$both_3,1                       # 97o
        fnms    $ya_8,$slope_8,$za_5,$ya_6              # 98e
        fnms    $yc_6,$slope_8,$zc_4,$yc_6              # 99e
        fm      $p_13,$yc_7,$xb_2                       # 100e
        fnms    $xa_2,$slope_2,$za_3,$xa_2              # 101e
        fm      $p_14,$ya_4,$xc_3                       # 102e
        fm      $p_15,$ya_7,$xc_7                       # 103e
        fm      $p_16,$ya_8,$xc_6                       # 104e
        fm      $p_17,$yc_3,$xb                         # 105e
        fnms    $xa_3,$slope_7,$za_6,$xa_3              # 106e
        fm      $p_12,$yb_2,$xa_2                       # 107e
        fm      $p_18,$yc_8,$xb_6                       # 108e
        fnms    $xa_5,$slope_6,$za_5,$xa_5              # 109e
        fnms    $yb_7,$slope_8,$zb_4,$yb_7              # 110e
        fm      $p_19,$yc_6,$xb_7                       # 111e
        fnms    $xa_4,$slope_5,$za_4,$xa_4              # 112e
        fms     $v_2,$xa_2,$yc_7,$p_14                  # 113e
        fnms    $yb_5,$slope_4,$zb_6,$yb_5              # 114e
        fnms    $yb_6,$slope_9,$zb_3,$yb_6              # 115e
        fm      $p_20,$ya_3,$xc_8                       # 116e
        fms     $q_5,$ya_4,$xc_3,$p_14                  # 117e
        fms     $q_14,$yc_7,$xb_2,$p_13                 # 118e
        fms     $u_2,$xc_3,$yb_2,$p_13                  # 119e
        fms     $q_15,$yc_3,$xb,$p_17                   # 120e
        fms     $q_16,$ya_7,$xc_7,$p_15                 # 121e
        fm      $p_13,$yb_7,$xa_5                       # 122e
        fms     $v_3,$xa_3,$yc_3,$p_20                  # 123e
        fms     $v_4,$xa_5,$yc_6,$p_16                  # 124e
        fms     $q_17,$yb_2,$xa_2,$p_12                 # 125e
        fms     $u_3,$xc_7,$yb_6,$p_18                  # 126e
        fms     $u_4,$xc_8,$yb_5,$p_17                  # 127e
        fm      $p_14,$yb_5,$xa_3                       # 128e
        fs      $u_2,$u_2,$q_14                         # 129e
        fms     $w,$xb_2,$ya_4,$p_12                    # 130e
        fms     $q_18,$yc_8,$xb_6,$p_18                 # 131e
        fms     $q_19,$yc_6,$xb_7,$p_19                 # 132e
        fms     $u_5,$xc_6,$yb_7,$p_19                  # 133e
        fms     $q_20,$ya_3,$xc_8,$p_20                 # 134e
        fms     $v_5,$xa_4,$yc_8,$p_15                  # 135e
        fm      $p_20,$yb_6,$xa_4                       # 136e
        fms     $q_2,$ya_8,$xc_6,$p_16                  # 137e
        fs      $v_6,$v_2,$q_5                          # 138e
        fs      $u_6,$u_3,$q_18                         # 139e
        fms     $q_21,$yb_7,$xa_5,$p_13                 # 140e
        fms     $q_22,$yb_5,$xa_3,$p_14                 # 141e
        fms     $q_23,$yb_6,$xa_4,$p_20                 # 142e
        fms     $w_2,$xb_7,$ya_8,$p_13                  # 143e
        fa      $det_2,$u_2,$v_6                        # 144e
        fs      $v_4,$v_4,$q_2                          # 145e
        fs      $v,$v_5,$q_16                           # 146e
        fs      $u_5,$u_5,$q_19                         # 147e
        fs      $v_7,$v_3,$q_20                         # 148e
        fms     $w_3,$xb_6,$ya_7,$p_20                  # 149e
        fms     $w_4,$xb,$ya_3,$p_14                    # 150e
        fs      $u_7,$u_4,$q_15                         # 151e
        fs      $w_5,$w,$q_17                           # 152e
        fa      $det_3,$u_6,$v                          # 153e
        fa      $det_4,$u_5,$v_4                        # 154e
        fs      $w_3,$w_3,$q_23                         # 155e
        fs      $w,$w_2,$q_21                           # 156e
        fa      $det_5,$u_7,$v_7                        # 157e
        fs      $w_6,$w_4,$q_22                         # 158e
        fa      $det_6,$det_2,$w_5                      # 159e
        fa      $det_7,$det_3,$w_3                      # 161e
        fa      $det_8,$det_4,$w                        # 162e
        fa      $det_5,$det_5,$w_6                      # 164e
        lnop                                            # 164o pairing
        xor     $control_2,$det_6,$slope_10             # 165e of -1 / direction z
        frest   $t_y_2,$det_6                           # 165o
        xor     $control_3,$det_7,$slope_13             # 167e of -1 / direction z
        frest   $t_y_3,$det_7                           # 167o
        xor     $control_4,$det_8,$slope_11             # 168e of -1 / direction z
        frest   $t_y_4,$det_8                           # 168o
        fi      $t_y_5,$det_6,$t_y_2                    # 169e
        lnop                                            # 169o pairing
        xor     $control_5,$det_5,$slope_12             # 170e of -1 / direction z
        frest   $t_y_6,$det_5                           # 170o
        fi      $t_y_2,$det_7,$t_y_3                    # 171e
        fi      $t_y_4,$det_8,$t_y_4                    # 172e
        or      $control_6,$control_5,$both_3           # 173e
        fi      $t_y_6,$det_5,$t_y_6                    # 174e
        or      $control_7,$control_4,$both_3           # 175e
        fnms    $t_e_2,$det_6,$t_y_5,$k_above_one       # 176e
        or      $control_8,$control_2,$both_3           # 177e
        fnms    $t_e_3,$det_7,$t_y_2,$k_above_one       # 178e
        fnms    $t_e_4,$det_8,$t_y_4,$k_above_one       # 179e
        or      $control_9,$control_3,$both_3           # 180e
        fnms    $t_e_5,$det_5,$t_y_6,$k_above_one       # 181e
        fma     $inverse_2,$t_e_2,$t_y_5,$t_y_5         # 182e
        fma     $inverse_3,$t_e_3,$t_y_2,$t_y_2         # 184e
        fma     $inverse_4,$t_e_4,$t_y_4,$t_y_4         # 185e
        fma     $inverse_5,$t_e_5,$t_y_6,$t_y_6         # 187e
        fm      $u_8,$u_2,$inverse_2                    # 188e
        fm      $v_8,$v_6,$inverse_2                    # 189e
        fm      $u_9,$u_6,$inverse_3                    # 190e
        fm      $u_2,$u_5,$inverse_4                    # 191e
        fm      $v,$v,$inverse_3                        # 192e
        fm      $u_10,$u_7,$inverse_5                   # 193e
        fm      $ahead,$u_8,$za_3                       # 194e
        fm      $v_7,$v_7,$inverse_5                    # 195e
        fm      $ahead_2,$u_9,$za_4                     # 196e
        fm      $v_9,$v_4,$inverse_4                    # 197e
        fm      $ahead_3,$u_2,$za_5                     # 198e
        fm      $ahead_4,$u_10,$za_6                    # 199e
        fma     $ahead_5,$v_8,$zb_2,$ahead              # 200e
next_triangle:
            fm      $w,$w,$inverse_4                    # 0e
        lqd     $object,0($a_candidate)                 # 0o
            fm      $w_7,$w_5,$inverse_2                # 1e
            lnop                                        # 1o pairing
            fma     $ahead,$v_7,$zb_6,$ahead_4          # 2e
            lqd     $t_best,384($a_packet_2)            # 2o
            fm      $w_2,$w_6,$inverse_5                # 3e
            lqd     $t_best_2,416($a_packet_2)          # 3o
            fma     $ahead_3,$v_9,$zb_4,$ahead_3        # 4e
            lqd     $t_best_3,400($a_packet_2)          # 4o
            fm      $w_8,$w_3,$inverse_3                # 5e
            lqd     $t_best_4,432($a_packet_2)          # 5o
            fma     $ahead_6,$v,$zb_3,$ahead_2          # 6e
        rotqbyi $a_shear_2,$object,12                   # 6o
            fma     $ahead_2,$w_7,$zc_2,$ahead_5        # 7e
        lqd     $vertex_a_2,48($object)                 # 7o
            or      $outside,$u_8,$v_8                  # 8e
        lqd     $vertex_b_2,64($object)                 # 8o
            fma     $ahead,$w_2,$zc_6,$ahead            # 9e
        lqd     $vertex_c_2,80($object)                 # 9o
            fma     $ahead_3,$w,$zc_4,$ahead_3          # 10e
        lqd     $p,0($a_shear_2)                        # 10o
            or      $outside_2,$u_10,$v_7               # 11e
        lqd     $p_3,64($a_shear_2)                     # 11o
            fma     $ahead_6,$w_8,$zc_3,$ahead_6        # 12e
        lqd     $p_2,128($a_shear_2)                    # 12o
            fm      $ahead_2,$ahead_2,$slope_10         # 13e
        lqd     $p_4,16($a_shear_2)                     # 13o
            or      $outside_3,$u_9,$v                  # 14e
        lqd     $p_5,80($a_shear_2)                     # 14o
            fm      $ahead,$ahead,$slope_12             # 15e
        lqd     $p_9,32($a_shear_2)                     # 15o
            fm      $ahead_3,$ahead_3,$slope_11         # 16e
        lqd     $p_6,96($a_shear_2)                     # 16o
            or      $outside_4,$u_2,$v_9                # 17e
        lqd     $p_21,160($a_shear_2)                   # 17o
            fm      $ahead_6,$ahead_6,$slope_13         # 18e
        lqd     $p_8,48($a_shear_2)                     # 18o
            xor     $t,$ahead_2,$k_sign                 # 19e
        lqd     $p_11,112($a_shear_2)                   # 19o
            or      $outside,$outside,$w_7              # 20e
        lqd     $p_7,144($a_shear_2)                    # 20o
            xor     $t_2,$ahead,$k_sign                 # 21e
        lqd     $p_22,176($a_shear_2)                   # 21o
            xor     $t_3,$ahead_3,$k_sign               # 22e
        lqd     $q_3,192($a_shear_2)                    # 22o
            cgt     $control,$t_best_3,$t_2             # 23e
        lqd     $q_4,256($a_shear_2)                    # 23o
            xor     $t_4,$ahead_6,$k_sign               # 24e
        lqd     $q_5,208($a_shear_2)                    # 24o
            or      $outside_4,$outside_4,$w            # 25e
        lqd     $q_24,352($a_shear_2)                   # 25o
            or      $outside_5,$outside_3,$w_8          # 26e
        lqd     $q_10,240($a_shear_2)                   # 26o
            cgt     $control_10,$t_best_4,$t_3          # 27e
        lqd     $q_13,336($a_shear_2)                   # 27o
            orc     $outside,$outside,$control_8        # 28e
        lqd     $q_7,224($a_shear_2)                    # 28o
            cgt     $control_11,$t_best,$t              # 29e
        lqd     $q_11,288($a_shear_2)                   # 29o
            or      $outside_6,$outside_2,$w_2          # 30e
        lqd     $q_12,304($a_shear_2)                   # 30o
            and     $control,$control,$ahead            # 31e
        lqd     $q_8,368($a_shear_2)                    # 31o
            cgt     $control_12,$t_best_2,$t_4          # 32e
        lqd     $q_2,320($a_shear_2)                    # 32o
            and     $control_13,$control_10,$ahead_3    # 33e
        shufb   $zb_2,$vertex_b_2,$vertex_b_2,$p_2      # 33o
            and     $control_14,$control_11,$ahead_2    # 34e
        shufb   $zc_2,$vertex_c_2,$vertex_c_2,$p_2      # 34o
            orc     $outside_4,$outside_4,$control_7    # 35e
        shufb   $xb_3,$vertex_b_2,$vertex_b_2,$p_4      # 35o
            orc     $outside_6,$outside_6,$control_6    # 36e
        lqd     $q_9,272($a_shear_2)                    # 36o
            orc     $outside_5,$outside_5,$control_9    # 37e
        shufb   $ya_3,$vertex_a_2,$vertex_a_2,$p_5      # 37o
        fs      $zb_2,$zb_2,$q_2                        # 38e
        shufb   $yc_3,$vertex_c_2,$vertex_c_2,$p_5      # 38o
        fs      $zc_2,$zc_2,$q_2                        # 39e
        shufb   $za_6,$vertex_a_2,$vertex_a_2,$p_7      # 39o
        fs      $xb_3,$xb_3,$q_5                        # 40e
        shufb   $ya_5,$vertex_a_2,$vertex_a_2,$p_6      # 40o
            and     $control_15,$control_12,$ahead_6    # 41e
        shufb   $za_4,$vertex_a_2,$vertex_a_2,$p_21     # 41o
        fs      $ya_3,$ya_3,$q_9                        # 42e
        shufb   $zb_3,$vertex_b_2,$vertex_b_2,$p_21     # 42o
        fs      $yc_3,$yc_3,$q_9                        # 43e
        shufb   $zc_3,$vertex_c_2,$vertex_c_2,$p_21     # 43o
        fs      $za_6,$za_6,$q_13                       # 44e
        shufb   $za_5,$vertex_a_2,$vertex_a_2,$p_22     # 44o
        fs      $ya_5,$ya_5,$q_11                       # 45e
        shufb   $zb_4,$vertex_b_2,$vertex_b_2,$p_22     # 45o
        fs      $zb_3,$zb_3,$q_24                       # 46e
        shufb   $zc_4,$vertex_c_2,$vertex_c_2,$p_22     # 46o
        fs      $za_4,$za_4,$q_24                       # 47e
        shufb   $xc_2,$vertex_c_2,$vertex_c_2,$p        # 47o
        fs      $za_5,$za_5,$q_8                        # 48e
        shufb   $ya_2,$vertex_a_2,$vertex_a_2,$p_3      # 48o
        fs      $zb_4,$zb_4,$q_8                        # 49e
        shufb   $yc_2,$vertex_c_2,$vertex_c_2,$p_3      # 49o
        fs      $zc_3,$zc_3,$q_24                       # 50e
        shufb   $zc_7,$vertex_c_2,$vertex_c_2,$p_7      # 50o
        fs      $xc_2,$xc_2,$q_3                        # 51e
        shufb   $xb_4,$vertex_b_2,$vertex_b_2,$p_9      # 51o
        fs      $ya_2,$ya_2,$q_4                        # 52e
        shufb   $yc_4,$vertex_c_2,$vertex_c_2,$p_6      # 52o
        fs      $yc_2,$yc_2,$q_4                        # 53e
        shufb   $xb_5,$vertex_b_2,$vertex_b_2,$p_8      # 53o
        fs      $zc_6,$zc_7,$q_13                       # 54e
        shufb   $xb_2,$vertex_b_2,$vertex_b_2,$p        # 54o
        fs      $xb_4,$xb_4,$q_7                        # 55e
        shufb   $za_7,$vertex_a_2,$vertex_a_2,$p_2      # 55o
        fs      $yc_4,$yc_4,$q_11                       # 56e
        shufb   $xc_4,$vertex_c_2,$vertex_c_2,$p_4      # 56o
        fs      $xb_5,$xb_5,$q_10                       # 57e
        shufb   $zb_7,$vertex_b_2,$vertex_b_2,$p_7      # 57o
        fs      $xb_2,$xb_2,$q_3                        # 58e
        shufb   $xc_5,$vertex_c_2,$vertex_c_2,$p_9      # 58o
        fs      $za_7,$za_7,$q_2                        # 59e
        shufb   $xc_6,$vertex_c_2,$vertex_c_2,$p_8      # 59o
        fs      $xc_4,$xc_4,$q_5                        # 60e
        shufb   $ya_6,$vertex_a_2,$vertex_a_2,$p_11     # 60o
        fs      $zb_6,$zb_7,$q_13                       # 61e
        shufb   $yc_6,$vertex_c_2,$vertex_c_2,$p_11     # 61o
        fs      $xc_9,$xc_5,$q_7                        # 62e
        lqd     $slope_14,448($a_shear_2)               # 62o
        fs      $xc_6,$xc_6,$q_10                       # 63e
        lqd     $slope_4,464($a_shear_2)                # 63o
        fs      $ya_6,$ya_6,$q_12                       # 64e
        lqd     $slope_5,416($a_shear_2)                # 64o
        fs      $yc_6,$yc_6,$q_12                       # 65e
        lqd     $slope_2,384($a_shear_2)                # 65o
        fs      $zc_4,$zc_4,$q_8                        # 66e
        lnop                                            # 66o pairing
            andc    $control_14,$control_14,$outside    # 67e
        lqd     $slope_6,432($a_shear_2)                # 67o
        fnms    $ya_4,$slope_14,$za_7,$ya_2             # 68e
        lnop                                            # 68o pairing
        fnms    $ya_3,$slope_4,$za_6,$ya_3              # 69e
        shufb   $xa_2,$vertex_a_2,$vertex_a_2,$p        # 69o
        fnms    $xb_6,$slope_5,$zb_3,$xb_4              # 70e
        shufb   $yb_2,$vertex_b_2,$vertex_b_2,$p_3      # 70o
        fnms    $xb_2,$slope_2,$zb_2,$xb_2              # 71e
        shufb   $xa_3,$vertex_a_2,$vertex_a_2,$p_4      # 71o
        fnms    $yc_3,$slope_4,$zc_6,$yc_3              # 72e
        lqd     $slope_15,400($a_shear_2)               # 72o
        fnms    $xc_6,$slope_6,$zc_4,$xc_6              # 73e
        shufb   $xa_4,$vertex_a_2,$vertex_a_2,$p_9      # 73o
        fs      $yb_2,$yb_2,$q_4                        # 74e
        shufb   $yb_8,$vertex_b_2,$vertex_b_2,$p_6      # 74o
        fnms    $xc_9,$slope_5,$zc_3,$xc_9              # 75e
        shufb   $xa_5,$vertex_a_2,$vertex_a_2,$p_8      # 75o
        fs      $xa_2,$xa_2,$q_3                        # 76e
        shufb   $yb_9,$vertex_b_2,$vertex_b_2,$p_11     # 76o
        fs      $xa_4,$xa_4,$q_7                        # 77e
        shufb   $yb_5,$vertex_b_2,$vertex_b_2,$p_5      # 77o
        fs      $yb_6,$yb_8,$q_11                       # 78e
        lnop                                            # 78o pairing
        fnms    $xc_10,$slope_15,$zc_6,$xc_4            # 79e
        lqd     $slope_9,480($a_shear_2)                # 79o
        fnms    $xc_11,$slope_2,$zc_2,$xc_2             # 80e
        lnop                                            # 80o pairing
        fs      $yb_5,$yb_5,$q_9                        # 81e
        lqd     $both_4,32($object)                     # 81o
        fnms    $yc_9,$slope_14,$zc_2,$yc_2             # 82e
        lnop                                            # 82o pairing
        fs      $xa_3,$xa_3,$q_5                        # 83e
        lqd     $slope_16,496($a_shear_2)               # 83o
        fnms    $xb_8,$slope_15,$zb_6,$xb_3             # 84e
            rotqbii $control_14,$control_14,1           # 84o
        fnms    $ya_7,$slope_9,$za_4,$ya_5              # 85e
        fnms    $yc_10,$slope_9,$zc_3,$yc_4             # 86e
        fs      $xa_5,$xa_5,$q_10                       # 87e
        shufb   $both_3,$both_4,$both_4,$m_w            # 87o
        fs      $yb_7,$yb_9,$q_12                       # 88e
        fnms    $xb_9,$slope_6,$zb_4,$xb_5              # 89e
        fnms    $ya_9,$slope_16,$za_5,$ya_6             # 90e
        lnop                                            # 90o pairing
        fnms    $yc_6,$slope_16,$zc_4,$yc_6             # 91e
        rotqbii $both_3,$both_3,1                       # 91o
        fm      $p_13,$yc_9,$xb_2                       # 92e
        lnop                                            # 92o pairing
        fnms    $yb_5,$slope_4,$zb_6,$yb_5              # 93e
            gb      $control_14,$control_14             # 93o
        fm      $p_17,$yc_3,$xb_8                       # 94e
        fnms    $yb_6,$slope_9,$zb_3,$yb_6              # 95e
        fnms    $xa_3,$slope_15,$za_6,$xa_3             # 96e
        lnop                                            # 96o pairing
        fm      $p_11,$yc_10,$xb_6                      # 97e
            shlqbii $control_14,$control_14,4           # 97o
        fnms    $xa_5,$slope_6,$za_5,$xa_5              # 98e
        fnms    $yb_7,$slope_16,$zb_4,$yb_7             # 99e
        fm      $p_19,$yc_6,$xb_9                       # 100e
        lnop                                            # 100o pairing
        fnms    $xa_2,$slope_2,$za_7,$xa_2              # 101e
            lqx     $control_14,$control_14,$a_controls # 101o
        fnms    $yb_2,$slope_14,$zb_2,$yb_2             # 102e
            lqd     $nearest_2,448($a_packet_2)         # 102o
        fm      $p_14,$ya_4,$xc_11                      # 103e
        fm      $p_20,$ya_3,$xc_10                      # 104e
        fnms    $xa_4,$slope_5,$za_4,$xa_4              # 105e
        fm      $p_15,$ya_7,$xc_9                       # 106e
        fm      $p_16,$ya_9,$xc_6                       # 107e
            shufb   $t_best,$t_best,$t,$control_14      # 107o
        fm      $p_23,$yb_2,$xa_2                       # 108e
            shufb   $nearest_3,$nearest_2,$object_2,$control_14 # 108o
        fms     $q_5,$ya_4,$xc_11,$p_14                 # 109e
        fms     $q_15,$yc_3,$xb_8,$p_17                 # 110e
        fms     $q_18,$yc_10,$xb_6,$p_11                # 111e
            stqd    $t_best,384($a_packet_2)            # 111o
        fms     $q_19,$yc_6,$xb_9,$p_19                 # 112e
            stqd    $nearest_3,448($a_packet_2)         # 112o
        fms     $u_5,$xc_6,$yb_7,$p_19                  # 113e
        fms     $q_8,$yc_9,$xb_2,$p_13                  # 114e
        fms     $u_2,$xc_11,$yb_2,$p_13                 # 115e
        fms     $v_2,$xa_2,$yc_9,$p_14                  # 116e
        fms     $u_3,$xc_9,$yb_6,$p_11                  # 117e
        fms     $q_16,$ya_7,$xc_9,$p_15                 # 118e
        fm      $p_13,$yb_7,$xa_5                       # 119e
        fms     $u_4,$xc_10,$yb_5,$p_17                 # 120e
        fms     $q_25,$ya_3,$xc_10,$p_20                # 121e
        fms     $v_3,$xa_3,$yc_3,$p_20                  # 122e
        fm      $p_14,$yb_5,$xa_3                       # 123e
        fms     $v_5,$xa_4,$yc_10,$p_15                 # 124e
        fm      $p_20,$yb_6,$xa_4                       # 125e
        fms     $q_2,$ya_9,$xc_6,$p_16                  # 126e
        fms     $v_10,$xa_5,$yc_6,$p_16                 # 127e
        fs      $v_6,$v_2,$q_5                          # 128e
        fms     $w_9,$xb_9,$ya_9,$p_13                  # 129e
        fs      $u_2,$u_2,$q_8                          # 130e
        fms     $q_23,$yb_6,$xa_4,$p_20                 # 131e
        fms     $q_17,$yb_2,$xa_2,$p_23                 # 132e
        fs      $v_10,$v_10,$q_2                        # 133e
        fms     $w,$xb_2,$ya_4,$p_23                    # 134e
        fms     $w_4,$xb_8,$ya_3,$p_14                  # 135e
        fs      $u_6,$u_3,$q_18                         # 136e
        fs      $v,$v_5,$q_16                           # 137e
        fs      $u_5,$u_5,$q_19                         # 138e
        fms     $q_21,$yb_7,$xa_5,$p_13                 # 139e
        fs      $u_7,$u_4,$q_15                         # 140e
        fs      $v_7,$v_3,$q_25                         # 141e
        fms     $q_22,$yb_5,$xa_3,$p_14                 # 142e
        fms     $w_3,$xb_6,$ya_7,$p_20                  # 143e
        fs      $w_5,$w,$q_17                           # 144e
        fs      $w,$w_9,$q_21                           # 145e
        fa      $det_6,$u_2,$v_6                        # 146e
        fa      $det_9,$u_7,$v_7                        # 147e
        fs      $w_6,$w_4,$q_22                         # 148e
        fs      $w_3,$w_3,$q_23                         # 149e
        fa      $det_10,$u_6,$v                         # 150e
        fa      $det_11,$u_5,$v_10                      # 151e
        lnop                                            # 151o pairing
        fa      $det_6,$det_6,$w_5                      # 152e
        lqd     $slope_10,512($a_shear_2)               # 152o
            andc    $control,$control,$outside_6        # 153e
        lqd     $slope_12,528($a_shear_2)               # 153o
        fa      $det_5,$det_9,$w_6                      # 154e
        lqd     $slope_11,560($a_shear_2)               # 154o
            andc    $control_16,$control_15,$outside_5  # 155e
            rotqbii $control,$control,1                 # 155o
        fa      $det_7,$det_10,$w_3                     # 156e
        lqd     $slope_13,544($a_shear_2)               # 156o
        fa      $det_8,$det_11,$w                       # 157e
            rotqbii $control_16,$control_16,1           # 157o
        xor     $control_2,$det_6,$slope_10             # 158e of -1 / direction z
        frest   $t_y_2,$det_6                           # 158o
            andc    $control_13,$control_13,$outside_4  # 159e
            gb      $control,$control                   # 159o
        xor     $control_5,$det_5,$slope_12             # 160e of -1 / direction z
        frest   $t_y_6,$det_5                           # 160o
        or      $control_8,$control_2,$both_3           # 161e
            rotqbii $control_13,$control_13,1           # 161o
        fi      $t_y_7,$det_6,$t_y_2                    # 162e
        frest   $t_y_2,$det_7                           # 162o
        xor     $control_4,$det_8,$slope_11             # 163e of -1 / direction z
        frest   $t_y_4,$det_8                           # 163o
        fi      $t_y_6,$det_5,$t_y_6                    # 164e
            gb      $control_16,$control_16             # 164o
        xor     $control_3,$det_7,$slope_13             # 165e of -1 / direction z
            gb      $control_13,$control_13             # 165o
        fi      $t_y_2,$det_7,$t_y_2                    # 166e
            shlqbii $control,$control,4                 # 166o
        fi      $t_y_4,$det_8,$t_y_4                    # 167e
            lqd     $nearest_4,464($a_packet_2)         # 167o
        or      $control_9,$control_3,$both_3           # 168e
            shlqbii $control_16,$control_16,4           # 168o
        fnms    $t_e_2,$det_6,$t_y_7,$k_above_one       # 169e
            shlqbii $control_13,$control_13,4           # 169o
        or      $control_6,$control_5,$both_3           # 170e
            lqx     $control,$control,$a_controls       # 170o
        fnms    $t_e_5,$det_5,$t_y_6,$k_above_one       # 171e
            lqd     $nearest_5,496($a_packet_2)         # 171o
        or      $control_7,$control_4,$both_3           # 172e
            lqx     $control_16,$control_16,$a_controls # 172o
        fnms    $t_e_3,$det_7,$t_y_2,$k_above_one       # 173e
            lqx     $control_13,$control_13,$a_controls # 173o
        fnms    $t_e_4,$det_8,$t_y_4,$k_above_one       # 174e
        hbrr    next_triangle_back,next_triangle        # 174o hint
        fma     $inverse_2,$t_e_2,$t_y_7,$t_y_7         # 175e
            lqd     $nearest_6,480($a_packet_2)         # 175o
        ai      $count,$count,-1                        # 176e
            shufb   $nearest_7,$nearest_4,$object_2,$control # 176o
        fma     $inverse_5,$t_e_5,$t_y_6,$t_y_6         # 177e
            shufb   $t_best_3,$t_best_3,$t_2,$control   # 177o
        ai      $a_candidate,$a_candidate,16            # 178e
            shufb   $t_best_2,$t_best_2,$t_4,$control_16 # 178o
        fma     $inverse_3,$t_e_3,$t_y_2,$t_y_2         # 179e
            shufb   $nearest_8,$nearest_5,$object_2,$control_13 # 179o
        fma     $inverse_4,$t_e_4,$t_y_4,$t_y_4         # 180e
            shufb   $t_best,$t_best_4,$t_3,$control_13  # 180o
        fm      $u_8,$u_2,$inverse_2                    # 181e
            stqd    $t_best_3,400($a_packet_2)          # 181o
        fm      $v_8,$v_6,$inverse_2                    # 182e
            stqd    $t_best_2,416($a_packet_2)          # 182o
        fm      $u_10,$u_7,$inverse_5                   # 183e
            shufb   $nearest_9,$nearest_6,$object_2,$control_16 # 183o
        fm      $v_7,$v_7,$inverse_5                    # 184e
            stqd    $t_best,432($a_packet_2)            # 184o
        fm      $u_9,$u_6,$inverse_3                    # 185e
            stqd    $nearest_8,496($a_packet_2)         # 185o
        fm      $u_2,$u_5,$inverse_4                    # 186e
            stqd    $nearest_7,464($a_packet_2)         # 186o
        fm      $ahead,$u_8,$za_7                       # 187e
            stqd    $nearest_9,480($a_packet_2)         # 187o
        fm      $v,$v,$inverse_3                        # 188e
        rotqbyi $a_packet_2,$object,4                   # 188o
        fm      $v_9,$v_10,$inverse_4                   # 189e
        shufb   $object_2,$object,$object,$m_splat      # 189o
        fm      $ahead_4,$u_10,$za_6                    # 190e
        fm      $ahead_2,$u_9,$za_4                     # 191e
        fm      $ahead_3,$u_2,$za_5                     # 192e
        lnop                                            # 192o pairing
        fma     $ahead_5,$v_8,$zb_2,$ahead              # 193e
next_triangle_back:
        brnz    $count,next_triangle                    # 193o
next_triangle_drain:
        fm      $w_7,$w_5,$inverse_2                    # 0e
        lqd     $t_best,384($a_packet_2)                # 0o
        fm      $w_2,$w_6,$inverse_5                    # 1e
        lqd     $t_best_3,400($a_packet_2)              # 1o
        fm      $w_8,$w_3,$inverse_3                    # 2e
        lqd     $t_best_4,432($a_packet_2)              # 2o
        fma     $ahead_6,$v,$zb_3,$ahead_2              # 3e
        lqd     $nearest_2,448($a_packet_2)             # 3o
        fma     $ahead,$v_7,$zb_6,$ahead_4              # 4e
        lqd     $t_best_2,416($a_packet_2)              # 4o
        fm      $w,$w,$inverse_4                        # 5e
        hbr     isect_triangle_pairs_r16_return,$lr     # 5o hint
        fma     $ahead_2,$w_7,$zc_2,$ahead_5            # 6e
        fma     $ahead_3,$v_9,$zb_4,$ahead_3            # 7e
        or      $outside,$u_8,$v_8                      # 8e
        fma     $ahead_6,$w_8,$zc_3,$ahead_6            # 9e
        fma     $ahead,$w_2,$zc_6,$ahead                # 10e
        or      $outside,$outside,$w_7                  # 11e
        fm      $ahead_2,$ahead_2,$slope_10             # 12e
        fma     $ahead_3,$w,$zc_4,$ahead_3              # 13e
        orc     $outside,$outside,$control_8            # 14e
        fm      $ahead_6,$ahead_6,$slope_13             # 15e
        fm      $ahead,$ahead,$slope_12                 # 16e
        or      $outside_2,$u_10,$v_7                   # 17e
        xor     $t,$ahead_2,$k_sign                     # 18e
        fm      $ahead_3,$ahead_3,$slope_11             # 19e
        cgt     $control_11,$t_best,$t                  # 20e
        or      $outside_6,$outside_2,$w_2              # 21e
        and     $control_14,$control_11,$ahead_2        # 22e
        xor     $t_4,$ahead_6,$k_sign                   # 23e
        andc    $control_14,$control_14,$outside        # 24e
        cgt     $control_12,$t_best_2,$t_4              # 25e
        xor     $t_2,$ahead,$k_sign                     # 26e
        rotqbii $control_14,$control_14,1               # 26o
        or      $outside_3,$u_9,$v                      # 27e
        or      $outside_4,$u_2,$v_9                    # 28e
        cgt     $control,$t_best_3,$t_2                 # 29e
        lnop                                            # 29o pairing
        orc     $outside_6,$outside_6,$control_6        # 30e
        gb      $control_14,$control_14                 # 30o
        or      $outside_4,$outside_4,$w                # 31e
        and     $control,$control,$ahead                # 32e
        xor     $t_3,$ahead_3,$k_sign                   # 33e
        lnop                                            # 33o pairing
        andc    $control,$control,$outside_6            # 34e
        shlqbii $control_14,$control_14,4               # 34o
        cgt     $control_10,$t_best_4,$t_3              # 35e
        lnop                                            # 35o pairing
        or      $outside_5,$outside_3,$w_8              # 36e
        rotqbii $control,$control,1                     # 36o
        and     $control_13,$control_10,$ahead_3        # 37e
        lnop                                            # 37o pairing
        orc     $outside_5,$outside_5,$control_9        # 38e
        lqx     $control_14,$control_14,$a_controls     # 38o
        orc     $outside_4,$outside_4,$control_7        # 39e
        lnop                                            # 39o pairing
        and     $control_15,$control_12,$ahead_6        # 40e
        gb      $control,$control                       # 40o
        andc    $control_13,$control_13,$outside_4      # 41e
        andc    $control_16,$control_15,$outside_5      # 42e
        rotqbii $control_13,$control_13,1               # 43o
        rotqbii $control_16,$control_16,1               # 44o
        shufb   $t_best,$t_best,$t,$control_14          # 45o
        shufb   $nearest_3,$nearest_2,$object_2,$control_14 # 46o
        gb      $control_13,$control_13                 # 47o
        gb      $control_16,$control_16                 # 48o
        shlqbii $control,$control,4                     # 49o
        stqd    $t_best,384($a_packet_2)                # 50o
        shlqbii $control_13,$control_13,4               # 51o
        shlqbii $control_16,$control_16,4               # 52o
        stqd    $nearest_3,448($a_packet_2)             # 53o
        lqx     $control,$control,$a_controls           # 54o
        lqx     $control_13,$control_13,$a_controls     # 55o
        lqx     $control_16,$control_16,$a_controls     # 56o
        lqd     $nearest_4,464($a_packet_2)             # 57o
        lqd     $nearest_5,496($a_packet_2)             # 58o
        lqd     $nearest_6,480($a_packet_2)             # 59o
        shufb   $t_best_3,$t_best_3,$t_2,$control       # 60o
        shufb   $t_best,$t_best_4,$t_3,$control_13      # 61o
        shufb   $t_best_2,$t_best_2,$t_4,$control_16    # 62o
        shufb   $nearest_7,$nearest_4,$object_2,$control # 63o
        shufb   $nearest_8,$nearest_5,$object_2,$control_13 # 64o
        stqd    $t_best_3,400($a_packet_2)              # 65o
        stqd    $t_best_2,416($a_packet_2)              # 66o
        shufb   $nearest_9,$nearest_6,$object_2,$control_16 # 67o
        stqd    $t_best,432($a_packet_2)                # 68o
        stqd    $nearest_8,496($a_packet_2)             # 69o
        stqd    $nearest_7,464($a_packet_2)             # 70o
        stqd    $nearest_9,480($a_packet_2)             # 71o
isect_triangle_pairs_r16_return:
        bi      $lr                                     # 72o
next_triangle_short:
        ai      $count,$count,-1                        # 0e
        lqd     $object,0($a_candidate)                 # 0o
        ai      $a_candidate,$a_candidate,16            # 1e
        rotqbyi $a_shear,$object,12                     # 6o
        lqd     $vertex_a,48($object)                   # 7o
        lqd     $vertex_c,80($object)                   # 8o
        lqd     $vertex_b,64($object)                   # 9o
        lqd     $p,64($a_shear)                         # 10o
        lqd     $p_7,32($a_shear)                       # 11o
        lqd     $p_12,0($a_shear)                       # 12o
        lqd     $p_10,144($a_shear)                     # 13o
        lqd     $p_24,128($a_shear)                     # 14o
        lqd     $p_25,16($a_shear)                      # 15o
        lqd     $p_26,80($a_shear)                      # 16o
        lqd     $p_27,160($a_shear)                     # 17o
        lqd     $q,352($a_shear)                        # 18o
        lqd     $q_26,224($a_shear)                     # 19o
        shufb   $za,$vertex_a,$vertex_a,$p_24           # 20o
        shufb   $xc,$vertex_c,$vertex_c,$p_7            # 21o
        shufb   $ya,$vertex_a,$vertex_a,$p_26           # 22o
        shufb   $yc,$vertex_c,$vertex_c,$p_26           # 23o
        lqd     $p_28,96($a_shear)                      # 24o
        fs      $xc,$xc,$q_26                           # 25e
        shufb   $xb,$vertex_b,$vertex_b,$p_7            # 25o
        shufb   $zc,$vertex_c,$vertex_c,$p_27           # 26o
        lqd     $q_27,192($a_shear)                     # 27o
        nop     $127                                    # 28e pairing
        shufb   $xb_10,$vertex_b,$vertex_b,$p_12        # 28o
        fs      $xb,$xb,$q_26                           # 29e
        shufb   $ya_10,$vertex_a,$vertex_a,$p           # 29o
        fs      $zc,$zc,$q                              # 30e
        shufb   $yc_11,$vertex_c,$vertex_c,$p           # 30o
        lqd     $q_28,320($a_shear)                     # 31o
        shufb   $xc_12,$vertex_c,$vertex_c,$p_12        # 32o
        fs      $xb_10,$xb_10,$q_27                     # 33e
        lqd     $q_29,208($a_shear)                     # 33o
        lqd     $q_30,288($a_shear)                     # 34o
        lqd     $q_31,256($a_shear)                     # 35o
        fs      $xc_12,$xc_12,$q_27                     # 36e
        shufb   $xb_11,$vertex_b,$vertex_b,$p_25        # 36o
        fs      $za,$za,$q_28                           # 37e
        lqd     $q_8,272($a_shear)                      # 37o
        lqd     $q_32,336($a_shear)                     # 38o
        shufb   $za_8,$vertex_a,$vertex_a,$p_10         # 39o
        fs      $xb_11,$xb_11,$q_29                     # 40e
        shufb   $zb_8,$vertex_b,$vertex_b,$p_10         # 40o
        fs      $ya_10,$ya_10,$q_31                     # 41e
        shufb   $yc_12,$vertex_c,$vertex_c,$p_28        # 41o
        fs      $yc_11,$yc_11,$q_31                     # 42e
        shufb   $zb_9,$vertex_b,$vertex_b,$p_27         # 42o
        fs      $ya,$ya,$q_8                            # 43e
        shufb   $zb_10,$vertex_b,$vertex_b,$p_24        # 43o
        fs      $yc,$yc,$q_8                            # 44e
        shufb   $xc_13,$vertex_c,$vertex_c,$p_25        # 44o
        fs      $yc_12,$yc_12,$q_30                     # 45e
        shufb   $ya_11,$vertex_a,$vertex_a,$p_28        # 45o
        fs      $zb_9,$zb_9,$q                          # 46e
        lqd     $slope_17,480($a_shear)                 # 46o
        fs      $zb_10,$zb_10,$q_28                     # 47e
        shufb   $zc_8,$vertex_c,$vertex_c,$p_24         # 47o
        fs      $xc_13,$xc_13,$q_29                     # 48e
        shufb   $zc_9,$vertex_c,$vertex_c,$p_10         # 48o
        fs      $za_8,$za_8,$q_32                       # 49e
        lqd     $slope_18,464($a_shear)                 # 49o
        fs      $zb_8,$zb_8,$q_32                       # 50e
        shufb   $za_9,$vertex_a,$vertex_a,$p_27         # 50o
        fs      $zc_8,$zc_8,$q_28                       # 51e
        shufb   $yb_10,$vertex_b,$vertex_b,$p_26        # 51o
        fs      $zc_9,$zc_9,$q_32                       # 52e
        shufb   $xa_6,$vertex_a,$vertex_a,$p_7          # 52o
        fs      $ya_12,$ya_11,$q_30                     # 53e
        lqd     $slope_19,416($a_shear)                 # 53o
        fs      $za_9,$za_9,$q                          # 54e
        lqd     $slope_20,448($a_shear)                 # 54o
        fs      $yb_10,$yb_10,$q_8                      # 55e
        shufb   $xa_7,$vertex_a,$vertex_a,$p_25         # 55o
        fnms    $ya,$slope_18,$za_8,$ya                 # 56e
        lqd     $slope_6,400($a_shear)                  # 56o
        fs      $xa_6,$xa_6,$q_26                       # 57e
        lqd     $slope_21,384($a_shear)                 # 57o
        fnms    $yc,$slope_18,$zc_9,$yc                 # 58e
        shufb   $xa_8,$vertex_a,$vertex_a,$p_12         # 58o
        fs      $xa_7,$xa_7,$q_29                       # 59e
        shufb   $yb_11,$vertex_b,$vertex_b,$p           # 59o
        fnms    $ya_10,$slope_20,$za,$ya_10             # 60e
        lqd     $p_29,176($a_shear)                     # 60o
        fnms    $yc_11,$slope_20,$zc_8,$yc_11           # 61e
        shufb   $yb_4,$vertex_b,$vertex_b,$p_28         # 61o
        fnms    $ya_12,$slope_17,$za_9,$ya_12           # 62e
        lqd     $q_33,304($a_shear)                     # 62o
        fnms    $xb_10,$slope_21,$zb_10,$xb_10          # 63e
        lqd     $p_30,48($a_shear)                      # 63o
        fnms    $xc_13,$slope_6,$zc_9,$xc_13            # 64e
        lqd     $p_31,112($a_shear)                     # 64o
        fnms    $xb,$slope_19,$zb_9,$xb                 # 65e
        lqd     $q_34,240($a_shear)                     # 65o
        fnms    $xb_11,$slope_6,$zb_8,$xb_11            # 66e
        lqd     $q_2,368($a_shear)                      # 66o
        fnms    $xc,$slope_19,$zc,$xc                   # 67e
        shufb   $zc_10,$vertex_c,$vertex_c,$p_29        # 67o
        fs      $xa_8,$xa_8,$q_27                       # 68e
        shufb   $zb_11,$vertex_b,$vertex_b,$p_29        # 68o
        fnms    $xc_12,$slope_21,$zc_8,$xc_12           # 69e
        shufb   $xb_12,$vertex_b,$vertex_b,$p_30        # 69o
        fs      $yb_4,$yb_4,$q_30                       # 70e
        shufb   $ya_13,$vertex_a,$vertex_a,$p_31        # 70o
        fs      $yb_11,$yb_11,$q_31                     # 71e
        shufb   $xc_14,$vertex_c,$vertex_c,$p_30        # 71o
        fnms    $yc_12,$slope_17,$zc,$yc_12             # 72e
        shufb   $za_10,$vertex_a,$vertex_a,$p_29        # 72o
        fnms    $xa_6,$slope_19,$za_9,$xa_6             # 73e
        lqd     $slope_19,432($a_shear)                 # 73o
        fm      $p_32,$ya_12,$xc                        # 74e
        shufb   $yc_13,$vertex_c,$vertex_c,$p_31        # 74o
        fm      $p_33,$ya_10,$xc_12                     # 75e
        lqd     $slope_22,496($a_shear)                 # 75o
        fnms    $yb_4,$slope_17,$zb_9,$yb_4             # 76e
        shufb   $yb_12,$vertex_b,$vertex_b,$p_31        # 76o
        fm      $p_34,$yc,$xb_11                        # 77e
        shufb   $xa_9,$vertex_a,$vertex_a,$p_30         # 77o
        fs      $xb_13,$xb_12,$q_34                     # 78e
        lqd     $slope_23,512($a_shear)                 # 78o
        fs      $zb_11,$zb_11,$q_2                      # 79e
        lqd     $slope_24,528($a_shear)                 # 79o
        fs      $zc_10,$zc_10,$q_2                      # 80e
        lqd     $slope_25,544($a_shear)                 # 80o
        fnms    $xa_7,$slope_6,$za_8,$xa_7              # 81e
        rotqbyi $a_packet_3,$object,4                   # 81o
        fnms    $yb_10,$slope_18,$zb_8,$yb_10           # 82e
        lqd     $both_5,32($object)                     # 82o
        fs      $xc_14,$xc_14,$q_34                     # 83e
        lqd     $slope_26,560($a_shear)                 # 83o
        fnms    $xa_8,$slope_21,$za,$xa_8               # 84e
        shufb   $object,$object,$object,$m_splat        # 84o
        fm      $p_35,$ya,$xc_13                        # 85e
        lqd     $t_best_5,400($a_packet_3)              # 85o
        fs      $yc_13,$yc_13,$q_33                     # 86e
        lqd     $t_best_6,416($a_packet_3)              # 86o
        fnms    $yb_11,$slope_20,$zb_10,$yb_11          # 87e
        lqd     $t_best_7,384($a_packet_3)              # 87o
        fm      $p_36,$yc_11,$xb_10                     # 88e
        shufb   $both_5,$both_5,$both_5,$m_w            # 88o
        fm      $p_17,$yc_12,$xb                        # 89e
        lqd     $t_best_8,432($a_packet_3)              # 89o
        fms     $v_11,$xa_8,$yc_11,$p_33                # 90e
        lqd     $nearest_10,448($a_packet_3)            # 90o
        fs      $za_10,$za_10,$q_2                      # 91e
        lqd     $nearest_4,480($a_packet_3)             # 91o
        fms     $q_35,$ya_10,$xc_12,$p_33               # 92e
        rotqbii $both_5,$both_5,1                       # 92o
        fms     $v_12,$xa_7,$yc,$p_35                   # 93e
        lqd     $nearest_11,464($a_packet_3)            # 93o
        fms     $u_11,$xc_12,$yb_11,$p_36               # 94e
        lqd     $nearest_12,496($a_packet_3)            # 94o
        fm      $p_37,$yb_10,$xa_7                      # 95e
        fms     $q_18,$yc_12,$xb,$p_17                  # 96e
        fm      $p_38,$yb_4,$xa_6                       # 97e
        fs      $ya_13,$ya_13,$q_33                     # 98e
        fnms    $xc_14,$slope_19,$zc_10,$xc_14          # 99e
        fms     $v_13,$xa_6,$yc_12,$p_32                # 100e
        fms     $q_36,$yc,$xb_11,$p_34                  # 101e
        fms     $u_12,$xc_13,$yb_10,$p_34               # 102e
        fms     $u_4,$xc,$yb_4,$p_17                    # 103e
        fnms    $ya_13,$slope_22,$za_10,$ya_13          # 104e
        fms     $q_23,$ya_12,$xc,$p_32                  # 105e
        fs      $xa_9,$xa_9,$q_34                       # 106e
        fnms    $xb_13,$slope_19,$zb_11,$xb_13          # 107e
        fms     $q_37,$yc_11,$xb_10,$p_36               # 108e
        fm      $p_39,$yb_11,$xa_8                      # 109e
        fs      $u_13,$u_12,$q_36                       # 110e
        fms     $q_26,$ya,$xc_13,$p_35                  # 111e
        fms     $q_6,$yb_10,$xa_7,$p_37                 # 112e
        fms     $w_8,$xb_11,$ya,$p_37                   # 113e
        fs      $u,$u_11,$q_37                          # 114e
        fnms    $yc_13,$slope_22,$zc_10,$yc_13          # 115e
        fs      $u_14,$u_4,$q_18                        # 116e
        fs      $v_14,$v_12,$q_26                       # 117e
        fs      $v_15,$v_13,$q_23                       # 118e
        fms     $q_20,$yb_4,$xa_6,$p_38                 # 119e
        fs      $yb_12,$yb_12,$q_33                     # 120e
        fs      $v_16,$v_11,$q_35                       # 121e
        fms     $w,$xb_10,$ya_10,$p_39                  # 122e
        fms     $w_10,$xb,$ya_12,$p_38                  # 123e
        fms     $q_38,$yb_11,$xa_8,$p_39                # 124e
        fnms    $xa_9,$slope_19,$za_10,$xa_9            # 125e
        fa      $det_12,$u_14,$v_15                     # 126e
        fm      $p,$ya_13,$xc_14                        # 127e
        fm      $p_21,$yc_13,$xb_13                     # 128e
        fs      $w_7,$w_10,$q_20                        # 129e
        fs      $w,$w,$q_38                             # 130e
        fnms    $yb_13,$slope_22,$zb_11,$yb_12          # 131e
        fs      $w_11,$w_8,$q_6                         # 132e
        fms     $v,$xa_9,$yc_13,$p                      # 133e
        fa      $det_4,$u,$v_16                         # 134e
        fa      $det_6,$u_13,$v_14                      # 135e
        fms     $q_39,$ya_13,$xc_14,$p                  # 136e
        fms     $u_6,$xc_14,$yb_13,$p_21                # 137e
        fm      $p_40,$yb_13,$xa_9                      # 138e
        fms     $q_22,$yc_13,$xb_13,$p_21               # 139e
        fa      $det_4,$det_4,$w                        # 140e
        fa      $det_6,$det_6,$w_11                     # 141e
        fa      $det_12,$det_12,$w_7                    # 142e
        fs      $v,$v,$q_39                             # 143e
        fms     $q_38,$yb_13,$xa_9,$p_40                # 144e
        fs      $u_5,$u_6,$q_22                         # 145e
        lnop                                            # 145o pairing
        fms     $w_6,$xb_13,$ya_13,$p_40                # 146e
        frest   $t_y,$det_4                             # 146o
        xor     $control_17,$det_6,$slope_24            # 147e of -1 / direction z
        frest   $t_y_8,$det_6                           # 147o
        xor     $control_18,$det_12,$slope_25           # 148e of -1 / direction z
        frest   $t_y_9,$det_12                          # 148o
        xor     $control_19,$det_4,$slope_23            # 149e of -1 / direction z
        fi      $t_y,$det_4,$t_y                        # 150e
        fi      $t_y_8,$det_6,$t_y_8                    # 151e
        fi      $t_y_9,$det_12,$t_y_9                   # 152e
        or      $control_19,$control_19,$both_5         # 153e
        fs      $w_2,$w_6,$q_38                         # 154e
        fa      $det_13,$u_5,$v                         # 155e
        or      $control_17,$control_17,$both_5         # 156e
        fnms    $t_e_6,$det_4,$t_y,$k_above_one         # 157e
        fnms    $t_e_2,$det_6,$t_y_8,$k_above_one       # 158e
        fnms    $t_e_7,$det_12,$t_y_9,$k_above_one      # 159e
        or      $control_18,$control_18,$both_5         # 160e
        fa      $det_13,$det_13,$w_2                    # 161e
        fma     $inverse_6,$t_e_6,$t_y,$t_y             # 163e
        fma     $inverse_2,$t_e_2,$t_y_8,$t_y_8         # 164e
        fma     $inverse,$t_e_7,$t_y_9,$t_y_9           # 165e
        xor     $control_20,$det_13,$slope_26           # 167e of -1 / direction z
        frest   $t_y,$det_13                            # 167o
        fm      $u,$u,$inverse_6                        # 169e
        fm      $u_13,$u_13,$inverse_2                  # 170e
        fi      $t_y,$det_13,$t_y                       # 171e
        or      $control_20,$control_20,$both_5         # 172e
        fm      $u_14,$u_14,$inverse                    # 173e
        fm      $v_16,$v_16,$inverse_6                  # 174e
        fm      $v_14,$v_14,$inverse_2                  # 175e
        fm      $v_15,$v_15,$inverse                    # 176e
        fm      $ahead_7,$u,$za                         # 177e
        fnms    $t_e_8,$det_13,$t_y,$k_above_one        # 178e
        fm      $ahead_8,$u_14,$za_9                    # 179e
        fm      $ahead_9,$u_13,$za_8                    # 180e
        fm      $w,$w,$inverse_6                        # 181e
        fm      $w_11,$w_11,$inverse_2                  # 182e
        fma     $ahead_10,$v_16,$zb_10,$ahead_7         # 183e
        fma     $inverse_2,$t_e_8,$t_y,$t_y             # 184e
        fma     $ahead_8,$v_15,$zb_9,$ahead_8           # 185e
        fma     $ahead_11,$v_14,$zb_8,$ahead_9          # 186e
        fm      $w_7,$w_7,$inverse                      # 187e
        or      $outside,$u_14,$v_15                    # 188e
        fma     $ahead_3,$w,$zc_8,$ahead_10             # 189e
        fm      $u_15,$u_5,$inverse_2                   # 190e
        fm      $v,$v,$inverse_2                        # 191e
        fma     $ahead_4,$w_11,$zc_9,$ahead_11          # 192e
        fma     $ahead_8,$w_7,$zc,$ahead_8              # 193e
        fm      $w_2,$w_2,$inverse_2                    # 194e
        fm      $ahead_3,$ahead_3,$slope_23             # 195e
        fm      $ahead_2,$u_15,$za_10                   # 196e
        or      $outside_7,$u_13,$v_14                  # 197e
        fm      $ahead_4,$ahead_4,$slope_24             # 198e
        fm      $ahead_8,$ahead_8,$slope_25             # 199e
        or      $outside,$outside,$w_7                  # 200e
        xor     $t,$ahead_3,$k_sign                     # 201e
        fma     $ahead_12,$v,$zb_11,$ahead_2            # 202e
        or      $outside_8,$u,$v_16                     # 203e
        xor     $t_5,$ahead_4,$k_sign                   # 204e
        or      $outside_8,$outside_8,$w                # 205e
        cgt     $control,$t_best_5,$t_5                 # 206e
        xor     $t_6,$ahead_8,$k_sign                   # 207e
        and     $control,$control,$ahead_4              # 208e
        cgt     $control_21,$t_best_6,$t_6              # 209e
        orc     $outside_8,$outside_8,$control_19       # 210e
        cgt     $control_22,$t_best_7,$t                # 211e
        or      $outside_9,$outside_7,$w_11             # 212e
        and     $control_13,$control_22,$ahead_3        # 213e
        and     $control_21,$control_21,$ahead_8        # 214e
        andc    $control_13,$control_13,$outside_8      # 215e
        fma     $ahead_12,$w_2,$zc_10,$ahead_12         # 216e
        orc     $outside_9,$outside_9,$control_17       # 217e
        rotqbii $control_13,$control_13,1               # 217o
        orc     $outside,$outside,$control_18           # 218e
        andc    $control,$control,$outside_9            # 219e
        andc    $control_21,$control_21,$outside        # 220e
        lnop                                            # 220o pairing
        or      $outside,$u_15,$v                       # 221e
        rotqbii $control,$control,1                     # 221o
        fm      $ahead_12,$ahead_12,$slope_26           # 222e
        rotqbii $control_21,$control_21,1               # 222o
        or      $outside,$outside,$w_2                  # 223e
        gb      $control_23,$control_13                 # 223o
        orc     $outside,$outside,$control_20           # 225e
        gb      $control,$control                       # 225o
        gb      $control_21,$control_21                 # 226o
        shlqbii $control_23,$control_23,4               # 227o
        xor     $t_7,$ahead_12,$k_sign                  # 228e
        shlqbii $control,$control,4                     # 229o
        cgt     $control_24,$t_best_8,$t_7              # 230e
        shlqbii $control_21,$control_21,4               # 230o
        lqx     $control_23,$control_23,$a_controls     # 231o
        and     $control_25,$control_24,$ahead_12       # 232e
        nop     $127                                    # 233e pairing
        lqx     $control,$control,$a_controls           # 233o
        andc    $control_25,$control_25,$outside        # 234e
        lqx     $control_21,$control_21,$a_controls     # 234o
        rotqbii $control_25,$control_25,1               # 236o
        shufb   $t_best,$t_best_7,$t,$control_23        # 237o
        shufb   $nearest,$nearest_10,$object,$control_23 # 238o
        shufb   $t_best_9,$t_best_5,$t_5,$control       # 239o
        shufb   $nearest_13,$nearest_4,$object,$control_21 # 240o
        shufb   $t_best_2,$t_best_6,$t_6,$control_21    # 241o
        gb      $control_25,$control_25                 # 242o
        stqd    $t_best_9,400($a_packet_3)              # 243o
        stqd    $t_best,384($a_packet_3)                # 244o
        stqd    $nearest,448($a_packet_3)               # 245o
        shlqbii $control_25,$control_25,4               # 246o
        shufb   $nearest,$nearest_11,$object,$control   # 247o
        stqd    $nearest_13,480($a_packet_3)            # 248o
        stqd    $t_best_2,416($a_packet_3)              # 249o
        lqx     $control,$control_25,$a_controls        # 250o
        stqd    $nearest,464($a_packet_3)               # 251o
        hbrr    next_triangle_short_back,next_triangle_short # 252o hint
        shufb   $t_best,$t_best_8,$t_7,$control         # 256o
        shufb   $nearest,$nearest_12,$object,$control   # 257o
        stqd    $t_best,432($a_packet_3)                # 260o
        stqd    $nearest,496($a_packet_3)               # 261o
next_triangle_short_back:
        brnz    $count,next_triangle_short              # 262o
        nop     $127                                    # 263e pairing
        bi      $lr                                     # 263o
endfunction isect_triangle_pairs_r16
