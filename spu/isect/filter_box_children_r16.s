# filter_box_children_r16   of nodes' children, those whose boxes one of a packet's rays may meet
#   C       struct candidate *filter_box_children_r16(const struct candidate *, int count,
#                                                     struct candidate *);
#   In      $3 candidates as cull_box_nodes makes them with 4, $4 count (0 is none), $5 where the
#           list goes, which may be the same place; pointers 16-aligned
#   Out     candidates of such children, in order: object is the child, the rest the candidate's;
#           as many quadwords may be written as there are candidates
#           $3 end of the list
#   Uses    $3-$4, $10-$58   Saves  -   Stack  0   Calls  -
#   Domain  bounds as bound_origins_r16 makes them; |d| = 1 within 4 ulp; half sizes of a child's
#           box with a slack of 2^-18 (|c| + H), c its centre, H half its diagonal; distances from
#           2^-60 to 2^60
#   Error   0: no child is left out that a ray of the packet meets
#   Twin    lab/twins/src/cull_box_nodes.rs
#
# Separating axes, without a division. With f = c - origin and the box's half sizes h, a ray misses
# the box if along one of the axes' cross products with d it passes beside it,
#   |f.y d.z - f.z d.y| > h.y |d.z| + h.z |d.y|, and so on,
# or if the box is behind the origin: f.d + h.|d| < 0. The half sizes have a slack for the origin,
# 2^-18 (|apex| + r), as in filter_children_r16. Both slacks together are 32 ulp of |f| along each
# axis, and the roundings of each comparison add up to less than 8 ulp of |f| (|d.y| + |d.z|).

        .include "filter_tmpl.inc"

        .set    NEXT,3
        registers a_first                               # candidate
        registers count,a_list
        # constants
        .set    NEXT,10
        registers m_x,m_low,m_extent,m_entry,k_sign,k_slack
        # state
        registers a_candidate
        registers found                                 # children so far
        # the candidate
        registers candidate,a_bound,a_packet,extent,turned
        # the child
        registers m_lane                                # the shuffle that splats its word
        registers cx,cy,cz,half_x,half_y,half_z,child,entry,offset
        # the rays
        registers ox,oy,oz,dx,dy,dz,fx,fy,fz
        registers ax,ay,az                              # |d|
        registers cross_x,cross_y,cross_z,reach_x,reach_y,reach_z,ahead,t
        registers all_miss                              # signs
        registers any
        # the candidate, loaded again instead of being kept in a register for so long
        registers again

        filter_tables .rodata.boxes

function filter_box_children_r16
        ori     $a_candidate,$a_first,0
        ori     $3,$a_list,0
        biz     $count,$lr
        il      $found,0
        lqa     $m_extent,extent_words
        lqa     $m_entry,entry_words
        ilhu    $k_sign,0x8000
        ilhu    $k_slack,0x3680                         # 2^-18
        load_constant $m_x,0x00010203
        load_constant $m_low,0x03030303
next_child:
        filter_child
    .irp axis, x,y,z
        lqd     $c\axis,BOX_NODE_\axis($candidate)
        shufb   $c\axis,$c\axis,$c\axis,$m_lane
        lqd     $half_\axis,BOX_NODE_half_\axis($candidate)
        shufb   $half_\axis,$half_\axis,$half_\axis,$m_lane
        fma     $half_\axis,$extent,$k_slack,$half_\axis
    .endr
    .irp row, 0,1,2,3
    .irp axis, x,y,z
        lqd     $o\axis,RAYS16_origin_\axis+16*\row($a_packet)
        lqd     $d\axis,RAYS16_direction_\axis+16*\row($a_packet)
        fs      $f\axis,$c\axis,$o\axis
        andc    $a\axis,$d\axis,$k_sign
    .endr
        lqd     $t,RAYS16_t+16*\row($a_packet)
        fm      $cross_x,$fz,$dy
        fms     $cross_x,$fy,$dz,$cross_x
        fm      $reach_x,$half_z,$ay
        fma     $reach_x,$half_y,$az,$reach_x
        fm      $cross_y,$fx,$dz
        fms     $cross_y,$fz,$dx,$cross_y
        fm      $reach_y,$half_x,$az
        fma     $reach_y,$half_z,$ax,$reach_y
        fm      $cross_z,$fy,$dx
        fms     $cross_z,$fx,$dy,$cross_z
        fm      $reach_z,$half_y,$ax
        fma     $reach_z,$half_x,$ay,$reach_z
    .irp axis, x,y,z
        fcmgt   $cross_\axis,$cross_\axis,$reach_\axis
    .endr
        fm      $ahead,$fx,$dx
        fma     $ahead,$fy,$dy,$ahead
        fma     $ahead,$fz,$dz,$ahead
        fma     $ahead,$half_x,$ax,$ahead
        fma     $ahead,$half_y,$ay,$ahead
        fma     $ahead,$half_z,$az,$ahead
        or      $cross_x,$cross_x,$cross_y
        or      $cross_z,$cross_z,$ahead
        or      $cross_x,$cross_x,$t
    .if \row
        or      $cross_x,$cross_x,$cross_z
        and     $all_miss,$all_miss,$cross_x
    .else
        or      $all_miss,$cross_x,$cross_z
    .endif
    .endr
        nor     $any,$all_miss,$all_miss
        rotmai  $any,$any,-31
        orx     $any,$any                               # all ones if a ray may meet the box
        filter_list BOX_NODE
        bi      $lr
endfunction filter_box_children_r16
