# paths_meet   which subtiles of a tile have rays that may have crossed one of some spheres
#   C       unsigned int paths_meet(const struct path *, int count, const struct node *, int nodes);
#   In      $3 PATHs, consecutive, $4 count (at least 8), $5 NODEs, consecutive, $6 nodes (at least
#           1); pointers 16-aligned
#   Out     $3 the subtiles' bits, as in PATH
#   Uses    $3-$4, $10-$46   Saves  -   Stack  0   Calls  -
#   Domain  as for cull_nodes
#   Error   0: no path that crosses a sphere is left out
#   Twin    lab/twins/src/paths.rs
#
# The test is that of cull_nodes, and one more: a sphere is out of reach, too, if its distance from
# the axis exceeds what the farthest ray has gone,
#   S + farthest - perp (1 - 2^-12)
# Of rays that are scattered over every direction this is all that is known. One loop runs over
# paths and nodes: two nested ones would drain and fill the pipeline for every path.

        .include "work_unit.inc"
        .include "macros.inc"

        .set    NEXT,3
        registers a_path,count,a_first,nodes
        # constants
        .set    NEXT,10
        registers m_x,m_y,m_z,m_w,k_near
        # state
        registers a_node,left,found
        # the path
        registers first,second,third
        registers apex_x,apex_y,apex_z,radius,axis_x,axis_y,axis_z,cosine,sine,farthest,subtiles
        # the spheres
        registers vx,vy,vz,reach,along,perp,t_y,beside,ahead,near,c_last

function paths_meet
        load_constant $m_x,0x00010203
        load_constant $m_y,0x04050607
        load_constant $m_z,0x08090a0b
        load_constant $m_w,0x0c0d0e0f
        load_constant $k_near,0x3f7ff000                # 1 - 2^-12
        ori     $a_node,$a_first,0
        ori     $left,$nodes,0
        il      $found,0
        mpyu    $count,$count,$nodes
next_node:
        lqd     $first,0($a_path)
        lqd     $second,16($a_path)
        lqd     $third,32($a_path)
        shufb   $apex_x,$first,$first,$m_x
        shufb   $apex_y,$first,$first,$m_y
        shufb   $apex_z,$first,$first,$m_z
        shufb   $radius,$first,$first,$m_w
        shufb   $axis_x,$second,$second,$m_x
        shufb   $axis_y,$second,$second,$m_y
        shufb   $axis_z,$second,$second,$m_z
        shufb   $cosine,$second,$second,$m_w
        shufb   $sine,$third,$third,$m_x
        shufb   $farthest,$third,$third,$m_y
        shufb   $subtiles,$third,$third,$m_z
        lqd     $vx,NODE_x($a_node)
        lqd     $vy,NODE_y($a_node)
        lqd     $vz,NODE_z($a_node)
        lqd     $reach,NODE_radius($a_node)
        fs      $vx,$vx,$apex_x
        fs      $vy,$vy,$apex_y
        fs      $vz,$vz,$apex_z
        fa      $reach,$reach,$radius
        fm      $along,$vx,$axis_x
        fma     $along,$vy,$axis_y,$along
        fma     $along,$vz,$axis_z,$along
        fnms    $vx,$along,$axis_x,$vx
        fnms    $vy,$along,$axis_y,$vy
        fnms    $vz,$along,$axis_z,$vz
        fm      $perp,$vx,$vx
        fma     $perp,$vy,$vy,$perp
        fma     $perp,$vz,$vz,$perp
        frsqest $t_y,$perp
        fi      $t_y,$perp,$t_y
        fm      $perp,$perp,$t_y
        fma     $beside,$along,$sine,$reach
        fnms    $beside,$perp,$cosine,$beside
        fa      $ahead,$reach,$along
        fa      $near,$reach,$farthest
        fnms    $perp,$perp,$k_near,$near
        fs      $near,$near,$along
        or      $beside,$beside,$ahead
        or      $near,$near,$perp
        or      $beside,$beside,$near
        rotmai  $beside,$beside,-31                     # all ones: the sphere is not met
        andc    $subtiles,$subtiles,$beside
        or      $found,$found,$subtiles
        # After the last node, the first one and the next path.
        ai      $left,$left,-1
        ceqi    $c_last,$left,0
        ai      $a_node,$a_node,NODE_SIZE
        selb    $a_node,$a_node,$a_first,$c_last
        selb    $left,$left,$nodes,$c_last
        andi    $c_last,$c_last,PATH_SIZE
        a       $a_path,$a_path,$c_last
        ai      $count,$count,-1
        brnz    $count,next_node                        # at least 8 passes
        orx     $3,$found
        bi      $lr
endfunction paths_meet
