# cuts_rays_r16   lets primary rays hit the ground where cuts have found it
#   C       void cuts_rays_r16(struct rays16 *, int count, const vec_float4 *ahead,
#                                unsigned ground);
#   In      $3 rays, consecutive; $4 packets (at least 1); $5 the horizontal axis of the view: x, z;
#           $6 address of the ground's OBJECT; pointers 16-aligned
#   Out     t and object of rays whose pixel has a distance above 0
#   Uses    $3-$30   Saves  -   Stack  0   Calls  -
#   Domain  the four pixels of a row are one after the other; directions not across the axis
#   Error   4 ulp of t
#   Twin    lab/twins/src/cuts.rs
#
# The loop counts up, so that it isn't pipelined, which would take more local store.

        .include "work_unit.inc"
        .include "macros.inc"
        .include "reciprocal.inc"
        .include "height.inc"

        .set    NEXT,3
        registers a_rays,count,a_ahead,ground
        registers m_first,m_pair,m_four,k_one,ahead_x,ahead_z
        registers a_pixels,q0,q1,q2,q3,x,z,inverse,t_y,t_e,t,c_hit,object

        .section .rodata.cuts,"a",@progbits
        .align  4
first_two:
        .int    0x00010203,0x10111213,0x80808080,0x80808080
both:   .int    0x00010203,0x04050607,0x10111213,0x14151617

function cuts_rays_r16
        splat_mask $m_first
        lqa     $m_pair,first_two
        lqa     $m_four,both
        ilhu    $k_one,0x3f80
        lqd     $t,0($a_ahead)
        splat   $ahead_x,$t,$m_first
        rotqbyi $t,$t,4
        splat   $ahead_z,$t,$m_first
        splat   $ground,$ground,$m_first
        sfi     $count,$count,0
next_packet:
    .irp row, 0,1,2,3
        lqd     $a_pixels,RAYS16_pixel+16*\row($a_rays)
        lqd     $x,RAYS16_direction_x+16*\row($a_rays)
        lqd     $z,RAYS16_direction_z+16*\row($a_rays)
        lqd     $t,RAYS16_t+16*\row($a_rays)
        lqd     $object,RAYS16_object+16*\row($a_rays)
        fm      $x,$x,$ahead_x
        fma     $x,$z,$ahead_z,$x
        reciprocal_f4 $inverse,$x,$t_y,$t_e,$k_one
    .irp lane, 0,1,2,3
        lqd     $q\lane,16*\lane($a_pixels)
    .endr
        shufb   $q0,$q0,$q1,$m_pair
        shufb   $q2,$q2,$q3,$m_pair
        shufb   $q0,$q0,$q2,$m_four                     # distances along the axis
        rotmai  $t_e,$t,-31                             # rays that are not there
        il      $t_y,0
        fcgt    $c_hit,$q0,$t_y
        andc    $c_hit,$c_hit,$t_e
        fm      $q0,$q0,$inverse
        selb    $t,$t,$q0,$c_hit
        selb    $object,$object,$ground,$c_hit
        stqd    $t,RAYS16_t+16*\row($a_rays)
        stqd    $object,RAYS16_object+16*\row($a_rays)
    .endr
        il      $t_y,RAYS16_SIZE
        a       $a_rays,$a_rays,$t_y
        ai      $count,$count,1
        brnz    $count,next_packet
        bi      $lr
endfunction cuts_rays_r16
