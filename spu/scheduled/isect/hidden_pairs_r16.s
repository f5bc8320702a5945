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
        .set count_2,79; .set a_pair_2,2; .set a_pair_3,5; .set pair_2,6; .set pair_3,5
        .set near_2,2; .set near_3,7; .set a_packet_2,8; .set pair_4,9; .set t1_2,12; .set t3_2,19
        .set t2_2,21; .set t_2,8; .set farther2_2,13; .set farther_2,14; .set farther2_3,9
        .set farther_3,9; .set step_2,2
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
        lqd     $near_2,16($pair)                       # 11o
        rotqbyi $a_packet,$pair,4                       # 12o
        lqd     $near_3,16($pair_2)                     # 13o
        rotqbyi $a_packet_2,$pair_2,4                   # 14o
        shlqbyi $pair_4,$pair,0                         # 15o copy
        lqd     $t+1,208($a_packet)                     # 16o
        lqd     $t+3,240($a_packet)                     # 17o
        lqd     $t+2,224($a_packet)                     # 18o
        lqd     $t,192($a_packet)                       # 19o
        shufb   $near,$near_2,$near_2,$m_near           # 20o
        lqd     $t1_2,208($a_packet_2)                  # 21o
        lqd     $t3_2,240($a_packet_2)                  # 22o
        lqd     $t2_2,224($a_packet_2)                  # 23o
        fcgt    $farther+1,$t+1,$near                   # 24e
        lqd     $t_2,192($a_packet_2)                   # 24o
        fcgt    $farther2_2,$t+2,$near                  # 25e
        lqd     $near_2,16($pair_3)                     # 25o
        fcgt    $farther+3,$t+3,$near                   # 26e
        shufb   $near_3,$near_3,$near_3,$m_near         # 26o
        fcgt    $farther_2,$t,$near                     # 27e
        stqd    $pair_4,0($a_out)                       # 27o never ahead of the reading
        or      $farther2_3,$farther2_2,$farther+3      # 28e
        shlqbyi $pair_2,$pair_2,0                       # 28o copy
        or      $farther_2,$farther_2,$farther+1        # 29e
        rotqbyi $a_packet,$pair_3,4                     # 29o
        fcgt    $farther+1,$t1_2,$near_3                # 30e
        shlqbyi $pair_3,$pair_3,0                       # 30o copy
        or      $farther_3,$farther_2,$farther2_3       # 31e
        fcgt    $farther+2,$t2_2,$near_3                # 32e
        fcgt    $farther+3,$t3_2,$near_3                # 33e
        gb      $step,$farther_3                        # 33o
        fcgt    $farther,$t_2,$near_3                   # 34e
        lnop                                            # 34o pairing
next_pair:
            or      $farther+2,$farther+2,$farther+3    # 0e
        lqd     $pair,0($a_pair)                        # 0o
        ai      $a_pair,$a_pair,16                      # 1e
            lqd     $t+1,208($a_packet)                 # 1o
            or      $farther,$farther,$farther+1        # 2e
            lqd     $t+3,240($a_packet)                 # 2o
            clgti   $step,$step,0                       # 3e
            lqd     $t+2,224($a_packet)                 # 3o
            or      $farther,$farther,$farther+2        # 4e
            shufb   $near,$near_2,$near_2,$m_near       # 4o
            andi    $step,$step,16                      # 5e
            lqd     $t,192($a_packet)                   # 5o
        ai      $count,$count,-1                        # 6e
        lqd     $near_2,16($pair)                       # 6o
            a       $a_out,$a_out,$step                 # 7e
        rotqbyi $a_packet,$pair,4                       # 7o
            fcgt    $farther+1,$t+1,$near               # 8e
            gb      $step,$farther                      # 8o
            fcgt    $farther+2,$t+2,$near               # 9e
            stqd    $pair_2,0($a_out)                   # 9o never ahead of the reading
            fcgt    $farther+3,$t+3,$near               # 10e
        shlqbyi $pair_2,$pair,0                         # 10o copy
            fcgt    $farther,$t,$near                   # 11e
        brz     $count,next_pair_drain_2                # 11o the last pass
            or      $farther+2,$farther+2,$farther+3    # 12e
        lqd     $pair,0($a_pair)                        # 12o
        ai      $a_pair,$a_pair,16                      # 13e
            lqd     $t+1,208($a_packet)                 # 13o
            or      $farther,$farther,$farther+1        # 14e
            lqd     $t+3,240($a_packet)                 # 14o
            clgti   $step,$step,0                       # 15e
            lqd     $t+2,224($a_packet)                 # 15o
            or      $farther,$farther,$farther+2        # 16e
            shufb   $near,$near_2,$near_2,$m_near       # 16o
            andi    $step,$step,16                      # 17e
            lqd     $t,192($a_packet)                   # 17o
        ai      $count,$count,-1                        # 18e
        lqd     $near_2,16($pair)                       # 18o
            a       $a_out,$a_out,$step                 # 19e
        rotqbyi $a_packet,$pair,4                       # 19o
            fcgt    $farther+1,$t+1,$near               # 20e
            gb      $step,$farther                      # 20o
            fcgt    $farther+2,$t+2,$near               # 21e
            stqd    $pair_3,0($a_out)                   # 21o never ahead of the reading
            fcgt    $farther+3,$t+3,$near               # 22e
        shlqbyi $pair_3,$pair,0                         # 22o copy
            fcgt    $farther,$t,$near                   # 23e
next_pair_back:
        brnz    $count,next_pair                        # 23o
next_pair_drain:
        or      $farther,$farther,$farther+1            # 0e
        shufb   $near,$near_2,$near_2,$m_near           # 0o
        or      $farther+2,$farther+2,$farther+3        # 1e
        lqd     $t,192($a_packet)                       # 1o
        clgti   $step,$step,0                           # 2e
        lqd     $t+1,208($a_packet)                     # 2o
        or      $farther,$farther,$farther+2            # 3e
        lqd     $t+3,240($a_packet)                     # 3o
        andi    $step,$step,16                          # 4e
        lqd     $t+2,224($a_packet)                     # 4o
        nop     $127                                    # 5e pairing
        hbr     hidden_pairs_r16_return,$lr             # 5o hint
        a       $a_out,$a_out,$step                     # 6e
        gb      $step,$farther                          # 6o
        fcgt    $farther,$t,$near                       # 7e
        lnop                                            # 7o pairing
        fcgt    $farther+1,$t+1,$near                   # 8e
        stqd    $pair_2,0($a_out)                       # 8o never ahead of the reading
        fcgt    $farther+3,$t+3,$near                   # 9e
        fcgt    $farther+2,$t+2,$near                   # 10e
        or      $farther,$farther,$farther+1            # 11e
        or      $farther+2,$farther+2,$farther+3        # 12e
        clgti   $step,$step,0                           # 13e
        or      $farther,$farther,$farther+2            # 14e
        andi    $step,$step,16                          # 15e
        gb      $step_2,$farther                        # 16o
        a       $a_out,$a_out,$step                     # 17e
        stqd    $pair_3,0($a_out)                       # 19o never ahead of the reading
        clgti   $step,$step_2,0                         # 20e
        andi    $step,$step,16                          # 22e
        a       $a_out,$a_out,$step                     # 24e
        lnop                                            # 24o pairing
        ori     $a_pair,$a_out,0                        # 26e
hidden_pairs_r16_return:
        bi      $lr                                     # 26o
next_pair_drain_2:
        or      $farther,$farther,$farther+1            # 0e
        shufb   $near,$near_2,$near_2,$m_near           # 0o
        or      $farther+2,$farther+2,$farther+3        # 1e
        lqd     $t,192($a_packet)                       # 1o
        clgti   $step,$step,0                           # 2e
        lqd     $t+1,208($a_packet)                     # 2o
        or      $farther,$farther,$farther+2            # 3e
        lqd     $t+3,240($a_packet)                     # 3o
        andi    $step,$step,16                          # 4e
        lqd     $t+2,224($a_packet)                     # 4o
        nop     $127                                    # 5e pairing
        hbr     hidden_pairs_r16_return_2,$lr           # 5o hint
        a       $a_out,$a_out,$step                     # 6e
        gb      $step,$farther                          # 6o
        fcgt    $farther,$t,$near                       # 7e
        lnop                                            # 7o pairing
        fcgt    $farther+1,$t+1,$near                   # 8e
        stqd    $pair_3,0($a_out)                       # 8o never ahead of the reading
        fcgt    $farther+3,$t+3,$near                   # 9e
        fcgt    $farther+2,$t+2,$near                   # 10e
        or      $farther,$farther,$farther+1            # 11e
        or      $farther+2,$farther+2,$farther+3        # 12e
        clgti   $step,$step,0                           # 13e
        or      $farther,$farther,$farther+2            # 14e
        andi    $step,$step,16                          # 15e
        gb      $step_2,$farther                        # 16o
        a       $a_out,$a_out,$step                     # 17e
        stqd    $pair_2,0($a_out)                       # 19o never ahead of the reading
        clgti   $step,$step_2,0                         # 20e
        andi    $step,$step,16                          # 22e
        a       $a_out,$a_out,$step                     # 24e
        lnop                                            # 24o pairing
        ori     $a_pair,$a_out,0                        # 26e
hidden_pairs_r16_return_2:
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
