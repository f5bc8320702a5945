# cull_spheres_p16   which of sixteen packets some eye ray may enter a sphere from, sphere by sphere
#   C       void cull_spheres_p16(const struct packet *, const struct pair *, int count,
#                                 unsigned *);
#   In      $3 the middle directions of sixteen packets, as a packet; $4 list whose entries' first
#           words are the addresses of spheres; $5 count (at least 1); $6 where masks go, a word in
#           every fourth; the other pointers 16-aligned
#   Out     a mask a sphere: 16 bits, the highest of packet 0
#   Uses    $4-$6, $10-$61   Saves  -   Stack  0   Calls  -
#   Domain  |d| = 1 within 4 ulp; limits as the PPU makes them
#   Error   0: no packet is left out a ray of which enters
#   Twin    oracle/src/twin/cull.rs
#
# As filter_spheres_r16, with the cone of the sphere widened by that of a packet.
# Scheduled by spu schedule from cull_spheres_p16.s

        .include "work_unit.inc"
        .include "macros.inc"

        .set    a_middles,3
        .set    a_list,4
        .set    count,5
        .set    a_mask,6
        # constants
        .set    m_x,10
        .set    m_y,11
        .set    m_z,12
        .set    m_limit,13
        .set    m_signs,14                              # top bytes of two quadwords' words
        .set    m_halves,15                             # packets 15, 0 to 14: see the rotation
        .set    m_word,16
        # the middles
        .set    dx,20
        .set    dy,24
        .set    dz,28
        # the sphere
        .set    a_sphere,34
        .set    quad,35
        .set    more,36
        .set    cx,37
        .set    cy,38
        .set    cz,39
        .set    limit,40
        # temporaries
        .set    s,41                                    # to 44
        .set    signs,45
        .set    signs_low,46
        .set    masks,47

        .section .rodata
        .align  4
signs_of_two:
        .int    0x0004080c,0x1014181c,0x0004080c,0x1014181c
halves: .int    0x17000102,0x03040506,0x07101112,0x13141516

function cull_spheres_p16
        .set    count_2,79
        .set    a_list_2,2
        .set    a_sphere_2,2
        .set    a_list_3,3
        .set    a_sphere_3,7
        .set    more_2,8
        .set    quad_2,2
        .set    more_3,9
        .set    quad_3,7
        .set    cy_2,17
        .set    cz_2,18
        .set    limit_2,8
        .set    cx_2,19
        .set    s1_2,32
        .set    cy_3,33
        .set    cz_3,35
        .set    s2_2,2
        .set    s1_3,9
        .set    s_2,3
        .set    s3_2,7
        .set    s2_3,8
        .set    s_3,17
        .set    s3_3,18
        .set    s1_4,19
        .set    s2_4,3
        .set    s_4,2
        .set    s3_4,8
        .set    signs_2,7
        .set    signs_3,2
        .set    a_mask_2,2
        .set    signs_4,3
        .set    s2_5,4
        .set    cz_4,3
        .set    s_5,5
        .set    s_6,6
        .set    s3_5,10
        .set    a_mask_3,5
        .set    a_mask_4,3
        ilhu    $m_x,1                                  # 0e
        lqa     $m_signs,signs_of_two                   # 0o

        ilhu    $m_y,0x405                              # 1e
        lqa     $m_halves,halves                        # 1o

        ilhu    $m_z,0x809                              # 2e
        lqd     $dx,0($a_middles)                       # 2o

        ilhu    $m_limit,0x809                          # 3e
        lqd     $dy,64($a_middles)                      # 3o

        clgti   $count_2,$count,4                       # 4e at least as many passes as overlap
        lqd     $dz,128($a_middles)                     # 4o

        iohl    $m_x,515                                # 5e
        lqd     $dx+1,16($a_middles)                    # 5o

        iohl    $m_y,0x607                              # 6e
        lqd     $dy+1,80($a_middles)                    # 6o

        iohl    $m_z,0xa0b                              # 7e
        lqd     $dz+1,144($a_middles)                   # 7o

        iohl    $m_limit,0xa0b                          # 8e
        lqd     $dx+2,32($a_middles)                    # 8o

        lqd     $dy+2,96($a_middles)                    # 9o
        lqd     $dz+2,160($a_middles)                   # 10o

        lqd     $dx+3,48($a_middles)                    # 11o
        lqd     $dy+3,112($a_middles)                   # 12o

        lqd     $dz+3,176($a_middles)                   # 13o
        cwd     $m_word,0($a_mask)                      # 14o

        nop     $127                                    # 15e pairing
        brz     $count_2,next_sphere_short              # 15o too few passes

        ai      $a_list_2,$a_list,16                    # 16e
        lqd     $a_sphere,0($a_list)                    # 16o

        ai      $count,$count,-1                        # 17e
        hbrr    next_sphere_back,next_sphere            # 17o hint

        ai      $a_list,$a_list_2,16                    # 18e
        lqd     $a_sphere_2,0($a_list_2)                # 18o

        ai      $count,$count,-1                        # 19e
        lnop                                            # 19o pairing

        ai      $a_list_3,$a_list,16                    # 20e
        lqd     $a_sphere_3,0($a_list)                  # 20o

        ai      $count,$count,-1                        # 21e
        lnop                                            # 21o pairing

        ai      $a_list,$a_list_3,16                    # 22e
        lqd     $more,16($a_sphere)                     # 22o

        ai      $count,$count,-1                        # 23e
        lqd     $quad,0($a_sphere)                      # 23o

        lqd     $more_2,16($a_sphere_2)                 # 24o
        lqd     $quad_2,0($a_sphere_2)                  # 25o

        lqd     $more_3,16($a_sphere_3)                 # 26o
        lqd     $quad_3,0($a_sphere_3)                  # 27o

        shufb   $limit,$more,$more,$m_limit             # 28o
        shufb   $cx,$quad,$quad,$m_x                    # 29o

        shufb   $cy_2,$quad,$quad,$m_y                  # 30o
        shufb   $cz_2,$quad,$quad,$m_z                  # 31o

        nop     $127                                    # 32e pairing
        shufb   $limit_2,$more_2,$more_2,$m_limit       # 32o

        fnms    $s+2,$cx,$dx+2,$limit                   # 33e
        shufb   $cx_2,$quad_2,$quad_2,$m_x              # 33o

        fnms    $s1_2,$cx,$dx+1,$limit                  # 34e
        shufb   $cy_3,$quad_2,$quad_2,$m_y              # 34o

        fnms    $s,$cx,$dx,$limit                       # 35e
        lqd     $a_sphere,0($a_list_3)                  # 35o

        fnms    $s+3,$cx,$dx+3,$limit                   # 36e
        shufb   $cz_3,$quad_2,$quad_2,$m_z              # 36o

        fnms    $s2_2,$cx_2,$dx+2,$limit_2              # 37e
        shufb   $limit,$more_3,$more_3,$m_limit         # 37o

        fnms    $s1_3,$cx_2,$dx+1,$limit_2              # 38e
        shufb   $cx,$quad_3,$quad_3,$m_x                # 38o

        fnms    $s+2,$cy_2,$dy+2,$s+2                   # 39e
        shufb   $cy,$quad_3,$quad_3,$m_y                # 39o

        fnms    $s+1,$cy_2,$dy+1,$s1_2                  # 40e
        shufb   $cz,$quad_3,$quad_3,$m_z                # 40o

        fnms    $s,$cy_2,$dy,$s                         # 41e
        lqd     $more,16($a_sphere)                     # 41o

        fnms    $s+3,$cy_2,$dy+3,$s+3                   # 42e
        fnms    $s_2,$cx_2,$dx,$limit_2                 # 43e

        fnms    $s3_2,$cx_2,$dx+3,$limit_2              # 44e
        fnms    $s2_3,$cz_2,$dz+2,$s+2                  # 45e

        fnms    $s+1,$cz_2,$dz+1,$s+1                   # 46e
        fnms    $s_3,$cz_2,$dz,$s                       # 47e

        fnms    $s3_3,$cz_2,$dz+3,$s+3                  # 48e
        fnms    $s2_2,$cy_3,$dy+2,$s2_2                 # 49e

        fnms    $s1_4,$cy_3,$dy+1,$s1_3                 # 50e
        fnms    $s,$cy_3,$dy,$s_2                       # 51e

        fnms    $s+3,$cy_3,$dy+3,$s3_2                  # 52e
        lnop                                            # 52o pairing

        fnms    $s+2,$cx,$dx+2,$limit                   # 53e
        shufb   $signs,$s_3,$s+1,$m_signs               # 53o

        fnms    $s1_3,$cx,$dx+1,$limit                  # 54e
        shufb   $signs_low,$s2_3,$s3_3,$m_signs         # 54o

        fnms    $s2_4,$cz_3,$dz+2,$s2_2                 # 55e
        fnms    $s+1,$cz_3,$dz+1,$s1_4                  # 56e

        fnms    $s_4,$cz_3,$dz,$s                       # 57e
        lnop                                            # 57o pairing

        fnms    $s3_4,$cz_3,$dz+3,$s+3                  # 58e
        shufb   $signs,$signs,$signs_low,$m_halves      # 58o

        nop     $127                                    # 59e pairing
        rotqbii $signs_2,$signs,1                       # 62o the sign of byte k to the end of byte

next_sphere:
            fnms    $s,$cx,$dx,$limit                   # 0e
            lqd     $quad,0($a_sphere)                  # 0o

            fnms    $s+3,$cx,$dx+3,$limit               # 1e
            lqd     $masks,0($a_mask)                   # 1o

            fnms    $s+2,$cy,$dy+2,$s+2                 # 2e
            shufb   $signs,$s_4,$s+1,$m_signs           # 2o

        ai      $count,$count,-1                        # 3e
            shufb   $signs_low,$s2_4,$s3_4,$m_signs     # 3o

            fnms    $s+1,$cy,$dy+1,$s1_3                # 4e
            shufb   $limit,$more,$more,$m_limit         # 4o

        nop     $127                                    # 5e pairing
        lqd     $a_sphere,0($a_list)                    # 5o

            fnms    $s,$cy,$dy,$s                       # 6e
            gbb     $signs_3,$signs_2                   # 6o

            fnms    $s+3,$cy,$dy+3,$s+3                 # 7e
            shufb   $cx,$quad,$quad,$m_x                # 7o

        ai      $a_list,$a_list,16                      # 8e
            shufb   $signs,$signs,$signs_low,$m_halves  # 8o

            fnms    $s2_4,$cz,$dz+2,$s+2                # 9e
            shufb   $cy,$quad,$quad,$m_y                # 9o

            fnms    $s+1,$cz,$dz+1,$s+1                 # 10e
            shufb   $masks,$signs_3,$masks,$m_word      # 10o

            fnms    $s+2,$cx,$dx+2,$limit               # 11e
        lqd     $more,16($a_sphere)                     # 11o

            fnms    $s_4,$cz,$dz,$s                     # 12e
            rotqbii $signs_2,$signs,1                   # 12o the sign of byte k to the end of byte

            fnms    $s3_4,$cz,$dz+3,$s+3                # 13e
            shufb   $cz,$quad,$quad,$m_z                # 13o

            fnms    $s1_3,$cx,$dx+1,$limit              # 14e
            stqd    $masks,0($a_mask)                   # 14o

            ai      $a_mask,$a_mask,16                  # 15e
next_sphere_back:
        brnz    $count,next_sphere                      # 15o

next_sphere_drain:
        fnms    $s,$cx,$dx,$limit                       # 0e
        lqd     $quad,0($a_sphere)                      # 0o

        fnms    $s+3,$cx,$dx+3,$limit                   # 1e
        lqd     $masks,0($a_mask)                       # 1o

        fnms    $s+2,$cy,$dy+2,$s+2                     # 2e
        shufb   $signs,$s_4,$s+1,$m_signs               # 2o

        fnms    $s+1,$cy,$dy+1,$s1_3                    # 3e
        shufb   $signs_low,$s2_4,$s3_4,$m_signs         # 3o

        ai      $a_mask_2,$a_mask,16                    # 4e
        shufb   $limit,$more,$more,$m_limit             # 4o

        nop     $127                                    # 5e pairing
        gbb     $signs_4,$signs_2                       # 5o

        fnms    $s,$cy,$dy,$s                           # 6e
        shufb   $cx,$quad,$quad,$m_x                    # 6o

        fnms    $s+3,$cy,$dy+3,$s+3                     # 7e
        shufb   $signs,$signs,$signs_low,$m_halves      # 7o

        fnms    $s2_5,$cz,$dz+2,$s+2                    # 8e
        shufb   $cy,$quad,$quad,$m_y                    # 8o

        fnms    $s+1,$cz,$dz+1,$s+1                     # 9e
        shufb   $masks,$signs_4,$masks,$m_word          # 9o

        fnms    $s+2,$cx,$dx+2,$limit                   # 10e
        shufb   $cz_4,$quad,$quad,$m_z                  # 10o

        fnms    $s1_3,$cx,$dx+1,$limit                  # 11e
        rotqbii $signs_2,$signs,1                       # 11o the sign of byte k to the end of byte

        fnms    $s_5,$cx,$dx,$limit                     # 12e
        hbr     cull_spheres_p16_return,$lr             # 12o hint

        fnms    $s3_4,$cx,$dx+3,$limit                  # 13e
        stqd    $masks,0($a_mask)                       # 13o

        fnms    $s_6,$cz,$dz,$s                         # 14e
        lqd     $masks,0($a_mask_2)                     # 14o

        fnms    $s3_5,$cz,$dz+3,$s+3                    # 15e
        gbb     $signs_2,$signs_2                       # 15o

        fnms    $s+2,$cy,$dy+2,$s+2                     # 16e
        fnms    $s1_3,$cy,$dy+1,$s1_3                   # 17e

        fnms    $s,$cy,$dy,$s_5                         # 18e
        fnms    $s+3,$cy,$dy+3,$s3_4                    # 19e

        ai      $a_mask_3,$a_mask_2,16                  # 20e
        shufb   $signs,$s_6,$s+1,$m_signs               # 20o

        nop     $127                                    # 21e pairing
        shufb   $signs_low,$s2_5,$s3_5,$m_signs         # 21o

        fnms    $s2_5,$cz_4,$dz+2,$s+2                  # 22e
        shufb   $masks,$signs_2,$masks,$m_word          # 22o

        fnms    $s+1,$cz_4,$dz+1,$s1_3                  # 23e
        fnms    $s_6,$cz_4,$dz,$s                       # 24e

        fnms    $s3_4,$cz_4,$dz+3,$s+3                  # 25e
        shufb   $signs,$signs,$signs_low,$m_halves      # 25o

        ai      $a_mask_4,$a_mask_3,16                  # 26e
        stqd    $masks,0($a_mask_2)                     # 26o

        lqd     $masks,0($a_mask_3)                     # 27o
        ai      $a_mask_2,$a_mask_4,16                  # 28e

        rotqbii $signs_2,$signs,1                       # 29o the sign of byte k to the end of byte
        shufb   $signs,$s_6,$s+1,$m_signs               # 30o

        shufb   $signs_low,$s2_5,$s3_4,$m_signs         # 31o
        gbb     $signs_3,$signs_2                       # 33o

        shufb   $signs,$signs,$signs_low,$m_halves      # 35o
        shufb   $masks,$signs_3,$masks,$m_word          # 37o

        rotqbii $signs_2,$signs,1                       # 39o the sign of byte k to the end of byte
        stqd    $masks,0($a_mask_3)                     # 41o

        lqd     $masks,0($a_mask_4)                     # 42o
        gbb     $signs_3,$signs_2                       # 43o

        shufb   $masks,$signs_3,$masks,$m_word          # 48o
        stqd    $masks,0($a_mask_4)                     # 52o

        nop     $127                                    # 53e pairing
cull_spheres_p16_return:
        bi      $lr                                     # 53o

next_sphere_short:
        ai      $count,$count,-1                        # 0e
        lqd     $a_sphere,0($a_list)                    # 0o

        ai      $a_list,$a_list,16                      # 1e
        lqd     $masks,0($a_mask)                       # 1o

        lqd     $quad,0($a_sphere)                      # 6o
        lqd     $more,16($a_sphere)                     # 7o

        shufb   $cx,$quad,$quad,$m_x                    # 12o
        shufb   $limit,$more,$more,$m_limit             # 13o

        shufb   $cy,$quad,$quad,$m_y                    # 14o
        shufb   $cz,$quad,$quad,$m_z                    # 15o

        fnms    $s,$cx,$dx,$limit                       # 17e
        fnms    $s+1,$cx,$dx+1,$limit                   # 18e

        fnms    $s+2,$cx,$dx+2,$limit                   # 19e
        fnms    $s+3,$cx,$dx+3,$limit                   # 20e

        fnms    $s,$cy,$dy,$s                           # 23e
        fnms    $s+1,$cy,$dy+1,$s+1                     # 24e

        fnms    $s+2,$cy,$dy+2,$s+2                     # 25e
        fnms    $s+3,$cy,$dy+3,$s+3                     # 26e

        fnms    $s,$cz,$dz,$s                           # 29e
        fnms    $s+1,$cz,$dz+1,$s+1                     # 30e

        fnms    $s+2,$cz,$dz+2,$s+2                     # 31e
        fnms    $s+3,$cz,$dz+3,$s+3                     # 32e

        shufb   $signs,$s,$s+1,$m_signs                 # 36o
        shufb   $signs_low,$s+2,$s+3,$m_signs           # 38o

        shufb   $signs,$signs,$signs_low,$m_halves      # 42o
        rotqbii $signs,$signs,1                         # 46o the sign of byte k to the end of byte

        gbb     $signs,$signs                           # 50o
        shufb   $masks,$signs,$masks,$m_word            # 54o

        nop     $127                                    # 55e pairing
        stqd    $masks,0($a_mask)                       # 58o

        ai      $a_mask,$a_mask,16                      # 59e
        brnz    $count,next_sphere_short                # 59o

        nop     $127                                    # 60e pairing
        bi      $lr                                     # 60o
endfunction cull_spheres_p16
