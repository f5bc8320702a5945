# isect_pairs_double_r16   nearest entry of packets' eye rays into spheres, in double precision
#   C       void isect_pairs_double_r16(const struct pair *, int count);
#   In      $3 pairs, $4 count (0 is none); pointers 16-aligned
#   Out     the pairs' packets: t, object, where an entry is nearer than what was there
#   Uses    $3-$4, $10-$54   Saves  -   Stack  0   Calls  -
#   Domain  |d| = 1 within 4 ulp; radius > 0; centre and radius below 2^60; rounds to the nearest
#   Error   0.51 ulp of t, eye 1.5 to 1e6 radii from the centre, ray within 0.995 r of it
#   Twin    oracle/src/twin/sphere/double.rs
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
        .set    m_x,17
        .set    m_y,18
        .set    m_z,19
        .set    m_radius2,20
        .set    a_merges,21
        # the pair
        .set    object,22
        .set    a_packet,23
        .set    quad,24
        .set    cx,25
        .set    cy,26
        .set    cz,27
        .set    radius2,28
        # a row
        .set    dx,29
        .set    dy,30
        .set    dz,31
        .set    t_best,32
        .set    nearest,33
        # temporaries
        .set    b,34
        .set    lx,35
        .set    ly,36
        .set    lz,37
        .set    disc,38
        .set    y,39
        .set    s,40
        .set    e,41
        .set    ex,42
        .set    ey,43
        .set    ez,44
        .set    x,45
        .set    near,46
        .set    w,47
        .set    cc,48
        .set    q,49
        .set    t_even,50
        .set    disc_even,51
        .set    t,52
        .set    hit,53
        .set    merge,54

        merges_table
        double_table

function isect_pairs_double_r16
        eye_form 0
endfunction isect_pairs_double_r16
