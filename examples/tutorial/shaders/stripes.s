# shader_stripes   soft stripes across the scene's y axis, as of a planet's clouds
#   C       void shader_stripes(struct surfaces *, const struct rays16 *, const vec_uint4 *mask,
#                               const struct material *, const struct shading *);
#   In      $3 surfaces, $4 rays, $5 four quadwords of lanes to shade, $6 material, $7 shading
#   Out     the lanes' colours, less in the stripes
#   Uses    $10-$21   Saves  -   Stack  0   Calls  -
#   Domain  s times y within -2^22 and 2^22
#
#   w = s y, s the first parameter: stripes a unit
#   f = w - trunc(w), g = f^2, part = strength (g - g^2): 0 where a stripe begins, at most 1/4
#   red loses part of itself, green 2 part, blue 4 part

        .include "work_unit.inc"
        .include "macros.inc"
        .include "shader.inc"

        .set    a_surfaces,3
        .set    a_mask,5
        .set    a_material,6
        .set    a_shading,7
        .set    m_word,10
        .set    scale,11
        .set    strength,12
        .set    eye_y,13
        .set    mask,14
        .set    place,15                                # y, then w
        .set    whole,16
        .set    within,17                               # f
        .set    square,18                               # g
        .set    part,19
        .set    colour,20
        .set    striped,21

        shader_entry stripes

function shader_stripes
        lqd     $scale,MATERIAL_parameters($a_material)
        lqd     $eye_y,SHADING_eye($a_shading)
        splat_mask $m_word
        rotqbyi $strength,$scale,4
        rotqbyi $eye_y,$eye_y,4
        splat   $scale,$scale,$m_word
        splat   $strength,$strength,$m_word
        splat   $eye_y,$eye_y,$m_word
    .irp row, 0,1,2,3
        lqd     $place,SURFACES_point_y+16*\row($a_surfaces)
        lqd     $mask,16*\row($a_mask)
        fa      $place,$place,$eye_y
        fm      $place,$place,$scale
        cflts   $whole,$place,0
        csflt   $whole,$whole,0
        fs      $within,$place,$whole
        fm      $square,$within,$within
        fnms    $part,$square,$square,$square           # g - g^2
        fm      $part,$part,$strength
        .irp    channel, red,green,blue
        lqd     $colour,SURFACES_\channel+16*\row($a_surfaces)
        fnms    $striped,$part,$colour,$colour
        fa      $part,$part,$part
        selb    $colour,$colour,$striped,$mask
        stqd    $colour,SURFACES_\channel+16*\row($a_surfaces)
        .endr
    .endr
        bi      $lr
endfunction shader_stripes
