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
        .set    a_pair_2,2
        .set    object_2,5
        .set    object_3,7
        .set    a_packet_2,2
        .set    quad_2,20
        .set    a_packet_3,19
        .set    quad_3,6
        .set    dx_2,29
        .set    dx_3,22
        .set    cx_2,23
        .set    dy_2,35
        .set    cy_2,25
        .set    dy_3,36
        .set    b_2,30
        .set    dy_4,31
        .set    b_3,21
        .set    dz_2,42
        .set    b_4,32
        .set    cz_2,26
        .set    dz_3,44
        .set    dz_4,39
        .set    radius2_2,9
        .set    dx_4,34
        .set    dy_5,45
        .set    dz_5,43
        .set    dx_5,27
        .set    cx_3,33
        .set    dy_6,37
        .set    dx_6,38
        .set    dx_7,40
        .set    cy_3,48
        .set    b_5,8
        .set    dz_6,49
        .set    b_6,18
        .set    dy_7,50
        .set    dy_8,51
        .set    lx_2,24
        .set    t_best_2,52
        .set    lx_3,29
        .set    cz_3,53
        .set    lx_4,22
        .set    t_best_3,54
        .set    ly_2,35
        .set    t_best_4,55
        .set    ly_3,36
        .set    dz_7,56
        .set    dz_8,57
        .set    disc_2,24
        .set    radius2_3,20
        .set    disc_3,29
        .set    dx_8,6
        .set    disc_4,22
        .set    dy_9,58
        .set    lz_2,41
        .set    nearest_2,42
        .set    lz_3,44
        .set    lz_4,39
        .set    nearest_3,5
        .set    nearest_4,35
        .set    dz_9,36
        .set    a_packet_4,59
        .set    b_7,31
        .set    a_packet_5,8
        .set    b_8,46
        .set    b_9,47
        .set    t_best_5,18
        .set    disc_5,2
        .set    b_10,39
        .set    y_2,41
        .set    b_11,44
        .set    y_3,47
        .set    y_4,60
        .set    lx_5,23
        .set    ly_4,25
        .set    disc_6,9
        .set    lz_5,23
        .set    s_2,26
        .set    s_3,43
        .set    s_4,45
        .set    lx_6,25
        .set    e_2,27
        .set    e_3,34
        .set    e_4,60
        .set    b_12,41
        .set    e_5,23
        .set    e_6,31
        .set    ly_5,34
        .set    disc_7,25
        .set    y_5,37
        .set    lx_7,38
        .set    t_2,23
        .set    t_3,26
        .set    t_4,27
        .set    y_6,21
        .set    hit_2,31
        .set    hit_3,32
        .set    hit_4,2
        .set    hit_5,43
        .set    hit_6,24
        .set    s_5,22
        .set    disc_8,37
        .set    e_7,40
        .set    hit_7,30
        .set    disc_9,51
        .set    lz_6,24
        .set    merge_2,38
        .set    merge_3,30
        .set    lz_7,37
        .set    b_13,50
        .set    y_7,31
        .set    nearest_5,32
        .set    disc_10,40
        .set    t_best_6,23
        .set    t_5,21
        .set    y_8,22
        .set    disc_11,52
        .set    t_best_7,2
        .set    nearest_6,6
        .set    t_best_8,49
        .set    nearest_7,48
        .set    t_best_9,9
        .set    nearest_8,53
        .set    nearest_9,54
        .set    y_9,2
        .set    y_10,5
        .set    t_best_10,6
        .set    s_6,6
        .set    s_7,9
        .set    e_8,21
        .set    e_9,5
        .set    t_6,6
        .set    t_7,5
        .set    b_14,9
        .set    y_11,40
        .set    hit_8,41
        .set    s_8,21
        .set    e_10,38
        .set    merge_4,32
        .set    lz_8,40
        .set    disc_12,6
        .set    nearest_10,31
        .set    object_4,3
        .set    a_packet_6,4
        .set    y_12,7
        .set    e_11,7
        .set    nearest_11,7
        .set    hit_9,8
        .set    dx_9,2
        .set    dx_10,5
        .set    dy_10,6
        .set    dy_11,7
        .set    dz_10,22
        .set    dz_11,23
        .set    cz_4,27
        .set    dx_11,28
        .set    dy_12,30
        .set    radius2_4,19
        .set    dz_12,31
        .set    t_best_11,32
        .set    t_best_12,33
        .set    b_15,34
        .set    t_best_13,35
        .set    t_best_14,36
        .set    nearest_12,37
        .set    nearest_13,38
        .set    nearest_14,39
        .set    nearest_15,40
        .set    lx_8,2
        .set    lx_9,5
        .set    ly_6,6
        .set    ly_7,7
        .set    disc_13,5
        .set    lz_9,26
        .set    lz_10,22
        .set    lz_11,6
        .set    lx_10,7
        .set    ly_8,20
        .set    disc_14,21
        .set    y_13,19
        .set    y_14,23
        .set    y_15,20
        .set    s_9,23
        .set    s_10,24
        .set    y_16,25
        .set    e_12,19
        .set    e_13,20
        .set    t_8,7
        .set    t_9,8
        .set    t_10,9
        .set    hit_10,20
        .set    hit_11,22
        .set    hit_12,23
        .set    hit_13,5
        .set    t_11,19
        .set    merge_5,20
        .set    hit_14,21
        .set    merge_6,2
        .set    merge_7,5
        .set    hit_15,6
        .set    t_best_15,7
        .set    t_best_16,8
        .set    nearest_16,2
        nop     $127                                    # 0e pairing
        biz     $count,$lr                              # 0o

        ilhu    $m_x,1                                  # 1e
        ilhu    $m_y,0x405                              # 2e

        ilhu    $m_z,0x809                              # 3e
        ilhu    $m_radius2,0xc0d                        # 4e

        clgti   $count_2,$count,2                       # 5e at least as many passes as overlap
        iohl    $m_x,515                                # 6e

        iohl    $m_y,0x607                              # 7e
        iohl    $m_z,0xa0b                              # 8e

        iohl    $m_radius2,0xe0f                        # 9e
        ilhu    $k_half,0x3f00                          # 10e

        ilhu    $k_one,0x3f80                           # 11e
        lnop                                            # 11o pairing

        ila     $bits,merges                            # 12e
        brz     $count_2,next_pair_short                # 12o too few passes

        ai      $a_pair_2,$a_pair,16                    # 13e
        lqd     $object_2,0($a_pair)                    # 13o

        ai      $count,$count,-1                        # 14e
        lnop                                            # 14o pairing

        ai      $a_pair,$a_pair_2,16                    # 15e
        lqd     $object_3,0($a_pair_2)                  # 15o

        ai      $count,$count,-1                        # 16e
        rotqbyi $a_packet_2,$object_2,4                 # 19o

        lqd     $quad_2,0($object_2)                    # 20o
        rotqbyi $a_packet_3,$object_3,4                 # 21o

        lqd     $quad_3,0($object_3)                    # 22o
        lqd     $dx,32($a_packet_2)                     # 23o

        lqd     $dx_2,48($a_packet_2)                   # 24o
        lqd     $dx_3,16($a_packet_2)                   # 25o

        shufb   $cx_2,$quad_2,$quad_2,$m_x              # 26o
        lqd     $dy_2,96($a_packet_2)                   # 27o

        shufb   $cy_2,$quad_2,$quad_2,$m_y              # 28o
        lqd     $dy_3,112($a_packet_2)                  # 29o

        fm      $b_2,$cx_2,$dx                          # 30e
        lqd     $dy_4,80($a_packet_2)                   # 30o

        fm      $b_3,$cx_2,$dx_2                        # 31e
        lqd     $dz_2,160($a_packet_2)                  # 31o

        fm      $b_4,$cx_2,$dx_3                        # 32e
        shufb   $cz_2,$quad_2,$quad_2,$m_z              # 32o

        lqd     $dz_3,176($a_packet_2)                  # 33o
        lqd     $dz_4,144($a_packet_2)                  # 34o

        nop     $127                                    # 35e pairing
        shufb   $radius2_2,$quad_2,$quad_2,$m_radius2   # 35o

        fma     $b_2,$cy_2,$dy_2,$b_2                   # 36e
        lqd     $dx_4,0($a_packet_2)                    # 36o

        fma     $b_3,$cy_2,$dy_3,$b_3                   # 37e
        lqd     $dy_5,64($a_packet_2)                   # 37o

        fma     $b_4,$cy_2,$dy_4,$b_4                   # 38e
        lqd     $dz_5,128($a_packet_2)                  # 38o

        lqd     $dx_5,16($a_packet_3)                   # 39o
        shufb   $cx_3,$quad_3,$quad_3,$m_x              # 40o

        nop     $127                                    # 41e pairing
        lqd     $dy_6,80($a_packet_3)                   # 41o

        fma     $b_2,$cz_2,$dz_2,$b_2                   # 42e
        lqd     $dx_6,32($a_packet_3)                   # 42o

        fma     $b_3,$cz_2,$dz_3,$b_3                   # 43e
        lqd     $dx_7,48($a_packet_3)                   # 43o

        fma     $b_4,$cz_2,$dz_4,$b_4                   # 44e
        shufb   $cy_3,$quad_3,$quad_3,$m_y              # 44o

        fm      $b_5,$cx_2,$dx_4                        # 45e
        lqd     $dz_6,144($a_packet_3)                  # 45o

        fm      $b_6,$cx_3,$dx_5                        # 46e
        lqd     $dy_7,96($a_packet_3)                   # 46o

        nop     $127                                    # 47e pairing
        lqd     $dy_8,112($a_packet_3)                  # 47o

        fnms    $lx_2,$b_2,$dx,$cx_2                    # 48e
        lqd     $t_best_2,224($a_packet_2)              # 48o

        fnms    $lx_3,$b_3,$dx_2,$cx_2                  # 49e
        shufb   $cz_3,$quad_3,$quad_3,$m_z              # 49o

        fnms    $lx_4,$b_4,$dx_3,$cx_2                  # 50e
        lqd     $t_best_3,240($a_packet_2)              # 50o

        fnms    $ly_2,$b_2,$dy_2,$cy_2                  # 51e
        lqd     $t_best_4,208($a_packet_2)              # 51o

        fnms    $ly_3,$b_3,$dy_3,$cy_2                  # 52e
        lqd     $dz_7,160($a_packet_3)                  # 52o

        fnms    $ly,$b_4,$dy_4,$cy_2                    # 53e
        lqd     $dz_8,176($a_packet_3)                  # 53o

        fnms    $disc_2,$lx_2,$lx_2,$radius2_2          # 54e
        shufb   $radius2_3,$quad_3,$quad_3,$m_radius2   # 54o

        fnms    $disc_3,$lx_3,$lx_3,$radius2_2          # 55e
        lqd     $dx_8,0($a_packet_3)                    # 55o

        fnms    $disc_4,$lx_4,$lx_4,$radius2_2          # 56e
        lqd     $dy_9,64($a_packet_3)                   # 56o

        fnms    $lz_2,$b_2,$dz_2,$cz_2                  # 57e
        lqd     $nearest_2,288($a_packet_2)             # 57o

        fnms    $lz_3,$b_3,$dz_3,$cz_2                  # 58e
        shufb   $object,$object_2,$object_2,$m_x        # 58o

        fnms    $lz_4,$b_4,$dz_4,$cz_2                  # 59e
        lqd     $nearest_3,304($a_packet_2)             # 59o

        fnms    $disc_2,$ly_2,$ly_2,$disc_2             # 60e
        lqd     $nearest_4,272($a_packet_2)             # 60o

        fnms    $disc_3,$ly_3,$ly_3,$disc_3             # 61e
        lqd     $dz_9,128($a_packet_3)                  # 61o

        fnms    $disc_4,$ly,$ly,$disc_4                 # 62e
        shlqbyi $a_packet_4,$a_packet_2,0               # 62o copy

        fma     $b_7,$cy_2,$dy_5,$b_5                   # 63e
        shlqbyi $a_packet_5,$a_packet_2,0               # 63o copy

        fma     $b_8,$cy_3,$dy_6,$b_6                   # 64e
        lqd     $nearest,256($a_packet_2)               # 64o

        fm      $b_9,$cx_3,$dx_6                        # 65e
        lqd     $t_best_5,192($a_packet_2)              # 65o

        fnms    $disc_5,$lz_2,$lz_2,$disc_2             # 66e
        fnms    $disc_2,$lz_3,$lz_3,$disc_3             # 67e

        fnms    $disc_4,$lz_4,$lz_4,$disc_4             # 68e
        fma     $b,$cz_2,$dz_5,$b_7                     # 69e

        fm      $b_7,$cx_3,$dx_7                        # 70e
        fma     $b_8,$cz_3,$dz_6,$b_8                   # 71e

        fma     $b_10,$cy_3,$dy_7,$b_9                  # 72e
        frsqest $y_2,$disc_5                            # 72o

        fm      $b_11,$cx_3,$dx_8                       # 73e
        frsqest $y_3,$disc_2                            # 73o

        frsqest $y_4,$disc_4                            # 74o
        fnms    $lx_5,$b,$dx_4,$cx_2                    # 75e

        fi      $y,$disc_5,$y_2                         # 76e
        fi      $y_2,$disc_2,$y_3                       # 77e

        fi      $y_3,$disc_4,$y_4                       # 78e
        fnms    $ly_4,$b,$dy_5,$cy_2                    # 80e

        fnms    $disc_6,$lx_5,$lx_5,$radius2_2          # 81e
        fnms    $lz_5,$b,$dz_5,$cz_2                    # 82e

        fm      $s_2,$disc_5,$y                         # 83e
        fm      $s_3,$disc_2,$y_2                       # 84e

        fm      $s_4,$disc_4,$y_3                       # 85e
        fma     $b_7,$cy_3,$dy_8,$b_7                   # 86e

        fnms    $disc_6,$ly_4,$ly_4,$disc_6             # 87e
        fnms    $lx_6,$b_8,$dx_5,$cx_3                  # 88e

        fnms    $e_2,$s_2,$y,$k_one                     # 89e 1 - s y
        fnms    $e_3,$s_3,$y_2,$k_one                   # 90e 1 - s y

        fnms    $e_4,$s_4,$y_3,$k_one                   # 91e 1 - s y
        fma     $b_9,$cz_3,$dz_7,$b_10                  # 92e

        fnms    $disc_6,$lz_5,$lz_5,$disc_6             # 93e
        fma     $b_12,$cz_3,$dz_8,$b_7                  # 94e

        fma     $e_5,$e_2,$k_half,$k_one                # 95e
        fma     $e_2,$e_3,$k_half,$k_one                # 96e

        fma     $e_6,$e_4,$k_half,$k_one                # 97e
        fnms    $ly_5,$b_8,$dy_6,$cy_3                  # 98e

        fnms    $disc_7,$lx_6,$lx_6,$radius2_3          # 99e
        frsqest $y_5,$disc_6                            # 99o

        fnms    $lx_7,$b_9,$dx_6,$cx_3                  # 100e
        fnms    $t_2,$s_2,$e_5,$b_2                     # 101e

        fnms    $t_3,$s_3,$e_2,$b_3                     # 102e
        fnms    $t_4,$s_4,$e_6,$b_4                     # 103e

        fi      $y_6,$disc_6,$y_5                       # 104e
        fnms    $lx,$b_12,$dx_7,$cx_3                   # 106e

        clgt    $hit_2,$t_best_2,$t_2                   # 107e
        clgt    $hit_3,$t_best_3,$t_3                   # 108e

        andc    $hit_4,$hit_2,$disc_5                   # 109e its signs alone count
        clgt    $hit_5,$t_best_4,$t_4                   # 110e

        andc    $hit_6,$hit_3,$disc_2                   # 111e its signs alone count
        rotqbii $hit_4,$hit_4,1                         # 111o

        andc    $hit_3,$hit_5,$disc_4                   # 112e its signs alone count
        lnop                                            # 112o pairing

        fm      $s_5,$disc_6,$y_6                       # 113e
        rotqbii $hit_6,$hit_6,1                         # 113o

        fnms    $lz_4,$b_8,$dz_6,$cz_3                  # 114e
        rotqbii $hit_3,$hit_3,1                         # 114o

        fnms    $disc_7,$ly_5,$ly_5,$disc_7             # 115e
        gb      $hit_4,$hit_4                           # 115o

        fnms    $ly,$b_12,$dy_8,$cy_3                   # 116e
        lnop                                            # 116o pairing

        fnms    $ly_5,$b_9,$dy_7,$cy_3                  # 117e
        gb      $hit_6,$hit_6                           # 117o

        fnms    $disc_8,$lx_7,$lx_7,$radius2_3          # 118e
        gb      $hit_3,$hit_3                           # 118o

        fnms    $e_7,$s_5,$y_6,$k_one                   # 119e 1 - s y
        shlqbii $hit,$hit_4,4                           # 119o

        fnms    $disc_5,$lx,$lx,$radius2_3              # 120e
        lnop                                            # 120o pairing

        fma     $b_3,$cy_3,$dy_9,$b_11                  # 121e
        shlqbii $hit_7,$hit_6,4                         # 121o

        fnms    $disc_9,$lz_4,$lz_4,$disc_7             # 122e
        shlqbii $hit_3,$hit_3,4                         # 122o

        fnms    $lz_6,$b_9,$dz_7,$cz_3                  # 123e
        lqx     $merge_2,$bits,$hit                     # 123o

        fnms    $disc_7,$ly_5,$ly_5,$disc_8             # 124e
        lnop                                            # 124o pairing

        fma     $e_3,$e_7,$k_half,$k_one                # 125e
        lqx     $merge_3,$bits,$hit_7                   # 125o

        fnms    $lz_7,$b_12,$dz_8,$cz_3                 # 126e
        lqx     $merge,$bits,$hit_3                     # 126o

        fnms    $disc_5,$ly,$ly,$disc_5                 # 127e
        lnop                                            # 127o pairing

        fma     $b_13,$cz_3,$dz_9,$b_3                  # 128e
        frsqest $y_7,$disc_9                            # 128o

        nop     $127                                    # 129e pairing
        shufb   $nearest_5,$nearest_2,$object,$merge_2  # 129o

        fnms    $disc_10,$lz_6,$lz_6,$disc_7            # 130e
        shufb   $t_best_6,$t_best_2,$t_2,$merge_2       # 130o

        fnms    $t_5,$s_5,$e_3,$b                       # 131e
        hbrr    next_pair_back,next_pair                # 131o hint

        fi      $y_8,$disc_9,$y_7                       # 132e
        shufb   $nearest_3,$nearest_3,$object,$merge_3  # 132o

        nop     $127                                    # 133e pairing
        stqd    $nearest_5,288($a_packet_4)             # 133o

        fnms    $disc_11,$lz_7,$lz_7,$disc_5            # 134e
        shufb   $t_best_7,$t_best_3,$t_3,$merge_3       # 134o

        fnms    $lx,$b_13,$dx_8,$cx_3                   # 135e
        stqd    $t_best_6,224($a_packet_4)              # 135o

        fnms    $lz,$b_13,$dz_9,$cz_3                   # 136e
        shufb   $nearest_6,$nearest_4,$object,$merge    # 136o

        clgt    $hit,$t_best_5,$t_5                     # 137e
        lqd     $t_best_8,224($a_packet_3)              # 137o

        fnms    $ly,$b_13,$dy_9,$cy_3                   # 138e
        lqd     $nearest_7,288($a_packet_3)             # 138o

        andc    $hit,$hit,$disc_6                       # 139e its signs alone count
        shufb   $t_best_9,$t_best_4,$t_4,$merge         # 139o

        nop     $127                                    # 140e pairing
        stqd    $nearest_3,304($a_packet_4)             # 140o

        rotmai  $hit,$hit,-31                           # 141e
        stqd    $t_best_7,240($a_packet_4)              # 141o

        stqd    $nearest_6,272($a_packet_4)             # 142o
        stqd    $t_best_9,208($a_packet_4)              # 143o

        lqd     $nearest_8,272($a_packet_3)             # 144o
        lqd     $nearest_9,304($a_packet_3)             # 145o

        lqd     $t_best_4,208($a_packet_3)              # 146o
        frsqest $y_9,$disc_10                           # 147o

        nop     $127                                    # 148e pairing
        frsqest $y_10,$disc_11                          # 148o

next_pair:
            fi      $y,$disc_10,$y_9                    # 0e
            shlqbyi $a_packet_2,$a_packet_3,0           # 0o copy

            fi      $y_10,$disc_11,$y_10                # 1e
            lqd     $t_best,240($a_packet_3)            # 1o

            selb    $nearest,$nearest,$object,$hit      # 2e
            shufb   $object,$object_3,$object_3,$m_x    # 2o

            selb    $t_best_10,$t_best_5,$t_5,$hit      # 3e
        lqd     $object_3,0($a_pair)                    # 3o

            fnms    $disc,$lx,$lx,$radius2_3            # 4e
            stqd    $nearest,256($a_packet_5)           # 4o

        ai      $count,$count,-1                        # 5e
            stqd    $t_best_10,192($a_packet_5)         # 5o

            fm      $s,$disc_9,$y_8                     # 6e
            shlqbyi $a_packet_5,$a_packet_3,0           # 6o copy

            fm      $s_6,$disc_10,$y                    # 7e
            lqd     $nearest,256($a_packet_3)           # 7o

            fm      $s_7,$disc_11,$y_10                 # 8e
            lqd     $t_best_5,192($a_packet_3)          # 8o

        ai      $a_pair,$a_pair,16                      # 9e
        rotqbyi $a_packet_3,$object_3,4                 # 9o

            fnms    $disc,$ly,$ly,$disc                 # 10e
        lqd     $quad_2,0($object_3)                    # 10o

            fnms    $e,$s,$y_8,$k_one                   # 12e 1 - s y
            fnms    $e_8,$s_6,$y,$k_one                 # 13e 1 - s y

            fnms    $e_9,$s_7,$y_10,$k_one              # 14e 1 - s y
        lqd     $dx,32($a_packet_3)                     # 14o

        nop     $127                                    # 15e pairing
        lqd     $dx_3,16($a_packet_3)                   # 15o

            fnms    $disc,$lz,$lz,$disc                 # 16e
        shufb   $cx_2,$quad_2,$quad_2,$m_x              # 16o

            fma     $e,$e,$k_half,$k_one                # 18e
        shufb   $cy_2,$quad_2,$quad_2,$m_y              # 18o

            fma     $e_8,$e_8,$k_half,$k_one            # 19e
        shufb   $cz_2,$quad_2,$quad_2,$m_z              # 19o

            fma     $e_9,$e_9,$k_half,$k_one            # 20e
        lqd     $dx_2,48($a_packet_3)                   # 20o

        fm      $b_2,$cx_2,$dx                          # 21e
        lqd     $dy_4,80($a_packet_3)                   # 21o

        fm      $b_4,$cx_2,$dx_3                        # 22e
        lqd     $dx_4,0($a_packet_3)                    # 22o

        shufb   $radius2_3,$quad_2,$quad_2,$m_radius2   # 23o
            fnms    $t,$s,$e,$b_8                       # 24e

            fnms    $t_6,$s_6,$e_8,$b_9                 # 25e
            lnop                                        # 25o pairing

        fm      $b_3,$cx_2,$dx_2                        # 26e
        lqd     $dy_2,96($a_packet_3)                   # 26o

            fnms    $t_7,$s_7,$e_9,$b_12                # 27e
        fm      $b_14,$cx_2,$dx_4                       # 28e

        fma     $b_4,$cy_2,$dy_4,$b_4                   # 29e
        lqd     $dy_3,112($a_packet_3)                  # 29o

            clgt    $hit,$t_best_8,$t_6                 # 31e
            lnop                                        # 31o pairing

        fma     $b_2,$cy_2,$dy_2,$b_2                   # 32e
        lqd     $dz_4,144($a_packet_3)                  # 32o

            andc    $hit,$hit,$disc_10                  # 33e its signs alone count
            frsqest $y_11,$disc                         # 33o

            clgt    $hit_8,$t_best,$t_7                 # 34e
        lqd     $dz_2,160($a_packet_3)                  # 34o

            clgt    $hit_5,$t_best_4,$t                 # 35e
            rotqbii $hit,$hit,1                         # 35o

        fma     $b_3,$cy_2,$dy_3,$b_3                   # 36e
        lqd     $dz_3,176($a_packet_3)                  # 36o

            fi      $y_11,$disc,$y_11                   # 37e
        lqd     $dy_5,64($a_packet_3)                   # 37o

            andc    $hit_8,$hit_8,$disc_11              # 38e its signs alone count
            lnop                                        # 38o pairing

        fma     $b_8,$cz_2,$dz_4,$b_4                   # 39e
            gb      $hit,$hit                           # 39o

        fma     $b_9,$cz_2,$dz_2,$b_2                   # 40e
            rotqbii $hit_7,$hit_8,1                     # 40o

            andc    $hit_3,$hit_5,$disc_9               # 41e its signs alone count
        fma     $b_12,$cz_2,$dz_3,$b_3                  # 42e

        fma     $b_14,$cy_2,$dy_5,$b_14                 # 43e
            shlqbii $hit,$hit,4                         # 43o

            fm      $s_8,$disc,$y_11                    # 44e
            rotqbii $hit_3,$hit_3,1                     # 44o

        fnms    $ly,$b_8,$dy_4,$cy_2                    # 45e
            gb      $hit_7,$hit_7                       # 45o

        fnms    $lx_4,$b_8,$dx_3,$cx_2                  # 46e
        lnop                                            # 46o pairing

        fnms    $lx_2,$b_9,$dx,$cx_2                    # 47e
            lqx     $merge_2,$bits,$hit                 # 47o

        fnms    $lx_3,$b_12,$dx_2,$cx_2                 # 48e
            gb      $hit_3,$hit_3                       # 48o

        fnms    $ly_3,$b_12,$dy_3,$cy_2                 # 49e
            shlqbii $hit_7,$hit_7,4                     # 49o

            fnms    $e_7,$s_8,$y_11,$k_one              # 50e 1 - s y
            lnop                                        # 50o pairing

        fnms    $ly_2,$b_9,$dy_2,$cy_2                  # 51e
        lqd     $dz_5,128($a_packet_3)                  # 51o

        fnms    $disc_4,$lx_4,$lx_4,$radius2_3          # 52e
            shlqbii $hit_3,$hit_3,4                     # 52o

        fnms    $disc_2,$lx_2,$lx_2,$radius2_3          # 53e
            shufb   $nearest_7,$nearest_7,$object,$merge_2 # 53o

        fnms    $lz_4,$b_8,$dz_4,$cz_2                  # 54e
            shufb   $t_best_10,$t_best_8,$t_6,$merge_2  # 54o

        fnms    $disc_3,$lx_3,$lx_3,$radius2_3          # 55e
            lqx     $merge_3,$bits,$hit_7               # 55o

            fma     $e_10,$e_7,$k_half,$k_one           # 56e
            lqx     $merge_4,$bits,$hit_3               # 56o

        fnms    $lz_8,$b_9,$dz_2,$cz_2                  # 57e
            stqd    $nearest_7,288($a_packet_2)         # 57o

        fnms    $disc_4,$ly,$ly,$disc_4                 # 58e
            stqd    $t_best_10,224($a_packet_2)         # 58o

        fnms    $disc_12,$ly_2,$ly_2,$disc_2            # 59e
        lqd     $t_best_8,224($a_packet_3)              # 59o

        fnms    $lz_6,$b_12,$dz_3,$cz_2                 # 60e
        lqd     $nearest_7,288($a_packet_3)             # 60o

        fnms    $disc_3,$ly_3,$ly_3,$disc_3             # 61e
            shufb   $nearest_10,$nearest_9,$object,$merge_3 # 61o

            fnms    $t_5,$s_8,$e_10,$b_13               # 62e
            shufb   $t_best,$t_best,$t_7,$merge_3       # 62o

        fma     $b_13,$cz_2,$dz_5,$b_14                 # 63e
            shufb   $nearest_3,$nearest_8,$object,$merge_4 # 63o

        fnms    $disc_9,$lz_4,$lz_4,$disc_4             # 64e
            shufb   $t_best_9,$t_best_4,$t,$merge_4     # 64o

        fnms    $disc_10,$lz_8,$lz_8,$disc_12           # 65e
            stqd    $nearest_10,304($a_packet_2)        # 65o

            nop     $127                                # 66e pairing
            stqd    $t_best,240($a_packet_2)            # 66o

        fnms    $disc_11,$lz_6,$lz_6,$disc_3            # 67e
            stqd    $nearest_3,272($a_packet_2)         # 67o

            nop     $127                                # 68e pairing
            stqd    $t_best_9,208($a_packet_2)          # 68o

            clgt    $hit,$t_best_5,$t_5                 # 69e
        lqd     $nearest_8,272($a_packet_3)             # 69o

        fnms    $lx,$b_13,$dx_4,$cx_2                   # 70e
        frsqest $y,$disc_9                              # 70o

        fnms    $lz,$b_13,$dz_5,$cz_2                   # 71e
        frsqest $y_9,$disc_10                           # 71o

            andc    $hit,$hit,$disc                     # 72e its signs alone count
        lqd     $nearest_9,304($a_packet_3)             # 72o

        fnms    $ly,$b_13,$dy_5,$cy_2                   # 73e
        frsqest $y_10,$disc_11                          # 73o

            rotmai  $hit,$hit,-31                       # 74e
        lqd     $t_best_4,208($a_packet_3)              # 74o

        fi      $y_8,$disc_9,$y                         # 75e
next_pair_back:
        brnz    $count,next_pair                        # 75o

next_pair_drain:
        fnms    $disc,$lx,$lx,$radius2_3                # 0e
        lqd     $t_best,240($a_packet_3)                # 0o

        fi      $y_10,$disc_11,$y_10                    # 1e
        shufb   $object_4,$object_3,$object_3,$m_x      # 1o

        fi      $y,$disc_10,$y_9                        # 2e
        shlqbyi $a_packet_2,$a_packet_3,0               # 2o copy

        selb    $t_best_10,$t_best_5,$t_5,$hit          # 3e
        shlqbyi $a_packet_6,$a_packet_3,0               # 3o copy

        fm      $s,$disc_9,$y_8                         # 4e
        hbr     isect_pairs_r16_return,$lr              # 4o hint

        selb    $nearest,$nearest,$object,$hit          # 5e
        fnms    $disc,$ly,$ly,$disc                     # 6e

        nop     $127                                    # 7e pairing
        stqd    $nearest,256($a_packet_5)               # 7o

        fm      $s_7,$disc_11,$y_10                     # 8e
        stqd    $t_best_10,192($a_packet_5)             # 8o

        fm      $s_6,$disc_10,$y                        # 9e
        lqd     $t_best_5,192($a_packet_3)              # 9o

        fnms    $e,$s,$y_8,$k_one                       # 10e 1 - s y
        lqd     $nearest,256($a_packet_3)               # 10o

        fnms    $disc,$lz,$lz,$disc                     # 12e
        fnms    $e_9,$s_7,$y_10,$k_one                  # 14e 1 - s y

        fnms    $e_8,$s_6,$y,$k_one                     # 15e 1 - s y
        fma     $e,$e,$k_half,$k_one                    # 16e

        frsqest $y_12,$disc                             # 18o
        fma     $e_9,$e_9,$k_half,$k_one                # 20e

        fma     $e_8,$e_8,$k_half,$k_one                # 21e
        fnms    $t,$s,$e,$b_8                           # 22e

        fi      $y_12,$disc,$y_12                       # 23e
        fnms    $t_7,$s_7,$e_9,$b_12                    # 26e

        fnms    $t_6,$s_6,$e_8,$b_9                     # 27e
        clgt    $hit_5,$t_best_4,$t                     # 28e

        fm      $s_8,$disc,$y_12                        # 30e
        andc    $hit_3,$hit_5,$disc_9                   # 31e its signs alone count

        clgt    $hit_8,$t_best,$t_7                     # 32e
        lnop                                            # 32o pairing

        clgt    $hit,$t_best_8,$t_6                     # 33e
        rotqbii $hit_3,$hit_3,1                         # 33o

        andc    $hit_8,$hit_8,$disc_11                  # 34e its signs alone count
        andc    $hit,$hit,$disc_10                      # 35e its signs alone count

        fnms    $e_7,$s_8,$y_12,$k_one                  # 36e 1 - s y
        rotqbii $hit_7,$hit_8,1                         # 36o

        rotqbii $hit,$hit,1                             # 37o
        gb      $hit_3,$hit_3                           # 38o

        gb      $hit_7,$hit_7                           # 40o
        gb      $hit,$hit                               # 41o

        fma     $e_11,$e_7,$k_half,$k_one               # 42e
        shlqbii $hit_3,$hit_3,4                         # 42o

        shlqbii $hit_7,$hit_7,4                         # 44o
        shlqbii $hit,$hit,4                             # 45o

        nop     $127                                    # 46e pairing
        lqx     $merge_4,$bits,$hit_3                   # 46o

        fnms    $t_5,$s_8,$e_11,$b_13                   # 48e
        lqx     $merge_3,$bits,$hit_7                   # 48o

        lqx     $merge_2,$bits,$hit                     # 49o
        shufb   $nearest_11,$nearest_8,$object_4,$merge_4 # 52o

        nop     $127                                    # 53e pairing
        shufb   $t_best_9,$t_best_4,$t,$merge_4         # 53o

        clgt    $hit_9,$t_best_5,$t_5                   # 54e
        shufb   $nearest_10,$nearest_9,$object_4,$merge_3 # 54o

        nop     $127                                    # 55e pairing
        shufb   $nearest_7,$nearest_7,$object_4,$merge_2 # 55o

        andc    $hit_9,$hit_9,$disc                     # 56e its signs alone count
        shufb   $t_best_10,$t_best_8,$t_6,$merge_2      # 56o

        shufb   $t_best,$t_best,$t_7,$merge_3           # 57o
        rotmai  $hit,$hit_9,-31                         # 58e

        stqd    $nearest_7,288($a_packet_6)             # 59o
        stqd    $t_best_10,224($a_packet_6)             # 60o

        nop     $127                                    # 61e pairing
        stqd    $nearest_10,304($a_packet_6)            # 61o

        selb    $nearest,$nearest,$object_4,$hit        # 62e
        stqd    $t_best,240($a_packet_6)                # 62o

        selb    $t_best_10,$t_best_5,$t_5,$hit          # 63e
        stqd    $nearest_11,272($a_packet_6)            # 63o

        stqd    $t_best_9,208($a_packet_6)              # 64o
        stqd    $nearest,256($a_packet_2)               # 65o

        stqd    $t_best_10,192($a_packet_2)             # 66o
isect_pairs_r16_return:
        bi      $lr                                     # 67o

next_pair_short:
        ai      $count,$count,-1                        # 0e
        lqd     $object,0($a_pair)                      # 0o

        ai      $a_pair,$a_pair,16                      # 1e
        rotqbyi $a_packet,$object,4                     # 6o

        lqd     $quad,0($object)                        # 7o
        shufb   $object,$object,$object,$m_x            # 8o

        lqd     $dx,16($a_packet)                       # 10o
        lqd     $dx_9,32($a_packet)                     # 11o

        lqd     $dx_10,48($a_packet)                    # 12o
        shufb   $cx,$quad,$quad,$m_x                    # 13o

        lqd     $dy,80($a_packet)                       # 14o
        lqd     $dy_10,96($a_packet)                    # 15o

        nop     $127                                    # 16e pairing
        lqd     $dy_11,112($a_packet)                   # 16o

        fm      $b,$cx,$dx                              # 17e
        shufb   $cy,$quad,$quad,$m_y                    # 17o

        fm      $b_5,$cx,$dx_9                          # 18e
        lqd     $dz,144($a_packet)                      # 18o

        fm      $b_14,$cx,$dx_10                        # 19e
        lqd     $dz_10,160($a_packet)                   # 19o

        lqd     $dz_11,176($a_packet)                   # 20o
        shufb   $cz_4,$quad,$quad,$m_z                  # 21o

        nop     $127                                    # 22e pairing
        lqd     $dx_11,0($a_packet)                     # 22o

        fma     $b,$cy,$dy,$b                           # 23e
        lqd     $dy_12,64($a_packet)                    # 23o

        fma     $b_5,$cy,$dy_10,$b_5                    # 24e
        shufb   $radius2_4,$quad,$quad,$m_radius2       # 24o

        fma     $b_14,$cy,$dy_11,$b_14                  # 25e
        lqd     $dz_12,128($a_packet)                   # 25o

        lqd     $t_best_11,208($a_packet)               # 26o
        lqd     $t_best_12,224($a_packet)               # 27o

        fm      $b_15,$cx,$dx_11                        # 28e
        lqd     $t_best_13,240($a_packet)               # 28o

        fma     $b,$cz_4,$dz,$b                         # 29e
        lqd     $t_best_14,192($a_packet)               # 29o

        fma     $b_5,$cz_4,$dz_10,$b_5                  # 30e
        lqd     $nearest_12,272($a_packet)              # 30o

        fma     $b_14,$cz_4,$dz_11,$b_14                # 31e
        lqd     $nearest_13,288($a_packet)              # 31o

        lqd     $nearest_14,304($a_packet)              # 32o
        lqd     $nearest_15,256($a_packet)              # 33o

        fma     $b_15,$cy,$dy_12,$b_15                  # 34e
        fnms    $lx_2,$b,$dx,$cx                        # 35e

        fnms    $lx_8,$b_5,$dx_9,$cx                    # 36e
        fnms    $lx_9,$b_14,$dx_10,$cx                  # 37e

        fnms    $ly_4,$b,$dy,$cy                        # 38e
        fnms    $ly_6,$b_5,$dy_10,$cy                   # 39e

        fnms    $ly_7,$b_14,$dy_11,$cy                  # 40e
        fnms    $disc_2,$lx_2,$lx_2,$radius2_4          # 41e

        fnms    $disc_5,$lx_8,$lx_8,$radius2_4          # 42e
        fnms    $disc_13,$lx_9,$lx_9,$radius2_4         # 43e

        fma     $b_15,$cz_4,$dz_12,$b_15                # 44e
        fnms    $lz_9,$b,$dz,$cz_4                      # 45e

        fnms    $lz_10,$b_5,$dz_10,$cz_4                # 46e
        fnms    $disc_2,$ly_4,$ly_4,$disc_2             # 47e

        fnms    $disc_5,$ly_6,$ly_6,$disc_5             # 48e
        fnms    $lz_11,$b_14,$dz_11,$cz_4               # 49e

        fnms    $disc_13,$ly_7,$ly_7,$disc_13           # 50e
        fnms    $lx_10,$b_15,$dx_11,$cx                 # 51e

        fnms    $ly_8,$b_15,$dy_12,$cy                  # 52e
        fnms    $disc_14,$lz_9,$lz_9,$disc_2            # 53e

        fnms    $disc_5,$lz_10,$lz_10,$disc_5           # 54e
        fnms    $lz_10,$b_15,$dz_12,$cz_4               # 55e

        fnms    $disc_13,$lz_11,$lz_11,$disc_13         # 56e
        fnms    $disc_12,$lx_10,$lx_10,$radius2_4       # 57e

        frsqest $y_12,$disc_14                          # 59o
        frsqest $y_13,$disc_5                           # 60o

        frsqest $y_14,$disc_13                          # 62o
        fnms    $disc_12,$ly_8,$ly_8,$disc_12           # 63e

        fi      $y_12,$disc_14,$y_12                    # 64e
        fi      $y_13,$disc_5,$y_13                     # 65e

        fi      $y_15,$disc_13,$y_14                    # 66e
        fnms    $disc_12,$lz_10,$lz_10,$disc_12         # 69e

        fm      $s_5,$disc_14,$y_12                     # 71e
        fm      $s_9,$disc_5,$y_13                      # 72e

        fm      $s_10,$disc_13,$y_15                    # 73e
        frsqest $y_16,$disc_12                          # 75o

        fnms    $e_11,$s_5,$y_12,$k_one                 # 77e 1 - s y
        fnms    $e_12,$s_9,$y_13,$k_one                 # 78e 1 - s y

        fnms    $e_13,$s_10,$y_15,$k_one                # 79e 1 - s y
        fi      $y_16,$disc_12,$y_16                    # 80e

        fma     $e_11,$e_11,$k_half,$k_one              # 83e
        fma     $e_12,$e_12,$k_half,$k_one              # 84e

        fma     $e_13,$e_13,$k_half,$k_one              # 85e
        fm      $s_2,$disc_12,$y_16                     # 87e

        fnms    $t_8,$s_5,$e_11,$b                      # 89e
        fnms    $t_9,$s_9,$e_12,$b_5                    # 90e

        fnms    $t_10,$s_10,$e_13,$b_14                 # 91e
        fnms    $e_12,$s_2,$y_16,$k_one                 # 93e 1 - s y

        clgt    $hit_10,$t_best_11,$t_8                 # 95e
        clgt    $hit_11,$t_best_12,$t_9                 # 96e

        clgt    $hit_12,$t_best_13,$t_10                # 97e
        andc    $hit_10,$hit_10,$disc_14                # 98e its signs alone count

        andc    $hit_4,$hit_11,$disc_5                  # 99e its signs alone count
        lnop                                            # 99o pairing

        andc    $hit_13,$hit_12,$disc_13                # 100e its signs alone count
        rotqbii $hit_10,$hit_10,1                       # 100o

        fma     $e_12,$e_12,$k_half,$k_one              # 101e
        rotqbii $hit_4,$hit_4,1                         # 101o

        rotqbii $hit_13,$hit_13,1                       # 102o
        gb      $hit_10,$hit_10                         # 104o

        gb      $hit_4,$hit_4                           # 105o
        gb      $hit_13,$hit_13                         # 106o

        fnms    $t_11,$s_2,$e_12,$b_15                  # 107e
        shlqbii $hit_10,$hit_10,4                       # 108o

        shlqbii $hit_4,$hit_4,4                         # 109o
        shlqbii $hit_13,$hit_13,4                       # 110o

        nop     $127                                    # 111e pairing
        lqx     $merge_5,$bits,$hit_10                  # 112o

        clgt    $hit_14,$t_best_14,$t_11                # 113e
        lqx     $merge_6,$bits,$hit_4                   # 113o

        lqx     $merge_7,$bits,$hit_13                  # 114o
        andc    $hit_15,$hit_14,$disc_12                # 115e its signs alone count

        rotmai  $hit_15,$hit_15,-31                     # 117e
        shufb   $t_best,$t_best_11,$t_8,$merge_5        # 118o

        shufb   $nearest,$nearest_12,$object,$merge_5   # 119o
        shufb   $t_best_15,$t_best_12,$t_9,$merge_6     # 120o

        selb    $t_best_16,$t_best_14,$t_11,$hit_15     # 121e
        shufb   $nearest_16,$nearest_13,$object,$merge_6 # 121o

        selb    $nearest_6,$nearest_15,$object,$hit_15  # 122e
        shufb   $t_best_9,$t_best_13,$t_10,$merge_7     # 122o

        shufb   $nearest_3,$nearest_14,$object,$merge_7 # 123o
        stqd    $t_best_16,192($a_packet)               # 124o

        stqd    $nearest_6,256($a_packet)               # 125o
        stqd    $t_best,208($a_packet)                  # 126o

        stqd    $nearest,272($a_packet)                 # 127o
        stqd    $t_best_15,224($a_packet)               # 128o

        stqd    $nearest_16,288($a_packet)              # 129o
        stqd    $t_best_9,240($a_packet)                # 130o

        stqd    $nearest_3,304($a_packet)               # 131o
        brnz    $count,next_pair_short                  # 132o

        nop     $127                                    # 133e pairing
        bi      $lr                                     # 133o
endfunction isect_pairs_r16
