# The secondary rays of a batch: refracted rays first, then reflected ones, so that each kind stays
# together.

        .include "work_unit.inc"
        .include "macros.inc"
        .include "driver.inc"
        .include "whitted.inc"

        .set    amount,10
        .set    t_sum,11
        .set    t_add,12
        .set    t_carry,13
        .set    c_sent,14
        .set    NEXT,15
        registers a_rays,a_surfaces,left,deepest_pixel,flags
        registers pixel0,pixel1,pixel2,pixel3,rays_step,surfaces_step,both,left_flags

# Calls a kernel for the packets with a flag, and counts the secondary rays.
.macro  send_on kernel:req, flag:req, counter:req
        lqa     $amount,batch_flags
        andi    $amount,$amount,\flag
        brz     $amount,none_\@
        lqa     $3,sites_at
        il      $4,\flag
        il      $5,\flag
        brsl    $lr,sites_list
        lqa     $5,sites_at
        sf      $4,$5,$3
        rotmi   $4,$4,-SITE_SIZE_LOG2
        ori     $3,$5,0
        lqa     $5,queued
        ila     $6,frame
        load_word $6,FRAME_least_weight,$6
        lqa     $7,deepest
        brsl    $lr,\kernel
        lqa     $5,queued
        stqa    $3,queued
        sf      $amount,$5,$3
        rotmi   $amount,$amount,-QUEUED_SIZE_LOG2
        count   \counter,$amount,$t_sum,$t_add,$t_carry
none_\@:
.endm

# batch_bounce   sends the reflected and refracted rays of the batch's surfaces
#   Uses    $3-$79
#
# Packets all of whose rays are the last of their chains need no kernel: the flags of their surfaces
# show afterwards that they neither mirror nor transmit.
function batch_bounce
        enter
        lqa     $c_sent,deepest
        brz     $c_sent,sent
        lqa     $c_sent,batch_flags
        andi    $c_sent,$c_sent,MATERIAL_TRANSMITS|MATERIAL_MIRRORS
        brz     $c_sent,sent
        ceqi    $c_sent,$w_depth,1
        brnz    $c_sent,may_send
        lqa     $deepest_pixel,deepest
        lqa     $a_rays,rays_at
        lqa     $a_surfaces,surfaces_at
        il      $rays_step,RAYS16_SIZE
        il      $surfaces_step,SURFACES_SIZE
        il      $both,MATERIAL_TRANSMITS|MATERIAL_MIRRORS
        ori     $left,$w_count,0
        il      $left_flags,0
next_packet:
        hbrr    last_packet,next_packet
    .irp row, 0,1,2,3
        lqd     $pixel\row,RAYS16_pixel+16*\row($a_rays)
    .endr
        lqd     $flags,SURFACES_flags($a_surfaces)
        a       $a_rays,$a_rays,$rays_step
    .irp row, 0,1,2,3
        cgt     $pixel\row,$deepest_pixel,$pixel\row
    .endr
        or      $pixel0,$pixel0,$pixel1
        or      $pixel2,$pixel2,$pixel3
        ai      $left,$left,-1
        or      $pixel0,$pixel0,$pixel2
        orx     $pixel0,$pixel0
        ceqi    $pixel0,$pixel0,0
        and     $pixel0,$pixel0,$both
        andc    $flags,$flags,$pixel0
        stqd    $flags,SURFACES_flags($a_surfaces)
        or      $left_flags,$left_flags,$flags
        a       $a_surfaces,$a_surfaces,$surfaces_step
last_packet:
        brnz    $left,next_packet
        stqa    $left_flags,batch_flags
        and     $left_flags,$left_flags,$both
        brz     $left_flags,sent
may_send:
        brsl    $lr,queue_spill
        send_on refract_r16,MATERIAL_TRANSMITS,refracted
        send_on reflect_r16,MATERIAL_MIRRORS,reflected
sent:
        leave
endfunction batch_bounce
