# mesh_eye_bounds_r16   what packets' rays from the eye have in common: bounds for cull_boxes, and
#                       windows for filter_triangles_r16
#   C       void mesh_eye_bounds_r16(const struct rays16 *, int count, struct mesh_bound *,
#                                    const struct shear *, struct mesh_window *);
#   In      $3 RAYS16, consecutive, $4 count (0 is none), $5 MESH_BOUNDs likewise, $6 the
#           packets' SHEARS likewise, whose addresses go to the bounds, $7 MESH_WINDOWs likewise;
#           pointers 16-aligned
#   Out     the bounds and the windows; after the last window, the bound of all packets together,
#           unless there is none
#   Uses    $3-$7, $10-$79   Saves  -   Stack  0   Calls  -
#   Domain  origins 0; unit directions, also of absent rays, whose t have their signs set
#   Error   0: no ray meets a plane earlier or later than its bound; each slope is 2^-18
#           within its row's window, which is more than all roundings of the slope, of the ray's
#           SHEARS, and of a vertex's slopes in filter_triangles_r16
#   Twin    lab/twins/src/mesh_rows.rs
#
# The bounds are those of mesh_bounds_r16 for rays that start at 0, with its steps. The slopes are
# those against the axis along which the first ray is longest. If a ray's component along it is
# less than 1/2, or has the other sign, the windows have everything: packets across so wide an
# angle are seldom. Absent rays count, since they go through pixels beside the others'.
#
# The loop counts up, so that it isn't pipelined. Pipelined it would take 191 cycles a packet
# instead of 242, but 4.2 KB of local store instead of 1.6.

        .include "work_unit.inc"
        .include "macros.inc"
        .include "transpose.inc"
        .include "reciprocal.inc"
        .include "extremes.inc"
        .include "shear_tmpl.inc"

        .set    NEXT,3
        registers a_rays,count,a_bound,a_shear,a_window
        # constants
        .set    NEXT,10
        registers k_one,k_sign,k_half,k_slack
        registers k_most,k_least                        # the largest single, and minus that
        registers k_below_one,k_above_one,k_tiny,k_minus_tiny,k_none,k_zero
        registers m_first,m_last                        # of transpose
        registers m_lane                                # to 27
        .set    NEXT,m_lane+4
        registers a_orders
        # the rays
        registers direction_x,direction_y,direction_z
        # the packet
        registers c_y,c_z                               # for by_longest
        registers sign,wide
        # a row
        registers x,y,z,inverse,t_y,t_e,c_greater
        # the rows' slopes
        registers slope_x
        .set    NEXT,slope_x+4
        registers slope_y
        .set    NEXT,slope_y+4
        # the extremes over the rows: x, y, z, and again z or t
        registers slope_min
        .set    NEXT,slope_min+4
        registers slope_max
        .set    NEXT,slope_max+4
        registers lanes
        .set    NEXT,lanes+4
        registers t_words
        .set    NEXT,t_words+4
        # axes in the lanes
        registers d_min,d_max,down,up
        # the extremes of all packets
        registers all_min,all_max,negative
    .if NEXT > 80
        .error  "too many registers"
    .endif
        .set    order,x
        .set    order_y,y
        .set    order_z,z
        .set    everywhere,inverse
        .set    low,slope_x
        .set    high,slope_x+1
        .set    near,slope_x
        .set    far,slope_x+1
        .set    near_scale,slope_x+2
        .set    far_scale,slope_x+3
        .set    planes,slope_y
        .set    last,slope_y+1
        .set    m_word,slope_y+2

        transpose_table .rodata.mesh
# Where filter_triangles_r16 finds the components x and y of two vertices, and then z, of a packet
# that is longest along x, y or z.
orders:
    .irp words, 0x010200,0x020001,0x000102
        .int    0x00010203+0x04040404*(\words>>16),0x10111213+0x04040404*(\words>>16)
        .int    0x00010203+0x04040404*(\words>>8&0xff),0x10111213+0x04040404*(\words>>8&0xff)
        .int    0x00010203+0x04040404*(\words&0xff),0x10111213+0x04040404*(\words&0xff)
        .int    0x80808080,0x80808080
    .endr
near_planes:                                            # the slack before them is 0
        .int    BOXES_lo_x,BOXES_lo_y,BOXES_lo_z,0
shears_and_farthest:
        .int    0x80808080,0x80808080,0x00010203,0x1c1d1e1f
planes_and_others:
        .int    0x00010203,0x06070a0b,0x18191a1b,0x1c1d1e1f

# The minimum and the maximum of each row's slopes go everywhere in their places. Everything does if
# the packet is wide.
.macro  put_limits of:req, axis:req
        transpose lanes,\of,t_words,$m_first,$m_last
        fcgt    $c_greater,$lanes,$lanes+1
        selb    $t_words,$lanes,$lanes+1,$c_greater
        selb    $t_words+1,$lanes+1,$lanes,$c_greater
        fcgt    $c_greater,$lanes+2,$lanes+3
        selb    $t_words+2,$lanes+2,$lanes+3,$c_greater
        selb    $t_words+3,$lanes+3,$lanes+2,$c_greater
        minimum_f4 $t_words,$t_words+2,$c_greater
        maximum $t_words+1,$t_words+3,$c_greater
        fs      $t_words,$t_words,$k_slack
        fa      $t_words+1,$t_words+1,$k_slack
        selb    $t_words,$t_words,$k_least,$wide
        selb    $t_words+1,$t_words+1,$k_most,$wide
    .irp row, 0,1,2,3
        shufb   $everywhere,$t_words,$t_words,$m_lane+\row
        stqd    $everywhere,MESH_WINDOW_low_\axis+16*\row($a_window)
        shufb   $everywhere,$t_words+1,$t_words+1,$m_lane+\row
        stqd    $everywhere,MESH_WINDOW_high_\axis+16*\row($a_window)
    .endr
.endm

.macro  put_order part:req, field:req
        lqd     $order,\part($a_orders)
        lqd     $order_y,\part+32($a_orders)
        lqd     $order_z,\part+64($a_orders)
        by_longest $order,$order,$order_y,$order_z
        stqd    $order,MESH_WINDOW_\field($a_window)
.endm

# out = the extremes of x, y, z, and the fourth one, over the four lanes of each.
.macro  over_lanes out:req, of:req, extreme:req
        transpose lanes,\of,t_words,$m_first,$m_last
        \extreme $lanes,$lanes+1,$c_greater
        \extreme $lanes+2,$lanes+3,$c_greater
        \extreme $lanes,$lanes+2,$c_greater
        ori     \out,$lanes,0
.endm

.macro  put_axes value:req, field:req
    .set    lane_at,0
    .irp axis, x,y,z
        shufb   $everywhere,\value,\value,$m_lane+lane_at
        stqd    $everywhere,MESH_BOUND_\field\()_\axis($a_bound)
    .set    lane_at,lane_at+1
    .endr
.endm

.macro  extend axis:req, at:req, row:req
    .if \row
        fcgt    $c_greater,$slope_min+\at,$direction_\axis
        selb    $slope_min+\at,$slope_min+\at,$direction_\axis,$c_greater
        fcgt    $c_greater,$direction_\axis,$slope_max+\at
        selb    $slope_max+\at,$slope_max+\at,$direction_\axis,$c_greater
    .else
        ori     $slope_min+\at,$direction_\axis,0
        ori     $slope_max+\at,$direction_\axis,0
    .endif
.endm

function mesh_eye_bounds_r16
        biz     $count,$lr
        sfi     $count,$count,0
        ilhu    $k_one,0x3f80
        ilhu    $k_sign,0x8000
        load_constant $k_half,0x3effffff
        ilhu    $k_slack,0x3680                         # 2^-18
        load_constant $k_most,0x7fffffff
        il      $k_least,-1
        load_constant $k_below_one,0x3f7ffff8           # 1 - 2^-21
        load_constant $k_above_one,0x3f800004           # 1 + 2^-21
        ilhu    $k_tiny,0x2180                          # 2^-60
        ilhu    $k_minus_tiny,0xa180
        ilhu    $k_none,0xbf80                          # -1
        il      $k_zero,0
        ori     $all_min,$k_most,0
        ori     $all_max,$k_least,0
        lqa     $m_first,transpose_first
        lqa     $m_last,transpose_last
        ila     $a_orders,orders
    .irp lane, 0,1,2,3
        load_constant $m_lane+\lane,0x00010203+0x04040404*\lane
    .endr
next_bound:
        # The order of the axes is the first ray's.
        lqd     $direction_x,RAYS16_direction_x($a_rays)
        lqd     $direction_y,RAYS16_direction_y($a_rays)
        lqd     $direction_z,RAYS16_direction_z($a_rays)
        fcmgt   $c_y,$direction_y,$direction_x
        selb    $z,$direction_x,$direction_y,$c_y
        fcmgt   $c_z,$direction_z,$z
        selb    $z,$z,$direction_z,$c_z
        splat   $c_y,$c_y,$m_lane
        splat   $c_z,$c_z,$m_lane
        splat   $sign,$z,$m_lane
        and     $sign,$sign,$k_sign
        il      $wide,0
        ori     $slope_max+3,$k_none,0
    .irp row, 0,1,2,3
        lqd     $direction_x,RAYS16_direction_x+16*\row($a_rays)
        lqd     $direction_y,RAYS16_direction_y+16*\row($a_rays)
        lqd     $direction_z,RAYS16_direction_z+16*\row($a_rays)
        lqd     $t_y,RAYS16_t+16*\row($a_rays)
        cgt     $c_greater,$t_y,$slope_max+3
        selb    $slope_max+3,$slope_max+3,$t_y,$c_greater
        extend  x,0,\row
        extend  y,1,\row
        extend  z,2,\row
        by_longest $x,$direction_y,$direction_z,$direction_x
        by_longest $y,$direction_z,$direction_x,$direction_y
        by_longest $z,$direction_x,$direction_y,$direction_z
        xor     $t_y,$z,$sign
        fcgt    $t_y,$t_y,$k_half
        orc     $wide,$wide,$t_y
        reciprocal_f4 $inverse,$z,$t_y,$t_e,$k_one
        fm      $slope_x+\row,$x,$inverse
        fm      $slope_y+\row,$y,$inverse
    .endr
        orx     $wide,$wide
        splat   $wide,$wide,$m_lane
        put_limits slope_x,x
        put_limits slope_y,y
        put_order 0,order
        put_order 16,depth
        # The bounds. The fourth minimum is z again, and the fourth maximum is t.
        ori     $slope_min+3,$slope_min+2,0
        over_lanes $d_min,slope_min,minimum_f4
        over_lanes $d_max,slope_max,maximum
        minimum_f4 $all_min,$d_min,$c_greater
        maximum $all_max,$d_max,$c_greater
put_bound:
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
        put_axes $near_scale,near_scale
        put_axes $far_scale,far_scale
    .irp axis, x,y,z
        stqd    $k_zero,MESH_BOUND_near_shift_\axis($a_bound)
        stqd    $k_zero,MESH_BOUND_far_shift_\axis($a_bound)
    .endr
        lqa     $planes,near_planes
        il      $last,BOXES_hi_x-BOXES_lo_x
        and     $last,$last,$down
        a       $planes,$planes,$last
        lqa     $m_word,shears_and_farthest
        shufb   $last,$a_shear,$d_max,$m_word
        lqa     $m_word,planes_and_others
        shufb   $last,$planes,$last,$m_word
        stqd    $last,MESH_BOUND_slack($a_bound)
    .rept   2                                           # ai reaches to 511
        ai      $a_rays,$a_rays,RAYS16_SIZE/2
        ai      $a_shear,$a_shear,SHEARS_SIZE/2
        ai      $a_window,$a_window,MESH_WINDOW_SIZE/2
    .endr
        ai      $a_bound,$a_bound,MESH_BOUND_SIZE
        ai      $count,$count,1
        rotmai  $negative,$count,-31
        brnz    $negative,next_bound
        # The bound of all packets goes after the last window.
        binz    $count,$lr
        ori     $d_min,$all_min,0
        ori     $d_max,$all_max,0
        ori     $a_bound,$a_window,0
        br      put_bound
endfunction mesh_eye_bounds_r16
