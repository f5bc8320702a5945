# frustum_spheres   of an array of spheres, those that reach into a frustum
#   C       struct pair *frustum_spheres(const struct frustum *, const struct sphere *, int count,
#                                        struct pair *);
#   In      $3 frustum, $4 spheres, $5 count (0 is none), $6 where the list goes; 16-aligned
#   Out     a quadword for each such sphere, in order, whose first word is its address; one more
#           quadword may be written
#           $3 behind the list
#   Uses    $2-$27, $79   Saves  -   Stack  0   Calls  -
#   Domain  unit normals, within 4 ulp; reach as the PPU makes it
#   Error   0: no sphere is left out that has a point in the frustum
#   Twin    lab/twins/src/cull.rs
#
# The four planes are in the four lanes, so one sphere needs three products:
#   s = reach + n.c, which is negative in a lane if the whole sphere is outside that plane
# Scheduled by spu schedule from frustum_spheres.s

        .include "work_unit.inc"
        .include "macros.inc"

        .set    NEXT,3
        registers a_frustum,a_sphere,count,a_list
        # constants
        .set    NEXT,10
        registers m_x,m_y,m_z,m_reach,nx,ny,nz
        # the sphere
        .set    NEXT,20
        registers quad,more,cx,cy,cz,s
        # temporaries
        registers outside,step

function frustum_spheres
        .set count_2,79; .set a_sphere_2,2; .set a_sphere_3,6; .set quad_2,7; .set more_2,8
        .set quad_3,9; .set s_2,17; .set cx_2,18; .set s_3,8; .set cy_2,19; .set a_sphere_4,18
        .set cz_2,22; .set cx_3,7; .set a_sphere_5,17; .set cz_3,18; .set s_4,23; .set s_5,19
        .set s_6,7; .set cz_4,9
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
        clgti   $count_2,$count,4                       # 9e at least as many passes as overlap
        brz     $count_2,next_sphere_short              # 11o too few passes
        ai      $a_sphere_2,$a_sphere,48                # 12e
        lqd     $quad,0($a_sphere)                      # 12o
        ai      $count,$count,-1                        # 13e
        lqd     $more,16($a_sphere)                     # 13o
        ai      $a_sphere_3,$a_sphere_2,48              # 14e
        lqd     $quad_2,0($a_sphere_2)                  # 14o
        ai      $count,$count,-1                        # 15e
        lqd     $more_2,16($a_sphere_2)                 # 15o
        nop     $127                                    # 16e pairing
        hbrr    next_sphere_back,next_sphere            # 16o hint
        ai      $count,$count,-1                        # 17e
        lqd     $quad_3,0($a_sphere_3)                  # 17o
        nop     $127                                    # 18e pairing
        shufb   $cx,$quad,$quad,$m_x                    # 18o
        ai      $count,$count,-1                        # 19e
        shufb   $s_2,$more,$more,$m_reach               # 19o
        shufb   $cy,$quad,$quad,$m_y                    # 20o
        shufb   $cx_2,$quad_2,$quad_2,$m_x              # 21o
        nop     $127                                    # 22e pairing
        shufb   $s_3,$more_2,$more_2,$m_reach           # 22o
        fma     $s_2,$cx,$nx,$s_2                       # 23e
        shufb   $cz,$quad,$quad,$m_z                    # 23o
        shufb   $cy_2,$quad_2,$quad_2,$m_y              # 24o
        lqd     $more,16($a_sphere_3)                   # 25o
        fma     $s_3,$cx_2,$nx,$s_3                     # 26e
        shlqbyi $a_sphere_4,$a_sphere,0                 # 26o copy
        ori     $cz_2,$cz,0                             # 27e copy
        shufb   $cz,$quad_2,$quad_2,$m_z                # 27o
        ai      $a_sphere,$a_sphere_3,48                # 28e
        shufb   $cx_3,$quad_3,$quad_3,$m_x              # 28o
        fma     $s,$cy,$ny,$s_2                         # 29e
        shlqbyi $a_sphere_2,$a_sphere_2,0               # 29o copy
        ori     $a_sphere_5,$a_sphere_4,0               # 30e copy
        lqd     $quad,0($a_sphere)                      # 30o
        ori     $cz_3,$cz,0                             # 31e copy
        shufb   $s_4,$more,$more,$m_reach               # 31o
        fma     $s_3,$cy_2,$ny,$s_3                     # 32e
        lqd     $more,16($a_sphere)                     # 32o
        ori     $a_sphere_5,$a_sphere_5,0               # 33e copy
        shufb   $cz,$quad_3,$quad_3,$m_z                # 33o
        ori     $a_sphere_2,$a_sphere_2,0               # 34e copy
        shlqbyi $a_sphere_3,$a_sphere_3,0               # 34o copy
        fma     $s_5,$cz_2,$nz,$s                       # 35e
        stqd    $a_sphere_5,0($a_frustum)               # 35o
        fma     $s_6,$cx_3,$nx,$s_4                     # 36e
        shufb   $cy,$quad_3,$quad_3,$m_y                # 36o
        ori     $cz_4,$cz,0                             # 37e copy
        fma     $s_3,$cz_3,$nz,$s_3                     # 38e
        ori     $a_sphere_5,$a_sphere_2,0               # 39e copy
        rotqbii $outside,$s_5,1                         # 41o signs to the words' last bits
        nop     $127                                    # 42e pairing
        gb      $outside,$outside                       # 45o
next_sphere:
            ori     $a_sphere_2,$a_sphere_3,0           # 0e copy
            shlqbyi $a_sphere_3,$a_sphere,0             # 0o copy
            fma     $s,$cy,$ny,$s_6                     # 1e
            shufb   $cx,$quad,$quad,$m_x                # 1o
            ceqi    $step,$outside,0                    # 2e
            shufb   $s_6,$more,$more,$m_reach           # 2o
            ai      $a_sphere,$a_sphere,48              # 3e
            rotqbii $outside,$s_3,1                     # 3o signs to the words' last bits
            andi    $step,$step,16                      # 4e
            shufb   $cy,$quad,$quad,$m_y                # 4o
        ai      $count,$count,-1                        # 5e
            shufb   $cz,$quad,$quad,$m_z                # 5o
            fma     $s_6,$cx,$nx,$s_6                   # 6e
        lqd     $quad,0($a_sphere)                      # 6o
            a       $a_frustum,$a_frustum,$step         # 7e
        lqd     $more,16($a_sphere)                     # 7o
            fma     $s_3,$cz_4,$nz,$s                   # 8e
            gb      $outside,$outside                   # 8o
            ori     $cz_4,$cz,0                         # 9e copy
            stqd    $a_sphere_5,0($a_frustum)           # 9o
            ori     $a_sphere_5,$a_sphere_2,0           # 10e copy
next_sphere_back:
        brnz    $count,next_sphere                      # 10o
next_sphere_drain:
        fma     $s,$cy,$ny,$s_6                         # 0e
        shufb   $cx,$quad,$quad,$m_x                    # 0o
        ceqi    $step,$outside,0                        # 1e
        shufb   $s_6,$more,$more,$m_reach               # 1o
        ori     $a_sphere_2,$a_sphere_3,0               # 2e copy
        shufb   $cy,$quad,$quad,$m_y                    # 2o
        andi    $step,$step,16                          # 3e
        shufb   $cz,$quad,$quad,$m_z                    # 3o
        ori     $a_sphere_2,$a_sphere_2,0               # 4e copy
        rotqbii $outside,$s_3,1                         # 4o signs to the words' last bits
        fma     $s_6,$cx,$nx,$s_6                       # 5e
        hbr     frustum_spheres_return,$lr              # 5o hint
        fma     $s_3,$cz_4,$nz,$s                       # 6e
        shlqbyi $a_sphere_3,$a_sphere,0                 # 6o copy
        ori     $cz_4,$cz,0                             # 7e copy
        lnop                                            # 7o pairing
        a       $a_frustum,$a_frustum,$step             # 8e
        gb      $outside,$outside                       # 8o
        ai      $a_sphere,$a_sphere,48                  # 9e
        lnop                                            # 9o pairing
        ori     $a_sphere,$a_sphere_3,0                 # 10e copy
        stqd    $a_sphere_5,0($a_frustum)               # 10o
        fma     $s,$cy,$ny,$s_6                         # 11e
        lnop                                            # 11o pairing
        ceqi    $step,$outside,0                        # 12e
        rotqbii $outside,$s_3,1                         # 12o signs to the words' last bits
        ori     $a_sphere_5,$a_sphere,0                 # 13e copy
        andi    $step,$step,16                          # 14e
        a       $a_frustum,$a_frustum,$step             # 16e
        gb      $outside,$outside                       # 16o
        fma     $s_3,$cz_4,$nz,$s                       # 17e
        stqd    $a_sphere_2,0($a_frustum)               # 18o
        ceqi    $step,$outside,0                        # 20e
        andi    $step,$step,16                          # 22e
        rotqbii $outside,$s_3,1                         # 23o signs to the words' last bits
        a       $a_frustum,$a_frustum,$step             # 24e
        stqd    $a_sphere_5,0($a_frustum)               # 26o
        gb      $outside,$outside                       # 27o
        ceqi    $step,$outside,0                        # 31e
        andi    $step,$step,16                          # 33e
        a       $a_frustum,$a_frustum,$step             # 35e
frustum_spheres_return:
        bi      $lr                                     # 35o
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
