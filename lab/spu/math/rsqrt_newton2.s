# rsqrt_newton2   reciprocals of square roots: interpolation and two Newton steps
#   C       void rsqrt_newton2(const vec_float4 *in, vec_float4 *out, int count);
#   In      $3 operands, $4 where the results go (the operands' own place will do), $5 count of
#           quadwords (0 is none); pointers 16-aligned. Both arrays have space for the count rounded
#           up to a multiple of four, and all of these quadwords are processed
#   Out     the results
#   Uses    $3-$5, $10-$27, $32-$35   Saves  -   Stack  0   Calls  -
#   Domain  2^-126 <= x; of 0 the result is one of 2^128 or more, of x below 0 it means nothing
#   Error   0.999997 ulp of the SPU's format, worst at 0x3f800006; over all of two octaves
#   Twin    lab/twins/src/math.rs

        .include "macros.inc"
        .include "math.inc"
        .include "operands_tmpl.inc"

function rsqrt_newton2
        begin_operands
        ilhu    $k_half,0x3f00
        ilhu    $k_one,0x3f80
next_operand:
        load_operands
    .irp n, 0,1,2,3
        rsqrt_f4 $z+\n,$x+\n,$y+\n,$t_e+\n,$k_half,$k_one
        rsqrt_step_f4 $out+\n,$x+\n,$z+\n,$t_e+\n,$k_half,$k_one
    .endr
        store_operands
        next_operands next_operand
        bi      $lr
endfunction rsqrt_newton2
