# Atomic increments of the first word of a line by all SPUs, until it has reached the number of
# passes. Counts the increments of this SPU.
        .include "clock.inc"

        .text
        .global increments
increments:
        begins
1:      atomic  GETLLAR, $20, $21
        lqa     $22,LINE
        clgt    $23,$passes,$22
        ai      $22,$22,1
        brz     $23,2f
        stqa    $22,LINE
        atomic  PUTLLC, $20, $21
        brnz    $20,1b
        ai      $done,$done,1
        br      1b
2:      ends
        bi      $0
