# refract_r16   rays that surfaces let through, appended to a queue; what they don't, to the mirror
#   C       struct queued *refract_r16(const struct site *, int count, struct queued *, float
#           least);
#   In      $3 sites, $4 count (0 is none), $5 where the rays go: room for one more than
#           there may be, $6 least weight of a ray that is sent on; pointers 16-aligned
#   Out     a ray for each lane that lets something through, of a weight not below the least, in
#           order; surfaces' mirror: T F more; $3 the rays' end
#   Uses    $2-$4, $6-$79   Saves  -   Stack  0   Calls  -
#   Domain  directions and normals of length 1 within 4 ulp, normals on the ray's side; ratio from
#           1/4 to 4
#   Error   20 ulp of 1, each component of a direction, where the cosine beyond is above 0.1; below
#           it, 2 ulp over the cosine; where its square is below 16 ulp, all may be reflected or
#           not; its length within 2
#   Twin    lab/twins/src/refract.rs
#
# For the ratio e and the normal N:
#   s = e (d - (d.N) N)   along the surface; its length is the sine of refraction
#   k = 1 - s.s           below 0, all light is reflected, and F = 1
#   r = s - sqrt(k) N     or with the surface's own normal G if r does not cross it: r.G >= 0
#   F = schlick + grazing (1 - c)^5, where c is the cosine in the thinner medium: -d.N or sqrt(k)
# 1 - cosine^2 would lose the sine of a steep ray. The ray starts at point - leave G.
# Scheduled by spu schedule from refract_r16.s

        .include "work_unit.inc"
        .include "macros.inc"
        .include "math.inc"
        .include "bounce.inc"

        .set    NEXT,55
        registers k_one,transmittance,ratio,schlick,grazing,mirror
        registers along                                 # d.N
        registers k,beyond
        registers side                                  # r.G
        registers cosine                                # N.G
        registers wrong
        registers taken                                 # d.N of the normal that is used
        registers away                                  # 1 - c on the ray's side
        registers off                                   # 1 - c
        registers fifth
        registers share                                 # F
        registers through,total,thicker,t_y,t_s
        registers ux                                    # s
        registers uy,uz

# s, k and sqrt(k) for the normal n, where along is d.n.
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
        .set count_2,79; .set row_2,2; .set site_2,3; .set a_surfaces_2,6; .set ny_2,8
        .set a_rays_2,7; .set nz_2,19; .set ratio_2,9; .set dx_2,18; .set dy_2,21; .set dz_2,31
        .set gy_2,22; .set gz_2,33; .set a_rays_3,3; .set gx_2,23; .set nx_2,24; .set dx_3,29
        .set nx_3,26; .set gy_3,27; .set dx_4,2; .set ny_3,32; .set dy_3,34; .set ny_4,35
        .set dy_4,30; .set gz_3,36; .set nz_3,38; .set along_2,37; .set dz_3,39; .set nz_4,40
        .set cosine_2,56; .set dz_4,41; .set ratio_3,42; .set ux_2,18; .set gx_3,25; .set uy_2,8
        .set px_2,21; .set uz_2,19; .set gx_4,31; .set leave_2,47; .set gz_4,43; .set pz_2,44
        .set gy_4,58; .set grazing_2,62; .set uz_3,9; .set schlick_2,19; .set transmittance_2,45
        .set weight_2,49; .set py_2,31; .set k_2,37; .set gy_5,48; .set gz_5,18; .set pz_3,63
        .set px_3,28; .set ux_3,43; .set gx_5,51; .set uy_3,44; .set leave_3,50; .set uz_4,41
        .set a_surfaces_3,46; .set k_3,52; .set away_2,2; .set pixel_2,7; .set ux_4,8; .set nx_4,30
        .set uy_4,22; .set ny_5,37; .set uz_5,26; .set schlick_3,41; .set k_4,19; .set grazing_3,42
        .set side_2,9; .set nz_5,43; .set transmittance_3,44; .set k_5,33; .set a_surfaces_4,45
        .set py_3,48; .set t_y_2,6; .set px_4,54; .set weight_3,47; .set even_2,49; .set k_6,8
        .set gz_6,28; .set a_surfaces_5,51; .set even_3,52; .set pz_4,21; .set gz_7,31
        .set gx_6,33; .set k_7,25; .set gy_6,8; .set t_s_2,22; .set pixel_3,59; .set t_y_3,7
        .set beyond_2,18; .set beyond_3,6; .set t_s_3,28; .set side_3,6; .set beyond_4,9
        .set beyond_5,7; .set nx_5,6; .set nx_6,21; .set k_8,6; .set beyond_6,32; .set dx_5,6
        .set nx_7,7; .set dy_5,9; .set gy_7,18; .set ux_5,6; .set ratio_4,7; .set weight_4,19
        .set k_9,22; .set odd_2,6; .set odd_3,23; .set uz_6,7; .set first1_2,9; .set first3_2,24
        .set first2_2,8; .set first_2,6; .set keep_2,22; .set light_2,6; .set even_4,7
        .set t_y_4,19; .set keep_3,6; .set even_5,22; .set odd_4,28; .set end_2,29; .set step_2,18
        .set second_2,32; .set second1_2,7; .set second2_2,9; .set second3_2,22; .set step_3,23
        .set step_4,6; .set end_3,7; .set beyond_7,23; .set end_4,18; .set away_3,4
        .set grazing_4,6; .set schlick_4,2; .set transmittance_4,8; .set weight_5,9; .set even_6,3
        .set py_4,14; .set a_surfaces_6,16; .set even_7,18; .set pixel_4,19; .set weight_6,7
        .set light_3,20; .set odd_5,7; .set keep_4,20; .set first_3,24; .set even_8,25
        .set odd_6,30; .set first1_3,23; .set step_5,31; .set second1_3,22; .set step_6,24
        .set end_5,28; .set second2_3,31; .set first2_3,33; .set end_6,24; .set second3_3,23
        .set step_7,20; .set first3_3,7; .set weight_7,2; .set keep_5,4; .set odd_7,8; .set odd_8,2
        .set first_4,4; .set first1_4,3; .set step_8,8; .set step_9,12; .set first2_4,4
        .set end_7,8; .set end_8,3; .set gx_7,2; .set dx_6,3; .set gy_8,6; .set dy_6,7; .set gz_8,8
        .set dz_5,9; .set ratio_5,18; .set gx_8,19; .set gy_9,34; .set gz_9,35; .set even_9,19
        .set even_10,6; .set step_10,7; .set end_9,2
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
        ilhu    $k_three_halves,0x3fc0                  # 9e
        ilhu    $k_one,0x3f80                           # 10e
        brz     $count_2,next_row_short                 # 10o too few passes
        shli    $row,$at,2                              # 11e
        lqx     $site,$a_sites,$at                      # 11o
        ai      $at,$at,4                               # 12e
        ai      $count,$count,-1                        # 13e
        shli    $row_2,$at,2                            # 14e
        lqx     $site_2,$a_sites,$at                    # 14o
        andi    $row,$row,48                            # 15e
        ai      $at,$at,4                               # 16e
        a       $a_surfaces_2,$site,$row                # 17e
        rotqbyi $a_rays,$site,4                         # 17o
        andi    $row_2,$row_2,48                        # 18e
        lnop                                            # 18o pairing
        ai      $count,$count,-1                        # 19e
        lqd     $nx,192($a_surfaces_2)                  # 19o
        a       $a_surfaces,$site_2,$row_2              # 20e
        lqd     $ny_2,256($a_surfaces_2)                # 20o
        a       $a_rays_2,$a_rays,$row                  # 21e
        lqd     $nz_2,320($a_surfaces_2)                # 21o
        lqd     $ratio_2,0x480($a_surfaces_2)           # 22o
        lqd     $dx_2,192($a_rays_2)                    # 23o
        lqd     $dy_2,256($a_rays_2)                    # 24o
        lqd     $dz_2,320($a_rays_2)                    # 25o
        lqd     $gx,384($a_surfaces_2)                  # 26o
        lqd     $gy_2,448($a_surfaces_2)                # 27o
        nop     $127                                    # 28e pairing
        lqd     $gz_2,512($a_surfaces_2)                # 28o
        fm      $along,$dx_2,$nx                        # 29e
        rotqbyi $a_rays_3,$site_2,4                     # 29o
        lqd     $gx_2,384($a_surfaces_2)                # 30o
        shlqbyi $nx_2,$nx,0                             # 31o copy
        fm      $cosine,$nx,$gx                         # 32e
        lqd     $dx_3,192($a_rays_2)                    # 32o
        a       $a_rays_3,$a_rays_3,$row_2              # 33e
        lqd     $nx_3,192($a_surfaces)                  # 33o
        nop     $127                                    # 34e pairing
        lqd     $gy_3,448($a_surfaces_2)                # 34o
        fma     $along,$dy_2,$ny_2,$along               # 35e
        lqd     $dx_4,192($a_rays_3)                    # 35o
        shlqbyi $ny_3,$ny_2,0                           # 36o copy
        lqd     $dy_3,256($a_rays_2)                    # 37o
        fma     $cosine,$ny_2,$gy_2,$cosine             # 38e
        lqd     $ny_4,256($a_surfaces)                  # 38o
        lqd     $dy_4,256($a_rays_3)                    # 39o
        lqd     $gz_3,512($a_surfaces_2)                # 40o
        fma     $along,$dz_2,$nz_2,$along               # 41e
        shlqbyi $nz_3,$nz_2,0                           # 41o copy
        fm      $along_2,$dx_4,$nx_3                    # 42e
        lqd     $dz_3,320($a_rays_2)                    # 42o
        nop     $127                                    # 43e pairing
        lqd     $nz_4,320($a_surfaces)                  # 43o
        fma     $cosine_2,$nz_2,$gz_2,$cosine           # 44e
        lqd     $dz_4,320($a_rays_3)                    # 44o
        lqd     $ratio,0x480($a_surfaces_2)             # 45o
        lqd     $ratio_3,0x480($a_surfaces)             # 46o
        fnms    $ux_2,$along,$nx,$dx_2                  # 47e
        lqd     $gx_3,384($a_surfaces)                  # 47o
        fnms    $uy_2,$along,$ny_2,$dy_2                # 48e
        lqd     $px_2,0($a_surfaces_2)                  # 48o
        fnms    $uz_2,$along,$nz_2,$dz_2                # 49e
        lqd     $gx_4,384($a_surfaces_2)                # 49o
        fma     $along_2,$dy_4,$ny_4,$along_2           # 50e
        lqd     $leave_2,576($a_surfaces_2)             # 50o
        fa      $away,$k_one,$along                     # 51e
        lqd     $gz_4,512($a_surfaces_2)                # 51o
        fcgt    $thicker,$ratio,$k_one                  # 52e
        lqd     $pz_2,128($a_surfaces_2)                # 52o
        fm      $ux_2,$ux_2,$ratio_2                    # 53e
        lqd     $gy_4,448($a_surfaces)                  # 53o
        fm      $uy_2,$uy_2,$ratio_2                    # 54e
        lqd     $grazing_2,0x500($a_surfaces_2)         # 54o
        fm      $uz_3,$uz_2,$ratio_2                    # 55e
        lqd     $schlick_2,0x4c0($a_surfaces_2)         # 55o
        fma     $along,$dz_4,$nz_4,$along_2             # 56e
        lqd     $transmittance_2,0x440($a_surfaces_2)   # 56o
        fm      $cosine,$nx_3,$gx_3                     # 57e
        lqd     $weight_2,512($a_rays_2)                # 57o
        fnms    $px_2,$leave_2,$gx_4,$px_2              # 58e
        lqd     $py_2,64($a_surfaces_2)                 # 58o
        fnms    $k_2,$ux_2,$ux_2,$k_one                 # 59e
        lqd     $gy_5,448($a_surfaces_2)                # 59o
        fm      $side,$ux_2,$gx                         # 60e
        lqd     $gz_5,512($a_surfaces)                  # 60o
        fnms    $pz_3,$leave_2,$gz_4,$pz_2              # 61e
        lqd     $px_3,0($a_surfaces)                    # 61o
        fnms    $ux_3,$along,$nx_3,$dx_4                # 62e
        lqd     $gx_5,384($a_surfaces)                  # 62o
        fnms    $uy_3,$along,$ny_4,$dy_4                # 63e
        lqd     $leave_3,576($a_surfaces)               # 63o
        fnms    $uz_4,$along,$nz_4,$dz_4                # 64e
        shlqbyi $a_surfaces_3,$a_surfaces_2,0           # 64o copy
        fnms    $k_3,$uy_2,$uy_2,$k_2                   # 65e
        shlqbyi $a_surfaces_2,$a_surfaces_2,0           # 65o copy
        fma     $side,$uy_2,$gy_2,$side                 # 66e
        shlqbyi $away_2,$away,0                         # 66o copy
        fma     $cosine,$ny_4,$gy_4,$cosine             # 67e
        lqd     $pixel_2,576($a_rays_2)                 # 67o
        fm      $ux_4,$ux_3,$ratio_3                    # 68e
        shlqbyi $nx_4,$nx_3,0                           # 68o copy
        fm      $uy_4,$uy_3,$ratio_3                    # 69e
        shlqbyi $ny_5,$ny_4,0                           # 69o copy
        fm      $uz_5,$uz_4,$ratio_3                    # 70e
        shlqbyi $schlick_3,$schlick_2,0                 # 70o copy
        fnms    $k_4,$uz_3,$uz_3,$k_3                   # 71e
        shlqbyi $grazing_3,$grazing_2,0                 # 71o copy
        fma     $side_2,$uz_3,$gz_2,$side               # 72e
        shlqbyi $nz_5,$nz_4,0                           # 72o copy
        fma     $cosine,$nz_4,$gz_5,$cosine             # 73e
        shlqbyi $transmittance_3,$transmittance_2,0     # 73o copy
        fnms    $k_5,$ux_4,$ux_4,$k_one                 # 74e
        shlqbyi $a_surfaces_4,$a_surfaces_2,0           # 74o copy
        fm      $side,$ux_4,$gx_3                       # 75e
        lqd     $mirror,0x400($a_surfaces_3)            # 75o
        fa      $away,$k_one,$along                     # 76e
        shlqbyi $a_surfaces_3,$a_surfaces,0             # 76o copy
        fnms    $py_3,$leave_2,$gy_5,$py_2              # 77e
        frsqest $t_y_2,$k_4                             # 77o
        fnms    $px_4,$leave_3,$gx_5,$px_3              # 78e
        shlqbyi $weight_3,$weight_2,0                   # 78o copy
        nop     $127                                    # 79e pairing
        shufb   $even_2,$px_2,$pz_3,$m_first            # 79o
        fnms    $k_6,$uy_4,$uy_4,$k_5                   # 80e
        lqd     $gz_6,512($a_surfaces)                  # 80o
        fi      $t_y_2,$k_4,$t_y_2                      # 81e
        shlqbyi $a_surfaces_5,$a_surfaces,0             # 81o copy
        nop     $127                                    # 82e pairing
        shufb   $even_3,$px_2,$pz_3,$m_last             # 82o
        fma     $side,$uy_4,$gy_4,$side                 # 83e
        lqd     $pz_4,128($a_surfaces)                  # 83o
        lqd     $gz_7,512($a_surfaces)                  # 84o
        lqd     $gx_6,384($a_surfaces)                  # 85o
        fnms    $k_7,$uz_5,$uz_5,$k_6                   # 86e
        lqd     $grazing_2,0x500($a_surfaces)           # 86o
        nop     $127                                    # 87e pairing
        lqd     $gy_6,448($a_surfaces)                  # 87o
        fm      $t_s_2,$k_4,$t_y_2                      # 88e
        shlqbyi $pixel_3,$pixel_2,0                     # 88o copy
        fm      $t_y_2,$t_y_2,$k_half                   # 89e
        fma     $side,$uz_5,$gz_5,$side                 # 90e
        fnms    $pz_3,$leave_3,$gz_6,$pz_4              # 91e
        frsqest $t_y_3,$k_7                             # 92o
        fnms    $beyond_2,$t_s_2,$t_s_2,$k_4            # 94e
        fi      $t_y_3,$k_7,$t_y_3                      # 96e
        fma     $beyond_3,$beyond_2,$t_y_2,$t_s_2       # 100e
        fm      $t_s_3,$k_7,$t_y_3                      # 103e
        fm      $t_y_3,$t_y_3,$k_half                   # 104e
        fnms    $side_3,$beyond_3,$cosine_2,$side_2     # 106e
        fnms    $beyond_4,$t_s_3,$t_s_3,$k_7            # 109e
        or      $side_3,$side_3,$k_4                    # 112e
        cgti    $wrong,$side_3,-1                       # 114e neither is below 0
        fma     $beyond_5,$beyond_4,$t_y_3,$t_s_3       # 115e
        selb    $nx_5,$nx_2,$gx_2,$wrong                # 116e
        selb    $ny,$ny_3,$gy_3,$wrong                  # 117e
        fm      $taken,$dx_3,$nx_5                      # 118e
        shlqbyi $nx_6,$nx_5,0                           # 118o copy
        selb    $nz,$nz_3,$gz_3,$wrong                  # 119e
        fma     $taken,$dy_3,$ny,$taken                 # 124e
        fma     $taken,$dz_3,$nz,$taken                 # 130e
        fnms    $ux,$taken,$nx_5,$dx_3                  # 136e
        fnms    $uy,$taken,$ny,$dy_3                    # 137e
        fnms    $uz,$taken,$nz,$dz_3                    # 138e
        fm      $ux,$ux,$ratio                          # 142e
        fm      $uy,$uy,$ratio                          # 143e
        fm      $uz,$uz,$ratio                          # 144e
        fnms    $k_8,$ux,$ux,$k_one                     # 148e
        fnms    $k_8,$uy,$uy,$k_8                       # 154e
        lnop                                            # 154o pairing
        fnms    $k_8,$uz,$uz,$k_8                       # 160e
        hbrr    next_row_back,next_row                  # 160o hint
        rotmai  $total,$k_8,-31                         # 166e
        frsqest $t_y,$k_8                               # 166o
        fi      $t_y,$k_8,$t_y                          # 170e
        fm      $t_s,$k_8,$t_y                          # 177e
        fm      $t_y,$t_y,$k_half                       # 178e
        fnms    $beyond_6,$t_s,$t_s,$k_8                # 183e
        fma     $beyond_3,$beyond_6,$t_y,$t_s           # 189e
        lnop                                            # 189o pairing
next_row:
        shli    $row,$at,2                              # 0e
        lqx     $site,$a_sites,$at                      # 0o
        ai      $at,$at,4                               # 1e
            lqd     $schlick,0x4c0($a_surfaces)         # 1o
        ai      $count,$count,-1                        # 2e
            lqd     $dz,320($a_rays_3)                  # 2o
            fs      $off,$k_one,$beyond_3               # 3e
            lqd     $dx,192($a_rays_3)                  # 3o
            fnms    $rx,$beyond_3,$nx_6,$ux             # 4e
            lqd     $ratio,0x480($a_surfaces)           # 4o
            fnms    $side,$beyond_5,$cosine,$side       # 5e
            lqd     $transmittance,0x440($a_surfaces)   # 5o
            fnms    $ry,$beyond_3,$ny,$uy               # 6e
        rotqbyi $a_rays,$site,4                         # 6o
        andi    $row,$row,48                            # 7e
            lqd     $py,64($a_surfaces)                 # 7o
            fnms    $rz,$beyond_3,$nz,$uz               # 8e
            lqd     $gy,448($a_surfaces)                # 8o
        a       $a_surfaces,$site,$row                  # 9e
            lqd     $dy,256($a_rays_3)                  # 9o
            selb    $off,$away_2,$off,$thicker          # 10e
            shlqbyi $away_2,$away,0                     # 10o copy
            or      $side,$side,$k_7                    # 11e
            lqd     $weight,512($a_rays_3)              # 11o
            fm      $fifth,$off,$off                    # 12e
            lqd     $pixel,576($a_rays_3)               # 12o
        a       $a_rays_3,$a_rays,$row                  # 13e
        lnop                                            # 13o pairing
            cgti    $wrong,$side,-1                     # 14e neither is below 0
        lqd     $nx,192($a_surfaces)                    # 14o
            fcgt    $thicker,$ratio,$k_one              # 15e
        lqd     $dx_5,192($a_rays_3)                    # 15o
            selb    $nx_7,$nx_4,$gx_6,$wrong            # 16e
            lnop                                        # 16o pairing
            selb    $ny,$ny_5,$gy_6,$wrong              # 17e
        lqd     $gx,384($a_surfaces)                    # 17o
            fm      $taken,$dx,$nx_7                    # 18e
            fm      $fifth,$fifth,$fifth                # 19e
            fm      $length,$rx,$rx                     # 20e
        lqd     $ny_2,256($a_surfaces)                  # 20o
        fm      $along,$dx_5,$nx                        # 21e
        lqd     $dy_5,256($a_rays_3)                    # 21o
            selb    $nz,$nz_5,$gz_7,$wrong              # 22e
        lqd     $gy_7,448($a_surfaces)                  # 22o
        fm      $cosine,$nx,$gx                         # 23e
            shlqbyi $nx_6,$nx_7,0                       # 23o copy
            fma     $taken,$dy,$ny,$taken               # 24e
        shlqbyi $nx_4,$nx,0                             # 24o copy
            fm      $fifth,$fifth,$off                  # 25e
            lnop                                        # 25o pairing
            fma     $length,$ry,$ry,$length             # 26e
        lqd     $nz_2,320($a_surfaces)                  # 26o
        fma     $along,$dy_5,$ny_2,$along               # 27e
        lqd     $dz_2,320($a_rays_3)                    # 27o
        fma     $cosine,$ny_2,$gy_7,$cosine             # 29e
        lqd     $gz_2,512($a_surfaces)                  # 29o
            fma     $taken,$dz,$nz,$taken               # 30e
        shlqbyi $ny_5,$ny_2,0                           # 30o copy
            fma     $share,$fifth,$grazing_3,$schlick_3 # 31e
            shlqbyi $schlick_3,$schlick,0               # 31o copy
            fma     $length,$rz,$rz,$length             # 32e
            shlqbyi $grazing_3,$grazing_2,0             # 32o copy
        fma     $along,$dz_2,$nz_2,$along               # 33e
        fma     $cosine,$nz_2,$gz_2,$cosine             # 35e
            fnms    $uz,$taken,$nz,$dz                  # 36e
        shlqbyi $nz_5,$nz_2,0                           # 36o copy
            fnms    $ux,$taken,$nx_7,$dx                # 37e
            fnms    $uy,$taken,$ny,$dy                  # 38e
            selb    $share,$share,$k_one,$total         # 39e
            lnop                                        # 39o pairing
        fnms    $ux_5,$along,$nx,$dx_5                  # 40e
        lqd     $ratio_4,0x480($a_surfaces)             # 40o
            fma     $mirror,$transmittance_3,$share,$mirror # 41e
            lnop                                        # 41o pairing
            fnms    $through,$transmittance_3,$share,$transmittance_3 # 42e
            shlqbyi $transmittance_3,$transmittance,0   # 42o copy
        fnms    $uy_2,$along,$ny_2,$dy_5                # 43e
            fm      $ux,$ux,$ratio                      # 44e
        fnms    $uz_3,$along,$nz_2,$dz_2                # 45e
        fm      $ux_5,$ux_5,$ratio_4                    # 46e
            fm      $uy,$uy,$ratio                      # 47e
            stqd    $mirror,0x400($a_surfaces_4)        # 47o
            fm      $weight_4,$weight_3,$through        # 48e
            shlqbyi $a_surfaces_4,$a_surfaces_5,0       # 48o copy
            fm      $uz,$uz,$ratio                      # 49e
            lqd     $mirror,0x400($a_surfaces_3)        # 49o
        fm      $uy_2,$uy_2,$ratio_4                    # 50e
        shlqbyi $a_surfaces_3,$a_surfaces,0             # 50o copy
            fnms    $k,$ux,$ux,$k_one                   # 51e
            lnop                                        # 51o pairing
        fnms    $k_9,$ux_5,$ux_5,$k_one                 # 52e
            shlqbyi $weight_3,$weight,0                 # 52o copy
            fnms    $length,$length,$k_half,$k_three_halves # 53e
            lnop                                        # 53o pairing
        fm      $side,$ux_5,$gx                         # 54e
            shufb   $odd_2,$py_3,$weight_4,$m_first     # 54o
        fa      $away,$k_one,$along                     # 55e
            shufb   $odd_3,$py_3,$weight_4,$m_last      # 55o
            fnms    $py_3,$leave_3,$gy,$py              # 56e
        lqd     $px,0($a_surfaces)                      # 56o
            fnms    $k,$uy,$uy,$k                       # 57e
        lqd     $gx,384($a_surfaces)                    # 57o
        fm      $uz_6,$uz_3,$ratio_4                    # 58e
            shufb   $first1_2,$even_2,$odd_2,$m_last    # 58o
        fnms    $k_9,$uy_2,$uy_2,$k_9                   # 59e
            shufb   $first3_2,$even_3,$odd_3,$m_last    # 59o
        fma     $side,$uy_2,$gy_7,$side                 # 60e
            shufb   $first2_2,$even_3,$odd_3,$m_first   # 60o
            fm      $rz,$rz,$length                     # 61e
            shufb   $first_2,$even_2,$odd_2,$m_first    # 61o
            nop     $127                                # 62e pairing
            shufb   $even_2,$px_4,$pz_3,$m_first        # 62o
            fnms    $k,$uz,$uz,$k                       # 63e
        lqd     $leave_3,576($a_surfaces)               # 63o
            fm      $rx,$rx,$length                     # 64e
        lqd     $gz_5,512($a_surfaces)                  # 64o
        fnms    $k_7,$uz_6,$uz_6,$k_9                   # 65e
        shlqbyi $a_surfaces_5,$a_surfaces,0             # 65o copy
            cgti    $keep_2,$through,0                  # 66e
            shufb   $even_3,$px_4,$pz_3,$m_last         # 66o
            fm      $ry,$ry,$length                     # 67e
            stqx    $first_2,$a_queue,$end              # 67o
        fma     $side,$uz_6,$gz_2,$side                 # 68e
        lqd     $pz,128($a_surfaces)                    # 68o
        fnms    $px_4,$leave_3,$gx,$px                  # 69e
            frsqest $t_y,$k                             # 69o
            fcgt    $light_2,$least,$weight_4           # 70e
            shufb   $even_4,$rx,$rz,$m_first            # 70o
            rotmai  $total,$k,-31                       # 71e
        frsqest $t_y_4,$k_7                             # 71o
            andc    $keep_3,$keep_2,$light_2            # 72e
            shufb   $even_5,$rx,$rz,$m_last             # 72o
            fi      $t_y,$k,$t_y                        # 73e
            shufb   $odd_3,$ry,$pixel_3,$m_last         # 73o
            andi    $keep_3,$keep_3,32                  # 74e
            shufb   $odd_4,$ry,$pixel_3,$m_first        # 74o
        fi      $t_y_4,$k_7,$t_y_4                      # 75e
            shlqbyi $pixel_3,$pixel,0                   # 75o copy
            a       $end_2,$end,$keep_3                 # 76e
        lqd     $gz_7,512($a_surfaces)                  # 76o
        fnms    $pz_3,$leave_3,$gz_5,$pz                # 77e
            rotqbyi $step_2,$keep_3,8                   # 77o
            shufb   $second_2,$even_4,$odd_4,$m_first   # 78o
            shufb   $second1_2,$even_4,$odd_4,$m_last   # 79o
            fm      $t_s,$k,$t_y                        # 80e
            stqx    $first1_2,$a_queue,$end_2           # 80o
            fm      $t_y,$t_y,$k_half                   # 81e
            shufb   $second2_2,$even_5,$odd_3,$m_first  # 81o
        fm      $t_s_3,$k_7,$t_y_4                      # 82e
            shufb   $second3_2,$even_5,$odd_3,$m_last   # 82o
        fm      $t_y_4,$t_y_4,$k_half                   # 83e
            rotqbyi $step_3,$keep_3,4                   # 83o
            rotqbyi $step_4,$keep_3,12                  # 84o
            stqx    $second_2,$a_second,$end            # 85o
            fnms    $beyond_6,$t_s,$t_s,$k              # 86e
            stqx    $second1_2,$a_second,$end_2         # 86o
            a       $end_3,$end_2,$step_3               # 87e
        lqd     $gx_6,384($a_surfaces)                  # 87o
        fnms    $beyond_7,$t_s_3,$t_s_3,$k_7            # 88e
        lqd     $grazing_2,0x500($a_surfaces)           # 88o
            a       $end_4,$end_3,$step_2               # 89e
            stqx    $second2_2,$a_second,$end_3         # 89o
            nop     $127                                # 90e pairing
            stqx    $first2_2,$a_queue,$end_3           # 90o
            a       $end,$end_4,$step_4                 # 91e
            stqx    $second3_2,$a_second,$end_4         # 91o
            fma     $beyond_3,$beyond_6,$t_y,$t_s       # 92e
            stqx    $first3_2,$a_queue,$end_4           # 92o
        nop     $127                                    # 93e pairing
        lqd     $gy_6,448($a_surfaces)                  # 93o
        fma     $beyond_5,$beyond_7,$t_y_4,$t_s_3       # 94e
next_row_back:
        brnz    $count,next_row                         # 94o
next_row_drain:
        fnms    $side,$beyond_5,$cosine,$side           # 0e
        lqd     $dx,192($a_rays_3)                      # 0o
        fs      $off,$k_one,$beyond_3                   # 1e
        lqd     $dy,256($a_rays_3)                      # 1o
        fnms    $rx,$beyond_3,$nx_6,$ux                 # 2e
        lqd     $dz,320($a_rays_3)                      # 2o
        fnms    $ry,$beyond_3,$ny,$uy                   # 3e
        lqd     $ratio,0x480($a_surfaces)               # 3o
        fnms    $rz,$beyond_3,$nz,$uz                   # 4e
        shlqbyi $away_3,$away,0                         # 4o copy
        nop     $127                                    # 5e pairing
        lqd     $schlick,0x4c0($a_surfaces)             # 5o
        or      $side,$side,$k_7                        # 6e
        shlqbyi $grazing_4,$grazing_2,0                 # 6o copy
        selb    $off,$away_2,$off,$thicker              # 7e
        lqd     $transmittance,0x440($a_surfaces)       # 7o
        cgti    $wrong,$side,-1                         # 8e neither is below 0
        lqd     $weight,512($a_rays_3)                  # 8o
        fm      $fifth,$off,$off                        # 9e
        lqd     $py,64($a_surfaces)                     # 9o
        selb    $nx_7,$nx_4,$gx_6,$wrong                # 10e
        lqd     $gy,448($a_surfaces)                    # 10o
        selb    $ny,$ny_5,$gy_6,$wrong                  # 11e
        shlqbyi $schlick_4,$schlick,0                   # 11o copy
        fm      $taken,$dx,$nx_7                        # 12e
        shlqbyi $nx_6,$nx_7,0                           # 12o copy
        selb    $nz,$nz_5,$gz_7,$wrong                  # 13e
        shlqbyi $transmittance_4,$transmittance,0       # 13o copy
        fcgt    $thicker,$ratio,$k_one                  # 14e
        shlqbyi $weight_5,$weight,0                     # 14o copy
        fm      $fifth,$fifth,$fifth                    # 15e
        lqd     $pixel,576($a_rays_3)                   # 15o
        fm      $length,$rx,$rx                         # 16e
        shufb   $even_6,$px_4,$pz_3,$m_first            # 16o
        fnms    $py_4,$leave_3,$gy,$py                  # 17e
        hbr     refract_r16_return,$lr                  # 17o hint
        fma     $taken,$dy,$ny,$taken                   # 18e
        shlqbyi $a_surfaces_6,$a_surfaces_5,0           # 18o copy
        nop     $127                                    # 19e pairing
        shufb   $even_7,$px_4,$pz_3,$m_last             # 19o
        fm      $fifth,$fifth,$off                      # 21e
        shlqbyi $pixel_4,$pixel,0                       # 21o copy
        fma     $length,$ry,$ry,$length                 # 22e
        fma     $taken,$dz,$nz,$taken                   # 24e
        fma     $share,$fifth,$grazing_3,$schlick_3     # 27e
        fma     $length,$rz,$rz,$length                 # 28e
        fnms    $ux,$taken,$nx_7,$dx                    # 30e
        fnms    $uy,$taken,$ny,$dy                      # 31e
        fnms    $uz,$taken,$nz,$dz                      # 32e
        selb    $share,$share,$k_one,$total             # 33e
        fnms    $length,$length,$k_half,$k_three_halves # 34e
        fnms    $through,$transmittance_3,$share,$transmittance_3 # 35e
        fm      $ux,$ux,$ratio                          # 36e
        fm      $uy,$uy,$ratio                          # 37e
        fm      $uz,$uz,$ratio                          # 38e
        fma     $mirror,$transmittance_3,$share,$mirror # 39e
        fm      $rz,$rz,$length                         # 40e
        fm      $weight_6,$weight_3,$through            # 41e
        fnms    $k,$ux,$ux,$k_one                       # 42e
        fm      $rx,$rx,$length                         # 43e
        fm      $ry,$ry,$length                         # 44e
        lnop                                            # 44o pairing
        cgti    $keep_2,$through,0                      # 45e
        stqd    $mirror,0x400($a_surfaces_4)            # 45o
        nop     $127                                    # 46e pairing
        lqd     $mirror,0x400($a_surfaces_3)            # 46o
        fcgt    $light_3,$least,$weight_6               # 47e
        shufb   $odd_3,$py_3,$weight_6,$m_first         # 47o
        fnms    $k,$uy,$uy,$k                           # 48e
        shufb   $odd_5,$py_3,$weight_6,$m_last          # 48o
        andc    $keep_4,$keep_2,$light_3                # 49e
        shufb   $even_5,$rx,$rz,$m_first                # 49o
        nop     $127                                    # 50e pairing
        shufb   $odd_4,$ry,$pixel_3,$m_first            # 50o
        andi    $keep_4,$keep_4,32                      # 51e
        shufb   $first_3,$even_2,$odd_3,$m_first        # 51o
        nop     $127                                    # 52e pairing
        shufb   $even_8,$rx,$rz,$m_last                 # 52o
        a       $end_2,$end,$keep_4                     # 53e
        shufb   $odd_6,$ry,$pixel_3,$m_last             # 53o
        fnms    $k,$uz,$uz,$k                           # 54e
        shufb   $first1_3,$even_2,$odd_3,$m_last        # 54o
        shufb   $second_2,$even_5,$odd_4,$m_first       # 55o
        rotqbyi $step_5,$keep_4,4                       # 56o
        shufb   $second1_3,$even_5,$odd_4,$m_last       # 57o
        stqx    $first_3,$a_queue,$end                  # 58o
        nop     $127                                    # 59e pairing
        rotqbyi $step_6,$keep_4,8                       # 59o
        rotmai  $total,$k,-31                           # 60e
        frsqest $t_y,$k                                 # 60o
        a       $end_5,$end_2,$step_5                   # 61e
        shufb   $second2_3,$even_8,$odd_6,$m_first      # 61o
        nop     $127                                    # 62e pairing
        shufb   $first2_3,$even_3,$odd_5,$m_first       # 62o
        a       $end_6,$end_5,$step_6                   # 63e
        stqx    $first1_3,$a_queue,$end_2               # 63o
        fi      $t_y,$k,$t_y                            # 64e
        shufb   $second3_3,$even_8,$odd_6,$m_last       # 64o
        rotqbyi $step_7,$keep_4,12                      # 65o
        stqx    $second_2,$a_second,$end                # 66o
        shufb   $first3_3,$even_3,$odd_5,$m_last        # 67o
        stqx    $second1_3,$a_second,$end_2             # 68o
        a       $end,$end_6,$step_7                     # 69e
        stqx    $second2_3,$a_second,$end_5             # 69o
        nop     $127                                    # 70e pairing
        stqx    $first2_3,$a_queue,$end_5               # 70o
        fm      $t_s,$k,$t_y                            # 71e
        stqx    $second3_3,$a_second,$end_6             # 71o
        fm      $t_y,$t_y,$k_half                       # 72e
        stqx    $first3_3,$a_queue,$end_6               # 72o
        fnms    $beyond_6,$t_s,$t_s,$k                  # 77e
        fma     $beyond_5,$beyond_6,$t_y,$t_s           # 83e
        fs      $off,$k_one,$beyond_5                   # 89e
        fnms    $rx,$beyond_5,$nx_6,$ux                 # 90e
        fnms    $ry,$beyond_5,$ny,$uy                   # 91e
        fnms    $rz,$beyond_5,$nz,$uz                   # 92e
        selb    $off,$away_3,$off,$thicker              # 95e
        fm      $length,$rx,$rx                         # 96e
        fm      $fifth,$off,$off                        # 97e
        fma     $length,$ry,$ry,$length                 # 102e
        fm      $fifth,$fifth,$fifth                    # 103e
        fma     $length,$rz,$rz,$length                 # 108e
        fm      $fifth,$fifth,$off                      # 109e
        fnms    $length,$length,$k_half,$k_three_halves # 114e
        fma     $share,$fifth,$grazing_4,$schlick_4     # 115e
        fm      $rz,$rz,$length                         # 120e
        selb    $share,$share,$k_one,$total             # 121e
        fm      $rx,$rx,$length                         # 122e
        fnms    $through,$transmittance_4,$share,$transmittance_4 # 123e
        fm      $ry,$ry,$length                         # 124e
        fma     $mirror,$transmittance_4,$share,$mirror # 125e
        shufb   $even_4,$rx,$rz,$m_first                # 128o
        fm      $weight_7,$weight_5,$through            # 129e
        shufb   $even_5,$rx,$rz,$m_last                 # 129o
        cgti    $keep_5,$through,0                      # 130e
        shufb   $odd_4,$ry,$pixel_4,$m_first            # 130o
        shufb   $odd_3,$ry,$pixel_4,$m_last             # 131o
        stqd    $mirror,0x400($a_surfaces_6)            # 132o
        nop     $127                                    # 133e pairing
        shufb   $second_2,$even_4,$odd_4,$m_first       # 134o
        fcgt    $light_2,$least,$weight_7               # 135e
        shufb   $odd_7,$py_4,$weight_7,$m_first         # 135o
        nop     $127                                    # 136e pairing
        shufb   $odd_8,$py_4,$weight_7,$m_last          # 136o
        andc    $keep_3,$keep_5,$light_2                # 137e
        shufb   $second1_2,$even_4,$odd_4,$m_last       # 137o
        nop     $127                                    # 138e pairing
        shufb   $second2_2,$even_5,$odd_3,$m_first      # 138o
        andi    $keep_3,$keep_3,32                      # 139e
        shufb   $first_4,$even_6,$odd_7,$m_first        # 139o
        nop     $127                                    # 140e pairing
        shufb   $first1_4,$even_6,$odd_7,$m_last        # 140o
        a       $end_2,$end,$keep_3                     # 141e
        rotqbyi $step_8,$keep_3,4                       # 141o
        rotqbyi $step_9,$keep_3,8                       # 142o
        stqx    $first_4,$a_queue,$end                  # 143o
        nop     $127                                    # 144e pairing
        shufb   $first2_4,$even_7,$odd_8,$m_first       # 144o
        a       $end_7,$end_2,$step_8                   # 145e
        stqx    $first1_4,$a_queue,$end_2               # 145o
        nop     $127                                    # 146e pairing
        shufb   $second3_2,$even_5,$odd_3,$m_last       # 146o
        a       $end_8,$end_7,$step_9                   # 147e
        stqx    $second_2,$a_second,$end                # 147o
        shufb   $first3_2,$even_7,$odd_8,$m_last        # 148o
        rotqbyi $step_4,$keep_3,12                      # 149o
        stqx    $second1_2,$a_second,$end_2             # 150o
        stqx    $second2_2,$a_second,$end_7             # 151o
        nop     $127                                    # 152e pairing
        stqx    $first2_4,$a_queue,$end_7               # 152o
        a       $end,$end_8,$step_4                     # 153e
        stqx    $second3_2,$a_second,$end_8             # 153o
        nop     $127                                    # 154e pairing
        stqx    $first3_2,$a_queue,$end_8               # 154o
        a       $3,$a_queue,$end                        # 155e
refract_r16_return:
        bi      $lr                                     # 155o
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
        lqd     $dy,256($a_rays)                        # 13o
        lqd     $dz,320($a_rays)                        # 14o
        lqd     $gx,384($a_surfaces)                    # 15o
        lqd     $gy,448($a_surfaces)                    # 16o
        nop     $127                                    # 17e pairing
        lqd     $gz,512($a_surfaces)                    # 17o
        fm      $along,$dx,$nx                          # 18e
        lqd     $gx_7,384($a_surfaces)                  # 18o
        lqd     $dx_6,192($a_rays)                      # 19o
        lqd     $gy_8,448($a_surfaces)                  # 20o
        fm      $cosine,$nx,$gx                         # 21e
        lqd     $dy_6,256($a_rays)                      # 21o
        lqd     $gz_8,512($a_surfaces)                  # 22o
        lqd     $dz_5,320($a_rays)                      # 23o
        fma     $along,$dy,$ny,$along                   # 24e
        lqd     $ratio_5,0x480($a_surfaces)             # 24o
        lqd     $schlick,0x4c0($a_surfaces)             # 25o
        lqd     $grazing,0x500($a_surfaces)             # 26o
        fma     $cosine,$ny,$gy,$cosine                 # 27e
        lqd     $transmittance,0x440($a_surfaces)       # 27o
        lqd     $weight,512($a_rays)                    # 28o
        lqd     $px,0($a_surfaces)                      # 29o
        fma     $along,$dz,$nz,$along                   # 30e
        lqd     $py,64($a_surfaces)                     # 30o
        fcgt    $thicker,$ratio_5,$k_one                # 31e
        lqd     $pz,128($a_surfaces)                    # 31o
        nop     $127                                    # 32e pairing
        lqd     $leave,576($a_surfaces)                 # 32o
        fma     $cosine,$nz,$gz,$cosine                 # 33e
        lqd     $gx_8,384($a_surfaces)                  # 33o
        lqd     $gy_9,448($a_surfaces)                  # 34o
        lqd     $gz_9,512($a_surfaces)                  # 35o
        fnms    $ux,$along,$nx,$dx                      # 36e
        lqd     $pixel,576($a_rays)                     # 36o
        fnms    $uy,$along,$ny,$dy                      # 37e
        lqd     $mirror,0x400($a_surfaces)              # 37o
        fnms    $uz,$along,$nz,$dz                      # 38e
        fa      $away,$k_one,$along                     # 39e
        fnms    $px,$leave,$gx_8,$px                    # 40e
        fnms    $py,$leave,$gy_9,$py                    # 41e
        fm      $ux,$ux,$ratio                          # 42e
        fm      $uy,$uy,$ratio                          # 43e
        fm      $uz,$uz,$ratio                          # 44e
        fnms    $pz,$leave,$gz_9,$pz                    # 45e
        fnms    $k,$ux,$ux,$k_one                       # 48e
        fm      $side,$ux,$gx                           # 49e
        shufb   $even,$px,$pz,$m_first                  # 51o
        shufb   $even_9,$px,$pz,$m_last                 # 52o
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
        selb    $nx,$nx,$gx_7,$wrong                    # 105e
        selb    $ny,$ny,$gy_8,$wrong                    # 106e
        fm      $taken,$dx_6,$nx                        # 107e
        selb    $nz,$nz,$gz_8,$wrong                    # 108e
        fma     $taken,$dy_6,$ny,$taken                 # 113e
        fma     $taken,$dz_5,$nz,$taken                 # 119e
        fnms    $ux,$taken,$nx,$dx_6                    # 125e
        fnms    $uy,$taken,$ny,$dy_6                    # 126e
        fnms    $uz,$taken,$nz,$dz_5                    # 127e
        fm      $ux,$ux,$ratio_5                        # 131e
        fm      $uy,$uy,$ratio_5                        # 132e
        fm      $uz,$uz,$ratio_5                        # 133e
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
        fm      $rx,$rx,$length                         # 215e
        selb    $share,$share,$k_one,$total             # 216e
        fm      $ry,$ry,$length                         # 217e
        fnms    $through,$transmittance,$share,$transmittance # 218e
        fm      $rz,$rz,$length                         # 219e
        fma     $mirror,$transmittance,$share,$mirror   # 220e
        nop     $127                                    # 221e pairing
        shufb   $odd,$ry,$pixel,$m_first                # 223o
        fm      $weight,$weight,$through                # 224e
        shufb   $odd_8,$ry,$pixel,$m_last               # 224o
        cgti    $keep,$through,0                        # 225e
        shufb   $even_6,$rx,$rz,$m_first                # 225o
        shufb   $even_10,$rx,$rz,$m_last                # 226o
        stqd    $mirror,0x400($a_surfaces)              # 227o
        nop     $127                                    # 228e pairing
        shufb   $second,$even_6,$odd,$m_first           # 229o
        fcgt    $light,$least,$weight                   # 230e
        shufb   $odd_5,$py,$weight,$m_first             # 230o
        nop     $127                                    # 231e pairing
        shufb   $odd_7,$py,$weight,$m_last              # 231o
        andc    $keep,$keep,$light                      # 232e
        shufb   $second+1,$even_6,$odd,$m_last          # 232o
        nop     $127                                    # 233e pairing
        shufb   $second+2,$even_10,$odd_8,$m_first      # 233o
        andi    $keep,$keep,32                          # 234e
        shufb   $first,$even,$odd_5,$m_first            # 234o
        nop     $127                                    # 235e pairing
        shufb   $first+1,$even,$odd_5,$m_last           # 235o
        a       $end_8,$end,$keep                       # 236e
        rotqbyi $step,$keep,4                           # 236o
        rotqbyi $step_10,$keep,8                        # 237o
        shufb   $first+2,$even_9,$odd_7,$m_first        # 238o
        nop     $127                                    # 239e pairing
        shufb   $first+3,$even_9,$odd_7,$m_last         # 239o
        a       $end_7,$end_8,$step                     # 240e
        shufb   $second+3,$even_10,$odd_8,$m_last       # 240o
        nop     $127                                    # 241e pairing
        stqx    $first,$a_queue,$end                    # 241o
        a       $end_9,$end_7,$step_10                  # 242e
        stqx    $second,$a_second,$end                  # 242o
        stqx    $first+1,$a_queue,$end_8                # 243o
        stqx    $second+1,$a_second,$end_8              # 244o
        rotqbyi $step,$keep,12                          # 245o
        stqx    $first+2,$a_queue,$end_7                # 246o
        stqx    $second+2,$a_second,$end_7              # 247o
        stqx    $first+3,$a_queue,$end_9                # 248o
        a       $end,$end_9,$step                       # 249e
        stqx    $second+3,$a_second,$end_9              # 249o
        nop     $127                                    # 250e pairing
        brnz    $count,next_row_short                   # 250o
        a       $3,$a_queue,$end                        # 251e
        bi      $lr                                     # 251o
endfunction refract_r16
