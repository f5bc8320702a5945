# Processes a block of the mesh when it has arrived in local store.

        .include "work_unit.inc"
        .include "macros.inc"
        .include "driver.inc"
        .include "whitted.inc"
        .include "mesh.inc"

        .section .data.mesh,"aw",@progbits
        .align  4
arrived:                                # the block's number
        .skip   16
        .global height_scratch
height_scratch:                         # space of HEIGHT_SCRATCH bytes that nobody needs then
        .int    arena+MATERIAL_FIRST,0,0,0

        .set    NEXT,10
        registers a_frame

# mesh_arrive   checks a block and makes its positions relative to the eye; gives up if it is damaged
#   In      $3 address, $4 number
#   Uses    $3-$79
function mesh_arrive
        rotmi   $a_frame,$4,-23                         # HEIGHT_BLOCK
        brnz    $a_frame,height_arrive
        hbrr    prepare_call,mesh_prepare
        enter
        stqa    $4,arrived
        ila     $a_frame,frame
        ai      $5,$a_frame,FRAME_mesh_eye
        lqa     $6,block_limit
        load_word $7,FRAME_mesh_material_count,$a_frame
        lqa     $8,sides_known
prepare_call:
        brsl    $lr,mesh_prepare
        lqa     $4,arrived
        brnz    $3,bad_block
        leave
bad_block:
        shli    $3,$4,8
        ori     $3,$3,STATUS_MeshBlock
        br      give_up
endfunction mesh_arrive
        .global bad_block
