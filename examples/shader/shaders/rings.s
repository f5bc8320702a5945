# shader_rings   rings of two colours around the scene's y axis, as of a log that was cut
#   C       void shader_rings(struct surfaces *, const struct rays16 *, const vec_uint4 *mask,
#                             const struct material *, const struct shading *);
#   In      $3 surfaces, $4 rays, $5 four quadwords of lanes to shade, $6 material, $7 shading
#   Out     the lanes' colours: between the material's and that of the first three parameters
#   Uses    $10-$31   Saves  -   Stack  0   Calls  -
#
#   w = r s, r the distance from the axis and s the fourth parameter, rings a unit
#   part = (2 (w - floor(w)) - 1)^2, 1 where a ring begins and 0 in its middle
#   colour = colour + part (other - colour)

        .include "work_unit.inc"
        .include "macros.inc"
        .include "math.inc"
        .include "shader.inc"

        .set    a_surfaces,3
        .set    a_mask,5
        .set    a_material,6
        .set    a_shading,7
        .set    k_half,10
        .set    k_one,11
        .set    m_word,12
        .set    parameters,13
        .set    eye,14
        .set    red,15
        .set    green,16
        .set    blue,17
        .set    scale,18
        .set    eye_x,19
        .set    eye_z,20
        .set    x,21
        .set    z,22
        .set    square,23
        .set    radius,24
        .set    t_y,25
        .set    t_s,26
        .set    whole,27
        .set    part,28
        .set    mask,29
        .set    colour,30
        .set    mixed,31

shader rings
        lqd     $parameters,MATERIAL_parameters($a_material)
        lqd     $eye,SHADING_eye($a_shading)
        splat_mask $m_word
        splat   $red,$parameters,$m_word
        splat   $eye_x,$eye,$m_word
        load_constant $m_word,0x04050607
        splat   $green,$parameters,$m_word
        load_constant $m_word,0x08090a0b
        splat   $blue,$parameters,$m_word
        splat   $eye_z,$eye,$m_word
        load_constant $m_word,0x0c0d0e0f
        splat   $scale,$parameters,$m_word
        ilhu    $k_half,0x3f00
        ilhu    $k_one,0x3f80
    .irp row, 0,1,2,3
        lqd     $x,SURFACES_point_x+16*\row($a_surfaces)
        lqd     $z,SURFACES_point_z+16*\row($a_surfaces)
        fa      $x,$x,$eye_x
        fa      $z,$z,$eye_z
        fm      $square,$x,$x
        fma     $square,$z,$z,$square
        sqrt_f4 $radius,$square,$t_y,$t_s,$k_half
        fm      $radius,$radius,$scale                  # w
        cflts   $whole,$radius,0
        csflt   $whole,$whole,0
        fs      $part,$radius,$whole
        fa      $part,$part,$part
        fs      $part,$part,$k_one
        fm      $part,$part,$part
        lqd     $mask,16*\row($a_mask)
        .irp    channel, red,green,blue
        lqd     $colour,SURFACES_\channel+16*\row($a_surfaces)
        fs      $mixed,$\channel,$colour
        fma     $mixed,$mixed,$part,$colour
        selb    $colour,$colour,$mixed,$mask
        stqd    $colour,SURFACES_\channel+16*\row($a_surfaces)
        .endr
    .endr
        bi      $lr
endshader rings
