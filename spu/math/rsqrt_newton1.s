# rsqrt_newton1   reciprocals of square roots: interpolation and one Newton step
#   C       void rsqrt_newton1(const vec_float4 *in, vec_float4 *out, int count);
#   In      $3 operands, $4 where the results go (the operands' own place will do), $5 count of
#           quadwords (0 is none); pointers 16-aligned. Both arrays have room for a count rounded
#           up to fours, and so many are done
#   Out     the results
#   Uses    $2-$8, $10-$19, $24-$27, $32-$35, $79   Saves  -   Stack  0   Calls  -
#   Domain  2^-126 <= x; of 0 the result is one of 2^128 or more, of x below 0 it means nothing
#   Error   1.494 ulp of the SPU's format, worst at 0x400c01b3; over all of two octaves
#   Twin    oracle/src/twin/math.rs
# Scheduled by spu schedule from rsqrt_newton1.s

        .include "macros.inc"
        .include "math.inc"
        .include "operands_tmpl.inc"

function rsqrt_newton1
        .set    count_2,79
        .set    y1_2,2
        .set    y_2,6
        .set    y2_2,7
        .set    y3_2,8
        .set    a_out_2,2
        ai      $count,$count,3                         # 0e
        rotmi   $count,$count,-2                        # 2e

        nop     $127                                    # 3e pairing
        biz     $count,$lr                              # 6o

        clgti   $count_2,$count,1                       # 7e at least as many passes as overlap
        ilhu    $k_half,0x3f00                          # 8e

        ilhu    $k_one,0x3f80                           # 9e
        brz     $count_2,next_operand_short             # 9o too few passes

        ai      $count,$count,-1                        # 10e
        lqd     $x+1,16($a_in)                          # 10o

        lqd     $x,0($a_in)                             # 11o
        lqd     $x+2,32($a_in)                          # 12o

        nop     $127                                    # 13e pairing
        lqd     $x+3,48($a_in)                          # 13o

        ai      $a_in,$a_in,64                          # 14e
        hbrr    next_operand_back,next_operand          # 14o hint

        frsqest $y+1,$x+1                               # 16o
        frsqest $y,$x                                   # 17o

        frsqest $y+2,$x+2                               # 18o
        frsqest $y+3,$x+3                               # 19o

        fi      $y1_2,$x+1,$y+1                         # 20e
        fi      $y_2,$x,$y                              # 21e

        fi      $y2_2,$x+2,$y+2                         # 22e
        fi      $y3_2,$x+3,$y+3                         # 23e

        fm      $out+1,$y1_2,$k_half                    # 27e
        fm      $t_e,$x,$y_2                            # 28e

        fm      $t_e+1,$x+1,$y1_2                       # 29e
        lnop                                            # 29o pairing

next_operand:
            fm      $out,$y_2,$k_half                   # 0e
        lqd     $x+1,16($a_in)                          # 0o

            fm      $t_e+2,$x+2,$y2_2                   # 1e
        lqd     $x,0($a_in)                             # 1o

            fm      $t_e+3,$x+3,$y3_2                   # 2e
        lqd     $x+2,32($a_in)                          # 2o

            fnms    $t_e,$t_e,$y_2,$k_one               # 3e
        lqd     $x+3,48($a_in)                          # 3o

            fnms    $t_e+1,$t_e+1,$y1_2,$k_one          # 4e
            fm      $out+3,$y3_2,$k_half                # 5e

            fm      $out+2,$y2_2,$k_half                # 6e
        frsqest $y+1,$x+1                               # 6o

            fnms    $t_e+2,$t_e+2,$y2_2,$k_one          # 7e
        frsqest $y,$x                                   # 7o

            fnms    $t_e+3,$t_e+3,$y3_2,$k_one          # 8e
        frsqest $y+2,$x+2                               # 8o

            fma     $out,$t_e,$out,$y_2                 # 9e
        frsqest $y+3,$x+3                               # 9o

            fma     $out+1,$t_e+1,$out+1,$y1_2          # 10e
        fi      $y1_2,$x+1,$y+1                         # 11e

        fi      $y_2,$x,$y                              # 12e
        ai      $a_in,$a_in,64                          # 13e

            fma     $out+3,$t_e+3,$out+3,$y3_2          # 14e
            lnop                                        # 14o pairing

            fma     $out+2,$t_e+2,$out+2,$y2_2          # 15e
            stqd    $out,0($a_out)                      # 15o

        fi      $y2_2,$x+2,$y+2                         # 16e
            stqd    $out+1,16($a_out)                   # 16o

        fi      $y3_2,$x+3,$y+3                         # 17e
        ai      $count,$count,-1                        # 18e

        fm      $out+1,$y1_2,$k_half                    # 19e
        lnop                                            # 19o pairing

        fm      $t_e,$x,$y_2                            # 20e
            stqd    $out+3,48($a_out)                   # 20o

        fm      $t_e+1,$x+1,$y1_2                       # 21e
            stqd    $out+2,32($a_out)                   # 21o

            ai      $a_out,$a_out,64                    # 22e
next_operand_back:
        brnz    $count,next_operand                     # 22o

next_operand_drain:
        fm      $t_e+3,$x+3,$y3_2                       # 0e
        hbr     rsqrt_newton1_return,$lr                # 0o hint

        fm      $t_e+2,$x+2,$y2_2                       # 1e
        fm      $out,$y_2,$k_half                       # 2e

        fnms    $t_e,$t_e,$y_2,$k_one                   # 3e
        fnms    $t_e+1,$t_e+1,$y1_2,$k_one              # 4e

        fm      $out+3,$y3_2,$k_half                    # 5e
        fnms    $t_e+3,$t_e+3,$y3_2,$k_one              # 6e

        fm      $out+2,$y2_2,$k_half                    # 7e
        fnms    $t_e+2,$t_e+2,$y2_2,$k_one              # 8e

        fma     $out,$t_e,$out,$y_2                     # 9e
        fma     $out+1,$t_e+1,$out+1,$y1_2              # 10e

        ai      $a_out_2,$a_out,64                      # 11e
        fma     $out+3,$t_e+3,$out+3,$y3_2              # 12e

        fma     $out+2,$t_e+2,$out+2,$y2_2              # 14e
        stqd    $out,0($a_out)                          # 15o

        stqd    $out+1,16($a_out)                       # 16o
        stqd    $out+3,48($a_out)                       # 18o

        stqd    $out+2,32($a_out)                       # 20o
rsqrt_newton1_return:
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

        fm      $out,$y,$k_half                         # 21e
        fm      $out+1,$y+1,$k_half                     # 22e

        fnms    $t_e,$t_e,$y,$k_one                     # 23e
        fnms    $t_e+1,$t_e+1,$y+1,$k_one               # 24e

        fnms    $t_e+2,$t_e+2,$y+2,$k_one               # 25e
        fm      $out+2,$y+2,$k_half                     # 26e

        fnms    $t_e+3,$t_e+3,$y+3,$k_one               # 27e
        fm      $out+3,$y+3,$k_half                     # 28e

        fma     $out,$t_e,$out,$y                       # 29e
        fma     $out+1,$t_e+1,$out+1,$y+1               # 30e

        fma     $out+2,$t_e+2,$out+2,$y+2               # 32e
        fma     $out+3,$t_e+3,$out+3,$y+3               # 34e

        stqd    $out,0($a_out)                          # 35o
        stqd    $out+1,16($a_out)                       # 36o

        stqd    $out+2,32($a_out)                       # 38o
        stqd    $out+3,48($a_out)                       # 40o

        ai      $a_out,$a_out,64                        # 41e
        brnz    $count,next_operand_short               # 41o

        nop     $127                                    # 42e pairing
        bi      $lr                                     # 42o
endfunction rsqrt_newton1
