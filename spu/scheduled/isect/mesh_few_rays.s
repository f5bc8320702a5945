# mesh_few_rays   of a leaf of a mesh, the children whose boxes some of a few rays meet, as candidates
#                 of the rays' packets
#   C       struct mesh_candidate *mesh_few_rays(const struct boxes *, int count,
#                       const vec_uint4 *rays, struct mesh_candidate *, const struct mesh_ray *,
#                       const struct mesh_candidate packets[2], int base, vec_uint4 *);
#   In      $3 the lowest nodes, $4 count, at least 1, $5 the rays' bits, at least one, $6 where
#           the list goes, $7 MESH_RAYs, $8 two quadwords: a candidate of the first packet, and
#           what is added for each further one, $9 what is added to each child's word, $10 room for
#           as many quadwords as there are rays and three more; pointers 16-aligned
#   Out     ray by ray and child by child, a candidate for each box that a ray meets: object is the
#           child's word plus $9, packet and bound are those of the ray's packet, near is anything;
#           three more quadwords may be written
#           $3 behind the list
#   Uses    $2-$5, $7-$34, $37-$79   Saves  -   Stack  0   Calls  -
#   Domain  records as mesh_rays_r16 makes them; boxes with a slack of 2^-19 of the largest
#           magnitude of their coordinates; distances from 2^-60 to 2^60
#   Error   0: no child is left out that a ray enters before it ends
#   Twin    lab/twins/src/mesh_rays.rs
#
# Each ray is tested with each node, in one loop: for a few rays that is quicker than to look for
# the nodes that they meet, level by level. The tests are those of mesh_filter_rays.
# Scheduled by spu schedule from mesh_few_rays.s

        .include "work_unit.inc"
        .include "macros.inc"
        .include "extremes.inc"
        .include "transpose.inc"

        .set    NEXT,3
        registers a_first,nodes,a_bits,a_list,a_rays,a_packets,base,a_room
        # constants
        registers m_0,m_1,m_2,m_3                       # splat a word
        registers k_far,k_far_y                         # sums of both planes' offsets
        registers k_step,a_last
        registers m_entry                               # to 22: the child's word
        .set    NEXT,m_entry+4
        # state
        registers a_node,a_ray,listed,found,left
        # listing the rays
        registers rays,bit,none,number,part,k_first,k_numbers
        registers packet,bound,packets,bounds,step_packet,step_bound,start
        registers words                                 # to 44: by field, then by ray
        .set    NEXT,words+4
        registers turned                                # to 48
        .set    NEXT,turned+4
        registers m_low,m_high
        registers step                                  # to 54
        .set    NEXT,step+4
        # a ray
        registers ray,first,second,third,a_t,t
        registers far_planes,near_z,far_z,far_y,inverse,shift
        registers near_time_x,near_time_y,near_time_z,far_time_x,far_time_y,far_time_z
        registers c_greater,misses,child,entry,last
        .set    next,rays

        transpose_table .rodata.mesh
ray_numbers:                                            # of the first rays of the words
        .int    0,32,64,96
child_of_node:
    .irp child, 0,1,2,3
        .int    0x00010203+0x04040404*\child,0x14151617,0x18191a1b,0x1c1d1e1f
    .endr

function mesh_few_rays
        .set number_2,2; .set part_2,2; .set listed_2,5; .set listed_3,2; .set listed_4,7
        .set left_2,79; .set ray_2,2; .set last_2,5; .set a_node_2,4; .set child_2,5; .set last_3,7
        .set entry_2,10; .set shift_2,8; .set shift_3,25; .set inverse_2,7; .set shift_4,29
        .set shift_5,7; .set inverse_3,25; .set c_greater_2,7; .set near_time_x_2,7
        .set far_time_x_2,10; .set far_time_x_3,28; .set inverse_4,29; .set shift_6,30
        .set shift_7,31; .set entry_3,8; .set entry_4,7; .set shift_8,4; .set found_2,2
        .set entry_5,4; .set c_greater_3,5; .set far_time_x_4,2; .set inverse_5,2; .set shift_9,5
        .set c_greater_4,3; .set entry_6,5; .set entry_7,3; .set far_time_x_5,4; .set found_3,11
        .set found_4,4; .set last_4,2; .set entry_8,2; .set inverse_6,4; .set c_greater_5,4
        mpyi    $a_last,$a_first+1,112                  # 0e
        lqd     $next,0($a_bits)                        # 0o
        ilhu    $m_1,0x405                              # 1e
        hbrr    next_rays_back,next_rays                # 1o hint
        ilhu    $m_2,0x809                              # 2e
        lqd     $start,0($a_packets)                    # 2o
        ila     $m_0,0x10203                            # 3e
        lqd     $part,16($a_packets)                    # 3o
        iohl    $m_1,0x607                              # 4e
        lqa     $m_low,transpose_first                  # 4o
        iohl    $m_2,0xa0b                              # 5e
        lqa     $m_high,transpose_last                  # 5o
        cntb    $left,$next                             # 6e
        lqa     $k_numbers,ray_numbers                  # 6o
        ilhu    $m_3,0xc0d                              # 7e
        shufb   $base,$base,$base,$m_0                  # 7o
        ilhu    $k_far,0x7000                           # 8e
        shufb   $packets,$start,$start,$m_1             # 8o
        a       $a_last,$a_last,$a_first                # 9e
        shufb   $bounds,$start,$start,$m_2              # 9o
        sumb    $left,$left,$left                       # 10e
        shufb   $step_packet,$part,$part,$m_1           # 10o
        iohl    $m_3,0xe0f                              # 11e
        shufb   $step_bound,$part,$part,$m_2            # 11o
        iohl    $k_far,48                               # 12e
        shufb   $start,$a_rays,$a_rays,$m_0             # 12o
        il      $k_far_y,80                             # 13e
        rotmi   $left,$left,-16                         # 14e
        il      $k_step,16                              # 15e
        ai      $a_last,$a_last,-112                    # 16e
        ilhu    $k_first,0x8000                         # 17e
        lnop                                            # 17o pairing
        il      $listed,0                               # 18e
        rotqbyi $part,$left,8                           # 18o
        cgt     $none,$part,$left                       # 22e
        selb    $left,$left,$part,$none                 # 24e
        rotqbyi $part,$left,4                           # 26o
        cgt     $none,$part,$left                       # 30e
        selb    $left,$left,$part,$none                 # 32e
        sfi     $left,$left,0                           # 34e counts up: there are few passes
next_rays:
        clz     $number,$next                           # 0e
        ceqi    $none,$next,0                           # 1e
        a       $number_2,$number,$k_numbers            # 2e
        andc    $step,$k_step,$none                     # 3e
        rotmi   $part,$number_2,-4                      # 4e
        lnop                                            # 4o pairing
        mpyi    $words,$number_2,48                     # 5e
        rotqbyi $step+1,$step,4                         # 5o
        andi    $part_2,$number_2,15                    # 6e
        rotqbyi $step+2,$step,8                         # 6o
        a       $listed_2,$listed,$step                 # 7e
        rotqbyi $step+3,$step,12                        # 7o
        mpyu    $words+1,$part,$step_packet             # 8e
        mpyu    $words+2,$part,$step_bound              # 9e
        shli    $part,$part_2,2                         # 10e
        sfi     $bit,$number,0                          # 11e
        a       $words,$words,$start                    # 12e
        a       $listed_3,$listed_2,$step+1             # 13e
        rotm    $bit,$k_first,$bit                      # 14e
        a       $words+1,$words+1,$packets              # 15e
        a       $words+2,$words+2,$bounds               # 16e
        a       $words+3,$words+1,$part                 # 17e its t, but for the offset
        a       $listed_4,$listed_3,$step+2             # 18e
        shufb   $turned,$words,$words+2,$m_low          # 18o
        ai      $left,$left,1                           # 19e
        shufb   $turned+1,$words+1,$words+3,$m_low      # 19o
        andc    $next,$next,$bit                        # 20e
        shufb   $turned+2,$words,$words+2,$m_high       # 20o
        shufb   $turned+3,$words+1,$words+3,$m_high     # 21o
        shufb   $words,$turned,$turned+1,$m_low         # 23o
        shufb   $words+1,$turned,$turned+1,$m_high      # 24o
        shufb   $words+2,$turned+2,$turned+3,$m_low     # 25o
        shufb   $words+3,$turned+2,$turned+3,$m_high    # 26o
        stqx    $words,$a_room,$listed                  # 27o
        a       $listed,$listed_4,$step+3               # 28e
        stqx    $words+1,$a_room,$listed_2              # 28o
        stqx    $words+2,$a_room,$listed_3              # 29o
        stqx    $words+3,$a_room,$listed_4              # 30o
        nop     $127                                    # 31e pairing
next_rays_back:
        brnz    $left,next_rays                         # 31o
        rotmi   $left,$listed,-4                        # 32e
        lqa     $m_entry,child_of_node                  # 32o
        ori     $a_node,$a_first,0                      # 33e
        lqa     $m_entry+1,child_of_node+16             # 33o
        ori     $a_ray,$a_room,0                        # 34e
        lqa     $m_entry+2,child_of_node+32             # 34o
        il      $found,0                                # 35e
        lqa     $m_entry+3,child_of_node+48             # 35o
        mpyu    $left,$left,$a_first+1                  # 36e
        clgti   $left_2,$left,2                         # 43e at least as many passes as overlap
        nop     $127                                    # 44e pairing
        brz     $left_2,next_pair_short                 # 45o too few passes
        ceq     $last,$a_node,$a_last                   # 46e
        lqd     $ray_2,0($a_ray)                        # 46o
        ai      $next,$a_node,112                       # 47e
        lqd     $child,96($a_node)                      # 47o
        and     $last_2,$last,$k_step                   # 48e
        ai      $left,$left,-1                          # 49e
        a       $a_ray,$a_ray,$last_2                   # 50e
        selb    $a_node_2,$next,$a_first,$last          # 51e
        ai      $left,$left,-1                          # 52e
        lqd     $second,16($ray_2)                      # 52o
        a       $child_2,$child,$base                   # 53e
        lqd     $first,0($ray_2)                        # 53o
        ceq     $last,$a_node_2,$a_last                 # 54e
        lqd     $third,32($ray_2)                       # 54o
        ai      $next,$a_node_2,112                     # 55e
        rotqbyi $a_t,$ray_2,12                          # 55o
        and     $last_3,$last,$k_step                   # 56e
        lqd     $ray,0($a_ray)                          # 56o
        nop     $127                                    # 57e pairing
        shufb   $entry_2,$child_2,$ray_2,$m_entry       # 57o
        sf      $far_y,$second,$k_far_y                 # 58e
        lqx     $near_time_y,$a_node,$second            # 58o
        sf      $far_planes,$first,$k_far               # 59e
        lqx     $near_time_x,$a_node,$first             # 59o
        rotmi   $near_z,$first,-24                      # 60e
        shufb   $shift_2,$second,$second,$m_1           # 60o
        rotmi   $far_z,$far_planes,-24                  # 61e
        shufb   $shift_3,$second,$second,$m_2           # 61o
        a       $a_ray,$a_ray,$last_3                   # 62e
        lqx     $far_time_y,$a_node,$far_y              # 62o
        shufb   $inverse,$first,$first,$m_1             # 63o
        lqx     $far_time_x,$a_node,$far_planes         # 64o
        shufb   $inverse_2,$first,$first,$m_2           # 65o
        shufb   $shift_4,$third,$third,$m_2             # 66o
        fma     $near_time_x,$near_time_x,$inverse,$shift_2 # 67e
        lqx     $near_time_z,$a_node,$near_z            # 67o
        nop     $127                                    # 68e pairing
        shufb   $shift_2,$third,$third,$m_1             # 68o
        fma     $near_time_y,$near_time_y,$inverse_2,$shift_3 # 69e
        lqx     $far_time_z,$a_node,$far_z              # 69o
        fma     $far_time_y,$far_time_y,$inverse_2,$shift_4 # 70e
        shufb   $shift_5,$second,$second,$m_3           # 70o
        selb    $a_node,$next,$a_first,$last            # 71e
        shufb   $inverse_3,$first,$first,$m_3           # 71o
        fma     $far_time_x,$far_time_x,$inverse,$shift_2 # 72e
        lqd     $t,384($a_t)                            # 72o
        shufb   $shift,$third,$third,$m_3               # 73o
        lqd     $second,16($ray)                        # 74o
        fma     $near_time_z,$near_time_z,$inverse_3,$shift_5 # 75e
        lqd     $first,0($ray)                          # 75o
        fcgt    $c_greater,$near_time_y,$near_time_x    # 76e
        hbrr    next_pair_back,next_pair                # 76o hint
        fma     $far_time_z,$far_time_z,$inverse_3,$shift # 77e
        lqd     $third,32($ray)                         # 77o
        fcgt    $c_greater_2,$far_time_x,$far_time_y    # 78e
        rotqby  $t,$t,$a_t                              # 78o
        selb    $near_time_x,$near_time_x,$near_time_y,$c_greater # 79e
        lqd     $child,96($a_node_2)                    # 79o
        selb    $far_time_x,$far_time_x,$far_time_y,$c_greater_2 # 80e
        stqx    $entry_2,$a_list,$found                 # 80o
        fcgt    $c_greater,$near_time_z,$near_time_x    # 81e
        lqx     $near_time_x_2,$a_node_2,$first         # 81o
        sf      $far_y,$second,$k_far_y                 # 82e
        shufb   $t,$t,$t,$m_0                           # 82o
        selb    $near_time_x,$near_time_x,$near_time_z,$c_greater # 83e
        lqx     $near_time_y,$a_node_2,$second          # 83o
        fcgt    $c_greater,$far_time_x,$far_time_z      # 84e
        lqx     $far_time_y,$a_node_2,$far_y            # 84o
        sf      $far_planes,$first,$k_far               # 85e
        shufb   $shift_2,$second,$second,$m_1           # 85o
        selb    $far_time_x,$far_time_x,$far_time_z,$c_greater # 86e
        shufb   $shift_3,$second,$second,$m_2           # 86o
        fs      $misses,$t,$near_time_x                 # 87e
        lqx     $far_time_x_2,$a_node_2,$far_planes     # 87o
        fs      $far_time_x_3,$far_time_x,$near_time_x  # 88e
        shufb   $inverse,$first,$first,$m_1             # 88o
        rotmi   $near_z,$first,-24                      # 89e
        shufb   $inverse_4,$first,$first,$m_2           # 89o
        rotmi   $far_z,$far_planes,-24                  # 90e
        shufb   $shift_6,$third,$third,$m_2             # 90o
        a       $child,$child,$base                     # 91e
        shufb   $shift_7,$third,$third,$m_1             # 91o
        fma     $near_time_x,$near_time_x_2,$inverse,$shift_2 # 92e
        shufb   $entry_3,$child_2,$ray_2,$m_entry+3     # 92o
        or      $misses,$misses,$far_time_x             # 93e
        lqx     $near_time_z,$a_node_2,$near_z          # 93o
        fma     $far_time_y,$far_time_y,$inverse_4,$shift_6 # 94e
        lqx     $far_time_z,$a_node_2,$far_z            # 94o
        or      $misses,$misses,$far_time_x_3           # 95e
        shufb   $entry,$child_2,$ray_2,$m_entry+1       # 95o
        fma     $near_time_y,$near_time_y,$inverse_4,$shift_3 # 96e
        shufb   $entry_4,$child_2,$ray_2,$m_entry+2     # 96o
        rotmai  $misses,$misses,-31                     # 97e
        rotqbyi $a_t,$ray,12                            # 97o
        fma     $far_time_x,$far_time_x_2,$inverse,$shift_7 # 98e
        shlqbyi $entry_3,$entry_3,0                     # 98o copy
        shufb   $shift,$third,$third,$m_3               # 99o
        shufb   $entry_2,$child,$ray,$m_entry           # 100o
        andc    $step,$k_step,$misses                   # 101e
        shufb   $shift_8,$second,$second,$m_3           # 101o
        nop     $127                                    # 102e pairing
        shufb   $inverse_3,$first,$first,$m_3           # 102o
        a       $found_2,$found,$step                   # 103e
        rotqbyi $step+1,$step,4                         # 103o
next_pair:
        ceq     $last,$a_node,$a_last                   # 0e
            lqd     $t,384($a_t)                        # 0o
            fma     $near_time_z,$near_time_z,$inverse_3,$shift_8 # 1e
            stqx    $entry,$a_list,$found_2             # 1o
            a       $found_2,$found_2,$step+1           # 2e
            shufb   $entry,$child,$ray,$m_entry+1       # 2o
            fma     $far_time_z,$far_time_z,$inverse_3,$shift # 3e
            shufb   $entry_5,$child,$ray,$m_entry+3     # 3o
            fcgt    $c_greater,$near_time_y,$near_time_x # 4e
            stqx    $entry_4,$a_list,$found_2           # 4o
            fcgt    $c_greater_3,$far_time_x,$far_time_y # 5e
            shufb   $entry_4,$child,$ray,$m_entry+2     # 5o
            selb    $near_time_x,$near_time_x,$near_time_y,$c_greater # 6e
        lqd     $ray,0($a_ray)                          # 6o
            selb    $far_time_x,$far_time_x,$far_time_y,$c_greater_3 # 7e
            rotqby  $t,$t,$a_t                          # 7o
            fcgt    $c_greater,$near_time_z,$near_time_x # 8e
            rotqbyi $step+2,$step,8                     # 8o
        and     $last_2,$last,$k_step                   # 9e
            rotqbyi $step+3,$step,12                    # 9o
            selb    $near_time_x,$near_time_x,$near_time_z,$c_greater # 10e
        lqd     $child,96($a_node)                      # 10o
            fcgt    $c_greater,$far_time_x,$far_time_z  # 11e
            shufb   $t,$t,$t,$m_0                       # 11o
            a       $found_2,$found_2,$step+2           # 12e
        lqd     $third,32($ray)                         # 12o
            selb    $far_time_x,$far_time_x,$far_time_z,$c_greater # 13e
        lqd     $second,16($ray)                        # 13o
            a       $found,$found_2,$step+3             # 14e
        lqd     $first,0($ray)                          # 14o
            fs      $misses,$t,$near_time_x             # 15e
        rotqbyi $a_t,$ray,12                            # 15o
        a       $child,$child,$base                     # 16e
            stqx    $entry_3,$a_list,$found_2           # 16o
            fs      $far_time_x_4,$far_time_x,$near_time_x # 17e
            shlqbyi $entry_3,$entry_5,0                 # 17o copy
        ai      $next,$a_node,112                       # 18e
            stqx    $entry_2,$a_list,$found             # 18o
        sf      $far_y,$second,$k_far_y                 # 19e
        shufb   $shift,$third,$third,$m_3               # 19o
        sf      $far_planes,$first,$k_far               # 20e
        shufb   $shift_8,$second,$second,$m_1           # 20o
        rotmi   $near_z,$first,-24                      # 21e
        shufb   $entry_2,$child,$ray,$m_entry           # 21o
        rotmi   $far_z,$far_planes,-24                  # 22e
        shufb   $shift_3,$second,$second,$m_2           # 22o
            or      $misses,$misses,$far_time_x         # 23e
        lqx     $near_time_x,$a_node,$first             # 23o
        a       $a_ray,$a_ray,$last_2                   # 24e
        lqx     $far_time_y,$a_node,$far_y              # 24o
            or      $misses,$misses,$far_time_x_4       # 25e
        shufb   $inverse,$first,$first,$m_1             # 25o
        ai      $left,$left,-1                          # 26e
        lqx     $far_time_x,$a_node,$far_planes         # 26o
            rotmai  $misses,$misses,-31                 # 27e
        shufb   $inverse_5,$first,$first,$m_2           # 27o
        nop     $127                                    # 28e pairing
        lqx     $near_time_y,$a_node,$second            # 28o
        fma     $near_time_x,$near_time_x,$inverse,$shift_8 # 29e
        shufb   $shift_8,$third,$third,$m_2             # 29o
        nop     $127                                    # 30e pairing
        lqx     $near_time_z,$a_node,$near_z            # 30o
            andc    $step,$k_step,$misses               # 31e
        lqx     $far_time_z,$a_node,$far_z              # 31o
        selb    $a_node,$next,$a_first,$last            # 32e
        shufb   $shift_9,$third,$third,$m_1             # 32o
        fma     $far_time_y,$far_time_y,$inverse_5,$shift_8 # 33e
        shufb   $shift_8,$second,$second,$m_3           # 33o
        fma     $near_time_y,$near_time_y,$inverse_5,$shift_3 # 34e
        shufb   $inverse_3,$first,$first,$m_3           # 34o
            a       $found_2,$found,$step               # 35e
            rotqbyi $step+1,$step,4                     # 35o
        fma     $far_time_x,$far_time_x,$inverse,$shift_9 # 36e
next_pair_back:
        brnz    $left,next_pair                         # 36o
next_pair_drain:
        fma     $near_time_z,$near_time_z,$inverse_3,$shift_8 # 0e
        lqd     $t,384($a_t)                            # 0o
        fma     $far_time_z,$far_time_z,$inverse_3,$shift # 1e
        hbr     mesh_few_rays_return,$lr                # 1o hint
        fcgt    $c_greater,$near_time_y,$near_time_x    # 2e
        rotqbyi $step+2,$step,8                         # 2o
        fcgt    $c_greater_3,$far_time_x,$far_time_y    # 3e
        rotqbyi $step+3,$step,12                        # 3o
        selb    $near_time_x,$near_time_x,$near_time_y,$c_greater # 4e
        shufb   $entry_5,$child,$ray,$m_entry+3         # 4o
        selb    $far_time_x,$far_time_x,$far_time_y,$c_greater_3 # 5e
        stqx    $entry,$a_list,$found_2                 # 5o
        fcgt    $c_greater,$near_time_z,$near_time_x    # 6e
        rotqby  $t,$t,$a_t                              # 6o
        fcgt    $c_greater_4,$far_time_x,$far_time_z    # 7e
        shufb   $entry,$child,$ray,$m_entry+1           # 7o
        selb    $near_time_x,$near_time_x,$near_time_z,$c_greater # 8e
        shufb   $entry_6,$child,$ray,$m_entry+2         # 8o
        selb    $far_time_x,$far_time_x,$far_time_z,$c_greater_4 # 9e
        shlqbyi $entry_7,$entry_5,0                     # 9o copy
        a       $found_2,$found_2,$step+1               # 10e
        shufb   $t,$t,$t,$m_0                           # 10o
        fs      $far_time_x_5,$far_time_x,$near_time_x  # 11e
        lnop                                            # 11o pairing
        a       $found_3,$found_2,$step+2               # 12e
        stqx    $entry_4,$a_list,$found_2               # 12o
        fs      $misses,$t,$near_time_x                 # 14e
        stqx    $entry_3,$a_list,$found_3               # 14o
        a       $found,$found_3,$step+3                 # 15e
        stqx    $entry_2,$a_list,$found                 # 17o
        or      $misses,$misses,$far_time_x             # 20e
        or      $misses,$misses,$far_time_x_5           # 22e
        rotmai  $misses,$misses,-31                     # 24e
        andc    $step,$k_step,$misses                   # 28e
        a       $found_2,$found,$step                   # 30e
        rotqbyi $step+1,$step,4                         # 30o
        rotqbyi $step+2,$step,8                         # 31o
        rotqbyi $step+3,$step,12                        # 32o
        stqx    $entry,$a_list,$found_2                 # 33o
        a       $found_2,$found_2,$step+1               # 34e
        a       $found_4,$found_2,$step+2               # 36e
        stqx    $entry_6,$a_list,$found_2               # 36o
        a       $found,$found_4,$step+3                 # 38e
        stqx    $entry_7,$a_list,$found_4               # 38o
        a       $a_first,$a_list,$found                 # 40e
mesh_few_rays_return:
        bi      $lr                                     # 40o
next_pair_short:
        ceq     $last,$a_node,$a_last                   # 0e
        lqd     $ray,0($a_ray)                          # 0o
        ai      $next,$a_node,112                       # 1e
        lqd     $child,96($a_node)                      # 1o
        and     $last_4,$last,$k_step                   # 2e
        ai      $left,$left,-1                          # 3e
        a       $a_ray,$a_ray,$last_4                   # 4e
        lqd     $first,0($ray)                          # 6o
        a       $child,$child,$base                     # 7e
        lqd     $second,16($ray)                        # 7o
        lqd     $third,32($ray)                         # 8o
        rotqbyi $a_t,$ray,12                            # 9o
        shufb   $entry,$child,$ray,$m_entry             # 10o
        shufb   $entry_8,$child,$ray,$m_entry+1         # 11o
        sf      $far_planes,$first,$k_far               # 12e
        lqx     $near_time_x,$a_node,$first             # 12o
        rotmi   $near_z,$first,-24                      # 13e
        lqx     $near_time_y,$a_node,$second            # 13o
        sf      $far_y,$second,$k_far_y                 # 14e
        lqx     $far_time_x,$a_node,$far_planes         # 14o
        rotmi   $far_z,$far_planes,-24                  # 15e
        shufb   $inverse,$first,$first,$m_1             # 15o
        lqx     $far_time_y,$a_node,$far_y              # 16o
        shufb   $shift,$second,$second,$m_1             # 17o
        shufb   $inverse_6,$first,$first,$m_2           # 18o
        shufb   $shift_9,$second,$second,$m_2           # 19o
        nop     $127                                    # 20e pairing
        lqx     $near_time_z,$a_node,$near_z            # 20o
        fma     $near_time_x,$near_time_x,$inverse,$shift # 21e
        shufb   $shift,$third,$third,$m_1               # 21o
        nop     $127                                    # 22e pairing
        shufb   $shift_5,$third,$third,$m_2             # 22o
        fma     $near_time_y,$near_time_y,$inverse_6,$shift_9 # 23e
        lqd     $t,384($a_t)                            # 23o
        nop     $127                                    # 24e pairing
        lqx     $far_time_z,$a_node,$far_z              # 24o
        fma     $far_time_x,$far_time_x,$inverse,$shift # 25e
        shufb   $inverse,$first,$first,$m_3             # 25o
        fma     $far_time_y,$far_time_y,$inverse_6,$shift_5 # 26e
        shufb   $shift,$second,$second,$m_3             # 26o
        selb    $a_node,$next,$a_first,$last            # 27e
        shufb   $shift_8,$third,$third,$m_3             # 27o
        nop     $127                                    # 28e pairing
        shufb   $entry_6,$child,$ray,$m_entry+2         # 28o
        fcgt    $c_greater,$near_time_y,$near_time_x    # 29e
        rotqby  $t,$t,$a_t                              # 29o
        fma     $near_time_z,$near_time_z,$inverse,$shift # 30e
        shufb   $entry_4,$child,$ray,$m_entry+3         # 30o
        fma     $far_time_z,$far_time_z,$inverse,$shift_8 # 31e
        stqx    $entry,$a_list,$found                   # 31o
        selb    $near_time_x,$near_time_x,$near_time_y,$c_greater # 32e
        lnop                                            # 32o pairing
        fcgt    $c_greater,$far_time_x,$far_time_y      # 33e
        shufb   $t,$t,$t,$m_0                           # 33o
        selb    $far_time_x,$far_time_x,$far_time_y,$c_greater # 35e
        fcgt    $c_greater,$near_time_z,$near_time_x    # 36e
        fcgt    $c_greater_5,$far_time_x,$far_time_z    # 37e
        selb    $near_time_x,$near_time_x,$near_time_z,$c_greater # 38e
        selb    $far_time_x,$far_time_x,$far_time_z,$c_greater_5 # 39e
        fs      $misses,$t,$near_time_x                 # 40e
        fs      $far_time_x_5,$far_time_x,$near_time_x  # 41e
        or      $misses,$misses,$far_time_x             # 46e
        or      $misses,$misses,$far_time_x_5           # 48e
        rotmai  $misses,$misses,-31                     # 50e
        andc    $step,$k_step,$misses                   # 54e
        lnop                                            # 54o pairing
        a       $found,$found,$step                     # 56e
        rotqbyi $step+1,$step,4                         # 56o
        rotqbyi $step+2,$step,8                         # 57o
        rotqbyi $step+3,$step,12                        # 58o
        stqx    $entry_8,$a_list,$found                 # 59o
        a       $found,$found,$step+1                   # 60e
        a       $found_2,$found,$step+2                 # 62e
        stqx    $entry_6,$a_list,$found                 # 62o
        a       $found,$found_2,$step+3                 # 64e
        stqx    $entry_4,$a_list,$found_2               # 64o
        nop     $127                                    # 65e pairing
        brnz    $left,next_pair_short                   # 65o
        a       $a_first,$a_list,$found                 # 66e
        bi      $lr                                     # 66o
endfunction mesh_few_rays
