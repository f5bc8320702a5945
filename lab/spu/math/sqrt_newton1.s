# sqrt_newton1   square roots: interpolation and one Newton step
#   C       void sqrt_newton1(const vec_float4 *in, vec_float4 *out, int count);
#   In      $3 operands, $4 where the results go (the operands' own place will do), $5 count of
#           quadwords (0 is none); pointers 16-aligned. Both arrays have space for the count rounded
#           up to a multiple of four, and all of these quadwords are processed
#   Out     the results
#   Uses    $3-$5, $10, $12-$19, $24-$27, $32-$35   Saves  -   Stack  0   Calls  -
#   Domain  0, of which it is exactly 0, and 2^-104 <= x; of x below 0 the result means nothing.
#           Below 2^-104 remainders are flushed to 0: 4 ulp at 2^-106, from 2^-115 on unrefined
#   Error   1.546 ulp of the SPU's format, worst at 0x400be35b; over all of two octaves
#   Twin    lab/twins/src/math.rs

        .include "macros.inc"
        .include "math.inc"
        .include "operands_tmpl.inc"

function sqrt_newton1
        begin_operands
        ilhu    $k_half,0x3f00
next_operand:
        load_operands
    .irp n, 0,1,2,3
        sqrt_f4 $out+\n,$x+\n,$y+\n,$t_e+\n,$k_half
    .endr
        store_operands
        next_operands next_operand
        bi      $lr
endfunction sqrt_newton1
