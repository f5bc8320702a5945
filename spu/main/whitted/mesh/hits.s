# The triangles, spheres and cones of the mesh that rays of a batch have hit, as the records that
# shading takes: patches and objects. Neighbours in a packet share them. Most are made by
# mesh_flat_patches, four at a time. Those whose blocks have left the cache are made here, and so
# are spheres, cones, and triangles with normals or textures. Both ways make the same bits. With
# colours at vertices or materials in main memory, all of them are made here, and what makes these
# follows.

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
current_block:                                          # its block's number
        .skip   16

        .section .rodata.mesh,"a",@progbits
        .align  4
next_axes:                              # y, z, x
        .int    0x04050607,0x08090a0b,0x00010203,0x0c0d0e0f
vertex_indices:                         # three bytes to the ends of three words
        .int    0x80808000,0x80808001,0x80808002,0x80808080
object_end:                             # 0, leave, space for the material, the sides
        .int    0x80808080,0x00010203,0x80808080,0x1c1d1e1f
# The last words of a and b, and after them that of c.
last_of_two:
        .int    0x0c0d0e0f,0x1c1d1e1f,0x80808080,0x80808080
and_a_third:
        .int    0x00010203,0x04050607,0x1c1d1e1f,0x80808080
# A lane of x and y, and after them the same lane of z.
lanes:
    .irp lane, 0,1,2
        .int    0x00010203+0x04040404*\lane,0x10111213+0x04040404*\lane,0x80808080,0x80808080
        .int    0x00010203,0x04050607,0x10111213+0x04040404*\lane,0x80808080
    .endr

        # The registers of the traversal, which is done.
        .set    h_list,89                               # the hits that are to be made here
        .set    h_block,92                              # address of the block
        .set    h_end,109                               # the list's
        .set    h_patch,118

        .set    NEXT,10
        registers lane,offset,address,is_same,all_hit,m_splat,c_end,bytes
        registers number,counts,of_objects,a_vertices,a_faces # the block's
        registers index,face,material
        registers a,b,c,to_b,to_c,turned_b,turned_c,normal,square,inverse,t_y,t_e
        registers k_half,k_one,k_sign,m_xyz,m_next,k_leave,k_scale
        registers sum,sum_b,sum_c,c_more,leave_object,head,size
        registers u,v,z,fold,part,m_lane,m_third,textured,squares,places
        registers far_a,far_b,far_c                     # magnitudes of a, b - a and c - a

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
        hbrr    list_call,mesh_list_hits_r16
        enter
        ila     $3,arena+BATCH_RAYS
        ori     $4,$w_traced,0
        ila     $5,arena+MESH_POOL
        ila     $6,hit
list_call:
        brsl    $lr,mesh_list_hits_r16
        hbrr    patches_call,mesh_flat_patches
        # 0 after the last patch ends the list.
        il      $number,0
        stqd    $number,0($3)
        stqd    $number,PATCH_SIZE($3)
        stqd    $number,2*PATCH_SIZE($3)
        ila     $address,arena+MESH_POOL
        sf      $bytes,$address,$3
        il      $4,0x10000/PATCH_SIZE+1                 # exact for as many as there may be
        mpyu    $4,$4,$bytes
        rotmi   $4,$4,-16
        ai      $4,$4,3
        rotmi   $4,$4,-2
        stqa    $4,hit
        lqa     $5,kept_from
        ai      $5,$5,1
        brz     $5,patches
        ori     $3,$address,0
        ila     $5,mesh_leaves
        ila     $6,arena+COLOUR_TABLE
        brsl    $lr,height_corners
        lqa     $4,hit
patches:
        ila     $3,arena+MESH_POOL
        ila     $5,mesh_leaves
        ila     $6,arena+MESH_HIT_LIST
        ila     $7,frame
        load_word $7,FRAME_mesh_materials,$7
patches_call:
        brsl    $lr,mesh_flat_patches
        ila     $h_list,arena+MESH_HIT_LIST
        ori     $h_end,$3,0
        il      $number,-1                              # no block's
next_hit:
        hbrr    same_block,made_of_block
        ceq     $c_end,$h_list,$h_end
        brnz    $c_end,all_made
        lqd     $all_hit,0($h_list)
        rotqbyi $h_patch,$all_hit,4
        ai      $h_list,$h_list,MESH_HITS_SIZE
        shli    $3,$all_hit,1
        rotmi   $3,$3,-8
        nop     $2                                      # a hint must be eight instructions ahead
        ceq     $is_same,$number,$3
same_block:
        brnz    $is_same,made_of_block
        stqa    $all_hit,hit
        stqa    $3,current_block
        brsl    $lr,mesh_block
        lqa     $number,current_block
        lqa     $all_hit,hit
        ori     $h_block,$3,0
        lqd     $of_objects,MESH_HEADER_magic($h_block)
        lqd     $counts,MESH_HEADER_nodes($h_block)
        rotqbyi $of_objects,$of_objects,MESH_HEADER_kind
        mpyi    $a_vertices,$counts,BOXES_SIZE
        rotqbyi $a_faces,$counts,MESH_HEADER_vertices&15
        cgti    $of_objects,$of_objects,MESH_LEAF
        a       $a_vertices,$a_vertices,$h_block
        shli    $a_faces,$a_faces,4
        ai      $a_vertices,$a_vertices,MESH_HEADER_SIZE
        a       $a_faces,$a_faces,$a_vertices
made_of_block:
        ilhu    $k_sign,0x8000
        ilhu    $k_leave,0x3600                         # 2^-19
        andi    $index,$all_hit,(1<<7)-1
        brnz    $of_objects,object
        # Its vertices, relative to the eye.
        shli    $index,$index,2
        hbrr    plain,next_hit
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

        # The normal is (b - a) x (c - a), with the edges made about 1 long before. The normals at
        # its vertices are computed beside it, so that each fills the other's waits: the lower half
        # of the octahedron is folded back. A triangle without such normals ignores them.
        lqa     $m_lane,last_of_two
        fs      $to_b,$b,$a
        lqa     $m_third,and_a_third
        fs      $to_c,$c,$a
        lqa     $m_next,next_axes
        fsmbi   $m_xyz,0xfff0
        andc    $far_a,$a,$k_sign
        splat_mask $m_splat
        ilhu    $k_half,0x3f00
        and     $to_b,$to_b,$m_xyz
        shufb   $u,$a,$b,$m_lane
        and     $to_c,$to_c,$m_xyz
        rotqbyi $sum,$far_a,4
        andc    $far_b,$to_b,$k_sign
        shufb   $u,$u,$c,$m_third
        andc    $far_c,$to_c,$k_sign
        rotqbyi $sum_b,$far_b,4
        fa      $sum,$sum,$far_a
        rotqbyi $sum_c,$far_c,4
        shli    $v,$u,16
        rotqbyi $far_a,$far_a,8
        fa      $sum_b,$sum_b,$far_b
        rotqbyi $far_b,$far_b,8
        fa      $sum_c,$sum_c,$far_c
        rotqbyi $far_c,$far_c,8
        rotmai  $u,$u,-16
        rotmai  $v,$v,-16
        fa      $sum,$sum,$far_a
        fa      $sum_b,$sum_b,$far_b
        fa      $sum_c,$sum_c,$far_c
        csflt   $u,$u,0
        csflt   $v,$v,0
        load_constant $k_scale,0x38000100               # 1 / 32767
        cgt     $c_more,$sum_c,$sum_b
        selb    $size,$sum_b,$sum_c,$c_more
        fm      $u,$u,$k_scale
        fm      $v,$v,$k_scale
        recip_interpolated_f4 $inverse,$size
        fa      $leave_object,$sum,$size
        ilhu    $k_one,0x3f80
        andc    $z,$u,$k_sign
        andc    $part,$v,$k_sign
        fs      $z,$k_one,$z
        splat   $inverse,$inverse,$m_splat
        fm      $leave_object,$leave_object,$k_leave
        fm      $to_b,$to_b,$inverse
        fm      $to_c,$to_c,$inverse
        fs      $z,$z,$part
        and     $head,$a,$m_xyz
        shufb   $turned_b,$to_b,$to_b,$m_next
        stqd    $head,OBJECT_centre($h_patch)
        shufb   $turned_c,$to_c,$to_c,$m_next
        stqd    $head,TRI_a($h_patch)
        rotmai  $fold,$z,-31
        fm      $normal,$turned_b,$to_c
        and     $fold,$fold,$z
        andc    $fold,$fold,$k_sign                     # what z is below 0
        and     $part,$u,$k_sign
        or      $part,$part,$fold
        fs      $u,$u,$part
        and     $part,$v,$k_sign
        fms     $normal,$to_b,$turned_c,$normal
        or      $part,$part,$fold
        fs      $v,$v,$part
        and     $head,$b,$m_xyz
        stqd    $head,TRI_b($h_patch)
        fm      $squares,$u,$u
        shufb   $normal,$normal,$normal,$m_next
        and     $head,$c,$m_xyz
        stqd    $head,TRI_c($h_patch)
        fm      $square,$normal,$normal
        fma     $squares,$v,$v,$squares
        cwd     $m_lane,12($sp)
        rotqbyi $t_y,$square,4
        rotqbyi $t_e,$square,8
        fa      $square,$square,$t_y
        fma     $squares,$z,$z,$squares
        fa      $square,$square,$t_e
        # One root for all four.
        shufb   $squares,$square,$squares,$m_lane
        rsqrt_interpolated_f4 $t_y,$squares
        lqa     $m_lane,object_end
        shufb   $leave_object,$leave_object,$counts,$m_lane
        put_head $leave_object
        rsqrt_step_f4 $inverse,$squares,$t_y,$t_e,$k_half,$k_one
        rotqbyi $part,$counts,MESH_HEADER_sides&15
        ilhu    $size,SIDES_TEXTURED>>16
        and     $textured,$part,$size
        fm      $u,$u,$inverse
        rotqbyi $t_y,$inverse,12
        fm      $v,$v,$inverse
        splat   $t_y,$t_y,$m_splat
        fm      $z,$z,$inverse
        fm      $normal,$normal,$t_y
    .set    lane_at,0
    .irp vertex, a,b,c
        lqa     $m_lane,lanes+lane_at
        lqa     $m_third,lanes+lane_at+16
        shufb   $part,$u,$v,$m_lane
        shufb   $part,$part,$z,$m_third
        stqd    $part,PATCH_normal_\vertex($h_patch)
    .set    lane_at,lane_at+32
    .endr
        hbrr    plain,next_hit
        # The record of a plane through a.
        selb    $normal,$k_one,$normal,$m_xyz           # 1 is the slope
        stqd    $normal,OBJECT_axis($h_patch)
        ai      $h_patch,$h_patch,PATCH_SIZE
plain:  brz     $textured,next_hit

        # Its texture coordinates, which begin at the quadword after the faces. The vertices'
        # offsets have turned by two words.
        rotqbyi $part,$counts,MESH_HEADER_triangles&15
        ai      $part,$part,3
        andi    $part,$part,-4
        shli    $part,$part,2
        a       $places,$a_faces,$part
        rotmi   $index,$face,-1
        rotqbyi $index,$index,8
        cwd     $m_lane,12($sp)
        hbrr    has_texture,next_hit
    .irp vertex, a,b,c
        a       $address,$places,$index
        lqd     $u,0($address)
        lqd     $part,TRI_\vertex-PATCH_SIZE($h_patch)
        lqd     $z,PATCH_normal_\vertex-PATCH_SIZE($h_patch)
        rotqby  $u,$u,$address
        rotqbyi $v,$u,4
        shufb   $part,$u,$part,$m_lane
        shufb   $z,$v,$z,$m_lane
        rotqbyi $index,$index,4
        stqd    $part,TRI_\vertex-PATCH_SIZE($h_patch)
        stqd    $z,PATCH_normal_\vertex-PATCH_SIZE($h_patch)
    .endr
has_texture:
        br      next_hit

        # The record of a sphere or a cone, whose number is its offset in quadwords. It has how far
        # it extends beyond its offset as `leave`, and the number of its material. Shading needs no
        # more of a cone than of a sphere.
object: shli    $index,$index,4
        a       $address,$h_block,$index
        lqd     $a,OBJECT_centre($address)
        lqd     $b,OBJECT_axis($address)
        lqd     $c,OBJECT_offset($address)
        stqd    $a,OBJECT_centre($h_patch)
        stqd    $b,OBJECT_axis($h_patch)
        taxicab $sum,$a,$t_e
        andc    $size,$c,$k_sign
        rotqbyi $part,$c,OBJECT_leave&15
        fa      $leave_object,$sum,$size
        fa      $leave_object,$leave_object,$part
        fm      $leave_object,$leave_object,$k_leave
        cwd     $m_lane,OBJECT_leave&15($sp)
        shufb   $c,$leave_object,$c,$m_lane
        rotqbyi $material,$c,OBJECT_material&15
        put_head $c
        ai      $h_patch,$h_patch,PATCH_SIZE
        br      next_hit

all_made:
        # As leave does, but the test waits for nothing else.
        lqa     $address,after_hits
        ai      $sp,$sp,32
        lqd     $lr,16($sp)
        binz    $address,$address
        bi      $lr
endfunction mesh_hits
