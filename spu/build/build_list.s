# build_list   the DMA list that fetches a leaf block's vertices
#   C       int build_list(const unsigned *sources, int quads, void *list, unsigned low,
#                          unsigned vertices, unsigned count);
#   In      $3 the words that list the block's vertices, $4 quadwords of them, at least 1, $5 where
#           the list goes, $6 low word of the address of the mesh's vertices, $7 how many these are,
#           at most 2^24, $8 how many the block has; pointers 16-aligned
#   Out     $3 0, or something else if the words list other vertices than the mesh has, or another
#           number of them. The list has an element of 16 bytes a vertex for each word; the number
#           of runs and the zeros at the end give elements without bytes
#   Uses    $3-$8, $10-$24   Saves  -   Stack  0   Calls  -
#   Domain  any
#   Error   0
#   Twin    lab/twins/src/build.rs

        .include "work_unit.inc"
        .include "macros.inc"

        .set    NEXT,3
        registers a_source,quads,a_list,low,vertices,count
        .set    NEXT,10
        registers m_splat,m_first,m_second,k_index,bad,total
        registers source,length,end,wrong,address,size,first,second,t

        .section .rodata.build,"a",@progbits
        .align  4
first_elements:                         # a size and an address, twice
        .int    0x10111213,0x00010203,0x14151617,0x04050607
second_elements:
        .int    0x18191a1b,0x08090a0b,0x1c1d1e1f,0x0c0d0e0f

function build_list
        splat_mask $m_splat
        lqa     $m_first,first_elements
        lqa     $m_second,second_elements
        ilhu    $k_index,0xff
        iohl    $k_index,0xffff
        splat   $low,$low,$m_splat
        splat   $vertices,$vertices,$m_splat
        il      $bad,0
        il      $total,0
next_four:
        lqd     $source,0($a_source)
        rotmi   $length,$source,-24
        and     $source,$source,$k_index
        a       $end,$source,$length
        clgt    $wrong,$end,$vertices
        or      $bad,$bad,$wrong
        a       $total,$total,$length
        shli    $address,$source,4
        a       $address,$address,$low
        shli    $size,$length,4
        shufb   $first,$address,$size,$m_first
        shufb   $second,$address,$size,$m_second
        stqd    $first,0($a_list)
        stqd    $second,16($a_list)
        ai      $a_source,$a_source,16
        ai      $a_list,$a_list,32
        ai      $quads,$quads,-1
        brnz    $quads,next_four
        rotqbyi $t,$total,8
        a       $total,$total,$t
        rotqbyi $t,$total,4
        a       $total,$total,$t
        xor     $total,$total,$count
        orx     $bad,$bad
        or      $3,$bad,$total
        bi      $lr
endfunction build_list
