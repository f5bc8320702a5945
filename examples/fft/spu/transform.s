# The loops of the transform. They work on 256 lines of 128 bytes. A line is 16 complex numbers: 16
# real parts, then 16 imaginary parts. Each of the 16 belongs to a transform of its own, so that no
# loop but `turn` moves anything from lane to lane.
# Scheduled by spu schedule from transform.s

# The lines of a quarter, in bytes.
        .set    QUARTER, 64*128
# From a line's real parts to its imaginary ones.
        .set    IMAGINARY, 64

# Loads quadword q of the four lines at line_0 to line_3.
        .macro  load_four q:req, line_0:req, line_1:req, line_2:req, line_3:req
        lqd     $x0r,\q*16+\line_0
        lqd     $x0i,\q*16+IMAGINARY+\line_0
        lqd     $x1r,\q*16+\line_1
        lqd     $x1i,\q*16+IMAGINARY+\line_1
        lqd     $x2r,\q*16+\line_2
        lqd     $x2i,\q*16+IMAGINARY+\line_2
        lqd     $x3r,\q*16+\line_3
        lqd     $x3i,\q*16+IMAGINARY+\line_3
        .endm

# Stores the results. Those of a stage go a quarter apart: a pointer in the middle of two quarters
# reaches both.
        .macro  store_four q:req
        stqd    $y0r,\q*16-QUARTER($out_low)
        stqd    $y0i,\q*16-QUARTER+IMAGINARY($out_low)
        stqd    $y1r,\q*16($out_low)
        stqd    $y1i,\q*16+IMAGINARY($out_low)
        stqd    $y2r,\q*16-QUARTER($out_high)
        stqd    $y2i,\q*16-QUARTER+IMAGINARY($out_high)
        stqd    $y3r,\q*16($out_high)
        stqd    $y3i,\q*16+IMAGINARY($out_high)
        .endm

# plus and minus get x + w z and x - w z, for w = cosine (1 - i tangent). Without a multiplication
# of its own: six multiply-adds.
        .macro  twiddle plus_r:req, plus_i:req, minus_r:req, minus_i:req, x_r:req, x_i:req, z_r:req, z_i:req, tangent:req, cosine:req
        fma     $u,$\z_i,$\tangent,$\z_r
        fnms    $v,$\z_r,$\tangent,$\z_i
        fma     $\plus_r,$u,$\cosine,$\x_r
        fma     $\plus_i,$v,$\cosine,$\x_i
        fnms    $\minus_r,$u,$\cosine,$\x_r
        fnms    $\minus_i,$v,$\cosine,$\x_i
        .endm

        .set    x0r, 40
        .set    x0i, 41
        .set    x1r, 42
        .set    x1i, 43
        .set    x2r, 44
        .set    x2i, 45
        .set    x3r, 46
        .set    x3i, 47
        .set    apr, 48                         # x0 + w2 x2
        .set    api, 49
        .set    amr, 50                         # x0 - w2 x2
        .set    ami, 51
        .set    bpr, 52                         # x1 + w2 x3
        .set    bpi, 53
        .set    bmr, 54                         # x1 - w2 x3
        .set    bmi, 55
        .set    u, 56
        .set    v, 57
        .set    y0r, 58
        .set    y0i, 59
        .set    y1r, 60
        .set    y1i, 61
        .set    y2r, 62
        .set    y2i, 63
        .set    y3r, 64
        .set    y3i, 65
        .set    out_low, 20
        .set    out_high, 21
        .set    left, 22

# stage_first   transforms of four numbers: the first stage, which needs no twiddle factors
#   In      $3 256 lines, $4 where 256 lines go
#   Out     nothing
#   Twin    examples/fft/src/twin.rs, stage, with lines of 64
        .set    in_low, 23
        .set    in_high, 24

        .text
        .align  3
        .global stage_first
        .type   stage_first, @function
stage_first:
        .set r22_2,79; .set r40_2,12; .set r44_2,14; .set r54_2,2; .set r41_2,3; .set r51_2,4
        .set r47_2,5; .set r43_2,17; .set r45_2,6; .set r42_2,8; .set r50_2,27; .set r46_2,10
        .set r53_2,9; .set r49_2,30; .set r54_3,7; .set r52_2,11; .set r44_3,8; .set r40_3,10
        .set r64_2,13; .set r47_3,26; .set r52_3,28; .set r42_3,15; .set r51_3,25; .set r65_2,19
        .set r43_3,2; .set r48_2,4; .set r55_2,29; .set r40_4,31; .set r53_3,33; .set r44_4,32
        .set r50_3,34; .set r41_3,17; .set r54_4,16; .set r52_4,18; .set r48_3,12; .set r49_3,14
        .set r53_4,8; .set r50_4,13; .set r55_3,3; .set r48_4,5; .set r51_4,10; .set r59_2,6
        .set r49_4,8; .set r55_4,14; .set r61_2,2; .set r59_3,2; .set r42_4,3; .set r62_2,4
        .set r58_2,5; .set r63_2,6; .set r42_5,7; .set r65_3,8; .set r46_3,9; .set r62_3,10
        .set r64_3,2; .set r47_4,9; .set r60_2,13; .set r43_4,15; .set r45_3,3; .set r41_4,25
        .set r45_4,28; .set r64_4,3; .set r58_3,4; .set r20_2,3; .set r21_2,3; .set r40_5,2
        .set r42_6,4; .set r43_5,5; .set r46_4,6; .set r47_5,7; .set r48_5,8; .set r49_5,9
        .set r50_5,2; .set r51_5,3; .set r52_5,10; .set r53_5,11; .set r54_5,4; .set r40_6,6
        .set r55_5,5; .set r41_5,7; .set r42_7,13; .set r50_6,16; .set r51_6,17; .set r46_5,19
        .set r53_6,25; .set r54_6,27; .set r55_6,28; .set r48_6,29; .set r50_7,6; .set r51_7,7
        .set r52_6,31; .set r53_7,32; .set r54_7,13; .set r55_7,15
        il      $22,64                                  # 0e
        ila     $24,0x6000                              # 1e
        ila     $21,0x6000                              # 2e
        ila     $23,0x2000                              # 3e
        ila     $20,0x2000                              # 4e
        clgti   $r22_2,$22,1                            # 5e at least as many passes as overlap
        a       $24,$24,$3                              # 6e
        a       $23,$23,$3                              # 7e
        a       $21,$21,$4                              # 8e
        lnop                                            # 8o pairing
        a       $20,$20,$4                              # 9e
        brz     $r22_2,first_line_short                 # 9o too few passes
        ai      $22,$22,-1                              # 10e
        lqd     $45,-8080($24)                          # 10o
        lqd     $46,48($24)                             # 11o
        lqd     $42,48($23)                             # 12o
        lqd     $41,-8080($23)                          # 13o
        lqd     $47,80($24)                             # 14o
        lqd     $r40_2,-8176($23)                       # 15o
        lqd     $43,80($23)                             # 16o
        nop     $127                                    # 17e pairing
        lqd     $r44_2,-8176($24)                       # 17o
        fs      $r54_2,$42,$46                          # 18e
        lqd     $r41_2,-8096($23)                       # 18o
        fs      $r51_2,$41,$45                          # 19e
        lqd     $r47_2,96($24)                          # 19o
        fa      $49,$41,$45                             # 20e
        lqd     $r43_2,96($23)                          # 20o
        fa      $52,$42,$46                             # 21e
        lqd     $r45_2,-8096($24)                       # 21o
        fs      $55,$43,$47                             # 22e
        lqd     $r42_2,32($23)                          # 22o
        fs      $r50_2,$r40_2,$r44_2                    # 23e
        lqd     $r46_2,32($24)                          # 23o
        fa      $53,$43,$47                             # 24e
        lqd     $40,-8192($23)                          # 24o
        fs      $61,$r51_2,$r54_2                       # 25e
        lqd     $44,-8192($24)                          # 25o
        fa      $r53_2,$r43_2,$r47_2                    # 26e
        lqd     $42,0($23)                              # 26o
        fa      $r49_2,$r41_2,$r45_2                    # 27e
        lqd     $46,0($24)                              # 27o
        fs      $51,$r41_2,$r45_2                       # 28e
        lqd     $r41_2,-8128($23)                       # 28o
        fs      $r54_3,$r42_2,$r46_2                    # 29e
        lqd     $r45_2,-8128($24)                       # 29o
        fa      $r52_2,$r42_2,$r46_2                    # 30e
        lqd     $r44_3,-8160($24)                       # 30o
        fa      $48,$40,$44                             # 31e
        lqd     $r40_3,-8160($23)                       # 31o
        fs      $r64_2,$r50_2,$55                       # 32e
        lqd     $r47_3,112($24)                         # 32o
        fa      $r52_3,$42,$46                          # 33e
        lqd     $43,112($23)                            # 33o
        fs      $54,$42,$46                             # 34e
        lqd     $r42_3,16($23)                          # 34o
        fs      $r51_3,$r41_2,$r45_2                    # 35e
        lqd     $46,16($24)                             # 35o
        fa      $r65_2,$r51_2,$r54_2                    # 36e
        lqd     $r43_3,64($23)                          # 36o
        fa      $r48_2,$r40_3,$r44_3                    # 37e
        lqd     $47,64($24)                             # 37o
        fs      $r55_2,$r43_2,$r47_2                    # 38e
        lqd     $r40_4,-8144($23)                       # 38o
        fa      $r53_3,$43,$r47_3                       # 39e
        lqd     $r44_4,-8144($24)                       # 39o
        fs      $r50_3,$r40_3,$r44_3                    # 40e
        lqd     $45,-8112($24)                          # 40o
        fs      $63,$r49_2,$r53_2                       # 41e
        lqd     $r41_3,-8112($23)                       # 41o
        fa      $65,$51,$r54_3                          # 42e
        stqd    $61,112($20)                            # 42o
        fa      $58,$48,$r52_3                          # 43e
        stqd    $r64_2,16($21)                          # 43o
        fs      $50,$40,$44                             # 44e
        stqd    $r65_2,112($21)                         # 44o
        fs      $r54_4,$r42_3,$46                       # 45e
        fa      $r52_4,$r42_3,$46                       # 46e
        fa      $r48_3,$r40_2,$r44_2                    # 47e
        stqd    $63,-8096($21)                          # 47o
        fa      $r49_3,$r41_2,$r45_2                    # 48e
        stqd    $65,96($21)                             # 48o
        ai      $23,$23,128                             # 49e
        hbrr    first_line_back,first_line              # 49o hint
        fs      $61,$r51_3,$54                          # 50e
        stqd    $58,-8192($20)                          # 50o
        fs      $62,$r48_2,$r52_2                       # 51e
        fa      $59,$49,$r53_3                          # 52e
        fa      $60,$r50_3,$r55_2                       # 53e - i times the other difference
        fa      $r53_4,$r43_3,$47                       # 54e
        fs      $r50_4,$r40_4,$r44_4                    # 55e
        lnop                                            # 55o pairing
        fs      $64,$r50_3,$r55_2                       # 56e
        stqd    $61,64($20)                             # 56o
        fs      $r55_3,$43,$r47_3                       # 57e
        stqd    $62,-8160($21)                          # 57o
        fa      $r48_4,$r40_4,$r44_4                    # 58e
        stqd    $59,-8080($20)                          # 58o
        fs      $r51_4,$r41_3,$45                       # 59e
        stqd    $60,32($20)                             # 59o
        fa      $r59_2,$r49_3,$r53_4                    # 60e
        fs      $63,$r49_3,$r53_4                       # 61e
        fa      $r49_4,$r41_3,$45                       # 62e
        stqd    $64,32($21)                             # 62o
        fs      $r55_4,$r43_3,$47                       # 63e
        fa      $60,$r50_4,$r55_3                       # 64e - i times the other difference
        ai      $24,$24,128                             # 65e
        lnop                                            # 65o pairing
first_line:
            fs      $61,$r51_4,$r54_4                   # 0e
        lqd     $45,-8080($24)                          # 0o
            fs      $r61_2,$51,$r54_3                   # 1e
            stqd    $r59_2,-8128($20)                   # 1o
            fa      $58,$r48_4,$52                      # 2e
        lqd     $46,48($24)                             # 2o
            fs      $62,$r48_4,$52                      # 3e
            stqd    $63,-8128($21)                      # 3o
            fa      $65,$r51_3,$54                      # 4e
        lqd     $42,48($23)                             # 4o
            fa      $59,$r49_4,$53                      # 5e
            stqd    $60,48($20)                         # 5o
        ai      $22,$22,-1                              # 6e
            stqd    $61,80($20)                         # 6o
            fs      $63,$r49_4,$53                      # 7e
            stqd    $r61_2,96($20)                      # 7o
            fa      $r59_3,$r49_2,$r53_2                # 8e
            stqd    $58,-8144($20)                      # 8o
            fs      $64,$r50_4,$r55_3                   # 9e
        lqd     $r42_4,16($23)                          # 9o
            fa      $58,$r48_2,$r52_2                   # 10e
        lqd     $40,-8192($23)                          # 10o
            fs      $r62_2,$r48_3,$r52_4                # 11e
        lqd     $41,-8080($23)                          # 11o
            fa      $r58_2,$r48_3,$r52_4                # 12e
        lqd     $47,80($24)                             # 12o
            fs      $r63_2,$49,$r53_3                   # 13e
        lqd     $r42_5,32($23)                          # 13o
        fa      $52,$42,$46                             # 14e
            stqd    $63,-8112($21)                      # 14o
            fa      $r65_3,$r51_4,$r54_4                # 15e
        lqd     $r46_3,32($24)                          # 15o
        fs      $54,$42,$46                             # 16e
            stqd    $59,-8112($20)                      # 16o
        fs      $51,$41,$45                             # 17e
            stqd    $58,-8160($20)                      # 17o
        fa      $49,$41,$45                             # 18e
        lqd     $45,-8112($24)                          # 18o
            fs      $r62_3,$48,$r52_3                   # 19e
            stqd    $r59_3,-8096($20)                   # 19o
            fs      $r64_3,$50,$r55_4                   # 20e
        lqd     $44,-8192($24)                          # 20o
        fa      $r52_2,$r42_5,$r46_3                    # 21e
        lqd     $46,16($24)                             # 21o
            fa      $60,$r50_2,$55                      # 22e - i times the other difference
        lqd     $r40_2,-8176($23)                       # 22o
        fs      $r54_3,$r42_5,$r46_3                    # 23e
        lqd     $41,-8096($23)                          # 23o
        fs      $61,$51,$54                             # 24e
        lqd     $r47_4,96($24)                          # 24o
            fa      $r60_2,$50,$r55_4                   # 25e - i times the other difference
        lqd     $43,80($23)                             # 25o
        fa      $48,$40,$44                             # 26e
        lqd     $r44_2,-8176($24)                       # 26o
        fs      $50,$40,$44                             # 27e
        lqd     $r43_4,64($23)                          # 27o
        fs      $r54_4,$r42_4,$46                       # 28e
        lqd     $r43_2,96($23)                          # 28o
        fa      $r52_4,$r42_4,$46                       # 29e
        lqd     $r45_3,-8096($24)                       # 29o
        fa      $r65_2,$51,$54                          # 30e
        lqd     $r41_4,-8128($23)                       # 30o
        fs      $55,$43,$47                             # 31e
        lqd     $r47_3,112($24)                         # 31o
        fa      $53,$43,$47                             # 32e
        lqd     $42,0($23)                              # 32o
        fs      $r50_2,$r40_2,$r44_2                    # 33e
        lqd     $r45_4,-8128($24)                       # 33o
        fs      $r55_2,$r43_2,$r47_4                    # 34e
        lqd     $46,0($24)                              # 34o
        fa      $r53_2,$r43_2,$r47_4                    # 35e
        lqd     $r41_3,-8112($23)                       # 35o
        fa      $r49_2,$41,$r45_3                       # 36e
        lqd     $47,64($24)                             # 36o
        fs      $51,$41,$r45_3                          # 37e
        lqd     $43,112($23)                            # 37o
        fa      $r48_3,$r40_2,$r44_2                    # 38e
        lqd     $44,-8160($24)                          # 38o
        fs      $r64_4,$r50_2,$55                       # 39e
        lqd     $40,-8160($23)                          # 39o
        fa      $r49_3,$r41_4,$r45_4                    # 40e
        lqd     $r40_4,-8144($23)                       # 40o
        fs      $54,$42,$46                             # 41e
        lqd     $r44_4,-8144($24)                       # 41o
        ai      $23,$23,128                             # 42e
            stqd    $62,-8144($21)                      # 42o
        fs      $r51_3,$r41_4,$r45_4                    # 43e
            stqd    $r65_3,80($21)                      # 43o
        fa      $r52_3,$42,$46                          # 44e
            stqd    $60,16($20)                         # 44o
        fa      $r53_4,$r43_4,$47                       # 45e
            stqd    $64,48($21)                         # 45o
        fa      $r53_3,$43,$r47_3                       # 46e
            stqd    $65,64($21)                         # 46o
        fs      $r50_3,$40,$44                          # 47e
            stqd    $r62_2,-8176($21)                   # 47o
        fa      $r48_2,$40,$44                          # 48e
            stqd    $r60_2,0($20)                       # 48o
        fs      $r50_4,$r40_4,$r44_4                    # 49e
            stqd    $r58_2,-8176($20)                   # 49o
        ai      $24,$24,128                             # 50e
            stqd    $r63_2,-8080($21)                   # 50o
            ai      $20,$20,128                         # 51e
            stqd    $r64_3,0($21)                       # 51o
        fs      $63,$r49_2,$r53_2                       # 52e
            stqd    $r62_3,-8192($21)                   # 52o
            ai      $21,$21,128                         # 53e
        stqd    $61,112($20)                            # 53o
        fa      $65,$51,$r54_3                          # 54e
        lnop                                            # 54o pairing
        fa      $r48_4,$r40_4,$r44_4                    # 55e
        stqd    $r64_4,16($21)                          # 55o
        fa      $58,$48,$r52_3                          # 56e
        stqd    $r65_2,112($21)                         # 56o
        fs      $61,$r51_3,$54                          # 57e
        lnop                                            # 57o pairing
        fs      $62,$r48_2,$r52_2                       # 58e
        stqd    $63,-8096($21)                          # 58o
        fa      $59,$49,$r53_3                          # 59e
        lnop                                            # 59o pairing
        fa      $60,$r50_3,$r55_2                       # 60e - i times the other difference
        stqd    $65,96($21)                             # 60o
        fs      $64,$r50_3,$r55_2                       # 61e
        lnop                                            # 61o pairing
        fs      $r55_3,$43,$r47_3                       # 62e
        stqd    $58,-8192($20)                          # 62o
        fs      $r51_4,$r41_3,$45                       # 63e
        stqd    $61,64($20)                             # 63o
        fa      $r59_2,$r49_3,$r53_4                    # 64e
        stqd    $62,-8160($21)                          # 64o
        fs      $63,$r49_3,$r53_4                       # 65e
        stqd    $59,-8080($20)                          # 65o
        fa      $r49_4,$r41_3,$45                       # 66e
        stqd    $60,32($20)                             # 66o
        fs      $r55_4,$r43_4,$47                       # 67e
        stqd    $64,32($21)                             # 67o
        fa      $60,$r50_4,$r55_3                       # 68e - i times the other difference
first_line_back:
        brnz    $22,first_line                          # 68o
first_line_drain:
        fs      $61,$r51_4,$r54_4                       # 0e
        stqd    $r59_2,-8128($20)                       # 0o
        fs      $r61_2,$51,$r54_3                       # 1e
        stqd    $63,-8128($21)                          # 1o
        fa      $58,$r48_4,$52                          # 2e
        stqd    $60,48($20)                             # 2o
        fs      $63,$r49_4,$53                          # 3e
        hbr     stage_first_return,$lr                  # 3o hint
        fa      $59,$r49_4,$53                          # 4e
        fa      $r58_3,$r48_2,$r52_2                    # 5e
        fa      $r59_2,$r49_2,$r53_2                    # 6e
        stqd    $61,80($20)                             # 6o
        fs      $62,$r48_4,$52                          # 7e
        stqd    $r61_2,96($20)                          # 7o
        fa      $r65_3,$r51_4,$r54_4                    # 8e
        stqd    $58,-8144($20)                          # 8o
        fa      $60,$r50_2,$55                          # 9e - i times the other difference
        stqd    $63,-8112($21)                          # 9o
        fs      $64,$r50_4,$r55_3                       # 10e
        stqd    $59,-8112($20)                          # 10o
        fa      $65,$r51_3,$54                          # 11e
        stqd    $r58_3,-8160($20)                       # 11o
        fs      $r62_2,$r48_3,$r52_4                    # 12e
        stqd    $r59_2,-8096($20)                       # 12o
        fa      $r60_2,$50,$r55_4                       # 13e - i times the other difference
        stqd    $62,-8144($21)                          # 13o
        fa      $r58_2,$r48_3,$r52_4                    # 14e
        stqd    $r65_3,80($21)                          # 14o
        fs      $r63_2,$49,$r53_3                       # 15e
        stqd    $60,16($20)                             # 15o
        fs      $r64_3,$50,$r55_4                       # 16e
        stqd    $64,48($21)                             # 16o
        fs      $r62_3,$48,$r52_3                       # 17e
        stqd    $65,64($21)                             # 17o
        ai      $r20_2,$20,128                          # 18e
        stqd    $r62_2,-8176($21)                       # 18o
        ai      $r21_2,$21,128                          # 19e
        stqd    $r60_2,0($20)                           # 19o
        stqd    $r58_2,-8176($20)                       # 20o
        stqd    $r63_2,-8080($21)                       # 21o
        stqd    $r64_3,0($21)                           # 22o
        stqd    $r62_3,-8192($21)                       # 23o
        nop     $127                                    # 24e pairing
stage_first_return:
        bi      $lr                                     # 24o
first_line_short:
        ai      $22,$22,-1                              # 0e
        lqd     $40,-8192($23)                          # 0o
        lqd     $41,-8128($23)                          # 1o
        lqd     $42,0($23)                              # 2o
        lqd     $43,64($23)                             # 3o
        lqd     $44,-8192($24)                          # 4o
        lqd     $45,-8128($24)                          # 5o
        lqd     $46,0($24)                              # 6o
        lqd     $47,64($24)                             # 7o
        lqd     $r40_5,-8176($23)                       # 8o
        nop     $127                                    # 9e pairing
        lqd     $r41_2,-8112($23)                       # 9o
        fa      $48,$40,$44                             # 10e
        lqd     $r42_6,16($23)                          # 10o
        fa      $49,$41,$45                             # 11e
        lqd     $r43_5,80($23)                          # 11o
        fs      $50,$40,$44                             # 12e
        lqd     $44,-8176($24)                          # 12o
        fs      $51,$41,$45                             # 13e
        lqd     $45,-8112($24)                          # 13o
        fa      $52,$42,$46                             # 14e
        lqd     $r46_4,16($24)                          # 14o
        fa      $53,$43,$47                             # 15e
        lqd     $r47_5,80($24)                          # 15o
        fs      $54,$42,$46                             # 16e
        lqd     $40,-8160($23)                          # 16o
        fs      $55,$43,$47                             # 17e
        lqd     $41,-8096($23)                          # 17o
        fa      $r48_5,$r40_5,$44                       # 18e
        lqd     $42,32($23)                             # 18o
        fa      $r49_5,$r41_2,$45                       # 19e
        lqd     $43,96($23)                             # 19o
        fs      $r50_5,$r40_5,$44                       # 20e
        lqd     $44,-8160($24)                          # 20o
        fs      $r51_5,$r41_2,$45                       # 21e
        lqd     $45,-8096($24)                          # 21o
        fa      $r52_5,$r42_6,$r46_4                    # 22e
        lqd     $46,32($24)                             # 22o
        fa      $r53_5,$r43_5,$r47_5                    # 23e
        lqd     $47,96($24)                             # 23o
        fs      $r54_5,$r42_6,$r46_4                    # 24e
        lqd     $r40_6,-8144($23)                       # 24o
        fs      $r55_5,$r43_5,$r47_5                    # 25e
        lqd     $r41_5,-8080($23)                       # 25o
        fa      $r48_3,$40,$44                          # 26e
        lqd     $r42_7,48($23)                          # 26o
        fa      $r49_3,$41,$45                          # 27e
        lqd     $r43_4,112($23)                         # 27o
        fs      $r50_6,$40,$44                          # 28e
        lqd     $44,-8144($24)                          # 28o
        fs      $r51_6,$41,$45                          # 29e
        lqd     $45,-8080($24)                          # 29o
        fa      $r52_4,$42,$46                          # 30e
        lqd     $r46_5,48($24)                          # 30o
        fa      $r53_6,$43,$47                          # 31e
        lqd     $r47_3,112($24)                         # 31o
        fs      $r54_6,$42,$46                          # 32e
        fs      $r55_6,$43,$47                          # 33e
        fa      $r48_6,$r40_6,$44                       # 34e
        fa      $r49_2,$r41_5,$45                       # 35e
        fs      $r50_7,$r40_6,$44                       # 36e
        fs      $r51_7,$r41_5,$45                       # 37e
        fa      $r52_6,$r42_7,$r46_5                    # 38e
        fa      $r53_7,$r43_4,$r47_3                    # 39e
        fs      $r54_7,$r42_7,$r46_5                    # 40e
        fs      $r55_7,$r43_4,$r47_3                    # 41e
        fa      $58,$48,$52                             # 42e
        fa      $59,$49,$53                             # 43e
        fs      $62,$48,$52                             # 44e
        fs      $63,$49,$53                             # 45e
        fa      $60,$50,$55                             # 46e - i times the other difference
        fs      $61,$51,$54                             # 47e
        fs      $64,$50,$55                             # 48e
        stqd    $58,-8192($20)                          # 48o
        fa      $65,$51,$54                             # 49e
        stqd    $59,-8128($20)                          # 49o
        fa      $58,$r48_5,$r52_5                       # 50e
        stqd    $62,-8192($21)                          # 50o
        fa      $59,$r49_5,$r53_5                       # 51e
        stqd    $63,-8128($21)                          # 51o
        fs      $62,$r48_5,$r52_5                       # 52e
        stqd    $60,0($20)                              # 52o
        fs      $63,$r49_5,$r53_5                       # 53e
        stqd    $61,64($20)                             # 53o
        fa      $60,$r50_5,$r55_5                       # 54e - i times the other difference
        stqd    $64,0($21)                              # 54o
        fs      $61,$r51_5,$r54_5                       # 55e
        stqd    $65,64($21)                             # 55o
        fs      $64,$r50_5,$r55_5                       # 56e
        stqd    $58,-8176($20)                          # 56o
        fa      $65,$r51_5,$r54_5                       # 57e
        stqd    $59,-8112($20)                          # 57o
        fa      $58,$r48_3,$r52_4                       # 58e
        stqd    $62,-8176($21)                          # 58o
        fa      $59,$r49_3,$r53_6                       # 59e
        stqd    $63,-8112($21)                          # 59o
        fs      $62,$r48_3,$r52_4                       # 60e
        stqd    $60,16($20)                             # 60o
        fs      $63,$r49_3,$r53_6                       # 61e
        stqd    $61,80($20)                             # 61o
        fa      $60,$r50_6,$r55_6                       # 62e - i times the other difference
        stqd    $64,16($21)                             # 62o
        fs      $61,$r51_6,$r54_6                       # 63e
        stqd    $65,80($21)                             # 63o
        fs      $64,$r50_6,$r55_6                       # 64e
        stqd    $58,-8160($20)                          # 64o
        fa      $65,$r51_6,$r54_6                       # 65e
        stqd    $59,-8096($20)                          # 65o
        fa      $58,$r48_6,$r52_6                       # 66e
        stqd    $62,-8160($21)                          # 66o
        fa      $59,$r49_2,$r53_7                       # 67e
        stqd    $63,-8096($21)                          # 67o
        fs      $62,$r48_6,$r52_6                       # 68e
        stqd    $60,32($20)                             # 68o
        fs      $63,$r49_2,$r53_7                       # 69e
        stqd    $61,96($20)                             # 69o
        fa      $60,$r50_7,$r55_7                       # 70e - i times the other difference
        stqd    $64,32($21)                             # 70o
        fs      $61,$r51_7,$r54_7                       # 71e
        stqd    $65,96($21)                             # 71o
        fs      $64,$r50_7,$r55_7                       # 72e
        stqd    $58,-8144($20)                          # 72o
        fa      $65,$r51_7,$r54_7                       # 73e
        stqd    $59,-8080($20)                          # 73o
        ai      $23,$23,128                             # 74e
        stqd    $62,-8144($21)                          # 74o
        ai      $24,$24,128                             # 75e
        stqd    $63,-8080($21)                          # 75o
        stqd    $60,48($20)                             # 76o
        stqd    $61,112($20)                            # 77o
        ai      $20,$20,128                             # 78e
        stqd    $64,48($21)                             # 78o
        nop     $127                                    # 79e pairing
        stqd    $65,112($21)                            # 79o
        ai      $21,$21,128                             # 80e
        brnz    $22,first_line_short                    # 80o
        nop     $127                                    # 81e pairing
        bi      $lr                                     # 81o
        .size   stage_first, .-stage_first

# stage   the stage that joins four transforms of a length to one of four times that length
#   In      $3 256 lines, $4 where 256 lines go, $5 twiddle factors, $6 bytes from a line to the
#           next one of the same transform, $7 how far to the right to shift multiples of that, as
#           a negative number, to get an offset in the twiddle factors
#   Out     nothing
#   Twin    examples/fft/src/twin.rs, stage
#
# Line i belongs to butterfly p = i / s, where s is the distance. It takes the lines i + 3 p s and
# s, 2 s and 3 s behind that. A record of twiddle factors has four quadwords: tangent and cosine of
# the square of w, tangent and cosine of w.
        .set    m_butterfly, 23                 # the part of an offset that is p s
        .set    three, 24
        .set    i, 25
        .set    base_0, 26
        .set    base_1, 27
        .set    base_2, 28
        .set    base_3, 29
        .set    factors_1, 30
        .set    factors_2, 31
        .set    factors_3, 32
        .set    line_0, 33
        .set    line_1, 34
        .set    line_2, 35
        .set    line_3, 36
        .set    butterfly, 37
        .set    t2, 66
        .set    c2, 67
        .set    t1, 68
        .set    c1, 69

        .align  3
        .global stage
        .type   stage, @function
stage:
        .set r36_2,3; .set r47_6,11; .set r46_6,8; .set r47_7,12; .set r44_5,17; .set r45_5,18
        .set r43_6,39; .set r57_2,11; .set r57_3,14; .set r56_2,8; .set r42_8,2; .set r56_3,4
        .set r44_6,19; .set r52_7,46; .set r45_6,36; .set r53_8,48; .set r57_4,6; .set r56_4,10
        .set r54_8,42; .set r55_8,11; .set r43_7,13; .set r41_6,12; .set r52_8,16; .set r57_5,18
        .set r47_8,3; .set r41_7,49; .set r56_5,2; .set r40_7,17; .set r40_8,50; .set r48_7,43
        .set r56_6,19; .set r44_7,36; .set r45_7,35; .set r53_9,37; .set r43_8,34; .set r56_7,39
        .set r41_8,47; .set r54_9,10; .set r41_9,33; .set r56_8,13; .set r51_8,41; .set r56_9,58
        .set r57_6,3; .set r57_7,15; .set r50_8,59; .set r57_8,60; .set r58_4,14; .set r48_8,18
        .set r56_10,38; .set r57_9,39; .set r52_9,43; .set r56_11,54; .set r53_10,62; .set r59_4,13
        .set r58_5,41; .set r60_3,45; .set r57_10,35; .set r54_10,36; .set r48_9,44; .set r49_6,58
        .set r50_9,4; .set r51_9,16; .set r56_12,41; .set r57_11,13; .set r51_10,45; .set r57_12,52
        .set r49_7,42; .set r56_13,53; .set r50_10,54; .set r60_4,3; .set r58_6,6; .set r61_3,3
        .set r59_5,4; .set r62_4,2; .set r63_3,9; .set r46_7,13; .set r56_14,12; .set r57_13,16
        .set r42_9,38; .set r52_10,8; .set r53_11,13; .set r56_15,17; .set r44_8,40; .set r52_11,41
        .set r57_14,4; .set r53_12,6; .set r54_11,12; .set r40_9,34; .set r41_10,35; .set r41_11,36
        .set r50_11,17; .set r56_16,40; .set r57_15,10; .set r40_10,33; .set r50_12,12
        .set r58_7,2; .set r65_4,3; .set r64_5,4; .set r61_4,4; .set r59_6,3; .set r62_5,5
        .set r63_4,7; .set r21_3,2; .set r20_3,2; .set r36_3,2; .set r46_8,4; .set r57_16,8
        .set r42_10,9; .set r56_17,3; .set r44_9,4; .set r43_9,11; .set r41_12,13; .set r40_11,14
        .set r46_9,16; .set r52_12,3; .set r47_9,2; .set r54_12,9; .set r55_9,17; .set r53_13,4
        .set r44_10,6; .set r48_10,19; .set r56_18,35; .set r40_12,36; .set r56_19,37
        .set r41_13,38; .set r49_8,15; .set r56_20,33; .set r56_21,9; .set r57_17,17; .set r60_5,40
        .set r64_6,12; .set r58_8,16; .set r62_6,14; .set r61_5,15; .set r57_18,2; .set r55_10,6
        .set r53_14,3; .set r48_11,15; .set r51_11,2; .set r56_22,6; .set r58_9,13; .set r63_5,8
        .set r59_7,9
        ori     $26,$3,0                                # 0e
        il      $22,64                                  # 1e
        a       $27,$26,$6                              # 2e
        ila     $21,0x6000                              # 3e
        ila     $20,0x2000                              # 4e
        a       $28,$27,$6                              # 5e
        clgti   $r22_2,$22,1                            # 6e at least as many passes as overlap
        a       $21,$21,$4                              # 7e
        a       $20,$20,$4                              # 8e
        sfi     $23,$6,0                                # 9e
        a       $29,$28,$6                              # 10e
        ai      $30,$5,16                               # 11e
        ai      $31,$5,32                               # 12e
        ai      $32,$5,48                               # 13e
        il      $24,3                                   # 14e
        lnop                                            # 14o pairing
        il      $25,0                                   # 15e
        brz     $r22_2,stage_line_short                 # 15o too few passes
        and     $37,$25,$23                             # 17e
        ai      $22,$22,-1                              # 18e
        mpya    $36,$37,$24,$25                         # 19e
        rotm    $37,$37,$7                              # 20e
        ai      $25,$25,128                             # 21e
        lqx     $66,$5,$37                              # 24o
        nop     $127                                    # 25e pairing
        lqx     $67,$30,$37                             # 25o
        a       $r36_2,$29,$36                          # 26e
        lqx     $68,$31,$37                             # 26o
        a       $34,$27,$36                             # 27e
        lqx     $69,$32,$37                             # 27o
        a       $35,$28,$36                             # 28e
        lqd     $46,0($r36_2)                           # 28o
        a       $33,$26,$36                             # 29e
        lqd     $r47_6,64($r36_2)                       # 29o
        lqd     $r46_6,16($r36_2)                       # 30o
        lqd     $r47_7,80($r36_2)                       # 31o
        lqd     $r44_5,0($35)                           # 32o
        lqd     $r45_5,64($35)                          # 33o
        nop     $127                                    # 34e pairing
        lqd     $42,0($34)                              # 34o
        fma     $56,$r47_6,$66,$46                      # 35e
        lqd     $r43_6,64($34)                          # 35o
        fnms    $r57_2,$46,$66,$r47_6                   # 36e
        lqd     $r46_2,32($r36_2)                       # 36o
        fnms    $r57_3,$r46_6,$66,$r47_7                # 37e
        lqd     $47,96($r36_2)                          # 37o
        fma     $r56_2,$r47_7,$66,$r46_6                # 38e
        lqd     $r42_8,16($34)                          # 38o
        fma     $r56_3,$r45_5,$66,$r44_5                # 39e
        lqd     $43,80($34)                             # 39o
        fnms    $57,$r44_5,$66,$r45_5                   # 40e
        lqd     $r44_6,16($35)                          # 40o
        fma     $r52_7,$56,$67,$42                      # 41e
        lqd     $r45_6,80($35)                          # 41o
        fma     $r53_8,$r57_2,$67,$r43_6                # 42e
        lqd     $40,0($33)                              # 42o
        fnms    $r57_4,$r46_2,$66,$47                   # 43e
        lqd     $44,32($35)                             # 43o
        fma     $r56_4,$47,$66,$r46_2                   # 44e
        lqd     $45,96($35)                             # 44o
        fnms    $r54_8,$56,$67,$42                      # 45e
        lqd     $r42_3,32($34)                          # 45o
        fnms    $r55_8,$r57_2,$67,$r43_6                # 46e
        lqd     $r43_7,96($34)                          # 46o
        fma     $53,$r57_3,$67,$43                      # 47e
        lqd     $r41_6,64($33)                          # 47o
        fma     $r52_8,$r56_2,$67,$r42_8                # 48e
        lqd     $r46_3,48($r36_2)                       # 48o
        fnms    $r57_5,$r44_6,$66,$r45_6                # 49e
        lqd     $r47_8,112($r36_2)                      # 49o
        fnms    $54,$r56_2,$67,$r42_8                   # 50e
        lqd     $r41_7,80($33)                          # 50o
        fma     $r56_5,$r45_6,$66,$r44_6                # 51e
        lqd     $r40_7,16($33)                          # 51o
        fnms    $r55_4,$r57_3,$67,$43                   # 52e
        lqd     $r40_8,32($33)                          # 52o
        fma     $r48_7,$r56_3,$67,$40                   # 53e
        lqd     $r42_2,48($34)                          # 53o
        fma     $r56_6,$r53_8,$68,$r52_7                # 54e
        lqd     $r44_7,48($35)                          # 54o
        fma     $52,$r56_4,$67,$r42_3                   # 55e
        lqd     $r45_7,112($35)                         # 55o
        fma     $r53_9,$r57_4,$67,$r43_7                # 56e
        lqd     $r43_8,112($34)                         # 56o
        fma     $r56_7,$45,$66,$44                      # 57e
        lqd     $r41_8,96($33)                          # 57o
        fnms    $55,$r57_4,$67,$r43_7                   # 58e
        lqd     $r40_6,48($33)                          # 58o
        fnms    $r54_9,$r56_4,$67,$r42_3                # 59e
        lqd     $r41_9,112($33)                         # 59o
        fma     $r56_8,$r55_8,$68,$r54_8                # 60e
        fnms    $r51_8,$57,$67,$r41_6                   # 61e
        fma     $r56_9,$r47_8,$66,$r46_3                # 62e
        fnms    $r57_6,$r46_3,$66,$r47_8                # 63e
        fma     $r49_5,$r57_5,$67,$r41_7                # 64e
        fnms    $r57_7,$r52_8,$68,$53                   # 65e
        fnms    $r50_8,$r56_5,$67,$r40_7                # 66e
        fnms    $r57_8,$54,$68,$r55_4                   # 67e
        fnms    $51,$r57_5,$67,$r41_7                   # 68e
        fma     $56,$r55_4,$68,$54                      # 69e
        fma     $r58_4,$r56_6,$69,$r48_7                # 70e
        fma     $r48_8,$r56_7,$67,$r40_8                # 71e
        fma     $r56_10,$r53_9,$68,$52                  # 72e
        fnms    $62,$r56_6,$69,$r48_7                   # 73e
        fnms    $50,$r56_7,$67,$r40_8                   # 74e
        fnms    $r57_9,$r54_9,$68,$55                   # 75e
        fnms    $61,$r56_8,$69,$r51_8                   # 76e
        stqd    $r58_4,-8192($20)                       # 76o
        fnms    $r57_3,$44,$66,$45                      # 77e
        fma     $r52_9,$r56_9,$67,$r42_2                # 78e
        fma     $r56_11,$r45_7,$66,$r44_7               # 79e
        stqd    $62,-8192($21)                          # 79o
        fma     $r53_10,$r57_6,$67,$r43_8               # 80e
        fma     $65,$r56_8,$69,$r51_8                   # 81e
        fma     $r59_4,$r57_7,$69,$r49_5                # 82e
        stqd    $61,64($20)                             # 82o
        fnms    $64,$r57_8,$69,$r50_8                   # 83e
        fma     $r65_2,$56,$69,$51                      # 84e
        fma     $r58_5,$r56_10,$69,$r48_8               # 85e
        fma     $r60_3,$r57_9,$69,$50                   # 86e - i times the other difference
        fnms    $r57_10,$r44_7,$66,$r45_7               # 87e
        stqd    $65,64($21)                             # 87o
        fnms    $r54_10,$r56_9,$67,$r42_2               # 88e
        stqd    $r59_4,-8112($20)                       # 88o
        fnms    $r55_3,$r57_6,$67,$r43_8                # 89e
        stqd    $64,16($21)                             # 89o
        fma     $r48_9,$r56_11,$67,$r40_6               # 90e
        stqd    $r65_2,80($21)                          # 90o
        fma     $r49_6,$57,$67,$r41_6                   # 91e
        stqd    $r58_5,-8160($20)                       # 91o
        fnms    $r50_9,$r56_3,$67,$40                   # 92e
        stqd    $r60_3,32($20)                          # 92o
        fnms    $r57_2,$r54_8,$68,$r55_8                # 93e
        fma     $r56_2,$53,$68,$r52_8                   # 94e
        fma     $r56_6,$55,$68,$r54_9                   # 95e
        fnms    $57,$r52_7,$68,$r53_8                   # 96e
        fma     $48,$r56_5,$67,$r40_7                   # 97e
        fnms    $r51_9,$r57_3,$67,$r41_8                # 98e
        fma     $r56_12,$r53_10,$68,$r52_9              # 99e
        fnms    $r64_3,$r57_9,$69,$50                   # 100e
        fma     $49,$r57_3,$67,$r41_8                   # 101e
        fnms    $r57_11,$52,$68,$r53_9                  # 102e
        fnms    $r57_9,$r54_10,$68,$r55_3               # 103e
        fnms    $r51_10,$r57_10,$67,$r41_9              # 104e
        fnms    $r57_12,$r52_9,$68,$r53_10              # 105e
        lnop                                            # 105o pairing
        fma     $r49_7,$r57_10,$67,$r41_9               # 106e
        stqd    $r64_3,32($21)                          # 106o
        fma     $r56_13,$r55_3,$68,$r54_10              # 107e
        fnms    $r50_10,$r56_11,$67,$r40_6              # 108e
        fma     $65,$r56_6,$69,$r51_9                   # 109e
        fnms    $62,$r56_12,$69,$r48_9                  # 110e
        fnms    $63,$57,$69,$r49_6                      # 111e
        fma     $r60_4,$r57_2,$69,$r50_9                # 112e - i times the other difference
        fnms    $64,$r57_2,$69,$r50_9                   # 113e
        fma     $r58_6,$r56_2,$69,$48                   # 114e
        fma     $60,$r57_8,$69,$r50_8                   # 115e - i times the other difference
        lnop                                            # 115o pairing
stage_line:
            fnms    $61,$56,$69,$51                     # 0e
            stqd    $65,96($21)                         # 0o
            fnms    $r61_2,$r56_6,$69,$r51_9            # 1e
            stqd    $62,-8144($21)                      # 1o
            fma     $59,$r57_12,$69,$r49_7              # 2e
            stqd    $63,-8128($21)                      # 2o
        and     $37,$25,$23                             # 3e
            stqd    $r60_4,0($20)                       # 3o
            fnms    $r61_3,$r56_13,$69,$r51_10          # 4e
            stqd    $64,0($21)                          # 4o
        mpya    $36,$37,$24,$25                         # 5e
            stqd    $r58_6,-8176($20)                   # 5o
        rotm    $37,$37,$7                              # 6e
            stqd    $60,16($20)                         # 6o
            fnms    $63,$r57_7,$69,$r49_5               # 7e
            stqd    $61,80($20)                         # 7o
            fma     $r59_5,$r57_11,$69,$49              # 8e
            stqd    $59,-8080($20)                      # 8o
            fnms    $62,$r56_10,$69,$r48_8              # 9e
            stqd    $r61_2,96($20)                      # 9o
            fma     $59,$57,$69,$r49_6                  # 10e
            stqd    $r61_3,112($20)                     # 10o
            fnms    $r62_4,$r56_2,$69,$48               # 11e
        a       $r36_2,$29,$36                          # 12e
        a       $34,$27,$36                             # 13e
        lnop                                            # 13o pairing
        a       $35,$28,$36                             # 14e
        lqx     $66,$5,$37                              # 14o
        a       $33,$26,$36                             # 15e
        lqd     $46,0($r36_2)                           # 15o
            fnms    $r63_2,$r57_11,$69,$49              # 16e
        lqd     $r46_6,16($r36_2)                       # 16o
            fnms    $r63_3,$r57_12,$69,$r49_7           # 17e
        lqd     $r46_2,32($r36_2)                       # 17o
            fma     $60,$r57_9,$69,$r50_10              # 18e - i times the other difference
        lqd     $47,96($r36_2)                          # 18o
            fnms    $64,$r57_9,$69,$r50_10              # 19e
        lqd     $r47_6,64($r36_2)                       # 19o
        ai      $22,$22,-1                              # 20e
        lqd     $r47_7,80($r36_2)                       # 20o
            fma     $65,$r56_13,$69,$r51_10             # 21e
        lqd     $r46_7,48($r36_2)                       # 21o
        ai      $25,$25,128                             # 22e
        lqd     $r47_8,112($r36_2)                      # 22o
            fma     $58,$r56_12,$69,$r48_9              # 23e
            lnop                                        # 23o pairing
        fnms    $57,$r46_2,$66,$47                      # 24e
        lqx     $67,$30,$37                             # 24o
        fma     $56,$r47_6,$66,$46                      # 25e
        lqd     $44,32($35)                             # 25o
        fnms    $r57_3,$r46_6,$66,$r47_7                # 26e
        lqd     $45,96($35)                             # 26o
        fma     $r56_2,$r47_7,$66,$r46_6                # 27e
        lqd     $42,16($34)                             # 27o
        fma     $r56_14,$r47_8,$66,$r46_7               # 28e
        lqd     $43,80($34)                             # 28o
        fma     $r56_4,$47,$66,$r46_2                   # 29e
        lqd     $r42_3,32($34)                          # 29o
        fnms    $r57_6,$r46_7,$66,$r47_8                # 30e
        lqd     $r43_7,96($34)                          # 30o
        fnms    $r57_2,$46,$66,$r47_6                   # 31e
        lnop                                            # 31o pairing
        fnms    $r57_13,$44,$66,$45                     # 32e
        lqd     $r44_5,0($35)                           # 32o
        fnms    $54,$r56_2,$67,$42                      # 33e
        lqd     $r45_5,64($35)                          # 33o
        fma     $53,$r57_3,$67,$43                      # 34e
        lqd     $r44_6,16($35)                          # 34o
        fma     $52,$r56_4,$67,$r42_3                   # 35e
        lqd     $r45_6,80($35)                          # 35o
        fnms    $55,$57,$67,$r43_7                      # 36e
        lqd     $r42_9,48($34)                          # 36o
        fma     $r52_10,$r56_2,$67,$42                  # 37e
        lqd     $42,0($34)                              # 37o
        fma     $r53_11,$57,$67,$r43_7                  # 38e
        lqd     $r43_6,64($34)                          # 38o
        fnms    $57,$r44_5,$66,$r45_5                   # 39e
        lnop                                            # 39o pairing
        fma     $r56_15,$r45_5,$66,$r44_5               # 40e
        lqx     $68,$31,$37                             # 40o
        fnms    $r57_5,$r44_6,$66,$r45_6                # 41e
        lqd     $r44_8,48($35)                          # 41o
        fma     $r52_11,$r56_14,$67,$r42_9              # 42e
        lqd     $r45_7,112($35)                         # 42o
        fma     $r52_7,$56,$67,$42                      # 43e
        lqd     $r41_8,96($33)                          # 43o
        fma     $r53_8,$r57_2,$67,$r43_6                # 44e
        lqd     $r41_7,80($33)                          # 44o
        fnms    $r54_8,$56,$67,$42                      # 45e
        lqd     $r40_8,32($33)                          # 45o
        fnms    $r55_8,$r57_2,$67,$r43_6                # 46e
        lqd     $r43_8,112($34)                         # 46o
        fma     $56,$r45_6,$66,$r44_6                   # 47e
            stqd    $63,-8112($21)                      # 47o
        fnms    $r55_4,$r57_3,$67,$43                   # 48e
            stqd    $62,-8160($21)                      # 48o
        fma     $r56_6,$45,$66,$44                      # 49e
            stqd    $59,-8128($20)                      # 49o
        fnms    $r54_9,$r56_4,$67,$r42_3                # 50e
            stqd    $r62_4,-8176($21)                   # 50o
        fma     $r56_5,$r45_7,$66,$r44_8                # 51e
            stqd    $r59_5,-8096($20)                   # 51o
        fnms    $r57_14,$r44_8,$66,$r45_7               # 52e
            stqd    $r63_2,-8096($21)                   # 52o
        fma     $r53_12,$r57_6,$67,$r43_8               # 53e
            stqd    $60,48($20)                         # 53o
        fnms    $r54_11,$r56_14,$67,$r42_9              # 54e
            stqd    $r63_3,-8080($21)                   # 54o
        fnms    $r55_3,$r57_6,$67,$r43_8                # 55e
            stqd    $64,48($21)                         # 55o
        fma     $r49_5,$r57_5,$67,$r41_7                # 56e
            stqd    $65,112($21)                        # 56o
            ai      $21,$21,128                         # 57e
            stqd    $58,-8144($20)                      # 57o
            ai      $20,$20,128                         # 58e
        fnms    $51,$r57_5,$67,$r41_7                   # 59e
        fnms    $r57_7,$r52_10,$68,$53                  # 60e
        lqd     $40,0($33)                              # 60o
        fma     $r48_8,$r56_6,$67,$r40_8                # 61e
        lqd     $r40_9,48($33)                          # 61o
        fma     $49,$r57_13,$67,$r41_8                  # 62e
        lqd     $r41_10,112($33)                        # 62o
        fma     $r56_10,$r53_11,$68,$52                 # 63e
        lnop                                            # 63o pairing
        fnms    $r57_11,$52,$68,$r53_11                 # 64e
        lqd     $r41_11,64($33)                         # 64o
        fnms    $r57_9,$r54_11,$68,$r55_3               # 65e
        fma     $r48_7,$r56_15,$67,$40                  # 66e
        fma     $r48_9,$r56_5,$67,$r40_9                # 67e
        fnms    $r51_10,$r57_14,$67,$r41_10             # 68e
        fnms    $r57_12,$r52_11,$68,$r53_12             # 69e
        fma     $r49_6,$57,$67,$r41_11                  # 70e
        fnms    $r50_11,$r56_15,$67,$40                 # 71e
        fma     $r56_16,$r55_8,$68,$r54_8               # 72e
        fnms    $r57_2,$r54_8,$68,$r55_8                # 73e
        fma     $r56_2,$53,$68,$r52_10                  # 74e
        fnms    $50,$r56_6,$67,$r40_8                   # 75e
        fma     $r56_6,$55,$68,$r54_9                   # 76e
        fnms    $r57_15,$r54_9,$68,$55                  # 77e
        lqd     $r40_10,16($33)                         # 77o
        fma     $r49_7,$r57_14,$67,$r41_10              # 78e
        fma     $r56_13,$r55_3,$68,$r54_11              # 79e
        fnms    $r51_5,$57,$67,$r41_11                  # 80e
        fma     $r56_3,$r53_8,$68,$r52_7                # 81e
        fnms    $57,$r52_7,$68,$r53_8                   # 82e
        fma     $48,$56,$67,$r40_10                     # 83e
        fnms    $r50_12,$56,$67,$r40_10                 # 84e
        lqx     $69,$32,$37                             # 84o
        fma     $56,$r55_4,$68,$54                      # 85e
        fnms    $r57_3,$54,$68,$r55_4                   # 86e
        fnms    $r51_9,$r57_13,$67,$r41_8               # 87e
        fnms    $r50_10,$r56_5,$67,$r40_9               # 88e
        fma     $r56_12,$r53_12,$68,$r52_11             # 89e
        hbrr    stage_line_back,stage_line              # 89o hint
        fma     $r58_7,$r56_3,$69,$r48_7                # 90e
        fnms    $62,$r56_3,$69,$r48_7                   # 91e
        fnms    $61,$r56_16,$69,$r51_5                  # 92e
        fma     $65,$r56_16,$69,$r51_5                  # 93e
        fma     $59,$r57_7,$69,$r49_5                   # 94e
        fnms    $64,$r57_3,$69,$r50_12                  # 95e
        fma     $r65_4,$56,$69,$51                      # 96e
        stqd    $r58_7,-8192($20)                       # 96o
        fma     $r58_7,$r56_10,$69,$r48_8               # 97e
        stqd    $62,-8192($21)                          # 97o
        fma     $60,$r57_15,$69,$50                     # 98e - i times the other difference
        stqd    $61,64($20)                             # 98o
        fnms    $r64_5,$r57_15,$69,$50                  # 99e
        stqd    $65,64($21)                             # 99o
        fma     $65,$r56_6,$69,$r51_9                   # 100e
        stqd    $59,-8112($20)                          # 100o
        fnms    $62,$r56_12,$69,$r48_9                  # 101e
        stqd    $64,16($21)                             # 101o
        fnms    $63,$57,$69,$r49_6                      # 102e
        stqd    $r65_4,80($21)                          # 102o
        fma     $r60_4,$r57_2,$69,$r50_11               # 103e - i times the other difference
        stqd    $r58_7,-8160($20)                       # 103o
        fnms    $64,$r57_2,$69,$r50_11                  # 104e
        stqd    $60,32($20)                             # 104o
        fma     $r58_6,$r56_2,$69,$48                   # 105e
        stqd    $r64_5,32($21)                          # 105o
        fma     $60,$r57_3,$69,$r50_12                  # 106e - i times the other difference
stage_line_back:
        brnz    $22,stage_line                          # 106o
stage_line_drain:
        fnms    $61,$56,$69,$51                         # 0e
        stqd    $65,96($21)                             # 0o
        fma     $59,$r57_12,$69,$r49_7                  # 1e
        stqd    $62,-8144($21)                          # 1o
        fnms    $r61_2,$r56_6,$69,$r51_9                # 2e
        stqd    $63,-8128($21)                          # 2o
        fnms    $r61_4,$r56_13,$69,$r51_10              # 3e
        stqd    $r60_4,0($20)                           # 3o
        fnms    $63,$r57_7,$69,$r49_5                   # 4e
        stqd    $64,0($21)                              # 4o
        fnms    $62,$r56_10,$69,$r48_8                  # 5e
        stqd    $r58_6,-8176($20)                       # 5o
        fma     $r59_6,$57,$69,$r49_6                   # 6e
        stqd    $60,16($20)                             # 6o
        fnms    $r62_5,$r56_2,$69,$48                   # 7e
        hbr     stage_return,$lr                        # 7o hint
        fma     $r59_2,$r57_11,$69,$49                  # 8e
        stqd    $61,80($20)                             # 8o
        fnms    $r63_4,$r57_11,$69,$49                  # 9e
        stqd    $59,-8080($20)                          # 9o
        fma     $60,$r57_9,$69,$r50_10                  # 10e - i times the other difference
        stqd    $r61_2,96($20)                          # 10o
        fnms    $r63_3,$r57_12,$69,$r49_7               # 11e
        stqd    $r61_4,112($20)                         # 11o
        fnms    $64,$r57_9,$69,$r50_10                  # 12e
        stqd    $63,-8112($21)                          # 12o
        fma     $65,$r56_13,$69,$r51_10                 # 13e
        stqd    $62,-8160($21)                          # 13o
        fma     $58,$r56_12,$69,$r48_9                  # 14e
        stqd    $r59_6,-8128($20)                       # 14o
        ai      $r21_3,$21,128                          # 15e
        stqd    $r62_5,-8176($21)                       # 15o
        ai      $r20_3,$20,128                          # 16e
        stqd    $r59_2,-8096($20)                       # 16o
        stqd    $r63_4,-8096($21)                       # 17o
        stqd    $60,48($20)                             # 18o
        stqd    $r63_3,-8080($21)                       # 19o
        stqd    $64,48($21)                             # 20o
        stqd    $65,112($21)                            # 21o
        stqd    $58,-8144($20)                          # 22o
        nop     $127                                    # 23e pairing
stage_return:
        bi      $lr                                     # 23o
stage_line_short:
        and     $37,$25,$23                             # 0e
        ai      $22,$22,-1                              # 1e
        mpya    $36,$37,$24,$25                         # 2e
        rotm    $37,$37,$7                              # 3e
        ai      $25,$25,128                             # 4e
        lqx     $66,$5,$37                              # 7o
        nop     $127                                    # 8e pairing
        lqx     $67,$30,$37                             # 8o
        a       $r36_3,$29,$36                          # 9e
        lqx     $68,$31,$37                             # 9o
        a       $34,$27,$36                             # 10e
        lqx     $69,$32,$37                             # 10o
        a       $35,$28,$36                             # 11e
        lqd     $47,64($r36_3)                          # 11o
        a       $33,$26,$36                             # 12e
        lqd     $46,0($r36_3)                           # 12o
        lqd     $r47_8,80($r36_3)                       # 13o
        lqd     $r46_8,16($r36_3)                       # 14o
        lqd     $44,16($35)                             # 15o
        lqd     $45,80($35)                             # 16o
        nop     $127                                    # 17e pairing
        lqd     $42,16($34)                             # 17o
        fma     $56,$47,$66,$46                         # 18e
        lqd     $43,64($34)                             # 18o
        fnms    $57,$46,$66,$47                         # 19e
        lqd     $r45_2,64($35)                          # 19o
        fnms    $r57_16,$r46_8,$66,$r47_8               # 20e
        lqd     $r42_10,0($34)                          # 20o
        fma     $r56_17,$r47_8,$66,$r46_8               # 21e
        lqd     $r44_9,0($35)                           # 21o
        fnms    $r57_15,$44,$66,$45                     # 22e
        lqd     $r43_9,80($34)                          # 22o
        fma     $r56_14,$45,$66,$44                     # 23e
        lqd     $46,32($r36_3)                          # 23o
        nop     $127                                    # 24e pairing
        lqd     $40,0($33)                              # 24o
        fma     $53,$57,$67,$43                         # 25e
        lqd     $41,64($33)                             # 25o
        fma     $52,$56,$67,$r42_10                     # 26e
        lqd     $r41_12,80($33)                         # 26o
        fnms    $54,$r56_17,$67,$42                     # 27e
        lqd     $r40_11,16($33)                         # 27o
        fnms    $r57_7,$r44_9,$66,$r45_2                # 28e
        lqd     $r46_9,48($r36_3)                       # 28o
        fma     $r52_12,$r56_17,$67,$42                 # 29e
        lqd     $47,112($r36_3)                         # 29o
        fnms    $55,$r57_16,$67,$r43_9                  # 30e
        lqd     $r47_9,96($r36_3)                       # 30o
        fnms    $r54_12,$56,$67,$r42_10                 # 31e
        lqd     $44,48($35)                             # 31o
        fnms    $r55_9,$57,$67,$43                      # 32e
        lqd     $43,96($34)                             # 32o
        fma     $56,$r45_2,$66,$r44_9                   # 33e
        lqd     $45,112($35)                            # 33o
        fma     $r53_13,$r57_16,$67,$r43_9              # 34e
        lqd     $42,32($34)                             # 34o
        fma     $49,$r57_15,$67,$r41_12                 # 35e
        lqd     $r44_10,32($35)                         # 35o
        fnms    $57,$54,$68,$55                         # 36e
        lqd     $r42_2,48($34)                          # 36o
        fnms    $51,$r57_7,$67,$41                      # 37e
        lqd     $r43_9,112($34)                         # 37o
        fma     $48,$r56_14,$67,$r40_11                 # 38e
        lqd     $r45_5,96($35)                          # 38o
        fma     $r48_10,$56,$67,$40                     # 39e
        lqd     $r40_9,48($33)                          # 39o
        fma     $r56_18,$r53_13,$68,$r52_12             # 40e
        lqd     $r40_12,32($33)                         # 40o
        fma     $r56_19,$55,$68,$54                     # 41e
        lqd     $r41_13,96($33)                         # 41o
        fnms    $r51_4,$r57_15,$67,$r41_12              # 42e
        lqd     $r41_12,112($33)                        # 42o
        fma     $r49_8,$r57_7,$67,$41                   # 43e
        fma     $r56_20,$53,$68,$52                     # 44e
        fnms    $r57_9,$r54_12,$68,$r55_9               # 45e
        fnms    $50,$r56_14,$67,$r40_11                 # 46e
        fnms    $r57_6,$r52_12,$68,$r53_13              # 47e
        fnms    $r57_14,$r46_9,$66,$47                  # 48e
        fma     $r56_21,$r55_9,$68,$r54_12              # 49e
        fnms    $r50_12,$56,$67,$40                     # 50e
        fnms    $r57_3,$52,$68,$53                      # 51e
        fnms    $64,$57,$69,$50                         # 52e
        fnms    $r57_17,$46,$66,$r47_9                  # 53e
        fma     $59,$r57_6,$69,$49                      # 54e
        fma     $60,$57,$69,$50                         # 55e - i times the other difference
        fma     $r60_5,$r57_9,$69,$r50_12               # 56e - i times the other difference
        fnms    $r64_6,$r57_9,$69,$r50_12               # 57e
        lnop                                            # 57o pairing
        fnms    $63,$r57_3,$69,$r49_8                   # 58e
        stqd    $64,16($21)                             # 58o
        fma     $56,$r47_9,$66,$46                      # 59e
        lnop                                            # 59o pairing
        fma     $r56_5,$47,$66,$r46_9                   # 60e
        stqd    $59,-8112($20)                          # 60o
        fnms    $55,$r57_14,$67,$r43_9                  # 61e
        stqd    $60,16($20)                             # 61o
        fma     $58,$r56_18,$69,$48                     # 62e
        stqd    $r60_5,0($20)                           # 62o
        fnms    $62,$r56_18,$69,$48                     # 63e
        stqd    $r64_6,0($21)                           # 63o
        fnms    $61,$r56_19,$69,$r51_4                  # 64e
        stqd    $63,-8128($21)                          # 64o
        fma     $r56_14,$r45_5,$66,$r44_10              # 65e
        fnms    $54,$r56_5,$67,$r42_2                   # 66e
        fma     $r58_8,$r56_20,$69,$r48_10              # 67e
        lnop                                            # 67o pairing
        fma     $59,$r57_3,$69,$r49_8                   # 68e
        stqd    $58,-8176($20)                          # 68o
        fnms    $r62_6,$r56_20,$69,$r48_10              # 69e
        stqd    $62,-8176($21)                          # 69o
        fnms    $r61_5,$r56_21,$69,$51                  # 70e
        stqd    $61,80($20)                             # 70o
        fma     $65,$r56_21,$69,$51                     # 71e
        fnms    $63,$r57_6,$69,$49                      # 72e
        fma     $r65_4,$r56_19,$69,$r51_4               # 73e
        stqd    $r58_8,-8192($20)                       # 73o
        fnms    $r54_12,$56,$67,$42                     # 74e
        stqd    $59,-8128($20)                          # 74o
        fnms    $57,$44,$66,$45                         # 75e
        stqd    $r62_6,-8192($21)                       # 75o
        fma     $52,$r56_5,$67,$r42_2                   # 76e
        stqd    $r61_5,64($20)                          # 76o
        fnms    $r57_18,$r44_10,$66,$r45_5              # 77e
        stqd    $65,64($21)                             # 77o
        fnms    $r55_10,$r57_17,$67,$43                 # 78e
        stqd    $63,-8112($21)                          # 78o
        fma     $r52_10,$56,$67,$42                     # 79e
        stqd    $r65_4,80($21)                          # 79o
        fma     $53,$r57_17,$67,$43                     # 80e
        hbrr    stage_line_short_back,stage_line_short  # 80o hint
        fma     $56,$45,$66,$44                         # 81e
        fma     $r53_14,$r57_14,$67,$r43_9              # 82e
        fnms    $r57_14,$54,$68,$55                     # 83e
        fma     $r56_4,$55,$68,$54                      # 84e
        fnms    $51,$57,$67,$r41_12                     # 85e
        fnms    $r57_2,$r54_12,$68,$r55_10              # 86e
        fma     $48,$56,$67,$r40_9                      # 87e
        fnms    $50,$56,$67,$r40_9                      # 88e
        fnms    $r57_3,$52,$68,$r53_14                  # 89e
        fma     $r48_11,$r56_14,$67,$r40_12             # 90e
        fma     $49,$r57_18,$67,$r41_13                 # 91e
        fnms    $r51_11,$r57_18,$67,$r41_13             # 92e
        fma     $56,$53,$68,$r52_10                     # 93e
        fnms    $r57_16,$r52_10,$68,$53                 # 94e
        fma     $r56_22,$r55_10,$68,$r54_12             # 95e
        fma     $r49_5,$57,$67,$r41_12                  # 96e
        fnms    $r50_12,$r56_14,$67,$r40_12             # 97e
        fma     $r56_17,$r53_14,$68,$52                 # 98e
        fma     $60,$r57_14,$69,$50                     # 99e - i times the other difference
        fnms    $64,$r57_14,$69,$50                     # 100e
        fma     $65,$r56_4,$69,$51                      # 101e
        fnms    $63,$r57_3,$69,$r49_5                   # 102e
        fnms    $r64_5,$r57_2,$69,$r50_12               # 103e
        fma     $58,$56,$69,$r48_11                     # 104e
        fma     $59,$r57_16,$69,$49                     # 105e
        stqd    $60,48($20)                             # 105o
        fma     $r58_9,$r56_17,$69,$48                  # 106e
        stqd    $64,48($21)                             # 106o
        fnms    $62,$56,$69,$r48_11                     # 107e
        stqd    $65,112($21)                            # 107o
        fnms    $r63_5,$r57_16,$69,$49                  # 108e
        stqd    $63,-8080($21)                          # 108o
        fma     $r59_7,$r57_3,$69,$r49_5                # 109e
        stqd    $r64_5,32($21)                          # 109o
        fma     $60,$r57_2,$69,$r50_12                  # 110e - i times the other difference
        stqd    $58,-8160($20)                          # 110o
        fnms    $61,$r56_22,$69,$r51_11                 # 111e
        stqd    $59,-8096($20)                          # 111o
        fma     $65,$r56_22,$69,$r51_11                 # 112e
        stqd    $r58_9,-8144($20)                       # 112o
        fnms    $r62_4,$r56_17,$69,$48                  # 113e
        stqd    $62,-8160($21)                          # 113o
        fnms    $r61_3,$r56_4,$69,$51                   # 114e
        stqd    $r63_5,-8096($21)                       # 114o
        stqd    $r59_7,-8080($20)                       # 115o
        stqd    $60,32($20)                             # 116o
        stqd    $61,96($20)                             # 117o
        stqd    $65,96($21)                             # 118o
        nop     $127                                    # 119e pairing
        stqd    $r62_4,-8144($21)                       # 119o
        ai      $21,$21,128                             # 120e
        stqd    $r61_3,112($20)                         # 120o
        ai      $20,$20,128                             # 121e
stage_line_short_back:
        brnz    $22,stage_line_short                    # 121o
        nop     $127                                    # 122e pairing
        bi      $lr                                     # 122o
        .size   stage, .-stage

# turn_NAME   multiplies four lines at a time by twiddle factors, and transposes them
#   In      $3 lines, $4 where columns go, $5 fine factors: a line for each line; $6 coarse factors:
#           two quadwords for four lines, their real and imaginary parts; $7 how many times four
#           lines
#   Out     nothing
#   Twin    examples/fft/src/twin.rs, turn
#
# The factor of a number is the product of its fine one and its line's coarse one. The 16 numbers of
# a line go to 16 lines, `column` bytes apart; lines are `line` bytes apart.
        .set    fine, 5
        .set    coarse, 6
        .set    place, 23
        .set    row, 24
        .set    column_low, 25
        .set    column_high, 26
        .set    to_low, 27
        .set    to_high, 28
        .set    m_first, 29
        .set    m_last, 30
        .set    m_word, 31                      # to 34: copies of word 0 to 3
        .set    coarse_r, 35
        .set    coarse_i, 36
        .set    copy_r, 37                     # to 40
        .set    copy_i, 41                     # to 44
        .set    xr, 45
        .set    xi, 46
        .set    fr, 47
        .set    fi, 48
        .set    hr, 49
        .set    hi, 50
        .set    zr, 51                          # to 54
        .set    zi, 55                          # to 58
        .set    s0, 59
        .set    s1, 60
        .set    s2, 61
        .set    s3, 62
        .set    d0, 63
        .set    d1, 64
        .set    d2, 65
        .set    d3, 66
        .set    lines, 67
        .set    fine_lines, 68

# Transposes the four registers from z on, and stores them in the columns 4 q to 4 q + 3.
        .macro  put_columns z:req, q:req, pointer:req, first:req, column:req, part:req
        shufb   $s0,$\z,$\z+2,$m_first
        shufb   $s1,$\z+1,$\z+3,$m_first
        shufb   $s2,$\z,$\z+2,$m_last
        shufb   $s3,$\z+1,$\z+3,$m_last
        shufb   $d0,$s0,$s1,$m_first
        shufb   $d1,$s0,$s1,$m_last
        shufb   $d2,$s2,$s3,$m_first
        shufb   $d3,$s2,$s3,$m_last
        stqd    $d0,(\first)*\column+\part($\pointer)
        stqd    $d1,(\first+1)*\column+\part($\pointer)
        stqd    $d2,(\first+2)*\column+\part($\pointer)
        stqd    $d3,(\first+3)*\column+\part($\pointer)
        .endm

        .macro  turn_constants line:req, column:req
        lqa     $m_first,turn_shuffles
        lqa     $m_last,turn_shuffles+16
        .irp    word, 0,1,2,3
        lqa     $m_word+\word,turn_shuffles+32+16*\word
        .endr
        ila     $column_low,4*\column
        ila     $column_high,12*\column
        a       $column_low,$column_low,$4
        a       $column_high,$column_high,$4
        il      $lines,4*\line
        il      $fine_lines,4*128
        ori     $left,$7,0
        il      $place,0
        .endm

        .macro  turn_lines line:req, column:req
        andi    $row,$place,-64                 # 16 lines of 128 bytes, four at a time
        a       $row,$row,$place
        a       $to_low,$column_low,$row
        a       $to_high,$column_high,$row
        lqd     $coarse_r,0($coarse)
        lqd     $coarse_i,16($coarse)
        .irp    l, 0,1,2,3
        shufb   $copy_r+\l,$coarse_r,$coarse_r,$m_word+\l
        shufb   $copy_i+\l,$coarse_i,$coarse_i,$m_word+\l
        .endr
        .irp    q, 0,1,2,3
        .irp    l, 0,1,2,3
        lqd     $xr,\l*\line+16*\q($3)
        lqd     $xi,\l*\line+16*\q+IMAGINARY($3)
        lqd     $fr,\l*128+16*\q($fine)
        lqd     $fi,\l*128+16*\q+IMAGINARY($fine)
        fm      $hr,$fi,$copy_i+\l
        fm      $hi,$fi,$copy_r+\l
        fms     $hr,$fr,$copy_r+\l,$hr
        fma     $hi,$fr,$copy_i+\l,$hi
        fm      $zr+\l,$xi,$hi
        fm      $zi+\l,$xi,$hr
        fms     $zr+\l,$xr,$hr,$zr+\l
        fma     $zi+\l,$xr,$hi,$zi+\l
        .endr
        .if     \q<2
        put_columns zr, \q, to_low, 4*\q-4, \column, 0
        put_columns zi, \q, to_low, 4*\q-4, \column, IMAGINARY
        .else
        put_columns zr, \q, to_high, 4*\q-12, \column, 0
        put_columns zi, \q, to_high, 4*\q-12, \column, IMAGINARY
        .endif
        .endr
        a       $3,$3,$lines
        a       $fine,$fine,$fine_lines
        ai      $coarse,$coarse,32
        ai      $place,$place,16
        ai      $left,$left,-1
        .endm

# 16 columns of 256 lines, which become 16 rows of 16 lines.
        .align  3
        .global turn_batch
        .type   turn_batch, @function
turn_batch:
        .set r45_8,2; .set r45_9,8; .set r48_12,10; .set r45_10,11; .set r46_10,12; .set r47_10,13
        .set r45_11,17; .set r49_9,18; .set r50_13,10; .set r47_11,19; .set r46_11,14
        .set r49_10,16; .set r45_12,20; .set r49_11,21; .set r46_12,24; .set r50_14,15
        .set r48_13,35; .set r45_13,4; .set r46_13,36; .set r48_14,54; .set r45_14,15
        .set r46_14,50; .set r47_12,49; .set r49_12,59; .set r48_15,60; .set r50_15,48
        .set r45_15,61; .set r49_13,62; .set r59_8,63; .set r50_16,18; .set r59_9,64; .set r61_6,13
        .set r54_13,11; .set r61_7,12; .set r46_15,51; .set r50_17,19; .set r47_13,48
        .set r49_14,53; .set r48_16,55; .set r50_18,7; .set r49_15,57; .set r60_6,59
        .set r50_19,35; .set r60_7,62; .set r55_11,65; .set r62_7,11; .set r51_12,46; .set r62_8,52
        .set r63_6,58; .set r52_13,14; .set r63_7,66; .set r65_5,47; .set r55_12,19; .set r66_2,11
        .set r51_13,13; .set r52_14,7; .set r49_16,11; .set r49_17,12; .set r50_20,9
        .set r48_17,17; .set r49_18,10; .set r50_21,20; .set r59_10,21; .set r61_8,14
        .set r51_14,35; .set r47_14,36; .set r48_18,50; .set r45_16,49; .set r47_15,4
        .set r55_13,2; .set r48_19,11; .set r51_15,12; .set r46_16,35; .set r47_16,16
        .set r50_22,55; .set r60_8,57; .set r62_9,7; .set r62_10,54; .set r49_19,20; .set r45_17,7
        .set r50_23,11; .set r60_9,8; .set r49_20,4; .set r60_10,7; .set r62_11,8
        ila     $25,0x2000                              # 0e
        lqa     $29,turn_shuffles                       # 0o
        ila     $26,0x6000                              # 1e
        lqa     $30,turn_shuffles+16                    # 1o
        a       $25,$25,$4                              # 2e
        lqa     $31,turn_shuffles+32                    # 2o
        a       $26,$26,$4                              # 3e
        lqa     $32,turn_shuffles+48                    # 3o
        il      $67,512                                 # 4e
        lqa     $33,turn_shuffles+64                    # 4o
        il      $68,512                                 # 5e
        lqa     $34,turn_shuffles+80                    # 5o
        ori     $22,$7,0                                # 6e
        il      $23,0                                   # 7e
batch_lines:
        andi    $24,$23,-64                             # 0e
        lqd     $35,0($6)                               # 0o
        ai      $22,$22,-1                              # 1e
        lqd     $36,16($6)                              # 1o
        a       $24,$24,$23                             # 2e
        lqd     $45,0($3)                               # 2o
        ai      $6,$6,32                                # 3e
        lqd     $46,64($3)                              # 3o
        a       $27,$25,$24                             # 4e
        lqd     $47,0($5)                               # 4o
        a       $28,$26,$24                             # 5e
        lqd     $48,64($5)                              # 5o
        ai      $23,$23,16                              # 6e
        shufb   $37,$35,$35,$31                         # 6o
        shufb   $41,$36,$36,$31                         # 7o
        shufb   $38,$35,$35,$32                         # 8o
        shufb   $42,$36,$36,$32                         # 9o
        shufb   $39,$35,$35,$33                         # 10o
        fm      $49,$48,$41                             # 11e
        shufb   $43,$36,$36,$33                         # 11o
        fm      $50,$48,$37                             # 12e
        shufb   $40,$35,$35,$34                         # 12o
        shufb   $44,$36,$36,$34                         # 13o
        lqd     $r45_8,128($3)                          # 14o
        lqd     $r46_8,192($3)                          # 15o
        lqd     $r47_5,128($5)                          # 16o
        fms     $49,$47,$37,$49                         # 17e
        lqd     $48,192($5)                             # 17o
        fma     $50,$47,$41,$50                         # 18e
        lqd     $r45_9,256($3)                          # 18o
        lqd     $r46_3,320($3)                          # 19o
        lqd     $47,256($5)                             # 20o
        lqd     $r48_12,320($5)                         # 21o
        lqd     $r45_10,384($3)                         # 22o
        fm      $55,$46,$49                             # 23e
        lqd     $r46_10,448($3)                         # 23o
        fm      $51,$46,$50                             # 24e
        lqd     $r47_10,384($5)                         # 24o
        fm      $r49_3,$48,$42                          # 25e
        lqd     $r48_11,448($5)                         # 25o
        fm      $r50_6,$48,$38                          # 26e
        lqd     $r45_11,16($3)                          # 26o
        fm      $r49_9,$r48_12,$43                      # 27e
        lqd     $46,80($3)                              # 27o
        fm      $r50_13,$r48_12,$39                     # 28e
        lqd     $r47_11,16($5)                          # 28o
        fma     $55,$45,$50,$55                         # 29e
        lqd     $48,80($5)                              # 29o
        fms     $51,$45,$49,$51                         # 30e
        lqd     $45,144($3)                             # 30o
        fms     $49,$r47_5,$38,$r49_3                   # 31e
        lqd     $r46_11,208($3)                         # 31o
        fma     $50,$r47_5,$42,$r50_6                   # 32e
        lqd     $r47_5,144($5)                          # 32o
        fms     $r49_10,$47,$39,$r49_9                  # 33e
        lqd     $r48_8,208($5)                          # 33o
        fma     $r50_13,$47,$43,$r50_13                 # 34e
        lqd     $r45_12,272($3)                         # 34o
        fm      $r49_11,$r48_11,$44                     # 35e
        lqd     $r46_12,336($3)                         # 35o
        fm      $r50_14,$r48_11,$40                     # 36e
        lqd     $47,272($5)                             # 36o
        fm      $56,$r46_8,$49                          # 37e
        lqd     $r48_13,336($5)                         # 37o
        fm      $52,$r46_8,$50                          # 38e
        lqd     $r45_13,400($3)                         # 38o
        fm      $57,$r46_3,$r49_10                      # 39e
        lqd     $r46_13,464($3)                         # 39o
        fm      $53,$r46_3,$r50_13                      # 40e
        lqd     $r47_4,400($5)                          # 40o
        fms     $r49_11,$r47_10,$40,$r49_11             # 41e
        lqd     $r48_14,464($5)                         # 41o
        fma     $r50_4,$r47_10,$44,$r50_14              # 42e
        lqd     $r45_14,32($3)                          # 42o
        fma     $56,$r45_8,$50,$56                      # 43e
        lqd     $r46_14,96($3)                          # 43o
        fms     $52,$r45_8,$49,$52                      # 44e
        lqd     $r47_9,32($5)                           # 44o
        fma     $57,$r45_9,$r50_13,$57                  # 45e
        lqd     $r48_12,96($5)                          # 45o
        fms     $53,$r45_9,$r49_10,$53                  # 46e
        lqd     $r45_9,160($3)                          # 46o
        fm      $58,$r46_10,$r49_11                     # 47e
        lqd     $r46_9,224($3)                          # 47o
        fm      $r54_11,$r46_10,$r50_4                  # 48e
        lqd     $r47_12,160($5)                         # 48o
        fm      $r49_12,$48,$41                         # 49e
        lqd     $r48_15,224($5)                         # 49o
        fm      $r50_15,$48,$37                         # 50e
        lqd     $r45_15,288($3)                         # 50o
        fm      $r49_13,$r48_8,$42                      # 51e
        shufb   $r59_8,$55,$57,$29                      # 51o
        fm      $r50_16,$r48_8,$38                      # 52e
        shufb   $r59_9,$51,$53,$29                      # 52o
        fma     $58,$r45_10,$r50_4,$58                  # 53e
        shufb   $r61_6,$51,$53,$30                      # 53o
        fms     $r54_13,$r45_10,$r49_11,$r54_11         # 54e
        shufb   $r61_7,$55,$57,$30                      # 54o
        fms     $r49_11,$r47_11,$37,$r49_12             # 55e
        lqd     $r46_15,352($3)                         # 55o
        fma     $r50_17,$r47_11,$41,$r50_15             # 56e
        lqd     $r47_13,288($5)                         # 56o
        fms     $r49_14,$r47_5,$38,$r49_13              # 57e
        lqd     $r48_16,352($5)                         # 57o
        fma     $r50_18,$r47_5,$42,$r50_16              # 58e
        lqd     $r45_5,416($3)                          # 58o
        fm      $r49_15,$r48_13,$43                     # 59e
        shufb   $r60_6,$56,$58,$29                      # 59o
        fm      $r50_19,$r48_13,$39                     # 60e
        shufb   $r60_7,$52,$r54_13,$29                  # 60o
        fm      $r55_11,$46,$r49_11                     # 61e
        shufb   $r62_7,$52,$r54_13,$30                  # 61o
        fm      $r51_12,$46,$r50_17                     # 62e
        shufb   $r62_8,$56,$58,$30                      # 62o
        fm      $56,$r46_11,$r49_14                     # 63e
        shufb   $r63_6,$r59_8,$r60_6,$29                # 63o
        fm      $r52_13,$r46_11,$r50_18                 # 64e
        shufb   $r63_7,$r59_9,$r60_7,$29                # 64o
        fms     $r49_15,$47,$39,$r49_15                 # 65e
        shufb   $64,$r59_9,$r60_7,$30                   # 65o
        fma     $r50_19,$47,$43,$r50_19                 # 66e
        shufb   $r65_5,$r61_6,$r62_7,$29                # 66o
        fma     $r55_12,$r45_11,$r50_17,$r55_11         # 67e
        shufb   $r66_2,$r61_6,$r62_7,$30                # 67o
        fms     $r51_13,$r45_11,$r49_11,$r51_12         # 68e
        stqd    $r63_7,-8192($27)                       # 68o
        fma     $56,$45,$r50_18,$56                     # 69e
        stqd    $64,-6144($27)                          # 69o
        fms     $r52_14,$45,$r49_14,$r52_13             # 70e
        stqd    $r65_5,-4096($27)                       # 70o
        fm      $r57_3,$r46_12,$r49_15                  # 71e
        stqd    $r66_2,-2048($27)                       # 71o
        fm      $53,$r46_12,$r50_19                     # 72e
        shufb   $64,$r59_8,$r60_6,$30                   # 72o
        fm      $r49_16,$r48_14,$44                     # 73e
        shufb   $65,$r61_7,$r62_8,$29                   # 73o
        fm      $r50_11,$r48_14,$40                     # 74e
        shufb   $66,$r61_7,$r62_8,$30                   # 74o
        fm      $r49_17,$r48_12,$41                     # 75e
        stqd    $r63_6,-8128($27)                       # 75o
        fm      $r50_13,$r48_12,$37                     # 76e
        stqd    $64,-6080($27)                          # 76o
        fma     $r57_3,$r45_12,$r50_19,$r57_3           # 77e
        stqd    $65,-4032($27)                          # 77o
        fms     $53,$r45_12,$r49_15,$53                 # 78e
        stqd    $66,-1984($27)                          # 78o
        fms     $r49_16,$r47_4,$40,$r49_16              # 79e
        lqd     $46,480($3)                             # 79o
        fma     $r50_20,$r47_4,$44,$r50_11              # 80e
        lqd     $47,416($5)                             # 80o
        fms     $r49_17,$r47_9,$37,$r49_17              # 81e
        lqd     $r48_17,480($5)                         # 81o
        fma     $r50_5,$r47_9,$41,$r50_13               # 82e
        lqd     $45,48($3)                              # 82o
        fm      $r49_18,$r48_15,$42                     # 83e
        shufb   $59,$r55_12,$r57_3,$29                  # 83o
        fm      $r50_21,$r48_15,$38                     # 84e
        shufb   $r59_10,$r51_13,$53,$29                 # 84o
        fm      $58,$r46_13,$r49_16                     # 85e
        shufb   $r61_6,$r51_13,$53,$30                  # 85o
        fm      $54,$r46_13,$r50_20                     # 86e
        shufb   $r61_8,$r55_12,$r57_3,$30               # 86o
        fm      $r55_12,$r46_14,$r49_17                 # 87e
        lqd     $r46_12,112($3)                         # 87o
        fm      $r51_14,$r46_14,$r50_5                  # 88e
        lqd     $r47_14,48($5)                          # 88o
        fms     $r49_18,$r47_12,$38,$r49_18             # 89e
        lqd     $r48_18,112($5)                         # 89o
        fma     $r50_21,$r47_12,$42,$r50_21             # 90e
        lqd     $r45_16,176($3)                         # 90o
        fma     $58,$r45_13,$r50_20,$58                 # 91e
        lqd     $r46_3,240($3)                          # 91o
        fms     $54,$r45_13,$r49_16,$54                 # 92e
        lqd     $r47_15,176($5)                         # 92o
        fma     $r55_13,$r45_14,$r50_5,$r55_12          # 93e
        lqd     $r48_19,240($5)                         # 93o
        fms     $r51_15,$r45_14,$r49_17,$r51_14         # 94e
        lqd     $r45_14,304($3)                         # 94o
        fm      $r56_6,$r46_9,$r49_18                   # 95e
        lqd     $r46_16,368($3)                         # 95o
        fm      $52,$r46_9,$r50_21                      # 96e
        lqd     $r47_16,304($5)                         # 96o
        fm      $r49_14,$r48_16,$43                     # 97e
        shufb   $60,$56,$58,$29                         # 97o
        fm      $r50_22,$r48_16,$39                     # 98e
        shufb   $r60_8,$r52_14,$54,$29                  # 98o
        fm      $r49_13,$r48_17,$44                     # 99e
        shufb   $r62_9,$r52_14,$54,$30                  # 99o
        fm      $r50_11,$r48_17,$40                     # 100e
        shufb   $r62_10,$56,$58,$30                     # 100o
        fma     $56,$r45_9,$r50_21,$r56_6               # 101e
        shufb   $63,$59,$60,$29                         # 101o
        fms     $52,$r45_9,$r49_18,$52                  # 102e
        shufb   $r63_5,$r59_10,$r60_8,$29               # 102o
        fms     $r49_18,$r47_13,$39,$r49_14             # 103e
        shufb   $64,$r59_10,$r60_8,$30                  # 103o
        fma     $r50_17,$r47_13,$43,$r50_22             # 104e
        shufb   $65,$r61_6,$r62_9,$29                   # 104o
        fms     $r49_19,$47,$40,$r49_13                 # 105e
        shufb   $66,$r61_6,$r62_9,$30                   # 105o
        fma     $r50_18,$47,$44,$r50_11                 # 106e
        stqd    $r63_5,0($27)                           # 106o
        fm      $r49_4,$r48_18,$41                      # 107e
        stqd    $64,0x800($27)                          # 107o
        fm      $50,$r48_18,$37                         # 108e
        stqd    $65,0x1000($27)                         # 108o
        fm      $57,$r46_15,$r49_18                     # 109e
        stqd    $66,0x1800($27)                         # 109o
        fm      $53,$r46_15,$r50_17                     # 110e
        shufb   $64,$59,$60,$30                         # 110o
        fm      $58,$46,$r49_19                         # 111e
        shufb   $65,$r61_8,$r62_10,$29                  # 111o
        fm      $r54_7,$46,$r50_18                      # 112e
        shufb   $66,$r61_8,$r62_10,$30                  # 112o
        fms     $r49_4,$r47_14,$37,$r49_4               # 113e
        stqd    $63,64($27)                             # 113o
        fma     $50,$r47_14,$41,$50                     # 114e
        stqd    $64,0x840($27)                          # 114o
        fma     $57,$r45_15,$r50_17,$57                 # 115e
        stqd    $65,0x1040($27)                         # 115o
        fms     $53,$r45_15,$r49_18,$53                 # 116e
        stqd    $66,0x1840($27)                         # 116o
        fma     $58,$r45_5,$r50_18,$58                  # 117e
        lqd     $48,368($5)                             # 117o
        fms     $54,$r45_5,$r49_19,$r54_7               # 118e
        lqd     $r45_17,432($3)                         # 118o
        fm      $55,$r46_12,$r49_4                      # 119e
        lqd     $46,496($3)                             # 119o
        fm      $51,$r46_12,$50                         # 120e
        lqd     $47,432($5)                             # 120o
        fm      $r49_18,$r48_19,$42                     # 121e
        shufb   $59,$r55_13,$57,$29                     # 121o
        fm      $r50_23,$r48_19,$38                     # 122e
        shufb   $r59_4,$r51_15,$53,$29                  # 122o
        fm      $r49_3,$48,$43                          # 123e
        shufb   $61,$r51_15,$53,$30                     # 123o
        fm      $r50_12,$48,$39                         # 124e
        shufb   $60,$52,$54,$29                         # 124o
        fma     $55,$45,$50,$55                         # 125e
        shufb   $62,$52,$54,$30                         # 125o
        fms     $51,$45,$r49_4,$51                      # 126e
        shufb   $r60_9,$56,$58,$29                      # 126o
        fms     $r49_18,$r47_15,$38,$r49_18             # 127e
        shufb   $r61_2,$r55_13,$57,$30                  # 127o
        fma     $50,$r47_15,$42,$r50_23                 # 128e
        shufb   $63,$r59_4,$60,$29                      # 128o
        fms     $r49_20,$r47_16,$39,$r49_3              # 129e
        shufb   $64,$r59_4,$60,$30                      # 129o
        fma     $r50_23,$r47_16,$43,$r50_12             # 130e
        shufb   $65,$61,$62,$29                         # 130o
        a       $3,$3,$67                               # 131e
        shufb   $66,$61,$62,$30                         # 131o
        nop     $127                                    # 132e pairing
        stqd    $63,-8192($28)                          # 132o
        fm      $r56_14,$r46_3,$r49_18                  # 133e
        stqd    $64,-6144($28)                          # 133o
        fm      $52,$r46_3,$50                          # 134e
        stqd    $65,-4096($28)                          # 134o
        fm      $57,$r46_16,$r49_20                     # 135e
        stqd    $66,-2048($28)                          # 135o
        fm      $53,$r46_16,$r50_23                     # 136e
        shufb   $62,$56,$58,$30                         # 136o
        shufb   $63,$59,$r60_9,$29                      # 137o
        shufb   $64,$59,$r60_9,$30                      # 138o
        fma     $56,$r45_16,$50,$r56_14                 # 139e
        lqd     $48,496($5)                             # 139o
        fms     $52,$r45_16,$r49_18,$52                 # 140e
        shufb   $65,$r61_2,$62,$29                      # 140o
        fma     $57,$r45_14,$r50_23,$57                 # 141e
        shufb   $66,$r61_2,$62,$30                      # 141o
        fms     $53,$r45_14,$r49_20,$53                 # 142e
        stqd    $63,-8128($28)                          # 142o
        a       $5,$5,$68                               # 143e
        stqd    $64,-6080($28)                          # 143o
        nop     $127                                    # 144e pairing
        stqd    $65,-4032($28)                          # 144o
        fm      $49,$48,$44                             # 145e
        stqd    $66,-1984($28)                          # 145o
        fm      $50,$48,$40                             # 146e
        hbrr    batch_lines_back,batch_lines            # 146o hint
        shufb   $59,$55,$57,$29                         # 147o
        shufb   $r59_3,$51,$53,$29                      # 148o
        shufb   $61,$51,$53,$30                         # 149o
        shufb   $r61_4,$55,$57,$30                      # 150o
        fms     $49,$47,$40,$49                         # 151e
        fma     $50,$47,$44,$50                         # 152e
        fm      $58,$46,$49                             # 157e
        fm      $54,$46,$50                             # 158e
        fma     $58,$r45_17,$50,$58                     # 163e
        fms     $54,$r45_17,$49,$54                     # 164e
        shufb   $60,$56,$58,$29                         # 169o
        shufb   $r60_10,$52,$54,$29                     # 170o
        shufb   $62,$52,$54,$30                         # 171o
        shufb   $r62_11,$56,$58,$30                     # 172o
        shufb   $63,$59,$60,$29                         # 173o
        shufb   $r63_3,$r59_3,$r60_10,$29               # 174o
        shufb   $64,$r59_3,$r60_10,$30                  # 175o
        shufb   $65,$61,$62,$29                         # 176o
        shufb   $66,$61,$62,$30                         # 177o
        stqd    $r63_3,0($28)                           # 178o
        stqd    $64,0x800($28)                          # 179o
        stqd    $65,0x1000($28)                         # 180o
        stqd    $66,0x1800($28)                         # 181o
        shufb   $64,$59,$60,$30                         # 182o
        shufb   $65,$r61_4,$r62_11,$29                  # 183o
        shufb   $66,$r61_4,$r62_11,$30                  # 184o
        stqd    $63,64($28)                             # 185o
        stqd    $64,0x840($28)                          # 186o
        stqd    $65,0x1040($28)                         # 187o
        stqd    $66,0x1840($28)                         # 188o
        nop     $127                                    # 189e pairing
batch_lines_back:
        brnz    $22,batch_lines                         # 189o
        nop     $127                                    # 190e pairing
        bi      $lr                                     # 190o
        .size   turn_batch, .-turn_batch

# 16 columns of a matrix with 64 rows of 4 lines, which become 16 rows of 4 lines.
        .align  3
        .global turn_square
        .type   turn_square, @function
turn_square:
        ila     $25,0x800                               # 0e
        lqa     $29,turn_shuffles                       # 0o
        ila     $26,0x1800                              # 1e
        lqa     $30,turn_shuffles+16                    # 1o
        a       $25,$25,$4                              # 2e
        lqa     $31,turn_shuffles+32                    # 2o
        a       $26,$26,$4                              # 3e
        lqa     $32,turn_shuffles+48                    # 3o
        il      $67,0x800                               # 4e
        lqa     $33,turn_shuffles+64                    # 4o
        il      $68,512                                 # 5e
        lqa     $34,turn_shuffles+80                    # 5o
        ori     $22,$7,0                                # 6e
        il      $23,0                                   # 7e
square_lines:
        andi    $24,$23,-64                             # 0e
        lqd     $35,0($6)                               # 0o
        ai      $22,$22,-1                              # 1e
        lqd     $36,16($6)                              # 1o
        a       $24,$24,$23                             # 2e
        lqd     $45,0($3)                               # 2o
        ai      $6,$6,32                                # 3e
        lqd     $46,64($3)                              # 3o
        a       $27,$25,$24                             # 4e
        lqd     $47,0($5)                               # 4o
        a       $28,$26,$24                             # 5e
        lqd     $48,64($5)                              # 5o
        ai      $23,$23,16                              # 6e
        shufb   $37,$35,$35,$31                         # 6o
        shufb   $41,$36,$36,$31                         # 7o
        shufb   $38,$35,$35,$32                         # 8o
        shufb   $42,$36,$36,$32                         # 9o
        shufb   $39,$35,$35,$33                         # 10o
        fm      $49,$48,$41                             # 11e
        shufb   $43,$36,$36,$33                         # 11o
        fm      $50,$48,$37                             # 12e
        shufb   $40,$35,$35,$34                         # 12o
        shufb   $44,$36,$36,$34                         # 13o
        lqd     $r45_8,512($3)                          # 14o
        lqd     $r46_8,576($3)                          # 15o
        lqd     $r47_5,128($5)                          # 16o
        fms     $49,$47,$37,$49                         # 17e
        lqd     $48,192($5)                             # 17o
        fma     $50,$47,$41,$50                         # 18e
        lqd     $r45_9,0x400($3)                        # 18o
        lqd     $r46_3,0x440($3)                        # 19o
        lqd     $47,256($5)                             # 20o
        lqd     $r48_12,320($5)                         # 21o
        lqd     $r45_10,0x600($3)                       # 22o
        fm      $55,$46,$49                             # 23e
        lqd     $r46_10,0x640($3)                       # 23o
        fm      $51,$46,$50                             # 24e
        lqd     $r47_10,384($5)                         # 24o
        fm      $r49_3,$48,$42                          # 25e
        lqd     $r48_11,448($5)                         # 25o
        fm      $r50_6,$48,$38                          # 26e
        lqd     $r45_11,16($3)                          # 26o
        fm      $r49_9,$r48_12,$43                      # 27e
        lqd     $46,80($3)                              # 27o
        fm      $r50_13,$r48_12,$39                     # 28e
        lqd     $r47_11,16($5)                          # 28o
        fma     $55,$45,$50,$55                         # 29e
        lqd     $48,80($5)                              # 29o
        fms     $51,$45,$49,$51                         # 30e
        lqd     $45,528($3)                             # 30o
        fms     $49,$r47_5,$38,$r49_3                   # 31e
        lqd     $r46_11,592($3)                         # 31o
        fma     $50,$r47_5,$42,$r50_6                   # 32e
        lqd     $r47_5,144($5)                          # 32o
        fms     $r49_10,$47,$39,$r49_9                  # 33e
        lqd     $r48_8,208($5)                          # 33o
        fma     $r50_13,$47,$43,$r50_13                 # 34e
        lqd     $r45_12,0x410($3)                       # 34o
        fm      $r49_11,$r48_11,$44                     # 35e
        lqd     $r46_12,0x450($3)                       # 35o
        fm      $r50_14,$r48_11,$40                     # 36e
        lqd     $47,272($5)                             # 36o
        fm      $56,$r46_8,$49                          # 37e
        lqd     $r48_13,336($5)                         # 37o
        fm      $52,$r46_8,$50                          # 38e
        lqd     $r45_13,0x610($3)                       # 38o
        fm      $57,$r46_3,$r49_10                      # 39e
        lqd     $r46_13,0x650($3)                       # 39o
        fm      $53,$r46_3,$r50_13                      # 40e
        lqd     $r47_4,400($5)                          # 40o
        fms     $r49_11,$r47_10,$40,$r49_11             # 41e
        lqd     $r48_14,464($5)                         # 41o
        fma     $r50_4,$r47_10,$44,$r50_14              # 42e
        lqd     $r45_14,32($3)                          # 42o
        fma     $56,$r45_8,$50,$56                      # 43e
        lqd     $r46_14,96($3)                          # 43o
        fms     $52,$r45_8,$49,$52                      # 44e
        lqd     $r47_9,32($5)                           # 44o
        fma     $57,$r45_9,$r50_13,$57                  # 45e
        lqd     $r48_12,96($5)                          # 45o
        fms     $53,$r45_9,$r49_10,$53                  # 46e
        lqd     $r45_9,544($3)                          # 46o
        fm      $58,$r46_10,$r49_11                     # 47e
        lqd     $r46_9,608($3)                          # 47o
        fm      $r54_11,$r46_10,$r50_4                  # 48e
        lqd     $r47_12,160($5)                         # 48o
        fm      $r49_12,$48,$41                         # 49e
        lqd     $r48_15,224($5)                         # 49o
        fm      $r50_15,$48,$37                         # 50e
        lqd     $r45_15,0x420($3)                       # 50o
        fm      $r49_13,$r48_8,$42                      # 51e
        shufb   $r59_8,$55,$57,$29                      # 51o
        fm      $r50_16,$r48_8,$38                      # 52e
        shufb   $r59_9,$51,$53,$29                      # 52o
        fma     $58,$r45_10,$r50_4,$58                  # 53e
        shufb   $r61_6,$51,$53,$30                      # 53o
        fms     $r54_13,$r45_10,$r49_11,$r54_11         # 54e
        shufb   $r61_7,$55,$57,$30                      # 54o
        fms     $r49_11,$r47_11,$37,$r49_12             # 55e
        lqd     $r46_15,0x460($3)                       # 55o
        fma     $r50_17,$r47_11,$41,$r50_15             # 56e
        lqd     $r47_13,288($5)                         # 56o
        fms     $r49_14,$r47_5,$38,$r49_13              # 57e
        lqd     $r48_16,352($5)                         # 57o
        fma     $r50_18,$r47_5,$42,$r50_16              # 58e
        lqd     $r45_5,0x620($3)                        # 58o
        fm      $r49_15,$r48_13,$43                     # 59e
        shufb   $r60_6,$56,$58,$29                      # 59o
        fm      $r50_19,$r48_13,$39                     # 60e
        shufb   $r60_7,$52,$r54_13,$29                  # 60o
        fm      $r55_11,$46,$r49_11                     # 61e
        shufb   $r62_7,$52,$r54_13,$30                  # 61o
        fm      $r51_12,$46,$r50_17                     # 62e
        shufb   $r62_8,$56,$58,$30                      # 62o
        fm      $56,$r46_11,$r49_14                     # 63e
        shufb   $r63_6,$r59_8,$r60_6,$29                # 63o
        fm      $r52_13,$r46_11,$r50_18                 # 64e
        shufb   $r63_7,$r59_9,$r60_7,$29                # 64o
        fms     $r49_15,$47,$39,$r49_15                 # 65e
        shufb   $64,$r59_9,$r60_7,$30                   # 65o
        fma     $r50_19,$47,$43,$r50_19                 # 66e
        shufb   $r65_5,$r61_6,$r62_7,$29                # 66o
        fma     $r55_12,$r45_11,$r50_17,$r55_11         # 67e
        shufb   $r66_2,$r61_6,$r62_7,$30                # 67o
        fms     $r51_13,$r45_11,$r49_11,$r51_12         # 68e
        stqd    $r63_7,-2048($27)                       # 68o
        fma     $56,$45,$r50_18,$56                     # 69e
        stqd    $64,-1536($27)                          # 69o
        fms     $r52_14,$45,$r49_14,$r52_13             # 70e
        stqd    $r65_5,-1024($27)                       # 70o
        fm      $r57_3,$r46_12,$r49_15                  # 71e
        stqd    $r66_2,-512($27)                        # 71o
        fm      $53,$r46_12,$r50_19                     # 72e
        shufb   $64,$r59_8,$r60_6,$30                   # 72o
        fm      $r49_16,$r48_14,$44                     # 73e
        shufb   $65,$r61_7,$r62_8,$29                   # 73o
        fm      $r50_11,$r48_14,$40                     # 74e
        shufb   $66,$r61_7,$r62_8,$30                   # 74o
        fm      $r49_17,$r48_12,$41                     # 75e
        stqd    $r63_6,-1984($27)                       # 75o
        fm      $r50_13,$r48_12,$37                     # 76e
        stqd    $64,-1472($27)                          # 76o
        fma     $r57_3,$r45_12,$r50_19,$r57_3           # 77e
        stqd    $65,-960($27)                           # 77o
        fms     $53,$r45_12,$r49_15,$53                 # 78e
        stqd    $66,-448($27)                           # 78o
        fms     $r49_16,$r47_4,$40,$r49_16              # 79e
        lqd     $46,0x660($3)                           # 79o
        fma     $r50_20,$r47_4,$44,$r50_11              # 80e
        lqd     $47,416($5)                             # 80o
        fms     $r49_17,$r47_9,$37,$r49_17              # 81e
        lqd     $r48_17,480($5)                         # 81o
        fma     $r50_5,$r47_9,$41,$r50_13               # 82e
        lqd     $45,48($3)                              # 82o
        fm      $r49_18,$r48_15,$42                     # 83e
        shufb   $59,$r55_12,$r57_3,$29                  # 83o
        fm      $r50_21,$r48_15,$38                     # 84e
        shufb   $r59_10,$r51_13,$53,$29                 # 84o
        fm      $58,$r46_13,$r49_16                     # 85e
        shufb   $r61_6,$r51_13,$53,$30                  # 85o
        fm      $54,$r46_13,$r50_20                     # 86e
        shufb   $r61_8,$r55_12,$r57_3,$30               # 86o
        fm      $r55_12,$r46_14,$r49_17                 # 87e
        lqd     $r46_12,112($3)                         # 87o
        fm      $r51_14,$r46_14,$r50_5                  # 88e
        lqd     $r47_14,48($5)                          # 88o
        fms     $r49_18,$r47_12,$38,$r49_18             # 89e
        lqd     $r48_18,112($5)                         # 89o
        fma     $r50_21,$r47_12,$42,$r50_21             # 90e
        lqd     $r45_16,560($3)                         # 90o
        fma     $58,$r45_13,$r50_20,$58                 # 91e
        lqd     $r46_3,624($3)                          # 91o
        fms     $54,$r45_13,$r49_16,$54                 # 92e
        lqd     $r47_15,176($5)                         # 92o
        fma     $r55_13,$r45_14,$r50_5,$r55_12          # 93e
        lqd     $r48_19,240($5)                         # 93o
        fms     $r51_15,$r45_14,$r49_17,$r51_14         # 94e
        lqd     $r45_14,0x430($3)                       # 94o
        fm      $r56_6,$r46_9,$r49_18                   # 95e
        lqd     $r46_16,0x470($3)                       # 95o
        fm      $52,$r46_9,$r50_21                      # 96e
        lqd     $r47_16,304($5)                         # 96o
        fm      $r49_14,$r48_16,$43                     # 97e
        shufb   $60,$56,$58,$29                         # 97o
        fm      $r50_22,$r48_16,$39                     # 98e
        shufb   $r60_8,$r52_14,$54,$29                  # 98o
        fm      $r49_13,$r48_17,$44                     # 99e
        shufb   $r62_9,$r52_14,$54,$30                  # 99o
        fm      $r50_11,$r48_17,$40                     # 100e
        shufb   $r62_10,$56,$58,$30                     # 100o
        fma     $56,$r45_9,$r50_21,$r56_6               # 101e
        shufb   $63,$59,$60,$29                         # 101o
        fms     $52,$r45_9,$r49_18,$52                  # 102e
        shufb   $r63_5,$r59_10,$r60_8,$29               # 102o
        fms     $r49_18,$r47_13,$39,$r49_14             # 103e
        shufb   $64,$r59_10,$r60_8,$30                  # 103o
        fma     $r50_17,$r47_13,$43,$r50_22             # 104e
        shufb   $65,$r61_6,$r62_9,$29                   # 104o
        fms     $r49_19,$47,$40,$r49_13                 # 105e
        shufb   $66,$r61_6,$r62_9,$30                   # 105o
        fma     $r50_18,$47,$44,$r50_11                 # 106e
        stqd    $r63_5,0($27)                           # 106o
        fm      $r49_4,$r48_18,$41                      # 107e
        stqd    $64,512($27)                            # 107o
        fm      $50,$r48_18,$37                         # 108e
        stqd    $65,0x400($27)                          # 108o
        fm      $57,$r46_15,$r49_18                     # 109e
        stqd    $66,0x600($27)                          # 109o
        fm      $53,$r46_15,$r50_17                     # 110e
        shufb   $64,$59,$60,$30                         # 110o
        fm      $58,$46,$r49_19                         # 111e
        shufb   $65,$r61_8,$r62_10,$29                  # 111o
        fm      $r54_7,$46,$r50_18                      # 112e
        shufb   $66,$r61_8,$r62_10,$30                  # 112o
        fms     $r49_4,$r47_14,$37,$r49_4               # 113e
        stqd    $63,64($27)                             # 113o
        fma     $50,$r47_14,$41,$50                     # 114e
        stqd    $64,576($27)                            # 114o
        fma     $57,$r45_15,$r50_17,$57                 # 115e
        stqd    $65,0x440($27)                          # 115o
        fms     $53,$r45_15,$r49_18,$53                 # 116e
        stqd    $66,0x640($27)                          # 116o
        fma     $58,$r45_5,$r50_18,$58                  # 117e
        lqd     $48,368($5)                             # 117o
        fms     $54,$r45_5,$r49_19,$r54_7               # 118e
        lqd     $r45_17,0x630($3)                       # 118o
        fm      $55,$r46_12,$r49_4                      # 119e
        lqd     $46,0x670($3)                           # 119o
        fm      $51,$r46_12,$50                         # 120e
        lqd     $47,432($5)                             # 120o
        fm      $r49_18,$r48_19,$42                     # 121e
        shufb   $59,$r55_13,$57,$29                     # 121o
        fm      $r50_23,$r48_19,$38                     # 122e
        shufb   $r59_4,$r51_15,$53,$29                  # 122o
        fm      $r49_3,$48,$43                          # 123e
        shufb   $61,$r51_15,$53,$30                     # 123o
        fm      $r50_12,$48,$39                         # 124e
        shufb   $60,$52,$54,$29                         # 124o
        fma     $55,$45,$50,$55                         # 125e
        shufb   $62,$52,$54,$30                         # 125o
        fms     $51,$45,$r49_4,$51                      # 126e
        shufb   $r60_9,$56,$58,$29                      # 126o
        fms     $r49_18,$r47_15,$38,$r49_18             # 127e
        shufb   $r61_2,$r55_13,$57,$30                  # 127o
        fma     $50,$r47_15,$42,$r50_23                 # 128e
        shufb   $63,$r59_4,$60,$29                      # 128o
        fms     $r49_20,$r47_16,$39,$r49_3              # 129e
        shufb   $64,$r59_4,$60,$30                      # 129o
        fma     $r50_23,$r47_16,$43,$r50_12             # 130e
        shufb   $65,$61,$62,$29                         # 130o
        a       $3,$3,$67                               # 131e
        shufb   $66,$61,$62,$30                         # 131o
        nop     $127                                    # 132e pairing
        stqd    $63,-2048($28)                          # 132o
        fm      $r56_14,$r46_3,$r49_18                  # 133e
        stqd    $64,-1536($28)                          # 133o
        fm      $52,$r46_3,$50                          # 134e
        stqd    $65,-1024($28)                          # 134o
        fm      $57,$r46_16,$r49_20                     # 135e
        stqd    $66,-512($28)                           # 135o
        fm      $53,$r46_16,$r50_23                     # 136e
        shufb   $62,$56,$58,$30                         # 136o
        shufb   $63,$59,$r60_9,$29                      # 137o
        shufb   $64,$59,$r60_9,$30                      # 138o
        fma     $56,$r45_16,$50,$r56_14                 # 139e
        lqd     $48,496($5)                             # 139o
        fms     $52,$r45_16,$r49_18,$52                 # 140e
        shufb   $65,$r61_2,$62,$29                      # 140o
        fma     $57,$r45_14,$r50_23,$57                 # 141e
        shufb   $66,$r61_2,$62,$30                      # 141o
        fms     $53,$r45_14,$r49_20,$53                 # 142e
        stqd    $63,-1984($28)                          # 142o
        a       $5,$5,$68                               # 143e
        stqd    $64,-1472($28)                          # 143o
        nop     $127                                    # 144e pairing
        stqd    $65,-960($28)                           # 144o
        fm      $49,$48,$44                             # 145e
        stqd    $66,-448($28)                           # 145o
        fm      $50,$48,$40                             # 146e
        hbrr    square_lines_back,square_lines          # 146o hint
        shufb   $59,$55,$57,$29                         # 147o
        shufb   $r59_3,$51,$53,$29                      # 148o
        shufb   $61,$51,$53,$30                         # 149o
        shufb   $r61_4,$55,$57,$30                      # 150o
        fms     $49,$47,$40,$49                         # 151e
        fma     $50,$47,$44,$50                         # 152e
        fm      $58,$46,$49                             # 157e
        fm      $54,$46,$50                             # 158e
        fma     $58,$r45_17,$50,$58                     # 163e
        fms     $54,$r45_17,$49,$54                     # 164e
        shufb   $60,$56,$58,$29                         # 169o
        shufb   $r60_10,$52,$54,$29                     # 170o
        shufb   $62,$52,$54,$30                         # 171o
        shufb   $r62_11,$56,$58,$30                     # 172o
        shufb   $63,$59,$60,$29                         # 173o
        shufb   $r63_3,$r59_3,$r60_10,$29               # 174o
        shufb   $64,$r59_3,$r60_10,$30                  # 175o
        shufb   $65,$61,$62,$29                         # 176o
        shufb   $66,$61,$62,$30                         # 177o
        stqd    $r63_3,0($28)                           # 178o
        stqd    $64,512($28)                            # 179o
        stqd    $65,0x400($28)                          # 180o
        stqd    $66,0x600($28)                          # 181o
        shufb   $64,$59,$60,$30                         # 182o
        shufb   $65,$r61_4,$r62_11,$29                  # 183o
        shufb   $66,$r61_4,$r62_11,$30                  # 184o
        stqd    $63,64($28)                             # 185o
        stqd    $64,576($28)                            # 186o
        stqd    $65,0x440($28)                          # 187o
        stqd    $66,0x640($28)                          # 188o
        nop     $127                                    # 189e pairing
square_lines_back:
        brnz    $22,square_lines                        # 189o
        nop     $127                                    # 190e pairing
        bi      $lr                                     # 190o
        .size   turn_square, .-turn_square

        .section .rodata
        .align  4
turn_shuffles:
        .int    0x00010203,0x10111213,0x04050607,0x14151617
        .int    0x08090a0b,0x18191a1b,0x0c0d0e0f,0x1c1d1e1f
        .irp    word, 0x00010203,0x04050607,0x08090a0b,0x0c0d0e0f
        .int    \word,\word,\word,\word
        .endr
