# hidden_pairs_r16   drops the pairs in which all rays have hit something nearer than the sphere
#   C       struct pair *hidden_pairs_r16(struct pair *, int count);
#   In      $3 pairs of packets and spheres, $4 count (0 is none); pointers 16-aligned
#   Out     the other pairs, in order, from the same place on
#           $3 behind the last of them
#   Uses    $3-$4, $10-$23   Saves  -   Stack  0   Calls  -
#   Domain  any
#   Error   0
#   Twin    oracle/src/twin/cull.rs
# Scheduled by spu schedule from hidden_pairs_r16.s

        .include "work_unit.inc"
        .include "macros.inc"

        .set    a_pair,3
        .set    count,4
        # constants
        .set    m_near,10
        # state
        .set    a_out,11
        # the pair
        .set    pair,12
        .set    a_packet,13
        .set    near,14
        .set    t,15                                    # to 18
        .set    farther,19                              # to 22
        .set    step,23

function hidden_pairs_r16
        .set    count_2,79
        .set    a_pair_2,2
        .set    pair_2,5
        .set    a_packet_2,6
        .set    near_2,7
        .set    pair_3,2
        .set    t2_2,8
        .set    near_3,5
        .set    step_2,3
        nop     $127                                    # 0e pairing
        biz     $count,$lr                              # 0o

        ilhu    $m_near,1                               # 1e
        clgti   $count_2,$count,2                       # 2e at least as many passes as overlap

        iohl    $m_near,515                             # 3e
        lnop                                            # 3o pairing

        ori     $a_out,$a_pair,0                        # 4e
        brz     $count_2,next_pair_short                # 4o too few passes

        ai      $a_pair_2,$a_pair,16                    # 5e
        lqd     $pair_2,0($a_pair)                      # 5o

        ai      $count,$count,-1                        # 6e
        hbrr    next_pair_back,next_pair                # 6o hint

        ai      $a_pair,$a_pair_2,16                    # 7e
        lqd     $pair,0($a_pair_2)                      # 7o

        ai      $count,$count,-1                        # 8e
        rotqbyi $a_packet_2,$pair_2,4                   # 11o

        lqd     $near_2,16($pair_2)                     # 12o
        rotqbyi $a_packet,$pair,4                       # 13o

        shlqbyi $pair_3,$pair_2,0                       # 14o copy
        lqd     $t,192($a_packet_2)                     # 15o

        lqd     $t2_2,224($a_packet_2)                  # 16o
        lqd     $t+1,208($a_packet_2)                   # 17o

        shufb   $near,$near_2,$near_2,$m_near           # 18o
        lqd     $t+3,240($a_packet_2)                   # 19o

        lqd     $near_3,16($pair)                       # 20o
        lqd     $t+2,224($a_packet)                     # 21o

        fcgt    $farther+2,$t2_2,$near                  # 22e
        fcgt    $farther+1,$t+1,$near                   # 23e

        fcgt    $farther,$t,$near                       # 24e
        fcgt    $farther+3,$t+3,$near                   # 25e

next_pair:
            or      $farther+2,$farther+2,$farther+3    # 0e
            stqd    $pair_3,0($a_out)                   # 0o never ahead of the reading

            or      $farther,$farther,$farther+1        # 1e
            shlqbyi $pair_3,$pair,0                     # 1o copy

        ai      $count,$count,-1                        # 2e
            shufb   $near,$near_3,$near_3,$m_near       # 2o

            or      $farther,$farther,$farther+2        # 3e
        lqd     $pair,0($a_pair)                        # 3o

        ai      $a_pair,$a_pair,16                      # 4e
            lqd     $t+3,240($a_packet)                 # 4o

            nop     $127                                # 5e pairing
            gb      $step,$farther                      # 5o

            fcgt    $farther+2,$t+2,$near               # 6e
            lqd     $t+1,208($a_packet)                 # 6o

            nop     $127                                # 7e pairing
            lqd     $t,192($a_packet)                   # 7o

            clgti   $step,$step,0                       # 9e
        rotqbyi $a_packet,$pair,4                       # 9o

            fcgt    $farther+3,$t+3,$near               # 10e
            lnop                                        # 10o pairing

            andi    $step,$step,16                      # 11e
        lqd     $near_3,16($pair)                       # 11o

            fcgt    $farther+1,$t+1,$near               # 12e
            lnop                                        # 12o pairing

            a       $a_out,$a_out,$step                 # 13e
        lqd     $t+2,224($a_packet)                     # 13o

            fcgt    $farther,$t,$near                   # 14e
next_pair_back:
        brnz    $count,next_pair                        # 14o

next_pair_drain:
        or      $farther,$farther,$farther+1            # 0e
        stqd    $pair_3,0($a_out)                       # 0o never ahead of the reading

        or      $farther+2,$farther+2,$farther+3        # 1e
        shufb   $near,$near_3,$near_3,$m_near           # 1o

        nop     $127                                    # 2e pairing
        lqd     $t+1,208($a_packet)                     # 2o

        or      $farther,$farther,$farther+2            # 3e
        lqd     $t+3,240($a_packet)                     # 3o

        nop     $127                                    # 4e pairing
        lqd     $t,192($a_packet)                       # 4o

        fcgt    $farther+2,$t+2,$near                   # 5e
        hbr     hidden_pairs_r16_return,$lr             # 5o hint

        gb      $step,$farther                          # 6o
        shlqbyi $pair_3,$pair,0                         # 7o copy

        fcgt    $farther+1,$t+1,$near                   # 8e
        fcgt    $farther+3,$t+3,$near                   # 9e

        fcgt    $farther,$t,$near                       # 10e
        or      $farther+2,$farther+2,$farther+3        # 11e

        or      $farther,$farther,$farther+1            # 12e
        clgti   $step,$step,0                           # 13e

        or      $farther,$farther,$farther+2            # 14e
        andi    $step,$step,16                          # 15e

        gb      $step_2,$farther                        # 16o
        a       $a_out,$a_out,$step                     # 17e

        stqd    $pair_3,0($a_out)                       # 19o never ahead of the reading
        clgti   $step,$step_2,0                         # 20e

        andi    $step,$step,16                          # 22e
        a       $a_out,$a_out,$step                     # 24e

        ori     $a_pair,$a_out,0                        # 26e
hidden_pairs_r16_return:
        bi      $lr                                     # 26o

next_pair_short:
        ai      $count,$count,-1                        # 0e
        lqd     $pair,0($a_pair)                        # 0o

        ai      $a_pair,$a_pair,16                      # 1e
        rotqbyi $a_packet,$pair,4                       # 6o

        lqd     $near,16($pair)                         # 7o
        stqd    $pair,0($a_out)                         # 8o never ahead of the reading

        lqd     $t,192($a_packet)                       # 10o
        lqd     $t+1,208($a_packet)                     # 11o

        lqd     $t+2,224($a_packet)                     # 12o
        shufb   $near,$near,$near,$m_near               # 13o

        lqd     $t+3,240($a_packet)                     # 14o
        fcgt    $farther,$t,$near                       # 17e

        fcgt    $farther+1,$t+1,$near                   # 18e
        fcgt    $farther+2,$t+2,$near                   # 19e

        fcgt    $farther+3,$t+3,$near                   # 20e
        or      $farther,$farther,$farther+1            # 21e

        or      $farther+2,$farther+2,$farther+3        # 22e
        or      $farther,$farther,$farther+2            # 24e

        gb      $step,$farther                          # 26o
        clgti   $step,$step,0                           # 30e

        andi    $step,$step,16                          # 32e
        lnop                                            # 32o pairing

        a       $a_out,$a_out,$step                     # 34e
        brnz    $count,next_pair_short                  # 34o

        ori     $a_pair,$a_out,0                        # 36e
        bi      $lr                                     # 36o
endfunction hidden_pairs_r16
