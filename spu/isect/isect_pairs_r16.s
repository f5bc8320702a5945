# isect_pairs_r16   nearest entry of the eye rays of packets into spheres, pair by pair
#   C       void isect_pairs_r16(const struct pair *, int count);
#   In      $3 pairs, $4 count (0 is none); pointers 16-aligned
#   Out     the pairs' packets: t, object, where an entry is nearer than what was there
#   Uses    $3-$4, $10-$39   Saves  -   Stack  0   Calls  -
#   Domain  |d| = 1 within 4 ulp; radius > 0; centre and radius below 2^62
#   Error   12 ulp of t, eye 1.5 to 30 radii from the centre, ray within 0.995 r of it
#   Twin    oracle/src/twin/isect_pairs.rs
#
# For the centre c as the eye sees it and the unit direction d:
#   b = c.d             where the ray passes the centre
#   l = c - b d         from there to the centre
#   disc = r^2 - l.l    below 0: the ray passes by
#   t = b - sqrt(disc)  the entry; behind the eye: no hit (an opaque sphere has no inside)
# The perpendicular l keeps the digits that the b^2 - c of a distant sphere loses (Hearn and Baker).
#   y = 1/sqrt(disc) to 12 bits, s = disc y, sqrt(disc) = s (1 + (1 - s y)/2)
#
# There is no NaN that a compare could fail on. As unsigned numbers, singles below 0 are larger than
# all others: so one unsigned compare asks for an entry that is ahead and nearer. Of its mask and
# disc only the signs count: they are brought into four bits, and these choose a shuffle that
# merges old and new, all on the odd pipe.
# Scheduled by spu schedule from isect_pairs_r16.s

        .include "work_unit.inc"
        .include "macros.inc"

        .set    a_pair,3
        .set    count,4
        # constants
        .set    k_half,10
        .set    k_one,11
        .set    m_x,12
        .set    m_y,13
        .set    m_z,14
        .set    m_radius2,15
        .set    a_merges,16
        # the pair
        .set    object,17
        .set    a_packet,18
        .set    quad,19
        .set    cx,20
        .set    cy,21
        .set    cz,22
        .set    radius2,23
        # a row
        .set    dx,24
        .set    dy,25
        .set    dz,26
        .set    t_best,27
        .set    nearest,28
        # temporaries
        .set    b,29
        .set    lx,30
        .set    ly,31
        .set    lz,32
        .set    disc,33
        .set    y,34
        .set    s,35
        .set    e,36
        .set    t,37
        .set    hit,38
        .set    merge,39

        .section .rodata
        .align  4
# By four bits, of rows' lanes 1, 2, 3 and 0: words of A where the lane's bit is 0, else of B.
merges:
    .set    bits,0
    .rept   16
        .int    0x00010203+0x10101010*(bits&1)
        .int    0x04050607+0x10101010*(bits>>3&1)
        .int    0x08090a0b+0x10101010*(bits>>2&1)
        .int    0x0c0d0e0f+0x10101010*(bits>>1&1)
    .set    bits,bits+1
    .endr

function isect_pairs_r16
        .set    count_2,79
        .set    a_packet_2,24
        .set    quad_2,25
        .set    object_2,53
        .set    dx_2,30
        .set    dy_2,26
        .set    dx_3,33
        .set    cx_2,32
        .set    cy_2,31
        .set    dx_4,34
        .set    dx_5,29
        .set    b_2,39
        .set    dy_3,40
        .set    b_3,20
        .set    dz_2,44
        .set    dy_4,43
        .set    dy_5,42
        .set    b_4,36
        .set    dz_3,48
        .set    b_5,37
        .set    dz_4,46
        .set    cz_2,38
        .set    dz_5,47
        .set    radius2_2,25
        .set    b_6,49
        .set    b_7,45
        .set    b_8,51
        .set    b_9,50
        .set    ly_2,26
        .set    lz_2,36
        .set    lx_2,33
        .set    lz_3,9
        .set    lx_3,29
        .set    lx_4,32
        .set    ly_3,37
        .set    disc_2,30
        .set    ly_4,40
        .set    disc_3,29
        .set    disc_4,25
        .set    disc_5,18
        .set    lz_4,23
        .set    disc_6,2
        .set    disc_7,7
        .set    disc_8,43
        .set    disc_9,48
        .set    disc_10,44
        .set    disc_11,52
        .set    y_2,5
        .set    y_3,26
        .set    y_4,2
        .set    y_5,6
        .set    nearest_2,6
        .set    t_best_2,7
        .set    t_best_3,8
        .set    nearest_3,9
        .set    s_2,18
        .set    a_packet_3,19
        .set    s_3,20
        .set    t_best_4,21
        .set    s_4,22
        .set    nearest_4,23
        .set    e_2,26
        .set    e_3,2
        .set    e_4,5
        .set    t_2,35
        .set    t_3,18
        .set    t_4,2
        .set    t_5,5
        .set    hit_2,22
        .set    hit_3,41
        .set    hit_4,45
        .set    hit_5,39
        .set    hit_6,37
        .set    hit_7,20
        .set    merge_2,20
        .set    hit_8,34
        .set    merge_3,34
        .set    merge_4,22
        .set    nearest_5,20
        .set    hit_9,3
        .set    t_best_5,2
        .set    dx_6,2
        .set    dx_7,5
        .set    dx_8,6
        .set    dy_6,7
        .set    dy_7,8
        .set    dy_8,9
        .set    b_10,21
        .set    cy_3,22
        .set    b_11,23
        .set    b_12,27
        .set    dz_6,28
        .set    dz_7,30
        .set    dz_8,31
        .set    cz_3,32
        .set    radius2_3,19
        .set    t_best_6,33
        .set    t_best_7,34
        .set    t_best_8,35
        .set    t_best_9,36
        .set    nearest_6,37
        .set    nearest_7,38
        .set    nearest_8,39
        .set    nearest_9,40
        .set    lx_5,24
        .set    lx_6,2
        .set    lx_7,5
        .set    lx_8,6
        .set    ly_5,20
        .set    ly_6,7
        .set    disc_12,24
        .set    ly_7,8
        .set    disc_13,5
        .set    ly_8,9
        .set    disc_14,6
        .set    lz_5,19
        .set    disc_15,20
        .set    lz_6,22
        .set    lz_7,7
        .set    disc_16,8
        .set    y_6,7
        .set    y_7,9
        .set    y_8,19
        .set    y_9,20
        .set    s_5,24
        .set    s_6,25
        .set    s_7,26
        .set    e_5,7
        .set    e_6,9
        .set    e_7,19
        .set    e_8,20
        .set    t_6,7
        .set    t_7,9
        .set    t_8,19
        .set    t_9,20
        .set    hit_10,21
        .set    hit_11,8
        .set    hit_12,2
        .set    hit_13,5
        .set    hit_14,6
        .set    merge_5,8
        .set    merge_6,2
        .set    merge_7,5
        .set    merge_8,6
        .set    nearest_10,2
        .set    nearest_11,5
        .set    t_best_10,9
        nop     $127                                    # 0e pairing
        biz     $count,$lr                              # 0o

        ilhu    $m_x,1                                  # 1e
        ilhu    $m_y,0x405                              # 2e

        ilhu    $m_z,0x809                              # 3e
        ilhu    $m_radius2,0xc0d                        # 4e

        clgti   $count_2,$count,1                       # 5e at least as many passes as overlap
        iohl    $m_x,515                                # 6e

        iohl    $m_y,0x607                              # 7e
        iohl    $m_z,0xa0b                              # 8e

        iohl    $m_radius2,0xe0f                        # 9e
        ilhu    $k_half,0x3f00                          # 10e

        ilhu    $k_one,0x3f80                           # 11e
        lnop                                            # 11o pairing

        ila     $bits,merges                            # 12e
        brz     $count_2,next_pair_short                # 12o too few passes

        ai      $count,$count,-1                        # 13e
        lqd     $object,0($a_pair)                      # 13o

        ai      $a_pair,$a_pair,16                      # 14e
        rotqbyi $a_packet_2,$object,4                   # 19o

        lqd     $quad_2,0($object)                      # 20o
        shufb   $object_2,$object,$object,$m_x          # 21o

        lqd     $dx_2,32($a_packet_2)                   # 23o
        lqd     $dy_2,96($a_packet_2)                   # 24o

        lqd     $dx_3,16($a_packet_2)                   # 25o
        shufb   $cx_2,$quad_2,$quad_2,$m_x              # 26o

        shufb   $cy_2,$quad_2,$quad_2,$m_y              # 27o
        lqd     $dx_4,48($a_packet_2)                   # 28o

        nop     $127                                    # 29e pairing
        lqd     $dx_5,0($a_packet_2)                    # 29o

        fm      $b_2,$cx_2,$dx_2                        # 30e
        lqd     $dy_3,64($a_packet_2)                   # 30o

        fm      $b_3,$cx_2,$dx_3                        # 31e
        lqd     $dz_2,160($a_packet_2)                  # 31o

        lqd     $dy_4,112($a_packet_2)                  # 32o
        lqd     $dy_5,80($a_packet_2)                   # 33o

        fm      $b_4,$cx_2,$dx_4                        # 34e
        lqd     $dz_3,176($a_packet_2)                  # 34o

        fm      $b_5,$cx_2,$dx_5                        # 35e
        lqd     $dz_4,128($a_packet_2)                  # 35o

        fma     $b_2,$cy_2,$dy_2,$b_2                   # 36e
        shufb   $cz_2,$quad_2,$quad_2,$m_z              # 36o

        lqd     $dz_5,144($a_packet_2)                  # 37o
        shufb   $radius2_2,$quad_2,$quad_2,$m_radius2   # 38o

        fma     $b_3,$cy_2,$dy_5,$b_3                   # 39e
        fma     $b_4,$cy_2,$dy_4,$b_4                   # 40e

        fma     $b_5,$cy_2,$dy_3,$b_5                   # 41e
        hbrr    next_pair_back,next_pair                # 41o hint

        fma     $b_6,$cz_2,$dz_2,$b_2                   # 42e
        fma     $b_7,$cz_2,$dz_5,$b_3                   # 45e

        fma     $b_8,$cz_2,$dz_3,$b_4                   # 46e
        fma     $b_9,$cz_2,$dz_4,$b_5                   # 47e

        fnms    $lx,$b_6,$dx_2,$cx_2                    # 48e
        fnms    $ly_2,$b_6,$dy_2,$cy_2                  # 49e

        fnms    $lz_2,$b_6,$dz_2,$cz_2                  # 50e
        fnms    $lx_2,$b_7,$dx_3,$cx_2                  # 51e

        fnms    $lz_3,$b_8,$dz_3,$cz_2                  # 52e
        fnms    $lx_3,$b_9,$dx_5,$cx_2                  # 53e

        fnms    $lx_4,$b_8,$dx_4,$cx_2                  # 54e
        fnms    $ly_3,$b_9,$dy_3,$cy_2                  # 55e

        fnms    $disc_2,$lx,$lx,$radius2_2              # 56e
        fnms    $ly_4,$b_7,$dy_5,$cy_2                  # 57e

        fnms    $ly,$b_8,$dy_4,$cy_2                    # 58e
        fnms    $disc_3,$lx_3,$lx_3,$radius2_2          # 59e

        fnms    $disc,$lx_2,$lx_2,$radius2_2            # 60e
        fnms    $disc_4,$lx_4,$lx_4,$radius2_2          # 61e

        fnms    $disc_5,$ly_2,$ly_2,$disc_2             # 62e
        fnms    $lz_4,$b_9,$dz_4,$cz_2                  # 63e

        fnms    $lz,$b_7,$dz_5,$cz_2                    # 64e
        fnms    $disc_6,$ly_3,$ly_3,$disc_3             # 65e

        fnms    $disc,$ly_4,$ly_4,$disc                 # 66e
        fnms    $disc_7,$ly,$ly,$disc_4                 # 67e

        fnms    $disc_8,$lz_2,$lz_2,$disc_5             # 68e
        fnms    $disc_9,$lz_4,$lz_4,$disc_6             # 71e

        fnms    $disc_10,$lz,$lz,$disc                  # 72e
        fnms    $disc_11,$lz_3,$lz_3,$disc_7            # 73e

        frsqest $y,$disc_8                              # 74o
        frsqest $y_2,$disc_9                            # 77o

        fi      $y_3,$disc_8,$y                         # 78e
        frsqest $y_4,$disc_10                           # 78o

        nop     $127                                    # 79e pairing
        frsqest $y_5,$disc_11                           # 79o

next_pair:
            fi      $y,$disc_10,$y_4                    # 0e
            lqd     $t_best,192($a_packet_2)            # 0o

            fi      $y_4,$disc_9,$y_2                   # 1e
            lqd     $nearest,304($a_packet_2)           # 1o

            fi      $y_2,$disc_11,$y_5                  # 2e
            lqd     $nearest_2,256($a_packet_2)         # 2o

        ai      $count,$count,-1                        # 3e
            lqd     $t_best_2,208($a_packet_2)          # 3o

        nop     $127                                    # 4e pairing
        lqd     $object,0($a_pair)                      # 4o

        ai      $a_pair,$a_pair,16                      # 5e
            lqd     $t_best_3,224($a_packet_2)          # 5o

            fm      $s,$disc_8,$y_3                     # 6e
            lqd     $nearest_3,288($a_packet_2)         # 6o

            fm      $s_2,$disc_10,$y                    # 7e
            shlqbyi $a_packet_3,$a_packet_2,0           # 7o copy

            fm      $s_3,$disc_9,$y_4                   # 8e
            lqd     $t_best_4,240($a_packet_2)          # 8o

            fm      $s_4,$disc_11,$y_2                  # 9e
            lqd     $nearest_4,272($a_packet_2)         # 9o

        rotqbyi $a_packet_2,$object,4                   # 10o
        lqd     $quad_2,0($object)                      # 11o

            fnms    $e,$s,$y_3,$k_one                   # 12e 1 - s y
            fnms    $e_2,$s_2,$y,$k_one                 # 13e 1 - s y

            fnms    $e_3,$s_3,$y_4,$k_one               # 14e 1 - s y
            lnop                                        # 14o pairing

            fnms    $e_4,$s_4,$y_2,$k_one               # 15e 1 - s y
        lqd     $dx_5,0($a_packet_2)                    # 15o

        lqd     $dx_2,32($a_packet_2)                   # 16o
        shufb   $cy_2,$quad_2,$quad_2,$m_y              # 17o

            fma     $e,$e,$k_half,$k_one                # 18e
        shufb   $cx_2,$quad_2,$quad_2,$m_x              # 18o

            fma     $e_2,$e_2,$k_half,$k_one            # 19e
            lnop                                        # 19o pairing

            fma     $e_3,$e_3,$k_half,$k_one            # 20e
        lqd     $dx_3,16($a_packet_2)                   # 20o

            fma     $e_4,$e_4,$k_half,$k_one            # 21e
        lqd     $dx_4,48($a_packet_2)                   # 21o

        fm      $b_5,$cx_2,$dx_5                        # 22e
        shufb   $cz_2,$quad_2,$quad_2,$m_z              # 22o

        fm      $b_2,$cx_2,$dx_2                        # 23e
            fnms    $t_2,$s,$e,$b_6                     # 24e

            fnms    $t_3,$s_2,$e_2,$b_7                 # 25e
        shufb   $radius2_2,$quad_2,$quad_2,$m_radius2   # 25o

            fnms    $t_4,$s_3,$e_3,$b_9                 # 26e
            lnop                                        # 26o pairing

        fm      $b_3,$cx_2,$dx_3                        # 27e
        lqd     $dy_2,96($a_packet_2)                   # 27o

        fm      $b_4,$cx_2,$dx_4                        # 28e
            fnms    $t_5,$s_4,$e_4,$b_8                 # 29e

            clgt    $hit_2,$t_best_3,$t_2               # 30e
        lqd     $dy_3,64($a_packet_2)                   # 30o

            clgt    $hit_3,$t_best_2,$t_3               # 31e
        lqd     $dy_5,80($a_packet_2)                   # 31o

            andc    $hit_2,$hit_2,$disc_8               # 32e its signs alone count
        lqd     $dy_4,112($a_packet_2)                  # 32o

        fma     $b_2,$cy_2,$dy_2,$b_2                   # 33e
        lnop                                            # 33o pairing

            andc    $hit_3,$hit_3,$disc_10              # 34e its signs alone count
        lqd     $dz_2,160($a_packet_2)                  # 34o

            clgt    $hit_4,$t_best,$t_4                 # 35e
        lqd     $dz_4,128($a_packet_2)                  # 35o

        fma     $b_5,$cy_2,$dy_3,$b_5                   # 36e
            rotqbii $hit_2,$hit_2,1                     # 36o

        fma     $b_3,$cy_2,$dy_5,$b_3                   # 37e
            rotqbii $hit_3,$hit_3,1                     # 37o

        fma     $b_4,$cy_2,$dy_4,$b_4                   # 38e
        lqd     $dz_5,144($a_packet_2)                  # 38o

            andc    $hit_4,$hit_4,$disc_9               # 39e its signs alone count
        lqd     $dz_3,176($a_packet_2)                  # 39o

        fma     $b_6,$cz_2,$dz_2,$b_2                   # 40e
            gb      $hit_2,$hit_2                       # 40o

            clgt    $hit_5,$t_best_4,$t_5               # 41e
            gb      $hit_3,$hit_3                       # 41o

        fma     $b_9,$cz_2,$dz_4,$b_5                   # 42e
            rotqbii $hit_6,$hit_4,1                     # 42o

            andc    $hit_5,$hit_5,$disc_11              # 43e its signs alone count
            lnop                                        # 43o pairing

        fma     $b_7,$cz_2,$dz_5,$b_3                   # 44e
            shlqbii $hit_7,$hit_2,4                     # 44o

        fma     $b_8,$cz_2,$dz_3,$b_4                   # 45e
            rotqbii $hit_2,$hit_5,1                     # 45o

        fnms    $lz_2,$b_6,$dz_2,$cz_2                  # 46e
            shlqbii $hit_5,$hit_3,4                     # 46o

        fnms    $ly_2,$b_6,$dy_2,$cy_2                  # 47e
            gb      $hit_6,$hit_6                       # 47o

        fnms    $lx,$b_6,$dx_2,$cx_2                    # 48e
            lqx     $merge_2,$bits,$hit_7               # 48o

        fnms    $lx_3,$b_9,$dx_5,$cx_2                  # 49e
            gb      $hit_2,$hit_2                       # 49o

        fnms    $lx_2,$b_7,$dx_3,$cx_2                  # 50e
        lnop                                            # 50o pairing

        fnms    $lx_4,$b_8,$dx_4,$cx_2                  # 51e
            shlqbii $hit_8,$hit_6,4                     # 51o

        fnms    $ly_3,$b_9,$dy_3,$cy_2                  # 52e
            lqx     $merge,$bits,$hit_5                 # 52o

        fnms    $ly_4,$b_7,$dy_5,$cy_2                  # 53e
            shlqbii $hit_2,$hit_2,4                     # 53o

        fnms    $disc_2,$lx,$lx,$radius2_2              # 54e
            shufb   $nearest_3,$nearest_3,$object_2,$merge_2 # 54o

        fnms    $ly,$b_8,$dy_4,$cy_2                    # 55e
        lnop                                            # 55o pairing

        fnms    $disc_3,$lx_3,$lx_3,$radius2_2          # 56e
            lqx     $merge_3,$bits,$hit_8               # 56o

        fnms    $disc,$lx_2,$lx_2,$radius2_2            # 57e
            lqx     $merge_4,$bits,$hit_2               # 57o

        fnms    $disc_4,$lx_4,$lx_4,$radius2_2          # 58e
            shufb   $t_best_3,$t_best_3,$t_2,$merge_2   # 58o

        fnms    $lz,$b_7,$dz_5,$cz_2                    # 59e
            shufb   $t_best_2,$t_best_2,$t_3,$merge     # 59o

        fnms    $disc_5,$ly_2,$ly_2,$disc_2             # 60e
            shufb   $nearest_5,$nearest_4,$object_2,$merge # 60o

        fnms    $lz_4,$b_9,$dz_4,$cz_2                  # 61e
            stqd    $nearest_3,288($a_packet_3)         # 61o

        fnms    $lz_3,$b_8,$dz_3,$cz_2                  # 62e
            shufb   $t_best,$t_best,$t_4,$merge_3       # 62o

        fnms    $disc,$ly_4,$ly_4,$disc                 # 63e
            stqd    $t_best_3,224($a_packet_3)          # 63o

        fnms    $disc_6,$ly_3,$ly_3,$disc_3             # 64e
            stqd    $t_best_2,208($a_packet_3)          # 64o

        fnms    $disc_7,$ly,$ly,$disc_4                 # 65e
            stqd    $nearest_5,272($a_packet_3)         # 65o

        fnms    $disc_8,$lz_2,$lz_2,$disc_5             # 66e
            shufb   $nearest_2,$nearest_2,$object_2,$merge_3 # 66o

            stqd    $t_best,192($a_packet_3)            # 67o
            shufb   $t_best,$t_best_4,$t_5,$merge_4     # 68o

        fnms    $disc_10,$lz,$lz,$disc                  # 69e
            shufb   $nearest,$nearest,$object_2,$merge_4 # 69o

        fnms    $disc_9,$lz_4,$lz_4,$disc_6             # 70e
            stqd    $nearest_2,256($a_packet_3)         # 70o

        fnms    $disc_11,$lz_3,$lz_3,$disc_7            # 71e
        shufb   $object_2,$object,$object,$m_x          # 71o

            stqd    $t_best,240($a_packet_3)            # 72o
            stqd    $nearest,304($a_packet_3)           # 73o

        frsqest $y,$disc_8                              # 74o
        frsqest $y_4,$disc_10                           # 75o

        frsqest $y_2,$disc_9                            # 76o
        frsqest $y_5,$disc_11                           # 77o

        fi      $y_3,$disc_8,$y                         # 78e
next_pair_back:
        brnz    $count,next_pair                        # 78o

next_pair_drain:
        fi      $y,$disc_10,$y_4                        # 0e
        lqd     $t_best_2,208($a_packet_2)              # 0o

        fi      $y_4,$disc_9,$y_2                       # 1e
        lqd     $t_best_4,240($a_packet_2)              # 1o

        fi      $y_2,$disc_11,$y_5                      # 2e
        lqd     $t_best,192($a_packet_2)                # 2o

        nop     $127                                    # 3e pairing
        lqd     $t_best_3,224($a_packet_2)              # 3o

        fm      $s,$disc_8,$y_3                         # 4e
        lqd     $nearest_2,256($a_packet_2)             # 4o

        hbr     isect_pairs_r16_return,$lr              # 5o hint
        lqd     $nearest,304($a_packet_2)               # 6o

        fm      $s_2,$disc_10,$y                        # 7e
        lqd     $nearest_3,288($a_packet_2)             # 7o

        fm      $s_3,$disc_9,$y_4                       # 8e
        lqd     $nearest_4,272($a_packet_2)             # 8o

        fm      $s_4,$disc_11,$y_2                      # 9e
        shlqbyi $a_packet_3,$a_packet_2,0               # 9o copy

        fnms    $e,$s,$y_3,$k_one                       # 10e 1 - s y
        fnms    $e_2,$s_2,$y,$k_one                     # 13e 1 - s y

        fnms    $e_3,$s_3,$y_4,$k_one                   # 14e 1 - s y
        fnms    $e_4,$s_4,$y_2,$k_one                   # 15e 1 - s y

        fma     $e,$e,$k_half,$k_one                    # 16e
        fma     $e_2,$e_2,$k_half,$k_one                # 19e

        fma     $e_3,$e_3,$k_half,$k_one                # 20e
        fma     $e_4,$e_4,$k_half,$k_one                # 21e

        fnms    $t_2,$s,$e,$b_6                         # 22e
        fnms    $t_3,$s_2,$e_2,$b_7                     # 25e

        fnms    $t_4,$s_3,$e_3,$b_9                     # 26e
        fnms    $t_5,$s_4,$e_4,$b_8                     # 27e

        clgt    $hit_2,$t_best_3,$t_2                   # 28e
        andc    $hit_2,$hit_2,$disc_8                   # 30e its signs alone count

        clgt    $hit_3,$t_best_2,$t_3                   # 31e
        lnop                                            # 31o pairing

        clgt    $hit_4,$t_best,$t_4                     # 32e
        rotqbii $hit_2,$hit_2,1                         # 32o

        andc    $hit_3,$hit_3,$disc_10                  # 33e its signs alone count
        clgt    $hit_5,$t_best_4,$t_5                   # 34e

        andc    $hit_4,$hit_4,$disc_9                   # 35e its signs alone count
        rotqbii $hit_3,$hit_3,1                         # 35o

        andc    $hit_5,$hit_5,$disc_11                  # 36e its signs alone count
        gb      $hit_2,$hit_2                           # 36o

        rotqbii $hit_6,$hit_4,1                         # 37o
        rotqbii $hit_9,$hit_5,1                         # 38o

        gb      $hit_3,$hit_3                           # 39o
        shlqbii $hit_7,$hit_2,4                         # 40o

        gb      $hit_6,$hit_6                           # 41o
        gb      $hit_2,$hit_9                           # 42o

        shlqbii $hit_5,$hit_3,4                         # 43o
        lqx     $merge_2,$bits,$hit_7                   # 44o

        shlqbii $hit_8,$hit_6,4                         # 45o
        shlqbii $hit_2,$hit_2,4                         # 46o

        lqx     $merge,$bits,$hit_5                     # 47o
        lqx     $merge_3,$bits,$hit_8                   # 49o

        lqx     $merge_4,$bits,$hit_2                   # 50o
        shufb   $nearest_3,$nearest_3,$object_2,$merge_2 # 51o

        shufb   $t_best_3,$t_best_3,$t_2,$merge_2       # 52o
        shufb   $t_best_2,$t_best_2,$t_3,$merge         # 53o

        shufb   $nearest_5,$nearest_4,$object_2,$merge  # 54o
        shufb   $t_best,$t_best,$t_4,$merge_3           # 55o

        shufb   $nearest,$nearest,$object_2,$merge_4    # 56o
        shufb   $t_best_5,$t_best_4,$t_5,$merge_4       # 57o

        shufb   $nearest_2,$nearest_2,$object_2,$merge_3 # 58o
        stqd    $nearest_3,288($a_packet_3)             # 59o

        stqd    $t_best_3,224($a_packet_3)              # 60o
        stqd    $t_best_5,240($a_packet_3)              # 61o

        stqd    $t_best,192($a_packet_3)                # 62o
        stqd    $nearest,304($a_packet_3)               # 63o

        stqd    $t_best_2,208($a_packet_3)              # 64o
        stqd    $nearest_5,272($a_packet_3)             # 65o

        stqd    $nearest_2,256($a_packet_3)             # 66o
isect_pairs_r16_return:
        bi      $lr                                     # 67o

next_pair_short:
        ai      $count,$count,-1                        # 0e
        lqd     $object,0($a_pair)                      # 0o

        ai      $a_pair,$a_pair,16                      # 1e
        rotqbyi $a_packet,$object,4                     # 6o

        lqd     $quad,0($object)                        # 7o
        shufb   $object,$object,$object,$m_x            # 8o

        lqd     $dx,0($a_packet)                        # 10o
        lqd     $dx_6,16($a_packet)                     # 11o

        lqd     $dx_7,32($a_packet)                     # 12o
        lqd     $dx_8,48($a_packet)                     # 13o

        shufb   $cx,$quad,$quad,$m_x                    # 14o
        lqd     $dy,64($a_packet)                       # 15o

        lqd     $dy_6,80($a_packet)                     # 16o
        lqd     $dy_7,96($a_packet)                     # 17o

        fm      $b,$cx,$dx                              # 18e
        lqd     $dy_8,112($a_packet)                    # 18o

        fm      $b_10,$cx,$dx_6                         # 19e
        shufb   $cy_3,$quad,$quad,$m_y                  # 19o

        fm      $b_11,$cx,$dx_7                         # 20e
        lqd     $dz,128($a_packet)                      # 20o

        fm      $b_12,$cx,$dx_8                         # 21e
        lqd     $dz_6,144($a_packet)                    # 21o

        lqd     $dz_7,160($a_packet)                    # 22o
        lqd     $dz_8,176($a_packet)                    # 23o

        fma     $b,$cy_3,$dy,$b                         # 24e
        shufb   $cz_3,$quad,$quad,$m_z                  # 24o

        fma     $b_10,$cy_3,$dy_6,$b_10                 # 25e
        shufb   $radius2_3,$quad,$quad,$m_radius2       # 25o

        fma     $b_11,$cy_3,$dy_7,$b_11                 # 26e
        lqd     $t_best_6,192($a_packet)                # 26o

        fma     $b_12,$cy_3,$dy_8,$b_12                 # 27e
        lqd     $t_best_7,208($a_packet)                # 27o

        lqd     $t_best_8,224($a_packet)                # 28o
        lqd     $t_best_9,240($a_packet)                # 29o

        fma     $b,$cz_3,$dz,$b                         # 30e
        lqd     $nearest_6,256($a_packet)               # 30o

        fma     $b_10,$cz_3,$dz_6,$b_10                 # 31e
        lqd     $nearest_7,272($a_packet)               # 31o

        fma     $b_11,$cz_3,$dz_7,$b_11                 # 32e
        lqd     $nearest_8,288($a_packet)               # 32o

        fma     $b_12,$cz_3,$dz_8,$b_12                 # 33e
        lqd     $nearest_9,304($a_packet)               # 33o

        fnms    $lx_5,$b,$dx,$cx                        # 36e
        fnms    $lx_6,$b_10,$dx_6,$cx                   # 37e

        fnms    $lx_7,$b_11,$dx_7,$cx                   # 38e
        fnms    $lx_8,$b_12,$dx_8,$cx                   # 39e

        fnms    $ly_5,$b,$dy,$cy_3                      # 40e
        fnms    $ly_6,$b_10,$dy_6,$cy_3                 # 41e

        fnms    $disc_12,$lx_5,$lx_5,$radius2_3         # 42e
        fnms    $disc_6,$lx_6,$lx_6,$radius2_3          # 43e

        fnms    $ly_7,$b_11,$dy_7,$cy_3                 # 44e
        fnms    $disc_13,$lx_7,$lx_7,$radius2_3         # 45e

        fnms    $ly_8,$b_12,$dy_8,$cy_3                 # 46e
        fnms    $disc_14,$lx_8,$lx_8,$radius2_3         # 47e

        fnms    $lz_5,$b,$dz,$cz_3                      # 48e
        fnms    $disc_15,$ly_5,$ly_5,$disc_12           # 49e

        fnms    $lz_6,$b_10,$dz_6,$cz_3                 # 50e
        fnms    $disc_6,$ly_6,$ly_6,$disc_6             # 51e

        fnms    $lz_7,$b_11,$dz_7,$cz_3                 # 52e
        fnms    $disc_13,$ly_7,$ly_7,$disc_13           # 53e

        fnms    $lz,$b_12,$dz_8,$cz_3                   # 54e
        fnms    $disc_14,$ly_8,$ly_8,$disc_14           # 55e

        fnms    $disc_16,$lz_5,$lz_5,$disc_15           # 56e
        fnms    $disc_6,$lz_6,$lz_6,$disc_6             # 57e

        fnms    $disc_13,$lz_7,$lz_7,$disc_13           # 59e
        fnms    $disc_14,$lz,$lz,$disc_14               # 61e

        frsqest $y_6,$disc_16                           # 62o
        frsqest $y_7,$disc_6                            # 63o

        frsqest $y_8,$disc_13                           # 65o
        fi      $y_6,$disc_16,$y_6                      # 66e

        fi      $y_7,$disc_6,$y_7                       # 67e
        frsqest $y_9,$disc_14                           # 67o

        fi      $y_8,$disc_13,$y_8                      # 69e
        fi      $y_9,$disc_14,$y_9                      # 71e

        fm      $s_4,$disc_16,$y_6                      # 73e
        fm      $s_5,$disc_6,$y_7                       # 74e

        fm      $s_6,$disc_13,$y_8                      # 76e
        fm      $s_7,$disc_14,$y_9                      # 78e

        fnms    $e_5,$s_4,$y_6,$k_one                   # 79e 1 - s y
        fnms    $e_6,$s_5,$y_7,$k_one                   # 80e 1 - s y

        fnms    $e_7,$s_6,$y_8,$k_one                   # 82e 1 - s y
        fnms    $e_8,$s_7,$y_9,$k_one                   # 84e 1 - s y

        fma     $e_5,$e_5,$k_half,$k_one                # 85e
        fma     $e_6,$e_6,$k_half,$k_one                # 86e

        fma     $e_7,$e_7,$k_half,$k_one                # 88e
        fma     $e_8,$e_8,$k_half,$k_one                # 90e

        fnms    $t_6,$s_4,$e_5,$b                       # 91e
        fnms    $t_7,$s_5,$e_6,$b_10                    # 92e

        fnms    $t_8,$s_6,$e_7,$b_11                    # 94e
        fnms    $t_9,$s_7,$e_8,$b_12                    # 96e

        clgt    $hit_10,$t_best_6,$t_6                  # 97e
        clgt    $hit_2,$t_best_7,$t_7                   # 98e

        andc    $hit_11,$hit_10,$disc_16                # 99e its signs alone count
        clgt    $hit_10,$t_best_8,$t_8                  # 100e

        andc    $hit_12,$hit_2,$disc_6                  # 101e its signs alone count
        rotqbii $hit_11,$hit_11,1                       # 101o

        clgt    $hit_2,$t_best_9,$t_9                   # 102e
        lnop                                            # 102o pairing

        andc    $hit_13,$hit_10,$disc_13                # 103e its signs alone count
        rotqbii $hit_12,$hit_12,1                       # 103o

        andc    $hit_14,$hit_2,$disc_14                 # 104e its signs alone count
        rotqbii $hit_13,$hit_13,1                       # 105o

        rotqbii $hit_14,$hit_14,1                       # 106o
        gb      $hit_11,$hit_11                         # 107o

        gb      $hit_12,$hit_12                         # 108o
        gb      $hit_13,$hit_13                         # 109o

        gb      $hit_14,$hit_14                         # 110o
        shlqbii $hit_11,$hit_11,4                       # 111o

        shlqbii $hit_12,$hit_12,4                       # 112o
        shlqbii $hit_13,$hit_13,4                       # 113o

        shlqbii $hit_14,$hit_14,4                       # 114o
        lqx     $merge_5,$bits,$hit_11                  # 115o

        lqx     $merge_6,$bits,$hit_12                  # 116o
        lqx     $merge_7,$bits,$hit_13                  # 117o

        lqx     $merge_8,$bits,$hit_14                  # 118o
        shufb   $t_best,$t_best_6,$t_6,$merge_5         # 121o

        shufb   $nearest,$nearest_6,$object,$merge_5    # 122o
        shufb   $t_best_2,$t_best_7,$t_7,$merge_6       # 123o

        shufb   $nearest_10,$nearest_7,$object,$merge_6 # 124o
        shufb   $t_best_3,$t_best_8,$t_8,$merge_7       # 125o

        shufb   $nearest_11,$nearest_8,$object,$merge_7 # 126o
        shufb   $t_best_10,$t_best_9,$t_9,$merge_8      # 127o

        shufb   $nearest_2,$nearest_9,$object,$merge_8  # 128o
        stqd    $t_best,192($a_packet)                  # 129o

        stqd    $nearest,256($a_packet)                 # 130o
        stqd    $t_best_2,208($a_packet)                # 131o

        stqd    $nearest_10,272($a_packet)              # 132o
        stqd    $t_best_3,224($a_packet)                # 133o

        stqd    $nearest_11,288($a_packet)              # 134o
        stqd    $t_best_10,240($a_packet)               # 135o

        stqd    $nearest_2,304($a_packet)               # 136o
        brnz    $count,next_pair_short                  # 137o

        nop     $127                                    # 138e pairing
        bi      $lr                                     # 138o
endfunction isect_pairs_r16
