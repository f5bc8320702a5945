# What this SPU has to say of the frame: one line in main memory.

        .include "work_unit.inc"
        .include "macros.inc"
        .include "driver.inc"

        .section .bss
        .align  7
statistics:
        .skip   STATS_SIZE
        .global counters
counters:
        .skip   COUNTERS_SIZE

# statistics_reset   begins the counts of a frame
#   Uses    $20
        .set    zero,20

function statistics_reset
        il      $zero,0
    .set    place,0
    .rept   COUNTERS_SIZE/16
        stqa    $zero,counters+place
    .set    place,place+16
    .endr
        ori     $g_began,$g_mailed,0
    .irp ticks, dma_wait,ticks_fetch,ticks_cull,ticks_rays,ticks_isect,ticks_shade,n_hits
        il      $g_\ticks,0
    .endr
        bi      $lr
endfunction statistics_reset

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
        .set    more,21

.macro  put_word field:req, register:req
        store_word \register,STATS_\field,$a_line,$t_quad,$t_mask
.endm

.macro  put_count field:req
        lqa     $value,counters+COUNT_\field
        rotqbyi $value,$value,4
        put_word \field,$value
.endm

.macro  put_long_count field:req
        lqa     $value,counters+COUNT_\field
        put_word \field,$value
        rotqbyi $value,$value,4
        put_word \field+4,$value
.endm

function statistics_put
        enter
        ila     $a_frame,frame
        ila     $a_line,statistics
        load_word $value,FRAME_number,$a_frame
        put_word number,$value
        sum_lanes $g_n_hits,$value
        put_word eye_hits,$g_n_hits
    .irp field, tiles,packets,eye_rays,tiles_empty,tiles_blank,packets_empty,tests_hidden,cull_tests
        put_count \field
    .endr
    .irp field, reflected,refracted,shadow,hits
        put_count \field
    .endr
        put_long_count tests_made
        put_long_count hits_looked_for

        # Every packet with every sphere, less the tests made. Whitted's model has counted them.
        lqa     $value,counters+COUNT_packets
        rotqbyi $value,$value,4
        load_word $more,FRAME_sphere_count,$a_frame
        mpyu    $low,$value,$more
        rotmi   $value,$value,-16
        mpyu    $value,$value,$more
        rotmi   $high,$value,-16
        shli    $value,$value,16
        add_effective $high,$low,$value,$t_carry
        lqa     $value,counters+COUNT_tests_possible
        rotqbyi $more,$value,4
        add_effective $high,$low,$more,$t_carry
        a       $high,$high,$value
        lqa     $value,counters+COUNT_tests_made
        rotqbyi $more,$value,4
        bg      $t_carry,$more,$low                     # 1 unless it borrows
        sf      $low,$more,$low
        sfx     $t_carry,$value,$high
        put_word tests_skipped,$t_carry
        put_word tests_skipped+4,$low

    .irp phase, fetch,cull,rays,isect,shade
        put_word ticks_\phase,$g_ticks_\phase
    .endr
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
