# mesh_candidates   of visits of a mesh's leaf, the candidates of packets
#   C       struct mesh_candidate *mesh_candidates(const struct mesh_visit *, int count,
#                       struct mesh_candidate *, int base, const struct mesh_candidate packets[2]);
#   In      $3 visits, $4 count (0 is none), $5 where the list goes, $6 what is added to each
#           child's word, $7 two quadwords: a candidate of the first packet, and what is added for
#           each further one; pointers 16-aligned
#   Out     for each visit, a candidate of each packet that has one of its rays: object is the
#           child's word plus $6, near is the visit's; seven more quadwords may be written
#           $3 end of the list
#   Uses    $3-$7, $10-$42   Saves  -   Stack  0   Calls  -
#   Domain  any
#   Error   0
#   Twin    lab/twins/src/mesh_rays.rs

        .include "work_unit.inc"
        .include "macros.inc"

        .set    NEXT,3
        registers a_visit,count,a_list,base,a_packets
        .set    NEXT,10
        registers m_entry,k_step,packet                 # packet to 19
        .set    NEXT,packet+8
        registers found,child,bits,step                 # step to 30
        .set    NEXT,step+8
        registers entry,difference

        .section .rodata.mesh,"a",@progbits
        .align  4
packet_between:                                         # child and near, and between them the packet
        .int    0x00010203,0x14151617,0x18191a1b,0x08090a0b

function mesh_candidates
        fsmbi   $found,0xf000
        and     $base,$base,$found
        lqd     $packet,0($a_packets)
        lqd     $difference,16($a_packets)
        lqa     $m_entry,packet_between
        ilh     $k_step,MESH_CANDIDATE_SIZE
    .irp number, 1,2,3,4,5,6,7
        a       $packet+\number,$packet+\number-1,$difference
    .endr
        il      $found,0
        brz     $count,listed
next_visit:
        lqd     $child,MESH_VISIT_child($a_visit)
        lqd     $bits,MESH_VISIT_rays($a_visit)
        a       $child,$child,$base
        ceqhi   $bits,$bits,0
        andc    $step,$k_step,$bits
        # Only the last 18 bits of a sum make a difference to an address.
    .irp number, 1,2,3,4,5,6,7
        rotqbyi $step+\number,$step,(2*\number-2)&15
    .endr
        rotqbyi $step,$step,14
    .irp number, 0,1,2,3,4,5,6,7
        shufb   $entry,$child,$packet+\number,$m_entry
        stqx    $entry,$a_list,$found
        a       $found,$found,$step+\number
    .endr
        ai      $a_visit,$a_visit,MESH_VISIT_SIZE
        ai      $count,$count,-1
        brnz    $count,next_visit
listed: ilhu    $bits,3
        iohl    $bits,0xffff
        and     $found,$found,$bits
        a       $3,$a_list,$found
        bi      $lr
endfunction mesh_candidates
