# mesh_bounds_r16   what the rays of packets have in common, for cull_boxes
#   C       void mesh_bounds_r16(const struct rays16 *, int count, struct mesh_bound *,
#                                const struct shear *);
#   In      $3 RAYS16, one behind the other, $4 count (0 is none), $5 MESH_BOUNDs likewise, $6 the
#           packets' SHEARS likewise, whose addresses go to the bounds; pointers 16-aligned
#   Out     the bounds
#   Uses    $2-$72   Saves  -   Stack  0   Calls  -
#   Domain  origins below 2^60; components of directions up to 1; t has a sign where no ray is, and
#           anything else there
#   Error   0: no ray meets a plane earlier or later than the bound says
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
# Scheduled by spu schedule from mesh_bounds_r16.s

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
        .set turned_2,2; .set turned_3,7; .set turned_4,8; .set turned_5,9; .set turned_6,24
        .set turned_7,29; .set turned_8,33; .set c_greater_2,35; .set turned_9,36
        .set c_greater_3,37; .set turned_10,38; .set slack_2,39; .set turned_11,40
        .set direction_min2_2,41; .set turned_12,42; .set turned_13,43; .set c_greater_4,44
        .set turned_14,45; .set turned_15,46; .set turned_16,47; .set turned_17,37
        .set turned_18,44; .set c_greater_5,48; .set turned_19,49; .set c_greater_6,50
        .set turned_20,51; .set c_greater_7,52; .set turned_21,53; .set c_greater_8,55
        .set turned_22,56; .set turned_23,57; .set turned_24,58; .set slack_3,59; .set turned_25,60
        .set turned_26,55; .set c_greater_9,61; .set turned_27,62; .set m_splat_2,54
        .set slack_4,63; .set planes_2,64; .set c_greater_10,65; .set m_splat_3,66
        .set c_greater_11,8; .set direction_min1_2,48; .set direction_max1_2,52
        .set direction_max2_2,67; .set direction_max3_2,68; .set c_greater_12,2
        .set direction_max_2,8; .set c_greater_13,24; .set c_greater_14,69; .set c_greater_15,70
        .set c_greater_16,71; .set c_greater_17,72; .set c_greater_18,40; .set c_greater_19,29
        .set direction_min2_3,35; .set c_greater_20,41; .set direction_max2_3,33
        .set c_greater_21,67; .set slack_5,69; .set direction_max1_3,2; .set direction_max3_3,9
        .set c_greater_22,39; .set direction_min1_3,29; .set c_greater_23,43; .set c_greater_24,36
        .set c_greater_25,42; .set last3_2,41; .set planes_3,36; .set t_words_2,50
        .set t_words2_2,26; .set direction_max3_4,7; .set c_greater_26,9; .set c_greater_27,28
        .set direction_min2_4,9; .set c_greater_28,38; .set t_words3_2,38; .set direction_min1_4,28
        .set t_words3_3,27; .set c_greater_29,30; .set t_words1_2,31; .set t_rows2_2,30
        .set t_rows1_2,29; .set t_rows_2,7; .set t_rows3_2,24; .set c_greater_30,26
        .set c_greater_31,27; .set c_greater_32,31; .set c_greater_33,32; .set c_greater_34,33
        .set c_greater_35,25; .set t_rows_3,2; .set t_rows1_3,7; .set t_rows_4,8; .set t_rows2_3,2
        .set last_2,2; .set t_y_2,7; .set m_splat_4,8; .set m_splat_5,9; .set m_splat_6,25
        .set t_e_2,26; .set m_splat_7,27; .set m_splat_8,7; .set m_splat_9,26; .set everywhere_2,7
        .set everywhere_3,9; .set m_splat_10,2; .set everywhere_4,2; .set everywhere_5,8
        nop     $127                                    # 0e pairing
        biz     $count,$lr                              # 0o
        ilhu    $k_most,0x7fff                          # 1e
        lqa     $m_first,transpose_first                # 1o
        ilhu    $k_below_one,0x3f7f                     # 2e 1 - 2^-21
        lqa     $m_last,transpose_last                  # 2o
        ilhu    $k_above_one,0x3f80                     # 3e 1 + 2^-21
        ilhu    $k_up,3                                 # 4e
        iohl    $k_most,0xffff                          # 5e
        il      $k_least,-1                             # 6e
        iohl    $k_below_one,0xfff8                     # 7e 1 - 2^-21
        iohl    $k_above_one,4                          # 8e 1 + 2^-21
        ilhu    $k_slack,0x3600                         # 9e 2^-19
        iohl    $k_up,0xffff                            # 10e
        ilhu    $m_slack,0xfffc                         # 11e
        ilhu    $k_tiny,0x2180                          # 12e 2^-60
        ilhu    $k_minus_tiny,0xa180                    # 13e
        ilhu    $k_none,0xbf80                          # 14e -1
        il      $k_zero,0                               # 15e
        ilhu    $m_sign,0x8000                          # 16e
next_bound:
        ori     $near,$k_most,0                         # 0e
        lqd     $turned,64($a_packet)                   # 0o
        ori     $last,$k_least,0                        # 1e
        lqd     $turned_2,128($a_packet)                # 1o
        ori     $up,$k_most,0                           # 2e
        lqd     $turned_3,400($a_packet)                # 2o
        ori     $far,$k_most,0                          # 3e
        lqd     $turned_4,0($a_packet)                  # 3o
        ori     $last+2,$k_least,0                      # 4e
        lqd     $turned_5,384($a_packet)                # 4o
        ori     $direction_min,$k_most,0                # 5e
        lqd     $turned_6,16($a_packet)                 # 5o
        ori     $last+1,$k_least,0                      # 6e
        lqd     $turned_7,144($a_packet)                # 6o
        fcgt    $c_greater,$turned_2,$last+2            # 7e
        lqd     $turned_8,320($a_packet)                # 7o
        fcgt    $c_greater_2,$far,$turned_2             # 8e
        lqd     $turned_9,32($a_packet)                 # 8o
        fcgt    $c_greater_3,$up,$turned_4              # 9e
        lqd     $turned_10,336($a_packet)               # 9o
        cgti    $slack_2,$turned_5,-1                   # 10e
        lqd     $turned_11,80($a_packet)                # 10o
        ori     $direction_min2_2,$k_most,0             # 11e
        lqd     $turned_12,160($a_packet)               # 11o
        and     $c_greater_2,$c_greater_2,$slack_2      # 12e
        lqd     $turned_13,256($a_packet)               # 12o
        fcgt    $c_greater_4,$turned,$last+1            # 13e
        lqd     $turned_14,432($a_packet)               # 13o
        and     $c_greater_3,$c_greater_3,$slack_2      # 14e
        lqd     $turned_15,208($a_packet)               # 14o
        and     $c_greater_4,$c_greater_4,$slack_2      # 15e
        lqd     $turned_16,48($a_packet)                # 15o
        selb    $up,$up,$turned_4,$c_greater_3          # 16e
        lqd     $turned_17,192($a_packet)               # 16o
        selb    $last+1,$last+1,$turned,$c_greater_4    # 17e
        lqd     $turned_18,176($a_packet)               # 17o
        fcgt    $c_greater_5,$up,$turned_6              # 18e
        lqd     $turned_19,416($a_packet)               # 18o
        fcgt    $c_greater_6,$turned_11,$last+1         # 19e
        lqd     $turned_20,352($a_packet)               # 19o
        fcgt    $c_greater_7,$turned_4,$last            # 20e
        lqd     $turned_21,272($a_packet)               # 20o
        fcgt    $c_greater_8,$near,$turned              # 21e
        lqd     $turned_22,96($a_packet)                # 21o
        and     $c_greater_7,$c_greater_7,$slack_2      # 22e
        lqd     $turned_23,112($a_packet)               # 22o
        and     $c_greater_8,$c_greater_8,$slack_2      # 23e
        lqd     $turned_24,288($a_packet)               # 23o
        cgti    $slack_3,$turned_19,-1                  # 24e
        lqd     $turned_25,224($a_packet)               # 24o
        selb    $near,$near,$turned,$c_greater_8        # 25e
        lqd     $turned,368($a_packet)                  # 25o
        and     $c_greater,$c_greater,$slack_2          # 26e
        lqd     $turned_26,240($a_packet)               # 26o
        fcgt    $c_greater_9,$near,$turned_11           # 27e
        lqd     $turned_27,304($a_packet)               # 27o
        selb    $last+2,$last+2,$turned_2,$c_greater    # 28e
        lqa     $m_splat_2,shears_and_farthest          # 28o
        cgti    $slack_4,$turned_3,-1                   # 29e
        lqa     $planes_2,near_planes                   # 29o
        fcgt    $c_greater_10,$turned_7,$last+2         # 30e
        lqa     $m_splat_3,planes_and_others            # 30o
        and     $c_greater_9,$c_greater_9,$slack_4      # 31e
        selb    $last,$last,$turned_4,$c_greater_7      # 32e
        and     $c_greater_11,$c_greater_5,$slack_4     # 33e
        fcgt    $c_greater_5,$turned_6,$last            # 34e
        selb    $up,$up,$turned_6,$c_greater_11         # 35e
        and     $c_greater_11,$c_greater_5,$slack_4     # 36e
        ori     $direction_min1_2,$k_most,0             # 37e
        ori     $direction_max1_2,$k_least,0            # 38e
        ori     $direction_max2_2,$k_least,0            # 39e
        ori     $direction_max3_2,$k_none,0             # 40e
        selb    $far,$far,$turned_2,$c_greater_2        # 41e
        fcgt    $c_greater_12,$up,$turned_9             # 42e
        fcgt    $c_greater_2,$far,$turned_7             # 43e
        selb    $last,$last,$turned_6,$c_greater_11     # 44e
        and     $c_greater_11,$c_greater_6,$slack_4     # 45e
        and     $c_greater_12,$c_greater_12,$slack_3    # 46e
        selb    $last+1,$last+1,$turned_11,$c_greater_11 # 47e
        ori     $direction_max_2,$k_least,0             # 48e
        fcgt    $c_greater_13,$turned_22,$last+1        # 49e
        fcgt    $c_greater_6,$turned_17,$direction_max_2 # 50e
        fcgt    $c_greater_14,$direction_min,$turned_17 # 51e
        fcgt    $c_greater_15,$direction_min2_2,$turned_8 # 52e
        and     $c_greater_14,$c_greater_14,$slack_2    # 53e
        fcgt    $c_greater_16,$turned_8,$direction_max2_2 # 54e
        and     $c_greater_10,$c_greater_10,$slack_4    # 55e
        fcgt    $c_greater_17,$direction_min1_2,$turned_13 # 56e
        selb    $last+2,$last+2,$turned_7,$c_greater_10 # 57e
        and     $c_greater_10,$c_greater_15,$slack_2    # 58e
        and     $c_greater_15,$c_greater_16,$slack_2    # 59e
        selb    $direction_min2_2,$direction_min2_2,$turned_8,$c_greater_10 # 60e
        selb    $near,$near,$turned_11,$c_greater_9     # 61e
        and     $c_greater_2,$c_greater_2,$slack_4      # 62e
        fcgt    $c_greater_18,$turned_12,$last+2        # 63e
        selb    $far,$far,$turned_7,$c_greater_2        # 64e
        and     $c_greater_19,$c_greater_18,$slack_3    # 65e
        selb    $direction_min,$direction_min,$turned_17,$c_greater_14 # 66e
        fcgt    $c_greater_2,$direction_min2_2,$turned_10 # 67e
        fcgt    $c_greater_18,$direction_min,$turned_15 # 68e
        and     $c_greater_2,$c_greater_2,$slack_4      # 69e
        and     $c_greater_9,$c_greater_17,$slack_2     # 70e
        selb    $direction_min2_3,$direction_min2_2,$turned_10,$c_greater_2 # 71e
        cgt     $c_greater_20,$turned_5,$direction_max3_2 # 72e
        fcgt    $c_greater_10,$turned_13,$direction_max1_2 # 73e
        selb    $direction_max2_3,$direction_max2_2,$turned_8,$c_greater_15 # 74e
        fcgt    $c_greater_21,$far,$turned_12           # 75e
        cgti    $slack_5,$turned_14,-1                  # 76e
        and     $c_greater_21,$c_greater_21,$slack_3    # 77e
        selb    $up,$up,$turned_9,$c_greater_12         # 78e
        fcgt    $c_greater_12,$near,$turned_22          # 79e
        fcgt    $c_greater_15,$up,$turned_16            # 80e
        and     $c_greater_12,$c_greater_12,$slack_3    # 81e
        and     $c_greater_13,$c_greater_13,$slack_3    # 82e
        selb    $near,$near,$turned_22,$c_greater_12    # 83e
        and     $c_greater_12,$c_greater_10,$slack_2    # 84e
        fcgt    $c_greater_10,$turned_9,$last           # 85e
        selb    $direction_max1_3,$direction_max1_2,$turned_13,$c_greater_12 # 86e
        selb    $last+2,$last+2,$turned_12,$c_greater_19 # 87e
        and     $c_greater_19,$c_greater_20,$slack_2    # 88e
        fcgt    $c_greater_20,$turned_18,$last+2        # 89e
        selb    $direction_max3_3,$direction_max3_2,$turned_5,$c_greater_19 # 90e
        and     $c_greater_19,$c_greater_6,$slack_2     # 91e
        cgt     $c_greater_22,$turned_3,$direction_max3_3 # 92e
        selb    $direction_max_2,$direction_max_2,$turned_17,$c_greater_19 # 93e
        selb    $direction_min1_3,$direction_min1_2,$turned_13,$c_greater_9 # 94e
        fcgt    $c_greater_3,$turned_15,$direction_max_2 # 95e
        and     $c_greater_18,$c_greater_18,$slack_4    # 96e
        fcgt    $c_greater_23,$direction_min1_3,$turned_21 # 97e
        fcgt    $c_greater_5,$turned_21,$direction_max1_3 # 98e
        and     $c_greater_6,$c_greater_10,$slack_3     # 99e
        and     $c_greater_5,$c_greater_5,$slack_4      # 100e
        selb    $last,$last,$turned_9,$c_greater_6      # 101e
        selb    $direction_max1_3,$direction_max1_3,$turned_21,$c_greater_5 # 102e
        and     $c_greater_24,$c_greater_15,$slack_5    # 103e
        and     $c_greater_3,$c_greater_3,$slack_4      # 104e
        selb    $last+1,$last+1,$turned_22,$c_greater_13 # 105e
        selb    $direction_max_2,$direction_max_2,$turned_15,$c_greater_3 # 106e
        selb    $far,$far,$turned_12,$c_greater_21      # 107e
        fcgt    $c_greater_13,$turned_25,$direction_max_2 # 108e
        fcgt    $c_greater_3,$far,$turned_18            # 109e
        fcgt    $c_greater_25,$turned_16,$last          # 110e
        and     $c_greater_3,$c_greater_3,$slack_5      # 111e
        and     $c_greater_25,$c_greater_25,$slack_5    # 112e
        selb    $far,$far,$turned_18,$c_greater_3       # 113e
        and     $c_greater_3,$c_greater_20,$slack_5     # 114e
        and     $c_greater_13,$c_greater_13,$slack_3    # 115e
        selb    $last+2,$last+2,$turned_18,$c_greater_3 # 116e
        fcgt    $c_greater_3,$direction_min2_3,$turned_20 # 117e
        ori     $last3_2,$last+2,0                      # 118e
        fcgt    $c_greater_4,$near,$turned_23           # 119e
        and     $c_greater_23,$c_greater_23,$slack_4    # 120e
        and     $c_greater_4,$c_greater_4,$slack_5      # 121e
        selb    $direction_min1_3,$direction_min1_3,$turned_21,$c_greater_23 # 122e
        fcgt    $c_greater_23,$turned_10,$direction_max2_3 # 123e
        fcgt    $c_greater_5,$direction_min1_3,$turned_24 # 124e
        selb    $up,$up,$turned_16,$c_greater_24        # 125e
        ori     $planes_3,$far,0                        # 126e
        and     $c_greater_22,$c_greater_22,$slack_4    # 127e
        shufb   $t_words_2,$up,$far,$m_first            # 127o
        fcgt    $c_greater_7,$turned_24,$direction_max1_3 # 128e
        shufb   $t_words2_2,$up,$far,$m_last            # 128o
        selb    $direction_max3_4,$direction_max3_3,$turned_3,$c_greater_22 # 129e
        and     $c_greater_26,$c_greater_3,$slack_3     # 130e
        fcgt    $c_greater_27,$turned_23,$last+1        # 131e
        selb    $direction_min2_4,$direction_min2_3,$turned_20,$c_greater_26 # 132e
        and     $c_greater_27,$c_greater_27,$slack_5    # 133e
        and     $c_greater_2,$c_greater_7,$slack_3      # 134e
        fcgt    $c_greater_3,$direction_min2_4,$turned  # 135e
        selb    $direction_min,$direction_min,$turned_15,$c_greater_18 # 136e
        and     $c_greater_22,$c_greater_23,$slack_4    # 137e
        fcgt    $c_greater_18,$direction_min,$turned_25 # 138e
        selb    $direction_max2_3,$direction_max2_3,$turned_10,$c_greater_22 # 139e
        and     $c_greater_28,$c_greater_18,$slack_3    # 140e
        fcgt    $c_greater_22,$turned_20,$direction_max2_3 # 141e
        selb    $direction_max_2,$direction_max_2,$turned_25,$c_greater_13 # 142e
        cgt     $c_greater_13,$turned_19,$direction_max3_4 # 143e
        and     $c_greater_22,$c_greater_22,$slack_3    # 144e
        selb    $near,$near,$turned_23,$c_greater_4     # 145e
        selb    $last,$last,$turned_16,$c_greater_25    # 146e
        selb    $last+1,$last+1,$turned_23,$c_greater_27 # 147e
        shufb   $t_words+1,$near,$planes_3,$m_first     # 147o
        selb    $direction_min,$direction_min,$turned_25,$c_greater_28 # 148e
        shufb   $t_words,$last,$last+2,$m_first         # 148o
        and     $c_greater_27,$c_greater_5,$slack_3     # 149e
        shufb   $t_words3_2,$last+1,$last3_2,$m_last    # 149o
        fcgt    $c_greater_18,$direction_min,$turned_26 # 150e
        shufb   $t_words+2,$last,$last+2,$m_last        # 150o
        selb    $direction_min1_4,$direction_min1_3,$turned_24,$c_greater_27 # 151e
        shufb   $t_rows+1,$t_words_2,$t_words+1,$m_last # 151o
        and     $c_greater_19,$c_greater_18,$slack_5    # 152e
        shufb   $t_words3_3,$near,$planes_3,$m_last     # 152o
        fcgt    $c_greater_29,$direction_min1_4,$turned_27 # 153e
        shufb   $t_words1_2,$last+1,$last3_2,$m_first   # 153o
        selb    $direction_min,$direction_min,$turned_26,$c_greater_19 # 154e
        shufb   $t_rows+2,$t_words+2,$t_words3_2,$m_first # 154o
        and     $c_greater_19,$c_greater_29,$slack_5    # 155e
        shufb   $t_rows,$t_words_2,$t_words+1,$m_first  # 155o
        and     $c_greater_13,$c_greater_13,$slack_3    # 156e
        shufb   $t_rows2_2,$t_words2_2,$t_words3_3,$m_first # 156o
        selb    $direction_min1_4,$direction_min1_4,$turned_27,$c_greater_19 # 157e
        shufb   $t_rows1_2,$t_words,$t_words1_2,$m_last # 157o
        selb    $direction_max+3,$direction_max3_4,$turned_19,$c_greater_13 # 158e
        shufb   $t_rows_2,$t_words,$t_words1_2,$m_first # 158o
        selb    $direction_max1_3,$direction_max1_3,$turned_24,$c_greater_2 # 159e
        shufb   $t_rows+3,$t_words2_2,$t_words3_3,$m_last # 159o
        selb    $direction_max+2,$direction_max2_3,$turned_20,$c_greater_22 # 160e
        shufb   $t_rows3_2,$t_words+2,$t_words3_2,$m_last # 160o
        fcgt    $c_greater_30,$turned_27,$direction_max1_3 # 161e
        fcgt    $c_greater_31,$t_rows1_2,$t_rows_2      # 162e
        fcgt    $c_greater_32,$t_rows2_2,$t_rows+3      # 163e
        fcgt    $c_greater_33,$t_rows3_2,$t_rows+2      # 164e
        selb    $t_rows_2,$t_rows_2,$t_rows1_2,$c_greater_31 # 165e
        fcgt    $c_greater_31,$turned,$direction_max+2  # 166e
        fcgt    $c_greater_19,$turned_26,$direction_max_2 # 167e
        and     $c_greater_30,$c_greater_30,$slack_5    # 168e
        selb    $t_rows2_2,$t_rows2_2,$t_rows+3,$c_greater_32 # 169e
        cgt     $c_greater_32,$turned_14,$direction_max+3 # 170e
        and     $c_greater_34,$c_greater_3,$slack_5     # 171e
        and     $c_greater_31,$c_greater_31,$slack_5    # 172e
        selb    $direction_min+2,$direction_min2_4,$turned,$c_greater_34 # 173e
        selb    $direction_max+2,$direction_max+2,$turned,$c_greater_31 # 174e
        ori     $direction_min+3,$direction_min+2,0     # 175e
        shufb   $t_words+2,$direction_min,$direction_min+2,$m_last # 175o
        and     $c_greater_26,$c_greater_32,$slack_5    # 176e
        shufb   $t_words,$direction_min,$direction_min+2,$m_first # 176o
        fcgt    $c_greater_35,$t_rows,$t_rows+1         # 177e
        shufb   $t_words3_3,$direction_min1_4,$direction_min+3,$m_last # 177o
        selb    $t_rows+2,$t_rows+2,$t_rows3_2,$c_greater_33 # 178e
        shufb   $t_words+1,$direction_min1_4,$direction_min+3,$m_first # 178o
        selb    $direction_max+1,$direction_max1_3,$turned_27,$c_greater_30 # 179e
        fcgt    $c_greater_12,$t_rows+2,$t_rows_2       # 180e
        and     $c_greater_13,$c_greater_19,$slack_5    # 181e
        shufb   $t_rows+3,$t_words+2,$t_words3_3,$m_last # 181o
        selb    $t_rows_3,$t_rows_2,$t_rows+2,$c_greater_12 # 182e
        shufb   $t_rows1_3,$t_words,$t_words+1,$m_last  # 182o
        selb    $direction_max,$direction_max_2,$turned_26,$c_greater_13 # 183e
        shufb   $t_rows+2,$t_words+2,$t_words3_3,$m_first # 183o
        selb    $t_rows,$t_rows,$t_rows+1,$c_greater_35 # 184e
        shufb   $t_rows_4,$t_words,$t_words+1,$m_first  # 184o
        selb    $direction_max+3,$direction_max+3,$turned_14,$c_greater_26 # 185e
        shufb   $t_words,$direction_max,$direction_max+2,$m_first # 185o
        fcgt    $c_greater_26,$t_rows,$t_rows2_2        # 186e
        shufb   $t_words+2,$direction_max,$direction_max+2,$m_last # 186o
        ori     $o_max,$t_rows_3,0                      # 187e
        shufb   $t_words+3,$direction_max+1,$direction_max+3,$m_last # 187o
        fcgt    $c_greater_12,$t_rows+2,$t_rows+3       # 188e
        shufb   $t_words+1,$direction_max+1,$direction_max+3,$m_first # 188o
        selb    $t_rows,$t_rows,$t_rows2_2,$c_greater_26 # 189e
        selb    $t_rows+2,$t_rows+2,$t_rows+3,$c_greater_12 # 190e
        ori     $o_min,$t_rows,0                        # 191e
        shufb   $t_rows2_3,$t_words+2,$t_words+3,$m_first # 191o
        fcgt    $c_greater_26,$t_rows_4,$t_rows1_3      # 192e
        shufb   $t_rows,$t_words,$t_words+1,$m_first    # 192o
        andc    $slack,$o_min,$m_sign                   # 193e
        shufb   $t_rows+1,$t_words,$t_words+1,$m_last   # 193o
        selb    $t_rows_2,$t_rows_4,$t_rows1_3,$c_greater_26 # 194e
        shufb   $t_rows+3,$t_words+2,$t_words+3,$m_last # 194o
        andc    $turned,$o_max,$m_sign                  # 195e
        fcgt    $c_greater_11,$t_rows_2,$t_rows+2       # 196e
        fcgt    $c_greater_26,$t_rows+1,$t_rows         # 197e
        fcgt    $c_greater_30,$turned,$slack            # 198e
        selb    $t_rows,$t_rows,$t_rows+1,$c_greater_26 # 199e
        selb    $slack,$slack,$turned,$c_greater_30     # 200e
        fcgt    $c_greater_26,$t_rows+3,$t_rows2_3      # 201e
        lnop                                            # 201o pairing
        selb    $t_rows_2,$t_rows_2,$t_rows+2,$c_greater_11 # 202e
        rotqbyi $turned,$slack,8                        # 202o
        selb    $t_rows+2,$t_rows2_3,$t_rows+3,$c_greater_26 # 203e
        ori     $d_min,$t_rows_2,0                      # 204e
        fcgt    $c_greater_12,$t_rows+2,$t_rows         # 205e
        fcgt    $up,$d_min,$k_tiny                      # 206e
        selb    $t_rows,$t_rows,$t_rows+2,$c_greater_12 # 207e
        fcgt    $c_greater_12,$turned,$slack            # 208e
        ori     $d_max,$t_rows,0                        # 209e
        selb    $slack,$slack,$turned,$c_greater_12     # 210e
        fcgt    $down,$k_minus_tiny,$d_max              # 211e
        shufb   $last,$a_shear,$d_max,$m_splat_2        # 211o
        fcgt    $c_greater,$k_minus_tiny,$d_min         # 212e
        rotqbyi $turned,$slack,4                        # 212o
        fcgt    $c_greater_12,$d_max,$k_tiny            # 213e
        selb    $far,$k_minus_tiny,$d_min,$c_greater    # 214e
        selb    $near,$k_tiny,$d_max,$c_greater_12      # 215e
        selb    $far,$far,$d_min,$up                    # 216e
        selb    $near,$near,$d_min,$down                # 217e
        fcgt    $c_greater,$turned,$slack               # 218e
        selb    $far,$far,$d_max,$down                  # 219e
        frest   $t_y,$near                              # 219o
        selb    $slack,$slack,$turned,$c_greater        # 220e
        lnop                                            # 220o pairing
        il      $last_2,48                              # 221e
        frest   $t_y_2,$far                             # 221o
        fm      $slack,$slack,$k_slack                  # 222e
        fi      $t_y,$near,$t_y                         # 223e
        ilhu    $m_splat,0x405                          # 224e
        fi      $t_y_2,$far,$t_y_2                      # 225e
        ilhu    $m_splat_4,0x405                        # 226e
        ilhu    $m_splat_5,0x809                        # 227e
        a       $slack,$slack,$k_up                     # 228e rounded up
        ilhu    $m_splat_6,1                            # 229e
        fnms    $t_e,$near,$t_y,$k_below_one            # 230e
        and     $slack,$slack,$m_slack                  # 231e
        fnms    $t_e_2,$far,$t_y_2,$k_above_one         # 232e
        fs      $o_min,$o_min,$slack                    # 233e
        fa      $o_max,$o_max,$slack                    # 234e
        hbrr    next_bound_back,next_bound              # 234o hint
        ilhu    $m_splat_7,0x809                        # 235e
        fma     $near_scale,$t_e,$t_y,$t_y              # 236e
        iohl    $m_splat_7,0xa0b                        # 237e
        fma     $far_scale,$t_e_2,$t_y_2,$t_y_2         # 238e
        ilhu    $m_splat_8,0x405                        # 239e
        selb    $near_shift,$o_max,$o_min,$down         # 240e
        selb    $far_shift,$o_min,$o_max,$down          # 241e
        lnop                                            # 241o pairing
        fnms    $near_shift,$near_shift,$near_scale,$k_zero # 242e
        shufb   $everywhere,$near_scale,$near_scale,$m_splat_7 # 242o
        iohl    $m_splat_8,0x607                        # 243e
        fnms    $far_shift,$far_shift,$far_scale,$k_zero # 244e
        ilhu    $m_splat_9,1                            # 245e
        shufb   $everywhere_2,$far_scale,$far_scale,$m_splat_8 # 245o
        iohl    $m_splat_5,0xa0b                        # 246e
        stqd    $everywhere,32($a_bound)                # 246o
        ilhu    $m_splat_7,0x809                        # 247e
        lnop                                            # 247o pairing
        iohl    $m_splat,0x607                          # 248e
        shufb   $everywhere,$near_shift,$near_shift,$m_splat_5 # 248o
        iohl    $m_splat_7,0xa0b                        # 249e
        stqd    $everywhere_2,112($a_bound)             # 249o
        and     $last_2,$last_2,$down                   # 250e
        shufb   $everywhere_2,$far_shift,$far_shift,$m_splat # 250o
        ilhu    $m_splat,0x405                          # 251e
        shufb   $everywhere_3,$far_scale,$far_scale,$m_splat_7 # 251o
        a       $planes,$planes_2,$last_2               # 252e
        stqd    $everywhere,80($a_bound)                # 252o
        iohl    $m_splat,0x607                          # 253e
        lnop                                            # 253o pairing
        or      $planes,$planes,$slack                  # 254e
        stqd    $everywhere_2,160($a_bound)             # 254o
        ilhu    $m_splat_10,1                           # 255e
        shufb   $everywhere,$near_scale,$near_scale,$m_splat # 255o
        ilhu    $m_splat,0x809                          # 256e
        shufb   $last,$planes,$last,$m_splat_3          # 256o
        ai      $count,$count,-1                        # 257e
        stqd    $everywhere_3,128($a_bound)             # 257o
        iohl    $m_splat_6,515                          # 258e
        lnop                                            # 258o pairing
        ilhu    $m_splat_8,1                            # 259e
        stqd    $everywhere,16($a_bound)                # 259o
        iohl    $m_splat_10,515                         # 260e
        shufb   $everywhere,$far_shift,$far_shift,$m_splat_6 # 260o
        iohl    $m_splat_8,515                          # 261e
        stqd    $last,192($a_bound)                     # 261o
        iohl    $m_splat_9,515                          # 262e
        shufb   $everywhere_4,$far_scale,$far_scale,$m_splat_10 # 262o
        ai      $a_packet,$a_packet,320                 # 263e
        shufb   $everywhere_2,$near_shift,$near_shift,$m_splat_8 # 263o
        iohl    $m_splat_4,0x607                        # 264e
        shufb   $everywhere_3,$near_scale,$near_scale,$m_splat_9 # 264o
        iohl    $m_splat,0xa0b                          # 265e
        stqd    $everywhere,144($a_bound)               # 265o
        ai      $a_packet,$a_packet,320                 # 266e
        shufb   $everywhere,$near_shift,$near_shift,$m_splat_4 # 266o
        ai      $a_shear,$a_shear,288                   # 267e
        shufb   $everywhere_5,$far_shift,$far_shift,$m_splat # 267o
        nop     $127                                    # 268e pairing
        stqd    $everywhere_2,48($a_bound)              # 268o
        ai      $a_shear,$a_shear,288                   # 269e
        stqd    $everywhere_4,96($a_bound)              # 269o
        stqd    $everywhere,64($a_bound)                # 270o
        stqd    $everywhere_3,0($a_bound)               # 271o
        nop     $127                                    # 272e pairing
        stqd    $everywhere_5,176($a_bound)             # 272o
        ai      $a_bound,$a_bound,208                   # 273e
next_bound_back:
        brnz    $count,next_bound                       # 273o
        nop     $127                                    # 274e pairing
        bi      $lr                                     # 274o
endfunction mesh_bounds_r16
