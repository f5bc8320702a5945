# shadow_rays_r16   rays from where sixteen rays have hit to a light, unless they show nothing
#   C       vec_uint4 shadow_rays_r16(const struct site *, int count, const struct light *,
#                                     const struct object *background, float least,
#                                     struct ray_packet *, struct site *listed);
#   In      $3 sites, $4 count (at least 1), $5 light, $6 the background's object, $7 the least
#           share of the light that counts, or 0 if every ray does; $8 where the rays go, $9 where
#           their sites go, with room for as many as there are sites; pointers 16-aligned
#   Out     a packet for each site in which some lane has a ray, in order: origin, direction, t,
#           object; and these sites, as they are; what is behind these may be anything. $3 the end
#           of the listed sites, number of rays, how many bytes of the listed sites shine
#   Uses    $2-$66, $79   Saves  -   Stack  0   Calls  -
#   Domain  distance to the light below 2^62; shares not below 0; LIGHT_directional all ones or 0,
#           the direction then of length 1
#   Error   2 ulp of 1, each component of the direction; t 4 ulp
#   Twin    lab/twins/src/shadow_rays.rs
#
#   to = position - point, L = to / |to|, t = |to|
#   for a directional light: to = position, t = FARTHEST
#   a ray exists if neither N.L nor plane.L is below 0, one of them is above 0, and
#   |weight (most diffuse (N.L) + highlight)| > least; otherwise t = -1
#   origin = point + leave plane
# most is the OR of the bits of red, green and blue: at least the greatest of them, and below 2 if
# they are. A highlight is at most its share. If every ray counts, weight and most are 1: a ray
# exists where any share is. A light exactly at the point has L = 0, and there is no ray.
#
# Each packet is stored behind the last one that has a ray in some lane, so a packet without any is
# overwritten. The site is stored in the same way. A pass makes two rows of four rays.
# Scheduled by spu schedule from shadow_rays_r16.s

        .include "work_unit.inc"
        .include "macros.inc"
        .include "math.inc"
        .include "vectors.inc"

        .section .rodata
        .align  4
two:    .int    0x00010203,0x10111213,0x80808080,0x80808080
as_is:  .int    0x00010203,0x04050607,0x08090a0b,0x0c0d0e0f
# The lanes' OR enters from the right, as two bytes: the first four are of the last two passes.
recent: .int    0x02031010,0x02031010,0x02031010,0x80808080
# What is returned: the end of the listed sites, rays, how many bytes of these sites shine.
ended:  .int    0x00010203,0x10111213,0x04050607,0x80808080
# How far these move behind the rows 0 and 2: only behind a packet's last ones. The second part is
# for sites with highlights.
steps:  .int    0,0,0,0,0,0,0,0,RAYS16_SIZE,SITE_SIZE,0,0
        .skip   SITE_SHINES-48
        .int    0,0,0,0,0,0,0,0,RAYS16_SIZE,SITE_SIZE,SITE_SIZE,0

        .set    NEXT,3
        registers a_sites,count,a_light,background
        registers least                                 # later in all lanes
        registers a_shadow,a_listed
        # constants
        registers k_half,k_one,k_minus_one
        registers k_near                                # 0 for a directional light, else 1
        registers k_beyond                              # FARTHEST for a directional light, else 0
        registers light_x,light_y,light_z
        registers a_steps
        registers m_seen                                # takes 1 instead if every ray counts
        # state
        registers at                                    # 16 for each site that is done
        registers ends                                  # of packets, sites; bytes that shine
        registers there_before                          # of recent rows, whether any lane has a ray
        registers rays
        # the pass
        registers site,row,here,a_rays,to_list,to_packet,step,any
        # a row
        registers point_x,point_y,point_z,to_x,to_y,to_z,normal_x,normal_y,normal_z,plane_x
        registers plane_y,plane_z,leave,diffuse,squared,inverse,t,facing,facing_plane,there
        registers most,other,weight,share,there_next
        # temporaries
        registers light,m_lane,t_y,t_e

# A word of the light, in every lane.
.macro  splat_word out:req, pattern:req
        load_constant $m_lane,\pattern
        splat   \out,$light,$m_lane
.endm

# The rays of a row, and the mask of the lanes that have one.
.macro  shadow_ray at:req, there:req
    .irp axis, x,y,z
        lqd     $point_\axis,SURFACES_point_\axis+\at($here)
        fnms    $to_\axis,$point_\axis,$k_near,$light_\axis
    .endr
        dot_f4  $squared,to,to
        rsqrt_f4 $inverse,$squared,$t_y,$t_e,$k_half,$k_one
        fma     $t,$squared,$inverse,$k_beyond
    .irp axis, x,y,z
        lqd     $normal_\axis,SURFACES_normal_\axis+\at($here)
        lqd     $plane_\axis,SURFACES_plane_\axis+\at($here)
        fm      $to_\axis,$to_\axis,$inverse
        stqd    $to_\axis,RAYS16_direction_\axis+\at($to_packet)
    .endr
        dot_f4  $facing,normal,to
        dot_f4  $facing_plane,plane,to
        lqd     $diffuse,SURFACES_diffuse+\at($here)
        fm      $diffuse,$diffuse,$facing
        lqd     $leave,SURFACES_leave+\at($here)
    .irp axis, x,y,z
        fma     $point_\axis,$leave,$plane_\axis,$point_\axis
        stqd    $point_\axis,RAYS16_origin_\axis+\at($to_packet)
    .endr
        stqd    $background,RAYS16_object+\at($to_packet)
        # The OR of the channels is at least the greatest of them.
        lqd     $most,SURFACES_red+\at($here)
        lqd     $other,SURFACES_green+\at($here)
        or      $most,$most,$other
        lqd     $other,SURFACES_blue+\at($here)
        or      $most,$most,$other
        lqd     $weight,RAYS16_weight+\at($a_rays)
        shufb   $most,$most,$k_one,$m_seen
        shufb   $weight,$weight,$k_one,$m_seen
        lqd     $share,SURFACES_highlight+\at($here)
        fma     $share,$most,$diffuse,$share
        fm      $share,$weight,$share
        or      $facing,$facing,$facing_plane
        fcmgt   $\there,$share,$least
        cgti    $facing,$facing,0
        and     $\there,$\there,$facing
        sf      $rays,$\there,$rays                    # true is -1
        selb    $t,$k_minus_one,$t,$\there
        stqd    $t,RAYS16_t+\at($to_packet)
.endm

function shadow_rays_r16
        .set m_lane_2,2; .set m_lane_3,5; .set m_lane_4,10; .set count_2,79; .set row_2,2
        .set to_list_2,25; .set to_packet_2,64; .set point_x_2,8; .set point_y_2,28
        .set point_z_2,27; .set to_x_2,29; .set a_rays_2,47; .set to_y_2,38; .set most_2,2
        .set to_z_2,30; .set other_2,54; .set to_z_3,31; .set other_3,39; .set other_4,5
        .set squared_2,9; .set weight_2,37; .set weight_3,47; .set leave_2,40; .set leave_3,43
        .set plane_x_2,50; .set plane_z_2,54; .set step_2,45; .set weight_4,57; .set weight_5,60
        .set squared_3,51; .set most_3,47; .set plane_z_3,44; .set plane_y_2,61; .set point_z_3,58
        .set normal_y_2,27; .set normal_y_3,62; .set t_y_2,56; .set normal_z_2,53
        .set normal_z_3,39; .set t_y_3,2; .set normal_x_2,9; .set t_y_4,37; .set diffuse_2,43
        .set diffuse_3,55; .set normal_x_3,5; .set share_2,56; .set share_3,59; .set step_3,66
        .set t_e_2,26; .set t_e_3,33; .set inverse_2,40; .set inverse_3,45; .set inverse_4,37
        .set to_x_3,63; .set to_y_3,65; .set to_z_4,29; .set facing_2,2; .set facing_plane_2,5
        .set t_2,9; .set squared_4,39; .set facing_3,5; .set diffuse_4,40; .set squared_5,2
        .set share_4,40; .set weight_6,39; .set there_next_2,55; .set there_2,39; .set there_3,27
        .set t_e_4,2; .set t_e_5,39; .set there_next_3,5; .set any_2,49; .set m_lane_5,53
        .set rays_2,55; .set any_3,2; .set step_4,2; .set to_z_5,3; .set point_x_3,2
        .set point_y_3,5; .set point_z_4,8; .set to_x_4,9; .set normal_x_4,24; .set to_y_4,25
        .set to_z_6,28; .set normal_z_4,30; .set squared_6,31; .set plane_x_3,42; .set most_4,43
        .set other_5,44; .set other_6,47; .set diffuse_5,48; .set a_rays_3,49; .set plane_y_3,44
        .set plane_y_4,50; .set share_5,47; .set weight_7,49; .set t_y_5,51; .set plane_z_4,53
        .set plane_z_5,56; .set leave_4,57; .set leave_5,60; .set step_5,26; .set t_e_6,61
        .set t_e_7,62; .set inverse_5,63; .set inverse_6,64; .set inverse_7,32; .set inverse_8,33
        .set to_x_5,2; .set to_y_5,5; .set to_z_7,8; .set facing_4,9; .set facing_5,24
        .set facing_plane_3,25; .set facing_plane_4,2; .set t_3,28; .set t_4,31
        .set facing_plane_5,9; .set diffuse_6,8; .set share_6,8; .set t_5,5
        ila     $m_lane,0x10203                         # 0e
        lqd     $light,0($a_light)                      # 0o
        ilhu    $m_lane_2,0xc0d                         # 1e
        lqa     $t_y,two                                # 1o
        shli    $count,$count,1                         # 2e passes
        shufb   $least,$least,$least,$m_lane            # 2o
        iohl    $m_lane_2,0xe0f                         # 3e
        lqa     $m_seen,as_is                           # 3o
        ilhu    $m_lane_3,1                             # 4e
        shufb   $background,$background,$background,$m_lane # 4o
        ilhu    $m_lane,0x405                           # 5e
        lnop                                            # 5o pairing
        ilhu    $m_lane_4,0x809                         # 6e
        shufb   $there,$light,$light,$m_lane_2          # 6o
        ceqi    $t_e,$least,0                           # 7e
        shufb   $ends,$a_shadow,$a_listed,$t_y          # 7o
        ilh     $m_lane_2,0x1010                        # 8e
        iohl    $m_lane_3,515                           # 9e
        iohl    $m_lane,0x607                           # 10e
        lnop                                            # 10o pairing
        iohl    $m_lane_4,0xa0b                         # 11e
        shufb   $light_x,$light,$light,$m_lane_3        # 11o
        ilhu    $k_one,0x3f80                           # 12e
        shufb   $light_y,$light,$light,$m_lane          # 12o
        ilhu    $k_beyond,0x5e80                        # 13e
        shufb   $light_z,$light,$light,$m_lane_4        # 13o
        and     $t_e,$t_e,$m_lane_2                     # 14e
        clgti   $count_2,$count,1                       # 15e at least as many passes as overlap
        ilhu    $k_half,0x3f00                          # 16e
        ilhu    $k_minus_one,0xbf80                     # 17e
        andc    $k_near,$k_one,$there                   # 18e
        and     $k_beyond,$k_beyond,$there              # 19e
        or      $m_seen,$m_seen,$t_e                    # 20e
        ila     $a_steps,steps                          # 21e
        il      $at,0                                   # 22e
        il      $there_before,0                         # 23e
        il      $rays,0                                 # 24e
        brz     $count_2,next_pass_short                # 24o too few passes
        ai      $count,$count,-1                        # 25e
        shlqbii $row_2,$at,2                            # 25o
        nop     $127                                    # 26e pairing
        lqx     $site,$a_sites,$at                      # 26o
        ai      $at,$at,8                               # 27e
        rotqbyi $to_list_2,$ends,4                      # 27o
        andi    $row_2,$row_2,48                        # 29e
        a       $to_packet_2,$ends,$row_2               # 31e
        a       $here,$site,$row_2                      # 32e all of its words
        lqd     $point_x,16($here)                      # 34o
        lqd     $point_x_2,0($here)                     # 35o
        lqd     $point_y,64($here)                      # 36o
        lqd     $point_y_2,80($here)                    # 37o
        lqd     $point_z,144($here)                     # 38o
        nop     $127                                    # 39e pairing
        lqd     $point_z_2,128($here)                   # 39o
        fnms    $to_x,$point_x,$k_near,$light_x         # 40e
        lqd     $other,720($here)                       # 40o
        fnms    $to_x_2,$point_x_2,$k_near,$light_x     # 41e
        lqd     $most,656($here)                        # 41o
        fnms    $to_y,$point_y,$k_near,$light_y         # 42e
        rotqbyi $a_rays_2,$here,4                       # 42o
        fnms    $to_y_2,$point_y_2,$k_near,$light_y     # 43e
        lqd     $most_2,640($here)                      # 43o
        fnms    $to_z_2,$point_z,$k_near,$light_z       # 44e
        lqd     $other_2,704($here)                     # 44o
        fnms    $to_z_3,$point_z_2,$k_near,$light_z     # 45e
        lqd     $other_3,784($here)                     # 45o
        fm      $squared,$to_x,$to_x                    # 46e
        lqd     $other_4,768($here)                     # 46o
        fm      $squared_2,$to_x_2,$to_x_2              # 47e
        lqd     $weight_2,528($a_rays_2)                # 47o
        or      $most,$most,$other                      # 48e
        lqd     $weight_3,512($a_rays_2)                # 48o
        nop     $127                                    # 49e pairing
        lqd     $plane_x,400($here)                     # 49o
        or      $most_2,$most_2,$other_2                # 50e
        lqd     $leave_2,576($here)                     # 50o
        or      $most,$most,$other_3                    # 51e
        lqd     $plane_y,448($here)                     # 51o
        fma     $squared,$to_y_2,$to_y_2,$squared       # 52e
        lqd     $leave_3,592($here)                     # 52o
        fma     $squared_2,$to_y,$to_y,$squared_2       # 53e
        lqd     $plane_x_2,384($here)                   # 53o
        or      $most_2,$most_2,$other_4                # 54e
        lqd     $plane_z_2,512($here)                   # 54o
        rotqbyi $step_2,$here,8                         # 55o
        shufb   $most,$most,$k_one,$m_seen              # 56o
        fma     $point_y,$leave_2,$plane_y,$point_y     # 57e
        shufb   $weight_4,$weight_2,$k_one,$m_seen      # 57o
        fma     $squared,$to_z_2,$to_z_2,$squared       # 58e
        shufb   $weight_5,$weight_3,$k_one,$m_seen      # 58o
        fma     $squared_3,$to_z_3,$to_z_3,$squared_2   # 59e
        shufb   $most_3,$most_2,$k_one,$m_seen          # 59o
        fma     $point_x,$leave_3,$plane_x,$point_x     # 60e
        lqd     $plane_z_3,528($here)                   # 60o
        fma     $point_x_2,$leave_2,$plane_x_2,$point_x_2 # 61e
        lqd     $plane_y_2,464($here)                   # 61o
        fma     $point_z_3,$leave_2,$plane_z_2,$point_z_2 # 62e
        lqd     $normal_y_2,272($here)                  # 62o
        lqd     $normal_y_3,256($here)                  # 63o
        frsqest $t_y,$squared                           # 64o
        nop     $127                                    # 65e pairing
        frsqest $t_y_2,$squared_3                       # 65o
        fma     $point_z,$leave_3,$plane_z_3,$point_z   # 66e
        lqd     $normal_z_2,336($here)                  # 66o
        fma     $point_y_2,$leave_3,$plane_y_2,$point_y_2 # 67e
        lqd     $normal_z_3,320($here)                  # 67o
        fi      $t_y_3,$squared,$t_y                    # 68e
        lqd     $normal_x_2,192($here)                  # 68o
        fi      $t_y_4,$squared_3,$t_y_2                # 69e
        lqd     $diffuse_2,832($here)                   # 69o
        lqd     $diffuse_3,848($here)                   # 70o
        lqd     $normal_x_3,208($here)                  # 71o
        lqd     $share_2,896($here)                     # 72o
        lqd     $share_3,912($here)                     # 73o
        nop     $127                                    # 74e pairing
        lqx     $step_3,$a_steps,$step_2                # 74o
        fm      $t_e_2,$squared,$t_y_3                  # 75e
        stqd    $point_y,64($to_packet_2)               # 75o
        fm      $t_e_3,$squared_3,$t_y_4                # 76e
        fm      $inverse_2,$t_y_3,$k_half               # 77e
        fm      $inverse_3,$t_y_4,$k_half               # 78e
        hbrr    next_pass_back,next_pass                # 78o hint
        fnms    $t_e_2,$t_e_2,$t_y_3,$k_one             # 81e
        fnms    $t_e_3,$t_e_3,$t_y_4,$k_one             # 82e
        fma     $inverse_2,$t_e_2,$inverse_2,$t_y_3     # 87e
        fma     $inverse_4,$t_e_3,$inverse_3,$t_y_4     # 88e
        fm      $to_x,$to_x,$inverse_2                  # 93e
        fm      $to_x_3,$to_x_2,$inverse_4              # 94e
        fm      $to_y_3,$to_y,$inverse_4                # 95e
        fm      $to_y,$to_y_2,$inverse_2                # 96e
        fm      $to_z_4,$to_z_2,$inverse_2              # 97e
        lnop                                            # 97o pairing
next_pass:
            fm      $facing,$normal_x_3,$to_x           # 0e
            stqd    $point_x,16($to_packet_2)           # 0o
            fm      $facing_2,$normal_x_2,$to_x_3       # 1e
            stqd    $site,0($to_list_2)                 # 1o
            fm      $facing_plane,$plane_x_2,$to_x_3    # 2e
        shlqbii $row,$at,2                              # 2o
            fm      $facing_plane_2,$plane_x,$to_x      # 3e
        lqx     $site,$a_sites,$at                      # 3o
            fma     $t,$squared_3,$inverse_4,$k_beyond  # 4e
            stqd    $to_x,208($to_packet_2)             # 4o
            fm      $to_z,$to_z_3,$inverse_4            # 5e
            stqd    $to_z_4,336($to_packet_2)           # 5o
            fma     $facing,$normal_y_2,$to_y,$facing   # 6e
            stqd    $point_x_2,0($to_packet_2)          # 6o
        andi    $row,$row,48                            # 7e
            stqd    $to_y,272($to_packet_2)             # 7o
            fma     $facing_plane,$plane_y,$to_y_3,$facing_plane # 8e
            stqd    $background,464($to_packet_2)       # 8o
        a       $here,$site,$row                        # 9e all of its words
            stqd    $point_z,144($to_packet_2)          # 9o
            fma     $facing_plane_2,$plane_y_2,$to_y,$facing_plane_2 # 10e
            stqd    $point_y_2,80($to_packet_2)         # 10o
            fma     $facing_2,$normal_y_3,$to_y_3,$facing_2 # 11e
            lnop                                        # 11o pairing
            fma     $facing,$normal_z_2,$to_z_4,$facing # 12e
        lqd     $point_x,16($here)                      # 12o
        ai      $at,$at,8                               # 13e
        lqd     $point_x_2,0($here)                     # 13o
            fma     $t_2,$squared,$inverse_2,$k_beyond  # 14e
        lqd     $point_y,64($here)                      # 14o
            fma     $facing_plane,$plane_z_2,$to_z,$facing_plane # 15e
        lqd     $point_z,144($here)                     # 15o
            fma     $facing_plane_2,$plane_z_3,$to_z_4,$facing_plane_2 # 16e
        lqd     $point_z_2,128($here)                   # 16o
            fma     $facing_2,$normal_z_3,$to_z,$facing_2 # 17e
        lqd     $point_y_2,80($here)                    # 17o
        fnms    $to_x,$point_x,$k_near,$light_x         # 18e
        fnms    $to_x_2,$point_x_2,$k_near,$light_x     # 19e
        fnms    $to_y,$point_y,$k_near,$light_y         # 20e
        fnms    $to_z_2,$point_z,$k_near,$light_z       # 21e
        fnms    $to_z_3,$point_z_2,$k_near,$light_z     # 22e
        fnms    $to_y_2,$point_y_2,$k_near,$light_y     # 23e
        fm      $squared,$to_x,$to_x                    # 24e
        fm      $squared_4,$to_x_2,$to_x_2              # 25e
            or      $facing_3,$facing,$facing_plane_2   # 26e
            lnop                                        # 26o pairing
            fm      $diffuse,$diffuse_3,$facing         # 27e
        lqd     $plane_x,400($here)                     # 27o
            fm      $diffuse_4,$diffuse_2,$facing_2     # 28e
        lqd     $leave,576($here)                       # 28o
            or      $facing,$facing_2,$facing_plane     # 29e
        lqd     $plane_y,448($here)                     # 29o
        fma     $squared,$to_y_2,$to_y_2,$squared       # 30e
        lqd     $other,720($here)                       # 30o
        fma     $squared_5,$to_y,$to_y,$squared_4       # 31e
        lqd     $other_3,784($here)                     # 31o
            cgti    $facing,$facing,0                   # 32e
        lqd     $leave_3,592($here)                     # 32o
            fma     $share,$most,$diffuse,$share_3      # 33e
        lqd     $most,656($here)                        # 33o
            fma     $share_4,$most_3,$diffuse_4,$share_2 # 34e
        rotqbyi $step_2,$here,8                         # 34o
        fma     $point_y,$leave,$plane_y,$point_y       # 35e
        rotqbyi $a_rays_2,$here,4                       # 35o
        fma     $squared,$to_z_2,$to_z_2,$squared       # 36e
        lqd     $plane_x_2,384($here)                   # 36o
        fma     $squared_3,$to_z_3,$to_z_3,$squared_5   # 37e
        lqd     $most_2,640($here)                      # 37o
        fma     $point_x,$leave_3,$plane_x,$point_x     # 38e
        lqd     $other_2,704($here)                     # 38o
        or      $most,$most,$other                      # 39e
        lnop                                            # 39o pairing
            fm      $share_4,$weight_5,$share_4         # 40e
        lqd     $other,768($here)                       # 40o
        or      $most,$most,$other_3                    # 41e
        lqd     $weight_6,528($a_rays_2)                # 41o
            fm      $share,$weight_4,$share             # 42e
        frsqest $t_y,$squared                           # 42o
        fma     $point_x_2,$leave,$plane_x_2,$point_x_2 # 43e
        frsqest $t_y_2,$squared_3                       # 43o
        or      $most_2,$most_2,$other_2                # 44e
        lqd     $plane_z_2,512($here)                   # 44o
            cgti    $facing_3,$facing_3,0               # 45e
        lqd     $weight_3,512($a_rays_2)                # 45o
        fi      $t_y,$squared,$t_y                      # 46e
        shufb   $most,$most,$k_one,$m_seen              # 46o
        fi      $t_y_2,$squared_3,$t_y_2                # 47e
        lnop                                            # 47o pairing
            fcmgt   $there_next_2,$share,$least         # 48e
            stqd    $background,448($to_packet_2)       # 48o
        or      $most_2,$most_2,$other                  # 49e
        shufb   $weight_4,$weight_6,$k_one,$m_seen      # 49o
            fcmgt   $there_2,$share_4,$least            # 50e
            stqd    $point_z_3,128($to_packet_2)        # 50o
        fma     $point_z_3,$leave,$plane_z_2,$point_z_2 # 51e
        shufb   $weight_5,$weight_3,$k_one,$m_seen      # 51o
            and     $there_3,$there_2,$facing           # 52e
        shufb   $most_3,$most_2,$k_one,$m_seen          # 52o
        fm      $t_e_4,$squared,$t_y                    # 53e
            stqd    $to_y_3,256($to_packet_2)           # 53o
        fm      $t_e_5,$squared_3,$t_y_2                # 54e
            stqd    $to_x_3,192($to_packet_2)           # 54o
        fm      $inverse_2,$t_y,$k_half                 # 55e
            stqd    $to_z,320($to_packet_2)             # 55o
            and     $there_next_3,$there_next_2,$facing_3 # 56e
            lnop                                        # 56o pairing
        fm      $inverse_4,$t_y_2,$k_half               # 57e
        lqd     $plane_z_3,528($here)                   # 57o
            or      $any_2,$there_3,$there_next_3       # 58e
            lqa     $m_lane_5,recent                    # 58o
        fnms    $t_e_4,$t_e_4,$t_y,$k_one               # 59e
        lnop                                            # 59o pairing
        fnms    $t_e_5,$t_e_5,$t_y_2,$k_one             # 60e
            orx     $any_2,$any_2                       # 60o
            sf      $rays_2,$there_3,$rays              # 61e
        lqd     $plane_y_2,464($here)                   # 61o
            selb    $t,$k_minus_one,$t,$there_3         # 62e
        lqd     $normal_y_2,272($here)                  # 62o
        fma     $point_z,$leave_3,$plane_z_3,$point_z   # 63e
        lqd     $normal_y_3,256($here)                  # 63o
            selb    $t_2,$k_minus_one,$t_2,$there_next_3 # 64e
            shufb   $there_before,$there_before,$any_2,$m_lane_5 # 64o
        fma     $inverse_2,$t_e_4,$inverse_2,$t_y       # 65e
        lqd     $normal_z_2,336($here)                  # 65o
        fma     $inverse_4,$t_e_5,$inverse_4,$t_y_2     # 66e
            stqd    $t,384($to_packet_2)                # 66o
        fma     $point_y_2,$leave_3,$plane_y_2,$point_y_2 # 67e
            stqd    $t_2,400($to_packet_2)              # 67o
        ai      $count,$count,-1                        # 68e
        lqd     $normal_z_3,320($here)                  # 68o
            ceqi    $any_3,$there_before,0              # 69e
        lqd     $normal_x_2,192($here)                  # 69o
            sf      $rays,$there_next_3,$rays_2         # 70e
        lqd     $diffuse_2,832($here)                   # 70o
            andc    $step_4,$step_3,$any_3              # 71e
        lqd     $diffuse_3,848($here)                   # 71o
        fm      $to_x,$to_x,$inverse_2                  # 72e
        lqd     $normal_x_3,208($here)                  # 72o
            a       $ends,$ends,$step_4                 # 73e
        lqd     $share_2,896($here)                     # 73o
        fm      $to_x_3,$to_x_2,$inverse_4              # 74e
        lqd     $share_3,912($here)                     # 74o
        a       $to_packet_2,$ends,$row                 # 75e
        rotqbyi $to_list_2,$ends,4                      # 75o
        fm      $to_y_3,$to_y,$inverse_4                # 76e
        lqx     $step_3,$a_steps,$step_2                # 76o
        fm      $to_y,$to_y_2,$inverse_2                # 77e
        stqd    $point_y,64($to_packet_2)               # 77o
        fm      $to_z_4,$to_z_2,$inverse_2              # 78e
next_pass_back:
        brnz    $count,next_pass                        # 78o
next_pass_drain:
        fm      $facing,$normal_x_3,$to_x               # 0e
        stqd    $point_x,16($to_packet_2)               # 0o
        fm      $facing_2,$normal_x_2,$to_x_3           # 1e
        stqd    $site,0($to_list_2)                     # 1o
        fm      $to_z_5,$to_z_3,$inverse_4              # 2e
        stqd    $to_x,208($to_packet_2)                 # 2o
        fm      $facing_plane,$plane_x_2,$to_x_3        # 3e
        stqd    $to_z_4,336($to_packet_2)               # 3o
        fm      $facing_plane_2,$plane_x,$to_x          # 4e
        stqd    $point_x_2,0($to_packet_2)              # 4o
        fma     $t,$squared_3,$inverse_4,$k_beyond      # 5e
        stqd    $to_y,272($to_packet_2)                 # 5o
        fma     $facing,$normal_y_2,$to_y,$facing       # 6e
        stqd    $background,464($to_packet_2)           # 6o
        fma     $facing_2,$normal_y_3,$to_y_3,$facing_2 # 7e
        stqd    $point_z,144($to_packet_2)              # 7o
        fma     $t_2,$squared,$inverse_2,$k_beyond      # 8e
        stqd    $point_y_2,80($to_packet_2)             # 8o
        fma     $facing_plane,$plane_y,$to_y_3,$facing_plane # 9e
        stqd    $background,448($to_packet_2)           # 9o
        fma     $facing_plane_2,$plane_y_2,$to_y,$facing_plane_2 # 10e
        stqd    $point_z_3,128($to_packet_2)            # 10o
        nop     $127                                    # 11e pairing
        stqd    $to_y_3,256($to_packet_2)               # 11o
        fma     $facing,$normal_z_2,$to_z_4,$facing     # 12e
        stqd    $to_x_3,192($to_packet_2)               # 12o
        fma     $facing_2,$normal_z_3,$to_z_5,$facing_2 # 13e
        stqd    $to_z_5,320($to_packet_2)               # 13o
        nop     $127                                    # 14e pairing
        lqa     $m_lane_5,recent                        # 14o
        fma     $facing_plane,$plane_z_2,$to_z_5,$facing_plane # 15e
        hbr     shadow_rays_r16_return,$lr              # 15o hint
        fma     $facing_plane_2,$plane_z_3,$to_z_4,$facing_plane_2 # 16e
        fm      $diffuse,$diffuse_3,$facing             # 18e
        fm      $diffuse_4,$diffuse_2,$facing_2         # 19e
        or      $facing_2,$facing_2,$facing_plane       # 21e
        or      $facing_3,$facing,$facing_plane_2       # 22e
        cgti    $facing,$facing_2,0                     # 23e
        fma     $share,$most,$diffuse,$share_3          # 24e
        fma     $share_4,$most_3,$diffuse_4,$share_2    # 25e
        cgti    $facing_3,$facing_3,0                   # 26e
        fm      $share,$weight_4,$share                 # 30e
        fm      $share_4,$weight_5,$share_4             # 31e
        fcmgt   $there_next_2,$share,$least             # 36e
        fcmgt   $there_2,$share_4,$least                # 37e
        and     $there_next_3,$there_next_2,$facing_3   # 38e
        and     $there_3,$there_2,$facing               # 39e
        selb    $t_2,$k_minus_one,$t_2,$there_next_3    # 40e
        or      $any_2,$there_3,$there_next_3           # 41e
        sf      $rays_2,$there_3,$rays                  # 42e
        selb    $t,$k_minus_one,$t,$there_3             # 43e
        orx     $any_2,$any_2                           # 43o
        sf      $rays,$there_next_3,$rays_2             # 44e
        stqd    $t,384($to_packet_2)                    # 45o
        rotqbyi $step,$rays,8                           # 46o
        shufb   $there_before,$there_before,$any_2,$m_lane_5 # 47o
        stqd    $t_2,400($to_packet_2)                  # 48o
        lqa     $m_lane,ended                           # 49o
        a       $rays,$rays,$step                       # 50e
        ceqi    $any_3,$there_before,0                  # 51e
        rotqbyi $step,$rays,4                           # 52o
        andc    $step_4,$step_3,$any_3                  # 53e
        a       $ends,$ends,$step_4                     # 55e
        a       $rays,$rays,$step                       # 56e
        rotqbyi $ends,$ends,4                           # 57o
        shufb   $a_sites,$ends,$rays,$m_lane            # 61o
        nop     $127                                    # 62e pairing
shadow_rays_r16_return:
        bi      $lr                                     # 62o
next_pass_short:
        ai      $count,$count,-1                        # 0e
        lqx     $site,$a_sites,$at                      # 0o
        nop     $127                                    # 1e pairing
        shlqbii $row,$at,2                              # 1o
        ai      $at,$at,8                               # 2e
        lqa     $m_lane,recent                          # 2o
        rotqbyi $to_list,$ends,4                        # 3o
        andi    $row,$row,48                            # 5e
        a       $here,$site,$row                        # 7e all of its words
        stqd    $site,0($to_list)                       # 7o
        a       $to_packet,$ends,$row                   # 8e
        lqd     $point_x,0($here)                       # 9o
        lqd     $point_x_3,16($here)                    # 10o
        lqd     $point_y,64($here)                      # 11o
        lqd     $point_y_3,80($here)                    # 12o
        lqd     $point_z,128($here)                     # 13o
        nop     $127                                    # 14e pairing
        lqd     $point_z_4,144($here)                   # 14o
        fnms    $to_x,$point_x,$k_near,$light_x         # 15e
        lqd     $normal_x,192($here)                    # 15o
        fnms    $to_x_4,$point_x_3,$k_near,$light_x     # 16e
        lqd     $normal_x_4,208($here)                  # 16o
        fnms    $to_y,$point_y,$k_near,$light_y         # 17e
        lqd     $normal_y,256($here)                    # 17o
        fnms    $to_y_4,$point_y_3,$k_near,$light_y     # 18e
        lqd     $normal_y_2,272($here)                  # 18o
        fnms    $to_z,$point_z,$k_near,$light_z         # 19e
        lqd     $normal_z,320($here)                    # 19o
        fnms    $to_z_6,$point_z_4,$k_near,$light_z     # 20e
        lqd     $normal_z_4,336($here)                  # 20o
        fm      $squared,$to_x,$to_x                    # 21e
        lqd     $plane_x,384($here)                     # 21o
        fm      $squared_6,$to_x_4,$to_x_4              # 22e
        lqd     $most,640($here)                        # 22o
        lqd     $other,704($here)                       # 23o
        lqd     $plane_x_3,400($here)                   # 24o
        lqd     $most_4,656($here)                      # 25o
        lqd     $other_5,720($here)                     # 26o
        fma     $squared,$to_y,$to_y,$squared           # 27e
        lqd     $diffuse,832($here)                     # 27o
        fma     $squared_6,$to_y_4,$to_y_4,$squared_6   # 28e
        lqd     $other_6,768($here)                     # 28o
        or      $most,$most,$other                      # 29e
        lqd     $diffuse_5,848($here)                   # 29o
        lqd     $other,784($here)                       # 30o
        rotqbyi $a_rays_3,$here,4                       # 31o
        or      $most_4,$most_4,$other_5                # 32e
        lqd     $plane_y_3,448($here)                   # 32o
        fma     $squared,$to_z,$to_z,$squared           # 33e
        lqd     $plane_y_4,464($here)                   # 33o
        fma     $squared_6,$to_z_6,$to_z_6,$squared_6   # 34e
        lqd     $share,896($here)                       # 34o
        or      $most,$most,$other_6                    # 35e
        lqd     $share_5,912($here)                     # 35o
        or      $most_4,$most_4,$other                  # 36e
        lqd     $weight,512($a_rays_3)                  # 36o
        shufb   $most,$most,$k_one,$m_seen              # 37o
        lqd     $weight_7,528($a_rays_3)                # 38o
        frsqest $t_y,$squared                           # 39o
        frsqest $t_y_5,$squared_6                       # 40o
        shufb   $most_4,$most_4,$k_one,$m_seen          # 41o
        lqd     $plane_z_4,512($here)                   # 42o
        fi      $t_y,$squared,$t_y                      # 43e
        lqd     $plane_z_5,528($here)                   # 43o
        fi      $t_y_5,$squared_6,$t_y_5                # 44e
        shufb   $weight,$weight,$k_one,$m_seen          # 44o
        shufb   $weight_7,$weight_7,$k_one,$m_seen      # 45o
        lqd     $leave_4,576($here)                     # 46o
        lqd     $leave_5,592($here)                     # 47o
        rotqbyi $step_5,$here,8                         # 48o
        nop     $127                                    # 49e pairing
        stqd    $background,448($to_packet)             # 49o
        fm      $t_e_6,$squared,$t_y                    # 50e
        stqd    $background,464($to_packet)             # 50o
        fm      $t_e_7,$squared_6,$t_y_5                # 51e
        lnop                                            # 51o pairing
        fm      $inverse_5,$t_y,$k_half                 # 52e
        lqx     $step_5,$a_steps,$step_5                # 52o
        fm      $inverse_6,$t_y_5,$k_half               # 53e
        fma     $point_x,$leave_4,$plane_x,$point_x     # 54e
        fma     $point_y,$leave_4,$plane_y_3,$point_y   # 55e
        fnms    $t_e_6,$t_e_6,$t_y,$k_one               # 56e
        fnms    $t_e_7,$t_e_7,$t_y_5,$k_one             # 57e
        fma     $point_z,$leave_4,$plane_z_4,$point_z   # 58e
        fma     $point_x_3,$leave_5,$plane_x_3,$point_x_3 # 59e
        lnop                                            # 59o pairing
        fma     $point_y_3,$leave_5,$plane_y_4,$point_y_3 # 60e
        stqd    $point_x,0($to_packet)                  # 60o
        fma     $point_z_4,$leave_5,$plane_z_5,$point_z_4 # 61e
        stqd    $point_y,64($to_packet)                 # 61o
        fma     $inverse_7,$t_e_6,$inverse_5,$t_y       # 62e
        fma     $inverse_8,$t_e_7,$inverse_6,$t_y_5     # 63e
        stqd    $point_z,128($to_packet)                # 64o
        stqd    $point_x_3,16($to_packet)               # 65o
        stqd    $point_y_3,80($to_packet)               # 66o
        stqd    $point_z_4,144($to_packet)              # 67o
        fm      $to_x,$to_x,$inverse_7                  # 68e
        fm      $to_x_5,$to_x_4,$inverse_8              # 69e
        fm      $to_y,$to_y,$inverse_7                  # 70e
        fm      $to_y_5,$to_y_4,$inverse_8              # 71e
        fm      $to_z,$to_z,$inverse_7                  # 72e
        fm      $to_z_7,$to_z_6,$inverse_8              # 73e
        fm      $facing_4,$normal_x,$to_x               # 74e
        stqd    $to_x,192($to_packet)                   # 74o
        fm      $facing_5,$normal_x_4,$to_x_5           # 75e
        stqd    $to_x_5,208($to_packet)                 # 75o
        fm      $facing_plane_3,$plane_x,$to_x          # 76e
        stqd    $to_y,256($to_packet)                   # 76o
        fm      $facing_plane_4,$plane_x_3,$to_x_5      # 77e
        stqd    $to_y_5,272($to_packet)                 # 77o
        fma     $t_3,$squared,$inverse_7,$k_beyond      # 78e
        stqd    $to_z,320($to_packet)                   # 78o
        fma     $t_4,$squared_6,$inverse_8,$k_beyond    # 79e
        stqd    $to_z_7,336($to_packet)                 # 79o
        fma     $facing_4,$normal_y,$to_y,$facing_4     # 80e
        fma     $facing_5,$normal_y_2,$to_y_5,$facing_5 # 81e
        fma     $facing_plane_3,$plane_y_3,$to_y,$facing_plane_3 # 82e
        fma     $facing_plane,$plane_y_4,$to_y_5,$facing_plane_4 # 83e
        fma     $facing_2,$normal_z,$to_z,$facing_4     # 86e
        fma     $facing_3,$normal_z_4,$to_z_7,$facing_5 # 87e
        fma     $facing_plane_5,$plane_z_4,$to_z,$facing_plane_3 # 88e
        fma     $facing_plane,$plane_z_5,$to_z_7,$facing_plane # 89e
        fm      $diffuse,$diffuse,$facing_2             # 92e
        fm      $diffuse_6,$diffuse_5,$facing_3         # 93e
        or      $facing_2,$facing_2,$facing_plane_5     # 94e
        or      $facing_3,$facing_3,$facing_plane       # 95e
        cgti    $facing_2,$facing_2,0                   # 96e
        cgti    $facing_3,$facing_3,0                   # 97e
        fma     $share,$most,$diffuse,$share            # 98e
        fma     $share_6,$most_4,$diffuse_6,$share_5    # 99e
        fm      $share,$weight,$share                   # 104e
        fm      $share_6,$weight_7,$share_6             # 105e
        fcmgt   $there,$share,$least                    # 110e
        fcmgt   $there_next,$share_6,$least             # 111e
        and     $there,$there,$facing_2                 # 112e
        and     $there_next,$there_next,$facing_3       # 113e
        selb    $t,$k_minus_one,$t_3,$there             # 114e
        or      $any_3,$there,$there_next               # 115e
        selb    $t_5,$k_minus_one,$t_4,$there_next      # 116e
        stqd    $t,384($to_packet)                      # 116o
        sf      $rays,$there,$rays                      # 117e
        orx     $any,$any_3                             # 117o
        stqd    $t_5,400($to_packet)                    # 118o
        sf      $rays,$there_next,$rays                 # 119e
        shufb   $there_before,$there_before,$any,$m_lane # 121o
        ceqi    $any,$there_before,0                    # 125e
        andc    $step,$step_5,$any                      # 127e
        lnop                                            # 127o pairing
        a       $ends,$ends,$step                       # 129e
        brnz    $count,next_pass_short                  # 129o
        rotqbyi $step,$rays,8                           # 130o
        lqa     $m_lane,ended                           # 131o
        rotqbyi $ends,$ends,4                           # 132o
        a       $rays,$rays,$step                       # 134e
        rotqbyi $step,$rays,4                           # 136o
        a       $rays,$rays,$step                       # 140e
        shufb   $a_sites,$ends,$rays,$m_lane            # 142o
        bi      $lr                                     # 143o
endfunction shadow_rays_r16
