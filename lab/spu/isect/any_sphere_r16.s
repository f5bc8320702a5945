# any_sphere_r16   which of sixteen rays one sphere blocks
#   C       unsigned any_sphere_r16(const struct rays *, const struct sphere *);
#   In      $3 rays, $4 sphere; pointers 16-aligned
#   Out     $3 a bit a ray, 0x8000 of the first: hit between 0 and t. None for a ray whose t is not
#           above 0
#   Uses    $3-$5, $10-$67   Saves  -   Stack  0   Calls  -
#   Domain  |d| = 1 within 4 ulp; radius > 0; coordinates and radius below 2^62
#   Error   30 ulp of the larger of t and r: nearer to a hit, t may count as on its other side;
#           origin up to 30 radii from the centre, ray within 0.995 r of it
#   Twin    lab/twins/src/sphere_ray.rs
#
# The result is a word of bits, not four masks: a caller can branch on it directly, and can make
# masks of it on the odd pipe (fsm). No root is computed. The steps are in sphere_ray_tmpl.inc.

        .include "work_unit.inc"
        .include "macros.inc"
        .include "sphere_ray_tmpl.inc"

        .set    blocked,3
        .set    NEXT,3
        registers a_rays,a_sphere
        # results
        .set    NEXT,10
        registers active,code
        # constants
        registers m_x,m_y,m_z,m_radius2,m_even,m_gather
        # the sphere
        registers quadword,cx,cy,cz,radius2
        # the rays: rows 0 to 3
        registers ox
        .set    oy,27
        .set    oz,31
        .set    dx,35
        .set    dy,39
        .set    dz,43
        .set    t_best,47
        .set    unblocked,51                            # its sign counts
        # temporaries
        .set    NEXT,55
        registers fx,fy,fz,b,disc,out,ahead,past,clear,either,first,second,zero

        sphere_any_shuffles

function any_sphere_r16
        sphere_masks
        sphere_splat $a_sphere
        sphere_rays $a_rays
        sphere_any_start
        sphere_any_code $active
    .irp row, 0,1,2,3
        sphere_any \row
    .endr
        sphere_any_code $code
        xor     $blocked,$active,$code
        bi      $lr
endfunction any_sphere_r16
