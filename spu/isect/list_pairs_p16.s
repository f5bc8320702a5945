# list_pairs_p16   pairs of one object with those packets of a group that a mask names
#   C       struct pair *list_pairs_p16(unsigned mask, const struct place *, const void *object,
#                                       struct pair *);
#   In      $3 mask, 16 bits, the highest of packet 0; $4 the sixteen places of a group; $5 address
#           of the object's record; $6 where the pairs go; pointers 16-aligned
#   Out     the pairs; one more quadword may be written
#           $3 behind the pairs
#   Uses    $3, $6, $10-$13   Saves  -   Stack  0   Calls  -
#   Domain  any
#   Error   0
#   Twin    oracle/src/twin/lists.rs
# Scheduled by spu schedule from list_pairs_p16.s

        .include "work_unit.inc"
        .include "macros.inc"
        .include "lists.inc"

        .set    mask,3
        .set    a_places,4
        .set    object,5
        .set    a_out,6
        # constants
        .set    m_pair,10
        # temporaries
        .set    pair,11
        .set    bit,12

        .section .rodata
        .align  4
        # A pair: the object's word, then the packet's out of a place.
pair_of_object_and_place:
        .int    0x00010203,0x10111213,0x14151617,0x18191a1b

function list_pairs_p16
        .set    bit_2,2
        .set    bit_3,7
        .set    bit_4,8
        .set    a_out_2,9
        .set    a_out_3,7
        .set    a_out_4,2
        .set    bit_5,13
        .set    bit_6,14
        .set    a_out_5,12
        .set    bit_7,9
        .set    a_out_6,8
        .set    a_out_7,13
        .set    bit_8,15
        .set    bit_9,16
        .set    bit_10,17
        .set    a_out_8,14
        .set    bit_11,6
        .set    a_out_9,15
        .set    a_out_10,16
        .set    bit_12,18
        .set    bit_13,19
        .set    bit_14,3
        .set    a_out_11,17
        .set    a_out_12,18
        .set    a_out_13,3
        shli    $mask,$mask,4                           # 0e
        lqa     $m_pair,pair_of_object_and_place        # 0o

        lqd     $pair,0($a_places)                      # 1o
        hbr     list_pairs_p16_return,$lr               # 2o hint

        rotmi   $bit,$mask,-15                          # 4e
        rotmi   $bit_2,$mask,-14                        # 5e

        rotmi   $bit_3,$mask,-13                        # 6e
        lnop                                            # 6o pairing

        rotmi   $bit_4,$mask,-12                        # 7e
        shufb   $pair,$object,$pair,$m_pair             # 7o

        andi    $bit,$bit,16                            # 8e
        andi    $bit_2,$bit_2,16                        # 9e

        a       $a_out_2,$a_out,$bit                    # 10e
        lnop                                            # 10o pairing

        andi    $bit,$bit_3,16                          # 11e
        stqd    $pair,0($a_out)                         # 11o may alias the one before

        a       $a_out,$a_out_2,$bit_2                  # 12e
        lqd     $pair,16($a_places)                     # 12o

        andi    $bit_2,$bit_4,16                        # 13e
        a       $a_out_3,$a_out,$bit                    # 14e

        rotmi   $bit,$mask,-11                          # 15e
        a       $a_out_4,$a_out_3,$bit_2                # 16e

        rotmi   $bit_4,$mask,-10                        # 17e
        lnop                                            # 17o pairing

        rotmi   $bit_5,$mask,-9                         # 18e
        shufb   $pair,$object,$pair,$m_pair             # 18o

        andi    $bit,$bit,16                            # 19e
        rotmi   $bit_6,$mask,-8                         # 20e

        a       $a_out_5,$a_out_4,$bit                  # 21e
        lnop                                            # 21o pairing

        andi    $bit_4,$bit_4,16                        # 22e
        stqd    $pair,0($a_out_2)                       # 22o may alias the one before

        andi    $bit_7,$bit_5,16                        # 23e
        lqd     $pair,32($a_places)                     # 23o

        a       $a_out_6,$a_out_5,$bit_4                # 24e
        andi    $bit_5,$bit_6,16                        # 25e

        a       $a_out_2,$a_out_6,$bit_7                # 26e
        rotmi   $bit_6,$mask,-7                         # 27e

        a       $a_out_7,$a_out_2,$bit_5                # 28e
        lnop                                            # 28o pairing

        rotmi   $bit_8,$mask,-6                         # 29e
        shufb   $pair,$object,$pair,$m_pair             # 29o

        rotmi   $bit_9,$mask,-5                         # 30e
        andi    $bit_6,$bit_6,16                        # 31e

        rotmi   $bit_10,$mask,-4                        # 32e
        lnop                                            # 32o pairing

        a       $a_out_8,$a_out_7,$bit_6                # 33e
        stqd    $pair,0($a_out)                         # 33o may alias the one before

        andi    $bit_11,$bit_8,16                       # 34e
        lqd     $pair,48($a_places)                     # 34o

        andi    $bit_8,$bit_9,16                        # 35e
        a       $a_out,$a_out_8,$bit_11                 # 36e

        andi    $bit_9,$bit_10,16                       # 37e
        a       $a_out_9,$a_out,$bit_8                  # 38e

        rotmi   $bit_10,$mask,-3                        # 39e
        lnop                                            # 39o pairing

        a       $a_out_10,$a_out_9,$bit_9               # 40e
        shufb   $pair,$object,$pair,$m_pair             # 40o

        rotmi   $bit_12,$mask,-2                        # 41e
        rotmi   $bit_13,$mask,-1                        # 42e

        andi    $bit_10,$bit_10,16                      # 43e
        lnop                                            # 43o pairing

        rotmi   $bit_14,$mask,0                         # 44e
        stqd    $pair,0($a_out_3)                       # 44o may alias the one before

        a       $a_out_3,$a_out_10,$bit_10              # 45e
        lqd     $pair,64($a_places)                     # 45o

        andi    $bit_10,$bit_12,16                      # 46e
        andi    $bit_12,$bit_13,16                      # 47e

        a       $a_out_11,$a_out_3,$bit_10              # 48e
        andi    $bit_14,$bit_14,16                      # 49e

        a       $a_out_12,$a_out_11,$bit_12             # 50e
        shufb   $pair,$object,$pair,$m_pair             # 51o

        a       $a_out_13,$a_out_12,$bit_14             # 52e
        ori     $mask,$a_out_13,0                       # 54e

        stqd    $pair,0($a_out_4)                       # 55o may alias the one before
        lqd     $pair,80($a_places)                     # 56o

        shufb   $pair,$object,$pair,$m_pair             # 62o
        stqd    $pair,0($a_out_5)                       # 66o may alias the one before

        lqd     $pair,96($a_places)                     # 67o
        shufb   $pair,$object,$pair,$m_pair             # 73o

        stqd    $pair,0($a_out_6)                       # 77o may alias the one before
        lqd     $pair,112($a_places)                    # 78o

        shufb   $pair,$object,$pair,$m_pair             # 84o
        stqd    $pair,0($a_out_2)                       # 88o may alias the one before

        lqd     $pair,128($a_places)                    # 89o
        shufb   $pair,$object,$pair,$m_pair             # 95o

        stqd    $pair,0($a_out_7)                       # 99o may alias the one before
        lqd     $pair,144($a_places)                    # 100o

        shufb   $pair,$object,$pair,$m_pair             # 106o
        stqd    $pair,0($a_out_8)                       # 110o may alias the one before

        lqd     $pair,160($a_places)                    # 111o
        shufb   $pair,$object,$pair,$m_pair             # 117o

        stqd    $pair,0($a_out)                         # 121o may alias the one before
        lqd     $pair,176($a_places)                    # 122o

        shufb   $pair,$object,$pair,$m_pair             # 128o
        stqd    $pair,0($a_out_9)                       # 132o may alias the one before

        lqd     $pair,192($a_places)                    # 133o
        shufb   $pair,$object,$pair,$m_pair             # 139o

        stqd    $pair,0($a_out_10)                      # 143o may alias the one before
        lqd     $pair,208($a_places)                    # 144o

        shufb   $pair,$object,$pair,$m_pair             # 150o
        stqd    $pair,0($a_out_3)                       # 154o may alias the one before

        lqd     $pair,224($a_places)                    # 155o
        shufb   $pair,$object,$pair,$m_pair             # 161o

        stqd    $pair,0($a_out_11)                      # 165o may alias the one before
        lqd     $pair,240($a_places)                    # 166o

        shufb   $pair,$object,$pair,$m_pair             # 172o
        stqd    $pair,0($a_out_12)                      # 176o may alias the one before

        nop     $127                                    # 177e pairing
list_pairs_p16_return:
        bi      $lr                                     # 177o
endfunction list_pairs_p16
