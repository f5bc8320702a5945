# isect_triangles_r16   nearest hit of sixteen rays with the triangles of an array, from both sides
#   C       void isect_triangles_r16(struct rays *, const struct shear *,
#                                    const struct triangle *, int count, int object);
#   In      $3 rays, $4 what shear_r16 made of them, $5 triangles, $6 count (0 is none), $7 object
#           number of the first; pointers 16-aligned
#   Out     rays: t, object, u, v, where a hit has 0 < t < what was there
#   Uses    $2, $4-$79   Saves  -   Stack  0   Calls  -
#   Domain  rays.t >= 0; distances from the origin below 2^60; triangles higher than 2^-50 across
#           the ray
#   Error   6 ulp of t, 8e-5 in u and v; edges from 1/100 of the distance to all of it, area across
#           the ray above 1/20 of their square
#   Twin    oracle/src/twin/triangle.rs
# Scheduled by spu schedule from isect_triangles_r16.s

        .include "work_unit.inc"
        .include "macros.inc"
        .include "rays.inc"
        .include "flat.inc"
        .include "triangle_tmpl.inc"

        .set    a_rays,3
        .set    a_shear,4
        .set    a_triangle,5
        .set    count,6
        .set    object,7
        # constants
        .set    k_above_one,10
        .set    k_sign,11
        .set    m_splat,12
        .set    a_controls,13
        # -t, carried from triangle to triangle; the rest of a hit waits in the rays, so that the
        # pipelined loop has registers enough
        .set    n_best,14
        .set    best,18
        # the triangle
        .set    vertex_a,19
        .set    vertex_b,20
        .set    vertex_c,21
        # temporaries
        .set    xa,22
        .set    ya,23
        .set    za,24
        .set    xb,25
        .set    yb,26
        .set    zb,27
        .set    xc,28
        .set    yc,29
        .set    zc,30
        .set    axis,31
        .set    origin,32
        .set    slope,33
        .set    p,31                                    # reused
        .set    q,32                                    # reused
        .set    u,34
        .set    v,35
        .set    w,36
        .set    det,37
        .set    inverse,38
        .set    t_y,39
        .set    t_e,40
        .set    n,41
        .set    outside,42
        .set    control,37                              # reused

        sign_controls_table

function isect_triangles_r16
        .set    count_2,79
        .set    vertex_b_2,26
        .set    vertex_a_2,48
        .set    p_2,55
        .set    vertex_c_2,44
        .set    p_3,51
        .set    p_4,29
        .set    p_5,46
        .set    p_6,60
        .set    q_2,30
        .set    p_7,64
        .set    yb_2,62
        .set    ya_2,63
        .set    q_3,57
        .set    q_4,71
        .set    yc_2,55
        .set    q_5,24
        .set    xc_2,49
        .set    xb_2,74
        .set    yc_3,30
        .set    p_8,27
        .set    q_6,47
        .set    p_9,59
        .set    q_7,72
        .set    zb_2,73
        .set    xa_2,51
        .set    p_10,40
        .set    p_11,45
        .set    xb_3,52
        .set    xc_3,54
        .set    yb_3,61
        .set    yc_4,66
        .set    zb_3,28
        .set    zc_2,77
        .set    xa_3,46
        .set    xa_4,68
        .set    xb_4,70
        .set    zc_3,76
        .set    ya_3,55
        .set    zb_4,60
        .set    za_2,29
        .set    p_12,23
        .set    xc_4,64
        .set    slope_2,57
        .set    ya_4,24
        .set    q_8,20
        .set    q_9,25
        .set    xc_5,47
        .set    q_10,37
        .set    xc_6,32
        .set    q_11,39
        .set    za_3,58
        .set    zc_4,65
        .set    za_4,73
        .set    slope_3,77
        .set    zb_5,55
        .set    slope_4,72
        .set    xb_5,50
        .set    yb_4,53
        .set    yc_5,56
        .set    za_5,54
        .set    q_12,67
        .set    xa_5,75
        .set    zc_5,27
        .set    zb_6,59
        .set    xc_7,40
        .set    xa_6,64
        .set    ya_5,45
        .set    yb_5,2
        .set    zc_6,31
        .set    yc_6,69
        .set    xb_6,44
        .set    ya_6,48
        .set    zc_7,74
        .set    xc_8,20
        .set    ya_7,39
        .set    slope_5,40
        .set    zc_8,71
        .set    slope_6,23
        .set    xb_7,27
        .set    slope_7,45
        .set    slope_8,31
        .set    ya_8,25
        .set    yc_7,19
        .set    p_13,37
        .set    xa_7,33
        .set    yc_8,23
        .set    xa_8,57
        .set    yb_6,56
        .set    yc_9,36
        .set    q_13,66
        .set    p_14,61
        .set    q_14,75
        .set    v_2,30
        .set    p_15,68
        .set    q_15,70
        .set    v_3,34
        .set    v_4,19
        .set    q_16,61
        .set    q_17,33
        .set    w_2,24
        .set    slope_9,52
        .set    p_16,63
        .set    u_2,40
        .set    slope_10,56
        .set    w_3,46
        .set    xa_9,31
        .set    p_17,48
        .set    u_3,32
        .set    p_18,69
        .set    v_5,45
        .set    q_18,36
        .set    slope_11,63
        .set    p_19,67
        .set    q_19,2
        .set    w_4,25
        .set    u_4,27
        .set    u_5,62
        .set    q_20,69
        .set    u_6,44
        .set    w_5,33
        .set    v_6,23
        .set    control_2,25
        .set    q_21,26
        .set    u_7,47
        .set    w_6,39
        .set    w_7,26
        .set    control_3,33
        .set    t_y_2,49
        .set    control_4,50
        .set    t_y_3,53
        .set    t_e_2,34
        .set    t_y_4,57
        .set    t_e_3,12
        .set    t_y_5,42
        .set    t_y_6,22
        .set    inverse_2,21
        .set    slope_12,12
        .set    t_e_4,25
        .set    u_8,78
        .set    w_8,49
        .set    inverse_3,24
        .set    v_7,2
        .set    n_2,19
        .set    u_9,9
        .set    w_9,8
        .set    v_8,18
        .set    u_10,21
        .set    n_3,24
        .set    v_9,22
        .set    w_10,28
        .set    n_4,30
        .set    outside_2,38
        .set    n_5,8
        .set    outside_3,43
        .set    outside_4,49
        .set    n_6,28
        .set    outside_5,36
        .set    control_5,57
        .set    control_6,36
        .set    control_7,61
        .set    control_8,42
        .set    n_7,12
        .set    control_9,69
        .set    control_10,38
        .set    control_11,76
        .set    control_12,43
        .set    best_2,63
        .set    best_3,69
        .set    best_4,57
        .set    best_5,2
        .set    best_6,34
        .set    best_7,64
        .set    best_8,61
        .set    best_9,48
        .set    best_10,32
        .set    best_11,31
        .set    best_12,51
        .set    control_13,34
        .set    best_13,38
        .set    control_14,20
        .set    best_14,43
        .set    best_15,46
        .set    control_15,62
        .set    best_16,20
        .set    best_17,79
        .set    best_18,12
        .set    inverse_4,5
        .set    u_11,6
        .set    v_10,4
        .set    best_19,5
        .set    w_11,9
        .set    outside_6,8
        .set    n_8,10
        .set    control_16,18
        .set    control_17,9
        .set    object_2,9
        .set    control_18,5
        .set    best_20,7
        .set    best_21,10
        .set    q_22,8
        .set    q_23,9
        .set    q_24,12
        .set    p_20,18
        .set    q_25,19
        .set    p_21,21
        .set    vertex_a_3,22
        .set    vertex_c_3,23
        .set    p_22,24
        .set    ya_9,28
        .set    za_6,30
        .set    zc_9,33
        .set    zc_10,34
        .set    zb_7,24
        .set    slope_13,35
        .set    p_23,36
        .set    slope_14,37
        .set    zb_8,9
        .set    xa_10,38
        .set    p_24,39
        .set    yc_10,41
        .set    p_25,42
        .set    zb_9,43
        .set    p_26,44
        .set    xa_11,45
        .set    q_26,46
        .set    za_7,47
        .set    xb_8,48
        .set    ya_10,50
        .set    zb_10,51
        .set    yb_7,52
        .set    slope_15,53
        .set    xb_9,54
        .set    zc_11,24
        .set    slope_16,55
        .set    yc_11,44
        .set    q_27,56
        .set    xc_9,21
        .set    xc_10,39
        .set    yc_12,8
        .set    za_8,31
        .set    ya_11,26
        .set    yb_8,36
        .set    zc_12,19
        .set    xa_12,24
        .set    slope_17,42
        .set    ya_12,46
        .set    yc_13,53
        .set    p_27,25
        .set    slope_18,58
        .set    yb_9,18
        .set    xa_13,59
        .set    q_28,60
        .set    xc_11,61
        .set    za_9,18
        .set    xb_10,22
        .set    zc_13,23
        .set    p_28,54
        .set    q_29,62
        .set    xb_11,39
        .set    zb_11,25
        .set    yb_10,20
        .set    slope_19,44
        .set    slope_20,65
        .set    p_29,66
        .set    slope_21,67
        .set    yb_11,12
        .set    best_22,36
        .set    q_30,68
        .set    xa_14,37
        .set    best_23,45
        .set    best_24,70
        .set    best_25,71
        .set    best_26,73
        .set    yb_12,35
        .set    best_27,52
        .set    best_28,74
        .set    best_29,40
        .set    best_30,55
        .set    p_30,75
        .set    best_31,76
        .set    u_12,63
        .set    best_32,77
        .set    u_13,64
        .set    p_31,62
        .set    p_32,78
        .set    q_31,49
        .set    q_32,21
        .set    p_33,72
        .set    p_34,79
        .set    q_33,48
        .set    xc_12,56
        .set    q_34,35
        .set    v_11,37
        .set    v_12,29
        .set    ya_13,41
        .set    u_14,12
        .set    w_12,22
        .set    v_13,8
        .set    p_35,38
        .set    v_14,32
        .set    control_19,35
        .set    control_20,46
        .set    w_13,2
        .set    q_35,28
        .set    v_15,38
        .set    t_y_7,27
        .set    t_y_8,24
        .set    t_y_9,41
        .set    v_16,28
        .set    t_y_10,38
        .set    w_14,20
        .set    control_21,39
        .set    t_e_5,37
        .set    t_e_6,41
        .set    t_e_7,35
        .set    inverse_5,27
        .set    t_y_11,35
        .set    u_15,37
        .set    u_16,41
        .set    n_9,27
        .set    t_e_8,30
        .set    n_10,31
        .set    n_11,39
        .set    n_12,9
        .set    n_13,26
        .set    outside_7,30
        .set    outside_8,31
        .set    outside_9,24
        .set    outside_10,22
        .set    n_14,18
        .set    control_22,27
        .set    n_15,2
        .set    control_23,19
        .set    control_24,22
        .set    control_25,23
        .set    best_33,24
        .set    best_34,8
        .set    best_35,25
        .set    best_36,27
        .set    best_37,9
        nop     $127                                    # 0e pairing
        biz     $count,$lr                              # 0o

        ila     $m_splat,0x10203                        # 1e
        lqd     $n_best,384($a_rays)                    # 1o

        ilhu    $k_above_one,0x3f80                     # 2e
        lqd     $n_best+1,400($a_rays)                  # 2o

        ilhu    $k_sign,0x8000                          # 3e
        lqd     $signs,416($a_rays)                     # 3o

        clgti   $count_2,$count,2                       # 4e at least as many passes as overlap
        lqd     $signs+1,432($a_rays)                   # 4o

        iohl    $k_above_one,2                          # 5e
        shufb   $object,$object,$object,$m_splat        # 5o

        ila     $a_controls,sign_controls               # 6e
        xor     $n_best,$n_best,$k_sign                 # 7e

        xor     $n_best+1,$n_best+1,$k_sign             # 8e
        xor     $signs,$signs,$k_sign                   # 9e

        xor     $signs+1,$signs+1,$k_sign               # 10e
        brz     $count_2,next_triangle_short            # 10o too few passes

        ai      $count,$count,-1                        # 11e
        lqd     $vertex_b_2,16($a_triangle)             # 11o

        nop     $127                                    # 12e pairing
        lqd     $vertex_a_2,0($a_triangle)              # 12o

        ai      $count,$count,-1                        # 13e
        lqd     $p_2,80($a_shear)                       # 13o

        nop     $127                                    # 14e pairing
        lqd     $vertex_c_2,32($a_triangle)             # 14o

        ai      $a_triangle,$a_triangle,48              # 15e
        lqd     $p_3,48($a_shear)                       # 15o

        lqd     $p,176($a_shear)                        # 16o
        lqd     $p_4,144($a_shear)                      # 17o

        lqd     $p_5,32($a_shear)                       # 18o
        lqd     $p_6,96($a_shear)                       # 19o

        lqd     $q_2,272($a_shear)                      # 20o
        lqd     $p_7,16($a_shear)                       # 21o

        shufb   $yb_2,$vertex_b_2,$vertex_b_2,$p_2      # 22o
        shufb   $ya_2,$vertex_a_2,$vertex_a_2,$p_2      # 23o

        lqd     $q_3,240($a_shear)                      # 24o
        lqd     $q_4,368($a_shear)                      # 25o

        fs      $yb_2,$yb_2,$q_2                        # 26e
        shufb   $yc_2,$vertex_c_2,$vertex_c_2,$p_2      # 26o

        fs      $ya_2,$ya_2,$q_2                        # 27e
        lqd     $q_5,288($a_shear)                      # 27o

        shufb   $xc_2,$vertex_c_2,$vertex_c_2,$p_3      # 28o
        shufb   $xb_2,$vertex_b_2,$vertex_b_2,$p_3      # 29o

        fs      $yc_3,$yc_2,$q_2                        # 30e
        lqd     $q,208($a_shear)                        # 30o

        nop     $127                                    # 31e pairing
        lqd     $p_8,128($a_shear)                      # 31o

        fs      $xc_2,$xc_2,$q_3                        # 32e
        lqd     $q_6,224($a_shear)                      # 32o

        fs      $xb_2,$xb_2,$q_3                        # 33e
        lqd     $p_9,160($a_shear)                      # 33o

        lqd     $q_7,336($a_shear)                      # 34o
        shufb   $zb_2,$vertex_b_2,$vertex_b_2,$p        # 35o

        shufb   $xa_2,$vertex_a_2,$vertex_a_2,$p_3      # 36o
        lqd     $p_10,0($a_shear)                       # 37o

        lqd     $p_11,64($a_shear)                      # 38o
        shufb   $xb_3,$vertex_b_2,$vertex_b_2,$p_5      # 39o

        fs      $xa_2,$xa_2,$q_3                        # 40e
        shufb   $xc_3,$vertex_c_2,$vertex_c_2,$p_5      # 40o

        shufb   $yb_3,$vertex_b_2,$vertex_b_2,$p_6      # 41o
        shufb   $yc_4,$vertex_c_2,$vertex_c_2,$p_6      # 42o

        fs      $xb_3,$xb_3,$q_6                        # 43e
        shufb   $zb_3,$vertex_b_2,$vertex_b_2,$p_4      # 43o

        nop     $127                                    # 44e pairing
        shufb   $zc_2,$vertex_c_2,$vertex_c_2,$p_4      # 44o

        fs      $yb_3,$yb_3,$q_5                        # 45e
        shufb   $xa_3,$vertex_a_2,$vertex_a_2,$p_5      # 45o

        fs      $yc_4,$yc_4,$q_5                        # 46e
        shufb   $xa_4,$vertex_a_2,$vertex_a_2,$p_7      # 46o

        fs      $zb_3,$zb_3,$q_7                        # 47e
        shufb   $xb_4,$vertex_b_2,$vertex_b_2,$p_7      # 47o

        fs      $zc_3,$zc_2,$q_7                        # 48e
        shufb   $ya_3,$vertex_a_2,$vertex_a_2,$p_6      # 48o

        fs      $zb_4,$zb_2,$q_4                        # 49e
        shufb   $za_2,$vertex_a_2,$vertex_a_2,$p_4      # 49o

        fs      $xa_3,$xa_3,$q_6                        # 50e
        lqd     $p_12,112($a_shear)                     # 50o

        fs      $xa_4,$xa_4,$q                          # 51e
        shufb   $xc_4,$vertex_c_2,$vertex_c_2,$p_7      # 51o

        fs      $xb_4,$xb_4,$q                          # 52e
        lqd     $slope_2,432($a_shear)                  # 52o

        fs      $ya_4,$ya_3,$q_5                        # 53e
        lqd     $q_8,192($a_shear)                      # 53o

        fs      $za_2,$za_2,$q_7                        # 54e
        lqd     $q_9,352($a_shear)                      # 54o

        fs      $xc_5,$xc_3,$q_6                        # 55e
        lqd     $q_10,320($a_shear)                     # 55o

        fs      $xc_6,$xc_4,$q                          # 56e
        lqd     $q_11,256($a_shear)                     # 56o

        shufb   $za_3,$vertex_a_2,$vertex_a_2,$p_8      # 57o
        shufb   $zc_4,$vertex_c_2,$vertex_c_2,$p_9      # 58o

        shufb   $za_4,$vertex_a_2,$vertex_a_2,$p_9      # 59o
        lqd     $slope_3,464($a_shear)                  # 60o

        fs      $za_3,$za_3,$q_10                       # 61e
        shufb   $zb_5,$vertex_b_2,$vertex_b_2,$p_8      # 61o

        fs      $zc_4,$zc_4,$q_9                        # 62e
        lqd     $slope_4,400($a_shear)                  # 62o

        fs      $za_4,$za_4,$q_9                        # 63e
        shufb   $xb_5,$vertex_b_2,$vertex_b_2,$p_10     # 63o

        nop     $127                                    # 64e pairing
        shufb   $yb_4,$vertex_b_2,$vertex_b_2,$p_11     # 64o

        fs      $zb_5,$zb_5,$q_10                       # 65e
        shufb   $yc_5,$vertex_c_2,$vertex_c_2,$p_11     # 65o

        fnms    $yc_3,$slope_3,$zc_3,$yc_3              # 66e
        shufb   $za_5,$vertex_a_2,$vertex_a_2,$p        # 66o

        fs      $xb_5,$xb_5,$q_8                        # 67e
        lqd     $q_12,304($a_shear)                     # 67o

        fs      $yb_4,$yb_4,$q_11                       # 68e
        shufb   $xa_5,$vertex_a_2,$vertex_a_2,$p_10     # 68o

        fs      $yc_5,$yc_5,$q_11                       # 69e
        shufb   $zc_5,$vertex_c_2,$vertex_c_2,$p_8      # 69o

        fs      $za_5,$za_5,$q_4                        # 70e
        shufb   $zb_6,$vertex_b_2,$vertex_b_2,$p_9      # 70o

        fnms    $xc_6,$slope_4,$zc_3,$xc_6              # 71e
        shufb   $xc_7,$vertex_c_2,$vertex_c_2,$p_10     # 71o

        fs      $xa_6,$xa_5,$q_8                        # 72e
        shufb   $ya_5,$vertex_a_2,$vertex_a_2,$p_11     # 72o

        fnms    $yb_5,$slope_3,$zb_3,$yb_2              # 73e
        shufb   $zc_6,$vertex_c_2,$vertex_c_2,$p        # 73o

        fs      $zb_6,$zb_6,$q_9                        # 74e
        shufb   $yc_6,$vertex_c_2,$vertex_c_2,$p_12     # 74o

        fnms    $xb_6,$slope_2,$zb_4,$xb_2              # 75e
        shufb   $ya_6,$vertex_a_2,$vertex_a_2,$p_12     # 75o

        fs      $zc_7,$zc_5,$q_10                       # 76e
        lqd     $slope,416($a_shear)                    # 76o

        fs      $xc_8,$xc_7,$q_8                        # 77e
        shufb   $yb,$vertex_b_2,$vertex_b_2,$p_12       # 77o

        fs      $ya_7,$ya_5,$q_11                       # 78e
        lqd     $slope_5,480($a_shear)                  # 78o

        fs      $zc_8,$zc_6,$q_4                        # 79e
        lqd     $slope_6,448($a_shear)                  # 79o

        fnms    $xb_7,$slope_4,$zb_3,$xb_4              # 80e
        lqd     $slope_7,496($a_shear)                  # 80o

        fs      $ya_6,$ya_6,$q_12                       # 81e
        lqd     $slope_8,384($a_shear)                  # 81o

        fnms    $ya_8,$slope_3,$za_2,$ya_2              # 82e
        fs      $yb,$yb,$q_12                           # 83e

        fnms    $xc_5,$slope,$zc_4,$xc_5                # 84e
        fs      $yc_6,$yc_6,$q_12                       # 85e

        fnms    $xb_3,$slope,$zb_6,$xb_3                # 86e
        fnms    $xa_2,$slope_2,$za_5,$xa_2              # 87e

        fnms    $yb_4,$slope_6,$zb_5,$yb_4              # 88e
        fnms    $ya_7,$slope_6,$za_3,$ya_7              # 89e

        fnms    $xc_2,$slope_2,$zc_8,$xc_2              # 90e
        fnms    $yc_7,$slope_5,$zc_4,$yc_4              # 91e

        fm      $p_13,$yc_3,$xb_7                       # 92e
        fnms    $xa_7,$slope,$za_4,$xa_3                # 93e

        fnms    $ya_4,$slope_5,$za_4,$ya_4              # 94e
        fnms    $ya_6,$slope_7,$za_5,$ya_6              # 95e

        fnms    $yc_8,$slope_6,$zc_7,$yc_5              # 96e
        fnms    $xa_8,$slope_4,$za_2,$xa_4              # 97e

        fm      $p_5,$ya_8,$xc_6                        # 98e
        fnms    $yb_6,$slope_5,$zb_6,$yb_3              # 99e

        fnms    $yb,$slope_7,$zb_4,$yb                  # 100e
        fnms    $yc_9,$slope_7,$zc_8,$yc_6              # 101e

        fm      $p_11,$yc_7,$xb_3                       # 102e
        fms     $q_13,$yc_3,$xb_7,$p_13                 # 103e

        fm      $p_14,$ya_6,$xc_2                       # 104e
        fm      $p_10,$ya_4,$xc_5                       # 105e

        fms     $q_14,$ya_8,$xc_6,$p_5                  # 106e
        fms     $v_2,$xa_8,$yc_3,$p_5                   # 107e

        fm      $p_5,$yb_6,$xa_7                        # 108e
        fm      $p_15,$yb,$xa_2                         # 109e

        fms     $q_15,$yc_7,$xb_3,$p_11                 # 110e
        fms     $v_3,$xa_2,$yc_9,$p_14                  # 111e

        fms     $q_7,$ya_4,$xc_5,$p_10                  # 112e
        fms     $v_4,$xa_7,$yc_7,$p_10                  # 113e

        fnms    $xb_5,$slope_8,$zb_5,$xb_5              # 114e
        fms     $q_16,$ya_6,$xc_2,$p_14                 # 115e

        fms     $q_17,$yb_6,$xa_7,$p_5                  # 116e
        lnop                                            # 116o pairing

        fms     $w_2,$xb_3,$ya_4,$p_5                   # 117e
        lqd     $slope_9,528($a_shear)                  # 117o

        fnms    $xc_8,$slope_8,$zc_7,$xc_8              # 118e
        fm      $p_16,$yc_9,$xb_6                       # 119e

        fms     $u_2,$xc_5,$yb_6,$p_11                  # 120e
        lqd     $slope_10,544($a_shear)                 # 120o

        fms     $w_3,$xb_6,$ya_6,$p_15                  # 121e
        fnms    $xa_9,$slope_8,$za_3,$xa_6              # 122e

        fm      $p_17,$yb_5,$xa_8                       # 123e
        fms     $u_3,$xc_6,$yb_5,$p_13                  # 124e

        fm      $p_18,$yc_8,$xb_5                       # 125e
        fs      $v_5,$v_3,$q_16                         # 126e

        fms     $u,$xc_2,$yb,$p_16                      # 127e
        lnop                                            # 127o pairing

        fs      $v_4,$v_4,$q_7                          # 128e
        lqd     $q_7,336($a_shear)                      # 128o

        fs      $u_2,$u_2,$q_15                         # 129e
        lnop                                            # 129o pairing

        fms     $q_18,$yc_9,$xb_6,$p_16                 # 130e
        lqd     $slope_11,560($a_shear)                 # 130o

        fm      $p_7,$ya_7,$xc_8                        # 131e
        fm      $p_19,$yb_4,$xa_9                       # 132e

        fms     $q_19,$yb_5,$xa_8,$p_17                 # 133e
        lnop                                            # 133o pairing

        fms     $w_4,$xb_7,$ya_8,$p_17                  # 134e
        lqd     $vertex_a_2,0($a_triangle)              # 134o

        fs      $v_2,$v_2,$q_14                         # 135e
        lnop                                            # 135o pairing

        fs      $u_4,$u_3,$q_13                         # 136e
        lqd     $q,208($a_shear)                        # 136o

        fms     $u_5,$xc_8,$yb_4,$p_18                  # 137e
        fms     $q_20,$yc_8,$xb_5,$p_18                 # 138e

        fs      $w_2,$w_2,$q_17                         # 139e
        fa      $control,$u_2,$v_4                      # 140e

        fs      $u_6,$u,$q_18                           # 141e
        fms     $w_5,$xb_5,$ya_7,$p_19                  # 142e

        fms     $q_8,$ya_7,$xc_8,$p_7                   # 143e
        lnop                                            # 143o pairing

        fms     $v_6,$xa_9,$yc_8,$p_7                   # 144e
        lqd     $p_7,16($a_shear)                       # 144o

        fs      $w,$w_4,$q_19                           # 145e
        lnop                                            # 145o pairing

        fms     $q_11,$yb_4,$xa_9,$p_19                 # 146e
        lqd     $p,176($a_shear)                        # 146o

        fa      $control_2,$u_4,$v_2                    # 147e
        lqd     $q_12,304($a_shear)                     # 147o

        fms     $q_21,$yb,$xa_2,$p_15                   # 148e
        lqd     $p_3,48($a_shear)                       # 148o

        fa      $control,$control,$w_2                  # 149e
        lnop                                            # 149o pairing

        fs      $u_7,$u_5,$q_20                         # 150e
        shufb   $xa_4,$vertex_a_2,$vertex_a_2,$p_7      # 150o

        fs      $v_6,$v_6,$q_8                          # 151e
        lqd     $q_8,192($a_shear)                      # 151o

        fs      $w_6,$w_5,$q_11                         # 152e
        fa      $control_2,$control_2,$w                # 153e

        fs      $w_7,$w_3,$q_21                         # 154e
        lqd     $p_5,32($a_shear)                       # 154o

        fa      $control_3,$u_6,$v_5                    # 155e
        frest   $t_y_2,$control                         # 155o

        fs      $xa_4,$xa_4,$q                          # 156e
        fa      $control_4,$u_7,$v_6                    # 157e

        fi      $t_y_2,$control,$t_y_2                  # 159e
        frest   $t_y_3,$control_2                       # 159o

        fa      $control_3,$control_3,$w_7              # 161e
        fi      $t_y_3,$control_2,$t_y_3                # 163e

        fa      $control_4,$control_4,$w_6              # 165e
        lnop                                            # 165o pairing

        fnms    $t_e_2,$control,$t_y_2,$k_above_one     # 166e
        lqd     $q_10,320($a_shear)                     # 166o

        frest   $t_y_4,$control_3                       # 167o
        fnms    $t_e_3,$control_2,$t_y_3,$k_above_one   # 170e

        fi      $t_y_5,$control_3,$t_y_4                # 171e
        frest   $t_y_6,$control_4                       # 171o

        fma     $inverse_2,$t_e_2,$t_y_2,$t_y_2         # 173e
        fi      $t_y_6,$control_4,$t_y_6                # 175e

        fma     $inverse,$t_e_3,$t_y_3,$t_y_3           # 177e
        lqd     $slope_12,512($a_shear)                 # 177o

        fnms    $t_e_4,$control_3,$t_y_5,$k_above_one   # 178e
        lqd     $slope,416($a_shear)                    # 178o

        fm      $u_8,$u_2,$inverse_2                    # 179e
        fm      $w_8,$w_2,$inverse_2                    # 180e

        fm      $v,$v_4,$inverse_2                      # 181e
        fnms    $t_e,$control_4,$t_y_6,$k_above_one     # 182e

        fm      $u,$u_4,$inverse                        # 183e
        lqd     $p_8,128($a_shear)                      # 183o

        fma     $inverse_3,$t_e_4,$t_y_5,$t_y_5         # 184e
        lqd     $q_9,352($a_shear)                      # 184o

        fm      $w,$w,$inverse                          # 185e
        fm      $v_7,$v_2,$inverse                      # 186e

        fm      $n,$u_8,$za_4                           # 187e
        lnop                                            # 187o pairing

        fma     $inverse,$t_e,$t_y_6,$t_y_6             # 188e
        lqd     $p_10,0($a_shear)                       # 188o

        fm      $n_2,$u,$za_2                           # 189e
        lqd     $p_4,144($a_shear)                      # 189o

        fm      $u_9,$u_6,$inverse_3                    # 190e
        lqd     $vertex_c_2,32($a_triangle)             # 190o

        fm      $w_9,$w_7,$inverse_3                    # 191e
        lqd     $vertex_b_2,16($a_triangle)             # 191o

        fm      $v_8,$v_5,$inverse_3                    # 192e
        lqd     $p_11,64($a_shear)                      # 192o

        fma     $n,$v,$zb_6,$n                          # 193e
        lqd     $p_9,160($a_shear)                      # 193o

        fm      $u_10,$u_7,$inverse                     # 194e
        lqd     $q_6,224($a_shear)                      # 194o

        fma     $n_2,$v_7,$zb_3,$n_2                    # 195e
        shufb   $xa_5,$vertex_a_2,$vertex_a_2,$p_10     # 195o

        fm      $n_3,$u_9,$za_5                         # 196e
        shufb   $xc_3,$vertex_c_2,$vertex_c_2,$p_5      # 196o

        fm      $v_9,$v_6,$inverse                      # 197e
        shufb   $zb_2,$vertex_b_2,$vertex_b_2,$p        # 197o

        fm      $w_10,$w_6,$inverse                     # 198e
        lqd     $p_12,112($a_shear)                     # 198o

        fma     $n,$w_8,$zc_4,$n                        # 199e
        lqd     $q_11,256($a_shear)                     # 199o

        fm      $n_4,$u_10,$za_3                        # 200e
        shufb   $za_3,$vertex_a_2,$vertex_a_2,$p_8      # 200o

        fma     $n_2,$w,$zc_3,$n_2                      # 201e
        shufb   $xb_5,$vertex_b_2,$vertex_b_2,$p_10     # 201o

        fma     $n_3,$v_8,$zb_4,$n_3                    # 202e
        lqd     $p_6,96($a_shear)                       # 202o

        or      $outside_2,$u_9,$v_8                    # 203e
        shufb   $xb_4,$vertex_b_2,$vertex_b_2,$p_7      # 203o

        or      $outside,$u_8,$v                        # 204e
        shufb   $yb_4,$vertex_b_2,$vertex_b_2,$p_11     # 204o

        or      $outside_2,$outside_2,$w_9              # 205e
        shufb   $zc_4,$vertex_c_2,$vertex_c_2,$p_9      # 205o

        fma     $n_4,$v_9,$zb_5,$n_4                    # 206e
        lqd     $p_2,80($a_shear)                       # 206o

        fm      $n_2,$n_2,$slope_9                      # 207e
        shufb   $xb_3,$vertex_b_2,$vertex_b_2,$p_5      # 207o

        fma     $n_5,$w_9,$zc_8,$n_3                    # 208e
        lqd     $q_4,368($a_shear)                      # 208o

        or      $outside_3,$u_10,$v_9                   # 209e
        lqd     $q_5,288($a_shear)                      # 209o

        or      $outside,$outside,$w_8                  # 210e
        shufb   $yc_4,$vertex_c_2,$vertex_c_2,$p_6      # 210o

        fm      $n,$n,$slope_10                         # 211e
        shufb   $xa_3,$vertex_a_2,$vertex_a_2,$p_5      # 211o

        or      $outside_4,$u,$v_7                      # 212e
        shufb   $yb_2,$vertex_b_2,$vertex_b_2,$p_2      # 212o

        or      $outside_3,$outside_3,$w_10             # 213e
        shufb   $yc_5,$vertex_c_2,$vertex_c_2,$p_11     # 213o

        fma     $n_6,$w_10,$zc_7,$n_4                   # 214e
        lqd     $q_2,272($a_shear)                      # 214o

        or      $outside_5,$outside_4,$w                # 215e
        shufb   $xc_2,$vertex_c_2,$vertex_c_2,$p_3      # 215o

        cgt     $control_5,$n_best+1,$n_2               # 216e 0 < t < t_best
        shufb   $xb_2,$vertex_b_2,$vertex_b_2,$p_3      # 216o

        fm      $n_5,$n_5,$slope_11                     # 217e
        shufb   $ya_2,$vertex_a_2,$vertex_a_2,$p_2      # 217o

        andc    $control_6,$control_5,$outside_5        # 218e
        lqd     $q_3,240($a_shear)                      # 218o

        cgt     $control_7,$signs,$n                    # 219e 0 < t < t_best
        shufb   $yc_2,$vertex_c_2,$vertex_c_2,$p_2      # 219o

        fs      $yb_2,$yb_2,$q_2                        # 220e
        shufb   $xa_2,$vertex_a_2,$vertex_a_2,$p_3      # 220o

        andc    $control_8,$control_7,$outside          # 221e
        shufb   $yb_3,$vertex_b_2,$vertex_b_2,$p_6      # 221o

        fs      $ya_2,$ya_2,$q_2                        # 222e
        rotqbii $control_6,$control_6,1                 # 222o

        fs      $yc_3,$yc_2,$q_2                        # 223e
        shufb   $ya_3,$vertex_a_2,$vertex_a_2,$p_6      # 223o

        fs      $xc_2,$xc_2,$q_3                        # 224e
        shufb   $zc_2,$vertex_c_2,$vertex_c_2,$p_4      # 224o

        fs      $zb_4,$zb_2,$q_4                        # 225e
        shufb   $xc_4,$vertex_c_2,$vertex_c_2,$p_7      # 225o

        fs      $xb_2,$xb_2,$q_3                        # 226e
        shufb   $xc_7,$vertex_c_2,$vertex_c_2,$p_10     # 226o

        fs      $xa_2,$xa_2,$q_3                        # 227e
        lqd     $slope_2,432($a_shear)                  # 227o

        fm      $n_7,$n_6,$slope_12                     # 228e
        shufb   $zb_3,$vertex_b_2,$vertex_b_2,$p_4      # 228o

        fs      $yb_3,$yb_3,$q_5                        # 229e
        shufb   $za_2,$vertex_a_2,$vertex_a_2,$p_4      # 229o

        fs      $yc_4,$yc_4,$q_5                        # 230e
        shufb   $ya_5,$vertex_a_2,$vertex_a_2,$p_11     # 230o

        fs      $ya_4,$ya_3,$q_5                        # 231e
        shufb   $zb_5,$vertex_b_2,$vertex_b_2,$p_8      # 231o

        fs      $xb_3,$xb_3,$q_6                        # 232e
        shufb   $zc_5,$vertex_c_2,$vertex_c_2,$p_8      # 232o

        fs      $xa_3,$xa_3,$q_6                        # 233e
        shufb   $za_4,$vertex_a_2,$vertex_a_2,$p_9      # 233o

        cgt     $control_9,$signs+1,$n_5                # 234e 0 < t < t_best
        shufb   $zb_6,$vertex_b_2,$vertex_b_2,$p_9      # 234o

        fs      $xc_5,$xc_3,$q_6                        # 235e
        shufb   $za_5,$vertex_a_2,$vertex_a_2,$p        # 235o

        andc    $control_10,$control_9,$outside_2       # 236e
        shufb   $yc_6,$vertex_c_2,$vertex_c_2,$p_12     # 236o

        fs      $za_3,$za_3,$q_10                       # 237e
        shufb   $zc_6,$vertex_c_2,$vertex_c_2,$p        # 237o

        fnms    $xb_6,$slope_2,$zb_4,$xb_2              # 238e
        shufb   $ya_6,$vertex_a_2,$vertex_a_2,$p_12     # 238o

        cgt     $control_11,$n_best,$n_7                # 239e 0 < t < t_best
        shufb   $yb,$vertex_b_2,$vertex_b_2,$p_12       # 239o

        fs      $zb_5,$zb_5,$q_10                       # 240e
        lqd     $slope_6,448($a_shear)                  # 240o

        fs      $zc_7,$zc_5,$q_10                       # 241e
        gb      $control,$control_6                     # 241o

        fs      $yb_4,$yb_4,$q_11                       # 242e
        rotqbii $control_8,$control_8,1                 # 242o

        fs      $yc_5,$yc_5,$q_11                       # 243e
        fs      $za_5,$za_5,$q_4                        # 244e

        andc    $control_12,$control_11,$outside_3      # 245e
        shlqbii $control,$control,4                     # 245o

        fs      $yc_6,$yc_6,$q_12                       # 246e
        gb      $control_8,$control_8                   # 246o

        fs      $zc_3,$zc_2,$q_7                        # 247e
        lqd     $slope_3,464($a_shear)                  # 247o

        fs      $za_2,$za_2,$q_7                        # 248e
        lnop                                            # 248o pairing

        fs      $ya_7,$ya_5,$q_11                       # 249e
        lqd     $slope_7,496($a_shear)                  # 249o

        fs      $zc_8,$zc_6,$q_4                        # 250e
        lqd     $slope_8,384($a_shear)                  # 250o

        fs      $xb_4,$xb_4,$q                          # 251e
        lqx     $control,$control,$a_controls           # 251o

        fs      $zb_3,$zb_3,$q_7                        # 252e
        lqd     $slope_4,400($a_shear)                  # 252o

        fs      $xc_6,$xc_4,$q                          # 253e
        shlqbii $control_8,$control_8,4                 # 253o

        fs      $xb_5,$xb_5,$q_8                        # 254e
        fs      $xa_6,$xa_5,$q_8                        # 255e

        fs      $zc_4,$zc_4,$q_9                        # 256e
        lnop                                            # 256o pairing

        fs      $za_4,$za_4,$q_9                        # 257e
        shufb   $n_best+1,$n_best+1,$n_2,$control       # 257o

        fs      $xc_8,$xc_7,$q_8                        # 258e
        lqd     $slope_5,480($a_shear)                  # 258o

        fs      $zb_6,$zb_6,$q_9                        # 259e
        fnms    $xa_2,$slope_2,$za_5,$xa_2              # 260e

        fnms    $ya_8,$slope_3,$za_2,$ya_2              # 261e
        lqd     $best_2,592($a_rays)                    # 261o

        fnms    $yc_9,$slope_7,$zc_8,$yc_6              # 262e
        lqd     $best_3,464($a_rays)                    # 262o

        fnms    $xc_2,$slope_2,$zc_8,$xc_2              # 263e
        lqd     $best_4,528($a_rays)                    # 263o

        fnms    $yc_3,$slope_3,$zc_3,$yc_3              # 264e
        fnms    $xb_7,$slope_4,$zb_3,$xb_4              # 265e

        fs      $ya_6,$ya_6,$q_12                       # 266e
        lnop                                            # 266o pairing

        fnms    $xc_6,$slope_4,$zc_3,$xc_6              # 267e
        shufb   $best_5,$best_2,$v_7,$control           # 267o

        fnms    $xb_5,$slope_8,$zb_5,$xb_5              # 268e
        lnop                                            # 268o pairing

        fnms    $xc_8,$slope_8,$zc_7,$xc_8              # 269e
        shufb   $best_6,$best_4,$u,$control             # 269o

        fs      $yb,$yb,$q_12                           # 270e
        fnms    $xc_5,$slope,$zc_4,$xc_5                # 271e

        fnms    $xb_3,$slope,$zb_6,$xb_3                # 272e
        lnop                                            # 272o pairing

        fnms    $xa_9,$slope_8,$za_3,$xa_6              # 273e
        shufb   $best_7,$best_3,$object,$control        # 273o

        fnms    $yc_7,$slope_5,$zc_4,$yc_4              # 274e
        fnms    $ya_4,$slope_5,$za_4,$ya_4              # 275e

        fnms    $yb_4,$slope_6,$zb_5,$yb_4              # 276e
        lnop                                            # 276o pairing

        fnms    $ya_7,$slope_6,$za_3,$ya_7              # 277e
        stqd    $best_7,464($a_rays)                    # 277o

        fm      $p_13,$yc_3,$xb_7                       # 278e
        stqd    $best_6,528($a_rays)                    # 278o

        fnms    $xa_7,$slope,$za_4,$xa_3                # 279e
        stqd    $best_5,592($a_rays)                    # 279o

        fnms    $ya_6,$slope_7,$za_5,$ya_6              # 280e
        fnms    $yc_8,$slope_6,$zc_7,$yc_5              # 281e

        fnms    $xa_8,$slope_4,$za_2,$xa_4              # 282e
        fm      $p_5,$ya_8,$xc_6                        # 283e

        fnms    $yb_6,$slope_5,$zb_6,$yb_3              # 284e
        fnms    $yb,$slope_7,$zb_4,$yb                  # 285e

        fm      $p_11,$yc_7,$xb_3                       # 286e
        fm      $p_10,$ya_4,$xc_5                       # 287e

        fms     $q_13,$yc_3,$xb_7,$p_13                 # 288e
        fm      $p_14,$ya_6,$xc_2                       # 289e

        fms     $q_14,$ya_8,$xc_6,$p_5                  # 290e
        fms     $v_2,$xa_8,$yc_3,$p_5                   # 291e

        fm      $p_5,$yb_6,$xa_7                        # 292e
        fm      $p_15,$yb,$xa_2                         # 293e

        fms     $q_15,$yc_7,$xb_3,$p_11                 # 294e
        fnms    $yb_5,$slope_3,$zb_3,$yb_2              # 295e

        fms     $q_7,$ya_4,$xc_5,$p_10                  # 296e
        fms     $v_4,$xa_7,$yc_7,$p_10                  # 297e

        fms     $v_3,$xa_2,$yc_9,$p_14                  # 298e
        fms     $u_2,$xc_5,$yb_6,$p_11                  # 299e

        fm      $p_18,$yc_8,$xb_5                       # 300e
        fms     $q_16,$ya_6,$xc_2,$p_14                 # 301e

        fms     $q_17,$yb_6,$xa_7,$p_5                  # 302e
        lqd     $slope_10,544($a_shear)                 # 302o

        fms     $w_2,$xb_3,$ya_4,$p_5                   # 303e
        lqd     $slope_9,528($a_shear)                  # 303o

        fm      $p_16,$yc_9,$xb_6                       # 304e
        fm      $p_7,$ya_7,$xc_8                        # 305e

        fm      $p_19,$yb_4,$xa_9                       # 306e
        fms     $w_3,$xb_6,$ya_6,$p_15                  # 307e

        fm      $p_17,$yb_5,$xa_8                       # 308e
        fs      $v_4,$v_4,$q_7                          # 309e

        fs      $u_2,$u_2,$q_15                         # 310e
        fms     $u_3,$xc_6,$yb_5,$p_13                  # 311e

        fms     $u_5,$xc_8,$yb_4,$p_18                  # 312e
        lnop                                            # 312o pairing

        fs      $v_5,$v_3,$q_16                         # 313e
        lqd     $best_8,544($a_rays)                    # 313o

        fs      $w_2,$w_2,$q_17                         # 314e
        fms     $u,$xc_2,$yb,$p_16                      # 315e

        fms     $w_5,$xb_5,$ya_7,$p_19                  # 316e
        fms     $q_8,$ya_7,$xc_8,$p_7                   # 317e

        fms     $q_18,$yc_9,$xb_6,$p_16                 # 318e
        lqd     $slope_11,560($a_shear)                 # 318o

        fms     $q_11,$yb_4,$xa_9,$p_19                 # 319e
        fms     $q_19,$yb_5,$xa_8,$p_17                 # 320e

        fms     $w_4,$xb_7,$ya_8,$p_17                  # 321e
        lqd     $best_9,624($a_rays)                    # 321o

        fms     $q_20,$yc_8,$xb_5,$p_18                 # 322e
        fs      $v_2,$v_2,$q_14                         # 323e

        fa      $control,$u_2,$v_4                      # 324e
        lnop                                            # 324o pairing

        fs      $u_4,$u_3,$q_13                         # 325e
        lqd     $best_10,496($a_rays)                   # 325o

        fms     $v_6,$xa_9,$yc_8,$p_7                   # 326e
        lqd     $best_11,512($a_rays)                   # 326o

        fms     $q_21,$yb,$xa_2,$p_15                   # 327e
        lqd     $best_12,448($a_rays)                   # 327o

        fs      $u_6,$u,$q_18                           # 328e
        rotqbii $control_13,$control_10,1               # 328o

        fs      $w_6,$w_5,$q_11                         # 329e
        rotqbii $control_3,$control_12,1                # 329o

        fs      $w,$w_4,$q_19                           # 330e
        lqd     $best_5,576($a_rays)                    # 330o

        fa      $control_2,$u_4,$v_2                    # 331e
        lqd     $best_13,480($a_rays)                   # 331o

        fa      $control,$control,$w_2                  # 332e
        gb      $control_13,$control_13                 # 332o

        fs      $v_6,$v_6,$q_8                          # 333e
        gb      $control_14,$control_3                  # 333o

        fs      $u_7,$u_5,$q_20                         # 334e
        lqd     $best_14,608($a_rays)                   # 334o

        fs      $w_7,$w_3,$q_21                         # 335e
        lqd     $best_15,560($a_rays)                   # 335o

        fa      $control_3,$u_6,$v_5                    # 336e
        shlqbii $control_13,$control_13,4               # 336o

        fa      $control_2,$control_2,$w                # 337e
        shlqbii $control_14,$control_14,4               # 337o

        ai      $a_triangle,$a_triangle,48              # 338e
        frest   $t_y_2,$control                         # 338o

        fa      $control_4,$u_7,$v_6                    # 340e
        lqx     $control_15,$control_13,$a_controls     # 340o

        lqx     $control_14,$control_14,$a_controls     # 341o
        fa      $control_3,$control_3,$w_7              # 342e

        fi      $t_y_2,$control,$t_y_2                  # 343e
        frest   $t_y_3,$control_2                       # 343o

        fa      $control_4,$control_4,$w_6              # 346e
        shufb   $signs+1,$signs+1,$n_5,$control_15      # 346o

        fi      $t_y_3,$control_2,$t_y_3                # 347e
        shufb   $best_5,$best_5,$v_9,$control_14        # 347o

        frest   $t_y_4,$control_3                       # 348o
        shufb   $best_12,$best_12,$object,$control_14   # 349o

        fnms    $t_e_2,$control,$t_y_2,$k_above_one     # 350e
        lqx     $control,$control_8,$a_controls         # 350o

        nop     $127                                    # 351e pairing
        shufb   $n_best,$n_best,$n_7,$control_14        # 351o

        fi      $t_y_5,$control_3,$t_y_4                # 352e
        frest   $t_y_6,$control_4                       # 352o

        nop     $127                                    # 353e pairing
        shufb   $best_16,$best_11,$u_10,$control_14     # 353o

        fnms    $t_e_3,$control_2,$t_y_3,$k_above_one   # 354e
        stqd    $best_5,576($a_rays)                    # 354o

        nop     $127                                    # 355e pairing
        shufb   $best_11,$best_10,$object,$control_15   # 355o

        fma     $inverse_2,$t_e_2,$t_y_2,$t_y_2         # 356e
        shufb   $best_5,$best_13,$object,$control       # 356o

        fi      $t_y_6,$control_4,$t_y_6                # 357e
        shufb   $signs,$signs,$n,$control               # 357o

        ai      $object,$object,1                       # 358e
        shufb   $best_10,$best_14,$v,$control           # 358o

        fnms    $t_e_4,$control_3,$t_y_5,$k_above_one   # 359e
        shufb   $best_17,$best_9,$v_8,$control_15       # 359o

        fma     $inverse,$t_e_3,$t_y_3,$t_y_3           # 360e
        shufb   $best_18,$best_8,$u_8,$control          # 360o

        stqd    $best_5,480($a_rays)                    # 361o
        fm      $w_8,$w_2,$inverse_2                    # 362e

        fm      $u_8,$u_2,$inverse_2                    # 363e
        fnms    $t_e,$control_4,$t_y_6,$k_above_one     # 364e

        fma     $inverse_3,$t_e_4,$t_y_5,$t_y_5         # 365e
        lnop                                            # 365o pairing

next_triangle:
            fm      $v,$v_4,$inverse_2                  # 0e
            stqd    $best_12,448($a_rays)               # 0o

            fm      $u,$u_4,$inverse                    # 1e
            stqd    $best_11,496($a_rays)               # 1o

            fm      $w,$w,$inverse                      # 2e
            stqd    $best_18,544($a_rays)               # 2o

            fm      $v_7,$v_2,$inverse                  # 3e
            stqd    $best_16,512($a_rays)               # 3o

            fma     $inverse,$t_e,$t_y_6,$t_y_6         # 4e
            shufb   $best,$best_15,$u_9,$control_15     # 4o

            fm      $w_9,$w_7,$inverse_3                # 5e
            stqd    $best_10,608($a_rays)               # 5o

            fm      $u_9,$u_6,$inverse_3                # 6e
        lqd     $slope,416($a_shear)                    # 6o

            fm      $n,$u_8,$za_4                       # 7e
            lqd     $slope_12,512($a_shear)             # 7o

            fm      $n_2,$u,$za_2                       # 8e
            stqd    $best,560($a_rays)                  # 8o

            or      $outside,$u_8,$v                    # 9e
        lqd     $q,208($a_shear)                        # 9o

            fm      $v_8,$v_5,$inverse_3                # 10e
        lqd     $q_8,192($a_shear)                      # 10o

            fm      $u_10,$u_7,$inverse                 # 11e
        lqd     $p,176($a_shear)                        # 11o

            fm      $v_9,$v_6,$inverse                  # 12e
        lqd     $p_12,112($a_shear)                     # 12o

            fm      $n_3,$u_9,$za_5                     # 13e
        lqd     $q_9,352($a_shear)                      # 13o

            fma     $n_2,$v_7,$zb_3,$n_2                # 14e
        lqd     $vertex_b_2,16($a_triangle)             # 14o

            fma     $n,$v,$zb_6,$n                      # 15e
        lqd     $p_8,128($a_shear)                      # 15o

            fm      $w_10,$w_6,$inverse                 # 16e
        lqd     $p_4,144($a_shear)                      # 16o

            fm      $n_4,$u_10,$za_3                    # 17e
        lqd     $q_10,320($a_shear)                     # 17o

            or      $outside_2,$u_9,$v_8                # 18e
        lqd     $q_11,256($a_shear)                     # 18o

            fma     $n_3,$v_8,$zb_4,$n_3                # 19e
        lqd     $p_10,0($a_shear)                       # 19o

            or      $outside_3,$u_10,$v_9               # 20e
        lqd     $vertex_c_2,32($a_triangle)             # 20o

            fma     $n_2,$w,$zc_3,$n_2                  # 21e
        lqd     $p_11,64($a_shear)                      # 21o

            or      $outside,$outside,$w_8              # 22e
        lqd     $p_5,32($a_shear)                       # 22o

            fma     $n,$w_8,$zc_4,$n                    # 23e
        lqd     $q_6,224($a_shear)                      # 23o

            fma     $n_4,$v_9,$zb_5,$n_4                # 24e
        lqd     $vertex_a_2,0($a_triangle)              # 24o

            or      $outside_4,$u,$v_7                  # 25e
        shufb   $xb_5,$vertex_b_2,$vertex_b_2,$p_10     # 25o

            or      $outside_2,$outside_2,$w_9          # 26e
        lqd     $p_3,48($a_shear)                       # 26o

            fma     $n_5,$w_9,$zc_8,$n_3                # 27e
        lqd     $q_5,288($a_shear)                      # 27o

            fm      $n_2,$n_2,$slope_9                  # 28e
        shufb   $xb_3,$vertex_b_2,$vertex_b_2,$p_5      # 28o

        fs      $xb_5,$xb_5,$q_8                        # 29e
        shufb   $yb_4,$vertex_b_2,$vertex_b_2,$p_11     # 29o

            fm      $n,$n,$slope_10                     # 30e
        shufb   $xc_3,$vertex_c_2,$vertex_c_2,$p_5      # 30o

            or      $outside_3,$outside_3,$w_10         # 31e
        shufb   $xa_3,$vertex_a_2,$vertex_a_2,$p_5      # 31o

        fs      $xb_3,$xb_3,$q_6                        # 32e
        lqd     $p_2,80($a_shear)                       # 32o

        fs      $yb_4,$yb_4,$q_11                       # 33e
        shufb   $yc_5,$vertex_c_2,$vertex_c_2,$p_11     # 33o

            or      $outside_5,$outside_4,$w            # 34e
        shufb   $xc_2,$vertex_c_2,$vertex_c_2,$p_3      # 34o

            cgt     $control_5,$n_best+1,$n_2           # 35e 0 < t < t_best
        shufb   $za_3,$vertex_a_2,$vertex_a_2,$p_8      # 35o

        fs      $xa_3,$xa_3,$q_6                        # 36e
        lqd     $p_9,160($a_shear)                      # 36o

        fs      $yc_5,$yc_5,$q_11                       # 37e
        lqd     $p_6,96($a_shear)                       # 37o

            cgt     $control_7,$signs,$n                # 38e 0 < t < t_best
        shufb   $yb_2,$vertex_b_2,$vertex_b_2,$p_2      # 38o

            fma     $n_6,$w_10,$zc_7,$n_4               # 39e
        lqd     $q_2,272($a_shear)                      # 39o

            fm      $n_5,$n_5,$slope_11                 # 40e
        shufb   $ya_2,$vertex_a_2,$vertex_a_2,$p_2      # 40o

        fs      $xc_5,$xc_3,$q_6                        # 41e
        shufb   $za_5,$vertex_a_2,$vertex_a_2,$p        # 41o

        fs      $za_3,$za_3,$q_10                       # 42e
        lqd     $p_7,16($a_shear)                       # 42o

            andc    $control_6,$control_5,$outside_5    # 43e
        lqd     $q_3,240($a_shear)                      # 43o

            andc    $control_8,$control_7,$outside      # 44e
        shufb   $yb_3,$vertex_b_2,$vertex_b_2,$p_6      # 44o

        fs      $ya_2,$ya_2,$q_2                        # 45e
        shufb   $zc_4,$vertex_c_2,$vertex_c_2,$p_9      # 45o

        fs      $yb_2,$yb_2,$q_2                        # 46e
        shufb   $yc_4,$vertex_c_2,$vertex_c_2,$p_6      # 46o

            fm      $n_7,$n_6,$slope_12                 # 47e
        shufb   $zb_3,$vertex_b_2,$vertex_b_2,$p_4      # 47o

        fs      $yb_3,$yb_3,$q_5                        # 48e
        lqd     $q_12,304($a_shear)                     # 48o

        fs      $zc_4,$zc_4,$q_9                        # 49e
        shufb   $xa_4,$vertex_a_2,$vertex_a_2,$p_7      # 49o

            cgt     $control_9,$signs+1,$n_5            # 50e 0 < t < t_best
        shufb   $xb_4,$vertex_b_2,$vertex_b_2,$p_7      # 50o

        fs      $xc_2,$xc_2,$q_3                        # 51e
        lqd     $q_4,368($a_shear)                      # 51o

            andc    $control_10,$control_9,$outside_2   # 52e
        shufb   $yc_6,$vertex_c_2,$vertex_c_2,$p_12     # 52o

        fs      $yc_4,$yc_4,$q_5                        # 53e
        lnop                                            # 53o pairing

        fs      $xa_4,$xa_4,$q                          # 54e
        lqd     $q_7,336($a_shear)                      # 54o

        fs      $xb_4,$xb_4,$q                          # 55e
        shufb   $yc_2,$vertex_c_2,$vertex_c_2,$p_2      # 55o

        fnms    $xc_5,$slope,$zc_4,$xc_5                # 56e
        shufb   $zb_2,$vertex_b_2,$vertex_b_2,$p        # 56o

        fs      $yc_6,$yc_6,$q_12                       # 57e
        shufb   $xb_2,$vertex_b_2,$vertex_b_2,$p_3      # 57o

        fs      $za_5,$za_5,$q_4                        # 58e
        shufb   $xa_5,$vertex_a_2,$vertex_a_2,$p_10     # 58o

            cgt     $control_11,$n_best,$n_7            # 59e 0 < t < t_best
        shufb   $zc_2,$vertex_c_2,$vertex_c_2,$p_4      # 59o

        fs      $yc_3,$yc_2,$q_2                        # 60e
        lnop                                            # 60o pairing

            andc    $control_12,$control_11,$outside_3  # 61e
        shufb   $ya_3,$vertex_a_2,$vertex_a_2,$p_6      # 61o

        fs      $zb_4,$zb_2,$q_4                        # 62e
        shufb   $za_4,$vertex_a_2,$vertex_a_2,$p_9      # 62o

        fs      $xb_2,$xb_2,$q_3                        # 63e
        shufb   $xa_2,$vertex_a_2,$vertex_a_2,$p_3      # 63o

        fs      $zc_3,$zc_2,$q_7                        # 64e
        shufb   $xc_4,$vertex_c_2,$vertex_c_2,$p_7      # 64o

        fs      $zb_3,$zb_3,$q_7                        # 65e
        lqd     $slope_3,464($a_shear)                  # 65o

        fs      $ya_4,$ya_3,$q_5                        # 66e
        shufb   $zb_5,$vertex_b_2,$vertex_b_2,$p_8      # 66o

        fs      $za_4,$za_4,$q_9                        # 67e
        shufb   $za_2,$vertex_a_2,$vertex_a_2,$p_4      # 67o

        fs      $xa_2,$xa_2,$q_3                        # 68e
        lqd     $slope_2,432($a_shear)                  # 68o

        fs      $xc_6,$xc_4,$q                          # 69e
        shufb   $xc_7,$vertex_c_2,$vertex_c_2,$p_10     # 69o

        fs      $xa_6,$xa_5,$q_8                        # 70e
        shufb   $ya_5,$vertex_a_2,$vertex_a_2,$p_11     # 70o

        fnms    $yc_3,$slope_3,$zc_3,$yc_3              # 71e
        shufb   $ya_6,$vertex_a_2,$vertex_a_2,$p_12     # 71o

        fs      $zb_5,$zb_5,$q_10                       # 72e
        shufb   $zc_6,$vertex_c_2,$vertex_c_2,$p        # 72o

        fs      $za_2,$za_2,$q_7                        # 73e
        shufb   $zc_5,$vertex_c_2,$vertex_c_2,$p_8      # 73o

        fnms    $xb_6,$slope_2,$zb_4,$xb_2              # 74e
        shufb   $zb_6,$vertex_b_2,$vertex_b_2,$p_9      # 74o

        fnms    $xa_2,$slope_2,$za_5,$xa_2              # 75e
        lqd     $slope_4,400($a_shear)                  # 75o

        fs      $xc_8,$xc_7,$q_8                        # 76e
        lqd     $slope_5,480($a_shear)                  # 76o

        fs      $ya_7,$ya_5,$q_11                       # 77e
        lqd     $slope_7,496($a_shear)                  # 77o

        fs      $ya_6,$ya_6,$q_12                       # 78e
            rotqbii $control_6,$control_6,1             # 78o

        fs      $zc_8,$zc_6,$q_4                        # 79e
        shufb   $yb,$vertex_b_2,$vertex_b_2,$p_12       # 79o

        fs      $zc_7,$zc_5,$q_10                       # 80e
        lqd     $slope_6,448($a_shear)                  # 80o

        fnms    $xb_7,$slope_4,$zb_3,$xb_4              # 81e
        lnop                                            # 81o pairing

        fnms    $ya_4,$slope_5,$za_4,$ya_4              # 82e
            gb      $control,$control_6                 # 82o

        fs      $zb_6,$zb_6,$q_9                        # 83e
            stqd    $best_17,624($a_rays)               # 83o

        fnms    $ya_8,$slope_3,$za_2,$ya_2              # 84e
        lqd     $slope_8,384($a_shear)                  # 84o

        fnms    $yc_9,$slope_7,$zc_8,$yc_6              # 85e
            lqd     $best_2,592($a_rays)                # 85o

        fnms    $yb_4,$slope_6,$zb_5,$yb_4              # 86e
            shlqbii $control,$control,4                 # 86o

        fnms    $ya_6,$slope_7,$za_5,$ya_6              # 87e
        lnop                                            # 87o pairing

        fnms    $ya_7,$slope_6,$za_3,$ya_7              # 88e
            lqd     $best_3,464($a_rays)                # 88o

        fnms    $xc_2,$slope_2,$zc_8,$xc_2              # 89e
            lqd     $best_4,528($a_rays)                # 89o

        fnms    $xb_5,$slope_8,$zb_5,$xb_5              # 90e
            lqx     $control,$control,$a_controls       # 90o

        fnms    $yc_8,$slope_6,$zc_7,$yc_5              # 91e
        fnms    $xc_8,$slope_8,$zc_7,$xc_8              # 92e

        fnms    $yb_6,$slope_5,$zb_6,$yb_3              # 93e
        fnms    $xb_3,$slope,$zb_6,$xb_3                # 94e

        fm      $p_14,$ya_6,$xc_2                       # 95e
        lnop                                            # 95o pairing

        fnms    $xa_9,$slope_8,$za_3,$xa_6              # 96e
            shufb   $best_7,$best_3,$object,$control    # 96o

        fm      $p_18,$yc_8,$xb_5                       # 97e
            shufb   $best_6,$best_4,$u,$control         # 97o

        fs      $yb,$yb,$q_12                           # 98e
            shufb   $best_5,$best_2,$v_7,$control       # 98o

        fnms    $xa_8,$slope_4,$za_2,$xa_4              # 99e
        lnop                                            # 99o pairing

        fm      $p_16,$yc_9,$xb_6                       # 100e
            stqd    $best_7,464($a_rays)                # 100o

        fm      $p_7,$ya_7,$xc_8                        # 101e
            stqd    $best_6,528($a_rays)                # 101o

        fms     $v_3,$xa_2,$yc_9,$p_14                  # 102e
            stqd    $best_5,592($a_rays)                # 102o

        fnms    $yb_5,$slope_3,$zb_3,$yb_2              # 103e
        lnop                                            # 103o pairing

        fms     $u_5,$xc_8,$yb_4,$p_18                  # 104e
            shufb   $n_best+1,$n_best+1,$n_2,$control   # 104o

        fnms    $yc_7,$slope_5,$zc_4,$yc_4              # 105e
        fnms    $xc_6,$slope_4,$zc_3,$xc_6              # 106e

        fnms    $yb,$slope_7,$zb_4,$yb                  # 107e
        fm      $p_13,$yc_3,$xb_7                       # 108e

        fnms    $xa_7,$slope,$za_4,$xa_3                # 109e
        fm      $p_10,$ya_4,$xc_5                       # 110e

        fm      $p_11,$yc_7,$xb_3                       # 111e
        fm      $p_5,$ya_8,$xc_6                        # 112e

        fms     $q_16,$ya_6,$xc_2,$p_14                 # 113e
        fms     $q_13,$yc_3,$xb_7,$p_13                 # 114e

        fm      $p_19,$yb_4,$xa_9                       # 115e
        fm      $p_15,$yb,$xa_2                         # 116e

        fms     $q_15,$yc_7,$xb_3,$p_11                 # 117e
        fms     $q_20,$yc_8,$xb_5,$p_18                 # 118e

        fms     $q_7,$ya_4,$xc_5,$p_10                  # 119e
        fms     $q_14,$ya_8,$xc_6,$p_5                  # 120e

        fms     $v_2,$xa_8,$yc_3,$p_5                   # 121e
        fm      $p_5,$yb_6,$xa_7                        # 122e

        fms     $v_4,$xa_7,$yc_7,$p_10                  # 123e
        fms     $u_2,$xc_5,$yb_6,$p_11                  # 124e

        fs      $v_5,$v_3,$q_16                         # 125e
        fms     $u,$xc_2,$yb,$p_16                      # 126e

        fs      $u_7,$u_5,$q_20                         # 127e
        fms     $q_17,$yb_6,$xa_7,$p_5                  # 128e

        fms     $w_2,$xb_3,$ya_4,$p_5                   # 129e
        fs      $v_4,$v_4,$q_7                          # 130e

        fs      $u_2,$u_2,$q_15                         # 131e
        fms     $w_3,$xb_6,$ya_6,$p_15                  # 132e

        fm      $p_17,$yb_5,$xa_8                       # 133e
        fms     $u_3,$xc_6,$yb_5,$p_13                  # 134e

        fs      $w_2,$w_2,$q_17                         # 135e
        fms     $w_5,$xb_5,$ya_7,$p_19                  # 136e

        fs      $v_2,$v_2,$q_14                         # 137e
        fms     $q_8,$ya_7,$xc_8,$p_7                   # 138e

        fa      $control,$u_2,$v_4                      # 139e
        fms     $q_21,$yb,$xa_2,$p_15                   # 140e

        fms     $q_19,$yb_5,$xa_8,$p_17                 # 141e
        lnop                                            # 141o pairing

        fms     $q_18,$yc_9,$xb_6,$p_16                 # 142e
        lqd     $slope_11,560($a_shear)                 # 142o

        fms     $q_11,$yb_4,$xa_9,$p_19                 # 143e
        hbrr    next_triangle_back,next_triangle        # 143o hint

        fms     $w_4,$xb_7,$ya_8,$p_17                  # 144e
        lqd     $slope_9,528($a_shear)                  # 144o

        fs      $u_4,$u_3,$q_13                         # 145e
        lqd     $slope_10,544($a_shear)                 # 145o

        fms     $v_6,$xa_9,$yc_8,$p_7                   # 146e
            lqd     $best_11,512($a_rays)               # 146o

        fs      $w_7,$w_3,$q_21                         # 147e
            lqd     $best_10,496($a_rays)               # 147o

        fs      $u_6,$u,$q_18                           # 148e
            lqd     $best_15,560($a_rays)               # 148o

        fs      $w_6,$w_5,$q_11                         # 149e
            rotqbii $control_3,$control_12,1            # 149o

        fs      $w,$w_4,$q_19                           # 150e
            lqd     $best_5,576($a_rays)                # 150o

        fa      $control_2,$u_4,$v_2                    # 151e
            rotqbii $control_13,$control_10,1           # 151o

        fa      $control,$control,$w_2                  # 152e
            lqd     $best_13,480($a_rays)               # 152o

        fs      $v_6,$v_6,$q_8                          # 153e
            gb      $control_14,$control_3              # 153o

        fa      $control_3,$u_6,$v_5                    # 154e
            rotqbii $control_8,$control_8,1             # 154o

        ai      $count,$count,-1                        # 155e
            gb      $control_13,$control_13             # 155o

        ai      $a_triangle,$a_triangle,48              # 156e
            lqd     $best_14,608($a_rays)               # 156o

        fa      $control_2,$control_2,$w                # 157e
            lqd     $best_9,624($a_rays)                # 157o

        nop     $127                                    # 158e pairing
        frest   $t_y_2,$control                         # 158o

        fa      $control_4,$u_7,$v_6                    # 159e
            shlqbii $control_14,$control_14,4           # 159o

        fa      $control_3,$control_3,$w_7              # 160e
            shlqbii $control_13,$control_13,4           # 160o

            nop     $127                                # 161e pairing
            gb      $control_8,$control_8               # 161o

        fi      $t_y_2,$control,$t_y_2                  # 162e
            lqd     $best_12,448($a_rays)               # 162o

        frest   $t_y_3,$control_2                       # 163o
            lqx     $control_14,$control_14,$a_controls # 164o

        fa      $control_4,$control_4,$w_6              # 165e
            shlqbii $control_8,$control_8,4             # 165o

        nop     $127                                    # 166e pairing
        frest   $t_y_4,$control_3                       # 166o

        fi      $t_y_3,$control_2,$t_y_3                # 167e
            lqd     $best_8,544($a_rays)                # 167o

            nop     $127                                # 168e pairing
            lqx     $control_15,$control_13,$a_controls # 168o

        fnms    $t_e_2,$control,$t_y_2,$k_above_one     # 169e
            lqx     $control,$control_8,$a_controls     # 169o

        fi      $t_y_5,$control_3,$t_y_4                # 170e
            shufb   $best_5,$best_5,$v_9,$control_14    # 170o

        frest   $t_y_6,$control_4                       # 171o
            shufb   $best_12,$best_12,$object,$control_14 # 172o

            nop     $127                                # 173e pairing
            shufb   $n_best,$n_best,$n_7,$control_14    # 173o

        fnms    $t_e_3,$control_2,$t_y_3,$k_above_one   # 174e
            shufb   $best_16,$best_11,$u_10,$control_14 # 174o

        fma     $inverse_2,$t_e_2,$t_y_2,$t_y_2         # 175e
            shufb   $signs,$signs,$n,$control           # 175o

        fi      $t_y_6,$control_4,$t_y_6                # 176e
            stqd    $best_5,576($a_rays)                # 176o

            nop     $127                                # 177e pairing
            shufb   $best_5,$best_13,$object,$control   # 177o

        fnms    $t_e_4,$control_3,$t_y_5,$k_above_one   # 178e
            shufb   $best_11,$best_10,$object,$control_15 # 178o

            ai      $object,$object,1                   # 179e
            shufb   $best_10,$best_14,$v,$control       # 179o

        fma     $inverse,$t_e_3,$t_y_3,$t_y_3           # 180e
            shufb   $best_18,$best_8,$u_8,$control      # 180o

        fm      $w_8,$w_2,$inverse_2                    # 181e
            stqd    $best_5,480($a_rays)                # 181o

        fm      $u_8,$u_2,$inverse_2                    # 182e
            shufb   $signs+1,$signs+1,$n_5,$control_15  # 182o

        fnms    $t_e,$control_4,$t_y_6,$k_above_one     # 183e
            shufb   $best_17,$best_9,$v_8,$control_15   # 183o

        fma     $inverse_3,$t_e_4,$t_y_5,$t_y_5         # 184e
next_triangle_back:
        brnz    $count,next_triangle                    # 184o

next_triangle_drain:
        fm      $u,$u_4,$inverse                        # 0e
        stqd    $best_12,448($a_rays)                   # 0o

        fm      $v_7,$v_2,$inverse                      # 1e
        stqd    $best_11,496($a_rays)                   # 1o

        fma     $inverse_4,$t_e,$t_y_6,$t_y_6           # 2e
        stqd    $best_18,544($a_rays)                   # 2o

        fm      $w,$w,$inverse                          # 3e
        stqd    $best_16,512($a_rays)                   # 3o

        fm      $u_11,$u_6,$inverse_3                   # 4e
        stqd    $best_10,608($a_rays)                   # 4o

        fm      $v,$v_4,$inverse_2                      # 5e
        lqd     $slope_12,512($a_shear)                 # 5o

        fm      $n_2,$u,$za_2                           # 6e
        shufb   $best,$best_15,$u_9,$control_15         # 6o

        fm      $n,$u_8,$za_4                           # 7e
        hbr     isect_triangles_r16_return,$lr          # 7o hint

        fm      $u_10,$u_7,$inverse_4                   # 8e
        fm      $v_9,$v_6,$inverse_4                    # 9e

        fm      $v_10,$v_5,$inverse_3                   # 10e
        stqd    $best,560($a_rays)                      # 10o

        fm      $n_5,$u_11,$za_5                        # 11e
        stqd    $best_17,624($a_rays)                   # 11o

        fma     $n_2,$v_7,$zb_3,$n_2                    # 12e
        lqd     $best_3,464($a_rays)                    # 12o

        fm      $w_10,$w_6,$inverse_4                   # 13e
        lqd     $best_4,528($a_rays)                    # 13o

        fm      $n_4,$u_10,$za_3                        # 14e
        lqd     $best_19,592($a_rays)                   # 14o

        fma     $n,$v,$zb_6,$n                          # 15e
        fm      $w_11,$w_7,$inverse_3                   # 16e

        fma     $n_3,$v_10,$zb_4,$n_5                   # 17e
        fma     $n_2,$w,$zc_3,$n_2                      # 18e

        or      $outside_6,$u,$v_7                      # 19e
        fma     $n_4,$v_9,$zb_5,$n_4                    # 20e

        or      $outside_5,$outside_6,$w                # 21e
        fma     $n,$w_8,$zc_4,$n                        # 22e

        fma     $n_5,$w_11,$zc_8,$n_3                   # 23e
        fm      $n_2,$n_2,$slope_9                      # 24e

        or      $outside_3,$u_10,$v_9                   # 25e
        fma     $n_8,$w_10,$zc_7,$n_4                   # 26e

        or      $outside,$u_8,$v                        # 27e
        fm      $n,$n,$slope_10                         # 28e

        fm      $n_5,$n_5,$slope_11                     # 29e
        cgt     $control_16,$n_best+1,$n_2              # 30e 0 < t < t_best

        or      $outside_3,$outside_3,$w_10             # 31e
        andc    $control_6,$control_16,$outside_5       # 32e

        fm      $n_7,$n_8,$slope_12                     # 33e
        lnop                                            # 33o pairing

        or      $outside_2,$u_11,$v_10                  # 34e
        rotqbii $control_6,$control_6,1                 # 34o

        or      $outside,$outside,$w_8                  # 35e
        cgt     $control_7,$signs,$n                    # 36e 0 < t < t_best

        or      $outside_2,$outside_2,$w_11             # 37e
        lnop                                            # 37o pairing

        andc    $control_8,$control_7,$outside          # 38e
        gb      $control,$control_6                     # 38o

        cgt     $control_11,$n_best,$n_7                # 39e 0 < t < t_best
        lnop                                            # 39o pairing

        cgt     $control_17,$signs+1,$n_5               # 40e 0 < t < t_best
        rotqbii $control_8,$control_8,1                 # 40o

        andc    $control_12,$control_11,$outside_3      # 41e
        lnop                                            # 41o pairing

        andc    $control_10,$control_17,$outside_2      # 42e
        shlqbii $control,$control,4                     # 42o

        ai      $object_2,$object,1                     # 43e
        rotqbii $control_3,$control_12,1                # 43o

        rotqbii $control_17,$control_10,1               # 44o
        gb      $control_8,$control_8                   # 45o

        lqx     $control,$control,$a_controls           # 46o
        gb      $control_14,$control_3                  # 47o

        gb      $control_17,$control_17                 # 48o
        shlqbii $control_8,$control_8,4                 # 49o

        shlqbii $control_14,$control_14,4               # 51o
        shufb   $best_7,$best_3,$object,$control        # 52o

        shufb   $best_6,$best_4,$u,$control             # 53o
        shufb   $best_5,$best_19,$v_7,$control          # 54o

        shlqbii $control_18,$control_17,4               # 55o
        stqd    $best_7,464($a_rays)                    # 56o

        stqd    $best_6,528($a_rays)                    # 57o
        stqd    $best_5,592($a_rays)                    # 58o

        lqd     $best_5,576($a_rays)                    # 59o
        lqx     $control_14,$control_14,$a_controls     # 60o

        lqd     $best_13,480($a_rays)                   # 61o
        lqx     $control_17,$control_8,$a_controls      # 62o

        lqd     $best_12,448($a_rays)                   # 63o
        lqd     $best_10,496($a_rays)                   # 64o

        lqx     $control_15,$control_18,$a_controls     # 65o
        lqd     $best_8,544($a_rays)                    # 66o

        lqd     $best_11,512($a_rays)                   # 67o
        lqd     $best_14,608($a_rays)                   # 68o

        shufb   $best_5,$best_5,$v_9,$control_14        # 69o
        lqd     $best_15,560($a_rays)                   # 70o

        shufb   $best_19,$best_13,$object,$control_17   # 71o
        lqd     $best_9,624($a_rays)                    # 72o

        shufb   $best_12,$best_12,$object,$control_14   # 73o
        shufb   $best_20,$best_10,$object,$control_15   # 74o

        stqd    $best_5,576($a_rays)                    # 75o
        shufb   $best_5,$best_8,$u_8,$control_17        # 76o

        shufb   $best_21,$best_11,$u_10,$control_14     # 77o
        stqd    $best_19,480($a_rays)                   # 78o

        shufb   $best_10,$best_14,$v,$control_17        # 79o
        stqd    $best_12,448($a_rays)                   # 80o

        shufb   $n_best+1,$n_best+1,$n_2,$control       # 81o
        shufb   $n_best,$n_best,$n_7,$control_14        # 82o

        shufb   $signs,$signs,$n,$control_17            # 83o
        shufb   $signs+1,$signs+1,$n_5,$control_15      # 84o

        xor     $n_best+1,$n_best+1,$k_sign             # 85e
        stqd    $best_20,496($a_rays)                   # 85o

        xor     $n_best,$n_best,$k_sign                 # 86e
        shufb   $best,$best_15,$u_11,$control_15        # 86o

        xor     $signs,$signs,$k_sign                   # 87e
        shufb   $best_17,$best_9,$v_10,$control_15      # 87o

        xor     $signs+1,$signs+1,$k_sign               # 88e
        stqd    $best_5,544($a_rays)                    # 88o

        stqd    $best_21,512($a_rays)                   # 89o
        stqd    $best_10,608($a_rays)                   # 90o

        stqd    $best,560($a_rays)                      # 91o
        stqd    $best_17,624($a_rays)                   # 92o

        stqd    $n_best,384($a_rays)                    # 93o
        stqd    $n_best+1,400($a_rays)                  # 94o

        stqd    $signs,416($a_rays)                     # 95o
        stqd    $signs+1,432($a_rays)                   # 96o

        nop     $127                                    # 97e pairing
isect_triangles_r16_return:
        bi      $lr                                     # 97o

next_triangle_short:
        ai      $count,$count,-1                        # 0e
        lqd     $q,208($a_shear)                        # 0o

        lqd     $p,144($a_shear)                        # 1o
        lqd     $q_19,288($a_shear)                     # 2o

        lqd     $vertex_b,16($a_triangle)               # 3o
        lqd     $q_22,256($a_shear)                     # 4o

        lqd     $q_23,320($a_shear)                     # 5o
        lqd     $q_24,272($a_shear)                     # 6o

        lqd     $p_20,96($a_shear)                      # 7o
        lqd     $q_25,352($a_shear)                     # 8o

        lqd     $p_21,0($a_shear)                       # 9o
        lqd     $vertex_a_3,0($a_triangle)              # 10o

        nop     $127                                    # 11e pairing
        lqd     $vertex_c_3,32($a_triangle)             # 11o

        ai      $a_triangle,$a_triangle,48              # 12e
        lqd     $p_22,128($a_shear)                     # 12o

        lqd     $q_9,224($a_shear)                      # 13o
        lqd     $q_21,192($a_shear)                     # 14o

        shufb   $xb_7,$vertex_b,$vertex_b,$p_21         # 15o
        shufb   $ya_9,$vertex_a_3,$vertex_a_3,$p_20     # 16o

        shufb   $yc,$vertex_c_3,$vertex_c_3,$p_20       # 17o
        shufb   $za_6,$vertex_a_3,$vertex_a_3,$p_22     # 18o

        nop     $127                                    # 19e pairing
        shufb   $zc_9,$vertex_c_3,$vertex_c_3,$p_22     # 19o

        fs      $xb_7,$xb_7,$q_21                       # 20e
        shufb   $zc_10,$vertex_c_3,$vertex_c_3,$p       # 20o

        fs      $yc,$yc,$q_19                           # 21e
        shufb   $zb_7,$vertex_b,$vertex_b,$p_22         # 21o

        fs      $za_6,$za_6,$q_23                       # 22e
        lqd     $slope_13,448($a_shear)                 # 22o

        fs      $zc_9,$zc_9,$q_23                       # 23e
        lqd     $p_23,80($a_shear)                      # 23o

        fs      $ya_9,$ya_9,$q_19                       # 24e
        lqd     $slope_14,400($a_shear)                 # 24o

        fs      $zb_8,$zb_7,$q_23                       # 25e
        lqd     $p_22,160($a_shear)                     # 25o

        shufb   $xa_10,$vertex_a_3,$vertex_a_3,$p_21    # 26o
        lqd     $p_24,16($a_shear)                      # 27o

        lqd     $slope_5,464($a_shear)                  # 28o
        shufb   $yc_10,$vertex_c_3,$vertex_c_3,$p_23    # 29o

        fs      $xa_10,$xa_10,$q_21                     # 30e
        lqd     $p_25,32($a_shear)                      # 30o

        shufb   $zb_9,$vertex_b,$vertex_b,$p_22         # 31o
        lqd     $p_26,64($a_shear)                      # 32o

        fs      $yc_10,$yc_10,$q_24                     # 33e
        shufb   $xa_11,$vertex_a_3,$vertex_a_3,$p_24    # 33o

        nop     $127                                    # 34e pairing
        lqd     $q_26,336($a_shear)                     # 34o

        fs      $zb_9,$zb_9,$q_25                       # 35e
        shufb   $za_7,$vertex_a_3,$vertex_a_3,$p_22     # 35o

        nop     $127                                    # 36e pairing
        shufb   $xb_8,$vertex_b,$vertex_b,$p_25         # 36o

        fs      $xa_11,$xa_11,$q                        # 37e
        shufb   $xc_2,$vertex_c_3,$vertex_c_3,$p_25     # 37o

        nop     $127                                    # 38e pairing
        shufb   $ya_10,$vertex_a_3,$vertex_a_3,$p_26    # 38o

        fs      $za_7,$za_7,$q_25                       # 39e
        shufb   $zb_10,$vertex_b,$vertex_b,$p           # 39o

        fs      $xb_8,$xb_8,$q_9                        # 40e
        shufb   $yb_7,$vertex_b,$vertex_b,$p_26         # 40o

        fs      $xc_2,$xc_2,$q_9                        # 41e
        lqd     $slope_15,384($a_shear)                 # 41o

        fs      $ya_10,$ya_10,$q_22                     # 42e
        shufb   $xb_9,$vertex_b,$vertex_b,$p_24         # 42o

        fs      $zb_10,$zb_10,$q_26                     # 43e
        shufb   $zc_11,$vertex_c_3,$vertex_c_3,$p_22    # 43o

        fs      $zc_10,$zc_10,$q_26                     # 44e
        lqd     $slope_16,416($a_shear)                 # 44o

        fs      $yb_7,$yb_7,$q_22                       # 45e
        shufb   $yc_11,$vertex_c_3,$vertex_c_3,$p_26    # 45o

        fs      $xb_9,$xb_9,$q                          # 46e
        lqd     $q_27,368($a_shear)                     # 46o

        fnms    $xb_7,$slope_15,$zb_8,$xb_7             # 47e
        shufb   $xc_9,$vertex_c_3,$vertex_c_3,$p_21     # 47o

        fnms    $ya_10,$slope_13,$za_6,$ya_10           # 48e
        shufb   $xc_10,$vertex_c_3,$vertex_c_3,$p_24    # 48o

        fs      $yc_12,$yc_11,$q_22                     # 49e
        shufb   $za_8,$vertex_a_3,$vertex_a_3,$p        # 49o

        fnms    $yc_10,$slope_5,$zc_10,$yc_10           # 50e
        lqd     $p_26,112($a_shear)                     # 50o

        fs      $xc_9,$xc_9,$q_21                       # 51e
        shufb   $ya_11,$vertex_a_3,$vertex_a_3,$p_23    # 51o

        fs      $xc_6,$xc_10,$q                         # 52e
        shufb   $yb_8,$vertex_b,$vertex_b,$p_23         # 52o

        fs      $za_8,$za_8,$q_26                       # 53e
        lqd     $p_24,48($a_shear)                      # 53o

        fs      $zc_12,$zc_11,$q_25                     # 54e
        shufb   $xa_12,$vertex_a_3,$vertex_a_3,$p_25    # 54o

        fs      $ya_11,$ya_11,$q_24                     # 55e
        lqd     $slope_17,480($a_shear)                 # 55o

        fnms    $xa_10,$slope_15,$za_6,$xa_10           # 56e
        shufb   $ya_12,$vertex_a_3,$vertex_a_3,$p_26    # 56o

        fnms    $xc_9,$slope_15,$zc_9,$xc_9             # 57e
        shufb   $yc_13,$vertex_c_3,$vertex_c_3,$p_26    # 57o

        fnms    $xc_6,$slope_14,$zc_10,$xc_6            # 58e
        lqd     $slope_2,496($a_shear)                  # 58o

        fs      $xa_12,$xa_12,$q_9                      # 59e
        lqd     $p_27,176($a_shear)                     # 59o

        fnms    $xb_8,$slope_16,$zb_9,$xb_8             # 60e
        lqd     $slope_18,432($a_shear)                 # 60o

        fnms    $ya_9,$slope_17,$za_7,$ya_9             # 61e
        shufb   $yb_9,$vertex_b,$vertex_b,$p_20         # 61o

        fnms    $yc,$slope_17,$zc_12,$yc                # 62e
        shufb   $xa_13,$vertex_a_3,$vertex_a_3,$p_24    # 62o

        fnms    $ya_11,$slope_5,$za_8,$ya_11            # 63e
        lqd     $q_28,304($a_shear)                     # 63o

        fnms    $yc_12,$slope_13,$zc_9,$yc_12           # 64e
        shufb   $xc_11,$vertex_c_3,$vertex_c_3,$p_24    # 64o

        fs      $yb_5,$yb_9,$q_19                       # 65e
        shufb   $za_9,$vertex_a_3,$vertex_a_3,$p_27     # 65o

        fnms    $xb_10,$slope_14,$zb_10,$xb_9           # 66e
        shufb   $zc_13,$vertex_c_3,$vertex_c_3,$p_27    # 66o

        fm      $p_28,$ya_10,$xc_9                      # 67e
        lqd     $q_29,240($a_shear)                     # 67o

        fm      $p_16,$yc,$xb_8                         # 68e
        shufb   $xb_11,$vertex_b,$vertex_b,$p_24        # 68o

        fs      $yc_13,$yc_13,$q_28                     # 69e
        shufb   $zb_11,$vertex_b,$vertex_b,$p_27        # 69o

        fm      $p_7,$yc_12,$xb_7                       # 70e
        shufb   $yb_10,$vertex_b,$vertex_b,$p_26        # 70o

        fnms    $yb_5,$slope_17,$zb_9,$yb_5             # 71e
        lqd     $slope_17,512($a_shear)                 # 71o

        fs      $zc_13,$zc_13,$q_27                     # 72e
        lqd     $slope_19,528($a_shear)                 # 72o

        fs      $xc_11,$xc_11,$q_29                     # 73e
        lqd     $slope_20,560($a_shear)                 # 73o

        fm      $p_29,$yc_10,$xb_10                     # 74e
        lqd     $slope_21,544($a_shear)                 # 74o

        fs      $yb_11,$yb_8,$q_24                      # 75e
        lqd     $best_22,544($a_rays)                   # 75o

        fms     $q_30,$yc_12,$xb_7,$p_7                 # 76e
        lqd     $best_3,608($a_rays)                    # 76o

        fnms    $xa_14,$slope_14,$za_8,$xa_11           # 77e
        lqd     $best_23,480($a_rays)                   # 77o

        fnms    $yc_13,$slope_2,$zc_13,$yc_13           # 78e
        lqd     $best_24,592($a_rays)                   # 78o

        fnms    $xc_2,$slope_16,$zc_12,$xc_2            # 79e
        lqd     $best_25,512($a_rays)                   # 79o

        fms     $q_7,$yc,$xb_8,$p_16                    # 80e
        lqd     $best_26,576($a_rays)                   # 80o

        fnms    $yb_12,$slope_13,$zb_8,$yb_7            # 81e
        lqd     $best_27,528($a_rays)                   # 81o

        fs      $xa_13,$xa_13,$q_29                     # 82e
        lqd     $best_28,448($a_rays)                   # 82o

        fnms    $yb_11,$slope_5,$zb_10,$yb_11           # 83e
        lqd     $best_29,496($a_rays)                   # 83o

        fnms    $xa_12,$slope_16,$za_7,$xa_12           # 84e
        lqd     $best_30,464($a_rays)                   # 84o

        fm      $p_30,$ya_9,$xc_2                       # 85e
        lqd     $best_31,624($a_rays)                   # 85o

        fms     $u_12,$xc_2,$yb_5,$p_16                 # 86e
        lqd     $best_32,560($a_rays)                   # 86o

        fms     $u_13,$xc_9,$yb_12,$p_7                 # 87e
        fs      $xb_11,$xb_11,$q_29                     # 88e

        fm      $p_31,$yb_11,$xa_14                     # 89e
        fm      $p_32,$yb_5,$xa_12                      # 90e

        fms     $q_31,$ya_9,$xc_2,$p_30                 # 91e
        fs      $u_12,$u_12,$q_7                        # 92e

        fms     $q_32,$ya_10,$xc_9,$p_28                # 93e
        fs      $u_13,$u_13,$q_30                       # 94e

        fms     $q_30,$yb_11,$xa_14,$p_31               # 95e
        fm      $p_33,$yb_12,$xa_10                     # 96e

        fm      $p_34,$ya_11,$xc_6                      # 97e
        fs      $za_9,$za_9,$q_27                       # 98e

        fms     $w_10,$xb_8,$ya_9,$p_32                 # 99e
        fs      $zb_11,$zb_11,$q_27                     # 100e

        fms     $q_33,$yc_10,$xb_10,$p_29               # 101e
        fnms    $xc_12,$slope_18,$zc_13,$xc_11          # 102e

        fs      $ya_12,$ya_12,$q_28                     # 103e
        fs      $yb_10,$yb_10,$q_28                     # 104e

        fms     $q_34,$yb_12,$xa_10,$p_33               # 105e
        fnms    $xb_11,$slope_18,$zb_11,$xb_11          # 106e

        fms     $v_11,$xa_14,$yc_10,$p_34               # 107e
        fms     $v_12,$xa_12,$yc,$p_30                  # 108e

        fnms    $ya_13,$slope_2,$za_9,$ya_12            # 109e
        fnms    $yb_10,$slope_2,$zb_11,$yb_10           # 110e

        fms     $u_14,$xc_6,$yb_11,$p_29                # 111e
        fm      $p_5,$yc_13,$xb_11                      # 112e

        fms     $w_12,$xb_10,$ya_11,$p_31               # 113e
        fms     $v_13,$xa_10,$yc_12,$p_28               # 114e

        fm      $p_35,$ya_13,$xc_12                     # 115e
        fms     $q,$ya_11,$xc_6,$p_34                   # 116e

        fms     $w_7,$xb_7,$ya_10,$p_33                 # 117e
        fms     $u_4,$xc_12,$yb_10,$p_5                 # 118e

        fs      $u_14,$u_14,$q_33                       # 119e
        fs      $v_13,$v_13,$q_32                       # 120e

        fms     $q_32,$yc_13,$xb_11,$p_5                # 121e
        fs      $v_14,$v_11,$q                          # 122e

        fs      $v_12,$v_12,$q_31                       # 123e
        fs      $w_7,$w_7,$q_34                         # 124e

        fms     $q_19,$yb_5,$xa_12,$p_32                # 125e
        fa      $control,$u_13,$v_13                    # 126e

        fs      $w_12,$w_12,$q_30                       # 127e
        fnms    $xa_12,$slope_18,$za_9,$xa_13           # 128e

        fa      $control_19,$u_12,$v_12                 # 129e
        fa      $control_20,$u_14,$v_14                 # 130e

        fs      $w_13,$w_10,$q_19                       # 131e
        fa      $control,$control,$w_7                  # 132e

        fms     $q_35,$ya_13,$xc_12,$p_35               # 133e
        fm      $p_17,$yb_10,$xa_12                     # 134e

        fms     $v_15,$xa_12,$yc_13,$p_35               # 135e
        fa      $control_20,$control_20,$w_12           # 136e

        fa      $control_19,$control_19,$w_13           # 137e
        lnop                                            # 137o pairing

        fs      $u_10,$u_4,$q_32                        # 138e
        frest   $t_y_7,$control                         # 138o

        fms     $w_6,$xb_11,$ya_13,$p_17                # 140e
        fms     $q_8,$yb_10,$xa_12,$p_17                # 141e

        fi      $t_y_8,$control,$t_y_7                  # 142e
        frest   $t_y_7,$control_20                      # 142o

        frest   $t_y_9,$control_19                      # 143o
        fs      $v_16,$v_15,$q_35                       # 144e

        fi      $t_y_7,$control_20,$t_y_7               # 146e
        fi      $t_y_10,$control_19,$t_y_9              # 147e

        fs      $w_14,$w_6,$q_8                         # 149e
        fa      $control_21,$u_10,$v_16                 # 150e

        fnms    $t_e_5,$control,$t_y_8,$k_above_one     # 151e
        fnms    $t_e_6,$control_20,$t_y_7,$k_above_one  # 153e

        fnms    $t_e_7,$control_19,$t_y_10,$k_above_one # 154e
        fa      $control_21,$control_21,$w_14           # 156e

        fma     $inverse_3,$t_e_5,$t_y_8,$t_y_8         # 157e
        fma     $inverse_5,$t_e_6,$t_y_7,$t_y_7         # 159e

        fma     $inverse,$t_e_7,$t_y_10,$t_y_10         # 160e
        frest   $t_y_11,$control_21                     # 162o

        fm      $v_13,$v_13,$inverse_3                  # 163e
        fm      $u_15,$u_13,$inverse_3                  # 164e

        fm      $u_14,$u_14,$inverse_5                  # 165e
        fi      $t_y_11,$control_21,$t_y_11             # 166e

        fm      $u_16,$u_12,$inverse                    # 168e
        fm      $v_12,$v_12,$inverse                    # 169e

        fm      $v_14,$v_14,$inverse_5                  # 170e
        fm      $w_12,$w_12,$inverse_5                  # 171e

        fm      $n_9,$u_15,$za_6                        # 172e
        fnms    $t_e_8,$control_21,$t_y_11,$k_above_one # 173e

        fm      $n_10,$u_14,$za_8                       # 174e
        fm      $n_11,$u_16,$za_7                       # 175e

        fm      $w_13,$w_13,$inverse                    # 176e
        fm      $w_2,$w_7,$inverse_3                    # 177e

        fma     $n_12,$v_13,$zb_8,$n_9                  # 178e
        fma     $inverse,$t_e_8,$t_y_11,$t_y_11         # 179e

        fma     $n_13,$v_14,$zb_10,$n_10                # 180e
        fma     $n_9,$v_12,$zb_9,$n_11                  # 181e

        or      $outside_7,$u_14,$v_14                  # 182e
        or      $outside_8,$u_15,$v_13                  # 183e

        fma     $n_12,$w_2,$zc_9,$n_12                  # 184e
        fm      $u_10,$u_10,$inverse                    # 185e

        fma     $n_13,$w_12,$zc_10,$n_13                # 186e
        fm      $v,$v_16,$inverse                       # 187e

        or      $outside_9,$outside_8,$w_2              # 188e
        or      $outside_10,$outside_7,$w_12            # 189e

        fm      $n_12,$n_12,$slope_17                   # 190e
        fm      $n_14,$u_10,$za_9                       # 191e

        fm      $n_13,$n_13,$slope_19                   # 192e
        fma     $n_2,$w_13,$zc_12,$n_9                  # 193e

        fm      $w_14,$w_14,$inverse                    # 194e
        or      $outside,$u_16,$v_12                    # 195e

        cgt     $control_22,$n_best,$n_12               # 196e 0 < t < t_best
        or      $outside,$outside,$w_13                 # 197e

        fma     $n_15,$v,$zb_11,$n_14                   # 198e
        fm      $n_14,$n_2,$slope_21                    # 199e

        andc    $control_23,$control_22,$outside_9      # 200e
        or      $outside_9,$u_10,$v                     # 201e

        cgt     $control_2,$n_best+1,$n_13              # 202e 0 < t < t_best
        rotqbii $control_23,$control_23,1               # 202o

        or      $outside_9,$outside_9,$w_14             # 203e
        fma     $n_15,$w_14,$zc_13,$n_15                # 204e

        andc    $control_14,$control_2,$outside_10      # 205e
        lnop                                            # 205o pairing

        cgt     $control_24,$signs,$n_14                # 206e 0 < t < t_best
        gb      $control_23,$control_23                 # 206o

        rotqbii $control_14,$control_14,1               # 207o
        andc    $control_24,$control_24,$outside        # 208e

        fm      $n_15,$n_15,$slope_20                   # 210e
        rotqbii $control_24,$control_24,1               # 210o

        shlqbii $control_23,$control_23,4               # 211o
        gb      $control_14,$control_14                 # 212o

        gb      $control_24,$control_24                 # 214o
        lqx     $control_23,$control_23,$a_controls     # 215o

        cgt     $control_25,$signs+1,$n_15              # 216e 0 < t < t_best
        shlqbii $control_14,$control_14,4               # 216o

        andc    $control_25,$control_25,$outside_9      # 218e
        shlqbii $control_24,$control_24,4               # 218o

        rotqbii $control_25,$control_25,1               # 220o
        lqx     $control_14,$control_14,$a_controls     # 221o

        lqx     $control_24,$control_24,$a_controls     # 222o
        shufb   $best_33,$best_28,$object,$control_23   # 223o

        shufb   $best_34,$best_26,$v_13,$control_23     # 224o
        gb      $control_25,$control_25                 # 225o

        shufb   $best_35,$best_25,$u_15,$control_23     # 226o
        stqd    $best_33,448($a_rays)                   # 227o

        shufb   $best_33,$best_30,$object,$control_14   # 228o
        shufb   $best_36,$best_24,$v_14,$control_14     # 229o

        stqd    $best_35,512($a_rays)                   # 230o
        shufb   $best_35,$best_3,$v_12,$control_24      # 231o

        stqd    $best_33,464($a_rays)                   # 232o
        stqd    $best_34,576($a_rays)                   # 233o

        shufb   $best_34,$best_23,$object,$control_24   # 234o
        shufb   $best_33,$best_22,$u_16,$control_24     # 235o

        shufb   $n_best+1,$n_best+1,$n_13,$control_14   # 236o
        stqd    $best_35,608($a_rays)                   # 237o

        stqd    $best_34,480($a_rays)                   # 238o
        stqd    $best_33,544($a_rays)                   # 239o

        shlqbii $control,$control_25,4                  # 240o
        stqd    $best_36,592($a_rays)                   # 241o

        shufb   $best_34,$best_27,$u_14,$control_14     # 242o
        shufb   $n_best,$n_best,$n_12,$control_23       # 243o

        lqx     $control,$control,$a_controls           # 244o
        shufb   $signs,$signs,$n_14,$control_24         # 245o

        stqd    $best_34,528($a_rays)                   # 246o
        hbrr    next_triangle_short_back,next_triangle_short # 247o hint

        shufb   $best,$best_31,$v,$control              # 250o
        shufb   $best_34,$best_32,$u_10,$control        # 251o

        nop     $127                                    # 252e pairing
        shufb   $best_37,$best_29,$object,$control      # 252o

        ai      $object,$object,1                       # 253e
        shufb   $signs+1,$signs+1,$n_15,$control        # 253o

        stqd    $best,624($a_rays)                      # 254o
        stqd    $best_34,560($a_rays)                   # 255o

        stqd    $best_37,496($a_rays)                   # 256o
next_triangle_short_back:
        brnz    $count,next_triangle_short              # 262o

        xor     $n_best,$n_best,$k_sign                 # 258e
        hbr     isect_triangles_r16_return_2,$lr        # 258o hint

        xor     $n_best+1,$n_best+1,$k_sign             # 259e
        lnop                                            # 259o pairing

        xor     $signs,$signs,$k_sign                   # 260e
        stqd    $n_best,384($a_rays)                    # 260o

        xor     $signs+1,$signs+1,$k_sign               # 261e
        stqd    $n_best+1,400($a_rays)                  # 261o

        stqd    $signs,416($a_rays)                     # 262o
        stqd    $signs+1,432($a_rays)                   # 263o

        nop     $127                                    # 264e pairing
isect_triangles_r16_return_2:
        bi      $lr                                     # 264o
endfunction isect_triangles_r16
