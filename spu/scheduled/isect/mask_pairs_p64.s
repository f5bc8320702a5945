# mask_pairs_p64   which of a tile's packets are in a list of pairs
#   C       vec_uint4 mask_pairs_p64(const struct pair *, int count, const struct packet *);
#   In      $3 pairs, $4 count (0 is none), $5 the tile's first packet; pointers 16-aligned
#   Out     $3 a mask for each sixteen packets: 16 bits, the highest of the first
#   Uses    $2-$4, $6-$16, $79   Saves  -   Stack  0   Calls  -
#   Domain  all packets are of the tile, which has at most 64
#   Error   0
#   Twin    lab/twins/src/lists.rs
# Scheduled by spu schedule from mask_pairs_p64.s

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
        .set count_2,79; .set a_pair_2,2; .set number_2,2; .set a_pair_3,6; .set number_3,7
        .set number_4,8; .set number_5,6; .set number_6,9; .set number_7,3; .set bit_2,2
        il      $mask,0                                 # 0e
        brz     $count,none                             # 0o
        ilhu    $k_first,0                              # 1e
        lqa     $k_groups,groups                        # 1o
        clgti   $count_2,$count,4                       # 2e at least as many passes as overlap
        iohl    $k_first,0x8000                         # 3e
        il      $k_inverse,0xccd                        # 4e
        lnop                                            # 4o pairing
        ila     $m_splat,0x10203                        # 5e
        brz     $count_2,next_pair_short                # 5o too few passes
        ai      $a_pair_2,$a_pair,16                    # 6e
        lqd     $number,0($a_pair)                      # 6o
        ai      $count,$count,-1                        # 7e
        hbrr    next_pair_back,next_pair                # 7o hint
        ai      $a_pair,$a_pair_2,16                    # 8e
        lqd     $number_2,0($a_pair_2)                  # 8o
        ai      $count,$count,-1                        # 9e
        lnop                                            # 9o pairing
        ai      $a_pair_3,$a_pair,16                    # 10e
        lqd     $number_3,0($a_pair)                    # 10o
        ai      $count,$count,-1                        # 11e
        lnop                                            # 11o pairing
        ai      $a_pair,$a_pair_3,16                    # 12e
        rotqbyi $number_4,$number,4                     # 12o
        ai      $count,$count,-1                        # 13e
        lqd     $number,0($a_pair_3)                    # 13o
        nop     $127                                    # 14e pairing
        rotqbyi $number_2,$number_2,4                   # 14o
        sf      $number_5,$a_packets,$number_4          # 16e
        rotqbyi $number_3,$number_3,4                   # 16o
        rotmi   $number_5,$number_5,-4                  # 18e quadwords
        lnop                                            # 18o pairing
        sf      $number_2,$a_packets,$number_2          # 19e
        rotqbyi $number_4,$number,4                     # 19o
        sf      $number_3,$a_packets,$number_3          # 20e
        rotmi   $number_2,$number_2,-4                  # 21e quadwords
        mpyu    $number_5,$number_5,$k_inverse          # 22e
        rotmi   $number_3,$number_3,-4                  # 23e quadwords
        mpyu    $number_2,$number_2,$k_inverse          # 25e
        mpyu    $number_6,$number_3,$k_inverse          # 27e
        rotmi   $number_5,$number_5,-16                 # 29e
        rotmi   $number_3,$number_2,-16                 # 32e
        shufb   $number_2,$number_5,$number_5,$m_splat  # 33o
        sf      $number_2,$number_2,$k_groups           # 37e
        rotm    $bit,$k_first,$number_2                 # 39e 0 in the lanes of other groups
        lnop                                            # 39o pairing
next_pair:
        ai      $count,$count,-1                        # 0e
        lqd     $number,0($a_pair)                      # 0o
        ai      $a_pair,$a_pair,16                      # 1e
            shufb   $number_2,$number_3,$number_3,$m_splat # 1o
            sf      $number_5,$a_packets,$number_4      # 2e
            or      $mask,$mask,$bit                    # 3e
            rotmi   $number_5,$number_5,-4              # 4e quadwords
            sf      $number_2,$number_2,$k_groups       # 5e
            rotmi   $number_3,$number_6,-16             # 6e
        rotqbyi $number_4,$number,4                     # 6o
            rotm    $bit,$k_first,$number_2             # 7e 0 in the lanes of other groups
            lnop                                        # 7o pairing
            mpyu    $number_6,$number_5,$k_inverse      # 8e
next_pair_back:
        brnz    $count,next_pair                        # 8o
next_pair_drain:
        sf      $number_5,$a_packets,$number_4          # 0e
        shufb   $number_2,$number_3,$number_3,$m_splat  # 0o
        rotmi   $number_3,$number_6,-16                 # 1e
        rotmi   $number_5,$number_5,-4                  # 2e quadwords
        or      $mask,$mask,$bit                        # 3e
        sf      $number_2,$number_2,$k_groups           # 4e
        shufb   $number_7,$number_3,$number_3,$m_splat  # 5o
        mpyu    $number_6,$number_5,$k_inverse          # 6e
        rotm    $bit,$k_first,$number_2                 # 7e 0 in the lanes of other groups
        sf      $number_2,$number_7,$k_groups           # 9e
        rotm    $bit_2,$k_first,$number_2               # 11e 0 in the lanes of other groups
        or      $mask,$mask,$bit                        # 12e
        rotmi   $number_3,$number_6,-16                 # 13e
        or      $mask,$mask,$bit_2                      # 15e
        shufb   $number_2,$number_3,$number_3,$m_splat  # 17o
        sf      $number_2,$number_2,$k_groups           # 21e
        rotm    $bit,$k_first,$number_2                 # 23e 0 in the lanes of other groups
        or      $mask,$mask,$bit                        # 27e
none:
        ori     $a_pair,$mask,0                         # 0e
        bi      $lr                                     # 0o
next_pair_short:
        ai      $count,$count,-1                        # 0e
        lqd     $number,0($a_pair)                      # 0o
        ai      $a_pair,$a_pair,16                      # 1e
        rotqbyi $number,$number,4                       # 6o
        sf      $number,$a_packets,$number              # 10e
        rotmi   $number,$number,-4                      # 12e quadwords
        mpyu    $number,$number,$k_inverse              # 16e
        rotmi   $number,$number,-16                     # 23e
        shufb   $number,$number,$number,$m_splat        # 27o
        sf      $number,$number,$k_groups               # 31e
        rotm    $bit,$k_first,$number                   # 33e 0 in the lanes of other groups
        lnop                                            # 33o pairing
        or      $mask,$mask,$bit                        # 37e
        brnz    $count,next_pair_short                  # 37o
        nop     $127                                    # 38e pairing
        br      none                                    # 38o
endfunction mask_pairs_p64
