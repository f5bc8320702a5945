# isect_ball_pairs_double_r16   nearest hit of packets' rays with spheres, in double precision
#   C       void isect_ball_pairs_double_r16(const struct candidate *, int count);
#   In      $3 candidates of objects that are spheres, $4 count (0 is none); pointers 16-aligned
#   Out     the candidates' packets: t, object, where a hit has 0 < t < what was there
#   Uses    $3-$4, $10-$63   Saves  -   Stack  0   Calls  -
#   Domain  |d| = 1 within 4 ulp; coordinates and radius below 2^60, radius above 2^-40; rounds to
#           the nearest
#   Error   0.51 ulp of the larger of t and r, origin up to 30 radii from the centre and beyond
#           1e-5 of one from the surface, ray within 0.995 r of it
#   Twin    oracle/src/twin/sphere/double.rs
#
# The steps are those of sphere_tmpl.inc: of the crossings the entry is asked for, with SIDES_EXIT the
# exit, and with SIDES_BOTH the exit of a ray from inside.

        .include "work_unit.inc"
        .include "macros.inc"
        .include "pairs.inc"
        .include "math.inc"
        .include "sphere_tmpl.inc"
        .include "sphere_double.inc"

        .set    a_candidate,3
        .set    count,4
        # constants
        .set    m_x,10
        .set    m_y,11
        .set    m_z,12
        .set    k_one,13
        .set    k_half,14
        .set    k_tiny,15
        .set    m_high,16
        .set    m_rows,17
        .set    m_sign,18
        .set    k_halve,19
        .set    a_controls,20
        .set    a_half,21
        .set    a_whole,22
        .set    a_by_side,23
        # the candidate
        .set    object,24
        .set    a_packet,25
        .set    quad,26
        .set    cx,27
        .set    cy,28
        .set    cz,29
        .set    radius2,30
        .set    sides,31
        .set    half,32                                 # 1/2, with the sign that the root gets
        .set    whole,33                                # 1 likewise
        .set    m_by_side,34                            # the sign's bit if a ray's side gives it
        # a row
        .set    ox,35
        .set    oy,36
        .set    oz,37
        .set    dx,38
        .set    dy,39
        .set    dz,40
        .set    t_best,41
        .set    nearest,42
        # temporaries
        .set    lx,43                                   # f, then l
        .set    ly,44
        .set    lz,45
        .set    b,46
        .set    outside,47                              # disc
        .set    disc,47
        .set    cc,48
        .set    y,49
        .set    s,50
        .set    e,51
        .set    ex,52
        .set    ey,53
        .set    ez,54
        .set    x,55
        .set    near,56
        .set    w,57
        .set    q,58
        .set    t_even,59
        .set    disc_even,60
        .set    t,61
        .set    ahead,62
        .set    control,63

        sign_controls_table
        sides_tables 0x3f000000, 0x3f800000
        double_table

function isect_ball_pairs_double_r16
        general_form
endfunction isect_ball_pairs_double_r16
