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
        shli    $mask,$mask,4
        lqd     $origin,0($a_origin)
    .set    packet,0
    .rept   16
        lqd     $place,PLACE_SIZE*packet($a_places)
        a       $place,$place,$origin
        stqd    $place,0($a_out)                        # may alias the one before
        keep_if_named $a_out,$mask,packet,$bit
    .set    packet,packet+1
    .endr
        ori     $3,$a_out,0
        bi      $lr
endfunction list_places_p16
