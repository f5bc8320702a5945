# mesh_eye_bounds_r16   what packets' rays from the eye have in common: bounds for cull_boxes, and
#                       windows for filter_triangles_r16
#   C       void mesh_eye_bounds_r16(const struct rays16 *, int count, struct mesh_bound *,
#                                    const struct shear *, struct mesh_window *);
#   In      $3 RAYS16, one behind the other, $4 count (0 is none), $5 MESH_BOUNDs likewise, $6 the
#           packets' SHEARS likewise, whose addresses go to the bounds, $7 MESH_WINDOWs likewise;
#           pointers 16-aligned
#   Out     the bounds and the windows
#   Uses    $2-$77   Saves  -   Stack  0   Calls  -
#   Domain  origins 0; unit directions, also of absent rays, whose t have their signs set
#   Error   0: no ray meets a plane earlier or later than the bound says; each slope is 2^-18
#           within its row's window, which is more than all roundings of the slope, of the ray's
#           SHEARS, and of a vertex's slopes in filter_triangles_r16
#   Twin    lab/twins/src/mesh_rows.rs
#
# The bounds are those of mesh_bounds_r16 for rays that start at 0, with its steps. The slopes are
# those against the axis along which the first ray is longest. If a ray's component along it is
# less than 1/2, or has the other sign, the windows have everything: packets across so wide an
# angle are seldom. Absent rays count, since they go through pixels beside the others'.
#
# The loop counts up, so that it isn't pipelined. Pipelined it would take 186 cycles a packet
# instead of 221, but 4.2 KB of local store instead of 1.6.
# Scheduled by spu schedule from mesh_eye_bounds_r16.s

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
        registers least
        .set    NEXT,least+4
        registers most
        .set    NEXT,most+4
        registers lanes
        .set    NEXT,lanes+4
        registers t_words
        .set    NEXT,t_words+4
        # axes in the lanes
        registers d_min,d_max,down,up
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

# The least and the greatest of each row's slopes go everywhere in their places. Everything does if
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
        fcgt    $c_greater,$least+\at,$direction_\axis
        selb    $least+\at,$least+\at,$direction_\axis,$c_greater
        fcgt    $c_greater,$direction_\axis,$most+\at
        selb    $most+\at,$most+\at,$direction_\axis,$c_greater
    .else
        ori     $least+\at,$direction_\axis,0
        ori     $most+\at,$direction_\axis,0
    .endif
.endm

function mesh_eye_bounds_r16
        .set direction_x_2,2; .set a_window_2,8; .set direction_z_2,9; .set a_shear_2,30
        .set direction_z_3,32; .set r3_2,33; .set direction_z_4,34; .set t_y_2,36
        .set direction_y_2,37; .set t_y_3,38; .set direction_z_5,39; .set direction_x_3,40
        .set direction_y_3,41; .set direction_x_4,43; .set direction_y_4,44; .set direction_y_5,36
        .set t_y_4,42; .set direction_x_5,45; .set c_greater_2,46; .set direction_y_6,3
        .set order_y_2,47; .set c_y_2,49; .set order_2,50; .set c_greater_3,52; .set m_word_2,54
        .set order_z_2,29; .set c_y_3,44; .set planes_2,49; .set m_word_3,55; .set order_z_3,59
        .set order_z_4,60; .set order_y_3,61; .set order_3,62; .set order_z_5,63; .set order_4,64
        .set order_z_6,46; .set c_greater_4,65; .set order_z_7,66; .set c_greater_5,67
        .set order_y_4,68; .set c_greater_6,69; .set order_5,70; .set most_2,69; .set c_z_2,71
        .set c_greater_7,72; .set c_z_3,42; .set most_3,65; .set order_z_8,9; .set c_greater_8,29
        .set sign_2,9; .set t_y_5,69; .set t_y_6,71; .set order_z_9,72; .set t_y_7,73
        .set order_6,74; .set order_z_10,34; .set t_y_8,72; .set order_y_5,39; .set order_7,2
        .set t_y_9,43; .set t_y_10,62; .set c_greater_9,71; .set t_e_2,73; .set t_e_3,75
        .set c_greater_10,76; .set t_e_4,76; .set t_e_5,71; .set least3_2,77; .set everywhere_2,69
        .set c_greater_11,73; .set everywhere_3,62; .set everywhere_4,43; .set t_y_11,63
        .set everywhere_5,71; .set far_2,2; .set near_2,63; .set c_greater_12,74; .set t_words_2,72
        .set t_words2_2,51; .set c_greater_13,38; .set order_8,53; .set most_4,29
        .set far_scale_2,53; .set last_2,43; .set t_words_3,65; .set order_y_6,3
        .set t_words3_2,39; .set t_words1_2,38; .set planes_3,3; .set t_words1_3,52
        .set order_9,31; .set t_words1_4,67; .set t_y_12,60; .set lanes2_2,68; .set t_words3_3,2
        .set order_y_7,32; .set lanes3_2,39; .set lanes_2,31; .set lanes1_2,36; .set lanes1_3,40
        .set m_word1_2,32; .set t_words3_4,41; .set m_word_4,37; .set lanes_3,51
        .set t_words2_3,53; .set lanes2_3,39; .set lanes_4,29; .set c_greater_14,31
        .set lanes2_4,45; .set t_words_4,31; .set t_y_13,9; .set lanes3_3,2; .set c_greater_15,34
        .set t_words3_5,36; .set t_words1_5,32; .set lanes_5,34; .set c_greater_16,39
        .set t_words2_4,3; .set lanes1_4,37; .set t_words2_5,31; .set lanes2_5,32
        .set c_greater_17,43; .set lanes2_6,41; .set order_10,47; .set lanes3_4,3
        .set c_greater_18,36; .set c_greater_19,9; .set t_words3_6,38; .set c_greater_20,51
        .set lanes2_7,3; .set lanes_6,3; .set c_greater_21,3; .set last_3,6; .set near_3,3
        .set near_4,9; .set everywhere_6,3; .set everywhere_7,36; .set t_words_5,34
        .set t_words1_6,2; .set c_greater_22,2; .set t_words_6,3; .set everywhere_8,6
        .set everywhere_9,29; .set t_y_14,32; .set order_11,6; .set t_y_15,29
        .set everywhere_10,31; .set t_words_7,32; .set everywhere_11,30; .set everywhere_12,33
        .set everywhere_13,9; .set t_e_6,2; .set everywhere_14,2; .set everywhere_15,8
        nop     $127                                    # 0e pairing
        biz     $count,$lr                              # 0o
        ilhu    $k_half,0x3eff                          # 1e
        lqa     $m_first,transpose_first                # 1o
        ilhu    $k_most,0x7fff                          # 2e
        lqa     $m_last,transpose_last                  # 2o
        ilhu    $k_below_one,0x3f7f                     # 3e 1 - 2^-21
        ilhu    $k_above_one,0x3f80                     # 4e 1 + 2^-21
        ilhu    $m_lane,1                               # 5e
        ilhu    $m_lane+1,0x405                         # 6e
        ilhu    $m_lane+2,0x809                         # 7e
        ilhu    $m_lane+3,0xc0d                         # 8e
        sfi     $count,$count,0                         # 9e
        ilhu    $k_one,0x3f80                           # 10e
        ilhu    $k_sign,0x8000                          # 11e
        iohl    $k_half,0xffff                          # 12e
        ilhu    $k_slack,0x3680                         # 13e 2^-18
        iohl    $k_most,0xffff                          # 14e
        il      $k_least,-1                             # 15e
        iohl    $k_below_one,0xfff8                     # 16e 1 - 2^-21
        iohl    $k_above_one,4                          # 17e 1 + 2^-21
        ilhu    $k_tiny,0x2180                          # 18e 2^-60
        ilhu    $k_minus_tiny,0xa180                    # 19e
        ilhu    $k_none,0xbf80                          # 20e -1
        il      $k_zero,0                               # 21e
        ila     $a_orders,orders                        # 22e
        iohl    $m_lane,515                             # 23e
        iohl    $m_lane+1,0x607                         # 24e
        iohl    $m_lane+2,0xa0b                         # 25e
        iohl    $m_lane+3,0xe0f                         # 26e
next_bound:
        ori     $most+3,$k_none,0                       # 0e
        lqd     $direction_x,192($3)                    # 0o
        il      $wide,0                                 # 1e
        lqd     $direction_z,352($3)                    # 1o
        il      $last,48                                # 2e
        lqd     $direction_x_2,208($3)                  # 2o
        ai      $count,$count,1                         # 3e
        lqd     $t_y,384($3)                            # 3o
        ai      $a_window_2,$a_window,144               # 4e
        lqd     $direction_z_2,320($3)                  # 4o
        ai      $a_shear_2,$a_shear,288                 # 5e
        lqd     $direction_z_3,368($3)                  # 5o
        ai      $r3_2,$3,320                            # 6e
        lqd     $direction_z_4,336($3)                  # 6o
        lqd     $t_y_2,400($3)                          # 7o
        lqd     $direction_y_2,272($3)                  # 8o
        cgt     $c_greater,$t_y,$most+3                 # 9e
        lqd     $t_y_3,432($3)                          # 9o
        nop     $127                                    # 10e pairing
        lqd     $direction_z_5,320($3)                  # 10o
        selb    $most+3,$most+3,$t_y,$c_greater         # 11e
        lqd     $direction_x_3,240($3)                  # 11o
        nop     $127                                    # 12e pairing
        lqd     $direction_y_3,288($3)                  # 12o
        cgt     $c_greater,$t_y_2,$most+3               # 13e
        lqd     $direction_x_4,192($3)                  # 13o
        nop     $127                                    # 14e pairing
        lqd     $direction_y_4,256($3)                  # 14o
        selb    $most+3,$most+3,$t_y_2,$c_greater       # 15e
        lqd     $direction_y_5,304($3)                  # 15o
        ori     $most+2,$direction_z_5,0                # 16e
        lqd     $t_y_4,416($3)                          # 16o
        ori     $least+2,$direction_z_5,0               # 17e
        lqd     $direction_x_5,224($3)                  # 17o
        fcgt    $c_greater_2,$direction_z_4,$most+2     # 18e
        lqd     $direction_y_6,256($3)                  # 18o
        ori     $least,$direction_x_4,0                 # 19e
        lqd     $order_y_2,32($a_orders)                # 19o
        fcmgt   $c_y_2,$direction_y_4,$direction_x      # 20e
        lqd     $order_2,16($a_orders)                  # 20o
        fcgt    $c_greater_3,$least+2,$direction_z_4    # 21e
        lqa     $m_word_2,shears_and_farthest           # 21o
        selb    $order_z_2,$direction_x,$direction_y_4,$c_y_2 # 22e
        shufb   $c_y_3,$c_y_2,$c_y_2,$m_lane            # 22o
        selb    $least+2,$least+2,$direction_z_4,$c_greater_3 # 23e
        lqa     $planes_2,near_planes                   # 23o
        ori     $least+1,$direction_y_6,0               # 24e
        lqa     $m_word_3,planes_and_others             # 24o
        ori     $most+1,$direction_y_6,0                # 25e
        stqd    $k_zero,64($a_bound)                    # 25o
        selb    $order_z_3,$direction_x_3,$direction_y_5,$c_y_3 # 26e
        stqd    $k_zero,160($a_bound)                   # 26o
        selb    $order_z_4,$direction_x_5,$direction_y_3,$c_y_3 # 27e
        lqd     $order_y_3,48($a_orders)                # 27o
        selb    $order_3,$direction_y_2,$direction_z_4,$c_y_3 # 28e
        stqd    $k_zero,176($a_bound)                   # 28o
        selb    $order_z_5,$direction_x_4,$direction_y_6,$c_y_3 # 29e
        lqd     $order_4,0($a_orders)                   # 29o
        selb    $most+2,$most+2,$direction_z_4,$c_greater_2 # 30e
        lqd     $order_z_6,80($a_orders)                # 30o
        cgt     $c_greater_4,$t_y_4,$most+3             # 31e
        lqd     $order_z_7,64($a_orders)                # 31o
        fcgt    $c_greater_5,$direction_z,$most+2       # 32e
        stqd    $k_zero,144($a_bound)                   # 32o
        selb    $order_y_4,$direction_z_4,$direction_x_2,$c_y_3 # 33e
        stqd    $k_zero,80($a_bound)                    # 33o
        fcgt    $c_greater_6,$least,$direction_x_2      # 34e
        stqd    $k_zero,48($a_bound)                    # 34o
        selb    $order_5,$direction_y_5,$direction_z_3,$c_y_3 # 35e
        selb    $least,$least,$direction_x_2,$c_greater_6 # 36e
        ori     $most_2,$direction_x_4,0                # 37e
        fcmgt   $c_z_2,$direction_z_2,$order_z_2        # 38e
        fcgt    $c_greater_7,$direction_x_2,$most_2     # 39e
        lnop                                            # 39o pairing
        selb    $most+3,$most+3,$t_y_4,$c_greater_4     # 40e
        shufb   $c_z_3,$c_z_2,$c_z_2,$m_lane            # 40o
        selb    $most_3,$most_2,$direction_x_2,$c_greater_7 # 41e
        selb    $order_z_8,$order_z_2,$direction_z_2,$c_z_2 # 42e
        fcgt    $c_greater_8,$direction_x_5,$most_3     # 43e
        lnop                                            # 43o pairing
        selb    $order_z_3,$order_z_3,$direction_z_3,$c_z_3 # 44e
        shufb   $sign_2,$order_z_8,$order_z_8,$m_lane   # 44o
        selb    $order_z_4,$order_z_4,$direction_z,$c_z_3 # 45e
        lnop                                            # 45o pairing
        selb    $order_z_5,$order_z_5,$direction_z_5,$c_z_3 # 46e
        frest   $t_y_5,$order_z_3                       # 46o
        selb    $order_y_4,$order_y_4,$direction_y_2,$c_z_3 # 47e
        frest   $t_y_6,$order_z_4                       # 47o
        selb    $order_z_9,$direction_x_2,$direction_y_2,$c_y_3 # 48e
        frest   $t_y_7,$order_z_5                       # 48o
        selb    $order_6,$direction_y_6,$direction_z_5,$c_y_3 # 49e
        selb    $order_z_10,$order_z_9,$direction_z_4,$c_z_3 # 50e
        fi      $t_y_5,$order_z_3,$t_y_5                # 51e
        lnop                                            # 51o pairing
        fi      $t_y_8,$order_z_5,$t_y_7                # 52e
        frest   $t_y_7,$order_z_10                      # 52o
        selb    $order_6,$order_6,$direction_x_4,$c_z_3 # 53e
        selb    $order_y_5,$direction_z_5,$direction_x_4,$c_y_3 # 54e
        selb    $order_7,$order_3,$direction_x_2,$c_z_3 # 55e
        fi      $t_y_9,$order_z_10,$t_y_7               # 56e
        fi      $t_y_10,$order_z_4,$t_y_6               # 57e
        fcgt    $c_greater_9,$direction_y_2,$most+1     # 58e
        fnms    $t_e_2,$order_z_3,$t_y_5,$k_one         # 59e
        fnms    $t_e_3,$order_z_5,$t_y_8,$k_one         # 60e
        selb    $most+1,$most+1,$direction_y_2,$c_greater_9 # 61e
        fcgt    $c_greater_9,$least+2,$direction_z      # 62e
        fcgt    $c_greater_10,$direction_y_3,$most+1    # 63e
        selb    $least+2,$least+2,$direction_z,$c_greater_9 # 64e
        selb    $most+1,$most+1,$direction_y_3,$c_greater_10 # 65e
        fcgt    $c_greater_9,$least+2,$direction_z_3    # 66e
        fnms    $t_e_4,$order_z_4,$t_y_10,$k_one        # 67e
        selb    $least+2,$least+2,$direction_z_3,$c_greater_9 # 68e
        fnms    $t_e_5,$order_z_10,$t_y_9,$k_one        # 69e
        ori     $least3_2,$least+2,0                    # 70e
        fma     $everywhere_2,$t_e_2,$t_y_5,$t_y_5      # 71e
        cgt     $c_greater_11,$t_y_3,$most+3            # 72e
        fma     $everywhere_3,$t_e_4,$t_y_10,$t_y_10    # 73e
        and     $sign_2,$sign_2,$k_sign                 # 74e
        fma     $everywhere_4,$t_e_5,$t_y_9,$t_y_9      # 75e
        xor     $t_y_11,$order_z_5,$sign_2              # 76e
        fma     $everywhere_5,$t_e_3,$t_y_8,$t_y_8      # 77e
        fcgt    $t_y_11,$t_y_11,$k_half                 # 78e
        fcgt    $c_greater_7,$least,$direction_x_5      # 79e
        orc     $wide,$wide,$t_y_11                     # 80e
        selb    $least,$least,$direction_x_5,$c_greater_7 # 81e
        fm      $far_2,$order_7,$everywhere_4           # 82e
        fm      $near_2,$order_6,$everywhere_5          # 83e
        fcgt    $c_greater_7,$least,$direction_x_3      # 84e
        fcgt    $c_greater_12,$least+1,$direction_y_2   # 85e
        selb    $least,$least,$direction_x_3,$c_greater_7 # 86e
        selb    $least+1,$least+1,$direction_y_2,$c_greater_12 # 87e
        lnop                                            # 87o pairing
        selb    $order_y,$direction_z,$direction_x_5,$c_y_3 # 88e
        shufb   $t_words_2,$least,$least+2,$m_first     # 88o
        fcgt    $c_greater_12,$least+1,$direction_y_3   # 89e
        shufb   $t_words2_2,$least,$least+2,$m_last     # 89o
        selb    $most+2,$most+2,$direction_z,$c_greater_5 # 90e
        selb    $most+3,$most+3,$t_y_3,$c_greater_11    # 91e
        fcgt    $c_greater_13,$direction_z_3,$most+2    # 92e
        selb    $least+1,$least+1,$direction_y_3,$c_greater_12 # 93e
        selb    $most+2,$most+2,$direction_z_3,$c_greater_13 # 94e
        fcgt    $c_greater_13,$least+1,$direction_y_5   # 95e
        selb    $order_8,$order_5,$direction_x_3,$c_z_3 # 96e
        selb    $most_4,$most_3,$direction_x_5,$c_greater_8 # 97e
        fm      $far_scale_2,$order_8,$everywhere_2     # 98e
        fcgt    $c_greater_4,$direction_x_3,$most_4     # 99e
        fm      $last_2,$order_y_4,$everywhere_4        # 100e
        selb    $most_4,$most_4,$direction_x_3,$c_greater_4 # 101e
        selb    $least+1,$least+1,$direction_y_5,$c_greater_13 # 102e
        lnop                                            # 102o pairing
        fcgt    $c_greater_13,$direction_y_5,$most+1    # 103e
        shufb   $t_words_3,$most_4,$most+2,$m_first     # 103o
        selb    $order_y_6,$order_y_5,$direction_y_6,$c_z_3 # 104e
        shufb   $t_words3_2,$least+1,$least3_2,$m_last  # 104o
        selb    $most+1,$most+1,$direction_y_5,$c_greater_13 # 105e
        shufb   $t_words1_2,$far_2,$far_scale_2,$m_first # 105o
        fm      $planes_3,$order_y_6,$everywhere_5      # 106e
        shufb   $t_words1_3,$least+1,$least3_2,$m_first # 106o
        selb    $order_9,$direction_y_3,$direction_z,$c_y_3 # 107e
        shufb   $t_words1_4,$most+1,$most+3,$m_first    # 107o
        xor     $t_y_12,$order_z_4,$sign_2              # 108e
        shufb   $lanes2_2,$t_words2_2,$t_words3_2,$m_first # 108o
        selb    $order_9,$order_9,$direction_x_5,$c_z_3 # 109e
        shufb   $t_words3_3,$far_2,$far_scale_2,$m_last # 109o
        selb    $order_y_7,$direction_z_3,$direction_x_3,$c_y_3 # 110e
        shufb   $lanes3_2,$t_words2_2,$t_words3_2,$m_last # 110o
        fm      $near_scale,$order_9,$everywhere_3      # 111e
        shufb   $lanes_2,$t_words_3,$t_words1_4,$m_first # 111o
        selb    $order_y_7,$order_y_7,$direction_y_5,$c_z_3 # 112e
        shufb   $lanes1_2,$t_words_2,$t_words1_3,$m_last # 112o
        selb    $order_y,$order_y,$direction_y_3,$c_z_3 # 113e
        shufb   $lanes1_3,$t_words_3,$t_words1_4,$m_last # 113o
        fm      $m_word1_2,$order_y_7,$everywhere_2     # 114e
        shufb   $t_words3_4,$most+1,$most+3,$m_last     # 114o
        fm      $m_word_4,$order_y,$everywhere_3        # 115e
        shufb   $lanes_3,$t_words_2,$t_words1_3,$m_first # 115o
        fcgt    $c_greater_3,$lanes2_2,$lanes3_2        # 116e
        shufb   $t_words+2,$most_4,$most+2,$m_last      # 116o
        fcgt    $c_greater_8,$lanes1_3,$lanes_2         # 117e
        shufb   $t_words2_3,$near_2,$near_scale,$m_last # 117o
        selb    $lanes2_3,$lanes2_2,$lanes3_2,$c_greater_3 # 118e
        shufb   $t_words,$near_2,$near_scale,$m_first   # 118o
        selb    $lanes_4,$lanes_2,$lanes1_3,$c_greater_8 # 119e
        lnop                                            # 119o pairing
        fcgt    $c_greater_14,$lanes_3,$lanes1_2        # 120e
        shufb   $lanes+3,$t_words+2,$t_words3_4,$m_last # 120o
        xor     $t_y,$order_z_3,$sign_2                 # 121e
        shufb   $lanes2_4,$t_words2_3,$t_words3_3,$m_first # 121o
        selb    $lanes,$lanes_3,$lanes1_2,$c_greater_14 # 122e
        shufb   $t_words_4,$planes_3,$m_word_4,$m_first # 122o
        xor     $t_y_13,$order_z_10,$sign_2             # 123e
        shufb   $lanes3_3,$t_words2_3,$t_words3_3,$m_last # 123o
        fcgt    $c_greater_15,$lanes,$lanes2_3          # 124e
        shufb   $t_words3_5,$last_2,$m_word1_2,$m_last  # 124o
        fcgt    $t_y_13,$t_y_13,$k_half                 # 125e
        shufb   $t_words1_5,$last_2,$m_word1_2,$m_first # 125o
        selb    $lanes,$lanes,$lanes2_3,$c_greater_15   # 126e
        shufb   $lanes_5,$t_words,$t_words1_2,$m_first  # 126o
        fcgt    $c_greater_16,$lanes2_4,$lanes3_3       # 127e
        shufb   $t_words2_4,$planes_3,$m_word_4,$m_last # 127o
        ori     $d_min,$lanes,0                         # 128e
        shufb   $lanes1_4,$t_words,$t_words1_2,$m_last  # 128o
        fcgt    $t_y_3,$t_y_12,$k_half                  # 129e
        shufb   $lanes+1,$t_words_4,$t_words1_5,$m_last # 129o
        fcgt    $up,$d_min,$k_tiny                      # 130e
        shufb   $lanes,$t_words_4,$t_words1_5,$m_first  # 130o
        selb    $t_words2_5,$lanes2_4,$lanes3_3,$c_greater_16 # 131e
        shufb   $lanes2_5,$t_words2_4,$t_words3_5,$m_first # 131o
        fcgt    $c_greater_17,$lanes_5,$lanes1_4        # 132e
        shufb   $lanes2_6,$t_words+2,$t_words3_4,$m_first # 132o
        selb    $order_10,$order_4,$order_y_2,$c_y_3    # 133e
        shufb   $lanes3_4,$t_words2_4,$t_words3_5,$m_last # 133o
        fcgt    $c_greater_18,$lanes,$lanes+1           # 134e
        orc     $wide,$wide,$t_y_13                     # 135e
        selb    $t_words+1,$lanes+1,$lanes,$c_greater_18 # 136e
        fcgt    $c_greater_19,$lanes2_5,$lanes3_4       # 137e
        orc     $wide,$wide,$t_y_3                      # 138e
        selb    $t_words3_6,$lanes3_4,$lanes2_5,$c_greater_19 # 139e
        fcgt    $c_greater_20,$lanes+3,$lanes2_6        # 140e
        fcgt    $c_greater_3,$t_words3_6,$t_words+1     # 141e
        fcgt    $t_y,$t_y,$k_half                       # 142e
        selb    $t_words+1,$t_words+1,$t_words3_6,$c_greater_3 # 143e
        selb    $t_words+2,$lanes2_5,$lanes3_4,$c_greater_19 # 144e
        fa      $t_words+1,$t_words+1,$k_slack          # 145e
        selb    $lanes2_7,$lanes2_6,$lanes+3,$c_greater_20 # 146e
        orc     $wide,$wide,$t_y                        # 147e
        fcgt    $c_greater_19,$lanes2_7,$lanes_4        # 148e
        lnop                                            # 148o pairing
        selb    $t_words1_5,$lanes1_4,$lanes_5,$c_greater_17 # 149e
        orx     $wide,$wide                             # 149o
        selb    $lanes_6,$lanes_4,$lanes2_7,$c_greater_19 # 150e
        selb    $t_words,$lanes,$lanes+1,$c_greater_18  # 151e
        ori     $d_max,$lanes_6,0                       # 152e
        lnop                                            # 152o pairing
        fcgt    $c_greater_21,$t_words,$t_words+2       # 153e
        shufb   $wide,$wide,$wide,$m_lane               # 153o
        fcgt    $down,$k_minus_tiny,$d_max              # 154e
        shufb   $last_3,$a_shear,$d_max,$m_word_2       # 154o
        selb    $t_words,$t_words,$t_words+2,$c_greater_21 # 155e
        fcgt    $c_greater_21,$d_max,$k_tiny            # 156e
        selb    $t_words+1,$t_words+1,$k_most,$wide     # 157e
        selb    $near_3,$k_tiny,$d_max,$c_greater_21    # 158e
        selb    $t_words3_3,$lanes3_3,$lanes2_4,$c_greater_16 # 159e
        shufb   $everywhere,$t_words+1,$t_words+1,$m_lane+1 # 159o
        selb    $near_4,$near_3,$d_min,$down            # 160e
        shufb   $everywhere_6,$t_words+1,$t_words+1,$m_lane+2 # 160o
        fcgt    $c_greater_8,$t_words3_3,$t_words1_5    # 161e
        shufb   $everywhere_7,$t_words+1,$t_words+1,$m_lane+3 # 161o
        selb    $t_words_5,$lanes_5,$lanes1_4,$c_greater_17 # 162e
        frest   $t_y,$near_4                            # 162o
        selb    $t_words1_6,$t_words1_5,$t_words3_3,$c_greater_8 # 163e
        stqd    $everywhere,208($a_window)              # 163o
        fcgt    $c_greater_8,$t_words_5,$t_words2_5     # 164e
        shufb   $everywhere,$t_words+1,$t_words+1,$m_lane # 164o
        fa      $t_words+1,$t_words1_6,$k_slack         # 165e
        stqd    $everywhere_7,240($a_window)            # 165o
        fcgt    $c_greater_22,$k_minus_tiny,$d_min      # 166e
        stqd    $everywhere_6,224($a_window)            # 166o
        and     $last,$last,$down                       # 167e
        lnop                                            # 167o pairing
        selb    $far_2,$k_minus_tiny,$d_min,$c_greater_22 # 168e
        stqd    $everywhere,192($a_window)              # 168o
        a       $planes_3,$planes_2,$last               # 169e
        selb    $far_2,$far_2,$d_min,$up                # 170e
        selb    $t_words+1,$t_words+1,$k_most,$wide     # 171e
        shufb   $last,$planes_3,$last_3,$m_word_3       # 171o
        selb    $far_2,$far_2,$d_max,$down              # 172e
        lnop                                            # 172o pairing
        fs      $t_words,$t_words,$k_slack              # 173e
        shufb   $everywhere,$t_words+1,$t_words+1,$m_lane # 173o
        selb    $t_words_6,$t_words_5,$t_words2_5,$c_greater_8 # 174e
        shufb   $everywhere_8,$t_words+1,$t_words+1,$m_lane+2 # 174o
        selb    $order,$order_10,$order_z_7,$c_z_3      # 175e
        shufb   $everywhere_9,$t_words+1,$t_words+1,$m_lane+1 # 175o
        fs      $t_words_6,$t_words_6,$k_slack          # 176e
        stqd    $last,192($a_bound)                     # 176o
        selb    $order_9,$order_2,$order_y_3,$c_y_3     # 177e
        frest   $t_y_14,$far_2                          # 177o
        fi      $t_y,$near_4,$t_y                       # 178e
        stqd    $everywhere_8,96($a_window)             # 178o
        selb    $t_words,$t_words,$k_least,$wide        # 179e
        stqd    $everywhere_9,80($a_window)             # 179o
        selb    $order_11,$order_9,$order_z_6,$c_z_3    # 180e
        stqd    $order,256($a_window)                   # 180o
        fi      $t_y_15,$far_2,$t_y_14                  # 181e
        shufb   $everywhere_10,$t_words,$t_words,$m_lane+1 # 181o
        selb    $t_words_7,$t_words_6,$k_least,$wide    # 182e
        stqd    $order_11,272($a_window)                # 182o
        ai      $a_shear,$a_shear_2,288                 # 183e
        shufb   $everywhere_11,$t_words,$t_words,$m_lane+3 # 183o
        ai      $3,$r3_2,320                            # 184e
        shufb   $everywhere_12,$t_words_7,$t_words_7,$m_lane+1 # 184o
        fnms    $t_e,$near_4,$t_y,$k_below_one          # 185e
        stqd    $everywhere_10,144($a_window)           # 185o
        shufb   $everywhere_13,$t_words,$t_words,$m_lane # 186o
        stqd    $everywhere_11,176($a_window)           # 187o
        fnms    $t_e_6,$far_2,$t_y_15,$k_above_one      # 188e
        shufb   $everywhere_11,$t_words_7,$t_words_7,$m_lane+3 # 188o
        shufb   $everywhere_10,$t_words_7,$t_words_7,$m_lane # 189o
        stqd    $everywhere_13,128($a_window)           # 190o
        fma     $near_scale,$t_e,$t_y,$t_y              # 191e
        shufb   $everywhere_13,$t_words_7,$t_words_7,$m_lane+2 # 191o
        stqd    $everywhere_11,48($a_window)            # 192o
        stqd    $everywhere_10,0($a_window)             # 193o
        fma     $far_scale,$t_e_6,$t_y_15,$t_y_15       # 194e
        shufb   $everywhere_14,$t_words,$t_words,$m_lane+2 # 194o
        stqd    $everywhere_13,32($a_window)            # 195o
        shufb   $everywhere_13,$t_words+1,$t_words+1,$m_lane+3 # 196o
        shufb   $everywhere_9,$near_scale,$near_scale,$m_lane # 197o
        shufb   $everywhere_11,$near_scale,$near_scale,$m_lane+1 # 198o
        stqd    $everywhere,64($a_window)               # 199o
        stqd    $everywhere_13,112($a_window)           # 200o
        shufb   $everywhere,$far_scale,$far_scale,$m_lane+1 # 201o
        stqd    $everywhere_12,16($a_window)            # 202o
        nop     $127                                    # 203e pairing
        stqd    $everywhere_14,160($a_window)           # 203o
        ai      $a_window,$a_window_2,144               # 204e
        hbrr    next_bound_back,next_bound              # 204o hint
        stqd    $everywhere,112($a_bound)               # 205o
        shufb   $everywhere,$far_scale,$far_scale,$m_lane+2 # 206o
        shufb   $everywhere_14,$near_scale,$near_scale,$m_lane+2 # 207o
        shufb   $everywhere_15,$far_scale,$far_scale,$m_lane # 208o
        stqd    $everywhere_9,0($a_bound)               # 209o
        stqd    $everywhere,128($a_bound)               # 210o
        stqd    $everywhere_14,32($a_bound)             # 211o
        stqd    $everywhere_15,96($a_bound)             # 212o
        stqd    $everywhere_11,16($a_bound)             # 213o
        ai      $a_bound,$a_bound,208                   # 214e
        nop     $127                                    # 215e pairing
next_bound_back:
        brnz    $count,next_bound                       # 220o
        nop     $127                                    # 216e pairing
        bi      $lr                                     # 216o
endfunction mesh_eye_bounds_r16
