# any_spheres_r16   which of sixteen rays any sphere of an array blocks
#   C       unsigned any_spheres_r16(const struct rays *, const struct sphere *, int count);
#   In      $3 rays, $4 spheres, $5 count (0 is none); pointers 16-aligned
#   Out     $3 a bit a ray, 0x8000 of the first: hit between 0 and t. None for a ray whose t is not
#           above 0
#   Uses    $3-$5, $10-$69   Saves  -   Stack  0   Calls  -
#   Domain  |d| = 1 within 4 ulp; radius > 0; coordinates and radius below 2^62
#   Error   30 ulp of the larger of t and r: nearer to a hit, t may count as on its other side;
#           origin up to 30 radii from the centre, ray within 0.995 r of it
#   Twin    lab/twins/src/sphere_ray.rs
#
# Between chunks of CHUNK spheres, the kernel returns if no ray is unblocked. Within a chunk the
# loop has no exits, as a pipelined loop must: draining, checking and filling it again costs about
# as much as a sphere. The steps are in sphere_ray_tmpl.inc.

        .include "work_unit.inc"
        .include "macros.inc"
        .include "sphere_ray_tmpl.inc"

        .set    CHUNK,8

        .set    blocked,3
        .set    NEXT,3
        registers a_rays,a_sphere,count
        # results
        .set    NEXT,10
        registers active,code
        # the chunk
        registers chunk,c_short
        # constants
        registers m_x,m_y,m_z,m_radius2,m_even,m_gather
        # the sphere
        registers quadword,cx,cy,cz,radius2
        # the rays: rows 0 to 3
        registers ox
        .set    oy,29
        .set    oz,33
        .set    dx,37
        .set    dy,41
        .set    dz,45
        .set    t_best,49
        .set    unblocked,53                            # its sign counts
        # temporaries
        .set    NEXT,57
        registers fx,fy,fz,b,disc,out,ahead,past,clear,either,first,second,zero

        sphere_any_shuffles

function any_spheres_r16
        sphere_masks
        sphere_rays $a_rays
        sphere_any_start
        sphere_any_code $active
        lr      $code,$active
next_chunk:
        brz     $code,done
        brz     $count,done
        il      $chunk,CHUNK
        cgt     $c_short,$chunk,$count
        selb    $chunk,$chunk,$count,$c_short
        sf      $count,$chunk,$count
next_sphere:
        sphere_splat $a_sphere
    .irp row, 0,1,2,3
        sphere_any \row
    .endr
        ai      $a_sphere,$a_sphere,BARE_SPHERE_SIZE
        ai      $chunk,$chunk,-1
        brnz    $chunk,next_sphere
        sphere_any_code $code
        br      next_chunk
done:
        xor     $blocked,$active,$code
        bi      $lr
endfunction any_spheres_r16
