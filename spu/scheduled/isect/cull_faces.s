# cull_faces   of candidates whose objects are flat, those some ray of which may meet the seen side
#   C       struct candidate *cull_faces(const struct candidate *, int count, struct candidate *,
#                                        float along);
#   In      $3 candidates whose objects have gain 0 and a unit axis, $4 count (0 is none), $5 where
#           the list goes: elsewhere, or over the candidates; $6 1 if the rays go along their
#           bounds' axes, -1 if against them; pointers 16-aligned
#   Out     those candidates, in order; behind them what is left out may be written, but nothing
#           behind as many quadwords as there are candidates
#           $3 behind the list
#   Uses    $2-$38, $79   Saves  -   Stack  0   Calls  -
#   Domain  bounds as bound_fan_r16 makes them, or bound_origins_r16; distances from 2^-60 to 2^60;
#           OBJECT_leave at least 2^-20 of the sum of the centre's components' magnitudes
#   Error   0: no candidate is left out whose plane a ray meets from a side that is seen, by the
#           numbers of the records
#   Twin    lab/twins/src/cull_faces.rs
#
# With n the object's axis:
#   g = axis.n                  all rays go with n if g > sine, and all against it if -g > sine
#   h = (apex - centre).n       all start in front of the plane if h > M, and behind it if -h > M
#   M = radius + leave          starts within rounding of the plane count as on both sides
# The front is hit by rays that start in front of it and go against n. A one-sided candidate is
# therefore culled if all rays go with n, or if all start behind. A candidate with SIDES_BOTH is
# culled if all rays go with n and start in front, or if all go against it and start behind.
#
# Rays that go against their bound's axis end in its sphere. The bound then has their end points
# instead of their origins, so sides and directions are reversed.
# Scheduled by spu schedule from cull_faces.s

        .include "work_unit.inc"
        .include "macros.inc"

        .set    NEXT,3
        registers a_first,count,a_list,along
        # constants
        .set    NEXT,10
        registers k_along
        registers k_leave                               # by lanes: 0, 1
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
        registers outer                                 # all go with n; all start behind
        registers inner                                 # all start in front; all go against n
        registers both,drop,step
        # the candidate, loaded again instead of being kept in a register for so long; it is
        # overwritten only later
        registers a_again,again

        .section .rodata
        .align  4
first_words:
        .int    0x00010203,0x10111213,0x04050607,0x14151617
third_words:
        .int    0x08090a0b,0x18191a1b,0x80808080,0x80808080
outer_words:
        .int    0x00010203,0x14151617,0x80808080,0x80808080
inner_words:
        .int    0x04050607,0x10111213,0x80808080,0x80808080
leave_by_lane:
        .float  0,1,0,0

function cull_faces
        .set m_w_2,2; .set count_2,79; .set a_candidate_2,2; .set candidate_2,2
        .set a_candidate_3,5; .set candidate_3,6; .set a_candidate_4,7; .set others_2,8
        .set a_bound_2,9; .set others_3,22; .set apart_2,23; .set a_bound_3,24; .set apart_3,25
        .set normal_2,26; .set axis_2,27; .set normal_3,28; .set apart_4,8; .set axis_3,23
        .set others_4,29; .set normal_4,30; .set axis_4,31; .set candidate_4,5; .set own_2,20
        .set limits_2,21; .set own_3,2; .set limits_3,9; .set axis_5,29; .set candidate_5,7
        .set a_bound_4,26; .set both_2,28; .set others_5,31; .set limits_4,20; .set terms_2,8
        .set both_3,21; .set others_6,27; .set terms_3,22; .set limits_5,2; .set others_7,9
        .set own_4,6; .set terms_4,25; .set apart_5,9; .set others_8,23; .set limits_6,24
        .set a_bound_5,31; .set own_5,5; .set limits_7,22; .set others_9,6; .set others_10,24
        .set with_2,30; .set apart_6,32; .set against_2,38; .set axis_6,20; .set with_3,34
        .set against_3,27; .set others_11,2; .set outer_2,2; .set inner_2,6; .set inner_3,9
        .set limits_8,7; .set drop_2,2; .set both_4,9; .set limits_9,5; .set apart_7,7
        .set drop_3,4; .set a_again_2,2; .set both_5,24; .set a_again_3,27; .set a_again_4,29
        .set apart_8,6; .set axis_7,7; .set outer_3,25; .set limits_10,4; .set drop_4,21
        .set others_12,5; .set terms_5,6; .set terms_6,2; .set with_4,5; .set drop_5,6
        ori     $a_candidate,$a_first,0                 # 0e
        ori     $a_again,$a_first,0                     # 1e
        ori     $a_first,$a_list,0                      # 2e
        biz     $count,$lr                              # 2o
        ila     $m_w_2,0x10203                          # 3e
        lqa     $k_leave,leave_by_lane                  # 3o
        ilhu    $m_w,0xc0d                              # 4e
        lqa     $m_first,first_words                    # 4o
        clgti   $count_2,$count,6                       # 5e at least as many passes as overlap
        lqa     $m_third,third_words                    # 5o
        iohl    $m_w,0xe0f                              # 6e
        lqa     $m_outer,outer_words                    # 6o
        il      $k_sixteen,16                           # 7e
        lqa     $m_inner,inner_words                    # 7o
        il      $found,0                                # 8e
        shufb   $k_along,$along,$along,$m_w_2           # 8o
        nop     $127                                    # 9e pairing
        brz     $count_2,next_face_short                # 9o too few passes
        ai      $a_candidate_2,$a_candidate,16          # 10e
        lqd     $candidate,0($a_candidate)              # 10o
        ai      $count,$count,-1                        # 11e
        lqd     $again,0($a_again)                      # 11o
        ai      $a_candidate,$a_candidate_2,16          # 12e
        lqd     $candidate_2,0($a_candidate_2)          # 12o
        ai      $count,$count,-1                        # 13e
        lnop                                            # 13o pairing
        ai      $a_candidate_3,$a_candidate,16          # 14e
        lqd     $candidate_3,0($a_candidate)            # 14o
        ai      $count,$count,-1                        # 15e
        lnop                                            # 15o pairing
        ai      $a_candidate_4,$a_candidate_3,16        # 16e
        rotqbyi $a_bound,$candidate,8                   # 16o
        ai      $count,$count,-1                        # 17e
        lqd     $others_2,0($candidate)                 # 17o
        ai      $a_candidate,$a_candidate_4,16          # 18e
        rotqbyi $a_bound_2,$candidate_2,8               # 18o
        ai      $count,$count,-1                        # 19e
        lqd     $others_3,0($candidate_2)               # 19o
        ai      $a_again,$a_again,16                    # 20e
        lqd     $apart_2,160($a_bound)                  # 20o
        ai      $count,$count,-1                        # 21e
        rotqbyi $a_bound_3,$candidate_3,8               # 21o
        lqd     $apart_3,160($a_bound_2)                # 22o
        lqd     $normal_2,16($candidate)                # 23o
        lqd     $axis_2,176($a_bound)                   # 24o
        lqd     $normal_3,16($candidate_2)              # 25o
        fs      $apart_4,$apart_2,$others_2             # 26e
        lqd     $axis_3,176($a_bound_2)                 # 26o
        nop     $127                                    # 27e pairing
        lqd     $others_4,0($candidate_3)               # 27o
        fs      $apart,$apart_3,$others_3               # 28e
        lqd     $apart_3,160($a_bound_3)                # 28o
        nop     $127                                    # 29e pairing
        lqd     $normal_4,16($candidate_3)              # 29o
        fm      $axis_2,$axis_2,$normal_2               # 30e
        lqd     $axis_4,176($a_bound_3)                 # 30o
        nop     $127                                    # 31e pairing
        lqd     $candidate_4,0($a_candidate_3)          # 31o
        fm      $apart_4,$apart_4,$normal_2             # 32e
        lqd     $own_2,32($candidate)                   # 32o
        fm      $axis_3,$axis_3,$normal_3               # 33e
        lqd     $limits_2,192($a_bound)                 # 33o
        fm      $apart,$apart,$normal_3                 # 34e
        lqd     $own_3,32($candidate_2)                 # 34o
        fs      $apart_3,$apart_3,$others_4             # 35e
        lqd     $limits_3,192($a_bound_2)               # 35o
        fm      $axis_5,$axis_4,$normal_4               # 36e
        lqd     $candidate_5,0($a_candidate_4)          # 36o
        nop     $127                                    # 37e pairing
        rotqbyi $a_bound_4,$candidate_4,8               # 37o
        a       $both_2,$own_2,$own_2                   # 38e SIDES_BOTH becomes the sign
        shufb   $others_5,$axis_2,$apart_4,$m_third     # 38o
        fma     $limits_4,$own_2,$k_leave,$limits_2     # 39e
        shufb   $terms_2,$axis_2,$apart_4,$m_first      # 39o
        a       $both_3,$own_3,$own_3                   # 40e SIDES_BOTH becomes the sign
        shufb   $others_6,$axis_3,$apart,$m_third       # 40o
        fm      $apart_3,$apart_3,$normal_4             # 41e
        shufb   $terms_3,$axis_3,$apart,$m_first        # 41o
        fma     $limits_5,$own_3,$k_leave,$limits_3     # 42e
        lqd     $others_7,0($candidate_4)               # 42o
        fa      $terms_2,$terms_2,$others_5             # 43e
        lqd     $apart_2,160($a_bound_4)                # 43o
        nop     $127                                    # 44e pairing
        lqd     $normal_4,16($candidate_4)              # 44o
        fa      $terms_3,$terms_3,$others_6             # 45e
        lqd     $axis_2,176($a_bound_4)                 # 45o
        ori     $limits_4,$limits_4,0                   # 46e copy
        lqd     $own_4,32($candidate_3)                 # 46o
        nop     $127                                    # 47e pairing
        shufb   $others_5,$axis_5,$apart_3,$m_third     # 47o
        ori     $limits_5,$limits_5,0                   # 48e copy
        shufb   $terms_4,$axis_5,$apart_3,$m_first      # 48o
        fs      $apart_5,$apart_2,$others_7             # 49e
        rotqbyi $others_8,$terms_2,8                    # 49o
        nop     $127                                    # 50e pairing
        lqd     $limits_6,192($a_bound_3)               # 50o
        fm      $axis_5,$axis_2,$normal_4               # 51e
        rotqbyi $others_6,$terms_3,8                    # 51o
        fa      $terms_4,$terms_4,$others_5             # 52e
        hbrr    next_face_back,next_face                # 52o hint
        fa      $terms_2,$terms_2,$others_8             # 53e
        rotqbyi $a_bound_5,$candidate_5,8               # 53o
        a       $both,$own_4,$own_4                     # 54e SIDES_BOTH becomes the sign
        lqd     $own_5,32($candidate_4)                 # 54o
        fa      $terms,$terms_3,$others_6               # 55e
        lqd     $limits_7,192($a_bound_4)               # 55o
        fm      $apart_5,$apart_5,$normal_4             # 56e
        lqd     $normal,16($candidate_5)                # 56o
        fma     $limits,$own_4,$k_leave,$limits_6       # 57e
        lqd     $others_9,0($candidate_5)               # 57o
        nop     $127                                    # 58e pairing
        rotqbyi $others_10,$terms_4,8                   # 58o
        fnms    $with_2,$terms_2,$k_along,$limits_4     # 59e
        lqd     $apart_6,160($a_bound_5)                # 59o
        fma     $against_2,$terms_2,$k_along,$limits_4  # 60e
        lqd     $axis_6,176($a_bound_5)                 # 60o
        fnms    $with_3,$terms,$k_along,$limits_5       # 61e
        shufb   $both_2,$both_2,$both_2,$m_w            # 61o
        fma     $against_3,$terms,$k_along,$limits_5    # 62e
        shufb   $others_11,$axis_5,$apart_5,$m_third    # 62o
        fa      $terms_4,$terms_4,$others_10            # 63e
        shufb   $terms_2,$axis_5,$apart_5,$m_first      # 63o
        ori     $limits_3,$limits,0                     # 64e copy
        stqx    $again,$a_first,$found                  # 64o
        fma     $limits,$own_5,$k_leave,$limits_7       # 65e
        shufb   $both_3,$both_3,$both_3,$m_w            # 65o
        fs      $apart,$apart_6,$others_9               # 66e
        shufb   $inner,$with_2,$against_2,$m_inner      # 66o
        fa      $terms_2,$terms_2,$others_11            # 67e
        shufb   $outer_2,$with_2,$against_2,$m_outer    # 67o
        fm      $axis_5,$axis_6,$normal                 # 68e
        shufb   $inner_2,$with_3,$against_3,$m_inner    # 68o
        fnms    $with_2,$terms_4,$k_along,$limits_3     # 69e
        lqd     $own,32($candidate_5)                   # 69o
        fma     $against_2,$terms_4,$k_along,$limits_3  # 70e
        lqd     $candidate,0($a_candidate)              # 70o
        orc     $inner_3,$inner,$both_2                 # 71e
        lqd     $limits_8,192($a_bound_5)               # 71o
        orc     $inner,$inner_2,$both_3                 # 72e
        shufb   $both,$both,$both,$m_w                  # 72o
        and     $drop_2,$outer_2,$inner_3               # 73e
        shufb   $outer,$with_3,$against_3,$m_outer      # 73o
        a       $both_4,$own_5,$own_5                   # 74e SIDES_BOTH becomes the sign
        lnop                                            # 74o pairing
next_face:
            fm      $apart,$apart,$normal               # 0e
            orx     $drop,$drop_2                       # 0o
            and     $drop_2,$outer,$inner               # 1e
            lqd     $again,0($a_again)                  # 1o
            ai      $a_again,$a_again,16                # 2e
            rotqbyi $a_bound,$candidate,8               # 2o
            ori     $limits_9,$limits,0                 # 3e copy
            lqd     $normal,16($candidate)              # 3o
            rotmai  $drop,$drop,-31                     # 4e
            rotqbyi $others,$terms_2,8                  # 4o
            ai      $a_candidate,$a_candidate,16        # 5e
            lqd     $others_9,0($candidate)             # 5o
            fma     $limits,$own,$k_leave,$limits_8     # 6e
            lqd     $apart_7,160($a_bound)              # 6o
        ai      $count,$count,-1                        # 7e
            shufb   $inner,$with_2,$against_2,$m_inner  # 7o
            andc    $step,$k_sixteen,$drop              # 8e
            lqd     $axis,176($a_bound)                 # 8o
            fa      $terms,$terms_2,$others             # 9e
            shufb   $others,$axis_5,$apart,$m_third     # 9o
            a       $found,$found,$step                 # 10e
            shufb   $terms_2,$axis_5,$apart,$m_first    # 10o
            orc     $inner,$inner,$both                 # 11e
            shufb   $both,$both_4,$both_4,$m_w          # 11o
            fs      $apart,$apart_7,$others_9           # 12e
            stqx    $again,$a_first,$found              # 12o
            a       $both_4,$own,$own                   # 13e SIDES_BOTH becomes the sign
            lqd     $own,32($candidate)                 # 13o
            fa      $terms_2,$terms_2,$others           # 14e
        lqd     $candidate,0($a_candidate)              # 14o
            fm      $axis_5,$axis,$normal               # 15e
            shufb   $outer,$with_2,$against_2,$m_outer  # 15o
            fnms    $with_2,$terms,$k_along,$limits_9   # 16e
            lqd     $limits_8,192($a_bound)             # 16o
            fma     $against_2,$terms,$k_along,$limits_9 # 17e
next_face_back:
        brnz    $count,next_face                        # 17o
next_face_drain:
        fm      $apart,$apart,$normal                   # 0e
        rotqbyi $a_bound,$candidate,8                   # 0o
        and     $drop_3,$outer,$inner                   # 1e
        lqd     $others_9,0($candidate)                 # 1o
        ori     $limits_9,$limits,0                     # 2e copy
        lqd     $normal,16($candidate)                  # 2o
        fma     $limits,$own,$k_leave,$limits_8         # 3e
        orx     $drop,$drop_2                           # 3o
        ai      $a_again_2,$a_again,16                  # 4e
        lqd     $apart_7,160($a_bound)                  # 4o
        a       $both_5,$own,$own                       # 5e SIDES_BOTH becomes the sign
        lqd     $axis,176($a_bound)                     # 5o
        ai      $a_again_3,$a_again_2,16                # 6e
        shufb   $others,$axis_5,$apart,$m_third         # 6o
        rotmai  $drop,$drop,-31                         # 7e
        shufb   $terms_3,$axis_5,$apart,$m_first        # 7o
        ai      $a_again_4,$a_again_3,16                # 8e
        lqd     $again,0($a_again)                      # 8o
        ori     $limits,$limits,0                       # 9e copy
        rotqbyi $others_5,$terms_2,8                    # 9o
        fs      $apart_8,$apart_7,$others_9             # 10e
        shufb   $inner,$with_2,$against_2,$m_inner      # 10o
        fm      $axis_7,$axis,$normal                   # 11e
        orx     $drop_3,$drop_3                         # 11o
        andc    $step,$k_sixteen,$drop                  # 12e
        shufb   $outer_3,$with_2,$against_2,$m_outer    # 12o
        fa      $terms_3,$terms_3,$others               # 13e
        shufb   $both_4,$both_4,$both_4,$m_w            # 13o
        a       $found,$found,$step                     # 14e
        shufb   $both_5,$both_5,$both_5,$m_w            # 14o
        fa      $terms_2,$terms_2,$others_5             # 15e
        hbr     cull_faces_return,$lr                   # 15o hint
        fm      $apart_8,$apart_8,$normal               # 16e
        stqx    $again,$a_first,$found                  # 16o
        orc     $inner,$inner,$both                     # 17e
        lqd     $own_2,32($candidate)                   # 17o
        rotmai  $drop,$drop_3,-31                       # 18e
        lqd     $limits_10,192($a_bound)                # 18o
        and     $drop_4,$outer_3,$inner                 # 19e
        rotqbyi $others,$terms_3,8                      # 19o
        ai      $a_again,$a_again_4,16                  # 20e
        lqd     $again,0($a_again_2)                    # 20o
        fnms    $with_2,$terms_2,$k_along,$limits_9     # 21e
        orx     $drop_2,$drop_4                         # 21o
        fma     $against_2,$terms_2,$k_along,$limits_9  # 22e
        shufb   $others_12,$axis_7,$apart_8,$m_third    # 22o
        fa      $terms_2,$terms_3,$others               # 23e
        shufb   $terms_5,$axis_7,$apart_8,$m_first      # 23o
        fma     $limits_10,$own_2,$k_leave,$limits_10   # 24e
        andc    $step,$k_sixteen,$drop                  # 25e
        rotmai  $drop,$drop_2,-31                       # 26e
        fa      $terms_6,$terms_5,$others_12            # 27e
        a       $found,$found,$step                     # 28e
        shufb   $inner,$with_2,$against_2,$m_inner      # 28o
        fnms    $with_4,$terms_2,$k_along,$limits       # 29e
        shufb   $outer,$with_2,$against_2,$m_outer      # 29o
        fma     $against_2,$terms_2,$k_along,$limits    # 30e
        stqx    $again,$a_first,$found                  # 30o
        ori     $limits_10,$limits_10,0                 # 31e copy
        lqd     $again,0($a_again_3)                    # 31o
        orc     $inner,$inner,$both_4                   # 32e
        lnop                                            # 32o pairing
        a       $both_4,$own_2,$own_2                   # 33e SIDES_BOTH becomes the sign
        rotqbyi $others,$terms_6,8                      # 33o
        and     $drop_5,$outer,$inner                   # 34e
        lnop                                            # 34o pairing
        andc    $step,$k_sixteen,$drop                  # 35e
        shufb   $both,$both_4,$both_4,$m_w              # 35o
        ai      $a_candidate,$a_candidate,16            # 36e
        shufb   $inner,$with_4,$against_2,$m_inner      # 36o
        fa      $terms,$terms_6,$others                 # 37e
        orx     $drop,$drop_5                           # 37o
        a       $found,$found,$step                     # 38e
        shufb   $outer,$with_4,$against_2,$m_outer      # 38o
        ai      $a_again_2,$a_again,16                  # 39e
        lnop                                            # 39o pairing
        orc     $inner,$inner,$both_5                   # 40e
        stqx    $again,$a_first,$found                  # 40o
        rotmai  $drop,$drop,-31                         # 41e
        lqd     $again,0($a_again_4)                    # 41o
        and     $drop_2,$outer,$inner                   # 42e
        fnms    $with_2,$terms,$k_along,$limits_10      # 43e
        fma     $against_2,$terms,$k_along,$limits_10   # 44e
        orx     $drop_2,$drop_2                         # 44o
        andc    $step,$k_sixteen,$drop                  # 45e
        a       $found,$found,$step                     # 47e
        rotmai  $drop,$drop_2,-31                       # 48e
        stqx    $again,$a_first,$found                  # 49o
        shufb   $inner,$with_2,$against_2,$m_inner      # 50o
        shufb   $outer,$with_2,$against_2,$m_outer      # 51o
        andc    $step,$k_sixteen,$drop                  # 52e
        lqd     $again,0($a_again)                      # 52o
        orc     $inner,$inner,$both                     # 54e
        a       $found,$found,$step                     # 55e
        and     $drop_2,$outer,$inner                   # 56e
        orx     $drop,$drop_2                           # 58o
        stqx    $again,$a_first,$found                  # 59o
        rotmai  $drop,$drop,-31                         # 62e
        andc    $step,$k_sixteen,$drop                  # 66e
        a       $found,$found,$step                     # 68e
        a       $a_first,$a_first,$found                # 70e
cull_faces_return:
        bi      $lr                                     # 70o
next_face_short:
        ai      $count,$count,-1                        # 0e
        lqd     $candidate,0($a_candidate)              # 0o
        ai      $a_candidate,$a_candidate,16            # 1e
        lqd     $again,0($a_again)                      # 1o
        ai      $a_again,$a_again,16                    # 2e
        rotqbyi $a_bound,$candidate,8                   # 6o
        lqd     $others,0($candidate)                   # 7o
        lqd     $normal,16($candidate)                  # 8o
        lqd     $own,32($candidate)                     # 9o
        lqd     $apart,160($a_bound)                    # 10o
        lqd     $axis,176($a_bound)                     # 11o
        lqd     $limits,192($a_bound)                   # 12o
        stqx    $again,$a_first,$found                  # 13o
        a       $both,$own,$own                         # 15e SIDES_BOTH becomes the sign
        fs      $apart,$apart,$others                   # 16e
        lnop                                            # 16o pairing
        fm      $axis,$axis,$normal                     # 17e
        shufb   $both,$both,$both,$m_w                  # 17o
        fma     $limits,$own,$k_leave,$limits           # 18e
        fm      $apart,$apart,$normal                   # 22e
        shufb   $terms,$axis,$apart,$m_first            # 28o
        shufb   $others,$axis,$apart,$m_third           # 29o
        fa      $terms,$terms,$others                   # 33e
        rotqbyi $others,$terms,8                        # 39o
        fa      $terms,$terms,$others                   # 43e
        fnms    $with,$terms,$k_along,$limits           # 49e
        fma     $against,$terms,$k_along,$limits        # 50e
        shufb   $inner,$with,$against,$m_inner          # 56o
        shufb   $outer,$with,$against,$m_outer          # 57o
        orc     $inner,$inner,$both                     # 60e
        and     $drop,$outer,$inner                     # 62e
        orx     $drop,$drop                             # 64o
        rotmai  $drop,$drop,-31                         # 68e
        andc    $step,$k_sixteen,$drop                  # 72e
        a       $found,$found,$step                     # 74e
        brnz    $count,next_face_short                  # 74o
        a       $a_first,$a_first,$found                # 76e
        bi      $lr                                     # 76o
endfunction cull_faces
