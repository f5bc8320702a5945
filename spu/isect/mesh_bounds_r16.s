# mesh_bounds_r16   what the rays of packets have in common, for cull_boxes
#   C       void mesh_bounds_r16(const struct rays16 *, int count, struct mesh_bound *,
#                                const struct shear *);
#   In      $3 RAYS16, consecutive, $4 count (0 is none), $5 MESH_BOUNDs likewise, $6 the
#           packets' SHEARS likewise, whose addresses go to the bounds; pointers 16-aligned
#   Out     the bounds
#   Uses    $3-$6, $10-$60   Saves  -   Stack  0   Calls  -
#   Domain  origins below 2^60; components of directions up to 1; t has a sign where no ray is, and
#           anything else there
#   Error   0: no ray meets a plane earlier or later than its bound
#   Twin    lab/twins/src/mesh.rs
#
# For an axis on which the origins are from o_min to o_max, and the directions from d_min to d_max,
# the times at which a ray meets a plane at p, when it comes from outside a box or leaves it, are
#   all up, d_min > 2^-60       from (p - o_max) / d_max on for the lower plane,
#                               to (p - o_min) / d_min for the upper one
#   all down, d_max < -2^-60    from (p - o_min) / d_min on for the upper plane,
#                               to (p - o_max) / d_max for the lower one
#   up and down                 from (p - o_max) / d_max on for the lower plane,
#                               from (p - o_min) / d_min on for the upper one
# In the last case d_max is at least 2^-60, and d_min at most -2^-60, so that nothing overflows:
# rays along the other axes meet neither plane from outside, or very late. The quotients are stored
# as scale p + shift with the scale 1/d. The first is made smaller by 2^-21, the second larger, in
# magnitude, so that their order is safe from rounding. The origins are moved apart by 2^-19 of the
# largest magnitude of all their coordinates, rounded up to six digits.

        .include "work_unit.inc"
        .include "macros.inc"
        .include "transpose.inc"
        .include "reciprocal.inc"
        .include "extremes.inc"

        .set    NEXT,3
        registers a_packet,count,a_bound,a_shear
        # constants
        .set    NEXT,10
        registers m_first,m_last                        # of transpose
        registers k_most,k_least                        # the largest single, and minus that
        registers k_below_one,k_above_one,k_slack,k_up,m_slack,k_tiny,k_minus_tiny,k_none,k_zero
        registers m_sign
        # the rays
        registers there,v
        # the extremes, x, y, z; and the largest t
        registers origin_min                            # to 27
        .set    NEXT,origin_min+4
        registers origin_max                            # to 31
        .set    NEXT,origin_max+4
        registers direction_min                         # to 35
        .set    NEXT,direction_min+4
        registers direction_max                         # to 39
        .set    NEXT,direction_max+4
        registers t_words                               # to 43
        .set    NEXT,t_words+4
        registers t_rows                                # to 47
        .set    NEXT,t_rows+4
        # axes in the lanes
        registers o_min,o_max,d_min,d_max
        registers c_greater,down,t_y,t_e,everywhere,m_splat
        registers near_scale,far_scale,near_shift,far_shift
        # reused
        .set    extent,there
        .set    slack,there
        .set    turned,v
        .set    up,origin_min
        .set    near,origin_min+1
        .set    far,origin_min+2
        .set    planes,origin_min+3
        .set    last,origin_max

        transpose_table .rodata.mesh
near_planes:                                            # the slack goes to their upper halves
        .int    BOXES_lo_x,BOXES_lo_y,BOXES_lo_z,0
shears_and_farthest:
        .int    0x80808080,0x80808080,0x00010203,0x1c1d1e1f
planes_and_others:
        .int    0x00010203,0x06070a0b,0x18191a1b,0x1c1d1e1f

# Extends a pair of extremes by a field of the row's rays.
.macro  extend low:req, high:req, field:req, row:req
        lqd     $v,\field+16*\row($a_packet)
        fcgt    $c_greater,\low,$v
        and     $c_greater,$c_greater,$there
        selb    \low,\low,$v,$c_greater
        fcgt    $c_greater,$v,\high
        and     $c_greater,$c_greater,$there
        selb    \high,\high,$v,$c_greater
.endm

# out = the extremes of x, y, z, and the fourth one, over the four lanes of each.
.macro  over_lanes out:req, of:req, extreme:req
        transpose t_rows,\of,t_words,$m_first,$m_last
        \extreme $t_rows,$t_rows+1,$c_greater
        \extreme $t_rows+2,$t_rows+3,$c_greater
        \extreme $t_rows,$t_rows+2,$c_greater
        ori     \out,$t_rows,0
.endm

.macro  put_axes value:req, field:req
    .irp axis, x,y,z
        splat_lane \axis
        shufb   $everywhere,\value,\value,$m_splat
        stqd    $everywhere,MESH_BOUND_\field\()_\axis($a_bound)
    .endr
.endm

.macro  splat_lane axis:req
    .ifc \axis,x
        load_constant $m_splat,0x00010203
    .endif
    .ifc \axis,y
        load_constant $m_splat,0x04050607
    .endif
    .ifc \axis,z
        load_constant $m_splat,0x08090a0b
    .endif
.endm

function mesh_bounds_r16
        biz     $count,$lr
        lqa     $m_first,transpose_first
        lqa     $m_last,transpose_last
        load_constant $k_most,0x7fffffff
        il      $k_least,-1
        load_constant $k_below_one,0x3f7ffff8           # 1 - 2^-21
        load_constant $k_above_one,0x3f800004           # 1 + 2^-21
        ilhu    $k_slack,0x3600                         # 2^-19
        load_constant $k_up,0x3ffff
        ilhu    $m_slack,0xfffc
        ilhu    $k_tiny,0x2180                          # 2^-60
        ilhu    $k_minus_tiny,0xa180
        ilhu    $k_none,0xbf80                          # -1
        il      $k_zero,0
        ilhu    $m_sign,0x8000
next_bound:
    .irp lane, 0,1,2
        ori     $origin_min+\lane,$k_most,0
        ori     $origin_max+\lane,$k_least,0
        ori     $direction_min+\lane,$k_most,0
        ori     $direction_max+\lane,$k_least,0
    .endr
        ori     $direction_max+3,$k_none,0
    .irp row, 0,1,2,3
        lqd     $v,RAYS16_t+16*\row($a_packet)
        cgti    $there,$v,-1
        cgt     $c_greater,$v,$direction_max+3
        and     $c_greater,$c_greater,$there
        selb    $direction_max+3,$direction_max+3,$v,$c_greater
        extend  $origin_min,$origin_max,RAYS16_origin_x,\row
        extend  $origin_min+1,$origin_max+1,RAYS16_origin_y,\row
        extend  $origin_min+2,$origin_max+2,RAYS16_origin_z,\row
        extend  $direction_min,$direction_max,RAYS16_direction_x,\row
        extend  $direction_min+1,$direction_max+1,RAYS16_direction_y,\row
        extend  $direction_min+2,$direction_max+2,RAYS16_direction_z,\row
    .endr
        # The fourth is z again, except where it is t.
        ori     $origin_min+3,$origin_min+2,0
        ori     $origin_max+3,$origin_max+2,0
        ori     $direction_min+3,$direction_min+2,0
        over_lanes $o_min,origin_min,minimum_f4
        over_lanes $o_max,origin_max,maximum
        over_lanes $d_min,direction_min,minimum_f4
        over_lanes $d_max,direction_max,maximum
        # The origins' extremes, moved apart.
        andc    $extent,$o_min,$m_sign
        andc    $turned,$o_max,$m_sign
        maximum $extent,$turned,$c_greater
        rotqbyi $turned,$extent,8
        maximum $extent,$turned,$c_greater
        rotqbyi $turned,$extent,4
        maximum $extent,$turned,$c_greater
        fm      $slack,$extent,$k_slack
        a       $slack,$slack,$k_up                     # rounded up
        and     $slack,$slack,$m_slack
        fs      $o_min,$o_min,$slack
        fa      $o_max,$o_max,$slack
        # near and far: the directions whose inverses are the scales.
        fcgt    $down,$k_minus_tiny,$d_max
        fcgt    $up,$d_min,$k_tiny
        fcgt    $c_greater,$d_max,$k_tiny
        selb    $near,$k_tiny,$d_max,$c_greater
        selb    $near,$near,$d_min,$down
        fcgt    $c_greater,$k_minus_tiny,$d_min
        selb    $far,$k_minus_tiny,$d_min,$c_greater
        selb    $far,$far,$d_min,$up
        selb    $far,$far,$d_max,$down
        reciprocal_f4 $near_scale,$near,$t_y,$t_e,$k_below_one
        reciprocal_f4 $far_scale,$far,$t_y,$t_e,$k_above_one
        selb    $near_shift,$o_max,$o_min,$down
        selb    $far_shift,$o_min,$o_max,$down
        fnms    $near_shift,$near_shift,$near_scale,$k_zero
        fnms    $far_shift,$far_shift,$far_scale,$k_zero
        put_axes $near_scale,near_scale
        put_axes $near_shift,near_shift
        put_axes $far_scale,far_scale
        put_axes $far_shift,far_shift
        lqa     $planes,near_planes
        il      $last,BOXES_hi_x-BOXES_lo_x
        and     $last,$last,$down
        a       $planes,$planes,$last
        or      $planes,$planes,$slack
        lqa     $m_splat,shears_and_farthest
        shufb   $last,$a_shear,$d_max,$m_splat
        lqa     $m_splat,planes_and_others
        shufb   $last,$planes,$last,$m_splat
        stqd    $last,MESH_BOUND_slack($a_bound)
    .rept   2                                           # ai reaches to 511
        ai      $a_packet,$a_packet,RAYS16_SIZE/2
        ai      $a_shear,$a_shear,SHEARS_SIZE/2
    .endr
        ai      $a_bound,$a_bound,MESH_BOUND_SIZE
        ai      $count,$count,-1
        brnz    $count,next_bound
        bi      $lr
endfunction mesh_bounds_r16
