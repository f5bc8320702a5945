# load_rays_r16   rays that wait, brought into packets, nothing hit yet
#   C       void load_rays_r16(const struct queued *, int rays, struct rays16 *,
#                              unsigned background, unsigned sum);
#   In      $3 QUEUED rays, $4 how many (at least 1), $5 packets, $6 address of the background's
#           OBJECT, $7 address of a sum that nobody reads; pointers 16-aligned
#   Out     RAYS16, consecutive, as many as the rays fill
#   Uses    $3-$7, $10-$35   Saves  -   Stack  0   Calls  -
#   Domain  any; the queue is read up to the last packet's end
#   Error   0
#   Twin    lab/twins/src/load_rays.rs
#
# After the last ray, absent rays fill the packet: t is -1, the weight is 0, and the pixel's sum is
# one that is never read. Their origins and directions are whatever follows the queue.

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
        splat_mask $m_splat
        splat   $left,$rows,$m_splat
        splat   $background,$background,$m_splat
        splat   $dummy,$dummy,$m_splat
        lqa     $m_first,transpose_first
        lqa     $m_last,transpose_last
        ilhu    $k_far,FARTHEST>>16
        ilhu    $k_absent,0xbf80
        lqa     $k_lanes,lanes
        il      $k_further,RAYS16_SIZE-64
        ai      $rows,$rows,15
        andi    $rows,$rows,-16
        rotmi   $rows,$rows,-2
next_row:
    .irp ray, 0,1,2,3
        lqd     $origin+\ray,QUEUED_SIZE*\ray+QUEUED_origin($a_queue)
        lqd     $direction+\ray,QUEUED_SIZE*\ray+QUEUED_direction($a_queue)
    .endr
        transpose origin,origin,t_words,$m_first,$m_last
        transpose direction,direction,t_words,$m_first,$m_last
        cgt     $c_there,$left,$k_lanes
        selb    $t,$k_absent,$k_far,$c_there
        and     $origin+3,$origin+3,$c_there
        selb    $direction+3,$dummy,$direction+3,$c_there
        stqd    $origin,RAYS16_origin_x($a_row)
        stqd    $origin+1,RAYS16_origin_y($a_row)
        stqd    $origin+2,RAYS16_origin_z($a_row)
        stqd    $origin+3,RAYS16_weight($a_row)
        stqd    $direction,RAYS16_direction_x($a_row)
        stqd    $direction+1,RAYS16_direction_y($a_row)
        stqd    $direction+2,RAYS16_direction_z($a_row)
        stqd    $direction+3,RAYS16_pixel($a_row)
        stqd    $t,RAYS16_t($a_row)
        stqd    $background,RAYS16_object($a_row)
        # Behind the last row of a packet, the next packet.
        andi    $c_last,$rows,3
        ceqi    $c_last,$c_last,1
        and     $c_last,$c_last,$k_further
        a       $a_row,$a_row,$c_last
        ai      $a_row,$a_row,16
        ai      $a_queue,$a_queue,QUEUED_SIZE*4
        ai      $left,$left,-4
        ai      $rows,$rows,-1
        brnz    $rows,next_row
        bi      $lr
endfunction load_rays_r16
