# list_places_p16   the places of those packets of a group that a mask names
#   C       struct place *list_places_p16(unsigned mask, const struct place *,
#                                         const struct place *origin, struct place *);
#   In      $3 mask, 16 bits, the highest of packet 0; $4 the sixteen places of a group at 0, 0;
#           $5 what to add to each of them; $6 where the list goes; pointers 16-aligned
#   Out     the list; one more quadword may be written
#           $3 behind the list
#   Uses    $3, $6, $10-$13   Saves  -   Stack  0   Calls  -
#   Domain  any
#   Error   0
#   Twin    oracle/src/twin/lists.rs
# Scheduled by spu schedule from list_places_p16.s

        .include "work_unit.inc"
        .include "macros.inc"
        .include "lists.inc"

        .set    mask,3
        .set    a_places,4
        .set    a_origin,5
        .set    a_out,6
        # temporaries
        .set    place,10
        .set    bit,11
        .set    origin,12

function list_places_p16
        .set    bit_2,2
        .set    bit_3,5
        .set    a_out_2,2
        .set    a_out_3,7
        .set    bit_4,8
        .set    a_out_4,9
        .set    a_out_5,11
        .set    a_out_6,5
        .set    bit_5,13
        .set    bit_6,14
        .set    a_out_7,13
        .set    a_out_8,8
        .set    bit_7,15
        .set    bit_8,16
        .set    a_out_9,14
        .set    bit_9,3
        .set    a_out_10,16
        .set    a_out_11,3
        shli    $mask,$mask,4                           # 0e
        lqd     $origin,0($a_origin)                    # 0o

        lqd     $place,0($a_places)                     # 1o
        hbr     list_places_p16_return,$lr              # 2o hint

        rotmi   $bit,$mask,-15                          # 4e
        rotmi   $bit_2,$mask,-14                        # 5e

        rotmi   $bit_3,$mask,-13                        # 6e
        a       $place,$place,$origin                   # 7e

        andi    $bit,$bit,16                            # 8e
        lnop                                            # 8o pairing

        andi    $bit_2,$bit_2,16                        # 9e
        stqd    $place,0($a_out)                        # 9o may alias the one before

        a       $a_out,$a_out,$bit                      # 10e
        lqd     $place,16($a_places)                    # 10o

        andi    $bit,$bit_3,16                          # 11e
        a       $a_out_2,$a_out,$bit_2                  # 12e

        rotmi   $bit_3,$mask,-12                        # 13e
        a       $a_out_3,$a_out_2,$bit                  # 14e

        rotmi   $bit,$mask,-11                          # 15e
        a       $place,$place,$origin                   # 16e

        andi    $bit_3,$bit_3,16                        # 17e
        lnop                                            # 17o pairing

        rotmi   $bit_4,$mask,-10                        # 18e
        stqd    $place,0($a_out)                        # 18o may alias the one before

        a       $a_out,$a_out_3,$bit_3                  # 19e
        lqd     $place,32($a_places)                    # 19o

        andi    $bit,$bit,16                            # 20e
        rotmi   $bit_3,$mask,-9                         # 21e

        a       $a_out_4,$a_out,$bit                    # 22e
        andi    $bit,$bit_4,16                          # 23e

        rotmi   $bit_4,$mask,-8                         # 24e
        a       $place,$place,$origin                   # 25e

        a       $a_out_5,$a_out_4,$bit                  # 26e
        lnop                                            # 26o pairing

        andi    $bit_3,$bit_3,16                        # 27e
        stqd    $place,0($a_out_2)                      # 27o may alias the one before

        andi    $bit_2,$bit_4,16                        # 28e
        lqd     $place,48($a_places)                    # 28o

        a       $a_out_6,$a_out_5,$bit_3                # 29e
        rotmi   $bit_4,$mask,-7                         # 30e

        a       $a_out_2,$a_out_6,$bit_2                # 31e
        rotmi   $bit_5,$mask,-6                         # 32e

        rotmi   $bit_6,$mask,-5                         # 33e
        a       $place,$place,$origin                   # 34e

        andi    $bit_4,$bit_4,16                        # 35e
        lnop                                            # 35o pairing

        andi    $bit_5,$bit_5,16                        # 36e
        stqd    $place,0($a_out_3)                      # 36o may alias the one before

        a       $a_out_3,$a_out_2,$bit_4                # 37e
        lqd     $place,64($a_places)                    # 37o

        andi    $bit_4,$bit_6,16                        # 38e
        a       $a_out_7,$a_out_3,$bit_5                # 39e

        rotmi   $bit_6,$mask,-4                         # 40e
        a       $a_out_8,$a_out_7,$bit_4                # 41e

        rotmi   $bit_7,$mask,-3                         # 42e
        a       $place,$place,$origin                   # 43e

        andi    $bit_6,$bit_6,16                        # 44e
        lnop                                            # 44o pairing

        rotmi   $bit_8,$mask,-2                         # 45e
        stqd    $place,0($a_out)                        # 45o may alias the one before

        a       $a_out,$a_out_8,$bit_6                  # 46e
        lqd     $place,80($a_places)                    # 46o

        andi    $bit_6,$bit_7,16                        # 47e
        rotmi   $bit_7,$mask,-1                         # 48e

        a       $a_out_9,$a_out,$bit_6                  # 49e
        andi    $bit_8,$bit_8,16                        # 50e

        rotmi   $bit_9,$mask,0                          # 51e
        a       $place,$place,$origin                   # 52e

        a       $a_out_10,$a_out_9,$bit_8               # 53e
        lnop                                            # 53o pairing

        andi    $bit_7,$bit_7,16                        # 54e
        stqd    $place,0($a_out_4)                      # 54o may alias the one before

        andi    $bit_9,$bit_9,16                        # 55e
        lqd     $place,96($a_places)                    # 55o

        a       $a_out_4,$a_out_10,$bit_7               # 56e
        a       $a_out_11,$a_out_4,$bit_9               # 58e

        ori     $mask,$a_out_11,0                       # 60e
        a       $place,$place,$origin                   # 61e

        stqd    $place,0($a_out_5)                      # 63o may alias the one before
        lqd     $place,112($a_places)                   # 64o

        a       $place,$place,$origin                   # 70e
        stqd    $place,0($a_out_6)                      # 72o may alias the one before

        lqd     $place,128($a_places)                   # 73o
        a       $place,$place,$origin                   # 79e

        stqd    $place,0($a_out_2)                      # 81o may alias the one before
        lqd     $place,144($a_places)                   # 82o

        a       $place,$place,$origin                   # 88e
        stqd    $place,0($a_out_3)                      # 90o may alias the one before

        lqd     $place,160($a_places)                   # 91o
        a       $place,$place,$origin                   # 97e

        stqd    $place,0($a_out_7)                      # 99o may alias the one before
        lqd     $place,176($a_places)                   # 100o

        a       $place,$place,$origin                   # 106e
        stqd    $place,0($a_out_8)                      # 108o may alias the one before

        lqd     $place,192($a_places)                   # 109o
        a       $place,$place,$origin                   # 115e

        stqd    $place,0($a_out)                        # 117o may alias the one before
        lqd     $place,208($a_places)                   # 118o

        a       $place,$place,$origin                   # 124e
        stqd    $place,0($a_out_9)                      # 126o may alias the one before

        lqd     $place,224($a_places)                   # 127o
        a       $place,$place,$origin                   # 133e

        stqd    $place,0($a_out_10)                     # 135o may alias the one before
        lqd     $place,240($a_places)                   # 136o

        a       $place,$place,$origin                   # 142e
        stqd    $place,0($a_out_4)                      # 144o may alias the one before

        nop     $127                                    # 145e pairing
list_places_p16_return:
        bi      $lr                                     # 145o
endfunction list_places_p16
