# reflect_r16   rays that mirrors throw back, appended to a queue
#   C       struct queued *reflect_r16(const struct site *, int count, struct queued *);
#   In      $3 sites, $4 count (0 is none), $5 where the rays go: room for one more than
#           there may be; pointers 16-aligned
#   Out     a ray for each lane whose share `mirror` is above 0, in order; $3 their end
#   Uses    $3-$4, $10-$58   Saves  -   Stack  0   Calls  -
#   Domain  directions and normals of length 1 within 4 ulp, normals on the ray's side
#   Error   5 ulp of 1, each component of a direction; where r.G is within 1e-5 of 0, either normal
#           may be taken; its length within 2
#   Twin    oracle/src/twin/reflect.rs
#
#   r = d - 2 (d.N) N, by the surface's own normal G where that does not leave it: r.G <= 0
# The ray starts at point + leave G.

        .include "work_unit.inc"
        .include "macros.inc"
        .include "bounce.inc"

        .set    mirror,53
        .set    along,54                                # d.N
        .set    along_plane,55                          # d.G
        .set    cosine,56                               # N.G
        .set    off,57                                  # r.G
        .set    twice,58

bounce_shuffles

function reflect_r16
        bounce_begins
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
        fma     $p\axis,$leave,$g\axis,$p\axis
    .endr
        bounce_unit
        bounce_append $mirror
        ai      $count,$count,-1
        brnz    $count,next_row
        bounce_ends
endfunction reflect_r16
