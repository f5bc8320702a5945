# any_spheres_r16   which of sixteen rays any sphere of an array blocks
#   C       unsigned any_spheres_r16(const struct rays *, const struct ball *, int count);
#   In      $3 rays, $4 spheres, $5 count (0 is none); pointers 16-aligned
#   Out     $3 a bit a ray, 0x8000 of the first: hit between 0 and t. None for a ray whose t is not
#           above 0
#   Uses    $2-$70   Saves  -   Stack  0   Calls  -
#   Domain  |d| = 1 within 4 ulp; radius > 0; coordinates and radius below 2^62
#   Error   30 ulp of the larger of t and r, by which t may be on the wrong side of the hit; origin up
#           to 30 radii from the centre, ray within 0.995 r of it
#   Twin    oracle/src/twin/ball.rs
#
# Leaves between chunks of CHUNK spheres as soon as no ray is left unblocked: a look costs about a
# quarter of a sphere, and within a chunk the loop is free of exits, as a pipelined one must be. The
# steps are in ball_tmpl.inc.

        .include "work_unit.inc"
        .include "macros.inc"
        .include "ball_tmpl.inc"

        .set    CHUNK,8

        .set    active,2
        .set    blocked,3
        .set    a_rays,3
        .set    a_ball,4
        .set    count,5
        .set    chunk,69
        .set    c_part,70

        ball_any_shuffles

function any_spheres_r16
        ball_masks
        ball_rays $a_rays
        ball_any_start
        ball_any_code $active
        lr      $code,$active
next_chunk:
        brz     $code,done
        brz     $count,done
        il      $chunk,CHUNK
        cgt     $c_part,$chunk,$count
        selb    $chunk,$chunk,$count,$c_part
        sf      $count,$chunk,$count
next_ball:
        ball_splat $a_ball
    .irp row, 0,1,2,3
        ball_any \row
    .endr
        ai      $a_ball,$a_ball,BALL_SIZE
        ai      $chunk,$chunk,-1
        brnz    $chunk,next_ball
        ball_any_code $code
        br      next_chunk
done:
        xor     $blocked,$active,$code
        bi      $lr
endfunction any_spheres_r16
