# isect_sphere_r1   nearest hit of one ray with one sphere
#   C       void isect_sphere_r1(struct ray *, const struct ball *, int object);
#   In      $3 ray, $4 sphere, $5 object number; pointers 16-aligned
#   Out     ray: t, object, if a hit is at 0 < t < the t that was there
#   Uses    $6-$40   Saves  -   Stack  0   Calls  -
#   Domain  |d| = 1 within 4 ulp; radius > 0; coordinates and radius below 2^62; t not below 0 (0
#           leaves the ray alone)
#   Error   40 ulp of the larger of t and r, origin up to 30 radii from the centre, ray within
#           0.995 r of it
#   Twin    oracle/src/twin/ball.rs
#
# Gives the bits that isect_sphere_r16 gives: its formulas and order of sums (ball_tmpl.inc).
# Nothing but latency counts: vectors are handled as such where lanes don't meet, and every sum
# runs over splats, so that it takes no rotation and comes out in all lanes, ready for the next
# vector.
# Scheduled by spu schedule from isect_sphere_r1.s

        .include "work_unit.inc"
        .include "macros.inc"
        .include "rays.inc"

        .set    a_ray,3
        .set    a_ball,4
        .set    object,5
        # constants
        .set    k_half,6
        .set    k_one,7
        .set    m_sign,8
        .set    m_x,9
        .set    m_y,10
        .set    m_z,11
        .set    m_radius2,12
        # the ray and the sphere
        .set    origin,13
        .set    direction,14
        .set    dx,15
        .set    dy,16
        .set    dz,17
        .set    t_best,18
        .set    nearest,19
        .set    ball,20
        .set    radius2,21
        # from the origin to the centre; from the ray's nearest point to it
        .set    centre,22
        .set    cx,23
        .set    cy,24
        .set    cz,25
        .set    l,26
        .set    lx,27
        .set    ly,28
        .set    lz,29
        # temporaries, the same in all lanes
        .set    b,30
        .set    disc,31
        .set    out,32
        .set    y,33
        .set    s,34
        .set    e,35
        .set    t,36
        .set    c_meets,37
        .set    c_hit,38
        .set    minus_t,39
        .set    limit,40                                # -t of the nearest hit so far

function isect_sphere_r1
        ilhu    $m_x,1                                  # 0e
        lqd     $ball,0($a_ball)                        # 0o

        ilhu    $m_y,0x405                              # 1e
        lqd     $origin,0($a_ray)                       # 1o

        iohl    $m_x,515                                # 2e
        lqd     $direction,16($a_ray)                   # 2o

        iohl    $m_y,0x607                              # 3e
        lqd     $t_best,32($a_ray)                      # 3o

        ilhu    $m_z,0x809                              # 4e
        hbr     isect_sphere_r1_return,$lr              # 4o hint

        ilhu    $m_radius2,0xc0d                        # 5e
        lqd     $nearest,48($a_ray)                     # 5o

        iohl    $m_z,0xa0b                              # 6e
        fs      $centre,$ball,$origin                   # 7e

        iohl    $m_radius2,0xe0f                        # 8e
        shufb   $dx,$direction,$direction,$m_x          # 8o

        ilhu    $k_one,0x3f80                           # 9e
        shufb   $dy,$direction,$direction,$m_y          # 9o

        ilhu    $k_half,0x3f00                          # 10e
        shufb   $dz,$direction,$direction,$m_z          # 10o

        ilhu    $m_sign,0x8000                          # 11e
        shufb   $radius2,$ball,$ball,$m_radius2         # 11o

        xor     $limit,$t_best,$m_sign                  # 13e
        shufb   $cx,$centre,$centre,$m_x                # 13o

        shufb   $cy,$centre,$centre,$m_y                # 14o
        shufb   $cz,$centre,$centre,$m_z                # 15o

        fm      $b,$cx,$dx                              # 17e
        fma     $b,$cy,$dy,$b                           # 23e

        fma     $b,$cz,$dz,$b                           # 29e
        fnms    $l,$b,$direction,$centre                # 35e

        shufb   $lx,$l,$l,$m_x                          # 41o
        shufb   $ly,$l,$l,$m_y                          # 42o

        shufb   $lz,$l,$l,$m_z                          # 43o
        fnms    $disc,$lx,$lx,$radius2                  # 45e

        fnms    $disc,$ly,$ly,$disc                     # 51e
        fnms    $disc,$lz,$lz,$disc                     # 57e

        fms     $out,$b,$b,$disc                        # 63e
        frsqest $y,$disc                                # 63o

        cgti    $c_meets,$disc,-1                       # 64e
        fi      $y,$disc,$y                             # 67e

        fm      $s,$disc,$y                             # 74e
        fnms    $e,$s,$y,$k_one                         # 80e 1 - s y

        selb    $s,$s,$out,$m_sign                      # 81e
        fma     $e,$e,$k_half,$k_one                    # 86e

        fms     $minus_t,$s,$e,$b                       # 92e
        fnms    $t,$s,$e,$b                             # 93e

        cgt     $c_hit,$limit,$minus_t                  # 98e
        and     $c_hit,$c_hit,$c_meets                  # 100e

        selb    $t_best,$t_best,$t,$c_hit               # 102e
        selb    $nearest,$nearest,$object,$c_hit        # 103e

        stqd    $t_best,32($a_ray)                      # 104o
        stqd    $nearest,48($a_ray)                     # 105o

        nop     $127                                    # 106e pairing
isect_sphere_r1_return:
        bi      $lr                                     # 106o
endfunction isect_sphere_r1
