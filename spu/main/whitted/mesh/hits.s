# The triangles and spheres of the mesh that rays of a batch have hit, as the records that shading
# takes: patches and objects. A packet's rays hit the same ones again and again, so each is made
# once a packet.

        .include "work_unit.inc"
        .include "macros.inc"
        .include "driver.inc"
        .include "whitted.inc"
        .include "mesh.inc"
        .include "math.inc"
        .include "reciprocal.inc"

        .section .data.mesh,"aw",@progbits
        .align  4
hit:    .skip   16                                      # what RAYS16 has of the current hit
current_block:                          # its block's number; no block has all ones
        .skip   16

        .section .rodata.mesh,"a",@progbits
        .align  4
next_axes:                              # y, z, x
        .int    0x04050607,0x08090a0b,0x00010203,0x0c0d0e0f
vertex_indices:                         # three bytes to the ends of three words
        .int    0x80808000,0x80808001,0x80808002,0x80808080
object_end:                             # 0, leave, room for the material, the sides
        .int    0x80808080,0x00010203,0x80808080,0x1c1d1e1f
# The last words of a and b, and behind them that of c.
last_of_two:
        .int    0x0c0d0e0f,0x1c1d1e1f,0x80808080,0x80808080
and_a_third:
        .int    0x00010203,0x04050607,0x1c1d1e1f,0x80808080
# A lane of x and y, and behind them the same lane of z.
lanes:
    .irp lane, 0,1,2
        .int    0x00010203+0x04040404*\lane,0x10111213+0x04040404*\lane,0x80808080,0x80808080
        .int    0x00010203,0x04050607,0x10111213+0x04040404*\lane,0x80808080
    .endr

        # The registers of the traversal, which is done.
        .set    h_left,89                               # packets
        .set    h_block,92                              # address of the block
        .set    h_packet,109
        .set    h_patch,118

        .set    NEXT,10
        registers mask,bits,lane,offset,address,same,all_hit,all_patch,m_splat
        registers object                                # to 22: the packet's
        .set    NEXT,object+4
        registers number,counts,a_vertices,a_faces,index,face,material
        registers a,b,c,to_b,to_c,turned_b,turned_c,normal,square,inverse,t_y,t_e
        registers k_half,k_one,k_sign,m_xyz,m_next,k_leave,k_scale
        registers sum,sum_b,sum_c,c_more,leave_object,head,size
        registers u,v,z,fold,part,m_lane,m_third,textured

# out = |x| + |y| + |z| in the first lane. t is changed.
.macro  taxicab out:req, vector:req, t:req
        andc    \t,\vector,$k_sign
        rotqbyi \out,\t,4
        fa      \out,\out,\t
        rotqbyi \t,\t,8
        fa      \out,\out,\t
.endm

# Puts the address of the material into the last quadword of an object's record, and stores that.
.macro  put_head quad:req
        mpyi    $material,$material,MATERIAL_SIZE
        ila     $address,frame
        load_word $offset,FRAME_mesh_materials,$address
        a       $material,$material,$offset
        cwd     $m_lane,OBJECT_material&15($sp)
        shufb   $head,$material,\quad,$m_lane
        stqd    $head,OBJECT_offset($h_patch)
.endm

# mesh_hits   makes the patches that the rays of BATCH_RAYS have hit, and lets RAYS16 point to them
#   In      w_traced
#   Out     RAYS16_object, MESH_POOL
#   Uses    $3-$79, w_plan, w_first, w_here, w_left
function mesh_hits
        enter
        ila     $h_packet,arena+BATCH_RAYS
        ila     $h_patch,arena+MESH_POOL
        ori     $h_left,$w_traced,0
        il      $number,-1
        stqa    $number,current_block
next_hit:
        # The first of the rays that have hit a triangle of the mesh.
    .irp row, 0,1,2,3
        lqd     $object+\row,RAYS16_object+16*\row($h_packet)
    .endr
        il      $mask,0
    .irp row, 0,1,2,3
        rotmi   $bits,$object+\row,-31
        gb      $bits,$bits
        shli    $mask,$mask,4
        or      $mask,$mask,$bits
    .endr
        brz     $mask,next_packet
        clz     $lane,$mask
        shli    $lane,$lane,2
        il      $offset,RAYS16_object-4*16
        a       $offset,$offset,$lane
        a       $address,$h_packet,$offset
        lqx     $same,$h_packet,$offset
        rotqby  $same,$same,$address
        # All that have hit the same get the address of the patch.
        splat_mask $m_splat
        splat   $all_hit,$same,$m_splat
        splat   $all_patch,$h_patch,$m_splat
    .irp row, 0,1,2,3
        ceq     $same,$object+\row,$all_hit
        selb    $object+\row,$object+\row,$all_patch,$same
        stqd    $object+\row,RAYS16_object+16*\row($h_packet)
    .endr
        stqa    $all_hit,hit
        shli    $3,$all_hit,1
        rotmi   $3,$3,-8
        lqa     $number,current_block
        ceq     $same,$number,$3
        brnz    $same,the_same_block
        stqa    $3,current_block
        brsl    $lr,mesh_block
        ori     $h_block,$3,0
the_same_block:
        ilhu    $k_sign,0x8000
        ilhu    $k_leave,0x3580                         # 2^-20
        lqd     $counts,MESH_HEADER_magic($h_block)
        rotqbyi $counts,$counts,MESH_HEADER_kind
        ceqi    $counts,$counts,MESH_SPHERES
        brnz    $counts,sphere
        # Its vertices, relative to the eye.
        lqa     $index,hit
        andi    $index,$index,(1<<7)-1
        shli    $index,$index,2
        lqd     $counts,MESH_HEADER_nodes($h_block)
        mpyi    $a_vertices,$counts,BOXES_SIZE
        a       $a_vertices,$a_vertices,$h_block
        ai      $a_vertices,$a_vertices,MESH_HEADER_SIZE
        rotqbyi $a_faces,$counts,MESH_HEADER_vertices&15
        shli    $a_faces,$a_faces,4
        a       $a_faces,$a_faces,$a_vertices
        lqx     $face,$a_faces,$index
        a       $address,$a_faces,$index
        rotqby  $face,$face,$address
        andi    $material,$face,0xff
        lqa     $m_lane,vertex_indices
        shufb   $face,$face,$face,$m_lane
        shli    $face,$face,4
        lqx     $a,$a_vertices,$face
        rotqbyi $face,$face,4
        lqx     $b,$a_vertices,$face
        rotqbyi $face,$face,4
        lqx     $c,$a_vertices,$face

        # The normal is (b - a) x (c - a), with the edges made about 1 long before.
        ilhu    $k_half,0x3f00
        ilhu    $k_one,0x3f80
        fsmbi   $m_xyz,0xfff0
        lqa     $m_next,next_axes
        fs      $to_b,$b,$a
        fs      $to_c,$c,$a
        and     $to_b,$to_b,$m_xyz
        and     $to_c,$to_c,$m_xyz
        taxicab $sum,$a,$t_e
        taxicab $sum_b,$to_b,$t_e
        taxicab $sum_c,$to_c,$t_e
        cgt     $c_more,$sum_c,$sum_b
        selb    $size,$sum_b,$sum_c,$c_more
        fa      $leave_object,$sum,$size
        fm      $leave_object,$leave_object,$k_leave
        recip_interpolated_f4 $inverse,$size
        splat_mask $m_splat
        splat   $inverse,$inverse,$m_splat
        fm      $to_b,$to_b,$inverse
        fm      $to_c,$to_c,$inverse
        shufb   $turned_b,$to_b,$to_b,$m_next
        shufb   $turned_c,$to_c,$to_c,$m_next
        fm      $normal,$turned_b,$to_c
        fms     $normal,$to_b,$turned_c,$normal
        shufb   $normal,$normal,$normal,$m_next
        fm      $square,$normal,$normal
        rotqbyi $t_y,$square,4
        rotqbyi $t_e,$square,8
        fa      $square,$square,$t_y
        fa      $square,$square,$t_e
        splat   $square,$square,$m_splat
        rsqrt_f4 $inverse,$square,$t_y,$t_e,$k_half,$k_one
        fm      $normal,$normal,$inverse

        # The record of a plane through a.
        and     $head,$a,$m_xyz
        stqd    $head,OBJECT_centre($h_patch)
        stqd    $head,TRI_a($h_patch)
        selb    $normal,$k_one,$normal,$m_xyz           # 1 is the slope
        stqd    $normal,OBJECT_axis($h_patch)
        lqa     $m_lane,object_end
        shufb   $leave_object,$leave_object,$counts,$m_lane
        put_head $leave_object
        and     $head,$b,$m_xyz
        stqd    $head,TRI_b($h_patch)
        and     $head,$c,$m_xyz
        stqd    $head,TRI_c($h_patch)
        rotqbyi $part,$counts,MESH_HEADER_sides&15
        ilhu    $size,(SIDES_SMOOTH|SIDES_TEXTURED)>>16
        and     $part,$part,$size
        brz     $part,made

        # The normals at its vertices: the lower half of the octahedron is folded back.
        lqa     $m_lane,last_of_two
        lqa     $m_third,and_a_third
        shufb   $u,$a,$b,$m_lane
        shufb   $u,$u,$c,$m_third
        shli    $v,$u,16
        rotmai  $u,$u,-16
        rotmai  $v,$v,-16
        csflt   $u,$u,0
        csflt   $v,$v,0
        load_constant $k_scale,0x38000100               # 1 / 32767
        fm      $u,$u,$k_scale
        fm      $v,$v,$k_scale
        andc    $z,$u,$k_sign
        andc    $part,$v,$k_sign
        fs      $z,$k_one,$z
        fs      $z,$z,$part
        rotmai  $fold,$z,-31
        and     $fold,$fold,$z
        andc    $fold,$fold,$k_sign                     # what z is below 0
    .irp axis, u,v
        and     $part,$\axis,$k_sign
        or      $part,$part,$fold
        fs      $\axis,$\axis,$part
    .endr
        fm      $square,$u,$u
        fma     $square,$v,$v,$square
        fma     $square,$z,$z,$square
        rsqrt_f4 $inverse,$square,$t_y,$t_e,$k_half,$k_one
        # While that is computed.
        rotqbyi $textured,$counts,MESH_HEADER_sides&15
        ilhu    $size,SIDES_TEXTURED>>16
        and     $textured,$textured,$size
        fm      $u,$u,$inverse
        fm      $v,$v,$inverse
        fm      $z,$z,$inverse
    .set    lane_at,0
    .irp vertex, a,b,c
        lqa     $m_lane,lanes+lane_at
        lqa     $m_third,lanes+lane_at+16
        shufb   $part,$u,$v,$m_lane
        shufb   $part,$part,$z,$m_third
        stqd    $part,PATCH_normal_\vertex($h_patch)
    .set    lane_at,lane_at+32
    .endr
        brz     $textured,made

        # Its texture coordinates, which begin at the quadword after the faces. The vertices'
        # offsets have turned by two words.
        rotqbyi $part,$counts,MESH_HEADER_triangles&15
        ai      $part,$part,3
        andi    $part,$part,-4
        shli    $part,$part,2
        a       $a_faces,$a_faces,$part
        rotmi   $index,$face,-1
        rotqbyi $index,$index,8
        cwd     $m_lane,12($sp)
    .irp vertex, a,b,c
        a       $address,$a_faces,$index
        lqd     $u,0($address)
        lqd     $part,TRI_\vertex($h_patch)
        lqd     $z,PATCH_normal_\vertex($h_patch)
        rotqby  $u,$u,$address
        rotqbyi $v,$u,4
        shufb   $part,$u,$part,$m_lane
        shufb   $z,$v,$z,$m_lane
        rotqbyi $index,$index,4
        stqd    $part,TRI_\vertex($h_patch)
        stqd    $z,PATCH_normal_\vertex($h_patch)
    .endr
        br      made

        # The record of a sphere, whose number is its offset in quadwords. It lacks `leave`, and has
        # the number of its material.
sphere: lqa     $index,hit
        andi    $index,$index,(1<<7)-1
        shli    $index,$index,4
        a       $address,$h_block,$index
        lqd     $a,OBJECT_centre($address)
        lqd     $b,OBJECT_axis($address)
        lqd     $c,OBJECT_offset($address)
        stqd    $a,OBJECT_centre($h_patch)
        stqd    $b,OBJECT_axis($h_patch)
        taxicab $sum,$a,$t_e
        andc    $size,$c,$k_sign
        fa      $leave_object,$sum,$size
        fm      $leave_object,$leave_object,$k_leave
        cwd     $m_lane,OBJECT_leave&15($sp)
        shufb   $c,$leave_object,$c,$m_lane
        rotqbyi $material,$c,OBJECT_material&15
        put_head $c
made:   ai      $h_patch,$h_patch,PATCH_SIZE
        br      next_hit

next_packet:
    .rept   2                                           # ai reaches to 511
        ai      $h_packet,$h_packet,RAYS16_SIZE/2
    .endr
        ai      $h_left,$h_left,-1
        brnz    $h_left,next_hit
        leave
endfunction mesh_hits
