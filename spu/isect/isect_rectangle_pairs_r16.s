# isect_rectangle_pairs_r16   nearest hit of packets' rays with parallelograms, by candidates
#   C       void isect_rectangle_pairs_r16(const struct candidate *, int count);
#   In      $3 candidates of objects that are rectangles, $4 count (0 is none); pointers 16-aligned
#   Out     the candidates' packets: t, object, where a hit has 0 < t < what was there
#   Uses    $3-$4, $10-$50   Saves  -   Stack  0   Calls  -
#   Domain  |direction| and |axis| about 1; distances from the corner below 2^60
#   Error   20 ulp of t, 5e-4 in u and v; edges from 1/100 of the distance to all of it, 30 degrees
#           or more apart; incidence within 84 degrees of the normal
#   Twin    lab/twins/src/rectangle_pairs.rs
#
# Like isect_rectangle_r16. But from the back, where the direction goes with the axis, it is hit
# only with SIDES_BOTH. A ray parallel to the plane gets a t that is 0 or beyond everything, so it
# misses.

        .include "work_unit.inc"
        .include "macros.inc"
        .include "pairs.inc"
        .include "rectangle_tmpl.inc"

        .set    NEXT,3
        registers a_candidate,count
        # constants
        .set    NEXT,10
        registers k_x,k_y,k_z,m_w,k_one,k_sign
        .set    NEXT,42
        registers a_controls
        # the candidate
        registers object
        .set    NEXT,43
        registers a_rectangle,a_packet
        .set    NEXT,44
        registers a_rays,both
        # temporaries
        registers outside,c_v
        .set    NEXT,47
        registers seen                                  # reused
        registers t,t_best,nearest
        .set    control,47                              # reused
        .set    ahead,39                                # n

        sign_controls_table

function isect_rectangle_pairs_r16
        biz     $count,$lr
        rectangle_masks
        load_constant $m_w,0x0c0d0e0f
        ilhu    $k_one,0x3f80
        ilhu    $k_sign,0x8000
        ila     $a_controls,sign_controls
next_rectangle:
        load_candidate
        load_both
        load_rectangle OBJECT_centre, OBJECT_axis, RECT_dual_u, RECT_dual_v
        splat   $object,$object,$k_x
    .irp row, 0,1,2,3
        plane_row \row, RAYS16
        outside_rectangle
        outside_if_behind $along
        xor     $t,$n,$k_sign
        keep_nearer \row
    .endr
        next_candidate next_rectangle
        bi      $lr
endfunction isect_rectangle_pairs_r16
