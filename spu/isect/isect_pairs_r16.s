# isect_pairs_r16   nearest entry of the eye rays of packets into spheres, pair by pair
#   C       void isect_pairs_r16(const struct pair *, int count);
#   In      $3 pairs, $4 count (0 is none); pointers 16-aligned
#   Out     the pairs' packets: t, object, where an entry is nearer than what was there
#   Uses    $2-$68, $79   Saves  -   Stack  0   Calls  -
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
        .set    object_2,58
        .set    object_3,2
        .set    a_packet_2,64
        .set    quad_2,43
        .set    quad_3,5
        .set    a_packet_3,6
        .set    dx_2,7
        .set    cz_2,8
        .set    dx_3,9
        .set    radius2_2,36
        .set    dx_4,43
        .set    dy_2,17
        .set    dy_3,32
        .set    b_2,18
        .set    dz_2,44
        .set    dz_3,23
        .set    b_3,39
        .set    dy_4,28
        .set    dz_4,30
        .set    b_4,19
        .set    dx_5,31
        .set    cx_2,33
        .set    dy_5,34
        .set    cy_2,35
        .set    b_5,27
        .set    dz_5,37
        .set    dx_6,38
        .set    dx_7,45
        .set    dx_8,50
        .set    lx_2,7
        .set    b_6,42
        .set    ly_2,25
        .set    radius2_3,5
        .set    lz_2,26
        .set    t_best_2,29
        .set    dy_6,49
        .set    b_7,40
        .set    dy_7,61
        .set    lx_3,9
        .set    dy_8,62
        .set    disc_2,7
        .set    dz_6,51
        .set    ly_3,17
        .set    nearest_2,55
        .set    lz_3,41
        .set    dz_7,19
        .set    lx_4,43
        .set    dz_8,57
        .set    ly_4,32
        .set    a_packet_4,67
        .set    disc_3,9
        .set    object_4,44
        .set    a_packet_5,25
        .set    lx_5,20
        .set    a_packet_6,24
        .set    lz_4,23
        .set    t_best_3,46
        .set    disc_4,43
        .set    nearest_3,47
        .set    t_best_4,48
        .set    b_8,68
        .set    b_9,17
        .set    disc_5,18
        .set    ly_5,20
        .set    object_5,53
        .set    disc_6,21
        .set    object_6,54
        .set    lz_5,2
        .set    a_packet_7,59
        .set    a_packet_8,63
        .set    b_10,8
        .set    y_2,26
        .set    b_11,28
        .set    a_packet_9,60
        .set    disc_7,20
        .set    a_packet_10,56
        .set    y_3,21
        .set    y_4,23
        .set    lx_6,24
        .set    b_12,41
        .set    disc_8,40
        .set    y_5,2
        .set    y_6,30
        .set    s_2,20
        .set    b_13,23
        .set    disc_9,24
        .set    s_3,21
        .set    s_4,32
        .set    b_14,34
        .set    lz_6,8
        .set    e_2,37
        .set    t_2,20
        .set    e_3,30
        .set    b_15,36
        .set    s_5,31
        .set    b_16,2
        .set    hit_2,23
        .set    disc_10,52
        .set    hit_3,7
        .set    lx_7,8
        .set    b_17,65
        .set    e_4,7
        .set    b_18,66
        .set    ly_6,42
        .set    lz_7,49
        .set    t_best_5,20
        .set    nearest_4,38
        .set    e_5,26
        .set    t_best_6,50
        .set    e_6,25
        .set    nearest_5,51
        .set    t_3,44
        .set    lz_8,29
        .set    disc_11,23
        .set    e_7,21
        .set    t_best_7,57
        .set    ly_7,7
        .set    nearest_6,61
        .set    disc_12,8
        .set    ly_8,6
        .set    disc_13,17
        .set    t_4,62
        .set    hit_4,9
        .set    dx_9,2
        .set    dx_10,5
        .set    disc_14,6
        .set    dy_9,9
        .set    dy_10,6
        .set    b_19,7
        .set    dz_9,17
        .set    hit_5,28
        .set    t_5,31
        .set    t_best_8,35
        .set    lx_8,2
        .set    merge_2,35
        .set    s_6,23
        .set    y_7,42
        .set    disc_15,2
        .set    nearest_7,39
        .set    y_8,29
        .set    nearest_8,42
        .set    s_7,45
        .set    e_8,34
        .set    t_best_9,31
        .set    merge_3,7
        .set    b_20,6
        .set    lx_9,17
        .set    nearest_9,2
        .set    e_9,24
        .set    t_best_10,7
        .set    e_10,5
        .set    hit_6,4
        .set    cy_3,4
        .set    dy_11,7
        .set    hit_7,13
        .set    dz_10,3
        .set    b_21,14
        .set    t_best_11,18
        .set    radius2_4,15
        .set    b_22,21
        .set    a_packet_11,28
        .set    merge_4,31
        .set    lx_10,5
        .set    ly_9,9
        .set    object_7,25
        .set    merge_5,13
        .set    disc_16,5
        .set    a_packet_12,38
        .set    t_6,35
        .set    lz_9,17
        .set    lx_11,26
        .set    nearest_10,31
        .set    t_best_12,9
        .set    s_8,13
        .set    object_8,12
        .set    y_9,37
        .set    hit_8,34
        .set    disc_17,26
        .set    hit_9,17
        .set    a_packet_13,34
        .set    e_11,4
        .set    disc_18,15
        .set    y_10,20
        .set    hit_10,30
        .set    lz_10,18
        .set    disc_19,19
        .set    hit_11,26
        .set    nearest_11,17
        .set    e_12,3
        .set    disc_20,4
        .set    y_11,7
        .set    hit_12,14
        .set    hit_13,3
        .set    hit_14,6
        .set    s_9,9
        .set    merge_6,3
        .set    hit_15,8
        .set    t_best_13,13
        .set    nearest_12,3
        .set    s_10,6
        .set    hit_16,2
        .set    nearest_13,8
        .set    b_23,9
        .set    dz_11,22
        .set    cz_3,27
        .set    dx_11,28
        .set    dy_12,30
        .set    radius2_5,19
        .set    dz_12,31
        .set    t_best_14,32
        .set    t_best_15,33
        .set    t_best_16,36
        .set    nearest_14,37
        .set    nearest_15,40
        .set    lz_11,22
        .set    lz_12,6
        .set    y_12,19
        .set    s_11,22
        .set    s_12,24
        .set    y_13,25
        .set    e_13,19
        .set    e_14,20
        .set    s_13,26
        .set    t_7,7
        .set    t_8,8
        .set    t_9,9
        .set    hit_17,20
        .set    hit_18,22
        .set    hit_19,5
        .set    t_10,19
        .set    merge_7,20
        .set    hit_20,21
        .set    merge_8,2
        .set    merge_9,5
        .set    t_best_17,8
        .set    nearest_16,6
        .set    nearest_17,5
        nop     $127                                    # 0e pairing
        biz     $count,$lr                              # 0o

        ilhu    $m_x,1                                  # 1e
        ilhu    $m_y,0x405                              # 2e

        ilhu    $m_z,0x809                              # 3e
        ilhu    $m_radius2,0xc0d                        # 4e

        clgti   $count_2,$count,3                       # 5e at least as many passes as overlap
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
        ai      $count,$count,-1                        # 18e

        rotqbyi $a_packet_2,$object_2,4                 # 19o
        lqd     $quad_2,0($object_2)                    # 20o

        lqd     $quad_3,0($object_3)                    # 21o
        rotqbyi $a_packet_3,$object_3,4                 # 22o

        lqd     $dx_2,0($a_packet_2)                    # 23o
        lqd     $dy,64($a_packet_2)                     # 24o

        lqd     $dz,128($a_packet_2)                    # 25o
        shufb   $cx,$quad_2,$quad_2,$m_x                # 26o

        shufb   $cy,$quad_2,$quad_2,$m_y                # 27o
        shufb   $cz_2,$quad_2,$quad_2,$m_z              # 28o

        nop     $127                                    # 29e pairing
        lqd     $dx_3,16($a_packet_2)                   # 29o

        fm      $b,$cx,$dx_2                            # 30e
        shufb   $radius2_2,$quad_2,$quad_2,$m_radius2   # 30o

        lqd     $dx_4,48($a_packet_2)                   # 31o
        lqd     $dy_2,80($a_packet_2)                   # 32o

        lqd     $dx,32($a_packet_2)                     # 33o
        lqd     $dy_3,112($a_packet_2)                  # 34o

        fm      $b_2,$cx,$dx_3                          # 35e
        lqd     $dz_2,144($a_packet_2)                  # 35o

        fma     $b,$cy,$dy,$b                           # 36e
        lqd     $dz_3,176($a_packet_2)                  # 36o

        fm      $b_3,$cx,$dx_4                          # 37e
        lqd     $dy_4,96($a_packet_2)                   # 37o

        nop     $127                                    # 38e pairing
        lqd     $dz_4,160($a_packet_2)                  # 38o

        fm      $b_4,$cx,$dx                            # 39e
        lqd     $dx_5,0($a_packet_3)                    # 39o

        nop     $127                                    # 40e pairing
        shufb   $cx_2,$quad_3,$quad_3,$m_x              # 40o

        fma     $b_2,$cy,$dy_2,$b_2                     # 41e
        lqd     $dy_5,64($a_packet_3)                   # 41o

        fma     $b,$cz_2,$dz,$b                         # 42e
        shufb   $cy_2,$quad_3,$quad_3,$m_y              # 42o

        fma     $b_5,$cy,$dy_3,$b_3                     # 43e
        lqd     $dz_5,128($a_packet_3)                  # 43o

        nop     $127                                    # 44e pairing
        shufb   $cz,$quad_3,$quad_3,$m_z                # 44o

        fma     $b_4,$cy,$dy_4,$b_4                     # 45e
        lqd     $dx_6,32($a_packet_3)                   # 45o

        fm      $b_3,$cx_2,$dx_5                        # 46e
        lqd     $dx_7,16($a_packet_3)                   # 46o

        fma     $b_2,$cz_2,$dz_2,$b_2                   # 47e
        lqd     $dx_8,48($a_packet_3)                   # 47o

        fnms    $lx_2,$b,$dx_2,$cx                      # 48e
        shlqbyi $b_6,$b,0                               # 48o copy

        fnms    $ly_2,$b,$dy,$cy                        # 49e
        shufb   $radius2_3,$quad_3,$quad_3,$m_radius2   # 49o

        fnms    $lz_2,$b,$dz,$cz_2                      # 50e
        lqd     $t_best_2,192($a_packet_2)              # 50o

        fma     $b_5,$cz_2,$dz_3,$b_5                   # 51e
        lqd     $dy_6,96($a_packet_3)                   # 51o

        fma     $b_7,$cz_2,$dz_4,$b_4                   # 52e
        lqd     $dy_7,112($a_packet_3)                  # 52o

        fnms    $lx_3,$b_2,$dx_3,$cx                    # 53e
        lqd     $dy_8,80($a_packet_3)                   # 53o

        fnms    $disc_2,$lx_2,$lx_2,$radius2_2          # 54e
        lqd     $dz_6,160($a_packet_3)                  # 54o

        fnms    $ly_3,$b_2,$dy_2,$cy                    # 55e
        lqd     $nearest_2,256($a_packet_2)             # 55o

        fnms    $lz_3,$b_2,$dz_2,$cz_2                  # 56e
        lqd     $dz_7,176($a_packet_3)                  # 56o

        fnms    $lx_4,$b_5,$dx_4,$cx                    # 57e
        lqd     $dz_8,144($a_packet_3)                  # 57o

        fnms    $ly_4,$b_5,$dy_3,$cy                    # 58e
        shlqbyi $a_packet_4,$a_packet_2,0               # 58o copy

        fnms    $disc_3,$lx_3,$lx_3,$radius2_2          # 59e
        shufb   $object_4,$object_2,$object_2,$m_x      # 59o

        fnms    $disc_2,$ly_2,$ly_2,$disc_2             # 60e
        shlqbyi $a_packet_5,$a_packet_2,0               # 60o copy

        fnms    $lx_5,$b_7,$dx,$cx                      # 61e
        shlqbyi $a_packet_6,$a_packet_2,0               # 61o copy

        fnms    $lz_4,$b_5,$dz_3,$cz_2                  # 62e
        lqd     $t_best_3,208($a_packet_4)              # 62o

        fnms    $disc_4,$lx_4,$lx_4,$radius2_2          # 63e
        lqd     $nearest_3,272($a_packet_4)             # 63o

        fma     $b_3,$cy_2,$dy_5,$b_3                   # 64e
        lqd     $t_best_4,240($a_packet_4)              # 64o

        fnms    $disc_3,$ly_3,$ly_3,$disc_3             # 65e
        shlqbyi $b_8,$b_5,0                             # 65o copy

        fnms    $disc_2,$lz_2,$lz_2,$disc_2             # 66e
        shlqbyi $b_9,$b_2,0                             # 66o copy

        fnms    $disc_5,$lx_5,$lx_5,$radius2_2          # 67e
        shlqbyi $b_5,$b_7,0                             # 67o copy

        fnms    $ly_5,$b_7,$dy_4,$cy                    # 68e
        shlqbyi $object_5,$object_4,0                   # 68o copy

        fnms    $disc_6,$ly_4,$ly_4,$disc_4             # 69e
        shufb   $object_6,$object_3,$object_3,$m_x      # 69o

        fnms    $lz_5,$b_7,$dz_4,$cz_2                  # 70e
        shlqbyi $a_packet_7,$a_packet_3,0               # 70o copy

        fnms    $disc_3,$lz_3,$lz_3,$disc_3             # 71e
        shlqbyi $a_packet_8,$a_packet_3,0               # 71o copy

        fma     $b_10,$cz,$dz_5,$b_3                    # 72e
        frsqest $y_2,$disc_2                            # 72o

        fm      $b_11,$cx_2,$dx_6                       # 73e
        shlqbyi $a_packet_9,$a_packet_3,0               # 73o copy

        fnms    $disc_7,$ly_5,$ly_5,$disc_5             # 74e
        shlqbyi $a_packet_10,$a_packet_6,0              # 74o copy

        fnms    $disc_5,$lz_4,$lz_4,$disc_6             # 75e
        fi      $y_3,$disc_2,$y_2                       # 76e

        nop     $127                                    # 77e pairing
        frsqest $y_4,$disc_3                            # 77o

        fnms    $lx_6,$b_10,$dx_5,$cx_2                 # 78e
        shlqbyi $b_12,$b_10,0                           # 78o copy

        fm      $b_3,$cx_2,$dx_8                        # 79e
        fnms    $disc_8,$lz_5,$lz_5,$disc_7             # 80e

        fi      $y_5,$disc_3,$y_4                       # 81e
        frsqest $y_6,$disc_5                            # 81o

        fm      $s_2,$disc_2,$y_3                       # 83e
        fm      $b_13,$cx_2,$dx_7                       # 84e

        fi      $y_6,$disc_5,$y_6                       # 85e
        frsqest $y_2,$disc_8                            # 86o

        fnms    $ly,$b_10,$dy_5,$cy_2                   # 87e
        fnms    $disc_9,$lx_6,$lx_6,$radius2_3          # 88e

        fnms    $e,$s_2,$y_3,$k_one                     # 89e 1 - s y
        fm      $s_3,$disc_3,$y_5                       # 90e

        fma     $b_11,$cy_2,$dy_6,$b_11                 # 91e
        fi      $y_2,$disc_8,$y_2                       # 92e

        fm      $s_4,$disc_5,$y_6                       # 94e
        fma     $e,$e,$k_half,$k_one                    # 95e

        fma     $b_13,$cy_2,$dy_8,$b_13                 # 96e
        fma     $b_14,$cy_2,$dy_7,$b_3                  # 97e

        fnms    $lz_6,$b_10,$dz_5,$cz                   # 98e
        fnms    $e_2,$s_3,$y_5,$k_one                   # 99e 1 - s y

        fnms    $disc_9,$ly,$ly,$disc_9                 # 100e
        fnms    $t_2,$s_2,$e,$b_6                       # 101e

        fma     $b_11,$cz,$dz_6,$b_11                   # 102e
        fnms    $e_3,$s_4,$y_6,$k_one                   # 103e 1 - s y

        fma     $b_15,$cz,$dz_8,$b_13                   # 104e
        fm      $s_5,$disc_8,$y_2                       # 105e

        fma     $b_16,$cz,$dz_7,$b_14                   # 106e
        clgt    $hit_2,$t_best_2,$t_2                   # 107e

        fnms    $disc_10,$lz_6,$lz_6,$disc_9            # 108e
        andc    $hit_3,$hit_2,$disc_2                   # 109e its signs alone count

        fnms    $lx_7,$b_11,$dx_6,$cx_2                 # 110e
        shlqbyi $b_17,$b_15,0                           # 110o copy

        rotmai  $hit,$hit_3,-31                         # 111e
        lnop                                            # 111o pairing

        fma     $e_4,$e_2,$k_half,$k_one                # 112e
        shlqbyi $b_18,$b_16,0                           # 112o copy

        fnms    $ly_6,$b_11,$dy_6,$cy_2                 # 113e
        lnop                                            # 113o pairing

        fnms    $lz_7,$b_11,$dz_6,$cz                   # 114e
        frsqest $y,$disc_10                             # 114o

        selb    $t_best_5,$t_best_2,$t_2,$hit           # 115e
        selb    $nearest_4,$nearest_2,$object_4,$hit    # 116e

        fnms    $e_5,$s_5,$y_2,$k_one                   # 117e 1 - s y
        stqd    $t_best_5,192($a_packet_5)              # 117o

        fnms    $lx_5,$b_16,$dx_8,$cx_2                 # 118e
        stqd    $nearest_4,256($a_packet_5)             # 118o

        fnms    $lx_6,$b_15,$dx_7,$cx_2                 # 119e
        lqd     $t_best_6,192($a_packet_3)              # 119o

        fma     $e_6,$e_3,$k_half,$k_one                # 120e
        lqd     $nearest_5,304($a_packet_4)             # 120o

        fnms    $t_3,$s_3,$e_4,$b_9                     # 121e
        hbrr    next_pair_back,next_pair                # 121o hint

        fnms    $lz_8,$b_15,$dz_8,$cz                   # 122e
        lqd     $object_2,0($a_pair)                    # 122o

        fnms    $disc_11,$lx_7,$lx_7,$radius2_3         # 123e
        lqd     $nearest_2,288($a_packet_4)             # 123o

        fma     $e_7,$e_5,$k_half,$k_one                # 124e
        lqd     $t_best_7,224($a_packet_4)              # 124o

        fnms    $ly_7,$b_16,$dy_7,$cy_2                 # 125e
        lqd     $nearest_6,256($a_packet_3)             # 125o

        fi      $y,$disc_10,$y                          # 126e
        clgt    $hit,$t_best_3,$t_3                     # 127e

        fnms    $disc_12,$lx_5,$lx_5,$radius2_3         # 128e
        lqd     $quad_2,0($object_2)                    # 128o

        fnms    $ly_8,$b_15,$dy_8,$cy_2                 # 129e
        rotqbyi $a_packet_2,$object_2,4                 # 129o

        fnms    $disc_13,$lx_6,$lx_6,$radius2_3         # 130e
        fnms    $t_4,$s_4,$e_6,$b_8                     # 131e

        andc    $hit_4,$hit,$disc_3                     # 132e its signs alone count
        lnop                                            # 132o pairing

next_pair:
            fnms    $disc,$ly_8,$ly_8,$disc_13          # 0e
            lqd     $dx,32($a_packet_2)                 # 0o

            fnms    $lz,$b_16,$dz_7,$cz                 # 1e
            lqd     $dx_9,0($a_packet_2)                # 1o

            fm      $s,$disc_10,$y                      # 2e
            lqd     $dx_10,16($a_packet_2)              # 2o

            clgt    $hit,$t_best_4,$t_4                 # 3e
            shufb   $cx,$quad_2,$quad_2,$m_x            # 3o

            fnms    $disc_14,$ly_7,$ly_7,$disc_12       # 4e
            andc    $hit,$hit,$disc_5                   # 5e its signs alone count

            fnms    $disc,$lz_8,$lz_8,$disc             # 6e
            rotqbii $hit_3,$hit_4,1                     # 6o

            fm      $b,$cx,$dx_9                        # 7e
            lqd     $dy,64($a_packet_2)                 # 7o

            fm      $b_10,$cx,$dx                       # 8e
            lqd     $dy_9,80($a_packet_2)               # 8o

            fm      $b_9,$cx,$dx_10                     # 9e
            lqd     $dz,128($a_packet_2)                # 9o

            fnms    $e,$s,$y,$k_one                     # 10e 1 - s y
            gb      $hit_3,$hit_3                       # 10o

            fnms    $t,$s_5,$e_7,$b_5                   # 11e
            shufb   $cy,$quad_2,$quad_2,$m_y            # 11o

            fnms    $disc_5,$lz,$lz,$disc_14            # 12e
            rotqbii $hit,$hit,1                         # 12o

        ai      $count,$count,-1                        # 13e
            lqd     $dy_10,96($a_packet_2)              # 13o

            nop     $127                                # 14e pairing
            shlqbii $hit_3,$hit_3,4                     # 14o

            fma     $b,$cy,$dy,$b                       # 15e
            shufb   $cz,$quad_2,$quad_2,$m_z            # 15o

            fma     $e,$e,$k_half,$k_one                # 16e
            gb      $hit,$hit                           # 16o

            ai      $a_pair,$a_pair,16                  # 17e
            lqd     $dz_7,176($a_packet_2)              # 17o

            fnms    $disc_11,$ly_6,$ly_6,$disc_11       # 18e
            lqx     $merge,$bits,$hit_3                 # 18o

            fma     $b_19,$cy,$dy_10,$b_10              # 19e
            frsqest $y,$disc                            # 19o

            fma     $b_10,$cy,$dy_9,$b_9                # 20e
            shlqbyi $b_5,$b_11,0                        # 20o copy

            fma     $b,$cz,$dz,$b                       # 21e
            lqd     $dz_9,160($a_packet_2)              # 21o

            clgt    $hit_5,$t_best_7,$t                 # 22e
            frsqest $y_6,$disc_5                        # 22o

            fnms    $t_5,$s,$e,$b_12                    # 23e
            lqd     $dy_3,112($a_packet_2)              # 23o

            fi      $y,$disc,$y                         # 24e
            shufb   $t_best_8,$t_best_3,$t_3,$merge     # 24o

            andc    $hit_5,$hit_5,$disc_8               # 25e its signs alone count
            shufb   $radius2_2,$quad_2,$quad_2,$m_radius2 # 25o

            fnms    $disc_8,$lz_7,$lz_7,$disc_11        # 26e
            shlqbii $hit,$hit,4                         # 26o

            fnms    $lx_8,$b,$dx_9,$cx                  # 27e
            rotqbii $hit_2,$hit_5,1                     # 27o

            fma     $b_11,$cz,$dz_9,$b_19               # 28e
            stqd    $t_best_8,208($a_packet_10)         # 28o

            clgt    $hit_3,$t_best_6,$t_5               # 29e
            shlqbyi $b_12,$b,0                          # 29o copy

            fi      $y_6,$disc_5,$y_6                   # 30e
            lqx     $merge_2,$bits,$hit                 # 30o

            andc    $hit,$hit_3,$disc_10                # 31e its signs alone count
            gb      $hit_3,$hit_2                       # 31o

            fm      $s_6,$disc,$y                       # 32e
            frsqest $y_7,$disc_8                        # 32o

            fnms    $disc_15,$lx_8,$lx_8,$radius2_2     # 33e
            lqd     $dx_4,48($a_packet_2)               # 33o

            fnms    $ly_2,$b,$dy,$cy                    # 34e
            shufb   $nearest_7,$nearest_3,$object_5,$merge # 34o

            fnms    $lz_2,$b,$dz,$cz                    # 35e
            shlqbii $hit_3,$hit_3,4                     # 35o

            fi      $y_8,$disc_8,$y_7                   # 36e
            shufb   $nearest_8,$nearest_5,$object_5,$merge_2 # 36o

            rotmai  $hit,$hit,-31                       # 37e
            lqd     $dz_2,144($a_packet_2)              # 37o

            fm      $s_7,$disc_5,$y_6                   # 38e
            stqd    $nearest_7,272($a_packet_10)        # 38o

            fnms    $e_8,$s_6,$y,$k_one                 # 39e 1 - s y
            shufb   $t_best_8,$t_best_4,$t_4,$merge_2   # 39o

            fm      $b_3,$cx,$dx_4                      # 40e
            lqd     $t_best_3,208($a_packet_7)          # 40o

            selb    $t_best_9,$t_best_6,$t_5,$hit       # 41e
            lqd     $nearest_3,272($a_packet_7)         # 41o

            selb    $nearest_4,$nearest_6,$object_6,$hit # 42e
            lqx     $merge_3,$bits,$hit_3               # 42o

            fnms    $disc_15,$ly_2,$ly_2,$disc_15       # 43e
            stqd    $nearest_8,304($a_packet_10)        # 43o

            fma     $b_10,$cz,$dz_2,$b_10               # 44e
            stqd    $t_best_8,240($a_packet_10)         # 44o

            fnms    $ly_6,$b_11,$dy_10,$cy              # 45e
            lqd     $t_best_4,240($a_packet_7)          # 45o

            fnms    $lz_7,$b_11,$dz_9,$cz               # 46e
            stqd    $t_best_9,192($a_packet_9)          # 46o

            fm      $s_5,$disc_8,$y_8                   # 47e
            stqd    $nearest_4,256($a_packet_9)         # 47o

            fma     $b_20,$cy,$dy_3,$b_3                # 48e
            lqd     $t_best_6,192($a_packet_2)          # 48o

            fnms    $lx_9,$b_11,$dx,$cx                 # 49e
            lqd     $nearest_5,304($a_packet_7)         # 49o

            fnms    $disc_10,$lz_2,$lz_2,$disc_15       # 50e
            shufb   $nearest_9,$nearest_2,$object_5,$merge_3 # 50o

            fnms    $e_9,$s_7,$y_6,$k_one               # 51e 1 - s y
            shufb   $t_best_10,$t_best_7,$t,$merge_3    # 51o

            fma     $e_6,$e_8,$k_half,$k_one            # 52e
            shlqbyi $object_5,$object_6,0               # 52o copy

            fnms    $e_5,$s_5,$y_8,$k_one               # 53e 1 - s y
            shufb   $object_6,$object_2,$object_2,$m_x  # 53o

            fnms    $lz_8,$b_10,$dz_2,$cz               # 54e
            stqd    $nearest_9,288($a_packet_10)        # 54o

            fma     $b_16,$cz,$dz_7,$b_20               # 55e
            lqd     $nearest_2,288($a_packet_7)         # 55o

            fnms    $lx,$b_10,$dx_10,$cx                # 56e
            stqd    $t_best_10,224($a_packet_10)        # 56o

            fma     $e_10,$e_9,$k_half,$k_one           # 57e
            shlqbyi $a_packet_10,$a_packet_8,0          # 57o copy

            fnms    $ly_8,$b_10,$dy_9,$cy               # 58e
            lqd     $t_best_7,224($a_packet_7)          # 58o

            fnms    $t_3,$s_6,$e_6,$b_17                # 59e
        lqd     $object_2,0($a_pair)                    # 59o

            fnms    $disc_11,$lx_9,$lx_9,$radius2_2     # 60e
            shlqbyi $a_packet_7,$a_packet_2,0           # 60o copy

            fnms    $ly_7,$b_16,$dy_3,$cy               # 61e
            frsqest $y,$disc_10                         # 61o

            fnms    $lx_3,$b_16,$dx_4,$cx               # 62e
            shlqbyi $a_packet_9,$a_packet_2,0           # 62o copy

            fnms    $disc_13,$lx,$lx,$radius2_2         # 63e
            lqd     $nearest_6,256($a_packet_2)         # 63o

            fnms    $t_4,$s_7,$e_10,$b_18               # 64e
            shlqbyi $a_packet_8,$a_packet_2,0           # 64o copy

            fi      $y,$disc_10,$y                      # 65e
        rotqbyi $a_packet_2,$object_2,4                 # 65o

            clgt    $hit,$t_best_3,$t_3                 # 66e
        lqd     $quad_2,0($object_2)                    # 66o

            fma     $e_7,$e_5,$k_half,$k_one            # 67e
            shlqbyi $b_17,$b_10,0                       # 67o copy

            fnms    $disc_12,$lx_3,$lx_3,$radius2_2     # 68e
            shlqbyi $b_18,$b_16,0                       # 68o copy

            andc    $hit_4,$hit,$disc                   # 69e its signs alone count
next_pair_back:
        brnz    $count,next_pair                        # 69o

next_pair_drain:
        fnms    $disc,$ly_8,$ly_8,$disc_13              # 0e
        rotqbii $hit_6,$hit_4,1                         # 0o

        fnms    $lz,$b_16,$dz_7,$cz                     # 1e
        lqd     $dx_9,0($a_packet_2)                    # 1o

        fnms    $disc_14,$ly_7,$ly_7,$disc_12           # 2e
        shufb   $cx,$quad_2,$quad_2,$m_x                # 2o

        fnms    $disc_11,$ly_6,$ly_6,$disc_11           # 3e
        lqd     $dy,64($a_packet_2)                     # 3o

        fm      $s,$disc_10,$y                          # 4e
        gb      $hit_3,$hit_6                           # 4o

        clgt    $hit,$t_best_4,$t_4                     # 5e
        shufb   $cy_3,$quad_2,$quad_2,$m_y              # 5o

        fnms    $disc,$lz_8,$lz_8,$disc                 # 6e
        lqd     $dx_10,16($a_packet_2)                  # 6o

        fm      $b,$cx,$dx_9                            # 7e
        lqd     $dz,128($a_packet_2)                    # 7o

        fnms    $disc_14,$lz,$lz,$disc_14               # 8e
        shlqbii $hit_3,$hit_3,4                         # 8o

        fnms    $t,$s_5,$e_7,$b_5                       # 9e
        shufb   $cz,$quad_2,$quad_2,$m_z                # 9o

        fnms    $disc_12,$lz_7,$lz_7,$disc_11           # 10e
        lqd     $dy_9,80($a_packet_2)                   # 10o

        fnms    $e,$s,$y,$k_one                         # 11e 1 - s y
        lqd     $dx,32($a_packet_2)                     # 11o

        fm      $b_9,$cx,$dx_10                         # 12e
        lqx     $merge,$bits,$hit_3                     # 12o

        fma     $b,$cy_3,$dy,$b                         # 13e
        lqd     $dy_11,96($a_packet_2)                  # 13o

        andc    $hit,$hit,$disc_5                       # 14e its signs alone count
        lqd     $dz_7,176($a_packet_2)                  # 14o

        clgt    $hit_7,$t_best_7,$t                     # 15e
        frsqest $y,$disc                                # 15o

        ai      $a_pair,$a_pair,16                      # 16e
        lqd     $dz_10,160($a_packet_2)                 # 16o

        fm      $b_21,$cx,$dx                           # 17e
        lqd     $dy_3,112($a_packet_2)                  # 17o

        fma     $b_9,$cy_3,$dy_9,$b_9                   # 18e
        shufb   $t_best_11,$t_best_3,$t_3,$merge        # 18o

        fma     $b,$cz,$dz,$b                           # 19e
        shufb   $radius2_4,$quad_2,$quad_2,$m_radius2   # 19o

        fi      $y,$disc,$y                             # 20e
        frsqest $y_6,$disc_14                           # 20o

        andc    $hit_7,$hit_7,$disc_8                   # 21e its signs alone count
        rotqbii $hit,$hit,1                             # 21o

        fma     $e,$e,$k_half,$k_one                    # 22e
        stqd    $t_best_11,208($a_packet_10)            # 22o

        fma     $b_21,$cy_3,$dy_11,$b_21                # 23e
        lqd     $dx_4,48($a_packet_2)                   # 23o

        fi      $y_6,$disc_14,$y_6                      # 24e
        lqd     $dz_2,144($a_packet_2)                  # 24o

        nop     $127                                    # 25e pairing
        frsqest $y_7,$disc_12                           # 25o

        fnms    $lx_8,$b,$dx_9,$cx                      # 26e
        gb      $hit,$hit                               # 26o

        fm      $s_6,$disc,$y                           # 27e
        rotqbii $hit_7,$hit_7,1                         # 27o

        fnms    $ly_2,$b,$dy,$cy_3                      # 28e
        shufb   $nearest_7,$nearest_3,$object_5,$merge  # 28o

        fm      $b_2,$cx,$dx_4                          # 29e
        shlqbyi $b_5,$b_11,0                            # 29o copy

        fma     $b_9,$cz,$dz_2,$b_9                     # 30e
        shlqbii $hit,$hit,4                             # 30o

        fnms    $lz_2,$b,$dz,$cz                        # 31e
        gb      $hit_7,$hit_7                           # 31o

        fnms    $disc_15,$lx_8,$lx_8,$radius2_4         # 32e
        shlqbyi $b_22,$b,0                              # 32o copy

        fnms    $e_8,$s_6,$y,$k_one                     # 33e 1 - s y
        shlqbyi $a_packet_11,$a_packet_8,0              # 33o copy

        fi      $y_8,$disc_12,$y_7                      # 34e
        lqx     $merge_4,$bits,$hit                     # 34o

        nop     $127                                    # 35e pairing
        stqd    $nearest_7,272($a_packet_10)            # 35o

        fma     $b_2,$cy_3,$dy_3,$b_2                   # 36e
        shlqbii $hit_7,$hit_7,4                         # 36o

        fnms    $lx_10,$b_9,$dx_10,$cx                  # 37e
        lqd     $t_best_3,208($a_packet_7)              # 37o

        fnms    $disc_15,$ly_2,$ly_2,$disc_15           # 38e
        lqd     $nearest_3,272($a_packet_7)             # 38o

        fnms    $ly_9,$b_9,$dy_9,$cy_3                  # 39e
        shlqbyi $object_7,$object_6,0                   # 39o copy

        fma     $b_21,$cz,$dz_10,$b_21                  # 40e
        shufb   $nearest_8,$nearest_5,$object_5,$merge_4 # 40o

        fm      $s_7,$disc_14,$y_6                      # 41e
        lqx     $merge_5,$bits,$hit_7                   # 41o

        fma     $b_2,$cz,$dz_7,$b_2                     # 42e
        shufb   $t_best_9,$t_best_4,$t_4,$merge_4       # 42o

        fnms    $disc_16,$lx_10,$lx_10,$radius2_4       # 43e
        shlqbyi $a_packet_12,$a_packet_2,0              # 43o copy

        fma     $e_8,$e_8,$k_half,$k_one                # 44e
        stqd    $nearest_8,304($a_packet_10)            # 44o

        fnms    $t_6,$s,$e,$b_12                        # 45e
        shlqbyi $b_15,$b_9,0                            # 45o copy

        fnms    $disc_15,$lz_2,$lz_2,$disc_15           # 46e
        stqd    $t_best_9,240($a_packet_10)             # 46o

        fnms    $lz_9,$b_9,$dz_2,$cz                    # 47e
        lqd     $t_best_4,240($a_packet_7)              # 47o

        fnms    $lx_11,$b_2,$dx_4,$cx                   # 48e
        shufb   $nearest_10,$nearest_2,$object_5,$merge_5 # 48o

        fnms    $disc_16,$ly_9,$ly_9,$disc_16           # 49e
        shufb   $t_best_12,$t_best_7,$t,$merge_5        # 49o

        fm      $s_8,$disc_12,$y_8                      # 50e
        shufb   $object_8,$object_2,$object_2,$m_x      # 50o

        fnms    $lx_5,$b_21,$dx,$cx                     # 51e
        shlqbyi $a_packet_6,$a_packet_2,0               # 51o copy

        fnms    $e_3,$s_7,$y_6,$k_one                   # 52e 1 - s y
        frsqest $y_9,$disc_15                           # 52o

        fnms    $t_3,$s_6,$e_8,$b_17                    # 53e
        shlqbyi $b_13,$b_2,0                            # 53o copy

        clgt    $hit_8,$t_best_6,$t_6                   # 54e
        shlqbyi $b_3,$b_21,0                            # 54o copy

        fnms    $ly_4,$b_2,$dy_3,$cy_3                  # 55e
        shlqbyi $a_packet_8,$a_packet_2,0               # 55o copy

        andc    $hit_8,$hit_8,$disc_10                  # 56e its signs alone count
        shlqbyi $object_5,$object_8,0                   # 56o copy

        fnms    $disc_17,$lx_11,$lx_11,$radius2_4       # 57e
        fnms    $disc_16,$lz_9,$lz_9,$disc_16           # 58e

        rotmai  $hit_9,$hit_8,-31                       # 59e
        shlqbyi $a_packet_13,$a_packet_8,0              # 59o copy

        fnms    $ly_6,$b_21,$dy_11,$cy_3                # 60e
        fnms    $e_11,$s_8,$y_8,$k_one                  # 61e 1 - s y

        fma     $e_4,$e_3,$k_half,$k_one                # 62e
        fnms    $disc_18,$lx_5,$lx_5,$radius2_4         # 63e

        fi      $y_10,$disc_15,$y_9                     # 64e
        frsqest $y_8,$disc_16                           # 64o

        clgt    $hit_10,$t_best_3,$t_3                  # 65e
        selb    $t_best_8,$t_best_6,$t_6,$hit_9         # 66e

        andc    $hit_10,$hit_10,$disc                   # 67e its signs alone count
        lnop                                            # 67o pairing

        fnms    $lz_10,$b_2,$dz_7,$cz                   # 68e
        stqd    $t_best_8,192($a_packet_9)              # 68o

        fnms    $disc_19,$ly_4,$ly_4,$disc_17           # 69e
        rotqbii $hit_11,$hit_10,1                       # 69o

        selb    $nearest_11,$nearest_6,$object_6,$hit_9 # 70e
        hbr     isect_pairs_r16_return,$lr              # 70o hint

        fnms    $lz_7,$b_21,$dz_10,$cz                  # 71e
        lnop                                            # 71o pairing

        fnms    $t_4,$s_7,$e_4,$b_18                    # 72e
        stqd    $nearest_11,256($a_packet_9)            # 72o

        fma     $e_12,$e_11,$k_half,$k_one              # 73e
        lqd     $t_best_6,192($a_packet_2)              # 73o

        fnms    $disc_20,$ly_6,$ly_6,$disc_18           # 74e
        lqd     $nearest_5,304($a_packet_7)             # 74o

        fm      $s,$disc_15,$y_10                       # 75e
        stqd    $nearest_10,288($a_packet_10)           # 75o

        fi      $y_11,$disc_16,$y_8                     # 76e
        gb      $hit_12,$hit_11                         # 76o

        nop     $127                                    # 77e pairing
        lqd     $nearest_2,288($a_packet_7)             # 77o

        fnms    $disc_5,$lz_10,$lz_10,$disc_19          # 78e
        stqd    $t_best_12,224($a_packet_10)            # 78o

        clgt    $hit_4,$t_best_4,$t_4                   # 79e
        lqd     $t_best_7,224($a_packet_7)              # 79o

        fnms    $t,$s_8,$e_12,$b_5                      # 80e
        shlqbii $hit_13,$hit_12,4                       # 80o

        fnms    $disc_8,$lz_7,$lz_7,$disc_20            # 81e
        lqd     $nearest_6,256($a_packet_2)             # 81o

        fnms    $e_11,$s,$y_10,$k_one                   # 82e 1 - s y
        andc    $hit_14,$hit_4,$disc_14                 # 83e its signs alone count

        fm      $s_9,$disc_16,$y_11                     # 84e
        frsqest $y_6,$disc_5                            # 84o

        nop     $127                                    # 85e pairing
        rotqbii $hit_14,$hit_14,1                       # 85o

        clgt    $hit_7,$t_best_7,$t                     # 86e
        lqx     $merge_6,$bits,$hit_13                  # 86o

        frsqest $y_7,$disc_8                            # 87o
        fma     $e_11,$e_11,$k_half,$k_one              # 88e

        andc    $hit_15,$hit_7,$disc_12                 # 89e its signs alone count
        gb      $hit_14,$hit_14                         # 89o

        fi      $y_6,$disc_5,$y_6                       # 90e
        lnop                                            # 90o pairing

        fi      $y_8,$disc_8,$y_7                       # 91e
        rotqbii $hit_15,$hit_15,1                       # 91o

        nop     $127                                    # 92e pairing
        shufb   $t_best_13,$t_best_3,$t_3,$merge_6      # 92o

        fnms    $e_4,$s_9,$y_11,$k_one                  # 93e 1 - s y
        shlqbii $hit_14,$hit_14,4                       # 93o

        fnms    $t_5,$s,$e_11,$b_22                     # 94e
        shufb   $nearest_12,$nearest_3,$object_7,$merge_6 # 94o

        gb      $hit_6,$hit_15                          # 95o
        stqd    $t_best_13,208($a_packet_11)            # 96o

        fm      $s_7,$disc_5,$y_6                       # 97e
        lqx     $merge_2,$bits,$hit_14                  # 97o

        fm      $s_10,$disc_8,$y_8                      # 98e
        stqd    $nearest_12,272($a_packet_11)           # 98o

        fma     $e_12,$e_4,$k_half,$k_one               # 99e
        shlqbii $hit_3,$hit_6,4                         # 99o

        clgt    $hit_6,$t_best_6,$t_5                   # 100e
        lqd     $t_best_3,208($a_packet_12)             # 100o

        lqd     $nearest_3,272($a_packet_12)            # 101o
        andc    $hit_16,$hit_6,$disc_15                 # 102e its signs alone count

        fnms    $e_11,$s_7,$y_6,$k_one                  # 103e 1 - s y
        shufb   $nearest_8,$nearest_5,$object_7,$merge_2 # 103o

        rotmai  $hit_16,$hit_16,-31                     # 104e
        lqx     $merge_3,$bits,$hit_3                   # 104o

        fnms    $t_3,$s_9,$e_12,$b_15                   # 105e
        shufb   $t_best_8,$t_best_4,$t_4,$merge_2       # 105o

        fnms    $e_5,$s_10,$y_8,$k_one                  # 106e 1 - s y
        stqd    $nearest_8,304($a_packet_11)            # 107o

        selb    $t_best_9,$t_best_6,$t_5,$hit_16        # 108e
        lnop                                            # 108o pairing

        fma     $e_12,$e_11,$k_half,$k_one              # 109e
        stqd    $t_best_8,240($a_packet_11)             # 109o

        selb    $nearest_9,$nearest_6,$object_8,$hit_16 # 110e
        lqd     $t_best_4,240($a_packet_12)             # 110o

        clgt    $hit_6,$t_best_3,$t_3                   # 111e
        shufb   $nearest_13,$nearest_2,$object_7,$merge_3 # 111o

        fma     $e_7,$e_5,$k_half,$k_one                # 112e
        stqd    $t_best_9,192($a_packet_6)              # 112o

        andc    $hit_4,$hit_6,$disc_16                  # 113e its signs alone count
        stqd    $nearest_9,256($a_packet_6)             # 113o

        nop     $127                                    # 114e pairing
        shufb   $t_best_10,$t_best_7,$t,$merge_3        # 114o

        fnms    $t_4,$s_7,$e_12,$b_13                   # 115e
        lqd     $nearest_5,304($a_packet_12)            # 115o

        stqd    $nearest_13,288($a_packet_11)           # 116o
        rotqbii $hit_16,$hit_4,1                        # 117o

        fnms    $t,$s_10,$e_7,$b_3                      # 118e
        lqd     $nearest_2,288($a_packet_12)            # 118o

        stqd    $t_best_10,224($a_packet_11)            # 119o
        lqd     $t_best_7,224($a_packet_12)             # 120o

        clgt    $hit,$t_best_4,$t_4                     # 121e
        gb      $hit_3,$hit_16                          # 121o

        andc    $hit,$hit,$disc_5                       # 123e its signs alone count
        shlqbii $hit_3,$hit_3,4                         # 125o

        clgt    $hit_5,$t_best_7,$t                     # 126e
        rotqbii $hit,$hit,1                             # 126o

        andc    $hit_5,$hit_5,$disc_8                   # 128e its signs alone count
        lqx     $merge,$bits,$hit_3                     # 129o

        rotqbii $hit_2,$hit_5,1                         # 130o
        gb      $hit,$hit                               # 131o

        gb      $hit_3,$hit_2                           # 134o
        shufb   $t_best_8,$t_best_3,$t_3,$merge         # 135o

        shlqbii $hit,$hit,4                             # 136o
        shufb   $nearest_7,$nearest_3,$object_5,$merge  # 137o

        shlqbii $hit_3,$hit_3,4                         # 138o
        stqd    $t_best_8,208($a_packet_13)             # 139o

        lqx     $merge_2,$bits,$hit                     # 140o
        stqd    $nearest_7,272($a_packet_13)            # 141o

        lqx     $merge_3,$bits,$hit_3                   # 142o
        shufb   $nearest_8,$nearest_5,$object_5,$merge_2 # 146o

        shufb   $t_best_8,$t_best_4,$t_4,$merge_2       # 147o
        shufb   $nearest_9,$nearest_2,$object_5,$merge_3 # 148o

        shufb   $t_best_10,$t_best_7,$t,$merge_3        # 149o
        stqd    $nearest_8,304($a_packet_13)            # 150o

        stqd    $t_best_8,240($a_packet_13)             # 151o
        stqd    $nearest_9,288($a_packet_13)            # 152o

        stqd    $t_best_10,224($a_packet_13)            # 153o
isect_pairs_r16_return:
        bi      $lr                                     # 154o

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

        fm      $b_10,$cx,$dx_9                         # 18e
        lqd     $dz,144($a_packet)                      # 18o

        fm      $b_23,$cx,$dx_10                        # 19e
        lqd     $dz_11,160($a_packet)                   # 19o

        lqd     $dz_3,176($a_packet)                    # 20o
        shufb   $cz_3,$quad,$quad,$m_z                  # 21o

        nop     $127                                    # 22e pairing
        lqd     $dx_11,0($a_packet)                     # 22o

        fma     $b,$cy,$dy,$b                           # 23e
        lqd     $dy_12,64($a_packet)                    # 23o

        fma     $b_10,$cy,$dy_10,$b_10                  # 24e
        shufb   $radius2_5,$quad,$quad,$m_radius2       # 24o

        fma     $b_23,$cy,$dy_11,$b_23                  # 25e
        lqd     $dz_12,128($a_packet)                   # 25o

        lqd     $t_best_14,208($a_packet)               # 26o
        lqd     $t_best_15,224($a_packet)               # 27o

        fm      $b_14,$cx,$dx_11                        # 28e
        lqd     $t_best_8,240($a_packet)                # 28o

        fma     $b,$cz_3,$dz,$b                         # 29e
        lqd     $t_best_16,192($a_packet)               # 29o

        fma     $b_10,$cz_3,$dz_11,$b_10                # 30e
        lqd     $nearest_14,272($a_packet)              # 30o

        fma     $b_23,$cz_3,$dz_3,$b_23                 # 31e
        lqd     $nearest_4,288($a_packet)               # 31o

        lqd     $nearest_7,304($a_packet)               # 32o
        lqd     $nearest_15,256($a_packet)              # 33o

        fma     $b_14,$cy,$dy_12,$b_14                  # 34e
        fnms    $lx_6,$b,$dx,$cx                        # 35e

        fnms    $lx_8,$b_10,$dx_9,$cx                   # 36e
        fnms    $lx_10,$b_23,$dx_10,$cx                 # 37e

        fnms    $ly_2,$b,$dy,$cy                        # 38e
        fnms    $ly_8,$b_10,$dy_10,$cy                  # 39e

        fnms    $ly_7,$b_23,$dy_11,$cy                  # 40e
        fnms    $disc_9,$lx_6,$lx_6,$radius2_5          # 41e

        fnms    $disc_15,$lx_8,$lx_8,$radius2_5         # 42e
        fnms    $disc_16,$lx_10,$lx_10,$radius2_5       # 43e

        fma     $b_14,$cz_3,$dz_12,$b_14                # 44e
        fnms    $lz_2,$b,$dz,$cz_3                      # 45e

        fnms    $lz_11,$b_10,$dz_11,$cz_3               # 46e
        fnms    $disc_9,$ly_2,$ly_2,$disc_9             # 47e

        fnms    $disc_15,$ly_8,$ly_8,$disc_15           # 48e
        fnms    $lz_12,$b_23,$dz_3,$cz_3                # 49e

        fnms    $disc_16,$ly_7,$ly_7,$disc_16           # 50e
        fnms    $lx_2,$b_14,$dx_11,$cx                  # 51e

        fnms    $ly_5,$b_14,$dy_12,$cy                  # 52e
        fnms    $disc_6,$lz_2,$lz_2,$disc_9             # 53e

        fnms    $disc_15,$lz_11,$lz_11,$disc_15         # 54e
        fnms    $lz_11,$b_14,$dz_12,$cz_3               # 55e

        fnms    $disc_16,$lz_12,$lz_12,$disc_16         # 56e
        fnms    $disc_14,$lx_2,$lx_2,$radius2_5         # 57e

        frsqest $y_11,$disc_6                           # 59o
        frsqest $y_12,$disc_15                          # 60o

        frsqest $y_4,$disc_16                           # 62o
        fnms    $disc_14,$ly_5,$ly_5,$disc_14           # 63e

        fi      $y_11,$disc_6,$y_11                     # 64e
        fi      $y_12,$disc_15,$y_12                    # 65e

        fi      $y_10,$disc_16,$y_4                     # 66e
        fnms    $disc_14,$lz_11,$lz_11,$disc_14         # 69e

        fm      $s_11,$disc_6,$y_11                     # 71e
        fm      $s_6,$disc_15,$y_12                     # 72e

        fm      $s_12,$disc_16,$y_10                    # 73e
        frsqest $y_13,$disc_14                          # 75o

        fnms    $e_4,$s_11,$y_11,$k_one                 # 77e 1 - s y
        fnms    $e_13,$s_6,$y_12,$k_one                 # 78e 1 - s y

        fnms    $e_14,$s_12,$y_10,$k_one                # 79e 1 - s y
        fi      $y_13,$disc_14,$y_13                    # 80e

        fma     $e_4,$e_4,$k_half,$k_one                # 83e
        fma     $e_13,$e_13,$k_half,$k_one              # 84e

        fma     $e_14,$e_14,$k_half,$k_one              # 85e
        fm      $s_13,$disc_14,$y_13                    # 87e

        fnms    $t_7,$s_11,$e_4,$b                      # 89e
        fnms    $t_8,$s_6,$e_13,$b_10                   # 90e

        fnms    $t_9,$s_12,$e_14,$b_23                  # 91e
        fnms    $e_13,$s_13,$y_13,$k_one                # 93e 1 - s y

        clgt    $hit_17,$t_best_14,$t_7                 # 95e
        clgt    $hit_18,$t_best_15,$t_8                 # 96e

        clgt    $hit_2,$t_best_8,$t_9                   # 97e
        andc    $hit_17,$hit_17,$disc_6                 # 98e its signs alone count

        andc    $hit_16,$hit_18,$disc_15                # 99e its signs alone count
        lnop                                            # 99o pairing

        andc    $hit_19,$hit_2,$disc_16                 # 100e its signs alone count
        rotqbii $hit_17,$hit_17,1                       # 100o

        fma     $e_13,$e_13,$k_half,$k_one              # 101e
        rotqbii $hit_16,$hit_16,1                       # 101o

        rotqbii $hit_19,$hit_19,1                       # 102o
        gb      $hit_17,$hit_17                         # 104o

        gb      $hit_16,$hit_16                         # 105o
        gb      $hit_19,$hit_19                         # 106o

        fnms    $t_10,$s_13,$e_13,$b_14                 # 107e
        shlqbii $hit_17,$hit_17,4                       # 108o

        shlqbii $hit_16,$hit_16,4                       # 109o
        shlqbii $hit_19,$hit_19,4                       # 110o

        nop     $127                                    # 111e pairing
        lqx     $merge_7,$bits,$hit_17                  # 112o

        clgt    $hit_20,$t_best_16,$t_10                # 113e
        lqx     $merge_8,$bits,$hit_16                  # 113o

        lqx     $merge_9,$bits,$hit_19                  # 114o
        andc    $hit_14,$hit_20,$disc_14                # 115e its signs alone count

        rotmai  $hit_14,$hit_14,-31                     # 117e
        shufb   $t_best,$t_best_14,$t_7,$merge_7        # 118o

        shufb   $nearest,$nearest_14,$object,$merge_7   # 119o
        shufb   $t_best_10,$t_best_15,$t_8,$merge_8     # 120o

        selb    $t_best_17,$t_best_16,$t_10,$hit_14     # 121e
        shufb   $nearest_9,$nearest_4,$object,$merge_8  # 121o

        selb    $nearest_16,$nearest_15,$object,$hit_14 # 122e
        shufb   $t_best_12,$t_best_8,$t_9,$merge_9      # 122o

        shufb   $nearest_17,$nearest_7,$object,$merge_9 # 123o
        stqd    $t_best_17,192($a_packet)               # 124o

        stqd    $nearest_16,256($a_packet)              # 125o
        stqd    $t_best,208($a_packet)                  # 126o

        stqd    $nearest,272($a_packet)                 # 127o
        stqd    $t_best_10,224($a_packet)               # 128o

        stqd    $nearest_9,288($a_packet)               # 129o
        stqd    $t_best_12,240($a_packet)               # 130o

        stqd    $nearest_17,304($a_packet)              # 131o
        brnz    $count,next_pair_short                  # 132o

        nop     $127                                    # 133e pairing
        bi      $lr                                     # 133o
endfunction isect_pairs_r16
