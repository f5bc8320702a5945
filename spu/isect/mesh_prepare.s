# mesh_prepare   checks a block of a mesh, makes its positions relative to the eye, and adds the
#                numbers of boxes to the children of an inner block
#   C       int mesh_prepare(struct mesh_block *, int number, const vec_float4 *eye, int blocks,
#                            int materials, int sides);
#   In      $3 the block, as it is in main memory, $4 its number, $5 the eye: x, y, z, anything, $6
#           how many blocks there are, $7 how many materials, $8 the bits that `sides` may have;
#           pointers 16-aligned
#   Out     $3 0, or something else if the block is damaged. Then its positions may be anything.
#   Uses    $3-$8, $10-$74   Saves  -   Stack  0   Calls  -
#   Domain  any
#   Error   0: boxes hold what they held, with a slack of 2^-19 of the largest magnitude of their
#           coordinates or more
#   Twin    lab/twins/src/mesh_prepare.rs
#
# The checks make the traversal end and stay within the lists: the levels of nodes
# are complete, runs have triangles of the block, triangles have vertices of the block, they,
# spheres and cones have materials of the scene, and children come after their parents. A lane of a
# node without a child must have the box that no ray meets.
#
# All boxes of a block get the slack of its root, which holds the others.

        .include "work_unit.inc"
        .include "macros.inc"
        .include "mesh_block.inc"
        .include "extremes.inc"

        .set    NEXT,3
        registers a_block,number,a_eye,blocks,materials,sides
        .set    NEXT,10
        # constants
        registers eye_x,eye_y,eye_z,m_splat,k_sign,k_no_low,k_no_high,k_steps,k_least_one
        # the header
        registers header,counts,kind,levels,nodes,triangles,vertices
        # the nodes
        registers a_node                                # address
        registers below                                 # offset of the next child above the lowest
        registers of_objects,k_objects,k_last           # where these begin, the last from there
        registers a_level_end                           # where the current level ends
        registers a_end
        registers a_low,low                             # the lowest level's first node, and how many
        registers boxes,k_four                          # the numbers of the node's boxes, shifted
        registers child,absent,valid,wrong,expected,lengths,firsts
        registers lo_x,lo_y,lo_z,hi_x,hi_y,hi_z
        registers size,other,slack,c_greater
        registers bad                                   # not 0 in any lane: not as it should be
        registers t,left
        registers coordinates                           # SIDES_TEXTURED, or 0; then their bytes
        # vertices and faces
        registers a_vertex,a_again,vertex                     # to 62
        .set    NEXT,vertex+4
        registers moved                                 # to 66
        .set    NEXT,moved+4
        registers eye,m_xyz,face,limit
        # a sphere's or a cone's record: its bytes, its quadwords, and 512 by these
        registers of_spheres,k_size,k_quads,k_part

    .if CONE_SIZE != 1<<6
        .error  "a cone's record has another size than is multiplied by here"
    .endif

        .section .rodata.mesh,"a",@progbits
        .align  4
steps:  .int    0,BOXES_SIZE,2*BOXES_SIZE,3*BOXES_SIZE
first_boxes:
        .int    0<<CHILD_SHIFT,1<<CHILD_SHIFT,2<<CHILD_SHIFT,3<<CHILD_SHIFT

.macro  splat_axis out:req, axis:req
        load_constant $t,0x00010203+0x04040404*\axis
        shufb   \out,$eye,$eye,$t
.endm

function mesh_prepare
        il      $bad,0
        lqd     $header,MESH_HEADER_magic($a_block)
        lqd     $counts,MESH_HEADER_nodes($a_block)
        lqd     $eye,0($a_eye)
        load_constant $t,MESH_MAGIC
        xor     $wrong,$header,$t
        or      $bad,$bad,$wrong
        rotqbyi $t,$header,MESH_HEADER_number
        xor     $wrong,$t,$number
        or      $bad,$bad,$wrong
        rotqbyi $kind,$header,MESH_HEADER_kind
        clgti   $wrong,$kind,MESH_CONES
        or      $bad,$bad,$wrong
        rotqbyi $levels,$header,MESH_HEADER_levels
        ai      $t,$levels,-1
        clgti   $wrong,$t,MESH_LEVELS-1
        or      $bad,$bad,$wrong
        rotqbyi $nodes,$counts,MESH_HEADER_nodes&15
        ai      $t,$nodes,-1
        clgti   $wrong,$t,MESH_MAX_NODES-1
        or      $bad,$bad,$wrong
        rotqbyi $triangles,$counts,MESH_HEADER_triangles&15
        clgti   $wrong,$triangles,MESH_FACES
        or      $bad,$bad,$wrong
        rotqbyi $vertices,$counts,MESH_HEADER_vertices&15
        clgti   $wrong,$vertices,MESH_VERTICES
        or      $bad,$bad,$wrong
        rotqbyi $t,$counts,MESH_HEADER_sides&15
        ilhu    $coordinates,SIDES_TEXTURED>>16
        and     $coordinates,$coordinates,$t
        andc    $wrong,$t,$sides
        or      $bad,$bad,$wrong
        # An inner block has no triangles or objects, and only triangles have vertices.
        cgti    $of_objects,$kind,MESH_LEAF
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
        # The even pipe has more to do. From the next word, the vertices, come zeros.
        shlqbii $expected,$triangles,2
        shlqbii $wrong,$triangles,6                     # cones: a size of 2^6
        selb    $expected,$expected,$wrong,$of_objects
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
        fsmbi   $k_least_one,0xf000
        and     $bad,$bad,$k_least_one
        splat_mask $m_splat
        lqa     $k_steps,steps
        il      $below,MESH_HEADER_SIZE+BOXES_SIZE
        ai      $a_low,$a_block,MESH_HEADER_SIZE
        ai      $a_level_end,$a_low,BOXES_SIZE
        a       $a_end,$a_end,$a_low
        ori     $a_node,$a_low,0
        ori     $low,$nodes,0
        brnz    $bad,damaged
next_level:
        ai      $levels,$levels,-1
        brz     $levels,lowest
        # The nodes below follow one another.
upper:  lqd     $child,BOXES_child($a_low)
        splat   $expected,$below,$m_splat
        ceqi    $absent,$child,0
        xori    $valid,$absent,-1
        a       $expected,$expected,$k_steps
        ceq     $expected,$expected,$child
        rotqmbyi $t,$valid,-4
        or      $t,$t,$k_least_one                      # lanes that may have a child
        and     $t,$t,$expected
        andc    $wrong,$valid,$t
        andc    $t,$k_least_one,$valid
        or      $wrong,$wrong,$t
        or      $bad,$bad,$wrong
        gb      $t,$valid
        cntb    $t,$t
        mpyi    $t,$t,BOXES_SIZE
        a       $below,$below,$t
        ai      $low,$low,-1
        ai      $a_low,$a_low,BOXES_SIZE
        ceq     $t,$a_low,$a_level_end
        brz     $t,upper
        a       $a_level_end,$a_block,$below
        cgt     $t,$a_level_end,$a_end
        brz     $t,next_level
damaged:
        il      $3,-1
        bi      $lr

lowest: ceq     $t,$a_level_end,$a_end                  # all levels are there, and nothing but these
        brz     $t,damaged
        # The root's largest magnitude, of lanes with a child.
        splat_axis $eye_x,0
        splat_axis $eye_y,1
        splat_axis $eye_z,2
        ilhu    $k_sign,0x8000
        ilhu    $k_no_low,NO_BOX>>16
        ilhu    $k_no_high,0x8000|NO_BOX>>16
        lqd     $child,BOXES_child($a_node)
        il      $size,0
    .irp axis, x,y,z
        lqd     $lo_\axis,BOXES_lo_\axis($a_node)
        lqd     $hi_\axis,BOXES_hi_\axis($a_node)
        fs      $lo_\axis,$lo_\axis,$eye_\axis
        fs      $hi_\axis,$hi_\axis,$eye_\axis
        andc    $lo_\axis,$lo_\axis,$k_sign
        andc    $hi_\axis,$hi_\axis,$k_sign
        maximum $size,$lo_\axis,$c_greater
        maximum $size,$hi_\axis,$c_greater
    .endr
        ceqi    $absent,$child,0
        andc    $size,$size,$absent
        rotqbyi $other,$size,8
        maximum $size,$other,$c_greater
        rotqbyi $other,$size,4
        maximum $size,$other,$c_greater
        ilhu    $slack,0x3600                           # 2^-19
        fm      $slack,$size,$slack
        ori     $left,$nodes,0
next_boxes:
        lqd     $child,BOXES_child($a_node)
    .irp axis, x,y,z
        lqd     $lo_\axis,BOXES_lo_\axis($a_node)
        lqd     $hi_\axis,BOXES_hi_\axis($a_node)
    .endr
        ceqi    $absent,$child,0
        ceq     $wrong,$lo_x,$k_no_low
        ceq     $t,$hi_x,$k_no_high
        and     $wrong,$wrong,$t
        andc    $wrong,$absent,$wrong
        or      $bad,$bad,$wrong
    .irp axis, x,y,z
        fs      $lo_\axis,$lo_\axis,$eye_\axis
        fs      $lo_\axis,$lo_\axis,$slack
        stqd    $lo_\axis,BOXES_lo_\axis($a_node)
        fs      $hi_\axis,$hi_\axis,$eye_\axis
        fa      $hi_\axis,$hi_\axis,$slack
        stqd    $hi_\axis,BOXES_hi_\axis($a_node)
    .endr
        ai      $a_node,$a_node,BOXES_SIZE
        ai      $left,$left,-1
        brnz    $left,next_boxes
        fsmbi   $m_xyz,0xfff0
        ai      $limit,$materials,-1
        ori     $a_vertex,$a_end,0
        splat   $triangles,$triangles,$m_splat
        brnz    $of_objects,objects
        brnz    $kind,blocks_below

        # The runs of triangles.
next_runs:
        lqd     $child,BOXES_child($a_low)
        ceqi    $absent,$child,0
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
        andc    $wrong,$wrong,$absent
        or      $bad,$bad,$wrong
        ai      $a_low,$a_low,BOXES_SIZE
        ai      $low,$low,-1
        brnz    $low,next_runs
        # The vertices, four at a time, after the few that are left over.
        andi    $left,$vertices,3
        brz     $left,by_fours
        sfi     $left,$left,0                           # counts up: not worth a pipeline
next_vertex:
        lqd     $vertex,0($a_vertex)
        fs      $moved,$vertex,$eye
        selb    $vertex,$vertex,$moved,$m_xyz
        stqd    $vertex,0($a_vertex)
        ai      $a_vertex,$a_vertex,MESH_VERTEX_SIZE
        ai      $left,$left,1
        brnz    $left,next_vertex
by_fours:
        ori     $a_again,$a_vertex,0
        rotmi   $left,$vertices,-2
        brz     $left,faces
next_four:
    .irp place, 0,1,2,3
        lqd     $vertex+\place,MESH_VERTEX_SIZE*\place($a_vertex)
        fs      $moved+\place,$vertex+\place,$eye
        selb    $vertex+\place,$vertex+\place,$moved+\place,$m_xyz
        stqd    $vertex+\place,MESH_VERTEX_SIZE*\place($a_again)
    .endr
        ai      $a_vertex,$a_vertex,4*MESH_VERTEX_SIZE
        ai      $a_again,$a_again,4*MESH_VERTEX_SIZE
        ai      $left,$left,-1
        brnz    $left,next_four                 # one pass: the memory for this code is full
        # No index is above the largest one.
faces:  ai      $vertices,$vertices,-1
        load_constant $t,0x03030313
        shufb   $limit,$vertices,$limit,$t
        orx     $bad,$bad
        ai      $left,$triangles,3
        rotmi   $left,$left,-2
        andi    $t,$left,1
        rotmi   $left,$left,-1
        brz     $t,in_pairs
        lqd     $face,0($a_vertex)
        clgtb   $face,$face,$limit
        or      $bad,$bad,$face
        ai      $a_vertex,$a_vertex,4*MESH_FACE_SIZE
in_pairs:
        brz     $left,checked
next_faces:
        lqd     $face,0($a_vertex)
        clgtb   $face,$face,$limit
        or      $bad,$bad,$face
        lqd     $vertex,4*MESH_FACE_SIZE($a_vertex)
        clgtb   $vertex,$vertex,$limit
        or      $bad,$bad,$vertex
        ai      $a_vertex,$a_vertex,2*4*MESH_FACE_SIZE
        ai      $left,$left,-1
        brnz    $left,next_faces
checked:
        orx     $3,$bad
        bi      $lr

        # The numbers of blocks.
blocks_below:
        splat   $number,$number,$m_splat
        splat   $blocks,$blocks,$m_splat
        lqa     $boxes,first_boxes
        ilhu    $k_four,4<<(CHILD_SHIFT-16)
next_blocks:
        lqd     $child,BOXES_child($a_low)
        ceqi    $absent,$child,0
        clgt    $t,$child,$number
        clgt    $wrong,$blocks,$child
        nand    $wrong,$wrong,$t
        andc    $wrong,$wrong,$absent
        or      $bad,$bad,$wrong
        or      $child,$child,$boxes
        stqd    $child,BOXES_child($a_low)
        a       $boxes,$boxes,$k_four
        ai      $a_low,$a_low,BOXES_SIZE
        ai      $low,$low,-1
        brnz    $low,next_blocks
        orx     $3,$bad
        bi      $lr

        # The offsets of spheres or cones: multiples of their size from the first one on. A size in
        # quadwords is 3 or 4, and a part of it is times 512.
objects:
        sf      $k_objects,$a_block,$a_end
        splat   $k_objects,$k_objects,$m_splat
        splat   $of_spheres,$of_spheres,$m_splat
        il      $k_size,CONE_SIZE
        il      $t,OBJECT_SIZE
        selb    $k_size,$k_size,$t,$of_spheres
        mpy     $k_last,$triangles,$k_size
        sf      $k_last,$k_size,$k_last
        il      $k_part,512/4
        il      $t,512/3+1
        selb    $k_part,$k_part,$t,$of_spheres
        rotmi   $k_quads,$k_size,-4
        ori     $left,$triangles,0
        ori     $a_again,$a_vertex,0
next_lanes:
        lqd     $child,BOXES_child($a_low)
        ceqi    $absent,$child,0
        sf      $t,$k_objects,$child
        clgt    $wrong,$t,$k_last
        andi    $firsts,$t,15
        or      $wrong,$wrong,$firsts
        rotmi   $t,$t,-4
        mpyu    $firsts,$t,$k_part
        rotmi   $firsts,$firsts,-9
        mpyu    $firsts,$firsts,$k_quads
        ceq     $firsts,$firsts,$t
        orc     $wrong,$wrong,$firsts
        andc    $wrong,$wrong,$absent
        or      $bad,$bad,$wrong
        ai      $a_low,$a_low,BOXES_SIZE
        ai      $low,$low,-1
        brnz    $low,next_lanes
        orx     $bad,$bad
next_object:
        lqd     $vertex,OBJECT_centre($a_vertex)
        lqd     $face,OBJECT_material&~15($a_vertex)
        fs      $moved,$vertex,$eye
        rotqbyi $face,$face,OBJECT_material&15
        selb    $moved,$vertex,$moved,$m_xyz
        clgt    $face,$face,$limit
        stqd    $moved,OBJECT_centre($a_again)
        or      $bad,$bad,$face
        a       $a_vertex,$a_vertex,$k_size
        a       $a_again,$a_again,$k_size
        ai      $left,$left,-1
        brnz    $left,next_object
        and     $bad,$bad,$k_least_one
        orx     $3,$bad
        bi      $lr
endfunction mesh_prepare
