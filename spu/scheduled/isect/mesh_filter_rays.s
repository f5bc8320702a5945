# mesh_filter_rays   of a block of a mesh, the children whose boxes some rays of a batch meet, and
#                    which rays these are
#   C       struct mesh_visit *mesh_filter_rays(const struct boxes *, int count, vec_uint4 *rays,
#                       struct mesh_visit *, struct mesh_ray *, const struct rays16 *,
#                       vec_uint4 *);
#   In      $3 the block's BOXES, $4 count, at least 1, $5 bits of the rays that are tested, with
#           room for a quadword of each further node and three more, $6 where the visits go, $7
#           MESH_RAYs, $8 their packets, $9 room for 131 quadwords; pointers 16-aligned
#   Out     MESH_VISITs of the lowest nodes' children that rays meet, in order; three more may be
#           written
#           $3 behind them, $4 how often a ray was tested with a node
#   Uses    $2-$5, $7-$8, $10-$60, $79   Saves  -   Stack  0   Calls  -
#   Domain  complete levels of nodes; records as mesh_rays_r16 makes them; boxes with a slack of
#           2^-19 of the largest magnitude of their coordinates; distances from 2^-60 to 2^60
#   Error   0: no ray is left out that enters a child's box before it ends
#   Twin    lab/twins/src/mesh_rays.rs
#
# For rays that go every way. Nodes are taken one after the other, with the rays that meet their
# own boxes, and the four boxes in the four lanes. A ray misses a box if one of these is below 0:
#   the first end - the last start
#   t - the last start
#   the first end
# Before the first node, the rays' t are brought up to date.
# Scheduled by spu schedule from mesh_filter_rays.s

        .include "work_unit.inc"
        .include "macros.inc"
        .include "extremes.inc"

        .set    NEXT,3
        registers a_node,nodes,a_bits,a_visits,a_rays,a_packets,a_room
        # constants
        registers m_0,m_1,m_2,m_3                       # splat a word
        registers k_far,k_far_y                         # sums of both planes' offsets
        registers k_bit,k_most,k_visit
        # state
        registers a_next                                # where the next node's bits go
        registers a_end                                 # where all nodes have bits
        registers tests,found,a_visit_bits,of_root
        # the node
        registers rays,near,child
        registers met                                   # to 35: bits of rays
        .set    NEXT,met+4
        registers left,listed
        # listing the rays
        registers m_entry                               # to 41
        .set    NEXT,m_entry+4
        registers k_first,k_step,k_numbers,k_packet
        registers bit,none,number,address,a_t,part
        registers step                                  # to 55
        .set    NEXT,step+4
        registers entry
        # reused
        .set    a_list,k_first
        .set    a_again,k_step
        .set    again,k_numbers
        .set    t,k_packet
        .set    record,bit
        .set    first,bit
        .set    second,none
        .set    third,number
        .set    far_planes,address
        .set    near_z,a_t
        .set    far_z,part
        .set    far_y,step
        .set    inverse,step+1
        .set    shift,step+2
        .set    near_time_x,step+3
        .set    near_time_y,entry
        .set    NEXT,entry+1
        registers near_time_z,far_time_x,far_time_y,far_time_z,c_greater,misses,hit,ray_bit
        .set    step_2,near_time_z

        .section .rodata.mesh,"a",@progbits
        .align  4
# The record's address, and behind it that of the ray's t.
addresses:
    .irp lane, 0,1,2,3
        .int    0x00010203+0x04040404*\lane,0x10111213+0x04040404*\lane,0x80808080,0x80808080
    .endr
ray_numbers:                                            # of the first rays of the words
        .int    0,32,64,96
child_and_near:
    .irp child, 0,1,2,3
        .int    0x00010203+0x04040404*\child,0x80808080,0x10111213+0x04040404*\child,0x80808080
    .endr
one_bit:
        .int    0,0,0,1
t_first:
        .int    0x00010203,0x14151617,0x18191a1b,0x1c1d1e1f

function mesh_filter_rays
        .set left_2,79; .set third_2,42; .set first_2,44; .set near_z_2,47; .set far_z_2,27
        .set far_z_3,2; .set inverse_2,27; .set listed_2,49; .set far_planes_2,47; .set listed_3,48
        .set listed_4,2; .set near_time_y_2,27; .set near_time_y_3,45; .set near_time_y_4,46
        .set a_list_2,2; .set first_3,25; .set a_list_3,27; .set first_4,2; .set third_3,35
        .set near_z_3,34; .set third_4,25; .set near_z_4,36; .set t_2,37; .set near_z_5,27
        .set t_3,34; .set third_5,2; .set a_again_2,2; .set third_6,32; .set a_again_3,35
        .set second_2,27; .set third_7,34; .set first_5,33; .set far_y_2,36; .set far_time_x_2,2
        .set far_planes_3,37; .set inverse_3,35; .set near_time_x_2,39; .set shift_2,40
        .set shift_3,41; .set inverse_4,25; .set shift_4,39; .set shift_5,2; .set inverse_5,2
        .set misses_2,34; .set c_greater_2,25; .set near_time_x_3,35; .set far_time_x_3,25
        .set misses_3,41; .set ray_bit_2,36; .set c_greater_3,40; .set shift_6,34
        .set far_time_x_4,27; .set shift_7,37; .set misses_4,2; .set misses_5,27
        .set near_time_x_4,25; .set misses_6,32; .set c_greater_4,33; .set near_time_x_5,37
        .set misses_7,38; .set ray_bit_3,33; .set near_time_y_5,2; .set far_z_4,25
        .set near_time_y_6,32; .set far_z_5,33; .set near_time_y_7,34; .set found_2,35
        .set found_3,36; .set found_4,26; .set listed_5,27; .set listed_6,43; .set near_time_y_8,42
        .set near_time_y_9,44; .set shift_8,27; .set shift_9,33; .set shift_10,25
        .set c_greater_5,2; .set misses_8,25
        ila     $m_0,0x10203                            # 0e
        lqa     $k_bit,one_bit                          # 0o
        ai      $a_packets,$a_packets,384               # 1e
        lnop                                            # 1o pairing
        shli    $a_end,$a_node+1,4                      # 2e
        shufb   $a_rays,$a_rays,$a_rays,$m_0            # 2o
        ilhu    $m_1,0x405                              # 3e
        shufb   $a_packets,$a_packets,$a_packets,$m_0   # 3o
        ilhu    $m_2,0x809                              # 4e
        ilhu    $m_3,0xc0d                              # 5e
        ilhu    $k_far,0x7000                           # 6e
        ilhu    $k_most,0x7fff                          # 7e
        iohl    $m_1,0x607                              # 8e
        iohl    $m_2,0xa0b                              # 9e
        iohl    $m_3,0xe0f                              # 10e
        iohl    $k_far,48                               # 11e
        il      $k_far_y,80                             # 12e
        iohl    $k_most,0xffff                          # 13e
        il      $k_visit,32                             # 14e
        ai      $a_next,$a_bits,16                      # 15e
        a       $a_end,$a_end,$a_bits                   # 16e
        ai      $a_visit_bits,$a_visits,16              # 17e
        il      $tests,0                                # 18e
        il      $found,0                                # 19e
        il      $of_root,1                              # 20e
        lnop                                            # 20o pairing
next_node:
        ori     $near,$k_most,0                         # 0e
        lqd     $rays,0($a_bits)                        # 0o
        il      $met,0                                  # 1e
        il      $met+1,0                                # 2e
        il      $met+2,0                                # 3e
        il      $met+3,0                                # 4e
        orx     $left,$rays                             # 6o
        brz     $left,tested                            # 10o
        cntb    $left,$rays                             # 11e
        lqa     $m_entry,addresses                      # 11o
        ilhu    $a_list,0x8000                          # 12e
        lqa     $m_entry+1,addresses+16                 # 12o
        il      $a_again,16                             # 13e
        lqa     $m_entry+2,addresses+32                 # 13o
        il      $t,640                                  # 14e
        lqa     $m_entry+3,addresses+48                 # 14o
        sumb    $left,$left,$left                       # 15e
        lqa     $again,ray_numbers                      # 15o
        il      $listed,0                               # 16e
        rotmi   $left,$left,-16                         # 19e
        rotqbyi $far_z,$left,8                          # 23o
        cgt     $second,$far_z,$left                    # 27e
        selb    $left,$left,$far_z,$second              # 29e
        rotqbyi $far_z,$left,4                          # 31o
        cgt     $second,$far_z,$left                    # 35e
        selb    $left,$left,$far_z,$second              # 37e
        clgti   $left_2,$left,1                         # 39e at least as many passes as overlap
        brz     $left_2,next_rays_short                 # 41o too few passes
        clz     $third,$rays                            # 42e
        hbrr    next_rays_back,next_rays                # 42o hint
        ceqi    $second,$rays,0                         # 43e
        a       $third_2,$third,$again                  # 44e
        sfi     $first_2,$third,0                       # 45e
        rotmi   $near_z_2,$third_2,-4                   # 46e
        mpyi    $far_planes,$third_2,48                 # 47e
        andi    $far_z_2,$third_2,15                    # 48e
        andc    $far_y,$a_again,$second                 # 49e
        mpyu    $near_z,$near_z_2,$t                    # 50e
        shli    $far_z_3,$far_z_2,2                     # 51e
        rotqbyi $inverse_2,$far_y,4                     # 51o
        rotm    $first,$a_list,$first_2                 # 52e
        rotqbyi $shift,$far_y,8                         # 52o
        a       $listed_2,$listed,$far_y                # 53e
        rotqbyi $near_time_x,$far_y,12                  # 53o
        ai      $left,$left,-1                          # 54e
        a       $far_planes_2,$far_planes,$a_rays       # 55e
        andc    $rays,$rays,$first                      # 56e
        a       $near_z,$near_z,$far_z_3                # 57e
        a       $listed_3,$listed_2,$inverse_2          # 58e
        lnop                                            # 58o pairing
next_rays:
            a       $near_z,$near_z,$a_packets          # 0e
        clz     $third,$rays                            # 1e
            a       $listed_4,$listed_3,$shift          # 2e
            shufb   $near_time_y,$far_planes_2,$near_z,$m_entry # 2o
        ceqi    $second,$rays,0                         # 3e
            shufb   $near_time_y_2,$far_planes_2,$near_z,$m_entry+1 # 3o
        a       $third_2,$third,$again                  # 4e
            shufb   $near_time_y_3,$far_planes_2,$near_z,$m_entry+2 # 4o
        sfi     $first_2,$third,0                       # 5e
            shufb   $near_time_y_4,$far_planes_2,$near_z,$m_entry+3 # 5o
        rotmi   $near_z_2,$third_2,-4                   # 6e
            stqx    $near_time_y,$a_room,$listed        # 6o
            a       $listed,$listed_4,$near_time_x      # 7e
            stqx    $near_time_y_2,$a_room,$listed_2    # 7o
        andi    $far_z_2,$third_2,15                    # 8e
            stqx    $near_time_y_3,$a_room,$listed_3    # 8o
        mpyi    $far_planes,$third_2,48                 # 9e
            stqx    $near_time_y_4,$a_room,$listed_4    # 9o
        shli    $far_z_3,$far_z_2,2                     # 10e
        mpyu    $near_z,$near_z_2,$t                    # 11e
        rotm    $first,$a_list,$first_2                 # 12e
        andc    $far_y,$a_again,$second                 # 13e
        ai      $left,$left,-1                          # 14e
        lnop                                            # 14o pairing
        a       $listed_2,$listed,$far_y                # 15e
        rotqbyi $inverse_2,$far_y,4                     # 15o
        andc    $rays,$rays,$first                      # 16e
        rotqbyi $shift,$far_y,8                         # 16o
        a       $far_planes_2,$far_planes,$a_rays       # 17e
        rotqbyi $near_time_x,$far_y,12                  # 17o
        a       $near_z,$near_z,$far_z_3                # 18e
        lnop                                            # 18o pairing
        a       $listed_3,$listed_2,$inverse_2          # 19e
next_rays_back:
        brnz    $left,next_rays                         # 19o
next_rays_drain:
        a       $near_z,$near_z,$a_packets              # 0e
        a       $listed_4,$listed_3,$shift              # 1e
        shufb   $near_time_y,$far_planes_2,$near_z,$m_entry # 2o
        shufb   $near_time_y_2,$far_planes_2,$near_z,$m_entry+1 # 3o
        shufb   $near_time_y_3,$far_planes_2,$near_z,$m_entry+2 # 4o
        shufb   $near_time_y_4,$far_planes_2,$near_z,$m_entry+3 # 5o
        nop     $127                                    # 6e pairing
        stqx    $near_time_y,$a_room,$listed            # 6o
        a       $listed,$listed_4,$near_time_x          # 7e
        stqx    $near_time_y_2,$a_room,$listed_2        # 7o
        stqx    $near_time_y_3,$a_room,$listed_3        # 8o
        stqx    $near_time_y_4,$a_room,$listed_4        # 9o
mesh_filter_rays_block:
        rotmi   $left,$listed,-4                        # 0e
        lnop                                            # 0o pairing
        a       $tests,$tests,$left                     # 4e
        brz     $of_root,up_to_date                     # 4o
        clgti   $left_2,$left,3                         # 5e at least as many passes as overlap
        lqa     $step_2,t_first                         # 5o
        il      $of_root,0                              # 6e
        ori     $listed,$left,0                         # 7e
        ori     $a_list,$a_room,0                       # 8e
        lnop                                            # 8o pairing
        ori     $a_again,$a_room,0                      # 9e
        brz     $left_2,next_t_short                    # 9o too few passes
        ai      $a_list_2,$a_list,16                    # 10e
        lqd     $first_3,0($a_list)                     # 10o
        ai      $left,$left,-1                          # 11e
        hbrr    next_t_back,next_t                      # 11o hint
        ai      $a_list_3,$a_list_2,16                  # 12e
        lqd     $first_4,0($a_list_2)                   # 12o
        ai      $left,$left,-1                          # 13e
        lqd     $again,0($a_again)                      # 13o
        ai      $a_list,$a_list_3,16                    # 14e
        lqd     $first,0($a_list_3)                     # 14o
        ai      $left,$left,-1                          # 15e
        lnop                                            # 15o pairing
        ai      $a_again,$a_again,16                    # 16e
        rotqbyi $near_z,$first_3,4                      # 16o
        lqd     $third_3,32($first_3)                   # 17o
        rotqbyi $near_z_3,$first_4,4                    # 18o
        nop     $127                                    # 19e pairing
        lqd     $third_4,32($first_4)                   # 19o
        ori     $near_z_4,$near_z,0                     # 20e copy
        lqd     $t_2,0($near_z)                         # 20o
        ori     $near_z_5,$near_z_3,0                   # 22e copy
        lqd     $t_3,0($near_z_3)                       # 22o
        ori     $third_5,$third_3,0                     # 23e copy
        rotqby  $t,$t_2,$near_z_4                       # 26o
next_t:
        ai      $left,$left,-1                          # 0e
            shufb   $third,$t,$third_5,$step_2          # 0o
            ori     $third_5,$third_4,0                 # 1e copy
            rotqbyi $near_z,$first,4                    # 1o
            lqd     $third_4,32($first)                 # 2o
        lqd     $first,0($a_list)                       # 3o
            nop     $127                                # 4e pairing
            stqd    $third,32($again)                   # 4o
        ai      $a_list,$a_list,16                      # 5e
            rotqby  $t,$t_3,$near_z_5                   # 5o
            ori     $near_z_5,$near_z,0                 # 6e copy
            lqd     $t_3,0($near_z)                     # 6o
            nop     $127                                # 7e pairing
            lqd     $again,0($a_again)                  # 7o
            ai      $a_again,$a_again,16                # 8e
next_t_back:
        brnz    $left,next_t                            # 8o
next_t_drain:
        ori     $third_4,$third_4,0                     # 0e copy
        shufb   $third,$t,$third_5,$step_2              # 0o
        ai      $a_again_2,$a_again,16                  # 1e
        rotqbyi $near_z,$first,4                        # 1o
        nop     $127                                    # 2e pairing
        lqd     $third_6,32($first)                     # 2o
        ai      $a_again_3,$a_again_2,16                # 3e
        rotqby  $t,$t_3,$near_z_5                       # 3o
        nop     $127                                    # 4e pairing
        stqd    $third,32($again)                       # 4o
        ori     $near_z_5,$near_z,0                     # 5e copy
        lqd     $t_3,0($near_z)                         # 5o
        lqd     $again,0($a_again)                      # 6o
        shufb   $third,$t,$third_4,$step_2              # 7o
        ori     $third_4,$third_6,0                     # 8e copy
        rotqby  $t,$t_3,$near_z_5                       # 11o
        stqd    $third,32($again)                       # 12o
        lqd     $again,0($a_again_2)                    # 13o
        shufb   $third,$t,$third_4,$step_2              # 15o
        stqd    $third,32($again)                       # 19o
mesh_filter_rays_block_2:
        ori     $left,$listed,0                         # 0e
        lnop                                            # 0o pairing
up_to_date:
        clgti   $left_2,$left,2                         # 0e at least as many passes as overlap
        ori     $a_list,$a_room,0                       # 1e
        nop     $127                                    # 2e pairing
        brz     $left_2,next_ray_short                  # 2o too few passes
        ai      $a_list_2,$a_list,16                    # 3e
        lqd     $first,0($a_list)                       # 3o
        ai      $left,$left,-1                          # 4e
        hbrr    next_ray_back,next_ray                  # 4o hint
        ai      $a_list,$a_list_2,16                    # 5e
        lqd     $first_4,0($a_list_2)                   # 5o
        ai      $left,$left,-1                          # 6e
        lqd     $first_3,0($first)                      # 9o
        lqd     $second_2,16($first)                    # 10o
        lqd     $third_7,32($first)                     # 11o
        lqd     $second,16($first_4)                    # 12o
        lqd     $first_5,0($first_4)                    # 13o
        nop     $127                                    # 14e pairing
        lqd     $third,32($first_4)                     # 14o
        sf      $far_planes,$first_3,$k_far             # 15e
        rotqmbyi $near_z,$first_3,-3                    # 15o
        sf      $far_y,$second_2,$k_far_y               # 16e
        lqx     $near_time_y,$a_node,$second_2          # 16o
        nop     $127                                    # 17e pairing
        shufb   $shift,$second_2,$second_2,$m_1         # 17o
        sf      $far_y_2,$second,$k_far_y               # 18e
        lqx     $far_time_x_2,$a_node,$far_planes       # 18o
        sf      $far_planes_3,$first_5,$k_far           # 19e
        lqx     $far_time_y,$a_node,$far_y              # 19o
        shufb   $inverse_3,$first_3,$first_3,$m_2       # 20o
        lqx     $near_time_x_2,$a_node,$first_3         # 21o
        shufb   $inverse,$first_3,$first_3,$m_1         # 22o
        rotqmbyi $far_z,$far_planes,-3                  # 23o
        shufb   $shift_2,$second_2,$second_2,$m_2       # 24o
        shufb   $shift_3,$third_7,$third_7,$m_1         # 25o
        nop     $127                                    # 26e pairing
        shufb   $inverse_4,$first_3,$first_3,$m_3       # 26o
        fma     $near_time_x,$near_time_x_2,$inverse,$shift # 27e
        lqx     $step_2,$a_node,$near_z                 # 27o
        fma     $near_time_y,$near_time_y,$inverse_3,$shift_2 # 28e
        shufb   $shift_4,$third_7,$third_7,$m_2         # 28o
        fma     $far_time_x,$far_time_x_2,$inverse,$shift_3 # 29e
        shufb   $shift_5,$second_2,$second_2,$m_3       # 29o
        shufb   $shift,$third_7,$third_7,$m_3           # 30o
        lqx     $far_time_z,$a_node,$far_z              # 31o
        fma     $far_time_y,$far_time_y,$inverse_3,$shift_4 # 32e
        rotqmbyi $ray_bit,$second_2,-3                  # 32o
        fma     $step_2,$step_2,$inverse_4,$shift_5     # 33e
        lqx     $near_time_y_2,$a_node,$second          # 33o
        fcgt    $c_greater,$near_time_y,$near_time_x    # 34e
        shufb   $inverse,$first_5,$first_5,$m_1         # 34o
        nop     $127                                    # 35e pairing
        shufb   $inverse_5,$first_5,$first_5,$m_2       # 35o
        selb    $near_time_x,$near_time_x,$near_time_y,$c_greater # 36e
        lqx     $near_time_x_2,$a_node,$first_5         # 36o
        fma     $far_time_z,$far_time_z,$inverse_4,$shift # 37e
        shufb   $shift,$second,$second,$m_2             # 37o
        fcgt    $c_greater,$far_time_x,$far_time_y      # 38e
        shufb   $misses_2,$third_7,$third_7,$m_0        # 38o
        fcgt    $c_greater_2,$step_2,$near_time_x       # 39e
        shufb   $shift_2,$second,$second,$m_1           # 39o
        selb    $far_time_x,$far_time_x,$far_time_y,$c_greater # 40e
        shlqbybi $misses,$k_bit,$ray_bit                # 40o
        selb    $near_time_x_3,$near_time_x,$step_2,$c_greater_2 # 41e
        rotqmbyi $near_z,$first_5,-3                    # 41o
        fma     $near_time_y,$near_time_y_2,$inverse_5,$shift # 42e
        lqx     $far_time_x_3,$a_node,$far_planes_3     # 42o
        fs      $misses_3,$misses_2,$near_time_x_3      # 43e
        lqx     $far_time_y,$a_node,$far_y_2            # 43o
        fcgt    $c_greater,$far_time_x,$far_time_z      # 44e
        shlqbi  $ray_bit_2,$misses,$ray_bit             # 44o
        fma     $near_time_x,$near_time_x_2,$inverse,$shift_2 # 45e
        lqx     $step_2,$a_node,$near_z                 # 45o
        selb    $far_time_x,$far_time_x,$far_time_z,$c_greater # 46e
        rotqmbyi $far_z,$far_planes_3,-3                # 46o
        fcgt    $c_greater_3,$near,$near_time_x_3       # 47e
        shufb   $shift_6,$third,$third,$m_1             # 47o
        fs      $far_time_x_4,$far_time_x,$near_time_x_3 # 48e
        shufb   $shift_4,$second,$second,$m_3           # 48o
        or      $misses,$misses_3,$far_time_x           # 49e
        shufb   $shift_7,$third,$third,$m_2             # 49o
next_ray:
            fma     $far_time_x,$far_time_x_3,$inverse,$shift_6 # 0e
            lqx     $far_time_z,$a_node,$far_z          # 0o
            fma     $far_time_y,$far_time_y,$inverse_5,$shift_7 # 1e
            shufb   $inverse,$first_5,$first_5,$m_3     # 1o
            or      $misses,$misses,$far_time_x_4       # 2e
        lqd     $first,0($a_list)                       # 2o
        ai      $a_list,$a_list,16                      # 3e
            shufb   $misses_4,$third,$third,$m_0        # 3o
            cgti    $hit,$misses,-1                     # 4e
            rotqmbyi $ray_bit,$second,-3                # 4o
            fcgt    $c_greater,$near_time_y,$near_time_x # 5e
            shufb   $shift,$third,$third,$m_3           # 5o
            and     $c_greater_2,$c_greater_3,$hit      # 6e
            shufb   $misses,$hit,$hit,$m_0              # 6o
            fma     $step_2,$step_2,$inverse,$shift_4   # 7e
            shufb   $misses_5,$hit,$hit,$m_3            # 7o
            selb    $near_time_x,$near_time_x,$near_time_y,$c_greater # 8e
        lqd     $second,16($first)                      # 8o
            fcgt    $c_greater,$far_time_x,$far_time_y  # 9e
        lqd     $first_5,0($first)                      # 9o
            fma     $far_time_z,$far_time_z,$inverse,$shift # 10e
        lqd     $third,32($first)                       # 10o
            selb    $met,$met,$misses,$ray_bit_2        # 11e
            shlqbybi $misses,$k_bit,$ray_bit            # 11o
            selb    $far_time_x,$far_time_x,$far_time_y,$c_greater # 12e
            shufb   $misses_2,$hit,$hit,$m_1            # 12o
            selb    $met+3,$met+3,$misses_5,$ray_bit_2  # 13e
            shufb   $misses_5,$hit,$hit,$m_2            # 13o
            fcgt    $c_greater,$step_2,$near_time_x     # 14e
        lqx     $near_time_y,$a_node,$second            # 14o
            selb    $near,$near,$near_time_x_3,$c_greater_2 # 15e
        rotqmbyi $near_z,$first_5,-3                    # 15o
        sf      $far_y,$second,$k_far_y                 # 16e
        lqx     $near_time_x_4,$a_node,$first_5         # 16o
            selb    $met+2,$met+2,$misses_5,$ray_bit_2  # 17e
        shufb   $inverse,$first_5,$first_5,$m_1         # 17o
            selb    $near_time_x_3,$near_time_x,$step_2,$c_greater # 18e
        lqx     $far_time_y,$a_node,$far_y              # 18o
            selb    $met+1,$met+1,$misses_2,$ray_bit_2  # 19e
        shufb   $shift,$second,$second,$m_1             # 19o
        sf      $far_planes,$first_5,$k_far             # 20e
            shlqbi  $ray_bit_2,$misses,$ray_bit         # 20o
            fs      $misses,$misses_4,$near_time_x_3    # 21e
        shufb   $inverse_5,$first_5,$first_5,$m_2       # 21o
            fcgt    $c_greater,$far_time_x,$far_time_z  # 22e
        rotqmbyi $far_z,$far_planes,-3                  # 22o
        fma     $near_time_x,$near_time_x_4,$inverse,$shift # 23e
        lqx     $far_time_x_3,$a_node,$far_planes       # 23o
            selb    $far_time_x,$far_time_x,$far_time_z,$c_greater # 24e
        shufb   $shift,$second,$second,$m_2             # 24o
        ai      $left,$left,-1                          # 25e
        lqx     $step_2,$a_node,$near_z                 # 25o
            fs      $far_time_x_4,$far_time_x,$near_time_x_3 # 26e
        shufb   $shift_6,$third,$third,$m_1             # 26o
            or      $misses,$misses,$far_time_x         # 27e
        shufb   $shift_7,$third,$third,$m_2             # 27o
        fma     $near_time_y,$near_time_y,$inverse_5,$shift # 28e
        shufb   $shift_4,$second,$second,$m_3           # 28o
            fcgt    $c_greater_3,$near,$near_time_x_3   # 29e
next_ray_back:
        brnz    $left,next_ray                          # 29o
next_ray_drain:
        fma     $far_time_x,$far_time_x_3,$inverse,$shift_6 # 0e
        lqx     $far_time_z,$a_node,$far_z              # 0o
        fma     $far_time_y,$far_time_y,$inverse_5,$shift_7 # 1e
        shufb   $inverse,$first_5,$first_5,$m_3         # 1o
        fcgt    $c_greater,$near_time_y,$near_time_x    # 2e
        shufb   $shift,$third,$third,$m_3               # 2o
        or      $misses,$misses,$far_time_x_4           # 3e
        shufb   $misses_4,$third,$third,$m_0            # 3o
        selb    $near_time_x,$near_time_x,$near_time_y,$c_greater # 4e
        rotqmbyi $ray_bit,$second,-3                    # 4o
        fma     $step_2,$step_2,$inverse,$shift_4       # 5e
        fma     $far_time_z,$far_time_z,$inverse,$shift # 6e
        fcgt    $c_greater,$far_time_x,$far_time_y      # 7e
        lnop                                            # 7o pairing
        cgti    $hit,$misses,-1                         # 8e
        shlqbybi $misses,$k_bit,$ray_bit                # 8o
        selb    $far_time_x,$far_time_x,$far_time_y,$c_greater # 9e
        lnop                                            # 9o pairing
        and     $c_greater_2,$c_greater_3,$hit          # 10e
        shufb   $misses_5,$hit,$hit,$m_0                # 10o
        fcgt    $c_greater,$step_2,$near_time_x         # 11e
        shufb   $misses_6,$hit,$hit,$m_3                # 11o
        fcgt    $c_greater_4,$far_time_x,$far_time_z    # 12e
        shufb   $misses_2,$hit,$hit,$m_1                # 12o
        selb    $near_time_x_5,$near_time_x,$step_2,$c_greater # 13e
        shufb   $misses_7,$hit,$hit,$m_2                # 13o
        selb    $far_time_x,$far_time_x,$far_time_z,$c_greater_4 # 14e
        shlqbi  $ray_bit_3,$misses,$ray_bit             # 14o
        fs      $misses,$misses_4,$near_time_x_5        # 15e
        fs      $far_time_x_2,$far_time_x,$near_time_x_5 # 16e
        selb    $near,$near,$near_time_x_3,$c_greater_2 # 17e
        selb    $met,$met,$misses_5,$ray_bit_2          # 18e
        fcgt    $c_greater_3,$near,$near_time_x_5       # 19e
        selb    $met+3,$met+3,$misses_6,$ray_bit_2      # 20e
        or      $misses,$misses,$far_time_x             # 21e
        selb    $met+2,$met+2,$misses_7,$ray_bit_2      # 22e
        or      $misses,$misses,$far_time_x_2           # 23e
        selb    $met+1,$met+1,$misses_2,$ray_bit_2      # 24e
        cgti    $hit,$misses,-1                         # 25e
        lnop                                            # 25o pairing
        and     $c_greater_2,$c_greater_3,$hit          # 27e
        shufb   $misses,$hit,$hit,$m_0                  # 27o
        nop     $127                                    # 28e pairing
        shufb   $misses_5,$hit,$hit,$m_3                # 28o
        selb    $near,$near,$near_time_x_5,$c_greater_2 # 29e
        shufb   $misses_2,$hit,$hit,$m_1                # 29o
        shufb   $misses_4,$hit,$hit,$m_2                # 30o
        selb    $met,$met,$misses,$ray_bit_3            # 31e
        selb    $met+3,$met+3,$misses_5,$ray_bit_3      # 32e
        selb    $met+1,$met+1,$misses_2,$ray_bit_3      # 33e
        selb    $met+2,$met+2,$misses_4,$ray_bit_3      # 34e
        lnop                                            # 34o pairing
tested:
        cgt     $left,$a_end,$a_next                    # 0e
        lqd     $child,96($a_node)                      # 0o
        nop     $127                                    # 1e pairing
        brnz    $left,upper                             # 2o
        orx     $far_z,$met                             # 3o
        lqa     $near_time_y,child_and_near             # 4o
        lqa     $near_time_y_5,child_and_near+16        # 5o
        orx     $far_z_4,$met+1                         # 6o
        ceqi    $far_z,$far_z,0                         # 7e
        lqa     $near_time_y_6,child_and_near+32        # 7o
        nop     $127                                    # 8e pairing
        orx     $far_z_5,$met+2                         # 8o
        andc    $far_z,$k_visit,$far_z                  # 9e
        lqa     $near_time_y_7,child_and_near+48        # 9o
        ceqi    $far_z_4,$far_z_4,0                     # 10e
        shufb   $near_time_y,$child,$near,$near_time_y  # 10o
        a       $found_2,$found,$far_z                  # 11e
        shufb   $near_time_y_5,$child,$near,$near_time_y_5 # 11o
        andc    $far_z,$k_visit,$far_z_4                # 12e
        orx     $far_z_4,$met+3                         # 12o
        ceqi    $far_z_5,$far_z_5,0                     # 13e
        shufb   $near_time_y_6,$child,$near,$near_time_y_6 # 13o
        a       $found_3,$found_2,$far_z                # 14e
        stqx    $near_time_y,$a_visits,$found           # 14o
        andc    $far_z,$k_visit,$far_z_5                # 15e
        shufb   $near_time_y,$child,$near,$near_time_y_7 # 15o
        ceqi    $far_z_4,$far_z_4,0                     # 16e
        stqx    $met,$a_visit_bits,$found               # 16o
        a       $found_4,$found_3,$far_z                # 17e
        stqx    $near_time_y_5,$a_visits,$found_2       # 17o
        andc    $far_z,$k_visit,$far_z_4                # 18e
        stqx    $met+1,$a_visit_bits,$found_2           # 18o
        nop     $127                                    # 19e pairing
        stqx    $near_time_y_6,$a_visits,$found_3       # 19o
        a       $found,$found_4,$far_z                  # 20e
        stqx    $met+2,$a_visit_bits,$found_3           # 20o
        stqx    $near_time_y,$a_visits,$found_4         # 21o
        stqx    $met+3,$a_visit_bits,$found_4           # 22o
next:
        ai      $a_node+1,$a_node+1,-1                  # 0e
        ai      $a_bits,$a_bits,16                      # 1e
        ai      $a_node,$a_node,112                     # 2e
        brnz    $a_node+1,next_node                     # 2o
        a       $a_node,$a_visits,$found                # 3e
        lnop                                            # 3o pairing
        ori     $a_node+1,$tests,0                      # 4e
        bi      $lr                                     # 4o
upper:
        ceqi    $child,$child,0                         # 0e
        stqd    $met,0($a_next)                         # 0o
        stqd    $met+1,16($a_next)                      # 1o
        gb      $child,$child                           # 2o
        stqd    $met+2,32($a_next)                      # 3o
        stqd    $met+3,48($a_next)                      # 4o
        cntb    $child,$child                           # 6e
        sfi     $child,$child,4                         # 10e
        shli    $child,$child,4                         # 12e
        lnop                                            # 12o pairing
        a       $a_next,$a_next,$child                  # 16e
        br      next                                    # 16o
next_rays_short:
        clz     $third,$rays                            # 0e
        ceqi    $second,$rays,0                         # 1e
        a       $third_5,$third,$again                  # 2e
        andc    $far_y,$a_again,$second                 # 3e
        rotmi   $near_z,$third_5,-4                     # 4e
        lnop                                            # 4o pairing
        andi    $far_z,$third_5,15                      # 5e
        rotqbyi $inverse,$far_y,4                       # 5o
        mpyi    $far_planes,$third_5,48                 # 6e
        rotqbyi $shift,$far_y,8                         # 6o
        shli    $far_z,$far_z,2                         # 7e
        rotqbyi $near_time_x,$far_y,12                  # 7o
        mpyu    $near_z,$near_z,$t                      # 8e
        a       $listed_4,$listed,$far_y                # 9e
        sfi     $first,$third,0                         # 10e
        a       $listed_5,$listed_4,$inverse            # 11e
        rotm    $first,$a_list,$first                   # 12e
        a       $far_planes,$far_planes,$a_rays         # 13e
        a       $listed_6,$listed_5,$shift              # 14e
        a       $near_z,$near_z,$far_z                  # 15e
        ai      $left,$left,-1                          # 16e
        a       $near_z,$near_z,$a_packets              # 17e
        andc    $rays,$rays,$first                      # 18e
        shufb   $near_time_y,$far_planes,$near_z,$m_entry # 19o
        shufb   $near_time_y_8,$far_planes,$near_z,$m_entry+1 # 20o
        shufb   $near_time_y_9,$far_planes,$near_z,$m_entry+2 # 21o
        shufb   $near_time_y_3,$far_planes,$near_z,$m_entry+3 # 22o
        stqx    $near_time_y,$a_room,$listed            # 23o
        a       $listed,$listed_6,$near_time_x          # 24e
        stqx    $near_time_y_8,$a_room,$listed_4        # 24o
        stqx    $near_time_y_9,$a_room,$listed_5        # 25o
        stqx    $near_time_y_3,$a_room,$listed_6        # 26o
        nop     $127                                    # 27e pairing
        brnz    $left,next_rays_short                   # 27o
        nop     $127                                    # 28e pairing
        br      mesh_filter_rays_block                  # 28o
next_t_short:
        ai      $left,$left,-1                          # 0e
        lqd     $first,0($a_list)                       # 0o
        ai      $a_list,$a_list,16                      # 1e
        lqd     $again,0($a_again)                      # 1o
        ai      $a_again,$a_again,16                    # 2e
        rotqbyi $near_z,$first,4                        # 6o
        lqd     $third,32($first)                       # 7o
        lqd     $t,0($near_z)                           # 10o
        rotqby  $t,$t,$near_z                           # 16o
        shufb   $third,$t,$third,$step_2                # 20o
        stqd    $third,32($again)                       # 24o
        brnz    $left,next_t_short                      # 25o
        nop     $127                                    # 26e pairing
        br      mesh_filter_rays_block_2                # 26o
next_ray_short:
        ai      $left,$left,-1                          # 0e
        lqd     $first,0($a_list)                       # 0o
        ai      $a_list,$a_list,16                      # 1e
        lqd     $second,16($first)                      # 6o
        lqd     $first_4,0($first)                      # 7o
        lqd     $third,32($first)                       # 8o
        sf      $far_y,$second,$k_far_y                 # 12e
        lqx     $near_time_y,$a_node,$second            # 12o
        sf      $far_planes,$first_4,$k_far             # 13e
        rotqmbyi $near_z,$first_4,-3                    # 13o
        lqx     $near_time_x,$a_node,$first_4           # 14o
        rotqmbyi $far_z,$far_planes,-3                  # 15o
        lqx     $far_time_x,$a_node,$far_planes         # 16o
        lqx     $far_time_y,$a_node,$far_y              # 17o
        shufb   $inverse,$first_4,$first_4,$m_1         # 18o
        shufb   $shift,$second,$second,$m_1             # 19o
        shufb   $inverse_4,$first_4,$first_4,$m_2       # 20o
        shufb   $shift_8,$second,$second,$m_2           # 21o
        nop     $127                                    # 22e pairing
        lqx     $step_2,$a_node,$near_z                 # 22o
        fma     $near_time_x,$near_time_x,$inverse,$shift # 23e
        shufb   $shift,$third,$third,$m_1               # 23o
        nop     $127                                    # 24e pairing
        shufb   $shift_9,$third,$third,$m_2             # 24o
        fma     $near_time_y,$near_time_y,$inverse_4,$shift_8 # 25e
        lqx     $far_time_z,$a_node,$far_z              # 25o
        nop     $127                                    # 26e pairing
        shufb   $inverse_5,$first_4,$first_4,$m_3       # 26o
        fma     $far_time_x,$far_time_x,$inverse,$shift # 27e
        shufb   $shift,$second,$second,$m_3             # 27o
        fma     $far_time_y,$far_time_y,$inverse_4,$shift_9 # 28e
        shufb   $shift_10,$third,$third,$m_3            # 28o
        shufb   $misses,$third,$third,$m_0              # 29o
        rotqmbyi $ray_bit,$second,-3                    # 30o
        fma     $step_2,$step_2,$inverse_5,$shift       # 31e
        fma     $far_time_z,$far_time_z,$inverse_5,$shift_10 # 32e
        fcgt    $c_greater,$near_time_y,$near_time_x    # 33e
        lnop                                            # 33o pairing
        fcgt    $c_greater_5,$far_time_x,$far_time_y    # 34e
        shlqbybi $misses_8,$k_bit,$ray_bit              # 34o
        selb    $near_time_x,$near_time_x,$near_time_y,$c_greater # 35e
        selb    $far_time_x,$far_time_x,$far_time_y,$c_greater_5 # 36e
        fcgt    $c_greater,$step_2,$near_time_x         # 37e
        lnop                                            # 37o pairing
        fcgt    $c_greater_5,$far_time_x,$far_time_z    # 38e
        shlqbi  $ray_bit,$misses_8,$ray_bit             # 38o
        selb    $near_time_x,$near_time_x,$step_2,$c_greater # 39e
        selb    $far_time_x,$far_time_x,$far_time_z,$c_greater_5 # 40e
        fs      $misses,$misses,$near_time_x            # 41e
        fs      $far_time_x_2,$far_time_x,$near_time_x  # 42e
        fcgt    $c_greater,$near,$near_time_x           # 43e
        or      $misses,$misses,$far_time_x             # 47e
        or      $misses,$misses,$far_time_x_2           # 49e
        cgti    $hit,$misses,-1                         # 51e
        and     $c_greater,$c_greater,$hit              # 53e
        shufb   $misses,$hit,$hit,$m_0                  # 53o
        nop     $127                                    # 54e pairing
        shufb   $misses_4,$hit,$hit,$m_1                # 54o
        selb    $near,$near,$near_time_x,$c_greater     # 55e
        shufb   $misses_8,$hit,$hit,$m_2                # 55o
        shufb   $misses_5,$hit,$hit,$m_3                # 56o
        selb    $met,$met,$misses,$ray_bit              # 57e
        selb    $met+1,$met+1,$misses_4,$ray_bit        # 58e
        selb    $met+2,$met+2,$misses_8,$ray_bit        # 59e
        selb    $met+3,$met+3,$misses_5,$ray_bit        # 60e
        brnz    $left,next_ray_short                    # 60o
        nop     $127                                    # 61e pairing
        br      tested                                  # 61o
endfunction mesh_filter_rays
