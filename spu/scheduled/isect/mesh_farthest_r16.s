# mesh_farthest_r16   how far the rays of packets count, after hits
#   C       void mesh_farthest_r16(const struct rays16 *, int count, struct mesh_bound *);
#   In      $3 RAYS16, one behind the other, $4 count (0 is none), $5 MESH_BOUNDs likewise; pointers
#           16-aligned
#   Out     the bounds' farthest: the largest t, or -1 if no ray is there
#   Uses    $2-$5, $10-$19   Saves  -   Stack  0   Calls  -
#   Domain  t has a sign where no ray is
#   Error   0
#   Twin    lab/twins/src/mesh.rs
#
# The loop counts up, so that it isn't pipelined. Pipelined it would take 16 cycles a packet instead
# of 43, but 568 bytes of local store instead of 136.
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

        .section .rodata.mesh,"a",@progbits
        .align  4
last_word_of_another:
        .int    0x00010203,0x04050607,0x08090a0b,0x1c1d1e1f

.macro  farther a:req, b:req
        cgt     $c_greater,\b,\a
        selb    \a,\a,\b,$c_greater
.endm

function mesh_farthest_r16
        .set a_packet_2,2; .set c_greater_2,2
        nop     $127                                    # 0e pairing
        biz     $count,$lr                              # 0o
        sfi     $count,$count,0                         # 1e
        hbrr    next_farthest_back,next_farthest        # 1o hint
        ilhu    $k_none,0xbf80                          # 2e -1
        lqa     $m_word,last_word_of_another            # 2o
next_farthest:
        ai      $a_packet_2,$a_packet,320               # 0e
        lqd     $t,384($a_packet)                       # 0o
        ai      $count,$count,1                         # 1e
        lqd     $t+1,400($a_packet)                     # 1o
        lqd     $t+2,416($a_packet)                     # 2o
        lqd     $t+3,432($a_packet)                     # 3o
        ai      $a_packet,$a_packet_2,320               # 4e
        lqd     $last,192($a_bound)                     # 4o
        cgt     $c_greater,$t+1,$t                      # 7e
        cgt     $c_greater_2,$t+3,$t+2                  # 9e
        selb    $t,$t,$t+1,$c_greater                   # 10e
        selb    $t+2,$t+2,$t+3,$c_greater_2             # 11e
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
next_farthest_back:
        brnz    $count,next_farthest                    # 42o
        nop     $127                                    # 43e pairing
        bi      $lr                                     # 43o
endfunction mesh_farthest_r16
