# The driver of the microbenchmarks: fetches its order, waits for mail so that all SPUs begin
# together, calls the benchmark, and stores the result after the order.
        .include "clock.inc"

        .section .data
        .balign 128
        .global order
order:  .fill   128,1,0
result: .fill   128,1,0

# The benchmarks, in the order of their numbers in src/order.rs.
        .balign 16
table:  .word   stream
        .word   stream_without_command
        .word   putlluc
        .word   increments
        .word   ping_pong
        .word   list
        .word   mail
        .word   signals
        .word   signals_of_spes
        .word   hinted_loop
        .word   taken_branches
        .word   double_pairs

        .text
        .global _start
_start: # $4 is the effective address of the order.
        ori     $ea_high,$4,0
        rotqbyi $ea_low,$4,4
        ori     $5,$ea_high,0
        ori     $6,$ea_low,0
        ila     $20,order
        il      $21,128
        il      $22,GET
        bra     fetch
fetched:
        rdch    $7,$ch29                # the mail to begin
        lqa     $20,order
        lqa     $21,order+16
        lqa     $22,order+32
        rotqbyi $passes,$20,4
        rotqbyi $opcode,$20,8
        rotqbyi $size,$20,12
        ori     $depth,$21,0
        rotqbyi $ea_high,$21,4
        rotqbyi $ea_low,$21,8
        rotqbyi $ea_mask,$21,12
        ori     $number,$22,0
        ila     $23,table
        shli    $24,$20,2
        lqx     $25,$23,$24
        a       $24,$23,$24
        rotqby  $25,$25,$24
        il      $done,0
        il      $26,-1
        wrch    $ch7,$26
        bisl    $0,$25

        # Ticks, and what the SPU counted, into the first two words of the result.
        sf      $20,$ended,$began
        stqa    $20,result
        stqa    $done,result+16
        ila     $20,result
        ai      $6,$6,128
        il      $21,128
        il      $22,PUT
        bra     store
stored: stop    0x2000

# A line between local store at $20 and the order's address.
fetch:  il      $30,0
        wrch    $ch16,$20
        wrch    $ch17,$5
        wrch    $ch18,$6
        wrch    $ch19,$21
        wrch    $ch20,$30
        wrch    $ch21,$22
        il      $30,1
        wait_tags $30,$31
        bra     fetched
store:  il      $30,0
        wrch    $ch16,$20
        wrch    $ch17,$5
        wrch    $ch18,$6
        wrch    $ch19,$21
        wrch    $ch20,$30
        wrch    $ch21,$22
        il      $30,1
        wait_tags $30,$31
        bra     stored
