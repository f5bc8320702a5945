# smooth_r16   normals that shade, of those of sixteen hits that are on patches
#   C       void smooth_r16(const struct ray_packet *, struct surfaces *);
#   In      $3 rays, $4 surfaces; pointers 16-aligned. A ray's hit is an address, of any
#           record
#   Out     surfaces: normal, where the object has SIDES_SMOOTH and so is a patch
#   Uses    $3-$4, $10-$62   Saves  -   Stack  0   Calls  -
#   Domain  points in their patches; edges from 2^-30 to 2^30, and from 1/100 of the points'
#           distance from the eye on; |plane| about 1, the patch's own normal, on the ray's side
#   Error   3e-7 of 1, for the point as it is given; vertices' normals within 60 degrees of the
#           plane's
#   Twin    lab/twins/src/smooth.rs
#
# For the point p, the vertices a, b, c relative to p, their normals and the plane's normal g:
#   n = (g x b).c normal_a + (g x c).a normal_b + (g x a).b normal_c
# The shares of the area change their signs with g, so n points to the same side as g, which is the
# ray's side. If it nevertheless points away from the ray, n.d >= 0, it is replaced by g. Otherwise
# it is normalised.
#
# The loop counts up, so that it isn't pipelined. Pipelined it would take 2 KB more of local store,
# and 0.1 % less time in a scene with many patches.

        .include "work_unit.inc"
        .include "macros.inc"
        .include "barycentric.inc"
        .include "math.inc"

        .set    NEXT,3
        registers a_rays,a_surfaces
        # constants
        .set    NEXT,10
        registers m_xy,m_zw,m_first,m_second,k_half,k_one,rows
        # the lanes' patches
        registers patch                                 # to 20
        .set    quad,21                                 # to 24
        .set    NEXT,25
        registers low,high,smooth
        # the row
        registers px,py,pz,gx,gy,gz,dx,dy,dz
        registers ax                                    # the vertices, then their normals
        registers ay,az,bx,by,bz,cx,cy,cz,turn_x,turn_y,turn_z,share_a,share_b,share_c,nx,ny,nz
        registers along,square,inverse,t_y,t_e,old_x,old_y,old_z

        .section .rodata
        .align  4
        .global transpose
transpose:
        transpose_shuffles

function smooth_r16
        lqa     $m_xy,transpose
        lqa     $m_zw,transpose+16
        lqa     $m_first,transpose+32
        lqa     $m_second,transpose+48
        ilhu    $k_half,0x3f00
        ilhu    $k_one,0x3f80
        il      $rows,-4
next_row:
        lqd     $patch,RAYS16_object($a_rays)
        rotqbyi $patch+1,$patch,4
        rotqbyi $patch+2,$patch,8
        rotqbyi $patch+3,$patch,12
    .irp lane, 0,1,2,3
        lqd     $quad+\lane,OBJECT_sides&~15($patch+\lane)
    .endr
        shufb   $low,$quad,$quad+1,$m_zw
        shufb   $high,$quad+2,$quad+3,$m_zw
        shufb   $smooth,$low,$high,$m_second
        shli    $smooth,$smooth,2                       # SIDES_SMOOTH becomes the sign
        rotmai  $smooth,$smooth,-31
    .irp axis, x,y,z
        lqd     $p\axis,SURFACES_point_\axis($a_surfaces)
        lqd     $g\axis,SURFACES_plane_\axis($a_surfaces)
        lqd     $d\axis,RAYS16_direction_\axis($a_rays)
    .endr
        gather  patch,TRI_a,$ax,$ay,$az
        gather  patch,TRI_b,$bx,$by,$bz
        gather  patch,TRI_c,$cx,$cy,$cz
    .irp axis, x,y,z
        fs      $a\axis,$a\axis,$p\axis
        fs      $b\axis,$b\axis,$p\axis
        fs      $c\axis,$c\axis,$p\axis
    .endr
        share_of_area $share_a,b,c
        share_of_area $share_b,c,a
        share_of_area $share_c,a,b
        gather  patch,PATCH_normal_a,$ax,$ay,$az
        gather  patch,PATCH_normal_b,$bx,$by,$bz
        gather  patch,PATCH_normal_c,$cx,$cy,$cz
    .irp axis, x,y,z
        fm      $n\axis,$share_a,$a\axis
        fma     $n\axis,$share_b,$b\axis,$n\axis
        fma     $n\axis,$share_c,$c\axis,$n\axis
    .endr
        fm      $along,$nx,$dx
        fma     $along,$ny,$dy,$along
        fma     $along,$nz,$dz,$along
        rotmai  $along,$along,-31
        fm      $square,$nx,$nx
        fma     $square,$ny,$ny,$square
        fma     $square,$nz,$nz,$square
        rsqrt_f4 $inverse,$square,$t_y,$t_e,$k_half,$k_one
    .irp axis, x,y,z
        fm      $n\axis,$n\axis,$inverse
        selb    $n\axis,$g\axis,$n\axis,$along
        lqd     $old_\axis,SURFACES_normal_\axis($a_surfaces)
        selb    $n\axis,$old_\axis,$n\axis,$smooth
        stqd    $n\axis,SURFACES_normal_\axis($a_surfaces)
    .endr
        ai      $a_rays,$a_rays,16
        ai      $a_surfaces,$a_surfaces,16
        ai      $rows,$rows,1
        brnz    $rows,next_row
        bi      $lr
endfunction smooth_r16
