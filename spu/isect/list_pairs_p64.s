# list_pairs_p64   pairs of one object with those packets of a tile that masks name
#   C       struct pair *list_pairs_p64(const unsigned masks[4], const struct place *,
#                                       const void *object, struct pair *);
#   In      $3 masks, one for each sixteen packets: 16 bits, the highest of the first; $4 the places of
#           64 packets; $5 address of the object's record; $6 where the pairs go; pointers 16-aligned
#   Out     the pairs; one more quadword may be written
#           $3 behind the pairs
#   Uses    $2-$3, $6-$53   Saves  -   Stack  0   Calls  -
#   Domain  any
#   Error   0
#   Twin    oracle/src/twin/lists.rs
# Scheduled by spu schedule from list_pairs_p64.s

        .include "work_unit.inc"
        .include "macros.inc"
        .include "lists.inc"

        .set    a_masks,3
        .set    a_places,4
        .set    object,5
        .set    a_out,6
        # constants
        .set    m_pair,10
        # temporaries
        .set    masks,11
        .set    pair,12
        .set    bit,13

        .section .rodata
        .align  4
        # A pair: the object's word, then the packet's out of a place.
pair_of_object_and_place:
        .int    0x00010203,0x10111213,0x14151617,0x18191a1b

function list_pairs_p64
        .set    packet,16
        .set    bit_2,2
        .set    masks_2,3
        .set    bit_3,7
        .set    bit_4,8
        .set    masks_3,9
        .set    a_out_2,2
        .set    masks_4,8
        .set    a_out_3,13
        .set    bit_5,6
        .set    a_out_4,7
        .set    bit_6,14
        .set    masks_5,15
        .set    bit_7,15
        .set    bit_8,16
        .set    a_out_5,14
        .set    a_out_6,16
        .set    bit_9,17
        .set    bit_10,18
        .set    bit_11,19
        .set    a_out_7,15
        .set    a_out_8,17
        .set    a_out_9,18
        .set    bit_12,20
        .set    bit_13,21
        .set    bit_14,11
        .set    a_out_10,19
        .set    a_out_11,20
        .set    a_out_12,11
        .set    bit_15,22
        .set    bit_16,23
        .set    bit_17,24
        .set    a_out_13,21
        .set    a_out_14,22
        .set    a_out_15,23
        .set    bit_18,25
        .set    bit_19,26
        .set    bit_20,27
        .set    a_out_16,24
        .set    bit_21,12
        .set    pair_2,14
        .set    a_out_17,12
        .set    a_out_18,25
        .set    a_out_19,26
        .set    bit_22,28
        .set    bit_23,29
        .set    bit_24,30
        .set    a_out_20,27
        .set    a_out_21,28
        .set    a_out_22,29
        .set    bit_25,31
        .set    bit_26,32
        .set    bit_27,3
        .set    a_out_23,30
        .set    a_out_24,31
        .set    a_out_25,33
        .set    bit_28,34
        .set    pair_3,15
        .set    a_out_26,35
        .set    a_out_27,32
        .set    a_out_28,36
        .set    pair_4,17
        .set    bit_29,37
        .set    a_out_29,34
        .set    a_out_30,38
        .set    pair_5,3
        .set    pair_6,18
        .set    bit_30,39
        .set    bit_31,40
        .set    a_out_31,37
        .set    a_out_32,41
        .set    a_out_33,39
        .set    bit_32,42
        .set    bit_33,9
        .set    a_out_34,40
        .set    a_out_35,42
        .set    pair_7,19
        .set    a_out_36,9
        .set    bit_34,43
        .set    bit_35,44
        .set    bit_36,45
        .set    a_out_37,46
        .set    a_out_38,44
        .set    bit_37,47
        .set    bit_38,48
        .set    a_out_39,43
        .set    a_out_40,45
        .set    pair_8,20
        .set    a_out_41,47
        .set    a_out_42,49
        .set    bit_39,50
        .set    bit_40,51
        .set    a_out_43,48
        .set    a_out_44,50
        .set    bit_41,52
        .set    bit_42,53
        .set    a_out_45,51
        .set    pair_9,21
        .set    a_out_46,52
        .set    a_out_47,53
        .set    a_out_48,3
        .set    pair_10,8
        .set    pair_11,6
        lqa     $m_pair,pair_of_object_and_place        # 0o
        lqd     $pair,0($a_places)                      # 1o

        lqd     $masks,0($a_masks)                      # 2o
        shufb   $pair,$object,$pair,$m_pair             # 7o

        shli    $masks,$masks,4                         # 8e
        stqd    $pair,0($a_out)                         # 11o may alias the one before

        rotmi   $bit,$masks,-15                         # 12e
        lqd     $pair,16($a_places)                     # 12o

        rotmi   $bit_2,$masks,-14                       # 13e
        rotqbyi $masks_2,$masks,4                       # 13o

        rotmi   $bit_3,$masks,-13                       # 14e
        rotmi   $bit_4,$masks,-12                       # 15e

        andi    $bit,$bit,16                            # 16e
        lnop                                            # 16o pairing

        andi    $bit_2,$bit_2,16                        # 17e
        rotqbyi $masks_3,$masks_2,4                     # 17o

        a       $a_out,$a_out,$bit                      # 18e
        shufb   $pair,$object,$pair,$m_pair             # 18o

        andi    $bit,$bit_3,16                          # 19e
        a       $a_out_2,$a_out,$bit_2                  # 20e

        andi    $bit_3,$bit_4,16                        # 21e
        rotqbyi $masks_4,$masks_3,4                     # 21o

        a       $a_out_3,$a_out_2,$bit                  # 22e
        stqd    $pair,0($a_out)                         # 22o may alias the one before

        rotmi   $bit_5,$masks,-11                       # 23e
        lqd     $pair,32($a_places)                     # 23o

        a       $a_out_4,$a_out_3,$bit_3                # 24e
        lnop                                            # 24o pairing

        rotmi   $bit_6,$masks,-10                       # 25e
        rotqbyi $masks_5,$masks_4,4                     # 25o

        rotmi   $bit_7,$masks,-9                        # 26e
        andi    $bit_5,$bit_5,16                        # 27e

        rotmi   $bit_8,$masks,-8                        # 28e
        lnop                                            # 28o pairing

        a       $a_out,$a_out_4,$bit_5                  # 29e
        shufb   $pair,$object,$pair,$m_pair             # 29o

        andi    $bit_6,$bit_6,16                        # 30e
        andi    $bit_7,$bit_7,16                        # 31e

        a       $a_out_5,$a_out,$bit_6                  # 32e
        lnop                                            # 32o pairing

        andi    $bit_8,$bit_8,16                        # 33e
        stqd    $pair,0($a_out_2)                       # 33o may alias the one before

        a       $a_out_2,$a_out_5,$bit_7                # 34e
        lqd     $pair,48($a_places)                     # 34o

        rotmi   $bit_7,$masks,-7                        # 35e
        a       $a_out_6,$a_out_2,$bit_8                # 36e

        rotmi   $bit_9,$masks,-6                        # 37e
        rotmi   $bit_10,$masks,-5                       # 38e

        andi    $bit_7,$bit_7,16                        # 39e
        lnop                                            # 39o pairing

        rotmi   $bit_11,$masks,-4                       # 40e
        shufb   $pair,$object,$pair,$m_pair             # 40o

        a       $a_out_7,$a_out_6,$bit_7                # 41e
        andi    $bit_9,$bit_9,16                        # 42e

        andi    $bit_10,$bit_10,16                      # 43e
        lnop                                            # 43o pairing

        a       $a_out_8,$a_out_7,$bit_9                # 44e
        stqd    $pair,0($a_out_3)                       # 44o may alias the one before

        andi    $bit,$bit_11,16                         # 45e
        lqd     $pair,64($a_places)                     # 45o

        a       $a_out_9,$a_out_8,$bit_10               # 46e
        rotmi   $bit_11,$masks,-3                       # 47e

        a       $a_out_3,$a_out_9,$bit                  # 48e
        rotmi   $bit_12,$masks,-2                       # 49e

        rotmi   $bit_13,$masks,-1                       # 50e
        lnop                                            # 50o pairing

        andi    $bit_11,$bit_11,16                      # 51e
        shufb   $pair,$object,$pair,$m_pair             # 51o

        rotmi   $bit_14,$masks,0                        # 52e
        a       $a_out_10,$a_out_3,$bit_11              # 53e

        andi    $bit_12,$bit_12,16                      # 54e
        lnop                                            # 54o pairing

        andi    $bit_13,$bit_13,16                      # 55e
        stqd    $pair,0($a_out_4)                       # 55o may alias the one before

        a       $a_out_4,$a_out_10,$bit_12              # 56e
        lqd     $pair,80($a_places)                     # 56o

        andi    $bit_14,$bit_14,16                      # 57e
        a       $a_out_11,$a_out_4,$bit_13              # 58e

        rotmi   $bit_13,$masks_2,-15                    # 59e
        a       $a_out_12,$a_out_11,$bit_14             # 60e

        rotmi   $bit_15,$masks_2,-14                    # 61e
        lnop                                            # 61o pairing

        rotmi   $bit_16,$masks_2,-13                    # 62e
        shufb   $pair,$object,$pair,$m_pair             # 62o

        andi    $bit_13,$bit_13,16                      # 63e
        rotmi   $bit_17,$masks_2,-12                    # 64e

        a       $a_out_13,$a_out_12,$bit_13             # 65e
        lnop                                            # 65o pairing

        andi    $bit_15,$bit_15,16                      # 66e
        stqd    $pair,0($a_out)                         # 66o may alias the one before

        andi    $bit_5,$bit_16,16                       # 67e
        lqd     $pair,96($a_places)                     # 67o

        a       $a_out_14,$a_out_13,$bit_15             # 68e
        andi    $bit_16,$bit_17,16                      # 69e

        a       $a_out,$a_out_14,$bit_5                 # 70e
        rotmi   $bit_17,$masks_2,-11                    # 71e

        a       $a_out_15,$a_out,$bit_16                # 72e
        lnop                                            # 72o pairing

        rotmi   $bit_18,$masks_2,-10                    # 73e
        shufb   $pair,$object,$pair,$m_pair             # 73o

        rotmi   $bit_19,$masks_2,-9                     # 74e
        andi    $bit_17,$bit_17,16                      # 75e

        rotmi   $bit_20,$masks_2,-8                     # 76e
        lnop                                            # 76o pairing

        a       $a_out_16,$a_out_15,$bit_17             # 77e
        stqd    $pair,0($a_out_5)                       # 77o may alias the one before

        andi    $bit_21,$bit_18,16                      # 78e
        lqd     $pair_2,112($a_places)                  # 78o

        andi    $bit_18,$bit_19,16                      # 79e
        a       $a_out_17,$a_out_16,$bit_21             # 80e

        andi    $bit_19,$bit_20,16                      # 81e
        a       $a_out_18,$a_out_17,$bit_18             # 82e

        rotmi   $bit_20,$masks_2,-7                     # 83e
        lnop                                            # 83o pairing

        a       $a_out_19,$a_out_18,$bit_19             # 84e
        shufb   $pair_2,$object,$pair_2,$m_pair         # 84o

        rotmi   $bit_22,$masks_2,-6                     # 85e
        rotmi   $bit_23,$masks_2,-5                     # 86e

        andi    $bit_20,$bit_20,16                      # 87e
        lnop                                            # 87o pairing

        rotmi   $bit_24,$masks_2,-4                     # 88e
        stqd    $pair_2,0($a_out_2)                     # 88o may alias the one before

        a       $a_out_2,$a_out_19,$bit_20              # 89e
        lqd     $pair_2,128($a_places)                  # 89o

        andi    $bit_20,$bit_22,16                      # 90e
        andi    $bit_22,$bit_23,16                      # 91e

        a       $a_out_20,$a_out_2,$bit_20              # 92e
        andi    $bit_23,$bit_24,16                      # 93e

        a       $a_out_21,$a_out_20,$bit_22             # 94e
        lnop                                            # 94o pairing

        rotmi   $bit_24,$masks_2,-3                     # 95e
        shufb   $pair_2,$object,$pair_2,$m_pair         # 95o

        a       $a_out_22,$a_out_21,$bit_23             # 96e
        rotmi   $bit_25,$masks_2,-2                     # 97e

        rotmi   $bit_26,$masks_2,-1                     # 98e
        lnop                                            # 98o pairing

        andi    $bit_24,$bit_24,16                      # 99e
        stqd    $pair_2,0($a_out_6)                     # 99o may alias the one before

        rotmi   $bit_27,$masks_2,0                      # 100e
        lqd     $pair_2,144($a_places)                  # 100o

        a       $a_out_6,$a_out_22,$bit_24              # 101e
        andi    $bit_24,$bit_25,16                      # 102e

        andi    $bit_25,$bit_26,16                      # 103e
        a       $a_out_23,$a_out_6,$bit_24              # 104e

        andi    $bit_27,$bit_27,16                      # 105e
        lnop                                            # 105o pairing

        a       $a_out_24,$a_out_23,$bit_25             # 106e
        shufb   $pair_2,$object,$pair_2,$m_pair         # 106o

        rotmi   $bit_26,$masks_3,-15                    # 107e
        a       $a_out_25,$a_out_24,$bit_27             # 108e

        rotmi   $bit_27,$masks_3,-14                    # 109e
        lnop                                            # 109o pairing

        rotmi   $bit_28,$masks_3,-13                    # 110e
        stqd    $pair_2,0($a_out_7)                     # 110o may alias the one before

        andi    $bit_6,$bit_26,16                       # 111e
        lqd     $pair_3,160($a_places)                  # 111o

        rotmi   $bit_26,$masks_3,-12                    # 112e
        a       $a_out_5,$a_out_25,$bit_6               # 113e

        andi    $bit_27,$bit_27,16                      # 114e
        andi    $bit_28,$bit_28,16                      # 115e

        a       $a_out_26,$a_out_5,$bit_27              # 116e
        lnop                                            # 116o pairing

        andi    $bit_27,$bit_26,16                      # 117e
        shufb   $pair_3,$object,$pair_3,$m_pair         # 117o

        a       $a_out_27,$a_out_26,$bit_28             # 118e
        rotmi   $bit_28,$masks_3,-11                    # 119e

        a       $a_out_28,$a_out_27,$bit_27             # 120e
        lnop                                            # 120o pairing

        rotmi   $bit_27,$masks_3,-10                    # 121e
        stqd    $pair_3,0($a_out_8)                     # 121o may alias the one before

        rotmi   $bit_7,$masks_3,-9                      # 122e
        lqd     $pair_4,176($a_places)                  # 122o

        andi    $bit_28,$bit_28,16                      # 123e
        rotmi   $bit_29,$masks_3,-8                     # 124e

        a       $a_out_29,$a_out_28,$bit_28             # 125e
        andi    $bit_27,$bit_27,16                      # 126e

        andi    $bit_7,$bit_7,16                        # 127e
        lnop                                            # 127o pairing

        a       $a_out_30,$a_out_29,$bit_27             # 128e
        shufb   $pair_5,$object,$pair_4,$m_pair         # 128o

        andi    $bit_9,$bit_29,16                       # 129e
        a       $a_out_7,$a_out_30,$bit_7               # 130e

        rotmi   $bit_29,$masks_3,-7                     # 131e
        lnop                                            # 131o pairing

        a       $a_out_8,$a_out_7,$bit_9                # 132e
        stqd    $pair_5,0($a_out_9)                     # 132o may alias the one before

        rotmi   $bit_27,$masks_3,-6                     # 133e
        lqd     $pair_6,192($a_places)                  # 133o

        rotmi   $bit_30,$masks_3,-5                     # 134e
        andi    $bit_29,$bit_29,16                      # 135e

        rotmi   $bit_31,$masks_3,-4                     # 136e
        a       $a_out_31,$a_out_8,$bit_29              # 137e

        andi    $bit_27,$bit_27,16                      # 138e
        lnop                                            # 138o pairing

        andi    $bit_30,$bit_30,16                      # 139e
        shufb   $pair_6,$object,$pair_6,$m_pair         # 139o

        a       $a_out_32,$a_out_31,$bit_27             # 140e
        andi    $bit_27,$bit_31,16                      # 141e

        a       $a_out_33,$a_out_32,$bit_30             # 142e
        lnop                                            # 142o pairing

        rotmi   $bit_31,$masks_3,-3                     # 143e
        stqd    $pair_6,0($a_out_3)                     # 143o may alias the one before

        a       $a_out_3,$a_out_33,$bit_27              # 144e
        lqd     $pair_5,208($a_places)                  # 144o

        rotmi   $bit_10,$masks_3,-2                     # 145e
        rotmi   $bit_32,$masks_3,-1                     # 146e

        andi    $bit_31,$bit_31,16                      # 147e
        rotmi   $bit_33,$masks_3,0                      # 148e

        a       $a_out_34,$a_out_3,$bit_31              # 149e
        lnop                                            # 149o pairing

        andi    $bit_10,$bit_10,16                      # 150e
        shufb   $pair_5,$object,$pair_5,$m_pair         # 150o

        andi    $bit_32,$bit_32,16                      # 151e
        a       $a_out_9,$a_out_34,$bit_10              # 152e

        andi    $bit_33,$bit_33,16                      # 153e
        lnop                                            # 153o pairing

        a       $a_out_35,$a_out_9,$bit_32              # 154e
        stqd    $pair_5,0($a_out_10)                    # 154o may alias the one before

        rotmi   $bit_27,$masks_4,-15                    # 155e
        lqd     $pair_7,224($a_places)                  # 155o

        a       $a_out_36,$a_out_35,$bit_33             # 156e
        rotmi   $bit_34,$masks_4,-14                    # 157e

        rotmi   $bit_35,$masks_4,-13                    # 158e
        andi    $bit_27,$bit_27,16                      # 159e

        rotmi   $bit_36,$masks_4,-12                    # 160e
        lnop                                            # 160o pairing

        a       $a_out_37,$a_out_36,$bit_27             # 161e
        shufb   $pair_5,$object,$pair_7,$m_pair         # 161o

        andi    $bit_11,$bit_34,16                      # 162e
        andi    $bit_34,$bit_35,16                      # 163e

        a       $a_out_10,$a_out_37,$bit_11             # 164e
        lnop                                            # 164o pairing

        andi    $bit_35,$bit_36,16                      # 165e
        stqd    $pair_5,0($a_out_4)                     # 165o may alias the one before

        a       $a_out_4,$a_out_10,$bit_34              # 166e
        lqd     $pair_5,240($a_places)                  # 166o

        rotmi   $bit_34,$masks_4,-11                    # 167e
        a       $a_out_38,$a_out_4,$bit_35              # 168e

        rotmi   $bit_36,$masks_4,-10                    # 169e
        rotmi   $bit_37,$masks_4,-9                     # 170e

        andi    $bit_34,$bit_34,16                      # 171e
        lnop                                            # 171o pairing

        rotmi   $bit_38,$masks_4,-8                     # 172e
        shufb   $pair_5,$object,$pair_5,$m_pair         # 172o

        a       $a_out_39,$a_out_38,$bit_34             # 173e
        andi    $bit_36,$bit_36,16                      # 174e

        andi    $bit_37,$bit_37,16                      # 175e
        lnop                                            # 175o pairing

        a       $a_out_40,$a_out_39,$bit_36             # 176e
        stqd    $pair_5,0($a_out_11)                    # 176o may alias the one before

        andi    $bit_27,$bit_38,16                      # 177e
        lqd     $pair_8,256($a_places)                  # 177o

        a       $a_out_41,$a_out_40,$bit_37             # 178e
        rotmi   $bit_38,$masks_4,-7                     # 179e

        a       $a_out_42,$a_out_41,$bit_27             # 180e
        rotmi   $bit_27,$masks_4,-6                     # 181e

        rotmi   $bit_39,$masks_4,-5                     # 182e
        lnop                                            # 182o pairing

        andi    $bit_38,$bit_38,16                      # 183e
        shufb   $pair_8,$object,$pair_8,$m_pair         # 183o

        rotmi   $bit_40,$masks_4,-4                     # 184e
        a       $a_out_43,$a_out_42,$bit_38             # 185e

        andi    $bit_27,$bit_27,16                      # 186e
        lnop                                            # 186o pairing

        andi    $bit_39,$bit_39,16                      # 187e
        stqd    $pair_8,0($a_out_12)                    # 187o may alias the one before

        a       $a_out_12,$a_out_43,$bit_27             # 188e
        lqd     $pair_5,272($a_places)                  # 188o

        andi    $bit_12,$bit_40,16                      # 189e
        a       $a_out_44,$a_out_12,$bit_39             # 190e

        rotmi   $bit_40,$masks_4,-3                     # 191e
        a       $a_out_11,$a_out_44,$bit_12             # 192e

        rotmi   $bit_41,$masks_4,-2                     # 193e
        lnop                                            # 193o pairing

        rotmi   $bit_42,$masks_4,-1                     # 194e
        shufb   $pair_5,$object,$pair_5,$m_pair         # 194o

        andi    $bit_40,$bit_40,16                      # 195e
        rotmi   $bit_4,$masks_4,0                       # 196e

        a       $a_out_45,$a_out_11,$bit_40             # 197e
        lnop                                            # 197o pairing

        andi    $bit_41,$bit_41,16                      # 198e
        stqd    $pair_5,0($a_out_13)                    # 198o may alias the one before

        andi    $bit_27,$bit_42,16                      # 199e
        lqd     $pair_9,288($a_places)                  # 199o

        a       $a_out_46,$a_out_45,$bit_41             # 200e
        andi    $bit_4,$bit_4,16                        # 201e

        a       $a_out_47,$a_out_46,$bit_27             # 202e
        a       $a_out_48,$a_out_47,$bit_4              # 204e

        shufb   $pair_10,$object,$pair_9,$m_pair        # 205o
        ori     $a_masks,$a_out_48,0                    # 206e

        stqd    $pair_10,0($a_out_14)                   # 209o may alias the one before
        lqd     $pair_10,304($a_places)                 # 210o

        shufb   $pair_10,$object,$pair_10,$m_pair       # 216o
        stqd    $pair_10,0($a_out)                      # 220o may alias the one before

        lqd     $pair_11,320($a_places)                 # 221o
        shufb   $pair_11,$object,$pair_11,$m_pair       # 227o

        stqd    $pair_11,0($a_out_15)                   # 231o may alias the one before
        lqd     $pair_11,336($a_places)                 # 232o

        shufb   $pair_11,$object,$pair_11,$m_pair       # 238o
        stqd    $pair_11,0($a_out_16)                   # 242o may alias the one before

        lqd     $pair_11,352($a_places)                 # 243o
        shufb   $pair_11,$object,$pair_11,$m_pair       # 249o

        stqd    $pair_11,0($a_out_17)                   # 253o may alias the one before
        lqd     $pair,368($a_places)                    # 254o

        shufb   $pair,$object,$pair,$m_pair             # 260o
        stqd    $pair,0($a_out_18)                      # 264o may alias the one before

        lqd     $pair,384($a_places)                    # 265o
        shufb   $pair,$object,$pair,$m_pair             # 271o

        stqd    $pair,0($a_out_19)                      # 275o may alias the one before
        lqd     $pair,400($a_places)                    # 276o

        shufb   $pair,$object,$pair,$m_pair             # 282o
        stqd    $pair,0($a_out_2)                       # 286o may alias the one before

        lqd     $pair,416($a_places)                    # 287o
        shufb   $pair,$object,$pair,$m_pair             # 293o

        stqd    $pair,0($a_out_20)                      # 297o may alias the one before
        lqd     $pair,432($a_places)                    # 298o

        shufb   $pair,$object,$pair,$m_pair             # 304o
        stqd    $pair,0($a_out_21)                      # 308o may alias the one before

        lqd     $pair,448($a_places)                    # 309o
        shufb   $pair,$object,$pair,$m_pair             # 315o

        stqd    $pair,0($a_out_22)                      # 319o may alias the one before
        lqd     $pair,464($a_places)                    # 320o

        shufb   $pair,$object,$pair,$m_pair             # 326o
        stqd    $pair,0($a_out_6)                       # 330o may alias the one before

        lqd     $pair,480($a_places)                    # 331o
        shufb   $pair,$object,$pair,$m_pair             # 337o

        stqd    $pair,0($a_out_23)                      # 341o may alias the one before
        lqd     $pair,496($a_places)                    # 342o

        shufb   $pair,$object,$pair,$m_pair             # 348o
        stqd    $pair,0($a_out_24)                      # 352o may alias the one before

        lqd     $pair,512($a_places)                    # 353o
        shufb   $pair,$object,$pair,$m_pair             # 359o

        stqd    $pair,0($a_out_25)                      # 363o may alias the one before
        lqd     $pair,528($a_places)                    # 364o

        shufb   $pair,$object,$pair,$m_pair             # 370o
        stqd    $pair,0($a_out_5)                       # 374o may alias the one before

        lqd     $pair,544($a_places)                    # 375o
        shufb   $pair,$object,$pair,$m_pair             # 381o

        stqd    $pair,0($a_out_26)                      # 385o may alias the one before
        lqd     $pair,560($a_places)                    # 386o

        shufb   $pair,$object,$pair,$m_pair             # 392o
        stqd    $pair,0($a_out_27)                      # 396o may alias the one before

        lqd     $pair,576($a_places)                    # 397o
        shufb   $pair,$object,$pair,$m_pair             # 403o

        stqd    $pair,0($a_out_28)                      # 407o may alias the one before
        lqd     $pair,592($a_places)                    # 408o

        shufb   $pair,$object,$pair,$m_pair             # 414o
        stqd    $pair,0($a_out_29)                      # 418o may alias the one before

        lqd     $pair,608($a_places)                    # 419o
        shufb   $pair,$object,$pair,$m_pair             # 425o

        stqd    $pair,0($a_out_30)                      # 429o may alias the one before
        lqd     $pair,624($a_places)                    # 430o

        shufb   $pair,$object,$pair,$m_pair             # 436o
        stqd    $pair,0($a_out_7)                       # 440o may alias the one before

        lqd     $pair,640($a_places)                    # 441o
        hbr     list_pairs_p64_return,$lr               # 442o hint

        shufb   $pair,$object,$pair,$m_pair             # 447o
        stqd    $pair,0($a_out_8)                       # 451o may alias the one before

        lqd     $pair,656($a_places)                    # 452o
        shufb   $pair,$object,$pair,$m_pair             # 458o

        stqd    $pair,0($a_out_31)                      # 462o may alias the one before
        lqd     $pair,672($a_places)                    # 463o

        shufb   $pair,$object,$pair,$m_pair             # 469o
        stqd    $pair,0($a_out_32)                      # 473o may alias the one before

        lqd     $pair,688($a_places)                    # 474o
        shufb   $pair,$object,$pair,$m_pair             # 480o

        stqd    $pair,0($a_out_33)                      # 484o may alias the one before
        lqd     $pair,704($a_places)                    # 485o

        shufb   $pair,$object,$pair,$m_pair             # 491o
        stqd    $pair,0($a_out_3)                       # 495o may alias the one before

        lqd     $pair,720($a_places)                    # 496o
        shufb   $pair,$object,$pair,$m_pair             # 502o

        stqd    $pair,0($a_out_34)                      # 506o may alias the one before
        lqd     $pair,736($a_places)                    # 507o

        shufb   $pair,$object,$pair,$m_pair             # 513o
        stqd    $pair,0($a_out_9)                       # 517o may alias the one before

        lqd     $pair,752($a_places)                    # 518o
        shufb   $pair,$object,$pair,$m_pair             # 524o

        stqd    $pair,0($a_out_35)                      # 528o may alias the one before
        lqd     $pair,768($a_places)                    # 529o

        shufb   $pair,$object,$pair,$m_pair             # 535o
        stqd    $pair,0($a_out_36)                      # 539o may alias the one before

        lqd     $pair,784($a_places)                    # 540o
        shufb   $pair,$object,$pair,$m_pair             # 546o

        stqd    $pair,0($a_out_37)                      # 550o may alias the one before
        lqd     $pair,800($a_places)                    # 551o

        shufb   $pair,$object,$pair,$m_pair             # 557o
        stqd    $pair,0($a_out_10)                      # 561o may alias the one before

        lqd     $pair,816($a_places)                    # 562o
        shufb   $pair,$object,$pair,$m_pair             # 568o

        stqd    $pair,0($a_out_4)                       # 572o may alias the one before
        lqd     $pair,832($a_places)                    # 573o

        shufb   $pair,$object,$pair,$m_pair             # 579o
        stqd    $pair,0($a_out_38)                      # 583o may alias the one before

        lqd     $pair,848($a_places)                    # 584o
        shufb   $pair,$object,$pair,$m_pair             # 590o

        stqd    $pair,0($a_out_39)                      # 594o may alias the one before
        lqd     $pair,864($a_places)                    # 595o

        shufb   $pair,$object,$pair,$m_pair             # 601o
        stqd    $pair,0($a_out_40)                      # 605o may alias the one before

        lqd     $pair,880($a_places)                    # 606o
        shufb   $pair,$object,$pair,$m_pair             # 612o

        stqd    $pair,0($a_out_41)                      # 616o may alias the one before
        lqd     $pair,896($a_places)                    # 617o

        shufb   $pair,$object,$pair,$m_pair             # 623o
        stqd    $pair,0($a_out_42)                      # 627o may alias the one before

        lqd     $pair,912($a_places)                    # 628o
        shufb   $pair,$object,$pair,$m_pair             # 634o

        stqd    $pair,0($a_out_43)                      # 638o may alias the one before
        lqd     $pair,928($a_places)                    # 639o

        shufb   $pair,$object,$pair,$m_pair             # 645o
        stqd    $pair,0($a_out_12)                      # 649o may alias the one before

        lqd     $pair,944($a_places)                    # 650o
        shufb   $pair,$object,$pair,$m_pair             # 656o

        stqd    $pair,0($a_out_44)                      # 660o may alias the one before
        lqd     $pair,960($a_places)                    # 661o

        shufb   $pair,$object,$pair,$m_pair             # 667o
        stqd    $pair,0($a_out_11)                      # 671o may alias the one before

        lqd     $pair,976($a_places)                    # 672o
        shufb   $pair,$object,$pair,$m_pair             # 678o

        stqd    $pair,0($a_out_45)                      # 682o may alias the one before
        lqd     $pair,992($a_places)                    # 683o

        shufb   $pair,$object,$pair,$m_pair             # 689o
        stqd    $pair,0($a_out_46)                      # 693o may alias the one before

        lqd     $pair,1008($a_places)                   # 694o
        shufb   $pair,$object,$pair,$m_pair             # 700o

        stqd    $pair,0($a_out_47)                      # 704o may alias the one before
list_pairs_p64_return:
        bi      $lr                                     # 705o
endfunction list_pairs_p64
