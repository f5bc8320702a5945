# roll_off   limits light to less than 1 without a step
#   C       void roll_off(vec_float4 *values, int quads);
#   In      $3 values, 16-aligned, $4 quadwords (at least 1)
#   Out     the same place: the values
#   Uses    $2-$23, $79   Saves  -   Stack  0   Calls  -
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
        registers k_knee,k_half,k_share,k_one,x,beyond,inverse,bent,c_above

function roll_off
        .set count_2,79; .set a_value_2,2; .set a_value_3,7; .set x_2,5; .set a_value_4,19
        .set x_3,8; .set beyond_2,16; .set x_4,6; .set c_above_2,21; .set a_value_5,9
        .set beyond_3,14; .set x_5,17; .set c_above_3,22; .set c_above_4,5; .set beyond_4,18
        .set x_6,19; .set a_value_6,15; .set inverse_2,20; .set c_above_5,6; .set x_7,2
        .set inverse_3,23; .set inverse_4,17; .set x_8,7; .set c_above_6,16; .set bent_2,8
        .set beyond_5,7; .set inverse_5,4; .set x_9,9; .set beyond_6,17; .set a_value_7,20
        .set beyond_7,11; .set c_above_7,20; .set x_10,21; .set c_above_8,9; .set x_11,10
        .set bent_3,5; .set a_value_8,8; .set inverse_6,19; .set bent_4,4; .set inverse_7,9
        .set bent_5,2; .set x_12,3; .set bent_6,9; .set a_value_9,11
        clgti   $count_2,$count,5                       # 0e at least as many passes as overlap
        ilhu    $k_knee,0x3f40                          # 1e 3/4
        ilhu    $k_half,0x3f00                          # 2e
        ilhu    $k_share,0x3d80                         # 3e 1/16
        ilhu    $k_one,0x3f80                           # 4e
        brz     $count_2,next_quad_short                # 4o too few passes
        ai      $a_value_2,$a_value,16                  # 5e
        lqd     $x,0($a_value)                          # 5o
        ai      $count,$count,-1                        # 6e
        hbrr    next_quad_back,next_quad                # 6o hint
        ai      $a_value_3,$a_value_2,16                # 7e
        lqd     $x_2,0($a_value_2)                      # 7o
        ai      $count,$count,-1                        # 8e
        shlqbyi $a_value_4,$a_value,0                   # 8o copy
        ai      $a_value,$a_value_3,16                  # 9e
        lqd     $x_3,0($a_value_3)                      # 9o
        ai      $count,$count,-1                        # 10e
        shlqbyi $a_value_2,$a_value_2,0                 # 10o copy
        fs      $beyond_2,$x,$k_half                    # 11e
        shlqbyi $x_4,$x,0                               # 11o copy
        fcgt    $c_above_2,$x,$k_knee                   # 12e
        shlqbyi $a_value_5,$a_value_4,0                 # 12o copy
        fs      $beyond_3,$x_2,$k_half                  # 13e
        shlqbyi $x_5,$x_2,0                             # 13o copy
        fcgt    $c_above_3,$x_2,$k_knee                 # 14e
        shlqbyi $c_above_4,$c_above_2,0                 # 14o copy
        fs      $beyond_4,$x_3,$k_half                  # 15e
        shlqbyi $x_6,$x_4,0                             # 15o copy
        ai      $count,$count,-1                        # 16e
        shlqbyi $a_value_6,$a_value_2,0                 # 16o copy
        ori     $a_value_5,$a_value_5,0                 # 17e copy
        frest   $inverse_2,$beyond_2                    # 17o
        ori     $c_above_5,$c_above_4,0                 # 18e copy
        shlqbyi $beyond_2,$beyond_2,0                   # 18o copy
        ori     $x_7,$x_6,0                             # 19e copy
        frest   $inverse_3,$beyond_3                    # 19o
        ai      $count,$count,-1                        # 20e
        shlqbyi $beyond_3,$beyond_3,0                   # 20o copy
        fcgt    $c_above_2,$x_3,$k_knee                 # 21e
        shlqbyi $x_2,$x_5,0                             # 21o copy
        fi      $inverse_4,$beyond_2,$inverse_2         # 22e
        shlqbyi $a_value_4,$a_value_3,0                 # 22o copy
        nop     $127                                    # 23e pairing
        shlqbyi $x_8,$x_3,0                             # 23o copy
        fi      $inverse_2,$beyond_3,$inverse_3         # 24e
        shlqbyi $c_above_6,$c_above_3,0                 # 24o copy
        fnms    $bent_2,$inverse_4,$k_share,$k_one      # 29e
        lnop                                            # 29o pairing
next_quad:
            selb    $bent,$x_7,$bent_2,$c_above_5       # 0e
            lqd     $x,0($a_value)                      # 0o
            ori     $x_7,$x_2,0                         # 1e copy
            shlqbyi $x_2,$x_8,0                         # 1o copy
            ori     $c_above_5,$c_above_6,0             # 2e copy
            frest   $inverse,$beyond_4                  # 2o
        ai      $count,$count,-1                        # 3e
            shlqbyi $beyond_5,$beyond_4,0               # 3o copy
            fnms    $bent_2,$inverse_2,$k_share,$k_one  # 4e
            stqd    $bent,0($a_value_5)                 # 4o
            ori     $a_value_5,$a_value_6,0             # 5e copy
            shlqbyi $a_value_6,$a_value_4,0             # 5o copy
            fs      $beyond_4,$x,$k_half                # 6e
            shlqbyi $a_value_4,$a_value,0               # 6o copy
            fi      $inverse_2,$beyond_5,$inverse       # 7e
            shlqbyi $x_8,$x,0                           # 7o copy
            ai      $a_value,$a_value,16                # 8e
            shlqbyi $c_above_6,$c_above_2,0             # 8o copy
            fcgt    $c_above_2,$x,$k_knee               # 9e
next_quad_back:
        brnz    $count,next_quad                        # 9o
next_quad_drain:
        selb    $bent,$x_7,$bent_2,$c_above_5           # 0e
        lqd     $x,0($a_value)                          # 0o
        ai      $a_value_2,$a_value,16                  # 1e
        frest   $inverse_5,$beyond_4                    # 1o
        ori     $c_above_5,$c_above_6,0                 # 2e copy
        stqd    $bent,0($a_value_5)                     # 2o
        fnms    $bent_2,$inverse_2,$k_share,$k_one      # 3e
        lqd     $x_9,0($a_value_2)                      # 3o
        ori     $a_value_6,$a_value_6,0                 # 4e copy
        hbr     roll_off_return,$lr                     # 4o hint
        ori     $x_2,$x_2,0                             # 5e copy
        shlqbyi $c_above_6,$c_above_2,0                 # 5o copy
        fs      $beyond_6,$x,$k_half                    # 6e
        shlqbyi $a_value_4,$a_value_4,0                 # 6o copy
        fcgt    $c_above_2,$x,$k_knee                   # 7e
        shlqbyi $x,$x,0                                 # 7o copy
        ai      $a_value_7,$a_value_2,16                # 8e
        shlqbyi $beyond_4,$beyond_4,0                   # 8o copy
        fs      $beyond_7,$x_9,$k_half                  # 9e
        shlqbyi $c_above_7,$c_above_2,0                 # 9o copy
        ori     $c_above_6,$c_above_6,0                 # 10e copy
        shlqbyi $x_10,$x_9,0                            # 10o copy
        fcgt    $c_above_8,$x_9,$k_knee                 # 11e
        shlqbyi $x_11,$x,0                              # 11o copy
        fi      $inverse_5,$beyond_4,$inverse_5         # 12e
        shlqbyi $beyond_3,$beyond_6,0                   # 12o copy
        ori     $c_above,$c_above_7,0                   # 13e copy
        frest   $inverse_4,$beyond_6                    # 13o
        selb    $bent_3,$x_2,$bent_2,$c_above_5         # 14e
        shlqbyi $x_4,$x_10,0                            # 14o copy
        ori     $a_value_8,$a_value_4,0                 # 15e copy
        frest   $inverse_6,$beyond_7                    # 15o
        ori     $x_11,$x_11,0                           # 16e copy
        shlqbyi $beyond_7,$beyond_7,0                   # 16o copy
        fi      $inverse_2,$beyond_3,$inverse_4         # 17e
        stqd    $bent_3,0($a_value_6)                   # 17o
        ori     $x_2,$x_4,0                             # 18e copy
        shlqbyi $c_above_5,$c_above_8,0                 # 18o copy
        fnms    $bent_4,$inverse_5,$k_share,$k_one      # 19e
        shlqbyi $a_value,$a_value,0                     # 19o copy
        fi      $inverse_7,$beyond_7,$inverse_6         # 20e
        shlqbyi $x_8,$x_8,0                             # 20o copy
        shlqbyi $a_value_4,$a_value_2,0                 # 21o copy
        ori     $c_above_5,$c_above_5,0                 # 22e copy
        shlqbyi $a_value_6,$a_value,0                   # 23o copy
        fnms    $bent_5,$inverse_2,$k_share,$k_one      # 24e
        ori     $x_12,$x_8,0                            # 25e copy
        shlqbyi $a_value_3,$a_value_4,0                 # 25o copy
        fnms    $bent_6,$inverse_7,$k_share,$k_one      # 27e
        ori     $a_value_9,$a_value_6,0                 # 28e copy
        selb    $bent,$x_12,$bent_4,$c_above_6          # 29e
        selb    $bent_5,$x_11,$bent_5,$c_above          # 30e
        ori     $a_value,$a_value_3,0                   # 31e copy
        stqd    $bent,0($a_value_8)                     # 31o
        stqd    $bent_5,0($a_value_9)                   # 32o
        selb    $bent,$x_2,$bent_6,$c_above_5           # 33e
        stqd    $bent,0($a_value)                       # 35o
roll_off_return:
        bi      $lr                                     # 36o
next_quad_short:
        ai      $count,$count,-1                        # 0e
        lqd     $x,0($a_value)                          # 0o
        fs      $beyond,$x,$k_half                      # 6e
        fcgt    $c_above,$x,$k_knee                     # 7e
        frest   $inverse,$beyond                        # 12o
        fi      $inverse,$beyond,$inverse               # 16e
        fnms    $bent,$inverse,$k_share,$k_one          # 23e
        selb    $bent,$x,$bent,$c_above                 # 29e
        nop     $127                                    # 30e pairing
        stqd    $bent,0($a_value)                       # 31o
        ai      $a_value,$a_value,16                    # 32e
        brnz    $count,next_quad_short                  # 32o
        nop     $127                                    # 33e pairing
        bi      $lr                                     # 33o
endfunction roll_off
