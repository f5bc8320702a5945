# A shader that changes one of the driver's registers.

        .include "macros.inc"
        .include "shader.inc"

shader changes_90
        il      $90,7
        bi      $lr
endshader changes_90
