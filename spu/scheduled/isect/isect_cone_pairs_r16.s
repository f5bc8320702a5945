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
        .set count_2,79; .set object_2,21; .set a_packet_2,22; .set quad_2,24; .set a_packet_3,25
        .set quad_3,48; .set base_x_2,20; .set base_y_2,26; .set base_z_2,5; .set growth_2,20
        .set radius_2,5; .set object_3,6; .set a_packet_4,8; .set sides_2,44; .set a_packet_5,23
        .set height_2,46; .set object_4,2; .set a_packet_6,7; .set near_2,47; .set row_2,49
        .set near_3,42; .set near_4,29; .set row_3,45; .set ex_2,9; .set row_4,31; .set ez_2,24
        .set h_2,22; .set ey_2,34; .set h_3,56; .set cx_2,26; .set h_4,50; .set cz_2,28
        .set h_5,30; .set cy_2,27; .set k_2,59; .set vx_2,5; .set turn_y_2,32; .set vy_2,20
        .set turn_y_3,36; .set vy_3,9; .set out_2,33; .set disc_2,58; .set t_y_2,22; .set t_y_3,5
        .set t_e_2,9; .set row_5,2; .set row_6,3; .set a_packet_7,4; .set near_5,7; .set height_3,8
        .set if_enters_2,10; .set h_6,11; .set a_packet_8,5; .set object_5,9; .set a_packet_9,12
        .set hidden_second_2,10; .set disc_3,15; .set t_y_4,6; .set t_e_3,2; .set quad_4,5
        .set quad_5,6
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
        andi    $row,$row,48                            # 20e
        ai      $count,$count,-1                        # 21e
        nop     $127                                    # 22e pairing
        shufb   $object_2,$object,$object,$m_x          # 22o
        ai      $count,$count,-1                        # 23e
        rotqbyi $a_packet_2,$object,4                   # 23o
        lqd     $sides,32($object)                      # 24o
        lqd     $quad_2,0($object_2)                    # 26o
        a       $a_packet_3,$a_packet_2,$row            # 27e
        lqd     $quad,16($object_2)                     # 27o
        lqd     $quad_3,48($object_2)                   # 28o
        lqd     $wx,0($a_packet_3)                      # 29o
        lqd     $wy,64($a_packet_3)                     # 30o
        lqd     $x,192($a_packet_3)                     # 31o
        shufb   $base_x_2,$quad_2,$quad_2,$m_x          # 32o
        shufb   $base_y_2,$quad_2,$quad_2,$m_y          # 33o
        lqd     $wz,128($a_packet_3)                    # 34o
        lqd     $y,256($a_packet_3)                     # 35o
        fs      $wx,$base_x_2,$wx                       # 36e
        shufb   $base_z_2,$quad_2,$quad_2,$m_z          # 36o
        fs      $wy,$base_y_2,$wy                       # 37e
        lqd     $z,320($a_packet_3)                     # 37o
        shufb   $axis_x,$quad,$quad,$m_x                # 38o
        shufb   $axis_y,$quad,$quad,$m_y                # 39o
        fs      $wz,$base_z_2,$wz                       # 40e
        shufb   $axis_z,$quad,$quad,$m_z                # 40o
        nop     $127                                    # 41e pairing
        shufb   $growth_2,$quad_3,$quad_3,$m_y          # 41o
        fm      $near,$wx,$x                            # 42e
        rotqbyi $sides,$sides,12                        # 42o
        fm      $row,$axis_x,$x                         # 43e
        shufb   $radius_2,$quad_3,$quad_3,$m_x          # 43o
        shlqbyi $object_3,$object_2,0                   # 44o copy
        shlqbyi $a_packet_4,$a_packet_3,0               # 45o copy
        rotmi   $sides_2,$sides,-26                     # 46e the two bits to quadwords' addresses
        shlqbyi $a_packet_5,$a_packet_3,0               # 46o copy
        nop     $127                                    # 47e pairing
        shufb   $height_2,$quad_3,$quad_3,$m_z          # 47o
        fma     $near,$wy,$y,$near                      # 48e
        shlqbyi $object_4,$object_3,0                   # 48o copy
        fma     $row,$axis_y,$y,$row                    # 49e
        lqd     $t_best,384($a_packet_4)                # 49o
        lqx     $if_enters,$a_if_enters,$sides_2        # 50o
        shlqbyi $a_packet_6,$a_packet_5,0               # 51o copy
        lqd     $nearest,448($a_packet_4)               # 52o
        fma     $near_2,$wz,$z,$near                    # 54e
        fma     $row_2,$axis_z,$z,$row                  # 55e
        shli    $row,$a_candidate,2                     # 56e
        fms     $wx,$near_2,$x,$wx                      # 60e
        shlqbyi $near_3,$near_2,0                       # 60o copy
        fms     $wy,$near_2,$y,$wy                      # 61e
        shlqbyi $near_4,$near_2,0                       # 61o copy
        fms     $wz,$near_2,$z,$wz                      # 62e
        shlqbyi $row_3,$row_2,0                         # 62o copy
        fnms    $ex_2,$row_2,$axis_x,$x                 # 63e
        shlqbyi $row_4,$row_2,0                         # 63o copy
        fm      $m,$growth_2,$row_2                     # 64e
        fnms    $ez_2,$row_2,$axis_z,$z                 # 65e
        fm      $h_2,$axis_x,$wx                        # 66e
        fnms    $ey_2,$row_2,$axis_y,$y                 # 67e
        andi    $row,$row,48                            # 68e
        fm      $a,$ex_2,$ex_2                          # 69e
        fma     $h_2,$axis_y,$wy,$h_2                   # 72e
        fma     $a,$ey_2,$ey_2,$a                       # 75e
        fma     $h_3,$axis_z,$wz,$h_2                   # 78e
        fma     $a,$ez_2,$ez_2,$a                       # 81e
        fnms    $cx_2,$h_3,$axis_x,$wx                  # 84e
        shlqbyi $h_4,$h_3,0                             # 84o copy
        fnms    $cz_2,$h_3,$axis_z,$wz                  # 85e
        shlqbyi $h_5,$h_3,0                             # 85o copy
        fnms    $cy_2,$h_3,$axis_y,$wy                  # 86e
        fma     $k_2,$growth_2,$h_3,$radius_2           # 87e
        fnms    $a,$m,$m,$a                             # 88e
        fm      $vx_2,$m,$cx_2                          # 90e
        fm      $turn_y_2,$cx_2,$ez_2                   # 91e
        fm      $vy_2,$m,$cy_2                          # 92e
        fm      $turn_z,$cy_2,$ex_2                     # 93e
        lnop                                            # 93o pairing
        fm      $turn_x,$cz_2,$ey_2                     # 94e
        frest   $t_y,$a                                 # 94o
        fm      $b,$cx_2,$ex_2                          # 95e
        fms     $vx_2,$k_2,$ex_2,$vx_2                  # 96e
        fms     $turn_y_3,$cz_2,$ex_2,$turn_y_2         # 97e
        lnop                                            # 97o pairing
        fms     $vy_3,$k_2,$ey_2,$vy_2                  # 98e
        lqd     $object,0($a_candidate)                 # 98o
        fm      $vz,$m,$cz_2                            # 99e
        fms     $turn_x,$cy_2,$ez_2,$turn_x             # 100e
        fma     $b,$cy_2,$ey_2,$b                       # 101e
        fms     $disc,$vx_2,$vx_2,$k_tiny               # 102e
        fms     $turn_z,$cx_2,$ey_2,$turn_z             # 103e
        lqx     $if_leaves,$a_if_leaves,$sides_2        # 103o
        fm      $out,$cx_2,$cx_2                        # 104e
        rotqbyi $a_packet_2,$object,4                   # 104o
        fms     $vz,$k_2,$ez_2,$vz                      # 105e
        shufb   $object_2,$object,$object,$m_x          # 105o
        fi      $t_y,$a,$t_y                            # 106e
        lqd     $sides,32($object)                      # 106o
        ai      $a_candidate,$a_candidate,4             # 107e
        fma     $disc,$vy_3,$vy_3,$disc                 # 108e
        fma     $b,$cz_2,$ez_2,$b                       # 109e
        lqd     $quad_2,0($object_2)                    # 109o
        a       $a_packet_3,$a_packet_2,$row            # 110e
        lqd     $quad,16($object_2)                     # 110o
        fma     $out,$cy_2,$cy_2,$out                   # 111e
        lqd     $quad_3,48($object_2)                   # 111o
        nop     $127                                    # 112e pairing
        lqd     $wx,0($a_packet_3)                      # 112o
        fnms    $t_e,$a,$t_y,$k_one                     # 113e
        lqd     $x,192($a_packet_3)                     # 113o
        fma     $disc,$vz,$vz,$disc                     # 114e
        lqd     $wy,64($a_packet_3)                     # 114o
        fnms    $b,$k_2,$m,$b                           # 115e
        shufb   $base_x_2,$quad_2,$quad_2,$m_x          # 115o
        nop     $127                                    # 116e pairing
        shufb   $base_y_2,$quad_2,$quad_2,$m_y          # 116o
        fma     $out,$cz_2,$cz_2,$out                   # 117e
        lqd     $wz,128($a_packet_3)                    # 117o
        nop     $127                                    # 118e pairing
        shufb   $base_z_2,$quad_2,$quad_2,$m_z          # 118o
        fs      $wx,$base_x_2,$wx                       # 119e
        lqd     $z,320($a_packet_3)                     # 119o
        fnms    $disc,$turn_x,$turn_x,$disc             # 120e
        shufb   $axis_z,$quad,$quad,$m_z                # 120o
        fs      $wy,$base_y_2,$wy                       # 121e
        shufb   $axis_x,$quad,$quad,$m_x                # 121o
        fma     $inverse,$t_e,$t_y,$t_y                 # 122e
        shufb   $axis_y,$quad,$quad,$m_y                # 122o
        fs      $wz,$base_z_2,$wz                       # 123e
        shufb   $growth_2,$quad_3,$quad_3,$m_y          # 123o
        selb    $hidden,$if_enters,$if_leaves,$b        # 124e
        shufb   $radius_2,$quad_3,$quad_3,$m_x          # 124o
        fm      $near,$wx,$x                            # 125e
        rotqbyi $sides,$sides,12                        # 125o
        fnms    $disc,$turn_y_3,$turn_y_3,$disc         # 126e
        lqd     $y,256($a_packet_3)                     # 126o
        fm      $row,$axis_x,$x                         # 127e
        shlqbyi $object_3,$object_2,0                   # 127o copy
        selb    $hidden_second,$if_leaves,$if_enters,$b # 128e
        shlqbyi $a_packet_4,$a_packet_3,0               # 128o copy
        fnms    $out_2,$k_2,$k_2,$out                   # 129e
        shlqbyi $a_packet_5,$a_packet_3,0               # 129o copy
        rotmi   $sides_2,$sides,-26                     # 130e the two bits to quadwords' addresses
        fma     $near,$wy,$y,$near                      # 132e
        fnms    $disc,$turn_z,$turn_z,$disc             # 133e
        fma     $row,$axis_y,$y,$row                    # 134e
        fma     $near_2,$wz,$z,$near                    # 138e
        frsqest $t_y,$disc                              # 139o
        fma     $row_2,$axis_z,$z,$row                  # 140e
        shlqbyi $disc_2,$disc,0                         # 140o copy
        shli    $row,$a_candidate,2                     # 141e
        fi      $t_y,$disc,$t_y                         # 143e
        fms     $wx,$near_2,$x,$wx                      # 145e
        fms     $wz,$near_2,$z,$wz                      # 146e
        fms     $wy,$near_2,$y,$wy                      # 147e
        fnms    $ex_2,$row_2,$axis_x,$x                 # 148e
        fnms    $ey_2,$row_2,$axis_y,$y                 # 149e
        fm      $s,$disc,$t_y                           # 150e
        fm      $h_2,$axis_x,$wx                        # 151e
        fm      $m,$growth_2,$row_2                     # 152e
        fnms    $ez_2,$row_2,$axis_z,$z                 # 153e
        fm      $a,$ex_2,$ex_2                          # 154e
        andi    $row,$row,48                            # 155e
        fnms    $t_e,$s,$t_y,$k_one                     # 156e 1 - s y
        fma     $h_2,$axis_y,$wy,$h_2                   # 157e
        selb    $s,$s,$b,$m_sign                        # 158e
        fma     $a,$ey_2,$ey_2,$a                       # 160e
        fma     $t_e,$t_e,$k_half,$k_one                # 162e
        fma     $h_3,$axis_z,$wz,$h_2                   # 163e
        fma     $a,$ez_2,$ez_2,$a                       # 166e
        fma     $q,$s,$t_e,$b                           # 168e
        fnms    $cx_2,$h_3,$axis_x,$wx                  # 169e
        fnms    $cz_2,$h_3,$axis_z,$wz                  # 170e
        fma     $k_2,$growth_2,$h_3,$radius_2           # 171e
        fnms    $cy_2,$h_3,$axis_y,$wy                  # 172e
        fnms    $a,$m,$m,$a                             # 173e
        fm      $first,$q,$inverse                      # 174e -s
        frest   $t_y_2,$q                               # 174o
        fm      $vx_2,$m,$cx_2                          # 175e
        fm      $turn_y_2,$cx_2,$ez_2                   # 176e
        fm      $b,$cx_2,$ex_2                          # 177e
        fm      $vy_2,$m,$cy_2                          # 178e
        fm      $turn_z,$cy_2,$ex_2                     # 179e
        frest   $t_y,$a                                 # 179o
        fm      $vz,$m,$cz_2                            # 180e
        fms     $vx_2,$k_2,$ex_2,$vx_2                  # 181e
        fms     $turn_y_3,$cz_2,$ex_2,$turn_y_2         # 182e
        fma     $b,$cy_2,$ey_2,$b                       # 183e
        fms     $vy_3,$k_2,$ey_2,$vy_2                  # 184e
        lqd     $object,0($a_candidate)                 # 184o
        fm      $turn_x,$cz_2,$ey_2                     # 185e
        fms     $vz,$k_2,$ez_2,$vz                      # 186e
        fms     $disc,$vx_2,$vx_2,$k_tiny               # 187e
        fi      $t_y_3,$q,$t_y_2                        # 188e
        fi      $t_y,$a,$t_y                            # 189e
        lnop                                            # 189o pairing
        ai      $a_candidate,$a_candidate,4             # 190e
        shufb   $object_2,$object,$object,$m_x          # 190o
        fma     $b,$cz_2,$ez_2,$b                       # 191e
        rotqbyi $a_packet_2,$object,4                   # 191o
        fms     $turn_x,$cy_2,$ez_2,$turn_x             # 192e
        lqd     $sides,32($object)                      # 192o
        fma     $disc,$vy_3,$vy_3,$disc                 # 193e
        lnop                                            # 193o pairing
        fm      $out,$cx_2,$cx_2                        # 194e
        lqd     $quad_2,0($object_2)                    # 194o
        a       $a_packet_3,$a_packet_2,$row            # 195e
        lqd     $quad,16($object_2)                     # 195o
        fnms    $t_e_2,$q,$t_y_3,$k_one                 # 196e
        lnop                                            # 196o pairing
        fms     $turn_z,$cx_2,$ey_2,$turn_z             # 197e
        lqd     $wx,0($a_packet_3)                      # 197o
        fs      $t,$near_4,$first                       # 198e
        lqd     $x,192($a_packet_3)                     # 198o
        fma     $disc,$vz,$vz,$disc                     # 199e
        lqd     $wy,64($a_packet_3)                     # 199o
        fma     $out,$cy_2,$cy_2,$out                   # 200e
        shufb   $base_x_2,$quad_2,$quad_2,$m_x          # 200o
        fnms    $t_e,$a,$t_y,$k_one                     # 201e
        shufb   $base_y_2,$quad_2,$quad_2,$m_y          # 201o
        fma     $inverse_q,$t_e_2,$t_y_3,$t_y_3         # 202e
        lqd     $wz,128($a_packet_3)                    # 202o
        fnms    $off,$first,$row_4,$h_5                 # 203e the crossing's height
        lqd     $z,320($a_packet_3)                     # 203o
        fs      $wx,$base_x_2,$wx                       # 204e
        shufb   $base_z_2,$quad_2,$quad_2,$m_z          # 204o
        fnms    $disc,$turn_x,$turn_x,$disc             # 205e
        shufb   $axis_y,$quad,$quad,$m_y                # 205o
        fs      $wy,$base_y_2,$wy                       # 206e
        shufb   $axis_x,$quad,$quad,$m_x                # 206o
        fma     $out,$cz_2,$cz_2,$out                   # 207e
        shlqbyi $near_4,$near_2,0                       # 207o copy
        fm      $second,$out_2,$inverse_q               # 208e
        shufb   $axis_z,$quad,$quad,$m_z                # 208o
        fs      $wz,$base_z_2,$wz                       # 209e
        shlqbyi $row_4,$row_2,0                         # 209o copy
        fm      $near,$wx,$x                            # 210e
        lqx     $if_leaves,$a_if_leaves,$sides_2        # 210o
        fnms    $disc,$turn_y_3,$turn_y_3,$disc         # 211e
        lqd     $y,256($a_packet_3)                     # 211o
        fm      $row,$axis_x,$x                         # 212e
        lqx     $if_enters,$a_if_enters,$sides_2        # 212o
        fma     $inverse,$t_e,$t_y,$t_y                 # 213e
        shlqbyi $h_5,$h_3,0                             # 213o copy
        fs      $t_second,$near_3,$second               # 214e
        shlqbyi $near_3,$near_2,0                       # 214o copy
        fnms    $off_second,$second,$row_3,$h_4         # 215e
        shlqbyi $row_3,$row_2,0                         # 215o copy
        clgt    $off,$off,$height_2                     # 216e below 0 is above all
        shlqbyi $h_4,$h_3,0                             # 216o copy
        fma     $near,$wy,$y,$near                      # 217e
        rotqbyi $sides,$sides,12                        # 217o
        fma     $row,$axis_y,$y,$row                    # 218e
        fnms    $disc,$turn_z,$turn_z,$disc             # 219e
        or      $t,$t,$off                              # 220e
        fnms    $b,$k_2,$m,$b                           # 221e
        clgt    $off_second,$off_second,$height_2       # 222e
        shufb   $height_2,$quad_3,$quad_3,$m_z          # 222o
        fma     $near_2,$wz,$z,$near                    # 223e
        lqd     $quad_3,48($object_2)                   # 223o
        fma     $row_2,$axis_z,$z,$row                  # 224e
        lnop                                            # 224o pairing
        or      $t_second,$t_second,$off_second         # 225e
        frsqest $t_y,$disc                              # 225o
        or      $t,$t,$hidden                           # 226e
        selb    $hidden,$if_enters,$if_leaves,$b        # 227e
        or      $t_second,$t_second,$hidden_second      # 228e
        lnop                                            # 228o pairing
        fms     $wx,$near_2,$x,$wx                      # 229e
        shufb   $growth_2,$quad_3,$quad_3,$m_y          # 229o
        fms     $wy,$near_2,$y,$wy                      # 230e
        shufb   $radius_2,$quad_3,$quad_3,$m_x          # 230o
        fi      $t_y,$disc,$t_y                         # 231e
        clgt    $control,$t,$t_second                   # 232e
        fnms    $ex_2,$row_2,$axis_x,$x                 # 233e
        selb    $hidden_second,$if_leaves,$if_enters,$b # 234e
        fm      $h_2,$axis_x,$wx                        # 235e
        fnms    $ey_2,$row_2,$axis_y,$y                 # 236e
        fms     $wz,$near_2,$z,$wz                      # 237e
        fm      $s,$disc,$t_y                           # 238e
        fm      $a,$ex_2,$ex_2                          # 239e
        fnms    $ez_2,$row_2,$axis_z,$z                 # 240e
        fma     $h_2,$axis_y,$wy,$h_2                   # 241e
        selb    $t,$t,$t_second,$control                # 242e
        fnms    $out_2,$k_2,$k_2,$out                   # 243e
        cgt     $control,$t_best,$t                     # 244e
        fma     $a,$ey_2,$ey_2,$a                       # 245e
        cgti    $ahead,$t,0                             # 246e
        fma     $h_3,$axis_z,$wz,$h_2                   # 247e
        and     $control,$control,$ahead                # 248e
        fnms    $t_e,$s,$t_y,$k_one                     # 249e 1 - s y
        selb    $s,$s,$b,$m_sign                        # 250e
        fma     $a,$ez_2,$ez_2,$a                       # 251e
        lnop                                            # 251o pairing
        andc    $control,$control,$disc_2               # 252e
        shlqbyi $disc_2,$disc,0                         # 252o copy
        fnms    $cx_2,$h_3,$axis_x,$wx                  # 253e
        lnop                                            # 253o pairing
        fma     $k_2,$growth_2,$h_3,$radius_2           # 254e
        rotqbii $control,$control,1                     # 254o
        fma     $t_e,$t_e,$k_half,$k_one                # 255e
        fm      $m,$growth_2,$row_2                     # 256e
        fnms    $cy_2,$h_3,$axis_y,$wy                  # 257e
        lnop                                            # 257o pairing
        rotmi   $sides_2,$sides,-26                     # 258e the two bits to quadwords' addresses
        hbrr    next_row_back,next_row                  # 258o hint
        fnms    $cz_2,$h_3,$axis_z,$wz                  # 259e
        gb      $control,$control                       # 259o
        fm      $turn_y_2,$cx_2,$ez_2                   # 260e
        fma     $q,$s,$t_e,$b                           # 261e
        fnms    $a,$m,$m,$a                             # 262e
        lnop                                            # 262o pairing
        fm      $vy_2,$m,$cy_2                          # 263e
        shlqbii $control,$control,4                     # 263o
        fm      $vx_2,$m,$cx_2                          # 264e
        fm      $turn_x,$cz_2,$ey_2                     # 265e
        fms     $turn_y_3,$cz_2,$ex_2,$turn_y_2         # 266e
        lnop                                            # 266o pairing
        fm      $first,$q,$inverse                      # 267e -s
        lqx     $control,$control,$a_controls           # 267o
        fm      $b,$cx_2,$ex_2                          # 268e
        frest   $t_y_2,$q                               # 268o
        fm      $turn_z,$cy_2,$ex_2                     # 269e
        frest   $t_y,$a                                 # 269o
        fms     $vx_2,$k_2,$ex_2,$vx_2                  # 270e
        fm      $vz,$m,$cz_2                            # 271e
        fms     $vy_3,$k_2,$ey_2,$vy_2                  # 272e
        lnop                                            # 272o pairing
next_row:
            fms     $turn_x,$cy_2,$ez_2,$turn_x         # 0e
        lqd     $object,0($a_candidate)                 # 0o
            fms     $vz,$k_2,$ez_2,$vz                  # 1e
            shufb   $nearest,$nearest,$object_4,$control # 1o
            fms     $disc,$vx_2,$vx_2,$k_tiny           # 2e
            shufb   $t_best,$t_best,$t,$control         # 2o
            fi      $t_y,$a,$t_y                        # 3e
            shlqbyi $object_4,$object_3,0               # 3o copy
            fi      $t_y_3,$q,$t_y_2                    # 4e
            shlqbyi $object_3,$object_2,0               # 4o copy
        shli    $row,$a_candidate,2                     # 5e
            stqd    $nearest,448($a_packet_6)           # 5o
            fma     $b,$cy_2,$ey_2,$b                   # 6e
            lqd     $nearest,448($a_packet_4)           # 6o
            fm      $out,$cx_2,$cx_2                    # 7e
            stqd    $t_best,384($a_packet_6)            # 7o
            fma     $disc,$vy_3,$vy_3,$disc             # 8e
            lqd     $t_best,384($a_packet_4)            # 8o
        ai      $a_candidate,$a_candidate,4             # 9e
            shlqbyi $a_packet_6,$a_packet_5,0           # 9o copy
            fnms    $t_e,$a,$t_y,$k_one                 # 10e
            shlqbyi $a_packet_4,$a_packet_3,0           # 10o copy
            fnms    $t_e_2,$q,$t_y_3,$k_one             # 11e
        shufb   $object_2,$object,$object,$m_x          # 11o
            fma     $b,$cz_2,$ez_2,$b                   # 12e
        rotqbyi $a_packet_2,$object,4                   # 12o
        andi    $row,$row,48                            # 13e
        lnop                                            # 13o pairing
            fma     $disc,$vz,$vz,$disc                 # 14e
            shlqbyi $a_packet_5,$a_packet_3,0           # 14o copy
            fma     $out,$cy_2,$cy_2,$out               # 15e
        lqd     $quad_2,0($object_2)                    # 15o
        a       $a_packet_3,$a_packet_2,$row            # 16e
        lqd     $sides,32($object)                      # 16o
            fma     $inverse,$t_e,$t_y,$t_y             # 17e
        lqd     $quad,16($object_2)                     # 17o
            fms     $turn_z,$cx_2,$ey_2,$turn_z         # 18e
        lqd     $wx,0($a_packet_3)                      # 18o
            fnms    $b,$k_2,$m,$b                       # 19e
        lqd     $wy,64($a_packet_3)                     # 19o
            fnms    $disc,$turn_x,$turn_x,$disc         # 20e
        lqd     $x,192($a_packet_3)                     # 20o
            fs      $t,$near_4,$first                   # 21e
        shufb   $base_x_2,$quad_2,$quad_2,$m_x          # 21o
            fma     $out,$cz_2,$cz_2,$out               # 22e
        lqd     $wz,128($a_packet_3)                    # 22o
            fnms    $off,$first,$row_4,$h_5             # 23e the crossing's height
        shufb   $base_y_2,$quad_2,$quad_2,$m_y          # 23o
            fma     $inverse_q,$t_e_2,$t_y_3,$t_y_3     # 24e
        shufb   $base_z_2,$quad_2,$quad_2,$m_z          # 24o
        fs      $wx,$base_x_2,$wx                       # 25e
        shufb   $axis_z,$quad,$quad,$m_z                # 25o
            fnms    $disc,$turn_y_3,$turn_y_3,$disc     # 26e
        shufb   $axis_y,$quad,$quad,$m_y                # 26o
        fs      $wy,$base_y_2,$wy                       # 27e
        fs      $wz,$base_z_2,$wz                       # 28e
            clgt    $off,$off,$height_2                 # 29e below 0 is above all
        lqd     $y,256($a_packet_3)                     # 29o
            fm      $second,$out_2,$inverse_q           # 30e
        shufb   $axis_x,$quad,$quad,$m_x                # 30o
        fm      $near,$wx,$x                            # 31e
        rotqbyi $sides,$sides,12                        # 31o
            or      $t,$t,$off                          # 32e
            shlqbyi $near_4,$near_2,0                   # 32o copy
            fnms    $disc,$turn_z,$turn_z,$disc         # 33e
            lqx     $if_enters,$a_if_enters,$sides_2    # 33o
        fm      $row,$axis_x,$x                         # 34e
            shlqbyi $h_5,$h_3,0                         # 34o copy
            or      $t,$t,$hidden                       # 35e
            lqx     $if_leaves,$a_if_leaves,$sides_2    # 35o
            fnms    $off_second,$second,$row_3,$h_4     # 36e
            shlqbyi $row_4,$row_2,0                     # 36o copy
        fma     $near,$wy,$y,$near                      # 37e
        lqd     $z,320($a_packet_3)                     # 37o
            fs      $t_second,$near_3,$second           # 38e
            shlqbyi $near_3,$near_2,0                   # 38o copy
        rotmi   $sides_2,$sides,-26                     # 39e the two bits to quadwords' addresses
            frsqest $t_y,$disc                          # 39o
        fma     $row,$axis_y,$y,$row                    # 40e
            shlqbyi $row_3,$row_2,0                     # 40o copy
            selb    $hidden,$if_enters,$if_leaves,$b    # 41e
            lnop                                        # 41o pairing
            clgt    $off_second,$off_second,$height_2   # 42e
            shufb   $height_2,$quad_3,$quad_3,$m_z      # 42o
        fma     $near_2,$wz,$z,$near                    # 43e
            fi      $t_y,$disc,$t_y                     # 44e
            or      $t_second,$t_second,$off_second     # 45e
        lqd     $quad_3,48($object_2)                   # 45o
        fma     $row_2,$axis_z,$z,$row                  # 46e
            shlqbyi $h_4,$h_3,0                         # 46o copy
            or      $t_second,$t_second,$hidden_second  # 47e
            selb    $hidden_second,$if_leaves,$if_enters,$b # 48e
        fms     $wx,$near_2,$x,$wx                      # 49e
            clgt    $control,$t,$t_second               # 50e
            fnms    $out_2,$k_2,$k_2,$out               # 51e
        shufb   $radius_2,$quad_3,$quad_3,$m_x          # 51o
        fnms    $ex_2,$row_2,$axis_x,$x                 # 52e
        shufb   $growth_2,$quad_3,$quad_3,$m_y          # 52o
            fm      $s,$disc,$t_y                       # 53e
        fms     $wy,$near_2,$y,$wy                      # 54e
        fm      $h_2,$axis_x,$wx                        # 55e
        fnms    $ey_2,$row_2,$axis_y,$y                 # 56e
        fms     $wz,$near_2,$z,$wz                      # 57e
        fm      $a,$ex_2,$ex_2                          # 58e
            fnms    $t_e,$s,$t_y,$k_one                 # 59e 1 - s y
        fm      $m,$growth_2,$row_2                     # 60e
        fma     $h_2,$axis_y,$wy,$h_2                   # 61e
        fnms    $ez_2,$row_2,$axis_z,$z                 # 62e
            selb    $s,$s,$b,$m_sign                    # 63e
        fma     $a,$ey_2,$ey_2,$a                       # 64e
            selb    $t,$t,$t_second,$control            # 65e
            fma     $t_e,$t_e,$k_half,$k_one            # 66e
            cgt     $control,$t_best,$t                 # 67e
            cgti    $ahead,$t,0                         # 68e
        fma     $h_3,$axis_z,$wz,$h_2                   # 69e
            and     $control,$control,$ahead            # 70e
        fma     $a,$ez_2,$ez_2,$a                       # 71e
        lnop                                            # 71o pairing
            andc    $control,$control,$disc_2           # 72e
            shlqbyi $disc_2,$disc,0                     # 72o copy
            fma     $q,$s,$t_e,$b                       # 73e
            lnop                                        # 73o pairing
        ai      $count,$count,-1                        # 74e
            rotqbii $control,$control,1                 # 74o
        fnms    $cx_2,$h_3,$axis_x,$wx                  # 75e
        fnms    $cy_2,$h_3,$axis_y,$wy                  # 76e
        fnms    $cz_2,$h_3,$axis_z,$wz                  # 77e
        lnop                                            # 77o pairing
        fnms    $a,$m,$m,$a                             # 78e
            gb      $control,$control                   # 78o
            fm      $first,$q,$inverse                  # 79e -s
            frest   $t_y_2,$q                           # 79o
        fma     $k_2,$growth_2,$h_3,$radius_2           # 80e
        fm      $vx_2,$m,$cx_2                          # 81e
        fm      $vy_2,$m,$cy_2                          # 82e
            shlqbii $control,$control,4                 # 82o
        fm      $turn_y_2,$cx_2,$ez_2                   # 83e
        lnop                                            # 83o pairing
        fm      $vz,$m,$cz_2                            # 84e
        frest   $t_y,$a                                 # 84o
        fm      $turn_x,$cz_2,$ey_2                     # 85e
        lnop                                            # 85o pairing
        fm      $turn_z,$cy_2,$ex_2                     # 86e
            lqx     $control,$control,$a_controls       # 86o
        fms     $vx_2,$k_2,$ex_2,$vx_2                  # 87e
        fm      $b,$cx_2,$ex_2                          # 88e
        fms     $turn_y_3,$cz_2,$ex_2,$turn_y_2         # 89e
        lnop                                            # 89o pairing
        fms     $vy_3,$k_2,$ey_2,$vy_2                  # 90e
next_row_back:
        brnz    $count,next_row                         # 90o
next_row_drain:
        fms     $disc,$vx_2,$vx_2,$k_tiny               # 0e
        shufb   $t_best,$t_best,$t,$control             # 0o
        fms     $vz,$k_2,$ez_2,$vz                      # 1e
        shufb   $nearest,$nearest,$object_4,$control    # 1o
        fms     $turn_x,$cy_2,$ez_2,$turn_x             # 2e
        shlqbyi $row_5,$row_2,0                         # 2o copy
        fi      $t_y_3,$q,$t_y_2                        # 3e
        shlqbyi $row_6,$row_2,0                         # 3o copy
        fi      $t_y,$a,$t_y                            # 4e
        shlqbyi $a_packet_7,$a_packet_3,0               # 4o copy
        nop     $127                                    # 5e pairing
        stqd    $nearest,448($a_packet_6)               # 5o
        fma     $disc,$vy_3,$vy_3,$disc                 # 6e
        lqd     $nearest,448($a_packet_4)               # 6o
        fma     $b,$cy_2,$ey_2,$b                       # 7e
        stqd    $t_best,384($a_packet_6)                # 7o
        fms     $turn_z,$cx_2,$ey_2,$turn_z             # 8e
        lqd     $t_best,384($a_packet_4)                # 8o
        fnms    $off,$first,$row_4,$h_5                 # 9e the crossing's height
        lqx     $if_leaves,$a_if_leaves,$sides_2        # 9o
        fnms    $t_e_2,$q,$t_y_3,$k_one                 # 10e
        shlqbyi $h_5,$h_3,0                             # 10o copy
        fs      $t,$near_4,$first                       # 11e
        shlqbyi $near_5,$near_2,0                       # 11o copy
        fma     $disc,$vz,$vz,$disc                     # 12e
        shufb   $height_3,$quad_3,$quad_3,$m_z          # 12o
        fma     $b,$cz_2,$ez_2,$b                       # 13e
        shlqbyi $object_3,$object_3,0                   # 13o copy
        fm      $out,$cx_2,$cx_2                        # 14e
        lqx     $if_enters_2,$a_if_enters,$sides_2      # 14o
        clgt    $off,$off,$height_2                     # 15e below 0 is above all
        shlqbyi $h_6,$h_3,0                             # 15o copy
        fma     $inverse_q,$t_e_2,$t_y_3,$t_y_3         # 16e
        shlqbyi $near_4,$near_2,0                       # 16o copy
        or      $t,$t,$off                              # 17e
        shlqbyi $a_packet_8,$a_packet_5,0               # 17o copy
        fnms    $disc,$turn_x,$turn_x,$disc             # 18e
        shlqbyi $a_packet_5,$a_packet_3,0               # 18o copy
        fnms    $b,$k_2,$m,$b                           # 19e
        hbr     isect_cone_pairs_r16_return,$lr         # 19o hint
        fma     $out,$cy_2,$cy_2,$out                   # 20e
        shlqbyi $object_5,$object_2,0                   # 20o copy
        or      $t,$t,$hidden                           # 21e
        lnop                                            # 21o pairing
        fm      $second,$out_2,$inverse_q               # 22e
        shlqbyi $a_packet_9,$a_packet_5,0               # 22o copy
        fnms    $t_e,$a,$t_y,$k_one                     # 23e
        lnop                                            # 23o pairing
        fnms    $disc,$turn_y_3,$turn_y_3,$disc         # 24e
        shlqbyi $object_5,$object_5,0                   # 24o copy
        selb    $hidden,$if_enters_2,$if_leaves,$b      # 25e
        fma     $out,$cz_2,$cz_2,$out                   # 26e
        selb    $hidden_second_2,$if_leaves,$if_enters_2,$b # 27e
        fnms    $off_second,$second,$row_3,$h_4         # 28e
        fs      $t_second,$near_3,$second               # 29e
        fnms    $disc,$turn_z,$turn_z,$disc             # 30e
        fma     $inverse,$t_e,$t_y,$t_y                 # 31e
        fnms    $out_2,$k_2,$k_2,$out                   # 32e
        clgt    $off_second,$off_second,$height_2       # 34e
        lnop                                            # 34o pairing
        or      $t_second,$t_second,$off_second         # 36e
        frsqest $t_y,$disc                              # 36o
        shlqbyi $disc_3,$disc,0                         # 37o copy
        or      $t_second,$t_second,$hidden_second      # 38e
        fi      $t_y,$disc,$t_y                         # 40e
        clgt    $control,$t,$t_second                   # 41e
        selb    $t,$t,$t_second,$control                # 43e
        cgti    $ahead,$t,0                             # 45e
        cgt     $control,$t_best,$t                     # 46e
        fm      $s,$disc,$t_y                           # 47e
        and     $control,$control,$ahead                # 48e
        andc    $control,$control,$disc_2               # 50e
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
        frest   $t_y_2,$q                               # 71o
        shufb   $nearest,$nearest,$object_3,$control    # 72o
        fi      $t_y_4,$q,$t_y_2                        # 75e
        nop     $127                                    # 76e pairing
        stqd    $nearest,448($a_packet_8)               # 76o
        fnms    $off,$first,$row_5,$h_5                 # 77e the crossing's height
        lqd     $nearest,448($a_packet_7)               # 77o
        fs      $t,$near_4,$first                       # 78e
        stqd    $t_best,384($a_packet_8)                # 78o
        lqd     $t_best,384($a_packet_7)                # 79o
        fnms    $t_e_3,$q,$t_y_4,$k_one                 # 82e
        clgt    $off,$off,$height_3                     # 83e below 0 is above all
        or      $t,$t,$off                              # 85e
        or      $t,$t,$hidden                           # 87e
        fma     $inverse_q,$t_e_3,$t_y_4,$t_y_4         # 88e
        fm      $second,$out_2,$inverse_q               # 94e
        fnms    $off_second,$second,$row_6,$h_6         # 100e
        fs      $t_second,$near_5,$second               # 101e
        clgt    $off_second,$off_second,$height_3       # 106e
        or      $t_second,$t_second,$off_second         # 108e
        or      $t_second,$t_second,$hidden_second_2    # 110e
        clgt    $control,$t,$t_second                   # 112e
        selb    $t,$t,$t_second,$control                # 114e
        cgt     $control,$t_best,$t                     # 116e
        cgti    $ahead,$t,0                             # 117e
        and     $control,$control,$ahead                # 119e
        andc    $control,$control,$disc_3               # 121e
        rotqbii $control,$control,1                     # 123o
        gb      $control,$control                       # 127o
        shlqbii $control,$control,4                     # 131o
        lqx     $control,$control,$a_controls           # 135o
        shufb   $nearest,$nearest,$object_5,$control    # 141o
        shufb   $t_best,$t_best,$t,$control             # 142o
        stqd    $nearest,448($a_packet_9)               # 145o
        stqd    $t_best,384($a_packet_9)                # 146o
        nop     $127                                    # 147e pairing
isect_cone_pairs_r16_return:
        bi      $lr                                     # 147o
next_row_short:
        shli    $row,$a_candidate,2                     # 0e
        lqd     $object,0($a_candidate)                 # 0o
        ai      $count,$count,-1                        # 1e
        ai      $a_candidate,$a_candidate,4             # 2e
        andi    $row,$row,48                            # 4e
        shufb   $object_4,$object,$object,$m_x          # 6o
        rotqbyi $a_packet,$object,4                     # 7o
        lqd     $sides,32($object)                      # 8o
        nop     $127                                    # 9e pairing
        lqd     $quad,0($object_4)                      # 10o
        a       $a_packet,$a_packet,$row                # 11e
        lqd     $quad_4,16($object_4)                   # 11o
        lqd     $quad_5,48($object_4)                   # 12o
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
        shufb   $axis_x,$quad_4,$quad_4,$m_x            # 22o
        shufb   $axis_y,$quad_4,$quad_4,$m_y            # 23o
        nop     $127                                    # 24e pairing
        shufb   $axis_z,$quad_4,$quad_4,$m_z            # 24o
        fs      $wz,$base_z,$wz                         # 25e
        shufb   $growth,$quad_5,$quad_5,$m_y            # 25o
        fm      $near,$wx,$x                            # 26e
        shufb   $radius,$quad_5,$quad_5,$m_x            # 26o
        fm      $row,$axis_x,$x                         # 27e
        rotqbyi $sides,$sides,12                        # 27o
        shufb   $height,$quad_5,$quad_5,$m_z            # 28o
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
        shufb   $nearest,$nearest,$object_4,$control    # 228o
        stqd    $t_best,384($a_packet)                  # 231o
        stqd    $nearest,448($a_packet)                 # 232o
        nop     $127                                    # 233e pairing
        brnz    $count,next_row_short                   # 233o
        nop     $127                                    # 234e pairing
        bi      $lr                                     # 234o
endfunction isect_cone_pairs_r16
