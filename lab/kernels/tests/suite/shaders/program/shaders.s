# Shaders that keep to the contract, and that don't.

        .include "work_unit.inc"
        .include "macros.inc"
        .include "shader.inc"

# Lit red becomes the first parameter, lit green the distance, and the material gets a mirror.
shader good
        lqd     $10,MATERIAL_parameters($6)
        splat_mask $11
        splat   $10,$10,$11
        stqd    $10,-SHADER_STACK($sp)                  # all of the stack that it has
    .irp row, 0,1,2,3
        lqd     $12,16*\row($5)
        lqd     $13,SURFACES_lit_red+16*\row($3)
        selb    $13,$13,$10,$12
        stqd    $13,SURFACES_lit_red+16*\row($3)
        lqd     $13,SURFACES_lit_green+16*\row($3)
        lqd     $14,RAYS16_t+16*\row($4)
        selb    $13,$13,$14,$12
        stqd    $13,SURFACES_lit_green+16*\row($3)
    .endr
        lqd     $13,SURFACES_flags($3)
        il      $14,MATERIAL_MIRRORS
        or      $13,$13,$14
        stqd    $13,SURFACES_flags($3)
        bi      $lr
endshader good

shader lanes
        lqd     $10,SURFACES_leave+16*2($3)
        ai      $10,$10,1
        stqd    $10,SURFACES_leave+16*2($3)
        bi      $lr
endshader lanes

shader pointer
        ai      $sp,$sp,-16
        bi      $lr
endshader pointer

shader register
        rotqbyi $90,$90,1
        bi      $lr
endshader register

shader stack
        stqd    $10,-SHADER_STACK-16($sp)
        bi      $lr
endshader stack
