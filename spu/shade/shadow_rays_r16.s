# shadow_rays_r16   rays from where sixteen rays have hit to a light
#   C       vec_uint4 shadow_rays_r16(const struct site *, int count, const struct light *,
#                                     const struct object *background);
#   In      $3 sites, $4 count (at least 1), $5 light, $6 the background's object; pointers
#           16-aligned
#   Out     the sites' shadow rays: origin, direction, t, object; weight and pixel stay as they are
#           $3 shadow rays, a count a lane
#   Uses    $3-$4, $6-$7, $10-$50   Saves  -   Stack  0   Calls  -
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
        ilhu    $k_half,0x3f00
        ilhu    $k_one,0x3f80
        ilhu    $k_farthest,FARTHEST>>16
        ilhu    $k_minus_one,0xbf80
        lqd     $light,LIGHT_position($a_light)
        splat_word $light_x,0x00010203
        splat_word $light_y,0x04050607
        splat_word $light_z,0x08090a0b
        splat_word $c_directional,0x0c0d0e0f
        andc    $k_near,$k_one,$c_directional
        splat_mask $m_lane
        splat   $background,$background,$m_lane
        il      $rays,0
next_site:
        lqd     $a_surfaces,SITE_surfaces($a_site)
        rotqbyi $a_shadow,$a_surfaces,SITE_shadow
    .irp row, 0,1,2,3
    .irp axis, x,y,z
        lqd     $point_\axis,SURFACES_point_\axis+16*\row($a_surfaces)
        lqd     $normal_\axis,SURFACES_normal_\axis+16*\row($a_surfaces)
        lqd     $plane_\axis,SURFACES_plane_\axis+16*\row($a_surfaces)
        fnms    $to_\axis,$point_\axis,$k_near,$light_\axis
    .endr
        dot_f4  $squared,to,to
        rsqrt_f4 $inverse,$squared,$t_y,$t_e,$k_half,$k_one
        fm      $t,$squared,$inverse
        selb    $t,$t,$k_farthest,$c_directional
        selb    $inverse,$inverse,$k_one,$c_directional
    .irp axis, x,y,z
        fm      $to_\axis,$to_\axis,$inverse
        stqd    $to_\axis,RAYS16_direction_\axis+16*\row($a_shadow)
    .endr
        dot_f4  $facing,normal,to
        dot_f4  $facing_plane,plane,to
        lqd     $share,SURFACES_highlight+16*\row($a_surfaces)
        lqd     $diffuse,SURFACES_diffuse+16*\row($a_surfaces)
        or      $share,$share,$diffuse
        cgti    $facing,$facing,0
        cgti    $facing_plane,$facing_plane,0
        cgti    $share,$share,0
        and     $facing,$facing,$facing_plane
        and     $facing,$facing,$share
        sf      $rays,$facing,$rays                     # true is -1
        selb    $t,$k_minus_one,$t,$facing
        stqd    $t,RAYS16_t+16*\row($a_shadow)
        stqd    $background,RAYS16_object+16*\row($a_shadow)
        lqd     $leave,SURFACES_leave+16*\row($a_surfaces)
    .irp axis, x,y,z
        fma     $point_\axis,$leave,$plane_\axis,$point_\axis
        stqd    $point_\axis,RAYS16_origin_\axis+16*\row($a_shadow)
    .endr
    .endr
        ai      $a_site,$a_site,SITE_SIZE
        ai      $count,$count,-1
        brnz    $count,next_site
        ori     $3,$rays,0
        bi      $lr
endfunction shadow_rays_r16
