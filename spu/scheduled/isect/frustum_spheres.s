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
        .set count_2,79; .set more_2,2; .set quad_2,6; .set more_3,7; .set s_2,8; .set s_3,2
        .set cx_2,9; .set cy_2,17; .set quad_3,18; .set cz_2,6; .set cz_3,9; .set s_4,7
        .set cz_4,19; .set s_5,17; .set s_6,6; .set s_7,9; .set cz_5,8; .set a_sphere_2,5
        .set a_sphere_3,2
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
        ai      $count,$count,-1                        # 12e
        lqd     $more,16($a_sphere)                     # 12o
        nop     $127                                    # 13e pairing
        lqd     $quad,0($a_sphere)                      # 13o
        ai      $count,$count,-1                        # 14e
        lqd     $more_2,64($a_sphere)                   # 14o
        nop     $127                                    # 15e pairing
        lqd     $quad_2,48($a_sphere)                   # 15o
        ai      $count,$count,-1                        # 16e
        hbrr    next_sphere_back,next_sphere            # 16o hint
        nop     $127                                    # 17e pairing
        lqd     $more_3,112($a_sphere)                  # 17o
        ai      $count,$count,-1                        # 18e
        shufb   $s_2,$more,$more,$m_reach               # 18o
        shufb   $cx,$quad,$quad,$m_x                    # 19o
        shufb   $cy,$quad,$quad,$m_y                    # 20o
        shufb   $s_3,$more_2,$more_2,$m_reach           # 21o
        shufb   $cx_2,$quad_2,$quad_2,$m_x              # 22o
        fma     $s_2,$cx,$nx,$s_2                       # 23e
        shufb   $cz,$quad,$quad,$m_z                    # 23o
        shufb   $cy_2,$quad_2,$quad_2,$m_y              # 24o
        lqd     $quad_3,96($a_sphere)                   # 25o
        fma     $s_3,$cx_2,$nx,$s_3                     # 26e
        shufb   $cz_2,$quad_2,$quad_2,$m_z              # 26o
        ori     $cz_3,$cz,0                             # 27e copy
        shufb   $s_4,$more_3,$more_3,$m_reach           # 27o
        nop     $127                                    # 28e pairing
        lqd     $more,160($a_sphere)                    # 28o
        fma     $s,$cy,$ny,$s_2                         # 29e
        lqd     $quad,144($a_sphere)                    # 29o
        ori     $cz_4,$cz_2,0                           # 30e copy
        stqd    $a_sphere,0($a_frustum)                 # 30o
        nop     $127                                    # 31e pairing
        shufb   $cx,$quad_3,$quad_3,$m_x                # 31o
        fma     $s_5,$cy_2,$ny,$s_3                     # 32e
        shufb   $cz,$quad_3,$quad_3,$m_z                # 32o
        shufb   $cy,$quad_3,$quad_3,$m_y                # 33o
        shufb   $s_6,$more,$more,$m_reach               # 34o
        fma     $s_7,$cz_3,$nz,$s                       # 35e
        fma     $s_3,$cx,$nx,$s_4                       # 36e
        ori     $cz_5,$cz,0                             # 37e copy
        fma     $s_4,$cz_4,$nz,$s_5                     # 38e
        rotqbii $outside,$s_7,1                         # 41o signs to the words' last bits
        gb      $outside,$outside                       # 45o
next_sphere:
        ai      $count,$count,-1                        # 0e
        lqd     $more,208($a_sphere)                    # 0o
            fma     $s,$cy,$ny,$s_3                     # 1e
            shufb   $cx,$quad,$quad,$m_x                # 1o
            ceqi    $step,$outside,0                    # 2e
            shufb   $cz,$quad,$quad,$m_z                # 2o
            ai      $a_sphere,$a_sphere,48              # 3e
            rotqbii $outside,$s_4,1                     # 3o signs to the words' last bits
            andi    $step,$step,16                      # 4e
            shufb   $cy,$quad,$quad,$m_y                # 4o
            fma     $s_3,$cx,$nx,$s_6                   # 5e
        lqd     $quad,144($a_sphere)                    # 5o
            a       $a_frustum,$a_frustum,$step         # 6e
        shufb   $s_6,$more,$more,$m_reach               # 6o
            fma     $s_4,$cz_5,$nz,$s                   # 7e
            gb      $outside,$outside                   # 7o
            ori     $cz_5,$cz,0                         # 8e copy
            stqd    $a_sphere,0($a_frustum)             # 8o
        nop     $127                                    # 9e pairing
next_sphere_back:
        brnz    $count,next_sphere                      # 9o
next_sphere_drain:
        fma     $s,$cy,$ny,$s_3                         # 0e
        shufb   $cx,$quad,$quad,$m_x                    # 0o
        ceqi    $step,$outside,0                        # 1e
        shufb   $cy,$quad,$quad,$m_y                    # 1o
        ai      $a_sphere,$a_sphere,48                  # 2e
        shufb   $cz,$quad,$quad,$m_z                    # 2o
        andi    $step,$step,16                          # 3e
        rotqbii $outside,$s_4,1                         # 3o signs to the words' last bits
        fma     $s_3,$cx,$nx,$s_6                       # 4e
        hbr     frustum_spheres_return,$lr              # 4o hint
        a       $a_frustum,$a_frustum,$step             # 5e
        fma     $s_4,$cz_5,$nz,$s                       # 6e
        ori     $cz_5,$cz,0                             # 7e copy
        gb      $outside,$outside                       # 7o
        ai      $a_sphere_2,$a_sphere,48                # 8e
        stqd    $a_sphere,0($a_frustum)                 # 8o
        fma     $s,$cy,$ny,$s_3                         # 10e
        ceqi    $step,$outside,0                        # 11e
        ai      $a_sphere,$a_sphere_2,48                # 12e
        rotqbii $outside,$s_4,1                         # 12o signs to the words' last bits
        andi    $step,$step,16                          # 13e
        ai      $a_sphere_3,$a_sphere,48                # 14e
        a       $a_frustum,$a_frustum,$step             # 15e
        lnop                                            # 15o pairing
        fma     $s_4,$cz_5,$nz,$s                       # 16e
        gb      $outside,$outside                       # 16o
        stqd    $a_sphere_2,0($a_frustum)               # 17o
        ceqi    $step,$outside,0                        # 20e
        andi    $step,$step,16                          # 22e
        rotqbii $outside,$s_4,1                         # 22o signs to the words' last bits
        a       $a_frustum,$a_frustum,$step             # 24e
        gb      $outside,$outside                       # 26o
        stqd    $a_sphere,0($a_frustum)                 # 27o
        ceqi    $step,$outside,0                        # 30e
        andi    $step,$step,16                          # 32e
        lnop                                            # 32o pairing
        a       $a_frustum,$a_frustum,$step             # 34e
frustum_spheres_return:
        bi      $lr                                     # 34o
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
