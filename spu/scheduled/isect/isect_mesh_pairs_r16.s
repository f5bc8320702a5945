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
        .set count_2,79; .set a_run_2,2; .set candidate_2,6; .set candidate_3,7; .set candidate_4,2
        .set triangles_2,79; .set at_2,4; .set a_packet_2,78; .set t_best_2,35; .set t_best_3,32
        .set axis_2,63; .set object_2,79; .set axis_3,50; .set axis_4,34; .set axis_5,29
        .set origin_2,38; .set vertex_c_2,2; .set vertex_b_2,33; .set vertex_a_2,9
        .set origin_3,51; .set vertex_c_3,8; .set vertex_b_3,27; .set axis_6,2; .set axis_7,30
        .set axis_8,7; .set axis_9,45; .set origin_4,68; .set xb_2,71; .set ya_2,48; .set yc_2,4
        .set xc_2,69; .set origin_5,36; .set zc_2,55; .set zb_2,64; .set origin_6,65; .set za_2,50
        .set origin_7,44; .set xc_3,5; .set slope_2,72; .set zc_3,6; .set za_3,76; .set yc_3,21
        .set zb_3,24; .set origin_8,25; .set za_4,51; .set origin_9,31; .set xc_4,46; .set xb_3,28
        .set zc_4,49; .set xb_4,7; .set ya_3,75; .set za_5,33; .set zb_4,56; .set ya_4,47
        .set za_6,29; .set xb_5,53; .set slope_3,67; .set xa_2,25; .set slope_4,33; .set slope_5,76
        .set slope_6,37; .set yb_2,41; .set slope_7,34; .set xa_3,30; .set yb_3,42; .set xa_4,38
        .set yb_4,39; .set xa_5,2; .set axis_10,66; .set xa_6,43; .set axis_11,38
        .set origin_10,73; .set yb_5,31; .set origin_11,54; .set ya_5,44; .set xb_6,42
        .set yc_4,62; .set zb_5,52; .set zc_5,57; .set sum_2,58; .set ya_6,70; .set za_7,74
        .set xc_5,8; .set sum_3,38; .set yb_6,27; .set slope_8,63; .set slope_9,59; .set sum_4,30
        .set xa_7,77; .set sum_5,9; .set slope_10,60; .set sum_6,33; .set slope_11,45
        .set sum_7,26; .set header_2,61; .set header_3,65; .set rest_2,58; .set v_2,4
        .set sum_8,66; .set header_4,38; .set rest_3,30; .set sum_9,67; .set v_3,40
        .set header_5,9; .set v_4,46; .set header_6,21; .set header_7,26; .set sum_10,68
        .set rest_4,5; .set header_8,25; .set rest_5,33; .set w_2,41; .set v_5,7; .set rest_6,9
        .set header_9,31; .set w_3,2; .set w_4,26; .set det_2,28; .set w_5,25; .set det_3,30
        .set xb_7,38; .set zc_6,65; .set w_6,21; .set det_4,26; .set xa_8,31; .set ya_7,36
        .set t_y_2,39; .set sum_11,62; .set t_y_3,41; .set seen_2,42; .set sum_12,43; .set t_y_4,44
        .set seen_3,46; .set v_6,53; .set seen_4,54; .set t_e_2,28; .set header_10,8
        .set header_11,40; .set t_e_3,30; .set t_e_4,26; .set inverse_2,28; .set w_7,36
        .set header_12,27; .set v_7,31; .set inverse_3,8; .set inverse_4,26; .set w_8,33
        .set det_5,43; .set ahead_2,27; .set det_6,38; .set ahead_3,29; .set ahead_4,36
        .set w_9,28; .set w_10,8; .set t_y_5,21; .set ahead_5,25; .set ahead_6,24; .set seen_5,40
        .set outside_2,4; .set ahead_7,26; .set ahead_8,6; .set seen_6,27; .set seen_7,41
        .set outside_3,26; .set outside_4,5; .set t_2,36; .set outside_5,34; .set seen_8,29
        .set outside_6,21; .set control_2,2; .set t_best_4,5; .set nearest_2,6; .set nearest_3,7
        .set nearest_4,8; .set t_3,9; .set control_3,21; .set t_best_5,2; .set t_best_6,29
        .set control_4,7; .set axis_12,32; .set vertex_c_4,27; .set nearest_5,5; .set axis_13,37
        .set xb_8,30; .set xc_6,45; .set yc_5,34; .set slope_12,38; .set slope_13,65; .set yb_7,32
        .set zc_7,29; .set yc_6,2; .set zc_8,25; .set origin_12,29; .set zb_6,7; .set slope_14,36
        .set xa_9,9; .set xb_9,27; .set xa_10,54; .set xc_7,44; .set zc_9,8; .set sum_13,21
        .set sum_14,32; .set ya_8,45; .set xc_8,29; .set rest_7,6; .set xb_10,8; .set xa_11,24
        .set sum_15,36; .set yc_7,38; .set sum_16,54; .set sum_17,57; .set v_8,59; .set rest_8,60
        .set v_9,63; .set header_13,30; .set header_14,32; .set header_15,34; .set v_10,67
        .set header_16,2; .set header_17,5; .set rest_9,36; .set v_11,24; .set v_12,21
        .set v_13,30; .set rest_10,2; .set w_11,42; .set header_18,33; .set w_12,32; .set det_7,36
        .set w_13,9; .set det_8,31; .set det_9,34; .set det_10,29; .set slope_15,24; .set seen_9,37
        .set t_y_6,38; .set slope_16,39; .set t_y_7,27; .set t_y_8,42; .set inverse_5,27
        .set t_y_9,36; .set inverse_6,4; .set v_14,28; .set w_14,4; .set ahead_9,2; .set t_y_10,30
        .set outside_7,6; .set ahead_10,7; .set control_5,4; .set nearest_6,2; .set at_3,2
        .set t_best_7,4; .set t_best_8,6; .set axis_14,8; .set axis_15,9; .set origin_13,21
        .set origin_14,23; .set axis_16,24; .set origin_15,27; .set axis_17,33; .set axis_18,35
        .set ya_9,38; .set za_8,39; .set xb_11,41; .set xb_12,44; .set za_9,45; .set axis_19,46
        .set yc_8,47; .set origin_16,48; .set zb_7,49; .set xb_13,50; .set slope_17,51
        .set za_10,52; .set zc_10,53; .set zb_8,46; .set zc_11,35; .set yb_8,9; .set zb_9,23
        .set yb_9,46; .set zb_10,55; .set xc_9,56; .set xa_12,36; .set xc_10,24; .set origin_17,57
        .set xc_11,62; .set ya_10,64; .set zb_11,43; .set yc_9,42; .set zc_12,7; .set ya_11,49
        .set slope_18,57; .set axis_20,48; .set slope_19,27; .set slope_20,64; .set axis_21,65
        .set xa_13,8; .set origin_18,67; .set ya_12,68; .set slope_21,69; .set za_11,70
        .set slope_22,71; .set zc_13,72; .set xb_14,21; .set sum_18,73; .set yc_10,74
        .set sum_19,75; .set origin_19,76; .set xc_12,32; .set xa_14,29; .set zb_12,36
        .set slope_23,48; .set sum_20,60; .set slope_24,26; .set nearest_7,64; .set nearest_8,77
        .set nearest_9,78; .set header_19,63; .set za_12,46; .set v_15,70; .set header_20,54
        .set v_16,57; .set rest_11,76; .set header_21,73; .set rest_12,56; .set header_22,47
        .set sum_21,70; .set rest_13,44; .set header_23,24; .set v_17,42; .set sum_22,56
        .set v_18,54; .set w_15,34; .set w_16,38; .set det_11,41; .set det_12,37; .set w_17,27
        .set det_13,33; .set sum_23,37; .set t_y_11,34; .set v_19,32; .set t_y_12,40
        .set seen_10,57; .set header_24,29; .set t_y_13,37; .set t_e_5,38; .set t_e_6,42
        .set t_e_7,33; .set inverse_7,38; .set inverse_8,34; .set object_3,28; .set inverse_9,31
        .set v_20,41; .set ahead_11,39; .set ahead_12,44; .set t_e_8,31; .set ahead_13,23
        .set ahead_14,38; .set inverse_10,30; .set outside_8,8; .set ahead_15,30; .set outside_9,24
        .set t_4,29; .set t_5,31; .set control_6,32; .set control_7,8; .set t_6,8; .set control_8,9
        .set control_9,5
        ori     $a_candidate,$a_first,0                 # 0e
        ori     $a_run,$a_first,0                       # 1e
        il      $a_first,0                              # 2e
        biz     $count,$lr                              # 2o
        clgti   $count_2,$count,2                       # 3e at least as many passes as overlap
        brz     $count_2,next_run_short                 # 5o too few passes
        ai      $a_run_2,$a_run,16                      # 6e
        lqd     $candidate,0($a_run)                    # 6o
        ai      $count,$count,-1                        # 7e
        hbrr    next_run_back,next_run                  # 7o hint
        ai      $a_run,$a_run_2,16                      # 8e
        lqd     $candidate_2,0($a_run_2)                # 8o
        ai      $count,$count,-1                        # 9e
        rotmi   $candidate_3,$candidate,-16             # 12e
next_run:
        ai      $count,$count,-1                        # 0e
        lqd     $candidate,0($a_run)                    # 0o
        ai      $a_run,$a_run,16                        # 1e
            rotmi   $candidate_4,$candidate_2,-16       # 2e
            a       $a_first,$a_first,$candidate_3      # 3e
        brz     $count,next_run_drain_2                 # 3o the last pass
        ai      $count,$count,-1                        # 4e
        lqd     $candidate_2,0($a_run)                  # 4o
        ai      $a_run,$a_run,16                        # 5e
            rotmi   $candidate_3,$candidate,-16         # 6e
            a       $a_first,$a_first,$candidate_4      # 7e
next_run_back:
        brnz    $count,next_run                         # 7o
next_run_drain:
        rotmi   $candidate_4,$candidate_2,-16           # 0e
        a       $a_first,$a_first,$candidate_3          # 1e
        a       $a_first,$a_first,$candidate_4          # 4e
        lnop                                            # 4o pairing
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
        rotqbyi $a_packet_2,$candidate,4                # 27o
        a       $vertex_a,$a_faces,$index               # 29e
        lqx     $face,$a_faces,$index                   # 29o
        lqd     $a_shear,192($a_shear)                  # 30o
        rotqmbii $index,$index,-2                       # 31o
        rotqmbii $ends,$ends,-6                         # 32o
        lqd     $t_best_2,400($a_packet_2)              # 33o
        lqd     $t_best_3,384($a_packet_2)              # 34o
        rotqby  $face,$face,$vertex_a                   # 35o
        cgt     $more,$ends,$at_2                       # 36e
        rotqbyi $a_shear,$a_shear,8                     # 36o
        shufb   $index,$index,$index,$m_splat           # 37o
        andc    $ends,$k_step,$more                     # 38e
        and     $at,$at_2,$more                         # 39e
        shufb   $face,$face,$face,$m_indices            # 39o
        a       $a_candidate,$a_candidate,$ends         # 40e
        lqd     $axis_2,0($a_shear)                     # 40o
        or      $object_2,$index,$hit                   # 41e
        lqd     $axis_3,128($a_shear)                   # 41o
        lqd     $axis_4,64($a_shear)                    # 42o
        shlqbii $face,$face,4                           # 43o
        lqd     $axis,112($a_shear)                     # 44o
        lqd     $axis_5,144($a_shear)                   # 45o
        lqd     $origin_2,256($a_shear)                 # 46o
        rotqbyi $vertex_c_2,$face,8                     # 47o
        rotqbyi $vertex_b_2,$face,4                     # 48o
        lqx     $vertex_a_2,$a_vertices,$face           # 49o
        lqd     $origin_3,320($a_shear)                 # 50o
        lqx     $vertex_c_3,$a_vertices,$vertex_c_2     # 51o
        lqx     $vertex_b_3,$a_vertices,$vertex_b_2     # 52o
        lqd     $axis_6,80($a_shear)                    # 53o
        lqd     $axis_7,48($a_shear)                    # 54o
        lqd     $axis_8,176($a_shear)                   # 55o
        lqd     $axis_9,16($a_shear)                    # 56o
        lqd     $origin_4,192($a_shear)                 # 57o
        shufb   $xb_2,$vertex_b_3,$vertex_b_3,$axis_2   # 58o
        shufb   $ya_2,$vertex_a_2,$vertex_a_2,$axis_4   # 59o
        shufb   $yc_2,$vertex_c_3,$vertex_c_3,$axis_4   # 60o
        shufb   $xc_2,$vertex_c_3,$vertex_c_3,$axis_2   # 61o
        nop     $127                                    # 62e pairing
        lqd     $origin_5,272($a_shear)                 # 62o
        fs      $ya_2,$ya_2,$origin_2                   # 63e
        shufb   $zc_2,$vertex_c_3,$vertex_c_3,$axis_3   # 63o
        fs      $xb_2,$xb_2,$origin_4                   # 64e
        shufb   $zb_2,$vertex_b_3,$vertex_b_3,$axis_3   # 64o
        fs      $xc_2,$xc_2,$origin_4                   # 65e
        lqd     $origin_6,208($a_shear)                 # 65o
        fs      $yc_2,$yc_2,$origin_2                   # 66e
        shufb   $za_2,$vertex_a_2,$vertex_a_2,$axis_3   # 66o
        fs      $zc_2,$zc_2,$origin_3                   # 67e
        lqd     $origin,240($a_shear)                   # 67o
        fs      $zb_2,$zb_2,$origin_3                   # 68e
        lqd     $origin_7,368($a_shear)                 # 68o
        nop     $127                                    # 69e pairing
        shufb   $xc_3,$vertex_c_3,$vertex_c_3,$axis_9   # 69o
        fs      $za_2,$za_2,$origin_3                   # 70e
        lqd     $slope_2,384($a_shear)                  # 70o
        shufb   $zc_3,$vertex_c_3,$vertex_c_3,$axis_5   # 71o
        shufb   $za_3,$vertex_a_2,$vertex_a_2,$axis_8   # 72o
        fs      $xc_3,$xc_3,$origin_6                   # 73e
        shufb   $yc_3,$vertex_c_3,$vertex_c_3,$axis_6   # 73o
        shufb   $zb_3,$vertex_b_3,$vertex_b_3,$axis_8   # 74o
        lqd     $origin_8,336($a_shear)                 # 75o
        fs      $za_4,$za_3,$origin_7                   # 76e
        lqd     $origin_9,304($a_shear)                 # 76o
        fnms    $xc_2,$slope_2,$zc_2,$xc_2              # 77e
        shufb   $xc_4,$vertex_c_3,$vertex_c_3,$axis_7   # 77o
        fs      $zb_3,$zb_3,$origin_7                   # 78e
        shufb   $xb_3,$vertex_b_3,$vertex_b_3,$axis_7   # 78o
        fs      $yc_3,$yc_3,$origin_5                   # 79e
        shufb   $zc_4,$vertex_c_3,$vertex_c_3,$axis_8   # 79o
        fnms    $xb_4,$slope_2,$zb_2,$xb_2              # 80e
        shufb   $ya_3,$vertex_a_2,$vertex_a_2,$axis_6   # 80o
        fs      $zc_3,$zc_3,$origin_8                   # 81e
        shufb   $za_5,$vertex_a_2,$vertex_a_2,$axis_5   # 81o
        fs      $xb_3,$xb_3,$origin                     # 82e
        shufb   $zb_4,$vertex_b_3,$vertex_b_3,$axis_5   # 82o
        fs      $xc_4,$xc_4,$origin                     # 83e
        shufb   $yc,$vertex_c_3,$vertex_c_3,$axis       # 83o
        fs      $ya_3,$ya_3,$origin_5                   # 84e
        shufb   $ya_4,$vertex_a_2,$vertex_a_2,$axis     # 84o
        fs      $za_6,$za_5,$origin_8                   # 85e
        shufb   $xb_5,$vertex_b_3,$vertex_b_3,$axis_9   # 85o
        fs      $zb_4,$zb_4,$origin_8                   # 86e
        lqd     $slope_3,448($a_shear)                  # 86o
        fs      $yc,$yc,$origin_9                       # 87e
        shufb   $xa_2,$vertex_a_2,$vertex_a_2,$axis_2   # 87o
        fs      $ya_4,$ya_4,$origin_9                   # 88e
        lqd     $slope_4,400($a_shear)                  # 88o
        fs      $zc_4,$zc_4,$origin_7                   # 89e
        lqd     $slope_5,464($a_shear)                  # 89o
        fs      $xb_5,$xb_5,$origin_6                   # 90e
        lqd     $slope_6,496($a_shear)                  # 90o
        fs      $xa_2,$xa_2,$origin_4                   # 91e
        shufb   $yb_2,$vertex_b_3,$vertex_b_3,$axis_4   # 91o
        fnms    $ya_2,$slope_3,$za_2,$ya_2              # 92e
        lqd     $slope_7,432($a_shear)                  # 92o
        fnms    $yc_2,$slope_3,$zc_2,$yc_2              # 93e
        shufb   $xa_3,$vertex_a_2,$vertex_a_2,$axis_7   # 93o
        fnms    $xc_3,$slope_4,$zc_3,$xc_3              # 94e
        shufb   $yb_3,$vertex_b_3,$vertex_b_3,$axis     # 94o
        fs      $yb_2,$yb_2,$origin_2                   # 95e
        shufb   $xa_4,$vertex_a_2,$vertex_a_2,$axis_9   # 95o
        fnms    $ya_4,$slope_6,$za_4,$ya_4              # 96e
        shufb   $yb_4,$vertex_b_3,$vertex_b_3,$axis_6   # 96o
        fs      $xa_5,$xa_3,$origin                     # 97e
        lqd     $axis_10,32($a_shear)                   # 97o
        fnms    $xb_3,$slope_7,$zb_3,$xb_3              # 98e
        lqd     $axis_7,96($a_shear)                    # 98o
        fs      $xa_6,$xa_4,$origin_6                   # 99e
        lqd     $axis_11,160($a_shear)                  # 99o
        fs      $yb_4,$yb_4,$origin_5                   # 100e
        lqd     $origin_10,352($a_shear)                # 100o
        fs      $yb_5,$yb_3,$origin_9                   # 101e
        lqd     $origin_5,224($a_shear)                 # 101o
        fnms    $yc,$slope_6,$zc_4,$yc                  # 102e
        lqd     $origin_11,288($a_shear)                # 102o
        fnms    $ya_5,$slope_5,$za_6,$ya_3              # 103e
        shufb   $xb_6,$vertex_b_3,$vertex_b_3,$axis_10  # 103o
        fnms    $xc_4,$slope_7,$zc_4,$xc_4              # 104e
        shufb   $yc_4,$vertex_c_3,$vertex_c_3,$axis_7   # 104o
        fnms    $xb_5,$slope_4,$zb_4,$xb_5              # 105e
        shufb   $zb_5,$vertex_b_3,$vertex_b_3,$axis_11  # 105o
        fnms    $yc_3,$slope_5,$zc_3,$yc_3              # 106e
        shufb   $zc_5,$vertex_c_3,$vertex_c_3,$axis_11  # 106o
        fm      $sum_2,$yc_2,$xb_4                      # 107e
        shufb   $ya_6,$vertex_a_2,$vertex_a_2,$axis_7   # 107o
        fnms    $xa_2,$slope_2,$za_2,$xa_2              # 108e
        shufb   $za_7,$vertex_a_2,$vertex_a_2,$axis_11  # 108o
        fnms    $yb_2,$slope_3,$zb_2,$yb_2              # 109e
        shufb   $xc_5,$vertex_c_3,$vertex_c_3,$axis_10  # 109o
        fm      $sum_3,$ya_2,$xc_2                      # 110e
        shufb   $yb_6,$vertex_b_3,$vertex_b_3,$axis_7   # 110o
        fnms    $yb_4,$slope_5,$zb_4,$yb_4              # 111e
        lqd     $slope_8,480($a_shear)                  # 111o
        fnms    $xa_5,$slope_7,$za_4,$xa_5              # 112e
        lqd     $slope_9,416($a_shear)                  # 112o
        fm      $sum_4,$yc,$xb_3                        # 113e
        shufb   $xa_7,$vertex_a_2,$vertex_a_2,$axis_10  # 113o
        fm      $sum_5,$ya_4,$xc_4                      # 114e
        lqd     $slope_7,512($a_shear)                  # 114o
        fnms    $xa_6,$slope_4,$za_6,$xa_6              # 115e
        lqd     $slope_10,560($a_shear)                 # 115o
        fnms    $yb_5,$slope_6,$zb_3,$yb_5              # 116e
        lqd     $slope_6,528($a_shear)                  # 116o
        fm      $sum_6,$yc_3,$xb_5                      # 117e
        lqd     $slope_11,544($a_shear)                 # 117o
        fm      $sum_7,$ya_5,$xc_3                      # 118e
        fms     $header_2,$ya_2,$xc_2,$sum_3            # 119e
        fms     $header_3,$yc_2,$xb_4,$sum_2            # 120e
        fms     $rest_2,$xc_2,$yb_2,$sum_2              # 121e
        fms     $v_2,$xa_2,$yc_2,$sum_3                 # 122e
        fm      $sum_8,$yb_2,$xa_2                      # 123e
        fms     $header_4,$yc,$xb_3,$sum_4              # 124e
        fms     $rest_3,$xc_4,$yb_5,$sum_4              # 125e
        fm      $sum_9,$yb_4,$xa_6                      # 126e
        fms     $v_3,$xa_5,$yc,$sum_5                   # 127e
        fms     $header_5,$ya_4,$xc_4,$sum_5            # 128e
        fms     $v_4,$xa_6,$yc_3,$sum_7                 # 129e
        fms     $header_6,$yc_3,$xb_5,$sum_6            # 130e
        fms     $header_7,$ya_5,$xc_3,$sum_7            # 131e
        fm      $sum_10,$yb_5,$xa_5                     # 132e
        fms     $rest_4,$xc_3,$yb_4,$sum_6              # 133e
        fms     $header_8,$yb_2,$xa_2,$sum_8            # 134e
        fs      $rest_5,$rest_2,$header_3               # 135e
        fs      $v_2,$v_2,$header_2                     # 136e
        fms     $w_2,$xb_4,$ya_2,$sum_8                 # 137e
        fs      $v_5,$v_3,$header_5                     # 138e
        fs      $rest_4,$rest_4,$header_6               # 139e
        fs      $rest_6,$rest_3,$header_4               # 140e
        fms     $header_9,$yb_5,$xa_5,$sum_10           # 141e
        fs      $v,$v_4,$header_7                       # 142e
        fms     $w_3,$xb_3,$ya_4,$sum_10                # 143e
        fms     $header_6,$yb_4,$xa_6,$sum_9            # 144e
        fms     $w_4,$xb_5,$ya_5,$sum_9                 # 145e
        fa      $det_2,$rest_5,$v_2                     # 146e
        fs      $w_5,$w_2,$header_8                     # 147e
        fs      $zb_5,$zb_5,$origin_10                  # 148e
        fs      $za_7,$za_7,$origin_10                  # 149e
        fa      $det_3,$rest_4,$v                       # 150e
        fs      $yc_4,$yc_4,$origin_11                  # 151e
        fs      $xc_5,$xc_5,$origin_5                   # 152e
        fs      $ya_6,$ya_6,$origin_11                  # 153e
        fs      $xb_7,$xb_6,$origin_5                   # 154e
        fs      $w_3,$w_3,$header_9                     # 155e
        fs      $zc_6,$zc_5,$origin_10                  # 156e
        fs      $w_6,$w_4,$header_6                     # 157e
        fa      $det_4,$rest_6,$v_5                     # 158e
        fa      $det_2,$det_2,$w_5                      # 159e
        fs      $xa_8,$xa_7,$origin_5                   # 160e
        fnms    $ya_7,$slope_8,$za_7,$ya_6              # 161e
        fnms    $xb_7,$slope_9,$zb_5,$xb_7              # 162e
        fnms    $xc_5,$slope_9,$zc_6,$xc_5              # 163e
        fa      $det_3,$det_3,$w_6                      # 164e
        lnop                                            # 164o pairing
        fs      $yb_6,$yb_6,$origin_11                  # 165e
        frest   $t_y_2,$det_2                           # 165o
        fnms    $yc,$slope_8,$zc_6,$yc_4                # 166e
        fa      $det_4,$det_4,$w_3                      # 167e
        fnms    $xa_8,$slope_9,$za_7,$xa_8              # 168e
        fm      $sum_11,$ya_7,$xc_5                     # 169e
        fi      $t_y_2,$det_2,$t_y_2                    # 170e
        frest   $t_y_3,$det_3                           # 170o
        xor     $seen_2,$det_2,$slope_7                 # 171e of -1 / direction z
        fm      $sum_12,$yc,$xb_7                       # 172e
        fnms    $yb_6,$slope_8,$zb_5,$yb_6              # 173e
        frest   $t_y_4,$det_4                           # 173o
        fi      $t_y_3,$det_3,$t_y_3                    # 174e
        xor     $seen_3,$det_3,$slope_6                 # 175e of -1 / direction z
        fms     $v_6,$xa_8,$yc,$sum_11                  # 176e
        fi      $t_y_4,$det_4,$t_y_4                    # 177e
        xor     $seen_4,$det_4,$slope_10                # 178e of -1 / direction z
        fms     $rest,$xc_5,$yb_6,$sum_12               # 179e
        fnms    $t_e_2,$det_2,$t_y_2,$k_above_one       # 180e
        fm      $sum_2,$yb_6,$xa_8                      # 181e
        fms     $header_10,$ya_7,$xc_5,$sum_11          # 182e
        fms     $header_11,$yc,$xb_7,$sum_12            # 183e
        fnms    $t_e_3,$det_3,$t_y_3,$k_above_one       # 184e
        fnms    $t_e_4,$det_4,$t_y_4,$k_above_one       # 185e
        fma     $inverse_2,$t_e_2,$t_y_2,$t_y_2         # 186e
        fms     $w_7,$xb_7,$ya_7,$sum_2                 # 187e
        fms     $header_12,$yb_6,$xa_8,$sum_2           # 188e
        fs      $rest,$rest,$header_11                  # 189e
        fs      $v_7,$v_6,$header_10                    # 190e
        fma     $inverse_3,$t_e_3,$t_y_3,$t_y_3         # 191e
        fma     $inverse_4,$t_e_4,$t_y_4,$t_y_4         # 192e
        fm      $rest_3,$rest_5,$inverse_2              # 193e
        fs      $w_8,$w_7,$header_12                    # 194e
        fm      $v_2,$v_2,$inverse_2                    # 195e
        fa      $det_5,$rest,$v_7                       # 196e
        fm      $rest_4,$rest_4,$inverse_3              # 197e
        fm      $rest_6,$rest_6,$inverse_4              # 198e
        fm      $ahead_2,$rest_3,$za_2                  # 199e
        fm      $v,$v,$inverse_3                        # 200e
        fm      $v_5,$v_5,$inverse_4                    # 201e
        fa      $det_6,$det_5,$w_8                      # 202e
        fm      $ahead_3,$rest_4,$za_6                  # 203e
        fm      $ahead_4,$rest_6,$za_4                  # 204e
        fma     $ahead_2,$v_2,$zb_2,$ahead_2            # 205e
        fm      $w_9,$w_5,$inverse_2                    # 206e
        fm      $w_10,$w_6,$inverse_3                   # 207e
        fm      $w_3,$w_3,$inverse_4                    # 208e
        frest   $t_y_5,$det_6                           # 208o
        fma     $ahead_5,$v,$zb_4,$ahead_3              # 209e
        fma     $ahead_6,$v_5,$zb_3,$ahead_4            # 210e
        or      $seen_5,$seen_3,$both                   # 211e
        fi      $t_y_5,$det_6,$t_y_5                    # 212e
        or      $outside_2,$rest_3,$v_2                 # 213e
        fma     $ahead_7,$w_9,$zc_2,$ahead_2            # 214e
        fma     $ahead_8,$w_10,$zc_3,$ahead_5           # 215e
        fma     $ahead_6,$w_3,$zc_4,$ahead_6            # 216e
        or      $seen_6,$seen_2,$both                   # 217e
        or      $seen_7,$seen_4,$both                   # 218e
        fnms    $t_e,$det_6,$t_y_5,$k_above_one         # 219e
        fm      $ahead,$ahead_7,$slope_7                # 220e
        or      $outside_3,$rest_4,$v                   # 221e
        fm      $ahead_5,$ahead_6,$slope_10             # 222e
        or      $outside_4,$rest_6,$v_5                 # 223e
        fm      $ahead_8,$ahead_8,$slope_6              # 224e
        fma     $inverse,$t_e,$t_y_5,$t_y_5             # 225e
        or      $outside_4,$outside_4,$w_3              # 226e
        xor     $t_2,$ahead,$k_sign                     # 227e
        orc     $outside_5,$outside_4,$seen_7           # 228e
        cgt     $control,$t_best_3,$t_2                 # 229e
        xor     $seen_8,$det_6,$slope_11                # 230e of -1 / direction z
        or      $outside_6,$outside_3,$w_10             # 231e
        or      $outside_2,$outside_2,$w_9              # 232e
        or      $seen_8,$seen_8,$both                   # 233e
        orc     $outside,$outside_6,$seen_5             # 234e
        orc     $outside_2,$outside_2,$seen_6           # 235e
        lnop                                            # 235o pairing
next_triangle:
            xor     $t,$ahead_8,$k_sign                 # 0e
        lqd     $candidate,0($a_candidate)              # 0o
            and     $control,$control,$ahead            # 1e
            cgt     $control_2,$t_best_2,$t             # 2e
            andc    $control,$control,$outside_2        # 3e
            lqd     $nearest,448($a_packet_2)           # 3o
        ai      $at_2,$at,4                             # 4e
            lqd     $t_best,416($a_packet_2)            # 4o
            and     $control_2,$control_2,$ahead_8      # 5e
            rotqbii $control,$control,1                 # 5o
        andi    $index,$candidate,511                   # 6e 4 times it
            lqd     $t_best_4,432($a_packet_2)          # 6o
            andc    $control_2,$control_2,$outside      # 7e
        rotqbyi $a_shear,$candidate,8                   # 7o
            fm      $rest,$rest,$inverse                # 8e
            lqd     $nearest_2,480($a_packet_2)         # 8o
            fm      $v,$v_7,$inverse                    # 9e
            rotqbii $control_2,$control_2,1             # 9o
            fm      $w,$w_8,$inverse                    # 10e
            gb      $control,$control                   # 10o
        a       $index,$index,$at                       # 11e
            lqd     $nearest_3,464($a_packet_2)         # 11o
        ai      $triangles,$triangles,-1                # 12e
            lqd     $nearest_4,496($a_packet_2)         # 12o
        a       $vertex_a,$a_faces,$index               # 13e
            gb      $control_2,$control_2               # 13o
            fm      $ahead,$rest,$za_7                  # 14e
        lqx     $face,$a_faces,$index                   # 14o
            or      $outside,$rest,$v                   # 15e
        lqd     $a_shear,192($a_shear)                  # 15o
            xor     $t_3,$ahead_5,$k_sign               # 16e
        rotqmbii $index,$index,-2                       # 16o
            or      $outside,$outside,$w                # 17e
        rotqmbyi $ends,$candidate,-1                    # 17o 4 times the run's length
            cgt     $control_3,$t_best_4,$t_3           # 18e
            shlqbii $control,$control,4                 # 18o
            orc     $outside,$outside,$seen_8           # 19e
            shlqbii $control_2,$control_2,4             # 19o
            and     $control_3,$control_3,$ahead_5      # 20e
        rotqby  $face,$face,$vertex_a                   # 20o
            fma     $ahead,$v,$zb_5,$ahead              # 21e
        rotqbyi $a_shear,$a_shear,8                     # 21o
            andc    $control_3,$control_3,$outside_5    # 22e
        shufb   $index,$index,$index,$m_splat           # 22o
            lqx     $control_2,$control_2,$a_controls   # 23o
            rotqbii $control_3,$control_3,1             # 24o
        nop     $127                                    # 25e pairing
        shufb   $face,$face,$face,$m_indices            # 25o
            fma     $ahead,$w,$zc_6,$ahead              # 27e
            lqx     $control,$control,$a_controls       # 27o
            gb      $control_3,$control_3               # 28o
        lqd     $origin,240($a_shear)                   # 29o
            shufb   $nearest_3,$nearest_3,$object_2,$control_2 # 30o
            shufb   $t_best_5,$t_best_2,$t,$control_2   # 31o
        nop     $127                                    # 32e pairing
        lqd     $origin_8,336($a_shear)                 # 32o
            fm      $ahead,$ahead,$slope_11             # 33e
            shufb   $t_best_6,$t_best_3,$t_2,$control   # 33o
            stqd    $nearest_3,464($a_packet_2)         # 34o
            shlqbii $control_4,$control_3,4             # 35o
            stqd    $t_best_5,400($a_packet_2)          # 36o
        shlqbii $face,$face,4                           # 37o
        nop     $127                                    # 38e pairing
        lqd     $axis,112($a_shear)                     # 38o
            xor     $t,$ahead,$k_sign                   # 39e
            stqd    $t_best_6,384($a_packet_2)          # 39o
        nop     $127                                    # 40e pairing
        lqd     $axis_6,80($a_shear)                    # 40o
            cgt     $control_3,$t_best,$t               # 41e
            lqx     $control_4,$control_4,$a_controls   # 41o
        nop     $127                                    # 42e pairing
        lqd     $axis_5,144($a_shear)                   # 42o
            and     $control_3,$control_3,$ahead        # 43e
        lqd     $axis_7,48($a_shear)                    # 43o
        nop     $127                                    # 44e pairing
        lqd     $origin_9,304($a_shear)                 # 44o
            andc    $control_3,$control_3,$outside      # 45e
        lqd     $axis_12,96($a_shear)                   # 45o
        rotqbyi $vertex_b_2,$face,4                     # 46o
            shufb   $t_best_4,$t_best_4,$t_3,$control_4 # 47o
        lqx     $vertex_a_2,$a_vertices,$face           # 48o
        rotqbyi $vertex_c_4,$face,8                     # 49o
        lqd     $axis_4,64($a_shear)                    # 50o
            stqd    $t_best_4,432($a_packet_2)          # 51o
            shufb   $nearest_5,$nearest_4,$object_2,$control_4 # 52o
        lqd     $axis_8,176($a_shear)                   # 53o
        lqx     $vertex_c_3,$a_vertices,$vertex_c_4     # 54o
        shufb   $za,$vertex_a_2,$vertex_a_2,$axis_5     # 55o
            rotqbii $control_3,$control_3,1             # 56o
        lqx     $vertex_b_3,$a_vertices,$vertex_b_2     # 57o
        nop     $127                                    # 58e pairing
        shufb   $xa,$vertex_a_2,$vertex_a_2,$axis_7     # 58o
        fs      $za,$za,$origin_8                       # 59e
        lqd     $origin_5,272($a_shear)                 # 59o
        lqd     $axis_13,160($a_shear)                  # 60o
        shufb   $yc,$vertex_c_3,$vertex_c_3,$axis       # 61o
        fs      $xa,$xa,$origin                         # 62e
        lqd     $origin_2,256($a_shear)                 # 62o
        shufb   $yb_4,$vertex_b_3,$vertex_b_3,$axis_6   # 63o
        shufb   $yb_2,$vertex_b_3,$vertex_b_3,$axis_4   # 64o
        fs      $yc,$yc,$origin_9                       # 65e
        lqd     $origin_7,368($a_shear)                 # 65o
        nop     $127                                    # 66e pairing
        lqd     $axis_9,16($a_shear)                    # 66o
        fs      $yb_4,$yb_4,$origin_5                   # 67e
        shufb   $xc_4,$vertex_c_3,$vertex_c_3,$axis_7   # 67o
        fs      $yb_2,$yb_2,$origin_2                   # 68e
        shufb   $xb_8,$vertex_b_3,$vertex_b_3,$axis_7   # 68o
        shufb   $ya_4,$vertex_a_2,$vertex_a_2,$axis     # 69o
        shufb   $ya_2,$vertex_a_2,$vertex_a_2,$axis_4   # 70o
        fs      $xc_4,$xc_4,$origin                     # 71e
        shufb   $zc_4,$vertex_c_3,$vertex_c_3,$axis_8   # 71o
        fs      $xb_8,$xb_8,$origin                     # 72e
        shufb   $xa_6,$vertex_a_2,$vertex_a_2,$axis_9   # 72o
        fs      $ya_4,$ya_4,$origin_9                   # 73e
        lqd     $axis_3,128($a_shear)                   # 73o
        fs      $ya_2,$ya_2,$origin_2                   # 74e
        lqd     $origin_3,320($a_shear)                 # 74o
        fs      $zc_4,$zc_4,$origin_7                   # 75e
        shufb   $zb_5,$vertex_b_3,$vertex_b_3,$axis_13  # 75o
        shufb   $xb_5,$vertex_b_3,$vertex_b_3,$axis_9   # 76o
        shufb   $xc_6,$vertex_c_3,$vertex_c_3,$axis_9   # 77o
        lqd     $origin_11,288($a_shear)                # 78o
        shufb   $zc_2,$vertex_c_3,$vertex_c_3,$axis_3   # 79o
        shufb   $zb_4,$vertex_b_3,$vertex_b_3,$axis_5   # 80o
        shufb   $yc_4,$vertex_c_3,$vertex_c_3,$axis_12  # 81o
        lqd     $axis_2,0($a_shear)                     # 82o
        shufb   $yc_5,$vertex_c_3,$vertex_c_3,$axis_4   # 83o
        fs      $zc_2,$zc_2,$origin_3                   # 84e
        shufb   $zb_2,$vertex_b_3,$vertex_b_3,$axis_3   # 84o
        fs      $yc_4,$yc_4,$origin_11                  # 85e
        lqd     $origin_6,208($a_shear)                 # 85o
        fs      $zb_4,$zb_4,$origin_8                   # 86e
        lqd     $axis_10,32($a_shear)                   # 86o
        fs      $yc_5,$yc_5,$origin_2                   # 87e
        lqd     $slope_12,432($a_shear)                 # 87o
        fs      $zb_2,$zb_2,$origin_3                   # 88e
        lqd     $slope_3,448($a_shear)                  # 88o
        lqd     $origin_4,192($a_shear)                 # 89o
        shufb   $xc_2,$vertex_c_3,$vertex_c_3,$axis_2   # 90o
        fs      $xb_5,$xb_5,$origin_6                   # 91e
        shufb   $ya_6,$vertex_a_2,$vertex_a_2,$axis_12  # 91o
        fs      $xc_6,$xc_6,$origin_6                   # 92e
        shufb   $xb_2,$vertex_b_3,$vertex_b_3,$axis_2   # 92o
        fnms    $xc_4,$slope_12,$zc_4,$xc_4             # 93e
        lqd     $slope_2,384($a_shear)                  # 93o
        fnms    $yc_5,$slope_3,$zc_2,$yc_5              # 94e
        lqd     $origin_10,352($a_shear)                # 94o
        fs      $xa_6,$xa_6,$origin_6                   # 95e
        lqd     $slope_13,400($a_shear)                 # 95o
        fs      $xb_2,$xb_2,$origin_4                   # 96e
        shufb   $yb_7,$vertex_b_3,$vertex_b_3,$axis_12  # 96o
        fnms    $yb_2,$slope_3,$zb_2,$yb_2              # 97e
        shufb   $za_7,$vertex_a_2,$vertex_a_2,$axis_13  # 97o
        fs      $ya_6,$ya_6,$origin_11                  # 98e
        shufb   $ya_3,$vertex_a_2,$vertex_a_2,$axis_6   # 98o
        fs      $xc_2,$xc_2,$origin_4                   # 99e
        shufb   $yb_3,$vertex_b_3,$vertex_b_3,$axis     # 99o
        fs      $zb_5,$zb_5,$origin_10                  # 100e
        shufb   $za_2,$vertex_a_2,$vertex_a_2,$axis_3   # 100o
        fnms    $xb_5,$slope_13,$zb_4,$xb_5             # 101e
        shufb   $zc_7,$vertex_c_3,$vertex_c_3,$axis_5   # 101o
        fs      $ya_3,$ya_3,$origin_5                   # 102e
        shufb   $za_3,$vertex_a_2,$vertex_a_2,$axis_8   # 102o
        fs      $za_7,$za_7,$origin_10                  # 103e
        lnop                                            # 103o pairing
        fs      $za_2,$za_2,$origin_3                   # 104e
        shufb   $yc_6,$vertex_c_3,$vertex_c_3,$axis_6   # 104o
        fs      $zc_8,$zc_7,$origin_8                   # 105e
        lqd     $origin_12,224($a_shear)                # 105o
        fs      $za_4,$za_3,$origin_7                   # 106e
        lqd     $slope_5,464($a_shear)                  # 106o
        fnms    $xc_2,$slope_2,$zc_2,$xc_2              # 107e
        shufb   $xa_7,$vertex_a_2,$vertex_a_2,$axis_10  # 107o
        fs      $yc_6,$yc_6,$origin_5                   # 108e
        shufb   $zb_6,$vertex_b_3,$vertex_b_3,$axis_8   # 108o
        fs      $yb_7,$yb_7,$origin_11                  # 109e
        lqd     $slope_14,496($a_shear)                 # 109o
        fs      $yb_5,$yb_3,$origin_9                   # 110e
        shufb   $xa_9,$vertex_a_2,$vertex_a_2,$axis_2   # 110o
        fnms    $xb_6,$slope_2,$zb_2,$xb_2              # 111e
        shufb   $xb_9,$vertex_b_3,$vertex_b_3,$axis_10  # 111o
        fnms    $yb_4,$slope_5,$zb_4,$yb_4              # 112e
            gb      $control_3,$control_3               # 112o
        fnms    $ya_2,$slope_3,$za_2,$ya_2              # 113e
        lnop                                            # 113o pairing
        fs      $xa_10,$xa_7,$origin_12                 # 114e
        lqd     $slope_8,480($a_shear)                  # 114o
        fnms    $ya_4,$slope_14,$za_4,$ya_4             # 115e
        lnop                                            # 115o pairing
        fnms    $yc_6,$slope_5,$zc_8,$yc_6              # 116e
            shlqbii $control_3,$control_3,4             # 116o
        fnms    $yc,$slope_14,$zc_4,$yc                 # 117e
            shufb   $nearest,$nearest,$object_2,$control # 117o
        fs      $zb_6,$zb_6,$origin_7                   # 118e
        shufb   $xc_7,$vertex_c_3,$vertex_c_3,$axis_10  # 118o
        fs      $xa_9,$xa_9,$origin_4                   # 119e
        shufb   $zc_9,$vertex_c_3,$vertex_c_3,$axis_13  # 119o
        fnms    $yb,$slope_8,$zb_5,$yb_7                # 120e
            lqx     $control,$control_3,$a_controls     # 120o
        fm      $sum_13,$ya_4,$xc_4                     # 121e
            stqd    $nearest,448($a_packet_2)           # 121o
        fm      $sum_14,$yc_5,$xb_6                     # 122e
            stqd    $nearest_5,496($a_packet_2)         # 122o
        fnms    $xc_3,$slope_13,$zc_8,$xc_6             # 123e
        lnop                                            # 123o pairing
        fs      $xb_9,$xb_9,$origin_12                  # 124e
        rotqmbii $ends,$ends,-6                         # 124o
        fnms    $ya_8,$slope_8,$za_7,$ya_6              # 125e
        lqd     $slope_9,416($a_shear)                  # 125o
        fnms    $xa_6,$slope_13,$za,$xa_6               # 126e
            shufb   $t_best,$t_best,$t,$control         # 126o
        fnms    $xa,$slope_12,$za_4,$xa                 # 127e
            shufb   $nearest_2,$nearest_2,$object_2,$control # 127o
        fs      $xc_8,$xc_7,$origin_12                  # 128e
        fnms    $ya_5,$slope_5,$za,$ya_3                # 129e
        fnms    $xa_9,$slope_2,$za_2,$xa_9              # 130e
            stqd    $t_best,416($a_packet_2)            # 130o
        fnms    $xb_9,$slope_9,$zb_5,$xb_9              # 131e
            stqd    $nearest_2,480($a_packet_2)         # 131o
        fms     $rest_7,$xc_2,$yb_2,$sum_14             # 132e
        rotqbyi $a_packet_2,$candidate,4                # 132o
        fs      $zc_6,$zc_9,$origin_10                  # 133e
        fnms    $xb_10,$slope_12,$zb_6,$xb_8            # 134e
        fnms    $xa_11,$slope_9,$za_7,$xa_10            # 135e
        fm      $sum_4,$ya_2,$xc_2                      # 136e
        fnms    $yb_5,$slope_14,$zb_6,$yb_5             # 137e
        fm      $sum_15,$yc_6,$xb_5                     # 138e
        fnms    $xc_8,$slope_9,$zc_6,$xc_8              # 139e
        fnms    $yc_7,$slope_8,$zc_6,$yc_4              # 140e
        fm      $sum_16,$ya_5,$xc_3                     # 141e
        fm      $sum_17,$yc,$xb_10                      # 142e
        fm      $sum_2,$yb,$xa_11                       # 143e
        fms     $v_8,$xa_9,$yc_5,$sum_4                 # 144e
        fms     $rest_8,$xc_3,$yb_4,$sum_15             # 145e
        fm      $sum_11,$ya_8,$xc_8                     # 146e
        fms     $v_9,$xa,$yc,$sum_13                    # 147e
        fm      $sum_8,$yb_2,$xa_9                      # 148e
        fms     $header_11,$yc,$xb_10,$sum_17           # 149e
        fms     $header_6,$ya_4,$xc_4,$sum_13           # 150e
        fms     $header_13,$ya_2,$xc_2,$sum_4           # 151e
        fms     $header_14,$yc_5,$xb_6,$sum_14          # 152e
        fms     $header_15,$yb,$xa_11,$sum_2            # 153e
        fms     $v_10,$xa_6,$yc_6,$sum_16               # 154e
        fms     $header_16,$yc_6,$xb_5,$sum_15          # 155e
        fms     $header_17,$ya_5,$xc_3,$sum_16          # 156e
        fms     $rest_9,$xc_4,$yb_5,$sum_17             # 157e
        fms     $v_11,$xa_11,$yc_7,$sum_11              # 158e
        fs      $rest_7,$rest_7,$header_14              # 159e
        fs      $v_12,$v_9,$header_6                    # 160e
        fs      $v_13,$v_8,$header_13                   # 161e
        fm      $sum_14,$yb_4,$xa_6                     # 162e
        fs      $rest_10,$rest_8,$header_16             # 163e
        fms     $header,$ya_8,$xc_8,$sum_11             # 164e
        fm      $sum_16,$yb_5,$xa                       # 165e
        fms     $header_5,$yb_2,$xa_9,$sum_8            # 166e
        fms     $w_2,$xb_6,$ya_2,$sum_8                 # 167e
        fms     $w_11,$xb_9,$ya_8,$sum_2                # 168e
        fs      $v,$v_10,$header_17                     # 169e
        fs      $rest_4,$rest_9,$header_11              # 170e
        fms     $header_9,$yb_5,$xa,$sum_16             # 171e
        fms     $w_10,$xb_10,$ya_4,$sum_16              # 172e
        fms     $header_18,$yb_4,$xa_6,$sum_14          # 173e
        fms     $w_12,$xb_5,$ya_5,$sum_14               # 174e
        fa      $det_7,$rest_7,$v_13                    # 175e
        fs      $w_13,$w_2,$header_5                    # 176e
        fm      $sum,$yc_7,$xb_9                        # 177e
        fs      $w_10,$w_10,$header_9                   # 178e
        fa      $det_8,$rest_10,$v                      # 179e
        fs      $w_12,$w_12,$header_18                  # 180e
        fs      $w_8,$w_11,$header_15                   # 181e
        lnop                                            # 181o pairing
        fa      $det_9,$det_7,$w_13                     # 182e
        lqd     $slope,512($a_shear)                    # 182o
        fa      $det_7,$rest_4,$v_12                    # 183e
        fms     $rest,$xc_8,$yb,$sum                    # 184e
        fms     $header_12,$yc_7,$xb_9,$sum             # 185e
        fa      $det_10,$det_8,$w_12                    # 186e
        fs      $v_7,$v_11,$header                      # 187e
        lqd     $slope_15,528($a_shear)                 # 187o
        xor     $seen_9,$det_9,$slope                   # 188e of -1 / direction z
        frest   $t_y_6,$det_9                           # 188o
        fa      $det_7,$det_7,$w_10                     # 189e
        lqd     $slope_16,560($a_shear)                 # 189o
        or      $seen_9,$seen_9,$both                   # 190e
        fs      $rest,$rest,$header_12                  # 191e
        fi      $t_y_7,$det_9,$t_y_6                    # 192e
        frest   $t_y_6,$det_10                          # 192o
        xor     $seen_5,$det_10,$slope_15               # 193e of -1 / direction z
        cgt     $more,$ends,$at_2                       # 194e
        xor     $seen_7,$det_7,$slope_16                # 195e of -1 / direction z
        frest   $t_y_8,$det_7                           # 195o
        or      $seen_5,$seen_5,$both                   # 196e
        fa      $det_5,$rest,$v_7                       # 197e
        fi      $t_y_6,$det_10,$t_y_6                   # 198e
        fi      $t_y_8,$det_7,$t_y_8                    # 199e
        or      $seen_7,$seen_7,$both                   # 200e
        fnms    $t_e,$det_9,$t_y_7,$k_above_one         # 201e
        andc    $ends,$k_step,$more                     # 202e
        lnop                                            # 202o pairing
        fa      $det_9,$det_5,$w_8                      # 203e
        lqd     $slope_11,544($a_shear)                 # 203o
        or      $object_2,$index,$hit                   # 204e
        fnms    $t_e_4,$det_10,$t_y_6,$k_above_one      # 205e
        fnms    $t_e_2,$det_7,$t_y_8,$k_above_one       # 206e
        fma     $inverse_5,$t_e,$t_y_7,$t_y_7           # 207e
        a       $a_candidate,$a_candidate,$ends         # 208e
        lnop                                            # 208o pairing
        xor     $seen_8,$det_9,$slope_11                # 209e of -1 / direction z
        frest   $t_y_9,$det_9                           # 209o
        and     $at,$at_2,$more                         # 210e
        fma     $inverse_6,$t_e_4,$t_y_6,$t_y_6         # 211e
        fma     $inverse_4,$t_e_2,$t_y_8,$t_y_8         # 212e
        fm      $rest_7,$rest_7,$inverse_5              # 213e
        or      $seen_8,$seen_8,$both                   # 214e
        fm      $v_14,$v_13,$inverse_5                  # 215e
        fm      $w_13,$w_13,$inverse_5                  # 216e
        fm      $v,$v,$inverse_6                        # 217e
        fm      $rest_10,$rest_10,$inverse_6            # 218e
        fm      $rest_4,$rest_4,$inverse_4              # 219e
        fm      $v_12,$v_12,$inverse_4                  # 220e
        fm      $w_14,$w_12,$inverse_6                  # 221e
        fm      $w_10,$w_10,$inverse_4                  # 222e
        fm      $ahead,$rest_7,$za_2                    # 223e
        or      $outside_3,$rest_10,$v                  # 224e
        fm      $ahead_9,$rest_10,$za                   # 225e
        fm      $ahead_2,$rest_4,$za_4                  # 226e
        fi      $t_y_10,$det_9,$t_y_9                   # 227e
        or      $outside_4,$rest_4,$v_12                # 228e
        or      $outside_7,$rest_7,$v_14                # 229e
        fma     $ahead,$v_14,$zb_2,$ahead               # 230e
        or      $outside_4,$outside_4,$w_10             # 231e
        fma     $ahead_10,$v_12,$zb_6,$ahead_2          # 232e
        lnop                                            # 232o pairing
        fma     $ahead_9,$v,$zb_4,$ahead_9              # 233e
        hbrr    next_triangle_back,next_triangle        # 233o hint
        fnms    $t_e,$det_9,$t_y_10,$k_above_one        # 234e
        or      $outside_6,$outside_3,$w_14             # 235e
        fma     $ahead,$w_13,$zc_2,$ahead               # 236e
        orc     $outside,$outside_6,$seen_5             # 237e
        fma     $ahead_10,$w_10,$zc_4,$ahead_10         # 238e
        fma     $ahead_9,$w_14,$zc_8,$ahead_9           # 239e
        or      $outside_2,$outside_7,$w_13             # 240e
        fma     $inverse,$t_e,$t_y_10,$t_y_10           # 241e
        fm      $ahead,$ahead,$slope                    # 242e
        orc     $outside_2,$outside_2,$seen_9           # 243e
        fm      $ahead_5,$ahead_10,$slope_16            # 244e
        lqd     $t_best_3,384($a_packet_2)              # 244o
        fm      $ahead_8,$ahead_9,$slope_15             # 245e
        orc     $outside_5,$outside_4,$seen_7           # 246e
        lqd     $t_best_2,400($a_packet_2)              # 247o
        xor     $t_2,$ahead,$k_sign                     # 248e
        cgt     $control,$t_best_3,$t_2                 # 250e
next_triangle_back:
        brnz    $triangles,next_triangle                # 250o
next_triangle_drain:
        fm      $rest,$rest,$inverse                    # 0e
        lqd     $t_best_4,432($a_packet_2)              # 0o
        xor     $t,$ahead_8,$k_sign                     # 1e
        lqd     $t_best,416($a_packet_2)                # 1o
        fm      $v,$v_7,$inverse                        # 2e
        lqd     $nearest_3,464($a_packet_2)             # 2o
        cgt     $control_2,$t_best_2,$t                 # 3e
        lqd     $nearest,448($a_packet_2)               # 3o
        and     $control,$control,$ahead                # 4e
        lqd     $nearest_4,480($a_packet_2)             # 4o
        and     $control_2,$control_2,$ahead_8          # 5e
        lqd     $nearest_2,496($a_packet_2)             # 5o
        fm      $ahead,$rest,$za_7                      # 6e
        hbr     isect_mesh_pairs_r16_return,$lr         # 6o hint
        andc    $control_2,$control_2,$outside          # 7e
        fm      $w,$w_8,$inverse                        # 8e
        andc    $control,$control,$outside_2            # 9e
        rotqbii $control_2,$control_2,1                 # 9o
        xor     $t_3,$ahead_5,$k_sign                   # 10e
        lnop                                            # 10o pairing
        or      $outside,$rest,$v                       # 11e
        rotqbii $control,$control,1                     # 11o
        fma     $ahead,$v,$zb_5,$ahead                  # 12e
        lnop                                            # 12o pairing
        cgt     $control_3,$t_best_4,$t_3               # 13e
        gb      $control_2,$control_2                   # 13o
        or      $outside,$outside,$w                    # 14e
        lnop                                            # 14o pairing
        and     $control_3,$control_3,$ahead_5          # 15e
        gb      $control,$control                       # 15o
        orc     $outside,$outside,$seen_8               # 16e
        lnop                                            # 16o pairing
        andc    $control_3,$control_3,$outside_5        # 17e
        shlqbii $control_2,$control_2,4                 # 17o
        fma     $ahead,$w,$zc_6,$ahead                  # 18e
        shlqbii $control,$control,4                     # 19o
        rotqbii $control_3,$control_3,1                 # 20o
        lqx     $control_2,$control_2,$a_controls       # 21o
        nop     $127                                    # 22e pairing
        lqx     $control,$control,$a_controls           # 23o
        fm      $ahead,$ahead,$slope_11                 # 24e
        gb      $control_3,$control_3                   # 24o
        shufb   $nearest_3,$nearest_3,$object_2,$control_2 # 27o
        shufb   $t_best_5,$t_best_2,$t,$control_2       # 28o
        nop     $127                                    # 29e pairing
        shufb   $t_best_6,$t_best_3,$t_2,$control       # 29o
        xor     $t,$ahead,$k_sign                       # 30e
        shlqbii $control_5,$control_3,4                 # 30o
        nop     $127                                    # 31e pairing
        stqd    $nearest_3,464($a_packet_2)             # 31o
        cgt     $control_3,$t_best,$t                   # 32e
        stqd    $t_best_5,400($a_packet_2)              # 32o
        nop     $127                                    # 33e pairing
        stqd    $t_best_6,384($a_packet_2)              # 33o
        and     $control_3,$control_3,$ahead            # 34e
        lqx     $control_4,$control_5,$a_controls       # 34o
        shufb   $nearest,$nearest,$object_2,$control    # 35o
        andc    $control_3,$control_3,$outside          # 36e
        rotqbii $control_3,$control_3,1                 # 38o
        shufb   $t_best_4,$t_best_4,$t_3,$control_4     # 40o
        shufb   $nearest_6,$nearest_2,$object_2,$control_4 # 41o
        gb      $control_3,$control_3                   # 42o
        stqd    $t_best_4,432($a_packet_2)              # 44o
        shlqbii $control_3,$control_3,4                 # 46o
        lqx     $control,$control_3,$a_controls         # 50o
        stqd    $nearest,448($a_packet_2)               # 51o
        stqd    $nearest_6,496($a_packet_2)             # 52o
        shufb   $t_best,$t_best,$t,$control             # 56o
        shufb   $nearest_2,$nearest_4,$object_2,$control # 57o
        stqd    $t_best,416($a_packet_2)                # 60o
        stqd    $nearest_2,480($a_packet_2)             # 61o
isect_mesh_pairs_r16_return:
        bi      $lr                                     # 62o
next_run_drain_2:
        rotmi   $candidate_3,$candidate,-16             # 0e
        a       $a_first,$a_first,$candidate_4          # 1e
        a       $a_first,$a_first,$candidate_3          # 4e
        br      isect_mesh_pairs_r16_block              # 4o
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
        lqd     $t_best,416($a_packet)                  # 12o
        lqd     $t_best_7,384($a_packet)                # 13o
        lqd     $t_best_4,400($a_packet)                # 14o
        lqd     $t_best_8,432($a_packet)                # 15o
        rotqby  $face,$face,$vertex_a                   # 16o
        rotqbyi $a_shear,$a_shear,8                     # 17o
        rotqmbii $index,$index,-2                       # 18o
        lqd     $nearest,448($a_packet)                 # 19o
        shufb   $face,$face,$face,$m_indices            # 20o
        lqd     $axis,96($a_shear)                      # 21o
        lqd     $axis_8,128($a_shear)                   # 22o
        lqd     $origin,224($a_shear)                   # 23o
        shlqbii $face,$face,4                           # 24o
        lqd     $axis_14,0($a_shear)                    # 25o
        lqd     $axis_15,64($a_shear)                   # 26o
        lqd     $origin_13,208($a_shear)                # 27o
        rotqbyi $vertex_c,$face,8                       # 28o
        rotqbyi $vertex_b,$face,4                       # 29o
        lqx     $vertex_a,$a_vertices,$face             # 30o
        lqd     $origin_14,336($a_shear)                # 31o
        lqx     $vertex_c,$a_vertices,$vertex_c         # 32o
        lqd     $axis_16,32($a_shear)                   # 33o
        lqd     $origin_15,320($a_shear)                # 34o
        lqd     $origin_12,272($a_shear)                # 35o
        lqd     $axis_17,16($a_shear)                   # 36o
        shufb   $ya,$vertex_a,$vertex_a,$axis_15        # 37o
        lqd     $axis_18,160($a_shear)                  # 38o
        lqx     $vertex_b,$a_vertices,$vertex_b         # 39o
        lqd     $origin_5,256($a_shear)                 # 40o
        shufb   $yc,$vertex_c,$vertex_c,$axis_15        # 41o
        lqd     $axis_13,80($a_shear)                   # 42o
        shufb   $ya_9,$vertex_a,$vertex_a,$axis         # 43o
        shufb   $za_8,$vertex_a,$vertex_a,$axis_18      # 44o
        nop     $127                                    # 45e pairing
        shufb   $xb_11,$vertex_b,$vertex_b,$axis_16     # 45o
        fs      $yc,$yc,$origin_5                       # 46e
        shufb   $xb_12,$vertex_b,$vertex_b,$axis_17     # 46o
        fs      $ya,$ya,$origin_5                       # 47e
        shufb   $za_9,$vertex_a,$vertex_a,$axis_8       # 47o
        nop     $127                                    # 48e pairing
        lqd     $axis_19,144($a_shear)                  # 48o
        fs      $xb_11,$xb_11,$origin                   # 49e
        shufb   $yc_8,$vertex_c,$vertex_c,$axis_13      # 49o
        fs      $xb_12,$xb_12,$origin_13                # 50e
        lqd     $origin_16,288($a_shear)                # 50o
        fs      $za_9,$za_9,$origin_15                  # 51e
        shufb   $zb_7,$vertex_b,$vertex_b,$axis_18      # 51o
        nop     $127                                    # 52e pairing
        shufb   $xb_13,$vertex_b,$vertex_b,$axis_14     # 52o
        fs      $yc_8,$yc_8,$origin_12                  # 53e
        lqd     $slope_17,400($a_shear)                 # 53o
        shufb   $za_10,$vertex_a,$vertex_a,$axis_19     # 54o
        shufb   $zc_10,$vertex_c,$vertex_c,$axis_19     # 55o
        fs      $ya_9,$ya_9,$origin_16                  # 56e
        shufb   $zb_8,$vertex_b,$vertex_b,$axis_19      # 56o
        nop     $127                                    # 57e pairing
        shufb   $zc_11,$vertex_c,$vertex_c,$axis_18     # 57o
        fs      $za_10,$za_10,$origin_14                # 58e
        lqd     $origin_11,192($a_shear)                # 58o
        fs      $zc_10,$zc_10,$origin_14                # 59e
        shufb   $yb_8,$vertex_b,$vertex_b,$axis_15      # 59o
        fs      $zb_9,$zb_8,$origin_14                  # 60e
        shufb   $yb_9,$vertex_b,$vertex_b,$axis         # 60o
        shufb   $zb_10,$vertex_b,$vertex_b,$axis_8      # 61o
        shufb   $xc_9,$vertex_c,$vertex_c,$axis_17      # 62o
        fs      $yb_8,$yb_8,$origin_5                   # 63e
        shufb   $xa_12,$vertex_a,$vertex_a,$axis_16     # 63o
        fs      $xb_13,$xb_13,$origin_11                # 64e
        shufb   $xc_10,$vertex_c,$vertex_c,$axis_16     # 64o
        fs      $zb_10,$zb_10,$origin_15                # 65e
        lqd     $origin_17,352($a_shear)                # 65o
        fs      $yb_9,$yb_9,$origin_16                  # 66e
        lqd     $slope_10,416($a_shear)                 # 66o
        fs      $xc_9,$xc_9,$origin_13                  # 67e
        shufb   $xc_11,$vertex_c,$vertex_c,$axis_14     # 67o
        fs      $xc_10,$xc_10,$origin                   # 68e
        lqd     $slope_8,384($a_shear)                  # 68o
        fnms    $xb_12,$slope_17,$zb_9,$xb_12           # 69e
        shufb   $ya_10,$vertex_a,$vertex_a,$axis_13     # 69o
        fs      $xa_12,$xa_12,$origin                   # 70e
        shufb   $yb,$vertex_b,$vertex_b,$axis_13        # 70o
        fs      $zb_11,$zb_7,$origin_17                 # 71e
        shufb   $yc_9,$vertex_c,$vertex_c,$axis         # 71o
        fs      $za_8,$za_8,$origin_17                  # 72e
        shufb   $zc_12,$vertex_c,$vertex_c,$axis_8      # 72o
        fs      $ya_11,$ya_10,$origin_12                # 73e
        shufb   $xa,$vertex_a,$vertex_a,$axis_17        # 73o
        fs      $zc_11,$zc_11,$origin_17                # 74e
        lqd     $slope_18,464($a_shear)                 # 74o
        fs      $yc_9,$yc_9,$origin_16                  # 75e
        lqd     $axis_20,112($a_shear)                  # 75o
        fs      $zc_12,$zc_12,$origin_15                # 76e
        lqd     $slope_19,480($a_shear)                 # 76o
        fs      $xc_11,$xc_11,$origin_11                # 77e
        lqd     $slope_20,448($a_shear)                 # 77o
        fnms    $xb_11,$slope_10,$zb_11,$xb_11          # 78e
        lqd     $axis_21,176($a_shear)                  # 78o
        fnms    $xc_9,$slope_17,$zc_10,$xc_9            # 79e
        shufb   $xa_13,$vertex_a,$vertex_a,$axis_14     # 79o
        fnms    $yc_8,$slope_18,$zc_10,$yc_8            # 80e
        lqd     $axis_10,48($a_shear)                   # 80o
        fnms    $ya_11,$slope_18,$za_10,$ya_11          # 81e
        lqd     $origin_18,304($a_shear)                # 81o
        fnms    $yc_9,$slope_19,$zc_11,$yc_9            # 82e
        shufb   $ya_12,$vertex_a,$vertex_a,$axis_20     # 82o
        fnms    $xc_11,$slope_8,$zc_12,$xc_11           # 83e
        lqd     $slope_21,432($a_shear)                 # 83o
        fnms    $ya,$slope_20,$za_9,$ya                 # 84e
        shufb   $za_11,$vertex_a,$vertex_a,$axis_21     # 84o
        fnms    $yc,$slope_20,$zc_12,$yc                # 85e
        lqd     $slope_22,496($a_shear)                 # 85o
        fnms    $ya_9,$slope_19,$za_8,$ya_9             # 86e
        shufb   $zc_13,$vertex_c,$vertex_c,$axis_21     # 86o
        fs      $xa,$xa,$origin_13                      # 87e
        shufb   $xb_14,$vertex_b,$vertex_b,$axis_10     # 87o
        fm      $sum_18,$yc_9,$xb_11                    # 88e
        shufb   $yc_10,$vertex_c,$vertex_c,$axis_20     # 88o
        fs      $xa_13,$xa_13,$origin_11                # 89e
        lqd     $origin_11,240($a_shear)                # 89o
        fm      $sum_19,$ya,$xc_11                      # 90e
        lqd     $origin_19,368($a_shear)                # 90o
        fnms    $xb_13,$slope_8,$zb_10,$xb_13           # 91e
        shufb   $xc_12,$vertex_c,$vertex_c,$axis_10     # 91o
        fs      $yb,$yb,$origin_12                      # 92e
        shufb   $xa_14,$vertex_a,$vertex_a,$axis_10     # 92o
        fnms    $xa_3,$slope_10,$za_8,$xa_12            # 93e
        shufb   $zb_12,$vertex_b,$vertex_b,$axis_21     # 93o
        fnms    $xc_10,$slope_10,$zc_11,$xc_10          # 94e
        shufb   $yb_5,$vertex_b,$vertex_b,$axis_20      # 94o
        fs      $xc_12,$xc_12,$origin_11                # 95e
        lqd     $slope_23,544($a_shear)                 # 95o
        fnms    $xa,$slope_17,$za_10,$xa                # 96e
        lqd     $slope_17,512($a_shear)                 # 96o
        fm      $sum_20,$yc,$xb_13                      # 97e
        lqd     $slope_13,528($a_shear)                 # 97o
        fnms    $yb_8,$slope_20,$zb_10,$yb_8            # 98e
        lqd     $slope_24,560($a_shear)                 # 98o
        fs      $xb_14,$xb_14,$origin_11                # 99e
        lqd     $nearest_7,480($a_packet)               # 99o
        fm      $sum_8,$ya_9,$xc_10                     # 100e
        shufb   $index,$index,$index,$m_splat           # 100o
        fs      $yc_10,$yc_10,$origin_18                # 101e
        lqd     $nearest_8,464($a_packet)               # 101o
        fs      $zc_13,$zc_13,$origin_19                # 102e
        rotqmbii $ends,$ends,-6                         # 102o
        fs      $ya_12,$ya_12,$origin_18                # 103e
        lqd     $nearest_9,496($a_packet)               # 103o
        fs      $zb_12,$zb_12,$origin_19                # 104e
        fnms    $xa_13,$slope_8,$za_9,$xa_13            # 105e
        fms     $header_19,$ya,$xc_11,$sum_19           # 106e
        fnms    $yb,$slope_18,$zb_9,$yb                 # 107e
        fm      $sum_17,$ya_11,$xc_9                    # 108e
        fnms    $yb_6,$slope_19,$zb_11,$yb_9            # 109e
        fs      $za_12,$za_11,$origin_19                # 110e
        fms     $v_15,$xa_13,$yc,$sum_19                # 111e
        fm      $sum_19,$yc_8,$xb_12                    # 112e
        fs      $xa_14,$xa_14,$origin_11                # 113e
        fms     $header_20,$ya_11,$xc_9,$sum_17         # 114e
        fms     $v_16,$xa,$yc_8,$sum_17                 # 115e
        fms     $rest_11,$xc_10,$yb_6,$sum_18           # 116e
        fms     $header_21,$yc_9,$xb_11,$sum_18         # 117e
        fms     $rest_12,$xc_9,$yb,$sum_19              # 118e
        fnms    $ya_12,$slope_22,$za_12,$ya_12          # 119e
        fms     $header_11,$yc,$xb_13,$sum_20           # 120e
        fms     $header_22,$yc_8,$xb_12,$sum_19         # 121e
        fm      $sum_19,$yb,$xa                         # 122e
        fnms    $xc_12,$slope_21,$zc_13,$xc_12          # 123e
        fs      $v_9,$v_15,$header_19                   # 124e
        fm      $sum_21,$yb_8,$xa_13                    # 125e
        fs      $yb_5,$yb_5,$origin_18                  # 126e
        fs      $rest,$rest_12,$header_22               # 127e
        fms     $w,$xb_12,$ya_11,$sum_19                # 128e
        fs      $rest_13,$rest_11,$header_21            # 129e
        fms     $header_23,$ya_9,$xc_10,$sum_8          # 130e
        fms     $v_17,$xa_3,$yc_9,$sum_8                # 131e
        fm      $sum_22,$yb_6,$xa_3                     # 132e
        fms     $rest_8,$xc_11,$yb_8,$sum_20            # 133e
        fs      $v_18,$v_16,$header_20                  # 134e
        fnms    $xb_14,$slope_21,$zb_12,$xb_14          # 135e
        fms     $w_15,$xb_13,$ya,$sum_21                # 136e
        fs      $v_11,$v_17,$header_23                  # 137e
        fms     $header_12,$yb_6,$xa_3,$sum_22          # 138e
        fs      $rest_3,$rest_8,$header_11              # 139e
        fms     $w_16,$xb_11,$ya_9,$sum_22              # 140e
        fnms    $yb_5,$slope_22,$zb_12,$yb_5            # 141e
        fnms    $yc,$slope_22,$zc_13,$yc_10             # 142e
        fa      $det,$rest_13,$v_11                     # 143e
        fa      $det_11,$rest,$v_18                     # 144e
        fms     $header_18,$yb,$xa,$sum_19              # 145e
        fnms    $xa_14,$slope_21,$za_12,$xa_14          # 146e
        fms     $header_10,$yb_8,$xa_13,$sum_21         # 147e
        fm      $sum_5,$yc,$xb_14                       # 148e
        fa      $det_12,$rest_3,$v_9                    # 149e
        fs      $w_17,$w_16,$header_12                  # 150e
        fs      $w,$w,$header_18                        # 151e
        fm      $sum_6,$ya_12,$xc_12                    # 152e
        fs      $w_10,$w_15,$header_10                  # 153e
        fms     $header_15,$yc,$xb_14,$sum_5            # 154e
        fms     $rest_6,$xc_12,$yb_5,$sum_5             # 155e
        fa      $det,$det,$w_17                         # 156e
        fa      $det_6,$det_11,$w                       # 157e
        fms     $v_3,$xa_14,$yc,$sum_6                  # 158e
        fms     $header_14,$ya_12,$xc_12,$sum_6         # 159e
        fa      $det_13,$det_12,$w_10                   # 160e
        fm      $sum_23,$yb_5,$xa_14                    # 161e
        fs      $rest_6,$rest_6,$header_15              # 162e
        frest   $t_y_11,$det                            # 162o
        xor     $seen,$det,$slope_23                    # 163e of -1 / direction z
        frest   $t_y_3,$det_6                           # 163o
        xor     $seen_2,$det_6,$slope_13                # 164e of -1 / direction z
        fs      $v_19,$v_3,$header_14                   # 165e
        fi      $t_y_11,$det,$t_y_11                    # 166e
        frest   $t_y_12,$det_13                         # 166o
        fi      $t_y_3,$det_6,$t_y_3                    # 167e
        xor     $seen_10,$det_13,$slope_17              # 168e of -1 / direction z
        fms     $header_24,$yb_5,$xa_14,$sum_23         # 169e
        fms     $w_6,$xb_14,$ya_12,$sum_23              # 170e
        fa      $det_8,$rest_6,$v_19                    # 171e
        fi      $t_y_13,$det_13,$t_y_12                 # 172e
        or      $seen_5,$seen_2,$both                   # 173e
        fnms    $t_e_5,$det_6,$t_y_3,$k_above_one       # 174e
        fnms    $t_e_6,$det,$t_y_11,$k_above_one        # 175e
        fs      $w_6,$w_6,$header_24                    # 176e
        or      $seen,$seen,$both                       # 177e
        or      $seen_8,$seen_10,$both                  # 178e
        fnms    $t_e_7,$det_13,$t_y_13,$k_above_one     # 179e
        fma     $inverse_7,$t_e_5,$t_y_3,$t_y_3         # 180e
        fma     $inverse_8,$t_e_6,$t_y_11,$t_y_11       # 181e
        fa      $det,$det_8,$w_6                        # 182e
        cgt     $more,$ends,$at_3                       # 183e
        or      $object_3,$index,$hit                   # 184e
        fma     $inverse_9,$t_e_7,$t_y_13,$t_y_13       # 185e
        fm      $rest,$rest,$inverse_7                  # 186e
        fm      $v_11,$v_11,$inverse_8                  # 187e
        lnop                                            # 187o pairing
        fm      $rest_5,$rest_13,$inverse_8             # 188e
        frest   $t_y_13,$det                            # 188o
        fm      $v_20,$v_18,$inverse_7                  # 189e
        fm      $w_17,$w_17,$inverse_8                  # 190e
        fm      $rest_3,$rest_3,$inverse_9              # 191e
        fi      $t_y_11,$det,$t_y_13                    # 192e
        xor     $seen_9,$det,$slope_24                  # 193e of -1 / direction z
        fm      $v_17,$v_9,$inverse_9                   # 194e
        fm      $ahead,$rest,$za_10                     # 195e
        fm      $ahead_11,$rest_5,$za_8                 # 196e
        fm      $ahead_12,$rest_3,$za_9                 # 197e
        fm      $w_10,$w_10,$inverse_9                  # 198e
        fnms    $t_e_8,$det,$t_y_11,$k_above_one        # 199e
        fm      $w,$w,$inverse_7                        # 200e
        fma     $ahead,$v_20,$zb_9,$ahead               # 201e
        fma     $ahead_13,$v_11,$zb_11,$ahead_11        # 202e
        fma     $ahead_14,$v_17,$zb_10,$ahead_12        # 203e
        or      $outside,$rest_3,$v_17                  # 204e
        fma     $inverse_10,$t_e_8,$t_y_11,$t_y_11      # 205e
        or      $outside,$outside,$w_10                 # 206e
        fma     $ahead,$w,$zc_10,$ahead                 # 207e
        fma     $ahead_13,$w_17,$zc_11,$ahead_13        # 208e
        fma     $ahead_10,$w_10,$zc_12,$ahead_14        # 209e
        or      $outside_8,$rest,$v_20                  # 210e
        fm      $rest,$rest_6,$inverse_10               # 211e
        fm      $w_13,$w_6,$inverse_10                  # 212e
        fm      $ahead,$ahead,$slope_13                 # 213e
        fm      $v_12,$v_19,$inverse_10                 # 214e
        fm      $ahead_10,$ahead_10,$slope_17           # 215e
        fm      $ahead_13,$ahead_13,$slope_23           # 216e
        fm      $ahead_15,$rest,$za_12                  # 217e
        or      $outside_9,$rest_5,$v_11                # 218e
        xor     $t,$ahead,$k_sign                       # 219e
        orc     $outside,$outside,$seen_8               # 220e
        xor     $t_4,$ahead_10,$k_sign                  # 221e
        xor     $t_5,$ahead_13,$k_sign                  # 222e
        fma     $ahead_15,$v_12,$zb_12,$ahead_15        # 223e
        cgt     $control,$t_best,$t_5                   # 224e
        cgt     $control_6,$t_best_7,$t_4               # 225e
        or      $outside_9,$outside_9,$w_17             # 226e
        and     $control_4,$control_6,$ahead_10         # 227e
        orc     $outside_9,$outside_9,$seen             # 228e
        fma     $ahead_2,$w_13,$zc_13,$ahead_15         # 229e
        andc    $control_4,$control_4,$outside          # 230e
        or      $outside,$outside_8,$w                  # 231e
        lnop                                            # 231o pairing
        cgt     $control_7,$t_best_4,$t                 # 232e
        rotqbii $control_4,$control_4,1                 # 232o
        orc     $outside,$outside,$seen_5               # 233e
        and     $control_7,$control_7,$ahead            # 234e
        and     $control,$control,$ahead_13             # 235e
        lnop                                            # 235o pairing
        andc    $control_7,$control_7,$outside          # 236e
        gb      $control_4,$control_4                   # 236o
        fm      $ahead,$ahead_2,$slope_24               # 237e
        lnop                                            # 237o pairing
        andc    $control,$control,$outside_9            # 238e
        rotqbii $control_7,$control_7,1                 # 238o
        or      $outside,$rest,$v_12                    # 239e
        lnop                                            # 239o pairing
        or      $seen,$seen_9,$both                     # 240e
        rotqbii $control,$control,1                     # 240o
        or      $outside,$outside,$w_13                 # 241e
        shlqbii $control_4,$control_4,4                 # 241o
        and     $at,$at_3,$more                         # 242e
        gb      $control_2,$control_7                   # 242o
        xor     $t_6,$ahead,$k_sign                     # 243e
        lnop                                            # 243o pairing
        orc     $outside,$outside,$seen                 # 244e
        gb      $control,$control                       # 244o
        cgt     $control_8,$t_best_8,$t_6               # 245e
        lqx     $control_4,$control_4,$a_controls       # 245o
        andc    $ends,$k_step,$more                     # 246e
        shlqbii $control_2,$control_2,4                 # 246o
        and     $control_8,$control_8,$ahead            # 247e
        lnop                                            # 247o pairing
        a       $a_candidate,$a_candidate,$ends         # 248e
        shlqbii $control,$control,4                     # 248o
        andc    $control_8,$control_8,$outside          # 249e
        lqx     $control_2,$control_2,$a_controls       # 250o
        shufb   $t_best_7,$t_best_7,$t_4,$control_4     # 251o
        lqx     $control,$control,$a_controls           # 252o
        rotqbii $control_8,$control_8,1                 # 253o
        shufb   $nearest,$nearest,$object_3,$control_4  # 254o
        stqd    $t_best_7,384($a_packet)                # 255o
        shufb   $t_best_7,$t_best_4,$t,$control_2       # 256o
        shufb   $nearest_6,$nearest_8,$object_3,$control_2 # 257o
        shufb   $t_best,$t_best,$t_5,$control           # 258o
        gb      $control_9,$control_8                   # 259o
        shufb   $nearest_3,$nearest_7,$object_3,$control # 260o
        stqd    $nearest_6,464($a_packet)               # 261o
        stqd    $t_best,416($a_packet)                  # 262o
        shlqbii $control,$control_9,4                   # 263o
        stqd    $nearest_3,480($a_packet)               # 264o
        stqd    $nearest,448($a_packet)                 # 265o
        stqd    $t_best_7,400($a_packet)                # 266o
        hbrr    next_triangle_short_back,next_triangle_short # 267o hint
        lqx     $control,$control,$a_controls           # 268o
        shufb   $t_best,$t_best_8,$t_6,$control         # 274o
        shufb   $nearest,$nearest_9,$object_3,$control  # 275o
        stqd    $t_best,432($a_packet)                  # 278o
        stqd    $nearest,496($a_packet)                 # 279o
        nop     $127                                    # 280e pairing
next_triangle_short_back:
        brnz    $triangles,next_triangle_short          # 280o
        nop     $127                                    # 281e pairing
        bi      $lr                                     # 281o
endfunction isect_mesh_pairs_r16
