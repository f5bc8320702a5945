# hidden_pairs_r16   drops the pairs in which all rays have hit something nearer
#   C       struct pair *hidden_pairs_r16(struct pair *, int count, float near);
#   In      $3 pairs of one object, $4 count (0 is none), $5 near: no ray meets the object nearer;
#           pointers 16-aligned
#   Out     the other pairs, in order, from the same place on
#           $3 behind the last of them
#   Uses    $3-$5, $10-$29   Saves  -   Stack  0   Calls  -
#   Domain  any
#   Error   0
#   Twin    oracle/src/twin/cull.rs

        .include "work_unit.inc"
        .include "macros.inc"

        .set    a_pair,3
        .set    count,4
        .set    near,5
        # constants
        .set    m_first,10
        # state
        .set    a_out,11
        # the pair
        .set    pair,12
        .set    a_packet,13
        .set    t,14                                    # to 17
        .set    farther,18                              # to 21
        .set    step,22

function hidden_pairs_r16
        biz     $count,$lr
        splat_mask $m_first
        splat   $near,$near,$m_first
        ori     $a_out,$a_pair,0
next_pair:
        lqd     $pair,0($a_pair)
        rotqbyi $a_packet,$pair,PAIR_packet
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
