# Calls the shaders of a packet of surfaces. If the frame requests it, also checks that they keep
# their contract, which is in docs/shaders.md.
#
# The driver's state is in the registers that a shader must preserve. So a check keeps its copies
# in memory, and restores the registers before it returns.

        .include "work_unit.inc"
        .include "macros.inc"
        .include "driver.inc"
        .include "whitted.inc"
        .include "shader.inc"

        .set    KEPT_REGISTERS,48                       # $80 to $127
        .set    PATTERN,0x5eed57ac

# The stack frame of shaders_run during a call, from its stack pointer.
        .set    CALL_surfaces,32
        .set    CALL_rays,48
        .set    CALL_material,64
        .set    CALL_index,80
        .set    CALL_left,96                            # materials of lanes that are left
        .set    CALL_mask,160
        .set    CALL_kept,224
        .set    CALL_SIZE,CALL_kept+16*KEPT_REGISTERS

# The surfaces before a shader, then the registers after it, at the end of the lists of nodes. The
# patches that rays have hit are in front of it.
        .set    KEPT,ROOT_LISTS-(SURFACES_SIZE+127)/128*128
    .if 16*KEPT_REGISTERS > ROOT_LISTS-KEPT || (16*SMALL_BATCH+3)*PATCH_SIZE > KEPT-OBJECT_LIST
        .error  "the registers that a shader must preserve don't fit into the lists of nodes"
    .endif

        .section .bss
        .align  7
        .global shading
shading:                                # the shaders' context
        .skip   SHADING_SIZE
kept_stack:
        .skip   16

        .set    flags,10
        .set    surfaces,11
        .set    t_size,12
        .set    index,13
        .set    most,14
        .set    other,15
        .set    c_larger,16
        .set    mask,17
        .set    table,18
        .set    table_end,19
        .set    known,20
        .set    status,21
        .set    limit,22
        .set    left,24                                 # to 27

# most = the larger one of most and other, unsigned.
.macro  larger
        clgt    $c_larger,$other,$most
        selb    $most,$most,$other,$c_larger
.endm

# Whether the frame requests checks.
.macro  checked out:req
        ila     \out,frame
        load_word \out,FRAME_features,\out
        andi    \out,\out,FEATURE_CHECK_SHADERS
.endm

# shaders_run   shades the surfaces with shaders of their own, one material after the other
#   In      $3 SURFACES, $4 RAYS16
#   Out     $3 STATUS_Done, or STATUS_Shader + (RULE_ value << 8) + (register << 16)
#           + (shader << 24)
#   Uses    $3-$79, CALL_SIZE of stack and the shader's
function shaders_run
        ori     $surfaces,$3,0
        il      $3,STATUS_Done
        load_word $flags,SURFACES_flags,$surfaces
        andi    $flags,$flags,MATERIAL_SHADED
        biz     $flags,$lr
        stqd    $lr,16($sp)
        stqd    $sp,-CALL_SIZE($sp)
        il      $t_size,-CALL_SIZE
        a       $sp,$sp,$t_size
        stqd    $surfaces,CALL_surfaces($sp)
        stqd    $4,CALL_rays($sp)
    .irp row, 0,1,2,3
        lqd     $left,SURFACES_material+16*\row($surfaces)
        stqd    $left,CALL_left+16*\row($sp)
    .endr
next_material:
        il      $most,0
    .irp row, 0,1,2,3
        lqd     $left+\row,CALL_left+16*\row($sp)
        ori     $other,$left+\row,0
        larger
    .endr
        rotqbyi $other,$most,8
        larger
        rotqbyi $other,$most,4
        larger
        il      $3,STATUS_Done
        brz     $most,return
    .irp row, 0,1,2,3
        ceq     $mask,$left+\row,$most
        stqd    $mask,CALL_mask+16*\row($sp)
        andc    $mask,$left+\row,$mask
        stqd    $mask,CALL_left+16*\row($sp)
    .endr
        load_word $flags,MATERIAL_flags,$most
        andi    $flags,$flags,MATERIAL_SHADED
        brz     $flags,next_material

        load_word $index,MATERIAL_shader,$most
        stqd    $most,CALL_material($sp)
        stqd    $index,CALL_index($sp)
        ila     $table,shaders_start
        ila     $table_end,shaders_end
        sf      $table_end,$table,$table_end
        rotmi   $table_end,$table_end,-SHADER_ENTRY_LOG2
        clgt    $known,$table_end,$index
        il      $status,RULE_KNOWN
        brz     $known,refuse
        checked $flags
        brz     $flags,keep_nothing
        brsl    $lr,shader_keep
keep_nothing:
        lqd     $index,CALL_index($sp)
        shli    $index,$index,SHADER_ENTRY_LOG2
        ila     $table,shaders_start
        lqx     $index,$index,$table                    # its address is the first word
        lqd     $3,CALL_surfaces($sp)
        lqd     $4,CALL_rays($sp)
        ai      $5,$sp,CALL_mask
        lqd     $6,CALL_material($sp)
        ila     $7,shading
        bisl    $lr,$index
        checked $flags
        brz     $flags,next_material
        brsl    $lr,shader_broke
        ori     $status,$3,0
        brz     $status,next_material
refuse:
        lqd     $index,CALL_index($sp)
        il      $limit,255
        clgt    $c_larger,$index,$limit
        selb    $index,$index,$limit,$c_larger
        shli    $index,$index,24
        shli    $status,$status,8
        a       $status,$status,$index
        ai      $3,$status,STATUS_Shader
return:
        il      $t_size,CALL_SIZE
        a       $sp,$sp,$t_size
        lqd     $lr,16($sp)
        bi      $lr
endfunction shaders_run

        .set    count,10
        .set    at,11
        .set    a_from,12
        .set    quad,13
        .set    a_pattern,14
        .set    pattern,15

# shader_keep   saves everything that a shader must preserve, and fills the memory below its stack
#   In      the stack frame of shaders_run
#   Uses    $10-$15
function shader_keep
        stqa    $sp,kept_stack
        .set    number,80
    .rept KEPT_REGISTERS
        stqd    $number,CALL_kept+16*(number-80)($sp)
        .set    number,number+1
    .endr
        lqd     $a_from,CALL_surfaces($sp)
        ila     $a_pattern,arena+KEPT
        il      $at,SURFACES_SIZE-16
next_kept:
        lqx     $quad,$a_from,$at
        stqx    $quad,$a_pattern,$at
        ai      $at,$at,-16
        cgti    $count,$at,-1
        brnz    $count,next_kept

        load_constant $pattern,PATTERN
        il      $at,-2*SHADER_STACK
        a       $a_pattern,$sp,$at
        il      $at,SHADER_STACK-16
next_filled:
        stqx    $pattern,$a_pattern,$at
        ai      $at,$at,-16
        cgti    $count,$at,-1
        brnz    $count,next_filled
        bi      $lr
endfunction shader_keep

        .set    rule,3
        .set    a_now,16
        .set    now,17
        .set    differs,18
        .set    mask0,20                                # to 23
        .set    broken_lanes,24
        .set    broken_stack,25
        .set    broken_pointer,26
        .set    register,27

# broken, in word 0, is 0 if all of differs is 0.
.macro  any_word broken:req
        orx     \broken,$differs
.endm

# shader_broke   finds what a shader did not preserve; restores registers and the stack pointer
#   In      the stack frame of shaders_run
#   Out     $3 0, or a RULE_ value + (register << 8)
#   Uses    $3, $10-$27
function shader_broke
        lqa     $quad,kept_stack
        xor     $differs,$quad,$sp
        any_word $broken_pointer
        ori     $sp,$quad,0

        # Surfaces are in rows of four, except for the last quadword, where a shader may add flags.
        lqd     $a_now,CALL_surfaces($sp)
        ila     $a_from,arena+KEPT
    .irp row, 0,1,2,3
        lqd     $mask0+\row,CALL_mask+16*\row($sp)
    .endr
        il      $differs,0
        il      $at,0
        il      $count,SURFACES_flags/64
next_rows:
    .irp row, 0,1,2,3
        lqx     $quad,$a_from,$at
        lqx     $now,$a_now,$at
        xor     $quad,$quad,$now
        andc    $quad,$quad,$mask0+\row
        or      $differs,$differs,$quad
        ai      $at,$at,16
    .endr
        ai      $count,$count,-1
        brnz    $count,next_rows
        any_word $broken_lanes

        load_constant $pattern,PATTERN
        il      $at,-2*SHADER_STACK
        a       $a_pattern,$sp,$at
        il      $differs,0
        il      $at,SHADER_STACK-16
next_pattern:
        lqx     $quad,$a_pattern,$at
        xor     $quad,$quad,$pattern
        or      $differs,$differs,$quad
        ai      $at,$at,-16
        cgti    $count,$at,-1
        brnz    $count,next_pattern
        any_word $broken_stack

        .set    number,80
    .rept KEPT_REGISTERS
        stqd    $number,16*(number-80)($a_from)
        lqd     $number,CALL_kept+16*(number-80)($sp)
        .set    number,number+1
    .endr
        il      $rule,RULE_REGISTER
        il      $register,1
        brnz    $broken_pointer,names_register
        il      $register,80
        ai      $a_now,$sp,CALL_kept
next_register:
        lqd     $quad,0($a_from)
        lqd     $now,0($a_now)
        xor     $differs,$quad,$now
        any_word $differs
        brnz    $differs,names_register
        ai      $a_from,$a_from,16
        ai      $a_now,$a_now,16
        ai      $register,$register,1
        cgti    $count,$register,127
        brz     $count,next_register
        il      $rule,RULE_STACK
        binz    $broken_stack,$lr
        il      $rule,RULE_LANES
        binz    $broken_lanes,$lr
        il      $rule,0
        bi      $lr
names_register:
        shli    $register,$register,8
        a       $rule,$rule,$register
        bi      $lr
endfunction shader_broke
