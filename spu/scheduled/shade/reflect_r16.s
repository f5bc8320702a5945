# reflect_r16   rays that mirrors throw back, appended to a queue
#   C       struct queued *reflect_r16(const struct site *, int count, struct queued *, float
#           least);
#   In      $3 sites, $4 count (0 is none), $5 where the rays go: room for one more than
#           there may be, $6 least weight of a ray that is sent on; pointers 16-aligned
#   Out     a ray for each lane whose share `mirror` is above 0 and whose weight is not below the
#           least, in order; $3 their end
#   Uses    $2-$4, $6-$62, $79   Saves  -   Stack  0   Calls  -
#   Domain  directions and normals of length 1 within 4 ulp, normals on the ray's side
#   Error   5 ulp of 1, each component of a direction; where r.G is within 1e-5 of 0, either normal
#           may be taken; its length within 2
#   Twin    lab/twins/src/reflect.rs
#
# r = d - 2 (d.N) N, or with the surface's own normal G if r does not leave the surface: r.G <= 0
# The ray starts at point + leave G.
# Scheduled by spu schedule from reflect_r16.s

        .include "work_unit.inc"
        .include "macros.inc"
        .include "bounce.inc"

        .set    NEXT,55
        registers mirror
        registers along                                 # d.N
        registers along_plane                           # d.G
        registers cosine                                # N.G
        registers off                                   # r.G
        registers twice

bounce_shuffles

function reflect_r16
        .set count_2,79; .set row_2,2; .set site_2,3; .set nx_2,6; .set a_surfaces_2,7
        .set gx_2,18; .set a_rays_2,19; .set ny_2,21; .set nz_2,23; .set dx_2,8; .set dy_2,25
        .set gy_2,32; .set dz_2,33; .set gz_2,34; .set a_rays_3,3; .set dx_3,35; .set py_2,22
        .set a_rays_4,8; .set pz_2,2; .set px_2,3; .set nx_3,9; .set dx_4,36; .set dy_3,24
        .set py_3,20; .set nz_3,22; .set along_2,27; .set dz_3,31; .set py_4,39; .set keep_2,30
        .set odd_2,54; .set light_2,40; .set odd_3,45; .set cosine_2,20; .set even_2,3
        .set along_plane_2,2; .set step_2,40; .set py_5,43; .set pz_3,20; .set px_3,7
        .set end_2,61; .set along_3,3; .set step_3,47; .set first2_2,27; .set ny_3,18; .set nz_4,19
        .set rx_2,23; .set rz_2,25; .set dx_5,33; .set length_2,2; .set keep_3,7; .set light_3,18
        .set end_3,62; .set end_4,2; .set step_4,6; .set odd_4,7; .set dx_6,18; .set even_3,18
        .set pz_4,19; .set even_4,21; .set px_4,18; .set even_5,4; .set end_5,6; .set pixel_2,7
        .set first_2,8; .set step_5,3; .set nz_5,4; .set odd_5,14; .set end_6,16; .set end_7,4
        .set end_8,9; .set end_9,3; .set odd_6,2; .set step_6,7; .set end_10,8
        ori     $a_sites,$3,0                           # 0e
        lnop                                            # 0o pairing
        ori     $3,$a_queue,0                           # 1e
        biz     $count,$lr                              # 1o
        shli    $count,$count,2                         # 2e
        lqa     $m_first,first_two                      # 2o
        ila     $least,0x10203                          # 3e
        lqa     $m_last,last_two                        # 3o
        ai      $a_second,$a_queue,16                   # 4e
        lnop                                            # 4o pairing
        il      $at,0                                   # 5e
        shufb   $least,$given_least,$given_least,$least # 5o
        clgti   $count_2,$count,2                       # 6e at least as many passes as overlap
        il      $end,0                                  # 7e
        ilhu    $k_half,0x3f00                          # 8e
        lnop                                            # 8o pairing
        ilhu    $k_three_halves,0x3fc0                  # 9e
        brz     $count_2,next_row_short                 # 9o too few passes
        shli    $row,$at,2                              # 10e
        lqx     $site,$a_sites,$at                      # 10o
        ai      $at,$at,4                               # 11e
        ai      $count,$count,-1                        # 12e
        shli    $row_2,$at,2                            # 13e
        lqx     $site_2,$a_sites,$at                    # 13o
        andi    $row,$row,48                            # 14e
        ai      $at,$at,4                               # 15e
        a       $a_surfaces,$site,$row                  # 16e
        rotqbyi $a_rays,$site,4                         # 16o
        andi    $row_2,$row_2,48                        # 17e
        lnop                                            # 17o pairing
        ai      $count,$count,-1                        # 18e
        lqd     $nx_2,192($a_surfaces)                  # 18o
        a       $a_surfaces_2,$site_2,$row_2            # 19e
        lqd     $gx_2,384($a_surfaces)                  # 19o
        a       $a_rays_2,$a_rays,$row                  # 20e
        lqd     $ny_2,256($a_surfaces)                  # 20o
        lqd     $nz_2,320($a_surfaces)                  # 21o
        lqd     $dx_2,192($a_rays_2)                    # 22o
        lqd     $dy_2,256($a_rays_2)                    # 23o
        lqd     $gy_2,448($a_surfaces)                  # 24o
        fm      $cosine,$nx_2,$gx_2                     # 25e
        lqd     $dz_2,320($a_rays_2)                    # 25o
        lqd     $gz_2,512($a_surfaces)                  # 26o
        rotqbyi $a_rays_3,$site_2,4                     # 27o
        fm      $along,$dx_2,$nx_2                      # 28e
        lqd     $mirror,0x400($a_surfaces)              # 28o
        fm      $along_plane,$dx_2,$gx_2                # 29e
        lqd     $weight,512($a_rays_2)                  # 29o
        ori     $dx_3,$dx_2,0                           # 30e copy
        lqd     $leave,576($a_surfaces)                 # 30o
        fma     $cosine,$ny_2,$gy_2,$cosine             # 31e
        lqd     $py_2,64($a_surfaces)                   # 31o
        a       $a_rays_4,$a_rays_3,$row_2              # 32e
        lqd     $pz_2,128($a_surfaces)                  # 32o
        nop     $127                                    # 33e pairing
        lqd     $px_2,0($a_surfaces)                    # 33o
        fma     $along,$dy_2,$ny_2,$along               # 34e
        lqd     $nx_3,192($a_surfaces_2)                # 34o
        fma     $along_plane,$dy_2,$gy_2,$along_plane   # 35e
        lqd     $dx_4,192($a_rays_4)                    # 35o
        fm      $weight,$weight,$mirror                 # 36e
        lqd     $gx,384($a_surfaces_2)                  # 36o
        fma     $cosine,$nz_2,$gz_2,$cosine             # 37e
        lqd     $dy_3,256($a_rays_4)                    # 37o
        fma     $py_3,$leave,$gy_2,$py_2                # 38e
        lqd     $ny,256($a_surfaces_2)                  # 38o
        fma     $pz_2,$leave,$gz_2,$pz_2                # 39e
        lqd     $nz_3,320($a_surfaces_2)                # 39o
        fma     $along_2,$dz_2,$nz_2,$along             # 40e
        lqd     $gy,448($a_surfaces_2)                  # 40o
        fma     $along_plane,$dz_2,$gz_2,$along_plane   # 41e
        lqd     $dz_3,320($a_rays_4)                    # 41o
        fma     $px_2,$leave,$gx_2,$px_2                # 42e
        lqd     $leave,576($a_surfaces_2)               # 42o
        fm      $along,$dx_4,$nx_3                      # 43e
        lqd     $py_4,64($a_surfaces_2)                 # 43o
        cgti    $keep_2,$mirror,0                       # 44e
        shufb   $odd_2,$py_3,$weight,$m_last            # 44o
        fcgt    $light_2,$least,$weight                 # 45e
        shufb   $odd_3,$py_3,$weight,$m_first           # 45o
        fa      $twice,$along_2,$along_2                # 46e
        lqd     $mirror,0x400($a_surfaces_2)            # 46o
        andc    $keep,$keep_2,$light_2                  # 47e
        lqd     $weight,512($a_rays_4)                  # 47o
        fm      $cosine_2,$nx_3,$gx                     # 48e
        shufb   $even,$px_2,$pz_2,$m_last               # 48o
        andi    $keep,$keep,32                          # 49e
        shufb   $even_2,$px_2,$pz_2,$m_first            # 49o
        fm      $along_plane_2,$dx_4,$gx                # 50e
        lqd     $gz,512($a_surfaces_2)                  # 50o
        fma     $along,$dy_3,$ny,$along                 # 51e
        rotqbyi $step,$keep,8                           # 51o
        fnms    $off,$twice,$cosine,$along_plane        # 52e
        rotqbyi $step_2,$keep,4                         # 52o
        fma     $py_5,$leave,$gy,$py_4                  # 53e
        shufb   $first+1,$even_2,$odd_3,$m_last         # 53o
        fma     $cosine,$ny,$gy,$cosine_2               # 54e
        shufb   $first+3,$even,$odd_2,$m_last           # 54o
        fm      $weight,$weight,$mirror                 # 55e
        lqd     $pz_3,128($a_surfaces_2)                # 55o
        fma     $along_plane_2,$dy_3,$gy,$along_plane_2 # 56e
        lqd     $px_3,0($a_surfaces_2)                  # 56o
        fma     $along,$dz_3,$nz_3,$along               # 57e
        shufb   $first,$even_2,$odd_3,$m_first          # 57o
        cgti    $off,$off,0                             # 58e
        hbrr    next_row_back,next_row                  # 58o hint
        a       $end_2,$end,$keep                       # 59e
        lqd     $pixel,576($a_rays_2)                   # 59o
        selb    $along_3,$along_plane,$along_2,$off     # 60e
        rotqbyi $step_3,$keep,12                        # 60o
        selb    $nx_2,$gx_2,$nx_2,$off                  # 61e
        stqx    $first,$a_queue,$end                    # 61o
        fa      $twice,$along_3,$along_3                # 62e
        shufb   $first2_2,$even,$odd_2,$m_first         # 62o
        selb    $ny_3,$gy_2,$ny_2,$off                  # 63e
        shufb   $odd_2,$py_5,$weight,$m_last            # 63o
        selb    $nz_4,$gz_2,$nz_2,$off                  # 64e
        shufb   $odd_3,$py_5,$weight,$m_first           # 64o
        fma     $pz_3,$leave,$gz,$pz_3                  # 65e
        fma     $px_2,$leave,$gx,$px_3                  # 66e
        fma     $cosine,$nz_3,$gz,$cosine               # 67e
        fnms    $rx_2,$twice,$nx_2,$dx_3                # 68e
        fnms    $ry,$twice,$ny_3,$dy_2                  # 69e
        fnms    $rz_2,$twice,$nz_4,$dz_2                # 70e
        fma     $along_plane,$dz_3,$gz,$along_plane_2   # 71e
        fa      $twice,$along,$along                    # 72e
        ori     $dx_5,$dx_4,0                           # 73e copy
        fm      $length_2,$rx_2,$rx_2                   # 74e
        cgti    $keep_3,$mirror,0                       # 75e
        fcgt    $light_3,$least,$weight                 # 76e
        a       $end_3,$end_2,$step_2                   # 77e
        fma     $length,$ry,$ry,$length_2               # 80e
        fma     $length,$rz_2,$rz_2,$length             # 86e
        lnop                                            # 86o pairing
next_row:
            fnms    $length,$length,$k_half,$k_three_halves # 0e
            stqx    $first+1,$a_queue,$end_2            # 0o
            a       $end_4,$end_3,$step                 # 1e
            shufb   $even,$px_2,$pz_3,$m_last           # 1o
        shli    $row,$at,2                              # 2e
            shufb   $even_2,$px_2,$pz_3,$m_first        # 2o
            andc    $keep,$keep_3,$light_3              # 3e
        lqx     $site,$a_sites,$at                      # 3o
            fnms    $off,$twice,$cosine,$along_plane    # 4e
            stqx    $first2_2,$a_queue,$end_3           # 4o
            andi    $keep,$keep,32                      # 5e
            stqx    $first+3,$a_queue,$end_4            # 5o
            fm      $ry,$ry,$length                     # 6e
            shufb   $first+1,$even_2,$odd_3,$m_last     # 6o
        andi    $row,$row,48                            # 7e
            rotqbyi $step,$keep,8                       # 7o
        ai      $at,$at,4                               # 8e
            rotqbyi $step_4,$keep,4                     # 8o
        a       $a_surfaces,$site,$row                  # 9e
        rotqbyi $a_rays,$site,4                         # 9o
            cgti    $off,$off,0                         # 10e
            shufb   $first+3,$even,$odd_2,$m_last       # 10o
            fm      $rz,$rz_2,$length                   # 11e
        lqd     $leave,576($a_surfaces)                 # 11o
            selb    $along,$along_plane,$along,$off     # 12e
            shufb   $odd,$ry,$pixel,$m_last             # 12o
            selb    $nx,$gx,$nx_3,$off                  # 13e
            shufb   $odd_4,$ry,$pixel,$m_first          # 13o
            fa      $twice,$along,$along                # 14e
            lqd     $pixel,576($a_rays_4)               # 14o
        a       $a_rays_4,$a_rays,$row                  # 15e
        lqd     $gx,384($a_surfaces)                    # 15o
            selb    $nz,$gz,$nz_3,$off                  # 16e
        lqd     $nx_3,192($a_surfaces)                  # 16o
            selb    $ny,$gy,$ny,$off                    # 17e
        lqd     $nz_3,320($a_surfaces)                  # 17o
        ai      $count,$count,-1                        # 18e
        lqd     $dx_6,192($a_rays_4)                    # 18o
            fm      $rx,$rx_2,$length                   # 19e
        lqd     $gy,448($a_surfaces)                    # 19o
            fnms    $ry,$twice,$ny,$dy_3                # 20e
        lqd     $gz,512($a_surfaces)                    # 20o
            fnms    $rx_2,$twice,$nx,$dx_5              # 21e
        lqd     $dy_3,256($a_rays_4)                    # 21o
        fm      $cosine,$nx_3,$gx                       # 22e
        lqd     $ny,256($a_surfaces)                    # 22o
            fnms    $rz_2,$twice,$nz,$dz_3              # 23e
        lqd     $py,64($a_surfaces)                     # 23o
        fm      $along_plane,$dx_6,$gx                  # 24e
        lqd     $mirror,0x400($a_surfaces)              # 24o
        fm      $along,$dx_6,$nx_3                      # 25e
        lqd     $dz_3,320($a_rays_4)                    # 25o
        ori     $dx_5,$dx_6,0                           # 26e copy
            shufb   $even_3,$rx,$rz,$m_first            # 26o
            fm      $length,$rx_2,$rx_2                 # 27e
        lqd     $pz_4,128($a_surfaces)                  # 27o
        fma     $cosine,$ny,$gy,$cosine                 # 28e
            shufb   $even_4,$rx,$rz,$m_last             # 28o
        fma     $py,$leave,$gy,$py                      # 29e
        lqd     $weight,512($a_rays_4)                  # 29o
        fma     $along_plane,$dy_3,$gy,$along_plane     # 30e
            shufb   $second+1,$even_3,$odd_4,$m_last    # 30o
        fma     $along,$dy_3,$ny,$along                 # 31e
            shufb   $second,$even_3,$odd_4,$m_first     # 31o
        cgti    $keep_3,$mirror,0                       # 32e
        lqd     $px_4,0($a_surfaces)                    # 32o
        fma     $pz_3,$leave,$gz,$pz_4                  # 33e
            shufb   $first,$even_2,$odd_3,$m_first      # 33o
            fma     $length,$ry,$ry,$length             # 34e
            shufb   $second+3,$even_4,$odd,$m_last      # 34o
        fm      $weight,$weight,$mirror                 # 35e
            stqx    $second,$a_second,$end              # 35o
            a       $end,$end_4,$step_3                 # 36e
            rotqbyi $step_3,$keep,12                    # 36o
        fma     $along,$dz_3,$nz_3,$along               # 37e
            shufb   $first2_2,$even,$odd_2,$m_first     # 37o
        fma     $px_2,$leave,$gx,$px_4                  # 38e
            stqx    $first,$a_queue,$end                # 38o
        fma     $cosine,$nz_3,$gz,$cosine               # 39e
            shufb   $second+2,$even_4,$odd,$m_first     # 39o
            fma     $length,$rz_2,$rz_2,$length         # 40e
            stqx    $second+1,$a_second,$end_2          # 40o
        fma     $along_plane,$dz_3,$gz,$along_plane     # 41e
        shufb   $odd_2,$py,$weight,$m_last              # 41o
        fcgt    $light_3,$least,$weight                 # 42e
        shufb   $odd_3,$py,$weight,$m_first             # 42o
            a       $end_2,$end,$keep                   # 43e
            stqx    $second+2,$a_second,$end_3          # 43o
        fa      $twice,$along,$along                    # 44e
            stqx    $second+3,$a_second,$end_4          # 44o
            a       $end_3,$end_2,$step_4               # 45e
next_row_back:
        brnz    $count,next_row                         # 45o
next_row_drain:
        fnms    $off,$twice,$cosine,$along_plane        # 0e
        stqx    $first+1,$a_queue,$end_2                # 0o
        fnms    $length,$length,$k_half,$k_three_halves # 1e
        stqx    $first2_2,$a_queue,$end_3               # 1o
        a       $end_4,$end_3,$step                     # 2e
        shufb   $even_5,$px_2,$pz_3,$m_first            # 2o
        andc    $keep,$keep_3,$light_3                  # 3e
        hbr     reflect_r16_return,$lr                  # 3o hint
        a       $end_5,$end_4,$step_3                   # 4e
        stqx    $first+3,$a_queue,$end_4                # 4o
        andi    $keep,$keep,32                          # 5e
        lqd     $pixel_2,576($a_rays_4)                 # 5o
        cgti    $off,$off,0                             # 6e
        shufb   $first_2,$even_5,$odd_3,$m_first        # 6o
        fm      $ry,$ry,$length                         # 7e
        shufb   $even,$px_2,$pz_3,$m_last               # 7o
        selb    $along,$along_plane,$along,$off         # 8e
        rotqbyi $step_5,$keep,4                         # 8o
        selb    $nx_3,$gx,$nx_3,$off                    # 9e
        shufb   $first+1,$even_5,$odd_3,$m_last         # 9o
        fa      $twice,$along,$along                    # 10e
        rotqbyi $step,$keep,8                           # 10o
        selb    $ny,$gy,$ny,$off                        # 11e
        shufb   $first2_2,$even,$odd_2,$m_first         # 11o
        selb    $nz_5,$gz,$nz_3,$off                    # 12e
        shufb   $first+3,$even,$odd_2,$m_last           # 12o
        fm      $rz,$rz_2,$length                       # 13e
        shufb   $odd_5,$ry,$pixel,$m_first              # 13o
        fm      $rx,$rx_2,$length                       # 14e
        shufb   $odd,$ry,$pixel,$m_last                 # 14o
        a       $end_6,$end_5,$keep                     # 15e
        rotqbyi $step_3,$keep,12                        # 15o
        fnms    $rx_2,$twice,$nx_3,$dx_5                # 16e
        fnms    $ry,$twice,$ny,$dy_3                    # 17e
        fnms    $rz_2,$twice,$nz_5,$dz_3                # 18e
        a       $end_7,$end_6,$step_5                   # 19e
        nop     $127                                    # 20e pairing
        shufb   $even_3,$rx,$rz,$m_first                # 20o
        a       $end_8,$end_7,$step                     # 21e
        shufb   $even_4,$rx,$rz,$m_last                 # 21o
        fm      $length,$rx_2,$rx_2                     # 22e
        a       $end_9,$end_8,$step_3                   # 23e
        nop     $127                                    # 24e pairing
        shufb   $second,$even_3,$odd_5,$m_first         # 24o
        a       $3,$a_queue,$end_9                      # 25e
        shufb   $second+1,$even_3,$odd_5,$m_last        # 25o
        shufb   $second+2,$even_4,$odd,$m_first         # 26o
        shufb   $second+3,$even_4,$odd,$m_last          # 27o
        fma     $length,$ry,$ry,$length                 # 28e
        stqx    $second,$a_second,$end                  # 28o
        stqx    $first_2,$a_queue,$end_5                # 29o
        stqx    $second+1,$a_second,$end_2              # 30o
        stqx    $second+2,$a_second,$end_3              # 31o
        stqx    $second+3,$a_second,$end_4              # 32o
        nop     $127                                    # 33e pairing
        stqx    $first+1,$a_queue,$end_6                # 33o
        fma     $length,$rz_2,$rz_2,$length             # 34e
        stqx    $first2_2,$a_queue,$end_7               # 34o
        stqx    $first+3,$a_queue,$end_8                # 35o
        fnms    $length,$length,$k_half,$k_three_halves # 40e
        fm      $ry,$ry,$length                         # 46e
        fm      $rz,$rz_2,$length                       # 47e
        fm      $rx,$rx_2,$length                       # 48e
        shufb   $odd_6,$ry,$pixel_2,$m_first            # 52o
        shufb   $odd,$ry,$pixel_2,$m_last               # 53o
        shufb   $even_3,$rx,$rz,$m_first                # 54o
        shufb   $even_4,$rx,$rz,$m_last                 # 55o
        shufb   $second,$even_3,$odd_6,$m_first         # 58o
        shufb   $second+1,$even_3,$odd_6,$m_last        # 59o
        shufb   $second+2,$even_4,$odd,$m_first         # 60o
        shufb   $second+3,$even_4,$odd,$m_last          # 61o
        stqx    $second,$a_second,$end_5                # 62o
        stqx    $second+1,$a_second,$end_6              # 63o
        stqx    $second+2,$a_second,$end_7              # 64o
        stqx    $second+3,$a_second,$end_8              # 65o
reflect_r16_return:
        bi      $lr                                     # 66o
next_row_short:
        shli    $row,$at,2                              # 0e
        lqx     $site,$a_sites,$at                      # 0o
        ai      $count,$count,-1                        # 1e
        ai      $at,$at,4                               # 2e
        andi    $row,$row,48                            # 4e
        lnop                                            # 4o pairing
        a       $a_surfaces,$site,$row                  # 6e
        rotqbyi $a_rays,$site,4                         # 6o
        lqd     $nx,192($a_surfaces)                    # 8o
        lqd     $gx,384($a_surfaces)                    # 9o
        a       $a_rays,$a_rays,$row                    # 10e
        lqd     $ny,256($a_surfaces)                    # 10o
        lqd     $gy,448($a_surfaces)                    # 11o
        lqd     $dx,192($a_rays)                        # 12o
        lqd     $dy,256($a_rays)                        # 13o
        lqd     $dz,320($a_rays)                        # 14o
        fm      $cosine,$nx,$gx                         # 15e
        lqd     $nz,320($a_surfaces)                    # 15o
        lqd     $gz,512($a_surfaces)                    # 16o
        lqd     $weight,512($a_rays)                    # 17o
        fm      $along,$dx,$nx                          # 18e
        lqd     $mirror,0x400($a_surfaces)              # 18o
        fm      $along_plane,$dx,$gx                    # 19e
        lqd     $px,0($a_surfaces)                      # 19o
        nop     $127                                    # 20e pairing
        lqd     $py,64($a_surfaces)                     # 20o
        fma     $cosine,$ny,$gy,$cosine                 # 21e
        lqd     $pz,128($a_surfaces)                    # 21o
        lqd     $leave,576($a_surfaces)                 # 22o
        lqd     $pixel,576($a_rays)                     # 23o
        fma     $along,$dy,$ny,$along                   # 24e
        fma     $along_plane,$dy,$gy,$along_plane       # 25e
        fm      $weight,$weight,$mirror                 # 26e
        fma     $cosine,$nz,$gz,$cosine                 # 27e
        fma     $px,$leave,$gx,$px                      # 28e
        fma     $py,$leave,$gy,$py                      # 29e
        fma     $along,$dz,$nz,$along                   # 30e
        fma     $along_plane,$dz,$gz,$along_plane       # 31e
        fma     $pz,$leave,$gz,$pz                      # 32e
        cgti    $keep,$mirror,0                         # 33e
        fcgt    $light,$least,$weight                   # 34e
        shufb   $odd,$py,$weight,$m_first               # 35o
        fa      $twice,$along,$along                    # 36e
        shufb   $odd_6,$py,$weight,$m_last              # 36o
        andc    $keep,$keep,$light                      # 37e
        shufb   $even,$px,$pz,$m_first                  # 38o
        andi    $keep,$keep,32                          # 39e
        shufb   $even_2,$px,$pz,$m_last                 # 39o
        a       $end_5,$end,$keep                       # 41e
        rotqbyi $step,$keep,4                           # 41o
        fnms    $off,$twice,$cosine,$along_plane        # 42e
        shufb   $first,$even,$odd,$m_first              # 42o
        shufb   $first+1,$even,$odd,$m_last             # 43o
        rotqbyi $step_6,$keep,8                         # 44o
        a       $end_10,$end_5,$step                    # 45e
        shufb   $first+2,$even_2,$odd_6,$m_first        # 45o
        shufb   $first+3,$even_2,$odd_6,$m_last         # 46o
        stqx    $first,$a_queue,$end                    # 47o
        cgti    $off,$off,0                             # 48e
        stqx    $first+1,$a_queue,$end_5                # 48o
        a       $end_4,$end_10,$step_6                  # 49e
        rotqbyi $step,$keep,12                          # 49o
        selb    $along,$along_plane,$along,$off         # 50e
        stqx    $first+2,$a_queue,$end_10               # 50o
        selb    $nx,$gx,$nx,$off                        # 51e
        stqx    $first+3,$a_queue,$end_4                # 51o
        fa      $twice,$along,$along                    # 52e
        selb    $ny,$gy,$ny,$off                        # 53e
        selb    $nz,$gz,$nz,$off                        # 54e
        fnms    $rx,$twice,$nx,$dx                      # 58e
        fnms    $ry,$twice,$ny,$dy                      # 59e
        fnms    $rz,$twice,$nz,$dz                      # 60e
        fm      $length,$rx,$rx                         # 64e
        fma     $length,$ry,$ry,$length                 # 70e
        fma     $length,$rz,$rz,$length                 # 76e
        fnms    $length,$length,$k_half,$k_three_halves # 82e
        fm      $rx,$rx,$length                         # 88e
        fm      $ry,$ry,$length                         # 89e
        fm      $rz,$rz,$length                         # 90e
        shufb   $odd,$ry,$pixel,$m_first                # 95o
        shufb   $even,$rx,$rz,$m_first                  # 96o
        shufb   $even_2,$rx,$rz,$m_last                 # 97o
        shufb   $odd_4,$ry,$pixel,$m_last               # 98o
        shufb   $second,$even,$odd,$m_first             # 100o
        shufb   $second+1,$even,$odd,$m_last            # 101o
        shufb   $second+2,$even_2,$odd_4,$m_first       # 102o
        shufb   $second+3,$even_2,$odd_4,$m_last        # 103o
        stqx    $second,$a_second,$end                  # 104o
        a       $end,$end_4,$step                       # 105e
        stqx    $second+1,$a_second,$end_5              # 105o
        stqx    $second+2,$a_second,$end_10             # 106o
        stqx    $second+3,$a_second,$end_4              # 107o
        nop     $127                                    # 108e pairing
        brnz    $count,next_row_short                   # 108o
        a       $3,$a_queue,$end                        # 109e
        bi      $lr                                     # 109o
endfunction reflect_r16
