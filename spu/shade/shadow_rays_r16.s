# shadow_rays_r16   rays from where sixteen rays have hit to a light, unless they show nothing
#   C       vec_uint4 shadow_rays_r16(const struct site *, int count, const struct light *,
#                                     const struct object *background, float min_share,
#                                     struct ray_packet *, struct site *listed);
#   In      $3 sites, $4 count (at least 1), $5 light, $6 the background's object, $7 the minimum
#           share of the light that counts, or 0 if every ray does; $8 where the rays go, $9 where
#           their sites go, with space for as many as there are sites; pointers 16-aligned
#   Out     a packet for each site in which some lane has a ray, in order: origin, direction, t,
#           object; and these sites, as they are; anything may follow these. $3 the end
#           of the listed sites, number of rays, how many bytes of the listed sites shine
#   Uses    $3-$4, $6-$7, $10-$68   Saves  -   Stack  0   Calls  -
#   Domain  distance to the light below 2^62; shares not below 0; a direction of
#           length 1 if the light is infinitely far
#   Error   2 ulp of 1, each component of the direction; t 4 ulp
#   Twin    lab/twins/src/shadow_rays.rs
#
#   to = position - point, L = to / |to|, t = |to|
#   fade = 1 - falloff |to|^2
#   for a directional light: to = position, t = FARTHEST, fade = 1
#   a ray exists if neither N.L nor plane.L is below 0, one of them is above 0, and
#   fade weight (most diffuse (N.L) + highlight) > minimum; otherwise t = -1
#   origin = point + ahead L + rest plane, which is `leave` off the surface: ahead is
#   leave / (plane.L), at most 8 leave, or 2 where light passes; rest is 0 unless the ray grazes
#   t counts from point
# most is the OR of the bits of red, green and blue: at least the largest of them, and below 2 if
# they are. A highlight is at most its share. If every ray counts, weight and most are 1: a ray
# exists where any share is. A light exactly at the point has L = 0, and there is no ray.
#
# Each packet is stored after the last one that has a ray in some lane, so a packet without any is
# overwritten. The site is stored in the same way. A pass makes two rows of four rays.

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
# The results: the end of the listed sites, rays, how many bytes of these sites shine.
ended:  .int    0x00010203,0x10111213,0x04050607,0x80808080
# How far these move after the rows 0 and 2: only after a packet's last ones. The second part is
# for sites with highlights.
steps:  .int    0,0,0,0,0,0,0,0,RAYS16_SIZE,SITE_SIZE,0,0
        .skip   SITE_SHINES-48
        .int    0,0,0,0,0,0,0,0,RAYS16_SIZE,SITE_SIZE,SITE_SIZE,0

        .set    NEXT,3
        registers a_sites,count,a_light,background
        registers min_share                             # later in all lanes
        registers a_shadow,a_listed
        # constants
        registers k_half,k_one,k_minus_one
        registers k_near                                # 0 for a directional light, else 1
        registers k_beyond                              # FARTHEST for a directional light, else 0
        registers k_falloff                             # 0 for a directional light
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
        registers most,other,weight,share,there_next,fade
        registers k_farthest,k_inside,ahead,farthest,grazes,rest
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
        fnms    $fade,$squared,$k_falloff,$k_one
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
        frest   $ahead,$facing_plane
        lqd     $farthest,SURFACES_transmittance+\at($here)
        cgti    $farthest,$farthest,0
        selb    $farthest,$k_farthest,$k_inside,$farthest
        fcmgt   $grazes,$ahead,$farthest
        selb    $ahead,$ahead,$farthest,$grazes
        fm      $ahead,$leave,$ahead
        fnms    $rest,$ahead,$facing_plane,$leave
        and     $rest,$rest,$grazes
    .irp axis, x,y,z
        fma     $point_\axis,$ahead,$to_\axis,$point_\axis
        fma     $point_\axis,$rest,$plane_\axis,$point_\axis
        stqd    $point_\axis,RAYS16_origin_\axis+\at($to_packet)
    .endr
        stqd    $background,RAYS16_object+\at($to_packet)
        # The OR of the channels is at least the largest of them.
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
        fm      $weight,$weight,$fade
        fm      $share,$weight,$share
        or      $facing,$facing,$facing_plane
        fcgt    $\there,$share,$min_share
        cgti    $facing,$facing,0
        and     $\there,$\there,$facing
        sf      $rays,$\there,$rays                    # true is -1
        selb    $t,$k_minus_one,$t,$\there
        stqd    $t,RAYS16_t+\at($to_packet)
.endm

function shadow_rays_r16
        shli    $count,$count,1                         # passes
        ilhu    $k_half,0x3f00
        ilhu    $k_one,0x3f80
        ilhu    $k_beyond,FARTHEST>>16
        ilhu    $k_minus_one,0xbf80
        ilhu    $k_farthest,0x4100                      # 8
        ilhu    $k_inside,0x4000                        # 2
        lqd     $light,LIGHT_position($a_light)
        lqa     $t_y,two
        splat_word $light_x,0x00010203
        splat_word $light_y,0x04050607
        splat_word $light_z,0x08090a0b
        splat_word $k_falloff,0x0c0d0e0f
        rotmai  $there,$k_falloff,-31
        andc    $k_near,$k_one,$there
        and     $k_beyond,$k_beyond,$there
        andc    $k_falloff,$k_falloff,$there
        splat_mask $m_lane
        splat   $background,$background,$m_lane
        splat   $min_share,$min_share,$m_lane
        lqa     $m_seen,as_is
        ceqi    $t_e,$min_share,0
        ilh     $m_lane,0x1010
        and     $t_e,$t_e,$m_lane
        or      $m_seen,$m_seen,$t_e
        shufb   $ends,$a_shadow,$a_listed,$t_y
        ila     $a_steps,steps
        il      $at,0
        il      $there_before,0
        il      $rays,0
next_pass:
        lqx     $site,$a_sites,$at
        shlqbii $row,$at,2
        ai      $at,$at,8
        andi    $row,$row,48
        a       $here,$site,$row                        # all of its words
        a       $to_packet,$ends,$row
        rotqbyi $step,$here,SITE_shines
        lqx     $step,$a_steps,$step
        rotqbyi $a_rays,$here,SITE_rays
        rotqbyi $to_list,$ends,4
        shadow_ray 0,there
        shadow_ray 16,there_next
        or      $any,$there,$there_next
        stqd    $site,0($to_list)
        lqa     $m_lane,recent
        orx     $any,$any
        shufb   $there_before,$there_before,$any,$m_lane
        ceqi    $any,$there_before,0
        andc    $step,$step,$any
        a       $ends,$ends,$step
        ai      $count,$count,-1
        brnz    $count,next_pass                        # at least 2 passes: a site has two
        rotqbyi $step,$rays,8
        lqa     $m_lane,ended
        a       $rays,$rays,$step
        rotqbyi $ends,$ends,4
        rotqbyi $step,$rays,4
        a       $rays,$rays,$step
        shufb   $3,$ends,$rays,$m_lane
        bi      $lr
endfunction shadow_rays_r16
