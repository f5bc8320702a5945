# Commands of one size with a number of them in flight, one under each tag: each waits for the one
# that had its tag and buffer before. Beside it the same loop without commands, which measures what
# the loop itself takes.
        .include "clock.inc"

        .set    offset, 20
        .set    tag, 21
        .set    lsa, 22
        .set    base, 23
        .set    ea, 24
        .set    mask, 25
        .set    word, 26
        .set    one, 27
        .set    last, 28

        .macro  loop_of channel:req
        il      $offset,0
        il      $tag,0
        il      $one,1
        ila     $base,BUFFERS
        ila     $lsa,BUFFERS
        begins
1:      shl     $mask,$one,$tag
        hbrr    2f,1b
        wait_tags $mask,$word
        a       $ea,$ea_low,$offset
        wrch    $ch16,$lsa
        wrch    $ch17,$ea_high
        wrch    $ch18,$ea
        wrch    $ch19,$size
        wrch    $ch20,$tag
        wrch    $ch\channel,$opcode
        a       $offset,$offset,$size
        ai      $tag,$tag,1
        a       $lsa,$lsa,$size
        ceq     $last,$tag,$depth
        and     $offset,$offset,$ea_mask
        andc    $tag,$tag,$last
        selb    $lsa,$lsa,$base,$last
        ai      $passes,$passes,-1
2:      brnz    $passes,1b
        shl     $mask,$one,$depth
        ai      $mask,$mask,-1
        wait_tags $mask,$word
        ends
        bi      $0
        .endm

        .text
        .global stream
stream: loop_of 21

        .global stream_without_command
stream_without_command:
        loop_of 20
