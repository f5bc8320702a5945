# list_places_p64   the places of those packets of a tile that masks name
#   C       struct place *list_places_p64(const unsigned masks[4], const struct place *,
#                                         const struct place *origin, struct place *);
#   In      $3 masks, one for each sixteen packets: 16 bits, the highest of the first; $4 the
#           places of 64 packets at 0, 0; $5 what to add to each; $6 where the list goes; pointers
#           16-aligned
#   Out     the list; one more quadword may be written
#           $3 behind the list
#   Uses    $2-$42   Saves  -   Stack  0   Calls  -
#   Domain  any
#   Error   0
#   Twin    lab/twins/src/lists.rs
# Scheduled by spu schedule from list_places_p64.s

        .include "work_unit.inc"
        .include "macros.inc"
        .include "lists.inc"

        .set    NEXT,3
        registers a_masks,a_places,a_origin,a_out
        # temporaries
        .set    NEXT,10
        registers masks,bit,origin
        registers place                                 # to 28

function list_places_p64
        .set masks_2,2; .set bit_2,3; .set bit_3,5; .set bit_4,7; .set a_out_2,8; .set a_out_3,3
        .set masks_3,6; .set bit_5,9; .set a_out_4,5; .set bit_6,13; .set a_out_5,11
        .set masks_4,29; .set bit_7,30; .set a_out_6,9; .set masks_5,31; .set bit_8,31
        .set a_out_7,7; .set bit_9,32; .set a_out_8,13; .set a_out_9,30; .set bit_10,33
        .set a_out_10,31; .set bit_11,34; .set bit_12,35; .set a_out_11,32; .set bit_13,36
        .set a_out_12,33; .set bit_14,37; .set bit_15,10; .set bit_16,38; .set a_out_13,34
        .set a_out_14,35; .set bit_17,39; .set a_out_15,37; .set a_out_16,10; .set bit_18,40
        .set a_out_17,36; .set bit_19,41; .set a_out_18,38; .set bit_20,42; .set bit_21,14
        .set bit_22,15; .set a_out_19,14; .set bit_23,16; .set a_out_20,15; .set a_out_21,40
        .set bit_24,17; .set a_out_22,17; .set bit_25,18; .set bit_26,19; .set bit_27,2
        .set place1_2,18; .set bit_28,20; .set place_2,21; .set a_out_23,16; .set place2_2,22
        .set place6_2,23; .set place3_2,24; .set a_out_24,2; .set place4_2,25; .set place5_2,26
        .set bit_29,28; .set place13_2,30; .set place7_2,31; .set place10_2,32; .set place11_2,33
        .set place9_2,34; .set place12_2,35; .set place15_2,37; .set place8_2,41; .set place3_3,21
        .set bit_30,8; .set place5_3,3; .set place7_3,15; .set a_out_25,19; .set place1_3,16
        .set place2_3,17; .set place6_3,20; .set bit_31,21; .set bit_32,24; .set place3_4,26
        .set bit_33,27; .set place7_4,28; .set place4_3,30; .set place15_3,31; .set place5_4,32
        .set place14_2,34; .set place8_3,35; .set place13_3,37; .set a_out_26,21; .set place7_5,18
        .set place4_4,27; .set bit_34,6; .set place5_5,17; .set place8_4,8; .set place3_5,20
        .set place7_6,21; .set place8_5,28; .set place6_4,30; .set place13_4,31; .set place15_4,4
        lqd     $masks,0($a_masks)                      # 0o
        lqd     $place,0($a_places)                     # 1o
        lqd     $origin,0($a_origin)                    # 2o
        lqd     $place+2,32($a_places)                  # 3o
        lqd     $place+15,240($a_places)                # 4o
        lqd     $place+1,16($a_places)                  # 5o
        shli    $masks,$masks,4                         # 6e
        lqd     $place+3,48($a_places)                  # 6o
        nop     $127                                    # 7e pairing
        lqd     $place+4,64($a_places)                  # 7o
        a       $place,$place,$origin                   # 8e
        lqd     $place+5,80($a_places)                  # 8o
        a       $place+2,$place+2,$origin               # 9e
        lqd     $place+10,160($a_places)                # 9o
        rotmi   $bit,$masks,-15                         # 10e
        rotqbyi $masks_2,$masks,4                       # 10o
        rotmi   $bit_2,$masks,-14                       # 11e
        lqd     $place+13,208($a_places)                # 11o
        rotmi   $bit_3,$masks,-13                       # 12e
        lqd     $place+7,112($a_places)                 # 12o
        rotmi   $bit_4,$masks,-12                       # 13e
        lqd     $place+8,128($a_places)                 # 13o
        andi    $bit,$bit,16                            # 14e
        lqd     $place+9,144($a_places)                 # 14o
        andi    $bit_2,$bit_2,16                        # 15e
        lqd     $place+11,176($a_places)                # 15o
        a       $a_out_2,$a_out,$bit                    # 16e
        lqd     $place+6,96($a_places)                  # 16o
        andi    $bit,$bit_4,16                          # 17e
        lqd     $place+14,224($a_places)                # 17o
        a       $a_out_3,$a_out_2,$bit_2                # 18e
        lqd     $place+12,192($a_places)                # 18o
        rotmi   $bit_4,$masks,-10                       # 19e
        stqd    $place,0($a_out)                        # 19o may alias the one before
        andi    $bit_3,$bit_3,16                        # 20e
        rotqbyi $masks_3,$masks_2,4                     # 20o
        rotmi   $bit_5,$masks,-11                       # 21e
        a       $a_out_4,$a_out_3,$bit_3                # 22e
        rotmi   $bit_6,$masks,-9                        # 23e
        lnop                                            # 23o pairing
        a       $a_out_5,$a_out_4,$bit                  # 24e
        rotqbyi $masks_4,$masks_3,4                     # 24o
        andi    $bit_5,$bit_5,16                        # 25e
        rotmi   $bit_7,$masks,-8                        # 26e
        a       $a_out_6,$a_out_5,$bit_5                # 27e
        lnop                                            # 27o pairing
        andi    $bit_4,$bit_4,16                        # 28e
        rotqbyi $masks_5,$masks_4,4                     # 28o
        rotmi   $bit_8,$masks,-7                        # 29e
        a       $a_out_7,$a_out_6,$bit_4                # 30e
        andi    $bit_7,$bit_7,16                        # 31e
        rotmi   $bit_9,$masks,-6                        # 32e
        andi    $bit_6,$bit_6,16                        # 33e
        andi    $bit_8,$bit_8,16                        # 34e
        a       $a_out_8,$a_out_7,$bit_6                # 35e
        andi    $bit_9,$bit_9,16                        # 36e
        a       $a_out_9,$a_out_8,$bit_7                # 37e
        rotmi   $bit_10,$masks,-5                       # 38e
        a       $a_out_10,$a_out_9,$bit_8               # 39e
        rotmi   $bit_11,$masks,-4                       # 40e
        rotmi   $bit_12,$masks,-3                       # 41e
        andi    $bit_10,$bit_10,16                      # 42e
        a       $a_out_11,$a_out_10,$bit_9              # 43e
        rotmi   $bit_13,$masks,0                        # 44e
        a       $a_out_12,$a_out_11,$bit_10             # 45e
        andi    $bit_12,$bit_12,16                      # 46e
        rotmi   $bit_14,$masks,-2                       # 47e
        andi    $bit_11,$bit_11,16                      # 48e
        rotmi   $bit_15,$masks,-1                       # 49e
        rotmi   $bit_16,$masks_2,-15                    # 50e
        andi    $bit_14,$bit_14,16                      # 51e
        a       $a_out_13,$a_out_12,$bit_11             # 52e
        andi    $bit_15,$bit_15,16                      # 53e
        a       $a_out_14,$a_out_13,$bit_12             # 54e
        rotmi   $bit_17,$masks_2,-14                    # 55e
        a       $a_out_15,$a_out_14,$bit_14             # 56e
        andi    $bit_16,$bit_16,16                      # 57e
        a       $a_out_16,$a_out_15,$bit_15             # 58e
        rotmi   $bit_18,$masks_2,-11                    # 59e
        andi    $bit_13,$bit_13,16                      # 60e
        andi    $bit_17,$bit_17,16                      # 61e
        a       $a_out_17,$a_out_16,$bit_13             # 62e
        rotmi   $bit_19,$masks_2,-13                    # 63e
        a       $place+1,$place+1,$origin               # 64e
        a       $a_out_18,$a_out_17,$bit_16             # 65e
        lnop                                            # 65o pairing
        rotmi   $bit_20,$masks_2,-12                    # 66e
        stqd    $place+1,0($a_out_2)                    # 66o may alias the one before
        a       $a_out_2,$a_out_18,$bit_17              # 67e
        stqd    $place+2,0($a_out_3)                    # 67o may alias the one before
        andi    $bit_2,$bit_19,16                       # 68e
        a       $place+6,$place+6,$origin               # 69e
        a       $a_out_3,$a_out_2,$bit_2                # 70e
        andi    $bit_21,$bit_20,16                      # 71e
        rotmi   $bit_22,$masks_2,-10                    # 72e
        a       $a_out_19,$a_out_3,$bit_21              # 73e
        a       $place+5,$place+5,$origin               # 74e
        rotmi   $bit_17,$masks_2,-8                     # 75e
        andi    $bit_22,$bit_22,16                      # 76e
        a       $place+3,$place+3,$origin               # 77e
        rotmi   $bit_19,$masks_2,-9                     # 78e
        lnop                                            # 78o pairing
        a       $place+7,$place+7,$origin               # 79e
        stqd    $place+3,0($a_out_4)                    # 79o may alias the one before
        andi    $bit_3,$bit_18,16                       # 80e
        andi    $bit_23,$bit_17,16                      # 81e
        a       $place+8,$place+8,$origin               # 82e
        a       $a_out_4,$a_out_19,$bit_3               # 83e
        rotmi   $bit_17,$masks_2,-5                     # 84e
        a       $a_out_20,$a_out_4,$bit_22              # 85e
        a       $place+9,$place+9,$origin               # 86e
        andi    $bit_18,$bit_19,16                      # 87e
        a       $place+4,$place+4,$origin               # 88e
        a       $a_out_21,$a_out_20,$bit_18             # 89e
        a       $place+12,$place+12,$origin             # 90e
        stqd    $place+4,0($a_out_5)                    # 90o may alias the one before
        a       $a_out_5,$a_out_21,$bit_23              # 91e
        stqd    $place+5,0($a_out_6)                    # 91o may alias the one before
        rotmi   $bit_5,$masks_2,-7                      # 92e
        stqd    $place+6,0($a_out_7)                    # 92o may alias the one before
        rotmi   $bit_4,$masks_2,-6                      # 93e
        stqd    $place+7,0($a_out_8)                    # 93o may alias the one before
        rotmi   $bit_6,$masks_2,-2                      # 94e
        stqd    $place+8,0($a_out_9)                    # 94o may alias the one before
        rotmi   $bit_23,$masks_2,-3                     # 95e
        stqd    $place+9,0($a_out_10)                   # 95o may alias the one before
        andi    $bit_5,$bit_5,16                        # 96e
        andi    $bit_4,$bit_4,16                        # 97e
        a       $a_out_6,$a_out_5,$bit_5                # 98e
        a       $place+11,$place+11,$origin             # 99e
        a       $place+13,$place+13,$origin             # 100e
        a       $a_out_7,$a_out_6,$bit_4                # 101e
        andi    $bit_24,$bit_17,16                      # 102e
        andi    $bit_23,$bit_23,16                      # 103e
        a       $a_out_22,$a_out_7,$bit_24              # 104e
        a       $place+10,$place+10,$origin             # 105e
        a       $place+15,$place+15,$origin             # 106e
        lnop                                            # 106o pairing
        rotmi   $bit_25,$masks_2,-4                     # 107e
        stqd    $place+10,0($a_out_11)                  # 107o may alias the one before
        rotmi   $bit_26,$masks_2,0                      # 108e
        stqd    $place+11,0($a_out_12)                  # 108o may alias the one before
        a       $place+14,$place+14,$origin             # 109e
        stqd    $place+12,0($a_out_13)                  # 109o may alias the one before
        andi    $bit_6,$bit_6,16                        # 110e
        stqd    $place+13,0($a_out_14)                  # 110o may alias the one before
        andi    $bit_25,$bit_25,16                      # 111e
        stqd    $place+14,0($a_out_15)                  # 111o may alias the one before
        rotmi   $bit_27,$masks_2,-1                     # 112e
        stqd    $place+15,0($a_out_16)                  # 112o may alias the one before
        a       $a_out_16,$a_out_22,$bit_25             # 113e
        lqd     $place1_2,272($a_places)                # 113o
        rotmi   $bit_28,$masks_3,-14                    # 114e
        lqd     $place_2,256($a_places)                 # 114o
        a       $a_out_23,$a_out_16,$bit_23             # 115e
        lqd     $place2_2,288($a_places)                # 115o
        andi    $bit_27,$bit_27,16                      # 116e
        lqd     $place6_2,352($a_places)                # 116o
        a       $a_out_8,$a_out_23,$bit_6               # 117e
        lqd     $place+14,480($a_places)                # 117o
        andi    $bit_26,$bit_26,16                      # 118e
        lqd     $place3_2,304($a_places)                # 118o
        a       $a_out_24,$a_out_8,$bit_27              # 119e
        lqd     $place4_2,320($a_places)                # 119o
        a       $place_2,$place_2,$origin               # 120e
        lqd     $place5_2,336($a_places)                # 120o
        rotmi   $bit_29,$masks_3,-15                    # 121e
        lqd     $place13_2,464($a_places)               # 121o
        a       $place1_2,$place1_2,$origin             # 122e
        lqd     $place7_2,368($a_places)                # 122o
        a       $place2_2,$place2_2,$origin             # 123e
        lqd     $place10_2,416($a_places)               # 123o
        andi    $bit_28,$bit_28,16                      # 124e
        lqd     $place11_2,432($a_places)               # 124o
        andi    $bit_29,$bit_29,16                      # 125e
        lqd     $place9_2,400($a_places)                # 125o
        a       $place4_2,$place4_2,$origin             # 126e
        lqd     $place12_2,448($a_places)               # 126o
        a       $place6_2,$place6_2,$origin             # 127e
        lqd     $place15_2,496($a_places)               # 127o
        rotmi   $bit_17,$masks_3,-13                    # 128e
        lqd     $place8_2,384($a_places)                # 128o
        rotmi   $bit_20,$masks_3,-11                    # 129e
        stqd    $place_2,0($a_out_17)                   # 129o may alias the one before
        a       $place3_3,$place3_2,$origin             # 130e
        stqd    $place1_2,0($a_out_18)                  # 130o may alias the one before
        rotmi   $bit_25,$masks_3,-12                    # 131e
        stqd    $place2_2,0($a_out_2)                   # 131o may alias the one before
        andi    $bit_30,$bit_17,16                      # 132e
        stqd    $place3_3,0($a_out_3)                   # 132o may alias the one before
        a       $place5_3,$place5_2,$origin             # 133e
        stqd    $place4_2,0($a_out_19)                  # 133o may alias the one before
        a       $place+8,$place8_2,$origin              # 134e
        lnop                                            # 134o pairing
        a       $a_out_19,$a_out_24,$bit_26             # 135e
        stqd    $place5_3,0($a_out_4)                   # 135o may alias the one before
        rotmi   $bit_2,$masks_3,-10                     # 136e
        stqd    $place6_2,0($a_out_20)                  # 136o may alias the one before
        a       $a_out_4,$a_out_19,$bit_29              # 137e
        a       $place7_3,$place7_2,$origin             # 138e
        a       $a_out_25,$a_out_4,$bit_28              # 139e
        lnop                                            # 139o pairing
        a       $place+9,$place9_2,$origin              # 140e
        stqd    $place7_3,0($a_out_21)                  # 140o may alias the one before
        a       $a_out_2,$a_out_25,$bit_30              # 141e
        stqd    $place+8,0($a_out_5)                    # 141o may alias the one before
        a       $place+12,$place12_2,$origin            # 142e
        stqd    $place+9,0($a_out_6)                    # 142o may alias the one before
        a       $place+11,$place11_2,$origin            # 143e
        a       $place+14,$place+14,$origin             # 144e
        andi    $bit,$bit_25,16                         # 145e
        a       $place+15,$place15_2,$origin            # 146e
        a       $a_out_6,$a_out_2,$bit                  # 147e
        andi    $bit,$bit_20,16                         # 148e
        andi    $bit_2,$bit_2,16                        # 149e
        a       $a_out_5,$a_out_6,$bit                  # 150e
        rotmi   $bit_22,$masks_3,-7                     # 151e
        a       $a_out_3,$a_out_5,$bit_2                # 152e
        a       $place+10,$place10_2,$origin            # 153e
        a       $place+13,$place13_2,$origin            # 154e
        rotmi   $bit_25,$masks_3,-9                     # 155e
        stqd    $place+10,0($a_out_7)                   # 155o may alias the one before
        rotmi   $bit_4,$masks_3,-8                      # 156e
        stqd    $place+11,0($a_out_22)                  # 156o may alias the one before
        andi    $bit_22,$bit_22,16                      # 157e
        stqd    $place+12,0($a_out_16)                  # 157o may alias the one before
        rotmi   $bit_15,$masks_3,-6                     # 158e
        stqd    $place+13,0($a_out_23)                  # 158o may alias the one before
        andi    $bit_23,$bit_25,16                      # 159e
        stqd    $place+14,0($a_out_8)                   # 159o may alias the one before
        andi    $bit_4,$bit_4,16                        # 160e
        stqd    $place+15,0($a_out_24)                  # 160o may alias the one before
        a       $a_out_24,$a_out_3,$bit_23              # 161e
        lqd     $place,512($a_places)                   # 161o
        andi    $bit_15,$bit_15,16                      # 162e
        lqd     $place1_3,528($a_places)                # 162o
        a       $a_out_7,$a_out_24,$bit_4               # 163e
        lqd     $place2_3,544($a_places)                # 163o
        rotmi   $bit_25,$masks_3,-3                     # 164e
        lqd     $place6_3,608($a_places)                # 164o
        a       $a_out_20,$a_out_7,$bit_22              # 165e
        lqd     $place+9,656($a_places)                 # 165o
        rotmi   $bit_31,$masks_3,-5                     # 166e
        lqd     $place+10,672($a_places)                # 166o
        rotmi   $bit_32,$masks_3,-2                     # 167e
        lqd     $place+12,704($a_places)                # 167o
        a       $place1_3,$place1_3,$origin             # 168e
        lqd     $place3_4,560($a_places)                # 168o
        rotmi   $bit_33,$masks_3,-4                     # 169e
        lqd     $place7_4,624($a_places)                # 169o
        andi    $bit_31,$bit_31,16                      # 170e
        lqd     $place4_3,576($a_places)                # 170o
        andi    $bit_25,$bit_25,16                      # 171e
        lqd     $place15_3,752($a_places)               # 171o
        a       $place,$place,$origin                   # 172e
        lqd     $place5_4,592($a_places)                # 172o
        andi    $bit_33,$bit_33,16                      # 173e
        lqd     $place11_2,688($a_places)               # 173o
        a       $a_out_16,$a_out_20,$bit_15             # 174e
        lqd     $place14_2,736($a_places)               # 174o
        andi    $bit_32,$bit_32,16                      # 175e
        lqd     $place8_3,640($a_places)                # 175o
        rotmi   $bit_13,$masks_3,-1                     # 176e
        lqd     $place13_3,720($a_places)               # 176o
        a       $a_out_26,$a_out_16,$bit_31             # 177e
        stqd    $place,0($a_out_19)                     # 177o may alias the one before
        rotmi   $bit_6,$masks_4,-15                     # 178e
        stqd    $place1_3,0($a_out_4)                   # 178o may alias the one before
        a       $a_out_4,$a_out_26,$bit_33              # 179e
        andi    $bit_21,$bit_13,16                      # 180e
        a       $a_out_23,$a_out_4,$bit_25              # 181e
        a       $place7_5,$place7_4,$origin             # 182e
        a       $place4_4,$place4_3,$origin             # 183e
        andi    $bit_6,$bit_6,16                        # 184e
        a       $place2_3,$place2_3,$origin             # 185e
        a       $place3_4,$place3_4,$origin             # 186e
        rotmi   $bit_34,$masks_3,0                      # 187e
        stqd    $place2_3,0($a_out_25)                  # 187o may alias the one before
        a       $place5_5,$place5_4,$origin             # 188e
        stqd    $place3_4,0($a_out_2)                   # 188o may alias the one before
        a       $place8_4,$place8_3,$origin             # 189e
        stqd    $place4_4,0($a_out_6)                   # 189o may alias the one before
        a       $place+9,$place+9,$origin               # 190e
        stqd    $place5_5,0($a_out_5)                   # 190o may alias the one before
        andi    $bit,$bit_34,16                         # 191e
        a       $place+10,$place+10,$origin             # 192e
        rotmi   $bit_34,$masks_4,-14                    # 193e
        a       $place+6,$place6_3,$origin              # 194e
        a       $a_out_6,$a_out_23,$bit_32              # 195e
        lnop                                            # 195o pairing
        rotmi   $bit_24,$masks_4,-12                    # 196e
        stqd    $place+6,0($a_out_3)                    # 196o may alias the one before
        a       $a_out_3,$a_out_6,$bit_21               # 197e
        stqd    $place7_5,0($a_out_24)                  # 197o may alias the one before
        rotmi   $bit_27,$masks_4,-11                    # 198e
        stqd    $place8_4,0($a_out_7)                   # 198o may alias the one before
        a       $a_out_7,$a_out_3,$bit                  # 199e
        stqd    $place+9,0($a_out_20)                   # 199o may alias the one before
        a       $place+12,$place+12,$origin             # 200e
        stqd    $place+10,0($a_out_16)                  # 200o may alias the one before
        a       $a_out_2,$a_out_7,$bit_6                # 201e
        rotmi   $bit,$masks_4,-13                       # 202e
        a       $place+11,$place11_2,$origin            # 203e
        a       $place+14,$place14_2,$origin            # 204e
        andi    $bit_34,$bit_34,16                      # 205e
        stqd    $place+11,0($a_out_26)                  # 205o may alias the one before
        andi    $bit,$bit,16                            # 206e
        stqd    $place+12,0($a_out_4)                   # 206o may alias the one before
        andi    $bit_3,$bit_24,16                       # 207e
        andi    $bit_27,$bit_27,16                      # 208e
        a       $a_out,$a_out_2,$bit_34                 # 209e
        rotmi   $bit_15,$masks_4,-10                    # 210e
        a       $place+13,$place13_3,$origin            # 211e
        a       $a_out_5,$a_out,$bit                    # 212e
        a       $place+15,$place15_3,$origin            # 213e
        stqd    $place+13,0($a_out_23)                  # 213o may alias the one before
        a       $a_out_4,$a_out_5,$bit_3                # 214e
        stqd    $place+14,0($a_out_6)                   # 214o may alias the one before
        andi    $bit_5,$bit_15,16                       # 215e
        stqd    $place+15,0($a_out_3)                   # 215o may alias the one before
        a       $a_out_24,$a_out_4,$bit_27              # 216e
        lqd     $place+2,800($a_places)                 # 216o
        rotmi   $bit_2,$masks_4,-9                      # 217e
        lqd     $place+1,784($a_places)                 # 217o
        a       $a_out_6,$a_out_24,$bit_5               # 218e
        lqd     $place+4,832($a_places)                 # 218o
        rotmi   $bit_15,$masks_4,-6                     # 219e
        lqd     $place,768($a_places)                   # 219o
        rotmi   $bit_23,$masks_4,-8                     # 220e
        lqd     $place+9,912($a_places)                 # 220o
        rotmi   $bit_25,$masks_4,-4                     # 221e
        lqd     $place+10,928($a_places)                # 221o
        a       $place+2,$place+2,$origin               # 222e
        lqd     $place+11,944($a_places)                # 222o
        andi    $bit_2,$bit_2,16                        # 223e
        lqd     $place+12,960($a_places)                # 223o
        rotmi   $bit_26,$masks_4,-7                     # 224e
        lqd     $place3_5,816($a_places)                # 224o
        a       $a_out_3,$a_out_6,$bit_2                # 225e
        lqd     $place7_6,880($a_places)                # 225o
        andi    $bit_15,$bit_15,16                      # 226e
        lqd     $place+14,992($a_places)                # 226o
        a       $place,$place,$origin                   # 227e
        hbr     list_places_p64_return,$lr              # 227o hint
        andi    $bit_26,$bit_26,16                      # 228e
        lqd     $place5_2,848($a_places)                # 228o
        a       $place+1,$place+1,$origin               # 229e
        lqd     $place8_5,896($a_places)                # 229o
        a       $place3_5,$place3_5,$origin             # 230e
        lqd     $place6_4,864($a_places)                # 230o
        andi    $bit_23,$bit_23,16                      # 231e
        lqd     $place13_4,976($a_places)               # 231o
        rotmi   $bit_9,$masks_4,-5                      # 232e
        lqd     $place15_4,1008($a_places)              # 232o
        a       $a_out_23,$a_out_3,$bit_23              # 233e
        stqd    $place,0($a_out_7)                      # 233o may alias the one before
        andi    $bit_4,$bit_25,16                       # 234e
        stqd    $place+1,0($a_out_2)                    # 234o may alias the one before
        a       $a_out_2,$a_out_23,$bit_26              # 235e
        stqd    $place+2,0($a_out)                      # 235o may alias the one before
        andi    $bit_34,$bit_9,16                       # 236e
        stqd    $place3_5,0($a_out_5)                   # 236o may alias the one before
        a       $a_out_16,$a_out_2,$bit_15              # 237e
        rotmi   $bit,$masks_4,-3                        # 238e
        rotmi   $bit_6,$masks_4,-2                      # 239e
        a       $place+5,$place5_2,$origin              # 240e
        a       $place+4,$place+4,$origin               # 241e
        a       $place+6,$place6_4,$origin              # 242e
        a       $place+10,$place+10,$origin             # 243e
        stqd    $place+4,0($a_out_4)                    # 243o may alias the one before
        a       $place+11,$place+11,$origin             # 244e
        stqd    $place+5,0($a_out_24)                   # 244o may alias the one before
        a       $a_out,$a_out_16,$bit_34                # 245e
        stqd    $place+6,0($a_out_6)                    # 245o may alias the one before
        a       $place+7,$place7_6,$origin              # 246e
        rotmi   $bit_27,$masks_4,-1                     # 247e
        a       $place+8,$place8_5,$origin              # 248e
        stqd    $place+7,0($a_out_3)                    # 248o may alias the one before
        a       $place+9,$place+9,$origin               # 249e
        lnop                                            # 249o pairing
        a       $place+13,$place13_4,$origin            # 250e
        stqd    $place+8,0($a_out_23)                   # 250o may alias the one before
        andi    $bit_27,$bit_27,16                      # 251e
        stqd    $place+9,0($a_out_2)                    # 251o may alias the one before
        a       $a_out_3,$a_out,$bit_4                  # 252e
        stqd    $place+10,0($a_out_16)                  # 252o may alias the one before
        andi    $bit,$bit,16                            # 253e
        stqd    $place+11,0($a_out)                     # 253o may alias the one before
        andi    $bit_3,$bit_6,16                        # 254e
        a       $a_out,$a_out_3,$bit                    # 255e
        rotmi   $bit,$masks_4,0                         # 256e
        a       $a_out_4,$a_out,$bit_3                  # 257e
        a       $place+12,$place+12,$origin             # 258e
        a       $place+14,$place+14,$origin             # 259e
        andi    $bit,$bit,16                            # 260e
        stqd    $place+12,0($a_out_3)                   # 260o may alias the one before
        a       $a_out_24,$a_out_4,$bit_27              # 261e
        stqd    $place+13,0($a_out)                     # 261o may alias the one before
        a       $place+15,$place15_4,$origin            # 262e
        stqd    $place+14,0($a_out_4)                   # 262o may alias the one before
        a       $a_out,$a_out_24,$bit                   # 263e
        stqd    $place+15,0($a_out_24)                  # 264o may alias the one before
        ori     $a_masks,$a_out,0                       # 265e
list_places_p64_return:
        bi      $lr                                     # 265o
endfunction list_places_p64
