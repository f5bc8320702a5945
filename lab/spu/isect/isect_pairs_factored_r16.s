# isect_pairs_factored_r16   nearest entry of packets' eye rays into spheres, by (r - l)(r + l)
#   C       void isect_pairs_factored_r16(const struct pair *, int count);
#   In      $3 pairs, $4 count (0 is none); pointers 16-aligned
#   Out     the pairs' packets: t, object, where an entry is nearer than what was there
#   Uses    $3-$4, $10-$42   Saves  -   Stack  0   Calls  -
#   Domain  |d| = 1 within 4 ulp; radius > 0; centre and radius below 2^62
#   Error   40 ulp of t, eye 1.5 to 30 radii from the centre, ray within 0.995 r of it
#   Twin    lab/twins/src/sphere/factored.rs
#
# The steps are those of sphere_tmpl.inc. An opaque sphere has no inside: only the entry counts, and
# behind the eye it is none.

        .include "work_unit.inc"
        .include "macros.inc"
        .include "math.inc"
        .include "sphere_tmpl.inc"
        .include "sphere_factored.inc"

        .set    a_pair,3
        .set    count,4
        # constants
        .set    k_one,10
        .set    k_half,11
        .set    half,12
        .set    whole,13
        .set    m_x,14
        .set    m_y,15
        .set    m_z,16
        .set    m_radius2,17
        .set    a_merges,18
        # the pair
        .set    object,19
        .set    a_packet,20
        .set    quad,21
        .set    cx,22
        .set    cy,23
        .set    cz,24
        .set    fx,22                                   # c
        .set    fy,23
        .set    fz,24
        .set    radius2,25
        .set    radius,26
        # a row
        .set    dx,27
        .set    dy,28
        .set    dz,29
        .set    t_best,30
        .set    nearest,31
        # temporaries
        .set    b,32
        .set    lx,33
        .set    ly,34
        .set    lz,35
        .set    disc,36
        .set    y,37
        .set    s,38
        .set    e,39
        .set    t,40
        .set    hit,41
        .set    merge,42

        merges_table

function isect_pairs_factored_r16
        eye_form 0, 0x3f000000, 0x3f800000
endfunction isect_pairs_factored_r16
