# filter_children_r16   of nodes' children, those that one of the packet's rays may meet
#   C       struct candidate *filter_children_r16(const struct candidate *, int count,
#                                                 struct candidate *);
#   In      $3 candidates as cull_nodes makes them with 4, $4 count (0 is none), $5 where the list
#           goes, which may be the same place; pointers 16-aligned
#   Out     candidates of such children, in order: object is the child, the rest the candidate's;
#           as many quadwords may be written as there are candidates
#           $3 end of the list
#   Uses    $3-$4, $10-$58   Saves  -   Stack  0   Calls  -
#   Domain  bounds as bound_origins_r16 makes them; |d| = 1 within 4 ulp; the radius of a child's
#           sphere with a slack of 2^-18 (|c| + R), c its centre, R its radius; of a lane without a
#           child, -FARTHEST; distances from 2^-60 to 2^60
#   Error   0: no child is left out that a ray of the packet meets
#   Twin    lab/twins/src/cull_nodes.rs
#
# For rays that go every way, whose cone lets through nearly everything. With f = c - origin, for
# each ray:
#   b = f.d                     along the ray
#   l = f - b d                 across it
# The ray misses if one of these is below 0:
#   S^2 - l.l                   it passes the sphere
#   S + b                       the sphere is behind the origin
# S is the radius and a slack for the origin, 2^-18 (|apex| + r), where |apex| is the sum of the
# components' magnitudes and r the radius of the packet's bound. Both slacks together are 32 ulp
# of |f|. The roundings add up to 16, half of them because of the length of d.

        .include "filter_tmpl.inc"

        .set    NEXT,3
        registers a_first                               # candidate
        registers count,a_list
        # constants
        .set    NEXT,10
        registers m_x,m_low,m_extent,m_entry,m_signs,m_halves,k_sign,k_slack,k_all
        # state
        registers a_candidate
        registers found                                 # children so far
        # the candidate
        registers candidate,a_bound,a_packet,extent,turned
        # the child
        registers m_lane                                # the shuffle that splats its word
        registers cx,cy,cz,reach,reach2,child,entry,offset
        # the rays
        registers ox,oy,oz,dx,dy,dz,fx,fy,fz,b
        registers disc                                  # to 48
        .set    NEXT,disc+4
        registers ahead                                 # to 52
        .set    NEXT,ahead+4
        registers t                                     # to 56
        .set    NEXT,t+4
        registers signs,low,any
        # the candidate, loaded again instead of being kept in a register for so long
        registers again

        filter_tables .rodata
signs_of_two:
        .int    0x0004080c,0x1014181c,0x0004080c,0x1014181c
halves: .int    0x00010203,0x04050607,0x18191a1b,0x1c1d1e1f

# The top bytes of sixteen words.
.macro  top_bytes out:req, words:req
        shufb   \out,$\words,$\words+1,$m_signs
        shufb   $low,$\words+2,$\words+3,$m_signs
        shufb   \out,\out,$low,$m_halves
.endm

function filter_children_r16
        ori     $a_candidate,$a_first,0
        ori     $3,$a_list,0
        biz     $count,$lr
        il      $found,0
        lqa     $m_extent,extent_words
        lqa     $m_entry,entry_words
        lqa     $m_signs,signs_of_two
        lqa     $m_halves,halves
        ilhu    $k_sign,0x8000
        ilhu    $k_slack,0x3680                         # 2^-18
        load_constant $k_all,0xffff
        load_constant $m_x,0x00010203
        load_constant $m_low,0x03030303
next_child:
        filter_child
        lqd     $reach,NODE_radius($candidate)
        shufb   $reach,$reach,$reach,$m_lane
        fma     $reach,$extent,$k_slack,$reach
        fm      $reach2,$reach,$reach
    .irp axis, x,y,z
        lqd     $c\axis,NODE_\axis($candidate)
        shufb   $c\axis,$c\axis,$c\axis,$m_lane
    .endr
    .irp row, 0,1,2,3
    .irp axis, x,y,z
        lqd     $o\axis,RAYS16_origin_\axis+16*\row($a_packet)
        lqd     $d\axis,RAYS16_direction_\axis+16*\row($a_packet)
        fs      $f\axis,$c\axis,$o\axis
    .endr
        lqd     $t+\row,RAYS16_t+16*\row($a_packet)
        fm      $b,$fx,$dx
        fma     $b,$fy,$dy,$b
        fma     $b,$fz,$dz,$b
        fa      $ahead+\row,$b,$reach
        fnms    $fx,$b,$dx,$fx
        fnms    $fy,$b,$dy,$fy
        fnms    $fz,$b,$dz,$fz
        fnms    $disc+\row,$fx,$fx,$reach2
        fnms    $disc+\row,$fy,$fy,$disc+\row
        fnms    $disc+\row,$fz,$fz,$disc+\row
    .endr
        top_bytes $signs,disc
        top_bytes $any,ahead
        or      $signs,$signs,$any
        top_bytes $any,t
        or      $signs,$signs,$any
        rotqbii $signs,$signs,1                         # signs to the bytes' last bits
        gbb     $signs,$signs
        clgt    $any,$k_all,$signs
        filter_list NODE
        bi      $lr
endfunction filter_children_r16
