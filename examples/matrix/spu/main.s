# Fetches A, B and C, each 64x64 singles and one after the other at the address in $4, multiplies as
# often as the word after them demands, and stores C and the decrementer's ticks there.
        .set    ea_high, 4
        .set    ea_low, 5
        .set    left, 6

        .section .data
        .balign 128
        .global matrix_a
        .global matrix_b
        .global matrix_c
matrix_a:
        .fill   16384,1,0
matrix_b:
        .fill   16384,1,0
# The kernel stores four rows in front of the first ones.
        .fill   1024,1,0
matrix_c:
        .fill   16384,1,0
control:
        .fill   128,1,0
# The kernel loads the A and C after the last rows, without using them.
        .fill   2048,1,0

# Shuffles that copy word 0, 1, 2 or 3.
        .global splat
splat:  .irp    word, 0x00010203,0x04050607,0x08090a0b,0x0c0d0e0f
        .int    \word,\word,\word,\word
        .endr

        .text
# Moves size bytes between local store and the address offset bytes after the argument, and waits.
        .macro  move lsa:req, offset:req, size:req, command:req
        ila     $20,\lsa
        wrch    $ch16,$20
        wrch    $ch17,$ea_high
        ila     $20,\offset
        a       $20,$20,$ea_low
        wrch    $ch18,$20
        ila     $20,\size
        wrch    $ch19,$20
        il      $20,0
        wrch    $ch20,$20
        il      $20,\command
        wrch    $ch21,$20
        il      $20,1
        wrch    $ch22,$20
        il      $20,2
        wrch    $ch23,$20
        rdch    $20,$ch24
        .endm

        .global _start
_start: rotqbyi $ea_low,$4,4
        move    matrix_a, 0, 16384, 0x40
        move    matrix_b, 16384, 16384, 0x40
        move    matrix_c, 32768, 16384, 0x40
        move    control, 49152, 128, 0x40
        lqa     $left,control
        il      $20,-1
        wrch    $ch7,$20
        rdch    $7,$ch8
1:      brsl    $0,multiply
        ai      $left,$left,-1
        brnz    $left,1b
        rdch    $8,$ch8
        sf      $8,$8,$7
        stqa    $8,control
        move    matrix_c, 32768, 16384, 0x20
        move    control, 49152, 128, 0x20
        stop    0x2000
