# The rays that wait to be traced: a stack, from whose end whole batches are taken. A batch may have
# rays of several depths; each ray stores its own.
#
# The stack can't overflow. With B rays in a batch, a ray with n others before it in its chain is
# always among the first (n + 2) B - 1. That holds for secondary rays of primary rays, n = 1, which
# are traced only while less than B rays wait. A batch takes the last B rays and leaves those below
# as they are. The rays that the i-th of them sends on have at most B + i others of this batch
# below them, because both kernels keep the order. So these are at most B places above their
# parent. A ray of the maximum depth D sends none, therefore at most (D + 1) B - 1 rays wait.
#
# Local store holds three batches of them at least, and more if the scene is small. Each
# ray of a batch sends at most two. When these don't fit, the lowest batch is put into
# main memory, and the others move down. The batch that was put last comes back when less than B rays
# wait in local store. So the stack is always the same as if all of it were there.

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
        .global queue_end
queue_end:                              # the address after its memory
        .skip   16
        .global spilled
spilled:                                # how many batches are in main memory
        .skip   16
        .global deepest
deepest:                                # in all words: a ray that sends others has a lesser `pixel`
        .skip   16

        .set    first,10
        .set    a_frame,11
        .set    t_count,12
        .set    t_c,13
        .set    bytes,14
        .set    from,15
        .set    to,16
        .set    NEXT,17
        registers ray0,ray1,ray2,ray3,step,command,offset

# Transfers the lowest batch in local store to or from its place in main memory, and waits.
.macro  transfer direction:req, number:req
        ila     $a_frame,frame
        load_word $4,FRAME_waiting,$a_frame
        load_word $5,FRAME_waiting+4,$a_frame
        mpyu    $offset,\number,$bytes
        shli    $6,$g_number,WAITING_SIZE_LOG2
        a       $offset,$offset,$6
        add_effective $4,$5,$offset,$t_c
        lqa     $3,queue
        il      $7,TAG_QUEUE
        il      $command,MFC_\direction
        mfc_command $3,$4,$5,$bytes,$7,$command
        load_constant $3,1<<TAG_QUEUE
        brsl    $lr,dma_wait
.endm

# queue_prepare   sets up an empty queue after the scene, up to a mesh's cache or the memory's end
#   Out     w_most
#   Uses    $10-$13
function queue_prepare
        ila     $a_frame,frame
        load_word $w_most,FRAME_batch,$a_frame
        shli    $w_most,$w_most,4
        load_word $first,FRAME_scene_bytes,$a_frame
        ila     $a_frame,SCENE_ADDRESS
        a       $first,$first,$a_frame
        stqa    $first,queue
        stqa    $first,queued
        il      $first,0
        stqa    $first,spilled
        ila     $a_frame,frame
        load_constant $first,SCENE_ADDRESS+SCENE_CAPACITY
        lqa     $t_c,streamed
        brz     $t_c,to_the_end
        load_word $first,FRAME_mesh_cache,$a_frame
to_the_end:
        stqa    $first,queue_end
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
        lqa     $5,rays_at
        ila     $6,SCENE_ADDRESS
        ila     $7,arena+NO_PIXEL
load_call:
        brsl    $lr,load_rays_r16
        leave
endfunction queue_take

# queue_spill   frees space for two rays of each ray of a batch, and for one more, which the kernels
#               write but don't count. If there is none, it puts the lowest batch into main memory
#   In      queued: a batch less than fitted
#   Uses    $3-$7, $10-$23
function queue_spill
        shli    $bytes,$w_most,QUEUED_SIZE_LOG2
        lqa     $3,queued
        lqa     $4,queue_end
        a       $5,$bytes,$bytes
        a       $3,$3,$5
        cgt     $t_c,$4,$3
        binz    $t_c,$lr
        enter
        lqa     $6,spilled
        ai      $7,$6,1
        stqa    $7,spilled
        transfer PUT,$6
        lqa     $to,queue
        a       $from,$to,$bytes
        lqa     $3,queued
        sf      $4,$bytes,$3
        stqa    $4,queued
        sf      $bytes,$from,$3
        brsl    $lr,rays_move
        leave
endfunction queue_spill

# queue_refill   fetches the batch that was put into main memory last
#   In      queue, queued: less than one batch; spilled: not 0
#   Uses    $3-$7, $10-$23
function queue_refill
        enter
        lqa     $from,queue
        lqa     $3,queued
        sf      $4,$from,$3
        shli    $bytes,$w_most,QUEUED_SIZE_LOG2
        a       $to,$from,$bytes
        a       $3,$3,$bytes
        stqa    $3,queued
        ori     $bytes,$4,0
        brsl    $lr,rays_move
        shli    $bytes,$w_most,QUEUED_SIZE_LOG2
        lqa     $6,spilled
        ai      $6,$6,-1
        stqa    $6,spilled
        transfer GET,$6
        leave
endfunction queue_refill

# rays_move   copies waiting rays to a place in the queue that does not overlap theirs; two at a time,
# so one more may be copied
#   In      from, to, bytes
#   Uses    $14-$21
function rays_move
        il      $step,2*QUEUED_SIZE
        br      last_rays
next_rays:
        lqd     $ray0,0($from)
        lqd     $ray1,16($from)
        lqd     $ray2,32($from)
        lqd     $ray3,48($from)
        a       $from,$from,$step
        sf      $bytes,$step,$bytes
        stqd    $ray0,0($to)
        stqd    $ray1,16($to)
        stqd    $ray2,32($to)
        stqd    $ray3,48($to)
        a       $to,$to,$step
last_rays:
        cgti    $t_c,$bytes,0
        brnz    $t_c,next_rays
        bi      $lr
endfunction rays_move
