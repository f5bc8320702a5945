# mesh_rays_r16   records of the rays of packets one by one, for mesh_filter_rays
#   C       void mesh_rays_r16(const struct rays16 *, int count, struct mesh_ray *);
#   In      $3 RAYS16, consecutive, $4 count (0 is none, at most 8), $5 where 16 records
#           for each packet go; pointers 16-aligned
#   Out     the records
#   Uses    $3-$5, $10-$60   Saves  -   Stack  0   Calls  -
#   Domain  origins below 2^60; components of directions up to 1
#   Error   0: no ray meets a plane earlier or later than its record has it
#   Twin    lab/twins/src/mesh_rays.rs
#
# A ray meets a plane at p of an axis at (p - o) / d. A component of a direction below 2^-60
# becomes 2^-60, which moves the ray by less than the slacks: as in filter_boxes_r16, each box has
# one, and the origin moves by 2^-19 of its largest coordinate, forwards for the planes that are
# met first and backwards for the others.

        .include "work_unit.inc"
        .include "macros.inc"
        .include "transpose.inc"
        .include "reciprocal.inc"
        .include "extremes.inc"

        .set    NEXT,3
        registers a_row,count,a_record
        .set    NEXT,10
        # constants
        registers m_first,m_last,m_sign,k_tiny,k_one,k_slack,k_zero,k_to_next
        # state
        registers number                                # 127 - the row's rays' numbers
        # a row
        registers o_x,o_y,o_z,size,other,c_greater,slack,last,step
        registers d_x,d_y,d_z,t_y,t_e,signed
        # the records of the row by field, later by ray
        registers first                                 # to 36: the first quadwords
        .set    NEXT,first+4
        registers second                                # to 40
        .set    NEXT,second+4
        registers third                                 # to 44
        .set    NEXT,third+4
        registers words                                 # to 48
        .set    NEXT,words+4
        .set    inverse_x,first+1
        .set    inverse_y,first+2
        .set    inverse_z,first+3

        transpose_table .rodata.mesh
numbers:
        .int    127,126,125,124

function mesh_rays_r16
        biz     $count,$lr
        shli    $count,$count,2
        lqa     $m_first,transpose_first
        lqa     $m_last,transpose_last
        lqa     $number,numbers
        ilhu    $m_sign,0x8000
        ilhu    $k_tiny,0x2180                          # 2^-60
        ilhu    $k_one,0x3f80
        ilhu    $k_slack,0x3600                         # 2^-19
        il      $k_zero,0
        il      $k_to_next,RAYS16_SIZE-3*16
next_row:
    .irp axis, x,y,z
        lqd     $o_\axis,RAYS16_origin_\axis($a_row)
        lqd     $d_\axis,RAYS16_direction_\axis($a_row)
    .endr
        andc    $size,$o_x,$m_sign
        andc    $other,$o_y,$m_sign
        maximum $size,$other,$c_greater
        andc    $other,$o_z,$m_sign
        maximum $size,$other,$c_greater
        fm      $slack,$size,$k_slack
    .set    AXIS,1
    .irp axis, x,y,z
        fcmgt   $c_greater,$k_tiny,$d_\axis
        selb    $d_\axis,$d_\axis,$k_tiny,$c_greater
        reciprocal_f4 $inverse_\axis,$d_\axis,$t_y,$t_e,$k_one
        selb    $signed,$slack,$inverse_\axis,$m_sign
        fa      $other,$o_\axis,$signed
        fs      $o_\axis,$o_\axis,$signed
        fnms    $second+AXIS,$other,$inverse_\axis,$k_zero
        fnms    $third+AXIS,$o_\axis,$inverse_\axis,$k_zero
    .set    AXIS,AXIS+1
    .endr
        # Going down an axis, the upper planes are met first.
        rotmai  $first,$inverse_x,-31
        andi    $first,$first,BOXES_hi_x-BOXES_lo_x
        rotmai  $other,$inverse_z,-31
        andi    $other,$other,BOXES_hi_x-BOXES_lo_x
        ai      $other,$other,BOXES_lo_z
        shli    $other,$other,24
        or      $first,$first,$other
        rotmai  $second,$inverse_y,-31
        andi    $second,$second,BOXES_hi_x-BOXES_lo_x
        ai      $second,$second,BOXES_lo_y
        shli    $other,$number,24
        or      $second,$second,$other
        lqd     $third,RAYS16_t($a_row)
        transpose first,first,words,$m_first,$m_last
        transpose second,second,words,$m_first,$m_last
        transpose third,third,words,$m_first,$m_last
    .irp lane, 0,1,2,3
        stqd    $first+\lane,MESH_RAY_planes+MESH_RAY_SIZE*\lane($a_record)
        stqd    $second+\lane,MESH_RAY_number+MESH_RAY_SIZE*\lane($a_record)
        stqd    $third+\lane,MESH_RAY_t+MESH_RAY_SIZE*\lane($a_record)
    .endr
        # After the fourth row, the next packet.
        andi    $last,$number,12
        ceqi    $last,$last,0
        il      $step,16
        selb    $step,$step,$k_to_next,$last
        a       $a_row,$a_row,$step
        ai      $number,$number,-4
        ai      $a_record,$a_record,4*MESH_RAY_SIZE
        ai      $count,$count,-1
        brnz    $count,next_row                         # at least 4 passes: a packet has four rows
        bi      $lr
endfunction mesh_rays_r16
