# roll_off   limits light to less than 1 without a step
#   C       void roll_off(vec_float4 *values, int quads);
#   In      $3 values, 16-aligned, $4 quadwords (at least 1)
#   Out     the same place: the values
#   Uses    $3-$4, $10-$18   Saves  -   Stack  0   Calls  -
#   Domain  any values
#   Error   0.03 of 1/255, of values from 0
#   Twin    lab/twins/src/display.rs
#
#   x                          up to 3/4
#   1 - 1/16 / (x - 1/2)       above: of the same slope there, and below 1

        .include "work_unit.inc"
        .include "macros.inc"

        .set    NEXT,3
        registers a_value,count
        .set    NEXT,10
        registers k_knee,k_half,k_share,k_one,x,beyond,inverse,bent,c_above

function roll_off
        ilhu    $k_knee,0x3f40                          # 3/4
        ilhu    $k_half,0x3f00
        ilhu    $k_share,0x3d80                         # 1/16
        ilhu    $k_one,0x3f80
next_quad:
        lqd     $x,0($a_value)
        fs      $beyond,$x,$k_half
        frest   $inverse,$beyond
        fi      $inverse,$beyond,$inverse
        fnms    $bent,$inverse,$k_share,$k_one
        fcgt    $c_above,$x,$k_knee
        selb    $bent,$x,$bent,$c_above
        stqd    $bent,0($a_value)
        ai      $a_value,$a_value,16
        ai      $count,$count,-1
        brnz    $count,next_quad
        bi      $lr
endfunction roll_off
