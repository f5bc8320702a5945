# This SPU's statistics of the frame, a record in main memory.

        .include "work_unit.inc"
        .include "macros.inc"
        .include "driver.inc"

        .set    GENERATIONS_SIZE,STATS_reserved-STATS_generations

        .section .bss
        .align  4
        .global generations
generations:                            # as in the record
        .skip   GENERATIONS_SIZE
        # The other counters, reset together with these.
        .global counters
counters:
        .skip   COUNTERS_SIZE
        .global times_added
times_added:                            # decrementer when times_add was last called
        .skip   16

# statistics_reset   sets the counters of a frame to 0
#   Uses    $20
        .set    zero,20

function statistics_reset
        il      $zero,0
    .set    place,0
    .rept   (GENERATIONS_SIZE+COUNTERS_SIZE)/16
        stqa    $zero,generations+place
    .set    place,place+16
    .endr
        ori     $g_began,$g_mailed,0
        stqa    $g_mailed,times_added
    .irp ticks, dma_wait,ticks_fetch,ticks_cull,ticks_rays,ticks_isect,ticks_shade,n_hits
        il      $g_\ticks,0
    .endr
        bi      $lr
endfunction statistics_reset

# times_add   adds the ticks in registers to the counters; must be called before they reach 2^32,
#             so also in the middle of a long tile
#   Uses    $10-$14
        .set    now,10
        .set    since,11
        .set    t_sum,12
        .set    t_add,13
        .set    t_carry,14

function times_add
        rdch    $now,$SPU_RdDec
        lqa     $since,times_added
        stqa    $now,times_added
        sf      $since,$now,$since                      # it counts down
        count   elapsed,$since,$t_sum,$t_add,$t_carry
    .irp ticks, dma_wait,ticks_fetch,ticks_cull,ticks_rays,ticks_isect,ticks_shade
        count   \ticks,$g_\ticks,$t_sum,$t_add,$t_carry
        il      $g_\ticks,0
    .endr
        # A tile's cost is one word. At most LONG_TICKS of the time so far are counted.
        sf      $since,$now,$g_tile_began
        rotmi   $since,$since,-LONG_TICKS_LOG2
        biz     $since,$lr
        ilhu    $since,1<<(LONG_TICKS_LOG2-16)
        a       $g_tile_began,$now,$since
        bi      $lr
endfunction times_add

# statistics_put   sends the record, and waits until it has arrived
#
# Its counters are put together where packets of tiles were, since no tile is left.
#
#   Uses    $3, $10-$22
        .set    a_frame,10
        .set    a_record,11
        .set    value,12
        .set    a_counter,13
        .set    m_second,14
        .set    high,15
        .set    low,16
        .set    t_carry,17
        .set    size,18
        .set    tag,19
        .set    command,20
        .set    more,21
        .set    left,22

function statistics_put
        enter
        brsl    $lr,times_add
        ila     $a_frame,frame
        load_word $value,FRAME_number,$a_frame
        fsmbi   $more,0xf000
        and     $value,$value,$more
        stqa    $value,counters+COUNT_number
        sum_lanes $g_n_hits,$value
        rotqmbyi $value,$g_n_hits,-4
        stqa    $value,counters+COUNT_eye_hits
        rotqmbyi $value,$g_idle,-4
        stqa    $value,counters+COUNT_idle
        # The time since the mail, less that spent waiting for the MFC.
        lqa     $value,counters+COUNT_elapsed
        lqa     $more,counters+COUNT_dma_wait
        bg      $t_carry,$more,$value                   # 1 unless it borrows
        shlqbyi $t_carry,$t_carry,4
        sfx     $t_carry,$more,$value
        stqa    $t_carry,counters+COUNT_busy

        # Without skipping, every packet is tested with every sphere. Whitted's model has already
        # counted its tests.
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
        cwd     $m_second,4($sp)
        shufb   $value,$low,$high,$m_second
        stqa    $value,counters+COUNT_tests_possible

        ila     $a_counter,counters
        ila     $a_record,packets
        il      $left,STATS_generations/16
        fsmbi   $m_second,0x00ff
next_two:
        hbrr    last_two,next_two
        lqd     $value,0($a_counter)
        lqd     $more,16($a_counter)
        ai      $a_counter,$a_counter,2*16
        ai      $left,$left,-1
        rotqbyi $more,$more,8
        selb    $value,$value,$more,$m_second
        stqd    $value,0($a_record)
        ai      $a_record,$a_record,16
last_two:
        brnz    $left,next_two

        ila     $a_record,packets
        load_word $high,FRAME_statistics,$a_frame
        load_word $low,FRAME_statistics+4,$a_frame
        il      $size,STATS_SIZE
        mpyu    $value,$g_number,$size
        add_effective $high,$low,$value,$t_carry
        il      $size,STATS_generations
        il      $tag,TAG_STATISTICS
        il      $command,MFC_PUT
        mfc_command $a_record,$high,$low,$size,$tag,$command
        add_effective $high,$low,$size,$t_carry
        ila     $a_record,generations
        il      $size,GENERATIONS_SIZE
        mfc_command $a_record,$high,$low,$size,$tag,$command
        il      $3,1<<TAG_STATISTICS
        brsl    $lr,dma_wait
        leave
endfunction statistics_put
