# Calls dot on two arrays of 64 floats. The truncated result is in $3 when it exits, with status 0.
        .text
        .align  3
        .global _start
_start:
        ila     $3,first
        ila     $4,second
        il      $5,16
        brsl    $lr,dot
        cflts   $3,$3,0
        stop    0x2000

        .data
        .align  4
first:  .fill   64,4,0x3f000000         # 0.5
second: .fill   64,4,0x3fa00000         # 1.25
