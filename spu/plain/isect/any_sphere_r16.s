# any_sphere_r16   which of sixteen rays one sphere blocks
#   C       unsigned any_sphere_r16(const struct rays *, const struct ball *);
#   In      $3 rays, $4 sphere; pointers 16-aligned
#   Out     $3 a bit a ray, 0x8000 of the first: hit between 0 and t. None for a ray whose t is not
#           above 0
#   Uses    $3-$68   Saves  -   Stack  0   Calls  -
#   Domain  |d| = 1 within 4 ulp; radius > 0; coordinates and radius below 2^62
#   Error   30 ulp of the larger of t and r, by which t may be on the wrong side of the hit; origin up
#           to 30 radii from the centre, ray within 0.995 r of it
#   Twin    oracle/src/twin/ball.rs
#
# A word of bits, not four masks: a caller branches on it as it is, and makes masks of it on the odd
# pipe (fsm). No root is taken; the steps are in ball_tmpl.inc.

        .include "work_unit.inc"
        .include "macros.inc"
        .include "ball_tmpl.inc"

        .set    blocked,3
        .set    a_rays,3
        .set    a_ball,4
        .set    active,5

        ball_any_shuffles

function any_sphere_r16
        ball_masks
        ball_splat $a_ball
        ball_rays $a_rays
        ball_any_start
        ball_any_code $active
    .irp row, 0,1,2,3
        ball_any \row
    .endr
        ball_any_code $code
        xor     $blocked,$active,$code
        bi      $lr
endfunction any_sphere_r16
