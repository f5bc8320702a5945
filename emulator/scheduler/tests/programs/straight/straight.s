# One example of each rule that straight-line code can show.

        .text
        .globl _start
        .type _start,@function
_start:
        il $3,1
        lqa $4,0x100
        a $5,$3,$4
        shufb $6,$5,$5,$3
        mpy $7,$3,$3
        fa $8,$3,$3
        dfa $9,$3,$3
        lqd $10,0($4)
        br 1f
        .size _start,.-_start
        .type table,@object
table:
        .long 0x00800000
        .long 0x12345678
        .globl after
        .type after,@function
after:
1:      bi $0
        .size after,.-after
