# shader_checker   cubes of two colours in turn, in the scene's coordinates
#   C       void shader_checker(struct surfaces *, const struct rays16 *, const vec_uint4 *mask,
#                               const struct material *, const struct shading *);
#   In      $3 surfaces, $4 rays, $5 four quadwords of lanes to shade, $6 material, $7 shading;
#           pointers 16-aligned
#   Out     the colours of lanes in odd cubes
#   Uses    $10-$27   Saves  -   Stack  0   Calls  -
#   Domain  s times a coordinate within -2^22 and 2^22
#   Error   none but where a point is within its own error of a cube's side
#   Twin    lab/twins/src/shader.rs
#
# A point is in an odd cube if floor(s x + 1/1024) + floor(s y + 1/1024) + floor(s z + 1/1024) is
# odd, where s is the fourth parameter. Its colour is then that of the first three parameters.
# Because of the 1/1024, a plane on a side of the cubes, at a multiple of 1/s, is in one layer of
# cubes, and rounding does not split it between two.

        .include "work_unit.inc"
        .include "macros.inc"
        .include "shader.inc"

        .set    a_surfaces,3
        .set    NEXT,5
        registers a_mask,a_material,a_shading
        # constants
        .set    NEXT,10
        registers k_within,m_word,parameters,eye,red,green,blue,scale,eye_x,eye_y,eye_z
        # a row
        registers place,cell,whole,c_above,cells,odd,colour

        shader_entry checker

function shader_checker
        lqd     $parameters,MATERIAL_parameters($a_material)
        lqd     $eye,SHADING_eye($a_shading)
        splat_mask $m_word
        splat   $red,$parameters,$m_word
        splat   $eye_x,$eye,$m_word
        load_constant $m_word,0x04050607
        splat   $green,$parameters,$m_word
        splat   $eye_y,$eye,$m_word
        load_constant $m_word,0x08090a0b
        splat   $blue,$parameters,$m_word
        splat   $eye_z,$eye,$m_word
        load_constant $m_word,0x0c0d0e0f
        splat   $scale,$parameters,$m_word
        ilhu    $k_within,0x3a80                        # 1/1024
    .irp row, 0,1,2,3
        il      $cells,0
        .irp    axis, x,y,z
        lqd     $place,SURFACES_point_\axis+16*\row($a_surfaces)
        fa      $place,$place,$eye_\axis
        fma     $place,$place,$scale,$k_within
        cflts   $cell,$place,0
        csflt   $whole,$cell,0
        fcgt    $c_above,$whole,$place                  # below 0, towards 0 is upwards
        a       $cells,$cells,$cell
        a       $cells,$cells,$c_above                  # true is -1
        .endr
        lqd     $odd,16*\row($a_mask)
        andi    $cells,$cells,1
        ceqi    $cells,$cells,1
        and     $odd,$odd,$cells
        .irp    channel, red,green,blue
        lqd     $colour,SURFACES_\channel+16*\row($a_surfaces)
        selb    $colour,$colour,$\channel,$odd
        stqd    $colour,SURFACES_\channel+16*\row($a_surfaces)
        .endr
    .endr
        bi      $lr
endfunction shader_checker
