# height_corners   vertices of triangles of a height field with their normals and colours, for those
#                  hit triangles whose leaves are known
#   C       void height_corners(struct patch *, int count, const struct mesh_leaf *,
#                               vec_uint4 *colours);
#   In      $3 patches as mesh_list_hits_r16 leaves them, with space for three more, $4 how many
#           fours of them (0 is none), $5 MESH_LEAF_PLACES leaves, those of a height field as
#           height_block makes them, $6 a quadword for each patch; pointers 16-aligned
#   Out     TRI_a to PATCH_normal_c of the patches, and the packed colours of their vertices, in the
#           first three words. Where the leaf is another one, or not there, they are anything
#   Uses    $3-$6, $10-$79   Saves  -   Stack  0   Calls  -
#   Domain  any normals and colours
#   Error   3 ulp of 1, each part of a normal
#   Twin    lab/twins/src/height.rs
#
# Four triangles are in the four lanes. The loop counts up, so that it isn't pipelined, which would
# multiply its size.

        .include "work_unit.inc"
        .include "macros.inc"
        .include "math.inc"
        .include "transpose.inc"
        .include "height.inc"
        .include "mesh_block.inc"

        .set    FACES_AT,HEIGHT_VERTICES*MESH_VERTEX_SIZE  # from the vertices on
        .set    COLOURS_AT,FACES_AT+64*MESH_FACE_SIZE

        .set    NEXT,3
        registers a_patch,fours,a_table,a_colours
        # constants
        .set    NEXT,10
        registers m_first,m_last                        # of transpose
        registers m_upper,m_second,m_fourth,m_xyz,k_vertex,k_colour,k_sign,k_half,k_one,k_scale
        # the triangles
        registers row                                   # to 25
        .set    NEXT,row+4
        registers words                                 # to 29
        .set    NEXT,words+4
        registers lane                                  # to 33
        .set    NEXT,lane+4
        registers at                                    # to 37
        .set    NEXT,at+4
        registers object,number,offset,vertices,face
        registers colour                                # to 46: of three vertices, and anything
        .set    NEXT,colour+4
        registers normal                                # to 50: x, y, z, 0
        .set    NEXT,normal+4
        registers packed,fold,part,square,t_y,t_e,inverse,known
        registers nothing                               # where lanes without a leaf read: a_table
    .if NEXT > 80
        .error  "too many registers"
    .endif

        transpose_table .rodata.height
upper_halves:
        .int    0x00010203,0x04050607,0x10111213,0x14151617
second_words:
        .int    0x04050607,0x14151617,0x04050607,0x14151617
fourth_words:
        .int    0x0c0d0e0f,0x1c1d1e1f,0x0c0d0e0f,0x1c1d1e1f

# One word of four registers: the one that `pick` takes twice of two.
.macro  words_of out:req, of:req, pick:req
        shufb   $words,$\of,$\of+1,\pick
        shufb   $words+1,$\of+2,$\of+3,\pick
        shufb   \out,$words,$words+1,$m_upper
.endm

# Loads the quadwords at `beside` from each lane of addresses.
.macro  load_lanes addresses:req, beside=0
        ori     $at,\addresses,0
        lqd     $lane,\beside($at)
    .irp number, 1,2,3
        rotqbyi $at+\number,\addresses,4*\number
        lqd     $lane+\number,\beside($at+\number)
    .endr
.endm

# The words at each lane of addresses.
.macro  load_words out:req, addresses:req, beside:req
        load_lanes \addresses,\beside
    .irp number, 0,1,2,3
        rotqby  $lane+\number,$lane+\number,$at+\number
    .endr
        words_of \out,lane,$m_first
.endm

# The normal of a vertex, whose index is in a byte of the faces, as mesh_hits unpacks it; and its
# colour.
.macro  corner name:req, byte:req
        rotmi   $offset,$face,4-8*\byte
        and     $offset,$offset,$k_vertex
        a       $offset,$offset,$vertices
        load_lanes $offset
        words_of $packed,lane,$m_fourth
    .irp number, 0,1,2,3
        and     $lane+\number,$lane+\number,$m_xyz
        stqd    $lane+\number,TRI_\name+PATCH_SIZE*\number($a_patch)
    .endr
        rotmi   $offset,$face,2-8*\byte
        and     $offset,$offset,$k_colour
        a       $offset,$offset,$vertices
        load_words $colour+3-\byte,$offset,COLOURS_AT
        shli    $normal+1,$packed,16
        rotmai  $normal,$packed,-16
        rotmai  $normal+1,$normal+1,-16
        csflt   $normal,$normal,0
        csflt   $normal+1,$normal+1,0
        fm      $normal,$normal,$k_scale
        fm      $normal+1,$normal+1,$k_scale
        andc    $normal+2,$normal,$k_sign
        andc    $part,$normal+1,$k_sign
        fs      $normal+2,$k_one,$normal+2
        fs      $normal+2,$normal+2,$part
        rotmai  $fold,$normal+2,-31
        and     $fold,$fold,$normal+2
        andc    $fold,$fold,$k_sign                     # what z is below 0
    .irp axis, 0,1
        and     $part,$normal+\axis,$k_sign
        or      $part,$part,$fold
        fs      $normal+\axis,$normal+\axis,$part
    .endr
        fm      $square,$normal,$normal
        fma     $square,$normal+1,$normal+1,$square
        fma     $square,$normal+2,$normal+2,$square
        rsqrt_f4 $inverse,$square,$t_y,$t_e,$k_half,$k_one
    .irp axis, 0,1,2
        fm      $normal+\axis,$normal+\axis,$inverse
    .endr
        il      $normal+3,0
        transpose row,normal,words,$m_first,$m_last
    .irp number, 0,1,2,3
        stqd    $row+\number,PATCH_normal_\name+PATCH_SIZE*\number($a_patch)
    .endr
.endm

function height_corners
        biz     $fours,$lr
        sfi     $fours,$fours,0
        lqa     $m_first,transpose_first
        lqa     $m_last,transpose_last
        lqa     $m_upper,upper_halves
        lqa     $m_second,second_words
        lqa     $m_fourth,fourth_words
        fsmbi   $m_xyz,0xfff0
        splat_mask $nothing
        splat   $nothing,$a_table,$nothing
        il      $k_vertex,0xff0
        il      $k_colour,0x3fc
        ilhu    $k_sign,0x8000
        ilhu    $k_half,0x3f00
        ilhu    $k_one,0x3f80
        load_constant $k_scale,0x38000100               # 1 / 32767
next_four:
    .irp number, 0,1,2,3
        lqd     $lane+\number,PATCH_SIZE*\number($a_patch)
    .endr
        words_of $object,lane,$m_first
        shli    $number,$object,1
        rotmi   $number,$number,-8
        leaf_place $offset,$number
    .irp number, 0,1,2,3
        rotqbyi $row+\number,$offset,4*\number
        lqx     $row+\number,$row+\number,$a_table
    .endr
        words_of $vertices,row,$m_second                # of MESH_LEAVES
        # Others have any face, and might read what a transfer is still writing.
        words_of $known,row,$m_first
        ceq     $known,$known,$number
        shli    $part,$number,8                         # HEIGHT_BLOCK becomes the sign
        rotmai  $part,$part,-31
        and     $known,$known,$part
        selb    $vertices,$nothing,$vertices,$known
        andi    $offset,$object,127
        shli    $offset,$offset,2
        a       $offset,$offset,$vertices
        load_words $face,$offset,FACES_AT
        and     $face,$face,$known
        corner  a,3
        corner  b,2
        corner  c,1
        transpose row,colour,words,$m_first,$m_last
    .irp number, 0,1,2,3
        stqd    $row+\number,16*\number($a_colours)
    .endr
    .rept   2                                           # ai reaches to 511
        ai      $a_patch,$a_patch,2*PATCH_SIZE
    .endr
        ai      $a_colours,$a_colours,4*16
        ai      $fours,$fours,1
        brnz    $fours,next_four
        bi      $lr
endfunction height_corners
