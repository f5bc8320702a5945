# Scans two numbers from standard input and prints their sum.
        .include "runtime.inc"

        .type   main,@function
main:
        enter
        ila     $3,asking
        ila     $4,first
        ila     $5,second
        brsl    $lr,scanf
        ori     $80,$3,0
        lqr     $4,first
        lqr     $5,second
        a       $4,$4,$5
        ila     $3,telling
        brsl    $lr,printf
        ori     $3,$80,0
        leave

        .section .rodata
asking: .asciz  "%d %d"
telling: .asciz "%d\n"
        .data
        .align  4
first:  .space  16
second: .space  16
