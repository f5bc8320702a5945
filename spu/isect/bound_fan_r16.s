# bound_fan_r16   what the rays of packets are within that all go through one point, or end there
#   C       void bound_fan_r16(const struct rays16 *, int count, struct bound *,
#                              const struct light *, float along);
#   In      $3 RAYS16, consecutive, $4 count (at least 1), $5 BOUNDs, $6 LIGHT, whose
#           position is the point, $7 1 if the rays start there, -1 if they end there; pointers
#           16-aligned
#   Out     the packets' bounds, consecutive: of rays that end there, as if they came from
#           there
#   Uses    $3-$5, $10-$70   Saves  -   Stack  0   Calls  -
#   Domain  |d| = 1 within 4 ulp, of rays whose t has no sign; others are not there, and anything.
#           The rays' ends at the point are within LIGHT_near of it, the rounding of cull_nodes
#           included
#   Error   0: no ray is outside; axis, cosine and sine allow for the rounding of cull_nodes
#   Twin    lab/twins/src/bound.rs
#
# The apex is the point, and the radius is LIGHT_near: a ray that ends there is the same segment,
# by its t, as one that comes from there. The axis is the normalised mean of the directions. For
# unit vectors, the square of the chord is c = |d - axis|^2 = 2 - 2 cos. With the largest chord,
#   cosine = (1 - c/2) (1 - 2^-12)        because cull_nodes computes a length to 12 bits
#   sine = sqrt(c - c^2/4) + 2^-18        because the relative error of c is about 2^-20
# If a direction is more than 79 degrees from the axis, the cone is of little use. Near a right
# angle, sine^2 + cosine^2 would exceed 1, but cull_nodes relies on it being less. Then axis,
# cosine and sine are all 0. The same holds if the sum of the directions is too short for such a
# cone, which has at least 3/16 in length, and might be 0. Without any ray, sine and radius are
# minus the largest single.
#
# Tried: axes and chords in one loop. It takes 101 cycles a packet instead of 106, but has five
# stages. The code is 0.4 KB larger, and a call takes correspondingly longer until the stages are
# full.

        .include "bound_tmpl.inc"

        .set    a_light,6
        .set    along,7
        # constants
        .set    k_along,12                              # the weight: 1, or -1 to reverse the rays
        .set    k_short,8
        .set    k_wide,9
        .set    k_cosine,49
        .set    k_chord,50
        .set    k_quarter,51                            # by lanes: chord, t
        .set    k_sine,52                               # the same: 1, 0
        .set    k_least,53                              # the same: smallest sine, radius
        .set    m_even,54
        .set    m_odd,55
        # of all packets
        .set    apex,56
        .set    apex_x,57
        .set    apex_y,58
        .set    apex_z,59
        # before the loops
        .set    light,60
        .set    m_least,61
        .set    packets,62
        .set    a_first,63
        # the axis
        .set    axis,64
        .set    axis_x,65
        .set    axis_y,66
        .set    axis_z,67
        .set    length,68                               # squared
        .set    c_short,69
        # the cone
        .set    top,31                                  # chord^2, t; the sums are no longer needed
        .set    top_t,32
        .set    most,33                                 # of all lanes: chord^2, t
        .set    t_odd,34
        .set    root,70
        .set    cosine,71
        .set    c_wide,72
        .set    limits,73
        .set    a_first_bound,74

        quadword_constants
quarter_by_lane:
        .float  0.25,0,0,0
sine_by_lane:
        .float  1,0,0,0
least_by_lane:                                          # 2^-18
        .int    0x36800000,0,0,0
# The even-numbered words of two quadwords, and the odd-numbered ones.
even_words:
        .int    0x00010203,0x10111213,0x08090a0b,0x18191a1b
odd_words:
        .int    0x04050607,0x14151617,0x0c0d0e0f,0x1c1d1e1f
# The smallest sine, and the light's distance of the rays from it.
least_and_near:
        .int    0x00010203,0x1c1d1e1f,0x80808080,0x80808080

function bound_fan_r16
        bound_constants
        shufb   $k_along,$along,$along,$m_x
        ilhu    $k_short,0x3d00                         # 1/32, less than (3/16)^2
        ilhu    $k_wide,0x3fd0                          # 2 - 2 (3/16)
        load_constant $k_cosine,0x3f7ff000              # 1 - 2^-12
        load_constant $k_chord,0x3efff000               # half of it
        lqa     $k_quarter,quarter_by_lane
        lqa     $k_sine,sine_by_lane
        lqa     $k_least,least_by_lane
        lqa     $m_even,even_words
        lqa     $m_odd,odd_words
        lqa     $m_least,least_and_near
        lqd     $light,LIGHT_near&~15($a_light)
        shufb   $k_least,$k_least,$light,$m_least
        lqd     $apex,LIGHT_position($a_light)
    .irp axis, x,y,z
        shufb   $apex_\axis,$apex,$apex,$m_\axis
    .endr
        ori     $packets,$count,0
        ori     $a_first,$a_packet,0
        ori     $a_first_bound,$a_bound,0
        il      $sum+3,0
next_axis:
        bound_weights
        sum_rows direction
        fm      $length,$t_rows,$t_rows
        rotqbyi $t_y,$length,4
        rotqbyi $t_e,$length,8
        fa      $length,$length,$t_y
        fa      $length,$length,$t_e
        shufb   $length,$length,$length,$m_x
        rsqrt_f4 $inverse,$length,$t_y,$t_e,$k_half,$k_one
        fm      $axis,$t_rows,$inverse
        fcgt    $c_short,$k_short,$length
        stqd    $axis,BOUND_axis($a_bound)
        stqd    $c_short,BOUND_limits($a_bound)
        next_bound next_axis

        ori     $count,$packets,0
        ori     $a_packet,$a_first,0
        ori     $a_bound,$a_first_bound,0
next_cone:
        lqd     $axis,BOUND_axis($a_bound)
        lqd     $c_short,BOUND_limits($a_bound)
    .irp axis, x,y,z
        shufb   $axis_\axis,$axis,$axis,$m_\axis
    .endr
    .irp row, 0,1,2,3
    .ifc \row,0
        lqd     $top_t,RAYS16_t($a_packet)
        cgti    $there,$top_t,-1
    .else
        lqd     $t,RAYS16_t+16*\row($a_packet)
        cgti    $there+\row,$t,-1
    .endif
    .irp axis, x,y,z
        lqd     $v\axis,RAYS16_direction_\axis+16*\row($a_packet)
        fms     $v\axis,$v\axis,$k_along,$axis_\axis
    .endr
    .ifc \row,0
        square_row 0,$top
    .else
        square_row \row
        maximum $top,$squared
        maximum $top_t,$t
    .endif
    .endr
        shufb   $most,$top,$top_t,$m_even
        shufb   $t_odd,$top,$top_t,$m_odd
        maximum $most,$t_odd
        rotqbyi $t_odd,$most,8
        maximum $most,$t_odd
        fm      $t_y,$most,$k_quarter
        fnms    $t,$t_y,$most,$most
        sqrt_f4 $root,$t,$t_y,$t_e,$k_half
        fnms    $cosine,$most,$k_chord,$k_cosine
        fcgt    $c_wide,$most,$k_wide
        or      $c_wide,$c_wide,$c_short
        shufb   $c_wide,$c_wide,$c_wide,$m_x
        shufb   $t,$most,$most,$m_y
        rotmai  $none,$t,-31
        fma     $limits,$root,$k_sine,$k_least
        andc    $cosine,$cosine,$c_wide
        andc    $axis,$axis,$c_wide
        shufb   $t_y,$limits,$limits,$m_y
        andc    $limits,$limits,$c_wide
        or      $t_y,$t_y,$none                         # all ones is the largest single below 0
        or      $limits,$limits,$none
        stqd    $t_y,BOUND_radius($a_bound)
        shufb   $limits,$limits,$limits,$m_x
        stqd    $limits,BOUND_sine($a_bound)
        shufb   $limits,$limits,$t_y,$m_even
        stqd    $limits,BOUND_limits($a_bound)
        put_splat $cosine,cosine,$m_x
        put_splat $axis,axis_x,$m_x
        put_splat $axis,axis_y,$m_y
        put_splat $axis,axis_z,$m_z
        stqd    $axis,BOUND_axis($a_bound)
        stqd    $t,BOUND_farthest($a_bound)
        stqd    $apex,BOUND_apex($a_bound)
    .irp axis, x,y,z
        stqd    $apex_\axis,BOUND_apex_\axis($a_bound)
    .endr
        next_bound next_cone
        bi      $lr
endfunction bound_fan_r16
