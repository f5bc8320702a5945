# printf with every kind of argument, through a va_list; returns the number of characters.
        .include "runtime.inc"

        .type   main,@function
main:
        enter
        ila     $3,format
        ila     $4,moon
        il      $5,-42
        lqr     $6,pi
        lqr     $7,large
        il      $8,'!'
        brsl    $lr,printf
        leave

        .section .rodata
        .align  4
pi:     .double 3.14159265358979, 0.0
large:  .quad   123456789012345, 0
format: .asciz  "hello, %s: %d, %.3f, %lld%c\n"
moon:   .asciz  "moon"
