# same_objects_r16   which packets' rays have all hit the same object
#   C       unsigned int same_objects_r16(const struct rays16 *, int count);
#   In      $3 rays, one behind the other, 16-aligned, $4 packets (1 to 32)
#   Out     $3 a bit a packet, the last packet's the lowest
#   Uses    $2-$18, $79   Saves  -   Stack  0   Calls  -
#   Domain  any objects
#   Error   0
#   Twin    lab/twins/src/surfaces.rs
# Scheduled by spu schedule from same_objects_r16.s

        .include "work_unit.inc"
        .include "macros.inc"

        .set    NEXT,3
        registers a_rays,count
        # constants
        .set    NEXT,10
        registers m_splat,step
        # state
        registers same
        # a packet
        registers object0,object1,object2,object3,object,bits

function same_objects_r16
        .set count_2,79; .set a_rays_2,2; .set object0_2,6; .set object1_2,7; .set object2_2,8
        .set object3_2,9; .set object0_3,5; .set object_2,13; .set object0_4,2; .set object1_3,6
        .set object2_3,7; .set object3_3,8; .set object2_4,2; .set bits_2,6; .set same_2,2
        clgti   $count_2,$count,2                       # 0e at least as many passes as overlap
        ila     $m_splat,0x10203                        # 1e
        il      $step,640                               # 2e
        lnop                                            # 2o pairing
        il      $same,0                                 # 3e
        brz     $count_2,next_packet_short              # 3o too few passes
        a       $a_rays_2,$a_rays,$step                 # 4e
        lqd     $object0_2,448($a_rays)                 # 4o
        ai      $count,$count,-1                        # 5e
        hbrr    next_packet_back,next_packet            # 5o hint
        nop     $127                                    # 6e pairing
        lqd     $object1_2,464($a_rays)                 # 6o
        ai      $count,$count,-1                        # 7e
        lqd     $object2_2,480($a_rays)                 # 7o
        nop     $127                                    # 8e pairing
        lqd     $object3_2,496($a_rays)                 # 8o
        a       $a_rays,$a_rays_2,$step                 # 9e
        lqd     $object0_3,448($a_rays_2)               # 9o
        shufb   $object_2,$object0_2,$object0_2,$m_splat # 10o
        lqd     $object1,464($a_rays_2)                 # 11o
        lqd     $object2,480($a_rays_2)                 # 12o
        lqd     $object3,496($a_rays_2)                 # 13o
        ceq     $object0_4,$object0_2,$object_2         # 14e
        lnop                                            # 14o pairing
        ceq     $object1_3,$object1_2,$object_2         # 15e
        shufb   $object,$object0_3,$object0_3,$m_splat  # 15o
        ceq     $object2_3,$object2_2,$object_2         # 16e
        ceq     $object3_3,$object3_2,$object_2         # 17e
        and     $object0,$object0_4,$object1_3          # 18e
        and     $object2_4,$object2_3,$object3_3        # 19e
        and     $object0,$object0,$object2_4            # 21e
        gb      $bits_2,$object0                        # 23o
next_packet:
            ceq     $object0,$object0_3,$object         # 0e
            lnop                                        # 0o pairing
            a       $same_2,$same,$same                 # 1e
        lqd     $object0_3,448($a_rays)                 # 1o
            ceq     $object1,$object1,$object           # 2e
            ceq     $object2,$object2,$object           # 3e
            ceq     $object3,$object3,$object           # 4e
            and     $object0,$object0,$object1          # 5e
            and     $object2,$object2,$object3          # 6e
        lqd     $object1,464($a_rays)                   # 6o
        ai      $count,$count,-1                        # 7e
        shufb   $object,$object0_3,$object0_3,$m_splat  # 7o
            and     $object0,$object0,$object2          # 8e
        lqd     $object2,480($a_rays)                   # 8o
            ceqi    $bits,$bits_2,15                    # 9e true is -1
        lqd     $object3,496($a_rays)                   # 9o
        a       $a_rays,$a_rays,$step                   # 10e
            gb      $bits_2,$object0                    # 10o
            sf      $same,$bits,$same_2                 # 11e
next_packet_back:
        brnz    $count,next_packet                      # 11o
next_packet_drain:
        ceq     $object0,$object0_3,$object             # 0e
        hbr     same_objects_r16_return,$lr             # 0o hint
        ceq     $object1,$object1,$object               # 1e
        ceq     $object2,$object2,$object               # 2e
        ceq     $object3,$object3,$object               # 3e
        and     $object0,$object0,$object1              # 4e
        and     $object2,$object2,$object3              # 5e
        a       $same_2,$same,$same                     # 6e
        and     $object0,$object0,$object2              # 7e
        ceqi    $bits,$bits_2,15                        # 8e true is -1
        gb      $bits_2,$object0                        # 9o
        sf      $same,$bits,$same_2                     # 10e
        a       $same_2,$same,$same                     # 12e
        ceqi    $bits,$bits_2,15                        # 13e true is -1
        sf      $same,$bits,$same_2                     # 15e
        lnop                                            # 15o pairing
        ori     $a_rays,$same,0                         # 17e
same_objects_r16_return:
        bi      $lr                                     # 17o
next_packet_short:
        a       $same,$same,$same                       # 0e
        lqd     $object0,448($a_rays)                   # 0o
        ai      $count,$count,-1                        # 1e
        lqd     $object1,464($a_rays)                   # 1o
        lqd     $object2,480($a_rays)                   # 2o
        lqd     $object3,496($a_rays)                   # 3o
        a       $a_rays,$a_rays,$step                   # 4e
        shufb   $object,$object0,$object0,$m_splat      # 6o
        ceq     $object0,$object0,$object               # 10e
        ceq     $object1,$object1,$object               # 11e
        ceq     $object2,$object2,$object               # 12e
        ceq     $object3,$object3,$object               # 13e
        and     $object0,$object0,$object1              # 14e
        and     $object2,$object2,$object3              # 15e
        and     $object0,$object0,$object2              # 17e
        gb      $bits,$object0                          # 19o
        ceqi    $bits,$bits,15                          # 23e true is -1
        lnop                                            # 23o pairing
        sf      $same,$bits,$same                       # 25e
        brnz    $count,next_packet_short                # 25o
        ori     $a_rays,$same,0                         # 27e
        bi      $lr                                     # 27o
endfunction same_objects_r16
