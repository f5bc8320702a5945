# mesh_candidates   of visits of a mesh's leaf, the candidates of packets
#   C       struct mesh_candidate *mesh_candidates(const struct mesh_visit *, int count,
#                       struct mesh_candidate *, int base, const struct mesh_candidate packets[2]);
#   In      $3 visits, $4 count (0 is none), $5 where the list goes, $6 what is added to each
#           child's word, $7 two quadwords: a candidate of the first packet, and what is added for
#           each further one; pointers 16-aligned
#   Out     for each visit, a candidate of each packet that has one of its rays: object is the
#           child's word plus $6, near is the visit's; seven more quadwords may be written
#           $3 behind the list
#   Uses    $2-$4, $6-$32, $79   Saves  -   Stack  0   Calls  -
#   Domain  any
#   Error   0
#   Twin    lab/twins/src/mesh_rays.rs
# Scheduled by spu schedule from mesh_candidates.s

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
        .set found_2,2; .set count_2,79; .set child_2,2; .set step_2,7; .set found_3,7
        .set entry_2,8; .set found_4,9; .set entry_3,21; .set found_5,24; .set found_6,26
        .set step6_2,22; .set found_7,27; .set entry_4,25; .set entry_5,29; .set found_8,8
        .set entry_6,7; .set entry_7,9; .set found_9,28; .set step_3,2; .set found_10,22
        .set entry_8,24; .set found_11,25; .set entry_9,2
        ilh     $k_step,16                              # 0e
        lqd     $packet,0($a_packets)                   # 0o
        il      $found,0                                # 1e
        lqd     $difference,16($a_packets)              # 1o
        fsmbi   $found_2,0xf000                         # 2o
        lqa     $m_entry,packet_between                 # 3o
        and     $base,$base,$found_2                    # 6e
        a       $packet+1,$packet,$difference           # 7e
        a       $packet+2,$packet+1,$difference         # 9e
        a       $packet+3,$packet+2,$difference         # 11e
        a       $packet+4,$packet+3,$difference         # 13e
        a       $packet+5,$packet+4,$difference         # 15e
        a       $packet+6,$packet+5,$difference         # 17e
        lnop                                            # 17o pairing
        a       $packet+7,$packet+6,$difference         # 19e
        brz     $count,listed                           # 19o
        clgti   $count_2,$count,1                       # 20e at least as many passes as overlap
        brz     $count_2,next_visit_short               # 22o too few passes
        ai      $count,$count,-1                        # 23e
        lqd     $bits,16($a_visit)                      # 23o
        nop     $127                                    # 24e pairing
        lqd     $child,0($a_visit)                      # 24o
        ai      $a_visit,$a_visit,32                    # 25e
        hbrr    next_visit_back,next_visit              # 25o hint
        ceqhi   $bits,$bits,0                           # 29e
        a       $child_2,$child,$base                   # 30e
        andc    $step,$k_step,$bits                     # 31e
        shufb   $entry,$child_2,$packet,$m_entry        # 32o
        rotqbyi $step_2,$step,14                        # 33o
        rotqbyi $step+1,$step,0                         # 34o
        rotqbyi $step+2,$step,2                         # 35o
        rotqbyi $step+3,$step,4                         # 36o
        a       $found_3,$found,$step_2                 # 37e
        shufb   $entry_2,$child_2,$packet+1,$m_entry    # 37o
        nop     $127                                    # 38e pairing
        rotqbyi $step+4,$step,6                         # 38o
        a       $found_4,$found_3,$step+1               # 39e
        shufb   $entry_3,$child_2,$packet+2,$m_entry    # 39o
        nop     $127                                    # 40e pairing
        rotqbyi $step+5,$step,8                         # 40o
        a       $found_5,$found_4,$step+2               # 41e
        stqx    $entry,$a_list,$found                   # 41o
        nop     $127                                    # 42e pairing
        stqx    $entry_2,$a_list,$found_3               # 42o
        a       $found_6,$found_5,$step+3               # 43e
        rotqbyi $step6_2,$step,10                       # 43o
        nop     $127                                    # 44e pairing
        stqx    $entry_3,$a_list,$found_4               # 44o
        a       $found_7,$found_6,$step+4               # 45e
        shufb   $entry_4,$child_2,$packet+3,$m_entry    # 45o
        nop     $127                                    # 46e pairing
        shufb   $entry_5,$child_2,$packet+4,$m_entry    # 46o
        a       $found_8,$found_7,$step+5               # 47e
        shufb   $entry_6,$child_2,$packet+5,$m_entry    # 47o
        shufb   $entry_7,$child_2,$packet+6,$m_entry    # 48o
        a       $found_9,$found_8,$step6_2              # 49e
next_visit:
        ai      $count,$count,-1                        # 0e
        lqd     $bits,16($a_visit)                      # 0o
        nop     $127                                    # 1e pairing
        lqd     $child,0($a_visit)                      # 1o
        ai      $a_visit,$a_visit,32                    # 2e
            rotqbyi $step+7,$step,12                    # 2o
            stqx    $entry_4,$a_list,$found_5           # 3o
            shufb   $entry,$child_2,$packet+7,$m_entry  # 4o
            nop     $127                                # 5e pairing
            stqx    $entry_5,$a_list,$found_6           # 5o
        ceqhi   $bits,$bits,0                           # 6e
            stqx    $entry_6,$a_list,$found_7           # 6o
        a       $child_2,$child,$base                   # 7e
            stqx    $entry_7,$a_list,$found_8           # 7o
        andc    $step,$k_step,$bits                     # 8e
            stqx    $entry,$a_list,$found_9             # 8o
            a       $found,$found_9,$step+7             # 9e
        shufb   $entry,$child_2,$packet,$m_entry        # 9o
        rotqbyi $step_2,$step,14                        # 10o
        rotqbyi $step+1,$step,0                         # 11o
        rotqbyi $step+2,$step,2                         # 12o
        rotqbyi $step+3,$step,4                         # 13o
        a       $found_3,$found,$step_2                 # 14e
        rotqbyi $step+4,$step,6                         # 14o
        nop     $127                                    # 15e pairing
        shufb   $entry_2,$child_2,$packet+1,$m_entry    # 15o
        a       $found_4,$found_3,$step+1               # 16e
        shufb   $entry_3,$child_2,$packet+2,$m_entry    # 16o
        nop     $127                                    # 17e pairing
        rotqbyi $step+5,$step,8                         # 17o
        a       $found_5,$found_4,$step+2               # 18e
        shufb   $entry_4,$child_2,$packet+3,$m_entry    # 18o
        nop     $127                                    # 19e pairing
        stqx    $entry,$a_list,$found                   # 19o
        a       $found_6,$found_5,$step+3               # 20e
        shufb   $entry_5,$child_2,$packet+4,$m_entry    # 20o
        nop     $127                                    # 21e pairing
        rotqbyi $step6_2,$step,10                       # 21o
        a       $found_7,$found_6,$step+4               # 22e
        stqx    $entry_2,$a_list,$found_3               # 22o
        nop     $127                                    # 23e pairing
        shufb   $entry_6,$child_2,$packet+5,$m_entry    # 23o
        a       $found_8,$found_7,$step+5               # 24e
        stqx    $entry_3,$a_list,$found_4               # 24o
        nop     $127                                    # 25e pairing
        shufb   $entry_7,$child_2,$packet+6,$m_entry    # 25o
        a       $found_9,$found_8,$step6_2              # 26e
next_visit_back:
        brnz    $count,next_visit                       # 26o
next_visit_drain:
        rotqbyi $step+7,$step,12                        # 0o
        stqx    $entry_4,$a_list,$found_5               # 1o
        shufb   $entry,$child_2,$packet+7,$m_entry      # 2o
        stqx    $entry_5,$a_list,$found_6               # 3o
        a       $found,$found_9,$step+7                 # 4e
        stqx    $entry_6,$a_list,$found_7               # 4o
        stqx    $entry_7,$a_list,$found_8               # 5o
        stqx    $entry,$a_list,$found_9                 # 6o
listed:
        ilhu    $bits,3                                 # 0e
        iohl    $bits,0xffff                            # 2e
        and     $found,$found,$bits                     # 4e
        lnop                                            # 4o pairing
        a       $a_visit,$a_list,$found                 # 6e
        bi      $lr                                     # 6o
next_visit_short:
        ai      $count,$count,-1                        # 0e
        lqd     $bits,16($a_visit)                      # 0o
        lqd     $child,0($a_visit)                      # 1o
        ai      $a_visit,$a_visit,32                    # 2e
        ceqhi   $bits,$bits,0                           # 6e
        a       $child,$child,$base                     # 7e
        andc    $step,$k_step,$bits                     # 8e
        shufb   $entry,$child,$packet,$m_entry          # 9o
        rotqbyi $step_3,$step,14                        # 10o
        rotqbyi $step+1,$step,0                         # 11o
        rotqbyi $step+2,$step,2                         # 12o
        rotqbyi $step+3,$step,4                         # 13o
        a       $found_2,$found,$step_3                 # 14e
        rotqbyi $step+4,$step,6                         # 14o
        nop     $127                                    # 15e pairing
        shufb   $entry_6,$child,$packet+1,$m_entry      # 15o
        a       $found_8,$found_2,$step+1               # 16e
        shufb   $entry_7,$child,$packet+2,$m_entry      # 16o
        nop     $127                                    # 17e pairing
        rotqbyi $step+5,$step,8                         # 17o
        a       $found_10,$found_8,$step+2              # 18e
        shufb   $entry_8,$child,$packet+3,$m_entry      # 18o
        nop     $127                                    # 19e pairing
        stqx    $entry,$a_list,$found                   # 19o
        a       $found,$found_10,$step+3                # 20e
        shufb   $entry,$child,$packet+4,$m_entry        # 20o
        nop     $127                                    # 21e pairing
        rotqbyi $step+6,$step,10                        # 21o
        a       $found_11,$found,$step+4                # 22e
        stqx    $entry_6,$a_list,$found_2               # 22o
        nop     $127                                    # 23e pairing
        shufb   $entry_9,$child,$packet+5,$m_entry      # 23o
        a       $found_3,$found_11,$step+5              # 24e
        stqx    $entry_7,$a_list,$found_8               # 24o
        nop     $127                                    # 25e pairing
        shufb   $entry_2,$child,$packet+6,$m_entry      # 25o
        a       $found_4,$found_3,$step+6               # 26e
        stqx    $entry_8,$a_list,$found_10              # 26o
        shufb   $entry_3,$child,$packet+7,$m_entry      # 27o
        stqx    $entry,$a_list,$found                   # 28o
        rotqbyi $step+7,$step,12                        # 29o
        stqx    $entry_9,$a_list,$found_11              # 30o
        stqx    $entry_2,$a_list,$found_3               # 31o
        stqx    $entry_3,$a_list,$found_4               # 32o
        a       $found,$found_4,$step+7                 # 33e
        brnz    $count,next_visit_short                 # 33o
        nop     $127                                    # 34e pairing
        br      listed                                  # 34o
endfunction mesh_candidates
