# The entry that an image must have. Nobody starts the image of the kernels alone: they are called
# by name, one by one.
        .section .text.start,"ax",@progbits
        .align  3
        .global _start
_start:
        stop    0x1ffd

# The kernels for depth shading, boxes and refitted meshes are directly in front of those for
# colours, so that the bench has all the memory in front of them.
        .global build_place, depth_place, boxes_place
        .set    build_place,0x25a00
        .set    depth_place,0x26800
        .set    boxes_place,0x30e80
