# The planes around a tile, which all go through the eye.
#
# The direction through a pixel is D(x, y) = corner + x right + y down. So the plane of column x0
# has the normal D(x0, .) x down = corner x down + x0 (right x down), and the plane of row y0 has
# the normal corner x right - y0 (right x down). That is one product and one sum for each tile. The
# inner side depends on the camera's handedness, the sign of V = (corner x down).right: the product
# of the normal of column x0 with D(x, y) is V (x - x0), and that of row y0 is -V (y - y0).

        .include "work_unit.inc"
        .include "macros.inc"
        .include "math.inc"
        .include "driver.inc"

        .section .bss
        .align  4
        # x, y, z in a quadword each, with the lanes left, right, top, bottom
plane_base:
        .skip   48
plane_step:
        .skip   48
        .global frustum
frustum:
        .skip   FRUSTUM_SIZE

        quadword_constants
yzx:    .int    0x04050607,0x08090a0b,0x00010203,0x0c0d0e0f
zxy:    .int    0x08090a0b,0x00010203,0x04050607,0x0c0d0e0f
        # words of two quadwords A and B
aabb:   .int    0x00010203,0x00010203,0x10111213,0x10111213
abab:   .int    0x00010203,0x10111213,0x00010203,0x10111213
base_signs:
        .int    0,0x80000000,0x80000000,0
step_signs:
        .int    0,0x80000000,0,0x80000000
edges:  .float  -0.5,0.5,-0.5,0.5                       # from a pixel's centre

        .set    a_frame,10
        .set    corner,11
        .set    right,12
        .set    down,13
        .set    m_yzx,14
        .set    m_zxy,15
        .set    column,16                               # corner x down
        .set    row,17                                  # corner x right
        .set    both,18                                 # right x down
        .set    sign,19
        .set    m_aabb,20
        .set    m_splat,21
        .set    base_sign,22
        .set    step_sign,23
        .set    base,24
        .set    step,25
        .set    t_1,26
        .set    t_2,27

.macro  cross out:req, a:req, b:req
        shufb   \out,\a,\a,$m_zxy
        shufb   $t_1,\b,\b,$m_yzx
        fm      \out,\out,$t_1
        shufb   $t_1,\a,\a,$m_yzx
        shufb   $t_2,\b,\b,$m_zxy
        fms     \out,$t_1,$t_2,\out
.endm

# planes_prepare   prepares the products for all tiles of the frame
#   Uses    $10-$27
function planes_prepare
        ila     $a_frame,frame
        lqd     $corner,FRAME_corner($a_frame)
        lqd     $right,FRAME_right($a_frame)
        lqd     $down,FRAME_down($a_frame)
        lqa     $m_yzx,yzx
        lqa     $m_zxy,zxy
        lqa     $m_aabb,aabb
        lqa     $base_sign,base_signs
        lqa     $step_sign,step_signs
        splat_mask $m_splat
        cross   $column,$corner,$down
        cross   $row,$corner,$right
        cross   $both,$right,$down

        fm      $sign,$column,$right
        rotqbyi $t_1,$sign,4
        rotqbyi $t_2,$sign,8
        fa      $sign,$sign,$t_1
        fa      $sign,$sign,$t_2                        # V
        ilhu    $t_1,0x8000
        and     $sign,$sign,$t_1
        splat   $sign,$sign,$m_splat
        xor     $base_sign,$base_sign,$sign
        xor     $step_sign,$step_sign,$sign
    .irp axis, 0,4,8
        rotqbyi $base,$column,\axis
        rotqbyi $t_1,$row,\axis
        shufb   $base,$base,$t_1,$m_aabb
        xor     $base,$base,$base_sign
        stqa    $base,plane_base+4*\axis
        rotqbyi $step,$both,\axis
        splat   $step,$step,$m_splat
        xor     $step,$step,$step_sign
        stqa    $step,plane_step+4*\axis
    .endr
        bi      $lr
endfunction planes_prepare

# tile_planes   makes the frustum of the current tile, to the outer edges of its pixels
#   Uses    $10-$27
        .set    at,10
        .set    last,11
        .set    m_abab,12
        .set    nx,13
        .set    ny,14
        .set    nz,15
        .set    length,16
        .set    inverse,17
        .set    k_half,18
        .set    k_one,19

function tile_planes
        lqa     $m_abab,abab
        a       $at,$g_tile_x,$g_tile_width
        ai      $at,$at,-1
        shufb   $at,$g_tile_x,$at,$m_abab
        a       $last,$g_tile_y,$g_tile_height
        ai      $last,$last,-1
        shufb   $last,$g_tile_y,$last,$m_abab
        fsmbi   $t_1,0x00ff
        selb    $at,$at,$last,$t_1                      # left, right, top, bottom pixel
        csflt   $at,$at,0
        lqa     $t_1,edges
        fa      $at,$at,$t_1
    .irp axis, x,y,z
        .ifc    \axis,x
        .set    offset,0
        .else
        .set    offset,offset+16
        .endif
        lqa     $base,plane_base+offset
        lqa     $step,plane_step+offset
        fma     $n\axis,$at,$step,$base
    .endr
        ilhu    $k_half,0x3f00
        ilhu    $k_one,0x3f80
        fm      $length,$nx,$nx
        fma     $length,$ny,$ny,$length
        fma     $length,$nz,$nz,$length                 # squared
        rsqrt_f4 $inverse,$length,$t_1,$t_2,$k_half,$k_one
        fm      $nx,$nx,$inverse
        fm      $ny,$ny,$inverse
        fm      $nz,$nz,$inverse
        stqa    $nx,frustum+FRUSTUM_normal_x
        stqa    $ny,frustum+FRUSTUM_normal_y
        stqa    $nz,frustum+FRUSTUM_normal_z
        bi      $lr
endfunction tile_planes
