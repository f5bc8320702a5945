# isect_sphere_pairs_double_r16   nearest hit of packets' rays with spheres, in double precision
#   C       void isect_sphere_pairs_double_r16(const struct candidate *, int count);
#   In      $3 candidates of objects that are spheres, $4 count (0 is none); pointers 16-aligned
#   Out     the candidates' packets: t, object, where a hit has 0 < t < what was there
#   Uses    $3-$4, $10-$64   Saves  -   Stack  0   Calls  -
#   Domain  |d| = 1 within 4 ulp; coordinates and radius below 2^60, radius above 2^-40; rounds to
#           the nearest
#   Error   0.51 ulp of the larger of t and r, origin up to 30 radii from the centre and beyond
#           1e-5 of one from the surface, ray within 0.995 r of it
#   Twin    lab/twins/src/sphere/double.rs
#
# The steps are in sphere_tmpl.inc. The hit is the entry; with SIDES_EXIT it is the exit, and with
# SIDES_BOTH it is also the exit of a ray from inside.

        .include "sphere_general.inc"
        .include "sphere_double.inc"

        general_registers "k_one,k_half,k_tiny,m_high,m_rows,m_sign,k_halve,k_half_double", "radius2", "cc,y,s,e,ex,ey,ez,x,near,w,q,t_even,disc_even"
        sign_controls_table
        sides_tables 0x3f000000, 0x3f800000
        double_table

function isect_sphere_pairs_double_r16
        general_form
endfunction isect_sphere_pairs_double_r16
