# isect_pairs_newton2_r16   nearest entry of packets' eye rays into spheres, two steps for the root
#   C       void isect_pairs_newton2_r16(const struct pair *, int count);
#   In      $3 pairs, $4 count (0 is none); pointers 16-aligned
#   Out     the pairs' packets: t, object, where an entry is nearer than what was there
#   Uses    $3-$4, $10-$38   Saves  -   Stack  0   Calls  -
#   Domain  |d| = 1 within 4 ulp; radius > 0; centre and radius below 2^62
#   Error   12 ulp of t, eye 1.5 to 30 radii from the centre, ray within 0.995 r of it
#   Twin    lab/twins/src/sphere/newton2.rs
#
# The steps are those of sphere_tmpl.inc. An opaque sphere has no inside: only the entry counts, and
# behind the eye it is none.

        .include "work_unit.inc"
        .include "macros.inc"
        .include "sphere_tmpl.inc"
        .include "sphere_newton2.inc"

        .set    a_pair,3
        .set    count,4
        # constants
        .set    k_half,10
        .set    m_x,11
        .set    m_y,12
        .set    m_z,13
        .set    m_radius2,14
        .set    a_merges,15
        # the pair
        .set    object,16
        .set    a_packet,17
        .set    quad,18
        .set    cx,19
        .set    cy,20
        .set    cz,21
        .set    fx,19                                   # c
        .set    fy,20
        .set    fz,21
        .set    radius2,22
        # a row
        .set    dx,23
        .set    dy,24
        .set    dz,25
        .set    t_best,26
        .set    nearest,27
        # temporaries
        .set    b,28
        .set    lx,29
        .set    ly,30
        .set    lz,31
        .set    disc,32
        .set    y,33
        .set    s,34
        .set    e,35
        .set    t,36
        .set    hit,37
        .set    merge,38

        merges_table

function isect_pairs_newton2_r16
        eye_form 0
endfunction isect_pairs_newton2_r16
