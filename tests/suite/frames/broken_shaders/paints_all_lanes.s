# A shader that colours all lanes of the packet, including those that it must not shade.

        .include "work_unit.inc"
        .include "macros.inc"
        .include "shader.inc"

shader paints_all_lanes
        ilhu    $10,0x3f80
    .irp row, 0,1,2,3
        stqd    $10,SURFACES_red+16*\row($3)
    .endr
        bi      $lr
endshader paints_all_lanes
