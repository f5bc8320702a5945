# list_pairs_p64   pairs of one object with those packets of a tile that masks name
#   C       struct pair *list_pairs_p64(const unsigned masks[4], const struct place *,
#                                       const void *object, struct pair *);
#   In      $3 masks, one for each sixteen packets: 16 bits, the highest of the first; $4 the
#           places of 64 packets; $5 address of the object's record; $6 where the pairs go;
#           pointers 16-aligned
#   Out     the pairs; one more quadword may be written
#           $3 behind the pairs
#   Uses    $2-$4, $6-$33   Saves  -   Stack  0   Calls  -
#   Domain  any
#   Error   0
#   Twin    lab/twins/src/lists.rs
# Scheduled by spu schedule from list_pairs_p64.s

        .include "work_unit.inc"
        .include "macros.inc"
        .include "lists.inc"

        .set    NEXT,3
        registers a_masks,a_places,object,a_out
        # constants
        .set    NEXT,10
        registers m_pair
        # temporaries
        registers masks,bit
        registers pair                                  # to 28

        .section .rodata
        .align  4
        # A pair: the object's word, then the packet's out of a place.
pair_of_object_and_place:
        .int    0x00010203,0x10111213,0x14151617,0x18191a1b

function list_pairs_p64
        .set masks_2,2; .set bit_2,3; .set bit_3,7; .set bit_4,8; .set a_out_2,9; .set a_out_3,3
        .set a_out_4,12; .set bit_5,28; .set pair15_2,29; .set a_out_5,8; .set bit_6,6
        .set a_out_6,7; .set bit_7,9; .set bit_8,13; .set masks_3,8; .set masks_4,6
        .set a_out_7,11; .set bit_9,20; .set pair7_2,21; .set bit_10,22; .set pair8_2,23
        .set pair9_2,24; .set bit_11,25; .set pair10_2,26; .set a_out_8,20; .set pair11_2,27
        .set pair12_2,28; .set bit_12,29; .set pair13_2,30; .set a_out_9,22; .set pair14_2,31
        .set pair15_3,32; .set bit_13,33; .set a_out_10,25; .set bit_14,11; .set pair7_3,14
        .set pair9_3,9; .set bit_15,15; .set bit_16,16; .set a_out_11,13; .set bit_17,14
        .set a_out_12,14; .set bit_18,2; .set a_out_13,2; .set bit_19,21; .set pair8_3,22
        .set pair9_4,23; .set bit_20,24; .set pair10_3,25; .set pair11_3,26; .set pair12_3,27
        .set pair13_3,29; .set a_out_14,21; .set pair14_3,30; .set pair15_4,31; .set bit_21,32
        .set a_out_15,24; .set pair8_4,13; .set pair11_4,14; .set bit_22,23; .set pair10_4,24
        .set pair11_5,25; .set pair12_4,26; .set bit_23,27; .set pair13_4,28; .set pair14_4,29
        .set pair15_5,4; .set bit_24,30; .set a_out_16,23; .set pair10_5,12; .set a_out_17,4
        lqd     $masks,0($a_masks)                      # 0o
        lqa     $m_pair,pair_of_object_and_place        # 1o
        lqd     $pair,0($a_places)                      # 2o
        lqd     $pair+1,16($a_places)                   # 3o
        lqd     $pair+2,32($a_places)                   # 4o
        lqd     $pair+3,48($a_places)                   # 5o
        shli    $masks,$masks,4                         # 6e
        lqd     $pair+4,64($a_places)                   # 6o
        lqd     $pair+5,80($a_places)                   # 7o
        shufb   $pair,$object,$pair,$m_pair             # 8o
        nop     $127                                    # 9e pairing
        lqd     $pair+6,96($a_places)                   # 9o
        rotmi   $bit,$masks,-15                         # 10e
        rotqbyi $masks_2,$masks,4                       # 10o
        rotmi   $bit_2,$masks,-14                       # 11e
        shufb   $pair+1,$object,$pair+1,$m_pair         # 11o
        rotmi   $bit_3,$masks,-13                       # 12e
        lqd     $pair+7,112($a_places)                  # 12o
        rotmi   $bit_4,$masks,-12                       # 13e
        shufb   $pair+2,$object,$pair+2,$m_pair         # 13o
        andi    $bit,$bit,16                            # 14e
        lqd     $pair+8,128($a_places)                  # 14o
        andi    $bit_2,$bit_2,16                        # 15e
        shufb   $pair+3,$object,$pair+3,$m_pair         # 15o
        a       $a_out_2,$a_out,$bit                    # 16e
        lqd     $pair+9,144($a_places)                  # 16o
        andi    $bit,$bit_3,16                          # 17e
        lqd     $pair+10,160($a_places)                 # 17o
        a       $a_out_3,$a_out_2,$bit_2                # 18e
        lqd     $pair+11,176($a_places)                 # 18o
        rotmi   $bit_3,$masks,-11                       # 19e
        lqd     $pair+12,192($a_places)                 # 19o
        a       $a_out_4,$a_out_3,$bit                  # 20e
        lqd     $pair+13,208($a_places)                 # 20o
        andi    $bit_4,$bit_4,16                        # 21e
        lqd     $pair+14,224($a_places)                 # 21o
        rotmi   $bit_5,$masks,-10                       # 22e
        lqd     $pair15_2,240($a_places)                # 22o
        a       $a_out_5,$a_out_4,$bit_4                # 23e
        shufb   $pair+4,$object,$pair+4,$m_pair         # 23o
        andi    $bit_3,$bit_3,16                        # 24e
        stqd    $pair,0($a_out)                         # 24o may alias the one before
        rotmi   $bit_6,$masks,-9                        # 25e
        shufb   $pair+5,$object,$pair+5,$m_pair         # 25o
        a       $a_out_6,$a_out_5,$bit_3                # 26e
        stqd    $pair+1,0($a_out_2)                     # 26o may alias the one before
        andi    $bit_7,$bit_5,16                        # 27e
        shufb   $pair+6,$object,$pair+6,$m_pair         # 27o
        rotmi   $bit_8,$masks,-8                        # 28e
        stqd    $pair+2,0($a_out_3)                     # 28o may alias the one before
        a       $a_out_3,$a_out_6,$bit_7                # 29e
        shufb   $pair+7,$object,$pair+7,$m_pair         # 29o
        andi    $bit_6,$bit_6,16                        # 30e
        stqd    $pair+3,0($a_out_4)                     # 30o may alias the one before
        rotmi   $bit,$masks,-7                          # 31e
        shufb   $pair+8,$object,$pair+8,$m_pair         # 31o
        a       $a_out,$a_out_3,$bit_6                  # 32e
        stqd    $pair+4,0($a_out_5)                     # 32o may alias the one before
        andi    $bit_4,$bit_8,16                        # 33e
        shufb   $pair+9,$object,$pair+9,$m_pair         # 33o
        rotmi   $bit_7,$masks,-6                        # 34e
        stqd    $pair+5,0($a_out_6)                     # 34o may alias the one before
        a       $a_out_6,$a_out,$bit_4                  # 35e
        shufb   $pair+10,$object,$pair+10,$m_pair       # 35o
        andi    $bit,$bit,16                            # 36e
        stqd    $pair+6,0($a_out_3)                     # 36o may alias the one before
        rotmi   $bit_2,$masks,-5                        # 37e
        shufb   $pair+11,$object,$pair+11,$m_pair       # 37o
        a       $a_out_5,$a_out_6,$bit                  # 38e
        stqd    $pair+7,0($a_out)                       # 38o may alias the one before
        andi    $bit,$bit_7,16                          # 39e
        shufb   $pair+12,$object,$pair+12,$m_pair       # 39o
        rotmi   $bit_6,$masks,-4                        # 40e
        stqd    $pair+8,0($a_out_6)                     # 40o may alias the one before
        a       $a_out_6,$a_out_5,$bit                  # 41e
        shufb   $pair+13,$object,$pair+13,$m_pair       # 41o
        andi    $bit,$bit_2,16                          # 42e
        stqd    $pair+9,0($a_out_5)                     # 42o may alias the one before
        rotmi   $bit_2,$masks,-3                        # 43e
        shufb   $pair+14,$object,$pair+14,$m_pair       # 43o
        a       $a_out_5,$a_out_6,$bit                  # 44e
        stqd    $pair+10,0($a_out_6)                    # 44o may alias the one before
        andi    $bit,$bit_6,16                          # 45e
        shufb   $pair+15,$object,$pair15_2,$m_pair      # 45o
        rotmi   $bit_6,$masks,-2                        # 46e
        stqd    $pair+11,0($a_out_5)                    # 46o may alias the one before
        a       $a_out_6,$a_out_5,$bit                  # 47e
        rotqbyi $masks_3,$masks_2,4                     # 47o
        andi    $bit,$bit_2,16                          # 48e
        lnop                                            # 48o pairing
        rotmi   $bit_2,$masks,-1                        # 49e
        stqd    $pair+12,0($a_out_6)                    # 49o may alias the one before
        a       $a_out_6,$a_out_6,$bit                  # 50e
        lnop                                            # 50o pairing
        andi    $bit,$bit_6,16                          # 51e
        rotqbyi $masks_4,$masks_3,4                     # 51o
        rotmi   $bit_7,$masks,0                         # 52e
        stqd    $pair+13,0($a_out_6)                    # 52o may alias the one before
        a       $a_out_6,$a_out_6,$bit                  # 53e
        andi    $bit,$bit_2,16                          # 54e
        rotmi   $bit_2,$masks_2,-15                     # 55e
        stqd    $pair+14,0($a_out_6)                    # 55o may alias the one before
        a       $a_out_6,$a_out_6,$bit                  # 56e
        rotqbyi $masks,$masks_4,4                       # 56o
        andi    $bit,$bit_7,16                          # 57e
        lnop                                            # 57o pairing
        rotmi   $bit_7,$masks_2,-14                     # 58e
        stqd    $pair+15,0($a_out_6)                    # 58o may alias the one before
        a       $a_out_6,$a_out_6,$bit                  # 59e
        lqd     $pair,256($a_places)                    # 59o
        andi    $bit,$bit_2,16                          # 60e
        lqd     $pair+1,272($a_places)                  # 60o
        rotmi   $bit_2,$masks_2,-13                     # 61e
        lqd     $pair+2,288($a_places)                  # 61o
        a       $a_out_7,$a_out_6,$bit                  # 62e
        lqd     $pair+3,304($a_places)                  # 62o
        andi    $bit,$bit_7,16                          # 63e
        lqd     $pair+4,320($a_places)                  # 63o
        rotmi   $bit_7,$masks_2,-12                     # 64e
        lqd     $pair+5,336($a_places)                  # 64o
        a       $a_out_4,$a_out_7,$bit                  # 65e
        shufb   $pair,$object,$pair,$m_pair             # 65o
        andi    $bit_2,$bit_2,16                        # 66e
        lqd     $pair+6,352($a_places)                  # 66o
        rotmi   $bit_9,$masks_2,-11                     # 67e
        shufb   $pair+1,$object,$pair+1,$m_pair         # 67o
        a       $a_out_3,$a_out_4,$bit_2                # 68e
        lqd     $pair7_2,368($a_places)                 # 68o
        andi    $bit_7,$bit_7,16                        # 69e
        shufb   $pair+2,$object,$pair+2,$m_pair         # 69o
        rotmi   $bit_10,$masks_2,-10                    # 70e
        lqd     $pair8_2,384($a_places)                 # 70o
        a       $a_out_2,$a_out_3,$bit_7                # 71e
        shufb   $pair+3,$object,$pair+3,$m_pair         # 71o
        andi    $bit_9,$bit_9,16                        # 72e
        lqd     $pair9_2,400($a_places)                 # 72o
        rotmi   $bit_11,$masks_2,-9                     # 73e
        lqd     $pair10_2,416($a_places)                # 73o
        a       $a_out_8,$a_out_2,$bit_9                # 74e
        lqd     $pair11_2,432($a_places)                # 74o
        andi    $bit_10,$bit_10,16                      # 75e
        lqd     $pair12_2,448($a_places)                # 75o
        rotmi   $bit_12,$masks_2,-8                     # 76e
        lqd     $pair13_2,464($a_places)                # 76o
        a       $a_out_9,$a_out_8,$bit_10               # 77e
        lqd     $pair14_2,480($a_places)                # 77o
        andi    $bit_11,$bit_11,16                      # 78e
        lqd     $pair15_3,496($a_places)                # 78o
        rotmi   $bit_13,$masks_2,-7                     # 79e
        shufb   $pair+4,$object,$pair+4,$m_pair         # 79o
        a       $a_out_10,$a_out_9,$bit_11              # 80e
        stqd    $pair,0($a_out_6)                       # 80o may alias the one before
        andi    $bit_3,$bit_12,16                       # 81e
        shufb   $pair+5,$object,$pair+5,$m_pair         # 81o
        rotmi   $bit_8,$masks_2,-6                      # 82e
        stqd    $pair+1,0($a_out_7)                     # 82o may alias the one before
        a       $a_out_6,$a_out_10,$bit_3               # 83e
        shufb   $pair+6,$object,$pair+6,$m_pair         # 83o
        andi    $bit_14,$bit_13,16                      # 84e
        stqd    $pair+2,0($a_out_4)                     # 84o may alias the one before
        rotmi   $bit,$masks_2,-5                        # 85e
        shufb   $pair7_3,$object,$pair7_2,$m_pair       # 85o
        a       $a_out_7,$a_out_6,$bit_14               # 86e
        stqd    $pair+3,0($a_out_3)                     # 86o may alias the one before
        andi    $bit_2,$bit_8,16                        # 87e
        shufb   $pair+8,$object,$pair8_2,$m_pair        # 87o
        rotmi   $bit_8,$masks_2,-4                      # 88e
        stqd    $pair+4,0($a_out_2)                     # 88o may alias the one before
        a       $a_out_3,$a_out_7,$bit_2                # 89e
        shufb   $pair9_3,$object,$pair9_2,$m_pair       # 89o
        andi    $bit,$bit,16                            # 90e
        stqd    $pair+5,0($a_out_8)                     # 90o may alias the one before
        rotmi   $bit_15,$masks_2,-3                     # 91e
        shufb   $pair+10,$object,$pair10_2,$m_pair      # 91o
        a       $a_out_4,$a_out_3,$bit                  # 92e
        stqd    $pair+6,0($a_out_9)                     # 92o may alias the one before
        andi    $bit_8,$bit_8,16                        # 93e
        shufb   $pair+11,$object,$pair11_2,$m_pair      # 93o
        rotmi   $bit_16,$masks_2,-2                     # 94e
        stqd    $pair7_3,0($a_out_10)                   # 94o may alias the one before
        a       $a_out_11,$a_out_4,$bit_8               # 95e
        shufb   $pair+12,$object,$pair12_2,$m_pair      # 95o
        andi    $bit_17,$bit_15,16                      # 96e
        stqd    $pair+8,0($a_out_6)                     # 96o may alias the one before
        rotmi   $bit_3,$masks_2,-1                      # 97e
        shufb   $pair+13,$object,$pair13_2,$m_pair      # 97o
        a       $a_out_12,$a_out_11,$bit_17             # 98e
        stqd    $pair9_3,0($a_out_7)                    # 98o may alias the one before
        andi    $bit_7,$bit_16,16                       # 99e
        shufb   $pair+14,$object,$pair14_2,$m_pair      # 99o
        rotmi   $bit_18,$masks_2,0                      # 100e
        stqd    $pair+10,0($a_out_3)                    # 100o may alias the one before
        a       $a_out_3,$a_out_12,$bit_7               # 101e
        shufb   $pair+15,$object,$pair15_3,$m_pair      # 101o
        andi    $bit_3,$bit_3,16                        # 102e
        stqd    $pair+11,0($a_out_4)                    # 102o may alias the one before
        rotmi   $bit,$masks_3,-15                       # 103e
        stqd    $pair+12,0($a_out_11)                   # 103o may alias the one before
        a       $a_out_6,$a_out_3,$bit_3                # 104e
        stqd    $pair+13,0($a_out_12)                   # 104o may alias the one before
        andi    $bit_18,$bit_18,16                      # 105e
        stqd    $pair+14,0($a_out_3)                    # 105o may alias the one before
        rotmi   $bit_2,$masks_3,-14                     # 106e
        stqd    $pair+15,0($a_out_6)                    # 106o may alias the one before
        a       $a_out_13,$a_out_6,$bit_18              # 107e
        lqd     $pair,512($a_places)                    # 107o
        andi    $bit,$bit,16                            # 108e
        lqd     $pair+1,528($a_places)                  # 108o
        rotmi   $bit_3,$masks_3,-13                     # 109e
        lqd     $pair+2,544($a_places)                  # 109o
        a       $a_out_2,$a_out_13,$bit                 # 110e
        lqd     $pair+3,560($a_places)                  # 110o
        andi    $bit,$bit_2,16                          # 111e
        lqd     $pair+4,576($a_places)                  # 111o
        rotmi   $bit_2,$masks_3,-12                     # 112e
        lqd     $pair+5,592($a_places)                  # 112o
        a       $a_out_7,$a_out_2,$bit                  # 113e
        shufb   $pair,$object,$pair,$m_pair             # 113o
        andi    $bit,$bit_3,16                          # 114e
        lqd     $pair+6,608($a_places)                  # 114o
        rotmi   $bit_3,$masks_3,-11                     # 115e
        shufb   $pair+1,$object,$pair+1,$m_pair         # 115o
        a       $a_out_4,$a_out_7,$bit                  # 116e
        lqd     $pair+7,624($a_places)                  # 116o
        andi    $bit_2,$bit_2,16                        # 117e
        shufb   $pair+2,$object,$pair+2,$m_pair         # 117o
        rotmi   $bit_19,$masks_3,-10                    # 118e
        lqd     $pair8_3,640($a_places)                 # 118o
        a       $a_out_3,$a_out_4,$bit_2                # 119e
        shufb   $pair+3,$object,$pair+3,$m_pair         # 119o
        andi    $bit_3,$bit_3,16                        # 120e
        lqd     $pair9_4,656($a_places)                 # 120o
        rotmi   $bit_20,$masks_3,-9                     # 121e
        lqd     $pair10_3,672($a_places)                # 121o
        a       $a_out_6,$a_out_3,$bit_3                # 122e
        lqd     $pair11_3,688($a_places)                # 122o
        andi    $bit_19,$bit_19,16                      # 123e
        lqd     $pair12_3,704($a_places)                # 123o
        rotmi   $bit_5,$masks_3,-8                      # 124e
        lqd     $pair13_3,720($a_places)                # 124o
        a       $a_out_14,$a_out_6,$bit_19              # 125e
        lqd     $pair14_3,736($a_places)                # 125o
        andi    $bit_20,$bit_20,16                      # 126e
        lqd     $pair15_4,752($a_places)                # 126o
        rotmi   $bit_21,$masks_3,-7                     # 127e
        shufb   $pair+4,$object,$pair+4,$m_pair         # 127o
        a       $a_out_15,$a_out_14,$bit_20             # 128e
        stqd    $pair,0($a_out_13)                      # 128o may alias the one before
        andi    $bit_18,$bit_5,16                       # 129e
        shufb   $pair+5,$object,$pair+5,$m_pair         # 129o
        rotmi   $bit_8,$masks_3,-6                      # 130e
        stqd    $pair+1,0($a_out_2)                     # 130o may alias the one before
        a       $a_out_13,$a_out_15,$bit_18             # 131e
        shufb   $pair+6,$object,$pair+6,$m_pair         # 131o
        andi    $bit_7,$bit_21,16                       # 132e
        stqd    $pair+2,0($a_out_7)                     # 132o may alias the one before
        rotmi   $bit_14,$masks_3,-5                     # 133e
        shufb   $pair+7,$object,$pair+7,$m_pair         # 133o
        a       $a_out_2,$a_out_13,$bit_7               # 134e
        stqd    $pair+3,0($a_out_4)                     # 134o may alias the one before
        andi    $bit,$bit_8,16                          # 135e
        shufb   $pair8_4,$object,$pair8_3,$m_pair       # 135o
        rotmi   $bit_17,$masks_3,-4                     # 136e
        stqd    $pair+4,0($a_out_3)                     # 136o may alias the one before
        a       $a_out_3,$a_out_2,$bit                  # 137e
        shufb   $pair+9,$object,$pair9_4,$m_pair        # 137o
        andi    $bit,$bit_14,16                         # 138e
        stqd    $pair+5,0($a_out_6)                     # 138o may alias the one before
        rotmi   $bit_3,$masks_3,-3                      # 139e
        shufb   $pair+10,$object,$pair10_3,$m_pair      # 139o
        a       $a_out_7,$a_out_3,$bit                  # 140e
        stqd    $pair+6,0($a_out_14)                    # 140o may alias the one before
        andi    $bit,$bit_17,16                         # 141e
        shufb   $pair11_4,$object,$pair11_3,$m_pair     # 141o
        rotmi   $bit_15,$masks_3,-2                     # 142e
        stqd    $pair+7,0($a_out_15)                    # 142o may alias the one before
        a       $a_out_4,$a_out_7,$bit                  # 143e
        shufb   $pair+12,$object,$pair12_3,$m_pair      # 143o
        andi    $bit_3,$bit_3,16                        # 144e
        stqd    $pair8_4,0($a_out_13)                   # 144o may alias the one before
        rotmi   $bit_18,$masks_3,-1                     # 145e
        shufb   $pair+13,$object,$pair13_3,$m_pair      # 145o
        a       $a_out_6,$a_out_4,$bit_3                # 146e
        stqd    $pair+9,0($a_out_2)                     # 146o may alias the one before
        andi    $bit_7,$bit_15,16                       # 147e
        shufb   $pair+14,$object,$pair14_3,$m_pair      # 147o
        rotmi   $bit_4,$masks_3,0                       # 148e
        stqd    $pair+10,0($a_out_3)                    # 148o may alias the one before
        a       $a_out_3,$a_out_6,$bit_7                # 149e
        shufb   $pair+15,$object,$pair15_4,$m_pair      # 149o
        andi    $bit_18,$bit_18,16                      # 150e
        stqd    $pair11_4,0($a_out_7)                   # 150o may alias the one before
        rotmi   $bit_7,$masks_4,-15                     # 151e
        stqd    $pair+12,0($a_out_4)                    # 151o may alias the one before
        a       $a_out_13,$a_out_3,$bit_18              # 152e
        stqd    $pair+13,0($a_out_6)                    # 152o may alias the one before
        andi    $bit,$bit_4,16                          # 153e
        stqd    $pair+14,0($a_out_3)                    # 153o may alias the one before
        rotmi   $bit_2,$masks_4,-14                     # 154e
        stqd    $pair+15,0($a_out_13)                   # 154o may alias the one before
        a       $a_out_13,$a_out_13,$bit                # 155e
        lqd     $pair,768($a_places)                    # 155o
        andi    $bit,$bit_7,16                          # 156e
        lqd     $pair+1,784($a_places)                  # 156o
        rotmi   $bit_3,$masks_4,-13                     # 157e
        lqd     $pair+2,800($a_places)                  # 157o
        a       $a_out_5,$a_out_13,$bit                 # 158e
        lqd     $pair+3,816($a_places)                  # 158o
        andi    $bit,$bit_2,16                          # 159e
        lqd     $pair+4,832($a_places)                  # 159o
        rotmi   $bit_2,$masks_4,-12                     # 160e
        lqd     $pair+5,848($a_places)                  # 160o
        a       $a_out_2,$a_out_5,$bit                  # 161e
        shufb   $pair,$object,$pair,$m_pair             # 161o
        andi    $bit,$bit_3,16                          # 162e
        lqd     $pair+6,864($a_places)                  # 162o
        rotmi   $bit_3,$masks_4,-11                     # 163e
        shufb   $pair+1,$object,$pair+1,$m_pair         # 163o
        a       $a_out_7,$a_out_2,$bit                  # 164e
        lqd     $pair+7,880($a_places)                  # 164o
        andi    $bit,$bit_2,16                          # 165e
        shufb   $pair+2,$object,$pair+2,$m_pair         # 165o
        rotmi   $bit_2,$masks_4,-10                     # 166e
        lqd     $pair+8,896($a_places)                  # 166o
        a       $a_out_4,$a_out_7,$bit                  # 167e
        shufb   $pair+3,$object,$pair+3,$m_pair         # 167o
        andi    $bit_3,$bit_3,16                        # 168e
        lqd     $pair+9,912($a_places)                  # 168o
        rotmi   $bit_22,$masks_4,-9                     # 169e
        lqd     $pair10_4,928($a_places)                # 169o
        a       $a_out_6,$a_out_4,$bit_3                # 170e
        lqd     $pair11_5,944($a_places)                # 170o
        andi    $bit_2,$bit_2,16                        # 171e
        lqd     $pair12_4,960($a_places)                # 171o
        rotmi   $bit_23,$masks_4,-8                     # 172e
        lqd     $pair13_4,976($a_places)                # 172o
        a       $a_out_3,$a_out_6,$bit_2                # 173e
        lqd     $pair14_4,992($a_places)                # 173o
        andi    $bit_22,$bit_22,16                      # 174e
        lqd     $pair15_5,1008($a_places)               # 174o
        rotmi   $bit_24,$masks_4,-7                     # 175e
        shufb   $pair+4,$object,$pair+4,$m_pair         # 175o
        a       $a_out_16,$a_out_3,$bit_22              # 176e
        stqd    $pair,0($a_out_13)                      # 176o may alias the one before
        andi    $bit_18,$bit_23,16                      # 177e
        hbr     list_pairs_p64_return,$lr               # 177o hint
        rotmi   $bit_8,$masks_4,-6                      # 178e
        shufb   $pair+5,$object,$pair+5,$m_pair         # 178o
        a       $a_out_13,$a_out_16,$bit_18             # 179e
        stqd    $pair+1,0($a_out_5)                     # 179o may alias the one before
        andi    $bit_4,$bit_24,16                       # 180e
        shufb   $pair+6,$object,$pair+6,$m_pair         # 180o
        rotmi   $bit_17,$masks_4,-5                     # 181e
        stqd    $pair+2,0($a_out_2)                     # 181o may alias the one before
        a       $a_out_5,$a_out_13,$bit_4               # 182e
        shufb   $pair+7,$object,$pair+7,$m_pair         # 182o
        andi    $bit_7,$bit_8,16                        # 183e
        stqd    $pair+3,0($a_out_7)                     # 183o may alias the one before
        rotmi   $bit_14,$masks_4,-4                     # 184e
        shufb   $pair+8,$object,$pair+8,$m_pair         # 184o
        a       $a_out_2,$a_out_5,$bit_7                # 185e
        stqd    $pair+4,0($a_out_4)                     # 185o may alias the one before
        andi    $bit,$bit_17,16                         # 186e
        shufb   $pair+9,$object,$pair+9,$m_pair         # 186o
        rotmi   $bit_8,$masks_4,-3                      # 187e
        stqd    $pair+5,0($a_out_6)                     # 187o may alias the one before
        a       $a_out_6,$a_out_2,$bit                  # 188e
        shufb   $pair10_5,$object,$pair10_4,$m_pair     # 188o
        andi    $bit_14,$bit_14,16                      # 189e
        stqd    $pair+6,0($a_out_3)                     # 189o may alias the one before
        rotmi   $bit_2,$masks_4,-2                      # 190e
        shufb   $pair+11,$object,$pair11_5,$m_pair      # 190o
        a       $a_out_7,$a_out_6,$bit_14               # 191e
        stqd    $pair+7,0($a_out_16)                    # 191o may alias the one before
        andi    $bit_8,$bit_8,16                        # 192e
        shufb   $pair+12,$object,$pair12_4,$m_pair      # 192o
        rotmi   $bit_17,$masks_4,-1                     # 193e
        stqd    $pair+8,0($a_out_13)                    # 193o may alias the one before
        a       $a_out_13,$a_out_7,$bit_8               # 194e
        shufb   $pair+13,$object,$pair13_4,$m_pair      # 194o
        andi    $bit_2,$bit_2,16                        # 195e
        stqd    $pair+9,0($a_out_5)                     # 195o may alias the one before
        rotmi   $bit_6,$masks_4,0                       # 196e
        shufb   $pair+14,$object,$pair14_4,$m_pair      # 196o
        a       $a_out_3,$a_out_13,$bit_2               # 197e
        stqd    $pair10_5,0($a_out_2)                   # 197o may alias the one before
        andi    $bit,$bit_17,16                         # 198e
        shufb   $pair+15,$object,$pair15_5,$m_pair      # 198o
        nop     $127                                    # 199e pairing
        stqd    $pair+11,0($a_out_6)                    # 199o may alias the one before
        a       $a_out_17,$a_out_3,$bit                 # 200e
        stqd    $pair+12,0($a_out_7)                    # 200o may alias the one before
        andi    $bit,$bit_6,16                          # 201e
        stqd    $pair+13,0($a_out_13)                   # 201o may alias the one before
        nop     $127                                    # 202e pairing
        stqd    $pair+14,0($a_out_3)                    # 202o may alias the one before
        a       $a_out,$a_out_17,$bit                   # 203e
        stqd    $pair+15,0($a_out_17)                   # 203o may alias the one before
        ori     $a_masks,$a_out,0                       # 205e
list_pairs_p64_return:
        bi      $lr                                     # 205o
endfunction list_pairs_p64
