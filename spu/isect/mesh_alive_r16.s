# mesh_alive_r16   which of a batch's rays count farther than a distance
#   C       void mesh_alive_r16(const struct rays16 *, int count, float near, vec_uint4 *);
#   In      $3 RAYS16, consecutive, $4 count, 1 to 8, $5 distance; below 0 it is 0, $6 a
#           bit for each ray, the first ray's first; pointers 16-aligned
#   Out     the bits of other rays, and of those that are not there, become 0
#   Uses    $3-$6, $10-$29   Saves  -   Stack  0   Calls  -
#   Domain  t has a sign where no ray is
#   Error   0
#   Twin    lab/twins/src/mesh_rays.rs

        .include "work_unit.inc"
        .include "macros.inc"
        .include "extremes.inc"

        .set    NEXT,3
        registers a_packet,count,near,a_bits
        .set    NEXT,10
        registers m_bytes,m_halves,k_zero,c_greater,alive,bytes
        registers t                                     # to 19
        .set    NEXT,t+4
        registers old

        .section .rodata.mesh,"a",@progbits
        .align  4
last_bytes:                                             # of eight words
        .int    0x03070b0f,0x13171b1f,0x80808080,0x80808080
first_halves:
        .int    0x00010203,0x04050607,0x10111213,0x14151617

function mesh_alive_r16
        splat_mask $m_bytes
        splat   $near,$near,$m_bytes
        il      $k_zero,0
        maximum $near,$k_zero,$c_greater
        lqa     $m_bytes,last_bytes
        lqa     $m_halves,first_halves
        il      $alive,0
        shli    $bytes,$count,1
        sfi     $bytes,$bytes,16
next_packet:
    .irp row, 0,1,2,3
        lqd     $t+\row,RAYS16_t+16*\row($a_packet)
        fcgt    $t+\row,$t+\row,$near
    .endr
        shufb   $t,$t,$t+1,$m_bytes
        shufb   $t+2,$t+2,$t+3,$m_bytes
        shufb   $t,$t,$t+2,$m_halves
        gbb     $t,$t
        rotqbyi $t,$t,4                                 # to the last bytes
        shlqbyi $alive,$alive,2
        or      $alive,$alive,$t
    .rept   2                                           # ai reaches to 511
        ai      $a_packet,$a_packet,RAYS16_SIZE/2
    .endr
        ai      $count,$count,-1
        brnz    $count,next_packet
        shlqby  $alive,$alive,$bytes
        lqd     $old,0($a_bits)
        and     $old,$old,$alive
        stqd    $old,0($a_bits)
        bi      $lr
endfunction mesh_alive_r16
