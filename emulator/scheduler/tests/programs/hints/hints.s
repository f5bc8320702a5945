# Hints at all distances, in code whose symbols have no sizes.

        .text
        .globl _start
_start:
        hbrr near,second
        .rept 7
        lnop
        .endr
near:   brz $3,second
        hbrr late,second
        .rept 8
        lnop
        .endr
late:   brz $3,second
        hbrr far,second
        .rept 14
        lnop
        .endr
far:    brz $3,second
        hbrr again,second
        hbrr far,second
        .rept 15
        lnop
        .endr
again:  br second

        .globl second
second: bi $0
