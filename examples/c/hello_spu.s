# Prints a line by the C library's printf, and exits with the number of characters. printf runs on
# the PPE: a stop asks for it, and the word after the stop is the call's number. hello_spu.c is
# the same for a compiler.
        .set    PRINTF,37

        .text
        .global _start
_start: stop    0x2100
        .long   PRINTF<<24 + arguments
        lqa     $3,arguments            # the result has taken the place of the first argument
        andi    $3,$3,0xff              # the exit status is a part of an instruction,
        lqr     $4,exit
        cwd     $5,0($sp)
        a       $3,$3,$4
        shufb   $4,$3,$4,$5
        stqr    $4,exit                 # which is made just before it runs
        sync
        br      exit

        .align  4
exit:   stop    0x2000
        nop
        nop
        nop

# Each argument has a quadword. After the format comes a va_list: where the arguments are, and
# where the stack had more of them if there were too many for registers.
        .data
        .align  4
arguments:
        .long   format, 0, 0, 0
        .long   others, 0, 0, 0
        .long   0, 0, 0, 0
others: .long   moon, 0, 0, 0
        .long   -42, 0, 0, 0
        .double 3.14159265358979, 0
        .quad   123456789012345, 0
        .long   '!', 0, 0, 0
format: .asciz  "hello, %s: %d, %.3f, %lld%c\n"
moon:   .asciz  "moon"
