# recip_estimate   reciprocals: the bare estimate
#   C       void recip_estimate(const vec_float4 *in, vec_float4 *out, int count);
#   In      $3 operands, $4 where the results go (the operands' own place will do), $5 count of
#           quadwords (0 is none); pointers 16-aligned. Both arrays have space for the count rounded
#           up to a multiple of four, and all of these quadwords are processed
#   Out     the results
#   Uses    $3-$5, $12-$15, $32-$35   Saves  -   Stack  0   Calls  -
#   Domain  2^-126 <= |x| < 2^126; from there on the result is 0, of 0 it is 2^128 or more
#           with the sign of x
#   Error   956084 ulp of the SPU's format, worst at 0x3f87ffff; over all of an octave
#   Twin    lab/twins/src/math.rs
#
# The estimate word is used directly. Its last 10 digits are a step and not a fraction, so they
# contribute little. The error is largest at the end of a table entry.

        .include "macros.inc"
        .include "operands_tmpl.inc"

function recip_estimate
        begin_operands
next_operand:
        load_operands
    .irp n, 0,1,2,3
        frest   $out+\n,$x+\n
    .endr
        store_operands
        next_operands next_operand
        bi      $lr
endfunction recip_estimate
