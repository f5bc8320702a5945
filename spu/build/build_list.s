# build_list   the DMA list that fetches a leaf block's vertices
#   C       int build_list(const unsigned *sources, int count, void *list, unsigned low,
#                          unsigned vertices);
#   In      $3 the indices of the block's vertices, $4 count, at least 1, $5 where the list goes, $6
#           low word of the address of the mesh's vertices, $7 how many these are; pointers
#           16-aligned. Sources and list are used up to a multiple of four.
#   Out     $3 0, or something else if there is no vertex of an index
#   Uses    $3-$7, $10-$24   Saves  -   Stack  0   Calls  -
#   Domain  any
#   Error   0
#   Twin    lab/twins/src/build.rs

        .include "work_unit.inc"
        .include "macros.inc"

        .set    NEXT,3
        registers a_source,count,a_list,low,vertices
        .set    NEXT,10
        registers m_splat,k_size,k_last,m_first,m_second,bad
        registers source,wrong,address,first,second

        .section .rodata.build,"a",@progbits
        .align  4
first_elements:                         # a size and an address, twice
        .int    0x10111213,0x00010203,0x10111213,0x04050607
second_elements:
        .int    0x10111213,0x08090a0b,0x10111213,0x0c0d0e0f

function build_list
        splat_mask $m_splat
        il      $k_size,MESH_VERTEX_SIZE
        lqa     $m_first,first_elements
        lqa     $m_second,second_elements
        splat   $low,$low,$m_splat
        splat   $k_size,$k_size,$m_splat
        ai      $k_last,$vertices,-1
        splat   $k_last,$k_last,$m_splat
        il      $bad,0
        ai      $count,$count,3
        rotmi   $count,$count,-2
next_four:
        lqd     $source,0($a_source)
        clgt    $wrong,$source,$k_last
        or      $bad,$bad,$wrong
        shli    $address,$source,4
        a       $address,$address,$low
        shufb   $first,$address,$k_size,$m_first
        shufb   $second,$address,$k_size,$m_second
        stqd    $first,0($a_list)
        stqd    $second,16($a_list)
        ai      $a_source,$a_source,16
        ai      $a_list,$a_list,32
        ai      $count,$count,-1
        brnz    $count,next_four
        orx     $3,$bad
        bi      $lr
endfunction build_list
