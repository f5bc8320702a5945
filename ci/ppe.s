# An SPU program that takes frames and traces nothing: it replies as if all tiles of the work units
# had been traced. With it, QEMU counts what the PPE's program does and wastes no time on emulated
# SPUs. All tiles must be whole: 64x16 pixels.
#
#   Entry   $4 word 1: the number of this SPU; SPU 0 replies for all tiles
#   Mail, reply, exit   as spu/main/main.s

        .set    high, 80
        .set    low, 81
        .set    number, 82
        .set    unit, 83                        # the low address of the unit
        .set    left, 84
        .set    pixels, 85

# Moves a record between local store and main memory.
        .macro  move lsa:req, low:req, size:req, command:req
        ila     $10,\lsa
        wrch    $ch16,$10
        wrch    $ch17,$high
        wrch    $ch18,\low
        il      $10,\size
        wrch    $ch19,$10
        il      $10,0
        wrch    $ch20,$10
        il      $10,\command
        wrch    $ch21,$10
        il      $10,1
        wrch    $ch22,$10
        il      $10,2
        wrch    $ch23,$10
        rdch    $10,$ch24
        .endm

        .text
        .global _start
_start: rotqbyi $number,$4,4
next_mail:
        rdch    $high,$ch29
        rdch    $low,$ch29
        or      $2,$high,$low
        brz     $2,exit
        brnz    $number,reply
        move    frame, $low, 448, 0x40
        lqa     $left,frame+80                  # unit_count
        rotqbyi $left,$left,8
        lqa     $unit,frame+64                  # units
        rotqbyi $high,$unit,8
        rotqbyi $unit,$unit,12
        il      $pixels,0
        brz     $left,2f
1:      move    record, $unit, 128, 0x40
        lqa     $2,record                       # count
        shli    $2,$2,10
        a       $pixels,$pixels,$2
        ai      $unit,$unit,127
        ai      $unit,$unit,1
        ai      $left,$left,-1
        brnz    $left,1b
2:      lqa     $3,frame+64                     # statistics
        ori     $high,$3,0
        rotqbyi $3,$3,4
        ai      $3,$3,16
        cwd     $2,12($1)                       # the low word of primary_rays
        il      $4,0
        shufb   $2,$pixels,$4,$2
        stqa    $2,record
        move    record, $3, 16, 0x20
reply:  il      $2,0
        wrch    $ch30,$2
        br      next_mail
exit:   stop    0x2000

        .section .bss,"aw",@nobits
        .balign 128
frame:  .skip   512
record: .skip   128
