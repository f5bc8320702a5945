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
first:  .rept   64
        .float  0.5
        .endr
second: .rept   64
        .float  1.25
        .endr
