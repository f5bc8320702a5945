# shadow_rays_r16   rays from where sixteen rays have hit to a light
#   C       vec_uint4 shadow_rays_r16(const struct site *, int count, const struct light *,
#                                     const struct object *background);
#   In      $3 sites, $4 count (at least 1), $5 light, $6 the background's object; pointers
#           16-aligned
#   Out     the sites' shadow rays: origin, direction, t, object; weight and pixel stay as they are
#           $3 shadow rays, a count a lane
#   Uses    $2-$66, $79   Saves  -   Stack  0   Calls  -
#   Domain  distance to the light below 2^62; shares not below 0; LIGHT_directional all ones or 0,
#           the direction then of length 1
#   Error   2 ulp of 1, each component of the direction; t 4 ulp
#   Twin    lab/twins/src/shadow_rays.rs
#
#   to = position - point, L = to / |to|, t = |to|
#   for a directional light: L = position, t = FARTHEST
#   a ray exists if N.L > 0, plane.L > 0 and diffuse or highlight > 0; otherwise t = -1
#   origin = point + leave plane
# A light exactly at the point has L = 0, so N.L = 0 and there is no ray.
# Scheduled by spu schedule from shadow_rays_r16.s

        .include "work_unit.inc"
        .include "macros.inc"
        .include "math.inc"
        .include "vectors.inc"

        .set    NEXT,3
        registers a_site,count,a_light,background
        # constants
        registers k_half
        .set    NEXT,10
        registers k_one,k_farthest,k_minus_one
        registers k_near                                # 0 for a directional light, else 1
        registers c_directional,light_x,light_y,light_z
        # state
        registers rays
        # the site
        registers a_surfaces,a_shadow
        # a row
        registers point_x,point_y,point_z,to_x,to_y,to_z,normal_x,normal_y,normal_z,plane_x
        registers plane_y,plane_z,leave,share,diffuse,squared,inverse,t,facing,facing_plane
        # temporaries
        registers light,m_lane,t_y,t_e

# A word of the light, in every lane.
.macro  splat_word out:req, pattern:req
        load_constant $m_lane,\pattern
        splat   \out,$light,$m_lane
.endm

function shadow_rays_r16
        .set m_lane_2,2; .set m_lane_3,5; .set m_lane_4,7; .set count_2,79; .set point_x_2,9
        .set point_y_2,27; .set point_x_3,24; .set point_y_3,32; .set point_z_2,29; .set to_x_2,8
        .set point_z_3,35; .set to_x_3,28; .set to_y_2,20; .set point_z_4,41; .set to_x_4,30
        .set leave_2,2; .set to_y_3,5; .set plane_x_2,25; .set to_z_2,23; .set plane_y_2,26
        .set leave_3,51; .set squared_2,37; .set plane_x_3,48; .set to_z_3,45; .set plane_z_2,34
        .set to_y_4,31; .set point_x_4,33; .set squared_3,42; .set diffuse_2,38; .set to_z_4,46
        .set a_shadow_2,53; .set plane_z_3,56; .set share_2,39; .set point_z_5,43
        .set point_y_4,47; .set diffuse_3,62; .set plane_z_4,57; .set leave_4,59; .set share_3,49
        .set diffuse_4,2; .set to_y_5,40; .set plane_x_4,55; .set share_4,60; .set to_x_5,50
        .set t_y_2,52; .set to_z_5,44; .set t_y_3,54; .set point_x_5,64; .set t_y_4,22
        .set t_y_5,33; .set share_5,38; .set squared_4,21; .set plane_y_3,41; .set t_e_2,49
        .set inverse_2,54; .set t_e_3,58; .set inverse_3,63; .set t_e_4,2; .set inverse_4,61
        .set t_e_5,24; .set point_y_5,29; .set share_6,43; .set inverse_5,22; .set squared_5,49
        .set inverse_6,21; .set share_7,33; .set inverse_7,47; .set plane_y_4,43; .set normal_x_2,2
        .set inverse_8,24; .set normal_y_2,29; .set t_2,22; .set normal_x_3,36; .set inverse_9,52
        .set plane_x_5,54; .set t_y_6,58; .set inverse_10,59; .set to_y_6,60; .set to_z_6,59
        .set facing_plane_2,24; .set facing_2,8; .set t_y_7,25; .set facing_plane_3,31
        .set facing_3,36; .set normal_y_3,58; .set facing_plane_4,48; .set normal_x_4,52
        .set facing_4,28; .set t_3,2; .set t_e_6,8; .set plane_y_5,45; .set facing_plane_5,21
        .set normal_z_2,61; .set facing_5,62; .set facing_plane_6,26; .set normal_y_4,5
        .set facing_plane_7,20; .set normal_z_3,30; .set leave_5,24; .set plane_z_5,31; .set t_4,52
        .set share_8,2; .set diffuse_5,29; .set facing_6,5; .set facing_plane_8,8
        .set facing_plane_9,23; .set facing_7,9; .set inverse_11,8; .set t_5,20; .set t_6,29
        .set normal_x_5,20; .set facing_plane_10,22; .set normal_z_4,36; .set to_x_6,21
        .set normal_y_5,30; .set facing_8,2; .set point_y_6,8; .set point_y_7,20; .set rays_2,23
        .set t_7,25; .set point_z_6,26; .set to_z_7,33; .set to_y_7,43; .set diffuse_6,48
        .set t_y_8,39; .set plane_y_6,23; .set t_y_9,50; .set diffuse_7,51; .set t_8,5
        .set plane_z_6,5; .set point_z_7,2; .set point_x_6,41; .set t_e_7,22; .set point_z_8,24
        .set share_9,26; .set inverse_12,39; .set inverse_13,2; .set point_y_8,24
        .set inverse_14,36; .set normal_x_6,28; .set to_y_8,29; .set normal_y_6,50; .set to_z_8,39
        .set normal_z_5,50; .set normal_z_6,58; .set facing_9,30; .set t_e_8,20; .set facing_10,29
        .set inverse_15,30; .set normal_z_7,26; .set facing_plane_11,5; .set diffuse_8,8
        .set facing_plane_12,3; .set facing_11,3; .set t_9,4; .set point_x_7,2; .set normal_x_7,5
        .set plane_x_6,8; .set point_y_9,9; .set normal_y_7,35; .set plane_y_7,37
        .set point_z_9,38; .set normal_z_8,39; .set plane_z_7,40; .set to_x_7,41; .set diffuse_9,42
        .set leave_6,44; .set point_x_8,22; .set share_10,23; .set normal_x_8,33; .set t_y_10,42
        .set plane_x_7,46; .set normal_y_8,44; .set plane_y_8,48; .set point_z_10,49; .set to_x_8,2
        .set to_y_9,51; .set plane_z_8,9; .set t_e_9,38; .set share_11,52; .set inverse_16,53
        .set diffuse_10,54; .set to_z_9,55; .set leave_7,56; .set squared_6,57; .set point_x_9,58
        .set normal_x_9,59; .set plane_x_8,60; .set point_y_10,54; .set t_y_11,61
        .set normal_y_9,62; .set plane_y_9,63; .set point_z_11,64; .set inverse_17,38
        .set normal_z_9,42; .set t_y_12,53; .set plane_z_9,61; .set share_12,65; .set diffuse_11,66
        .set leave_8,19; .set t_y_13,47; .set facing_12,27; .set t_y_14,30; .set share_13,47
        .set to_x_9,49; .set t_e_10,28; .set inverse_18,31; .set facing_13,21; .set inverse_19,26
        .set t_e_11,27; .set t_10,21; .set to_z_10,21; .set t_11,24; .set t_12,8; .set facing_14,22
        .set facing_plane_13,2; .set point_y_11,2
        ilhu    $m_lane,0xc0d                           # 0e
        lqd     $light,0($a_light)                      # 0o
        ilhu    $m_lane_2,1                             # 1e
        iohl    $m_lane,0xe0f                           # 2e
        ilhu    $m_lane_3,0x405                         # 3e
        ilhu    $m_lane_4,0x809                         # 4e
        iohl    $m_lane_2,515                           # 5e
        lnop                                            # 5o pairing
        iohl    $m_lane_3,0x607                         # 6e
        shufb   $c_directional,$light,$light,$m_lane    # 6o
        iohl    $m_lane_4,0xa0b                         # 7e
        shufb   $light_x,$light,$light,$m_lane_2        # 7o
        ila     $m_lane,0x10203                         # 8e
        shufb   $light_y,$light,$light,$m_lane_3        # 8o
        ilhu    $k_one,0x3f80                           # 9e
        shufb   $light_z,$light,$light,$m_lane_4        # 9o
        clgti   $count_2,$count,1                       # 10e at least as many passes as overlap
        shufb   $background,$background,$background,$m_lane # 10o
        ilhu    $k_half,0x3f00                          # 11e
        ilhu    $k_farthest,0x5e80                      # 12e
        ilhu    $k_minus_one,0xbf80                     # 13e
        andc    $k_near,$k_one,$c_directional           # 14e
        il      $rays,0                                 # 15e
        brz     $count_2,next_site_short                # 15o too few passes
        ai      $count,$count,-1                        # 16e
        lqd     $a_surfaces,0($a_site)                  # 16o
        ai      $a_site,$a_site,16                      # 17e
        lqd     $point_x,0($a_surfaces)                 # 22o
        lqd     $point_x_2,32($a_surfaces)              # 23o
        lqd     $point_y_2,64($a_surfaces)              # 24o
        lqd     $point_x_3,48($a_surfaces)              # 25o
        lqd     $point_y_3,96($a_surfaces)              # 26o
        nop     $127                                    # 27e pairing
        lqd     $point_z_2,128($a_surfaces)             # 27o
        fnms    $to_x_2,$point_x,$k_near,$light_x       # 28e
        lqd     $point_z_3,160($a_surfaces)             # 28o
        fnms    $to_x_3,$point_x_2,$k_near,$light_x     # 29e
        lqd     $point_y,112($a_surfaces)               # 29o
        fnms    $to_y_2,$point_y_2,$k_near,$light_y     # 30e
        lqd     $point_z_4,176($a_surfaces)             # 30o
        fnms    $to_x_4,$point_x_3,$k_near,$light_x     # 31e
        lqd     $leave_2,624($a_surfaces)               # 31o
        fnms    $to_y_3,$point_y_3,$k_near,$light_y     # 32e
        lqd     $plane_x_2,384($a_surfaces)             # 32o
        fnms    $to_z_2,$point_z_2,$k_near,$light_z     # 33e
        lqd     $plane_y_2,496($a_surfaces)             # 33o
        fm      $squared,$to_x_2,$to_x_2                # 34e
        lqd     $leave_3,576($a_surfaces)               # 34o
        fm      $squared_2,$to_x_3,$to_x_3              # 35e
        lqd     $plane_x_3,432($a_surfaces)             # 35o
        fnms    $to_z_3,$point_z_3,$k_near,$light_z     # 36e
        lqd     $plane_z_2,560($a_surfaces)             # 36o
        fnms    $to_y_4,$point_y,$k_near,$light_y       # 37e
        lqd     $point_x_4,16($a_surfaces)              # 37o
        fm      $squared_3,$to_x_4,$to_x_4              # 38e
        lqd     $diffuse_2,832($a_surfaces)             # 38o
        fnms    $to_z_4,$point_z_4,$k_near,$light_z     # 39e
        rotqbyi $a_shadow_2,$a_surfaces,8               # 39o
        fma     $squared,$to_y_2,$to_y_2,$squared       # 40e
        lqd     $plane_z_3,512($a_surfaces)             # 40o
        fma     $squared_2,$to_y_3,$to_y_3,$squared_2   # 41e
        lqd     $share_2,896($a_surfaces)               # 41o
        fma     $point_y,$leave_2,$plane_y_2,$point_y   # 42e
        lqd     $point_z_5,144($a_surfaces)             # 42o
        fma     $point_x,$leave_3,$plane_x_2,$point_x   # 43e
        lqd     $point_y_4,80($a_surfaces)              # 43o
        fma     $squared_3,$to_y_4,$to_y_4,$squared_3   # 44e
        lqd     $diffuse_3,864($a_surfaces)             # 44o
        fma     $point_z_4,$leave_2,$plane_z_2,$point_z_4 # 45e
        lqd     $plane_z_4,528($a_surfaces)             # 45o
        fma     $squared,$to_z_2,$to_z_2,$squared       # 46e
        lqd     $leave_4,592($a_surfaces)               # 46o
        fma     $squared_2,$to_z_3,$to_z_3,$squared_2   # 47e
        lqd     $share_3,912($a_surfaces)               # 47o
        fma     $point_x_3,$leave_2,$plane_x_3,$point_x_3 # 48e
        lqd     $diffuse_4,848($a_surfaces)             # 48o
        fnms    $to_y_5,$point_y_4,$k_near,$light_y     # 49e
        lqd     $plane_x_4,400($a_surfaces)             # 49o
        fma     $squared_3,$to_z_4,$to_z_4,$squared_3   # 50e
        lqd     $share_4,928($a_surfaces)               # 50o
        fnms    $to_x_5,$point_x_4,$k_near,$light_x     # 51e
        stqd    $background,496($a_shadow_2)            # 51o
        fma     $point_z_2,$leave_3,$plane_z_3,$point_z_2 # 52e
        frsqest $t_y_2,$squared                         # 52o
        fnms    $to_z_5,$point_z_5,$k_near,$light_z     # 53e
        frsqest $t_y_3,$squared_2                       # 53o
        fma     $point_z_5,$leave_4,$plane_z_4,$point_z_5 # 54e
        stqd    $point_y,112($a_shadow_2)               # 54o
        fma     $point_x_5,$leave_4,$plane_x_4,$point_x_4 # 55e
        stqd    $background,480($a_shadow_2)            # 55o
        fi      $t_y_4,$squared,$t_y_2                  # 56e
        frsqest $t_y_2,$squared_3                       # 56o
        fi      $t_y_5,$squared_2,$t_y_3                # 57e
        stqd    $point_z_4,176($a_shadow_2)             # 57o
        or      $share_5,$share_2,$diffuse_2            # 58e
        stqd    $point_x,0($a_shadow_2)                 # 58o
        fm      $squared_4,$to_x_5,$to_x_5              # 59e
        stqd    $point_x_3,48($a_shadow_2)              # 59o
        fi      $t_y_2,$squared_3,$t_y_2                # 60e
        stqd    $background,448($a_shadow_2)            # 60o
        cgti    $share_2,$share_5,0                     # 61e
        lqd     $plane_y_3,464($a_surfaces)             # 61o
        or      $share_5,$share_3,$diffuse_4            # 62e
        stqd    $background,464($a_shadow_2)            # 62o
        fm      $t_e_2,$squared,$t_y_4                  # 63e
        stqd    $point_x_5,16($a_shadow_2)              # 63o
        fm      $inverse_2,$t_y_4,$k_half               # 64e
        stqd    $point_z_5,144($a_shadow_2)             # 64o
        fm      $t_e_3,$squared_2,$t_y_5                # 65e
        stqd    $point_z_2,128($a_shadow_2)             # 65o
        fm      $inverse_3,$t_y_5,$k_half               # 66e
        fm      $t_e_4,$squared_3,$t_y_2                # 67e
        fm      $inverse_4,$t_y_2,$k_half               # 68e
        fnms    $t_e_2,$t_e_2,$t_y_4,$k_one             # 69e
        fma     $squared_4,$to_y_5,$to_y_5,$squared_4   # 70e
        fnms    $t_e_5,$t_e_3,$t_y_5,$k_one             # 71e
        fma     $point_y_5,$leave_4,$plane_y_3,$point_y_4 # 72e
        fnms    $t_e_4,$t_e_4,$t_y_2,$k_one             # 73e
        or      $share_6,$share_4,$diffuse_3            # 74e
        fma     $inverse_5,$t_e_2,$inverse_2,$t_y_4     # 75e
        fma     $squared_5,$to_z_5,$to_z_5,$squared_4   # 76e
        fma     $inverse_6,$t_e_5,$inverse_3,$t_y_5     # 77e
        cgti    $share_7,$share_6,0                     # 78e
        stqd    $point_y_5,80($a_shadow_2)              # 78o
        fma     $inverse_7,$t_e_4,$inverse_4,$t_y_2     # 79e
        lqd     $plane_y_4,480($a_surfaces)             # 79o
        nop     $127                                    # 80e pairing
        lqd     $normal_x_2,224($a_surfaces)            # 80o
        selb    $inverse_8,$inverse_5,$k_one,$c_directional # 81e
        lqd     $normal_y_2,256($a_surfaces)            # 81o
        fm      $t_2,$squared,$inverse_5                # 82e
        lqd     $normal_x_3,192($a_surfaces)            # 82o
        selb    $inverse_9,$inverse_6,$k_one,$c_directional # 83e
        lqd     $plane_x_5,416($a_surfaces)             # 83o
        fm      $to_x_2,$to_x_2,$inverse_8              # 84e
        frsqest $t_y_6,$squared_5                       # 84o
        fm      $to_x_3,$to_x_3,$inverse_9              # 85e
        fm      $to_y_3,$to_y_3,$inverse_9              # 86e
        selb    $inverse_10,$inverse_7,$k_one,$c_directional # 87e
        fm      $to_y_2,$to_y_2,$inverse_8              # 88e
        fm      $to_z_4,$to_z_4,$inverse_10             # 89e
        lnop                                            # 89o pairing
        fm      $to_y_6,$to_y_4,$inverse_10             # 90e
        stqd    $to_x_2,192($a_shadow_2)                # 90o
        fm      $to_z_2,$to_z_2,$inverse_8              # 91e
        stqd    $to_x_3,224($a_shadow_2)                # 91o
        fm      $to_x_4,$to_x_4,$inverse_10             # 92e
        stqd    $to_y_3,288($a_shadow_2)                # 92o
        fm      $to_z_6,$to_z_3,$inverse_9              # 93e
        fm      $facing_plane_2,$plane_x_2,$to_x_2      # 94e
        fm      $facing_2,$normal_x_3,$to_x_2           # 95e
        fi      $t_y_7,$squared_5,$t_y_6                # 96e
        selb    $t_2,$t_2,$k_farthest,$c_directional    # 97e
        stqd    $to_z_2,320($a_shadow_2)                # 97o
        fm      $facing_plane_3,$plane_x_5,$to_x_3      # 98e
        stqd    $to_y_2,256($a_shadow_2)                # 98o
        fm      $facing_3,$normal_x_2,$to_x_3           # 99e
        lqd     $normal_y_3,288($a_surfaces)            # 99o
        fm      $facing_plane_4,$plane_x_3,$to_x_4      # 100e
        lqd     $normal_x_4,240($a_surfaces)            # 100o
        fma     $facing_4,$normal_y_2,$to_y_2,$facing_2 # 101e
        stqd    $to_z_4,368($a_shadow_2)                # 101o
        fm      $t_3,$squared_2,$inverse_6              # 102e
        stqd    $to_y_6,304($a_shadow_2)                # 102o
        fm      $t_e_6,$squared_5,$t_y_7                # 103e
        lqd     $plane_y_5,448($a_surfaces)             # 103o
        fma     $facing_plane_5,$plane_y_4,$to_y_3,$facing_plane_3 # 104e
        lqd     $normal_z,320($a_surfaces)              # 104o
        fm      $inverse,$t_y_7,$k_half                 # 105e
        lqd     $normal_z_2,352($a_surfaces)            # 105o
        fm      $facing_5,$normal_x_4,$to_x_4           # 106e
        stqd    $to_x_4,240($a_shadow_2)                # 106o
        fma     $facing_plane_6,$plane_y_2,$to_y_6,$facing_plane_4 # 107e
        stqd    $to_z_6,352($a_shadow_2)                # 107o
        fma     $facing_3,$normal_y_3,$to_y_3,$facing_3 # 108e
        lqd     $normal_y_4,304($a_surfaces)            # 108o
        fma     $facing_plane_7,$plane_y_5,$to_y_2,$facing_plane_2 # 109e
        lqd     $normal_z_3,368($a_surfaces)            # 109o
        fnms    $t_e_6,$t_e_6,$t_y_7,$k_one             # 110e
        lqd     $leave_5,608($a_surfaces)               # 110o
        fma     $facing_4,$normal_z,$to_z_2,$facing_4   # 111e
        lqd     $plane_z_5,544($a_surfaces)             # 111o
        selb    $t_4,$t_3,$k_farthest,$c_directional    # 112e
        lqd     $share_8,944($a_surfaces)               # 112o
        fma     $facing_plane_6,$plane_z_2,$to_z_4,$facing_plane_6 # 113e
        lqd     $diffuse_5,880($a_surfaces)             # 113o
        fma     $facing_6,$normal_y_4,$to_y_6,$facing_5 # 114e
        fma     $facing_plane_7,$plane_z_3,$to_z_2,$facing_plane_7 # 115e
        fma     $point_x_2,$leave_5,$plane_x_5,$point_x_2 # 116e
        cgti    $facing_4,$facing_4,0                   # 117e
        fma     $inverse,$t_e_6,$inverse,$t_y_7         # 118e
        fma     $facing_3,$normal_z_2,$to_z_6,$facing_3 # 119e
        fma     $facing_6,$normal_z_3,$to_z_4,$facing_6 # 120e
        cgti    $facing_plane_8,$facing_plane_7,0       # 121e
        fma     $facing_plane_9,$plane_z_5,$to_z_6,$facing_plane_5 # 122e
        stqd    $point_x_2,32($a_shadow_2)              # 122o
        and     $facing_7,$facing_4,$facing_plane_8     # 123e
        selb    $inverse_11,$inverse,$k_one,$c_directional # 124e
        and     $facing_4,$facing_7,$share_2            # 125e
        cgti    $facing_7,$facing_3,0                   # 126e
        selb    $t_5,$k_minus_one,$t_2,$facing_4        # 127e
        cgti    $facing_plane_9,$facing_plane_9,0       # 128e
        or      $share_8,$share_8,$diffuse_5            # 129e
        stqd    $t_5,384($a_shadow_2)                   # 129o
        fm      $t_6,$squared_5,$inverse                # 130e
        lqd     $normal_x_5,208($a_surfaces)            # 130o
        cgti    $facing_plane_10,$facing_plane_6,0      # 131e
        lqd     $normal_z_4,336($a_surfaces)            # 131o
        fm      $to_x_6,$to_x_5,$inverse_11             # 132e
        lqd     $normal_y_5,272($a_surfaces)            # 132o
        cgti    $facing,$facing_6,0                     # 133e
        and     $facing_7,$facing_7,$facing_plane_9     # 134e
        and     $facing_6,$facing,$facing_plane_10      # 135e
        lnop                                            # 135o pairing
next_site:
            fm      $to_y,$to_y_5,$inverse_11           # 0e
        lqd     $a_surfaces,0($a_site)                  # 0o
        ai      $a_site,$a_site,16                      # 1e
            cgti    $share,$share_5,0                   # 2e
            cgti    $share_8,$share_8,0                 # 3e
            fm      $to_z,$to_z_5,$inverse_11           # 4e
            fm      $facing_plane,$plane_x_4,$to_x_6    # 5e
            stqd    $to_x_6,208($a_shadow_2)            # 5o
            fm      $facing,$normal_x_5,$to_x_6         # 6e
            stqd    $to_y,272($a_shadow_2)              # 6o
            fma     $point_z,$leave_5,$plane_z_5,$point_z_3 # 7e
            and     $facing_8,$facing_6,$share_8        # 8e
            and     $facing_6,$facing_7,$share_7        # 9e
        lqd     $point_y,112($a_surfaces)               # 9o
            fma     $point_y_6,$leave_3,$plane_y_5,$point_y_2 # 10e
            stqd    $to_z,336($a_shadow_2)              # 10o
            fma     $facing_plane,$plane_y_3,$to_y,$facing_plane # 11e
        lqd     $point_x,0($a_surfaces)                 # 11o
            fma     $facing,$normal_y_5,$to_y,$facing   # 12e
        lqd     $point_x_2,32($a_surfaces)              # 12o
            fma     $point_y_7,$leave_5,$plane_y_4,$point_y_3 # 13e
            stqd    $point_z,160($a_shadow_2)           # 13o
            sf      $rays_2,$facing_4,$rays             # 14e true is -1
        lqd     $point_x_3,48($a_surfaces)              # 14o
            fm      $t,$squared_3,$inverse_7            # 15e
        lqd     $point_y_2,64($a_surfaces)              # 15o
            selb    $t_7,$t_6,$k_farthest,$c_directional # 16e
            stqd    $point_y_6,64($a_shadow_2)          # 16o
        fnms    $to_x_2,$point_x,$k_near,$light_x       # 17e
            fma     $facing_plane,$plane_z_4,$to_z,$facing_plane # 18e
        fnms    $to_x_3,$point_x_2,$k_near,$light_x     # 19e
        lqd     $point_z_2,128($a_surfaces)             # 19o
        fnms    $to_x_4,$point_x_3,$k_near,$light_x     # 20e
            stqd    $point_y_7,96($a_shadow_2)          # 20o
        fnms    $to_y_2,$point_y_2,$k_near,$light_y     # 21e
        fnms    $to_y_4,$point_y,$k_near,$light_y       # 22e
            fma     $facing,$normal_z_4,$to_z,$facing   # 23e
        lqd     $point_y_3,96($a_surfaces)              # 23o
            cgti    $facing_plane,$facing_plane,0       # 24e
        lqd     $point_z_6,144($a_surfaces)             # 24o
        fnms    $to_z_7,$point_z_2,$k_near,$light_z     # 25e
        lqd     $point_z_3,160($a_surfaces)             # 25o
        fm      $squared,$to_x_2,$to_x_2                # 26e
        lnop                                            # 26o pairing
        fm      $squared_2,$to_x_3,$to_x_3              # 27e
        lqd     $point_z_4,176($a_surfaces)             # 27o
        fm      $squared_3,$to_x_4,$to_x_4              # 28e
        fnms    $to_y_7,$point_y_3,$k_near,$light_y     # 29e
        fnms    $to_z_5,$point_z_6,$k_near,$light_z     # 30e
        fnms    $to_z_3,$point_z_3,$k_near,$light_z     # 31e
        fma     $squared,$to_y_2,$to_y_2,$squared       # 32e
        fnms    $to_z_4,$point_z_4,$k_near,$light_z     # 33e
            cgti    $facing,$facing,0                   # 34e
        lqd     $point_y_4,80($a_surfaces)              # 34o
        fma     $squared_2,$to_y_7,$to_y_7,$squared_2   # 35e
        fma     $squared_3,$to_y_4,$to_y_4,$squared_3   # 36e
            and     $facing,$facing,$facing_plane       # 37e
        fma     $squared,$to_z_7,$to_z_7,$squared       # 38e
            and     $facing,$facing,$share              # 39e
        lqd     $share,896($a_surfaces)                 # 39o
        fnms    $to_y_5,$point_y_4,$k_near,$light_y     # 40e
        lqd     $diffuse_6,832($a_surfaces)             # 40o
            selb    $t_7,$k_minus_one,$t_7,$facing      # 41e
            sf      $rays_2,$facing,$rays_2             # 42e true is -1
        fma     $squared_2,$to_z_3,$to_z_3,$squared_2   # 43e
            stqd    $t_7,400($a_shadow_2)               # 43o
            sf      $rays_2,$facing_6,$rays_2           # 44e true is -1
        lqd     $plane_x_2,384($a_surfaces)             # 44o
        fma     $squared_3,$to_z_4,$to_z_4,$squared_3   # 45e
        frsqest $t_y_8,$squared                         # 45o
        or      $share,$share,$diffuse_6                # 46e
        lqd     $plane_x_3,432($a_surfaces)             # 46o
            sf      $rays,$facing_8,$rays_2             # 47e true is -1
        lqd     $plane_y_6,496($a_surfaces)             # 47o
        cgti    $share,$share,0                         # 48e
        lqd     $share_3,912($a_surfaces)               # 48o
        fi      $t_y_8,$squared,$t_y_8                  # 49e
        frsqest $t_y_9,$squared_2                       # 49o
            selb    $t,$t,$k_farthest,$c_directional    # 50e
        lqd     $diffuse_7,848($a_surfaces)             # 50o
            selb    $t_8,$k_minus_one,$t_4,$facing_6    # 51e
        frsqest $t_y_2,$squared_3                       # 51o
            selb    $t,$k_minus_one,$t,$facing_8        # 52e
        lqd     $leave_2,624($a_surfaces)               # 52o
        fi      $t_y_9,$squared_2,$t_y_9                # 53e
            stqd    $t_8,416($a_shadow_2)               # 53o
        ai      $count,$count,-1                        # 54e
        lqd     $plane_z_6,560($a_surfaces)             # 54o
        fi      $t_y_2,$squared_3,$t_y_2                # 55e
            stqd    $t,432($a_shadow_2)                 # 55o
        or      $share_5,$share_3,$diffuse_7            # 56e
        rotqbyi $a_shadow_2,$a_surfaces,8               # 56o
        fm      $t_e_2,$squared,$t_y_8                  # 57e
        lqd     $leave_3,576($a_surfaces)               # 57o
        fm      $inverse_2,$t_y_8,$k_half               # 58e
        lqd     $plane_x_4,400($a_surfaces)             # 58o
        fma     $point_x_3,$leave_2,$plane_x_3,$point_x_3 # 59e
        lqd     $plane_z_3,512($a_surfaces)             # 59o
        fma     $point_y,$leave_2,$plane_y_6,$point_y   # 60e
        lqd     $plane_z_4,528($a_surfaces)             # 60o
        fm      $t_e_3,$squared_2,$t_y_9                # 61e
        lqd     $leave_4,592($a_surfaces)               # 61o
        fma     $point_z_7,$leave_2,$plane_z_6,$point_z_4 # 62e
        lqd     $point_x_6,16($a_surfaces)              # 62o
        fma     $point_x,$leave_3,$plane_x_2,$point_x   # 63e
        lqd     $share_4,928($a_surfaces)               # 63o
        fm      $inverse_4,$t_y_2,$k_half               # 64e
        lqd     $diffuse_3,864($a_surfaces)             # 64o
        fnms    $t_e_2,$t_e_2,$t_y_8,$k_one             # 65e
        stqd    $background,496($a_shadow_2)            # 65o
        fm      $inverse_3,$t_y_9,$k_half               # 66e
        stqd    $point_y,112($a_shadow_2)               # 66o
        fm      $t_e_7,$squared_3,$t_y_2                # 67e
        stqd    $background,480($a_shadow_2)            # 67o
        fma     $point_x_5,$leave_4,$plane_x_4,$point_x_6 # 68e
        stqd    $point_z_7,176($a_shadow_2)             # 68o
        fnms    $t_e_4,$t_e_3,$t_y_9,$k_one             # 69e
        stqd    $point_x,0($a_shadow_2)                 # 69o
        fnms    $to_x_6,$point_x_6,$k_near,$light_x     # 70e
        stqd    $point_x_3,48($a_shadow_2)              # 70o
        fma     $point_z_8,$leave_4,$plane_z_4,$point_z_6 # 71e
        stqd    $background,448($a_shadow_2)            # 71o
        or      $share_9,$share_4,$diffuse_3            # 72e
        lqd     $plane_y_3,464($a_surfaces)             # 72o
        fnms    $t_e_7,$t_e_7,$t_y_2,$k_one             # 73e
        stqd    $background,464($a_shadow_2)            # 73o
        fma     $inverse_12,$t_e_2,$inverse_2,$t_y_8    # 74e
        stqd    $point_x_5,16($a_shadow_2)              # 74o
        fma     $inverse_13,$t_e_4,$inverse_3,$t_y_9    # 75e
        fm      $squared_5,$to_x_6,$to_x_6              # 76e
        fma     $point_z_2,$leave_3,$plane_z_3,$point_z_2 # 77e
        stqd    $point_z_8,144($a_shadow_2)             # 77o
        fma     $point_y_8,$leave_4,$plane_y_3,$point_y_4 # 78e
        fma     $inverse_7,$t_e_7,$inverse_4,$t_y_2     # 79e
        fm      $t_2,$squared,$inverse_12               # 80e
        selb    $inverse_14,$inverse_12,$k_one,$c_directional # 81e
        selb    $inverse_12,$inverse_13,$k_one,$c_directional # 82e
        lnop                                            # 82o pairing
        fma     $squared_5,$to_y_5,$to_y_5,$squared_5   # 83e
        stqd    $point_z_2,128($a_shadow_2)             # 83o
        fm      $to_x_2,$to_x_2,$inverse_14             # 84e
        stqd    $point_y_8,80($a_shadow_2)              # 84o
        fm      $to_x,$to_x_3,$inverse_12               # 85e
        lqd     $normal_x_6,192($a_surfaces)            # 85o
        fm      $to_y_8,$to_y_7,$inverse_12             # 86e
        lqd     $plane_y_4,480($a_surfaces)             # 86o
        fm      $to_z_7,$to_z_7,$inverse_14             # 87e
        lqd     $normal_y_6,256($a_surfaces)            # 87o
        fm      $to_y_2,$to_y_2,$inverse_14             # 88e
        lqd     $normal_x_3,224($a_surfaces)            # 88o
        selb    $inverse_9,$inverse_7,$k_one,$c_directional # 89e
        lqd     $plane_x_5,416($a_surfaces)             # 89o
        fma     $squared_5,$to_z_5,$to_z_5,$squared_5   # 90e
        stqd    $to_x_2,192($a_shadow_2)                # 90o
        fm      $facing_4,$normal_x_6,$to_x_2           # 91e
        stqd    $to_x,224($a_shadow_2)                  # 91o
        fm      $to_z_4,$to_z_4,$inverse_9              # 92e
        stqd    $to_y_8,288($a_shadow_2)                # 92o
        fm      $to_y_4,$to_y_4,$inverse_9              # 93e
        stqd    $to_z_7,320($a_shadow_2)                # 93o
        fm      $facing_3,$normal_x_3,$to_x             # 94e
        stqd    $to_y_2,256($a_shadow_2)                # 94o
        fm      $facing_plane_2,$plane_x_5,$to_x        # 95e
        lqd     $normal_y_3,288($a_surfaces)            # 95o
        fm      $facing_plane_8,$plane_x_2,$to_x_2      # 96e
        frsqest $t_y_7,$squared_5                       # 96o
        fm      $to_x_4,$to_x_4,$inverse_9              # 97e
        lqd     $normal_x_4,240($a_surfaces)            # 97o
        fm      $to_z_8,$to_z_3,$inverse_12             # 98e
        stqd    $to_z_4,368($a_shadow_2)                # 98o
        fma     $facing_4,$normal_y_6,$to_y_2,$facing_4 # 99e
        stqd    $to_y_4,304($a_shadow_2)                # 99o
        fi      $t_y_7,$squared_5,$t_y_7                # 100e
        lqd     $plane_y_5,448($a_surfaces)             # 100o
        selb    $t_2,$t_2,$k_farthest,$c_directional    # 101e
        lqd     $normal_z_5,320($a_surfaces)            # 101o
        fma     $facing_3,$normal_y_3,$to_y_8,$facing_3 # 102e
        lqd     $normal_z_6,352($a_surfaces)            # 102o
        fm      $facing_plane_4,$plane_x_3,$to_x_4      # 103e
        stqd    $to_x_4,240($a_shadow_2)                # 103o
        fm      $facing_9,$normal_x_4,$to_x_4           # 104e
        stqd    $to_z_8,352($a_shadow_2)                # 104o
        fma     $facing_plane_2,$plane_y_4,$to_y_8,$facing_plane_2 # 105e
        lqd     $normal_y_2,304($a_surfaces)            # 105o
        fma     $facing_plane_8,$plane_y_5,$to_y_2,$facing_plane_8 # 106e
        fm      $t_e_8,$squared_5,$t_y_7                # 107e
        fma     $facing_4,$normal_z_5,$to_z_7,$facing_4 # 108e
        fma     $facing_3,$normal_z_6,$to_z_8,$facing_3 # 109e
        fma     $facing_plane_9,$plane_y_6,$to_y_4,$facing_plane_4 # 110e
        fma     $facing_10,$normal_y_2,$to_y_4,$facing_9 # 111e
        fma     $facing_plane_8,$plane_z_3,$to_z_7,$facing_plane_8 # 112e
        lnop                                            # 112o pairing
        fm      $inverse_15,$t_y_7,$k_half              # 113e
        lqd     $plane_z_5,544($a_surfaces)             # 113o
        cgti    $share_7,$share_9,0                     # 114e
        lqd     $normal_z_7,368($a_surfaces)            # 114o
        cgti    $facing_3,$facing_3,0                   # 115e
        cgti    $facing_4,$facing_4,0                   # 116e
        fma     $facing_plane_11,$plane_z_6,$to_z_4,$facing_plane_9 # 117e
        cgti    $facing_plane_8,$facing_plane_8,0       # 118e
        fma     $facing_plane_9,$plane_z_5,$to_z_8,$facing_plane_2 # 119e
        lqd     $leave_5,608($a_surfaces)               # 119o
        fma     $facing,$normal_z_7,$to_z_4,$facing_10  # 120e
        hbrr    next_site_back,next_site                # 120o hint
        and     $facing_2,$facing_4,$facing_plane_8     # 121e
        fnms    $t_e_8,$t_e_8,$t_y_7,$k_one             # 122e
        fm      $t_3,$squared_2,$inverse_13             # 123e
        cgti    $facing_plane_11,$facing_plane_11,0     # 124e
        fma     $point_x_2,$leave_5,$plane_x_5,$point_x_2 # 125e
        cgti    $facing_plane_9,$facing_plane_9,0       # 126e
        and     $facing_4,$facing_2,$share              # 127e
        lqd     $share,944($a_surfaces)                 # 127o
        cgti    $facing,$facing,0                       # 128e
        lqd     $diffuse_8,880($a_surfaces)             # 128o
        fma     $inverse,$t_e_8,$inverse_15,$t_y_7      # 129e
        selb    $t_5,$k_minus_one,$t_2,$facing_4        # 130e
        and     $facing_6,$facing,$facing_plane_11      # 131e
        stqd    $point_x_2,32($a_shadow_2)              # 131o
        and     $facing_7,$facing_3,$facing_plane_9     # 132e
        stqd    $t_5,384($a_shadow_2)                   # 132o
        selb    $t_4,$t_3,$k_farthest,$c_directional    # 133e
        lnop                                            # 133o pairing
        or      $share_8,$share,$diffuse_8              # 134e
        lqd     $normal_z_4,336($a_surfaces)            # 134o
        selb    $inverse_11,$inverse,$k_one,$c_directional # 135e
        lqd     $normal_x_5,208($a_surfaces)            # 135o
        fm      $t_6,$squared_5,$inverse                # 136e
        lqd     $normal_y_5,272($a_surfaces)            # 136o
        fm      $to_x_6,$to_x_6,$inverse_11             # 137e
next_site_back:
        brnz    $count,next_site                        # 137o
next_site_drain:
        fm      $facing_plane_12,$plane_x_4,$to_x_6     # 0e
        hbr     shadow_rays_r16_return,$lr              # 0o hint
        fm      $to_y,$to_y_5,$inverse_11               # 1e
        stqd    $to_x_6,208($a_shadow_2)                # 1o
        fm      $facing,$normal_x_5,$to_x_6             # 2e
        fm      $to_z,$to_z_5,$inverse_11               # 3e
        fma     $point_y_6,$leave_3,$plane_y_5,$point_y_2 # 4e
        cgti    $share,$share_5,0                       # 5e
        fma     $point_z,$leave_5,$plane_z_5,$point_z_3 # 6e
        lnop                                            # 6o pairing
        fma     $facing_plane,$plane_y_3,$to_y,$facing_plane_12 # 7e
        stqd    $to_y,272($a_shadow_2)                  # 7o
        fma     $facing,$normal_y_5,$to_y,$facing       # 8e
        lnop                                            # 8o pairing
        fma     $point_y_7,$leave_5,$plane_y_4,$point_y_3 # 9e
        stqd    $to_z,336($a_shadow_2)                  # 9o
        fm      $t,$squared_3,$inverse_7                # 10e
        and     $facing_11,$facing_7,$share_7           # 11e
        cgti    $share_8,$share_8,0                     # 12e
        stqd    $point_z,160($a_shadow_2)               # 12o
        fma     $facing_plane,$plane_z_4,$to_z,$facing_plane # 13e
        stqd    $point_y_6,64($a_shadow_2)              # 13o
        fma     $facing,$normal_z_4,$to_z,$facing       # 14e
        lnop                                            # 14o pairing
        selb    $t_9,$k_minus_one,$t_4,$facing_11       # 15e
        stqd    $point_y_7,96($a_shadow_2)              # 15o
        selb    $t,$t,$k_farthest,$c_directional        # 16e
        and     $facing_8,$facing_6,$share_8            # 17e
        sf      $rays_2,$facing_4,$rays                 # 18e true is -1
        cgti    $facing_plane,$facing_plane,0           # 19e
        cgti    $facing,$facing,0                       # 20e
        selb    $t_7,$t_6,$k_farthest,$c_directional    # 21e
        and     $facing,$facing,$facing_plane           # 22e
        selb    $t,$k_minus_one,$t,$facing_8            # 23e
        and     $facing,$facing,$share                  # 24e
        sf      $rays_2,$facing,$rays_2                 # 26e true is -1
        selb    $t_7,$k_minus_one,$t_7,$facing          # 27e
        sf      $rays_2,$facing_11,$rays_2              # 28e true is -1
        nop     $127                                    # 29e pairing
        stqd    $t_7,400($a_shadow_2)                   # 29o
        sf      $rays,$facing_8,$rays_2                 # 30e true is -1
        stqd    $t_9,416($a_shadow_2)                   # 30o
        nop     $127                                    # 31e pairing
        stqd    $t,432($a_shadow_2)                     # 31o
        ori     $a_site,$rays,0                         # 32e
shadow_rays_r16_return:
        bi      $lr                                     # 32o
next_site_short:
        ai      $count,$count,-1                        # 0e
        lqd     $a_surfaces,0($a_site)                  # 0o
        ai      $a_site,$a_site,16                      # 1e
        rotqbyi $a_shadow,$a_surfaces,8                 # 6o
        lqd     $point_x,0($a_surfaces)                 # 7o
        lqd     $normal_x,192($a_surfaces)              # 8o
        lqd     $plane_x,384($a_surfaces)               # 9o
        lqd     $point_y,64($a_surfaces)                # 10o
        lqd     $normal_y,256($a_surfaces)              # 11o
        lqd     $plane_y,448($a_surfaces)               # 12o
        fnms    $to_x,$point_x,$k_near,$light_x         # 13e
        lqd     $point_z,128($a_surfaces)               # 13o
        lqd     $normal_z,320($a_surfaces)              # 14o
        lqd     $plane_z,512($a_surfaces)               # 15o
        fnms    $to_y,$point_y,$k_near,$light_y         # 16e
        lqd     $share,896($a_surfaces)                 # 16o
        lqd     $diffuse,832($a_surfaces)               # 17o
        stqd    $background,448($a_shadow)              # 18o
        fnms    $to_z,$point_z,$k_near,$light_z         # 19e
        lqd     $leave,576($a_surfaces)                 # 19o
        fm      $squared,$to_x,$to_x                    # 20e
        lqd     $point_x_7,16($a_surfaces)              # 20o
        lqd     $normal_x_7,208($a_surfaces)            # 21o
        lqd     $plane_x_6,400($a_surfaces)             # 22o
        or      $share,$share,$diffuse                  # 23e
        lqd     $point_y_9,80($a_surfaces)              # 23o
        nop     $127                                    # 24e pairing
        lqd     $normal_y_7,272($a_surfaces)            # 24o
        cgti    $share,$share,0                         # 25e
        lqd     $plane_y_7,464($a_surfaces)             # 25o
        fma     $squared,$to_y,$to_y,$squared           # 26e
        lqd     $point_z_9,144($a_surfaces)             # 26o
        fma     $point_x,$leave,$plane_x,$point_x       # 27e
        lqd     $normal_z_8,336($a_surfaces)            # 27o
        fma     $point_y,$leave,$plane_y,$point_y       # 28e
        lqd     $plane_z_7,528($a_surfaces)             # 28o
        fma     $point_z,$leave,$plane_z,$point_z       # 29e
        lqd     $share_7,912($a_surfaces)               # 29o
        fnms    $to_x_7,$point_x_7,$k_near,$light_x     # 30e
        lqd     $diffuse_9,848($a_surfaces)             # 30o
        fnms    $to_y_7,$point_y_9,$k_near,$light_y     # 31e
        stqd    $background,464($a_shadow)              # 31o
        fma     $squared,$to_z,$to_z,$squared           # 32e
        lqd     $leave_6,592($a_surfaces)               # 32o
        fnms    $to_z_3,$point_z_9,$k_near,$light_z     # 33e
        stqd    $point_x,0($a_shadow)                   # 33o
        stqd    $point_y,64($a_shadow)                  # 34o
        stqd    $point_z,128($a_shadow)                 # 35o
        fm      $squared_4,$to_x_7,$to_x_7              # 36e
        lqd     $point_x_8,32($a_surfaces)              # 36o
        or      $share_10,$share_7,$diffuse_9           # 37e
        lqd     $normal_x_8,224($a_surfaces)            # 37o
        fma     $point_x_7,$leave_6,$plane_x_6,$point_x_7 # 38e
        frsqest $t_y_10,$squared                        # 38o
        cgti    $share_10,$share_10,0                   # 39e
        lqd     $plane_x_7,416($a_surfaces)             # 39o
        fma     $point_y_9,$leave_6,$plane_y_7,$point_y_9 # 40e
        lqd     $point_y_4,96($a_surfaces)              # 40o
        fma     $point_z_9,$leave_6,$plane_z_7,$point_z_9 # 41e
        lqd     $normal_y_8,288($a_surfaces)            # 41o
        fi      $t_y_10,$squared,$t_y_10                # 42e
        lqd     $plane_y_8,480($a_surfaces)             # 42o
        nop     $127                                    # 43e pairing
        lqd     $point_z_10,160($a_surfaces)            # 43o
        fma     $squared_4,$to_y_7,$to_y_7,$squared_4   # 44e
        stqd    $point_x_7,16($a_shadow)                # 44o
        fnms    $to_x_8,$point_x_8,$k_near,$light_x     # 45e
        lqd     $normal_z_5,352($a_surfaces)            # 45o
        fnms    $to_y_9,$point_y_4,$k_near,$light_y     # 46e
        stqd    $point_y_9,80($a_shadow)                # 46o
        stqd    $point_z_9,144($a_shadow)               # 47o
        lqd     $plane_z_8,544($a_surfaces)             # 48o
        fm      $t_e_9,$squared,$t_y_10                 # 49e
        lqd     $share_11,928($a_surfaces)              # 49o
        fm      $inverse_16,$t_y_10,$k_half             # 50e
        lqd     $diffuse_10,864($a_surfaces)            # 50o
        fma     $squared_4,$to_z_3,$to_z_3,$squared_4   # 51e
        stqd    $background,480($a_shadow)              # 51o
        fnms    $to_z_9,$point_z_10,$k_near,$light_z    # 52e
        lqd     $leave_7,608($a_surfaces)               # 52o
        fm      $squared_6,$to_x_8,$to_x_8              # 53e
        lqd     $point_x_9,48($a_surfaces)              # 53o
        nop     $127                                    # 54e pairing
        lqd     $normal_x_9,240($a_surfaces)            # 54o
        fnms    $t_e_9,$t_e_9,$t_y_10,$k_one            # 55e
        lqd     $plane_x_8,432($a_surfaces)             # 55o
        or      $share_11,$share_11,$diffuse_10         # 56e
        lqd     $point_y_10,112($a_surfaces)            # 56o
        nop     $127                                    # 57e pairing
        frsqest $t_y_11,$squared_4                      # 57o
        cgti    $share_11,$share_11,0                   # 58e
        lqd     $normal_y_9,304($a_surfaces)            # 58o
        fma     $squared_6,$to_y_9,$to_y_9,$squared_6   # 59e
        lqd     $plane_y_9,496($a_surfaces)             # 59o
        fma     $point_x_8,$leave_7,$plane_x_7,$point_x_8 # 60e
        lqd     $point_z_11,176($a_surfaces)            # 60o
        fma     $inverse_17,$t_e_9,$inverse_16,$t_y_10  # 61e
        lqd     $normal_z_9,368($a_surfaces)            # 61o
        fi      $t_y_12,$squared_4,$t_y_11              # 62e
        lqd     $plane_z_9,560($a_surfaces)             # 62o
        nop     $127                                    # 63e pairing
        lqd     $share_12,944($a_surfaces)              # 63o
        fma     $point_y_4,$leave_7,$plane_y_8,$point_y_4 # 64e
        lqd     $diffuse_11,880($a_surfaces)            # 64o
        fma     $squared_6,$to_z_9,$to_z_9,$squared_6   # 65e
        stqd    $background,496($a_shadow)              # 65o
        fma     $point_z_10,$leave_7,$plane_z_8,$point_z_10 # 66e
        stqd    $point_x_8,32($a_shadow)                # 66o
        fm      $t_2,$squared,$inverse_17               # 67e
        lqd     $leave_8,624($a_surfaces)               # 67o
        selb    $inverse_14,$inverse_17,$k_one,$c_directional # 68e
        fm      $t_e_9,$squared_4,$t_y_12               # 69e
        fm      $to_x,$to_x,$inverse_14                 # 70e
        stqd    $point_y_4,96($a_shadow)                # 70o
        fm      $to_y,$to_y,$inverse_14                 # 71e
        frsqest $t_y_13,$squared_6                      # 71o
        fm      $to_z,$to_z,$inverse_14                 # 72e
        stqd    $point_z_10,160($a_shadow)              # 72o
        selb    $t_2,$t_2,$k_farthest,$c_directional    # 73e
        fm      $inverse_14,$t_y_12,$k_half             # 74e
        fnms    $t_e_9,$t_e_9,$t_y_12,$k_one            # 75e
        lnop                                            # 75o pairing
        fm      $facing_12,$normal_x,$to_x              # 76e
        stqd    $to_x,192($a_shadow)                    # 76o
        fm      $facing_plane_2,$plane_x,$to_x          # 77e
        stqd    $to_y,256($a_shadow)                    # 77o
        fi      $t_y_14,$squared_6,$t_y_13              # 78e
        stqd    $to_z,320($a_shadow)                    # 78o
        or      $share_13,$share_12,$diffuse_11         # 79e
        fnms    $to_x_9,$point_x_9,$k_near,$light_x     # 80e
        fma     $inverse_14,$t_e_9,$inverse_14,$t_y_12  # 81e
        fma     $facing_12,$normal_y,$to_y,$facing_12   # 82e
        fma     $facing_plane_2,$plane_y,$to_y,$facing_plane_2 # 83e
        fnms    $to_y,$point_y_10,$k_near,$light_y      # 84e
        fm      $t_e_10,$squared_6,$t_y_14              # 85e
        fm      $inverse_18,$t_y_14,$k_half             # 86e
        fm      $t,$squared_4,$inverse_14               # 87e
        fma     $facing_13,$normal_z,$to_z,$facing_12   # 88e
        fma     $facing_plane_2,$plane_z,$to_z,$facing_plane_2 # 89e
        selb    $inverse_19,$inverse_14,$k_one,$c_directional # 90e
        fnms    $t_e_11,$t_e_10,$t_y_14,$k_one          # 91e
        fm      $to_x_3,$to_x_7,$inverse_19             # 92e
        selb    $t,$t,$k_farthest,$c_directional        # 93e
        cgti    $facing_13,$facing_13,0                 # 94e
        cgti    $facing_plane_2,$facing_plane_2,0       # 95e
        fm      $to_y_8,$to_y_7,$inverse_19             # 96e
        and     $facing_13,$facing_13,$facing_plane_2   # 97e
        lnop                                            # 97o pairing
        fm      $to_z,$to_z_3,$inverse_19               # 98e
        stqd    $to_x_3,208($a_shadow)                  # 98o
        and     $facing_13,$facing_13,$share            # 99e
        fm      $facing_6,$normal_x_7,$to_x_3           # 100e
        sf      $rays,$facing_13,$rays                  # 101e true is -1
        lnop                                            # 101o pairing
        selb    $t_10,$k_minus_one,$t_2,$facing_13      # 102e
        stqd    $to_y_8,272($a_shadow)                  # 102o
        fm      $facing_plane_8,$plane_x_6,$to_x_3      # 103e
        lnop                                            # 103o pairing
        fma     $inverse_5,$t_e_11,$inverse_18,$t_y_14  # 104e
        stqd    $t_10,384($a_shadow)                    # 104o
        fnms    $to_z_10,$point_z_11,$k_near,$light_z   # 105e
        stqd    $to_z,336($a_shadow)                    # 105o
        fma     $facing_6,$normal_y_7,$to_y_8,$facing_6 # 106e
        fm      $squared,$to_x_9,$to_x_9                # 107e
        cgti    $share,$share_13,0                      # 108e
        fma     $facing_plane_8,$plane_y_7,$to_y_8,$facing_plane_8 # 109e
        fm      $t_11,$squared_6,$inverse_5             # 110e
        selb    $inverse,$inverse_5,$k_one,$c_directional # 111e
        fma     $facing,$normal_z_8,$to_z,$facing_6     # 112e
        fm      $to_x_8,$to_x_8,$inverse                # 113e
        fm      $to_y_3,$to_y_9,$inverse                # 114e
        fma     $facing_plane,$plane_z_7,$to_z,$facing_plane_8 # 115e
        selb    $t_12,$t_11,$k_farthest,$c_directional  # 116e
        fm      $to_z,$to_z_9,$inverse                  # 117e
        cgti    $facing,$facing,0                       # 118e
        lnop                                            # 118o pairing
        fm      $facing_14,$normal_x_8,$to_x_8          # 119e
        stqd    $to_x_8,224($a_shadow)                  # 119o
        fm      $facing_plane_13,$plane_x_7,$to_x_8     # 120e
        stqd    $to_y_3,288($a_shadow)                  # 120o
        cgti    $facing_plane,$facing_plane,0           # 121e
        fma     $squared,$to_y,$to_y,$squared           # 122e
        and     $facing,$facing,$facing_plane           # 123e
        stqd    $to_z,352($a_shadow)                    # 123o
        fma     $point_x_3,$leave_8,$plane_x_8,$point_x_9 # 124e
        and     $facing,$facing,$share_10               # 125e
        fma     $facing_14,$normal_y_8,$to_y_3,$facing_14 # 126e
        sf      $rays,$facing,$rays                     # 127e true is -1
        selb    $t,$k_minus_one,$t,$facing              # 128e
        fma     $facing_plane,$plane_y_8,$to_y_3,$facing_plane_13 # 129e
        fma     $squared,$to_z_10,$to_z_10,$squared     # 130e
        stqd    $t,400($a_shadow)                       # 130o
        fma     $point_y_11,$leave_8,$plane_y_9,$point_y_10 # 131e
        stqd    $point_x_3,48($a_shadow)                # 131o
        fma     $facing,$normal_z_5,$to_z,$facing_14    # 132e
        fma     $point_z,$leave_8,$plane_z_9,$point_z_11 # 133e
        fma     $facing_plane,$plane_z_8,$to_z,$facing_plane # 135e
        hbrr    next_site_short_back,next_site_short    # 135o hint
        frsqest $t_y,$squared                           # 136o
        stqd    $point_y_11,112($a_shadow)              # 137o
        cgti    $facing,$facing,0                       # 138e
        stqd    $point_z,176($a_shadow)                 # 139o
        fi      $t_y,$squared,$t_y                      # 140e
        cgti    $facing_plane,$facing_plane,0           # 141e
        and     $facing,$facing,$facing_plane           # 143e
        and     $facing,$facing,$share_11               # 145e
        sf      $rays,$facing,$rays                     # 147e true is -1
        selb    $t,$k_minus_one,$t_12,$facing           # 148e
        fm      $t_e,$squared,$t_y                      # 149e
        lnop                                            # 149o pairing
        fm      $inverse,$t_y,$k_half                   # 150e
        stqd    $t,416($a_shadow)                       # 150o
        fnms    $t_e,$t_e,$t_y,$k_one                   # 155e
        fma     $inverse,$t_e,$inverse,$t_y             # 161e
        fm      $t,$squared,$inverse                    # 167e
        selb    $inverse,$inverse,$k_one,$c_directional # 168e
        fm      $to_x,$to_x_9,$inverse                  # 170e
        fm      $to_y,$to_y,$inverse                    # 171e
        fm      $to_z,$to_z_10,$inverse                 # 172e
        selb    $t,$t,$k_farthest,$c_directional        # 173e
        fm      $facing,$normal_x_9,$to_x               # 176e
        stqd    $to_x,240($a_shadow)                    # 176o
        fm      $facing_plane,$plane_x_8,$to_x          # 177e
        stqd    $to_y,304($a_shadow)                    # 177o
        stqd    $to_z,368($a_shadow)                    # 178o
        fma     $facing,$normal_y_9,$to_y,$facing       # 182e
        fma     $facing_plane,$plane_y_9,$to_y,$facing_plane # 183e
        fma     $facing,$normal_z_9,$to_z,$facing       # 188e
        fma     $facing_plane,$plane_z_9,$to_z,$facing_plane # 189e
        cgti    $facing,$facing,0                       # 194e
        cgti    $facing_plane,$facing_plane,0           # 195e
        and     $facing,$facing,$facing_plane           # 197e
        and     $facing,$facing,$share                  # 199e
        sf      $rays,$facing,$rays                     # 201e true is -1
        selb    $t,$k_minus_one,$t,$facing              # 202e
        stqd    $t,432($a_shadow)                       # 204o
        nop     $127                                    # 205e pairing
next_site_short_back:
        brnz    $count,next_site_short                  # 205o
        ori     $a_site,$rays,0                         # 206e
        bi      $lr                                     # 206o
endfunction shadow_rays_r16
