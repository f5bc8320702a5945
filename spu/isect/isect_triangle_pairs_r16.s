# isect_triangle_pairs_r16   nearest hit of packets' rays with triangles, candidate by candidate
#   C       void isect_triangle_pairs_r16(const struct candidate *, int count);
#   In      $3 candidates of objects that are triangles, and of shears of their packets, $4 count (0
#           is none); pointers 16-aligned
#   Out     the candidates' packets: t, object, where a hit has 0 < t < what was there
#   Uses    $3-$4, $10-$46   Saves  -   Stack  0   Calls  -
#   Domain  distances from the origin below 2^60; triangles higher than 2^-50 across the ray
#   Error   6 ulp of t, 8e-5 in barycentric coordinates; edges from 1/100 of the distance to all of
#           it, area across the ray above 1/20 of their square
#   Twin    lab/twins/src/triangle_pairs.rs
#
# As watertight as isect_triangles_r16, by the same steps; but from behind, where the vertices go
# clockwise, it is hit only with SIDES_BOTH. They go counter-clockwise if the sum of u, v and w has the
# sign of direction z.

        .include "work_unit.inc"
        .include "macros.inc"
        .include "pairs.inc"
        .include "triangle_tmpl.inc"

        .set    a_candidate,3
        .set    count,4
        # constants
        .set    k_above_one,10
        .set    k_sign,11
        .set    m_splat,12
        .set    m_w,13
        .set    a_controls,14
        # the candidate
        .set    object,15
        .set    a_packet,16
        .set    a_shear,17
        .set    both,18
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
        .set    ahead,41                                # n
        .set    outside,42
        .set    seen,43
        .set    t,44
        .set    t_best,45
        .set    nearest,46
        .set    control,43                              # reused

        sign_controls_table

function isect_triangle_pairs_r16
        biz     $count,$lr
        splat_mask $m_splat
        load_constant $m_w,0x0c0d0e0f
        load_above_one $k_above_one
        ilhu    $k_sign,0x8000
        ila     $a_controls,sign_controls
next_triangle:
        load_candidate
        load_both
        rotqbyi $a_shear,$object,CANDIDATE_shear
        lqd     $vertex_a,TRI_a($object)
        lqd     $vertex_b,TRI_b($object)
        lqd     $vertex_c,TRI_c($object)
        splat   $object,$object,$m_splat
    .irp row, 0,1,2,3
        triangle_row \row
        xor     $seen,$det,$slope                       # of -1 / direction z
        outside_if_behind $seen
        xor     $t,$n,$k_sign
        keep_nearer \row
    .endr
        next_candidate next_triangle
        bi      $lr
endfunction isect_triangle_pairs_r16
