# mesh_few_rays   of a leaf of a mesh, the children whose boxes some of a few rays meet, as candidates
#                 of the rays' packets
#   C       struct mesh_candidate *mesh_few_rays(const struct boxes *, int count,
#                       const vec_uint4 *rays, struct mesh_candidate *, const struct mesh_ray *,
#                       const struct mesh_candidate packets[2], int base, vec_uint4 *);
#   In      $3 the lowest nodes, $4 count, at least 1, $5 the rays' bits, at least one, $6 where
#           the list goes, $7 MESH_RAYs, $8 two quadwords: a candidate of the first packet, and
#           what is added for each further one, $9 what is added to each child's word, $10 space for
#           as many quadwords as there are rays and three more; pointers 16-aligned
#   Out     ray by ray and child by child, a candidate for each box that a ray meets: object is the
#           child's word plus $9, packet and bound are those of the ray's packet, near is anything;
#           three more quadwords may be written
#           $3 end of the list
#   Uses    $3-$79   Saves  -   Stack  0   Calls  -
#   Domain  records as mesh_rays_r16 makes them; boxes with a slack of 2^-19 of the largest
#           magnitude of their coordinates; distances from 2^-60 to 2^60
#   Error   0: no child is left out that a ray enters before it ends
#   Twin    lab/twins/src/mesh_rays.rs
#
# Each ray is tested with each node, in one loop: for a few rays that is quicker than to look for
# the nodes that they meet, level by level. The tests are those of mesh_filter_rays.

        .include "work_unit.inc"
        .include "macros.inc"
        .include "extremes.inc"
        .include "transpose.inc"

        .set    NEXT,3
        registers a_first,nodes,a_bits,a_list,a_rays,a_packets,base,a_buffer
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
        lqd     $rays,0($a_bits)
        splat_mask $m_0
        load_constant $m_1,0x04050607
        load_constant $m_2,0x08090a0b
        load_constant $m_3,0x0c0d0e0f
        load_constant $k_far,(BOXES_lo_z+BOXES_hi_z)<<24|(BOXES_lo_x+BOXES_hi_x)
        il      $k_far_y,BOXES_lo_y+BOXES_hi_y
        il      $k_step,MESH_CANDIDATE_SIZE
        mpyi    $a_last,$nodes,BOXES_SIZE
        a       $a_last,$a_last,$a_first
        ai      $a_last,$a_last,-BOXES_SIZE
        lqa     $m_low,transpose_first
        lqa     $m_high,transpose_last
        lqa     $k_numbers,ray_numbers
        ilhu    $k_first,0x8000
        shufb   $base,$base,$base,$m_0
        lqd     $start,0($a_packets)
        lqd     $part,16($a_packets)
        shufb   $packets,$start,$start,$m_1
        shufb   $bounds,$start,$start,$m_2
        shufb   $step_packet,$part,$part,$m_1
        shufb   $step_bound,$part,$part,$m_2
        shufb   $start,$a_rays,$a_rays,$m_0
        # The largest number of bits of a word.
        cntb    $left,$rays
        sumb    $left,$left,$left
        rotmi   $left,$left,-16
        rotqbyi $part,$left,8
        cgt     $none,$part,$left
        selb    $left,$left,$part,$none
        rotqbyi $part,$left,4
        cgt     $none,$part,$left
        selb    $left,$left,$part,$none
        sfi     $left,$left,0                           # counts up: there are few passes
        il      $listed,0
next_rays:
        clz     $number,$rays
        sfi     $bit,$number,0
        rotm    $bit,$k_first,$bit
        ceqi    $none,$rays,0
        andc    $rays,$rays,$bit
        andc    $step,$k_step,$none
        a       $number,$number,$k_numbers
        mpyi    $words,$number,MESH_RAY_SIZE
        a       $words,$words,$start
        rotmi   $part,$number,-4
        mpyu    $words+1,$part,$step_packet
        a       $words+1,$words+1,$packets
        mpyu    $words+2,$part,$step_bound
        a       $words+2,$words+2,$bounds
        andi    $part,$number,15
        shli    $part,$part,2
        a       $words+3,$words+1,$part                 # its t, but for the offset
        transpose words,words,turned,$m_low,$m_high
    .irp lane, 1,2,3
        rotqbyi $step+\lane,$step,4*\lane
    .endr
    .irp lane, 0,1,2,3
        stqx    $words+\lane,$a_buffer,$listed
        a       $listed,$listed,$step+\lane
    .endr
        ai      $left,$left,1
        brnz    $left,next_rays
        rotmi   $left,$listed,-4
        mpyu    $left,$left,$nodes
    .irp child, 0,1,2,3
        lqa     $m_entry+\child,child_of_node+16*\child
    .endr
        ori     $a_node,$a_first,0
        ori     $a_ray,$a_buffer,0
        il      $found,0
next_pair:
        lqd     $ray,0($a_ray)
        lqd     $first,MESH_RAY_planes($ray)
        lqd     $second,MESH_RAY_number($ray)
        lqd     $third,MESH_RAY_t($ray)
        rotqbyi $a_t,$ray,12
        lqd     $t,RAYS16_t($a_t)
        rotqby  $t,$t,$a_t
        shufb   $t,$t,$t,$m_0
        sf      $far_planes,$first,$k_far
        rotmi   $near_z,$first,-24
        rotmi   $far_z,$far_planes,-24
        sf      $far_y,$second,$k_far_y
        lqx     $near_time_x,$a_node,$first
        lqx     $near_time_y,$a_node,$second
        lqx     $near_time_z,$a_node,$near_z
        lqx     $far_time_x,$a_node,$far_planes
        lqx     $far_time_y,$a_node,$far_y
        lqx     $far_time_z,$a_node,$far_z
    .set    AXIS,1
    .irp axis, x,y,z
        shufb   $inverse,$first,$first,$m_0+AXIS
        shufb   $shift,$second,$second,$m_0+AXIS
        fma     $near_time_\axis,$near_time_\axis,$inverse,$shift
        shufb   $shift,$third,$third,$m_0+AXIS
        fma     $far_time_\axis,$far_time_\axis,$inverse,$shift
    .set    AXIS,AXIS+1
    .endr
        maximum $near_time_x,$near_time_y,$c_greater
        maximum $near_time_x,$near_time_z,$c_greater
        minimum_f4 $far_time_x,$far_time_y,$c_greater
        minimum_f4 $far_time_x,$far_time_z,$c_greater
        fs      $misses,$t,$near_time_x
        or      $misses,$misses,$far_time_x
        fs      $far_time_x,$far_time_x,$near_time_x
        or      $misses,$misses,$far_time_x
        rotmai  $misses,$misses,-31
        andc    $step,$k_step,$misses
    .irp lane, 1,2,3
        rotqbyi $step+\lane,$step,4*\lane
    .endr
        lqd     $child,BOXES_child($a_node)
        a       $child,$child,$base
    .irp lane, 0,1,2,3
        shufb   $entry,$child,$ray,$m_entry+\lane
        stqx    $entry,$a_list,$found
        a       $found,$found,$step+\lane
    .endr
        # The next node, or the first one and the next ray.
        ceq     $last,$a_node,$a_last
        ai      $next,$a_node,BOXES_SIZE
        selb    $a_node,$next,$a_first,$last
        and     $last,$last,$k_step
        a       $a_ray,$a_ray,$last
        ai      $left,$left,-1
        brnz    $left,next_pair
        a       $3,$a_list,$found
        bi      $lr
endfunction mesh_few_rays
