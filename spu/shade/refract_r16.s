# refract_r16   rays that surfaces let through, appended to a queue; what they don't, to the mirror
#   C       struct queued *refract_r16(const struct site *, int count, struct queued *, float
#           min_weight, unsigned deepest);
#   In      $3 sites, $4 count (0 is none), $5 where the rays go: space for one more than
#           there may be, $6 minimum weight of a ray that is sent on, $7 CHAIN_STEP times the
#           rays that may come before the last of a chain; pointers 16-aligned
#   Out     a ray for each lane that lets something through, of at least the minimum weight, unless
#           the lane's is the last of its chain, in order; surfaces' mirror: T F more; $3 the rays'
#           end
#   Uses    $3-$4, $10-$79   Saves  -   Stack  0   Calls  -
#   Domain  directions and normals of length 1 within 4 ulp, normals on the ray's side; ratio from
#           1/4 to 4
#   Error   20 ulp of 1, each component of a direction, where the cosine beyond is above 0.1; below
#           it, 2 ulp over the cosine; where its square is below 16 ulp, all may be reflected or
#           not; its length within 2
#   Twin    lab/twins/src/refract.rs
#
# For the ratio e and the normal N:
#   s = e (d - (d.N) N)   along the surface; its length is the sine of refraction
#   k = 1 - s.s           below 0, all light is reflected, and F = 1
#   r = s - sqrt(k) N     or with the surface's own normal G if r does not cross it: r.G >= 0
#   F = schlick + grazing (1 - c)^5, where c is the cosine in the thinner medium: -d.N or sqrt(k)
# 1 - cosine^2 would lose the sine of a steep ray. The ray starts `leave` off
# the surface, as bounce_leave has it.

        .include "work_unit.inc"
        .include "macros.inc"
        .include "math.inc"
        .include "bounce.inc"

        .set    NEXT,55
        registers k_inside,k_one,transmittance,ratio,schlick,grazing,mirror
        registers along                                 # d.N
        registers k,beyond
        registers side                                  # r.G
        registers cosine                                # N.G
        registers wrong
        registers taken                                 # d.N of the normal that is used
        registers away                                  # 1 - c on the ray's side
        registers off                                   # 1 - c
        registers fifth
        registers share                                 # F
        registers through,thicker,t_y,t_s
        .set    total,50                                # reused
        registers ux                                    # s
        registers uy,uz

# s, k and sqrt(k) for the normal n, where along is d.n.
.macro  beyond_by along:req
    .irp axis, x,y,z
        fnms    $u\axis,\along,$n\axis,$d\axis
        fm      $u\axis,$u\axis,$ratio
    .endr
        fnms    $k,$ux,$ux,$k_one
        fnms    $k,$uy,$uy,$k
        fnms    $k,$uz,$uz,$k
        sqrt_f4 $beyond,$k,$t_y,$t_s,$k_half
.endm

bounce_shuffles

function refract_r16
        bounce_begins
        ilhu    $k_inside,0xc000                        # -2, since r.G is below 0
        ilhu    $k_one,0x3f80
next_row:
        bounce_row
        lqd     $ratio,SURFACES_ratio($a_surfaces)
        lqd     $transmittance,SURFACES_transmittance($a_surfaces)
        lqd     $schlick,SURFACES_schlick($a_surfaces)
        lqd     $grazing,SURFACES_grazing($a_surfaces)
        lqd     $mirror,SURFACES_mirror($a_surfaces)

        dot     along,d,n
        beyond_by $along
        dot     side,u,g
        dot     cosine,n,g
        fnms    $side,$beyond,$cosine,$side
        or      $side,$side,$k
        cgti    $wrong,$side,-1                         # neither is below 0
        # Values that are loaded again need no register in between.
    .irp axis, x,y,z
        lqd     $g\axis,SURFACES_plane_\axis($a_surfaces)
        selb    $n\axis,$n\axis,$g\axis,$wrong
        lqd     $d\axis,RAYS16_direction_\axis($a_rays)
    .endr
        lqd     $ratio,SURFACES_ratio($a_surfaces)
        dot     taken,d,n
        beyond_by $taken

        fa      $away,$k_one,$along
        fs      $off,$k_one,$beyond
        fcgt    $thicker,$ratio,$k_one
        selb    $off,$away,$off,$thicker
        fm      $fifth,$off,$off
        fm      $fifth,$fifth,$fifth
        fm      $fifth,$fifth,$off
        fma     $share,$fifth,$grazing,$schlick
        rotmai  $total,$k,-31
        selb    $share,$share,$k_one,$total
        fma     $mirror,$transmittance,$share,$mirror
        fnms    $through,$transmittance,$share,$transmittance
        stqd    $mirror,SURFACES_mirror($a_surfaces)

    .irp axis, x,y,z
        lqd     $g\axis,SURFACES_plane_\axis($a_surfaces)
        fnms    $r\axis,$beyond,$n\axis,$u\axis
    .endr
        bounce_leave fnms,$k_inside
        bounce_unit
        bounce_append $through
        ai      $count,$count,-1
        brnz    $count,next_row                         # at least 4 passes: a site has four rows
        bounce_ends
endfunction refract_r16
