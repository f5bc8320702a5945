# ray_setup_r16   unit eye rays through the centres of the pixels of packets, nothing hit yet
#   C       void ray_setup_r16(const struct basis *, const struct place *, int count,
#                              unsigned background);
#   In      $3 basis, $4 places, $5 count (at least 1), $6 address of the background's record;
#           pointers 16-aligned
#   Out     the places' packets: direction, t, object
#   Uses    $4-$6, $10-$39   Saves  -   Stack  0   Calls  -
#   Domain  the direction through each pixel is not 0 and below 2^63 in length; pixels below 2^23
#   Error   1.5 ulp of 1, each component
#   Twin    oracle/src/twin/ray_setup.rs
#
# Register k of each direction component holds row k of the 4x4 pixels, a pixel a lane:
#   d = corner + fx right + fy down, over its length
# Scheduled by spu schedule from ray_setup_r16.s

        .include "work_unit.inc"
        .include "macros.inc"
        .include "math.inc"

        .set    a_basis,3
        .set    a_place,4
        .set    count,5
        .set    background,6
        # constants
        .set    k_half,10
        .set    k_one,11
        .set    k_lanes,12
        .set    k_far,13
        .set    m_packet,14
        .set    m_x,15
        .set    m_y,16
        .set    corner_x,17
        .set    corner_y,18
        .set    corner_z,19
        .set    right_x,20
        .set    right_y,21
        .set    right_z,22
        .set    down_x,23
        .set    down_y,24
        .set    down_z,25
        # the packet
        .set    place,26
        .set    a_packet,27
        .set    fx,28
        .set    fy,29
        .set    k_row,40                                # to 43: the row's number
        # the top row's directions, without down
        .set    base_x,30
        .set    base_y,31
        .set    base_z,32
        # temporaries
        .set    dx,33
        .set    dy,34
        .set    dz,35
        .set    length,36
        .set    inverse,37
        .set    t_y,38
        .set    t_e,39

        .section .rodata
        .align  4
lanes:  .float  0,1,2,3

function ray_setup_r16
        .set    count_2,79
        .set    a_place_2,2
        .set    place_2,3
        .set    place_3,31
        .set    fx_2,9
        .set    a_packet_2,30
        .set    fx_3,2
        .set    fx_4,3
        .set    fy_2,7
        .set    fy_3,33
        .set    t_y_2,3
        .set    t_y_3,8
        .set    t_y_4,46
        .set    base_x_2,7
        .set    base_y_2,32
        .set    base_z_2,47
        .set    t_y_5,14
        .set    t_y_6,44
        .set    base_x_3,28
        .set    dx_2,29
        .set    dx_3,35
        .set    dx_4,36
        .set    dy_2,37
        .set    dy_3,39
        .set    dy_4,52
        .set    length_2,2
        .set    length_3,26
        .set    length_4,27
        .set    dz_2,53
        .set    dz_3,54
        .set    dz_4,8
        .set    length_5,3
        .set    length_6,45
        .set    dx_5,26
        .set    dz_5,27
        .set    length_7,7
        .set    length_8,38
        .set    dx_6,45
        .set    t_y_7,49
        .set    dx_7,48
        .set    t_y_8,50
        .set    t_y_9,9
        .set    t_y_10,55
        .set    t_y_11,56
        .set    dx_8,49
        .set    length_9,57
        .set    dy_5,50
        .set    t_e_2,2
        .set    t_e_3,3
        .set    t_e_4,7
        .set    inverse_2,58
        .set    inverse_3,59
        .set    inverse_4,60
        .set    dy_6,51
        .set    inverse_5,55
        .set    inverse_6,56
        .set    inverse_7,7
        .set    t_e_5,9
        .set    dy_7,57
        .set    dy_8,7
        .set    dz_6,29
        .set    dy_9,8
        .set    dz_7,7
        .set    dz_8,9
        .set    t_y_12,28
        .set    t_y_13,29
        .set    length_10,9
        .set    t_e_6,29
        .set    inverse_8,3
        .set    inverse_9,32
        .set    t_y_14,39
        .set    inverse_10,2
        .set    dx_9,39
        .set    dy_10,9
        .set    dy_11,3
        .set    dy_12,2
        .set    t_y_15,4
        .set    a_packet_3,5
        .set    dx_10,8
        .set    dz_9,12
        .set    dz_10,4
        .set    length_11,6
        .set    t_y_16,13
        .set    inverse_11,15
        .set    t_e_7,6
        .set    inverse_12,10
        .set    dz_11,14
        .set    dx_11,6
        .set    dy_13,11
        .set    dy_14,6
        .set    t_y_17,2
        .set    t_y_18,7
        .set    dx_12,9
        .set    dx_13,14
        .set    dy_15,26
        .set    length_12,28
        .set    dy_16,29
        .set    length_13,30
        .set    dy_17,31
        .set    length_14,35
        .set    dz_12,37
        .set    dz_13,2
        .set    dz_14,3
        .set    length_15,32
        .set    t_y_19,35
        .set    t_e_8,36
        .set    t_e_9,28
        .set    inverse_13,45
        .set    t_e_10,30
        .set    inverse_14,46
        .set    t_e_11,32
        .set    inverse_15,47
        .set    inverse_16,48
        .set    inverse_17,36
        .set    inverse_18,28
        .set    inverse_19,30
        .set    dy_18,28
        ila     $m_packet,0x10203                       # 0e
        lqa     $k_lanes,lanes                          # 0o

        ilhu    $m_x,0x809                              # 1e
        lqd     $corner_x,0($a_basis)                   # 1o

        ilhu    $m_y,0xc0d                              # 2e
        lqd     $right_x,48($a_basis)                   # 2o

        ilhu    $k_far,0x7fff                           # 3e
        lqd     $down_x,96($a_basis)                    # 3o

        clgti   $count_2,$count,2                       # 4e at least as many passes as overlap
        lqd     $corner_y,16($a_basis)                  # 4o

        iohl    $m_x,0xa0b                              # 5e
        lqd     $right_y,64($a_basis)                   # 5o

        iohl    $m_y,0xe0f                              # 6e
        lqd     $down_y,112($a_basis)                   # 6o

        ilhu    $k_half,0x3f00                          # 7e
        lqd     $corner_z,32($a_basis)                  # 7o

        ilhu    $k_one,0x3f80                           # 8e
        lqd     $right_z,80($a_basis)                   # 8o

        iohl    $k_far,0xffff                           # 9e
        lqd     $down_z,128($a_basis)                   # 9o

        il      $k_row,0                                # 10e
        shufb   $background,$background,$background,$m_packet # 10o

        ilhu    $k_row+1,0x3f80                         # 11e
        ilhu    $k_row+2,0x4000                         # 12e

        ilhu    $k_row+3,0x4040                         # 13e
        brz     $count_2,next_packet_short              # 13o too few passes

        ai      $a_place_2,$a_place,16                  # 14e
        lqd     $place_2,0($a_place)                    # 14o

        ai      $count,$count,-1                        # 15e
        lnop                                            # 15o pairing

        ai      $a_place,$a_place_2,16                  # 16e
        lqd     $place_3,0($a_place_2)                  # 16o

        ai      $count,$count,-1                        # 17e
        lnop                                            # 17o pairing

        csflt   $fx_2,$place_2,0                        # 20e its words x and y
        rotqbyi $a_packet_2,$place_2,0                  # 20o

        csflt   $fx_3,$place_3,0                        # 22e its words x and y
        stqd    $k_far,192($a_packet_2)                 # 24o

        stqd    $k_far,224($a_packet_2)                 # 25o
        stqd    $k_far,208($a_packet_2)                 # 26o

        shufb   $fx_4,$fx_2,$fx_2,$m_x                  # 27o
        shufb   $fy_2,$fx_2,$fx_2,$m_y                  # 28o

        shufb   $fx_2,$fx_3,$fx_3,$m_x                  # 29o
        shufb   $fy_3,$fx_3,$fx_3,$m_y                  # 30o

        fa      $fx_3,$fx_4,$k_lanes                    # 31e
        stqd    $background,272($a_packet_2)            # 31o

        fa      $t_y_2,$fy_2,$k_row                     # 32e
        stqd    $background,288($a_packet_2)            # 32o

        fa      $t_y_3,$fy_2,$k_row+3                   # 33e
        stqd    $background,304($a_packet_2)            # 33o

        fa      $t_y_4,$fy_2,$k_row+1                   # 34e
        stqd    $background,256($a_packet_2)            # 34o

        fa      $t_y,$fy_2,$k_row+2                     # 35e
        stqd    $k_far,240($a_packet_2)                 # 35o

        fa      $fx_2,$fx_2,$k_lanes                    # 36e
        fma     $base_x_2,$fx_3,$right_x,$corner_x      # 37e

        fma     $base_y_2,$fx_3,$right_y,$corner_y      # 38e
        fma     $base_z_2,$fx_3,$right_z,$corner_z      # 39e

        fa      $t_y_5,$fy_3,$k_row                     # 40e
        fa      $t_y_6,$fy_3,$k_row+3                   # 41e

        fma     $base_x_3,$fx_2,$right_x,$corner_x      # 42e
        fma     $dx_2,$t_y_3,$down_x,$base_x_2          # 43e

        fma     $dx_3,$t_y_2,$down_x,$base_x_2          # 44e
        fma     $dx_4,$t_y_4,$down_x,$base_x_2          # 45e

        fma     $dy_2,$t_y_3,$down_y,$base_y_2          # 46e
        fma     $dy_3,$t_y_2,$down_y,$base_y_2          # 47e

        fma     $dy_4,$t_y_4,$down_y,$base_y_2          # 48e
        fm      $length_2,$dx_2,$dx_2                   # 49e

        fm      $length_3,$dx_3,$dx_3                   # 50e
        fm      $length_4,$dx_4,$dx_4                   # 51e

        fma     $dz_2,$t_y_2,$down_z,$base_z_2          # 52e
        fma     $dz_3,$t_y_4,$down_z,$base_z_2          # 53e

        fma     $dz_4,$t_y_3,$down_z,$base_z_2          # 54e
        fma     $length_2,$dy_2,$dy_2,$length_2         # 55e

        fma     $length_5,$dy_3,$dy_3,$length_3         # 56e
        fma     $length_6,$dy_4,$dy_4,$length_4         # 57e

        fma     $dx_5,$t_y,$down_x,$base_x_2            # 58e
        fma     $dy,$t_y,$down_y,$base_y_2              # 59e

        fma     $dz_5,$t_y,$down_z,$base_z_2            # 60e
        fma     $length_2,$dz_4,$dz_4,$length_2         # 61e squared

        fma     $length_5,$dz_2,$dz_2,$length_5         # 62e squared
        fma     $length_7,$dz_3,$dz_3,$length_6         # 63e squared

        fm      $length_8,$dx_5,$dx_5                   # 64e
        fma     $base_y_2,$fx_2,$right_y,$corner_y      # 65e

        fa      $t_y_4,$fy_3,$k_row+1                   # 66e
        lnop                                            # 66o pairing

        fma     $dx_6,$t_y_6,$down_x,$base_x_3          # 67e
        frsqest $t_y_7,$length_2                        # 67o

        fma     $dx_7,$t_y_5,$down_x,$base_x_3          # 68e
        frsqest $t_y_8,$length_5                        # 68o

        fma     $base_z_2,$fx_2,$right_z,$corner_z      # 69e
        frsqest $t_y_9,$length_7                        # 69o

        fma     $length_8,$dy,$dy,$length_8             # 70e
        fi      $t_y_10,$length_2,$t_y_7                # 71e

        fi      $t_y_11,$length_5,$t_y_8                # 72e
        fi      $t_y_9,$length_7,$t_y_9                 # 73e

        fma     $dx_8,$t_y_4,$down_x,$base_x_3          # 75e
        fma     $length_9,$dz_5,$dz_5,$length_8         # 76e squared

        fma     $dy_5,$t_y_6,$down_y,$base_y_2          # 77e
        fm      $t_e_2,$length_2,$t_y_10                # 78e

        fm      $t_e_3,$length_5,$t_y_11                # 79e
        fm      $t_e_4,$length_7,$t_y_9                 # 80e

        fm      $inverse_2,$t_y_11,$k_half              # 81e
        hbrr    next_packet_back,next_packet            # 81o hint

        fm      $inverse_3,$t_y_10,$k_half              # 82e
        frsqest $t_y,$length_9                          # 82o

        fm      $inverse_4,$t_y_9,$k_half               # 83e
        fnms    $t_e_2,$t_e_2,$t_y_10,$k_one            # 84e

        fnms    $t_e_3,$t_e_3,$t_y_11,$k_one            # 85e
        fnms    $t_e_4,$t_e_4,$t_y_9,$k_one             # 86e

        fi      $t_y,$length_9,$t_y                     # 87e
        fma     $dy_6,$t_y_5,$down_y,$base_y_2          # 89e

        fma     $inverse_5,$t_e_2,$inverse_3,$t_y_10    # 90e
        fma     $inverse_6,$t_e_3,$inverse_2,$t_y_11    # 91e

        fma     $inverse_7,$t_e_4,$inverse_4,$t_y_9     # 92e
        fm      $length_2,$dx_6,$dx_6                   # 93e

        fm      $t_e_5,$length_9,$t_y                   # 94e
        fm      $length_5,$dx_7,$dx_7                   # 95e

        fm      $dx_2,$dx_2,$inverse_5                  # 96e
        fm      $dz_4,$dz_4,$inverse_5                  # 97e

        fm      $dx_4,$dx_4,$inverse_7                  # 98e
        fm      $dx_3,$dx_3,$inverse_6                  # 99e

        fm      $dz_3,$dz_3,$inverse_7                  # 100e
        fm      $dy_7,$dy_3,$inverse_6                  # 101e

        fm      $dy_8,$dy_4,$inverse_7                  # 102e
        stqd    $dx_2,48($a_packet_2)                   # 102o

        fm      $dz_6,$dz_2,$inverse_6                  # 103e
        stqd    $dz_4,176($a_packet_2)                  # 103o

        fm      $dy_9,$dy_2,$inverse_5                  # 104e
        stqd    $dx_4,16($a_packet_2)                   # 104o

        fma     $dy_4,$t_y_4,$down_y,$base_y_2          # 105e
        stqd    $dx_3,0($a_packet_2)                    # 105o

        fnms    $t_e,$t_e_5,$t_y,$k_one                 # 106e
        stqd    $dz_3,144($a_packet_2)                  # 106o

        stqd    $dy_7,64($a_packet_2)                   # 107o
        stqd    $dy_8,80($a_packet_2)                   # 108o

        stqd    $dz_6,128($a_packet_2)                  # 109o
        stqd    $dy_9,112($a_packet_2)                  # 110o

next_packet:
            fm      $length,$dx_8,$dx_8                 # 0e
            fm      $inverse,$t_y,$k_half               # 1e

            fma     $dz,$t_y_5,$down_z,$base_z_2        # 2e
            fma     $length_2,$dy_5,$dy_5,$length_2     # 3e

            fma     $length_5,$dy_6,$dy_6,$length_5     # 4e
            fma     $dz_7,$t_y_4,$down_z,$base_z_2      # 5e

            fma     $dz_4,$t_y_6,$down_z,$base_z_2      # 6e
            fma     $length,$dy_4,$dy_4,$length         # 7e

            fma     $inverse,$t_e,$inverse,$t_y         # 8e
            fa      $t_y,$fy_3,$k_row+2                 # 9e

            fma     $length_5,$dz,$dz,$length_5         # 10e squared
        ai      $count,$count,-1                        # 11e

            fma     $length_2,$dz_4,$dz_4,$length_2     # 12e squared
            fma     $length,$dz_7,$dz_7,$length         # 13e squared

            fm      $dx,$dx_5,$inverse                  # 14e
            fm      $dy,$dy,$inverse                    # 15e

            fm      $dz_8,$dz_5,$inverse                # 16e
            frsqest $t_y_5,$length_5                    # 16o

            fma     $dx_5,$t_y,$down_x,$base_x_3        # 17e
            lnop                                        # 17o pairing

            fma     $dz_5,$t_y,$down_z,$base_z_2        # 18e
            frsqest $t_y_12,$length_2                   # 18o

            nop     $127                                # 19e pairing
            frsqest $t_y_13,$length                     # 19o

            fi      $t_y_5,$length_5,$t_y_5             # 20e
            stqd    $dx,32($a_packet_2)                 # 20o

            nop     $127                                # 21e pairing
            stqd    $dy,96($a_packet_2)                 # 21o

            fma     $dy,$t_y,$down_y,$base_y_2          # 22e
            stqd    $dz_8,160($a_packet_2)              # 22o

            fm      $length_10,$dx_5,$dx_5              # 23e
            rotqbyi $a_packet_2,$place_3,0              # 23o

            fi      $t_y,$length_2,$t_y_12              # 24e
        lqd     $place_3,0($a_place)                    # 24o

            fi      $t_y_12,$length,$t_y_13             # 25e
        ai      $a_place,$a_place,16                    # 26e

            fm      $inverse,$t_y_5,$k_half             # 27e
            stqd    $k_far,192($a_packet_2)             # 27o

            fm      $t_e,$length_5,$t_y_5               # 28e
            stqd    $k_far,224($a_packet_2)             # 28o

            fma     $length_5,$dy,$dy,$length_10        # 29e
            stqd    $k_far,208($a_packet_2)             # 29o

        csflt   $fx_2,$place_3,0                        # 30e its words x and y
            stqd    $background,272($a_packet_2)        # 30o

            nop     $127                                # 31e pairing
            stqd    $background,288($a_packet_2)        # 31o

            fm      $t_e_2,$length_2,$t_y               # 32e
            stqd    $background,304($a_packet_2)        # 32o

            fm      $t_e_6,$length,$t_y_12              # 33e
            stqd    $background,256($a_packet_2)        # 33o

            fnms    $t_e,$t_e,$t_y_5,$k_one             # 34e
            stqd    $k_far,240($a_packet_2)             # 34o

            fma     $length,$dz_5,$dz_5,$length_5       # 35e squared
            fm      $inverse_8,$t_y,$k_half             # 36e

            fm      $inverse_9,$t_y_12,$k_half          # 37e
        shufb   $fy_3,$fx_2,$fx_2,$m_y                  # 37o

            fnms    $t_e_2,$t_e_2,$t_y,$k_one           # 38e
        shufb   $fx_2,$fx_2,$fx_2,$m_x                  # 38o

            fnms    $t_e_6,$t_e_6,$t_y_12,$k_one        # 39e
            fma     $inverse,$t_e,$inverse,$t_y_5       # 40e

        fa      $t_y_5,$fy_3,$k_row                     # 41e
            frsqest $t_y_14,$length                     # 41o

        fa      $fx_2,$fx_2,$k_lanes                    # 42e
        fa      $t_y_6,$fy_3,$k_row+3                   # 43e

            fma     $inverse_10,$t_e_2,$inverse_8,$t_y  # 44e
            fma     $inverse_8,$t_e_6,$inverse_9,$t_y_12 # 45e

            fi      $t_y,$length,$t_y_14                # 46e
        fma     $base_x_3,$fx_2,$right_x,$corner_x      # 48e

        fma     $base_y_2,$fx_2,$right_y,$corner_y      # 49e
            fm      $dx_2,$dx_6,$inverse_10             # 50e

            fm      $dz_4,$dz_4,$inverse_10             # 51e
            fm      $dx_9,$dx_8,$inverse_8              # 52e

            fm      $dx_6,$dx_7,$inverse                # 53e
            fm      $dz_7,$dz_7,$inverse_8              # 54e

        fa      $t_y_4,$fy_3,$k_row+1                   # 55e
        lnop                                            # 55o pairing

        fma     $base_z_2,$fx_2,$right_z,$corner_z      # 56e
            stqd    $dx_2,48($a_packet_2)               # 56o

            fm      $dy_10,$dy_6,$inverse               # 57e
            stqd    $dz_4,176($a_packet_2)              # 57o

            fm      $dy_11,$dy_4,$inverse_8             # 58e
            stqd    $dx_9,16($a_packet_2)               # 58o

            fm      $dz,$dz,$inverse                    # 59e
            stqd    $dx_6,0($a_packet_2)                # 59o

            fm      $dy_12,$dy_5,$inverse_10            # 60e
            stqd    $dz_7,144($a_packet_2)              # 60o

        fma     $dx_6,$t_y_6,$down_x,$base_x_3          # 61e
        fma     $dx_7,$t_y_5,$down_x,$base_x_3          # 62e

        fma     $dx_8,$t_y_4,$down_x,$base_x_3          # 63e
            stqd    $dy_10,64($a_packet_2)              # 63o

            fm      $t_e,$length,$t_y                   # 64e
            stqd    $dy_11,80($a_packet_2)              # 64o

        fma     $dy_5,$t_y_6,$down_y,$base_y_2          # 65e
            stqd    $dz,128($a_packet_2)                # 65o

        fma     $dy_6,$t_y_5,$down_y,$base_y_2          # 66e
            stqd    $dy_12,112($a_packet_2)             # 66o

        fm      $length_2,$dx_6,$dx_6                   # 67e
        fm      $length_5,$dx_7,$dx_7                   # 68e

        fma     $dy_4,$t_y_4,$down_y,$base_y_2          # 69e
        lnop                                            # 69o pairing

            fnms    $t_e,$t_e,$t_y,$k_one               # 70e
next_packet_back:
        brnz    $count,next_packet                      # 70o

next_packet_drain:
        fa      $t_y_15,$fy_3,$k_row+2                  # 0e
        hbr     ray_setup_r16_return,$lr                # 0o hint

        fm      $length,$dx_8,$dx_8                     # 1e
        rotqbyi $a_packet_3,$place_3,0                  # 1o

        fma     $dz,$t_y_5,$down_z,$base_z_2            # 2e
        fma     $length_2,$dy_5,$dy_5,$length_2         # 3e

        fma     $length_5,$dy_6,$dy_6,$length_5         # 4e
        lnop                                            # 4o pairing

        fma     $dz_7,$t_y_4,$down_z,$base_z_2          # 5e
        stqd    $k_far,192($a_packet_3)                 # 5o

        fma     $dx_10,$t_y_15,$down_x,$base_x_3        # 6e
        stqd    $k_far,224($a_packet_3)                 # 6o

        fma     $dy_10,$t_y_15,$down_y,$base_y_2        # 7e
        stqd    $k_far,208($a_packet_3)                 # 7o

        fma     $dz_9,$t_y_6,$down_z,$base_z_2          # 8e
        stqd    $background,272($a_packet_3)            # 8o

        fma     $length,$dy_4,$dy_4,$length             # 9e
        stqd    $background,288($a_packet_3)            # 9o

        fma     $dz_10,$t_y_15,$down_z,$base_z_2        # 10e
        stqd    $background,304($a_packet_3)            # 10o

        fma     $length_5,$dz,$dz,$length_5             # 11e squared
        stqd    $background,256($a_packet_3)            # 11o

        fm      $length_11,$dx_10,$dx_10                # 12e
        stqd    $k_far,240($a_packet_3)                 # 12o

        fm      $inverse,$t_y,$k_half                   # 13e
        fma     $length_2,$dz_9,$dz_9,$length_2         # 14e squared

        fma     $length,$dz_7,$dz_7,$length             # 15e squared
        frsqest $t_y_5,$length_5                        # 17o

        fma     $length_11,$dy_10,$dy_10,$length_11     # 18e
        fma     $inverse,$t_e,$inverse,$t_y             # 19e

        nop     $127                                    # 20e pairing
        frsqest $t_y_12,$length_2                       # 20o

        fi      $t_y_5,$length_5,$t_y_5                 # 21e
        frsqest $t_y_13,$length                         # 21o

        fma     $length_11,$dz_10,$dz_10,$length_11     # 24e squared
        fi      $t_y,$length_2,$t_y_12                  # 25e

        fi      $t_y_12,$length,$t_y_13                 # 26e
        fm      $t_e,$length_5,$t_y_5                   # 28e

        fm      $inverse_8,$t_y_5,$k_half               # 29e
        lnop                                            # 29o pairing

        fm      $dx,$dx_5,$inverse                      # 30e
        frsqest $t_y_16,$length_11                      # 30o

        fm      $dy,$dy,$inverse                        # 31e
        fm      $t_e_2,$length_2,$t_y                   # 32e

        fm      $t_e_6,$length,$t_y_12                  # 33e
        fi      $t_y_16,$length_11,$t_y_16              # 34e

        fnms    $t_e,$t_e,$t_y_5,$k_one                 # 36e
        stqd    $dx,32($a_packet_2)                     # 36o

        fm      $inverse_11,$t_y,$k_half                # 37e
        stqd    $dy,96($a_packet_2)                     # 37o

        fm      $inverse_9,$t_y_12,$k_half              # 38e
        fnms    $t_e_2,$t_e_2,$t_y,$k_one               # 39e

        fnms    $t_e_6,$t_e_6,$t_y_12,$k_one            # 40e
        fm      $t_e_7,$length_11,$t_y_16               # 41e

        fm      $inverse_12,$t_y_16,$k_half             # 42e
        fma     $inverse_8,$t_e,$inverse_8,$t_y_5       # 43e

        fm      $dz_11,$dz_5,$inverse                   # 44e
        fma     $inverse_10,$t_e_2,$inverse_11,$t_y     # 45e

        fma     $inverse_11,$t_e_6,$inverse_9,$t_y_12   # 46e
        fnms    $t_e,$t_e_7,$t_y_16,$k_one              # 47e

        fm      $dx_11,$dx_7,$inverse_8                 # 49e
        lnop                                            # 49o pairing

        fm      $dy_13,$dy_6,$inverse_8                 # 50e
        stqd    $dz_11,160($a_packet_2)                 # 50o

        fm      $dx_2,$dx_6,$inverse_10                 # 51e
        fm      $dz_9,$dz_9,$inverse_10                 # 52e

        fma     $inverse,$t_e,$inverse_12,$t_y_16       # 53e
        fm      $dx_9,$dx_8,$inverse_11                 # 54e

        fm      $dz_7,$dz_7,$inverse_11                 # 55e
        stqd    $dx_11,0($a_packet_3)                   # 55o

        fm      $dy_14,$dy_4,$inverse_11                # 56e
        stqd    $dy_13,64($a_packet_3)                  # 56o

        fm      $dz,$dz,$inverse_8                      # 57e
        stqd    $dx_2,48($a_packet_3)                   # 57o

        fm      $dy_12,$dy_5,$inverse_10                # 58e
        stqd    $dz_9,176($a_packet_3)                  # 58o

        fm      $dx,$dx_10,$inverse                     # 59e
        lnop                                            # 59o pairing

        fm      $dy,$dy_10,$inverse                     # 60e
        stqd    $dx_9,16($a_packet_3)                   # 60o

        fm      $dz_8,$dz_10,$inverse                   # 61e
        stqd    $dz_7,144($a_packet_3)                  # 61o

        stqd    $dy_14,80($a_packet_3)                  # 62o
        stqd    $dz,128($a_packet_3)                    # 63o

        stqd    $dy_12,112($a_packet_3)                 # 64o
        stqd    $dx,32($a_packet_3)                     # 65o

        stqd    $dy,96($a_packet_3)                     # 66o
        stqd    $dz_8,160($a_packet_3)                  # 67o

        nop     $127                                    # 68e pairing
ray_setup_r16_return:
        bi      $lr                                     # 68o

next_packet_short:
        ai      $count,$count,-1                        # 0e
        lqd     $place,0($a_place)                      # 0o

        ai      $a_place,$a_place,16                    # 1e
        lnop                                            # 1o pairing

        csflt   $fx,$place,0                            # 6e its words x and y
        rotqbyi $a_packet,$place,0                      # 6o

        stqd    $k_far,192($a_packet)                   # 10o
        stqd    $background,256($a_packet)              # 11o

        stqd    $k_far,208($a_packet)                   # 12o
        shufb   $fx_3,$fx,$fx,$m_x                      # 13o

        shufb   $fy,$fx,$fx,$m_y                        # 14o
        stqd    $background,272($a_packet)              # 15o

        nop     $127                                    # 16e pairing
        stqd    $k_far,224($a_packet)                   # 16o

        fa      $fx,$fx_3,$k_lanes                      # 17e
        stqd    $background,288($a_packet)              # 17o

        fa      $t_y,$fy,$k_row                         # 18e
        stqd    $k_far,240($a_packet)                   # 18o

        fa      $t_y_17,$fy,$k_row+1                    # 19e
        stqd    $background,304($a_packet)              # 19o

        fa      $t_y_2,$fy,$k_row+2                     # 20e
        fa      $t_y_18,$fy,$k_row+3                    # 21e

        fma     $base_x,$fx,$right_x,$corner_x          # 23e
        fma     $base_y,$fx,$right_y,$corner_y          # 24e

        fma     $base_z,$fx,$right_z,$corner_z          # 25e
        fma     $dx,$t_y,$down_x,$base_x                # 29e

        fma     $dx_10,$t_y_17,$down_x,$base_x          # 30e
        fma     $dx_12,$t_y_2,$down_x,$base_x           # 31e

        fma     $dx_13,$t_y_18,$down_x,$base_x          # 32e
        fma     $dy,$t_y,$down_y,$base_y                # 33e

        fma     $dy_15,$t_y_17,$down_y,$base_y          # 34e
        fm      $length,$dx,$dx                         # 35e

        fm      $length_12,$dx_10,$dx_10                # 36e
        fma     $dy_16,$t_y_2,$down_y,$base_y           # 37e

        fm      $length_13,$dx_12,$dx_12                # 38e
        fma     $dy_17,$t_y_18,$down_y,$base_y          # 39e

        fm      $length_14,$dx_13,$dx_13                # 40e
        fma     $dz_12,$t_y,$down_z,$base_z             # 41e

        fma     $length,$dy,$dy,$length                 # 42e
        fma     $dz_13,$t_y_17,$down_z,$base_z          # 43e

        fma     $length_12,$dy_15,$dy_15,$length_12     # 44e
        fma     $dz_14,$t_y_2,$down_z,$base_z           # 45e

        fma     $length_13,$dy_16,$dy_16,$length_13     # 46e
        fma     $dz_7,$t_y_18,$down_z,$base_z           # 47e

        fma     $length_15,$dy_17,$dy_17,$length_14     # 48e
        fma     $length,$dz_12,$dz_12,$length           # 49e squared

        fma     $length_12,$dz_13,$dz_13,$length_12     # 50e squared
        fma     $length_13,$dz_14,$dz_14,$length_13     # 52e squared

        fma     $length_15,$dz_7,$dz_7,$length_15       # 54e squared
        frsqest $t_y,$length                            # 55o

        frsqest $t_y_19,$length_12                      # 56o
        frsqest $t_y_14,$length_13                      # 58o

        fi      $t_y,$length,$t_y                       # 59e
        lnop                                            # 59o pairing

        fi      $t_y_19,$length_12,$t_y_19              # 60e
        frsqest $t_y_6,$length_15                       # 60o

        fi      $t_y_14,$length_13,$t_y_14              # 62e
        fi      $t_y_6,$length_15,$t_y_6                # 64e

        fm      $t_e_8,$length,$t_y                     # 66e
        fm      $t_e_9,$length_12,$t_y_19               # 67e

        fm      $inverse_13,$t_y,$k_half                # 68e
        fm      $t_e_10,$length_13,$t_y_14              # 69e

        fm      $inverse_14,$t_y_19,$k_half             # 70e
        fm      $t_e_11,$length_15,$t_y_6               # 71e

        fnms    $t_e_8,$t_e_8,$t_y,$k_one               # 72e
        fnms    $t_e_9,$t_e_9,$t_y_19,$k_one            # 73e

        fm      $inverse_15,$t_y_14,$k_half             # 74e
        fnms    $t_e_10,$t_e_10,$t_y_14,$k_one          # 75e

        fm      $inverse_16,$t_y_6,$k_half              # 76e
        fnms    $t_e_11,$t_e_11,$t_y_6,$k_one           # 77e

        fma     $inverse_17,$t_e_8,$inverse_13,$t_y     # 78e
        fma     $inverse_18,$t_e_9,$inverse_14,$t_y_19  # 79e

        fma     $inverse_19,$t_e_10,$inverse_15,$t_y_14 # 81e
        fma     $inverse_9,$t_e_11,$inverse_16,$t_y_6   # 83e

        fm      $dx,$dx,$inverse_17                     # 84e
        fm      $dy,$dy,$inverse_17                     # 85e

        fm      $dz,$dz_12,$inverse_17                  # 86e
        fm      $dx_10,$dx_10,$inverse_18               # 87e

        fm      $dy_15,$dy_15,$inverse_18               # 88e
        fm      $dz_13,$dz_13,$inverse_18               # 89e

        fm      $dx_12,$dx_12,$inverse_19               # 90e
        stqd    $dx,0($a_packet)                        # 90o

        fm      $dy_18,$dy_16,$inverse_19               # 91e
        stqd    $dy,64($a_packet)                       # 91o

        fm      $dz_14,$dz_14,$inverse_19               # 92e
        stqd    $dz,128($a_packet)                      # 92o

        fm      $dx,$dx_13,$inverse_9                   # 93e
        stqd    $dx_10,16($a_packet)                    # 93o

        fm      $dy,$dy_17,$inverse_9                   # 94e
        stqd    $dy_15,80($a_packet)                    # 94o

        fm      $dz,$dz_7,$inverse_9                    # 95e
        stqd    $dz_13,144($a_packet)                   # 95o

        stqd    $dx_12,32($a_packet)                    # 96o
        stqd    $dy_18,96($a_packet)                    # 97o

        stqd    $dz_14,160($a_packet)                   # 98o
        stqd    $dx,48($a_packet)                       # 99o

        stqd    $dy,112($a_packet)                      # 100o
        stqd    $dz,176($a_packet)                      # 101o

        nop     $127                                    # 102e pairing
        brnz    $count,next_packet_short                # 102o

        nop     $127                                    # 103e pairing
        bi      $lr                                     # 103o
endfunction ray_setup_r16
