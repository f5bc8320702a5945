# isect_pairs_r16   nearest entry of packets' eye rays into spheres, pair by pair
#   C       void isect_pairs_r16(const struct pair *, int count);
#   In      $3 pairs, $4 count (0 is none); pointers 16-aligned
#   Out     the pairs' packets: t, object, where an entry is nearer than what was there
#   Uses    $3-$4, $10-$40   Saves  -   Stack  0   Calls  -
#   Domain  |d| = 1 within 4 ulp; radius > 0; centre and radius below 2^62
#   Error   12 ulp of t, eye 1.5 to 30 radii from the centre, ray within 0.995 r of it
#   Twin    lab/twins/src/sphere/perpendicular.rs
#
# The steps are those of sphere_tmpl.inc. An opaque sphere has no inside: only the entry counts, and
# behind the eye it is none.

        .include "work_unit.inc"
        .include "macros.inc"
        .include "sphere_tmpl.inc"
        .include "sphere_perpendicular.inc"

        .set    a_pair,3
        .set    count,4
        # constants
        .set    k_one,10
        .set    half,11
        .set    whole,12
        .set    m_x,13
        .set    m_y,14
        .set    m_z,15
        .set    m_radius2,16
        .set    a_merges,17
        # the pair
        .set    object,18
        .set    a_packet,19
        .set    quad,20
        .set    cx,21
        .set    cy,22
        .set    cz,23
        .set    fx,21                                   # c
        .set    fy,22
        .set    fz,23
        .set    radius2,24
        # a row
        .set    dx,25
        .set    dy,26
        .set    dz,27
        .set    t_best,28
        .set    nearest,29
        # temporaries
        .set    b,30
        .set    lx,31
        .set    ly,32
        .set    lz,33
        .set    disc,34
        .set    y,35
        .set    s,36
        .set    e,37
        .set    t,38
        .set    hit,39
        .set    merge,40

        merges_table

function isect_pairs_r16
        eye_form 1, 0x3f000000, 0x3f800000
endfunction isect_pairs_r16
