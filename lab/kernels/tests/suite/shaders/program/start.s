# The symbols that spu/main/shaders.s needs from the program around it.

        .include "work_unit.inc"

        .section .text.start,"ax",@progbits
        .align  3
        .global _start
        .type   _start, @function
_start:
        stop    0x1fff
        .size   _start, .-_start

        .section .bss
        .align  7
        .global frame
frame:  .skip   FRAME_SIZE
