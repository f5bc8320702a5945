# bound_r16   what the rays of packets are within: a ball moved along a cone
#   C       void bound_r16(const struct rays16 *, int count, struct bound *);
#   In      $3 RAYS16, one behind the other, $4 count (at least 1), $5 BOUNDs; pointers 16-aligned
#   Out     the packets' bounds, one behind the other
#   Uses    $3-$5, $10-$77   Saves  -   Stack  0   Calls  -
#   Domain  |d| = 1 within 4 ulp and origins below 2^60, of rays whose t has no sign; others are not
#           there, and anything
#   Error   0: no ray is outside; apex, axis, cosine and sine allow for the rounding of cull_nodes
#   Twin    oracle/src/twin/bound.rs
#
# The apex is the mean of the origins, the axis that of the directions at length 1. Of the rays
#   n = -d.axis, l = d + n axis   so |l| is the sine of d's angle with the axis
#   r = origin - apex
# the largest n, l^2, r^2, t are looked for, and of these
#   cosine = -n (1 - 2^-12)       for cull_nodes takes a length in 12 bits
#   sine = |l| + 2^-18            l is right to some 2^-20
#   radius = |r| (1 + 2^-18) + 2^-18 |apex|, in the sum of the components' magnitudes
# With a direction more than 79 degrees from the axis the cone is of little use, and near a right
# angle sine^2 + cosine^2 would exceed 1, where cull_nodes relies on less: then axis, cosine and sine
# are all 0. The radius is less the largest single if no ray is there.

        .include "work_unit.inc"
        .include "macros.inc"
        .include "math.inc"
        .include "rays.inc"
        .include "flat.inc"
        .include "transpose.inc"

        .set    a_packet,3
        .set    count,4
        .set    a_bound,5
        # constants
        .set    k_one,10
        .set    k_half,11
        .set    k_zero,12
        .set    k_minus_one,13
        .set    k_wide,14
        .set    k_slack,15
        .set    k_grown,16
        .set    k_shrunk,17
        .set    m_sign,18
        .set    m_first,19
        .set    m_last,20
        .set    m_x,21
        .set    m_y,22
        .set    m_z,23
        .set    m_w,24
        # rows of rays
        .set    there,25                                # to 28: masks
        .set    weight,29                               # to 32: 1 or 0
        .set    ox,33
        .set    oy,34
        .set    oz,35
        .set    dx,36
        .set    dy,37
        .set    dz,38
        # sums, then those of all lanes in the lanes
        .set    sum,39                                  # to 42: x, y, z, rays
        .set    t_words,43                              # to 46
        .set    t_rows,47                               # to 50
        # the packet
        .set    rays,51
        .set    inverse,52
        .set    apex_x,53
        .set    apex_y,54
        .set    apex_z,55
        .set    axis_x,56
        .set    axis_y,57
        .set    axis_z,58
        .set    length,59
        .set    t_y,60
        .set    t_e,61
        # largest so far
        .set    top,62                                  # to 65: n, l^2, r^2, t
        .set    n,66
        .set    l2,67
        .set    r2,68
        .set    t,69
        .set    c_greater,70
        # the bound
        .set    root,71
        .set    sine,72
        .set    cosine,73
        .set    radius,74
        .set    farthest,75
        .set    c_wide,76
        .set    none,77

        .set    WIDE,0xbe40                             # -3/16
        .set    SLACK,0x3680                            # 2^-18

.macro  maximum out:req, a:req, b:req
        fcgt    $c_greater,\a,\b
        selb    \out,\b,\a,$c_greater
.endm

# The sums over four rows of rays, in $sum to $sum+3, to one vector of the sums over all.
.macro  sum_lanes
        transpose t_rows,sum,t_words,$m_first,$m_last
        fa      $t_rows,$t_rows,$t_rows+1
        fa      $t_rows+2,$t_rows+2,$t_rows+3
        fa      $t_rows,$t_rows,$t_rows+2
.endm

# Of three fields, the sums over four rows of the rays that are there.
.macro  sum_rows field:req
    .irp row, 0,1,2,3
        lqd     $ox,RAYS16_\field\()_x+16*\row($a_packet)
        lqd     $oy,RAYS16_\field\()_y+16*\row($a_packet)
        lqd     $oz,RAYS16_\field\()_z+16*\row($a_packet)
    .ifc \row,0
        fm      $sum,$ox,$weight
        fm      $sum+1,$oy,$weight
        fm      $sum+2,$oz,$weight
    .else
        fma     $sum,$ox,$weight+\row,$sum
        fma     $sum+1,$oy,$weight+\row,$sum+1
        fma     $sum+2,$oz,$weight+\row,$sum+2
    .endif
    .endr
        sum_lanes
.endm

        transpose_table

function bound_r16
        ilhu    $k_one,0x3f80
        ilhu    $k_half,0x3f00
        il      $k_zero,0
        ilhu    $k_minus_one,0xbf80
        ilhu    $k_wide,WIDE
        ilhu    $k_slack,SLACK
        load_constant $k_grown,0x3f800020               # 1 + 2^-18
        load_constant $k_shrunk,0xbf7ff000              # -(1 - 2^-12)
        ilhu    $m_sign,0x8000
        lqa     $m_first,transpose_first
        lqa     $m_last,transpose_last
        load_constant $m_x,0x00010203
        load_constant $m_y,0x04050607
        load_constant $m_z,0x08090a0b
        load_constant $m_w,0x0c0d0e0f
next_packet:
    .irp row, 0,1,2,3
        lqd     $t,RAYS16_t+16*\row($a_packet)
        cgti    $there+\row,$t,-1
        and     $weight+\row,$there+\row,$k_one
    .endr
        fa      $sum+3,$weight,$weight+1
        fa      $t_e,$weight+2,$weight+3
        fa      $sum+3,$sum+3,$t_e
        sum_rows origin
        shufb   $rays,$t_rows,$t_rows,$m_w
        reciprocal_f4 $inverse,$rays,$t_y,$t_e,$k_one
        fm      $inverse,$t_rows,$inverse
        shufb   $apex_x,$inverse,$inverse,$m_x
        shufb   $apex_y,$inverse,$inverse,$m_y
        shufb   $apex_z,$inverse,$inverse,$m_z
        sum_rows direction
        shufb   $axis_x,$t_rows,$t_rows,$m_x
        shufb   $axis_y,$t_rows,$t_rows,$m_y
        shufb   $axis_z,$t_rows,$t_rows,$m_z
        fm      $length,$axis_x,$axis_x
        fma     $length,$axis_y,$axis_y,$length
        fma     $length,$axis_z,$axis_z,$length         # squared
        rsqrt_f4 $inverse,$length,$t_y,$t_e,$k_half,$k_one
        fm      $axis_x,$axis_x,$inverse
        fm      $axis_y,$axis_y,$inverse
        fm      $axis_z,$axis_z,$inverse
    .irp row, 0,1,2,3
    .irp axis, x,y,z
        lqd     $o\axis,RAYS16_origin_\axis+16*\row($a_packet)
        lqd     $d\axis,RAYS16_direction_\axis+16*\row($a_packet)
        fs      $o\axis,$o\axis,$apex_\axis
    .endr
        fm      $r2,$ox,$ox
        fma     $r2,$oy,$oy,$r2
        fma     $r2,$oz,$oz,$r2
        fnms    $n,$dx,$axis_x,$k_zero
        fnms    $n,$dy,$axis_y,$n
        fnms    $n,$dz,$axis_z,$n
        fma     $dx,$n,$axis_x,$dx
        fma     $dy,$n,$axis_y,$dy
        fma     $dz,$n,$axis_z,$dz
        fm      $l2,$dx,$dx
        fma     $l2,$dy,$dy,$l2
        fma     $l2,$dz,$dz,$l2
    .ifc \row,0
        selb    $top,$k_minus_one,$n,$there
        and     $top+1,$l2,$there
        and     $top+2,$r2,$there
        lqd     $top+3,RAYS16_t($a_packet)
    .else
        selb    $n,$k_minus_one,$n,$there+\row
        and     $l2,$l2,$there+\row
        and     $r2,$r2,$there+\row
        lqd     $t,RAYS16_t+16*\row($a_packet)
        maximum $top,$top,$n
        maximum $top+1,$top+1,$l2
        maximum $top+2,$top+2,$r2
        maximum $top+3,$top+3,$t
    .endif
    .endr
        transpose top,top,t_words,$m_first,$m_last
        maximum $top,$top,$top+1
        maximum $top+2,$top+2,$top+3
        maximum $top,$top,$top+2
        sqrt_f4 $root,$top,$t_y,$t_e,$k_half
        shufb   $n,$top,$top,$m_x
        shufb   $sine,$root,$root,$m_y
        shufb   $radius,$root,$root,$m_z
        shufb   $farthest,$top,$top,$m_w
        fm      $cosine,$n,$k_shrunk
        fa      $sine,$sine,$k_slack
        andc    $ox,$apex_x,$m_sign
        andc    $oy,$apex_y,$m_sign
        andc    $oz,$apex_z,$m_sign
        fa      $ox,$ox,$oy
        fa      $ox,$ox,$oz
        fm      $radius,$radius,$k_grown
        fma     $radius,$ox,$k_slack,$radius
        ceqi    $none,$rays,0
        or      $radius,$radius,$none                   # all ones is the largest single below 0
        fcgt    $c_wide,$n,$k_wide
        andc    $cosine,$cosine,$c_wide
        andc    $sine,$sine,$c_wide
    .irp axis, x,y,z
        andc    $axis_\axis,$axis_\axis,$c_wide
        stqd    $apex_\axis,BOUND_apex_\axis($a_bound)
        stqd    $axis_\axis,BOUND_axis_\axis($a_bound)
    .endr
        stqd    $cosine,BOUND_cosine($a_bound)
        stqd    $sine,BOUND_sine($a_bound)
        stqd    $radius,BOUND_radius($a_bound)
        stqd    $farthest,BOUND_farthest($a_bound)
    .rept   2
        ai      $a_packet,$a_packet,RAYS16_SIZE/2
    .endr
        ai      $a_bound,$a_bound,BOUND_SIZE
        ai      $count,$count,-1
        brnz    $count,next_packet
        bi      $lr
endfunction bound_r16
