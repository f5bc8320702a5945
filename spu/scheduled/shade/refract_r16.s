# refract_r16   rays that surfaces let through, appended to a queue; what they don't, to the mirror
#   C       struct queued *refract_r16(const struct site *, int count, struct queued *, float
#           least, unsigned deepest);
#   In      $3 sites, $4 count (0 is none), $5 where the rays go: room for one more than
#           there may be, $6 least weight of a ray that is sent on, $7 CHAIN_STEP times the
#           rays that may come before the last of a chain; pointers 16-aligned
#   Out     a ray for each lane that lets something through, of a weight not below the least, unless
#           the lane's is the last of its chain, in order; surfaces' mirror: T F more; $3 the rays'
#           end
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
        .set count_2,79; .set row_2,2; .set site_2,3; .set a_surfaces_2,8; .set ny_2,18
        .set a_rays_2,9; .set nz_2,21; .set ratio_2,22; .set dx_2,19; .set dz_2,26; .set gy_2,27
        .set gz_2,29; .set gx_2,32; .set nx_2,34; .set dx_3,35; .set a_rays_3,3; .set gy_3,36
        .set ny_3,38; .set dy_2,39; .set a_rays_4,2; .set nx_3,3; .set gz_3,54; .set dx_4,30
        .set dz_3,56; .set ny_4,33; .set along_2,31; .set dy_3,37; .set nz_3,24; .set dz_4,40
        .set cosine_2,57; .set ratio_3,59; .set ratio_4,41; .set gx_3,42; .set ux_2,19
        .set gy_4,25; .set uy_2,18; .set px_2,23; .set uz_2,26; .set gx_4,43; .set pz_2,44
        .set leave_2,45; .set gz_4,46; .set gy_5,48; .set py_2,50; .set uz_3,22; .set gz_5,26
        .set px_3,51; .set gx_5,52; .set pz_3,58; .set k_2,47; .set leave_3,49; .set gz_6,19
        .set px_4,28; .set a_surfaces_3,23; .set schlick_2,43; .set ux_3,30
        .set transmittance_2,46; .set uy_3,37; .set grazing_2,61; .set weight_2,63; .set uz_4,18
        .set pixel_2,9; .set ux_4,27; .set gy_6,30; .set uy_4,66; .set gx_6,40; .set k_3,67
        .set gz_7,47; .set side_2,22; .set schlick_3,62; .set dy_4,72; .set py_3,48; .set dz_5,75
        .set k_4,29; .set nx_4,23; .set px_5,52; .set t_y_2,3; .set pz_4,73; .set schlick_4,37
        .set light_2,58; .set grazing_3,41; .set pixel_3,76; .set transmittance_3,42; .set t_y_3,19
        .set a_surfaces_4,43; .set weight_3,45; .set k_5,3; .set a_surfaces_5,46; .set even_2,50
        .set even_3,51; .set a_surfaces_6,44; .set t_s_2,28; .set k_6,9; .set beyond_2,3
        .set t_y_4,8; .set side_3,3; .set nx_5,8; .set k_7,18; .set total_2,54; .set t_y_5,21
        .set t_s_3,36; .set beyond_3,25; .set dx_5,3; .set gy_7,9; .set dy_5,19; .set dz_6,21
        .set ux_5,3; .set uz_5,21; .set weight_4,19; .set px_6,25; .set keep_2,44; .set gx_7,38
        .set k_8,22; .set odd_2,47; .set odd_3,3; .set pz_5,28; .set first3_2,29; .set k_9,19
        .set first_2,22; .set first1_2,3; .set keep_3,32; .set gz_8,18; .set keep_4,19
        .set odd_4,22; .set odd_5,25; .set end_2,32; .set step_2,35; .set step_3,3; .set step_4,18
        .set even_4,21; .set even_5,28; .set end_3,3; .set second3_2,34; .set second_2,38
        .set second1_2,25; .set second2_2,21; .set end_4,22; .set away_2,3; .set schlick_5,4
        .set grazing_4,8; .set length_2,2; .set transmittance_4,14; .set weight_5,16; .set even_6,9
        .set py_4,18; .set even_7,19; .set nx_6,21; .set light_3,2; .set pixel_4,7
        .set through_2,23; .set weight_6,22; .set odd_6,23; .set keep_5,24; .set first1_3,23
        .set odd_7,28; .set even_8,29; .set even_9,30; .set step_5,31; .set first2_2,33
        .set end_5,31; .set step_6,23; .set second2_3,24; .set end_6,23; .set weight_7,3
        .set odd_8,4; .set second2_4,3; .set keep_6,2; .set first_3,6; .set first1_4,4
        .set first2_3,7; .set step_7,8; .set end_7,4; .set gx_8,2; .set gy_8,8; .set dy_6,9
        .set dz_7,19; .set ratio_5,31; .set px_7,32; .set py_5,33; .set pz_6,34; .set gx_9,35
        .set gz_9,39; .set pixel_5,21; .set px_8,22; .set odd_9,2; .set even_10,3; .set even_11,8
        .set light_4,9; .set odd_10,18; .set odd_11,19; .set step_8,9; .set end_8,2; .set end_9,8
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
        ilhu    $k_chain,256                            # 10e
        ilhu    $k_one,0x3f80                           # 11e
        brz     $count_2,next_row_short                 # 11o too few passes
        shli    $row,$at,2                              # 12e
        lqx     $site,$a_sites,$at                      # 12o
        ai      $at,$at,4                               # 13e
        ai      $count,$count,-1                        # 14e
        shli    $row_2,$at,2                            # 15e
        lqx     $site_2,$a_sites,$at                    # 15o
        andi    $row,$row,48                            # 16e
        ai      $at,$at,4                               # 17e
        a       $a_surfaces_2,$site,$row                # 18e
        rotqbyi $a_rays,$site,4                         # 18o
        andi    $row_2,$row_2,48                        # 19e
        lnop                                            # 19o pairing
        ai      $count,$count,-1                        # 20e
        lqd     $nx,192($a_surfaces_2)                  # 20o
        a       $a_surfaces,$site_2,$row_2              # 21e
        lqd     $ny_2,256($a_surfaces_2)                # 21o
        a       $a_rays_2,$a_rays,$row                  # 22e
        lqd     $nz_2,320($a_surfaces_2)                # 22o
        lqd     $ratio_2,0x480($a_surfaces_2)           # 23o
        lqd     $dx_2,192($a_rays_2)                    # 24o
        lqd     $dy,256($a_rays_2)                      # 25o
        lqd     $dz_2,320($a_rays_2)                    # 26o
        lqd     $gx,384($a_surfaces_2)                  # 27o
        lqd     $gy_2,448($a_surfaces_2)                # 28o
        nop     $127                                    # 29e pairing
        lqd     $gz_2,512($a_surfaces_2)                # 29o
        fm      $along,$dx_2,$nx                        # 30e
        lqd     $gx_2,384($a_surfaces_2)                # 30o
        shlqbyi $nx_2,$nx,0                             # 31o copy
        lqd     $dx_3,192($a_rays_2)                    # 32o
        fm      $cosine,$nx,$gx                         # 33e
        rotqbyi $a_rays_3,$site_2,4                     # 33o
        lqd     $gy_3,448($a_surfaces_2)                # 34o
        shlqbyi $ny_3,$ny_2,0                           # 35o copy
        fma     $along,$dy,$ny_2,$along                 # 36e
        lqd     $dy_2,256($a_rays_2)                    # 36o
        a       $a_rays_4,$a_rays_3,$row_2              # 37e
        lqd     $nx_3,192($a_surfaces)                  # 37o
        nop     $127                                    # 38e pairing
        lqd     $gz_3,512($a_surfaces_2)                # 38o
        fma     $cosine,$ny_2,$gy_2,$cosine             # 39e
        lqd     $dx_4,192($a_rays_4)                    # 39o
        lqd     $dz_3,320($a_rays_2)                    # 40o
        lqd     $ny_4,256($a_surfaces)                  # 41o
        fma     $along_2,$dz_2,$nz_2,$along             # 42e
        lqd     $dy_3,256($a_rays_4)                    # 42o
        lqd     $nz_3,320($a_surfaces)                  # 43o
        lqd     $dz_4,320($a_rays_4)                    # 44o
        fma     $cosine_2,$nz_2,$gz_2,$cosine           # 45e
        lqd     $ratio_3,0x480($a_surfaces_2)           # 45o
        fm      $along,$dx_4,$nx_3                      # 46e
        lqd     $ratio_4,0x480($a_surfaces)             # 46o
        nop     $127                                    # 47e pairing
        lqd     $gx_3,384($a_surfaces)                  # 47o
        fnms    $ux_2,$along_2,$nx,$dx_2                # 48e
        lqd     $gy_4,448($a_surfaces)                  # 48o
        fnms    $uy_2,$along_2,$ny_2,$dy                # 49e
        lqd     $px_2,0($a_surfaces_2)                  # 49o
        fnms    $uz_2,$along_2,$nz_2,$dz_2              # 50e
        lqd     $gx_4,384($a_surfaces_2)                # 50o
        fa      $away,$k_one,$along_2                   # 51e
        lqd     $pz_2,128($a_surfaces_2)                # 51o
        fma     $along,$dy_3,$ny_4,$along               # 52e
        lqd     $leave_2,576($a_surfaces_2)             # 52o
        fm      $cosine,$nx_3,$gx_3                     # 53e
        lqd     $gz_4,512($a_surfaces_2)                # 53o
        fm      $ux_2,$ux_2,$ratio_2                    # 54e
        lqd     $gy_5,448($a_surfaces_2)                # 54o
        fm      $uy_2,$uy_2,$ratio_2                    # 55e
        lqd     $py_2,64($a_surfaces_2)                 # 55o
        fm      $uz_3,$uz_2,$ratio_2                    # 56e
        lqd     $gz_5,512($a_surfaces)                  # 56o
        fcgt    $thicker,$ratio_3,$k_one                # 57e
        lqd     $px_3,0($a_surfaces)                    # 57o
        fma     $along_2,$dz_4,$nz_3,$along             # 58e
        lqd     $gx_5,384($a_surfaces)                  # 58o
        fma     $cosine,$ny_4,$gy_4,$cosine             # 59e
        lqd     $pz_3,128($a_surfaces)                  # 59o
        fnms    $k_2,$ux_2,$ux_2,$k_one                 # 60e
        lqd     $leave_3,576($a_surfaces)               # 60o
        fm      $side,$ux_2,$gx                         # 61e
        lqd     $gz_6,512($a_surfaces)                  # 61o
        fnms    $px_4,$leave_2,$gx_4,$px_2              # 62e
        shlqbyi $a_surfaces_3,$a_surfaces_2,0           # 62o copy
        fnms    $pz_2,$leave_2,$gz_4,$pz_2              # 63e
        lqd     $schlick_2,0x4c0($a_surfaces_2)         # 63o
        fnms    $ux_3,$along_2,$nx_3,$dx_4              # 64e
        lqd     $transmittance_2,0x440($a_surfaces_2)   # 64o
        fnms    $uy_3,$along_2,$ny_4,$dy_3              # 65e
        lqd     $grazing_2,0x500($a_surfaces_2)         # 65o
        fnms    $k_2,$uy_2,$uy_2,$k_2                   # 66e
        lqd     $weight_2,512($a_rays_2)                # 66o
        fma     $side,$uy_2,$gy_2,$side                 # 67e
        shlqbyi $a_surfaces_2,$a_surfaces_2,0           # 67o copy
        fnms    $uz_4,$along_2,$nz_3,$dz_4              # 68e
        lqd     $pixel_2,576($a_rays_2)                 # 68o
        fma     $cosine,$nz_3,$gz_5,$cosine             # 69e
        lqd     $mirror,0x400($a_surfaces_3)            # 69o
        fm      $ux_4,$ux_3,$ratio_4                    # 70e
        lqd     $gy_6,448($a_surfaces)                  # 70o
        fm      $uy_4,$uy_3,$ratio_4                    # 71e
        lqd     $gx_6,384($a_surfaces)                  # 71o
        fnms    $k_3,$uz_3,$uz_3,$k_2                   # 72e
        lqd     $gz_7,512($a_surfaces)                  # 72o
        fma     $side_2,$uz_3,$gz_2,$side               # 73e
        lqd     $schlick_3,0x4c0($a_surfaces)           # 73o
        fm      $uz_4,$uz_4,$ratio_4                    # 74e
        lqd     $dy_4,256($a_rays_4)                    # 74o
        fnms    $py_3,$leave_2,$gy_5,$py_2              # 75e
        lqd     $dz_5,320($a_rays_4)                    # 75o
        fnms    $k_4,$ux_4,$ux_4,$k_one                 # 76e
        shlqbyi $nx_4,$nx_3,0                           # 76o copy
        fm      $side,$ux_4,$gx_3                       # 77e
        shlqbyi $ny_4,$ny_4,0                           # 77o copy
        fnms    $px_5,$leave_3,$gx_5,$px_3              # 78e
        frsqest $t_y_2,$k_3                             # 78o
        fnms    $pz_4,$leave_3,$gz_6,$pz_3              # 79e
        shlqbyi $schlick_4,$schlick_2,0                 # 79o copy
        cgt     $light_2,$deepest,$pixel_2              # 80e
        shlqbyi $grazing_3,$grazing_2,0                 # 80o copy
        a       $pixel_3,$pixel_2,$k_chain              # 81e
        shlqbyi $transmittance_3,$transmittance_2,0     # 81o copy
        fi      $t_y_3,$k_3,$t_y_2                      # 82e
        shlqbyi $a_surfaces_4,$a_surfaces_2,0           # 82o copy
        nop     $127                                    # 83e pairing
        shlqbyi $weight_3,$weight_2,0                   # 83o copy
        fnms    $k_5,$uy_4,$uy_4,$k_4                   # 84e
        shlqbyi $a_surfaces_5,$a_surfaces,0             # 84o copy
        fma     $side,$uy_4,$gy_4,$side                 # 85e
        shufb   $even_2,$px_4,$pz_2,$m_first            # 85o
        shufb   $even_3,$px_4,$pz_2,$m_last             # 86o
        shlqbyi $a_surfaces_6,$a_surfaces,0             # 87o copy
        fm      $t_s_2,$k_3,$t_y_3                      # 89e
        fm      $t_y_3,$t_y_3,$k_half                   # 90e
        fnms    $k_6,$uz_4,$uz_4,$k_5                   # 91e
        fma     $side,$uz_4,$gz_5,$side                 # 92e
        fnms    $beyond_2,$t_s_2,$t_s_2,$k_3            # 95e
        frsqest $t_y_4,$k_6                             # 97o
        fma     $beyond,$beyond_2,$t_y_3,$t_s_2         # 101e
        fi      $t_y_3,$k_6,$t_y_4                      # 102e
        fnms    $side_3,$beyond,$cosine_2,$side_2       # 107e
        fm      $t_s_2,$k_6,$t_y_3                      # 109e
        fm      $t_y_3,$t_y_3,$k_half                   # 110e
        or      $side_3,$side_3,$k_3                    # 113e
        cgti    $wrong,$side_3,-1                       # 115e neither is below 0
        fnms    $beyond_2,$t_s_2,$t_s_2,$k_6            # 116e
        selb    $nx_5,$nx_2,$gx_2,$wrong                # 117e
        selb    $ny,$ny_3,$gy_3,$wrong                  # 118e
        fm      $taken,$dx_3,$nx_5                      # 119e
        selb    $nz,$nz_2,$gz_3,$wrong                  # 120e
        fma     $taken,$dy_2,$ny,$taken                 # 125e
        fma     $taken,$dz_3,$nz,$taken                 # 131e
        fnms    $ux,$taken,$nx_5,$dx_3                  # 137e
        fnms    $uy,$taken,$ny,$dy_2                    # 138e
        fnms    $uz,$taken,$nz,$dz_3                    # 139e
        fm      $ux,$ux,$ratio_3                        # 143e
        fm      $uy,$uy,$ratio_3                        # 144e
        fm      $uz,$uz,$ratio_3                        # 145e
        fnms    $k_7,$ux,$ux,$k_one                     # 149e
        fnms    $k_7,$uy,$uy,$k_7                       # 155e
        fnms    $k_7,$uz,$uz,$k_7                       # 161e
        lnop                                            # 161o pairing
        rotmai  $total_2,$k_7,-31                       # 167e
        frsqest $t_y_5,$k_7                             # 167o
        fi      $t_y_5,$k_7,$t_y_5                      # 171e
        fm      $t_s_3,$k_7,$t_y_5                      # 178e
        fm      $t_y_5,$t_y_5,$k_half                   # 179e
        fnms    $beyond,$t_s_3,$t_s_3,$k_7              # 184e
        fma     $beyond_3,$beyond,$t_y_5,$t_s_3         # 190e
        lnop                                            # 190o pairing
next_row:
            fma     $beyond,$beyond_2,$t_y_3,$t_s_2     # 0e
        lqx     $site,$a_sites,$at                      # 0o
        shli    $row,$at,2                              # 1e
        lnop                                            # 1o pairing
        ai      $at,$at,4                               # 2e
            lqd     $dx,192($a_rays_4)                  # 2o
        ai      $count,$count,-1                        # 3e
            lqd     $transmittance,0x440($a_surfaces)   # 3o
            fnms    $rz,$beyond_3,$nz,$uz               # 4e
            lqd     $grazing,0x500($a_surfaces)         # 4o
            fs      $off,$k_one,$beyond_3               # 5e
            lqd     $ratio,0x480($a_surfaces)           # 5o
        andi    $row,$row,48                            # 6e
        rotqbyi $a_rays,$site,4                         # 6o
            fnms    $side,$beyond,$cosine,$side         # 7e
            lqd     $gy,448($a_surfaces)                # 7o
            fnms    $rx,$beyond_3,$nx_5,$ux             # 8e
            lqd     $py,64($a_surfaces)                 # 8o
        a       $a_surfaces,$site,$row                  # 9e
            lqd     $weight,512($a_rays_4)              # 9o
            fnms    $ry,$beyond_3,$ny,$uy               # 10e
            lqd     $pixel,576($a_rays_4)               # 10o
        a       $a_rays_4,$a_rays,$row                  # 11e
            selb    $off,$away,$off,$thicker            # 12e
            or      $side,$side,$k_6                    # 13e
            lnop                                        # 13o pairing
            fcgt    $thicker,$ratio,$k_one              # 14e
        lqd     $nx,192($a_surfaces)                    # 14o
            cgti    $wrong,$side,-1                     # 15e neither is below 0
        lqd     $gx,384($a_surfaces)                    # 15o
            fm      $fifth,$off,$off                    # 16e
        lqd     $dx_5,192($a_rays_4)                    # 16o
            selb    $nx_5,$nx_4,$gx_6,$wrong            # 17e
            selb    $nz,$nz_3,$gz_7,$wrong              # 18e
            fm      $taken,$dx,$nx_5                    # 19e
        lqd     $gy_7,448($a_surfaces)                  # 19o
            selb    $ny,$ny_4,$gy_6,$wrong              # 20e
        shlqbyi $nx_4,$nx,0                             # 20o copy
        fm      $cosine,$nx,$gx                         # 21e
        lqd     $ny_2,256($a_surfaces)                  # 21o
        fm      $along,$dx_5,$nx                        # 22e
        lqd     $dy_5,256($a_rays_4)                    # 22o
            fm      $fifth,$fifth,$fifth                # 23e
            fm      $length,$rx,$rx                     # 24e
            fma     $taken,$dy_4,$ny,$taken             # 25e
            lnop                                        # 25o pairing
            fa      $away,$k_one,$along_2               # 26e
        lqd     $gz,512($a_surfaces)                    # 26o
        fma     $cosine,$ny_2,$gy_7,$cosine             # 27e
        lqd     $nz_3,320($a_surfaces)                  # 27o
        fma     $along,$dy_5,$ny_2,$along               # 28e
        lqd     $dz_6,320($a_rays_4)                    # 28o
            fm      $fifth,$fifth,$off                  # 29e
            fma     $length,$ry,$ry,$length             # 30e
            fma     $taken,$dz_5,$nz,$taken             # 31e
        fma     $cosine,$nz_3,$gz,$cosine               # 33e
        fma     $along_2,$dz_6,$nz_3,$along             # 34e
        shlqbyi $ny_4,$ny_2,0                           # 34o copy
            fma     $share,$fifth,$grazing_3,$schlick_4 # 35e
            shlqbyi $schlick_4,$schlick_3,0             # 35o copy
            fma     $length,$rz,$rz,$length             # 36e
            fnms    $uy,$taken,$ny,$dy_4                # 37e
            fnms    $uz,$taken,$nz,$dz_5                # 38e
            fnms    $ux,$taken,$nx_5,$dx                # 39e
        fnms    $ux_5,$along_2,$nx,$dx_5                # 40e
        lnop                                            # 40o pairing
            selb    $share,$share,$k_one,$total_2       # 41e
        lqd     $ratio_2,0x480($a_surfaces)             # 41o
        fnms    $uz_5,$along_2,$nz_3,$dz_6              # 42e
            shlqbyi $grazing_3,$grazing,0               # 42o copy
            fma     $mirror,$transmittance_3,$share,$mirror # 43e
            fnms    $through,$transmittance_3,$share,$transmittance_3 # 44e
            fm      $uz,$uz,$ratio                      # 45e
            lnop                                        # 45o pairing
            fm      $ux,$ux,$ratio                      # 46e
            shlqbyi $transmittance_3,$transmittance,0   # 46o copy
        fnms    $uy_2,$along_2,$ny_2,$dy_5              # 47e
        fm      $ux_5,$ux_5,$ratio_2                    # 48e
            fm      $uy,$uy,$ratio                      # 49e
            stqd    $mirror,0x400($a_surfaces_4)        # 49o
            fm      $weight_4,$weight_3,$through        # 50e
            lqd     $mirror,0x400($a_surfaces_5)        # 50o
        fm      $uz_5,$uz_5,$ratio_2                    # 51e
            shlqbyi $a_surfaces_4,$a_surfaces_6,0       # 51o copy
            fnms    $length,$length,$k_half,$k_three_halves # 52e
        lqd     $px_6,0($a_surfaces)                    # 52o
            cgti    $keep_2,$through,0                  # 53e
            shlqbyi $weight_3,$weight,0                 # 53o copy
            fnms    $k,$ux,$ux,$k_one                   # 54e
        lqd     $gx_7,384($a_surfaces)                  # 54o
        fm      $uy_2,$uy_2,$ratio_2                    # 55e
        shlqbyi $a_surfaces_5,$a_surfaces,0             # 55o copy
        fnms    $k_8,$ux_5,$ux_5,$k_one                 # 56e
            shufb   $odd_2,$py_3,$weight_4,$m_last      # 56o
        fm      $side,$ux_5,$gx                         # 57e
            shufb   $odd_3,$py_3,$weight_4,$m_first     # 57o
            fnms    $py_3,$leave_3,$gy,$py              # 58e
        lqd     $pz_5,128($a_surfaces)                  # 58o
            fm      $rx,$rx,$length                     # 59e
        lqd     $leave_3,576($a_surfaces)               # 59o
            fnms    $k,$uy,$uy,$k                       # 60e
            shufb   $first3_2,$even_3,$odd_2,$m_last    # 60o
            fcgt    $light,$least,$weight_4             # 61e
            shufb   $first+2,$even_3,$odd_2,$m_first    # 61o
        fnms    $k_9,$uy_2,$uy_2,$k_8                   # 62e
            shufb   $first_2,$even_2,$odd_3,$m_first    # 62o
            fm      $ry,$ry,$length                     # 63e
            shufb   $first1_2,$even_2,$odd_3,$m_last    # 63o
            andc    $keep_3,$keep_2,$light              # 64e
            shufb   $even_2,$px_5,$pz_4,$m_first        # 64o
        fma     $side,$uy_2,$gy_7,$side                 # 65e
            shufb   $even_3,$px_5,$pz_4,$m_last         # 65o
            fnms    $k,$uz,$uz,$k                       # 66e
        shlqbyi $a_surfaces_6,$a_surfaces,0             # 66o copy
        fnms    $px_5,$leave_3,$gx_7,$px_6              # 67e
            stqx    $first_2,$a_queue,$end              # 67o
        fnms    $k_6,$uz_5,$uz_5,$k_9                   # 68e
        lqd     $gz_8,512($a_surfaces)                  # 68o
            and     $keep_4,$keep_3,$light_2            # 69e
            shufb   $odd_4,$ry,$pixel_3,$m_last         # 69o
            cgt     $light_2,$deepest,$pixel            # 70e
            shufb   $odd_5,$ry,$pixel_3,$m_first        # 70o
            andi    $keep_4,$keep_4,32                  # 71e
        hbrr    next_row_back,next_row                  # 71o hint
            fm      $rz,$rz,$length                     # 72e
            frsqest $t_y,$k                             # 72o
            a       $end_2,$end,$keep_4                 # 73e
            rotqbyi $step_2,$keep_4,8                   # 73o
        fma     $side,$uz_5,$gz,$side                   # 74e
        frsqest $t_y_5,$k_6                             # 74o
        fnms    $pz_4,$leave_3,$gz_8,$pz_5              # 75e
            stqx    $first1_2,$a_queue,$end_2           # 75o
            fi      $t_y,$k,$t_y                        # 76e
            rotqbyi $step_3,$keep_4,4                   # 76o
            rotmai  $total_2,$k,-31                     # 77e
            rotqbyi $step_4,$keep_4,12                  # 77o
        fi      $t_y_3,$k_6,$t_y_5                      # 78e
            shufb   $even_4,$rx,$rz,$m_last             # 78o
            nop     $127                                # 79e pairing
            shufb   $even_5,$rx,$rz,$m_first            # 79o
            a       $end_3,$end_2,$step_3               # 80e
        lqd     $gy_6,448($a_surfaces)                  # 80o
            a       $pixel_3,$pixel,$k_chain            # 81e
        lqd     $gx_6,384($a_surfaces)                  # 81o
            nop     $127                                # 82e pairing
            shufb   $second3_2,$even_4,$odd_4,$m_last   # 82o
            fm      $t_s_3,$k,$t_y                      # 83e
            shufb   $second_2,$even_5,$odd_5,$m_first   # 83o
            fm      $t_y,$t_y,$k_half                   # 84e
            shufb   $second1_2,$even_5,$odd_5,$m_last   # 84o
        fm      $t_s_2,$k_6,$t_y_3                      # 85e
            shufb   $second2_2,$even_4,$odd_4,$m_first  # 85o
        fm      $t_y_3,$t_y_3,$k_half                   # 86e
            stqx    $first+2,$a_queue,$end_3            # 86o
            a       $end_4,$end_3,$step_2               # 87e
            stqx    $second_2,$a_second,$end            # 87o
            nop     $127                                # 88e pairing
            stqx    $second1_2,$a_second,$end_2         # 88o
            fnms    $beyond,$t_s_3,$t_s_3,$k            # 89e
            stqx    $second2_2,$a_second,$end_3         # 89o
            a       $end,$end_4,$step_4                 # 90e
            stqx    $second3_2,$a_second,$end_4         # 90o
        fnms    $beyond_2,$t_s_2,$t_s_2,$k_6            # 91e
            stqx    $first3_2,$a_queue,$end_4           # 91o
        lqd     $gz_7,512($a_surfaces)                  # 92o
        lqd     $schlick_3,0x4c0($a_surfaces)           # 93o
        nop     $127                                    # 94e pairing
        lqd     $dy_4,256($a_rays_4)                    # 94o
            fma     $beyond_3,$beyond,$t_y,$t_s_3       # 95e
        lqd     $dz_5,320($a_rays_4)                    # 95o
        nop     $127                                    # 96e pairing
next_row_back:
        brnz    $count,next_row                         # 96o
next_row_drain:
        fma     $beyond,$beyond_2,$t_y_3,$t_s_2         # 0e
        lqd     $dx,192($a_rays_4)                      # 0o
        fs      $off,$k_one,$beyond_3                   # 1e
        lqd     $ratio,0x480($a_surfaces)               # 1o
        fa      $away_2,$k_one,$along_2                 # 2e
        lqd     $grazing,0x500($a_surfaces)             # 2o
        fnms    $rx,$beyond_3,$nx_5,$ux                 # 3e
        shlqbyi $schlick_5,$schlick_3,0                 # 3o copy
        fnms    $ry,$beyond_3,$ny,$uy                   # 4e
        lqd     $transmittance,0x440($a_surfaces)       # 4o
        fnms    $rz,$beyond_3,$nz,$uz                   # 5e
        lqd     $weight,512($a_rays_4)                  # 5o
        fnms    $side,$beyond,$cosine,$side             # 6e
        lqd     $gy,448($a_surfaces)                    # 6o
        selb    $off,$away,$off,$thicker                # 7e
        lqd     $py,64($a_surfaces)                     # 7o
        fcgt    $thicker,$ratio,$k_one                  # 8e
        shlqbyi $grazing_4,$grazing,0                   # 8o copy
        fm      $fifth,$off,$off                        # 9e
        lqd     $pixel,576($a_rays_4)                   # 9o
        fm      $length_2,$rx,$rx                       # 10e
        shlqbyi $transmittance_4,$transmittance,0       # 10o copy
        nop     $127                                    # 11e pairing
        shlqbyi $weight_5,$weight,0                     # 11o copy
        or      $side,$side,$k_6                        # 12e
        shufb   $even_6,$px_5,$pz_4,$m_first            # 12o
        fnms    $py_4,$leave_3,$gy,$py                  # 13e
        hbr     refract_r16_return,$lr                  # 13o hint
        cgti    $wrong,$side,-1                         # 14e neither is below 0
        shufb   $even_7,$px_5,$pz_4,$m_last             # 14o
        fm      $fifth,$fifth,$fifth                    # 15e
        shlqbyi $a_surfaces,$a_surfaces_6,0             # 15o copy
        selb    $nx_6,$nx_4,$gx_6,$wrong                # 16e
        selb    $ny,$ny_4,$gy_6,$wrong                  # 17e
        fm      $taken,$dx,$nx_6                        # 18e
        selb    $nz,$nz_3,$gz_7,$wrong                  # 19e
        fma     $length,$ry,$ry,$length_2               # 20e
        fm      $fifth,$fifth,$off                      # 21e
        cgt     $light_3,$deepest,$pixel                # 22e
        a       $pixel_4,$pixel,$k_chain                # 23e
        fma     $taken,$dy_4,$ny,$taken                 # 24e
        fma     $length,$rz,$rz,$length                 # 26e
        fma     $share,$fifth,$grazing_3,$schlick_4     # 27e
        fma     $taken,$dz_5,$nz,$taken                 # 30e
        fnms    $length,$length,$k_half,$k_three_halves # 32e
        selb    $share,$share,$k_one,$total_2           # 33e
        fnms    $through_2,$transmittance_3,$share,$transmittance_3 # 35e
        fnms    $ux,$taken,$nx_6,$dx                    # 36e
        fnms    $uy,$taken,$ny,$dy_4                    # 37e
        fnms    $uz,$taken,$nz,$dz_5                    # 38e
        fma     $mirror,$transmittance_3,$share,$mirror # 39e
        fm      $rx,$rx,$length                         # 40e
        fm      $weight_6,$weight_3,$through_2          # 41e
        fm      $ux,$ux,$ratio                          # 42e
        fm      $uy,$uy,$ratio                          # 43e
        fm      $uz,$uz,$ratio                          # 44e
        cgti    $keep_2,$through_2,0                    # 45e
        stqd    $mirror,0x400($a_surfaces_4)            # 45o
        fm      $ry,$ry,$length                         # 46e
        lqd     $mirror,0x400($a_surfaces_5)            # 46o
        fcgt    $light,$least,$weight_6                 # 47e
        shufb   $odd_6,$py_3,$weight_6,$m_first         # 47o
        fnms    $k,$ux,$ux,$k_one                       # 48e
        shufb   $odd_2,$py_3,$weight_6,$m_last          # 48o
        fm      $rz,$rz,$length                         # 49e
        andc    $keep_3,$keep_2,$light                  # 50e
        nop     $127                                    # 51e pairing
        shufb   $first_2,$even_2,$odd_6,$m_first        # 51o
        and     $keep_5,$keep_3,$light_2                # 52e
        shufb   $odd_5,$ry,$pixel_3,$m_first            # 52o
        nop     $127                                    # 53e pairing
        shufb   $first1_3,$even_2,$odd_6,$m_last        # 53o
        fnms    $k,$uy,$uy,$k                           # 54e
        shufb   $odd_7,$ry,$pixel_3,$m_last             # 54o
        andi    $keep_5,$keep_5,32                      # 55e
        shufb   $even_8,$rx,$rz,$m_first                # 55o
        nop     $127                                    # 56e pairing
        shufb   $even_9,$rx,$rz,$m_last                 # 56o
        a       $end_2,$end,$keep_5                     # 57e
        rotqbyi $step_5,$keep_5,4                       # 57o
        shufb   $first2_2,$even_3,$odd_2,$m_first       # 58o
        rotqbyi $step_2,$keep_5,8                       # 59o
        fnms    $k,$uz,$uz,$k                           # 60e
        shufb   $second_2,$even_8,$odd_5,$m_first       # 60o
        a       $end_5,$end_2,$step_5                   # 61e
        stqx    $first_2,$a_queue,$end                  # 61o
        nop     $127                                    # 62e pairing
        shufb   $second1_2,$even_8,$odd_5,$m_last       # 62o
        a       $end_4,$end_5,$step_2                   # 63e
        stqx    $first1_3,$a_queue,$end_2               # 63o
        rotqbyi $step_6,$keep_5,12                      # 64o
        shufb   $second2_3,$even_9,$odd_7,$m_first      # 65o
        rotmai  $total_2,$k,-31                         # 66e
        frsqest $t_y,$k                                 # 66o
        nop     $127                                    # 67e pairing
        shufb   $second3_2,$even_9,$odd_7,$m_last       # 67o
        a       $end_6,$end_4,$step_6                   # 68e
        stqx    $first2_2,$a_queue,$end_5               # 68o
        nop     $127                                    # 69e pairing
        shufb   $first3_2,$even_3,$odd_2,$m_last        # 69o
        fi      $t_y,$k,$t_y                            # 70e
        stqx    $second_2,$a_second,$end                # 70o
        stqx    $second1_2,$a_second,$end_2             # 71o
        stqx    $second2_3,$a_second,$end_5             # 72o
        stqx    $second3_2,$a_second,$end_4             # 73o
        stqx    $first3_2,$a_queue,$end_4               # 74o
        fm      $t_s_3,$k,$t_y                          # 77e
        fm      $t_y,$t_y,$k_half                       # 78e
        fnms    $beyond,$t_s_3,$t_s_3,$k                # 83e
        fma     $beyond_3,$beyond,$t_y,$t_s_3           # 89e
        fs      $off,$k_one,$beyond_3                   # 95e
        fnms    $rx,$beyond_3,$nx_6,$ux                 # 96e
        fnms    $ry,$beyond_3,$ny,$uy                   # 97e
        fnms    $rz,$beyond_3,$nz,$uz                   # 98e
        selb    $off,$away_2,$off,$thicker              # 101e
        fm      $length,$rx,$rx                         # 102e
        fm      $fifth,$off,$off                        # 103e
        fma     $length,$ry,$ry,$length                 # 108e
        fm      $fifth,$fifth,$fifth                    # 109e
        fma     $length,$rz,$rz,$length                 # 114e
        fm      $fifth,$fifth,$off                      # 115e
        fnms    $length,$length,$k_half,$k_three_halves # 120e
        fma     $share,$fifth,$grazing_4,$schlick_5     # 121e
        fm      $rx,$rx,$length                         # 126e
        selb    $share,$share,$k_one,$total_2           # 127e
        fm      $ry,$ry,$length                         # 128e
        fnms    $through,$transmittance_4,$share,$transmittance_4 # 129e
        fm      $rz,$rz,$length                         # 130e
        fma     $mirror,$transmittance_4,$share,$mirror # 131e
        shufb   $odd_5,$ry,$pixel_4,$m_first            # 134o
        fm      $weight_7,$weight_5,$through            # 135e
        shufb   $odd_4,$ry,$pixel_4,$m_last             # 135o
        cgti    $keep_2,$through,0                      # 136e
        shufb   $even_5,$rx,$rz,$m_first                # 136o
        shufb   $even_4,$rx,$rz,$m_last                 # 137o
        stqd    $mirror,0x400($a_surfaces)              # 138o
        nop     $127                                    # 139e pairing
        shufb   $second_2,$even_5,$odd_5,$m_first       # 140o
        fcgt    $light,$least,$weight_7                 # 141e
        shufb   $odd_8,$py_4,$weight_7,$m_first         # 141o
        nop     $127                                    # 142e pairing
        shufb   $odd_2,$py_4,$weight_7,$m_last          # 142o
        andc    $keep_3,$keep_2,$light                  # 143e
        shufb   $second1_2,$even_5,$odd_5,$m_last       # 143o
        nop     $127                                    # 144e pairing
        shufb   $second2_4,$even_4,$odd_4,$m_first      # 144o
        and     $keep_6,$keep_3,$light_3                # 145e
        shufb   $first_3,$even_6,$odd_8,$m_first        # 145o
        nop     $127                                    # 146e pairing
        shufb   $first1_4,$even_6,$odd_8,$m_last        # 146o
        andi    $keep_6,$keep_6,32                      # 147e
        shufb   $first2_3,$even_7,$odd_2,$m_first       # 147o
        nop     $127                                    # 148e pairing
        shufb   $second3_2,$even_4,$odd_4,$m_last       # 148o
        a       $end_2,$end_6,$keep_6                   # 149e
        rotqbyi $step_7,$keep_6,4                       # 149o
        stqx    $first_3,$a_queue,$end_6                # 150o
        rotqbyi $step_2,$keep_6,8                       # 151o
        nop     $127                                    # 152e pairing
        stqx    $first1_4,$a_queue,$end_2               # 152o
        a       $end_7,$end_2,$step_7                   # 153e
        shufb   $first3_2,$even_7,$odd_2,$m_last        # 153o
        nop     $127                                    # 154e pairing
        rotqbyi $step_4,$keep_6,12                      # 154o
        a       $end_4,$end_7,$step_2                   # 155e
        stqx    $first2_3,$a_queue,$end_7               # 155o
        stqx    $second_2,$a_second,$end_6              # 156o
        stqx    $second1_2,$a_second,$end_2             # 157o
        a       $end,$end_4,$step_4                     # 158e
        stqx    $second2_4,$a_second,$end_7             # 158o
        nop     $127                                    # 159e pairing
        stqx    $second3_2,$a_second,$end_4             # 159o
        a       $3,$a_queue,$end                        # 160e
        stqx    $first3_2,$a_queue,$end_4               # 160o
        nop     $127                                    # 161e pairing
refract_r16_return:
        bi      $lr                                     # 161o
next_row_short:
        shli    $row,$at,2                              # 0e
        lqx     $site,$a_sites,$at                      # 0o
        ai      $at,$at,4                               # 1e
        ai      $count,$count,-1                        # 2e
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
        lqd     $gx_8,384($a_surfaces)                  # 18o
        lqd     $dx_5,192($a_rays)                      # 19o
        lqd     $gy_8,448($a_surfaces)                  # 20o
        fm      $cosine,$nx,$gx                         # 21e
        lqd     $dy_6,256($a_rays)                      # 21o
        lqd     $gz_8,512($a_surfaces)                  # 22o
        lqd     $dz_7,320($a_rays)                      # 23o
        fma     $along,$dy,$ny,$along                   # 24e
        lqd     $ratio_5,0x480($a_surfaces)             # 24o
        lqd     $schlick,0x4c0($a_surfaces)             # 25o
        lqd     $grazing,0x500($a_surfaces)             # 26o
        fma     $cosine,$ny,$gy,$cosine                 # 27e
        lqd     $transmittance,0x440($a_surfaces)       # 27o
        lqd     $weight,512($a_rays)                    # 28o
        lqd     $px_7,0($a_surfaces)                    # 29o
        fma     $along,$dz,$nz,$along                   # 30e
        lqd     $py_5,64($a_surfaces)                   # 30o
        fcgt    $thicker,$ratio_5,$k_one                # 31e
        lqd     $pz_6,128($a_surfaces)                  # 31o
        nop     $127                                    # 32e pairing
        lqd     $leave,576($a_surfaces)                 # 32o
        fma     $cosine,$nz,$gz,$cosine                 # 33e
        lqd     $gx_9,384($a_surfaces)                  # 33o
        lqd     $gy_3,448($a_surfaces)                  # 34o
        lqd     $gz_9,512($a_surfaces)                  # 35o
        fnms    $ux,$along,$nx,$dx                      # 36e
        lqd     $pixel_5,576($a_rays)                   # 36o
        fnms    $uy,$along,$ny,$dy                      # 37e
        lqd     $mirror,0x400($a_surfaces)              # 37o
        fnms    $uz,$along,$nz,$dz                      # 38e
        fa      $away,$k_one,$along                     # 39e
        fnms    $px_8,$leave,$gx_9,$px_7                # 40e
        fnms    $py,$leave,$gy_3,$py_5                  # 41e
        fm      $ux,$ux,$ratio                          # 42e
        fm      $uy,$uy,$ratio                          # 43e
        fm      $uz,$uz,$ratio                          # 44e
        fnms    $pz,$leave,$gz_9,$pz_6                  # 45e
        cgt     $light,$deepest,$pixel_5                # 46e
        a       $pixel,$pixel_5,$k_chain                # 47e
        fnms    $k,$ux,$ux,$k_one                       # 48e
        fm      $side,$ux,$gx                           # 49e
        shufb   $even,$px_8,$pz,$m_first                # 51o
        shufb   $even_4,$px_8,$pz,$m_last               # 52o
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
        selb    $nz,$nz,$gz_8,$wrong                    # 108e
        fma     $taken,$dy_6,$ny,$taken                 # 113e
        fma     $taken,$dz_7,$nz,$taken                 # 119e
        fnms    $ux,$taken,$nx,$dx_5                    # 125e
        fnms    $uy,$taken,$ny,$dy_6                    # 126e
        fnms    $uz,$taken,$nz,$dz_7                    # 127e
        fm      $ux,$ux,$ratio_5                        # 131e
        fm      $uy,$uy,$ratio_5                        # 132e
        fm      $uz,$uz,$ratio_5                        # 133e
        fnms    $k,$ux,$ux,$k_one                       # 137e
        fnms    $k,$uy,$uy,$k                           # 143e
        fnms    $k,$uz,$uz,$k                           # 149e
        rotmai  $total,$k,-31                           # 155e
        frsqest $t_y,$k                                 # 155o
        hbrr    next_row_short_back,next_row_short      # 156o hint
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
        shufb   $odd,$ry,$pixel,$m_first                # 223o
        fm      $weight,$weight,$through                # 224e
        shufb   $odd_9,$ry,$pixel,$m_last               # 224o
        cgti    $keep,$through,0                        # 225e
        shufb   $even_10,$rx,$rz,$m_first               # 225o
        shufb   $even_11,$rx,$rz,$m_last                # 226o
        stqd    $mirror,0x400($a_surfaces)              # 227o
        nop     $127                                    # 228e pairing
        shufb   $second,$even_10,$odd,$m_first          # 229o
        fcgt    $light_4,$least,$weight                 # 230e
        shufb   $odd_10,$py,$weight,$m_first            # 230o
        nop     $127                                    # 231e pairing
        shufb   $odd_11,$py,$weight,$m_last             # 231o
        andc    $keep,$keep,$light_4                    # 232e
        shufb   $second+1,$even_10,$odd,$m_last         # 232o
        nop     $127                                    # 233e pairing
        shufb   $second+2,$even_11,$odd_9,$m_first      # 233o
        and     $keep,$keep,$light                      # 234e
        shufb   $first,$even,$odd_10,$m_first           # 234o
        nop     $127                                    # 235e pairing
        shufb   $first+1,$even,$odd_10,$m_last          # 235o
        andi    $keep,$keep,32                          # 236e
        shufb   $first+2,$even_4,$odd_11,$m_first       # 236o
        nop     $127                                    # 237e pairing
        shufb   $first+3,$even_4,$odd_11,$m_last        # 237o
        a       $end_3,$end,$keep                       # 238e
        rotqbyi $step,$keep,4                           # 238o
        rotqbyi $step_8,$keep,8                         # 239o
        shufb   $second+3,$even_11,$odd_9,$m_last       # 240o
        nop     $127                                    # 241e pairing
        stqx    $first,$a_queue,$end                    # 241o
        a       $end_8,$end_3,$step                     # 242e
        stqx    $second,$a_second,$end                  # 242o
        nop     $127                                    # 243e pairing
        stqx    $first+1,$a_queue,$end_3                # 243o
        a       $end_9,$end_8,$step_8                   # 244e
        stqx    $second+1,$a_second,$end_3              # 244o
        rotqbyi $step,$keep,12                          # 245o
        stqx    $first+2,$a_queue,$end_8                # 246o
        stqx    $second+2,$a_second,$end_8              # 247o
        stqx    $first+3,$a_queue,$end_9                # 248o
        a       $end,$end_9,$step                       # 249e
        stqx    $second+3,$a_second,$end_9              # 249o
        nop     $127                                    # 250e pairing
next_row_short_back:
        brnz    $count,next_row_short                   # 250o
        a       $3,$a_queue,$end                        # 251e
        bi      $lr                                     # 251o
endfunction refract_r16
