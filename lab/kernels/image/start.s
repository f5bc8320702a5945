# The entry that an image must have. Nobody starts the image of the kernels alone: they are called
# by name, one by one.
        .section .text.start,"ax",@progbits
        .align  3
        .global _start
_start:
        stop    0x1ffd

# The kernels for depth shading, boxes and height fields are directly in front of those for colours,
# and the ones for refitting and building meshes after those for meshes, so that the bench has all
# the memory in front of them.
        .global depth_place, boxes_place, height_place, sort_place, build_place
        .set    depth_place,0x26b80
        .set    boxes_place,0x31200
        .set    height_place,0x32480
        .set    build_place,0x3cd00
        .set    sort_place,0x3db00
