# reflect_r16   rays that mirrors throw back, appended to a queue
#   C       struct queued *reflect_r16(const struct site *, int count, struct queued *, float
#           min_weight, unsigned deepest);
#   In      $3 sites, $4 count (0 is none), $5 where the rays go: space for one more than
#           there may be, $6 minimum weight of a ray that is sent on, $7 CHAIN_STEP times the
#           rays that may come before the last of a chain; pointers 16-aligned
#   Out     a ray for each lane whose share `mirror` is above 0 and whose weight is not below the
#           minimum, unless the lane's is the last of its chain, in order; $3 their end
#   Uses    $3-$4, $10-$64   Saves  -   Stack  0   Calls  -
#   Domain  directions and normals of length 1 within 4 ulp, normals on the ray's side
#   Error   5 ulp of 1, each component of a direction; where r.G is within 1e-5 of 0, either normal
#           may be taken; its length within 2
#   Twin    lab/twins/src/reflect.rs
#
# r = d - 2 (d.N) N, or with the surface's own normal G if r does not leave the surface: r.G <= 0
# The ray starts `leave` off the surface, as bounce_leave has it. The ray in a small body must not
# start beyond the opposite wall: where light passes, it moves 2 leave along itself at most, else 8.

        .include "work_unit.inc"
        .include "macros.inc"
        .include "bounce.inc"

        .set    NEXT,55
        registers k_farthest,k_inside,mirror,transmittance
        registers farthest                              # one of the two
        registers along                                 # d.N
        registers along_plane                           # d.G
        registers cosine                                # N.G
        registers off                                   # r.G
        registers twice

bounce_shuffles

function reflect_r16
        bounce_begins
        ilhu    $k_farthest,0x4100                      # 8
        ilhu    $k_inside,0x4000                        # 2
next_row:
        bounce_row
        lqd     $mirror,SURFACES_mirror($a_surfaces)
        dot     along,d,n
        dot     along_plane,d,g
        dot     cosine,n,g
        fa      $twice,$along,$along
        fnms    $off,$twice,$cosine,$along_plane
        cgti    $off,$off,0
    .irp axis, x,y,z
        selb    $n\axis,$g\axis,$n\axis,$off
    .endr
        selb    $along,$along_plane,$along,$off
        fa      $twice,$along,$along
    .irp axis, x,y,z
        fnms    $r\axis,$twice,$n\axis,$d\axis
    .endr
        lqd     $transmittance,SURFACES_transmittance($a_surfaces)
        cgti    $farthest,$transmittance,0
        selb    $farthest,$k_farthest,$k_inside,$farthest
        bounce_leave fma,$farthest
        bounce_unit
        bounce_append $mirror
        ai      $count,$count,-1
        brnz    $count,next_row                         # at least 4 passes: a site has four rows
        bounce_ends
endfunction reflect_r16
