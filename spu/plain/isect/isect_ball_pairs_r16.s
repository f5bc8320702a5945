# isect_ball_pairs_r16   nearest hit of packets' rays with spheres, candidate by candidate
#   C       void isect_ball_pairs_r16(const struct candidate *, int count);
#   In      $3 candidates of objects that are spheres, $4 count (0 is none); pointers 16-aligned
#   Out     the candidates' packets: t, object, where a hit has 0 < t < what was there
#   Uses    $3-$4, $10-$48   Saves  -   Stack  0   Calls  -
#   Domain  |d| = 1 within 4 ulp; coordinates and radius below 2^62, radius above 2^-40
#   Error   25 ulp of the larger of t and r, origin up to 30 radii from the centre, ray within
#           0.995 r of it
#   Twin    oracle/src/twin/ball_pairs.rs
#
# The steps are those of ball_tmpl.inc, but the root is added or taken off by what is seen: taken
# off for the entry, added for SIDES_EXIT; with SIDES_BOTH added for a ray from inside. The sign of
# the root is that of two constants of its last step, from a table by the two bits, and with
# SIDES_BOTH that of |c|^2 - r^2.

        .include "work_unit.inc"
        .include "macros.inc"
        .include "ball_tmpl.inc"
        .include "pairs.inc"

        .set    a_candidate,3
        .set    count,4
        # constants
        .set    m_x,10
        .set    m_y,11
        .set    m_z,12
        .set    k_one,13
        .set    a_controls,14
        .set    a_half,15
        .set    a_whole,16
        .set    a_by_side,17
        # the candidate
        .set    object,18
        .set    a_packet,19
        .set    quad,20
        .set    cx,21
        .set    cy,22
        .set    cz,23
        .set    radius2,24
        .set    sides,25
        .set    half,26                                 # 1/2, with the sign that the root gets
        .set    whole,27                                # 1 likewise
        .set    m_by_side,28                            # the sign's bit if a ray's side gives it
        # a row
        .set    ox,29
        .set    oy,30
        .set    oz,31
        .set    dx,32
        .set    dy,33
        .set    dz,34
        .set    t_best,35
        .set    nearest,36
        # temporaries
        .set    fx,37
        .set    fy,38
        .set    fz,39
        .set    b,40
        .set    outside,41                              # disc
        .set    disc,41
        .set    out,42
        .set    y,43
        .set    s,44
        .set    e,45
        .set    t,46
        .set    ahead,47
        .set    control,48

        sign_controls_table

# By SIDES_BOTH, then SIDES_EXIT and both.
half_by_sides:
    .irp value, 0x3f000000,0x3f000000,0xbf000000,0x3f000000
        .int    \value,\value,\value,\value
    .endr
whole_by_sides:
    .irp value, 0x3f800000,0x3f800000,0xbf800000,0x3f800000
        .int    \value,\value,\value,\value
    .endr
m_by_sides:
    .irp value, 0,0x80000000,0,0x80000000
        .int    \value,\value,\value,\value
    .endr

function isect_ball_pairs_r16
        biz     $count,$lr
        splat_words
        ilhu    $k_one,0x3f80
        ila     $a_controls,sign_controls
        ila     $a_half,half_by_sides
        ila     $a_whole,whole_by_sides
        ila     $a_by_side,m_by_sides
next_ball:
        load_candidate
        lqd     $quad,OBJECT_centre($object)
        lqd     $sides,OBJECT_offset($object)
        shufb   $object,$object,$object,$m_x
        shufb   $cx,$quad,$quad,$m_x
        shufb   $cy,$quad,$quad,$m_y
        shufb   $cz,$quad,$quad,$m_z
        shufb   $radius2,$sides,$sides,$m_x
        fm      $radius2,$radius2,$radius2
        rotqbyi $sides,$sides,OBJECT_sides-OBJECT_offset
        rotmi   $sides,$sides,-26                       # the two bits to quadwords' addresses
        lqx     $half,$a_half,$sides
        lqx     $whole,$a_whole,$sides
        lqx     $m_by_side,$a_by_side,$sides
    .irp row, 0,1,2,3
        lqd     $ox,RAYS16_origin_x+16*\row($a_packet)
        lqd     $oy,RAYS16_origin_y+16*\row($a_packet)
        lqd     $oz,RAYS16_origin_z+16*\row($a_packet)
        lqd     $dx,RAYS16_direction_x+16*\row($a_packet)
        lqd     $dy,RAYS16_direction_y+16*\row($a_packet)
        lqd     $dz,RAYS16_direction_z+16*\row($a_packet)
        ball_meet 0
        frsqest $y,$disc
        fi      $y,$disc,$y
        fm      $s,$disc,$y
        fnms    $e,$s,$y,$k_one                         # 1 - s y
        fma     $e,$e,$half,$whole
        selb    $s,$s,$out,$m_by_side
        fnms    $t,$s,$e,$b
        cgti    $ahead,$t,0
        keep_nearer \row
    .endr
        next_candidate next_ball
        bi      $lr
endfunction isect_ball_pairs_r16
