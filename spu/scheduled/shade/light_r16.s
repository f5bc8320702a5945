# light_r16   what a light adds to surfaces: Lambert's share and Blinn's highlight
#   C       void light_r16(const struct site *, int count, const struct light *,
#                          const struct object *background, const struct ray_packet *);
#   In      $3 sites, $4 count (at least 1), $5 light, $6 the background's object, $7 the
#           sites' packets of shadow rays, one behind the other; pointers 16-aligned
#   Out     the sites' surfaces: lit, in lanes whose shadow ray is there (t >= 0) and has met
#           nothing
#   Uses    $2-$67, $79   Saves  -   Stack  0   Calls  -
#   Domain  N.L >= 0 and N.d <= 0 where there is a shadow ray; shares from 0 to 1; N, L, d of
#           length 1 within 8 ulp; exponent 0, or from 0.25 to 4096
#   Error   0.6 thousandths of the brightness, exponents to 1000; 1.5 to 4096
#   Twin    lab/twins/src/light.rs
#
#   lit += brightness (diffuse (N.L) colour + highlight (N.H)^exponent)
# For H = L - d, without a root or a unit vector:
#   q = (N.H)^2 / |H|^2                      the square of the cosine: N.H is at least 0
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
        .set    k_one,27
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

# $result = 2^(-$n $exponent)
.macro  exp2_of_product
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
        .set m_lane_2,2; .set m_lane_3,5; .set count_2,79; .set to_x_2,13; .set to_x_3,15
        .set to_x_4,17; .set to_y_2,18; .set to_y_3,20; .set to_y_4,25; .set to_y_5,43
        .set half_x_2,19; .set half_x_3,16; .set half_x_4,24; .set half_y_2,23; .set half_y_3,42
        .set half_y_4,45; .set half_z_2,47; .set to_z_2,48; .set half_z_3,50; .set to_z_3,51
        .set half_z_4,52; .set squared_2,49; .set to_z_4,53; .set to_z_5,55; .set squared_3,46
        .set half_z_5,11; .set squared_4,21; .set normal_x_2,58; .set normal_x_3,59
        .set normal_x_4,60; .set normal_x_5,61; .set normal_y_2,62; .set normal_y_3,63
        .set normal_y_4,64; .set a_surfaces_2,66; .set lit_2,67; .set cosine_2,40; .set cosine_3,5
        .set squared_5,24; .set reached_2,46; .set cosine_4,19; .set t_y_2,65; .set cosine_5,16
        .set cosine_6,22; .set t_y_3,56; .set t_c_2,17; .set t_y_4,40; .set colour_2,59
        .set t_c_3,13; .set t_y_5,41; .set cosine_7,2; .set normal_y_5,19; .set t_y_6,42
        .set normal_z_2,45; .set t_y_7,54; .set normal_z_3,56; .set colour_3,58; .set lit_3,65
        .set normal_z_4,23; .set t_e_2,11; .set normal_z_5,21; .set t_e_3,24; .set t_e_4,47
        .set t_e_5,44; .set inverse_2,24; .set inverse_3,40; .set inverse_4,41; .set inverse_5,11
        .set t_c_4,42; .set quotient_2,5; .set t_c_5,14; .set t_c_6,15; .set quotient_3,16
        .set quotient_4,2; .set quotient_5,11; .set power_2,18; .set power_3,19; .set power_4,22
        .set mantissa_2,2; .set mantissa_3,5; .set unit_2,11; .set unit_3,2; .set unit_4,5
        .set reached_3,15; .set unit_5,16; .set colour_4,57; .set lit_4,62; .set n_2,24
        .set n_3,40; .set n_4,41; .set colour_5,43; .set lit_5,63; .set n_5,20; .set reached_4,41
        .set t_c_7,23; .set highlight_2,55; .set colour_6,45; .set colour_7,48; .set reached_5,11
        .set exponent_2,19; .set n_6,5; .set t_c_8,22; .set reached_6,21; .set t_c_9,41; .set n_7,2
        .set exponent_3,24; .set t_c_10,40; .set diffuse_2,42; .set t_c_11,19; .set colour_8,22
        .set reached_7,19; .set t_c_12,21; .set diffuse_3,41; .set diffuse_4,17; .set diffuse_5,18
        .set whole_2,5; .set whole_3,2; .set reached_8,24; .set colour_9,46; .set diffuse_6,13
        .set fraction_2,16; .set fraction_3,18; .set result_2,20; .set result_3,21; .set whole_4,23
        .set t_e_6,5; .set whole_5,44; .set result_4,16; .set colour_10,20; .set result_5,18
        .set diffuse_7,21; .set lit_6,25; .set diffuse_8,14; .set lit_7,44; .set reached_9,60
        .set lit_8,40; .set diffuse_9,11; .set highlight_3,13; .set lit_9,23; .set lit_10,16
        .set result_6,5; .set lit_11,18; .set highlight_4,2; .set lit_12,17; .set lit_13,15
        .set diffuse_10,61; .set colour_11,14; .set colour_12,41; .set colour_13,11
        .set colour_14,19; .set colour_15,2; .set lit_14,5; .set lit_15,2; .set colour_16,23
        .set lit_16,21; .set highlight_5,54; .set colour_17,56; .set colour_18,54; .set lit_17,56
        .set lit_18,57; .set lit_19,54; .set colour_19,3; .set lit_20,3; .set colour_20,4
        .set colour_21,5; .set lit_21,6; .set colour_22,7
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
        il      $step,640                               # 18e
        ilhu    $k_one,0x3f80                           # 19e
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
        lqd     $to_x,240($a_shadow)                    # 33o
        lqd     $to_x_2,208($a_shadow)                  # 34o
        lqd     $to_x_3,192($a_shadow)                  # 35o
        lqd     $to_x_4,224($a_shadow)                  # 36o
        lqd     $to_y_2,304($a_shadow)                  # 37o
        rotqbyi $a_rays,$a_surfaces,4                   # 38o
        lqd     $to_y_3,272($a_shadow)                  # 39o
        lqd     $to_y_4,256($a_shadow)                  # 40o
        lqd     $to_y_5,288($a_shadow)                  # 41o
        lqd     $half_x,208($a_rays)                    # 42o
        lqd     $half_x_2,224($a_rays)                  # 43o
        lqd     $half_x_3,240($a_rays)                  # 44o
        lqd     $half_x_4,192($a_rays)                  # 45o
        lqd     $half_y,272($a_rays)                    # 46o
        lqd     $half_y_2,304($a_rays)                  # 47o
        fs      $half_x,$to_x_2,$half_x                 # 48e
        lqd     $half_y_3,256($a_rays)                  # 48o
        fs      $half_x_2,$to_x_4,$half_x_2             # 49e
        lqd     $half_y_4,288($a_rays)                  # 49o
        fs      $half_x_3,$to_x,$half_x_3               # 50e
        lqd     $half_z_2,336($a_rays)                  # 50o
        fs      $half_x_4,$to_x_3,$half_x_4             # 51e
        lqd     $to_z_2,368($a_shadow)                  # 51o
        fs      $half_y,$to_y_3,$half_y                 # 52e
        lqd     $half_z_3,368($a_rays)                  # 52o
        fs      $half_y_2,$to_y_2,$half_y_2             # 53e
        lqd     $to_z_3,352($a_shadow)                  # 53o
        fs      $half_y_3,$to_y_4,$half_y_3             # 54e
        lqd     $half_z_4,352($a_rays)                  # 54o
        fm      $squared_2,$half_x_2,$half_x_2          # 55e
        lqd     $to_z_4,336($a_shadow)                  # 55o
        fm      $squared,$half_x_3,$half_x_3            # 56e
        lqd     $to_z_5,320($a_shadow)                  # 56o
        fm      $squared_3,$half_x_4,$half_x_4          # 57e
        lqd     $half_z_5,320($a_rays)                  # 57o
        fm      $squared_4,$half_x,$half_x              # 58e
        lqd     $normal_x_2,208($a_surfaces)            # 58o
        fs      $half_y_4,$to_y_5,$half_y_4             # 59e
        lqd     $normal_x_3,224($a_surfaces)            # 59o
        fs      $half_z_3,$to_z_2,$half_z_3             # 60e
        lqd     $normal_x_4,192($a_surfaces)            # 60o
        fs      $half_z_4,$to_z_3,$half_z_4             # 61e
        lqd     $normal_x_5,240($a_surfaces)            # 61o
        fma     $squared,$half_y_2,$half_y_2,$squared   # 62e
        lqd     $normal_y_2,256($a_surfaces)            # 62o
        fs      $half_z_2,$to_z_4,$half_z_2             # 63e
        lqd     $normal_y_3,288($a_surfaces)            # 63o
        fma     $squared_4,$half_y,$half_y,$squared_4   # 64e
        lqd     $normal_y_4,272($a_surfaces)            # 64o
        fma     $squared_2,$half_y_4,$half_y_4,$squared_2 # 65e
        shlqbyi $a_surfaces_2,$a_surfaces,0             # 65o copy
        fma     $squared_3,$half_y_3,$half_y_3,$squared_3 # 66e
        lqd     $lit_2,0x540($a_surfaces)               # 66o
        fs      $half_z_5,$to_z_5,$half_z_5             # 67e
        fma     $squared,$half_z_3,$half_z_3,$squared   # 68e
        fm      $cosine_2,$normal_x_2,$half_x           # 69e
        fma     $squared_4,$half_z_2,$half_z_2,$squared_4 # 70e
        fma     $squared_2,$half_z_4,$half_z_4,$squared_2 # 71e
        fm      $cosine_3,$normal_x_4,$half_x_4         # 72e
        fma     $squared_5,$half_z_5,$half_z_5,$squared_3 # 73e
        lqd     $reached_2,384($a_shadow)               # 73o
        fm      $cosine_4,$normal_x_3,$half_x_2         # 74e
        frest   $t_y_2,$squared                         # 74o
        fm      $cosine_5,$normal_x_5,$half_x_3         # 75e
        lnop                                            # 75o pairing
        fma     $cosine_6,$normal_y_4,$half_y,$cosine_2 # 76e
        frest   $t_y_3,$squared_4                       # 76o
        fm      $t_c_2,$normal_x_3,$to_x_4              # 77e
        frest   $t_y_4,$squared_2                       # 77o
        fma     $cosine_3,$normal_y_2,$half_y_3,$cosine_3 # 78e
        lqd     $colour_2,816($a_surfaces)              # 78o
        fm      $t_c_3,$normal_x_2,$to_x_2              # 79e
        frest   $t_y_5,$squared_5                       # 79o
        fma     $cosine_7,$normal_y_3,$half_y_4,$cosine_4 # 80e
        lqd     $normal_y_5,304($a_surfaces)            # 80o
        fi      $t_y_6,$squared_4,$t_y_3                # 81e
        lqd     $normal_z_2,320($a_surfaces)            # 81o
        fi      $t_y_7,$squared,$t_y_2                  # 82e
        lqd     $normal_z_3,336($a_surfaces)            # 82o
        fi      $t_y_5,$squared_5,$t_y_5                # 83e
        lqd     $colour_3,688($a_surfaces)              # 83o
        fi      $t_y_4,$squared_2,$t_y_4                # 84e
        lqd     $lit_3,0x570($a_surfaces)               # 84o
        cgti    $reached_2,$reached_2,-1                # 85e
        lnop                                            # 85o pairing
        fma     $cosine_5,$normal_y_5,$half_y_2,$cosine_5 # 86e
        lqd     $normal_z_4,368($a_surfaces)            # 86o
        fma     $cosine_3,$normal_z_2,$half_z_5,$cosine_3 # 87e
        lnop                                            # 87o pairing
        fnms    $t_e_2,$squared_4,$t_y_6,$k_one         # 88e
        lqd     $normal_z_5,352($a_surfaces)            # 88o
        fma     $cosine_6,$normal_z_3,$half_z_2,$cosine_6 # 89e
        fnms    $t_e_3,$squared_5,$t_y_5,$k_one         # 90e
        fnms    $t_e_4,$squared_2,$t_y_4,$k_one         # 91e
        lnop                                            # 91o pairing
        fma     $cosine_5,$normal_z_4,$half_z_3,$cosine_5 # 92e
        lqd     $exponent,992($a_surfaces)              # 92o
        fnms    $t_e_5,$squared,$t_y_7,$k_one           # 93e
        fma     $cosine_7,$normal_z_5,$half_z_4,$cosine_7 # 94e
        fm      $cosine_3,$cosine_3,$cosine_3           # 95e
        fma     $inverse_2,$t_e_3,$t_y_5,$t_y_5         # 96e
        fma     $inverse_3,$t_e_4,$t_y_4,$t_y_4         # 97e
        fm      $cosine_5,$cosine_5,$cosine_5           # 98e
        fm      $cosine_6,$cosine_6,$cosine_6           # 99e
        fma     $inverse_4,$t_e_5,$t_y_7,$t_y_7         # 100e
        fm      $cosine_7,$cosine_7,$cosine_7           # 101e
        lnop                                            # 101o pairing
        fma     $inverse_5,$t_e_2,$t_y_6,$t_y_6         # 102e
        lqd     $t_c_4,496($a_shadow)                   # 102o
        fm      $quotient_2,$cosine_3,$inverse_2        # 103e
        fm      $t_c_5,$normal_x_5,$to_x                # 104e
        fm      $t_c_6,$normal_x_4,$to_x_3              # 105e
        fm      $quotient_3,$cosine_5,$inverse_4        # 106e
        fm      $quotient_4,$cosine_7,$inverse_3        # 107e
        fm      $quotient_5,$cosine_6,$inverse_5        # 108e
        sf      $power,$quotient_2,$k_root2             # 109e
        fma     $t_c_5,$normal_y_5,$to_y_2,$t_c_5       # 110e
        andc    $power,$power,$m_fraction               # 111e
        sf      $power_2,$quotient_3,$k_root2           # 112e
        sf      $power_3,$quotient_4,$k_root2           # 113e
        andc    $power_2,$power_2,$m_fraction           # 114e
        sf      $power_4,$quotient_5,$k_root2           # 115e
        andc    $power_3,$power_3,$m_fraction           # 116e
        andc    $power_4,$power_4,$m_fraction           # 117e
        a       $mantissa,$power_3,$quotient_4          # 118e
        a       $mantissa_2,$power,$quotient_2          # 119e
        a       $mantissa_3,$power_4,$quotient_5        # 120e
        fs      $unit_2,$mantissa,$k_one                # 121e
        fs      $unit_3,$mantissa_2,$k_one              # 122e
        fs      $unit_4,$mantissa_3,$k_one              # 123e
        a       $mantissa,$power_2,$quotient_3          # 124e
        fma     $t_c,$normal_y_2,$to_y_4,$t_c_6         # 125e
        lqd     $reached_3,400($a_shadow)               # 125o
        fs      $unit_5,$mantissa,$k_one                # 126e
        lqd     $colour_4,752($a_surfaces)              # 126o
        fma     $n,$unit_2,$k_log+4,$k_log+3            # 127e
        lqd     $lit_4,0x5b0($a_surfaces)               # 127o
        fma     $n_2,$unit_3,$k_log+4,$k_log+3          # 128e
        fma     $n_3,$unit_4,$k_log+4,$k_log+3          # 129e
        csflt   $power,$power,24                        # 130e
        cgti    $reached_3,$reached_3,-1                # 131e
        fma     $n_4,$unit_5,$k_log+4,$k_log+3          # 132e
        fma     $n,$unit_2,$n,$k_log+2                  # 133e
        fma     $n_2,$unit_3,$n_2,$k_log+2              # 134e
        fma     $n_3,$unit_4,$n_3,$k_log+2              # 135e
        fma     $t_c_2,$normal_y_3,$to_y_5,$t_c_2       # 136e
        lqd     $colour_5,672($a_surfaces)              # 136o
        fma     $t_c_3,$normal_y_4,$to_y_3,$t_c_3       # 137e
        lqd     $lit_5,0x5f0($a_surfaces)               # 137o
        fma     $n_5,$unit_5,$n_4,$k_log+2              # 138e
        lqd     $reached_4,416($a_shadow)               # 138o
        fma     $n,$unit_2,$n,$k_log+1                  # 139e
        fma     $n_2,$unit_3,$n_2,$k_log+1              # 140e
        fma     $n_3,$unit_4,$n_3,$k_log+1              # 141e
        lnop                                            # 141o pairing
        fma     $t_c_5,$normal_z_4,$to_z_2,$t_c_5       # 142e
        lqd     $t_c_7,464($a_shadow)                   # 142o
        fma     $t_c,$normal_z_2,$to_z_5,$t_c           # 143e
        lqd     $highlight_2,944($a_surfaces)           # 143o
        fma     $n_5,$unit_5,$n_5,$k_log+1              # 144e
        lqd     $colour_6,784($a_surfaces)              # 144o
        fma     $n,$unit_2,$n,$k_log                    # 145e
        lqd     $colour_7,640($a_surfaces)              # 145o
        csflt   $power_3,$power_3,24                    # 146e
        csflt   $power_4,$power_4,24                    # 147e
        ceq     $t_c_7,$t_c_7,$background               # 148e
        fma     $n_3,$unit_4,$n_3,$k_log                # 149e
        fma     $n_2,$unit_3,$n_2,$k_log                # 150e
        fma     $n_5,$unit_5,$n_5,$k_log                # 151e
        fma     $t_c_3,$normal_z_3,$to_z_4,$t_c_3       # 152e
        lnop                                            # 152o pairing
        fnms    $n,$unit_2,$n,$power_3                  # 153e
        lqd     $reached_5,432($a_shadow)               # 153o
        fma     $t_c_2,$normal_z_5,$to_z_3,$t_c_2       # 154e
        lqd     $exponent_2,976($a_surfaces)            # 154o
        fnms    $n_6,$unit_4,$n_3,$power_4              # 155e
        lqd     $t_c_8,480($a_shadow)                   # 155o
        cgti    $reached_6,$reached_4,-1                # 156e
        lqd     $t_c_9,448($a_shadow)                   # 156o
        fnms    $n_7,$unit_3,$n_2,$power                # 157e
        lqd     $exponent_3,960($a_surfaces)            # 157o
        ceq     $t_c_10,$t_c_4,$background              # 158e
        lqd     $diffuse_2,864($a_surfaces)             # 158o
        cgti    $reached_5,$reached_5,-1                # 159e
        lqd     $highlight,912($a_surfaces)             # 159o
        fm      $n,$n,$exponent                         # 160e
        lqd     $exponent,1008($a_surfaces)             # 160o
        fm      $n_6,$n_6,$exponent_2                   # 161e
        lnop                                            # 161o pairing
        ceq     $t_c_11,$t_c_8,$background              # 162e
        lqd     $colour_8,720($a_surfaces)              # 162o
        fm      $n_7,$n_7,$exponent_3                   # 163e
        and     $reached_7,$reached_6,$t_c_11           # 164e
        ceq     $t_c_12,$t_c_9,$background              # 165e
        lqd     $diffuse_3,832($a_surfaces)             # 165o
        fm      $diffuse_4,$diffuse_2,$t_c_2            # 166e
        lqd     $diffuse_2,880($a_surfaces)             # 166o
        csflt   $power,$power_2,24                      # 167e
        lqd     $diffuse_5,848($a_surfaces)             # 167o
        cfltu   $whole,$n_6,23                          # 168e
        cfltu   $whole_2,$n,23                          # 169e
        cfltu   $whole_3,$n_7,23                        # 170e
        lnop                                            # 170o pairing
        and     $reached_8,$reached_2,$t_c_12           # 171e
        lqd     $colour_9,800($a_surfaces)              # 171o
        and     $reached_3,$reached_3,$t_c_7            # 172e
        fm      $diffuse_6,$diffuse_5,$t_c_3            # 173e
        fnms    $n,$unit_5,$n_5,$power                  # 174e
        selb    $fraction,$k_one,$whole,$m_fraction     # 175e
        selb    $fraction_2,$k_one,$whole_2,$m_fraction # 176e
        fma     $result,$fraction,$k_exp+3,$k_exp+2     # 177e
        selb    $fraction_3,$k_one,$whole_3,$m_fraction # 178e
        fma     $result_2,$fraction_2,$k_exp+3,$k_exp+2 # 179e
        fma     $result_3,$fraction_3,$k_exp+3,$k_exp+2 # 180e
        clgt    $t_e,$k_none,$whole_3                   # 181e
        andc    $whole_3,$whole_3,$m_fraction           # 182e
        fma     $result,$fraction,$result,$k_exp+1      # 183e
        andc    $whole_4,$whole_2,$m_fraction           # 184e
        fma     $result_2,$fraction_2,$result_2,$k_exp+1 # 185e
        fma     $result_3,$fraction_3,$result_3,$k_exp+1 # 186e
        clgt    $t_e_6,$k_none,$whole_2                 # 187e
        andc    $whole_5,$whole,$m_fraction             # 188e
        fma     $result,$fraction,$result,$k_exp        # 189e
        clgt    $t_e_4,$k_none,$whole                   # 190e
        lnop                                            # 190o pairing
        fma     $result_4,$fraction_2,$result_2,$k_exp  # 191e
        lqd     $colour_10,736($a_surfaces)             # 191o
        fma     $result_5,$fraction_3,$result_3,$k_exp  # 192e
        lnop                                            # 192o pairing
        fm      $diffuse_7,$diffuse_3,$t_c              # 193e
        lqd     $lit_6,0x5c0($a_surfaces)               # 193o
        fm      $diffuse_8,$diffuse_2,$t_c_5            # 194e
        lnop                                            # 194o pairing
        sf      $result,$whole_5,$result                # 195e
        lqd     $lit_7,0x580($a_surfaces)               # 195o
        and     $reached_9,$reached_5,$t_c_10           # 196e
        lqd     $lit_8,0x5a0($a_surfaces)               # 196o
        and     $diffuse_9,$diffuse_6,$reached_3        # 197e
        lqd     $highlight_3,928($a_surfaces)           # 197o
        and     $result,$result,$t_e_4                  # 198e
        lnop                                            # 198o pairing
        sf      $result_4,$whole_4,$result_4            # 199e
        lqd     $lit_9,0x550($a_surfaces)               # 199o
        fm      $highlight,$highlight,$result           # 200e
        lnop                                            # 200o pairing
        and     $result,$result_4,$t_e_6                # 201e
        lqd     $lit_10,0x590($a_surfaces)              # 201o
        sf      $result_6,$whole_3,$result_5            # 202e
        lqd     $lit_11,0x5e0($a_surfaces)              # 202o
        and     $diffuse_2,$diffuse_7,$reached_8        # 203e
        lqd     $colour,656($a_surfaces)                # 203o
        fm      $highlight_4,$highlight_3,$result       # 204e
        lnop                                            # 204o pairing
        and     $diffuse_6,$diffuse_4,$reached_7        # 205e
        lqd     $lit_12,0x5d0($a_surfaces)              # 205o
        and     $highlight,$highlight,$reached_3        # 206e
        lqd     $lit_13,0x560($a_surfaces)              # 206o
        and     $diffuse_10,$diffuse_8,$reached_9       # 207e
        fm      $n,$n,$exponent                         # 208e
        fma     $colour_11,$colour_6,$diffuse_9,$highlight # 209e
        lqd     $colour_6,768($a_surfaces)              # 209o
        fma     $colour_12,$colour,$diffuse_9,$highlight # 210e
        and     $highlight_4,$highlight_4,$reached_7    # 211e
        a       $a_shadow,$a_shadow,$step               # 212e
        lnop                                            # 212o pairing
        fma     $colour_13,$colour_8,$diffuse_9,$highlight # 213e
        lqd     $highlight,896($a_surfaces)             # 213o
        fma     $colour_14,$colour_10,$diffuse_6,$highlight_4 # 214e
        lqd     $colour_10,704($a_surfaces)             # 214o
        fma     $lit,$bright_blue,$colour_11,$lit_12    # 215e
        lnop                                            # 215o pairing
next_site:
            fma     $colour,$colour_5,$diffuse_6,$highlight_4 # 0e
            fma     $colour_15,$colour_9,$diffuse_6,$highlight_4 # 1e
            cfltu   $whole,$n,23                        # 2e
        lqd     $a_surfaces,0($a_site)                  # 2o
            and     $result,$result_6,$t_e              # 3e
        ai      $count,$count,-1                        # 4e
        ai      $a_site,$a_site,16                      # 5e
            stqd    $lit,0x5d0($a_surfaces_2)           # 5o
            fma     $lit,$bright_red,$colour,$lit_13    # 6e
            lnop                                        # 6o pairing
            fma     $lit_14,$bright_green,$colour_13,$lit_10 # 7e
        lqd     $to_x,240($a_shadow)                    # 7o
            fm      $highlight,$highlight,$result       # 8e
        rotqbyi $a_rays,$a_surfaces,4                   # 8o
            fma     $lit_15,$bright_blue,$colour_15,$lit_11 # 9e
        lqd     $to_x_2,208($a_shadow)                  # 9o
            selb    $fraction,$k_one,$whole,$m_fraction # 10e
        lqd     $to_x_3,192($a_shadow)                  # 10o
            fma     $lit_10,$bright_green,$colour_14,$lit_8 # 11e
        lqd     $to_x_4,224($a_shadow)                  # 11o
            fma     $result,$fraction,$k_exp+3,$k_exp+2 # 12e
        lqd     $to_y_2,304($a_shadow)                  # 12o
            clgt    $t_e,$k_none,$whole                 # 13e
            stqd    $lit_14,0x590($a_surfaces_2)        # 13o
            and     $highlight,$highlight,$reached_8    # 14e
        lqd     $half_x,208($a_rays)                    # 14o
            fma     $lit_14,$bright_red,$colour_12,$lit_9 # 15e
        lqd     $half_x_2,224($a_rays)                  # 15o
            fma     $colour,$colour_10,$diffuse_2,$highlight # 16e
        lqd     $to_y_3,272($a_shadow)                  # 16o
            fma     $colour_16,$colour_6,$diffuse_2,$highlight # 17e
            stqd    $lit_10,0x5a0($a_surfaces_2)        # 17o
            fma     $result,$fraction,$result,$k_exp+1  # 18e
        lqd     $half_x_3,240($a_rays)                  # 18o
            andc    $whole,$whole,$m_fraction           # 19e
        lqd     $half_x_4,192($a_rays)                  # 19o
        fs      $half_x,$to_x_2,$half_x                 # 20e
        lqd     $half_y,272($a_rays)                    # 20o
        fs      $half_x_2,$to_x_4,$half_x_2             # 21e
            stqd    $lit_15,0x5e0($a_surfaces_2)        # 21o
            fma     $colour_15,$colour_7,$diffuse_2,$highlight # 22e
            stqd    $lit_14,0x550($a_surfaces_2)        # 22o
            fma     $lit_14,$bright_blue,$colour_16,$lit_6 # 23e
        lqd     $half_y_2,304($a_rays)                  # 23o
        fs      $half_x_3,$to_x,$half_x_3               # 24e
        lnop                                            # 24o pairing
        fs      $half_x_4,$to_x_3,$half_x_4             # 25e
        lqd     $to_y_4,256($a_shadow)                  # 25o
        fs      $half_y,$to_y_3,$half_y                 # 26e
        lqd     $half_y_3,256($a_rays)                  # 26o
            fma     $lit_16,$bright_green,$colour,$lit_7 # 27e
            fma     $result,$fraction,$result,$k_exp    # 28e
        fs      $half_y_2,$to_y_2,$half_y_2             # 29e
        lqd     $to_y_5,288($a_shadow)                  # 29o
        fm      $squared,$half_x_3,$half_x_3            # 30e
        lqd     $half_y_4,288($a_rays)                  # 30o
        fm      $squared_3,$half_x_4,$half_x_4          # 31e
        lqd     $half_z_2,336($a_rays)                  # 31o
        fs      $half_y_3,$to_y_4,$half_y_3             # 32e
        lqd     $to_z_2,368($a_shadow)                  # 32o
        fm      $squared_2,$half_x_2,$half_x_2          # 33e
        lqd     $half_z_3,368($a_rays)                  # 33o
            sf      $result,$whole,$result              # 34e
            stqd    $lit_16,0x580($a_surfaces_2)        # 34o
        fm      $squared_4,$half_x,$half_x              # 35e
        lqd     $to_z_3,352($a_shadow)                  # 35o
            and     $result,$result,$t_e                # 36e
        lqd     $half_z_4,352($a_rays)                  # 36o
        fs      $half_y_4,$to_y_5,$half_y_4             # 37e
        lqd     $to_z_4,336($a_shadow)                  # 37o
            fm      $highlight_5,$highlight_2,$result   # 38e
        fma     $squared,$half_y_2,$half_y_2,$squared   # 39e
        fs      $half_z_3,$to_z_2,$half_z_3             # 40e
        fma     $squared_4,$half_y,$half_y,$squared_4   # 41e
        fs      $half_z_4,$to_z_3,$half_z_4             # 42e
        fs      $half_z_2,$to_z_4,$half_z_2             # 43e
            and     $highlight_5,$highlight_5,$reached_9 # 44e
        lqd     $to_z_5,320($a_shadow)                  # 44o
        fma     $squared_2,$half_y_4,$half_y_4,$squared_2 # 45e
        lqd     $half_z_5,320($a_rays)                  # 45o
            fma     $colour_17,$colour_4,$diffuse_10,$highlight_5 # 46e
            fma     $colour_4,$colour_2,$diffuse_10,$highlight_5 # 47e
            fma     $colour_18,$colour_3,$diffuse_10,$highlight_5 # 48e
            lnop                                        # 48o pairing
        fma     $squared,$half_z_3,$half_z_3,$squared   # 49e
        lqd     $normal_x_2,208($a_surfaces)            # 49o
        fma     $squared_3,$half_y_3,$half_y_3,$squared_3 # 50e
        lqd     $normal_x_3,224($a_surfaces)            # 50o
        fs      $half_z_5,$to_z_5,$half_z_5             # 51e
        lqd     $normal_x_4,192($a_surfaces)            # 51o
            fma     $lit_17,$bright_green,$colour_17,$lit_4 # 52e
        lqd     $normal_x_5,240($a_surfaces)            # 52o
            fma     $lit_18,$bright_blue,$colour_4,$lit_5 # 53e
        lqd     $normal_y_2,256($a_surfaces)            # 53o
        fma     $squared_4,$half_z_2,$half_z_2,$squared_4 # 54e
        lqd     $normal_y_3,288($a_surfaces)            # 54o
        fm      $cosine_2,$normal_x_2,$half_x           # 55e
        lqd     $normal_y_4,272($a_surfaces)            # 55o
            fma     $lit_19,$bright_red,$colour_18,$lit_3 # 56e
        frest   $t_y_2,$squared                         # 56o
        fma     $squared_2,$half_z_4,$half_z_4,$squared_2 # 57e
            stqd    $lit_14,0x5c0($a_surfaces_2)        # 57o
        fm      $cosine_3,$normal_x_4,$half_x_4         # 58e
            stqd    $lit_17,0x5b0($a_surfaces_2)        # 58o
        fma     $squared_5,$half_z_5,$half_z_5,$squared_3 # 59e
            stqd    $lit_18,0x5f0($a_surfaces_2)        # 59o
            fma     $lit_15,$bright_red,$colour_15,$lit_2 # 60e
        lqd     $reached_2,384($a_shadow)               # 60o
        fm      $cosine_4,$normal_x_3,$half_x_2         # 61e
        frest   $t_y_3,$squared_4                       # 61o
        fm      $cosine_5,$normal_x_5,$half_x_3         # 62e
            stqd    $lit,0x560($a_surfaces_2)           # 62o
        fma     $cosine_6,$normal_y_4,$half_y,$cosine_2 # 63e
        frest   $t_y_4,$squared_2                       # 63o
        fma     $cosine_3,$normal_y_2,$half_y_3,$cosine_3 # 64e
            stqd    $lit_19,0x570($a_surfaces_2)        # 64o
        fm      $t_c_2,$normal_x_3,$to_x_4              # 65e
        frest   $t_y_5,$squared_5                       # 65o
        fm      $t_c_3,$normal_x_2,$to_x_2              # 66e
            stqd    $lit_15,0x540($a_surfaces_2)        # 66o
        fma     $cosine_7,$normal_y_3,$half_y_4,$cosine_4 # 67e
        lqd     $normal_y_5,304($a_surfaces)            # 67o
        fi      $t_y_6,$squared_4,$t_y_3                # 68e
        lqd     $normal_z_2,320($a_surfaces)            # 68o
        fi      $t_y_7,$squared,$t_y_2                  # 69e
        lnop                                            # 69o pairing
        fi      $t_y_5,$squared_5,$t_y_5                # 70e
        lqd     $normal_z_3,336($a_surfaces)            # 70o
        fi      $t_y_4,$squared_2,$t_y_4                # 71e
        cgti    $reached_2,$reached_2,-1                # 72e
        fma     $cosine_5,$normal_y_5,$half_y_2,$cosine_5 # 73e
        lqd     $normal_z_4,368($a_surfaces)            # 73o
        fma     $cosine_3,$normal_z_2,$half_z_5,$cosine_3 # 74e
        lnop                                            # 74o pairing
        fnms    $t_e_2,$squared_4,$t_y_6,$k_one         # 75e
        lqd     $normal_z_5,352($a_surfaces)            # 75o
        fma     $cosine_6,$normal_z_3,$half_z_2,$cosine_6 # 76e
        fnms    $t_e_3,$squared_5,$t_y_5,$k_one         # 77e
        fnms    $t_e_4,$squared_2,$t_y_4,$k_one         # 78e
        fma     $cosine_5,$normal_z_4,$half_z_3,$cosine_5 # 79e
        fnms    $t_e_5,$squared,$t_y_7,$k_one           # 80e
        fma     $cosine_7,$normal_z_5,$half_z_4,$cosine_7 # 81e
        fm      $cosine_3,$cosine_3,$cosine_3           # 82e
        fma     $inverse_2,$t_e_3,$t_y_5,$t_y_5         # 83e
        fma     $inverse_3,$t_e_4,$t_y_4,$t_y_4         # 84e
        fm      $cosine_5,$cosine_5,$cosine_5           # 85e
        fm      $cosine_6,$cosine_6,$cosine_6           # 86e
        shlqbyi $a_surfaces_2,$a_surfaces,0             # 86o copy
        fma     $inverse_4,$t_e_5,$t_y_7,$t_y_7         # 87e
        fm      $cosine_7,$cosine_7,$cosine_7           # 88e
        fma     $inverse_5,$t_e_2,$t_y_6,$t_y_6         # 89e
        fm      $quotient_2,$cosine_3,$inverse_2        # 90e
        fm      $t_c_5,$normal_x_5,$to_x                # 91e
        fm      $t_c_6,$normal_x_4,$to_x_3              # 92e
        fm      $quotient_3,$cosine_5,$inverse_4        # 93e
        fm      $quotient_4,$cosine_7,$inverse_3        # 94e
        fm      $quotient_5,$cosine_6,$inverse_5        # 95e
        sf      $power,$quotient_2,$k_root2             # 96e
        fma     $t_c_5,$normal_y_5,$to_y_2,$t_c_5       # 97e
        andc    $power,$power,$m_fraction               # 98e
        sf      $power_2,$quotient_3,$k_root2           # 99e
        sf      $power_3,$quotient_4,$k_root2           # 100e
        andc    $power_2,$power_2,$m_fraction           # 101e
        sf      $power_4,$quotient_5,$k_root2           # 102e
        andc    $power_3,$power_3,$m_fraction           # 103e
        andc    $power_4,$power_4,$m_fraction           # 104e
        a       $mantissa,$power_3,$quotient_4          # 105e
        a       $mantissa_2,$power,$quotient_2          # 106e
        a       $mantissa_3,$power_4,$quotient_5        # 107e
        fs      $unit_2,$mantissa,$k_one                # 108e
        fs      $unit_3,$mantissa_2,$k_one              # 109e
        fs      $unit_4,$mantissa_3,$k_one              # 110e
        a       $mantissa,$power_2,$quotient_3          # 111e
        lnop                                            # 111o pairing
        fma     $t_c,$normal_y_2,$to_y_4,$t_c_6         # 112e
        lqd     $reached_3,400($a_shadow)               # 112o
        fs      $unit_5,$mantissa,$k_one                # 113e
        fma     $n,$unit_2,$k_log+4,$k_log+3            # 114e
        fma     $n_2,$unit_3,$k_log+4,$k_log+3          # 115e
        fma     $n_3,$unit_4,$k_log+4,$k_log+3          # 116e
        csflt   $power,$power,24                        # 117e
        cgti    $reached_3,$reached_3,-1                # 118e
        fma     $n_4,$unit_5,$k_log+4,$k_log+3          # 119e
        fma     $n,$unit_2,$n,$k_log+2                  # 120e
        fma     $n_2,$unit_3,$n_2,$k_log+2              # 121e
        fma     $n_3,$unit_4,$n_3,$k_log+2              # 122e
        fma     $t_c_2,$normal_y_3,$to_y_5,$t_c_2       # 123e
        fma     $t_c_3,$normal_y_4,$to_y_3,$t_c_3       # 124e
        fma     $n_5,$unit_5,$n_4,$k_log+2              # 125e
        fma     $n,$unit_2,$n,$k_log+1                  # 126e
        fma     $n_2,$unit_3,$n_2,$k_log+1              # 127e
        fma     $n_3,$unit_4,$n_3,$k_log+1              # 128e
        fma     $t_c_5,$normal_z_4,$to_z_2,$t_c_5       # 129e
        lqd     $t_c_7,464($a_shadow)                   # 129o
        fma     $t_c,$normal_z_2,$to_z_5,$t_c           # 130e
        fma     $n_5,$unit_5,$n_5,$k_log+1              # 131e
        fma     $n,$unit_2,$n,$k_log                    # 132e
        csflt   $power_3,$power_3,24                    # 133e
        csflt   $power_4,$power_4,24                    # 134e
        ceq     $t_c_7,$t_c_7,$background               # 135e
        fma     $n_3,$unit_4,$n_3,$k_log                # 136e
        lnop                                            # 136o pairing
        fma     $n_2,$unit_3,$n_2,$k_log                # 137e
        lqd     $reached_4,416($a_shadow)               # 137o
        fma     $n_5,$unit_5,$n_5,$k_log                # 138e
        lnop                                            # 138o pairing
        fma     $t_c_3,$normal_z_3,$to_z_4,$t_c_3       # 139e
        lqd     $t_c_4,496($a_shadow)                   # 139o
        fnms    $n,$unit_2,$n,$power_3                  # 140e
        lqd     $reached_5,432($a_shadow)               # 140o
        fma     $t_c_2,$normal_z_5,$to_z_3,$t_c_2       # 141e
        lqd     $exponent,992($a_surfaces)              # 141o
        fnms    $n_6,$unit_4,$n_3,$power_4              # 142e
        lqd     $exponent_2,976($a_surfaces)            # 142o
        cgti    $reached_6,$reached_4,-1                # 143e
        lqd     $t_c_8,480($a_shadow)                   # 143o
        fnms    $n_7,$unit_3,$n_2,$power                # 144e
        lqd     $exponent_3,960($a_surfaces)            # 144o
        ceq     $t_c_10,$t_c_4,$background              # 145e
        lnop                                            # 145o pairing
        cgti    $reached_5,$reached_5,-1                # 146e
        lqd     $t_c_9,448($a_shadow)                   # 146o
        fm      $n,$n,$exponent                         # 147e
        lqd     $diffuse_2,864($a_surfaces)             # 147o
        fm      $n_6,$n_6,$exponent_2                   # 148e
        ceq     $t_c_11,$t_c_8,$background              # 149e
        fm      $n_7,$n_7,$exponent_3                   # 150e
        and     $reached_7,$reached_6,$t_c_11           # 151e
        ceq     $t_c_12,$t_c_9,$background              # 152e
        fm      $diffuse_4,$diffuse_2,$t_c_2            # 153e
        csflt   $power,$power_2,24                      # 154e
        lqd     $diffuse_5,848($a_surfaces)             # 154o
        cfltu   $whole,$n_6,23                          # 155e
        cfltu   $whole_2,$n,23                          # 156e
        cfltu   $whole_3,$n_7,23                        # 157e
        and     $reached_8,$reached_2,$t_c_12           # 158e
        and     $reached_3,$reached_3,$t_c_7            # 159e
        fm      $diffuse_6,$diffuse_5,$t_c_3            # 160e
        fnms    $n,$unit_5,$n_5,$power                  # 161e
        selb    $fraction,$k_one,$whole,$m_fraction     # 162e
        selb    $fraction_2,$k_one,$whole_2,$m_fraction # 163e
        fma     $result,$fraction,$k_exp+3,$k_exp+2     # 164e
        selb    $fraction_3,$k_one,$whole_3,$m_fraction # 165e
        fma     $result_2,$fraction_2,$k_exp+3,$k_exp+2 # 166e
        fma     $result_3,$fraction_3,$k_exp+3,$k_exp+2 # 167e
        clgt    $t_e,$k_none,$whole_3                   # 168e
        andc    $whole_3,$whole_3,$m_fraction           # 169e
        lnop                                            # 169o pairing
        fma     $result,$fraction,$result,$k_exp+1      # 170e
        lqd     $colour_8,720($a_surfaces)              # 170o
        andc    $whole_4,$whole_2,$m_fraction           # 171e
        lqd     $highlight_2,944($a_surfaces)           # 171o
        fma     $result_2,$fraction_2,$result_2,$k_exp+1 # 172e
        lqd     $diffuse_3,832($a_surfaces)             # 172o
        fma     $result_3,$fraction_3,$result_3,$k_exp+1 # 173e
        lqd     $diffuse_2,880($a_surfaces)             # 173o
        clgt    $t_e_6,$k_none,$whole_2                 # 174e
        lqd     $colour_5,672($a_surfaces)              # 174o
        andc    $whole_5,$whole,$m_fraction             # 175e
        lqd     $colour_6,784($a_surfaces)              # 175o
        fma     $result,$fraction,$result,$k_exp        # 176e
        lqd     $colour_9,800($a_surfaces)              # 176o
        clgt    $t_e_4,$k_none,$whole                   # 177e
        lqd     $colour_7,640($a_surfaces)              # 177o
        fma     $result_4,$fraction_2,$result_2,$k_exp  # 178e
        lqd     $colour_10,736($a_surfaces)             # 178o
        fma     $result_5,$fraction_3,$result_3,$k_exp  # 179e
        lqd     $colour_3,688($a_surfaces)              # 179o
        fm      $diffuse_7,$diffuse_3,$t_c              # 180e
        lqd     $colour_4,752($a_surfaces)              # 180o
        fm      $diffuse_8,$diffuse_2,$t_c_5            # 181e
        lqd     $highlight,912($a_surfaces)             # 181o
        sf      $result,$whole_5,$result                # 182e
        lqd     $colour_2,816($a_surfaces)              # 182o
        and     $reached_9,$reached_5,$t_c_10           # 183e
        lqd     $lit_2,0x540($a_surfaces)               # 183o
        and     $diffuse_9,$diffuse_6,$reached_3        # 184e
        lqd     $highlight_3,928($a_surfaces)           # 184o
        and     $result,$result,$t_e_4                  # 185e
        hbrr    next_site_back,next_site                # 185o hint
        sf      $result_4,$whole_4,$result_4            # 186e
        lqd     $lit_6,0x5c0($a_surfaces)               # 186o
        fm      $highlight,$highlight,$result           # 187e
        lqd     $lit_3,0x570($a_surfaces)               # 187o
        and     $result,$result_4,$t_e_6                # 188e
        lqd     $lit_7,0x580($a_surfaces)               # 188o
        sf      $result_6,$whole_3,$result_5            # 189e
        lqd     $exponent,1008($a_surfaces)             # 189o
        and     $diffuse_2,$diffuse_7,$reached_8        # 190e
        lqd     $lit_10,0x590($a_surfaces)              # 190o
        fm      $highlight_4,$highlight_3,$result       # 191e
        lqd     $colour,656($a_surfaces)                # 191o
        and     $diffuse_6,$diffuse_4,$reached_7        # 192e
        lqd     $lit_12,0x5d0($a_surfaces)              # 192o
        and     $highlight,$highlight,$reached_3        # 193e
        lqd     $lit_13,0x560($a_surfaces)              # 193o
        and     $diffuse_10,$diffuse_8,$reached_9       # 194e
        lqd     $lit_9,0x550($a_surfaces)               # 194o
        fm      $n,$n,$exponent                         # 195e
        lqd     $lit_11,0x5e0($a_surfaces)              # 195o
        fma     $colour_11,$colour_6,$diffuse_9,$highlight # 196e
        lqd     $lit_8,0x5a0($a_surfaces)               # 196o
        fma     $colour_12,$colour,$diffuse_9,$highlight # 197e
        lqd     $lit_4,0x5b0($a_surfaces)               # 197o
        and     $highlight_4,$highlight_4,$reached_7    # 198e
        lqd     $lit_5,0x5f0($a_surfaces)               # 198o
        a       $a_shadow,$a_shadow,$step               # 199e
        lqd     $colour_6,768($a_surfaces)              # 199o
        fma     $colour_13,$colour_8,$diffuse_9,$highlight # 200e
        lqd     $highlight,896($a_surfaces)             # 200o
        fma     $colour_14,$colour_10,$diffuse_6,$highlight_4 # 201e
        lqd     $colour_10,704($a_surfaces)             # 201o
        fma     $lit,$bright_blue,$colour_11,$lit_12    # 202e
next_site_back:
        brnz    $count,next_site                        # 202o
next_site_drain:
        cfltu   $whole,$n,23                            # 0e
        hbr     light_r16_return,$lr                    # 0o hint
        and     $result,$result_6,$t_e                  # 1e
        stqd    $lit,0x5d0($a_surfaces_2)               # 1o
        fma     $colour_19,$colour_9,$diffuse_6,$highlight_4 # 2e
        fm      $highlight,$highlight,$result           # 3e
        fma     $lit_14,$bright_green,$colour_13,$lit_10 # 4e
        fma     $lit_10,$bright_green,$colour_14,$lit_8 # 5e
        fma     $colour,$colour_5,$diffuse_6,$highlight_4 # 6e
        selb    $fraction,$k_one,$whole,$m_fraction     # 7e
        andc    $whole_3,$whole,$m_fraction             # 8e
        fma     $result,$fraction,$k_exp+3,$k_exp+2     # 9e
        clgt    $t_e,$k_none,$whole                     # 10e
        stqd    $lit_14,0x590($a_surfaces_2)            # 10o
        and     $highlight,$highlight,$reached_8        # 11e
        stqd    $lit_10,0x5a0($a_surfaces_2)            # 11o
        fma     $lit_20,$bright_blue,$colour_19,$lit_11 # 12e
        fma     $colour_20,$colour_10,$diffuse_2,$highlight # 13e
        fma     $colour_21,$colour_6,$diffuse_2,$highlight # 14e
        fma     $result,$fraction,$result,$k_exp+1      # 15e
        fma     $lit_21,$bright_red,$colour_12,$lit_9   # 16e
        fma     $colour_22,$colour_7,$diffuse_2,$highlight # 17e
        fma     $lit,$bright_red,$colour,$lit_13        # 18e
        stqd    $lit_20,0x5e0($a_surfaces_2)            # 18o
        fma     $lit_16,$bright_green,$colour_20,$lit_7 # 19e
        fma     $lit_14,$bright_blue,$colour_21,$lit_6  # 20e
        fma     $result,$fraction,$result,$k_exp        # 21e
        stqd    $lit_21,0x550($a_surfaces_2)            # 22o
        fma     $lit_20,$bright_red,$colour_22,$lit_2   # 23e
        stqd    $lit_16,0x580($a_surfaces_2)            # 25o
        stqd    $lit_14,0x5c0($a_surfaces_2)            # 26o
        sf      $result,$whole_3,$result                # 27e
        and     $result,$result,$t_e                    # 29e
        fm      $highlight_5,$highlight_2,$result       # 31e
        and     $highlight_5,$highlight_5,$reached_9    # 37e
        fma     $colour_17,$colour_4,$diffuse_10,$highlight_5 # 39e
        fma     $colour_4,$colour_2,$diffuse_10,$highlight_5 # 40e
        fma     $colour_18,$colour_3,$diffuse_10,$highlight_5 # 41e
        fma     $lit_17,$bright_green,$colour_17,$lit_4 # 45e
        fma     $lit_18,$bright_blue,$colour_4,$lit_5   # 46e
        fma     $lit_19,$bright_red,$colour_18,$lit_3   # 47e
        stqd    $lit_17,0x5b0($a_surfaces_2)            # 51o
        stqd    $lit_18,0x5f0($a_surfaces_2)            # 52o
        stqd    $lit,0x560($a_surfaces_2)               # 53o
        stqd    $lit_19,0x570($a_surfaces_2)            # 54o
        stqd    $lit_20,0x540($a_surfaces_2)            # 55o
        nop     $127                                    # 56e pairing
light_r16_return:
        bi      $lr                                     # 56o
next_site_short:
        ai      $count,$count,-1                        # 0e
        lqd     $a_surfaces,0($a_site)                  # 0o
        ai      $a_site,$a_site,16                      # 1e
        lqd     $to_y,256($a_shadow)                    # 1o
        lqd     $to_z,320($a_shadow)                    # 2o
        lqd     $to_x,192($a_shadow)                    # 3o
        lqd     $t_c,448($a_shadow)                     # 4o
        lqd     $reached,384($a_shadow)                 # 5o
        rotqbyi $a_rays,$a_surfaces,4                   # 6o
        lqd     $normal_x,192($a_surfaces)              # 7o
        lqd     $normal_y,256($a_surfaces)              # 8o
        lqd     $normal_z,320($a_surfaces)              # 9o
        ceq     $t_c,$t_c,$background                   # 10e
        lqd     $half_x,192($a_rays)                    # 10o
        cgti    $reached,$reached,-1                    # 11e
        lqd     $half_z,320($a_rays)                    # 11o
        nop     $127                                    # 12e pairing
        lqd     $half_y,256($a_rays)                    # 12o
        and     $reached,$reached,$t_c                  # 13e
        lqd     $exponent,960($a_surfaces)              # 13o
        fm      $t_c,$normal_x,$to_x                    # 14e
        lqd     $highlight,896($a_surfaces)             # 14o
        nop     $127                                    # 15e pairing
        lqd     $diffuse,832($a_surfaces)               # 15o
        fs      $half_x,$to_x,$half_x                   # 16e
        lqd     $to_x,208($a_shadow)                    # 16o
        fs      $half_z,$to_z,$half_z                   # 17e
        lqd     $colour,640($a_surfaces)                # 17o
        fs      $half_y,$to_y,$half_y                   # 18e
        lqd     $lit,0x540($a_surfaces)                 # 18o
        fma     $t_c,$normal_y,$to_y,$t_c               # 20e
        lqd     $to_y,272($a_shadow)                    # 20o
        fm      $squared,$half_x,$half_x                # 22e
        lnop                                            # 22o pairing
        fm      $cosine,$normal_x,$half_x               # 23e
        lqd     $half_x,208($a_rays)                    # 23o
        nop     $127                                    # 24e pairing
        lqd     $normal_x,208($a_surfaces)              # 24o
        fma     $t_c,$normal_z,$to_z,$t_c               # 26e
        lqd     $to_z,336($a_shadow)                    # 26o
        fma     $squared,$half_y,$half_y,$squared       # 28e
        lnop                                            # 28o pairing
        fma     $cosine,$normal_y,$half_y,$cosine       # 29e
        lqd     $half_y,272($a_rays)                    # 29o
        fs      $half_x,$to_x,$half_x                   # 30e
        lqd     $normal_y,272($a_surfaces)              # 30o
        fm      $diffuse,$diffuse,$t_c                  # 32e
        lqd     $t_c,464($a_shadow)                     # 32o
        fma     $squared,$half_z,$half_z,$squared       # 34e
        lnop                                            # 34o pairing
        fma     $cosine,$normal_z,$half_z,$cosine       # 35e
        lqd     $half_z,336($a_rays)                    # 35o
        fs      $half_y,$to_y,$half_y                   # 36e
        lqd     $normal_z,336($a_surfaces)              # 36o
        ceq     $t_c,$t_c,$background                   # 38e
        and     $diffuse,$diffuse,$reached              # 39e
        frest   $t_y,$squared                           # 40o
        fm      $cosine,$cosine,$cosine                 # 41e
        fs      $half_z,$to_z,$half_z                   # 42e
        fi      $t_y,$squared,$t_y                      # 44e
        fnms    $t_e,$squared,$t_y,$k_one               # 51e
        fm      $squared,$half_x,$half_x                # 52e
        fma     $inverse,$t_e,$t_y,$t_y                 # 57e
        fma     $squared,$half_y,$half_y,$squared       # 58e
        fm      $quotient,$cosine,$inverse              # 63e
        lnop                                            # 63o pairing
        fm      $cosine,$normal_x,$half_x               # 64e
        lqd     $half_x,224($a_rays)                    # 64o
        fma     $squared,$half_z,$half_z,$squared       # 65e
        sf      $power,$quotient,$k_root2               # 69e
        fma     $cosine,$normal_y,$half_y,$cosine       # 70e
        lqd     $half_y,288($a_rays)                    # 70o
        andc    $power,$power,$m_fraction               # 71e
        frest   $t_y,$squared                           # 71o
        a       $mantissa,$power,$quotient              # 73e
        csflt   $power,$power,24                        # 74e
        fi      $t_y,$squared,$t_y                      # 75e
        fs      $unit,$mantissa,$k_one                  # 77e
        fma     $cosine,$normal_z,$half_z,$cosine       # 78e
        lqd     $half_z,352($a_rays)                    # 78o
        fma     $n,$unit,$k_log+4,$k_log+3              # 83e
        fm      $cosine,$cosine,$cosine                 # 84e
        fma     $n,$unit,$n,$k_log+2                    # 89e
        fma     $n,$unit,$n,$k_log+1                    # 95e
        fma     $n,$unit,$n,$k_log                      # 101e
        fnms    $n,$unit,$n,$power                      # 107e
        fm      $n,$n,$exponent                         # 113e
        lqd     $exponent,976($a_surfaces)              # 113o
        cfltu   $whole,$n,23                            # 119e
        selb    $fraction,$k_one,$whole,$m_fraction     # 126e
        clgt    $t_e,$k_none,$whole                     # 127e
        fma     $result,$fraction,$k_exp+3,$k_exp+2     # 128e
        andc    $whole,$whole,$m_fraction               # 129e
        fma     $result,$fraction,$result,$k_exp+1      # 134e
        fma     $result,$fraction,$result,$k_exp        # 140e
        sf      $result,$whole,$result                  # 146e
        and     $result,$result,$t_e                    # 148e
        fnms    $t_e,$squared,$t_y,$k_one               # 149e
        fm      $highlight,$highlight,$result           # 150e
        fma     $inverse,$t_e,$t_y,$t_y                 # 155e
        and     $highlight,$highlight,$reached          # 156e
        lqd     $reached,400($a_shadow)                 # 156o
        fma     $colour,$colour,$diffuse,$highlight     # 158e
        fm      $quotient,$cosine,$inverse              # 161e
        cgti    $reached,$reached,-1                    # 162e
        and     $reached,$reached,$t_c                  # 164e
        fm      $t_c,$normal_x,$to_x                    # 165e
        lqd     $to_x,224($a_shadow)                    # 165o
        fma     $lit,$bright_red,$colour,$lit           # 166e
        lqd     $normal_x,224($a_surfaces)              # 166o
        sf      $power,$quotient,$k_root2               # 167e
        lqd     $colour,704($a_surfaces)                # 167o
        andc    $power,$power,$m_fraction               # 169e
        a       $mantissa,$power,$quotient              # 171e
        csflt   $power,$power,24                        # 172e
        stqd    $lit,0x540($a_surfaces)                 # 172o
        lqd     $lit,0x580($a_surfaces)                 # 173o
        fs      $unit,$mantissa,$k_one                  # 174e
        fs      $half_x,$to_x,$half_x                   # 175e
        lnop                                            # 175o pairing
        fma     $t_c,$normal_y,$to_y,$t_c               # 176e
        lqd     $to_y,288($a_shadow)                    # 176o
        fma     $colour,$colour,$diffuse,$highlight     # 177e
        lqd     $normal_y,288($a_surfaces)              # 177o
        fma     $n,$unit,$k_log+4,$k_log+3              # 180e
        fm      $squared,$half_x,$half_x                # 181e
        fma     $t_c,$normal_z,$to_z,$t_c               # 182e
        lqd     $to_z,352($a_shadow)                    # 182o
        fs      $half_y,$to_y,$half_y                   # 183e
        lqd     $normal_z,352($a_surfaces)              # 183o
        fm      $cosine,$normal_x,$half_x               # 184e
        lqd     $half_x,240($a_rays)                    # 184o
        fma     $lit,$bright_green,$colour,$lit         # 185e
        lqd     $colour,768($a_surfaces)                # 185o
        fma     $n,$unit,$n,$k_log+2                    # 186e
        fs      $half_z,$to_z,$half_z                   # 188e
        fma     $squared,$half_y,$half_y,$squared       # 189e
        lnop                                            # 189o pairing
        fma     $cosine,$normal_y,$half_y,$cosine       # 190e
        lqd     $half_y,304($a_rays)                    # 190o
        fma     $colour,$colour,$diffuse,$highlight     # 191e
        lqd     $highlight,912($a_surfaces)             # 191o
        fma     $n,$unit,$n,$k_log+1                    # 192e
        lqd     $diffuse,848($a_surfaces)               # 192o
        stqd    $lit,0x580($a_surfaces)                 # 193o
        lqd     $lit,0x5c0($a_surfaces)                 # 194o
        fma     $squared,$half_z,$half_z,$squared       # 195e
        lnop                                            # 195o pairing
        fma     $cosine,$normal_z,$half_z,$cosine       # 196e
        lqd     $half_z,368($a_rays)                    # 196o
        fma     $n,$unit,$n,$k_log                      # 198e
        lnop                                            # 198o pairing
        fm      $diffuse,$diffuse,$t_c                  # 199e
        lqd     $t_c,480($a_shadow)                     # 199o
        fma     $lit,$bright_blue,$colour,$lit          # 200e
        lqd     $colour,656($a_surfaces)                # 200o
        frest   $t_y,$squared                           # 201o
        fm      $cosine,$cosine,$cosine                 # 202e
        fnms    $n,$unit,$n,$power                      # 204e
        fi      $t_y,$squared,$t_y                      # 205e
        and     $diffuse,$diffuse,$reached              # 206e
        stqd    $lit,0x5c0($a_surfaces)                 # 206o
        ceq     $t_c,$t_c,$background                   # 207e
        lqd     $lit,0x550($a_surfaces)                 # 207o
        fm      $n,$n,$exponent                         # 210e
        lqd     $exponent,992($a_surfaces)              # 210o
        cfltu   $whole,$n,23                            # 216e
        selb    $fraction,$k_one,$whole,$m_fraction     # 223e
        clgt    $t_e,$k_none,$whole                     # 224e
        fma     $result,$fraction,$k_exp+3,$k_exp+2     # 225e
        andc    $whole,$whole,$m_fraction               # 226e
        fma     $result,$fraction,$result,$k_exp+1      # 231e
        fma     $result,$fraction,$result,$k_exp        # 237e
        sf      $result,$whole,$result                  # 243e
        and     $result,$result,$t_e                    # 245e
        fnms    $t_e,$squared,$t_y,$k_one               # 246e
        fm      $highlight,$highlight,$result           # 247e
        fma     $inverse,$t_e,$t_y,$t_y                 # 252e
        and     $highlight,$highlight,$reached          # 253e
        lqd     $reached,416($a_shadow)                 # 253o
        fma     $colour,$colour,$diffuse,$highlight     # 255e
        fm      $quotient,$cosine,$inverse              # 258e
        cgti    $reached,$reached,-1                    # 259e
        and     $reached,$reached,$t_c                  # 261e
        fm      $t_c,$normal_x,$to_x                    # 262e
        lqd     $to_x,240($a_shadow)                    # 262o
        fma     $lit,$bright_red,$colour,$lit           # 263e
        lqd     $normal_x,240($a_surfaces)              # 263o
        sf      $power,$quotient,$k_root2               # 264e
        lqd     $colour,720($a_surfaces)                # 264o
        andc    $power,$power,$m_fraction               # 266e
        a       $mantissa,$power,$quotient              # 268e
        fs      $half_x,$to_x,$half_x                   # 269e
        stqd    $lit,0x550($a_surfaces)                 # 269o
        fs      $unit,$mantissa,$k_one                  # 270e
        lqd     $lit,0x590($a_surfaces)                 # 270o
        fma     $t_c,$normal_y,$to_y,$t_c               # 271e
        lqd     $to_y,304($a_shadow)                    # 271o
        csflt   $power,$power,24                        # 272e
        lqd     $normal_y,304($a_surfaces)              # 272o
        fma     $colour,$colour,$diffuse,$highlight     # 274e
        fm      $squared,$half_x,$half_x                # 275e
        fma     $n,$unit,$k_log+4,$k_log+3              # 276e
        lnop                                            # 276o pairing
        fma     $t_c,$normal_z,$to_z,$t_c               # 277e
        lqd     $to_z,368($a_shadow)                    # 277o
        fs      $half_y,$to_y,$half_y                   # 278e
        lqd     $normal_z,368($a_surfaces)              # 278o
        fm      $cosine,$normal_x,$half_x               # 279e
        lnop                                            # 279o pairing
        fma     $lit,$bright_green,$colour,$lit         # 280e
        lqd     $colour,784($a_surfaces)                # 280o
        fma     $n,$unit,$n,$k_log+2                    # 282e
        fs      $half_z,$to_z,$half_z                   # 283e
        fma     $squared,$half_y,$half_y,$squared       # 284e
        fma     $cosine,$normal_y,$half_y,$cosine       # 285e
        fma     $colour,$colour,$diffuse,$highlight     # 286e
        stqd    $lit,0x590($a_surfaces)                 # 286o
        nop     $127                                    # 287e pairing
        lqd     $highlight,928($a_surfaces)             # 287o
        fma     $n,$unit,$n,$k_log+1                    # 288e
        lqd     $lit,0x5d0($a_surfaces)                 # 288o
        lqd     $diffuse,864($a_surfaces)               # 289o
        fma     $squared,$half_z,$half_z,$squared       # 290e
        fma     $cosine,$normal_z,$half_z,$cosine       # 291e
        fma     $n,$unit,$n,$k_log                      # 294e
        fma     $lit,$bright_blue,$colour,$lit          # 295e
        lqd     $colour,672($a_surfaces)                # 295o
        fm      $diffuse,$diffuse,$t_c                  # 296e
        frest   $t_y,$squared                           # 296o
        fm      $cosine,$cosine,$cosine                 # 297e
        lqd     $t_c,496($a_shadow)                     # 297o
        fnms    $n,$unit,$n,$power                      # 300e
        lnop                                            # 300o pairing
        fi      $t_y,$squared,$t_y                      # 301e
        stqd    $lit,0x5d0($a_surfaces)                 # 301o
        and     $diffuse,$diffuse,$reached              # 302e
        lqd     $lit,0x560($a_surfaces)                 # 302o
        ceq     $t_c,$t_c,$background                   # 303e
        lnop                                            # 303o pairing
        fm      $n,$n,$exponent                         # 306e
        lqd     $exponent,1008($a_surfaces)             # 306o
        cfltu   $whole,$n,23                            # 312e
        selb    $fraction,$k_one,$whole,$m_fraction     # 319e
        clgt    $t_e,$k_none,$whole                     # 320e
        fma     $result,$fraction,$k_exp+3,$k_exp+2     # 321e
        andc    $whole,$whole,$m_fraction               # 322e
        fma     $result,$fraction,$result,$k_exp+1      # 327e
        fma     $result,$fraction,$result,$k_exp        # 333e
        sf      $result,$whole,$result                  # 339e
        and     $result,$result,$t_e                    # 341e
        fnms    $t_e,$squared,$t_y,$k_one               # 342e
        fm      $highlight,$highlight,$result           # 343e
        fma     $inverse,$t_e,$t_y,$t_y                 # 348e
        and     $highlight,$highlight,$reached          # 349e
        lqd     $reached,432($a_shadow)                 # 349o
        a       $a_shadow,$a_shadow,$step               # 350e
        fma     $colour,$colour,$diffuse,$highlight     # 351e
        fm      $quotient,$cosine,$inverse              # 354e
        cgti    $reached,$reached,-1                    # 355e
        and     $reached,$reached,$t_c                  # 357e
        lnop                                            # 357o pairing
        fma     $lit,$bright_red,$colour,$lit           # 358e
        lqd     $colour,736($a_surfaces)                # 358o
        fm      $t_c,$normal_x,$to_x                    # 359e
        sf      $power,$quotient,$k_root2               # 360e
        andc    $power,$power,$m_fraction               # 362e
        lnop                                            # 362o pairing
        a       $mantissa,$power,$quotient              # 364e
        stqd    $lit,0x560($a_surfaces)                 # 364o
        csflt   $power,$power,24                        # 365e
        lqd     $lit,0x5a0($a_surfaces)                 # 365o
        fs      $unit,$mantissa,$k_one                  # 367e
        fma     $colour,$colour,$diffuse,$highlight     # 368e
        fma     $t_c,$normal_y,$to_y,$t_c               # 369e
        fma     $n,$unit,$k_log+4,$k_log+3              # 373e
        fma     $lit,$bright_green,$colour,$lit         # 374e
        lqd     $colour,800($a_surfaces)                # 374o
        fma     $t_c,$normal_z,$to_z,$t_c               # 375e
        fma     $n,$unit,$n,$k_log+2                    # 379e
        fma     $colour,$colour,$diffuse,$highlight     # 380e
        stqd    $lit,0x5a0($a_surfaces)                 # 380o
        lqd     $diffuse,880($a_surfaces)               # 381o
        lqd     $highlight,944($a_surfaces)             # 382o
        lqd     $lit,0x5e0($a_surfaces)                 # 383o
        fma     $n,$unit,$n,$k_log+1                    # 385e
        fm      $diffuse,$diffuse,$t_c                  # 387e
        lnop                                            # 387o pairing
        fma     $lit,$bright_blue,$colour,$lit          # 389e
        lqd     $colour,688($a_surfaces)                # 389o
        fma     $n,$unit,$n,$k_log                      # 391e
        and     $diffuse,$diffuse,$reached              # 393e
        stqd    $lit,0x5e0($a_surfaces)                 # 395o
        lqd     $lit,0x570($a_surfaces)                 # 396o
        fnms    $n,$unit,$n,$power                      # 397e
        hbrr    next_site_short_back,next_site_short    # 397o hint
        fm      $n,$n,$exponent                         # 403e
        cfltu   $whole,$n,23                            # 409e
        selb    $fraction,$k_one,$whole,$m_fraction     # 416e
        clgt    $t_e,$k_none,$whole                     # 417e
        fma     $result,$fraction,$k_exp+3,$k_exp+2     # 418e
        andc    $whole,$whole,$m_fraction               # 419e
        fma     $result,$fraction,$result,$k_exp+1      # 424e
        fma     $result,$fraction,$result,$k_exp        # 430e
        sf      $result,$whole,$result                  # 436e
        and     $result,$result,$t_e                    # 438e
        fm      $highlight,$highlight,$result           # 440e
        and     $highlight,$highlight,$reached          # 446e
        fma     $colour,$colour,$diffuse,$highlight     # 448e
        lnop                                            # 448o pairing
        fma     $lit,$bright_red,$colour,$lit           # 454e
        lqd     $colour,752($a_surfaces)                # 454o
        fma     $colour,$colour,$diffuse,$highlight     # 460e
        stqd    $lit,0x570($a_surfaces)                 # 460o
        nop     $127                                    # 461e pairing
        lqd     $lit,0x5b0($a_surfaces)                 # 461o
        fma     $lit,$bright_green,$colour,$lit         # 467e
        lqd     $colour,816($a_surfaces)                # 467o
        fma     $colour,$colour,$diffuse,$highlight     # 473e
        stqd    $lit,0x5b0($a_surfaces)                 # 473o
        lqd     $lit,0x5f0($a_surfaces)                 # 474o
        fma     $lit,$bright_blue,$colour,$lit          # 480e
        stqd    $lit,0x5f0($a_surfaces)                 # 486o
next_site_short_back:
        brnz    $count,next_site_short                  # 487o
        nop     $127                                    # 488e pairing
        bi      $lr                                     # 488o
endfunction light_r16
