# isect_triangle_mt_pairs_r16   nearest hit of packets' rays and triangles, after Moeller, Trumbore
#   C       void isect_triangle_mt_pairs_r16(const struct candidate *, int count);
#   In      $3 candidates of objects that are triangles, their shears not looked at, $4 count (0 is
#           none); pointers 16-aligned
#   Out     the candidates' packets: t, object, where a hit has 0 < t < what was there
#   Uses    $2-$79   Saves  -   Stack  0   Calls  -
#   Domain  |direction| about 1; edges and distances from the vertices between 2^-30 and 2^30
#   Error   24 ulp of t, 2e-4 in barycentric coordinates; edges from 1/100 of the distance to all of
#           it, area across the ray above 1/20 of their square
#   Twin    oracle/src/twin/triangle_mt_pairs.rs
#
# Moeller and Trumbore 1997: with edges e1 and e2 from vertex a, s from there to the origin, and
# determinant e1.(d x e2), u is s.(d x e2), v is d.(s x e1), t is e2.(s x e1), each by the
# determinant. Both cross products are taken the other way round, so that the determinant's sign is
# set where the vertices go counter-clockwise. From behind a triangle is hit only with SIDES_BOTH. A
# ray along the plane gets a t that is 0 or beyond everything: no hit.
#
# Not watertight: each triangle works a shared edge out from a vertex and edges of its own, and what
# one rounds off the other does not take. Of rays from inside a closed mesh that are aimed at its
# edges and vertices one in 10 gets out; one in 40 where vertices lie on a lattice, whose products
# are exact more often (kernels/tests/flat/leaks.rs, where none gets past isect_triangle_pairs_r16).
# Scheduled by spu schedule from isect_triangle_mt_pairs_r16.s

        .include "work_unit.inc"
        .include "macros.inc"
        .include "pairs.inc"
        .include "vectors.inc"

        .set    a_candidate,3
        .set    count,4
        # constants
        .set    k_one,10
        .set    k_zero,11
        .set    k_sign,12
        .set    m_x,13
        .set    m_y,14
        .set    m_z,15
        .set    m_w,16
        .set    a_controls,17
        # the candidate
        .set    object,18
        .set    a_packet,19
        .set    both,20
        .set    vertex,21
        .set    edge_1,22
        .set    edge_2,23
        .set    a_x,24
        .set    a_y,25
        .set    a_z,26
        .set    e1_x,27
        .set    e1_y,28
        .set    e1_z,29
        .set    e2_x,30
        .set    e2_y,31
        .set    e2_z,32
        # temporaries
        .set    s_x,33
        .set    s_y,34
        .set    s_z,35
        .set    d_x,36
        .set    d_y,37
        .set    d_z,38
        .set    p_x,39
        .set    p_y,40
        .set    p_z,41
        .set    q_x,42
        .set    q_y,43
        .set    q_z,44
        .set    det,45
        .set    inverse,46
        .set    t_y,47
        .set    t_e,48
        .set    u,49
        .set    v,50
        .set    w,51
        .set    n,52
        .set    ahead,52                                # n
        .set    outside,53
        .set    seen,54
        .set    t,55
        .set    t_best,56
        .set    nearest,57
        .set    control,58

        sign_controls_table

# out = component z of a x b, where x, y, z are in order.
.macro  cross_component out:req, a:req, b:req, x:req, y:req
        fm      \out,$\a\()_\y,$\b\()_\x
        fms     \out,$\a\()_\x,$\b\()_\y,\out
.endm

.macro  cross_f4 out:req, a:req, b:req
        cross_component $\out\()_x,\a,\b,y,z
        cross_component $\out\()_y,\a,\b,z,x
        cross_component $\out\()_z,\a,\b,x,y
.endm

# A vector of the candidate, each component in every lane.
.macro  splat_vector out:req, vector:req
    .irp axis, x,y,z
        shufb   $\out\()_\axis,\vector,\vector,$m_\axis
    .endr
.endm

function isect_triangle_mt_pairs_r16
        .set    count_2,79
        .set    edge_1_2,8
        .set    both_2,60
        .set    object_2,74
        .set    d_y_2,25
        .set    d_y_3,26
        .set    d_y_4,33
        .set    d_z_2,24
        .set    d_z_3,27
        .set    d_z_4,28
        .set    e2_y_2,23
        .set    p_x_2,44
        .set    d_x_2,51
        .set    p_x_3,41
        .set    d_x_3,35
        .set    p_x_4,47
        .set    d_x_4,42
        .set    p_y_2,43
        .set    e1_x_2,2
        .set    e1_y_2,48
        .set    s_y_2,45
        .set    p_y_3,31
        .set    a_y_2,29
        .set    p_y_4,52
        .set    s_y_3,5
        .set    s_y_4,70
        .set    e1_z_2,46
        .set    s_x_2,64
        .set    p_z_2,6
        .set    s_z_2,71
        .set    det_2,67
        .set    s_z_3,50
        .set    s_z_4,53
        .set    a_x_2,54
        .set    p_z_3,49
        .set    a_z_2,21
        .set    p_z_4,59
        .set    s_z_5,61
        .set    det_3,62
        .set    s_x_3,63
        .set    p_z_5,65
        .set    s_x_4,69
        .set    det_4,66
        .set    s_x_5,72
        .set    det_5,7
        .set    t_best_2,68
        .set    t_best_3,77
        .set    t_best_4,79
        .set    a_packet_2,76
        .set    det_6,8
        .set    s_y_5,29
        .set    t_y_2,8
        .set    s_z_6,9
        .set    q_x_2,20
        .set    t_y_3,22
        .set    t_y_4,18
        .set    t_y_5,21
        .set    q_x_3,55
        .set    q_x_4,58
        .set    s_x_6,71
        .set    q_x_5,56
        .set    s_x_7,54
        .set    t_y_6,57
        .set    seen_2,75
        .set    q_y_2,18
        .set    u_2,44
        .set    q_y_3,73
        .set    q_y_4,70
        .set    u_3,39
        .set    q_y_5,69
        .set    u_4,41
        .set    u_5,47
        .set    t_e_2,78
        .set    v_2,51
        .set    q_z_2,64
        .set    u_6,43
        .set    v_3,36
        .set    ahead_2,20
        .set    q_y_6,40
        .set    v_4,35
        .set    t_e_3,46
        .set    u_7,31
        .set    q_z_3,47
        .set    v_5,42
        .set    q_z_4,48
        .set    t_e_4,52
        .set    t_e_5,54
        .set    q_z_5,45
        .set    v_6,25
        .set    ahead_3,51
        .set    u_8,6
        .set    inverse_2,8
        .set    q_z_6,9
        .set    v_7,26
        .set    ahead_4,29
        .set    ahead_5,30
        .set    u_9,35
        .set    ahead_6,5
        .set    q_z_7,2
        .set    inverse_3,18
        .set    inverse_4,20
        .set    ahead_7,21
        .set    v_8,22
        .set    ahead_8,26
        .set    u_10,27
        .set    v_9,24
        .set    u_11,23
        .set    ahead_9,9
        .set    v_10,21
        .set    w_2,22
        .set    v_11,28
        .set    w_3,29
        .set    ahead_10,2
        .set    w_4,30
        .set    w_5,8
        .set    ahead_11,24
        .set    w_6,2
        .set    t_2,70
        .set    w_7,9
        .set    outside_2,5
        .set    seen_3,69
        .set    seen_4,72
        .set    outside_3,25
        .set    outside_4,21
        .set    outside_5,27
        .set    t_3,78
        .set    control_2,28
        .set    outside_6,2
        .set    nearest_2,5
        .set    nearest_3,6
        .set    control_3,7
        .set    outside_7,8
        .set    nearest_4,9
        .set    t_4,20
        .set    control_4,22
        .set    control_5,2
        .set    outside_8,7
        .set    e1_x_3,8
        .set    t_best_5,67
        .set    s_y_6,68
        .set    det_7,69
        .set    p_z_6,70
        .set    p_z_7,5
        .set    t_best_6,58
        .set    s_z_7,21
        .set    q_x_6,6
        .set    t_y_7,72
        .set    t_y_8,74
        .set    q_x_7,9
        .set    t_best_7,2
        .set    t_y_9,55
        .set    u_12,2
        .set    q_y_7,39
        .set    q_y_8,58
        .set    q_z_8,18
        .set    t_y_10,40
        .set    ahead_12,77
        .set    v_12,20
        .set    t_e_6,7
        .set    ahead_13,6
        .set    q_y_9,31
        .set    u_13,29
        .set    q_z_9,35
        .set    q_z_10,41
        .set    q_z_11,37
        .set    v_13,7
        .set    q_z_12,8
        .set    u_14,22
        .set    ahead_14,25
        .set    inverse_5,26
        .set    u_15,5
        .set    inverse_6,21
        .set    inverse_7,27
        .set    ahead_15,8
        .set    v_14,9
        .set    v_15,23
        .set    ahead_16,18
        .set    w_8,20
        .set    w_9,24
        .set    w_10,21
        .set    w_11,6
        .set    t_5,3
        .set    control_6,4
        .set    d_y_5,2
        .set    d_z_5,5
        .set    d_x_5,6
        .set    d_y_6,7
        .set    d_y_7,8
        .set    p_x_5,9
        .set    d_z_6,23
        .set    p_y_5,24
        .set    d_z_7,25
        .set    p_x_6,26
        .set    d_x_6,33
        .set    a_y_3,35
        .set    s_z_8,42
        .set    s_x_8,43
        .set    p_z_8,44
        .set    e1_z_3,22
        .set    p_x_7,45
        .set    s_x_9,46
        .set    det_8,47
        .set    s_z_9,48
        .set    det_9,49
        .set    d_x_7,50
        .set    p_y_6,51
        .set    a_x_3,52
        .set    s_y_7,53
        .set    s_y_8,54
        .set    s_z_10,55
        .set    s_x_10,56
        .set    s_x_11,57
        .set    p_y_7,58
        .set    s_z_11,59
        .set    t_best_8,60
        .set    det_10,61
        .set    t_best_9,62
        .set    t_best_10,63
        .set    det_11,64
        .set    t_best_11,65
        .set    p_z_9,66
        .set    nearest_5,67
        .set    q_x_8,68
        .set    nearest_6,69
        .set    nearest_7,70
        .set    t_y_11,71
        .set    nearest_8,72
        .set    q_x_9,73
        .set    p_z_10,75
        .set    u_16,9
        .set    seen_5,76
        .set    q_y_10,77
        .set    q_y_11,78
        .set    s_y_9,35
        .set    t_e_7,49
        .set    v_16,6
        .set    det_12,54
        .set    t_e_8,61
        .set    q_z_13,46
        .set    q_x_10,79
        .set    s_z_12,24
        .set    q_z_14,43
        .set    ahead_17,73
        .set    s_x_12,52
        .set    q_z_15,34
        .set    ahead_18,56
        .set    v_17,2
        .set    seen_6,47
        .set    q_z_16,29
        .set    u_17,26
        .set    inverse_8,41
        .set    q_y_12,44
        .set    ahead_19,37
        .set    q_y_13,5
        .set    ahead_20,38
        .set    v_18,33
        .set    ahead_21,34
        .set    t_e_9,37
        .set    u_18,38
        .set    ahead_22,39
        .set    q_z_17,22
        .set    w_12,7
        .set    inverse_9,30
        .set    u_19,8
        .set    inverse_10,24
        .set    t_6,7
        .set    control_7,21
        .set    t_7,21
        .set    t_8,22
        .set    control_8,23
        .set    outside_9,6
        .set    seen_7,8
        .set    control_9,9
        .set    control_10,5
        .set    t_best_12,7
        .set    control_11,6
        .set    nearest_9,2
        nop     $127                                    # 0e pairing
        biz     $count,$lr                              # 0o

        ilhu    $m_x,1                                  # 1e
        ilhu    $m_y,0x405                              # 2e

        ilhu    $m_z,0x809                              # 3e
        ilhu    $m_w,0xc0d                              # 4e

        clgti   $count_2,$count,1                       # 5e at least as many passes as overlap
        iohl    $m_x,515                                # 6e

        iohl    $m_y,0x607                              # 7e
        iohl    $m_z,0xa0b                              # 8e

        iohl    $m_w,0xe0f                              # 9e
        ilhu    $k_one,0x3f80                           # 10e

        il      $k_zero,0                               # 11e
        ilhu    $k_sign,0x8000                          # 12e

        ila     $a_controls,sign_controls               # 13e
        brz     $count_2,next_triangle_short            # 13o too few passes

        ai      $count,$count,-1                        # 14e
        lqd     $object,0($a_candidate)                 # 14o

        ai      $a_candidate,$a_candidate,16            # 15e
        lqd     $vertex,48($object)                     # 20o

        lqd     $edge_2,80($object)                     # 21o
        rotqbyi $a_packet,$object,4                     # 22o

        lqd     $edge_1_2,64($object)                   # 23o
        lqd     $both_2,32($object)                     # 24o

        shufb   $object_2,$object,$object,$m_x          # 25o
        lqd     $d_y_2,272($a_packet)                   # 26o

        fs      $edge_2,$edge_2,$vertex                 # 27e
        lqd     $d_y,256($a_packet)                     # 27o

        nop     $127                                    # 28e pairing
        lqd     $d_y_3,304($a_packet)                   # 28o

        fs      $edge_1_2,$edge_1_2,$vertex             # 29e
        lqd     $d_y_4,288($a_packet)                   # 29o

        lqd     $d_z,336($a_packet)                     # 30o
        lqd     $d_z_2,320($a_packet)                   # 31o

        lqd     $d_z_3,368($a_packet)                   # 32o
        shufb   $e2_z,$edge_2,$edge_2,$m_z              # 33o

        shufb   $e2_x,$edge_2,$edge_2,$m_x              # 34o
        lqd     $d_z_4,352($a_packet)                   # 35o

        nop     $127                                    # 36e pairing
        shufb   $e2_y_2,$edge_2,$edge_2,$m_y            # 36o

        fm      $p_x_2,$e2_z,$d_y_2                     # 37e
        lqd     $d_x_2,208($a_packet)                   # 37o

        fm      $p_x,$e2_z,$d_y                         # 38e
        lqd     $d_x,192($a_packet)                     # 38o

        fm      $p_x_3,$e2_z,$d_y_3                     # 39e
        lqd     $d_x_3,240($a_packet)                   # 39o

        fm      $p_x_4,$e2_z,$d_y_4                     # 40e
        lqd     $d_x_4,224($a_packet)                   # 40o

        fm      $p_y_2,$e2_x,$d_z                       # 41e
        shufb   $e1_x_2,$edge_1_2,$edge_1_2,$m_x        # 41o

        fm      $p_y,$e2_x,$d_z_2                       # 42e
        shufb   $e1_y_2,$edge_1_2,$edge_1_2,$m_y        # 42o

        fms     $p_x_2,$e2_y_2,$d_z,$p_x_2              # 43e
        lqd     $s_y_2,80($a_packet)                    # 43o

        fm      $p_y_3,$e2_x,$d_z_3                     # 44e
        lqd     $s_y,64($a_packet)                      # 44o

        fms     $p_x_3,$e2_y_2,$d_z_3,$p_x_3            # 45e
        shufb   $a_y_2,$vertex,$vertex,$m_y             # 45o

        fm      $p_y_4,$e2_x,$d_z_4                     # 46e
        lqd     $s_y_3,112($a_packet)                   # 46o

        fms     $p_x_4,$e2_y_2,$d_z_4,$p_x_4            # 47e
        lqd     $s_y_4,96($a_packet)                    # 47o

        fms     $p_x,$e2_y_2,$d_z_2,$p_x                # 48e
        shufb   $e1_z_2,$edge_1_2,$edge_1_2,$m_z        # 48o

        fms     $p_y_2,$e2_z,$d_x_2,$p_y_2              # 49e
        lqd     $s_x_2,16($a_packet)                    # 49o

        fm      $p_z_2,$e2_y_2,$d_x_2                   # 50e
        lqd     $s_z_2,144($a_packet)                   # 50o

        fm      $det_2,$e1_x_2,$p_x_2                   # 51e
        lqd     $s_z_3,128($a_packet)                   # 51o

        fms     $p_y,$e2_z,$d_x,$p_y                    # 52e
        lqd     $s_z_4,176($a_packet)                   # 52o

        fms     $p_y_3,$e2_z,$d_x_3,$p_y_3              # 53e
        shufb   $a_x_2,$vertex,$vertex,$m_x             # 53o

        fm      $p_z_3,$e2_y_2,$d_x                     # 54e
        shufb   $a_z_2,$vertex,$vertex,$m_z             # 54o

        fm      $p_z_4,$e2_y_2,$d_x_4                   # 55e
        lqd     $s_z_5,160($a_packet)                   # 55o

        fm      $det_3,$e1_x_2,$p_x_3                   # 56e
        lqd     $s_x_3,48($a_packet)                    # 56o

        fm      $p_z_5,$e2_y_2,$d_x_3                   # 57e
        lqd     $s_x_4,32($a_packet)                    # 57o

        fm      $det_4,$e1_x_2,$p_x_4                   # 58e
        lqd     $s_x_5,0($a_packet)                     # 58o

        fms     $p_y_4,$e2_z,$d_x_4,$p_y_4              # 59e
        shufb   $both_2,$both_2,$both_2,$m_w            # 59o

        fm      $det_5,$e1_x_2,$p_x                     # 60e
        lqd     $t_best_2,400($a_packet)                # 60o

        fma     $det_2,$e1_y_2,$p_y_2,$det_2            # 61e
        lqd     $t_best_3,416($a_packet)                # 61o

        fms     $p_z_2,$e2_x,$d_y_2,$p_z_2              # 62e
        lqd     $t_best_4,384($a_packet)                # 62o

        fms     $p_z_3,$e2_x,$d_y,$p_z_3                # 63e
        rotqbii $both_2,$both_2,1                       # 63o

        fma     $det_3,$e1_y_2,$p_y_3,$det_3            # 64e
        shlqbyi $a_packet_2,$a_packet,0                 # 64o copy

        fms     $p_z_5,$e2_x,$d_y_3,$p_z_5              # 65e
        fms     $p_z_4,$e2_x,$d_y_4,$p_z_4              # 66e

        fma     $det_6,$e1_y_2,$p_y_4,$det_4            # 67e
        fma     $det_4,$e1_y_2,$p_y,$det_5              # 68e

        fs      $s_y_2,$s_y_2,$a_y_2                    # 69e
        fma     $det_2,$e1_z_2,$p_z_2,$det_2            # 70e

        fs      $s_y_3,$s_y_3,$a_y_2                    # 71e
        fs      $s_y,$s_y,$a_y_2                        # 72e

        fs      $s_y_5,$s_y_4,$a_y_2                    # 73e
        fma     $det_5,$e1_z_2,$p_z_4,$det_6            # 74e

        fma     $det_3,$e1_z_2,$p_z_5,$det_3            # 75e
        lnop                                            # 75o pairing

        fma     $det_4,$e1_z_2,$p_z_3,$det_4            # 76e
        frest   $t_y_2,$det_2                           # 76o

        fs      $s_x_2,$s_x_2,$a_x_2                    # 77e
        fs      $s_z_6,$s_z_2,$a_z_2                    # 78e

        fm      $q_x_2,$e1_z_2,$s_y_2                   # 79e
        lnop                                            # 79o pairing

        fs      $s_z_3,$s_z_3,$a_z_2                    # 80e
        frest   $t_y_3,$det_5                           # 80o

        fs      $s_z_4,$s_z_4,$a_z_2                    # 81e
        frest   $t_y_4,$det_3                           # 81o

        fs      $s_z_5,$s_z_5,$a_z_2                    # 82e
        frest   $t_y_5,$det_4                           # 82o

        fs      $s_x_3,$s_x_3,$a_x_2                    # 83e
        fm      $q_x_3,$e1_z_2,$s_y_3                   # 84e

        fm      $q_x_4,$e1_z_2,$s_y                     # 85e
        fs      $s_x_6,$s_x_5,$a_x_2                    # 86e

        fm      $q_x_5,$e1_z_2,$s_y_5                   # 87e
        fs      $s_x_7,$s_x_4,$a_x_2                    # 88e

        fi      $t_y_2,$det_2,$t_y_2                    # 89e
        fi      $t_y_3,$det_5,$t_y_3                    # 90e

        fi      $t_y_5,$det_4,$t_y_5                    # 91e
        fi      $t_y_6,$det_3,$t_y_4                    # 92e

        or      $seen_2,$det_4,$both_2                  # 93e
        fm      $q_y_2,$e1_x_2,$s_z_6                   # 94e

        fms     $q_x_2,$e1_y_2,$s_z_6,$q_x_2            # 95e
        fm      $u_2,$s_x_2,$p_x_2                      # 96e

        fm      $q_y_3,$e1_x_2,$s_z_3                   # 97e
        fm      $q_y_4,$e1_x_2,$s_z_4                   # 98e

        fms     $q_x_4,$e1_y_2,$s_z_3,$q_x_4            # 99e
        fm      $u_3,$s_x_6,$p_x                        # 100e

        fm      $q_y_5,$e1_x_2,$s_z_5                   # 101e
        fms     $q_x_5,$e1_y_2,$s_z_5,$q_x_5            # 102e

        fms     $q_x_3,$e1_y_2,$s_z_4,$q_x_3            # 103e
        fm      $u_4,$s_x_3,$p_x_3                      # 104e

        fm      $u_5,$s_x_7,$p_x_4                      # 105e
        fnms    $t_e_2,$det_2,$t_y_2,$k_one             # 106e

        fm      $v_2,$d_x_2,$q_x_2                      # 107e
        fms     $q_y_2,$e1_z_2,$s_x_2,$q_y_2            # 108e

        fm      $q_z_2,$e1_y_2,$s_x_2                   # 109e
        fma     $u_6,$s_y_2,$p_y_2,$u_2                 # 110e

        fm      $q_z,$e1_y_2,$s_x_7                     # 111e
        fm      $v_3,$d_x,$q_x_4                        # 112e

        fms     $q_y_4,$e1_z_2,$s_x_3,$q_y_4            # 113e
        fma     $u_3,$s_y,$p_y,$u_3                     # 114e

        fnms    $ahead_2,$e2_x,$q_x_2,$k_zero           # 115e
        fms     $q_y_3,$e1_z_2,$s_x_6,$q_y_3            # 116e

        fms     $q_y_6,$e1_z_2,$s_x_7,$q_y_5            # 117e
        fm      $v_4,$d_x_3,$q_x_3                      # 118e

        fnms    $t_e_3,$det_5,$t_y_3,$k_one             # 119e
        fma     $u_7,$s_y_3,$p_y_3,$u_4                 # 120e

        fma     $u_4,$s_y_5,$p_y_4,$u_5                 # 121e
        fm      $q_z_3,$e1_y_2,$s_x_3                   # 122e

        fm      $v_5,$d_x_4,$q_x_5                      # 123e
        fm      $q_z_4,$e1_y_2,$s_x_6                   # 124e

        fnms    $t_e_4,$det_3,$t_y_6,$k_one             # 125e
        fnms    $t_e_5,$det_4,$t_y_5,$k_one             # 126e

        fms     $q_z_5,$e1_x_2,$s_y_2,$q_z_2            # 127e
        fma     $v_6,$d_y_2,$q_y_2,$v_2                 # 128e

        fnms    $ahead_3,$e2_x,$q_x_5,$k_zero           # 129e
        fma     $u_8,$s_z_6,$p_z_2,$u_6                 # 130e

        fma     $inverse_2,$t_e_2,$t_y_2,$t_y_2         # 131e
        fms     $q_z_6,$e1_x_2,$s_y_5,$q_z              # 132e

        fma     $v_7,$d_y_3,$q_y_4,$v_4                 # 133e
        fma     $u,$s_z_3,$p_z_3,$u_3                   # 134e

        fnms    $ahead_4,$e2_x,$q_x_3,$k_zero           # 135e
        fnms    $ahead_5,$e2_x,$q_x_4,$k_zero           # 136e

        fma     $u_7,$s_z_4,$p_z_5,$u_7                 # 137e
        fma     $u_9,$s_z_5,$p_z_4,$u_4                 # 138e

        fms     $q_z,$e1_x_2,$s_y_3,$q_z_3              # 139e
        fma     $v_3,$d_y,$q_y_3,$v_3                   # 140e

        fma     $inverse,$t_e_3,$t_y_3,$t_y_3           # 141e
        fnms    $ahead_6,$e2_y_2,$q_y_2,$ahead_2        # 142e

        fma     $v,$d_y_4,$q_y_6,$v_5                   # 143e
        fms     $q_z_7,$e1_x_2,$s_y,$q_z_4              # 144e

        fma     $inverse_3,$t_e_4,$t_y_6,$t_y_6         # 145e
        fma     $inverse_4,$t_e_5,$t_y_5,$t_y_5         # 146e

        fnms    $ahead_7,$e2_y_2,$q_y_6,$ahead_3        # 147e
        fma     $v_8,$d_z,$q_z_5,$v_6                   # 148e

        fm      $u_8,$u_8,$inverse_2                    # 149e
        fma     $v_6,$d_z_3,$q_z,$v_7                   # 150e

        fnms    $ahead_8,$e2_y_2,$q_y_4,$ahead_4        # 151e
        fm      $u_10,$u_9,$inverse                     # 152e

        fnms    $ahead,$e2_z,$q_z_5,$ahead_6            # 153e
        fnms    $ahead_6,$e2_y_2,$q_y_3,$ahead_5        # 154e

        fma     $v_9,$d_z_2,$q_z_7,$v_3                 # 155e
        fm      $u_11,$u_7,$inverse_3                   # 156e

        fma     $v,$d_z_4,$q_z_6,$v                     # 157e
        fm      $u,$u,$inverse_4                        # 158e

        fnms    $ahead_9,$e2_z,$q_z_6,$ahead_7          # 159e
        fm      $v_10,$v_8,$inverse_2                   # 160e

        fs      $w_2,$k_one,$u_8                        # 161e
        fs      $w,$k_one,$u_10                         # 162e

        fnms    $ahead_6,$e2_z,$q_z_7,$ahead_6          # 163e
        fm      $v_11,$v_6,$inverse_3                   # 164e

        fm      $v_6,$v_9,$inverse_4                    # 165e
        fs      $w_3,$k_one,$u_11                       # 166e

        fnms    $ahead_10,$e2_z,$q_z,$ahead_8           # 167e
        fs      $w_4,$k_one,$u                          # 168e

        fm      $ahead,$ahead,$inverse_2                # 169e -t
        fm      $v,$v,$inverse                          # 170e

        fs      $w_5,$w_2,$v_10                         # 171e
        fm      $ahead_8,$ahead_9,$inverse              # 172e -t

        fm      $ahead_11,$ahead_10,$inverse_3          # 173e -t
        fs      $w_6,$w_4,$v_6                          # 174e

        xor     $t_2,$ahead,$k_sign                     # 175e
        fs      $w,$w,$v                                # 176e

        fs      $w_7,$w_3,$v_11                         # 177e
        fm      $ahead_2,$ahead_6,$inverse_4            # 178e -t

        cgt     $control,$t_best_2,$t_2                 # 179e
        or      $outside_2,$u_8,$v_10                   # 180e

        or      $seen_3,$det_5,$both_2                  # 181e
        or      $seen_4,$det_3,$both_2                  # 182e

        or      $outside_3,$u,$v_6                      # 183e
        or      $outside,$u_11,$v_11                    # 184e

        or      $outside_4,$u_10,$v                     # 185e
        or      $outside_5,$outside_2,$w_5              # 186e

        xor     $t_3,$ahead_8,$k_sign                   # 187e
        and     $control_2,$control,$ahead              # 188e

next_triangle:
            cgt     $control,$t_best_3,$t_3             # 0e
            lnop                                        # 0o pairing

            or      $outside,$outside,$w_7              # 1e
        lqd     $object,0($a_candidate)                 # 1o

            or      $outside_6,$outside_3,$w_6          # 2e
            lqd     $nearest,496($a_packet)             # 2o

            xor     $t,$ahead_2,$k_sign                 # 3e
            lqd     $nearest_2,464($a_packet)           # 3o

            orc     $outside_6,$outside_6,$seen_2       # 4e
            lqd     $nearest_3,480($a_packet)           # 4o

            cgt     $control_3,$t_best_4,$t             # 5e
            lqd     $t_best,432($a_packet)              # 5o

            or      $outside_7,$outside_4,$w            # 6e
            lqd     $nearest_4,448($a_packet)           # 6o

            and     $control_3,$control_3,$ahead_2      # 7e
        rotqbyi $a_packet,$object,4                     # 7o

            orc     $outside,$outside,$seen_4           # 8e
            lnop                                        # 8o pairing

            xor     $t_4,$ahead_11,$k_sign              # 9e
        lqd     $vertex,48($object)                     # 9o

            or      $seen,$det_2,$both_2                # 10e
        lqd     $edge_2,80($object)                     # 10o

            cgt     $control_4,$t_best,$t_4             # 11e
            orc     $outside_7,$outside_7,$seen_3       # 12e

            and     $control_4,$control_4,$ahead_11     # 13e
            lnop                                        # 13o pairing

            andc    $control_5,$control_3,$outside_6    # 14e
        lqd     $s_y,64($a_packet)                      # 14o

            orc     $outside_8,$outside_5,$seen         # 15e
        lqd     $d_z,336($a_packet)                     # 15o

        fs      $edge_2,$edge_2,$vertex                 # 16e
        lqd     $d_z_2,320($a_packet)                   # 16o

            andc    $control_3,$control_2,$outside_8    # 17e
        lqd     $d_y,256($a_packet)                     # 17o

            andc    $control_4,$control_4,$outside      # 18e
        lqd     $d_y_2,272($a_packet)                   # 18o

            and     $control,$control,$ahead_8          # 19e
        lqd     $d_y_3,304($a_packet)                   # 19o

        ai      $count,$count,-1                        # 20e
            rotqbii $control_3,$control_3,1             # 20o

            andc    $control,$control,$outside_7        # 21e
        lqd     $d_x,192($a_packet)                     # 21o

        ai      $a_candidate,$a_candidate,16            # 22e
        lqd     $edge_1_2,64($object)                   # 22o

        lqd     $d_z_3,368($a_packet)                   # 23o
            gb      $control_3,$control_3               # 24o

        shufb   $e2_x,$edge_2,$edge_2,$m_x              # 25o
        shufb   $e2_z,$edge_2,$edge_2,$m_z              # 26o

        nop     $127                                    # 27e pairing
        lqd     $d_z_4,352($a_packet)                   # 27o

        fs      $edge_1_2,$edge_1_2,$vertex             # 28e
            shlqbii $control_3,$control_3,4             # 28o

        fm      $p_y,$e2_x,$d_z_2                       # 29e
        shufb   $a_y_2,$vertex,$vertex,$m_y             # 29o

        fm      $p_y_3,$e2_x,$d_z_3                     # 30e
        lqd     $d_y_4,288($a_packet)                   # 30o

        fm      $p_x,$e2_z,$d_y                         # 31e
        lqd     $d_x_3,240($a_packet)                   # 31o

        fm      $p_x_3,$e2_z,$d_y_3                     # 32e
        lqd     $d_x_4,224($a_packet)                   # 32o

        fm      $p_y_2,$e2_x,$d_z                       # 33e
        shufb   $e2_y_2,$edge_2,$edge_2,$m_y            # 33o

        fm      $p_x_2,$e2_z,$d_y_2                     # 34e
        lqd     $s_y_2,80($a_packet)                    # 34o

        fms     $p_y,$e2_z,$d_x,$p_y                    # 35e
        shufb   $e1_z_2,$edge_1_2,$edge_1_2,$m_z        # 35o

        fm      $p_x_4,$e2_z,$d_y_4                     # 36e
        shufb   $e1_y_2,$edge_1_2,$edge_1_2,$m_y        # 36o

        fms     $p_y_3,$e2_z,$d_x_3,$p_y_3              # 37e
        shufb   $e1_x_3,$edge_1_2,$edge_1_2,$m_x        # 37o

        fm      $p_z_3,$e2_y_2,$d_x                     # 38e
        lqd     $s_z_3,128($a_packet)                   # 38o

        fms     $p_x_3,$e2_y_2,$d_z_3,$p_x_3            # 39e
        lqd     $d_x_2,208($a_packet)                   # 39o

        fm      $p_y_4,$e2_x,$d_z_4                     # 40e
        lqd     $s_z_4,176($a_packet)                   # 40o

        fms     $p_x_2,$e2_y_2,$d_z,$p_x_2              # 41e
        shufb   $a_x_2,$vertex,$vertex,$m_x             # 41o

        fms     $p_x_4,$e2_y_2,$d_z_4,$p_x_4            # 42e
        shufb   $a_z_2,$vertex,$vertex,$m_z             # 42o

        fm      $p_z_4,$e2_y_2,$d_x_4                   # 43e
        lqd     $both_2,32($object)                     # 43o

        fms     $p_z_3,$e2_x,$d_y,$p_z_3                # 44e
        lqd     $s_z_5,160($a_packet)                   # 44o

        fms     $p_y_2,$e2_z,$d_x_2,$p_y_2              # 45e
            lqx     $control_3,$control_3,$a_controls   # 45o

        fm      $det_3,$e1_x_3,$p_x_3                   # 46e
        lqd     $s_x_3,48($a_packet)                    # 46o

        fms     $p_x,$e2_y_2,$d_z_2,$p_x                # 47e
        lqd     $s_x_2,16($a_packet)                    # 47o

        fs      $s_z_3,$s_z_3,$a_z_2                    # 48e
            rotqbii $control_4,$control_4,1             # 48o

        fs      $s_z_4,$s_z_4,$a_z_2                    # 49e
        shufb   $both_2,$both_2,$both_2,$m_w            # 49o

        fm      $p_z_5,$e2_y_2,$d_x_3                   # 50e
            rotqbii $control_5,$control_5,1             # 50o

        fm      $det_4,$e1_x_3,$p_x_4                   # 51e
            shufb   $t_best_5,$t_best_2,$t_2,$control_3 # 51o

        fms     $p_y_4,$e2_z,$d_x_4,$p_y_4              # 52e
        lqd     $s_y_6,112($a_packet)                   # 52o

        fm      $det_7,$e1_x_3,$p_x                     # 53e
            rotqbii $control,$control,1                 # 53o

        fm      $p_z_6,$e2_y_2,$d_x_2                   # 54e
            gb      $control_4,$control_4               # 54o

        fma     $det_3,$e1_y_2,$p_y_3,$det_3            # 55e
            stqd    $t_best_5,400($a_packet_2)          # 55o

        fm      $det_2,$e1_x_3,$p_x_2                   # 56e
            gb      $control_5,$control_5               # 56o

        fms     $p_z_5,$e2_x,$d_y_3,$p_z_5              # 57e
            gb      $control,$control                   # 57o

        fms     $p_z_4,$e2_x,$d_y_4,$p_z_4              # 58e
            shufb   $nearest_2,$nearest_2,$object_2,$control_3 # 58o

        fma     $det_5,$e1_y_2,$p_y_4,$det_4            # 59e
            shlqbii $control_4,$control_4,4             # 59o

        fma     $det_4,$e1_y_2,$p_y,$det_7              # 60e
        lqd     $s_x_4,32($a_packet)                    # 60o

        fs      $s_z_5,$s_z_5,$a_z_2                    # 61e
            shlqbii $control,$control,4                 # 61o

        fma     $det_2,$e1_y_2,$p_y_2,$det_2            # 62e
            stqd    $nearest_2,464($a_packet_2)         # 62o

        fms     $p_z_7,$e2_x,$d_y_2,$p_z_6              # 63e
            shlqbii $control_5,$control_5,4             # 63o

        fs      $s_x_2,$s_x_2,$a_x_2                    # 64e
        lqd     $s_y_4,96($a_packet)                    # 64o

        fma     $det_5,$e1_z_2,$p_z_4,$det_5            # 65e
            lqx     $control,$control,$a_controls       # 65o

        fma     $det_3,$e1_z_2,$p_z_5,$det_3            # 66e
            lqx     $control_4,$control_4,$a_controls   # 66o

        fs      $s_y_2,$s_y_2,$a_y_2                    # 67e
        lqd     $s_z_2,144($a_packet)                   # 67o

        fs      $s_y_6,$s_y_6,$a_y_2                    # 68e
        lqd     $s_x_5,0($a_packet)                     # 68o

        fma     $det_4,$e1_z_2,$p_z_3,$det_4            # 69e
            lqx     $control_5,$control_5,$a_controls   # 69o

        fs      $s_x_3,$s_x_3,$a_x_2                    # 70e
        rotqbii $both_2,$both_2,1                       # 70o

        fm      $q_y_3,$e1_x_3,$s_z_3                   # 71e
            shufb   $nearest_3,$nearest_3,$object_2,$control # 71o

        fs      $s_y,$s_y,$a_y_2                        # 72e
            shufb   $t_best_6,$t_best_3,$t_3,$control   # 72o

        fs      $s_z_7,$s_z_2,$a_z_2                    # 73e
            shufb   $nearest,$nearest,$object_2,$control_4 # 73o

        fs      $s_y_5,$s_y_4,$a_y_2                    # 74e
            shufb   $t_best,$t_best,$t_4,$control_4     # 74o

        fm      $q_x_2,$e1_z_2,$s_y_2                   # 75e
            stqd    $nearest_3,480($a_packet_2)         # 75o

        fm      $q_x_6,$e1_z_2,$s_y_6                   # 76e
        frest   $t_y_3,$det_5                           # 76o

        fm      $q_y_4,$e1_x_3,$s_z_4                   # 77e
            stqd    $t_best_6,416($a_packet_2)          # 77o

        fm      $q_x_4,$e1_z_2,$s_y                     # 78e
            shufb   $nearest_4,$nearest_4,$object_2,$control_5 # 78o

        fs      $s_x_6,$s_x_5,$a_x_2                    # 79e
            stqd    $t_best,432($a_packet_2)            # 79o

        fm      $q_x_5,$e1_z_2,$s_y_5                   # 80e
        frest   $t_y_7,$det_4                           # 80o

        fi      $t_y_3,$det_5,$t_y_3                    # 81e
        frest   $t_y_8,$det_3                           # 81o

        or      $seen_2,$det_4,$both_2                  # 82e
            stqd    $nearest,496($a_packet_2)           # 82o

        fs      $s_x_7,$s_x_4,$a_x_2                    # 83e
            stqd    $nearest_4,448($a_packet_2)         # 83o

        fms     $q_x_7,$e1_y_2,$s_z_3,$q_x_4            # 84e
            shufb   $t_best_7,$t_best_4,$t,$control_5   # 84o

        fi      $t_y_9,$det_4,$t_y_7                    # 85e
        fi      $t_y_6,$det_3,$t_y_8                    # 86e

        or      $seen_3,$det_5,$both_2                  # 87e
        lnop                                            # 87o pairing

        fma     $det_2,$e1_z_2,$p_z_7,$det_2            # 88e
            stqd    $t_best_7,384($a_packet_2)          # 88o

        fm      $u_12,$s_x_6,$p_x                       # 89e
        fm      $q_y_7,$e1_x_3,$s_z_5                   # 90e

        fm      $q_y_8,$e1_x_3,$s_z_7                   # 91e
        lnop                                            # 91o pairing

        fms     $q_x_5,$e1_y_2,$s_z_5,$q_x_5            # 92e
        shufb   $object_2,$object,$object,$m_x          # 92o

        fm      $q_z_8,$e1_y_2,$s_x_7                   # 93e
        shlqbyi $a_packet_2,$a_packet,0                 # 93o copy

        fms     $q_x_2,$e1_y_2,$s_z_7,$q_x_2            # 94e
        frest   $t_y_7,$det_2                           # 94o

        fms     $q_x_6,$e1_y_2,$s_z_4,$q_x_6            # 95e
        fm      $v_3,$d_x,$q_x_7                        # 96e

        fms     $q_y_4,$e1_z_2,$s_x_3,$q_y_4            # 97e
        fma     $u_12,$s_y,$p_y,$u_12                   # 98e

        fi      $t_y_10,$det_2,$t_y_7                   # 99e
        or      $seen_4,$det_3,$both_2                  # 100e

        fnms    $ahead_12,$e2_x,$q_x_2,$k_zero          # 101e
        fms     $q_y_3,$e1_z_2,$s_x_6,$q_y_3            # 102e

        fms     $q_y_7,$e1_z_2,$s_x_7,$q_y_7            # 103e
        fm      $v_4,$d_x_3,$q_x_6                      # 104e

        fm      $u_4,$s_x_3,$p_x_3                      # 105e
        fnms    $t_e_2,$det_2,$t_y_10,$k_one            # 106e

        fms     $q_z_8,$e1_x_3,$s_y_5,$q_z_8            # 107e
        fm      $v_12,$d_x_2,$q_x_2                     # 108e

        fnms    $t_e_6,$det_5,$t_y_3,$k_one             # 109e
        fma     $v_7,$d_y_3,$q_y_4,$v_4                 # 110e

        fm      $u_9,$s_x_7,$p_x_4                      # 111e
        fm      $u_2,$s_x_2,$p_x_2                      # 112e

        fma     $u,$s_z_3,$p_z_3,$u_12                  # 113e
        fma     $u_12,$s_y_6,$p_y_3,$u_4                # 114e

        fnms    $ahead_13,$e2_x,$q_x_6,$k_zero          # 115e
        fnms    $ahead_9,$e2_x,$q_x_7,$k_zero           # 116e

        fms     $q_y_9,$e1_z_2,$s_x_2,$q_y_8            # 117e
        fma     $u_13,$s_y_5,$p_y_4,$u_9                # 118e

        fm      $q_z_9,$e1_y_2,$s_x_3                   # 119e
        fm      $q_z_10,$e1_y_2,$s_x_2                  # 120e

        fma     $u_6,$s_y_2,$p_y_2,$u_2                 # 121e
        fma     $u_12,$s_z_4,$p_z_5,$u_12               # 122e

        fm      $v,$d_x_4,$q_x_5                        # 123e
        fma     $u_13,$s_z_5,$p_z_4,$u_13               # 124e

        fms     $q_z,$e1_x_3,$s_y_6,$q_z_9              # 125e
        fms     $q_z_9,$e1_x_3,$s_y_2,$q_z_10           # 126e

        fma     $v_3,$d_y,$q_y_3,$v_3                   # 127e
        fm      $q_z_11,$e1_y_2,$s_x_6                  # 128e

        fma     $inverse,$t_e_6,$t_y_3,$t_y_3           # 129e
        fnms    $t_e,$det_3,$t_y_6,$k_one               # 130e

        fnms    $ahead,$e2_y_2,$q_y_9,$ahead_12         # 131e
        fma     $v_13,$d_y_2,$q_y_9,$v_12               # 132e

        fma     $v,$d_y_4,$q_y_7,$v                     # 133e
        fms     $q_z_12,$e1_x_3,$s_y,$q_z_11            # 134e

        fma     $v_12,$d_z_3,$q_z,$v_7                  # 135e
        fnms    $ahead_13,$e2_y_2,$q_y_4,$ahead_13      # 136e

        fm      $u_14,$u_13,$inverse                    # 137e
        fnms    $ahead_14,$e2_x,$q_x_5,$k_zero          # 138e

        fma     $inverse_5,$t_e,$t_y_6,$t_y_6           # 139e
        fnms    $t_e,$det_4,$t_y_9,$k_one               # 140e

        fnms    $ahead,$e2_z,$q_z_9,$ahead              # 141e
        fnms    $ahead_9,$e2_y_2,$q_y_3,$ahead_9        # 142e

        fma     $v_9,$d_z_2,$q_z_12,$v_3                # 143e
        fma     $u_15,$s_z_7,$p_z_7,$u_6                # 144e

        fm      $u_12,$u_12,$inverse_5                  # 145e
        fma     $inverse_6,$t_e_2,$t_y_10,$t_y_10       # 146e

        fma     $inverse_7,$t_e,$t_y_9,$t_y_9           # 147e
        fs      $w,$k_one,$u_14                         # 148e

        fnms    $ahead_15,$e2_z,$q_z_12,$ahead_9        # 149e
        fm      $v_14,$v_12,$inverse_5                  # 150e

        fnms    $ahead_2,$e2_y_2,$q_y_7,$ahead_14       # 151e
        fma     $v,$d_z_4,$q_z_8,$v                     # 152e

        fm      $v_15,$v_9,$inverse_7                   # 153e
        fma     $v_13,$d_z,$q_z_9,$v_13                 # 154e

        fm      $u,$u,$inverse_7                        # 155e
        fm      $u_15,$u_15,$inverse_6                  # 156e

        fnms    $ahead_16,$e2_z,$q_z_8,$ahead_2         # 157e
        fs      $w_8,$k_one,$u_12                       # 158e

        fnms    $ahead_13,$e2_z,$q_z,$ahead_13          # 159e
        fm      $v_13,$v_13,$inverse_6                  # 160e

        fs      $w_9,$k_one,$u                          # 161e
        fm      $ahead,$ahead,$inverse_6                # 162e -t

        fs      $w_10,$k_one,$u_15                      # 163e
        lnop                                            # 163o pairing

        fm      $v,$v,$inverse                          # 164e
        hbrr    next_triangle_back,next_triangle        # 164o hint

        or      $outside_3,$u,$v_15                     # 165e
        or      $outside,$u_12,$v_14                    # 166e

        fs      $w_6,$w_9,$v_15                         # 167e
        lnop                                            # 167o pairing

        fm      $ahead_11,$ahead_13,$inverse_5          # 168e -t
        lqd     $t_best_2,400($a_packet)                # 168o

        xor     $t_2,$ahead,$k_sign                     # 169e
        fs      $w_11,$w_10,$v_13                       # 170e

        fm      $ahead_8,$ahead_16,$inverse             # 171e -t
        or      $outside_4,$u_14,$v                     # 172e

        fs      $w,$w,$v                                # 173e
        cgt     $control,$t_best_2,$t_2                 # 174e

        fs      $w_7,$w_8,$v_14                         # 175e
        lqd     $t_best_3,416($a_packet)                # 175o

        or      $outside_2,$u_15,$v_13                  # 176e
        fm      $ahead_2,$ahead_15,$inverse_7           # 177e -t

        or      $outside_5,$outside_2,$w_11             # 178e
        lnop                                            # 178o pairing

        xor     $t_3,$ahead_8,$k_sign                   # 179e
        lqd     $t_best_4,384($a_packet)                # 179o

        and     $control_2,$control,$ahead              # 180e
next_triangle_back:
        brnz    $count,next_triangle                    # 180o

next_triangle_drain:
        or      $seen,$det_2,$both_2                    # 0e
        lqd     $t_best,432($a_packet)                  # 0o

        or      $outside,$outside,$w_7                  # 1e
        lqd     $nearest_2,464($a_packet)               # 1o

        orc     $outside_8,$outside_5,$seen             # 2e
        lqd     $nearest,496($a_packet)                 # 2o

        or      $outside_7,$outside_4,$w                # 3e
        lqd     $nearest_4,448($a_packet)               # 3o

        andc    $control_3,$control_2,$outside_8        # 4e
        lqd     $nearest_3,480($a_packet)               # 4o

        orc     $outside,$outside,$seen_4               # 5e
        hbr     isect_triangle_mt_pairs_r16_return,$lr  # 5o hint

        cgt     $control,$t_best_3,$t_3                 # 6e
        rotqbii $control_3,$control_3,1                 # 6o

        orc     $outside_7,$outside_7,$seen_3           # 7e
        or      $outside_6,$outside_3,$w_6              # 8e

        xor     $t_5,$ahead_11,$k_sign                  # 9e
        lnop                                            # 9o pairing

        orc     $outside_6,$outside_6,$seen_2           # 10e
        gb      $control_3,$control_3                   # 10o

        cgt     $control_4,$t_best,$t_5                 # 11e
        and     $control,$control,$ahead_8              # 12e

        and     $control_4,$control_4,$ahead_11         # 13e
        lnop                                            # 13o pairing

        xor     $t,$ahead_2,$k_sign                     # 14e
        shlqbii $control_3,$control_3,4                 # 14o

        andc    $control_4,$control_4,$outside          # 15e
        cgt     $control_6,$t_best_4,$t                 # 16e

        andc    $control,$control,$outside_7            # 17e
        rotqbii $control_4,$control_4,1                 # 17o

        and     $control_6,$control_6,$ahead_2          # 18e
        lqx     $control_3,$control_3,$a_controls       # 18o

        rotqbii $control,$control,1                     # 19o
        andc    $control_5,$control_6,$outside_6        # 20e

        gb      $control_4,$control_4                   # 21o
        rotqbii $control_5,$control_5,1                 # 22o

        gb      $control,$control                       # 23o
        shufb   $nearest_2,$nearest_2,$object_2,$control_3 # 24o

        shufb   $t_best_5,$t_best_2,$t_2,$control_3     # 25o
        gb      $control_5,$control_5                   # 26o

        shlqbii $control,$control,4                     # 27o
        shlqbii $control_4,$control_4,4                 # 28o

        stqd    $t_best_5,400($a_packet_2)              # 29o
        stqd    $nearest_2,464($a_packet_2)             # 30o

        lqx     $control,$control,$a_controls           # 31o
        shlqbii $control_5,$control_5,4                 # 32o

        lqx     $control_4,$control_4,$a_controls       # 33o
        lqx     $control_5,$control_5,$a_controls       # 36o

        shufb   $nearest_3,$nearest_3,$object_2,$control # 37o
        shufb   $t_best_6,$t_best_3,$t_3,$control       # 38o

        shufb   $nearest,$nearest,$object_2,$control_4  # 39o
        shufb   $t_best,$t_best,$t_5,$control_4         # 40o

        stqd    $nearest_3,480($a_packet_2)             # 41o
        shufb   $nearest_4,$nearest_4,$object_2,$control_5 # 42o

        shufb   $t_best_7,$t_best_4,$t,$control_5       # 43o
        stqd    $t_best_6,416($a_packet_2)              # 44o

        stqd    $t_best,432($a_packet_2)                # 45o
        stqd    $nearest,496($a_packet_2)               # 46o

        stqd    $nearest_4,448($a_packet_2)             # 47o
        stqd    $t_best_7,384($a_packet_2)              # 48o

        nop     $127                                    # 49e pairing
isect_triangle_mt_pairs_r16_return:
        bi      $lr                                     # 49o

next_triangle_short:
        ai      $count,$count,-1                        # 0e
        lqd     $object,0($a_candidate)                 # 0o

        ai      $a_candidate,$a_candidate,16            # 1e
        lqd     $vertex,48($object)                     # 6o

        lqd     $edge_2,80($object)                     # 7o
        rotqbyi $a_packet,$object,4                     # 8o

        lqd     $edge_1,64($object)                     # 9o
        lqd     $both,32($object)                       # 10o

        shufb   $object,$object,$object,$m_x            # 11o
        lqd     $d_y,256($a_packet)                     # 12o

        fs      $edge_2,$edge_2,$vertex                 # 13e
        lqd     $d_y_5,272($a_packet)                   # 13o

        nop     $127                                    # 14e pairing
        lqd     $d_z,320($a_packet)                     # 14o

        fs      $edge_1,$edge_1,$vertex                 # 15e
        lqd     $d_z_5,336($a_packet)                   # 15o

        lqd     $d_x,192($a_packet)                     # 16o
        lqd     $d_x_5,208($a_packet)                   # 17o

        lqd     $d_y_6,304($a_packet)                   # 18o
        shufb   $e2_z,$edge_2,$edge_2,$m_z              # 19o

        shufb   $e2_x,$edge_2,$edge_2,$m_x              # 20o
        shufb   $e2_y,$edge_2,$edge_2,$m_y              # 21o

        nop     $127                                    # 22e pairing
        shufb   $e1_x,$edge_1,$edge_1,$m_x              # 22o

        fm      $p_x,$e2_z,$d_y                         # 23e
        lqd     $d_y_7,288($a_packet)                   # 23o

        fm      $p_x_5,$e2_z,$d_y_5                     # 24e
        lqd     $s_y,64($a_packet)                      # 24o

        fm      $p_y,$e2_x,$d_z                         # 25e
        lqd     $d_z_6,352($a_packet)                   # 25o

        fm      $p_y_5,$e2_x,$d_z_5                     # 26e
        lqd     $d_z_7,368($a_packet)                   # 26o

        fm      $p_z,$e2_y,$d_x                         # 27e
        shufb   $e1_y,$edge_1,$edge_1,$m_y              # 27o

        fm      $p_x_6,$e2_z,$d_y_6                     # 28e
        lqd     $s_y_5,80($a_packet)                    # 28o

        fms     $p_x,$e2_y,$d_z,$p_x                    # 29e
        lqd     $d_x_6,240($a_packet)                   # 29o

        fms     $p_x_5,$e2_y,$d_z_5,$p_x_5              # 30e
        shufb   $a_y_3,$vertex,$vertex,$m_y             # 30o

        fms     $p_y,$e2_z,$d_x,$p_y                    # 31e
        lqd     $s_z_8,128($a_packet)                   # 31o

        fms     $p_y_5,$e2_z,$d_x_5,$p_y_5              # 32e
        lqd     $s_x_8,16($a_packet)                    # 32o

        fm      $p_z_8,$e2_y,$d_x_5                     # 33e
        shufb   $e1_z_3,$edge_1,$edge_1,$m_z            # 33o

        fm      $p_x_7,$e2_z,$d_y_7                     # 34e
        lqd     $s_x_9,0($a_packet)                     # 34o

        fm      $det_8,$e1_x,$p_x                       # 35e
        lqd     $s_z_9,144($a_packet)                   # 35o

        fm      $det_9,$e1_x,$p_x_5                     # 36e
        lqd     $d_x_7,224($a_packet)                   # 36o

        fm      $p_y_6,$e2_x,$d_z_7                     # 37e
        shufb   $a_x_3,$vertex,$vertex,$m_x             # 37o

        fms     $p_z,$e2_x,$d_y,$p_z                    # 38e
        shufb   $a_z_2,$vertex,$vertex,$m_z             # 38o

        fms     $p_z_8,$e2_x,$d_y_5,$p_z_8              # 39e
        lqd     $s_y_7,112($a_packet)                   # 39o

        fms     $p_x_7,$e2_y,$d_z_6,$p_x_7              # 40e
        lqd     $s_y_8,96($a_packet)                    # 40o

        fma     $det_8,$e1_y,$p_y,$det_8                # 41e
        lqd     $s_z_10,160($a_packet)                  # 41o

        fms     $p_x_6,$e2_y,$d_z_7,$p_x_6              # 42e
        lqd     $s_x_10,48($a_packet)                   # 42o

        fma     $det_9,$e1_y,$p_y_5,$det_9              # 43e
        lqd     $s_x_11,32($a_packet)                   # 43o

        fm      $p_y_7,$e2_x,$d_z_6                     # 44e
        lqd     $s_z_11,176($a_packet)                  # 44o

        fs      $s_y_5,$s_y_5,$a_y_3                    # 45e
        shufb   $both,$both,$both,$m_w                  # 45o

        fs      $s_y,$s_y,$a_y_3                        # 46e
        lqd     $t_best_8,384($a_packet)                # 46o

        fm      $det_10,$e1_x,$p_x_7                    # 47e
        lqd     $t_best_9,400($a_packet)                # 47o

        fma     $det_8,$e1_z_3,$p_z,$det_8              # 48e
        lqd     $t_best_10,416($a_packet)               # 48o

        fm      $det_11,$e1_x,$p_x_6                    # 49e
        rotqbii $both,$both,1                           # 49o

        fma     $det_9,$e1_z_3,$p_z_8,$det_9            # 50e
        lqd     $t_best_11,432($a_packet)               # 50o

        fm      $p_z_9,$e2_y,$d_x_7                     # 51e
        lqd     $nearest_5,448($a_packet)               # 51o

        fm      $q_x_8,$e1_z_3,$s_y                     # 52e
        lqd     $nearest_6,464($a_packet)               # 52o

        fms     $p_y_6,$e2_z,$d_x_6,$p_y_6              # 53e
        lqd     $nearest_7,496($a_packet)               # 53o

        fs      $s_z_8,$s_z_8,$a_z_2                    # 54e
        frest   $t_y_11,$det_8                          # 54o

        fs      $s_x_8,$s_x_8,$a_x_3                    # 55e
        lqd     $nearest_8,480($a_packet)               # 55o

        fm      $q_x_9,$e1_z_3,$s_y_5                   # 56e
        frest   $t_y_8,$det_9                           # 56o

        fms     $p_y_7,$e2_z,$d_x_7,$p_y_7              # 57e
        fm      $p_z_10,$e2_y,$d_x_6                    # 58e

        fs      $s_x_9,$s_x_9,$a_x_3                    # 59e
        fs      $s_z_9,$s_z_9,$a_z_2                    # 60e

        fma     $det_11,$e1_y,$p_y_6,$det_11            # 61e
        fms     $q_x_8,$e1_y,$s_z_8,$q_x_8              # 62e

        fma     $det_10,$e1_y,$p_y_7,$det_10            # 63e
        fms     $p_z_10,$e2_x,$d_y_6,$p_z_10            # 64e

        fm      $u_16,$s_x_8,$p_x_5                     # 65e
        fi      $t_y_11,$det_8,$t_y_11                  # 66e

        fi      $t_y_8,$det_9,$t_y_8                    # 67e
        or      $seen_5,$det_9,$both                    # 68e

        fms     $p_z_9,$e2_x,$d_y_7,$p_z_9              # 69e
        fs      $s_y_7,$s_y_7,$a_y_3                    # 70e

        fms     $q_x_9,$e1_y,$s_z_9,$q_x_9              # 71e
        fm      $q_y_10,$e1_x,$s_z_8                    # 72e

        fm      $u_3,$s_x_9,$p_x                        # 73e
        fm      $q_y_11,$e1_x,$s_z_9                    # 74e

        fs      $s_y_9,$s_y_8,$a_y_3                    # 75e
        fnms    $t_e_7,$det_9,$t_y_8,$k_one             # 76e

        fm      $v_16,$d_x_5,$q_x_9                     # 77e
        fma     $det_12,$e1_z_3,$p_z_9,$det_10          # 78e

        fnms    $t_e_8,$det_8,$t_y_11,$k_one            # 79e
        fm      $v_3,$d_x,$q_x_8                        # 80e

        fma     $det_11,$e1_z_3,$p_z_10,$det_11         # 81e
        fms     $q_y_10,$e1_z_3,$s_x_9,$q_y_10          # 82e

        fm      $q_z_13,$e1_y,$s_x_9                    # 83e
        lnop                                            # 83o pairing

        fma     $u_3,$s_y,$p_y,$u_3                     # 84e
        frest   $t_y_10,$det_12                         # 84o

        fm      $q_x_10,$e1_z_3,$s_y_9                  # 85e
        fma     $u_16,$s_y_5,$p_y_5,$u_16               # 86e

        fs      $s_z_12,$s_z_10,$a_z_2                  # 87e
        frest   $t_y_9,$det_11                          # 87o

        fms     $q_y_11,$e1_z_3,$s_x_8,$q_y_11          # 88e
        fm      $q_z_14,$e1_y,$s_x_8                    # 89e

        fnms    $ahead_17,$e2_x,$q_x_9,$k_zero          # 90e
        fs      $s_x_11,$s_x_11,$a_x_3                  # 91e

        fs      $s_x_12,$s_x_10,$a_x_3                  # 92e
        fms     $q_z_15,$e1_x,$s_y,$q_z_13              # 93e

        fma     $inverse,$t_e_8,$t_y_11,$t_y_11         # 94e
        fnms    $ahead_18,$e2_x,$q_x_8,$k_zero          # 95e

        fma     $v_17,$d_y_5,$q_y_11,$v_16              # 96e
        fm      $q_x_6,$e1_z_3,$s_y_7                   # 97e

        fi      $t_y_10,$det_12,$t_y_10                 # 98e
        fi      $t_y_9,$det_11,$t_y_9                   # 99e

        or      $seen_6,$det_8,$both                    # 100e
        fs      $s_z_7,$s_z_11,$a_z_2                   # 101e

        fms     $q_z_16,$e1_x,$s_y_5,$q_z_14            # 102e
        fm      $u_17,$s_x_12,$p_x_6                    # 103e

        fma     $u_3,$s_z_8,$p_z,$u_3                   # 104e
        fma     $inverse_8,$t_e_7,$t_y_8,$t_y_8         # 105e

        fma     $u,$s_z_9,$p_z_8,$u_16                  # 106e
        fms     $q_x,$e1_y,$s_z_12,$q_x_10              # 107e

        fm      $u_16,$s_x_11,$p_x_7                    # 108e
        fm      $q_y,$e1_x,$s_z_7                       # 109e

        fm      $q_y_12,$e1_x,$s_z_12                   # 110e
        fma     $v_3,$d_y,$q_y_10,$v_3                  # 111e

        fnms    $ahead_19,$e2_y,$q_y_11,$ahead_17       # 112e
        fms     $q_x_6,$e1_y,$s_z_7,$q_x_6              # 113e

        fma     $v_17,$d_z_5,$q_z_16,$v_17              # 114e
        fm      $u,$u,$inverse_8                        # 115e

        fms     $q_y_13,$e1_z_3,$s_x_11,$q_y_12         # 116e
        fma     $v_3,$d_z,$q_z_15,$v_3                  # 117e

        fnms    $ahead_20,$e2_y,$q_y_10,$ahead_18       # 118e
        fm      $v_18,$d_x_6,$q_x_6                     # 119e

        fm      $q_z,$e1_y,$s_x_11                      # 120e
        fma     $u_17,$s_y_7,$p_y_6,$u_17               # 121e

        fnms    $ahead_4,$e2_z,$q_z_16,$ahead_19        # 122e
        fnms    $t_e,$det_12,$t_y_10,$k_one             # 123e

        fnms    $ahead_21,$e2_z,$q_z_15,$ahead_20       # 124e
        fm      $v,$d_x_7,$q_x                          # 125e

        fnms    $t_e_9,$det_11,$t_y_9,$k_one            # 126e
        fm      $u_18,$u_3,$inverse                     # 127e

        fnms    $ahead_22,$e2_x,$q_x,$k_zero            # 128e
        fms     $q_y,$e1_z_3,$s_x_12,$q_y               # 129e

        fm      $q_z_17,$e1_y,$s_x_12                   # 130e
        fs      $w,$k_one,$u                            # 131e

        fma     $u_16,$s_y_9,$p_y_7,$u_16               # 132e
        fm      $v_17,$v_17,$inverse_8                  # 133e

        fm      $v_11,$v_3,$inverse                     # 134e
        fnms    $ahead,$e2_x,$q_x_6,$k_zero             # 135e

        fma     $v_16,$d_y_6,$q_y,$v_18                 # 136e
        fs      $w_12,$k_one,$u_18                      # 137e

        fms     $q_z,$e1_x,$s_y_9,$q_z                  # 138e
        fma     $inverse_9,$t_e,$t_y_10,$t_y_10         # 139e

        fma     $u_16,$s_z_12,$p_z_9,$u_16              # 140e
        fma     $v,$d_y_7,$q_y_13,$v                    # 141e

        fma     $u_19,$s_z_7,$p_z_10,$u_17              # 142e
        fm      $ahead_7,$ahead_4,$inverse_8            # 143e -t

        fma     $inverse_10,$t_e_9,$t_y_9,$t_y_9        # 144e
        fm      $ahead_8,$ahead_21,$inverse             # 145e -t

        fs      $w_12,$w_12,$v_11                       # 146e
        fms     $q_z_17,$e1_x,$s_y_7,$q_z_17            # 147e

        fnms    $ahead_6,$e2_y,$q_y_13,$ahead_22        # 148e
        fm      $u_16,$u_16,$inverse_9                  # 149e

        fs      $w,$w,$v_17                             # 150e
        or      $outside,$u_18,$v_11                    # 151e

        xor     $t,$ahead_8,$k_sign                     # 152e
        fnms    $ahead,$e2_y,$q_y,$ahead                # 153e

        fma     $v,$d_z_6,$q_z,$v                       # 154e
        fnms    $ahead_6,$e2_z,$q_z,$ahead_6            # 155e

        fma     $v_16,$d_z_7,$q_z_17,$v_16              # 156e
        fm      $u_19,$u_19,$inverse_10                 # 157e

        or      $outside,$outside,$w_12                 # 158e
        or      $outside_6,$u,$v_17                     # 159e

        xor     $t_6,$ahead_7,$k_sign                   # 160e
        or      $outside_6,$outside_6,$w                # 161e

        fm      $v,$v,$inverse_9                        # 162e
        orc     $outside_6,$outside_6,$seen_5           # 163e

        fnms    $ahead,$e2_z,$q_z_17,$ahead             # 164e
        orc     $outside,$outside,$seen_6               # 165e

        cgt     $control,$t_best_8,$t                   # 166e
        cgt     $control_4,$t_best_9,$t_6               # 167e

        fs      $w,$k_one,$u_16                         # 168e
        and     $control,$control,$ahead_8              # 169e

        and     $control_7,$control_4,$ahead_7          # 170e
        fs      $w_2,$k_one,$u_19                       # 171e

        andc    $control_5,$control_7,$outside_6        # 172e
        andc    $control,$control,$outside              # 173e

        fm      $v_16,$v_16,$inverse_10                 # 174e
        rotqbii $control_5,$control_5,1                 # 174o

        fm      $ahead_6,$ahead_6,$inverse_9            # 175e -t
        rotqbii $control,$control,1                     # 175o

        fs      $w,$w,$v                                # 176e
        fm      $ahead,$ahead,$inverse_10               # 177e -t

        or      $seen,$det_12,$both                     # 178e
        gb      $control_5,$control_5                   # 178o

        or      $outside,$u_16,$v                       # 179e
        gb      $control,$control                       # 179o

        fs      $w_7,$w_2,$v_16                         # 180e
        xor     $t_7,$ahead_6,$k_sign                   # 181e

        or      $outside,$outside,$w                    # 182e
        shlqbii $control_5,$control_5,4                 # 182o

        xor     $t_8,$ahead,$k_sign                     # 183e
        shlqbii $control,$control,4                     # 183o

        cgt     $control_8,$t_best_10,$t_7              # 184e
        or      $outside_9,$u_19,$v_16                  # 185e

        or      $seen_7,$det_11,$both                   # 186e
        lqx     $control_5,$control_5,$a_controls       # 186o

        or      $outside_9,$outside_9,$w_7              # 187e
        lqx     $control,$control,$a_controls           # 187o

        cgt     $control_9,$t_best_11,$t_8              # 188e
        and     $control_10,$control_8,$ahead_6         # 189e

        and     $control_9,$control_9,$ahead            # 190e
        orc     $outside,$outside,$seen                 # 191e

        orc     $outside_9,$outside_9,$seen_7           # 192e
        shufb   $t_best,$t_best_9,$t_6,$control_5       # 192o

        andc    $control_10,$control_10,$outside        # 193e
        shufb   $t_best_12,$t_best_8,$t,$control        # 193o

        andc    $control_11,$control_9,$outside_9       # 194e
        shufb   $nearest,$nearest_5,$object,$control    # 194o

        rotqbii $control,$control_10,1                  # 195o
        rotqbii $control_10,$control_11,1               # 196o

        shufb   $nearest_9,$nearest_6,$object,$control_5 # 197o
        stqd    $nearest,448($a_packet)                 # 198o

        gb      $control,$control                       # 199o
        gb      $control_10,$control_10                 # 200o

        stqd    $nearest_9,464($a_packet)               # 201o
        stqd    $t_best,400($a_packet)                  # 202o

        shlqbii $control,$control,4                     # 203o
        shlqbii $control_5,$control_10,4                # 204o

        stqd    $t_best_12,384($a_packet)               # 205o
        hbrr    next_triangle_short_back,next_triangle_short # 206o hint

        lqx     $control,$control,$a_controls           # 207o
        lqx     $control_5,$control_5,$a_controls       # 208o

        shufb   $t_best,$t_best_10,$t_7,$control        # 213o
        shufb   $nearest,$nearest_7,$object,$control_5  # 214o

        shufb   $nearest_2,$nearest_8,$object,$control  # 215o
        shufb   $t_best_7,$t_best_11,$t_8,$control_5    # 216o

        stqd    $t_best,416($a_packet)                  # 217o
        stqd    $nearest,496($a_packet)                 # 218o

        stqd    $nearest_2,480($a_packet)               # 219o
        stqd    $t_best_7,432($a_packet)                # 220o

        nop     $127                                    # 221e pairing
next_triangle_short_back:
        brnz    $count,next_triangle_short              # 221o

        nop     $127                                    # 222e pairing
        bi      $lr                                     # 222o
endfunction isect_triangle_mt_pairs_r16
