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
#   Uses    $20-$22
        .set    zero,20
        .set    counter,21
        .set    left,22
        .set    ALL_COUNTERS,COUNTERS_SIZE+GENERATIONS_SIZE

function statistics_reset
        il      $zero,0
        ila     $counter,generations
        il      $left,ALL_COUNTERS/16
next_counter:
        hbrr    last_counter,next_counter
        stqd    $zero,0($counter)
        ai      $counter,$counter,16
        ai      $left,$left,-1
last_counter:
        brnz    $left,next_counter
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
# All but the generations is put together where packets of tiles were, since no tile is left.
#   Uses    $3, $10-$21
        .set    a_frame,10
        .set    a_record,11
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

# Stores 64 bits from the first two words of a register.
.macro  put_long field:req, register:req
        lqd     $t_quad,(STATS_\field)&~15($a_record)
        cdd     $t_mask,(STATS_\field)&15($sp)
        shufb   $t_quad,\register,$t_quad,$t_mask
        stqd    $t_quad,(STATS_\field)&~15($a_record)
.endm

.macro  put_count field:req
        lqa     $value,counters+COUNT_\field
        put_long \field,$value
.endm

# out = a - b, with 64 bits each in the first two words.
.macro  difference out:req, a:req, b:req
        bg      $t_carry,\b,\a                          # 1 unless it borrows
        shlqbyi $t_carry,$t_carry,4
        sfx     $t_carry,\b,\a
        ori     \out,$t_carry,0
.endm

function statistics_put
        enter
        brsl    $lr,times_add
        ila     $a_frame,frame
        ila     $a_record,packets
        load_word $value,FRAME_number,$a_frame
        store_word $value,STATS_number,$a_record,$t_quad,$t_mask
        il      $value,0
        store_word $value,STATS_unused,$a_record,$t_quad,$t_mask
        sum_lanes $g_n_hits,$value
        rotqmbyi $value,$g_n_hits,-4
        fsmbi   $t_mask,0x0f00
        and     $value,$value,$t_mask
        put_long eye_hits,$value
    .irp field, tiles,packets,primary_rays,tiles_empty,tiles_blank,packets_empty,tests_hidden,cull_tests
        put_count \field
    .endr
    .irp field, tests_made,hits_looked_for,reflected,refracted,shadow,hits
        put_count \field
    .endr
    .irp field, samples,dma_wait,ticks_fetch,ticks_cull,ticks_rays,ticks_isect,ticks_shade
        put_count \field
    .endr
        rotqmbyi $value,$g_idle,-4
        put_long idle,$value
        lqa     $value,counters+COUNT_elapsed
        lqa     $more,counters+COUNT_dma_wait
        difference $value,$value,$more
        put_long busy,$value

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
        cwd     $t_mask,4($sp)
        shufb   $value,$low,$high,$t_mask
        put_long tests_possible,$value

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
