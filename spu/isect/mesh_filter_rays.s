# mesh_filter_rays   of a block of a mesh, the children whose boxes some rays of a batch meet, and
#                    which rays these are
#   C       struct mesh_visit *mesh_filter_rays(const struct boxes *, int count, vec_uint4 *rays,
#                       struct mesh_visit *, struct mesh_ray *, const struct rays16 *,
#                       vec_uint4 *);
#   In      $3 the block's BOXES, $4 count, at least 1, $5 bits of the rays that are tested, with
#           space for a quadword of each further node and three more, $6 where the visits go, $7
#           MESH_RAYs, $8 their packets, $9 space for 131 quadwords; pointers 16-aligned
#   Out     MESH_VISITs of the lowest nodes' children that rays meet, in order; three more may be
#           written
#           $3 their end, $4 how often a ray was tested with a node
#   Uses    $3-$79   Saves  -   Stack  0   Calls  -
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

        .include "work_unit.inc"
        .include "macros.inc"
        .include "extremes.inc"

        .set    NEXT,3
        registers a_node,nodes,a_bits,a_visits,a_rays,a_packets,a_buffer
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
# The record's address, and after it that of the ray's t.
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
        splat_mask $m_0
        load_constant $m_1,0x04050607
        load_constant $m_2,0x08090a0b
        load_constant $m_3,0x0c0d0e0f
        load_constant $k_far,(BOXES_lo_z+BOXES_hi_z)<<24|(BOXES_lo_x+BOXES_hi_x)
        il      $k_far_y,BOXES_lo_y+BOXES_hi_y
        lqa     $k_bit,one_bit
        load_constant $k_most,0x7fffffff
        il      $k_visit,MESH_VISIT_SIZE
        shufb   $a_rays,$a_rays,$a_rays,$m_0
        ai      $a_packets,$a_packets,RAYS16_t
        shufb   $a_packets,$a_packets,$a_packets,$m_0
        ai      $a_next,$a_bits,16
        shli    $a_end,$nodes,4
        a       $a_end,$a_end,$a_bits
        ai      $a_visit_bits,$a_visits,MESH_VISIT_rays
        il      $tests,0
        il      $found,0
        il      $of_root,1
next_node:
        lqd     $rays,0($a_bits)
        orx     $left,$rays
        ori     $near,$k_most,0
    .irp child, 0,1,2,3
        il      $met+\child,0
    .endr
        brz     $left,tested
        # The rays' records, one of each word in a pass. The largest number of bits is that of passes.
        cntb    $left,$rays
        sumb    $left,$left,$left
        rotmi   $left,$left,-16
        rotqbyi $part,$left,8
        cgt     $none,$part,$left
        selb    $left,$left,$part,$none
        rotqbyi $part,$left,4
        cgt     $none,$part,$left
        selb    $left,$left,$part,$none
    .irp lane, 0,1,2,3
        lqa     $m_entry+\lane,addresses+16*\lane
    .endr
        ilhu    $k_first,0x8000
        il      $k_step,16
        lqa     $k_numbers,ray_numbers
        il      $k_packet,RAYS16_SIZE
        il      $listed,0
next_rays:
        clz     $number,$rays
        sfi     $bit,$number,0
        rotm    $bit,$k_first,$bit
        ceqi    $none,$rays,0
        andc    $rays,$rays,$bit
        andc    $step,$k_step,$none
        a       $number,$number,$k_numbers
        mpyi    $address,$number,MESH_RAY_SIZE
        a       $address,$address,$a_rays
        rotmi   $a_t,$number,-4
        mpyu    $a_t,$a_t,$k_packet
        andi    $part,$number,15
        shli    $part,$part,2
        a       $a_t,$a_t,$part
        a       $a_t,$a_t,$a_packets
    .irp lane, 1,2,3
        rotqbyi $step+\lane,$step,4*\lane
    .endr
    .irp lane, 0,1,2,3
        shufb   $entry,$address,$a_t,$m_entry+\lane
        stqx    $entry,$a_buffer,$listed
        a       $listed,$listed,$step+\lane
    .endr
        ai      $left,$left,-1
        brnz    $left,next_rays
        rotmi   $left,$listed,-4
        a       $tests,$tests,$left
        brz     $of_root,up_to_date
        il      $of_root,0
        ori     $listed,$left,0
        ori     $a_list,$a_buffer,0
        ori     $a_again,$a_buffer,0
        lqa     $near_time_z,t_first
next_t: lqd     $record,0($a_list)
        rotqbyi $a_t,$record,4
        lqd     $t,0($a_t)
        rotqby  $t,$t,$a_t
        lqd     $third,MESH_RAY_t($record)
        shufb   $third,$t,$third,$near_time_z
        lqd     $again,0($a_again)
        stqd    $third,MESH_RAY_t($again)
        ai      $a_list,$a_list,16
        ai      $a_again,$a_again,16
        ai      $left,$left,-1
        brnz    $left,next_t
        ori     $left,$listed,0
up_to_date:
        ori     $a_list,$a_buffer,0
next_ray:
        lqd     $record,0($a_list)
        lqd     $second,MESH_RAY_number($record)
        lqd     $third,MESH_RAY_t($record)
        lqd     $first,MESH_RAY_planes($record)
        sf      $far_planes,$first,$k_far
        rotqmbyi $near_z,$first,-3
        rotqmbyi $far_z,$far_planes,-3
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
        shufb   $misses,$third,$third,$m_0
        maximum $near_time_x,$near_time_y,$c_greater
        maximum $near_time_x,$near_time_z,$c_greater
        minimum_f4 $far_time_x,$far_time_y,$c_greater
        minimum_f4 $far_time_x,$far_time_z,$c_greater
        fs      $misses,$misses,$near_time_x
        or      $misses,$misses,$far_time_x
        fs      $far_time_x,$far_time_x,$near_time_x
        or      $misses,$misses,$far_time_x
        cgti    $hit,$misses,-1
        fcgt    $c_greater,$near,$near_time_x
        and     $c_greater,$c_greater,$hit
        selb    $near,$near,$near_time_x,$c_greater
        rotqmbyi $ray_bit,$second,-3
        shlqbybi $misses,$k_bit,$ray_bit
        shlqbi  $ray_bit,$misses,$ray_bit
    .irp child, 0,1,2,3
        shufb   $misses,$hit,$hit,$m_0+\child
        selb    $met+\child,$met+\child,$misses,$ray_bit
    .endr
        ai      $a_list,$a_list,16
        ai      $left,$left,-1
        brnz    $left,next_ray
tested: lqd     $child,BOXES_child($a_node)
        cgt     $left,$a_end,$a_next
        brnz    $left,upper
        # The children of a lowest node that have rays.
    .irp child, 0,1,2,3
        lqa     $entry,child_and_near+16*\child
        shufb   $entry,$child,$near,$entry
        stqx    $entry,$a_visits,$found
        stqx    $met+\child,$a_visit_bits,$found
        orx     $part,$met+\child
        ceqi    $part,$part,0
        andc    $part,$k_visit,$part
        a       $found,$found,$part
    .endr
next:   ai      $a_bits,$a_bits,16
        ai      $a_node,$a_node,BOXES_SIZE
        ai      $nodes,$nodes,-1
        brnz    $nodes,next_node
        a       $3,$a_visits,$found
        ori     $4,$tests,0
        bi      $lr

        # The nodes below, which follow one another.
upper:
    .irp child, 0,1,2,3
        stqd    $met+\child,16*\child($a_next)
    .endr
        ceqi    $child,$child,0
        gb      $child,$child
        cntb    $child,$child
        sfi     $child,$child,4
        shli    $child,$child,4
        a       $a_next,$a_next,$child
        br      next
endfunction mesh_filter_rays
