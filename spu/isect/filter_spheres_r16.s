# filter_spheres_r16   of an array of spheres, those that some of sixteen eye rays may enter
#   C       struct pair *filter_spheres_r16(const struct packet *, const struct sphere *, int fours,
#                                           struct pair *);
#   In      $3 packet, $4 spheres, $5 spheres in fours (at least 1), $6 where pairs go;
#           pointers 16-aligned
#   Out     a pair for each such sphere, in order; one more quadword may be written
#           $3 behind the last pair
#   Uses    $3-$6, $10-$61   Saves  -   Stack  0   Calls  -
#   Domain  |d| = 1 within 4 ulp; limits as the PPU makes them
#   Error   0: no sphere is left out that a ray enters
#   Twin    oracle/src/twin/cull.rs
#
# A unit direction d enters the sphere around c if c.d is above the cosine of the sphere's cone times
# |c|. The limit is a little less than that, so that rounding lets no sphere slip through: what
# passes here is tested exactly by isect_pairs_r16. Per ray
#   s = limit - c.d, negative if it may be entered
# and the signs of all sixteen are brought together on the odd pipe.
# Scheduled by spu schedule from filter_spheres_r16.s

        .include "work_unit.inc"
        .include "macros.inc"

        .set    a_packet,3
        .set    a_sphere,4
        .set    fours,5
        .set    a_pairs,6
        # constants
        .set    m_x,10
        .set    m_y,11
        .set    m_z,12
        .set    m_limit,13
        .set    m_signs,14                              # top bytes of two quadwords' words
        .set    m_halves,15                             # the first half of one, the last of another
        .set    m_pair,16
        .set    k_next,17
        .set    k_all,18
        # the rays: rows 0 to 3 of the packet
        .set    dx,20
        .set    dy,24
        .set    dz,28
        # state: the pair of the sphere at hand, whose first word is the sphere's address; pairs so far
        .set    pair,32
        .set    found,33
        # the sphere
        .set    quad,34
        .set    more,35
        .set    cx,36
        .set    cy,37
        .set    cz,38
        .set    limit,39
        # temporaries
        .set    s,40                                    # to 43
        .set    signs,44
        .set    signs_low,45
        .set    c_any,46
        .set    offset,47

        .section .rodata
        .align  4
signs_of_two:
        .int    0x0004080c,0x1014181c,0x0004080c,0x1014181c
halves: .int    0x00010203,0x04050607,0x18191a1b,0x1c1d1e1f

function filter_spheres_r16
        .set    fours_2,79
        .set    pair_2,2
        .set    pair_3,3
        .set    more_2,4
        .set    quad_2,7
        .set    pair_4,16
        .set    quad_3,8
        .set    more_3,9
        .set    limit_2,4
        .set    cx_2,19
        .set    s2_2,35
        .set    cx_3,38
        .set    s1_2,40
        .set    limit_3,9
        .set    s_2,41
        .set    cz_2,34
        .set    s3_2,36
        .set    cy_2,39
        .set    s1_3,42
        .set    cy_3,43
        .set    s_3,44
        .set    quad_4,45
        .set    more_4,46
        .set    cz_3,7
        .set    cz_4,8
        .set    s2_3,37
        .set    s3_3,4
        .set    s3_4,19
        .set    cx_4,47
        .set    s1_4,32
        .set    limit_4,46
        .set    s2_4,48
        .set    cy_4,49
        .set    s_4,38
        .set    cz_5,9
        .set    s3_5,34
        .set    s_5,36
        .set    signs_2,39
        .set    s2_5,34
        .set    s_6,35
        .set    s1_5,7
        .set    more_5,19
        .set    signs_3,8
        .set    s3_6,37
        .set    s1_6,38
        .set    pair_5,19
        .set    cx_5,41
        .set    signs_low_2,4
        .set    signs_4,7
        .set    more_6,37
        .set    quad_5,40
        .set    signs_5,4
        .set    s_7,8
        .set    cy_5,45
        .set    s3_7,39
        .set    pair_6,48
        .set    limit_5,37
        .set    quad_6,46
        .set    more_7,47
        .set    s1_7,9
        .set    s2_6,38
        .set    offset_2,42
        .set    signs_6,49
        .set    cy_6,50
        .set    cx_6,51
        .set    s1_8,45
        .set    s_8,2
        .set    signs_low_3,35
        .set    c_any_2,4
        .set    limit_6,36
        .set    cz_6,4
        .set    c_any_3,8
        .set    cy_7,9
        .set    signs_7,3
        .set    found_2,7
        .set    signs_8,35
        .set    s1_9,33
        .set    pair_7,49
        .set    s3_8,8
        .set    s2_7,3
        .set    more_8,39
        .set    s1_10,16
        .set    s2_8,2
        .set    s2_9,7
        .set    s3_9,9
        .set    s_9,7
        .set    s1_11,8
        .set    found_3,4
        .set    signs_9,2
        .set    found_4,3
        .set    s2_10,9
        .set    s3_10,16
        .set    pair_8,5
        .set    more_9,33
        .set    s_10,9
        .set    quad_7,38
        .set    pair_9,43
        .set    s2_11,47
        .set    quad_8,50
        .set    pair_10,51
        .set    quad_9,52
        .set    s_11,53
        .set    more_10,54
        .set    s3_11,55
        .set    limit_7,33
        .set    s1_12,36
        .set    cx_7,39
        .set    quad_10,56
        .set    more_11,8
        .set    s2_12,57
        .set    cx_8,58
        .set    s1_13,59
        .set    cy_8,60
        .set    s_12,61
        .set    cx_9,62
        .set    s3_12,33
        .set    s1_14,54
        .set    cy_9,63
        .set    s_13,64
        .set    cx_10,10
        .set    s2_13,65
        .set    limit_8,8
        .set    s3_13,13
        .set    cy_10,46
        .set    cz_7,45
        .set    cy_11,58
        .set    cy_12,11
        .set    s3_14,60
        .set    cz_8,50
        .set    s1_15,66
        .set    signs_10,40
        .set    s2_14,41
        .set    signs_low_4,3
        .set    s_14,4
        .set    cz_9,39
        .set    s2_15,52
        .set    cz_10,12
        .set    s1_16,56
        .set    s_15,57
        .set    s2_16,22
        .set    s_16,20
        .set    s3_15,23
        .set    s1_17,10
        .set    s2_17,21
        .set    signs_low_5,37
        .set    s_17,42
        .set    signs_11,10
        .set    s3_16,40
        .set    s3_17,45
        .set    s1_18,46
        .set    signs_low_6,34
        .set    signs_12,36
        .set    signs_13,24
        .set    signs_14,11
        .set    signs_low_7,25
        .set    s3_18,26
        .set    s_18,16
        .set    signs_low_8,12
        .set    c_any_4,20
        .set    signs_15,21
        .set    c_any_5,7
        .set    found_5,9
        .set    c_any_6,11
        .set    pair_11,10
        .set    found_6,10
        .set    offset_3,4
        .set    offset_4,7
        .set    offset_5,8
        .set    offset_6,3
        .set    quad_11,4
        .set    more_12,7
        .set    pair_12,8
        .set    quad_12,9
        .set    more_13,16
        .set    limit_9,7
        .set    cx_11,35
        .set    limit_10,16
        .set    more_14,36
        .set    s_19,39
        .set    cy_13,44
        .set    s3_19,7
        .set    s_20,19
        .set    cx_12,48
        .set    s1_19,49
        .set    s2_18,50
        .set    cy_14,35
        .set    offset_7,51
        .set    s_21,37
        .set    s1_20,39
        .set    s2_19,32
        .set    s1_21,44
        .set    s2_20,45
        .set    s_22,34
        .set    signs_low_9,39
        .set    s2_21,19
        .set    signs_16,16
        .set    signs_low_10,7
        .set    signs_17,9
        .set    found_7,2
        ilhu    $m_x,1                                  # 0e
        fsmbi   $m_pair,0xf000                          # 0o

        ilhu    $m_y,0x405                              # 1e
        rotqmbyi $pair,$a_packet,-4                      # 1o

        ilhu    $m_z,0x809                              # 2e
        lqa     $m_signs,signs_of_two                   # 2o

        ilhu    $m_limit,0x405                          # 3e
        lqa     $m_halves,halves                        # 3o

        il      $k_next,48                              # 4e
        lqd     $dx,0($a_packet)                        # 4o

        clgti   $fours_2,$fours,3                       # 5e at least as many passes as overlap
        lqd     $dy,64($a_packet)                       # 5o

        iohl    $m_x,515                                # 6e
        lqd     $dz,128($a_packet)                      # 6o

        iohl    $m_y,0x607                              # 7e
        lqd     $dx+1,16($a_packet)                     # 7o

        iohl    $m_z,0xa0b                              # 8e
        lqd     $dy+1,80($a_packet)                     # 8o

        iohl    $m_limit,0x607                          # 9e
        lqd     $dz+1,144($a_packet)                    # 9o

        il      $k_all,-1                               # 10e
        lqd     $dx+2,32($a_packet)                     # 10o

        and     $k_next,$k_next,$m_pair                 # 11e of the first word alone
        lqd     $dy+2,96($a_packet)                     # 11o

        selb    $pair,$pair,$a_sphere,$m_pair           # 12e
        lqd     $dz+2,160($a_packet)                    # 12o

        il      $found,0                                # 13e
        lqd     $dx+3,48($a_packet)                     # 13o

        lqd     $dy+3,112($a_packet)                    # 14o
        lqd     $dz+3,176($a_packet)                    # 15o

        nop     $127                                    # 16e pairing
        brz     $fours_2,next_four_short                # 16o too few passes

        a       $pair_2,$pair,$k_next                   # 17e
        lqd     $more,16($pair)                         # 17o

        ai      $fours,$fours,-1                        # 18e
        lqd     $quad,0($pair)                          # 18o

        a       $pair_3,$pair_2,$k_next                 # 19e
        lqd     $more_2,16($pair_2)                     # 19o

        ai      $fours,$fours,-1                        # 20e
        lqd     $quad_2,0($pair_2)                      # 20o

        a       $pair_4,$pair_3,$k_next                 # 21e
        lqd     $quad_3,0($pair_3)                      # 21o

        ai      $fours,$fours,-1                        # 22e
        lqd     $more_3,16($pair_3)                     # 22o

        shufb   $limit,$more,$more,$m_limit             # 23o
        shufb   $cx,$quad,$quad,$m_x                    # 24o

        shufb   $cy,$quad,$quad,$m_y                    # 25o
        shufb   $limit_2,$more_2,$more_2,$m_limit       # 26o

        nop     $127                                    # 27e pairing
        shufb   $cx_2,$quad_2,$quad_2,$m_x              # 27o

        fnms    $s2_2,$cx,$dx+2,$limit                  # 28e
        shufb   $cx_3,$quad_3,$quad_3,$m_x              # 28o

        fnms    $s1_2,$cx,$dx+1,$limit                  # 29e
        shufb   $limit_3,$more_3,$more_3,$m_limit       # 29o

        fnms    $s_2,$cx,$dx,$limit                     # 30e
        shufb   $cz_2,$quad,$quad,$m_z                  # 30o

        fnms    $s3_2,$cx,$dx+3,$limit                  # 31e
        shufb   $cy_2,$quad_2,$quad_2,$m_y              # 31o

        fnms    $s1_3,$cx_2,$dx+1,$limit_2              # 32e
        shufb   $cy_3,$quad_3,$quad_3,$m_y              # 32o

        fnms    $s_3,$cx_2,$dx,$limit_2                 # 33e
        lqd     $quad_4,0($pair_4)                      # 33o

        fnms    $s2_2,$cy,$dy+2,$s2_2                   # 34e
        lqd     $more_4,16($pair_4)                     # 34o

        fnms    $s1_2,$cy,$dy+1,$s1_2                   # 35e
        shlqbii $offset,$found,4                        # 35o

        fnms    $s_2,$cy,$dy,$s_2                       # 36e
        shufb   $cz_3,$quad_2,$quad_2,$m_z              # 36o

        fnms    $s3_2,$cy,$dy+3,$s3_2                   # 37e
        shufb   $cz_4,$quad_3,$quad_3,$m_z              # 37o

        fnms    $s2_3,$cx_2,$dx+2,$limit_2              # 38e
        lnop                                            # 38o pairing

        fnms    $s3_3,$cx_2,$dx+3,$limit_2              # 39e
        stqx    $pair,$a_pairs,$offset                  # 39o

        fnms    $s3_4,$cx_3,$dx+3,$limit_3              # 40e
        shufb   $cx_4,$quad_4,$quad_4,$m_x              # 40o

        fnms    $s1_4,$cx_3,$dx+1,$limit_3              # 41e
        shufb   $limit_4,$more_4,$more_4,$m_limit       # 41o

        fnms    $s2_4,$cx_3,$dx+2,$limit_3              # 42e
        shufb   $cy_4,$quad_4,$quad_4,$m_y              # 42o

        fnms    $s_4,$cx_3,$dx,$limit_3                 # 43e
        shufb   $cz_5,$quad_4,$quad_4,$m_z              # 43o

        fnms    $s2_2,$cz_2,$dz+2,$s2_2                 # 44e
        fnms    $s1_2,$cz_2,$dz+1,$s1_2                 # 45e

        fnms    $s_2,$cz_2,$dz,$s_2                     # 46e
        fnms    $s3_5,$cz_2,$dz+3,$s3_2                 # 47e

        fnms    $s_5,$cy_2,$dy,$s_3                     # 48e
        fnms    $s1_3,$cy_2,$dy+1,$s1_3                 # 49e

        fnms    $s3_3,$cy_2,$dy+3,$s3_3                 # 50e
        fnms    $s2_3,$cy_2,$dy+2,$s2_3                 # 51e

        fnms    $s3_4,$cy_3,$dy+3,$s3_4                 # 52e
        shufb   $signs_2,$s_2,$s1_2,$m_signs            # 52o

        fnms    $s1_2,$cy_3,$dy+1,$s1_4                 # 53e
        shufb   $signs_low,$s2_2,$s3_5,$m_signs         # 53o

        fnms    $s2_5,$cy_3,$dy+2,$s2_4                 # 54e
        fnms    $s_6,$cy_3,$dy,$s_4                     # 55e

        fnms    $s_5,$cz_3,$dz,$s_5                     # 56e
        lnop                                            # 56o pairing

        fnms    $s+1,$cz_3,$dz+1,$s1_3                  # 57e
        shufb   $signs,$signs_2,$signs_low,$m_halves    # 57o

        fnms    $s2_3,$cz_3,$dz+2,$s2_3                 # 58e
        fnms    $s+3,$cz_3,$dz+3,$s3_3                  # 59e

        a       $pair,$pair_4,$k_next                   # 60e
        lnop                                            # 60o pairing

        fnms    $s3_3,$cz_4,$dz+3,$s3_4                 # 61e
        rotqbii $signs,$signs,1                         # 61o signs to the bytes' last bits

        fnms    $s1_5,$cz_4,$dz+1,$s1_2                 # 62e
        lqd     $more_5,16($pair)                       # 62o

        fnms    $s+2,$cz_4,$dz+2,$s2_5                  # 63e
        lqd     $quad,0($pair)                          # 63o

        fnms    $s,$cz_4,$dz,$s_6                       # 64e
        shufb   $signs_3,$s_5,$s+1,$m_signs             # 64o

        fnms    $s2_2,$cx_4,$dx+2,$limit_4              # 65e
        shufb   $signs_low,$s2_3,$s+3,$m_signs          # 65o

        fnms    $s_5,$cx_4,$dx,$limit_4                 # 66e
        gbb     $signs,$signs                           # 66o

        fnms    $s3_6,$cx_4,$dx+3,$limit_4              # 67e
        lnop                                            # 67o pairing

        fnms    $s1_6,$cx_4,$dx+1,$limit_4              # 68e
        shufb   $limit,$more_5,$more_5,$m_limit         # 68o

        a       $pair_5,$pair,$k_next                   # 69e
        shufb   $cx_5,$quad,$quad,$m_x                  # 69o

        cg      $c_any,$signs,$k_all                    # 70e 1 if any, else 0
        shufb   $signs_low_2,$s+2,$s3_3,$m_signs        # 70o

        fnms    $s2_2,$cy_4,$dy+2,$s2_2                 # 71e
        shufb   $signs_4,$s,$s1_5,$m_signs              # 71o

        fnms    $s_5,$cy_4,$dy,$s_5                     # 72e
        shufb   $signs_3,$signs_3,$signs_low,$m_halves  # 72o

        fnms    $s+3,$cy_4,$dy+3,$s3_6                  # 73e
        lqd     $more_6,16($pair_5)                     # 73o

        fnms    $s1_6,$cy_4,$dy+1,$s1_6                 # 74e
        lqd     $quad_5,0($pair_5)                      # 74o

        fnms    $s+2,$cx_5,$dx+2,$limit                 # 75e
        shufb   $signs_5,$signs_4,$signs_low_2,$m_halves # 75o

        fnms    $s1_5,$cx_5,$dx+1,$limit                # 76e
        rotqbii $signs,$signs_3,1                       # 76o signs to the bytes' last bits

        fnms    $s_7,$cx_5,$dx,$limit                   # 77e
        shufb   $cy_5,$quad,$quad,$m_y                  # 77o

        fnms    $s3_7,$cx_5,$dx+3,$limit                # 78e
        shufb   $cz_2,$quad,$quad,$m_z                  # 78o

        a       $pair_6,$pair_5,$k_next                 # 79e
        rotqbii $signs_5,$signs_5,1                     # 79o signs to the bytes' last bits

        a       $found,$found,$c_any                    # 80e
        shufb   $limit_5,$more_6,$more_6,$m_limit       # 80o

        fnms    $s2_2,$cz_5,$dz+2,$s2_2                 # 81e
        shufb   $cx_5,$quad_5,$quad_5,$m_x              # 81o

        fnms    $s_5,$cz_5,$dz,$s_5                     # 82e
        lqd     $quad_6,0($pair_6)                      # 82o

        fnms    $s+3,$cz_5,$dz+3,$s+3                   # 83e
        lqd     $more_7,16($pair_6)                     # 83o

        fnms    $s1_7,$cz_5,$dz+1,$s1_6                 # 84e
        gbb     $signs,$signs                           # 84o

        fnms    $s2_6,$cy_5,$dy+2,$s+2                  # 85e
        shlqbii $offset_2,$found,4                      # 85o

        fnms    $s1_5,$cy_5,$dy+1,$s1_5                 # 86e
        gbb     $signs_6,$signs_5                       # 86o

        fnms    $s_7,$cy_5,$dy,$s_7                     # 87e
        shufb   $cy_6,$quad_5,$quad_5,$m_y              # 87o

        fnms    $s3_7,$cy_5,$dy+3,$s3_7                 # 88e
        shufb   $cx_6,$quad_6,$quad_6,$m_x              # 88o

        fnms    $s1_8,$cx_5,$dx+1,$limit_5              # 89e
        stqx    $pair_2,$a_pairs,$offset_2              # 89o

        fnms    $s_8,$cx_5,$dx,$limit_5                 # 90e
        shufb   $signs_low_3,$s2_2,$s+3,$m_signs        # 90o

        cg      $c_any_2,$signs,$k_all                  # 91e 1 if any, else 0
        shufb   $signs,$s_5,$s1_7,$m_signs              # 91o

        fnms    $s+2,$cz_2,$dz+2,$s2_6                  # 92e
        shufb   $limit_6,$more_7,$more_7,$m_limit       # 92o

        a       $found,$found,$c_any_2                  # 93e
        shufb   $cz_6,$quad_5,$quad_5,$m_z              # 93o

        fnms    $s1_5,$cz_2,$dz+1,$s1_5                 # 94e
        hbrr    next_four_back,next_four                # 94o hint

        fnms    $s,$cz_2,$dz,$s_7                       # 95e
        shufb   $signs,$signs,$signs_low_3,$m_halves    # 95o

        fnms    $s+3,$cz_2,$dz+3,$s3_7                  # 96e
        shlqbii $offset,$found,4                        # 96o

        cg      $c_any_3,$signs_6,$k_all                # 97e 1 if any, else 0
        shufb   $cy_7,$quad_6,$quad_6,$m_y              # 97o

        fnms    $s2_6,$cx_5,$dx+2,$limit_5              # 98e
        shufb   $cz_2,$quad_6,$quad_6,$m_z              # 98o

        fnms    $s3_6,$cx_5,$dx+3,$limit_5              # 99e
        rotqbii $signs,$signs,1                         # 99o signs to the bytes' last bits

        fnms    $s_8,$cy_6,$dy,$s_8                     # 100e
        stqx    $pair_3,$a_pairs,$offset                # 100o

        fnms    $s+1,$cy_6,$dy+1,$s1_8                  # 101e
        shufb   $signs_7,$s,$s1_5,$m_signs              # 101o

        a       $found_2,$found,$c_any_3                # 102e
        shufb   $signs_low,$s+2,$s+3,$m_signs           # 102o

        fnms    $s+3,$cx_6,$dx+3,$limit_6               # 103e
        gbb     $signs_8,$signs                         # 103o

        fnms    $s1_9,$cx_6,$dx+1,$limit_6              # 104e
        shlqbii $offset,$found_2,4                      # 104o

        a       $pair_7,$pair_6,$k_next                 # 105e
        lnop                                            # 105o pairing

        fnms    $s3_8,$cy_6,$dy+3,$s3_6                 # 106e
        shufb   $signs,$signs_7,$signs_low,$m_halves    # 106o

        fnms    $s2_7,$cy_6,$dy+2,$s2_6                 # 107e
        lqd     $quad_4,0($pair_7)                      # 107o

        fnms    $s,$cz_6,$dz,$s_8                       # 108e
        stqx    $pair_4,$a_pairs,$offset                # 108o

        fnms    $s+2,$cx_6,$dx+2,$limit_6               # 109e
        lqd     $more_8,16($pair_7)                     # 109o

        fnms    $s+1,$cz_6,$dz+1,$s+1                   # 110e
        fnms    $s_4,$cx_6,$dx,$limit_6                 # 111e

        fnms    $s3_6,$cy_7,$dy+3,$s+3                  # 112e
        fnms    $s1_10,$cy_7,$dy+1,$s1_9                # 113e

next_four:
            fnms    $s+2,$cy_7,$dy+2,$s+2               # 0e
            rotqbii $signs,$signs,1                     # 0o signs to the bytes' last bits

            fnms    $s2_8,$cz_6,$dz+2,$s2_7             # 1e
            lnop                                        # 1o pairing

            cg      $c_any,$signs_8,$k_all              # 2e 1 if any, else 0
            shufb   $signs_7,$s,$s+1,$m_signs           # 2o

            fnms    $s+3,$cz_6,$dz+3,$s3_8              # 3e
            shufb   $cx,$quad_4,$quad_4,$m_x            # 3o

            a       $found,$found_2,$c_any              # 4e
            shufb   $limit,$more_8,$more_8,$m_limit     # 4o

            fnms    $s3_3,$cz_2,$dz+3,$s3_6             # 5e
            shufb   $cy,$quad_4,$quad_4,$m_y            # 5o

            fnms    $s+1,$cz_2,$dz+1,$s1_10             # 6e
            shlqbii $offset,$found,4                    # 6o

            fnms    $s,$cy_7,$dy,$s_4                   # 7e
            lnop                                        # 7o pairing

            fnms    $s2_9,$cx,$dx+2,$limit              # 8e
            shufb   $cz,$quad_4,$quad_4,$m_z            # 8o

            fnms    $s_7,$cx,$dx,$limit                 # 9e
            gbb     $signs,$signs                       # 9o

            fnms    $s3_9,$cx,$dx+3,$limit              # 10e
            stqx    $pair,$a_pairs,$offset              # 10o

            fnms    $s1_10,$cx,$dx+1,$limit             # 11e
            shufb   $signs_low,$s2_8,$s+3,$m_signs      # 11o

            a       $pair,$pair_7,$k_next               # 12e
            fnms    $s+2,$cz_2,$dz+2,$s+2               # 13e

            fnms    $s,$cz_2,$dz,$s                     # 14e
            lqd     $more,16($pair)                     # 14o

            fnms    $s2_8,$cy,$dy+2,$s2_9               # 15e
            lqd     $quad,0($pair)                      # 15o

            fnms    $s_9,$cy,$dy,$s_7                   # 16e
            shufb   $signs_7,$signs_7,$signs_low,$m_halves # 16o

            fnms    $s+3,$cy,$dy+3,$s3_9                # 17e
            cg      $c_any,$signs,$k_all                # 18e 1 if any, else 0

            fnms    $s1_11,$cy,$dy+1,$s1_10             # 19e
            shufb   $signs_low,$s+2,$s3_3,$m_signs      # 19o

            a       $found_3,$found,$c_any              # 20e
            rotqbii $signs,$signs_7,1                   # 20o signs to the bytes' last bits

            fnms    $s+2,$cz,$dz+2,$s2_8                # 21e
            shufb   $limit,$more,$more,$m_limit         # 21o

            fnms    $s_8,$cz,$dz,$s_9                   # 22e
            shufb   $cx,$quad,$quad,$m_x                # 22o

            fnms    $s+3,$cz,$dz+3,$s+3                 # 23e
            shlqbii $offset,$found_3,4                  # 23o

        ai      $fours,$fours,-1                        # 24e
            shufb   $signs_7,$s,$s+1,$m_signs           # 24o

            fnms    $s+1,$cz,$dz+1,$s1_11               # 25e
            shufb   $cy,$quad,$quad,$m_y                # 25o

            fnms    $s2_9,$cx,$dx+2,$limit              # 26e
            shufb   $cz,$quad,$quad,$m_z                # 26o

            fnms    $s1_11,$cx,$dx+1,$limit             # 27e
            stqx    $pair_5,$a_pairs,$offset            # 27o

            fnms    $s,$cx,$dx,$limit                   # 28e
            shufb   $signs_7,$signs_7,$signs_low,$m_halves # 28o

            a       $pair_5,$pair,$k_next               # 29e
            gbb     $signs,$signs                       # 29o

            fnms    $s3_9,$cx,$dx+3,$limit              # 30e
            lqd     $more,16($pair_5)                   # 31o

            fnms    $s2_9,$cy,$dy+2,$s2_9               # 32e
            lqd     $quad,0($pair_5)                    # 32o

            fnms    $s1_11,$cy,$dy+1,$s1_11             # 33e
            shufb   $signs_low,$s+2,$s+3,$m_signs       # 33o

            cg      $c_any,$signs,$k_all                # 34e 1 if any, else 0
            shufb   $signs,$s_8,$s+1,$m_signs           # 34o

            fnms    $s,$cy,$dy,$s                       # 35e
            rotqbii $signs_9,$signs_7,1                 # 35o signs to the bytes' last bits

            fnms    $s+3,$cy,$dy+3,$s3_9                # 36e
            lnop                                        # 36o pairing

            a       $found_4,$found_3,$c_any            # 37e
            shufb   $limit,$more,$more,$m_limit         # 37o

            fnms    $s+2,$cz,$dz+2,$s2_9                # 38e
            shufb   $cx,$quad,$quad,$m_x                # 38o

            fnms    $s+1,$cz,$dz+1,$s1_11               # 39e
            shlqbii $offset,$found_4,4                  # 39o

            nop     $127                                # 40e pairing
            shufb   $cz_6,$quad,$quad,$m_z              # 40o

            fnms    $s,$cz,$dz,$s                       # 41e
            shufb   $cy,$quad,$quad,$m_y                # 41o

            fnms    $s1_5,$cx,$dx+1,$limit              # 42e
            shufb   $signs,$signs,$signs_low,$m_halves  # 42o

            fnms    $s_7,$cx,$dx,$limit                 # 43e
            stqx    $pair_6,$a_pairs,$offset            # 43o

            a       $pair_6,$pair_5,$k_next             # 44e
            gbb     $signs_9,$signs_9                   # 44o

            fnms    $s2_10,$cx,$dx+2,$limit             # 45e
            lnop                                        # 45o pairing

            fnms    $s3_10,$cx,$dx+3,$limit             # 46e
            lqd     $quad,0($pair_6)                    # 46o

            fnms    $s+3,$cz,$dz+3,$s+3                 # 47e
            lqd     $more,16($pair_6)                   # 47o

            cg      $c_any,$signs_9,$k_all              # 48e 1 if any, else 0
            shufb   $signs_9,$s,$s+1,$m_signs           # 48o

            fnms    $s,$cy,$dy,$s_7                     # 49e
            rotqbii $signs,$signs,1                     # 49o signs to the bytes' last bits

            fnms    $s+1,$cy,$dy+1,$s1_5                # 50e
            a       $found_2,$found_4,$c_any            # 51e

            fnms    $s3_8,$cy,$dy+3,$s3_10              # 52e
            shufb   $cx,$quad,$quad,$m_x                # 52o

            fnms    $s2_7,$cy,$dy+2,$s2_10              # 53e
            shufb   $limit,$more,$more,$m_limit         # 53o

            nop     $127                                # 54e pairing
            shlqbii $offset,$found_2,4                  # 54o

            fnms    $s,$cz_6,$dz,$s                     # 55e
            shufb   $signs_low,$s+2,$s+3,$m_signs       # 55o

            shufb   $cy_7,$quad,$quad,$m_y              # 56o
            fnms    $s+3,$cx,$dx+3,$limit               # 57e

            fnms    $s1_10,$cx,$dx+1,$limit             # 58e
            stqx    $pair_7,$a_pairs,$offset            # 58o

            fnms    $s+2,$cx,$dx+2,$limit               # 59e
            gbb     $signs_8,$signs                     # 59o

            a       $pair_7,$pair_6,$k_next             # 60e
            shufb   $cz_2,$quad,$quad,$m_z              # 60o

            fnms    $s+1,$cz_6,$dz+1,$s+1               # 61e
            shufb   $signs,$signs_9,$signs_low,$m_halves # 61o

            fnms    $s_4,$cx,$dx,$limit                 # 62e
            lqd     $quad_4,0($pair_7)                  # 62o

            fnms    $s3_6,$cy_7,$dy+3,$s+3              # 63e
            lqd     $more_8,16($pair_7)                 # 63o

            fnms    $s1_10,$cy_7,$dy+1,$s1_10           # 64e
next_four_back:
        brnz    $fours,next_four                        # 64o

next_four_drain:
        a       $pair_2,$pair_7,$k_next                 # 0e
        shufb   $cx,$quad_4,$quad_4,$m_x                # 0o

        fnms    $s+2,$cy_7,$dy+2,$s+2                   # 1e
        shufb   $limit,$more_8,$more_8,$m_limit         # 1o

        a       $pair_8,$pair_2,$k_next                 # 2e
        lqd     $more_9,16($pair_2)                     # 2o

        fnms    $s_10,$cy_7,$dy,$s_4                    # 3e
        lqd     $quad_7,0($pair_2)                      # 3o

        a       $pair_9,$pair_8,$k_next                 # 4e
        lqd     $more_4,16($pair_8)                     # 4o

        fnms    $s2_11,$cx,$dx+2,$limit                 # 5e
        lqd     $quad_8,0($pair_8)                      # 5o

        a       $pair_10,$pair_9,$k_next                # 6e
        lqd     $quad_9,0($pair_9)                      # 6o

        fnms    $s_11,$cx,$dx,$limit                    # 7e
        lqd     $more_10,16($pair_9)                    # 7o

        fnms    $s3_11,$cx,$dx+3,$limit                 # 8e
        shufb   $limit_7,$more_9,$more_9,$m_limit       # 8o

        fnms    $s1_12,$cx,$dx+1,$limit                 # 9e
        shufb   $cx_7,$quad_7,$quad_7,$m_x              # 9o

        fnms    $s2_7,$cz_6,$dz+2,$s2_7                 # 10e
        lqd     $quad_10,0($pair_10)                    # 10o

        fnms    $s3_3,$cz_6,$dz+3,$s3_8                 # 11e
        lqd     $more_11,16($pair_10)                   # 11o

        fnms    $s3_6,$cz_2,$dz+3,$s3_6                 # 12e
        shufb   $limit_4,$more_4,$more_4,$m_limit       # 12o

        fnms    $s2_12,$cx_7,$dx+2,$limit_7             # 13e
        shufb   $cx_8,$quad_8,$quad_8,$m_x              # 13o

        fnms    $s1_13,$cx_7,$dx+1,$limit_7             # 14e
        shufb   $cy_8,$quad_4,$quad_4,$m_y              # 14o

        fnms    $s_12,$cx_7,$dx,$limit_7                # 15e
        shufb   $cx_9,$quad_9,$quad_9,$m_x              # 15o

        fnms    $s3_12,$cx_7,$dx+3,$limit_7             # 16e
        shufb   $limit,$more_10,$more_10,$m_limit       # 16o

        fnms    $s1_14,$cx_8,$dx+1,$limit_4             # 17e
        shufb   $cy_9,$quad_7,$quad_7,$m_y              # 17o

        fnms    $s_13,$cx_8,$dx,$limit_4                # 18e
        shufb   $cx_10,$quad_10,$quad_10,$m_x           # 18o

        fnms    $s2_13,$cx_8,$dx+2,$limit_4             # 19e
        shufb   $limit_8,$more_11,$more_11,$m_limit     # 19o

        fnms    $s3_13,$cx_8,$dx+3,$limit_4             # 20e
        shufb   $cy_10,$quad_8,$quad_8,$m_y             # 20o

        fnms    $s2_11,$cy_8,$dy+2,$s2_11               # 21e
        shufb   $cz_7,$quad_4,$quad_4,$m_z              # 21o

        fnms    $s_11,$cy_8,$dy,$s_11                   # 22e
        shufb   $cy_11,$quad_9,$quad_9,$m_y             # 22o

        fnms    $s3_11,$cy_8,$dy+3,$s3_11               # 23e
        shufb   $cz,$quad_7,$quad_7,$m_z                # 23o

        fnms    $s1_12,$cy_8,$dy+1,$s1_12               # 24e
        shufb   $cy_12,$quad_10,$quad_10,$m_y           # 24o

        fnms    $s3_14,$cx_9,$dx+3,$limit               # 25e
        shufb   $cz_8,$quad_8,$quad_8,$m_z              # 25o

        fnms    $s1_15,$cx_9,$dx+1,$limit               # 26e
        shufb   $signs_10,$s,$s+1,$m_signs              # 26o

        fnms    $s2_14,$cx_9,$dx+2,$limit               # 27e
        shufb   $signs_low_4,$s2_7,$s3_3,$m_signs       # 27o

        fnms    $s_14,$cx_9,$dx,$limit                  # 28e
        shufb   $cz_9,$quad_9,$quad_9,$m_z              # 28o

        fnms    $s2_15,$cy_9,$dy+2,$s2_12               # 29e
        shufb   $cz_10,$quad_10,$quad_10,$m_z           # 29o

        fnms    $s1_16,$cy_9,$dy+1,$s1_13               # 30e
        rotqbii $signs,$signs,1                         # 30o signs to the bytes' last bits

        fnms    $s_15,$cy_9,$dy,$s_12                   # 31e
        shufb   $signs_7,$signs_10,$signs_low_4,$m_halves # 31o

        fnms    $s3_12,$cy_9,$dy+3,$s3_12               # 32e
        fnms    $s2_16,$cx_10,$dx+2,$limit_8            # 33e

        fnms    $s_16,$cx_10,$dx,$limit_8               # 34e
        gbb     $signs,$signs                           # 34o

        fnms    $s3_15,$cx_10,$dx+3,$limit_8            # 35e
        rotqbii $signs_7,$signs_7,1                     # 35o signs to the bytes' last bits

        fnms    $s1_11,$cx_10,$dx+1,$limit_8            # 36e
        fnms    $s1_17,$cz_2,$dz+1,$s1_10               # 37e

        fnms    $s+2,$cz_2,$dz+2,$s+2                   # 38e
        lnop                                            # 38o pairing

        fnms    $s,$cz_2,$dz,$s_10                      # 39e
        gbb     $signs_7,$signs_7                       # 39o

        fnms    $s_10,$cy_10,$dy,$s_13                  # 40e
        fnms    $s1_10,$cy_10,$dy+1,$s1_14              # 41e

        fnms    $s3_13,$cy_10,$dy+3,$s3_13              # 42e
        fnms    $s2_17,$cy_10,$dy+2,$s2_13              # 43e

        fnms    $s2_5,$cz_7,$dz+2,$s2_11                # 44e
        shufb   $signs_low_5,$s+2,$s3_6,$m_signs        # 44o

        fnms    $s_17,$cz_7,$dz,$s_11                   # 45e
        shufb   $signs_11,$s,$s1_17,$m_signs            # 45o

        fnms    $s3_16,$cz_7,$dz+3,$s3_11               # 46e
        fnms    $s1_12,$cz_7,$dz+1,$s1_12               # 47e

        fnms    $s3_17,$cy_11,$dy+3,$s3_14              # 48e
        lnop                                            # 48o pairing

        fnms    $s1_18,$cy_11,$dy+1,$s1_15              # 49e
        shufb   $signs_11,$signs_11,$signs_low_5,$m_halves # 49o

        fnms    $s2_3,$cy_11,$dy+2,$s2_14               # 50e
        fnms    $s_14,$cy_11,$dy,$s_14                  # 51e

        fnms    $s2_14,$cz,$dz+2,$s2_15                 # 52e
        shufb   $signs_low_6,$s2_5,$s3_16,$m_signs      # 52o

        fnms    $s1_2,$cz,$dz+1,$s1_16                  # 53e
        shufb   $signs_12,$s_17,$s1_12,$m_signs         # 53o

        fnms    $s_17,$cz,$dz,$s_15                     # 54e
        rotqbii $signs_11,$signs_11,1                   # 54o signs to the bytes' last bits

        fnms    $s3_12,$cz,$dz+3,$s3_12                 # 55e
        fnms    $s2_16,$cy_12,$dy+2,$s2_16              # 56e

        fnms    $s_16,$cy_12,$dy,$s_16                  # 57e
        shufb   $signs_13,$signs_12,$signs_low_6,$m_halves # 57o

        fnms    $s3_15,$cy_12,$dy+3,$s3_15              # 58e
        gbb     $signs_11,$signs_11                     # 58o

        fnms    $s1_11,$cy_12,$dy+1,$s1_11              # 59e
        lnop                                            # 59o pairing

        fnms    $s_10,$cz_8,$dz,$s_10                   # 60e
        shufb   $signs_14,$s_17,$s1_2,$m_signs          # 60o

        fnms    $s1_10,$cz_8,$dz+1,$s1_10               # 61e
        shufb   $signs_low_7,$s2_14,$s3_12,$m_signs     # 61o

        fnms    $s2_17,$cz_8,$dz+2,$s2_17               # 62e
        rotqbii $signs_13,$signs_13,1                   # 62o signs to the bytes' last bits

        fnms    $s3_13,$cz_8,$dz+3,$s3_13               # 63e
        fnms    $s3_18,$cz_9,$dz+3,$s3_17               # 64e

        fnms    $s+1,$cz_9,$dz+1,$s1_18                 # 65e
        shufb   $signs_14,$signs_14,$signs_low_7,$m_halves # 65o

        fnms    $s+2,$cz_9,$dz+2,$s2_3                  # 66e
        gbb     $signs_13,$signs_13                     # 66o

        fnms    $s,$cz_9,$dz,$s_14                      # 67e
        shufb   $signs_5,$s_10,$s1_10,$m_signs          # 67o

        fnms    $s2_10,$cz_10,$dz+2,$s2_16              # 68e
        lnop                                            # 68o pairing

        fnms    $s_18,$cz_10,$dz,$s_16                  # 69e
        shufb   $signs_low,$s2_17,$s3_13,$m_signs       # 69o

        fnms    $s3_13,$cz_10,$dz+3,$s3_15              # 70e
        rotqbii $signs_14,$signs_14,1                   # 70o signs to the bytes' last bits

        fnms    $s1_11,$cz_10,$dz+1,$s1_11              # 71e
        lnop                                            # 71o pairing

        cg      $c_any,$signs_8,$k_all                  # 72e 1 if any, else 0
        shufb   $signs_low_8,$s+2,$s3_18,$m_signs       # 72o

        cg      $c_any_4,$signs,$k_all                  # 73e 1 if any, else 0
        shufb   $signs_15,$s,$s+1,$m_signs              # 73o

        a       $found,$found_2,$c_any                  # 74e
        shufb   $signs_5,$signs_5,$signs_low,$m_halves  # 74o

        cg      $c_any,$signs_7,$k_all                  # 75e 1 if any, else 0
        gbb     $signs,$signs_14                        # 75o

        a       $found_4,$found,$c_any_4                # 76e
        shufb   $signs_low,$s2_10,$s3_13,$m_signs       # 76o

        cg      $c_any_5,$signs_11,$k_all               # 77e 1 if any, else 0
        shufb   $signs_3,$s_18,$s1_11,$m_signs          # 77o

        a       $found_5,$found_4,$c_any                # 78e
        shufb   $signs_11,$signs_15,$signs_low_8,$m_halves # 78o

        cg      $c_any,$signs_13,$k_all                 # 79e 1 if any, else 0
        shlqbii $offset,$found,4                        # 79o

        a       $found_2,$found_5,$c_any_5              # 80e
        rotqbii $signs_5,$signs_5,1                     # 80o signs to the bytes' last bits

        cg      $c_any_6,$signs,$k_all                  # 81e 1 if any, else 0
        shufb   $signs,$signs_3,$signs_low,$m_halves    # 81o

        a       $found,$found_2,$c_any                  # 82e
        rotqbii $signs_3,$signs_11,1                    # 82o signs to the bytes' last bits

        a       $pair_11,$pair_10,$k_next               # 83e
        stqx    $pair,$a_pairs,$offset                  # 83o

        a       $found_6,$found,$c_any_6                # 84e
        gbb     $signs_5,$signs_5                       # 84o

        rotqbii $signs,$signs,1                         # 85o signs to the bytes' last bits
        hbr     filter_spheres_r16_return,$lr           # 86o hint

        nop     $127                                    # 87e pairing
        gbb     $signs_3,$signs_3                       # 87o

        cg      $c_any,$signs_5,$k_all                  # 88e 1 if any, else 0
        shlqbii $offset,$found_4,4                      # 88o

        nop     $127                                    # 89e pairing
        gbb     $signs_8,$signs                         # 89o

        a       $found_4,$found_6,$c_any                # 90e
        shlqbii $offset_3,$found_5,4                    # 90o

        cg      $c_any,$signs_3,$k_all                  # 91e 1 if any, else 0
        shlqbii $offset_4,$found_2,4                    # 91o

        nop     $127                                    # 92e pairing
        shlqbii $offset_5,$found,4                      # 92o

        a       $found_5,$found_4,$c_any                # 93e
        stqx    $pair_5,$a_pairs,$offset                # 93o

        cg      $c_any,$signs_8,$k_all                  # 94e 1 if any, else 0
        shlqbii $offset,$found_6,4                      # 94o

        nop     $127                                    # 95e pairing
        stqx    $pair_6,$a_pairs,$offset_3              # 95o

        a       $found,$found_5,$c_any                  # 96e
        shlqbii $offset_6,$found_4,4                    # 96o

        nop     $127                                    # 97e pairing
        stqx    $pair_7,$a_pairs,$offset_4              # 97o

        shli    $found,$found,4                         # 98e
        shlqbii $offset_3,$found_5,4                    # 98o

        stqx    $pair_2,$a_pairs,$offset_5              # 99o
        stqx    $pair_8,$a_pairs,$offset                # 100o

        nop     $127                                    # 101e pairing
        stqx    $pair_9,$a_pairs,$offset_6              # 101o

        a       $a_packet,$a_pairs,$found               # 102e
        stqx    $pair_10,$a_pairs,$offset_3             # 102o

        nop     $127                                    # 103e pairing
filter_spheres_r16_return:
        bi      $lr                                     # 103o

next_four_short:
        a       $pair_2,$pair,$k_next                   # 0e
        lqd     $quad,0($pair)                          # 0o

        ai      $fours,$fours,-1                        # 1e
        lqd     $more,16($pair)                         # 1o

        a       $pair_3,$pair_2,$k_next                 # 2e
        lqd     $quad_11,0($pair_2)                     # 2o

        nop     $127                                    # 3e pairing
        lqd     $more_12,16($pair_2)                    # 3o

        a       $pair_12,$pair_3,$k_next                # 4e
        lqd     $quad_12,0($pair_3)                     # 4o

        lqd     $more_13,16($pair_3)                    # 5o
        shufb   $cx,$quad,$quad,$m_x                    # 6o

        shufb   $limit,$more,$more,$m_limit             # 7o
        shufb   $cx_2,$quad_11,$quad_11,$m_x            # 8o

        shufb   $limit_9,$more_12,$more_12,$m_limit     # 9o
        shufb   $cx_11,$quad_12,$quad_12,$m_x           # 10o

        fnms    $s,$cx,$dx,$limit                       # 11e
        shufb   $limit_10,$more_13,$more_13,$m_limit    # 11o

        fnms    $s+1,$cx,$dx+1,$limit                   # 12e
        shufb   $cy,$quad,$quad,$m_y                    # 12o

        fnms    $s+2,$cx,$dx+2,$limit                   # 13e
        lqd     $quad_7,0($pair_12)                     # 13o

        fnms    $s+3,$cx,$dx+3,$limit                   # 14e
        lqd     $more_14,16($pair_12)                   # 14o

        fnms    $s_19,$cx_2,$dx,$limit_9                # 15e
        shufb   $cy_13,$quad_11,$quad_11,$m_y           # 15o

        fnms    $s1_8,$cx_2,$dx+1,$limit_9              # 16e
        shufb   $cy_10,$quad_12,$quad_12,$m_y           # 16o

        fnms    $s2_11,$cx_2,$dx+2,$limit_9             # 17e
        shufb   $cz_2,$quad,$quad,$m_z                  # 17o

        fnms    $s3_19,$cx_2,$dx+3,$limit_9             # 18e
        shufb   $cz_6,$quad_11,$quad_11,$m_z            # 18o

        fnms    $s_20,$cx_11,$dx,$limit_10              # 19e
        shufb   $cx_12,$quad_7,$quad_7,$m_x             # 19o

        fnms    $s1_19,$cx_11,$dx+1,$limit_10           # 20e
        shufb   $limit_6,$more_14,$more_14,$m_limit     # 20o

        fnms    $s2_18,$cx_11,$dx+2,$limit_10           # 21e
        shufb   $cz_5,$quad_12,$quad_12,$m_z            # 21o

        fnms    $s3_10,$cx_11,$dx+3,$limit_10           # 22e
        shufb   $cy_14,$quad_7,$quad_7,$m_y             # 22o

        fnms    $s,$cy,$dy,$s                           # 23e
        shufb   $cz,$quad_7,$quad_7,$m_z                # 23o

        fnms    $s+1,$cy,$dy+1,$s+1                     # 24e
        shlqbii $offset_7,$found,4                      # 24o

        fnms    $s+2,$cy,$dy+2,$s+2                     # 25e
        fnms    $s+3,$cy,$dy+3,$s+3                     # 26e

        fnms    $s_21,$cy_13,$dy,$s_19                  # 27e
        lnop                                            # 27o pairing

        fnms    $s1_20,$cy_13,$dy+1,$s1_8               # 28e
        stqx    $pair,$a_pairs,$offset_7                # 28o

        fnms    $s2_19,$cy_13,$dy+2,$s2_11              # 29e
        fnms    $s3_19,$cy_13,$dy+3,$s3_19              # 30e

        fnms    $s_20,$cy_10,$dy,$s_20                  # 31e
        fnms    $s1_21,$cy_10,$dy+1,$s1_19              # 32e

        fnms    $s2_20,$cy_10,$dy+2,$s2_18              # 33e
        fnms    $s3_10,$cy_10,$dy+3,$s3_10              # 34e

        fnms    $s,$cz_2,$dz,$s                         # 35e
        fnms    $s+1,$cz_2,$dz+1,$s+1                   # 36e

        fnms    $s+2,$cz_2,$dz+2,$s+2                   # 37e
        fnms    $s+3,$cz_2,$dz+3,$s+3                   # 38e

        fnms    $s_22,$cx_12,$dx,$limit_6               # 39e
        fnms    $s1_18,$cx_12,$dx+1,$limit_6            # 40e

        fnms    $s2_11,$cx_12,$dx+2,$limit_6            # 41e
        lnop                                            # 41o pairing

        fnms    $s3_2,$cx_12,$dx+3,$limit_6             # 42e
        shufb   $signs_10,$s,$s+1,$m_signs              # 42o

        fnms    $s_21,$cz_6,$dz,$s_21                   # 43e
        lnop                                            # 43o pairing

        fnms    $s+1,$cz_6,$dz+1,$s1_20                 # 44e
        shufb   $signs_low_9,$s+2,$s+3,$m_signs         # 44o

        fnms    $s+2,$cz_6,$dz+2,$s2_19                 # 45e
        fnms    $s+3,$cz_6,$dz+3,$s3_19                 # 46e

        fnms    $s_14,$cz_5,$dz,$s_20                   # 47e
        lnop                                            # 47o pairing

        fnms    $s1_5,$cz_5,$dz+1,$s1_21                # 48e
        shufb   $signs,$signs_10,$signs_low_9,$m_halves # 48o

        fnms    $s2_21,$cz_5,$dz+2,$s2_20               # 49e
        lnop                                            # 49o pairing

        fnms    $s3_9,$cz_5,$dz+3,$s3_10                # 50e
        shufb   $signs_16,$s_21,$s+1,$m_signs           # 50o

        fnms    $s,$cy_14,$dy,$s_22                     # 51e
        lnop                                            # 51o pairing

        fnms    $s+1,$cy_14,$dy+1,$s1_18                # 52e
        shufb   $signs_low,$s+2,$s+3,$m_signs           # 52o

        fnms    $s+2,$cy_14,$dy+2,$s2_11                # 53e
        rotqbii $signs,$signs,1                         # 53o signs to the bytes' last bits

        fnms    $s+3,$cy_14,$dy+3,$s3_2                 # 54e
        shufb   $signs_5,$s_14,$s1_5,$m_signs           # 54o

        a       $pair,$pair_12,$k_next                  # 55e
        shufb   $signs_low_10,$s2_21,$s3_9,$m_signs     # 56o

        fnms    $s,$cz,$dz,$s                           # 57e
        shufb   $signs_17,$signs_16,$signs_low,$m_halves # 57o

        fnms    $s+1,$cz,$dz+1,$s+1                     # 58e
        gbb     $signs,$signs                           # 58o

        fnms    $s+2,$cz,$dz+2,$s+2                     # 59e
        lnop                                            # 59o pairing

        fnms    $s+3,$cz,$dz+3,$s+3                     # 60e
        shufb   $signs_5,$signs_5,$signs_low_10,$m_halves # 60o

        rotqbii $signs_4,$signs_17,1                    # 61o signs to the bytes' last bits
        cg      $c_any,$signs,$k_all                    # 62e 1 if any, else 0

        a       $found,$found,$c_any                    # 64e
        rotqbii $signs,$signs_5,1                       # 64o signs to the bytes' last bits

        shufb   $signs_5,$s,$s+1,$m_signs               # 65o
        shufb   $signs_low,$s+2,$s+3,$m_signs           # 66o

        gbb     $signs_4,$signs_4                       # 67o
        gbb     $signs,$signs                           # 68o

        shlqbii $offset,$found,4                        # 69o
        shufb   $signs_5,$signs_5,$signs_low,$m_halves  # 70o

        cg      $c_any,$signs_4,$k_all                  # 71e 1 if any, else 0
        cg      $c_any_5,$signs,$k_all                  # 72e 1 if any, else 0

        a       $found,$found,$c_any                    # 73e
        stqx    $pair_2,$a_pairs,$offset                # 73o

        nop     $127                                    # 74e pairing
        rotqbii $signs,$signs_5,1                       # 74o signs to the bytes' last bits

        a       $found_7,$found,$c_any_5                # 75e
        shlqbii $offset,$found,4                        # 75o

        shlqbii $offset_3,$found_7,4                    # 77o
        gbb     $signs,$signs                           # 78o

        stqx    $pair_3,$a_pairs,$offset                # 79o
        stqx    $pair_12,$a_pairs,$offset_3             # 81o

        cg      $c_any,$signs,$k_all                    # 82e 1 if any, else 0
        lnop                                            # 82o pairing

        a       $found,$found_7,$c_any                  # 84e
        brnz    $fours,next_four_short                  # 84o

        shli    $found,$found,4                         # 86e
        lnop                                            # 86o pairing

        a       $a_packet,$a_pairs,$found               # 90e
        bi      $lr                                     # 90o
endfunction filter_spheres_r16
