# isect_pairs_refined_r16   nearest entry of packets' eye rays into spheres, to the last digits
#   C       void isect_pairs_refined_r16(const struct pair *, int count);
#   In      $3 pairs, $4 count (0 is none); pointers 16-aligned
#   Out     the pairs' packets: t, object, where an entry is nearer than what was there
#   Uses    $3-$4, $10-$43   Saves  -   Stack  0   Calls  -
#   Domain  |d| = 1 within 4 ulp; radius > 0; centre and radius below 2^62 and from 2^-38 on
#   Error   3.5 ulp of t, eye 2 to 1e6 radii from the centre, ray within 0.9 r of it; from 30 radii
#           on 2
#   Twin    lab/twins/src/sphere/refined.rs
#
# The steps are those of sphere_tmpl.inc. An opaque sphere has no inside: only the entry counts, and
# behind the eye it is none.

        .include "work_unit.inc"
        .include "macros.inc"
        .include "sphere_tmpl.inc"
        .include "sphere_refined.inc"

        .set    a_pair,3
        .set    count,4
        # constants
        .set    k_one,10
        .set    k_two,11
        .set    k_scales,12
        .set    half,13
        .set    whole,14
        .set    m_x,15
        .set    m_y,16
        .set    m_z,17
        .set    m_radius2,18
        .set    a_merges,19
        # the pair
        .set    object,20
        .set    a_packet,21
        .set    quad,22
        .set    cx,23
        .set    cy,24
        .set    cz,25
        .set    fx,23                                   # c
        .set    fy,24
        .set    fz,25
        .set    radius2,26
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
        .set    rest,40
        .set    t,41
        .set    hit,42
        .set    merge,43

        merges_table
# Lengths halved, and the radius squared with them.
scales:
        .int    0x3f000000,0x3f000000,0x3f000000,0x3e800000

function isect_pairs_refined_r16
        eye_form 0, REFINED_STEP, REFINED_ROOT
endfunction isect_pairs_refined_r16
