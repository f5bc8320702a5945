# texture_places_r16   where the texels of sixteen hits are in their textures
#   C       void texture_places_r16(const struct rays16 *, const struct surfaces *,
#                                   struct texels *, vec_float4 pixel_angle);
#   In      $3 rays, $4 their surfaces, $5 texels, $6 the angle of a pixel in the preferred slot;
#           pointers 16-aligned. A ray's hit is an address, of any record
#   Out     texels: tile, all ones unless the object has SIDES_TEXTURED and the material a TEXTURE;
#           place, right and down of the others
#   Uses    $3-$79   Saves  -   Stack  0   Calls  -
#   Domain  points in their triangles; edges from 2^-30 to 2^30, and from 1/100 of the points'
#           distance from the eye on; |plane| and |d| about 1
#   Error   4e-7 of the largest texture coordinate, or 1, plus the largest difference between those
#           of the vertices; for the point as it is given
#   Twin    lab/twins/src/texture.rs
#
# For the point p, the vertices a, b, c relative to p, and the plane's normal g:
#   A = (g x b).c, B = (g x c).a, C = (g x a).b        their sum is the triangle's double area
#   u = u_a + B (u_b - u_a) / sum + C (u_c - u_a) / sum            v likewise
# A pixel's width where the ray meets the surface, in texels of the first level:
#   f^2 = (angle (|origin| + t))^2 / (g.d)^2 |double area in u, v| texels / sum
# The level is the whole number nearest to log2 f, so half the exponent of 2 f^2, rounded down.
# |origin| is how far the ray's chain has come, exactly so for the first two rays of a chain.
#
# The loop counts up, so that it isn't pipelined, which would double its size.

        .include "work_unit.inc"
        .include "macros.inc"
        .include "barycentric.inc"
        .include "math.inc"
        .include "reciprocal.inc"

        .set    NEXT,3
        registers a_rays,a_surfaces,a_texels,angle
        # constants
        registers m_xy,m_zw,m_first,m_second,k_half,k_one,k_sign,rows
        # the lanes' records
        registers patch                                 # to 18
        .set    quad,19                                 # to 22
        .set    texture,23                              # to 26
        .set    NEXT,27
        registers low,high,textured
        # the row
        registers px,py,pz,gx,gy,gz,dx,dy,dz
        registers ax                                    # the vertices, relative to the point
        registers ay,az,au,bx,by,bz,bu,cx,cy,cz,cu,av,bv,cv
        registers turn_x,turn_y,turn_z,share_a,share_b,share_c,inverse,t_y,t_e
        registers u,v,area,far,breadth,cosine,steep
        # the texture and its level, after the triangle
        .set    levels,px
        .set    last,py
        .set    texels,pz
        .set    wraps,gx
        .set    level,gy
        .set    c_level,gz
        .set    width,ax
        .set    height,ay
        .set    across,az
        .set    first,bx
        .set    whole,by
        .set    floor,bz
        .set    c_above,cx
        .set    inside,cy
        .set    turned,cz
        .set    m_wrap,turn_x
        .set    column,turn_y
        .set    row,turn_z
        .set    tile,share_a
        .set    place,share_b

        .section .rodata.texture,"a",@progbits
        .align  4
transpose:
        transpose_shuffles

# Loads one word of it: the second one with m_xy, the fourth with m_zw.
.macro  gather_one from:req, offset:req, out:req, m_half:req
    .irp lane, 0,1,2,3
        lqd     $quad+\lane,\offset($\from+\lane)
    .endr
        shufb   $low,$quad,$quad+1,\m_half
        shufb   $high,$quad+2,$quad+3,\m_half
        shufb   \out,$low,$high,$m_second
.endm

# Brings coordinates between 0 and 1. The shifts bring their bits of `wraps` to the sign.
.macro  within place:req, repeated:req, mirrored:req
        cflts   $whole,\place,0
        csflt   $floor,$whole,0
        fcgt    $c_above,$floor,\place                  # below 0, towards 0 is upwards
        a       $whole,$whole,$c_above                  # true is -1
        csflt   $floor,$whole,0
        fs      $inside,\place,$floor
        fs      $turned,$k_one,$inside
        shli    $whole,$whole,31
        shli    $m_wrap,$wraps,\mirrored
        and     $whole,$whole,$m_wrap
        rotmai  $whole,$whole,-31
        selb    $inside,$inside,$turned,$whole
        shli    $m_wrap,$wraps,\repeated
        rotmai  $m_wrap,$m_wrap,-31
        selb    \place,\place,$inside,$m_wrap
        rotmai  $c_above,\place,-31
        andc    \place,\place,$c_above
        fcgt    $c_above,\place,$k_one
        selb    \place,\place,$k_one,$c_above
.endm

function texture_places_r16
        lqa     $m_xy,transpose
        lqa     $m_zw,transpose+16
        lqa     $m_first,transpose+32
        lqa     $m_second,transpose+48
        ilhu    $k_half,0x3f00
        ilhu    $k_one,0x3f80
        ilhu    $k_sign,0x8000
        splat_mask $low
        splat   $angle,$angle,$low
        il      $rows,-4
next_row:
        lqd     $patch,RAYS16_object($a_rays)
        spread_lanes patch
        gather_one patch,OBJECT_sides&~15,$textured,$m_zw
        shli    $textured,$textured,3                   # SIDES_TEXTURED becomes the sign
        rotmai  $textured,$textured,-31
        lqd     $texture,SURFACES_material($a_surfaces)
        spread_lanes texture
        gather_one texture,MATERIAL_texture&~15,$texture,$m_xy
        ceqi    $low,$texture,0
        andc    $textured,$textured,$low
        spread_lanes texture
    .irp axis, x,y,z
        lqd     $p\axis,SURFACES_point_\axis($a_surfaces)
        lqd     $g\axis,SURFACES_plane_\axis($a_surfaces)
        lqd     $d\axis,RAYS16_direction_\axis($a_rays)
    .endr
        gather  patch,TRI_a,$ax,$ay,$az,$au
        gather  patch,TRI_b,$bx,$by,$bz,$bu
        gather  patch,TRI_c,$cx,$cy,$cz,$cu
        gather_one patch,PATCH_normal_a,$av,$m_zw
        gather_one patch,PATCH_normal_b,$bv,$m_zw
        gather_one patch,PATCH_normal_c,$cv,$m_zw
    .irp axis, x,y,z
        fs      $a\axis,$a\axis,$p\axis
        fs      $b\axis,$b\axis,$p\axis
        fs      $c\axis,$c\axis,$p\axis
    .endr
        share_of_area $share_a,b,c
        share_of_area $share_b,c,a
        share_of_area $share_c,a,b
        fa      $share_a,$share_a,$share_b
        fa      $share_a,$share_a,$share_c
        reciprocal_f4 $inverse,$share_a,$t_y,$t_e,$k_one
        fm      $share_b,$share_b,$inverse
        fm      $share_c,$share_c,$inverse
        fs      $bu,$bu,$au
        fs      $cu,$cu,$au
        fs      $bv,$bv,$av
        fs      $cv,$cv,$av
        fma     $u,$share_b,$bu,$au
        fma     $u,$share_c,$cu,$u
        fma     $v,$share_b,$bv,$av
        fma     $v,$share_c,$cv,$v
        fm      $area,$bu,$cv
        fnms    $area,$cu,$bv,$area
        fm      $area,$area,$inverse
        andc    $area,$area,$k_sign

        # How far the ray has come, how large a pixel is there, and how steeply it meets the plane.
        fm      $cosine,$gx,$dx
        fma     $cosine,$gy,$dy,$cosine
        fma     $cosine,$gz,$dz,$cosine
        fm      $cosine,$cosine,$cosine
        lqd     $px,RAYS16_origin_x($a_rays)
        lqd     $py,RAYS16_origin_y($a_rays)
        lqd     $pz,RAYS16_origin_z($a_rays)
        fm      $breadth,$px,$px
        fma     $breadth,$py,$py,$breadth
        fma     $breadth,$pz,$pz,$breadth
        sqrt_f4 $far,$breadth,$t_y,$t_e,$k_half
        lqd     $breadth,RAYS16_t($a_rays)
        fa      $far,$far,$breadth
        fm      $far,$far,$angle
        fm      $far,$far,$far
        reciprocal_f4 $steep,$cosine,$t_y,$t_e,$k_one
        fm      $breadth,$far,$area
        fm      $breadth,$breadth,$steep

        gather  texture,0,$levels,$last,$texels,$wraps
        fm      $breadth,$breadth,$texels
        rotmi   $level,$breadth,-23
        ai      $level,$level,-126                      # the exponent of 2 f^2
        rotmai  $level,$level,-1
        cgti    $c_level,$level,-1
        and     $level,$level,$c_level
        cgt     $c_level,$level,$last
        selb    $level,$level,$last,$c_level
        shli    $level,$level,4
        a       $texture,$levels,$level
        spread_lanes texture
        gather  texture,0,$width,$height,$across,$first
        within  $u,28,29
        within  $v,30,31
        fma     $u,$u,$width,$k_half
        fma     $v,$v,$height,$k_half
        cflts   $column,$u,0
        cflts   $row,$v,0
        csflt   $inside,$column,0
        csflt   $turned,$row,0
        fs      $u,$u,$inside
        fs      $v,$v,$turned
        stqd    $u,TEXELS_right($a_texels)
        stqd    $v,TEXELS_down($a_texels)
        rotmi   $tile,$column,-3
        rotmi   $whole,$row,-3
        andi    $column,$column,7
        andi    $row,$row,7
        mpyu    $whole,$whole,$across
        shli    $column,$column,2
        mpyi    $row,$row,4*TEXTURE_SIDE
        rotmi   $wraps,$wraps,-WRAP_BITS
        a       $tile,$tile,$whole
        a       $first,$first,$wraps
        a       $tile,$tile,$first
        orc     $tile,$tile,$textured
        a       $place,$column,$row
        stqd    $tile,TEXELS_tile($a_texels)
        stqd    $place,TEXELS_place($a_texels)
        ai      $a_rays,$a_rays,16
        ai      $a_surfaces,$a_surfaces,16
        ai      $a_texels,$a_texels,16
        ai      $rows,$rows,1
        brnz    $rows,next_row
        bi      $lr
endfunction texture_places_r16
