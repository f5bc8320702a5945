# cull_spheres_p16   which of sixteen packets some eye ray may enter a sphere from, sphere by sphere
#   C       void cull_spheres_p16(const struct packet *, const struct pair *, int count,
#                                 vec_uint4 *);
#   In      $3 the middle directions of sixteen packets, as a packet; $4 list whose entries' first
#           words are the addresses of spheres; $5 count (at least 1); $6 where masks go;
#           pointers 16-aligned
#   Out     a quadword a sphere: in its first word 16 bits, the highest of packet 0
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
        .set    limit_2,8
        .set    cx_2,16
        .set    cy_2,17
        .set    s3_2,18
        .set    cy_3,19
        .set    s2_2,32
        .set    cz_2,33
        .set    limit_3,34
        .set    s3_3,9
        .set    cz_3,2
        .set    s2_3,40
        .set    a_sphere_4,3
        .set    s1_2,7
        .set    s_2,8
        .set    s2_4,3
        .set    s1_3,16
        .set    s_3,17
        .set    s3_4,19
        .set    s2_5,9
        .set    signs_2,3
        .set    signs_3,2
        .set    s3_5,3
        .set    cz_4,3
        .set    a_mask_2,4
        .set    signs_4,5
        .set    s3_6,7
        .set    s1_4,2
        .set    s1_5,10
        .set    s_4,2
        .set    a_mask_3,3
        .set    signs_5,4
        .set    a_mask_4,5
        .set    signs_low_2,5
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
        brz     $count_2,next_sphere_short              # 14o too few passes

        ai      $a_list_2,$a_list,16                    # 15e
        lqd     $a_sphere,0($a_list)                    # 15o

        ai      $count,$count,-1                        # 16e
        hbrr    next_sphere_back,next_sphere            # 16o hint

        ai      $a_list,$a_list_2,16                    # 17e
        lqd     $a_sphere_2,0($a_list_2)                # 17o

        ai      $count,$count,-1                        # 18e
        lnop                                            # 18o pairing

        ai      $a_list_3,$a_list,16                    # 19e
        lqd     $a_sphere_3,0($a_list)                  # 19o

        ai      $count,$count,-1                        # 20e
        lnop                                            # 20o pairing

        ai      $a_list,$a_list_3,16                    # 21e
        lqd     $more,16($a_sphere)                     # 21o

        ai      $count,$count,-1                        # 22e
        lqd     $quad,0($a_sphere)                      # 22o

        lqd     $more_2,16($a_sphere_2)                 # 23o
        lqd     $quad_2,0($a_sphere_2)                  # 24o

        lqd     $more_3,16($a_sphere_3)                 # 25o
        lqd     $quad_3,0($a_sphere_3)                  # 26o

        shufb   $limit,$more,$more,$m_limit             # 27o
        shufb   $cx,$quad,$quad,$m_x                    # 28o

        shufb   $limit_2,$more_2,$more_2,$m_limit       # 29o
        shufb   $cx_2,$quad_2,$quad_2,$m_x              # 30o

        nop     $127                                    # 31e pairing
        shufb   $cy_2,$quad,$quad,$m_y                  # 31o

        fnms    $s3_2,$cx,$dx+3,$limit                  # 32e
        shufb   $cy_3,$quad_2,$quad_2,$m_y              # 32o

        fnms    $s2_2,$cx,$dx+2,$limit                  # 33e
        shufb   $cz_2,$quad,$quad,$m_z                  # 33o

        fnms    $s+1,$cx,$dx+1,$limit                   # 34e
        shufb   $limit_3,$more_3,$more_3,$m_limit       # 34o

        fnms    $s,$cx,$dx,$limit                       # 35e
        shufb   $cx,$quad_3,$quad_3,$m_x                # 35o

        fnms    $s3_3,$cx_2,$dx+3,$limit_2              # 36e
        shufb   $cz_3,$quad_2,$quad_2,$m_z              # 36o

        fnms    $s2_3,$cx_2,$dx+2,$limit_2              # 37e
        lqd     $a_sphere_4,0($a_list_3)                # 37o

        fnms    $s3_2,$cy_2,$dy+3,$s3_2                 # 38e
        shufb   $cy,$quad_3,$quad_3,$m_y                # 38o

        fnms    $s+2,$cy_2,$dy+2,$s2_2                  # 39e
        shufb   $cz,$quad_3,$quad_3,$m_z                # 39o

        fnms    $s+1,$cy_2,$dy+1,$s+1                   # 40e
        fnms    $s,$cy_2,$dy,$s                         # 41e

        fnms    $s1_2,$cx_2,$dx+1,$limit_2              # 42e
        lnop                                            # 42o pairing

        fnms    $s_2,$cx_2,$dx,$limit_2                 # 43e
        lqd     $more,16($a_sphere_4)                   # 43o

        fnms    $s3_3,$cy_3,$dy+3,$s3_3                 # 44e
        lqd     $quad,0($a_sphere_4)                    # 44o

        fnms    $s2_4,$cy_3,$dy+2,$s2_3                 # 45e
        fnms    $s+3,$cz_2,$dz+3,$s3_2                  # 46e

        fnms    $s+2,$cz_2,$dz+2,$s+2                   # 47e
        fnms    $s1_3,$cz_2,$dz+1,$s+1                  # 48e

        fnms    $s_3,$cz_2,$dz,$s                       # 49e
        fnms    $s+1,$cy_3,$dy+1,$s1_2                  # 50e

        fnms    $s,$cy_3,$dy,$s_2                       # 51e
        fnms    $s3_2,$cx,$dx+3,$limit_3                # 52e

        fnms    $s3_4,$cz_3,$dz+3,$s3_3                 # 53e
        shufb   $signs_low,$s+2,$s+3,$m_signs           # 53o

        fnms    $s+2,$cz_3,$dz+2,$s2_4                  # 54e
        lnop                                            # 54o pairing

        fnms    $s2_5,$cx,$dx+2,$limit_3                # 55e
        shufb   $signs_2,$s_3,$s1_3,$m_signs            # 55o

        fnms    $s1_2,$cz_3,$dz+1,$s+1                  # 56e
        fnms    $s_2,$cz_3,$dz,$s                       # 57e

        fnms    $s+1,$cx,$dx+1,$limit_3                 # 58e
        lnop                                            # 58o pairing

        fnms    $s,$cx,$dx,$limit_3                     # 59e
        shufb   $signs_3,$signs_2,$signs_low,$m_halves  # 59o

        fnms    $s3_5,$cy,$dy+3,$s3_2                   # 60e
        shufb   $signs_low,$s+2,$s3_4,$m_signs          # 60o

next_sphere:
        ai      $count,$count,-1                        # 0e
            rotqbii $signs,$signs_3,1                   # 0o the sign of byte k to the end of byte

            fnms    $s+2,$cy,$dy+2,$s2_5                # 1e
            shufb   $limit,$more,$more,$m_limit         # 1o

            fnms    $s+1,$cy,$dy+1,$s+1                 # 2e
            shufb   $cx,$quad,$quad,$m_x                # 2o

            fnms    $s,$cy,$dy,$s                       # 3e
        lqd     $a_sphere,0($a_list)                    # 3o

        ai      $a_list,$a_list,16                      # 4e
            shufb   $signs_3,$s_2,$s1_2,$m_signs        # 4o

            fnms    $s+3,$cz,$dz+3,$s3_5                # 5e
            shufb   $cy,$quad,$quad,$m_y                # 5o

            fnms    $s3_5,$cx,$dx+3,$limit              # 6e
            gbb     $signs,$signs                       # 6o

            fnms    $s+2,$cz,$dz+2,$s+2                 # 7e
            lnop                                        # 7o pairing

            fnms    $s1_2,$cz,$dz+1,$s+1                # 8e
            shufb   $signs_3,$signs_3,$signs_low,$m_halves # 8o

            fnms    $s_2,$cz,$dz,$s                     # 9e
            shufb   $cz,$quad,$quad,$m_z                # 9o

            fnms    $s2_5,$cx,$dx+2,$limit              # 10e
        lqd     $more,16($a_sphere)                     # 10o

            fnms    $s+1,$cx,$dx+1,$limit               # 11e
        lqd     $quad,0($a_sphere)                      # 11o

            fnms    $s,$cx,$dx,$limit                   # 12e
            stqd    $signs,0($a_mask)                   # 12o

            fnms    $s3_5,$cy,$dy+3,$s3_5               # 13e
            shufb   $signs_low,$s+2,$s+3,$m_signs       # 13o

            ai      $a_mask,$a_mask,16                  # 14e
next_sphere_back:
        brnz    $count,next_sphere                      # 14o

next_sphere_drain:
        fnms    $s+2,$cy,$dy+2,$s2_5                    # 0e
        shufb   $limit,$more,$more,$m_limit             # 0o

        fnms    $s+1,$cy,$dy+1,$s+1                     # 1e
        shufb   $cx,$quad,$quad,$m_x                    # 1o

        fnms    $s,$cy,$dy,$s                           # 2e
        shufb   $cy,$quad,$quad,$m_y                    # 2o

        fnms    $s+3,$cz,$dz+3,$s3_5                    # 3e
        shufb   $cz_4,$quad,$quad,$m_z                  # 3o

        ai      $a_mask_2,$a_mask,16                    # 4e
        shufb   $signs_4,$s_2,$s1_2,$m_signs            # 4o

        fnms    $s3_6,$cx,$dx+3,$limit                  # 5e
        hbr     cull_spheres_p16_return,$lr             # 5o hint

        fnms    $s2_5,$cx,$dx+2,$limit                  # 6e
        rotqbii $signs,$signs_3,1                       # 6o the sign of byte k to the end of byte

        fnms    $s1_4,$cx,$dx+1,$limit                  # 7e
        lnop                                            # 7o pairing

        fnms    $s_2,$cx,$dx,$limit                     # 8e
        shufb   $signs_4,$signs_4,$signs_low,$m_halves  # 8o

        fnms    $s+2,$cz,$dz+2,$s+2                     # 9e
        lnop                                            # 9o pairing

        fnms    $s1_5,$cz,$dz+1,$s+1                    # 10e
        gbb     $signs,$signs                           # 10o

        fnms    $s3_6,$cy,$dy+3,$s3_6                   # 11e
        lnop                                            # 11o pairing

        fnms    $s2_5,$cy,$dy+2,$s2_5                   # 12e
        rotqbii $signs_4,$signs_4,1                     # 12o the sign of byte k to the end of byte

        fnms    $s+1,$cy,$dy+1,$s1_4                    # 13e
        lnop                                            # 13o pairing

        fnms    $s_4,$cy,$dy,$s_2                       # 14e
        stqd    $signs,0($a_mask)                       # 14o

        fnms    $s_2,$cz,$dz,$s                         # 15e
        shufb   $signs_low,$s+2,$s+3,$m_signs           # 15o

        ai      $a_mask,$a_mask_2,16                    # 16e
        gbb     $signs,$signs_4                         # 16o

        fnms    $s+3,$cz_4,$dz+3,$s3_6                  # 17e
        fnms    $s+2,$cz_4,$dz+2,$s2_5                  # 18e

        fnms    $s1_2,$cz_4,$dz+1,$s+1                  # 19e
        lnop                                            # 19o pairing

        fnms    $s_4,$cz_4,$dz,$s_4                     # 20e
        stqd    $signs,0($a_mask_2)                     # 20o

        ai      $a_mask_3,$a_mask,16                    # 21e
        shufb   $signs_5,$s_2,$s1_5,$m_signs            # 21o

        ai      $a_mask_4,$a_mask_3,16                  # 23e
        shufb   $signs_low_2,$s+2,$s+3,$m_signs         # 24o

        shufb   $signs_5,$signs_5,$signs_low,$m_halves  # 25o
        shufb   $signs_3,$s_4,$s1_2,$m_signs            # 26o

        rotqbii $signs,$signs_5,1                       # 29o the sign of byte k to the end of byte
        shufb   $signs_3,$signs_3,$signs_low_2,$m_halves # 30o

        gbb     $signs,$signs                           # 33o
        rotqbii $signs_3,$signs_3,1                     # 34o the sign of byte k to the end of byte

        stqd    $signs,0($a_mask)                       # 37o
        gbb     $signs,$signs_3                         # 38o

        stqd    $signs,0($a_mask_3)                     # 42o
cull_spheres_p16_return:
        bi      $lr                                     # 43o

next_sphere_short:
        ai      $count,$count,-1                        # 0e
        lqd     $a_sphere,0($a_list)                    # 0o

        ai      $a_list,$a_list,16                      # 1e
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

        nop     $127                                    # 51e pairing
        stqd    $signs,0($a_mask)                       # 54o

        ai      $a_mask,$a_mask,16                      # 55e
        brnz    $count,next_sphere_short                # 55o

        nop     $127                                    # 56e pairing
        bi      $lr                                     # 56o
endfunction cull_spheres_p16
