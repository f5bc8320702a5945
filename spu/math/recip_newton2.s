# recip_newton2   reciprocals: estimate, interpolation and two Newton steps
#   C       void recip_newton2(const vec_float4 *in, vec_float4 *out, int count);
#   In      $3 operands, $4 where the results go (the operands' own place will do), $5 count of
#           quadwords (0 is none); pointers 16-aligned. Both arrays have room for a count rounded
#           up to fours, and so many are done
#   Out     the results
#   Uses    $2-$30, $32-$35, $79   Saves  -   Stack  0   Calls  -
#   Domain  2^-126 <= |x| < 2^126; from there on the result is 0, of 0 it is the largest single,
#           with the sign of x
#   Error   1.0000001 ulp of the SPU's format, worst at 0x3fca6691; over all of an octave
#   Twin    oracle/src/twin/math.rs
# Scheduled by spu schedule from recip_newton2.s

        .include "macros.inc"
        .include "reciprocal.inc"
        .include "operands_tmpl.inc"

function recip_newton2
        .set    count_2,79
        .set    a_in_2,2
        .set    x2_2,6
        .set    x1_2,7
        .set    x3_2,8
        .set    x_2,9
        .set    y2_2,10
        .set    x2_3,22
        .set    x1_3,24
        .set    y_2,20
        .set    x3_3,25
        .set    t_e1_2,2
        .set    x_3,27
        .set    t_e3_2,6
        .set    y3_2,28
        .set    t_e_2,29
        .set    y1_2,30
        .set    z2_2,10
        .set    x2_4,2
        .set    t_e1_3,3
        .set    t_e_3,5
        .set    z3_2,3
        .set    a_out_2,5
        .set    a_out_3,2
        ai      $count,$count,3                         # 0e
        rotmi   $count,$count,-2                        # 2e

        nop     $127                                    # 3e pairing
        biz     $count,$lr                              # 6o

        clgti   $count_2,$count,2                       # 7e at least as many passes as overlap
        ilhu    $k_one,0x3f80                           # 8e

        nop     $127                                    # 9e pairing
        brz     $count_2,next_operand_short             # 9o too few passes

        ai      $a_in_2,$a_in,64                        # 10e
        lqd     $x2_2,32($a_in)                         # 10o

        ai      $count,$count,-1                        # 11e
        lqd     $x1_2,16($a_in)                         # 11o

        nop     $127                                    # 12e pairing
        lqd     $x3_2,48($a_in)                         # 12o

        ai      $count,$count,-1                        # 13e
        lqd     $x_2,0($a_in)                           # 13o

        ai      $a_in,$a_in_2,64                        # 14e
        lqd     $x,0($a_in_2)                           # 14o

        lqd     $x+2,32($a_in_2)                        # 15o
        frest   $y+2,$x2_2                              # 16o

        frest   $y+1,$x1_2                              # 17o
        frest   $y+3,$x3_2                              # 18o

        nop     $127                                    # 19e pairing
        frest   $y,$x_2                                 # 19o

        fi      $y2_2,$x2_2,$y+2                        # 20e
        shlqbyi $x2_3,$x2_2,0                           # 20o copy

        fi      $y+1,$x1_2,$y+1                         # 21e
        frest   $y+2,$x+2                               # 21o

        fi      $y+3,$x3_2,$y+3                         # 22e
        shlqbyi $x1_3,$x1_2,0                           # 22o copy

        fi      $y_2,$x_2,$y                            # 23e
        lqd     $x+3,48($a_in_2)                        # 23o

        nop     $127                                    # 24e pairing
        hbrr    next_operand_back,next_operand          # 24o hint

        fi      $y+2,$x+2,$y+2                          # 25e
        lqd     $x+1,16($a_in_2)                        # 25o

        nop     $127                                    # 26e pairing
        shlqbyi $x3_3,$x3_2,0                           # 26o copy

        fnms    $t_e+2,$x2_2,$y2_2,$k_one               # 27e
        frest   $y,$x                                   # 27o

        fnms    $t_e1_2,$x1_2,$y+1,$k_one               # 28e
        shlqbyi $x_3,$x_2,0                             # 28o copy

        fnms    $t_e3_2,$x3_2,$y+3,$k_one               # 29e
        frest   $y3_2,$x+3                              # 29o

        fnms    $t_e_2,$x_2,$y_2,$k_one                 # 30e
        shlqbyi $x_2,$x,0                               # 30o copy

        fi      $y,$x,$y                                # 31e
        shlqbyi $x1_2,$x+1,0                            # 31o copy

        nop     $127                                    # 32e pairing
        frest   $y1_2,$x+1                              # 32o

        fma     $z2_2,$t_e+2,$y2_2,$y2_2                # 33e
        shlqbyi $x3_2,$x+3,0                            # 33o copy

        fma     $z+1,$t_e1_2,$y+1,$y+1                  # 34e
        shlqbyi $x2_4,$x+2,0                            # 34o copy

        fma     $z+3,$t_e3_2,$y+3,$y+3                  # 35e
        fma     $z,$t_e_2,$y_2,$y_2                     # 36e

        fi      $y+3,$x+3,$y3_2                         # 37e
        fi      $y+1,$x+1,$y1_2                         # 38e

        fnms    $t_e+2,$x2_3,$z2_2,$k_one               # 40e
        fnms    $t_e3_2,$x3_3,$z+3,$k_one               # 41e

        fnms    $t_e+1,$x1_3,$z+1,$k_one                # 42e
        fnms    $t_e,$x_3,$z,$k_one                     # 43e

        fma     $out+2,$t_e+2,$z2_2,$z2_2               # 46e
        lnop                                            # 46o pairing

next_operand:
        ai      $count,$count,-1                        # 0e
            fnms    $t_e+2,$x+2,$y+2,$k_one             # 1e

            fma     $out+1,$t_e+1,$z+1,$z+1             # 2e
        lqd     $x+2,32($a_in)                          # 2o

            fma     $out,$t_e,$z,$z                     # 3e
            stqd    $out+2,32($a_out)                   # 3o

            fnms    $t_e+3,$x+3,$y+3,$k_one             # 4e
            lnop                                        # 4o pairing

            fnms    $t_e+1,$x+1,$y+1,$k_one             # 5e
        lqd     $x+3,48($a_in)                          # 5o

            fnms    $t_e,$x,$y,$k_one                   # 6e
        lqd     $x+1,16($a_in)                          # 6o

            fma     $z+2,$t_e+2,$y+2,$y+2               # 7e
        lqd     $x,0($a_in)                             # 7o

        ai      $a_in,$a_in,64                          # 8e
        frest   $y+2,$x+2                               # 8o

            fma     $out+3,$t_e3_2,$z+3,$z+3            # 9e
            stqd    $out+1,16($a_out)                   # 9o

            fma     $z+3,$t_e+3,$y+3,$y+3               # 10e
            stqd    $out,0($a_out)                      # 10o

            fma     $z+1,$t_e+1,$y+1,$y+1               # 11e
        frest   $y+3,$x+3                               # 11o

            fma     $z,$t_e,$y,$y                       # 12e
        frest   $y+1,$x+1                               # 12o

            fnms    $t_e+2,$x2_4,$z+2,$k_one            # 13e
        frest   $y,$x                                   # 13o

        fi      $y+2,$x+2,$y+2                          # 14e
        shlqbyi $x2_4,$x+2,0                            # 14o copy

        fi      $y+3,$x+3,$y+3                          # 15e
            stqd    $out+3,48($a_out)                   # 15o

            ai      $a_out,$a_out,64                    # 16e
            fnms    $t_e3_2,$x3_2,$z+3,$k_one           # 17e

            fnms    $t_e+1,$x1_2,$z+1,$k_one            # 18e
        shlqbyi $x1_2,$x+1,0                            # 18o copy

            fnms    $t_e,$x_2,$z,$k_one                 # 19e
        shlqbyi $x3_2,$x+3,0                            # 19o copy

            fma     $out+2,$t_e+2,$z+2,$z+2             # 20e
        shlqbyi $x_2,$x,0                               # 20o copy

        fi      $y+1,$x+1,$y+1                          # 21e
        lnop                                            # 21o pairing

        fi      $y,$x,$y                                # 22e
next_operand_back:
        brnz    $count,next_operand                     # 22o

next_operand_drain:
        fnms    $t_e+2,$x+2,$y+2,$k_one                 # 0e
        hbr     recip_newton2_return,$lr                # 0o hint

        fnms    $t_e1_3,$x+1,$y+1,$k_one                # 1e
        stqd    $out+2,32($a_out)                       # 1o

        fnms    $t_e_3,$x,$y,$k_one                     # 2e
        fnms    $t_e+3,$x+3,$y+3,$k_one                 # 3e

        fma     $out+1,$t_e+1,$z+1,$z+1                 # 4e
        fma     $out,$t_e,$z,$z                         # 5e

        fma     $z+2,$t_e+2,$y+2,$y+2                   # 6e
        fma     $z+1,$t_e1_3,$y+1,$y+1                  # 7e

        fma     $z,$t_e_3,$y,$y                         # 8e
        fma     $z3_2,$t_e+3,$y+3,$y+3                  # 9e

        fma     $out+3,$t_e3_2,$z+3,$z+3                # 10e
        stqd    $out+1,16($a_out)                       # 10o

        ai      $a_out_2,$a_out,64                      # 11e
        stqd    $out,0($a_out)                          # 11o

        fnms    $t_e+2,$x2_4,$z+2,$k_one                # 12e
        fnms    $t_e+1,$x1_2,$z+1,$k_one                # 13e

        fnms    $t_e,$x_2,$z,$k_one                     # 14e
        fnms    $t_e3_2,$x3_2,$z3_2,$k_one              # 15e

        ai      $a_out_3,$a_out_2,64                    # 16e
        stqd    $out+3,48($a_out)                       # 16o

        fma     $out+2,$t_e+2,$z+2,$z+2                 # 18e
        fma     $out+1,$t_e+1,$z+1,$z+1                 # 19e

        fma     $out,$t_e,$z,$z                         # 20e
        fma     $out+3,$t_e3_2,$z3_2,$z3_2              # 21e

        stqd    $out+2,32($a_out_2)                     # 24o
        stqd    $out+1,16($a_out_2)                     # 25o

        stqd    $out,0($a_out_2)                        # 26o
        stqd    $out+3,48($a_out_2)                     # 27o

        nop     $127                                    # 28e pairing
recip_newton2_return:
        bi      $lr                                     # 28o

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

        fma     $z,$t_e,$y,$y                           # 23e
        fma     $z+1,$t_e+1,$y+1,$y+1                   # 24e

        fma     $z+2,$t_e+2,$y+2,$y+2                   # 25e
        fma     $z+3,$t_e+3,$y+3,$y+3                   # 26e

        fnms    $t_e,$x,$z,$k_one                       # 29e
        fnms    $t_e+1,$x+1,$z+1,$k_one                 # 30e

        fnms    $t_e+2,$x+2,$z+2,$k_one                 # 31e
        fnms    $t_e+3,$x+3,$z+3,$k_one                 # 32e

        fma     $out,$t_e,$z,$z                         # 35e
        fma     $out+1,$t_e+1,$z+1,$z+1                 # 36e

        fma     $out+2,$t_e+2,$z+2,$z+2                 # 37e
        fma     $out+3,$t_e+3,$z+3,$z+3                 # 38e

        stqd    $out,0($a_out)                          # 41o
        stqd    $out+1,16($a_out)                       # 42o

        stqd    $out+2,32($a_out)                       # 43o
        stqd    $out+3,48($a_out)                       # 44o

        ai      $a_out,$a_out,64                        # 45e
        brnz    $count,next_operand_short               # 45o

        nop     $127                                    # 46e pairing
        bi      $lr                                     # 46o
endfunction recip_newton2
