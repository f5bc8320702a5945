# The entry that an image must have. Nobody starts the image of the kernels alone: they are called
# by name, one by one.
        .section .text.start,"ax",@progbits
        .align  3
        .global _start
_start:
        stop    0x1ffd

# Directly in front of the kernels for colours, so that the bench has all the memory in front of
# it.
        .global boxes_place
        .set    boxes_place,0x32e00
