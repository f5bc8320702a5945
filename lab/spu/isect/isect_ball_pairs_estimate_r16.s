# isect_ball_pairs_estimate_r16   nearest hit of packets' rays with spheres, by a root's estimate
#   C       void isect_ball_pairs_estimate_r16(const struct candidate *, int count);
#   In      $3 candidates of objects that are spheres, $4 count (0 is none); pointers 16-aligned
#   Out     the candidates' packets: t, object, where a hit has 0 < t < what was there
#   Uses    $3-$4, $10-$47   Saves  -   Stack  0   Calls  -
#   Domain  |d| = 1 within 4 ulp; coordinates and radius below 2^62, radius above 2^-40
#   Error   500000 ulp of the larger of t and r, origin up to 30 radii from the centre but not
#           within a tenth of one from the surface, ray within 0.995 r of it
#   Twin    lab/twins/src/sphere/perpendicular.rs
#
# The steps are those of sphere_tmpl.inc: of the crossings the entry is asked for, with SIDES_EXIT the
# exit, and with SIDES_BOTH the exit of a ray from inside.

        .include "work_unit.inc"
        .include "macros.inc"
        .include "pairs.inc"
        .include "sphere_tmpl.inc"
        .include "sphere_estimate.inc"

        .set    a_candidate,3
        .set    count,4
        # constants
        .set    m_x,10
        .set    m_y,11
        .set    m_z,12
        .set    m_sign,13
        .set    a_controls,14
        .set    a_half,15
        .set    a_whole,16
        .set    a_by_side,17
        # the candidate
        .set    object,18
        .set    a_packet,19
        .set    quad,20
        .set    cx,21
        .set    cy,22
        .set    cz,23
        .set    radius2,24
        .set    sides,25
        .set    half,26                                 # 1/2, with the sign that the root gets
        .set    whole,27                                # 1 likewise
        .set    m_by_side,28                            # the sign's bit if a ray's side gives it
        # a row
        .set    ox,29
        .set    oy,30
        .set    oz,31
        .set    dx,32
        .set    dy,33
        .set    dz,34
        .set    t_best,35
        .set    nearest,36
        # temporaries
        .set    fx,37
        .set    fy,38
        .set    fz,39
        .set    lx,37                                   # f
        .set    ly,38
        .set    lz,39
        .set    b,40
        .set    outside,41                              # disc
        .set    disc,41
        .set    out,42
        .set    y,43
        .set    s,44
        .set    t,45
        .set    ahead,46
        .set    control,47

        sign_controls_table
        sides_tables 0x3f000000, 0x3f800000

function isect_ball_pairs_estimate_r16
        general_form
endfunction isect_ball_pairs_estimate_r16
