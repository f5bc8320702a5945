# A shader that changes the driver's number of tiles: the next work unit's are beyond it.

        .include "macros.inc"
        .include "shader.inc"

shader changes_93
        il      $93,0
        bi      $lr
endshader changes_93
