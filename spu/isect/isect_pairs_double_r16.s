# isect_pairs_double_r16   nearest entry of packets' eye rays into spheres, in double precision
#   C       void isect_pairs_double_r16(const struct pair *, int count);
#   In      $3 pairs, $4 count (0 is none); pointers 16-aligned
#   Out     the pairs' packets: t, object, where an entry is nearer than what was there
#   Uses    $3-$4, $10-$55   Saves  -   Stack  0   Calls  -
#   Domain  |d| = 1 within 4 ulp; radius > 0; centre and radius below 2^60; rounds to the nearest
#   Error   0.51 ulp of t, eye 1.5 to 1e6 radii from the centre, ray within 0.995 r of it
#   Twin    lab/twins/src/sphere/double.rs
#
# The steps are those of sphere_tmpl.inc. An opaque sphere has no inside: only the entry counts, and
# behind the eye it is none.

        .include "work_unit.inc"
        .include "macros.inc"
        .include "math.inc"
        .include "sphere_tmpl.inc"
        .include "sphere_double.inc"

        .set    a_pair,3
        .set    count,4
        # constants
        .set    k_one,10
        .set    k_half,11
        .set    k_tiny,12
        .set    m_high,13
        .set    m_rows,14
        .set    m_sign,15
        .set    k_halve,16
        .set    k_half_double,17
        .set    m_x,18
        .set    m_y,19
        .set    m_z,20
        .set    m_radius2,21
        .set    a_merges,22
        # the pair
        .set    object,23
        .set    a_packet,24
        .set    quad,25
        .set    cx,26
        .set    cy,27
        .set    cz,28
        .set    radius2,29
        # a row
        .set    dx,30
        .set    dy,31
        .set    dz,32
        .set    t_best,33
        .set    nearest,34
        # temporaries
        .set    b,35
        .set    lx,36
        .set    ly,37
        .set    lz,38
        .set    disc,39
        .set    y,40
        .set    s,41
        .set    e,42
        .set    ex,43
        .set    ey,44
        .set    ez,45
        .set    x,46
        .set    near,47
        .set    w,48
        .set    cc,49
        .set    q,50
        .set    t_even,51
        .set    disc_even,52
        .set    t,53
        .set    hit,54
        .set    merge,55

        merges_table
        double_table

function isect_pairs_double_r16
        eye_form 0
endfunction isect_pairs_double_r16
