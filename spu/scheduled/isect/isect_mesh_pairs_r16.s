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
# branches.
#
# That loop counts up, so that it isn't pipelined. Pipelined it would take 209 cycles a triangle
# instead of 281, but 5.8 KB of local store instead of 1.6; a block of a mesh has 2. With two rows
# of rays in a pass it would take 222 cycles and 4.2 KB.
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
        .set count_2,79; .set candidate_2,2; .set at_2,2; .set t_best_2,4; .set t_best_3,5
        .set t_best_4,6; .set axis_2,7; .set axis_3,8; .set axis_4,9; .set origin_2,21
        .set origin_3,23; .set axis_5,24; .set origin_4,27; .set origin_5,29; .set axis_6,33
        .set axis_7,35; .set origin_6,36; .set axis_8,37; .set ya_2,38; .set za_2,39; .set xb_2,41
        .set xb_3,44; .set za_3,45; .set axis_9,46; .set yc_2,47; .set origin_7,48; .set zb_2,49
        .set xb_4,50; .set slope_2,51; .set za_4,52; .set zc_2,53; .set zb_3,46; .set zc_3,35
        .set origin_8,54; .set yb_2,9; .set zb_4,23; .set yb_3,46; .set zb_5,55; .set xc_2,56
        .set xa_2,36; .set xc_3,24; .set origin_9,57; .set slope_3,60; .set xc_4,62
        .set slope_4,63; .set ya_3,64; .set zb_6,43; .set yc_3,42; .set zc_4,7; .set ya_4,49
        .set slope_5,57; .set axis_10,48; .set slope_6,27; .set slope_7,64; .set axis_11,65
        .set xa_3,8; .set axis_12,66; .set origin_10,67; .set ya_5,68; .set slope_8,69
        .set za_5,70; .set slope_9,71; .set zc_5,72; .set xb_5,21; .set sum_2,73; .set yc_4,74
        .set sum_3,75; .set origin_11,76; .set xc_5,32; .set xa_4,29; .set xa_5,30; .set zb_7,36
        .set yb_4,31; .set slope_10,48; .set sum_4,60; .set slope_11,65; .set slope_12,26
        .set nearest_2,64; .set sum_5,66; .set nearest_3,77; .set nearest_4,78; .set header_2,63
        .set sum_6,57; .set yb_5,27; .set za_6,46; .set v_2,70; .set header_3,54; .set v_3,57
        .set rest_2,76; .set header_4,73; .set rest_3,56; .set header_5,40; .set header_6,47
        .set v_4,63; .set sum_7,70; .set rest_4,44; .set header_7,24; .set v_5,42; .set sum_8,56
        .set rest_5,60; .set v_6,54; .set w_2,34; .set v_7,24; .set header_8,27; .set rest_6,30
        .set w_3,38; .set det_2,41; .set header_9,33; .set header_10,8; .set sum_9,9; .set det_3,37
        .set w_4,27; .set sum_10,33; .set w_5,8; .set header_11,34; .set rest_7,9; .set det_4,38
        .set v_8,40; .set header_12,32; .set det_5,33; .set sum_11,37; .set t_y_2,34; .set t_y_3,41
        .set seen_2,42; .set v_9,32; .set t_y_4,40; .set seen_3,57; .set header_13,29; .set w_6,21
        .set det_6,31; .set t_y_5,37; .set seen_4,40; .set t_e_2,38; .set t_e_3,42; .set seen_5,29
        .set t_e_4,33; .set inverse_2,38; .set inverse_3,34; .set object_2,28; .set inverse_4,31
        .set rest_8,33; .set v_10,41; .set seen_6,37; .set ahead_2,39; .set ahead_3,44
        .set t_e_5,31; .set ahead_4,23; .set ahead_5,38; .set inverse_5,30; .set ahead_6,7
        .set outside_2,8; .set w_7,9; .set v_11,21; .set ahead_7,30; .set outside_3,24; .set t_2,29
        .set t_3,31; .set control_2,32; .set control_3,7; .set ahead_8,27; .set control_4,8
        .set control_5,2; .set t_4,8; .set control_6,9; .set nearest_5,2; .set control_7,5
        .set nearest_6,7
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
        lqd     $rest,16($a_block)                      # 0o
        ila     $m_splat,0x10203                        # 1e
        lqd     $header,0($a_block)                     # 1o
        il      $k_step,16                              # 2e
        lqa     $m_indices,vertex_indices               # 2o
        ori     $triangles,$a_first,0                   # 3e
        ilhu    $k_above_one,0x3f80                     # 4e
        sfi     $triangles,$triangles,0                 # 5e
        lnop                                            # 5o pairing
        mpyi    $a_vertices,$rest,112                   # 6e
        rotqbyi $both,$rest,12                          # 6o
        iohl    $k_above_one,2                          # 7e
        rotqbyi $hit,$header,4                          # 7o
        ila     $a_controls,sign_controls               # 8e
        rotqbyi $a_faces,$rest,8                        # 8o
        il      $at,0                                   # 9e
        shli    $both,$both,1                           # 10e SIDES_BOTH to the sign
        shli    $hit,$hit,7                             # 11e
        shli    $a_faces,$a_faces,4                     # 12e
        a       $a_vertices,$a_vertices,$a_block        # 13e
        shufb   $both,$both,$both,$m_splat              # 14o
        or      $hit,$hit,$k_sign                       # 15e
        ai      $a_vertices,$a_vertices,32              # 16e
        shufb   $hit,$hit,$hit,$m_splat                 # 17o
        a       $a_faces,$a_faces,$a_vertices           # 18e
next_triangle:
        ai      $at_2,$at,4                             # 0e
        lqd     $candidate,0($a_candidate)              # 0o
        ai      $triangles,$triangles,1                 # 1e
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
        lqd     $t_best_2,384($a_packet)                # 13o
        lqd     $t_best_3,400($a_packet)                # 14o
        lqd     $t_best_4,432($a_packet)                # 15o
        rotqby  $face,$face,$vertex_a                   # 16o
        rotqbyi $a_shear,$a_shear,8                     # 17o
        rotqmbii $index,$index,-2                       # 18o
        lqd     $nearest,448($a_packet)                 # 19o
        shufb   $face,$face,$face,$m_indices            # 20o
        lqd     $axis,96($a_shear)                      # 21o
        lqd     $axis_2,128($a_shear)                   # 22o
        lqd     $origin,224($a_shear)                   # 23o
        shlqbii $face,$face,4                           # 24o
        lqd     $axis_3,0($a_shear)                     # 25o
        lqd     $axis_4,64($a_shear)                    # 26o
        lqd     $origin_2,208($a_shear)                 # 27o
        rotqbyi $vertex_c,$face,8                       # 28o
        rotqbyi $vertex_b,$face,4                       # 29o
        lqx     $vertex_a,$a_vertices,$face             # 30o
        lqd     $origin_3,336($a_shear)                 # 31o
        lqx     $vertex_c,$a_vertices,$vertex_c         # 32o
        lqd     $axis_5,32($a_shear)                    # 33o
        lqd     $origin_4,320($a_shear)                 # 34o
        lqd     $origin_5,272($a_shear)                 # 35o
        lqd     $axis_6,16($a_shear)                    # 36o
        shufb   $ya,$vertex_a,$vertex_a,$axis_4         # 37o
        lqd     $axis_7,160($a_shear)                   # 38o
        lqx     $vertex_b,$a_vertices,$vertex_b         # 39o
        lqd     $origin_6,256($a_shear)                 # 40o
        shufb   $yc,$vertex_c,$vertex_c,$axis_4         # 41o
        lqd     $axis_8,80($a_shear)                    # 42o
        shufb   $ya_2,$vertex_a,$vertex_a,$axis         # 43o
        shufb   $za_2,$vertex_a,$vertex_a,$axis_7       # 44o
        nop     $127                                    # 45e pairing
        shufb   $xb_2,$vertex_b,$vertex_b,$axis_5       # 45o
        fs      $yc,$yc,$origin_6                       # 46e
        shufb   $xb_3,$vertex_b,$vertex_b,$axis_6       # 46o
        fs      $ya,$ya,$origin_6                       # 47e
        shufb   $za_3,$vertex_a,$vertex_a,$axis_2       # 47o
        nop     $127                                    # 48e pairing
        lqd     $axis_9,144($a_shear)                   # 48o
        fs      $xb_2,$xb_2,$origin                     # 49e
        shufb   $yc_2,$vertex_c,$vertex_c,$axis_8       # 49o
        fs      $xb_3,$xb_3,$origin_2                   # 50e
        lqd     $origin_7,288($a_shear)                 # 50o
        fs      $za_3,$za_3,$origin_4                   # 51e
        shufb   $zb_2,$vertex_b,$vertex_b,$axis_7       # 51o
        nop     $127                                    # 52e pairing
        shufb   $xb_4,$vertex_b,$vertex_b,$axis_3       # 52o
        fs      $yc_2,$yc_2,$origin_5                   # 53e
        lqd     $slope_2,400($a_shear)                  # 53o
        shufb   $za_4,$vertex_a,$vertex_a,$axis_9       # 54o
        shufb   $zc_2,$vertex_c,$vertex_c,$axis_9       # 55o
        fs      $ya_2,$ya_2,$origin_7                   # 56e
        shufb   $zb_3,$vertex_b,$vertex_b,$axis_9       # 56o
        nop     $127                                    # 57e pairing
        shufb   $zc_3,$vertex_c,$vertex_c,$axis_7       # 57o
        fs      $za_4,$za_4,$origin_3                   # 58e
        lqd     $origin_8,192($a_shear)                 # 58o
        fs      $zc_2,$zc_2,$origin_3                   # 59e
        shufb   $yb_2,$vertex_b,$vertex_b,$axis_4       # 59o
        fs      $zb_4,$zb_3,$origin_3                   # 60e
        shufb   $yb_3,$vertex_b,$vertex_b,$axis         # 60o
        shufb   $zb_5,$vertex_b,$vertex_b,$axis_2       # 61o
        shufb   $xc_2,$vertex_c,$vertex_c,$axis_6       # 62o
        fs      $yb_2,$yb_2,$origin_6                   # 63e
        shufb   $xa_2,$vertex_a,$vertex_a,$axis_5       # 63o
        fs      $xb_4,$xb_4,$origin_8                   # 64e
        shufb   $xc_3,$vertex_c,$vertex_c,$axis_5       # 64o
        fs      $zb_5,$zb_5,$origin_4                   # 65e
        lqd     $origin_9,352($a_shear)                 # 65o
        fs      $yb_3,$yb_3,$origin_7                   # 66e
        lqd     $slope_3,416($a_shear)                  # 66o
        fs      $xc_2,$xc_2,$origin_2                   # 67e
        shufb   $xc_4,$vertex_c,$vertex_c,$axis_3       # 67o
        fs      $xc_3,$xc_3,$origin                     # 68e
        lqd     $slope_4,384($a_shear)                  # 68o
        fnms    $xb_3,$slope_2,$zb_4,$xb_3              # 69e
        shufb   $ya_3,$vertex_a,$vertex_a,$axis_8       # 69o
        fs      $xa_2,$xa_2,$origin                     # 70e
        shufb   $yb,$vertex_b,$vertex_b,$axis_8         # 70o
        fs      $zb_6,$zb_2,$origin_9                   # 71e
        shufb   $yc_3,$vertex_c,$vertex_c,$axis         # 71o
        fs      $za_2,$za_2,$origin_9                   # 72e
        shufb   $zc_4,$vertex_c,$vertex_c,$axis_2       # 72o
        fs      $ya_4,$ya_3,$origin_5                   # 73e
        shufb   $xa,$vertex_a,$vertex_a,$axis_6         # 73o
        fs      $zc_3,$zc_3,$origin_9                   # 74e
        lqd     $slope_5,464($a_shear)                  # 74o
        fs      $yc_3,$yc_3,$origin_7                   # 75e
        lqd     $axis_10,112($a_shear)                  # 75o
        fs      $zc_4,$zc_4,$origin_4                   # 76e
        lqd     $slope_6,480($a_shear)                  # 76o
        fs      $xc_4,$xc_4,$origin_8                   # 77e
        lqd     $slope_7,448($a_shear)                  # 77o
        fnms    $xb_2,$slope_3,$zb_6,$xb_2              # 78e
        lqd     $axis_11,176($a_shear)                  # 78o
        fnms    $xc_2,$slope_2,$zc_2,$xc_2              # 79e
        shufb   $xa_3,$vertex_a,$vertex_a,$axis_3       # 79o
        fnms    $yc_2,$slope_5,$zc_2,$yc_2              # 80e
        lqd     $axis_12,48($a_shear)                   # 80o
        fnms    $ya_4,$slope_5,$za_4,$ya_4              # 81e
        lqd     $origin_10,304($a_shear)                # 81o
        fnms    $yc_3,$slope_6,$zc_3,$yc_3              # 82e
        shufb   $ya_5,$vertex_a,$vertex_a,$axis_10      # 82o
        fnms    $xc_4,$slope_4,$zc_4,$xc_4              # 83e
        lqd     $slope_8,432($a_shear)                  # 83o
        fnms    $ya,$slope_7,$za_3,$ya                  # 84e
        shufb   $za_5,$vertex_a,$vertex_a,$axis_11      # 84o
        fnms    $yc,$slope_7,$zc_4,$yc                  # 85e
        lqd     $slope_9,496($a_shear)                  # 85o
        fnms    $ya_2,$slope_6,$za_2,$ya_2              # 86e
        shufb   $zc_5,$vertex_c,$vertex_c,$axis_11      # 86o
        fs      $xa,$xa,$origin_2                       # 87e
        shufb   $xb_5,$vertex_b,$vertex_b,$axis_12      # 87o
        fm      $sum_2,$yc_3,$xb_2                      # 88e
        shufb   $yc_4,$vertex_c,$vertex_c,$axis_10      # 88o
        fs      $xa_3,$xa_3,$origin_8                   # 89e
        lqd     $origin_8,240($a_shear)                 # 89o
        fm      $sum_3,$ya,$xc_4                        # 90e
        lqd     $origin_11,368($a_shear)                # 90o
        fnms    $xb_4,$slope_4,$zb_5,$xb_4              # 91e
        shufb   $xc_5,$vertex_c,$vertex_c,$axis_12      # 91o
        fs      $yb,$yb,$origin_5                       # 92e
        shufb   $xa_4,$vertex_a,$vertex_a,$axis_12      # 92o
        fnms    $xa_5,$slope_3,$za_2,$xa_2              # 93e
        shufb   $zb_7,$vertex_b,$vertex_b,$axis_11      # 93o
        fnms    $xc_3,$slope_3,$zc_3,$xc_3              # 94e
        shufb   $yb_4,$vertex_b,$vertex_b,$axis_10      # 94o
        fs      $xc_5,$xc_5,$origin_8                   # 95e
        lqd     $slope_10,544($a_shear)                 # 95o
        fnms    $xa,$slope_2,$za_4,$xa                  # 96e
        lqd     $slope_2,512($a_shear)                  # 96o
        fm      $sum_4,$yc,$xb_4                        # 97e
        lqd     $slope_11,528($a_shear)                 # 97o
        fnms    $yb_2,$slope_7,$zb_5,$yb_2              # 98e
        lqd     $slope_12,560($a_shear)                 # 98o
        fs      $xb_5,$xb_5,$origin_8                   # 99e
        lqd     $nearest_2,480($a_packet)               # 99o
        fm      $sum_5,$ya_2,$xc_3                      # 100e
        shufb   $index,$index,$index,$m_splat           # 100o
        fs      $yc_4,$yc_4,$origin_10                  # 101e
        lqd     $nearest_3,464($a_packet)               # 101o
        fs      $zc_5,$zc_5,$origin_11                  # 102e
        rotqmbii $ends,$ends,-6                         # 102o
        fs      $ya_5,$ya_5,$origin_10                  # 103e
        lqd     $nearest_4,496($a_packet)               # 103o
        fs      $zb_7,$zb_7,$origin_11                  # 104e
        fnms    $xa_3,$slope_4,$za_3,$xa_3              # 105e
        fms     $header_2,$ya,$xc_4,$sum_3              # 106e
        fnms    $yb,$slope_5,$zb_4,$yb                  # 107e
        fm      $sum_6,$ya_4,$xc_2                      # 108e
        fnms    $yb_5,$slope_6,$zb_6,$yb_3              # 109e
        fs      $za_6,$za_5,$origin_11                  # 110e
        fms     $v_2,$xa_3,$yc,$sum_3                   # 111e
        fm      $sum_3,$yc_2,$xb_3                      # 112e
        fs      $xa_4,$xa_4,$origin_8                   # 113e
        fms     $header_3,$ya_4,$xc_2,$sum_6            # 114e
        fms     $v_3,$xa,$yc_2,$sum_6                   # 115e
        fms     $rest_2,$xc_3,$yb_5,$sum_2              # 116e
        fms     $header_4,$yc_3,$xb_2,$sum_2            # 117e
        fms     $rest_3,$xc_2,$yb,$sum_3                # 118e
        fnms    $ya_5,$slope_9,$za_6,$ya_5              # 119e
        fms     $header_5,$yc,$xb_4,$sum_4              # 120e
        fms     $header_6,$yc_2,$xb_3,$sum_3            # 121e
        fm      $sum_3,$yb,$xa                          # 122e
        fnms    $xc_5,$slope_8,$zc_5,$xc_5              # 123e
        fs      $v_4,$v_2,$header_2                     # 124e
        fm      $sum_7,$yb_2,$xa_3                      # 125e
        fs      $yb_4,$yb_4,$origin_10                  # 126e
        fs      $rest,$rest_3,$header_6                 # 127e
        fms     $w,$xb_3,$ya_4,$sum_3                   # 128e
        fs      $rest_4,$rest_2,$header_4               # 129e
        fms     $header_7,$ya_2,$xc_3,$sum_5            # 130e
        fms     $v_5,$xa_5,$yc_3,$sum_5                 # 131e
        fm      $sum_8,$yb_5,$xa_5                      # 132e
        fms     $rest_5,$xc_4,$yb_2,$sum_4              # 133e
        fs      $v_6,$v_3,$header_3                     # 134e
        fnms    $xb_5,$slope_8,$zb_7,$xb_5              # 135e
        fms     $w_2,$xb_4,$ya,$sum_7                   # 136e
        fs      $v_7,$v_5,$header_7                     # 137e
        fms     $header_8,$yb_5,$xa_5,$sum_8            # 138e
        fs      $rest_6,$rest_5,$header_5               # 139e
        fms     $w_3,$xb_2,$ya_2,$sum_8                 # 140e
        fnms    $yb_4,$slope_9,$zb_7,$yb_4              # 141e
        fnms    $yc,$slope_9,$zc_5,$yc_4                # 142e
        fa      $det,$rest_4,$v_7                       # 143e
        fa      $det_2,$rest,$v_6                       # 144e
        fms     $header_9,$yb,$xa,$sum_3                # 145e
        fnms    $xa_4,$slope_8,$za_6,$xa_4              # 146e
        fms     $header_10,$yb_2,$xa_3,$sum_7           # 147e
        fm      $sum_9,$yc,$xb_5                        # 148e
        fa      $det_3,$rest_6,$v_4                     # 149e
        fs      $w_4,$w_3,$header_8                     # 150e
        fs      $w,$w,$header_9                         # 151e
        fm      $sum_10,$ya_5,$xc_5                     # 152e
        fs      $w_5,$w_2,$header_10                    # 153e
        fms     $header_11,$yc,$xb_5,$sum_9             # 154e
        fms     $rest_7,$xc_5,$yb_4,$sum_9              # 155e
        fa      $det,$det,$w_4                          # 156e
        fa      $det_4,$det_2,$w                        # 157e
        fms     $v_8,$xa_4,$yc,$sum_10                  # 158e
        fms     $header_12,$ya_5,$xc_5,$sum_10          # 159e
        fa      $det_5,$det_3,$w_5                      # 160e
        fm      $sum_11,$yb_4,$xa_4                     # 161e
        fs      $rest_7,$rest_7,$header_11              # 162e
        frest   $t_y_2,$det                             # 162o
        xor     $seen,$det,$slope_10                    # 163e of -1 / direction z
        frest   $t_y_3,$det_4                           # 163o
        xor     $seen_2,$det_4,$slope_11                # 164e of -1 / direction z
        fs      $v_9,$v_8,$header_12                    # 165e
        fi      $t_y_2,$det,$t_y_2                      # 166e
        frest   $t_y_4,$det_5                           # 166o
        fi      $t_y_3,$det_4,$t_y_3                    # 167e
        xor     $seen_3,$det_5,$slope_2                 # 168e of -1 / direction z
        fms     $header_13,$yb_4,$xa_4,$sum_11          # 169e
        fms     $w_6,$xb_5,$ya_5,$sum_11                # 170e
        fa      $det_6,$rest_7,$v_9                     # 171e
        fi      $t_y_5,$det_5,$t_y_4                    # 172e
        or      $seen_4,$seen_2,$both                   # 173e
        fnms    $t_e_2,$det_4,$t_y_3,$k_above_one       # 174e
        fnms    $t_e_3,$det,$t_y_2,$k_above_one         # 175e
        fs      $w_6,$w_6,$header_13                    # 176e
        or      $seen,$seen,$both                       # 177e
        or      $seen_5,$seen_3,$both                   # 178e
        fnms    $t_e_4,$det_5,$t_y_5,$k_above_one       # 179e
        fma     $inverse_2,$t_e_2,$t_y_3,$t_y_3         # 180e
        fma     $inverse_3,$t_e_3,$t_y_2,$t_y_2         # 181e
        fa      $det,$det_6,$w_6                        # 182e
        cgt     $more,$ends,$at_2                       # 183e
        or      $object_2,$index,$hit                   # 184e
        fma     $inverse_4,$t_e_4,$t_y_5,$t_y_5         # 185e
        fm      $rest,$rest,$inverse_2                  # 186e
        fm      $v_7,$v_7,$inverse_3                    # 187e
        lnop                                            # 187o pairing
        fm      $rest_8,$rest_4,$inverse_3              # 188e
        frest   $t_y_5,$det                             # 188o
        fm      $v_10,$v_6,$inverse_2                   # 189e
        fm      $w_4,$w_4,$inverse_3                    # 190e
        fm      $rest_6,$rest_6,$inverse_4              # 191e
        fi      $t_y_2,$det,$t_y_5                      # 192e
        xor     $seen_6,$det,$slope_12                  # 193e of -1 / direction z
        fm      $v_5,$v_4,$inverse_4                    # 194e
        fm      $ahead,$rest,$za_4                      # 195e
        fm      $ahead_2,$rest_8,$za_2                  # 196e
        fm      $ahead_3,$rest_6,$za_3                  # 197e
        fm      $w_5,$w_5,$inverse_4                    # 198e
        fnms    $t_e_5,$det,$t_y_2,$k_above_one         # 199e
        fm      $w,$w,$inverse_2                        # 200e
        fma     $ahead,$v_10,$zb_4,$ahead               # 201e
        fma     $ahead_4,$v_7,$zb_6,$ahead_2            # 202e
        fma     $ahead_5,$v_5,$zb_5,$ahead_3            # 203e
        or      $outside,$rest_6,$v_5                   # 204e
        fma     $inverse_5,$t_e_5,$t_y_2,$t_y_2         # 205e
        or      $outside,$outside,$w_5                  # 206e
        fma     $ahead,$w,$zc_2,$ahead                  # 207e
        fma     $ahead_4,$w_4,$zc_3,$ahead_4            # 208e
        fma     $ahead_6,$w_5,$zc_4,$ahead_5            # 209e
        or      $outside_2,$rest,$v_10                  # 210e
        fm      $rest,$rest_7,$inverse_5                # 211e
        fm      $w_7,$w_6,$inverse_5                    # 212e
        fm      $ahead,$ahead,$slope_11                 # 213e
        fm      $v_11,$v_9,$inverse_5                   # 214e
        fm      $ahead_6,$ahead_6,$slope_2              # 215e
        fm      $ahead_4,$ahead_4,$slope_10             # 216e
        fm      $ahead_7,$rest,$za_6                    # 217e
        or      $outside_3,$rest_8,$v_7                 # 218e
        xor     $t,$ahead,$k_sign                       # 219e
        orc     $outside,$outside,$seen_5               # 220e
        xor     $t_2,$ahead_6,$k_sign                   # 221e
        xor     $t_3,$ahead_4,$k_sign                   # 222e
        fma     $ahead_7,$v_11,$zb_7,$ahead_7           # 223e
        cgt     $control,$t_best,$t_3                   # 224e
        cgt     $control_2,$t_best_2,$t_2               # 225e
        or      $outside_3,$outside_3,$w_4              # 226e
        and     $control_3,$control_2,$ahead_6          # 227e
        orc     $outside_3,$outside_3,$seen             # 228e
        fma     $ahead_8,$w_7,$zc_5,$ahead_7            # 229e
        andc    $control_3,$control_3,$outside          # 230e
        or      $outside,$outside_2,$w                  # 231e
        lnop                                            # 231o pairing
        cgt     $control_4,$t_best_3,$t                 # 232e
        rotqbii $control_3,$control_3,1                 # 232o
        orc     $outside,$outside,$seen_4               # 233e
        and     $control_4,$control_4,$ahead            # 234e
        and     $control,$control,$ahead_4              # 235e
        lnop                                            # 235o pairing
        andc    $control_4,$control_4,$outside          # 236e
        gb      $control_3,$control_3                   # 236o
        fm      $ahead,$ahead_8,$slope_12               # 237e
        lnop                                            # 237o pairing
        andc    $control,$control,$outside_3            # 238e
        rotqbii $control_4,$control_4,1                 # 238o
        or      $outside,$rest,$v_11                    # 239e
        lnop                                            # 239o pairing
        or      $seen,$seen_6,$both                     # 240e
        rotqbii $control,$control,1                     # 240o
        or      $outside,$outside,$w_7                  # 241e
        shlqbii $control_3,$control_3,4                 # 241o
        and     $at,$at_2,$more                         # 242e
        gb      $control_5,$control_4                   # 242o
        xor     $t_4,$ahead,$k_sign                     # 243e
        lnop                                            # 243o pairing
        orc     $outside,$outside,$seen                 # 244e
        gb      $control,$control                       # 244o
        cgt     $control_6,$t_best_4,$t_4               # 245e
        lqx     $control_3,$control_3,$a_controls       # 245o
        andc    $ends,$k_step,$more                     # 246e
        shlqbii $control_5,$control_5,4                 # 246o
        and     $control_6,$control_6,$ahead            # 247e
        lnop                                            # 247o pairing
        a       $a_candidate,$a_candidate,$ends         # 248e
        shlqbii $control,$control,4                     # 248o
        andc    $control_6,$control_6,$outside          # 249e
        lqx     $control_5,$control_5,$a_controls       # 250o
        shufb   $t_best_2,$t_best_2,$t_2,$control_3     # 251o
        lqx     $control,$control,$a_controls           # 252o
        rotqbii $control_6,$control_6,1                 # 253o
        shufb   $nearest,$nearest,$object_2,$control_3  # 254o
        stqd    $t_best_2,384($a_packet)                # 255o
        shufb   $t_best_2,$t_best_3,$t,$control_5       # 256o
        shufb   $nearest_5,$nearest_3,$object_2,$control_5 # 257o
        shufb   $t_best,$t_best,$t_3,$control           # 258o
        gb      $control_7,$control_6                   # 259o
        shufb   $nearest_6,$nearest_2,$object_2,$control # 260o
        stqd    $nearest_5,464($a_packet)               # 261o
        stqd    $t_best,416($a_packet)                  # 262o
        shlqbii $control,$control_7,4                   # 263o
        stqd    $nearest_6,480($a_packet)               # 264o
        stqd    $nearest,448($a_packet)                 # 265o
        stqd    $t_best_2,400($a_packet)                # 266o
        hbrr    next_triangle_back,next_triangle        # 267o hint
        lqx     $control,$control,$a_controls           # 268o
        shufb   $t_best,$t_best_4,$t_4,$control         # 274o
        shufb   $nearest,$nearest_4,$object_2,$control  # 275o
        stqd    $t_best,432($a_packet)                  # 278o
        stqd    $nearest,496($a_packet)                 # 279o
        nop     $127                                    # 280e pairing
next_triangle_back:
        brnz    $triangles,next_triangle                # 280o
        nop     $127                                    # 281e pairing
        bi      $lr                                     # 281o
next_run_short:
        ai      $count,$count,-1                        # 0e
        lqd     $candidate,0($a_run)                    # 0o
        ai      $a_run,$a_run,16                        # 1e
        rotmi   $candidate,$candidate,-16               # 6e
        a       $a_first,$a_first,$candidate            # 10e
        brnz    $count,next_run_short                   # 10o
        nop     $127                                    # 11e pairing
        br      isect_mesh_pairs_r16_block              # 11o
endfunction isect_mesh_pairs_r16
