# refract_r16   rays that surfaces let through, appended to a queue; what they don't, to the mirror
#   C       struct queued *refract_r16(const struct site *, int count, struct queued *);
#   In      $3 sites, $4 count (0 is none), $5 where the rays go: room for one more than
#           there may be; pointers 16-aligned
#   Out     a ray for each lane that lets something through, in order; surfaces' mirror: T F more;
#           $3 the rays' end
#   Uses    $2-$4, $6-$79   Saves  -   Stack  0   Calls  -
#   Domain  directions and normals of length 1 within 4 ulp, normals on the ray's side; ratio from
#           1/4 to 4
#   Error   20 ulp of 1, each component of a direction, where the cosine beyond is above 0.1; below
#           it, 2 ulp over the cosine; where its square is below 16 ulp, all may be reflected or
#           not; its length within 2
#   Twin    oracle/src/twin/refract.rs
#
# For the ratio e, by the normal N:
#   s = e (d - (d.N) N)   along the surface: its length is the sine beyond
#   k = 1 - s.s           below 0: all is reflected, F = 1
#   r = s - sqrt(k) N     by the surface's own normal G where that does not cross it: r.G >= 0
#   F = schlick + grazing (1 - c)^5, c the cosine in the thinner medium: -d.N or sqrt(k)
# 1 - cosine^2 would lose the sine of a steep ray. The ray starts at point - leave G.
# Scheduled by spu schedule from refract_r16.s

        .include "work_unit.inc"
        .include "macros.inc"
        .include "math.inc"
        .include "bounce.inc"

        .set    k_one,53
        .set    transmittance,54
        .set    ratio,55
        .set    schlick,56
        .set    grazing,57
        .set    mirror,58
        .set    along,59                                # d.N
        .set    k,60
        .set    beyond,61
        .set    side,62                                 # r.G
        .set    cosine,63                               # N.G
        .set    wrong,64
        .set    taken,65                                # d.N of the normal taken
        .set    away,66                                 # 1 - c on this side
        .set    off,67                                  # 1 - c
        .set    fifth,68
        .set    share,69                                # F
        .set    through,70
        .set    total,71
        .set    thicker,72
        .set    t_y,73
        .set    t_s,74
        .set    ux,75                                   # s
        .set    uy,76
        .set    uz,77

# s, k and sqrt(k) by n, where along is d.n.
.macro  beyond_by along:req
    .irp axis, x,y,z
        fnms    $u\axis,\along,$n\axis,$d\axis
        fm      $u\axis,$u\axis,$ratio
    .endr
        fnms    $k,$ux,$ux,$k_one
        fnms    $k,$uy,$uy,$k
        fnms    $k,$uz,$uz,$k
        sqrt_f4 $beyond,$k,$t_y,$t_s,$k_half
.endm

bounce_shuffles

function refract_r16
        .set    count_2,79
        .set    row_2,2
        .set    site_2,3
        .set    a_surfaces_2,6
        .set    ny_2,7
        .set    a_rays_2,8
        .set    nz_2,19
        .set    ratio_2,18
        .set    dx_2,9
        .set    dy_2,21
        .set    dz_2,22
        .set    gz_2,31
        .set    a_rays_3,3
        .set    gx_2,23
        .set    nx_2,24
        .set    dx_3,34
        .set    a_rays_4,2
        .set    nx_3,3
        .set    gy_2,27
        .set    dx_4,26
        .set    ny_3,32
        .set    dy_3,35
        .set    ny_4,33
        .set    dy_4,30
        .set    gz_3,36
        .set    nz_3,38
        .set    along_2,37
        .set    dz_3,39
        .set    dz_4,40
        .set    cosine_2,54
        .set    nz_4,45
        .set    ratio_3,41
        .set    ux_2,9
        .set    gx_3,25
        .set    uy_2,7
        .set    px_2,21
        .set    gy_3,19
        .set    along_3,22
        .set    pz_2,37
        .set    gx_4,42
        .set    py_2,47
        .set    gz_4,43
        .set    leave_2,44
        .set    gy_4,18
        .set    a_surfaces_3,22
        .set    a_surfaces_4,46
        .set    grazing_2,48
        .set    k_2,49
        .set    transmittance_2,6
        .set    py_3,19
        .set    weight_2,28
        .set    gz_5,47
        .set    uy_3,26
        .set    gy_5,50
        .set    uz_2,30
        .set    py_4,40
        .set    leave_3,52
        .set    a_surfaces_5,29
        .set    pz_3,57
        .set    ux_3,7
        .set    a_surfaces_6,60
        .set    uy_4,46
        .set    pixel_2,8
        .set    uz_3,61
        .set    away_2,9
        .set    k_3,64
        .set    nx_4,30
        .set    side_2,3
        .set    a_surfaces_7,65
        .set    schlick_2,37
        .set    k_4,26
        .set    grazing_3,41
        .set    nz_5,42
        .set    t_y_2,25
        .set    py_5,51
        .set    px_3,33
        .set    transmittance_3,43
        .set    k_5,6
        .set    pz_4,56
        .set    gx_5,26
        .set    a_surfaces_8,44
        .set    weight_3,46
        .set    gx_6,18
        .set    k_6,45
        .set    gz_6,6
        .set    py_6,48
        .set    t_s_2,22
        .set    a_surfaces_9,49
        .set    t_y_3,19
        .set    even_2,50
        .set    gy_6,31
        .set    px_4,78
        .set    gz_7,40
        .set    pz_5,61
        .set    t_y_4,52
        .set    grazing_4,47
        .set    beyond_2,29
        .set    even_3,57
        .set    pixel_3,74
        .set    t_y_5,6
        .set    a_surfaces_10,52
        .set    beyond_3,8
        .set    beyond_4,3
        .set    nx_5,6
        .set    ny_5,8
        .set    nx_6,32
        .set    uz_4,19
        .set    uz_5,25
        .set    t_s_3,18
        .set    dx_5,3
        .set    dy_5,8
        .set    dz_5,18
        .set    a_surfaces_11,21
        .set    ux_4,3
        .set    uy_5,6
        .set    a_surfaces_12,8
        .set    px_5,22
        .set    gy_7,23
        .set    pz_6,24
        .set    weight_4,19
        .set    gx_7,38
        .set    gz_8,18
        .set    leave_4,3
        .set    odd_2,28
        .set    odd_3,19
        .set    first3_2,8
        .set    first2_2,6
        .set    keep_2,28
        .set    first1_2,29
        .set    first_2,19
        .set    step_2,23
        .set    step_3,31
        .set    step_4,47
        .set    end_2,28
        .set    odd_4,29
        .set    end_3,23
        .set    odd_5,35
        .set    even_4,3
        .set    end_4,6
        .set    even_5,21
        .set    second2_2,24
        .set    second_2,34
        .set    second1_2,21
        .set    second3_2,3
        .set    away_3,3
        .set    grazing_5,4
        .set    length_2,6
        .set    even_6,8
        .set    nx_7,9
        .set    a_surfaces_13,14
        .set    even_7,7
        .set    schlick_3,16
        .set    weight_5,6
        .set    py_7,2
        .set    transmittance_4,18
        .set    pixel_4,19
        .set    uz_6,9
        .set    odd_6,9
        .set    weight_6,20
        .set    even_8,22
        .set    end_5,9
        .set    odd_7,24
        .set    second3_3,26
        .set    first_3,28
        .set    first1_3,24
        .set    end_6,30
        .set    odd_8,20
        .set    first3_3,22
        .set    first2_3,20
        .set    t_s_4,20
        .set    beyond_5,9
        .set    odd_9,3
        .set    even_9,4
        .set    keep_3,6
        .set    odd_10,2
        .set    first1_4,3
        .set    second3_4,4
        .set    end_7,7
        .set    gz_9,2
        .set    gy_8,6
        .set    dy_6,7
        .set    gx_8,8
        .set    ratio_4,9
        .set    gx_9,34
        .set    pz_7,21
        .set    even_10,19
        .set    even_11,6
        .set    odd_11,8
        .set    step_5,18
        .set    step_6,2
        .set    end_8,2
        .set    end_9,3
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
        lnop                                            # 8o pairing

        ilhu    $k_one,0x3f80                           # 9e
        brz     $count_2,next_row_short                 # 9o too few passes

        shli    $row,$at,2                              # 10e
        lqx     $site,$a_sites,$at                      # 10o

        ai      $at,$at,4                               # 11e
        ai      $count,$count,-1                        # 12e

        shli    $row_2,$at,2                            # 13e
        lqx     $site_2,$a_sites,$at                    # 13o

        andi    $row,$row,48                            # 14e
        ai      $at,$at,4                               # 15e

        a       $a_surfaces_2,$site,$row                # 16e
        rotqbyi $a_rays,$site,4                         # 16o

        andi    $row_2,$row_2,48                        # 17e
        lnop                                            # 17o pairing

        ai      $count,$count,-1                        # 18e
        lqd     $nx,192($a_surfaces_2)                  # 18o

        a       $a_surfaces,$site_2,$row_2              # 19e
        lqd     $ny_2,256($a_surfaces_2)                # 19o

        a       $a_rays_2,$a_rays,$row                  # 20e
        lqd     $nz_2,320($a_surfaces_2)                # 20o

        lqd     $ratio_2,0x480($a_surfaces_2)           # 21o
        lqd     $dx_2,192($a_rays_2)                    # 22o

        lqd     $dy_2,256($a_rays_2)                    # 23o
        lqd     $dz_2,320($a_rays_2)                    # 24o

        lqd     $gx,384($a_surfaces_2)                  # 25o
        lqd     $gy,448($a_surfaces_2)                  # 26o

        nop     $127                                    # 27e pairing
        lqd     $gz_2,512($a_surfaces_2)                # 27o

        fm      $along,$dx_2,$nx                        # 28e
        rotqbyi $a_rays_3,$site_2,4                     # 28o

        lqd     $gx_2,384($a_surfaces_2)                # 29o
        shlqbyi $nx_2,$nx,0                             # 30o copy

        fm      $cosine,$nx,$gx                         # 31e
        lqd     $dx_3,192($a_rays_2)                    # 31o

        a       $a_rays_4,$a_rays_3,$row_2              # 32e
        lqd     $nx_3,192($a_surfaces)                  # 32o

        nop     $127                                    # 33e pairing
        lqd     $gy_2,448($a_surfaces_2)                # 33o

        fma     $along,$dy_2,$ny_2,$along               # 34e
        lqd     $dx_4,192($a_rays_4)                    # 34o

        shlqbyi $ny_3,$ny_2,0                           # 35o copy
        lqd     $dy_3,256($a_rays_2)                    # 36o

        fma     $cosine,$ny_2,$gy,$cosine               # 37e
        lqd     $ny_4,256($a_surfaces)                  # 37o

        lqd     $dy_4,256($a_rays_4)                    # 38o
        lqd     $gz_3,512($a_surfaces_2)                # 39o

        fma     $along,$dz_2,$nz_2,$along               # 40e
        shlqbyi $nz_3,$nz_2,0                           # 40o copy

        fm      $along_2,$dx_4,$nx_3                    # 41e
        lqd     $dz_3,320($a_rays_2)                    # 41o

        nop     $127                                    # 42e pairing
        lqd     $dz_4,320($a_rays_4)                    # 42o

        fma     $cosine_2,$nz_2,$gz_2,$cosine           # 43e
        lqd     $nz_4,320($a_surfaces)                  # 43o

        lqd     $ratio,0x480($a_surfaces_2)             # 44o
        lqd     $ratio_3,0x480($a_surfaces)             # 45o

        fnms    $ux_2,$along,$nx,$dx_2                  # 46e
        lqd     $gx_3,384($a_surfaces)                  # 46o

        fnms    $uy_2,$along,$ny_2,$dy_2                # 47e
        lqd     $px_2,0($a_surfaces_2)                  # 47o

        fnms    $uz,$along,$nz_2,$dz_2                  # 48e
        lqd     $gy_3,448($a_surfaces_2)                # 48o

        fma     $along_3,$dy_4,$ny_4,$along_2           # 49e
        lqd     $pz_2,128($a_surfaces_2)                # 49o

        fa      $away,$k_one,$along                     # 50e
        lqd     $gx_4,384($a_surfaces_2)                # 50o

        fcgt    $thicker,$ratio,$k_one                  # 51e
        lqd     $py_2,64($a_surfaces_2)                 # 51o

        fm      $ux_2,$ux_2,$ratio_2                    # 52e
        lqd     $gz_4,512($a_surfaces_2)                # 52o

        fm      $uy_2,$uy_2,$ratio_2                    # 53e
        lqd     $leave_2,576($a_surfaces_2)             # 53o

        fm      $uz,$uz,$ratio_2                        # 54e
        lqd     $gy_4,448($a_surfaces)                  # 54o

        fma     $along,$dz_4,$nz_4,$along_3             # 55e
        shlqbyi $a_surfaces_3,$a_surfaces_2,0           # 55o copy

        fm      $cosine,$nx_3,$gx_3                     # 56e
        shlqbyi $a_surfaces_4,$a_surfaces_2,0           # 56o copy

        nop     $127                                    # 57e pairing
        lqd     $grazing_2,0x500($a_surfaces_2)         # 57o

        fnms    $k_2,$ux_2,$ux_2,$k_one                 # 58e
        lqd     $schlick,0x4c0($a_surfaces_2)           # 58o

        fm      $side,$ux_2,$gx                         # 59e
        lqd     $transmittance_2,0x440($a_surfaces_2)   # 59o

        fnms    $py_3,$leave_2,$gy_3,$py_2              # 60e
        lqd     $weight_2,512($a_rays_2)                # 60o

        fnms    $ux_2,$along,$nx_3,$dx_4                # 61e
        lqd     $gz_5,512($a_surfaces)                  # 61o

        fnms    $uy_3,$along,$ny_4,$dy_4                # 62e
        lqd     $gy_5,448($a_surfaces)                  # 62o

        fnms    $uz_2,$along,$nz_4,$dz_4                # 63e
        lqd     $py_4,64($a_surfaces)                   # 63o

        fnms    $k_2,$uy_2,$uy_2,$k_2                   # 64e
        lqd     $leave_3,576($a_surfaces)               # 64o

        fma     $side,$uy_2,$gy,$side                   # 65e
        shlqbyi $a_surfaces_5,$a_surfaces_4,0           # 65o copy

        fnms    $pz_3,$leave_2,$gz_4,$pz_2              # 66e
        shlqbyi $a_surfaces_3,$a_surfaces_3,0           # 66o copy

        fm      $ux_3,$ux_2,$ratio_3                    # 67e
        shlqbyi $a_surfaces_6,$a_surfaces,0             # 67o copy

        fm      $uy_4,$uy_3,$ratio_3                    # 68e
        lqd     $pixel_2,576($a_rays_2)                 # 68o

        fm      $uz_3,$uz_2,$ratio_3                    # 69e
        shlqbyi $away_2,$away,0                         # 69o copy

        fnms    $k_3,$uz,$uz,$k_2                       # 70e
        shlqbyi $nx_4,$nx_3,0                           # 70o copy

        fma     $side_2,$uz,$gz_2,$side                 # 71e
        shlqbyi $a_surfaces_7,$a_surfaces,0             # 71o copy

        fnms    $px_2,$leave_2,$gx_4,$px_2              # 72e
        shlqbyi $schlick_2,$schlick,0                   # 72o copy

        fnms    $k_4,$ux_3,$ux_3,$k_one                 # 73e
        shlqbyi $grazing_3,$grazing_2,0                 # 73o copy

        fm      $side,$ux_3,$gx_3                       # 74e
        shlqbyi $ny_2,$ny_4,0                           # 74o copy

        fma     $cosine,$ny_4,$gy_4,$cosine             # 75e
        shlqbyi $nz_5,$nz_4,0                           # 75o copy

        fa      $away,$k_one,$along                     # 76e
        frsqest $t_y_2,$k_3                             # 76o

        fnms    $py_5,$leave_3,$gy_5,$py_4              # 77e
        lqd     $px_3,0($a_surfaces)                    # 77o

        nop     $127                                    # 78e pairing
        shlqbyi $transmittance_3,$transmittance_2,0     # 78o copy

        fnms    $k_5,$uy_4,$uy_4,$k_4                   # 79e
        lqd     $pz_4,128($a_surfaces)                  # 79o

        fi      $t_y_2,$k_3,$t_y_2                      # 80e
        lqd     $gx_5,384($a_surfaces)                  # 80o

        nop     $127                                    # 81e pairing
        shlqbyi $a_surfaces_8,$a_surfaces_3,0           # 81o copy

        fma     $side,$uy_4,$gy_4,$side                 # 82e
        lqd     $mirror,0x400($a_surfaces_5)            # 82o

        fma     $cosine,$nz_4,$gz_5,$cosine             # 83e
        shlqbyi $weight_3,$weight_2,0                   # 83o copy

        nop     $127                                    # 84e pairing
        lqd     $gx_6,384($a_surfaces)                  # 84o

        fnms    $k_6,$uz_3,$uz_3,$k_5                   # 85e
        lqd     $gz_6,512($a_surfaces)                  # 85o

        nop     $127                                    # 86e pairing
        shlqbyi $py_6,$py_3,0                           # 86o copy

        fm      $t_s_2,$k_3,$t_y_2                      # 87e
        shlqbyi $a_surfaces_9,$a_surfaces_6,0           # 87o copy

        fm      $t_y_3,$t_y_2,$k_half                   # 88e
        shufb   $even_2,$px_2,$pz_3,$m_first            # 88o

        fma     $side,$uz_3,$gz_5,$side                 # 89e
        lqd     $gy_6,448($a_surfaces)                  # 89o

        fnms    $px_4,$leave_3,$gx_6,$px_3              # 90e
        lqd     $gz_7,512($a_surfaces)                  # 90o

        fnms    $pz_5,$leave_3,$gz_6,$pz_4              # 91e
        frsqest $t_y_4,$k_6                             # 91o

        nop     $127                                    # 92e pairing
        lqd     $grazing_4,0x500($a_surfaces)           # 92o

        fnms    $beyond_2,$t_s_2,$t_s_2,$k_3            # 93e
        shufb   $even_3,$px_2,$pz_3,$m_last             # 93o

        nop     $127                                    # 94e pairing
        shlqbyi $pixel_3,$pixel_2,0                     # 94o copy

        fi      $t_y_5,$k_6,$t_y_4                      # 95e
        shlqbyi $a_surfaces_10,$a_surfaces_7,0          # 95o copy

        fma     $beyond_3,$beyond_2,$t_y_3,$t_s_2       # 99e
        fm      $t_s_2,$k_6,$t_y_5                      # 102e

        fm      $t_y_3,$t_y_5,$k_half                   # 103e
        fnms    $side_2,$beyond_3,$cosine_2,$side_2     # 105e

        fnms    $beyond_2,$t_s_2,$t_s_2,$k_6            # 108e
        or      $side_2,$side_2,$k_3                    # 111e

        cgti    $wrong,$side_2,-1                       # 113e neither is below 0
        fma     $beyond_4,$beyond_2,$t_y_3,$t_s_2       # 114e

        selb    $nx_5,$nx_2,$gx_2,$wrong                # 115e
        selb    $ny_5,$ny_3,$gy_2,$wrong                # 116e

        fm      $taken,$dx_3,$nx_5                      # 117e
        shlqbyi $nx_6,$nx_5,0                           # 117o copy

        selb    $nz,$nz_3,$gz_3,$wrong                  # 118e
        shlqbyi $ny_4,$ny_5,0                           # 118o copy

        fma     $taken,$dy_3,$ny_5,$taken               # 123e
        fma     $taken,$dz_3,$nz,$taken                 # 129e

        fnms    $ux,$taken,$nx_5,$dx_3                  # 135e
        fnms    $uy,$taken,$ny_5,$dy_3                  # 136e

        fnms    $uz_4,$taken,$nz,$dz_3                  # 137e
        fm      $ux,$ux,$ratio                          # 141e

        fm      $uy,$uy,$ratio                          # 142e
        fm      $uz_5,$uz_4,$ratio                      # 143e

        fnms    $k,$ux,$ux,$k_one                       # 147e
        fnms    $k,$uy,$uy,$k                           # 153e

        fnms    $k,$uz_5,$uz_5,$k                       # 159e
        lnop                                            # 159o pairing

        rotmai  $total,$k,-31                           # 165e
        frsqest $t_y,$k                                 # 165o

        fi      $t_y,$k,$t_y                            # 169e
        hbrr    next_row_back,next_row                  # 169o hint

        fm      $t_s_3,$k,$t_y                          # 176e
        fm      $t_y,$t_y,$k_half                       # 177e

        fnms    $beyond_3,$t_s_3,$t_s_3,$k              # 182e
        fma     $beyond_3,$beyond_3,$t_y,$t_s_3         # 188e

next_row:
        shli    $row,$at,2                              # 0e
        lqx     $site,$a_sites,$at                      # 0o

            fnms    $rz,$beyond_3,$nz,$uz_5             # 1e
            lqd     $dz,320($a_rays_4)                  # 1o

            fs      $off,$k_one,$beyond_3               # 2e
            lqd     $schlick,0x4c0($a_surfaces)         # 2o

        ai      $at,$at,4                               # 3e
            lqd     $transmittance,0x440($a_surfaces)   # 3o

            fnms    $rx,$beyond_3,$nx_6,$ux             # 4e
            lqd     $dy,256($a_rays_4)                  # 4o

            fnms    $side,$beyond_4,$cosine,$side       # 5e
            lqd     $ratio,0x480($a_surfaces)           # 5o

        andi    $row,$row,48                            # 6e
        rotqbyi $a_rays,$site,4                         # 6o

            fnms    $ry,$beyond_3,$ny_4,$uy             # 7e
            lqd     $dx,192($a_rays_4)                  # 7o

        a       $a_surfaces,$site,$row                  # 8e
            lqd     $weight,512($a_rays_4)              # 8o

            selb    $off,$away_2,$off,$thicker          # 9e
            lqd     $pixel,576($a_rays_4)               # 9o

        a       $a_rays_4,$a_rays,$row                  # 10e
            or      $side,$side,$k_6                    # 11e

            fcgt    $thicker,$ratio,$k_one              # 12e
        lqd     $nx,192($a_surfaces)                    # 12o

            cgti    $wrong,$side,-1                     # 13e neither is below 0
        lqd     $dx_5,192($a_rays_4)                    # 13o

            fm      $fifth,$off,$off                    # 14e
            lnop                                        # 14o pairing

            selb    $nx_5,$nx_4,$gx_5,$wrong            # 15e
        lqd     $gx,384($a_surfaces)                    # 15o

            selb    $ny,$ny_2,$gy_6,$wrong              # 16e
            fm      $taken,$dx,$nx_5                    # 17e

            selb    $nz,$nz_5,$gz_7,$wrong              # 18e
        lqd     $ny_2,256($a_surfaces)                  # 18o

        fm      $along,$dx_5,$nx                        # 19e
        lqd     $dy_5,256($a_rays_4)                    # 19o

            fm      $length,$rx,$rx                     # 20e
        lqd     $gy,448($a_surfaces)                    # 20o

        fm      $cosine,$nx,$gx                         # 21e
            shlqbyi $away_2,$away,0                     # 21o copy

            fm      $fifth,$fifth,$fifth                # 22e
            lnop                                        # 22o pairing

            fma     $taken,$dy,$ny,$taken               # 23e
        shlqbyi $nx_4,$nx,0                             # 23o copy

        ai      $count,$count,-1                        # 24e
        lqd     $dz_5,320($a_rays_4)                    # 24o

        fma     $along,$dy_5,$ny_2,$along               # 25e
        lqd     $nz_2,320($a_surfaces)                  # 25o

            fma     $length,$ry,$ry,$length             # 26e
        shlqbyi $a_surfaces_11,$a_surfaces,0            # 26o copy

        fma     $cosine,$ny_2,$gy,$cosine               # 27e
        lqd     $gz_2,512($a_surfaces)                  # 27o

            fm      $fifth,$fifth,$off                  # 28e
            shlqbyi $nx_6,$nx_5,0                       # 28o copy

            fma     $taken,$dz,$nz,$taken               # 29e
            shlqbyi $ny_4,$ny,0                         # 29o copy

        fma     $along,$dz_5,$nz_2,$along               # 31e
            fma     $length,$rz,$rz,$length             # 32e

        fma     $cosine,$nz_2,$gz_2,$cosine             # 33e
            fma     $share,$fifth,$grazing_3,$schlick_2 # 34e

            fnms    $ux,$taken,$nx_5,$dx                # 35e
            shlqbyi $schlick_2,$schlick,0               # 35o copy

            fnms    $uy,$taken,$ny,$dy                  # 36e
            shlqbyi $grazing_3,$grazing_4,0             # 36o copy

        fnms    $ux_4,$along,$nx,$dx_5                  # 37e
        lnop                                            # 37o pairing

        fnms    $uy_5,$along,$ny_2,$dy_5                # 38e
        shlqbyi $a_surfaces_12,$a_surfaces,0            # 38o copy

        fnms    $uz,$along,$nz_2,$dz_5                  # 39e
        lqd     $ratio_2,0x480($a_surfaces)             # 39o

            selb    $share,$share,$k_one,$total         # 40e
        shlqbyi $ny_2,$ny_2,0                           # 40o copy

            fm      $ux,$ux,$ratio                      # 41e
        shlqbyi $nz_5,$nz_2,0                           # 41o copy

            fma     $mirror,$transmittance_3,$share,$mirror # 42e
            lnop                                        # 42o pairing

            fnms    $uz_4,$taken,$nz,$dz                # 43e
        lqd     $px_5,0($a_surfaces)                    # 43o

            fnms    $through,$transmittance_3,$share,$transmittance_3 # 44e
            shlqbyi $transmittance_3,$transmittance,0   # 44o copy

        fm      $ux_4,$ux_4,$ratio_2                    # 45e
        lqd     $gy_7,448($a_surfaces)                  # 45o

            fm      $uy,$uy,$ratio                      # 46e
        lqd     $pz_6,128($a_surfaces)                  # 46o

            fnms    $k,$ux,$ux,$k_one                   # 47e
        lqd     $gx_5,384($a_surfaces)                  # 47o

        fm      $uy_5,$uy_5,$ratio_2                    # 48e
            stqd    $mirror,0x400($a_surfaces_8)        # 48o

            fm      $uz_5,$uz_4,$ratio                  # 49e
            shlqbyi $a_surfaces_8,$a_surfaces_10,0      # 49o copy

            fm      $weight_4,$weight_3,$through        # 50e
            lqd     $mirror,0x400($a_surfaces_9)        # 50o

        fnms    $k_6,$ux_4,$ux_4,$k_one                 # 51e
            shlqbyi $weight_3,$weight,0                 # 51o copy

        nop     $127                                    # 52e pairing
        lqd     $gx_7,384($a_surfaces)                  # 52o

            fnms    $k,$uy,$uy,$k                       # 53e
        lqd     $py_2,64($a_surfaces)                   # 53o

        fm      $uz,$uz,$ratio_2                        # 54e
        lqd     $gz_8,512($a_surfaces)                  # 54o

        fm      $side,$ux_4,$gx                         # 55e
        lqd     $leave_4,576($a_surfaces)               # 55o

        fa      $away,$k_one,$along                     # 56e
            shufb   $odd_2,$py_6,$weight_4,$m_last      # 56o

        fnms    $k_6,$uy_5,$uy_5,$k_6                   # 57e
            shufb   $odd_3,$py_6,$weight_4,$m_first     # 57o

            nop     $127                                # 58e pairing
            shlqbyi $py_6,$py_5,0                       # 58o copy

            fnms    $k,$uz_5,$uz_5,$k                   # 59e
        shlqbyi $a_surfaces_9,$a_surfaces_12,0          # 59o copy

            fnms    $length,$length,$k_half,$k_three_halves # 60e
            shufb   $first3_2,$even_3,$odd_2,$m_last    # 60o

        fma     $side,$uy_5,$gy,$side                   # 61e
            shufb   $first2_2,$even_3,$odd_2,$m_first   # 61o

            cgti    $keep_2,$through,0                  # 62e
            shufb   $first1_2,$even_2,$odd_3,$m_last    # 62o

        fnms    $k_6,$uz,$uz,$k_6                       # 63e
            shufb   $first_2,$even_2,$odd_3,$m_first    # 63o

            andi    $keep_2,$keep_2,32                  # 64e
            shufb   $even_2,$px_4,$pz_5,$m_first        # 64o

        fnms    $py_5,$leave_4,$gy_7,$py_2              # 65e
            frsqest $t_y,$k                             # 65o

            fm      $ry,$ry,$length                     # 66e
            rotqbyi $step_2,$keep_2,4                   # 66o

        fma     $side,$uz,$gz_2,$side                   # 67e
            rotqbyi $step_3,$keep_2,8                   # 67o

            rotmai  $total,$k,-31                       # 68e
            rotqbyi $step_4,$keep_2,12                  # 68o

            fi      $t_y,$k,$t_y                        # 69e
        frsqest $t_y_4,$k_6                             # 69o

            a       $end_2,$end,$keep_2                 # 70e
            stqx    $first_2,$a_queue,$end              # 70o

            fm      $rz,$rz,$length                     # 71e
            shufb   $even_3,$px_4,$pz_5,$m_last         # 71o

            fm      $rx,$rx,$length                     # 72e
            stqx    $first1_2,$a_queue,$end_2           # 72o

        fi      $t_y_3,$k_6,$t_y_4                      # 73e
            shufb   $odd_4,$ry,$pixel_3,$m_last         # 73o

            a       $end_3,$end_2,$step_2               # 74e
            shufb   $odd_5,$ry,$pixel_3,$m_first        # 74o

        fnms    $pz_5,$leave_4,$gz_8,$pz_6              # 75e
            shlqbyi $pixel_3,$pixel,0                   # 75o copy

            fm      $t_s_3,$k,$t_y                      # 76e
            stqx    $first2_2,$a_queue,$end_3           # 76o

            fm      $t_y,$t_y,$k_half                   # 77e
        shlqbyi $a_surfaces_10,$a_surfaces_11,0         # 77o copy

        fnms    $px_4,$leave_4,$gx_7,$px_5              # 78e
            shufb   $even_4,$rx,$rz,$m_last             # 78o

            a       $end_4,$end_3,$step_3               # 79e
            shufb   $even_5,$rx,$rz,$m_first            # 79o

        fm      $t_s_2,$k_6,$t_y_3                      # 80e
        lqd     $gy_6,448($a_surfaces)                  # 80o

        fm      $t_y_3,$t_y_3,$k_half                   # 81e
            stqx    $first3_2,$a_queue,$end_4           # 81o

            fnms    $beyond_3,$t_s_3,$t_s_3,$k          # 82e
            shufb   $second2_2,$even_4,$odd_4,$m_first  # 82o

            shufb   $second_2,$even_5,$odd_5,$m_first   # 83o
            shufb   $second1_2,$even_5,$odd_5,$m_last   # 84o

            nop     $127                                # 85e pairing
            shufb   $second3_2,$even_4,$odd_4,$m_last   # 85o

        fnms    $beyond_2,$t_s_2,$t_s_2,$k_6            # 86e
        lqd     $gz_7,512($a_surfaces)                  # 86o

            nop     $127                                # 87e pairing
            stqx    $second_2,$a_second,$end            # 87o

            fma     $beyond_3,$beyond_3,$t_y,$t_s_3     # 88e
            stqx    $second1_2,$a_second,$end_2         # 88o

            a       $end,$end_4,$step_4                 # 89e
            stqx    $second2_2,$a_second,$end_3         # 89o

            stqx    $second3_2,$a_second,$end_4         # 90o
        lqd     $grazing_4,0x500($a_surfaces)           # 91o

        fma     $beyond_4,$beyond_2,$t_y_3,$t_s_2       # 92e
next_row_back:
        brnz    $count,next_row                         # 92o

next_row_drain:
        fnms    $side,$beyond_4,$cosine,$side           # 0e
        lqd     $dx,192($a_rays_4)                      # 0o

        fnms    $rx,$beyond_3,$nx_6,$ux                 # 1e
        lqd     $dz,320($a_rays_4)                      # 1o

        fs      $off,$k_one,$beyond_3                   # 2e
        lqd     $ratio,0x480($a_surfaces)               # 2o

        fnms    $ry,$beyond_3,$ny_4,$uy                 # 3e
        lqd     $dy,256($a_rays_4)                      # 3o

        fnms    $rz,$beyond_3,$nz,$uz_5                 # 4e
        lqd     $schlick,0x4c0($a_surfaces)             # 4o

        nop     $127                                    # 5e pairing
        shlqbyi $away_3,$away,0                         # 5o copy

        or      $side,$side,$k_6                        # 6e
        shlqbyi $grazing_5,$grazing_4,0                 # 6o copy

        fm      $length_2,$rx,$rx                       # 7e
        lqd     $weight,512($a_rays_4)                  # 7o

        cgti    $wrong,$side,-1                         # 8e neither is below 0
        hbr     refract_r16_return,$lr                  # 8o hint

        selb    $off,$away_2,$off,$thicker              # 9e
        shufb   $even_6,$px_4,$pz_5,$m_last             # 9o

        selb    $nx_7,$nx_4,$gx_5,$wrong                # 10e
        shlqbyi $a_surfaces_13,$a_surfaces_10,0         # 10o copy

        selb    $ny,$ny_2,$gy_6,$wrong                  # 11e
        shufb   $even_7,$px_4,$pz_5,$m_first            # 11o

        fm      $taken,$dx,$nx_7                        # 12e
        shlqbyi $nx_6,$nx_7,0                           # 12o copy

        selb    $nz,$nz_5,$gz_7,$wrong                  # 13e
        shlqbyi $ny_4,$ny,0                             # 13o copy

        fm      $fifth,$off,$off                        # 14e
        shlqbyi $schlick_3,$schlick,0                   # 14o copy

        fcgt    $thicker,$ratio,$k_one                  # 15e
        lqd     $transmittance,0x440($a_surfaces)       # 15o

        fma     $length,$ry,$ry,$length_2               # 16e
        shlqbyi $weight_5,$weight,0                     # 16o copy

        nop     $127                                    # 17e pairing
        lqd     $pixel,576($a_rays_4)                   # 17o

        fma     $taken,$dy,$ny,$taken                   # 18e
        shlqbyi $py_7,$py_5,0                           # 18o copy

        fm      $fifth,$fifth,$fifth                    # 20e
        shlqbyi $transmittance_4,$transmittance,0       # 21o copy

        fma     $length,$rz,$rz,$length                 # 22e
        shlqbyi $pixel_4,$pixel,0                       # 23o copy

        fma     $taken,$dz,$nz,$taken                   # 24e
        fm      $fifth,$fifth,$off                      # 26e

        fnms    $length,$length,$k_half,$k_three_halves # 28e
        fnms    $ux,$taken,$nx_7,$dx                    # 30e

        fnms    $uy,$taken,$ny,$dy                      # 31e
        fnms    $uz_6,$taken,$nz,$dz                    # 32e

        fma     $share,$fifth,$grazing_3,$schlick_2     # 33e
        fm      $ry,$ry,$length                         # 34e

        fm      $rx,$rx,$length                         # 35e
        fm      $ux,$ux,$ratio                          # 36e

        fm      $uy,$uy,$ratio                          # 37e
        fm      $uz_5,$uz_6,$ratio                      # 38e

        selb    $share,$share,$k_one,$total             # 39e
        lnop                                            # 39o pairing

        fm      $rz,$rz,$length                         # 40e
        shufb   $odd_6,$ry,$pixel_3,$m_first            # 40o

        fnms    $through,$transmittance_3,$share,$transmittance_3 # 41e
        shufb   $odd_4,$ry,$pixel_3,$m_last             # 41o

        fnms    $k,$ux,$ux,$k_one                       # 42e
        fma     $mirror,$transmittance_3,$share,$mirror # 43e

        nop     $127                                    # 44e pairing
        shufb   $even_5,$rx,$rz,$m_first                # 46o

        fm      $weight_6,$weight_3,$through            # 47e
        shufb   $even_8,$rx,$rz,$m_last                 # 47o

        fnms    $k,$uy,$uy,$k                           # 48e
        lnop                                            # 48o pairing

        cgti    $keep_2,$through,0                      # 49e
        stqd    $mirror,0x400($a_surfaces_8)            # 49o

        nop     $127                                    # 50e pairing
        shufb   $second_2,$even_5,$odd_6,$m_first       # 50o

        andi    $keep_2,$keep_2,32                      # 51e
        shufb   $second1_2,$even_5,$odd_6,$m_last       # 51o

        nop     $127                                    # 52e pairing
        lqd     $mirror,0x400($a_surfaces_9)            # 52o

        a       $end_5,$end,$keep_2                     # 53e
        rotqbyi $step_2,$keep_2,4                       # 53o

        fnms    $k,$uz_5,$uz_5,$k                       # 54e
        shufb   $odd_7,$py_6,$weight_6,$m_first         # 54o

        rotqbyi $step_4,$keep_2,12                      # 55o
        shufb   $second3_3,$even_8,$odd_4,$m_last       # 56o

        a       $end_3,$end_5,$step_2                   # 57e
        rotqbyi $step_3,$keep_2,8                       # 57o

        shufb   $first_3,$even_2,$odd_7,$m_first        # 58o
        shufb   $first1_3,$even_2,$odd_7,$m_last        # 59o

        rotmai  $total,$k,-31                           # 60e
        frsqest $t_y,$k                                 # 60o

        a       $end_6,$end_3,$step_3                   # 61e
        shufb   $odd_8,$py_6,$weight_6,$m_last          # 61o

        nop     $127                                    # 62e pairing
        stqx    $first_3,$a_queue,$end                  # 62o

        a       $end_2,$end_6,$step_4                   # 63e
        stqx    $first1_3,$a_queue,$end_5               # 63o

        fi      $t_y,$k,$t_y                            # 64e
        shufb   $second2_2,$even_8,$odd_4,$m_first      # 64o

        shufb   $first3_3,$even_3,$odd_8,$m_last        # 65o
        shufb   $first2_3,$even_3,$odd_8,$m_first       # 66o

        nop     $127                                    # 67e pairing
        stqx    $first2_3,$a_queue,$end_3               # 70o

        fm      $t_s_4,$k,$t_y                          # 71e
        stqx    $first3_3,$a_queue,$end_6               # 71o

        fm      $t_y,$t_y,$k_half                       # 72e
        stqx    $second_2,$a_second,$end                # 72o

        stqx    $second1_2,$a_second,$end_5             # 73o
        stqx    $second2_2,$a_second,$end_3             # 74o

        stqx    $second3_3,$a_second,$end_6             # 75o
        fnms    $beyond_5,$t_s_4,$t_s_4,$k              # 77e

        fma     $beyond_5,$beyond_5,$t_y,$t_s_4         # 83e
        fnms    $rx,$beyond_5,$nx_6,$ux                 # 89e

        fs      $off,$k_one,$beyond_5                   # 90e
        fnms    $ry,$beyond_5,$ny_4,$uy                 # 91e

        fnms    $rz,$beyond_5,$nz,$uz_5                 # 92e
        fm      $length,$rx,$rx                         # 95e

        selb    $off,$away_3,$off,$thicker              # 96e
        fm      $fifth,$off,$off                        # 98e

        fma     $length,$ry,$ry,$length                 # 101e
        fm      $fifth,$fifth,$fifth                    # 104e

        fma     $length,$rz,$rz,$length                 # 107e
        fm      $fifth,$fifth,$off                      # 110e

        fnms    $length,$length,$k_half,$k_three_halves # 113e
        fma     $share,$fifth,$grazing_5,$schlick_3     # 116e

        fm      $rz,$rz,$length                         # 119e
        fm      $ry,$ry,$length                         # 120e

        fm      $rx,$rx,$length                         # 121e
        selb    $share,$share,$k_one,$total             # 122e

        fnms    $through,$transmittance_4,$share,$transmittance_4 # 124e
        fma     $mirror,$transmittance_4,$share,$mirror # 125e

        shufb   $odd_9,$ry,$pixel_4,$m_first            # 126o
        shufb   $even_9,$rx,$rz,$m_last                 # 127o

        shufb   $even_5,$rx,$rz,$m_first                # 128o
        shufb   $odd_4,$ry,$pixel_4,$m_last             # 129o

        fm      $weight_4,$weight_5,$through            # 130e
        lnop                                            # 130o pairing

        cgti    $keep_3,$through,0                      # 131e
        stqd    $mirror,0x400($a_surfaces_13)           # 131o

        nop     $127                                    # 132e pairing
        shufb   $second_2,$even_5,$odd_9,$m_first       # 132o

        andi    $keep_3,$keep_3,32                      # 133e
        shufb   $second2_2,$even_9,$odd_4,$m_first      # 133o

        nop     $127                                    # 134e pairing
        shufb   $second1_2,$even_5,$odd_9,$m_last       # 134o

        a       $end_5,$end_2,$keep_3                   # 135e
        rotqbyi $step_3,$keep_3,8                       # 135o

        shufb   $odd_9,$py_7,$weight_4,$m_first         # 136o
        shufb   $odd_10,$py_7,$weight_4,$m_last         # 137o

        rotqbyi $step_2,$keep_3,4                       # 138o
        rotqbyi $step_4,$keep_3,12                      # 139o

        shufb   $first_2,$even_7,$odd_9,$m_first        # 140o
        shufb   $first2_2,$even_6,$odd_10,$m_first      # 141o

        a       $end_3,$end_5,$step_2                   # 142e
        shufb   $first1_4,$even_7,$odd_9,$m_last        # 142o

        nop     $127                                    # 143e pairing
        shufb   $second3_4,$even_9,$odd_4,$m_last       # 143o

        a       $end_7,$end_3,$step_3                   # 144e
        stqx    $first_2,$a_queue,$end_2                # 144o

        nop     $127                                    # 145e pairing
        shufb   $first3_2,$even_6,$odd_10,$m_last       # 145o

        a       $end,$end_7,$step_4                     # 146e
        stqx    $first1_4,$a_queue,$end_5               # 146o

        stqx    $first2_2,$a_queue,$end_3               # 147o
        a       $3,$a_queue,$end                        # 148e

        stqx    $first3_2,$a_queue,$end_7               # 149o
        stqx    $second_2,$a_second,$end_2              # 150o

        stqx    $second1_2,$a_second,$end_5             # 151o
        stqx    $second2_2,$a_second,$end_3             # 152o

        stqx    $second3_4,$a_second,$end_7             # 153o
refract_r16_return:
        bi      $lr                                     # 154o

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
        lqd     $ny,256($a_surfaces)                    # 9o

        a       $a_rays,$a_rays,$row                    # 10e
        lqd     $nz,320($a_surfaces)                    # 10o

        lqd     $ratio,0x480($a_surfaces)               # 11o
        lqd     $dx,192($a_rays)                        # 12o

        lqd     $dz,320($a_rays)                        # 13o
        lqd     $dy,256($a_rays)                        # 14o

        lqd     $gx,384($a_surfaces)                    # 15o
        lqd     $gz,512($a_surfaces)                    # 16o

        nop     $127                                    # 17e pairing
        lqd     $gy,448($a_surfaces)                    # 17o

        fm      $along,$dx,$nx                          # 18e
        lqd     $gz_9,512($a_surfaces)                  # 18o

        lqd     $dx_5,192($a_rays)                      # 19o
        lqd     $gy_8,448($a_surfaces)                  # 20o

        fm      $cosine,$nx,$gx                         # 21e
        lqd     $dy_6,256($a_rays)                      # 21o

        lqd     $gx_8,384($a_surfaces)                  # 22o
        lqd     $ratio_4,0x480($a_surfaces)             # 23o

        fma     $along,$dy,$ny,$along                   # 24e
        lqd     $dz_5,320($a_rays)                      # 24o

        lqd     $grazing,0x500($a_surfaces)             # 25o
        lqd     $py,64($a_surfaces)                     # 26o

        fma     $cosine,$ny,$gy,$cosine                 # 27e
        lqd     $schlick,0x4c0($a_surfaces)             # 27o

        nop     $127                                    # 28e pairing
        lqd     $gy_3,448($a_surfaces)                  # 28o

        fcgt    $thicker,$ratio_4,$k_one                # 29e
        lqd     $gz_2,512($a_surfaces)                  # 29o

        fma     $along,$dz,$nz,$along                   # 30e
        lqd     $px_3,0($a_surfaces)                    # 30o

        lqd     $leave,576($a_surfaces)                 # 31o
        lqd     $gx_9,384($a_surfaces)                  # 32o

        fma     $cosine,$nz,$gz,$cosine                 # 33e
        lqd     $transmittance,0x440($a_surfaces)       # 33o

        lqd     $pixel,576($a_rays)                     # 34o
        lqd     $weight,512($a_rays)                    # 35o

        fnms    $ux,$along,$nx,$dx                      # 36e
        lqd     $pz_7,128($a_surfaces)                  # 36o

        fnms    $uz,$along,$nz,$dz                      # 37e
        lqd     $mirror,0x400($a_surfaces)              # 37o

        fnms    $uy,$along,$ny,$dy                      # 38e
        fa      $away,$k_one,$along                     # 39e

        fnms    $px_5,$leave,$gx_9,$px_3                # 40e
        fnms    $py,$leave,$gy_3,$py                    # 41e

        fm      $ux,$ux,$ratio                          # 42e
        fm      $uz,$uz,$ratio                          # 43e

        fm      $uy,$uy,$ratio                          # 44e
        fnms    $pz,$leave,$gz_2,$pz_7                  # 45e

        fnms    $k,$ux,$ux,$k_one                       # 48e
        fm      $side,$ux,$gx                           # 49e

        shufb   $even,$px_5,$pz,$m_first                # 51o
        shufb   $even_10,$px_5,$pz,$m_last              # 52o

        fnms    $k,$uy,$uy,$k                           # 54e
        fma     $side,$uy,$gy,$side                     # 55e

        fnms    $k,$uz,$uz,$k                           # 60e
        fma     $side,$uz,$gz,$side                     # 61e

        frsqest $t_y,$k                                 # 66o
        fi      $t_y,$k,$t_y                            # 70e

        fm      $t_s,$k,$t_y                            # 77e
        fm      $t_y,$t_y,$k_half                       # 78e

        fnms    $beyond,$t_s,$t_s,$k                    # 83e
        fma     $beyond,$beyond,$t_y,$t_s               # 89e

        fnms    $side,$beyond,$cosine,$side             # 95e
        or      $side,$side,$k                          # 101e

        cgti    $wrong,$side,-1                         # 103e neither is below 0
        selb    $nx,$nx,$gx_8,$wrong                    # 105e

        selb    $ny,$ny,$gy_8,$wrong                    # 106e
        fm      $taken,$dx_5,$nx                        # 107e

        selb    $nz,$nz,$gz_9,$wrong                    # 108e
        fma     $taken,$dy_6,$ny,$taken                 # 113e

        fma     $taken,$dz_5,$nz,$taken                 # 119e
        fnms    $ux,$taken,$nx,$dx_5                    # 125e

        fnms    $uy,$taken,$ny,$dy_6                    # 126e
        fnms    $uz,$taken,$nz,$dz_5                    # 127e

        fm      $ux,$ux,$ratio_4                        # 131e
        fm      $uy,$uy,$ratio_4                        # 132e

        fm      $uz,$uz,$ratio_4                        # 133e
        fnms    $k,$ux,$ux,$k_one                       # 137e

        fnms    $k,$uy,$uy,$k                           # 143e
        fnms    $k,$uz,$uz,$k                           # 149e

        rotmai  $total,$k,-31                           # 155e
        frsqest $t_y,$k                                 # 155o

        fi      $t_y,$k,$t_y                            # 159e
        fm      $t_s,$k,$t_y                            # 166e

        fm      $t_y,$t_y,$k_half                       # 167e
        fnms    $beyond,$t_s,$t_s,$k                    # 172e

        fma     $beyond,$beyond,$t_y,$t_s               # 178e
        fs      $off,$k_one,$beyond                     # 184e

        fnms    $rx,$beyond,$nx,$ux                     # 185e
        fnms    $ry,$beyond,$ny,$uy                     # 186e

        fnms    $rz,$beyond,$nz,$uz                     # 187e
        selb    $off,$away,$off,$thicker                # 190e

        fm      $length,$rx,$rx                         # 191e
        fm      $fifth,$off,$off                        # 192e

        fma     $length,$ry,$ry,$length                 # 197e
        fm      $fifth,$fifth,$fifth                    # 198e

        fma     $length,$rz,$rz,$length                 # 203e
        fm      $fifth,$fifth,$off                      # 204e

        fnms    $length,$length,$k_half,$k_three_halves # 209e
        fma     $share,$fifth,$grazing,$schlick         # 210e

        fm      $rz,$rz,$length                         # 215e
        selb    $share,$share,$k_one,$total             # 216e

        fm      $ry,$ry,$length                         # 217e
        fnms    $through,$transmittance,$share,$transmittance # 218e

        fm      $rx,$rx,$length                         # 219e
        fma     $mirror,$transmittance,$share,$mirror   # 220e

        nop     $127                                    # 221e pairing
        shufb   $odd,$ry,$pixel,$m_last                 # 223o

        cgti    $keep,$through,0                        # 224e
        shufb   $odd_10,$ry,$pixel,$m_first             # 224o

        fm      $weight,$weight,$through                # 225e
        shufb   $even_4,$rx,$rz,$m_first                # 225o

        andi    $keep,$keep,32                          # 226e
        shufb   $even_11,$rx,$rz,$m_last                # 226o

        nop     $127                                    # 227e pairing
        stqd    $mirror,0x400($a_surfaces)              # 227o

        a       $end_7,$end,$keep                       # 228e
        rotqbyi $step,$keep,12                          # 228o

        shufb   $second+1,$even_4,$odd_10,$m_last       # 229o
        shufb   $second+3,$even_11,$odd,$m_last         # 230o

        shufb   $odd_11,$py,$weight,$m_last             # 231o
        shufb   $odd_6,$py,$weight,$m_first             # 232o

        rotqbyi $step_5,$keep,8                         # 233o
        shufb   $second,$even_4,$odd_10,$m_first        # 234o

        rotqbyi $step_6,$keep,4                         # 235o
        shufb   $first,$even,$odd_6,$m_first            # 236o

        shufb   $first+1,$even,$odd_6,$m_last           # 237o
        stqx    $second,$a_second,$end                  # 238o

        a       $end_8,$end_7,$step_6                   # 239e
        shufb   $first+3,$even_10,$odd_11,$m_last       # 239o

        nop     $127                                    # 240e pairing
        shufb   $first+2,$even_10,$odd_11,$m_first      # 240o

        a       $end_9,$end_8,$step_5                   # 241e
        shufb   $second+2,$even_11,$odd,$m_first        # 241o

        stqx    $second+1,$a_second,$end_7              # 242o
        stqx    $first,$a_queue,$end                    # 243o

        a       $end,$end_9,$step                       # 244e
        stqx    $first+1,$a_queue,$end_7                # 244o

        stqx    $first+2,$a_queue,$end_8                # 245o
        stqx    $first+3,$a_queue,$end_9                # 246o

        stqx    $second+2,$a_second,$end_8              # 247o
        stqx    $second+3,$a_second,$end_9              # 248o

        nop     $127                                    # 249e pairing
        brnz    $count,next_row_short                   # 249o

        a       $3,$a_queue,$end                        # 250e
        bi      $lr                                     # 250o
endfunction refract_r16
