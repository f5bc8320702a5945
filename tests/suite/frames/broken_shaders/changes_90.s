# A shader that changes a register of the driver's.

        .include "macros.inc"
        .include "shader.inc"

shader changes_90
        il      $90,7
        bi      $lr
endshader changes_90
