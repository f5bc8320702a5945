# isect_sphere_r16   nearest hit of sixteen rays with one sphere
#   C       void isect_sphere_r16(struct rays *, const struct sphere *, int object);
#   In      $3 rays, $4 sphere, $5 object number; pointers 16-aligned
#   Out     rays: t, object, where a hit is at 0 < t < the t that was there
#   Uses    $3-$5, $10-$66   Saves  -   Stack  0   Calls  -
#   Domain  |d| = 1 within 4 ulp; radius > 0; coordinates and radius below 2^62; t not below 0 (0
#           leaves the ray alone)
#   Error   40 ulp of the larger of t and r, origin up to 30 radii from the centre, ray within
#           0.995 r of it
#   Twin    lab/twins/src/sphere_ray.rs
#
# The hit is the entry, or the exit for a ray from inside. A ray that starts at least 6 ulp of r
# above the surface and leaves it does not hit it again. The steps are in sphere_ray_tmpl.inc.

        .include "work_unit.inc"
        .include "macros.inc"
        .include "sphere_ray_tmpl.inc"

        .set    NEXT,3
        registers a_rays,a_sphere,object
        # constants
        .set    NEXT,10
        registers m_x,m_y,m_z,m_radius2,k_half,k_one,m_sign,a_merges
        # the sphere
        registers quadword,cx,cy,cz,radius2
        # the rays: rows 0 to 3
        registers ox
        .set    oy,27
        .set    oz,31
        .set    dx,35
        .set    dy,39
        .set    dz,43
        .set    t_best,47                               # of the nearest hit so far: -t
        .set    nearest,51
        # temporaries
        .set    NEXT,55
        registers fx,fy,fz,b,disc,out,y,s,e,t,hit,merge

        sphere_merges

function isect_sphere_r16
        sphere_masks
        sphere_nearest_constants
        sphere_splat $a_sphere
        shufb   $object,$object,$object,$m_x
        sphere_rays $a_rays
    .irp row, 0,1,2,3
        lqd     $nearest+\row,RAYS_object+16*\row($a_rays)
        sphere_turn_t \row
        sphere_nearest \row, $object
        sphere_turn_t \row
        stqd    $t_best+\row,RAYS_t+16*\row($a_rays)
        stqd    $nearest+\row,RAYS_object+16*\row($a_rays)
    .endr
        bi      $lr
endfunction isect_sphere_r16
