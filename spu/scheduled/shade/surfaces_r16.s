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
        .set count_2,79; .set direction_x_2,27; .set t_e_2,2; .set direction_y_2,30
        .set point_x_2,36; .set point_y_2,41; .set a_rays_2,2; .set t_e_3,18; .set quad2_2,21
        .set quad3_2,22; .set leave_point_2,26; .set quad0_2,20; .set a_surfaces_2,78
        .set t_e_4,32; .set quad1_2,29; .set leave_point_3,18; .set direction_z_2,37
        .set low02_2,3; .set centre_x_2,38; .set low13_2,23; .set centre_y_2,40; .set quad3_3,28
        .set high13_2,22; .set axis_x_2,25; .set point_z_2,31; .set axis_y_2,17; .set quad2_3,33
        .set high02_2,20; .set quad0_3,35; .set quad1_3,24; .set axis_z_2,2; .set along_2,23
        .set quad3_4,26; .set slope_2,28; .set t_e_5,34; .set gain_2,21; .set along_3,20
        .set along_4,33; .set leave_object_2,24; .set normal_y_2,22; .set normal_z_2,29
        .set normal_x_2,32; .set quad0_4,23; .set leave_object_3,18; .set quad3_5,2
        .set quad2_4,49; .set quad2_5,25; .set off_squared_2,17; .set quad3_6,46; .set quad2_6,26
        .set quad3_7,42; .set quad0_5,34; .set high13_3,47; .set quad1_4,43; .set low13_3,44
        .set quad2_7,45; .set low02_3,23; .set off_squared_3,47; .set high13_4,59; .set quad1_5,51
        .set high02_3,17; .set high13_5,20; .set high02_4,46; .set low02_4,25; .set t_y_2,35
        .set row2_2,48; .set high02_5,49; .set high13_6,53; .set row3_2,60; .set t_y_3,61
        .set low13_4,2; .set low02_5,26; .set row3_3,35; .set row2_3,43; .set low13_5,42
        .set row1_2,48; .set low02_6,76; .set low13_6,73; .set t_e_6,45; .set t_out_2,18
        .set row0_2,2; .set row3_4,20; .set t_e_7,24; .set row0_3,49; .set row2_4,34
        .set row0_4,71; .set row3_5,19; .set row3_6,48; .set row0_5,53; .set quad2_8,18
        .set quad0_6,21; .set t_e_8,23; .set t_e_9,20; .set point_y_3,32; .set point_x_3,34
        .set low13_7,31; .set high02_6,39; .set axis_z_3,18; .set axis_y_3,2; .set along_5,17
        .set leave_point_4,17; .set leave_point_5,2; .set quad2_9,17; .set off_squared_4,18
        .set quad0_7,26; .set quad3_8,23; .set leave_object_4,2; .set low02_7,24; .set low13_8,46
        .set quad1_6,18; .set high13_7,23; .set high02_7,25; .set row1_3,24; .set row3_7,26
        .set high02_8,43; .set t_y_4,46; .set high02_9,18; .set t_y_5,44; .set low02_8,17
        .set row2_5,46; .set seen_2,18; .set t_out_3,42; .set row2_6,18; .set a_surfaces_3,2
        .set flip_2,2; .set quad0_8,19; .set there_2,23; .set a_rays_3,18; .set quad2_10,27
        .set t_e_10,28; .set direction_z_3,29; .set point_z_3,20; .set low02_9,28
        .set centre_x_3,30; .set centre_y_3,32; .set point_z_4,17; .set centre_z_2,20
        .set high13_8,18; .set axis_x_3,33; .set axis_y_4,28; .set axis_z_4,19; .set quad3_9,18
        .set quad2_11,19; .set quad3_10,20; .set high02_10,31; .set row2_7,32; .set quad3_11,19
        .set low13_9,26; .set quad1_7,28; .set low02_10,32; .set row1_4,33; .set high02_11,36
        .set high13_9,19; .set row3_8,18; .set t_e_11,27; .set low02_11,19; .set row0_6,20
        .set row0_7,19; .set row2_8,20; .set seen_3,27
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
        lqd     $t,384($a_rays)                         # 15o
        ceqi    $last,$last,1                           # 16e
        lqd     $point_x,0($a_rays)                     # 16o
        nop     $127                                    # 17e pairing
        lqd     $direction_x_2,192($a_rays)             # 17o
        and     $t_e_2,$last,$k_rays_gap                # 18e
        lqd     $point_y,64($a_rays)                    # 18o
        and     $t_e,$last,$k_packet                    # 19e
        lqd     $direction_y_2,256($a_rays)             # 19o
        ori     $a_lane0,$object,0                      # 20e
        rotqbyi $a_lane2,$object,8                      # 20o
        cgti    $there,$t,-1                            # 21e
        rotqbyi $a_lane3,$object,12                     # 21o
        ceq     $miss,$object,$background               # 22e
        rotqbyi $a_lane1,$object,4                      # 22o
        fma     $point_x_2,$t,$direction_x_2,$point_x   # 23e
        lqd     $quad0,0($a_lane0)                      # 23o
        andc    $miss,$there,$miss                      # 24e
        lqd     $quad2,0($a_lane2)                      # 24o
        fma     $point_y_2,$t,$direction_y_2,$point_y   # 25e
        lqd     $quad3,0($a_lane3)                      # 25o
        a       $a_rays_2,$a_rays,$t_e_2                # 26e
        lqd     $quad1,0($a_lane1)                      # 26o
        and     $t_e_3,$last,$k_surfaces_gap            # 27e
        lqd     $quad2_2,16($a_lane2)                   # 27o
        sf      $hits,$miss,$hits                       # 28e
        lqd     $quad3_2,16($a_lane3)                   # 28o
        andc    $leave_point_2,$point_x_2,$k_sign       # 29e
        lqd     $quad0_2,16($a_lane0)                   # 29o
        a       $a_surfaces_2,$a_surfaces,$t_e_3        # 30e
        rotqbyi $quad2,$quad2,8                         # 30o
        andc    $t_e_4,$point_y_2,$k_sign               # 31e
        rotqbyi $quad3,$quad3,8                         # 31o
        nop     $127                                    # 32e pairing
        lqd     $quad1_2,16($a_lane1)                   # 32o
        fa      $leave_point_3,$leave_point_2,$t_e_4    # 33e
        rotqbyi $quad2_2,$quad2_2,8                     # 33o
        selb    $low02,$quad0,$quad2,$m_behind          # 34e
        rotqbyi $quad3_2,$quad3_2,8                     # 34o
        selb    $low13,$quad1,$quad3,$m_behind          # 35e
        lqd     $point_z,128($a_rays)                   # 35o
        selb    $high02,$quad2,$quad0,$m_behind         # 36e
        lqd     $direction_z_2,320($a_rays)             # 36o
        selb    $low02_2,$quad0_2,$quad2_2,$m_behind    # 37e
        shufb   $centre_x_2,$low02,$low13,$m_first      # 37o
        selb    $low13_2,$quad1_2,$quad3_2,$m_behind    # 38e
        shufb   $centre_y_2,$low02,$low13,$m_second     # 38o
        selb    $high13,$quad3,$quad1,$m_behind         # 39e
        lqd     $quad3_3,32($a_lane3)                   # 39o
        selb    $high13_2,$quad3_2,$quad1_2,$m_behind   # 40e
        shufb   $axis_x_2,$low02_2,$low13_2,$m_first    # 40o
        fs      $off_x,$point_x_2,$centre_x_2           # 41e
        shufb   $centre_z,$high02,$high13,$m_third      # 41o
        fma     $point_z_2,$t,$direction_z_2,$point_z   # 42e
        shufb   $axis_y_2,$low02_2,$low13_2,$m_second   # 42o
        fs      $off_y,$point_y_2,$centre_y_2           # 43e
        lqd     $quad2_3,32($a_lane2)                   # 43o
        selb    $high02_2,$quad2_2,$quad0_2,$m_behind   # 44e
        lqd     $quad0_3,32($a_lane0)                   # 44o
        ai      $a_rays,$a_rays_2,16                    # 45e
        lqd     $quad1_3,32($a_lane1)                   # 45o
        nop     $127                                    # 46e pairing
        shufb   $axis_z_2,$high02_2,$high13_2,$m_third  # 46o
        fm      $along_2,$off_x,$axis_x_2               # 47e
        rotqbyi $quad3_4,$quad3_3,8                     # 47o
        fs      $off_z,$point_z_2,$centre_z             # 48e
        shufb   $slope_2,$high02_2,$high13_2,$m_fourth  # 48o
        andc    $t_e_5,$point_z_2,$k_sign               # 49e
        rotqbyi $quad2,$quad2_3,8                       # 49o
        shufb   $gain_2,$high02,$high13,$m_fourth       # 50o
        selb    $high13,$quad3_4,$quad1_3,$m_behind     # 51e
        selb    $low13,$quad1_3,$quad3_4,$m_behind      # 52e
        fma     $along_3,$off_y,$axis_y_2,$along_2      # 53e
        selb    $high02,$quad2,$quad0_3,$m_behind       # 54e
        ori     $sides13,$high13,0                      # 55e
        ori     $sides02,$high02,0                      # 56e
        shufb   $row2,$high02,$high13,$m_third          # 56o
        selb    $low02,$quad0_3,$quad2,$m_behind        # 57e
        fa      $leave_point_3,$leave_point_3,$t_e_5    # 58e
        fma     $along_4,$off_z,$axis_z_2,$along_3      # 59e
        shufb   $leave_object_2,$low02,$low13,$m_second # 59o
        ori     $a_lane0,$row2,0                        # 60e
        rotqbyi $a_lane2,$row2,8                        # 60o
        fm      $normal_y_2,$slope_2,$axis_y_2          # 61e
        rotqbyi $a_lane3,$row2,12                       # 61o
        fm      $normal_z_2,$slope_2,$axis_z_2          # 62e
        rotqbyi $a_lane1,$row2,4                        # 62o
        fm      $normal_x_2,$slope_2,$axis_x_2          # 63e
        lqd     $quad0_4,48($a_lane0)                   # 63o
        fma     $leave_object_3,$leave_point_3,$k_leave,$leave_object_2 # 64e
        lqd     $quad2,48($a_lane2)                     # 64o
        fnms    $off_x,$along_4,$axis_x_2,$off_x        # 65e
        lqd     $quad3,48($a_lane3)                     # 65o
        fnms    $off_y,$along_4,$axis_y_2,$off_y        # 66e
        lqd     $quad1,48($a_lane1)                     # 66o
        fnms    $off_z,$along_4,$axis_z_2,$off_z        # 67e
        lqd     $quad3_5,32($a_lane3)                   # 67o
        lqd     $quad2_4,32($a_lane2)                   # 68o
        lqd     $quad2_5,16($a_lane2)                   # 69o
        nop     $127                                    # 70e pairing
        rotqbyi $quad2,$quad2,8                         # 70o
        fm      $off_squared_2,$off_x,$off_x            # 71e
        rotqbyi $quad3,$quad3,8                         # 71o
        lqd     $quad3_6,16($a_lane3)                   # 72o
        lqd     $quad2_6,0($a_lane2)                    # 73o
        selb    $high02,$quad2,$quad0_4,$m_behind       # 74e
        lqd     $quad3_7,0($a_lane3)                    # 74o
        selb    $high13,$quad3,$quad1,$m_behind         # 75e
        lqd     $quad0_5,32($a_lane0)                   # 75o
        or      $high02_2,$high02,$sides02              # 76e
        lqd     $quad1_3,32($a_lane1)                   # 76o
        fma     $off_squared_2,$off_y,$off_y,$off_squared_2 # 77e
        lqd     $quad0_3,16($a_lane0)                   # 77o
        or      $high13_3,$high13,$sides13              # 78e
        lqd     $quad1_4,16($a_lane1)                   # 78o
        selb    $low13_3,$quad1,$quad3,$m_behind        # 79e
        rotqbyi $quad2_7,$quad2_4,8                     # 79o
        selb    $low02_3,$quad0_4,$quad2,$m_behind      # 80e
        shufb   $flags,$high02_2,$high13_3,$m_fourth    # 80o
        rotqbyi $quad3,$quad3_5,8                       # 81o
        rotqbyi $quad2_5,$quad2_5,8                     # 82o
        fma     $off_squared_3,$off_z,$off_z,$off_squared_2 # 83e
        rotqbyi $quad3_5,$quad3_6,8                     # 83o
        and     $flags,$flags,$there                    # 84e
        lqd     $quad0,0($a_lane0)                      # 84o
        selb    $high13_4,$quad3,$quad1_3,$m_behind     # 85e
        lqd     $quad1_5,0($a_lane1)                    # 85o
        selb    $high02_3,$quad2_7,$quad0_5,$m_behind   # 86e
        orx     $flags,$flags                           # 86o
        selb    $high13_5,$quad3_5,$quad1_4,$m_behind   # 87e
        rotqbyi $quad2_6,$quad2_6,8                     # 87o
        selb    $high02_4,$quad2_5,$quad0_3,$m_behind   # 88e
        rotqbyi $quad3_7,$quad3_7,8                     # 88o
        selb    $low02_4,$quad0_3,$quad2_5,$m_behind    # 89e
        frsqest $t_y_2,$off_squared_3                   # 89o
        or      $seen,$seen,$flags                      # 90e
        shufb   $row2_2,$high02_3,$high13_4,$m_third    # 90o
        selb    $high02_5,$quad2_6,$quad0,$m_behind     # 91e
        shufb   $row1,$low02_3,$low13_3,$m_second       # 91o
        selb    $high13_6,$quad3_7,$quad1_5,$m_behind   # 92e
        shufb   $row3_2,$high02_4,$high13_5,$m_fourth   # 92o
        fi      $t_y_3,$off_squared_3,$t_y_2            # 93e
        stqd    $seen,0($a_flags)                       # 93o
        selb    $low13_4,$quad1_4,$quad3_5,$m_behind    # 94e
        stqd    $row2,0x600($a_surfaces)                # 94o
        selb    $low02_5,$quad0,$quad2_6,$m_behind      # 95e
        stqd    $row2_2,0x4c0($a_surfaces)              # 95o
        and     $row3_3,$row3_2,$there                  # 96e
        shufb   $row2_3,$high02_5,$high13_6,$m_third    # 96o
        selb    $low13_5,$quad1_5,$quad3_7,$m_behind    # 97e
        shufb   $row1_2,$low02_4,$low13_4,$m_second     # 97o
        selb    $low02_6,$quad0_5,$quad2_7,$m_behind    # 98e
        stqd    $row1,0x580($a_surfaces)                # 98o
        selb    $low13_6,$quad1_3,$quad3,$m_behind      # 99e
        stqd    $leave_object_3,576($a_surfaces)        # 99o
        fm      $t_e_6,$off_squared_3,$t_y_3            # 100e
        stqd    $row3_3,0x440($a_surfaces)              # 100o
        fm      $t_out_2,$t_y_3,$k_half                 # 101e
        stqd    $row2_3,768($a_surfaces)                # 101o
        andc    $seen,$seen,$last                       # 102e
        shufb   $row0_2,$low02_4,$low13_4,$m_first      # 102o
        a       $a_flags,$a_flags,$t_e                  # 103e
        shufb   $row2,$high02_4,$high13_5,$m_third      # 103o
        shufb   $row3_4,$high02_5,$high13_6,$m_fourth   # 104o
        stqd    $row1_2,960($a_surfaces)                # 105o
        fnms    $t_e_7,$t_e_6,$t_y_3,$k_one             # 106e
        shufb   $offset,$low02,$low13,$m_first          # 106o
        and     $row0_3,$row0_2,$there                  # 107e
        shufb   $row2_4,$high02,$high13,$m_third        # 107o
        and     $row2,$row2,$there                      # 108e
        shufb   $row0_4,$low02_3,$low13_3,$m_first      # 108o
        and     $row3_5,$row3_4,$there                  # 109e
        shufb   $row3_6,$high02_3,$high13_4,$m_fourth   # 109o
        shufb   $row0_5,$low02_5,$low13_5,$m_first      # 110o
        shufb   $row1,$low02_5,$low13_5,$m_second       # 111o
        fma     $t_out,$t_e_7,$t_out_2,$t_y_3           # 112e
        lnop                                            # 112o pairing
next_row:
        andi    $last,$count,3                          # 0e
        lqd     $point_y,64($a_rays)                    # 0o
        ai      $count,$count,-1                        # 1e
        lqd     $object,448($a_rays)                    # 1o
        nop     $127                                    # 2e pairing
        lqd     $point_z,128($a_rays)                   # 2o
        ceqi    $last,$last,1                           # 3e
        lqd     $t,384($a_rays)                         # 3o
            fm      $t_out,$t_out,$gain_2               # 4e
        lqd     $point_x,0($a_rays)                     # 4o
        and     $t_e,$last,$k_packet                    # 5e
            stqd    $row3_5,832($a_surfaces)            # 5o
        and     $t_e_2,$last,$k_rays_gap                # 6e
            stqd    $row1,704($a_surfaces)              # 6o
        nop     $127                                    # 7e pairing
        rotqbyi $a_lane2,$object,8                      # 7o
        ceq     $miss,$object,$background               # 8e
        rotqbyi $a_lane1,$object,4                      # 8o
        ori     $a_lane0,$object,0                      # 9e
            stqd    $row2_4,0x5c0($a_surfaces)          # 9o
            fma     $normal_z,$t_out,$off_z,$normal_z_2 # 10e
        rotqbyi $a_lane3,$object,12                     # 10o
            fma     $normal_x,$t_out,$off_x,$normal_x_2 # 11e
        lqd     $quad2,0($a_lane2)                      # 11o
        cgti    $there,$t,-1                            # 12e
        lqd     $quad2_8,16($a_lane2)                   # 12o
            fms     $height,$off_squared_3,$t_out,$offset # 13e
        lqd     $quad0,0($a_lane0)                      # 13o
        andc    $miss,$there,$miss                      # 14e
        lqd     $quad3,0($a_lane3)                      # 14o
            fma     $normal_y,$t_out,$off_y,$normal_y_2 # 15e
        lqd     $quad0_6,16($a_lane0)                   # 15o
        a       $a_rays_2,$a_rays,$t_e_2                # 16e
        lqd     $quad3_2,16($a_lane3)                   # 16o
            fm      $t_e_8,$normal_x,$direction_x_2     # 17e
        lqd     $direction_x_2,192($a_rays)             # 17o
        sf      $hits,$miss,$hits                       # 18e
        lqd     $quad1,0($a_lane1)                      # 18o
            fma     $height,$slope_2,$along_4,$height   # 19e
        rotqbyi $quad2,$quad2,8                         # 19o
        and     $t_e_9,$last,$k_surfaces_gap            # 20e
        lqd     $quad3_3,32($a_lane3)                   # 20o
        lqd     $quad1_2,16($a_lane1)                   # 21o
        rotqbyi $quad3,$quad3,8                         # 22o
            fma     $t_e_8,$normal_y,$direction_y_2,$t_e_8 # 23e
        lqd     $direction_y_2,256($a_rays)             # 23o
        selb    $low02,$quad0,$quad2,$m_behind          # 24e
        rotqbyi $quad3_2,$quad3_2,8                     # 24o
            fnms    $point_z_2,$height,$normal_z,$point_z_2 # 25e
        rotqbyi $quad2_8,$quad2_8,8                     # 25o
            fnms    $point_y_3,$height,$normal_y,$point_y_2 # 26e
        lqd     $quad2_3,32($a_lane2)                   # 26o
            fnms    $point_x_3,$height,$normal_x,$point_x_2 # 27e
        lqd     $quad0_3,32($a_lane0)                   # 27o
        selb    $high02,$quad2,$quad0,$m_behind         # 28e
        rotqbyi $quad3_3,$quad3_3,8                     # 28o
        fma     $point_x_2,$t,$direction_x_2,$point_x   # 29e
        lqd     $quad1_3,32($a_lane1)                   # 29o
        selb    $low13,$quad1,$quad3,$m_behind          # 30e
        hbrr    next_row_back,next_row                  # 30o hint
        selb    $high13,$quad3,$quad1,$m_behind         # 31e
            stqd    $point_z_2,128($a_surfaces)         # 31o
            fma     $t_e_8,$normal_z,$direction_z_2,$t_e_8 # 32e
        lqd     $direction_z_2,320($a_rays)             # 32o
        selb    $low13_7,$quad1_2,$quad3_2,$m_behind    # 33e
        shufb   $centre_x_2,$low02,$low13,$m_first      # 33o
        selb    $high13_2,$quad3_2,$quad1_2,$m_behind   # 34e
        shufb   $centre_z,$high02,$high13,$m_third      # 34o
        selb    $high02_6,$quad2_8,$quad0_6,$m_behind   # 35e
        shufb   $centre_y_2,$low02,$low13,$m_second     # 35o
        selb    $low02,$quad0_6,$quad2_8,$m_behind      # 36e
        shufb   $gain_2,$high02,$high13,$m_fourth       # 36o
        fma     $point_y_2,$t,$direction_y_2,$point_y   # 37e
        shufb   $axis_z_3,$high02_6,$high13_2,$m_third  # 37o
        fs      $off_x,$point_x_2,$centre_x_2           # 38e
        shufb   $axis_x_2,$low02,$low13_7,$m_first      # 38o
        selb    $low13,$quad1_3,$quad3_3,$m_behind      # 39e
        rotqbyi $quad2,$quad2_3,8                       # 39o
        selb    $high13,$quad3_3,$quad1_3,$m_behind     # 40e
        shufb   $slope_2,$high02_6,$high13_2,$m_fourth  # 40o
        ai      $a_rays,$a_rays_2,16                    # 41e
        shufb   $axis_y_3,$low02,$low13_7,$m_second     # 41o
        fma     $point_z_2,$t,$direction_z_2,$point_z   # 42e
            stqd    $point_y_3,64($a_surfaces)          # 42o
        fs      $off_y,$point_y_2,$centre_y_2           # 43e
            stqd    $point_x_3,0($a_surfaces)           # 43o
        fm      $along_5,$off_x,$axis_x_2               # 44e
            stqd    $row0_5,640($a_surfaces)            # 44o
        selb    $low02,$quad0_3,$quad2,$m_behind        # 45e
            stqd    $row0_3,896($a_surfaces)            # 45o
        selb    $high02,$quad2,$quad0_3,$m_behind       # 46e
            stqd    $row2,0x400($a_surfaces)            # 46o
        ori     $sides13,$high13,0                      # 47e
        shufb   $offset,$low02,$low13,$m_first          # 47o
        fm      $normal_y_2,$slope_2,$axis_y_3          # 48e
        shufb   $row2,$high02,$high13,$m_third          # 48o
        fs      $off_z,$point_z_2,$centre_z             # 49e
        shufb   $leave_object_2,$low02,$low13,$m_second # 49o
        fma     $along_5,$off_y,$axis_y_3,$along_5      # 50e
            stqd    $row0_4,0x540($a_surfaces)          # 50o
        ori     $sides02,$high02,0                      # 51e
            stqd    $row3_6,0x500($a_surfaces)          # 51o
        ori     $a_lane0,$row2,0                        # 52e
        rotqbyi $a_lane2,$row2,8                        # 52o
        fm      $normal_z_2,$slope_2,$axis_z_3          # 53e
        rotqbyi $a_lane1,$row2,4                        # 53o
        andc    $leave_point_2,$point_x_2,$k_sign       # 54e
        rotqbyi $a_lane3,$row2,12                       # 54o
        andc    $t_e_4,$point_y_2,$k_sign               # 55e
        lqd     $quad0,0($a_lane0)                      # 55o
        fma     $along_4,$off_z,$axis_z_3,$along_5      # 56e
        lqd     $quad2,48($a_lane2)                     # 56o
        fa      $leave_point_4,$leave_point_2,$t_e_4    # 57e
        lqd     $quad1,48($a_lane1)                     # 57o
            rotmai  $front,$t_e_8,-31                   # 58e
        lqd     $quad3,48($a_lane3)                     # 58o
        fm      $normal_x_2,$slope_2,$axis_x_2          # 59e
        lqd     $quad2_6,0($a_lane2)                    # 59o
            andc    $flip,$k_sign,$t_e_8                # 60e
        lqd     $quad0_4,48($a_lane0)                   # 60o
        andc    $t_e_5,$point_z_2,$k_sign               # 61e
        lqd     $quad3_7,0($a_lane3)                    # 61o
        fnms    $off_x,$along_4,$axis_x_2,$off_x        # 62e
        lqd     $quad2_5,16($a_lane2)                   # 62o
            selb    $m_ratio,$m_second,$m_first,$front  # 63e
        lqd     $quad3_6,16($a_lane3)                   # 63o
            xor     $normal_x,$normal_x,$flip           # 64e
        rotqbyi $quad3,$quad3,8                         # 64o
        fnms    $off_z,$along_4,$axis_z_3,$off_z        # 65e
            shufb   $row0,$low02_6,$low13_6,$m_ratio    # 65o
        fnms    $off_y,$along_4,$axis_y_3,$off_y        # 66e
            stqd    $normal_x,384($a_surfaces)          # 66o
        fa      $leave_point_5,$leave_point_4,$t_e_5    # 67e
        rotqbyi $quad2_9,$quad2_6,8                     # 67o
        fm      $off_squared_4,$off_x,$off_x            # 68e
        lqd     $quad0_7,16($a_lane0)                   # 68o
            xor     $normal_y,$normal_y,$flip           # 69e
        lqd     $quad0_5,32($a_lane0)                   # 69o
        selb    $high13,$quad3,$quad1,$m_behind         # 70e
        rotqbyi $quad2,$quad2,8                         # 70o
        selb    $low13,$quad1,$quad3,$m_behind          # 71e
            stqd    $normal_y,448($a_surfaces)          # 71o
        nop     $127                                    # 72e pairing
        lqd     $quad3,32($a_lane3)                     # 72o
        or      $high13_3,$high13,$sides13              # 73e
        lqd     $quad1,16($a_lane1)                     # 73o
        fma     $off_squared_4,$off_y,$off_y,$off_squared_4 # 74e
        lqd     $quad2_4,32($a_lane2)                   # 74o
        selb    $high02,$quad2,$quad0_4,$m_behind       # 75e
        rotqbyi $quad2_5,$quad2_5,8                     # 75o
        selb    $low02,$quad0_4,$quad2,$m_behind        # 76e
        rotqbyi $quad3_8,$quad3_6,8                     # 76o
        or      $high02_4,$high02,$sides02              # 77e
        lqd     $quad1_5,0($a_lane1)                    # 77o
        fma     $leave_object_4,$leave_point_5,$k_leave,$leave_object_2 # 78e
        shufb   $row1,$low02,$low13,$m_second           # 78o
        selb    $low02_7,$quad0_7,$quad2_5,$m_behind    # 79e
        shufb   $flags,$high02_4,$high13_3,$m_fourth    # 79o
        selb    $low13_8,$quad1,$quad3_8,$m_behind      # 80e
        rotqbyi $quad2,$quad2_4,8                       # 80o
        fma     $off_squared_3,$off_z,$off_z,$off_squared_4 # 81e
        lqd     $quad1_6,32($a_lane1)                   # 81o
        selb    $high13_7,$quad3_8,$quad1,$m_behind     # 82e
        shufb   $row0_3,$low02_7,$low13_8,$m_first      # 82o
        selb    $high02_7,$quad2_5,$quad0_7,$m_behind   # 83e
        rotqbyi $quad3,$quad3,8                         # 83o
        selb    $low02_6,$quad0_5,$quad2,$m_behind      # 84e
        shufb   $row1_3,$low02_7,$low13_8,$m_second     # 84o
        and     $flags,$flags,$there                    # 85e
            stqd    $normal_x,192($a_surfaces)          # 85o
        and     $row0_3,$row0_3,$there                  # 86e
        shufb   $row3_7,$high02_7,$high13_7,$m_fourth   # 86o
        selb    $high02_8,$quad2_9,$quad0,$m_behind     # 87e
        frsqest $t_y_4,$off_squared_3                   # 87o
        selb    $high13_4,$quad3,$quad1_6,$m_behind     # 88e
            stqd    $row0,0x480($a_surfaces)            # 88o
        selb    $low13_6,$quad1_6,$quad3,$m_behind      # 89e
            stqd    $normal_y,256($a_surfaces)          # 89o
        selb    $high02_9,$quad2,$quad0_5,$m_behind     # 90e
        shufb   $row2_4,$high02,$high13,$m_third        # 90o
        fi      $t_y_5,$off_squared_3,$t_y_4            # 91e
        orx     $flags,$flags                           # 91o
        selb    $low02_8,$quad0,$quad2_9,$m_behind      # 92e
        shufb   $row0_4,$low02,$low13,$m_first          # 92o
            xor     $normal_z,$normal_z,$flip           # 93e
        shufb   $row2_5,$high02_9,$high13_4,$m_third    # 93o
        and     $row3_7,$row3_7,$there                  # 94e
        shufb   $row3_6,$high02_9,$high13_4,$m_fourth   # 94o
        or      $seen_2,$seen,$flags                    # 95e
            stqd    $normal_z,512($a_surfaces)          # 95o
            nop     $127                                # 96e pairing
            stqd    $normal_z,320($a_surfaces)          # 96o
            ai      $a_surfaces,$a_surfaces_2,16        # 97e
        stqd    $seen_2,0($a_flags)                     # 97o
        fm      $t_e_6,$off_squared_3,$t_y_5            # 98e
        rotqbyi $quad3,$quad3_7,8                       # 98o
        fm      $t_out_3,$t_y_5,$k_half                 # 99e
        stqd    $row2,0x600($a_surfaces)                # 99o
        a       $a_surfaces_2,$a_surfaces,$t_e_9        # 100e
        shufb   $row2,$high02_7,$high13_7,$m_third      # 100o
        andc    $seen,$seen_2,$last                     # 101e
        stqd    $row2_5,0x4c0($a_surfaces)              # 101o
        selb    $high13,$quad3,$quad1_5,$m_behind       # 102e
        stqd    $row1,0x580($a_surfaces)                # 102o
        selb    $low13,$quad1_5,$quad3,$m_behind        # 103e
        stqd    $leave_object_4,576($a_surfaces)        # 103o
        fnms    $t_e_2,$t_e_6,$t_y_5,$k_one             # 104e
        shufb   $row2_6,$high02_8,$high13,$m_third      # 104o
        and     $row2,$row2,$there                      # 105e
        shufb   $row3_4,$high02_8,$high13,$m_fourth     # 105o
        a       $a_flags,$a_flags,$t_e                  # 106e
        shufb   $row0_5,$low02_8,$low13,$m_first        # 106o
        stqd    $row3_7,0x440($a_surfaces)              # 107o
        stqd    $row2_6,768($a_surfaces)                # 108o
        and     $row3_5,$row3_4,$there                  # 109e
        stqd    $row1_3,960($a_surfaces)                # 109o
        fma     $t_out,$t_e_2,$t_out_3,$t_y_5           # 110e
        shufb   $row1,$low02_8,$low13,$m_second         # 110o
        nop     $127                                    # 111e pairing
next_row_back:
        brnz    $count,next_row                         # 111o
next_row_drain:
        fm      $t_out,$t_out,$gain_2                   # 0e
        stqd    $row3_5,832($a_surfaces)                # 0o
        ai      $a_surfaces_3,$a_surfaces_2,16          # 1e
        stqd    $row1,704($a_surfaces)                  # 1o
        ori     $a_rays,$hits,0                         # 2e
        stqd    $row2_4,0x5c0($a_surfaces)              # 2o
        hbr     surfaces_r16_return,$lr                 # 3o hint
        fma     $normal_x,$t_out,$off_x,$normal_x_2     # 6e
        fms     $height,$off_squared_3,$t_out,$offset   # 7e
        fma     $normal_y,$t_out,$off_y,$normal_y_2     # 8e
        fma     $normal_z,$t_out,$off_z,$normal_z_2     # 9e
        fm      $t_e_8,$normal_x,$direction_x_2         # 12e
        fma     $height,$slope_2,$along_4,$height       # 13e
        fma     $t_e_8,$normal_y,$direction_y_2,$t_e_8  # 18e
        fnms    $point_z_2,$height,$normal_z,$point_z_2 # 19e
        fnms    $point_y_3,$height,$normal_y,$point_y_2 # 20e
        fnms    $point_x_3,$height,$normal_x,$point_x_2 # 21e
        fma     $t_e_8,$normal_z,$direction_z_2,$t_e_8  # 24e
        stqd    $point_z_2,128($a_surfaces)             # 25o
        stqd    $point_y_3,64($a_surfaces)              # 26o
        stqd    $point_x_3,0($a_surfaces)               # 27o
        stqd    $row0_5,640($a_surfaces)                # 28o
        nop     $127                                    # 29e pairing
        stqd    $row0_3,896($a_surfaces)                # 29o
        rotmai  $front,$t_e_8,-31                       # 30e
        stqd    $row2,0x400($a_surfaces)                # 30o
        andc    $flip_2,$k_sign,$t_e_8                  # 31e
        stqd    $row0_4,0x540($a_surfaces)              # 31o
        stqd    $row3_6,0x500($a_surfaces)              # 32o
        xor     $normal_x,$normal_x,$flip_2             # 33e
        selb    $m_ratio,$m_second,$m_first,$front      # 34e
        lnop                                            # 34o pairing
        xor     $normal_y,$normal_y,$flip_2             # 35e
        stqd    $normal_x,384($a_surfaces)              # 35o
        xor     $normal_z,$normal_z,$flip_2             # 36e
        shufb   $row0,$low02_6,$low13_6,$m_ratio        # 36o
        stqd    $normal_y,448($a_surfaces)              # 37o
        stqd    $normal_x,192($a_surfaces)              # 38o
        stqd    $row0,0x480($a_surfaces)                # 40o
        stqd    $normal_y,256($a_surfaces)              # 41o
        stqd    $normal_z,512($a_surfaces)              # 42o
        stqd    $normal_z,320($a_surfaces)              # 43o
        nop     $127                                    # 44e pairing
surfaces_r16_return:
        bi      $lr                                     # 44o
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
        and     $t_e_3,$last,$k_rays_gap                # 9e
        lqd     $quad0,0($a_lane0)                      # 9o
        fma     $point_y,$t,$direction_y,$point_y       # 10e
        lqd     $quad0_8,16($a_lane0)                   # 10o
        fma     $point_x,$t,$direction_x,$point_x       # 11e
        lqd     $quad3,0($a_lane3)                      # 11o
        cgti    $there_2,$t,-1                          # 12e
        lqd     $quad3_4,16($a_lane3)                   # 12o
        a       $a_rays_3,$a_rays,$t_e_3                # 13e
        lqd     $quad2,0($a_lane2)                      # 13o
        andc    $miss,$there_2,$miss                    # 14e
        lqd     $quad1,0($a_lane1)                      # 14o
        nop     $127                                    # 15e pairing
        lqd     $quad2_10,16($a_lane2)                  # 15o
        andc    $t_e_10,$point_y,$k_sign                # 16e
        lqd     $direction_z_3,320($a_rays)             # 16o
        andc    $leave_point,$point_x,$k_sign           # 17e
        rotqbyi $quad3,$quad3,8                         # 17o
        sf      $hits,$miss,$hits                       # 18e
        lqd     $point_z_3,128($a_rays)                 # 18o
        fa      $leave_point,$leave_point,$t_e_10       # 19e
        rotqbyi $quad2,$quad2,8                         # 19o
        ai      $a_rays,$a_rays_3,16                    # 20e
        lqd     $quad1_6,16($a_lane1)                   # 20o
        selb    $low13,$quad1,$quad3,$m_behind          # 21e
        rotqbyi $quad2_10,$quad2_10,8                   # 21o
        selb    $high13,$quad3,$quad1,$m_behind         # 22e
        rotqbyi $quad3,$quad3_4,8                       # 22o
        selb    $low02,$quad0,$quad2,$m_behind          # 23e
        lqd     $quad3_4,32($a_lane3)                   # 23o
        selb    $high02,$quad2,$quad0,$m_behind         # 24e
        lqd     $quad1,32($a_lane1)                     # 24o
        selb    $low02_9,$quad0_8,$quad2_10,$m_behind   # 25e
        shufb   $centre_x_3,$low02,$low13,$m_first      # 25o
        selb    $low13_7,$quad1_6,$quad3,$m_behind      # 26e
        shufb   $centre_y_3,$low02,$low13,$m_second     # 26o
        fma     $point_z_4,$t,$direction_z_3,$point_z_3 # 27e
        shufb   $centre_z_2,$high02,$high13,$m_third    # 27o
        selb    $high13_8,$quad3,$quad1_6,$m_behind     # 28e
        shufb   $axis_x_3,$low02_9,$low13_7,$m_first    # 28o
        fs      $off_x,$point_x,$centre_x_3             # 29e
        shufb   $axis_y_4,$low02_9,$low13_7,$m_second   # 29o
        fs      $off_y,$point_y,$centre_y_3             # 30e
        shufb   $gain,$high02,$high13,$m_fourth         # 30o
        selb    $high02,$quad2_10,$quad0_8,$m_behind    # 31e
        lqd     $quad2,32($a_lane2)                     # 31o
        nop     $127                                    # 32e pairing
        rotqbyi $quad3,$quad3_4,8                       # 32o
        fs      $off_z,$point_z_4,$centre_z_2           # 33e
        shufb   $axis_z_4,$high02,$high13_8,$m_third    # 33o
        andc    $t_e_9,$point_z_4,$k_sign               # 34e
        shufb   $slope,$high02,$high13_8,$m_fourth      # 34o
        fm      $along,$off_x,$axis_x_3                 # 35e
        lqd     $quad0,32($a_lane0)                     # 35o
        selb    $high13,$quad3,$quad1,$m_behind         # 36e
        lnop                                            # 36o pairing
        selb    $low13,$quad1,$quad3,$m_behind          # 37e
        rotqbyi $quad2,$quad2,8                         # 37o
        fm      $normal_y,$slope,$axis_y_4              # 38e
        fm      $normal_x,$slope,$axis_x_3              # 39e
        fm      $normal_z,$slope,$axis_z_4              # 40e
        fma     $along,$off_y,$axis_y_4,$along          # 41e
        selb    $high02,$quad2,$quad0,$m_behind         # 42e
        selb    $low02,$quad0,$quad2,$m_behind          # 43e
        ori     $sides13,$high13,0                      # 44e
        shufb   $row2,$high02,$high13,$m_third          # 44o
        fa      $leave_point,$leave_point,$t_e_9        # 45e
        shufb   $offset,$low02,$low13,$m_first          # 45o
        ori     $sides02,$high02,0                      # 46e
        shufb   $leave_object,$low02,$low13,$m_second   # 46o
        fma     $along,$off_z,$axis_z_4,$along          # 47e
        lnop                                            # 47o pairing
        ori     $a_lane0,$row2,0                        # 48e
        rotqbyi $a_lane3,$row2,12                       # 48o
        rotqbyi $a_lane1,$row2,4                        # 49o
        lqd     $quad0,0($a_lane0)                      # 50o
        fma     $leave_object,$leave_point,$k_leave,$leave_object # 51e
        rotqbyi $a_lane2,$row2,8                        # 51o
        nop     $127                                    # 52e pairing
        lqd     $quad3,0($a_lane3)                      # 52o
        fnms    $off_x,$along,$axis_x_3,$off_x          # 53e
        lqd     $quad3_9,48($a_lane3)                   # 53o
        fnms    $off_y,$along,$axis_y_4,$off_y          # 54e
        lqd     $quad1,0($a_lane1)                      # 54o
        fnms    $off_z,$along,$axis_z_4,$off_z          # 55e
        lqd     $quad2,0($a_lane2)                      # 55o
        lqd     $quad2_11,48($a_lane2)                  # 56o
        lqd     $quad3_10,16($a_lane3)                  # 57o
        nop     $127                                    # 58e pairing
        rotqbyi $quad3,$quad3,8                         # 58o
        fm      $off_squared,$off_x,$off_x              # 59e
        rotqbyi $quad3_9,$quad3_9,8                     # 59o
        lqd     $quad2_6,32($a_lane2)                   # 60o
        rotqbyi $quad2,$quad2,8                         # 61o
        selb    $high13,$quad3,$quad1,$m_behind         # 62e
        rotqbyi $quad2_11,$quad2_11,8                   # 62o
        selb    $low13,$quad1,$quad3,$m_behind          # 63e
        rotqbyi $quad3,$quad3_10,8                      # 63o
        nop     $127                                    # 64e pairing
        lqd     $quad0_2,48($a_lane0)                   # 64o
        fma     $off_squared,$off_y,$off_y,$off_squared # 65e
        lqd     $quad1,48($a_lane1)                     # 65o
        selb    $low02,$quad0,$quad2,$m_behind          # 66e
        lqd     $quad2_10,16($a_lane2)                  # 66o
        selb    $high02,$quad2,$quad0,$m_behind         # 67e
        lqd     $quad3_3,32($a_lane3)                   # 67o
        shufb   $row0,$low02,$low13,$m_first            # 68o
        shufb   $row1,$low02,$low13,$m_second           # 69o
        selb    $high02_10,$quad2_11,$quad0_2,$m_behind # 70e
        shufb   $row2_7,$high02,$high13,$m_third        # 70o
        fma     $off_squared,$off_z,$off_z,$off_squared # 71e
        shufb   $row3,$high02,$high13,$m_fourth         # 71o
        or      $high02,$high02_10,$sides02             # 72e
        stqd    $row0,640($a_surfaces)                  # 72o
        selb    $low02,$quad0_2,$quad2_11,$m_behind     # 73e
        lqd     $quad0,32($a_lane0)                     # 73o
        selb    $low13,$quad1,$quad3_9,$m_behind        # 74e
        rotqbyi $quad3_11,$quad3_3,8                    # 74o
        and     $row3,$row3,$there_2                    # 75e
        stqd    $row2,0x600($a_surfaces)                # 75o
        selb    $high13,$quad3_9,$quad1,$m_behind       # 76e
        lqd     $quad1,32($a_lane1)                     # 76o
        nop     $127                                    # 77e pairing
        frsqest $t_y,$off_squared                       # 77o
        or      $high13_8,$high13,$sides13              # 78e
        stqd    $row2_7,768($a_surfaces)                # 78o
        rotqbyi $quad2,$quad2_6,8                       # 79o
        lqd     $quad0_2,16($a_lane0)                   # 80o
        fi      $t_y,$off_squared,$t_y                  # 81e
        stqd    $leave_object,576($a_surfaces)          # 81o
        selb    $low13_9,$quad1,$quad3_11,$m_behind     # 82e
        lqd     $quad1_7,16($a_lane1)                   # 82o
        selb    $low02_10,$quad0,$quad2,$m_behind       # 83e
        shufb   $row1_4,$low02,$low13,$m_second         # 83o
        selb    $high02_11,$quad2,$quad0,$m_behind      # 84e
        stqd    $row1,704($a_surfaces)                  # 84o
        selb    $high13_9,$quad3_11,$quad1,$m_behind    # 85e
        rotqbyi $quad2,$quad2_10,8                      # 85o
        shufb   $flags,$high02,$high13_8,$m_fourth      # 86o
        shufb   $row3_8,$high02_11,$high13_9,$m_fourth  # 87o
        fm      $t_e_11,$off_squared,$t_y               # 88e
        shufb   $row2,$high02_11,$high13_9,$m_third     # 88o
        fm      $t_out,$t_y,$k_half                     # 89e
        stqd    $row3,832($a_surfaces)                  # 89o
        selb    $low02_11,$quad0_2,$quad2,$m_behind     # 90e
        shufb   $row0,$low02,$low13,$m_first            # 90o
        selb    $high02,$quad2,$quad0_2,$m_behind       # 91e
        stqd    $row3_8,0x500($a_surfaces)              # 91o
        selb    $low13,$quad1_7,$quad3,$m_behind        # 92e
        stqd    $row2,0x4c0($a_surfaces)                # 92o
        and     $flags,$flags,$there_2                  # 93e
        shufb   $row2,$high02_10,$high13,$m_third       # 93o
        fnms    $t_e_3,$t_e_11,$t_y,$k_one              # 94e
        shufb   $row0_6,$low02_11,$low13,$m_first       # 94o
        selb    $high13,$quad3,$quad1_7,$m_behind       # 95e
        orx     $flags,$flags                           # 95o
        shufb   $row1,$low02_11,$low13,$m_second        # 96o
        shufb   $row3,$high02,$high13,$m_fourth         # 97o
        and     $row0_7,$row0_6,$there_2                # 98e
        shufb   $row2_8,$high02,$high13,$m_third        # 98o
        or      $seen_3,$seen,$flags                    # 99e
        stqd    $row2,0x5c0($a_surfaces)                # 99o
        fma     $t_out,$t_e_3,$t_out,$t_y               # 100e
        stqd    $row1,960($a_surfaces)                  # 100o
        andc    $seen,$seen_3,$last                     # 101e
        stqd    $seen_3,0($a_flags)                     # 101o
        and     $row2,$row2_8,$there_2                  # 102e
        stqd    $row0,0x540($a_surfaces)                # 102o
        a       $a_flags,$a_flags,$t_e                  # 103e
        stqd    $row0_7,896($a_surfaces)                # 103o
        and     $row3,$row3,$there_2                    # 104e
        stqd    $row2,0x400($a_surfaces)                # 104o
        nop     $127                                    # 105e pairing
        stqd    $row1_4,0x580($a_surfaces)              # 105o
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
        fnms    $point_z_4,$height,$normal_z,$point_z_4 # 128e
        fma     $t_e,$normal_z,$direction_z_3,$t_e      # 130e
        stqd    $point_x,0($a_surfaces)                 # 132o
        stqd    $point_y,64($a_surfaces)                # 133o
        stqd    $point_z_4,128($a_surfaces)             # 134o
        andc    $flip,$k_sign,$t_e                      # 136e
        rotmai  $front,$t_e,-31                         # 137e
        xor     $normal_z,$normal_z,$flip               # 138e
        xor     $normal_x,$normal_x,$flip               # 139e
        xor     $normal_y,$normal_y,$flip               # 140e
        stqd    $normal_z,320($a_surfaces)              # 140o
        selb    $m_ratio,$m_second,$m_first,$front      # 141e
        stqd    $normal_z,512($a_surfaces)              # 141o
        stqd    $normal_x,192($a_surfaces)              # 142o
        shufb   $row0,$low02_10,$low13_9,$m_ratio       # 143o
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
