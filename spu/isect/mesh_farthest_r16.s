# mesh_farthest_r16   how far the rays of packets count, after hits
#   C       void mesh_farthest_r16(const struct rays16 *, int count, struct mesh_bound *);
#   In      $3 RAYS16, consecutive, $4 count (0 is none), $5 MESH_BOUNDs likewise; pointers
#           16-aligned
#   Out     the bounds' farthest: the largest t, or -1 if no ray is there
#   Uses    $3-$5, $10-$19   Saves  -   Stack  0   Calls  -
#   Domain  t has a sign where no ray is
#   Error   0
#   Twin    lab/twins/src/mesh.rs
#
# The loop counts up, so that it isn't pipelined. Pipelined it would take 16 cycles a packet instead
# of 43, but 568 bytes of local store instead of 136.

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
        biz     $count,$lr
        sfi     $count,$count,0
        ilhu    $k_none,0xbf80                          # -1
        lqa     $m_word,last_word_of_another
next_farthest:
    .irp row, 0,1,2,3
        lqd     $t+\row,RAYS16_t+16*\row($a_packet)
    .endr
        farther $t,$t+1
        farther $t+2,$t+3
        farther $t,$t+2
        rotqbyi $turned,$t,8
        farther $t,$turned
        rotqbyi $turned,$t,4
        farther $t,$turned
        cgti    $c_there,$t,-1
        selb    $t,$k_none,$t,$c_there
        lqd     $last,MESH_BOUND_farthest&~15($a_bound)
        shufb   $last,$last,$t,$m_word
        stqd    $last,MESH_BOUND_farthest&~15($a_bound)
    .rept   2                                           # ai reaches to 511
        ai      $a_packet,$a_packet,RAYS16_SIZE/2
    .endr
        ai      $a_bound,$a_bound,MESH_BOUND_SIZE
        ai      $count,$count,1
        brnz    $count,next_farthest
        bi      $lr
endfunction mesh_farthest_r16
