# shader_sky   a gradient from the horizon to the zenith, for what rays see that hit nothing
#   C       void shader_sky(struct surfaces *, const struct rays16 *, const vec_uint4 *mask,
#                           const struct material *, const struct shading *);
#   In      $3 surfaces, $4 rays, $5 four quadwords of lanes to shade, $6 material, $7 shading;
#           pointers 16-aligned
#   Out     lit colours
#   Uses    $3-$28   Saves  -   Stack  0   Calls  -
#   Domain  any
#   Error   3 ulp of 1, each channel, of colours up to 1
#   Twin    lab/twins/src/shader.rs
#
#   lit += max(direction . up, 0) (colour - lit), where up is the first three parameters
# The background's material sends the colour at the horizon and has the zenith's as its own.

        .include "work_unit.inc"
        .include "macros.inc"
        .include "shader.inc"

        .set    NEXT,3
        registers a_surfaces,a_rays,a_mask,a_material
        # constants
        .set    NEXT,10
        registers k_zero,m_word,parameters,up_x,up_y,up_z
        # a row
        registers mask,height,along_x,along_y,along_z,c_above
        registers red,green,blue,lit_red,lit_green,lit_blue

        shader_entry sky

function shader_sky
        lqd     $parameters,MATERIAL_parameters($a_material)
        splat_mask $m_word
        splat   $up_x,$parameters,$m_word
        load_constant $m_word,0x04050607
        splat   $up_y,$parameters,$m_word
        load_constant $m_word,0x08090a0b
        splat   $up_z,$parameters,$m_word
        il      $k_zero,0
    .irp row, 0,1,2,3
        lqd     $along_x,RAYS16_direction_x+16*\row($a_rays)
        lqd     $along_y,RAYS16_direction_y+16*\row($a_rays)
        lqd     $along_z,RAYS16_direction_z+16*\row($a_rays)
        fm      $height,$along_x,$up_x
        fma     $height,$along_y,$up_y,$height
        fma     $height,$along_z,$up_z,$height
        fcgt    $c_above,$height,$k_zero
        and     $height,$height,$c_above
        lqd     $mask,16*\row($a_mask)
        .irp    channel, red,green,blue
        lqd     $\channel,SURFACES_\channel+16*\row($a_surfaces)
        lqd     $lit_\channel,SURFACES_lit_\channel+16*\row($a_surfaces)
        fs      $\channel,$\channel,$lit_\channel
        fma     $\channel,$height,$\channel,$lit_\channel
        selb    $lit_\channel,$lit_\channel,$\channel,$mask
        stqd    $lit_\channel,SURFACES_lit_\channel+16*\row($a_surfaces)
        .endr
    .endr
        bi      $lr
endfunction shader_sky
