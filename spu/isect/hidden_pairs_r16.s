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
# Scheduled by spu schedule from hidden_pairs_r16.s

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
        .set    count_2,79
        .set    a_pair_2,2
        .set    pair_2,6
        .set    a_pair_3,7
        .set    pair_3,2
        .set    a_packet_2,7
        .set    t_2,8
        .set    t3_2,9
        .set    t1_2,10
        .set    t2_2,17
        .set    pair_4,3
        .set    step_2,2
        nop     $127                                    # 0e pairing
        biz     $count,$lr                              # 0o

        ila     $m_first,0x10203                        # 1e
        clgti   $count_2,$count,3                       # 2e at least as many passes as overlap

        ori     $a_out,$a_pair,0                        # 3e
        shufb   $near,$near,$near,$m_first              # 3o

        nop     $127                                    # 4e pairing
        brz     $count_2,next_pair_short                # 4o too few passes

        ai      $a_pair_2,$a_pair,16                    # 5e
        lqd     $pair_2,0($a_pair)                      # 5o

        ai      $count,$count,-1                        # 6e
        hbrr    next_pair_back,next_pair                # 6o hint

        ai      $a_pair_3,$a_pair_2,16                  # 7e
        lqd     $pair_3,0($a_pair_2)                    # 7o

        ai      $count,$count,-1                        # 8e
        lnop                                            # 8o pairing

        ai      $a_pair,$a_pair_3,16                    # 9e
        lqd     $pair,0($a_pair_3)                      # 9o

        ai      $count,$count,-1                        # 10e
        rotqbyi $a_packet,$pair_2,4                     # 11o

        shlqbyi $pair_2,$pair_2,0                       # 12o copy
        rotqbyi $a_packet_2,$pair_3,4                   # 13o

        shlqbyi $pair_3,$pair_3,0                       # 14o copy
        lqd     $t+3,240($a_packet)                     # 15o

        lqd     $t+1,208($a_packet)                     # 16o
        lqd     $t+2,224($a_packet)                     # 17o

        lqd     $t_2,192($a_packet)                     # 18o
        lqd     $t3_2,240($a_packet_2)                  # 19o

        nop     $127                                    # 20e pairing
        lqd     $t1_2,208($a_packet_2)                  # 20o

        fcgt    $farther+3,$t+3,$near                   # 21e
        lqd     $t2_2,224($a_packet_2)                  # 21o

        fcgt    $farther+1,$t+1,$near                   # 22e
        stqd    $pair_2,0($a_out)                       # 22o never ahead of the reading

        fcgt    $farther+2,$t+2,$near                   # 23e
        lqd     $t,192($a_packet_2)                     # 23o

        fcgt    $farther,$t_2,$near                     # 24e
        rotqbyi $a_packet,$pair,4                       # 24o

        or      $farther+2,$farther+2,$farther+3        # 25e
        or      $farther,$farther,$farther+1            # 26e

        fcgt    $farther+1,$t1_2,$near                  # 27e
        or      $farther,$farther,$farther+2            # 28e

        fcgt    $farther+3,$t3_2,$near                  # 29e
        lnop                                            # 29o pairing

        fcgt    $farther+2,$t2_2,$near                  # 30e
        gb      $step,$farther                          # 30o

        clgti   $step,$step,0                           # 34e
        andi    $step,$step,16                          # 36e

next_pair:
            fcgt    $farther,$t,$near                   # 0e
            lnop                                        # 0o pairing

            a       $a_out,$a_out,$step                 # 1e
            lqd     $t+3,240($a_packet)                 # 1o

            or      $farther+2,$farther+2,$farther+3    # 2e
            lqd     $t+1,208($a_packet)                 # 2o

            or      $farther,$farther,$farther+1        # 3e
            stqd    $pair_3,0($a_out)                   # 3o never ahead of the reading

        ai      $count,$count,-1                        # 4e
            shlqbyi $pair_3,$pair,0                     # 4o copy

            or      $farther,$farther,$farther+2        # 5e
        lqd     $pair,0($a_pair)                        # 5o

        ai      $a_pair,$a_pair,16                      # 6e
            lqd     $t+2,224($a_packet)                 # 6o

            nop     $127                                # 7e pairing
            gb      $step,$farther                      # 7o

            fcgt    $farther+1,$t+1,$near               # 8e
            lqd     $t,192($a_packet)                   # 8o

            fcgt    $farther+3,$t+3,$near               # 9e
            lnop                                        # 9o pairing

            clgti   $step,$step,0                       # 11e
        rotqbyi $a_packet,$pair,4                       # 11o

            fcgt    $farther+2,$t+2,$near               # 12e
            lnop                                        # 12o pairing

            andi    $step,$step,16                      # 13e
next_pair_back:
        brnz    $count,next_pair                        # 13o

next_pair_drain:
        fcgt    $farther,$t,$near                       # 0e
        lqd     $t+3,240($a_packet)                     # 0o

        or      $farther+2,$farther+2,$farther+3        # 1e
        lqd     $t+1,208($a_packet)                     # 1o

        or      $farther,$farther,$farther+1            # 2e
        lqd     $t+2,224($a_packet)                     # 2o

        a       $a_out,$a_out,$step                     # 3e
        lqd     $t,192($a_packet)                       # 3o

        or      $farther,$farther,$farther+2            # 4e
        hbr     hidden_pairs_r16_return,$lr             # 4o hint

        nop     $127                                    # 5e pairing
        shlqbyi $pair_4,$pair,0                         # 5o copy

        fcgt    $farther+3,$t+3,$near                   # 6e
        gb      $step,$farther                          # 6o

        fcgt    $farther+1,$t+1,$near                   # 7e
        stqd    $pair_3,0($a_out)                       # 7o never ahead of the reading

        fcgt    $farther+2,$t+2,$near                   # 8e
        fcgt    $farther,$t,$near                       # 9e

        or      $farther+2,$farther+2,$farther+3        # 10e
        or      $farther,$farther,$farther+1            # 11e

        clgti   $step,$step,0                           # 12e
        or      $farther,$farther,$farther+2            # 13e

        andi    $step,$step,16                          # 14e
        gb      $step_2,$farther                        # 15o

        a       $a_out,$a_out,$step                     # 16e
        stqd    $pair_4,0($a_out)                       # 18o never ahead of the reading

        clgti   $step,$step_2,0                         # 19e
        andi    $step,$step,16                          # 21e

        a       $a_out,$a_out,$step                     # 23e
        lnop                                            # 23o pairing

        ori     $a_pair,$a_out,0                        # 25e
hidden_pairs_r16_return:
        bi      $lr                                     # 25o

next_pair_short:
        ai      $count,$count,-1                        # 0e
        lqd     $pair,0($a_pair)                        # 0o

        ai      $a_pair,$a_pair,16                      # 1e
        rotqbyi $a_packet,$pair,4                       # 6o

        stqd    $pair,0($a_out)                         # 7o never ahead of the reading
        lqd     $t,192($a_packet)                       # 10o

        lqd     $t+1,208($a_packet)                     # 11o
        lqd     $t+2,224($a_packet)                     # 12o

        lqd     $t+3,240($a_packet)                     # 13o
        fcgt    $farther,$t,$near                       # 16e

        fcgt    $farther+1,$t+1,$near                   # 17e
        fcgt    $farther+2,$t+2,$near                   # 18e

        fcgt    $farther+3,$t+3,$near                   # 19e
        or      $farther,$farther,$farther+1            # 20e

        or      $farther+2,$farther+2,$farther+3        # 21e
        or      $farther,$farther,$farther+2            # 23e

        gb      $step,$farther                          # 25o
        clgti   $step,$step,0                           # 29e

        andi    $step,$step,16                          # 31e
        lnop                                            # 31o pairing

        a       $a_out,$a_out,$step                     # 33e
        brnz    $count,next_pair_short                  # 33o

        ori     $a_pair,$a_out,0                        # 35e
        bi      $lr                                     # 35o
endfunction hidden_pairs_r16
