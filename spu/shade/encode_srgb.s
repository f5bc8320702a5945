# encode_srgb   linear light to sRGB's values
#   C       void encode_srgb(vec_float4 *values, int quads);
#   In      $3 values, 16-aligned, $4 quadwords (even, at least 2)
#   Out     the same place: the values, encoded
#   Uses    $3-$4, $10-$30   Saves  -   Stack  0   Calls  -
#   Domain  any values: below 0 they stay below, above 1 they stay above
#   Error   0.12 of 1/255, of values from 0 to 1
#   Twin    lab/twins/src/display.rs
#
#   12.92 x                            up to 0.0031308
#   1.055 x^(1/2.4) - 0.055            above
# The power is a polynomial of degree 4 in x^(1/4), whose error is at most 0.013 of 1/255. The rest
# is the error of two roots of 12 bits.

        .include "work_unit.inc"
        .include "macros.inc"
        .include "math.inc"

        .set    NEXT,3
        registers a_value,count
        .set    NEXT,10
        registers k_edge,k_slope,k_0,k_1,k_2,k_3,k_4
        registers x0,x1,inverse0,inverse1,root0,root1,power0,power1,line0,line1
        registers c_above0,c_above1,fourth0,fourth1

function encode_srgb
        load_constant $k_edge,0x3b4d2e1c                # 0.0031308
        load_constant $k_slope,0x414eb852               # 12.92
        load_constant $k_0,0xbd854959                   # -0.0650813
        load_constant $k_1,0x3e4cc0a4                   # 0.1999536
        load_constant $k_2,0x3f8e58f4                   # 1.1120896
        load_constant $k_3,0xbea598d6                   # -0.3234317
        load_constant $k_4,0x3d9ca819                   # 0.0764925
        rotmi   $count,$count,-1                        # pairs
next_pair:
    .irp n, 0,1
        lqd     $x\n,16*\n($a_value)
        rsqrt_interpolated_f4 $inverse\n,$x\n
        fm      $root\n,$x\n,$inverse\n
        rsqrt_interpolated_f4 $inverse\n,$root\n
        fm      $fourth\n,$root\n,$inverse\n
        fma     $power\n,$k_4,$fourth\n,$k_3
        fma     $power\n,$power\n,$fourth\n,$k_2
        fma     $power\n,$power\n,$fourth\n,$k_1
        fma     $power\n,$power\n,$fourth\n,$k_0
        fm      $line\n,$x\n,$k_slope
        fcgt    $c_above\n,$x\n,$k_edge
        selb    $line\n,$line\n,$power\n,$c_above\n
        stqd    $line\n,16*\n($a_value)
    .endr
        ai      $a_value,$a_value,32
        ai      $count,$count,-1
        brnz    $count,next_pair
        bi      $lr
endfunction encode_srgb
