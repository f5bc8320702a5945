# mesh_alive_r16   which of a batch's rays count farther than a distance
#   C       void mesh_alive_r16(const struct rays16 *, int count, float near, vec_uint4 *);
#   In      $3 RAYS16, one behind the other, $4 count, 1 to 8, $5 distance; below 0 it is 0, $6 a
#           bit for each ray, the first ray's first; pointers 16-aligned
#   Out     the bits of other rays, and of those that are not there, become 0
#   Uses    $2-$5, $7-$21, $79   Saves  -   Stack  0   Calls  -
#   Domain  t has a sign where no ray is
#   Error   0
#   Twin    lab/twins/src/mesh_rays.rs
# Scheduled by spu schedule from mesh_alive_r16.s

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
        .set m_bytes_2,2; .set count_2,79; .set a_packet_2,2; .set t_2,9; .set t2_2,12; .set t3_2,7
        .set t_3,8; .set t1_2,13; .set t2_3,16; .set t3_3,2; .set t_4,7; .set alive_2,20
        .set t_5,13; .set t2_4,14; .set t1_3,16; .set t_6,21; .set alive_3,2
        ila     $m_bytes_2,0x10203                      # 0e
        lqa     $m_bytes,last_bytes                     # 0o
        il      $k_zero,0                               # 1e
        lqa     $m_halves,first_halves                  # 1o
        shli    $bytes,$count,1                         # 2e
        shufb   $near,$near,$near,$m_bytes_2            # 2o
        clgti   $count_2,$count,3                       # 3e at least as many passes as overlap
        il      $alive,0                                # 4e
        fcgt    $c_greater,$k_zero,$near                # 6e
        sfi     $bytes,$bytes,16                        # 7e
        selb    $near,$near,$k_zero,$c_greater          # 8e
        brz     $count_2,next_packet_short              # 8o too few passes
        ai      $a_packet_2,$a_packet,320               # 9e
        lqd     $t_2,384($a_packet)                     # 9o
        ai      $count,$count,-1                        # 10e
        lqd     $t+1,400($a_packet)                     # 10o
        ai      $a_packet_2,$a_packet_2,320             # 11e
        lqd     $t2_2,416($a_packet)                    # 11o
        ai      $count,$count,-1                        # 12e
        lqd     $t3_2,432($a_packet)                    # 12o
        ai      $a_packet,$a_packet_2,320               # 13e
        hbrr    next_packet_back,next_packet            # 13o hint
        ai      $count,$count,-1                        # 14e
        lqd     $t_3,384($a_packet_2)                   # 14o
        fcgt    $t_2,$t_2,$near                         # 15e
        lqd     $t1_2,400($a_packet_2)                  # 15o
        fcgt    $t+1,$t+1,$near                         # 16e
        lqd     $t2_3,416($a_packet_2)                  # 16o
        fcgt    $t+2,$t2_2,$near                        # 17e
        lqd     $t3_3,432($a_packet_2)                  # 17o
        fcgt    $t+3,$t3_2,$near                        # 18e
        shufb   $t_4,$t_2,$t+1,$m_bytes                 # 18o
        ai      $a_packet,$a_packet,320                 # 19e
        shlqbyi $alive_2,$alive,2                       # 19o
        fcgt    $t_2,$t_3,$near                         # 20e
        shufb   $t+2,$t+2,$t+3,$m_bytes                 # 20o
        fcgt    $t+1,$t1_2,$near                        # 21e
        lqd     $t_5,384($a_packet)                     # 21o
        fcgt    $t2_4,$t2_3,$near                       # 22e
        lqd     $t1_3,400($a_packet)                    # 22o
        fcgt    $t+3,$t3_3,$near                        # 23e
        lqd     $t2_2,416($a_packet)                    # 23o
        ai      $a_packet_2,$a_packet,320               # 24e
        shufb   $t_6,$t_4,$t+2,$m_halves                # 24o
        nop     $127                                    # 25e pairing
        lqd     $t3_2,432($a_packet)                    # 25o
        ai      $a_packet,$a_packet_2,320               # 26e
        shufb   $t_3,$t_2,$t+1,$m_bytes                 # 26o
        fcgt    $t_2,$t_5,$near                         # 27e
        shufb   $t+2,$t2_4,$t+3,$m_bytes                # 27o
        fcgt    $t+1,$t1_3,$near                        # 28e
        gbb     $t_5,$t_6                               # 28o
next_packet:
        ai      $a_packet_2,$a_packet,320               # 0e
            shufb   $t,$t_3,$t+2,$m_halves              # 0o
            fcgt    $t+3,$t3_2,$near                    # 1e
            rotqbyi $t_4,$t_5,4                         # 1o to the last bytes
            fcgt    $t+2,$t2_2,$near                    # 2e
            shufb   $t_3,$t_2,$t+1,$m_bytes             # 2o
        ai      $count,$count,-1                        # 3e
        lqd     $t_2,384($a_packet)                     # 3o
        nop     $127                                    # 4e pairing
        lqd     $t+1,400($a_packet)                     # 4o
            or      $alive,$alive_2,$t_4                # 5e
        lqd     $t2_2,416($a_packet)                    # 5o
        nop     $127                                    # 6e pairing
        lqd     $t3_2,432($a_packet)                    # 6o
        ai      $a_packet,$a_packet_2,320               # 7e
            shufb   $t+2,$t+2,$t+3,$m_bytes             # 7o
            nop     $127                                # 8e pairing
            gbb     $t_5,$t                             # 8o
        fcgt    $t_2,$t_2,$near                         # 9e
            shlqbyi $alive_2,$alive,2                   # 9o
        fcgt    $t+1,$t+1,$near                         # 10e
next_packet_back:
        brnz    $count,next_packet                      # 10o
next_packet_drain:
        fcgt    $t+3,$t3_2,$near                        # 0e
        shufb   $t,$t_3,$t+2,$m_halves                  # 0o
        fcgt    $t+2,$t2_2,$near                        # 1e
        rotqbyi $t_4,$t_5,4                             # 1o to the last bytes
        shufb   $t_3,$t_2,$t+1,$m_bytes                 # 2o
        shufb   $t+2,$t+2,$t+3,$m_bytes                 # 3o
        nop     $127                                    # 4e pairing
        gbb     $t_5,$t                                 # 4o
        or      $alive,$alive_2,$t_4                    # 5e
        hbr     mesh_alive_r16_return,$lr               # 5o hint
        lqd     $old,0($a_bits)                         # 6o
        shufb   $t,$t_3,$t+2,$m_halves                  # 7o
        shlqbyi $alive_3,$alive,2                       # 8o
        rotqbyi $t_4,$t_5,4                             # 9o to the last bytes
        gbb     $t_5,$t                                 # 11o
        or      $alive,$alive_3,$t_4                    # 13e
        shlqbyi $alive_3,$alive,2                       # 15o
        rotqbyi $t_4,$t_5,4                             # 16o to the last bytes
        or      $alive,$alive_3,$t_4                    # 20e
        shlqby  $alive,$alive,$bytes                    # 22o
        and     $old,$old,$alive                        # 26e
        stqd    $old,0($a_bits)                         # 28o
        nop     $127                                    # 29e pairing
mesh_alive_r16_return:
        bi      $lr                                     # 29o
next_packet_short:
        ai      $a_packet_2,$a_packet,320               # 0e
        lqd     $t,384($a_packet)                       # 0o
        ai      $count,$count,-1                        # 1e
        lqd     $t+1,400($a_packet)                     # 1o
        lqd     $t+2,416($a_packet)                     # 2o
        lqd     $t+3,432($a_packet)                     # 3o
        ai      $a_packet,$a_packet_2,320               # 4e
        shlqbyi $alive,$alive,2                         # 4o
        fcgt    $t,$t,$near                             # 6e
        fcgt    $t+1,$t+1,$near                         # 7e
        fcgt    $t+2,$t+2,$near                         # 8e
        lnop                                            # 8o pairing
        fcgt    $t+3,$t+3,$near                         # 9e
        shufb   $t,$t,$t+1,$m_bytes                     # 9o
        shufb   $t+2,$t+2,$t+3,$m_bytes                 # 11o
        shufb   $t,$t,$t+2,$m_halves                    # 15o
        gbb     $t,$t                                   # 19o
        rotqbyi $t,$t,4                                 # 23o to the last bytes
        or      $alive,$alive,$t                        # 27e
        brnz    $count,next_packet_short                # 27o
        lqd     $old,0($a_bits)                         # 28o
        shlqby  $alive,$alive,$bytes                    # 29o
        and     $old,$old,$alive                        # 34e
        stqd    $old,0($a_bits)                         # 36o
        nop     $127                                    # 37e pairing
        bi      $lr                                     # 37o
endfunction mesh_alive_r16
