# isect_mesh_pairs_r16   nearest hit of packets' rays with runs of a mesh's triangles
#   C       void isect_mesh_pairs_r16(const struct mesh_candidate *, int count,
#                                     const struct mesh_header *);
#   In      $3 candidates of runs of triangles, $4 count (0 is none), $5 the runs' block, in local
#           store and relative to the eye; pointers 16-aligned
#   Out     the candidates' packets: t, object, where a hit has 0 < t < what was there; object is
#           MESH_HIT, plus 128 times the block's number, plus the triangle's index
#   Uses    $2-$79   Saves  -   Stack  0   Calls  -
#   Domain  distances from the origin below 2^60; triangles higher than 2^-50 across the ray; runs
#           of at least one triangle
#   Error   6 ulp of t, 8e-5 in barycentric coordinates; edges from 1/100 of the distance to all of
#           it, area across the ray above 1/20 of their square
#   Twin    lab/twins/src/mesh_pairs.rs
#
# As watertight as isect_triangle_pairs_r16, with the same steps: triangles that share a vertex get
# the same bits for it. The loop goes over triangles, not over runs, so that short runs cost no
# branches. It takes two passes for a triangle, of two rows of rays each: with four rows in a pass
# the loop took 209 cycles a triangle instead of 2 times 111, but 5.8 KB of local store instead of 4.2.
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
        registers a_candidate
        registers passes                                # left, two a triangle
        registers at                                    # in the run: 4 times the index
        registers rows                                  # offset of the pass's two rows: 0 or 32
        # the candidate
        registers candidate,a_packet,a_shear
        # the triangle
        registers face,index,object,vertex_a,vertex_b,vertex_c
        # temporaries
        registers xa,ya,za,xb,yb,zb,xc,yc,zc,axis,origin,slope
        registers p,q
        registers u,v,w,det,inverse,t_y,t_e,n
        registers outside,seen,t,t_best,nearest,control
        registers ends,more,next
        .set    ahead,n
        # only before the loop
        .set    sum,p
        .set    header,q
        .set    rest,u

        sign_controls_table
vertex_indices:                                         # three bytes to the ends of three words
        .int    0x80808000,0x80808001,0x80808002,0x80808080

function isect_mesh_pairs_r16
        .set count_2,79; .set candidate_2,2; .set passes_2,79; .set rows_2,2; .set index_2,5
        .set at_2,6; .set a_packet_2,7; .set index_3,9; .set t_best_2,73; .set a_packet_3,4
        .set nearest_2,3; .set a_shear_2,32; .set axis_2,8; .set axis_3,50; .set axis_4,51
        .set vertex_c_2,6; .set at_3,25; .set vertex_b_2,7; .set origin_2,55; .set vertex_a_2,22
        .set origin_3,46; .set slope_2,66; .set ya_2,64; .set za_2,39; .set yc_2,54; .set zb_2,40
        .set zc_2,37; .set za_3,67; .set xc_2,48; .set xb_2,26; .set zb_3,68; .set slope_3,27
        .set zc_3,70; .set xa_2,45; .set xc_3,8; .set yb_2,51; .set face_2,28; .set ya_3,44
        .set axis_5,53; .set axis_6,56; .set yb_3,50; .set axis_7,63; .set yc_3,29
        .set origin_4,42; .set xc_4,43; .set origin_5,8; .set origin_6,31; .set a_shear_3,33
        .set xa_3,34; .set xc_5,47; .set yc_4,65; .set xb_3,40; .set sum_2,51; .set za_4,71
        .set xc_6,22; .set zc_4,72; .set yc_5,39; .set ya_4,6; .set sum_3,28; .set zb_4,64
        .set header_2,29; .set slope_4,36; .set slope_5,38; .set header_3,41; .set yb_4,69
        .set xa_4,7; .set xb_4,6; .set slope_6,29; .set vertex_c_3,28; .set zb_5,30
        .set vertex_b_3,33; .set vertex_a_3,27; .set yb_5,8; .set slope_7,33; .set index_4,43
        .set a_packet_4,24; .set xa_5,5; .set axis_8,7; .set axis_9,22; .set sum_4,26
        .set sum_5,44; .set origin_7,36; .set seen_2,38; .set za_5,41; .set rest_2,42; .set zb_6,53
        .set header_4,26; .set zc_5,22; .set header_5,39; .set xc_7,56; .set v_2,40; .set xb_5,44
        .set slope_8,57; .set t_e_2,50; .set za_6,60; .set candidate_3,41; .set zc_6,46
        .set axis_10,61; .set header_6,5; .set w_2,6; .set origin_8,34; .set rest_3,26
        .set origin_9,45; .set v_3,39; .set inverse_2,40; .set xc_8,42; .set yc_6,51; .set ya_5,52
        .set xc_9,54; .set zb_7,55; .set ya_6,22; .set a_shear_4,28; .set w_3,5; .set slope_9,6
        .set det_2,56; .set slope_10,64; .set xa_6,57; .set a_shear_5,7; .set xa_7,63
        .set sum_6,27; .set sum_7,74; .set slope_11,31; .set ahead_2,9; .set sum_8,67
        .set header_7,75; .set v_4,51; .set rest_4,27; .set t_y_2,76; .set header_8,54
        .set header_9,40; .set w_4,22; .set rest_5,44; .set v_5,50; .set t_y_3,27
        .set outside_2,47; .set w_5,40; .set seen_3,22; .set det_3,38; .set t_e_3,48
        .set outside_3,29; .set det_4,47; .set index_5,25; .set t_2,48; .set control_2,27
        .set vertex_a_4,38; .set t_y_4,41; .set face_3,49; .set control_3,25; .set t_y_5,29
        .set origin_10,49; .set xc_10,65; .set t_e_4,57; .set face_4,38; .set origin_11,27
        .set face_5,30; .set control_4,45; .set inverse_3,25; .set xa_8,8; .set vertex_c_4,29
        .set vertex_b_4,37; .set yb_6,34; .set t_best_3,48; .set xc_11,55; .set yb_7,6
        .set axis_11,34; .set sum_9,48; .set axis_12,62; .set sum_10,63; .set axis_13,64
        .set ahead_3,60; .set origin_12,65; .set origin_13,70; .set outside_4,26; .set yc_7,67
        .set outside_5,5; .set yb_8,71; .set w_6,74; .set zc_7,25; .set control_5,40; .set xb_6,62
        .set rest_6,69; .set slope_12,75; .set header_10,48; .set slope_13,76; .set header_11,55
        .set axis_14,72; .set ahead_4,53; .set ya_7,60; .set control_6,34; .set axis_15,54
        .set header_12,6; .set control_7,5; .set xc_12,77; .set w_7,36; .set yc_8,52; .set yc_9,78
        .set yb_9,48; .set v_6,55; .set ahead_5,39; .set ya_8,30; .set xb_7,46; .set nearest_3,2
        .set ya_9,3; .set xc_13,24; .set ahead_6,2; .set det_5,45; .set yc_10,8; .set seen_4,5
        .set outside_6,62; .set t_3,66; .set sum_11,24; .set seen_5,3; .set control_8,47
        .set header_13,3; .set rest_7,3; .set v_7,6; .set w_8,8; .set slope_14,3; .set slope_15,5
        .set seen_6,6; .set vertex_c_5,8; .set t_best_4,3; .set vertex_b_5,24; .set vertex_c_6,3
        .set control_9,52; .set rest_8,37; .set header_14,34; .set v_8,33; .set ahead_7,44
        .set xb_8,8; .set slope_16,51; .set xc_14,3; .set control_10,3; .set ya_10,2; .set xb_9,3
        .set nearest_4,14; .set yb_10,16; .set header_15,17; .set rest_9,4; .set origin_14,21
        .set slope_17,8; .set header_16,27; .set a_packet_5,5; .set slope_18,30; .set zc_8,34
        .set zb_8,37; .set slope_19,32; .set za_7,21; .set yb_11,4; .set sum_12,6; .set det_6,8
        .set t_best_5,13; .set header_17,16; .set rest_10,6; .set v_9,24; .set w_9,2; .set det_7,3
        .set v_10,8; .set v_11,13; .set w_10,16; .set nearest_5,6; .set t_y_6,7; .set a_packet_6,13
        .set object_2,7; .set control_11,9; .set outside_7,3; .set at_4,4; .set control_12,2
        .set t_best_6,4; .set t_best_7,2; .set axis_16,4; .set axis_17,5; .set origin_15,6
        .set origin_16,7; .set xb_10,9; .set ya_11,27; .set yc_11,5; .set za_8,28; .set zb_9,44
        .set zc_9,7; .set sum_13,32; .set slope_20,46; .set slope_21,47; .set xa_9,30
        .set zb_10,31; .set rest_11,32; .set xc_15,9; .set ya_12,24; .set rest_12,5; .set sum_14,4
        .set header_18,9; .set v_12,4; .set det_8,9; .set seen_7,9; .set ahead_8,4; .set t_4,4
        .set control_13,6
        nop     $127                                    # 0e pairing
        biz     $count,$lr                              # 0o
        clgti   $count_2,$count,1                       # 1e at least as many passes as overlap
        ori     $a_candidate,$a_first,0                 # 2e
        il      $passes,0                               # 3e
        brz     $count_2,next_run_short                 # 3o too few passes
        ai      $count,$count,-1                        # 4e
        lqd     $candidate_2,0($a_first)                # 4o
        ai      $a_first,$a_first,16                    # 5e
        hbrr    next_run_back,next_run                  # 5o hint
next_run:
            rotmi   $candidate,$candidate_2,-16         # 1e
        lqd     $candidate_2,0($a_first)                # 1o
        ai      $a_first,$a_first,16                    # 2e
        ai      $count,$count,-1                        # 3e
            a       $passes,$passes,$candidate          # 5e
next_run_back:
        brnz    $count,next_run                         # 5o
next_run_drain:
        rotmi   $candidate,$candidate_2,-16             # 0e
        a       $passes,$passes,$candidate              # 4e
isect_mesh_pairs_r16_block:
        ilhu    $k_sign,0x8000                          # 0e
        lqd     $header,0($a_block)                     # 0o
        a       $passes,$passes,$passes                 # 1e
        lqd     $rest,16($a_block)                      # 1o
        ila     $m_splat,0x10203                        # 2e
        lqa     $m_indices,vertex_indices               # 2o
        ilhu    $k_above_one,0x3f80                     # 3e
        clgti   $passes_2,$passes,3                     # 4e at least as many passes as overlap
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
        il      $rows,0                                 # 13e
        a       $a_vertices,$a_vertices,$a_block        # 14e
        or      $hit,$hit,$k_sign                       # 15e
        shufb   $both,$both,$both,$m_splat              # 15o
        ai      $a_vertices,$a_vertices,32              # 16e
        shufb   $hit,$hit,$hit,$m_splat                 # 17o
        a       $a_faces,$a_faces,$a_vertices           # 18e
        brz     $passes_2,next_rows_short               # 18o too few passes
        xori    $rows_2,$rows,32                        # 19e
        lqd     $candidate,0($a_candidate)              # 19o
        ai      $passes,$passes,-1                      # 20e
        ceqi    $next,$rows_2,0                         # 21e
        ai      $passes,$passes,-1                      # 22e
        andi    $next,$next,4                           # 23e
        ai      $passes,$passes,-1                      # 24e
        lnop                                            # 24o pairing
        andi    $index_2,$candidate,511                 # 25e 4 times it
        rotqbyi $a_shear,$candidate,8                   # 25o
        a       $at_2,$at,$next                         # 26e
        rotqmbyi $ends,$candidate,-1                    # 26o 4 times the run's length
        a       $index_2,$index_2,$at                   # 27e
        rotqbyi $a_packet_2,$candidate,4                # 27o
        a       $vertex_a,$a_faces,$index_2             # 29e
        lqx     $face,$a_faces,$index_2                 # 29o
        nop     $127                                    # 30e pairing
        lqd     $a_shear,192($a_shear)                  # 30o
        a       $a_packet,$a_packet_2,$rows             # 31e
        rotqmbii $ends,$ends,-6                         # 31o
        rotqmbii $index_3,$index_2,-2                   # 32o
        lqd     $t_best_2,400($a_packet)                # 33o
        nop     $127                                    # 34e pairing
        shlqbyi $a_packet_3,$a_packet,0                 # 34o copy
        cgt     $more,$ends,$at_2                       # 35e
        rotqby  $face,$face,$vertex_a                   # 35o
        nop     $127                                    # 36e pairing
        rotqbyi $a_shear,$a_shear,8                     # 36o
        andc    $ends,$k_step,$more                     # 37e
        lqd     $nearest_2,464($a_packet)               # 37o
        and     $at,$at_2,$more                         # 38e
        lqd     $t_best,384($a_packet)                  # 38o
        a       $a_candidate,$a_candidate,$ends         # 39e
        shufb   $face,$face,$face,$m_indices            # 39o
        a       $a_shear_2,$a_shear,$rows               # 40e
        lqd     $nearest,448($a_packet)                 # 40o
        xori    $rows,$rows_2,32                        # 41e
        lqd     $candidate,0($a_candidate)              # 41o
        nop     $127                                    # 42e pairing
        lqd     $axis_2,16($a_shear_2)                  # 42o
        ceqi    $next,$rows,0                           # 43e
        shlqbii $face,$face,4                           # 43o
        nop     $127                                    # 44e pairing
        lqd     $axis_3,144($a_shear_2)                 # 44o
        andi    $next,$next,4                           # 45e
        lqd     $axis_4,80($a_shear_2)                  # 45o
        nop     $127                                    # 46e pairing
        lqd     $origin,208($a_shear_2)                 # 46o
        andi    $index_2,$candidate,511                 # 47e 4 times it
        rotqbyi $vertex_c_2,$face,8                     # 47o
        a       $at_3,$at,$next                         # 48e
        rotqbyi $vertex_b_2,$face,4                     # 48o
        a       $index_2,$index_2,$at                   # 49e
        lqx     $vertex_a,$a_vertices,$face             # 49o
        nop     $127                                    # 50e pairing
        lqd     $origin_2,272($a_shear_2)               # 50o
        a       $vertex_a_2,$a_faces,$index_2           # 51e
        lqx     $vertex_c_2,$a_vertices,$vertex_c_2     # 51o
        lqx     $vertex_b_2,$a_vertices,$vertex_b_2     # 52o
        lqd     $origin_3,336($a_shear_2)               # 53o
        lqd     $slope_2,464($a_shear_2)                # 54o
        shufb   $ya_2,$vertex_a,$vertex_a,$axis_4       # 55o
        shufb   $za_2,$vertex_a,$vertex_a,$axis_3       # 56o
        shufb   $yc_2,$vertex_c_2,$vertex_c_2,$axis_4   # 57o
        nop     $127                                    # 58e pairing
        shufb   $zb_2,$vertex_b_2,$vertex_b_2,$axis_3   # 58o
        fs      $ya_2,$ya_2,$origin_2                   # 59e
        shufb   $zc_2,$vertex_c_2,$vertex_c_2,$axis_3   # 59o
        fs      $za_3,$za_2,$origin_3                   # 60e
        shufb   $xc_2,$vertex_c_2,$vertex_c_2,$axis_2   # 60o
        fs      $yc_2,$yc_2,$origin_2                   # 61e
        shufb   $xb_2,$vertex_b_2,$vertex_b_2,$axis_2   # 61o
        fs      $zb_3,$zb_2,$origin_3                   # 62e
        lqd     $slope_3,400($a_shear_2)                # 62o
        fs      $zc_3,$zc_2,$origin_3                   # 63e
        shufb   $xa_2,$vertex_a,$vertex_a,$axis_2       # 63o
        fs      $xc_3,$xc_2,$origin                     # 64e
        shufb   $yb_2,$vertex_b_2,$vertex_b_2,$axis_4   # 64o
        fs      $xb_2,$xb_2,$origin                     # 65e
        lqx     $face_2,$a_faces,$index_2               # 65o
        fnms    $ya_3,$slope_2,$za_3,$ya_2              # 66e
        lqd     $axis_5,128($a_shear_2)                 # 66o
        fs      $xa_2,$xa_2,$origin                     # 67e
        lqd     $axis_6,0($a_shear_2)                   # 67o
        fs      $yb_3,$yb_2,$origin_2                   # 68e
        lqd     $axis_7,64($a_shear_2)                  # 68o
        fnms    $yc_3,$slope_2,$zc_3,$yc_2              # 69e
        lqd     $origin_4,192($a_shear_2)               # 69o
        fnms    $xc_4,$slope_3,$zc_3,$xc_3              # 70e
        lqd     $origin_5,256($a_shear_2)               # 70o
        fnms    $xb_2,$slope_3,$zb_3,$xb_2              # 71e
        lqd     $origin_6,320($a_shear_2)               # 71o
        nop     $127                                    # 72e pairing
        rotqbyi $a_shear_3,$candidate,8                 # 72o
        fnms    $xa_3,$slope_3,$za_3,$xa_2              # 73e
        rotqby  $face,$face_2,$vertex_a_2               # 73o
        fnms    $yb,$slope_2,$zb_3,$yb_3                # 74e
        shufb   $xc_5,$vertex_c_2,$vertex_c_2,$axis_6   # 74o
        nop     $127                                    # 75e pairing
        shufb   $yc_4,$vertex_c_2,$vertex_c_2,$axis_7   # 75o
        fm      $sum,$ya_3,$xc_4                        # 76e
        shufb   $xb_3,$vertex_b_2,$vertex_b_2,$axis_6   # 76o
        fm      $sum_2,$yc_3,$xb_2                      # 77e
        shufb   $za_4,$vertex_a,$vertex_a,$axis_5       # 77o
        fs      $xc_6,$xc_5,$origin_4                   # 78e
        shufb   $zc_4,$vertex_c_2,$vertex_c_2,$axis_5   # 78o
        fs      $yc_5,$yc_4,$origin_5                   # 79e
        shufb   $ya_4,$vertex_a,$vertex_a,$axis_7       # 79o
        fm      $sum_3,$yb,$xa_3                        # 80e
        shufb   $zb_4,$vertex_b_2,$vertex_b_2,$axis_5   # 80o
        fs      $za,$za_4,$origin_6                     # 81e
        lqd     $a_shear_3,192($a_shear_3)              # 81o
        fms     $v,$xa_3,$yc_3,$sum                     # 82e
        shufb   $face,$face,$face,$m_indices            # 82o
        fms     $header_2,$yc_3,$xb_2,$sum_2            # 83e
        lqd     $slope_4,448($a_shear_2)                # 83o
        fms     $rest,$xc_4,$yb,$sum_2                  # 84e
        lqd     $slope_5,384($a_shear_2)                # 84o
        fms     $header_3,$ya_3,$xc_4,$sum              # 85e
        shufb   $yb_4,$vertex_b_2,$vertex_b_2,$axis_7   # 85o
        fms     $header,$yb,$xa_3,$sum_3                # 86e
        shufb   $xa_4,$vertex_a,$vertex_a,$axis_6       # 86o
        fms     $w,$xb_2,$ya_3,$sum_3                   # 87e
        shlqbii $face,$face,4                           # 87o
        fs      $ya,$ya_4,$origin_5                     # 88e
        rotqbyi $a_shear,$a_shear_3,8                   # 88o
        fs      $xb_4,$xb_3,$origin_4                   # 89e
        rotqmbyi $ends,$candidate,-1                    # 89o 4 times the run's length
        fs      $rest,$rest,$header_2                   # 90e
        lqd     $slope_6,528($a_shear_2)                # 90o
        fs      $v,$v,$header_3                         # 91e
        rotqbyi $vertex_c_3,$face,8                     # 91o
        fs      $zb_5,$zb_4,$origin_6                   # 92e
        rotqbyi $vertex_b_3,$face,4                     # 92o
        fs      $w,$w,$header                           # 93e
        lqx     $vertex_a_3,$a_vertices,$face           # 93o
        fs      $zc_2,$zc_4,$origin_6                   # 94e
        rotqmbii $ends,$ends,-6                         # 94o
        fs      $xa_4,$xa_4,$origin_4                   # 95e
        lqx     $vertex_c_3,$a_vertices,$vertex_c_3     # 95o
        fs      $yb_5,$yb_4,$origin_5                   # 96e
        lqx     $vertex_b,$a_vertices,$vertex_b_3       # 96o
        fa      $det,$rest,$v                           # 97e
        lqd     $slope_7,512($a_shear_2)                # 97o
        fnms    $ya,$slope_4,$za,$ya                    # 98e
        shufb   $index_4,$index_3,$index_3,$m_splat     # 98o
        fnms    $xb_4,$slope_5,$zb_5,$xb_4              # 99e
        rotqbyi $a_packet_4,$candidate,4                # 99o
        fnms    $yc,$slope_4,$zc_2,$yc_5                # 100e
        rotqmbii $index_3,$index_2,-2                   # 100o
        fnms    $xc,$slope_5,$zc_2,$xc_6                # 101e
        a       $a_shear_2,$a_shear,$rows_2             # 102e
        fa      $det,$det,$w                            # 103e
        lnop                                            # 103o pairing
        fnms    $xa_5,$slope_5,$za,$xa_4                # 104e
        lqd     $axis_8,16($a_shear_2)                  # 104o
        fnms    $yb_5,$slope_4,$zb_5,$yb_5              # 105e
        lqd     $axis_9,144($a_shear_2)                 # 105o
        fm      $sum_4,$yc,$xb_4                        # 106e
        lqd     $axis_4,80($a_shear_2)                  # 106o
        fm      $sum_5,$ya,$xc                          # 107e
        lqd     $origin_7,208($a_shear_2)               # 107o
        cgt     $more,$ends,$at_3                       # 108e
        lqd     $origin_2,272($a_shear_2)               # 108o
        xor     $seen_2,$det,$slope_6                   # 109e of -1 / direction z
        frest   $t_y,$det                               # 109o
        andc    $ends,$k_step,$more                     # 110e
        lqd     $origin_3,336($a_shear_2)               # 110o
        fm      $sum,$yb_5,$xa_5                        # 111e
        shufb   $za_5,$vertex_a_3,$vertex_a_3,$axis_9   # 111o
        fms     $rest_2,$xc,$yb_5,$sum_4                # 112e
        shufb   $yc_2,$vertex_c_3,$vertex_c_3,$axis_4   # 112o
        fi      $t_y,$det,$t_y                          # 113e
        shufb   $ya_2,$vertex_a_3,$vertex_a_3,$axis_4   # 113o
        a       $a_candidate,$a_candidate,$ends         # 114e
        shufb   $zb_6,$vertex_b,$vertex_b,$axis_9       # 114o
        fms     $header_4,$yc,$xb_4,$sum_4              # 115e
        shufb   $zc_5,$vertex_c_3,$vertex_c_3,$axis_9   # 115o
        fms     $header_5,$ya,$xc,$sum_5                # 116e
        shufb   $xc_7,$vertex_c_3,$vertex_c_3,$axis_8   # 116o
        fms     $v_2,$xa_5,$yc,$sum_5                   # 117e
        shufb   $xb_5,$vertex_b,$vertex_b,$axis_8       # 117o
        fs      $ya_2,$ya_2,$origin_2                   # 118e
        lqd     $slope_2,464($a_shear_2)                # 118o
        fs      $yc_2,$yc_2,$origin_2                   # 119e
        lqd     $slope_8,400($a_shear_2)                # 119o
        fnms    $t_e_2,$det,$t_y,$k_above_one           # 120e
        shufb   $xa_4,$vertex_a_3,$vertex_a_3,$axis_8   # 120o
        fs      $za_6,$za_5,$origin_3                   # 121e
        shufb   $yb_2,$vertex_b,$vertex_b,$axis_4       # 121o
        fs      $zb_6,$zb_6,$origin_3                   # 122e
        lqd     $candidate_3,0($a_candidate)            # 122o
        fs      $zc_6,$zc_5,$origin_3                   # 123e
        lqd     $axis_9,128($a_shear_2)                 # 123o
        fs      $xb_5,$xb_5,$origin_7                   # 124e
        lqd     $axis_10,0($a_shear_2)                  # 124o
        fs      $xc_7,$xc_7,$origin_7                   # 125e
        lqd     $axis_7,64($a_shear_2)                  # 125o
        fms     $header_6,$yb_5,$xa_5,$sum              # 126e
        lqd     $origin_5,192($a_shear_2)               # 126o
        fms     $w_2,$xb_4,$ya,$sum                     # 127e
        lqd     $origin_8,256($a_shear_2)               # 127o
        fs      $rest_3,$rest_2,$header_4               # 128e
        lqd     $origin_9,320($a_shear_2)               # 128o
        fs      $v_3,$v_2,$header_5                     # 129e
        shufb   $za_4,$vertex_a_3,$vertex_a_3,$axis_9   # 129o
        fma     $inverse_2,$t_e_2,$t_y,$t_y             # 130e
        shufb   $xc_8,$vertex_c_3,$vertex_c_3,$axis_10  # 130o
        fs      $xa_4,$xa_4,$origin_7                   # 131e
        shufb   $yc_4,$vertex_c_3,$vertex_c_3,$axis_7   # 131o
        fs      $yb_3,$yb_2,$origin_2                   # 132e
        shufb   $xb,$vertex_b,$vertex_b,$axis_10        # 132o
        fnms    $xb_5,$slope_8,$zb_6,$xb_5              # 133e
        shufb   $zc_4,$vertex_c_3,$vertex_c_3,$axis_9   # 133o
        fnms    $yc_6,$slope_2,$zc_6,$yc_2              # 134e
        shufb   $ya_5,$vertex_a_3,$vertex_a_3,$axis_7   # 134o
        fnms    $xc_9,$slope_8,$zc_6,$xc_7              # 135e
        shufb   $zb_7,$vertex_b,$vertex_b,$axis_9       # 135o
        fnms    $ya_6,$slope_2,$za_6,$ya_2              # 136e
        rotqbyi $a_shear_4,$candidate_3,8               # 136o
        fs      $w_3,$w_2,$header_6                     # 137e
        lqd     $slope_9,448($a_shear_2)                # 137o
        fa      $det_2,$rest_3,$v_3                     # 138e
        lqd     $slope_10,384($a_shear_2)               # 138o
        fm      $rest,$rest,$inverse_2                  # 139e
        shufb   $yb_4,$vertex_b,$vertex_b,$axis_7       # 139o
        fnms    $xa_6,$slope_8,$za_6,$xa_4              # 140e
        lqd     $a_shear_5,192($a_shear_4)              # 140o
        fnms    $yb_3,$slope_2,$zb_6,$yb_3              # 141e
        shufb   $xa_7,$vertex_a_3,$vertex_a_3,$axis_10  # 141o
        fm      $sum_6,$yc_6,$xb_5                      # 142e
        lqd     $slope_2,528($a_shear_2)                # 142o
        fm      $sum_7,$ya_6,$xc_9                      # 143e
        lqd     $slope_11,512($a_shear_2)               # 143o
        fa      $det_2,$det_2,$w_3                      # 144e
        rotqmbyi $ends,$candidate_3,-1                  # 144o 4 times the run's length
        fm      $v,$v,$inverse_2                        # 145e
        shufb   $index,$index_3,$index_3,$m_splat       # 145o
        fm      $ahead_2,$rest,$za_3                    # 146e
        rotqbyi $a_shear_2,$a_shear_5,8                 # 146o
        fm      $sum_8,$yb_3,$xa_6                      # 147e
        rotqbyi $a_packet_2,$candidate_3,4              # 147o
        fms     $header_7,$yc_6,$xb_5,$sum_6            # 148e
        rotqmbii $ends,$ends,-6                         # 148o
        fms     $v_4,$xa_6,$yc_6,$sum_7                 # 149e
        lnop                                            # 149o pairing
        fms     $rest_4,$xc_9,$yb_3,$sum_6              # 150e
        frest   $t_y_2,$det_2                           # 150o
        fms     $header_8,$ya_6,$xc_9,$sum_7            # 151e
        fm      $w,$w,$inverse_2                        # 152e
        fma     $ahead_2,$v,$zb_3,$ahead_2              # 153e
        fms     $header_9,$yb_3,$xa_6,$sum_8            # 154e
        fms     $w_4,$xb_5,$ya_6,$sum_8                 # 155e
        fs      $rest_5,$rest_4,$header_7               # 156e
        fs      $v_5,$v_4,$header_8                     # 157e
        fi      $t_y_3,$det_2,$t_y_2                    # 158e
        or      $outside_2,$rest,$v                     # 159e
        fma     $ahead_2,$w,$zc_3,$ahead_2              # 160e
        fs      $w_5,$w_4,$header_9                     # 161e
        or      $seen_3,$seen_2,$both                   # 162e
        fa      $det_3,$rest_5,$v_5                     # 163e
        or      $outside_2,$outside_2,$w                # 164e
        fnms    $t_e_3,$det_2,$t_y_3,$k_above_one       # 165e
        fm      $ahead_2,$ahead_2,$slope_6              # 166e
        orc     $outside_3,$outside_2,$seen_3           # 167e
        and     $at,$at_3,$more                         # 168e
        fa      $det_4,$det_3,$w_5                      # 169e
        andi    $index_5,$candidate_3,511               # 170e 4 times it
        fma     $inverse,$t_e_3,$t_y_3,$t_y_3           # 171e
        xor     $t_2,$ahead_2,$k_sign                   # 172e
        a       $index_5,$index_5,$at                   # 173e
        cgt     $control_2,$t_best_2,$t_2               # 174e
        a       $vertex_a_4,$a_faces,$index_5           # 175e
        frest   $t_y_4,$det_4                           # 175o
        and     $control_2,$control_2,$ahead_2          # 176e
        lqx     $face_3,$a_faces,$index_5               # 176o
        fm      $rest_3,$rest_3,$inverse                # 177e
        rotqmbii $index_3,$index_5,-2                   # 177o
        andc    $control_3,$control_2,$outside_3        # 178e
        fi      $t_y_5,$det_4,$t_y_4                    # 179e
        a       $a_shear_2,$a_shear_2,$rows             # 180e
        rotqbii $control_3,$control_3,1                 # 180o
        fm      $v_3,$v_3,$inverse                      # 181e
        lnop                                            # 181o pairing
        fm      $w_3,$w_3,$inverse                      # 182e
        rotqby  $face,$face_3,$vertex_a_4               # 182o
        fm      $ahead,$rest_3,$za                      # 183e
        lqd     $origin_10,208($a_shear_2)              # 183o
        fs      $yc_6,$yc_4,$origin_8                   # 184e
        gb      $control_3,$control_3                   # 184o
        fs      $xc_10,$xc_8,$origin_5                  # 185e
        lqd     $origin_4,192($a_shear_2)               # 185o
        fnms    $t_e_4,$det_4,$t_y_5,$k_above_one       # 186e
        shufb   $face_4,$face,$face,$m_indices          # 186o
        fs      $ya_5,$ya_5,$origin_8                   # 187e
        lqd     $origin_11,256($a_shear_2)              # 187o
        fs      $za,$za_4,$origin_9                     # 188e
        shlqbii $control_3,$control_3,4                 # 188o
        fma     $ahead,$v_3,$zb_5,$ahead                # 189e
        lnop                                            # 189o pairing
        fs      $xb,$xb,$origin_5                       # 190e
        shlqbii $face_5,$face_4,4                       # 190o
        fs      $zb,$zb_7,$origin_9                     # 191e
        lnop                                            # 191o pairing
        fs      $zc,$zc_4,$origin_9                     # 192e
        lqx     $control_4,$control_3,$a_controls       # 192o
        fma     $inverse_3,$t_e_4,$t_y_5,$t_y_5         # 193e
        lnop                                            # 193o pairing
        fs      $xa_8,$xa_7,$origin_5                   # 194e
        rotqbyi $vertex_c_4,$face_5,8                   # 194o
        fma     $ahead,$w_3,$zc_2,$ahead                # 195e
        rotqbyi $vertex_b_4,$face_5,4                   # 195o
        fs      $yb_6,$yb_4,$origin_8                   # 196e
        lqx     $vertex_a,$a_vertices,$face_5           # 196o
        fnms    $ya_5,$slope_9,$za,$ya_5                # 197e
        lnop                                            # 197o pairing
        fnms    $xb,$slope_10,$zb,$xb                   # 198e
        shufb   $t_best_3,$t_best_2,$t_2,$control_4     # 198o
        fnms    $yc_6,$slope_9,$zc,$yc_6                # 199e
        fnms    $xc_11,$slope_10,$zc,$xc_10             # 200e
        fm      $rest_5,$rest_5,$inverse_3              # 201e
        lnop                                            # 201o pairing
        fm      $ahead,$ahead,$slope_7                  # 202e
        stqd    $t_best_3,400($a_packet_3)              # 202o
        fnms    $xa_8,$slope_10,$za,$xa_8               # 203e
        lqx     $vertex_c_4,$a_vertices,$vertex_c_4     # 203o
        fnms    $yb_7,$slope_9,$zb,$yb_6                # 204e
        lqd     $axis_11,16($a_shear_2)                 # 204o
        fm      $sum_9,$yc_6,$xb                        # 205e
        lqd     $axis_12,144($a_shear_2)                # 205o
        fm      $sum_10,$ya_5,$xc_11                    # 206e
        lqd     $axis_13,80($a_shear_2)                 # 206o
        fm      $v_5,$v_5,$inverse_3                    # 207e
        lqx     $vertex_b_4,$a_vertices,$vertex_b_4     # 207o
        fm      $ahead_3,$rest_5,$za_6                  # 208e
        lqd     $origin_12,272($a_shear_2)              # 208o
        xor     $seen,$det_2,$slope_7                   # 209e of -1 / direction z
        lqd     $origin_13,336($a_shear_2)              # 209o
        or      $outside_4,$rest_3,$v_3                 # 210e
        shufb   $xa,$vertex_a,$vertex_a,$axis_11        # 210o
        xor     $t,$ahead,$k_sign                       # 211e
        shufb   $za_2,$vertex_a,$vertex_a,$axis_12      # 211o
        or      $seen,$seen,$both                       # 212e
        shufb   $yc_7,$vertex_c_4,$vertex_c_4,$axis_13  # 212o
        or      $outside_5,$outside_4,$w_3              # 213e
        shufb   $zb_3,$vertex_b_4,$vertex_b_4,$axis_12  # 213o
        fm      $sum_4,$yb_7,$xa_8                      # 214e
        shufb   $yb_8,$vertex_b_4,$vertex_b_4,$axis_13  # 214o
        fm      $w_6,$w_5,$inverse_3                    # 215e
        shufb   $zc_7,$vertex_c_4,$vertex_c_4,$axis_12  # 215o
        cgt     $control_5,$t_best,$t                   # 216e
        shufb   $xb_6,$vertex_b_4,$vertex_b_4,$axis_11  # 216o
        fms     $rest_6,$xc_11,$yb_7,$sum_9             # 217e
        lqd     $slope_12,464($a_shear_2)               # 217o
        fms     $header_10,$yc_6,$xb,$sum_9             # 218e
        lqd     $slope_13,400($a_shear_2)               # 218o
        fms     $header_11,$ya_5,$xc_11,$sum_10         # 219e
        lqd     $axis_14,0($a_shear_2)                  # 219o
        fms     $v_4,$xa_8,$yc_6,$sum_10                # 220e
        lqd     $axis_7,64($a_shear_2)                  # 220o
        fma     $ahead_4,$v_5,$zb_6,$ahead_3            # 221e
        shufb   $ya_7,$vertex_a,$vertex_a,$axis_13      # 221o
        orc     $outside_5,$outside_5,$seen             # 222e
        shufb   $xc_7,$vertex_c_4,$vertex_c_4,$axis_11  # 222o
        and     $control_6,$control_5,$ahead            # 223e
        lqd     $axis_15,128($a_shear_2)                # 223o
        fms     $header_12,$yb_7,$xa_8,$sum_4           # 224e
        lnop                                            # 224o pairing
        andc    $control_7,$control_6,$outside_5        # 225e
        shufb   $xc_12,$vertex_c_4,$vertex_c_4,$axis_14 # 225o
        fms     $w_7,$xb,$ya_5,$sum_4                   # 226e
        shufb   $yc_8,$vertex_c_4,$vertex_c_4,$axis_7   # 226o
        fs      $xa_8,$xa,$origin_10                    # 227e
        rotqbii $control_7,$control_7,1                 # 227o
        fs      $yc_9,$yc_7,$origin_12                  # 228e
        shufb   $xb_3,$vertex_b_4,$vertex_b_4,$axis_14  # 228o
        fs      $rest_3,$rest_6,$header_10              # 229e
        shufb   $yb_4,$vertex_b_4,$vertex_b_4,$axis_7   # 229o
        fs      $yb_9,$yb_8,$origin_12                  # 230e
        shufb   $xa,$vertex_a,$vertex_a,$axis_14        # 230o
        fs      $za_3,$za_2,$origin_13                  # 231e
        gb      $control_7,$control_7                   # 231o
        fs      $zb_3,$zb_3,$origin_13                  # 232e
        shufb   $za_4,$vertex_a,$vertex_a,$axis_15      # 232o
        fs      $v_6,$v_4,$header_11                    # 233e
        shufb   $zc_4,$vertex_c_4,$vertex_c_4,$axis_15  # 233o
        fma     $ahead_5,$w_6,$zc_6,$ahead_4            # 234e
        shufb   $ya_8,$vertex_a,$vertex_a,$axis_7       # 234o
        fs      $zc_3,$zc_7,$origin_13                  # 235e
        shlqbii $control_7,$control_7,4                 # 235o
        fs      $xb_7,$xb_6,$origin_10                  # 236e
        shufb   $zb_4,$vertex_b_4,$vertex_b_4,$axis_15  # 236o
        or      $object,$index_4,$hit                   # 237e
        a       $a_packet,$a_packet_4,$rows_2           # 238e
        fs      $w_7,$w_7,$header_12                    # 239e
        shufb   $nearest_3,$nearest_2,$object,$control_4 # 239o
        fs      $ya_9,$ya_7,$origin_12                  # 240e
        fnms    $xa_3,$slope_13,$za_3,$xa_8             # 241e
        fs      $xc_13,$xc_7,$origin_10                 # 242e
        lnop                                            # 242o pairing
        fnms    $yb,$slope_12,$zb_3,$yb_9               # 243e
        stqd    $nearest_3,464($a_packet_3)             # 243o
        fm      $ahead_6,$ahead_5,$slope_2              # 244e
        lqd     $t_best_2,400($a_packet)                # 244o
        fa      $det_5,$rest_3,$v_6                     # 245e
        lqx     $control,$control_7,$a_controls         # 245o
        fnms    $xb_4,$slope_13,$zb_3,$xb_7             # 246e
        fnms    $yc_10,$slope_12,$zc_3,$yc_9            # 247e
        xor     $seen_4,$det_4,$slope_2                 # 248e of -1 / direction z
        or      $outside_6,$rest_5,$v_5                 # 249e
        fs      $yc_5,$yc_8,$origin_11                  # 250e
        fs      $xc_10,$xc_12,$origin_4                 # 251e
        fnms    $xc_4,$slope_13,$zc_3,$xc_13            # 252e
        fnms    $ya_3,$slope_12,$za_3,$ya_9             # 253e
        xor     $t_3,$ahead_6,$k_sign                   # 254e
        fa      $det,$det_5,$w_7                        # 255e
        fm      $sum_11,$yb,$xa_3                       # 256e
        fm      $sum_2,$yc_10,$xb_4                     # 257e
        or      $seen_5,$seen_4,$both                   # 258e
        or      $outside_6,$outside_6,$w_6              # 259e
        cgt     $control_4,$t_best_2,$t_3               # 260e
        orc     $outside_5,$outside_6,$seen_5           # 261e
        and     $control_8,$control_4,$ahead_6          # 262e
        lnop                                            # 262o pairing
next_rows:
            fm      $sum,$ya_3,$xc_4                    # 0e
            lnop                                        # 0o pairing
            xor     $seen,$det,$slope_11                # 1e of -1 / direction z
            frest   $t_y,$det                           # 1o
            fs      $xa,$xa,$origin_4                   # 2e
            shufb   $nearest,$nearest,$object,$control  # 2o
            or      $object,$index,$hit                 # 3e
            shufb   $t_best,$t_best,$t,$control         # 3o
            fms     $header,$yb,$xa_3,$sum_11           # 4e
            shufb   $index,$index_3,$index_3,$m_splat   # 4o
            fms     $w,$xb_4,$ya_3,$sum_11              # 5e
            lqd     $nearest_3,464($a_packet)           # 5o
            fms     $header_13,$yc_10,$xb_4,$sum_2      # 6e
            stqd    $nearest,448($a_packet_3)           # 6o
            fms     $v,$xa_3,$yc_10,$sum                # 7e
            stqd    $t_best,384($a_packet_3)            # 7o
            fi      $t_y,$det,$t_y                      # 8e
            shlqbyi $a_packet_3,$a_packet,0             # 8o copy
            andc    $control,$control_8,$outside_5      # 9e
            lqd     $t_best,384($a_packet)              # 9o
            fms     $rest,$xc_4,$yb,$sum_2              # 10e
            lqd     $nearest,448($a_packet)             # 10o
            a       $a_packet,$a_packet_2,$rows         # 11e
            xori    $rows,$rows,32                      # 12e
            fms     $header_6,$ya_3,$xc_4,$sum          # 13e
            ceqi    $next,$rows,0                       # 14e
            fs      $w,$w,$header                       # 15e
            andi    $next,$next,4                       # 16e
            fnms    $t_e,$det,$t_y,$k_above_one         # 17e
            a       $at_2,$at,$next                     # 18e
            fs      $rest,$rest,$header_13              # 19e
            cgt     $more,$ends,$at_2                   # 20e
            fs      $v,$v,$header_6                     # 21e
            andc    $ends,$k_step,$more                 # 22e
            and     $at,$at_2,$more                     # 23e
            a       $a_candidate,$a_candidate,$ends     # 24e
            fma     $inverse,$t_e,$t_y,$t_y             # 25e
            lnop                                        # 25o pairing
            or      $seen,$seen,$both                   # 26e
        lqd     $candidate,0($a_candidate)              # 26o
            fs      $ya,$ya_8,$origin_11                # 27e
            fa      $det,$rest,$v                       # 28e
        ai      $passes,$passes,-1                      # 29e
            fs      $yb,$yb_4,$origin_11                # 30e
            fm      $rest_7,$rest_3,$inverse            # 31e
            lqd     $origin,320($a_shear_2)             # 31o
        andi    $index_2,$candidate,511                 # 32e 4 times it
        rotqbyi $a_shear,$candidate,8                   # 32o
            fm      $v_7,$v_6,$inverse                  # 33e
        rotqbyi $a_packet_2,$candidate,4                # 33o
            fm      $w_8,$w_7,$inverse                  # 34e
        rotqmbyi $ends,$candidate,-1                    # 34o 4 times the run's length
        a       $index_2,$index_2,$at                   # 35e
            lqd     $slope,448($a_shear_2)              # 35o
            fa      $det,$det,$w                        # 36e
        lqd     $a_shear,192($a_shear)                  # 36o
            fm      $ahead,$rest_7,$za                  # 37e
        rotqmbii $index_3,$index_2,-2                   # 37o
            fs      $za,$za_4,$origin                   # 38e
        lqx     $face,$a_faces,$index_2                 # 38o
            or      $outside,$rest_7,$v_7               # 39e
        rotqmbii $ends,$ends,-6                         # 39o
        a       $vertex_a,$a_faces,$index_2             # 40e
            lqd     $slope_14,384($a_shear_2)           # 40o
            or      $outside,$outside,$w_8              # 41e
            lqd     $slope_15,528($a_shear_2)           # 41o
            fs      $xb,$xb_3,$origin_4                 # 42e
            rotqbii $control,$control,1                 # 42o
            fma     $ahead,$v_7,$zb,$ahead              # 43e
            frest   $t_y,$det                           # 43o
            fs      $zb,$zb_4,$origin                   # 44e
        rotqby  $face,$face,$vertex_a                   # 44o
            fnms    $ya,$slope,$za,$ya                  # 45e
        rotqbyi $a_shear,$a_shear,8                     # 45o
            fnms    $xa,$slope_14,$za,$xa               # 46e
            gb      $control,$control                   # 46o
            fi      $t_y,$det,$t_y                      # 47e
            lnop                                        # 47o pairing
            xor     $seen_6,$det,$slope_15              # 48e of -1 / direction z
        shufb   $face,$face,$face,$m_indices            # 48o
            fma     $ahead,$w_8,$zc,$ahead              # 49e
            lnop                                        # 49o pairing
            fs      $zc,$zc_4,$origin                   # 50e
            shlqbii $control,$control,4                 # 50o
            fnms    $yb,$slope,$zb,$yb                  # 51e
            lnop                                        # 51o pairing
            fnms    $xb,$slope_14,$zb,$xb               # 52e
        shlqbii $face,$face,4                           # 52o
            or      $seen_6,$seen_6,$both               # 53e
            lnop                                        # 53o pairing
            fnms    $t_e,$det,$t_y,$k_above_one         # 54e
            lqx     $control,$control,$a_controls       # 54o
            fm      $ahead,$ahead,$slope_11             # 55e
            lqd     $slope_11,512($a_shear_2)           # 55o
        a       $a_shear_2,$a_shear,$rows               # 56e
        hbrr    next_rows_back,next_rows                # 56o hint
            fnms    $yc,$slope,$zc,$yc_5                # 57e
        rotqbyi $vertex_c_5,$face,8                     # 57o
            fnms    $xc,$slope_14,$zc,$xc_10            # 58e
        lqx     $vertex_a,$a_vertices,$face             # 58o
            fm      $sum,$yb,$xa                        # 59e
        lqd     $origin,208($a_shear_2)                 # 59o
            fma     $inverse,$t_e,$t_y,$t_y             # 60e
            shufb   $t_best_4,$t_best_2,$t_3,$control   # 60o
            xor     $t,$ahead,$k_sign                   # 61e
        rotqbyi $vertex_b_5,$face,4                     # 61o
            orc     $outside,$outside,$seen             # 62e
        lqd     $origin_4,192($a_shear_2)               # 62o
            fm      $sum_4,$yc,$xb                      # 63e
        lqd     $origin_11,256($a_shear_2)              # 63o
            fm      $sum_5,$ya,$xc                      # 64e
            stqd    $t_best_4,400($a_packet_3)          # 64o
            fms     $header,$yb,$xa,$sum                # 65e
        lqx     $vertex_c_6,$a_vertices,$vertex_c_5     # 65o
            fm      $rest,$rest,$inverse                # 66e
        lqd     $axis_2,16($a_shear_2)                  # 66o
            fm      $v,$v,$inverse                      # 67e
        lqd     $axis_3,144($a_shear_2)                 # 67o
            fm      $w,$w,$inverse                      # 68e
        lqd     $axis_4,80($a_shear_2)                  # 68o
            cgt     $control_9,$t_best,$t               # 69e
        lqd     $axis_5,128($a_shear_2)                 # 69o
            fms     $rest_8,$xc,$yb,$sum_4              # 70e
        lqx     $vertex_b_5,$a_vertices,$vertex_b_5     # 70o
            fms     $header_4,$yc,$xb,$sum_4            # 71e
        lqd     $axis_6,0($a_shear_2)                   # 71o
            fms     $w_7,$xb,$ya,$sum                   # 72e
        shufb   $xa_2,$vertex_a,$vertex_a,$axis_2       # 72o
            or      $outside_6,$rest,$v                 # 73e
        lqd     $axis_7,64($a_shear_2)                  # 73o
            and     $control_9,$control_9,$ahead        # 74e
        shufb   $yc_2,$vertex_c_6,$vertex_c_6,$axis_4   # 74o
            or      $outside_6,$outside_6,$w            # 75e
        shufb   $ya_2,$vertex_a,$vertex_a,$axis_4       # 75o
            andc    $control_9,$control_9,$outside      # 76e
        lqd     $origin_2,272($a_shear_2)               # 76o
            fms     $header_14,$ya,$xc,$sum_5           # 77e
        shufb   $za_2,$vertex_a,$vertex_a,$axis_3       # 77o
            fms     $v_8,$xa,$yc,$sum_5                 # 78e
        shufb   $zb_2,$vertex_b_5,$vertex_b_5,$axis_3   # 78o
            fm      $ahead_7,$rest,$za_3                # 79e
        shufb   $xc_5,$vertex_c_6,$vertex_c_6,$axis_6   # 79o
            fs      $w_7,$w_7,$header                   # 80e
        lqd     $origin_3,336($a_shear_2)               # 80o
        fs      $xa_2,$xa_2,$origin                     # 81e
        shufb   $yb_2,$vertex_b_5,$vertex_b_5,$axis_4   # 81o
        fs      $ya_2,$ya_2,$origin_2                   # 82e
        shufb   $yc_4,$vertex_c_6,$vertex_c_6,$axis_7   # 82o
        fs      $yc_2,$yc_2,$origin_2                   # 83e
        lqd     $slope_2,464($a_shear_2)                # 83o
            fs      $rest_3,$rest_8,$header_4           # 84e
        shufb   $zc_2,$vertex_c_6,$vertex_c_6,$axis_3   # 84o
        fs      $yb_3,$yb_2,$origin_2                   # 85e
            shufb   $nearest_3,$nearest_3,$object,$control # 85o
            fma     $ahead_7,$v,$zb_3,$ahead_7          # 86e
        shufb   $xc_2,$vertex_c_6,$vertex_c_6,$axis_2   # 86o
        fs      $za_3,$za_2,$origin_3                   # 87e
        shufb   $xb_8,$vertex_b_5,$vertex_b_5,$axis_2   # 87o
        fs      $yc_5,$yc_4,$origin_11                  # 88e
        lqd     $slope_16,400($a_shear_2)               # 88o
        fs      $zb_3,$zb_2,$origin_3                   # 89e
            stqd    $nearest_3,464($a_packet_3)         # 89o
        fs      $xc_10,$xc_5,$origin_4                  # 90e
        shufb   $xb_3,$vertex_b_5,$vertex_b_5,$axis_6   # 90o
            fs      $v_6,$v_8,$header_14                # 91e
        shufb   $yb_4,$vertex_b_5,$vertex_b_5,$axis_7   # 91o
            fma     $ahead_6,$w,$zc_3,$ahead_7          # 92e
        shufb   $xa,$vertex_a,$vertex_a,$axis_6         # 92o
        fs      $zc_3,$zc_2,$origin_3                   # 93e
        shufb   $za_4,$vertex_a,$vertex_a,$axis_5       # 93o
        fs      $xb_8,$xb_8,$origin                     # 94e
        shufb   $zc_4,$vertex_c_6,$vertex_c_6,$axis_5   # 94o
        fnms    $xa_3,$slope_16,$za_3,$xa_2             # 95e
            rotqbii $control,$control_9,1               # 95o
        fs      $xc_14,$xc_2,$origin                    # 96e
        lnop                                            # 96o pairing
        fnms    $yb,$slope_2,$zb_3,$yb_3                # 97e
        shufb   $ya_8,$vertex_a,$vertex_a,$axis_7       # 97o
            fm      $ahead_6,$ahead_6,$slope_15         # 98e
            lnop                                        # 98o pairing
            fa      $det,$rest_3,$v_6                   # 99e
            gb      $control,$control                   # 99o
            orc     $outside_5,$outside_6,$seen_6       # 100e
            lnop                                        # 100o pairing
        fnms    $xb_4,$slope_16,$zb_3,$xb_8             # 101e
            lqd     $t_best_2,400($a_packet)            # 101o
        fnms    $yc_10,$slope_2,$zc_3,$yc_2             # 102e
        lnop                                            # 102o pairing
        fnms    $xc_4,$slope_16,$zc_3,$xc_14            # 103e
            shlqbii $control,$control,4                 # 103o
        fnms    $ya_3,$slope_2,$za_3,$ya_2              # 104e
        shufb   $zb_4,$vertex_b_5,$vertex_b_5,$axis_5   # 104o
            xor     $t_3,$ahead_6,$k_sign               # 105e
            fa      $det,$det,$w_7                      # 106e
            cgt     $control_10,$t_best_2,$t_3          # 107e
            lqx     $control,$control,$a_controls       # 107o
        fm      $sum_11,$yb,$xa_3                       # 108e
            and     $control_8,$control_10,$ahead_6     # 109e
        fm      $sum_2,$yc_10,$xb_4                     # 110e
next_rows_back:
        brnz    $passes,next_rows                       # 110o
next_rows_drain:
        fs      $ya_10,$ya_8,$origin_11                 # 0e
        shufb   $nearest,$nearest,$object,$control      # 0o
        fm      $sum,$ya_3,$xc_4                        # 1e
        shufb   $t_best,$t_best,$t,$control             # 1o
        fs      $xb_9,$xb_3,$origin_4                   # 2e
        lqd     $nearest_4,464($a_packet)               # 2o
        fs      $yb_10,$yb_4,$origin_11                 # 3e
        frest   $t_y,$det                               # 3o
        fms     $header_15,$yc_10,$xb_4,$sum_2          # 4e
        stqd    $nearest,448($a_packet_3)               # 4o
        fs      $xa,$xa,$origin_4                       # 5e
        stqd    $t_best,384($a_packet_3)                # 5o
        fms     $rest_9,$xc_4,$yb,$sum_2                # 6e
        lqd     $origin_14,320($a_shear_2)              # 6o
        fms     $v,$xa_3,$yc_10,$sum                    # 7e
        lqd     $slope_17,448($a_shear_2)               # 7o
        fms     $header_16,$ya_3,$xc_4,$sum             # 8e
        lqd     $slope_6,384($a_shear_2)                # 8o
        fi      $t_y,$det,$t_y                          # 9e
        lqd     $t_best,384($a_packet)                  # 9o
        andc    $control,$control_8,$outside_5          # 10e
        shlqbyi $a_packet_5,$a_packet,0                 # 10o copy
        fms     $header,$yb,$xa_3,$sum_11               # 11e
        lqd     $slope_18,528($a_shear_2)               # 11o
        fs      $zc_8,$zc_4,$origin_14                  # 12e
        rotqbii $control,$control,1                     # 12o
        fs      $zb_8,$zb_4,$origin_14                  # 13e
        lqd     $slope_19,512($a_shear_2)               # 13o
        fs      $za_7,$za_4,$origin_14                  # 14e
        lqd     $nearest,448($a_packet)                 # 14o
        fs      $v,$v,$header_16                        # 15e
        shufb   $index_3,$index_3,$index_3,$m_splat     # 15o
        fs      $rest,$rest_9,$header_15                # 16e
        gb      $control,$control                       # 16o
        fms     $w,$xb_4,$ya_3,$sum_11                  # 17e
        fnms    $yc,$slope_17,$zc_8,$yc_5               # 18e
        fnms    $xb_9,$slope_6,$zb_8,$xb_9              # 19e
        lnop                                            # 19o pairing
        fnms    $ya_10,$slope_17,$za_7,$ya_10           # 20e
        shlqbii $control,$control,4                     # 20o
        fnms    $xc,$slope_6,$zc_8,$xc_10               # 21e
        fnms    $xa,$slope_6,$za_7,$xa                  # 22e
        fnms    $yb_11,$slope_17,$zb_8,$yb_10           # 23e
        lnop                                            # 23o pairing
        fnms    $t_e,$det,$t_y,$k_above_one             # 24e
        lqx     $control,$control,$a_controls           # 24o
        fm      $sum_12,$yc,$xb_9                       # 25e
        fa      $det_6,$rest,$v                         # 26e
        fm      $sum_5,$ya_10,$xc                       # 27e
        fs      $w,$w,$header                           # 28e
        fm      $sum,$yb_11,$xa                         # 29e
        lnop                                            # 29o pairing
        fma     $inverse,$t_e,$t_y,$t_y                 # 30e
        shufb   $t_best_5,$t_best_2,$t_3,$control       # 30o
        fms     $header_17,$yc,$xb_9,$sum_12            # 31e
        fms     $rest_10,$xc,$yb_11,$sum_12             # 32e
        fms     $header_15,$ya_10,$xc,$sum_5            # 33e
        lnop                                            # 33o pairing
        fms     $v_9,$xa,$yc,$sum_5                     # 34e
        stqd    $t_best_5,400($a_packet_5)              # 34o
        fms     $header,$yb_11,$xa,$sum                 # 35e
        fms     $w_9,$xb_9,$ya_10,$sum                  # 36e
        fa      $det_7,$det_6,$w                        # 37e
        fs      $rest_9,$rest_10,$header_17             # 38e
        fm      $rest_10,$rest_3,$inverse               # 39e
        fs      $v_10,$v_9,$header_15                   # 40e
        fm      $v_11,$v_6,$inverse                     # 41e
        fs      $w_9,$w_9,$header                       # 42e
        fm      $w_10,$w_7,$inverse                     # 43e
        frest   $t_y,$det_7                             # 43o
        xor     $seen,$det,$slope_11                    # 44e of -1 / direction z
        fm      $ahead,$rest_10,$za                     # 45e
        fa      $det,$rest_9,$v_10                      # 46e
        fi      $t_y,$det_7,$t_y                        # 47e
        or      $outside,$rest_10,$v_11                 # 48e
        or      $seen,$seen,$both                       # 49e
        or      $outside,$outside,$w_10                 # 50e
        fma     $ahead,$v_11,$zb,$ahead                 # 51e
        fa      $det,$det,$w_9                          # 52e
        orc     $outside,$outside,$seen                 # 53e
        fnms    $t_e,$det_7,$t_y,$k_above_one           # 54e
        lnop                                            # 54o pairing
        or      $object,$index,$hit                     # 55e
        hbr     isect_mesh_pairs_r16_return,$lr         # 55o hint
        a       $a_packet,$a_packet_2,$rows             # 56e
        lnop                                            # 56o pairing
        fma     $ahead,$w_10,$zc,$ahead                 # 57e
        shufb   $nearest_5,$nearest_4,$object,$control  # 57o
        xor     $seen_5,$det_7,$slope_18                # 58e of -1 / direction z
        frest   $t_y_6,$det                             # 58o
        xor     $seen,$det,$slope_19                    # 59e of -1 / direction z
        shlqbyi $a_packet_6,$a_packet,0                 # 59o copy
        fma     $inverse,$t_e,$t_y,$t_y                 # 60e
        lnop                                            # 60o pairing
        or      $seen_5,$seen_5,$both                   # 61e
        stqd    $nearest_5,464($a_packet_5)             # 61o
        fi      $t_y,$det,$t_y_6                        # 62e
        lqd     $t_best_2,400($a_packet)                # 62o
        or      $seen,$seen,$both                       # 63e
        lqd     $nearest_5,464($a_packet)               # 63o
        fm      $ahead,$ahead,$slope_11                 # 64e
        or      $object_2,$index_3,$hit                 # 65e
        fm      $rest,$rest,$inverse                    # 66e
        fm      $v,$v,$inverse                          # 67e
        fm      $w,$w,$inverse                          # 68e
        fnms    $t_e,$det,$t_y,$k_above_one             # 69e
        xor     $t,$ahead,$k_sign                       # 70e
        xori    $rows,$rows,32                          # 71e
        fm      $ahead_7,$rest,$za_3                    # 72e
        cgt     $control_11,$t_best,$t                  # 73e
        or      $outside_6,$rest,$v                     # 74e
        fma     $inverse,$t_e,$t_y,$t_y                 # 75e
        and     $control_9,$control_11,$ahead           # 76e
        or      $outside_6,$outside_6,$w                # 77e
        andc    $control_9,$control_9,$outside          # 78e
        fma     $ahead_7,$v,$zb_3,$ahead_7              # 79e
        orc     $outside_7,$outside_6,$seen_5           # 80e
        rotqbii $control,$control_9,1                   # 80o
        fm      $rest_9,$rest_9,$inverse                # 81e
        fm      $v_10,$v_10,$inverse                    # 82e
        fm      $w_9,$w_9,$inverse                      # 83e
        lnop                                            # 83o pairing
        ceqi    $next,$rows,0                           # 84e
        gb      $control,$control                       # 84o
        fma     $ahead_2,$w,$zc_3,$ahead_7              # 85e
        andi    $next,$next,4                           # 86e
        fm      $ahead,$rest_9,$za_7                    # 87e
        lnop                                            # 87o pairing
        or      $outside,$rest_9,$v_10                  # 88e
        shlqbii $control,$control,4                     # 88o
        a       $at_4,$at,$next                         # 89e
        or      $outside,$outside,$w_9                  # 90e
        fm      $ahead_2,$ahead_2,$slope_18             # 91e
        lnop                                            # 91o pairing
        orc     $outside,$outside,$seen                 # 92e
        lqx     $control,$control,$a_controls           # 92o
        fma     $ahead,$v_10,$zb_8,$ahead               # 93e
        cgt     $more,$ends,$at_4                       # 94e
        andc    $ends,$k_step,$more                     # 96e
        xor     $t_3,$ahead_2,$k_sign                   # 97e
        a       $a_candidate,$a_candidate,$ends         # 98e
        shufb   $nearest,$nearest,$object,$control      # 98o
        fma     $ahead,$w_9,$zc_8,$ahead                # 99e
        shufb   $t_best,$t_best,$t,$control             # 99o
        cgt     $control_12,$t_best_2,$t_3              # 100e
        and     $at,$at_4,$more                         # 101e
        and     $control_8,$control_12,$ahead_2         # 102e
        stqd    $nearest,448($a_packet_5)               # 102o
        nop     $127                                    # 103e pairing
        stqd    $t_best,384($a_packet_5)                # 103o
        andc    $control,$control_8,$outside_7          # 104e
        lqd     $t_best,384($a_packet)                  # 104o
        fm      $ahead,$ahead,$slope_19                 # 105e
        lqd     $nearest,448($a_packet)                 # 105o
        rotqbii $control,$control,1                     # 106o
        gb      $control,$control                       # 110o
        xor     $t,$ahead,$k_sign                       # 111e
        cgt     $control_9,$t_best,$t                   # 113e
        shlqbii $control,$control,4                     # 114o
        and     $control_9,$control_9,$ahead            # 115e
        andc    $control_9,$control_9,$outside          # 117e
        lqx     $control,$control,$a_controls           # 118o
        rotqbii $control_12,$control_9,1                # 119o
        gb      $control_12,$control_12                 # 123o
        shufb   $nearest_2,$nearest_5,$object_2,$control # 124o
        shufb   $t_best_6,$t_best_2,$t_3,$control       # 125o
        shlqbii $control,$control_12,4                  # 127o
        stqd    $t_best_6,400($a_packet_6)              # 129o
        stqd    $nearest_2,464($a_packet_6)             # 130o
        lqx     $control,$control,$a_controls           # 131o
        shufb   $nearest,$nearest,$object_2,$control    # 137o
        shufb   $t_best,$t_best,$t,$control             # 138o
        stqd    $nearest,448($a_packet_6)               # 141o
        stqd    $t_best,384($a_packet_6)                # 142o
        nop     $127                                    # 143e pairing
isect_mesh_pairs_r16_return:
        bi      $lr                                     # 143o
next_run_short:
        ai      $count,$count,-1                        # 0e
        lqd     $candidate,0($a_first)                  # 0o
        ai      $a_first,$a_first,16                    # 1e
        rotmi   $candidate,$candidate,-16               # 6e
        a       $passes,$passes,$candidate              # 10e
        brnz    $count,next_run_short                   # 10o
        nop     $127                                    # 11e pairing
        br      isect_mesh_pairs_r16_block              # 11o
next_rows_short:
        ai      $passes,$passes,-1                      # 0e
        lqd     $candidate,0($a_candidate)              # 0o
        andi    $index,$candidate,511                   # 6e 4 times it
        rotqbyi $a_shear,$candidate,8                   # 6o
        nop     $127                                    # 7e pairing
        rotqbyi $a_packet,$candidate,4                  # 7o
        a       $index,$index,$at                       # 8e
        rotqmbyi $ends,$candidate,-1                    # 8o 4 times the run's length
        a       $vertex_a,$a_faces,$index               # 10e
        lqx     $face,$a_faces,$index                   # 10o
        a       $a_packet,$a_packet,$rows               # 11e
        lqd     $a_shear,192($a_shear)                  # 11o
        rotqmbii $index,$index,-2                       # 12o
        lqd     $t_best,384($a_packet)                  # 13o
        lqd     $t_best_7,400($a_packet)                # 14o
        lqd     $nearest,448($a_packet)                 # 15o
        rotqby  $face,$face,$vertex_a                   # 16o
        rotqbyi $a_shear,$a_shear,8                     # 17o
        shufb   $index,$index,$index,$m_splat           # 18o
        rotqmbii $ends,$ends,-6                         # 19o
        nop     $127                                    # 20e pairing
        shufb   $face,$face,$face,$m_indices            # 20o
        a       $a_shear,$a_shear,$rows                 # 21e
        lqd     $nearest_2,464($a_packet)               # 21o
        xori    $rows,$rows,32                          # 22e
        lnop                                            # 22o pairing
        or      $object,$index,$hit                     # 23e
        lqd     $axis,0($a_shear)                       # 23o
        ceqi    $next,$rows,0                           # 24e
        shlqbii $face,$face,4                           # 24o
        nop     $127                                    # 25e pairing
        lqd     $axis_16,64($a_shear)                   # 25o
        andi    $next,$next,4                           # 26e
        lqd     $axis_17,128($a_shear)                  # 26o
        nop     $127                                    # 27e pairing
        lqd     $origin,192($a_shear)                   # 27o
        a       $at,$at,$next                           # 28e
        rotqbyi $vertex_b,$face,4                       # 28o
        nop     $127                                    # 29e pairing
        rotqbyi $vertex_c,$face,8                       # 29o
        cgt     $more,$ends,$at                         # 30e
        lqx     $vertex_a,$a_vertices,$face             # 30o
        nop     $127                                    # 31e pairing
        lqd     $origin_15,256($a_shear)                # 31o
        andc    $ends,$k_step,$more                     # 32e
        lqx     $vertex_b,$a_vertices,$vertex_b         # 32o
        and     $at,$at,$more                           # 33e
        lqx     $vertex_c,$a_vertices,$vertex_c         # 33o
        a       $a_candidate,$a_candidate,$ends         # 34e
        lqd     $origin_16,320($a_shear)                # 34o
        lqd     $slope,384($a_shear)                    # 35o
        shufb   $ya,$vertex_a,$vertex_a,$axis_16        # 36o
        shufb   $za,$vertex_a,$vertex_a,$axis_17        # 37o
        shufb   $xb,$vertex_b,$vertex_b,$axis           # 38o
        nop     $127                                    # 39e pairing
        shufb   $xc,$vertex_c,$vertex_c,$axis           # 39o
        fs      $ya,$ya,$origin_15                      # 40e
        shufb   $yc,$vertex_c,$vertex_c,$axis_16        # 40o
        fs      $za,$za,$origin_16                      # 41e
        shufb   $zb,$vertex_b,$vertex_b,$axis_17        # 41o
        fs      $xb,$xb,$origin                         # 42e
        shufb   $zc,$vertex_c,$vertex_c,$axis_17        # 42o
        fs      $xc,$xc,$origin                         # 43e
        lqd     $slope_15,448($a_shear)                 # 43o
        fs      $yc,$yc,$origin_15                      # 44e
        shufb   $xa,$vertex_a,$vertex_a,$axis           # 44o
        fs      $zb,$zb,$origin_16                      # 45e
        shufb   $yb,$vertex_b,$vertex_b,$axis_16        # 45o
        fs      $zc,$zc,$origin_16                      # 46e
        lqd     $axis,16($a_shear)                      # 46o
        nop     $127                                    # 47e pairing
        lqd     $axis_16,80($a_shear)                   # 47o
        fs      $xa,$xa,$origin                         # 48e
        lqd     $axis_8,144($a_shear)                   # 48o
        fs      $yb,$yb,$origin_15                      # 49e
        lqd     $origin,208($a_shear)                   # 49o
        fnms    $ya,$slope_15,$za,$ya                   # 50e
        lqd     $origin_15,272($a_shear)                # 50o
        fnms    $xb,$slope,$zb,$xb                      # 51e
        lqd     $origin_5,336($a_shear)                 # 51o
        fnms    $xc,$slope,$zc,$xc                      # 52e
        shufb   $xb_10,$vertex_b,$vertex_b,$axis        # 52o
        fnms    $yc,$slope_15,$zc,$yc                   # 53e
        shufb   $xc_13,$vertex_c,$vertex_c,$axis        # 53o
        fnms    $xa,$slope,$za,$xa                      # 54e
        shufb   $ya_11,$vertex_a,$vertex_a,$axis_16     # 54o
        fnms    $yb,$slope_15,$zb,$yb                   # 55e
        shufb   $yc_11,$vertex_c,$vertex_c,$axis_16     # 55o
        fs      $xb_10,$xb_10,$origin                   # 56e
        shufb   $za_8,$vertex_a,$vertex_a,$axis_8       # 56o
        fs      $xc_13,$xc_13,$origin                   # 57e
        shufb   $zb_9,$vertex_b,$vertex_b,$axis_8       # 57o
        fm      $sum,$ya,$xc                            # 58e
        shufb   $zc_9,$vertex_c,$vertex_c,$axis_8       # 58o
        fm      $sum_13,$yc,$xb                         # 59e
        lqd     $slope_20,400($a_shear)                 # 59o
        fs      $ya_11,$ya_11,$origin_15                # 60e
        lqd     $slope_21,464($a_shear)                 # 60o
        fs      $yc_11,$yc_11,$origin_15                # 61e
        shufb   $xa_9,$vertex_a,$vertex_a,$axis         # 61o
        fs      $za_8,$za_8,$origin_5                   # 62e
        shufb   $yb_11,$vertex_b,$vertex_b,$axis_16     # 62o
        fs      $zb_10,$zb_9,$origin_5                  # 63e
        lqd     $slope,512($a_shear)                    # 63o
        fs      $zc_9,$zc_9,$origin_5                   # 64e
        lqd     $slope_17,528($a_shear)                 # 64o
        fms     $header_4,$yc,$xb,$sum_13               # 65e
        fms     $rest_11,$xc,$yb,$sum_13                # 66e
        fms     $header_5,$ya,$xc,$sum                  # 67e
        fms     $v,$xa,$yc,$sum                         # 68e
        fm      $sum,$yb,$xa                            # 69e
        fs      $xa_9,$xa_9,$origin                     # 70e
        fs      $yb_11,$yb_11,$origin_15                # 71e
        fnms    $xb_4,$slope_20,$zb_10,$xb_10           # 72e
        fnms    $xc_15,$slope_20,$zc_9,$xc_13           # 73e
        fnms    $ya_12,$slope_21,$za_8,$ya_11           # 74e
        fnms    $yc,$slope_21,$zc_9,$yc_11              # 75e
        fs      $rest_12,$rest_11,$header_4             # 76e
        fs      $v,$v,$header_5                         # 77e
        fms     $header_4,$yb,$xa,$sum                  # 78e
        fms     $w,$xb,$ya,$sum                         # 79e
        fnms    $xa,$slope_20,$za_8,$xa_9               # 80e
        fnms    $yb,$slope_21,$zb_10,$yb_11             # 81e
        fm      $sum,$yc,$xb_4                          # 82e
        fm      $sum_14,$ya_12,$xc_15                   # 83e
        fa      $det,$rest_12,$v                        # 84e
        fs      $w,$w,$header_4                         # 85e
        fm      $sum_4,$yb,$xa                          # 87e
        fms     $header,$yc,$xb_4,$sum                  # 88e
        fms     $rest,$xc_15,$yb,$sum                   # 89e
        fms     $header_18,$ya_12,$xc_15,$sum_14        # 90e
        fms     $v_12,$xa,$yc,$sum_14                   # 91e
        fa      $det,$det,$w                            # 92e
        fms     $header_16,$yb,$xa,$sum_4               # 93e
        fms     $w_2,$xb_4,$ya_12,$sum_4                # 94e
        fs      $rest,$rest,$header                     # 95e
        fs      $v_12,$v_12,$header_18                  # 97e
        lnop                                            # 97o pairing
        xor     $seen,$det,$slope                       # 98e of -1 / direction z
        frest   $t_y,$det                               # 98o
        fs      $w_2,$w_2,$header_16                    # 100e
        or      $seen,$seen,$both                       # 101e
        fi      $t_y,$det,$t_y                          # 102e
        fa      $det_8,$rest,$v_12                      # 104e
        fnms    $t_e,$det,$t_y,$k_above_one             # 109e
        fa      $det,$det_8,$w_2                        # 110e
        fma     $inverse,$t_e,$t_y,$t_y                 # 115e
        lnop                                            # 115o pairing
        xor     $seen_7,$det,$slope_17                  # 116e of -1 / direction z
        frest   $t_y,$det                               # 116o
        or      $seen_7,$seen_7,$both                   # 118e
        fi      $t_y,$det,$t_y                          # 120e
        fm      $rest_12,$rest_12,$inverse              # 122e
        fm      $v,$v,$inverse                          # 123e
        fm      $w,$w,$inverse                          # 124e
        fnms    $t_e,$det,$t_y,$k_above_one             # 127e
        fm      $ahead,$rest_12,$za                     # 128e
        or      $outside,$rest_12,$v                    # 129e
        or      $outside,$outside,$w                    # 131e
        fma     $inverse,$t_e,$t_y,$t_y                 # 133e
        fma     $ahead,$v,$zb,$ahead                    # 134e
        orc     $outside,$outside,$seen                 # 135e
        fm      $rest,$rest,$inverse                    # 139e
        fma     $ahead,$w,$zc,$ahead                    # 140e
        fm      $v,$v_12,$inverse                       # 141e
        fm      $w,$w_2,$inverse                        # 142e
        fm      $ahead_8,$rest,$za_8                    # 145e
        fm      $ahead,$ahead,$slope                    # 146e
        or      $outside_5,$rest,$v                     # 147e
        or      $outside_5,$outside_5,$w                # 149e
        fma     $ahead_8,$v,$zb_10,$ahead_8             # 151e
        xor     $t,$ahead,$k_sign                       # 152e
        orc     $outside_5,$outside_5,$seen_7           # 153e
        cgt     $control,$t_best,$t                     # 154e
        and     $control,$control,$ahead                # 156e
        fma     $ahead,$w,$zc_9,$ahead_8                # 157e
        andc    $control,$control,$outside              # 158e
        rotqbii $control,$control,1                     # 160o
        fm      $ahead,$ahead,$slope_17                 # 163e
        gb      $control,$control                       # 164o
        shlqbii $control,$control,4                     # 168o
        xor     $t_4,$ahead,$k_sign                     # 169e
        cgt     $control_13,$t_best_7,$t_4              # 171e
        lqx     $control,$control,$a_controls           # 172o
        and     $control_13,$control_13,$ahead          # 173e
        andc    $control_7,$control_13,$outside_5       # 175e
        rotqbii $control_7,$control_7,1                 # 177o
        shufb   $t_best,$t_best,$t,$control             # 178o
        shufb   $nearest,$nearest,$object,$control      # 179o
        gb      $control,$control_7                     # 181o
        stqd    $t_best,384($a_packet)                  # 182o
        stqd    $nearest,448($a_packet)                 # 183o
        hbrr    next_rows_short_back,next_rows_short    # 184o hint
        shlqbii $control,$control,4                     # 185o
        lqx     $control,$control,$a_controls           # 189o
        shufb   $t_best,$t_best_7,$t_4,$control         # 195o
        shufb   $nearest,$nearest_2,$object,$control    # 196o
        stqd    $t_best,400($a_packet)                  # 199o
        stqd    $nearest,464($a_packet)                 # 200o
next_rows_short_back:
        brnz    $passes,next_rows_short                 # 201o
        nop     $127                                    # 202e pairing
        bi      $lr                                     # 202o
endfunction isect_mesh_pairs_r16
