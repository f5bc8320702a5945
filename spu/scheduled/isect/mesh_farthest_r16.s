# mesh_farthest_r16   how far the rays of packets count, after hits
#   C       void mesh_farthest_r16(const struct rays16 *, int count, struct mesh_bound *);
#   In      $3 RAYS16, one behind the other, $4 count (0 is none), $5 MESH_BOUNDs likewise; pointers
#           16-aligned
#   Out     the bounds' farthest: the largest t, or -1 if no ray is there
#   Uses    $2-$20, $79   Saves  -   Stack  0   Calls  -
#   Domain  t has a sign where no ray is
#   Error   0
#   Twin    lab/twins/src/mesh.rs
# Scheduled by spu schedule from mesh_farthest_r16.s

        .include "work_unit.inc"
        .include "macros.inc"

        .set    NEXT,3
        registers a_packet,count,a_bound
        .set    NEXT,10
        registers k_none,m_word
        registers t                                     # to 15
        .set    NEXT,t+4
        registers turned,c_greater,c_there,last

        .section .rodata
        .align  4
last_word_of_another:
        .int    0x00010203,0x04050607,0x08090a0b,0x1c1d1e1f

.macro  farther a:req, b:req
        cgt     $c_greater,\b,\a
        selb    \a,\a,\b,$c_greater
.endm

function mesh_farthest_r16
        .set count_2,79; .set a_packet_2,6; .set t_2,2; .set t_3,7; .set t1_2,8; .set t2_2,9
        .set t3_2,6; .set a_packet_3,12; .set c_greater_2,16; .set t_4,18; .set t2_3,15
        .set t3_3,16; .set c_greater_3,3; .set c_greater_4,20; .set t_5,3; .set turned_2,6
        .set c_greater_5,7; .set c_greater_6,8; .set c_greater_7,9; .set t_6,9; .set turned_3,12
        .set t_7,8; .set a_bound_2,2; .set a_bound_3,3; .set a_bound_4,4; .set a_packet_4,2
        .set c_greater_8,2
        nop     $127                                    # 0e pairing
        biz     $count,$lr                              # 0o
        clgti   $count_2,$count,3                       # 1e at least as many passes as overlap
        lqa     $m_word,last_word_of_another            # 1o
        ilhu    $k_none,0xbf80                          # 2e -1
        brz     $count_2,next_farthest_short            # 3o too few passes
        ai      $a_packet_2,$a_packet,320               # 4e
        lqd     $t_2,384($a_packet)                     # 4o
        ai      $count,$count,-1                        # 5e
        lqd     $t+1,400($a_packet)                     # 5o
        ai      $a_packet_2,$a_packet_2,320             # 6e
        lqd     $t+2,416($a_packet)                     # 6o
        ai      $count,$count,-1                        # 7e
        lqd     $t+3,432($a_packet)                     # 7o
        ai      $a_packet,$a_packet_2,320               # 8e
        lqd     $t_3,384($a_packet_2)                   # 8o
        ai      $count,$count,-1                        # 9e
        lqd     $t1_2,400($a_packet_2)                  # 9o
        ai      $a_packet,$a_packet,320                 # 10e
        lqd     $t2_2,416($a_packet_2)                  # 10o
        cgt     $c_greater,$t+1,$t_2                    # 11e
        lqd     $t3_2,432($a_packet_2)                  # 11o
        ai      $a_packet_3,$a_packet,320               # 12e
        hbrr    next_farthest_back,next_farthest        # 12o hint
        cgt     $c_greater_2,$t+3,$t+2                  # 13e
        lqd     $t_4,384($a_packet)                     # 13o
        selb    $t_2,$t_2,$t+1,$c_greater               # 14e
        lqd     $t+1,400($a_packet)                     # 14o
        selb    $t+2,$t+2,$t+3,$c_greater_2             # 15e
        lqd     $t2_3,416($a_packet)                    # 15o
        cgt     $c_greater,$t1_2,$t_3                   # 16e
        lqd     $t3_3,432($a_packet)                    # 16o
        cgt     $c_greater_3,$t+2,$t_2                  # 17e
        lqd     $last,192($a_bound)                     # 17o
        cgt     $c_greater_4,$t3_2,$t2_2                # 18e
        selb    $t_2,$t_2,$t+2,$c_greater_3             # 19e
        selb    $t_5,$t_3,$t1_2,$c_greater              # 20e
        lnop                                            # 20o pairing
        selb    $t+2,$t2_2,$t3_2,$c_greater_4           # 21e
        rotqbyi $turned_2,$t_2,8                        # 21o
        cgt     $c_greater,$t+1,$t_4                    # 22e
        cgt     $c_greater_5,$t+2,$t_5                  # 23e
        cgt     $c_greater_6,$t3_3,$t2_3                # 24e
        cgt     $c_greater_7,$turned_2,$t_2             # 25e
        selb    $t_3,$t_5,$t+2,$c_greater_5             # 26e
        selb    $t_2,$t_2,$turned_2,$c_greater_7        # 27e
        ai      $a_packet,$a_packet_3,320               # 28e
        rotqbyi $turned_2,$t_3,8                        # 28o
        selb    $t_6,$t_4,$t+1,$c_greater               # 29e
        rotqbyi $turned_3,$t_2,4                        # 29o
        selb    $t+2,$t2_3,$t3_3,$c_greater_6           # 30e
        cgt     $c_greater_6,$turned_2,$t_3             # 32e
        cgt     $c_greater,$turned_3,$t_2               # 33e
        selb    $t_7,$t_3,$turned_2,$c_greater_6        # 34e
        selb    $t,$t_2,$turned_3,$c_greater            # 35e
        cgti    $c_there,$t,-1                          # 37e
next_farthest:
            cgt     $c_greater,$t+2,$t_6                # 0e
            rotqbyi $turned,$t_7,4                      # 0o
            selb    $t,$k_none,$t,$c_there              # 1e
        lqd     $t_2,384($a_packet)                     # 1o
        ai      $a_packet_2,$a_packet,320               # 2e
        lqd     $t+1,400($a_packet)                     # 2o
            selb    $t_3,$t_6,$t+2,$c_greater           # 3e
        lqd     $t+2,416($a_packet)                     # 3o
            cgt     $c_greater,$turned,$t_7             # 4e
            shufb   $last,$last,$t,$m_word              # 4o
        ai      $count,$count,-1                        # 5e
        lqd     $t+3,432($a_packet)                     # 5o
        ai      $a_packet,$a_packet_2,320               # 6e
            rotqbyi $turned_2,$t_3,8                    # 6o
            selb    $t,$t_7,$turned,$c_greater          # 7e
            lnop                                        # 7o pairing
        cgt     $c_greater,$t+1,$t_2                    # 8e
            stqd    $last,192($a_bound)                 # 8o
            ai      $a_bound,$a_bound,208               # 9e
            cgt     $c_greater_6,$turned_2,$t_3         # 10e
        selb    $t_6,$t_2,$t+1,$c_greater               # 11e
        cgt     $c_greater,$t+3,$t+2                    # 12e
            selb    $t_7,$t_3,$turned_2,$c_greater_6    # 13e
            lnop                                        # 13o pairing
        selb    $t+2,$t+2,$t+3,$c_greater               # 14e
            lqd     $last,192($a_bound)                 # 14o
            cgti    $c_there,$t,-1                      # 15e
next_farthest_back:
        brnz    $count,next_farthest                    # 15o
next_farthest_drain:
        cgt     $c_greater,$t+2,$t_6                    # 0e
        rotqbyi $turned,$t_7,4                          # 0o
        selb    $t,$k_none,$t,$c_there                  # 1e
        hbr     mesh_farthest_r16_return,$lr            # 1o hint
        selb    $t_3,$t_6,$t+2,$c_greater               # 2e
        lnop                                            # 2o pairing
        ai      $a_bound_2,$a_bound,208                 # 3e
        shufb   $last,$last,$t,$m_word                  # 3o
        cgt     $c_greater,$turned,$t_7                 # 4e
        rotqbyi $turned_2,$t_3,8                        # 4o
        ai      $a_bound_3,$a_bound_2,208               # 5e
        selb    $t,$t_7,$turned,$c_greater              # 6e
        ai      $a_bound_4,$a_bound_3,208               # 7e
        stqd    $last,192($a_bound)                     # 7o
        cgt     $c_greater_6,$turned_2,$t_3             # 8e
        lqd     $last,192($a_bound_2)                   # 8o
        cgti    $c_there,$t,-1                          # 9e
        selb    $t_7,$t_3,$turned_2,$c_greater_6        # 10e
        selb    $t,$k_none,$t,$c_there                  # 11e
        rotqbyi $turned,$t_7,4                          # 12o
        shufb   $last,$last,$t,$m_word                  # 14o
        cgt     $c_greater,$turned,$t_7                 # 16e
        selb    $t,$t_7,$turned,$c_greater              # 18e
        stqd    $last,192($a_bound_2)                   # 18o
        lqd     $last,192($a_bound_3)                   # 19o
        cgti    $c_there,$t,-1                          # 20e
        selb    $t,$k_none,$t,$c_there                  # 22e
        shufb   $last,$last,$t,$m_word                  # 25o
        stqd    $last,192($a_bound_3)                   # 29o
mesh_farthest_r16_return:
        bi      $lr                                     # 30o
next_farthest_short:
        ai      $a_packet_4,$a_packet,320               # 0e
        lqd     $t,384($a_packet)                       # 0o
        ai      $count,$count,-1                        # 1e
        lqd     $t+1,400($a_packet)                     # 1o
        lqd     $t+2,416($a_packet)                     # 2o
        lqd     $t+3,432($a_packet)                     # 3o
        ai      $a_packet,$a_packet_4,320               # 4e
        lqd     $last,192($a_bound)                     # 4o
        cgt     $c_greater,$t+1,$t                      # 7e
        cgt     $c_greater_8,$t+3,$t+2                  # 9e
        selb    $t,$t,$t+1,$c_greater                   # 10e
        selb    $t+2,$t+2,$t+3,$c_greater_8             # 11e
        cgt     $c_greater,$t+2,$t                      # 13e
        selb    $t,$t,$t+2,$c_greater                   # 15e
        rotqbyi $turned,$t,8                            # 17o
        cgt     $c_greater,$turned,$t                   # 21e
        selb    $t,$t,$turned,$c_greater                # 23e
        rotqbyi $turned,$t,4                            # 25o
        cgt     $c_greater,$turned,$t                   # 29e
        selb    $t,$t,$turned,$c_greater                # 31e
        cgti    $c_there,$t,-1                          # 33e
        selb    $t,$k_none,$t,$c_there                  # 35e
        shufb   $last,$last,$t,$m_word                  # 37o
        stqd    $last,192($a_bound)                     # 41o
        ai      $a_bound,$a_bound,208                   # 42e
        brnz    $count,next_farthest_short              # 42o
        nop     $127                                    # 43e pairing
        bi      $lr                                     # 43o
endfunction mesh_farthest_r16
