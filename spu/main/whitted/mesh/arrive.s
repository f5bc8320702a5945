# What is done with a block of the mesh when it has arrived in local store.

        .include "work_unit.inc"
        .include "macros.inc"
        .include "driver.inc"
        .include "extremes.inc"
        .include "whitted.inc"
        .include "mesh.inc"

        .set    NEXT,3
        registers a_block,number
        .set    NEXT,10
        # constants
        registers eye_x,eye_y,eye_z,m_splat,k_sign,k_slack,k_none,k_steps,k_first,k_least_one
        # the header
        registers header,counts,kind,levels,nodes,triangles,vertices,blocks
        # the nodes
        registers a_node                                # address
        registers below                                 # offset of the next child above the lowest
        registers a_children                              # the code for the node's children
        registers of_spheres,k_objects,k_last           # where spheres begin, and the last one from there
        registers a_level_end                           # where the current level ends
        registers a_end
        registers boxes                                 # the numbers of the node's boxes, shifted
        registers child,valid,wrong,expected,lengths,firsts,words
        registers lo_x,lo_y,lo_z,hi_x,hi_y,hi_z
        registers slack
        registers bad                                   # not 0 in any lane: not as it should be
        registers t
        registers coordinates                           # SIDES_TEXTURED, or 0; then their bytes
        # vertices and faces
        registers a_vertex,left,vertex                  # to 62
        .set    NEXT,vertex+4
        registers moved                                 # to 66
        .set    NEXT,moved+4
        registers eye,m_xyz,face,limit
        .set    a_face,a_vertex
        # Temporaries of a node, where the vertices come afterwards.
        .set    largest_x,vertex
        .set    largest_y,vertex+1
        .set    largest_z,vertex+2
        .set    magnitude_x,moved
        .set    magnitude_y,moved+1
        .set    magnitude_z,moved+2
        .set    greater_x,vertex+3
        .set    greater_y,moved+3
        .set    greater_z,face

        .section .rodata.mesh,"a",@progbits
        .align  4
steps:  .int    0,BOXES_SIZE,2*BOXES_SIZE,3*BOXES_SIZE
first_boxes:
        .int    0<<CHILD_SHIFT,1<<CHILD_SHIFT,2<<CHILD_SHIFT,3<<CHILD_SHIFT
eye_axes:
        .int    0x00010203,0x00010203,0x00010203,0x00010203
        .int    0x04050607,0x04050607,0x04050607,0x04050607
        .int    0x08090a0b,0x08090a0b,0x08090a0b,0x08090a0b

# Stores the node's box, and goes to the next node by the branch `next`.
.macro  node_done next:req
        or      $bad,$bad,$wrong
    .irp axis, x,y,z
        fs      $lo_\axis,$lo_\axis,$slack
        fa      $hi_\axis,$hi_\axis,$slack
    .endr
    .irp axis, x,y,z
        stqd    $lo_\axis,BOXES_lo_\axis($a_node)
        stqd    $hi_\axis,BOXES_hi_\axis($a_node)
    .endr
        ai      $a_node,$a_node,BOXES_SIZE
        ceq     $t,$a_node,$a_level_end
        brnz    $t,level_done
\next: br      next_node
.endm

# mesh_arrive   checks a block, makes its positions relative to the eye, and adds the numbers of
#               boxes to the children of an inner block; gives up if the block is damaged
#   In      $3 address, $4 number
#   Uses    $3, $10-$70
#
# What is checked is what makes the traversal end and stay within the lists: the levels of nodes are
# complete, runs have triangles of the block, triangles have vertices of the block, they and spheres
# have materials of the scene, and children come after their parents. A lane of a node without a
# child must have the box that no ray meets.
function mesh_arrive
        il      $bad,0
        lqd     $header,MESH_HEADER_magic($a_block)
        lqd     $counts,MESH_HEADER_nodes($a_block)
        load_constant $t,MESH_MAGIC
        xor     $wrong,$header,$t
        or      $bad,$bad,$wrong
        rotqbyi $t,$header,MESH_HEADER_number
        xor     $wrong,$t,$number
        or      $bad,$bad,$wrong
        rotqbyi $kind,$header,MESH_HEADER_kind
        clgti   $wrong,$kind,MESH_SPHERES
        or      $bad,$bad,$wrong
        rotqbyi $levels,$header,MESH_HEADER_levels
        ai      $t,$levels,-1
        clgti   $wrong,$t,MESH_LEVELS-1
        or      $bad,$bad,$wrong
        ori     $nodes,$counts,0
        ai      $t,$nodes,-1
        clgti   $wrong,$t,MESH_MOST_NODES-1
        or      $bad,$bad,$wrong
        rotqbyi $triangles,$counts,MESH_HEADER_triangles&15
        clgti   $wrong,$triangles,MESH_FACES
        or      $bad,$bad,$wrong
        rotqbyi $vertices,$counts,MESH_HEADER_vertices&15
        clgti   $wrong,$vertices,MESH_VERTICES
        or      $bad,$bad,$wrong
        rotqbyi $t,$counts,MESH_HEADER_sides&15
        lqa     $wrong,sides_known
        ilhu    $coordinates,SIDES_TEXTURED>>16
        and     $coordinates,$coordinates,$t
        andc    $wrong,$t,$wrong
        or      $bad,$bad,$wrong
        # An inner block has no triangles or spheres, and only triangles have vertices.
        ceqi    $of_spheres,$kind,MESH_SPHERES
        ceqi    $wrong,$kind,MESH_LEAF
        ceqi    $t,$vertices,0
        ceq     $wrong,$wrong,$t
        or      $bad,$bad,$wrong
        ceqi    $kind,$kind,MESH_INNER
        ceqi    $t,$triangles,0
        xor     $wrong,$t,$kind
        or      $bad,$bad,$wrong
        mpyi    $a_end,$nodes,BOXES_SIZE
        shli    $t,$vertices,4
        a       $t,$t,$a_end
        shli    $expected,$triangles,2
        mpyi    $wrong,$triangles,OBJECT_SIZE
        selb    $wrong,$expected,$wrong,$of_spheres
        a       $t,$t,$wrong
        # Texture coordinates begin at the next quadword.
        ai      $t,$t,15
        andi    $t,$t,-16
        cgti    $coordinates,$coordinates,0
        shli    $wrong,$vertices,3
        and     $wrong,$wrong,$coordinates
        a       $t,$t,$wrong
        il      $wrong,MESH_BLOCK-MESH_HEADER_SIZE
        cgt     $wrong,$t,$wrong
        or      $bad,$bad,$wrong
        # The other words were not compared.
        fsmbi   $t,0xf000
        and     $bad,$bad,$t
        brnz    $bad,bad_block

        splat_mask $m_splat
        lqa     $eye,frame+FRAME_mesh_eye
        lqa     $t,eye_axes
        shufb   $eye_x,$eye,$eye,$t
        lqa     $t,eye_axes+16
        shufb   $eye_y,$eye,$eye,$t
        lqa     $t,eye_axes+32
        shufb   $eye_z,$eye,$eye,$t
        ilhu    $k_sign,0x8000
        ilhu    $k_slack,0x3600                         # 2^-19
        ilhu    $k_none,NO_BOX>>16
        lqa     $k_steps,steps
        lqa     $boxes,first_boxes
        ilhu    $k_first,4<<(CHILD_SHIFT-16)
        fsmbi   $k_least_one,0xf000
        splat   $kind,$kind,$m_splat
        splat   $number,$number,$m_splat
        splat   $triangles,$triangles,$m_splat
        ila     $blocks,frame
        load_word $blocks,FRAME_mesh_blocks,$blocks
        splat   $blocks,$blocks,$m_splat
        ai      $t,$a_end,MESH_HEADER_SIZE
        splat   $k_objects,$t,$m_splat
        mpyi    $t,$triangles,OBJECT_SIZE
        il      $k_last,-OBJECT_SIZE
        a       $k_last,$k_last,$t
        splat   $of_spheres,$of_spheres,$m_splat
        il      $below,MESH_HEADER_SIZE+BOXES_SIZE
        ai      $a_node,$a_block,MESH_HEADER_SIZE
        ai      $a_level_end,$a_node,BOXES_SIZE
        a       $a_end,$a_end,$a_node
next_level:
        # The nodes of a level all have the same kind of children.
        ila     $a_children,of_triangles
        ila     $wrong,sphere_lanes
        selb    $a_children,$a_children,$wrong,$of_spheres
        ila     $wrong,of_inner
        selb    $a_children,$a_children,$wrong,$kind
        ila     $wrong,upper
        cgti    $t,$levels,1
        selb    $a_children,$a_children,$wrong,$t
next_node:
        hbr     by_kind,$a_children
        lqd     $child,BOXES_child($a_node)
    .irp axis, x,y,z
        lqd     $lo_\axis,BOXES_lo_\axis($a_node)
        lqd     $hi_\axis,BOXES_hi_\axis($a_node)
    .endr
        # The box relative to the eye. A lane without a child must have no box.
        ceqi    $valid,$child,0
        ceq     $wrong,$lo_x,$k_none
        xor     $t,$hi_x,$k_sign
        fs      $lo_x,$lo_x,$eye_x
        ceq     $t,$t,$k_none
        fs      $hi_x,$hi_x,$eye_x
        and     $wrong,$wrong,$t
        fs      $lo_y,$lo_y,$eye_y
        andc    $wrong,$valid,$wrong
        fs      $hi_y,$hi_y,$eye_y
        or      $bad,$bad,$wrong
        fs      $lo_z,$lo_z,$eye_z
        xori    $valid,$valid,-1
        fs      $hi_z,$hi_z,$eye_z
        # It becomes larger by the rounding of that and of its test.
    .irp axis, x,y,z
        andc    $largest_\axis,$lo_\axis,$k_sign
        andc    $magnitude_\axis,$hi_\axis,$k_sign
    .endr
    .irp axis, x,y,z
        fcgt    $greater_\axis,$magnitude_\axis,$largest_\axis
    .endr
    .irp axis, x,y,z
        selb    $largest_\axis,$largest_\axis,$magnitude_\axis,$greater_\axis
    .endr
        maximum $largest_x,$largest_y,$greater_x
        maximum $largest_x,$largest_z,$greater_x
        fm      $slack,$largest_x,$k_slack
by_kind:
        bi      $a_children

        # The numbers of blocks.
of_inner:
        hbrr    inner_done,next_node
        clgt    $t,$child,$number
        clgt    $wrong,$blocks,$child
        and     $wrong,$wrong,$t
        andc    $wrong,$valid,$wrong
        or      $child,$child,$boxes
        stqd    $child,BOXES_child($a_node)
        a       $boxes,$boxes,$k_first
        node_done inner_done

        # The nodes below, which follow one another.
upper:  hbrr    upper_done,next_node
        splat   $expected,$below,$m_splat
        a       $expected,$expected,$k_steps
        ceq     $expected,$expected,$child
        rotqmbyi $t,$valid,-4
        or      $t,$t,$k_least_one                      # lanes that may have a child
        and     $t,$t,$expected
        andc    $wrong,$valid,$t
        andc    $t,$k_least_one,$valid
        or      $wrong,$wrong,$t
        gb      $t,$valid
        cntb    $t,$t
        mpyi    $t,$t,BOXES_SIZE
        a       $below,$below,$t
        node_done upper_done

        # The offsets of spheres: multiples of their size from the first one on.
sphere_lanes:
        hbrr    spheres_done,next_node
        sf      $t,$k_objects,$child
        clgt    $wrong,$t,$k_last
        andi    $firsts,$t,15
        or      $wrong,$wrong,$firsts
        rotmi   $t,$t,-4
        mpyui   $firsts,$t,171                          # a third of it, times 512
        rotmi   $firsts,$firsts,-9
        mpyui   $firsts,$firsts,OBJECT_SIZE/16
        ceq     $firsts,$firsts,$t
        orc     $wrong,$wrong,$firsts
        and     $wrong,$wrong,$valid
        node_done spheres_done

        # The runs of triangles.
of_triangles:
        hbrr    leaf_done,next_node
        rotmi   $lengths,$child,-16
        ilhu    $t,0xffff
        andc    $firsts,$child,$t
        rotmi   $firsts,$firsts,-2
        andi    $wrong,$child,3
        ai      $t,$lengths,-1
        clgti   $t,$t,MESH_RUN-1
        or      $wrong,$wrong,$t
        a       $t,$firsts,$lengths
        clgt    $t,$t,$triangles
        or      $wrong,$wrong,$t
        and     $wrong,$wrong,$valid
        node_done leaf_done

level_done:
        ai      $levels,$levels,-1
        a       $a_level_end,$a_block,$below
        cgt     $t,$a_level_end,$a_end
        brnz    $t,bad_block
        brnz    $levels,next_level
        # All levels are there, and nothing but these.
        ceq     $t,$a_node,$a_end
        brz     $t,bad_block
        orx     $bad,$bad
        brnz    $bad,bad_block

        # The vertices, four at a time, after the few that are left over.
        ori     $a_vertex,$a_end,0
        fsmbi   $m_xyz,0xfff0
        ila     $limit,frame
        load_word $limit,FRAME_mesh_material_count,$limit
        ai      $limit,$limit,-1
        brnz    $of_spheres,objects
        andi    $left,$vertices,3
        brz     $left,by_fours
next_vertex:
        lqd     $vertex,0($a_vertex)
        fs      $moved,$vertex,$eye
        selb    $vertex,$vertex,$moved,$m_xyz
        stqd    $vertex,0($a_vertex)
        ai      $a_vertex,$a_vertex,MESH_VERTEX_SIZE
        ai      $left,$left,-1
        brnz    $left,next_vertex
by_fours:
        rotmi   $left,$vertices,-2
        brz     $left,faces
next_four:
        hbrr    last_four,next_four
    .irp place, 0,1,2,3
        lqd     $vertex+\place,MESH_VERTEX_SIZE*\place($a_vertex)
    .endr
    .irp place, 0,1,2,3
        fs      $moved+\place,$vertex+\place,$eye
    .endr
        ai      $left,$left,-1
    .irp place, 0,1,2,3
        selb    $vertex+\place,$vertex+\place,$moved+\place,$m_xyz
        stqd    $vertex+\place,MESH_VERTEX_SIZE*\place($a_vertex)
    .endr
        ai      $a_vertex,$a_vertex,4*MESH_VERTEX_SIZE
last_four:
        brnz    $left,next_four

        # No index is above the largest one.
faces:  biz     $triangles,$lr
        ai      $vertices,$vertices,-1
        load_constant $t,0x03030313
        shufb   $limit,$vertices,$limit,$t
        ai      $left,$triangles,3
        rotmi   $left,$left,-2
        il      $bad,0
        andi    $t,$left,1
        rotmi   $left,$left,-1
        brz     $t,next_faces
        lqd     $face,0($a_face)
        clgtb   $bad,$face,$limit
        ai      $a_face,$a_face,4*MESH_FACE_SIZE
        brz     $left,faces_done
next_faces:
        hbrr    last_faces,next_faces
        lqd     $face,0($a_face)
        lqd     $vertex,4*MESH_FACE_SIZE($a_face)
        ai      $a_face,$a_face,2*4*MESH_FACE_SIZE
        ai      $left,$left,-1
        clgtb   $face,$face,$limit
        clgtb   $vertex,$vertex,$limit
        or      $bad,$bad,$face
        or      $bad,$bad,$vertex
last_faces:
        brnz    $left,next_faces
faces_done:
        orx     $bad,$bad
        biz     $bad,$lr
bad_block:
        shli    $3,$number,8
        ori     $3,$3,STATUS_MeshBlock
        br      give_up

        # The centres of spheres. The next one is loaded while one is moved; behind the last one
        # that is whatever comes after the block.
objects:
        lqd     $vertex,OBJECT_centre($a_vertex)
next_object:
        hbrr    last_object,next_object
        lqd     $face,OBJECT_material&~15($a_vertex)
        fs      $moved,$vertex,$eye
        lqd     $vertex+1,OBJECT_centre+OBJECT_SIZE($a_vertex)
        ai      $triangles,$triangles,-1
        rotqbyi $face,$face,OBJECT_material&15
        selb    $moved,$vertex,$moved,$m_xyz
        clgt    $face,$face,$limit
        stqd    $moved,OBJECT_centre($a_vertex)
        ai      $a_vertex,$a_vertex,OBJECT_SIZE
        ori     $vertex,$vertex+1,0
        or      $bad,$bad,$face
last_object:
        brnz    $triangles,next_object
        biz     $bad,$lr
        br      bad_block
endfunction mesh_arrive
