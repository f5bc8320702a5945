# build_leaf   makes the boxes of a leaf block around new vertices
#   C       void build_leaf(struct mesh_block *, struct build_bounds *, void *memory);
#   In      $3 the block with its new vertices, $4 where its bounds go, $5 4,704 bytes for
#           intermediate results; pointers 16-aligned
#   Out     the block's boxes, the bounds, and normals of 0 without SIDES_SMOOTH
#   Uses    $3-$5, $10-$77   Saves  -   Stack  0   Calls  -
#   Domain  a header with 1 to 18 nodes and at least one triangle, whose arrays are within the
#           block; whatever else the block has, nothing else is written. Coordinates up to 2^62
#           have no sign of 0 and no denormals: of equal ones the block may have either.
#   Error   0: boxes hold exactly the vertices of their triangles
#   Twin    lab/twins/src/build.rs
#
# First each triangle gets a box. Then, from the last node to the root, a run's box holds those of
# its triangles, eight steps for four runs at a time: the steps beyond the end of a run repeat its
# last triangle, so there is no branch. Lanes without a child take the box that is not there, which
# changes no other. The root of two levels takes the boxes of the nodes below it, which follow it.

        .include "work_unit.inc"
        .include "macros.inc"
        .include "mesh_block.inc"
        .include "transpose.inc"
        .include "extremes.inc"

        .set    BOX_SIZE,32
        .set    BOX_SIZE_LOG2,5
        .set    NO_BOX_AT,(MESH_FACES+1)*BOX_SIZE
        .set    NODES_AT,NO_BOX_AT+BOX_SIZE

        .set    NEXT,3
        registers a_block,a_bounds,a_boxes
        .set    NEXT,10
        # constants
        registers m_first,m_last,m_splat,k_halves,k_steps
        registers m_corner                              # to 17: of a face's corners by four faces
        .set    NEXT,m_corner+3
        # the header
        registers header,nodes,levels,triangles,vertices,sides
        # the triangles
        registers a_vertices,a_face,a_box,left,faces
        registers corner                                # to 31: offsets of four faces' corners
        .set    NEXT,corner+3
        registers vertex                                # to 34
        .set    NEXT,vertex+3
        registers low,high,c_greater,offset
        # the nodes
        registers a_node,a_around,node,upper,child,absent,lengths,last,at,step
        registers lo                                    # to 52: by children, then by axes
        .set    NEXT,lo+4
        registers hi                                    # to 56
        .set    NEXT,hi+4
        registers t                                     # to 60
        .set    NEXT,t+4
        registers place                                 # to 64
        .set    NEXT,place+4
        registers more_low,more_high
        registers size_x,size_y,size_z,area,cost,around_low,around_high
        registers k_none,k_no_high,a_none,k_one

        transpose_table .rodata.build
corners:
    .irp of, 0,1,2
        .int    0x80808000+\of,0x80808004+\of,0x80808008+\of,0x8080800c+\of
    .endr
steps:  .int    0,BOX_SIZE,2*BOX_SIZE,3*BOX_SIZE

function build_leaf
        lqd     $header,MESH_HEADER_nodes($a_block)
        lqd     $levels,MESH_HEADER_levels&~15($a_block)
        lqa     $m_first,transpose_first
        lqa     $m_last,transpose_last
        lqa     $m_corner,corners
        lqa     $m_corner+1,corners+16
        lqa     $m_corner+2,corners+32
        lqa     $k_steps,steps
        splat_mask $m_splat
        ilhu    $k_halves,0xffff
        ilhu    $k_none,NO_BOX>>16
        ilhu    $k_no_high,0x8000|NO_BOX>>16
        ilhu    $k_one,0x3f80
        il      $cost,0
        stqd    $k_none,NO_BOX_AT($a_boxes)
        stqd    $k_no_high,NO_BOX_AT+16($a_boxes)
        ori     $nodes,$header,0
        rotqbyi $levels,$levels,MESH_HEADER_levels&15
        rotqbyi $triangles,$header,MESH_HEADER_triangles&15
        rotqbyi $vertices,$header,MESH_HEADER_vertices&15
        rotqbyi $sides,$header,MESH_HEADER_sides&15
        mpyi    $a_vertices,$nodes,BOXES_SIZE
        a       $a_vertices,$a_vertices,$a_block
        ai      $a_vertices,$a_vertices,MESH_HEADER_SIZE
        shli    $a_face,$vertices,4
        a       $a_face,$a_face,$a_vertices
        ilhu    $t,SIDES_SMOOTH>>16
        and     $t,$t,$sides
        brnz    $t,smooth
        # Flat triangles have no normals at their vertices.
        fsmbi   $t,0xfff0
        ori     $a_box,$a_vertices,0
next_normal:
        lqd     $vertex,0($a_box)
        and     $vertex,$vertex,$t
        stqd    $vertex,0($a_box)
        ai      $a_box,$a_box,MESH_VERTEX_SIZE
        ai      $vertices,$vertices,-1
        brnz    $vertices,next_normal
smooth:
        ori     $a_box,$a_boxes,0
        ai      $left,$triangles,3
        rotmi   $left,$left,-2
next_faces:
        lqd     $faces,0($a_face)
    .irp of, 0,1,2
        shufb   $corner+\of,$faces,$faces,$m_corner+\of
        shli    $corner+\of,$corner+\of,4
    .endr
    .irp face, 0,1,2,3
      .irp of, 0,1,2
        rotqbyi $offset,$corner+\of,4*\face
        lqx     $vertex+\of,$a_vertices,$offset
      .endr
        fcgt    $c_greater,$vertex,$vertex+1
        selb    $low,$vertex,$vertex+1,$c_greater
        selb    $high,$vertex+1,$vertex,$c_greater
        minimum_f4 $low,$vertex+2,$c_greater
        maximum $high,$vertex+2,$c_greater
        stqd    $low,BOX_SIZE*\face($a_box)
        stqd    $high,BOX_SIZE*\face+16($a_box)
    .endr
        ai      $a_face,$a_face,16
        ai      $a_box,$a_box,4*BOX_SIZE
        ai      $left,$left,-1
        brnz    $left,next_faces

        ori     $node,$nodes,0
        mpyi    $a_node,$nodes,BOXES_SIZE
        a       $a_node,$a_node,$a_block
        ai      $a_node,$a_node,MESH_HEADER_SIZE-BOXES_SIZE
        il      $a_around,NODES_AT
        a       $a_around,$a_around,$a_boxes
        shli    $t,$nodes,BOX_SIZE_LOG2
        a       $a_around,$a_around,$t
        ai      $a_around,$a_around,-BOX_SIZE
        il      $a_none,NO_BOX_AT
        a       $a_none,$a_none,$a_boxes
        splat   $a_none,$a_none,$m_splat
        splat   $a_boxes,$a_boxes,$m_splat
next_node:
        lqd     $child,BOXES_child($a_node)
        ai      $node,$node,-1
        ceqi    $absent,$child,0
        # The root of more than one level.
        ceqi    $upper,$node,0
        cgti    $t,$levels,1
        and     $upper,$upper,$t
        brnz    $upper,root
        rotmi   $lengths,$child,-16
        andc    $at,$child,$k_halves
        shli    $at,$at,BOX_SIZE_LOG2-2
        a       $at,$at,$a_boxes
        ai      $last,$lengths,-1
        shli    $last,$last,BOX_SIZE_LOG2
        andc    $last,$last,$absent
        csflt   $lengths,$lengths,0
        selb    $at,$at,$a_none,$absent
    .irp lane, 0,1,2,3
        rotqbyi $place,$at,4*\lane
        lqd     $lo+\lane,0($place)
        lqd     $hi+\lane,16($place)
    .endr
        il      $step,0
    .rept   MESH_RUN-1
        ai      $step,$step,BOX_SIZE
        minimum $t,$step,$last,$c_greater
        a       $t,$t,$at
      .irp lane, 0,1,2,3
        rotqbyi $place+\lane,$t,4*\lane
        lqd     $more_low,0($place+\lane)
        lqd     $more_high,16($place+\lane)
        minimum_f4 $lo+\lane,$more_low,$c_greater
        maximum $hi+\lane,$more_high,$c_greater
      .endr
    .endr
boxes:
        ori     $around_low,$lo,0
        ori     $around_high,$hi,0
    .irp lane, 1,2,3
        minimum_f4 $around_low,$lo+\lane,$c_greater
        maximum $around_high,$hi+\lane,$c_greater
    .endr
        stqd    $around_low,0($a_around)
        stqd    $around_high,16($a_around)
        ai      $a_around,$a_around,-BOX_SIZE
        transpose lo,lo,t,$m_first,$m_last
        transpose hi,hi,t,$m_first,$m_last
    .irp axis, 0,1,2
        stqd    $lo+\axis,BOXES_lo_x+16*\axis($a_node)
        stqd    $hi+\axis,BOXES_hi_x+16*\axis($a_node)
    .endr
        fs      $size_x,$hi,$lo
        fs      $size_y,$hi+1,$lo+1
        fs      $size_z,$hi+2,$lo+2
        fm      $area,$size_x,$size_y
        fma     $area,$size_y,$size_z,$area
        fma     $area,$size_z,$size_x,$area
        fm      $area,$area,$lengths
        andc    $area,$area,$absent
        fa      $cost,$cost,$area
        ai      $a_node,$a_node,-BOXES_SIZE
        brnz    $node,next_node

        rotqbyi $t,$cost,8
        fa      $cost,$cost,$t
        rotqbyi $t,$cost,4
        fa      $cost,$cost,$t
        fsmbi   $t,0x000f
        selb    $around_low,$around_low,$cost,$t
        andc    $around_high,$around_high,$t
        stqd    $around_low,0($a_bounds)
        stqd    $around_high,16($a_bounds)
        bi      $lr

root:   splat   $t,$a_around,$m_splat
        ai      $t,$t,BOX_SIZE
        a       $t,$t,$k_steps
        selb    $at,$t,$a_none,$absent
    .irp lane, 0,1,2,3
        rotqbyi $place,$at,4*\lane
        lqd     $lo+\lane,0($place)
        lqd     $hi+\lane,16($place)
    .endr
        ori     $lengths,$k_one,0
        br      boxes
endfunction build_leaf
