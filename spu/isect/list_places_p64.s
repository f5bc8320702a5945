# list_places_p64   the places of those packets of a tile that masks name
#   C       struct place *list_places_p64(const unsigned masks[4], const struct place *,
#                                         const struct place *origin, struct place *);
#   In      $3 masks, one for each sixteen packets: 16 bits, the highest of the first; $4 the
#           places of 64 packets at 0, 0; $5 what to add to each; $6 where the list goes; pointers
#           16-aligned
#   Out     the list; one more quadword may be written
#           $3 end of the list
#   Uses    $3, $6, $10-$28   Saves  -   Stack  0   Calls  -
#   Domain  any
#   Error   0
#   Twin    lab/twins/src/lists.rs

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
        lqd     $masks,0($a_masks)
        lqd     $origin,0($a_origin)
        shli    $masks,$masks,4
    .set    entry,0
    .rept   4
    .set    packet,0
    .rept   16
        lqd     $place+packet,PLACE_SIZE*entry($a_places)
        a       $place+packet,$place+packet,$origin
    .set    packet,packet+1
    .set    entry,entry+1
    .endr
    .set    packet,0
    .rept   16
        stqd    $place+packet,0($a_out)                 # may alias the one before
        keep_if_named $a_out,$masks,packet,$bit
    .set    packet,packet+1
    .endr
        rotqbyi $masks,$masks,4
    .endr
        ori     $3,$a_out,0
        bi      $lr
endfunction list_places_p64
