# A shader that changes the driver's number of tiles, so that the next work unit is out of range.

        .include "macros.inc"
        .include "shader.inc"

shader changes_93
        il      $93,0
        bi      $lr
endshader changes_93
