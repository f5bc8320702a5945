# cull_nodes   of nodes under packets' bounds, the children that some ray of the packet may meet
#   C       struct candidate *cull_nodes(const struct candidate *, int count, struct candidate *,
#                                        int lanes);
#   In      $3 candidates whose objects are NODEs, $4 count (0 is none), $5 where the list goes, $6
#           0, or 4 if filter_children_r16 gets the list; pointers 16-aligned
#   Out     candidates of such children, node by node, children in order: object is the child, or
#           with 4 its node's address plus 4 times its lane, the rest the node's; one more quadword
#           may be written
#           $3 end of the list
#   Uses    $3-$4, $10-$48   Saves  -   Stack  0   Calls  -
#   Domain  bounds as bound_fan_r16 makes them, or bound_origins_r16; the radius of a child's sphere
#           with a slack of 2^-18 (|c| + R), c its centre, R its radius; of a lane without a child,
#           -FARTHEST; distances from 2^-60 to 2^60
#   Error   0: no child is left out that a ray of the packet meets, from inside or within its t
#   Twin    lab/twins/src/cull_nodes.rs
#
# The four children are in the four lanes. Relative to the bound's apex, with v = c - apex:
#   a = v.axis                  along the cone
#   perp = |v - a axis|         across it
#   S = R + radius              shrinking the rays to the apex enlarges the sphere by as much
# A child is culled if one of these is below 0:
#   S - perp cosine + a sine    S minus the distance from the cone's side
#   S + a                       the whole sphere is beyond the apex
#   S + farthest - a            the whole sphere is too far away
# The perpendicular keeps the digits for a distant sphere. 12 bits of its length are enough,
# because the bound's cosine is smaller by as much.
#
# The slack is 32 ulp, and the roundings add up to 24. Most of them truncate to the safe side: with
# a slack of only 2 ulp of R, no sphere in
# lab/kernels/tests/suite/rays/conservative.rs was lost. The first ones were lost with a slack of
# minus 2 ulp of |c| + R.

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
        registers rays_radius                             # the rays' radius
        registers farthest
        # the children
        registers vx,vy,vz
        registers reach                                 # S
        registers along,perp,t_y,beside,ahead,near
        registers step                                  # to 42
        .set    NEXT,43
        registers entry
        # the candidate, loaded again instead of being kept in a register for so long
        registers a_again,again
        # what the list gets of a child: its address, or its lane's
        registers m_of_child,m_of_node,k_lanes,c_address

        cull_tables .rodata

function cull_nodes
        cull_begin
next_node:
        lqd     $candidate,0($a_candidate)
        rotqbyi $a_bound,$candidate,CANDIDATE_bound
        lqd     $reach,NODE_radius($candidate)
        lqd     $cosine,BOUND_cosine($a_bound)
        lqd     $sine,BOUND_sine($a_bound)
        lqd     $rays_radius,BOUND_radius($a_bound)
        lqd     $farthest,BOUND_farthest($a_bound)
    .irp axis, x,y,z
        lqd     $v\axis,NODE_\axis($candidate)
        lqd     $apex_\axis,BOUND_apex_\axis($a_bound)
        lqd     $axis_\axis,BOUND_axis_\axis($a_bound)
        fs      $v\axis,$v\axis,$apex_\axis
    .endr
        fm      $along,$vx,$axis_x
        fma     $along,$vy,$axis_y,$along
        fma     $along,$vz,$axis_z,$along
        fa      $reach,$reach,$rays_radius
        fa      $ahead,$reach,$along
        fa      $near,$reach,$farthest
        fs      $near,$near,$along
        or      $ahead,$ahead,$near
        fma     $beside,$along,$sine,$reach
        fnms    $vx,$along,$axis_x,$vx
        fnms    $vy,$along,$axis_y,$vy
        fnms    $vz,$along,$axis_z,$vz
        fm      $perp,$vx,$vx
        fma     $perp,$vy,$vy,$perp
        fma     $perp,$vz,$vz,$perp                     # squared
        frsqest $t_y,$perp
        fi      $t_y,$perp,$t_y
        fm      $perp,$perp,$t_y
        fnms    $beside,$perp,$cosine,$beside
        cull_list NODE
        a       $3,$3,$found
        bi      $lr
endfunction cull_nodes
