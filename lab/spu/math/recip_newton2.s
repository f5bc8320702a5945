# recip_newton2   reciprocals: estimate, interpolation and two Newton steps
#   C       void recip_newton2(const vec_float4 *in, vec_float4 *out, int count);
#   In      $3 operands, $4 where the results go (the operands' own place will do), $5 count of
#           quadwords (0 is none); pointers 16-aligned. Both arrays have space for the count rounded
#           up to a multiple of four, and all of these quadwords are processed
#   Out     the results
#   Uses    $3-$5, $11-$27, $32-$35   Saves  -   Stack  0   Calls  -
#   Domain  2^-126 <= |x| < 2^126; from there on the result is 0, of 0 it is the largest single,
#           with the sign of x
#   Error   1.0000001 ulp of the SPU's format, worst at 0x3fca6691; over all of an octave
#   Twin    lab/twins/src/math.rs

        .include "macros.inc"
        .include "reciprocal.inc"
        .include "operands_tmpl.inc"

function recip_newton2
        begin_operands
        ilhu    $k_one,0x3f80
next_operand:
        load_operands
    .irp n, 0,1,2,3
        reciprocal_f4 $z+\n,$x+\n,$y+\n,$t_e+\n,$k_one
        recip_step_f4 $out+\n,$x+\n,$z+\n,$t_e+\n,$k_one
    .endr
        store_operands
        next_operands next_operand
        bi      $lr
endfunction recip_newton2
