# list_places_p64   the places of those packets of a tile that masks name
#   C       struct place *list_places_p64(const unsigned masks[4], const struct place *,
#                                         const struct place *origin, struct place *);
#   In      $3 masks, one for each sixteen packets: 16 bits, the highest of the first; $4 the places of
#           64 packets at 0, 0; $5 what to add to each; $6 where the list goes; pointers 16-aligned
#   Out     the list; one more quadword may be written
#           $3 behind the list
#   Uses    $2-$3, $5-$46   Saves  -   Stack  0   Calls  -
#   Domain  any
#   Error   0
#   Twin    oracle/src/twin/lists.rs
# Scheduled by spu schedule from list_places_p64.s

        .include "work_unit.inc"
        .include "macros.inc"
        .include "lists.inc"

        .set    a_masks,3
        .set    a_places,4
        .set    a_origin,5
        .set    a_out,6
        # temporaries
        .set    masks,10
        .set    place,11
        .set    bit,12
        .set    origin,13

function list_places_p64
        .set    packet,16
        .set    bit_2,2
        .set    bit_3,3
        .set    masks_2,5
        .set    bit_4,7
        .set    masks_3,8
        .set    a_out_2,2
        .set    masks_4,7
        .set    a_out_3,3
        .set    bit_5,9
        .set    bit_6,14
        .set    masks_5,15
        .set    a_out_4,9
        .set    a_out_5,12
        .set    bit_7,15
        .set    bit_8,16
        .set    a_out_6,14
        .set    bit_9,17
        .set    a_out_7,16
        .set    a_out_8,15
        .set    bit_10,18
        .set    bit_11,19
        .set    a_out_9,18
        .set    bit_12,10
        .set    a_out_10,17
        .set    bit_13,20
        .set    a_out_11,10
        .set    bit_14,21
        .set    a_out_12,20
        .set    a_out_13,19
        .set    bit_15,22
        .set    bit_16,23
        .set    a_out_14,22
        .set    a_out_15,21
        .set    bit_17,24
        .set    bit_18,25
        .set    a_out_16,11
        .set    place_2,14
        .set    a_out_17,23
        .set    bit_19,26
        .set    a_out_18,25
        .set    place_3,16
        .set    a_out_19,24
        .set    bit_20,27
        .set    bit_21,28
        .set    a_out_20,27
        .set    bit_22,5
        .set    a_out_21,26
        .set    bit_23,29
        .set    a_out_22,5
        .set    place_4,3
        .set    bit_24,30
        .set    a_out_23,29
        .set    a_out_24,28
        .set    bit_25,31
        .set    bit_26,32
        .set    a_out_25,31
        .set    a_out_26,30
        .set    bit_27,33
        .set    bit_28,34
        .set    a_out_27,32
        .set    bit_29,35
        .set    a_out_28,34
        .set    place_5,9
        .set    a_out_29,33
        .set    a_out_30,36
        .set    bit_30,37
        .set    place_6,10
        .set    a_out_31,37
        .set    a_out_32,8
        .set    bit_31,38
        .set    bit_32,39
        .set    a_out_33,38
        .set    place_7,19
        .set    a_out_34,35
        .set    a_out_35,40
        .set    bit_33,41
        .set    a_out_36,41
        .set    a_out_37,39
        .set    bit_34,42
        .set    bit_35,43
        .set    bit_36,44
        .set    a_out_38,43
        .set    place_8,22
        .set    a_out_39,42
        .set    a_out_40,45
        .set    bit_37,46
        .set    a_out_41,44
        .set    a_out_42,46
        lqd     $masks,0($a_masks)                      # 0o
        lqd     $origin,0($a_origin)                    # 1o

        lqd     $place,0($a_places)                     # 2o
        shli    $masks,$masks,4                         # 6e

        a       $place,$place,$origin                   # 8e
        lnop                                            # 8o pairing

        rotmi   $bit,$masks,-15                         # 10e
        stqd    $place,0($a_out)                        # 10o may alias the one before

        rotmi   $bit_2,$masks,-14                       # 11e
        lqd     $place,16($a_places)                    # 11o

        rotmi   $bit_3,$masks,-13                       # 12e
        rotqbyi $masks_2,$masks,4                       # 12o

        rotmi   $bit_4,$masks,-12                       # 13e
        andi    $bit,$bit,16                            # 14e

        andi    $bit_2,$bit_2,16                        # 15e
        lnop                                            # 15o pairing

        a       $a_out,$a_out,$bit                      # 16e
        rotqbyi $masks_3,$masks_2,4                     # 16o

        a       $place,$place,$origin                   # 17e
        a       $a_out_2,$a_out,$bit_2                  # 18e

        andi    $bit,$bit_3,16                          # 19e
        stqd    $place,0($a_out)                        # 19o may alias the one before

        andi    $bit_3,$bit_4,16                        # 20e
        lqd     $place,32($a_places)                    # 20o

        a       $a_out,$a_out_2,$bit                    # 21e
        rotqbyi $masks_4,$masks_3,4                     # 21o

        rotmi   $bit,$masks,-11                         # 22e
        a       $a_out_3,$a_out,$bit_3                  # 23e

        rotmi   $bit_5,$masks,-10                       # 24e
        lnop                                            # 24o pairing

        rotmi   $bit_6,$masks,-9                        # 25e
        rotqbyi $masks_5,$masks_4,4                     # 25o

        a       $place,$place,$origin                   # 26e
        andi    $bit,$bit,16                            # 27e

        andi    $bit_5,$bit_5,16                        # 28e
        stqd    $place,0($a_out_2)                      # 28o may alias the one before

        a       $a_out_2,$a_out_3,$bit                  # 29e
        lqd     $place,48($a_places)                    # 29o

        andi    $bit,$bit_6,16                          # 30e
        a       $a_out_4,$a_out_2,$bit_5                # 31e

        rotmi   $bit_6,$masks,-8                        # 32e
        a       $a_out_5,$a_out_4,$bit                  # 33e

        rotmi   $bit_7,$masks,-7                        # 34e
        a       $place,$place,$origin                   # 35e

        andi    $bit_6,$bit_6,16                        # 36e
        lnop                                            # 36o pairing

        rotmi   $bit_8,$masks,-6                        # 37e
        stqd    $place,0($a_out)                        # 37o may alias the one before

        a       $a_out,$a_out_5,$bit_6                  # 38e
        lqd     $place,64($a_places)                    # 38o

        andi    $bit_6,$bit_7,16                        # 39e
        rotmi   $bit_7,$masks,-5                        # 40e

        a       $a_out_6,$a_out,$bit_6                  # 41e
        andi    $bit_8,$bit_8,16                        # 42e

        rotmi   $bit_9,$masks,-4                        # 43e
        a       $place,$place,$origin                   # 44e

        a       $a_out_7,$a_out_6,$bit_8                # 45e
        lnop                                            # 45o pairing

        andi    $bit_7,$bit_7,16                        # 46e
        stqd    $place,0($a_out_3)                      # 46o may alias the one before

        andi    $bit_3,$bit_9,16                        # 47e
        lqd     $place,80($a_places)                    # 47o

        a       $a_out_8,$a_out_7,$bit_7                # 48e
        rotmi   $bit_9,$masks,-3                        # 49e

        a       $a_out_3,$a_out_8,$bit_3                # 50e
        rotmi   $bit_10,$masks,-2                       # 51e

        rotmi   $bit_11,$masks,-1                       # 52e
        a       $place,$place,$origin                   # 53e

        andi    $bit_9,$bit_9,16                        # 54e
        lnop                                            # 54o pairing

        andi    $bit_10,$bit_10,16                      # 55e
        stqd    $place,0($a_out_2)                      # 55o may alias the one before

        a       $a_out_2,$a_out_3,$bit_9                # 56e
        lqd     $place,96($a_places)                    # 56o

        andi    $bit_9,$bit_11,16                       # 57e
        a       $a_out_9,$a_out_2,$bit_10               # 58e

        rotmi   $bit_12,$masks,0                        # 59e
        a       $a_out_10,$a_out_9,$bit_9               # 60e

        rotmi   $bit_11,$masks_2,-15                    # 61e
        a       $place,$place,$origin                   # 62e

        andi    $bit_12,$bit_12,16                      # 63e
        lnop                                            # 63o pairing

        rotmi   $bit_13,$masks_2,-14                    # 64e
        stqd    $place,0($a_out_4)                      # 64o may alias the one before

        a       $a_out_4,$a_out_10,$bit_12              # 65e
        lqd     $place,112($a_places)                   # 65o

        andi    $bit_12,$bit_11,16                      # 66e
        rotmi   $bit_11,$masks_2,-13                    # 67e

        a       $a_out_11,$a_out_4,$bit_12              # 68e
        andi    $bit_13,$bit_13,16                      # 69e

        rotmi   $bit_14,$masks_2,-12                    # 70e
        a       $place,$place,$origin                   # 71e

        a       $a_out_12,$a_out_11,$bit_13             # 72e
        lnop                                            # 72o pairing

        andi    $bit_11,$bit_11,16                      # 73e
        stqd    $place,0($a_out_5)                      # 73o may alias the one before

        andi    $bit,$bit_14,16                         # 74e
        lqd     $place,128($a_places)                   # 74o

        a       $a_out_13,$a_out_12,$bit_11             # 75e
        rotmi   $bit_14,$masks_2,-11                    # 76e

        a       $a_out_5,$a_out_13,$bit                 # 77e
        rotmi   $bit_15,$masks_2,-10                    # 78e

        rotmi   $bit_16,$masks_2,-9                     # 79e
        a       $place,$place,$origin                   # 80e

        andi    $bit_14,$bit_14,16                      # 81e
        lnop                                            # 81o pairing

        andi    $bit_15,$bit_15,16                      # 82e
        stqd    $place,0($a_out)                        # 82o may alias the one before

        a       $a_out,$a_out_5,$bit_14                 # 83e
        lqd     $place,144($a_places)                   # 83o

        andi    $bit_14,$bit_16,16                      # 84e
        a       $a_out_14,$a_out,$bit_15                # 85e

        rotmi   $bit_16,$masks_2,-8                     # 86e
        a       $a_out_15,$a_out_14,$bit_14             # 87e

        rotmi   $bit_17,$masks_2,-7                     # 88e
        a       $place,$place,$origin                   # 89e

        andi    $bit_16,$bit_16,16                      # 90e
        lnop                                            # 90o pairing

        rotmi   $bit_18,$masks_2,-6                     # 91e
        stqd    $place,0($a_out_6)                      # 91o may alias the one before

        a       $a_out_16,$a_out_15,$bit_16             # 92e
        lqd     $place_2,160($a_places)                 # 92o

        andi    $bit_16,$bit_17,16                      # 93e
        rotmi   $bit_17,$masks_2,-5                     # 94e

        a       $a_out_17,$a_out_16,$bit_16             # 95e
        andi    $bit_18,$bit_18,16                      # 96e

        rotmi   $bit_19,$masks_2,-4                     # 97e
        a       $place_2,$place_2,$origin               # 98e

        a       $a_out_18,$a_out_17,$bit_18             # 99e
        lnop                                            # 99o pairing

        andi    $bit_17,$bit_17,16                      # 100e
        stqd    $place_2,0($a_out_7)                    # 100o may alias the one before

        andi    $bit_6,$bit_19,16                       # 101e
        lqd     $place_3,176($a_places)                 # 101o

        a       $a_out_19,$a_out_18,$bit_17             # 102e
        rotmi   $bit_19,$masks_2,-3                     # 103e

        a       $a_out_6,$a_out_19,$bit_6               # 104e
        rotmi   $bit_20,$masks_2,-2                     # 105e

        rotmi   $bit_21,$masks_2,-1                     # 106e
        a       $place_3,$place_3,$origin               # 107e

        andi    $bit_19,$bit_19,16                      # 108e
        lnop                                            # 108o pairing

        andi    $bit_20,$bit_20,16                      # 109e
        stqd    $place_3,0($a_out_8)                    # 109o may alias the one before

        a       $a_out_8,$a_out_6,$bit_19               # 110e
        lqd     $place_3,192($a_places)                 # 110o

        andi    $bit_19,$bit_21,16                      # 111e
        a       $a_out_20,$a_out_8,$bit_20              # 112e

        rotmi   $bit_22,$masks_2,0                      # 113e
        a       $a_out_21,$a_out_20,$bit_19             # 114e

        rotmi   $bit_21,$masks_3,-15                    # 115e
        a       $place_3,$place_3,$origin               # 116e

        andi    $bit_22,$bit_22,16                      # 117e
        lnop                                            # 117o pairing

        rotmi   $bit_23,$masks_3,-14                    # 118e
        stqd    $place_3,0($a_out_3)                    # 118o may alias the one before

        a       $a_out_22,$a_out_21,$bit_22             # 119e
        lqd     $place_4,208($a_places)                 # 119o

        andi    $bit_8,$bit_21,16                       # 120e
        rotmi   $bit_21,$masks_3,-13                    # 121e

        a       $a_out_7,$a_out_22,$bit_8               # 122e
        andi    $bit_23,$bit_23,16                      # 123e

        rotmi   $bit_24,$masks_3,-12                    # 124e
        a       $place_4,$place_4,$origin               # 125e

        a       $a_out_23,$a_out_7,$bit_23              # 126e
        lnop                                            # 126o pairing

        andi    $bit_21,$bit_21,16                      # 127e
        stqd    $place_4,0($a_out_2)                    # 127o may alias the one before

        andi    $bit_2,$bit_24,16                       # 128e
        lqd     $place_4,224($a_places)                 # 128o

        a       $a_out_24,$a_out_23,$bit_21             # 129e
        rotmi   $bit_24,$masks_3,-11                    # 130e

        a       $a_out_2,$a_out_24,$bit_2               # 131e
        rotmi   $bit_25,$masks_3,-10                    # 132e

        rotmi   $bit_26,$masks_3,-9                     # 133e
        a       $place_4,$place_4,$origin               # 134e

        andi    $bit_24,$bit_24,16                      # 135e
        lnop                                            # 135o pairing

        andi    $bit_25,$bit_25,16                      # 136e
        stqd    $place_4,0($a_out_9)                    # 136o may alias the one before

        a       $a_out_9,$a_out_2,$bit_24               # 137e
        lqd     $place_4,240($a_places)                 # 137o

        andi    $bit_24,$bit_26,16                      # 138e
        a       $a_out_25,$a_out_9,$bit_25              # 139e

        rotmi   $bit_26,$masks_3,-8                     # 140e
        a       $a_out_26,$a_out_25,$bit_24             # 141e

        rotmi   $bit_27,$masks_3,-7                     # 142e
        a       $place_4,$place_4,$origin               # 143e

        andi    $bit_26,$bit_26,16                      # 144e
        lnop                                            # 144o pairing

        rotmi   $bit_28,$masks_3,-6                     # 145e
        stqd    $place_4,0($a_out_10)                   # 145o may alias the one before

        a       $a_out_10,$a_out_26,$bit_26             # 146e
        lqd     $place_4,256($a_places)                 # 146o

        andi    $bit_26,$bit_27,16                      # 147e
        rotmi   $bit_27,$masks_3,-5                     # 148e

        a       $a_out_27,$a_out_10,$bit_26             # 149e
        andi    $bit_28,$bit_28,16                      # 150e

        rotmi   $bit_29,$masks_3,-4                     # 151e
        a       $place_4,$place_4,$origin               # 152e

        a       $a_out_28,$a_out_27,$bit_28             # 153e
        lnop                                            # 153o pairing

        andi    $bit_27,$bit_27,16                      # 154e
        stqd    $place_4,0($a_out_4)                    # 154o may alias the one before

        andi    $bit_3,$bit_29,16                       # 155e
        lqd     $place_5,272($a_places)                 # 155o

        a       $a_out_29,$a_out_28,$bit_27             # 156e
        rotmi   $bit_29,$masks_3,-3                     # 157e

        a       $a_out_30,$a_out_29,$bit_3              # 158e
        rotmi   $bit_3,$masks_3,-2                      # 159e

        rotmi   $bit_30,$masks_3,-1                     # 160e
        a       $place_5,$place_5,$origin               # 161e

        andi    $bit_29,$bit_29,16                      # 162e
        lnop                                            # 162o pairing

        andi    $bit_3,$bit_3,16                        # 163e
        stqd    $place_5,0($a_out_11)                   # 163o may alias the one before

        a       $a_out_4,$a_out_30,$bit_29              # 164e
        lqd     $place_6,288($a_places)                 # 164o

        andi    $bit_29,$bit_30,16                      # 165e
        a       $a_out_31,$a_out_4,$bit_3               # 166e

        rotmi   $bit_3,$masks_3,0                       # 167e
        a       $a_out_32,$a_out_31,$bit_29             # 168e

        rotmi   $bit_29,$masks_4,-15                    # 169e
        a       $place_6,$place_6,$origin               # 170e

        andi    $bit_3,$bit_3,16                        # 171e
        lnop                                            # 171o pairing

        rotmi   $bit_31,$masks_4,-14                    # 172e
        stqd    $place_6,0($a_out_12)                   # 172o may alias the one before

        a       $a_out_11,$a_out_32,$bit_3              # 173e
        lqd     $place_4,304($a_places)                 # 173o

        andi    $bit_13,$bit_29,16                      # 174e
        rotmi   $bit_29,$masks_4,-13                    # 175e

        a       $a_out_12,$a_out_11,$bit_13             # 176e
        andi    $bit_31,$bit_31,16                      # 177e

        rotmi   $bit_32,$masks_4,-12                    # 178e
        a       $place_4,$place_4,$origin               # 179e

        a       $a_out_33,$a_out_12,$bit_31             # 180e
        lnop                                            # 180o pairing

        andi    $bit_29,$bit_29,16                      # 181e
        stqd    $place_4,0($a_out_13)                   # 181o may alias the one before

        andi    $bit_3,$bit_32,16                       # 182e
        lqd     $place_7,320($a_places)                 # 182o

        a       $a_out_34,$a_out_33,$bit_29             # 183e
        rotmi   $bit_32,$masks_4,-11                    # 184e

        a       $a_out_35,$a_out_34,$bit_3              # 185e
        rotmi   $bit_3,$masks_4,-10                     # 186e

        rotmi   $bit_33,$masks_4,-9                     # 187e
        a       $place_7,$place_7,$origin               # 188e

        andi    $bit_32,$bit_32,16                      # 189e
        lnop                                            # 189o pairing

        andi    $bit_3,$bit_3,16                        # 190e
        stqd    $place_7,0($a_out_5)                    # 190o may alias the one before

        a       $a_out_5,$a_out_35,$bit_32              # 191e
        lqd     $place_7,336($a_places)                 # 191o

        andi    $bit_32,$bit_33,16                      # 192e
        a       $a_out_36,$a_out_5,$bit_3               # 193e

        rotmi   $bit_3,$masks_4,-8                      # 194e
        a       $a_out_37,$a_out_36,$bit_32             # 195e

        rotmi   $bit_34,$masks_4,-7                     # 196e
        a       $place_7,$place_7,$origin               # 197e

        andi    $bit_3,$bit_3,16                        # 198e
        lnop                                            # 198o pairing

        rotmi   $bit_35,$masks_4,-6                     # 199e
        stqd    $place_7,0($a_out)                      # 199o may alias the one before

        a       $a_out,$a_out_37,$bit_3                 # 200e
        lqd     $place_4,352($a_places)                 # 200o

        andi    $bit_11,$bit_34,16                      # 201e
        rotmi   $bit_34,$masks_4,-5                     # 202e

        a       $a_out_13,$a_out,$bit_11                # 203e
        andi    $bit_35,$bit_35,16                      # 204e

        rotmi   $bit_36,$masks_4,-4                     # 205e
        a       $place_4,$place_4,$origin               # 206e

        a       $a_out_38,$a_out_13,$bit_35             # 207e
        lnop                                            # 207o pairing

        andi    $bit_34,$bit_34,16                      # 208e
        stqd    $place_4,0($a_out_14)                   # 208o may alias the one before

        andi    $bit_3,$bit_36,16                       # 209e
        lqd     $place_8,368($a_places)                 # 209o

        a       $a_out_39,$a_out_38,$bit_34             # 210e
        rotmi   $bit_36,$masks_4,-3                     # 211e

        a       $a_out_40,$a_out_39,$bit_3              # 212e
        rotmi   $bit_3,$masks_4,-2                      # 213e

        rotmi   $bit_37,$masks_4,-1                     # 214e
        a       $place_8,$place_8,$origin               # 215e

        andi    $bit_36,$bit_36,16                      # 216e
        lnop                                            # 216o pairing

        andi    $bit_3,$bit_3,16                        # 217e
        stqd    $place_8,0($a_out_15)                   # 217o may alias the one before

        a       $a_out_15,$a_out_40,$bit_36             # 218e
        lqd     $place_8,384($a_places)                 # 218o

        rotmi   $bit_4,$masks_4,0                       # 219e
        a       $a_out_41,$a_out_15,$bit_3              # 220e

        andi    $bit_3,$bit_37,16                       # 221e
        a       $a_out_42,$a_out_41,$bit_3              # 223e

        a       $place_4,$place_8,$origin               # 224e
        andi    $bit_4,$bit_4,16                        # 225e

        nop     $127                                    # 226e pairing
        stqd    $place_4,0($a_out_16)                   # 226o may alias the one before

        a       $a_out_3,$a_out_42,$bit_4               # 227e
        lqd     $place,400($a_places)                   # 227o

        ori     $a_masks,$a_out_3,0                     # 229e
        a       $place,$place,$origin                   # 233e

        stqd    $place,0($a_out_17)                     # 235o may alias the one before
        lqd     $place,416($a_places)                   # 236o

        a       $place,$place,$origin                   # 242e
        stqd    $place,0($a_out_18)                     # 244o may alias the one before

        lqd     $place,432($a_places)                   # 245o
        a       $place,$place,$origin                   # 251e

        stqd    $place,0($a_out_19)                     # 253o may alias the one before
        lqd     $place,448($a_places)                   # 254o

        a       $place,$place,$origin                   # 260e
        stqd    $place,0($a_out_6)                      # 262o may alias the one before

        lqd     $place,464($a_places)                   # 263o
        a       $place,$place,$origin                   # 269e

        stqd    $place,0($a_out_8)                      # 271o may alias the one before
        lqd     $place,480($a_places)                   # 272o

        a       $place,$place,$origin                   # 278e
        stqd    $place,0($a_out_20)                     # 280o may alias the one before

        lqd     $place,496($a_places)                   # 281o
        a       $place,$place,$origin                   # 287e

        stqd    $place,0($a_out_21)                     # 289o may alias the one before
        lqd     $place,512($a_places)                   # 290o

        a       $place,$place,$origin                   # 296e
        stqd    $place,0($a_out_22)                     # 298o may alias the one before

        lqd     $place,528($a_places)                   # 299o
        a       $place,$place,$origin                   # 305e

        stqd    $place,0($a_out_7)                      # 307o may alias the one before
        lqd     $place,544($a_places)                   # 308o

        a       $place,$place,$origin                   # 314e
        stqd    $place,0($a_out_23)                     # 316o may alias the one before

        lqd     $place,560($a_places)                   # 317o
        a       $place,$place,$origin                   # 323e

        stqd    $place,0($a_out_24)                     # 325o may alias the one before
        lqd     $place,576($a_places)                   # 326o

        a       $place,$place,$origin                   # 332e
        stqd    $place,0($a_out_2)                      # 334o may alias the one before

        lqd     $place,592($a_places)                   # 335o
        a       $place,$place,$origin                   # 341e

        stqd    $place,0($a_out_9)                      # 343o may alias the one before
        lqd     $place,608($a_places)                   # 344o

        a       $place,$place,$origin                   # 350e
        stqd    $place,0($a_out_25)                     # 352o may alias the one before

        lqd     $place,624($a_places)                   # 353o
        a       $place,$place,$origin                   # 359e

        stqd    $place,0($a_out_26)                     # 361o may alias the one before
        lqd     $place,640($a_places)                   # 362o

        hbr     list_places_p64_return,$lr              # 363o hint
        a       $place,$place,$origin                   # 368e

        stqd    $place,0($a_out_10)                     # 370o may alias the one before
        lqd     $place,656($a_places)                   # 371o

        a       $place,$place,$origin                   # 377e
        stqd    $place,0($a_out_27)                     # 379o may alias the one before

        lqd     $place,672($a_places)                   # 380o
        a       $place,$place,$origin                   # 386e

        stqd    $place,0($a_out_28)                     # 388o may alias the one before
        lqd     $place,688($a_places)                   # 389o

        a       $place,$place,$origin                   # 395e
        stqd    $place,0($a_out_29)                     # 397o may alias the one before

        lqd     $place,704($a_places)                   # 398o
        a       $place,$place,$origin                   # 404e

        stqd    $place,0($a_out_30)                     # 406o may alias the one before
        lqd     $place,720($a_places)                   # 407o

        a       $place,$place,$origin                   # 413e
        stqd    $place,0($a_out_4)                      # 415o may alias the one before

        lqd     $place,736($a_places)                   # 416o
        a       $place,$place,$origin                   # 422e

        stqd    $place,0($a_out_31)                     # 424o may alias the one before
        lqd     $place,752($a_places)                   # 425o

        a       $place,$place,$origin                   # 431e
        stqd    $place,0($a_out_32)                     # 433o may alias the one before

        lqd     $place,768($a_places)                   # 434o
        a       $place,$place,$origin                   # 440e

        stqd    $place,0($a_out_11)                     # 442o may alias the one before
        lqd     $place,784($a_places)                   # 443o

        a       $place,$place,$origin                   # 449e
        stqd    $place,0($a_out_12)                     # 451o may alias the one before

        lqd     $place,800($a_places)                   # 452o
        a       $place,$place,$origin                   # 458e

        stqd    $place,0($a_out_33)                     # 460o may alias the one before
        lqd     $place,816($a_places)                   # 461o

        a       $place,$place,$origin                   # 467e
        stqd    $place,0($a_out_34)                     # 469o may alias the one before

        lqd     $place,832($a_places)                   # 470o
        a       $place,$place,$origin                   # 476e

        stqd    $place,0($a_out_35)                     # 478o may alias the one before
        lqd     $place,848($a_places)                   # 479o

        a       $place,$place,$origin                   # 485e
        stqd    $place,0($a_out_5)                      # 487o may alias the one before

        lqd     $place,864($a_places)                   # 488o
        a       $place,$place,$origin                   # 494e

        stqd    $place,0($a_out_36)                     # 496o may alias the one before
        lqd     $place,880($a_places)                   # 497o

        a       $place,$place,$origin                   # 503e
        stqd    $place,0($a_out_37)                     # 505o may alias the one before

        lqd     $place,896($a_places)                   # 506o
        a       $place,$place,$origin                   # 512e

        stqd    $place,0($a_out)                        # 514o may alias the one before
        lqd     $place,912($a_places)                   # 515o

        a       $place,$place,$origin                   # 521e
        stqd    $place,0($a_out_13)                     # 523o may alias the one before

        lqd     $place,928($a_places)                   # 524o
        a       $place,$place,$origin                   # 530e

        stqd    $place,0($a_out_38)                     # 532o may alias the one before
        lqd     $place,944($a_places)                   # 533o

        a       $place,$place,$origin                   # 539e
        stqd    $place,0($a_out_39)                     # 541o may alias the one before

        lqd     $place,960($a_places)                   # 542o
        a       $place,$place,$origin                   # 548e

        stqd    $place,0($a_out_40)                     # 550o may alias the one before
        lqd     $place,976($a_places)                   # 551o

        a       $place,$place,$origin                   # 557e
        stqd    $place,0($a_out_15)                     # 559o may alias the one before

        lqd     $place,992($a_places)                   # 560o
        a       $place,$place,$origin                   # 566e

        stqd    $place,0($a_out_41)                     # 568o may alias the one before
        lqd     $place,1008($a_places)                  # 569o

        a       $place,$place,$origin                   # 575e
        stqd    $place,0($a_out_42)                     # 577o may alias the one before

        nop     $127                                    # 578e pairing
list_places_p64_return:
        bi      $lr                                     # 578o
endfunction list_places_p64
