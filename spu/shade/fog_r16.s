# fog_r16   what fog leaves of the light of surfaces, and adds to it
#   C       void fog_r16(struct surfaces *, const struct rays16 *, const vec_uint4 *mask,
#                        const float *fog);
#   In      $3 surfaces, $4 rays, $5 four quadwords of lanes that have hit something, $6 the density
#           times log2(e), red, green, blue; pointers 16-aligned
#   Out     lit colours, and shares of secondary rays
#   Uses    $3-$30   Saves  -   Stack  0   Calls  -
#   Domain  densities from 0 on
#   Error   0.0002 of colours up to 1
#   Twin    lab/twins/src/light.rs
#
#   lit = fog + e^(-density t) (lit - fog), and the shares are multiplied by the same power

        .include "work_unit.inc"
        .include "macros.inc"
        .include "exp2.inc"

        .set    NEXT,3
        registers a_surfaces,a_rays,a_mask,a_fog
        # constants
        .set    NEXT,10
        registers m_fraction,k_none,k_one,exponent,fog_red,fog_green,fog_blue
        .set    k_exp,NEXT
        .set    NEXT,NEXT+4
        # a row
        registers mask,n,whole,fraction,result,lit,t_e,changed
        .set    m_word,mask

function fog_r16
        ilhu    $k_one,0x3f80
        exp_constants
        lqd     $n,0($a_fog)
        splat_mask $m_word
        splat   $exponent,$n,$m_word
        load_constant $m_word,0x04050607
        splat   $fog_red,$n,$m_word
        load_constant $m_word,0x08090a0b
        splat   $fog_green,$n,$m_word
        load_constant $m_word,0x0c0d0e0f
        splat   $fog_blue,$n,$m_word
    .irp row, 0,1,2,3
        lqd     $n,RAYS16_t+16*\row($a_rays)
        exp2_of_product
        lqd     $mask,16*\row($a_mask)
    .irp channel, red,green,blue
        lqd     $lit,SURFACES_lit_\channel+16*\row($a_surfaces)
        fs      $changed,$lit,$fog_\channel
        fma     $changed,$changed,$result,$fog_\channel
        selb    $lit,$lit,$changed,$mask
        stqd    $lit,SURFACES_lit_\channel+16*\row($a_surfaces)
    .endr
    .irp share, mirror,transmittance
        lqd     $lit,SURFACES_\share+16*\row($a_surfaces)
        fm      $changed,$lit,$result
        selb    $lit,$lit,$changed,$mask
        stqd    $lit,SURFACES_\share+16*\row($a_surfaces)
    .endr
    .endr
        bi      $lr
endfunction fog_r16
