# mesh_flat_patches   the patches of hit triangles of a mesh, for those whose leaves are known
#   C       struct mesh_hit *mesh_flat_patches(struct patch *, int count, const struct mesh_leaf *,
#                                              struct mesh_hit *, const struct material *);
#   In      $3 patches as mesh_list_hits_r16 leaves them, with space for three more, $4 how many
#           fours of them (0 is none), with 0 as the objects after the last, $5 MESH_LEAF_PLACES
#           leaves, $6 where the list goes, $7 the mesh's first material; pointers 16-aligned
#   Out     OBJECT_centre to OBJECT_sides of the patches; the patches after the last get anything
#           the list: the hits whose leaves are not there, in order; four more may be written
#           $3 end of the list
#   Uses    $3-$7, $10-$79   Saves  -   Stack  0   Calls  -
#   Domain  coordinates below 2^60, edges from 2^-60 on
#   Error   16 ulp of 1 in the normal of a triangle whose area is above 1/40 of its longest edge's
#           square; 3e-4 of leave
#   Twin    lab/twins/src/mesh_patches.rs
#
# The loop counts up, so that it isn't pipelined. Pipelined it would take 129 cycles for four
# triangles instead of 261, but 4.9 KB of local store instead of 1.1, where the cache loses two
# blocks.
#
# Four triangles are in the four lanes. The normal is (b - a) x (c - a), with the edges made about
# 1 long before. A patch that the list has gets anything.

        .include "work_unit.inc"
        .include "macros.inc"
        .include "math.inc"
        .include "reciprocal.inc"
        .include "transpose.inc"
        .include "mesh_block.inc"

        .set    NEXT,3
        registers a_first,fours,a_table,a_list,a_materials
        # constants
        .set    NEXT,10
        registers m_first,m_last                        # of transpose
        registers m_upper,k_places,k_sign,k_half,k_one,k_leave,k_zero,m_xyz,k_patches,m_splat
        registers m_hit                                 # to 25
        .set    NEXT,m_hit+4
        # state
        registers a_patch
        registers found                                 # bytes of the list so far
        # the triangles
        registers row                                   # to 31
        .set    NEXT,row+4
        registers words                                 # to 35
        .set    NEXT,words+4
        registers leaf                                  # to 39: number, vertices, faces, sides
        .set    NEXT,leaf+4
        registers vertex                                # to 43
        .set    NEXT,vertex+4
        registers object,number,offset,index,face,c_missing,step,hit,patch
        registers xa,ya,za,xb,yb,zb,xc,yc,zc
        registers size,size_b,size_c,t,t_e,c_more,inverse,leave,square
        registers nx,ny,nz
        .set    material,number
        .set    centre,hit

        transpose_table .rodata.mesh
upper_halves:
        .int    0x00010203,0x04050607,0x10111213,0x14151617
hit_words:                              # an object, its patch
    .irp lane, 0,1,2,3
        .int    0x00010203+0x04040404*\lane,0x10111213+0x04040404*\lane,0x80808080,0x80808080
    .endr
patches:                                # of four triangles, from the first one on
        .int    0,PATCH_SIZE,2*PATCH_SIZE,3*PATCH_SIZE

# The first words of four registers.
.macro  first_words out:req, of:req
        shufb   $words,$\of,$\of+1,$m_first
        shufb   $words+1,$\of+2,$\of+3,$m_first
        shufb   \out,$words,$words+1,$m_upper
.endm

# Loads a quadword for each lane of addresses.
.macro  load_lanes out:req, addresses:req
        lqd     $\out,0(\addresses)
    .irp lane, 1,2,3
        rotqbyi $\out+\lane,\addresses,4*\lane
        lqd     $\out+\lane,0($\out+\lane)
    .endr
.endm

# Loads the vertices that bits of faces name, from their bit `shift` on, and turns them.
.macro  load_vertices x:req, y:req, z:req, shift:req
        rotmi   $offset,$face,-(\shift)
        and     $offset,$offset,$k_places
        a       $offset,$offset,$leaf+1
        load_lanes vertex,$offset
        shufb   $words,$vertex,$vertex+2,$m_first
        shufb   $words+1,$vertex+1,$vertex+3,$m_first
        shufb   $words+2,$vertex,$vertex+2,$m_last
        shufb   $words+3,$vertex+1,$vertex+3,$m_last
        shufb   \x,$words,$words+1,$m_first
        shufb   \y,$words,$words+1,$m_last
        shufb   \z,$words+2,$words+3,$m_first
.endm

# out = |x| + |y| + |z|
.macro  taxicab out:req, x:req, y:req, z:req, t:req
        andc    \out,\x,$k_sign
        andc    \t,\y,$k_sign
        fa      \out,\out,\t
        andc    \t,\z,$k_sign
        fa      \out,\out,\t
.endm

# Stores the columns of four registers to a field of four patches.
.macro  put_quads of:req, field:req
        transpose row,\of,words,$m_first,$m_last
    .irp lane, 0,1,2,3
        stqd    $row+\lane,\field+PATCH_SIZE*\lane($a_patch)
    .endr
.endm

function mesh_flat_patches
        ori     $a_patch,$a_first,0
        il      $found,0
        ori     $3,$a_list,0
        biz     $fours,$lr
        sfi     $fours,$fours,0
        lqa     $m_first,transpose_first
        lqa     $m_last,transpose_last
        lqa     $m_upper,upper_halves
        lqa     $k_patches,patches
        splat_mask $m_splat
    .irp lane, 0,1,2,3
        lqa     $m_hit+\lane,hit_words+16*\lane
    .endr
        il      $k_places,0xff0
        ilhu    $k_sign,0x8000
        ilhu    $k_half,0x3f00
        ilhu    $k_one,0x3f80
        ilhu    $k_leave,0x3600                         # 2^-19
        il      $k_zero,0
        fsmbi   $m_xyz,0xfff0
        splat   $a_materials,$a_materials,$m_splat
next_four:
    .irp lane, 0,1,2,3
        lqd     $vertex+\lane,PATCH_SIZE*\lane($a_patch)
    .endr
        first_words $object,vertex
        # Their leaves.
        shli    $number,$object,1
        rotmi   $number,$number,-8
        leaf_place $offset,$number
    .irp lane, 0,1,2,3
        rotqbyi $row+\lane,$offset,4*\lane
        lqx     $row+\lane,$row+\lane,$a_table
    .endr
        transpose leaf,row,words,$m_first,$m_last
        ceq     $c_missing,$leaf,$number
        cgti    $step,$object,-1
        nor     $c_missing,$c_missing,$step
        # The missing ones go to the list.
        splat   $patch,$a_patch,$m_splat
        a       $patch,$patch,$k_patches
        andi    $step,$c_missing,MESH_HITS_SIZE
    .irp lane, 0,1,2,3
        shufb   $hit,$object,$patch,$m_hit+\lane
        stqx    $hit,$a_list,$found
        rotqbyi $hit,$step,4*\lane
        a       $found,$found,$hit
    .endr
        # Their faces.
        andi    $index,$object,127
        shli    $index,$index,2
        a       $index,$index,$leaf+2
        load_lanes vertex,$index
    .irp lane, 0,1,2,3
        rotqbyi $row+\lane,$index,4*\lane
        rotqby  $vertex+\lane,$vertex+\lane,$row+\lane
    .endr
        first_words $face,vertex
        load_vertices $xb,$yb,$zb,12
        load_vertices $xc,$yc,$zc,4
        load_vertices $xa,$ya,$za,20
    .irp lane, 0,1,2,3
        and     $centre,$vertex+\lane,$m_xyz
        stqd    $centre,OBJECT_centre+PATCH_SIZE*\lane($a_patch)
    .endr
    .irp axis, x,y,z
        fs      $\axis\()b,$\axis\()b,$\axis\()a
        fs      $\axis\()c,$\axis\()c,$\axis\()a
    .endr
        taxicab $size,$xa,$ya,$za,$t
        taxicab $size_b,$xb,$yb,$zb,$t
        taxicab $size_c,$xc,$yc,$zc,$t
        cgt     $c_more,$size_c,$size_b
        selb    $size_b,$size_b,$size_c,$c_more
        recip_interpolated_f4 $inverse,$size_b
        fa      $leave,$size,$size_b
        fm      $leave,$leave,$k_leave
    .irp axis, x,y,z
        fm      $\axis\()b,$\axis\()b,$inverse
        fm      $\axis\()c,$\axis\()c,$inverse
    .endr
        fm      $nx,$zb,$yc
        fms     $nx,$yb,$zc,$nx
        fm      $ny,$xb,$zc
        fms     $ny,$zb,$xc,$ny
        fm      $nz,$yb,$xc
        fms     $nz,$xb,$yc,$nz
        fm      $square,$nx,$nx
        fm      $t,$ny,$ny
        fa      $square,$square,$t
        fm      $t,$nz,$nz
        fa      $square,$square,$t
        rsqrt_interpolated_f4 $t,$square
        rsqrt_step_f4 $inverse,$square,$t,$t_e,$k_half,$k_one
        fm      $vertex,$nx,$inverse
        fm      $vertex+1,$ny,$inverse
        fm      $vertex+2,$nz,$inverse
        ori     $vertex+3,$k_one,0                      # the slope
        put_quads vertex,OBJECT_axis
        andi    $material,$face,0xff
        mpyi    $material,$material,MATERIAL_SIZE
        ori     $leaf,$k_zero,0
        ori     $leaf+1,$leave,0
        a       $leaf+2,$material,$a_materials
        put_quads leaf,OBJECT_offset
    .rept   2                                           # ai reaches to 511
        ai      $a_patch,$a_patch,2*PATCH_SIZE
    .endr
        ai      $fours,$fours,1
        brnz    $fours,next_four
        a       $3,$a_list,$found
        bi      $lr
endfunction mesh_flat_patches
