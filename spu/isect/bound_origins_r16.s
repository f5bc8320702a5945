# bound_origins_r16   where the rays of packets are within whose directions are bounded already
#   C       void bound_origins_r16(const struct rays16 *, int count, struct bound *);
#   In      $3 RAYS16, consecutive, $4 count (at least 1), $5 BOUNDs, as bound_fan_r16
#           makes them of any point; pointers 16-aligned
#   Out     the bounds' apexes and radii, those of the rays
#   Uses    $3-$5, $10-$60   Saves  -   Stack  0   Calls  -
#   Domain  origins below 2^60, of rays whose t has no sign; others are not there, and anything
#   Error   0: no origin is outside; apex and radius allow for the rounding of cull_nodes
#   Twin    lab/twins/src/bound.rs
#
# The apex is the mean of the origins. With the largest r = |origin - apex|,
#   radius = r (1 + 2^-18) + 2^-18 |apex|, where |apex| is the sum of its components' magnitudes.
# Without any ray, the radius is minus the largest single.

        .include "bound_tmpl.inc"
        .include "flat.inc"

        # constants
        .set    m_w,49
        .set    k_slack,50
        .set    k_grown,51
        .set    m_sign,52
        .set    m_limits,53
        # the packet
        .set    rays,54
        .set    apex,55
        .set    apex_x,56
        .set    apex_y,57
        .set    apex_z,58
        .set    top,59
        .set    radius,60
        .set    limits,61

        quadword_constants
sine_and_radius:
        .int    0x00010203,0x10111213,0x80808080,0x80808080

function bound_origins_r16
        bound_constants
        ilhu    $k_weight,0x3f80
        load_constant $m_w,0x0c0d0e0f
        ilhu    $k_slack,0x3680                         # 2^-18
        load_constant $k_grown,0x3f800020               # 1 + 2^-18
        ilhu    $m_sign,0x8000
        lqa     $m_limits,sine_and_radius
next_packet:
        bound_weights
        fa      $sum+3,$weight,$weight+1
        fa      $t_e,$weight+2,$weight+3
        fa      $sum+3,$sum+3,$t_e
        sum_rows origin
        shufb   $rays,$t_rows,$t_rows,$m_w
        reciprocal_f4 $inverse,$rays,$t_y,$t_e,$k_one
        fm      $apex,$t_rows,$inverse
        stqd    $apex,BOUND_apex($a_bound)
    .irp axis, x,y,z
        shufb   $apex_\axis,$apex,$apex,$m_\axis
        stqd    $apex_\axis,BOUND_apex_\axis($a_bound)
    .endr
    .irp row, 0,1,2,3
    .irp axis, x,y,z
        lqd     $v\axis,RAYS16_origin_\axis+16*\row($a_packet)
        fs      $v\axis,$v\axis,$apex_\axis
    .endr
    .ifc \row,0
        square_row 0,$top
    .else
        square_row \row
        maximum $top,$squared
    .endif
    .endr
        rotqbyi $t,$top,4
        maximum $top,$t
        rotqbyi $t,$top,8
        maximum $top,$t
        sqrt_f4 $radius,$top,$t_y,$t_e,$k_half
        fm      $radius,$radius,$k_grown
        andc    $apex,$apex,$m_sign
        rotqbyi $t_y,$apex,4
        rotqbyi $t_e,$apex,8
        fa      $apex,$apex,$t_y
        fa      $apex,$apex,$t_e                        # in the first lane
        fma     $radius,$apex,$k_slack,$radius
        shufb   $radius,$radius,$radius,$m_x
        ceqi    $none,$rays,0
        or      $radius,$radius,$none                   # all ones is the largest single below 0
        stqd    $radius,BOUND_radius($a_bound)
        lqd     $limits,BOUND_limits($a_bound)
        shufb   $limits,$limits,$radius,$m_limits
        stqd    $limits,BOUND_limits($a_bound)
        next_bound next_packet
        bi      $lr
endfunction bound_origins_r16
