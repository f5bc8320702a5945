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
        .set m_lane_2,2; .set m_lane_3,5; .set m_lane_4,7; .set count_2,79; .set point_x_2,8
        .set point_x_3,9; .set point_x_4,20; .set point_y_2,31; .set point_x_5,24
        .set point_y_3,29; .set to_x_2,28; .set point_y_4,43; .set to_x_3,23; .set point_z_2,27
        .set to_x_4,32; .set point_y_5,26; .set to_y_2,40; .set point_z_3,34; .set to_x_5,22
        .set point_z_4,45; .set to_y_3,41; .set point_z_5,37; .set plane_x_2,53; .set squared_2,48
        .set leave_2,55; .set squared_3,46; .set plane_x_3,57; .set to_y_4,49; .set leave_3,59
        .set to_z_2,33; .set plane_x_4,61; .set to_y_5,35; .set leave_4,54; .set plane_y_2,58
        .set squared_4,42; .set a_shadow_2,62; .set to_z_3,44; .set diffuse_2,52; .set share_2,2
        .set to_z_4,50; .set to_z_5,47; .set t_y_2,30; .set t_y_3,5; .set share_3,39; .set t_y_4,2
        .set t_y_5,38; .set t_y_6,52; .set t_e_2,5; .set t_y_7,8; .set plane_x_5,21; .set t_e_3,9
        .set normal_x_2,24; .set inverse_2,52; .set normal_y_2,25; .set t_e_4,51
        .set normal_x_3,26; .set inverse_3,63; .set t_e_5,56; .set inverse_4,64; .set inverse_5,5
        .set inverse_6,60; .set t_e_6,30; .set inverse_7,9; .set inverse_8,2; .set inverse_9,38
        .set t_2,56; .set to_x_6,8; .set to_y_6,28; .set inverse_10,30; .set inverse_11,36
        .set inverse_12,40; .set normal_x_4,51; .set normal_y_3,60; .set to_y_7,36
        .set normal_x_5,49; .set plane_y_3,38; .set facing_2,24; .set facing_plane_2,8
        .set to_z_6,30; .set normal_z_2,61; .set to_z_7,40; .set plane_z_2,52; .set facing_3,51
        .set facing_plane_3,57; .set facing_plane_4,32; .set facing_4,22; .set plane_y_4,44
        .set facing_plane_5,26; .set normal_y_4,53; .set facing_5,23; .set plane_y_5,28
        .set facing_6,25; .set normal_z_3,47; .set facing_plane_6,49; .set normal_y_5,51
        .set plane_z_3,36; .set plane_z_4,38; .set share_4,53; .set diffuse_3,58
        .set normal_z_4,33; .set facing_7,28; .set plane_z_5,23; .set facing_8,41
        .set normal_z_5,25; .set diffuse_4,47; .set share_5,50; .set facing_plane_7,31
        .set facing_plane_8,29; .set facing_9,33; .set share_6,24; .set t_3,5; .set leave_5,26
        .set t_4,19; .set facing_10,9; .set facing_11,8; .set point_z_6,25; .set facing_plane_9,30
        .set facing_12,57; .set share_7,32; .set share_8,31; .set rays_2,33; .set share_9,22
        .set t_5,51; .set facing_13,32; .set t_6,53; .set facing_14,2; .set rays_3,5
        .set facing_15,30; .set t_y_8,53; .set t_7,54; .set t_8,52; .set t_e_7,54; .set t_e_8,58
        .set t_e_9,21; .set t_e_10,25; .set inverse_13,21; .set inverse_14,24; .set inverse_15,26
        .set normal_x_6,28; .set normal_y_6,36; .set normal_x_7,40; .set normal_y_7,52
        .set normal_x_8,60; .set to_y_8,38; .set plane_y_6,49; .set to_z_8,24; .set facing_16,36
        .set to_z_9,9; .set facing_plane_10,23; .set plane_y_7,51; .set normal_z_6,40
        .set normal_y_8,47; .set facing_plane_11,25; .set facing_plane_12,33; .set normal_z_7,41
        .set diffuse_5,24; .set share_10,35; .set t_9,30; .set normal_z_8,24
        .set facing_plane_13,5; .set point_z_7,2; .set point_y_6,3; .set share_11,4
        .set facing_17,5; .set t_10,3; .set point_x_6,2; .set normal_x_9,5; .set plane_x_6,8
        .set point_y_7,9; .set normal_y_9,35; .set plane_y_8,37; .set point_z_8,38
        .set normal_z_9,39; .set plane_z_6,40; .set share_12,33; .set to_x_7,41; .set diffuse_6,42
        .set to_y_9,43; .set leave_6,44; .set to_z_10,45; .set squared_5,21; .set point_x_7,22
        .set share_13,23; .set normal_x_10,33; .set t_y_9,42; .set plane_x_7,46; .set point_y_8,47
        .set normal_y_10,44; .set plane_y_9,48; .set point_z_9,49; .set to_x_8,2
        .set normal_z_10,50; .set to_y_10,51; .set plane_z_7,9; .set t_e_11,38; .set share_14,52
        .set inverse_16,53; .set diffuse_7,54; .set to_z_11,55; .set leave_7,56; .set squared_6,57
        .set point_x_8,58; .set normal_x_11,59; .set plane_x_8,60; .set point_y_9,54
        .set t_y_10,61; .set normal_y_11,62; .set plane_y_10,63; .set point_z_10,64
        .set normal_z_11,42; .set plane_z_8,61; .set share_15,65; .set diffuse_8,66; .set t_11,22
        .set leave_8,19; .set t_y_11,47; .set facing_18,27; .set facing_plane_14,24
        .set share_16,47; .set to_x_9,49; .set t_e_12,28; .set inverse_17,31; .set facing_19,21
        .set t_e_13,27; .set to_y_11,29; .set t_12,21; .set inverse_18,22; .set to_z_12,21
        .set t_13,24; .set to_y_12,5; .set t_14,8; .set facing_plane_15,2; .set point_y_10,2
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
        lqd     $point_x_2,0($a_surfaces)               # 22o
        lqd     $point_x_3,48($a_surfaces)              # 23o
        lqd     $point_x_4,16($a_surfaces)              # 24o
        lqd     $point_y_2,64($a_surfaces)              # 25o
        lqd     $point_x_5,32($a_surfaces)              # 26o
        nop     $127                                    # 27e pairing
        lqd     $point_y_3,112($a_surfaces)             # 27o
        fnms    $to_x_2,$point_x_2,$k_near,$light_x     # 28e
        lqd     $point_y_4,80($a_surfaces)              # 28o
        fnms    $to_x_3,$point_x_3,$k_near,$light_x     # 29e
        lqd     $point_z_2,128($a_surfaces)             # 29o
        fnms    $to_x_4,$point_x_4,$k_near,$light_x     # 30e
        lqd     $point_y_5,96($a_surfaces)              # 30o
        fnms    $to_y_2,$point_y_2,$k_near,$light_y     # 31e
        lqd     $point_z_3,176($a_surfaces)             # 31o
        fnms    $to_x_5,$point_x_5,$k_near,$light_x     # 32e
        lqd     $point_z_4,144($a_surfaces)             # 32o
        fnms    $to_y_3,$point_y_3,$k_near,$light_y     # 33e
        lqd     $point_z_5,160($a_surfaces)             # 33o
        fm      $squared,$to_x_2,$to_x_2                # 34e
        lqd     $plane_x_2,432($a_surfaces)             # 34o
        fm      $squared_2,$to_x_3,$to_x_3              # 35e
        lqd     $leave_2,624($a_surfaces)               # 35o
        fm      $squared_3,$to_x_4,$to_x_4              # 36e
        lqd     $plane_x_3,416($a_surfaces)             # 36o
        fnms    $to_y_4,$point_y_4,$k_near,$light_y     # 37e
        lqd     $leave_3,608($a_surfaces)               # 37o
        fnms    $to_z_2,$point_z_2,$k_near,$light_z     # 38e
        lqd     $plane_x_4,384($a_surfaces)             # 38o
        fnms    $to_y_5,$point_y_5,$k_near,$light_y     # 39e
        lqd     $leave_4,576($a_surfaces)               # 39o
        fma     $squared,$to_y_2,$to_y_2,$squared       # 40e
        lqd     $plane_y_2,480($a_surfaces)             # 40o
        fm      $squared_4,$to_x_5,$to_x_5              # 41e
        rotqbyi $a_shadow_2,$a_surfaces,8               # 41o
        fnms    $to_z_3,$point_z_3,$k_near,$light_z     # 42e
        lqd     $diffuse_2,832($a_surfaces)             # 42o
        fma     $squared_2,$to_y_3,$to_y_3,$squared_2   # 43e
        lqd     $share_2,896($a_surfaces)               # 43o
        fnms    $to_z_4,$point_z_4,$k_near,$light_z     # 44e
        lnop                                            # 44o pairing
        fma     $squared_3,$to_y_4,$to_y_4,$squared_3   # 45e
        stqd    $background,480($a_shadow_2)            # 45o
        fma     $squared,$to_z_2,$to_z_2,$squared       # 46e
        fnms    $to_z_5,$point_z_5,$k_near,$light_z     # 47e
        fma     $squared_4,$to_y_5,$to_y_5,$squared_4   # 48e
        fma     $squared_2,$to_z_3,$to_z_3,$squared_2   # 49e
        fma     $point_x_3,$leave_2,$plane_x_2,$point_x_3 # 50e
        fma     $squared_3,$to_z_4,$to_z_4,$squared_3   # 51e
        fma     $point_x_5,$leave_3,$plane_x_3,$point_x_5 # 52e
        frsqest $t_y_2,$squared                         # 52o
        fma     $point_x_2,$leave_4,$plane_x_4,$point_x_2 # 53e
        fma     $squared_4,$to_z_5,$to_z_5,$squared_4   # 54e
        fma     $point_y_5,$leave_3,$plane_y_2,$point_y_5 # 55e
        frsqest $t_y_3,$squared_2                       # 55o
        fi      $t_y_2,$squared,$t_y_2                  # 56e
        stqd    $point_x_3,48($a_shadow_2)              # 56o
        or      $share_3,$share_2,$diffuse_2            # 57e
        frsqest $t_y_4,$squared_3                       # 57o
        nop     $127                                    # 58e pairing
        stqd    $background,448($a_shadow_2)            # 58o
        fi      $t_y_5,$squared_2,$t_y_3                # 59e
        stqd    $background,464($a_shadow_2)            # 59o
        cgti    $share_3,$share_3,0                     # 60e
        frsqest $t_y_6,$squared_4                       # 60o
        fi      $t_y_4,$squared_3,$t_y_4                # 61e
        stqd    $background,496($a_shadow_2)            # 61o
        nop     $127                                    # 62e pairing
        stqd    $point_x_5,32($a_shadow_2)              # 62o
        fm      $t_e_2,$squared,$t_y_2                  # 63e
        stqd    $point_x_2,0($a_shadow_2)               # 63o
        fi      $t_y_7,$squared_4,$t_y_6                # 64e
        stqd    $point_y_5,96($a_shadow_2)              # 64o
        nop     $127                                    # 65e pairing
        lqd     $plane_x_5,400($a_surfaces)             # 65o
        fm      $t_e_3,$squared_2,$t_y_5                # 66e
        lqd     $normal_x_2,192($a_surfaces)            # 66o
        fm      $inverse_2,$t_y_2,$k_half               # 67e
        lqd     $normal_y_2,272($a_surfaces)            # 67o
        fm      $t_e_4,$squared_3,$t_y_4                # 68e
        lqd     $normal_x_3,224($a_surfaces)            # 68o
        fnms    $t_e_2,$t_e_2,$t_y_2,$k_one             # 69e
        fm      $inverse_3,$t_y_5,$k_half               # 70e
        fm      $t_e_5,$squared_4,$t_y_7                # 71e
        fnms    $t_e_3,$t_e_3,$t_y_5,$k_one             # 72e
        fm      $inverse_4,$t_y_4,$k_half               # 73e
        fnms    $t_e_4,$t_e_4,$t_y_4,$k_one             # 74e
        fma     $inverse_5,$t_e_2,$inverse_2,$t_y_2     # 75e
        fm      $inverse_6,$t_y_7,$k_half               # 76e
        fnms    $t_e_6,$t_e_5,$t_y_7,$k_one             # 77e
        fma     $inverse_7,$t_e_3,$inverse_3,$t_y_5     # 78e
        fma     $inverse_8,$t_e_4,$inverse_4,$t_y_4     # 80e
        selb    $inverse_9,$inverse_5,$k_one,$c_directional # 81e
        fm      $t_2,$squared,$inverse_5                # 82e
        fma     $inverse_5,$t_e_6,$inverse_6,$t_y_7     # 83e
        fm      $to_x_6,$to_x_2,$inverse_9              # 84e
        fm      $to_y_6,$to_y_2,$inverse_9              # 85e
        selb    $inverse_10,$inverse_7,$k_one,$c_directional # 86e
        selb    $inverse_11,$inverse_8,$k_one,$c_directional # 87e
        fm      $to_x_3,$to_x_3,$inverse_10             # 88e
        fm      $to_z_4,$to_z_4,$inverse_11             # 89e
        selb    $inverse_12,$inverse_5,$k_one,$c_directional # 90e
        stqd    $to_x_6,192($a_shadow_2)                # 90o
        fm      $to_x_4,$to_x_4,$inverse_11             # 91e
        stqd    $to_y_6,256($a_shadow_2)                # 91o
        fm      $to_x_5,$to_x_5,$inverse_12             # 92e
        lqd     $normal_x_4,208($a_surfaces)            # 92o
        fm      $to_y_5,$to_y_5,$inverse_12             # 93e
        lqd     $normal_y_3,256($a_surfaces)            # 93o
        fm      $to_y_7,$to_y_4,$inverse_11             # 94e
        stqd    $to_x_3,240($a_shadow_2)                # 94o
        fm      $to_y_3,$to_y_3,$inverse_10             # 95e
        lqd     $normal_x_5,240($a_surfaces)            # 95o
        fm      $to_z_2,$to_z_2,$inverse_9              # 96e
        lqd     $plane_y_3,448($a_surfaces)             # 96o
        fm      $facing_2,$normal_x_2,$to_x_6           # 97e
        stqd    $to_z_4,336($a_shadow_2)                # 97o
        fm      $facing_plane_2,$plane_x_4,$to_x_6      # 98e
        stqd    $to_x_4,208($a_shadow_2)                # 98o
        fm      $to_z_6,$to_z_3,$inverse_10             # 99e
        lqd     $normal_z_2,336($a_surfaces)            # 99o
        fm      $to_z_7,$to_z_5,$inverse_12             # 100e
        lqd     $plane_z_2,512($a_surfaces)             # 100o
        fm      $facing_3,$normal_x_4,$to_x_4           # 101e
        stqd    $to_x_5,224($a_shadow_2)                # 101o
        fm      $facing_plane_3,$plane_x_3,$to_x_5      # 102e
        stqd    $to_y_5,288($a_shadow_2)                # 102o
        fm      $facing_plane_4,$plane_x_5,$to_x_4      # 103e
        stqd    $to_y_7,272($a_shadow_2)                # 103o
        fm      $facing_4,$normal_x_3,$to_x_5           # 104e
        stqd    $to_y_3,304($a_shadow_2)                # 104o
        fma     $facing_2,$normal_y_3,$to_y_6,$facing_2 # 105e
        stqd    $to_z_2,320($a_shadow_2)                # 105o
        fma     $facing_plane_2,$plane_y_3,$to_y_6,$facing_plane_2 # 106e
        lqd     $plane_y_4,464($a_surfaces)             # 106o
        fm      $facing_plane_5,$plane_x_2,$to_x_3      # 107e
        lqd     $normal_y_4,288($a_surfaces)            # 107o
        fm      $facing_5,$normal_x_5,$to_x_3           # 108e
        lqd     $plane_y_5,496($a_surfaces)             # 108o
        fma     $facing_6,$normal_y_2,$to_y_7,$facing_3 # 109e
        lqd     $normal_z_3,320($a_surfaces)            # 109o
        fma     $facing_plane_6,$plane_y_2,$to_y_5,$facing_plane_3 # 110e
        lqd     $normal_y_5,304($a_surfaces)            # 110o
        fma     $point_y_2,$leave_4,$plane_y_3,$point_y_2 # 111e
        stqd    $to_z_6,368($a_shadow_2)                # 111o
        fma     $facing_plane_4,$plane_y_4,$to_y_7,$facing_plane_4 # 112e
        lqd     $plane_z_3,528($a_surfaces)             # 112o
        fma     $facing_4,$normal_y_4,$to_y_5,$facing_4 # 113e
        lqd     $plane_z_4,560($a_surfaces)             # 113o
        fma     $facing_plane_2,$plane_z_2,$to_z_2,$facing_plane_2 # 114e
        lqd     $share_4,912($a_surfaces)               # 114o
        fma     $facing_plane_5,$plane_y_5,$to_y_3,$facing_plane_5 # 115e
        lqd     $diffuse_3,848($a_surfaces)             # 115o
        fma     $facing_2,$normal_z_3,$to_z_2,$facing_2 # 116e
        lqd     $normal_z_4,352($a_surfaces)            # 116o
        fma     $point_y_3,$leave_2,$plane_y_5,$point_y_3 # 117e
        stqd    $to_z_7,352($a_shadow_2)                # 117o
        fma     $facing_7,$normal_y_5,$to_y_3,$facing_5 # 118e
        lqd     $plane_z_5,544($a_surfaces)             # 118o
        fma     $facing_8,$normal_z_2,$to_z_4,$facing_6 # 119e
        lqd     $normal_z_5,368($a_surfaces)            # 119o
        fma     $facing_plane_4,$plane_z_3,$to_z_4,$facing_plane_4 # 120e
        lqd     $diffuse_4,864($a_surfaces)             # 120o
        cgti    $facing_plane_2,$facing_plane_2,0       # 121e
        lqd     $share_5,928($a_surfaces)               # 121o
        fma     $facing_4,$normal_z_4,$to_z_7,$facing_4 # 122e
        stqd    $point_y_2,64($a_shadow_2)              # 122o
        fma     $facing_plane_7,$plane_z_4,$to_z_6,$facing_plane_5 # 123e
        stqd    $point_y_3,112($a_shadow_2)             # 123o
        fma     $facing_plane_8,$plane_z_5,$to_z_7,$facing_plane_6 # 124e
        lqd     $diffuse,880($a_surfaces)               # 124o
        cgti    $facing_9,$facing_2,0                   # 125e
        lqd     $share_6,944($a_surfaces)               # 125o
        fm      $t_3,$squared_4,$inverse_5              # 126e
        lqd     $leave_5,592($a_surfaces)               # 126o
        fm      $t_4,$squared_2,$inverse_7              # 127e
        and     $facing_10,$facing_9,$facing_plane_2    # 128e
        fma     $point_z,$leave_3,$plane_z_5,$point_z_5 # 129e
        fma     $facing_11,$normal_z_5,$to_z_6,$facing_7 # 130e
        fma     $point_z_6,$leave_2,$plane_z_4,$point_z_3 # 131e
        cgti    $facing_7,$facing_8,0                   # 132e
        cgti    $facing_plane_9,$facing_plane_4,0       # 133e
        and     $facing_12,$facing_10,$share_3          # 134e
        or      $share_7,$share_4,$diffuse_3            # 135e
        cgti    $facing,$facing_4,0                     # 136e
        cgti    $facing_plane_8,$facing_plane_8,0       # 137e
        cgti    $facing_plane,$facing_plane_7,0         # 138e
        or      $share_8,$share_5,$diffuse_4            # 139e
        sf      $rays_2,$facing_12,$rays                # 140e true is -1
        cgti    $share_9,$share_7,0                     # 141e
        selb    $t_5,$t_3,$k_farthest,$c_directional    # 142e
        and     $facing_10,$facing_7,$facing_plane_9    # 143e
        and     $facing_13,$facing,$facing_plane_8      # 144e
        selb    $t_6,$t_4,$k_farthest,$c_directional    # 145e
        lnop                                            # 145o pairing
next_site:
            and     $facing,$facing_10,$share_9         # 0e
            lnop                                        # 0o pairing
            fm      $t,$squared_3,$inverse_8            # 1e
            stqd    $point_z,160($a_shadow_2)           # 1o
            or      $share,$share_6,$diffuse            # 2e
        lqd     $a_surfaces,0($a_site)                  # 2o
            cgti    $facing_14,$facing_11,0             # 3e
            stqd    $point_z_6,176($a_shadow_2)         # 3o
            cgti    $share,$share,0                     # 4e
            fma     $point_x,$leave_5,$plane_x_5,$point_x_4 # 5e
            and     $facing_14,$facing_14,$facing_plane # 6e
            sf      $rays_3,$facing,$rays_2             # 7e true is -1
            selb    $t,$t,$k_farthest,$c_directional    # 8e
        lqd     $point_x_2,0($a_surfaces)               # 8o
            fma     $point_z,$leave_5,$plane_z_3,$point_z_4 # 9e
        lqd     $point_x_3,48($a_surfaces)              # 9o
            and     $facing_14,$facing_14,$share        # 10e
        lqd     $point_x_4,16($a_surfaces)              # 10o
            fma     $point_y,$leave_5,$plane_y_4,$point_y_4 # 11e
        lqd     $point_x_5,32($a_surfaces)              # 11o
            fma     $point_z_6,$leave_4,$plane_z_2,$point_z_2 # 12e
        lqd     $point_y_5,96($a_surfaces)              # 12o
            cgti    $share,$share_8,0                   # 13e
        lqd     $point_z_2,128($a_surfaces)             # 13o
        fnms    $to_x_2,$point_x_2,$k_near,$light_x     # 14e
        lqd     $point_y_3,112($a_surfaces)             # 14o
            and     $facing_15,$facing_13,$share        # 15e
            stqd    $point_z,144($a_shadow_2)           # 15o
        fnms    $to_x_3,$point_x_3,$k_near,$light_x     # 16e
        lqd     $point_y_2,64($a_surfaces)              # 16o
        fnms    $to_x_4,$point_x_4,$k_near,$light_x     # 17e
            stqd    $point_y,80($a_shadow_2)            # 17o
        fnms    $to_x_5,$point_x_5,$k_near,$light_x     # 18e
        lnop                                            # 18o pairing
        fnms    $to_z_2,$point_z_2,$k_near,$light_z     # 19e
        lqd     $point_z_3,176($a_surfaces)             # 19o
        fm      $squared,$to_x_2,$to_x_2                # 20e
        lnop                                            # 20o pairing
        fnms    $to_y_5,$point_y_5,$k_near,$light_y     # 21e
        lqd     $point_z_5,160($a_surfaces)             # 21o
        fnms    $to_y_2,$point_y_2,$k_near,$light_y     # 22e
        fnms    $to_y_3,$point_y_3,$k_near,$light_y     # 23e
        fm      $squared_4,$to_x_5,$to_x_5              # 24e
        lqd     $point_y_4,80($a_surfaces)              # 24o
        fnms    $to_z_3,$point_z_3,$k_near,$light_z     # 25e
        lqd     $point_z_4,144($a_surfaces)             # 25o
        fm      $squared_3,$to_x_4,$to_x_4              # 26e
        fnms    $to_z_5,$point_z_5,$k_near,$light_z     # 27e
        fm      $squared_2,$to_x_3,$to_x_3              # 28e
        fma     $squared,$to_y_2,$to_y_2,$squared       # 29e
        fnms    $to_y_4,$point_y_4,$k_near,$light_y     # 30e
        fnms    $to_z_4,$point_z_4,$k_near,$light_z     # 31e
            selb    $t_5,$k_minus_one,$t_5,$facing_15   # 32e
        fma     $squared_4,$to_y_5,$to_y_5,$squared_4   # 33e
        fma     $squared_2,$to_y_3,$to_y_3,$squared_2   # 34e
            stqd    $t_5,416($a_shadow_2)               # 34o
        fma     $squared,$to_z_2,$to_z_2,$squared       # 35e
        fma     $squared_3,$to_y_4,$to_y_4,$squared_3   # 36e
            selb    $t_5,$k_minus_one,$t_6,$facing_14   # 37e
        lqd     $diffuse_2,832($a_surfaces)             # 37o
        ai      $count,$count,-1                        # 38e
        lqd     $share_4,896($a_surfaces)               # 38o
        fma     $squared_4,$to_z_5,$to_z_5,$squared_4   # 39e
        fma     $squared_2,$to_z_3,$to_z_3,$squared_2   # 40e
            sf      $rays_3,$facing_15,$rays_3          # 41e true is -1
        frsqest $t_y_2,$squared                         # 41o
        fma     $squared_3,$to_z_4,$to_z_4,$squared_3   # 42e
            selb    $t,$k_minus_one,$t,$facing          # 43e
        or      $share_3,$share_4,$diffuse_2            # 44e
        lnop                                            # 44o pairing
        fi      $t_y_2,$squared,$t_y_2                  # 45e
        frsqest $t_y_6,$squared_4                       # 45o
        cgti    $share_3,$share_3,0                     # 46e
        frsqest $t_y_8,$squared_2                       # 46o
            selb    $t_7,$t_2,$k_farthest,$c_directional # 47e
            stqd    $t,400($a_shadow_2)                 # 47o
            sf      $rays,$facing_14,$rays_3            # 48e true is -1
        frsqest $t_y_4,$squared_3                       # 48o
        fi      $t_y_3,$squared_4,$t_y_6                # 49e
        fi      $t_y_5,$squared_2,$t_y_8                # 50e
            selb    $t_8,$k_minus_one,$t_7,$facing_12   # 51e
        lqd     $plane_x_2,432($a_surfaces)             # 51o
        fm      $t_e_7,$squared,$t_y_2                  # 52e
        lqd     $leave_2,624($a_surfaces)               # 52o
        fi      $t_y_4,$squared_3,$t_y_4                # 53e
            stqd    $t_8,384($a_shadow_2)               # 53o
        ai      $a_site,$a_site,16                      # 54e
        fm      $inverse_2,$t_y_2,$k_half               # 55e
        fm      $t_e_5,$squared_4,$t_y_3                # 56e
        lqd     $plane_x_3,416($a_surfaces)             # 56o
        fm      $t_e_8,$squared_2,$t_y_5                # 57e
        lqd     $leave_3,608($a_surfaces)               # 57o
        fm      $inverse_6,$t_y_3,$k_half               # 58e
        lqd     $plane_x_4,384($a_surfaces)             # 58o
        fma     $point_x_3,$leave_2,$plane_x_2,$point_x_3 # 59e
            stqd    $point_x,16($a_shadow_2)            # 59o
        fnms    $t_e_9,$t_e_7,$t_y_2,$k_one             # 60e
            stqd    $t_5,432($a_shadow_2)               # 60o
        fm      $t_e_4,$squared_3,$t_y_4                # 61e
            stqd    $point_z_6,128($a_shadow_2)         # 61o
        fnms    $t_e_10,$t_e_5,$t_y_3,$k_one            # 62e
        rotqbyi $a_shadow_2,$a_surfaces,8               # 62o
        fma     $point_x_5,$leave_3,$plane_x_3,$point_x_5 # 63e
        lqd     $leave_4,576($a_surfaces)               # 63o
        fnms    $t_e_5,$t_e_8,$t_y_5,$k_one             # 64e
        lqd     $plane_y_2,480($a_surfaces)             # 64o
        fm      $inverse_3,$t_y_5,$k_half               # 65e
        lnop                                            # 65o pairing
        fm      $inverse_4,$t_y_4,$k_half               # 66e
        stqd    $background,480($a_shadow_2)            # 66o
        fma     $inverse_13,$t_e_9,$inverse_2,$t_y_2    # 67e
        stqd    $point_x_3,48($a_shadow_2)              # 67o
        fnms    $t_e_3,$t_e_4,$t_y_4,$k_one             # 68e
        stqd    $background,448($a_shadow_2)            # 68o
        fma     $point_x_2,$leave_4,$plane_x_4,$point_x_2 # 69e
        stqd    $background,464($a_shadow_2)            # 69o
        fma     $point_y_5,$leave_3,$plane_y_2,$point_y_5 # 70e
        stqd    $background,496($a_shadow_2)            # 70o
        fma     $inverse_10,$t_e_5,$inverse_3,$t_y_5    # 71e
        stqd    $point_x_5,32($a_shadow_2)              # 71o
        fma     $inverse_5,$t_e_10,$inverse_6,$t_y_3    # 72e
        selb    $inverse_14,$inverse_13,$k_one,$c_directional # 73e
        fma     $inverse_8,$t_e_3,$inverse_4,$t_y_4     # 74e
        lnop                                            # 74o pairing
        fm      $t_2,$squared,$inverse_13               # 75e
        stqd    $point_x_2,0($a_shadow_2)               # 75o
        fm      $to_x_6,$to_x_2,$inverse_14             # 76e
        stqd    $point_y_5,96($a_shadow_2)              # 76o
        fm      $to_y,$to_y_2,$inverse_14               # 77e
        lnop                                            # 77o pairing
        selb    $inverse_7,$inverse_10,$k_one,$c_directional # 78e
        lqd     $plane_x_5,400($a_surfaces)             # 78o
        selb    $inverse_15,$inverse_5,$k_one,$c_directional # 79e
        lqd     $normal_x_6,192($a_surfaces)            # 79o
        fm      $to_x_3,$to_x_3,$inverse_7              # 80e
        lqd     $normal_y_6,272($a_surfaces)            # 80o
        selb    $inverse_9,$inverse_8,$k_one,$c_directional # 81e
        lqd     $normal_x_7,224($a_surfaces)            # 81o
        fm      $to_y_5,$to_y_5,$inverse_15             # 82e
        stqd    $to_x_6,192($a_shadow_2)                # 82o
        fm      $to_z_4,$to_z_4,$inverse_9              # 83e
        stqd    $to_y,256($a_shadow_2)                  # 83o
        fm      $to_x_4,$to_x_4,$inverse_9              # 84e
        lqd     $normal_x_4,208($a_surfaces)            # 84o
        fm      $facing_7,$normal_x_6,$to_x_6           # 85e
        lqd     $normal_y_7,256($a_surfaces)            # 85o
        fm      $facing_plane_2,$plane_x_4,$to_x_6      # 86e
        stqd    $to_x_3,240($a_shadow_2)                # 86o
        fm      $to_x_5,$to_x_5,$inverse_15             # 87e
        lqd     $normal_x_8,240($a_surfaces)            # 87o
        fm      $to_y_8,$to_y_4,$inverse_9              # 88e
        lqd     $plane_y_6,448($a_surfaces)             # 88o
        fm      $to_y_3,$to_y_3,$inverse_7              # 89e
        stqd    $to_z_4,336($a_shadow_2)                # 89o
        fm      $facing_3,$normal_x_4,$to_x_4           # 90e
        stqd    $to_x_4,208($a_shadow_2)                # 90o
        fm      $to_z_8,$to_z_2,$inverse_14             # 91e
        lqd     $normal_z_4,336($a_surfaces)            # 91o
        fma     $facing_7,$normal_y_7,$to_y,$facing_7   # 92e
        lqd     $plane_z_2,512($a_surfaces)             # 92o
        fm      $facing_plane_3,$plane_x_3,$to_x_5      # 93e
        stqd    $to_x_5,224($a_shadow_2)                # 93o
        fma     $facing_plane_2,$plane_y_6,$to_y,$facing_plane_2 # 94e
        stqd    $to_y_5,288($a_shadow_2)                # 94o
        fm      $facing_6,$normal_x_8,$to_x_3           # 95e
        stqd    $to_y_8,272($a_shadow_2)                # 95o
        fma     $facing_16,$normal_y_6,$to_y_8,$facing_3 # 96e
        stqd    $to_y_3,304($a_shadow_2)                # 96o
        fm      $to_z_9,$to_z_3,$inverse_7              # 97e
        stqd    $to_z_8,320($a_shadow_2)                # 97o
        fm      $facing_plane_4,$plane_x_5,$to_x_4      # 98e
        lqd     $plane_y_4,464($a_surfaces)             # 98o
        fm      $facing_plane_10,$plane_x_2,$to_x_3     # 99e
        lqd     $plane_y_7,496($a_surfaces)             # 99o
        fm      $facing_4,$normal_x_7,$to_x_5           # 100e
        lqd     $normal_z_6,320($a_surfaces)            # 100o
        fma     $facing_plane_2,$plane_z_2,$to_z_8,$facing_plane_2 # 101e
        lqd     $normal_y_4,288($a_surfaces)            # 101o
        fm      $to_z,$to_z_5,$inverse_15               # 102e
        lqd     $normal_y_8,304($a_surfaces)            # 102o
        fma     $facing_9,$normal_z_4,$to_z_4,$facing_16 # 103e
        stqd    $to_z_9,368($a_shadow_2)                # 103o
        fma     $facing_plane_4,$plane_y_4,$to_y_8,$facing_plane_4 # 104e
        lqd     $plane_z_3,528($a_surfaces)             # 104o
        fma     $facing_plane_10,$plane_y_7,$to_y_3,$facing_plane_10 # 105e
        lqd     $plane_z_4,560($a_surfaces)             # 105o
        fma     $facing_2,$normal_z_6,$to_z_8,$facing_7 # 106e
        cgti    $facing_plane,$facing_plane_2,0         # 107e
        fma     $facing_11,$normal_y_8,$to_y_3,$facing_6 # 108e
        fma     $facing_4,$normal_y_4,$to_y_5,$facing_4 # 109e
        fma     $facing_plane_11,$plane_z_3,$to_z_4,$facing_plane_4 # 110e
        fma     $facing_plane_10,$plane_z_4,$to_z_9,$facing_plane_10 # 111e
        cgti    $facing_2,$facing_2,0                   # 112e
        lnop                                            # 112o pairing
        cgti    $facing_7,$facing_9,0                   # 113e
        lqd     $share_7,912($a_surfaces)               # 113o
        fma     $facing_plane_12,$plane_y_2,$to_y_5,$facing_plane_3 # 114e
        lqd     $diffuse,848($a_surfaces)               # 114o
        fm      $t_3,$squared_4,$inverse_5              # 115e
        lqd     $normal_z_7,352($a_surfaces)            # 115o
        cgti    $facing_plane_11,$facing_plane_11,0     # 116e
        stqd    $to_z,352($a_shadow_2)                  # 116o
        and     $facing_2,$facing_2,$facing_plane       # 117e
        lnop                                            # 117o pairing
        cgti    $facing_plane,$facing_plane_10,0        # 118e
        lqd     $plane_z_5,544($a_surfaces)             # 118o
        and     $facing_12,$facing_2,$share_3           # 119e
        lqd     $diffuse_5,864($a_surfaces)             # 119o
        or      $share_7,$share_7,$diffuse              # 120e
        lqd     $share_10,928($a_surfaces)              # 120o
        fma     $facing,$normal_z_7,$to_z,$facing_4     # 121e
        hbrr    next_site_back,next_site                # 121o hint
        fma     $point_y,$leave_4,$plane_y_6,$point_y_2 # 122e
        fma     $point_y_3,$leave_2,$plane_y_7,$point_y_3 # 123e
        fma     $facing_plane_5,$plane_z_5,$to_z,$facing_plane_12 # 124e
        fm      $t_9,$squared_2,$inverse_10             # 125e
        or      $share_8,$share_10,$diffuse_5           # 126e
        lnop                                            # 126o pairing
        cgti    $facing,$facing,0                       # 127e
        lqd     $normal_z_8,368($a_surfaces)            # 127o
        sf      $rays_2,$facing_12,$rays                # 128e true is -1
        stqd    $point_y,64($a_shadow_2)                # 128o
        cgti    $share_9,$share_7,0                     # 129e
        stqd    $point_y_3,112($a_shadow_2)             # 129o
        selb    $t_5,$t_3,$k_farthest,$c_directional    # 130e
        fma     $point_z,$leave_3,$plane_z_5,$point_z_5 # 131e
        cgti    $facing_plane_13,$facing_plane_5,0      # 132e
        lnop                                            # 132o pairing
        fma     $facing_11,$normal_z_8,$to_z_9,$facing_11 # 133e
        lqd     $diffuse,880($a_surfaces)               # 133o
        and     $facing_10,$facing_7,$facing_plane_11   # 134e
        lqd     $share_6,944($a_surfaces)               # 134o
        fma     $point_z_6,$leave_2,$plane_z_4,$point_z_3 # 135e
        lnop                                            # 135o pairing
        and     $facing_13,$facing,$facing_plane_13     # 136e
        lqd     $leave_5,592($a_surfaces)               # 136o
        selb    $t_6,$t_9,$k_farthest,$c_directional    # 137e
next_site_back:
        brnz    $count,next_site                        # 137o
next_site_drain:
        fm      $t,$squared_3,$inverse_8                # 0e
        hbr     shadow_rays_r16_return,$lr              # 0o hint
        fma     $point_z_7,$leave_5,$plane_z_3,$point_z_4 # 1e
        stqd    $point_z,160($a_shadow_2)               # 1o
        fma     $point_y_6,$leave_5,$plane_y_4,$point_y_4 # 2e
        stqd    $point_z_6,176($a_shadow_2)             # 2o
        cgti    $share,$share_8,0                       # 3e
        or      $share_11,$share_6,$diffuse             # 4e
        cgti    $facing_17,$facing_11,0                 # 5e
        and     $facing_15,$facing_13,$share            # 6e
        and     $facing,$facing_10,$share_9             # 7e
        stqd    $point_z_7,144($a_shadow_2)             # 7o
        fma     $point_x,$leave_5,$plane_x_5,$point_x_4 # 8e
        stqd    $point_y_6,80($a_shadow_2)              # 8o
        selb    $t,$t,$k_farthest,$c_directional        # 9e
        cgti    $share,$share_11,0                      # 10e
        and     $facing_14,$facing_17,$facing_plane     # 11e
        selb    $t_5,$k_minus_one,$t_5,$facing_15       # 12e
        selb    $t_10,$t_2,$k_farthest,$c_directional   # 13e
        lnop                                            # 13o pairing
        fma     $point_z_6,$leave_4,$plane_z_2,$point_z_2 # 14e
        stqd    $t_5,416($a_shadow_2)                   # 14o
        selb    $t,$k_minus_one,$t,$facing              # 15e
        and     $facing_14,$facing_14,$share            # 16e
        selb    $t_8,$k_minus_one,$t_10,$facing_12      # 17e
        stqd    $t,400($a_shadow_2)                     # 17o
        sf      $rays_3,$facing,$rays_2                 # 18e true is -1
        lnop                                            # 18o pairing
        selb    $t_5,$k_minus_one,$t_6,$facing_14       # 19e
        stqd    $t_8,384($a_shadow_2)                   # 19o
        sf      $rays_3,$facing_15,$rays_3              # 20e true is -1
        stqd    $point_x,16($a_shadow_2)                # 20o
        nop     $127                                    # 21e pairing
        stqd    $t_5,432($a_shadow_2)                   # 21o
        sf      $rays,$facing_14,$rays_3                # 22e true is -1
        stqd    $point_z_6,128($a_shadow_2)             # 22o
        ori     $a_site,$rays,0                         # 24e
shadow_rays_r16_return:
        bi      $lr                                     # 24o
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
        lqd     $point_x_6,16($a_surfaces)              # 20o
        lqd     $normal_x_9,208($a_surfaces)            # 21o
        lqd     $plane_x_6,400($a_surfaces)             # 22o
        or      $share,$share,$diffuse                  # 23e
        lqd     $point_y_7,80($a_surfaces)              # 23o
        nop     $127                                    # 24e pairing
        lqd     $normal_y_9,272($a_surfaces)            # 24o
        cgti    $share,$share,0                         # 25e
        lqd     $plane_y_8,464($a_surfaces)             # 25o
        fma     $squared,$to_y,$to_y,$squared           # 26e
        lqd     $point_z_8,144($a_surfaces)             # 26o
        fma     $point_x,$leave,$plane_x,$point_x       # 27e
        lqd     $normal_z_9,336($a_surfaces)            # 27o
        fma     $point_y,$leave,$plane_y,$point_y       # 28e
        lqd     $plane_z_6,528($a_surfaces)             # 28o
        fma     $point_z,$leave,$plane_z,$point_z       # 29e
        lqd     $share_12,912($a_surfaces)              # 29o
        fnms    $to_x_7,$point_x_6,$k_near,$light_x     # 30e
        lqd     $diffuse_6,848($a_surfaces)             # 30o
        fnms    $to_y_9,$point_y_7,$k_near,$light_y     # 31e
        stqd    $background,464($a_shadow)              # 31o
        fma     $squared,$to_z,$to_z,$squared           # 32e
        lqd     $leave_6,592($a_surfaces)               # 32o
        fnms    $to_z_10,$point_z_8,$k_near,$light_z    # 33e
        stqd    $point_x,0($a_shadow)                   # 33o
        stqd    $point_y,64($a_shadow)                  # 34o
        stqd    $point_z,128($a_shadow)                 # 35o
        fm      $squared_5,$to_x_7,$to_x_7              # 36e
        lqd     $point_x_7,32($a_surfaces)              # 36o
        or      $share_13,$share_12,$diffuse_6          # 37e
        lqd     $normal_x_10,224($a_surfaces)           # 37o
        fma     $point_x_6,$leave_6,$plane_x_6,$point_x_6 # 38e
        frsqest $t_y_9,$squared                         # 38o
        cgti    $share_13,$share_13,0                   # 39e
        lqd     $plane_x_7,416($a_surfaces)             # 39o
        fma     $point_y_7,$leave_6,$plane_y_8,$point_y_7 # 40e
        lqd     $point_y_8,96($a_surfaces)              # 40o
        fma     $point_z_8,$leave_6,$plane_z_6,$point_z_8 # 41e
        lqd     $normal_y_10,288($a_surfaces)           # 41o
        fi      $t_y_9,$squared,$t_y_9                  # 42e
        lqd     $plane_y_9,480($a_surfaces)             # 42o
        nop     $127                                    # 43e pairing
        lqd     $point_z_9,160($a_surfaces)             # 43o
        fma     $squared_5,$to_y_9,$to_y_9,$squared_5   # 44e
        stqd    $point_x_6,16($a_shadow)                # 44o
        fnms    $to_x_8,$point_x_7,$k_near,$light_x     # 45e
        lqd     $normal_z_10,352($a_surfaces)           # 45o
        fnms    $to_y_10,$point_y_8,$k_near,$light_y    # 46e
        stqd    $point_y_7,80($a_shadow)                # 46o
        stqd    $point_z_8,144($a_shadow)               # 47o
        lqd     $plane_z_7,544($a_surfaces)             # 48o
        fm      $t_e_11,$squared,$t_y_9                 # 49e
        lqd     $share_14,928($a_surfaces)              # 49o
        fm      $inverse_16,$t_y_9,$k_half              # 50e
        lqd     $diffuse_7,864($a_surfaces)             # 50o
        fma     $squared_5,$to_z_10,$to_z_10,$squared_5 # 51e
        stqd    $background,480($a_shadow)              # 51o
        fnms    $to_z_11,$point_z_9,$k_near,$light_z    # 52e
        lqd     $leave_7,608($a_surfaces)               # 52o
        fm      $squared_6,$to_x_8,$to_x_8              # 53e
        lqd     $point_x_8,48($a_surfaces)              # 53o
        nop     $127                                    # 54e pairing
        lqd     $normal_x_11,240($a_surfaces)           # 54o
        fnms    $t_e_11,$t_e_11,$t_y_9,$k_one           # 55e
        lqd     $plane_x_8,432($a_surfaces)             # 55o
        or      $share_14,$share_14,$diffuse_7          # 56e
        lqd     $point_y_9,112($a_surfaces)             # 56o
        nop     $127                                    # 57e pairing
        frsqest $t_y_10,$squared_5                      # 57o
        cgti    $share_14,$share_14,0                   # 58e
        lqd     $normal_y_11,304($a_surfaces)           # 58o
        fma     $squared_6,$to_y_10,$to_y_10,$squared_6 # 59e
        lqd     $plane_y_10,496($a_surfaces)            # 59o
        fma     $point_x_7,$leave_7,$plane_x_7,$point_x_7 # 60e
        lqd     $point_z_10,176($a_surfaces)            # 60o
        fma     $inverse_9,$t_e_11,$inverse_16,$t_y_9   # 61e
        lqd     $normal_z_11,368($a_surfaces)           # 61o
        fi      $t_y_8,$squared_5,$t_y_10               # 62e
        lqd     $plane_z_8,560($a_surfaces)             # 62o
        nop     $127                                    # 63e pairing
        lqd     $share_15,944($a_surfaces)              # 63o
        fma     $point_y_8,$leave_7,$plane_y_9,$point_y_8 # 64e
        lqd     $diffuse_8,880($a_surfaces)             # 64o
        fma     $squared_6,$to_z_11,$to_z_11,$squared_6 # 65e
        stqd    $background,496($a_shadow)              # 65o
        fma     $point_z_9,$leave_7,$plane_z_7,$point_z_9 # 66e
        stqd    $point_x_7,32($a_shadow)                # 66o
        fm      $t_11,$squared,$inverse_9               # 67e
        lqd     $leave_8,624($a_surfaces)               # 67o
        selb    $inverse_11,$inverse_9,$k_one,$c_directional # 68e
        fm      $t_e_11,$squared_5,$t_y_8               # 69e
        fm      $to_x,$to_x,$inverse_11                 # 70e
        stqd    $point_y_8,96($a_shadow)                # 70o
        fm      $to_y,$to_y,$inverse_11                 # 71e
        frsqest $t_y_11,$squared_6                      # 71o
        fm      $to_z,$to_z,$inverse_11                 # 72e
        stqd    $point_z_9,160($a_shadow)               # 72o
        selb    $t_11,$t_11,$k_farthest,$c_directional  # 73e
        fm      $inverse_11,$t_y_8,$k_half              # 74e
        fnms    $t_e_11,$t_e_11,$t_y_8,$k_one           # 75e
        lnop                                            # 75o pairing
        fm      $facing_18,$normal_x,$to_x              # 76e
        stqd    $to_x,192($a_shadow)                    # 76o
        fm      $facing_plane_14,$plane_x,$to_x         # 77e
        stqd    $to_y,256($a_shadow)                    # 77o
        fi      $t_y_2,$squared_6,$t_y_11               # 78e
        stqd    $to_z,320($a_shadow)                    # 78o
        or      $share_16,$share_15,$diffuse_8          # 79e
        fnms    $to_x_9,$point_x_8,$k_near,$light_x     # 80e
        fma     $inverse_11,$t_e_11,$inverse_11,$t_y_8  # 81e
        fma     $facing_18,$normal_y,$to_y,$facing_18   # 82e
        fma     $facing_plane_14,$plane_y,$to_y,$facing_plane_14 # 83e
        fnms    $to_y,$point_y_9,$k_near,$light_y       # 84e
        fm      $t_e_12,$squared_6,$t_y_2               # 85e
        fm      $inverse_17,$t_y_2,$k_half              # 86e
        fm      $t,$squared_5,$inverse_11               # 87e
        fma     $facing_19,$normal_z,$to_z,$facing_18   # 88e
        fma     $facing_plane_14,$plane_z,$to_z,$facing_plane_14 # 89e
        selb    $inverse_15,$inverse_11,$k_one,$c_directional # 90e
        fnms    $t_e_13,$t_e_12,$t_y_2,$k_one           # 91e
        fm      $to_x_2,$to_x_7,$inverse_15             # 92e
        selb    $t,$t,$k_farthest,$c_directional        # 93e
        cgti    $facing_19,$facing_19,0                 # 94e
        cgti    $facing_plane_14,$facing_plane_14,0     # 95e
        fm      $to_y_11,$to_y_9,$inverse_15            # 96e
        and     $facing_19,$facing_19,$facing_plane_14  # 97e
        lnop                                            # 97o pairing
        fm      $to_z,$to_z_10,$inverse_15              # 98e
        stqd    $to_x_2,208($a_shadow)                  # 98o
        and     $facing_19,$facing_19,$share            # 99e
        fm      $facing_17,$normal_x_9,$to_x_2          # 100e
        sf      $rays,$facing_19,$rays                  # 101e true is -1
        lnop                                            # 101o pairing
        selb    $t_12,$k_minus_one,$t_11,$facing_19     # 102e
        stqd    $to_y_11,272($a_shadow)                 # 102o
        fm      $facing_plane_2,$plane_x_6,$to_x_2      # 103e
        lnop                                            # 103o pairing
        fma     $inverse_18,$t_e_13,$inverse_17,$t_y_2  # 104e
        stqd    $t_12,384($a_shadow)                    # 104o
        fnms    $to_z_12,$point_z_10,$k_near,$light_z   # 105e
        stqd    $to_z,336($a_shadow)                    # 105o
        fma     $facing_17,$normal_y_9,$to_y_11,$facing_17 # 106e
        fm      $squared,$to_x_9,$to_x_9                # 107e
        cgti    $share,$share_16,0                      # 108e
        fma     $facing_plane_2,$plane_y_8,$to_y_11,$facing_plane_2 # 109e
        fm      $t_13,$squared_6,$inverse_18            # 110e
        selb    $inverse,$inverse_18,$k_one,$c_directional # 111e
        fma     $facing,$normal_z_9,$to_z,$facing_17    # 112e
        fm      $to_x_8,$to_x_8,$inverse                # 113e
        fm      $to_y_12,$to_y_10,$inverse              # 114e
        fma     $facing_plane,$plane_z_6,$to_z,$facing_plane_2 # 115e
        selb    $t_14,$t_13,$k_farthest,$c_directional  # 116e
        fm      $to_z,$to_z_11,$inverse                 # 117e
        cgti    $facing,$facing,0                       # 118e
        lnop                                            # 118o pairing
        fm      $facing_4,$normal_x_10,$to_x_8          # 119e
        stqd    $to_x_8,224($a_shadow)                  # 119o
        fm      $facing_plane_15,$plane_x_7,$to_x_8     # 120e
        stqd    $to_y_12,288($a_shadow)                 # 120o
        cgti    $facing_plane,$facing_plane,0           # 121e
        fma     $squared,$to_y,$to_y,$squared           # 122e
        and     $facing,$facing,$facing_plane           # 123e
        stqd    $to_z,352($a_shadow)                    # 123o
        fma     $point_x_5,$leave_8,$plane_x_8,$point_x_8 # 124e
        and     $facing,$facing,$share_13               # 125e
        fma     $facing_4,$normal_y_10,$to_y_12,$facing_4 # 126e
        sf      $rays,$facing,$rays                     # 127e true is -1
        selb    $t,$k_minus_one,$t,$facing              # 128e
        fma     $facing_plane,$plane_y_9,$to_y_12,$facing_plane_15 # 129e
        fma     $squared,$to_z_12,$to_z_12,$squared     # 130e
        stqd    $t,400($a_shadow)                       # 130o
        fma     $point_y_10,$leave_8,$plane_y_10,$point_y_9 # 131e
        stqd    $point_x_5,48($a_shadow)                # 131o
        fma     $facing,$normal_z_10,$to_z,$facing_4    # 132e
        fma     $point_z,$leave_8,$plane_z_8,$point_z_10 # 133e
        fma     $facing_plane,$plane_z_7,$to_z,$facing_plane # 135e
        hbrr    next_site_short_back,next_site_short    # 135o hint
        frsqest $t_y,$squared                           # 136o
        stqd    $point_y_10,112($a_shadow)              # 137o
        cgti    $facing,$facing,0                       # 138e
        stqd    $point_z,176($a_shadow)                 # 139o
        fi      $t_y,$squared,$t_y                      # 140e
        cgti    $facing_plane,$facing_plane,0           # 141e
        and     $facing,$facing,$facing_plane           # 143e
        and     $facing,$facing,$share_14               # 145e
        sf      $rays,$facing,$rays                     # 147e true is -1
        selb    $t,$k_minus_one,$t_14,$facing           # 148e
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
        fm      $to_z,$to_z_12,$inverse                 # 172e
        selb    $t,$t,$k_farthest,$c_directional        # 173e
        fm      $facing,$normal_x_11,$to_x              # 176e
        stqd    $to_x,240($a_shadow)                    # 176o
        fm      $facing_plane,$plane_x_8,$to_x          # 177e
        stqd    $to_y,304($a_shadow)                    # 177o
        stqd    $to_z,368($a_shadow)                    # 178o
        fma     $facing,$normal_y_11,$to_y,$facing      # 182e
        fma     $facing_plane,$plane_y_10,$to_y,$facing_plane # 183e
        fma     $facing,$normal_z_11,$to_z,$facing      # 188e
        fma     $facing_plane,$plane_z_8,$to_z,$facing_plane # 189e
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
