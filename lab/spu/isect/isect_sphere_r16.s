# isect_sphere_r16   nearest hit of sixteen rays with one sphere
#   C       void isect_sphere_r16(struct rays *, const struct ball *, int object);
#   In      $3 rays, $4 sphere, $5 object number; pointers 16-aligned
#   Out     rays: t, object, where a hit is at 0 < t < the t that was there
#   Uses    $3-$5, $10-$66   Saves  -   Stack  0   Calls  -
#   Domain  |d| = 1 within 4 ulp; radius > 0; coordinates and radius below 2^62; t not below 0 (0
#           leaves the ray alone)
#   Error   40 ulp of the larger of t and r, origin up to 30 radii from the centre, ray within
#           0.995 r of it
#   Twin    lab/twins/src/ball.rs
#
# The entry, or the exit of a ray from inside; a ray that leaves the surface outwards from 6 ulp
# of r above it does not meet it again. The steps are in ball_tmpl.inc.

        .include "work_unit.inc"
        .include "macros.inc"
        .include "ball_tmpl.inc"

        .set    a_rays,3
        .set    a_ball,4
        .set    object,5
        # constants
        .set    m_x,10
        .set    m_y,11
        .set    m_z,12
        .set    m_radius2,13
        .set    k_half,14
        .set    k_one,15
        .set    m_sign,16
        .set    a_merges,17
        # the sphere
        .set    ball,18
        .set    cx,19
        .set    cy,20
        .set    cz,21
        .set    radius2,22
        # the rays: rows 0 to 3
        .set    ox,23
        .set    oy,27
        .set    oz,31
        .set    dx,35
        .set    dy,39
        .set    dz,43
        .set    t_best,47                               # of the nearest hit so far: -t
        .set    nearest,51
        # temporaries
        .set    fx,55
        .set    fy,56
        .set    fz,57
        .set    b,58
        .set    disc,59
        .set    out,60
        .set    y,61
        .set    s,62
        .set    e,63
        .set    t,64
        .set    hit,65
        .set    merge,66

        ball_merges

function isect_sphere_r16
        ball_masks
        ball_nearest_constants
        ball_splat $a_ball
        shufb   $object,$object,$object,$m_x
        ball_rays $a_rays
    .irp row, 0,1,2,3
        lqd     $nearest+\row,RAYS_object+16*\row($a_rays)
        ball_turn_t \row
        ball_nearest \row, $object
        ball_turn_t \row
        stqd    $t_best+\row,RAYS_t+16*\row($a_rays)
        stqd    $nearest+\row,RAYS_object+16*\row($a_rays)
    .endr
        bi      $lr
endfunction isect_sphere_r16
