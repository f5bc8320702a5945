# mesh_prepare   checks a block of a mesh, makes its positions relative to the eye, and adds the
#                numbers of boxes to the children of an inner block
#   C       int mesh_prepare(struct mesh_block *, int number, const vec_float4 *eye, int blocks,
#                            int materials, int sides);
#   In      $3 the block, as it is in main memory, $4 its number, $5 the eye: x, y, z, anything, $6
#           how many blocks there are, $7 how many materials, $8 the bits that `sides` may have;
#           pointers 16-aligned
#   Out     $3 0, or something else if the block is damaged. Then its positions may be anything.
#   Uses    $2-$75, $79   Saves  -   Stack  0   Calls  -
#   Domain  any
#   Error   0: boxes hold what they held, with a slack of 2^-19 of the largest magnitude of their
#           coordinates or more
#   Twin    lab/twins/src/mesh_prepare.rs
#
# What is checked is what makes the traversal end and stay within the lists: the levels of nodes
# are complete, runs have triangles of the block, triangles have vertices of the block, they,
# spheres and cones have materials of the scene, and children come after their parents. A lane of a
# node without a child must have the box that no ray meets.
#
# All boxes of a block get the slack of its root, which holds the others.
# Scheduled by spu schedule from mesh_prepare.s

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
        .set wrong_2,2; .set wrong_3,5; .set wrong_4,9; .set t_2,10; .set t_3,11; .set t_4,9
        .set t_5,5; .set wrong_5,8; .set t_6,2; .set t_7,8; .set left_2,79; .set hi_y_2,5
        .set lo_x_2,2; .set a_node_2,9; .set hi_x_2,8; .set lo_z_2,5; .set hi_x_3,2; .set hi_z_2,8
        .set low_2,79; .set vertex_2,2; .set vertex1_2,3; .set vertex2_2,4; .set vertex3_2,5
        .set a_again_2,2; .set face_2,2; .set vertex_3,3; .set bad_2,4; .set child_2,2
        .set a_low_2,3; .set a_low_3,2; .set child_3,3; .set a_low_4,4; .set t_8,3; .set t_9,6
        .set absent_2,4; .set firsts_2,5; .set firsts_3,9; .set wrong_6,3; .set firsts_4,7
        .set wrong_7,6; .set absent_3,10; .set firsts_5,6; .set wrong_8,7; .set absent_4,8
        .set wrong_9,4; .set a_vertex_2,3; .set face_3,4; .set vertex_4,5; .set moved_2,4
        .set moved_3,5; .set a_again_3,6; .set vertex_5,7; .set hi_x_4,5; .set firsts_6,3
        ilhu    $t,0x4d45                               # 0e
        lqd     $header,0($a_block)                     # 0o
        il      $bad,0                                  # 1e
        lqd     $counts,16($a_block)                    # 1o
        iohl    $t,0x5348                               # 2e
        fsmbi   $k_least_one,0xf000                     # 2o
        ilhu    $coordinates,0x1000                     # 3e
        lqd     $eye,0($a_eye)                          # 3o
        il      $wrong,0x7e0                            # 4e
        lqa     $k_steps,steps                          # 4o
        ai      $a_low,$a_block,32                      # 5e
        lnop                                            # 5o pairing
        xor     $wrong_2,$header,$t                     # 6e
        rotqbyi $t,$header,4                            # 6o
        ila     $m_splat,0x10203                        # 7e
        rotqbyi $nodes,$counts,0                        # 7o
        or      $bad,$bad,$wrong_2                      # 8e
        rotqbyi $triangles,$counts,4                    # 8o
        il      $below,144                              # 9e
        rotqbyi $kind,$header,8                         # 9o
        xor     $wrong_2,$t,$number                     # 10e
        rotqbyi $levels,$header,12                      # 10o
        mpyi    $a_end,$nodes,112                       # 11e
        rotqbyi $vertices,$counts,8                     # 11o
        mpyi    $wrong_3,$triangles,48                  # 12e
        shlqbii $expected,$triangles,2                  # 12o
        or      $bad,$bad,$wrong_2                      # 13e
        shlqbii $wrong_2,$triangles,6                   # 13o cones: a size of 2^6
        clgti   $wrong_4,$kind,3                        # 14e
        rotqbyi $t,$counts,12                           # 14o
        ai      $t_2,$levels,-1                         # 15e
        or      $bad,$bad,$wrong_4                      # 16e
        clgti   $wrong_4,$t_2,2                         # 17e
        ai      $t_2,$nodes,-1                          # 18e
        cgti    $of_objects,$kind,1                     # 19e
        shli    $t_3,$vertices,4                        # 20e
        or      $bad,$bad,$wrong_4                      # 21e
        clgti   $wrong_4,$t_2,17                        # 22e
        ceqi    $of_spheres,$kind,2                     # 23e
        selb    $expected,$expected,$wrong_2,$of_objects # 24e
        or      $bad,$bad,$wrong_4                      # 25e
        clgti   $wrong_2,$triangles,127                 # 26e
        a       $t_4,$t_3,$a_end                        # 27e
        selb    $wrong_3,$expected,$wrong_3,$of_spheres # 28e
        or      $bad,$bad,$wrong_2                      # 29e
        clgti   $wrong_2,$vertices,255                  # 30e
        and     $coordinates,$coordinates,$t            # 31e
        a       $t_5,$t_4,$wrong_3                      # 32e
        shli    $wrong_4,$vertices,3                    # 33e
        or      $bad,$bad,$wrong_2                      # 34e
        andc    $wrong_2,$t,$sides                      # 35e
        ceqi    $wrong_5,$kind,1                        # 36e
        ceqi    $t,$vertices,0                          # 37e
        ai      $t_5,$t_5,15                            # 38e
        cgti    $coordinates,$coordinates,0             # 39e
        or      $bad,$bad,$wrong_2                      # 40e
        ceq     $wrong_2,$wrong_5,$t                    # 41e
        ceqi    $kind,$kind,0                           # 42e
        ceqi    $t,$triangles,0                         # 43e
        andi    $t_5,$t_5,-16                           # 44e
        and     $wrong_5,$wrong_4,$coordinates          # 45e
        or      $bad,$bad,$wrong_2                      # 46e
        xor     $wrong_2,$t,$kind                       # 47e
        a       $t,$t_5,$wrong_5                        # 48e
        or      $bad,$bad,$wrong_2                      # 49e
        cgt     $wrong,$t,$wrong                        # 50e
        ai      $a_level_end,$a_low,112                 # 51e
        or      $bad,$bad,$wrong                        # 52e
        a       $a_end,$a_end,$a_low                    # 53e
        and     $bad,$bad,$k_least_one                  # 54e
        ori     $a_node,$a_low,0                        # 55e
        lnop                                            # 55o pairing
        ori     $low,$nodes,0                           # 56e
        brnz    $bad,damaged                            # 56o
next_level:
        ai      $levels,$levels,-1                      # 0e
        hbrr    upper_back,upper                        # 0o hint
        nop     $127                                    # 1e pairing
        brz     $levels,lowest                          # 2o
upper:
        ai      $low,$low,-1                            # 0e
        lqd     $child,96($a_low)                       # 0o
        ai      $a_low,$a_low,112                       # 1e
        shufb   $expected,$below,$below,$m_splat        # 1o
        ceq     $t,$a_low,$a_level_end                  # 3e
        a       $expected,$expected,$k_steps            # 5e
        ceqi    $absent,$child,0                        # 6e
        ceq     $expected,$expected,$child              # 7e
        xori    $valid,$absent,-1                       # 8e
        lnop                                            # 8o pairing
        andc    $t_6,$k_least_one,$valid                # 10e
        gb      $t_5,$valid                             # 10o
        rotqmbyi $t_7,$valid,-4                         # 11o
        cntb    $t_5,$t_5                               # 14e
        or      $t_7,$t_7,$k_least_one                  # 15e lanes that may have a child
        and     $t_7,$t_7,$expected                     # 17e
        mpyi    $t_5,$t_5,112                           # 18e
        andc    $wrong,$valid,$t_7                      # 19e
        or      $wrong,$wrong,$t_6                      # 21e
        or      $bad,$bad,$wrong                        # 23e
        a       $below,$below,$t_5                      # 25e
upper_back:
        brz     $t,upper                                # 25o
        a       $a_level_end,$a_block,$below            # 27e
        cgt     $t,$a_level_end,$a_end                  # 29e
        nop     $127                                    # 30e pairing
        brz     $t,next_level                           # 31o
damaged:
        il      $a_block,-1                             # 0e
        bi      $lr                                     # 0o
lowest:
        ceq     $t,$a_level_end,$a_end                  # 0e all levels are there, and nothing but
        brz     $t,damaged                              # 2o
        ilhu    $t,1                                    # 3e
        lqd     $lo_x,0($a_node)                        # 3o
        ilhu    $t_6,0x405                              # 4e
        lqd     $hi_x,48($a_node)                       # 4o
        iohl    $t,515                                  # 5e
        lqd     $lo_y,16($a_node)                       # 5o
        iohl    $t_6,0x607                              # 6e
        lqd     $hi_y,64($a_node)                       # 6o
        ilhu    $k_sign,0x8000                          # 7e
        shufb   $eye_x,$eye,$eye,$t                     # 7o
        il      $size,0                                 # 8e
        shufb   $eye_y,$eye,$eye,$t_6                   # 8o
        ilhu    $t,0x809                                # 9e
        lqd     $lo_z,32($a_node)                       # 9o
        ilhu    $slack,0x3600                           # 10e 2^-19
        lqd     $hi_z,80($a_node)                       # 10o
        fs      $lo_x,$lo_x,$eye_x                      # 11e
        lqd     $child,96($a_node)                      # 11o
        fs      $hi_x,$hi_x,$eye_x                      # 12e
        fs      $lo_y,$lo_y,$eye_y                      # 13e
        iohl    $t,0xa0b                                # 14e
        fs      $hi_y,$hi_y,$eye_y                      # 15e
        ori     $left,$nodes,0                          # 16e
        shufb   $eye_z,$eye,$eye,$t                     # 16o
        andc    $lo_x,$lo_x,$k_sign                     # 17e
        andc    $hi_x,$hi_x,$k_sign                     # 18e
        fcgt    $c_greater,$lo_x,$size                  # 19e
        andc    $lo_y,$lo_y,$k_sign                     # 20e
        selb    $size,$size,$lo_x,$c_greater            # 21e
        fs      $lo_z,$lo_z,$eye_z                      # 22e
        fcgt    $c_greater,$hi_x,$size                  # 23e
        andc    $hi_y,$hi_y,$k_sign                     # 24e
        selb    $size,$size,$hi_x,$c_greater            # 25e
        fs      $hi_z,$hi_z,$eye_z                      # 26e
        fcgt    $c_greater,$lo_y,$size                  # 27e
        andc    $lo_z,$lo_z,$k_sign                     # 28e
        selb    $size,$size,$lo_y,$c_greater            # 29e
        ceqi    $absent,$child,0                        # 30e
        fcgt    $c_greater,$hi_y,$size                  # 31e
        andc    $hi_z,$hi_z,$k_sign                     # 32e
        selb    $size,$size,$hi_y,$c_greater            # 33e
        clgti   $left_2,$left,1                         # 34e at least as many passes as overlap
        fcgt    $c_greater,$lo_z,$size                  # 35e
        ilhu    $k_no_low,0x6080                        # 36e
        selb    $size,$size,$lo_z,$c_greater            # 37e
        ilhu    $k_no_high,0xe080                       # 38e
        fcgt    $c_greater,$hi_z,$size                  # 39e
        selb    $size,$size,$hi_z,$c_greater            # 41e
        andc    $size,$size,$absent                     # 43e
        rotqbyi $other,$size,8                          # 45o
        fcgt    $c_greater,$other,$size                 # 49e
        selb    $size,$size,$other,$c_greater           # 51e
        rotqbyi $other,$size,4                          # 53o
        fcgt    $c_greater,$other,$size                 # 57e
        selb    $size,$size,$other,$c_greater           # 59e
        lnop                                            # 59o pairing
        fm      $slack,$size,$slack                     # 61e
        brz     $left_2,next_boxes_short                # 61o too few passes
        ai      $left,$left,-1                          # 62e
        lqd     $lo_x,0($a_node)                        # 62o
        lqd     $lo_z,32($a_node)                       # 63o
        lqd     $hi_z,80($a_node)                       # 64o
        lqd     $hi_x,48($a_node)                       # 65o
        hbrr    next_boxes_back,next_boxes              # 66o hint
        nop     $127                                    # 67e pairing
        lqd     $hi_y_2,64($a_node)                     # 67o
        fs      $lo_x_2,$lo_x,$eye_x                    # 68e
        lqd     $lo_y,16($a_node)                       # 68o
        fs      $lo_z,$lo_z,$eye_z                      # 69e
        shlqbyi $a_node_2,$a_node,0                     # 69o copy
        fs      $hi_z,$hi_z,$eye_z                      # 70e
        lqd     $child,96($a_node)                      # 70o
        fs      $hi_x_2,$hi_x,$eye_x                    # 71e
        ceq     $wrong,$lo_x,$k_no_low                  # 72e
        fs      $hi_y,$hi_y_2,$eye_y                    # 73e
        fs      $lo_x,$lo_x_2,$slack                    # 74e
        fs      $lo_z_2,$lo_z,$slack                    # 75e
        fs      $lo_y,$lo_y,$eye_y                      # 76e
        fa      $hi_x_3,$hi_x_2,$slack                  # 77e
        fa      $hi_z_2,$hi_z,$slack                    # 78e
        ai      $a_node,$a_node,112                     # 79e
        lnop                                            # 79o pairing
        ceq     $t,$hi_x,$k_no_high                     # 80e
        stqd    $lo_x,0($a_node_2)                      # 80o
next_boxes:
            and     $wrong,$wrong,$t                    # 0e
        lqd     $lo_x,0($a_node)                        # 0o
            ceqi    $absent,$child,0                    # 1e
        lqd     $lo_z,32($a_node)                       # 1o
            fs      $lo_y,$lo_y,$slack                  # 2e
        lqd     $hi_z,80($a_node)                       # 2o
            andc    $wrong,$absent,$wrong               # 3e
            stqd    $hi_x_3,48($a_node_2)               # 3o
            fa      $hi_y,$hi_y,$slack                  # 4e
        lqd     $hi_x,48($a_node)                       # 4o
            or      $bad,$bad,$wrong                    # 5e
            stqd    $hi_z_2,80($a_node_2)               # 5o
        fs      $lo_x_2,$lo_x,$eye_x                    # 6e
            stqd    $lo_z_2,32($a_node_2)               # 6o
        fs      $lo_z,$lo_z,$eye_z                      # 7e
        lqd     $hi_y_2,64($a_node)                     # 7o
        fs      $hi_z,$hi_z,$eye_z                      # 8e
            stqd    $lo_y,16($a_node_2)                 # 8o
        ceq     $wrong,$lo_x,$k_no_low                  # 9e
        lqd     $lo_y,16($a_node)                       # 9o
        ai      $left,$left,-1                          # 10e
        lqd     $child,96($a_node)                      # 10o
        fs      $hi_x_2,$hi_x,$eye_x                    # 11e
            stqd    $hi_y,64($a_node_2)                 # 11o
        fs      $lo_x,$lo_x_2,$slack                    # 12e
        shlqbyi $a_node_2,$a_node,0                     # 12o copy
        ai      $a_node,$a_node,112                     # 13e
        fs      $hi_y,$hi_y_2,$eye_y                    # 14e
        fs      $lo_z_2,$lo_z,$slack                    # 15e
        fs      $lo_y,$lo_y,$eye_y                      # 16e
        fa      $hi_x_3,$hi_x_2,$slack                  # 17e
        lnop                                            # 17o pairing
        ceq     $t,$hi_x,$k_no_high                     # 18e
        stqd    $lo_x,0($a_node_2)                      # 18o
        fa      $hi_z_2,$hi_z,$slack                    # 19e
next_boxes_back:
        brnz    $left,next_boxes                        # 19o
next_boxes_drain:
        fs      $lo_y,$lo_y,$slack                      # 0e
        stqd    $hi_x_3,48($a_node_2)                   # 0o
        fa      $hi_y,$hi_y,$slack                      # 1e
        stqd    $hi_z_2,80($a_node_2)                   # 1o
        and     $wrong,$wrong,$t                        # 2e
        stqd    $lo_z_2,32($a_node_2)                   # 2o
        ceqi    $absent,$child,0                        # 3e
        andc    $wrong,$absent,$wrong                   # 5e
        nop     $127                                    # 6e pairing
        stqd    $lo_y,16($a_node_2)                     # 6o
        or      $bad,$bad,$wrong                        # 7e
        stqd    $hi_y,64($a_node_2)                     # 7o
mesh_prepare_block:
        ai      $limit,$materials,-1                    # 0e
        fsmbi   $m_xyz,0xfff0                           # 0o
        ori     $a_vertex,$a_end,0                      # 1e
        shufb   $triangles,$triangles,$triangles,$m_splat # 1o
        nop     $127                                    # 2e pairing
        brnz    $of_objects,objects                     # 2o
        nop     $127                                    # 3e pairing
        brnz    $kind,blocks_below                      # 3o
        clgti   $low_2,$low,1                           # 4e at least as many passes as overlap
        brz     $low_2,next_runs_short                  # 6o too few passes
        ilhu    $t,0xffff                               # 7e
        lqd     $child,96($a_low)                       # 7o
        ai      $a_low,$a_low,112                       # 8e
        hbrr    next_runs_back,next_runs                # 8o hint
        ai      $low,$low,-1                            # 9e
        rotmi   $lengths,$child,-16                     # 13e
        andc    $firsts,$child,$t                       # 14e
        andi    $wrong,$child,3                         # 15e
        rotmi   $firsts,$firsts,-2                      # 16e
        ai      $t,$lengths,-1                          # 17e
        ceqi    $absent,$child,0                        # 18e
        clgti   $t,$t,7                                 # 19e
        a       $t_6,$firsts,$lengths                   # 20e
        or      $wrong,$wrong,$t                        # 21e
next_runs:
            clgt    $t,$t_6,$triangles                  # 0e
        lqd     $child,96($a_low)                       # 0o
        ai      $a_low,$a_low,112                       # 1e
            or      $wrong,$wrong,$t                    # 2e
        ai      $low,$low,-1                            # 3e
            andc    $wrong,$wrong,$absent               # 4e
        ilhu    $t,0xffff                               # 5e
            or      $bad,$bad,$wrong                    # 6e
        rotmi   $lengths,$child,-16                     # 7e
        andc    $firsts,$child,$t                       # 8e
        andi    $wrong,$child,3                         # 9e
        rotmi   $firsts,$firsts,-2                      # 10e
        ai      $t,$lengths,-1                          # 11e
        ceqi    $absent,$child,0                        # 12e
        clgti   $t,$t,7                                 # 13e
        a       $t_6,$firsts,$lengths                   # 14e
        or      $wrong,$wrong,$t                        # 15e
next_runs_back:
        brnz    $low,next_runs                          # 15o
next_runs_drain:
        clgt    $t,$t_6,$triangles                      # 0e
        or      $wrong,$wrong,$t                        # 2e
        andc    $wrong,$wrong,$absent                   # 4e
        or      $bad,$bad,$wrong                        # 6e
mesh_prepare_block_2:
        andi    $left,$vertices,3                       # 0e
        brz     $left,by_fours                          # 2o
        sfi     $left,$left,0                           # 3e counts up: not worth a pipeline
        hbrr    next_vertex_back,next_vertex            # 3o hint
next_vertex:
        ai      $left,$left,1                           # 0e
        lqd     $vertex,0($a_vertex)                    # 1o
        fs      $moved,$vertex,$eye                     # 7e
        selb    $vertex,$vertex,$moved,$m_xyz           # 13e
        nop     $127                                    # 14e pairing
        stqd    $vertex,0($a_vertex)                    # 15o
        ai      $a_vertex,$a_vertex,16                  # 16e
next_vertex_back:
        brnz    $left,next_vertex                       # 16o
by_fours:
        rotmi   $left,$vertices,-2                      # 0e
        ori     $a_again,$a_vertex,0                    # 1e
        nop     $127                                    # 2e pairing
        brz     $left,faces                             # 4o
        clgti   $left_2,$left,1                         # 5e at least as many passes as overlap
        brz     $left_2,next_four_short                 # 7o too few passes
        ai      $left,$left,-1                          # 8e
        lqd     $vertex_2,0($a_vertex)                  # 8o
        lqd     $vertex1_2,16($a_vertex)                # 9o
        lqd     $vertex2_2,32($a_vertex)                # 10o
        nop     $127                                    # 11e pairing
        lqd     $vertex3_2,48($a_vertex)                # 11o
        ai      $a_vertex,$a_vertex,64                  # 12e
        hbrr    next_four_back,next_four                # 12o hint
        fs      $moved,$vertex_2,$eye                   # 14e
        fs      $moved+1,$vertex1_2,$eye                # 15e
        fs      $moved+2,$vertex2_2,$eye                # 16e
        fs      $moved+3,$vertex3_2,$eye                # 17e
next_four:
            selb    $vertex,$vertex_2,$moved,$m_xyz     # 1e
        lqd     $vertex_2,0($a_vertex)                  # 1o
            selb    $vertex+1,$vertex1_2,$moved+1,$m_xyz # 2e
        lqd     $vertex1_2,16($a_vertex)                # 2o
            selb    $vertex+2,$vertex2_2,$moved+2,$m_xyz # 3e
        lqd     $vertex2_2,32($a_vertex)                # 3o
            selb    $vertex+3,$vertex3_2,$moved+3,$m_xyz # 4e
        lqd     $vertex3_2,48($a_vertex)                # 4o
        ai      $a_vertex,$a_vertex,64                  # 5e
            stqd    $vertex,0($a_again)                 # 5o
        ai      $left,$left,-1                          # 6e
            stqd    $vertex+1,16($a_again)              # 6o
        fs      $moved,$vertex_2,$eye                   # 7e
            stqd    $vertex+2,32($a_again)              # 7o
        fs      $moved+1,$vertex1_2,$eye                # 8e
            stqd    $vertex+3,48($a_again)              # 8o
        fs      $moved+2,$vertex2_2,$eye                # 9e
        fs      $moved+3,$vertex3_2,$eye                # 10e
            ai      $a_again,$a_again,64                # 11e
next_four_back:
        brnz    $left,next_four                         # 11o one pass: the room for this code is
next_four_drain:
        selb    $vertex,$vertex_2,$moved,$m_xyz         # 0e
        selb    $vertex+1,$vertex1_2,$moved+1,$m_xyz    # 1e
        selb    $vertex+2,$vertex2_2,$moved+2,$m_xyz    # 2e
        stqd    $vertex,0($a_again)                     # 2o
        selb    $vertex+3,$vertex3_2,$moved+3,$m_xyz    # 3e
        stqd    $vertex+1,16($a_again)                  # 3o
        ai      $a_again_2,$a_again,64                  # 4e
        stqd    $vertex+2,32($a_again)                  # 4o
        nop     $127                                    # 5e pairing
        stqd    $vertex+3,48($a_again)                  # 5o
faces:
        ai      $left,$triangles,3                      # 0e
        orx     $bad,$bad                               # 0o
        ilhu    $t,771                                  # 1e
        rotmi   $left,$left,-2                          # 2e
        ai      $vertices,$vertices,-1                  # 3e
        iohl    $t,787                                  # 4e
        andi    $t_6,$left,1                            # 6e
        shufb   $limit,$vertices,$limit,$t              # 6o
        rotmi   $left,$left,-1                          # 7e
        brz     $t_6,in_pairs                           # 8o
        lqd     $face,0($a_vertex)                      # 9o
        ai      $a_vertex,$a_vertex,16                  # 10e
        clgtb   $face,$face,$limit                      # 15e
        or      $bad,$bad,$face                         # 17e
in_pairs:
        nop     $127                                    # 0e pairing
        brz     $left,checked                           # 0o
        clgti   $left_2,$left,1                         # 1e at least as many passes as overlap
        brz     $left_2,next_faces_short                # 3o too few passes
        ai      $left,$left,-1                          # 4e
        lqd     $face_2,0($a_vertex)                    # 4o
        nop     $127                                    # 5e pairing
        lqd     $vertex_3,16($a_vertex)                 # 5o
        ai      $a_vertex,$a_vertex,32                  # 6e
        hbrr    next_faces_back,next_faces              # 6o hint
next_faces:
        ai      $left,$left,-1                          # 0e
        lnop                                            # 0o pairing
            clgtb   $face,$face_2,$limit                # 1e
        lqd     $face_2,0($a_vertex)                    # 1o
            clgtb   $vertex,$vertex_3,$limit            # 2e
        lqd     $vertex_3,16($a_vertex)                 # 2o
            or      $bad_2,$bad,$face                   # 3e
        ai      $a_vertex,$a_vertex,32                  # 4e
            or      $bad,$bad_2,$vertex                 # 5e
next_faces_back:
        brnz    $left,next_faces                        # 5o
next_faces_drain:
        clgtb   $face,$face_2,$limit                    # 0e
        clgtb   $vertex,$vertex_3,$limit                # 1e
        or      $bad_2,$bad,$face                       # 2e
        or      $bad,$bad_2,$vertex                     # 4e
checked:
        orx     $a_block,$bad                           # 0o
        bi      $lr                                     # 1o
blocks_below:
        clgti   $low_2,$low,1                           # 0e at least as many passes as overlap
        lqa     $boxes,first_boxes                      # 0o
        ilhu    $k_four,0x800                           # 1e
        shufb   $number,$number,$number,$m_splat        # 1o
        shufb   $blocks,$blocks,$blocks,$m_splat        # 2o
        brz     $low_2,next_blocks_short                # 3o too few passes
        ai      $low,$low,-1                            # 4e
        lqd     $child_2,96($a_low)                     # 4o
        nop     $127                                    # 5e pairing
        shlqbyi $a_low_2,$a_low,0                       # 5o copy
        ai      $a_low,$a_low,112                       # 6e
        hbrr    next_blocks_back,next_blocks            # 6o hint
        clgt    $wrong,$blocks,$child_2                 # 10e
        clgt    $t,$child_2,$number                     # 11e
        ceqi    $absent,$child_2,0                      # 12e
        nand    $wrong,$wrong,$t                        # 13e
next_blocks:
            or      $child,$child_2,$boxes              # 0e
        lqd     $child_2,96($a_low)                     # 0o
            andc    $wrong,$wrong,$absent               # 1e
            lnop                                        # 1o pairing
            a       $boxes,$boxes,$k_four               # 2e
            stqd    $child,96($a_low_2)                 # 2o
        ai      $low,$low,-1                            # 3e
        shlqbyi $a_low_2,$a_low,0                       # 3o copy
            or      $bad,$bad,$wrong                    # 4e
        ai      $a_low,$a_low,112                       # 5e
        clgt    $t,$child_2,$number                     # 6e
        clgt    $wrong,$blocks,$child_2                 # 7e
        ceqi    $absent,$child_2,0                      # 8e
        lnop                                            # 8o pairing
        nand    $wrong,$wrong,$t                        # 9e
next_blocks_back:
        brnz    $low,next_blocks                        # 9o
next_blocks_drain:
        andc    $wrong,$wrong,$absent                   # 0e
        or      $child,$child_2,$boxes                  # 1e
        or      $bad,$bad,$wrong                        # 2e
        lnop                                            # 2o pairing
        a       $boxes,$boxes,$k_four                   # 3e
        stqd    $child,96($a_low_2)                     # 3o
        orx     $a_block,$bad                           # 4o
        bi      $lr                                     # 5o
objects:
        il      $k_size,64                              # 0e
        shufb   $of_spheres,$of_spheres,$of_spheres,$m_splat # 0o
        il      $t,48                                   # 1e
        sf      $k_objects,$a_block,$a_end              # 2e
        il      $k_part,128                             # 3e
        lnop                                            # 3o pairing
        selb    $k_size,$k_size,$t,$of_spheres          # 4e
        shufb   $k_objects,$k_objects,$k_objects,$m_splat # 4o
        il      $t,171                                  # 5e
        mpy     $k_last,$triangles,$k_size              # 6e
        clgti   $low_2,$low,3                           # 7e at least as many passes as overlap
        selb    $k_part,$k_part,$t,$of_spheres          # 8e
        rotmi   $k_quads,$k_size,-4                     # 9e
        ori     $left,$triangles,0                      # 10e
        ori     $a_again,$a_vertex,0                    # 11e
        lnop                                            # 11o pairing
        sf      $k_last,$k_size,$k_last                 # 13e
        brz     $low_2,next_lanes_short                 # 13o too few passes
        ai      $a_low_3,$a_low,112                     # 14e
        lqd     $child_3,96($a_low)                     # 14o
        ai      $low,$low,-1                            # 15e
        hbrr    next_lanes_back,next_lanes              # 15o hint
        ai      $a_low_4,$a_low_3,112                   # 16e
        lqd     $child_2,96($a_low_3)                   # 16o
        ai      $low,$low,-1                            # 17e
        lnop                                            # 17o pairing
        ai      $a_low,$a_low_4,112                     # 18e
        lqd     $child,96($a_low_4)                     # 18o
        ai      $low,$low,-1                            # 19e
        sf      $t_7,$k_objects,$child_3                # 20e
        ceqi    $absent,$child_3,0                      # 21e
        rotmi   $t_8,$t_7,-4                            # 22e
        sf      $t_9,$k_objects,$child_2                # 23e
        shlqbyi $absent_2,$absent,0                     # 23o copy
        andi    $firsts_2,$t_7,15                       # 24e
        rotmi   $t,$t_9,-4                              # 25e
        mpyu    $firsts_3,$t_8,$k_part                  # 26e
        shlqbyi $t_2,$t_8,0                             # 26o copy
        clgt    $wrong_6,$t_7,$k_last                   # 27e
        ceqi    $absent,$child_2,0                      # 28e
        mpyu    $firsts_4,$t,$k_part                    # 29e
        or      $wrong_6,$wrong_6,$firsts_2             # 30e
        andi    $firsts_2,$t_9,15                       # 31e
        clgt    $wrong_7,$t_9,$k_last                   # 32e
        rotmi   $firsts,$firsts_3,-9                    # 33e
        sf      $t_7,$k_objects,$child                  # 34e
        mpyu    $firsts,$firsts,$k_quads                # 37e
        ceq     $firsts,$firsts,$t_2                    # 44e
next_lanes:
        ai      $low,$low,-1                            # 0e
            shlqbyi $t_6,$t,0                           # 0o copy
            orc     $wrong,$wrong_6,$firsts             # 1e
            rotmi   $firsts,$firsts_4,-9                # 2e
            or      $wrong_6,$wrong_7,$firsts_2         # 3e
            lnop                                        # 3o pairing
            andc    $wrong,$wrong,$absent_2             # 4e
            shlqbyi $absent_2,$absent,0                 # 4o copy
            ceqi    $absent,$child,0                    # 5e
            lnop                                        # 5o pairing
            rotmi   $t,$t_7,-4                          # 6e
        lqd     $child,96($a_low)                       # 6o
            mpyu    $firsts,$firsts,$k_quads            # 7e
            andi    $firsts_2,$t_7,15                   # 8e
            clgt    $wrong_7,$t_7,$k_last               # 9e
            mpyu    $firsts_4,$t,$k_part                # 10e
        ai      $a_low,$a_low,112                       # 11e
        sf      $t_7,$k_objects,$child                  # 12e
            or      $bad,$bad,$wrong                    # 13e
            lnop                                        # 13o pairing
            ceq     $firsts,$firsts,$t_6                # 14e
next_lanes_back:
        brnz    $low,next_lanes                         # 14o
next_lanes_drain:
        rotmi   $t_6,$t_7,-4                            # 0e
        shlqbyi $t_4,$t,0                               # 0o copy
        rotmi   $firsts_4,$firsts_4,-9                  # 1e
        shlqbyi $absent_3,$absent,0                     # 1o copy
        orc     $wrong,$wrong_6,$firsts                 # 2e
        or      $wrong_6,$wrong_7,$firsts_2             # 3e
        mpyu    $firsts_2,$t_6,$k_part                  # 4e
        shlqbyi $t_6,$t_6,0                             # 4o copy
        mpyu    $firsts,$firsts_4,$k_quads              # 5e
        ceqi    $absent,$child,0                        # 6e
        andi    $firsts_5,$t_7,15                       # 7e
        lnop                                            # 7o pairing
        clgt    $wrong_8,$t_7,$k_last                   # 8e
        shlqbyi $absent_4,$absent,0                     # 8o copy
        andc    $wrong,$wrong,$absent_2                 # 9e
        or      $wrong_9,$wrong_8,$firsts_5             # 10e
        rotmi   $firsts_2,$firsts_2,-9                  # 11e
        ceq     $firsts,$firsts,$t_4                    # 12e
        or      $bad,$bad,$wrong                        # 13e
        orc     $wrong,$wrong_6,$firsts                 # 14e
        mpyu    $firsts,$firsts_2,$k_quads              # 15e
        andc    $wrong,$wrong,$absent_3                 # 16e
        or      $bad,$bad,$wrong                        # 18e
        ceq     $firsts,$firsts,$t_6                    # 22e
        orc     $wrong,$wrong_9,$firsts                 # 24e
        andc    $wrong,$wrong,$absent_4                 # 26e
        or      $bad,$bad,$wrong                        # 28e
        lnop                                            # 28o pairing
mesh_prepare_block_3:
        clgti   $left_2,$left,2                         # 0e at least as many passes as overlap
        orx     $bad,$bad                               # 0o
        nop     $127                                    # 1e pairing
        brz     $left_2,next_object_short               # 2o too few passes
        a       $a_vertex_2,$a_vertex,$k_size           # 3e
        lqd     $face_3,32($a_vertex)                   # 3o
        ai      $left,$left,-1                          # 4e
        hbrr    next_object_back,next_object            # 4o hint
        nop     $127                                    # 5e pairing
        lqd     $vertex_4,0($a_vertex)                  # 5o
        a       $a_vertex,$a_vertex_2,$k_size           # 6e
        lqd     $face_2,32($a_vertex_2)                 # 6o
        ai      $left,$left,-1                          # 7e
        lqd     $vertex,0($a_vertex_2)                  # 7o
        nop     $127                                    # 8e pairing
        rotqbyi $face,$face_3,8                         # 9o
        fs      $moved_2,$vertex_4,$eye                 # 11e
        shlqbyi $vertex_3,$vertex_4,0                   # 11o copy
        clgt    $face,$face,$limit                      # 13e
        lnop                                            # 13o pairing
next_object:
            or      $bad,$bad,$face                     # 0e
            rotqbyi $face,$face_2,8                     # 0o
        ai      $left,$left,-1                          # 1e
        lqd     $face_2,32($a_vertex)                   # 1o
            selb    $moved,$vertex_3,$moved_2,$m_xyz    # 2e
            shlqbyi $vertex_3,$vertex,0                 # 2o copy
            fs      $moved_2,$vertex,$eye               # 3e
        lqd     $vertex,0($a_vertex)                    # 3o
        a       $a_vertex,$a_vertex,$k_size             # 4e
            stqd    $moved,0($a_again)                  # 4o
            clgt    $face,$face,$limit                  # 5e
            lnop                                        # 5o pairing
            a       $a_again,$a_again,$k_size           # 6e
next_object_back:
        brnz    $left,next_object                       # 6o
next_object_drain:
        fs      $moved_3,$vertex,$eye                   # 0e
        rotqbyi $face_2,$face_2,8                       # 0o
        or      $bad,$bad,$face                         # 1e
        hbr     mesh_prepare_return,$lr                 # 1o hint
        a       $a_again_3,$a_again,$k_size             # 2e
        shlqbyi $vertex_5,$vertex,0                     # 2o copy
        selb    $moved,$vertex_3,$moved_2,$m_xyz        # 3e
        clgt    $face,$face_2,$limit                    # 4e
        a       $a_again_2,$a_again_3,$k_size           # 5e
        stqd    $moved,0($a_again)                      # 5o
        or      $bad,$bad,$face                         # 6e
        selb    $moved,$vertex_5,$moved_3,$m_xyz        # 7e
        and     $bad,$bad,$k_least_one                  # 8e
        stqd    $moved,0($a_again_3)                    # 9o
        orx     $a_block,$bad                           # 10o
mesh_prepare_return:
        bi      $lr                                     # 11o
next_boxes_short:
        ai      $left,$left,-1                          # 0e
        lqd     $lo_x,0($a_node)                        # 0o
        lqd     $hi_x,48($a_node)                       # 1o
        lqd     $lo_y,16($a_node)                       # 2o
        lqd     $hi_y,64($a_node)                       # 3o
        lqd     $lo_z,32($a_node)                       # 4o
        nop     $127                                    # 5e pairing
        lqd     $hi_z,80($a_node)                       # 5o
        fs      $lo_x_2,$lo_x,$eye_x                    # 6e
        lqd     $child,96($a_node)                      # 6o
        fs      $hi_x_4,$hi_x,$eye_x                    # 7e
        fs      $lo_y,$lo_y,$eye_y                      # 8e
        fs      $hi_y,$hi_y,$eye_y                      # 9e
        fs      $lo_z,$lo_z,$eye_z                      # 10e
        fs      $hi_z,$hi_z,$eye_z                      # 11e
        fs      $lo_x_2,$lo_x_2,$slack                  # 12e
        fa      $hi_x_4,$hi_x_4,$slack                  # 13e
        fs      $lo_y,$lo_y,$slack                      # 14e
        fa      $hi_y,$hi_y,$slack                      # 15e
        fs      $lo_z,$lo_z,$slack                      # 16e
        fa      $hi_z,$hi_z,$slack                      # 17e
        lnop                                            # 17o pairing
        ceq     $wrong,$lo_x,$k_no_low                  # 18e
        stqd    $lo_x_2,0($a_node)                      # 18o
        ceq     $t,$hi_x,$k_no_high                     # 19e
        stqd    $hi_x_4,48($a_node)                     # 19o
        ceqi    $absent,$child,0                        # 20e
        stqd    $lo_y,16($a_node)                       # 20o
        and     $wrong,$wrong,$t                        # 21e
        stqd    $hi_y,64($a_node)                       # 21o
        nop     $127                                    # 22e pairing
        stqd    $lo_z,32($a_node)                       # 22o
        andc    $wrong,$absent,$wrong                   # 23e
        stqd    $hi_z,80($a_node)                       # 23o
        ai      $a_node,$a_node,112                     # 24e
        lnop                                            # 24o pairing
        or      $bad,$bad,$wrong                        # 25e
        brnz    $left,next_boxes_short                  # 25o
        nop     $127                                    # 26e pairing
        br      mesh_prepare_block                      # 26o
next_runs_short:
        ilhu    $t,0xffff                               # 0e
        lqd     $child,96($a_low)                       # 0o
        ai      $low,$low,-1                            # 1e
        ai      $a_low,$a_low,112                       # 2e
        rotmi   $lengths,$child,-16                     # 6e
        andc    $firsts,$child,$t                       # 7e
        andi    $wrong,$child,3                         # 8e
        rotmi   $firsts,$firsts,-2                      # 9e
        ai      $t,$lengths,-1                          # 10e
        ceqi    $absent,$child,0                        # 11e
        clgti   $t,$t,7                                 # 12e
        a       $t_6,$firsts,$lengths                   # 13e
        or      $wrong,$wrong,$t                        # 14e
        clgt    $t,$t_6,$triangles                      # 15e
        or      $wrong,$wrong,$t                        # 17e
        andc    $wrong,$wrong,$absent                   # 19e
        or      $bad,$bad,$wrong                        # 21e
        brnz    $low,next_runs_short                    # 21o
        nop     $127                                    # 22e pairing
        br      mesh_prepare_block_2                    # 22o
next_four_short:
        ai      $left,$left,-1                          # 0e
        lqd     $vertex,0($a_vertex)                    # 0o
        lqd     $vertex+1,16($a_vertex)                 # 1o
        lqd     $vertex+2,32($a_vertex)                 # 2o
        lqd     $vertex+3,48($a_vertex)                 # 3o
        ai      $a_vertex,$a_vertex,64                  # 4e
        fs      $moved,$vertex,$eye                     # 6e
        fs      $moved+1,$vertex+1,$eye                 # 7e
        fs      $moved+2,$vertex+2,$eye                 # 8e
        fs      $moved+3,$vertex+3,$eye                 # 9e
        selb    $vertex,$vertex,$moved,$m_xyz           # 12e
        selb    $vertex+1,$vertex+1,$moved+1,$m_xyz     # 13e
        selb    $vertex+2,$vertex+2,$moved+2,$m_xyz     # 14e
        stqd    $vertex,0($a_again)                     # 14o
        selb    $vertex+3,$vertex+3,$moved+3,$m_xyz     # 15e
        stqd    $vertex+1,16($a_again)                  # 15o
        stqd    $vertex+2,32($a_again)                  # 16o
        stqd    $vertex+3,48($a_again)                  # 17o
        ai      $a_again,$a_again,64                    # 18e
        brnz    $left,next_four_short                   # 18o one pass: the room for this code is
        nop     $127                                    # 19e pairing
        br      faces                                   # 19o
next_faces_short:
        ai      $left,$left,-1                          # 0e
        lqd     $face,0($a_vertex)                      # 0o
        lqd     $vertex,16($a_vertex)                   # 1o
        ai      $a_vertex,$a_vertex,32                  # 2e
        clgtb   $face,$face,$limit                      # 6e
        clgtb   $vertex,$vertex,$limit                  # 7e
        or      $bad,$bad,$face                         # 8e
        lnop                                            # 8o pairing
        or      $bad,$bad,$vertex                       # 10e
        brnz    $left,next_faces_short                  # 10o
        nop     $127                                    # 11e pairing
        br      checked                                 # 11o
next_blocks_short:
        ai      $low,$low,-1                            # 0e
        lqd     $child,96($a_low)                       # 0o
        clgt    $t,$child,$number                       # 6e
        clgt    $wrong,$blocks,$child                   # 7e
        ceqi    $absent,$child,0                        # 8e
        nand    $wrong,$wrong,$t                        # 9e
        or      $child,$child,$boxes                    # 10e
        andc    $wrong,$wrong,$absent                   # 11e
        a       $boxes,$boxes,$k_four                   # 12e
        stqd    $child,96($a_low)                       # 12o
        or      $bad,$bad,$wrong                        # 13e
        lnop                                            # 13o pairing
        ai      $a_low,$a_low,112                       # 14e
        brnz    $low,next_blocks_short                  # 14o
        orx     $a_block,$bad                           # 15o
        bi      $lr                                     # 16o
next_lanes_short:
        ai      $low,$low,-1                            # 0e
        lqd     $child,96($a_low)                       # 0o
        ai      $a_low,$a_low,112                       # 1e
        sf      $t,$k_objects,$child                    # 6e
        ceqi    $absent,$child,0                        # 7e
        rotmi   $t_6,$t,-4                              # 8e
        clgt    $wrong,$t,$k_last                       # 9e
        andi    $firsts,$t,15                           # 10e
        mpyu    $firsts_6,$t_6,$k_part                  # 12e
        or      $wrong,$wrong,$firsts                   # 13e
        rotmi   $firsts,$firsts_6,-9                    # 19e
        mpyu    $firsts,$firsts,$k_quads                # 23e
        ceq     $firsts,$firsts,$t_6                    # 30e
        orc     $wrong,$wrong,$firsts                   # 32e
        andc    $wrong,$wrong,$absent                   # 34e
        lnop                                            # 34o pairing
        or      $bad,$bad,$wrong                        # 36e
        brnz    $low,next_lanes_short                   # 36o
        nop     $127                                    # 37e pairing
        br      mesh_prepare_block_3                    # 37o
next_object_short:
        ai      $left,$left,-1                          # 0e
        lqd     $vertex,0($a_vertex)                    # 0o
        lqd     $face,32($a_vertex)                     # 1o
        a       $a_vertex,$a_vertex,$k_size             # 2e
        fs      $moved,$vertex,$eye                     # 6e
        rotqbyi $face,$face,8                           # 7o
        clgt    $face,$face,$limit                      # 11e
        selb    $moved,$vertex,$moved,$m_xyz            # 12e
        or      $bad,$bad,$face                         # 13e
        stqd    $moved,0($a_again)                      # 14o
        a       $a_again,$a_again,$k_size               # 15e
        brnz    $left,next_object_short                 # 15o
        and     $bad,$bad,$k_least_one                  # 16e
        orx     $a_block,$bad                           # 18o
        nop     $127                                    # 19e pairing
        bi      $lr                                     # 19o
endfunction mesh_prepare
