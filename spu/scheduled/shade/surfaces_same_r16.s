# surfaces_same_r16   surfaces_r16 for packets whose sixteen rays have all hit the same object
#   C       vec_uint4 surfaces_same_r16(const struct rays16 *, int count, struct surfaces *,
#                                       const struct object *background);
#   In      $3 rays, $4 packets (at least 1), $5 surfaces; rays and surfaces one behind the other
#           $6 the background's object; pointers 16-aligned
#   Out     the packets' surfaces, the bits that surfaces_r16 gives
#           $3 rays that hit something, a count a lane
#   Uses    $2-$79   Saves  -   Stack  0   Calls  -
#   Domain  that of surfaces_r16; in a packet all rays have the same object, also those that are
#           not there
#   Error   0.15 of SURFACES_leave, distance of a point from its surface
#   Twin    lab/twins/src/surfaces.rs
#
# Splats replace the gathers. same_objects_r16 finds the packets for which this is possible.
# Scheduled by spu schedule from surfaces_same_r16.s

        .include "surface_tmpl.inc"

        # shuffles
        .set    m_x,54
        .set    m_y,55
        .set    m_z,56
        .set    m_w,57
        .set    m_index,58
        # the object and its material
        .set    quad,59
        .set    quad_sides,60
        .set    a_material,61
        .set    row0,62

# A word of a quadword, in every lane.
.macro  splats out0:req, out1:req, out2:req
        shufb   \out0,$quad,$quad,$m_x
        shufb   \out1,$quad,$quad,$m_y
        shufb   \out2,$quad,$quad,$m_z
.endm

.macro  keep_splat word:req, field:req
        shufb   $row0,$quad,$quad,$m_\word
        keep    $row0,\field
.endm

.macro  keep_splat_share word:req, field:req
        shufb   $row0,$quad,$quad,$m_\word
        keep_share row0,\field
.endm

function surfaces_same_r16
        .set count_2,79; .set last_2,2; .set direction_y_2,26; .set a_rays_2,19; .set quad_2,28
        .set quad_3,30; .set direction_z_2,29; .set point_z_2,31; .set there_2,27
        .set direction_x_2,18; .set centre_x_2,3; .set centre_y_2,21; .set direction_z_3,37
        .set axis_x_2,22; .set point_z_3,17; .set centre_z_2,23; .set axis_y_2,3
        .set leave_point_2,21; .set t_e_2,29; .set slope_2,30; .set t_e_3,32; .set gain_2,31
        .set offset_2,23; .set normal_x_2,35; .set quad_4,34; .set quad_5,36
        .set leave_object_2,42; .set row0_2,43; .set quad_6,46; .set row0_3,47
        .set leave_point_3,20; .set row0_4,21; .set row0_5,46; .set row0_6,48; .set row0_7,49
        .set row0_8,51; .set row0_9,71; .set a_rays_3,28; .set leave_object_3,50; .set row0_10,20
        .set row0_11,58; .set row0_12,67; .set off_x_2,49; .set row0_13,3; .set off_squared_2,20
        .set object_2,33; .set point_y_2,36; .set direction_x_3,29; .set row0_14,52
        .set point_x_2,27; .set a_surfaces_2,22; .set t_2,38; .set miss_2,42; .set t_e_4,34
        .set direction_y_3,47; .set point_x_3,53; .set quad_7,43; .set off_squared_3,60
        .set direction_z_4,20; .set point_z_4,19; .set quad_sides_2,63; .set miss_3,33
        .set centre_x_3,42; .set point_y_3,65; .set centre_y_3,36; .set leave_point_4,64
        .set axis_x_3,69; .set t_y_2,33; .set off_x_3,42; .set centre_z_3,66; .set axis_y_3,38
        .set direction_z_5,73; .set t_y_3,68; .set t_e_5,70; .set off_y_2,72; .set row0_15,36
        .set along_2,74; .set off_z_2,75; .set t_e_6,21; .set quad_8,51; .set t_e_7,64
        .set quad_9,77; .set t_out_2,66; .set along_3,46; .set point_z_5,70; .set quad_10,19
        .set quad_11,20; .set t_e_8,58; .set flags_2,20; .set row0_16,64; .set slope_3,48
        .set flags_3,67; .set t_out_3,71; .set offset_3,43; .set off_x_4,64; .set leave_object_4,76
        .set off_y_3,66; .set gain_3,42; .set normal_y_2,68; .set row0_17,28; .set off_z_3,72
        .set point_x_4,63; .set t_out_4,31; .set normal_x_3,74; .set row0_18,38
        .set off_squared_4,78; .set seen_2,21; .set direction_x_4,69; .set along_4,75
        .set normal_x_4,29; .set height_2,16; .set normal_y_3,39; .set row0_19,23; .set row0_20,35
        .set off_squared_5,19; .set direction_y_4,77; .set row0_21,40; .set t_e_9,18
        .set height_3,30; .set off_squared_6,53; .set t_e_10,2; .set point_x_5,51
        .set point_z_6,24; .set point_y_4,49; .set flip_2,18; .set normal_x_5,19; .set m_index_2,2
        .set row0_22,2; .set a_rays_4,2; .set row0_23,19; .set centre_x_4,18; .set centre_y_4,20
        .set axis_x_4,2; .set axis_y_4,18; .set quad_12,23; .set quad_13,31; .set quad_14,35
        .set quad_15,42; .set normal_x_6,44; .set normal_y_4,47; .set leave_object_5,30
        .set off_squared_7,17; .set off_squared_8,2; .set seen_3,17; .set normal_z_2,4
        .set a_surfaces_3,6; .set quad_16,10; .set a_surfaces_4,3; .set front_2,2; .set a_rays_5,26
        .set point_z_7,27; .set direction_z_6,28; .set a_surfaces_5,2; .set centre_y_5,18
        .set quad_17,18; .set t_e_11,23; .set quad_18,26; .set quad_19,27; .set row0_24,29
        .set row0_25,27; .set row0_26,42; .set row0_27,18; .set row0_28,31; .set row0_29,32
        .set row0_30,33; .set seen_4,37; .set off_squared_9,36; .set off_squared_10,18
        shli    $count,$count,2                         # 0e
        ila     $t_y,0x10203                            # 1e
        ilhu    $m_x,1                                  # 2e
        lnop                                            # 2o pairing
        ilhu    $m_y,0x405                              # 3e
        shufb   $background,$background,$background,$t_y # 3o
        ilhu    $m_z,0x809                              # 4e
        ilhu    $m_w,0xc0d                              # 5e
        il      $a_flags,0x640                          # 6e
        clgti   $count_2,$count,2                       # 7e at least as many passes as overlap
        iohl    $m_x,515                                # 8e
        iohl    $m_y,0x607                              # 9e
        iohl    $m_z,0xa0b                              # 10e
        iohl    $m_w,0xe0f                              # 11e
        ilhu    $k_half,0x3f00                          # 12e
        ilhu    $k_one,0x3f80                           # 13e
        ilhu    $k_sign,0x8000                          # 14e
        ilhu    $k_leave,0x3580                         # 15e
        il      $k_rays_gap,576                         # 16e
        il      $k_surfaces_gap,0x610                   # 17e
        il      $k_packet,0x650                         # 18e
        il      $hits,0                                 # 19e
        il      $seen,0                                 # 20e
        lnop                                            # 20o pairing
        a       $a_flags,$a_surfaces,$a_flags           # 21e
        brz     $count_2,next_row_short                 # 21o too few passes
        andi    $last,$count,3                          # 22e
        lqd     $object,448($a_rays)                    # 22o
        ai      $count,$count,-1                        # 23e
        lqd     $direction_x,192($a_rays)               # 23o
        ceqi    $last,$last,1                           # 24e
        lqd     $point_x,0($a_rays)                     # 24o
        andi    $last_2,$count,3                        # 25e
        lqd     $t,384($a_rays)                         # 25o
        and     $t_e,$last,$k_rays_gap                  # 26e
        lqd     $point_y,64($a_rays)                    # 26o
        ceqi    $last_2,$last_2,1                       # 27e
        lqd     $direction_y_2,256($a_rays)             # 27o
        a       $a_rays_2,$a_rays,$t_e                  # 28e
        lqd     $quad_2,0($object)                      # 28o
        ceq     $miss,$object,$background               # 29e
        lqd     $quad_3,16($object)                     # 29o
        ai      $a_rays_2,$a_rays_2,16                  # 30e
        lqd     $direction_z_2,320($a_rays)             # 30o
        fma     $point_x,$t,$direction_x,$point_x       # 31e
        lqd     $point_z_2,128($a_rays)                 # 31o
        cgti    $there_2,$t,-1                          # 32e
        lqd     $quad_sides,32($object)                 # 32o
        fma     $point_y,$t,$direction_y_2,$point_y     # 33e
        shlqbyi $direction_x_2,$direction_x,0           # 33o copy
        andc    $miss,$there_2,$miss                    # 34e
        shufb   $centre_x_2,$quad_2,$quad_2,$m_x        # 34o
        and     $t_e,$last_2,$k_rays_gap                # 35e
        shufb   $centre_y_2,$quad_2,$quad_2,$m_y        # 35o
        ori     $direction_z_3,$direction_z_2,0         # 36e copy
        shufb   $axis_x_2,$quad_3,$quad_3,$m_x          # 36o
        fma     $point_z_3,$t,$direction_z_2,$point_z_2 # 37e
        shufb   $centre_z_2,$quad_2,$quad_2,$m_z        # 37o
        fs      $off_x,$point_x,$centre_x_2             # 38e
        shufb   $axis_y_2,$quad_3,$quad_3,$m_y          # 38o
        fs      $off_y,$point_y,$centre_y_2             # 39e
        shufb   $axis_z,$quad_3,$quad_3,$m_z            # 39o
        andc    $leave_point_2,$point_x,$k_sign         # 40e
        shufb   $a_material,$quad_sides,$quad_sides,$m_z # 40o
        andc    $t_e_2,$point_y,$k_sign                 # 41e
        shufb   $slope_2,$quad_3,$quad_3,$m_w           # 41o
        and     $t_e_3,$last,$k_surfaces_gap            # 42e
        shufb   $gain_2,$quad_2,$quad_2,$m_w            # 42o
        fs      $off_z,$point_z_3,$centre_z_2           # 43e
        shufb   $offset_2,$quad_sides,$quad_sides,$m_x  # 43o
        fm      $along,$off_x,$axis_x_2                 # 44e
        lqd     $quad_2,48($a_material)                 # 44o
        fm      $normal_x_2,$slope_2,$axis_x_2          # 45e
        lqd     $quad_4,0($a_material)                  # 45o
        fm      $normal_y,$slope_2,$axis_y_2            # 46e
        lqd     $quad_5,16($a_material)                 # 46o
        fm      $normal_z,$slope_2,$axis_z              # 47e
        shlqbyi $direction_y_2,$direction_y_2,0         # 47o copy
        fa      $leave_point_2,$leave_point_2,$t_e_2    # 48e
        shlqbyi $point_x,$point_x,0                     # 48o copy
        andc    $t_e_2,$point_z_3,$k_sign               # 49e
        shufb   $leave_object_2,$quad_sides,$quad_sides,$m_y # 49o
        fma     $along,$off_y,$axis_y_2,$along          # 50e
        shufb   $row0_2,$quad_2,$quad_2,$m_x            # 50o
        or      $quad_6,$quad_2,$quad_sides             # 51e
        shufb   $row0_3,$quad_4,$quad_4,$m_z            # 51o
        ori     $point_z_3,$point_z_3,0                 # 52e copy
        shufb   $row0,$quad_5,$quad_5,$m_z              # 52o
        sf      $hits,$miss,$hits                       # 53e
        shufb   $flags,$quad_6,$quad_6,$m_w             # 53o
        fa      $leave_point_3,$leave_point_2,$t_e_2    # 54e
        shufb   $row0_4,$quad_2,$quad_2,$m_z            # 54o
        and     $t_e_2,$last,$k_packet                  # 55e
        shufb   $row0_5,$quad_4,$quad_4,$m_y            # 55o
        fma     $along,$off_z,$axis_z,$along            # 56e
        shufb   $row0_6,$quad_4,$quad_4,$m_x            # 56o
        and     $flags,$flags,$there_2                  # 57e
        shufb   $row0_7,$quad_5,$quad_5,$m_w            # 57o
        and     $row0_8,$row0,$there_2                  # 58e
        shufb   $row0_9,$quad_2,$quad_2,$m_y            # 58o
        a       $a_rays_3,$a_rays_2,$t_e                # 59e
        orx     $flags,$flags                           # 59o
        fma     $leave_object_3,$leave_point_3,$k_leave,$leave_object_2 # 60e
        shufb   $row0_10,$quad_4,$quad_4,$m_w           # 60o
        and     $row0_11,$row0_7,$there_2               # 61e
        shufb   $row0_12,$quad_5,$quad_5,$m_y           # 61o
        fnms    $off_x_2,$along,$axis_x_2,$off_x        # 62e
        shlqbyi $point_y,$point_y,0                     # 62o copy
        fnms    $off_y,$along,$axis_y_2,$off_y          # 63e
        shufb   $row0_13,$quad_5,$quad_5,$m_x           # 63o
        fnms    $off_z,$along,$axis_z,$off_z            # 64e
        or      $seen,$seen,$flags                      # 65e
        ori     $along,$along,0                         # 66e copy
        lnop                                            # 66o pairing
        and     $row0,$row0_10,$there_2                 # 67e
        stqd    $seen,0($a_flags)                       # 67o
        fm      $off_squared_2,$off_x_2,$off_x_2        # 68e
        lqd     $object_2,448($a_rays_2)                # 68o
        andc    $seen,$seen,$last                       # 69e
        lqd     $point_y_2,64($a_rays_2)                # 69o
        ai      $count,$count,-1                        # 70e
        lqd     $quad,32($a_material)                   # 70o
        a       $a_flags,$a_flags,$t_e_2                # 71e
        lqd     $direction_x_3,192($a_rays_2)           # 71o
        and     $row0_14,$row0_13,$there_2              # 72e
        lqd     $point_x_2,0($a_rays_2)                 # 72o
        a       $a_surfaces_2,$a_surfaces,$t_e_3        # 73e
        lqd     $t_2,384($a_rays_2)                     # 73o
        fma     $off_squared_2,$off_y,$off_y,$off_squared_2 # 74e
        stqd    $row0_3,768($a_surfaces)                # 74o
        ceq     $miss_2,$object_2,$background           # 75e
        stqd    $row0_2,0x540($a_surfaces)              # 75o
        and     $t_e_3,$last_2,$k_surfaces_gap          # 76e
        stqd    $a_material,0x600($a_surfaces)          # 76o
        ai      $a_rays,$a_rays_3,16                    # 77e
        lqd     $quad_2,0($object_2)                    # 77o
        and     $t_e_4,$last_2,$k_packet                # 78e
        lqd     $direction_y_3,256($a_rays_2)           # 78o
        fma     $point_x_3,$t_2,$direction_x_3,$point_x_2 # 79e
        lqd     $quad_7,16($object_2)                   # 79o
        fma     $off_squared_3,$off_z,$off_z,$off_squared_2 # 80e
        lqd     $direction_z_4,320($a_rays_2)           # 80o
        cgti    $there_2,$t_2,-1                        # 81e
        lqd     $point_z_4,128($a_rays_2)               # 81o
        nop     $127                                    # 82e pairing
        lqd     $quad_sides_2,32($object_2)             # 82o
        andc    $miss_3,$there_2,$miss_2                # 83e
        shufb   $centre_x_3,$quad_2,$quad_2,$m_x        # 83o
        fma     $point_y_3,$t_2,$direction_y_3,$point_y_2 # 84e
        shufb   $centre_y_3,$quad_2,$quad_2,$m_y        # 84o
        andc    $leave_point_4,$point_x_3,$k_sign       # 85e
        shufb   $axis_x_3,$quad_7,$quad_7,$m_x          # 85o
        sf      $hits,$miss_3,$hits                     # 86e
        frsqest $t_y_2,$off_squared_3                   # 86o
        fs      $off_x_3,$point_x_3,$centre_x_3         # 87e
        shufb   $centre_z_3,$quad_2,$quad_2,$m_z        # 87o
        fma     $point_z_4,$t_2,$direction_z_4,$point_z_4 # 88e
        shufb   $axis_y_3,$quad_7,$quad_7,$m_y          # 88o
        ori     $direction_z_5,$direction_z_4,0         # 89e copy
        shufb   $row0_10,$quad,$quad,$m_w               # 89o
        fi      $t_y_3,$off_squared_3,$t_y_2            # 90e
        shufb   $a_material,$quad_sides_2,$quad_sides_2,$m_z # 90o
        andc    $t_e_5,$point_y_3,$k_sign               # 91e
        shufb   $axis_z,$quad_7,$quad_7,$m_z            # 91o
        fs      $off_y_2,$point_y_3,$centre_y_3         # 92e
        shufb   $row0_15,$quad,$quad,$m_z               # 92o
        fm      $along_2,$off_x_3,$axis_x_3             # 93e
        stqd    $row0_10,0x500($a_surfaces)             # 93o
        fs      $off_z_2,$point_z_4,$centre_z_3         # 94e
        stqd    $row0_4,0x5c0($a_surfaces)              # 94o
        fa      $leave_point_3,$leave_point_4,$t_e_5    # 95e
        stqd    $row0_8,0x400($a_surfaces)              # 95o
        andc    $t_e_6,$point_z_4,$k_sign               # 96e
        lqd     $quad_8,48($a_material)                 # 96o
        fm      $t_e_7,$off_squared_3,$t_y_3            # 97e
        lqd     $quad_9,16($a_material)                 # 97o
        fm      $t_out_2,$t_y_3,$k_half                 # 98e
        stqd    $row0_5,704($a_surfaces)                # 98o
        fma     $along_3,$off_y_2,$axis_y_3,$along_2    # 99e
        stqd    $row0_6,640($a_surfaces)                # 99o
        ori     $point_z_5,$point_z_4,0                 # 100e copy
        lqd     $quad_10,0($a_material)                 # 100o
        fa      $leave_point_2,$leave_point_3,$t_e_6    # 101e
        stqd    $row0_15,0x4c0($a_surfaces)             # 101o
        or      $quad_11,$quad_8,$quad_sides_2          # 102e
        stqd    $row0_11,0x440($a_surfaces)             # 102o
        fnms    $t_e_8,$t_e_7,$t_y_3,$k_one             # 103e
        stqd    $row0_9,0x580($a_surfaces)              # 103o
        nop     $127                                    # 104e pairing
        shufb   $flags_2,$quad_11,$quad_11,$m_w         # 104o
        fma     $along_3,$off_z_2,$axis_z,$along_3      # 105e
        shufb   $row0_16,$quad_9,$quad_9,$m_w           # 105o
        shufb   $slope_3,$quad_7,$quad_7,$m_w           # 106o
        stqd    $row0_12,960($a_surfaces)               # 107o
        and     $flags_3,$flags_2,$there_2              # 108e
        shufb   $row0_15,$quad_8,$quad_8,$m_z           # 108o
        fma     $t_out_3,$t_e_8,$t_out_2,$t_y_3         # 109e
        shufb   $offset_3,$quad_sides_2,$quad_sides_2,$m_x # 109o
        and     $row0_11,$row0_16,$there_2              # 110e
        shufb   $row0_10,$quad_10,$quad_10,$m_w         # 110o
        fnms    $off_x_4,$along_3,$axis_x_3,$off_x_3    # 111e
        shufb   $leave_object_4,$quad_sides_2,$quad_sides_2,$m_y # 111o
        fnms    $off_y_3,$along_3,$axis_y_3,$off_y_2    # 112e
        shufb   $gain_3,$quad_2,$quad_2,$m_w            # 112o
        fm      $normal_y_2,$slope_3,$axis_y_3          # 113e
        shufb   $row0_17,$quad_9,$quad_9,$m_x           # 113o
        fnms    $off_z_3,$along_3,$axis_z,$off_z_2      # 114e
        shlqbyi $point_x_4,$point_x_3,0                 # 114o copy
        fm      $t_out_4,$t_out_3,$gain_2               # 115e
        orx     $flags,$flags_3                         # 115o
        fm      $normal_x_3,$slope_3,$axis_x_3          # 116e
        shufb   $row0_18,$quad_10,$quad_10,$m_z         # 116o
        fm      $off_squared_4,$off_x_4,$off_x_4        # 117e
        shlqbyi $point_y_3,$point_y_3,0                 # 117o copy
        fma     $leave_object_4,$leave_point_2,$k_leave,$leave_object_4 # 118e
        shufb   $row0_12,$quad_9,$quad_9,$m_y           # 118o
        or      $seen_2,$seen,$flags                    # 119e
        shlqbyi $direction_x_4,$direction_x_3,0         # 119o copy
        ori     $along_4,$along_3,0                     # 120e copy
        shufb   $row0_9,$quad_8,$quad_8,$m_y            # 120o
        fma     $normal_x_4,$t_out_4,$off_x_2,$normal_x_2 # 121e
        shufb   $row0_5,$quad_10,$quad_10,$m_x          # 121o
        fms     $height_2,$off_squared_3,$t_out_4,$offset_2 # 122e
        shufb   $row0_7,$quad_9,$quad_9,$m_z            # 122o
        fma     $normal_y_3,$t_out_4,$off_y,$normal_y   # 123e
        shufb   $row0_19,$quad_8,$quad_8,$m_x           # 123o
        fma     $normal_z,$t_out_4,$off_z,$normal_z     # 124e
        shufb   $row0_20,$quad_10,$quad_10,$m_y         # 124o
        fma     $off_squared_5,$off_y_3,$off_y_3,$off_squared_4 # 125e
        shlqbyi $direction_y_4,$direction_y_3,0         # 125o copy
        and     $row0_21,$row0_7,$there_2               # 126e
        fm      $t_e_9,$normal_x_4,$direction_x_2       # 127e
        fma     $height_3,$slope_2,$along,$height_2     # 128e
        andc    $seen,$seen_2,$last_2                   # 129e
        fma     $off_squared_6,$off_z_3,$off_z_3,$off_squared_5 # 131e
        fma     $t_e_10,$normal_y_3,$direction_y_2,$t_e_9 # 133e
        fnms    $point_x_5,$height_3,$normal_x_4,$point_x # 134e
        fnms    $point_z_6,$height_3,$normal_z,$point_z_3 # 135e
        fnms    $point_y_4,$height_3,$normal_y_3,$point_y # 136e
        fma     $t_e_10,$normal_z,$direction_z_3,$t_e_10 # 139e
        stqd    $point_x_5,0($a_surfaces)               # 140o
        stqd    $row0,832($a_surfaces)                  # 141o
        stqd    $point_z_6,128($a_surfaces)             # 142o
        hbrr    next_row_back,next_row                  # 143o hint
        nop     $127                                    # 144e pairing
        stqd    $row0_14,896($a_surfaces)               # 144o
        andc    $flip_2,$k_sign,$t_e_10                 # 145e
        stqd    $leave_object_3,576($a_surfaces)        # 145o
        rotmai  $front,$t_e_10,-31                      # 146e
        stqd    $point_y_4,64($a_surfaces)              # 146o
        xor     $normal_x_5,$normal_x_4,$flip_2         # 147e
        stqd    $seen_2,0($a_flags)                     # 147o
        xor     $normal_y,$normal_y_3,$flip_2           # 148e
        lnop                                            # 148o pairing
        xor     $normal_z,$normal_z,$flip_2             # 149e
        stqd    $normal_x_5,192($a_surfaces)            # 149o
        selb    $m_index_2,$m_y,$m_x,$front             # 150e
        stqd    $normal_y,256($a_surfaces)              # 150o
        stqd    $normal_y,448($a_surfaces)              # 151o
        stqd    $normal_x_5,384($a_surfaces)            # 152o
        nop     $127                                    # 153e pairing
        stqd    $normal_z,512($a_surfaces)              # 153o
next_row:
        andi    $last,$count,3                          # 0e
            stqd    $normal_z,320($a_surfaces)          # 0o
        ai      $count,$count,-1                        # 1e
            frsqest $t_y,$off_squared_6                 # 1o
            and     $row0,$row0_10,$there_2             # 2e
        lqd     $point_y,64($a_rays)                    # 2o
        ceqi    $last,$last,1                           # 3e
            shufb   $row0_22,$quad,$quad,$m_index_2     # 3o
            fm      $normal_z,$slope_3,$axis_z          # 4e
        lqd     $object,448($a_rays)                    # 4o
            fi      $t_y,$off_squared_6,$t_y            # 5e
            lqd     $quad,32($a_material)               # 5o
            a       $a_flags,$a_flags,$t_e_4            # 6e
        lqd     $direction_x,192($a_rays)               # 6o
        and     $t_e,$last,$k_rays_gap                  # 7e
            stqd    $row0_22,0x480($a_surfaces)         # 7o
            ai      $a_surfaces,$a_surfaces_2,16        # 8e
        lqd     $point_x,0($a_rays)                     # 8o
        a       $a_rays_4,$a_rays,$t_e                  # 9e
        lqd     $t,384($a_rays)                         # 9o
        ceq     $miss,$object,$background               # 10e
            stqd    $row0_18,768($a_surfaces)           # 10o
            and     $row0_23,$row0_17,$there_2          # 11e
            stqd    $row0_19,0x540($a_surfaces)         # 11o
            fm      $t_e,$off_squared_6,$t_y            # 12e
            stqd    $a_material,0x600($a_surfaces)      # 12o
            a       $a_surfaces_2,$a_surfaces,$t_e_3    # 13e
            shufb   $row0_19,$quad,$quad,$m_w           # 13o
            fm      $t_out,$t_y,$k_half                 # 14e
        lqd     $direction_y_2,256($a_rays)             # 14o
        cgti    $there_2,$t,-1                          # 15e
        lqd     $quad_2,0($object)                      # 15o
        fma     $point_x,$t,$direction_x,$point_x       # 16e
        lqd     $direction_z_2,320($a_rays)             # 16o
        andc    $miss,$there_2,$miss                    # 17e
        lqd     $quad_3,16($object)                     # 17o
            fnms    $t_e,$t_e,$t_y,$k_one               # 18e
        lqd     $point_z_2,128($a_rays)                 # 18o
        and     $t_e_3,$last,$k_surfaces_gap            # 19e
        lqd     $quad_sides,32($object)                 # 19o
        fma     $point_y,$t,$direction_y_2,$point_y     # 20e
            stqd    $row0_19,0x500($a_surfaces)         # 20o
        sf      $hits,$miss,$hits                       # 21e
        shufb   $centre_x_4,$quad_2,$quad_2,$m_x        # 21o
        andc    $leave_point,$point_x,$k_sign           # 22e
        shufb   $centre_y_4,$quad_2,$quad_2,$m_y        # 22o
        ai      $a_rays,$a_rays_4,16                    # 23e
        shufb   $axis_z,$quad_3,$quad_3,$m_z            # 23o
            fma     $t_out,$t_e,$t_out,$t_y             # 24e
        shufb   $axis_x_4,$quad_3,$quad_3,$m_x          # 24o
        fma     $point_z_3,$t,$direction_z_2,$point_z_2 # 25e
        shufb   $centre_z_2,$quad_2,$quad_2,$m_z        # 25o
        fs      $off_x,$point_x,$centre_x_4             # 26e
        shufb   $axis_y_4,$quad_3,$quad_3,$m_y          # 26o
        andc    $t_e,$point_y,$k_sign                   # 27e
        shufb   $a_material,$quad_sides,$quad_sides,$m_z # 27o
        fs      $off_y,$point_y,$centre_y_4             # 28e
            stqd    $row0_15,0x5c0($a_surfaces)         # 28o
        fa      $leave_point,$leave_point,$t_e          # 29e
            stqd    $row0_21,0x400($a_surfaces)         # 29o
            fm      $t_out,$t_out,$gain_3               # 30e
            shufb   $row0_10,$quad,$quad,$m_z           # 30o
        fs      $off_z,$point_z_3,$centre_z_2           # 31e
        lqd     $quad_12,48($a_material)                # 31o
        fm      $along,$off_x,$axis_x_4                 # 32e
        lqd     $quad_13,16($a_material)                # 32o
        andc    $t_e,$point_z_3,$k_sign                 # 33e
            stqd    $row0_20,704($a_surfaces)           # 33o
        and     $t_e_4,$last,$k_packet                  # 34e
            stqd    $row0_5,640($a_surfaces)            # 34o
        fa      $leave_point,$leave_point,$t_e          # 35e
        lqd     $quad_14,0($a_material)                 # 35o
            fms     $height,$off_squared_6,$t_out,$offset_3 # 36e
            stqd    $row0_10,0x4c0($a_surfaces)         # 36o
            fma     $normal_z,$t_out,$off_z_3,$normal_z # 37e
        shufb   $row0_15,$quad_12,$quad_12,$m_z         # 37o
        fma     $along,$off_y,$axis_y_4,$along          # 38e
        shufb   $row0_10,$quad_13,$quad_13,$m_w         # 38o
        or      $quad_15,$quad_12,$quad_sides           # 39e
        shufb   $offset_3,$quad_sides,$quad_sides,$m_x  # 39o
            fma     $normal_x_6,$t_out,$off_x_4,$normal_x_3 # 40e
            stqd    $row0_11,0x440($a_surfaces)         # 40o
            fma     $normal_y_4,$t_out,$off_y_3,$normal_y_2 # 41e
        shufb   $flags,$quad_15,$quad_15,$m_w           # 41o
            fma     $height,$slope_3,$along_4,$height   # 42e
        shufb   $slope_3,$quad_3,$quad_3,$m_w           # 42o
        and     $row0_11,$row0_10,$there_2              # 43e
        shufb   $row0_10,$quad_14,$quad_14,$m_w         # 43o
        fma     $along,$off_z,$axis_z,$along            # 44e
        shufb   $leave_object_5,$quad_sides,$quad_sides,$m_y # 44o
            nop     $127                                # 45e pairing
            stqd    $row0_9,0x580($a_surfaces)          # 45o
            fm      $t_e,$normal_x_6,$direction_x_4     # 46e
        shufb   $gain_3,$quad_2,$quad_2,$m_w            # 46o
        and     $flags,$flags,$there_2                  # 47e
        shufb   $row0_17,$quad_13,$quad_13,$m_x         # 47o
            fnms    $point_y_4,$height,$normal_y_4,$point_y_3 # 48e
            stqd    $row0_12,960($a_surfaces)           # 48o
            fnms    $point_x_5,$height,$normal_x_6,$point_x_4 # 49e
        shlqbyi $point_x_4,$point_x,0                   # 49o copy
        fnms    $off_x_4,$along,$axis_x_4,$off_x        # 50e
        orx     $flags,$flags                           # 50o
            fnms    $point_z_6,$height,$normal_z,$point_z_5 # 51e
        shufb   $row0_18,$quad_14,$quad_14,$m_z         # 51o
            fma     $t_e,$normal_y_4,$direction_y_4,$t_e # 52e
        shlqbyi $point_y_3,$point_y,0                   # 52o copy
        fnms    $off_y_3,$along,$axis_y_4,$off_y        # 53e
        shufb   $row0_12,$quad_13,$quad_13,$m_y         # 53o
        fm      $normal_y_2,$slope_3,$axis_y_4          # 54e
        shlqbyi $direction_x_4,$direction_x,0           # 54o copy
        ori     $point_z_5,$point_z_3,0                 # 55e copy
            stqd    $point_x_5,0($a_surfaces)           # 55o
        fm      $off_squared_7,$off_x_4,$off_x_4        # 56e
        shufb   $row0_9,$quad_12,$quad_12,$m_y          # 56o
        fnms    $off_z_3,$along,$axis_z,$off_z          # 57e
        shufb   $row0_5,$quad_14,$quad_14,$m_x          # 57o
            fma     $t_e,$normal_z,$direction_z_5,$t_e  # 58e
            stqd    $row0,832($a_surfaces)              # 58o
        ori     $direction_z_5,$direction_z_2,0         # 59e copy
            stqd    $point_z_6,128($a_surfaces)         # 59o
        fm      $normal_x_3,$slope_3,$axis_x_4          # 60e
        shufb   $row0_19,$quad_12,$quad_12,$m_x         # 60o
        ori     $along_4,$along,0                       # 61e copy
            stqd    $row0_23,896($a_surfaces)           # 61o
        fma     $off_squared_8,$off_y_3,$off_y_3,$off_squared_7 # 62e
        shufb   $row0_20,$quad_14,$quad_14,$m_y         # 62o
        or      $seen_3,$seen,$flags                    # 63e
            stqd    $leave_object_4,576($a_surfaces)    # 63o
            andc    $flip_2,$k_sign,$t_e                # 64e
        shufb   $row0,$quad_13,$quad_13,$m_z            # 64o
        fma     $leave_object_4,$leave_point,$k_leave,$leave_object_5 # 65e
        shlqbyi $direction_y_4,$direction_y_2,0         # 65o copy
            xor     $normal_x_5,$normal_x_6,$flip_2     # 66e
            stqd    $point_y_4,64($a_surfaces)          # 66o
            xor     $normal_y,$normal_y_4,$flip_2       # 67e
        stqd    $seen_3,0($a_flags)                     # 67o
            rotmai  $front,$t_e,-31                     # 68e
            stqd    $normal_x_5,192($a_surfaces)        # 68o
        fma     $off_squared_6,$off_z_3,$off_z_3,$off_squared_8 # 69e
            stqd    $normal_y,256($a_surfaces)          # 69o
            xor     $normal_z,$normal_z,$flip_2         # 70e
            stqd    $normal_y,448($a_surfaces)          # 70o
        and     $row0_21,$row0,$there_2                 # 71e
            stqd    $normal_x_5,384($a_surfaces)        # 71o
            selb    $m_index_2,$m_y,$m_x,$front         # 72e
            stqd    $normal_z,512($a_surfaces)          # 72o
        andc    $seen,$seen_3,$last                     # 73e
next_row_back:
        brnz    $count,next_row                         # 73o
next_row_drain:
        fm      $normal_z_2,$slope_3,$axis_z            # 0e
        frsqest $t_y,$off_squared_6                     # 0o
        ai      $a_surfaces_3,$a_surfaces_2,16          # 1e
        stqd    $normal_z,320($a_surfaces)              # 1o
        and     $row0,$row0_10,$there_2                 # 2e
        lqd     $quad_16,32($a_material)                # 2o
        and     $row0_23,$row0_17,$there_2              # 3e
        shufb   $row0_22,$quad,$quad,$m_index_2         # 3o
        fi      $t_y,$off_squared_6,$t_y                # 4e
        hbr     surfaces_same_r16_return,$lr            # 4o hint
        a       $a_surfaces_2,$a_surfaces_3,$t_e_3      # 5e
        a       $a_flags,$a_flags,$t_e_4                # 6e
        ai      $a_surfaces_4,$a_surfaces_2,16          # 7e
        stqd    $row0_22,0x480($a_surfaces)             # 7o
        ori     $a_rays,$hits,0                         # 8e
        shufb   $row0_22,$quad_16,$quad_16,$m_w         # 8o
        stqd    $row0_18,768($a_surfaces_3)             # 9o
        stqd    $row0_19,0x540($a_surfaces_3)           # 10o
        fm      $t_e,$off_squared_6,$t_y                # 11e
        stqd    $a_material,0x600($a_surfaces_3)        # 11o
        fm      $t_out,$t_y,$k_half                     # 12e
        stqd    $row0_22,0x500($a_surfaces_3)           # 12o
        stqd    $row0_15,0x5c0($a_surfaces_3)           # 13o
        shufb   $row0_10,$quad_16,$quad_16,$m_z         # 14o
        stqd    $row0_21,0x400($a_surfaces_3)           # 15o
        stqd    $row0_20,704($a_surfaces_3)             # 16o
        fnms    $t_e,$t_e,$t_y,$k_one                   # 17e
        stqd    $row0_5,640($a_surfaces_3)              # 17o
        stqd    $row0_10,0x4c0($a_surfaces_3)           # 18o
        stqd    $row0_11,0x440($a_surfaces_3)           # 19o
        stqd    $row0_9,0x580($a_surfaces_3)            # 20o
        stqd    $row0_12,960($a_surfaces_3)             # 21o
        fma     $t_out,$t_e,$t_out,$t_y                 # 23e
        fm      $t_out,$t_out,$gain_3                   # 29e
        fma     $normal_x_6,$t_out,$off_x_4,$normal_x_3 # 35e
        fms     $height,$off_squared_6,$t_out,$offset_3 # 36e
        fma     $normal_y_4,$t_out,$off_y_3,$normal_y_2 # 37e
        fma     $normal_z,$t_out,$off_z_3,$normal_z_2   # 38e
        fm      $t_e,$normal_x_6,$direction_x_4         # 41e
        fma     $height,$slope_3,$along_4,$height       # 42e
        fma     $t_e,$normal_y_4,$direction_y_4,$t_e    # 47e
        fnms    $point_x_5,$height,$normal_x_6,$point_x_4 # 48e
        fnms    $point_z_6,$height,$normal_z,$point_z_5 # 49e
        fnms    $point_y_4,$height,$normal_y_4,$point_y_3 # 50e
        fma     $t_e,$normal_z,$direction_z_5,$t_e      # 53e
        stqd    $point_x_5,0($a_surfaces_3)             # 54o
        stqd    $row0,832($a_surfaces_3)                # 55o
        stqd    $point_z_6,128($a_surfaces_3)           # 56o
        stqd    $row0_23,896($a_surfaces_3)             # 57o
        stqd    $leave_object_4,576($a_surfaces_3)      # 58o
        andc    $flip_2,$k_sign,$t_e                    # 59e
        stqd    $point_y_4,64($a_surfaces_3)            # 59o
        rotmai  $front_2,$t_e,-31                       # 60e
        xor     $normal_x_5,$normal_x_6,$flip_2         # 61e
        xor     $normal_y,$normal_y_4,$flip_2           # 62e
        lnop                                            # 62o pairing
        xor     $normal_z,$normal_z,$flip_2             # 63e
        stqd    $normal_x_5,192($a_surfaces_3)          # 63o
        selb    $m_index_2,$m_y,$m_x,$front_2           # 64e
        stqd    $normal_y,256($a_surfaces_3)            # 64o
        stqd    $normal_y,448($a_surfaces_3)            # 65o
        shufb   $row0_22,$quad_16,$quad_16,$m_index_2   # 66o
        stqd    $normal_x_5,384($a_surfaces_3)          # 67o
        stqd    $normal_z,512($a_surfaces_3)            # 68o
        stqd    $normal_z,320($a_surfaces_3)            # 69o
        stqd    $row0_22,0x480($a_surfaces_3)           # 70o
        nop     $127                                    # 71e pairing
surfaces_same_r16_return:
        bi      $lr                                     # 71o
next_row_short:
        andi    $last,$count,3                          # 0e
        lqd     $object,448($a_rays)                    # 0o
        ai      $count,$count,-1                        # 1e
        lqd     $t,384($a_rays)                         # 1o
        ceqi    $last,$last,1                           # 2e
        lqd     $point_x,0($a_rays)                     # 2o
        nop     $127                                    # 3e pairing
        lqd     $direction_x,192($a_rays)               # 3o
        and     $t_e,$last,$k_rays_gap                  # 4e
        lqd     $point_y,64($a_rays)                    # 4o
        and     $t_e_10,$last,$k_surfaces_gap           # 5e
        lqd     $direction_y,256($a_rays)               # 5o
        ceq     $miss,$object,$background               # 6e
        lqd     $quad,0($object)                        # 6o
        cgti    $there,$t,-1                            # 7e
        lqd     $quad_12,16($object)                    # 7o
        a       $a_rays_5,$a_rays,$t_e                  # 8e
        lqd     $point_z_7,128($a_rays)                 # 8o
        fma     $point_x,$t,$direction_x,$point_x       # 9e
        lqd     $direction_z_6,320($a_rays)             # 9o
        andc    $miss,$there,$miss                      # 10e
        lqd     $quad_sides,32($object)                 # 10o
        fma     $point_y,$t,$direction_y,$point_y       # 11e
        lnop                                            # 11o pairing
        a       $a_surfaces_5,$a_surfaces,$t_e_10       # 12e
        shufb   $centre_x_2,$quad,$quad,$m_x            # 12o
        and     $t_e,$last,$k_packet                    # 13e
        shufb   $centre_y_5,$quad,$quad,$m_y            # 13o
        sf      $hits,$miss,$hits                       # 14e
        shufb   $axis_x,$quad_12,$quad_12,$m_x          # 14o
        fma     $point_z_3,$t,$direction_z_6,$point_z_7 # 15e
        shufb   $centre_z,$quad,$quad,$m_z              # 15o
        fs      $off_x,$point_x,$centre_x_2             # 16e
        shufb   $axis_y,$quad_12,$quad_12,$m_y          # 16o
        fs      $off_y,$point_y,$centre_y_5             # 17e
        shufb   $axis_z,$quad_12,$quad_12,$m_z          # 17o
        andc    $leave_point,$point_x,$k_sign           # 18e
        shufb   $gain,$quad,$quad,$m_w                  # 18o
        andc    $t_e_9,$point_y,$k_sign                 # 19e
        shufb   $slope,$quad_12,$quad_12,$m_w           # 19o
        ai      $a_rays,$a_rays_5,16                    # 20e
        shufb   $a_material,$quad_sides,$quad_sides,$m_z # 20o
        fs      $off_z,$point_z_3,$centre_z             # 21e
        shufb   $offset,$quad_sides,$quad_sides,$m_x    # 21o
        fm      $along,$off_x,$axis_x                   # 22e
        shufb   $leave_object,$quad_sides,$quad_sides,$m_y # 22o
        fm      $normal_x,$slope,$axis_x                # 23e
        lnop                                            # 23o pairing
        fm      $normal_y,$slope,$axis_y                # 24e
        lqd     $quad,48($a_material)                   # 24o
        fm      $normal_z,$slope,$axis_z                # 25e
        lqd     $quad_11,0($a_material)                 # 25o
        fa      $leave_point,$leave_point,$t_e_9        # 26e
        lqd     $quad_17,16($a_material)                # 26o
        andc    $t_e_11,$point_z_3,$k_sign              # 27e
        lqd     $quad_18,32($a_material)                # 27o
        fma     $along,$off_y,$axis_y,$along            # 28e
        stqd    $a_material,0x600($a_surfaces)          # 28o
        or      $quad_19,$quad,$quad_sides              # 30e
        shufb   $row0,$quad,$quad,$m_x                  # 30o
        nop     $127                                    # 31e pairing
        shufb   $row0_24,$quad_11,$quad_11,$m_w         # 31o
        fa      $leave_point,$leave_point,$t_e_11       # 32e
        shufb   $flags,$quad_19,$quad_19,$m_w           # 32o
        nop     $127                                    # 33e pairing
        shufb   $row0_19,$quad_17,$quad_17,$m_x         # 33o
        fma     $along,$off_z,$axis_z,$along            # 34e
        shufb   $row0_25,$quad_17,$quad_17,$m_z         # 34o
        and     $row0_24,$row0_24,$there                # 35e
        shufb   $row0_26,$quad_17,$quad_17,$m_w         # 35o
        and     $flags,$flags,$there                    # 36e
        shufb   $row0_5,$quad_11,$quad_11,$m_x          # 36o
        and     $row0_19,$row0_19,$there                # 37e
        shufb   $row0_3,$quad_11,$quad_11,$m_y          # 37o
        fma     $leave_object,$leave_point,$k_leave,$leave_object # 38e
        orx     $flags,$flags                           # 38o
        and     $row0_25,$row0_25,$there                # 39e
        shufb   $row0_10,$quad_11,$quad_11,$m_z         # 39o
        fnms    $off_x,$along,$axis_x,$off_x            # 40e
        shufb   $row0_27,$quad_17,$quad_17,$m_y         # 40o
        fnms    $off_y,$along,$axis_y,$off_y            # 41e
        shufb   $row0_28,$quad_18,$quad_18,$m_z         # 41o
        fnms    $off_z,$along,$axis_z,$off_z            # 42e
        shufb   $row0_29,$quad_18,$quad_18,$m_w         # 42o
        and     $row0_23,$row0_26,$there                # 43e
        shufb   $row0_30,$quad,$quad,$m_y               # 43o
        or      $seen_4,$seen,$flags                    # 44e
        shufb   $row0_26,$quad,$quad,$m_z               # 44o
        nop     $127                                    # 45e pairing
        stqd    $leave_object,576($a_surfaces)          # 45o
        fm      $off_squared_9,$off_x,$off_x            # 46e
        stqd    $row0_5,640($a_surfaces)                # 46o
        andc    $seen,$seen_4,$last                     # 47e
        stqd    $row0_3,704($a_surfaces)                # 47o
        stqd    $row0_10,768($a_surfaces)               # 48o
        stqd    $row0_24,832($a_surfaces)               # 49o
        stqd    $row0_19,896($a_surfaces)               # 50o
        stqd    $row0_27,960($a_surfaces)               # 51o
        fma     $off_squared_10,$off_y,$off_y,$off_squared_9 # 52e
        stqd    $row0_25,0x400($a_surfaces)             # 52o
        stqd    $row0_23,0x440($a_surfaces)             # 53o
        stqd    $row0_28,0x4c0($a_surfaces)             # 54o
        stqd    $row0_29,0x500($a_surfaces)             # 55o
        stqd    $row0,0x540($a_surfaces)                # 56o
        nop     $127                                    # 57e pairing
        stqd    $row0_30,0x580($a_surfaces)             # 57o
        fma     $off_squared_10,$off_z,$off_z,$off_squared_10 # 58e
        stqd    $row0_26,0x5c0($a_surfaces)             # 58o
        stqd    $seen_4,0($a_flags)                     # 59o
        a       $a_flags,$a_flags,$t_e                  # 60e
        frsqest $t_y,$off_squared_10                    # 64o
        fi      $t_y,$off_squared_10,$t_y               # 68e
        fm      $t_e,$off_squared_10,$t_y               # 75e
        fm      $t_out,$t_y,$k_half                     # 76e
        fnms    $t_e,$t_e,$t_y,$k_one                   # 81e
        fma     $t_out,$t_e,$t_out,$t_y                 # 87e
        fm      $t_out,$t_out,$gain                     # 93e
        fma     $normal_x,$t_out,$off_x,$normal_x       # 99e
        fma     $normal_y,$t_out,$off_y,$normal_y       # 100e
        fma     $normal_z,$t_out,$off_z,$normal_z       # 101e
        fms     $height,$off_squared_10,$t_out,$offset  # 102e
        fm      $t_e,$normal_x,$direction_x             # 105e
        fma     $height,$slope,$along,$height           # 108e
        fma     $t_e,$normal_y,$direction_y,$t_e        # 111e
        fnms    $point_x,$height,$normal_x,$point_x     # 114e
        fnms    $point_y,$height,$normal_y,$point_y     # 115e
        fnms    $point_z_3,$height,$normal_z,$point_z_3 # 116e
        fma     $t_e,$normal_z,$direction_z_6,$t_e      # 117e
        stqd    $point_x,0($a_surfaces)                 # 120o
        stqd    $point_y,64($a_surfaces)                # 121o
        stqd    $point_z_3,128($a_surfaces)             # 122o
        rotmai  $front,$t_e,-31                         # 123e
        andc    $flip,$k_sign,$t_e                      # 124e
        xor     $normal_x,$normal_x,$flip               # 126e
        selb    $m_index,$m_y,$m_x,$front               # 127e
        lnop                                            # 127o pairing
        xor     $normal_y,$normal_y,$flip               # 128e
        stqd    $normal_x,192($a_surfaces)              # 128o
        xor     $normal_z,$normal_z,$flip               # 129e
        shufb   $row0,$quad_18,$quad_18,$m_index        # 129o
        stqd    $normal_x,384($a_surfaces)              # 130o
        stqd    $normal_y,256($a_surfaces)              # 131o
        stqd    $normal_y,448($a_surfaces)              # 132o
        stqd    $normal_z,320($a_surfaces)              # 133o
        stqd    $normal_z,512($a_surfaces)              # 134o
        stqd    $row0,0x480($a_surfaces)                # 135o
        ai      $a_surfaces,$a_surfaces_5,16            # 136e
        brnz    $count,next_row_short                   # 136o
        ori     $a_rays,$hits,0                         # 137e
        bi      $lr                                     # 137o
endfunction surfaces_same_r16
