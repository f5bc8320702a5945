# isect_pairs_newton2_r16   nearest entries of primary rays into spheres, two steps for the root
#   C       void isect_pairs_newton2_r16(const struct pair *, int count);
#   In      $3 pairs, $4 count (0 is none); pointers 16-aligned
#   Out     the pairs' packets: t, object, where an entry is nearer than what was there
#   Uses    $3-$4, $10-$38   Saves  -   Stack  0   Calls  -
#   Domain  |d| = 1 within 4 ulp; radius > 0; centre and radius below 2^62
#   Error   12 ulp of t, eye 1.5 to 30 radii from the centre, ray within 0.995 r of it
#   Twin    lab/twins/src/sphere/newton2.rs
#
# The steps are in sphere_tmpl.inc. An opaque sphere has no inside, so only the entry counts, and
# only if it is in front of the eye.

        .include "sphere_eye.inc"
        .include "sphere_newton2.inc"

        eye_registers "k_half", "radius2", "b,lx,ly,lz,disc,y,s,e"
        merges_table

function isect_pairs_newton2_r16
        eye_form 0
endfunction isect_pairs_newton2_r16
