# texture_places_r16   where the texels of sixteen hits are in their textures
#   C       void texture_places_r16(const struct rays16 *, const struct surfaces *,
#                                   struct texels *, vec_float4 pixel_angle);
#   In      $3 rays, $4 their surfaces, $5 texels, $6 the angle of a pixel in the preferred slot;
#           pointers 16-aligned. What a ray has hit is an address, of any record
#   Out     texels: tile, all ones unless the object has SIDES_TEXTURED and the material a TEXTURE;
#           place, right and down of the others
#   Uses    $2-$69   Saves  -   Stack  0   Calls  -
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
# The loop counts up, so that it isn't pipelined, which would take as much room again.
# Scheduled by spu schedule from texture_places_r16.s

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
        .set quad_2,2; .set quad1_2,23; .set quad2_2,24; .set quad3_2,25; .set quad_3,26
        .set quad1_3,27; .set quad2_3,28; .set quad3_3,29; .set low_2,34; .set high_2,36
        .set low_3,37; .set high_3,38; .set low_4,39; .set high_4,40; .set low_5,19; .set high_5,20
        .set low_6,2; .set high_6,21; .set height_2,22; .set level_2,23; .set m_wrap_2,24
        .set levels_2,25; .set column_2,29; .set quad1_4,30; .set quad2_4,34; .set m_wrap_3,38
        .set quad3_4,40; .set quad_4,25; .set quad1_5,42; .set quad2_5,46; .set quad3_5,50
        .set row_2,51; .set dz_2,52; .set low_7,26; .set high_7,24; .set column_3,30
        .set quad_5,34; .set quad1_6,38; .set quad2_6,31; .set low_8,25; .set row_3,42
        .set high_8,46; .set texture_2,29; .set row_4,47; .set au_2,27; .set bu_2,19; .set low_9,20
        .set bv_2,2; .set breadth_2,19; .set quad_6,20; .set quad1_7,21; .set quad2_7,22
        .set quad3_6,23; .set quad_7,15; .set quad1_8,16; .set quad2_8,17; .set quad3_7,18
        .set low_10,15; .set t_y_2,16; .set low_11,17; .set quad_8,18; .set low_12,18
        .set high_9,16; .set m_wrap_4,2; .set m_wrap_5,15; .set m_wrap_6,16; .set whole_2,17
        .set floor_2,18; .set inside_2,18; .set whole_3,2; .set turned_2,17; .set c_above_2,15
        ila     $low,0x10203                            # 0e
        lqa     $m_xy,transpose                         # 0o
        ilhu    $k_half,0x3f00                          # 1e
        lqa     $m_zw,transpose+16                      # 1o
        ilhu    $k_one,0x3f80                           # 2e
        lqa     $m_first,transpose+32                   # 2o
        ilhu    $k_sign,0x8000                          # 3e
        lqa     $m_second,transpose+48                  # 3o
        il      $rows,-4                                # 4e
        shufb   $angle,$angle,$angle,$low               # 4o
next_row:
        ai      $rows,$rows,1                           # 0e
        lqd     $patch,448($a_rays)                     # 0o
        lqd     $last,64($a_surfaces)                   # 1o
        lqd     $texels,128($a_surfaces)                # 2o
        lqd     $c_level,512($a_surfaces)               # 3o
        lqd     $levels,0($a_surfaces)                  # 4o
        lqd     $wraps,384($a_surfaces)                 # 5o
        rotqbyi $patch+1,$patch,4                       # 6o
        rotqbyi $patch+2,$patch,8                       # 7o
        rotqbyi $patch+3,$patch,12                      # 8o
        lqd     $quad,64($patch)                        # 9o
        lqd     $quad+1,64($patch+1)                    # 10o
        lqd     $quad+2,64($patch+2)                    # 11o
        lqd     $quad+3,64($patch+3)                    # 12o
        lqd     $quad_2,80($patch)                      # 13o
        lqd     $quad1_2,80($patch+1)                   # 14o
        lqd     $quad2_2,80($patch+2)                   # 15o
        lqd     $quad3_2,80($patch+3)                   # 16o
        lqd     $quad_3,48($patch)                      # 17o
        lqd     $quad1_3,48($patch+1)                   # 18o
        lqd     $quad2_3,48($patch+2)                   # 19o
        lqd     $quad3_3,48($patch+3)                   # 20o
        shufb   $low_2,$quad,$quad+1,$m_xy              # 21o
        shufb   $high_2,$quad+2,$quad+3,$m_xy           # 22o
        shufb   $low_3,$quad_2,$quad1_2,$m_xy           # 23o
        shufb   $high_3,$quad2_2,$quad3_2,$m_xy         # 24o
        shufb   $low_4,$quad_3,$quad1_3,$m_xy           # 25o
        shufb   $whole,$low_2,$high_2,$m_second         # 26o
        shufb   $high_4,$quad2_3,$quad3_3,$m_xy         # 27o
        shufb   $inside,$low_3,$high_3,$m_second        # 28o
        nop     $127                                    # 29e pairing
        shufb   $low_5,$quad,$quad+1,$m_zw              # 29o
        fs      $whole,$whole,$last                     # 30e
        shufb   $high_5,$quad+2,$quad+3,$m_zw           # 30o
        nop     $127                                    # 31e pairing
        shufb   $low_6,$quad_2,$quad1_2,$m_zw           # 31o
        fs      $inside,$inside,$last                   # 32e
        shufb   $high_6,$quad2_2,$quad3_2,$m_zw         # 32o
        shufb   $height_2,$low_4,$high_4,$m_second      # 33o
        shufb   $floor,$low_5,$high_5,$m_first          # 34o
        nop     $127                                    # 35e pairing
        shufb   $low,$quad_3,$quad1_3,$m_zw             # 35o
        fm      $m_wrap,$c_level,$whole                 # 36e
        shufb   $turned,$low_6,$high_6,$m_first         # 36o
        fs      $height_2,$height_2,$last               # 37e
        shufb   $high,$quad2_3,$quad3_3,$m_zw           # 37o
        fs      $floor,$floor,$texels                   # 38e
        lqd     $level_2,448($a_surfaces)               # 38o
        fm      $m_wrap_2,$c_level,$inside              # 39e
        shufb   $width,$low_4,$high_4,$m_first          # 39o
        fs      $turned,$turned,$texels                 # 40e
        shufb   $first,$low_2,$high_2,$m_first          # 40o
        shufb   $across,$low,$high,$m_first             # 41o
        shufb   $c_above,$low_3,$high_3,$m_first        # 42o
        fs      $width,$width,$levels                   # 43e
        lqd     $levels_2,0($a_rays)                    # 43o
        fs      $first,$first,$levels                   # 44e
        lqd     $last,64($a_rays)                       # 44o
        fs      $across,$across,$texels                 # 45e
        lqd     $texels,128($a_rays)                    # 45o
        fs      $c_above,$c_above,$levels               # 46e
        lqd     $dx,192($a_rays)                        # 46o
        fm      $column,$wraps,$floor                   # 47e
        lqd     $dy,256($a_rays)                        # 47o
        fms     $m_wrap,$level_2,$floor,$m_wrap         # 48e
        lqd     $quad_3,96($patch)                      # 48o
        fm      $column_2,$wraps,$turned                # 49e
        lqd     $quad1_4,96($patch+1)                   # 49o
        fms     $m_wrap_2,$level_2,$turned,$m_wrap_2    # 50e
        lqd     $quad2_4,96($patch+2)                   # 50o
        fm      $m_wrap_3,$c_level,$height_2            # 51e
        lqd     $quad3_4,96($patch+3)                   # 51o
        fm      $breadth,$levels_2,$levels_2            # 52e
        lqd     $quad_4,128($patch)                     # 52o
        fm      $row,$level_2,$first                    # 53e
        lqd     $quad1_5,128($patch+1)                  # 53o
        fms     $column,$c_level,$first,$column         # 54e
        lqd     $quad2_5,128($patch+2)                  # 54o
        fm      $tile,$m_wrap,$c_above                  # 55e
        lqd     $quad3_5,128($patch+3)                  # 55o
        fm      $row_2,$level_2,$c_above                # 56e
        lqd     $dz_2,320($a_rays)                      # 56o
        fms     $column_2,$c_level,$c_above,$column_2   # 57e
        shufb   $low_7,$quad_3,$quad1_4,$m_zw           # 57o
        fm      $place,$m_wrap_2,$width                 # 58e
        shufb   $high_7,$quad2_4,$quad3_4,$m_zw         # 58o
        fm      $column_3,$wraps,$across                # 59e
        lqd     $quad_5,112($patch)                     # 59o
        fms     $m_wrap,$level_2,$across,$m_wrap_3      # 60e
        lqd     $quad1_6,112($patch+1)                  # 60o
        fma     $breadth,$last,$last,$breadth           # 61e
        lqd     $quad2_6,112($patch+2)                  # 61o
        fms     $row,$wraps,$whole,$row                 # 62e
        lqd     $quad3_4,112($patch+3)                  # 62o
        fma     $tile,$column,$inside,$tile             # 63e
        shufb   $low_8,$quad_4,$quad1_5,$m_zw           # 63o
        fms     $row_3,$wraps,$inside,$row_2            # 64e
        shufb   $high_8,$quad2_5,$quad3_5,$m_zw         # 64o
        fma     $place,$column_2,$height_2,$place       # 65e
        lqd     $texture_2,0x600($a_surfaces)           # 65o
        fm      $row_4,$level_2,$width                  # 66e
        shufb   $au_2,$low,$high,$m_second              # 66o
        fms     $column,$c_level,$width,$column_3       # 67e
        shufb   $bu_2,$low_5,$high_5,$m_second          # 67o
        fm      $share_c,$m_wrap,$first                 # 68e
        shufb   $av,$low_7,$high_7,$m_second            # 68o
        fma     $breadth,$texels,$texels,$breadth       # 69e
        shufb   $cv,$low_8,$high_8,$m_second            # 69o
        fma     $tile,$row,$turned,$tile                # 70e
        shufb   $low_9,$quad_5,$quad1_6,$m_zw           # 70o
        fma     $place,$row_3,$across,$place            # 71e
        shufb   $high,$quad2_6,$quad3_4,$m_zw           # 71o
        fms     $row,$wraps,$height_2,$row_4            # 72e
        rotqbyi $texture+1,$texture_2,4                 # 72o
        fm      $cosine,$wraps,$dx                      # 73e
        rotqbyi $texture+2,$texture_2,8                 # 73o
        fma     $share_c,$column,$whole,$share_c        # 74e
        rotqbyi $texture+3,$texture_2,12                # 74o
        fs      $bu,$bu_2,$au_2                         # 75e
        frsqest $t_y,$breadth                           # 75o
        fs      $cv,$cv,$av                             # 76e
        shufb   $cu,$low_6,$high_6,$m_second            # 76o
        fa      $tile,$tile,$place                      # 77e
        shufb   $bv_2,$low_9,$high,$m_second            # 77o
        ai      $a_surfaces,$a_surfaces,16              # 78e
        lqd     $breadth_2,384($a_rays)                 # 78o
        fi      $t_y,$breadth,$t_y                      # 79e
        lqd     $quad_6,80($texture_2)                  # 79o
        ai      $a_rays,$a_rays,16                      # 80e
        lqd     $quad1_7,80($texture+1)                 # 80o
        fma     $share_c,$row,$floor,$share_c           # 81e
        lqd     $quad2_7,80($texture+2)                 # 81o
        fma     $cosine,$level_2,$dy,$cosine            # 82e
        lqd     $quad3_6,80($texture+3)                 # 82o
        fs      $cu,$cu,$au_2                           # 83e
        lqd     $quad_7,32($patch)                      # 83o
        fs      $bv_2,$bv_2,$av                         # 84e
        lqd     $quad1_8,32($patch+1)                   # 84o
        fm      $area,$bu,$cv                           # 85e
        lqd     $quad2_8,32($patch+2)                   # 85o
        fm      $t_e,$breadth,$t_y                      # 86e
        shufb   $low_9,$quad_6,$quad1_7,$m_xy           # 86o
        fa      $tile,$tile,$share_c                    # 87e
        lqd     $quad3_7,32($patch+3)                   # 87o
        fm      $t_y,$t_y,$k_half                       # 88e
        shufb   $high,$quad2_7,$quad3_6,$m_xy           # 88o
        fma     $cosine,$c_level,$dz_2,$cosine          # 89e
        shufb   $low_10,$quad_7,$quad1_8,$m_zw          # 90o
        fnms    $area,$cu,$bv_2,$area                   # 91e
        lnop                                            # 91o pairing
        fnms    $far,$t_e,$t_e,$breadth                 # 92e
        shufb   $texture,$low_9,$high,$m_second         # 92o
        frest   $t_y_2,$tile                            # 93o
        shufb   $high,$quad2_8,$quad3_7,$m_zw           # 94o
        fm      $cosine,$cosine,$cosine                 # 95e
        lnop                                            # 95o pairing
        ceqi    $low_11,$texture,0                      # 96e
        rotqbyi $texture+1,$texture,4                   # 96o
        fi      $t_y_2,$tile,$t_y_2                     # 97e
        rotqbyi $texture+2,$texture,8                   # 97o
        nop     $127                                    # 98e pairing
        rotqbyi $texture+3,$texture,12                  # 98o
        fma     $far,$far,$t_y,$t_e                     # 99e
        lqd     $quad_8,0($texture)                     # 99o
        lqd     $quad+1,0($texture+1)                   # 100o
        frest   $t_y,$cosine                            # 101o
        lqd     $quad+2,0($texture+2)                   # 102o
        lqd     $quad+3,0($texture+3)                   # 103o
        fnms    $t_e,$tile,$t_y_2,$k_one                # 104e
        shufb   $textured,$low_10,$high,$m_second       # 104o
        fa      $far,$far,$breadth_2                    # 105e
        lnop                                            # 105o pairing
        fi      $t_y,$cosine,$t_y                       # 106e
        shufb   $low_10,$quad_8,$quad+1,$m_zw           # 106o
        shufb   $low_12,$quad_8,$quad+1,$m_xy           # 107o
        shli    $textured,$textured,3                   # 108e SIDES_TEXTURED becomes the sign
        nop     $127                                    # 109e pairing
        shufb   $high,$quad+2,$quad+3,$m_zw             # 109o
        fma     $inverse,$t_e,$t_y_2,$t_y_2             # 110e
        shufb   $high_9,$quad+2,$quad+3,$m_xy           # 110o
        fm      $far,$far,$angle                        # 111e
        rotmai  $textured,$textured,-31                 # 112e
        fnms    $t_e,$cosine,$t_y,$k_one                # 113e
        shufb   $texels,$low_10,$high,$m_first          # 113o
        shufb   $last,$low_12,$high_9,$m_second         # 114o
        shufb   $wraps,$low_10,$high,$m_second          # 115o
        fm      $place,$place,$inverse                  # 116e
        shufb   $levels,$low_12,$high_9,$m_first        # 116o
        fm      $area,$area,$inverse                    # 117e
        fm      $far,$far,$far                          # 118e
        fm      $share_c,$share_c,$inverse              # 119e
        fma     $steep,$t_e,$t_y,$t_y                   # 120e
        shli    $m_wrap,$wraps,31                       # 121e
        fma     $v,$place,$bv_2,$av                     # 122e
        andc    $area,$area,$k_sign                     # 123e
        fma     $u,$place,$bu,$au_2                     # 124e
        fm      $breadth,$far,$area                     # 125e
        shli    $m_wrap_4,$wraps,29                     # 126e
        shli    $m_wrap_5,$wraps,30                     # 127e
        fma     $v,$share_c,$cv,$v                      # 128e
        shli    $m_wrap_6,$wraps,28                     # 129e
        fma     $u,$share_c,$cu,$u                      # 130e
        fm      $breadth,$breadth,$steep                # 131e
        rotmai  $m_wrap_5,$m_wrap_5,-31                 # 132e
        rotmai  $m_wrap_6,$m_wrap_6,-31                 # 133e
        cflts   $whole,$v,0                             # 134e
        andc    $textured,$textured,$low_11             # 135e
        cflts   $whole_2,$u,0                           # 136e
        fm      $breadth,$breadth,$texels               # 138e
        csflt   $floor,$whole,0                         # 141e
        csflt   $floor_2,$whole_2,0                     # 143e
        rotmi   $level,$breadth,-23                     # 144e
        ai      $level,$level,-126                      # 148e the exponent of 2 f^2
        fcgt    $c_above,$floor,$v                      # 149e
        rotmai  $level,$level,-1                        # 150e
        a       $whole,$whole,$c_above                  # 151e
        fcgt    $c_above,$floor_2,$u                    # 152e
        csflt   $floor,$whole,0                         # 153e
        cgti    $c_level,$level,-1                      # 154e
        a       $whole_2,$whole_2,$c_above              # 155e
        and     $level,$level,$c_level                  # 156e
        csflt   $floor_2,$whole_2,0                     # 157e
        cgt     $c_level,$level,$last                   # 158e
        shli    $whole,$whole,31                        # 159e
        selb    $level,$level,$last,$c_level            # 160e
        fs      $inside,$v,$floor                       # 161e
        shli    $level,$level,4                         # 162e
        shli    $whole_2,$whole_2,31                    # 163e
        fs      $inside_2,$u,$floor_2                   # 164e
        and     $whole,$whole,$m_wrap                   # 165e
        a       $texture,$levels,$level                 # 166e
        fs      $turned,$k_one,$inside                  # 167e
        rotmai  $whole,$whole,-31                       # 168e
        rotqbyi $texture+1,$texture,4                   # 168o
        and     $whole_3,$whole_2,$m_wrap_4             # 169e
        rotqbyi $texture+2,$texture,8                   # 169o
        fs      $turned_2,$k_one,$inside_2              # 170e
        rotqbyi $texture+3,$texture,12                  # 170o
        rotmai  $whole_3,$whole_3,-31                   # 171e
        lqd     $quad,0($texture)                       # 171o
        nop     $127                                    # 172e pairing
        lqd     $quad+1,0($texture+1)                   # 172o
        selb    $inside,$inside,$turned,$whole          # 173e
        lqd     $quad+2,0($texture+2)                   # 173o
        nop     $127                                    # 174e pairing
        lqd     $quad+3,0($texture+3)                   # 174o
        selb    $v,$v,$inside,$m_wrap_5                 # 175e
        hbrr    next_row_back,next_row                  # 175o hint
        selb    $inside,$inside_2,$turned_2,$whole_3    # 176e
        rotmai  $c_above,$v,-31                         # 177e
        selb    $u,$u,$inside,$m_wrap_6                 # 178e
        shufb   $low,$quad,$quad+1,$m_xy                # 178o
        nop     $127                                    # 179e pairing
        shufb   $low_6,$quad,$quad+1,$m_zw              # 179o
        rotmai  $c_above_2,$u,-31                       # 180e
        shufb   $high,$quad+2,$quad+3,$m_xy             # 180o
        andc    $v,$v,$c_above                          # 181e
        shufb   $high_9,$quad+2,$quad+3,$m_zw           # 181o
        fcgt    $c_above,$v,$k_one                      # 183e
        lnop                                            # 183o pairing
        andc    $u,$u,$c_above_2                        # 184e
        shufb   $height,$low,$high,$m_second            # 184o
        selb    $v,$v,$k_one,$c_above                   # 185e
        shufb   $width,$low,$high,$m_first              # 185o
        fcgt    $c_above,$u,$k_one                      # 186e
        shufb   $across,$low_6,$high_9,$m_first         # 186o
        shufb   $first,$low_6,$high_9,$m_second         # 187o
        fma     $v,$v,$height,$k_half                   # 188e
        selb    $u,$u,$k_one,$c_above                   # 189e
        fma     $u,$u,$width,$k_half                    # 191e
        cflts   $row,$v,0                               # 194e
        cflts   $column,$u,0                            # 197e
        rotmi   $whole,$row,-3                          # 201e
        csflt   $turned,$row,0                          # 202e
        andi    $row,$row,7                             # 203e
        csflt   $inside,$column,0                       # 204e
        mpyu    $whole,$whole,$across                   # 205e
        rotmi   $tile,$column,-3                        # 206e
        mpyi    $row,$row,36                            # 207e
        andi    $column,$column,7                       # 208e
        fs      $v,$v,$turned                           # 209e
        shli    $column,$column,2                       # 210e
        fs      $u,$u,$inside                           # 211e
        a       $tile,$tile,$whole                      # 212e
        a       $tile,$tile,$first                      # 214e
        lnop                                            # 214o pairing
        a       $place,$column,$row                     # 215e
        stqd    $v,192($a_texels)                       # 215o
        orc     $tile,$tile,$textured                   # 216e
        stqd    $u,128($a_texels)                       # 217o
        stqd    $tile,0($a_texels)                      # 218o
        stqd    $place,64($a_texels)                    # 219o
        ai      $a_texels,$a_texels,16                  # 220e
next_row_back:
        brnz    $rows,next_row                          # 220o
        nop     $127                                    # 221e pairing
        bi      $lr                                     # 221o
endfunction texture_places_r16
