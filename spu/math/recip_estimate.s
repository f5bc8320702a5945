# recip_estimate   reciprocals: the bare estimate
#   C       void recip_estimate(const vec_float4 *in, vec_float4 *out, int count);
#   In      $3 operands, $4 where the results go (the operands' own place will do), $5 count of
#           quadwords (0 is none); pointers 16-aligned. Both arrays have room for a count rounded
#           up to fours, and so many are done
#   Out     the results
#   Uses    $2-$5, $12-$15, $32-$35, $79   Saves  -   Stack  0   Calls  -
#   Domain  2^-126 <= |x| < 2^126; from there on the result is 0, of 0 it is 2^128 or more
#           with the sign of x
#   Error   956084 ulp of the SPU's format, worst at 0x3f87ffff; over all of an octave
#   Twin    oracle/src/twin/math.rs
#
# The estimate word taken as it is. Its last 10 digits, a step and no fraction, count for little:
# the error is largest where an entry of the table ends.
# Scheduled by spu schedule from recip_estimate.s

        .include "macros.inc"
        .include "operands_tmpl.inc"

function recip_estimate
        .set    count_2,79
        .set    a_out_2,2
        ai      $count,$count,3                         # 0e
        rotmi   $count,$count,-2                        # 2e

        nop     $127                                    # 3e pairing
        biz     $count,$lr                              # 6o

        clgti   $count_2,$count,1                       # 7e at least as many passes as overlap
        brz     $count_2,next_operand_short             # 9o too few passes

        ai      $count,$count,-1                        # 10e
        lqd     $x,0($a_in)                             # 10o

        lqd     $x+1,16($a_in)                          # 11o
        hbrr    next_operand_back,next_operand          # 12o hint

        lqd     $x+2,32($a_in)                          # 13o
        lqd     $x+3,48($a_in)                          # 14o

        ai      $a_in,$a_in,64                          # 15e
        frest   $out,$x                                 # 16o

        frest   $out+1,$x+1                             # 17o
        frest   $out+2,$x+2                             # 19o

        stqd    $out,0($a_out)                          # 20o
        stqd    $out+1,16($a_out)                       # 21o

        nop     $127                                    # 22e pairing
        frest   $out+3,$x+3                             # 22o

next_operand:
        ai      $count,$count,-1                        # 0e
        lqd     $x,0($a_in)                             # 0o

        lqd     $x+1,16($a_in)                          # 1o
        lqd     $x+2,32($a_in)                          # 2o

        nop     $127                                    # 3e pairing
        lqd     $x+3,48($a_in)                          # 3o

        ai      $a_in,$a_in,64                          # 4e
            stqd    $out+2,32($a_out)                   # 4o

            nop     $127                                # 5e pairing
            stqd    $out+3,48($a_out)                   # 5o

            ai      $a_out,$a_out,64                    # 6e
        frest   $out,$x                                 # 6o

        frest   $out+1,$x+1                             # 7o
        frest   $out+2,$x+2                             # 8o

        frest   $out+3,$x+3                             # 9o
        stqd    $out,0($a_out)                          # 10o

        stqd    $out+1,16($a_out)                       # 11o
next_operand_back:
        brnz    $count,next_operand                     # 12o

next_operand_drain:
        ai      $a_out_2,$a_out,64                      # 0e
        stqd    $out+2,32($a_out)                       # 0o

        stqd    $out+3,48($a_out)                       # 1o
        bi      $lr                                     # 2o

next_operand_short:
        ai      $count,$count,-1                        # 0e
        lqd     $x,0($a_in)                             # 0o

        lqd     $x+1,16($a_in)                          # 1o
        lqd     $x+2,32($a_in)                          # 2o

        lqd     $x+3,48($a_in)                          # 3o
        ai      $a_in,$a_in,64                          # 4e

        frest   $out,$x                                 # 6o
        frest   $out+1,$x+1                             # 7o

        frest   $out+2,$x+2                             # 8o
        frest   $out+3,$x+3                             # 9o

        stqd    $out,0($a_out)                          # 10o
        stqd    $out+1,16($a_out)                       # 11o

        stqd    $out+2,32($a_out)                       # 12o
        stqd    $out+3,48($a_out)                       # 13o

        ai      $a_out,$a_out,64                        # 14e
        brnz    $count,next_operand_short               # 14o

        nop     $127                                    # 15e pairing
        bi      $lr                                     # 15o
endfunction recip_estimate
