# same_objects_r16   which packets' rays have all hit the same object
#   C       unsigned int same_objects_r16(const struct rays16 *, int count);
#   In      $3 rays, consecutive, 16-aligned, $4 packets (1 to 32)
#   Out     $3 a bit a packet, the last packet's the lowest
#   Uses    $3-$4, $10-$20   Saves  -   Stack  0   Calls  -
#   Domain  any objects
#   Error   0
#   Twin    lab/twins/src/surfaces.rs

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
        splat_mask $m_splat
        il      $step,RAYS16_SIZE
        il      $same,0
next_packet:
    .irp row, 0,1,2,3
        lqd     $object\row,RAYS16_object+16*\row($a_rays)
    .endr
        splat   $object,$object0,$m_splat
    .irp row, 0,1,2,3
        ceq     $object\row,$object\row,$object
    .endr
        and     $object0,$object0,$object1
        and     $object2,$object2,$object3
        and     $object0,$object0,$object2
        gb      $bits,$object0
        ceqi    $bits,$bits,15                          # true is -1
        a       $same,$same,$same
        sf      $same,$bits,$same
        a       $a_rays,$a_rays,$step
        ai      $count,$count,-1
        brnz    $count,next_packet
        ori     $3,$same,0
        bi      $lr
endfunction same_objects_r16
