# isect_cone_pairs_r16   nearest hit of packets' rays with open cones, candidate by candidate
#   C       void isect_cone_pairs_r16(const struct candidate *, int count);
#   In      $3 candidates of objects that are cones, $4 count (0 is none); pointers 16-aligned
#   Out     the candidates' packets: t, object, where a hit has 0 < t < what was there
#   Uses    $2-$79   Saves  -   Stack  0   Calls  -
#   Domain  |d| and |axis| = 1 within 4 ulp; distances, height and radius from 2^-30 to 2^30;
#           radius and height not below 0; radii of the body, by growth, not below 0
#   Error   250 ulp of the sum of the distance from the base, the height and the largest radius,
#           where t changes by less than 10 times what the surface is moved by; farther than
#           1e-4 radii and 2e-6 of that sum from outlines, ends and surface, hits are right,
#           but in cones so thin as 1/200 of their height that taper to almost nothing, where
#           one seed in some thirty has shown a hit lost inside
#   Twin    lab/twins/src/cone.rs
#
# Let w be the vector from the base to the ray's point that is nearest to the base. It has the
# component h along the axis and c across it. The direction has the components rise and e. The
# body's radius at that height is k, and it grows along the ray by m. The ray crosses the body, or
# its mirror image beyond the apex, at the roots of
# |c + s e|^2 = (k + m s)^2, whose halved coefficients are
#   a = |e|^2 - m^2
#   b = c.e - k m
#   out = |c|^2 - k^2
#   disc = |k e - m c|^2 - |c x e|^2
# The last equals b^2 - a out, but loses digits only at the outline and near the apex. If the root
# gets the sign of b, q = b + root does not cancel, and the crossings are at s = -q/a and s =
# -out/q. The crossing at -q/a enters the body if b is not below 0, and otherwise leaves it. The
# other crossing does the opposite. This also holds for a below 0. If the direction is parallel to
# the axis of a cylinder, disc would be 0. It is made slightly smaller, so that there is no hit.
#
# Crossings outside the heights or seen from the wrong side get a negative sign, and so do not
# count. As unsigned integers they are larger than the others, and the smaller number is the nearer
# crossing.
#
# A pass is one row of four rays, a quarter of a candidate. All four rows in one pass would leave
# too few registers for passes to overlap (386 cycles instead of 4 times 91) and have four times as
# much code. The odd pipe has room to load the record again. A load ignores the lowest bits of an
# address, so the list pointer advances by quarters of an entry: all four load the same candidate,
# and the low bits select the row.
# Scheduled by spu schedule from isect_cone_pairs_r16.s

        .include "work_unit.inc"
        .include "macros.inc"
        .include "pairs.inc"

        .set    NEXT,3
        registers a_candidate,count
        # constants
        .set    NEXT,10
        registers m_x,m_y,m_z,k_half,k_one,k_tiny,m_sign,a_controls,a_if_enters,a_if_leaves
        # the candidate
        registers object
        registers a_packet                              # its row
        registers quad,base_x,base_y,base_z,axis_x,axis_y,axis_z,radius,growth,height,sides
        registers if_enters                             # the sign bit where entries do not count
        registers if_leaves                             # the sign bit where exits do not count
        # a row
        registers x                                     # direction
        registers y,z,wx,wy,wz
        registers near                                  # t of the ray's point nearest to the base
        registers h,rise,cx,cy,cz,ex,ey,ez,k,m,a,b,out
        registers turn_x                                # c x e
        registers turn_y,turn_z
        registers vx                                    # k e - m c
        registers vy,vz
        registers outside                               # disc
        .set    NEXT,61
        registers disc
        registers t_y,s,t_e,q,inverse,first,second,t,t_second,off,off_second,hidden,hidden_second
        registers ahead,t_best,nearest,control,inverse_q
        .set    row,43                                  # reused

        sign_controls_table

# Indexed by SIDES_BOTH, SIDES_EXIT and both.
hidden_if_enters:
    .irp value, 0,0,0x80000000,0
        .int    \value,\value,\value,\value
    .endr
hidden_if_leaves:
    .irp value, 0x80000000,0,0,0
        .int    \value,\value,\value,\value
    .endr

# dot = a . b, where the registers' names are a and b followed by x, y and z.
.macro  dot_f4 dot:req, a:req, b
        fm      \dot,$\a\()x,$\b\()x
        fma     \dot,$\a\()y,$\b\()y,\dot
        fma     \dot,$\a\()z,$\b\()z,\dot
.endm

function isect_cone_pairs_r16
        .set count_2,79; .set row_2,2; .set object_2,5; .set object_3,6; .set a_packet_2,22
        .set row_3,7; .set object_4,8; .set object_5,9; .set quad_2,24; .set quad_3,21
        .set quad_4,48; .set base_x_2,7; .set base_y_2,26; .set base_z_2,7; .set growth_2,7
        .set radius_2,23; .set row_4,24; .set quad_5,25; .set a_packet_3,29; .set quad_6,30
        .set quad_7,32; .set object_6,21; .set a_packet_4,31; .set base_x_3,33; .set a_packet_5,2
        .set base_y_3,29; .set base_z_3,34; .set a_packet_6,25; .set wy_2,31; .set wx_2,42
        .set near_2,47; .set x_2,41; .set row_5,49; .set wz_2,24; .set y_2,43; .set z_2,44
        .set wy_3,29; .set axis_y_2,51; .set wx_3,31; .set axis_x_2,33; .set axis_z_2,52
        .set growth_3,53; .set radius_3,54; .set ex_2,30; .set quad_8,35; .set m_2,55; .set ey_2,36
        .set wy_4,45; .set ez_2,37; .set x_3,56; .set h_2,46; .set y_3,57; .set near_3,50
        .set wz_3,58; .set base_x_4,34; .set row_6,59; .set base_y_4,60; .set a_2,61
        .set base_z_4,35; .set z_3,62; .set sides_2,20; .set quad_9,63; .set wy_5,60
        .set near_4,64; .set row_7,45; .set near_5,59; .set a_3,47; .set row_8,61; .set wx_4,34
        .set row_9,65; .set height_2,66; .set near_6,46; .set axis_x_3,67; .set wz_4,35
        .set axis_y_3,68; .set axis_z_3,63; .set near_7,58; .set sides_3,5; .set cx_2,26
        .set h_3,38; .set k_2,69; .set h_4,70; .set cy_2,27; .set cz_2,28; .set sides_4,7
        .set wx_5,39; .set object_7,40; .set wy_6,71; .set vx_2,6; .set a_packet_7,8
        .set turn_y_2,29; .set a_packet_8,23; .set vy_2,31; .set growth_4,72; .set vz_2,50
        .set sides_5,73; .set turn_x_2,7; .set turn_z_2,74; .set near_8,42; .set vx_3,75
        .set turn_y_3,78; .set vy_3,79; .set turn_x_3,9; .set a_packet_9,7; .set h_5,22
        .set near_9,29; .set disc_2,75; .set row_10,31; .set object_8,2; .set b_2,30
        .set height_3,46; .set m_3,32; .set radius_4,40; .set ex_3,41; .set ez_3,36; .set disc_3,44
        .set ey_3,43; .set out_2,26; .set t_y_2,49; .set b_3,37; .set a_4,75; .set cx_3,33
        .set h_6,50; .set disc_4,9; .set h_7,30; .set cy_3,39; .set k_3,53; .set cz_3,22
        .set vx_4,24; .set vy_4,44; .set turn_y_4,51; .set vz_3,52; .set if_enters_2,54
        .set if_leaves_2,20; .set t_y_3,27; .set disc_5,24; .set disc_6,71; .set hidden_second_2,78
        .set row_11,79; .set t_e_2,44; .set turn_z_3,28; .set s_2,9; .set inverse_2,44
        .set t_e_3,27; .set hidden_2,20; .set wx_6,54; .set out_3,51; .set q_2,9; .set b_4,27
        .set h_8,28; .set wy_7,37; .set first_2,33; .set t_y_4,34; .set t_y_5,41; .set disc_7,58
        .set t_y_6,43; .set sides_6,44; .set off_2,55; .set if_enters_3,59; .set ex_4,70
        .set if_leaves_3,5; .set t_y_7,33; .set t_e_4,9; .set off_3,43; .set a_5,55; .set s_3,43
        .set b_5,9; .set t_e_5,20; .set ey_4,34; .set out_4,27; .set second_2,26; .set t_e_6,33
        .set ez_4,24; .set inverse_3,20; .set out_5,22; .set off_second_2,27; .set t_second_2,26
        .set h_9,56; .set out_6,33; .set t_second_3,22; .set k_4,59; .set vx_5,5; .set vy_5,22
        .set turn_y_5,32; .set vy_6,9; .set turn_y_6,36; .set t_y_8,22; .set t_y_9,5
        .set base_x_5,20; .set base_z_5,5; .set radius_5,5; .set ex_5,9; .set growth_5,20
        .set vy_7,20; .set row_12,3; .set a_packet_10,4; .set near_10,7; .set height_4,8
        .set if_enters_4,10; .set h_10,11; .set a_packet_11,5; .set a_packet_12,12
        .set hidden_second_3,10; .set disc_8,15; .set t_y_10,6; .set t_e_7,2; .set quad_10,5
        .set quad_11,6
        nop     $127                                    # 0e pairing
        biz     $count,$lr                              # 0o
        shli    $count,$count,2                         # 1e
        ilhu    $m_x,1                                  # 2e
        ilhu    $m_y,0x405                              # 3e
        ilhu    $m_z,0x809                              # 4e
        clgti   $count_2,$count,3                       # 5e at least as many passes as overlap
        iohl    $m_x,515                                # 6e
        iohl    $m_y,0x607                              # 7e
        iohl    $m_z,0xa0b                              # 8e
        ilhu    $k_half,0x3f00                          # 9e
        ilhu    $k_one,0x3f80                           # 10e
        ilhu    $k_tiny,128                             # 11e
        ilhu    $m_sign,0x8000                          # 12e
        ila     $a_controls,sign_controls               # 13e
        ila     $a_if_enters,hidden_if_enters           # 14e
        ila     $a_if_leaves,hidden_if_leaves           # 15e
        brz     $count_2,next_row_short                 # 15o too few passes
        shli    $row,$a_candidate,2                     # 16e
        lqd     $object,0($a_candidate)                 # 16o
        ai      $a_candidate,$a_candidate,4             # 17e
        ai      $count,$count,-1                        # 18e
        shli    $row_2,$a_candidate,2                   # 19e
        lqd     $object_2,0($a_candidate)               # 19o
        andi    $row,$row,48                            # 20e
        ai      $a_candidate,$a_candidate,4             # 21e
        ai      $count,$count,-1                        # 22e
        shufb   $object_3,$object,$object,$m_x          # 22o
        andi    $row_2,$row_2,48                        # 23e
        rotqbyi $a_packet_2,$object,4                   # 23o
        shli    $row_3,$a_candidate,2                   # 24e
        lqd     $object_4,0($a_candidate)               # 24o
        ai      $a_candidate,$a_candidate,4             # 25e
        shufb   $object_5,$object_2,$object_2,$m_x      # 25o
        ai      $count,$count,-1                        # 26e
        lqd     $quad_2,0($object_3)                    # 26o
        a       $a_packet_2,$a_packet_2,$row            # 27e
        lqd     $quad_3,16($object_3)                   # 27o
        andi    $row,$row_3,48                          # 28e
        lqd     $quad_4,48($object_3)                   # 28o
        lqd     $wx,0($a_packet_2)                      # 29o
        lqd     $wy,64($a_packet_2)                     # 30o
        lqd     $x,192($a_packet_2)                     # 31o
        shufb   $base_x_2,$quad_2,$quad_2,$m_x          # 32o
        shufb   $base_y_2,$quad_2,$quad_2,$m_y          # 33o
        lqd     $y,256($a_packet_2)                     # 34o
        nop     $127                                    # 35e pairing
        lqd     $wz,128($a_packet_2)                    # 35o
        fs      $wx,$base_x_2,$wx                       # 36e
        shufb   $base_z_2,$quad_2,$quad_2,$m_z          # 36o
        fs      $wy,$base_y_2,$wy                       # 37e
        lqd     $z,320($a_packet_2)                     # 37o
        shufb   $axis_x,$quad_3,$quad_3,$m_x            # 38o
        shufb   $axis_y,$quad_3,$quad_3,$m_y            # 39o
        nop     $127                                    # 40e pairing
        shufb   $axis_z,$quad_3,$quad_3,$m_z            # 40o
        fs      $wz,$base_z_2,$wz                       # 41e
        shufb   $growth_2,$quad_4,$quad_4,$m_y          # 41o
        fm      $near,$wx,$x                            # 42e
        shufb   $radius_2,$quad_4,$quad_4,$m_x          # 42o
        fm      $row_4,$axis_x,$x                       # 43e
        lqd     $quad_5,0($object_5)                    # 43o
        rotqbyi $a_packet_3,$object_2,4                 # 44o
        lqd     $quad_6,16($object_5)                   # 45o
        lqd     $quad_7,48($object_5)                   # 46o
        shufb   $object_6,$object_4,$object_4,$m_x      # 47o
        fma     $near,$wy,$y,$near                      # 48e
        rotqbyi $a_packet_4,$object_4,4                 # 48o
        fma     $row_4,$axis_y,$y,$row_4                # 49e
        shufb   $base_x_3,$quad_5,$quad_5,$m_x          # 49o
        a       $a_packet_5,$a_packet_3,$row_2          # 50e
        shufb   $base_y_3,$quad_5,$quad_5,$m_y          # 50o
        nop     $127                                    # 51e pairing
        shufb   $base_z_3,$quad_5,$quad_5,$m_z          # 51o
        a       $a_packet_6,$a_packet_4,$row            # 52e
        lqd     $wy_2,64($a_packet_5)                   # 52o
        nop     $127                                    # 53e pairing
        lqd     $wx_2,0($a_packet_5)                    # 53o
        fma     $near_2,$wz,$z,$near                    # 54e
        lqd     $x_2,192($a_packet_5)                   # 54o
        fma     $row_5,$axis_z,$z,$row_4                # 55e
        lqd     $wz_2,128($a_packet_5)                  # 55o
        lqd     $y_2,256($a_packet_5)                   # 56o
        lqd     $z_2,320($a_packet_5)                   # 57o
        fs      $wy_3,$base_y_3,$wy_2                   # 58e
        shufb   $axis_y_2,$quad_6,$quad_6,$m_y          # 58o
        fs      $wx_3,$base_x_3,$wx_2                   # 59e
        shufb   $axis_x_2,$quad_6,$quad_6,$m_x          # 59o
        fms     $wy,$near_2,$y,$wy                      # 60e
        shufb   $axis_z_2,$quad_6,$quad_6,$m_z          # 60o
        fms     $wx,$near_2,$x,$wx                      # 61e
        shufb   $growth_3,$quad_7,$quad_7,$m_y          # 61o
        fms     $wz,$near_2,$z,$wz                      # 62e
        shufb   $radius_3,$quad_7,$quad_7,$m_x          # 62o
        fnms    $ex_2,$row_5,$axis_x,$x                 # 63e
        lqd     $quad_8,0($object_6)                    # 63o
        fm      $m_2,$growth_2,$row_5                   # 64e
        lqd     $wx_2,0($a_packet_6)                    # 64o
        fnms    $ey_2,$row_5,$axis_y,$y                 # 65e
        lqd     $wy_4,64($a_packet_6)                   # 65o
        fnms    $ez_2,$row_5,$axis_z,$z                 # 66e
        lqd     $x_3,192($a_packet_6)                   # 66o
        fm      $h_2,$axis_x,$wx                        # 67e
        lqd     $y_3,256($a_packet_6)                   # 67o
        fm      $near_3,$wx_3,$x_2                      # 68e
        lqd     $wz_3,128($a_packet_6)                  # 68o
        fs      $wz_2,$base_z_3,$wz_2                   # 69e
        shufb   $base_x_4,$quad_8,$quad_8,$m_x          # 69o
        fm      $row_6,$axis_x_2,$x_2                   # 70e
        shufb   $base_y_4,$quad_8,$quad_8,$m_y          # 70o
        fm      $a_2,$ex_2,$ex_2                        # 71e
        shufb   $base_z_4,$quad_8,$quad_8,$m_z          # 71o
        nop     $127                                    # 72e pairing
        lqd     $z_3,320($a_packet_6)                   # 72o
        fma     $h_2,$axis_y,$wy,$h_2                   # 73e
        lqd     $sides_2,32($object)                    # 73o
        fma     $near_3,$wy_3,$y_2,$near_3              # 74e
        lqd     $quad_9,16($object_6)                   # 74o
        fs      $wy_5,$base_y_4,$wy_4                   # 75e
        shlqbyi $near_4,$near_2,0                       # 75o copy
        fma     $row_7,$axis_y_2,$y_2,$row_6            # 76e
        shlqbyi $near_5,$near_2,0                       # 76o copy
        fma     $a_3,$ey_2,$ey_2,$a_2                   # 77e
        shlqbyi $row_8,$row_5,0                         # 77o copy
        fs      $wx_4,$base_x_4,$wx_2                   # 78e
        shlqbyi $row_9,$row_5,0                         # 78o copy
        fma     $h,$axis_z,$wz,$h_2                     # 79e
        shufb   $height_2,$quad_4,$quad_4,$m_z          # 79o
        fma     $near_6,$wz_2,$z_2,$near_3              # 80e
        shufb   $axis_x_3,$quad_9,$quad_9,$m_x          # 80o
        fs      $wz_4,$base_z_4,$wz_3                   # 81e
        shufb   $axis_y_3,$quad_9,$quad_9,$m_y          # 81o
        fma     $row_5,$axis_z_2,$z_2,$row_7            # 82e
        shufb   $axis_z_3,$quad_9,$quad_9,$m_z          # 82o
        fma     $a_3,$ez_2,$ez_2,$a_3                   # 83e
        rotqbyi $sides_2,$sides_2,12                    # 83o
        fm      $near_7,$wx_4,$x_3                      # 84e
        lqd     $sides_3,32($object_2)                  # 84o
        fnms    $cx_2,$h,$axis_x,$wx                    # 85e
        shlqbyi $h_3,$h,0                               # 85o copy
        fma     $k_2,$growth_2,$h,$radius_2             # 86e
        shlqbyi $h_4,$h,0                               # 86o copy
        fnms    $cy_2,$h,$axis_y,$wy                    # 87e
        lqd     $quad_4,48($object_6)                   # 87o
        fnms    $cz_2,$h,$axis_z,$wz                    # 88e
        lqd     $sides_4,32($object_4)                  # 88o
        fms     $wx_5,$near_6,$x_2,$wx_3                # 89e
        shlqbyi $object_7,$object_3,0                   # 89o copy
        fms     $wy_6,$near_6,$y_2,$wy_3                # 90e
        rotqbyi $sides_3,$sides_3,12                    # 90o
        fm      $vx_2,$m_2,$cx_2                        # 91e
        shlqbyi $a_packet_7,$a_packet_2,0               # 91o copy
        fm      $turn_y_2,$cx_2,$ez_2                   # 92e
        shlqbyi $a_packet_8,$a_packet_5,0               # 92o copy
        fm      $vy_2,$m_2,$cy_2                        # 93e
        shufb   $growth_4,$quad_4,$quad_4,$m_y          # 93o
        fm      $vz_2,$m_2,$cz_2                        # 94e
        rotqbyi $sides_5,$sides_4,12                    # 94o
        fm      $turn_x_2,$cz_2,$ey_2                   # 95e
        lqd     $t_best,384($a_packet_7)                # 95o
        fm      $turn_z_2,$cy_2,$ex_2                   # 96e
        shlqbyi $near_8,$near_6,0                       # 96o copy
        fms     $vx_3,$k_2,$ex_2,$vx_2                  # 97e
        shlqbyi $a_packet_2,$a_packet_2,0               # 97o copy
        fms     $turn_y_3,$cz_2,$ex_2,$turn_y_2         # 98e
        lqd     $nearest,448($a_packet_7)               # 98o
        fms     $vy_3,$k_2,$ey_2,$vy_2                  # 99e
        shlqbyi $row_7,$row_5,0                         # 99o copy
        fms     $vz_2,$k_2,$ez_2,$vz_2                  # 100e
        shlqbyi $object_3,$object_5,0                   # 100o copy
        fms     $turn_x_3,$cy_2,$ez_2,$turn_x_2         # 101e
        shlqbyi $a_packet_9,$a_packet_2,0               # 101o copy
        fm      $h_5,$axis_x_2,$wx_5                    # 102e
        shlqbyi $near_9,$near_6,0                       # 102o copy
        fms     $disc_2,$vx_3,$vx_3,$k_tiny             # 103e
        shlqbyi $row_10,$row_5,0                        # 103o copy
        fms     $turn_z_2,$cx_2,$ey_2,$turn_z_2         # 104e
        shlqbyi $a_packet_7,$a_packet_5,0               # 104o copy
        fms     $wz_2,$near_6,$z_2,$wz_2                # 105e
        shlqbyi $object_8,$object_7,0                   # 105o copy
        fm      $b_2,$cx_2,$ex_2                        # 106e
        shufb   $height_3,$quad_7,$quad_7,$m_z          # 106o
        fm      $m_3,$growth_3,$row_5                   # 107e
        shufb   $radius_4,$quad_4,$quad_4,$m_x          # 107o
        fma     $h_5,$axis_y_2,$wy_6,$h_5               # 108e
        fma     $disc_2,$vy_3,$vy_3,$disc_2             # 109e
        fnms    $ex_3,$row_5,$axis_x_2,$x_2             # 110e
        fnms    $a_3,$m_2,$m_2,$a_3                     # 111e
        fma     $b_2,$cy_2,$ey_2,$b_2                   # 112e
        fnms    $ez_3,$row_5,$axis_z_2,$z_2             # 113e
        fma     $h_5,$axis_z_2,$wz_2,$h_5               # 114e
        fma     $disc_3,$vz_2,$vz_2,$disc_2             # 115e
        fnms    $ey_3,$row_5,$axis_y_2,$y_2             # 116e
        lnop                                            # 116o pairing
        fm      $out_2,$cx_2,$cx_2                      # 117e
        frest   $t_y_2,$a_3                             # 117o
        fma     $b_3,$cz_2,$ez_2,$b_2                   # 118e
        fm      $a_4,$ex_3,$ex_3                        # 119e
        fnms    $cx_3,$h_5,$axis_x_2,$wx_5              # 120e
        shlqbyi $h_6,$h_5,0                             # 120o copy
        fnms    $disc_4,$turn_x_3,$turn_x_3,$disc_3     # 121e
        shlqbyi $h_7,$h_5,0                             # 121o copy
        fnms    $cy_3,$h_5,$axis_y_2,$wy_6              # 122e
        fma     $k_3,$growth_3,$h_5,$radius_3           # 123e
        fnms    $b_3,$k_2,$m_2,$b_3                     # 124e
        fnms    $cz_3,$h_5,$axis_z_2,$wz_2              # 125e
        fm      $vx_4,$m_3,$cx_3                        # 126e
        fnms    $disc_4,$turn_y_3,$turn_y_3,$disc_4     # 127e
        fm      $vy_4,$m_3,$cy_3                        # 128e
        fm      $turn_y_4,$cx_3,$ez_3                   # 129e
        fi      $t_y_2,$a_3,$t_y_2                      # 130e
        rotmi   $sides_2,$sides_2,-26                   # 131e the two bits to quadwords' addresses
        fm      $vz_3,$m_3,$cz_3                        # 132e
        fnms    $disc_4,$turn_z_2,$turn_z_2,$disc_4     # 133e
        fms     $vx_4,$k_3,$ex_3,$vx_4                  # 134e
        lnop                                            # 134o pairing
        fms     $vy_4,$k_3,$ey_3,$vy_4                  # 135e
        lqx     $if_enters_2,$a_if_enters,$sides_2      # 135o
        fm      $turn_x,$cz_3,$ey_3                     # 136e
        lqx     $if_leaves_2,$a_if_leaves,$sides_2      # 136o
        fms     $turn_y_4,$cz_3,$ex_3,$turn_y_4         # 137e
        fms     $vz_3,$k_3,$ez_3,$vz_3                  # 138e
        fma     $out_2,$cy_2,$cy_2,$out_2               # 139e
        frsqest $t_y_3,$disc_4                          # 139o
        fms     $disc_5,$vx_4,$vx_4,$k_tiny             # 140e
        shlqbyi $disc_6,$disc_4,0                       # 140o copy
        fm      $turn_z_2,$cy_3,$ex_3                   # 141e
        fms     $turn_x,$cy_3,$ez_3,$turn_x             # 142e
        fi      $t_y_3,$disc_4,$t_y_3                   # 143e
        selb    $hidden_second_2,$if_leaves_2,$if_enters_2,$b_3 # 144e
        fm      $row_11,$axis_x_3,$x_3                  # 145e
        fma     $disc_5,$vy_4,$vy_4,$disc_5             # 146e
        fnms    $t_e_2,$a_3,$t_y_2,$k_one               # 147e
        fma     $out_2,$cz_2,$cz_2,$out_2               # 148e
        fms     $turn_z_3,$cx_3,$ey_3,$turn_z_2         # 149e
        fm      $s_2,$disc_4,$t_y_3                     # 150e
        fma     $near_2,$wy_5,$y_3,$near_7              # 151e
        fma     $disc_5,$vz_3,$vz_3,$disc_5             # 152e
        fma     $inverse_2,$t_e_2,$t_y_2,$t_y_2         # 153e
        fnms    $out_2,$k_2,$k_2,$out_2                 # 154e
        fma     $a,$ey_3,$ey_3,$a_4                     # 155e
        fnms    $t_e_3,$s_2,$t_y_3,$k_one               # 156e 1 - s y
        selb    $s_2,$s_2,$b_3,$m_sign                  # 157e
        fnms    $disc_5,$turn_x,$turn_x,$disc_5         # 158e
        fma     $near_2,$wz_4,$z_3,$near_2              # 159e
        fma     $row_5,$axis_y_3,$y_3,$row_11           # 160e
        fma     $a,$ez_3,$ez_3,$a                       # 161e
        fma     $t_e_3,$t_e_3,$k_half,$k_one            # 162e
        selb    $hidden_2,$if_enters_2,$if_leaves_2,$b_3 # 163e
        fnms    $disc_5,$turn_y_4,$turn_y_4,$disc_5     # 164e
        fms     $wx_6,$near_2,$x_3,$wx_4                # 165e
        fms     $wz_4,$near_2,$z_3,$wz_4                # 166e
        fm      $out_3,$cx_3,$cx_3                      # 167e
        fma     $q_2,$s_2,$t_e_3,$b_3                   # 168e
        fm      $b_4,$cx_3,$ex_3                        # 169e
        fnms    $disc_5,$turn_z_3,$turn_z_3,$disc_5     # 170e
        fm      $h_8,$axis_x_3,$wx_6                    # 171e
        fnms    $a,$m_3,$m_3,$a                         # 172e
        fms     $wy_7,$near_2,$y_3,$wy_5                # 173e
        lnop                                            # 173o pairing
        fm      $first_2,$q_2,$inverse_2                # 174e -s
        frest   $t_y_4,$q_2                             # 174o
        fma     $b_4,$cy_3,$ey_3,$b_4                   # 175e
        lnop                                            # 175o pairing
        fma     $row_5,$axis_z_3,$z_3,$row_5            # 176e
        frsqest $t_y_5,$disc_5                          # 176o
        rotmi   $sides_3,$sides_3,-26                   # 177e the two bits to quadwords' addresses
        shlqbyi $disc_7,$disc_5,0                       # 177o copy
        fi      $t_y_4,$q_2,$t_y_4                      # 178e
        frest   $t_y_6,$a                               # 178o
        rotmi   $sides_6,$sides_5,-26                   # 179e the two bits to quadwords' addresses
        fnms    $off_2,$first_2,$row_9,$h_4             # 180e the crossing's height
        fs      $t,$near_5,$first_2                     # 181e
        lqx     $if_enters_3,$a_if_enters,$sides_3      # 181o
        fnms    $ex_4,$row_5,$axis_x_3,$x_3             # 182e
        lqx     $if_leaves_3,$a_if_leaves,$sides_3      # 182o
        fi      $t_y_7,$disc_5,$t_y_5                   # 183e
        fi      $t_y_5,$a,$t_y_6                        # 184e
        fnms    $t_e_4,$q_2,$t_y_4,$k_one               # 186e
        clgt    $off_3,$off_2,$height_2                 # 187e below 0 is above all
        fma     $h_8,$axis_y_3,$wy_7,$h_8               # 188e
        fm      $a_5,$ex_4,$ex_4                        # 189e
        or      $t,$t,$off_3                            # 190e
        fm      $s_3,$disc_5,$t_y_7                     # 191e
        fma     $inverse_q,$t_e_4,$t_y_4,$t_y_4         # 192e
        or      $t,$t,$hidden_2                         # 193e
        fma     $b_5,$cz_3,$ez_3,$b_4                   # 194e
        fnms    $t_e_5,$a,$t_y_5,$k_one                 # 195e
        fnms    $ey_4,$row_5,$axis_y_3,$y_3             # 196e
        fma     $out_4,$cy_3,$cy_3,$out_3               # 197e
        fm      $second_2,$out_2,$inverse_q             # 198e
        fnms    $t_e_6,$s_3,$t_y_7,$k_one               # 199e 1 - s y
        fnms    $ez_4,$row_5,$axis_z_3,$z_3             # 200e
        fma     $inverse_3,$t_e_5,$t_y_5,$t_y_5         # 201e
        fma     $a,$ey_4,$ey_4,$a_5                     # 202e
        fma     $out_5,$cz_3,$cz_3,$out_4               # 203e
        fnms    $off_second_2,$second_2,$row_8,$h_3     # 204e
        fs      $t_second_2,$near_4,$second_2           # 205e
        fma     $t_e,$t_e_6,$k_half,$k_one              # 206e
        fma     $h_9,$axis_z_3,$wz_4,$h_8               # 207e
        fnms    $b_5,$k_3,$m_3,$b_5                     # 208e
        fm      $m,$growth_4,$row_5                     # 209e
        clgt    $off_second_2,$off_second_2,$height_2   # 210e
        fnms    $out_6,$k_3,$k_3,$out_5                 # 211e
        or      $t_second_3,$t_second_2,$off_second_2   # 212e
        fnms    $cz_2,$h_9,$axis_z_3,$wz_4              # 213e
        or      $t_second_3,$t_second_3,$hidden_second_2 # 214e
        selb    $hidden,$if_enters_3,$if_leaves_3,$b_5  # 215e
        clgt    $control,$t,$t_second_3                 # 216e
        selb    $hidden_second,$if_leaves_3,$if_enters_3,$b_5 # 217e
        selb    $t,$t,$t_second_3,$control              # 218e
        fnms    $cx_2,$h_9,$axis_x_3,$wx_6              # 219e
        cgti    $ahead,$t,0                             # 220e
        cgt     $control,$t_best,$t                     # 221e
        fnms    $cy_2,$h_9,$axis_y_3,$wy_7              # 222e
        and     $control,$control,$ahead                # 223e
        fma     $k_4,$growth_4,$h_9,$radius_4           # 224e
        fm      $vx_5,$m,$cx_2                          # 225e
        andc    $control,$control,$disc_6               # 226e
        fm      $b,$cx_2,$ex_4                          # 227e
        fm      $vy_5,$m,$cy_2                          # 228e
        rotqbii $control,$control,1                     # 228o
        fm      $turn_x,$cz_2,$ey_4                     # 229e
        fma     $a,$ez_4,$ez_4,$a                       # 230e
        fm      $turn_z,$cy_2,$ex_4                     # 231e
        lnop                                            # 231o pairing
        selb    $s,$s_3,$b_5,$m_sign                    # 232e
        gb      $control,$control                       # 232o
        fms     $vx_5,$k_4,$ex_4,$vx_5                  # 233e
        hbrr    next_row_back,next_row                  # 233o hint
        fma     $q,$s,$t_e,$b_5                         # 234e
        fm      $turn_y_5,$cx_2,$ez_4                   # 235e
        fnms    $a,$m,$m,$a                             # 236e
        shlqbii $control,$control,4                     # 236o
        fm      $vz,$m,$cz_2                            # 237e
        fms     $vy_6,$k_4,$ey_4,$vy_5                  # 238e
        fm      $first,$q,$inverse_3                    # 240e -s
        lqx     $control,$control,$a_controls           # 240o
        fms     $turn_y_6,$cz_2,$ex_4,$turn_y_5         # 241e
        frest   $t_y_8,$q                               # 241o
        nop     $127                                    # 242e pairing
        frest   $t_y,$a                                 # 242o
next_row:
            fms     $turn_x,$cy_2,$ez_4,$turn_x         # 0e
        lqd     $object,0($a_candidate)                 # 0o
            fms     $vz,$k_4,$ez_4,$vz                  # 1e
            shufb   $nearest,$nearest,$object_8,$control # 1o
            fms     $disc,$vx_5,$vx_5,$k_tiny           # 2e
            shufb   $t_best,$t_best,$t,$control         # 2o
            fi      $t_y,$a,$t_y                        # 3e
            shlqbyi $object_8,$object_3,0               # 3o copy
            fi      $t_y_9,$q,$t_y_8                    # 4e
            shlqbyi $object_3,$object_6,0               # 4o copy
        shli    $row,$a_candidate,2                     # 5e
            stqd    $nearest,448($a_packet_9)           # 5o
            fma     $b,$cy_2,$ey_4,$b                   # 6e
            lqd     $nearest,448($a_packet_7)           # 6o
            fm      $out,$cx_2,$cx_2                    # 7e
            stqd    $t_best,384($a_packet_9)            # 7o
            fma     $disc,$vy_6,$vy_6,$disc             # 8e
            lqd     $t_best,384($a_packet_7)            # 8o
        ai      $a_candidate,$a_candidate,4             # 9e
            shlqbyi $a_packet_9,$a_packet_8,0           # 9o copy
            fnms    $t_e,$a,$t_y,$k_one                 # 10e
            shlqbyi $a_packet_7,$a_packet_6,0           # 10o copy
            fnms    $t_e_4,$q,$t_y_9,$k_one             # 11e
        shufb   $object_6,$object,$object,$m_x          # 11o
            fma     $b,$cz_2,$ez_4,$b                   # 12e
        rotqbyi $a_packet_2,$object,4                   # 12o
        andi    $row,$row,48                            # 13e
        lnop                                            # 13o pairing
            fma     $disc,$vz,$vz,$disc                 # 14e
            shlqbyi $a_packet_8,$a_packet_6,0           # 14o copy
            fma     $out,$cy_2,$cy_2,$out               # 15e
        lqd     $quad_2,0($object_6)                    # 15o
        a       $a_packet_6,$a_packet_2,$row            # 16e
        lqd     $sides,32($object)                      # 16o
            fma     $inverse,$t_e,$t_y,$t_y             # 17e
        lqd     $quad,16($object_6)                     # 17o
            fms     $turn_z,$cx_2,$ey_4,$turn_z         # 18e
        lqd     $wx,0($a_packet_6)                      # 18o
            fnms    $b,$k_4,$m,$b                       # 19e
        lqd     $wy,64($a_packet_6)                     # 19o
            fnms    $disc,$turn_x,$turn_x,$disc         # 20e
        lqd     $x,192($a_packet_6)                     # 20o
            fs      $t,$near_9,$first                   # 21e
        shufb   $base_x_5,$quad_2,$quad_2,$m_x          # 21o
            fma     $out,$cz_2,$cz_2,$out               # 22e
        lqd     $wz,128($a_packet_6)                    # 22o
            fnms    $off,$first,$row_10,$h_7            # 23e the crossing's height
        shufb   $base_y_2,$quad_2,$quad_2,$m_y          # 23o
            fma     $inverse_q,$t_e_4,$t_y_9,$t_y_9     # 24e
        shufb   $base_z_5,$quad_2,$quad_2,$m_z          # 24o
        fs      $wx,$base_x_5,$wx                       # 25e
        shufb   $axis_z,$quad,$quad,$m_z                # 25o
            fnms    $disc,$turn_y_6,$turn_y_6,$disc     # 26e
        shufb   $axis_y,$quad,$quad,$m_y                # 26o
        fs      $wy,$base_y_2,$wy                       # 27e
        fs      $wz,$base_z_5,$wz                       # 28e
            clgt    $off,$off,$height_3                 # 29e below 0 is above all
        lqd     $y,256($a_packet_6)                     # 29o
            fm      $second,$out_6,$inverse_q           # 30e
        shufb   $axis_x,$quad,$quad,$m_x                # 30o
        fm      $near,$wx,$x                            # 31e
        rotqbyi $sides,$sides,12                        # 31o
            or      $t,$t,$off                          # 32e
            shlqbyi $near_9,$near_2,0                   # 32o copy
            fnms    $disc,$turn_z,$turn_z,$disc         # 33e
            lqx     $if_enters,$a_if_enters,$sides_6    # 33o
        fm      $row,$axis_x,$x                         # 34e
            shlqbyi $h_7,$h_9,0                         # 34o copy
            or      $t,$t,$hidden                       # 35e
            lqx     $if_leaves,$a_if_leaves,$sides_6    # 35o
            fnms    $off_second,$second,$row_7,$h_6     # 36e
            shlqbyi $row_10,$row_5,0                    # 36o copy
        fma     $near,$wy,$y,$near                      # 37e
        lqd     $z,320($a_packet_6)                     # 37o
            fs      $t_second,$near_8,$second           # 38e
            shlqbyi $near_8,$near_2,0                   # 38o copy
        rotmi   $sides_6,$sides,-26                     # 39e the two bits to quadwords' addresses
            frsqest $t_y,$disc                          # 39o
        fma     $row,$axis_y,$y,$row                    # 40e
            shlqbyi $row_7,$row_5,0                     # 40o copy
            selb    $hidden,$if_enters,$if_leaves,$b    # 41e
            lnop                                        # 41o pairing
            clgt    $off_second,$off_second,$height_3   # 42e
            shufb   $height_3,$quad_4,$quad_4,$m_z      # 42o
        fma     $near_2,$wz,$z,$near                    # 43e
            fi      $t_y,$disc,$t_y                     # 44e
            or      $t_second,$t_second,$off_second     # 45e
        lqd     $quad_4,48($object_6)                   # 45o
        fma     $row_5,$axis_z,$z,$row                  # 46e
            shlqbyi $h_6,$h_9,0                         # 46o copy
            or      $t_second,$t_second,$hidden_second  # 47e
            selb    $hidden_second,$if_leaves,$if_enters,$b # 48e
        fms     $wx,$near_2,$x,$wx                      # 49e
            clgt    $control,$t,$t_second               # 50e
            fnms    $out_6,$k_4,$k_4,$out               # 51e
        shufb   $radius_5,$quad_4,$quad_4,$m_x          # 51o
        fnms    $ex_5,$row_5,$axis_x,$x                 # 52e
        shufb   $growth_5,$quad_4,$quad_4,$m_y          # 52o
            fm      $s,$disc,$t_y                       # 53e
        fms     $wy,$near_2,$y,$wy                      # 54e
        fm      $h_5,$axis_x,$wx                        # 55e
        fnms    $ey_4,$row_5,$axis_y,$y                 # 56e
        fms     $wz,$near_2,$z,$wz                      # 57e
        fm      $a,$ex_5,$ex_5                          # 58e
            fnms    $t_e,$s,$t_y,$k_one                 # 59e 1 - s y
        fm      $m,$growth_5,$row_5                     # 60e
        fma     $h_5,$axis_y,$wy,$h_5                   # 61e
        fnms    $ez_4,$row_5,$axis_z,$z                 # 62e
            selb    $s,$s,$b,$m_sign                    # 63e
        fma     $a,$ey_4,$ey_4,$a                       # 64e
            selb    $t,$t,$t_second,$control            # 65e
            fma     $t_e,$t_e,$k_half,$k_one            # 66e
            cgt     $control,$t_best,$t                 # 67e
            cgti    $ahead,$t,0                         # 68e
        fma     $h_9,$axis_z,$wz,$h_5                   # 69e
            and     $control,$control,$ahead            # 70e
        fma     $a,$ez_4,$ez_4,$a                       # 71e
        lnop                                            # 71o pairing
            andc    $control,$control,$disc_7           # 72e
            shlqbyi $disc_7,$disc,0                     # 72o copy
            fma     $q,$s,$t_e,$b                       # 73e
            lnop                                        # 73o pairing
        ai      $count,$count,-1                        # 74e
            rotqbii $control,$control,1                 # 74o
        fnms    $cx_2,$h_9,$axis_x,$wx                  # 75e
        fnms    $cy_2,$h_9,$axis_y,$wy                  # 76e
        fnms    $cz_2,$h_9,$axis_z,$wz                  # 77e
        lnop                                            # 77o pairing
        fnms    $a,$m,$m,$a                             # 78e
            gb      $control,$control                   # 78o
            fm      $first,$q,$inverse                  # 79e -s
            frest   $t_y_8,$q                           # 79o
        fma     $k_4,$growth_5,$h_9,$radius_5           # 80e
        fm      $vx_5,$m,$cx_2                          # 81e
        fm      $vy_7,$m,$cy_2                          # 82e
            shlqbii $control,$control,4                 # 82o
        fm      $turn_y_5,$cx_2,$ez_4                   # 83e
        lnop                                            # 83o pairing
        fm      $vz,$m,$cz_2                            # 84e
        frest   $t_y,$a                                 # 84o
        fm      $turn_x,$cz_2,$ey_4                     # 85e
        lnop                                            # 85o pairing
        fm      $turn_z,$cy_2,$ex_5                     # 86e
            lqx     $control,$control,$a_controls       # 86o
        fms     $vx_5,$k_4,$ex_5,$vx_5                  # 87e
        fm      $b,$cx_2,$ex_5                          # 88e
        fms     $turn_y_6,$cz_2,$ex_5,$turn_y_5         # 89e
        lnop                                            # 89o pairing
        fms     $vy_6,$k_4,$ey_4,$vy_7                  # 90e
next_row_back:
        brnz    $count,next_row                         # 90o
next_row_drain:
        fms     $disc,$vx_5,$vx_5,$k_tiny               # 0e
        shufb   $t_best,$t_best,$t,$control             # 0o
        fms     $vz,$k_4,$ez_4,$vz                      # 1e
        shufb   $nearest,$nearest,$object_8,$control    # 1o
        fms     $turn_x,$cy_2,$ez_4,$turn_x             # 2e
        shlqbyi $row_2,$row_5,0                         # 2o copy
        fi      $t_y_9,$q,$t_y_8                        # 3e
        shlqbyi $row_12,$row_5,0                        # 3o copy
        fi      $t_y,$a,$t_y                            # 4e
        shlqbyi $a_packet_10,$a_packet_6,0              # 4o copy
        nop     $127                                    # 5e pairing
        stqd    $nearest,448($a_packet_9)               # 5o
        fma     $disc,$vy_6,$vy_6,$disc                 # 6e
        lqd     $nearest,448($a_packet_7)               # 6o
        fma     $b,$cy_2,$ey_4,$b                       # 7e
        stqd    $t_best,384($a_packet_9)                # 7o
        fms     $turn_z,$cx_2,$ey_4,$turn_z             # 8e
        lqd     $t_best,384($a_packet_7)                # 8o
        fnms    $off,$first,$row_10,$h_7                # 9e the crossing's height
        lqx     $if_leaves,$a_if_leaves,$sides_6        # 9o
        fnms    $t_e_4,$q,$t_y_9,$k_one                 # 10e
        shlqbyi $h_7,$h_9,0                             # 10o copy
        fs      $t,$near_9,$first                       # 11e
        shlqbyi $near_10,$near_2,0                      # 11o copy
        fma     $disc,$vz,$vz,$disc                     # 12e
        shufb   $height_4,$quad_4,$quad_4,$m_z          # 12o
        fma     $b,$cz_2,$ez_4,$b                       # 13e
        shlqbyi $object_3,$object_3,0                   # 13o copy
        fm      $out,$cx_2,$cx_2                        # 14e
        lqx     $if_enters_4,$a_if_enters,$sides_6      # 14o
        clgt    $off,$off,$height_3                     # 15e below 0 is above all
        shlqbyi $h_10,$h_9,0                            # 15o copy
        fma     $inverse_q,$t_e_4,$t_y_9,$t_y_9         # 16e
        shlqbyi $near_9,$near_2,0                       # 16o copy
        or      $t,$t,$off                              # 17e
        shlqbyi $a_packet_11,$a_packet_8,0              # 17o copy
        fnms    $disc,$turn_x,$turn_x,$disc             # 18e
        shlqbyi $a_packet_8,$a_packet_6,0               # 18o copy
        fnms    $b,$k_4,$m,$b                           # 19e
        hbr     isect_cone_pairs_r16_return,$lr         # 19o hint
        fma     $out,$cy_2,$cy_2,$out                   # 20e
        shlqbyi $object_5,$object_6,0                   # 20o copy
        or      $t,$t,$hidden                           # 21e
        lnop                                            # 21o pairing
        fm      $second,$out_6,$inverse_q               # 22e
        shlqbyi $a_packet_12,$a_packet_8,0              # 22o copy
        fnms    $t_e,$a,$t_y,$k_one                     # 23e
        lnop                                            # 23o pairing
        fnms    $disc,$turn_y_6,$turn_y_6,$disc         # 24e
        shlqbyi $object_5,$object_5,0                   # 24o copy
        selb    $hidden,$if_enters_4,$if_leaves,$b      # 25e
        fma     $out,$cz_2,$cz_2,$out                   # 26e
        selb    $hidden_second_3,$if_leaves,$if_enters_4,$b # 27e
        fnms    $off_second,$second,$row_7,$h_6         # 28e
        fs      $t_second,$near_8,$second               # 29e
        fnms    $disc,$turn_z,$turn_z,$disc             # 30e
        fma     $inverse,$t_e,$t_y,$t_y                 # 31e
        fnms    $out_6,$k_4,$k_4,$out                   # 32e
        clgt    $off_second,$off_second,$height_3       # 34e
        lnop                                            # 34o pairing
        or      $t_second,$t_second,$off_second         # 36e
        frsqest $t_y,$disc                              # 36o
        shlqbyi $disc_8,$disc,0                         # 37o copy
        or      $t_second,$t_second,$hidden_second      # 38e
        fi      $t_y,$disc,$t_y                         # 40e
        clgt    $control,$t,$t_second                   # 41e
        selb    $t,$t,$t_second,$control                # 43e
        cgti    $ahead,$t,0                             # 45e
        cgt     $control,$t_best,$t                     # 46e
        fm      $s,$disc,$t_y                           # 47e
        and     $control,$control,$ahead                # 48e
        andc    $control,$control,$disc_7               # 50e
        rotqbii $control,$control,1                     # 52o
        fnms    $t_e,$s,$t_y,$k_one                     # 53e 1 - s y
        selb    $s,$s,$b,$m_sign                        # 54e
        gb      $control,$control                       # 56o
        fma     $t_e,$t_e,$k_half,$k_one                # 59e
        shlqbii $control,$control,4                     # 60o
        lqx     $control,$control,$a_controls           # 64o
        fma     $q,$s,$t_e,$b                           # 65e
        nop     $127                                    # 66e pairing
        shufb   $t_best,$t_best,$t,$control             # 70o
        fm      $first,$q,$inverse                      # 71e -s
        frest   $t_y_8,$q                               # 71o
        shufb   $nearest,$nearest,$object_3,$control    # 72o
        fi      $t_y_10,$q,$t_y_8                       # 75e
        nop     $127                                    # 76e pairing
        stqd    $nearest,448($a_packet_11)              # 76o
        fnms    $off,$first,$row_2,$h_7                 # 77e the crossing's height
        lqd     $nearest,448($a_packet_10)              # 77o
        fs      $t,$near_9,$first                       # 78e
        stqd    $t_best,384($a_packet_11)               # 78o
        lqd     $t_best,384($a_packet_10)               # 79o
        fnms    $t_e_7,$q,$t_y_10,$k_one                # 82e
        clgt    $off,$off,$height_4                     # 83e below 0 is above all
        or      $t,$t,$off                              # 85e
        or      $t,$t,$hidden                           # 87e
        fma     $inverse_q,$t_e_7,$t_y_10,$t_y_10       # 88e
        fm      $second,$out_6,$inverse_q               # 94e
        fnms    $off_second,$second,$row_12,$h_10       # 100e
        fs      $t_second,$near_10,$second              # 101e
        clgt    $off_second,$off_second,$height_4       # 106e
        or      $t_second,$t_second,$off_second         # 108e
        or      $t_second,$t_second,$hidden_second_3    # 110e
        clgt    $control,$t,$t_second                   # 112e
        selb    $t,$t,$t_second,$control                # 114e
        cgt     $control,$t_best,$t                     # 116e
        cgti    $ahead,$t,0                             # 117e
        and     $control,$control,$ahead                # 119e
        andc    $control,$control,$disc_8               # 121e
        rotqbii $control,$control,1                     # 123o
        gb      $control,$control                       # 127o
        shlqbii $control,$control,4                     # 131o
        lqx     $control,$control,$a_controls           # 135o
        shufb   $nearest,$nearest,$object_5,$control    # 141o
        shufb   $t_best,$t_best,$t,$control             # 142o
        stqd    $nearest,448($a_packet_12)              # 145o
        stqd    $t_best,384($a_packet_12)               # 146o
        nop     $127                                    # 147e pairing
isect_cone_pairs_r16_return:
        bi      $lr                                     # 147o
next_row_short:
        shli    $row,$a_candidate,2                     # 0e
        lqd     $object,0($a_candidate)                 # 0o
        ai      $count,$count,-1                        # 1e
        ai      $a_candidate,$a_candidate,4             # 2e
        andi    $row,$row,48                            # 4e
        shufb   $object_8,$object,$object,$m_x          # 6o
        rotqbyi $a_packet,$object,4                     # 7o
        lqd     $sides,32($object)                      # 8o
        nop     $127                                    # 9e pairing
        lqd     $quad,0($object_8)                      # 10o
        a       $a_packet,$a_packet,$row                # 11e
        lqd     $quad_10,16($object_8)                  # 11o
        lqd     $quad_11,48($object_8)                  # 12o
        lqd     $wx,0($a_packet)                        # 13o
        lqd     $x,192($a_packet)                       # 14o
        lqd     $wy,64($a_packet)                       # 15o
        shufb   $base_x,$quad,$quad,$m_x                # 16o
        shufb   $base_y,$quad,$quad,$m_y                # 17o
        lqd     $y,256($a_packet)                       # 18o
        lqd     $wz,128($a_packet)                      # 19o
        fs      $wx,$base_x,$wx                         # 20e
        shufb   $base_z,$quad,$quad,$m_z                # 20o
        fs      $wy,$base_y,$wy                         # 21e
        lqd     $z,320($a_packet)                       # 21o
        shufb   $axis_x,$quad_10,$quad_10,$m_x          # 22o
        shufb   $axis_y,$quad_10,$quad_10,$m_y          # 23o
        nop     $127                                    # 24e pairing
        shufb   $axis_z,$quad_10,$quad_10,$m_z          # 24o
        fs      $wz,$base_z,$wz                         # 25e
        shufb   $growth,$quad_11,$quad_11,$m_y          # 25o
        fm      $near,$wx,$x                            # 26e
        shufb   $radius,$quad_11,$quad_11,$m_x          # 26o
        fm      $row,$axis_x,$x                         # 27e
        rotqbyi $sides,$sides,12                        # 27o
        shufb   $height,$quad_11,$quad_11,$m_z          # 28o
        lqd     $t_best,384($a_packet)                  # 29o
        lqd     $nearest,448($a_packet)                 # 30o
        rotmi   $sides,$sides,-26                       # 31e the two bits to quadwords' addresses
        fma     $near,$wy,$y,$near                      # 32e
        fma     $row,$axis_y,$y,$row                    # 33e
        lqx     $if_enters,$a_if_enters,$sides          # 35o
        lqx     $if_leaves,$a_if_leaves,$sides          # 36o
        fma     $near,$wz,$z,$near                      # 38e
        fma     $row,$axis_z,$z,$row                    # 39e
        fms     $wx,$near,$x,$wx                        # 44e
        fms     $wy,$near,$y,$wy                        # 45e
        fms     $wz,$near,$z,$wz                        # 46e
        fm      $m,$growth,$row                         # 47e
        fnms    $ex,$row,$axis_x,$x                     # 48e
        fnms    $ey,$row,$axis_y,$y                     # 49e
        fm      $h,$axis_x,$wx                          # 50e
        fnms    $ez,$row,$axis_z,$z                     # 51e
        fm      $a,$ex,$ex                              # 54e
        fma     $h,$axis_y,$wy,$h                       # 56e
        fma     $a,$ey,$ey,$a                           # 60e
        fma     $h,$axis_z,$wz,$h                       # 62e
        fma     $a,$ez,$ez,$a                           # 66e
        fnms    $cx,$h,$axis_x,$wx                      # 68e
        fnms    $cy,$h,$axis_y,$wy                      # 69e
        fma     $k,$growth,$h,$radius                   # 70e
        fnms    $cz,$h,$axis_z,$wz                      # 71e
        fnms    $a,$m,$m,$a                             # 72e
        fm      $vx,$m,$cx                              # 74e
        fm      $vy,$m,$cy                              # 75e
        fm      $turn_y,$cx,$ez                         # 76e
        fm      $vz,$m,$cz                              # 77e
        fm      $turn_x,$cz,$ey                         # 78e
        frest   $t_y,$a                                 # 78o
        fm      $turn_z,$cy,$ex                         # 79e
        fms     $vx,$k,$ex,$vx                          # 80e
        fms     $vy,$k,$ey,$vy                          # 81e
        fms     $turn_y,$cz,$ex,$turn_y                 # 82e
        fms     $vz,$k,$ez,$vz                          # 83e
        fms     $turn_x,$cy,$ez,$turn_x                 # 84e
        fms     $turn_z,$cx,$ey,$turn_z                 # 85e
        fms     $disc,$vx,$vx,$k_tiny                   # 86e
        fm      $b,$cx,$ex                              # 87e
        fm      $out,$cx,$cx                            # 88e
        fi      $t_y,$a,$t_y                            # 89e
        fma     $disc,$vy,$vy,$disc                     # 92e
        fma     $b,$cy,$ey,$b                           # 93e
        fma     $out,$cy,$cy,$out                       # 94e
        fnms    $t_e,$a,$t_y,$k_one                     # 96e
        fma     $disc,$vz,$vz,$disc                     # 98e
        fma     $b,$cz,$ez,$b                           # 99e
        fma     $out,$cz,$cz,$out                       # 100e
        fma     $inverse,$t_e,$t_y,$t_y                 # 102e
        fnms    $disc,$turn_x,$turn_x,$disc             # 104e
        fnms    $b,$k,$m,$b                             # 105e
        fnms    $out,$k,$k,$out                         # 106e
        fnms    $disc,$turn_y,$turn_y,$disc             # 110e
        selb    $hidden,$if_enters,$if_leaves,$b        # 111e
        selb    $hidden_second,$if_leaves,$if_enters,$b # 112e
        fnms    $disc,$turn_z,$turn_z,$disc             # 116e
        frsqest $t_y,$disc                              # 122o
        fi      $t_y,$disc,$t_y                         # 126e
        fm      $s,$disc,$t_y                           # 133e
        fnms    $t_e,$s,$t_y,$k_one                     # 139e 1 - s y
        selb    $s,$s,$b,$m_sign                        # 140e
        fma     $t_e,$t_e,$k_half,$k_one                # 145e
        fma     $q,$s,$t_e,$b                           # 151e
        lnop                                            # 151o pairing
        fm      $first,$q,$inverse                      # 157e -s
        frest   $t_y,$q                                 # 157o
        fi      $t_y,$q,$t_y                            # 161e
        fnms    $off,$first,$row,$h                     # 163e the crossing's height
        fs      $t,$near,$first                         # 164e
        fnms    $t_e,$q,$t_y,$k_one                     # 168e
        clgt    $off,$off,$height                       # 169e below 0 is above all
        or      $t,$t,$off                              # 171e
        or      $t,$t,$hidden                           # 173e
        fma     $inverse_q,$t_e,$t_y,$t_y               # 174e
        fm      $second,$out,$inverse_q                 # 180e
        fnms    $off_second,$second,$row,$h             # 186e
        fs      $t_second,$near,$second                 # 187e
        clgt    $off_second,$off_second,$height         # 192e
        or      $t_second,$t_second,$off_second         # 194e
        or      $t_second,$t_second,$hidden_second      # 196e
        clgt    $control,$t,$t_second                   # 198e
        selb    $t,$t,$t_second,$control                # 200e
        cgti    $ahead,$t,0                             # 202e
        cgt     $control,$t_best,$t                     # 203e
        and     $control,$control,$ahead                # 205e
        andc    $control,$control,$disc                 # 207e
        rotqbii $control,$control,1                     # 209o
        gb      $control,$control                       # 213o
        shlqbii $control,$control,4                     # 217o
        lqx     $control,$control,$a_controls           # 221o
        shufb   $t_best,$t_best,$t,$control             # 227o
        shufb   $nearest,$nearest,$object_8,$control    # 228o
        stqd    $t_best,384($a_packet)                  # 231o
        stqd    $nearest,448($a_packet)                 # 232o
        nop     $127                                    # 233e pairing
        brnz    $count,next_row_short                   # 233o
        nop     $127                                    # 234e pairing
        bi      $lr                                     # 234o
endfunction isect_cone_pairs_r16
