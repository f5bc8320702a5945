# Notes in places where they can't be right.

        .macro twice
        il $3,1
        il $4,2
        .endm

        .text
        .globl _start
_start:
        twice                                           # 0e two instructions
                                                        # 2e none
        ai $3,$3,1                                      # 2e
        .long 0x00800000
        ai $3,$3,1                                      # 4e after an invalid instruction
