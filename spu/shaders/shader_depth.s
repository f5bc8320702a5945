# shader_depth   the material's colour alone, which fades to black with the distance
#   C       void shader_depth(struct surfaces *, const struct rays16 *, const vec_uint4 *mask,
#                             const struct material *, const struct shading *);
#   In      $3 surfaces, $4 rays, $5 four quadwords of lanes to shade, $6 material, $7 shading;
#           pointers 16-aligned
#   Out     lit colours; no share of light, mirror or transmittance is left
#   Uses    $10-$21   Saves  -   Stack  0   Calls  -
#   Domain  any
#   Error   2 ulp of 1, each channel of a colour up to 1
#   Twin    lab/twins/src/shader.rs
#
#   lit = colour clamp((far - t) scale, 0, 1), where far and scale are the first two parameters

        .include "work_unit.inc"
        .include "macros.inc"
        .include "shader.inc"

        .set    NEXT,3
        registers a_surfaces,a_rays,a_mask,a_material
        # constants
        .set    NEXT,10
        registers k_zero,k_one,k_far,k_scale,m_second,parameters
        # a row
        registers mask,bright,c_over,colour,lit,part

        shader_entry depth

function shader_depth
        lqd     $parameters,MATERIAL_parameters($a_material)
        splat_mask $m_second
        splat   $k_far,$parameters,$m_second
        load_constant $m_second,0x04050607
        splat   $k_scale,$parameters,$m_second
        il      $k_zero,0
        ilhu    $k_one,0x3f80
    .irp row, 0,1,2,3
        lqd     $mask,16*\row($a_mask)
        lqd     $bright,RAYS16_t+16*\row($a_rays)
        fs      $bright,$k_far,$bright
        fm      $bright,$bright,$k_scale
        fcgt    $c_over,$k_zero,$bright
        selb    $bright,$bright,$k_zero,$c_over
        fcgt    $c_over,$bright,$k_one
        selb    $bright,$bright,$k_one,$c_over
        .irp    channel, red,green,blue
        lqd     $colour,SURFACES_\channel+16*\row($a_surfaces)
        lqd     $lit,SURFACES_lit_\channel+16*\row($a_surfaces)
        fm      $colour,$colour,$bright
        selb    $lit,$lit,$colour,$mask
        stqd    $lit,SURFACES_lit_\channel+16*\row($a_surfaces)
        .endr
        .irp    share, diffuse,highlight,mirror,transmittance
        lqd     $part,SURFACES_\share+16*\row($a_surfaces)
        andc    $part,$part,$mask
        stqd    $part,SURFACES_\share+16*\row($a_surfaces)
        .endr
    .endr
        bi      $lr
endfunction shader_depth
