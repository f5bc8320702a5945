# sqrt_estimate   square roots: the operand times the bare estimate
#   C       void sqrt_estimate(const vec_float4 *in, vec_float4 *out, int count);
#   In      $3 operands, $4 where the results go (the operands' own place will do), $5 count of
#           quadwords (0 is none); pointers 16-aligned. Both arrays have space for the count rounded
#           up to a multiple of four, and all of these quadwords are processed
#   Out     the results
#   Uses    $3-$5, $12-$19, $32-$35   Saves  -   Stack  0   Calls  -
#   Domain  0 <= x; exactly 0 for 0, of x below 0 less the root of |x|
#   Error   368832 ulp of the SPU's format, worst at 0x4007ffff; over all of two octaves
#   Twin    lab/twins/src/math.rs

        .include "macros.inc"
        .include "operands_tmpl.inc"

function sqrt_estimate
        begin_operands
next_operand:
        load_operands
    .irp n, 0,1,2,3
        frsqest $y+\n,$x+\n
        fm      $out+\n,$x+\n,$y+\n
    .endr
        store_operands
        next_operands next_operand
        bi      $lr
endfunction sqrt_estimate
