# objects_boxes   makes the boxes of a leaf block of spheres or cones around its records
#   C       void objects_boxes(struct mesh_block *, struct build_bounds *, void *memory);
#   In      $3 the block with its records, as objects_pack divides it, $4 where its bounds go, $5
#           128 bytes for intermediate results; pointers 16-aligned
#   Out     the block's boxes, and the bounds, which cost 0
#   Uses    $3-$5, $10-$65   Saves  -   Stack  0   Calls  -
#   Domain  a header with 1 to 16 objects; whatever the records have, nothing else is written
#   Error   0: a box holds its sphere or its cone's rims but for the rounding of its corners, which
#           boxes are widened for when they are traced. A cone's is larger by less than a
#           fourteenth of the radius
#   Twin    lab/twins/src/objects.rs
#
# A disc across a cone's axis reaches as far along x as its radius times sqrt(1 - axis_x^2). The box
# needs no root: the smallest of five tangents to it is never below it. Each tangent is a little
# higher, by more than the rounding of the axis.
#
# The loops count up, so that they aren't pipelined: they have at most four passes.

        .include "work_unit.inc"
        .include "macros.inc"
        .include "mesh_block.inc"
        .include "transpose.inc"
        .include "extremes.inc"

        .set    NEXT,3
        registers a_block,a_bounds,a_around
        .set    NEXT,10
        registers m_first,m_last,k_none,k_no_high,k_sign,k_xyz
        registers kind,levels,nodes,left,a_node,a_object,a_to,child,absent,c_greater
        registers lo                                    # to 29: by axes, then by children
        .set    NEXT,lo+4
        registers hi                                    # to 33
        .set    NEXT,hi+4
        registers t                                     # to 37
        .set    NEXT,t+4
        registers base                                  # to 41, with the gain
        .set    NEXT,base+4
        registers axis                                  # to 45, with the slope
        .set    NEXT,axis+4
        registers radius                                # to 49: of a cone with growth and height
        .set    NEXT,radius+4
        registers top,zero,across,square,apex,other
        registers k_one,k_tangent                       # to 60: how high they begin
        .set    NEXT,k_tangent+5
        registers k_slope                               # to 65: how they rise
        .set    NEXT,k_slope+5

        transpose_table .rodata.objects

# Writes the boxes of a node and the box around them, and goes on to the next one, whose \size bytes
# of records follow.
.macro  put_boxes size:req
        lqd     $child,BOXES_child($a_node)
        ceqi    $absent,$child,0
    .irp axis, 0,1,2
        selb    $lo+\axis,$lo+\axis,$k_none,$absent
        selb    $hi+\axis,$hi+\axis,$k_no_high,$absent
        stqd    $lo+\axis,BOXES_lo_x+16*\axis($a_node)
        stqd    $hi+\axis,BOXES_hi_x+16*\axis($a_node)
    .endr
        il      $lo+3,0
        il      $hi+3,0
        transpose lo,lo,t,$m_first,$m_last
        transpose hi,hi,t,$m_first,$m_last
        around
        stqd    $lo,0($a_to)
        stqd    $hi,16($a_to)
        ai      $a_to,$a_to,32
        ai      $a_node,$a_node,BOXES_SIZE
        ai      $a_object,$a_object,\size
        ai      $left,$left,1
.endm

# Makes the box around four, in place of the first one.
.macro  around
    .irp lane, 1,2,3
        minimum_f4 $lo,$lo+\lane,$c_greater
        maximum $hi,$hi+\lane,$c_greater
    .endr
.endm

function objects_boxes
        lqa     $m_first,transpose_first
        lqa     $m_last,transpose_last
        ilhu    $k_none,NO_BOX>>16
        ilhu    $k_no_high,0x8000|NO_BOX>>16
        ilhu    $k_sign,0x8000
        fsmbi   $k_xyz,0xfff0
        load_word $kind,MESH_HEADER_kind,$a_block
        load_word $levels,MESH_HEADER_levels,$a_block
        load_word $nodes,MESH_HEADER_nodes,$a_block
        ai      $levels,$levels,-1
        sf      $left,$nodes,$levels                    # minus the nodes with records
        mpyi    $a_node,$levels,BOXES_SIZE
        a       $a_node,$a_node,$a_block
        ai      $a_node,$a_node,MESH_HEADER_SIZE
        mpyi    $a_object,$nodes,BOXES_SIZE
        a       $a_object,$a_object,$a_block
        ai      $a_object,$a_object,MESH_HEADER_SIZE
        ori     $a_to,$a_around,0
    .irp node, 0,1,2,3
        stqd    $k_none,32*\node($a_around)
        stqd    $k_no_high,32*\node+16($a_around)
    .endr
        ceqi    $kind,$kind,MESH_CONES
        brnz    $kind,cones
next_spheres:
    .irp of, 0,1,2,3
        lqd     $base+\of,OBJECT_SIZE*\of+OBJECT_centre($a_object)
        lqd     $radius+\of,OBJECT_SIZE*\of+OBJECT_offset($a_object)
    .endr
        transpose base,base,t,$m_first,$m_last
        shufb   $radius,$radius,$radius+2,$m_first
        shufb   $radius+1,$radius+1,$radius+3,$m_first
        shufb   $radius,$radius,$radius+1,$m_first
        andc    $radius,$radius,$k_sign
    .irp axis, 0,1,2
        fs      $lo+\axis,$base+\axis,$radius
        fa      $hi+\axis,$base+\axis,$radius
    .endr
        put_boxes 4*OBJECT_SIZE
        brnz    $left,next_spheres

root:
    .irp node, 0,1,2,3
        lqd     $lo+\node,32*\node($a_around)
        lqd     $hi+\node,32*\node+16($a_around)
    .endr
        brz     $levels,bounds
    .irp corner, lo,hi
        transpose base,\corner,t,$m_first,$m_last
      .irp axis, 0,1,2
        stqd    $base+\axis,MESH_HEADER_SIZE+BOXES_\corner\()_x+16*\axis($a_block)
      .endr
    .endr
bounds: around
        and     $lo,$lo,$k_xyz
        and     $hi,$hi,$k_xyz
        stqd    $lo,0($a_bounds)
        stqd    $hi,16($a_bounds)
        bi      $lr

cones:  ilhu    $k_one,0x3f80
    .irp tangent, 0,1,2,3,4
        ilhu    $k_tangent+\tangent,0x3f01-0x80*\tangent
        ilhu    $k_slope+\tangent,0x3f00+0x80*\tangent
    .endr
        il      $zero,0
next_cones:
    .irp of, 0,1,2,3
        lqd     $base+\of,CONE_SIZE*\of+OBJECT_centre($a_object)
        lqd     $axis+\of,CONE_SIZE*\of+OBJECT_axis($a_object)
        lqd     $radius+\of,CONE_SIZE*\of+CONE_radius($a_object)
    .endr
        transpose base,base,t,$m_first,$m_last
        transpose axis,axis,t,$m_first,$m_last
        transpose radius,radius,t,$m_first,$m_last
        fma     $top,$radius+1,$radius+2,$radius
        maximum $top,$zero,$c_greater
    .irp along, 0,1,2
        fnms    $square,$axis+\along,$axis+\along,$k_one
        fma     $across,$square,$k_slope,$k_tangent
      .irp tangent, 1,2,3,4
        fma     $other,$square,$k_slope+\tangent,$k_tangent+\tangent
        minimum_f4 $across,$other,$c_greater
      .endr
        fma     $apex,$axis+\along,$radius+2,$base+\along
        fnms    $lo+\along,$across,$radius,$base+\along
        fnms    $other,$across,$top,$apex
        minimum_f4 $lo+\along,$other,$c_greater
        fma     $hi+\along,$across,$radius,$base+\along
        fma     $other,$across,$top,$apex
        maximum $hi+\along,$other,$c_greater
    .endr
        put_boxes 4*CONE_SIZE
        brnz    $left,next_cones
        br      root
endfunction objects_boxes
