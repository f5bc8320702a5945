# encode_srgb   linear light to sRGB's values
#   C       void encode_srgb(vec_float4 *values, int quads);
#   In      $3 values, 16-aligned, $4 quadwords (at least 1)
#   Out     the same place: the values, encoded
#   Uses    $2-$33, $79   Saves  -   Stack  0   Calls  -
#   Domain  any values: below 0 they stay below, above 1 they stay above
#   Error   0.12 of 1/255, of values from 0 to 1
#   Twin    lab/twins/src/display.rs
#
#   12.92 x                            up to 0.0031308
#   1.055 x^(1/2.4) - 0.055            above
# The power is a polynomial of degree 4 in x^(1/4), whose error is at most 0.013 of 1/255. The rest
# is the error of two roots of 12 bits.
# Scheduled by spu schedule from encode_srgb.s

        .include "work_unit.inc"
        .include "macros.inc"
        .include "math.inc"

        .set    NEXT,3
        registers a_value,count
        .set    NEXT,10
        registers k_edge,k_slope,k_0,k_1,k_2,k_3,k_4
        registers x,inverse,root,fourth,power,line,c_above

function encode_srgb
        .set count_2,79; .set a_value_2,2; .set x_2,20; .set a_value_3,5; .set x_3,6
        .set a_value_4,9; .set x_4,7; .set line_2,33; .set inverse_2,8; .set c_above_2,30
        .set x_5,19; .set line_3,17; .set c_above_3,21; .set x_6,22; .set inverse_3,23
        .set c_above_4,27; .set inverse_4,6; .set c_above_5,18; .set line_4,32; .set x_7,24
        .set line_5,7; .set root_2,8; .set a_value_5,31; .set root_3,6; .set line_6,26
        .set inverse_5,5; .set root_4,18; .set line_7,25; .set inverse_6,22; .set root_5,28
        .set c_above_6,24; .set a_value_6,29; .set fourth_2,2; .set fourth_3,28; .set fourth_4,8
        .set fourth_5,7; .set power_2,2; .set root_6,17; .set a_value_7,4; .set x_8,5
        .set c_above_7,8; .set line_8,19; .set a_value_8,22; .set line_9,4; .set root_7,5
        .set c_above_8,10; .set line_10,2; .set c_above_9,9; .set fourth_6,10; .set power_3,7
        .set line_11,11; .set c_above_10,20; .set fourth_7,5; .set fourth_8,21; .set power_4,23
        .set inverse_7,26; .set fourth_9,17; .set a_value_9,18; .set power_5,10; .set inverse_8,2
        .set power_6,6; .set fourth_10,18; .set power_7,5; .set line_12,20; .set c_above_11,3
        .set a_value_10,11; .set fourth_11,11; .set power_8,3
        ilhu    $k_edge,0x3b4d                          # 0e 0.0031308
        ilhu    $k_slope,0x414e                         # 1e 12.92
        ilhu    $k_0,0xbd85                             # 2e -0.0650813
        ilhu    $k_1,0x3e4c                             # 3e 0.1999536
        ilhu    $k_2,0x3f8e                             # 4e 1.1120896
        ilhu    $k_3,0xbea5                             # 5e -0.3234317
        ilhu    $k_4,0x3d9c                             # 6e 0.0764925
        clgti   $count_2,$count,5                       # 7e at least as many passes as overlap
        iohl    $k_edge,0x2e1c                          # 8e 0.0031308
        iohl    $k_slope,0xb852                         # 9e 12.92
        iohl    $k_0,0x4959                             # 10e -0.0650813
        iohl    $k_1,0xc0a4                             # 11e 0.1999536
        iohl    $k_2,0x58f4                             # 12e 1.1120896
        iohl    $k_3,0x98d6                             # 13e -0.3234317
        iohl    $k_4,0xa819                             # 14e 0.0764925
        brz     $count_2,next_quad_short                # 14o too few passes
        ai      $a_value_2,$a_value,16                  # 15e
        lqd     $x_2,0($a_value)                        # 15o
        ai      $count,$count,-1                        # 16e
        hbrr    next_quad_back,next_quad                # 16o hint
        ai      $a_value_3,$a_value_2,16                # 17e
        lqd     $x_3,0($a_value_2)                      # 17o
        ai      $count,$count,-1                        # 18e
        shlqbyi $a_value_4,$a_value,0                   # 18o copy
        ai      $a_value,$a_value_3,16                  # 19e
        lqd     $x_4,0($a_value_3)                      # 19o
        ai      $count,$count,-1                        # 20e
        shlqbyi $a_value_2,$a_value_2,0                 # 20o copy
        fm      $line_2,$x_2,$k_slope                   # 21e
        frsqest $inverse_2,$x_2                         # 21o
        fcgt    $c_above_2,$x_2,$k_edge                 # 22e
        shlqbyi $x_5,$x_2,0                             # 22o copy
        fm      $line_3,$x_3,$k_slope                   # 23e
        frsqest $inverse,$x_3                           # 23o
        fcgt    $c_above_3,$x_3,$k_edge                 # 24e
        shlqbyi $x_6,$x_3,0                             # 24o copy
        fi      $inverse_2,$x_2,$inverse_2              # 25e
        frsqest $inverse_3,$x_4                         # 25o
        fcgt    $c_above_4,$x_4,$k_edge                 # 26e
        shlqbyi $a_value_4,$a_value_4,0                 # 26o copy
        fi      $inverse_4,$x_3,$inverse                # 27e
        lqd     $x_2,0($a_value)                        # 27o
        ai      $count,$count,-1                        # 28e
        shlqbyi $c_above_5,$c_above_2,0                 # 28o copy
        fi      $inverse_3,$x_4,$inverse_3              # 29e
        shlqbyi $line_4,$line_2,0                       # 29o copy
        ai      $count,$count,-1                        # 30e
        shlqbyi $x_7,$x_4,0                             # 30o copy
        fm      $line_5,$x_4,$k_slope                   # 31e
        shlqbyi $c_above_3,$c_above_3,0                 # 31o copy
        fm      $root_2,$x_5,$inverse_2                 # 32e
        shlqbyi $a_value_5,$a_value_4,0                 # 32o copy
        fm      $line_2,$x_2,$k_slope                   # 33e
        shlqbyi $line_3,$line_3,0                       # 33o copy
        fm      $root_3,$x_6,$inverse_4                 # 34e
        shlqbyi $a_value_2,$a_value_2,0                 # 34o copy
        fcgt    $c_above_2,$x_2,$k_edge                 # 35e
        shlqbyi $c_above_5,$c_above_5,0                 # 35o copy
        fm      $root,$x_7,$inverse_3                   # 36e
        shlqbyi $line_6,$line_4,0                       # 36o copy
        shlqbyi $a_value_4,$a_value_3,0                 # 37o copy
        frsqest $inverse_5,$root_2                      # 38o
        ori     $c_above,$c_above_5,0                   # 39e copy
        shlqbyi $root_4,$root_2,0                       # 39o copy
        ori     $line_7,$line_6,0                       # 40e copy
        frsqest $inverse_6,$root_3                      # 40o
        nop     $127                                    # 41e pairing
        shlqbyi $root_5,$root_3,0                       # 41o copy
        fi      $inverse_5,$root_2,$inverse_5           # 42e
        shlqbyi $c_above_6,$c_above_3,0                 # 42o copy
        nop     $127                                    # 43e pairing
        shlqbyi $line_6,$line_3,0                       # 43o copy
        fi      $inverse_2,$root_3,$inverse_6           # 44e
        shlqbyi $c_above_4,$c_above_4,0                 # 44o copy
        shlqbyi $a_value_6,$a_value_5,0                 # 45o copy
        shlqbyi $a_value_5,$a_value_2,0                 # 46o copy
        shlqbyi $line_4,$line_5,0                       # 47o copy
        frsqest $inverse_4,$x_2                         # 48o
        fm      $fourth_2,$root_4,$inverse_5            # 49e
        fm      $fourth_3,$root_5,$inverse_2            # 51e
        fma     $power,$k_4,$fourth_2,$k_3              # 55e
        shlqbyi $fourth_4,$fourth_2,0                   # 55o copy
        shlqbyi $fourth_5,$fourth_2,0                   # 56o copy
        fma     $power,$power,$fourth_2,$k_2            # 61e
        fma     $power_2,$power,$fourth_4,$k_1          # 67e
        lnop                                            # 67o pairing
next_quad:
            fma     $power,$k_4,$fourth_3,$k_3          # 0e
            frsqest $inverse,$root                      # 0o
            fma     $power_2,$power_2,$fourth_5,$k_0    # 1e
            shlqbyi $a_value_3,$a_value_4,0             # 1o copy
            fi      $inverse_4,$x_2,$inverse_4          # 2e
            shlqbyi $fourth_5,$fourth_3,0               # 2o copy
        ai      $count,$count,-1                        # 3e
            shlqbyi $fourth_4,$fourth_3,0               # 3o copy
            fi      $inverse,$root,$inverse             # 4e
            shlqbyi $a_value_4,$a_value,0               # 4o copy
            ai      $a_value,$a_value,16                # 5e
            shlqbyi $root_6,$root,0                     # 5o copy
            fma     $power,$power,$fourth_3,$k_2        # 6e
            shlqbyi $x_5,$x_2,0                         # 6o copy
            selb    $line,$line_7,$power_2,$c_above     # 7e
            lqd     $x_2,0($a_value)                    # 7o
            ori     $c_above,$c_above_6,0               # 8e copy
            shlqbyi $c_above_6,$c_above_4,0             # 8o copy
            ori     $line_7,$line_6,0                   # 9e copy
            shlqbyi $line_6,$line_4,0                   # 9o copy
            fm      $root,$x_5,$inverse_4               # 10e
            shlqbyi $c_above_4,$c_above_2,0             # 10o copy
            fm      $fourth_3,$root_6,$inverse          # 11e
            stqd    $line,0($a_value_6)                 # 11o
            fma     $power_2,$power,$fourth_4,$k_1      # 12e
            shlqbyi $a_value_6,$a_value_5,0             # 12o copy
            fcgt    $c_above_2,$x_2,$k_edge             # 13e
            shlqbyi $a_value_5,$a_value_3,0             # 13o copy
            nop     $127                                # 14e pairing
            shlqbyi $line_4,$line_2,0                   # 14o copy
            fm      $line_2,$x_2,$k_slope               # 15e
            frsqest $inverse_4,$x_2                     # 15o
        nop     $127                                    # 16e pairing
next_quad_back:
        brnz    $count,next_quad                        # 16o
next_quad_drain:
        ai      $a_value_7,$a_value,16                  # 0e
        shlqbyi $x_8,$x_2,0                             # 0o copy
        fi      $inverse_4,$x_2,$inverse_4              # 1e
        frsqest $inverse,$root                          # 1o
        ori     $c_above_7,$c_above_6,0                 # 2e copy
        lqd     $x_2,0($a_value_7)                      # 2o
        fma     $power,$k_4,$fourth_3,$k_3              # 3e
        shlqbyi $root_6,$root,0                         # 3o copy
        fma     $power_2,$power_2,$fourth_5,$k_0        # 4e
        shlqbyi $a_value,$a_value,0                     # 4o copy
        fi      $inverse,$root,$inverse                 # 5e
        shlqbyi $fourth_5,$fourth_3,0                   # 5o copy
        ori     $line_8,$line_6,0                       # 6e copy
        shlqbyi $a_value_8,$a_value_7,0                 # 6o copy
        ai      $a_value_7,$a_value_7,16                # 7e
        shlqbyi $line_9,$line_2,0                       # 7o copy
        fm      $root_7,$x_8,$inverse_4                 # 8e
        frsqest $inverse_4,$x_2                         # 8o
        fma     $power,$power,$fourth_3,$k_2            # 9e
        shlqbyi $x_7,$x_2,0                             # 9o copy
        fm      $line_2,$x_2,$k_slope                   # 10e
        shlqbyi $a_value,$a_value,0                     # 10o copy
        fcgt    $c_above_8,$x_2,$k_edge                 # 11e
        shlqbyi $line_6,$line_9,0                       # 11o copy
        fi      $inverse_4,$x_2,$inverse_4              # 12e
        shlqbyi $a_value_7,$a_value_4,0                 # 12o copy
        selb    $line_10,$line_7,$power_2,$c_above      # 13e
        shlqbyi $c_above_9,$c_above_8,0                 # 13o copy
        fm      $fourth_6,$root_6,$inverse              # 14e
        shlqbyi $root_6,$root_7,0                       # 14o copy
        fma     $power_3,$power,$fourth_5,$k_1          # 15e
        frsqest $inverse,$root_7                        # 15o
        ori     $line_7,$line_6,0                       # 16e copy
        shlqbyi $line_11,$line_2,0                      # 16o copy
        shlqbyi $a_value_7,$a_value_7,0                 # 17o copy
        shlqbyi $a_value,$a_value,0                     # 18o copy
        fm      $root_3,$x_7,$inverse_4                 # 19e
        shlqbyi $c_above_10,$c_above_2,0                # 19o copy
        fi      $inverse,$root_7,$inverse               # 20e
        shlqbyi $fourth_7,$fourth_6,0                   # 20o copy
        nop     $127                                    # 21e pairing
        shlqbyi $fourth_8,$fourth_6,0                   # 21o copy
        fma     $power_4,$k_4,$fourth_6,$k_3            # 22e
        hbr     encode_srgb_return,$lr                  # 22o hint
        shlqbyi $c_above_6,$c_above_10,0                # 23o copy
        shlqbyi $fourth,$fourth_3,0                     # 24o copy
        frsqest $inverse_7,$root_3                      # 25o
        shlqbyi $root_5,$root_3,0                       # 26o copy
        fm      $fourth_9,$root_6,$inverse              # 27e
        shlqbyi $a_value_9,$a_value_8,0                 # 27o copy
        fma     $power_5,$power_4,$fourth_6,$k_2        # 28e
        stqd    $line_10,0($a_value_6)                  # 28o
        fi      $inverse_8,$root_3,$inverse_7           # 29e
        shlqbyi $line_6,$line_4,0                       # 29o copy
        ori     $c_above,$c_above_6,0                   # 30e copy
        shlqbyi $c_above_6,$c_above_4,0                 # 30o copy
        fma     $power_6,$power_3,$fourth,$k_0          # 31e
        shlqbyi $a_value_6,$a_value_7,0                 # 31o copy
        nop     $127                                    # 32e pairing
        shlqbyi $a_value_7,$a_value_9,0                 # 32o copy
        fma     $power_3,$k_4,$fourth_9,$k_3            # 33e
        shlqbyi $fourth_10,$fourth_9,0                  # 33o copy
        fma     $power_7,$power_5,$fourth_7,$k_1        # 34e
        shlqbyi $fourth_6,$fourth_9,0                   # 34o copy
        ori     $line_12,$line_6,0                      # 35e copy
        shlqbyi $line_6,$line_11,0                      # 35o copy
        fm      $fourth_3,$root_5,$inverse_8            # 36e
        shlqbyi $a_value_2,$a_value,0                   # 36o copy
        ori     $c_above_11,$c_above_6,0                # 37e copy
        shlqbyi $a_value_10,$a_value_5,0                # 37o copy
        selb    $line,$line_8,$power_6,$c_above_7       # 38e
        shlqbyi $c_above_6,$c_above_9,0                 # 38o copy
        fma     $power_6,$power_3,$fourth_9,$k_2        # 39e
        shlqbyi $a_value_7,$a_value_7,0                 # 39o copy
        fma     $power_7,$power_7,$fourth_8,$k_0        # 40e
        lnop                                            # 40o pairing
        ori     $line_5,$line_6,0                       # 41e copy
        stqd    $line,0($a_value_10)                    # 41o
        fma     $power,$k_4,$fourth_3,$k_3              # 42e
        shlqbyi $fourth_4,$fourth_3,0                   # 42o copy
        ori     $c_above_9,$c_above_6,0                 # 43e copy
        shlqbyi $fourth_11,$fourth_3,0                  # 43o copy
        fma     $power_6,$power_6,$fourth_6,$k_1        # 45e
        selb    $line,$line_12,$power_7,$c_above_11     # 46e
        fma     $power,$power,$fourth_3,$k_2            # 48e
        stqd    $line,0($a_value_6)                     # 48o
        fma     $power_8,$power_6,$fourth_10,$k_0       # 51e
        fma     $power_7,$power,$fourth_4,$k_1          # 54e
        selb    $line,$line_7,$power_8,$c_above         # 57e
        stqd    $line,0($a_value_2)                     # 59o
        fma     $power_2,$power_7,$fourth_11,$k_0       # 60e
        selb    $line,$line_5,$power_2,$c_above_9       # 66e
        stqd    $line,0($a_value_7)                     # 68o
encode_srgb_return:
        bi      $lr                                     # 69o
next_quad_short:
        ai      $count,$count,-1                        # 0e
        lqd     $x,0($a_value)                          # 0o
        fm      $line,$x,$k_slope                       # 6e
        frsqest $inverse,$x                             # 6o
        fcgt    $c_above,$x,$k_edge                     # 7e
        fi      $inverse,$x,$inverse                    # 10e
        fm      $root,$x,$inverse                       # 17e
        frsqest $inverse,$root                          # 23o
        fi      $inverse,$root,$inverse                 # 27e
        fm      $fourth,$root,$inverse                  # 34e
        fma     $power,$k_4,$fourth,$k_3                # 40e
        fma     $power,$power,$fourth,$k_2              # 46e
        fma     $power,$power,$fourth,$k_1              # 52e
        fma     $power,$power,$fourth,$k_0              # 58e
        selb    $line,$line,$power,$c_above             # 64e
        stqd    $line,0($a_value)                       # 66o
        ai      $a_value,$a_value,16                    # 67e
        brnz    $count,next_quad_short                  # 67o
        nop     $127                                    # 68e pairing
        bi      $lr                                     # 68o
endfunction encode_srgb
