# frustum_spheres   of an array of spheres, those that reach into a frustum
#   C       struct pair *frustum_spheres(const struct frustum *, const struct sphere *, int count,
#                                        struct pair *);
#   In      $3 frustum, $4 spheres, $5 count (0 is none), $6 where the list goes; 16-aligned
#   Out     a quadword for each such sphere, in order, whose first word is its address; one more
#           quadword may be written
#           $3 behind the list
#   Uses    $3-$6, $10-$39   Saves  -   Stack  0   Calls  -
#   Domain  unit normals, within 4 ulp; reach as the PPU makes it
#   Error   0: no sphere is left out that has a point in the frustum
#   Twin    oracle/src/twin/cull.rs
#
# The four planes stand in the four lanes, so one sphere takes three products:
#   s = reach + n.c, negative in a lane: all of the sphere is outside of that plane
# Scheduled by spu schedule from frustum_spheres.s

        .include "work_unit.inc"
        .include "macros.inc"

        .set    a_frustum,3
        .set    a_sphere,4
        .set    count,5
        .set    a_list,6
        # constants
        .set    m_x,10
        .set    m_y,11
        .set    m_z,12
        .set    m_reach,13
        .set    nx,14
        .set    ny,15
        .set    nz,16
        # the sphere
        .set    quad,20
        .set    more,21
        .set    cx,22
        .set    cy,23
        .set    cz,24
        .set    s,25
        # temporaries
        .set    outside,26
        .set    step,27

function frustum_spheres
        .set    count_2,79
        .set    a_sphere_2,2
        .set    more_2,6
        .set    s_2,7
        .set    quad_2,8
        .set    cz_2,9
        .set    s_3,6
        .set    s_4,5
        .set    a_sphere_3,6
        ilhu    $m_x,1                                  # 0e
        lqd     $nx,0($a_frustum)                       # 0o

        ilhu    $m_y,0x405                              # 1e
        lqd     $ny,16($a_frustum)                      # 1o

        ilhu    $m_z,0x809                              # 2e
        lqd     $nz,32($a_frustum)                      # 2o

        ilhu    $m_reach,0xc0d                          # 3e
        iohl    $m_x,515                                # 4e

        iohl    $m_y,0x607                              # 5e
        iohl    $m_z,0xa0b                              # 6e

        iohl    $m_reach,0xe0f                          # 7e
        lnop                                            # 7o pairing

        ori     $a_frustum,$a_list,0                    # 8e
        biz     $count,$lr                              # 8o

        clgti   $count_2,$count,2                       # 9e at least as many passes as overlap
        brz     $count_2,next_sphere_short              # 11o too few passes

        ai      $count,$count,-1                        # 12e
        lqd     $more,16($a_sphere)                     # 12o

        nop     $127                                    # 13e pairing
        lqd     $quad,0($a_sphere)                      # 13o

        ai      $count,$count,-1                        # 14e
        shlqbyi $a_sphere_2,$a_sphere,0                 # 14o copy

        ai      $a_sphere,$a_sphere,48                  # 15e
        hbrr    next_sphere_back,next_sphere            # 15o hint

        lqd     $more_2,16($a_sphere)                   # 17o
        shufb   $s_2,$more,$more,$m_reach               # 18o

        shufb   $cx,$quad,$quad,$m_x                    # 19o
        shufb   $cy,$quad,$quad,$m_y                    # 20o

        lqd     $quad_2,0($a_sphere)                    # 21o
        shufb   $cz_2,$quad,$quad,$m_z                  # 22o

        fma     $s_2,$cx,$nx,$s_2                       # 23e
        shufb   $s_3,$more_2,$more_2,$m_reach           # 23o

        shufb   $cx,$quad_2,$quad_2,$m_x                # 27o
        shufb   $cz,$quad_2,$quad_2,$m_z                # 28o

        fma     $s,$cy,$ny,$s_2                         # 29e
        shufb   $cy,$quad_2,$quad_2,$m_y                # 29o

        fma     $s_3,$cx,$nx,$s_3                       # 31e
        fma     $s,$cz_2,$nz,$s                         # 35e

next_sphere:
        ai      $count,$count,-1                        # 0e
            stqd    $a_sphere_2,0($a_frustum)           # 0o

            nop     $127                                # 1e pairing
            shlqbyi $a_sphere_2,$a_sphere,0             # 1o copy

            ai      $a_sphere,$a_sphere,48              # 2e
            rotqbii $outside,$s,1                       # 2o signs to the words' last bits

        nop     $127                                    # 3e pairing
        lqd     $more,16($a_sphere)                     # 4o

            fma     $s,$cy,$ny,$s_3                     # 5e
        lqd     $quad,0($a_sphere)                      # 5o

            nop     $127                                # 6e pairing
            gb      $outside,$outside                   # 6o

            ceqi    $step,$outside,0                    # 10e
        shufb   $s_3,$more,$more,$m_reach               # 10o

            fma     $s,$cz,$nz,$s                       # 11e
        shufb   $cx,$quad,$quad,$m_x                    # 11o

            andi    $step,$step,16                      # 12e
        shufb   $cz,$quad,$quad,$m_z                    # 12o

        shufb   $cy,$quad,$quad,$m_y                    # 13o
            a       $a_frustum,$a_frustum,$step         # 14e

        fma     $s_3,$cx,$nx,$s_3                       # 15e
next_sphere_back:
        brnz    $count,next_sphere                      # 15o

next_sphere_drain:
        fma     $s_4,$cy,$ny,$s_3                       # 0e
        rotqbii $outside,$s,1                           # 0o signs to the words' last bits

        ai      $a_sphere_3,$a_sphere,48                # 1e
        hbr     frustum_spheres_return,$lr              # 1o hint

        shlqbyi $a_sphere,$a_sphere,0                   # 2o copy
        stqd    $a_sphere_2,0($a_frustum)               # 3o

        gb      $outside,$outside                       # 4o
        fma     $s,$cz,$nz,$s_4                         # 6e

        ceqi    $step,$outside,0                        # 8e
        andi    $step,$step,16                          # 10e

        a       $a_frustum,$a_frustum,$step             # 12e
        rotqbii $outside,$s,1                           # 12o signs to the words' last bits

        stqd    $a_sphere,0($a_frustum)                 # 14o
        gb      $outside,$outside                       # 16o

        ceqi    $step,$outside,0                        # 20e
        andi    $step,$step,16                          # 22e

        a       $a_frustum,$a_frustum,$step             # 24e
frustum_spheres_return:
        bi      $lr                                     # 24o

next_sphere_short:
        ai      $count,$count,-1                        # 0e
        lqd     $quad,0($a_sphere)                      # 0o

        lqd     $more,16($a_sphere)                     # 1o
        stqd    $a_sphere,0($a_frustum)                 # 2o

        ai      $a_sphere,$a_sphere,48                  # 3e
        shufb   $cx,$quad,$quad,$m_x                    # 6o

        shufb   $s,$more,$more,$m_reach                 # 7o
        shufb   $cy,$quad,$quad,$m_y                    # 8o

        shufb   $cz,$quad,$quad,$m_z                    # 9o
        fma     $s,$cx,$nx,$s                           # 11e

        fma     $s,$cy,$ny,$s                           # 17e
        fma     $s,$cz,$nz,$s                           # 23e

        rotqbii $outside,$s,1                           # 29o signs to the words' last bits
        gb      $outside,$outside                       # 33o

        ceqi    $step,$outside,0                        # 37e
        andi    $step,$step,16                          # 39e

        a       $a_frustum,$a_frustum,$step             # 41e
        brnz    $count,next_sphere_short                # 41o

        nop     $127                                    # 42e pairing
        bi      $lr                                     # 42o
endfunction frustum_spheres
