# isect_pairs_constants_r16   nearest entries of primary rays into spheres, by their direction
#   C       void isect_pairs_constants_r16(const struct pair *, int count);
#   In      $3 pairs, $4 count (0 is none); pointers 16-aligned
#   Out     the pairs' packets: t, object, where an entry is nearer than what was there
#   Uses    $3-$4, $10-$42   Saves  -   Stack  0   Calls  -
#   Domain  |d| and |axis| = 1 within 4 ulp; distance and radius from 2^-40 to 2^62
#   Error   3.5 ulp of t, eye 2 to 1e6 radii from the centre, ray within 0.9 r of it
#   Twin    lab/twins/src/sphere/constants.rs
#
# The steps are in sphere_tmpl.inc. An opaque sphere has no inside, so only the entry counts, and
# only if it is in front of the eye. The record has the unit direction in place of the centre, and
# the squared radius relative to the square of the distance.

        .include "sphere_eye.inc"
        .include "sphere_constants.inc"

        eye_registers "k_one,k_quarter,half,whole", "radius2,distance", "lx,ly,lz,chord,disc,y,s,e"
        merges_table

function isect_pairs_constants_r16
        eye_form 1, 0x3f000000, 0x3f800000
endfunction isect_pairs_constants_r16
