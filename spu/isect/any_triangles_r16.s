# any_triangles_r16   which of sixteen rays the triangles of an array stand in the way of
#   C       unsigned any_triangles_r16(const struct rays *, const struct shear *,
#                                      const struct triangle *, int count);
#   In      $3 rays, $4 what shear_r16 made of them, $5 triangles, $6 count (0 is none); pointers
#           16-aligned
#   Out     $3 a bit a ray, 0x8000 of the first: a triangle is hit with 0 < t < rays.t
#   Uses    $2-$3, $5-$77, $79   Saves  -   Stack  0   Calls  -
#   Domain  as isect_triangles_r16
#   Error   none of its own: hits exactly what isect_triangles_r16 hits
#   Twin    oracle/src/twin/triangle.rs
#
# Leaves between chunks of CHUNK triangles as soon as every ray is blocked; within a chunk the loop
# is free of exits, as a pipelined one must be. Rays whose t is not above 0 are not waited for.
# Scheduled by spu schedule from any_triangles_r16.s

        .include "work_unit.inc"
        .include "macros.inc"
        .include "rays.inc"
        .include "flat.inc"
        .include "triangle_tmpl.inc"

        .set    CHUNK,8

        .set    code,3
        .set    a_rays,3
        .set    a_shear,4
        .set    a_triangle,5
        .set    count,6
        # constants
        .set    k_above_one,10
        .set    k_sign,11
        .set    n_far,12                                # -t of the farthest
        # results, carried from triangle to triangle: a row each, the signs count
        .set    blocked,16
        # the triangle
        .set    vertex_a,20
        .set    vertex_b,21
        .set    vertex_c,22
        # temporaries
        .set    xa,23
        .set    ya,24
        .set    za,25
        .set    xb,26
        .set    yb,27
        .set    zb,28
        .set    xc,29
        .set    yc,30
        .set    zc,31
        .set    axis,32
        .set    origin,33
        .set    slope,34
        .set    p,35
        .set    q,36
        .set    u,37
        .set    v,38
        .set    w,39
        .set    det,40
        .set    inverse,41
        .set    t_y,42
        .set    t_e,43
        .set    n,44
        .set    outside,45
        .set    hit,46
        .set    low,47
        .set    m_rows,48
        .set    m_code,49
        .set    chunk,50
        .set    c_part,51
        .set    clear,52
        .set    idle,53                                 # bits: t not above 0
        .set    done,54                                 # bits: blocked or idle
        .set    k_zero,55

        sign_gathers_table

function any_triangles_r16
        .set    chunk_2,79
        .set    axis_2,23
        .set    axis_3,25
        .set    axis_4,26
        .set    axis_5,30
        .set    origin_2,41
        .set    axis_6,27
        .set    axis_7,29
        .set    origin_3,43
        .set    origin_4,2
        .set    origin_5,52
        .set    origin_6,3
        .set    xc_2,39
        .set    xb_2,61
        .set    yc_2,9
        .set    axis_8,7
        .set    xc_3,62
        .set    xc_4,67
        .set    axis_9,8
        .set    axis_10,36
        .set    zc_2,11
        .set    zc_3,24
        .set    yc_3,28
        .set    origin_7,31
        .set    zc_4,47
        .set    origin_8,46
        .set    origin_9,51
        .set    yc_4,11
        .set    zb_2,60
        .set    zc_5,28
        .set    axis_11,34
        .set    zc_6,42
        .set    ya_2,58
        .set    yc_5,38
        .set    zc_7,54
        .set    ya_3,68
        .set    za_2,69
        .set    zb_3,70
        .set    origin_10,40
        .set    ya_4,63
        .set    xa_2,24
        .set    za_3,64
        .set    zb_4,65
        .set    slope_2,3
        .set    slope_3,37
        .set    yb_2,29
        .set    axis_12,33
        .set    xa_3,2
        .set    xb_3,57
        .set    za_4,59
        .set    xb_4,66
        .set    zc_8,7
        .set    slope_4,24
        .set    slope_5,26
        .set    xb_5,71
        .set    zb_5,75
        .set    yb_3,8
        .set    ya_5,28
        .set    slope_6,30
        .set    xb_6,31
        .set    origin_11,32
        .set    xc_5,35
        .set    xc_6,72
        .set    xb_7,41
        .set    ya_6,73
        .set    yc_6,22
        .set    ya_7,44
        .set    p_2,45
        .set    slope_7,76
        .set    xa_4,27
        .set    zc_9,77
        .set    slope_8,7
        .set    origin_12,55
        .set    za_5,74
        .set    yb_4,25
        .set    xa_5,20
        .set    yb_5,21
        .set    slope_9,51
        .set    slope_10,56
        .set    slope_11,57
        .set    slope_12,52
        .set    slope_13,55
        .set    p_3,36
        .set    xb_8,33
        .set    p_4,34
        .set    p_5,24
        .set    p_6,63
        .set    xc_7,3
        .set    p_7,37
        .set    ya_8,30
        .set    p_8,32
        .set    q_2,68
        .set    p_9,40
        .set    v_2,26
        .set    v_3,11
        .set    q_3,67
        .set    q_4,9
        .set    p_10,43
        .set    u_2,46
        .set    q_5,66
        .set    q_6,39
        .set    q_7,7
        .set    q_8,71
        .set    u_3,36
        .set    u_4,34
        .set    u_5,45
        .set    w_2,28
        .set    u_6,3
        .set    q_9,2
        .set    w_3,8
        .set    p_11,51
        .set    q_10,27
        .set    v_4,22
        .set    q_11,20
        .set    v_5,9
        .set    u_7,31
        .set    w_4,21
        .set    det_2,3
        .set    v_6,30
        .set    w_5,33
        .set    det_3,7
        .set    w_6,34
        .set    w_7,41
        .set    det_4,20
        .set    det_5,8
        .set    t_y_2,22
        .set    t_y_3,24
        .set    t_y_4,3
        .set    t_y_5,27
        .set    t_y_6,21
        .set    t_e_2,7
        .set    t_e_3,2
        .set    inverse_2,27
        .set    t_e_4,8
        .set    inverse_3,28
        .set    inverse_4,35
        .set    u_8,43
        .set    v_7,45
        .set    inverse_5,40
        .set    u_9,51
        .set    u_10,58
        .set    n_2,2
        .set    v_8,3
        .set    n_3,8
        .set    axis_13,9
        .set    n_4,24
        .set    w_8,31
        .set    w_9,35
        .set    origin_13,42
        .set    outside_2,38
        .set    origin_14,47
        .set    origin_15,54
        .set    outside_3,3
        .set    origin_16,56
        .set    outside_4,11
        .set    origin_17,37
        .set    hit_2,44
        .set    outside_5,28
        .set    zc_10,9
        .set    zc_11,26
        .set    yc_7,26
        .set    zc_12,30
        .set    zc_13,22
        .set    slope_14,36
        .set    hit_3,2
        .set    slope_15,22
        .set    xa_6,32
        .set    yb_6,7
        .set    ya_9,33
        .set    xb_9,40
        .set    slope_16,41
        .set    xc_8,43
        .set    ya_10,46
        .set    xb_10,52
        .set    xc_9,55
        .set    ya_11,56
        .set    yb_7,22
        .set    p_12,25
        .set    p_13,57
        .set    p_14,41
        .set    u_11,25
        .set    q_12,62
        .set    q_13,43
        .set    u_12,41
        .set    q_14,55
        .set    q_15,22
        .set    w_10,23
        .set    w_11,29
        .set    det_6,22
        .set    hit_4,21
        .set    hit_5,23
        .set    hit_6,11
        .set    axis_14,2
        .set    axis_15,3
        .set    origin_18,11
        .set    origin_19,23
        .set    origin_20,24
        .set    origin_21,25
        .set    origin_22,26
        .set    xb_11,27
        .set    za_6,31
        .set    zb_6,34
        .set    zc_14,3
        .set    xb_12,35
        .set    xc_10,36
        .set    ya_12,37
        .set    yc_8,23
        .set    za_7,38
        .set    zb_7,39
        .set    slope_17,40
        .set    slope_18,42
        .set    yb_8,2
        .set    xa_7,7
        .set    axis_16,11
        .set    axis_17,43
        .set    axis_18,44
        .set    axis_19,24
        .set    origin_23,45
        .set    p_15,52
        .set    xb_13,54
        .set    p_16,55
        .set    xc_11,56
        .set    ya_13,42
        .set    za_8,58
        .set    p_17,59
        .set    zc_15,43
        .set    yc_9,64
        .set    za_9,65
        .set    zb_8,47
        .set    xc_12,25
        .set    slope_19,62
        .set    slope_20,66
        .set    slope_21,67
        .set    slope_22,68
        .set    xa_8,33
        .set    yb_9,11
        .set    q_16,41
        .set    u_13,44
        .set    q_17,24
        .set    slope_23,29
        .set    slope_24,69
        .set    q_18,70
        .set    slope_25,71
        .set    u_14,57
        .set    v_9,23
        .set    xb_14,45
        .set    xc_13,46
        .set    ya_14,51
        .set    yc_10,54
        .set    v_10,24
        .set    w_12,27
        .set    u_15,28
        .set    w_13,7
        .set    xa_9,8
        .set    p_18,30
        .set    p_19,33
        .set    w_14,2
        .set    det_7,27
        .set    det_8,36
        .set    q_19,37
        .set    u_16,35
        .set    q_20,44
        .set    q_21,46
        .set    u_17,32
        .set    q_22,25
        .set    v_11,33
        .set    p_20,54
        .set    q_23,8
        .set    w_15,11
        .set    u_18,30
        .set    v_12,25
        .set    t_y_7,32
        .set    t_y_8,11
        .set    w_16,20
        .set    det_9,21
        .set    t_e_5,27
        .set    t_e_6,32
        .set    t_y_9,33
        .set    inverse_6,11
        .set    u_19,33
        .set    t_e_7,35
        .set    t_e_8,21
        .set    n_5,31
        .set    n_6,21
        .set    n_7,9
        .set    v_13,21
        .set    n_8,20
        .set    outside_6,23
        .set    outside_7,7
        .set    hit_7,8
        .set    hit_8,7
        il      $k_zero,0                               # 0e
        lqd     $n_far,384($a_rays)                     # 0o

        ilhu    $k_above_one,0x3f80                     # 1e
        lqd     $n_far+1,400($a_rays)                   # 1o

        ilhu    $k_sign,0x8000                          # 2e
        lqd     $n_far+2,416($a_rays)                   # 2o

        iohl    $k_above_one,2                          # 3e
        lqd     $n_far+3,432($a_rays)                   # 3o

        lqa     $m_rows,sign_gathers                    # 4o
        lqa     $m_code,sign_gathers+16                 # 5o

        fcgt    $blocked,$n_far,$k_zero                 # 6e
        fcgt    $blocked+1,$n_far+1,$k_zero             # 7e

        fcgt    $blocked+2,$n_far+2,$k_zero             # 8e
        fcgt    $blocked+3,$n_far+3,$k_zero             # 9e

        nor     $blocked,$blocked,$blocked              # 10e
        nor     $blocked+1,$blocked+1,$blocked+1        # 11e

        nor     $blocked+2,$blocked+2,$blocked+2        # 12e
        lnop                                            # 12o pairing

        nor     $blocked+3,$blocked+3,$blocked+3        # 13e
        shufb   $idle,$blocked,$blocked+1,$m_rows       # 13o

        xor     $n_far,$n_far,$k_sign                   # 14e
        lnop                                            # 14o pairing

        xor     $n_far+1,$n_far+1,$k_sign               # 15e
        shufb   $low,$blocked+2,$blocked+3,$m_rows      # 15o

        xor     $n_far+2,$n_far+2,$k_sign               # 16e
        xor     $n_far+3,$n_far+3,$k_sign               # 17e

        shufb   $idle,$idle,$low,$m_code                # 19o
        rotqbii $idle,$idle,1                           # 23o

        gbb     $idle,$idle                             # 27o
        ori     $done,$idle,0                           # 31e

next_chunk:
        ai      $clear,$done,1                          # 0e 0x10000 if no ray is left
        rotmi   $clear,$clear,-16                       # 2e

        nop     $127                                    # 3e pairing
        brnz    $clear,return                           # 6o

        nop     $127                                    # 7e pairing
        brz     $count,return                           # 7o

        il      $chunk,8                                # 8e
        cgt     $c_part,$chunk,$count                   # 10e

        selb    $chunk,$chunk,$count,$c_part            # 12e
        clgti   $chunk_2,$chunk,1                       # 14e at least as many passes as overlap

        sf      $count,$chunk,$count                    # 15e
        brz     $chunk_2,next_triangle_short            # 16o too few passes

        ai      $chunk,$chunk,-1                        # 17e
        lqd     $vertex_c,32($a_triangle)               # 17o

        lqd     $axis_2,16($a_shear)                    # 18o
        lqd     $axis_3,80($a_shear)                    # 19o

        lqd     $vertex_a,0($a_triangle)                # 20o
        lqd     $axis,0($a_shear)                       # 21o

        nop     $127                                    # 22e pairing
        lqd     $vertex_b,16($a_triangle)               # 22o

        ai      $a_triangle,$a_triangle,48              # 23e
        lqd     $axis_4,144($a_shear)                   # 23o

        lqd     $axis_5,160($a_shear)                   # 24o
        lqd     $origin_2,256($a_shear)                 # 25o

        lqd     $axis_6,32($a_shear)                    # 26o
        lqd     $axis_7,96($a_shear)                    # 27o

        lqd     $origin_3,208($a_shear)                 # 28o
        lqd     $origin_4,336($a_shear)                 # 29o

        lqd     $origin_5,288($a_shear)                 # 30o
        lqd     $origin_6,352($a_shear)                 # 31o

        shufb   $xc_2,$vertex_c,$vertex_c,$axis         # 32o
        shufb   $xb_2,$vertex_b,$vertex_b,$axis_2       # 33o

        shufb   $yc_2,$vertex_c,$vertex_c,$axis_3       # 34o
        lqd     $axis_8,128($a_shear)                   # 35o

        nop     $127                                    # 36e pairing
        shufb   $xc_3,$vertex_c,$vertex_c,$axis_2       # 36o

        fs      $xb_2,$xb_2,$origin_3                   # 37e
        shufb   $xc_4,$vertex_c,$vertex_c,$axis_6       # 37o

        lqd     $axis_9,64($a_shear)                    # 38o
        lqd     $axis_10,176($a_shear)                  # 39o

        fs      $xc_3,$xc_3,$origin_3                   # 40e
        shufb   $zc_2,$vertex_c,$vertex_c,$axis_4       # 40o

        shufb   $zc_3,$vertex_c,$vertex_c,$axis_8       # 41o
        shufb   $yc_3,$vertex_c,$vertex_c,$axis_7       # 42o

        nop     $127                                    # 43e pairing
        lqd     $origin_7,320($a_shear)                 # 43o

        fs      $zc_4,$zc_2,$origin_4                   # 44e
        lqd     $origin_8,272($a_shear)                 # 44o

        nop     $127                                    # 45e pairing
        lqd     $origin_9,224($a_shear)                 # 45o

        fs      $yc_4,$yc_3,$origin_5                   # 46e
        shufb   $zb_2,$vertex_b,$vertex_b,$axis_8       # 46o

        shufb   $zc_5,$vertex_c,$vertex_c,$axis_5       # 47o
        lqd     $axis_11,112($a_shear)                  # 48o

        fs      $zc_6,$zc_3,$origin_7                   # 49e
        shufb   $ya_2,$vertex_a,$vertex_a,$axis_9       # 49o

        fs      $zb_2,$zb_2,$origin_7                   # 50e
        shufb   $yc_5,$vertex_c,$vertex_c,$axis_9       # 50o

        fs      $zc_7,$zc_5,$origin_6                   # 51e
        shufb   $ya_3,$vertex_a,$vertex_a,$axis_7       # 51o

        fs      $yc_2,$yc_2,$origin_8                   # 52e
        shufb   $za_2,$vertex_a,$vertex_a,$axis_5       # 52o

        fs      $ya_2,$ya_2,$origin_2                   # 53e
        shufb   $zb_3,$vertex_b,$vertex_b,$axis_5       # 53o

        fs      $yc_5,$yc_5,$origin_2                   # 54e
        lqd     $origin_10,192($a_shear)                # 54o

        fs      $xc_4,$xc_4,$origin_9                   # 55e
        shufb   $ya_4,$vertex_a,$vertex_a,$axis_3       # 55o

        fs      $za_2,$za_2,$origin_6                   # 56e
        shufb   $xa_2,$vertex_a,$vertex_a,$axis         # 56o

        fs      $zb_3,$zb_3,$origin_6                   # 57e
        shufb   $za_3,$vertex_a,$vertex_a,$axis_4       # 57o

        fs      $ya_3,$ya_3,$origin_5                   # 58e
        shufb   $zb_4,$vertex_b,$vertex_b,$axis_4       # 58o

        fs      $ya_4,$ya_4,$origin_8                   # 59e
        lqd     $slope_2,400($a_shear)                  # 59o

        fs      $xc_2,$xc_2,$origin_10                  # 60e
        lqd     $slope_3,464($a_shear)                  # 60o

        fs      $za_3,$za_3,$origin_4                   # 61e
        shufb   $yb_2,$vertex_b,$vertex_b,$axis_7       # 61o

        fs      $zb_4,$zb_4,$origin_4                   # 62e
        lqd     $axis_12,48($a_shear)                   # 62o

        fs      $xa_3,$xa_2,$origin_10                  # 63e
        shufb   $xb_3,$vertex_b,$vertex_b,$axis         # 63o

        nop     $127                                    # 64e pairing
        shufb   $za_4,$vertex_a,$vertex_a,$axis_8       # 64o

        fnms    $xc_3,$slope_2,$zc_4,$xc_3              # 65e
        shufb   $xb_4,$vertex_b,$vertex_b,$axis_6       # 65o

        fs      $yb_2,$yb_2,$origin_5                   # 66e
        shufb   $zc_8,$vertex_c,$vertex_c,$axis_10      # 66o

        fs      $xb_3,$xb_3,$origin_10                  # 67e
        lqd     $slope_4,384($a_shear)                  # 67o

        fs      $za_4,$za_4,$origin_7                   # 68e
        lqd     $slope_5,416($a_shear)                  # 68o

        fs      $xb_4,$xb_4,$origin_9                   # 69e
        shufb   $xb_5,$vertex_b,$vertex_b,$axis_12      # 69o

        fnms    $yc_2,$slope_3,$zc_4,$yc_2              # 70e
        shufb   $zb_5,$vertex_b,$vertex_b,$axis_10      # 70o

        fnms    $xb_2,$slope_2,$zb_4,$xb_2              # 71e
        shufb   $yb_3,$vertex_b,$vertex_b,$axis_9       # 71o

        fnms    $ya_5,$slope_3,$za_3,$ya_4              # 72e
        lqd     $slope_6,480($a_shear)                  # 72o

        fnms    $xb_6,$slope_4,$zb_2,$xb_3              # 73e
        lqd     $origin_11,304($a_shear)                # 73o

        fnms    $xc_5,$slope_5,$zc_7,$xc_4              # 74e
        lqd     $origin_10,368($a_shear)                # 74o

        fs      $yb_3,$yb_3,$origin_2                   # 75e
        shufb   $xc_6,$vertex_c,$vertex_c,$axis_12      # 75o

        fnms    $xb_7,$slope_5,$zb_3,$xb_4              # 76e
        shufb   $ya_6,$vertex_a,$vertex_a,$axis_11      # 76o

        fnms    $xc_2,$slope_4,$zc_6,$xc_2              # 77e
        shufb   $yc_6,$vertex_c,$vertex_c,$axis_11      # 77o

        fnms    $ya_7,$slope_6,$za_2,$ya_3              # 78e
        shufb   $xa,$vertex_a,$vertex_a,$axis_2         # 78o

        fm      $p_2,$yc_2,$xb_2                        # 79e
        lqd     $slope_7,448($a_shear)                  # 79o

        fs      $ya_6,$ya_6,$origin_11                  # 80e
        shufb   $xa_4,$vertex_a,$vertex_a,$axis_6       # 80o

        fs      $zc_9,$zc_8,$origin_10                  # 81e
        lqd     $slope_8,432($a_shear)                  # 81o

        fs      $xa,$xa,$origin_3                       # 82e
        lqd     $origin_12,240($a_shear)                # 82o

        fs      $yc_6,$yc_6,$origin_11                  # 83e
        shufb   $za_5,$vertex_a,$vertex_a,$axis_10      # 83o

        fs      $xa_4,$xa_4,$origin_9                   # 84e
        shufb   $yb_4,$vertex_b,$vertex_b,$axis_3       # 84o

        fnms    $ya_2,$slope_7,$za_4,$ya_2              # 85e
        shufb   $xa_5,$vertex_a,$vertex_a,$axis_12      # 85o

        fnms    $yc_5,$slope_7,$zc_6,$yc_5              # 86e
        shufb   $yb_5,$vertex_b,$vertex_b,$axis_11      # 86o

        fs      $zb_5,$zb_5,$origin_10                  # 87e
        lqd     $slope_9,496($a_shear)                  # 87o

        fs      $xb_5,$xb_5,$origin_12                  # 88e
        lqd     $slope_10,544($a_shear)                 # 88o

        fs      $yb_4,$yb_4,$origin_8                   # 89e
        lqd     $slope_11,560($a_shear)                 # 89o

        fs      $xc_6,$xc_6,$origin_12                  # 90e
        lqd     $slope_12,512($a_shear)                 # 90o

        fs      $xa_5,$xa_5,$origin_12                  # 91e
        lqd     $slope_13,528($a_shear)                 # 91o

        fnms    $yc_4,$slope_6,$zc_7,$yc_4              # 92e
        fm      $p_3,$yc_5,$xb_6                        # 93e

        fnms    $xa_4,$slope_5,$za_2,$xa_4              # 94e
        fs      $za_5,$za_5,$origin_10                  # 95e

        fnms    $yb_4,$slope_3,$zb_4,$yb_4              # 96e
        fnms    $xb_8,$slope_8,$zb_5,$xb_5              # 97e

        fm      $p_4,$yc_4,$xb_7                        # 98e
        fnms    $xa_3,$slope_4,$za_4,$xa_3              # 99e

        fm      $p_5,$ya_7,$xc_5                        # 100e
        fm      $p_6,$ya_2,$xc_2                        # 101e

        fnms    $xa,$slope_2,$za_3,$xa                  # 102e
        fnms    $xc_7,$slope_8,$zc_9,$xc_6              # 103e

        fnms    $yc_6,$slope_9,$zc_9,$yc_6              # 104e
        fs      $yb_5,$yb_5,$origin_11                  # 105e

        fnms    $yb_3,$slope_7,$zb_2,$yb_3              # 106e
        fm      $p_7,$ya_5,$xc_3                        # 107e

        fnms    $yb_2,$slope_6,$zb_3,$yb_2              # 108e
        fnms    $ya_8,$slope_9,$za_5,$ya_6              # 109e

        fm      $p_8,$yb_4,$xa                          # 110e
        fms     $q_2,$yc_4,$xb_7,$p_4                   # 111e

        fm      $p_9,$yb_3,$xa_3                        # 112e
        fms     $v_2,$xa_4,$yc_4,$p_5                   # 113e

        fms     $v_3,$xa,$yc_2,$p_7                     # 114e
        fms     $q_3,$yc_2,$xb_2,$p_2                   # 115e

        fms     $q_4,$ya_5,$xc_3,$p_7                   # 116e
        fm      $p_7,$yc_6,$xb_8                        # 117e

        fm      $p_10,$ya_8,$xc_7                       # 118e
        fms     $u_2,$xc_2,$yb_3,$p_3                   # 119e

        fms     $q_5,$yc_5,$xb_6,$p_3                   # 120e
        fms     $v,$xa_3,$yc_5,$p_6                     # 121e

        fnms    $yb_5,$slope_9,$zb_5,$yb_5              # 122e
        fms     $q_6,$ya_2,$xc_2,$p_6                   # 123e

        fnms    $xa_5,$slope_8,$za_5,$xa_5              # 124e
        fms     $q_7,$ya_7,$xc_5,$p_5                   # 125e

        fm      $p_5,$yb_2,$xa_4                        # 126e
        fms     $q_8,$yc_6,$xb_8,$p_7                   # 127e

        fms     $u_3,$xc_3,$yb_4,$p_2                   # 128e
        fs      $v,$v,$q_6                              # 129e

        fms     $u_4,$xc_5,$yb_2,$p_4                   # 130e
        fs      $v_2,$v_2,$q_7                          # 131e

        fms     $q_7,$ya_8,$xc_7,$p_10                  # 132e
        fs      $u_5,$u_2,$q_5                          # 133e

        fms     $w,$xb_6,$ya_2,$p_9                     # 134e
        fms     $w_2,$xb_2,$ya_5,$p_8                   # 135e

        fms     $u_6,$xc_7,$yb_5,$p_7                   # 136e
        fs      $u_3,$u_3,$q_3                          # 137e

        fms     $q_9,$yb_3,$xa_3,$p_9                   # 138e
        fs      $u,$u_4,$q_2                            # 139e

        fms     $w_3,$xb_7,$ya_7,$p_5                   # 140e
        fm      $p_11,$yb_5,$xa_5                       # 141e

        fms     $q_10,$yb_2,$xa_4,$p_5                  # 142e
        fms     $v_4,$xa_5,$yc_6,$p_10                  # 143e

        fs      $w,$w,$q_9                              # 144e
        fms     $q_9,$yb_4,$xa,$p_8                     # 145e

        fa      $det,$u_5,$v                            # 146e
        fms     $q_11,$yb_5,$xa_5,$p_11                 # 147e

        fs      $v_5,$v_3,$q_4                          # 148e
        fs      $u_7,$u_6,$q_8                          # 149e

        fms     $w_4,$xb_8,$ya_8,$p_11                  # 150e
        fa      $det_2,$u,$v_2                          # 151e

        fs      $v_6,$v_4,$q_7                          # 152e
        fs      $w_5,$w_2,$q_9                          # 153e

        fa      $det_3,$u_3,$v_5                        # 154e
        fs      $w_6,$w_3,$q_10                         # 155e

        fs      $w_7,$w_4,$q_11                         # 156e
        fa      $det,$det,$w                            # 157e

        fa      $det_4,$u_7,$v_6                        # 158e
        fa      $det_3,$det_3,$w_5                      # 160e

        fa      $det_5,$det_2,$w_6                      # 161e
        frest   $t_y_2,$det                             # 163o

        fa      $det_4,$det_4,$w_7                      # 164e
        frest   $t_y_3,$det_3                           # 166o

        fi      $t_y_2,$det,$t_y_2                      # 167e
        frest   $t_y_4,$det_5                           # 167o

        fi      $t_y_3,$det_3,$t_y_3                    # 170e
        frest   $t_y_5,$det_4                           # 170o

        fi      $t_y_4,$det_5,$t_y_4                    # 171e
        fnms    $t_e,$det,$t_y_2,$k_above_one           # 174e

        fi      $t_y_6,$det_4,$t_y_5                    # 175e
        fnms    $t_e_2,$det_3,$t_y_3,$k_above_one       # 177e

        fnms    $t_e_3,$det_5,$t_y_4,$k_above_one       # 178e
        fma     $inverse_2,$t_e,$t_y_2,$t_y_2           # 180e

        fnms    $t_e_4,$det_4,$t_y_6,$k_above_one       # 182e
        fma     $inverse_3,$t_e_2,$t_y_3,$t_y_3         # 183e

        fma     $inverse_4,$t_e_3,$t_y_4,$t_y_4         # 184e
        fm      $u_8,$u_5,$inverse_2                    # 186e

        fm      $v_7,$v,$inverse_2                      # 187e
        fma     $inverse_5,$t_e_4,$t_y_6,$t_y_6         # 188e

        fm      $u_9,$u_3,$inverse_3                    # 189e
        fm      $u_10,$u,$inverse_4                     # 190e

next_triangle:
            fm      $v,$v_5,$inverse_3                  # 0e
        lqd     $vertex_a,0($a_triangle)                # 0o

            fm      $u,$u_7,$inverse_5                  # 1e
        lqd     $vertex_b,16($a_triangle)               # 1o

            fm      $n,$u_8,$za_4                       # 2e
        lqd     $vertex_c,32($a_triangle)               # 2o

            fm      $n_2,$u_9,$za_3                     # 3e
        lqd     $axis,0($a_shear)                       # 3o

            fm      $v_8,$v_2,$inverse_4                # 4e
        lqd     $axis_8,64($a_shear)                    # 4o

            fm      $n_3,$u_10,$za_2                    # 5e
        lqd     $axis_13,128($a_shear)                  # 5o

            fm      $v_3,$v_6,$inverse_5                # 6e
        lqd     $axis_2,16($a_shear)                    # 6o

            fm      $n_4,$u,$za_5                       # 7e
        lqd     $axis_3,80($a_shear)                    # 7o

            fm      $w,$w,$inverse_2                    # 8e
        lqd     $axis_4,144($a_shear)                   # 8o

            fma     $n,$v_7,$zb_2,$n                    # 9e
        lqd     $axis_6,32($a_shear)                    # 9o

            fm      $w_2,$w_5,$inverse_3                # 10e
        lqd     $axis_7,96($a_shear)                    # 10o

            fma     $n_2,$v,$zb_4,$n_2                  # 11e
        lqd     $axis_5,160($a_shear)                   # 11o

            fm      $w_8,$w_6,$inverse_4                # 12e
        lqd     $axis_12,48($a_shear)                   # 12o

            fma     $n_3,$v_8,$zb_3,$n_3                # 13e
        lqd     $axis_11,112($a_shear)                  # 13o

            fm      $w_9,$w_7,$inverse_5                # 14e
        lqd     $axis_10,176($a_shear)                  # 14o

            fma     $n_4,$v_3,$zb_5,$n_4                # 15e
        lqd     $origin_10,192($a_shear)                # 15o

            fma     $n,$w,$zc_6,$n                      # 16e
        lqd     $origin_2,256($a_shear)                 # 16o

            fma     $n_2,$w_2,$zc_4,$n_2                # 17e
        lqd     $origin_13,320($a_shear)                # 17o

            or      $outside,$u_8,$v_7                  # 18e
        lqd     $origin_3,208($a_shear)                 # 18o

            fma     $n_3,$w_8,$zc_7,$n_3                # 19e
        lqd     $origin_8,272($a_shear)                 # 19o

            or      $outside_2,$u_9,$v                  # 20e
        lqd     $origin_14,336($a_shear)                # 20o

            fma     $n_4,$w_9,$zc_9,$n_4                # 21e
        lqd     $origin_9,224($a_shear)                 # 21o

            fm      $n,$n,$slope_12                     # 22e
        lqd     $origin_5,288($a_shear)                 # 22o

            fm      $n_2,$n_2,$slope_13                 # 23e
        lqd     $origin_15,352($a_shear)                # 23o

            or      $outside_3,$u_10,$v_8               # 24e
        lqd     $origin_12,240($a_shear)                # 24o

            fm      $n_3,$n_3,$slope_10                 # 25e
        lqd     $origin_16,304($a_shear)                # 25o

            or      $outside_4,$u,$v_3                  # 26e
        lqd     $origin_17,368($a_shear)                # 26o

            fm      $n_4,$n_4,$slope_11                 # 27e
        shufb   $xb_3,$vertex_b,$vertex_b,$axis         # 27o

            or      $outside,$outside,$w                # 28e
        shufb   $xc_2,$vertex_c,$vertex_c,$axis         # 28o

            cgt     $hit_2,$n_far,$n                    # 29e 0 < t < t_far
        shufb   $ya_2,$vertex_a,$vertex_a,$axis_8       # 29o

            or      $outside_5,$outside_2,$w_2          # 30e
        shufb   $yc_5,$vertex_c,$vertex_c,$axis_8       # 30o

        fs      $xb_3,$xb_3,$origin_10                  # 31e
        shufb   $za_4,$vertex_a,$vertex_a,$axis_13      # 31o

        fs      $xc_2,$xc_2,$origin_10                  # 32e
        shufb   $zb_2,$vertex_b,$vertex_b,$axis_13      # 32o

        fs      $ya_2,$ya_2,$origin_2                   # 33e
        shufb   $zc_10,$vertex_c,$vertex_c,$axis_13     # 33o

        fs      $yc_5,$yc_5,$origin_2                   # 34e
        shufb   $xb_2,$vertex_b,$vertex_b,$axis_2       # 34o

        fs      $za_4,$za_4,$origin_13                  # 35e
        shufb   $xc_3,$vertex_c,$vertex_c,$axis_2       # 35o

        fs      $zb_2,$zb_2,$origin_13                  # 36e
        shufb   $ya_4,$vertex_a,$vertex_a,$axis_3       # 36o

        fs      $zc_6,$zc_10,$origin_13                 # 37e
        shufb   $yc_2,$vertex_c,$vertex_c,$axis_3       # 37o

        fs      $xb_2,$xb_2,$origin_3                   # 38e
        shufb   $za_3,$vertex_a,$vertex_a,$axis_4       # 38o

        fs      $xc_3,$xc_3,$origin_3                   # 39e
        shufb   $zb_4,$vertex_b,$vertex_b,$axis_4       # 39o

        fs      $ya_4,$ya_4,$origin_8                   # 40e
        shufb   $zc_11,$vertex_c,$vertex_c,$axis_4      # 40o

        fs      $yc_2,$yc_2,$origin_8                   # 41e
        shufb   $xb_4,$vertex_b,$vertex_b,$axis_6       # 41o

        fs      $za_3,$za_3,$origin_14                  # 42e
        shufb   $xc_4,$vertex_c,$vertex_c,$axis_6       # 42o

        fs      $zb_4,$zb_4,$origin_14                  # 43e
        shufb   $ya_3,$vertex_a,$vertex_a,$axis_7       # 43o

        fs      $zc_4,$zc_11,$origin_14                 # 44e
        shufb   $yc_7,$vertex_c,$vertex_c,$axis_7       # 44o

        fs      $xb_4,$xb_4,$origin_9                   # 45e
        shufb   $za_2,$vertex_a,$vertex_a,$axis_5       # 45o

        fs      $xc_4,$xc_4,$origin_9                   # 46e
        shufb   $zb_3,$vertex_b,$vertex_b,$axis_5       # 46o

        fs      $ya_3,$ya_3,$origin_5                   # 47e
        shufb   $zc_12,$vertex_c,$vertex_c,$axis_5      # 47o

        fs      $yc_7,$yc_7,$origin_5                   # 48e
        shufb   $xb_5,$vertex_b,$vertex_b,$axis_12      # 48o

        fs      $za_2,$za_2,$origin_15                  # 49e
        shufb   $xc_6,$vertex_c,$vertex_c,$axis_12      # 49o

        fs      $zb_3,$zb_3,$origin_15                  # 50e
        shufb   $ya_6,$vertex_a,$vertex_a,$axis_11      # 50o

        fs      $zc_7,$zc_12,$origin_15                 # 51e
        shufb   $yc,$vertex_c,$vertex_c,$axis_11        # 51o

        fs      $xb_5,$xb_5,$origin_12                  # 52e
        shufb   $za_5,$vertex_a,$vertex_a,$axis_10      # 52o

        fs      $xc_6,$xc_6,$origin_12                  # 53e
        shufb   $zb_5,$vertex_b,$vertex_b,$axis_10      # 53o

        fs      $ya_6,$ya_6,$origin_16                  # 54e
        shufb   $zc_13,$vertex_c,$vertex_c,$axis_10     # 54o

        fs      $yc,$yc,$origin_16                      # 55e
        lqd     $slope_14,384($a_shear)                 # 55o

        fs      $za_5,$za_5,$origin_17                  # 56e
        lnop                                            # 56o pairing

        fs      $zb_5,$zb_5,$origin_17                  # 57e
        lqd     $slope_7,448($a_shear)                  # 57o

        fs      $zc_9,$zc_13,$origin_17                 # 58e
        lnop                                            # 58o pairing

            cgt     $hit_3,$n_far+1,$n_2                # 59e 0 < t < t_far
        lqd     $slope_15,400($a_shear)                 # 59o

            or      $outside_3,$outside_3,$w_8          # 60e
            lnop                                        # 60o pairing

        fnms    $xb_6,$slope_14,$zb_2,$xb_3             # 61e
        lqd     $slope_3,464($a_shear)                  # 61o

        fnms    $xc_2,$slope_14,$zc_6,$xc_2             # 62e
        lqd     $slope_11,416($a_shear)                 # 62o

        fnms    $ya_2,$slope_7,$za_4,$ya_2              # 63e
        shufb   $xa_6,$vertex_a,$vertex_a,$axis         # 63o

        fnms    $yc_5,$slope_7,$zc_6,$yc_5              # 64e
        shufb   $yb_6,$vertex_b,$vertex_b,$axis_8       # 64o

        fnms    $xb_2,$slope_15,$zb_4,$xb_2             # 65e
        shufb   $xa,$vertex_a,$vertex_a,$axis_2         # 65o

        fnms    $xc_3,$slope_15,$zc_4,$xc_3             # 66e
        shufb   $yb_4,$vertex_b,$vertex_b,$axis_3       # 66o

        fs      $xa_6,$xa_6,$origin_10                  # 67e
        shufb   $xa_4,$vertex_a,$vertex_a,$axis_6       # 67o

        fs      $yb_6,$yb_6,$origin_2                   # 68e
        shufb   $yb_2,$vertex_b,$vertex_b,$axis_7       # 68o

        fs      $xa,$xa,$origin_3                       # 69e
        shufb   $xa_5,$vertex_a,$vertex_a,$axis_12      # 69o

        fs      $yb_4,$yb_4,$origin_8                   # 70e
        shufb   $yb_5,$vertex_b,$vertex_b,$axis_11      # 70o

        fnms    $ya_9,$slope_3,$za_3,$ya_4              # 71e
        lqd     $slope,480($a_shear)                    # 71o

        fnms    $yc_2,$slope_3,$zc_4,$yc_2              # 72e
        fs      $xa_4,$xa_4,$origin_9                   # 73e

        fs      $yb_2,$yb_2,$origin_5                   # 74e
        lnop                                            # 74o pairing

        fnms    $xb_9,$slope_11,$zb_3,$xb_4             # 75e
        lqd     $slope_16,432($a_shear)                 # 75o

        fnms    $xc_8,$slope_11,$zc_7,$xc_4             # 76e
        lnop                                            # 76o pairing

        fnms    $ya_10,$slope,$za_2,$ya_3               # 77e
        lqd     $slope_9,496($a_shear)                  # 77o

        fnms    $yc_7,$slope,$zc_7,$yc_7                # 78e
        fs      $xa_5,$xa_5,$origin_12                  # 79e

        fs      $yb_5,$yb_5,$origin_16                  # 80e
        fnms    $xb_10,$slope_16,$zb_5,$xb_5            # 81e

        fnms    $xc_9,$slope_16,$zc_9,$xc_6             # 82e
        fnms    $ya_11,$slope_9,$za_5,$ya_6             # 83e

        fnms    $yc,$slope_9,$zc_9,$yc                  # 84e
        fnms    $xa_6,$slope_14,$za_4,$xa_6             # 85e

        fnms    $yb_6,$slope_7,$zb_2,$yb_6              # 86e
        fm      $p_3,$yc_5,$xb_6                        # 87e

        fm      $p_6,$ya_2,$xc_2                        # 88e
        fnms    $xa,$slope_15,$za_3,$xa                 # 89e

        fnms    $yb_7,$slope_3,$zb_4,$yb_4              # 90e
        fm      $p_12,$yc_2,$xb_2                       # 91e

        fm      $p_7,$ya_9,$xc_3                        # 92e
        fnms    $xa_4,$slope_11,$za_2,$xa_4             # 93e

        fnms    $yb_2,$slope,$zb_3,$yb_2                # 94e
        fm      $p_4,$yc_7,$xb_9                        # 95e

        fm      $p_13,$ya_10,$xc_8                      # 96e
        fnms    $xa_5,$slope_16,$za_5,$xa_5             # 97e

        fnms    $yb_5,$slope_9,$zb_5,$yb_5              # 98e
        fm      $p_14,$yc,$xb_10                        # 99e

        fm      $p_11,$ya_11,$xc_9                      # 100e
        fms     $q_5,$yc_5,$xb_6,$p_3                   # 101e

        fms     $u_3,$xc_2,$yb_6,$p_3                   # 102e
        fms     $q_6,$ya_2,$xc_2,$p_6                   # 103e

        fms     $v,$xa_6,$yc_5,$p_6                     # 104e
        fm      $p_6,$yb_6,$xa_6                        # 105e

        fms     $q_3,$yc_2,$xb_2,$p_12                  # 106e
        fms     $u_11,$xc_3,$yb_7,$p_12                 # 107e

        fms     $q_12,$ya_9,$xc_3,$p_7                  # 108e
        fms     $v_5,$xa,$yc_2,$p_7                     # 109e

        fm      $p_7,$yb_7,$xa                          # 110e
        fms     $q_2,$yc_7,$xb_9,$p_4                   # 111e

        fms     $u_4,$xc_8,$yb_2,$p_4                   # 112e
        fms     $q_13,$ya_10,$xc_8,$p_13                # 113e

        fms     $v_2,$xa_4,$yc_7,$p_13                  # 114e
        fm      $p_13,$yb_2,$xa_4                       # 115e

        fms     $q_8,$yc,$xb_10,$p_14                   # 116e
        fms     $u_12,$xc_9,$yb_5,$p_14                 # 117e

        fms     $q_14,$ya_11,$xc_9,$p_11                # 118e
        fms     $v_6,$xa_5,$yc,$p_11                    # 119e

        fm      $p_11,$yb_5,$xa_5                       # 120e
        fs      $u_3,$u_3,$q_5                          # 121e

        fs      $v,$v,$q_6                              # 122e
        fms     $q_7,$yb_6,$xa_6,$p_6                   # 123e

        fms     $w,$xb_6,$ya_2,$p_6                     # 124e
        fs      $u_11,$u_11,$q_3                        # 125e

        fs      $v_5,$v_5,$q_12                         # 126e
        fms     $q_15,$yb_7,$xa,$p_7                    # 127e

        fms     $w_10,$xb_2,$ya_9,$p_7                  # 128e
        fs      $u,$u_4,$q_2                            # 129e

        fs      $v_2,$v_2,$q_13                         # 130e
        fms     $q_10,$yb_2,$xa_4,$p_13                 # 131e

        fms     $w_11,$xb_9,$ya_10,$p_13                # 132e
        fs      $u_7,$u_12,$q_8                         # 133e

        fs      $v_6,$v_6,$q_14                         # 134e
        fms     $q_11,$yb_5,$xa_5,$p_11                 # 135e

        fms     $w_4,$xb_10,$ya_11,$p_11                # 136e
        fs      $w,$w,$q_7                              # 137e

        fa      $det,$u_3,$v                            # 138e
        fs      $w_5,$w_10,$q_15                        # 139e

        fa      $det_3,$u_11,$v_5                       # 140e
        fs      $w_6,$w_11,$q_10                        # 141e

        fa      $det_6,$u,$v_2                          # 142e
        fs      $w_7,$w_4,$q_11                         # 143e

        fa      $det_4,$u_7,$v_6                        # 144e
        fa      $det,$det,$w                            # 145e

        fa      $det_3,$det_3,$w_5                      # 146e
            cgt     $hit,$n_far+2,$n_3                  # 147e 0 < t < t_far

        fa      $det_5,$det_6,$w_6                      # 148e
            or      $outside_4,$outside_4,$w_9          # 149e

        fa      $det_4,$det_4,$w_7                      # 150e
        lnop                                            # 150o pairing

            cgt     $hit_4,$n_far+3,$n_4                # 151e 0 < t < t_far
        frest   $t_y_2,$det                             # 151o

            andc    $hit_5,$hit_2,$outside              # 152e
        frest   $t_y_3,$det_3                           # 152o

            andc    $hit_3,$hit_3,$outside_5            # 153e
            lnop                                        # 153o pairing

            andc    $hit,$hit,$outside_3                # 154e
        frest   $t_y_4,$det_5                           # 154o

        fi      $t_y_2,$det,$t_y_2                      # 155e
        lnop                                            # 155o pairing

        fi      $t_y_3,$det_3,$t_y_3                    # 156e
        frest   $t_y_5,$det_4                           # 156o

            andc    $hit_6,$hit_4,$outside_4            # 157e
        fi      $t_y_4,$det_5,$t_y_4                    # 158e

        ai      $chunk,$chunk,-1                        # 159e
        fi      $t_y_6,$det_4,$t_y_5                    # 160e

            or      $blocked,$blocked,$hit_5            # 161e
        hbrr    next_triangle_back,next_triangle        # 161o hint

        fnms    $t_e,$det,$t_y_2,$k_above_one           # 162e
        fnms    $t_e_2,$det_3,$t_y_3,$k_above_one       # 163e

            or      $blocked+1,$blocked+1,$hit_3        # 164e
        fnms    $t_e_3,$det_5,$t_y_4,$k_above_one       # 165e

            or      $blocked+2,$blocked+2,$hit          # 166e
        fnms    $t_e_4,$det_4,$t_y_6,$k_above_one       # 167e

        fma     $inverse_2,$t_e,$t_y_2,$t_y_2           # 168e
        fma     $inverse_3,$t_e_2,$t_y_3,$t_y_3         # 169e

            or      $blocked+3,$blocked+3,$hit_6        # 170e
        fma     $inverse_4,$t_e_3,$t_y_4,$t_y_4         # 171e

        ai      $a_triangle,$a_triangle,48              # 172e
        lnop                                            # 172o pairing

        fma     $inverse_5,$t_e_4,$t_y_6,$t_y_6         # 173e
        lqd     $slope_12,512($a_shear)                 # 173o

        fm      $u_8,$u_3,$inverse_2                    # 174e
        lqd     $slope_13,528($a_shear)                 # 174o

        fm      $u_9,$u_11,$inverse_3                   # 175e
        lqd     $slope_10,544($a_shear)                 # 175o

        fm      $v_7,$v,$inverse_2                      # 176e
        lqd     $slope_11,560($a_shear)                 # 176o

        fm      $u_10,$u,$inverse_4                     # 177e
next_triangle_back:
        brnz    $chunk,next_triangle                    # 177o

next_triangle_drain:
        fm      $u,$u_7,$inverse_5                      # 0e
        fm      $v,$v_5,$inverse_3                      # 1e

        fm      $n,$u_8,$za_4                           # 2e
        fm      $n_2,$u_9,$za_3                         # 3e

        fm      $v_8,$v_2,$inverse_4                    # 4e
        fm      $n_3,$u_10,$za_2                        # 5e

        fm      $v_3,$v_6,$inverse_5                    # 6e
        fm      $n_4,$u,$za_5                           # 7e

        fm      $w,$w,$inverse_2                        # 8e
        fma     $n,$v_7,$zb_2,$n                        # 9e

        fm      $w_2,$w_5,$inverse_3                    # 10e
        fma     $n_2,$v,$zb_4,$n_2                      # 11e

        fm      $w_8,$w_6,$inverse_4                    # 12e
        fma     $n_3,$v_8,$zb_3,$n_3                    # 13e

        fm      $w_9,$w_7,$inverse_5                    # 14e
        fma     $n_4,$v_3,$zb_5,$n_4                    # 15e

        fma     $n,$w,$zc_6,$n                          # 16e
        fma     $n_2,$w_2,$zc_4,$n_2                    # 17e

        or      $outside,$u_8,$v_7                      # 18e
        fma     $n_3,$w_8,$zc_7,$n_3                    # 19e

        or      $outside_2,$u_9,$v                      # 20e
        fma     $n_4,$w_9,$zc_9,$n_4                    # 21e

        fm      $n,$n,$slope_12                         # 22e
        fm      $n_2,$n_2,$slope_13                     # 23e

        or      $outside_3,$u_10,$v_8                   # 24e
        fm      $n_3,$n_3,$slope_10                     # 25e

        or      $outside_4,$u,$v_3                      # 26e
        fm      $n_4,$n_4,$slope_11                     # 27e

        or      $outside,$outside,$w                    # 28e
        cgt     $hit_2,$n_far,$n                        # 29e 0 < t < t_far

        or      $outside_5,$outside_2,$w_2              # 30e
        cgt     $hit_3,$n_far+1,$n_2                    # 31e 0 < t < t_far

        or      $outside_3,$outside_3,$w_8              # 32e
        cgt     $hit,$n_far+2,$n_3                      # 33e 0 < t < t_far

        or      $outside_4,$outside_4,$w_9              # 34e
        cgt     $hit_4,$n_far+3,$n_4                    # 35e 0 < t < t_far

        andc    $hit_5,$hit_2,$outside                  # 36e
        andc    $hit_3,$hit_3,$outside_5                # 37e

        andc    $hit,$hit,$outside_3                    # 38e
        andc    $hit_6,$hit_4,$outside_4                # 39e

        or      $blocked,$blocked,$hit_5                # 40e
        or      $blocked+1,$blocked+1,$hit_3            # 41e

        or      $blocked+2,$blocked+2,$hit              # 42e
        lnop                                            # 42o pairing

        or      $blocked+3,$blocked+3,$hit_6            # 43e
        shufb   $done,$blocked,$blocked+1,$m_rows       # 43o

        shufb   $low,$blocked+2,$blocked+3,$m_rows      # 45o
        shufb   $done,$done,$low,$m_code                # 49o

        rotqbii $done,$done,1                           # 53o
        gbb     $done,$done                             # 57o

        nop     $127                                    # 58e pairing
        br      next_chunk                              # 58o

return:
        xor     $a_rays,$done,$idle                     # 0e
        bi      $lr                                     # 0o

next_triangle_short:
        ai      $chunk,$chunk,-1                        # 0e
        lqd     $vertex_a,0($a_triangle)                # 0o

        lqd     $vertex_b,16($a_triangle)               # 1o
        lqd     $vertex_c,32($a_triangle)               # 2o

        ai      $a_triangle,$a_triangle,48              # 3e
        lqd     $axis,0($a_shear)                       # 3o

        lqd     $axis_14,64($a_shear)                   # 4o
        lqd     $axis_15,128($a_shear)                  # 5o

        lqd     $axis_8,16($a_shear)                    # 6o
        lqd     $axis_9,80($a_shear)                    # 7o

        lqd     $axis_13,144($a_shear)                  # 8o
        lqd     $origin,192($a_shear)                   # 9o

        lqd     $origin_18,256($a_shear)                # 10o
        lqd     $origin_19,320($a_shear)                # 11o

        lqd     $origin_20,208($a_shear)                # 12o
        lqd     $origin_21,272($a_shear)                # 13o

        lqd     $origin_22,336($a_shear)                # 14o
        shufb   $xb_11,$vertex_b,$vertex_b,$axis        # 15o

        shufb   $xc,$vertex_c,$vertex_c,$axis           # 16o
        shufb   $ya_5,$vertex_a,$vertex_a,$axis_14      # 17o

        nop     $127                                    # 18e pairing
        shufb   $yc,$vertex_c,$vertex_c,$axis_14        # 18o

        fs      $xb_11,$xb_11,$origin                   # 19e
        shufb   $za_6,$vertex_a,$vertex_a,$axis_15      # 19o

        fs      $xc,$xc,$origin                         # 20e
        shufb   $zb_6,$vertex_b,$vertex_b,$axis_15      # 20o

        fs      $ya_5,$ya_5,$origin_18                  # 21e
        shufb   $zc_14,$vertex_c,$vertex_c,$axis_15     # 21o

        fs      $yc,$yc,$origin_18                      # 22e
        shufb   $xb_12,$vertex_b,$vertex_b,$axis_8      # 22o

        fs      $za_6,$za_6,$origin_19                  # 23e
        shufb   $xc_10,$vertex_c,$vertex_c,$axis_8      # 23o

        fs      $zb_6,$zb_6,$origin_19                  # 24e
        shufb   $ya_12,$vertex_a,$vertex_a,$axis_9      # 24o

        fs      $zc_14,$zc_14,$origin_19                # 25e
        shufb   $yc_8,$vertex_c,$vertex_c,$axis_9       # 25o

        fs      $xb_12,$xb_12,$origin_20                # 26e
        shufb   $za_7,$vertex_a,$vertex_a,$axis_13      # 26o

        fs      $xc_10,$xc_10,$origin_20                # 27e
        shufb   $zb_7,$vertex_b,$vertex_b,$axis_13      # 27o

        fs      $ya_12,$ya_12,$origin_21                # 28e
        shufb   $zc_10,$vertex_c,$vertex_c,$axis_13     # 28o

        fs      $yc_8,$yc_8,$origin_21                  # 29e
        lqd     $slope_17,384($a_shear)                 # 29o

        fs      $za_7,$za_7,$origin_22                  # 30e
        lqd     $slope_16,448($a_shear)                 # 30o

        fs      $zb_7,$zb_7,$origin_22                  # 31e
        lqd     $slope_18,400($a_shear)                 # 31o

        fs      $zc_10,$zc_10,$origin_22                # 32e
        lqd     $slope_5,464($a_shear)                  # 32o

        shufb   $xa_6,$vertex_a,$vertex_a,$axis         # 33o
        shufb   $yb_8,$vertex_b,$vertex_b,$axis_14      # 34o

        fnms    $xb_11,$slope_17,$zb_6,$xb_11           # 35e
        shufb   $xa_7,$vertex_a,$vertex_a,$axis_8       # 35o

        fnms    $xc,$slope_17,$zc_14,$xc                # 36e
        shufb   $yb_3,$vertex_b,$vertex_b,$axis_9       # 36o

        fs      $xa_6,$xa_6,$origin                     # 37e
        lqd     $axis_12,32($a_shear)                   # 37o

        fs      $yb_8,$yb_8,$origin_18                  # 38e
        lqd     $axis_16,96($a_shear)                   # 38o

        fnms    $ya_5,$slope_16,$za_6,$ya_5             # 39e
        lqd     $axis_17,160($a_shear)                  # 39o

        fnms    $yc,$slope_16,$zc_14,$yc                # 40e
        lqd     $axis_18,48($a_shear)                   # 40o

        fs      $xa_7,$xa_7,$origin_20                  # 41e
        lqd     $axis_19,112($a_shear)                  # 41o

        fs      $yb_3,$yb_3,$origin_21                  # 42e
        lqd     $axis_3,176($a_shear)                   # 42o

        fnms    $xb_12,$slope_18,$zb_7,$xb_12           # 43e
        lqd     $origin_23,224($a_shear)                # 43o

        fnms    $xc_10,$slope_18,$zc_10,$xc_10          # 44e
        lqd     $origin_8,288($a_shear)                 # 44o

        fnms    $ya_12,$slope_5,$za_7,$ya_12            # 45e
        lqd     $origin_14,352($a_shear)                # 45o

        fnms    $yc_8,$slope_5,$zc_10,$yc_8             # 46e
        lqd     $origin_9,240($a_shear)                 # 46o

        fnms    $xa_6,$slope_17,$za_6,$xa_6             # 47e
        lqd     $origin_10,304($a_shear)                # 47o

        fnms    $yb_8,$slope_16,$zb_6,$yb_8             # 48e
        lqd     $origin_2,368($a_shear)                 # 48o

        fm      $p_15,$yc,$xb_11                        # 49e
        shufb   $xb_13,$vertex_b,$vertex_b,$axis_12     # 49o

        fm      $p_16,$ya_5,$xc                         # 50e
        shufb   $xc_11,$vertex_c,$vertex_c,$axis_12     # 50o

        fnms    $xa_7,$slope_18,$za_7,$xa_7             # 51e
        shufb   $ya_13,$vertex_a,$vertex_a,$axis_16     # 51o

        fnms    $yb_3,$slope_5,$zb_7,$yb_3              # 52e
        shufb   $yc_7,$vertex_c,$vertex_c,$axis_16      # 52o

        fm      $p_13,$yc_8,$xb_12                      # 53e
        shufb   $za_8,$vertex_a,$vertex_a,$axis_17      # 53o

        fm      $p_17,$ya_12,$xc_10                     # 54e
        shufb   $zb_2,$vertex_b,$vertex_b,$axis_17      # 54o

        fs      $xb_13,$xb_13,$origin_23                # 55e
        shufb   $zc_15,$vertex_c,$vertex_c,$axis_17     # 55o

        fs      $xc_11,$xc_11,$origin_23                # 56e
        shufb   $xb_2,$vertex_b,$vertex_b,$axis_18      # 56o

        fs      $ya_13,$ya_13,$origin_8                 # 57e
        shufb   $xc_3,$vertex_c,$vertex_c,$axis_18      # 57o

        fs      $yc_7,$yc_7,$origin_8                   # 58e
        shufb   $ya_4,$vertex_a,$vertex_a,$axis_19      # 58o

        fs      $za_8,$za_8,$origin_14                  # 59e
        shufb   $yc_9,$vertex_c,$vertex_c,$axis_19      # 59o

        fs      $zb_2,$zb_2,$origin_14                  # 60e
        shufb   $za_9,$vertex_a,$vertex_a,$axis_3       # 60o

        fs      $zc_15,$zc_15,$origin_14                # 61e
        shufb   $zb_8,$vertex_b,$vertex_b,$axis_3       # 61o

        fs      $xb_2,$xb_2,$origin_9                   # 62e
        shufb   $zc_13,$vertex_c,$vertex_c,$axis_3      # 62o

        fs      $xc_12,$xc_3,$origin_9                  # 63e
        lqd     $slope_19,416($a_shear)                 # 63o

        fs      $ya_4,$ya_4,$origin_10                  # 64e
        lqd     $slope_20,480($a_shear)                 # 64o

        fs      $yc_9,$yc_9,$origin_10                  # 65e
        lqd     $slope_21,432($a_shear)                 # 65o

        fs      $za_9,$za_9,$origin_2                   # 66e
        lqd     $slope_22,496($a_shear)                 # 66o

        fs      $zb_8,$zb_8,$origin_2                   # 67e
        shufb   $xa_8,$vertex_a,$vertex_a,$axis_12      # 67o

        fs      $zc_13,$zc_13,$origin_2                 # 68e
        shufb   $yb_9,$vertex_b,$vertex_b,$axis_16      # 68o

        fms     $q_16,$yc,$xb_11,$p_15                  # 69e
        shufb   $xa_5,$vertex_a,$vertex_a,$axis_18      # 69o

        fms     $u_13,$xc,$yb_8,$p_15                   # 70e
        shufb   $yb_5,$vertex_b,$vertex_b,$axis_19      # 70o

        fms     $q_17,$ya_5,$xc,$p_16                   # 71e
        lqd     $slope_23,512($a_shear)                 # 71o

        fms     $v_6,$xa_6,$yc,$p_16                    # 72e
        lqd     $slope_12,528($a_shear)                 # 72o

        fm      $p_16,$yb_8,$xa_6                       # 73e
        lqd     $slope_24,544($a_shear)                 # 73o

        fms     $q_18,$yc_8,$xb_12,$p_13                # 74e
        lqd     $slope_25,560($a_shear)                 # 74o

        fms     $u_14,$xc_10,$yb_3,$p_13                # 75e
        fms     $q,$ya_12,$xc_10,$p_17                  # 76e

        fms     $v_9,$xa_7,$yc_8,$p_17                  # 77e
        fm      $p_17,$yb_3,$xa_7                       # 78e

        fs      $xa_8,$xa_8,$origin_23                  # 79e
        fs      $yb_9,$yb_9,$origin_8                   # 80e

        fnms    $xb_14,$slope_19,$zb_2,$xb_13           # 81e
        fnms    $xc_13,$slope_19,$zc_15,$xc_11          # 82e

        fnms    $ya_13,$slope_20,$za_8,$ya_13           # 83e
        fnms    $yc_7,$slope_20,$zc_15,$yc_7            # 84e

        fs      $xa_5,$xa_5,$origin_9                   # 85e
        fs      $yb_5,$yb_5,$origin_10                  # 86e

        fnms    $xb_9,$slope_21,$zb_8,$xb_2             # 87e
        fnms    $xc_12,$slope_21,$zc_13,$xc_12          # 88e

        fnms    $ya_14,$slope_22,$za_9,$ya_4            # 89e
        fnms    $yc_10,$slope_22,$zc_13,$yc_9           # 90e

        fs      $u_12,$u_13,$q_16                       # 91e
        fs      $v_10,$v_6,$q_17                        # 92e

        fms     $q_9,$yb_8,$xa_6,$p_16                  # 93e
        fms     $w_12,$xb_11,$ya_5,$p_16                # 94e

        fs      $u_15,$u_14,$q_18                       # 95e
        fs      $v_9,$v_9,$q                            # 96e

        fms     $q,$yb_3,$xa_7,$p_17                    # 97e
        fms     $w_13,$xb_12,$ya_12,$p_17               # 98e

        fnms    $xa_9,$slope_19,$za_8,$xa_8             # 99e
        fnms    $yb_9,$slope_20,$zb_2,$yb_9             # 100e

        fm      $p,$yc_7,$xb_14                         # 101e
        fm      $p_18,$ya_13,$xc_13                     # 102e

        fnms    $xa_5,$slope_21,$za_9,$xa_5             # 103e
        fnms    $yb_5,$slope_22,$zb_8,$yb_5             # 104e

        fm      $p_8,$yc_10,$xb_9                       # 105e
        fm      $p_19,$ya_14,$xc_12                     # 106e

        fs      $w_14,$w_12,$q_9                        # 107e
        fa      $det_7,$u_12,$v_10                      # 108e

        fs      $w_13,$w_13,$q                          # 109e
        fa      $det_8,$u_15,$v_9                       # 110e

        fms     $q_19,$yc_7,$xb_14,$p                   # 111e
        fms     $u_16,$xc_13,$yb_9,$p                   # 112e

        fms     $q_20,$ya_13,$xc_13,$p_18               # 113e
        fms     $v_2,$xa_9,$yc_7,$p_18                  # 114e

        fm      $p_18,$yb_9,$xa_9                       # 115e
        fms     $q_21,$yc_10,$xb_9,$p_8                 # 116e

        fms     $u_17,$xc_12,$yb_5,$p_8                 # 117e
        fms     $q_22,$ya_14,$xc_12,$p_19               # 118e

        fms     $v_11,$xa_5,$yc_10,$p_19                # 119e
        fm      $p_20,$yb_5,$xa_5                       # 120e

        fa      $det_7,$det_7,$w_14                     # 121e
        fa      $det_8,$det_8,$w_13                     # 122e

        fs      $u,$u_16,$q_19                          # 123e
        fs      $v_2,$v_2,$q_20                         # 124e

        fms     $q_23,$yb_9,$xa_9,$p_18                 # 125e
        fms     $w_15,$xb_14,$ya_13,$p_18               # 126e

        fs      $u_18,$u_17,$q_21                       # 127e
        frest   $t_y,$det_7                             # 127o

        fs      $v_12,$v_11,$q_22                       # 128e
        frest   $t_y_7,$det_8                           # 128o

        fms     $q_11,$yb_5,$xa_5,$p_20                 # 129e
        fms     $w_4,$xb_9,$ya_14,$p_20                 # 130e

        fa      $det,$u,$v_2                            # 131e
        fs      $w_3,$w_15,$q_23                        # 132e

        fi      $t_y,$det_7,$t_y                        # 133e
        fi      $t_y_8,$det_8,$t_y_7                    # 134e

        fs      $w_16,$w_4,$q_11                        # 136e
        fa      $det_9,$u_18,$v_12                      # 137e

        fa      $det,$det,$w_3                          # 138e
        fnms    $t_e_5,$det_7,$t_y,$k_above_one         # 140e

        fnms    $t_e_6,$det_8,$t_y_8,$k_above_one       # 141e
        fa      $det_9,$det_9,$w_16                     # 143e

        frest   $t_y_9,$det                             # 144o
        fma     $inverse_2,$t_e_5,$t_y,$t_y             # 146e

        fma     $inverse_6,$t_e_6,$t_y_8,$t_y_8         # 147e
        fi      $t_y,$det,$t_y_9                        # 148e

        frest   $t_y_7,$det_9                           # 149o
        fm      $u_19,$u_12,$inverse_2                  # 152e

        fi      $t_y_7,$det_9,$t_y_7                    # 153e
        fm      $u_15,$u_15,$inverse_6                  # 155e

        fnms    $t_e_7,$det,$t_y,$k_above_one           # 156e
        fm      $v_10,$v_10,$inverse_2                  # 157e

        fm      $n,$u_19,$za_6                          # 158e
        fm      $v_9,$v_9,$inverse_6                    # 159e

        fnms    $t_e_8,$det_9,$t_y_7,$k_above_one       # 160e
        fm      $n_5,$u_15,$za_7                        # 161e

        fma     $inverse,$t_e_7,$t_y,$t_y               # 162e
        fm      $w_14,$w_14,$inverse_2                  # 163e

        fma     $n,$v_10,$zb_6,$n                       # 164e
        fm      $w_13,$w_13,$inverse_6                  # 165e

        fma     $inverse_6,$t_e_8,$t_y_7,$t_y_7         # 166e
        fma     $n_6,$v_9,$zb_7,$n_5                    # 167e

        fm      $u,$u,$inverse                          # 168e
        fm      $v,$v_2,$inverse                        # 169e

        fma     $n,$w_14,$zc_14,$n                      # 170e
        fm      $w,$w_3,$inverse                        # 171e

        fm      $u_6,$u_18,$inverse_6                   # 172e
        fma     $n_3,$w_13,$zc_10,$n_6                  # 173e

        fm      $n_7,$u,$za_8                           # 174e
        fm      $v_13,$v_12,$inverse_6                  # 175e

        fm      $n,$n,$slope_23                         # 176e
        fm      $w_15,$w_16,$inverse_6                  # 177e

        fm      $n_8,$u_6,$za_9                         # 178e
        fm      $n_3,$n_3,$slope_12                     # 179e

        fma     $n_7,$v,$zb_2,$n_7                      # 180e
        or      $outside,$u_19,$v_10                    # 181e

        or      $outside_6,$u_15,$v_9                   # 182e
        or      $outside,$outside,$w_14                 # 183e

        fma     $n_2,$v_13,$zb_8,$n_8                   # 184e
        cgt     $hit,$n_far,$n                          # 185e 0 < t < t_far

        or      $outside_7,$outside_6,$w_13             # 186e
        cgt     $hit_7,$n_far+1,$n_3                    # 187e 0 < t < t_far

        andc    $hit,$hit,$outside                      # 188e
        andc    $hit_8,$hit_7,$outside_7                # 189e

        fma     $n,$w,$zc_15,$n_7                       # 190e
        fma     $n_2,$w_15,$zc_13,$n_2                  # 191e

        or      $blocked,$blocked,$hit                  # 192e
        lnop                                            # 192o pairing

        or      $blocked+1,$blocked+1,$hit_8            # 193e
        hbrr    next_triangle_short_back,next_triangle_short # 193o hint

        or      $outside,$u,$v                          # 194e
        or      $outside_3,$u_6,$v_13                   # 195e

        fm      $n,$n,$slope_24                         # 196e
        fm      $n_2,$n_2,$slope_25                     # 197e

        or      $outside,$outside,$w                    # 198e
        or      $outside_3,$outside_3,$w_15             # 199e

        cgt     $hit,$n_far+2,$n                        # 202e 0 < t < t_far
        cgt     $hit_3,$n_far+3,$n_2                    # 203e 0 < t < t_far

        andc    $hit,$hit,$outside                      # 204e
        andc    $hit_3,$hit_3,$outside_3                # 205e

        or      $blocked+2,$blocked+2,$hit              # 206e
        or      $blocked+3,$blocked+3,$hit_3            # 207e

        nop     $127                                    # 208e pairing
next_triangle_short_back:
        brnz    $chunk,next_triangle_short              # 208o

        shufb   $done,$blocked,$blocked+1,$m_rows       # 209o
        shufb   $low,$blocked+2,$blocked+3,$m_rows      # 210o

        shufb   $done,$done,$low,$m_code                # 214o
        rotqbii $done,$done,1                           # 218o

        gbb     $done,$done                             # 222o
        br      next_chunk                              # 223o
endfunction any_triangles_r16
