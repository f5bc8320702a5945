# rsqrt_interpolated   reciprocals of square roots: estimate and interpolation
#   C       void rsqrt_interpolated(const vec_float4 *in, vec_float4 *out, int count);
#   In      $3 operands, $4 where the results go (the operands' own place will do), $5 count of
#           quadwords (0 is none); pointers 16-aligned. Both arrays have room for a count rounded
#           up to fours, and so many are done
#   Out     the results
#   Uses    $2-$9, $12-$15, $32-$35, $79   Saves  -   Stack  0   Calls  -
#   Domain  2^-126 <= x; of 0 the result is one of 2^128 or more, of x below 0 that of |x|
#   Error   2242.63 ulp of the SPU's format, worst at 0x3f93f400; over all of two octaves
#   Twin    oracle/src/twin/math.rs
# Scheduled by spu schedule from rsqrt_interpolated.s

        .include "macros.inc"
        .include "math.inc"
        .include "operands_tmpl.inc"

function rsqrt_interpolated
        .set    count_2,79
        .set    a_in_2,2
        .set    x1_2,6
        .set    x3_2,7
        .set    x_2,8
        .set    x2_2,9
        .set    out1_2,6
        .set    out3_2,7
        .set    out2_2,2
        .set    a_out_2,3
        ai      $count,$count,3                         # 0e
        rotmi   $count,$count,-2                        # 2e

        nop     $127                                    # 3e pairing
        biz     $count,$lr                              # 6o

        clgti   $count_2,$count,2                       # 7e at least as many passes as overlap
        brz     $count_2,next_operand_short             # 9o too few passes

        ai      $a_in_2,$a_in,64                        # 10e
        lqd     $x1_2,16($a_in)                         # 10o

        ai      $count,$count,-1                        # 11e
        lqd     $x3_2,48($a_in)                         # 11o

        nop     $127                                    # 12e pairing
        lqd     $x_2,0($a_in)                           # 12o

        ai      $count,$count,-1                        # 13e
        lqd     $x2_2,32($a_in)                         # 13o

        ai      $a_in,$a_in_2,64                        # 14e
        hbrr    next_operand_back,next_operand          # 14o hint

        lqd     $x+1,16($a_in_2)                        # 15o
        frsqest $out+1,$x1_2                            # 16o

        frsqest $out+3,$x3_2                            # 17o
        frsqest $out,$x_2                               # 18o

        nop     $127                                    # 19e pairing
        frsqest $out+2,$x2_2                            # 19o

        fi      $out1_2,$x1_2,$out+1                    # 20e
        lqd     $x+3,48($a_in_2)                        # 20o

        fi      $out3_2,$x3_2,$out+3                    # 21e
        lqd     $x,0($a_in_2)                           # 21o

        fi      $out,$x_2,$out                          # 22e
        lqd     $x+2,32($a_in_2)                        # 22o

        fi      $out+2,$x2_2,$out+2                     # 23e
        frsqest $out+1,$x+1                             # 23o

        frsqest $out+3,$x+3                             # 26o
        stqd    $out1_2,16($a_out)                      # 27o

        stqd    $out3_2,48($a_out)                      # 28o
        stqd    $out,0($a_out)                          # 29o

next_operand:
            fi      $out+1,$x+1,$out+1                  # 0e
            frsqest $out,$x                             # 0o

            fi      $out+3,$x+3,$out+3                  # 1e
            stqd    $out+2,32($a_out)                   # 1o

            ai      $a_out,$a_out,64                    # 2e
            frsqest $out+2,$x+2                         # 2o

        ai      $count,$count,-1                        # 3e
        lqd     $x+1,16($a_in)                          # 3o

            fi      $out,$x,$out                        # 4e
        lqd     $x+3,48($a_in)                          # 4o

        nop     $127                                    # 5e pairing
        lqd     $x,0($a_in)                             # 5o

            fi      $out+2,$x+2,$out+2                  # 6e
        lqd     $x+2,32($a_in)                          # 6o

        ai      $a_in,$a_in,64                          # 7e
            stqd    $out+1,16($a_out)                   # 7o

            stqd    $out+3,48($a_out)                   # 8o
        frsqest $out+1,$x+1                             # 9o

        frsqest $out+3,$x+3                             # 10o
            stqd    $out,0($a_out)                      # 11o

        nop     $127                                    # 12e pairing
next_operand_back:
        brnz    $count,next_operand                     # 12o

next_operand_drain:
        fi      $out+1,$x+1,$out+1                      # 0e
        frsqest $out,$x                                 # 0o

        fi      $out+3,$x+3,$out+3                      # 1e
        frsqest $out2_2,$x+2                            # 1o

        ai      $a_out_2,$a_out,64                      # 2e
        hbr     rsqrt_interpolated_return,$lr           # 2o hint

        stqd    $out+2,32($a_out)                       # 3o
        fi      $out,$x,$out                            # 4e

        fi      $out+2,$x+2,$out2_2                     # 5e
        ai      $a_out,$a_out_2,64                      # 6e

        stqd    $out+1,16($a_out_2)                     # 7o
        stqd    $out+3,48($a_out_2)                     # 8o

        stqd    $out,0($a_out_2)                        # 11o
        stqd    $out+2,32($a_out_2)                     # 12o

        nop     $127                                    # 13e pairing
rsqrt_interpolated_return:
        bi      $lr                                     # 13o

next_operand_short:
        ai      $count,$count,-1                        # 0e
        lqd     $x,0($a_in)                             # 0o

        lqd     $x+1,16($a_in)                          # 1o
        lqd     $x+2,32($a_in)                          # 2o

        lqd     $x+3,48($a_in)                          # 3o
        ai      $a_in,$a_in,64                          # 4e

        frsqest $out,$x                                 # 6o
        frsqest $out+1,$x+1                             # 7o

        frsqest $out+2,$x+2                             # 8o
        frsqest $out+3,$x+3                             # 9o

        fi      $out,$x,$out                            # 10e
        fi      $out+1,$x+1,$out+1                      # 11e

        fi      $out+2,$x+2,$out+2                      # 12e
        fi      $out+3,$x+3,$out+3                      # 13e

        stqd    $out,0($a_out)                          # 17o
        stqd    $out+1,16($a_out)                       # 18o

        stqd    $out+2,32($a_out)                       # 19o
        stqd    $out+3,48($a_out)                       # 20o

        ai      $a_out,$a_out,64                        # 21e
        brnz    $count,next_operand_short               # 21o

        nop     $127                                    # 22e pairing
        bi      $lr                                     # 22o
endfunction rsqrt_interpolated
