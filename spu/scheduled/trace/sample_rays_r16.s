# sample_rays_r16   primary rays through the samples of pixels, as packets of rays from anywhere
#   C       void sample_rays_r16(const struct place *, int count, const struct basis *,
#                                unsigned background, int samples, struct rays16 *);
#   In      $3 places of pixels, four a packet, $4 count of packets (at least 1), $5 basis,
#           $6 address of the background's OBJECT, $7 samples of a pixel: 4 or 16, $8 packets;
#           pointers 16-aligned
#   Out     RAYS16, one behind the other, all of their words
#   Uses    $2-$58, $79   Saves  -   Stack  0   Calls  -
#   Domain  the direction through each sample is not 0 and below 2^63 in length; pixels below 2^18;
#           a place's pixels: the sum of the pixel
#   Error   2 ulp of 1, each component of a direction
#   Twin    lab/twins/src/sample_rays.rs
#
# Each place makes a row of four rays. Of 4 samples these are all, of 16 the row's number tells
# which. A place whose x is below 0 makes rays that are absent: t is -1, the weight is 0.
#
# Samples are a regular grid of n by n, turned so far that all have another x and another y:
#   x = i/n + j/n^2, y = j/n - i/n^2, from the first sample on, i and j from 0 to n - 1
# Edges that are nearly upright or level then have n^2 + 1 shades, not n + 1.
# Scheduled by spu schedule from sample_rays_r16.s

        .include "work_unit.inc"
        .include "macros.inc"
        .include "math.inc"
        .include "primary_ray_tmpl.inc"

        .set    NEXT,3
        registers a_place,count,a_basis,background,samples,a_packet
        # constants
        .set    NEXT,12
        registers k_far,m_x,m_y,m_pixels,k_zero
        .set    k_column,44                             # to 47: the x of a row's samples
        .set    k_absent,48
        # the row
        .set    place,26
        .set    NEXT,49
        registers x,y,pixels,c_absent,t,weight,a_pattern

        .section .rodata
        .align  4
        # x of the four rows' samples, then y, from the pixel's centre
samples_4:
    .rept   4
        .float  -0.375,0.125,-0.125,0.375
    .endr
    .rept   4
        .float  -0.125,-0.375,0.375,0.125
    .endr
samples_16:
        .float  -0.46875,-0.21875,0.03125,0.28125
        .float  -0.40625,-0.15625,0.09375,0.34375
        .float  -0.34375,-0.09375,0.15625,0.40625
        .float  -0.28125,-0.03125,0.21875,0.46875
        .float  -0.28125,-0.34375,-0.40625,-0.46875
        .float  -0.03125,-0.09375,-0.15625,-0.21875
        .float  0.21875,0.15625,0.09375,0.03125
        .float  0.46875,0.40625,0.34375,0.28125

function sample_rays_r16
        .set m_x_2,2; .set count_2,79; .set k_row_2,5; .set k_row1_2,2; .set k_row2_2,2
        .set k_row3_2,2; .set a_packet_2,56; .set place_2,2; .set place_3,7; .set place_4,9
        .set x_2,31; .set x_3,32; .set x_4,36; .set fx_2,37; .set fx_3,38; .set y_2,52
        .set fx_4,51; .set y_3,39; .set fx_5,53; .set y_4,54; .set fy_2,50; .set pixels_2,7
        .set fy_3,52; .set pixels_3,26; .set fy_4,39; .set fy_5,54; .set c_absent_2,49
        .set fx_6,30; .set t_y_2,51; .set pixels_4,2; .set t_y_3,35; .set base_x_2,27
        .set base_x_3,50; .set t_y_4,39; .set pixels_5,9; .set t_y_5,52; .set base_x_4,33
        .set base_x_5,34; .set dx_2,53; .set base_y_2,5; .set dx_3,27; .set base_y_3,50
        .set base_y_4,29; .set dx_4,54; .set length_2,34; .set length_3,26; .set base_y_5,2
        .set dy_2,50; .set base_z_2,38; .set base_z_3,30; .set dy_3,5; .set dy_4,7
        .set length_4,55; .set length_5,9; .set base_z_4,29; .set dy_5,28; .set base_z_5,2
        .set dz_2,30; .set length_6,37; .set length_7,38; .set dz_3,51; .set dz_4,9
        .set length_8,2; .set length_9,29; .set weight_2,34; .set c_absent_3,32; .set c_absent_4,31
        .set t_y_6,34; .set t_2,37; .set weight_3,55; .set t_y_7,57; .set weight_4,58
        .set weight_5,37; .set t_e_2,2; .set t_e_3,29; .set inverse_2,49; .set t_e_4,36
        .set t_e_5,26; .set inverse_3,55; .set inverse_4,57; .set t_e_6,58; .set inverse_5,2
        .set inverse_6,36; .set t_3,31; .set t_4,38; .set inverse_7,29; .set dz_5,55; .set dy_6,57
        .set dx_5,30; .set dz_6,58; .set dz_7,27; .set dx_6,29; .set length_10,56; .set dy_7,2
        .set base_z_6,5; .set base_z_7,9; .set length_11,5; .set c_absent_5,26; .set length_12,31
        .set weight_6,39; .set t_y_8,32; .set t_y_9,56; .set weight_7,57; .set t_y_10,37
        .set t_5,39; .set t_e_7,5; .set t_6,26; .set inverse_8,31; .set inverse_9,5; .set dx_7,2
        .set dy_8,3; .set dx_8,4; .set a_packet_3,2; .set place_5,5; .set x_5,27; .set x_6,28
        .set y_5,31; .set fx_7,32; .set y_6,33; .set fx_8,34; .set x_7,35; .set fy_6,36
        .set fy_7,26; .set fy_8,31; .set fx_9,33; .set fx_10,29; .set t_y_11,31; .set pixels_6,5
        .set base_y_6,37; .set t_y_12,9; .set t_y_13,5; .set base_y_7,26; .set base_x_6,36
        .set base_y_8,39; .set dx_9,34; .set base_z_8,33; .set base_x_7,7; .set dy_9,26
        .set dx_10,36; .set dy_10,39; .set dy_11,33; .set base_x_8,37; .set length_13,49
        .set dx_11,7; .set dx_12,37; .set length_14,51; .set dz_8,5; .set dz_9,31
        .set length_15,32; .set c_absent_6,35; .set c_absent_7,28; .set inverse_10,35
        .set t_e_8,49; .set t_y_14,53; .set t_e_9,38; .set inverse_11,54; .set t_7,28
        .set t_y_15,55; .set c_absent_8,27; .set t_e_10,28; .set weight_8,38; .set t_e_11,32
        .set inverse_12,38; .set inverse_13,28; .set dz_10,28; .set inverse_14,30; .set dx_13,32
        .set inverse_15,9; .set dz_11,26
        ceqi    $samples,$samples,16                    # 0e
        lqd     $corner_x,0($a_basis)                   # 0o
        ila     $a_pattern,samples_4                    # 1e
        lqd     $right_x,48($a_basis)                   # 1o
        andi    $samples,$samples,128                   # 2e
        lqd     $down_x,96($a_basis)                    # 2o
        ila     $m_x_2,0x10203                          # 3e
        lqd     $corner_y,16($a_basis)                  # 3o
        a       $a_pattern,$a_pattern,$samples          # 4e
        lqd     $right_y,64($a_basis)                   # 4o
        ilhu    $m_pixels,0x405                         # 5e
        lqd     $down_y,112($a_basis)                   # 5o
        ilhu    $m_x,0x809                              # 6e
        lqd     $corner_z,32($a_basis)                  # 6o
        ilhu    $m_y,0xc0d                              # 7e
        lqd     $right_z,80($a_basis)                   # 7o
        clgti   $count_2,$count,1                       # 8e at least as many passes as overlap
        lqd     $down_z,128($a_basis)                   # 8o
        iohl    $m_pixels,0x607                         # 9e
        lqd     $k_column,0($a_pattern)                 # 9o
        iohl    $m_x,0xa0b                              # 10e
        lqd     $k_row,64($a_pattern)                   # 10o
        iohl    $m_y,0xe0f                              # 11e
        lqd     $k_column+1,16($a_pattern)              # 11o
        ilhu    $k_far,0x5e80                           # 12e
        lqd     $k_row+1,80($a_pattern)                 # 12o
        ilhu    $k_absent,0xbf80                        # 13e
        lqd     $k_column+2,32($a_pattern)              # 13o
        il      $k_zero,0                               # 14e
        lqd     $k_row+2,96($a_pattern)                 # 14o
        ilhu    $k_half,0x3f00                          # 15e
        lqd     $k_column+3,48($a_pattern)              # 15o
        ilhu    $k_one,0x3f80                           # 16e
        lqd     $k_row+3,112($a_pattern)                # 16o
        il      $k_row_2,0                              # 17e
        shufb   $background,$background,$background,$m_x_2 # 17o
        ilhu    $k_row1_2,0x3f80                        # 18e
        ilhu    $k_row2_2,0x4000                        # 19e
        ilhu    $k_row3_2,0x4040                        # 20e
        brz     $count_2,next_packet_short              # 20o too few passes
        ai      $count,$count,-1                        # 21e
        lqd     $place,0($a_place)                      # 21o
        ai      $a_packet_2,$a_packet,320               # 22e
        lqd     $place_2,16($a_place)                   # 22o
        lqd     $place_3,48($a_place)                   # 23o
        lqd     $place_4,32($a_place)                   # 24o
        ai      $a_place,$a_place,64                    # 25e
        stqd    $k_zero,80($a_packet)                   # 25o
        stqd    $k_zero,144($a_packet)                  # 26o
        shufb   $x,$place,$place,$m_x                   # 27o
        shufb   $x_2,$place_2,$place_2,$m_x             # 28o
        shufb   $x_3,$place_3,$place_3,$m_x             # 29o
        nop     $127                                    # 30e pairing
        shufb   $x_4,$place_4,$place_4,$m_x             # 30o
        csflt   $fx_2,$x,0                              # 31e
        shufb   $y,$place_2,$place_2,$m_y               # 31o
        csflt   $fx_3,$x_2,0                            # 32e
        shufb   $y_2,$place,$place,$m_y                 # 32o
        csflt   $fx_4,$x_3,0                            # 33e
        shufb   $y_3,$place_4,$place_4,$m_y             # 33o
        csflt   $fx_5,$x_4,0                            # 34e
        shufb   $y_4,$place_3,$place_3,$m_y             # 34o
        csflt   $fy_2,$y,0                              # 35e
        shufb   $pixels_2,$place_3,$place_3,$m_pixels   # 35o
        csflt   $fy_3,$y_2,0                            # 36e
        shufb   $pixels_3,$place,$place,$m_pixels       # 36o
        csflt   $fy_4,$y_3,0                            # 37e
        stqd    $k_zero,160($a_packet)                  # 37o
        csflt   $fy_5,$y_4,0                            # 38e
        stqd    $background,480($a_packet)              # 38o
        cgt     $c_absent_2,$k_zero,$x                  # 39e
        stqd    $k_zero,112($a_packet)                  # 39o
        fa      $fx_3,$fx_3,$k_column+1                 # 40e
        stqd    $pixels_2,624($a_packet)                # 40o
        fa      $fx_6,$fx_2,$k_column                   # 41e
        stqd    $pixels_3,576($a_packet)                # 41o
        fa      $fx,$fx_5,$k_column+2                   # 42e
        stqd    $k_zero,16($a_packet)                   # 42o
        fa      $fx_2,$fx_4,$k_column+3                 # 43e
        stqd    $background,464($a_packet)              # 43o
        fa      $t_y_2,$fy_3,$k_row                     # 44e
        shufb   $pixels_4,$place_2,$place_2,$m_pixels   # 44o
        fa      $t_y_3,$fy_2,$k_row+1                   # 45e
        stqd    $k_zero,0($a_packet)                    # 45o
        fma     $base_x_2,$fx_3,$right_x,$corner_x      # 46e
        stqd    $k_zero,64($a_packet)                   # 46o
        fma     $base_x_3,$fx_6,$right_x,$corner_x      # 47e
        stqd    $k_zero,128($a_packet)                  # 47o
        fa      $t_y_4,$fy_4,$k_row+2                   # 48e
        shufb   $pixels_5,$place_4,$place_4,$m_pixels   # 48o
        fa      $t_y_5,$fy_5,$k_row+3                   # 49e
        stqd    $background,448($a_packet)              # 49o
        fma     $base_x_4,$fx,$right_x,$corner_x        # 50e
        stqd    $pixels_4,592($a_packet)                # 50o
        fma     $base_x_5,$fx_2,$right_x,$corner_x      # 51e
        stqd    $k_zero,32($a_packet)                   # 51o
        fma     $dx_2,$t_y_3,$down_x,$base_x_2          # 52e
        stqd    $k_zero,96($a_packet)                   # 52o
        fma     $base_y_2,$fx_6,$right_y,$corner_y      # 53e
        stqd    $pixels_5,608($a_packet)                # 53o
        fma     $dx_3,$t_y_2,$down_x,$base_x_3          # 54e
        stqd    $k_zero,48($a_packet)                   # 54o
        fma     $base_y_3,$fx_3,$right_y,$corner_y      # 55e
        stqd    $k_zero,176($a_packet)                  # 55o
        fma     $base_y_4,$fx_2,$right_y,$corner_y      # 56e
        stqd    $background,496($a_packet)              # 56o
        fma     $dx,$t_y_4,$down_x,$base_x_4            # 57e
        fma     $dx_4,$t_y_5,$down_x,$base_x_5          # 58e
        fm      $length_2,$dx_2,$dx_2                   # 59e
        fm      $length_3,$dx_3,$dx_3                   # 60e
        fma     $base_y_5,$fx,$right_y,$corner_y        # 61e
        fma     $dy_2,$t_y_3,$down_y,$base_y_3          # 62e
        fma     $base_z_2,$fx_3,$right_z,$corner_z      # 63e
        fma     $base_z_3,$fx_6,$right_z,$corner_z      # 64e
        fma     $dy_3,$t_y_2,$down_y,$base_y_2          # 65e
        fma     $dy_4,$t_y_5,$down_y,$base_y_4          # 66e
        fm      $length_4,$dx_4,$dx_4                   # 67e
        fm      $length_5,$dx,$dx                       # 68e
        fma     $base_z_4,$fx,$right_z,$corner_z        # 69e
        fma     $dy_5,$t_y_4,$down_y,$base_y_5          # 70e
        fma     $base_z_5,$fx_2,$right_z,$corner_z      # 71e
        fma     $dz_2,$t_y_2,$down_z,$base_z_3          # 72e
        fma     $length_3,$dy_3,$dy_3,$length_3         # 73e
        fma     $length_2,$dy_2,$dy_2,$length_2         # 74e
        fma     $dz,$t_y_3,$down_z,$base_z_2            # 75e
        fma     $length_6,$dy_4,$dy_4,$length_4         # 76e
        fma     $length_7,$dy_5,$dy_5,$length_5         # 77e
        fma     $dz_3,$t_y_5,$down_z,$base_z_5          # 78e
        fma     $dz_4,$t_y_4,$down_z,$base_z_4          # 79e
        fma     $length_8,$dz_2,$dz_2,$length_3         # 80e
        fma     $length_9,$dz,$dz,$length_2             # 81e
        cgt     $c_absent,$k_zero,$x_4                  # 82e
        andc    $weight_2,$k_one,$c_absent_2            # 83e
        fma     $length,$dz_3,$dz_3,$length_6           # 84e
        fma     $length_3,$dz_4,$dz_4,$length_7         # 85e
        stqd    $weight_2,512($a_packet)                # 85o
        cgt     $c_absent_3,$k_zero,$x_3                # 86e
        frsqest $t_y,$length_8                          # 86o
        cgt     $c_absent_4,$k_zero,$x_2                # 87e
        frsqest $t_y_6,$length_9                        # 87o
        selb    $t_2,$k_far,$k_absent,$c_absent         # 88e
        andc    $weight_3,$k_one,$c_absent_3            # 89e
        fi      $t_y,$length_8,$t_y                     # 90e
        frsqest $t_y_4,$length                          # 90o
        fi      $t_y_6,$length_9,$t_y_6                 # 91e
        frsqest $t_y_7,$length_3                        # 91o
        andc    $weight_4,$k_one,$c_absent_4            # 92e
        stqd    $t_2,416($a_packet)                     # 92o
        andc    $weight_5,$k_one,$c_absent              # 93e
        stqd    $weight_3,560($a_packet)                # 93o
        fi      $t_y_4,$length,$t_y_4                   # 94e
        stqd    $weight_4,528($a_packet)                # 94o
        fi      $t_y_5,$length_3,$t_y_7                 # 95e
        stqd    $weight_5,544($a_packet)                # 95o
        selb    $t_2,$k_far,$k_absent,$c_absent_2       # 96e
        fm      $t_e_2,$length_8,$t_y                   # 97e
        fm      $t_e_3,$length_9,$t_y_6                 # 98e
        stqd    $t_2,384($a_packet)                     # 98o
        fm      $inverse_2,$t_y,$k_half                 # 99e
        fm      $inverse,$t_y_6,$k_half                 # 100e
        fm      $t_e_4,$length,$t_y_4                   # 101e
        fm      $t_e_5,$length_3,$t_y_5                 # 102e
        fnms    $t_e_2,$t_e_2,$t_y,$k_one               # 103e
        fnms    $t_e_3,$t_e_3,$t_y_6,$k_one             # 104e
        fm      $inverse_3,$t_y_5,$k_half               # 105e
        fm      $inverse_4,$t_y_4,$k_half               # 106e
        fnms    $t_e_6,$t_e_4,$t_y_4,$k_one             # 107e
        fnms    $t_e_5,$t_e_5,$t_y_5,$k_one             # 108e
        fma     $inverse_5,$t_e_2,$inverse_2,$t_y       # 109e
        fma     $inverse_6,$t_e_3,$inverse,$t_y_6       # 110e
        selb    $t_3,$k_far,$k_absent,$c_absent_4       # 111e
        selb    $t_4,$k_far,$k_absent,$c_absent_3       # 112e
        fma     $inverse_7,$t_e_6,$inverse_4,$t_y_4     # 113e
        stqd    $t_3,400($a_packet)                     # 113o
        fma     $inverse,$t_e_5,$inverse_3,$t_y_5       # 114e
        stqd    $t_4,432($a_packet)                     # 114o
        fm      $dz_5,$dz_2,$inverse_5                  # 115e
        fm      $dy_6,$dy_3,$inverse_5                  # 116e
        fm      $dx_5,$dx_3,$inverse_5                  # 117e
        fm      $dz_6,$dz,$inverse_6                    # 118e
next_packet:
            fm      $dx,$dx,$inverse                    # 0e
        lqd     $place,0($a_place)                      # 0o
            fm      $dy,$dy_5,$inverse                  # 1e
        lqd     $place_2,16($a_place)                   # 1o
            fm      $dy_3,$dy_4,$inverse_7              # 2e
        lqd     $place_3,48($a_place)                   # 2o
            fm      $dz,$dz_4,$inverse                  # 3e
        lqd     $place_4,32($a_place)                   # 3o
            fm      $dz_7,$dz_3,$inverse_7              # 4e
            lnop                                        # 4o pairing
            fm      $dy_5,$dy_2,$inverse_6              # 5e
            stqd    $dx_5,192($a_packet)                # 5o
            fm      $dx_6,$dx_4,$inverse_7              # 6e
        shufb   $x,$place,$place,$m_x                   # 6o
            fm      $dx_5,$dx_2,$inverse_6              # 7e
        shufb   $x_2,$place_2,$place_2,$m_x             # 7o
        ai      $count,$count,-1                        # 8e
        shufb   $x_3,$place_3,$place_3,$m_x             # 8o
        ai      $a_place,$a_place,64                    # 9e
        shufb   $x_4,$place_4,$place_4,$m_x             # 9o
        csflt   $fx_2,$x,0                              # 10e
        shufb   $y,$place_2,$place_2,$m_y               # 10o
        csflt   $fx_3,$x_2,0                            # 11e
        shufb   $y_3,$place_4,$place_4,$m_y             # 11o
        csflt   $fx_4,$x_3,0                            # 12e
        shufb   $y_2,$place,$place,$m_y                 # 12o
        csflt   $fx_5,$x_4,0                            # 13e
        shufb   $y_4,$place_3,$place_3,$m_y             # 13o
        csflt   $fy_2,$y,0                              # 14e
        shufb   $pixels_3,$place,$place,$m_pixels       # 14o
        csflt   $fy_4,$y_3,0                            # 15e
        shufb   $pixels_4,$place_2,$place_2,$m_pixels   # 15o
        csflt   $fy_3,$y_2,0                            # 16e
        shufb   $pixels_5,$place_4,$place_4,$m_pixels   # 16o
        csflt   $fy_5,$y_4,0                            # 17e
        shufb   $pixels_2,$place_3,$place_3,$m_pixels   # 17o
        cgt     $c_absent_2,$k_zero,$x                  # 18e
            stqd    $dy_6,256($a_packet)                # 18o
        fa      $fx_3,$fx_3,$k_column+1                 # 19e
            stqd    $dx_5,208($a_packet)                # 19o
        fa      $fx_6,$fx_2,$k_column                   # 20e
            stqd    $dy_5,272($a_packet)                # 20o
        fa      $fx,$fx_5,$k_column+2                   # 21e
            stqd    $dz_5,320($a_packet)                # 21o
        fa      $fx_2,$fx_4,$k_column+3                 # 22e
            stqd    $dz_6,336($a_packet)                # 22o
        fa      $t_y_2,$fy_3,$k_row                     # 23e
            stqd    $dz,352($a_packet)                  # 23o
        fa      $t_y_3,$fy_2,$k_row+1                   # 24e
            stqd    $dz_7,368($a_packet)                # 24o
        fma     $base_x_2,$fx_3,$right_x,$corner_x      # 25e
        fma     $base_x_3,$fx_6,$right_x,$corner_x      # 26e
        fa      $t_y_4,$fy_4,$k_row+2                   # 27e
        lnop                                            # 27o pairing
        fa      $t_y_5,$fy_5,$k_row+3                   # 28e
            stqd    $dx,224($a_packet)                  # 28o
        fma     $base_x_4,$fx,$right_x,$corner_x        # 29e
            stqd    $dy,288($a_packet)                  # 29o
        fma     $base_x_5,$fx_2,$right_x,$corner_x      # 30e
            stqd    $dx_6,240($a_packet)                # 30o
        fma     $base_y_4,$fx_2,$right_y,$corner_y      # 31e
            stqd    $dy_3,304($a_packet)                # 31o
            ai      $a_packet,$a_packet_2,320           # 32e
        fma     $dx_2,$t_y_3,$down_x,$base_x_2          # 33e
        fma     $base_y_2,$fx_6,$right_y,$corner_y      # 34e
        stqd    $k_zero,80($a_packet)                   # 34o
        fma     $dx_3,$t_y_2,$down_x,$base_x_3          # 35e
        stqd    $k_zero,144($a_packet)                  # 35o
        fma     $dx,$t_y_4,$down_x,$base_x_4            # 36e
        stqd    $k_zero,160($a_packet)                  # 36o
        fma     $base_y_3,$fx_3,$right_y,$corner_y      # 37e
        stqd    $background,480($a_packet)              # 37o
        fma     $dx_4,$t_y_5,$down_x,$base_x_5          # 38e
        stqd    $k_zero,112($a_packet)                  # 38o
        fm      $length_2,$dx_2,$dx_2                   # 39e
        stqd    $pixels_2,624($a_packet)                # 39o
        fma     $dy_4,$t_y_5,$down_y,$base_y_4          # 40e
        stqd    $pixels_3,576($a_packet)                # 40o
        fm      $length_3,$dx_3,$dx_3                   # 41e
        stqd    $k_zero,16($a_packet)                   # 41o
        fma     $base_y_4,$fx,$right_y,$corner_y        # 42e
        stqd    $background,464($a_packet)              # 42o
        fma     $dy_2,$t_y_3,$down_y,$base_y_3          # 43e
        stqd    $k_zero,0($a_packet)                    # 43o
        fma     $base_z_2,$fx_3,$right_z,$corner_z      # 44e
        stqd    $k_zero,64($a_packet)                   # 44o
        fm      $length_4,$dx_4,$dx_4                   # 45e
        stqd    $k_zero,128($a_packet)                  # 45o
        fm      $length_10,$dx,$dx                      # 46e
        stqd    $background,448($a_packet)              # 46o
        fma     $base_z_3,$fx_6,$right_z,$corner_z      # 47e
        stqd    $pixels_4,592($a_packet)                # 47o
        fma     $dy_7,$t_y_2,$down_y,$base_y_2          # 48e
        stqd    $k_zero,32($a_packet)                   # 48o
        fma     $base_z_6,$fx,$right_z,$corner_z        # 49e
        stqd    $k_zero,96($a_packet)                   # 49o
        fma     $dy_5,$t_y_4,$down_y,$base_y_4          # 50e
        stqd    $pixels_5,608($a_packet)                # 50o
        fma     $base_z_7,$fx_2,$right_z,$corner_z      # 51e
        stqd    $k_zero,48($a_packet)                   # 51o
        fma     $length_9,$dy_4,$dy_4,$length_4         # 52e
        stqd    $k_zero,176($a_packet)                  # 52o
        fma     $dz_2,$t_y_2,$down_z,$base_z_3          # 53e
        stqd    $background,496($a_packet)              # 53o
        fma     $length_3,$dy_7,$dy_7,$length_3         # 54e
        fma     $length_2,$dy_2,$dy_2,$length_2         # 55e
        fma     $length_6,$dy_5,$dy_5,$length_10        # 56e
        fma     $dz_3,$t_y_5,$down_z,$base_z_7          # 57e
        fma     $dz,$t_y_3,$down_z,$base_z_2            # 58e
        fma     $dz_4,$t_y_4,$down_z,$base_z_6          # 59e
        fma     $length_11,$dz_2,$dz_2,$length_3        # 60e
        cgt     $c_absent,$k_zero,$x_4                  # 61e
        cgt     $c_absent_5,$k_zero,$x_2                # 62e
        fma     $length,$dz_3,$dz_3,$length_9           # 63e
        fma     $length_9,$dz,$dz,$length_2             # 64e
        fma     $length_12,$dz_4,$dz_4,$length_6        # 65e
        andc    $weight_2,$k_one,$c_absent_2            # 66e
        frsqest $t_y,$length_11                         # 66o
        selb    $t_2,$k_far,$k_absent,$c_absent         # 67e
        lnop                                            # 67o pairing
        andc    $weight_6,$k_one,$c_absent              # 68e
        stqd    $weight_2,512($a_packet)                # 68o
        cgt     $c_absent,$k_zero,$x_3                  # 69e
        frsqest $t_y_8,$length                          # 69o
        fi      $t_y,$length_11,$t_y                    # 70e
        frsqest $t_y_6,$length_9                        # 70o
        andc    $weight_3,$k_one,$c_absent              # 71e
        frsqest $t_y_9,$length_12                       # 71o
        andc    $weight_7,$k_one,$c_absent_5            # 72e
        stqd    $t_2,416($a_packet)                     # 72o
        fi      $t_y_8,$length,$t_y_8                   # 73e
        stqd    $weight_3,560($a_packet)                # 73o
        fi      $t_y_6,$length_9,$t_y_6                 # 74e
        stqd    $weight_7,528($a_packet)                # 74o
        fi      $t_y_10,$length_12,$t_y_9               # 75e
        stqd    $weight_6,544($a_packet)                # 75o
        selb    $t_5,$k_far,$k_absent,$c_absent_2       # 76e
        fm      $t_e_7,$length_11,$t_y                  # 77e
        fm      $inverse_2,$t_y,$k_half                 # 78e
        stqd    $t_5,384($a_packet)                     # 78o
        selb    $t_6,$k_far,$k_absent,$c_absent_5       # 79e
        fm      $t_e,$length,$t_y_8                     # 80e
        fm      $t_e_3,$length_9,$t_y_6                 # 81e
        stqd    $t_6,400($a_packet)                     # 81o
        fm      $t_e_5,$length_12,$t_y_10               # 82e
        hbrr    next_packet_back,next_packet            # 82o hint
        fnms    $t_e_7,$t_e_7,$t_y,$k_one               # 83e
        fm      $inverse_8,$t_y_10,$k_half              # 84e
        fm      $inverse_6,$t_y_6,$k_half               # 85e
        fnms    $t_e,$t_e,$t_y_8,$k_one                 # 86e
        fnms    $t_e_3,$t_e_3,$t_y_6,$k_one             # 87e
        fnms    $t_e_5,$t_e_5,$t_y_10,$k_one            # 88e
        fm      $inverse_3,$t_y_8,$k_half               # 89e
        fma     $inverse_9,$t_e_7,$inverse_2,$t_y       # 90e
        selb    $t_4,$k_far,$k_absent,$c_absent         # 91e
        ai      $a_packet_2,$a_packet,320               # 92e
        fma     $inverse_6,$t_e_3,$inverse_6,$t_y_6     # 93e
        stqd    $t_4,432($a_packet)                     # 93o
        fma     $inverse,$t_e_5,$inverse_8,$t_y_10      # 94e
        fma     $inverse_7,$t_e,$inverse_3,$t_y_8       # 95e
        fm      $dz_5,$dz_2,$inverse_9                  # 96e
        fm      $dy_6,$dy_7,$inverse_9                  # 97e
        fm      $dx_5,$dx_3,$inverse_9                  # 98e
        lnop                                            # 98o pairing
        fm      $dz_6,$dz,$inverse_6                    # 99e
next_packet_back:
        brnz    $count,next_packet                      # 99o
next_packet_drain:
        fm      $dx_7,$dx_2,$inverse_6                  # 0e
        hbr     sample_rays_r16_return,$lr              # 0o hint
        fm      $dy_8,$dy_2,$inverse_6                  # 1e
        stqd    $dx_5,192($a_packet)                    # 1o
        fm      $dz,$dz_4,$inverse                      # 2e
        stqd    $dy_6,256($a_packet)                    # 2o
        fm      $dz_7,$dz_3,$inverse_7                  # 3e
        fm      $dx,$dx,$inverse                        # 4e
        fm      $dy,$dy_5,$inverse                      # 5e
        lnop                                            # 5o pairing
        fm      $dx_8,$dx_4,$inverse_7                  # 6e
        stqd    $dx_7,208($a_packet)                    # 6o
        fm      $dy_3,$dy_4,$inverse_7                  # 7e
        stqd    $dy_8,272($a_packet)                    # 7o
        ai      $a_packet_3,$a_packet_2,320             # 8e
        stqd    $dz_5,320($a_packet)                    # 8o
        stqd    $dz_6,336($a_packet)                    # 9o
        stqd    $dz,352($a_packet)                      # 10o
        stqd    $dz_7,368($a_packet)                    # 11o
        stqd    $dx,224($a_packet)                      # 12o
        stqd    $dy,288($a_packet)                      # 13o
        stqd    $dx_8,240($a_packet)                    # 14o
        stqd    $dy_3,304($a_packet)                    # 15o
sample_rays_r16_return:
        bi      $lr                                     # 16o
next_packet_short:
        ai      $count,$count,-1                        # 0e
        lqd     $place,0($a_place)                      # 0o
        ai      $a_packet_3,$a_packet,320               # 1e
        lqd     $place_5,16($a_place)                   # 1o
        lqd     $place_3,32($a_place)                   # 2o
        lqd     $place_4,48($a_place)                   # 3o
        ai      $a_place,$a_place,64                    # 4e
        stqd    $k_zero,128($a_packet)                  # 4o
        stqd    $k_zero,16($a_packet)                   # 5o
        shufb   $y,$place,$place,$m_y                   # 6o
        shufb   $x,$place,$place,$m_x                   # 7o
        shufb   $x_5,$place_3,$place_3,$m_x             # 8o
        nop     $127                                    # 9e pairing
        shufb   $x_6,$place_4,$place_4,$m_x             # 9o
        csflt   $fy,$y,0                                # 10e
        shufb   $y,$place_5,$place_5,$m_y               # 10o
        csflt   $fx_6,$x,0                              # 11e
        shufb   $y_5,$place_3,$place_3,$m_y             # 11o
        csflt   $fx_7,$x_5,0                            # 12e
        shufb   $y_6,$place_4,$place_4,$m_y             # 12o
        csflt   $fx_8,$x_6,0                            # 13e
        shufb   $x_7,$place_5,$place_5,$m_x             # 13o
        csflt   $fy_6,$y,0                              # 14e
        shufb   $pixels,$place,$place,$m_pixels         # 14o
        csflt   $fy_7,$y_5,0                            # 15e
        stqd    $k_zero,64($a_packet)                   # 15o
        csflt   $fy_8,$y_6,0                            # 16e
        stqd    $k_zero,144($a_packet)                  # 16o
        csflt   $fx_9,$x_7,0                            # 17e
        stqd    $background,448($a_packet)              # 17o
        cgt     $c_absent,$k_zero,$x                    # 18e
        stqd    $k_zero,0($a_packet)                    # 18o
        fa      $fx_6,$fx_6,$k_column                   # 19e
        stqd    $k_zero,80($a_packet)                   # 19o
        fa      $t_y,$fy,$k_row                         # 20e
        stqd    $k_zero,48($a_packet)                   # 20o
        fa      $fx_10,$fx_7,$k_column+2                # 21e
        stqd    $k_zero,176($a_packet)                  # 21o
        fa      $fx_7,$fx_8,$k_column+3                 # 22e
        shufb   $pixels_5,$place_4,$place_4,$m_pixels   # 22o
        fa      $t_y_11,$fy_8,$k_row+3                  # 23e
        shufb   $pixels_6,$place_5,$place_5,$m_pixels   # 23o
        fa      $fx_9,$fx_9,$k_column+1                 # 24e
        stqd    $k_zero,32($a_packet)                   # 24o
        fma     $base_x_5,$fx_6,$right_x,$corner_x      # 25e
        shufb   $pixels_2,$place_3,$place_3,$m_pixels   # 25o
        fma     $base_y_6,$fx_6,$right_y,$corner_y      # 26e
        stqd    $pixels_5,624($a_packet)                # 26o
        fa      $t_y_12,$fy_6,$k_row+1                  # 27e
        stqd    $pixels_6,592($a_packet)                # 27o
        fa      $t_y_13,$fy_7,$k_row+2                  # 28e
        stqd    $background,464($a_packet)              # 28o
        fma     $base_y_7,$fx_10,$right_y,$corner_y     # 29e
        stqd    $k_zero,112($a_packet)                  # 29o
        fma     $base_x_6,$fx_9,$right_x,$corner_x      # 30e
        stqd    $pixels,576($a_packet)                  # 30o
        fma     $base_y_8,$fx_9,$right_y,$corner_y      # 31e
        stqd    $background,480($a_packet)              # 31o
        fma     $dx_9,$t_y,$down_x,$base_x_5            # 32e
        stqd    $k_zero,160($a_packet)                  # 32o
        fma     $base_z_8,$fx_9,$right_z,$corner_z      # 33e
        stqd    $pixels_2,608($a_packet)                # 33o
        fma     $base_x_7,$fx_7,$right_x,$corner_x      # 34e
        stqd    $background,496($a_packet)              # 34o
        fma     $dy_9,$t_y_13,$down_y,$base_y_7         # 35e
        stqd    $k_zero,96($a_packet)                   # 35o
        fma     $dx_10,$t_y_12,$down_x,$base_x_6        # 36e
        fma     $dy_10,$t_y_12,$down_y,$base_y_8        # 37e
        fma     $base_z_3,$fx_6,$right_z,$corner_z      # 38e
        fma     $dz_4,$t_y_12,$down_z,$base_z_8         # 39e
        fma     $dy_11,$t_y,$down_y,$base_y_6           # 40e
        fma     $base_x_8,$fx_10,$right_x,$corner_x     # 41e
        fm      $length_13,$dx_10,$dx_10                # 42e
        fma     $dx_11,$t_y_11,$down_x,$base_x_7        # 43e
        fma     $dz_2,$t_y,$down_z,$base_z_3            # 44e
        fm      $length_7,$dx_9,$dx_9                   # 45e
        fma     $base_y_3,$fx_7,$right_y,$corner_y      # 46e
        fma     $dx_12,$t_y_13,$down_x,$base_x_8        # 47e
        fma     $length_13,$dy_10,$dy_10,$length_13     # 48e
        fma     $base_z_4,$fx_10,$right_z,$corner_z     # 49e
        fma     $base_z,$fx_7,$right_z,$corner_z        # 50e
        fma     $length_7,$dy_11,$dy_11,$length_7       # 51e
        fma     $dy_2,$t_y_11,$down_y,$base_y_3         # 52e
        fm      $length_14,$dx_12,$dx_12                # 53e
        fma     $length_13,$dz_4,$dz_4,$length_13       # 54e
        fma     $dz_8,$t_y_13,$down_z,$base_z_4         # 55e
        fm      $length_9,$dx_11,$dx_11                 # 56e
        fma     $length_7,$dz_2,$dz_2,$length_7         # 57e
        fma     $dz_9,$t_y_11,$down_z,$base_z           # 58e
        fma     $length_15,$dy_9,$dy_9,$length_14       # 59e
        andc    $weight,$k_one,$c_absent                # 60e
        frsqest $t_y_2,$length_13                       # 60o
        cgt     $c_absent_6,$k_zero,$x_7                # 61e
        lnop                                            # 61o pairing
        fma     $length_9,$dy_2,$dy_2,$length_9         # 62e
        stqd    $weight,512($a_packet)                  # 62o
        selb    $t,$k_far,$k_absent,$c_absent           # 63e
        frsqest $t_y_5,$length_7                        # 63o
        fi      $t_y_2,$length_13,$t_y_2                # 64e
        lnop                                            # 64o pairing
        cgt     $c_absent_7,$k_zero,$x_6                # 65e
        stqd    $t,384($a_packet)                       # 65o
        fma     $length_15,$dz_8,$dz_8,$length_15       # 66e
        fi      $t_y_5,$length_7,$t_y_5                 # 67e
        selb    $t,$k_far,$k_absent,$c_absent_6         # 68e
        fma     $length_9,$dz_9,$dz_9,$length_9         # 69e
        andc    $weight,$k_one,$c_absent_6              # 70e
        stqd    $t,400($a_packet)                       # 70o
        fm      $inverse_10,$t_y_2,$k_half              # 71e
        lnop                                            # 71o pairing
        fm      $t_e_8,$length_13,$t_y_2                # 72e
        frsqest $t_y_14,$length_15                      # 72o
        andc    $weight_3,$k_one,$c_absent_7            # 73e
        stqd    $weight,528($a_packet)                  # 73o
        fm      $t_e_9,$length_7,$t_y_5                 # 74e
        lnop                                            # 74o pairing
        fm      $inverse_11,$t_y_5,$k_half              # 75e
        frsqest $t_y_9,$length_9                        # 75o
        fi      $t_y_14,$length_15,$t_y_14              # 76e
        stqd    $weight_3,560($a_packet)                # 76o
        selb    $t_7,$k_far,$k_absent,$c_absent_7       # 77e
        fnms    $t_e_8,$t_e_8,$t_y_2,$k_one             # 78e
        fi      $t_y_15,$length_9,$t_y_9                # 79e
        stqd    $t_7,432($a_packet)                     # 79o
        cgt     $c_absent_8,$k_zero,$x_5                # 80e
        fnms    $t_e_10,$t_e_9,$t_y_5,$k_one            # 81e
        andc    $weight_8,$k_one,$c_absent_8            # 82e
        fm      $t_e_11,$length_15,$t_y_14              # 83e
        fma     $inverse_10,$t_e_8,$inverse_10,$t_y_2   # 84e
        stqd    $weight_8,544($a_packet)                # 84o
        fm      $inverse_12,$t_y_14,$k_half             # 85e
        fm      $t_e_3,$length_9,$t_y_15                # 86e
        fma     $inverse_13,$t_e_10,$inverse_11,$t_y_5  # 87e
        fm      $inverse_2,$t_y_15,$k_half              # 88e
        fnms    $t_e_11,$t_e_11,$t_y_14,$k_one          # 89e
        fm      $dy_10,$dy_10,$inverse_10               # 90e
        fm      $dz_4,$dz_4,$inverse_10                 # 91e
        fnms    $t_e_3,$t_e_3,$t_y_15,$k_one            # 92e
        fm      $dx_9,$dx_9,$inverse_13                 # 93e
        fm      $dy_11,$dy_11,$inverse_13               # 94e
        fm      $dz_10,$dz_2,$inverse_13                # 95e
        lnop                                            # 95o pairing
        fma     $inverse_14,$t_e_11,$inverse_12,$t_y_14 # 96e
        stqd    $dy_10,272($a_packet)                   # 96o
        fm      $dx_13,$dx_10,$inverse_10               # 97e
        stqd    $dz_4,336($a_packet)                    # 97o
        fma     $inverse_15,$t_e_3,$inverse_2,$t_y_15   # 98e
        lnop                                            # 98o pairing
        selb    $t,$k_far,$k_absent,$c_absent_8         # 99e
        stqd    $dx_9,192($a_packet)                    # 99o
        stqd    $dy_11,256($a_packet)                   # 100o
        stqd    $dz_10,320($a_packet)                   # 101o
        fm      $dy,$dy_9,$inverse_14                   # 102e
        stqd    $t,416($a_packet)                       # 102o
        fm      $dz,$dz_8,$inverse_14                   # 103e
        stqd    $dx_13,208($a_packet)                   # 103o
        fm      $dy_3,$dy_2,$inverse_15                 # 104e
        hbrr    next_packet_short_back,next_packet_short # 104o hint
        fm      $dx,$dx_12,$inverse_14                  # 105e
        fm      $dz_11,$dz_9,$inverse_15                # 106e
        fm      $dx_11,$dx_11,$inverse_15               # 107e
        stqd    $dy,288($a_packet)                      # 108o
        stqd    $dz,352($a_packet)                      # 109o
        stqd    $dy_3,304($a_packet)                    # 110o
        stqd    $dx,224($a_packet)                      # 111o
        stqd    $dz_11,368($a_packet)                   # 112o
        stqd    $dx_11,240($a_packet)                   # 113o
        ai      $a_packet,$a_packet_3,320               # 114e
        nop     $127                                    # 115e pairing
next_packet_short_back:
        brnz    $count,next_packet_short                # 120o
        nop     $127                                    # 116e pairing
        bi      $lr                                     # 116o
endfunction sample_rays_r16
