# An SPU program that takes frames and traces nothing: it replies as if all tiles of the work units
# had been traced. With it, QEMU counts what the PPE's program does and wastes no time on emulated
# SPUs. All tiles must be whole: 64x16 pixels.
#
# Where the SPUs would build blocks of spheres and cones, it writes no blocks, since the PPE reads
# none. The PPE reads only codes and boxes, and these are those of shapes that fill a cube evenly:
# the codes of a chunk rise by 1, and the boxes of all ranges follow one another through a grid.
# There may be up to 1024 shapes in a chunk, and 2048 blocks. Where the SPUs would refit
# blocks, the PPE's work is the same for any boxes, so the boxes stay as they are.
#
#   Entry   $4 word 1: the number of this SPU; SPU 0 replies for all tiles
#   Mail, reply, exit   as spu/main/main.s

        .set    high, 80
        .set    low, 81
        .set    number, 82
        .set    unit, 83                        # the low address of the unit
        .set    left, 84
        .set    pixels, 85
        .set    unit_high, 86
        .set    task, 87
        .set    result_high, 88
        .set    result, 89                      # the low address of codes or boxes
        .set    box, 90                         # the local-store address of the next box

        .set    FEATURE_BUILD, 2048
        .set    BUILD_SORT, 1
        # The part of a range that is in a block, in 65536ths: 13 spheres or cones.
        .set    IN_BLOCK, 5041

        # Moves bytes between local store and main memory.
        .macro  transfer lsa:req, high:req, low:req, size:req, command:req
        wrch    $ch16,\lsa
        wrch    $ch17,\high
        wrch    $ch18,\low
        wrch    $ch19,\size
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

        # Moves a record.
        .macro  move lsa:req, high:req, low:req, size:req, command:req
        ila     $11,\lsa
        il      $12,\size
        transfer $11, \high, \low, $12, \command
        .endm

        # Goes on with the next unit, if there is one.
        .macro  next_unit first:req
        ai      $unit,$unit,127
        ai      $unit,$unit,1
        ai      $left,$left,-1
        brnz    $left,\first
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
        move    frame, $high, $low, 448, 0x40
        lqa     $left,frame+80                  # unit_count
        rotqbyi $left,$left,8
        lqa     $unit,frame+64                  # units
        rotqbyi $unit_high,$unit,8
        rotqbyi $unit,$unit,12
        lqa     $2,frame                        # features
        rotqbyi $2,$2,12
        il      $3,FEATURE_BUILD
        and     $2,$2,$3
        brnz    $2,build
        il      $pixels,0
        brz     $left,2f
1:      move    record, $unit_high, $unit, 128, 0x40
        lqa     $2,record                       # count
        shli    $2,$2,10
        a       $pixels,$pixels,$2
        next_unit 1b
2:      lqa     $3,frame+64                     # statistics
        ori     $high,$3,0
        rotqbyi $3,$3,4
        ai      $3,$3,16
        cwd     $2,12($1)                       # the low word of primary_rays
        il      $4,0
        shufb   $2,$pixels,$4,$2
        stqa    $2,record
        move    record, $high, $3, 16, 0x20
reply:  il      $2,0
        wrch    $ch30,$2
        br      next_mail
exit:   stop    0x2000

        # The frame is one of BUILD.
build:  lqa     $low,frame+112                  # scene
        rotqbyi $high,$low,8
        rotqbyi $low,$low,12
        move    record, $high, $low, 128, 0x40
        lqa     $task,record+32                 # task
        rotqbyi $task,$task,8
        brz     $task,reply                     # BUILD_REFIT
        ceqi    $2,$task,BUILD_SORT
        brnz    $2,sort

        lqa     $result_high,record+16          # bounds
        rotqbyi $result_high,$result_high,8
        rotqbyi $result,$result_high,4
        il      $4,IN_BLOCK
        ila     $box,boxes
2:      move    record, $unit_high, $unit, 128, 0x40
        lqa     $5,record                       # first
        shli    $5,$5,5
        a       $5,$5,$result
        lqa     $6,record+16                    # triangles
        mpyu    $6,$6,$4
        rotmi   $6,$6,-16
        ai      $6,$6,1
        shli    $6,$6,5
        transfer $box, $result_high, $5, $6, 0x20
        a       $box,$box,$6
        next_unit 2b
        br      reply

sort:   lqa     $result_high,record+48          # sorted
        rotqbyi $result_high,$result_high,8
        rotqbyi $result,$result_high,4
3:      move    record, $unit_high, $unit, 128, 0x40
        lqa     $5,record                       # first
        shli    $5,$5,4
        a       $5,$5,$result
        lqa     $6,record+16                    # triangles
        shli    $6,$6,4
        ila     $7,codes
        transfer $7, $result_high, $5, $6, 0x20
        next_unit 3b
        br      reply

        .data
        .balign 128
        # BUILD_TRIANGLE records.
codes:  .set    at, 0
        .rept   1024
        .long   at, 0, 0, 0
        .set    at, at + 1
        .endr

        # One of a box's numbers: bits of its number that are three apart are the place of a cube
        # between 1 and 2.
        .macro  coordinate number:req, more:req
        .set    cube, ((\number) & 1) + ((\number) >> 2 & 2) + ((\number) >> 4 & 4) + ((\number) >> 6 & 8)
        .long   0x3f800000 + ((cube + \more) << 19)
        .endm
        # BUILD_BOUNDS records.
boxes:  .set    at, 0
        .rept   2048
        coordinate at, 0
        coordinate at >> 1, 0
        coordinate at >> 2, 0
        .long   0
        coordinate at, 1
        coordinate at >> 1, 1
        coordinate at >> 2, 1
        .long   0
        .set    at, at + 1
        .endr

        .section .bss,"aw",@nobits
        .balign 128
frame:  .skip   512
record: .skip   128
