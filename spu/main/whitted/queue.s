# The queues of rays that wait to be traced, one for each depth from the second on.
#
# A queue can't overflow: rays are added to it only while the previous depth is traced, and that is
# done only when no greater depth has a whole batch. So the queue has less than a batch then, and
# each ray of a batch sends at most two rays. So a queue always has less than three batches.

        .include "work_unit.inc"
        .include "macros.inc"
        .include "driver.inc"
        .include "whitted.inc"

        .section .bss
        .align  4
        .global queue_counts
queue_counts:                           # a quadword for each depth: the number of queued rays
        .skip   (MAX_DEPTH+2)*16
queues: .skip   16                      # the address of the second depth's queue
queue_bytes:                            # the bytes of each queue
        .skip   16
deepest:
        .skip   16

        .set    bytes,10
        .set    t_a,11
        .set    zero,12
        .set    a_frame,13

# queues_prepare   sets up empty queues after the scene
#   Out     w_most
#   Uses    $10-$13
function queues_prepare
        ila     $a_frame,frame
        load_word $w_most,FRAME_batch,$a_frame
        shli    $w_most,$w_most,4
        mpyi    $bytes,$w_most,3*QUEUED_SIZE
        stqa    $bytes,queue_bytes
        load_word $t_a,FRAME_scene_bytes,$a_frame
        ila     $bytes,SCENE_ADDRESS
        a       $t_a,$t_a,$bytes
        stqa    $t_a,queues
        load_word $t_a,FRAME_ray_depth,$a_frame
        stqa    $t_a,deepest
        il      $zero,0
        ila     $t_a,queue_counts
    .set    depth,0
    .rept   MAX_DEPTH+2
        stqd    $zero,16*depth($t_a)
    .set    depth,depth+1
    .endr
        bi      $lr
endfunction queues_prepare

# queue_full   finds the greatest depth with a whole batch of rays
#   Out     $3 depth; 0 if there is none
#   Uses    $3, $10-$13
        .set    a_count,10
        .set    count,11
        .set    c_enough,12

function queue_full
        lqa     $3,deepest
        ila     $a_count,queue_counts
next_depth:
        clgti   $c_enough,$3,1
        brz     $c_enough,none_full
        shli    $count,$3,4
        lqx     $count,$a_count,$count
        cgt     $c_enough,$w_most,$count
        biz     $c_enough,$lr
        ai      $3,$3,-1
        br      next_depth
none_full:
        il      $3,0
        bi      $lr
endfunction queue_full

# queue_rest   finds the least depth with queued rays
#   Out     $3 depth; 0 if there is none
#   Uses    $3, $10-$13
        .set    t_deepest,13

function queue_rest
        lqa     $t_deepest,deepest
        ila     $a_count,queue_counts
        il      $3,2
next_rest:
        cgt     $c_enough,$3,$t_deepest
        brnz    $c_enough,none_rest
        shli    $count,$3,4
        lqx     $count,$a_count,$count
        binz    $count,$lr
        ai      $3,$3,1
        br      next_rest
none_rest:
        il      $3,0
        bi      $lr
endfunction queue_rest

# queue_end   finds the address for the next ray of a depth
#   In      $3 depth, from 2 on
#   Out     $3 address, $4 address of its count
#   Uses    $3-$4, $10-$12
        .set    t_bytes,10
        .set    t_first,11
        .set    t_high,12

function queue_end
        ila     $4,queue_counts
        shli    $t_first,$3,4
        a       $4,$4,$t_first
        ai      $3,$3,-2
        lqa     $t_bytes,queue_bytes
        mpyu    $3,$3,$t_bytes
        lqa     $t_first,queues
        a       $3,$3,$t_first
        lqd     $t_high,0($4)
        shli    $t_high,$t_high,QUEUED_SIZE_LOG2
        a       $3,$3,$t_high
        bi      $lr
endfunction queue_end

# queue_take   takes the last batch of rays of a depth out of its queue
#   In      $3 depth
#   Out     BATCH_RAYS, w_count
#   Uses    $3-$79
        .set    t_count,13
        .set    t_c,14
        .set    t_offset,15

function queue_take
        enter
        brsl    $lr,queue_end
        lqd     $t_count,0($4)
        minimum $t_c,$t_count,$w_most,$t_offset
        sf      $t_count,$t_c,$t_count
        stqd    $t_count,0($4)
        shli    $t_offset,$t_c,QUEUED_SIZE_LOG2
        sf      $3,$t_offset,$3
        ori     $4,$t_c,0
        ai      $w_count,$t_c,15
        rotmi   $w_count,$w_count,-4
        ila     $5,arena+BATCH_RAYS
        ila     $6,SCENE_ADDRESS
        ila     $7,arena+NO_PIXEL
        brsl    $lr,load_rays_r16
        leave
endfunction queue_take
