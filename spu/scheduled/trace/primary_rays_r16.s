# primary_rays_r16   primary rays through the centres of pixels, as packets of rays from anywhere
#   C       void primary_rays_r16(const struct place *, int count, const struct basis *,
#                             unsigned background, int width, int height);
#   In      $3 places, $4 count (at least 1), $5 basis, $6 address of the background's OBJECT,
#           $7 width and $8 height of the picture; pointers 16-aligned
#   Out     the places' RAYS16, all of their words
#   Uses    $2-$65, $79   Saves  -   Stack  0   Calls  -
#   Domain  the direction through each pixel is not 0 and below 2^63 in length; pixels below 2^23;
#           a place's pixels: the sum of its top left pixel, rows of TILE_WIDTH sums
#   Error   2 ulp of 1, each component of a direction
#   Twin    lab/twins/src/primary_rays.rs
#
# Rays beyond the right and lower edges of the picture are absent: t is -1, the weight is 0.
# Scheduled by spu schedule from primary_rays_r16.s

        .include "work_unit.inc"
        .include "macros.inc"
        .include "math.inc"
        .include "primary_ray_tmpl.inc"

        .set    NEXT,3
        registers a_place,count,a_basis,background,width
        registers height                                # of the picture
        # constants
        .set    NEXT,12
        registers k_lanes,k_far,m_splat,m_x,m_y
        .set    NEXT,44
        registers m_pixels,k_zero,k_absent
        registers k_offset                              # to 50: from the sum of the top left pixel
        .set    k_below,51                              # to 54: rows of the picture below this one
        .set    NEXT,55
        registers k_pitch
        # the packet
        .set    place,26
        .set    a_packet,27
        registers x,y,pixels,c_column
        # the row
        registers c_within,t,weight,pixel

        .set    SUM_SIZE,16

        .section .rodata
        .align  4
lanes:  .int    0,1,2,3

function primary_rays_r16
        .set count_2,79; .set y_2,2; .set a_packet_2,30; .set pixel_2,5; .set pixel_3,8
        .set base_x_2,26; .set t_y_2,27; .set t_y_3,32; .set t_y_4,29; .set base_z_2,28
        .set dx_2,34; .set dx_3,5; .set dx_4,36; .set dy_2,35; .set dx_5,39; .set dy_3,55
        .set length_2,26; .set length_3,37; .set dy_4,57; .set length_4,56; .set dy_5,31
        .set length_5,8; .set dz_2,38; .set dz_3,27; .set dz_4,32; .set dz_5,28; .set length_6,29
        .set c_within_2,9; .set t_y_5,56; .set c_within_3,14; .set t_y_6,33; .set c_within_4,2
        .set pixel_4,58; .set t_y_7,61; .set t_y_8,62; .set c_within_5,63; .set weight_2,60
        .set t_y_9,9; .set t_e_2,26; .set t_e_3,29; .set c_within_6,59; .set t_e_4,37; .set t_2,2
        .set inverse_2,60; .set inverse_3,62; .set t_e_5,8; .set inverse_4,2; .set t_e_6,64
        .set weight_3,37; .set t_3,63; .set t_4,65; .set inverse_5,58; .set inverse_6,29
        .set weight_4,56; .set dx_6,2; .set dy_6,5; .set dz_6,8; .set dx_7,9; .set dy_7,14
        .set pixel_5,2; .set c_within_7,33; .set t_y_10,58; .set t_y_11,14; .set inverse_7,61
        .set t_e_7,2; .set t_5,26; .set dy_8,2; .set dx_8,3; .set c_within_8,5; .set t_y_12,8
        .set dx_9,26; .set dx_10,28; .set dx_11,29; .set dy_9,30; .set dy_10,36; .set length_7,39
        .set length_8,55; .set length_9,31; .set dz_7,9; .set length_10,32; .set t_y_13,55
        .set c_within_9,56; .set t_y_14,57; .set t_y_15,64; .set t_y_16,65; .set weight_5,63
        .set t_6,56; .set inverse_8,63; .set t_e_8,32; .set inverse_9,56; .set t_e_9,31
        .set inverse_10,64; .set inverse_11,65; .set t_7,60; .set inverse_12,39; .set inverse_13,32
        .set weight_6,5; .set inverse_14,31; .set dz_8,5; .set dy_11,32; .set dx_12,8; .set dy_12,9
        ila     $m_splat,0x10203                        # 0e
        lqa     $k_lanes,lanes                          # 0o
        il      $k_pitch,0x400                          # 1e
        lqd     $corner_x,0($a_basis)                   # 1o
        ilhu    $m_pixels,0x405                         # 2e
        shufb   $k_below,$height,$height,$m_splat       # 2o
        ilhu    $m_x,0x809                              # 3e
        lqd     $right_x,48($a_basis)                   # 3o
        ilhu    $m_x+1,0xc0d                            # 4e
        lqd     $down_x,96($a_basis)                    # 4o
        clgti   $count_2,$count,1                       # 5e at least as many passes as overlap
        lqd     $corner_y,16($a_basis)                  # 5o
        mpyi    $k_offset,$k_lanes,16                   # 6e
        lqd     $right_y,64($a_basis)                   # 6o
        iohl    $m_pixels,0x607                         # 7e
        lqd     $down_y,112($a_basis)                   # 7o
        iohl    $m_x,0xa0b                              # 8e
        lqd     $corner_z,32($a_basis)                  # 8o
        iohl    $m_x+1,0xe0f                            # 9e
        lqd     $right_z,80($a_basis)                   # 9o
        ilhu    $k_far,0x5e80                           # 10e
        lqd     $down_z,128($a_basis)                   # 10o
        ilhu    $k_absent,0xbf80                        # 11e
        shufb   $background,$background,$background,$m_splat # 11o
        il      $k_zero,0                               # 12e
        shufb   $width,$width,$width,$m_splat           # 12o
        a       $k_offset+1,$k_offset,$k_pitch          # 13e
        ai      $k_below+1,$k_below,-1                  # 14e
        a       $k_offset+2,$k_offset+1,$k_pitch        # 15e
        ai      $k_below+2,$k_below,-2                  # 16e
        a       $k_offset+3,$k_offset+2,$k_pitch        # 17e
        ai      $k_below+3,$k_below,-3                  # 18e
        ilhu    $k_half,0x3f00                          # 19e
        ilhu    $k_one,0x3f80                           # 20e
        il      $k_row,0                                # 21e
        ilhu    $k_row+1,0x3f80                         # 22e
        ilhu    $k_row+2,0x4000                         # 23e
        lnop                                            # 23o pairing
        ilhu    $k_row+3,0x4040                         # 24e
        brz     $count_2,next_packet_short              # 24o too few passes
        ai      $count,$count,-1                        # 25e
        lqd     $place,0($a_place)                      # 25o
        ai      $a_place,$a_place,16                    # 26e
        shufb   $x,$place,$place,$m_x                   # 31o
        shufb   $y_2,$place,$place,$m_x+1               # 32o
        shufb   $pixels,$place,$place,$m_pixels         # 33o
        rotqbyi $a_packet_2,$place,0                    # 34o
        a       $x,$x,$k_lanes                          # 35e
        csflt   $fy,$y_2,0                              # 36e
        csflt   $fx,$x,0                                # 37e
        a       $pixel,$pixels,$k_offset                # 38e
        stqd    $k_zero,128($a_packet_2)                # 38o
        a       $pixel_2,$pixels,$k_offset+2            # 39e
        stqd    $background,448($a_packet_2)            # 39o
        cgt     $c_column,$width,$x                     # 40e
        stqd    $pixel,576($a_packet_2)                 # 40o
        cgt     $c_within,$k_below,$y_2                 # 41e
        stqd    $k_zero,16($a_packet_2)                 # 41o
        a       $pixel_3,$pixels,$k_offset+3            # 42e
        stqd    $k_zero,80($a_packet_2)                 # 42o
        fa      $t_y,$fy,$k_row                         # 43e
        stqd    $k_zero,144($a_packet_2)                # 43o
        fma     $base_x_2,$fx,$right_x,$corner_x        # 44e
        stqd    $background,464($a_packet_2)            # 44o
        fa      $t_y_2,$fy,$k_row+1                     # 45e
        stqd    $k_zero,32($a_packet_2)                 # 45o
        fa      $t_y_3,$fy,$k_row+2                     # 46e
        stqd    $background,480($a_packet_2)            # 46o
        fma     $base_y,$fx,$right_y,$corner_y          # 47e
        stqd    $pixel_2,608($a_packet_2)               # 47o
        fa      $t_y_4,$fy,$k_row+3                     # 48e
        stqd    $k_zero,48($a_packet_2)                 # 48o
        fma     $base_z_2,$fx,$right_z,$corner_z        # 49e
        stqd    $k_zero,112($a_packet_2)                # 49o
        fma     $dx_2,$t_y,$down_x,$base_x_2            # 50e
        stqd    $k_zero,176($a_packet_2)                # 50o
        fma     $dx_3,$t_y_2,$down_x,$base_x_2          # 51e
        stqd    $k_zero,96($a_packet_2)                 # 51o
        fma     $dx_4,$t_y_3,$down_x,$base_x_2          # 52e
        stqd    $k_zero,160($a_packet_2)                # 52o
        fma     $dy_2,$t_y,$down_y,$base_y              # 53e
        stqd    $k_zero,0($a_packet_2)                  # 53o
        fma     $dx_5,$t_y_4,$down_x,$base_x_2          # 54e
        stqd    $background,496($a_packet_2)            # 54o
        fma     $dy_3,$t_y_2,$down_y,$base_y            # 55e
        stqd    $k_zero,64($a_packet_2)                 # 55o
        fm      $length_2,$dx_2,$dx_2                   # 56e
        stqd    $pixel_3,624($a_packet_2)               # 56o
        fm      $length_3,$dx_3,$dx_3                   # 57e
        fma     $dy_4,$t_y_3,$down_y,$base_y            # 58e
        fm      $length_4,$dx_4,$dx_4                   # 59e
        fma     $dy_5,$t_y_4,$down_y,$base_y            # 60e
        fm      $length_5,$dx_5,$dx_5                   # 61e
        fma     $dz_2,$t_y,$down_z,$base_z_2            # 62e
        fma     $length_2,$dy_2,$dy_2,$length_2         # 63e
        fma     $dz_3,$t_y_2,$down_z,$base_z_2          # 64e
        fma     $length_3,$dy_3,$dy_3,$length_3         # 65e
        fma     $dz_4,$t_y_3,$down_z,$base_z_2          # 66e
        fma     $length_4,$dy_4,$dy_4,$length_4         # 67e
        fma     $dz_5,$t_y_4,$down_z,$base_z_2          # 68e
        fma     $length_5,$dy_5,$dy_5,$length_5         # 69e
        fma     $length_2,$dz_2,$dz_2,$length_2         # 70e
        fma     $length_6,$dz_3,$dz_3,$length_3         # 71e
        and     $c_within,$c_within,$c_column           # 72e
        fma     $length_3,$dz_4,$dz_4,$length_4         # 73e
        selb    $t,$k_absent,$k_far,$c_within           # 74e
        fma     $length_5,$dz_5,$dz_5,$length_5         # 75e
        lnop                                            # 75o pairing
        cgt     $c_within_2,$k_below+1,$y_2             # 76e
        frsqest $t_y_5,$length_2                        # 76o
        cgt     $c_within_3,$k_below+2,$y_2             # 77e
        frsqest $t_y_6,$length_6                        # 77o
        cgt     $c_within_4,$k_below+3,$y_2             # 78e
        stqd    $t,384($a_packet_2)                     # 78o
        a       $pixel_4,$pixels,$k_offset+1            # 79e
        frsqest $t_y_7,$length_3                        # 79o
        fi      $t_y_5,$length_2,$t_y_5                 # 80e
        lnop                                            # 80o pairing
        fi      $t_y_6,$length_6,$t_y_6                 # 81e
        frsqest $t_y_8,$length_5                        # 81o
        and     $c_within_5,$c_within_2,$c_column       # 82e
        fi      $t_y_7,$length_3,$t_y_7                 # 83e
        and     $weight_2,$c_within,$k_one              # 84e
        fi      $t_y_9,$length_5,$t_y_8                 # 85e
        and     $c_within_3,$c_within_3,$c_column       # 86e
        stqd    $weight_2,512($a_packet_2)              # 86o
        fm      $t_e_2,$length_2,$t_y_5                 # 87e
        fm      $t_e_3,$length_6,$t_y_6                 # 88e
        and     $c_within_6,$c_within_4,$c_column       # 89e
        hbrr    next_packet_back,next_packet            # 89o hint
        fm      $t_e_4,$length_3,$t_y_7                 # 90e
        selb    $t_2,$k_absent,$k_far,$c_within_5       # 91e
        fm      $inverse_2,$t_y_5,$k_half               # 92e
        lnop                                            # 92o pairing
        fm      $inverse_3,$t_y_6,$k_half               # 93e
        stqd    $t_2,400($a_packet_2)                   # 93o
        fm      $t_e_5,$length_5,$t_y_9                 # 94e
        fnms    $t_e_2,$t_e_2,$t_y_5,$k_one             # 95e
        fnms    $t_e_3,$t_e_3,$t_y_6,$k_one             # 96e
        fm      $inverse_4,$t_y_7,$k_half               # 97e
        fnms    $t_e_6,$t_e_4,$t_y_7,$k_one             # 98e
        and     $weight_3,$c_within_5,$k_one            # 99e
        selb    $t_3,$k_absent,$k_far,$c_within_3       # 100e
        lnop                                            # 100o pairing
        selb    $t_4,$k_absent,$k_far,$c_within_6       # 101e
        stqd    $weight_3,528($a_packet_2)              # 101o
        fm      $inverse,$t_y_9,$k_half                 # 102e
        stqd    $t_3,416($a_packet_2)                   # 102o
        fnms    $t_e_5,$t_e_5,$t_y_9,$k_one             # 103e
        stqd    $pixel_4,592($a_packet_2)               # 103o
        fma     $inverse_5,$t_e_2,$inverse_2,$t_y_5     # 104e
        stqd    $t_4,432($a_packet_2)                   # 104o
        fma     $inverse_6,$t_e_3,$inverse_3,$t_y_6     # 105e
        fma     $inverse_2,$t_e_6,$inverse_4,$t_y_7     # 106e
        and     $weight_4,$c_within_3,$k_one            # 107e
        lnop                                            # 107o pairing
next_packet:
            fma     $inverse,$t_e_5,$inverse,$t_y_9     # 0e
        lqd     $place,0($a_place)                      # 0o
            fm      $dx,$dx_2,$inverse_5                # 1e
            stqd    $weight_4,544($a_packet_2)          # 1o
            fm      $dy,$dy_2,$inverse_5                # 2e
            fm      $dz,$dz_2,$inverse_5                # 3e
            fm      $dx_6,$dx_3,$inverse_6              # 4e
            fm      $dy_6,$dy_3,$inverse_6              # 5e
            fm      $dz_6,$dz_3,$inverse_6              # 6e
        shufb   $x,$place,$place,$m_x                   # 6o
            fm      $dx_7,$dx_4,$inverse_2              # 7e
        shufb   $pixels,$place,$place,$m_pixels         # 7o
            fm      $dy_7,$dy_4,$inverse_2              # 8e
            stqd    $dx,192($a_packet_2)                # 8o
            fm      $dz_3,$dz_4,$inverse_2              # 9e
        shufb   $y,$place,$place,$m_x+1                 # 9o
            fm      $dx,$dx_5,$inverse                  # 10e
            stqd    $dy,256($a_packet_2)                # 10o
            fm      $dy,$dy_5,$inverse                  # 11e
            stqd    $dz,320($a_packet_2)                # 11o
            fm      $dz,$dz_5,$inverse                  # 12e
            stqd    $dy_6,272($a_packet_2)              # 12o
        a       $pixel,$pixels,$k_offset                # 13e
            stqd    $dx_6,208($a_packet_2)              # 13o
        a       $pixel_5,$pixels,$k_offset+1            # 14e
            stqd    $dy_7,288($a_packet_2)              # 14o
        a       $pixel_2,$pixels,$k_offset+2            # 15e
            stqd    $dz_6,336($a_packet_2)              # 15o
            and     $weight,$c_within_6,$k_one          # 16e
            stqd    $dx_7,224($a_packet_2)              # 16o
        a       $pixel_3,$pixels,$k_offset+3            # 17e
            stqd    $dy,304($a_packet_2)                # 17o
        a       $x,$x,$k_lanes                          # 18e
            stqd    $weight,560($a_packet_2)            # 18o
        ai      $count,$count,-1                        # 19e
            stqd    $dz,368($a_packet_2)                # 19o
        csflt   $fx,$x,0                                # 20e
            stqd    $dx,240($a_packet_2)                # 20o
        ai      $a_place,$a_place,16                    # 21e
            stqd    $dz_3,352($a_packet_2)              # 21o
        csflt   $fy,$y,0                                # 22e
        rotqbyi $a_packet_2,$place,0                    # 22o
        cgt     $c_column,$width,$x                     # 23e
        cgt     $c_within,$k_below,$y                   # 24e
        cgt     $c_within_2,$k_below+1,$y               # 25e
        lnop                                            # 25o pairing
        cgt     $c_within_3,$k_below+2,$y               # 26e
        stqd    $k_zero,128($a_packet_2)                # 26o
        fma     $base_x_2,$fx,$right_x,$corner_x        # 27e
        stqd    $background,448($a_packet_2)            # 27o
        fma     $base_y,$fx,$right_y,$corner_y          # 28e
        stqd    $pixel,576($a_packet_2)                 # 28o
        fa      $t_y,$fy,$k_row                         # 29e
        stqd    $k_zero,16($a_packet_2)                 # 29o
        fa      $t_y_2,$fy,$k_row+1                     # 30e
        stqd    $k_zero,80($a_packet_2)                 # 30o
        fa      $t_y_3,$fy,$k_row+2                     # 31e
        stqd    $k_zero,144($a_packet_2)                # 31o
        fa      $t_y_4,$fy,$k_row+3                     # 32e
        stqd    $background,464($a_packet_2)            # 32o
        fma     $base_z_2,$fx,$right_z,$corner_z        # 33e
        stqd    $k_zero,32($a_packet_2)                 # 33o
        cgt     $c_within_7,$k_below+3,$y               # 34e
        stqd    $background,480($a_packet_2)            # 34o
        fma     $dx_2,$t_y,$down_x,$base_x_2            # 35e
        stqd    $pixel_2,608($a_packet_2)               # 35o
        fma     $dx_3,$t_y_2,$down_x,$base_x_2          # 36e
        stqd    $k_zero,48($a_packet_2)                 # 36o
        fma     $dx_4,$t_y_3,$down_x,$base_x_2          # 37e
        stqd    $k_zero,112($a_packet_2)                # 37o
        fma     $dx_5,$t_y_4,$down_x,$base_x_2          # 38e
        stqd    $k_zero,176($a_packet_2)                # 38o
        fma     $dy_2,$t_y,$down_y,$base_y              # 39e
        stqd    $k_zero,96($a_packet_2)                 # 39o
        fma     $dy_3,$t_y_2,$down_y,$base_y            # 40e
        stqd    $k_zero,160($a_packet_2)                # 40o
        fm      $length_2,$dx_2,$dx_2                   # 41e
        stqd    $k_zero,0($a_packet_2)                  # 41o
        fm      $length_3,$dx_3,$dx_3                   # 42e
        stqd    $background,496($a_packet_2)            # 42o
        fma     $dy_4,$t_y_3,$down_y,$base_y            # 43e
        stqd    $k_zero,64($a_packet_2)                 # 43o
        fm      $length_4,$dx_4,$dx_4                   # 44e
        stqd    $pixel_3,624($a_packet_2)               # 44o
        fma     $dy_5,$t_y_4,$down_y,$base_y            # 45e
        fm      $length_5,$dx_5,$dx_5                   # 46e
        fma     $dz_2,$t_y,$down_z,$base_z_2            # 47e
        fma     $length_2,$dy_2,$dy_2,$length_2         # 48e
        fma     $dz_3,$t_y_2,$down_z,$base_z_2          # 49e
        fma     $length_3,$dy_3,$dy_3,$length_3         # 50e
        fma     $dz_4,$t_y_3,$down_z,$base_z_2          # 51e
        fma     $length_4,$dy_4,$dy_4,$length_4         # 52e
        fma     $dz_5,$t_y_4,$down_z,$base_z_2          # 53e
        fma     $length_5,$dy_5,$dy_5,$length_5         # 54e
        fma     $length_2,$dz_2,$dz_2,$length_2         # 55e
        fma     $length_6,$dz_3,$dz_3,$length_3         # 56e
        and     $c_within,$c_within,$c_column           # 57e
        fma     $length_3,$dz_4,$dz_4,$length_4         # 58e
        and     $c_within_2,$c_within_2,$c_column       # 59e
        fma     $length_5,$dz_5,$dz_5,$length_5         # 60e
        selb    $t,$k_absent,$k_far,$c_within           # 61e
        frsqest $t_y_5,$length_2                        # 61o
        and     $weight,$c_within,$k_one                # 62e
        frsqest $t_y_10,$length_6                       # 62o
        and     $c_within,$c_within_3,$c_column         # 63e
        stqd    $t,384($a_packet_2)                     # 63o
        and     $c_within_6,$c_within_7,$c_column       # 64e
        frsqest $t_y_11,$length_3                       # 64o
        fi      $t_y_6,$length_2,$t_y_5                 # 65e
        stqd    $weight,512($a_packet_2)                # 65o
        fi      $t_y_5,$length_6,$t_y_10                # 66e
        frsqest $t_y_10,$length_5                       # 66o
        selb    $t,$k_absent,$k_far,$c_within_2         # 67e
        fi      $t_y_11,$length_3,$t_y_11               # 68e
        and     $weight,$c_within_2,$k_one              # 69e
        stqd    $t,400($a_packet_2)                     # 69o
        fi      $t_y_9,$length_5,$t_y_10                # 70e
        lnop                                            # 70o pairing
        selb    $t,$k_absent,$k_far,$c_within           # 71e
        stqd    $weight,528($a_packet_2)                # 71o
        fm      $t_e_2,$length_2,$t_y_6                 # 72e
        lnop                                            # 72o pairing
        fm      $t_e_3,$length_6,$t_y_5                 # 73e
        stqd    $t,416($a_packet_2)                     # 73o
        fm      $inverse_5,$t_y_6,$k_half               # 74e
        fm      $t_e_4,$length_3,$t_y_11                # 75e
        fm      $inverse_7,$t_y_5,$k_half               # 76e
        fm      $t_e_5,$length_5,$t_y_9                 # 77e
        fnms    $t_e_2,$t_e_2,$t_y_6,$k_one             # 78e
        fnms    $t_e_3,$t_e_3,$t_y_5,$k_one             # 79e
        fm      $inverse_3,$t_y_11,$k_half              # 80e
        stqd    $pixel_5,592($a_packet_2)               # 80o
        fnms    $t_e_7,$t_e_4,$t_y_11,$k_one            # 81e
        fm      $inverse,$t_y_9,$k_half                 # 82e
        fnms    $t_e_5,$t_e_5,$t_y_9,$k_one             # 83e
        fma     $inverse_5,$t_e_2,$inverse_5,$t_y_6     # 84e
        selb    $t_5,$k_absent,$k_far,$c_within_6       # 85e
        fma     $inverse_6,$t_e_3,$inverse_7,$t_y_5     # 86e
        and     $weight_4,$c_within,$k_one              # 87e
        stqd    $t_5,432($a_packet_2)                   # 87o
        fma     $inverse_2,$t_e_7,$inverse_3,$t_y_11    # 88e
next_packet_back:
        brnz    $count,next_packet                      # 88o
next_packet_drain:
        fm      $dx,$dx_2,$inverse_5                    # 0e
        hbr     primary_rays_r16_return,$lr             # 0o hint
        fm      $dy,$dy_2,$inverse_5                    # 1e
        stqd    $weight_4,544($a_packet_2)              # 1o
        fma     $inverse,$t_e_5,$inverse,$t_y_9         # 2e
        fm      $dz,$dz_2,$inverse_5                    # 3e
        fm      $dy_8,$dy_3,$inverse_6                  # 4e
        fm      $dx_8,$dx_3,$inverse_6                  # 5e
        fm      $dy_7,$dy_4,$inverse_2                  # 6e
        stqd    $dx,192($a_packet_2)                    # 6o
        fm      $dz_6,$dz_3,$inverse_6                  # 7e
        stqd    $dy,256($a_packet_2)                    # 7o
        fm      $dx_7,$dx_4,$inverse_2                  # 8e
        lnop                                            # 8o pairing
        fm      $dy,$dy_5,$inverse                      # 9e
        stqd    $dz,320($a_packet_2)                    # 9o
        fm      $dz,$dz_5,$inverse                      # 10e
        stqd    $dy_8,272($a_packet_2)                  # 10o
        fm      $dx,$dx_5,$inverse                      # 11e
        stqd    $dx_8,208($a_packet_2)                  # 11o
        fm      $dz_3,$dz_4,$inverse_2                  # 12e
        stqd    $dy_7,288($a_packet_2)                  # 12o
        and     $weight,$c_within_6,$k_one              # 13e
        stqd    $dz_6,336($a_packet_2)                  # 13o
        stqd    $dx_7,224($a_packet_2)                  # 14o
        stqd    $dy,304($a_packet_2)                    # 15o
        stqd    $weight,560($a_packet_2)                # 16o
        stqd    $dz,368($a_packet_2)                    # 17o
        stqd    $dx,240($a_packet_2)                    # 18o
        stqd    $dz_3,352($a_packet_2)                  # 19o
        nop     $127                                    # 20e pairing
primary_rays_r16_return:
        bi      $lr                                     # 20o
next_packet_short:
        ai      $count,$count,-1                        # 0e
        lqd     $place,0($a_place)                      # 0o
        ai      $a_place,$a_place,16                    # 1e
        shufb   $x,$place,$place,$m_x                   # 6o
        shufb   $y,$place,$place,$m_x+1                 # 7o
        rotqbyi $a_packet,$place,0                      # 8o
        shufb   $pixels,$place,$place,$m_pixels         # 9o
        a       $x,$x,$k_lanes                          # 10e
        csflt   $fy,$y,0                                # 11e
        lnop                                            # 11o pairing
        csflt   $fx,$x,0                                # 12e
        stqd    $k_zero,0($a_packet)                    # 12o
        cgt     $c_within,$k_below+1,$y                 # 13e
        stqd    $k_zero,64($a_packet)                   # 13o
        cgt     $c_column,$width,$x                     # 14e
        stqd    $background,448($a_packet)              # 14o
        a       $pixel,$pixels,$k_offset                # 15e
        stqd    $k_zero,176($a_packet)                  # 15o
        cgt     $c_within_4,$k_below+3,$y               # 16e
        stqd    $k_zero,96($a_packet)                   # 16o
        cgt     $c_within_8,$k_below,$y                 # 17e
        stqd    $pixel,576($a_packet)                   # 17o
        fa      $t_y,$fy,$k_row+2                       # 18e
        stqd    $background,496($a_packet)              # 18o
        fma     $base_x,$fx,$right_x,$corner_x          # 19e
        stqd    $k_zero,32($a_packet)                   # 19o
        fa      $t_y_12,$fy,$k_row                      # 20e
        stqd    $background,480($a_packet)              # 20o
        fa      $t_y_9,$fy,$k_row+1                     # 21e
        stqd    $k_zero,112($a_packet)                  # 21o
        fa      $t_y_11,$fy,$k_row+3                    # 22e
        stqd    $k_zero,48($a_packet)                   # 22o
        fma     $base_z,$fx,$right_z,$corner_z          # 23e
        stqd    $background,464($a_packet)              # 23o
        fma     $base_y,$fx,$right_y,$corner_y          # 24e
        stqd    $k_zero,80($a_packet)                   # 24o
        fma     $dx,$t_y,$down_x,$base_x                # 25e
        stqd    $k_zero,144($a_packet)                  # 25o
        fma     $dx_9,$t_y_12,$down_x,$base_x           # 26e
        stqd    $k_zero,16($a_packet)                   # 26o
        fma     $dx_10,$t_y_9,$down_x,$base_x           # 27e
        stqd    $k_zero,160($a_packet)                  # 27o
        fma     $dx_11,$t_y_11,$down_x,$base_x          # 28e
        stqd    $k_zero,128($a_packet)                  # 28o
        fma     $dz,$t_y_11,$down_z,$base_z             # 29e
        fma     $dy,$t_y_12,$down_y,$base_y             # 30e
        fma     $dy_9,$t_y,$down_y,$base_y              # 31e
        fma     $dy_10,$t_y_9,$down_y,$base_y           # 32e
        fm      $length_3,$dx_10,$dx_10                 # 33e
        fm      $length_7,$dx,$dx                       # 34e
        fm      $length_8,$dx_9,$dx_9                   # 35e
        fma     $dy_7,$t_y_11,$down_y,$base_y           # 36e
        fm      $length_9,$dx_11,$dx_11                 # 37e
        fma     $dz_2,$t_y,$down_z,$base_z              # 38e
        fma     $dz_7,$t_y_9,$down_z,$base_z            # 39e
        fma     $length_7,$dy_9,$dy_9,$length_7         # 40e
        fma     $length_8,$dy,$dy,$length_8             # 41e
        fma     $dz_6,$t_y_12,$down_z,$base_z           # 42e
        fma     $length_10,$dy_10,$dy_10,$length_3      # 43e
        fma     $length_9,$dy_7,$dy_7,$length_9         # 44e
        and     $c_within_8,$c_within_8,$c_column       # 45e
        fma     $length_3,$dz_2,$dz_2,$length_7         # 46e
        a       $pixel,$pixels,$k_offset+3              # 47e
        fma     $length_7,$dz_6,$dz_6,$length_8         # 48e
        fma     $length_10,$dz_7,$dz_7,$length_10       # 49e
        stqd    $pixel,624($a_packet)                   # 49o
        fma     $length_9,$dz,$dz,$length_9             # 50e
        and     $c_within,$c_within,$c_column           # 51e
        selb    $t,$k_absent,$k_far,$c_within_8         # 52e
        frsqest $t_y_13,$length_3                       # 52o
        and     $weight,$c_within,$k_one                # 53e
        lnop                                            # 53o pairing
        cgt     $c_within_9,$k_below+2,$y               # 54e
        frsqest $t_y_14,$length_7                       # 54o
        a       $pixel,$pixels,$k_offset+2              # 55e
        frsqest $t_y_15,$length_10                      # 55o
        fi      $t_y_13,$length_3,$t_y_13               # 56e
        frsqest $t_y_16,$length_9                       # 56o
        and     $c_within_9,$c_within_9,$c_column       # 57e
        stqd    $t,384($a_packet)                       # 57o
        fi      $t_y_14,$length_7,$t_y_14               # 58e
        stqd    $pixel,608($a_packet)                   # 58o
        fi      $t_y_7,$length_10,$t_y_15               # 59e
        stqd    $weight,528($a_packet)                  # 59o
        fi      $t_y_8,$length_9,$t_y_16                # 60e
        and     $weight_5,$c_within_9,$k_one            # 61e
        selb    $t_6,$k_absent,$k_far,$c_within_9       # 62e
        lnop                                            # 62o pairing
        fm      $t_e_4,$length_3,$t_y_13                # 63e
        stqd    $weight_5,544($a_packet)                # 63o
        fm      $inverse_8,$t_y_13,$k_half              # 64e
        stqd    $t_6,416($a_packet)                     # 64o
        fm      $t_e,$length_7,$t_y_14                  # 65e
        fm      $t_e_8,$length_10,$t_y_7                # 66e
        fm      $inverse_9,$t_y_14,$k_half              # 67e
        fm      $t_e_9,$length_9,$t_y_8                 # 68e
        fm      $inverse_10,$t_y_7,$k_half              # 69e
        fnms    $t_e_4,$t_e_4,$t_y_13,$k_one            # 70e
        fnms    $t_e,$t_e,$t_y_14,$k_one                # 71e
        fnms    $t_e_8,$t_e_8,$t_y_7,$k_one             # 72e
        fm      $inverse_11,$t_y_8,$k_half              # 73e
        fnms    $t_e_9,$t_e_9,$t_y_8,$k_one             # 74e
        selb    $t_7,$k_absent,$k_far,$c_within         # 75e
        fma     $inverse,$t_e_4,$inverse_8,$t_y_13      # 76e
        fma     $inverse_12,$t_e,$inverse_9,$t_y_14     # 77e
        stqd    $t_7,400($a_packet)                     # 77o
        fma     $inverse_13,$t_e_8,$inverse_10,$t_y_7   # 78e
        and     $weight_6,$c_within_8,$k_one            # 79e
        fma     $inverse_14,$t_e_9,$inverse_11,$t_y_8   # 80e
        lnop                                            # 80o pairing
        a       $pixel,$pixels,$k_offset+1              # 81e
        stqd    $weight_6,512($a_packet)                # 81o
        fm      $dz_8,$dz_2,$inverse                    # 82e
        lnop                                            # 82o pairing
        fm      $dy_9,$dy_9,$inverse                    # 83e
        stqd    $pixel,592($a_packet)                   # 83o
        fm      $dx_10,$dx_10,$inverse_13               # 84e
        fm      $dz_7,$dz_7,$inverse_13                 # 85e
        fm      $dx_11,$dx_11,$inverse_14               # 86e
        fm      $dy_11,$dy_10,$inverse_13               # 87e
        fm      $dy,$dy,$inverse_12                     # 88e
        stqd    $dz_8,352($a_packet)                    # 88o
        fm      $dx,$dx,$inverse                        # 89e
        stqd    $dy_9,288($a_packet)                    # 89o
        fm      $dz,$dz,$inverse_14                     # 90e
        stqd    $dx_10,208($a_packet)                   # 90o
        fm      $dz_8,$dz_6,$inverse_12                 # 91e
        stqd    $dz_7,336($a_packet)                    # 91o
        fm      $dx_12,$dx_9,$inverse_12                # 92e
        stqd    $dx_11,240($a_packet)                   # 92o
        fm      $dy_12,$dy_7,$inverse_14                # 93e
        stqd    $dy_11,272($a_packet)                   # 93o
        and     $c_within,$c_within_4,$c_column         # 94e
        stqd    $dy,256($a_packet)                      # 94o
        nop     $127                                    # 95e pairing
        stqd    $dx,224($a_packet)                      # 95o
        and     $weight,$c_within,$k_one                # 96e
        stqd    $dz,368($a_packet)                      # 96o
        selb    $t,$k_absent,$k_far,$c_within           # 97e
        stqd    $dz_8,320($a_packet)                    # 97o
        stqd    $weight,560($a_packet)                  # 98o
        stqd    $dy_12,304($a_packet)                   # 99o
        stqd    $dx_12,192($a_packet)                   # 100o
        stqd    $t,432($a_packet)                       # 101o
        nop     $127                                    # 102e pairing
        brnz    $count,next_packet_short                # 102o
        nop     $127                                    # 103e pairing
        bi      $lr                                     # 103o
endfunction primary_rays_r16
