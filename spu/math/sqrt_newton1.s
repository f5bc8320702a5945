# sqrt_newton1   square roots: interpolation and one Newton step
#   C       void sqrt_newton1(const vec_float4 *in, vec_float4 *out, int count);
#   In      $3 operands, $4 where the results go (the operands' own place will do), $5 count of
#           quadwords (0 is none); pointers 16-aligned. Both arrays have room for a count rounded
#           up to fours, and so many are done
#   Out     the results
#   Uses    $2-$22, $24-$27, $32-$35, $79   Saves  -   Stack  0   Calls  -
#   Domain  0, of which it is exactly 0, and 2^-104 <= x; of x below 0 the result means nothing.
#           Below 2^-104 remainders are flushed to 0: 4 ulp at 2^-106, from 2^-115 on unrefined
#   Error   1.546 ulp of the SPU's format, worst at 0x400be35b; over all of two octaves
#   Twin    oracle/src/twin/math.rs
# Scheduled by spu schedule from sqrt_newton1.s

        .include "macros.inc"
        .include "math.inc"
        .include "operands_tmpl.inc"

function sqrt_newton1
        .set    count_2,79
        .set    a_in_2,2
        .set    x1_2,6
        .set    x_2,7
        .set    x3_2,8
        .set    x2_2,9
        .set    y3_2,11
        .set    y1_2,19
        .set    y3_3,2
        .set    y_2,20
        .set    y2_2,21
        .set    y_3,22
        .set    y2_3,6
        .set    t_e2_2,3
        .set    t_e3_2,5
        .set    out2_2,7
        .set    out3_2,8
        .set    out2_3,3
        .set    out3_3,2
        .set    a_out_2,5
        ai      $count,$count,3                         # 0e
        rotmi   $count,$count,-2                        # 2e

        nop     $127                                    # 3e pairing
        biz     $count,$lr                              # 6o

        clgti   $count_2,$count,2                       # 7e at least as many passes as overlap
        ilhu    $k_half,0x3f00                          # 8e

        nop     $127                                    # 9e pairing
        brz     $count_2,next_operand_short             # 9o too few passes

        ai      $a_in_2,$a_in,64                        # 10e
        lqd     $x1_2,16($a_in)                         # 10o

        ai      $count,$count,-1                        # 11e
        lqd     $x_2,0($a_in)                           # 11o

        nop     $127                                    # 12e pairing
        lqd     $x3_2,48($a_in)                         # 12o

        ai      $count,$count,-1                        # 13e
        lqd     $x2_2,32($a_in)                         # 13o

        ai      $a_in,$a_in_2,64                        # 14e
        lqd     $x+3,48($a_in_2)                        # 14o

        lqd     $x+1,16($a_in_2)                        # 15o
        frsqest $y+1,$x1_2                              # 16o

        frsqest $y,$x_2                                 # 17o
        frsqest $y3_2,$x3_2                             # 18o

        nop     $127                                    # 19e pairing
        frsqest $y+2,$x2_2                              # 19o

        fi      $y1_2,$x1_2,$y+1                        # 20e
        lqd     $x,0($a_in_2)                           # 20o

        fi      $y,$x_2,$y                              # 21e
        frsqest $y+1,$x+1                               # 21o

        fi      $y3_2,$x3_2,$y3_2                       # 22e
        lqd     $x+2,32($a_in_2)                        # 22o

        fi      $y+2,$x2_2,$y+2                         # 23e
        hbrr    next_operand_back,next_operand          # 23o hint

        frsqest $y3_3,$x+3                              # 24o
        fi      $y+1,$x+1,$y+1                          # 25e

        frsqest $y_2,$x                                 # 26o
        fm      $t_e+1,$x1_2,$y1_2                      # 27e

        fm      $t_e,$x_2,$y                            # 28e
        frsqest $y2_2,$x+2                              # 28o

        fm      $t_e+3,$x3_2,$y3_2                      # 29e
        fm      $t_e+2,$x2_2,$y+2                       # 30e

        fm      $y_3,$y,$k_half                         # 31e
        fm      $y1_2,$y1_2,$k_half                     # 32e

        fnms    $out+1,$t_e+1,$t_e+1,$x1_2              # 33e
        fnms    $out,$t_e,$t_e,$x_2                     # 34e

        fi      $y3_3,$x+3,$y3_3                        # 35e
        fi      $y2_3,$x+2,$y2_2                        # 36e

        fi      $y,$x,$y_2                              # 37e
        fm      $y+2,$y+2,$k_half                       # 39e

        fma     $out+1,$out+1,$y1_2,$t_e+1              # 40e
        fnms    $out+3,$t_e+3,$t_e+3,$x3_2              # 41e

        fnms    $out+2,$t_e+2,$t_e+2,$x2_2              # 42e
        fm      $y+3,$y3_2,$k_half                      # 43e

        fma     $out,$out,$y_3,$t_e                     # 44e
        lnop                                            # 44o pairing

next_operand:
        ai      $count,$count,-1                        # 0e
            stqd    $out+1,16($a_out)                   # 0o

            fma     $out+2,$out+2,$y+2,$t_e+2           # 1e
            stqd    $out,0($a_out)                      # 1o

            fma     $out+3,$out+3,$y+3,$t_e+3           # 2e
            fm      $t_e+3,$x+3,$y3_3                   # 3e

            fm      $t_e,$x,$y                          # 4e
            fm      $t_e+1,$x+1,$y+1                    # 5e

            fm      $t_e+2,$x+2,$y2_3                   # 6e
            lnop                                        # 6o pairing

            fm      $y+1,$y+1,$k_half                   # 7e
            stqd    $out+2,32($a_out)                   # 7o

            fm      $y,$y,$k_half                       # 8e
            stqd    $out+3,48($a_out)                   # 8o

            fnms    $out+3,$t_e+3,$t_e+3,$x+3           # 9e
        lqd     $x+3,48($a_in)                          # 9o

            fnms    $out,$t_e,$t_e,$x                   # 10e
        lqd     $x,0($a_in)                             # 10o

            fnms    $out+1,$t_e+1,$t_e+1,$x+1           # 11e
        lqd     $x+1,16($a_in)                          # 11o

            fnms    $out+2,$t_e+2,$t_e+2,$x+2           # 12e
        lqd     $x+2,32($a_in)                          # 12o

            fm      $y+3,$y3_3,$k_half                  # 13e
        ai      $a_in,$a_in,64                          # 14e

            fm      $y+2,$y2_3,$k_half                  # 15e
        frsqest $y3_3,$x+3                              # 15o

            fma     $out,$out,$y,$t_e                   # 16e
        frsqest $y,$x                                   # 16o

            fma     $out+1,$out+1,$y+1,$t_e+1           # 17e
        frsqest $y+1,$x+1                               # 17o

            ai      $a_out,$a_out,64                    # 18e
        frsqest $y2_3,$x+2                              # 18o

        fi      $y3_3,$x+3,$y3_3                        # 19e
        fi      $y,$x,$y                                # 20e

        fi      $y+1,$x+1,$y+1                          # 21e
        lnop                                            # 21o pairing

        fi      $y2_3,$x+2,$y2_3                        # 22e
next_operand_back:
        brnz    $count,next_operand                     # 22o

next_operand_drain:
        fm      $t_e+1,$x+1,$y+1                        # 0e
        hbr     sqrt_newton1_return,$lr                 # 0o hint

        fm      $t_e,$x,$y                              # 1e
        stqd    $out+1,16($a_out)                       # 1o

        fm      $t_e2_2,$x+2,$y2_3                      # 2e
        stqd    $out,0($a_out)                          # 2o

        fm      $t_e3_2,$x+3,$y3_3                      # 3e
        fm      $y+1,$y+1,$k_half                       # 4e

        fm      $y,$y,$k_half                           # 5e
        fnms    $out+1,$t_e+1,$t_e+1,$x+1               # 6e

        fnms    $out,$t_e,$t_e,$x                       # 7e
        fnms    $out2_2,$t_e2_2,$t_e2_2,$x+2            # 8e

        fm      $y2_3,$y2_3,$k_half                     # 9e
        fnms    $out3_2,$t_e3_2,$t_e3_2,$x+3            # 10e

        fm      $y3_3,$y3_3,$k_half                     # 11e
        fma     $out+2,$out+2,$y+2,$t_e+2               # 12e

        fma     $out+3,$out+3,$y+3,$t_e+3               # 13e
        fma     $out+1,$out+1,$y+1,$t_e+1               # 14e

        fma     $out,$out,$y,$t_e                       # 15e
        fma     $out2_3,$out2_2,$y2_3,$t_e2_2           # 16e

        fma     $out3_3,$out3_2,$y3_3,$t_e3_2           # 17e
        lnop                                            # 17o pairing

        ai      $a_out_2,$a_out,64                      # 18e
        stqd    $out+2,32($a_out)                       # 18o

        nop     $127                                    # 19e pairing
        stqd    $out+3,48($a_out)                       # 19o

        ai      $a_out,$a_out_2,64                      # 20e
        stqd    $out+1,16($a_out_2)                     # 20o

        stqd    $out,0($a_out_2)                        # 21o
        stqd    $out2_3,32($a_out_2)                    # 22o

        stqd    $out3_3,48($a_out_2)                    # 23o
sqrt_newton1_return:
        bi      $lr                                     # 24o

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

        fm      $y,$y,$k_half                           # 21e
        fm      $y+1,$y+1,$k_half                       # 22e

        fnms    $out,$t_e,$t_e,$x                       # 23e
        fnms    $out+1,$t_e+1,$t_e+1,$x+1               # 24e

        fm      $y+2,$y+2,$k_half                       # 25e
        fnms    $out+2,$t_e+2,$t_e+2,$x+2               # 26e

        fm      $y+3,$y+3,$k_half                       # 27e
        fnms    $out+3,$t_e+3,$t_e+3,$x+3               # 28e

        fma     $out,$out,$y,$t_e                       # 29e
        fma     $out+1,$out+1,$y+1,$t_e+1               # 30e

        fma     $out+2,$out+2,$y+2,$t_e+2               # 32e
        fma     $out+3,$out+3,$y+3,$t_e+3               # 34e

        stqd    $out,0($a_out)                          # 35o
        stqd    $out+1,16($a_out)                       # 36o

        stqd    $out+2,32($a_out)                       # 38o
        stqd    $out+3,48($a_out)                       # 40o

        ai      $a_out,$a_out,64                        # 41e
        brnz    $count,next_operand_short               # 41o

        nop     $127                                    # 42e pairing
        bi      $lr                                     # 42o
endfunction sqrt_newton1
