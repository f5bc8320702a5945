# mesh_flat_patches   the patches of hit triangles of a mesh, for those whose leaves are known
#   C       struct mesh_hit *mesh_flat_patches(struct patch *, int count, const struct mesh_leaf *,
#                                              struct mesh_hit *, const struct material *);
#   In      $3 patches as mesh_list_hits_r16 leaves them, with room for three more, $4 how many
#           fours of them (0 is none), with 0 as the objects behind the last, $5 MESH_LEAF_PLACES
#           leaves, $6 where the list goes, $7 the mesh's first material; pointers 16-aligned
#   Out     OBJECT_centre to OBJECT_sides of the patches; the patches behind the last get anything
#           the list: the hits whose leaves are not there, in order; four more may be written
#           $3 behind the list
#   Uses    $2-$4, $7-$73   Saves  -   Stack  0   Calls  -
#   Domain  coordinates below 2^60, edges from 2^-60 on
#   Error   16 ulp of 1 in the normal of a triangle whose area is above 1/40 of its longest edge's
#           square; 3e-4 of leave
#   Twin    lab/twins/src/mesh_patches.rs
#
# The loop counts up, so that it isn't pipelined. Pipelined it would take 129 cycles for four
# triangles instead of 254, but 4.9 KB of local store instead of 1.1, where the cache loses two
# blocks.
#
# Four triangles are in the four lanes. The normal is (b - a) x (c - a), with the edges made about
# 1 long before. A patch that the list has gets anything.
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
        .set a_patch_2,2; .set vertex3_2,3; .set centre_2,3; .set centre_3,8; .set centre_4,9
        .set leaf_2,28; .set vertex3_3,28; .set row_2,29; .set row1_2,30; .set row2_2,31
        .set row3_2,32; .set centre_5,29; .set centre_6,28; .set found_2,29; .set found_3,3
        .set offset_2,3; .set offset_3,8; .set vertex3_4,9; .set vertex1_2,28; .set vertex2_2,29
        .set vertex3_5,30; .set vertex1_3,31; .set vertex2_3,32; .set vertex3_6,33; .set vertex_2,3
        .set vertex_3,8; .set words_2,34; .set words1_2,35; .set words_3,37; .set centre_7,44
        .set words1_3,45; .set centre_8,46; .set words_4,47; .set centre_9,48; .set words1_4,49
        .set words2_2,3; .set words3_2,9; .set words2_3,8; .set words3_3,28; .set t_2,3; .set t_3,8
        ori     $a_patch,$a_first,0                     # 0e
        il      $found,0                                # 1e
        ori     $a_first,$a_list,0                      # 2e
        biz     $fours,$lr                              # 2o
        ila     $m_splat,0x10203                        # 3e
        lqa     $m_first,transpose_first                # 3o
        sfi     $fours,$fours,0                         # 4e
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
next_four:
        ori     $vertex+3,$k_one,0                      # 0e the slope
        lqd     $vertex,0($a_patch)                     # 1o
        ori     $leaf,$k_zero,0                         # 2e
        lqd     $vertex+1,144($a_patch)                 # 2o
        ai      $a_patch_2,$a_patch,288                 # 3e
        lqd     $vertex+2,288($a_patch)                 # 3o
        ai      $fours,$fours,1                         # 4e
        lqd     $vertex3_2,432($a_patch)                # 4o
        shufb   $patch,$a_patch,$a_patch,$m_splat       # 5o
        shufb   $words,$vertex,$vertex+1,$m_first       # 8o
        a       $patch,$patch,$k_patches                # 9e
        shufb   $words+1,$vertex+2,$vertex3_2,$m_first  # 10o
        nop     $127                                    # 11e pairing
        shufb   $object,$words,$words+1,$m_upper        # 14o
        shli    $material,$object,1                     # 18e
        shufb   $centre,$object,$patch,$m_hit           # 18o
        andi    $index,$object,127                      # 19e
        shufb   $centre_2,$object,$patch,$m_hit+1       # 19o
        cgti    $step,$object,-1                        # 20e
        shufb   $centre_3,$object,$patch,$m_hit+2       # 20o
        shli    $index,$index,2                         # 21e
        shufb   $centre_4,$object,$patch,$m_hit+3       # 21o
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
        shufb   $leaf_2,$words,$words+1,$m_first        # 52o
        a       $index,$index,$leaf+2                   # 53e
        rotqbyi $vertex+1,$index,4                      # 55o
        ceq     $c_missing,$leaf_2,$material            # 56e
        rotqbyi $vertex+2,$index,8                      # 56o
        nop     $127                                    # 57e pairing
        rotqbyi $vertex3_3,$index,12                    # 57o
        nor     $c_missing,$c_missing,$step             # 58e
        lqd     $vertex,0($index)                       # 58o
        nop     $127                                    # 59e pairing
        lqd     $vertex+1,0($vertex+1)                  # 59o
        andi    $step,$c_missing,16                     # 60e
        lqd     $vertex+2,0($vertex+2)                  # 60o
        lqd     $vertex3_3,0($vertex3_3)                # 61o
        rotqbyi $row_2,$index,0                         # 62o
        rotqbyi $row1_2,$index,4                        # 63o
        rotqbyi $row2_2,$index,8                        # 64o
        rotqbyi $row3_2,$index,12                       # 65o
        rotqby  $vertex,$vertex,$row_2                  # 66o
        rotqby  $vertex+1,$vertex+1,$row1_2             # 67o
        rotqby  $vertex+2,$vertex+2,$row2_2             # 68o
        rotqby  $vertex3_3,$vertex3_3,$row3_2           # 69o
        rotqbyi $centre,$step,0                         # 70o
        shufb   $words,$vertex,$vertex+1,$m_first       # 71o
        rotqbyi $centre_5,$step,4                       # 72o
        nop     $127                                    # 73e pairing
        shufb   $words+1,$vertex+2,$vertex3_3,$m_first  # 73o
        a       $found,$found,$centre                   # 74e
        rotqbyi $centre,$step,8                         # 74o
        nop     $127                                    # 75e pairing
        rotqbyi $centre_6,$step,12                      # 75o
        a       $found_2,$found,$centre_5               # 76e
        stqx    $centre_2,$a_list,$found                # 76o
        nop     $127                                    # 77e pairing
        shufb   $face,$words,$words+1,$m_upper          # 77o
        a       $found_3,$found_2,$centre               # 78e
        stqx    $centre_3,$a_list,$found_2              # 78o
        a       $found,$found_3,$centre_6               # 80e
        stqx    $centre_4,$a_list,$found_3              # 80o
        rotmi   $offset,$face,-12                       # 81e
        rotmi   $offset_2,$face,-4                      # 82e
        rotmi   $offset_3,$face,-20                     # 83e
        andi    $material,$face,255                     # 84e
        and     $offset,$offset,$k_places               # 85e
        and     $offset_2,$offset_2,$k_places           # 86e
        and     $offset_3,$offset_3,$k_places           # 87e
        a       $offset,$offset,$leaf+1                 # 88e
        a       $offset_2,$offset_2,$leaf+1             # 89e
        lnop                                            # 89o pairing
        a       $offset_3,$offset_3,$leaf+1             # 90e
        rotqbyi $vertex+1,$offset,4                     # 90o
        mpyi    $material,$material,96                  # 91e
        rotqbyi $vertex+2,$offset,8                     # 91o
        rotqbyi $vertex3_4,$offset,12                   # 92o
        rotqbyi $vertex1_2,$offset_2,4                  # 93o
        rotqbyi $vertex2_2,$offset_2,8                  # 94o
        rotqbyi $vertex3_5,$offset_2,12                 # 95o
        rotqbyi $vertex1_3,$offset_3,4                  # 96o
        rotqbyi $vertex2_3,$offset_3,8                  # 97o
        a       $leaf+2,$material,$a_materials          # 98e
        rotqbyi $vertex3_6,$offset_3,12                 # 98o
        lqd     $vertex,0($offset)                      # 99o
        lqd     $vertex+1,0($vertex+1)                  # 100o
        lqd     $vertex+2,0($vertex+2)                  # 101o
        lqd     $vertex3_4,0($vertex3_4)                # 102o
        lqd     $vertex_2,0($offset_2)                  # 103o
        lqd     $vertex1_2,0($vertex1_2)                # 104o
        lqd     $vertex2_2,0($vertex2_2)                # 105o
        lqd     $vertex3_5,0($vertex3_5)                # 106o
        lqd     $vertex_3,0($offset_3)                  # 107o
        lqd     $vertex1_3,0($vertex1_3)                # 108o
        lqd     $vertex2_3,0($vertex2_3)                # 109o
        lqd     $vertex3_6,0($vertex3_6)                # 110o
        shufb   $words_2,$vertex,$vertex+2,$m_first     # 111o
        shufb   $words1_2,$vertex+1,$vertex3_4,$m_first # 112o
        and     $centre,$vertex_3,$m_xyz                # 113e
        shufb   $words_3,$vertex_2,$vertex2_2,$m_first  # 113o
        and     $centre_7,$vertex1_3,$m_xyz             # 114e
        shufb   $words1_3,$vertex1_2,$vertex3_5,$m_first # 114o
        and     $centre_8,$vertex2_3,$m_xyz             # 115e
        shufb   $words_4,$vertex_3,$vertex2_3,$m_first  # 115o
        and     $centre_9,$vertex3_6,$m_xyz             # 116e
        shufb   $words1_4,$vertex1_3,$vertex3_6,$m_first # 116o
        shufb   $xb,$words_2,$words1_2,$m_first         # 117o
        shufb   $yb,$words_2,$words1_2,$m_last          # 118o
        shufb   $xc,$words_3,$words1_3,$m_first         # 119o
        shufb   $yc,$words_3,$words1_3,$m_last          # 120o
        shufb   $xa,$words_4,$words1_4,$m_first         # 121o
        shufb   $ya,$words_4,$words1_4,$m_last          # 122o
        shufb   $words+2,$vertex,$vertex+2,$m_last      # 123o
        shufb   $words+3,$vertex+1,$vertex3_4,$m_last   # 124o
        fs      $xb,$xb,$xa                             # 125e
        shufb   $words2_2,$vertex_2,$vertex2_2,$m_last  # 125o
        fs      $xc,$xc,$xa                             # 126e
        shufb   $words3_2,$vertex1_2,$vertex3_5,$m_last # 126o
        fs      $yb,$yb,$ya                             # 127e
        shufb   $words2_3,$vertex_3,$vertex2_3,$m_last  # 127o
        fs      $yc,$yc,$ya                             # 128e
        shufb   $words3_3,$vertex1_3,$vertex3_6,$m_last # 128o
        andc    $size,$xa,$k_sign                       # 129e
        shufb   $zb,$words+2,$words+3,$m_first          # 129o
        andc    $t,$ya,$k_sign                          # 130e
        shufb   $zc,$words2_2,$words3_2,$m_first        # 130o
        andc    $size_b,$xb,$k_sign                     # 131e
        stqd    $centre,0($a_patch)                     # 131o
        andc    $size_c,$xc,$k_sign                     # 132e
        shufb   $za,$words2_3,$words3_3,$m_first        # 132o
        andc    $t_2,$yb,$k_sign                        # 133e
        stqd    $centre_7,144($a_patch)                 # 133o
        andc    $t_3,$yc,$k_sign                        # 134e
        stqd    $centre_8,288($a_patch)                 # 134o
        fa      $size_b,$size_b,$t_2                    # 135e
        stqd    $centre_9,432($a_patch)                 # 135o
        fs      $zb,$zb,$za                             # 136e
        shufb   $words,$leaf,$leaf+2,$m_first           # 136o
        fs      $zc,$zc,$za                             # 137e
        shufb   $words+2,$leaf,$leaf+2,$m_last          # 137o
        fa      $size_c,$size_c,$t_3                    # 138e
        fa      $size,$size,$t                          # 139e
        andc    $t,$za,$k_sign                          # 140e
        andc    $t_2,$zb,$k_sign                        # 142e
        andc    $t_3,$zc,$k_sign                        # 143e
        fa      $size_b,$size_b,$t_2                    # 144e
        fa      $size_c,$size_c,$t_3                    # 145e
        lnop                                            # 145o pairing
        fa      $size,$size,$t                          # 146e
        hbrr    next_four_back,next_four                # 146o hint
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
        fm      $t_2,$nz,$nz                            # 189e
        fa      $square,$square,$t                      # 193e
        fa      $square,$square,$t_2                    # 199e
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
        ai      $a_patch,$a_patch_2,288                 # 254e
next_four_back:
        brnz    $fours,next_four                        # 254o
        a       $a_first,$a_list,$found                 # 254e
        bi      $lr                                     # 254o
endfunction mesh_flat_patches
