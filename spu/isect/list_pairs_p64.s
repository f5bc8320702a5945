# list_pairs_p64   pairs of one object with those packets of a tile that masks name
#   C       struct pair *list_pairs_p64(const unsigned masks[4], const struct place *,
#                                       const void *object, struct pair *);
#   In      $3 masks, one for each sixteen packets: 16 bits, the highest of the first; $4 the
#           places of 64 packets; $5 address of the object's record; $6 where the pairs go;
#           pointers 16-aligned
#   Out     the pairs; one more quadword may be written
#           $3 end of the pairs
#   Uses    $3, $6, $10-$28   Saves  -   Stack  0   Calls  -
#   Domain  any
#   Error   0
#   Twin    lab/twins/src/lists.rs

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

        quadword_constants
        # A pair: the object's word, then the packet's out of a place.
pair_of_object_and_place:
        .int    0x00010203,0x10111213,0x14151617,0x18191a1b

function list_pairs_p64
        lqd     $masks,0($a_masks)
        lqa     $m_pair,pair_of_object_and_place
        shli    $masks,$masks,4
    .set    entry,0
    .rept   4
    .set    packet,0
    .rept   16
        lqd     $pair+packet,PLACE_SIZE*entry($a_places)
        shufb   $pair+packet,$object,$pair+packet,$m_pair
    .set    packet,packet+1
    .set    entry,entry+1
    .endr
    .set    packet,0
    .rept   16
        stqd    $pair+packet,0($a_out)                  # may alias the one before
        keep_if_named $a_out,$masks,packet,$bit
    .set    packet,packet+1
    .endr
        rotqbyi $masks,$masks,4
    .endr
        ori     $3,$a_out,0
        bi      $lr
endfunction list_pairs_p64
