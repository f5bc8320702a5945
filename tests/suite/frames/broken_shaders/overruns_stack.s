# A shader with a buffer larger than its stack.

        .include "macros.inc"
        .include "shader.inc"

        .set    BUFFER,SHADER_STACK+64

shader overruns_stack
        il      $10,BUFFER
        sf      $11,$10,$sp
        il      $12,BUFFER-16
fill:
        stqx    $12,$11,$12
        ai      $12,$12,-16
        cgti    $13,$12,-1
        brnz    $13,fill
        bi      $lr
endshader overruns_stack
