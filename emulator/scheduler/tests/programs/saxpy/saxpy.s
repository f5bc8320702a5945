# saxpy   y = a x + y, two quadwords a pass, the loads of a pass for the next
#   In      $3 a in all words, $4 x, $5 y, $6 passes (at least 1); 16-aligned

        .set a,3
        .set px,4
        .set py,5
        .set passes,6
        .set x1,10
        .set x2,11
        .set y1,12
        .set y2,13
        .set r1,14
        .set r2,15

        .text
        .globl _start
_start:
saxpy:
        hbrr back,loop                                  # 0o, 22 instructions ahead
        lqd $x1,0($px)                                  # 1o x1
        lqd $x2,16($px)                                 # 2o x2
        lqd $y1,0($py)                                  # 3o y1
        ai $px,$px,32                                   # 4e
        lqd $y2,16($py)                                 # 4o y2
        ai $py,$py,32                                   # 5e
        lnop                                            # 5o pairing

loop:
        fma $r1,$a,$x1,$y1                              # 0e r1
        lqd $x1,0($px)                                  # 0o x1 of the next pass

        fma $r2,$a,$x2,$y2                              # 1e r2
        lqd $x2,16($px)                                 # 1o x2

        ai $px,$px,32                                   # 2e
        lqd $y1,0($py)                                  # 2o y1

        ai $passes,$passes,-1                           # 3e
        lqd $y2,16($py)                                 # 3o y2

        ai $py,$py,32                                   # 4e
        lnop                                            # 4o pairing

        nop $127                                        # 5e pairing
        stqd $r1,-64($py)                               # 6o

        nop $127                                        # 7e pairing
        stqd $r2,-48($py)                               # 7o

        nop $127                                        # 8e pairing
back:   brnz $passes,loop                               # 8o
        stop                                            # 9o
        .type saxpy,@function
        .size saxpy,.-saxpy
