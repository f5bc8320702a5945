# isect_ball_pairs_factored_r16   nearest hit of packets' rays with spheres, by (r - l)(r + l)
#   C       void isect_ball_pairs_factored_r16(const struct candidate *, int count);
#   In      $3 candidates of objects that are spheres, $4 count (0 is none); pointers 16-aligned
#   Out     the candidates' packets: t, object, where a hit has 0 < t < what was there
#   Uses    $3-$4, $10-$49   Saves  -   Stack  0   Calls  -
#   Domain  |d| = 1 within 4 ulp; coordinates and radius below 2^62, radius above 2^-40
#   Error   60 ulp of the larger of t and r, origin up to 30 radii from the centre, ray within
#           0.995 r of it
#   Twin    lab/twins/src/sphere/factored.rs
#
# The steps are those of sphere_tmpl.inc: of the crossings the entry is asked for, with SIDES_EXIT the
# exit, and with SIDES_BOTH the exit of a ray from inside.

        .include "work_unit.inc"
        .include "macros.inc"
        .include "pairs.inc"
        .include "sphere_tmpl.inc"
        .include "sphere_factored.inc"

        .set    a_candidate,3
        .set    count,4
        # constants
        .set    m_x,10
        .set    m_y,11
        .set    m_z,12
        .set    k_one,13
        .set    k_half,14
        .set    a_controls,15
        .set    a_half,16
        .set    a_whole,17
        .set    a_by_side,18
        # the candidate
        .set    object,19
        .set    a_packet,20
        .set    quad,21
        .set    cx,22
        .set    cy,23
        .set    cz,24
        .set    radius,25
        .set    sides,26
        .set    half,27                                 # 1/2, with the sign that the root gets
        .set    whole,28                                # 1 likewise
        .set    m_by_side,29                            # the sign's bit if a ray's side gives it
        # a row
        .set    ox,30
        .set    oy,31
        .set    oz,32
        .set    dx,33
        .set    dy,34
        .set    dz,35
        .set    t_best,36
        .set    nearest,37
        # temporaries
        .set    fx,38
        .set    fy,39
        .set    fz,40
        .set    lx,38                                   # f
        .set    ly,39
        .set    lz,40
        .set    b,41
        .set    outside,42                              # disc
        .set    disc,42
        .set    out,43
        .set    y,44
        .set    s,45
        .set    e,46
        .set    t,47
        .set    ahead,48
        .set    control,49

        sign_controls_table
        sides_tables 0x3f000000, 0x3f800000

function isect_ball_pairs_factored_r16
        general_form
endfunction isect_ball_pairs_factored_r16
