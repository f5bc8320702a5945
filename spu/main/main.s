# The program of an SPU. It sleeps until its mailbox has the address of a frame, traces its share
# of the frame, and reports a status.
#
#   Entry   $4 word 1: the number of this SPU
#   Mail    two words: the effective address of a frame's record, high word first; 0, 0 ends the
#           program
#   Result  one word in the outbound interrupt mailbox: a STATUS_ value
#   Exit    stop 0x2000

        .include "work_unit.inc"
        .include "macros.inc"
        .include "driver.inc"

        .set    NEXT,10
        registers high,low,either,before,after

        .section .bss
        .align  4
first_stack:
        .skip   16

        .section .text.start,"ax",@progbits
        .align  3
        .global _start
        .type   _start, @function
_start:
        stqd    $sp,-32($sp)
        ai      $sp,$sp,-32
        stqa    $sp,first_stack
        rotqbyi $g_number,$4,4
        il      $before,-1
        wrch    $SPU_WrDec,$before
next_mail:
        rdch    $before,$SPU_RdDec
        rdch    $high,$SPU_RdInMbox
        rdch    $low,$SPU_RdInMbox
        rdch    $after,$SPU_RdDec
        sf      $g_idle,$after,$before
        ori     $g_mailed,$after,0
        or      $either,$high,$low
        brz     $either,exit

        brsl    $lr,statistics_reset
        ori     $4,$high,0
        ori     $5,$low,0
        brsl    $lr,frame_fetch
        brnz    $3,report
        lqa     $either,frame
        rotqbyi $either,$either,FRAME_features
        il      $high,FEATURE_BUILD
        and     $either,$either,$high
        brnz    $either,build
        brsl    $lr,scene_fetch
        brsl    $lr,units_trace
done:   brnz    $3,report
        brsl    $lr,statistics_put
        il      $3,STATUS_Done
report:
        wrch    $SPU_WrOutIntrMbox,$3
        br      next_mail
exit:
        stop    0x2000
build:  brsl    $lr,refit_fetch
        br      done

# Any code may jump here: reports $3, and skips the rest of the frame.
give_up:
        lqa     $sp,first_stack
        ori     $g_unit,$3,0
        il      $3,ALL_TAGS
        brsl    $lr,dma_wait
        ori     $3,$g_unit,0
        br      report
        .size   _start, .-_start
        .global give_up
