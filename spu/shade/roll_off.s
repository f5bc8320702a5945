# roll_off   limits light to less than 1 without a step
#   C       void roll_off(vec_float4 *values, int quads);
#   In      $3 values, 16-aligned, $4 quadwords (a multiple of 4, at least 4)
#   Out     the same place: the values
#   Uses    $3-$4, $10-$33   Saves  -   Stack  0   Calls  -
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
        registers k_knee,k_half,k_share,k_one
    .irp n, 0,1,2,3
        registers x\n,beyond\n,inverse\n,bent\n,c_above\n
    .endr

function roll_off
        ilhu    $k_knee,0x3f40                          # 3/4
        ilhu    $k_half,0x3f00
        ilhu    $k_share,0x3d80                         # 1/16
        ilhu    $k_one,0x3f80
        rotmi   $count,$count,-2
next_four:
    .irp n, 0,1,2,3
        lqd     $x\n,16*\n($a_value)
        fs      $beyond\n,$x\n,$k_half
        frest   $inverse\n,$beyond\n
        fi      $inverse\n,$beyond\n,$inverse\n
        fnms    $bent\n,$inverse\n,$k_share,$k_one
        fcgt    $c_above\n,$x\n,$k_knee
        selb    $bent\n,$x\n,$bent\n,$c_above\n
        stqd    $bent\n,16*\n($a_value)
    .endr
        ai      $a_value,$a_value,64
        ai      $count,$count,-1
        brnz    $count,next_four
        bi      $lr
endfunction roll_off
