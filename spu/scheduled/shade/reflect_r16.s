# reflect_r16   rays that mirrors throw back, appended to a queue
#   C       struct queued *reflect_r16(const struct site *, int count, struct queued *, float
#           least, unsigned deepest);
#   In      $3 sites, $4 count (0 is none), $5 where the rays go: room for one more than
#           there may be, $6 least weight of a ray that is sent on, $7 CHAIN_STEP times the
#           rays that may come before the last of a chain; pointers 16-aligned
#   Out     a ray for each lane whose share `mirror` is above 0 and whose weight is not below the
#           least, unless the lane's is the last of its chain, in order; $3 their end
#   Uses    $2-$62, $79   Saves  -   Stack  0   Calls  -
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
        .set count_2,79; .set row_2,2; .set site_2,3; .set nx_2,18; .set a_surfaces_2,9
        .set gx_2,23; .set ny_2,19; .set nz_2,24; .set dx_2,25; .set dy_2,26; .set gy_2,27
        .set dz_2,31; .set gz_2,32; .set px_2,22; .set py_2,30; .set weight_2,20; .set a_rays_2,34
        .set pixel_2,21; .set nx_3,3; .set keep_2,35; .set ny_3,8; .set py_3,36; .set pz_2,40
        .set mirror_2,41; .set px_3,42; .set py_4,37; .set leave_2,43; .set a_rays_3,2
        .set light_2,34; .set nz_3,9; .set dx_3,38; .set cosine_2,45; .set dy_3,49; .set even_2,21
        .set even_3,22; .set px_4,33; .set odd_2,42; .set odd_3,20; .set dz_3,44; .set along_2,36
        .set weight_3,46; .set along_plane_2,47; .set first_2,50; .set keep_3,34; .set first2_2,54
        .set first1_2,35; .set along_3,21; .set step_2,20; .set pixel_3,22; .set nx_4,2
        .set step_3,36; .set ny_4,18; .set step_4,51; .set end_2,52; .set pz_3,19; .set rx_2,24
        .set rz_2,25; .set end_3,61; .set weight_4,18; .set even_4,20; .set keep_4,23
        .set light_3,26; .set end_4,62; .set odd_4,2; .set second_2,19; .set step_5,2
        .set second2_2,19; .set second3_2,20; .set step_6,21; .set pixel_4,4; .set end_5,6
        .set even_5,3; .set step_7,7; .set end_6,8; .set end_7,2; .set second2_3,7; .set end_8,9
        .set odd_5,5; .set even_6,4; .set second2_4,5; .set light_4,2; .set odd_6,3; .set even_7,2
        .set step_8,9; .set end_9,18; .set odd_7,9
        ori     $a_sites,$3,0                           # 0e
        lnop                                            # 0o pairing
        ori     $3,$a_queue,0                           # 1e
        biz     $count,$lr                              # 1o
        shli    $count,$count,2                         # 2e
        lqa     $m_first,first_two                      # 2o
        ila     $light,0x10203                          # 3e
        lqa     $m_last,last_two                        # 3o
        ai      $a_second,$a_queue,16                   # 4e
        lnop                                            # 4o pairing
        il      $at,0                                   # 5e
        shufb   $least,$least,$least,$light             # 5o
        clgti   $count_2,$count,2                       # 6e at least as many passes as overlap
        shufb   $deepest,$deepest,$deepest,$light       # 6o
        il      $end,0                                  # 7e
        ilhu    $k_half,0x3f00                          # 8e
        ilhu    $k_three_halves,0x3fc0                  # 9e
        lnop                                            # 9o pairing
        ilhu    $k_chain,256                            # 10e
        brz     $count_2,next_row_short                 # 10o too few passes
        shli    $row,$at,2                              # 11e
        lqx     $site,$a_sites,$at                      # 11o
        ai      $at,$at,4                               # 12e
        ai      $count,$count,-1                        # 13e
        shli    $row_2,$at,2                            # 14e
        lqx     $site_2,$a_sites,$at                    # 14o
        andi    $row,$row,48                            # 15e
        ai      $at,$at,4                               # 16e
        a       $a_surfaces,$site,$row                  # 17e
        rotqbyi $a_rays,$site,4                         # 17o
        andi    $row_2,$row_2,48                        # 18e
        lnop                                            # 18o pairing
        ai      $count,$count,-1                        # 19e
        lqd     $nx_2,192($a_surfaces)                  # 19o
        a       $a_surfaces_2,$site_2,$row_2            # 20e
        lqd     $gx_2,384($a_surfaces)                  # 20o
        a       $a_rays,$a_rays,$row                    # 21e
        lqd     $ny_2,256($a_surfaces)                  # 21o
        lqd     $nz_2,320($a_surfaces)                  # 22o
        lqd     $dx_2,192($a_rays)                      # 23o
        lqd     $dy_2,256($a_rays)                      # 24o
        lqd     $gy_2,448($a_surfaces)                  # 25o
        fm      $cosine,$nx_2,$gx_2                     # 26e
        lqd     $dz_2,320($a_rays)                      # 26o
        lqd     $gz_2,512($a_surfaces)                  # 27o
        lqd     $pz,128($a_surfaces)                    # 28o
        fm      $along,$dx_2,$nx_2                      # 29e
        lqd     $mirror,0x400($a_surfaces)              # 29o
        fm      $along_plane,$dx_2,$gx_2                # 30e
        lqd     $px_2,0($a_surfaces)                    # 30o
        nop     $127                                    # 31e pairing
        lqd     $py_2,64($a_surfaces)                   # 31o
        fma     $cosine,$ny_2,$gy_2,$cosine             # 32e
        lqd     $leave,576($a_surfaces)                 # 32o
        lqd     $weight_2,512($a_rays)                  # 33o
        rotqbyi $a_rays_2,$site_2,4                     # 34o
        fma     $along,$dy_2,$ny_2,$along               # 35e
        lqd     $pixel_2,576($a_rays)                   # 35o
        fma     $along_plane,$dy_2,$gy_2,$along_plane   # 36e
        lqd     $nx_3,192($a_surfaces_2)                # 36o
        cgti    $keep_2,$mirror,0                       # 37e
        lqd     $gx,384($a_surfaces_2)                  # 37o
        fma     $cosine,$nz_2,$gz_2,$cosine             # 38e
        lqd     $ny_3,256($a_surfaces_2)                # 38o
        fma     $px_2,$leave,$gx_2,$px_2                # 39e
        lqd     $gy,448($a_surfaces_2)                  # 39o
        fma     $py_3,$leave,$gy_2,$py_2                # 40e
        lqd     $pz_2,128($a_surfaces_2)                # 40o
        fma     $along,$dz_2,$nz_2,$along               # 41e
        lqd     $mirror_2,0x400($a_surfaces_2)          # 41o
        fma     $along_plane,$dz_2,$gz_2,$along_plane   # 42e
        lqd     $px_3,0($a_surfaces_2)                  # 42o
        fma     $pz,$leave,$gz_2,$pz                    # 43e
        lqd     $py_4,64($a_surfaces_2)                 # 43o
        fm      $weight_2,$weight_2,$mirror             # 44e
        lqd     $leave_2,576($a_surfaces_2)             # 44o
        a       $a_rays_3,$a_rays_2,$row_2              # 45e
        lqd     $gz,512($a_surfaces_2)                  # 45o
        cgt     $light_2,$deepest,$pixel_2              # 46e
        lqd     $nz_3,320($a_surfaces_2)                # 46o
        fa      $twice,$along,$along                    # 47e
        lqd     $dx_3,192($a_rays_3)                    # 47o
        fm      $cosine_2,$nx_3,$gx                     # 48e
        lqd     $dy_3,256($a_rays_3)                    # 48o
        a       $pixel,$pixel_2,$k_chain                # 49e
        shufb   $even_2,$px_2,$pz,$m_last               # 49o
        fcgt    $light,$least,$weight_2                 # 50e
        shufb   $even_3,$px_2,$pz,$m_first              # 50o
        fma     $px_4,$leave_2,$gx,$px_3                # 51e
        shufb   $odd_2,$py_3,$weight_2,$m_first         # 51o
        andc    $keep_2,$keep_2,$light                  # 52e
        shufb   $odd_3,$py_3,$weight_2,$m_last          # 52o
        fnms    $off,$twice,$cosine,$along_plane        # 53e
        lqd     $dz_3,320($a_rays_3)                    # 53o
        fm      $along_2,$dx_3,$nx_3                    # 54e
        lqd     $weight_3,512($a_rays_3)                # 54o
        fm      $along_plane_2,$dx_3,$gx                # 55e
        shufb   $first_2,$even_3,$odd_2,$m_first        # 55o
        and     $keep_3,$keep_2,$light_2                # 56e
        shufb   $first2_2,$even_2,$odd_3,$m_first       # 56o
        fma     $cosine,$ny_3,$gy,$cosine_2             # 57e
        shufb   $first1_2,$even_3,$odd_2,$m_last        # 57o
        andi    $keep_3,$keep_3,32                      # 58e
        shufb   $first+3,$even_2,$odd_3,$m_last         # 58o
        cgti    $off,$off,0                             # 59e
        hbrr    next_row_back,next_row                  # 59o hint
        fma     $along_3,$dy_3,$ny_3,$along_2           # 60e
        rotqbyi $step_2,$keep_3,4                       # 60o
        selb    $along,$along_plane,$along,$off         # 61e
        lqd     $pixel_3,576($a_rays_3)                 # 61o
        selb    $nx_4,$gx_2,$nx_2,$off                  # 62e
        stqx    $first_2,$a_queue,$end                  # 62o
        fa      $twice,$along,$along                    # 63e
        rotqbyi $step_3,$keep_3,8                       # 63o
        selb    $ny_4,$gy_2,$ny_2,$off                  # 64e
        rotqbyi $step_4,$keep_3,12                      # 64o
        selb    $nz,$gz_2,$nz_2,$off                    # 65e
        fma     $along_plane,$dy_3,$gy,$along_plane_2   # 66e
        a       $end_2,$end,$keep_3                     # 67e
        fma     $pz_3,$leave_2,$gz,$pz_2                # 68e
        fnms    $rx_2,$twice,$nx_4,$dx_2                # 69e
        stqx    $first1_2,$a_queue,$end_2               # 69o
        fnms    $ry,$twice,$ny_4,$dy_2                  # 70e
        fnms    $rz_2,$twice,$nz,$dz_2                  # 71e
        a       $end_3,$end_2,$step_2                   # 72e
        fma     $py,$leave_2,$gy,$py_4                  # 73e
        fm      $weight_4,$weight_3,$mirror_2           # 74e
        stqx    $first2_2,$a_queue,$end_3               # 74o
        fm      $length,$rx_2,$rx_2                     # 75e
        shufb   $even,$px_4,$pz_3,$m_last               # 75o
        fma     $cosine,$nz_3,$gz,$cosine               # 76e
        shufb   $even_4,$px_4,$pz_3,$m_first            # 76o
        fma     $along,$dz_3,$nz_3,$along_3             # 77e
        fma     $along_plane,$dz_3,$gz,$along_plane     # 78e
        cgti    $keep_4,$mirror_2,0                     # 79e
        cgt     $light_3,$deepest,$pixel_3              # 80e
        fma     $length,$ry,$ry,$length                 # 81e
        a       $end_4,$end_3,$step_3                   # 82e
        fma     $length,$rz_2,$rz_2,$length             # 87e
        lnop                                            # 87o pairing
next_row:
        shli    $row,$at,2                              # 0e
            shufb   $odd,$py,$weight_4,$m_first         # 0o
            fa      $twice,$along,$along                # 1e
            shufb   $odd_4,$py,$weight_4,$m_last        # 1o
            fcgt    $light,$least,$weight_4             # 2e
        lqx     $site,$a_sites,$at                      # 2o
            fnms    $length,$length,$k_half,$k_three_halves # 3e
            stqx    $first+3,$a_queue,$end_4            # 3o
        ai      $at,$at,4                               # 4e
            shufb   $first,$even_4,$odd,$m_first        # 4o
        andi    $row,$row,48                            # 5e
            shufb   $first+2,$even,$odd_4,$m_first      # 5o
            andc    $keep,$keep_4,$light                # 6e
            shufb   $first+1,$even_4,$odd,$m_last       # 6o
            fnms    $off,$twice,$cosine,$along_plane    # 7e
            shufb   $first+3,$even,$odd_4,$m_last       # 7o
        a       $a_surfaces,$site,$row                  # 8e
        rotqbyi $a_rays,$site,4                         # 8o
            fm      $ry,$ry,$length                     # 9e
            lnop                                        # 9o pairing
            and     $keep,$keep,$light_3                # 10e
        lqd     $pz,128($a_surfaces)                    # 10o
            fm      $rx,$rx_2,$length                   # 11e
        lqd     $mirror,0x400($a_surfaces)              # 11o
            fm      $rz,$rz_2,$length                   # 12e
        lqd     $px,0($a_surfaces)                      # 12o
            cgti    $off,$off,0                         # 13e
        lqd     $py,64($a_surfaces)                     # 13o
        a       $a_rays,$a_rays,$row                    # 14e
        lqd     $leave,576($a_surfaces)                 # 14o
            selb    $nx,$gx,$nx_3,$off                  # 15e
            shufb   $odd,$ry,$pixel,$m_last             # 15o
            selb    $along,$along_plane,$along,$off     # 16e
        lqd     $nx_3,192($a_surfaces)                  # 16o
            selb    $ny,$gy,$ny_3,$off                  # 17e
            shufb   $odd_4,$ry,$pixel,$m_first          # 17o
            fa      $twice,$along,$along                # 18e
        lqd     $gx,384($a_surfaces)                    # 18o
            selb    $nz,$gz,$nz_3,$off                  # 19e
        lqd     $ny_3,256($a_surfaces)                  # 19o
            a       $pixel,$pixel_3,$k_chain            # 20e
        lqd     $nz_3,320($a_surfaces)                  # 20o
            andi    $keep,$keep,32                      # 21e
        lqd     $pixel_3,576($a_rays)                   # 21o
        cgti    $keep_4,$mirror,0                       # 22e
        lqd     $gz,512($a_surfaces)                    # 22o
        ai      $count,$count,-1                        # 23e
        lqd     $gy,448($a_surfaces)                    # 23o
        fm      $cosine,$nx_3,$gx                       # 24e
            shufb   $even,$rx,$rz,$m_first              # 24o
            fnms    $rx_2,$twice,$nx,$dx_3              # 25e
        lqd     $dx_3,192($a_rays)                      # 25o
            fnms    $rz_2,$twice,$nz,$dz_3              # 26e
        lqd     $dz_3,320($a_rays)                      # 26o
            fnms    $ry,$twice,$ny,$dy_3                # 27e
        lqd     $dy_3,256($a_rays)                      # 27o
        fma     $px,$leave,$gx,$px                      # 28e
        lqd     $weight_4,512($a_rays)                  # 28o
        cgt     $light_3,$deepest,$pixel_3              # 29e
            shufb   $second_2,$even,$odd_4,$m_first     # 29o
        fma     $py,$leave,$gy,$py                      # 30e
            shufb   $second+1,$even,$odd_4,$m_last      # 30o
        fm      $along,$dx_3,$nx_3                      # 31e
            rotqbyi $step_5,$keep,4                     # 31o
            fm      $length,$rx_2,$rx_2                 # 32e
            shufb   $even,$rx,$rz,$m_last               # 32o
        fma     $cosine,$ny_3,$gy,$cosine               # 33e
            stqx    $second_2,$a_second,$end            # 33o
            a       $end,$end_4,$step_4                 # 34e
            rotqbyi $step_4,$keep,12                    # 34o
        fm      $along_plane,$dx_3,$gx                  # 35e
            stqx    $second+1,$a_second,$end_2          # 35o
            a       $end_2,$end,$keep                   # 36e
            shufb   $second2_2,$even,$odd,$m_first      # 36o
        fma     $along,$dy_3,$ny_3,$along               # 37e
            shufb   $second3_2,$even,$odd,$m_last       # 37o
        fma     $pz,$leave,$gz,$pz                      # 38e
            rotqbyi $step_6,$keep,8                     # 38o
            fma     $length,$ry,$ry,$length             # 39e
            stqx    $first,$a_queue,$end                # 39o
        fm      $weight_4,$weight_4,$mirror             # 40e
            stqx    $second2_2,$a_second,$end_3         # 40o
        fma     $along_plane,$dy_3,$gy,$along_plane     # 41e
            stqx    $second3_2,$a_second,$end_4         # 41o
        fma     $cosine,$nz_3,$gz,$cosine               # 42e
            stqx    $first+1,$a_queue,$end_2            # 42o
        fma     $along,$dz_3,$nz_3,$along               # 43e
        lnop                                            # 43o pairing
            a       $end_3,$end_2,$step_5               # 44e
        shufb   $even,$px,$pz,$m_last                   # 44o
            fma     $length,$rz_2,$rz_2,$length         # 45e
        shufb   $even_4,$px,$pz,$m_first                # 45o
            a       $end_4,$end_3,$step_6               # 46e
            stqx    $first+2,$a_queue,$end_3            # 46o
        fma     $along_plane,$dz_3,$gz,$along_plane     # 47e
next_row_back:
        brnz    $count,next_row                         # 47o
next_row_drain:
        fa      $twice,$along,$along                    # 0e
        shufb   $odd,$py,$weight_4,$m_first             # 0o
        fnms    $length,$length,$k_half,$k_three_halves # 1e
        hbr     reflect_r16_return,$lr                  # 1o hint
        fcgt    $light,$least,$weight_4                 # 2e
        shufb   $odd_4,$py,$weight_4,$m_last            # 2o
        a       $pixel_4,$pixel_3,$k_chain              # 3e
        stqx    $first+3,$a_queue,$end_4                # 3o
        andc    $keep,$keep_4,$light                    # 4e
        shufb   $first,$even_4,$odd,$m_first            # 4o
        a       $end_5,$end_4,$step_4                   # 5e
        shufb   $first+1,$even_4,$odd,$m_last           # 5o
        fnms    $off,$twice,$cosine,$along_plane        # 6e
        shufb   $first+2,$even,$odd_4,$m_first          # 6o
        fm      $ry,$ry,$length                         # 7e
        shufb   $first+3,$even,$odd_4,$m_last           # 7o
        fm      $rx,$rx_2,$length                       # 8e
        fm      $rz,$rz_2,$length                       # 9e
        and     $keep,$keep,$light_3                    # 10e
        cgti    $off,$off,0                             # 12e
        andi    $keep,$keep,32                          # 13e
        shufb   $odd_4,$ry,$pixel,$m_first              # 13o
        selb    $along,$along_plane,$along,$off         # 14e
        shufb   $odd,$ry,$pixel,$m_last                 # 14o
        selb    $nx,$gx,$nx_3,$off                      # 15e
        shufb   $even,$rx,$rz,$m_first                  # 15o
        fa      $twice,$along,$along                    # 16e
        shufb   $even_5,$rx,$rz,$m_last                 # 16o
        selb    $ny,$gy,$ny_3,$off                      # 17e
        rotqbyi $step_7,$keep,4                         # 17o
        selb    $nz,$gz,$nz_3,$off                      # 18e
        rotqbyi $step_6,$keep,8                         # 18o
        a       $end_6,$end_5,$keep                     # 19e
        shufb   $second_2,$even,$odd_4,$m_first         # 19o
        nop     $127                                    # 20e pairing
        shufb   $second+1,$even,$odd_4,$m_last          # 20o
        a       $end_7,$end_6,$step_7                   # 21e
        shufb   $second2_3,$even_5,$odd,$m_first        # 21o
        fnms    $rx_2,$twice,$nx,$dx_3                  # 22e
        shufb   $second3_2,$even_5,$odd,$m_last         # 22o
        fnms    $ry,$twice,$ny,$dy_3                    # 23e
        stqx    $second_2,$a_second,$end                # 23o
        fnms    $rz_2,$twice,$nz,$dz_3                  # 24e
        stqx    $second+1,$a_second,$end_2              # 24o
        a       $end_8,$end_7,$step_6                   # 25e
        stqx    $first,$a_queue,$end_5                  # 25o
        stqx    $second2_3,$a_second,$end_3             # 26o
        stqx    $second3_2,$a_second,$end_4             # 27o
        fm      $length,$rx_2,$rx_2                     # 28e
        stqx    $first+1,$a_queue,$end_6                # 28o
        stqx    $first+2,$a_queue,$end_7                # 29o
        rotqbyi $step_4,$keep,12                        # 30o
        stqx    $first+3,$a_queue,$end_8                # 31o
        fma     $length,$ry,$ry,$length                 # 34e
        a       $end,$end_8,$step_4                     # 35e
        a       $3,$a_queue,$end                        # 37e
        fma     $length,$rz_2,$rz_2,$length             # 40e
        fnms    $length,$length,$k_half,$k_three_halves # 46e
        fm      $ry,$ry,$length                         # 52e
        fm      $rx,$rx_2,$length                       # 53e
        fm      $rz,$rz_2,$length                       # 54e
        shufb   $odd_5,$ry,$pixel_4,$m_first            # 58o
        shufb   $odd,$ry,$pixel_4,$m_last               # 59o
        shufb   $even,$rx,$rz,$m_first                  # 60o
        shufb   $even_6,$rx,$rz,$m_last                 # 61o
        shufb   $second_2,$even,$odd_5,$m_first         # 64o
        shufb   $second+1,$even,$odd_5,$m_last          # 65o
        shufb   $second2_4,$even_6,$odd,$m_first        # 66o
        shufb   $second3_2,$even_6,$odd,$m_last         # 67o
        stqx    $second_2,$a_second,$end_5              # 68o
        stqx    $second+1,$a_second,$end_6              # 69o
        stqx    $second2_4,$a_second,$end_7             # 70o
        stqx    $second3_2,$a_second,$end_8             # 71o
reflect_r16_return:
        bi      $lr                                     # 72o
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
        lnop                                            # 34o pairing
        cgt     $light_4,$deepest,$pixel                # 35e
        shufb   $odd,$py,$weight,$m_first               # 35o
        fa      $twice,$along,$along                    # 36e
        shufb   $odd_6,$py,$weight,$m_last              # 36o
        andc    $keep,$keep,$light                      # 37e
        lnop                                            # 37o pairing
        a       $pixel,$pixel,$k_chain                  # 38e
        shufb   $even,$px,$pz,$m_first                  # 38o
        and     $keep,$keep,$light_4                    # 39e
        shufb   $even_7,$px,$pz,$m_last                 # 39o
        andi    $keep,$keep,32                          # 41e
        lnop                                            # 41o pairing
        fnms    $off,$twice,$cosine,$along_plane        # 42e
        shufb   $first,$even,$odd,$m_first              # 42o
        a       $end_6,$end,$keep                       # 43e
        rotqbyi $step,$keep,4                           # 43o
        shufb   $first+1,$even,$odd,$m_last             # 44o
        rotqbyi $step_8,$keep,8                         # 45o
        nop     $127                                    # 46e pairing
        shufb   $first+2,$even_7,$odd_6,$m_first        # 46o
        a       $end_9,$end_6,$step                     # 47e
        shufb   $first+3,$even_7,$odd_6,$m_last         # 47o
        cgti    $off,$off,0                             # 48e
        stqx    $first,$a_queue,$end                    # 48o
        a       $end_7,$end_9,$step_8                   # 49e
        stqx    $first+1,$a_queue,$end_6                # 49o
        selb    $along,$along_plane,$along,$off         # 50e
        rotqbyi $step,$keep,12                          # 50o
        selb    $nx,$gx,$nx,$off                        # 51e
        stqx    $first+2,$a_queue,$end_9                # 51o
        fa      $twice,$along,$along                    # 52e
        stqx    $first+3,$a_queue,$end_7                # 52o
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
        shufb   $even_5,$rx,$rz,$m_last                 # 97o
        shufb   $odd_7,$ry,$pixel,$m_last               # 98o
        shufb   $second,$even,$odd,$m_first             # 100o
        shufb   $second+1,$even,$odd,$m_last            # 101o
        shufb   $second+2,$even_5,$odd_7,$m_first       # 102o
        shufb   $second+3,$even_5,$odd_7,$m_last        # 103o
        nop     $127                                    # 104e pairing
        stqx    $second,$a_second,$end                  # 104o
        a       $end,$end_7,$step                       # 105e
        stqx    $second+1,$a_second,$end_6              # 105o
        stqx    $second+2,$a_second,$end_9              # 106o
        stqx    $second+3,$a_second,$end_7              # 107o
        nop     $127                                    # 108e pairing
        brnz    $count,next_row_short                   # 108o
        a       $3,$a_queue,$end                        # 109e
        bi      $lr                                     # 109o
endfunction reflect_r16
