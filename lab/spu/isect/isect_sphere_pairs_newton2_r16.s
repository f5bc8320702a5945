# isect_sphere_pairs_newton2_r16   nearest hit of packets' rays with spheres, two steps for the
# root
#   C       void isect_sphere_pairs_newton2_r16(const struct candidate *, int count);
#   In      $3 candidates of objects that are spheres, $4 count (0 is none); pointers 16-aligned
#   Out     the candidates' packets: t, object, where a hit has 0 < t < what was there
#   Uses    $3-$4, $10-$48   Saves  -   Stack  0   Calls  -
#   Domain  |d| = 1 within 4 ulp; coordinates and radius below 2^62, radius above 2^-40
#   Error   25 ulp of the larger of t and r, origin up to 30 radii from the centre, ray within
#           0.995 r of it
#   Twin    lab/twins/src/sphere/newton2.rs
#
# The steps are in sphere_tmpl.inc. The hit is the entry; with SIDES_EXIT it is the exit, and with
# SIDES_BOTH it is also the exit of a ray from inside.

        .include "sphere_general.inc"
        .include "sphere_newton2.inc"

        general_registers "k_half", "radius2", "out,y,s,e"
        sign_controls_table
        sides_tables 0x3f000000, 0x3f800000

function isect_sphere_pairs_newton2_r16
        general_form
endfunction isect_sphere_pairs_newton2_r16
