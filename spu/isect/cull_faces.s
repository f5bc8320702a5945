# cull_faces   of candidates whose objects are flat, those some ray of which may meet the seen side
#   C       struct candidate *cull_faces(const struct candidate *, int count, struct candidate *,
#                                        float along);
#   In      $3 candidates whose objects have gain 0 and a unit axis, $4 count (0 is none), $5 where
#           the list goes: elsewhere, or over the candidates; $6 1 if the rays go along their
#           bounds' axes, -1 if against them; pointers 16-aligned
#   Out     those candidates, in order; culled ones may be written after them, but nothing after as
#           many quadwords as there are candidates
#           $3 end of the list
#   Uses    $3-$4, $10-$35   Saves  -   Stack  0   Calls  -
#   Domain  bounds as bound_fan_r16 makes them, or bound_origins_r16; distances from 2^-60 to 2^60;
#           OBJECT_leave at least 2^-22 of the sum of the centre's components' magnitudes
#   Error   0: no candidate is left out whose plane a ray meets from a side that is seen, by the
#           numbers of the records
#   Twin    lab/twins/src/cull_faces.rs
#
# With n the object's axis:
#   g = axis.n                  all rays go with n if g > sine, and all against it if -g > sine
#   h = (apex - centre).n       all start in front of the plane if h > M, and at its back if -h > M
#   M = radius + 4 leave        starts within rounding of the plane count as on both sides
# The front is hit by rays that start in front of it and go against n. A one-sided candidate is
# therefore culled if all rays go with n, or if all start at the back. A candidate with SIDES_BOTH
# is culled if all rays go with n and start in front, or if all go against it and start at the back.
#
# Rays that go against their bound's axis end in its sphere. The bound then has their end points
# instead of their origins, so sides and directions are reversed.

        .include "work_unit.inc"
        .include "macros.inc"

        .set    NEXT,3
        registers a_first,count,a_list,along
        # constants
        .set    NEXT,10
        registers k_along
        registers k_leave                               # by lanes: 0, 4
        registers k_sixteen,m_first,m_third,m_outer,m_inner,m_w
        # state
        registers a_candidate
        registers found                                 # bytes of the list so far
        # the candidate
        registers candidate,a_bound,apart,normal
        registers own                                   # offset, leave, material, sides
        registers axis,limits
        # the lanes of g and of h
        registers terms,others
        registers with                                  # limit less what it limits
        registers against
        registers outer                                 # all go with n; all start at the back
        registers inner                                 # all start in front; all go against n
        registers both,drop,step
        # the candidate, loaded again instead of being kept in a register for so long; it is
        # overwritten only later
        registers a_again,again

        quadword_constants
first_words:
        .int    0x00010203,0x10111213,0x04050607,0x14151617
third_words:
        .int    0x08090a0b,0x18191a1b,0x80808080,0x80808080
outer_words:
        .int    0x00010203,0x14151617,0x80808080,0x80808080
inner_words:
        .int    0x04050607,0x10111213,0x80808080,0x80808080
leave_by_lane:
        .float  0,4,0,0

function cull_faces
        ori     $a_candidate,$a_first,0
        ori     $a_again,$a_first,0
        ori     $3,$a_list,0
        biz     $count,$lr
        splat_mask $m_w
        splat   $k_along,$along,$m_w
        load_constant $m_w,0x0c0d0e0f
        il      $k_sixteen,CANDIDATE_SIZE
        lqa     $k_leave,leave_by_lane
        lqa     $m_first,first_words
        lqa     $m_third,third_words
        lqa     $m_outer,outer_words
        lqa     $m_inner,inner_words
        il      $found,0
next_face:
        lqd     $candidate,0($a_candidate)
        rotqbyi $a_bound,$candidate,CANDIDATE_bound
        lqd     $own,OBJECT_offset($candidate)
        lqd     $normal,OBJECT_axis($candidate)
        lqd     $others,OBJECT_centre($candidate)
        lqd     $apart,BOUND_apex($a_bound)
        lqd     $axis,BOUND_axis($a_bound)
        lqd     $limits,BOUND_limits($a_bound)
        fs      $apart,$apart,$others
        fm      $apart,$apart,$normal
        fm      $axis,$axis,$normal
        shufb   $terms,$axis,$apart,$m_first
        shufb   $others,$axis,$apart,$m_third
        fa      $terms,$terms,$others
        rotqbyi $others,$terms,8
        fa      $terms,$terms,$others
        fma     $limits,$own,$k_leave,$limits
        fnms    $with,$terms,$k_along,$limits
        fma     $against,$terms,$k_along,$limits
        shufb   $outer,$with,$against,$m_outer
        shufb   $inner,$with,$against,$m_inner
        a       $both,$own,$own                         # SIDES_BOTH becomes the sign
        shufb   $both,$both,$both,$m_w
        orc     $inner,$inner,$both
        and     $drop,$outer,$inner
        orx     $drop,$drop
        rotmai  $drop,$drop,-31
        andc    $step,$k_sixteen,$drop
        lqd     $again,0($a_again)
        stqx    $again,$3,$found
        a       $found,$found,$step
        ai      $a_candidate,$a_candidate,CANDIDATE_SIZE
        ai      $a_again,$a_again,CANDIDATE_SIZE
        ai      $count,$count,-1
        brnz    $count,next_face
        a       $3,$3,$found
        bi      $lr
endfunction cull_faces
