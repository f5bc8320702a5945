# mask_pairs_p64   which of a tile's packets are in a list of pairs
#   C       vec_uint4 mask_pairs_p64(const struct pair *, int count, const struct packet *);
#   In      $3 pairs, $4 count (0 is none), $5 the tile's first packet; pointers 16-aligned
#   Out     $3 a mask for each sixteen packets: 16 bits, the highest of the first
#   Uses    $3-$4, $10-$17   Saves  -   Stack  0   Calls  -
#   Domain  all packets are of the tile, which has at most 64
#   Error   0
#   Twin    lab/twins/src/lists.rs

        .include "work_unit.inc"
        .include "macros.inc"

        .set    NEXT,3
        registers a_pair,count,a_packets
        # constants
        .set    NEXT,10
        registers k_first,k_inverse,k_groups,m_splat
        # state
        registers mask
        # the pair
        registers number,bit

# A packet's number is its offset divided by PACKET_SIZE. It is computed as the number of quadwords
# times the reciprocal of QUADWORDS with 16 bits of fraction, rounded up, which is exact for so few
# packets.
        .set    QUADWORDS,PACKET_SIZE/16
        .set    INVERSE,(65536+QUADWORDS-1)/QUADWORDS

        .section .rodata
        .align  4
groups: .int    0,16,32,48

function mask_pairs_p64
        il      $mask,0
        brz     $count,none
        ilhu    $k_first,0
        iohl    $k_first,0x8000
        il      $k_inverse,INVERSE
        lqa     $k_groups,groups
        splat_mask $m_splat
next_pair:
        lqd     $number,0($a_pair)
        rotqbyi $number,$number,PAIR_packet
        sf      $number,$a_packets,$number
        rotmi   $number,$number,-4                      # quadwords
        mpyu    $number,$number,$k_inverse
        rotmi   $number,$number,-16
        splat   $number,$number,$m_splat
        sf      $number,$number,$k_groups
        rotm    $bit,$k_first,$number                   # 0 in the lanes of other groups
        or      $mask,$mask,$bit
        ai      $a_pair,$a_pair,PAIR_SIZE
        ai      $count,$count,-1
        brnz    $count,next_pair
none:   ori     $3,$mask,0
        bi      $lr
endfunction mask_pairs_p64
