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
        registers a_candidate
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

        sign_controls_table
vertex_indices:                                         # three bytes to the ends of three words
        .int    0x80808000,0x80808001,0x80808002,0x80808080

function isect_mesh_pairs_r16
        .set count_2,79; .set candidate_2,2; .set at_2,2; .set t_best_2,3; .set t_best_3,4
        .set t_best_4,5; .set axis_2,6; .set axis_3,7; .set axis_4,8; .set axis_5,2
        .set origin_2,9; .set origin_3,23; .set origin_4,28; .set origin_5,29; .set vertex_a_2,26
        .set origin_6,32; .set axis_6,33; .set axis_7,34; .set origin_7,35; .set xb_2,36
        .set ya_2,37; .set axis_8,39; .set axis_9,40; .set origin_8,43; .set za_2,44; .set zb_2,45
        .set yc_2,46; .set xc_2,47; .set ya_3,48; .set zc_2,49; .set zc_3,50; .set slope_2,51
        .set xc_3,52; .set ya_4,53; .set origin_9,54; .set za_3,55; .set zc_4,8; .set slope_3,56
        .set zb_3,58; .set xb_3,59; .set yc_3,60; .set zb_4,34; .set slope_4,61; .set yb_2,62
        .set xb_4,63; .set yb_3,41; .set za_4,33; .set yb_4,43; .set yc_4,40; .set slope_5,54
        .set yb_5,32; .set slope_6,41; .set za_5,9; .set xa_2,33; .set slope_7,29; .set xb_5,40
        .set xa_3,2; .set xa_4,7; .set yb_6,6; .set axis_10,28; .set origin_10,62; .set axis_11,23
        .set axis_12,63; .set slope_8,64; .set origin_11,65; .set ya_5,35; .set yc_5,66
        .set xb_6,67; .set za_6,68; .set zb_5,69; .set zc_5,56; .set xc_4,31; .set xa_5,23
        .set yc_6,26; .set sum_2,61; .set yb_7,28; .set yb_8,30; .set slope_9,32; .set sum_3,51
        .set slope_10,63; .set slope_11,66; .set slope_12,25; .set sum_4,41; .set nearest_2,70
        .set nearest_3,71; .set nearest_4,72; .set sum_5,73; .set nearest_5,74; .set sum_6,75
        .set rest_2,76; .set sum_7,77; .set header_2,38; .set sum_8,54; .set sum_9,78
        .set header_3,41; .set header_4,79; .set zc_6,42; .set v_2,56; .set header_5,77
        .set rest_3,73; .set v_3,39; .set header_6,46; .set v_4,60; .set header_7,51
        .set rest_4,47; .set rest_5,41; .set v_5,51; .set v_6,52; .set w_2,37; .set w_3,40
        .set header_8,2; .set header_9,30; .set xb_7,33; .set rest_6,43; .set header_10,6
        .set det_2,7; .set sum_10,29; .set sum_11,36; .set w_4,30; .set det_3,37; .set w_5,6
        .set det_4,38; .set sum_12,39; .set v_7,40; .set det_5,29; .set header_11,26
        .set rest_7,31; .set header_12,23; .set v_8,2; .set t_y_2,28; .set w_6,33; .set t_y_3,35
        .set seen_2,36; .set rest_8,26; .set t_y_4,31; .set seen_3,38; .set w_7,23; .set seen_4,33
        .set t_e_2,39; .set t_e_3,29; .set seen_5,7; .set t_e_4,37; .set inverse_2,28
        .set inverse_3,29; .set object_2,27; .set inverse_4,31; .set seen_6,35; .set t_y_5,37
        .set rest_9,39; .set v_9,43; .set ahead_2,9; .set ahead_3,38; .set w_8,28; .set ahead_4,30
        .set outside_2,31; .set ahead_5,8; .set w_9,2; .set ahead_6,23; .set outside_3,29
        .set outside_4,28; .set t_2,29; .set outside_5,6; .set control_2,7; .set t_3,9
        .set control_3,30; .set control_4,6; .set control_5,2; .set t_4,6; .set control_6,8
        .set nearest_6,2
        nop     $127                                    # 0e pairing
        biz     $count,$lr                              # 0o
        clgti   $count_2,$count,1                       # 1e at least as many passes as overlap
        ori     $a_candidate,$a_first,0                 # 2e
        il      $triangles,0                            # 3e
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
            a       $triangles,$triangles,$candidate    # 5e
next_run_back:
        brnz    $count,next_run                         # 5o
next_run_drain:
        rotmi   $candidate,$candidate_2,-16             # 0e
        a       $triangles,$triangles,$candidate        # 4e
isect_mesh_pairs_r16_block:
        ila     $m_splat,0x10203                        # 0e
        lqd     $header,0($a_block)                     # 0o
        ilhu    $k_sign,0x8000                          # 1e
        lqd     $rest,16($a_block)                      # 1o
        sfi     $triangles,$triangles,0                 # 2e
        lqa     $m_indices,vertex_indices               # 2o
        ilhu    $k_above_one,0x3f80                     # 3e
        ila     $a_controls,sign_controls               # 4e
        iohl    $k_above_one,2                          # 5e
        lnop                                            # 5o pairing
        il      $k_step,16                              # 6e
        rotqbyi $hit,$header,4                          # 6o
        mpyi    $a_vertices,$rest,112                   # 7e
        rotqbyi $both,$rest,12                          # 7o
        il      $at,0                                   # 8e
        rotqbyi $a_faces,$rest,8                        # 8o
        shli    $hit,$hit,7                             # 10e
        shli    $both,$both,1                           # 11e SIDES_BOTH to the sign
        shli    $a_faces,$a_faces,4                     # 12e
        a       $a_vertices,$a_vertices,$a_block        # 14e
        or      $hit,$hit,$k_sign                       # 15e
        shufb   $both,$both,$both,$m_splat              # 15o
        ai      $a_vertices,$a_vertices,32              # 16e
        shufb   $hit,$hit,$hit,$m_splat                 # 17o
        a       $a_faces,$a_faces,$a_vertices           # 18e
        lnop                                            # 18o pairing
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
        lqd     $t_best,384($a_packet)                  # 12o
        lqd     $t_best_2,400($a_packet)                # 13o
        lqd     $t_best_3,416($a_packet)                # 14o
        lqd     $t_best_4,432($a_packet)                # 15o
        rotqby  $face,$face,$vertex_a                   # 16o
        rotqbyi $a_shear,$a_shear,8                     # 17o
        rotqmbii $index,$index,-2                       # 18o
        rotqmbii $ends,$ends,-6                         # 19o
        shufb   $face,$face,$face,$m_indices            # 20o
        lqd     $axis,64($a_shear)                      # 21o
        lqd     $axis_2,80($a_shear)                    # 22o
        cgt     $more,$ends,$at_2                       # 23e
        lqd     $axis_3,16($a_shear)                    # 23o
        nop     $127                                    # 24e pairing
        shlqbii $face,$face,4                           # 24o
        andc    $ends,$k_step,$more                     # 25e
        lqd     $axis_4,160($a_shear)                   # 25o
        and     $at,$at_2,$more                         # 26e
        lqd     $axis_5,32($a_shear)                    # 26o
        a       $a_candidate,$a_candidate,$ends         # 27e
        lqd     $origin,192($a_shear)                   # 27o
        rotqbyi $vertex_c,$face,8                       # 28o
        rotqbyi $vertex_b,$face,4                       # 29o
        lqd     $origin_2,320($a_shear)                 # 30o
        lqd     $origin_3,272($a_shear)                 # 31o
        lqd     $origin_4,224($a_shear)                 # 32o
        lqx     $vertex_b,$a_vertices,$vertex_b         # 33o
        lqd     $origin_5,288($a_shear)                 # 34o
        lqx     $vertex_a_2,$a_vertices,$face           # 35o
        lqx     $vertex_c,$a_vertices,$vertex_c         # 36o
        lqd     $origin_6,256($a_shear)                 # 37o
        lqd     $axis_6,128($a_shear)                   # 38o
        lqd     $axis_7,144($a_shear)                   # 39o
        lqd     $origin_7,208($a_shear)                 # 40o
        shufb   $xb_2,$vertex_b,$vertex_b,$axis_5       # 41o
        shufb   $ya_2,$vertex_a_2,$vertex_a_2,$axis     # 42o
        shufb   $xc,$vertex_c,$vertex_c,$axis_5         # 43o
        nop     $127                                    # 44e pairing
        lqd     $axis_8,0($a_shear)                     # 44o
        fs      $xb_2,$xb_2,$origin_4                   # 45e
        lqd     $axis_9,96($a_shear)                    # 45o
        fs      $ya_2,$ya_2,$origin_6                   # 46e
        lqd     $origin_8,352($a_shear)                 # 46o
        fs      $xc,$xc,$origin_4                       # 47e
        shufb   $za_2,$vertex_a_2,$vertex_a_2,$axis_4   # 47o
        shufb   $zb_2,$vertex_b,$vertex_b,$axis_4       # 48o
        shufb   $yc_2,$vertex_c,$vertex_c,$axis         # 49o
        shufb   $xc_2,$vertex_c,$vertex_c,$axis_8       # 50o
        shufb   $ya_3,$vertex_a_2,$vertex_a_2,$axis_9   # 51o
        fs      $za_2,$za_2,$origin_8                   # 52e
        shufb   $zc_2,$vertex_c,$vertex_c,$axis_6       # 52o
        fs      $yc_2,$yc_2,$origin_6                   # 53e
        shufb   $zc_3,$vertex_c,$vertex_c,$axis_7       # 53o
        fs      $xc_2,$xc_2,$origin                     # 54e
        lqd     $slope_2,448($a_shear)                  # 54o
        fs      $ya_3,$ya_3,$origin_5                   # 55e
        shufb   $xc_3,$vertex_c,$vertex_c,$axis_3       # 55o
        fs      $zc_2,$zc_2,$origin_2                   # 56e
        shufb   $ya_4,$vertex_a_2,$vertex_a_2,$axis_2   # 56o
        fs      $zb_2,$zb_2,$origin_8                   # 57e
        lqd     $origin_9,336($a_shear)                 # 57o
        nop     $127                                    # 58e pairing
        shufb   $za_3,$vertex_a_2,$vertex_a_2,$axis_7   # 58o
        fs      $xc_3,$xc_3,$origin_7                   # 59e
        shufb   $zc_4,$vertex_c,$vertex_c,$axis_4       # 59o
        fs      $ya_4,$ya_4,$origin_3                   # 60e
        lqd     $slope_3,480($a_shear)                  # 60o
        nop     $127                                    # 61e pairing
        shufb   $zb_3,$vertex_b,$vertex_b,$axis_6       # 61o
        fnms    $yc_2,$slope_2,$zc_2,$yc_2              # 62e
        shufb   $xb_3,$vertex_b,$vertex_b,$axis_3       # 62o
        fs      $za_3,$za_3,$origin_9                   # 63e
        shufb   $yc_3,$vertex_c,$vertex_c,$axis_2       # 63o
        fs      $zc_3,$zc_3,$origin_9                   # 64e
        shufb   $zb_4,$vertex_b,$vertex_b,$axis_7       # 64o
        fs      $zb_3,$zb_3,$origin_2                   # 65e
        lqd     $slope_4,400($a_shear)                  # 65o
        fs      $xb_3,$xb_3,$origin_7                   # 66e
        shufb   $yb_2,$vertex_b,$vertex_b,$axis_9       # 66o
        fs      $yc_3,$yc_3,$origin_3                   # 67e
        shufb   $xb_4,$vertex_b,$vertex_b,$axis_8       # 67o
        fs      $zb_4,$zb_4,$origin_9                   # 68e
        shufb   $yb_3,$vertex_b,$vertex_b,$axis         # 68o
        fs      $zc_4,$zc_4,$origin_8                   # 69e
        shufb   $za_4,$vertex_a_2,$vertex_a_2,$axis_6   # 69o
        fs      $yb_4,$yb_2,$origin_5                   # 70e
        shufb   $yc_4,$vertex_c,$vertex_c,$axis_9       # 70o
        fnms    $xc_3,$slope_4,$zc_3,$xc_3              # 71e
        lqd     $slope_5,384($a_shear)                  # 71o
        fs      $yb_5,$yb_3,$origin_6                   # 72e
        lqd     $slope_6,416($a_shear)                  # 72o
        fs      $za_5,$za_4,$origin_2                   # 73e
        shufb   $xa_2,$vertex_a_2,$vertex_a_2,$axis_8   # 73o
        fs      $yc,$yc_4,$origin_5                     # 74e
        lqd     $slope_7,464($a_shear)                  # 74o
        fs      $xb_5,$xb_4,$origin                     # 75e
        shufb   $xa_3,$vertex_a_2,$vertex_a_2,$axis_5   # 75o
        fnms    $xb_3,$slope_4,$zb_4,$xb_3              # 76e
        shufb   $xa_4,$vertex_a_2,$vertex_a_2,$axis_3   # 76o
        fnms    $xc_2,$slope_5,$zc_2,$xc_2              # 77e
        shufb   $yb_6,$vertex_b,$vertex_b,$axis_2       # 77o
        fs      $xa_2,$xa_2,$origin                     # 78e
        lqd     $origin,368($a_shear)                   # 78o
        fs      $xa_3,$xa_3,$origin_4                   # 79e
        lqd     $axis_10,112($a_shear)                  # 79o
        fnms    $yc,$slope_3,$zc_4,$yc                  # 80e
        lqd     $origin_10,304($a_shear)                # 80o
        fs      $yb_6,$yb_6,$origin_3                   # 81e
        lqd     $axis_11,48($a_shear)                   # 81o
        fnms    $xb_5,$slope_5,$zb_3,$xb_5              # 82e
        lqd     $axis_12,176($a_shear)                  # 82o
        fnms    $ya_4,$slope_7,$za_3,$ya_4              # 83e
        lqd     $slope_8,432($a_shear)                  # 83o
        fnms    $ya_2,$slope_2,$za_5,$ya_2              # 84e
        lqd     $origin_11,240($a_shear)                # 84o
        fs      $xa_4,$xa_4,$origin_7                   # 85e
        shufb   $ya_5,$vertex_a_2,$vertex_a_2,$axis_10  # 85o
        fnms    $xb_2,$slope_6,$zb_2,$xb_2              # 86e
        shufb   $yc_5,$vertex_c,$vertex_c,$axis_10      # 86o
        fnms    $xc,$slope_6,$zc_4,$xc                  # 87e
        shufb   $xb_6,$vertex_b,$vertex_b,$axis_11      # 87o
        fnms    $ya_3,$slope_3,$za_2,$ya_3              # 88e
        shufb   $za_6,$vertex_a_2,$vertex_a_2,$axis_12  # 88o
        fnms    $yc_3,$slope_7,$zc_3,$yc_3              # 89e
        shufb   $zb_5,$vertex_b,$vertex_b,$axis_12      # 89o
        fnms    $yb_4,$slope_3,$zb_2,$yb_4              # 90e
        shufb   $zc_5,$vertex_c,$vertex_c,$axis_12      # 90o
        fnms    $xa_4,$slope_4,$za_3,$xa_4              # 91e
        shufb   $xc_4,$vertex_c,$vertex_c,$axis_11      # 91o
        fnms    $yb_6,$slope_7,$zb_4,$yb_6              # 92e
        shufb   $xa_5,$vertex_a_2,$vertex_a_2,$axis_11  # 92o
        fs      $yc_6,$yc_5,$origin_10                  # 93e
        lqd     $slope_7,496($a_shear)                  # 93o
        fm      $sum_2,$ya_3,$xc                        # 94e
        shufb   $yb_7,$vertex_b,$vertex_b,$axis_10      # 94o
        fnms    $yb_8,$slope_2,$zb_3,$yb_5              # 95e
        lqd     $slope_9,544($a_shear)                  # 95o
        fm      $sum_3,$ya_4,$xc_3                      # 96e
        lqd     $slope_10,528($a_shear)                 # 96o
        fs      $xc_4,$xc_4,$origin_11                  # 97e
        lqd     $slope_11,512($a_shear)                 # 97o
        fnms    $xa_3,$slope_6,$za_2,$xa_3              # 98e
        lqd     $slope_12,560($a_shear)                 # 98o
        fm      $sum_4,$yc,$xb_2                        # 99e
        shufb   $index,$index,$index,$m_splat           # 99o
        fs      $xb_6,$xb_6,$origin_11                  # 100e
        lqd     $nearest_2,448($a_packet)               # 100o
        fs      $za_6,$za_6,$origin                     # 101e
        lqd     $nearest_3,464($a_packet)               # 101o
        fs      $zb_5,$zb_5,$origin                     # 102e
        lqd     $nearest_4,480($a_packet)               # 102o
        fm      $sum_5,$yc_3,$xb_3                      # 103e
        lqd     $nearest_5,496($a_packet)               # 103o
        fm      $sum_6,$yb_4,$xa_3                      # 104e
        fms     $rest_2,$xc,$yb_4,$sum_4                # 105e
        fm      $sum_7,$ya_2,$xc_2                      # 106e
        fms     $header_2,$ya_3,$xc,$sum_2              # 107e
        fnms    $xa_2,$slope_5,$za_5,$xa_2              # 108e
        fm      $sum_8,$yc_2,$xb_5                      # 109e
        fm      $sum_9,$yb_6,$xa_4                      # 110e
        fms     $header_3,$yc,$xb_2,$sum_4              # 111e
        fms     $header_4,$ya_2,$xc_2,$sum_7            # 112e
        fs      $zc_6,$zc_5,$origin                     # 113e
        fms     $v_2,$xa_2,$yc_2,$sum_7                 # 114e
        fms     $header_5,$yc_3,$xb_3,$sum_5            # 115e
        fms     $rest_3,$xc_3,$yb_6,$sum_5              # 116e
        fms     $v_3,$xa_3,$yc,$sum_2                   # 117e
        fms     $header_6,$yc_2,$xb_5,$sum_8            # 118e
        fm      $sum_2,$yb_8,$xa_2                      # 119e
        fms     $v_4,$xa_4,$yc_3,$sum_3                 # 120e
        fs      $ya_5,$ya_5,$origin_10                  # 121e
        fs      $yb_7,$yb_7,$origin_10                  # 122e
        fms     $header_7,$ya_4,$xc_3,$sum_3            # 123e
        fms     $rest_4,$xc_2,$yb_8,$sum_8              # 124e
        fs      $xa_5,$xa_5,$origin_11                  # 125e
        fs      $rest_5,$rest_2,$header_3               # 126e
        fnms    $ya_5,$slope_7,$za_6,$ya_5              # 127e
        fnms    $yc_6,$slope_7,$zc_6,$yc_6              # 128e
        fs      $v_5,$v_4,$header_7                     # 129e
        fs      $v_6,$v_2,$header_4                     # 130e
        fms     $w_2,$xb_5,$ya_2,$sum_2                 # 131e
        fms     $w_3,$xb_3,$ya_4,$sum_9                 # 132e
        fms     $header_8,$yb_4,$xa_3,$sum_6            # 133e
        fnms    $xc_4,$slope_8,$zc_6,$xc_4              # 134e
        fms     $header_9,$yb_8,$xa_2,$sum_2            # 135e
        fnms    $xb_7,$slope_8,$zb_5,$xb_6              # 136e
        fs      $rest,$rest_4,$header_6                 # 137e
        fs      $rest_6,$rest_3,$header_5               # 138e
        fnms    $xa_5,$slope_8,$za_6,$xa_5              # 139e
        fnms    $yb_7,$slope_7,$zb_5,$yb_7              # 140e
        fs      $v,$v_3,$header_2                       # 141e
        fms     $w,$xb_2,$ya_3,$sum_6                   # 142e
        fms     $header_10,$yb_6,$xa_4,$sum_9           # 143e
        fa      $det_2,$rest_6,$v_5                     # 144e
        fm      $sum_10,$ya_5,$xc_4                     # 145e
        fm      $sum_11,$yb_7,$xa_5                     # 146e
        fs      $w_4,$w_2,$header_9                     # 147e
        fa      $det_3,$rest,$v_6                       # 148e
        fs      $w_5,$w_3,$header_10                    # 149e
        fa      $det_4,$rest_5,$v                       # 150e
        fm      $sum_12,$yc_6,$xb_7                     # 151e
        fms     $v_7,$xa_5,$yc_6,$sum_10                # 152e
        fs      $w,$w,$header_8                         # 153e
        fms     $header_8,$ya_5,$xc_4,$sum_10           # 154e
        fa      $det_2,$det_2,$w_5                      # 155e
        fa      $det_5,$det_3,$w_4                      # 156e
        fms     $header_11,$yc_6,$xb_7,$sum_12          # 157e
        fms     $rest_7,$xc_4,$yb_7,$sum_12             # 158e
        fa      $det_3,$det_4,$w                        # 159e
        fms     $header_12,$yb_7,$xa_5,$sum_11          # 160e
        lnop                                            # 160o pairing
        fs      $v_8,$v_7,$header_8                     # 161e
        frest   $t_y_2,$det_2                           # 161o
        fms     $w_6,$xb_7,$ya_5,$sum_11                # 162e
        frest   $t_y_3,$det_5                           # 162o
        xor     $seen_2,$det_5,$slope_11                # 163e of -1 / direction z
        fs      $rest_8,$rest_7,$header_11              # 164e
        fi      $t_y_2,$det_2,$t_y_2                    # 165e
        frest   $t_y_4,$det_3                           # 165o
        fi      $t_y_3,$det_5,$t_y_3                    # 166e
        xor     $seen_3,$det_3,$slope_9                 # 167e of -1 / direction z
        fs      $w_7,$w_6,$header_12                    # 168e
        fi      $t_y_4,$det_3,$t_y_4                    # 169e
        or      $seen_4,$seen_3,$both                   # 170e
        fa      $det_4,$rest_8,$v_8                     # 171e
        fnms    $t_e_2,$det_2,$t_y_2,$k_above_one       # 172e
        fnms    $t_e_3,$det_5,$t_y_3,$k_above_one       # 173e
        or      $seen_2,$seen_2,$both                   # 174e
        xor     $seen_5,$det_2,$slope_10                # 175e of -1 / direction z
        fnms    $t_e_4,$det_3,$t_y_4,$k_above_one       # 176e
        fa      $det_4,$det_4,$w_7                      # 177e
        fma     $inverse_2,$t_e_2,$t_y_2,$t_y_2         # 178e
        fma     $inverse_3,$t_e_3,$t_y_3,$t_y_3         # 179e
        or      $seen_5,$seen_5,$both                   # 180e
        or      $object_2,$index,$hit                   # 181e
        fma     $inverse_4,$t_e_4,$t_y_4,$t_y_4         # 182e
        lnop                                            # 182o pairing
        xor     $seen_6,$det_4,$slope_12                # 183e of -1 / direction z
        frest   $t_y_5,$det_4                           # 183o
        fm      $rest_9,$rest_6,$inverse_2              # 184e
        fm      $rest,$rest,$inverse_3                  # 185e
        fm      $v_7,$v_6,$inverse_3                    # 186e
        fi      $t_y_5,$det_4,$t_y_5                    # 187e
        or      $seen_6,$seen_6,$both                   # 188e
        fm      $rest_5,$rest_5,$inverse_4              # 189e
        fm      $v_9,$v_5,$inverse_2                    # 190e
        fm      $v,$v,$inverse_4                        # 191e
        fm      $ahead,$rest,$za_5                      # 192e
        fm      $ahead_2,$rest_9,$za_3                  # 193e
        fnms    $t_e,$det_4,$t_y_5,$k_above_one         # 194e
        fm      $ahead_3,$rest_5,$za_2                  # 195e
        fm      $w_5,$w_5,$inverse_2                    # 196e
        fm      $w,$w,$inverse_4                        # 197e
        fm      $w_8,$w_4,$inverse_3                    # 198e
        fma     $ahead_2,$v_9,$zb_4,$ahead_2            # 199e
        fma     $inverse_3,$t_e,$t_y_5,$t_y_5           # 200e
        fma     $ahead_4,$v,$zb_2,$ahead_3              # 201e
        fma     $ahead,$v_7,$zb_3,$ahead                # 202e
        or      $outside,$rest_5,$v                     # 203e
        or      $outside_2,$rest_9,$v_9                 # 204e
        fma     $ahead_2,$w_5,$zc_3,$ahead_2            # 205e
        fm      $rest_8,$rest_8,$inverse_3              # 206e
        fma     $ahead_5,$w,$zc_4,$ahead_4              # 207e
        fma     $ahead,$w_8,$zc_2,$ahead                # 208e
        fm      $v,$v_8,$inverse_3                      # 209e
        fm      $w_9,$w_7,$inverse_3                    # 210e
        fm      $ahead_2,$ahead_2,$slope_10             # 211e
        fm      $ahead_6,$rest_8,$za_6                  # 212e
        fm      $ahead_5,$ahead_5,$slope_9              # 213e
        fm      $ahead,$ahead,$slope_11                 # 214e
        or      $outside_3,$rest,$v_7                   # 215e
        or      $outside,$outside,$w                    # 216e
        or      $outside_4,$outside_3,$w_8              # 217e
        fma     $ahead_6,$v,$zb_5,$ahead_6              # 218e
        xor     $t,$ahead_2,$k_sign                     # 219e
        xor     $t_2,$ahead,$k_sign                     # 220e
        or      $outside_5,$outside_2,$w_5              # 221e
        cgt     $control,$t_best,$t_2                   # 222e
        orc     $outside_5,$outside_5,$seen_5           # 223e
        orc     $outside,$outside,$seen_4               # 224e
        cgt     $control_2,$t_best_2,$t                 # 225e
        orc     $outside_4,$outside_4,$seen_2           # 226e
        and     $control_2,$control_2,$ahead_2          # 227e
        xor     $t_3,$ahead_5,$k_sign                   # 228e
        fma     $ahead_6,$w_9,$zc_6,$ahead_6            # 229e
        cgt     $control_3,$t_best_3,$t_3               # 230e
        and     $control,$control,$ahead                # 231e
        andc    $control_4,$control_2,$outside_5        # 232e
        andc    $control,$control,$outside_4            # 233e
        and     $control_2,$control_3,$ahead_5          # 234e
        rotqbii $control_4,$control_4,1                 # 234o
        fm      $ahead,$ahead_6,$slope_12               # 235e
        rotqbii $control,$control,1                     # 235o
        andc    $control_2,$control_2,$outside          # 236e
        or      $outside,$rest_8,$v                     # 237e
        nop     $127                                    # 238e pairing
        rotqbii $control_2,$control_2,1                 # 238o
        or      $outside,$outside,$w_9                  # 239e
        gb      $control_5,$control_4                   # 239o
        gb      $control,$control                       # 240o
        xor     $t_4,$ahead,$k_sign                     # 241e
        orc     $outside,$outside,$seen_6               # 242e
        gb      $control_2,$control_2                   # 242o
        cgt     $control_6,$t_best_4,$t_4               # 243e
        shlqbii $control_5,$control_5,4                 # 243o
        shlqbii $control,$control,4                     # 244o
        and     $control_6,$control_6,$ahead            # 245e
        nop     $127                                    # 246e pairing
        shlqbii $control_2,$control_2,4                 # 246o
        andc    $control_6,$control_6,$outside          # 247e
        lqx     $control_5,$control_5,$a_controls       # 247o
        lqx     $control,$control,$a_controls           # 248o
        rotqbii $control_6,$control_6,1                 # 249o
        lqx     $control_2,$control_2,$a_controls       # 250o
        gb      $control_6,$control_6                   # 253o
        shufb   $nearest,$nearest_2,$object_2,$control  # 254o
        shufb   $t_best,$t_best,$t_2,$control           # 255o
        shufb   $t_best_3,$t_best_3,$t_3,$control_2     # 256o
        shlqbii $control,$control_6,4                   # 257o
        stqd    $nearest,448($a_packet)                 # 258o
        stqd    $t_best,384($a_packet)                  # 259o
        shufb   $t_best,$t_best_2,$t,$control_5         # 260o
        shufb   $nearest,$nearest_3,$object_2,$control_5 # 261o
        shufb   $nearest_6,$nearest_4,$object_2,$control_2 # 262o
        stqd    $t_best_3,416($a_packet)                # 263o
        stqd    $t_best,400($a_packet)                  # 264o
        stqd    $nearest,464($a_packet)                 # 265o
        stqd    $nearest_6,480($a_packet)               # 266o
        hbrr    next_triangle_back,next_triangle        # 267o hint
        lqx     $control,$control,$a_controls           # 268o
        shufb   $t_best,$t_best_4,$t_4,$control         # 274o
        shufb   $nearest,$nearest_5,$object_2,$control  # 275o
        stqd    $t_best,432($a_packet)                  # 278o
        stqd    $nearest,496($a_packet)                 # 279o
next_triangle_back:
        brnz    $triangles,next_triangle                # 280o
        nop     $127                                    # 281e pairing
        bi      $lr                                     # 281o
next_run_short:
        ai      $count,$count,-1                        # 0e
        lqd     $candidate,0($a_first)                  # 0o
        ai      $a_first,$a_first,16                    # 1e
        rotmi   $candidate,$candidate,-16               # 6e
        a       $triangles,$triangles,$candidate        # 10e
        brnz    $count,next_run_short                   # 10o
        nop     $127                                    # 11e pairing
        br      isect_mesh_pairs_r16_block              # 11o
endfunction isect_mesh_pairs_r16
