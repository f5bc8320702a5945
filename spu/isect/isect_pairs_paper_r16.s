# isect_pairs_paper_r16   nearest entries of primary rays into spheres, by b^2 - 4ac
#   C       void isect_pairs_paper_r16(const struct pair *, int count);
#   In      $3 pairs, $4 count (0 is none); pointers 16-aligned
#   Out     the pairs' packets: t, object, where an entry is nearer than what was there
#   Uses    $3-$4, $10-$38   Saves  -   Stack  0   Calls  -
#   Domain  |d| = 1 within 4 ulp; radius > 0; centre and radius below 2^62; eye 1.5 to 3 radii from
#           the centre
#   Error   80 ulp of t, eye 1.5 to 3 radii from the centre, ray within 0.995 r of it
#   Twin    lab/twins/src/sphere/paper.rs
#
# The steps are in sphere_tmpl.inc. An opaque sphere has no inside, so only the entry counts, and
# only if it is in front of the eye.

        .include "sphere_eye.inc"
        .include "sphere_paper.inc"

        eye_registers "k_one,half,whole", "radius2", "b,cc,disc,y,s,e"
        merges_table

function isect_pairs_paper_r16
        eye_form 1, 0x3f000000, 0x3f800000
endfunction isect_pairs_paper_r16
