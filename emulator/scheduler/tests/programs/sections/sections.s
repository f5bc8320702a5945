# Code in two sections. In an object, both start at 0 and a branch between them is unresolved.

        .text
        .globl _start
_start:
        il $3,1                                         # 0e
        ai $3,$3,1                                      # 2e
        br other                                        # 3o

        .section .text.other,"ax"
        .globl other
other:
        lqd $4,0($3)                                    # 0o
        ai $3,$4,1                                      # 6e
        brnz $3,other                                   # 8o
