# light_r16   what a light adds to surfaces: Lambert's share and Blinn's highlight
#   C       void light_r16(const struct site *, int count, const struct light *,
#                          const struct object *background);
#   In      $3 sites, $4 count (at least 1), $5 light, $6 the background's object; pointers
#           16-aligned
#   Out     the sites' surfaces: lit, in lanes whose shadow ray is there (t >= 0) and has met
#           nothing
#   Uses    $2-$67, $79   Saves  -   Stack  0   Calls  -
#   Domain  N.L > 0 where there is a shadow ray; shares from 0 to 1; N, L, d of length 1 within 8
#           ulp; exponent 0, or from 0.25 to 4096
#   Error   0.6 thousandths of the brightness, exponents to 1000; 1.5 to 4096
#   Twin    lab/twins/src/light.rs
#
#   lit += brightness (diffuse (N.L) colour + highlight (N.H)^exponent)
# For H = L - d, without a root or a unit vector:
#   q = (N.H)^2 / |H|^2                      the square of the cosine, where N.H is at least 0
#   q = 2^k m, sqrt(1/2) <= m <= sqrt(2)     log2(q) = k + u p(u), u = m - 1
#   n = -exponent log2(q) / 2                fixed point with 23 bits of fraction, at least 0
#   2^-n = 2^-f / 2^i                        f and i are bits of n: 1 + f is n's fraction under the
#                                            exponent of 1, and i is subtracted from the result's
# p has degree 4 and is exact to 5e-5 of log2(q). The error of the exponent grows as x^n falls, so
# x^n takes on at most 0.37 of it. Where q is nearly 1, the rounding of q itself, about 8 ulp, is
# multiplied by the exponent. 2^-f has degree 3 and is exact to 8e-5. 0^0 is 1.
# Scheduled by spu schedule from light_r16.s

        .include "light_tmpl.inc"

        # constants
        .set    k_one,26
        .set    m_sign,27
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

# The same for 2^(1 - g), 1 <= g < 2.
.macro  exp_constants
        load_constant $k_exp+0,0x3ffae237               # 1.9600285
        load_constant $k_exp+1,0xbfa25452               # -1.2681982
        load_constant $k_exp+2,0x3eb1b807               # 0.34710715
        load_constant $k_exp+3,0xbd1fcb52               # -0.03901226
.endm

# $quotient = (N.H)^2 / |H|^2
.macro  cosine_squared row:req
    .irp axis, x,y,z
        lqd     $half_\axis,RAYS16_direction_\axis+16*\row($a_rays)
        fs      $half_\axis,$to_\axis,$half_\axis
    .endr
        dot_f4  $cosine,normal,half
        dot_f4  $squared,half,half
        cgti    $t_e,$cosine,-1
        and     $cosine,$cosine,$t_e
        fm      $cosine,$cosine,$cosine
        frest   $t_y,$squared
        fi      $t_y,$squared,$t_y
        fnms    $t_e,$squared,$t_y,$k_one
        fma     $inverse,$t_e,$t_y,$t_y
        fm      $quotient,$cosine,$inverse
.endm

# $n = log2($quotient) / 2
.macro  half_log2
        sf      $power,$quotient,$k_root2               # -k, and what the shift drops
        rotmai  $power,$power,-23
        shli    $mantissa,$power,23
        a       $mantissa,$mantissa,$quotient
        csflt   $power,$power,1                         # -k/2
        fs      $unit,$mantissa,$k_one
        fma     $n,$unit,$k_log+4,$k_log+3
        fma     $n,$unit,$n,$k_log+2
        fma     $n,$unit,$n,$k_log+1
        fma     $n,$unit,$n,$k_log+0
        fms     $n,$unit,$n,$power
.endm

# $result = 2^($n $exponent)
.macro  exp2_of_product
        xor     $exponent,$exponent,$m_sign
        fm      $n,$n,$exponent
        cfltu   $whole,$n,23
        selb    $fraction,$k_one,$whole,$m_fraction
        fma     $result,$fraction,$k_exp+3,$k_exp+2
        fma     $result,$fraction,$result,$k_exp+1
        fma     $result,$fraction,$result,$k_exp+0
        clgt    $t_e,$k_none,$whole
        andc    $whole,$whole,$m_fraction
        sf      $result,$whole,$result
        and     $result,$result,$t_e
.endm

function light_r16
        .set m_lane_2,2; .set m_lane_3,5; .set count_2,79; .set a_shadow_2,16; .set a_rays_2,15
        .set normal_x_2,12; .set normal_x_3,19; .set to_x_2,11; .set half_x_2,13; .set half_x_3,24
        .set to_x_3,25; .set to_x_4,18; .set half_x_4,21; .set t_c_2,41; .set to_x_5,20
        .set half_x_5,11; .set to_y_2,14; .set half_y_2,22; .set to_y_3,17; .set half_y_3,46
        .set t_c_3,18; .set to_y_4,42; .set half_y_4,24; .set squared_2,2; .set half_y_5,43
        .set cosine_2,11; .set to_y_5,45; .set squared_3,12; .set to_z_2,47; .set to_z_3,49
        .set cosine_3,5; .set half_z_2,13; .set half_z_3,51; .set squared_4,50; .set half_z_4,52
        .set to_z_4,53; .set to_z_5,54; .set half_z_5,15; .set normal_x_4,55; .set normal_x_5,56
        .set normal_y_2,23; .set squared_5,48; .set normal_y_3,50; .set normal_y_4,57
        .set normal_z_2,62; .set normal_z_3,64; .set normal_z_4,63; .set cosine_4,21
        .set exponent_2,59; .set exponent_3,58; .set squared_6,19; .set normal_y_5,48
        .set lit_2,65; .set cosine_5,40; .set lit_3,66; .set highlight_2,67; .set t_y_2,60
        .set t_y_3,22; .set t_y_4,46; .set cosine_6,24; .set normal_z_5,40; .set t_y_5,61
        .set exponent_4,11; .set highlight_3,55; .set cosine_7,13; .set t_e_2,12; .set t_e_3,15
        .set t_e_4,19; .set t_e_5,44; .set t_e_6,2; .set t_e_7,52; .set t_e_8,21; .set t_e_9,51
        .set inverse_2,12; .set a_surfaces_2,60; .set inverse_3,15; .set exponent_5,22
        .set inverse_4,19; .set inverse_5,2; .set lit_4,61; .set quotient_2,5; .set exponent_6,12
        .set quotient_3,13; .set t_c_4,20; .set quotient_4,2; .set power_2,15; .set power_3,19
        .set power_4,21; .set power_5,22; .set mantissa_2,43; .set mantissa_3,24
        .set mantissa_4,44; .set mantissa_5,51; .set mantissa_6,5; .set mantissa_7,13
        .set mantissa_8,2; .set colour_2,51; .set unit_2,13; .set unit_3,2; .set unit_4,5
        .set unit_5,24; .set colour_3,48; .set t_c_5,14; .set n_2,43; .set n_3,44; .set n_4,46
        .set lit_5,57; .set n_5,45; .set t_c_6,17; .set n_6,20; .set n_7,42; .set colour_4,46
        .set n_8,18; .set reached_2,45; .set lit_6,64; .set n_9,23; .set diffuse_2,43
        .set t_c_7,40; .set lit_7,63; .set n_10,13; .set reached_3,18; .set n_11,2; .set n_12,5
        .set n_13,15; .set diffuse_3,23; .set reached_4,12; .set n_14,11; .set lit_8,58
        .set whole_2,2; .set t_c_8,15; .set reached_5,16; .set whole_3,5; .set colour_5,49
        .set whole_4,19; .set reached_6,11; .set fraction_2,20; .set t_c_9,12; .set result_2,22
        .set fraction_3,18; .set result_3,24; .set fraction_4,21; .set whole_5,43; .set result_4,42
        .set whole_6,50; .set colour_6,2; .set result_5,20; .set colour_7,22; .set colour_8,52
        .set result_6,18; .set colour_9,24; .set whole_7,44; .set t_e_10,5; .set colour_10,53
        .set highlight_4,50; .set diffuse_4,56; .set diffuse_5,44; .set highlight_5,21
        .set result_7,5; .set colour_11,18; .set highlight_6,20; .set colour_12,55
        .set highlight_7,5; .set lit_9,50; .set diffuse_6,41; .set diffuse_7,14; .set colour_13,44
        .set lit_10,54; .set diffuse_8,25; .set lit_11,43; .set reached_7,59; .set lit_12,40
        .set lit_13,45; .set diffuse_9,17; .set whole_8,47; .set highlight_8,62
        .set highlight_9,15; .set colour_14,5; .set colour_15,11; .set colour_16,12
        .set colour_17,13; .set colour_18,14; .set colour_19,17; .set lit_14,13; .set lit_15,2
        .set lit_16,17; .set lit_17,14; .set lit_18,5; .set colour_20,19; .set colour_21,23
        .set lit_19,19; .set lit_20,48; .set lit_21,23; .set result_8,3; .set highlight_10,3
        .set colour_22,4; .set colour_23,3
        ilhu    $m_lane,1                               # 0e
        lqd     $light,16($a_light)                     # 0o
        ilhu    $m_lane_2,0x405                         # 1e
        ilhu    $m_lane_3,0x809                         # 2e
        iohl    $m_lane,515                             # 3e
        iohl    $m_lane_2,0x607                         # 4e
        iohl    $m_lane_3,0xa0b                         # 5e
        shufb   $background,$background,$background,$m_lane # 5o
        ilhu    $m_fraction,127                         # 6e
        shufb   $bright_red,$light,$light,$m_lane       # 6o
        ilhu    $k_root2,0x3fb5                         # 7e
        shufb   $bright_green,$light,$light,$m_lane_2   # 7o
        ilhu    $k_log,0x3f38                           # 8e
        shufb   $bright_blue,$light,$light,$m_lane_3    # 8o
        ilhu    $k_log+1,0xbeb8                         # 9e
        ilhu    $k_log+2,0x3e78                         # 10e
        ilhu    $k_log+3,0xbe48                         # 11e
        ilhu    $k_log+4,0x3e02                         # 12e
        ilhu    $k_exp,0x3ffa                           # 13e
        ilhu    $k_exp+1,0xbfa2                         # 14e
        ilhu    $k_exp+2,0x3eb1                         # 15e
        ilhu    $k_exp+3,0xbd1f                         # 16e
        clgti   $count_2,$count,1                       # 17e at least as many passes as overlap
        ilhu    $k_one,0x3f80                           # 18e
        ilhu    $m_sign,0x8000                          # 19e
        iohl    $m_fraction,0xffff                      # 20e
        iohl    $k_root2,0x4f3                          # 21e
        ilhu    $k_none,0x3f00                          # 22e 126: 2^-n is 0
        iohl    $k_log,0xa8a2                           # 23e
        iohl    $k_log+1,0x764a                         # 24e
        iohl    $k_log+2,0x7a18                         # 25e
        iohl    $k_log+3,0x230e                         # 26e
        iohl    $k_log+4,0x6ed6                         # 27e
        iohl    $k_exp,0xe237                           # 28e
        iohl    $k_exp+1,0x5452                         # 29e
        iohl    $k_exp+2,0xb807                         # 30e
        iohl    $k_exp+3,0xcb52                         # 31e
        brz     $count_2,next_site_short                # 31o too few passes
        ai      $count,$count,-1                        # 32e
        lqd     $a_surfaces,0($a_site)                  # 32o
        ai      $a_site,$a_site,16                      # 33e
        rotqbyi $a_shadow_2,$a_surfaces,8               # 38o
        rotqbyi $a_rays_2,$a_surfaces,4                 # 39o
        lqd     $normal_x_2,208($a_surfaces)            # 40o
        lqd     $normal_x_3,224($a_surfaces)            # 41o
        lqd     $to_x_2,208($a_shadow_2)                # 42o
        lqd     $half_x_2,208($a_rays_2)                # 43o
        lqd     $half_x_3,224($a_rays_2)                # 44o
        lqd     $to_x_3,240($a_shadow_2)                # 45o
        lqd     $to_x_4,224($a_shadow_2)                # 46o
        nop     $127                                    # 47e pairing
        lqd     $half_x_4,240($a_rays_2)                # 47o
        fm      $t_c_2,$normal_x_2,$to_x_2              # 48e
        lqd     $to_x_5,192($a_shadow_2)                # 48o
        fs      $half_x_5,$to_x_2,$half_x_2             # 49e
        lqd     $half_x,192($a_rays_2)                  # 49o
        lqd     $to_y_2,304($a_shadow_2)                # 50o
        lqd     $half_y_2,304($a_rays_2)                # 51o
        fs      $half_x_2,$to_x_4,$half_x_3             # 52e
        lqd     $to_y_3,288($a_shadow_2)                # 52o
        fs      $half_x_4,$to_x_3,$half_x_4             # 53e
        lqd     $half_y_3,288($a_rays_2)                # 53o
        fm      $t_c_3,$normal_x_3,$to_x_4              # 54e
        lqd     $to_y_4,256($a_shadow_2)                # 54o
        fs      $half_x,$to_x_5,$half_x                 # 55e
        lqd     $half_y_4,256($a_rays_2)                # 55o
        fm      $squared_2,$half_x_5,$half_x_5          # 56e
        lqd     $half_y_5,272($a_rays_2)                # 56o
        fm      $cosine_2,$normal_x_2,$half_x_5         # 57e
        lqd     $to_y_5,272($a_shadow_2)                # 57o
        fm      $squared_3,$half_x_2,$half_x_2          # 58e
        lqd     $to_z_2,352($a_shadow_2)                # 58o
        fs      $half_y_2,$to_y_2,$half_y_2             # 59e
        lqd     $to_z_3,368($a_shadow_2)                # 59o
        fm      $cosine_3,$normal_x_3,$half_x_2         # 60e
        lqd     $half_z_2,352($a_rays_2)                # 60o
        fs      $half_y_3,$to_y_3,$half_y_3             # 61e
        lqd     $half_z_3,368($a_rays_2)                # 61o
        fm      $squared_4,$half_x_4,$half_x_4          # 62e
        lqd     $half_z_4,320($a_rays_2)                # 62o
        fm      $squared,$half_x,$half_x                # 63e
        lqd     $to_z_4,320($a_shadow_2)                # 63o
        fs      $half_y_4,$to_y_4,$half_y_4             # 64e
        lqd     $to_z_5,336($a_shadow_2)                # 64o
        fs      $half_y_5,$to_y_5,$half_y_5             # 65e
        lqd     $half_z_5,336($a_rays_2)                # 65o
        fs      $half_z_2,$to_z_2,$half_z_2             # 66e
        lqd     $normal_x_4,240($a_surfaces)            # 66o
        fs      $half_z_3,$to_z_3,$half_z_3             # 67e
        lqd     $normal_x_5,192($a_surfaces)            # 67o
        fma     $squared_3,$half_y_3,$half_y_3,$squared_3 # 68e
        lqd     $normal_y_2,288($a_surfaces)            # 68o
        fma     $squared_5,$half_y_2,$half_y_2,$squared_4 # 69e
        lqd     $normal_y_3,256($a_surfaces)            # 69o
        fma     $squared,$half_y_4,$half_y_4,$squared   # 70e
        lqd     $normal_y_4,272($a_surfaces)            # 70o
        fs      $half_z_4,$to_z_4,$half_z_4             # 71e
        lqd     $normal_z_2,352($a_surfaces)            # 71o
        fma     $squared_2,$half_y_5,$half_y_5,$squared_2 # 72e
        lqd     $normal_z_3,368($a_surfaces)            # 72o
        fs      $half_z_5,$to_z_5,$half_z_5             # 73e
        lqd     $normal_z_4,336($a_surfaces)            # 73o
        fm      $cosine_4,$normal_x_4,$half_x_4         # 74e
        lqd     $exponent_2,960($a_surfaces)            # 74o
        fma     $squared_3,$half_z_2,$half_z_2,$squared_3 # 75e
        lqd     $exponent_3,992($a_surfaces)            # 75o
        fma     $squared_6,$half_z_3,$half_z_3,$squared_5 # 76e
        lqd     $normal_y_5,304($a_surfaces)            # 76o
        fma     $squared,$half_z_4,$half_z_4,$squared   # 77e
        lqd     $lit_2,0x5b0($a_surfaces)               # 77o
        fm      $cosine_5,$normal_x_5,$half_x           # 78e
        lqd     $lit_3,0x5f0($a_surfaces)               # 78o
        fma     $squared_2,$half_z_5,$half_z_5,$squared_2 # 79e
        lqd     $highlight_2,928($a_surfaces)           # 79o
        fma     $cosine_3,$normal_y_2,$half_y_3,$cosine_3 # 80e
        lnop                                            # 80o pairing
        fma     $cosine,$normal_y_4,$half_y_5,$cosine_2 # 81e
        frest   $t_y_2,$squared_3                       # 81o
        fma     $cosine_4,$normal_y_5,$half_y_2,$cosine_4 # 82e
        frest   $t_y_3,$squared_6                       # 82o
        fm      $t_c,$normal_x_4,$to_x_3                # 83e
        frest   $t_y_4,$squared                         # 83o
        fma     $cosine_6,$normal_y_3,$half_y_4,$cosine_5 # 84e
        lqd     $normal_z_5,320($a_surfaces)            # 84o
        fi      $t_y_2,$squared_3,$t_y_2                # 85e
        frest   $t_y_5,$squared_2                       # 85o
        fi      $t_y_3,$squared_6,$t_y_3                # 86e
        lqd     $exponent_4,976($a_surfaces)            # 86o
        fi      $t_y_4,$squared,$t_y_4                  # 87e
        lqd     $highlight_3,912($a_surfaces)           # 87o
        xor     $exponent_2,$exponent_2,$m_sign         # 88e
        fi      $t_y_5,$squared_2,$t_y_5                # 89e
        xor     $exponent_3,$exponent_3,$m_sign         # 90e
        fma     $cosine_3,$normal_z_2,$half_z_2,$cosine_3 # 91e
        fma     $cosine_7,$normal_z_3,$half_z_3,$cosine_4 # 92e
        fma     $cosine_6,$normal_z_5,$half_z_4,$cosine_6 # 93e
        fma     $cosine,$normal_z_4,$half_z_5,$cosine   # 94e
        fnms    $t_e_2,$squared_3,$t_y_2,$k_one         # 95e
        fnms    $t_e_3,$squared_6,$t_y_3,$k_one         # 96e
        fnms    $t_e_4,$squared,$t_y_4,$k_one           # 97e
        cgti    $t_e_5,$cosine_3,-1                     # 98e
        fnms    $t_e_6,$squared_2,$t_y_5,$k_one         # 99e
        cgti    $t_e_7,$cosine_7,-1                     # 100e
        cgti    $t_e_8,$cosine_6,-1                     # 101e
        and     $cosine_3,$cosine_3,$t_e_5              # 102e
        cgti    $t_e_9,$cosine,-1                       # 103e
        and     $cosine_7,$cosine_7,$t_e_7              # 104e
        and     $cosine_4,$cosine_6,$t_e_8              # 105e
        fma     $inverse_2,$t_e_2,$t_y_2,$t_y_2         # 106e
        shlqbyi $a_surfaces_2,$a_surfaces,0             # 106o copy
        fm      $cosine_3,$cosine_3,$cosine_3           # 107e
        and     $cosine,$cosine,$t_e_9                  # 108e
        fm      $cosine_7,$cosine_7,$cosine_7           # 109e
        lnop                                            # 109o pairing
        fma     $inverse_3,$t_e_3,$t_y_3,$t_y_3         # 110e
        lqd     $exponent_5,1008($a_surfaces)           # 110o
        fm      $cosine_4,$cosine_4,$cosine_4           # 111e
        fma     $inverse_4,$t_e_4,$t_y_4,$t_y_4         # 112e
        fm      $cosine,$cosine,$cosine                 # 113e
        lnop                                            # 113o pairing
        fma     $inverse_5,$t_e_6,$t_y_5,$t_y_5         # 114e
        lqd     $lit_4,0x5c0($a_surfaces)               # 114o
        fm      $quotient,$cosine_3,$inverse_2          # 115e
        fm      $quotient_2,$cosine_7,$inverse_3        # 116e
        xor     $exponent_6,$exponent_5,$m_sign         # 117e
        fm      $quotient_3,$cosine_4,$inverse_4        # 118e
        fm      $t_c_4,$normal_x_5,$to_x_5              # 119e
        fm      $quotient_4,$cosine,$inverse_5          # 120e
        sf      $power_2,$quotient,$k_root2             # 121e
        sf      $power_3,$quotient_2,$k_root2           # 122e
        rotmai  $power_2,$power_2,-23                   # 123e
        sf      $power_4,$quotient_3,$k_root2           # 124e
        rotmai  $power_3,$power_3,-23                   # 125e
        sf      $power_5,$quotient_4,$k_root2           # 126e
        rotmai  $power_4,$power_4,-23                   # 127e
        rotmai  $power_5,$power_5,-23                   # 128e
        shli    $mantissa_2,$power_3,23                 # 129e
        shli    $mantissa_3,$power_2,23                 # 130e
        shli    $mantissa_4,$power_4,23                 # 131e
        shli    $mantissa_5,$power_5,23                 # 132e
        a       $mantissa_6,$mantissa_2,$quotient_2     # 133e
        a       $mantissa_3,$mantissa_3,$quotient       # 134e
        a       $mantissa_7,$mantissa_4,$quotient_3     # 135e
        lnop                                            # 135o pairing
        a       $mantissa_8,$mantissa_5,$quotient_4     # 136e
        lqd     $colour_2,752($a_surfaces)              # 136o
        fs      $unit_2,$mantissa_7,$k_one              # 137e
        fs      $unit_3,$mantissa_8,$k_one              # 138e
        fs      $unit_4,$mantissa_6,$k_one              # 139e
        fs      $unit_5,$mantissa_3,$k_one              # 140e
        fma     $t_c,$normal_y_5,$to_y_2,$t_c           # 141e
        lqd     $colour_3,656($a_surfaces)              # 141o
        fma     $t_c_5,$normal_y_3,$to_y_4,$t_c_4       # 142e
        fma     $n_2,$unit_2,$k_log+4,$k_log+3          # 143e
        fma     $n_3,$unit_3,$k_log+4,$k_log+3          # 144e
        fma     $n_4,$unit_4,$k_log+4,$k_log+3          # 145e
        fma     $t_c_2,$normal_y_4,$to_y_5,$t_c_2       # 146e
        lqd     $lit_5,0x5e0($a_surfaces)               # 146o
        fma     $n_5,$unit_5,$k_log+4,$k_log+3          # 147e
        fma     $t_c_6,$normal_y_2,$to_y_3,$t_c_3       # 148e
        fma     $n_6,$unit_2,$n_2,$k_log+2              # 149e
        fma     $n_7,$unit_3,$n_3,$k_log+2              # 150e
        fma     $n_3,$unit_4,$n_4,$k_log+2              # 151e
        lqd     $colour_4,704($a_surfaces)              # 151o
        csflt   $power_5,$power_5,1                     # 152e
        csflt   $power_3,$power_3,1                     # 153e
        csflt   $power_4,$power_4,1                     # 154e
        csflt   $power_2,$power_2,1                     # 155e
        xor     $exponent_4,$exponent_4,$m_sign         # 156e
        fma     $n_8,$unit_2,$n_6,$k_log+1              # 157e
        fma     $n_2,$unit_5,$n_5,$k_log+2              # 158e
        lqd     $reached_2,432($a_shadow_2)             # 158o
        fma     $n_6,$unit_3,$n_7,$k_log+1              # 159e
        fma     $n_7,$unit_4,$n_3,$k_log+1              # 160e
        fma     $t_c_6,$normal_z_2,$to_z_2,$t_c_6       # 161e
        lnop                                            # 161o pairing
        fma     $t_c,$normal_z_3,$to_z_3,$t_c           # 162e
        lqd     $lit_6,0x5a0($a_surfaces)               # 162o
        fma     $n_8,$unit_2,$n_8,$k_log                # 163e
        lnop                                            # 163o pairing
        fma     $n_9,$unit_5,$n_2,$k_log+1              # 164e
        lqd     $diffuse_2,864($a_surfaces)             # 164o
        fma     $n_6,$unit_3,$n_6,$k_log                # 165e
        fma     $n_7,$unit_4,$n_7,$k_log                # 166e
        fma     $t_c_5,$normal_z_5,$to_z_4,$t_c_5       # 167e
        lqd     $t_c_7,464($a_shadow_2)                 # 167o
        fma     $t_c_2,$normal_z_4,$to_z_5,$t_c_2       # 168e
        lqd     $lit_7,0x560($a_surfaces)               # 168o
        fms     $n_10,$unit_2,$n_8,$power_4             # 169e
        lqd     $reached_3,416($a_shadow_2)             # 169o
        fma     $n_9,$unit_5,$n_9,$k_log                # 170e
        fms     $n_11,$unit_3,$n_6,$power_5             # 171e
        fms     $n_12,$unit_4,$n_7,$power_3             # 172e
        ceq     $t_c_7,$t_c_7,$background               # 173e
        cgti    $reached_2,$reached_2,-1                # 174e
        fms     $n_13,$unit_5,$n_9,$power_2             # 176e
        fm      $n_11,$n_11,$exponent_4                 # 177e
        lnop                                            # 177o pairing
        fm      $diffuse_3,$diffuse_2,$t_c_6            # 178e
        lqd     $t_c_6,496($a_shadow_2)                 # 178o
        fm      $n,$n_12,$exponent_6                    # 179e
        lqd     $reached_4,384($a_shadow_2)             # 179o
        fm      $n_12,$n_10,$exponent_2                 # 180e
        lnop                                            # 180o pairing
        cgti    $reached,$reached_3,-1                  # 181e
        lqd     $t_c_3,480($a_shadow_2)                 # 181o
        fm      $n_14,$n_13,$exponent_3                 # 182e
        lqd     $lit_8,0x570($a_surfaces)               # 182o
        cfltu   $whole_2,$n_11,23                       # 183e
        lnop                                            # 183o pairing
        ceq     $t_c_8,$t_c_6,$background               # 184e
        lqd     $t_c_6,448($a_shadow_2)                 # 184o
        cfltu   $whole,$n,23                            # 185e
        lqd     $reached_5,400($a_shadow_2)             # 185o
        cfltu   $whole_3,$n_12,23                       # 186e
        lqd     $colour_5,736($a_surfaces)              # 186o
        cfltu   $whole_4,$n_14,23                       # 188e
        cgti    $reached_6,$reached_4,-1                # 189e
        selb    $fraction_2,$k_one,$whole_2,$m_fraction # 190e
        ceq     $t_c_9,$t_c_6,$background               # 191e
        ceq     $t_c_6,$t_c_3,$background               # 192e
        selb    $fraction,$k_one,$whole,$m_fraction     # 193e
        fma     $result_2,$fraction_2,$k_exp+3,$k_exp+2 # 194e
        selb    $fraction_3,$k_one,$whole_3,$m_fraction # 195e
        fma     $result,$fraction,$k_exp+3,$k_exp+2     # 196e
        fma     $result_3,$fraction_3,$k_exp+3,$k_exp+2 # 197e
        selb    $fraction_4,$k_one,$whole_4,$m_fraction # 198e
        andc    $whole_5,$whole_2,$m_fraction           # 199e
        fma     $result_2,$fraction_2,$result_2,$k_exp+1 # 200e
        fma     $result_4,$fraction_4,$k_exp+3,$k_exp+2 # 201e
        fma     $result,$fraction,$result,$k_exp+1      # 202e
        fma     $result_3,$fraction_3,$result_3,$k_exp+1 # 203e
        andc    $whole_6,$whole,$m_fraction             # 204e
        lnop                                            # 204o pairing
        clgt    $t_e,$k_none,$whole_2                   # 205e
        lqd     $colour_6,720($a_surfaces)              # 205o
        fma     $result_5,$fraction_2,$result_2,$k_exp  # 206e
        lqd     $colour_7,640($a_surfaces)              # 206o
        fma     $result_4,$fraction_4,$result_4,$k_exp+1 # 207e
        lnop                                            # 207o pairing
        fma     $result,$fraction,$result,$k_exp        # 208e
        lqd     $colour_8,784($a_surfaces)              # 208o
        fma     $result_6,$fraction_3,$result_3,$k_exp  # 209e
        lqd     $colour_9,768($a_surfaces)              # 209o
        andc    $whole_7,$whole_3,$m_fraction           # 210e
        clgt    $t_e_10,$k_none,$whole_3                # 211e
        sf      $result_5,$whole_5,$result_5            # 212e
        lqd     $diffuse_2,880($a_surfaces)             # 212o
        fma     $result_4,$fraction_4,$result_4,$k_exp  # 213e
        lnop                                            # 213o pairing
        clgt    $t_e_8,$k_none,$whole                   # 214e
        lqd     $colour_10,672($a_surfaces)             # 214o
        sf      $result,$whole_6,$result                # 215e
        lqd     $highlight_4,896($a_surfaces)           # 215o
        and     $result_5,$result_5,$t_e                # 216e
        lqd     $diffuse_4,848($a_surfaces)             # 216o
        sf      $result_6,$whole_7,$result_6            # 217e
        lqd     $diffuse_5,832($a_surfaces)             # 217o
        and     $result,$result,$t_e_8                  # 218e
        lqd     $highlight_5,944($a_surfaces)           # 218o
        and     $result_7,$result_6,$t_e_10             # 219e
        lqd     $colour_11,688($a_surfaces)             # 219o
        fm      $highlight_6,$highlight_3,$result_5     # 220e
        lqd     $colour_12,800($a_surfaces)             # 220o
        fm      $highlight_7,$highlight_4,$result_7     # 221e
        lqd     $lit_9,0x540($a_surfaces)               # 221o
        fm      $diffuse_6,$diffuse_4,$t_c_2            # 222e
        lnop                                            # 222o pairing
        fm      $diffuse_7,$diffuse_5,$t_c_5            # 223e
        lqd     $colour_13,816($a_surfaces)             # 223o
        fm      $highlight_5,$highlight_5,$result       # 224e
        lqd     $lit_10,0x590($a_surfaces)              # 224o
        fm      $diffuse_8,$diffuse_2,$t_c              # 225e
        lqd     $lit_11,0x550($a_surfaces)              # 225o
        cgti    $reached_5,$reached_5,-1                # 226e
        and     $reached_6,$reached_6,$t_c_9            # 227e
        and     $reached_7,$reached,$t_c_6              # 228e
        lnop                                            # 228o pairing
        and     $reached_4,$reached_5,$t_c_7            # 229e
        lqd     $lit_12,0x580($a_surfaces)              # 229o
        and     $reached,$reached_2,$t_c_8              # 230e
        lqd     $lit_13,0x5d0($a_surfaces)              # 230o
        and     $diffuse_9,$diffuse_6,$reached_4        # 231e
        and     $diffuse_6,$diffuse_7,$reached_6        # 232e
        andc    $whole_8,$whole_4,$m_fraction           # 233e
        and     $highlight_8,$highlight_7,$reached_6    # 234e
        and     $highlight_6,$highlight_6,$reached_4    # 235e
        and     $diffuse_7,$diffuse_8,$reached          # 236e
        and     $highlight_9,$highlight_5,$reached      # 237e
        lnop                                            # 237o pairing
next_site:
            fma     $colour,$colour_9,$diffuse_6,$highlight_8 # 0e
        lqd     $a_surfaces,0($a_site)                  # 0o
            fma     $colour_6,$colour_6,$diffuse_9,$highlight_6 # 1e
            fma     $colour_14,$colour_11,$diffuse_7,$highlight_9 # 2e
            fma     $colour_15,$colour_13,$diffuse_7,$highlight_9 # 3e
            fma     $colour_16,$colour_4,$diffuse_6,$highlight_8 # 4e
            fma     $colour_17,$colour_3,$diffuse_9,$highlight_6 # 5e
            lnop                                        # 5o pairing
            fma     $colour_18,$colour_2,$diffuse_7,$highlight_9 # 6e
        rotqbyi $a_rays_2,$a_surfaces,4                 # 6o
            clgt    $t_e,$k_none,$whole_4               # 7e
        rotqbyi $a_shadow_2,$a_surfaces,8               # 7o
            fma     $colour_19,$colour_8,$diffuse_9,$highlight_6 # 8e
            fma     $colour_11,$colour_7,$diffuse_6,$highlight_8 # 9e
            fma     $lit,$bright_green,$colour_16,$lit_12 # 10e
        lqd     $normal_x_2,208($a_surfaces)            # 10o
            fma     $lit_14,$bright_red,$colour_17,$lit_11 # 11e
        lqd     $normal_x_3,224($a_surfaces)            # 11o
            fma     $lit_15,$bright_green,$colour_6,$lit_10 # 12e
        lqd     $to_x_5,192($a_shadow_2)                # 12o
            and     $diffuse_3,$diffuse_3,$reached_7    # 13e
        lqd     $half_x,192($a_rays_2)                  # 13o
            fma     $lit_16,$bright_blue,$colour_19,$lit_13 # 14e
        lqd     $half_x_3,224($a_rays_2)                # 14o
        ai      $a_site,$a_site,16                      # 15e
        lqd     $to_x_3,240($a_shadow_2)                # 15o
            fma     $lit_17,$bright_green,$colour_18,$lit_2 # 16e
            stqd    $lit,0x580($a_surfaces_2)           # 16o
            fma     $lit,$bright_blue,$colour_15,$lit_3 # 17e
            stqd    $lit_14,0x550($a_surfaces_2)        # 17o
        ai      $count,$count,-1                        # 18e
        lqd     $to_x_2,208($a_shadow_2)                # 18o
        fs      $half_x,$to_x_5,$half_x                 # 19e
            stqd    $lit_15,0x590($a_surfaces_2)        # 19o
            fma     $lit_15,$bright_red,$colour_11,$lit_9 # 20e
            stqd    $lit_16,0x5d0($a_surfaces_2)        # 20o
            sf      $result,$whole_8,$result_4          # 21e
        lqd     $half_x_2,208($a_rays_2)                # 21o
            fma     $lit_16,$bright_blue,$colour,$lit_4 # 22e
        lqd     $to_x_4,224($a_shadow_2)                # 22o
            and     $result,$result,$t_e                # 23e
        lqd     $half_x_4,240($a_rays_2)                # 23o
        fm      $t_c_2,$normal_x_2,$to_x_2              # 24e
        lqd     $to_y_4,256($a_shadow_2)                # 24o
            fm      $highlight,$highlight_2,$result     # 25e
        lqd     $half_y_5,272($a_rays_2)                # 25o
        fm      $squared,$half_x,$half_x                # 26e
            stqd    $lit_17,0x5b0($a_surfaces_2)        # 26o
        fs      $half_x_5,$to_x_2,$half_x_2             # 27e
            stqd    $lit,0x5f0($a_surfaces_2)           # 27o
        fs      $half_x_2,$to_x_4,$half_x_3             # 28e
        lqd     $to_y_2,304($a_shadow_2)                # 28o
        fs      $half_x_4,$to_x_3,$half_x_4             # 29e
        lqd     $half_y_2,304($a_rays_2)                # 29o
            fma     $lit_18,$bright_red,$colour_14,$lit_8 # 30e
        lqd     $half_y_4,256($a_rays_2)                # 30o
            and     $highlight,$highlight,$reached_7    # 31e
        lqd     $to_y_5,272($a_shadow_2)                # 31o
        fm      $t_c_3,$normal_x_3,$to_x_4              # 32e
            stqd    $lit_15,0x540($a_surfaces_2)        # 32o
        fm      $squared_2,$half_x_5,$half_x_5          # 33e
            stqd    $lit_16,0x5c0($a_surfaces_2)        # 33o
        fm      $cosine_2,$normal_x_2,$half_x_5         # 34e
        lnop                                            # 34o pairing
        fm      $squared_3,$half_x_2,$half_x_2          # 35e
        lqd     $to_y_3,288($a_shadow_2)                # 35o
        fs      $half_y_2,$to_y_2,$half_y_2             # 36e
        lqd     $half_y_3,288($a_rays_2)                # 36o
        fs      $half_y_4,$to_y_4,$half_y_4             # 37e
        lqd     $to_z_2,352($a_shadow_2)                # 37o
        fs      $half_y_5,$to_y_5,$half_y_5             # 38e
            stqd    $lit_18,0x570($a_surfaces_2)        # 38o
        fm      $cosine_3,$normal_x_3,$half_x_2         # 39e
        lqd     $half_z_2,352($a_rays_2)                # 39o
            fma     $colour_20,$colour_12,$diffuse_3,$highlight # 40e
            fma     $colour_3,$colour_10,$diffuse_3,$highlight # 41e
            fma     $colour_21,$colour_5,$diffuse_3,$highlight # 42e
            lnop                                        # 42o pairing
        fs      $half_y_3,$to_y_3,$half_y_3             # 43e
        lqd     $to_z_3,368($a_shadow_2)                # 43o
        fm      $squared_4,$half_x_4,$half_x_4          # 44e
        lqd     $half_z_3,368($a_rays_2)                # 44o
        fs      $half_z_2,$to_z_2,$half_z_2             # 45e
        lqd     $half_z_4,320($a_rays_2)                # 45o
            fma     $lit_19,$bright_blue,$colour_20,$lit_5 # 46e
        lqd     $to_z_4,320($a_shadow_2)                # 46o
        fma     $squared,$half_y_4,$half_y_4,$squared   # 47e
        lqd     $to_z_5,336($a_shadow_2)                # 47o
            fma     $lit_20,$bright_red,$colour_3,$lit_7 # 48e
        lqd     $half_z_5,336($a_rays_2)                # 48o
            fma     $lit_21,$bright_green,$colour_21,$lit_6 # 49e
            lnop                                        # 49o pairing
        fs      $half_z_3,$to_z_3,$half_z_3             # 50e
        lqd     $normal_x_4,240($a_surfaces)            # 50o
        fma     $squared_2,$half_y_5,$half_y_5,$squared_2 # 51e
        lqd     $normal_x_5,192($a_surfaces)            # 51o
        fs      $half_z_4,$to_z_4,$half_z_4             # 52e
        lnop                                            # 52o pairing
        fma     $squared_3,$half_y_3,$half_y_3,$squared_3 # 53e
        lqd     $normal_y_4,272($a_surfaces)            # 53o
        fs      $half_z_5,$to_z_5,$half_z_5             # 54e
            stqd    $lit_20,0x560($a_surfaces_2)        # 54o
        fma     $squared_5,$half_y_2,$half_y_2,$squared_4 # 55e
            stqd    $lit_21,0x5a0($a_surfaces_2)        # 55o
        fm      $cosine_4,$normal_x_4,$half_x_4         # 56e
        lqd     $normal_y_2,288($a_surfaces)            # 56o
        fm      $cosine_5,$normal_x_5,$half_x           # 57e
        lqd     $normal_y_3,256($a_surfaces)            # 57o
        fma     $squared,$half_z_4,$half_z_4,$squared   # 58e
        lqd     $exponent_3,992($a_surfaces)            # 58o
        fma     $squared_3,$half_z_2,$half_z_2,$squared_3 # 59e
        lqd     $exponent_2,960($a_surfaces)            # 59o
        fma     $squared_2,$half_z_5,$half_z_5,$squared_2 # 60e
            stqd    $lit_19,0x5e0($a_surfaces_2)        # 60o
        fma     $squared_6,$half_z_3,$half_z_3,$squared_5 # 61e
        lqd     $normal_y_5,304($a_surfaces)            # 61o
        fma     $cosine,$normal_y_4,$half_y_5,$cosine_2 # 62e
        lqd     $exponent_4,976($a_surfaces)            # 62o
        fma     $cosine_6,$normal_y_3,$half_y_4,$cosine_5 # 63e
        lqd     $normal_z_5,320($a_surfaces)            # 63o
        fma     $cosine_3,$normal_y_2,$half_y_3,$cosine_3 # 64e
        frest   $t_y_4,$squared                         # 64o
        xor     $exponent_3,$exponent_3,$m_sign         # 65e
        frest   $t_y_2,$squared_3                       # 65o
        xor     $exponent_2,$exponent_2,$m_sign         # 66e
        frest   $t_y_5,$squared_2                       # 66o
        fma     $cosine_4,$normal_y_5,$half_y_2,$cosine_4 # 67e
        frest   $t_y_3,$squared_6                       # 67o
        fi      $t_y_4,$squared,$t_y_4                  # 68e
        lqd     $normal_z_2,352($a_surfaces)            # 68o
        fi      $t_y_2,$squared_3,$t_y_2                # 69e
        lqd     $normal_z_4,336($a_surfaces)            # 69o
        fi      $t_y_5,$squared_2,$t_y_5                # 70e
        lqd     $normal_z_3,368($a_surfaces)            # 70o
        fi      $t_y_3,$squared_6,$t_y_3                # 71e
        xor     $exponent_4,$exponent_4,$m_sign         # 72e
        fma     $cosine_6,$normal_z_5,$half_z_4,$cosine_6 # 73e
        fma     $cosine_3,$normal_z_2,$half_z_2,$cosine_3 # 74e
        fma     $cosine,$normal_z_4,$half_z_5,$cosine   # 75e
        fma     $cosine_7,$normal_z_3,$half_z_3,$cosine_4 # 76e
        fnms    $t_e_2,$squared_3,$t_y_2,$k_one         # 77e
        fnms    $t_e_3,$squared_6,$t_y_3,$k_one         # 78e
        fnms    $t_e_4,$squared,$t_y_4,$k_one           # 79e
        cgti    $t_e_8,$cosine_6,-1                     # 80e
        fnms    $t_e_6,$squared_2,$t_y_5,$k_one         # 81e
        cgti    $t_e_5,$cosine_3,-1                     # 82e
        cgti    $t_e_9,$cosine,-1                       # 83e
        cgti    $t_e_7,$cosine_7,-1                     # 84e
        and     $cosine_4,$cosine_6,$t_e_8              # 85e
        and     $cosine,$cosine,$t_e_9                  # 86e
        and     $cosine_7,$cosine_7,$t_e_7              # 87e
        and     $cosine_3,$cosine_3,$t_e_5              # 88e
        fma     $inverse_2,$t_e_2,$t_y_2,$t_y_2         # 89e
        fm      $cosine_3,$cosine_3,$cosine_3           # 90e
        fm      $cosine_7,$cosine_7,$cosine_7           # 91e
        lnop                                            # 91o pairing
        fma     $inverse_3,$t_e_3,$t_y_3,$t_y_3         # 92e
        shlqbyi $a_surfaces_2,$a_surfaces,0             # 92o copy
        fm      $cosine_4,$cosine_4,$cosine_4           # 93e
        lqd     $exponent_5,1008($a_surfaces)           # 93o
        fma     $inverse_4,$t_e_4,$t_y_4,$t_y_4         # 94e
        fm      $cosine,$cosine,$cosine                 # 95e
        fma     $inverse_5,$t_e_6,$t_y_5,$t_y_5         # 96e
        fm      $quotient,$cosine_3,$inverse_2          # 97e
        fm      $quotient_2,$cosine_7,$inverse_3        # 98e
        xor     $exponent_6,$exponent_5,$m_sign         # 99e
        fm      $quotient_3,$cosine_4,$inverse_4        # 100e
        fm      $t_c,$normal_x_4,$to_x_3                # 101e
        fm      $quotient_4,$cosine,$inverse_5          # 102e
        sf      $power_2,$quotient,$k_root2             # 103e
        sf      $power_3,$quotient_2,$k_root2           # 104e
        rotmai  $power_2,$power_2,-23                   # 105e
        sf      $power_4,$quotient_3,$k_root2           # 106e
        rotmai  $power_3,$power_3,-23                   # 107e
        sf      $power_5,$quotient_4,$k_root2           # 108e
        rotmai  $power_4,$power_4,-23                   # 109e
        rotmai  $power_5,$power_5,-23                   # 110e
        shli    $mantissa_3,$power_2,23                 # 111e
        shli    $mantissa_2,$power_3,23                 # 112e
        shli    $mantissa_4,$power_4,23                 # 113e
        shli    $mantissa_5,$power_5,23                 # 114e
        a       $mantissa_3,$mantissa_3,$quotient       # 115e
        a       $mantissa_6,$mantissa_2,$quotient_2     # 116e
        a       $mantissa_7,$mantissa_4,$quotient_3     # 117e
        a       $mantissa_8,$mantissa_5,$quotient_4     # 118e
        fs      $unit_2,$mantissa_7,$k_one              # 119e
        fs      $unit_3,$mantissa_8,$k_one              # 120e
        fs      $unit_5,$mantissa_3,$k_one              # 121e
        fs      $unit_4,$mantissa_6,$k_one              # 122e
        fm      $t_c_4,$normal_x_5,$to_x_5              # 123e
        fma     $t_c_2,$normal_y_4,$to_y_5,$t_c_2       # 124e
        fma     $n_2,$unit_2,$k_log+4,$k_log+3          # 125e
        fma     $n_3,$unit_3,$k_log+4,$k_log+3          # 126e
        fma     $n_5,$unit_5,$k_log+4,$k_log+3          # 127e
        fma     $n_4,$unit_4,$k_log+4,$k_log+3          # 128e
        fma     $t_c,$normal_y_5,$to_y_2,$t_c           # 129e
        fma     $t_c_5,$normal_y_3,$to_y_4,$t_c_4       # 130e
        fma     $n_6,$unit_2,$n_2,$k_log+2              # 131e
        fma     $n_7,$unit_3,$n_3,$k_log+2              # 132e
        fma     $n_2,$unit_5,$n_5,$k_log+2              # 133e
        fma     $n_3,$unit_4,$n_4,$k_log+2              # 134e
        fma     $t_c_6,$normal_y_2,$to_y_3,$t_c_3       # 135e
        fma     $t_c_5,$normal_z_5,$to_z_4,$t_c_5       # 136e
        fma     $n_8,$unit_2,$n_6,$k_log+1              # 137e
        fma     $n_6,$unit_3,$n_7,$k_log+1              # 138e
        lnop                                            # 138o pairing
        fma     $n_9,$unit_5,$n_2,$k_log+1              # 139e
        lqd     $t_c_7,464($a_shadow_2)                 # 139o
        fma     $n_7,$unit_4,$n_3,$k_log+1              # 140e
        csflt   $power_2,$power_2,1                     # 141e
        csflt   $power_3,$power_3,1                     # 142e
        csflt   $power_5,$power_5,1                     # 143e
        csflt   $power_4,$power_4,1                     # 144e
        ceq     $t_c_7,$t_c_7,$background               # 145e
        fma     $n_7,$unit_4,$n_7,$k_log                # 146e
        fma     $n_8,$unit_2,$n_8,$k_log                # 147e
        fma     $n_6,$unit_3,$n_6,$k_log                # 148e
        fma     $n_9,$unit_5,$n_9,$k_log                # 149e
        fma     $t_c_2,$normal_z_4,$to_z_5,$t_c_2       # 150e
        lnop                                            # 150o pairing
        fma     $t_c_6,$normal_z_2,$to_z_2,$t_c_6       # 151e
        lqd     $diffuse_2,864($a_surfaces)             # 151o
        fms     $n_12,$unit_4,$n_7,$power_3             # 152e
        fms     $n_10,$unit_2,$n_8,$power_4             # 153e
        fms     $n_11,$unit_3,$n_6,$power_5             # 154e
        fms     $n_13,$unit_5,$n_9,$power_2             # 155e
        fma     $t_c,$normal_z_3,$to_z_3,$t_c           # 156e
        lqd     $reached_3,416($a_shadow_2)             # 156o
        fm      $diffuse_3,$diffuse_2,$t_c_6            # 157e
        lqd     $t_c_6,496($a_shadow_2)                 # 157o
        fm      $n,$n_12,$exponent_6                    # 158e
        fm      $n_12,$n_10,$exponent_2                 # 159e
        fm      $n_11,$n_11,$exponent_4                 # 160e
        fm      $n_14,$n_13,$exponent_3                 # 161e
        cgti    $reached,$reached_3,-1                  # 162e
        lqd     $reached_4,384($a_shadow_2)             # 162o
        ceq     $t_c_8,$t_c_6,$background               # 163e
        lqd     $t_c_6,448($a_shadow_2)                 # 163o
        cfltu   $whole,$n,23                            # 164e
        lqd     $t_c_3,480($a_shadow_2)                 # 164o
        cfltu   $whole_3,$n_12,23                       # 165e
        cfltu   $whole_2,$n_11,23                       # 166e
        cfltu   $whole_4,$n_14,23                       # 167e
        cgti    $reached_6,$reached_4,-1                # 168e
        ceq     $t_c_9,$t_c_6,$background               # 169e
        ceq     $t_c_6,$t_c_3,$background               # 170e
        selb    $fraction,$k_one,$whole,$m_fraction     # 171e
        selb    $fraction_3,$k_one,$whole_3,$m_fraction # 172e
        selb    $fraction_2,$k_one,$whole_2,$m_fraction # 173e
        fma     $result,$fraction,$k_exp+3,$k_exp+2     # 174e
        selb    $fraction_4,$k_one,$whole_4,$m_fraction # 175e
        fma     $result_2,$fraction_2,$k_exp+3,$k_exp+2 # 176e
        fma     $result_3,$fraction_3,$k_exp+3,$k_exp+2 # 177e
        fma     $result_4,$fraction_4,$k_exp+3,$k_exp+2 # 178e
        andc    $whole_5,$whole_2,$m_fraction           # 179e
        fma     $result,$fraction,$result,$k_exp+1      # 180e
        andc    $whole_7,$whole_3,$m_fraction           # 181e
        fma     $result_2,$fraction_2,$result_2,$k_exp+1 # 182e
        fma     $result_3,$fraction_3,$result_3,$k_exp+1 # 183e
        lqd     $reached_2,432($a_shadow_2)             # 183o
        fma     $result_4,$fraction_4,$result_4,$k_exp+1 # 184e
        lqd     $colour_4,704($a_surfaces)              # 184o
        andc    $whole_8,$whole_4,$m_fraction           # 185e
        lqd     $colour_3,656($a_surfaces)              # 185o
        fma     $result,$fraction,$result,$k_exp        # 186e
        lqd     $colour_5,736($a_surfaces)              # 186o
        andc    $whole_6,$whole,$m_fraction             # 187e
        lqd     $colour_2,752($a_surfaces)              # 187o
        fma     $result_5,$fraction_2,$result_2,$k_exp  # 188e
        lqd     $colour_7,640($a_surfaces)              # 188o
        fma     $result_6,$fraction_3,$result_3,$k_exp  # 189e
        lqd     $colour_9,768($a_surfaces)              # 189o
        clgt    $t_e,$k_none,$whole_2                   # 190e
        lqd     $colour_6,720($a_surfaces)              # 190o
        fma     $result_4,$fraction_4,$result_4,$k_exp  # 191e
        lqd     $colour_8,784($a_surfaces)              # 191o
        clgt    $t_e_8,$k_none,$whole                   # 192e
        lqd     $colour_10,672($a_surfaces)             # 192o
        clgt    $t_e_10,$k_none,$whole_3                # 193e
        lqd     $highlight_3,912($a_surfaces)           # 193o
        sf      $result_5,$whole_5,$result_5            # 194e
        lqd     $diffuse_2,880($a_surfaces)             # 194o
        sf      $result_6,$whole_7,$result_6            # 195e
        lqd     $diffuse_5,832($a_surfaces)             # 195o
        sf      $result,$whole_6,$result                # 196e
        lqd     $highlight_4,896($a_surfaces)           # 196o
        and     $result_5,$result_5,$t_e                # 197e
        lqd     $diffuse_4,848($a_surfaces)             # 197o
        and     $result,$result,$t_e_8                  # 198e
        lqd     $highlight_5,944($a_surfaces)           # 198o
        fm      $highlight_6,$highlight_3,$result_5     # 199e
        lqd     $reached_5,400($a_shadow_2)             # 199o
        and     $result_7,$result_6,$t_e_10             # 200e
        hbrr    next_site_back,next_site                # 200o hint
        fm      $diffuse_7,$diffuse_5,$t_c_5            # 201e
        lqd     $colour_12,800($a_surfaces)             # 201o
        fm      $highlight_7,$highlight_4,$result_7     # 202e
        lqd     $colour_11,688($a_surfaces)             # 202o
        fm      $diffuse_6,$diffuse_4,$t_c_2            # 203e
        lqd     $colour_13,816($a_surfaces)             # 203o
        fm      $highlight_5,$highlight_5,$result       # 204e
        lqd     $lit_9,0x540($a_surfaces)               # 204o
        fm      $diffuse_8,$diffuse_2,$t_c              # 205e
        lqd     $lit_11,0x550($a_surfaces)              # 205o
        cgti    $reached_5,$reached_5,-1                # 206e
        lqd     $lit_10,0x590($a_surfaces)              # 206o
        cgti    $reached_2,$reached_2,-1                # 207e
        lqd     $lit_5,0x5e0($a_surfaces)               # 207o
        and     $reached_6,$reached_6,$t_c_9            # 208e
        lqd     $lit_8,0x570($a_surfaces)               # 208o
        and     $reached_4,$reached_5,$t_c_7            # 209e
        lqd     $lit_12,0x580($a_surfaces)              # 209o
        and     $reached_7,$reached,$t_c_6              # 210e
        lqd     $lit_4,0x5c0($a_surfaces)               # 210o
        and     $reached,$reached_2,$t_c_8              # 211e
        lqd     $lit_13,0x5d0($a_surfaces)              # 211o
        and     $highlight_8,$highlight_7,$reached_6    # 212e
        lqd     $lit_7,0x560($a_surfaces)               # 212o
        and     $diffuse_9,$diffuse_6,$reached_4        # 213e
        lqd     $lit_6,0x5a0($a_surfaces)               # 213o
        and     $diffuse_6,$diffuse_7,$reached_6        # 214e
        lqd     $lit_2,0x5b0($a_surfaces)               # 214o
        and     $highlight_6,$highlight_6,$reached_4    # 215e
        lqd     $lit_3,0x5f0($a_surfaces)               # 215o
        and     $diffuse_7,$diffuse_8,$reached          # 216e
        lqd     $highlight_2,928($a_surfaces)           # 216o
        and     $highlight_9,$highlight_5,$reached      # 217e
next_site_back:
        brnz    $count,next_site                        # 217o
next_site_drain:
        clgt    $t_e,$k_none,$whole_4                   # 0e
        hbr     light_r16_return,$lr                    # 0o hint
        sf      $result_8,$whole_8,$result_4            # 1e
        fma     $colour_16,$colour_4,$diffuse_6,$highlight_8 # 2e
        and     $result_8,$result_8,$t_e                # 3e
        fma     $colour_17,$colour_3,$diffuse_9,$highlight_6 # 4e
        fm      $highlight_10,$highlight_2,$result_8    # 5e
        fma     $colour_6,$colour_6,$diffuse_9,$highlight_6 # 6e
        fma     $colour_19,$colour_8,$diffuse_9,$highlight_6 # 7e
        fma     $colour_22,$colour_2,$diffuse_7,$highlight_9 # 8e
        fma     $colour_15,$colour_13,$diffuse_7,$highlight_9 # 9e
        fma     $colour_14,$colour_7,$diffuse_6,$highlight_8 # 10e
        fma     $lit,$bright_green,$colour_16,$lit_12   # 11e
        fma     $colour,$colour_9,$diffuse_6,$highlight_8 # 12e
        fma     $lit_14,$bright_red,$colour_17,$lit_11  # 13e
        and     $diffuse_3,$diffuse_3,$reached_7        # 14e
        and     $highlight,$highlight_10,$reached_7     # 15e
        fma     $colour_23,$colour_11,$diffuse_7,$highlight_9 # 16e
        fma     $lit_15,$bright_green,$colour_6,$lit_10 # 17e
        stqd    $lit,0x580($a_surfaces_2)               # 17o
        fma     $lit_16,$bright_blue,$colour_19,$lit_13 # 18e
        lnop                                            # 18o pairing
        fma     $colour_3,$colour_10,$diffuse_3,$highlight # 19e
        stqd    $lit_14,0x550($a_surfaces_2)            # 19o
        fma     $lit_17,$bright_green,$colour_22,$lit_2 # 20e
        fma     $colour_22,$colour_5,$diffuse_3,$highlight # 21e
        fma     $lit,$bright_blue,$colour_15,$lit_3     # 22e
        lnop                                            # 22o pairing
        fma     $colour_20,$colour_12,$diffuse_3,$highlight # 23e
        stqd    $lit_15,0x590($a_surfaces_2)            # 23o
        fma     $lit_15,$bright_red,$colour_14,$lit_9   # 24e
        stqd    $lit_16,0x5d0($a_surfaces_2)            # 24o
        fma     $lit_16,$bright_blue,$colour,$lit_4     # 25e
        lnop                                            # 25o pairing
        fma     $lit_18,$bright_red,$colour_23,$lit_8   # 26e
        stqd    $lit_17,0x5b0($a_surfaces_2)            # 26o
        fma     $lit_20,$bright_red,$colour_3,$lit_7    # 27e
        lnop                                            # 27o pairing
        fma     $lit_21,$bright_green,$colour_22,$lit_6 # 28e
        stqd    $lit,0x5f0($a_surfaces_2)               # 28o
        fma     $lit_19,$bright_blue,$colour_20,$lit_5  # 29e
        stqd    $lit_15,0x540($a_surfaces_2)            # 30o
        stqd    $lit_16,0x5c0($a_surfaces_2)            # 31o
        stqd    $lit_18,0x570($a_surfaces_2)            # 32o
        stqd    $lit_20,0x560($a_surfaces_2)            # 33o
        stqd    $lit_21,0x5a0($a_surfaces_2)            # 34o
        stqd    $lit_19,0x5e0($a_surfaces_2)            # 35o
light_r16_return:
        bi      $lr                                     # 36o
next_site_short:
        ai      $count,$count,-1                        # 0e
        lqd     $a_surfaces,0($a_site)                  # 0o
        ai      $a_site,$a_site,16                      # 1e
        rotqbyi $a_rays,$a_surfaces,4                   # 6o
        rotqbyi $a_shadow,$a_surfaces,8                 # 7o
        lqd     $normal_x,192($a_surfaces)              # 8o
        lqd     $normal_y,256($a_surfaces)              # 9o
        lqd     $half_x,192($a_rays)                    # 10o
        lqd     $to_x,192($a_shadow)                    # 11o
        lqd     $half_y,256($a_rays)                    # 12o
        lqd     $to_y,256($a_shadow)                    # 13o
        lqd     $to_z,320($a_shadow)                    # 14o
        lqd     $half_z,320($a_rays)                    # 15o
        lqd     $normal_z,320($a_surfaces)              # 16o
        fs      $half_x,$to_x,$half_x                   # 17e
        lqd     $reached,384($a_shadow)                 # 17o
        nop     $127                                    # 18e pairing
        lqd     $t_c,448($a_shadow)                     # 18o
        fs      $half_y,$to_y,$half_y                   # 19e
        lqd     $exponent,960($a_surfaces)              # 19o
        nop     $127                                    # 20e pairing
        lqd     $highlight,896($a_surfaces)             # 20o
        fs      $half_z,$to_z,$half_z                   # 21e
        lqd     $diffuse,832($a_surfaces)               # 21o
        nop     $127                                    # 22e pairing
        lqd     $colour,640($a_surfaces)                # 22o
        fm      $squared,$half_x,$half_x                # 23e
        lqd     $lit,0x540($a_surfaces)                 # 23o
        fm      $cosine,$normal_x,$half_x               # 24e
        lqd     $half_x,208($a_rays)                    # 24o
        cgti    $reached,$reached,-1                    # 25e
        ceq     $t_c,$t_c,$background                   # 26e
        xor     $exponent,$exponent,$m_sign             # 27e
        and     $reached,$reached,$t_c                  # 28e
        fma     $squared,$half_y,$half_y,$squared       # 29e
        lnop                                            # 29o pairing
        fma     $cosine,$normal_y,$half_y,$cosine       # 30e
        lqd     $half_y,272($a_rays)                    # 30o
        fm      $t_c,$normal_x,$to_x                    # 31e
        lqd     $to_x,208($a_shadow)                    # 31o
        lqd     $normal_x,208($a_surfaces)              # 32o
        fma     $squared,$half_z,$half_z,$squared       # 35e
        fma     $cosine,$normal_z,$half_z,$cosine       # 36e
        lqd     $half_z,336($a_rays)                    # 36o
        fma     $t_c,$normal_y,$to_y,$t_c               # 37e
        lqd     $to_y,272($a_shadow)                    # 37o
        fs      $half_x,$to_x,$half_x                   # 38e
        lqd     $normal_y,272($a_surfaces)              # 38o
        frest   $t_y,$squared                           # 41o
        cgti    $t_e,$cosine,-1                         # 42e
        fma     $t_c,$normal_z,$to_z,$t_c               # 43e
        lqd     $to_z,336($a_shadow)                    # 43o
        and     $cosine,$cosine,$t_e                    # 44e
        lqd     $normal_z,336($a_surfaces)              # 44o
        fi      $t_y,$squared,$t_y                      # 45e
        fm      $cosine,$cosine,$cosine                 # 47e
        fs      $half_y,$to_y,$half_y                   # 48e
        fs      $half_z,$to_z,$half_z                   # 49e
        fm      $diffuse,$diffuse,$t_c                  # 50e
        lqd     $t_c,464($a_shadow)                     # 50o
        fnms    $t_e,$squared,$t_y,$k_one               # 52e
        fm      $squared,$half_x,$half_x                # 53e
        and     $diffuse,$diffuse,$reached              # 56e
        ceq     $t_c,$t_c,$background                   # 57e
        fma     $inverse,$t_e,$t_y,$t_y                 # 58e
        fma     $squared,$half_y,$half_y,$squared       # 59e
        fm      $quotient,$cosine,$inverse              # 64e
        lnop                                            # 64o pairing
        fm      $cosine,$normal_x,$half_x               # 65e
        lqd     $half_x,224($a_rays)                    # 65o
        fma     $squared,$half_z,$half_z,$squared       # 66e
        sf      $power,$quotient,$k_root2               # 70e
        fma     $cosine,$normal_y,$half_y,$cosine       # 71e
        lqd     $half_y,288($a_rays)                    # 71o
        rotmai  $power,$power,-23                       # 72e
        frest   $t_y,$squared                           # 72o
        shli    $mantissa,$power,23                     # 76e
        csflt   $power,$power,1                         # 77e
        fi      $t_y,$squared,$t_y                      # 78e
        a       $mantissa,$mantissa,$quotient           # 80e
        fma     $cosine,$normal_z,$half_z,$cosine       # 81e
        lqd     $half_z,352($a_rays)                    # 81o
        fs      $unit,$mantissa,$k_one                  # 82e
        fma     $n,$unit,$k_log+4,$k_log+3              # 88e
        fma     $n,$unit,$n,$k_log+2                    # 94e
        fma     $n,$unit,$n,$k_log+1                    # 100e
        fma     $n,$unit,$n,$k_log                      # 106e
        fms     $n,$unit,$n,$power                      # 112e
        fm      $n,$n,$exponent                         # 118e
        lqd     $exponent,976($a_surfaces)              # 118o
        cfltu   $whole,$n,23                            # 124e
        xor     $exponent,$exponent,$m_sign             # 125e
        selb    $fraction,$k_one,$whole,$m_fraction     # 131e
        clgt    $t_e,$k_none,$whole                     # 132e
        fma     $result,$fraction,$k_exp+3,$k_exp+2     # 133e
        andc    $whole,$whole,$m_fraction               # 134e
        fma     $result,$fraction,$result,$k_exp+1      # 139e
        fma     $result,$fraction,$result,$k_exp        # 145e
        sf      $result,$whole,$result                  # 151e
        and     $result,$result,$t_e                    # 153e
        cgti    $t_e,$cosine,-1                         # 154e
        fm      $highlight,$highlight,$result           # 155e
        and     $cosine,$cosine,$t_e                    # 156e
        fnms    $t_e,$squared,$t_y,$k_one               # 157e
        fm      $cosine,$cosine,$cosine                 # 158e
        lnop                                            # 158o pairing
        and     $highlight,$highlight,$reached          # 161e
        lqd     $reached,400($a_shadow)                 # 161o
        fma     $inverse,$t_e,$t_y,$t_y                 # 163e
        fma     $colour,$colour,$diffuse,$highlight     # 164e
        cgti    $reached,$reached,-1                    # 167e
        fm      $quotient,$cosine,$inverse              # 169e
        and     $reached,$reached,$t_c                  # 170e
        lnop                                            # 170o pairing
        fm      $t_c,$normal_x,$to_x                    # 171e
        lqd     $to_x,224($a_shadow)                    # 171o
        fma     $lit,$bright_red,$colour,$lit           # 172e
        lqd     $normal_x,224($a_surfaces)              # 172o
        lqd     $colour,704($a_surfaces)                # 173o
        sf      $power,$quotient,$k_root2               # 175e
        rotmai  $power,$power,-23                       # 177e
        lnop                                            # 177o pairing
        fma     $t_c,$normal_y,$to_y,$t_c               # 178e
        lqd     $to_y,288($a_shadow)                    # 178o
        fs      $half_x,$to_x,$half_x                   # 179e
        lqd     $normal_y,288($a_surfaces)              # 179o
        fma     $colour,$colour,$diffuse,$highlight     # 180e
        stqd    $lit,0x540($a_surfaces)                 # 180o
        shli    $mantissa,$power,23                     # 181e
        lqd     $lit,0x580($a_surfaces)                 # 181o
        csflt   $power,$power,1                         # 182e
        lnop                                            # 182o pairing
        fma     $t_c,$normal_z,$to_z,$t_c               # 184e
        lqd     $to_z,352($a_shadow)                    # 184o
        a       $mantissa,$mantissa,$quotient           # 185e
        lqd     $normal_z,352($a_surfaces)              # 185o
        fm      $squared,$half_x,$half_x                # 186e
        fs      $unit,$mantissa,$k_one                  # 187e
        fm      $cosine,$normal_x,$half_x               # 188e
        lqd     $half_x,240($a_rays)                    # 188o
        fs      $half_y,$to_y,$half_y                   # 189e
        fs      $half_z,$to_z,$half_z                   # 190e
        fma     $lit,$bright_green,$colour,$lit         # 191e
        lqd     $colour,768($a_surfaces)                # 191o
        fma     $n,$unit,$k_log+4,$k_log+3              # 193e
        fma     $squared,$half_y,$half_y,$squared       # 195e
        fma     $cosine,$normal_y,$half_y,$cosine       # 196e
        lqd     $half_y,304($a_rays)                    # 196o
        fma     $colour,$colour,$diffuse,$highlight     # 197e
        lqd     $diffuse,848($a_surfaces)               # 197o
        nop     $127                                    # 198e pairing
        lqd     $highlight,912($a_surfaces)             # 198o
        fma     $n,$unit,$n,$k_log+2                    # 199e
        stqd    $lit,0x580($a_surfaces)                 # 199o
        lqd     $lit,0x5c0($a_surfaces)                 # 200o
        fma     $squared,$half_z,$half_z,$squared       # 201e
        fma     $cosine,$normal_z,$half_z,$cosine       # 202e
        lqd     $half_z,368($a_rays)                    # 202o
        fm      $diffuse,$diffuse,$t_c                  # 203e
        lqd     $t_c,480($a_shadow)                     # 203o
        fma     $n,$unit,$n,$k_log+1                    # 205e
        lnop                                            # 205o pairing
        fma     $lit,$bright_blue,$colour,$lit          # 206e
        lqd     $colour,656($a_surfaces)                # 206o
        frest   $t_y,$squared                           # 207o
        and     $diffuse,$diffuse,$reached              # 209e
        ceq     $t_c,$t_c,$background                   # 210e
        fma     $n,$unit,$n,$k_log                      # 211e
        fi      $t_y,$squared,$t_y                      # 212e
        stqd    $lit,0x5c0($a_surfaces)                 # 212o
        lqd     $lit,0x550($a_surfaces)                 # 213o
        fms     $n,$unit,$n,$power                      # 217e
        fm      $n,$n,$exponent                         # 223e
        lqd     $exponent,992($a_surfaces)              # 223o
        cfltu   $whole,$n,23                            # 229e
        xor     $exponent,$exponent,$m_sign             # 230e
        selb    $fraction,$k_one,$whole,$m_fraction     # 236e
        clgt    $t_e,$k_none,$whole                     # 237e
        fma     $result,$fraction,$k_exp+3,$k_exp+2     # 238e
        andc    $whole,$whole,$m_fraction               # 239e
        fma     $result,$fraction,$result,$k_exp+1      # 244e
        fma     $result,$fraction,$result,$k_exp        # 250e
        sf      $result,$whole,$result                  # 256e
        and     $result,$result,$t_e                    # 258e
        cgti    $t_e,$cosine,-1                         # 259e
        fm      $highlight,$highlight,$result           # 260e
        and     $cosine,$cosine,$t_e                    # 261e
        fnms    $t_e,$squared,$t_y,$k_one               # 262e
        fm      $cosine,$cosine,$cosine                 # 263e
        lnop                                            # 263o pairing
        and     $highlight,$highlight,$reached          # 266e
        lqd     $reached,416($a_shadow)                 # 266o
        fma     $inverse,$t_e,$t_y,$t_y                 # 268e
        fma     $colour,$colour,$diffuse,$highlight     # 269e
        cgti    $reached,$reached,-1                    # 272e
        fm      $quotient,$cosine,$inverse              # 274e
        and     $reached,$reached,$t_c                  # 275e
        lnop                                            # 275o pairing
        fm      $t_c,$normal_x,$to_x                    # 276e
        lqd     $to_x,240($a_shadow)                    # 276o
        fma     $lit,$bright_red,$colour,$lit           # 277e
        lqd     $normal_x,240($a_surfaces)              # 277o
        lqd     $colour,720($a_surfaces)                # 278o
        sf      $power,$quotient,$k_root2               # 280e
        rotmai  $power,$power,-23                       # 282e
        lnop                                            # 282o pairing
        fs      $half_x,$to_x,$half_x                   # 283e
        stqd    $lit,0x550($a_surfaces)                 # 283o
        fma     $t_c,$normal_y,$to_y,$t_c               # 284e
        lqd     $to_y,304($a_shadow)                    # 284o
        fma     $colour,$colour,$diffuse,$highlight     # 285e
        lqd     $normal_y,304($a_surfaces)              # 285o
        shli    $mantissa,$power,23                     # 286e
        lqd     $lit,0x590($a_surfaces)                 # 286o
        csflt   $power,$power,1                         # 287e
        fm      $cosine,$normal_x,$half_x               # 289e
        a       $mantissa,$mantissa,$quotient           # 290e
        lnop                                            # 290o pairing
        fma     $t_c,$normal_z,$to_z,$t_c               # 291e
        lqd     $to_z,368($a_shadow)                    # 291o
        fs      $unit,$mantissa,$k_one                  # 292e
        lqd     $normal_z,368($a_surfaces)              # 292o
        fs      $half_y,$to_y,$half_y                   # 293e
        fm      $squared,$half_x,$half_x                # 294e
        fma     $lit,$bright_green,$colour,$lit         # 295e
        lqd     $colour,784($a_surfaces)                # 295o
        fs      $half_z,$to_z,$half_z                   # 297e
        fma     $n,$unit,$k_log+4,$k_log+3              # 298e
        fma     $cosine,$normal_y,$half_y,$cosine       # 299e
        fma     $squared,$half_y,$half_y,$squared       # 300e
        fma     $colour,$colour,$diffuse,$highlight     # 301e
        lqd     $diffuse,864($a_surfaces)               # 301o
        lqd     $highlight,928($a_surfaces)             # 302o
        stqd    $lit,0x590($a_surfaces)                 # 303o
        fma     $n,$unit,$n,$k_log+2                    # 304e
        lqd     $lit,0x5d0($a_surfaces)                 # 304o
        fma     $cosine,$normal_z,$half_z,$cosine       # 305e
        fma     $squared,$half_z,$half_z,$squared       # 306e
        fm      $diffuse,$diffuse,$t_c                  # 307e
        lqd     $t_c,496($a_shadow)                     # 307o
        fma     $n,$unit,$n,$k_log+1                    # 310e
        lnop                                            # 310o pairing
        fma     $lit,$bright_blue,$colour,$lit          # 311e
        lqd     $colour,672($a_surfaces)                # 311o
        frest   $t_y,$squared                           # 312o
        and     $diffuse,$diffuse,$reached              # 313e
        ceq     $t_c,$t_c,$background                   # 314e
        fma     $n,$unit,$n,$k_log                      # 316e
        fi      $t_y,$squared,$t_y                      # 317e
        stqd    $lit,0x5d0($a_surfaces)                 # 317o
        lqd     $lit,0x560($a_surfaces)                 # 318o
        fms     $n,$unit,$n,$power                      # 322e
        fm      $n,$n,$exponent                         # 328e
        lqd     $exponent,1008($a_surfaces)             # 328o
        cfltu   $whole,$n,23                            # 334e
        xor     $exponent,$exponent,$m_sign             # 335e
        selb    $fraction,$k_one,$whole,$m_fraction     # 341e
        clgt    $t_e,$k_none,$whole                     # 342e
        fma     $result,$fraction,$k_exp+3,$k_exp+2     # 343e
        andc    $whole,$whole,$m_fraction               # 344e
        fma     $result,$fraction,$result,$k_exp+1      # 349e
        fma     $result,$fraction,$result,$k_exp        # 355e
        sf      $result,$whole,$result                  # 361e
        and     $result,$result,$t_e                    # 363e
        cgti    $t_e,$cosine,-1                         # 364e
        fm      $highlight,$highlight,$result           # 365e
        and     $cosine,$cosine,$t_e                    # 366e
        fnms    $t_e,$squared,$t_y,$k_one               # 367e
        fm      $cosine,$cosine,$cosine                 # 368e
        lnop                                            # 368o pairing
        and     $highlight,$highlight,$reached          # 371e
        lqd     $reached,432($a_shadow)                 # 371o
        fma     $inverse,$t_e,$t_y,$t_y                 # 373e
        fma     $colour,$colour,$diffuse,$highlight     # 374e
        cgti    $reached,$reached,-1                    # 377e
        fm      $quotient,$cosine,$inverse              # 379e
        fma     $lit,$bright_red,$colour,$lit           # 380e
        lqd     $colour,736($a_surfaces)                # 380o
        and     $reached,$reached,$t_c                  # 381e
        fm      $t_c,$normal_x,$to_x                    # 382e
        sf      $power,$quotient,$k_root2               # 385e
        lnop                                            # 385o pairing
        fma     $colour,$colour,$diffuse,$highlight     # 386e
        stqd    $lit,0x560($a_surfaces)                 # 386o
        rotmai  $power,$power,-23                       # 387e
        lqd     $lit,0x5a0($a_surfaces)                 # 387o
        fma     $t_c,$normal_y,$to_y,$t_c               # 388e
        shli    $mantissa,$power,23                     # 391e
        csflt   $power,$power,1                         # 392e
        lnop                                            # 392o pairing
        fma     $lit,$bright_green,$colour,$lit         # 394e
        lqd     $colour,800($a_surfaces)                # 394o
        a       $mantissa,$mantissa,$quotient           # 395e
        fma     $t_c,$normal_z,$to_z,$t_c               # 396e
        fs      $unit,$mantissa,$k_one                  # 397e
        lnop                                            # 397o pairing
        fma     $colour,$colour,$diffuse,$highlight     # 400e
        stqd    $lit,0x5a0($a_surfaces)                 # 400o
        lqd     $lit,0x5e0($a_surfaces)                 # 401o
        lqd     $highlight,944($a_surfaces)             # 402o
        fma     $n,$unit,$k_log+4,$k_log+3              # 403e
        lqd     $diffuse,880($a_surfaces)               # 403o
        fma     $lit,$bright_blue,$colour,$lit          # 407e
        lqd     $colour,688($a_surfaces)                # 407o
        fma     $n,$unit,$n,$k_log+2                    # 409e
        fm      $diffuse,$diffuse,$t_c                  # 410e
        stqd    $lit,0x5e0($a_surfaces)                 # 413o
        lqd     $lit,0x570($a_surfaces)                 # 414o
        fma     $n,$unit,$n,$k_log+1                    # 415e
        hbrr    next_site_short_back,next_site_short    # 415o hint
        and     $diffuse,$diffuse,$reached              # 416e
        fma     $n,$unit,$n,$k_log                      # 421e
        fms     $n,$unit,$n,$power                      # 427e
        fm      $n,$n,$exponent                         # 433e
        cfltu   $whole,$n,23                            # 439e
        selb    $fraction,$k_one,$whole,$m_fraction     # 446e
        clgt    $t_e,$k_none,$whole                     # 447e
        fma     $result,$fraction,$k_exp+3,$k_exp+2     # 448e
        andc    $whole,$whole,$m_fraction               # 449e
        fma     $result,$fraction,$result,$k_exp+1      # 454e
        fma     $result,$fraction,$result,$k_exp        # 460e
        sf      $result,$whole,$result                  # 466e
        and     $result,$result,$t_e                    # 468e
        fm      $highlight,$highlight,$result           # 470e
        and     $highlight,$highlight,$reached          # 476e
        fma     $colour,$colour,$diffuse,$highlight     # 478e
        fma     $lit,$bright_red,$colour,$lit           # 484e
        lqd     $colour,752($a_surfaces)                # 484o
        fma     $colour,$colour,$diffuse,$highlight     # 490e
        stqd    $lit,0x570($a_surfaces)                 # 490o
        nop     $127                                    # 491e pairing
        lqd     $lit,0x5b0($a_surfaces)                 # 491o
        fma     $lit,$bright_green,$colour,$lit         # 497e
        lqd     $colour,816($a_surfaces)                # 497o
        fma     $colour,$colour,$diffuse,$highlight     # 503e
        stqd    $lit,0x5b0($a_surfaces)                 # 503o
        lqd     $lit,0x5f0($a_surfaces)                 # 504o
        fma     $lit,$bright_blue,$colour,$lit          # 510e
        stqd    $lit,0x5f0($a_surfaces)                 # 516o
next_site_short_back:
        brnz    $count,next_site_short                  # 517o
        nop     $127                                    # 518e pairing
        bi      $lr                                     # 518o
endfunction light_r16
