# surfaces_r16   where sixteen rays have hit what they hit, and what the surfaces are there
#   C       vec_uint4 surfaces_r16(const struct rays16 *, int count, struct surfaces *,
#                                  const struct object *background);
#   In      $3 rays, $4 packets (at least 1), $5 surfaces; rays and surfaces one behind the other
#           $6 the background's object; pointers 16-aligned
#   Out     the packets' surfaces; of a ray that is not there (t < 0) anything, but shares of 0
#           $3 rays that hit something, a count a lane
#   Uses    $2-$79   Saves  -   Stack  0   Calls  -
#   Domain  the rays' objects are addresses of objects, also of rays that are not there; |d| = 1
#           within 4 ulp, t below 2^20; OBJECT_leave is 2^-20 (|centre x| + |centre y| + |centre z|
#           + |offset|)
#   Error   0.15 of SURFACES_leave, distance of a point from its surface; normals 2^-23 + leave/(4
#           r), each component, r the distance from the axis or the centre
#   Twin    lab/twins/src/surfaces.rs
#
# leave = OBJECT_leave + 2^-20 (|Px| + |Py| + |Pz|), which is 8 ulp of every number that a hit is
# computed from. In 240000 tries, rays that started at an eighth of it from spheres and planes did
# not meet them again, even along the surface. Of those that started at a sixteenth, 1 in 2400 did.
#
# The odd pipe is the bound. Of its 111 instructions, 34 load and store rays and surfaces, 28
# gather the quadwords of objects and materials, and 6 compute their addresses. Transposing four
# quadwords takes 6 instructions of the odd and 4 of the even pipe, instead of 8 of the odd.
# Scheduled by spu schedule from surfaces_r16.s

        .include "surface_tmpl.inc"

        # shuffles
        .set    m_behind,54
        .set    m_first,55
        .set    m_second,56
        .set    m_third,57
        .set    m_fourth,58
        # gathered
        .set    a_lane0,59
        .set    a_lane1,60
        .set    a_lane2,61
        .set    a_lane3,62
        .set    quad0,63
        .set    quad1,64
        .set    quad2,65
        .set    quad3,66
        .set    low02,67
        .set    high02,68
        .set    low13,69
        .set    high13,70
        .set    sides02,71
        .set    sides13,72
        .set    row0,73
        .set    row1,74
        .set    row2,75
        .set    row3,76
        .set    m_ratio,77

# The first half of transposing four quadwords A, B, C, D: A0 A1 C0 C1, C2 C3 A2 A3 and B0 B1 D0
# D1, D2 D3 B2 B3.
.macro  gather offset:req
    .irp lane, 0,1,2,3
        lqd     $quad\lane,\offset($a_lane\lane)
    .endr
        rotqbyi $quad2,$quad2,8
        rotqbyi $quad3,$quad3,8
        selb    $low02,$quad0,$quad2,$m_behind
        selb    $high02,$quad2,$quad0,$m_behind
        selb    $low13,$quad1,$quad3,$m_behind
        selb    $high13,$quad3,$quad1,$m_behind
.endm

# The second half.
.macro  row0_of out:req
        shufb   \out,$low02,$low13,$m_first
.endm
.macro  row1_of out:req
        shufb   \out,$low02,$low13,$m_second
.endm
.macro  row2_of out:req
        shufb   \out,$high02,$high13,$m_third
.endm

.macro  four_rows out0:req, out1:req, out2:req, out3:req
        row0_of \out0
        row1_of \out1
        row2_of \out2
        shufb   \out3,$high02,$high13,$m_fourth
.endm

# Moves the four lanes of a row of addresses to the preferred slots of four registers.
.macro  addresses row:req
        ori     $a_lane0,\row,0
        rotqbyi $a_lane1,\row,4
        rotqbyi $a_lane2,\row,8
        rotqbyi $a_lane3,\row,12
.endm

        .section .rodata
        .align  4
        # words of two quadwords P and Q
first:  .int    0x00010203,0x10111213,0x08090a0b,0x18191a1b # P0 Q0 P2 Q2
second: .int    0x04050607,0x14151617,0x0c0d0e0f,0x1c1d1e1f # P1 Q1 P3 Q3
third:  .int    0x08090a0b,0x18191a1b,0x00010203,0x10111213 # P2 Q2 P0 Q0
fourth: .int    0x0c0d0e0f,0x1c1d1e1f,0x04050607,0x14151617 # P3 Q3 P1 Q1

function surfaces_r16
        .set count_2,79; .set direction_x_2,30; .set t_e_2,2; .set direction_y_2,34
        .set a_rays_2,2; .set quad0_2,21; .set t_e_3,22; .set point_x_2,38; .set point_y_2,42
        .set quad3_2,27; .set a_surfaces_2,78; .set quad2_2,23; .set leave_point_2,18
        .set quad3_3,20; .set quad1_2,28; .set direction_z_2,40; .set quad2_3,2; .set quad0_3,22
        .set quad2_4,31; .set quad3_4,29; .set low02_2,23; .set centre_y_2,33; .set point_z_2,35
        .set centre_x_2,41; .set high13_2,17; .set quad1_3,32; .set quad2_5,20; .set off_x_2,25
        .set high02_2,21; .set axis_y_2,23; .set high02_3,2; .set centre_z_2,24; .set t_e_4,26
        .set axis_z_2,27; .set slope_2,37; .set gain_2,28; .set off_z_2,17; .set leave_point_3,21
        .set offset_2,47; .set normal_x_2,29; .set quad1_4,18; .set quad3_5,26; .set quad3_6,32
        .set off_x_3,31; .set quad0_4,20; .set off_z_3,33; .set quad0_5,17; .set off_squared_2,24
        .set high02_4,43; .set high13_3,51; .set low13_2,23; .set quad2_6,25; .set high13_4,18
        .set quad2_7,22; .set high02_5,26; .set quad1_5,46; .set low02_3,2; .set flags_2,17
        .set low02_4,18; .set quad1_6,25; .set off_squared_3,67; .set row1_2,24; .set high13_5,48
        .set high02_6,32; .set low02_5,43; .set row2_2,53; .set flags_3,2; .set low13_3,26
        .set row3_2,48; .set row1_3,27; .set row2_3,46; .set flags_4,59; .set row2_4,51
        .set low02_6,53; .set row0_2,2; .set high02_7,18; .set row0_3,21; .set seen_2,20
        .set low13_4,74; .set t_e_5,20; .set row2_5,72; .set row2_6,71; .set row3_3,59
        .set t_e_6,18; .set quad3_7,23; .set t_e_7,27; .set low02_7,20; .set point_x_3,36
        .set axis_z_3,24; .set point_y_3,39; .set leave_point_4,23; .set centre_z_3,17
        .set axis_y_3,20; .set t_e_8,21; .set quad1_7,23; .set quad1_8,22; .set low02_8,27
        .set quad1_9,17; .set low13_5,20; .set low02_9,46; .set quad0_6,49; .set high13_6,32
        .set high13_7,25; .set low02_10,24; .set flags_5,32; .set row2_7,43; .set row1_4,26
        .set high02_8,17; .set flags_6,22; .set seen_3,17; .set row1_5,17; .set a_surfaces_3,2
        .set quad0_7,19; .set there_2,23; .set a_rays_3,18; .set quad2_8,27; .set t_e_9,28
        .set direction_z_3,29; .set point_z_3,20; .set low02_11,28; .set centre_x_3,30
        .set low13_6,31; .set centre_y_3,32; .set point_z_4,17; .set centre_z_4,20
        .set axis_x_2,33; .set axis_y_4,28; .set axis_z_4,19; .set quad3_8,18; .set quad2_9,19
        .set quad2_10,26; .set quad3_9,28; .set high02_9,31; .set row2_8,32; .set quad3_10,19
        .set quad1_10,26; .set row1_6,32; .set low13_7,33; .set high02_10,36; .set high13_8,19
        .set low02_12,19; .set row2_9,20; .set row0_4,27; .set row0_5,19; .set seen_4,26
        shli    $count,$count,2                         # 0e
        lqa     $m_first,first                          # 0o
        ila     $t_y,0x10203                            # 1e
        lqa     $m_second,second                        # 1o
        il      $a_flags,0x640                          # 2e
        lqa     $m_third,third                          # 2o
        ilhu    $k_half,0x3f00                          # 3e
        lqa     $m_fourth,fourth                        # 3o
        clgti   $count_2,$count,1                       # 4e at least as many passes as overlap
        fsmbi   $m_behind,255                           # 4o
        ilhu    $k_one,0x3f80                           # 5e
        shufb   $background,$background,$background,$t_y # 5o
        ilhu    $k_sign,0x8000                          # 6e
        ilhu    $k_leave,0x3580                         # 7e
        il      $k_rays_gap,576                         # 8e
        il      $k_surfaces_gap,0x610                   # 9e
        il      $k_packet,0x650                         # 10e
        il      $hits,0                                 # 11e
        il      $seen,0                                 # 12e
        lnop                                            # 12o pairing
        a       $a_flags,$a_surfaces,$a_flags           # 13e
        brz     $count_2,next_row_short                 # 13o too few passes
        andi    $last,$count,3                          # 14e
        lqd     $object,448($a_rays)                    # 14o
        ai      $count,$count,-1                        # 15e
        lqd     $direction_x_2,192($a_rays)             # 15o
        ceqi    $last,$last,1                           # 16e
        lqd     $point_x,0($a_rays)                     # 16o
        nop     $127                                    # 17e pairing
        lqd     $point_y,64($a_rays)                    # 17o
        and     $t_e,$last,$k_packet                    # 18e
        lqd     $t,384($a_rays)                         # 18o
        and     $t_e_2,$last,$k_rays_gap                # 19e
        lqd     $direction_y_2,256($a_rays)             # 19o
        ori     $a_lane0,$object,0                      # 20e
        rotqbyi $a_lane3,$object,12                     # 20o
        ceq     $miss,$object,$background               # 21e
        rotqbyi $a_lane2,$object,8                      # 21o
        a       $a_rays_2,$a_rays,$t_e_2                # 22e
        lqd     $quad0_2,0($a_lane0)                    # 22o
        and     $t_e_3,$last,$k_surfaces_gap            # 23e
        lqd     $point_z,128($a_rays)                   # 23o
        fma     $point_x_2,$t,$direction_x_2,$point_x   # 24e
        lqd     $quad3,0($a_lane3)                      # 24o
        fma     $point_y_2,$t,$direction_y_2,$point_y   # 25e
        lqd     $quad2,0($a_lane2)                      # 25o
        cgti    $there,$t,-1                            # 26e
        lqd     $quad3_2,16($a_lane3)                   # 26o
        a       $a_surfaces_2,$a_surfaces,$t_e_3        # 27e
        rotqbyi $a_lane1,$object,4                      # 27o
        andc    $miss,$there,$miss                      # 28e
        lqd     $quad2_2,16($a_lane2)                   # 28o
        nop     $127                                    # 29e pairing
        lqd     $quad0,16($a_lane0)                     # 29o
        andc    $leave_point_2,$point_x_2,$k_sign       # 30e
        rotqbyi $quad3,$quad3,8                         # 30o
        andc    $t_e_3,$point_y_2,$k_sign               # 31e
        lqd     $quad1,0($a_lane1)                      # 31o
        sf      $hits,$miss,$hits                       # 32e
        rotqbyi $quad3_3,$quad3_2,8                     # 32o
        fa      $leave_point_2,$leave_point_2,$t_e_3    # 33e
        rotqbyi $quad2,$quad2,8                         # 33o
        lqd     $quad1_2,16($a_lane1)                   # 34o
        lqd     $direction_z_2,320($a_rays)             # 35o
        ai      $a_rays,$a_rays_2,16                    # 36e
        rotqbyi $quad2_3,$quad2_2,8                     # 36o
        selb    $low02,$quad0_2,$quad2,$m_behind        # 37e
        lqd     $quad0_3,32($a_lane0)                   # 37o
        selb    $low13,$quad1,$quad3,$m_behind          # 38e
        lqd     $quad2_4,32($a_lane2)                   # 38o
        selb    $high13,$quad3,$quad1,$m_behind         # 39e
        lqd     $quad3_4,32($a_lane3)                   # 39o
        selb    $low02_2,$quad0,$quad2_3,$m_behind      # 40e
        shufb   $centre_y_2,$low02,$low13,$m_second     # 40o
        fma     $point_z_2,$t,$direction_z_2,$point_z   # 41e
        shufb   $centre_x_2,$low02,$low13,$m_first      # 41o
        selb    $high13_2,$quad3_3,$quad1_2,$m_behind   # 42e
        lqd     $quad1_3,32($a_lane1)                   # 42o
        selb    $low13,$quad1_2,$quad3_3,$m_behind      # 43e
        lnop                                            # 43o pairing
        fs      $off_y,$point_y_2,$centre_y_2           # 44e
        rotqbyi $quad2_5,$quad2_4,8                     # 44o
        fs      $off_x_2,$point_x_2,$centre_x_2         # 45e
        shufb   $axis_x,$low02_2,$low13,$m_first        # 45o
        selb    $high02_2,$quad2,$quad0_2,$m_behind     # 46e
        shufb   $axis_y_2,$low02_2,$low13,$m_second     # 46o
        selb    $high02,$quad2_3,$quad0,$m_behind       # 47e
        rotqbyi $quad3_4,$quad3_4,8                     # 47o
        selb    $high02_3,$quad2_5,$quad0_3,$m_behind   # 48e
        shufb   $centre_z_2,$high02_2,$high13,$m_third  # 48o
        andc    $t_e_4,$point_z_2,$k_sign               # 49e
        shufb   $axis_z_2,$high02,$high13_2,$m_third    # 49o
        selb    $low02,$quad0_3,$quad2_5,$m_behind      # 50e
        shufb   $slope_2,$high02,$high13_2,$m_fourth    # 50o
        fm      $along,$off_x_2,$axis_x                 # 51e
        shufb   $gain_2,$high02_2,$high13,$m_fourth     # 51o
        fs      $off_z_2,$point_z_2,$centre_z_2         # 52e
        selb    $high13,$quad3_4,$quad1_3,$m_behind     # 53e
        selb    $low13,$quad1_3,$quad3_4,$m_behind      # 54e
        lnop                                            # 54o pairing
        fa      $leave_point_3,$leave_point_2,$t_e_4    # 55e
        shufb   $row2,$high02_3,$high13,$m_third        # 55o
        ori     $sides13,$high13,0                      # 56e
        shufb   $leave_object,$low02,$low13,$m_second   # 56o
        fma     $along,$off_y,$axis_y_2,$along          # 57e
        shufb   $offset_2,$low02,$low13,$m_first        # 57o
        ori     $sides02,$high02_3,0                    # 58e
        lnop                                            # 58o pairing
        ori     $a_lane0,$row2,0                        # 59e
        rotqbyi $a_lane2,$row2,8                        # 59o
        fm      $normal_z,$slope_2,$axis_z_2            # 60e
        rotqbyi $a_lane1,$row2,4                        # 60o
        fma     $leave_object,$leave_point_3,$k_leave,$leave_object # 61e
        rotqbyi $a_lane3,$row2,12                       # 61o
        fm      $normal_x_2,$slope_2,$axis_x            # 62e
        lqd     $quad0,48($a_lane0)                     # 62o
        fma     $along,$off_z_2,$axis_z_2,$along        # 63e
        lqd     $quad2_3,16($a_lane2)                   # 63o
        fm      $normal_y,$slope_2,$axis_y_2            # 64e
        lqd     $quad2,48($a_lane2)                     # 64o
        lqd     $quad3,32($a_lane3)                     # 65o
        lqd     $quad1_4,48($a_lane1)                   # 66o
        lqd     $quad3_5,48($a_lane3)                   # 67o
        lqd     $quad3_6,16($a_lane3)                   # 68o
        fnms    $off_x_3,$along,$axis_x,$off_x_2        # 69e
        lqd     $quad0_4,32($a_lane0)                   # 69o
        fnms    $off_y,$along,$axis_y_2,$off_y          # 70e
        rotqbyi $quad2,$quad2,8                         # 70o
        fnms    $off_z_3,$along,$axis_z_2,$off_z_2      # 71e
        lqd     $quad1,0($a_lane1)                      # 71o
        lqd     $quad0_5,16($a_lane0)                   # 72o
        rotqbyi $quad3_5,$quad3_5,8                     # 73o
        selb    $high02,$quad2,$quad0,$m_behind         # 74e
        rotqbyi $quad3_6,$quad3_6,8                     # 74o
        fm      $off_squared_2,$off_x_3,$off_x_3        # 75e
        rotqbyi $quad2_3,$quad2_3,8                     # 75o
        or      $high02_4,$high02,$sides02              # 76e
        lqd     $quad0_2,0($a_lane0)                    # 76o
        selb    $high13_3,$quad3_5,$quad1_4,$m_behind   # 77e
        lqd     $quad3_2,0($a_lane3)                    # 77o
        selb    $low13_2,$quad1_4,$quad3_5,$m_behind    # 78e
        lqd     $quad2_6,0($a_lane2)                    # 78o
        or      $high13_4,$high13_3,$sides13            # 79e
        lqd     $quad2_7,32($a_lane2)                   # 79o
        selb    $high02_5,$quad2_3,$quad0_5,$m_behind   # 80e
        lqd     $quad1_5,16($a_lane1)                   # 80o
        fma     $off_squared_2,$off_y,$off_y,$off_squared_2 # 81e
        rotqbyi $quad3,$quad3,8                         # 81o
        selb    $low02_3,$quad0_5,$quad2_3,$m_behind    # 82e
        shufb   $flags_2,$high02_4,$high13_4,$m_fourth  # 82o
        selb    $low02_4,$quad0,$quad2,$m_behind        # 83e
        rotqbyi $quad3_2,$quad3_2,8                     # 83o
        rotqbyi $quad2,$quad2_6,8                       # 84o
        rotqbyi $quad2_7,$quad2_7,8                     # 85o
        selb    $low13,$quad1_5,$quad3_6,$m_behind      # 86e
        lqd     $quad1_6,32($a_lane1)                   # 86o
        fma     $off_squared_3,$off_z_3,$off_z_3,$off_squared_2 # 87e
        shufb   $row1_2,$low02_4,$low13_2,$m_second     # 87o
        selb    $high13_5,$quad3_6,$quad1_5,$m_behind   # 88e
        shufb   $row1,$low02_3,$low13,$m_second         # 88o
        selb    $high02_6,$quad2_7,$quad0_4,$m_behind   # 89e
        shufb   $row0,$low02_3,$low13,$m_first          # 89o
        selb    $low02_5,$quad0_2,$quad2,$m_behind      # 90e
        shufb   $row2_2,$high02_5,$high13_5,$m_third    # 90o
        and     $flags_3,$flags_2,$there                # 91e
        shufb   $row3,$high02_5,$high13_5,$m_fourth     # 91o
        selb    $high13_2,$quad3,$quad1_6,$m_behind     # 92e
        stqd    $row1,960($a_surfaces)                  # 92o
        selb    $low13_3,$quad1,$quad3_2,$m_behind      # 93e
        frsqest $t_y,$off_squared_3                     # 93o
        selb    $high13,$quad3_2,$quad1,$m_behind       # 94e
        shufb   $row3_2,$high02_6,$high13_2,$m_fourth   # 94o
        and     $row3,$row3,$there                      # 95e
        shufb   $row1_3,$low02_5,$low13_3,$m_second     # 95o
        and     $row2_3,$row2_2,$there                  # 96e
        orx     $flags_4,$flags_3                       # 96o
        fi      $t_y,$off_squared_3,$t_y                # 97e
        shufb   $row2_4,$high02,$high13_3,$m_third      # 97o
        selb    $low02_6,$quad0_4,$quad2_7,$m_behind    # 98e
        shufb   $row0_2,$low02_4,$low13_2,$m_first      # 98o
        selb    $high02_7,$quad2,$quad0_2,$m_behind     # 99e
        shufb   $row0_3,$low02_5,$low13_3,$m_first      # 99o
        or      $seen_2,$seen,$flags_4                  # 100e
        stqd    $row3,0x440($a_surfaces)                # 100o
        selb    $low13_4,$quad1_6,$quad3,$m_behind      # 101e
        stqd    $row3_2,0x500($a_surfaces)              # 101o
        andc    $seen,$seen_2,$last                     # 102e
        stqd    $row2_3,0x400($a_surfaces)              # 102o
        nop     $127                                    # 103e pairing
        stqd    $seen_2,0($a_flags)                     # 103o
        fm      $t_e_5,$off_squared_3,$t_y              # 104e
        stqd    $row2_4,0x5c0($a_surfaces)              # 104o
        a       $a_flags,$a_flags,$t_e                  # 105e
        shufb   $row2_5,$high02_6,$high13_2,$m_third    # 105o
        fm      $t_out,$t_y,$k_half                     # 106e
        shufb   $row2_6,$high02_7,$high13,$m_third      # 106o
        shufb   $row3_3,$high02_7,$high13,$m_fourth     # 107o
        stqd    $leave_object,576($a_surfaces)          # 108o
        nop     $127                                    # 109e pairing
        stqd    $row1_3,704($a_surfaces)                # 109o
        fnms    $t_e_5,$t_e_5,$t_y,$k_one               # 110e
        stqd    $row0_3,640($a_surfaces)                # 110o
        and     $row3,$row3_3,$there                    # 111e
        stqd    $row1_2,0x580($a_surfaces)              # 111o
next_row:
        andi    $last,$count,3                          # 0e
        lqd     $object,448($a_rays)                    # 0o
            and     $row0,$row0,$there                  # 1e
        lqd     $point_x,0($a_rays)                     # 1o
        ceqi    $last,$last,1                           # 2e
        lqd     $point_y,64($a_rays)                    # 2o
        ai      $count,$count,-1                        # 3e
        lqd     $t,384($a_rays)                         # 3o
        and     $t_e,$last,$k_packet                    # 4e
        lqd     $point_z,128($a_rays)                   # 4o
            fma     $t_out,$t_e_5,$t_out,$t_y           # 5e
            stqd    $row0_2,0x540($a_surfaces)          # 5o
        and     $t_e_2,$last,$k_rays_gap                # 6e
        rotqbyi $a_lane2,$object,8                      # 6o
        ori     $a_lane0,$object,0                      # 7e
        rotqbyi $a_lane3,$object,12                     # 7o
        ceq     $miss,$object,$background               # 8e
        rotqbyi $a_lane1,$object,4                      # 8o
        and     $t_e_6,$last,$k_surfaces_gap            # 9e
        lqd     $quad0,16($a_lane0)                     # 9o
        cgti    $there,$t,-1                            # 10e
        lqd     $quad0_2,0($a_lane0)                    # 10o
            fm      $t_out,$t_out,$gain_2               # 11e
        lqd     $quad0_3,32($a_lane0)                   # 11o
        nop     $127                                    # 12e pairing
        lqd     $quad2,0($a_lane2)                      # 12o
        andc    $miss,$there,$miss                      # 13e
        lqd     $quad3,0($a_lane3)                      # 13o
        a       $a_rays_2,$a_rays,$t_e_2                # 14e
        lqd     $quad2_2,16($a_lane2)                   # 14o
        lqd     $quad3_2,16($a_lane3)                   # 15o
        lqd     $quad1,0($a_lane1)                      # 16o
            fma     $normal_x,$t_out,$off_x_3,$normal_x_2 # 17e
        lqd     $quad1_2,16($a_lane1)                   # 17o
        sf      $hits,$miss,$hits                       # 18e
        rotqbyi $quad2,$quad2,8                         # 18o
            fms     $height,$off_squared_3,$t_out,$offset_2 # 19e
            stqd    $row3,832($a_surfaces)              # 19o
            fma     $normal_y,$t_out,$off_y,$normal_y   # 20e
        rotqbyi $quad3,$quad3,8                         # 20o
            fma     $normal_z,$t_out,$off_z_3,$normal_z # 21e
        rotqbyi $quad2_5,$quad2_2,8                     # 21o
        selb    $low02,$quad0_2,$quad2,$m_behind        # 22e
        rotqbyi $quad3_7,$quad3_2,8                     # 22o
            fm      $t_e_7,$normal_x,$direction_x_2     # 23e
        lqd     $quad3_4,32($a_lane3)                   # 23o
        selb    $low13,$quad1,$quad3,$m_behind          # 24e
        lqd     $direction_x_2,192($a_rays)             # 24o
            fma     $height,$slope_2,$along,$height     # 25e
        lqd     $quad2_4,32($a_lane2)                   # 25o
        selb    $high02,$quad2_5,$quad0,$m_behind       # 26e
        hbrr    next_row_back,next_row                  # 26o hint
        selb    $high02_2,$quad2,$quad0_2,$m_behind     # 27e
        lqd     $quad1_3,32($a_lane1)                   # 27o
        selb    $low02_7,$quad0,$quad2_5,$m_behind      # 28e
        shufb   $centre_y_2,$low02,$low13,$m_second     # 28o
            fma     $t_e_7,$normal_y,$direction_y_2,$t_e_7 # 29e
        rotqbyi $quad3_4,$quad3_4,8                     # 29o
        selb    $high13,$quad3_7,$quad1_2,$m_behind     # 30e
        lqd     $direction_y_2,256($a_rays)             # 30o
            fnms    $point_z_2,$height,$normal_z,$point_z_2 # 31e
            stqd    $row2_6,768($a_surfaces)            # 31o
            fnms    $point_x_3,$height,$normal_x,$point_x_2 # 32e
        shufb   $slope_2,$high02,$high13,$m_fourth      # 32o
        fma     $point_x_2,$t,$direction_x_2,$point_x   # 33e
        shufb   $axis_z_3,$high02,$high13,$m_third      # 33o
            fnms    $point_y_3,$height,$normal_y,$point_y_2 # 34e
            stqd    $row0,896($a_surfaces)              # 34o
            fma     $t_e_7,$normal_z,$direction_z_2,$t_e_7 # 35e
        lqd     $direction_z_2,320($a_rays)             # 35o
        selb    $high13,$quad3,$quad1,$m_behind         # 36e
        shufb   $centre_x_2,$low02,$low13,$m_first      # 36o
        selb    $low13,$quad1_2,$quad3_7,$m_behind      # 37e
            stqd    $point_z_2,128($a_surfaces)         # 37o
        fma     $point_y_2,$t,$direction_y_2,$point_y   # 38e
            stqd    $point_x_3,0($a_surfaces)           # 38o
        andc    $leave_point_4,$point_x_2,$k_sign       # 39e
        rotqbyi $quad2,$quad2_4,8                       # 39o
        fs      $off_x_2,$point_x_2,$centre_x_2         # 40e
        shufb   $axis_x,$low02_7,$low13,$m_first        # 40o
            andc    $flip,$k_sign,$t_e_7                # 41e
            stqd    $point_y_3,64($a_surfaces)          # 41o
        fma     $point_z_2,$t,$direction_z_2,$point_z   # 42e
        shufb   $centre_z_3,$high02_2,$high13,$m_third  # 42o
            xor     $normal_z,$normal_z,$flip           # 43e
        shufb   $gain_2,$high02_2,$high13,$m_fourth     # 43o
            xor     $normal_x,$normal_x,$flip           # 44e
            stqd    $row2,0x600($a_surfaces)            # 44o
            xor     $normal_y,$normal_y,$flip           # 45e
            stqd    $normal_z,320($a_surfaces)          # 45o
        selb    $high13,$quad3_4,$quad1_3,$m_behind     # 46e
            stqd    $row2_5,0x4c0($a_surfaces)          # 46o
        fs      $off_y,$point_y_2,$centre_y_2           # 47e
            stqd    $normal_y,256($a_surfaces)          # 47o
        selb    $high02,$quad2,$quad0_3,$m_behind       # 48e
            stqd    $normal_x,384($a_surfaces)          # 48o
        nop     $127                                    # 49e pairing
        shufb   $axis_y_3,$low02_7,$low13,$m_second     # 49o
        fm      $along,$off_x_2,$axis_x                 # 50e
        shufb   $row2,$high02,$high13,$m_third          # 50o
        selb    $low13,$quad1_3,$quad3_4,$m_behind      # 51e
            stqd    $normal_z,512($a_surfaces)          # 51o
        selb    $low02,$quad0_3,$quad2,$m_behind        # 52e
            stqd    $normal_y,448($a_surfaces)          # 52o
        fm      $normal_x_2,$slope_2,$axis_x            # 53e
            stqd    $normal_x,192($a_surfaces)          # 53o
        fm      $normal_z,$slope_2,$axis_z_3            # 54e
        rotqbyi $a_lane1,$row2,4                        # 54o
        fs      $off_z_2,$point_z_2,$centre_z_3         # 55e
        rotqbyi $a_lane2,$row2,8                        # 55o
        fma     $along,$off_y,$axis_y_3,$along          # 56e
        shufb   $leave_object,$low02,$low13,$m_second   # 56o
        ori     $a_lane0,$row2,0                        # 57e
        rotqbyi $a_lane3,$row2,12                       # 57o
        andc    $t_e_8,$point_y_2,$k_sign               # 58e
        lqd     $quad1,0($a_lane1)                      # 58o
        andc    $t_e_3,$point_z_2,$k_sign               # 59e
        lqd     $quad0,48($a_lane0)                     # 59o
        fa      $leave_point_3,$leave_point_4,$t_e_8    # 60e
        lqd     $quad1_7,48($a_lane1)                   # 60o
        ori     $sides13,$high13,0                      # 61e
        lqd     $quad2,48($a_lane2)                     # 61o
        fma     $along,$off_z_2,$axis_z_3,$along        # 62e
        lqd     $quad3,32($a_lane3)                     # 62o
            rotmai  $front,$t_e_7,-31                   # 63e
        lqd     $quad3_5,48($a_lane3)                   # 63o
        ori     $sides02,$high02,0                      # 64e
        lqd     $quad3_2,0($a_lane3)                    # 64o
        ai      $a_rays,$a_rays_2,16                    # 65e
        lqd     $quad2_3,16($a_lane2)                   # 65o
        fm      $normal_y,$slope_2,$axis_y_3            # 66e
        lqd     $quad3_6,16($a_lane3)                   # 66o
        fa      $leave_point_3,$leave_point_3,$t_e_3    # 67e
        rotqbyi $quad2,$quad2,8                         # 67o
        fnms    $off_x_3,$along,$axis_x,$off_x_2        # 68e
        lqd     $quad1_8,32($a_lane1)                   # 68o
            selb    $m_ratio,$m_second,$m_first,$front  # 69e
        lqd     $quad2_6,0($a_lane2)                    # 69o
        fnms    $off_y,$along,$axis_y_3,$off_y          # 70e
        rotqbyi $quad3_3,$quad3_2,8                     # 70o
        selb    $high02,$quad2,$quad0,$m_behind         # 71e
        rotqbyi $quad2_3,$quad2_3,8                     # 71o
        selb    $low02_8,$quad0,$quad2,$m_behind        # 72e
        lqd     $quad0,16($a_lane0)                     # 72o
        fnms    $off_z_3,$along,$axis_z_3,$off_z_2      # 73e
        lqd     $quad1_9,16($a_lane1)                   # 73o
        fm      $off_squared_2,$off_x_3,$off_x_3        # 74e
        rotqbyi $quad3_6,$quad3_6,8                     # 74o
        selb    $high13,$quad3_3,$quad1,$m_behind       # 75e
        rotqbyi $quad3_5,$quad3_5,8                     # 75o
        or      $high02_4,$high02,$sides02              # 76e
        rotqbyi $quad2,$quad2_6,8                       # 76o
        selb    $low13_5,$quad1,$quad3_3,$m_behind      # 77e
        lqd     $quad2_6,32($a_lane2)                   # 77o
        selb    $low02_9,$quad0,$quad2_3,$m_behind      # 78e
        shufb   $offset_2,$low02,$low13,$m_first        # 78o
        selb    $high13_5,$quad3_6,$quad1_9,$m_behind   # 79e
        lqd     $quad0_6,32($a_lane0)                   # 79o
        fma     $off_squared_2,$off_y,$off_y,$off_squared_2 # 80e
        rotqbyi $quad3,$quad3,8                         # 80o
        selb    $high13_3,$quad3_5,$quad1_7,$m_behind   # 81e
            shufb   $row0,$low02_6,$low13_4,$m_ratio    # 81o
        selb    $low13,$quad1_9,$quad3_6,$m_behind      # 82e
        lqd     $quad0_5,0($a_lane0)                    # 82o
        or      $high13_6,$high13_3,$sides13            # 83e
        shufb   $row2_4,$high02,$high13_3,$m_third      # 83o
        selb    $high02,$quad2_3,$quad0,$m_behind       # 84e
        rotqbyi $quad2_3,$quad2_6,8                     # 84o
        selb    $high13_7,$quad3,$quad1_8,$m_behind     # 85e
            stqd    $row0,0x480($a_surfaces)            # 85o
            ai      $a_surfaces,$a_surfaces_2,16        # 86e
        shufb   $row2_2,$high02,$high13_5,$m_third      # 86o
        fma     $off_squared_3,$off_z_3,$off_z_3,$off_squared_2 # 87e
        shufb   $row3,$high02,$high13_5,$m_fourth       # 87o
        selb    $high02,$quad2_3,$quad0_6,$m_behind     # 88e
        shufb   $row1,$low02_9,$low13,$m_second         # 88o
        selb    $low02_10,$quad0_5,$quad2,$m_behind     # 89e
        shufb   $flags_5,$high02_4,$high13_6,$m_fourth  # 89o
        and     $row2_7,$row2_2,$there                  # 90e
        shufb   $row3_2,$high02,$high13_7,$m_fourth     # 90o
        selb    $low13_2,$quad1_7,$quad3_5,$m_behind    # 91e
        shufb   $row1_4,$low02_10,$low13_5,$m_second    # 91o
        selb    $high02_8,$quad2,$quad0_5,$m_behind     # 92e
        stqd    $row1,960($a_surfaces)                  # 92o
        selb    $low02_6,$quad0_6,$quad2_3,$m_behind    # 93e
        shufb   $row0_2,$low02_8,$low13_2,$m_first      # 93o
        and     $flags_5,$flags_5,$there                # 94e
        frsqest $t_y,$off_squared_3                     # 94o
        and     $row3,$row3,$there                      # 95e
        shufb   $row3_3,$high02_8,$high13,$m_fourth     # 95o
        selb    $low13_4,$quad1_8,$quad3,$m_behind      # 96e
        orx     $flags_6,$flags_5                       # 96o
        fma     $leave_object,$leave_point_3,$k_leave,$leave_object # 97e
        shufb   $row2_6,$high02_8,$high13,$m_third      # 97o
        fi      $t_y,$off_squared_3,$t_y                # 98e
        stqd    $row3,0x440($a_surfaces)                # 98o
        and     $row3,$row3_3,$there                    # 99e
        shufb   $row2_5,$high02,$high13_7,$m_third      # 99o
        a       $a_surfaces_2,$a_surfaces,$t_e_6        # 100e
        stqd    $row3_2,0x500($a_surfaces)              # 100o
        or      $seen_3,$seen,$flags_6                  # 101e
        shufb   $row0,$low02_10,$low13_5,$m_first       # 101o
        nop     $127                                    # 102e pairing
        stqd    $row2_7,0x400($a_surfaces)              # 102o
        andc    $seen,$seen_3,$last                     # 103e
        stqd    $seen_3,0($a_flags)                     # 103o
        a       $a_flags,$a_flags,$t_e                  # 104e
        shufb   $row1_5,$low02_8,$low13_2,$m_second     # 104o
        fm      $t_e,$off_squared_3,$t_y                # 105e
        stqd    $row2_4,0x5c0($a_surfaces)              # 105o
        fm      $t_out,$t_y,$k_half                     # 106e
        stqd    $leave_object,576($a_surfaces)          # 106o
        stqd    $row1_4,704($a_surfaces)                # 107o
        stqd    $row0,640($a_surfaces)                  # 108o
        shufb   $row0,$low02_9,$low13,$m_first          # 109o
        stqd    $row1_5,0x580($a_surfaces)              # 110o
        fnms    $t_e_5,$t_e,$t_y,$k_one                 # 111e
next_row_back:
        brnz    $count,next_row                         # 111o
next_row_drain:
        fma     $t_out,$t_e_5,$t_out,$t_y               # 0e
        stqd    $row0_2,0x540($a_surfaces)              # 0o
        and     $row0,$row0,$there                      # 1e
        hbr     surfaces_r16_return,$lr                 # 1o hint
        ai      $a_surfaces_3,$a_surfaces_2,16          # 2e
        stqd    $row3,832($a_surfaces)                  # 2o
        ori     $a_rays,$hits,0                         # 3e
        stqd    $row2_6,768($a_surfaces)                # 3o
        stqd    $row0,896($a_surfaces)                  # 4o
        fm      $t_out,$t_out,$gain_2                   # 6e
        fma     $normal_x,$t_out,$off_x_3,$normal_x_2   # 12e
        fms     $height,$off_squared_3,$t_out,$offset_2 # 13e
        fma     $normal_y,$t_out,$off_y,$normal_y       # 14e
        fma     $normal_z,$t_out,$off_z_3,$normal_z     # 15e
        fm      $t_e_7,$normal_x,$direction_x_2         # 18e
        fma     $height,$slope_2,$along,$height         # 19e
        fma     $t_e_7,$normal_y,$direction_y_2,$t_e_7  # 24e
        fnms    $point_z_2,$height,$normal_z,$point_z_2 # 25e
        fnms    $point_x_3,$height,$normal_x,$point_x_2 # 26e
        fnms    $point_y_3,$height,$normal_y,$point_y_2 # 27e
        fma     $t_e_7,$normal_z,$direction_z_2,$t_e_7  # 30e
        stqd    $point_z_2,128($a_surfaces)             # 31o
        stqd    $point_x_3,0($a_surfaces)               # 32o
        stqd    $point_y_3,64($a_surfaces)              # 33o
        stqd    $row2,0x600($a_surfaces)                # 34o
        andc    $flip,$k_sign,$t_e_7                    # 36e
        rotmai  $front,$t_e_7,-31                       # 37e
        xor     $normal_z,$normal_z,$flip               # 38e
        xor     $normal_y,$normal_y,$flip               # 39e
        lnop                                            # 39o pairing
        xor     $normal_x,$normal_x,$flip               # 40e
        stqd    $normal_z,320($a_surfaces)              # 40o
        selb    $m_ratio,$m_second,$m_first,$front      # 41e
        stqd    $row2_5,0x4c0($a_surfaces)              # 41o
        stqd    $normal_y,256($a_surfaces)              # 42o
        stqd    $normal_x,384($a_surfaces)              # 43o
        shufb   $row0,$low02_6,$low13_4,$m_ratio        # 44o
        stqd    $normal_z,512($a_surfaces)              # 45o
        stqd    $normal_y,448($a_surfaces)              # 46o
        stqd    $normal_x,192($a_surfaces)              # 47o
        stqd    $row0,0x480($a_surfaces)                # 48o
surfaces_r16_return:
        bi      $lr                                     # 49o
next_row_short:
        andi    $last,$count,3                          # 0e
        lqd     $object,448($a_rays)                    # 0o
        ai      $count,$count,-1                        # 1e
        lqd     $direction_x,192($a_rays)               # 1o
        ceqi    $last,$last,1                           # 2e
        lqd     $point_y,64($a_rays)                    # 2o
        nop     $127                                    # 3e pairing
        lqd     $direction_y,256($a_rays)               # 3o
        and     $t_e,$last,$k_packet                    # 4e
        lqd     $t,384($a_rays)                         # 4o
        and     $t_e_2,$last,$k_surfaces_gap            # 5e
        lqd     $point_x,0($a_rays)                     # 5o
        ori     $a_lane0,$object,0                      # 6e
        rotqbyi $a_lane2,$object,8                      # 6o
        ceq     $miss,$object,$background               # 7e
        rotqbyi $a_lane3,$object,12                     # 7o
        a       $a_surfaces_3,$a_surfaces,$t_e_2        # 8e
        rotqbyi $a_lane1,$object,4                      # 8o
        and     $t_e_6,$last,$k_rays_gap                # 9e
        lqd     $quad0,0($a_lane0)                      # 9o
        fma     $point_y,$t,$direction_y,$point_y       # 10e
        lqd     $quad0_7,16($a_lane0)                   # 10o
        fma     $point_x,$t,$direction_x,$point_x       # 11e
        lqd     $quad3,0($a_lane3)                      # 11o
        cgti    $there_2,$t,-1                          # 12e
        lqd     $quad3_5,16($a_lane3)                   # 12o
        a       $a_rays_3,$a_rays,$t_e_6                # 13e
        lqd     $quad2,0($a_lane2)                      # 13o
        andc    $miss,$there_2,$miss                    # 14e
        lqd     $quad1,0($a_lane1)                      # 14o
        nop     $127                                    # 15e pairing
        lqd     $quad2_8,16($a_lane2)                   # 15o
        andc    $t_e_9,$point_y,$k_sign                 # 16e
        lqd     $direction_z_3,320($a_rays)             # 16o
        andc    $leave_point,$point_x,$k_sign           # 17e
        rotqbyi $quad3,$quad3,8                         # 17o
        sf      $hits,$miss,$hits                       # 18e
        lqd     $point_z_3,128($a_rays)                 # 18o
        fa      $leave_point,$leave_point,$t_e_9        # 19e
        rotqbyi $quad2,$quad2,8                         # 19o
        ai      $a_rays,$a_rays_3,16                    # 20e
        lqd     $quad1_4,16($a_lane1)                   # 20o
        selb    $low13,$quad1,$quad3,$m_behind          # 21e
        rotqbyi $quad2_8,$quad2_8,8                     # 21o
        selb    $high13,$quad3,$quad1,$m_behind         # 22e
        rotqbyi $quad3,$quad3_5,8                       # 22o
        selb    $low02,$quad0,$quad2,$m_behind          # 23e
        lqd     $quad3_5,32($a_lane3)                   # 23o
        selb    $high02,$quad2,$quad0,$m_behind         # 24e
        lqd     $quad1,32($a_lane1)                     # 24o
        selb    $low02_11,$quad0_7,$quad2_8,$m_behind   # 25e
        shufb   $centre_x_3,$low02,$low13,$m_first      # 25o
        selb    $low13_6,$quad1_4,$quad3,$m_behind      # 26e
        shufb   $centre_y_3,$low02,$low13,$m_second     # 26o
        fma     $point_z_4,$t,$direction_z_3,$point_z_3 # 27e
        shufb   $centre_z_4,$high02,$high13,$m_third    # 27o
        selb    $high13_4,$quad3,$quad1_4,$m_behind     # 28e
        shufb   $axis_x_2,$low02_11,$low13_6,$m_first   # 28o
        fs      $off_x,$point_x,$centre_x_3             # 29e
        shufb   $axis_y_4,$low02_11,$low13_6,$m_second  # 29o
        fs      $off_y,$point_y,$centre_y_3             # 30e
        shufb   $gain,$high02,$high13,$m_fourth         # 30o
        selb    $high02,$quad2_8,$quad0_7,$m_behind     # 31e
        lqd     $quad2,32($a_lane2)                     # 31o
        nop     $127                                    # 32e pairing
        rotqbyi $quad3,$quad3_5,8                       # 32o
        fs      $off_z,$point_z_4,$centre_z_4           # 33e
        shufb   $axis_z_4,$high02,$high13_4,$m_third    # 33o
        andc    $t_e_5,$point_z_4,$k_sign               # 34e
        shufb   $slope,$high02,$high13_4,$m_fourth      # 34o
        fm      $along,$off_x,$axis_x_2                 # 35e
        lqd     $quad0,32($a_lane0)                     # 35o
        selb    $high13,$quad3,$quad1,$m_behind         # 36e
        lnop                                            # 36o pairing
        selb    $low13,$quad1,$quad3,$m_behind          # 37e
        rotqbyi $quad2,$quad2,8                         # 37o
        fm      $normal_y,$slope,$axis_y_4              # 38e
        fm      $normal_x,$slope,$axis_x_2              # 39e
        fm      $normal_z,$slope,$axis_z_4              # 40e
        fma     $along,$off_y,$axis_y_4,$along          # 41e
        selb    $high02,$quad2,$quad0,$m_behind         # 42e
        selb    $low02,$quad0,$quad2,$m_behind          # 43e
        fa      $leave_point,$leave_point,$t_e_5        # 44e
        shufb   $row2,$high02,$high13,$m_third          # 44o
        ori     $sides13,$high13,0                      # 45e
        shufb   $offset,$low02,$low13,$m_first          # 45o
        ori     $sides02,$high02,0                      # 46e
        shufb   $leave_object,$low02,$low13,$m_second   # 46o
        fma     $along,$off_z,$axis_z_4,$along          # 47e
        lnop                                            # 47o pairing
        ori     $a_lane0,$row2,0                        # 48e
        rotqbyi $a_lane3,$row2,12                       # 48o
        nop     $127                                    # 49e pairing
        rotqbyi $a_lane1,$row2,4                        # 49o
        fma     $leave_object,$leave_point,$k_leave,$leave_object # 50e
        lqd     $quad0,0($a_lane0)                      # 50o
        rotqbyi $a_lane2,$row2,8                        # 51o
        lqd     $quad3,0($a_lane3)                      # 52o
        fnms    $off_x,$along,$axis_x_2,$off_x          # 53e
        lqd     $quad3_8,48($a_lane3)                   # 53o
        fnms    $off_y,$along,$axis_y_4,$off_y          # 54e
        lqd     $quad1,0($a_lane1)                      # 54o
        fnms    $off_z,$along,$axis_z_4,$off_z          # 55e
        lqd     $quad2,0($a_lane2)                      # 55o
        lqd     $quad2_9,48($a_lane2)                   # 56o
        lqd     $quad3_3,16($a_lane3)                   # 57o
        nop     $127                                    # 58e pairing
        rotqbyi $quad3,$quad3,8                         # 58o
        fm      $off_squared,$off_x,$off_x              # 59e
        rotqbyi $quad3_8,$quad3_8,8                     # 59o
        lqd     $quad2_10,32($a_lane2)                  # 60o
        rotqbyi $quad2,$quad2,8                         # 61o
        selb    $high13,$quad3,$quad1,$m_behind         # 62e
        rotqbyi $quad2_9,$quad2_9,8                     # 62o
        selb    $low13,$quad1,$quad3,$m_behind          # 63e
        rotqbyi $quad3,$quad3_3,8                       # 63o
        nop     $127                                    # 64e pairing
        lqd     $quad0_4,48($a_lane0)                   # 64o
        fma     $off_squared,$off_y,$off_y,$off_squared # 65e
        lqd     $quad1,48($a_lane1)                     # 65o
        selb    $low02,$quad0,$quad2,$m_behind          # 66e
        lqd     $quad2_8,16($a_lane2)                   # 66o
        selb    $high02,$quad2,$quad0,$m_behind         # 67e
        lqd     $quad3_9,32($a_lane3)                   # 67o
        shufb   $row0,$low02,$low13,$m_first            # 68o
        shufb   $row1,$low02,$low13,$m_second           # 69o
        selb    $high02_9,$quad2_9,$quad0_4,$m_behind   # 70e
        shufb   $row2_8,$high02,$high13,$m_third        # 70o
        fma     $off_squared,$off_z,$off_z,$off_squared # 71e
        shufb   $row3,$high02,$high13,$m_fourth         # 71o
        or      $high02,$high02_9,$sides02              # 72e
        stqd    $row0,640($a_surfaces)                  # 72o
        selb    $low02,$quad0_4,$quad2_9,$m_behind      # 73e
        stqd    $row2,0x600($a_surfaces)                # 73o
        selb    $low13,$quad1,$quad3_8,$m_behind        # 74e
        lqd     $quad0,32($a_lane0)                     # 74o
        and     $row3,$row3,$there_2                    # 75e
        rotqbyi $quad3_10,$quad3_9,8                    # 75o
        selb    $high13,$quad3_8,$quad1,$m_behind       # 76e
        stqd    $row2_8,768($a_surfaces)                # 76o
        nop     $127                                    # 77e pairing
        frsqest $t_y,$off_squared                       # 77o
        or      $high13_4,$high13,$sides13              # 78e
        lqd     $quad1,32($a_lane1)                     # 78o
        rotqbyi $quad2,$quad2_10,8                      # 79o
        stqd    $leave_object,576($a_surfaces)          # 80o
        fi      $t_y,$off_squared,$t_y                  # 81e
        lqd     $quad0_4,16($a_lane0)                   # 81o
        nop     $127                                    # 82e pairing
        lqd     $quad1_10,16($a_lane1)                  # 82o
        selb    $low02_11,$quad0,$quad2,$m_behind       # 83e
        shufb   $row1_6,$low02,$low13,$m_second         # 83o
        selb    $low13_7,$quad1,$quad3_10,$m_behind     # 84e
        stqd    $row1,704($a_surfaces)                  # 84o
        selb    $high02_10,$quad2,$quad0,$m_behind      # 85e
        rotqbyi $quad2,$quad2_8,8                       # 85o
        selb    $high13_8,$quad3_10,$quad1,$m_behind    # 86e
        shufb   $flags,$high02,$high13_4,$m_fourth      # 86o
        nop     $127                                    # 87e pairing
        stqd    $row3,832($a_surfaces)                  # 87o
        fm      $t_e_6,$off_squared,$t_y                # 88e
        shufb   $row3,$high02_10,$high13_8,$m_fourth    # 88o
        fm      $t_out,$t_y,$k_half                     # 89e
        shufb   $row2,$high02_10,$high13_8,$m_third     # 89o
        selb    $low02_12,$quad0_4,$quad2,$m_behind     # 90e
        shufb   $row0,$low02,$low13,$m_first            # 90o
        selb    $high02,$quad2,$quad0_4,$m_behind       # 91e
        shufb   $row2_9,$high02_9,$high13,$m_third      # 91o
        selb    $low13,$quad1_10,$quad3,$m_behind       # 92e
        stqd    $row3,0x500($a_surfaces)                # 92o
        and     $flags,$flags,$there_2                  # 93e
        stqd    $row2,0x4c0($a_surfaces)                # 93o
        fnms    $t_e_6,$t_e_6,$t_y,$k_one               # 94e
        shufb   $row0_4,$low02_12,$low13,$m_first       # 94o
        selb    $high13,$quad3,$quad1_10,$m_behind      # 95e
        orx     $flags,$flags                           # 95o
        shufb   $row1,$low02_12,$low13,$m_second        # 96o
        shufb   $row3,$high02,$high13,$m_fourth         # 97o
        and     $row0_5,$row0_4,$there_2                # 98e
        shufb   $row2,$high02,$high13,$m_third          # 98o
        or      $seen_4,$seen,$flags                    # 99e
        stqd    $row2_9,0x5c0($a_surfaces)              # 99o
        fma     $t_out,$t_e_6,$t_out,$t_y               # 100e
        stqd    $row1,960($a_surfaces)                  # 100o
        andc    $seen,$seen_4,$last                     # 101e
        stqd    $seen_4,0($a_flags)                     # 101o
        and     $row2,$row2,$there_2                    # 102e
        stqd    $row0,0x540($a_surfaces)                # 102o
        a       $a_flags,$a_flags,$t_e                  # 103e
        stqd    $row0_5,896($a_surfaces)                # 103o
        and     $row3,$row3,$there_2                    # 104e
        stqd    $row2,0x400($a_surfaces)                # 104o
        nop     $127                                    # 105e pairing
        stqd    $row1_6,0x580($a_surfaces)              # 105o
        fm      $t_out,$t_out,$gain                     # 106e
        stqd    $row3,0x440($a_surfaces)                # 106o
        fma     $normal_x,$t_out,$off_x,$normal_x       # 112e
        fma     $normal_y,$t_out,$off_y,$normal_y       # 113e
        fms     $height,$off_squared,$t_out,$offset     # 114e
        fma     $normal_z,$t_out,$off_z,$normal_z       # 115e
        fm      $t_e,$normal_x,$direction_x             # 118e
        fma     $height,$slope,$along,$height           # 120e
        fma     $t_e,$normal_y,$direction_y,$t_e        # 124e
        fnms    $point_x,$height,$normal_x,$point_x     # 126e
        fnms    $point_y,$height,$normal_y,$point_y     # 127e
        fnms    $point_z,$height,$normal_z,$point_z_4   # 128e
        fma     $t_e,$normal_z,$direction_z_3,$t_e      # 130e
        stqd    $point_x,0($a_surfaces)                 # 132o
        stqd    $point_y,64($a_surfaces)                # 133o
        stqd    $point_z,128($a_surfaces)               # 134o
        andc    $flip,$k_sign,$t_e                      # 136e
        rotmai  $front,$t_e,-31                         # 137e
        xor     $normal_z,$normal_z,$flip               # 138e
        xor     $normal_x,$normal_x,$flip               # 139e
        xor     $normal_y,$normal_y,$flip               # 140e
        stqd    $normal_z,320($a_surfaces)              # 140o
        selb    $m_ratio,$m_second,$m_first,$front      # 141e
        stqd    $normal_z,512($a_surfaces)              # 141o
        stqd    $normal_x,192($a_surfaces)              # 142o
        shufb   $row0,$low02_11,$low13_7,$m_ratio       # 143o
        stqd    $normal_x,384($a_surfaces)              # 144o
        stqd    $normal_y,256($a_surfaces)              # 145o
        stqd    $normal_y,448($a_surfaces)              # 146o
        hbrr    next_row_short_back,next_row_short      # 147o hint
        stqd    $row0,0x480($a_surfaces)                # 148o
        ai      $a_surfaces,$a_surfaces_3,16            # 149e
        nop     $127                                    # 150e pairing
next_row_short_back:
        brnz    $count,next_row_short                   # 150o
        ori     $a_rays,$hits,0                         # 151e
        bi      $lr                                     # 151o
endfunction surfaces_r16
