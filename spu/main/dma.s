# DMA transfers of any size, and waiting for their end.

        .include "work_unit.inc"
        .include "macros.inc"
        .include "driver.inc"

# dma_wait   sleeps until no transfer with these tags is outstanding; adds the time to g_dma_wait
#   In      $3 mask of tags
#   Uses    $10-$13
        .set    mask,3
        .set    NEXT,10
        registers before,after,all,status

function dma_wait
        rdch    $before,$SPU_RdDec
        wrch    $MFC_WrTagMask,$mask
        il      $all,2
        wrch    $MFC_WrTagUpdate,$all
        rdch    $status,$MFC_RdTagStat
        rdch    $after,$SPU_RdDec
        sf      $before,$after,$before
        a       $g_dma_wait,$g_dma_wait,$before
        bi      $lr
endfunction dma_wait

# dma_get   fetches any number of bytes that is a multiple of 16, in transfers of at most 16 KB
#   In      $3 local store, $4 and $5 effective address, $6 bytes, $7 tag
#   Uses    $3-$6, $10-$14
        .set    lsa,3
        .set    high,4
        .set    low,5
        .set    bytes,6
        .set    tag,7
        .set    most,10
        .set    part,11
        .set    c_more,12
        .set    t_carry,13
        .set    command,14

function dma_get
        il      $command,MFC_GET
        br      dma_parts
endfunction dma_get

# dma_put   stores them in the same way
#   In      as dma_get
#   Uses    the same
function dma_put
        il      $command,MFC_PUT
dma_parts:
        il      $most,MAX_TRANSFER
next_part:
        biz     $bytes,$lr
        minimum $part,$bytes,$most,$c_more
        mfc_command $lsa,$high,$low,$part,$tag,$command
        a       $lsa,$lsa,$part
        add_effective $high,$low,$part,$t_carry
        sf      $bytes,$part,$bytes
        br      next_part
endfunction dma_put
