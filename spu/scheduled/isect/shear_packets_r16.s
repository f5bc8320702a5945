# shear_packets_r16   what isect_triangle_pairs_r16 needs to know of packets' rays
#   C       void shear_packets_r16(const struct ray_packet *, int count, struct shear *);
#   In      $3 packets, one behind the other, $4 count (0 is none), $5 shears likewise; pointers
#           16-aligned
#   Out     shears
#   Uses    $2-$55, $79   Saves  -   Stack  0   Calls  -
#   Domain  the longest component of a direction is from 2^-62 to 2^62
#   Error   1.5 ulp: of 1 in the slopes, of itself in 1 / direction z
#   Twin    lab/twins/src/triangle.rs
#
# The shears are those of shear_r16.
# Scheduled by spu schedule from shear_packets_r16.s

        .include "work_unit.inc"
        .include "macros.inc"
        .include "flat.inc"
        .include "shear_tmpl.inc"

        .set    NEXT,3
        registers a_rays,count,a_shear
        # constants
        .set    NEXT,10
        registers k_x,k_y,k_z,k_one,k_sign
        # the rays
        registers origin_x,origin_y,origin_z,direction_x,direction_y,direction_z
        # results
        registers axis_x,axis_y,axis_z
        registers own_x                                 # the origin in the ray's permuted axes
        registers own_y,own_z,slope_x,slope_y,minus_per_z
        # temporaries
        registers x,y,z,inverse,t_y,t_e,c_y,c_z

function shear_packets_r16
        .set count_2,79; .set a_rays_2,15; .set direction_y_2,7; .set direction_x_2,9
        .set direction_z_2,31; .set direction_y_3,23; .set direction_x_3,30; .set c_y_2,29
        .set direction_y_4,16; .set z_2,34; .set direction_x_4,28; .set direction_z_3,6
        .set c_z_2,42; .set direction_z_4,39; .set c_y_3,40; .set origin_y_2,41; .set origin_z_2,47
        .set origin_x_2,50; .set z_3,46; .set t_y_2,27; .set origin_x_3,43; .set c_y_4,38
        .set origin_z_3,45; .set c_z_3,49; .set t_y_3,17; .set z_4,48; .set c_z_4,51; .set t_y_4,53
        .set y_2,2; .set t_y_5,52; .set t_e_2,8; .set t_y_6,21; .set x_2,26; .set t_y_7,7
        .set x_3,22; .set t_e_3,2; .set x_4,9; .set y_3,21; .set t_e_4,26; .set slope_y_2,17
        .set slope_x_2,35; .set inverse_2,24; .set inverse_3,2; .set own_x_2,8; .set inverse_4,7
        .set t_e_5,31; .set t_e_6,22; .set y_4,27; .set slope_x_3,25; .set minus_per_z_2,8
        .set slope_y_3,26; .set x_5,34; .set y_5,16; .set axis_z_2,27; .set own_y_2,8
        .set origin_y_3,39; .set origin_z_4,31; .set x_6,28; .set slope_y_4,34; .set y_6,20
        .set slope_x_4,22; .set slope_x_5,18; .set origin_x_4,35; .set axis_x_2,9
        .set origin_y_4,27; .set y_7,19; .set origin_y_5,20; .set t_e_7,21; .set own_z_2,33
        .set t_e_8,16; .set t_e_9,9; .set axis_y_2,41; .set slope_x_6,8; .set origin_z_5,33
        .set origin_x_5,22; .set axis_z_3,21; .set minus_per_z_3,3; .set axis_y_3,25
        .set t_e_10,19; .set own_y_3,3; .set slope_y_5,16; .set slope_x_7,7; .set minus_per_z_4,21
        .set x_7,6; .set own_x_3,52; .set axis_z_4,32; .set own_x_4,6; .set slope_x_8,23
        .set axis_z_5,8; .set axis_z_6,9; .set axis_y_4,3; .set axis_x_3,44; .set axis_z_7,6
        .set axis_x_4,7; .set t_e_11,30; .set axis_y_5,19; .set own_y_4,7; .set own_z_3,41
        .set axis_x_5,16; .set own_z_4,9; .set axis_y_6,54; .set own_y_5,55; .set own_z_5,52
        .set axis_x_6,2; .set own_z_6,8; .set a_shear_2,17; .set x_8,33; .set direction_z_5,35
        .set own_y_6,24; .set own_x_5,2; .set t_y_8,8; .set x_9,35; .set t_e_12,39
        .set inverse_5,8; .set x_10,18; .set minus_per_z_5,9; .set inverse_6,17; .set slope_x_9,9
        .set minus_per_z_6,26; .set y_8,7; .set slope_y_6,19; .set slope_y_7,20; .set t_e_13,6
        .set t_e_14,18; .set t_e_15,7; .set origin_z_6,34; .set axis_z_8,46; .set own_y_7,48
        .set axis_x_7,31; .set origin_y_6,36; .set origin_y_7,46; .set minus_per_z_7,18
        .set axis_y_7,31; .set own_y_8,18; .set own_y_9,6; .set axis_x_8,6; .set axis_x_9,3
        .set a_shear_3,2; .set a_rays_3,2; .set a_shear_4,6; .set direction_x_5,7
        .set direction_y_5,8; .set direction_z_6,9; .set direction_x_6,15; .set direction_z_7,17
        .set c_y_5,21; .set direction_x_7,22; .set z_5,24; .set direction_z_8,25
        .set origin_x_6,26; .set c_z_5,27; .set origin_y_8,28; .set origin_z_7,29
        .set origin_x_7,30; .set c_y_6,31; .set c_y_7,33; .set t_y_9,35; .set z_6,38; .set z_7,40
        .set origin_z_8,41; .set origin_y_9,44; .set origin_x_8,46; .set c_z_6,47
        .set origin_y_10,48; .set x_11,49; .set t_y_10,50; .set origin_z_9,3; .set t_e_16,51
        .set t_e_17,53; .set x_12,54; .set y_9,9; .set inverse_7,34; .set inverse_8,35
        .set t_e_18,49; .set x_13,7; .set y_10,8; .set slope_x_10,51; .set slope_y_8,53
        .set inverse_9,49; .set x_14,50; .set t_e_19,54; .set slope_x_11,24; .set y_11,15
        .set x_15,16; .set y_12,25; .set slope_y_9,18; .set slope_y_10,8; .set axis_x_10,18
        .set own_x_6,7; .set axis_x_11,32; .set axis_y_8,36; .set axis_z_9,50; .set own_x_7,51
        .set own_y_10,52; .set own_z_7,21; .set slope_x_12,53; .set slope_y_11,54
        .set minus_per_z_8,34; .set slope_y_12,7; .set axis_x_12,8; .set axis_y_9,9
        .set axis_z_10,15; .set own_y_11,16; .set own_z_8,18
        nop     $127                                    # 0e pairing
        biz     $count,$lr                              # 0o
        ilhu    $k_y,0x405                              # 1e
        ilhu    $k_z,0x809                              # 2e
        clgti   $count_2,$count,1                       # 3e at least as many passes as overlap
        ila     $k_x,0x10203                            # 4e
        iohl    $k_y,0x607                              # 5e
        iohl    $k_z,0xa0b                              # 6e
        ilhu    $k_one,0x3f80                           # 7e
        lnop                                            # 7o pairing
        ilhu    $k_sign,0x8000                          # 8e
        brz     $count_2,next_packet_short              # 8o too few passes
        ai      $a_rays_2,$a_rays,320                   # 9e
        lqd     $direction_y_2,272($a_rays)             # 9o
        ai      $count,$count,-1                        # 10e
        lqd     $direction_x_2,208($a_rays)             # 10o
        lqd     $direction_z_2,336($a_rays)             # 11o
        lqd     $direction_y,288($a_rays)               # 12o
        lqd     $direction_x,224($a_rays)               # 13o
        lqd     $direction_y_3,256($a_rays)             # 14o
        nop     $127                                    # 15e pairing
        lqd     $direction_x_3,192($a_rays)             # 15o
        fcmgt   $c_y_2,$direction_y_2,$direction_x_2    # 16e
        lqd     $direction_z,352($a_rays)               # 16o
        nop     $127                                    # 17e pairing
        lqd     $direction_y_4,304($a_rays)             # 17o
        selb    $z_2,$direction_x_2,$direction_y_2,$c_y_2 # 18e
        lqd     $direction_x_4,240($a_rays)             # 18o
        fcmgt   $c_y,$direction_y,$direction_x          # 19e
        lqd     $direction_z_3,320($a_rays)             # 19o
        fcmgt   $c_z_2,$direction_z_2,$z_2              # 20e
        lqd     $direction_z_4,368($a_rays)             # 20o
        fcmgt   $c_y_3,$direction_y_3,$direction_x_3    # 21e
        lqd     $origin_y_2,96($a_rays)                 # 21o
        selb    $z_2,$z_2,$direction_z_2,$c_z_2         # 22e
        lqd     $origin_z_2,160($a_rays)                # 22o
        selb    $z,$direction_x,$direction_y,$c_y       # 23e
        lqd     $origin_x_2,32($a_rays)                 # 23o
        selb    $z_3,$direction_x_3,$direction_y_3,$c_y_3 # 24e
        frest   $t_y_2,$z_2                             # 24o
        fcmgt   $c_z,$direction_z,$z                    # 25e
        lqd     $origin_x_3,48($a_rays)                 # 25o
        fcmgt   $c_y_4,$direction_y_4,$direction_x_4    # 26e
        lqd     $origin_z_3,176($a_rays)                # 26o
        fcmgt   $c_z_3,$direction_z_3,$z_3              # 27e
        fi      $t_y_3,$z_2,$t_y_2                      # 28e
        selb    $z_4,$direction_x_4,$direction_y_4,$c_y_4 # 29e
        selb    $z,$z,$direction_z,$c_z                 # 30e
        selb    $z_3,$z_3,$direction_z_3,$c_z_3         # 31e
        lnop                                            # 31o pairing
        fcmgt   $c_z_4,$direction_z_4,$z_4              # 32e
        frest   $t_y_4,$z                               # 32o
        selb    $y_2,$direction_z_2,$direction_x_2,$c_y_2 # 33e
        frest   $t_y_5,$z_3                             # 33o
        selb    $z_4,$z_4,$direction_z_4,$c_z_4         # 34e
        fnms    $t_e_2,$z_2,$t_y_3,$k_one               # 35e
        fi      $t_y_4,$z,$t_y_4                        # 36e
        frest   $t_y_6,$z_4                             # 36o
        fi      $t_y_5,$z_3,$t_y_5                      # 37e
        selb    $x_2,$direction_y_2,$direction_z_2,$c_y_2 # 38e
        selb    $y,$y_2,$direction_y_2,$c_z_2           # 39e
        fi      $t_y_7,$z_4,$t_y_6                      # 40e
        selb    $x_3,$x_2,$direction_x_2,$c_z_2         # 41e
        fma     $inverse,$t_e_2,$t_y_3,$t_y_3           # 42e
        fnms    $t_e_3,$z,$t_y_4,$k_one                 # 43e
        fnms    $t_e_2,$z_3,$t_y_5,$k_one               # 44e
        selb    $x_4,$direction_y,$direction_z,$c_y     # 45e
        selb    $y_3,$direction_z_3,$direction_x_3,$c_y_3 # 46e
        fnms    $t_e_4,$z_4,$t_y_7,$k_one               # 47e
        fm      $slope_y_2,$y,$inverse                  # 48e
        fm      $slope_x_2,$x_3,$inverse                # 49e
        fma     $inverse_2,$t_e_3,$t_y_4,$t_y_4         # 50e
        fma     $inverse_3,$t_e_2,$t_y_5,$t_y_5         # 51e
        selb    $own_x_2,$origin_y_2,$origin_z_2,$c_y   # 52e
        fma     $inverse_4,$t_e_4,$t_y_7,$t_y_7         # 53e
        fnms    $t_e_5,$slope_y_2,$z_2,$y               # 54e
        selb    $x_4,$x_4,$direction_x,$c_z             # 55e
        selb    $y_3,$y_3,$direction_y_3,$c_z_3         # 56e
        fnms    $t_e_6,$slope_x_2,$z_2,$x_3             # 57e
        selb    $own_x_2,$own_x_2,$origin_x_2,$c_z      # 58e
        selb    $y_4,$direction_z_4,$direction_x_4,$c_y_4 # 59e
        lnop                                            # 59o pairing
        fm      $slope_x_3,$x_4,$inverse_2              # 60e
        stqd    $own_x_2,224($a_shear)                  # 60o
        xor     $minus_per_z_2,$inverse_3,$k_sign       # 61e
        fm      $slope_y_3,$y_3,$inverse_3              # 62e
        selb    $x_5,$direction_y_4,$direction_z_4,$c_y_4 # 63e
        stqd    $minus_per_z_2,512($a_shear)            # 63o
        xor     $minus_per_z_2,$inverse,$k_sign         # 64e
        selb    $y_5,$y_4,$direction_y_4,$c_z_4         # 65e
        selb    $axis_z_2,$k_x,$k_y,$c_y                # 66e
        stqd    $minus_per_z_2,528($a_shear)            # 66o
        selb    $own_y_2,$origin_z_2,$origin_x_2,$c_y   # 67e
        lqd     $origin_y_3,64($a_rays)                 # 67o
        fma     $slope_y_2,$t_e_5,$inverse,$slope_y_2   # 68e
        lqd     $origin_z_4,128($a_rays)                # 68o
        selb    $x_6,$x_5,$direction_x_4,$c_z_4         # 69e
        fm      $slope_y_4,$y_5,$inverse_4              # 70e
        selb    $axis_z_2,$axis_z_2,$k_z,$c_z           # 71e
        selb    $y_6,$direction_z,$direction_x,$c_y     # 72e
        selb    $own_y_2,$own_y_2,$origin_y_2,$c_z      # 73e
        stqd    $axis_z_2,160($a_shear)                 # 73o
        fma     $slope_x_4,$t_e_6,$inverse,$slope_x_2   # 74e
        lnop                                            # 74o pairing
        fm      $slope_x_5,$x_6,$inverse_4              # 75e
        stqd    $own_y_2,288($a_shear)                  # 75o
        fnms    $t_e_2,$slope_x_3,$z,$x_4               # 76e
        lqd     $origin_x_4,16($a_rays)                 # 76o
        selb    $axis_x_2,$k_y,$k_z,$c_y                # 77e
        lqd     $origin_y_4,112($a_rays)                # 77o
        selb    $y_7,$y_6,$direction_y,$c_z             # 78e
        lqd     $origin_y_5,80($a_rays)                 # 78o
        fnms    $t_e_7,$slope_y_3,$z_3,$y_3             # 79e
        stqd    $slope_y_2,464($a_shear)                # 79o
        selb    $own_z_2,$origin_x_2,$origin_y_2,$c_y   # 80e
        selb    $axis_x_2,$axis_x_2,$k_x,$c_z           # 81e
        fm      $slope_y_2,$y_7,$inverse_2              # 82e
        lnop                                            # 82o pairing
        fnms    $t_e_8,$slope_y_4,$z_4,$y_5             # 83e
        stqd    $axis_x_2,32($a_shear)                  # 83o
        selb    $own_z_2,$own_z_2,$origin_z_2,$c_z      # 84e
        stqd    $slope_x_4,400($a_shear)                # 84o
        fnms    $t_e_9,$slope_x_5,$z_4,$x_6             # 85e
        lnop                                            # 85o pairing
        selb    $axis_y_2,$k_z,$k_x,$c_y_4              # 86e
        stqd    $own_z_2,352($a_shear)                  # 86o
        fma     $slope_x_6,$t_e_2,$inverse_2,$slope_x_3 # 87e
        lqd     $origin_z_5,144($a_rays)                # 87o
        fma     $slope_y,$t_e_7,$inverse_3,$slope_y_3   # 88e
        lqd     $origin_x_5,0($a_rays)                  # 88o
        selb    $axis_z_3,$k_x,$k_y,$c_y_3              # 89e
        xor     $minus_per_z_3,$inverse_4,$k_sign       # 90e
        selb    $axis_y_3,$axis_y_2,$k_y,$c_z_4         # 91e
        lnop                                            # 91o pairing
        fnms    $t_e_10,$slope_y_2,$z,$y_7              # 92e
        stqd    $minus_per_z_3,560($a_shear)            # 92o
        selb    $axis_z_3,$axis_z_3,$k_z,$c_z_3         # 93e
        stqd    $axis_y_3,112($a_shear)                 # 93o
        selb    $own_y_3,$origin_z_3,$origin_x_3,$c_y_4 # 94e
        lnop                                            # 94o pairing
        fma     $slope_y_5,$t_e_8,$inverse_4,$slope_y_4 # 95e
        stqd    $axis_z_3,128($a_shear)                 # 95o
        selb    $own_y_3,$own_y_3,$origin_y_4,$c_z_4    # 96e
        stqd    $slope_x_6,416($a_shear)                # 96o
        fma     $slope_x_7,$t_e_9,$inverse_4,$slope_x_5 # 97e
        stqd    $slope_y,448($a_shear)                  # 97o
        xor     $minus_per_z_4,$inverse_2,$k_sign       # 98e
        stqd    $own_y_3,304($a_shear)                  # 98o
        selb    $own_y_3,$origin_z_5,$origin_x_4,$c_y_2 # 99e
        lnop                                            # 99o pairing
        selb    $x_7,$direction_y_3,$direction_z_3,$c_y_3 # 100e
        stqd    $minus_per_z_4,544($a_shear)            # 100o
        selb    $own_x_3,$origin_y_3,$origin_z_4,$c_y_3 # 101e
        stqd    $slope_y_5,496($a_shear)                # 101o
        selb    $own_y_3,$own_y_3,$origin_y_5,$c_z_2    # 102e
        fma     $slope_y,$t_e_10,$inverse_2,$slope_y_2  # 103e
        selb    $x,$x_7,$direction_x_3,$c_z_3           # 104e
        stqd    $own_y_3,272($a_shear)                  # 104o
        selb    $axis_z_4,$k_x,$k_y,$c_y_2              # 105e
        stqd    $slope_x_7,432($a_shear)                # 105o
        selb    $own_x_4,$own_x_3,$origin_x_5,$c_z_3    # 106e
        fm      $slope_x_8,$x,$inverse_3                # 107e
        selb    $axis_z_5,$k_x,$k_y,$c_y_4              # 108e
        stqd    $own_x_4,192($a_shear)                  # 108o
        selb    $axis_z_6,$axis_z_4,$k_z,$c_z_2         # 109e
        selb    $axis_y_4,$k_z,$k_x,$c_y_2              # 110e
        selb    $axis_x_3,$k_y,$k_z,$c_y_3              # 111e
        stqd    $axis_z_6,144($a_shear)                 # 111o
        selb    $axis_z_7,$axis_z_5,$k_z,$c_z_4         # 112e
        stqd    $slope_y,480($a_shear)                  # 112o
        selb    $axis_y_4,$axis_y_4,$k_y,$c_z_2         # 113e
        lnop                                            # 113o pairing
        selb    $axis_x_4,$axis_x_3,$k_x,$c_z_3         # 114e
        stqd    $axis_z_7,176($a_shear)                 # 114o
        fnms    $t_e_11,$slope_x_8,$z_3,$x              # 115e
        stqd    $axis_y_4,80($a_shear)                  # 115o
        selb    $axis_y_5,$k_z,$k_x,$c_y_3              # 116e
        stqd    $axis_x_4,0($a_shear)                   # 116o
        selb    $own_z,$origin_x_5,$origin_y_3,$c_y_3   # 117e
        selb    $own_y_4,$origin_z_4,$origin_x_5,$c_y_3 # 118e
        selb    $axis_y_3,$k_z,$k_x,$c_y                # 119e
        selb    $own_z_3,$origin_x_4,$origin_y_5,$c_y_2 # 120e
        selb    $own_x,$origin_y_5,$origin_z_5,$c_y_2   # 121e
        selb    $axis_x_5,$k_y,$k_z,$c_y_4              # 122e
        ai      $a_rays,$a_rays_2,320                   # 123e
        selb    $axis_x,$k_y,$k_z,$c_y_2                # 124e
        selb    $own_x_2,$origin_y_4,$origin_z_3,$c_y_4 # 125e
        selb    $own_z_4,$origin_x_3,$origin_y_4,$c_y_4 # 126e
        selb    $axis_y_6,$axis_y_5,$k_y,$c_z_3         # 127e
        selb    $own_y_5,$own_y_4,$origin_y_3,$c_z_3    # 128e
        selb    $own_z_5,$own_z,$origin_z_4,$c_z_3      # 129e
        lnop                                            # 129o pairing
next_packet:
        ai      $count,$count,-1                        # 0e
            selb    $axis_x,$axis_x,$k_x,$c_z_2         # 1e
            fma     $slope_x,$t_e_11,$inverse_3,$slope_x_8 # 2e
            lnop                                        # 2o pairing
            selb    $own_x,$own_x,$origin_x_4,$c_z_2    # 3e
        lqd     $direction_y,288($a_rays)               # 3o
            selb    $axis_x_6,$axis_x_5,$k_x,$c_z_4     # 4e
        lqd     $direction_x,224($a_rays)               # 4o
            selb    $own_z,$own_z_3,$origin_z_5,$c_z_2  # 5e
            lnop                                        # 5o pairing
            selb    $own_x_4,$own_x_2,$origin_x_3,$c_z_4 # 6e
        lqd     $direction_y_2,272($a_rays)             # 6o
            selb    $own_z_6,$own_z_4,$origin_z_3,$c_z_4 # 7e
        lqd     $direction_x_2,208($a_rays)             # 7o
            selb    $axis_y,$axis_y_3,$k_y,$c_z         # 8e
            lnop                                        # 8o pairing
        ai      $a_rays_2,$a_rays,320                   # 9e
        lqd     $direction_z,352($a_rays)               # 9o
        fcmgt   $c_y,$direction_y,$direction_x          # 10e
        lqd     $direction_y_4,304($a_rays)             # 10o
            ai      $a_shear_2,$a_shear,288             # 11e
        lqd     $direction_y_3,256($a_rays)             # 11o
        selb    $axis_y_3,$k_z,$k_x,$c_y                # 12e
        lqd     $direction_x_4,240($a_rays)             # 12o
        fcmgt   $c_y_2,$direction_y_2,$direction_x_2    # 13e
        lqd     $direction_x_3,192($a_rays)             # 13o
        selb    $z,$direction_x,$direction_y,$c_y       # 14e
        lqd     $direction_z_2,336($a_rays)             # 14o
        selb    $x_8,$direction_y,$direction_z,$c_y     # 15e
        selb    $z_2,$direction_x_2,$direction_y_2,$c_y_2 # 16e
        fcmgt   $c_z,$direction_z,$z                    # 17e
        lqd     $direction_z_5,320($a_rays)             # 17o
        fcmgt   $c_y_4,$direction_y_4,$direction_x_4    # 18e
        lqd     $direction_z_4,368($a_rays)             # 18o
        fcmgt   $c_y_3,$direction_y_3,$direction_x_3    # 19e
        lqd     $origin_y_2,96($a_rays)                 # 19o
        fcmgt   $c_z_2,$direction_z_2,$z_2              # 20e
        lqd     $origin_x_3,48($a_rays)                 # 20o
        selb    $axis_x_3,$k_y,$k_z,$c_y_3              # 21e
        lqd     $origin_z_3,176($a_rays)                # 21o
        selb    $z_3,$direction_x_3,$direction_y_3,$c_y_3 # 22e
        lqd     $origin_z_2,160($a_rays)                # 22o
        selb    $z_4,$direction_x_4,$direction_y_4,$c_y_4 # 23e
        lnop                                            # 23o pairing
        fcmgt   $c_z_3,$direction_z_5,$z_3              # 24e
        lqd     $origin_x_2,32($a_rays)                 # 24o
        fcmgt   $c_z_4,$direction_z_4,$z_4              # 25e
            stqd    $own_z_5,320($a_shear)              # 25o
        selb    $z_3,$z_3,$direction_z_5,$c_z_3         # 26e
            stqd    $own_x,208($a_shear)                # 26o
        selb    $own_y_6,$origin_z_3,$origin_x_3,$c_y_4 # 27e
            stqd    $axis_x_6,48($a_shear)              # 27o
        selb    $own_x_5,$origin_y_2,$origin_z_2,$c_y   # 28e
        frest   $t_y_5,$z_3                             # 28o
        selb    $z_4,$z_4,$direction_z_4,$c_z_4         # 29e
            stqd    $own_x_4,240($a_shear)              # 29o
        selb    $z,$z,$direction_z,$c_z                 # 30e
            stqd    $own_z_6,368($a_shear)              # 30o
        selb    $x_7,$direction_y_4,$direction_z_4,$c_y_4 # 31e
        frest   $t_y_8,$z_4                             # 31o
        selb    $own_x_5,$own_x_5,$origin_x_2,$c_z      # 32e
        frest   $t_y_4,$z                               # 32o
        selb    $y_6,$direction_z,$direction_x,$c_y     # 33e
            stqd    $own_y_5,256($a_shear)              # 33o
        selb    $z_2,$z_2,$direction_z_2,$c_z_2         # 34e
            stqd    $axis_y_6,64($a_shear)              # 34o
        fi      $t_y_5,$z_3,$t_y_5                      # 35e
            stqd    $slope_x,384($a_shear)              # 35o
        fi      $t_y_8,$z_4,$t_y_8                      # 36e
        frest   $t_y_2,$z_2                             # 36o
        fi      $t_y_4,$z,$t_y_4                        # 37e
            stqd    $axis_x,16($a_shear)                # 37o
        selb    $y_3,$direction_z_5,$direction_x_3,$c_y_3 # 38e
            stqd    $own_z,336($a_shear)                # 38o
        selb    $x_2,$direction_y_2,$direction_z_2,$c_y_2 # 39e
            stqd    $axis_y,96($a_shear)                # 39o
            ai      $a_shear,$a_shear_2,288             # 40e
        fi      $t_y_3,$z_2,$t_y_2                      # 41e
        selb    $x_3,$x_2,$direction_x_2,$c_z_2         # 42e
        stqd    $own_x_5,224($a_shear)                  # 42o
        fnms    $t_e_3,$z_3,$t_y_5,$k_one               # 43e
        fnms    $t_e_4,$z_4,$t_y_8,$k_one               # 44e
        selb    $y_4,$direction_z_4,$direction_x_4,$c_y_4 # 45e
        selb    $x_9,$direction_y_3,$direction_z_5,$c_y_3 # 46e
        fnms    $t_e_12,$z,$t_y_4,$k_one                # 47e
        selb    $y,$direction_z_2,$direction_x_2,$c_y_2 # 48e
        fnms    $t_e_9,$z_2,$t_y_3,$k_one               # 49e
        fma     $inverse_3,$t_e_3,$t_y_5,$t_y_5         # 50e
        fma     $inverse_5,$t_e_4,$t_y_8,$t_y_8         # 51e
        selb    $y_3,$y_3,$direction_y_3,$c_z_3         # 52e
        selb    $x_10,$x_8,$direction_x,$c_z            # 53e
        selb    $x_7,$x_7,$direction_x_4,$c_z_4         # 54e
        fma     $inverse,$t_e_9,$t_y_3,$t_y_3           # 55e
        xor     $minus_per_z_5,$inverse_3,$k_sign       # 56e
        selb    $x,$x_9,$direction_x_3,$c_z_3           # 57e
        lnop                                            # 57o pairing
        fma     $inverse_6,$t_e_12,$t_y_4,$t_y_4        # 58e
        stqd    $minus_per_z_5,512($a_shear)            # 58o
        fm      $slope_x_9,$x_7,$inverse_5              # 59e
        fm      $slope_y,$y_3,$inverse_3                # 60e
        fm      $slope_x_8,$x,$inverse_3                # 61e
        xor     $minus_per_z_6,$inverse,$k_sign         # 62e
        fm      $slope_x_2,$x_3,$inverse                # 63e
        lnop                                            # 63o pairing
        selb    $y,$y,$direction_y_2,$c_z_2             # 64e
        stqd    $minus_per_z_6,528($a_shear)            # 64o
        selb    $y_8,$y_6,$direction_y,$c_z             # 65e
        fm      $slope_y_6,$y,$inverse                  # 66e
        selb    $y_5,$y_4,$direction_y_4,$c_z_4         # 67e
        fm      $slope_x,$x_10,$inverse_6               # 68e
        fm      $slope_y_7,$y_8,$inverse_6              # 69e
        fm      $slope_y_3,$y_5,$inverse_5              # 70e
        fnms    $t_e_13,$slope_x_9,$z_4,$x_7            # 71e
        fnms    $t_e_11,$slope_x_8,$z_3,$x              # 72e
        fnms    $t_e_7,$slope_y,$z_3,$y_3               # 73e
        fnms    $t_e_14,$slope_x,$z,$x_10               # 74e
        fnms    $t_e_6,$slope_x_2,$z_2,$x_3             # 75e
        fnms    $t_e_15,$slope_y_7,$z,$y_8              # 76e
        selb    $axis_z_4,$k_x,$k_y,$c_y_2              # 77e
        lqd     $origin_y_3,64($a_rays)                 # 77o
        fnms    $t_e_5,$slope_y_6,$z_2,$y               # 78e
        lqd     $origin_z_6,128($a_rays)                # 78o
        fnms    $t_e_8,$slope_y_3,$z_4,$y_5             # 79e
        selb    $axis_z_8,$k_x,$k_y,$c_y                # 80e
        selb    $own_y_7,$origin_z_2,$origin_x_2,$c_y   # 81e
        selb    $axis_z_8,$axis_z_8,$k_z,$c_z           # 82e
        selb    $own_y_7,$own_y_7,$origin_y_2,$c_z      # 83e
        lnop                                            # 83o pairing
        selb    $own_x_3,$origin_y_3,$origin_z_6,$c_y_3 # 84e
        stqd    $axis_z_8,160($a_shear)                 # 84o
        fma     $slope_x_4,$t_e_6,$inverse,$slope_x_2   # 85e
        stqd    $own_y_7,288($a_shear)                  # 85o
        fma     $slope_y_6,$t_e_5,$inverse,$slope_y_6   # 86e
        selb    $axis_x_7,$k_y,$k_z,$c_y                # 87e
        selb    $own_z_2,$origin_x_2,$origin_y_2,$c_y   # 88e
        lnop                                            # 88o pairing
        selb    $axis_x_7,$axis_x_7,$k_x,$c_z           # 89e
        lqd     $origin_x_4,16($a_rays)                 # 89o
        selb    $own_z_2,$own_z_2,$origin_z_2,$c_z      # 90e
        lqd     $origin_y_6,112($a_rays)                # 90o
        selb    $axis_y_2,$k_z,$k_x,$c_y_4              # 91e
        lqd     $origin_y_7,80($a_rays)                 # 91o
        fma     $slope_y,$t_e_7,$inverse_3,$slope_y     # 92e
        stqd    $slope_y_6,464($a_shear)                # 92o
        selb    $axis_y_5,$k_z,$k_x,$c_y_3              # 93e
        stqd    $axis_x_7,32($a_shear)                  # 93o
        selb    $axis_z_3,$k_x,$k_y,$c_y_3              # 94e
        stqd    $slope_x_4,400($a_shear)                # 94o
        fma     $slope_x,$t_e_14,$inverse_6,$slope_x    # 95e
        stqd    $own_z_2,352($a_shear)                  # 95o
        xor     $minus_per_z_7,$inverse_5,$k_sign       # 96e
        lqd     $origin_x_5,0($a_rays)                  # 96o
        selb    $axis_y_7,$axis_y_2,$k_y,$c_z_4         # 97e
        lqd     $origin_z_5,144($a_rays)                # 97o
        selb    $axis_z_3,$axis_z_3,$k_z,$c_z_3         # 98e
        stqd    $minus_per_z_7,560($a_shear)            # 98o
        selb    $own_z_3,$origin_x_4,$origin_y_7,$c_y_2 # 99e
        stqd    $axis_y_7,112($a_shear)                 # 99o
        selb    $own_y_8,$own_y_6,$origin_y_6,$c_z_4    # 100e
        stqd    $axis_z_3,128($a_shear)                 # 100o
        fma     $slope_y_5,$t_e_8,$inverse_5,$slope_y_3 # 101e
        stqd    $slope_x,416($a_shear)                  # 101o
        selb    $own_z,$origin_x_5,$origin_y_3,$c_y_3   # 102e
        stqd    $slope_y,448($a_shear)                  # 102o
        xor     $minus_per_z_4,$inverse_6,$k_sign       # 103e
        stqd    $own_y_8,304($a_shear)                  # 103o
        fma     $slope_x,$t_e_13,$inverse_5,$slope_x_9  # 104e
        lnop                                            # 104o pairing
        selb    $own_x,$origin_y_7,$origin_z_5,$c_y_2   # 105e
        stqd    $minus_per_z_4,544($a_shear)            # 105o
        selb    $own_y_9,$origin_z_5,$origin_x_4,$c_y_2 # 106e
        hbrr    next_packet_back,next_packet            # 106o hint
        selb    $axis_z_5,$k_x,$k_y,$c_y_4              # 107e
        stqd    $slope_y_5,496($a_shear)                # 107o
        selb    $own_y_9,$own_y_9,$origin_y_7,$c_z_2    # 108e
        fma     $slope_y,$t_e_15,$inverse_6,$slope_y_7  # 109e
        selb    $own_y_4,$origin_z_6,$origin_x_5,$c_y_3 # 110e
        stqd    $own_y_9,272($a_shear)                  # 110o
        selb    $own_x_4,$own_x_3,$origin_x_5,$c_z_3    # 111e
        stqd    $slope_x,432($a_shear)                  # 111o
        selb    $axis_z_6,$axis_z_4,$k_z,$c_z_2         # 112e
        lnop                                            # 112o pairing
        selb    $axis_x_5,$k_y,$k_z,$c_y_4              # 113e
        stqd    $own_x_4,192($a_shear)                  # 113o
        selb    $axis_y,$k_z,$k_x,$c_y_2                # 114e
        stqd    $axis_z_6,144($a_shear)                 # 114o
        selb    $axis_z_7,$axis_z_5,$k_z,$c_z_4         # 115e
        stqd    $slope_y,480($a_shear)                  # 115o
        selb    $axis_y,$axis_y,$k_y,$c_z_2             # 116e
        lnop                                            # 116o pairing
        ai      $a_rays,$a_rays_2,320                   # 117e
        stqd    $axis_z_7,176($a_shear)                 # 117o
        selb    $axis_x,$k_y,$k_z,$c_y_2                # 118e
        stqd    $axis_y,80($a_shear)                    # 118o
        selb    $axis_x_8,$axis_x_3,$k_x,$c_z_3         # 119e
        selb    $own_x_2,$origin_y_6,$origin_z_3,$c_y_4 # 120e
        selb    $own_z_4,$origin_x_3,$origin_y_6,$c_y_4 # 121e
        stqd    $axis_x_8,0($a_shear)                   # 121o
        selb    $axis_y_6,$axis_y_5,$k_y,$c_z_3         # 122e
        selb    $own_y_5,$own_y_4,$origin_y_3,$c_z_3    # 123e
        selb    $own_z_5,$own_z,$origin_z_6,$c_z_3      # 124e
next_packet_back:
        brnz    $count,next_packet                      # 124o
next_packet_drain:
        selb    $own_x,$own_x,$origin_x_4,$c_z_2        # 0e
        hbr     shear_packets_r16_return,$lr            # 0o hint
        selb    $axis_x_9,$axis_x_5,$k_x,$c_z_4         # 1e
        stqd    $own_z_5,320($a_shear)                  # 1o
        fma     $slope_x,$t_e_11,$inverse_3,$slope_x_8  # 2e
        stqd    $own_x,208($a_shear)                    # 2o
        selb    $own_x_4,$own_x_2,$origin_x_3,$c_z_4    # 3e
        stqd    $axis_x_9,48($a_shear)                  # 3o
        selb    $own_z_6,$own_z_4,$origin_z_3,$c_z_4    # 4e
        lnop                                            # 4o pairing
        selb    $axis_x,$axis_x,$k_x,$c_z_2             # 5e
        stqd    $own_x_4,240($a_shear)                  # 5o
        selb    $own_z,$own_z_3,$origin_z_5,$c_z_2      # 6e
        stqd    $own_z_6,368($a_shear)                  # 6o
        selb    $axis_y,$axis_y_3,$k_y,$c_z             # 7e
        stqd    $own_y_5,256($a_shear)                  # 7o
        ai      $a_shear_2,$a_shear,288                 # 8e
        stqd    $axis_y_6,64($a_shear)                  # 8o
        nop     $127                                    # 9e pairing
        stqd    $slope_x,384($a_shear)                  # 9o
        ai      $a_shear_3,$a_shear_2,288               # 10e
        stqd    $axis_x,16($a_shear)                    # 10o
        stqd    $own_z,336($a_shear)                    # 11o
        stqd    $axis_y,96($a_shear)                    # 12o
        nop     $127                                    # 13e pairing
shear_packets_r16_return:
        bi      $lr                                     # 13o
next_packet_short:
        ai      $a_rays_3,$a_rays,320                   # 0e
        lqd     $direction_x,192($a_rays)               # 0o
        ai      $a_shear_4,$a_shear,288                 # 1e
        lqd     $direction_y,256($a_rays)               # 1o
        ai      $count,$count,-1                        # 2e
        lqd     $direction_x_5,208($a_rays)             # 2o
        lqd     $direction_y_5,272($a_rays)             # 3o
        lqd     $direction_z,320($a_rays)               # 4o
        lqd     $direction_z_6,336($a_rays)             # 5o
        lqd     $direction_x_6,224($a_rays)             # 6o
        fcmgt   $c_y,$direction_y,$direction_x          # 7e
        lqd     $direction_y_4,288($a_rays)             # 7o
        nop     $127                                    # 8e pairing
        lqd     $direction_z_7,352($a_rays)             # 8o
        fcmgt   $c_y_5,$direction_y_5,$direction_x_5    # 9e
        lqd     $direction_x_7,240($a_rays)             # 9o
        selb    $z,$direction_x,$direction_y,$c_y       # 10e
        lqd     $direction_y_3,304($a_rays)             # 10o
        selb    $z_5,$direction_x_5,$direction_y_5,$c_y_5 # 11e
        lqd     $direction_z_8,368($a_rays)             # 11o
        fcmgt   $c_z,$direction_z,$z                    # 12e
        lqd     $origin_x_6,0($a_rays)                  # 12o
        fcmgt   $c_z_5,$direction_z_6,$z_5              # 13e
        lqd     $origin_y_8,64($a_rays)                 # 13o
        selb    $z,$z,$direction_z,$c_z                 # 14e
        lqd     $origin_z_7,128($a_rays)                # 14o
        selb    $z_5,$z_5,$direction_z_6,$c_z_5         # 15e
        lqd     $origin_x_7,16($a_rays)                 # 15o
        fcmgt   $c_y_6,$direction_y_4,$direction_x_6    # 16e
        frest   $t_y,$z                                 # 16o
        fcmgt   $c_y_7,$direction_y_3,$direction_x_7    # 17e
        frest   $t_y_9,$z_5                             # 17o
        selb    $z_6,$direction_x_6,$direction_y_4,$c_y_6 # 18e
        lqd     $origin_y_3,80($a_rays)                 # 18o
        selb    $z_7,$direction_x_7,$direction_y_3,$c_y_7 # 19e
        lqd     $origin_z_8,144($a_rays)                # 19o
        fcmgt   $c_z_2,$direction_z_7,$z_6              # 20e
        lqd     $origin_x_3,32($a_rays)                 # 20o
        fi      $t_y,$z,$t_y                            # 21e
        lqd     $origin_y_9,96($a_rays)                 # 21o
        fi      $t_y_9,$z_5,$t_y_9                      # 22e
        lqd     $origin_z_3,160($a_rays)                # 22o
        selb    $z_6,$z_6,$direction_z_7,$c_z_2         # 23e
        lqd     $origin_x_8,48($a_rays)                 # 23o
        fcmgt   $c_z_6,$direction_z_8,$z_7              # 24e
        lqd     $origin_y_10,112($a_rays)               # 24o
        selb    $x_11,$direction_y,$direction_z,$c_y    # 25e
        frest   $t_y_10,$z_6                            # 25o
        selb    $z_7,$z_7,$direction_z_8,$c_z_6         # 26e
        lqd     $origin_z_9,176($a_rays)                # 26o
        selb    $y_6,$direction_z,$direction_x,$c_y     # 27e
        lnop                                            # 27o pairing
        fnms    $t_e_16,$z,$t_y,$k_one                  # 28e
        frest   $t_y_5,$z_7                             # 28o
        fnms    $t_e_17,$z_5,$t_y_9,$k_one              # 29e
        fi      $t_y_10,$z_6,$t_y_10                    # 30e
        selb    $x_12,$direction_y_5,$direction_z_6,$c_y_5 # 31e
        selb    $y_9,$direction_z_6,$direction_x_5,$c_y_5 # 32e
        fi      $t_y_5,$z_7,$t_y_5                      # 33e
        selb    $x_10,$x_11,$direction_x,$c_z           # 34e
        fma     $inverse_7,$t_e_16,$t_y,$t_y            # 35e
        fma     $inverse_8,$t_e_17,$t_y_9,$t_y_9        # 36e
        fnms    $t_e_18,$z_6,$t_y_10,$k_one             # 37e
        selb    $y_7,$y_6,$direction_y,$c_z             # 38e
        selb    $x_13,$x_12,$direction_x_5,$c_z_5       # 39e
        selb    $y_10,$y_9,$direction_y_5,$c_z_5        # 40e
        fm      $slope_x_9,$x_10,$inverse_7             # 41e
        fm      $slope_y_7,$y_7,$inverse_7              # 42e
        fm      $slope_x_10,$x_13,$inverse_8            # 43e
        fm      $slope_y_8,$y_10,$inverse_8             # 44e
        fma     $inverse_9,$t_e_18,$t_y_10,$t_y_10      # 45e
        selb    $x_14,$direction_y_4,$direction_z_7,$c_y_6 # 46e
        fnms    $t_e_19,$z_7,$t_y_5,$k_one              # 47e
        selb    $x_14,$x_14,$direction_x_6,$c_z_2       # 48e
        fnms    $t_e_14,$slope_x_9,$z,$x_10             # 49e
        fnms    $t_e_10,$slope_y_7,$z,$y_7              # 50e
        fnms    $t_e_15,$slope_x_10,$z_5,$x_13          # 51e
        fnms    $t_e_2,$slope_y_8,$z_5,$y_10            # 52e
        fm      $slope_x_11,$x_14,$inverse_9            # 53e
        selb    $y_11,$direction_z_7,$direction_x_6,$c_y_6 # 54e
        fma     $inverse_6,$t_e_19,$t_y_5,$t_y_5        # 55e
        selb    $y_11,$y_11,$direction_y_4,$c_z_2       # 56e
        selb    $x_15,$direction_y_3,$direction_z_8,$c_y_7 # 57e
        selb    $y_12,$direction_z_8,$direction_x_7,$c_y_7 # 58e
        fma     $slope_x_9,$t_e_14,$inverse_7,$slope_x_9 # 59e
        fma     $slope_y_9,$t_e_10,$inverse_7,$slope_y_7 # 60e
        fma     $slope_x_7,$t_e_15,$inverse_8,$slope_x_10 # 61e
        fma     $slope_y_10,$t_e_2,$inverse_8,$slope_y_8 # 62e
        fnms    $t_e_10,$slope_x_11,$z_6,$x_14          # 63e
        fm      $slope_y_7,$y_11,$inverse_9             # 64e
        selb    $x_15,$x_15,$direction_x_7,$c_z_6       # 65e
        stqd    $slope_x_9,384($a_shear)                # 65o
        selb    $y_9,$y_12,$direction_y_3,$c_z_6        # 66e
        stqd    $slope_y_9,448($a_shear)                # 66o
        selb    $axis_x_10,$k_y,$k_z,$c_y               # 67e
        stqd    $slope_x_7,400($a_shear)                # 67o
        selb    $axis_y,$k_z,$k_x,$c_y                  # 68e
        stqd    $slope_y_10,464($a_shear)               # 68o
        selb    $axis_z,$k_x,$k_y,$c_y                  # 69e
        selb    $own_x_6,$origin_y_8,$origin_z_7,$c_y   # 70e
        selb    $own_y,$origin_z_7,$origin_x_6,$c_y     # 71e
        selb    $own_z_6,$origin_x_6,$origin_y_8,$c_y   # 72e
        selb    $axis_x_11,$k_y,$k_z,$c_y_5             # 73e
        selb    $axis_y_8,$k_z,$k_x,$c_y_5              # 74e
        selb    $axis_z_9,$k_x,$k_y,$c_y_5              # 75e
        selb    $own_x_7,$origin_y_3,$origin_z_8,$c_y_5 # 76e
        selb    $own_y_10,$origin_z_8,$origin_x_7,$c_y_5 # 77e
        selb    $own_z_7,$origin_x_7,$origin_y_3,$c_y_5 # 78e
        fm      $slope_x_12,$x_15,$inverse_6            # 79e
        fm      $slope_y_11,$y_9,$inverse_6             # 80e
        xor     $minus_per_z_8,$inverse_7,$k_sign       # 81e
        selb    $axis_x_10,$axis_x_10,$k_x,$c_z         # 82e
        selb    $axis_y,$axis_y,$k_y,$c_z               # 83e
        stqd    $minus_per_z_8,512($a_shear)            # 83o
        selb    $axis_z,$axis_z,$k_z,$c_z               # 84e
        stqd    $axis_x_10,0($a_shear)                  # 84o
        selb    $own_x_6,$own_x_6,$origin_x_6,$c_z      # 85e
        stqd    $axis_y,64($a_shear)                    # 85o
        selb    $own_y,$own_y,$origin_y_8,$c_z          # 86e
        stqd    $axis_z,128($a_shear)                   # 86o
        selb    $own_z,$own_z_6,$origin_z_7,$c_z        # 87e
        stqd    $own_x_6,192($a_shear)                  # 87o
        xor     $minus_per_z,$inverse_8,$k_sign         # 88e
        stqd    $own_y,256($a_shear)                    # 88o
        selb    $axis_x_4,$axis_x_11,$k_x,$c_z_5        # 89e
        stqd    $own_z,320($a_shear)                    # 89o
        selb    $axis_y,$axis_y_8,$k_y,$c_z_5           # 90e
        stqd    $minus_per_z,528($a_shear)              # 90o
        selb    $axis_z,$axis_z_9,$k_z,$c_z_5           # 91e
        stqd    $axis_x_4,16($a_shear)                  # 91o
        selb    $own_x_6,$own_x_7,$origin_x_7,$c_z_5    # 92e
        stqd    $axis_y,80($a_shear)                    # 92o
        selb    $own_y,$own_y_10,$origin_y_3,$c_z_5     # 93e
        stqd    $axis_z,144($a_shear)                   # 93o
        selb    $own_z,$own_z_7,$origin_z_8,$c_z_5      # 94e
        stqd    $own_x_6,208($a_shear)                  # 94o
        fma     $slope_x,$t_e_10,$inverse_9,$slope_x_11 # 95e
        stqd    $own_y,272($a_shear)                    # 95o
        fnms    $t_e,$slope_y_7,$z_6,$y_11              # 96e
        stqd    $own_z,336($a_shear)                    # 96o
        fnms    $t_e_15,$slope_x_12,$z_7,$x_15          # 97e
        hbrr    next_packet_short_back,next_packet_short # 97o hint
        fnms    $t_e_2,$slope_y_11,$z_7,$y_9            # 98e
        selb    $axis_x,$k_y,$k_z,$c_y_6                # 99e
        selb    $axis_y,$k_z,$k_x,$c_y_6                # 100e
        lnop                                            # 100o pairing
        selb    $axis_z,$k_x,$k_y,$c_y_6                # 101e
        stqd    $slope_x,416($a_shear)                  # 101o
        fma     $slope_y,$t_e,$inverse_9,$slope_y_7     # 102e
        fma     $slope_x,$t_e_15,$inverse_6,$slope_x_12 # 103e
        fma     $slope_y_12,$t_e_2,$inverse_6,$slope_y_11 # 104e
        selb    $own_x,$origin_y_9,$origin_z_3,$c_y_6   # 105e
        selb    $own_y,$origin_z_3,$origin_x_3,$c_y_6   # 106e
        selb    $own_z,$origin_x_3,$origin_y_9,$c_y_6   # 107e
        selb    $axis_x_12,$k_y,$k_z,$c_y_7             # 108e
        stqd    $slope_y,480($a_shear)                  # 108o
        selb    $axis_y_9,$k_z,$k_x,$c_y_7              # 109e
        stqd    $slope_x,432($a_shear)                  # 109o
        selb    $axis_z_10,$k_x,$k_y,$c_y_7             # 110e
        stqd    $slope_y_12,496($a_shear)               # 110o
        selb    $own_x_6,$origin_y_10,$origin_z_9,$c_y_7 # 111e
        selb    $own_y_11,$origin_z_9,$origin_x_8,$c_y_7 # 112e
        selb    $own_z_8,$origin_x_8,$origin_y_10,$c_y_7 # 113e
        xor     $minus_per_z,$inverse_9,$k_sign         # 114e
        selb    $axis_x,$axis_x,$k_x,$c_z_2             # 115e
        lnop                                            # 115o pairing
        selb    $axis_y,$axis_y,$k_y,$c_z_2             # 116e
        stqd    $minus_per_z,544($a_shear)              # 116o
        selb    $axis_z,$axis_z,$k_z,$c_z_2             # 117e
        stqd    $axis_x,32($a_shear)                    # 117o
        selb    $own_x,$own_x,$origin_x_3,$c_z_2        # 118e
        stqd    $axis_y,96($a_shear)                    # 118o
        selb    $own_y,$own_y,$origin_y_9,$c_z_2        # 119e
        stqd    $axis_z,160($a_shear)                   # 119o
        selb    $own_z,$own_z,$origin_z_3,$c_z_2        # 120e
        stqd    $own_x,224($a_shear)                    # 120o
        xor     $minus_per_z,$inverse_6,$k_sign         # 121e
        stqd    $own_y,288($a_shear)                    # 121o
        selb    $axis_x,$axis_x_12,$k_x,$c_z_6          # 122e
        stqd    $own_z,352($a_shear)                    # 122o
        selb    $axis_y,$axis_y_9,$k_y,$c_z_6           # 123e
        stqd    $minus_per_z,560($a_shear)              # 123o
        selb    $axis_z,$axis_z_10,$k_z,$c_z_6          # 124e
        stqd    $axis_x,48($a_shear)                    # 124o
        selb    $own_x,$own_x_6,$origin_x_8,$c_z_6      # 125e
        stqd    $axis_y,112($a_shear)                   # 125o
        selb    $own_y,$own_y_11,$origin_y_10,$c_z_6    # 126e
        stqd    $axis_z,176($a_shear)                   # 126o
        selb    $own_z,$own_z_8,$origin_z_9,$c_z_6      # 127e
        stqd    $own_x,240($a_shear)                    # 127o
        ai      $a_rays,$a_rays_3,320                   # 128e
        stqd    $own_y,304($a_shear)                    # 128o
        nop     $127                                    # 129e pairing
        stqd    $own_z,368($a_shear)                    # 129o
        ai      $a_shear,$a_shear_4,288                 # 130e
next_packet_short_back:
        brnz    $count,next_packet_short                # 130o
        nop     $127                                    # 131e pairing
        bi      $lr                                     # 131o
endfunction shear_packets_r16
