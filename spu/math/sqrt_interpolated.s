# sqrt_interpolated   square roots: the operand times the interpolated estimate
#   C       void sqrt_interpolated(const vec_float4 *in, vec_float4 *out, int count);
#   In      $3 operands, $4 where the results go (the operands' own place will do), $5 count of
#           quadwords (0 is none); pointers 16-aligned. Both arrays have room for a count rounded
#           up to fours, and so many are done
#   Out     the results
#   Uses    $2-$21, $32-$35, $79   Saves  -   Stack  0   Calls  -
#   Domain  0 <= x; exactly 0 for 0, of x below 0 less the root of |x|
#   Error   2124.52 ulp of the SPU's format, worst at 0x400bdf97; over all of two octaves
#   Twin    oracle/src/twin/math.rs
# Scheduled by spu schedule from sqrt_interpolated.s

        .include "macros.inc"
        .include "math.inc"
        .include "operands_tmpl.inc"

function sqrt_interpolated
        .set    count_2,79
        .set    a_in_2,2
        .set    x1_2,9
        .set    x2_2,10
        .set    x1_3,7
        .set    x2_3,11
        .set    x_2,16
        .set    y_2,6
        .set    x3_2,13
        .set    y_3,14
        .set    x3_3,20
        .set    y3_2,15
        .set    y2_2,21
        .set    x1_4,8
        .set    x2_4,6
        .set    y1_2,2
        .set    x3_4,7
        .set    x_3,2
        .set    a_out_2,2
        ai      $count,$count,3                         # 0e
        rotmi   $count,$count,-2                        # 2e

        nop     $127                                    # 3e pairing
        biz     $count,$lr                              # 6o

        clgti   $count_2,$count,2                       # 7e at least as many passes as overlap
        brz     $count_2,next_operand_short             # 9o too few passes

        ai      $a_in_2,$a_in,64                        # 10e
        lqd     $x+1,16($a_in)                          # 10o

        ai      $count,$count,-1                        # 11e
        lqd     $x+2,32($a_in)                          # 11o

        nop     $127                                    # 12e pairing
        lqd     $x,0($a_in)                             # 12o

        ai      $count,$count,-1                        # 13e
        lqd     $x+3,48($a_in)                          # 13o

        ai      $a_in,$a_in_2,64                        # 14e
        lqd     $x1_2,16($a_in_2)                       # 14o

        nop     $127                                    # 15e pairing
        lqd     $x2_2,32($a_in_2)                       # 15o

        ori     $x1_3,$x+1,0                            # 16e copy
        frsqest $y+1,$x+1                               # 16o

        ori     $x2_3,$x+2,0                            # 17e copy
        frsqest $y+2,$x+2                               # 17o

        ori     $x_2,$x,0                               # 18e copy
        frsqest $y_2,$x                                 # 18o

        nop     $127                                    # 19e pairing
        frsqest $y+3,$x+3                               # 19o

        fi      $y+1,$x+1,$y+1                          # 20e
        lqd     $x3_2,48($a_in_2)                       # 20o

        fi      $y+2,$x+2,$y+2                          # 21e
        hbrr    next_operand_back,next_operand          # 21o hint

        fi      $y_3,$x,$y_2                            # 22e
        shlqbyi $x3_3,$x+3,0                            # 22o copy

        fi      $y3_2,$x+3,$y+3                         # 23e
        frsqest $y2_2,$x2_2                             # 23o

        ori     $x1_4,$x1_2,0                           # 24e copy
        lqd     $x,0($a_in_2)                           # 24o

        ori     $x2_4,$x2_2,0                           # 25e copy
        frsqest $y1_2,$x1_2                             # 25o

        nop     $127                                    # 26e pairing
        frsqest $y+3,$x3_2                              # 26o

        fm      $out+1,$x1_3,$y+1                       # 27e
        shlqbyi $x3_4,$x3_2,0                           # 27o copy

        fm      $out+2,$x2_3,$y+2                       # 28e
        fm      $out,$x_2,$y_3                          # 29e

        fi      $y+3,$x3_2,$y+3                         # 30e
        frsqest $y,$x                                   # 30o

        fi      $y+1,$x1_2,$y1_2                        # 31e
        fi      $y+2,$x2_2,$y2_2                        # 32e

        nop     $127                                    # 33e pairing
        stqd    $out+1,16($a_out)                       # 33o

        fm      $out+3,$x3_3,$y3_2                      # 34e
        stqd    $out+2,32($a_out)                       # 34o

next_operand:
            fi      $y,$x,$y                            # 0e
        lqd     $x+1,16($a_in)                          # 0o

        ai      $count,$count,-1                        # 1e
        lqd     $x+2,32($a_in)                          # 1o

            ori     $x_3,$x,0                           # 2e copy
        lqd     $x+3,48($a_in)                          # 2o

            fm      $out+1,$x1_4,$y+1                   # 3e
        lqd     $x,0($a_in)                             # 3o

            fm      $out+2,$x2_4,$y+2                   # 4e
            stqd    $out,0($a_out)                      # 4o

        ai      $a_in,$a_in,64                          # 5e
            stqd    $out+3,48($a_out)                   # 5o

            ai      $a_out,$a_out,64                    # 6e
        frsqest $y+1,$x+1                               # 6o

            fm      $out+3,$x3_4,$y+3                   # 7e
        frsqest $y+2,$x+2                               # 7o

        ori     $x2_4,$x+2,0                            # 8e copy
        frsqest $y+3,$x+3                               # 8o

            fm      $out,$x_3,$y                        # 9e
            stqd    $out+1,16($a_out)                   # 9o

        fi      $y+1,$x+1,$y+1                          # 10e
        frsqest $y,$x                                   # 10o

        fi      $y+2,$x+2,$y+2                          # 11e
        shlqbyi $x3_4,$x+3,0                            # 11o copy

        fi      $y+3,$x+3,$y+3                          # 12e
            stqd    $out+2,32($a_out)                   # 12o

        ori     $x1_4,$x+1,0                            # 13e copy
next_operand_back:
        brnz    $count,next_operand                     # 13o

next_operand_drain:
        fi      $y,$x,$y                                # 0e
        hbr     sqrt_interpolated_return,$lr            # 0o hint

        ori     $x_3,$x,0                               # 1e copy
        stqd    $out,0($a_out)                          # 1o

        fm      $out+1,$x1_4,$y+1                       # 2e
        stqd    $out+3,48($a_out)                       # 2o

        fm      $out+2,$x2_4,$y+2                       # 3e
        fm      $out+3,$x3_4,$y+3                       # 4e

        ai      $a_out,$a_out,64                        # 5e
        fm      $out,$x_3,$y                            # 7e

        ai      $a_out_2,$a_out,64                      # 8e
        stqd    $out+1,16($a_out)                       # 8o

        stqd    $out+2,32($a_out)                       # 9o
        stqd    $out,0($a_out)                          # 13o

        stqd    $out+3,48($a_out)                       # 14o
sqrt_interpolated_return:
        bi      $lr                                     # 15o

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

        fm      $out,$x,$y                              # 17e
        fm      $out+1,$x+1,$y+1                        # 18e

        fm      $out+2,$x+2,$y+2                        # 19e
        fm      $out+3,$x+3,$y+3                        # 20e

        stqd    $out,0($a_out)                          # 23o
        stqd    $out+1,16($a_out)                       # 24o

        stqd    $out+2,32($a_out)                       # 25o
        stqd    $out+3,48($a_out)                       # 26o

        ai      $a_out,$a_out,64                        # 27e
        brnz    $count,next_operand_short               # 27o

        nop     $127                                    # 28e pairing
        bi      $lr                                     # 28o
endfunction sqrt_interpolated
