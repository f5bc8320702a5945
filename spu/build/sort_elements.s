# sort_elements   sorts triangles by their codes; those with equal codes keep their order
#   C       void sort_elements(void *triangles, int fours, void *other, void *table);
#   In      $3 BUILD_TRIANGLE records, $4 fours of them, at least 1, $5 as many bytes for
#           intermediate results, $6 4,096 bytes more; pointers 16-aligned
#   Out     the records, sorted
#   Uses    $3-$6, $10-$33
#   Domain  any
#   Error   0
#   Twin    lab/twins/src/sort.rs
#
# A radix sort, by eight bits at a time from the last ones on. A quadword of the table counts the
# triangles that have the same bits. Then it has the address where the next one of them goes.

        .include "work_unit.inc"
        .include "macros.inc"

        .set    BINS,256
        .set    NEXT,3
        registers a_triangle,fours,a_other,a_table
        .set    NEXT,10
        registers turn,a_from,left,a_bin,place,count,next
        registers triangle                              # to 20
        .set    NEXT,triangle+4
        registers bin                                   # to 24
        .set    NEXT,bin+4
        registers t                                     # to 28
        .set    NEXT,t+4
        registers size

# The offsets of four triangles' quadwords in the table.
.macro  bins
    .irp of, 0,1,2,3
        lqd     $triangle+\of,16*\of($a_from)
        rotm    $bin+\of,$triangle+\of,$turn
        andi    $bin+\of,$bin+\of,BINS-1
        shli    $bin+\of,$bin+\of,4
    .endr
.endm

function sort_elements
        il      $turn,0
next_bits:
        ori     $a_bin,$a_table,0
        il      $left,BINS/8
        il      $count,0
next_clear:
    .irp of, 0,1,2,3,4,5,6,7
        stqd    $count,16*\of($a_bin)
    .endr
        ai      $a_bin,$a_bin,8*16
        ai      $left,$left,-1
        brnz    $left,next_clear                        # at least 32 passes

        ori     $a_from,$a_triangle,0
        ori     $left,$fours,0
next_count:
        bins
    .irp of, 0,1,2,3
        lqx     $t+\of,$a_table,$bin+\of
        ai      $t+\of,$t+\of,16
        stqx    $t+\of,$a_table,$bin+\of              # may alias
    .endr
        ai      $a_from,$a_from,64
        ai      $left,$left,-1
        brnz    $left,next_count

        ori     $a_bin,$a_table,0
        il      $left,BINS/4
        ori     $place,$a_other,0
next_place:
    .irp of, 0,1,2,3
        lqd     $t+\of,16*\of($a_bin)
        stqd    $place,16*\of($a_bin)
        a       $place,$place,$t+\of
    .endr
        ai      $a_bin,$a_bin,64
        ai      $left,$left,-1
        brnz    $left,next_place                        # at least 64 passes

        ori     $a_from,$a_triangle,0
        ori     $left,$fours,0
next_four:
        bins
    .irp of, 0,1,2,3
        lqx     $t+\of,$a_table,$bin+\of
        ai      $next,$t+\of,16
        stqx    $next,$a_table,$bin+\of                # may alias
        stqd    $triangle+\of,0($t+\of)
    .endr
        ai      $a_from,$a_from,64
        ai      $left,$left,-1
        brnz    $left,next_four

        # They are where the next eight bits go.
        ori     $next,$a_triangle,0
        ori     $a_triangle,$a_other,0
        ori     $a_other,$next,0
        ai      $turn,$turn,-8
        ai      $next,$turn,32
        brnz    $next,next_bits
        bi      $lr
endfunction sort_elements
