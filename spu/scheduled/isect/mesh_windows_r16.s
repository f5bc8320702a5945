# mesh_windows_r16   where the rays of packets from the eye go, for filter_triangles_r16
#   C       void mesh_windows_r16(const struct rays16 *, int count, struct mesh_window *);
#   In      $3 RAYS16, one behind the other, $4 count (0 is none), $5 MESH_WINDOWs likewise;
#           pointers 16-aligned
#   Out     the windows
#   Uses    $2-$64   Saves  -   Stack  0   Calls  -
#   Domain  unit directions; t has a sign where no ray is, and anything else there
#   Error   0: each slope is 2^-18 within its row's window, which is more than all roundings of the
#           slope, of the ray's SHEARS, and of a vertex's slopes in filter_triangles_r16
#   Twin    lab/twins/src/mesh_rows.rs
#
# The slopes are those against the axis along which the first ray is longest. If a ray's component
# along it is less than 1/2, or has the other sign, the windows have everything: packets across so
# wide an angle are seldom.
# Scheduled by spu schedule from mesh_windows_r16.s

        .include "work_unit.inc"
        .include "macros.inc"
        .include "transpose.inc"
        .include "reciprocal.inc"
        .include "extremes.inc"
        .include "shear_tmpl.inc"

        .set    NEXT,3
        registers a_rays,count,a_window
        # constants
        .set    NEXT,10
        registers k_one,k_sign,k_half,k_slack
        registers k_most,k_least                        # the largest single, and minus that
        registers m_first,m_last                        # of transpose
        registers m_splat
        registers a_orders
        # the rays
        registers direction_x,direction_y,direction_z,there
        # the packet
        registers c_y,c_z                               # for by_longest
        registers sign,wide
        # a row
        registers x,y,z,inverse,t_y,t_e,c_greater
        # the rows' limits, then a limit's lanes
        registers low_x
        .set    NEXT,low_x+4
        registers high_x
        .set    NEXT,high_x+4
        registers low_y
        .set    NEXT,low_y+4
        registers high_y
        .set    NEXT,high_y+4
        registers lanes
        .set    NEXT,lanes+4
        registers t_words
        .set    NEXT,t_words+4
        .set    order,x
        .set    order_y,y
        .set    order_z,z
        .set    everywhere,inverse

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

# Puts the least or the greatest of each row's lanes everywhere in its place, and everything if the
# packet is wide.
.macro  put_limit of:req, extreme:req, all:req, field:req
        transpose lanes,\of,t_words,$m_first,$m_last
        \extreme $lanes,$lanes+1,$c_greater
        \extreme $lanes+2,$lanes+3,$c_greater
        \extreme $lanes,$lanes+2,$c_greater
        selb    $lanes,$lanes,\all,$wide
    .irp row, 0,1,2,3
        load_constant $m_splat,0x00010203+0x04040404*\row
        shufb   $everywhere,$lanes,$lanes,$m_splat
        stqd    $everywhere,MESH_WINDOW_\field+16*\row($a_window)
    .endr
.endm

.macro  put_order part:req, field:req
        lqd     $order,\part($a_orders)
        lqd     $order_y,\part+32($a_orders)
        lqd     $order_z,\part+64($a_orders)
        by_longest $order,$order,$order_y,$order_z
        stqd    $order,MESH_WINDOW_\field($a_window)
.endm

function mesh_windows_r16
        .set m_splat_2,2; .set m_splat_3,6; .set direction_x_2,7; .set m_splat_4,8
        .set direction_y_2,9; .set m_splat_5,23; .set direction_x_3,24; .set m_splat_6,25
        .set direction_y_3,26; .set c_y_2,28; .set direction_x_4,29; .set m_splat_7,30
        .set direction_y_4,31; .set order_z_2,20; .set direction_x_5,21; .set m_splat_8,32
        .set direction_y_5,33; .set c_z_2,34; .set m_splat_9,35; .set direction_z_2,36
        .set m_splat_10,37; .set direction_z_3,38; .set order_z_3,39; .set direction_z_4,40
        .set order_z_4,41; .set order_z_5,42; .set sign_2,18; .set there_2,43; .set order_2,44
        .set there_3,45; .set there_4,46; .set there_5,47; .set t_y_2,48; .set t_y_3,49
        .set order_3,50; .set t_y_4,51; .set order_4,52; .set t_y_5,53; .set order_5,54
        .set order_y_2,55; .set order_6,56; .set order_y_3,57; .set order_7,58; .set order_z_6,59
        .set order_z_7,60; .set t_e_2,61; .set t_e_3,62; .set t_e_4,63; .set t_e_5,64
        .set everywhere_2,48; .set everywhere_3,49; .set everywhere_4,51; .set everywhere_5,53
        .set t_y_6,39; .set low_x_2,61; .set high_x_2,44; .set low_x1_2,62; .set high_x1_2,50
        .set low_x2_2,63; .set high_x2_2,52; .set low_x3_2,64; .set high_x3_2,58; .set t_y_7,41
        .set order_y_4,7; .set order_y_5,22; .set order_y_6,21; .set t_y_8,24; .set low_x_3,36
        .set t_y_9,38; .set low_x1_3,40; .set high_x1_3,41; .set t_y_10,42; .set low_x2_3,44
        .set high_x2_3,50; .set low_x3_3,52; .set t_words_2,61; .set t_words2_2,36
        .set t_words1_2,9; .set t_words3_2,26; .set t_words_3,31; .set t_words1_3,33
        .set t_words2_3,24; .set lanes_2,40; .set t_y_11,18; .set lanes2_2,9; .set order_y_7,20
        .set lanes3_2,22; .set lanes1_2,26; .set t_y_12,31; .set lanes3_3,24; .set low_y_2,31
        .set high_y_2,7; .set low_y2_2,18; .set low_y3_2,20; .set c_greater_2,2
        .set c_greater_3,21; .set c_greater_4,29; .set c_greater_5,33; .set lanes_3,2
        .set c_greater_6,22; .set low_y_3,24; .set t_words_4,18; .set t_words2_4,20
        .set t_words_5,21; .set t_words1_4,22; .set t_words2_5,7; .set t_words3_3,24
        .set everywhere_6,6; .set everywhere_7,8; .set everywhere_8,2; .set everywhere_9,23
        .set everywhere_10,25; .set m_splat_11,26; .set everywhere_11,29; .set everywhere_12,32
        .set m_splat_12,33; .set m_splat_13,9; .set lanes3_4,20; .set m_splat_14,36
        .set lanes_4,37; .set c_greater_7,38; .set lanes1_3,21; .set m_splat_15,22
        .set lanes2_3,39; .set c_greater_8,40; .set lanes3_5,7; .set c_greater_9,24
        .set c_greater_10,6; .set lanes2_4,6; .set c_greater_11,7; .set c_greater_12,8
        .set everywhere_13,7; .set everywhere_14,9; .set order_8,18; .set everywhere_15,20
        .set a_window_2,6
        nop     $127                                    # 0e pairing
        biz     $count,$lr                              # 0o
        ilhu    $k_half,0x3eff                          # 1e
        lqa     $m_first,transpose_first                # 1o
        ilhu    $k_most,0x7fff                          # 2e
        lqa     $m_last,transpose_last                  # 2o
        ilhu    $k_one,0x3f80                           # 3e
        ilhu    $k_sign,0x8000                          # 4e
        iohl    $k_half,0xffff                          # 5e
        ilhu    $k_slack,0x3680                         # 6e 2^-18
        iohl    $k_most,0xffff                          # 7e
        il      $k_least,-1                             # 8e
        ila     $a_orders,orders                        # 9e
        lnop                                            # 9o pairing
next_window:
        ila     $m_splat,0x10203                        # 0e
        lqd     $direction_x,192($a_rays)               # 0o
        il      $wide,0                                 # 1e
        lqd     $direction_y,256($a_rays)               # 1o
        ila     $m_splat_2,0x10203                      # 2e
        lqd     $direction_z,320($a_rays)               # 2o
        ilhu    $m_splat_3,1                            # 3e
        lqd     $direction_x_2,192($a_rays)             # 3o
        ilhu    $m_splat_4,0x405                        # 4e
        lqd     $direction_y_2,256($a_rays)             # 4o
        ilhu    $m_splat_5,0x809                        # 5e
        lqd     $direction_x_3,208($a_rays)             # 5o
        ilhu    $m_splat_6,0xc0d                        # 6e
        lqd     $direction_y_3,272($a_rays)             # 6o
        fcmgt   $c_y_2,$direction_y,$direction_x        # 7e
        lqd     $direction_x_4,224($a_rays)             # 7o
        ilhu    $m_splat_7,1                            # 8e
        lqd     $direction_y_4,288($a_rays)             # 8o
        selb    $order_z_2,$direction_x,$direction_y,$c_y_2 # 9e
        lqd     $direction_x_5,240($a_rays)             # 9o
        ilhu    $m_splat_8,0x405                        # 10e
        lqd     $direction_y_5,304($a_rays)             # 10o
        fcmgt   $c_z_2,$direction_z,$order_z_2          # 11e
        shufb   $c_y_2,$c_y_2,$c_y_2,$m_splat           # 11o
        ilhu    $m_splat_9,0x809                        # 12e
        lqd     $direction_z_2,320($a_rays)             # 12o
        selb    $order_z_2,$order_z_2,$direction_z,$c_z_2 # 13e
        lqd     $direction_z,336($a_rays)               # 13o
        ilhu    $m_splat_10,0xc0d                       # 14e
        lqd     $direction_z_3,352($a_rays)             # 14o
        selb    $order_z_3,$direction_x_2,$direction_y_2,$c_y_2 # 15e
        lqd     $direction_z_4,368($a_rays)             # 15o
        selb    $order_z_4,$direction_x_3,$direction_y_3,$c_y_2 # 16e
        shufb   $c_z_2,$c_z_2,$c_z_2,$m_splat           # 16o
        selb    $order_z_5,$direction_x_4,$direction_y_4,$c_y_2 # 17e
        shufb   $sign_2,$order_z_2,$order_z_2,$m_splat  # 17o
        selb    $order_z_2,$direction_x_5,$direction_y_5,$c_y_2 # 18e
        lqd     $there_2,384($a_rays)                   # 18o
        selb    $order_2,$direction_y_2,$direction_z_2,$c_y_2 # 19e
        lqd     $there_3,400($a_rays)                   # 19o
        selb    $order_z_3,$order_z_3,$direction_z_2,$c_z_2 # 20e
        lqd     $there_4,416($a_rays)                   # 20o
        selb    $order_z_4,$order_z_4,$direction_z,$c_z_2 # 21e
        lqd     $there_5,432($a_rays)                   # 21o
        selb    $order_z_5,$order_z_5,$direction_z_3,$c_z_2 # 22e
        frest   $t_y_2,$order_z_3                       # 22o
        selb    $order_z_2,$order_z_2,$direction_z_4,$c_z_2 # 23e
        frest   $t_y_3,$order_z_4                       # 23o
        selb    $order_3,$direction_y_3,$direction_z,$c_y_2 # 24e
        frest   $t_y_4,$order_z_5                       # 24o
        selb    $order_4,$direction_y_4,$direction_z_3,$c_y_2 # 25e
        frest   $t_y_5,$order_z_2                       # 25o
        fi      $t_y_2,$order_z_3,$t_y_2                # 26e
        lqd     $order_5,0($a_orders)                   # 26o
        fi      $t_y_3,$order_z_4,$t_y_3                # 27e
        lqd     $order_y_2,32($a_orders)                # 27o
        fi      $t_y_4,$order_z_5,$t_y_4                # 28e
        lqd     $order_6,16($a_orders)                  # 28o
        fi      $t_y_5,$order_z_2,$t_y_5                # 29e
        lqd     $order_y_3,48($a_orders)                # 29o
        selb    $order_7,$direction_y_5,$direction_z_4,$c_y_2 # 30e
        lqd     $order_z_6,64($a_orders)                # 30o
        selb    $order_2,$order_2,$direction_x_2,$c_z_2 # 31e
        lqd     $order_z_7,80($a_orders)                # 31o
        selb    $order_3,$order_3,$direction_x_3,$c_z_2 # 32e
        fnms    $t_e_2,$order_z_3,$t_y_2,$k_one         # 33e
        fnms    $t_e_3,$order_z_4,$t_y_3,$k_one         # 34e
        fnms    $t_e_4,$order_z_5,$t_y_4,$k_one         # 35e
        fnms    $t_e_5,$order_z_2,$t_y_5,$k_one         # 36e
        selb    $order_4,$order_4,$direction_x_4,$c_z_2 # 37e
        selb    $order_7,$order_7,$direction_x_5,$c_z_2 # 38e
        fma     $everywhere_2,$t_e_2,$t_y_2,$t_y_2      # 39e
        fma     $everywhere_3,$t_e_3,$t_y_3,$t_y_3      # 40e
        fma     $everywhere_4,$t_e_4,$t_y_4,$t_y_4      # 41e
        fma     $everywhere_5,$t_e_5,$t_y_5,$t_y_5      # 42e
        and     $sign_2,$sign_2,$k_sign                 # 43e
        cgti    $there_2,$there_2,-1                    # 44e
        fm      $order_2,$order_2,$everywhere_2         # 45e
        fm      $order_3,$order_3,$everywhere_3         # 46e
        fm      $order_4,$order_4,$everywhere_4         # 47e
        fm      $order_7,$order_7,$everywhere_5         # 48e
        xor     $t_y_6,$order_z_3,$sign_2               # 49e
        cgti    $there_3,$there_3,-1                    # 50e
        fs      $low_x_2,$order_2,$k_slack              # 51e
        fa      $high_x_2,$order_2,$k_slack             # 52e
        fs      $low_x1_2,$order_3,$k_slack             # 53e
        fa      $high_x1_2,$order_3,$k_slack            # 54e
        fs      $low_x2_2,$order_4,$k_slack             # 55e
        fa      $high_x2_2,$order_4,$k_slack            # 56e
        fs      $low_x3_2,$order_7,$k_slack             # 57e
        fa      $high_x3_2,$order_7,$k_slack            # 58e
        fcgt    $t_y_6,$t_y_6,$k_half                   # 59e
        xor     $t_y_7,$order_z_4,$sign_2               # 60e
        cgti    $there_4,$there_4,-1                    # 61e
        cgti    $there_5,$there_5,-1                    # 62e
        selb    $order_y_4,$direction_z_2,$direction_x_2,$c_y_2 # 63e
        selb    $order_y_5,$direction_z,$direction_x_3,$c_y_2 # 64e
        selb    $order_y,$direction_z_3,$direction_x_4,$c_y_2 # 65e
        selb    $order_y_6,$direction_z_4,$direction_x_5,$c_y_2 # 66e
        andc    $t_y_8,$there_2,$t_y_6                  # 67e
        selb    $low_x_3,$k_most,$low_x_2,$there_2      # 68e
        selb    $high_x,$k_least,$high_x_2,$there_2     # 69e
        fcgt    $t_y_9,$t_y_7,$k_half                   # 70e
        selb    $low_x1_3,$k_most,$low_x1_2,$there_3    # 71e
        selb    $high_x1_3,$k_least,$high_x1_2,$there_3 # 72e
        xor     $t_y_10,$order_z_5,$sign_2              # 73e
        selb    $low_x2_3,$k_most,$low_x2_2,$there_4    # 74e
        selb    $high_x2_3,$k_least,$high_x2_2,$there_4 # 75e
        selb    $low_x3_3,$k_most,$low_x3_2,$there_5    # 76e
        shufb   $t_words_2,$low_x_3,$low_x2_3,$m_first  # 76o
        selb    $high_x3_2,$k_least,$high_x3_2,$there_5 # 77e
        shufb   $t_words2_2,$low_x_3,$low_x2_3,$m_last  # 77o
        selb    $order_y_4,$order_y_4,$direction_y_2,$c_z_2 # 78e
        shufb   $t_words1_2,$low_x1_3,$low_x3_3,$m_first # 78o
        selb    $order_y_5,$order_y_5,$direction_y_3,$c_z_2 # 79e
        shufb   $t_words3_2,$low_x1_3,$low_x3_3,$m_last # 79o
        selb    $order_y,$order_y,$direction_y_4,$c_z_2 # 80e
        shufb   $t_words_3,$high_x,$high_x2_3,$m_first  # 80o
        selb    $order_y_6,$order_y_6,$direction_y_5,$c_z_2 # 81e
        shufb   $t_words1_3,$high_x1_3,$high_x3_2,$m_first # 81o
        or      $wide,$wide,$t_y_8                      # 82e
        shufb   $t_words2_3,$high_x,$high_x2_3,$m_last  # 82o
        andc    $t_y_9,$there_3,$t_y_9                  # 83e
        shufb   $t_words+3,$high_x1_3,$high_x3_2,$m_last # 83o
        fcgt    $t_y_6,$t_y_10,$k_half                  # 84e
        shufb   $lanes_2,$t_words_2,$t_words1_2,$m_first # 84o
        xor     $t_y_11,$order_z_2,$sign_2              # 85e
        shufb   $lanes+1,$t_words_2,$t_words1_2,$m_last # 85o
        fm      $order_y_4,$order_y_4,$everywhere_2     # 86e
        shufb   $lanes2_2,$t_words2_2,$t_words3_2,$m_first # 86o
        fm      $order_y_7,$order_y_5,$everywhere_3     # 87e
        shufb   $lanes3_2,$t_words2_2,$t_words3_2,$m_last # 87o
        fm      $order_y,$order_y,$everywhere_4         # 88e
        shufb   $lanes,$t_words_3,$t_words1_3,$m_first  # 88o
        fm      $order_y_6,$order_y_6,$everywhere_5     # 89e
        shufb   $lanes1_2,$t_words_3,$t_words1_3,$m_last # 89o
        or      $wide,$wide,$t_y_9                      # 90e
        shufb   $lanes+2,$t_words2_3,$t_words+3,$m_first # 90o
        andc    $t_y_12,$there_4,$t_y_6                 # 91e
        shufb   $lanes3_3,$t_words2_3,$t_words+3,$m_last # 91o
        fcgt    $t_y_11,$t_y_11,$k_half                 # 92e
        or      $wide,$wide,$t_y_12                     # 93e
        andc    $t_y_11,$there_5,$t_y_11                # 94e
        fs      $low_y_2,$order_y_4,$k_slack            # 95e
        or      $wide,$wide,$t_y_11                     # 96e
        fa      $high_y_2,$order_y_4,$k_slack           # 97e
        fs      $low_y+1,$order_y_7,$k_slack            # 98e
        orx     $wide,$wide                             # 98o
        fa      $high_y+1,$order_y_7,$k_slack           # 99e
        fs      $low_y2_2,$order_y,$k_slack             # 100e
        fa      $high_y+2,$order_y,$k_slack             # 101e
        lnop                                            # 101o pairing
        fs      $low_y3_2,$order_y_6,$k_slack           # 102e
        shufb   $wide,$wide,$wide,$m_splat_2            # 102o
        fa      $high_y+3,$order_y_6,$k_slack           # 103e
        fcgt    $c_greater_2,$lanes_2,$lanes+1          # 104e
        fcgt    $c_greater_3,$lanes2_2,$lanes3_2        # 105e
        fcgt    $c_greater_4,$lanes1_2,$lanes           # 106e
        fcgt    $c_greater_5,$lanes3_3,$lanes+2         # 107e
        selb    $lanes_3,$lanes_2,$lanes+1,$c_greater_2 # 108e
        selb    $lanes2_2,$lanes2_2,$lanes3_2,$c_greater_3 # 109e
        selb    $lanes,$lanes,$lanes1_2,$c_greater_4    # 110e
        selb    $lanes+2,$lanes+2,$lanes3_3,$c_greater_5 # 111e
        fcgt    $c_greater_3,$lanes_3,$lanes2_2         # 112e
        fcgt    $c_greater_6,$lanes+2,$lanes            # 113e
        selb    $low_y_3,$k_most,$low_y_2,$there_2      # 114e
        selb    $high_y_2,$k_least,$high_y_2,$there_2   # 115e
        selb    $low_y+1,$k_most,$low_y+1,$there_3      # 116e
        selb    $high_y+1,$k_least,$high_y+1,$there_3   # 117e
        selb    $low_y+2,$k_most,$low_y2_2,$there_4     # 118e
        selb    $high_y+2,$k_least,$high_y+2,$there_4   # 119e
        lnop                                            # 119o pairing
        selb    $low_y+3,$k_most,$low_y3_2,$there_5     # 120e
        shufb   $t_words_4,$low_y_3,$low_y+2,$m_first   # 120o
        selb    $high_y+3,$k_least,$high_y+3,$there_5   # 121e
        shufb   $t_words2_4,$low_y_3,$low_y+2,$m_last   # 121o
        selb    $lanes_3,$lanes_3,$lanes2_2,$c_greater_3 # 122e
        shufb   $t_words1_2,$low_y+1,$low_y+3,$m_first  # 122o
        selb    $lanes,$lanes,$lanes+2,$c_greater_6     # 123e
        shufb   $t_words+3,$low_y+1,$low_y+3,$m_last    # 123o
        selb    $lanes_3,$lanes_3,$k_least,$wide        # 124e
        shufb   $t_words_5,$high_y_2,$high_y+2,$m_first # 124o
        iohl    $m_splat_3,515                          # 125e
        shufb   $t_words1_4,$high_y+1,$high_y+3,$m_first # 125o
        iohl    $m_splat_4,0x607                        # 126e
        shufb   $t_words2_5,$high_y_2,$high_y+2,$m_last # 126o
        iohl    $m_splat_5,0xa0b                        # 127e
        shufb   $t_words3_3,$high_y+1,$high_y+3,$m_last # 127o
        iohl    $m_splat_6,0xe0f                        # 128e
        shufb   $everywhere,$lanes_3,$lanes_3,$m_splat_3 # 128o
        selb    $lanes,$lanes,$k_most,$wide             # 129e
        shufb   $everywhere_6,$lanes_3,$lanes_3,$m_splat_4 # 129o
        iohl    $m_splat_7,515                          # 130e
        shufb   $everywhere_7,$lanes_3,$lanes_3,$m_splat_5 # 130o
        iohl    $m_splat_8,0x607                        # 131e
        shufb   $everywhere_8,$lanes_3,$lanes_3,$m_splat_6 # 131o
        iohl    $m_splat_9,0xa0b                        # 132e
        shufb   $everywhere_9,$lanes,$lanes,$m_splat_7  # 132o
        iohl    $m_splat_10,0xe0f                       # 133e
        shufb   $everywhere_10,$lanes,$lanes,$m_splat_8 # 133o
        ilhu    $m_splat_11,1                           # 134e
        shufb   $everywhere_11,$lanes,$lanes,$m_splat_9 # 134o
        ilhu    $m_splat_7,0x405                        # 135e
        shufb   $everywhere_12,$lanes,$lanes,$m_splat_10 # 135o
        ilhu    $m_splat_12,0x809                       # 136e
        shufb   $lanes,$t_words_4,$t_words1_2,$m_first  # 136o
        ilhu    $m_splat_9,0xc0d                        # 137e
        shufb   $lanes+1,$t_words_4,$t_words1_2,$m_last # 137o
        ilhu    $m_splat,1                              # 138e
        shufb   $lanes+2,$t_words2_4,$t_words+3,$m_first # 138o
        ilhu    $m_splat_13,0x405                       # 139e
        shufb   $lanes3_4,$t_words2_4,$t_words+3,$m_last # 139o
        ilhu    $m_splat_14,0x809                       # 140e
        shufb   $lanes_4,$t_words_5,$t_words1_4,$m_first # 140o
        fcgt    $c_greater_7,$lanes,$lanes+1            # 141e
        shufb   $lanes1_3,$t_words_5,$t_words1_4,$m_last # 141o
        ilhu    $m_splat_15,0xc0d                       # 142e
        shufb   $lanes2_3,$t_words2_5,$t_words3_3,$m_first # 142o
        fcgt    $c_greater_8,$lanes+2,$lanes3_4         # 143e
        shufb   $lanes3_5,$t_words2_5,$t_words3_3,$m_last # 143o
        selb    $lanes,$lanes,$lanes+1,$c_greater_7     # 144e
        stqd    $everywhere,0($a_window)                # 144o
        fcgt    $c_greater_9,$lanes1_3,$lanes_4         # 145e
        stqd    $everywhere_6,16($a_window)             # 145o
        selb    $lanes+2,$lanes+2,$lanes3_4,$c_greater_8 # 146e
        stqd    $everywhere_7,32($a_window)             # 146o
        fcgt    $c_greater_10,$lanes3_5,$lanes2_3       # 147e
        stqd    $everywhere_8,48($a_window)             # 147o
        selb    $lanes_3,$lanes_4,$lanes1_3,$c_greater_9 # 148e
        stqd    $everywhere_9,64($a_window)             # 148o
        selb    $lanes2_4,$lanes2_3,$lanes3_5,$c_greater_10 # 149e
        stqd    $everywhere_10,80($a_window)            # 149o
        fcgt    $c_greater_11,$lanes,$lanes+2           # 150e
        stqd    $everywhere_11,96($a_window)            # 150o
        fcgt    $c_greater_12,$lanes2_4,$lanes_3        # 151e
        stqd    $everywhere_12,112($a_window)           # 151o
        selb    $lanes,$lanes,$lanes+2,$c_greater_11    # 152e
        hbrr    next_window_back,next_window            # 152o hint
        selb    $lanes_3,$lanes_3,$lanes2_4,$c_greater_12 # 153e
        selb    $lanes,$lanes,$k_least,$wide            # 154e
        iohl    $m_splat_11,515                         # 155e
        iohl    $m_splat_7,0x607                        # 156e
        iohl    $m_splat_12,0xa0b                       # 157e
        shufb   $everywhere,$lanes,$lanes,$m_splat_11   # 157o
        iohl    $m_splat_9,0xe0f                        # 158e
        shufb   $everywhere_6,$lanes,$lanes,$m_splat_7  # 158o
        selb    $lanes_3,$lanes_3,$k_most,$wide         # 159e
        shufb   $everywhere_13,$lanes,$lanes,$m_splat_12 # 159o
        iohl    $m_splat,515                            # 160e
        shufb   $everywhere_7,$lanes,$lanes,$m_splat_9  # 160o
        iohl    $m_splat_13,0x607                       # 161e
        stqd    $everywhere,128($a_window)              # 161o
        iohl    $m_splat_14,0xa0b                       # 162e
        shufb   $everywhere,$lanes_3,$lanes_3,$m_splat  # 162o
        iohl    $m_splat_15,0xe0f                       # 163e
        shufb   $everywhere_14,$lanes_3,$lanes_3,$m_splat_13 # 163o
        selb    $order_8,$order_5,$order_y_2,$c_y_2     # 164e
        shufb   $everywhere_15,$lanes_3,$lanes_3,$m_splat_14 # 164o
        selb    $order,$order_6,$order_y_3,$c_y_2       # 165e
        shufb   $everywhere_8,$lanes_3,$lanes_3,$m_splat_15 # 165o
        selb    $order_8,$order_8,$order_z_6,$c_z_2     # 166e
        stqd    $everywhere_6,144($a_window)            # 166o
        selb    $order,$order,$order_z_7,$c_z_2         # 167e
        stqd    $everywhere_13,160($a_window)           # 167o
        ai      $a_rays,$a_rays,320                     # 168e
        stqd    $everywhere_7,176($a_window)            # 168o
        ai      $a_window_2,$a_window,144               # 169e
        stqd    $everywhere,192($a_window)              # 169o
        ai      $count,$count,-1                        # 170e
        stqd    $everywhere_14,208($a_window)           # 170o
        ai      $a_rays,$a_rays,320                     # 171e
        stqd    $everywhere_15,224($a_window)           # 171o
        stqd    $everywhere_8,240($a_window)            # 172o
        stqd    $order_8,256($a_window)                 # 173o
        nop     $127                                    # 174e pairing
        stqd    $order,272($a_window)                   # 174o
        ai      $a_window,$a_window_2,144               # 175e
next_window_back:
        brnz    $count,next_window                      # 175o
        nop     $127                                    # 176e pairing
        bi      $lr                                     # 176o
endfunction mesh_windows_r16
