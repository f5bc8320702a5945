# mesh_list_hits_r16   gives each triangle of a mesh that packets have hit a patch
#   C       struct patch *mesh_list_hits_r16(struct rays16 *, int count, struct patch *,
#                                            vec_uint4 *none);
#   In      $3 RAYS16, one behind the other, $4 count (0 is none), $5 the first patch, $6 a
#           quadword that gets anything; pointers 16-aligned
#   Out     the packets' objects: for triangles of a mesh, their patches; others stay as they are
#           the patches' first quadwords: in all words, the object that was there
#           $3 behind the last patch
#   Uses    $2-$48   Saves  -   Stack  0   Calls  -
#   Domain  any objects
#   Error   0
#   Twin    lab/twins/src/mesh_patches.rs
#
# The loop counts up, so that it isn't pipelined. Pipelined it would take 86 cycles a packet
# instead of 134, but 2.8 KB of local store instead of 0.8.
#
# A ray gets the patch of its neighbour to the left or above, if they have hit the same triangle.
# So a packet may have several patches of a triangle, but only one if all rays have hit it.
# Scheduled by spu schedule from mesh_list_hits_r16.s

        .include "work_unit.inc"
        .include "macros.inc"

        .set    NEXT,3
        registers a_rays,count,a_patch,a_none
        # constants
        .set    NEXT,10
        registers k_size,m_splat,m_last
        registers m_lane                                # to 16
        .set    NEXT,m_lane+4
        # state
        registers a_packet
        registers next_patch                            # in all lanes
        # rows
        registers object,others,row_before,left,c_left,c_above,c_other,first,to_here,more
        registers patch,patch_above,scattered,a_lane,lane
        registers t_shift

function mesh_list_hits_r16
        .set a_packet_2,2; .set object_2,3; .set object_3,5; .set object_4,7; .set left_2,8
        .set c_other_2,9; .set left_3,11; .set left_4,20; .set c_left_2,8; .set lane_2,21
        .set lane_3,22; .set first_2,27; .set lane_4,28; .set lane_5,29; .set lane_6,30
        .set row_before_2,31; .set lane_7,32; .set c_left_3,11; .set lane_8,35; .set c_other_3,36
        .set t_shift_2,37; .set to_here_2,34; .set lane_9,38; .set first_3,39; .set lane_10,40
        .set c_above_2,31; .set t_shift_3,41; .set to_here_3,37; .set lane_11,42; .set lane_12,43
        .set row_before_3,44; .set t_shift_4,45; .set lane_13,41; .set lane_14,46
        .set to_here_4,26; .set more_2,34; .set patch_2,26; .set lane_15,47; .set more_3,37
        .set patch_3,19; .set lane_16,26; .set patch_4,27; .set c_left_4,20; .set c_other_4,45
        .set first_4,48; .set to_here_5,39; .set c_above_3,44; .set patch_5,37; .set t_shift_5,48
        .set first_5,34; .set row_before_4,39; .set t_shift_6,23; .set patch_above_2,39
        .set scattered_2,19; .set patch_6,24; .set a_lane_2,23; .set patch_7,3; .set a_lane_3,24
        .set t_shift_7,25; .set t_shift_8,39; .set a_lane_4,48; .set a_lane_5,19; .set to_here_6,21
        .set patch_8,21; .set patch_above_3,8; .set scattered_3,3; .set patch_9,8; .set a_lane_6,9
        .set patch_10,5; .set a_lane_7,8; .set a_lane_8,3; .set a_lane_9,5; .set a_lane_10,7
        .set a_lane_11,2
        ori     $a_packet,$a_rays,0                     # 0e
        lnop                                            # 0o pairing
        ori     $a_rays,$a_patch,0                      # 1e
        biz     $count,$lr                              # 1o
        ila     $m_splat,0x10203                        # 2e
        ilhu    $m_last,0xc0d                           # 3e
        ilhu    $m_lane,1                               # 4e
        shufb   $a_none,$a_none,$a_none,$m_splat        # 4o
        ilhu    $m_lane+1,0x405                         # 5e
        shufb   $next_patch,$a_patch,$a_patch,$m_splat  # 5o
        ilhu    $m_lane+2,0x809                         # 6e
        ilhu    $m_lane+3,0xc0d                         # 7e
        sfi     $count,$count,0                         # 8e
        il      $k_size,144                             # 9e
        iohl    $m_last,0xe0f                           # 10e
        iohl    $m_lane,515                             # 11e
        iohl    $m_lane+1,0x607                         # 12e
        iohl    $m_lane+2,0xa0b                         # 13e
        iohl    $m_lane+3,0xe0f                         # 14e
        lnop                                            # 14o pairing
next_packet:
        ai      $a_packet_2,$a_packet,320               # 0e
        lqd     $object,448($a_packet)                  # 0o
        ai      $count,$count,1                         # 1e
        lqd     $object_2,464($a_packet)                # 1o
        lqd     $object_3,480($a_packet)                # 2o
        lqd     $object_4,496($a_packet)                # 3o
        cgti    $c_other,$object,-1                     # 6e
        rotqmbyi $left,$object,-4                       # 6o
        ori     $row_before,$object,0                   # 7e
        rotqmbyi $left_2,$object_2,-4                   # 7o
        cgti    $c_other_2,$object_2,-1                 # 8e
        rotqmbyi $left_3,$object_3,-4                   # 8o
        ceq     $c_above,$object_2,$row_before          # 9e
        rotqmbyi $left_4,$object_4,-4                   # 9o
        ceq     $c_left,$object,$left                   # 10e
        shufb   $lane,$object,$object,$m_lane           # 10o
        ceq     $c_left_2,$object_2,$left_2             # 11e
        shufb   $lane_2,$object,$object,$m_lane+1       # 11o
        or      $first,$c_left,$c_other                 # 12e
        shufb   $lane_3,$object,$object,$m_lane+2       # 12o
        or      $first_2,$c_left_2,$c_other_2           # 13e
        shufb   $lane_4,$object,$object,$m_lane+3       # 13o
        andc    $first,$k_size,$first                   # 14e a patch for each ray with a new
        shufb   $lane_5,$object_2,$object_2,$m_lane     # 14o
        or      $first_2,$first_2,$c_above              # 15e
        shufb   $lane_6,$object_2,$object_2,$m_lane+1   # 15o
        ori     $row_before_2,$object_2,0               # 16e
        rotqmbyi $t_shift,$first,-4                     # 16o
        andc    $first_2,$k_size,$first_2               # 17e a patch for each ray with a new
        shufb   $lane_7,$object_2,$object_2,$m_lane+2   # 17o
        ceq     $c_left_3,$object_3,$left_3             # 18e
        shufb   $lane_8,$object_2,$object_2,$m_lane+3   # 18o
        cgti    $c_other_3,$object_3,-1                 # 19e
        rotqmbyi $t_shift_2,$first_2,-4                 # 19o
        a       $to_here_2,$first,$t_shift              # 20e
        shufb   $lane_9,$object_3,$object_3,$m_lane     # 20o
        or      $first_3,$c_left_3,$c_other_3           # 21e
        shufb   $lane_10,$object_3,$object_3,$m_lane+1  # 21o
        ceq     $c_above_2,$object_3,$row_before_2      # 22e
        rotqmbyi $t_shift_3,$to_here_2,-8               # 22o
        a       $to_here_3,$first_2,$t_shift_2          # 23e
        shufb   $lane_11,$object_3,$object_3,$m_lane+2  # 23o
        or      $first_3,$first_3,$c_above_2            # 24e
        shufb   $lane_12,$object_3,$object_3,$m_lane+3  # 24o
        ori     $row_before_3,$object_3,0               # 25e
        rotqmbyi $t_shift_4,$to_here_3,-8               # 25o
        a       $to_here_2,$to_here_2,$t_shift_3        # 26e
        shufb   $lane_13,$object_4,$object_4,$m_lane    # 26o
        andc    $first_3,$k_size,$first_3               # 27e a patch for each ray with a new
        shufb   $lane_14,$object_4,$object_4,$m_lane+1  # 27o
        sf      $to_here_4,$first,$to_here_2            # 28e
        shufb   $more_2,$to_here_2,$to_here_2,$m_last   # 28o
        a       $to_here_3,$to_here_3,$t_shift_4        # 29e
        rotqmbyi $t_shift_4,$first_3,-4                 # 29o
        a       $patch_2,$next_patch,$to_here_4         # 30e
        shufb   $lane_15,$object_4,$object_4,$m_lane+2  # 30o
        sf      $to_here,$first_2,$to_here_3            # 31e
        shufb   $more_3,$to_here_3,$to_here_3,$m_last   # 31o
        selb    $patch_3,$patch_2,$object,$c_other      # 32e
        shufb   $lane_16,$object_4,$object_4,$m_lane+3  # 32o
        a       $next_patch,$next_patch,$more_2         # 33e
        lnop                                            # 33o pairing
        a       $to_here_2,$first_3,$t_shift_4          # 34e
        rotqmbyi $t_shift_4,$patch_3,-4                 # 34o
        a       $patch_4,$next_patch,$to_here           # 35e
        lnop                                            # 35o pairing
        a       $next_patch,$next_patch,$more_3         # 36e
        rotqmbyi $t_shift_2,$to_here_2,-8               # 36o
        ceq     $c_left_4,$object_4,$left_4             # 37e
        selb    $patch_3,$patch_3,$t_shift_4,$c_left    # 38e
        cgti    $c_other_4,$object_4,-1                 # 39e
        lnop                                            # 39o pairing
        a       $to_here_2,$to_here_2,$t_shift_2        # 40e
        rotqmbyi $t_shift_2,$patch_3,-4                 # 40o
        or      $first_4,$c_left_4,$c_other_4           # 41e
        lnop                                            # 41o pairing
        sf      $to_here_5,$first_3,$to_here_2          # 42e
        shufb   $more_2,$to_here_2,$to_here_2,$m_last   # 42o
        ceq     $c_above_3,$object_4,$row_before_3      # 43e
        selb    $patch_3,$patch_3,$t_shift_2,$c_left    # 44e
        a       $patch_5,$next_patch,$to_here_5         # 45e
        lnop                                            # 45o pairing
        or      $first_3,$first_4,$c_above_3            # 46e
        rotqmbyi $t_shift_5,$patch_3,-4                 # 46o
        a       $next_patch,$next_patch,$more_2         # 47e
        andc    $first_5,$k_size,$first_3               # 48e a patch for each ray with a new
        ori     $row_before_4,$object_4,0               # 49e
        lnop                                            # 49o pairing
        selb    $patch_3,$patch_3,$t_shift_5,$c_left    # 50e
        rotqmbyi $t_shift_6,$first_5,-4                 # 50o
        ori     $patch_above_2,$patch_3,0               # 52e
        stqd    $patch_3,448($a_packet)                 # 52o
        selb    $scattered_2,$patch_3,$a_none,$c_other  # 53e
        selb    $patch_6,$patch_4,$patch_above_2,$c_above # 54e
        a       $to_here,$first_5,$t_shift_6            # 55e
        rotqbyi $a_lane_2,$scattered_2,0                # 55o
        selb    $patch_7,$patch_6,$object_2,$c_other_2  # 56e
        rotqbyi $a_lane_3,$scattered_2,4                # 56o
        rotqmbyi $t_shift_7,$to_here,-8                 # 57o
        rotqmbyi $t_shift_8,$patch_7,-4                 # 58o
        rotqbyi $a_lane_4,$scattered_2,8                # 59o
        rotqbyi $a_lane_5,$scattered_2,12               # 60o
        a       $to_here,$to_here,$t_shift_7            # 61e
        stqd    $lane,0($a_lane_2)                      # 61o
        selb    $patch_7,$patch_7,$t_shift_8,$c_left_2  # 62e
        stqd    $lane_2,0($a_lane_3)                    # 62o
        sf      $to_here_6,$first_5,$to_here            # 63e
        stqd    $lane_3,0($a_lane_4)                    # 63o
        nop     $127                                    # 64e pairing
        rotqmbyi $t_shift,$patch_7,-4                   # 64o
        a       $patch_8,$next_patch,$to_here_6         # 65e
        stqd    $lane_4,0($a_lane_5)                    # 65o
        shufb   $more,$to_here,$to_here,$m_last         # 66o
        selb    $patch_7,$patch_7,$t_shift,$c_left_2    # 68e
        a       $next_patch,$next_patch,$more           # 70e
        rotqmbyi $t_shift,$patch_7,-4                   # 70o
        selb    $patch_7,$patch_7,$t_shift,$c_left_2    # 74e
        lnop                                            # 74o pairing
        ori     $patch_above_3,$patch_7,0               # 76e
        stqd    $patch_7,464($a_packet)                 # 76o
        selb    $scattered_3,$patch_7,$a_none,$c_other_2 # 77e
        selb    $patch_9,$patch_5,$patch_above_3,$c_above_2 # 78e
        nop     $127                                    # 79e pairing
        rotqbyi $a_lane_6,$scattered_3,0                # 79o
        selb    $patch_10,$patch_9,$object_3,$c_other_3 # 80e
        rotqbyi $a_lane_7,$scattered_3,4                # 80o
        rotqbyi $a_lane_5,$scattered_3,8                # 81o
        rotqmbyi $t_shift,$patch_10,-4                  # 82o
        rotqbyi $a_lane_8,$scattered_3,12               # 83o
        stqd    $lane_5,0($a_lane_6)                    # 84o
        nop     $127                                    # 85e pairing
        stqd    $lane_6,0($a_lane_7)                    # 85o
        selb    $patch,$patch_10,$t_shift,$c_left_3     # 86e
        stqd    $lane_7,0($a_lane_5)                    # 86o
        stqd    $lane_8,0($a_lane_8)                    # 87o
        rotqmbyi $t_shift,$patch,-4                     # 88o
        hbrr    next_packet_back,next_packet            # 89o hint
        selb    $patch,$patch,$t_shift,$c_left_3        # 92e
        rotqmbyi $t_shift,$patch,-4                     # 94o
        selb    $patch,$patch,$t_shift,$c_left_3        # 98e
        ori     $patch_above,$patch,0                   # 100e
        stqd    $patch,480($a_packet)                   # 100o
        selb    $scattered,$patch,$a_none,$c_other_3    # 101e
        selb    $patch,$patch_8,$patch_above,$c_above_3 # 102e
        nop     $127                                    # 103e pairing
        rotqbyi $a_lane,$scattered,0                    # 103o
        selb    $patch,$patch,$object_4,$c_other_4      # 104e
        rotqbyi $a_lane_8,$scattered,4                  # 104o
        rotqbyi $a_lane_9,$scattered,8                  # 105o
        rotqmbyi $t_shift,$patch,-4                     # 106o
        rotqbyi $a_lane_10,$scattered,12                # 107o
        stqd    $lane_9,0($a_lane)                      # 108o
        nop     $127                                    # 109e pairing
        stqd    $lane_10,0($a_lane_8)                   # 109o
        selb    $patch,$patch,$t_shift,$c_left_4        # 110e
        stqd    $lane_11,0($a_lane_9)                   # 110o
        stqd    $lane_12,0($a_lane_10)                  # 111o
        rotqmbyi $t_shift,$patch,-4                     # 112o
        selb    $patch,$patch,$t_shift,$c_left_4        # 116e
        rotqmbyi $t_shift,$patch,-4                     # 118o
        selb    $patch,$patch,$t_shift,$c_left_4        # 122e
        lnop                                            # 122o pairing
        selb    $scattered,$patch,$a_none,$c_other_4    # 124e
        stqd    $patch,496($a_packet)                   # 124o
        ori     $patch_above,$patch,0                   # 125e
        lnop                                            # 125o pairing
        ai      $a_packet,$a_packet_2,320               # 126e
        rotqbyi $a_lane,$scattered,0                    # 126o
        rotqbyi $a_lane_11,$scattered,4                 # 127o
        rotqbyi $a_lane_8,$scattered,8                  # 128o
        rotqbyi $a_lane_9,$scattered,12                 # 129o
        stqd    $lane_13,0($a_lane)                     # 130o
        stqd    $lane_14,0($a_lane_11)                  # 131o
        stqd    $lane_15,0($a_lane_8)                   # 132o
        stqd    $lane_16,0($a_lane_9)                   # 133o
next_packet_back:
        brnz    $count,next_packet                      # 134o
        ori     $a_rays,$next_patch,0                   # 135e
        bi      $lr                                     # 135o
endfunction mesh_list_hits_r16
