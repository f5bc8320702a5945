# isect_ball_pairs_double_r16   nearest hit of packets' rays with spheres, in double precision
#   C       void isect_ball_pairs_double_r16(const struct candidate *, int count);
#   In      $3 candidates of objects that are spheres, $4 count (0 is none); pointers 16-aligned
#   Out     the candidates' packets: t, object, where a hit has 0 < t < what was there
#   Uses    $3-$4, $10-$64   Saves  -   Stack  0   Calls  -
#   Domain  |d| = 1 within 4 ulp; coordinates and radius below 2^60, radius above 2^-40; rounds to
#           the nearest
#   Error   0.51 ulp of the larger of t and r, origin up to 30 radii from the centre and beyond
#           1e-5 of one from the surface, ray within 0.995 r of it
#   Twin    lab/twins/src/sphere/double.rs
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
        .set    k_half_double,20
        .set    a_controls,21
        .set    a_half,22
        .set    a_whole,23
        .set    a_by_side,24
        # the candidate
        .set    object,25
        .set    a_packet,26
        .set    quad,27
        .set    cx,28
        .set    cy,29
        .set    cz,30
        .set    radius2,31
        .set    sides,32
        .set    half,33                                 # 1/2, with the sign that the root gets
        .set    whole,34                                # 1 likewise
        .set    m_by_side,35                            # the sign's bit if a ray's side gives it
        # a row
        .set    ox,36
        .set    oy,37
        .set    oz,38
        .set    dx,39
        .set    dy,40
        .set    dz,41
        .set    t_best,42
        .set    nearest,43
        # temporaries
        .set    lx,44                                   # f, then l
        .set    ly,45
        .set    lz,46
        .set    b,47
        .set    outside,48                              # disc
        .set    disc,48
        .set    cc,49
        .set    y,50
        .set    s,51
        .set    e,52
        .set    ex,53
        .set    ey,54
        .set    ez,55
        .set    x,56
        .set    near,57
        .set    w,58
        .set    q,59
        .set    t_even,60
        .set    disc_even,61
        .set    t,62
        .set    ahead,63
        .set    control,64

        sign_controls_table
        sides_tables 0x3f000000, 0x3f800000
        double_table

function isect_ball_pairs_double_r16
        general_form
endfunction isect_ball_pairs_double_r16
