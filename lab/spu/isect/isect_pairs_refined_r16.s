# isect_pairs_refined_r16   nearest entries of primary rays into spheres, to the last digits
#   C       void isect_pairs_refined_r16(const struct pair *, int count);
#   In      $3 pairs, $4 count (0 is none); pointers 16-aligned
#   Out     the pairs' packets: t, object, where an entry is nearer than what was there
#   Uses    $3-$4, $10-$43   Saves  -   Stack  0   Calls  -
#   Domain  |d| = 1 within 4 ulp; radius > 0; centre and radius below 2^62 and from 2^-38 on
#   Error   3.5 ulp of t, eye 2 to 1e6 radii from the centre, ray within 0.9 r of it; from 30 radii
#           on 2
#   Twin    lab/twins/src/sphere/refined.rs
# The steps are in sphere_tmpl.inc. An opaque sphere has no inside, so only the entry counts, and
# only if it is in front of the eye.
# and behind the eye it is none.

        .include "sphere_eye.inc"
        .include "sphere_refined.inc"

        eye_registers "k_one,k_two,k_scales,half,whole", "radius2", "b,lx,ly,lz,disc,y,s,e,rest"
        merges_table
# Scales the lengths by 1/2, and the squared radius by 1/4.
scales:
        .int    0x3f000000,0x3f000000,0x3f000000,0x3e800000

function isect_pairs_refined_r16
        eye_form 0, REFINED_STEP, REFINED_ROOT
endfunction isect_pairs_refined_r16
