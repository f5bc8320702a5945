# recip_newton1   reciprocals: estimate, interpolation and one Newton step
#   C       void recip_newton1(const vec_float4 *in, vec_float4 *out, int count);
#   In      $3 operands, $4 where the results go (the operands' own place will do), $5 count of
#           quadwords (0 is none); pointers 16-aligned. Both arrays have room for a count rounded
#           up to fours, and so many are done
#   Out     the results
#   Uses    $2-$21, $24-$27, $32-$35, $79   Saves  -   Stack  0   Calls  -
#   Domain  2^-126 <= |x| < 2^126; from there on the result is 0, of 0 it is the largest single,
#           with the sign of x
#   Error   1.438 ulp of the SPU's format, worst at 0x3fd7fffb; over all of an octave
#   Twin    oracle/src/twin/math.rs
# Scheduled by spu schedule from recip_newton1.s

        .include "macros.inc"
        .include "reciprocal.inc"
        .include "operands_tmpl.inc"

function recip_newton1
        .set    count_2,79
        .set    a_in_2,2
        .set    x2_2,6
        .set    x3_2,7
        .set    x_2,10
        .set    x2_3,8
        .set    y1_2,9
        .set    y_2,21
        .set    x_3,16
        .set    y3_2,6
        .set    y_3,12
        .set    y2_2,20
        .set    x1_2,15
        .set    x3_3,9
        .set    y3_3,8
        .set    y_4,10
        .set    y1_3,6
        .set    x1_3,7
        .set    x2_4,2
        .set    y1_4,2
        .set    x2_5,3
        .set    a_out_2,3
        .set    a_out_3,5
        ai      $count,$count,3                         # 0e
        rotmi   $count,$count,-2                        # 2e

        nop     $127                                    # 3e pairing
        biz     $count,$lr                              # 6o

        clgti   $count_2,$count,2                       # 7e at least as many passes as overlap
        ilhu    $k_one,0x3f80                           # 8e

        nop     $127                                    # 9e pairing
        brz     $count_2,next_operand_short             # 9o too few passes

        ai      $a_in_2,$a_in,64                        # 10e
        lqd     $x+3,48($a_in)                          # 10o

        ai      $count,$count,-1                        # 11e
        lqd     $x,0($a_in)                             # 11o

        nop     $127                                    # 12e pairing
        lqd     $x2_2,32($a_in)                         # 12o

        ai      $count,$count,-1                        # 13e
        lqd     $x+1,16($a_in)                          # 13o

        ai      $a_in,$a_in_2,64                        # 14e
        lqd     $x3_2,48($a_in_2)                       # 14o

        lqd     $x_2,0($a_in_2)                         # 15o
        frest   $y+3,$x+3                               # 16o

        nop     $127                                    # 17e pairing
        frest   $y,$x                                   # 17o

        ori     $x2_3,$x2_2,0                           # 18e copy
        frest   $y+2,$x2_2                              # 18o

        nop     $127                                    # 19e pairing
        frest   $y1_2,$x+1                              # 19o

        fi      $y+3,$x+3,$y+3                          # 20e
        lqd     $x+2,32($a_in_2)                        # 20o

        fi      $y_2,$x,$y                              # 21e
        shlqbyi $x+3,$x+3,0                             # 21o copy

        fi      $y+2,$x2_2,$y+2                         # 22e
        shlqbyi $x_3,$x,0                               # 22o copy

        fi      $y+1,$x+1,$y1_2                         # 23e
        hbrr    next_operand_back,next_operand          # 23o hint

        frest   $y3_2,$x3_2                             # 24o
        frest   $y_3,$x_2                               # 25o

        nop     $127                                    # 26e pairing
        frest   $y2_2,$x+2                              # 26o

        fnms    $t_e+3,$x+3,$y+3,$k_one                 # 27e
        shlqbyi $x1_2,$x+1,0                            # 27o copy

        fnms    $t_e,$x_3,$y_2,$k_one                   # 28e
        lqd     $x+1,16($a_in_2)                        # 28o

        fnms    $t_e+2,$x2_3,$y+2,$k_one                # 29e
        shlqbyi $x3_3,$x3_2,0                           # 29o copy

        fi      $y3_3,$x3_2,$y3_2                       # 30e
        shlqbyi $x_3,$x_2,0                             # 30o copy

        fi      $y_4,$x_2,$y_3                          # 31e
        fi      $y2_2,$x+2,$y2_2                        # 32e

        fnms    $t_e+1,$x1_2,$y+1,$k_one                # 34e
        frest   $y1_3,$x+1                              # 34o

        fma     $out+3,$t_e+3,$y+3,$y+3                 # 35e
        shlqbyi $x1_3,$x+1,0                            # 35o copy

        fma     $out,$t_e,$y_2,$y_2                     # 36e
        fma     $out+2,$t_e+2,$y+2,$y+2                 # 37e

next_operand:
            ori     $x2_4,$x+2,0                        # 0e copy
            stqd    $out+3,48($a_out)                   # 0o

            fma     $out+1,$t_e+1,$y+1,$y+1             # 1e
            stqd    $out,0($a_out)                      # 1o

            fi      $y+1,$x+1,$y1_3                     # 2e
        lqd     $x+3,48($a_in)                          # 2o

        ai      $count,$count,-1                        # 3e
        lqd     $x,0($a_in)                             # 3o

            fnms    $t_e+3,$x3_3,$y3_3,$k_one           # 4e
        lqd     $x+2,32($a_in)                          # 4o

            fnms    $t_e,$x_3,$y_4,$k_one               # 5e
        lqd     $x+1,16($a_in)                          # 5o

            fnms    $t_e+2,$x2_4,$y2_2,$k_one           # 6e
            stqd    $out+2,32($a_out)                   # 6o

        ai      $a_in,$a_in,64                          # 7e
            stqd    $out+1,16($a_out)                   # 7o

            ai      $a_out,$a_out,64                    # 8e
        frest   $y+3,$x+3                               # 8o

            fnms    $t_e+1,$x1_3,$y+1,$k_one            # 9e
        frest   $y,$x                                   # 9o

            fma     $out+3,$t_e+3,$y3_3,$y3_3           # 10e
        frest   $y+2,$x+2                               # 10o

            fma     $out,$t_e,$y_4,$y_4                 # 11e
        frest   $y1_3,$x+1                              # 11o

            fma     $out+2,$t_e+2,$y2_2,$y2_2           # 12e
        shlqbyi $x1_3,$x+1,0                            # 12o copy

        fi      $y3_3,$x+3,$y+3                         # 13e
        shlqbyi $x3_3,$x+3,0                            # 13o copy

        fi      $y_4,$x,$y                              # 14e
        shlqbyi $x_3,$x,0                               # 14o copy

        fi      $y2_2,$x+2,$y+2                         # 15e
next_operand_back:
        brnz    $count,next_operand                     # 15o

next_operand_drain:
        fi      $y1_4,$x+1,$y1_3                        # 0e
        hbr     recip_newton1_return,$lr                # 0o hint

        ori     $x2_5,$x+2,0                            # 1e copy
        stqd    $out+3,48($a_out)                       # 1o

        fnms    $t_e+3,$x3_3,$y3_3,$k_one               # 2e
        stqd    $out,0($a_out)                          # 2o

        fnms    $t_e,$x_3,$y_4,$k_one                   # 3e
        stqd    $out+2,32($a_out)                       # 3o

        fnms    $t_e+2,$x2_5,$y2_2,$k_one               # 4e
        fma     $out+1,$t_e+1,$y+1,$y+1                 # 5e

        ai      $a_out_2,$a_out,64                      # 6e
        fnms    $t_e+1,$x1_3,$y1_4,$k_one               # 7e

        fma     $out+3,$t_e+3,$y3_3,$y3_3               # 8e
        fma     $out,$t_e,$y_4,$y_4                     # 9e

        fma     $out+2,$t_e+2,$y2_2,$y2_2               # 10e
        lnop                                            # 10o pairing

        ai      $a_out_3,$a_out_2,64                    # 11e
        stqd    $out+1,16($a_out)                       # 11o

        fma     $out+1,$t_e+1,$y1_4,$y1_4               # 13e
        stqd    $out+3,48($a_out_2)                     # 14o

        stqd    $out,0($a_out_2)                        # 15o
        stqd    $out+2,32($a_out_2)                     # 16o

        stqd    $out+1,16($a_out_2)                     # 19o
recip_newton1_return:
        bi      $lr                                     # 20o

next_operand_short:
        ai      $count,$count,-1                        # 0e
        lqd     $x,0($a_in)                             # 0o

        lqd     $x+1,16($a_in)                          # 1o
        lqd     $x+2,32($a_in)                          # 2o

        lqd     $x+3,48($a_in)                          # 3o
        ai      $a_in,$a_in,64                          # 4e

        frest   $y,$x                                   # 6o
        frest   $y+1,$x+1                               # 7o

        frest   $y+2,$x+2                               # 8o
        frest   $y+3,$x+3                               # 9o

        fi      $y,$x,$y                                # 10e
        fi      $y+1,$x+1,$y+1                          # 11e

        fi      $y+2,$x+2,$y+2                          # 12e
        fi      $y+3,$x+3,$y+3                          # 13e

        fnms    $t_e,$x,$y,$k_one                       # 17e
        fnms    $t_e+1,$x+1,$y+1,$k_one                 # 18e

        fnms    $t_e+2,$x+2,$y+2,$k_one                 # 19e
        fnms    $t_e+3,$x+3,$y+3,$k_one                 # 20e

        fma     $out,$t_e,$y,$y                         # 23e
        fma     $out+1,$t_e+1,$y+1,$y+1                 # 24e

        fma     $out+2,$t_e+2,$y+2,$y+2                 # 25e
        fma     $out+3,$t_e+3,$y+3,$y+3                 # 26e

        stqd    $out,0($a_out)                          # 29o
        stqd    $out+1,16($a_out)                       # 30o

        stqd    $out+2,32($a_out)                       # 31o
        stqd    $out+3,48($a_out)                       # 32o

        ai      $a_out,$a_out,64                        # 33e
        brnz    $count,next_operand_short               # 33o

        nop     $127                                    # 34e pairing
        bi      $lr                                     # 34o
endfunction recip_newton1
