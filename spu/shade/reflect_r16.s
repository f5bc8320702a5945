# reflect_r16   rays that mirrors throw back, appended to a queue
#   C       struct queued *reflect_r16(const struct site *, int count, struct queued *);
#   In      $3 sites, $4 count (0 is none), $5 where the rays go: room for one more than
#           there may be; pointers 16-aligned
#   Out     a ray for each lane whose share `mirror` is above 0, in order; $3 their end
#   Uses    $2-$4, $6-$59, $79   Saves  -   Stack  0   Calls  -
#   Domain  directions and normals of length 1 within 4 ulp, normals on the ray's side
#   Error   5 ulp of 1, each component of a direction; where r.G is within 1e-5 of 0, either normal
#           may be taken; its length within 2
#   Twin    oracle/src/twin/reflect.rs
#
#   r = d - 2 (d.N) N, by the surface's own normal G where that does not leave it: r.G <= 0
# The ray starts at point + leave G.
# Scheduled by spu schedule from reflect_r16.s

        .include "work_unit.inc"
        .include "macros.inc"
        .include "bounce.inc"

        .set    mirror,53
        .set    along,54                                # d.N
        .set    along_plane,55                          # d.G
        .set    cosine,56                               # N.G
        .set    off,57                                  # r.G
        .set    twice,58

bounce_shuffles

function reflect_r16
        .set    count_2,79
        .set    row_2,2
        .set    site_2,3
        .set    nx_2,6
        .set    a_surfaces_2,7
        .set    gx_2,18
        .set    a_rays_2,19
        .set    ny_2,21
        .set    gy_2,25
        .set    dx_2,8
        .set    dy_2,26
        .set    dz_2,34
        .set    nz_2,32
        .set    gz_2,35
        .set    a_rays_3,3
        .set    nx_3,22
        .set    leave_2,9
        .set    dx_3,41
        .set    py_2,8
        .set    a_rays_4,23
        .set    pz_2,2
        .set    weight_2,3
        .set    dx_4,36
        .set    keep_2,20
        .set    ny_3,24
        .set    py_3,39
        .set    dy_3,30
        .set    along_2,40
        .set    dz_3,38
        .set    gz_3,33
        .set    keep_3,48
        .set    pz_3,9
        .set    cosine_2,20
        .set    along_plane_2,42
        .set    step_2,43
        .set    odd_2,45
        .set    end_2,47
        .set    even_2,46
        .set    odd_3,3
        .set    even_3,2
        .set    weight_3,20
        .set    first_2,49
        .set    first1_2,45
        .set    keep_4,19
        .set    along_3,7
        .set    nx_4,40
        .set    step_3,46
        .set    twice_2,45
        .set    first2_2,18
        .set    first3_2,6
        .set    nz_3,2
        .set    weight_4,7
        .set    rx_2,32
        .set    rz_2,21
        .set    end_3,59
        .set    end_4,2
        .set    step_4,3
        .set    odd_4,6
        .set    even_4,7
        .set    odd_5,8
        .set    odd_6,9
        .set    dx_5,18
        .set    even_5,19
        .set    even_6,25
        .set    py_4,26
        .set    keep_5,18
        .set    first1_3,19
        .set    weight_5,25
        .set    odd_7,2
        .set    end_5,4
        .set    step_5,7
        .set    end_6,8
        .set    odd_8,14
        .set    even_7,16
        .set    end_7,18
        .set    end_8,20
        .set    even_8,9
        .set    end_9,14
        .set    first2_3,6
        .set    first3_3,2
        .set    end_10,3
        .set    end_11,7
        ori     $a_sites,$3,0                           # 0e
        lnop                                            # 0o pairing

        ori     $3,$a_queue,0                           # 1e
        biz     $count,$lr                              # 1o

        shli    $count,$count,2                         # 2e
        lqa     $m_first,first_two                      # 2o

        ai      $a_second,$a_queue,16                   # 3e
        lqa     $m_last,last_two                        # 3o

        il      $at,0                                   # 4e
        il      $end,0                                  # 5e

        clgti   $count_2,$count,2                       # 6e at least as many passes as overlap
        ilhu    $k_half,0x3f00                          # 7e

        ilhu    $k_three_halves,0x3fc0                  # 8e
        brz     $count_2,next_row_short                 # 8o too few passes

        shli    $row,$at,2                              # 9e
        lqx     $site,$a_sites,$at                      # 9o

        ai      $at,$at,4                               # 10e
        ai      $count,$count,-1                        # 11e

        shli    $row_2,$at,2                            # 12e
        lqx     $site_2,$a_sites,$at                    # 12o

        andi    $row,$row,48                            # 13e
        ai      $at,$at,4                               # 14e

        a       $a_surfaces,$site,$row                  # 15e
        rotqbyi $a_rays,$site,4                         # 15o

        andi    $row_2,$row_2,48                        # 16e
        lnop                                            # 16o pairing

        ai      $count,$count,-1                        # 17e
        lqd     $nx_2,192($a_surfaces)                  # 17o

        a       $a_surfaces_2,$site_2,$row_2            # 18e
        lqd     $gx_2,384($a_surfaces)                  # 18o

        a       $a_rays_2,$a_rays,$row                  # 19e
        lqd     $ny_2,256($a_surfaces)                  # 19o

        lqd     $gy_2,448($a_surfaces)                  # 20o
        lqd     $dx_2,192($a_rays_2)                    # 21o

        lqd     $dy_2,256($a_rays_2)                    # 22o
        lqd     $dz_2,320($a_rays_2)                    # 23o

        fm      $cosine,$nx_2,$gx_2                     # 24e
        lqd     $nz_2,320($a_surfaces)                  # 24o

        lqd     $gz_2,512($a_surfaces)                  # 25o
        rotqbyi $a_rays_3,$site_2,4                     # 26o

        fm      $along,$dx_2,$nx_2                      # 27e
        lqd     $nx_3,192($a_surfaces_2)                # 27o

        fm      $along_plane,$dx_2,$gx_2                # 28e
        lqd     $leave_2,576($a_surfaces)               # 28o

        ori     $dx_3,$dx_2,0                           # 29e copy
        lqd     $mirror,0x400($a_surfaces)              # 29o

        fma     $cosine,$ny_2,$gy_2,$cosine             # 30e
        lqd     $py_2,64($a_surfaces)                   # 30o

        a       $a_rays_4,$a_rays_3,$row_2              # 31e
        lqd     $pz_2,128($a_surfaces)                  # 31o

        nop     $127                                    # 32e pairing
        lqd     $weight_2,512($a_rays_2)                # 32o

        fma     $along,$dy_2,$ny_2,$along               # 33e
        lqd     $dx_4,192($a_rays_4)                    # 33o

        fma     $along_plane,$dy_2,$gy_2,$along_plane   # 34e
        lqd     $px,0($a_surfaces)                      # 34o

        cgti    $keep_2,$mirror,0                       # 35e
        lqd     $gx,384($a_surfaces_2)                  # 35o

        fma     $cosine,$nz_2,$gz_2,$cosine             # 36e
        lqd     $ny_3,256($a_surfaces_2)                # 36o

        fma     $py_3,$leave_2,$gy_2,$py_2              # 37e
        lqd     $dy_3,256($a_rays_4)                    # 37o

        fma     $pz_2,$leave_2,$gz_2,$pz_2              # 38e
        lqd     $gy,448($a_surfaces_2)                  # 38o

        fma     $along_2,$dz_2,$nz_2,$along             # 39e
        lqd     $dz_3,320($a_rays_4)                    # 39o

        fma     $along_plane,$dz_2,$gz_2,$along_plane   # 40e
        lqd     $nz,320($a_surfaces_2)                  # 40o

        fm      $along,$dx_4,$nx_3                      # 41e
        lqd     $gz_3,512($a_surfaces_2)                # 41o

        fm      $weight_2,$weight_2,$mirror             # 42e
        lqd     $leave,576($a_surfaces_2)               # 42o

        fma     $px,$leave_2,$gx_2,$px                  # 43e
        lqd     $mirror,0x400($a_surfaces_2)            # 43o

        andi    $keep_3,$keep_2,32                      # 44e
        lqd     $py_2,64($a_surfaces_2)                 # 44o

        fa      $twice,$along_2,$along_2                # 45e
        lqd     $pz_3,128($a_surfaces_2)                # 45o

        fm      $cosine_2,$nx_3,$gx                     # 46e
        rotqbyi $step,$keep_3,8                         # 46o

        fm      $along_plane_2,$dx_4,$gx                # 47e
        rotqbyi $step_2,$keep_3,4                       # 47o

        fma     $along,$dy_3,$ny_3,$along               # 48e
        shufb   $odd_2,$py_3,$weight_2,$m_first         # 48o

        a       $end_2,$end,$keep_3                     # 49e
        shufb   $even_2,$px,$pz_2,$m_first              # 49o

        fma     $py_2,$leave,$gy,$py_2                  # 50e
        shufb   $odd_3,$py_3,$weight_2,$m_last          # 50o

        fnms    $off,$twice,$cosine,$along_plane        # 51e
        shufb   $even_3,$px,$pz_2,$m_last               # 51o

        fma     $cosine,$ny_3,$gy,$cosine_2             # 52e
        lqd     $weight_3,512($a_rays_4)                # 52o

        fma     $along_plane_2,$dy_3,$gy,$along_plane_2 # 53e
        shufb   $first_2,$even_2,$odd_2,$m_first        # 53o

        fma     $along,$dz_3,$nz,$along                 # 54e
        shufb   $first1_2,$even_2,$odd_2,$m_last        # 54o

        fma     $pz_3,$leave,$gz_3,$pz_3                # 55e
        lqd     $pixel,576($a_rays_2)                   # 55o

        cgti    $keep_4,$mirror,0                       # 56e
        lqd     $px,0($a_surfaces_2)                    # 56o

        cgti    $off,$off,0                             # 57e
        hbrr    next_row_back,next_row                  # 57o hint

        fma     $cosine,$nz,$gz_3,$cosine               # 58e
        stqx    $first_2,$a_queue,$end                  # 58o

        selb    $along_3,$along_plane,$along_2,$off     # 59e
        stqx    $first1_2,$a_queue,$end_2               # 59o

        selb    $nx_4,$gx_2,$nx_2,$off                  # 60e
        rotqbyi $step_3,$keep_3,12                      # 60o

        fa      $twice_2,$along_3,$along_3              # 61e
        shufb   $first2_2,$even_3,$odd_3,$m_first       # 61o

        selb    $ny_2,$gy_2,$ny_2,$off                  # 62e
        shufb   $first3_2,$even_3,$odd_3,$m_last        # 62o

        selb    $nz_3,$gz_2,$nz_2,$off                  # 63e
        fma     $along_plane,$dz_3,$gz_3,$along_plane_2 # 64e

        fa      $twice,$along,$along                    # 65e
        fm      $weight_4,$weight_3,$mirror             # 66e

        fnms    $rx_2,$twice_2,$nx_4,$dx_3              # 67e
        fnms    $ry,$twice_2,$ny_2,$dy_2                # 68e

        fnms    $rz_2,$twice_2,$nz_3,$dz_2              # 69e
        ori     $dx_3,$dx_4,0                           # 70e copy

        andi    $keep_3,$keep_4,32                      # 71e
        a       $end_3,$end_2,$step_2                   # 72e

        fm      $length,$rx_2,$rx_2                     # 73e
        fma     $length,$ry,$ry,$length                 # 79e

        fma     $length,$rz_2,$rz_2,$length             # 85e
        fnms    $length,$length,$k_half,$k_three_halves # 91e

next_row:
            fma     $px,$leave,$gx,$px                  # 0e
            stqx    $first2_2,$a_queue,$end_3           # 0o

            a       $end_4,$end_3,$step                 # 1e
            rotqbyi $step,$keep_3,8                     # 1o

        shli    $row,$at,2                              # 2e
        lqx     $site,$a_sites,$at                      # 2o

            fnms    $off,$twice,$cosine,$along_plane    # 3e
            stqx    $first3_2,$a_queue,$end_4           # 3o

        ai      $at,$at,4                               # 4e
            shufb   $odd,$py_2,$weight_4,$m_first       # 4o

            fm      $ry,$ry,$length                     # 5e
            rotqbyi $step_4,$keep_3,4                   # 5o

        andi    $row,$row,48                            # 6e
            shufb   $even,$px,$pz_3,$m_first            # 6o

            fm      $rz,$rz_2,$length                   # 7e
            shufb   $odd_4,$py_2,$weight_4,$m_last      # 7o

        a       $a_surfaces,$site,$row                  # 8e
        rotqbyi $a_rays,$site,4                         # 8o

            cgti    $off,$off,0                         # 9e
            shufb   $even_4,$px,$pz_3,$m_last           # 9o

        ai      $count,$count,-1                        # 10e
            shufb   $first,$even,$odd,$m_first          # 10o

            selb    $along,$along_plane,$along,$off     # 11e
            shufb   $odd_5,$ry,$pixel,$m_last           # 11o

            selb    $nx,$gx,$nx_3,$off                  # 12e
            shufb   $odd_6,$ry,$pixel,$m_first          # 12o

            fa      $twice,$along,$along                # 13e
            lqd     $pixel,576($a_rays_4)               # 13o

            selb    $ny,$gy,$ny_3,$off                  # 14e
        lqd     $nx_3,192($a_surfaces)                  # 14o

        a       $a_rays_4,$a_rays,$row                  # 15e
        lqd     $gx,384($a_surfaces)                    # 15o

            selb    $nz,$gz_3,$nz,$off                  # 16e
        lqd     $ny_3,256($a_surfaces)                  # 16o

            fm      $rx,$rx_2,$length                   # 17e
        lqd     $gy,448($a_surfaces)                    # 17o

        nop     $127                                    # 18e pairing
        lqd     $dx_5,192($a_rays_4)                    # 18o

            fnms    $ry,$twice,$ny,$dy_3                # 19e
        lqd     $dy_3,256($a_rays_4)                    # 19o

            fnms    $rx_2,$twice,$nx,$dx_3              # 20e
        lqd     $gz_3,512($a_surfaces)                  # 20o

        fm      $cosine,$nx_3,$gx                       # 21e
        lqd     $leave,576($a_surfaces)                 # 21o

            fnms    $rz_2,$twice,$nz,$dz_3              # 22e
        lqd     $dz_3,320($a_rays_4)                    # 22o

        nop     $127                                    # 23e pairing
        lqd     $mirror,0x400($a_surfaces)              # 23o

        fm      $along,$dx_5,$nx_3                      # 24e
            shufb   $even_5,$rx,$rz,$m_first            # 24o

        fm      $along_plane,$dx_5,$gx                  # 25e
            shufb   $even_6,$rx,$rz,$m_last             # 25o

            fm      $length,$rx_2,$rx_2                 # 26e
        lqd     $py_4,64($a_surfaces)                   # 26o

        ori     $dx_3,$dx_5,0                           # 27e copy
        lqd     $nz,320($a_surfaces)                    # 27o

        fma     $cosine,$ny_3,$gy,$cosine               # 28e
            shufb   $second,$even_5,$odd_6,$m_first     # 28o

        cgti    $keep_5,$mirror,0                       # 29e
            shufb   $second+2,$even_6,$odd_5,$m_first   # 29o

        fma     $along,$dy_3,$ny_3,$along               # 30e
            shufb   $second+1,$even_5,$odd_6,$m_last    # 30o

        fma     $along_plane,$dy_3,$gy,$along_plane     # 31e
            shufb   $second+3,$even_6,$odd_5,$m_last    # 31o

            fma     $length,$ry,$ry,$length             # 32e
            stqx    $second,$a_second,$end              # 32o

            a       $end,$end_4,$step_3                 # 33e
            rotqbyi $step_3,$keep_3,12                  # 33o

        fma     $py_2,$leave,$gy,$py_4                  # 34e
        lqd     $pz_3,128($a_surfaces)                  # 34o

        fma     $cosine,$nz,$gz_3,$cosine               # 35e
            stqx    $second+1,$a_second,$end_2          # 35o

        fma     $along,$dz_3,$nz,$along                 # 36e
            stqx    $second+2,$a_second,$end_3          # 36o

            a       $end_2,$end,$keep_3                 # 37e
            shufb   $first1_3,$even,$odd,$m_last        # 37o

            fma     $length,$rz_2,$rz_2,$length         # 38e
        lqd     $weight_5,512($a_rays_4)                # 38o

        andi    $keep_3,$keep_5,32                      # 39e
        lqd     $px,0($a_surfaces)                      # 39o

        fma     $pz_3,$leave,$gz_3,$pz_3                # 40e
            stqx    $first,$a_queue,$end                # 40o

        fma     $along_plane,$dz_3,$gz_3,$along_plane   # 41e
            shufb   $first2_2,$even_4,$odd_4,$m_first   # 41o

        fa      $twice,$along,$along                    # 42e
            shufb   $first3_2,$even_4,$odd_4,$m_last    # 42o

            a       $end_3,$end_2,$step_4               # 43e
            stqx    $first1_3,$a_queue,$end_2           # 43o

        fm      $weight_4,$weight_5,$mirror             # 44e
            stqx    $second+3,$a_second,$end_4          # 44o

            fnms    $length,$length,$k_half,$k_three_halves # 45e
next_row_back:
        brnz    $count,next_row                         # 45o

next_row_drain:
        fnms    $off,$twice,$cosine,$along_plane        # 0e
        stqx    $first2_2,$a_queue,$end_3               # 0o

        fm      $ry,$ry,$length                         # 1e
        shufb   $odd,$py_2,$weight_4,$m_first           # 1o

        fm      $rz,$rz_2,$length                       # 2e
        hbr     reflect_r16_return,$lr                  # 2o hint

        fm      $rx,$rx_2,$length                       # 3e
        shufb   $odd_7,$py_2,$weight_4,$m_last          # 3o

        fma     $px,$leave,$gx,$px                      # 4e
        rotqbyi $step_4,$keep_3,4                       # 4o

        a       $end_5,$end_3,$step                     # 5e
        rotqbyi $step,$keep_3,8                         # 5o

        cgti    $off,$off,0                             # 6e
        rotqbyi $step_5,$keep_3,12                      # 6o

        a       $end_6,$end_5,$step_3                   # 7e
        shufb   $odd_8,$ry,$pixel,$m_first              # 7o

        selb    $along,$along_plane,$along,$off         # 8e
        stqx    $first3_2,$a_queue,$end_5               # 8o

        selb    $nx,$gx,$nx_3,$off                      # 9e
        shufb   $even_5,$rx,$rz,$m_first                # 9o

        fa      $twice,$along,$along                    # 10e
        shufb   $odd_4,$ry,$pixel,$m_last               # 10o

        selb    $ny,$gy,$ny_3,$off                      # 11e
        lqd     $pixel,576($a_rays_4)                   # 11o

        selb    $nz,$gz_3,$nz,$off                      # 12e
        shufb   $even_7,$rx,$rz,$m_last                 # 12o

        a       $end_7,$end_6,$keep_3                   # 13e
        shufb   $even,$px,$pz_3,$m_first                # 13o

        nop     $127                                    # 14e pairing
        shufb   $second,$even_5,$odd_8,$m_first         # 14o

        a       $end_8,$end_7,$step_4                   # 15e
        shufb   $second+1,$even_5,$odd_8,$m_last        # 15o

        fnms    $rx_2,$twice,$nx,$dx_3                  # 16e
        shufb   $even_8,$px,$pz_3,$m_last               # 16o

        fnms    $ry,$twice,$ny,$dy_3                    # 17e
        shufb   $second+2,$even_7,$odd_4,$m_first       # 17o

        fnms    $rz_2,$twice,$nz,$dz_3                  # 18e
        shufb   $first,$even,$odd,$m_first              # 18o

        a       $end_9,$end_8,$step                     # 19e
        stqx    $second,$a_second,$end                  # 19o

        nop     $127                                    # 20e pairing
        shufb   $first1_3,$even,$odd,$m_last            # 20o

        a       $end,$end_9,$step_5                     # 21e
        shufb   $second+3,$even_7,$odd_4,$m_last        # 21o

        fm      $length,$rx_2,$rx_2                     # 22e
        stqx    $second+1,$a_second,$end_2              # 22o

        a       $3,$a_queue,$end                        # 23e
        stqx    $second+2,$a_second,$end_3              # 23o

        shufb   $first2_3,$even_8,$odd_7,$m_first       # 24o
        stqx    $first,$a_queue,$end_6                  # 25o

        shufb   $first3_3,$even_8,$odd_7,$m_last        # 26o
        stqx    $first1_3,$a_queue,$end_7               # 27o

        fma     $length,$ry,$ry,$length                 # 28e
        stqx    $second+3,$a_second,$end_5              # 28o

        stqx    $first2_3,$a_queue,$end_8               # 29o
        stqx    $first3_3,$a_queue,$end_9               # 30o

        fma     $length,$rz_2,$rz_2,$length             # 34e
        fnms    $length,$length,$k_half,$k_three_halves # 40e

        fm      $ry,$ry,$length                         # 46e
        fm      $rz,$rz_2,$length                       # 47e

        fm      $rx,$rx_2,$length                       # 48e
        shufb   $odd_6,$ry,$pixel,$m_first              # 52o

        shufb   $odd_7,$ry,$pixel,$m_last               # 53o
        shufb   $even_5,$rx,$rz,$m_first                # 54o

        shufb   $even_6,$rx,$rz,$m_last                 # 55o
        shufb   $second,$even_5,$odd_6,$m_first         # 58o

        shufb   $second+1,$even_5,$odd_6,$m_last        # 59o
        shufb   $second+2,$even_6,$odd_7,$m_first       # 60o

        shufb   $second+3,$even_6,$odd_7,$m_last        # 61o
        stqx    $second,$a_second,$end_6                # 62o

        stqx    $second+1,$a_second,$end_7              # 63o
        stqx    $second+2,$a_second,$end_8              # 64o

        stqx    $second+3,$a_second,$end_9              # 65o
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
        lqd     $px,0($a_surfaces)                      # 17o

        fm      $along,$dx,$nx                          # 18e
        lqd     $py,64($a_surfaces)                     # 18o

        fm      $along_plane,$dx,$gx                    # 19e
        lqd     $pz,128($a_surfaces)                    # 19o

        nop     $127                                    # 20e pairing
        lqd     $leave,576($a_surfaces)                 # 20o

        fma     $cosine,$ny,$gy,$cosine                 # 21e
        lqd     $weight,512($a_rays)                    # 21o

        lqd     $mirror,0x400($a_surfaces)              # 22o
        lqd     $pixel,576($a_rays)                     # 23o

        fma     $along,$dy,$ny,$along                   # 24e
        fma     $along_plane,$dy,$gy,$along_plane       # 25e

        fma     $px,$leave,$gx,$px                      # 26e
        fma     $cosine,$nz,$gz,$cosine                 # 27e

        fma     $py,$leave,$gy,$py                      # 28e
        fma     $pz,$leave,$gz,$pz                      # 29e

        fma     $along,$dz,$nz,$along                   # 30e
        fma     $along_plane,$dz,$gz,$along_plane       # 31e

        fm      $weight,$weight,$mirror                 # 32e
        cgti    $keep,$mirror,0                         # 33e

        andi    $keep,$keep,32                          # 35e
        shufb   $even,$px,$pz,$m_first                  # 35o

        fa      $twice,$along,$along                    # 36e
        shufb   $even_3,$px,$pz,$m_last                 # 36o

        a       $end_10,$end,$keep                      # 37e
        rotqbyi $step,$keep,4                           # 37o

        shufb   $odd,$py,$weight,$m_first               # 38o
        shufb   $odd_4,$py,$weight,$m_last              # 39o

        nop     $127                                    # 40e pairing
        rotqbyi $step_5,$keep,8                         # 40o

        a       $end_6,$end_10,$step                    # 41e
        rotqbyi $step,$keep,12                          # 41o

        fnms    $off,$twice,$cosine,$along_plane        # 42e
        shufb   $first,$even,$odd,$m_first              # 42o

        nop     $127                                    # 43e pairing
        shufb   $first+1,$even,$odd,$m_last             # 43o

        a       $end_11,$end_6,$step_5                  # 44e
        shufb   $first+2,$even_3,$odd_4,$m_first        # 44o

        shufb   $first+3,$even_3,$odd_4,$m_last         # 45o
        stqx    $first,$a_queue,$end                    # 46o

        nop     $127                                    # 47e pairing
        stqx    $first+1,$a_queue,$end_10               # 47o

        cgti    $off,$off,0                             # 48e
        stqx    $first+2,$a_queue,$end_6                # 48o

        stqx    $first+3,$a_queue,$end_11               # 49o
        selb    $along,$along_plane,$along,$off         # 50e

        selb    $nx,$gx,$nx,$off                        # 51e
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

        shufb   $even_3,$rx,$rz,$m_last                 # 97o
        shufb   $odd_4,$ry,$pixel,$m_last               # 98o

        shufb   $second,$even,$odd,$m_first             # 100o
        shufb   $second+1,$even,$odd,$m_last            # 101o

        shufb   $second+2,$even_3,$odd_4,$m_first       # 102o
        shufb   $second+3,$even_3,$odd_4,$m_last        # 103o

        nop     $127                                    # 104e pairing
        stqx    $second,$a_second,$end                  # 104o

        a       $end,$end_11,$step                      # 105e
        stqx    $second+1,$a_second,$end_10             # 105o

        stqx    $second+2,$a_second,$end_6              # 106o
        stqx    $second+3,$a_second,$end_11             # 107o

        nop     $127                                    # 108e pairing
        brnz    $count,next_row_short                   # 108o

        a       $3,$a_queue,$end                        # 109e
        bi      $lr                                     # 109o
endfunction reflect_r16
