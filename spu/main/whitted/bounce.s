# The secondary rays of a batch: refracted rays first, then reflected ones, so that each kind stays
# together.

        .include "work_unit.inc"
        .include "macros.inc"
        .include "driver.inc"
        .include "whitted.inc"

        .section .bss
        .align  4
bounce_from:                            # where the rays of the next depth begin
        .skip   16

        .set    amount,10
        .set    t_sum,11
        .set    t_add,12
        .set    t_carry,13
        .set    depth,14
        .set    c_end,15

# Calls a kernel for the packets with a flag, and counts the secondary rays.
.macro  send_on kernel:req, flag:req, counter:req
        lqa     $amount,batch_flags
        andi    $amount,$amount,\flag
        brz     $amount,none_\@
        ila     $3,arena+BATCH_SITES
        il      $4,\flag
        il      $5,\flag
        ila     $6,arena+SHADOW_RAYS
        brsl    $lr,sites_list
        ila     $5,arena+BATCH_SITES
        sf      $4,$5,$3
        rotmi   $4,$4,-SITE_SIZE_LOG2
        ori     $3,$5,0
        lqa     $5,bounce_from
        ila     $6,frame
        load_word $6,FRAME_least_weight,$6
        brsl    $lr,\kernel
        lqa     $5,bounce_from
        sf      $amount,$5,$3
        rotmi   $amount,$amount,-QUEUED_SIZE_LOG2
        stqa    $3,bounce_from
        count   \counter,$amount,$t_sum,$t_add,$t_carry
        ori     $w_sites,$amount,0
        ai      $3,$w_depth,1
        brsl    $lr,queue_end
        lqd     $t_sum,0($4)
        a       $t_sum,$t_sum,$w_sites
        stqd    $t_sum,0($4)
none_\@:
.endm

# batch_bounce   sends the reflected and refracted rays of the batch's surfaces
#   Uses    $3-$79, w_sites
function batch_bounce
        enter
        ila     $depth,frame
        load_word $depth,FRAME_ray_depth,$depth
        cgt     $c_end,$depth,$w_depth
        brz     $c_end,sent
        lqa     $c_end,batch_flags
        andi    $c_end,$c_end,MATERIAL_TRANSMITS|MATERIAL_MIRRORS
        brz     $c_end,sent
        ai      $3,$w_depth,1
        brsl    $lr,queue_end
        stqa    $3,bounce_from
        send_on refract_r16,MATERIAL_TRANSMITS,refracted
        send_on reflect_r16,MATERIAL_MIRRORS,reflected
sent:
        leave
endfunction batch_bounce
