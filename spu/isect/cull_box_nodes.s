# cull_box_nodes   of nodes under packets' bounds, the children whose boxes a ray may meet
#   C       struct candidate *cull_box_nodes(const struct candidate *, int count,
#                                            struct candidate *, int lanes);
#   In      $3 candidates whose objects are BOX_NODEs, $4 count (0 is none), $5 where the list
#           goes, $6 0, or 4 if filter_box_children_r16 gets the list; pointers 16-aligned
#   Out     candidates of such children, node by node, children in order: object is the child, or
#           with 4 its node's address plus 4 times its lane, the rest the node's; one more quadword
#           may be written
#           $3 end of the list
#   Uses    $3-$4, $10-$48   Saves  -   Stack  0   Calls  -
#   Domain  bounds as bound_fan_r16 makes them, or bound_origins_r16; half sizes of a child's box
#           with a slack of 2^-18 (|c| + H), c its centre, H half its diagonal; of a lane without a
#           child, -FARTHEST; distances from 2^-60 to 2^60
#   Error   0: no child is left out that a ray of the packet meets, from inside or within its t
#   Twin    lab/twins/src/cull_box_nodes.rs
#
# As cull_nodes, with boxes instead of spheres. Their reach depends on the direction: in the
# direction w it is R + sum of half |w|, R the radius of the bound. The cone's side is replaced by
# the plane that touches it towards the box's centre, whose normal is
#   w = cosine (v - a axis) / perp - sine axis
# so that v.w = perp cosine - a sine. No ray goes beyond that plane by more than R, because all
# directions are within the cone. A child is culled if one of these is below 0:
#   R + half.|w| - v.w            the whole box is beyond the plane
#   R + half.|axis| + a           it is beyond the apex
#   R + half.|axis| + farthest - a   it is too far away
# A bound that is open has axis, cosine and sine 0, and so w = 0, and nothing is culled.

        .include "cull_tmpl.inc"

        .set    NEXT,3
        registers a_first                               # candidate
        registers count,a_list,lanes
        # constants
        .set    m_child,10                              # to 13: a word of one and three of another
        # state
        .set    NEXT,14
        registers a_candidate
        registers found                                 # bytes of the list so far
        # the candidate
        registers candidate,a_bound,child
        # the bound
        registers apex_x,apex_y,apex_z,axis_x,axis_y,axis_z,cosine,sine
        registers rays_radius                           # the rays' radius
        registers farthest
        # the children
        registers vx,vy,vz
        registers half_x,half_y,half_z
        registers along,perp,t_y,beside,ahead,near
        registers side_x,side_y,side_z                  # w
        registers step                                  # four of them
        .set    NEXT,step+4
        registers entry
        # the candidate, loaded again instead of being kept in a register for so long
        registers a_again,again
        # what the list gets of a child: its address, or its lane's
        registers m_of_child,m_of_node,k_lanes,c_address,m_sign

        cull_tables .rodata.boxes

function cull_box_nodes
        cull_begin
        ilhu    $m_sign,0x8000
next_node:
        lqd     $candidate,0($a_candidate)
        rotqbyi $a_bound,$candidate,CANDIDATE_bound
        lqd     $cosine,BOUND_cosine($a_bound)
        lqd     $sine,BOUND_sine($a_bound)
        lqd     $rays_radius,BOUND_radius($a_bound)
        lqd     $farthest,BOUND_farthest($a_bound)
    .irp axis, x,y,z
        lqd     $v\axis,BOX_NODE_\axis($candidate)
        lqd     $half_\axis,BOX_NODE_half_\axis($candidate)
        lqd     $apex_\axis,BOUND_apex_\axis($a_bound)
        lqd     $axis_\axis,BOUND_axis_\axis($a_bound)
        fs      $v\axis,$v\axis,$apex_\axis
    .endr
        fm      $along,$vx,$axis_x
        fma     $along,$vy,$axis_y,$along
        fma     $along,$vz,$axis_z,$along
        fnms    $vx,$along,$axis_x,$vx
        fnms    $vy,$along,$axis_y,$vy
        fnms    $vz,$along,$axis_z,$vz
        fm      $perp,$vx,$vx
        fma     $perp,$vy,$vy,$perp
        fma     $perp,$vz,$vz,$perp                     # squared
        frsqest $t_y,$perp
        fi      $t_y,$perp,$t_y
        fm      $t_y,$t_y,$cosine
        fm      $perp,$perp,$t_y                        # perp cosine
    .irp axis, x,y,z
        fm      $side_\axis,$axis_\axis,$sine
        fms     $side_\axis,$v\axis,$t_y,$side_\axis
        andc    $side_\axis,$side_\axis,$m_sign
        andc    $axis_\axis,$axis_\axis,$m_sign
    .endr
        fma     $beside,$half_x,$side_x,$rays_radius
        fma     $beside,$half_y,$side_y,$beside
        fma     $beside,$half_z,$side_z,$beside
        fma     $ahead,$half_x,$axis_x,$rays_radius
        fma     $ahead,$half_y,$axis_y,$ahead
        fma     $ahead,$half_z,$axis_z,$ahead
        fma     $beside,$along,$sine,$beside
        fs      $beside,$beside,$perp
        fa      $near,$ahead,$farthest
        fa      $ahead,$ahead,$along
        fs      $near,$near,$along
        or      $ahead,$ahead,$near
        or      $ahead,$ahead,$half_x                   # below 0 without a child
        cull_list BOX_NODE
        a       $3,$3,$found
        bi      $lr
endfunction cull_box_nodes
