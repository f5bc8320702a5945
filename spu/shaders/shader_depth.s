# shader_depth   the material's colour alone, which fades to black with the distance
#   C       void shader_depth(struct surfaces *, const struct rays16 *, const vec_uint4 *mask,
#                             const struct material *, const struct shading *);
#   In      $3 surfaces, $4 rays, $5 four quadwords of lanes to shade, $6 material, $7 shading;
#           pointers 16-aligned
#   Out     lit colours; no share of light, mirror or transmittance is left
#   Uses    $3-$5, $10-$22   Saves  -   Stack  0   Calls  -
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
        registers mask,bright,c_over,colour,lit,part,a_end

        shader_entry depth

function shader_depth
        lqd     $parameters,MATERIAL_parameters($a_material)
        splat_mask $m_second
        splat   $k_far,$parameters,$m_second
        load_constant $m_second,0x04050607
        splat   $k_scale,$parameters,$m_second
        il      $k_zero,0
        ai      $a_end,$a_mask,64
        ilhu    $k_one,0x3f80
next_row:
        lqd     $mask,0($a_mask)
        lqd     $bright,RAYS16_t($a_rays)
        fs      $bright,$k_far,$bright
        fm      $bright,$bright,$k_scale
        fcgt    $c_over,$k_zero,$bright
        selb    $bright,$bright,$k_zero,$c_over
        fcgt    $c_over,$bright,$k_one
        selb    $bright,$bright,$k_one,$c_over
    .irp channel, red,green,blue
        lqd     $colour,SURFACES_\channel($a_surfaces)
        lqd     $lit,SURFACES_lit_\channel($a_surfaces)
        fm      $colour,$colour,$bright
        selb    $lit,$lit,$colour,$mask
        stqd    $lit,SURFACES_lit_\channel($a_surfaces)
    .endr
    .irp share, diffuse,highlight,mirror,transmittance
        lqd     $part,SURFACES_\share($a_surfaces)
        andc    $part,$part,$mask
        stqd    $part,SURFACES_\share($a_surfaces)
    .endr
        ai      $a_surfaces,$a_surfaces,16
        ai      $a_rays,$a_rays,16
        ai      $a_mask,$a_mask,16
        ceq     $c_over,$a_mask,$a_end
        brz     $c_over,next_row
        bi      $lr
endfunction shader_depth
