# ray_setup_r16   unit primary rays through the centres of the pixels of packets, nothing hit yet
#   C       void ray_setup_r16(const struct basis *, const struct place *, int count,
#                              unsigned background);
#   In      $3 basis, $4 places, $5 count (at least 1), $6 address of the background's record;
#           pointers 16-aligned
#   Out     the places' packets: direction, t, object
#   Uses    $2-$61, $79   Saves  -   Stack  0   Calls  -
#   Domain  the direction through each pixel is not 0 and below 2^63 in length; pixels below 2^23
#   Error   1.5 ulp of 1, each component
#   Twin    lab/twins/src/ray_setup.rs
# Scheduled by spu schedule from ray_setup_r16.s

        .include "work_unit.inc"
        .include "macros.inc"
        .include "math.inc"
        .include "primary_ray_tmpl.inc"

        .set    NEXT,3
        registers a_basis,a_place,count,background
        # constants
        .set    NEXT,12
        registers k_lanes,k_far,m_packet,m_x,m_y
        # the packet
        .set    NEXT,26
        registers place,a_packet

        .section .rodata
        .align  4
lanes:  .float  0,1,2,3

function ray_setup_r16
        .set count_2,79; .set a_place_2,2; .set a_packet_2,49; .set a_packet1_2,44; .set fy_2,28
        .set a_packet1_3,27; .set t_y_2,29; .set t_y_3,50; .set t_y_4,52; .set a_packet_3,48
        .set base_x_2,7; .set base_y_2,2; .set base_z_2,53; .set dx_2,3; .set dx_3,8; .set dy_2,9
        .set dy_3,27; .set dz_2,26; .set dx_4,14; .set length_2,3; .set dx_5,29; .set dx_6,57
        .set dy_4,37; .set dx_7,58; .set dy_5,7; .set dy_6,54; .set dy_7,61; .set length_3,2
        .set length_4,60; .set dx_8,32; .set length_5,9; .set dx_9,30; .set dz_3,45; .set dy_8,31
        .set dz_4,46; .set dy_9,47; .set length_6,8; .set t_y_5,39; .set t_y_6,3; .set t_y_7,33
        .set t_y_8,55; .set base_x_3,58; .set base_y_3,61; .set t_y_9,44; .set t_e_2,27
        .set t_e_3,2; .set inverse_2,36; .set inverse_3,28; .set t_y_10,51; .set dx_10,60
        .set inverse_4,34; .set inverse_5,33; .set inverse_6,2; .set t_e_4,9; .set dx_11,59
        .set inverse_7,55; .set dz_5,56; .set dy_10,36; .set dx_12,37; .set dy_11,2; .set dx_13,28
        .set dy_12,29; .set length_7,7; .set dy_13,3; .set t_e_5,8; .set inverse_8,27; .set dz_6,33
        .set dz_7,37; .set t_y_11,34; .set t_e_6,7; .set base_y_4,26; .set dz_8,27; .set dy_14,4
        .set dx_14,5; .set dy_15,6; .set dz_9,12; .set a_packet_4,13; .set length_8,15
        .set dx_15,16; .set dy_16,17; .set dz_10,18; .set dx_16,19; .set t_y_12,8; .set t_y_13,14
        .set inverse_9,15; .set inverse_10,10; .set dz_11,8; .set inverse_11,7; .set inverse_12,9
        .set dz_12,3; .set a_packet1_4,2; .set t_y_14,2; .set t_y_15,7; .set dx_17,9; .set dy_17,26
        .set length_9,28; .set length_10,30; .set length_11,35; .set dz_13,2; .set dz_14,7
        .set length_12,32; .set t_y_16,35; .set t_e_7,36; .set t_e_8,28; .set inverse_13,45
        .set t_e_9,30; .set inverse_14,46; .set t_e_10,32; .set inverse_15,47; .set inverse_16,48
        .set inverse_17,30; .set inverse_18,32; .set dy_18,28
        ila     $m_packet,0x10203                       # 0e
        lqa     $k_lanes,lanes                          # 0o
        ilhu    $m_x,0x809                              # 1e
        lqd     $corner_x,0($a_basis)                   # 1o
        ilhu    $m_y,0xc0d                              # 2e
        lqd     $right_x,48($a_basis)                   # 2o
        clgti   $count_2,$count,2                       # 3e at least as many passes as overlap
        lqd     $down_x,96($a_basis)                    # 3o
        iohl    $m_x,0xa0b                              # 4e
        lqd     $corner_y,16($a_basis)                  # 4o
        iohl    $m_y,0xe0f                              # 5e
        lqd     $right_y,64($a_basis)                   # 5o
        ilhu    $k_far,0x5e80                           # 6e
        lqd     $down_y,112($a_basis)                   # 6o
        ilhu    $k_half,0x3f00                          # 7e
        lqd     $corner_z,32($a_basis)                  # 7o
        ilhu    $k_one,0x3f80                           # 8e
        lqd     $right_z,80($a_basis)                   # 8o
        il      $k_row,0                                # 9e
        lqd     $down_z,128($a_basis)                   # 9o
        ilhu    $k_row+1,0x3f80                         # 10e
        shufb   $background,$background,$background,$m_packet # 10o
        ilhu    $k_row+2,0x4000                         # 11e
        lnop                                            # 11o pairing
        ilhu    $k_row+3,0x4040                         # 12e
        brz     $count_2,next_packet_short              # 12o too few passes
        ai      $a_place_2,$a_place,16                  # 13e
        lqd     $place,0($a_place)                      # 13o
        ai      $count,$count,-1                        # 14e
        ai      $a_place,$a_place_2,16                  # 15e
        ai      $count,$count,-1                        # 16e
        lnop                                            # 16o pairing
        csflt   $a_packet+1,$place,0                    # 19e its words x and y
        rotqbyi $a_packet_2,$place,0                    # 19o
        stqd    $k_far,192($a_packet_2)                 # 23o
        stqd    $background,256($a_packet_2)            # 24o
        stqd    $k_far,208($a_packet_2)                 # 25o
        shufb   $a_packet1_2,$a_packet+1,$a_packet+1,$m_x # 26o
        shufb   $fy_2,$a_packet+1,$a_packet+1,$m_y      # 27o
        stqd    $background,288($a_packet_2)            # 28o
        nop     $127                                    # 29e pairing
        stqd    $background,304($a_packet_2)            # 29o
        fa      $a_packet1_3,$a_packet1_2,$k_lanes      # 30e
        stqd    $background,272($a_packet_2)            # 30o
        fa      $t_y_2,$fy_2,$k_row+1                   # 31e
        stqd    $k_far,240($a_packet_2)                 # 31o
        fa      $t_y,$fy_2,$k_row                       # 32e
        stqd    $k_far,224($a_packet_2)                 # 32o
        fa      $t_y_3,$fy_2,$k_row+2                   # 33e
        lqd     $place,0($a_place_2)                    # 33o
        fa      $t_y_4,$fy_2,$k_row+3                   # 34e
        shlqbyi $a_packet_3,$a_packet_2,0               # 34o copy
        fma     $base_x_2,$a_packet1_3,$right_x,$corner_x # 36e
        fma     $base_y_2,$a_packet1_3,$right_y,$corner_y # 37e
        fma     $base_z_2,$a_packet1_3,$right_z,$corner_z # 38e
        lnop                                            # 38o pairing
        csflt   $a_packet+1,$place,0                    # 39e its words x and y
        rotqbyi $a_packet_2,$place,0                    # 39o
        fma     $dx_2,$t_y_2,$down_x,$base_x_2          # 42e
        lnop                                            # 42o pairing
        fma     $dx_3,$t_y,$down_x,$base_x_2            # 43e
        stqd    $k_far,192($a_packet_2)                 # 43o
        fma     $dy_2,$t_y_2,$down_y,$base_y_2          # 44e
        stqd    $background,256($a_packet_2)            # 44o
        fma     $dy_3,$t_y,$down_y,$base_y_2            # 45e
        stqd    $k_far,208($a_packet_2)                 # 45o
        fma     $dz_2,$t_y_2,$down_z,$base_z_2          # 46e
        shufb   $a_packet1_2,$a_packet+1,$a_packet+1,$m_x # 46o
        fma     $dz,$t_y,$down_z,$base_z_2              # 47e
        shufb   $fy_2,$a_packet+1,$a_packet+1,$m_y      # 47o
        fm      $length,$dx_2,$dx_2                     # 48e
        shlqbyi $dx_4,$dx_2,0                           # 48o copy
        fm      $length_2,$dx_3,$dx_3                   # 49e
        shlqbyi $dx_5,$dx_3,0                           # 49o copy
        fma     $dx_6,$t_y_4,$down_x,$base_x_2          # 50e
        shlqbyi $dy_4,$dy_2,0                           # 50o copy
        fma     $dx_7,$t_y_3,$down_x,$base_x_2          # 51e
        shlqbyi $dy_5,$dy_3,0                           # 51o copy
        fma     $dy_6,$t_y_3,$down_y,$base_y_2          # 52e
        stqd    $background,288($a_packet_2)            # 52o
        fma     $dy_7,$t_y_4,$down_y,$base_y_2          # 53e
        stqd    $background,304($a_packet_2)            # 53o
        fma     $length,$dy_2,$dy_2,$length             # 54e
        stqd    $background,272($a_packet_2)            # 54o
        fma     $length_3,$dy_3,$dy_3,$length_2         # 55e
        stqd    $k_far,240($a_packet_2)                 # 55o
        fm      $length_4,$dx_6,$dx_6                   # 56e
        shlqbyi $dx_8,$dx_6,0                           # 56o copy
        fm      $length_5,$dx_7,$dx_7                   # 57e
        shlqbyi $dx_9,$dx_7,0                           # 57o copy
        fma     $dz_3,$t_y_4,$down_z,$base_z_2          # 58e
        shlqbyi $dy_8,$dy_6,0                           # 58o copy
        fma     $dz_4,$t_y_3,$down_z,$base_z_2          # 59e
        shlqbyi $dy_9,$dy_7,0                           # 59o copy
        fma     $length,$dz_2,$dz_2,$length             # 60e
        stqd    $k_far,224($a_packet_2)                 # 60o
        fma     $length_3,$dz,$dz,$length_3             # 61e
        fma     $length_6,$dy_7,$dy_7,$length_4         # 62e
        fma     $length_5,$dy_6,$dy_6,$length_5         # 63e
        fa      $a_packet1_3,$a_packet1_2,$k_lanes      # 64e
        fa      $t_y_4,$fy_2,$k_row+3                   # 65e
        lnop                                            # 65o pairing
        fa      $t_y,$fy_2,$k_row                       # 66e
        frsqest $t_y_5,$length                          # 66o
        fa      $t_y_6,$fy_2,$k_row+1                   # 67e
        frsqest $t_y_7,$length_3                        # 67o
        fma     $length_6,$dz_3,$dz_3,$length_6         # 68e
        fma     $length_5,$dz_4,$dz_4,$length_5         # 69e
        fi      $t_y_5,$length,$t_y_5                   # 70e
        fi      $t_y_8,$length_3,$t_y_7                 # 71e
        fma     $base_x_3,$a_packet1_3,$right_x,$corner_x # 73e
        lnop                                            # 73o pairing
        fma     $base_y_3,$a_packet1_3,$right_y,$corner_y # 74e
        frsqest $t_y_7,$length_6                        # 74o
        fa      $t_y_3,$fy_2,$k_row+2                   # 75e
        frsqest $t_y_9,$length_5                        # 75o
        fma     $base_z_2,$a_packet1_3,$right_z,$corner_z # 76e
        fm      $t_e_2,$length,$t_y_5                   # 77e
        fm      $t_e_3,$length_3,$t_y_8                 # 78e
        fm      $inverse_2,$t_y_5,$k_half               # 79e
        fm      $inverse_3,$t_y_8,$k_half               # 80e
        hbrr    next_packet_back,next_packet            # 80o hint
        fi      $t_y_10,$length_6,$t_y_7                # 81e
        fi      $t_y_9,$length_5,$t_y_9                 # 82e
        fnms    $t_e_2,$t_e_2,$t_y_5,$k_one             # 84e
        fnms    $t_e_3,$t_e_3,$t_y_8,$k_one             # 85e
        fma     $dx_10,$t_y,$down_x,$base_x_3           # 86e
        fma     $dx_6,$t_y_4,$down_x,$base_x_3          # 87e
        fma     $dy_6,$t_y_3,$down_y,$base_y_3          # 88e
        fm      $inverse_4,$t_y_10,$k_half              # 89e
        fma     $inverse_5,$t_e_2,$inverse_2,$t_y_5     # 90e
        fma     $inverse_6,$t_e_3,$inverse_3,$t_y_8     # 91e
        fm      $t_e_4,$length_5,$t_y_9                 # 92e
        shlqbyi $dx_11,$dx_10,0                         # 92o copy
        fm      $inverse_7,$t_y_9,$k_half               # 93e
        fma     $dz_5,$t_y_6,$down_z,$base_z_2          # 94e
        fma     $dy_3,$t_y,$down_y,$base_y_3            # 95e
        fm      $dy_10,$dy_4,$inverse_5                 # 96e
        fm      $dz_2,$dz_2,$inverse_5                  # 97e
        fm      $dx_12,$dx_5,$inverse_6                 # 98e
        fm      $dz,$dz,$inverse_6                      # 99e
        fm      $dy_11,$dy_5,$inverse_6                 # 100e
        fma     $dx_13,$t_y_6,$down_x,$base_x_3         # 101e
        lnop                                            # 101o pairing
        fma     $dx_7,$t_y_3,$down_x,$base_x_3          # 102e
        stqd    $dy_10,80($a_packet_3)                  # 102o
        fma     $dy_12,$t_y_6,$down_y,$base_y_3         # 103e
        stqd    $dz_2,144($a_packet_3)                  # 103o
        fm      $length_7,$dx_10,$dx_10                 # 104e
        stqd    $dx_12,0($a_packet_3)                   # 104o
        fm      $length_4,$dx_6,$dx_6                   # 105e
        stqd    $dz,128($a_packet_3)                    # 105o
        fma     $dy_7,$t_y_4,$down_y,$base_y_3          # 106e
        stqd    $dy_11,64($a_packet_3)                  # 106o
next_packet:
            fm      $length,$dx_13,$dx_13               # 0e
            shlqbyi $dy_11,$dy_3,0                      # 0o copy
            fm      $t_e,$length_6,$t_y_10              # 1e
            lnop                                        # 1o pairing
            fma     $dz,$t_y,$down_z,$base_z_2          # 2e
            shlqbyi $dy_13,$dy_12,0                     # 2o copy
            fma     $length_7,$dy_3,$dy_3,$length_7     # 3e
            fnms    $t_e_5,$t_e_4,$t_y_9,$k_one         # 4e
            fm      $length_5,$dx_7,$dx_7               # 5e
            fma     $length,$dy_12,$dy_12,$length       # 6e
            fnms    $t_e,$t_e,$t_y_10,$k_one            # 7e
            lnop                                        # 7o pairing
            fm      $dx,$dx_4,$inverse_5                # 8e
        lqd     $place,0($a_place)                      # 8o
            fma     $length_7,$dz,$dz,$length_7         # 9e
            fma     $inverse,$t_e_5,$inverse_7,$t_y_9   # 10e
            fma     $length_6,$dy_7,$dy_7,$length_4     # 11e
            shlqbyi $dx_4,$dx_13,0                      # 11o copy
            fma     $length,$dz_5,$dz_5,$length         # 12e
            fma     $inverse_8,$t_e,$inverse_4,$t_y_10  # 13e
        csflt   $a_packet+1,$place,0                    # 14e its words x and y
        lnop                                            # 14o pairing
        ai      $count,$count,-1                        # 15e
            frsqest $t_y,$length_7                      # 15o
            fm      $dx_5,$dx_9,$inverse                # 16e
            shlqbyi $dx_9,$dx_7,0                       # 16o copy
            fm      $dy,$dy_8,$inverse                  # 17e
            lnop                                        # 17o pairing
            fma     $length_5,$dy_6,$dy_6,$length_5     # 18e
            shlqbyi $dy_8,$dy_6,0                       # 18o copy
            fm      $dx_8,$dx_8,$inverse_8              # 19e
            stqd    $dx,16($a_packet_3)                 # 19o
            fm      $dz_6,$dz_3,$inverse_8              # 20e
            frsqest $t_y_5,$length                      # 20o
            fm      $dy_3,$dy_9,$inverse_8              # 21e
        shufb   $a_packet1_2,$a_packet+1,$a_packet+1,$m_x # 21o
            fma     $dz_3,$t_y_4,$down_z,$base_z_2      # 22e
        shufb   $fy_2,$a_packet+1,$a_packet+1,$m_y      # 22o
            fm      $dz_7,$dz_4,$inverse                # 23e
            stqd    $dy,96($a_packet_3)                 # 23o
            fma     $dz_4,$t_y_3,$down_z,$base_z_2      # 24e
            shlqbyi $dy_9,$dy_7,0                       # 24o copy
            fi      $t_y_11,$length,$t_y_5              # 25e
            stqd    $dx_8,48($a_packet_3)               # 25o
            fi      $t_y,$length_7,$t_y                 # 26e
            stqd    $dz_6,176($a_packet_3)              # 26o
        ai      $a_place,$a_place,16                    # 27e
            stqd    $dy_3,112($a_packet_3)              # 27o
        fa      $a_packet1_3,$a_packet1_2,$k_lanes      # 28e
            stqd    $dx_5,32($a_packet_3)               # 28o
            fma     $length_6,$dz_3,$dz_3,$length_6     # 29e
            stqd    $dz_7,160($a_packet_3)              # 29o
            fma     $length_5,$dz_4,$dz_4,$length_5     # 30e
            shlqbyi $a_packet_3,$a_packet_2,0           # 30o copy
        fa      $t_y_2,$fy_2,$k_row+1                   # 31e
        rotqbyi $a_packet_2,$place,0                    # 31o
            fm      $t_e,$length,$t_y_11                # 32e
            shlqbyi $dx_8,$dx_6,0                       # 32o copy
            fm      $t_e_6,$length_7,$t_y               # 33e
            fm      $inverse,$t_y,$k_half               # 34e
        fma     $base_y_4,$a_packet1_3,$right_y,$corner_y # 35e
            frsqest $t_y_7,$length_6                    # 35o
            fm      $inverse_2,$t_y_11,$k_half          # 36e
            frsqest $t_y_9,$length_5                    # 36o
        fa      $t_y_3,$fy_2,$k_row+2                   # 37e
        stqd    $k_far,192($a_packet_2)                 # 37o
            fnms    $t_e,$t_e,$t_y_11,$k_one            # 38e
        stqd    $background,256($a_packet_2)            # 38o
            fi      $t_y_10,$length_6,$t_y_7            # 39e
        stqd    $k_far,208($a_packet_2)                 # 39o
            fi      $t_y_9,$length_5,$t_y_9             # 40e
        stqd    $background,288($a_packet_2)            # 40o
        nop     $127                                    # 41e pairing
        stqd    $background,304($a_packet_2)            # 41o
            fnms    $t_e_6,$t_e_6,$t_y,$k_one           # 42e
        stqd    $background,272($a_packet_2)            # 42o
        fa      $t_y_4,$fy_2,$k_row+3                   # 43e
        stqd    $k_far,240($a_packet_2)                 # 43o
            fma     $inverse_5,$t_e,$inverse_2,$t_y_11  # 44e
        stqd    $k_far,224($a_packet_2)                 # 44o
        fma     $base_z_2,$a_packet1_3,$right_z,$corner_z # 45e
        fma     $dy_6,$t_y_3,$down_y,$base_y_4          # 46e
            fm      $inverse_4,$t_y_10,$k_half          # 47e
            fma     $inverse,$t_e_6,$inverse,$t_y       # 48e
        fma     $base_x_2,$a_packet1_3,$right_x,$corner_x # 49e
        fa      $t_y,$fy_2,$k_row                       # 50e
            fm      $dy_13,$dy_13,$inverse_5            # 51e
            fm      $t_e_4,$length_5,$t_y_9             # 52e
            fm      $dz_8,$dz_5,$inverse_5              # 53e
            fm      $dx_13,$dx_11,$inverse              # 54e
            fm      $inverse_7,$t_y_9,$k_half           # 55e
            fm      $dz,$dz,$inverse                    # 56e
            fm      $dy_11,$dy_11,$inverse              # 57e
            stqd    $dy_13,80($a_packet_3)              # 57o
        fma     $dz_5,$t_y_2,$down_z,$base_z_2          # 58e
        lnop                                            # 58o pairing
        fma     $dx_2,$t_y,$down_x,$base_x_2            # 59e
            stqd    $dz_8,144($a_packet_3)              # 59o
        fma     $dx_6,$t_y_4,$down_x,$base_x_2          # 60e
            stqd    $dx_13,0($a_packet_3)               # 60o
        fma     $dy_3,$t_y,$down_y,$base_y_4            # 61e
        lnop                                            # 61o pairing
        fma     $dx_13,$t_y_2,$down_x,$base_x_2         # 62e
            stqd    $dz,128($a_packet_3)                # 62o
        fma     $dx_7,$t_y_3,$down_x,$base_x_2          # 63e
            stqd    $dy_11,64($a_packet_3)              # 63o
        fma     $dy_12,$t_y_2,$down_y,$base_y_4         # 64e
        lnop                                            # 64o pairing
        fm      $length_7,$dx_2,$dx_2                   # 65e
        shlqbyi $dx_11,$dx_2,0                          # 65o copy
        fm      $length_4,$dx_6,$dx_6                   # 66e
        lnop                                            # 66o pairing
        fma     $dy_7,$t_y_4,$down_y,$base_y_4          # 67e
next_packet_back:
        brnz    $count,next_packet                      # 67o
next_packet_drain:
        fm      $length,$dx_13,$dx_13                   # 0e
        shlqbyi $dy_13,$dy_12,0                         # 0o copy
        fm      $length_3,$dx_7,$dx_7                   # 1e
        shlqbyi $dy_14,$dy_3,0                          # 1o copy
        fma     $dz,$t_y,$down_z,$base_z_2              # 2e
        shlqbyi $dx_14,$dx_13,0                         # 2o copy
        fma     $length_7,$dy_3,$dy_3,$length_7         # 3e
        shlqbyi $dy_15,$dy_6,0                          # 3o copy
        fma     $dz_9,$t_y_3,$down_z,$base_z_2          # 4e
        shlqbyi $a_packet_4,$a_packet_2,0               # 4o copy
        fma     $length_8,$dy_7,$dy_7,$length_4         # 5e
        hbr     ray_setup_r16_return,$lr                # 5o hint
        fma     $length,$dy_12,$dy_12,$length           # 6e
        shlqbyi $dx_15,$dx_6,0                          # 6o copy
        fma     $length_3,$dy_6,$dy_6,$length_3         # 7e
        shlqbyi $dy_16,$dy_7,0                          # 7o copy
        fma     $dz_10,$t_y_4,$down_z,$base_z_2         # 8e
        shlqbyi $dx_16,$dx_7,0                          # 8o copy
        fma     $length_7,$dz,$dz,$length_7             # 9e
        fm      $t_e,$length_6,$t_y_10                  # 10e
        fnms    $t_e_5,$t_e_4,$t_y_9,$k_one             # 11e
        fma     $length,$dz_5,$dz_5,$length             # 12e
        fma     $length_5,$dz_9,$dz_9,$length_3         # 13e
        fma     $length_3,$dz_10,$dz_10,$length_8       # 14e
        fm      $dx,$dx_4,$inverse_5                    # 15e
        frsqest $t_y,$length_7                          # 15o
        fnms    $t_e,$t_e,$t_y_10,$k_one                # 16e
        fma     $inverse,$t_e_5,$inverse_7,$t_y_9       # 17e
        nop     $127                                    # 18e pairing
        frsqest $t_y_12,$length                         # 18o
        fi      $t_y,$length_7,$t_y                     # 19e
        frsqest $t_y_9,$length_5                        # 19o
        frsqest $t_y_13,$length_3                       # 20o
        stqd    $dx,16($a_packet_3)                     # 21o
        fi      $t_y_12,$length,$t_y_12                 # 22e
        fi      $t_y_9,$length_5,$t_y_9                 # 23e
        fi      $t_y_13,$length_3,$t_y_13               # 24e
        fm      $t_e_6,$length_7,$t_y                   # 26e
        fma     $inverse_8,$t_e,$inverse_4,$t_y_10      # 27e
        fm      $inverse_9,$t_y,$k_half                 # 28e
        fm      $t_e,$length,$t_y_12                    # 29e
        fm      $inverse_2,$t_y_12,$k_half              # 30e
        fm      $t_e_4,$length_5,$t_y_9                 # 31e
        fm      $t_e_3,$length_3,$t_y_13                # 32e
        fnms    $t_e_6,$t_e_6,$t_y,$k_one               # 33e
        fm      $dy,$dy_8,$inverse                      # 34e
        fnms    $t_e,$t_e,$t_y_12,$k_one                # 35e
        fm      $inverse_7,$t_y_9,$k_half               # 36e
        fnms    $t_e_4,$t_e_4,$t_y_9,$k_one             # 37e
        fm      $dx_8,$dx_8,$inverse_8                  # 38e
        fm      $inverse_10,$t_y_13,$k_half             # 39e
        lnop                                            # 39o pairing
        fnms    $t_e_3,$t_e_3,$t_y_13,$k_one            # 40e
        stqd    $dy,96($a_packet_3)                     # 40o
        fma     $inverse_5,$t_e,$inverse_2,$t_y_12      # 41e
        fm      $dz_11,$dz_3,$inverse_8                 # 42e
        fma     $inverse_11,$t_e_6,$inverse_9,$t_y      # 43e
        lnop                                            # 43o pairing
        fm      $dy_3,$dy_9,$inverse_8                  # 44e
        stqd    $dx_8,48($a_packet_3)                   # 44o
        fm      $dx_5,$dx_9,$inverse                    # 45e
        fm      $dz_7,$dz_4,$inverse                    # 46e
        fm      $dy_13,$dy_13,$inverse_5                # 47e
        lnop                                            # 47o pairing
        fma     $inverse_12,$t_e_4,$inverse_7,$t_y_9    # 48e
        stqd    $dz_11,176($a_packet_3)                 # 48o
        fm      $dz_11,$dz_5,$inverse_5                 # 49e
        lnop                                            # 49o pairing
        fma     $inverse_6,$t_e_3,$inverse_10,$t_y_13   # 50e
        stqd    $dy_3,112($a_packet_3)                  # 50o
        fm      $dx_13,$dx_11,$inverse_11               # 51e
        stqd    $dx_5,32($a_packet_3)                   # 51o
        fm      $dz,$dz,$inverse_11                     # 52e
        stqd    $dz_7,160($a_packet_3)                  # 52o
        fm      $dy_14,$dy_14,$inverse_11               # 53e
        stqd    $dy_13,80($a_packet_4)                  # 53o
        fm      $dx,$dx_14,$inverse_5                   # 54e
        lnop                                            # 54o pairing
        fm      $dy,$dy_15,$inverse_12                  # 55e
        stqd    $dz_11,144($a_packet_4)                 # 55o
        fm      $dx_8,$dx_15,$inverse_6                 # 56e
        lnop                                            # 56o pairing
        fm      $dz_12,$dz_10,$inverse_6                # 57e
        stqd    $dx_13,0($a_packet_4)                   # 57o
        fm      $dy_3,$dy_16,$inverse_6                 # 58e
        stqd    $dz,128($a_packet_4)                    # 58o
        fm      $dx_5,$dx_16,$inverse_12                # 59e
        stqd    $dy_14,64($a_packet_4)                  # 59o
        fm      $dz_7,$dz_9,$inverse_12                 # 60e
        stqd    $dx,16($a_packet_4)                     # 60o
        stqd    $dy,96($a_packet_4)                     # 61o
        stqd    $dx_8,48($a_packet_4)                   # 62o
        stqd    $dz_12,176($a_packet_4)                 # 63o
        stqd    $dy_3,112($a_packet_4)                  # 64o
        stqd    $dx_5,32($a_packet_4)                   # 65o
        stqd    $dz_7,160($a_packet_4)                  # 66o
        nop     $127                                    # 67e pairing
ray_setup_r16_return:
        bi      $lr                                     # 67o
next_packet_short:
        ai      $count,$count,-1                        # 0e
        lqd     $place,0($a_place)                      # 0o
        ai      $a_place,$a_place,16                    # 1e
        lnop                                            # 1o pairing
        csflt   $a_packet+1,$place,0                    # 6e its words x and y
        rotqbyi $a_packet,$place,0                      # 6o
        stqd    $k_far,192($a_packet)                   # 10o
        stqd    $background,256($a_packet)              # 11o
        stqd    $k_far,208($a_packet)                   # 12o
        shufb   $a_packet1_4,$a_packet+1,$a_packet+1,$m_x # 13o
        shufb   $fy,$a_packet+1,$a_packet+1,$m_y        # 14o
        stqd    $background,272($a_packet)              # 15o
        nop     $127                                    # 16e pairing
        stqd    $k_far,224($a_packet)                   # 16o
        fa      $a_packet+1,$a_packet1_4,$k_lanes       # 17e
        stqd    $background,288($a_packet)              # 17o
        fa      $t_y,$fy,$k_row                         # 18e
        stqd    $k_far,240($a_packet)                   # 18o
        fa      $t_y_14,$fy,$k_row+1                    # 19e
        stqd    $background,304($a_packet)              # 19o
        fa      $t_y_6,$fy,$k_row+2                     # 20e
        fa      $t_y_15,$fy,$k_row+3                    # 21e
        fma     $base_x,$a_packet+1,$right_x,$corner_x  # 23e
        fma     $base_y,$a_packet+1,$right_y,$corner_y  # 24e
        fma     $base_z,$a_packet+1,$right_z,$corner_z  # 25e
        fma     $dx,$t_y,$down_x,$base_x                # 29e
        fma     $dx_3,$t_y_14,$down_x,$base_x           # 30e
        fma     $dx_17,$t_y_6,$down_x,$base_x           # 31e
        fma     $dx_4,$t_y_15,$down_x,$base_x           # 32e
        fma     $dy,$t_y,$down_y,$base_y                # 33e
        fma     $dy_17,$t_y_14,$down_y,$base_y          # 34e
        fm      $length,$dx,$dx                         # 35e
        fm      $length_9,$dx_3,$dx_3                   # 36e
        fma     $dy_12,$t_y_6,$down_y,$base_y           # 37e
        fm      $length_10,$dx_17,$dx_17                # 38e
        fma     $dy_8,$t_y_15,$down_y,$base_y           # 39e
        fm      $length_11,$dx_4,$dx_4                  # 40e
        fma     $dz_7,$t_y,$down_z,$base_z              # 41e
        fma     $length,$dy,$dy,$length                 # 42e
        fma     $dz_13,$t_y_14,$down_z,$base_z          # 43e
        fma     $length_9,$dy_17,$dy_17,$length_9       # 44e
        fma     $dz_12,$t_y_6,$down_z,$base_z           # 45e
        fma     $length_10,$dy_12,$dy_12,$length_10     # 46e
        fma     $dz_14,$t_y_15,$down_z,$base_z          # 47e
        fma     $length_12,$dy_8,$dy_8,$length_11       # 48e
        fma     $length,$dz_7,$dz_7,$length             # 49e
        fma     $length_9,$dz_13,$dz_13,$length_9       # 50e
        fma     $length_10,$dz_12,$dz_12,$length_10     # 52e
        fma     $length_12,$dz_14,$dz_14,$length_12     # 54e
        frsqest $t_y,$length                            # 55o
        frsqest $t_y_16,$length_9                       # 56o
        frsqest $t_y_5,$length_10                       # 58o
        fi      $t_y,$length,$t_y                       # 59e
        lnop                                            # 59o pairing
        fi      $t_y_16,$length_9,$t_y_16               # 60e
        frsqest $t_y_9,$length_12                       # 60o
        fi      $t_y_5,$length_10,$t_y_5                # 62e
        fi      $t_y_9,$length_12,$t_y_9                # 64e
        fm      $t_e_7,$length,$t_y                     # 66e
        fm      $t_e_8,$length_9,$t_y_16                # 67e
        fm      $inverse_13,$t_y,$k_half                # 68e
        fm      $t_e_9,$length_10,$t_y_5                # 69e
        fm      $inverse_14,$t_y_16,$k_half             # 70e
        fm      $t_e_10,$length_12,$t_y_9               # 71e
        fnms    $t_e_7,$t_e_7,$t_y,$k_one               # 72e
        fnms    $t_e_8,$t_e_8,$t_y_16,$k_one            # 73e
        fm      $inverse_15,$t_y_5,$k_half              # 74e
        fnms    $t_e_9,$t_e_9,$t_y_5,$k_one             # 75e
        fm      $inverse_16,$t_y_9,$k_half              # 76e
        fnms    $t_e_10,$t_e_10,$t_y_9,$k_one           # 77e
        fma     $inverse_2,$t_e_7,$inverse_13,$t_y      # 78e
        fma     $inverse_3,$t_e_8,$inverse_14,$t_y_16   # 79e
        fma     $inverse_17,$t_e_9,$inverse_15,$t_y_5   # 81e
        fma     $inverse_18,$t_e_10,$inverse_16,$t_y_9  # 83e
        fm      $dx,$dx,$inverse_2                      # 84e
        fm      $dy,$dy,$inverse_2                      # 85e
        fm      $dz,$dz_7,$inverse_2                    # 86e
        fm      $dx_3,$dx_3,$inverse_3                  # 87e
        fm      $dy_17,$dy_17,$inverse_3                # 88e
        fm      $dz_13,$dz_13,$inverse_3                # 89e
        fm      $dx_17,$dx_17,$inverse_17               # 90e
        stqd    $dx,0($a_packet)                        # 90o
        fm      $dy_18,$dy_12,$inverse_17               # 91e
        stqd    $dy,64($a_packet)                       # 91o
        fm      $dz_12,$dz_12,$inverse_17               # 92e
        stqd    $dz,128($a_packet)                      # 92o
        fm      $dx,$dx_4,$inverse_18                   # 93e
        stqd    $dx_3,16($a_packet)                     # 93o
        fm      $dy,$dy_8,$inverse_18                   # 94e
        stqd    $dy_17,80($a_packet)                    # 94o
        fm      $dz,$dz_14,$inverse_18                  # 95e
        stqd    $dz_13,144($a_packet)                   # 95o
        stqd    $dx_17,32($a_packet)                    # 96o
        stqd    $dy_18,96($a_packet)                    # 97o
        stqd    $dz_12,160($a_packet)                   # 98o
        stqd    $dx,48($a_packet)                       # 99o
        stqd    $dy,112($a_packet)                      # 100o
        stqd    $dz,176($a_packet)                      # 101o
        nop     $127                                    # 102e pairing
        brnz    $count,next_packet_short                # 102o
        nop     $127                                    # 103e pairing
        bi      $lr                                     # 103o
endfunction ray_setup_r16
