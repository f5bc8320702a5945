# light_r16   what a light adds to surfaces: Lambert's share and Blinn's highlight
#   C       void light_r16(const struct site *, int count, const struct light *,
#                          const struct object *background);
#   In      $3 sites, with their shadow rays, $4 count (at least 1), $5 light, $6 the
#           background's object; pointers 16-aligned
#   Out     the sites' surfaces: lit, in lanes whose shadow ray is there (t >= 0) and has met
#           nothing
#   Uses    $3-$4, $6-$70   Saves  -   Stack  0   Calls  -
#   Domain  N.L >= 0 and N.d <= 0 where there is a shadow ray; shares from 0 to 1; N, L, d of
#           length 1 within 8 ulp; exponent 0, or from 0.25 to 4096
#   Error   0.6 thousandths of the brightness, exponents to 1000; 1.5 to 4096
#   Twin    lab/twins/src/light.rs
#
#   lit += brightness fade (diffuse (N.L) colour + highlight (N.H)^exponent)
#   fade = (1 - falloff t^2)^2
# For H = L - d, without a root or a unit vector:
#   q = (N.H)^2 / |H|^2                      the square of the cosine: N.H is at least 0
#   q = 2^k m, sqrt(1/2) <= m <= sqrt(2)     log2(q) = k + u p(u), u = m - 1
#   n = -exponent log2(q) / 2                fixed point with 23 bits of fraction, at least 0
#   2^-n = 2^-f / 2^i                        f and i are bits of n: 1 + f is n's fraction under the
#                                            exponent of 1, and i is subtracted from the result's
# p has degree 4 and is exact to 5e-5 of log2(q). The error of the exponent grows as x^n falls, so
# x^n takes on at most 0.37 of it. Where q is nearly 1, the rounding of q itself, about 8 ulp, is
# multiplied by the exponent. 2^-f has degree 3 and is exact to 8e-5. 0^0 is 1.

        .include "light_tmpl.inc"
        .include "exp2.inc"

        # constants
        .set    m_fraction,28
        .set    k_root2,29
        .set    k_none,30
        .set    k_log,31                                # five
        .set    k_exp,36                                # four
        # a row
        .set    half_x,40
        .set    half_y,41
        .set    half_z,42
        .set    cosine,43
        .set    squared,44
        .set    inverse,45
        .set    quotient,46
        .set    power,47
        .set    unit,48
        .set    n,49
        .set    exponent,50
        .set    highlight,51
        .set    fraction,52
        .set    whole,53
        .set    result,54
        .set    t_y,55
        .set    t_e,56
        .set    mantissa,57

# Minimax coefficients by Remez, weighted for the relative error and then rounded. They are for
# half of log2, so that k/2 is added.
.macro  log_constants
        load_constant $k_log+0,0x3f38a8a2               # 0.72132313
        load_constant $k_log+1,0xbeb8764a               # -0.36027749
        load_constant $k_log+2,0x3e787a18               # 0.24265325
        load_constant $k_log+3,0xbe48230e               # -0.19544622
        load_constant $k_log+4,0x3e026ed6               # 0.12737594
.endm

# $quotient = (N.H)^2 / |H|^2
.macro  cosine_squared row:req
    .irp axis, x,y,z
        lqd     $half_\axis,RAYS16_direction_\axis+16*\row($a_rays)
        fs      $half_\axis,$to_\axis,$half_\axis
    .endr
        dot_f4  $cosine,normal,half
        dot_f4  $squared,half,half
        fm      $cosine,$cosine,$cosine
        frest   $t_y,$squared
        fi      $t_y,$squared,$t_y
        fnms    $t_e,$squared,$t_y,$k_one
        fma     $inverse,$t_e,$t_y,$t_y
        fm      $quotient,$cosine,$inverse
.endm

# $n = -log2($quotient) / 2
.macro  half_log2
        sf      $power,$quotient,$k_root2
        andc    $power,$power,$m_fraction               # -k above the fraction
        a       $mantissa,$power,$quotient
        csflt   $power,$power,24                        # -k/2
        fs      $unit,$mantissa,$k_one
        fma     $n,$unit,$k_log+4,$k_log+3
        fma     $n,$unit,$n,$k_log+2
        fma     $n,$unit,$n,$k_log+1
        fma     $n,$unit,$n,$k_log+0
        fnms    $n,$unit,$n,$power
.endm

function light_r16
        light_begin
        load_constant $k_root2,0x3fb504f3
        log_constants
        exp_constants
next_site:
        lqd     $a_surfaces,SITE_surfaces($a_site)
        rotqbyi $a_rays,$a_surfaces,SITE_rays
        rotqbyi $a_shadow,$a_surfaces,SITE_shadow
    .irp row, 0,1,2,3
        light_row \row
        cosine_squared \row
        half_log2
        lqd     $exponent,SURFACES_exponent+16*\row($a_surfaces)
        exp2_of_product
        lqd     $highlight,SURFACES_highlight+16*\row($a_surfaces)
        fm      $highlight,$highlight,$result
        fm      $highlight,$highlight,$fade
        and     $highlight,$highlight,$reached
        light_add \row,$highlight
    .endr
        light_next
        brnz    $count,next_site
        bi      $lr
endfunction light_r16
