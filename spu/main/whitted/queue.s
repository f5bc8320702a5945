# The rays that wait to be traced: a stack, from whose end whole batches are taken. A batch may have
# rays of several depths; each ray knows its own.
#
# The stack can't overflow. With B rays in a batch, a ray with n others before it in its chain is
# always among the first (n + 2) B - 1. That holds for secondary rays of primary rays, n = 1, which
# are traced only while less than B rays wait. A batch takes the last B rays and leaves those below
# as they are. The rays that the i-th of them sends on have at most B + i others of this batch
# below them, because both kernels keep the order. So these are at most B places above their
# parent. A ray of the greatest depth D sends none, therefore at most (D + 1) B - 1 rays wait.

        .include "work_unit.inc"
        .include "macros.inc"
        .include "driver.inc"
        .include "whitted.inc"

        .section .bss
        .align  4
        .global queue
queue:                                  # the address of the first ray
        .skip   16
        .global queued
queued:                                 # the address after the last ray
        .skip   16
        .global deepest
deepest:                                # in all words: a ray that sends others has a lesser `pixel`
        .skip   16

        .set    first,10
        .set    a_frame,11
        .set    t_count,12
        .set    t_c,13
        .set    bytes,14

# queue_prepare   sets up an empty queue after the scene
#   Out     w_most
#   Uses    $10-$11
function queue_prepare
        ila     $a_frame,frame
        load_word $w_most,FRAME_batch,$a_frame
        shli    $w_most,$w_most,4
        load_word $first,FRAME_scene_bytes,$a_frame
        ila     $a_frame,SCENE_ADDRESS
        a       $first,$first,$a_frame
        stqa    $first,queue
        stqa    $first,queued
        ila     $a_frame,frame
        load_word $first,FRAME_ray_depth,$a_frame
        ai      $first,$first,-1
        shli    $first,$first,CHAIN_STEP_LOG2
        ila     $a_frame,0x10203
        shufb   $first,$first,$first,$a_frame
        stqa    $first,deepest
        bi      $lr
endfunction queue_prepare

# queue_take   takes the last batch of rays from the queue, or all if there are fewer
#   Out     BATCH_RAYS, batch_rays, w_count
#   Uses    $3-$79
function queue_take
        hbrr    load_call,load_rays_r16
        enter
        lqa     $3,queued
        lqa     $first,queue
        sf      $4,$first,$3
        shli    $bytes,$w_most,QUEUED_SIZE_LOG2
        minimum $4,$4,$bytes,$t_c
        sf      $3,$4,$3
        stqa    $3,queued
        rotmi   $4,$4,-QUEUED_SIZE_LOG2
        stqa    $4,batch_rays
        ai      $w_count,$4,15
        rotmi   $w_count,$w_count,-4
        ila     $5,arena+BATCH_RAYS
        ila     $6,SCENE_ADDRESS
        ila     $7,arena+NO_PIXEL
load_call:
        brsl    $lr,load_rays_r16
        leave
endfunction queue_take
