# mask_pairs_p16   which of a group's sixteen packets are in a list of pairs
#   C       unsigned mask_pairs_p16(const struct pair *, int count, const struct packet *);
#   In      $3 pairs, $4 count (0 is none), $5 the group's first packet; pointers 16-aligned
#   Out     $3 mask, 16 bits, the highest of packet 0
#   Uses    $3-$4, $10-$15   Saves  -   Stack  0   Calls  -
#   Domain  all packets are of the group
#   Error   0
#   Twin    oracle/src/twin/lists.rs
# Scheduled by spu schedule from mask_pairs_p16.s

        .include "work_unit.inc"
        .include "macros.inc"

        .set    a_pair,3
        .set    count,4
        .set    a_packets,5
        # constants
        .set    k_first,10
        .set    k_inverse,11
        # state
        .set    mask,12
        # the pair
        .set    number,13
        .set    bit,14

# A packet's number is its offset over PACKET_SIZE: so many quadwords, times one over them in 16 bits
# of fraction, rounded up, which is exact for so few.
        .set    QUADWORDS,PACKET_SIZE/16
        .set    INVERSE,(65536+QUADWORDS-1)/QUADWORDS

function mask_pairs_p16
        .set    count_2,79
        .set    a_pair_2,2
        .set    number_2,6
        .set    a_pair_3,7
        .set    number_3,2
        .set    number_4,7
        .set    number_5,8
        .set    bit_2,2
        il      $mask,0                                 # 0e
        brz     $count,none                             # 0o

        ilhu    $k_first,0                              # 1e
        clgti   $count_2,$count,3                       # 2e at least as many passes as overlap

        iohl    $k_first,0x8000                         # 3e
        lnop                                            # 3o pairing

        il      $k_inverse,0xccd                        # 4e
        brz     $count_2,next_pair_short                # 4o too few passes

        ai      $a_pair_2,$a_pair,16                    # 5e
        lqd     $number_2,0($a_pair)                    # 5o

        ai      $count,$count,-1                        # 6e
        hbrr    next_pair_back,next_pair                # 6o hint

        ai      $a_pair_3,$a_pair_2,16                  # 7e
        lqd     $number_3,0($a_pair_2)                  # 7o

        ai      $count,$count,-1                        # 8e
        lnop                                            # 8o pairing

        ai      $a_pair,$a_pair_3,16                    # 9e
        lqd     $number_4,0($a_pair_3)                  # 9o

        ai      $count,$count,-1                        # 10e
        rotqbyi $number_2,$number_2,4                   # 11o

        nop     $127                                    # 12e pairing
        rotqbyi $number_3,$number_3,4                   # 13o

        sf      $number_2,$a_packets,$number_2          # 15e
        rotqbyi $number_4,$number_4,4                   # 15o

        rotmi   $number_2,$number_2,-4                  # 17e quadwords
        sf      $number_3,$a_packets,$number_3          # 18e

        rotmi   $number_3,$number_3,-4                  # 20e quadwords
        mpyu    $number_2,$number_2,$k_inverse          # 21e

        mpyu    $number_5,$number_3,$k_inverse          # 24e
        rotmi   $number,$number_2,-16                   # 28e

next_pair:
            sfi     $number,$number,0                   # 0e
        lqd     $number_3,0($a_pair)                    # 0o

            sf      $number_2,$a_packets,$number_4      # 1e
        ai      $a_pair,$a_pair,16                      # 2e

            rotmi   $number_2,$number_2,-4              # 3e quadwords
            rotm    $bit,$k_first,$number               # 4e

            rotmi   $number,$number_5,-16               # 5e
            lnop                                        # 5o pairing

        ai      $count,$count,-1                        # 6e
        rotqbyi $number_4,$number_3,4                   # 6o

            mpyu    $number_5,$number_2,$k_inverse      # 7e
            lnop                                        # 7o pairing

            or      $mask,$mask,$bit                    # 8e
next_pair_back:
        brnz    $count,next_pair                        # 8o

next_pair_drain:
        sf      $number_2,$a_packets,$number_4          # 0e
        rotmi   $number_3,$number_5,-16                 # 1e

        rotmi   $number_2,$number_2,-4                  # 2e quadwords
        sfi     $number,$number,0                       # 3e

        rotm    $bit,$k_first,$number                   # 5e
        mpyu    $number_5,$number_2,$k_inverse          # 6e

        sfi     $number,$number_3,0                     # 7e
        rotm    $bit_2,$k_first,$number                 # 9e

        or      $mask,$mask,$bit                        # 10e
        rotmi   $number,$number_5,-16                   # 13e

        or      $mask,$mask,$bit_2                      # 14e
        sfi     $number,$number,0                       # 17e

        rotm    $bit,$k_first,$number                   # 19e
        or      $mask,$mask,$bit                        # 23e

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

        sfi     $number,$number,0                       # 27e
        rotm    $bit,$k_first,$number                   # 29e

        or      $mask,$mask,$bit                        # 33e
        brnz    $count,next_pair_short                  # 33o

        nop     $127                                    # 34e pairing
        br      none                                    # 34o
endfunction mask_pairs_p16
