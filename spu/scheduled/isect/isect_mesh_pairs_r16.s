# isect_mesh_pairs_r16   nearest hit of packets' rays with runs of a mesh's triangles
#   C       int isect_mesh_pairs_r16(const struct mesh_candidate *, int count,
#                                    const struct mesh_header *);
#   In      $3 candidates of runs of triangles, $4 count (0 is none), $5 the runs' block, in local
#           store and relative to the eye; pointers 16-aligned
#   Out     the candidates' packets: t, object, where a hit has 0 < t < what was there; object is
#           MESH_HIT, plus 128 times the block's number, plus the triangle's index
#           $3 how many triangles were tested with a packet
#   Uses    $2-$79   Saves  -   Stack  0   Calls  -
#   Domain  distances from the origin below 2^60; triangles higher than 2^-50 across the ray; runs
#           of at least one triangle
#   Error   6 ulp of t, 8e-5 in barycentric coordinates; edges from 1/100 of the distance to all of
#           it, area across the ray above 1/20 of their square
#   Twin    lab/twins/src/mesh_pairs.rs
#
# As watertight as isect_triangle_pairs_r16, with the same steps: triangles that share a vertex get
# the same bits for it. The loop goes over triangles, not over runs, so that short runs cost no
# branches. Pipelined, it takes 251 cycles a triangle instead of 281, and 2.8 KB more of local
# store, where the cache loses a block and a half.
# Scheduled by spu schedule from isect_mesh_pairs_r16.s

        .include "work_unit.inc"
        .include "macros.inc"
        .include "pairs.inc"
        .include "triangle_tmpl.inc"

        .set    NEXT,3
        registers a_first                               # candidate
        registers count,a_block
        # constants
        .set    NEXT,10
        registers k_above_one,k_sign,a_controls,m_splat,m_indices,k_step
        # the block
        registers a_vertices,a_faces,hit,both
        # state
        registers a_candidate,a_run
        registers triangles                             # minus those that are left
        registers at                                    # in the run: 4 times the index
        # the candidate
        registers candidate,a_packet,a_shear
        # the triangle
        registers face,index,object,vertex_a,vertex_b,vertex_c
        # temporaries
        registers xa,ya,za,xb,yb,zb,xc,yc,zc,axis,origin,slope
        registers p,q
        registers u,v,w,det,inverse,t_y,t_e,n
        registers outside,seen,t,t_best,nearest,control
        registers ends,more
        .set    ahead,n
        # only before the loop
        .set    sum,p
        .set    header,q
        .set    rest,u

        sign_controls_table .rodata.mesh
vertex_indices:                                         # three bytes to the ends of three words
        .int    0x80808000,0x80808001,0x80808002,0x80808080

function isect_mesh_pairs_r16
        .set count_2,79; .set candidate_2,2; .set triangles_2,79; .set at_2,8; .set t_best_2,33
        .set t_best_3,78; .set t_best_4,31; .set axis_2,2; .set axis_3,4; .set object_2,77
        .set axis_4,5; .set axis_5,37; .set axis_6,32; .set axis_7,21; .set vertex_b_2,6
        .set vertex_c_2,36; .set vertex_a_2,35; .set origin_2,34; .set vertex_b_3,27
        .set origin_3,29; .set origin_4,6; .set origin_5,46; .set axis_8,30; .set xb_2,52
        .set zb_2,69; .set zc_2,7; .set axis_9,8; .set axis_10,41; .set za_2,45; .set zc_3,5
        .set yc_2,49; .set ya_2,51; .set origin_6,54; .set xc_2,70; .set origin_7,57; .set yc_3,68
        .set ya_3,38; .set origin_8,7; .set origin_9,62; .set za_3,40; .set zc_4,47; .set zb_3,32
        .set ya_4,9; .set zc_5,56; .set zb_4,6; .set ya_5,61; .set xc_3,9; .set xb_3,55
        .set slope_2,74; .set yc_4,24; .set za_4,72; .set zc_6,8; .set xb_4,53; .set xc_4,28
        .set yc_5,43; .set yb_2,4; .set slope_3,66; .set slope_4,75; .set yb_3,29; .set xa_2,2
        .set za_5,34; .set xa_3,59; .set xb_5,4; .set yb_4,73; .set slope_5,30; .set slope_6,49
        .set xa_4,72; .set xb_6,42; .set axis_11,56; .set origin_10,48; .set xc_5,50; .set za_6,52
        .set ya_6,54; .set zc_7,65; .set yc_6,67; .set zb_5,41; .set xb_7,44; .set sum_2,36
        .set slope_7,55; .set xa_5,57; .set slope_8,64; .set sum_3,58; .set yb_5,63; .set xa_6,21
        .set sum_4,27; .set sum_5,35; .set header_2,60; .set yb_6,30; .set slope_9,62
        .set rest_2,66; .set slope_10,70; .set sum_6,72; .set slope_11,73; .set v_2,43
        .set slope_12,36; .set xa_7,26; .set a_packet_2,76; .set sum_7,49; .set rest_3,59
        .set sum_8,74; .set sum_9,75; .set header_3,58; .set header_4,27; .set v_3,39
        .set header_5,9; .set header_6,35; .set v_4,49; .set sum_10,68; .set header_7,24
        .set zb_6,71; .set header_8,29; .set za_7,48; .set xb_8,2; .set ya_7,41; .set rest_4,28
        .set v_5,27; .set rest_5,43; .set w_2,4; .set v_6,9; .set ya_8,39; .set w_3,38; .set w_4,53
        .set header_9,26; .set header_10,30; .set v_7,35; .set rest_6,37; .set rest_7,24
        .set xa_8,7; .set det_2,21; .set det_3,28; .set w_5,29; .set w_6,26; .set det_4,38
        .set sum_11,55; .set header_11,59; .set sum_12,42; .set t_y_2,41; .set rest_8,50
        .set t_y_3,46; .set seen_2,44; .set seen_3,52; .set t_y_4,51; .set header_12,7; .set w_7,2
        .set rest_9,30; .set t_y_5,42; .set seen_4,51; .set det_5,7; .set t_e_2,21; .set t_e_3,28
        .set inverse_2,38; .set seen_5,39; .set seen_6,41; .set inverse_3,21; .set inverse_4,28
        .set rest_10,42; .set t_y_6,38; .set seen_7,43; .set ahead_2,42; .set ahead_3,40
        .set ahead_4,34; .set t_e_4,7; .set ahead_5,21; .set ahead_6,27; .set ahead_7,6
        .set outside_2,4; .set ahead_8,5; .set ahead_9,7; .set v_8,38; .set w_8,21; .set ahead_10,8
        .set ahead_11,30; .set outside_3,2; .set outside_4,5; .set outside_5,7; .set t_2,79
        .set outside_6,29; .set outside_7,9; .set t_3,34; .set control_2,2; .set nearest_2,4
        .set nearest_3,5; .set control_3,6; .set nearest_4,7; .set t_4,8; .set control_4,9
        .set axis_12,24; .set axis_13,6; .set axis_14,31; .set axis_15,33; .set origin_11,37
        .set origin_12,38; .set xa_9,39; .set origin_13,61; .set xc_6,41; .set zb_7,24
        .set ya_9,69; .set xb_9,24; .set yb_7,33; .set zc_8,2; .set ya_10,33; .set yc_7,30
        .set xa_10,46; .set ya_11,27; .set slope_13,33; .set xa_11,31; .set zc_9,35; .set xc_7,21
        .set zc_10,52; .set zc_11,54; .set sum_13,4; .set xc_8,2; .set xa_12,8; .set zc_12,9
        .set sum_14,31; .set ya_12,5; .set xa_13,35; .set sum_15,38; .set sum_16,44; .set yb_8,47
        .set rest_11,31; .set rest_12,57; .set v_9,59; .set header_13,21; .set sum_17,62
        .set sum_18,63; .set v_10,21; .set sum_19,64; .set rest_13,7; .set w_9,5; .set header_14,4
        .set header_15,31; .set rest_14,41; .set header_16,2; .set header_17,33; .set v_11,8
        .set w_10,36; .set v_12,30; .set w_11,24; .set v_13,2; .set w_12,8; .set rest_15,4
        .set det_6,30; .set det_7,33; .set det_8,35; .set slope_14,26; .set seen_8,37
        .set t_e_5,30; .set t_e_6,35; .set inverse_5,30; .set inverse_6,35; .set ahead_12,41
        .set ahead_13,2; .set control_5,4; .set control_6,10; .set nearest_5,13; .set outside_8,14
        .set nearest_6,15; .set control_7,8; .set t_best_5,4; .set at_3,2; .set t_best_6,5
        .set t_best_7,6; .set axis_16,7; .set axis_17,9; .set axis_18,23; .set origin_14,24
        .set origin_15,30; .set origin_16,33; .set vertex_b_4,34; .set axis_19,35
        .set origin_17,36; .set axis_20,38; .set slope_15,39; .set origin_18,40; .set zc_13,45
        .set zc_14,46; .set xb_10,47; .set zb_8,48; .set xb_11,49; .set xb_12,51; .set yb_9,52
        .set zb_9,53; .set slope_16,54; .set zb_10,55; .set vertex_a_3,27; .set xc_9,56
        .set yb_10,57; .set slope_17,60; .set yc_8,62; .set yc_9,63; .set za_8,8; .set ya_13,64
        .set za_9,9; .set ya_14,65; .set xa_14,36; .set xc_10,38; .set xa_15,56; .set za_10,21
        .set axis_21,65; .set xa_16,29; .set ya_15,7; .set slope_18,56; .set origin_19,66
        .set xc_11,37; .set yb_11,42; .set xa_17,23; .set axis_22,39; .set yc_10,31; .set ya_16,43
        .set origin_20,52; .set axis_23,64; .set zc_15,67; .set ya_17,40; .set yb_12,66
        .set slope_19,68; .set xc_12,69; .set yb_13,35; .set za_11,70; .set sum_20,71
        .set xb_13,72; .set yc_11,32; .set yb_14,24; .set zb_11,34; .set origin_21,39
        .set xa_18,27; .set zb_12,30; .set slope_20,34; .set xc_13,64; .set sum_21,65
        .set nearest_7,69; .set nearest_8,70; .set sum_22,73; .set nearest_9,56; .set header_18,74
        .set rest_16,65; .set v_14,75; .set sum_23,52; .set sum_24,76; .set sum_25,77
        .set header_19,78; .set header_20,63; .set header_21,77; .set rest_17,38; .set header_22,57
        .set sum_26,79; .set xb_14,63; .set ya_18,37; .set header_23,40; .set v_15,23; .set v_16,31
        .set sum_27,33; .set sum_28,39; .set w_13,7; .set v_17,40; .set header_24,43; .set det_9,36
        .set v_18,32; .set det_10,51; .set rest_18,33; .set w_14,37; .set det_11,43; .set seen_9,29
        .set t_y_7,33; .set seen_10,54; .set det_12,57; .set w_15,27; .set t_y_8,37; .set t_e_7,50
        .set t_e_8,36; .set det_13,54; .set object_3,28; .set t_e_9,43; .set inverse_7,50
        .set inverse_8,33; .set seen_11,36; .set inverse_9,37; .set t_e_10,54; .set ahead_14,9
        .set ahead_15,32; .set t_5,30; .set control_8,32; .set t_6,27; .set control_9,29
        .set control_10,7; .set t_7,9; .set control_11,21; .set nearest_10,2
        ori     $a_candidate,$a_first,0                 # 0e
        ori     $a_run,$a_first,0                       # 1e
        il      $a_first,0                              # 2e
        biz     $count,$lr                              # 2o
        clgti   $count_2,$count,1                       # 3e at least as many passes as overlap
        brz     $count_2,next_run_short                 # 5o too few passes
        ai      $count,$count,-1                        # 6e
        lqd     $candidate_2,0($a_run)                  # 6o
        ai      $a_run,$a_run,16                        # 7e
        hbrr    next_run_back,next_run                  # 7o hint
next_run:
            rotmi   $candidate,$candidate_2,-16         # 1e
        lqd     $candidate_2,0($a_run)                  # 1o
        ai      $a_run,$a_run,16                        # 2e
        ai      $count,$count,-1                        # 3e
            a       $a_first,$a_first,$candidate        # 5e
next_run_back:
        brnz    $count,next_run                         # 5o
next_run_drain:
        rotmi   $candidate,$candidate_2,-16             # 0e
        a       $a_first,$a_first,$candidate            # 4e
isect_mesh_pairs_r16_block:
        ilhu    $k_sign,0x8000                          # 0e
        lqd     $header,0($a_block)                     # 0o
        ori     $triangles,$a_first,0                   # 1e
        lqd     $rest,16($a_block)                      # 1o
        ila     $m_splat,0x10203                        # 2e
        lqa     $m_indices,vertex_indices               # 2o
        ilhu    $k_above_one,0x3f80                     # 3e
        clgti   $triangles_2,$triangles,1               # 4e at least as many passes as overlap
        iohl    $k_above_one,2                          # 5e
        lnop                                            # 5o pairing
        ila     $a_controls,sign_controls               # 6e
        rotqbyi $hit,$header,4                          # 6o
        mpyi    $a_vertices,$rest,112                   # 7e
        rotqbyi $both,$rest,12                          # 7o
        il      $k_step,16                              # 8e
        rotqbyi $a_faces,$rest,8                        # 8o
        il      $at,0                                   # 9e
        shli    $hit,$hit,7                             # 10e
        shli    $both,$both,1                           # 11e SIDES_BOTH to the sign
        shli    $a_faces,$a_faces,4                     # 12e
        a       $a_vertices,$a_vertices,$a_block        # 14e
        lnop                                            # 14o pairing
        or      $hit,$hit,$k_sign                       # 15e
        shufb   $both,$both,$both,$m_splat              # 15o
        ai      $a_vertices,$a_vertices,32              # 16e
        shufb   $hit,$hit,$hit,$m_splat                 # 17o
        a       $a_faces,$a_faces,$a_vertices           # 18e
        brz     $triangles_2,next_triangle_short        # 18o too few passes
        ai      $at_2,$at,4                             # 19e
        lqd     $candidate,0($a_candidate)              # 19o
        ai      $triangles,$triangles,-1                # 20e
        lnop                                            # 20o pairing
        andi    $index,$candidate,511                   # 25e 4 times it
        rotqbyi $a_shear,$candidate,8                   # 25o
        nop     $127                                    # 26e pairing
        rotqmbyi $ends,$candidate,-1                    # 26o 4 times the run's length
        a       $index,$index,$at                       # 27e
        rotqbyi $a_packet,$candidate,4                  # 27o
        a       $vertex_a,$a_faces,$index               # 29e
        lqx     $face,$a_faces,$index                   # 29o
        lqd     $a_shear,192($a_shear)                  # 30o
        rotqmbii $index,$index,-2                       # 31o
        rotqmbii $ends,$ends,-6                         # 32o
        lqd     $t_best_2,400($a_packet)                # 33o
        lqd     $t_best_3,384($a_packet)                # 34o
        rotqby  $face,$face,$vertex_a                   # 35o
        cgt     $more,$ends,$at_2                       # 36e
        rotqbyi $a_shear,$a_shear,8                     # 36o
        nop     $127                                    # 37e pairing
        lqd     $t_best_4,416($a_packet)                # 37o
        andc    $ends,$k_step,$more                     # 38e
        shufb   $index,$index,$index,$m_splat           # 38o
        and     $at,$at_2,$more                         # 39e
        shufb   $face,$face,$face,$m_indices            # 39o
        a       $a_candidate,$a_candidate,$ends         # 40e
        lqd     $axis_2,0($a_shear)                     # 40o
        nop     $127                                    # 41e pairing
        lqd     $axis_3,64($a_shear)                    # 41o
        or      $object_2,$index,$hit                   # 42e
        lqd     $axis_4,128($a_shear)                   # 42o
        shlqbii $face,$face,4                           # 43o
        lqd     $axis_5,80($a_shear)                    # 44o
        lqd     $axis_6,144($a_shear)                   # 45o
        lqd     $axis_7,16($a_shear)                    # 46o
        rotqbyi $vertex_b_2,$face,4                     # 47o
        rotqbyi $vertex_c_2,$face,8                     # 48o
        lqx     $vertex_a_2,$a_vertices,$face           # 49o
        lqd     $origin_2,320($a_shear)                 # 50o
        lqx     $vertex_b_3,$a_vertices,$vertex_b_2     # 51o
        lqx     $vertex_c_2,$a_vertices,$vertex_c_2     # 52o
        lqd     $origin_3,256($a_shear)                 # 53o
        lqd     $origin_4,336($a_shear)                 # 54o
        lqd     $origin_5,272($a_shear)                 # 55o
        lqd     $axis_8,96($a_shear)                    # 56o
        shufb   $xb_2,$vertex_b_3,$vertex_b_3,$axis_2   # 57o
        shufb   $zb_2,$vertex_b_3,$vertex_b_3,$axis_4   # 58o
        shufb   $zc_2,$vertex_c_2,$vertex_c_2,$axis_4   # 59o
        lqd     $axis_9,160($a_shear)                   # 60o
        nop     $127                                    # 61e pairing
        lqd     $axis_10,32($a_shear)                   # 61o
        fs      $zb_2,$zb_2,$origin_2                   # 62e
        shufb   $za_2,$vertex_a_2,$vertex_a_2,$axis_4   # 62o
        fs      $zc_3,$zc_2,$origin_2                   # 63e
        shufb   $yc_2,$vertex_c_2,$vertex_c_2,$axis_3   # 63o
        shufb   $ya_2,$vertex_a_2,$vertex_a_2,$axis_3   # 64o
        lqd     $origin_6,192($a_shear)                 # 65o
        fs      $za_2,$za_2,$origin_2                   # 66e
        shufb   $xc_2,$vertex_c_2,$vertex_c_2,$axis_2   # 66o
        fs      $yc_2,$yc_2,$origin_3                   # 67e
        lqd     $origin_7,208($a_shear)                 # 67o
        fs      $ya_2,$ya_2,$origin_3                   # 68e
        shufb   $yc_3,$vertex_c_2,$vertex_c_2,$axis_5   # 68o
        shufb   $ya_3,$vertex_a_2,$vertex_a_2,$axis_5   # 69o
        lqd     $origin_8,224($a_shear)                 # 70o
        fs      $xc_2,$xc_2,$origin_6                   # 71e
        lqd     $origin_9,288($a_shear)                 # 71o
        fs      $xb_2,$xb_2,$origin_6                   # 72e
        shufb   $za_3,$vertex_a_2,$vertex_a_2,$axis_6   # 72o
        fs      $ya_3,$ya_3,$origin_5                   # 73e
        shufb   $zc_4,$vertex_c_2,$vertex_c_2,$axis_6   # 73o
        fs      $yc_3,$yc_3,$origin_5                   # 74e
        shufb   $zb_3,$vertex_b_3,$vertex_b_3,$axis_6   # 74o
        nop     $127                                    # 75e pairing
        shufb   $ya_4,$vertex_a_2,$vertex_a_2,$axis_8   # 75o
        fs      $za_3,$za_3,$origin_4                   # 76e
        lqd     $origin_2,352($a_shear)                 # 76o
        fs      $zc_4,$zc_4,$origin_4                   # 77e
        shufb   $zc_5,$vertex_c_2,$vertex_c_2,$axis_9   # 77o
        fs      $zb_3,$zb_3,$origin_4                   # 78e
        shufb   $zb_4,$vertex_b_3,$vertex_b_3,$axis_9   # 78o
        fs      $ya_5,$ya_4,$origin_9                   # 79e
        shufb   $xc_3,$vertex_c_2,$vertex_c_2,$axis_7   # 79o
        shufb   $xb_3,$vertex_b_3,$vertex_b_3,$axis_7   # 80o
        lqd     $slope_2,448($a_shear)                  # 81o
        fs      $zb_4,$zb_4,$origin_2                   # 82e
        shufb   $yc_4,$vertex_c_2,$vertex_c_2,$axis_8   # 82o
        fs      $xc_3,$xc_3,$origin_7                   # 83e
        shufb   $za_4,$vertex_a_2,$vertex_a_2,$axis_9   # 83o
        fs      $xb_3,$xb_3,$origin_7                   # 84e
        lqd     $slope,384($a_shear)                    # 84o
        fs      $zc_6,$zc_5,$origin_2                   # 85e
        shufb   $xb_4,$vertex_b_3,$vertex_b_3,$axis_10  # 85o
        fs      $yc_4,$yc_4,$origin_9                   # 86e
        shufb   $xc_4,$vertex_c_2,$vertex_c_2,$axis_10  # 86o
        fnms    $yc_5,$slope_2,$zc_3,$yc_2              # 87e
        shufb   $yb_2,$vertex_b_3,$vertex_b_3,$axis_3   # 87o
        fnms    $ya_2,$slope_2,$za_2,$ya_2              # 88e
        lqd     $slope_3,400($a_shear)                  # 88o
        fs      $xb_4,$xb_4,$origin_8                   # 89e
        shufb   $yb,$vertex_b_3,$vertex_b_3,$axis_5     # 89o
        fs      $xc_4,$xc_4,$origin_8                   # 90e
        lqd     $slope_4,464($a_shear)                  # 90o
        fs      $yb_3,$yb_2,$origin_3                   # 91e
        shufb   $xa_2,$vertex_a_2,$vertex_a_2,$axis_2   # 91o
        fs      $za_5,$za_4,$origin_2                   # 92e
        shufb   $xa_3,$vertex_a_2,$vertex_a_2,$axis_10  # 92o
        fnms    $xb_5,$slope,$zb_2,$xb_2                # 93e
        shufb   $yb_4,$vertex_b_3,$vertex_b_3,$axis_8   # 93o
        fs      $yb,$yb,$origin_5                       # 94e
        lqd     $slope_5,480($a_shear)                  # 94o
        fs      $xa_2,$xa_2,$origin_6                   # 95e
        lqd     $slope_6,416($a_shear)                  # 95o
        fnms    $xc,$slope,$zc_3,$xc_2                  # 96e
        shufb   $xa_4,$vertex_a_2,$vertex_a_2,$axis_7   # 96o
        fnms    $xb_6,$slope_3,$zb_3,$xb_3              # 97e
        lqd     $axis_7,48($a_shear)                    # 97o
        fnms    $ya_3,$slope_4,$za_3,$ya_3              # 98e
        lqd     $axis_10,176($a_shear)                  # 98o
        fnms    $xc_3,$slope_3,$zc_4,$xc_3              # 99e
        lqd     $axis_11,112($a_shear)                  # 99o
        fs      $xa_4,$xa_4,$origin_7                   # 100e
        lqd     $origin_5,304($a_shear)                 # 100o
        fs      $xa_3,$xa_3,$origin_8                   # 101e
        lqd     $origin_8,240($a_shear)                 # 101o
        fnms    $yc_3,$slope_4,$zc_4,$yc_3              # 102e
        lqd     $origin_10,368($a_shear)                # 102o
        fnms    $xc_4,$slope_6,$zc_6,$xc_4              # 103e
        shufb   $xc_5,$vertex_c_2,$vertex_c_2,$axis_7   # 103o
        fnms    $xb_4,$slope_6,$zb_4,$xb_4              # 104e
        shufb   $za_6,$vertex_a_2,$vertex_a_2,$axis_10  # 104o
        fnms    $yc_4,$slope_5,$zc_6,$yc_4              # 105e
        shufb   $ya_6,$vertex_a_2,$vertex_a_2,$axis_11  # 105o
        fnms    $ya_5,$slope_5,$za_5,$ya_5              # 106e
        shufb   $zc_7,$vertex_c_2,$vertex_c_2,$axis_10  # 106o
        fnms    $yb_3,$slope_2,$zb_2,$yb_3              # 107e
        shufb   $yc_6,$vertex_c_2,$vertex_c_2,$axis_11  # 107o
        fs      $yb_4,$yb_4,$origin_9                   # 108e
        shufb   $zb_5,$vertex_b_3,$vertex_b_3,$axis_10  # 108o
        fnms    $xa_2,$slope,$za_2,$xa_2                # 109e
        shufb   $xb_7,$vertex_b_3,$vertex_b_3,$axis_7   # 109o
        fm      $sum_2,$yc_5,$xb_5                      # 110e
        lqd     $slope_7,496($a_shear)                  # 110o
        fnms    $xa_5,$slope_3,$za_3,$xa_4              # 111e
        lqd     $slope_8,432($a_shear)                  # 111o
        fm      $sum_3,$yc_3,$xb_6                      # 112e
        shufb   $yb_5,$vertex_b_3,$vertex_b_3,$axis_11  # 112o
        fnms    $yb,$slope_4,$zb_3,$yb                  # 113e
        shufb   $xa_6,$vertex_a_2,$vertex_a_2,$axis_7   # 113o
        fm      $sum_4,$ya_2,$xc                        # 114e
        shlqbyi $zc_3,$zc_3,0                           # 114o copy
        fm      $sum_5,$ya_3,$xc_3                      # 115e
        shlqbyi $zc_4,$zc_4,0                           # 115o copy
        fms     $header_2,$yc_5,$xb_5,$sum_2            # 116e
        shlqbyi $zc_6,$zc_6,0                           # 116o copy
        fnms    $yb_6,$slope_5,$zb_4,$yb_4              # 117e
        lqd     $slope_9,512($a_shear)                  # 117o
        fms     $rest_2,$xc,$yb_3,$sum_2                # 118e
        lqd     $slope_10,528($a_shear)                 # 118o
        fm      $sum_6,$yc_4,$xb_4                      # 119e
        lqd     $slope_11,544($a_shear)                 # 119o
        fms     $v_2,$xa_2,$yc_5,$sum_4                 # 120e
        lqd     $slope_12,560($a_shear)                 # 120o
        fnms    $xa_7,$slope_6,$za_5,$xa_3              # 121e
        shlqbyi $a_packet_2,$a_packet,0                 # 121o copy
        fm      $sum_7,$ya_5,$xc_4                      # 122e
        fms     $rest_3,$xc_3,$yb,$sum_3                # 123e
        fm      $sum_8,$yb_3,$xa_2                      # 124e
        fm      $sum_9,$yb,$xa_5                        # 125e
        fms     $header_3,$yc_3,$xb_6,$sum_3            # 126e
        fms     $header_4,$ya_2,$xc,$sum_4              # 127e
        fs      $xc_5,$xc_5,$origin_8                   # 128e
        fms     $v_3,$xa_5,$yc_3,$sum_5                 # 129e
        fms     $header_5,$ya_3,$xc_3,$sum_5            # 130e
        fms     $header_6,$ya_5,$xc_4,$sum_7            # 131e
        fms     $v_4,$xa_7,$yc_4,$sum_7                 # 132e
        fs      $zc_7,$zc_7,$origin_10                  # 133e
        fs      $yc_6,$yc_6,$origin_5                   # 134e
        fm      $sum_10,$yb_6,$xa_7                     # 135e
        fms     $header_7,$yc_4,$xb_4,$sum_6            # 136e
        fs      $zb_6,$zb_5,$origin_10                  # 137e
        fms     $header_8,$yb_3,$xa_2,$sum_8            # 138e
        lnop                                            # 138o pairing
        fs      $za_7,$za_6,$origin_10                  # 139e
        shlqbyi $zc_5,$zc_7,0                           # 139o copy
        fs      $xb_8,$xb_7,$origin_8                   # 140e
        fs      $ya_7,$ya_6,$origin_5                   # 141e
        fms     $rest_4,$xc_4,$yb_6,$sum_6              # 142e
        fs      $v_5,$v_2,$header_4                     # 143e
        fs      $rest_5,$rest_2,$header_2               # 144e
        fms     $w_2,$xb_5,$ya_2,$sum_8                 # 145e
        fs      $v_6,$v_3,$header_5                     # 146e
        fnms    $ya_8,$slope_7,$za_7,$ya_7              # 147e
        fms     $w_3,$xb_6,$ya_3,$sum_9                 # 148e
        fms     $w_4,$xb_4,$ya_5,$sum_10                # 149e
        fms     $header_9,$yb_6,$xa_7,$sum_10           # 150e
        fms     $header_10,$yb,$xa_5,$sum_9             # 151e
        fs      $v_7,$v_4,$header_6                     # 152e
        fs      $rest_6,$rest_3,$header_3               # 153e
        fnms    $yc_6,$slope_7,$zc_7,$yc_6              # 154e
        fnms    $xb_8,$slope_8,$zb_6,$xb_8              # 155e
        fs      $rest_7,$rest_4,$header_7               # 156e
        fs      $xa_8,$xa_6,$origin_8                   # 157e
        fs      $yb_5,$yb_5,$origin_5                   # 158e
        fnms    $xc_5,$slope_8,$zc_7,$xc_5              # 159e
        fa      $det_2,$rest_5,$v_5                     # 160e
        fs      $w_2,$w_2,$header_8                     # 161e
        fa      $det_3,$rest_6,$v_6                     # 162e
        fs      $w_5,$w_3,$header_10                    # 163e
        fnms    $yb_6,$slope_7,$zb_6,$yb_5              # 164e
        fnms    $xa_8,$slope_8,$za_7,$xa_8              # 165e
        fm      $sum_7,$ya_8,$xc_5                      # 166e
        fs      $w_6,$w_4,$header_9                     # 167e
        fa      $det_4,$rest_7,$v_7                     # 168e
        fa      $det_2,$det_2,$w_2                      # 169e
        fm      $sum_11,$yc_6,$xb_8                     # 170e
        fa      $det_3,$det_3,$w_5                      # 171e
        fms     $header_11,$ya_8,$xc_5,$sum_7           # 172e
        fms     $v_4,$xa_8,$yc_6,$sum_7                 # 173e
        fa      $det_4,$det_4,$w_6                      # 174e
        lnop                                            # 174o pairing
        fm      $sum_12,$yb_6,$xa_8                     # 175e
        frest   $t_y_2,$det_2                           # 175o
        fms     $header_3,$yc_6,$xb_8,$sum_11           # 176e
        lnop                                            # 176o pairing
        fms     $rest_8,$xc_5,$yb_6,$sum_11             # 177e
        frest   $t_y_3,$det_3                           # 177o
        xor     $seen_2,$det_2,$slope_9                 # 178e of -1 / direction z
        fi      $t_y_2,$det_2,$t_y_2                    # 179e
        xor     $seen_3,$det_3,$slope_10                # 180e of -1 / direction z
        frest   $t_y_4,$det_4                           # 180o
        fs      $v_4,$v_4,$header_11                    # 181e
        fms     $header_12,$yb_6,$xa_8,$sum_12          # 182e
        fms     $w_7,$xb_8,$ya_8,$sum_12                # 183e
        fs      $rest_9,$rest_8,$header_3               # 184e
        fi      $t_y_3,$det_3,$t_y_3                    # 185e
        fi      $t_y_5,$det_4,$t_y_4                    # 186e
        xor     $seen_4,$det_4,$slope_11                # 187e of -1 / direction z
        fnms    $t_e,$det_2,$t_y_2,$k_above_one         # 188e
        fs      $w_7,$w_7,$header_12                    # 189e
        fa      $det_5,$rest_9,$v_4                     # 190e
        or      $seen_4,$seen_4,$both                   # 191e
        fnms    $t_e_2,$det_3,$t_y_3,$k_above_one       # 192e
        fnms    $t_e_3,$det_4,$t_y_5,$k_above_one       # 193e
        fma     $inverse_2,$t_e,$t_y_2,$t_y_2           # 194e
        or      $seen_5,$seen_3,$both                   # 195e
        fa      $det_5,$det_5,$w_7                      # 196e
        or      $seen_6,$seen_2,$both                   # 197e
        fma     $inverse_3,$t_e_2,$t_y_3,$t_y_3         # 198e
        fma     $inverse_4,$t_e_3,$t_y_5,$t_y_5         # 199e
        fm      $rest_10,$rest_5,$inverse_2             # 200e
        fm      $v_5,$v_5,$inverse_2                    # 201e
        lnop                                            # 201o pairing
        fm      $w_2,$w_2,$inverse_2                    # 202e
        frest   $t_y_6,$det_5                           # 202o
        xor     $seen_7,$det_5,$slope_12                # 203e of -1 / direction z
        fm      $rest_6,$rest_6,$inverse_3              # 204e
        fm      $rest_7,$rest_7,$inverse_4              # 205e
        fi      $t_y_6,$det_5,$t_y_6                    # 206e
        or      $outside,$rest_10,$v_5                  # 207e
        fm      $ahead_2,$rest_10,$za_2                 # 208e
        fm      $v_6,$v_6,$inverse_3                    # 209e
        fm      $ahead_3,$rest_6,$za_3                  # 210e
        fm      $ahead_4,$rest_7,$za_5                  # 211e
        fm      $v_7,$v_7,$inverse_4                    # 212e
        fnms    $t_e_4,$det_5,$t_y_6,$k_above_one       # 213e
        fm      $w_5,$w_5,$inverse_3                    # 214e
        fma     $ahead_5,$v_5,$zb_2,$ahead_2            # 215e
        fm      $w_6,$w_6,$inverse_4                    # 216e
        fma     $ahead_6,$v_6,$zb_3,$ahead_3            # 217e
        fma     $ahead_7,$v_7,$zb_4,$ahead_4            # 218e
        fma     $inverse_4,$t_e_4,$t_y_6,$t_y_6         # 219e
        or      $outside,$outside,$w_2                  # 220e
        fma     $ahead,$w_2,$zc_3,$ahead_5              # 221e
        or      $outside_2,$rest_6,$v_6                 # 222e
        fma     $ahead_8,$w_5,$zc_4,$ahead_6            # 223e
        fma     $ahead_9,$w_6,$zc_6,$ahead_7            # 224e
        fm      $rest,$rest_9,$inverse_4                # 225e
        fm      $v_8,$v_4,$inverse_4                    # 226e
        fm      $ahead,$ahead,$slope_9                  # 227e
        fm      $w_8,$w_7,$inverse_4                    # 228e
        fm      $ahead_7,$ahead_8,$slope_10             # 229e
        fm      $ahead_10,$ahead_9,$slope_11            # 230e
        fm      $ahead_11,$rest,$za_7                   # 231e
        or      $outside_3,$rest,$v_8                   # 232e
        orc     $outside,$outside,$seen_6               # 233e
        or      $outside_2,$outside_2,$w_5              # 234e
        or      $outside_4,$rest_7,$v_7                 # 235e
        orc     $outside_5,$outside_2,$seen_5           # 236e
        xor     $t_2,$ahead,$k_sign                     # 237e
        or      $seen_5,$seen_7,$both                   # 238e
        cgt     $control,$t_best_3,$t_2                 # 239e
        or      $outside_6,$outside_4,$w_6              # 240e
        or      $outside_7,$outside_3,$w_8              # 241e
        xor     $t_3,$ahead_7,$k_sign                   # 242e
next_triangle:
            and     $control,$control,$ahead            # 0e
        lqd     $candidate,0($a_candidate)              # 0o
            cgt     $control_2,$t_best_2,$t_3           # 1e
            lqd     $nearest,464($a_packet)             # 1o
            xor     $t,$ahead_10,$k_sign                # 2e
            lqd     $nearest_2,480($a_packet)           # 2o
            and     $control_2,$control_2,$ahead_7      # 3e
            lqd     $nearest_3,496($a_packet)           # 3o
            cgt     $control_3,$t_best_4,$t             # 4e
            lqd     $t_best,432($a_packet)              # 4o
            andc    $control_2,$control_2,$outside_5    # 5e
            lqd     $nearest_4,448($a_packet)           # 5o
            and     $control_3,$control_3,$ahead_10     # 6e
        rotqbyi $a_shear,$candidate,8                   # 6o
            andc    $control,$control,$outside          # 7e
            rotqbii $control_2,$control_2,1             # 7o
        andi    $index,$candidate,511                   # 8e 4 times it
        rotqmbyi $ends,$candidate,-1                    # 8o 4 times the run's length
            orc     $outside,$outside_7,$seen_5         # 9e
            rotqbii $control,$control,1                 # 9o
        a       $index,$index,$at                       # 10e
        rotqbyi $a_packet,$candidate,4                  # 10o
            fma     $ahead,$v_8,$zb_6,$ahead_11         # 11e
            lnop                                        # 11o pairing
        a       $vertex_a,$a_faces,$index               # 12e
        lqx     $face,$a_faces,$index                   # 12o
        ai      $triangles,$triangles,-1                # 13e
            gb      $control,$control                   # 13o
        ai      $at_2,$at,4                             # 14e
        rotqmbii $index,$index,-2                       # 14o
            orc     $outside_7,$outside_6,$seen_4       # 15e
        rotqmbii $ends,$ends,-6                         # 15o
        nop     $127                                    # 16e pairing
        lqd     $a_shear,192($a_shear)                  # 16o
            andc    $control_3,$control_3,$outside_7    # 17e
            shlqbii $control,$control,4                 # 17o
            fma     $ahead,$w_8,$zc_5,$ahead            # 18e
        rotqby  $face,$face,$vertex_a                   # 18o
        cgt     $more,$ends,$at_2                       # 19e
            rotqbii $control_3,$control_3,1             # 19o
            nop     $127                                # 20e pairing
            gb      $control_2,$control_2               # 20o
        andc    $ends,$k_step,$more                     # 21e
        shufb   $index,$index,$index,$m_splat           # 21o
        and     $at,$at_2,$more                         # 22e
        rotqbyi $a_shear,$a_shear,8                     # 22o
        a       $a_candidate,$a_candidate,$ends         # 23e
        lnop                                            # 23o pairing
            fm      $ahead,$ahead,$slope_12             # 24e
            gb      $control_3,$control_3               # 24o
        shufb   $face,$face,$face,$m_indices            # 25o
        lqd     $slope,384($a_shear)                    # 26o
            shlqbii $control_3,$control_3,4             # 28o
            shlqbii $control_2,$control_2,4             # 29o
            xor     $t_4,$ahead,$k_sign                 # 30e
        lqd     $origin,304($a_shear)                   # 30o
        nop     $127                                    # 31e pairing
        lqd     $axis,48($a_shear)                      # 31o
            cgt     $control_4,$t_best,$t_4             # 32e
            lqx     $control_3,$control_3,$a_controls   # 32o
            nop     $127                                # 33e pairing
            lqx     $control_2,$control_2,$a_controls   # 33o
            and     $control_4,$control_4,$ahead        # 34e
        lqd     $axis_7,16($a_shear)                    # 34o
        nop     $127                                    # 35e pairing
        lqd     $axis_12,176($a_shear)                  # 35o
            andc    $control_4,$control_4,$outside      # 36e
        lqd     $origin_3,256($a_shear)                 # 36o
        lqd     $axis_8,96($a_shear)                    # 37o
            shufb   $t_best_4,$t_best_4,$t,$control_3   # 38o
            shufb   $nearest_2,$nearest_2,$object_2,$control_3 # 39o
        lqd     $axis_13,160($a_shear)                  # 40o
        lqd     $axis_6,144($a_shear)                   # 41o
            stqd    $t_best_4,416($a_packet_2)          # 42o
            shufb   $t_best_4,$t_best_2,$t_3,$control_2 # 43o
            shufb   $nearest,$nearest,$object_2,$control_2 # 44o
        lqd     $axis_2,128($a_shear)                   # 45o
        shlqbii $face,$face,4                           # 46o
            stqd    $t_best_4,400($a_packet_2)          # 47o
            stqd    $nearest,464($a_packet_2)           # 48o
        lqd     $axis_14,0($a_shear)                    # 49o
            rotqbii $control_4,$control_4,1             # 50o
        lqd     $axis_15,64($a_shear)                   # 51o
        lqd     $origin_2,320($a_shear)                 # 52o
        lqx     $vertex_a_2,$a_vertices,$face           # 53o
        rotqbyi $vertex_c_2,$face,8                     # 54o
        lqd     $origin_11,336($a_shear)                # 55o
        rotqbyi $vertex_b_3,$face,4                     # 56o
        lqd     $origin_12,240($a_shear)                # 57o
        lqx     $vertex_c_2,$a_vertices,$vertex_c_2     # 58o
        shufb   $xa_9,$vertex_a_2,$vertex_a_2,$axis     # 59o
        shufb   $za_3,$vertex_a_2,$vertex_a_2,$axis_6   # 60o
        lqd     $axis_10,32($a_shear)                   # 61o
        lqx     $vertex_b_3,$a_vertices,$vertex_b_3     # 62o
        nop     $127                                    # 63e pairing
        shufb   $za_2,$vertex_a_2,$vertex_a_2,$axis_2   # 63o
        fs      $xa_9,$xa_9,$origin_12                  # 64e
        lqd     $origin_5,224($a_shear)                 # 64o
        fs      $za_3,$za_3,$origin_11                  # 65e
        shufb   $zc_4,$vertex_c_2,$vertex_c_2,$axis_6   # 65o
        nop     $127                                    # 66e pairing
        shufb   $za_7,$vertex_a_2,$vertex_a_2,$axis_12  # 66o
        fs      $za_2,$za_2,$origin_2                   # 67e
        shufb   $yc_2,$vertex_c_2,$vertex_c_2,$axis_15  # 67o
        nop     $127                                    # 68e pairing
        shufb   $xc_5,$vertex_c_2,$vertex_c_2,$axis     # 68o
        fs      $zc_4,$zc_4,$origin_11                  # 69e
        shufb   $ya_2,$vertex_a_2,$vertex_a_2,$axis_15  # 69o
        nop     $127                                    # 70e pairing
        shufb   $xb_2,$vertex_b_3,$vertex_b_3,$axis_14  # 70o
        fs      $yc_2,$yc_2,$origin_3                   # 71e
        shufb   $xb_4,$vertex_b_3,$vertex_b_3,$axis_10  # 71o
        fs      $xc_5,$xc_5,$origin_12                  # 72e
        lqd     $origin_6,192($a_shear)                 # 72o
        fs      $ya_2,$ya_2,$origin_3                   # 73e
        shufb   $xb_3,$vertex_b_3,$vertex_b_3,$axis_7   # 73o
        nop     $127                                    # 74e pairing
        lqd     $axis_11,112($a_shear)                  # 74o
        fs      $xb_4,$xb_4,$origin_5                   # 75e
        lqd     $origin_7,208($a_shear)                 # 75o
        shufb   $xa_3,$vertex_a_2,$vertex_a_2,$axis_10  # 76o
        shufb   $zb_3,$vertex_b_3,$vertex_b_3,$axis_6   # 77o
        fs      $xb_2,$xb_2,$origin_6                   # 78e
        lqd     $origin_13,368($a_shear)                # 78o
        nop     $127                                    # 79e pairing
        lqd     $origin_9,288($a_shear)                 # 79o
        fs      $xa_3,$xa_3,$origin_5                   # 80e
        shufb   $yb_5,$vertex_b_3,$vertex_b_3,$axis_11  # 80o
        fs      $xb_3,$xb_3,$origin_7                   # 81e
        lqd     $slope_8,432($a_shear)                  # 81o
        fs      $zb_3,$zb_3,$origin_11                  # 82e
        lqd     $axis_5,80($a_shear)                    # 82o
        nop     $127                                    # 83e pairing
        shufb   $zc_7,$vertex_c_2,$vertex_c_2,$axis_12  # 83o
        fs      $za_7,$za_7,$origin_13                  # 84e
        lqd     $slope_3,400($a_shear)                  # 84o
        fs      $yb_5,$yb_5,$origin                     # 85e
        shufb   $xc_6,$vertex_c_2,$vertex_c_2,$axis_10  # 85o
        nop     $127                                    # 86e pairing
        shufb   $yc_6,$vertex_c_2,$vertex_c_2,$axis_11  # 86o
        fs      $zc_7,$zc_7,$origin_13                  # 87e
        shufb   $zb_7,$vertex_b_3,$vertex_b_3,$axis_12  # 87o
        nop     $127                                    # 88e pairing
        shufb   $yc_3,$vertex_c_2,$vertex_c_2,$axis_5   # 88o
        fs      $xc_6,$xc_6,$origin_5                   # 89e
        lqd     $origin_5,272($a_shear)                 # 89o
        fs      $yc_6,$yc_6,$origin                     # 90e
        shufb   $ya_9,$vertex_a_2,$vertex_a_2,$axis_8   # 90o
        fnms    $xa_9,$slope_8,$za_7,$xa_9              # 91e
        shufb   $xc_2,$vertex_c_2,$vertex_c_2,$axis_14  # 91o
        fs      $zb_6,$zb_7,$origin_13                  # 92e
        shufb   $xb_9,$vertex_b_3,$vertex_b_3,$axis     # 92o
        fnms    $xb_6,$slope_3,$zb_3,$xb_3              # 93e
        lqd     $slope_7,496($a_shear)                  # 93o
        fs      $ya_5,$ya_9,$origin_9                   # 94e
        shufb   $zb_2,$vertex_b_3,$vertex_b_3,$axis_2   # 94o
        fs      $xc_2,$xc_2,$origin_6                   # 95e
        shufb   $xa_4,$vertex_a_2,$vertex_a_2,$axis_7   # 95o
        fs      $xb_9,$xb_9,$origin_12                  # 96e
        shufb   $ya_3,$vertex_a_2,$vertex_a_2,$axis_5   # 96o
        fs      $yc_3,$yc_3,$origin_5                   # 97e
        shufb   $yb,$vertex_b_3,$vertex_b_3,$axis_5     # 97o
        fs      $zb_2,$zb_2,$origin_2                   # 98e
        shufb   $yb_4,$vertex_b_3,$vertex_b_3,$axis_8   # 98o
        fs      $xa_4,$xa_4,$origin_7                   # 99e
        shufb   $yb_7,$vertex_b_3,$vertex_b_3,$axis_15  # 99o
        fnms    $yc_6,$slope_7,$zc_7,$yc_6              # 100e
        shufb   $zc_8,$vertex_c_2,$vertex_c_2,$axis_2   # 100o
        fs      $ya_3,$ya_3,$origin_5                   # 101e
        lqd     $slope_2,448($a_shear)                  # 101o
        fs      $yb_4,$yb_4,$origin_9                   # 102e
        lqd     $slope_4,464($a_shear)                  # 102o
        fs      $yb_3,$yb_7,$origin_3                   # 103e
        shufb   $ya_10,$vertex_a_2,$vertex_a_2,$axis_11 # 103o
        fs      $zc_8,$zc_8,$origin_2                   # 104e
        lqd     $origin_2,352($a_shear)                 # 104o
        fs      $yb,$yb,$origin_5                       # 105e
        shufb   $yc_7,$vertex_c_2,$vertex_c_2,$axis_8   # 105o
        fnms    $xa_10,$slope_3,$za_3,$xa_4             # 106e
        shufb   $zc_5,$vertex_c_2,$vertex_c_2,$axis_13  # 106o
        fnms    $ya_2,$slope_2,$za_2,$ya_2              # 107e
        shufb   $za_4,$vertex_a_2,$vertex_a_2,$axis_13  # 107o
        fnms    $yc_3,$slope_4,$zc_4,$yc_3              # 108e
        shufb   $zb_4,$vertex_b_3,$vertex_b_3,$axis_13  # 108o
        fs      $ya_11,$ya_10,$origin                   # 109e
        lqd     $slope_13,480($a_shear)                 # 109o
        fs      $yc_7,$yc_7,$origin_9                   # 110e
        shufb   $xa_11,$vertex_a_2,$vertex_a_2,$axis_14 # 110o
        fs      $zc_9,$zc_5,$origin_2                   # 111e
            gb      $control_4,$control_4               # 111o
        fnms    $yc_5,$slope_2,$zc_8,$yc_2              # 112e
        lqd     $slope_6,416($a_shear)                  # 112o
        fs      $zb_4,$zb_4,$origin_2                   # 113e
        shlqbyi $zc_5,$zc_7,0                           # 113o copy
        fs      $za_5,$za_4,$origin_2                   # 114e
        shufb   $xc_7,$vertex_c_2,$vertex_c_2,$axis_7   # 114o
        fs      $xa_11,$xa_11,$origin_6                 # 115e
            shlqbii $control_4,$control_4,4             # 115o
        fnms    $xb,$slope,$zb_2,$xb_2                  # 116e
        shlqbyi $zc_10,$zc_4,0                          # 116o copy
        fnms    $xb_9,$slope_8,$zb_6,$xb_9              # 117e
        shlqbyi $zc_11,$zc_8,0                          # 117o copy
        fnms    $xc_6,$slope_6,$zc_9,$xc_6              # 118e
        lnop                                            # 118o pairing
        fnms    $yc_7,$slope_13,$zc_9,$yc_7             # 119e
            lqx     $control_4,$control_4,$a_controls   # 119o
        fnms    $ya_11,$slope_7,$za_7,$ya_11            # 120e
        fnms    $xb_4,$slope_6,$zb_4,$xb_4              # 121e
        fnms    $ya_5,$slope_13,$za_5,$ya_5             # 122e
            stqd    $nearest_2,480($a_packet_2)         # 122o
        fm      $sum_13,$yc_3,$xb_6                     # 123e
        fnms    $xc_5,$slope_8,$zc_7,$xc_5              # 124e
        fs      $xc_7,$xc_7,$origin_7                   # 125e
            shufb   $nearest_3,$nearest_3,$object_2,$control_4 # 125o
        fnms    $xc_8,$slope,$zc_8,$xc_2                # 126e
            shufb   $t_best,$t_best,$t_4,$control_4     # 126o
        fnms    $xa_12,$slope,$za_2,$xa_11              # 127e
        shlqbyi $zc_12,$zc_9,0                          # 127o copy
        fm      $sum_14,$yc_5,$xb                       # 128e
        lnop                                            # 128o pairing
        fnms    $yb,$slope_4,$zb_3,$yb                  # 129e
            stqd    $nearest_3,496($a_packet_2)         # 129o
        fnms    $ya_12,$slope_4,$za_3,$ya_3             # 130e
            stqd    $t_best,432($a_packet_2)            # 130o
        fnms    $xc_7,$slope_3,$zc_4,$xc_7              # 131e
        lnop                                            # 131o pairing
        fnms    $yb_3,$slope_2,$zb_2,$yb_3              # 132e
            lqx     $control,$control,$a_controls       # 132o
        fnms    $xa_13,$slope_6,$za_5,$xa_3             # 133e
        fm      $sum_15,$ya_2,$xc_8                     # 134e
        fm      $sum_16,$ya_5,$xc_6                     # 135e
        fnms    $yb_8,$slope_7,$zb_6,$yb_5              # 136e
        fm      $sum_7,$ya_12,$xc_7                     # 137e
        lnop                                            # 137o pairing
        fm      $sum_11,$yc_6,$xb_9                     # 138e
            shufb   $nearest,$nearest_4,$object_2,$control # 138o
        fms     $header_12,$yc_5,$xb,$sum_14            # 139e
            shufb   $t_best,$t_best_3,$t_2,$control     # 139o
        fnms    $yb_7,$slope_13,$zb_4,$yb_4             # 140e
        fms     $rest_11,$xc_8,$yb_3,$sum_14            # 141e
        fms     $rest_12,$xc_7,$yb,$sum_13              # 142e
            stqd    $nearest,448($a_packet_2)           # 142o
        fms     $v_9,$xa_10,$yc_3,$sum_7                # 143e
            stqd    $t_best,384($a_packet_2)            # 143o
        fms     $header_13,$ya_12,$xc_7,$sum_7          # 144e
        lnop                                            # 144o pairing
        fm      $sum_7,$ya_11,$xc_5                     # 145e
        shlqbyi $a_packet_2,$a_packet,0                 # 145o copy
        fms     $header_3,$yc_6,$xb_9,$sum_11           # 146e
        fms     $header_2,$ya_5,$xc_6,$sum_16           # 147e
        fm      $sum_17,$yb_3,$xa_12                    # 148e
        fm      $sum_18,$yb,$xa_10                      # 149e
        fs      $v_10,$v_9,$header_13                   # 150e
        fms     $header_11,$ya_11,$xc_5,$sum_7          # 151e
        fms     $v_4,$xa_9,$yc_6,$sum_7                 # 152e
        fms     $rest_8,$xc_5,$yb_8,$sum_11             # 153e
        fm      $sum_11,$yc_7,$xb_4                     # 154e
        fm      $sum_19,$yb_7,$xa_13                    # 155e
        fs      $rest_13,$rest_11,$header_12            # 156e
        fms     $header_8,$yb_3,$xa_12,$sum_17          # 157e
        fms     $w_9,$xb_6,$ya_12,$sum_18               # 158e
        fms     $header_14,$yc_3,$xb_6,$sum_13          # 159e
        fms     $header_15,$yc_7,$xb_4,$sum_11          # 160e
        fms     $rest_14,$xc_6,$yb_7,$sum_11            # 161e
        fm      $sum_12,$yb_8,$xa_9                     # 162e
        fms     $header_16,$ya_2,$xc_8,$sum_15          # 163e
        fms     $w_4,$xb_4,$ya_5,$sum_19                # 164e
        fms     $header_17,$yb_7,$xa_13,$sum_19         # 165e
        fs      $v_4,$v_4,$header_11                    # 166e
        fs      $rest_11,$rest_14,$header_15            # 167e
        fms     $v_11,$xa_12,$yc_5,$sum_15              # 168e
        fms     $w_10,$xb,$ya_2,$sum_17                 # 169e
        fms     $v_12,$xa_13,$yc_7,$sum_16              # 170e
        fms     $header_6,$yb_8,$xa_9,$sum_12           # 171e
        fms     $w_11,$xb_9,$ya_11,$sum_12              # 172e
        fms     $header,$yb,$xa_10,$sum_18              # 173e
        fs      $v_13,$v_11,$header_16                  # 174e
        fs      $w_12,$w_10,$header_8                   # 175e
        fs      $v_5,$v_12,$header_2                    # 176e
        fs      $rest,$rest_8,$header_3                 # 177e
        fs      $rest_15,$rest_12,$header_14            # 178e
        fs      $w_11,$w_11,$header_6                   # 179e
        fa      $det,$rest_13,$v_13                     # 180e
        fs      $w_5,$w_4,$header_17                    # 181e
        fs      $w_9,$w_9,$header                       # 182e
        fa      $det_6,$rest,$v_4                       # 183e
        fa      $det_7,$rest_11,$v_5                    # 184e
        fa      $det_8,$rest_15,$v_10                   # 185e
        fa      $det,$det,$w_12                         # 186e
        lqd     $slope,512($a_shear)                    # 186o
        or      $object_2,$index,$hit                   # 187e
        lnop                                            # 187o pairing
        fa      $det_3,$det_6,$w_11                     # 189e
        lqd     $slope_12,560($a_shear)                 # 189o
        fa      $det_6,$det_7,$w_5                      # 190e
        lqd     $slope_13,528($a_shear)                 # 190o
        fa      $det_8,$det_8,$w_9                      # 191e
        lqd     $slope_14,544($a_shear)                 # 191o
        xor     $seen_8,$det,$slope                     # 192e of -1 / direction z
        frest   $t_y_6,$det                             # 192o
        or      $seen_8,$seen_8,$both                   # 194e
        lnop                                            # 194o pairing
        xor     $seen_5,$det_3,$slope_12                # 195e of -1 / direction z
        frest   $t_y_2,$det_3                           # 195o
        fi      $t_y_6,$det,$t_y_6                      # 196e
        frest   $t_y_5,$det_6                           # 196o
        xor     $seen_7,$det_8,$slope_13                # 197e of -1 / direction z
        frest   $t_y_3,$det_8                           # 197o
        xor     $seen_4,$det_6,$slope_14                # 198e of -1 / direction z
        fi      $t_y_2,$det_3,$t_y_2                    # 199e
        fi      $t_y_5,$det_6,$t_y_5                    # 200e
        fi      $t_y_3,$det_8,$t_y_3                    # 201e
        or      $seen_4,$seen_4,$both                   # 202e
        fnms    $t_e,$det,$t_y_6,$k_above_one           # 203e
        or      $seen_5,$seen_5,$both                   # 204e
        or      $seen_7,$seen_7,$both                   # 205e
        fnms    $t_e_3,$det_3,$t_y_2,$k_above_one       # 206e
        fnms    $t_e_5,$det_6,$t_y_5,$k_above_one       # 207e
        fnms    $t_e_6,$det_8,$t_y_3,$k_above_one       # 208e
        fma     $inverse_2,$t_e,$t_y_6,$t_y_6           # 209e
        fma     $inverse_4,$t_e_3,$t_y_2,$t_y_2         # 212e
        fma     $inverse_5,$t_e_5,$t_y_5,$t_y_5         # 213e
        fma     $inverse_6,$t_e_6,$t_y_3,$t_y_3         # 214e
        fm      $rest_13,$rest_13,$inverse_2            # 215e
        fm      $v_13,$v_13,$inverse_2                  # 216e
        fm      $w_12,$w_12,$inverse_2                  # 217e
        fm      $rest,$rest,$inverse_4                  # 218e
        fm      $rest_11,$rest_11,$inverse_5            # 219e
        fm      $v_10,$v_10,$inverse_6                  # 220e
        fm      $rest_15,$rest_15,$inverse_6            # 221e
        fm      $v_8,$v_4,$inverse_4                    # 222e
        fm      $ahead_12,$rest_13,$za_2                # 223e
        fm      $w,$w_9,$inverse_6                      # 224e
        fm      $ahead_8,$rest_11,$za_5                 # 225e
        or      $outside,$rest_13,$v_13                 # 226e
        fm      $ahead_9,$rest_15,$za_3                 # 227e
        or      $outside_2,$rest_15,$v_10               # 228e
        fm      $v_5,$v_5,$inverse_5                    # 229e
        fma     $ahead_13,$v_13,$zb_2,$ahead_12         # 230e
        fm      $w_5,$w_5,$inverse_5                    # 231e
        fm      $ahead_11,$rest,$za_7                   # 232e
        fma     $ahead_9,$v_10,$zb_3,$ahead_9           # 233e
        fm      $w_8,$w_11,$inverse_4                   # 234e
        lnop                                            # 234o pairing
        fma     $ahead_8,$v_5,$zb_4,$ahead_8            # 235e
        hbrr    next_triangle_back,next_triangle        # 235o hint
        fma     $ahead,$w_12,$zc_11,$ahead_13           # 236e
        or      $outside_3,$rest,$v_8                   # 237e
        or      $outside_2,$outside_2,$w                # 238e
        fma     $ahead_7,$w,$zc_10,$ahead_9             # 239e
        or      $outside,$outside,$w_12                 # 240e
        fma     $ahead_8,$w_5,$zc_12,$ahead_8           # 241e
        fm      $ahead,$ahead,$slope                    # 242e
        orc     $outside,$outside,$seen_8               # 243e
        orc     $outside_5,$outside_2,$seen_7           # 244e
        lnop                                            # 244o pairing
        fm      $ahead_7,$ahead_7,$slope_13             # 245e
        lqd     $t_best_3,384($a_packet)                # 245o
        or      $outside_2,$rest_11,$v_5                # 246e
        fm      $ahead_10,$ahead_8,$slope_14            # 247e
        or      $outside_7,$outside_3,$w_8              # 248e
        lqd     $t_best_2,400($a_packet)                # 248o
        xor     $t_2,$ahead,$k_sign                     # 249e
        or      $outside_6,$outside_2,$w_5              # 250e
        cgt     $control,$t_best_3,$t_2                 # 251e
        lqd     $t_best_4,416($a_packet)                # 251o
        xor     $t_3,$ahead_7,$k_sign                   # 252e
next_triangle_back:
        brnz    $triangles,next_triangle                # 252o
next_triangle_drain:
        fma     $ahead_13,$v_8,$zb_6,$ahead_11          # 0e
        lqd     $t_best,432($a_packet)                  # 0o
        xor     $t,$ahead_10,$k_sign                    # 1e
        lqd     $nearest,464($a_packet)                 # 1o
        cgt     $control_5,$t_best_2,$t_3               # 2e
        lqd     $nearest_3,480($a_packet)               # 2o
        cgt     $control_6,$t_best_4,$t                 # 3e
        lqd     $nearest_5,496($a_packet)               # 3o
        orc     $outside_8,$outside_6,$seen_4           # 4e
        lqd     $nearest_6,448($a_packet)               # 4o
        and     $control_7,$control_6,$ahead_10         # 5e
        hbr     isect_mesh_pairs_r16_return,$lr         # 5o hint
        fma     $ahead_13,$w_8,$zc_5,$ahead_13          # 6e
        and     $control_5,$control_5,$ahead_7          # 7e
        andc    $control_3,$control_7,$outside_8        # 8e
        andc    $control_5,$control_5,$outside_5        # 9e
        orc     $outside_5,$outside_7,$seen_5           # 10e
        rotqbii $control_3,$control_3,1                 # 10o
        and     $control,$control,$ahead                # 11e
        rotqbii $control_5,$control_5,1                 # 11o
        fm      $ahead,$ahead_13,$slope_12              # 12e
        andc    $control,$control,$outside              # 13e
        gb      $control_3,$control_3                   # 14o
        gb      $control_2,$control_5                   # 15o
        nop     $127                                    # 16e pairing
        rotqbii $control,$control,1                     # 16o
        xor     $t_4,$ahead,$k_sign                     # 18e
        shlqbii $control_3,$control_3,4                 # 18o
        nop     $127                                    # 19e pairing
        shlqbii $control_2,$control_2,4                 # 19o
        cgt     $control_4,$t_best,$t_4                 # 20e
        gb      $control,$control                       # 20o
        and     $control_4,$control_4,$ahead            # 22e
        lqx     $control_3,$control_3,$a_controls       # 22o
        nop     $127                                    # 23e pairing
        lqx     $control_2,$control_2,$a_controls       # 23o
        andc    $control_4,$control_4,$outside_5        # 24e
        shlqbii $control,$control,4                     # 24o
        rotqbii $control_4,$control_4,1                 # 26o
        shufb   $t_best_4,$t_best_4,$t,$control_3       # 28o
        shufb   $t_best_5,$t_best_2,$t_3,$control_2     # 29o
        gb      $control_4,$control_4                   # 30o
        shufb   $nearest,$nearest,$object_2,$control_2  # 31o
        stqd    $t_best_4,416($a_packet_2)              # 32o
        stqd    $t_best_5,400($a_packet_2)              # 33o
        shlqbii $control_4,$control_4,4                 # 34o
        stqd    $nearest,464($a_packet_2)               # 35o
        shufb   $nearest_2,$nearest_3,$object_2,$control_3 # 36o
        lqx     $control_4,$control_4,$a_controls       # 38o
        stqd    $nearest_2,480($a_packet_2)             # 40o
        shufb   $nearest_3,$nearest_5,$object_2,$control_4 # 44o
        shufb   $t_best,$t_best,$t_4,$control_4         # 45o
        stqd    $nearest_3,496($a_packet_2)             # 48o
        stqd    $t_best,432($a_packet_2)                # 49o
        lqx     $control,$control,$a_controls           # 50o
        shufb   $nearest,$nearest_6,$object_2,$control  # 56o
        shufb   $t_best,$t_best_3,$t_2,$control         # 57o
        stqd    $nearest,448($a_packet_2)               # 60o
        stqd    $t_best,384($a_packet_2)                # 61o
isect_mesh_pairs_r16_return:
        bi      $lr                                     # 62o
next_run_short:
        ai      $count,$count,-1                        # 0e
        lqd     $candidate,0($a_run)                    # 0o
        ai      $a_run,$a_run,16                        # 1e
        rotmi   $candidate,$candidate,-16               # 6e
        a       $a_first,$a_first,$candidate            # 10e
        brnz    $count,next_run_short                   # 10o
        nop     $127                                    # 11e pairing
        br      isect_mesh_pairs_r16_block              # 11o
next_triangle_short:
        ai      $at_3,$at,4                             # 0e
        lqd     $candidate,0($a_candidate)              # 0o
        ai      $triangles,$triangles,-1                # 1e
        lnop                                            # 1o pairing
        andi    $index,$candidate,511                   # 6e 4 times it
        rotqbyi $a_shear,$candidate,8                   # 6o
        nop     $127                                    # 7e pairing
        rotqbyi $a_packet,$candidate,4                  # 7o
        a       $index,$index,$at                       # 8e
        rotqmbyi $ends,$candidate,-1                    # 8o 4 times the run's length
        a       $vertex_a,$a_faces,$index               # 10e
        lqx     $face,$a_faces,$index                   # 10o
        lqd     $a_shear,192($a_shear)                  # 11o
        lqd     $t_best,384($a_packet)                  # 12o
        lqd     $t_best_5,400($a_packet)                # 13o
        lqd     $t_best_6,416($a_packet)                # 14o
        lqd     $t_best_7,432($a_packet)                # 15o
        rotqby  $face,$face,$vertex_a                   # 16o
        rotqbyi $a_shear,$a_shear,8                     # 17o
        rotqmbii $index,$index,-2                       # 18o
        lqd     $nearest,480($a_packet)                 # 19o
        shufb   $face,$face,$face,$m_indices            # 20o
        lqd     $axis,32($a_shear)                      # 21o
        lqd     $axis_16,64($a_shear)                   # 22o
        lqd     $axis_9,128($a_shear)                   # 23o
        shlqbii $face,$face,4                           # 24o
        lqd     $axis_17,144($a_shear)                  # 25o
        lqd     $origin,224($a_shear)                   # 26o
        lqd     $axis_7,160($a_shear)                   # 27o
        lqd     $axis_18,16($a_shear)                   # 28o
        lqd     $origin_14,288($a_shear)                # 29o
        rotqbyi $vertex_c,$face,8                       # 30o
        lqd     $origin_3,192($a_shear)                 # 31o
        lqd     $origin_15,256($a_shear)                # 32o
        lqd     $axis_14,80($a_shear)                   # 33o
        lqd     $origin_16,336($a_shear)                # 34o
        rotqbyi $vertex_b_4,$face,4                     # 35o
        lqd     $axis_19,96($a_shear)                   # 36o
        lqd     $origin_17,320($a_shear)                # 37o
        lqd     $origin_11,352($a_shear)                # 38o
        lqx     $vertex_c,$a_vertices,$vertex_c         # 39o
        lqd     $axis_20,0($a_shear)                    # 40o
        lqd     $slope,448($a_shear)                    # 41o
        lqx     $vertex_b_4,$a_vertices,$vertex_b_4     # 42o
        lqd     $slope_15,384($a_shear)                 # 43o
        lqd     $origin_18,208($a_shear)                # 44o
        shufb   $zc,$vertex_c,$vertex_c,$axis_9         # 45o
        shufb   $zc_13,$vertex_c,$vertex_c,$axis_7      # 46o
        shufb   $zc_14,$vertex_c,$vertex_c,$axis_17     # 47o
        shufb   $xb_10,$vertex_b_4,$vertex_b_4,$axis    # 48o
        fs      $zc,$zc,$origin_17                      # 49e
        shufb   $zb_8,$vertex_b_4,$vertex_b_4,$axis_9   # 49o
        fs      $zc_13,$zc_13,$origin_11                # 50e
        shufb   $xb_11,$vertex_b_4,$vertex_b_4,$axis_18 # 50o
        fs      $zc_14,$zc_14,$origin_16                # 51e
        shufb   $xc_5,$vertex_c,$vertex_c,$axis_20      # 51o
        fs      $xb_10,$xb_10,$origin                   # 52e
        shufb   $xb_12,$vertex_b_4,$vertex_b_4,$axis_20 # 52o
        fs      $zb_8,$zb_8,$origin_17                  # 53e
        shufb   $yb_9,$vertex_b_4,$vertex_b_4,$axis_16  # 53o
        fs      $xb_11,$xb_11,$origin_18                # 54e
        shufb   $zb_9,$vertex_b_4,$vertex_b_4,$axis_17  # 54o
        fs      $xc_5,$xc_5,$origin_3                   # 55e
        lqd     $slope_16,400($a_shear)                 # 55o
        fs      $xb_12,$xb_12,$origin_3                 # 56e
        shufb   $zb_10,$vertex_b_4,$vertex_b_4,$axis_7  # 56o
        fs      $yb_9,$yb_9,$origin_15                  # 57e
        lqx     $vertex_a_3,$a_vertices,$face           # 57o
        fs      $zb_9,$zb_9,$origin_16                  # 58e
        shufb   $xc_9,$vertex_c,$vertex_c,$axis_18      # 58o
        nop     $127                                    # 59e pairing
        shufb   $yb_10,$vertex_b_4,$vertex_b_4,$axis_14 # 59o
        fs      $zb_10,$zb_10,$origin_11                # 60e
        lqd     $slope_17,464($a_shear)                 # 60o
        fnms    $xc_5,$slope_15,$zc,$xc_5               # 61e
        shufb   $yc_8,$vertex_c,$vertex_c,$axis_19      # 61o
        fs      $xc_9,$xc_9,$origin_18                  # 62e
        shufb   $yc_9,$vertex_c,$vertex_c,$axis_16      # 62o
        fnms    $xb_12,$slope_15,$zb_8,$xb_12           # 63e
        shufb   $za_8,$vertex_a_3,$vertex_a_3,$axis_9   # 63o
        fnms    $xb_11,$slope_16,$zb_9,$xb_11           # 64e
        shufb   $ya_13,$vertex_a_3,$vertex_a_3,$axis_14 # 64o
        fs      $yc_8,$yc_8,$origin_14                  # 65e
        shufb   $za_9,$vertex_a_3,$vertex_a_3,$axis_17  # 65o
        fs      $yc_9,$yc_9,$origin_15                  # 66e
        shufb   $ya_14,$vertex_a_3,$vertex_a_3,$axis_19 # 66o
        fs      $za_8,$za_8,$origin_17                  # 67e
        shufb   $xa_14,$vertex_a_3,$vertex_a_3,$axis_20 # 67o
        fnms    $xc_10,$slope_16,$zc_14,$xc_9           # 68e
        shufb   $xa_15,$vertex_a_3,$vertex_a_3,$axis    # 68o
        fs      $za_9,$za_9,$origin_16                  # 69e
        shufb   $za_10,$vertex_a_3,$vertex_a_3,$axis_7  # 69o
        fs      $ya_10,$ya_14,$origin_14                # 70e
        lqd     $axis_21,176($a_shear)                  # 70o
        fs      $xa_16,$xa_14,$origin_3                 # 71e
        shufb   $ya_15,$vertex_a_3,$vertex_a_3,$axis_16 # 71o
        fs      $xa_14,$xa_15,$origin                   # 72e
        lqd     $slope_18,416($a_shear)                 # 72o
        fnms    $yc_9,$slope,$zc,$yc_9                  # 73e
        lqd     $origin_19,272($a_shear)                # 73o
        fs      $za_10,$za_10,$origin_11                # 74e
        shufb   $xc_11,$vertex_c,$vertex_c,$axis        # 74o
        fs      $ya_15,$ya_15,$origin_15                # 75e
        lqd     $origin_15,368($a_shear)                # 75o
        fnms    $yb_11,$slope,$zb_8,$yb_9               # 76e
        shufb   $xa_17,$vertex_a_3,$vertex_a_3,$axis_18 # 76o
        fnms    $xa_16,$slope_15,$za_8,$xa_16           # 77e
        lqd     $axis_22,112($a_shear)                  # 77o
        fs      $xc_11,$xc_11,$origin                   # 78e
        shufb   $yc_10,$vertex_c,$vertex_c,$axis_14     # 78o
        fs      $ya_16,$ya_13,$origin_19                # 79e
        lqd     $origin_20,304($a_shear)                # 79o
        fnms    $xb_10,$slope_18,$zb_10,$xb_10          # 80e
        lqd     $axis_23,48($a_shear)                   # 80o
        fnms    $ya_15,$slope,$za_8,$ya_15              # 81e
        lqd     $slope,480($a_shear)                    # 81o
        fs      $yc_10,$yc_10,$origin_19                # 82e
        shufb   $zc_15,$vertex_c,$vertex_c,$axis_21     # 82o
        fs      $xa_17,$xa_17,$origin_18                # 83e
        shufb   $ya_17,$vertex_a_3,$vertex_a_3,$axis_22 # 83o
        fs      $yb_10,$yb_10,$origin_19                # 84e
        shufb   $yb_12,$vertex_b_4,$vertex_b_4,$axis_22 # 84o
        fnms    $ya_16,$slope_17,$za_9,$ya_16           # 85e
        lqd     $slope_19,496($a_shear)                 # 85o
        fs      $zc_15,$zc_15,$origin_15                # 86e
        shufb   $xc_12,$vertex_c,$vertex_c,$axis_23     # 86o
        fnms    $yc_8,$slope,$zc_13,$yc_8               # 87e
        shufb   $yb_13,$vertex_b_4,$vertex_b_4,$axis_19 # 87o
        fnms    $yc_10,$slope_17,$zc_14,$yc_10          # 88e
        shufb   $za_11,$vertex_a_3,$vertex_a_3,$axis_21 # 88o
        fm      $sum_20,$ya_15,$xc_5                    # 89e
        shufb   $xb_13,$vertex_b_4,$vertex_b_4,$axis_23 # 89o
        fnms    $yb_10,$slope_17,$zb_9,$yb_10           # 90e
        shufb   $yc_11,$vertex_c,$vertex_c,$axis_22     # 90o
        fs      $yb_14,$yb_13,$origin_14                # 91e
        shufb   $zb_11,$vertex_b_4,$vertex_b_4,$axis_21 # 91o
        fs      $za,$za_11,$origin_15                   # 92e
        lqd     $origin_21,240($a_shear)                # 92o
        fnms    $xa_17,$slope_16,$za_9,$xa_17           # 93e
        lqd     $slope_16,432($a_shear)                 # 93o
        fs      $ya_17,$ya_17,$origin_20                # 94e
        shufb   $xa_18,$vertex_a_3,$vertex_a_3,$axis_23 # 94o
        fs      $zb_12,$zb_11,$origin_15                # 95e
        lqd     $slope_20,512($a_shear)                 # 95o
        fnms    $ya_10,$slope,$za_10,$ya_10             # 96e
        lqd     $slope_17,528($a_shear)                 # 96o
        fnms    $yb_14,$slope,$zb_10,$yb_14             # 97e
        lqd     $slope,544($a_shear)                    # 97o
        fs      $xc_13,$xc_12,$origin_21                # 98e
        lqd     $slope_14,560($a_shear)                 # 98o
        fm      $sum_21,$yc_8,$xb_10                    # 99e
        shufb   $index,$index,$index,$m_splat           # 99o
        fnms    $xc_11,$slope_18,$zc_13,$xc_11          # 100e
        lqd     $nearest_7,448($a_packet)               # 100o
        fs      $yb_12,$yb_12,$origin_20                # 101e
        lqd     $nearest_8,464($a_packet)               # 101o
        fm      $sum_22,$yb_10,$xa_17                   # 102e
        rotqmbii $ends,$ends,-6                         # 102o
        fnms    $xa_14,$slope_18,$za_10,$xa_14          # 103e
        lqd     $nearest_9,496($a_packet)               # 103o
        fnms    $xc_13,$slope_16,$zc_15,$xc_13          # 104e
        fms     $header_18,$yc_8,$xb_10,$sum_21         # 105e
        fms     $rest_16,$xc_11,$yb_14,$sum_21          # 106e
        fms     $v_14,$xa_16,$yc_9,$sum_20              # 107e
        fs      $yc_11,$yc_11,$origin_20                # 108e
        fm      $sum_23,$yb_11,$xa_16                   # 109e
        fm      $sum_24,$yc_10,$xb_11                   # 110e
        fm      $sum_25,$yc_9,$xb_12                    # 111e
        fs      $rest_16,$rest_16,$header_18            # 112e
        fm      $sum_8,$ya_16,$xc_10                    # 113e
        fnms    $yc_11,$slope_19,$zc_15,$yc_11          # 114e
        fms     $header_8,$yb_11,$xa_16,$sum_23         # 115e
        fms     $header_19,$yc_10,$xb_11,$sum_24        # 116e
        fms     $header_20,$yc_9,$xb_12,$sum_25         # 117e
        fms     $rest_10,$xc_5,$yb_11,$sum_25           # 118e
        fms     $header_21,$ya_16,$xc_10,$sum_8         # 119e
        fms     $rest_17,$xc_10,$yb_10,$sum_24          # 120e
        fms     $header_22,$yb_10,$xa_17,$sum_22        # 121e
        fm      $sum_24,$ya_10,$xc_11                   # 122e
        fm      $sum_26,$yb_14,$xa_14                   # 123e
        fs      $rest_10,$rest_10,$header_20            # 124e
        fs      $xb_14,$xb_13,$origin_21                # 125e
        fnms    $yb_12,$slope_19,$zb_12,$yb_12          # 126e
        fs      $xa_18,$xa_18,$origin_21                # 127e
        fms     $v_3,$xa_14,$yc_8,$sum_24               # 128e
        fms     $header_7,$yb_14,$xa_14,$sum_26         # 129e
        fms     $w_10,$xb_10,$ya_10,$sum_26             # 130e
        fnms    $xb_10,$slope_16,$zb_12,$xb_14          # 131e
        fms     $header_17,$ya_10,$xc_11,$sum_24        # 132e
        fnms    $xa_18,$slope_16,$za,$xa_18             # 133e
        fnms    $ya_18,$slope_19,$za,$ya_17             # 134e
        fms     $w,$xb_11,$ya_16,$sum_22                # 135e
        fms     $header_23,$ya_15,$xc_5,$sum_20         # 136e
        fms     $v_15,$xa_17,$yc_10,$sum_8              # 137e
        fs      $v_16,$v_3,$header_17                   # 138e
        fm      $sum_27,$yc_11,$xb_10                   # 139e
        fm      $sum_28,$ya_18,$xc_13                   # 140e
        fms     $w_13,$xb_12,$ya_15,$sum_23             # 141e
        fs      $v_17,$v_14,$header_23                  # 142e
        fs      $rest_17,$rest_17,$header_19            # 143e
        fa      $det,$rest_16,$v_16                     # 144e
        fs      $v_15,$v_15,$header_21                  # 145e
        fms     $header_24,$ya_18,$xc_13,$sum_28        # 146e
        fs      $w_13,$w_13,$header_8                   # 147e
        fs      $w,$w,$header_22                        # 148e
        fms     $header_8,$yc_11,$xb_10,$sum_27         # 149e
        fs      $w_11,$w_10,$header_7                   # 150e
        fa      $det_9,$rest_17,$v_15                   # 151e
        fms     $v_18,$xa_18,$yc_11,$sum_28             # 152e
        fm      $sum_28,$yb_12,$xa_18                   # 153e
        fa      $det_10,$rest_10,$v_17                  # 154e
        fms     $rest_18,$xc_13,$yb_12,$sum_27          # 155e
        fa      $det,$det,$w_11                         # 156e
        fa      $det_9,$det_9,$w                        # 157e
        fs      $v_18,$v_18,$header_24                  # 158e
        fms     $w_14,$xb_10,$ya_18,$sum_28             # 159e
        fa      $det_11,$det_10,$w_13                   # 160e
        fs      $rest,$rest_18,$header_8                # 161e
        fms     $header_4,$yb_12,$xa_18,$sum_28         # 162e
        frest   $t_y,$det                               # 162o
        xor     $seen_9,$det_9,$slope_17                # 163e of -1 / direction z
        frest   $t_y_7,$det_9                           # 163o
        xor     $seen_5,$det,$slope                     # 164e of -1 / direction z
        or      $seen_9,$seen_9,$both                   # 165e
        fi      $t_y,$det,$t_y                          # 166e
        frest   $t_y_4,$det_11                          # 166o
        fi      $t_y_7,$det_9,$t_y_7                    # 167e
        xor     $seen_10,$det_11,$slope_20              # 168e of -1 / direction z
        fa      $det_12,$rest,$v_18                     # 169e
        fs      $w_15,$w_14,$header_4                   # 170e
        fi      $t_y_8,$det_11,$t_y_4                   # 171e
        or      $seen_4,$seen_10,$both                  # 172e
        fnms    $t_e_7,$det,$t_y,$k_above_one           # 173e
        fnms    $t_e_8,$det_9,$t_y_7,$k_above_one       # 174e
        or      $seen_5,$seen_5,$both                   # 175e
        fa      $det_13,$det_12,$w_15                   # 176e
        or      $object_3,$index,$hit                   # 177e
        fnms    $t_e_9,$det_11,$t_y_8,$k_above_one      # 178e
        fma     $inverse_7,$t_e_7,$t_y,$t_y             # 179e
        fma     $inverse_8,$t_e_8,$t_y_7,$t_y_7         # 180e
        cgt     $more,$ends,$at_3                       # 181e
        lnop                                            # 181o pairing
        xor     $seen_11,$det_13,$slope_14              # 182e of -1 / direction z
        frest   $t_y,$det_13                            # 182o
        andc    $ends,$k_step,$more                     # 183e
        fma     $inverse_9,$t_e_9,$t_y_8,$t_y_8         # 184e
        fm      $rest_5,$rest_16,$inverse_7             # 185e
        fi      $t_y,$det_13,$t_y                       # 186e
        or      $seen_11,$seen_11,$both                 # 187e
        fm      $v_16,$v_16,$inverse_7                  # 188e
        fm      $rest_17,$rest_17,$inverse_8            # 189e
        fm      $rest_10,$rest_10,$inverse_9            # 190e
        fm      $ahead_5,$rest_5,$za_10                 # 191e
        fm      $v_15,$v_15,$inverse_8                  # 192e
        fnms    $t_e_10,$det_13,$t_y,$k_above_one       # 193e
        fm      $w,$w,$inverse_8                        # 194e
        fm      $ahead_14,$rest_17,$za_9                # 195e
        fm      $ahead_10,$rest_10,$za_8                # 196e
        fma     $ahead_5,$v_16,$zb_10,$ahead_5          # 197e
        fm      $w_11,$w_11,$inverse_7                  # 198e
        fma     $inverse_8,$t_e_10,$t_y,$t_y            # 199e
        fm      $w_13,$w_13,$inverse_9                  # 200e
        fma     $ahead,$v_15,$zb_9,$ahead_14            # 201e
        fm      $v_6,$v_17,$inverse_9                   # 202e
        or      $outside,$rest_17,$v_15                 # 203e
        fma     $ahead_5,$w_11,$zc_13,$ahead_5          # 204e
        fm      $rest,$rest,$inverse_8                  # 205e
        fm      $v_15,$v_18,$inverse_8                  # 206e
        fma     $ahead,$w,$zc_14,$ahead                 # 207e
        fma     $ahead_10,$v_6,$zb_8,$ahead_10          # 208e
        or      $outside,$outside,$w                    # 209e
        fm      $ahead_5,$ahead_5,$slope                # 210e
        fm      $ahead_15,$rest,$za                     # 211e
        fm      $w,$w_15,$inverse_8                     # 212e
        fm      $ahead,$ahead,$slope_17                 # 213e
        fma     $ahead_10,$w_13,$zc,$ahead_10           # 214e
        or      $outside_7,$rest_10,$v_6                # 215e
        xor     $t,$ahead_5,$k_sign                     # 216e
        fma     $ahead_6,$v_15,$zb_12,$ahead_15         # 217e
        cgt     $control,$t_best_6,$t                   # 218e
        xor     $t_5,$ahead,$k_sign                     # 219e
        fm      $ahead_10,$ahead_10,$slope_20           # 220e
        cgt     $control_8,$t_best_5,$t_5               # 221e
        or      $outside_5,$outside_7,$w_13             # 222e
        and     $control_4,$control_8,$ahead            # 223e
        orc     $outside,$outside,$seen_9               # 224e
        fma     $ahead,$w,$zc_15,$ahead_6               # 225e
        xor     $t_6,$ahead_10,$k_sign                  # 226e
        andc    $control_4,$control_4,$outside          # 227e
        cgt     $control_9,$t_best,$t_6                 # 228e
        and     $control,$control,$ahead_5              # 229e
        rotqbii $control_4,$control_4,1                 # 229o
        and     $control_7,$control_9,$ahead_10         # 230e
        or      $outside,$rest_5,$v_16                  # 231e
        fm      $ahead,$ahead,$slope_14                 # 232e
        lnop                                            # 232o pairing
        or      $outside,$outside,$w_11                 # 233e
        gb      $control_4,$control_4                   # 233o
        orc     $outside_5,$outside_5,$seen_4           # 234e
        orc     $outside,$outside,$seen_5               # 235e
        andc    $control_10,$control_7,$outside_5       # 236e
        lnop                                            # 236o pairing
        andc    $control,$control,$outside              # 237e
        shlqbii $control_7,$control_4,4                 # 237o
        xor     $t_7,$ahead,$k_sign                     # 238e
        rotqbii $control_10,$control_10,1               # 238o
        or      $outside,$rest,$v_15                    # 239e
        rotqbii $control,$control,1                     # 239o
        cgt     $control_11,$t_best_7,$t_7              # 240e
        lnop                                            # 240o pairing
        or      $outside,$outside,$w                    # 241e
        lqx     $control_7,$control_7,$a_controls       # 241o
        and     $control_11,$control_11,$ahead          # 242e
        gb      $control_10,$control_10                 # 242o
        orc     $outside,$outside,$seen_11              # 243e
        gb      $control,$control                       # 243o
        a       $a_candidate,$a_candidate,$ends         # 244e
        andc    $control_11,$control_11,$outside        # 245e
        and     $at,$at_3,$more                         # 246e
        shlqbii $control_2,$control_10,4                # 246o
        shlqbii $control,$control,4                     # 247o
        rotqbii $control_10,$control_11,1               # 248o
        shufb   $t_best_5,$t_best_5,$t_5,$control_7     # 249o
        lqx     $control_2,$control_2,$a_controls       # 250o
        lqx     $control,$control,$a_controls           # 251o
        gb      $control_10,$control_10                 # 252o
        stqd    $t_best_5,400($a_packet)                # 253o
        shufb   $nearest_2,$nearest_8,$object_3,$control_7 # 254o
        shufb   $t_best,$t_best,$t_6,$control_2         # 256o
        shufb   $nearest,$nearest,$object_3,$control    # 257o
        stqd    $nearest_2,464($a_packet)               # 258o
        shufb   $t_best_5,$t_best_6,$t,$control         # 259o
        stqd    $t_best,384($a_packet)                  # 260o
        shlqbii $control,$control_10,4                  # 261o
        shufb   $nearest_10,$nearest_7,$object_3,$control_2 # 262o
        stqd    $nearest,480($a_packet)                 # 263o
        stqd    $t_best_5,416($a_packet)                # 264o
        lqx     $control,$control,$a_controls           # 265o
        stqd    $nearest_10,448($a_packet)              # 266o
        hbrr    next_triangle_short_back,next_triangle_short # 267o hint
        shufb   $t_best,$t_best_7,$t_7,$control         # 271o
        shufb   $nearest,$nearest_9,$object_3,$control  # 272o
        stqd    $t_best,432($a_packet)                  # 275o
        stqd    $nearest,496($a_packet)                 # 276o
        nop     $127                                    # 277e pairing
next_triangle_short_back:
        brnz    $triangles,next_triangle_short          # 277o
        nop     $127                                    # 278e pairing
        bi      $lr                                     # 278o
endfunction isect_mesh_pairs_r16
