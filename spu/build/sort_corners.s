# sort_corners   the DMA list that fetches the corners of triangles
#   C       int sort_corners(const void *triangles, int twos, void *list, unsigned low,
#                            unsigned vertices);
#   In      $3 BUILD_TRIANGLE records, $4 twos of them, at least 1, $5 where the list goes, $6 low
#           word of the address of the mesh's vertices, $7 how many these are, at most 2^24;
#           pointers 16-aligned
#   Out     $3 0, or something else if a triangle has another vertex than the mesh has. The list
#           has an element of 16 bytes for each corner
#   Uses    $3-$7, $10-$36
#   Domain  any
#   Error   0
#   Twin    lab/twins/src/sort.rs

        .include "work_unit.inc"
        .include "macros.inc"

        .set    NEXT,3
        registers a_triangle,twos,a_list,low,vertices
        .set    NEXT,10
        registers m_splat,k_index,k_size,m_size,m_ab,m_ca,m_bc,bad,wrong
        registers corners                               # and 20
        .set    NEXT,corners+2
        registers element                               # to 23
        .set    NEXT,element+3

        .section .rodata.sort,"a",@progbits
        .align  4
corner_words:                                           # of two triangles, in every second word
        .int    0x80808080,0x04050607,0x80808080,0x08090a0b
        .int    0x80808080,0x0c0d0e0f,0x80808080,0x14151617
        .int    0x80808080,0x18191a1b,0x80808080,0x1c1d1e1f

function sort_corners
        splat_mask $m_splat
        lqa     $m_ab,corner_words
        lqa     $m_ca,corner_words+16
        lqa     $m_bc,corner_words+32
        ilhu    $k_index,0xff
        iohl    $k_index,0xffff
        fsmbi   $m_size,0xf0f0
        andi    $k_size,$m_size,16
        splat   $low,$low,$m_splat
        splat   $vertices,$vertices,$m_splat
        il      $bad,0
next_two:
    .irp of, 0,1
        lqd     $corners+\of,16*\of($a_triangle)
        and     $corners+\of,$corners+\of,$k_index
        clgt    $wrong,$vertices,$corners+\of
        orc     $bad,$bad,$wrong
        shli    $corners+\of,$corners+\of,4
        a       $corners+\of,$corners+\of,$low
    .endr
        shufb   $element,$corners,$corners,$m_ab
        shufb   $element+1,$corners,$corners+1,$m_ca
        shufb   $element+2,$corners,$corners+1,$m_bc
    .irp at, 0,1,2
        selb    $element+\at,$element+\at,$k_size,$m_size
        stqd    $element+\at,16*\at($a_list)
    .endr
        ai      $a_triangle,$a_triangle,32
        ai      $a_list,$a_list,48
        ai      $twos,$twos,-1
        brnz    $twos,next_two
        # The first words were the codes.
        shlqbyi $bad,$bad,4
        orx     $3,$bad
        bi      $lr
endfunction sort_corners
