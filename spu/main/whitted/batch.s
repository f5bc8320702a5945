# A batch of rays: their hits, the shading there, and their secondary rays.

        .include "work_unit.inc"
        .include "macros.inc"
        .include "driver.inc"
        .include "whitted.inc"

        .section .bss
        .align  4
        .global batch_rays
batch_rays:                             # how many rays it has
        .skip   16
        .global batch_flags
batch_flags:                            # the flags of all surfaces, combined
        .skip   16
        .global met_round
met_round:                              # not 0 if its rays were tested with spheres or cones of the
        .skip   16                      # mesh
fog_mask:                               # the lanes of a packet that have hit something
        .skip   64

        .set    amount,10
        .set    t_sum,11
        .set    t_add,12
        .set    t_carry,13
        .set    flags,14
        .set    a_surfaces,15
        .set    left,16
        .set    t_flags,17
        .set    wanted,18
        .set    c_any,19
        .set    later,20

# batch_trace   traces and shades the packets of BATCH_RAYS
#   In      w_depth, w_count
#   Uses    $3-$79
function batch_trace
        enter
        paths_sent
        hbrr    trace_call,packets_trace
        # How many rays came before the batch's first: 0, 1, or 2 for more.
        lqa     $3,rays_at
        ila     $amount,generations
        il      $5,0
        stqa    $5,met_round
        lqa     $6,batch_rays
        ori     $4,$w_count,0
        lqd     $later,RAYS16_pixel($3)
        ceqi    $5,$w_depth,1
        il      $wanted,2
        sfi     $5,$5,-1                                # rays of depth 1 start at the eye
        rotmi   $later,$later,-CHAIN_STEP_LOG2
        minimum $later,$later,$wanted,$c_any
        shli    $later,$later,GENERATION_SIZE_LOG2+1    # each with its shadow rays
        a       $amount,$amount,$later
        stqa    $amount,generation
trace_call:
        brsl    $lr,packets_trace
        lqa     $3,keeps_paths
        brz     $3,paths_added
        lqa     $3,rays_at
        ori     $4,$w_count,0
        il      $5,-1
        brsl    $lr,paths_add
paths_added:
        brsl    $lr,surfaces_make
        lqa     $3,of_cuts
        brz     $3,no_cuts
        brsl    $lr,cuts_surfaces
no_cuts:
        brsl    $lr,flags_gather
        stqa    $flags,batch_flags

        load_constant $wanted,SIDES_SMOOTH|MATERIAL_SHADED|MATERIAL_TEXTURED
        and     $wanted,$wanted,$flags
        brz     $wanted,shaded
        brsl    $lr,batch_shade
        # A shader may have added flags to a surface that its material doesn't have.
        brsl    $lr,flags_gather
        stqa    $flags,batch_flags
shaded:
        lqa     $3,frame+FRAME_ambient
        orx     $3,$3
        brz     $3,dark
        lqa     $3,surfaces_at
        ori     $4,$w_count,0
        ila     $5,frame+FRAME_ambient
        brsl    $lr,ambient_r16
dark:
        phase_ends $g_ticks_shade,$amount
        lqa     $flags,batch_flags
        andi    $wanted,$flags,MATERIAL_LIT
        brz     $wanted,unlit
        brsl    $lr,batch_light
unlit:
        lqa     $flags,frame+FRAME_fog
        brz     $flags,clear
        brsl    $lr,batch_fog
clear:
        brsl    $lr,batch_bounce
        lqa     $3,rays_at
        lqa     $4,surfaces_at
        ori     $5,$w_count,0
        brsl    $lr,accumulate_r16
        phase_ends $g_ticks_shade,$amount
        leave
endfunction batch_trace

# The addresses of packet w_left and of its surfaces.
.macro  packet_at packet:req, surfaces:req, t:req
        il      \t,RAYS16_SIZE
        mpyu    \packet,$w_left,\t
        lqa     \t,rays_at
        a       \packet,\packet,\t
        il      \t,SURFACES_SIZE
        mpyu    \surfaces,$w_left,\t
        lqa     \t,surfaces_at
        a       \surfaces,\surfaces,\t
.endm

# batch_fog   puts the fog between the batch's surfaces and where its rays have started
#   Uses    $3-$30, w_left
        .set    mask,10                                 # to 13
        .set    beyond,14
        .set    step,15

function batch_fog
        enter
        ori     $w_left,$w_count,0
next_fog:
        hbrr    fog_call,fog_r16
        ai      $w_left,$w_left,-1
        packet_at $4,$3,$step
        ila     $beyond,SCENE_ADDRESS
        ila     $5,fog_mask
        # Row by row, each instruction would wait for the one before.
    .irp row, 0,1,2,3
        lqd     $mask+\row,RAYS16_object+16*\row($4)
    .endr
    .irp row, 0,1,2,3
        ceq     $mask+\row,$mask+\row,$beyond
    .endr
    .irp row, 0,1,2,3
        xori    $mask+\row,$mask+\row,-1
    .endr
    .irp row, 0,1,2,3
        stqd    $mask+\row,16*\row($5)
    .endr
        ila     $6,frame+FRAME_fog
fog_call:
        brsl    $lr,fog_r16
        brnz    $w_left,next_fog
        leave
endfunction batch_fog

# flags_gather   combines the flags of all surfaces of the batch, of AT_ONCE packets at once
        .set    AT_ONCE,8
#   Out     $14
#   Uses    $14-$25
function flags_gather
        lqa     $a_surfaces,surfaces_at
        ori     $left,$w_count,0
        il      $flags,0
        il      $wanted,SURFACES_SIZE
        cgti    $t_flags,$left,AT_ONCE-1
        brnz    $t_flags,at_once
next_flags:
        lqd     $t_flags,SURFACES_flags($a_surfaces)
        or      $flags,$flags,$t_flags
        a       $a_surfaces,$a_surfaces,$wanted
        ai      $left,$left,-1
        brnz    $left,next_flags
        bi      $lr
at_once:
        # From the middle, so that all displacements fit.
        il      $t_flags,AT_ONCE/2*SURFACES_SIZE
        a       $a_surfaces,$a_surfaces,$t_flags
    .set    surfaces,0
    .rept   AT_ONCE
        lqd     $t_flags+surfaces,(surfaces-AT_ONCE/2)*SURFACES_SIZE+SURFACES_flags($a_surfaces)
    .set    surfaces,surfaces+1
    .endr
        ai      $left,$left,-AT_ONCE
        il      $t_flags+AT_ONCE,AT_ONCE/2*SURFACES_SIZE
        a       $a_surfaces,$a_surfaces,$t_flags+AT_ONCE
    .set    surfaces,0
    .rept   AT_ONCE
        or      $flags,$flags,$t_flags+surfaces
    .set    surfaces,surfaces+1
    .endr
        il      $wanted,SURFACES_SIZE
        cgti    $t_flags,$left,AT_ONCE-1
        brnz    $t_flags,at_once
        brnz    $left,next_flags
        bi      $lr
endfunction flags_gather

# surfaces_make   makes the surfaces that the batch has hit; packets that have hit only one object
# have a shorter kernel
#   Out     BATCH_SURFACES
#   Uses    $3-$79, w_left, w_sites, w_first, w_here
        .set    run,10
        .set    turned,11
        .set    c_same,12
        .set    offset,20
        .set    way,21

function surfaces_make
        enter
        lqa     $3,rays_at
        ori     $4,$w_count,0
        brsl    $lr,same_objects_r16
        # The bits of the remaining packets, with the first in the sign, and the length of its run.
        sfi     $run,$w_count,32
        shl     $w_sites,$3,$run
        il      $w_first,0
next_run:
        hbrr    same,surfaces_same_r16
        rotmai  $turned,$w_sites,-31
        xor     $turned,$turned,$w_sites                # 0 for packets like the first
        clz     $run,$turned
        sf      $w_left,$w_first,$w_count
        minimum $w_here,$run,$w_left,$c_same
        il      $3,RAYS16_SIZE
        mpyu    $3,$3,$w_first
        lqa     $offset,rays_at
        a       $3,$3,$offset
        ori     $4,$w_here,0
        il      $5,SURFACES_SIZE
        mpyu    $5,$5,$w_first
        lqa     $offset,surfaces_at
        a       $5,$5,$offset
        ila     $6,SCENE_ADDRESS
        rotmi   $c_same,$w_sites,-31
        brnz    $c_same,same
        brsl    $lr,surfaces_r16
        br      made
same:   brsl    $lr,surfaces_same_r16
made:   ceqi    $c_any,$w_depth,1
        brz     $c_any,sent
        a       $g_n_hits,$g_n_hits,$3
sent:   sum_lanes $3,$amount
        count   hits,$3,$t_sum,$t_add,$t_carry
        shl     $w_sites,$w_sites,$w_here
        a       $w_first,$w_first,$w_here
        ceq     $c_any,$w_first,$w_count
        brz     $c_any,next_run
        # Local store holds few objects, and their rays are rarely reflected often.
        lqa     $turned,streamed
        andi    $turned,$turned,FEATURE_MESH
        brz     $turned,refined
        lqa     $turned,met_round
        lqa     $c_same,frame+FRAME_trees+BVH_SIZE*BVH_SPHERES
        lqa     $offset,frame+FRAME_trees+BVH_SIZE*BVH_CONES
        or      $c_same,$c_same,$offset
        rotqbyi $c_same,$c_same,BVH_objects
        or      $turned,$turned,$c_same
        brz     $turned,refined
        lqa     $3,rays_at
        ori     $4,$w_count,0
        lqa     $5,surfaces_at
        brsl    $lr,refine_hits_r16
refined:
        leave
endfunction surfaces_make

# batch_shade   applies smooth normals, textures, colours and shaders, to the packets that have any
#   Uses    $3-$79, w_left

.macro  packet_and_surfaces
        packet_at $3,$4,$offset
        lqd     $flags,SURFACES_flags($4)
.endm

function batch_shade
        enter
        ori     $w_left,$w_count,0
next_packet:
        lqa     $way,surface_way
        ai      $w_left,$w_left,-1
        packet_and_surfaces
        hbr     way_call,$way
        ilhu    $wanted,SIDES_SMOOTH>>16
        and     $wanted,$wanted,$flags
        brz     $wanted,flat
        brsl    $lr,smooth_r16
        packet_and_surfaces
        lqa     $way,surface_way
flat:   andi    $wanted,$flags,MATERIAL_SHADED|MATERIAL_TEXTURED
        brz     $wanted,as_it_is
        andi    $wanted,$flags,MATERIAL_TEXTURED
        brz     $wanted,plain
        brz     $way,plain
way_call:
        bisl    $lr,$way
plain:  andi    $wanted,$flags,MATERIAL_SHADED
        brz     $wanted,as_it_is
        ori     $offset,$3,0
        ori     $3,$4,0
        ori     $4,$offset,0
        brsl    $lr,shaders_run
        brnz    $3,give_up
as_it_is:
        brnz    $w_left,next_packet
        leave
endfunction batch_shade
