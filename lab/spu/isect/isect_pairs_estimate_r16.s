# isect_pairs_estimate_r16   nearest entry of packets' eye rays into spheres, by a root's estimate
#   C       void isect_pairs_estimate_r16(const struct pair *, int count);
#   In      $3 pairs, $4 count (0 is none); pointers 16-aligned
#   Out     the pairs' packets: t, object, where an entry is nearer than what was there
#   Uses    $3-$4, $10-$35   Saves  -   Stack  0   Calls  -
#   Domain  |d| = 1 within 4 ulp; radius > 0; centre and radius below 2^62
#   Error   1000000 ulp of t, eye 1.5 to 30 radii from the centre, ray within 0.995 r of it
#   Twin    lab/twins/src/sphere/perpendicular.rs
#
# The steps are those of sphere_tmpl.inc. An opaque sphere has no inside: only the entry counts, and
# behind the eye it is none.

        .include "work_unit.inc"
        .include "macros.inc"
        .include "sphere_tmpl.inc"
        .include "sphere_estimate.inc"

        .set    a_pair,3
        .set    count,4
        # constants
        .set    m_x,10
        .set    m_y,11
        .set    m_z,12
        .set    m_radius2,13
        .set    a_merges,14
        # the pair
        .set    object,15
        .set    a_packet,16
        .set    quad,17
        .set    cx,18
        .set    cy,19
        .set    cz,20
        .set    fx,18                                   # c
        .set    fy,19
        .set    fz,20
        .set    radius2,21
        # a row
        .set    dx,22
        .set    dy,23
        .set    dz,24
        .set    t_best,25
        .set    nearest,26
        # temporaries
        .set    b,27
        .set    lx,28
        .set    ly,29
        .set    lz,30
        .set    disc,31
        .set    y,32
        .set    t,33
        .set    hit,34
        .set    merge,35

        merges_table

function isect_pairs_estimate_r16
        eye_form 2
endfunction isect_pairs_estimate_r16
