# mesh_list_hits_r16   gives each triangle of a mesh that packets have hit a patch
#   C       struct patch *mesh_list_hits_r16(struct rays16 *, int count, struct patch *,
#                                            vec_uint4 *none);
#   In      $3 RAYS16, consecutive, $4 count (0 is none), $5 the first patch, $6 a
#           quadword that gets anything; pointers 16-aligned
#   Out     the packets' objects: for triangles of a mesh, their patches; others stay as they are
#           the patches' first quadwords: in all words, the object that was there
#           $3 end of the patches
#   Uses    $3-$6, $10-$79   Saves  -   Stack  0   Calls  -
#   Domain  any objects
#   Error   0
#   Twin    lab/twins/src/mesh_patches.rs
#
# The loop counts up, so that it isn't pipelined. Pipelined it would take 86 cycles a packet
# instead of 134, but 2.8 KB of local store instead of 0.8.
#
# A ray gets the patch of its neighbour to the left or above, if they have hit the same triangle.
# So a packet may have several patches of a triangle, but only one if all rays have hit it.

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
        ori     $a_packet,$a_rays,0
        ori     $3,$a_patch,0
        biz     $count,$lr
        sfi     $count,$count,0
        il      $k_size,PATCH_SIZE
        splat_mask $m_splat
        load_constant $m_last,0x0c0d0e0f
        splat   $a_none,$a_none,$m_splat
    .irp lane, 0,1,2,3
        load_constant $m_lane+\lane,0x00010203+0x04040404*\lane
    .endr
        splat   $next_patch,$a_patch,$m_splat
next_packet:
    .irp row, 0,1,2,3
        lqd     $object,RAYS16_object+16*\row($a_packet)
        rotqmbyi $left,$object,-4
        ceq     $c_left,$object,$left
        cgti    $c_other,$object,-1
        or      $first,$c_left,$c_other
    .if \row
        ceq     $c_above,$object,$row_before
        or      $first,$first,$c_above
    .endif
        andc    $first,$k_size,$first                   # a patch for each ray with a new triangle
        # The patches of the row up to each lane.
        rotqmbyi $t_shift,$first,-4
        a       $to_here,$first,$t_shift
        rotqmbyi $t_shift,$to_here,-8
        a       $to_here,$to_here,$t_shift
        shufb   $more,$to_here,$to_here,$m_last
        sf      $to_here,$first,$to_here
        a       $patch,$next_patch,$to_here
        a       $next_patch,$next_patch,$more
    .if \row
        selb    $patch,$patch,$patch_above,$c_above
    .endif
        selb    $patch,$patch,$object,$c_other
    .rept   3
        rotqmbyi $t_shift,$patch,-4
        selb    $patch,$patch,$t_shift,$c_left
    .endr
        stqd    $patch,RAYS16_object+16*\row($a_packet)
        selb    $scattered,$patch,$a_none,$c_other
    .irp lane, 0,1,2,3
        rotqbyi $a_lane,$scattered,4*\lane
        splat   $lane,$object,$m_lane+\lane
        stqd    $lane,0($a_lane)
    .endr
        ori     $row_before,$object,0
        ori     $patch_above,$patch,0
    .endr
    .rept   2                                           # ai reaches to 511
        ai      $a_packet,$a_packet,RAYS16_SIZE/2
    .endr
        ai      $count,$count,1
        brnz    $count,next_packet
        ori     $3,$next_patch,0
        bi      $lr
endfunction mesh_list_hits_r16
