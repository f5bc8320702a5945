# isect_sphere_pairs_refined_r16   nearest hit of packets' rays with spheres, to the last digits
#   C       void isect_sphere_pairs_refined_r16(const struct candidate *, int count);
#   In      $3 candidates of objects that are spheres, $4 count (0 is none); pointers 16-aligned
#   Out     the candidates' packets: t, object, where a hit has 0 < t < what was there
#   Uses    $3-$4, $10-$51   Saves  -   Stack  0   Calls  -
#   Domain  |d| = 1 within 4 ulp; coordinates and radius below 2^62, radius above 2^-38
#   Error   8 ulp of the larger of t and r, origin up to 30 radii from the centre, ray within 0.9 r
#           of it
#   Twin    lab/twins/src/sphere/refined.rs
#
# The steps are in sphere_tmpl.inc. The hit is the entry; with SIDES_EXIT it is the exit, and with
# SIDES_BOTH it is also the exit of a ray from inside.

        .include "sphere_general.inc"
        .include "sphere_refined.inc"

        general_registers "k_one,k_two,k_half", "radius2", "out,y,s,e,rest"
        sign_controls_table
        sides_tables REFINED_STEP, REFINED_ROOT

function isect_sphere_pairs_refined_r16
        general_form
endfunction isect_sphere_pairs_refined_r16
