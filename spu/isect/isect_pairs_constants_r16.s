# isect_pairs_constants_r16   nearest entry of packets' eye rays into spheres, by their direction
#   C       void isect_pairs_constants_r16(const struct pair *, int count);
#   In      $3 pairs, $4 count (0 is none); pointers 16-aligned
#   Out     the pairs' packets: t, object, where an entry is nearer than what was there
#   Uses    $3-$4, $10-$42   Saves  -   Stack  0   Calls  -
#   Domain  |d| and |axis| = 1 within 4 ulp; distance and radius from 2^-40 to 2^62
#   Error   3.5 ulp of t, eye 2 to 1e6 radii from the centre, ray within 0.9 r of it
#   Twin    lab/twins/src/sphere/constants.rs
#
# The steps are those of sphere_tmpl.inc. An opaque sphere has no inside: only the entry counts, and
# behind the eye it is none. The centre's place in the record holds its unit direction, the radius
# squared is in parts of the distance's square.

        .include "work_unit.inc"
        .include "macros.inc"
        .include "sphere_tmpl.inc"
        .include "sphere_constants.inc"

        .set    a_pair,3
        .set    count,4
        # constants
        .set    k_one,10
        .set    k_quarter,11
        .set    half,12
        .set    k_half,12                               # half
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
        .set    cx,22                                   # the unit direction
        .set    cy,23
        .set    cz,24
        .set    radius2,25                              # k
        .set    distance,26
        # a row
        .set    dx,27
        .set    dy,28
        .set    dz,29
        .set    t_best,30
        .set    nearest,31
        # temporaries
        .set    lx,32                                   # d - u
        .set    ly,33
        .set    lz,34
        .set    chord,35                                # q
        .set    disc,36
        .set    y,37
        .set    s,38
        .set    e,39
        .set    t,40
        .set    hit,41
        .set    merge,42

        merges_table

function isect_pairs_constants_r16
        eye_form 1, 0x3f000000, 0x3f800000
endfunction isect_pairs_constants_r16
