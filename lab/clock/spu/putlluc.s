# Unconditional writes of one line, each waited for.
        .include "clock.inc"

        .text
        .global putlluc
putlluc:
        begins
1:      atomic  PUTLLUC, $20, $21
        ai      $passes,$passes,-1
        brnz    $passes,1b
        ends
        bi      $0
