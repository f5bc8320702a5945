# The scene: fetched once a frame from main memory to where the kernels read it.

        .include "work_unit.inc"
        .include "macros.inc"
        .include "driver.inc"
        .include "checks.inc"

        # spheres and background, a record in their format of which only the colour is used, are
        # placed by linker/spu.ld.
        .global spheres_size
        .set    spheres_size,(MAX_SPHERES+PADDING_SPHERES)*SPHERE_SIZE
    .if SPHERE_SIZE != 0x30
        .error  "linker/spu.ld takes another size of the background"
    .endif

        .section .bss
        .align  4
overwritten:                            # whether a scene has the place of that code
        .skip   16

# scene_fetch   starts to fetch the spheres, and the code if a scene has overwritten it, and sets up
# the records around them; or starts to fetch the scene of Whitted's model, which is complete
#   Uses    $3-$7, $10-$19
        .set    a_frame,15
        .set    quad,16
        .set    a_padding,17
        .set    centre,18
        .set    limits,19

function scene_fetch
        enter
        ila     $a_frame,frame
        load_word $quad,FRAME_features,$a_frame
        andi    $quad,$quad,FEATURE_WHITTED
        brz     $quad,plain
        stqa    $quad,overwritten
        ila     $3,SCENE_ADDRESS
        load_word $4,FRAME_scene,$a_frame
        load_word $5,FRAME_scene+4,$a_frame
        load_word $6,FRAME_scene_bytes,$a_frame
        il      $7,TAG_FRAME
        brsl    $lr,dma_get
        lqa     $quad,streamed
        brz     $quad,started
        # Without textures, the code for eye rays is in front of the rest.
        andi    $quad,$quad,FEATURE_TEXTURES
        ceqi    $quad,$quad,0
        ila     $3,MESH_CODE
        ila     $4,EYE_CODE
        selb    $3,$3,$4,$quad
        load_word $4,FRAME_code,$a_frame
        load_word $5,FRAME_code+4,$a_frame
        load_word $6,FRAME_code_bytes,$a_frame
        brsl    $lr,dma_get
        br      started
plain:
        il      $7,TAG_FRAME
        lqa     $quad,overwritten
        brz     $quad,present
        il      $quad,0
        stqa    $quad,overwritten
        load_constant $3,DEPTH_CODE
        load_word $4,FRAME_code,$a_frame
        load_word $5,FRAME_code+4,$a_frame
        load_word $6,FRAME_code_bytes,$a_frame
        brsl    $lr,dma_get
present:
        ila     $3,spheres
        load_word $4,FRAME_spheres,$a_frame
        load_word $5,FRAME_spheres+4,$a_frame
        il      $6,SPHERE_SIZE
        mpyu    $6,$g_spheres,$6
        a       $a_padding,$3,$6
        brsl    $lr,dma_get

        lqd     $quad,FRAME_background($a_frame)
        stqa    $quad,background+SPHERE_colour
        il      $centre,0
        load_constant $limits,0x7fffffff                # above every product
    .rept   PADDING_SPHERES
        stqd    $centre,0($a_padding)
        stqd    $limits,16($a_padding)
        ai      $a_padding,$a_padding,SPHERE_SIZE
    .endr
started:
        leave
endfunction scene_fetch

# refit_fetch   fetches the code that refits and builds meshes, and runs it
#   Out     $3 STATUS_ value
#   Uses    $3-$79, the units' and tiles' driver registers
        .set    status,3
        .set    bad,16
        .set    value,17
        .set    limit,18

function refit_fetch
        ila     $a_frame,frame
        # frame_fetch has checked the rest of these fields.
        require_from_one code_bytes,BUILD_CODE_CAPACITY,Code
        enter
        # The buffers have the place of the code for depth shading.
        stqa    $value,overwritten
        load_constant $3,BUILD_CODE
        load_word $4,FRAME_code,$a_frame
        load_word $5,FRAME_code+4,$a_frame
        ori     $6,$value,0
        il      $7,TAG_FRAME
        brsl    $lr,dma_get
        il      $3,1<<TAG_FRAME
        brsl    $lr,dma_wait
        sync
        brsl    $lr,build_blocks
        leave
refused:
        bi      $lr
endfunction refit_fetch
