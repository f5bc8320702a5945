# hidden_pairs_r16   drops the pairs in which all rays have hit something nearer than the sphere
#   C       struct pair *hidden_pairs_r16(struct pair *, int count);
#   In      $3 pairs of packets and spheres, $4 count (0 is none); pointers 16-aligned
#   Out     the other pairs, in order, from the same place on
#           $3 their end
#   Uses    $3-$4, $10-$23   Saves  -   Stack  0   Calls  -
#   Domain  any
#   Error   0
#   Twin    lab/twins/src/cull.rs

        .include "work_unit.inc"
        .include "macros.inc"

        .set    NEXT,3
        registers a_pair,count
        # constants
        .set    NEXT,10
        registers m_near
        # state
        registers a_out
        # the pair
        registers pair,a_packet,near
        registers t                                     # to 18
        .set    farther,19                              # to 22
        .set    step,23

function hidden_pairs_r16
        biz     $count,$lr
        load_constant $m_near,(SPHERE_near-16)*0x01010101+0x00010203
        ori     $a_out,$a_pair,0
next_pair:
        lqd     $pair,0($a_pair)
        rotqbyi $a_packet,$pair,PAIR_packet
        lqd     $near,16($pair)
        shufb   $near,$near,$near,$m_near
    .irp row, 0,1,2,3
        lqd     $t+\row,PACKET_t+16*\row($a_packet)
        fcgt    $farther+\row,$t+\row,$near
    .endr
        or      $farther,$farther,$farther+1
        or      $farther+2,$farther+2,$farther+3
        or      $farther,$farther,$farther+2
        gb      $step,$farther
        stqd    $pair,0($a_out)                         # never ahead of the reading
        clgti   $step,$step,0
        andi    $step,$step,PAIR_SIZE
        a       $a_out,$a_out,$step
        ai      $a_pair,$a_pair,PAIR_SIZE
        ai      $count,$count,-1
        brnz    $count,next_pair
        ori     $3,$a_out,0
        bi      $lr
endfunction hidden_pairs_r16
