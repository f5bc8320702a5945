# rsqrt_newton2   reciprocals of square roots: interpolation and two Newton steps
#   C       void rsqrt_newton2(const vec_float4 *in, vec_float4 *out, int count);
#   In      $3 operands, $4 where the results go (the operands' own place will do), $5 count of
#           quadwords (0 is none); pointers 16-aligned. Both arrays have room for a count rounded
#           up to fours, and so many are done
#   Out     the results
#   Uses    $2-$30, $32-$35, $79   Saves  -   Stack  0   Calls  -
#   Domain  2^-126 <= x; of 0 the result is one of 2^128 or more, of x below 0 it means nothing
#   Error   0.999997 ulp of the SPU's format, worst at 0x3f800006; over all of two octaves
#   Twin    oracle/src/twin/math.rs
# Scheduled by spu schedule from rsqrt_newton2.s

        .include "macros.inc"
        .include "math.inc"
        .include "operands_tmpl.inc"

function rsqrt_newton2
        .set    count_2,79
        .set    a_in_2,2
        .set    x2_2,6
        .set    x3_2,7
        .set    x1_2,8
        .set    x_2,9
        .set    y1_2,20
        .set    y_2,21
        .set    y1_3,2
        .set    y_3,20
        .set    y2_2,21
        .set    y3_2,22
        .set    z_2,23
        .set    z2_2,28
        .set    z1_2,29
        .set    z3_2,30
        .set    z_3,16
        .set    y2_3,23
        .set    y3_3,24
        .set    z1_3,17
        .set    t_e_2,12
        .set    z3_3,18
        .set    t_e1_2,6
        .set    t_e_3,13
        .set    t_e3_2,19
        .set    t_e_4,7
        .set    t_e2_2,12
        .set    z_4,28
        .set    t_e_5,2
        .set    z2_3,7
        .set    out1_2,6
        .set    t_e3_3,12
        .set    z3_4,13
        .set    z3_5,6
        .set    t_e3_4,2
        .set    a_out_2,2
        ai      $count,$count,3                         # 0e
        rotmi   $count,$count,-2                        # 2e

        nop     $127                                    # 3e pairing
        biz     $count,$lr                              # 6o

        clgti   $count_2,$count,2                       # 7e at least as many passes as overlap
        ilhu    $k_half,0x3f00                          # 8e

        ilhu    $k_one,0x3f80                           # 9e
        brz     $count_2,next_operand_short             # 9o too few passes

        ai      $a_in_2,$a_in,64                        # 10e
        lqd     $x,0($a_in)                             # 10o

        ai      $count,$count,-1                        # 11e
        lqd     $x+1,16($a_in)                          # 11o

        nop     $127                                    # 12e pairing
        lqd     $x2_2,32($a_in)                         # 12o

        ai      $count,$count,-1                        # 13e
        lqd     $x3_2,48($a_in)                         # 13o

        ai      $a_in,$a_in_2,64                        # 14e
        lqd     $x1_2,16($a_in_2)                       # 14o

        lqd     $x_2,0($a_in_2)                         # 15o
        frsqest $y,$x                                   # 16o

        frsqest $y+1,$x+1                               # 17o
        frsqest $y+2,$x2_2                              # 18o

        nop     $127                                    # 19e pairing
        frsqest $y+3,$x3_2                              # 19o

        fi      $y,$x,$y                                # 20e
        frsqest $y1_2,$x1_2                             # 20o

        fi      $y+1,$x+1,$y+1                          # 21e
        frsqest $y_2,$x_2                               # 21o

        fi      $y+2,$x2_2,$y+2                         # 22e
        lqd     $x+2,32($a_in_2)                        # 22o

        fi      $y+3,$x3_2,$y+3                         # 23e
        lqd     $x+3,48($a_in_2)                        # 23o

        fi      $y1_3,$x1_2,$y1_2                       # 24e
        hbrr    next_operand_back,next_operand          # 24o hint

        fi      $y_3,$x_2,$y_2                          # 25e
        fm      $t_e,$x,$y                              # 27e

        fm      $t_e+1,$x+1,$y+1                        # 28e
        frsqest $y2_2,$x+2                              # 28o

        fm      $t_e+2,$x2_2,$y+2                       # 29e
        frsqest $y3_2,$x+3                              # 29o

        fm      $z_2,$y,$k_half                         # 30e
        fm      $t_e+3,$x3_2,$y+3                       # 31e

        fm      $z2_2,$y+2,$k_half                      # 32e
        fnms    $t_e,$t_e,$y,$k_one                     # 33e

        fm      $z1_2,$y+1,$k_half                      # 34e
        fnms    $t_e+2,$t_e+2,$y+2,$k_one               # 35e

        fnms    $t_e+1,$t_e+1,$y+1,$k_one               # 36e
        fnms    $t_e+3,$t_e+3,$y+3,$k_one               # 37e

        fm      $z3_2,$y+3,$k_half                      # 38e
        fma     $z_3,$t_e,$z_2,$y                       # 39e

        fi      $y2_3,$x+2,$y2_2                        # 40e
        fi      $y3_3,$x+3,$y3_2                        # 41e

        fma     $z+2,$t_e+2,$z2_2,$y+2                  # 43e
        fma     $z1_3,$t_e+1,$z1_2,$y+1                 # 44e

        fm      $t_e_2,$x,$z_3                          # 45e
        fma     $z3_3,$t_e+3,$z3_2,$y+3                 # 46e

        fm      $out,$z_3,$k_half                       # 47e
        fm      $t_e+1,$x1_2,$y1_3                      # 48e

        fm      $t_e+2,$x2_2,$z+2                       # 49e
        fm      $t_e1_2,$x+1,$z1_3                      # 50e

        fm      $out+2,$z+2,$k_half                     # 51e
        fm      $t_e_3,$x_2,$y_3                        # 52e

        fm      $z+1,$y1_3,$k_half                      # 53e
        fm      $out+1,$z1_3,$k_half                    # 54e

        fnms    $t_e+2,$t_e+2,$z+2,$k_one               # 55e
        fm      $t_e3_2,$x+3,$y3_3                      # 56e

        fnms    $t_e+1,$t_e+1,$y1_3,$k_one              # 57e
        fm      $t_e+3,$x3_2,$z3_3                      # 58e

        fnms    $t_e_4,$t_e_2,$z_3,$k_one               # 59e
        fnms    $t_e1_2,$t_e1_2,$z1_3,$k_one            # 60e

        fm      $t_e2_2,$x+2,$y2_3                      # 61e
        fm      $z_4,$y_3,$k_half                       # 62e

        fma     $z+1,$t_e+1,$z+1,$y1_3                  # 63e
        fnms    $t_e_5,$t_e_3,$y_3,$k_one               # 64e

        fma     $out,$t_e_4,$out,$z_3                   # 65e
        fm      $z2_3,$y2_3,$k_half                     # 66e

        fma     $out+2,$t_e+2,$out+2,$z+2               # 67e
        fnms    $t_e+2,$t_e2_2,$y2_3,$k_one             # 68e

        fma     $out1_2,$t_e1_2,$out+1,$z1_3            # 69e
        fnms    $t_e+3,$t_e+3,$z3_3,$k_one              # 70e

        fnms    $t_e3_3,$t_e3_2,$y3_3,$k_one            # 71e
        stqd    $out,0($a_out)                          # 71o

        fm      $out+3,$z3_3,$k_half                    # 72e
        lnop                                            # 72o pairing

        fm      $z3_4,$y3_3,$k_half                     # 73e
        stqd    $out+2,32($a_out)                       # 73o

        fma     $z,$t_e_5,$z_4,$y_3                     # 74e
        lnop                                            # 74o pairing

        fm      $out+1,$z+1,$k_half                     # 75e
        stqd    $out1_2,16($a_out)                      # 75o

        fma     $z+2,$t_e+2,$z2_3,$y2_3                 # 76e
        fm      $t_e+1,$x1_2,$z+1                       # 77e

        fma     $out+3,$t_e+3,$out+3,$z3_3              # 78e
        fma     $z3_5,$t_e3_3,$z3_4,$y3_3               # 79e

        fm      $t_e,$x_2,$z                            # 80e
        lnop                                            # 80o pairing

next_operand:
            fm      $out,$z,$k_half                     # 0e
            stqd    $out+3,48($a_out)                   # 0o

            ai      $a_out,$a_out,64                    # 1e
        lqd     $x+1,16($a_in)                          # 1o

            fm      $t_e+2,$x+2,$z+2                    # 2e
        lqd     $x,0($a_in)                             # 2o

            fm      $t_e+3,$x+3,$z3_5                   # 3e
        lqd     $x+2,32($a_in)                          # 3o

            fnms    $t_e,$t_e,$z,$k_one                 # 4e
        lqd     $x+3,48($a_in)                          # 4o

            fm      $out+2,$z+2,$k_half                 # 5e
            fnms    $t_e+1,$t_e+1,$z+1,$k_one           # 6e

            fm      $out+3,$z3_5,$k_half                # 7e
        frsqest $y+1,$x+1                               # 7o

            fnms    $t_e+2,$t_e+2,$z+2,$k_one           # 8e
        frsqest $y,$x                                   # 8o

            fnms    $t_e+3,$t_e+3,$z3_5,$k_one          # 9e
        frsqest $y+2,$x+2                               # 9o

            fma     $out,$t_e,$out,$z                   # 10e
        frsqest $y+3,$x+3                               # 10o

        fi      $y+1,$x+1,$y+1                          # 11e
        fi      $y,$x,$y                                # 12e

        fi      $y+2,$x+2,$y+2                          # 13e
        fi      $y+3,$x+3,$y+3                          # 14e

        ai      $a_in,$a_in,64                          # 15e
        lnop                                            # 15o pairing

            fma     $out+2,$t_e+2,$out+2,$z+2           # 16e
            stqd    $out,0($a_out)                      # 16o

            fma     $out+1,$t_e+1,$out+1,$z+1           # 17e
        fm      $t_e+1,$x+1,$y+1                        # 18e

        fm      $t_e,$x,$y                              # 19e
        fm      $t_e+2,$x+2,$y+2                        # 20e

        fm      $t_e3_4,$x+3,$y+3                       # 21e
        lnop                                            # 21o pairing

        fm      $z+1,$y+1,$k_half                       # 22e
            stqd    $out+2,32($a_out)                   # 22o

        fm      $z,$y,$k_half                           # 23e
            stqd    $out+1,16($a_out)                   # 23o

        fnms    $t_e+1,$t_e+1,$y+1,$k_one               # 24e
        fnms    $t_e,$t_e,$y,$k_one                     # 25e

        fnms    $t_e+2,$t_e+2,$y+2,$k_one               # 26e
        fnms    $t_e3_4,$t_e3_4,$y+3,$k_one             # 27e

        fm      $z+2,$y+2,$k_half                       # 28e
        fm      $z+3,$y+3,$k_half                       # 29e

        fma     $z+1,$t_e+1,$z+1,$y+1                   # 30e
        fma     $z,$t_e,$z,$y                           # 31e

            fma     $out+3,$t_e+3,$out+3,$z3_5          # 32e
        ai      $count,$count,-1                        # 33e

        fma     $z+2,$t_e+2,$z+2,$y+2                   # 34e
        fma     $z3_5,$t_e3_4,$z+3,$y+3                 # 35e

        fm      $t_e+1,$x+1,$z+1                        # 36e
        fm      $t_e,$x,$z                              # 37e

        fm      $out+1,$z+1,$k_half                     # 38e
next_operand_back:
        brnz    $count,next_operand                     # 38o

next_operand_drain:
        fm      $t_e+2,$x+2,$z+2                        # 0e
        hbr     rsqrt_newton2_return,$lr                # 0o hint

        fm      $t_e+3,$x+3,$z3_5                       # 1e
        stqd    $out+3,48($a_out)                       # 1o

        fm      $out,$z,$k_half                         # 2e
        fnms    $t_e,$t_e,$z,$k_one                     # 3e

        fm      $out+2,$z+2,$k_half                     # 4e
        fnms    $t_e+1,$t_e+1,$z+1,$k_one               # 5e

        fnms    $t_e+2,$t_e+2,$z+2,$k_one               # 6e
        fm      $out+3,$z3_5,$k_half                    # 7e

        fnms    $t_e+3,$t_e+3,$z3_5,$k_one              # 8e
        fma     $out,$t_e,$out,$z                       # 9e

        ai      $a_out,$a_out,64                        # 10e
        fma     $out+1,$t_e+1,$out+1,$z+1               # 11e

        fma     $out+2,$t_e+2,$out+2,$z+2               # 12e
        ai      $a_out_2,$a_out,64                      # 13e

        fma     $out+3,$t_e+3,$out+3,$z3_5              # 14e
        stqd    $out,0($a_out)                          # 15o

        stqd    $out+2,32($a_out)                       # 18o
        stqd    $out+1,16($a_out)                       # 19o

        stqd    $out+3,48($a_out)                       # 20o
rsqrt_newton2_return:
        bi      $lr                                     # 21o

next_operand_short:
        ai      $count,$count,-1                        # 0e
        lqd     $x,0($a_in)                             # 0o

        lqd     $x+1,16($a_in)                          # 1o
        lqd     $x+2,32($a_in)                          # 2o

        lqd     $x+3,48($a_in)                          # 3o
        ai      $a_in,$a_in,64                          # 4e

        frsqest $y,$x                                   # 6o
        frsqest $y+1,$x+1                               # 7o

        frsqest $y+2,$x+2                               # 8o
        frsqest $y+3,$x+3                               # 9o

        fi      $y,$x,$y                                # 10e
        fi      $y+1,$x+1,$y+1                          # 11e

        fi      $y+2,$x+2,$y+2                          # 12e
        fi      $y+3,$x+3,$y+3                          # 13e

        fm      $t_e,$x,$y                              # 17e
        fm      $t_e+1,$x+1,$y+1                        # 18e

        fm      $t_e+2,$x+2,$y+2                        # 19e
        fm      $t_e+3,$x+3,$y+3                        # 20e

        fm      $z,$y,$k_half                           # 21e
        fm      $z+1,$y+1,$k_half                       # 22e

        fnms    $t_e,$t_e,$y,$k_one                     # 23e
        fnms    $t_e+1,$t_e+1,$y+1,$k_one               # 24e

        fnms    $t_e+2,$t_e+2,$y+2,$k_one               # 25e
        fm      $z+2,$y+2,$k_half                       # 26e

        fnms    $t_e+3,$t_e+3,$y+3,$k_one               # 27e
        fm      $z+3,$y+3,$k_half                       # 28e

        fma     $z,$t_e,$z,$y                           # 29e
        fma     $z+1,$t_e+1,$z+1,$y+1                   # 30e

        fma     $z+2,$t_e+2,$z+2,$y+2                   # 32e
        fma     $z+3,$t_e+3,$z+3,$y+3                   # 34e

        fm      $t_e,$x,$z                              # 35e
        fm      $t_e+1,$x+1,$z+1                        # 36e

        fm      $out,$z,$k_half                         # 37e
        fm      $t_e+2,$x+2,$z+2                        # 38e

        fm      $out+1,$z+1,$k_half                     # 39e
        fm      $t_e+3,$x+3,$z+3                        # 40e

        fnms    $t_e,$t_e,$z,$k_one                     # 41e
        fnms    $t_e+1,$t_e+1,$z+1,$k_one               # 42e

        fm      $out+2,$z+2,$k_half                     # 43e
        fnms    $t_e+2,$t_e+2,$z+2,$k_one               # 44e

        fm      $out+3,$z+3,$k_half                     # 45e
        fnms    $t_e+3,$t_e+3,$z+3,$k_one               # 46e

        fma     $out,$t_e,$out,$z                       # 47e
        fma     $out+1,$t_e+1,$out+1,$z+1               # 48e

        fma     $out+2,$t_e+2,$out+2,$z+2               # 50e
        fma     $out+3,$t_e+3,$out+3,$z+3               # 52e

        stqd    $out,0($a_out)                          # 53o
        stqd    $out+1,16($a_out)                       # 54o

        stqd    $out+2,32($a_out)                       # 56o
        stqd    $out+3,48($a_out)                       # 58o

        ai      $a_out,$a_out,64                        # 59e
        brnz    $count,next_operand_short               # 59o

        nop     $127                                    # 60e pairing
        bi      $lr                                     # 60o
endfunction rsqrt_newton2
