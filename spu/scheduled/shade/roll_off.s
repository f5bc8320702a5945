# roll_off   limits light to less than 1 without a step
#   C       void roll_off(vec_float4 *values, int quads);
#   In      $3 values, 16-aligned, $4 quadwords (a multiple of 4, at least 4)
#   Out     the same place: the values
#   Uses    $2-$33, $79   Saves  -   Stack  0   Calls  -
#   Domain  any values
#   Error   0.03 of 1/255, of values from 0
#   Twin    lab/twins/src/display.rs
#
#   x                          up to 3/4
#   1 - 1/16 / (x - 1/2)       above: of the same slope there, and below 1
# Scheduled by spu schedule from roll_off.s

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
        .set count_2,79; .set x2_2,2; .set x1_2,7; .set x3_2,5; .set x0_2,16; .set a_value_2,17
        .set beyond2_2,6; .set x2_3,8; .set beyond1_2,18; .set beyond0_2,21; .set a_value_3,9
        .set inverse1_2,2; .set inverse0_2,22; .set inverse1_3,32; .set x0_3,6; .set x1_3,2
        .set inverse0_3,21; .set a_value_4,7; .set a_value_5,4
        rotmi   $count,$count,-2                        # 0e
        ilhu    $k_knee,0x3f40                          # 1e 3/4
        ilhu    $k_half,0x3f00                          # 2e
        ilhu    $k_share,0x3d80                         # 3e 1/16
        clgti   $count_2,$count,2                       # 4e at least as many passes as overlap
        ilhu    $k_one,0x3f80                           # 5e
        nop     $127                                    # 6e pairing
        brz     $count_2,next_four_short                # 6o too few passes
        ai      $count,$count,-1                        # 7e
        lqd     $x2_2,32($a_value)                      # 7o
        nop     $127                                    # 8e pairing
        lqd     $x1_2,16($a_value)                      # 8o
        ai      $count,$count,-1                        # 9e
        lqd     $x3_2,48($a_value)                      # 9o
        lqd     $x0_2,0($a_value)                       # 10o
        shlqbyi $a_value_2,$a_value,0                   # 11o copy
        ai      $a_value,$a_value,64                    # 12e
        hbrr    next_four_back,next_four                # 12o hint
        fs      $beyond2_2,$x2_2,$k_half                # 13e
        shlqbyi $x2_3,$x2_2,0                           # 13o copy
        fs      $beyond1_2,$x1_2,$k_half                # 14e
        lqd     $x0,0($a_value)                         # 14o
        fs      $beyond3,$x3_2,$k_half                  # 15e
        lqd     $x2,32($a_value)                        # 15o
        fs      $beyond0_2,$x0_2,$k_half                # 16e
        lqd     $x1,16($a_value)                        # 16o
        fcgt    $c_above2,$x2_2,$k_knee                 # 17e
        lqd     $x3,48($a_value)                        # 17o
        fcgt    $c_above3,$x3_2,$k_knee                 # 18e
        shlqbyi $a_value_3,$a_value,0                   # 18o copy
        fcgt    $c_above1,$x1_2,$k_knee                 # 19e
        frest   $inverse2,$beyond2_2                    # 19o
        fs      $beyond0,$x0,$k_half                    # 20e
        frest   $inverse1_2,$beyond1_2                  # 20o
        fs      $beyond2,$x2,$k_half                    # 21e
        frest   $inverse3,$beyond3                      # 21o
        fs      $beyond1,$x1,$k_half                    # 22e
        frest   $inverse0_2,$beyond0_2                  # 22o
        fi      $inverse2,$beyond2_2,$inverse2          # 23e
        shlqbyi $x3_2,$x3_2,0                           # 23o copy
        fi      $inverse1_3,$beyond1_2,$inverse1_2      # 24e
        shlqbyi $x0_3,$x0_2,0                           # 24o copy
        fi      $inverse3,$beyond3,$inverse3            # 25e
        shlqbyi $x1_3,$x1_2,0                           # 25o copy
        fi      $inverse0_3,$beyond0_2,$inverse0_2      # 26e
        shlqbyi $a_value_4,$a_value_2,0                 # 26o copy
        fcgt    $c_above0,$x0_2,$k_knee                 # 27e
        fnms    $bent2,$inverse2,$k_share,$k_one        # 30e
        fnms    $bent1,$inverse1_3,$k_share,$k_one      # 31e
        fnms    $bent3,$inverse3,$k_share,$k_one        # 32e
        fnms    $bent0,$inverse0_3,$k_share,$k_one      # 33e
        lnop                                            # 33o pairing
next_four:
            fs      $beyond3,$x3,$k_half                # 0e
            frest   $inverse1,$beyond1                  # 0o
            ai      $a_value,$a_value,64                # 1e
            frest   $inverse0,$beyond0                  # 1o
            selb    $bent1,$x1_3,$bent1,$c_above1       # 2e
            shlqbyi $x1_3,$x1,0                         # 2o copy
            fcgt    $c_above1,$x1,$k_knee               # 3e
        lqd     $x1,16($a_value)                        # 3o
            selb    $bent3,$x3_2,$bent3,$c_above3       # 4e
            stqd    $bent1,16($a_value_4)               # 4o
            fi      $inverse0,$beyond0,$inverse0        # 5e
            frest   $inverse2,$beyond2                  # 5o
            selb    $bent2,$x2_3,$bent2,$c_above2       # 6e
            frest   $inverse3,$beyond3                  # 6o
            fcgt    $c_above2,$x2,$k_knee               # 7e
            shlqbyi $x3_2,$x3,0                         # 7o copy
            selb    $bent0,$x0_3,$bent0,$c_above0       # 8e
            stqd    $bent3,48($a_value_4)               # 8o
            fcgt    $c_above0,$x0,$k_knee               # 9e
            stqd    $bent2,32($a_value_4)               # 9o
            fi      $inverse1,$beyond1,$inverse1        # 10e
            shlqbyi $x0_3,$x0,0                         # 10o copy
        ai      $count,$count,-1                        # 11e
        lqd     $x0,0($a_value)                         # 11o
            fi      $inverse3,$beyond3,$inverse3        # 12e
            stqd    $bent0,0($a_value_4)                # 12o
            fi      $inverse2,$beyond2,$inverse2        # 13e
            shlqbyi $a_value_4,$a_value_3,0             # 13o copy
            fcgt    $c_above3,$x3,$k_knee               # 14e
            shlqbyi $x2_3,$x2,0                         # 14o copy
        fs      $beyond1,$x1,$k_half                    # 15e
        lqd     $x2,32($a_value)                        # 15o
            fnms    $bent0,$inverse0,$k_share,$k_one    # 16e
        lqd     $x3,48($a_value)                        # 16o
        fs      $beyond0,$x0,$k_half                    # 17e
        shlqbyi $a_value_3,$a_value,0                   # 17o copy
            fnms    $bent1,$inverse1,$k_share,$k_one    # 18e
            fnms    $bent3,$inverse3,$k_share,$k_one    # 19e
            fnms    $bent2,$inverse2,$k_share,$k_one    # 20e
            lnop                                        # 20o pairing
        fs      $beyond2,$x2,$k_half                    # 21e
next_four_back:
        brnz    $count,next_four                        # 21o
next_four_drain:
        fs      $beyond3,$x3,$k_half                    # 0e
        frest   $inverse1,$beyond1                      # 0o
        selb    $bent1,$x1_3,$bent1,$c_above1           # 1e
        frest   $inverse2,$beyond2                      # 1o
        selb    $bent3,$x3_2,$bent3,$c_above3           # 2e
        frest   $inverse0,$beyond0                      # 2o
        fcgt    $c_above1,$x1,$k_knee                   # 3e
        hbr     roll_off_return,$lr                     # 3o hint
        fi      $inverse1,$beyond1,$inverse1            # 4e
        shlqbyi $x1_3,$x1,0                             # 4o copy
        fi      $inverse2,$beyond2,$inverse2            # 5e
        shlqbyi $x3_2,$x3,0                             # 5o copy
        fi      $inverse0,$beyond0,$inverse0            # 6e
        frest   $inverse3,$beyond3                      # 6o
        selb    $bent2,$x2_3,$bent2,$c_above2           # 7e
        stqd    $bent1,16($a_value_4)                   # 7o
        selb    $bent0,$x0_3,$bent0,$c_above0           # 8e
        shlqbyi $a_value_5,$a_value_3,0                 # 8o copy
        fcgt    $c_above3,$x3,$k_knee                   # 9e
        shlqbyi $x2_3,$x2,0                             # 9o copy
        fi      $inverse3,$beyond3,$inverse3            # 10e
        stqd    $bent3,48($a_value_4)                   # 10o
        fcgt    $c_above2,$x2,$k_knee                   # 11e
        shlqbyi $x0_3,$x0,0                             # 11o copy
        fnms    $bent1,$inverse1,$k_share,$k_one        # 12e
        stqd    $bent2,32($a_value_4)                   # 12o
        fnms    $bent2,$inverse2,$k_share,$k_one        # 13e
        stqd    $bent0,0($a_value_4)                    # 13o
        fnms    $bent0,$inverse0,$k_share,$k_one        # 14e
        fcgt    $c_above0,$x0,$k_knee                   # 15e
        ai      $a_value,$a_value,64                    # 16e
        fnms    $bent3,$inverse3,$k_share,$k_one        # 17e
        selb    $bent1,$x1_3,$bent1,$c_above1           # 18e
        selb    $bent2,$x2_3,$bent2,$c_above2           # 19e
        selb    $bent0,$x0_3,$bent0,$c_above0           # 20e
        stqd    $bent1,16($a_value_5)                   # 20o
        selb    $bent3,$x3_2,$bent3,$c_above3           # 23e
        stqd    $bent3,48($a_value_5)                   # 25o
        stqd    $bent2,32($a_value_5)                   # 26o
        stqd    $bent0,0($a_value_5)                    # 27o
        nop     $127                                    # 28e pairing
roll_off_return:
        bi      $lr                                     # 28o
next_four_short:
        ai      $count,$count,-1                        # 0e
        lqd     $x0,0($a_value)                         # 0o
        lqd     $x1,16($a_value)                        # 1o
        lqd     $x2,32($a_value)                        # 2o
        lqd     $x3,48($a_value)                        # 3o
        fs      $beyond0,$x0,$k_half                    # 6e
        fs      $beyond1,$x1,$k_half                    # 7e
        fs      $beyond2,$x2,$k_half                    # 8e
        fs      $beyond3,$x3,$k_half                    # 9e
        fcgt    $c_above0,$x0,$k_knee                   # 10e
        fcgt    $c_above1,$x1,$k_knee                   # 11e
        lnop                                            # 11o pairing
        fcgt    $c_above2,$x2,$k_knee                   # 12e
        frest   $inverse0,$beyond0                      # 12o
        fcgt    $c_above3,$x3,$k_knee                   # 13e
        frest   $inverse1,$beyond1                      # 13o
        frest   $inverse2,$beyond2                      # 14o
        frest   $inverse3,$beyond3                      # 15o
        fi      $inverse0,$beyond0,$inverse0            # 16e
        fi      $inverse1,$beyond1,$inverse1            # 17e
        fi      $inverse2,$beyond2,$inverse2            # 18e
        fi      $inverse3,$beyond3,$inverse3            # 19e
        fnms    $bent0,$inverse0,$k_share,$k_one        # 23e
        fnms    $bent1,$inverse1,$k_share,$k_one        # 24e
        fnms    $bent2,$inverse2,$k_share,$k_one        # 25e
        fnms    $bent3,$inverse3,$k_share,$k_one        # 26e
        selb    $bent0,$x0,$bent0,$c_above0             # 29e
        selb    $bent1,$x1,$bent1,$c_above1             # 30e
        selb    $bent2,$x2,$bent2,$c_above2             # 31e
        stqd    $bent0,0($a_value)                      # 31o
        selb    $bent3,$x3,$bent3,$c_above3             # 32e
        stqd    $bent1,16($a_value)                     # 32o
        stqd    $bent2,32($a_value)                     # 33o
        stqd    $bent3,48($a_value)                     # 34o
        ai      $a_value,$a_value,64                    # 35e
        brnz    $count,next_four_short                  # 35o
        nop     $127                                    # 36e pairing
        bi      $lr                                     # 36o
endfunction roll_off
