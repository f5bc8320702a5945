# Two SPUs increment a line's first word in turn: SPU 0 if it is even, SPU 1 if it is odd. The one
# that waits reads the line again and again.
        .include "clock.inc"

        .text
        .global ping_pong
ping_pong:
        begins
1:      atomic  GETLLAR, $20, $21
        lqa     $22,LINE
        clgt    $23,$passes,$22
        andi    $24,$22,1
        ai      $22,$22,1
        brz     $23,2f
        ceq     $24,$24,$number
        brz     $24,1b
        stqa    $22,LINE
        atomic  PUTLLC, $20, $21
        br      1b
2:      ends
        bi      $0
