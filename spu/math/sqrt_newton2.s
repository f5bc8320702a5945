# sqrt_newton2   square roots: interpolation and two Newton steps
#   C       void sqrt_newton2(const vec_float4 *in, vec_float4 *out, int count);
#   In      $3 operands, $4 where the results go (the operands' own place will do), $5 count of
#           quadwords (0 is none); pointers 16-aligned. Both arrays have room for a count rounded
#           up to fours, and so many are done
#   Out     the results
#   Uses    $2-$35, $79   Saves  -   Stack  0   Calls  -
#   Domain  0, of which it is exactly 0, and 2^-104 <= x; of x below 0 the result means nothing.
#           Below 2^-104 remainders are flushed to 0: 4 ulp at 2^-106, from 2^-115 on unrefined
#   Error   1.00011 ulp of the SPU's format, worst at 0x4047fa5a; over all of two octaves
#   Twin    oracle/src/twin/math.rs
# Scheduled by spu schedule from sqrt_newton2.s

        .include "macros.inc"
        .include "math.inc"
        .include "operands_tmpl.inc"

function sqrt_newton2
        .set    count_2,79
        .set    a_in_2,2
        .set    x3_2,9
        .set    x1_2,11
        .set    x2_2,20
        .set    x_2,17
        .set    y1_2,6
        .set    y3_2,8
        .set    y_2,7
        .set    x_3,21
        .set    y_3,22
        .set    x2_3,24
        .set    x3_3,25
        .set    x1_3,27
        .set    z1_2,26
        .set    x_4,2
        .set    half_y_2,31
        .set    y1_3,28
        .set    z_2,22
        .set    x1_4,7
        .set    y2_2,32
        .set    half_y3_2,33
        .set    x2_4,8
        .set    z2_2,34
        .set    x3_4,6
        .set    t_e1_2,11
        .set    t_e3_2,9
        .set    t_e_2,35
        .set    t_e2_2,20
        .set    t_e_3,22
        .set    out1_2,20
        .set    half_y2_2,3
        .set    t_e2_3,5
        .set    a_out_2,9
        .set    a_out_3,5
        ai      $count,$count,3                         # 0e
        rotmi   $count,$count,-2                        # 2e

        nop     $127                                    # 3e pairing
        biz     $count,$lr                              # 6o

        clgti   $count_2,$count,2                       # 7e at least as many passes as overlap
        ilhu    $k_half,0x3f00                          # 8e

        nop     $127                                    # 9e pairing
        brz     $count_2,next_operand_short             # 9o too few passes

        ai      $a_in_2,$a_in,64                        # 10e
        lqd     $x3_2,48($a_in)                         # 10o

        ai      $count,$count,-1                        # 11e
        lqd     $x1_2,16($a_in)                         # 11o

        nop     $127                                    # 12e pairing
        lqd     $x2_2,32($a_in)                         # 12o

        ai      $count,$count,-1                        # 13e
        lqd     $x_2,0($a_in)                           # 13o

        ai      $a_in,$a_in_2,64                        # 14e
        lqd     $x,0($a_in_2)                           # 14o

        lqd     $x+3,48($a_in_2)                        # 15o
        frsqest $y+3,$x3_2                              # 16o

        frsqest $y1_2,$x1_2                             # 17o
        frsqest $y+2,$x2_2                              # 18o

        nop     $127                                    # 19e pairing
        frsqest $y,$x_2                                 # 19o

        fi      $y3_2,$x3_2,$y+3                        # 20e
        frsqest $y_2,$x                                 # 20o

        fi      $y1_2,$x1_2,$y1_2                       # 21e
        frsqest $y+3,$x+3                               # 21o

        fi      $y+2,$x2_2,$y+2                         # 22e
        shlqbyi $x_3,$x_2,0                             # 22o copy

        fi      $y_3,$x_2,$y                            # 23e
        shlqbyi $x2_3,$x2_2,0                           # 23o copy

        fi      $y,$x,$y_2                              # 24e
        lqd     $x+1,16($a_in_2)                        # 24o

        fi      $y+3,$x+3,$y+3                          # 25e
        lqd     $x+2,32($a_in_2)                        # 25o

        nop     $127                                    # 26e pairing
        hbrr    next_operand_back,next_operand          # 26o hint

        fm      $z+3,$x3_2,$y3_2                        # 27e
        shlqbyi $x3_3,$x3_2,0                           # 27o copy

        fm      $half_y+1,$y1_2,$k_half                 # 28e
        shlqbyi $x1_3,$x1_2,0                           # 28o copy

        fm      $z1_2,$x1_2,$y1_2                       # 29e
        shlqbyi $x_4,$x,0                               # 29o copy

        fm      $half_y_2,$y_3,$k_half                  # 30e
        frsqest $y1_3,$x+1                              # 30o

        fm      $z_2,$x_2,$y_3                          # 31e
        shlqbyi $x1_4,$x+1,0                            # 31o copy

        fm      $half_y+2,$y+2,$k_half                  # 32e
        frsqest $y2_2,$x+2                              # 32o

        fm      $half_y3_2,$y3_2,$k_half                # 33e
        shlqbyi $x2_4,$x+2,0                            # 33o copy

        fm      $z2_2,$x2_2,$y+2                        # 34e
        shlqbyi $x3_4,$x+3,0                            # 34o copy

        fnms    $t_e1_2,$z1_2,$z1_2,$x1_2               # 35e
        fnms    $t_e3_2,$z+3,$z+3,$x3_2                 # 36e

        fnms    $t_e_2,$z_2,$z_2,$x_2                   # 37e
        fi      $y+1,$x+1,$y1_3                         # 38e

        fi      $y+2,$x+2,$y2_2                         # 39e
        fnms    $t_e2_2,$z2_2,$z2_2,$x2_2               # 41e

        fma     $t_e3_2,$t_e3_2,$half_y3_2,$z+3         # 42e
        fma     $t_e1_2,$t_e1_2,$half_y+1,$z1_2         # 43e

        fma     $t_e_3,$t_e_2,$half_y_2,$z_2            # 44e
        fm      $half_y,$y,$k_half                      # 45e

        fm      $z+3,$x+3,$y+3                          # 46e
        fma     $t_e+2,$t_e2_2,$half_y+2,$z2_2          # 47e

        fnms    $out+3,$t_e3_2,$t_e3_2,$x3_3            # 48e
        fnms    $out1_2,$t_e1_2,$t_e1_2,$x1_3           # 49e

        fnms    $out,$t_e_3,$t_e_3,$x_3                 # 50e
        fm      $z+1,$x+1,$y+1                          # 51e

        fnms    $out+2,$t_e+2,$t_e+2,$x2_3              # 53e
        fma     $out+3,$out+3,$half_y3_2,$t_e3_2        # 54e

        fma     $out+1,$out1_2,$half_y+1,$t_e1_2        # 55e
        fma     $out,$out,$half_y_2,$t_e_3              # 56e

next_operand:
            fm      $z,$x,$y                            # 0e
            stqd    $out+1,16($a_out)                   # 0o

            fm      $half_y+1,$y+1,$k_half              # 1e
            stqd    $out,0($a_out)                      # 1o

            fnms    $t_e+1,$z+1,$z+1,$x+1               # 2e
        lqd     $x+1,16($a_in)                          # 2o

            fm      $half_y+3,$y+3,$k_half              # 3e
            stqd    $out+3,48($a_out)                   # 3o

            fma     $out+2,$out+2,$half_y+2,$t_e+2      # 4e
            fm      $z+2,$x+2,$y+2                      # 5e

            fnms    $t_e,$z,$z,$x                       # 6e
        lqd     $x,0($a_in)                             # 6o

            fnms    $t_e+3,$z+3,$z+3,$x+3               # 7e
        lqd     $x+3,48($a_in)                          # 7o

            fma     $t_e+1,$t_e+1,$half_y+1,$z+1        # 8e
        frsqest $y+1,$x+1                               # 8o

            fm      $half_y+2,$y+2,$k_half              # 9e
            lnop                                        # 9o pairing

        ai      $count,$count,-1                        # 10e
            stqd    $out+2,32($a_out)                   # 10o

            fnms    $t_e+2,$z+2,$z+2,$x+2               # 11e
        lqd     $x+2,32($a_in)                          # 11o

            fma     $t_e,$t_e,$half_y,$z                # 12e
        frsqest $y,$x                                   # 12o

            fma     $t_e+3,$t_e+3,$half_y+3,$z+3        # 13e
        frsqest $y+3,$x+3                               # 13o

        fi      $y+1,$x+1,$y+1                          # 14e
        ai      $a_in,$a_in,64                          # 15e

            fnms    $out+1,$t_e+1,$t_e+1,$x1_4          # 16e
            lnop                                        # 16o pairing

            fma     $t_e+2,$t_e+2,$half_y+2,$z+2        # 17e
        frsqest $y+2,$x+2                               # 17o

            fnms    $out,$t_e,$t_e,$x_4                 # 18e
        shlqbyi $x_4,$x,0                               # 18o copy

            fnms    $out+3,$t_e+3,$t_e+3,$x3_4          # 19e
        shlqbyi $x3_4,$x+3,0                            # 19o copy

        fi      $y+3,$x+3,$y+3                          # 20e
        shlqbyi $x1_4,$x+1,0                            # 20o copy

        fi      $y+2,$x+2,$y+2                          # 21e
        fi      $y,$x,$y                                # 22e

            ai      $a_out,$a_out,64                    # 23e
            fma     $out+1,$out+1,$half_y+1,$t_e+1      # 24e

            fnms    $out+2,$t_e+2,$t_e+2,$x2_4          # 25e
        shlqbyi $x2_4,$x+2,0                            # 25o copy

            fma     $out,$out,$half_y,$t_e              # 26e
        fm      $z+1,$x+1,$y+1                          # 27e

            fma     $out+3,$out+3,$half_y+3,$t_e+3      # 28e
        fm      $z+3,$x+3,$y+3                          # 29e

        fm      $half_y,$y,$k_half                      # 30e
next_operand_back:
        brnz    $count,next_operand                     # 30o

next_operand_drain:
        fm      $z,$x,$y                                # 0e
        hbr     sqrt_newton2_return,$lr                 # 0o hint

        fm      $z+2,$x+2,$y+2                          # 1e
        stqd    $out+1,16($a_out)                       # 1o

        fm      $half_y+1,$y+1,$k_half                  # 2e
        stqd    $out,0($a_out)                          # 2o

        fnms    $t_e+1,$z+1,$z+1,$x+1                   # 3e
        stqd    $out+3,48($a_out)                       # 3o

        fm      $half_y+3,$y+3,$k_half                  # 4e
        fnms    $t_e+3,$z+3,$z+3,$x+3                   # 5e

        fnms    $t_e,$z,$z,$x                           # 6e
        fm      $half_y2_2,$y+2,$k_half                 # 7e

        fnms    $t_e2_3,$z+2,$z+2,$x+2                  # 8e
        fma     $t_e+1,$t_e+1,$half_y+1,$z+1            # 9e

        fma     $out+2,$out+2,$half_y+2,$t_e+2          # 10e
        fma     $t_e+3,$t_e+3,$half_y+3,$z+3            # 11e

        fma     $t_e,$t_e,$half_y,$z                    # 12e
        ai      $a_out_2,$a_out,64                      # 13e

        fma     $t_e+2,$t_e2_3,$half_y2_2,$z+2          # 14e
        fnms    $out+1,$t_e+1,$t_e+1,$x1_4              # 15e

        ai      $a_out_3,$a_out_2,64                    # 16e
        stqd    $out+2,32($a_out)                       # 16o

        fnms    $out+3,$t_e+3,$t_e+3,$x3_4              # 17e
        fnms    $out,$t_e,$t_e,$x_4                     # 18e

        fnms    $out+2,$t_e+2,$t_e+2,$x2_4              # 20e
        fma     $out+1,$out+1,$half_y+1,$t_e+1          # 21e

        fma     $out+3,$out+3,$half_y+3,$t_e+3          # 23e
        fma     $out,$out,$half_y,$t_e                  # 24e

        fma     $out+2,$out+2,$half_y2_2,$t_e+2         # 26e
        stqd    $out+1,16($a_out_2)                     # 27o

        stqd    $out,0($a_out_2)                        # 30o
        stqd    $out+3,48($a_out_2)                     # 31o

        stqd    $out+2,32($a_out_2)                     # 32o
sqrt_newton2_return:
        bi      $lr                                     # 33o

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

        fm      $z,$x,$y                                # 17e
        fm      $z+1,$x+1,$y+1                          # 18e

        fm      $z+2,$x+2,$y+2                          # 19e
        fm      $z+3,$x+3,$y+3                          # 20e

        fm      $half_y,$y,$k_half                      # 21e
        fm      $half_y+1,$y+1,$k_half                  # 22e

        fnms    $t_e,$z,$z,$x                           # 23e
        fnms    $t_e+1,$z+1,$z+1,$x+1                   # 24e

        fm      $half_y+2,$y+2,$k_half                  # 25e
        fnms    $t_e+2,$z+2,$z+2,$x+2                   # 26e

        fm      $half_y+3,$y+3,$k_half                  # 27e
        fnms    $t_e+3,$z+3,$z+3,$x+3                   # 28e

        fma     $t_e,$t_e,$half_y,$z                    # 29e
        fma     $t_e+1,$t_e+1,$half_y+1,$z+1            # 30e

        fma     $t_e+2,$t_e+2,$half_y+2,$z+2            # 32e
        fma     $t_e+3,$t_e+3,$half_y+3,$z+3            # 34e

        fnms    $out,$t_e,$t_e,$x                       # 35e
        fnms    $out+1,$t_e+1,$t_e+1,$x+1               # 36e

        fnms    $out+2,$t_e+2,$t_e+2,$x+2               # 38e
        fnms    $out+3,$t_e+3,$t_e+3,$x+3               # 40e

        fma     $out,$out,$half_y,$t_e                  # 41e
        fma     $out+1,$out+1,$half_y+1,$t_e+1          # 42e

        fma     $out+2,$out+2,$half_y+2,$t_e+2          # 44e
        fma     $out+3,$out+3,$half_y+3,$t_e+3          # 46e

        stqd    $out,0($a_out)                          # 47o
        stqd    $out+1,16($a_out)                       # 48o

        stqd    $out+2,32($a_out)                       # 50o
        stqd    $out+3,48($a_out)                       # 52o

        ai      $a_out,$a_out,64                        # 53e
        brnz    $count,next_operand_short               # 53o

        nop     $127                                    # 54e pairing
        bi      $lr                                     # 54o
endfunction sqrt_newton2
