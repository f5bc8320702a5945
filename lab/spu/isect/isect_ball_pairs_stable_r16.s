# isect_ball_pairs_stable_r16   nearest hit of packets' rays with spheres, roots that don't cancel
#   C       void isect_ball_pairs_stable_r16(const struct candidate *, int count);
#   In      $3 candidates of objects that are spheres, $4 count (0 is none); pointers 16-aligned
#   Out     the candidates' packets: t, object, where a hit has 0 < t < what was there
#   Uses    $3-$4, $10-$51   Saves  -   Stack  0   Calls  -
#   Domain  |d| = 1 within 4 ulp; coordinates and radius below 2^62, radius above 2^-40
#   Error   20 ulp of the larger of t and r, origin up to 30 radii from the centre, ray within
#           0.995 r of it
#   Twin    lab/twins/src/sphere/stable.rs
#
# The steps are those of sphere_tmpl.inc: of the crossings the entry is asked for, with SIDES_EXIT the
# exit, and with SIDES_BOTH the exit of a ray from inside.

        .include "work_unit.inc"
        .include "macros.inc"
        .include "pairs.inc"
        .include "sphere_tmpl.inc"
        .include "sphere_stable.inc"

        .set    a_candidate,3
        .set    count,4
        # constants
        .set    m_x,10
        .set    m_y,11
        .set    m_z,12
        .set    k_one,13
        .set    k_half,14
        .set    m_sign,15
        .set    a_controls,16
        .set    a_half,17
        .set    a_whole,18
        .set    a_by_side,19
        # the candidate
        .set    object,20
        .set    a_packet,21
        .set    quad,22
        .set    cx,23
        .set    cy,24
        .set    cz,25
        .set    radius2,26
        .set    sides,27
        .set    half,28                                 # 1/2, with the sign that the root gets
        .set    whole,29                                # 1 likewise
        .set    m_by_side,30                            # the sign's bit if a ray's side gives it
        # a row
        .set    ox,31
        .set    oy,32
        .set    oz,33
        .set    dx,34
        .set    dy,35
        .set    dz,36
        .set    t_best,37
        .set    nearest,38
        # temporaries
        .set    fx,39
        .set    fy,40
        .set    fz,41
        .set    lx,39                                   # f
        .set    ly,40
        .set    lz,41
        .set    b,42
        .set    outside,43                              # disc
        .set    disc,43
        .set    cc,44
        .set    y,45
        .set    s,46
        .set    e,47
        .set    q,48
        .set    t,49
        .set    ahead,50
        .set    control,51

        sign_controls_table
        sides_tables 0x3f000000, 0x3f800000

function isect_ball_pairs_stable_r16
        general_form
endfunction isect_ball_pairs_stable_r16
