# sort_pack   packs the first of some sorted triangles into a leaf block without vertices and boxes
#   C       int sort_pack(const void *triangles, int count, struct mesh_block *, void *list,
#                         void *memory, unsigned low, unsigned vertices, unsigned number,
#                         unsigned turn);
#   In      $3 BUILD_TRIANGLE records, and 16 bytes after them, $4 how many, at least 1, $5 the
#           block, $6 where the DMA list of its vertices goes, 752 bytes, $7 10,208 bytes for
#           intermediate results, $8 low word of the address of the mesh's vertices, $9 how many
#           these are, at most 2^24, $10 the block's number, $11 1 to 255: another one in each call
#           since the intermediate results were 0; pointers 16-aligned
#   Out     $3 how many triangles are in the block; 0 if one of them has another vertex than the
#           mesh has
#   Uses    $3-$11, $12-$78
#   Domain  any
#   Error   0
#   Twin    lab/twins/src/sort.rs
#
# Triangles are added until the next one does not fit or has other sides. The block then ends where
# codes differ most, among the places where it is at least 61 % full, because the triangles after
# such a place are the farthest. A hash table finds a vertex among those of the block.

        .include "work_unit.inc"
        .include "macros.inc"

        .set    SLOTS,512
        .set    OWN_AT,16*SLOTS                         # the vertices, each in a quadword
        .set    FACES_AT,OWN_AT+16*94
        .set    NODES,5
        .set    FULL,MESH_BLOCK-MESH_HEADER_SIZE-NODES*BOXES_SIZE
        .set    LEAST,896
        .set    FEW,16                                  # triangles of a leaf with one node

        .set    NEXT,3
        registers a_triangle,left,a_block,a_list,a_memory,low,vertices,number,turn
        registers m_splat,m_pair,m_two_pairs,m_element,k_index,k_sides,k_slots,k_factor
        registers k_full,k_least,a_own,a_face
        registers sides,count,total,bad,best,cut_count,cut_total
        # a triangle
        registers triangle,following,own_sides,more,more_total,bytes,over,t
        registers corners,slots,words                   # in the triangle's last three words
        registers index                                 # to 47
        .set    NEXT,index+3
        registers slot,word,entry,found,is_free,fresh,at,face,better
        # the block
        registers few,levels,nodes,lanes,per,first,last,length,m_word,a_node,a_from,counts
        registers ones,quads,a_to

# The slots in which the vertices of a triangle are looked for first, and what these have then.
.macro  hash triangle:req
        and     $corners,\triangle,$k_index
        rotmi   $slots,$corners,-8
        xor     $slots,$slots,$corners
        mpyu    $slots,$slots,$k_factor
        rotmi   $slots,$slots,-3
        and     $slots,$slots,$k_slots
        or      $words,$corners,$turn
.endm

        .section .rodata.sort,"a",@progbits
        .align  4
pair:                                                   # the first words of two quadwords
        .int    0x00010203,0x10111213,0x00010203,0x10111213
two_pairs:
        .int    0x00010203,0x04050607,0x10111213,0x14151617
elements:
        .int    0x80808080,0x00010203,0x80808080,0x10111213
runs:   .int    0,1,2,3
lower_nodes:
    .irp node, 1,2,3,4
        .int    MESH_HEADER_SIZE+\node*BOXES_SIZE
    .endr

function sort_pack
        splat_mask $m_splat
        lqa     $m_pair,pair
        lqa     $m_two_pairs,two_pairs
        lqa     $m_element,elements
        ilhu    $k_index,0xff
        iohl    $k_index,0xffff
        ilhu    $k_sides,(SIDES_BOTH|SIDES_SMOOTH)>>16
        il      $k_slots,16*(SLOTS-1)
        ila     $k_factor,0x9e35
        il      $k_full,FULL
        il      $k_least,LEAST
        il      $a_own,OWN_AT
        a       $a_own,$a_own,$a_memory
        il      $a_face,FACES_AT
        a       $a_face,$a_face,$a_memory
        splat   $vertices,$vertices,$m_splat
        splat   $turn,$turn,$m_splat
        shli    $turn,$turn,24
        lqd     $triangle,0($a_triangle)
        shlqbyi $sides,$triangle,8
        and     $sides,$sides,$k_sides
        il      $count,0
        il      $total,0
        il      $bad,0
        il      $best,0
        il      $cut_count,0
        il      $cut_total,0
        hash    $triangle
next_triangle:
        lqd     $triangle,0($a_triangle)
        lqd     $following,16($a_triangle)
        shlqbyi $own_sides,$triangle,8
        and     $own_sides,$own_sides,$k_sides
        ceq     $t,$own_sides,$sides
        brz     $t,whole
        ori     $more_total,$total,0
        clgt    $t,$vertices,$corners
        orc     $bad,$bad,$t
    .irp of, 0,1,2
        rotqbyi $slot,$slots,4+4*\of
        rotqbyi $word,$words,4+4*\of
probe_\of:
        lqx     $entry,$a_memory,$slot
        ceq     $found,$entry,$word
        xor     $is_free,$entry,$word
        rotmi   $is_free,$is_free,-24
        or      $is_free,$is_free,$found
        brz     $is_free,taken_\of
        shufb   $fresh,$word,$more_total,$m_pair
        fsm     $t,$found
        selb    $fresh,$fresh,$entry,$t
        stqx    $fresh,$a_memory,$slot                  # may alias
        shli    $at,$more_total,4
        stqx    $fresh,$a_own,$at
        rotqbyi $index+\of,$fresh,4
        a       $more_total,$more_total,$found
        ai      $more_total,$more_total,1
    .endr
        ai      $more,$count,1
        shli    $bytes,$more,2
        ai      $bytes,$bytes,15
        andi    $bytes,$bytes,-16
        shli    $t,$more_total,4
        a       $bytes,$bytes,$t
        cgt     $over,$bytes,$k_full
        cgti    $t,$more,MESH_FACES
        or      $over,$over,$t
        brnz    $over,cut
        ori     $count,$more,0
        ori     $total,$more_total,0
        hash    $following
        shlqbyi $face,$triangle,4
        rotmi   $face,$face,-24
        shli    $index,$index,24
        shli    $index+1,$index+1,16
        shli    $index+2,$index+2,8
        or      $face,$face,$index
        or      $index+1,$index+1,$index+2
        or      $face,$face,$index+1
        lqd     $t,0($a_face)
        cwd     $m_word,0($a_face)
        shufb   $t,$face,$t,$m_word
        stqd    $t,0($a_face)
        ai      $a_face,$a_face,4
        xor     $following,$following,$triangle
        clgt    $better,$best,$following
        cgt     $t,$bytes,$k_least
        andc    $better,$t,$better
        selb    $best,$best,$following,$better
        selb    $cut_count,$cut_count,$count,$better
        selb    $cut_total,$cut_total,$total,$better
        ai      $a_triangle,$a_triangle,16
        ai      $left,$left,-1
        brnz    $left,next_triangle
        br      whole

    .irp of, 0,1,2
taken_\of:
        ai      $slot,$slot,16
        and     $slot,$slot,$k_slots
        br      probe_\of
    .endr

cut:    ceqi    $t,$cut_count,0
        selb    $count,$cut_count,$count,$t
        selb    $total,$cut_total,$total,$t
        # The first word was the code.
whole:  shlqbyi $bad,$bad,4
        orx     $bad,$bad
        brnz    $bad,damaged
        il      $t,0
        ori     $a_to,$a_block,0
        il      $left,MESH_BLOCK/256
next_clear:
    .irp of, 0,1,2,3,4,5,6,7,8,9,10,11,12,13,14,15
        stqd    $t,16*\of($a_to)
    .endr
        ai      $a_to,$a_to,256
        ai      $left,$left,-1
        brnz    $left,next_clear                        # at least 8 passes

        cgti    $few,$count,FEW
        sfi     $levels,$few,1
        shli    $nodes,$few,2
        sfi     $nodes,$nodes,1
        load_constant $t,MESH_MAGIC
        shufb   $word,$t,$number,$m_pair
        il      $t,MESH_LEAF
        shufb   $t,$t,$levels,$m_pair
        shufb   $word,$word,$t,$m_two_pairs
        stqd    $word,0($a_block)
        shufb   $word,$nodes,$count,$m_pair
        shufb   $t,$total,$sides,$m_pair
        shufb   $word,$word,$t,$m_two_pairs
        stqd    $word,16($a_block)

        lqa     $lanes,runs
        splat   $counts,$count,$m_splat
        brnz    $few,many
        # Four runs, of which the first are the longest.
        ai      $per,$counts,3
        rotmi   $per,$per,-2
        mpy     $first,$lanes,$per
        a       $last,$first,$per
        minimum $first,$first,$counts,$t
        minimum $last,$last,$counts,$t
        sf      $length,$first,$last
        ceqi    $t,$length,0
        shli    $first,$first,2
        shli    $length,$length,16
        or      $first,$first,$length
        andc    $first,$first,$t
        stqd    $first,MESH_HEADER_SIZE+BOXES_child($a_block)
        br      faces
many:   lqa     $word,lower_nodes
        stqd    $word,MESH_HEADER_SIZE+BOXES_child($a_block)
    .irp node, 1,2,3,4
        mpy     $first,$lanes,$counts
        a       $last,$first,$counts
        rotmi   $first,$first,-4
        rotmi   $last,$last,-4
        sf      $length,$first,$last
        shli    $first,$first,2
        shli    $length,$length,16
        or      $first,$first,$length
        stqd    $first,MESH_HEADER_SIZE+\node*BOXES_SIZE+BOXES_child($a_block)
        ai      $lanes,$lanes,4
    .endr
faces:  mpyi    $a_to,$nodes,BOXES_SIZE
        shli    $t,$total,4
        a       $a_to,$a_to,$t
        ai      $a_to,$a_to,MESH_HEADER_SIZE
        a       $a_to,$a_to,$a_block
        il      $a_from,FACES_AT
        a       $a_from,$a_from,$a_memory
        ai      $quads,$count,3
        rotmi   $quads,$quads,-2
next_faces:
        lqd     $face,0($a_from)
        stqd    $face,0($a_to)
        ai      $a_from,$a_from,16
        ai      $a_to,$a_to,16
        ai      $quads,$quads,-1
        brnz    $quads,next_faces
        # Triangles that were cut off may be in the last quadword.
        shli    $t,$count,2
        sfi     $t,$t,0
        andi    $t,$t,15
        il      $ones,-1
        shlqby  $ones,$ones,$t
        and     $face,$face,$ones
        stqd    $face,-16($a_to)

        splat   $low,$low,$m_splat
        fsmbi   $ones,0xf0f0
        andi    $word,$ones,16
        ai      $quads,$total,1
        rotmi   $quads,$quads,-1
next_elements:
        lqd     $entry,0($a_own)
        lqd     $fresh,16($a_own)
        shufb   $entry,$entry,$fresh,$m_element
        and     $entry,$entry,$k_index
        shli    $entry,$entry,4
        a       $entry,$entry,$low
        selb    $entry,$entry,$word,$ones
        stqd    $entry,0($a_list)
        ai      $a_own,$a_own,32
        ai      $a_list,$a_list,16
        ai      $quads,$quads,-1
        brnz    $quads,next_elements
        ori     $3,$count,0
        bi      $lr

damaged:
        il      $3,0
        bi      $lr
endfunction sort_pack
