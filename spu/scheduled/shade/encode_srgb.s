# encode_srgb   linear light to sRGB's values
#   C       void encode_srgb(vec_float4 *values, int quads);
#   In      $3 values, 16-aligned, $4 quadwords (even, at least 2)
#   Out     the same place: the values, encoded
#   Uses    $2-$40, $79   Saves  -   Stack  0   Calls  -
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
        registers x0,x1,inverse0,inverse1,root0,root1,power0,power1,line0,line1
        registers c_above0,c_above1,fourth0,fourth1

function encode_srgb
        .set count_2,79; .set a_value_2,2; .set x0_2,5; .set x1_2,6; .set x0_3,7; .set x1_3,9
        .set a_value_3,8; .set line0_2,32; .set inverse0_2,17; .set line1_2,19; .set inverse1_2,25
        .set c_above0_2,38; .set inverse0_3,20; .set inverse1_3,21; .set inverse0_4,22
        .set line0_3,31; .set inverse1_4,23; .set c_above0_3,35; .set c_above0_4,24
        .set a_value_4,29; .set c_above1_2,30; .set inverse0_5,8; .set root0_2,5
        .set inverse1_5,28; .set root1_2,40; .set a_value_5,6; .set line0_4,27; .set c_above0_5,34
        .set inverse1_6,33; .set inverse0_6,2; .set inverse1_7,7; .set inverse0_7,9
        .set line1_3,36; .set c_above1_3,37; .set a_value_6,39; .set power0_2,19; .set fourth0_2,9
        .set power1_2,23; .set c_above1_4,5; .set line1_4,7; .set fourth1_2,8; .set line1_5,24
        .set root0_3,2; .set root1_3,4; .set a_value_7,5; .set fourth1_3,7; .set c_above1_5,17
        .set line1_6,20; .set fourth0_3,10; .set power1_3,11; .set fourth1_4,18; .set line0_5,21
        .set c_above0_6,22; .set c_above1_6,23; .set line1_7,8; .set fourth0_4,2; .set line1_8,5
        .set c_above1_7,4; .set line0_6,9; .set power1_4,7; .set c_above0_7,11; .set power0_3,8
        .set fourth0_5,17; .set power1_5,15; .set fourth1_5,16; .set line1_9,4
        rotmi   $count,$count,-1                        # 0e pairs
        ilhu    $k_edge,0x3b4d                          # 1e 0.0031308
        ilhu    $k_slope,0x414e                         # 2e 12.92
        ilhu    $k_0,0xbd85                             # 3e -0.0650813
        ilhu    $k_1,0x3e4c                             # 4e 0.1999536
        ilhu    $k_2,0x3f8e                             # 5e 1.1120896
        ilhu    $k_3,0xbea5                             # 6e -0.3234317
        ilhu    $k_4,0x3d9c                             # 7e 0.0764925
        clgti   $count_2,$count,3                       # 8e at least as many passes as overlap
        iohl    $k_edge,0x2e1c                          # 9e 0.0031308
        iohl    $k_slope,0xb852                         # 10e 12.92
        iohl    $k_0,0x4959                             # 11e -0.0650813
        iohl    $k_1,0xc0a4                             # 12e 0.1999536
        iohl    $k_2,0x58f4                             # 13e 1.1120896
        iohl    $k_3,0x98d6                             # 14e -0.3234317
        lnop                                            # 14o pairing
        iohl    $k_4,0xa819                             # 15e 0.0764925
        brz     $count_2,next_pair_short                # 15o too few passes
        ai      $a_value_2,$a_value,32                  # 16e
        lqd     $x0_2,0($a_value)                       # 16o
        ai      $count,$count,-1                        # 17e
        lqd     $x1_2,16($a_value)                      # 17o
        nop     $127                                    # 18e pairing
        lqd     $x0_3,0($a_value_2)                     # 18o
        ai      $count,$count,-1                        # 19e
        lqd     $x1_3,16($a_value_2)                    # 19o
        nop     $127                                    # 20e pairing
        shlqbyi $a_value_3,$a_value,0                   # 20o copy
        ai      $a_value,$a_value_2,32                  # 21e
        hbrr    next_pair_back,next_pair                # 21o hint
        fm      $line0_2,$x0_2,$k_slope                 # 22e
        frsqest $inverse0_2,$x0_2                       # 22o
        fm      $line1_2,$x1_2,$k_slope                 # 23e
        frsqest $inverse1_2,$x1_2                       # 23o
        fcgt    $c_above0_2,$x0_2,$k_edge               # 24e
        frsqest $inverse0_3,$x0_3                       # 24o
        fcgt    $c_above1,$x1_2,$k_edge                 # 25e
        frsqest $inverse1_3,$x1_3                       # 25o
        fi      $inverse0_4,$x0_2,$inverse0_2           # 26e
        lqd     $x0,0($a_value)                         # 26o
        fi      $inverse1_2,$x1_2,$inverse1_2           # 27e
        lqd     $x1,16($a_value)                        # 27o
        fi      $inverse0_3,$x0_3,$inverse0_3           # 28e
        shlqbyi $line0_3,$line0_2,0                     # 28o copy
        fi      $inverse1_4,$x1_3,$inverse1_3           # 29e
        shlqbyi $c_above0_3,$c_above0_2,0               # 29o copy
        fcgt    $c_above0_4,$x0_3,$k_edge               # 30e
        shlqbyi $a_value_4,$a_value_3,0                 # 30o copy
        fm      $line0_2,$x0_3,$k_slope                 # 31e
        shlqbyi $c_above1_2,$c_above1,0                 # 31o copy
        fm      $line1,$x1_3,$k_slope                   # 32e
        frsqest $inverse0_5,$x0                         # 32o
        fm      $root0_2,$x0_2,$inverse0_4              # 33e
        frsqest $inverse1_5,$x1                         # 33o
        fm      $root1_2,$x1_2,$inverse1_2              # 34e
        shlqbyi $line1_2,$line1_2,0                     # 34o copy
        fm      $root0,$x0_3,$inverse0_3                # 35e
        shlqbyi $a_value_5,$a_value_2,0                 # 35o copy
        fm      $root1,$x1_3,$inverse1_4                # 36e
        shlqbyi $line0_4,$line0_3,0                     # 36o copy
        fi      $inverse0_5,$x0,$inverse0_5             # 37e
        shlqbyi $line0_3,$line0_2,0                     # 37o copy
        fi      $inverse1_2,$x1,$inverse1_5             # 38e
        shlqbyi $c_above0_5,$c_above0_3,0               # 38o copy
        fcgt    $c_above1,$x1_3,$k_edge                 # 39e
        frsqest $inverse0_3,$root0_2                    # 39o
        fm      $line0_2,$x0,$k_slope                   # 40e
        frsqest $inverse1_6,$root1_2                    # 40o
        ai      $count,$count,-1                        # 41e
        frsqest $inverse0_6,$root0                      # 41o
        fcgt    $c_above0_2,$x0,$k_edge                 # 42e
        frsqest $inverse1_7,$root1                      # 42o
        fi      $inverse0_7,$root0_2,$inverse0_3        # 43e
        shlqbyi $c_above0_3,$c_above0_4,0               # 43o copy
        fi      $inverse1_4,$root1_2,$inverse1_6        # 44e
        shlqbyi $line1_3,$line1_2,0                     # 44o copy
        fi      $inverse0_3,$root0,$inverse0_6          # 45e
        shlqbyi $c_above1_3,$c_above1_2,0               # 45o copy
        fi      $inverse1_6,$root1,$inverse1_7          # 46e
        shlqbyi $a_value_6,$a_value_4,0                 # 46o copy
        fm      $fourth0,$root0_2,$inverse0_7           # 50e
        fm      $fourth1,$root1_2,$inverse1_4           # 51e
        fma     $power0_2,$k_4,$fourth0,$k_3            # 56e
        shlqbyi $fourth0_2,$fourth0,0                   # 56o copy
        fma     $power1_2,$k_4,$fourth1,$k_3            # 57e
        fma     $power0_2,$power0_2,$fourth0,$k_2       # 62e
        fma     $power1,$power1_2,$fourth1,$k_2         # 63e
        fma     $power0_2,$power0_2,$fourth0,$k_1       # 68e
next_pair:
            fm      $fourth0,$root0,$inverse0_3         # 0e
            shlqbyi $a_value_2,$a_value_5,0             # 0o copy
            fm      $root0,$x0,$inverse0_5              # 1e
            shlqbyi $c_above1_4,$c_above1,0             # 1o copy
            fcgt    $c_above1,$x1,$k_edge               # 2e
            shlqbyi $a_value_5,$a_value,0               # 2o copy
            ai      $a_value,$a_value,32                # 3e
            shlqbyi $line1_4,$line1,0                   # 3o copy
            fm      $line1,$x1,$k_slope                 # 4e
            shlqbyi $fourth1_2,$fourth1,0               # 4o copy
            fma     $power1,$power1,$fourth1,$k_1       # 5e
        lqd     $x0,0($a_value)                         # 5o
            fma     $power0,$power0_2,$fourth0_2,$k_0   # 6e
            shlqbyi $fourth0_2,$fourth0,0               # 6o copy
            fm      $fourth1,$root1,$inverse1_6         # 7e
            lnop                                        # 7o pairing
            fm      $root1,$x1,$inverse1_2              # 8e
        lqd     $x1,16($a_value)                        # 8o
            fma     $power0_2,$k_4,$fourth0,$k_3        # 9e
            frsqest $inverse0_3,$root0                  # 9o
        ai      $count,$count,-1                        # 10e
        lnop                                            # 10o pairing
            fma     $power1,$power1,$fourth1_2,$k_0     # 11e
        frsqest $inverse0_5,$x0                         # 11o
            selb    $line0,$line0_4,$power0,$c_above0_5 # 12e
            shlqbyi $line0_4,$line0_3,0                 # 12o copy
            fma     $power1_2,$k_4,$fourth1,$k_3        # 13e
            shlqbyi $line0_3,$line0_2,0                 # 13o copy
        fm      $line0_2,$x0,$k_slope                   # 14e
            stqd    $line0,0($a_value_6)                # 14o
            fma     $power0_2,$power0_2,$fourth0,$k_2   # 15e
        frsqest $inverse1_2,$x1                         # 15o
            fi      $inverse0_3,$root0,$inverse0_3      # 16e
            frsqest $inverse1_6,$root1                  # 16o
            selb    $line1_5,$line1_3,$power1,$c_above1_3 # 17e
            shlqbyi $c_above0_5,$c_above0_3,0           # 17o copy
        fi      $inverse0_5,$x0,$inverse0_5             # 18e
            shlqbyi $c_above0_3,$c_above0_2,0           # 18o copy
        fi      $inverse1_2,$x1,$inverse1_2             # 19e
            shlqbyi $line1_3,$line1_4,0                 # 19o copy
            fi      $inverse1_6,$root1,$inverse1_6      # 20e
            shlqbyi $c_above1_3,$c_above1_4,0           # 20o copy
        fcgt    $c_above0_2,$x0,$k_edge                 # 21e
            stqd    $line1_5,16($a_value_6)             # 21o
            fma     $power0_2,$power0_2,$fourth0,$k_1   # 22e
            shlqbyi $a_value_6,$a_value_2,0             # 22o copy
            fma     $power1,$power1_2,$fourth1,$k_2     # 23e
next_pair_back:
        brnz    $count,next_pair                        # 23o
next_pair_drain:
        fm      $root0_3,$x0,$inverse0_5                # 0e
        shlqbyi $fourth1_2,$fourth1,0                   # 0o copy
        fm      $root1_3,$x1,$inverse1_2                # 1e
        hbr     encode_srgb_return,$lr                  # 1o hint
        fm      $fourth0,$root0,$inverse0_3             # 2e
        shlqbyi $a_value_7,$a_value,0                   # 2o copy
        fm      $fourth1_3,$root1,$inverse1_6           # 3e
        shlqbyi $c_above1_5,$c_above1,0                 # 3o copy
        fma     $power1,$power1,$fourth1,$k_1           # 4e
        shlqbyi $line1_6,$line1,0                       # 4o copy
        fm      $line1,$x1,$k_slope                     # 5e
        shlqbyi $a_value_5,$a_value_5,0                 # 5o copy
        fma     $power0,$power0_2,$fourth0_2,$k_0       # 6e
        frsqest $inverse0_7,$root0_3                    # 6o
        fcgt    $c_above1,$x1,$k_edge                   # 7e
        frsqest $inverse1_6,$root1_3                    # 7o
        fma     $power0_2,$k_4,$fourth0,$k_3            # 8e
        shlqbyi $fourth0_3,$fourth0,0                   # 8o copy
        fma     $power1_3,$k_4,$fourth1_3,$k_3          # 9e
        shlqbyi $fourth1_4,$fourth1_3,0                 # 9o copy
        fi      $inverse0_7,$root0_3,$inverse0_7        # 10e
        shlqbyi $line0_5,$line0_2,0                     # 10o copy
        fi      $inverse1_6,$root1_3,$inverse1_6        # 11e
        shlqbyi $c_above0_6,$c_above0_2,0               # 11o copy
        selb    $line0,$line0_4,$power0,$c_above0_5     # 12e
        shlqbyi $c_above1_6,$c_above1,0                 # 12o copy
        fma     $power1,$power1,$fourth1_2,$k_0         # 13e
        shlqbyi $line1_7,$line1,0                       # 13o copy
        fma     $power0_2,$power0_2,$fourth0,$k_2       # 14e
        shlqbyi $line0_4,$line0_3,0                     # 14o copy
        fma     $power1_3,$power1_3,$fourth1_3,$k_2     # 15e
        shlqbyi $c_above0_5,$c_above0_3,0               # 15o copy
        ai      $a_value,$a_value,32                    # 16e
        shlqbyi $a_value,$a_value_7,0                   # 16o copy
        fm      $fourth0_4,$root0_3,$inverse0_7         # 17e
        shlqbyi $line1_8,$line1_6,0                     # 17o copy
        fm      $fourth1,$root1_3,$inverse1_6           # 18e
        shlqbyi $c_above1_7,$c_above1_5,0               # 18o copy
        selb    $line1_5,$line1_3,$power1,$c_above1_3   # 19e
        shlqbyi $a_value_5,$a_value_5,0                 # 19o copy
        fma     $power0_2,$power0_2,$fourth0,$k_1       # 20e
        shlqbyi $line0_6,$line0_5,0                     # 20o copy
        fma     $power1_4,$power1_3,$fourth1_3,$k_1     # 21e
        shlqbyi $c_above0_7,$c_above0_6,0               # 21o copy
        nop     $127                                    # 22e pairing
        shlqbyi $line1_3,$line1_7,0                     # 22o copy
        fma     $power0_3,$k_4,$fourth0_4,$k_3          # 23e
        shlqbyi $fourth0_5,$fourth0_4,0                 # 23o copy
        fma     $power1_5,$k_4,$fourth1,$k_3            # 24e
        shlqbyi $fourth1_5,$fourth1,0                   # 24o copy
        nop     $127                                    # 25e pairing
        shlqbyi $c_above1_3,$c_above1_6,0               # 25o copy
        fma     $power0,$power0_2,$fourth0_3,$k_0       # 26e
        stqd    $line0,0($a_value_6)                    # 26o
        fma     $power1_4,$power1_4,$fourth1_4,$k_0     # 27e
        shlqbyi $a_value,$a_value,0                     # 27o copy
        stqd    $line1_5,16($a_value_6)                 # 28o
        fma     $power0_2,$power0_3,$fourth0_4,$k_2     # 29e
        fma     $power1,$power1_5,$fourth1,$k_2         # 30e
        selb    $line0,$line0_4,$power0,$c_above0_5     # 32e
        selb    $line1_9,$line1_8,$power1_4,$c_above1_7 # 33e
        stqd    $line0,0($a_value_5)                    # 34o
        fma     $power0_2,$power0_2,$fourth0_4,$k_1     # 35e
        stqd    $line1_9,16($a_value_5)                 # 35o
        fma     $power1,$power1,$fourth1,$k_1           # 36e
        fma     $power0,$power0_2,$fourth0_5,$k_0       # 41e
        fma     $power1,$power1,$fourth1_5,$k_0         # 42e
        selb    $line0,$line0_6,$power0,$c_above0_7     # 47e
        selb    $line1_5,$line1_3,$power1,$c_above1_3   # 48e
        stqd    $line0,0($a_value)                      # 49o
        stqd    $line1_5,16($a_value)                   # 50o
encode_srgb_return:
        bi      $lr                                     # 51o
next_pair_short:
        ai      $count,$count,-1                        # 0e
        lqd     $x0,0($a_value)                         # 0o
        nop     $127                                    # 1e pairing
        lqd     $x1,16($a_value)                        # 1o
        fm      $line0,$x0,$k_slope                     # 6e
        frsqest $inverse0,$x0                           # 6o
        fm      $line1,$x1,$k_slope                     # 7e
        frsqest $inverse1,$x1                           # 7o
        fcgt    $c_above0,$x0,$k_edge                   # 8e
        fcgt    $c_above1,$x1,$k_edge                   # 9e
        fi      $inverse0,$x0,$inverse0                 # 10e
        fi      $inverse1,$x1,$inverse1                 # 11e
        fm      $root0,$x0,$inverse0                    # 17e
        fm      $root1,$x1,$inverse1                    # 18e
        frsqest $inverse0,$root0                        # 23o
        frsqest $inverse1,$root1                        # 24o
        fi      $inverse0,$root0,$inverse0              # 27e
        fi      $inverse1,$root1,$inverse1              # 28e
        fm      $fourth0,$root0,$inverse0               # 34e
        fm      $fourth1,$root1,$inverse1               # 35e
        fma     $power0,$k_4,$fourth0,$k_3              # 40e
        fma     $power1,$k_4,$fourth1,$k_3              # 41e
        fma     $power0,$power0,$fourth0,$k_2           # 46e
        fma     $power1,$power1,$fourth1,$k_2           # 47e
        fma     $power0,$power0,$fourth0,$k_1           # 52e
        fma     $power1,$power1,$fourth1,$k_1           # 53e
        fma     $power0,$power0,$fourth0,$k_0           # 58e
        fma     $power1,$power1,$fourth1,$k_0           # 59e
        selb    $line0,$line0,$power0,$c_above0         # 64e
        selb    $line1,$line1,$power1,$c_above1         # 65e
        stqd    $line0,0($a_value)                      # 66o
        stqd    $line1,16($a_value)                     # 67o
        ai      $a_value,$a_value,32                    # 68e
        brnz    $count,next_pair_short                  # 68o
        nop     $127                                    # 69e pairing
        bi      $lr                                     # 69o
endfunction encode_srgb
