# What this SPU has to say of the frame: one line in main memory.

        .include "work_unit.inc"
        .include "macros.inc"
        .include "driver.inc"

        .section .bss
        .align  7
statistics:
        .skip   STATS_SIZE

# statistics_put   fills the line and sends it; it has arrived when this returns
#   Uses    $3, $10-$21
        .set    a_frame,10
        .set    a_line,11
        .set    value,12
        .set    t_quad,13
        .set    t_mask,14
        .set    high,15
        .set    low,16
        .set    t_carry,17
        .set    size,18
        .set    tag,19
        .set    command,20
        .set    zero,21

.macro  put_word field:req, register:req
        store_word \register,STATS_\field,$a_line,$t_quad,$t_mask
.endm

function statistics_put
        enter
        ila     $a_frame,frame
        ila     $a_line,statistics
        load_word $value,FRAME_number,$a_frame
        put_word number,$value
        put_word tiles,$g_n_tiles
        put_word packets,$g_n_packets
        put_word eye_rays,$g_n_rays
        rotqbyi $value,$g_n_hits,8
        a       $g_n_hits,$g_n_hits,$value
        rotqbyi $value,$g_n_hits,4
        a       $g_n_hits,$g_n_hits,$value
        put_word eye_hits,$g_n_hits
        put_word tests_made,$g_tests_high
        put_word tests_made+4,$g_tests_low
        il      $zero,0
        put_word tests_skipped,$zero
        put_word tests_skipped+4,$zero
        put_word dma_wait,$g_dma_wait
        put_word idle,$g_idle
        rdch    $value,$SPU_RdDec
        sf      $value,$value,$g_mailed                 # it counts down
        sf      $value,$g_dma_wait,$value
        put_word busy,$value

        load_word $high,FRAME_statistics,$a_frame
        load_word $low,FRAME_statistics+4,$a_frame
        il      $size,STATS_SIZE
        mpyu    $value,$g_number,$size
        add_effective $high,$low,$value,$t_carry
        il      $tag,TAG_STATISTICS
        il      $command,MFC_PUT
        mfc_command $a_line,$high,$low,$size,$tag,$command
        il      $3,1<<TAG_STATISTICS
        brsl    $lr,dma_wait
        leave
endfunction statistics_put
