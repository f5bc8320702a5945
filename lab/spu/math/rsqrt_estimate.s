# rsqrt_estimate   reciprocals of square roots: the bare estimate
#   C       void rsqrt_estimate(const vec_float4 *in, vec_float4 *out, int count);
#   In      $3 operands, $4 where the results go (the operands' own place will do), $5 count of
#           quadwords (0 is none); pointers 16-aligned. Both arrays have space for the count rounded
#           up to a multiple of four, and all of these quadwords are processed
#   Out     the results
#   Uses    $3-$5, $12-$15, $32-$35   Saves  -   Stack  0   Calls  -
#   Domain  2^-126 <= x; of 0 the result is one of 2^128 or more, of x below 0 that of |x|
#   Error   489115 ulp of the SPU's format, worst at 0x3f87ffff; over all of two octaves
#   Twin    lab/twins/src/math.rs
#
# The estimate word is used directly. Its last 10 digits are a step and not a fraction, so they
# contribute little. The error is largest at the end of a table entry.

        .include "macros.inc"
        .include "operands_tmpl.inc"

function rsqrt_estimate
        begin_operands
next_operand:
        load_operands
    .irp n, 0,1,2,3
        frsqest $out+\n,$x+\n
    .endr
        store_operands
        next_operands next_operand
        bi      $lr
endfunction rsqrt_estimate
