# load_rays_r16   rays that wait, brought into packets, nothing hit yet
#   C       void load_rays_r16(const struct queued *, int rays, struct rays16 *,
#                              unsigned background, unsigned sum);
#   In      $3 QUEUED rays, $4 how many (at least 1), $5 packets, $6 address of the background's
#           OBJECT, $7 address of a sum that nobody reads; pointers 16-aligned
#   Out     RAYS16, one behind the other, as many as the rays fill
#   Uses    $2-$17, $20-$35   Saves  -   Stack  0   Calls  -
#   Domain  any; the queue is read up to the last packet's end
#   Error   0
#   Twin    lab/twins/src/load_rays.rs
#
# After the last ray, absent rays fill the packet: t is -1, the weight is 0, and the pixel's sum is
# one that is never read. Their origins and directions are whatever follows the queue.
# Scheduled by spu schedule from load_rays_r16.s

        .include "work_unit.inc"
        .include "macros.inc"
        .include "transpose.inc"

        .set    NEXT,3
        registers a_queue
        registers rows                                  # rays, then rows left
        registers a_row                                 # rows of the packet
        registers background
        registers dummy                                 # the sum that is never read
        # constants
        .set    NEXT,10
        registers m_first,m_last,m_splat,k_far,k_absent,k_lanes,k_further
        # state
        .set    NEXT,20
        registers left                                  # rays from this row's first on
        # the row
        registers origin                                # to 24: rays, then x, y, z, weight
        .set    direction,25                            # to 28: rays, then x, y, z, pixel
        .set    t_words,29                              # to 32
        .set    NEXT,33
        registers c_there,t,c_last

        transpose_table
lanes:  .int    0,1,2,3

function load_rays_r16
        .set rows_2,2; .set a_row_2,2; .set t_words2_2,8; .set t_words3_2,9; .set t_words_2,12
        .set t_words1_2,17
        ai      $rows_2,$rows,15                        # 0e
        hbrr    next_row_back,next_row                  # 0o hint
        ila     $m_splat,0x10203                        # 1e
        lqa     $m_first,transpose_first                # 1o
        andi    $rows_2,$rows_2,-16                     # 2e
        lqa     $m_last,transpose_last                  # 2o
        ilhu    $k_far,0x5e80                           # 3e
        lqa     $k_lanes,lanes                          # 3o
        ilhu    $k_absent,0xbf80                        # 4e
        shufb   $left,$rows,$rows,$m_splat              # 4o
        rotmi   $rows,$rows_2,-2                        # 5e
        shufb   $background,$background,$background,$m_splat # 5o
        il      $k_further,576                          # 6e
        shufb   $dummy,$dummy,$dummy,$m_splat           # 6o
next_row:
        andi    $c_last,$rows,3                         # 0e
        lqd     $origin,0($a_queue)                     # 0o
        cgt     $c_there,$left,$k_lanes                 # 1e
        lqd     $direction,16($a_queue)                 # 1o
        ceqi    $c_last,$c_last,1                       # 2e
        lqd     $origin+1,32($a_queue)                  # 2o
        selb    $t,$k_absent,$k_far,$c_there            # 3e
        lqd     $direction+1,48($a_queue)               # 3o
        and     $c_last,$c_last,$k_further              # 4e
        lqd     $origin+2,64($a_queue)                  # 4o
        ai      $rows,$rows,-1                          # 5e
        lqd     $direction+2,80($a_queue)               # 5o
        a       $a_row_2,$a_row,$c_last                 # 6e
        lqd     $origin+3,96($a_queue)                  # 6o
        ai      $left,$left,-4                          # 7e
        lqd     $direction+3,112($a_queue)              # 7o
        ai      $a_queue,$a_queue,128                   # 8e
        stqd    $t,384($a_row)                          # 8o
        stqd    $background,448($a_row)                 # 9o
        shufb   $t_words+2,$origin,$origin+2,$m_last    # 10o
        shufb   $t_words2_2,$direction,$direction+2,$m_last # 11o
        shufb   $t_words+3,$origin+1,$origin+3,$m_last  # 12o
        shufb   $t_words3_2,$direction+1,$direction+3,$m_last # 13o
        shufb   $t_words,$origin,$origin+2,$m_first     # 14o
        shufb   $t_words+1,$origin+1,$origin+3,$m_first # 15o
        shufb   $t_words_2,$direction,$direction+2,$m_first # 16o
        shufb   $t_words1_2,$direction+1,$direction+3,$m_first # 17o
        shufb   $origin+3,$t_words+2,$t_words+3,$m_last # 18o
        shufb   $direction+3,$t_words2_2,$t_words3_2,$m_last # 19o
        shufb   $origin,$t_words,$t_words+1,$m_first    # 20o
        nop     $127                                    # 21e pairing
        shufb   $origin+1,$t_words,$t_words+1,$m_last   # 21o
        and     $origin+3,$origin+3,$c_there            # 22e
        shufb   $origin+2,$t_words+2,$t_words+3,$m_first # 22o
        selb    $direction+3,$dummy,$direction+3,$c_there # 23e
        shufb   $direction,$t_words_2,$t_words1_2,$m_first # 23o
        shufb   $direction+1,$t_words_2,$t_words1_2,$m_last # 24o
        shufb   $direction+2,$t_words2_2,$t_words3_2,$m_first # 25o
        stqd    $origin,0($a_row)                       # 26o
        stqd    $origin+1,64($a_row)                    # 27o
        stqd    $origin+2,128($a_row)                   # 28o
        stqd    $origin+3,512($a_row)                   # 29o
        stqd    $direction,192($a_row)                  # 30o
        stqd    $direction+1,256($a_row)                # 31o
        stqd    $direction+2,320($a_row)                # 32o
        stqd    $direction+3,576($a_row)                # 33o
        ai      $a_row,$a_row_2,16                      # 34e
next_row_back:
        brnz    $rows,next_row                          # 34o
        nop     $127                                    # 35e pairing
        bi      $lr                                     # 35o
endfunction load_rays_r16
