# hidden_pairs_r16   drops the pairs in which all rays have hit something nearer than the sphere
#   C       struct pair *hidden_pairs_r16(struct pair *, int count);
#   In      $3 pairs of packets and spheres, $4 count (0 is none); pointers 16-aligned
#   Out     the other pairs, in order, from the same place on
#           $3 behind the last of them
#   Uses    $2-$23, $79   Saves  -   Stack  0   Calls  -
#   Domain  any
#   Error   0
#   Twin    lab/twins/src/cull.rs
# Scheduled by spu schedule from hidden_pairs_r16.s

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
        .set count_2,79; .set a_pair_2,2; .set a_pair_3,5; .set pair_2,2; .set pair_3,5
        .set pair_4,6; .set a_packet_2,7; .set near_2,8; .set t2_2,9; .set t3_2,12; .set pair_5,3
        .set step_2,2
        nop     $127                                    # 0e pairing
        biz     $count,$lr                              # 0o
        ilhu    $m_near,1                               # 1e
        clgti   $count_2,$count,3                       # 2e at least as many passes as overlap
        iohl    $m_near,515                             # 3e
        lnop                                            # 3o pairing
        ori     $a_out,$a_pair,0                        # 4e
        brz     $count_2,next_pair_short                # 4o too few passes
        ai      $a_pair_2,$a_pair,16                    # 5e
        lqd     $pair,0($a_pair)                        # 5o
        ai      $count,$count,-1                        # 6e
        hbrr    next_pair_back,next_pair                # 6o hint
        ai      $a_pair_3,$a_pair_2,16                  # 7e
        lqd     $pair_2,0($a_pair_2)                    # 7o
        ai      $count,$count,-1                        # 8e
        lnop                                            # 8o pairing
        ai      $a_pair,$a_pair_3,16                    # 9e
        lqd     $pair_3,0($a_pair_3)                    # 9o
        ai      $count,$count,-1                        # 10e
        rotqbyi $a_packet,$pair,4                       # 11o
        lqd     $near,16($pair)                         # 12o
        shlqbyi $pair_4,$pair,0                         # 13o copy
        rotqbyi $a_packet_2,$pair_2,4                   # 14o
        lqd     $t,192($a_packet)                       # 15o
        lqd     $t+2,224($a_packet)                     # 16o
        lqd     $t+3,240($a_packet)                     # 17o
        lqd     $t+1,208($a_packet)                     # 18o
        shufb   $near,$near,$near,$m_near               # 19o
        lqd     $near_2,16($pair_2)                     # 20o
        shlqbyi $pair_4,$pair_4,0                       # 21o copy
        nop     $127                                    # 22e pairing
        lqd     $t2_2,224($a_packet_2)                  # 22o
        fcgt    $farther,$t,$near                       # 23e
        lqd     $t3_2,240($a_packet_2)                  # 23o
        fcgt    $farther+2,$t+2,$near                   # 24e
        shlqbyi $pair_2,$pair_2,0                       # 24o copy
        fcgt    $farther+3,$t+3,$near                   # 25e
        lqd     $t,192($a_packet_2)                     # 25o
        fcgt    $farther+1,$t+1,$near                   # 26e
        shufb   $near_2,$near_2,$near_2,$m_near         # 26o
        or      $farther+2,$farther+2,$farther+3        # 27e
        lqd     $t+1,208($a_packet_2)                   # 27o
        or      $farther,$farther,$farther+1            # 28e
        stqd    $pair_4,0($a_out)                       # 28o never ahead of the reading
        nop     $127                                    # 29e pairing
        lqd     $near,16($pair_3)                       # 29o
        or      $farther,$farther,$farther+2            # 30e
        shlqbyi $pair_2,$pair_2,0                       # 30o copy
        fcgt    $farther+2,$t2_2,$near_2                # 31e
        rotqbyi $a_packet,$pair_3,4                     # 31o
        fcgt    $farther+3,$t3_2,$near_2                # 32e
        gb      $step,$farther                          # 32o
        fcgt    $farther,$t,$near_2                     # 33e
        shlqbyi $pair_3,$pair_3,0                       # 33o copy
        fcgt    $farther+1,$t+1,$near_2                 # 34e
        or      $farther+2,$farther+2,$farther+3        # 35e
next_pair:
            or      $farther,$farther,$farther+1        # 0e
            lqd     $t,192($a_packet)                   # 0o
            clgti   $step,$step,0                       # 1e
        lqd     $pair,0($a_pair)                        # 1o
            or      $farther,$farther,$farther+2        # 2e
            lqd     $t+2,224($a_packet)                 # 2o
            andi    $step,$step,16                      # 3e
            lqd     $t+3,240($a_packet)                 # 3o
        ai      $a_pair,$a_pair,16                      # 4e
            shufb   $near,$near,$near,$m_near           # 4o
            a       $a_out,$a_out,$step                 # 5e
            lqd     $t+1,208($a_packet)                 # 5o
        ai      $count,$count,-1                        # 6e
            gb      $step,$farther                      # 6o
            nop     $127                                # 7e pairing
            stqd    $pair_2,0($a_out)                   # 7o never ahead of the reading
            fcgt    $farther,$t,$near                   # 8e
            shlqbyi $pair_2,$pair_3,0                   # 8o copy
            fcgt    $farther+2,$t+2,$near               # 9e
        rotqbyi $a_packet,$pair,4                       # 9o
            fcgt    $farther+3,$t+3,$near               # 10e
        shlqbyi $pair_3,$pair,0                         # 10o copy
            fcgt    $farther+1,$t+1,$near               # 11e
        lqd     $near,16($pair)                         # 11o
            or      $farther+2,$farther+2,$farther+3    # 12e
next_pair_back:
        brnz    $count,next_pair                        # 12o
next_pair_drain:
        or      $farther,$farther,$farther+1            # 0e
        shufb   $near,$near,$near,$m_near               # 0o
        clgti   $step,$step,0                           # 1e
        lqd     $t+2,224($a_packet)                     # 1o
        or      $farther,$farther,$farther+2            # 2e
        lqd     $t+3,240($a_packet)                     # 2o
        andi    $step,$step,16                          # 3e
        lqd     $t+1,208($a_packet)                     # 3o
        nop     $127                                    # 4e pairing
        lqd     $t,192($a_packet)                       # 4o
        a       $a_out,$a_out,$step                     # 5e
        hbr     hidden_pairs_r16_return,$lr             # 5o hint
        nop     $127                                    # 6e pairing
        gb      $step,$farther                          # 6o
        fcgt    $farther+2,$t+2,$near                   # 7e
        shlqbyi $pair_5,$pair_3,0                       # 7o copy
        fcgt    $farther+3,$t+3,$near                   # 8e
        stqd    $pair_2,0($a_out)                       # 8o never ahead of the reading
        fcgt    $farther+1,$t+1,$near                   # 9e
        fcgt    $farther,$t,$near                       # 10e
        or      $farther+2,$farther+2,$farther+3        # 11e
        or      $farther,$farther,$farther+1            # 12e
        clgti   $step,$step,0                           # 13e
        or      $farther,$farther,$farther+2            # 14e
        andi    $step,$step,16                          # 15e
        gb      $step_2,$farther                        # 16o
        a       $a_out,$a_out,$step                     # 17e
        stqd    $pair_5,0($a_out)                       # 19o never ahead of the reading
        clgti   $step,$step_2,0                         # 20e
        andi    $step,$step,16                          # 22e
        a       $a_out,$a_out,$step                     # 24e
        lnop                                            # 24o pairing
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
