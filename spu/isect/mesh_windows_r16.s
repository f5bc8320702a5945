# mesh_windows_r16   where the rays of packets from the eye go, for filter_triangles_r16
#   C       void mesh_windows_r16(const struct rays16 *, int count, struct mesh_window *);
#   In      $3 RAYS16, one behind the other, $4 count (0 is none), $5 MESH_WINDOWs likewise;
#           pointers 16-aligned
#   Out     the windows
#   Uses    $3-$5, $10-$79   Saves  -   Stack  0   Calls  -
#   Domain  unit directions; t has a sign where no ray is, and anything else there
#   Error   0: each slope is 2^-18 within its row's window, which is more than all roundings of the
#           slope, of the ray's SHEARS, and of a vertex's slopes in filter_triangles_r16
#   Twin    lab/twins/src/mesh_rows.rs
#
# The slopes are those against the axis along which the first ray is longest. If a ray's component
# along it is less than 1/2, or has the other sign, the windows have everything: packets across so
# wide an angle are seldom.

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
        biz     $count,$lr
        ilhu    $k_one,0x3f80
        ilhu    $k_sign,0x8000
        load_constant $k_half,0x3effffff
        ilhu    $k_slack,0x3680                         # 2^-18
        load_constant $k_most,0x7fffffff
        il      $k_least,-1
        lqa     $m_first,transpose_first
        lqa     $m_last,transpose_last
        ila     $a_orders,orders
next_window:
        # The order of the axes is the first ray's.
        lqd     $direction_x,RAYS16_direction_x($a_rays)
        lqd     $direction_y,RAYS16_direction_y($a_rays)
        lqd     $direction_z,RAYS16_direction_z($a_rays)
        splat_mask $m_splat
        fcmgt   $c_y,$direction_y,$direction_x
        selb    $z,$direction_x,$direction_y,$c_y
        fcmgt   $c_z,$direction_z,$z
        selb    $z,$z,$direction_z,$c_z
        splat   $c_y,$c_y,$m_splat
        splat   $c_z,$c_z,$m_splat
        splat   $sign,$z,$m_splat
        and     $sign,$sign,$k_sign
        il      $wide,0
    .irp row, 0,1,2,3
        lqd     $direction_x,RAYS16_direction_x+16*\row($a_rays)
        lqd     $direction_y,RAYS16_direction_y+16*\row($a_rays)
        lqd     $direction_z,RAYS16_direction_z+16*\row($a_rays)
        lqd     $there,RAYS16_t+16*\row($a_rays)
        cgti    $there,$there,-1
        by_longest $x,$direction_y,$direction_z,$direction_x
        by_longest $y,$direction_z,$direction_x,$direction_y
        by_longest $z,$direction_x,$direction_y,$direction_z
        xor     $t_y,$z,$sign
        fcgt    $t_y,$t_y,$k_half
        andc    $t_y,$there,$t_y
        or      $wide,$wide,$t_y
        reciprocal_f4 $inverse,$z,$t_y,$t_e,$k_one
    .irp axis, x,y
        fm      $\axis,$\axis,$inverse
        fs      $low_\axis+\row,$\axis,$k_slack
        fa      $high_\axis+\row,$\axis,$k_slack
        selb    $low_\axis+\row,$k_most,$low_\axis+\row,$there
        selb    $high_\axis+\row,$k_least,$high_\axis+\row,$there
    .endr
    .endr
        splat_mask $m_splat
        orx     $wide,$wide
        splat   $wide,$wide,$m_splat
        put_limit low_x,minimum_f4,$k_least,low_x
        put_limit high_x,maximum,$k_most,high_x
        put_limit low_y,minimum_f4,$k_least,low_y
        put_limit high_y,maximum,$k_most,high_y
        put_order 0,order
        put_order 16,depth
    .rept   2                                           # ai reaches to 511
        ai      $a_rays,$a_rays,RAYS16_SIZE/2
        ai      $a_window,$a_window,MESH_WINDOW_SIZE/2
    .endr
        ai      $count,$count,-1
        brnz    $count,next_window
        bi      $lr
endfunction mesh_windows_r16
