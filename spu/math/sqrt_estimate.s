# sqrt_estimate   square roots: the operand times the bare estimate
#   C       void sqrt_estimate(const vec_float4 *in, vec_float4 *out, int count);
#   In      $3 operands, $4 where the results go (the operands' own place will do), $5 count of
#           quadwords (0 is none); pointers 16-aligned. Both arrays have room for a count rounded
#           up to fours, and so many are done
#   Out     the results
#   Uses    $2-$5, $12-$19, $32-$35, $79   Saves  -   Stack  0   Calls  -
#   Domain  0 <= x; exactly 0 for 0, of x below 0 less the root of |x|
#   Error   368832 ulp of the SPU's format, worst at 0x4007ffff; over all of two octaves
#   Twin    oracle/src/twin/math.rs
# Scheduled by spu schedule from sqrt_estimate.s

        .include "macros.inc"
        .include "operands_tmpl.inc"

function sqrt_estimate
        .set    count_2,79
        .set    a_out_2,2
        ai      $count,$count,3                         # 0e
        rotmi   $count,$count,-2                        # 2e

        nop     $127                                    # 3e pairing
        biz     $count,$lr                              # 6o

        clgti   $count_2,$count,1                       # 7e at least as many passes as overlap
        brz     $count_2,next_operand_short             # 9o too few passes

        ai      $count,$count,-1                        # 10e
        lqd     $x+2,32($a_in)                          # 10o

        lqd     $x+1,16($a_in)                          # 11o
        hbrr    next_operand_back,next_operand          # 12o hint

        lqd     $x+3,48($a_in)                          # 13o
        lqd     $x,0($a_in)                             # 14o

        ai      $a_in,$a_in,64                          # 15e
        frsqest $y+2,$x+2                               # 16o

        frsqest $y+1,$x+1                               # 17o
        frsqest $y+3,$x+3                               # 19o

        fm      $out+2,$x+2,$y+2                        # 20e
        frsqest $y,$x                                   # 20o

        fm      $out+1,$x+1,$y+1                        # 21e
        lnop                                            # 21o pairing

next_operand:
        ai      $count,$count,-1                        # 0e
        lqd     $x+2,32($a_in)                          # 0o

            fm      $out+3,$x+3,$y+3                    # 1e
        lqd     $x+1,16($a_in)                          # 1o

            fm      $out,$x,$y                          # 2e
        lqd     $x+3,48($a_in)                          # 2o

        lqd     $x,0($a_in)                             # 3o
            stqd    $out+2,32($a_out)                   # 4o

            nop     $127                                # 5e pairing
            stqd    $out+1,16($a_out)                   # 5o

        ai      $a_in,$a_in,64                          # 6e
        frsqest $y+2,$x+2                               # 6o

            stqd    $out+3,48($a_out)                   # 7o
        frsqest $y+1,$x+1                               # 8o

            nop     $127                                # 9e pairing
            stqd    $out,0($a_out)                      # 9o

            ai      $a_out,$a_out,64                    # 10e
        frsqest $y+3,$x+3                               # 10o

        fm      $out+2,$x+2,$y+2                        # 11e
        frsqest $y,$x                                   # 11o

        fm      $out+1,$x+1,$y+1                        # 12e
next_operand_back:
        brnz    $count,next_operand                     # 12o

next_operand_drain:
        fm      $out+3,$x+3,$y+3                        # 0e
        stqd    $out+2,32($a_out)                       # 0o

        fm      $out,$x,$y                              # 1e
        stqd    $out+1,16($a_out)                       # 1o

        ai      $a_out_2,$a_out,64                      # 2e
        stqd    $out+3,48($a_out)                       # 6o

        stqd    $out,0($a_out)                          # 7o
        bi      $lr                                     # 8o

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

        fm      $out,$x,$y                              # 10e
        fm      $out+1,$x+1,$y+1                        # 11e

        fm      $out+2,$x+2,$y+2                        # 12e
        fm      $out+3,$x+3,$y+3                        # 13e

        stqd    $out,0($a_out)                          # 16o
        stqd    $out+1,16($a_out)                       # 17o

        stqd    $out+2,32($a_out)                       # 18o
        stqd    $out+3,48($a_out)                       # 19o

        ai      $a_out,$a_out,64                        # 20e
        brnz    $count,next_operand_short               # 20o

        nop     $127                                    # 21e pairing
        bi      $lr                                     # 21o
endfunction sqrt_estimate
