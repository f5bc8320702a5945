# isect_pairs_unnormalised_r16   nearest entries of primary rays into spheres, any lengths
#   C       void isect_pairs_unnormalised_r16(const struct pair *, int count);
#   In      $3 pairs, $4 count (0 is none); pointers 16-aligned
#   Out     the pairs' packets: t, object, where an entry is nearer than what was there
#   Uses    $3-$4, $10-$41   Saves  -   Stack  0   Calls  -
#   Domain  direction of a length from 2^-20 to 2^20; radius > 0; centre and radius from 2^-20 to
#           2^40; t in parts of the direction's length
#   Error   12 ulp of t, eye 1.5 to 30 radii from the centre, ray within 0.995 r of it
#   Twin    lab/twins/src/sphere/unnormalised.rs
#
# The steps are in sphere_tmpl.inc. An opaque sphere has no inside, so only the entry counts, and
# only if it is in front of the eye.

        .include "sphere_eye.inc"
        .include "sphere_unnormalised.inc"

        eye_registers "k_one,half,whole", "radius2", "b,lx,ly,lz,disc,y,s,e,over_a"
        merges_table

function isect_pairs_unnormalised_r16
        eye_form 0, 0x3f000000, 0x3f800000
endfunction isect_pairs_unnormalised_r16
