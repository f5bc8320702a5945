# The entry that an image must have. Nobody starts the image of the kernels alone: they are called
# by name, one by one.
        .section .text.start,"ax",@progbits
        .align  3
        .global _start
_start:
        stop    0x1ffd

# The kernels for depth shading, boxes, height fields, colours and textures are directly in front of
# those for eye rays, and the ones for refitting and building meshes after those for meshes, so that
# the bench has all the memory in front of them.
        .global depth_place, boxes_place, height_place, colour_place, texture_place
        .global cuts_place, sort_place, build_place, objects_place
        .set    cuts_place,0x25f80
        .set    depth_place,0x27900
        .set    boxes_place,0x31f80
        .set    height_place,0x33200
        .set    colour_place,0x34b00
        .set    texture_place,0x34f00
        .set    build_place,0x3cb80
        .set    sort_place,0x3d900
        .set    objects_place,0x3ec80
