# cull_faces   of candidates whose objects are flat, those some ray of which may meet the seen side
#   C       struct candidate *cull_faces(const struct candidate *, int count, struct candidate *,
#                                        float along);
#   In      $3 candidates whose objects have gain 0 and a unit axis, $4 count (0 is none), $5 where the
#           list goes: elsewhere, or over the candidates; $6 1 if the
#           rays go along their bounds' axes, -1 if against them; pointers 16-aligned
#   Out     those candidates, in order; behind them what is left out may be written, but nothing
#           behind as many quadwords as there are candidates
#           $3 behind the list
#   Uses    $2-$38, $79   Saves  -   Stack  0   Calls  -
#   Domain  bounds as bound_fan_r16 makes them, or bound_origins_r16; distances from 2^-60 to 2^60;
#           OBJECT_leave at least 2^-20 of the sum of the centre's components' magnitudes
#   Error   0: no candidate is left out whose plane a ray meets from a side that is seen, by the numbers
#           of the records
#   Twin    oracle/src/twin/cull_faces.rs
#
# With n the object's axis:
#   g = axis.n                  all rays go with n if g > sine, all against it if -g > sine
#   h = (apex - centre).n       all start before the plane if h > M, all behind it if -h > M
#   M = radius + leave          what starts within rounding of the plane counts as on both sides
# The front is met by rays that start before it and go against n. So a candidate is left out that is
# seen from the front alone if all go with n, or all start behind. One with SIDES_BOTH is left out if
# all go with n and start before it, or go against it and start behind.
#
# Rays that go against their bound's axis end in its ball: their ends' sides are the other ones, and
# their directions too.
# Scheduled by spu schedule from cull_faces.s

        .include "work_unit.inc"
        .include "macros.inc"

        .set    a_first,3
        .set    count,4
        .set    a_list,5
        .set    along,6
        # constants
        .set    k_along,10
        .set    k_leave,11                              # by lanes: 0, 1
        .set    k_sixteen,12
        .set    m_first,13
        .set    m_third,14
        .set    m_outer,15
        .set    m_inner,16
        .set    m_w,17
        # state
        .set    a_candidate,18
        .set    found,19                                # bytes of the list so far
        # the candidate
        .set    candidate,20
        .set    a_bound,21
        .set    apart,22
        .set    normal,23
        .set    own,24                                  # offset, leave, material, sides
        .set    axis,25
        .set    limits,26
        # lanes: of g, of h
        .set    terms,27
        .set    others,28
        .set    with,29                                 # limit less what it limits
        .set    against,30
        .set    outer,31                                # all go with it; all start behind
        .set    inner,32                                # all start before; all go against it
        .set    both,33
        .set    drop,34
        .set    step,35

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
        .set    m_w_2,2
        .set    count_2,79
        .set    a_candidate_2,2
        .set    candidate_2,38
        .set    candidate_3,2
        .set    a_candidate_3,5
        .set    candidate_4,6
        .set    a_bound_2,7
        .set    apart_2,8
        .set    others_2,9
        .set    apart_3,20
        .set    normal_2,22
        .set    axis_2,24
        .set    a_bound_3,26
        .set    own_2,37
        .set    limits_2,21
        .set    apart_4,9
        .set    candidate_5,31
        .set    apart_5,5
        .set    candidate_6,8
        .set    both_2,27
        .set    limits_3,29
        .set    axis_3,21
        .set    limits_4,7
        .set    others_3,8
        .set    terms_2,5
        .set    terms_3,22
        .set    terms_4,8
        .set    both_3,30
        .set    terms_5,28
        .set    others_4,22
        .set    apart_6,32
        .set    others_5,33
        .set    both_4,5
        .set    limits_5,36
        .set    both_5,26
        .set    others_6,20
        .set    axis_4,8
        .set    candidate_7,24
        .set    others_7,2
        .set    terms_6,9
        .set    candidate_8,32
        .set    with_2,34
        .set    against_2,35
        .set    candidate_9,9
        .set    drop_2,2
        .set    others_8,6
        .set    apart_7,7
        .set    a_bound_4,2
        .set    candidate_10,4
        .set    drop_3,6
        .set    both_6,20
        .set    limits_6,9
        .set    candidate_11,21
        .set    axis_5,6
        .set    a_bound_5,8
        .set    normal_3,18
        .set    apart_8,23
        .set    limits_7,5
        .set    terms_7,2
        .set    own_3,4
        .set    others_9,23
        .set    terms_8,6
        .set    both_7,8
        .set    candidate_12,7
        .set    both_8,4
        .set    candidate_13,11
        .set    drop_4,18
        .set    others_10,14
        .set    terms_9,13
        .set    terms_10,4
        .set    with_3,7
        .set    drop_5,5
        .set    drop_6,4
        ori     $a_candidate,$a_first,0                 # 0e
        lnop                                            # 0o pairing

        ori     $a_first,$a_list,0                      # 1e
        biz     $count,$lr                              # 1o

        ila     $m_w_2,0x10203                          # 2e
        lqa     $k_leave,leave_by_lane                  # 2o

        ilhu    $m_w,0xc0d                              # 3e
        lqa     $m_first,first_words                    # 3o

        clgti   $count_2,$count,6                       # 4e at least as many passes as overlap
        lqa     $m_third,third_words                    # 4o

        iohl    $m_w,0xe0f                              # 5e
        lqa     $m_outer,outer_words                    # 5o

        il      $k_sixteen,16                           # 6e
        lqa     $m_inner,inner_words                    # 6o

        il      $found,0                                # 7e
        shufb   $k_along,$along,$along,$m_w_2           # 7o

        nop     $127                                    # 8e pairing
        brz     $count_2,next_face_short                # 8o too few passes

        ai      $a_candidate_2,$a_candidate,16          # 9e
        lqd     $candidate_2,0($a_candidate)            # 9o

        ai      $count,$count,-1                        # 10e
        lnop                                            # 10o pairing

        ai      $a_candidate,$a_candidate_2,16          # 11e
        lqd     $candidate_3,0($a_candidate_2)          # 11o

        ai      $count,$count,-1                        # 12e
        lnop                                            # 12o pairing

        ai      $a_candidate_3,$a_candidate,16          # 13e
        lqd     $candidate_4,0($a_candidate)            # 13o

        ai      $count,$count,-1                        # 14e
        lnop                                            # 14o pairing

        ai      $a_candidate,$a_candidate_3,16          # 15e
        rotqbyi $a_bound,$candidate_2,8                 # 15o

        ai      $count,$count,-1                        # 16e
        lqd     $others,0($candidate_2)                 # 16o

        nop     $127                                    # 17e pairing
        lqd     $normal,16($candidate_2)                # 17o

        ai      $count,$count,-1                        # 18e
        rotqbyi $a_bound_2,$candidate_3,8               # 18o

        nop     $127                                    # 19e pairing
        lqd     $apart_2,160($a_bound)                  # 19o

        ai      $count,$count,-1                        # 20e
        lqd     $axis,176($a_bound)                     # 20o

        lqd     $others_2,0($candidate_3)               # 21o
        lqd     $apart_3,160($a_bound_2)                # 22o

        lqd     $normal_2,16($candidate_3)              # 23o
        lqd     $axis_2,176($a_bound_2)                 # 24o

        fs      $apart_2,$apart_2,$others               # 25e
        rotqbyi $a_bound_3,$candidate_4,8               # 25o

        fm      $axis,$axis,$normal                     # 26e
        lqd     $own_2,32($candidate_2)                 # 26o

        nop     $127                                    # 27e pairing
        lqd     $limits_2,192($a_bound)                 # 27o

        fs      $apart_4,$apart_3,$others_2             # 28e
        lqd     $others,0($candidate_4)                 # 28o

        nop     $127                                    # 29e pairing
        lqd     $apart_3,160($a_bound_3)                # 29o

        fm      $axis_2,$axis_2,$normal_2               # 30e
        lqd     $candidate_5,0($a_candidate_3)          # 30o

        fm      $apart_5,$apart_2,$normal               # 31e
        shlqbyi $candidate_6,$candidate_2,0             # 31o copy

        a       $both_2,$own_2,$own_2                   # 32e SIDES_BOTH becomes the sign
        lqd     $normal,16($candidate_4)                # 32o

        fma     $limits_3,$own_2,$k_leave,$limits_2     # 33e
        lqd     $axis_3,176($a_bound_3)                 # 33o

        fm      $apart,$apart_4,$normal_2               # 34e
        lqd     $own_2,32($candidate_3)                 # 34o

        fs      $apart_4,$apart_3,$others               # 35e
        shlqbyi $candidate,$candidate_6,0               # 35o copy

        lqd     $limits_4,192($a_bound_2)               # 36o
        shufb   $others_3,$axis,$apart_5,$m_third       # 37o

        nop     $127                                    # 38e pairing
        shufb   $terms_2,$axis,$apart_5,$m_first        # 38o

        fm      $axis,$axis_3,$normal                   # 39e
        rotqbyi $a_bound,$candidate_5,8                 # 39o

        ori     $candidate,$candidate,0                 # 40e copy
        shufb   $others,$axis_2,$apart,$m_third         # 40o

        fm      $apart_4,$apart_4,$normal               # 41e
        shufb   $terms_3,$axis_2,$apart,$m_first        # 41o

        fa      $terms_4,$terms_2,$others_3             # 42e
        hbrr    next_face_back,next_face                # 42o hint

        fma     $limits_4,$own_2,$k_leave,$limits_4     # 43e
        lqd     $own,32($candidate_4)                   # 43o

        a       $both_3,$own_2,$own_2                   # 44e SIDES_BOTH becomes the sign
        lqd     $limits,192($a_bound_3)                 # 44o

        fa      $terms_5,$terms_3,$others               # 45e
        lqd     $others_4,0($candidate_5)               # 45o

        lqd     $normal,16($candidate_5)                # 46o
        lqd     $apart_6,160($a_bound)                  # 47o

        nop     $127                                    # 48e pairing
        rotqbyi $others_5,$terms_4,8                    # 48o

        a       $both_4,$own,$own                       # 49e SIDES_BOTH becomes the sign
        stqx    $candidate,$a_first,$found              # 49o

        fma     $limits_5,$own,$k_leave,$limits         # 50e
        shufb   $both_5,$both_2,$both_2,$m_w            # 50o

        nop     $127                                    # 51e pairing
        rotqbyi $others_6,$terms_5,8                    # 51o

        fa      $terms,$terms_4,$others_5               # 52e
        lqd     $axis_4,176($a_bound)                   # 52o

        fs      $apart,$apart_6,$others_4               # 53e
        shlqbyi $candidate_7,$candidate_3,0             # 53o copy

        nop     $127                                    # 54e pairing
        shufb   $others_7,$axis,$apart_4,$m_third       # 54o

        fa      $terms_5,$terms_5,$others_6             # 55e
        shufb   $terms_6,$axis,$apart_4,$m_first        # 55o

        shlqbyi $candidate_4,$candidate_4,0             # 56o copy
        shlqbyi $candidate_8,$candidate_7,0             # 57o copy

        fnms    $with_2,$terms,$k_along,$limits_3       # 58e
        lqd     $own_2,32($candidate_5)                 # 58o

        fma     $against_2,$terms,$k_along,$limits_3    # 59e
        lqd     $candidate_2,0($a_candidate)            # 59o

        fa      $terms,$terms_6,$others_7               # 60e
        shufb   $both,$both_3,$both_3,$m_w              # 60o

        fnms    $with,$terms_5,$k_along,$limits_4       # 61e
        shlqbyi $candidate,$candidate_4,0               # 61o copy

        fma     $against,$terms_5,$k_along,$limits_4    # 62e
        shlqbyi $candidate_7,$candidate_5,0             # 62o copy

        fm      $axis,$axis_4,$normal                   # 63e
        ori     $candidate_9,$candidate_8,0             # 64e copy

        shufb   $inner,$with_2,$against_2,$m_inner      # 65o
        shufb   $outer,$with_2,$against_2,$m_outer      # 66o

        orc     $inner,$inner,$both_5                   # 69e
        and     $drop_2,$outer,$inner                   # 71e

        nop     $127                                    # 72e pairing
        orx     $drop,$drop_2                           # 73o

next_face:
            ai      $a_candidate,$a_candidate,16        # 0e
            shufb   $inner,$with,$against,$m_inner      # 0o

            rotmai  $drop,$drop,-31                     # 1e
            rotqbyi $others,$terms,8                    # 1o

            fm      $apart,$apart,$normal               # 2e
            shufb   $outer,$with,$against,$m_outer      # 2o

        ai      $count,$count,-1                        # 3e
            lqd     $limits,192($a_bound)               # 3o

            orc     $inner,$inner,$both                 # 4e
            shufb   $both,$both_4,$both_4,$m_w          # 4o

            fa      $terms,$terms,$others               # 5e
            rotqbyi $a_bound,$candidate_2,8             # 5o

            and     $drop_2,$outer,$inner               # 6e
            lqd     $others,0($candidate_2)             # 6o

            andc    $step,$k_sixteen,$drop              # 7e
            lqd     $normal,16($candidate_2)            # 7o

            a       $both_4,$own_2,$own_2               # 8e SIDES_BOTH becomes the sign
            shufb   $others_8,$axis,$apart,$m_third     # 8o

            a       $found,$found,$step                 # 9e
            lqd     $apart_7,160($a_bound)              # 9o

            nop     $127                                # 10e pairing
            shufb   $terms_4,$axis,$apart,$m_first      # 10o

            fnms    $with,$terms,$k_along,$limits_5     # 11e
            stqx    $candidate_9,$a_first,$found        # 11o

            ori     $candidate_9,$candidate,0           # 12e copy
            lqd     $axis,176($a_bound)                 # 12o

            fma     $against,$terms,$k_along,$limits_5  # 13e
            shlqbyi $candidate,$candidate_7,0           # 13o copy

            fa      $terms,$terms_4,$others_8           # 14e
            orx     $drop,$drop_2                       # 14o

            fs      $apart,$apart_7,$others             # 15e
            shlqbyi $candidate_7,$candidate_2,0         # 15o copy

            fma     $limits_5,$own_2,$k_leave,$limits   # 16e
            lqd     $own_2,32($candidate_2)             # 16o

            nop     $127                                # 17e pairing
            lqd     $candidate_2,0($a_candidate)        # 17o

            fm      $axis,$axis,$normal                 # 18e
next_face_back:
        brnz    $count,next_face                        # 18o

next_face_drain:
        rotmai  $drop,$drop,-31                         # 0e
        rotqbyi $a_bound_4,$candidate_2,8               # 0o

        ai      $a_candidate,$a_candidate,16            # 1e
        shufb   $inner,$with,$against,$m_inner          # 1o

        ori     $candidate_10,$candidate,0              # 2e copy
        shufb   $outer,$with,$against,$m_outer          # 2o

        fm      $apart,$apart,$normal                   # 3e
        lqd     $limits,192($a_bound)                   # 3o

        andc    $step,$k_sixteen,$drop                  # 4e
        lqd     $others,0($candidate_2)                 # 4o

        orc     $inner,$inner,$both                     # 5e
        lqd     $normal,16($candidate_2)                # 5o

        a       $found,$found,$step                     # 6e
        lqd     $apart_7,160($a_bound_4)                # 6o

        and     $drop_3,$outer,$inner                   # 7e
        rotqbyi $others_3,$terms,8                      # 7o

        a       $both_6,$own_2,$own_2                   # 8e SIDES_BOTH becomes the sign
        stqx    $candidate_9,$a_first,$found            # 8o

        fma     $limits_6,$own_2,$k_leave,$limits       # 9e
        lqd     $candidate_11,0($a_candidate)           # 9o

        ai      $a_candidate,$a_candidate,16            # 10e
        orx     $drop,$drop_3                           # 10o

        fa      $terms,$terms,$others_3                 # 11e
        lqd     $axis_5,176($a_bound_4)                 # 11o

        fs      $apart_7,$apart_7,$others               # 12e
        lqd     $own_2,32($candidate_2)                 # 12o

        nop     $127                                    # 13e pairing
        lqd     $limits,192($a_bound_4)                 # 13o

        rotmai  $drop,$drop,-31                         # 14e
        shufb   $others_7,$axis,$apart,$m_third         # 14o

        rotqbyi $a_bound_5,$candidate_11,8              # 15o
        lqd     $others,0($candidate_11)                # 16o

        fm      $axis_5,$axis_5,$normal                 # 17e
        lqd     $normal_3,16($candidate_11)             # 17o

        andc    $step,$k_sixteen,$drop                  # 18e
        shufb   $terms_3,$axis,$apart,$m_first          # 18o

        fm      $apart_7,$apart_7,$normal               # 19e
        lqd     $apart_8,160($a_bound_5)                # 19o

        a       $found,$found,$step                     # 20e
        shufb   $both,$both_4,$both_4,$m_w              # 20o

        fma     $limits_7,$own_2,$k_leave,$limits       # 21e
        shufb   $both_6,$both_6,$both_6,$m_w            # 21o

        fa      $terms_7,$terms_3,$others_7             # 22e
        stqx    $candidate_10,$a_first,$found           # 22o

        fnms    $with,$terms,$k_along,$limits_5         # 23e
        lqd     $axis,176($a_bound_5)                   # 23o

        fma     $against,$terms,$k_along,$limits_5      # 24e
        lqd     $own_3,32($candidate_11)                # 24o

        fs      $apart,$apart_8,$others                 # 25e
        shufb   $others_9,$axis_5,$apart_7,$m_third     # 25o

        a       $both_5,$own_2,$own_2                   # 26e SIDES_BOTH becomes the sign
        shufb   $terms_8,$axis_5,$apart_7,$m_first      # 26o

        lqd     $limits_4,192($a_bound_5)               # 27o
        rotqbyi $others,$terms_7,8                      # 28o

        fm      $axis,$axis,$normal_3                   # 29e
        shufb   $both_7,$both_5,$both_5,$m_w            # 29o

        fa      $terms,$terms_8,$others_9               # 30e
        shufb   $inner,$with,$against,$m_inner          # 30o

        fm      $apart,$apart,$normal_3                 # 31e
        shufb   $outer,$with,$against,$m_outer          # 31o

        fa      $terms_7,$terms_7,$others               # 32e
        hbr     cull_faces_return,$lr                   # 32o hint

        fma     $limits_5,$own_3,$k_leave,$limits_4     # 33e
        shlqbyi $candidate_4,$candidate_2,0             # 33o copy

        orc     $inner,$inner,$both                     # 34e
        shlqbyi $candidate_12,$candidate_11,0           # 34o copy

        a       $both_8,$own_3,$own_3                   # 35e SIDES_BOTH becomes the sign
        shlqbyi $candidate_13,$candidate_7,0            # 35o copy

        and     $drop_4,$outer,$inner                   # 36e
        rotqbyi $others,$terms,8                        # 36o

        nop     $127                                    # 37e pairing
        shufb   $others_10,$axis,$apart,$m_third        # 37o

        fnms    $with,$terms_7,$k_along,$limits_6       # 38e
        shufb   $terms_9,$axis,$apart,$m_first          # 38o

        fma     $against,$terms_7,$k_along,$limits_6    # 39e
        shufb   $both,$both_8,$both_8,$m_w              # 39o

        fa      $terms,$terms,$others                   # 40e
        orx     $drop,$drop_4                           # 40o

        ori     $candidate_9,$candidate_13,0            # 41e copy
        shlqbyi $candidate_3,$candidate_4,0             # 41o copy

        fa      $terms_10,$terms_9,$others_10           # 42e
        shlqbyi $candidate_4,$candidate_12,0            # 42o copy

        rotmai  $drop,$drop,-31                         # 44e
        lnop                                            # 44o pairing

        ori     $candidate_3,$candidate_3,0             # 45e copy
        shufb   $inner,$with,$against,$m_inner          # 45o

        fnms    $with_3,$terms,$k_along,$limits_7       # 46e
        shufb   $outer,$with,$against,$m_outer          # 46o

        fma     $against,$terms,$k_along,$limits_7      # 47e
        lnop                                            # 47o pairing

        andc    $step,$k_sixteen,$drop                  # 48e
        rotqbyi $others,$terms_10,8                     # 48o

        orc     $inner,$inner,$both_6                   # 49e
        a       $found,$found,$step                     # 50e

        and     $drop_5,$outer,$inner                   # 51e
        lnop                                            # 51o pairing

        fa      $terms,$terms_10,$others                # 52e
        stqx    $candidate_9,$a_first,$found            # 52o

        ori     $candidate_9,$candidate_4,0             # 53e copy
        shufb   $inner,$with_3,$against,$m_inner        # 53o

        shufb   $outer,$with_3,$against,$m_outer        # 54o
        orx     $drop,$drop_5                           # 55o

        orc     $inner,$inner,$both_7                   # 57e
        fnms    $with,$terms,$k_along,$limits_5         # 58e

        fma     $against,$terms,$k_along,$limits_5      # 59e
        and     $drop_6,$outer,$inner                   # 60e

        rotmai  $drop,$drop,-31                         # 61e
        orx     $drop_6,$drop_6                         # 62o

        andc    $step,$k_sixteen,$drop                  # 65e
        shufb   $inner,$with,$against,$m_inner          # 65o

        rotmai  $drop,$drop_6,-31                       # 66e
        shufb   $outer,$with,$against,$m_outer          # 66o

        a       $found,$found,$step                     # 67e
        lnop                                            # 67o pairing

        orc     $inner,$inner,$both                     # 69e
        stqx    $candidate_3,$a_first,$found            # 69o

        andc    $step,$k_sixteen,$drop                  # 70e
        and     $drop_2,$outer,$inner                   # 71e

        a       $found,$found,$step                     # 72e
        orx     $drop,$drop_2                           # 73o

        stqx    $candidate_9,$a_first,$found            # 74o
        rotmai  $drop,$drop,-31                         # 77e

        andc    $step,$k_sixteen,$drop                  # 81e
        a       $found,$found,$step                     # 83e

        a       $a_first,$a_first,$found                # 85e
cull_faces_return:
        bi      $lr                                     # 85o

next_face_short:
        ai      $count,$count,-1                        # 0e
        lqd     $candidate,0($a_candidate)              # 0o

        ai      $a_candidate,$a_candidate,16            # 1e
        rotqbyi $a_bound,$candidate,8                   # 6o

        lqd     $others,0($candidate)                   # 7o
        lqd     $normal,16($candidate)                  # 8o

        lqd     $own,32($candidate)                     # 9o
        lqd     $apart,160($a_bound)                    # 10o

        lqd     $axis,176($a_bound)                     # 11o
        lqd     $limits,192($a_bound)                   # 12o

        stqx    $candidate,$a_first,$found              # 13o
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
