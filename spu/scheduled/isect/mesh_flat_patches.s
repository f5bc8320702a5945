# mesh_flat_patches   the patches of hit triangles of a mesh, for those whose leaves are known
#   C       struct mesh_hit *mesh_flat_patches(struct patch *, int count, const struct mesh_leaf *,
#                                              struct mesh_hit *, const struct material *);
#   In      $3 patches as mesh_list_hits_r16 leaves them, with room for three more, $4 how many
#           fours of them (0 is none), with 0 as the objects behind the last, $5 MESH_LEAF_PLACES
#           leaves, $6 where the list goes, $7 the mesh's first material; pointers 16-aligned
#   Out     OBJECT_centre to OBJECT_sides of the patches; the patches behind the last get anything
#           the list: the hits whose leaves are not there, in order; four more may be written
#           $3 behind the list
#   Uses    $2-$77, $79   Saves  -   Stack  0   Calls  -
#   Domain  coordinates below 2^60, edges from 2^-60 on
#   Error   4e-7 in the normal of a triangle whose area is above 1/20 of its longest edge's square;
#           3e-4 of leave
#   Twin    lab/twins/src/mesh_patches.rs
#
# Four triangles are in the four lanes. The normal is (b - a) x (c - a), with the edges made about 1
# long before. A patch that the list has gets anything.
# Scheduled by spu schedule from mesh_flat_patches.s

        .include "work_unit.inc"
        .include "macros.inc"
        .include "math.inc"
        .include "reciprocal.inc"
        .include "transpose.inc"

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
        .set fours_2,79; .set a_patch_2,77; .set vertex1_2,34; .set a_patch_3,3; .set vertex_2,33
        .set a_patch_4,8; .set vertex3_2,35; .set leaf_2,9; .set vertex2_2,32; .set a_patch_5,28
        .set patch_2,29; .set a_patch_6,2; .set a_patch_7,30; .set words_2,33; .set a_patch_8,75
        .set words1_2,32; .set a_patch_9,76; .set leaf_3,38; .set object_2,50; .set a_patch_10,74
        .set vertex3_3,70; .set material_2,32; .set index_2,30; .set centre_2,31; .set step_2,69
        .set centre_3,33; .set index_3,67; .set centre_4,36; .set material_3,71; .set row_2,32
        .set row3_2,34; .set row1_2,35; .set words2_2,37; .set words3_2,30; .set words1_3,34
        .set leaf2_2,35; .set leaf_4,39; .set leaf1_2,32; .set leaf3_2,30; .set row1_3,34
        .set row2_2,39; .set row3_3,35; .set row_3,37; .set centre_5,34; .set words1_4,35
        .set words_3,40; .set centre_6,44; .set centre_7,37; .set found_2,34; .set face_2,27
        .set found_3,41; .set found_4,31; .set offset_2,33; .set offset_3,39; .set material_4,27
        .set offset_4,34; .set offset_5,32; .set vertex_3,34; .set vertex_4,35; .set vertex3_4,37
        .set vertex2_3,39; .set vertex1_3,42; .set vertex3_5,44; .set leaf2_3,27; .set vertex2_4,45
        .set vertex1_4,46; .set vertex3_6,47; .set vertex_5,48; .set vertex2_5,49
        .set vertex1_5,50; .set words1_5,45; .set words_4,46; .set vertex1_6,47; .set vertex2_6,48
        .set centre_8,49; .set vertex1_7,33; .set index_4,46; .set words_5,52; .set words_6,45
        .set centre_9,53; .set words1_6,54; .set words1_7,46; .set words_7,55; .set offset_6,56
        .set words1_8,57; .set xa_2,58; .set xb_2,45; .set row2_3,48; .set row1_4,51
        .set row3_4,59; .set xb_3,60; .set words3_3,44; .set yb_2,45; .set xc_2,46; .set yc_2,47
        .set row_4,52; .set words2_3,32; .set xc_3,35; .set words3_4,42; .set yc_3,43
        .set words3_5,33; .set t_2,32; .set row1_5,3; .set row_5,39; .set row2_4,32; .set row3_5,33
        .set t_3,34; .set words_8,37; .set words3_6,39; .set t_4,36; .set centre_10,3; .set t_5,40
        .set words2_4,9; .set leaf_5,40; .set centre_11,41; .set leaf3_3,45; .set vertex3_7,27
        .set vertex1_8,29; .set row_6,34; .set row1_6,44; .set inverse_2,46; .set inverse_3,33
        .set leaf1_3,34; .set words1_9,27; .set words1_10,39; .set found_5,29; .set row1_7,31
        .set row2_5,34; .set found_6,42; .set row3_6,9; .set offset_7,3; .set centre_12,9
        .set vertex1_9,28; .set vertex2_7,29; .set offset_8,30; .set vertex_6,31
        .set vertex1_10,32; .set vertex2_8,33; .set nx_2,48; .set vertex2_9,8; .set material_5,35
        .set vertex1_11,37; .set vertex_7,39; .set vertex3_8,42; .set vertex2_10,46
        .set square_2,47; .set vertex1_12,51; .set vertex3_9,30; .set vertex1_13,49
        .set leaf2_4,44; .set words_9,9; .set words1_11,8; .set t_6,28; .set vertex3_10,52
        .set square_3,30; .set vertex2_11,35; .set centre_13,42; .set vertex3_11,8
        .set vertex2_12,3; .set material_6,51; .set words1_12,53; .set square_4,37; .set index_5,28
        .set vertex3_12,39; .set centre_14,29; .set words2_5,42; .set words_10,30; .set words_11,35
        .set words1_13,51; .set words3_7,52; .set words2_6,3; .set t_7,8; .set words3_8,9
        .set words_12,3; .set t_8,30; .set leaf_6,8; .set centre_15,28; .set centre_16,8
        .set inverse_4,30; .set row3_7,32; .set row_7,33; .set leaf1_4,33; .set words1_14,30
        .set words3_9,32; .set row1_8,41; .set row2_6,43; .set words3_10,28; .set words_13,43
        .set words2_7,39; .set row_8,3; .set face_3,31; .set row1_9,33; .set row3_8,40; .set t_9,3
        .set row_9,42; .set row2_7,28; .set offset_9,8; .set offset_10,9; .set material_7,28
        .set vertex_8,29; .set vertex3_13,32; .set vertex1_14,3; .set vertex1_15,30
        .set vertex3_14,9; .set leaf_7,4; .set vertex3_15,18; .set a_patch_11,34
        .set a_patch_12,35; .set words2_8,8; .set words3_11,31; .set t_10,33; .set row2_8,8
        .set t_11,2; .set row2_9,3; .set row_10,9; .set t_12,5; .set words_14,2; .set words2_9,5
        .set words3_12,20; .set c_more_2,3; .set leaf_8,21; .set leave_2,22; .set inverse_5,23
        .set step_3,21; .set inverse_6,22; .set vertex1_16,23; .set vertex2_13,24; .set row2_10,31
        .set leaf1_5,36; .set words1_15,29; .set found_7,22; .set words3_13,23; .set row2_11,24
        .set row_11,2; .set offset_11,12; .set row2_12,2; .set row3_9,5; .set square_5,13
        .set material_8,2; .set vertex1_17,5; .set vertex1_18,22; .set vertex3_16,24
        .set vertex2_14,27; .set vertex_9,2; .set vertex2_15,5; .set vertex2_16,7; .set words_15,12
        .set centre_17,13; .set centre_18,22; .set words_16,23; .set centre_19,19; .set words3_14,3
        .set words2_10,2; .set words3_15,7; .set t_13,12; .set centre_20,2; .set words_17,5
        .set inverse_7,2; .set words1_16,4; .set words1_17,2; .set row2_13,6; .set square_6,5
        .set square_7,4; .set vertex3_17,3; .set leaf_9,28; .set vertex3_18,28; .set row_12,29
        .set row1_10,30; .set found_8,3; .set vertex1_19,31; .set vertex3_19,33; .set vertex_10,3
        .set vertex_11,8; .set words_18,34; .set centre_21,46; .set words_19,47; .set centre_22,48
        .set words1_18,49
        ori     $a_patch,$a_first,0                     # 0e
        il      $found,0                                # 1e
        ori     $a_first,$a_list,0                      # 2e
        biz     $fours,$lr                              # 2o
        ila     $m_splat,0x10203                        # 3e
        lqa     $m_first,transpose_first                # 3o
        clgti   $fours_2,$fours,3                       # 4e at least as many passes as overlap
        lqa     $m_last,transpose_last                  # 4o
        il      $k_places,0xff0                         # 5e
        lqa     $m_upper,upper_halves                   # 5o
        ilhu    $k_sign,0x8000                          # 6e
        lqa     $k_patches,patches                      # 6o
        ilhu    $k_half,0x3f00                          # 7e
        lqa     $m_hit,hit_words                        # 7o
        ilhu    $k_one,0x3f80                           # 8e
        lqa     $m_hit+1,hit_words+16                   # 8o
        ilhu    $k_leave,0x3580                         # 9e 2^-20
        lqa     $m_hit+2,hit_words+32                   # 9o
        il      $k_zero,0                               # 10e
        lqa     $m_hit+3,hit_words+48                   # 10o
        fsmbi   $m_xyz,0xfff0                           # 11o
        shufb   $a_materials,$a_materials,$a_materials,$m_splat # 12o
        nop     $127                                    # 13e pairing
        brz     $fours_2,next_four_short                # 13o too few passes
        ai      $a_patch_2,$a_patch,288                 # 14e
        lqd     $vertex1_2,144($a_patch)                # 14o
        ori     $a_patch_3,$a_patch,0                   # 15e copy
        lqd     $vertex_2,0($a_patch)                   # 15o
        ai      $a_patch_4,$a_patch_2,288               # 16e
        lqd     $vertex3_2,432($a_patch)                # 16o
        ori     $leaf_2,$k_zero,0                       # 17e
        lqd     $vertex2_2,288($a_patch)                # 17o
        ori     $a_patch_5,$a_patch,0                   # 18e copy
        shufb   $patch,$a_patch,$a_patch,$m_splat       # 18o
        ai      $a_patch_2,$a_patch_4,288               # 19e
        shufb   $patch_2,$a_patch_4,$a_patch_4,$m_splat # 19o
        ori     $a_patch_6,$a_patch_4,0                 # 20e copy
        shlqbyi $a_patch_7,$a_patch,0                   # 20o copy
        ai      $fours,$fours,-1                        # 21e
        shufb   $words_2,$vertex_2,$vertex1_2,$m_first  # 21o
        a       $patch,$patch,$k_patches                # 22e
        shlqbyi $a_patch_8,$a_patch_4,0                 # 22o copy
        a       $patch_2,$patch_2,$k_patches            # 23e
        shufb   $words1_2,$vertex2_2,$vertex3_2,$m_first # 23o
        ai      $fours,$fours,-1                        # 24e
        ori     $a_patch_9,$a_patch_4,0                 # 25e copy
        ai      $fours,$fours,-1                        # 26e
        lnop                                            # 26o pairing
        ori     $leaf_3,$k_zero,0                       # 27e
        shufb   $object_2,$words_2,$words1_2,$m_upper   # 27o
        ori     $a_patch_10,$a_patch_7,0                # 28e copy
        ori     $vertex3_3,$k_one,0                     # 29e the slope
        shli    $material_2,$object_2,1                 # 31e
        shufb   $centre,$object_2,$patch,$m_hit         # 31o
        andi    $index_2,$object_2,127                  # 32e
        shufb   $centre_2,$object_2,$patch,$m_hit+2     # 32o
        cgti    $step_2,$object_2,-1                    # 33e
        shufb   $centre_3,$object_2,$patch,$m_hit+1     # 33o
        shli    $index_3,$index_2,2                     # 34e
        shufb   $centre_4,$object_2,$patch,$m_hit+3     # 34o
        rotmi   $material_3,$material_2,-8              # 35e
        andi    $offset,$material_3,31                  # 39e
        shli    $offset,$offset,4                       # 41e
        rotqbyi $row+2,$offset,8                        # 45o
        rotqbyi $row_2,$offset,0                        # 46o
        rotqbyi $row3_2,$offset,12                      # 47o
        rotqbyi $row1_2,$offset,4                       # 48o
        lqx     $row+2,$row+2,$a_table                  # 49o
        lqx     $row_2,$row_2,$a_table                  # 50o
        lqx     $row3_2,$row3_2,$a_table                # 51o
        lqx     $row1_2,$row1_2,$a_table                # 52o
        shufb   $words2_2,$row_2,$row+2,$m_last         # 56o
        shufb   $words,$row_2,$row+2,$m_first           # 57o
        shufb   $words3_2,$row1_2,$row3_2,$m_last       # 58o
        shufb   $words1_3,$row1_2,$row3_2,$m_first      # 59o
        shufb   $leaf2_2,$words2_2,$words3_2,$m_first   # 62o
        shufb   $leaf_4,$words,$words1_3,$m_first       # 63o
        shufb   $leaf1_2,$words,$words1_3,$m_last       # 64o
        shufb   $leaf3_2,$words2_2,$words3_2,$m_last    # 65o
        a       $index,$index_3,$leaf2_2                # 66e
        ceq     $c_missing,$leaf_4,$material_3          # 67e
        rotqbyi $vertex+1,$index,4                      # 68o
        nor     $c_missing,$c_missing,$step_2           # 69e
        rotqbyi $vertex+3,$index,12                     # 69o
        nop     $127                                    # 70e pairing
        rotqbyi $vertex+2,$index,8                      # 70o
        andi    $step,$c_missing,16                     # 71e
        rotqbyi $row1_3,$index,4                        # 71o
        lqd     $vertex+1,0($vertex+1)                  # 72o
        lqd     $vertex+3,0($vertex+3)                  # 73o
        stqx    $centre,$a_list,$found                  # 74o
        lqd     $vertex+2,0($vertex+2)                  # 75o
        lqd     $vertex,0($index)                       # 76o
        rotqbyi $row2_2,$index,8                        # 77o
        rotqbyi $row3_3,$index,12                       # 78o
        rotqbyi $row_3,$index,0                         # 79o
        rotqby  $vertex+1,$vertex+1,$row1_3             # 80o
        rotqby  $vertex+2,$vertex+2,$row2_2             # 81o
        rotqby  $vertex+3,$vertex+3,$row3_3             # 82o
        rotqby  $vertex,$vertex,$row_3                  # 83o
        rotqbyi $centre,$step,0                         # 84o
        rotqbyi $centre_5,$step,4                       # 85o
        shufb   $words1_4,$vertex+2,$vertex+3,$m_first  # 86o
        shufb   $words_3,$vertex,$vertex+1,$m_first     # 87o
        a       $found,$found,$centre                   # 88e
        rotqbyi $centre_6,$step,8                       # 88o
        nop     $127                                    # 89e pairing
        rotqbyi $centre_7,$step,12                      # 89o
        a       $found_2,$found,$centre_5               # 90e
        stqx    $centre_3,$a_list,$found                # 90o
        nop     $127                                    # 91e pairing
        shufb   $face_2,$words_3,$words1_4,$m_upper     # 91o
        a       $found_3,$found_2,$centre_6             # 92e
        stqx    $centre_2,$a_list,$found_2              # 92o
        a       $found_4,$found_3,$centre_7             # 94e
        rotmi   $offset,$face_2,-20                     # 95e
        rotmi   $offset_2,$face_2,-4                    # 96e
        rotmi   $offset_3,$face_2,-12                   # 97e
        andi    $material_4,$face_2,255                 # 98e
        and     $offset,$offset,$k_places               # 99e
        and     $offset_2,$offset_2,$k_places           # 100e
        a       $offset,$offset,$leaf1_2                # 101e
        and     $offset_4,$offset_3,$k_places           # 102e
        lnop                                            # 102o pairing
        a       $offset_2,$offset_2,$leaf1_2            # 103e
        lqd     $vertex,0($offset)                      # 103o
        a       $offset_5,$offset_4,$leaf1_2            # 104e
        rotqbyi $vertex+3,$offset,12                    # 104o
        mpyi    $material_4,$material_4,96              # 105e
        lqd     $vertex_3,0($offset_2)                  # 105o
        lqd     $vertex_4,0($offset_5)                  # 106o
        rotqbyi $vertex3_4,$offset_2,12                 # 107o
        nop     $127                                    # 108e pairing
        rotqbyi $vertex2_3,$offset,8                    # 108o
        and     $centre,$vertex,$m_xyz                  # 109e
        rotqbyi $vertex1_3,$offset,4                    # 109o
        rotqbyi $vertex3_5,$offset_5,12                 # 110o
        stqd    $centre,0($a_patch)                     # 111o
        a       $leaf2_3,$material_4,$a_materials       # 112e
        lqd     $vertex2_4,288($a_patch_4)              # 112o
        ai      $a_patch,$a_patch_2,288                 # 113e
        lqd     $vertex1_4,144($a_patch_4)              # 113o
        nop     $127                                    # 114e pairing
        lqd     $vertex3_6,432($a_patch_4)              # 114o
        ai      $a_patch_2,$a_patch,288                 # 115e
        lqd     $vertex_5,0($a_patch_4)                 # 115o
        rotqbyi $vertex2_5,$offset_2,8                  # 116o
        rotqbyi $vertex1_5,$offset_5,4                  # 117o
        rotqbyi $vertex2_2,$offset_5,8                  # 118o
        lqd     $vertex2_3,0($vertex2_3)                # 119o
        shufb   $words1_5,$vertex2_4,$vertex3_6,$m_first # 120o
        shufb   $words_4,$vertex_5,$vertex1_4,$m_first  # 121o
        lqd     $vertex1_6,0($vertex1_5)                # 122o
        lqd     $vertex2_6,0($vertex2_5)                # 123o
        nop     $127                                    # 124e pairing
        lqd     $vertex3_4,0($vertex3_4)                # 124o
        and     $centre_8,$vertex2_3,$m_xyz             # 125e
        shufb   $object_2,$words_4,$words1_5,$m_upper   # 125o
        lqd     $vertex1_3,0($vertex1_3)                # 126o
        rotqbyi $vertex1_7,$offset_2,4                  # 127o
        nop     $127                                    # 128e pairing
        lqd     $vertex+3,0($vertex+3)                  # 128o
        shli    $material,$object_2,1                   # 129e
        lqd     $vertex3_5,0($vertex3_5)                # 129o
        andi    $index_4,$object_2,127                  # 130e
        lqd     $vertex2_2,0($vertex2_2)                # 130o
        cgti    $step_2,$object_2,-1                    # 131e
        lqd     $vertex1_7,0($vertex1_7)                # 131o
        and     $centre,$vertex1_3,$m_xyz               # 132e
        shufb   $words_5,$vertex_3,$vertex2_6,$m_first  # 132o
        rotmi   $material_3,$material,-8                # 133e
        shufb   $words_6,$vertex,$vertex2_3,$m_first    # 133o
        and     $centre_9,$vertex+3,$m_xyz              # 134e
        shufb   $words1_6,$vertex1_3,$vertex+3,$m_first # 134o
        shli    $index_3,$index_4,2                     # 135e
        shufb   $words1_7,$vertex1_6,$vertex3_5,$m_first # 135o
        nop     $127                                    # 136e pairing
        shufb   $words_7,$vertex_4,$vertex2_2,$m_first  # 136o
        andi    $offset_6,$material_3,31                # 137e
        shufb   $words1_8,$vertex1_7,$vertex3_4,$m_first # 137o
        nop     $127                                    # 138e pairing
        shufb   $xa_2,$words_6,$words1_6,$m_first       # 138o
        shli    $offset_6,$offset_6,4                   # 139e
        shufb   $ya,$words_6,$words1_6,$m_last          # 139o
        shufb   $words+2,$vertex_3,$vertex2_6,$m_last   # 140o
        stqd    $centre,144($a_patch_3)                 # 141o
        andc    $size,$xa_2,$k_sign                     # 142e
        shufb   $xb_2,$words_7,$words1_7,$m_first       # 142o
        andc    $t,$ya,$k_sign                          # 143e
        rotqbyi $row2_3,$offset_6,8                     # 143o
        nop     $127                                    # 144e pairing
        rotqbyi $row1_4,$offset_6,4                     # 144o
        fa      $size,$size,$t                          # 145e
        rotqbyi $row3_4,$offset_6,12                    # 145o
        fs      $xb_3,$xb_2,$xa_2                       # 146e
        shufb   $words3_3,$vertex1_6,$vertex3_5,$m_last # 146o
        shufb   $yb_2,$words_7,$words1_7,$m_last        # 147o
        shufb   $xc_2,$words_5,$words1_8,$m_first       # 148o
        shufb   $yc_2,$words_5,$words1_8,$m_last        # 149o
        rotqbyi $row_4,$offset_6,0                      # 150o
        fs      $yb,$yb_2,$ya                           # 151e
        shufb   $words2_3,$vertex_4,$vertex2_2,$m_last  # 151o
        fs      $xc_3,$xc_2,$xa_2                       # 152e
        shufb   $words3_4,$vertex1_3,$vertex+3,$m_last  # 152o
        fs      $yc_3,$yc_2,$ya                         # 153e
        shufb   $words3_5,$vertex1_7,$vertex3_4,$m_last # 153o
        andc    $size_b,$xb_3,$k_sign                   # 154e
        shufb   $words2_2,$vertex,$vertex2_3,$m_last    # 154o
        shufb   $zb,$words2_3,$words3_3,$m_first        # 155o
        stqd    $centre_8,288($a_patch_3)               # 156o
        andc    $t_2,$yb,$k_sign                        # 157e
        stqd    $centre_9,432($a_patch_3)               # 157o
        andc    $size_c,$xc_3,$k_sign                   # 158e
        lqx     $row1_5,$row1_4,$a_table                # 158o
        andc    $t,$yc_3,$k_sign                        # 159e
        lqx     $row_5,$row_4,$a_table                  # 159o
        fa      $size_b,$size_b,$t_2                    # 160e
        shufb   $za,$words2_2,$words3_4,$m_first        # 160o
        fa      $size_c,$size_c,$t                      # 161e
        lqx     $row2_4,$row2_3,$a_table                # 161o
        shufb   $zc,$words+2,$words3_5,$m_first         # 162o
        lqx     $row3_5,$row3_4,$a_table                # 163o
        fs      $zb,$zb,$za                             # 164e
        shufb   $centre,$object_2,$patch_2,$m_hit       # 164o
        andc    $t_3,$za,$k_sign                        # 165e
        stqx    $centre_4,$a_list,$found_3              # 165o
        fs      $zc,$zc,$za                             # 166e
        shufb   $words_8,$leaf_2,$leaf2_3,$m_first      # 166o
        fa      $size,$size,$t_3                        # 167e
        shufb   $words+2,$row_5,$row2_4,$m_last         # 167o
        shufb   $words,$row_5,$row2_4,$m_first          # 168o
        shufb   $words3_6,$row1_5,$row3_5,$m_last       # 169o
        andc    $t_4,$zb,$k_sign                        # 170e
        shufb   $words+1,$row1_5,$row3_5,$m_first       # 170o
        nop     $127                                    # 171e pairing
        shufb   $centre_10,$object_2,$patch_2,$m_hit+1  # 171o
        andc    $t_5,$zc,$k_sign                        # 172e
        shufb   $words2_4,$leaf_2,$leaf2_3,$m_last      # 172o
        fa      $size_b,$size_b,$t_4                    # 173e
        shufb   $leaf2_3,$words+2,$words3_6,$m_first    # 173o
        fa      $size_c,$size_c,$t_5                    # 174e
        shufb   $leaf_5,$words,$words+1,$m_first        # 174o
        shufb   $centre_11,$object_2,$patch_2,$m_hit+2  # 175o
        shufb   $leaf1_2,$words,$words+1,$m_last        # 176o
        a       $index,$index_3,$leaf2_3                # 177e
        shufb   $centre_4,$object_2,$patch_2,$m_hit+3   # 177o
        ceq     $c_missing,$leaf_5,$material_3          # 178e
        shufb   $leaf3_3,$words+2,$words3_6,$m_last     # 178o
        nop     $127                                    # 179e pairing
        rotqbyi $vertex3_7,$index,12                    # 179o
        cgt     $c_more,$size_c,$size_b                 # 180e
        rotqbyi $vertex1_8,$index,4                     # 180o
        nor     $c_missing,$c_missing,$step_2           # 181e
        rotqbyi $vertex+2,$index,8                      # 181o
        selb    $size_b,$size_b,$size_c,$c_more         # 182e
        rotqbyi $row2_2,$index,8                        # 182o
        andi    $step,$c_missing,16                     # 183e
        lqd     $vertex3_7,0($vertex3_7)                # 183o
        fa      $leave,$size,$size_b                    # 184e
        lqd     $vertex1_8,0($vertex1_8)                # 184o
        stqx    $centre,$a_list,$found_4                # 185o
        lqd     $vertex,0($index)                       # 186o
        lqd     $vertex+2,0($vertex+2)                  # 187o
        rotqbyi $row3_5,$index,12                       # 188o
        nop     $127                                    # 189e pairing
        rotqbyi $row_6,$index,0                         # 189o
        fm      $leave,$leave,$k_leave                  # 190e
        rotqbyi $row1_6,$index,4                        # 190o
        frest   $inverse_2,$size_b                      # 191o
        rotqby  $vertex3_7,$vertex3_7,$row3_5           # 192o
        rotqby  $vertex+2,$vertex+2,$row2_2             # 193o
        rotqby  $vertex1_8,$vertex1_8,$row1_6           # 194o
        fi      $inverse_3,$size_b,$inverse_2           # 195e
        rotqby  $vertex,$vertex,$row_6                  # 195o
        ori     $leaf1_3,$leave,0                       # 196e
        rotqbyi $centre,$step,0                         # 196o
        shufb   $words1_9,$vertex+2,$vertex3_7,$m_first # 197o
        shufb   $words1_10,$leaf1_3,$leaf3_2,$m_first   # 198o
        nop     $127                                    # 199e pairing
        shufb   $words_3,$vertex,$vertex1_8,$m_first    # 199o
        a       $found_5,$found_4,$centre               # 200e
        shufb   $words3_2,$leaf1_3,$leaf3_2,$m_last     # 200o
        nop     $127                                    # 201e pairing
        rotqbyi $centre,$step,4                         # 201o
        fm      $zb,$zb,$inverse_3                      # 202e
        shufb   $row1_7,$words_8,$words1_10,$m_last     # 202o
        fm      $xb,$xb_3,$inverse_3                    # 203e
        shufb   $face_2,$words_3,$words1_9,$m_upper     # 203o
        fm      $zc,$zc,$inverse_3                      # 204e
        shufb   $row2_5,$words2_4,$words3_2,$m_first    # 204o
        a       $found_6,$found_5,$centre               # 205e
        shufb   $row_3,$words_8,$words1_10,$m_first     # 205o
        fm      $yc,$yc_3,$inverse_3                    # 206e
        shufb   $row3_6,$words2_4,$words3_2,$m_last     # 206o
        rotmi   $offset,$face_2,-20                     # 207e
        stqx    $centre_10,$a_list,$found_5             # 207o
        rotmi   $offset_3,$face_2,-12                   # 208e
        stqd    $row1_7,176($a_patch_5)                 # 208o
        rotmi   $offset_7,$face_2,-4                    # 209e
        stqd    $row2_5,320($a_patch_5)                 # 209o
        fm      $xc,$xc_3,$inverse_3                    # 210e
        stqd    $row_3,32($a_patch_5)                   # 210o
        and     $offset,$offset,$k_places               # 211e
        stqx    $centre_11,$a_list,$found_6             # 211o
        fm      $nx,$zb,$yc                             # 212e
        stqd    $row3_6,464($a_patch_5)                 # 212o
        a       $offset,$offset,$leaf1_2                # 213e
        rotqbyi $centre_6,$step,8                       # 213o
        fm      $ny,$xb,$zc                             # 214e
        rotqbyi $centre_12,$step,12                     # 214o
        and     $offset_7,$offset_7,$k_places           # 215e
        lqd     $vertex,0($offset)                      # 215o
        fm      $yb,$yb,$inverse_3                      # 216e
        rotqbyi $vertex1_9,$offset,4                    # 216o
        a       $offset_7,$offset_7,$leaf1_2            # 217e
        rotqbyi $vertex2_7,$offset,8                    # 217o
        and     $offset_8,$offset_3,$k_places           # 218e
        rotqbyi $vertex+3,$offset,12                    # 218o
        andi    $material_4,$face_2,255                 # 219e
        lqd     $vertex_6,0($offset_7)                  # 219o
        a       $offset_8,$offset_8,$leaf1_2            # 220e
        rotqbyi $vertex1_10,$offset_7,4                 # 220o
        and     $centre,$vertex,$m_xyz                  # 221e
        rotqbyi $vertex2_8,$offset_7,8                  # 221o
        fm      $nz,$yb,$xc                             # 222e
        lqd     $vertex_3,0($offset_8)                  # 222o
        fms     $nx_2,$yb,$zc,$nx                       # 223e
        stqd    $centre,0($a_patch_4)                   # 223o
        fms     $ny,$zb,$xc,$ny                         # 224e
        lqd     $vertex2_9,288($a_patch)                # 224o
        mpyi    $material_5,$material_4,96              # 225e
        lqd     $vertex1_11,144($a_patch)               # 225o
        a       $found_3,$found_6,$centre_6             # 226e
        lqd     $vertex_7,0($a_patch)                   # 226o
        nop     $127                                    # 227e pairing
        lqd     $vertex3_8,432($a_patch)                # 227o
        fms     $nz,$xb,$yc,$nz                         # 228e
        rotqbyi $vertex2_10,$offset_8,8                 # 228o
        fm      $square_2,$nx_2,$nx_2                   # 229e
        rotqbyi $vertex1_12,$offset_8,4                 # 229o
        fm      $t,$ny,$ny                              # 230e
        rotqbyi $vertex3_9,$offset_8,12                 # 230o
        a       $found,$found_3,$centre_12              # 231e
        lqd     $vertex1_13,0($vertex1_9)               # 231o
        a       $leaf2_4,$material_5,$a_materials       # 232e
        shufb   $words_9,$vertex_7,$vertex1_11,$m_first # 232o
        nop     $127                                    # 233e pairing
        shufb   $words1_11,$vertex2_9,$vertex3_8,$m_first # 233o
        fm      $t_6,$nz,$nz                            # 234e
        lqd     $vertex3_10,0($vertex3_9)               # 234o
        nop     $127                                    # 235e pairing
        lqd     $vertex+3,0($vertex+3)                  # 235o
        fa      $square_3,$square_2,$t                  # 236e
        lqd     $vertex2_11,0($vertex2_10)              # 236o
        and     $centre_13,$vertex1_13,$m_xyz           # 237e
        shufb   $object_2,$words_9,$words1_11,$m_upper  # 237o
        lqd     $vertex1_4,0($vertex1_12)               # 238o
        rotqbyi $vertex3_11,$offset_7,12                # 239o
        nop     $127                                    # 240e pairing
        lqd     $vertex2_12,0($vertex2_7)               # 240o
        shli    $material_6,$object_2,1                 # 241e
        shufb   $words1_12,$vertex1_13,$vertex+3,$m_first # 241o
        fa      $square_4,$square_3,$t_6                # 242e
        lqd     $vertex1_6,0($vertex1_10)               # 242o
        andi    $index_5,$object_2,127                  # 243e
        lqd     $vertex3_12,0($vertex3_11)              # 243o
        and     $centre_12,$vertex+3,$m_xyz             # 244e
        lqd     $vertex2_9,0($vertex2_8)                # 244o
        shli    $index_3,$index_5,2                     # 245e
        stqd    $centre_13,144($a_patch_6)              # 245o
        and     $centre_14,$vertex2_12,$m_xyz           # 246e
        shufb   $words2_5,$vertex_3,$vertex2_11,$m_last # 246o
        rotmi   $material_3,$material_6,-8              # 247e
        shufb   $words_10,$vertex,$vertex2_12,$m_first  # 247o
        cgti    $step_2,$object_2,-1                    # 248e
        shufb   $words_11,$vertex_3,$vertex2_11,$m_first # 248o
        shufb   $words1_13,$vertex1_4,$vertex3_10,$m_first # 249o
        shufb   $words3_7,$vertex1_4,$vertex3_10,$m_last # 250o
next_four:
        ai      $fours,$fours,-1                        # 0e
            shufb   $words,$vertex_6,$vertex2_9,$m_first # 0o
            andi    $offset,$material_3,31              # 1e
            stqd    $centre_14,288($a_patch_6)          # 1o
            nop     $127                                # 2e pairing
            stqd    $centre_12,432($a_patch_6)          # 2o
            shli    $offset,$offset,4                   # 3e
            shufb   $words+1,$vertex1_6,$vertex3_12,$m_first # 3o
            ori     $a_patch_6,$a_patch,0               # 4e copy
            shufb   $yb,$words_11,$words1_13,$m_last    # 4o
            shufb   $ya,$words_10,$words1_12,$m_last    # 5o
            shufb   $words+2,$vertex,$vertex2_12,$m_last # 6o
            shufb   $xb,$words_11,$words1_13,$m_first   # 7o
            shufb   $xc,$words,$words+1,$m_first        # 8o
            fs      $yb,$yb,$ya                         # 9e
            shufb   $words2_6,$vertex_6,$vertex2_9,$m_last # 9o
            andc    $t,$ya,$k_sign                      # 10e
            rotqbyi $row,$offset,0                      # 10o
            shufb   $yc,$words,$words+1,$m_last         # 11o
            shufb   $words+3,$vertex1_13,$vertex+3,$m_last # 12o
            shufb   $xa,$words_10,$words1_12,$m_first   # 13o
            rotqbyi $row+2,$offset,8                    # 14o
            fs      $yc,$yc,$ya                         # 15e
            rotqbyi $row+1,$offset,4                    # 15o
            andc    $t_7,$yb,$k_sign                    # 16e
            shufb   $words3_8,$vertex1_6,$vertex3_12,$m_last # 16o
            fs      $xc,$xc,$xa                         # 17e
            shufb   $za,$words+2,$words+3,$m_first      # 17o
            fs      $xb,$xb,$xa                         # 18e
            rotqbyi $row+3,$offset,12                   # 18o
            andc    $size,$xa,$k_sign                   # 19e
            lqx     $row+2,$row+2,$a_table              # 19o
            nop     $127                                # 20e pairing
            lqx     $row+1,$row+1,$a_table              # 20o
            fa      $size,$size,$t                      # 21e
            lqx     $row,$row,$a_table                  # 21o
            andc    $t,$yc,$k_sign                      # 22e
            shufb   $zc,$words2_6,$words3_8,$m_first    # 22o
            andc    $size_c,$xc,$k_sign                 # 23e
            shufb   $zb,$words2_5,$words3_7,$m_first    # 23o
            andc    $size_b,$xb,$k_sign                 # 24e
            lqx     $row+3,$row+3,$a_table              # 24o
            fa      $size_c,$size_c,$t                  # 25e
            frsqest $t,$square_4                        # 25o
            fs      $zc,$zc,$za                         # 26e
            shufb   $patch,$a_patch,$a_patch,$m_splat   # 26o
            fs      $zb,$zb,$za                         # 27e
            shufb   $words+2,$row,$row+2,$m_last        # 27o
            fa      $size_b,$size_b,$t_7                # 28e
            shufb   $words,$row,$row+2,$m_first         # 28o
            fi      $t,$square_4,$t                     # 29e
            shufb   $words_12,$leaf_3,$leaf2_4,$m_first # 29o
            a       $patch,$patch,$k_patches            # 30e
            shufb   $words+3,$row+1,$row+3,$m_last      # 30o
            andc    $t_7,$za,$k_sign                    # 31e
            shufb   $words2_4,$leaf_3,$leaf2_4,$m_last  # 31o
            andc    $t_6,$zc,$k_sign                    # 32e
            shufb   $centre,$object_2,$patch,$m_hit     # 32o
            andc    $t_8,$zb,$k_sign                    # 33e
            shufb   $words+1,$row+1,$row+3,$m_first     # 33o
            fa      $size_c,$size_c,$t_6                # 34e
            shufb   $leaf+2,$words+2,$words+3,$m_first  # 34o
            fa      $size_b,$size_b,$t_8                # 35e
            stqx    $centre_4,$a_list,$found_3          # 35o
            fm      $t_e,$square_4,$t                   # 36e
            shufb   $centre_4,$object_2,$patch,$m_hit+3 # 36o
            fa      $size,$size,$t_7                    # 37e
            shufb   $leaf_6,$words,$words+1,$m_first    # 37o
            a       $index,$index_3,$leaf+2             # 38e
            shufb   $centre_15,$object_2,$patch,$m_hit+1 # 38o
            fm      $inverse,$t,$k_half                 # 39e
            shufb   $leaf+1,$words,$words+1,$m_last     # 39o
            ori     $leaf_3,$k_zero,0                   # 40e
            rotqbyi $vertex+3,$index,12                 # 40o
            cgt     $c_more,$size_c,$size_b             # 41e
            rotqbyi $vertex+1,$index,4                  # 41o
            ceq     $c_missing,$leaf_6,$material_3      # 42e
            shufb   $centre_16,$object_2,$patch,$m_hit+2 # 42o
            selb    $size_b,$size_b,$size_c,$c_more     # 43e
            rotqbyi $vertex+2,$index,8                  # 43o
            nor     $c_missing,$c_missing,$step_2       # 44e
            rotqbyi $row+1,$index,4                     # 44o
            fa      $leave,$size,$size_b                # 45e
            frest   $inverse_4,$size_b                  # 45o
            andi    $step,$c_missing,16                 # 46e
            lqd     $vertex+3,0($vertex+3)              # 46o
            fnms    $t_e,$t_e,$t,$k_one                 # 47e
            lqd     $vertex+1,0($vertex+1)              # 47o
            nop     $127                                # 48e pairing
            rotqbyi $centre_2,$step,12                  # 48o
            fi      $inverse_4,$size_b,$inverse_4       # 49e
            stqx    $centre,$a_list,$found              # 49o
            nop     $127                                # 50e pairing
            lqd     $vertex,0($index)                   # 50o
            fm      $leave,$leave,$k_leave              # 51e
            rotqbyi $row3_7,$index,12                   # 51o
            nop     $127                                # 52e pairing
            rotqbyi $centre,$step,0                     # 52o
            fma     $inverse,$t_e,$inverse,$t           # 53e
            lqd     $vertex+2,0($vertex+2)              # 53o
            rotqbyi $row_7,$index,0                     # 54o
            rotqbyi $row2_2,$index,8                    # 55o
            fm      $zb,$zb,$inverse_4                  # 56e
            rotqbyi $centre_6,$step,8                   # 56o
            fm      $zc,$zc,$inverse_4                  # 57e
            rotqby  $vertex+1,$vertex+1,$row+1          # 57o
            fm      $yc,$yc,$inverse_4                  # 58e
            rotqby  $vertex,$vertex,$row_7              # 58o
            fm      $xb,$xb,$inverse_4                  # 59e
            rotqby  $vertex+2,$vertex+2,$row2_2         # 59o
            a       $found_5,$found,$centre             # 60e
            rotqbyi $centre,$step,4                     # 60o
            fm      $xc,$xc,$inverse_4                  # 61e
        hbrr    next_four_back,next_four                # 61o hint
            ori     $leaf1_4,$leave,0                   # 62e
            rotqby  $vertex+3,$vertex+3,$row3_7         # 62o
            fm      $yb,$yb,$inverse_4                  # 63e
            stqx    $centre_15,$a_list,$found_5         # 63o
            fm      $vertex1_9,$ny,$inverse             # 64e
            shufb   $words1_14,$leaf1_4,$leaf3_3,$m_first # 64o
            fm      $nx,$zb,$yc                         # 65e
            shufb   $words3_9,$leaf1_4,$leaf3_3,$m_last # 65o
            fm      $ny,$xb,$zc                         # 66e
            shufb   $words+1,$vertex+2,$vertex+3,$m_first # 66o
            fm      $vertex_7,$nx_2,$inverse            # 67e
            shufb   $words_3,$vertex,$vertex+1,$m_first # 67o
            fm      $vertex+2,$nz,$inverse              # 68e
            shufb   $row1_8,$words_12,$words1_14,$m_last # 68o
            fm      $nz,$yb,$xc                         # 69e
            shufb   $row2_6,$words2_4,$words3_9,$m_first # 69o
            a       $found_5,$found_5,$centre           # 70e
            shufb   $words1_5,$vertex1_9,$vertex3_3,$m_first # 70o
            fms     $nx_2,$yb,$zc,$nx                   # 71e
            shufb   $words3_10,$vertex1_9,$vertex3_3,$m_last # 71o
            fms     $ny,$zb,$xc,$ny                     # 72e
            stqd    $row1_8,176($a_patch_9)             # 72o
            a       $found_3,$found_5,$centre_6         # 73e
            stqd    $row2_6,320($a_patch_9)             # 73o
            ori     $vertex3_3,$k_one,0                 # 74e the slope
            shufb   $words_13,$vertex_7,$vertex+2,$m_first # 74o
            fms     $nz,$xb,$yc,$nz                     # 75e
            shufb   $words2_7,$vertex_7,$vertex+2,$m_last # 75o
            a       $found,$found_3,$centre_2           # 76e
            shufb   $row_8,$words_12,$words1_14,$m_first # 76o
            fm      $square_3,$nx_2,$nx_2               # 77e
            shufb   $face_3,$words_3,$words+1,$m_upper  # 77o
            fm      $t,$ny,$ny                          # 78e
            shufb   $row1_9,$words_13,$words1_5,$m_last # 78o
            shufb   $row3_8,$words2_7,$words3_10,$m_last # 79o
            stqd    $row_8,32($a_patch_9)               # 80o
            fm      $t_9,$nz,$nz                        # 81e
            shufb   $row_9,$words_13,$words1_5,$m_first # 81o
            rotmi   $offset,$face_3,-20                 # 82e
            shufb   $row2_7,$words2_7,$words3_10,$m_first # 82o
            rotmi   $offset_3,$face_3,-12               # 83e
            stqd    $row1_9,160($a_patch_10)            # 83o
            rotmi   $offset_2,$face_3,-4                # 84e
            stqd    $row3_8,448($a_patch_10)            # 84o
            fa      $square_3,$square_3,$t              # 85e
            shufb   $row3_6,$words2_4,$words3_9,$m_last # 85o
            and     $offset,$offset,$k_places           # 86e
            stqd    $row_9,16($a_patch_10)              # 86o
            and     $offset_5,$offset_3,$k_places       # 87e
            stqd    $row2_7,304($a_patch_10)            # 87o
            a       $offset,$offset,$leaf+1             # 88e
            stqx    $centre_16,$a_list,$found_5         # 88o
            ori     $a_patch_10,$a_patch_8,0            # 89e copy
            stqd    $row3_6,464($a_patch_9)             # 89o
            and     $offset_9,$offset_2,$k_places       # 90e
            shufb   $leaf3_3,$words+2,$words+3,$m_last  # 90o
            a       $offset_10,$offset_5,$leaf+1        # 91e
            shlqbyi $a_patch_8,$a_patch,0               # 91o copy
            a       $offset_9,$offset_9,$leaf+1         # 92e
            lqd     $vertex,0($offset)                  # 92o
            andi    $material_7,$face_3,255             # 93e
            rotqbyi $vertex+3,$offset,12                # 93o
            ori     $a_patch_9,$a_patch,0               # 94e copy
            lqd     $vertex_8,0($offset_10)             # 94o
            mpyi    $material_7,$material_7,96          # 95e
            lqd     $vertex_6,0($offset_9)              # 95o
            nop     $127                                # 96e pairing
            rotqbyi $vertex3_13,$offset_9,12            # 96o
            fa      $square_4,$square_3,$t_9            # 97e
            rotqbyi $vertex1_14,$offset,4               # 97o
            and     $centre,$vertex,$m_xyz              # 98e
            rotqbyi $vertex1_15,$offset_10,4            # 98o
            rotqbyi $vertex+2,$offset_10,8              # 99o
            stqd    $centre,0($a_patch)                 # 100o
            ai      $a_patch,$a_patch_2,288             # 101e
            lqd     $vertex3_12,0($vertex3_13)          # 101o
            a       $leaf2_4,$material_7,$a_materials   # 102e
            rotqbyi $vertex1_9,$offset_9,4              # 102o
        ai      $a_patch_2,$a_patch,288                 # 103e
        lqd     $vertex2_2,288($a_patch)                # 103o
        lqd     $vertex_2,0($a_patch)                   # 104o
        lqd     $vertex1_2,144($a_patch)                # 105o
        lqd     $vertex3_2,432($a_patch)                # 106o
            lqd     $vertex+2,0($vertex+2)              # 107o
            rotqbyi $vertex3_14,$offset_10,12           # 108o
            rotqbyi $vertex2_9,$offset_9,8              # 109o
            rotqbyi $vertex2_10,$offset,8               # 110o
        shufb   $words_2,$vertex_2,$vertex1_2,$m_first  # 111o
        shufb   $words1_2,$vertex2_2,$vertex3_2,$m_first # 112o
            lqd     $vertex1_15,0($vertex1_15)          # 113o
            lqd     $vertex3_14,0($vertex3_14)          # 114o
            shufb   $words_11,$vertex_8,$vertex+2,$m_first # 115o
            lqd     $vertex1_6,0($vertex1_9)            # 116o
        shufb   $object_2,$words_2,$words1_2,$m_upper   # 117o
            lqd     $vertex1_13,0($vertex1_14)          # 118o
            lqd     $vertex2_12,0($vertex2_10)          # 119o
            nop     $127                                # 120e pairing
            lqd     $vertex+3,0($vertex+3)              # 120o
        andi    $index_5,$object_2,127                  # 121e
            lqd     $vertex2_9,0($vertex2_9)            # 121o
        shli    $material_2,$object_2,1                 # 122e
            shufb   $words1_13,$vertex1_15,$vertex3_14,$m_first # 122o
        cgti    $step_2,$object_2,-1                    # 123e
            shufb   $words3_7,$vertex1_15,$vertex3_14,$m_last # 123o
            and     $centre_12,$vertex1_13,$m_xyz       # 124e
            shufb   $words2_5,$vertex_8,$vertex+2,$m_last # 124o
            and     $centre_14,$vertex2_12,$m_xyz       # 125e
            shufb   $words_10,$vertex,$vertex2_12,$m_first # 125o
        rotmi   $material_3,$material_2,-8              # 126e
            stqd    $centre_12,144($a_patch_6)          # 126o
            and     $centre_12,$vertex+3,$m_xyz         # 127e
            shufb   $words1_12,$vertex1_13,$vertex+3,$m_first # 127o
        shli    $index_3,$index_5,2                     # 128e
next_four_back:
        brnz    $fours,next_four                        # 128o
next_four_drain:
        andi    $offset,$material_3,31                  # 0e
        shufb   $words,$vertex_6,$vertex2_9,$m_first    # 0o
        ori     $leaf_7,$k_zero,0                       # 1e
        shufb   $words+1,$vertex1_6,$vertex3_12,$m_first # 1o
        shli    $offset,$offset,4                       # 2e
        shufb   $yb,$words_11,$words1_13,$m_last        # 2o
        ori     $vertex3_15,$k_one,0                    # 3e the slope
        shufb   $ya,$words_10,$words1_12,$m_last        # 3o
        ori     $a_patch_5,$a_patch,0                   # 4e copy
        shufb   $xb,$words_11,$words1_13,$m_first       # 4o
        ori     $a_patch_11,$a_patch_8,0                # 5e copy
        shufb   $xc,$words,$words+1,$m_first            # 5o
        ori     $a_patch_12,$a_patch,0                  # 6e copy
        shufb   $yc,$words,$words+1,$m_last             # 6o
        fs      $yb,$yb,$ya                             # 7e
        shufb   $xa,$words_10,$words1_12,$m_first       # 7o
        andc    $t,$ya,$k_sign                          # 8e
        shufb   $words2_6,$vertex,$vertex2_12,$m_last   # 8o
        ori     $vertex3_9,$k_one,0                     # 9e the slope
        shufb   $words2_8,$vertex_6,$vertex2_9,$m_last  # 9o
        fs      $yc,$yc,$ya                             # 10e
        shufb   $words3_11,$vertex1_13,$vertex+3,$m_last # 10o
        fs      $xc,$xc,$xa                             # 11e
        shufb   $words3_9,$vertex1_6,$vertex3_12,$m_last # 11o
        fs      $xb,$xb,$xa                             # 12e
        shufb   $zb,$words2_5,$words3_7,$m_first        # 12o
        andc    $t_10,$yb,$k_sign                       # 13e
        rotqbyi $row_5,$offset,0                        # 13o
        andc    $size,$xa,$k_sign                       # 14e
        shufb   $za,$words2_6,$words3_11,$m_first       # 14o
        ai      $a_patch_3,$a_patch_2,288               # 15e
        shufb   $zc,$words2_8,$words3_9,$m_first        # 15o
        andc    $t_9,$yc,$k_sign                        # 16e
        rotqbyi $row2_8,$offset,8                       # 16o
        andc    $size_c,$xc,$k_sign                     # 17e
        rotqbyi $row1_7,$offset,4                       # 17o
        andc    $size_b,$xb,$k_sign                     # 18e
        rotqbyi $row3_7,$offset,12                      # 18o
        fs      $zc,$zc,$za                             # 19e
        stqd    $centre_14,288($a_patch_6)              # 19o
        fs      $zb,$zb,$za                             # 20e
        stqd    $centre_12,432($a_patch_6)              # 20o
        fa      $size_c,$size_c,$t_9                    # 21e
        frsqest $t_11,$square_4                         # 21o
        fa      $size_b,$size_b,$t_10                   # 22e
        lqx     $row2_9,$row2_8,$a_table                # 22o
        fa      $size,$size,$t                          # 23e
        lqx     $row+1,$row1_7,$a_table                 # 23o
        andc    $t_7,$za,$k_sign                        # 24e
        lqx     $row_10,$row_5,$a_table                 # 24o
        fi      $t,$square_4,$t_11                      # 25e
        lqx     $row+3,$row3_7,$a_table                 # 25o
        andc    $t_11,$zc,$k_sign                       # 26e
        shufb   $patch,$a_patch,$a_patch,$m_splat       # 26o
        andc    $t_12,$zb,$k_sign                       # 27e
        stqx    $centre_4,$a_list,$found_3              # 27o
        fa      $size_c,$size_c,$t_11                   # 28e
        shufb   $words_14,$leaf_3,$leaf2_4,$m_first     # 28o
        fa      $size_b,$size_b,$t_12                   # 29e
        shufb   $words2_9,$leaf_3,$leaf2_4,$m_last      # 29o
        fa      $size,$size,$t_7                        # 30e
        shufb   $words2_8,$row_10,$row2_9,$m_last       # 30o
        a       $patch,$patch,$k_patches                # 31e
        shufb   $words3_12,$row+1,$row+3,$m_last        # 31o
        fm      $t_e,$square_4,$t                       # 32e
        shufb   $words,$row_10,$row2_9,$m_first         # 32o
        fm      $inverse,$t,$k_half                     # 33e
        shufb   $centre,$object_2,$patch,$m_hit         # 33o
        nop     $127                                    # 34e pairing
        shufb   $words+1,$row+1,$row+3,$m_first         # 34o
        cgt     $c_more_2,$size_c,$size_b               # 35e
        shufb   $leaf+2,$words2_8,$words3_12,$m_first   # 35o
        nop     $127                                    # 36e pairing
        shufb   $centre_12,$object_2,$patch,$m_hit+1    # 36o
        selb    $size_b,$size_b,$size_c,$c_more_2       # 37e
        shufb   $centre_10,$object_2,$patch,$m_hit+2    # 37o
        fnms    $t_e,$t_e,$t,$k_one                     # 38e
        shufb   $leaf_8,$words,$words+1,$m_first        # 38o
        a       $index,$index_3,$leaf+2                 # 39e
        shufb   $leaf+1,$words,$words+1,$m_last         # 39o
        fa      $leave_2,$size,$size_b                  # 40e
        frest   $inverse_5,$size_b                      # 40o
        nop     $127                                    # 41e pairing
        rotqbyi $vertex+3,$index,12                     # 41o
        ceq     $c_missing,$leaf_8,$material_3          # 42e
        rotqbyi $vertex+1,$index,4                      # 42o
        nop     $127                                    # 43e pairing
        rotqbyi $vertex+2,$index,8                      # 43o
        fma     $inverse,$t_e,$inverse,$t               # 44e
        rotqbyi $row+1,$index,4                         # 44o
        nor     $c_missing,$c_missing,$step_2           # 45e
        lqd     $vertex+3,0($vertex+3)                  # 45o
        fm      $leave,$leave_2,$k_leave                # 46e
        lqd     $vertex+1,0($vertex+1)                  # 46o
        andi    $step_3,$c_missing,16                   # 47e
        stqx    $centre,$a_list,$found                  # 47o
        fi      $inverse_6,$size_b,$inverse_5           # 48e
        lqd     $vertex,0($index)                       # 48o
        nop     $127                                    # 49e pairing
        lqd     $vertex+2,0($vertex+2)                  # 49o
        fm      $vertex1_16,$ny,$inverse                # 50e
        rotqbyi $row3_7,$index,12                       # 50o
        fm      $vertex_7,$nx_2,$inverse                # 51e
        rotqbyi $row_7,$index,0                         # 51o
        fm      $vertex2_13,$nz,$inverse                # 52e
        rotqbyi $row2_10,$index,8                       # 52o
        ori     $leaf1_5,$leave,0                       # 53e
        rotqby  $vertex+1,$vertex+1,$row+1              # 53o
        nop     $127                                    # 54e pairing
        rotqby  $vertex+3,$vertex+3,$row3_7             # 54o
        fm      $zb,$zb,$inverse_6                      # 55e
        rotqby  $vertex,$vertex,$row_7                  # 55o
        fm      $zc,$zc,$inverse_6                      # 56e
        rotqby  $vertex+2,$vertex+2,$row2_10            # 56o
        fm      $yc,$yc,$inverse_6                      # 57e
        shufb   $words1_15,$leaf1_5,$leaf3_3,$m_first   # 57o
        fm      $xb,$xb,$inverse_6                      # 58e
        rotqbyi $centre,$step_3,0                       # 58o
        fm      $xc,$xc,$inverse_6                      # 59e
        shufb   $words3_9,$leaf1_5,$leaf3_3,$m_last     # 59o
        fm      $yb,$yb,$inverse_6                      # 60e
        shufb   $words+1,$vertex+2,$vertex+3,$m_first   # 60o
        nop     $127                                    # 61e pairing
        shufb   $words_3,$vertex,$vertex+1,$m_first     # 61o
        a       $found_7,$found,$centre                 # 62e
        shufb   $words1_5,$vertex1_16,$vertex3_3,$m_first # 62o
        fm      $nx,$zb,$yc                             # 63e
        shufb   $words_13,$vertex_7,$vertex2_13,$m_first # 63o
        fm      $ny,$xb,$zc                             # 64e
        shufb   $row1_8,$words_14,$words1_15,$m_last    # 64o
        nop     $127                                    # 65e pairing
        shufb   $words3_13,$vertex1_16,$vertex3_3,$m_last # 65o
        fm      $nz,$yb,$xc                             # 66e
        shufb   $words2_7,$vertex_7,$vertex2_13,$m_last # 66o
        shufb   $row2_11,$words2_9,$words3_9,$m_first   # 67o
        shufb   $face_3,$words_3,$words+1,$m_upper      # 68o
        fms     $nx_2,$yb,$zc,$nx                       # 69e
        shufb   $row_11,$words_14,$words1_15,$m_first   # 69o
        fms     $ny,$zb,$xc,$ny                         # 70e
        stqx    $centre_12,$a_list,$found_7             # 70o
        nop     $127                                    # 71e pairing
        shufb   $row1_9,$words_13,$words1_5,$m_last     # 71o
        rotmi   $offset,$face_3,-20                     # 72e
        stqd    $row1_8,176($a_patch_9)                 # 72o
        rotmi   $offset_10,$face_3,-12                  # 73e
        shufb   $row3_8,$words2_7,$words3_13,$m_last    # 73o
        rotmi   $offset_11,$face_3,-4                   # 74e
        rotqbyi $centre,$step_3,4                       # 74o
        fms     $nz,$xb,$yc,$nz                         # 75e
        stqd    $row2_11,320($a_patch_9)                # 75o
        and     $offset,$offset,$k_places               # 76e
        shufb   $row_9,$words_13,$words1_5,$m_first     # 76o
        and     $offset_10,$offset_10,$k_places         # 77e
        stqd    $row_11,32($a_patch_9)                  # 77o
        a       $found_5,$found_7,$centre               # 78e
        shufb   $row2_12,$words2_7,$words3_13,$m_first  # 78o
        a       $offset,$offset,$leaf+1                 # 79e
        stqd    $row1_9,160($a_patch_10)                # 79o
        and     $offset_11,$offset_11,$k_places         # 80e
        stqd    $row3_8,448($a_patch_10)                # 80o
        a       $offset_10,$offset_10,$leaf+1           # 81e
        shufb   $row3_9,$words2_9,$words3_9,$m_last     # 81o
        a       $offset_11,$offset_11,$leaf+1           # 82e
        stqd    $row_9,16($a_patch_10)                  # 82o
        fm      $square_5,$nx_2,$nx_2                   # 83e
        stqd    $row2_12,304($a_patch_10)               # 83o
        fm      $t,$ny,$ny                              # 84e
        stqx    $centre_10,$a_list,$found_5             # 84o
        fm      $t_9,$nz,$nz                            # 85e
        stqd    $row3_9,464($a_patch_9)                 # 85o
        andi    $material_8,$face_3,255                 # 86e
        lqd     $vertex,0($offset)                      # 86o
        nop     $127                                    # 87e pairing
        rotqbyi $vertex+3,$offset,12                    # 87o
        mpyi    $material_8,$material_8,96              # 88e
        rotqbyi $vertex3_13,$offset_11,12               # 88o
        nop     $127                                    # 89e pairing
        rotqbyi $vertex1_17,$offset,4                   # 89o
        fa      $square_5,$square_5,$t                  # 90e
        rotqbyi $vertex1_18,$offset_10,4                # 90o
        nop     $127                                    # 91e pairing
        rotqbyi $vertex+2,$offset_10,8                  # 91o
        and     $centre,$vertex,$m_xyz                  # 92e
        rotqbyi $vertex1_16,$offset_11,4                # 92o
        rotqbyi $vertex3_16,$offset_10,12               # 93o
        rotqbyi $vertex2_14,$offset_11,8                # 94o
        a       $leaf2_4,$material_8,$a_materials       # 95e
        rotqbyi $vertex2_10,$offset,8                   # 95o
        fa      $square_4,$square_5,$t_9                # 96e
        lqd     $vertex_9,0($offset_10)                 # 96o
        lqd     $vertex_6,0($offset_11)                 # 97o
        stqd    $centre,0($a_patch)                     # 98o
        lqd     $vertex3_12,0($vertex3_13)              # 99o
        lqd     $vertex+2,0($vertex+2)                  # 100o
        lqd     $vertex1_14,0($vertex1_18)              # 101o
        lqd     $vertex3_14,0($vertex3_16)              # 102o
        lqd     $vertex1_6,0($vertex1_16)               # 103o
        lqd     $vertex1_13,0($vertex1_17)              # 104o
        lqd     $vertex2_15,0($vertex2_10)              # 105o
        lqd     $vertex+3,0($vertex+3)                  # 106o
        lqd     $vertex2_16,0($vertex2_14)              # 107o
        shufb   $words_15,$vertex_9,$vertex+2,$m_first  # 108o
        nop     $127                                    # 109e pairing
        shufb   $words1_13,$vertex1_14,$vertex3_14,$m_first # 109o
        and     $centre_17,$vertex1_13,$m_xyz           # 110e
        shufb   $words+1,$vertex1_6,$vertex3_12,$m_first # 110o
        and     $centre_18,$vertex2_15,$m_xyz           # 111e
        shufb   $words_16,$vertex,$vertex2_15,$m_first  # 111o
        and     $centre_19,$vertex+3,$m_xyz             # 112e
        shufb   $words1_12,$vertex1_13,$vertex+3,$m_first # 112o
        shufb   $words,$vertex_6,$vertex2_16,$m_first   # 113o
        shufb   $yb,$words_15,$words1_13,$m_last        # 114o
        shufb   $xb,$words_15,$words1_13,$m_first       # 115o
        shufb   $ya,$words_16,$words1_12,$m_last        # 116o
        shufb   $xc,$words,$words+1,$m_first            # 117o
        shufb   $yc,$words,$words+1,$m_last             # 118o
        nop     $127                                    # 119e pairing
        shufb   $xa,$words_16,$words1_12,$m_first       # 119o
        fs      $yb,$yb,$ya                             # 120e
        shufb   $words3_14,$vertex1_14,$vertex3_14,$m_last # 120o
        andc    $t,$ya,$k_sign                          # 121e
        shufb   $words2_5,$vertex_9,$vertex+2,$m_last   # 121o
        fs      $yc,$yc,$ya                             # 122e
        shufb   $words2_10,$vertex,$vertex2_15,$m_last  # 122o
        fs      $xc,$xc,$xa                             # 123e
        shufb   $words2_9,$vertex_6,$vertex2_16,$m_last # 123o
        fs      $xb,$xb,$xa                             # 124e
        shufb   $words3_15,$vertex1_13,$vertex+3,$m_last # 124o
        andc    $size,$xa,$k_sign                       # 125e
        shufb   $words3_8,$vertex1_6,$vertex3_12,$m_last # 125o
        andc    $t_13,$yb,$k_sign                       # 126e
        shufb   $zb,$words2_5,$words3_14,$m_first       # 126o
        fa      $size,$size,$t                          # 127e
        frsqest $t,$square_4                            # 127o
        andc    $t_9,$yc,$k_sign                        # 128e
        shufb   $za,$words2_10,$words3_15,$m_first      # 128o
        andc    $size_c,$xc,$k_sign                     # 129e
        shufb   $zc,$words2_9,$words3_8,$m_first        # 129o
        andc    $size_b,$xb,$k_sign                     # 130e
        shufb   $leaf3_3,$words2_8,$words3_12,$m_last   # 130o
        fa      $size_c,$size_c,$t_9                    # 131e
        rotqbyi $centre_20,$step_3,8                    # 131o
        fs      $zb,$zb,$za                             # 132e
        shufb   $words_17,$leaf_7,$leaf2_4,$m_first     # 132o
        fs      $zc,$zc,$za                             # 133e
        rotqbyi $centre_2,$step_3,12                    # 133o
        fa      $size_b,$size_b,$t_13                   # 134e
        shufb   $words2_4,$leaf_7,$leaf2_4,$m_last      # 134o
        fi      $t,$square_4,$t                         # 135e
        shufb   $centre_4,$object_2,$patch,$m_hit+3     # 135o
        andc    $t_7,$za,$k_sign                        # 136e
        shlqbyi $a_patch_8,$a_patch,0                   # 136o copy
        a       $found_3,$found_5,$centre_20            # 137e
        stqd    $centre_17,144($a_patch_5)              # 137o
        andc    $t_11,$zb,$k_sign                       # 138e
        stqd    $centre_18,288($a_patch_5)              # 138o
        andc    $t_9,$zc,$k_sign                        # 139e
        stqd    $centre_19,432($a_patch_5)              # 139o
        fa      $size_b,$size_b,$t_11                   # 140e
        stqx    $centre_4,$a_list,$found_3              # 140o
        fa      $size_c,$size_c,$t_9                    # 141e
        fm      $t_e,$square_4,$t                       # 142e
        fa      $size,$size,$t_7                        # 143e
        fm      $inverse,$t,$k_half                     # 144e
        a       $found,$found_3,$centre_2               # 145e
        hbr     mesh_flat_patches_return,$lr            # 145o hint
        ori     $a_patch_10,$a_patch_8,0                # 146e copy
        cgt     $c_more,$size_c,$size_b                 # 147e
        fnms    $t_e,$t_e,$t,$k_one                     # 148e
        selb    $size_b,$size_b,$size_c,$c_more         # 149e
        a       $a_first,$a_list,$found                 # 150e
        lnop                                            # 150o pairing
        fa      $leave,$size,$size_b                    # 151e
        frest   $inverse_7,$size_b                      # 151o
        fma     $inverse,$t_e,$inverse,$t               # 154e
        fi      $inverse_7,$size_b,$inverse_7           # 155e
        fm      $leave,$leave,$k_leave                  # 157e
        fm      $vertex1_9,$ny,$inverse                 # 160e
        fm      $vertex_7,$nx_2,$inverse                # 161e
        fm      $zb,$zb,$inverse_7                      # 162e
        fm      $zc,$zc,$inverse_7                      # 163e
        fm      $yc,$yc,$inverse_7                      # 164e
        fm      $xb,$xb,$inverse_7                      # 165e
        lnop                                            # 165o pairing
        fm      $xc,$xc,$inverse_7                      # 166e
        shufb   $words1_16,$vertex1_9,$vertex3_15,$m_first # 166o
        fm      $yb,$yb,$inverse_7                      # 167e
        shufb   $words3_10,$vertex1_9,$vertex3_15,$m_last # 167o
        fm      $vertex+2,$nz,$inverse                  # 168e
        ori     $leaf1_4,$leave,0                       # 169e
        fm      $nx,$zb,$yc                             # 170e
        lnop                                            # 170o pairing
        fm      $ny,$xb,$zc                             # 171e
        shufb   $words1_17,$leaf1_4,$leaf3_3,$m_first   # 171o
        shufb   $words3_9,$leaf1_4,$leaf3_3,$m_last     # 172o
        fm      $nz,$yb,$xc                             # 173e
        shufb   $words_13,$vertex_7,$vertex+2,$m_first  # 174o
        shufb   $row1_8,$words_17,$words1_17,$m_last    # 175o
        fms     $nx_2,$yb,$zc,$nx                       # 176e
        shufb   $words2_7,$vertex_7,$vertex+2,$m_last   # 176o
        fms     $ny,$zb,$xc,$ny                         # 177e
        shufb   $row2_13,$words2_4,$words3_9,$m_first   # 177o
        nop     $127                                    # 178e pairing
        shufb   $row_11,$words_17,$words1_17,$m_first   # 178o
        fms     $nz,$xb,$yc,$nz                         # 179e
        shufb   $row1_9,$words_13,$words1_16,$m_last    # 179o
        stqd    $row1_8,176($a_patch_12)                # 180o
        shufb   $row3_8,$words2_7,$words3_10,$m_last    # 181o
        fm      $square_6,$nx_2,$nx_2                   # 182e
        stqd    $row2_13,320($a_patch_12)               # 182o
        fm      $t,$ny,$ny                              # 183e
        shufb   $row_9,$words_13,$words1_16,$m_first    # 183o
        nop     $127                                    # 184e pairing
        stqd    $row_11,32($a_patch_12)                 # 184o
        fm      $t_11,$nz,$nz                           # 185e
        shufb   $row2_7,$words2_7,$words3_10,$m_first   # 185o
        stqd    $row1_9,160($a_patch_11)                # 186o
        shufb   $row3_6,$words2_4,$words3_9,$m_last     # 187o
        nop     $127                                    # 188e pairing
        stqd    $row3_8,448($a_patch_11)                # 188o
        fa      $square_7,$square_6,$t                  # 189e
        stqd    $row_9,16($a_patch_11)                  # 189o
        stqd    $row2_7,304($a_patch_11)                # 190o
        stqd    $row3_6,464($a_patch_12)                # 191o
        fa      $square_4,$square_7,$t_11               # 195e
        frsqest $t,$square_4                            # 201o
        fi      $t,$square_4,$t                         # 205e
        fm      $t_e,$square_4,$t                       # 212e
        fm      $inverse,$t,$k_half                     # 213e
        fnms    $t_e,$t_e,$t,$k_one                     # 218e
        fma     $inverse,$t_e,$inverse,$t               # 224e
        fm      $vertex1_9,$ny,$inverse                 # 230e
        fm      $vertex_7,$nx_2,$inverse                # 231e
        fm      $vertex+2,$nz,$inverse                  # 232e
        shufb   $words1_5,$vertex1_9,$vertex3_9,$m_first # 236o
        shufb   $words3_10,$vertex1_9,$vertex3_9,$m_last # 237o
        shufb   $words_13,$vertex_7,$vertex+2,$m_first  # 238o
        shufb   $words2_7,$vertex_7,$vertex+2,$m_last   # 239o
        shufb   $row1_9,$words_13,$words1_5,$m_last     # 242o
        shufb   $row3_8,$words2_7,$words3_10,$m_last    # 243o
        shufb   $row_9,$words_13,$words1_5,$m_first     # 244o
        shufb   $row2_7,$words2_7,$words3_10,$m_first   # 245o
        stqd    $row1_9,160($a_patch_10)                # 246o
        stqd    $row3_8,448($a_patch_10)                # 247o
        stqd    $row_9,16($a_patch_10)                  # 248o
        stqd    $row2_7,304($a_patch_10)                # 249o
        nop     $127                                    # 250e pairing
mesh_flat_patches_return:
        bi      $lr                                     # 250o
next_four_short:
        ori     $vertex+3,$k_one,0                      # 0e the slope
        lqd     $vertex,0($a_patch)                     # 1o
        ori     $leaf,$k_zero,0                         # 2e
        lqd     $vertex+1,144($a_patch)                 # 2o
        ai      $a_patch_6,$a_patch,288                 # 3e
        lqd     $vertex+2,288($a_patch)                 # 3o
        ai      $fours,$fours,-1                        # 4e
        lqd     $vertex3_17,432($a_patch)               # 4o
        shufb   $patch,$a_patch,$a_patch,$m_splat       # 5o
        shufb   $words,$vertex,$vertex+1,$m_first       # 8o
        a       $patch,$patch,$k_patches                # 9e
        shufb   $words+1,$vertex+2,$vertex3_17,$m_first # 10o
        nop     $127                                    # 11e pairing
        shufb   $object,$words,$words+1,$m_upper        # 14o
        shli    $material,$object,1                     # 18e
        shufb   $centre,$object,$patch,$m_hit           # 18o
        andi    $index,$object,127                      # 19e
        shufb   $centre_10,$object,$patch,$m_hit+1      # 19o
        cgti    $step,$object,-1                        # 20e
        shufb   $centre_16,$object,$patch,$m_hit+2      # 20o
        shli    $index,$index,2                         # 21e
        shufb   $centre_12,$object,$patch,$m_hit+3      # 21o
        rotmi   $material,$material,-8                  # 22e
        stqx    $centre,$a_list,$found                  # 22o
        andi    $offset,$material,31                    # 26e
        shli    $offset,$offset,4                       # 28e
        rotqbyi $row,$offset,0                          # 32o
        rotqbyi $row+1,$offset,4                        # 33o
        rotqbyi $row+2,$offset,8                        # 34o
        rotqbyi $row+3,$offset,12                       # 35o
        lqx     $row,$row,$a_table                      # 36o
        lqx     $row+1,$row+1,$a_table                  # 37o
        lqx     $row+2,$row+2,$a_table                  # 38o
        lqx     $row+3,$row+3,$a_table                  # 39o
        shufb   $words+2,$row,$row+2,$m_last            # 44o
        shufb   $words+3,$row+1,$row+3,$m_last          # 45o
        shufb   $words,$row,$row+2,$m_first             # 46o
        shufb   $words+1,$row+1,$row+3,$m_first         # 47o
        shufb   $leaf+2,$words+2,$words+3,$m_first      # 49o
        shufb   $leaf+3,$words+2,$words+3,$m_last       # 50o
        shufb   $leaf+1,$words,$words+1,$m_last         # 51o
        shufb   $leaf_9,$words,$words+1,$m_first        # 52o
        a       $index,$index,$leaf+2                   # 53e
        rotqbyi $vertex+1,$index,4                      # 55o
        ceq     $c_missing,$leaf_9,$material            # 56e
        rotqbyi $vertex+2,$index,8                      # 56o
        nop     $127                                    # 57e pairing
        rotqbyi $vertex3_18,$index,12                   # 57o
        nor     $c_missing,$c_missing,$step             # 58e
        lqd     $vertex,0($index)                       # 58o
        nop     $127                                    # 59e pairing
        lqd     $vertex+1,0($vertex+1)                  # 59o
        andi    $step,$c_missing,16                     # 60e
        lqd     $vertex+2,0($vertex+2)                  # 60o
        lqd     $vertex3_18,0($vertex3_18)              # 61o
        rotqbyi $row_12,$index,0                        # 62o
        rotqbyi $row1_10,$index,4                       # 63o
        rotqbyi $row2_10,$index,8                       # 64o
        rotqbyi $row3_7,$index,12                       # 65o
        rotqby  $vertex,$vertex,$row_12                 # 66o
        rotqby  $vertex+1,$vertex+1,$row1_10            # 67o
        rotqby  $vertex+2,$vertex+2,$row2_10            # 68o
        rotqby  $vertex3_18,$vertex3_18,$row3_7         # 69o
        rotqbyi $centre,$step,0                         # 70o
        shufb   $words,$vertex,$vertex+1,$m_first       # 71o
        rotqbyi $centre_14,$step,4                      # 72o
        nop     $127                                    # 73e pairing
        shufb   $words+1,$vertex+2,$vertex3_18,$m_first # 73o
        a       $found,$found,$centre                   # 74e
        rotqbyi $centre,$step,8                         # 74o
        nop     $127                                    # 75e pairing
        rotqbyi $centre_15,$step,12                     # 75o
        a       $found_5,$found,$centre_14              # 76e
        stqx    $centre_10,$a_list,$found               # 76o
        nop     $127                                    # 77e pairing
        shufb   $face,$words,$words+1,$m_upper          # 77o
        a       $found_8,$found_5,$centre               # 78e
        stqx    $centre_16,$a_list,$found_5             # 78o
        a       $found,$found_8,$centre_15              # 80e
        stqx    $centre_12,$a_list,$found_8             # 80o
        rotmi   $offset,$face,-12                       # 81e
        rotmi   $offset_7,$face,-4                      # 82e
        rotmi   $offset_9,$face,-20                     # 83e
        andi    $material,$face,255                     # 84e
        and     $offset,$offset,$k_places               # 85e
        and     $offset_7,$offset_7,$k_places           # 86e
        and     $offset_9,$offset_9,$k_places           # 87e
        a       $offset,$offset,$leaf+1                 # 88e
        a       $offset_7,$offset_7,$leaf+1             # 89e
        lnop                                            # 89o pairing
        a       $offset_9,$offset_9,$leaf+1             # 90e
        rotqbyi $vertex+1,$offset,4                     # 90o
        mpyi    $material,$material,96                  # 91e
        rotqbyi $vertex+2,$offset,8                     # 91o
        rotqbyi $vertex3_14,$offset,12                  # 92o
        rotqbyi $vertex1_9,$offset_7,4                  # 93o
        rotqbyi $vertex2_7,$offset_7,8                  # 94o
        rotqbyi $vertex3_9,$offset_7,12                 # 95o
        rotqbyi $vertex1_19,$offset_9,4                 # 96o
        rotqbyi $vertex2_2,$offset_9,8                  # 97o
        a       $leaf+2,$material,$a_materials          # 98e
        rotqbyi $vertex3_19,$offset_9,12                # 98o
        lqd     $vertex,0($offset)                      # 99o
        lqd     $vertex+1,0($vertex+1)                  # 100o
        lqd     $vertex+2,0($vertex+2)                  # 101o
        lqd     $vertex3_14,0($vertex3_14)              # 102o
        lqd     $vertex_10,0($offset_7)                 # 103o
        lqd     $vertex1_9,0($vertex1_9)                # 104o
        lqd     $vertex2_7,0($vertex2_7)                # 105o
        lqd     $vertex3_9,0($vertex3_9)                # 106o
        lqd     $vertex_11,0($offset_9)                 # 107o
        lqd     $vertex1_19,0($vertex1_19)              # 108o
        lqd     $vertex2_2,0($vertex2_2)                # 109o
        lqd     $vertex3_19,0($vertex3_19)              # 110o
        shufb   $words_18,$vertex,$vertex+2,$m_first    # 111o
        shufb   $words1_4,$vertex+1,$vertex3_14,$m_first # 112o
        and     $centre,$vertex_11,$m_xyz               # 113e
        shufb   $words_8,$vertex_10,$vertex2_7,$m_first # 113o
        and     $centre_6,$vertex1_19,$m_xyz            # 114e
        shufb   $words1_5,$vertex1_9,$vertex3_9,$m_first # 114o
        and     $centre_21,$vertex2_2,$m_xyz            # 115e
        shufb   $words_19,$vertex_11,$vertex2_2,$m_first # 115o
        and     $centre_22,$vertex3_19,$m_xyz           # 116e
        shufb   $words1_18,$vertex1_19,$vertex3_19,$m_first # 116o
        shufb   $xb,$words_18,$words1_4,$m_first        # 117o
        shufb   $yb,$words_18,$words1_4,$m_last         # 118o
        shufb   $xc,$words_8,$words1_5,$m_first         # 119o
        shufb   $yc,$words_8,$words1_5,$m_last          # 120o
        shufb   $xa,$words_19,$words1_18,$m_first       # 121o
        shufb   $ya,$words_19,$words1_18,$m_last        # 122o
        shufb   $words+2,$vertex,$vertex+2,$m_last      # 123o
        shufb   $words+3,$vertex+1,$vertex3_14,$m_last  # 124o
        fs      $xb,$xb,$xa                             # 125e
        shufb   $words2_6,$vertex_10,$vertex2_7,$m_last # 125o
        fs      $xc,$xc,$xa                             # 126e
        shufb   $words3_8,$vertex1_9,$vertex3_9,$m_last # 126o
        fs      $yb,$yb,$ya                             # 127e
        shufb   $words2_8,$vertex_11,$vertex2_2,$m_last # 127o
        fs      $yc,$yc,$ya                             # 128e
        shufb   $words3_10,$vertex1_19,$vertex3_19,$m_last # 128o
        andc    $size,$xa,$k_sign                       # 129e
        shufb   $zb,$words+2,$words+3,$m_first          # 129o
        andc    $t,$ya,$k_sign                          # 130e
        shufb   $zc,$words2_6,$words3_8,$m_first        # 130o
        andc    $size_b,$xb,$k_sign                     # 131e
        stqd    $centre,0($a_patch)                     # 131o
        andc    $size_c,$xc,$k_sign                     # 132e
        shufb   $za,$words2_8,$words3_10,$m_first       # 132o
        andc    $t_9,$yb,$k_sign                        # 133e
        stqd    $centre_6,144($a_patch)                 # 133o
        andc    $t_7,$yc,$k_sign                        # 134e
        stqd    $centre_21,288($a_patch)                # 134o
        fa      $size_b,$size_b,$t_9                    # 135e
        stqd    $centre_22,432($a_patch)                # 135o
        fs      $zb,$zb,$za                             # 136e
        shufb   $words,$leaf,$leaf+2,$m_first           # 136o
        fs      $zc,$zc,$za                             # 137e
        shufb   $words+2,$leaf,$leaf+2,$m_last          # 137o
        fa      $size_c,$size_c,$t_7                    # 138e
        fa      $size,$size,$t                          # 139e
        andc    $t,$za,$k_sign                          # 140e
        andc    $t_9,$zb,$k_sign                        # 142e
        andc    $t_7,$zc,$k_sign                        # 143e
        fa      $size_b,$size_b,$t_9                    # 144e
        fa      $size_c,$size_c,$t_7                    # 145e
        lnop                                            # 145o pairing
        fa      $size,$size,$t                          # 146e
        hbrr    next_four_short_back,next_four_short    # 146o hint
        cgt     $c_more,$size_c,$size_b                 # 151e
        selb    $size_b,$size_b,$size_c,$c_more         # 153e
        fa      $leave,$size,$size_b                    # 155e
        frest   $inverse,$size_b                        # 155o
        fi      $inverse,$size_b,$inverse               # 159e
        fm      $leave,$leave,$k_leave                  # 161e
        fm      $xb,$xb,$inverse                        # 166e
        fm      $yc,$yc,$inverse                        # 167e
        fm      $zb,$zb,$inverse                        # 168e
        fm      $zc,$zc,$inverse                        # 169e
        fm      $xc,$xc,$inverse                        # 170e
        fm      $yb,$yb,$inverse                        # 171e
        ori     $leaf+1,$leave,0                        # 172e
        lnop                                            # 172o pairing
        fm      $nx,$zb,$yc                             # 174e
        shufb   $words+1,$leaf+1,$leaf+3,$m_first       # 174o
        fm      $ny,$xb,$zc                             # 175e
        shufb   $words+3,$leaf+1,$leaf+3,$m_last        # 175o
        fm      $nz,$yb,$xc                             # 177e
        shufb   $row,$words,$words+1,$m_first           # 178o
        nop     $127                                    # 179e pairing
        shufb   $row+1,$words,$words+1,$m_last          # 179o
        fms     $nx,$yb,$zc,$nx                         # 180e
        shufb   $row+2,$words+2,$words+3,$m_first       # 180o
        fms     $ny,$zb,$xc,$ny                         # 181e
        shufb   $row+3,$words+2,$words+3,$m_last        # 181o
        nop     $127                                    # 182e pairing
        stqd    $row,32($a_patch)                       # 182o
        fms     $nz,$xb,$yc,$nz                         # 183e
        stqd    $row+1,176($a_patch)                    # 183o
        stqd    $row+2,320($a_patch)                    # 184o
        stqd    $row+3,464($a_patch)                    # 185o
        fm      $square,$nx,$nx                         # 186e
        fm      $t,$ny,$ny                              # 187e
        fm      $t_9,$nz,$nz                            # 189e
        fa      $square,$square,$t                      # 193e
        fa      $square,$square,$t_9                    # 199e
        frsqest $t,$square                              # 205o
        fi      $t,$square,$t                           # 209e
        fm      $t_e,$square,$t                         # 216e
        fm      $inverse,$t,$k_half                     # 217e
        fnms    $t_e,$t_e,$t,$k_one                     # 222e
        fma     $inverse,$t_e,$inverse,$t               # 228e
        fm      $vertex,$nx,$inverse                    # 234e
        fm      $vertex+1,$ny,$inverse                  # 235e
        fm      $vertex+2,$nz,$inverse                  # 236e
        shufb   $words+1,$vertex+1,$vertex+3,$m_first   # 241o
        shufb   $words,$vertex,$vertex+2,$m_first       # 242o
        shufb   $words+2,$vertex,$vertex+2,$m_last      # 243o
        shufb   $words+3,$vertex+1,$vertex+3,$m_last    # 244o
        shufb   $row,$words,$words+1,$m_first           # 246o
        shufb   $row+1,$words,$words+1,$m_last          # 247o
        shufb   $row+2,$words+2,$words+3,$m_first       # 248o
        shufb   $row+3,$words+2,$words+3,$m_last        # 249o
        stqd    $row,16($a_patch)                       # 250o
        stqd    $row+1,160($a_patch)                    # 251o
        stqd    $row+2,304($a_patch)                    # 252o
        stqd    $row+3,448($a_patch)                    # 253o
        ai      $a_patch,$a_patch_6,288                 # 254e
next_four_short_back:
        brnz    $fours,next_four_short                  # 254o
        a       $a_first,$a_list,$found                 # 254e
        bi      $lr                                     # 254o
endfunction mesh_flat_patches
