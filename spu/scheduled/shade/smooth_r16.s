# smooth_r16   normals that shade, of those of sixteen hits that are on patches
#   C       void smooth_r16(const struct ray_packet *, struct surfaces *);
#   In      $3 rays, $4 surfaces; pointers 16-aligned. What a ray has hit is an address, of any
#           record
#   Out     surfaces: normal, where the object has SIDES_SMOOTH and so is a patch
#   Uses    $2-$64, $79   Saves  -   Stack  0   Calls  -
#   Domain  points in their patches; edges from 2^-30 to 2^30, and from 1/100 of the points'
#           distance from the eye on; |plane| about 1, the patch's own normal, on the ray's side
#   Error   3e-7 of 1, for the point as it is given; vertices' normals within 60 degrees of the
#           plane's
#   Twin    lab/twins/src/smooth.rs
#
# For the point p, the vertices a, b, c relative to p, their normals and the plane's normal g:
#   n = (g x b).c normal_a + (g x c).a normal_b + (g x a).b normal_c
# The shares of the area change their signs with g, so n points to the same side as g, which is the
# ray's side. If it nevertheless points away from the ray, n.d >= 0, it is replaced by g. Otherwise
# it is normalised.
# Scheduled by spu schedule from smooth_r16.s

        .include "work_unit.inc"
        .include "macros.inc"
        .include "math.inc"

        .set    NEXT,3
        registers a_rays,a_surfaces
        # constants
        .set    NEXT,10
        registers m_xy,m_zw,m_first,m_second,k_half,k_one,rows
        # the lanes' patches
        registers patch                                 # to 20
        .set    quad,21                                 # to 24
        .set    NEXT,25
        registers low,high,smooth
        # the row
        registers px,py,pz,gx,gy,gz,dx,dy,dz
        registers ax                                    # the vertices, then their normals
        registers ay,az,bx,by,bz,cx,cy,cz,turn_x,turn_y,turn_z,share_a,share_b,share_c,nx,ny,nz
        registers along,square,inverse,t_y,t_e,old_x,old_y,old_z

        .section .rodata
        .align  4
# The first and second words of A and B, alternating; the third and fourth; the first halves; the
# second halves.
transpose:
        .int    0x00010203,0x10111213,0x04050607,0x14151617
        .int    0x08090a0b,0x18191a1b,0x0c0d0e0f,0x1c1d1e1f
        .int    0x00010203,0x04050607,0x10111213,0x14151617
        .int    0x08090a0b,0x0c0d0e0f,0x18191a1b,0x1c1d1e1f

# Loads a vector of the four patches, with each component in a register.
.macro  gather x:req, y:req, z:req, offset:req
    .irp lane, 0,1,2,3
        lqd     $quad+\lane,\offset($patch+\lane)
    .endr
        shufb   $low,$quad,$quad+1,$m_xy
        shufb   $high,$quad+2,$quad+3,$m_xy
        shufb   \x,$low,$high,$m_first
        shufb   \y,$low,$high,$m_second
        shufb   $low,$quad,$quad+1,$m_zw
        shufb   $high,$quad+2,$quad+3,$m_zw
        shufb   \z,$low,$high,$m_first
.endm

# share = (g x from).to
.macro  share_of_area share:req, from:req, to:req
        fm      $turn_x,$gz,$\from\()y
        fm      $turn_y,$gx,$\from\()z
        fm      $turn_z,$gy,$\from\()x
        fms     $turn_x,$gy,$\from\()z,$turn_x
        fms     $turn_y,$gz,$\from\()x,$turn_y
        fms     $turn_z,$gx,$\from\()y,$turn_z
        fm      \share,$turn_x,$\to\()x
        fma     \share,$turn_y,$\to\()y,\share
        fma     \share,$turn_z,$\to\()z,\share
.endm

function smooth_r16
        .set rows_2,79; .set a_surfaces_2,2; .set gz_2,5; .set quad_2,8; .set quad3_2,9
        .set gx_2,6; .set quad_3,26; .set quad2_2,34; .set quad1_2,37; .set quad3_3,40
        .set high_2,7; .set low_2,38; .set quad3_4,25; .set quad_4,35; .set high_3,36; .set by_2,9
        .set quad1_3,23; .set quad2_3,39; .set low_3,41; .set low_4,8; .set high_4,43
        .set high_5,34; .set low_5,22; .set bz_2,8; .set high_6,42; .set low_6,21; .set bx_2,7
        .set ay_2,24; .set bx_3,38; .set ay_3,7; .set ax_2,36; .set turn_x_2,23; .set quad2_4,24
        .set quad3_5,26; .set quad2_5,27; .set quad1_4,29; .set turn_x_3,35; .set low_7,30
        .set quad_5,36; .set turn_y_2,41; .set high_7,40; .set turn_x_4,28; .set quad1_5,34
        .set high_8,46; .set turn_y_3,23; .set quad_6,50; .set turn_z_2,56; .set ax_3,52
        .set quad2_6,60; .set quad3_6,42; .set share_b_2,28; .set low_8,47; .set dz_2,43
        .set turn_z_3,51; .set dx_2,53; .set dy_2,33; .set ay_4,30; .set share_c_2,35
        .set high_9,24; .set share_b_3,25; .set low_9,7; .set high_10,22; .set share_c_3,9
        .set patch_2,23; .set ny_2,28; .set az_2,21; .set share_b_4,24; .set cx_2,25; .set gy_2,30
        .set low_10,27; .set nz_2,21; .set patch3_2,7; .set patch2_2,8; .set patch1_2,9
        .set ny_3,22; .set bz_3,26; .set quad_7,27; .set quad3_7,28; .set quad2_7,29
        .set quad1_6,24; .set nx_2,64; .set old_x_2,34; .set old_y_2,37; .set quad2_8,25
        .set quad1_7,31; .set high_11,21; .set py_2,35; .set quad3_8,36; .set by_3,32
        .set quad_8,39; .set high_12,28; .set quad2_9,42; .set low_11,44; .set low_12,24
        .set pz_2,27; .set bz_4,24; .set cy_2,28; .set low_13,45; .set turn_x_5,47; .set high_13,25
        .set low_14,26; .set px_2,40; .set bx_4,21; .set turn_x_6,48; .set cz_2,25; .set low_15,29
        .set ay_5,35; .set turn_y_4,38; .set quad1_8,42; .set az_3,26; .set turn_z_4,29
        .set quad3_9,44; .set quad_9,17; .set quad2_10,19; .set quad1_9,18; .set turn_x_7,27
        .set quad3_10,20; .set quad3_11,38; .set turn_y_5,40; .set quad2_11,46; .set quad1_10,50
        .set low_16,51; .set quad_10,52; .set turn_y_6,53; .set high_14,56; .set turn_z_5,57
        .set low_17,17; .set high_15,18; .set turn_x_8,19; .set quad1_11,20; .set share_b_5,27
        .set ax_4,47; .set inverse_2,48; .set smooth_2,17; .set quad_11,18; .set turn_z_6,60
        .set turn_y_7,36; .set quad2_12,44; .set share_c_4,21; .set quad3_12,19; .set turn_z_7,28
        .set low_18,39; .set ay_6,40; .set az_4,25; .set nx_3,35; .set bx_5,42; .set high_16,38
        .set share_b_6,26; .set quad_12,23; .set nz_3,8; .set bz_5,27; .set quad1_12,9
        .set quad3_13,7; .set cx_3,5; .set nx_4,21; .set low_19,43; .set ny_4,24; .set dx_3,25
        .set nx_5,6; .set old_x_3,61; .set old_y_3,63; .set low_20,5; .set gy_3,7; .set high_17,9
        .set ay_7,22; .set quad1_13,8; .set quad2_13,26; .set high_18,23; .set turn_y_8,25
        .set turn_x_9,21; .set quad3_14,35; .set low_21,34; .set az_5,8; .set bz_6,17; .set nx_6,22
        .set cx_4,20; .set ny_5,7; .set gy_4,2; .set a_surfaces_3,8; .set quad_13,2
        .set quad3_15,5; .set quad2_14,6; .set quad_14,7; .set quad3_16,27; .set high_19,5
        .set low_22,2; .set high_20,6; .set turn_x_10,8; .set quad1_14,5; .set turn_x_11,7
        .set quad3_17,8; .set turn_y_9,9; .set high_21,27; .set quad_15,30; .set quad1_15,7
        .set ax_5,9; .set turn_y_10,34; .set high_22,35; .set ay_8,25; .set turn_z_8,9
        .set by_4,23; .set high_23,2; .set bz_7,5
        il      $rows,4                                 # 0e
        lqa     $m_xy,transpose                         # 0o
        ilhu    $k_half,0x3f00                          # 1e
        lqa     $m_zw,transpose+16                      # 1o
        clgti   $rows_2,$rows,2                         # 2e at least as many passes as overlap
        lqa     $m_first,transpose+32                   # 2o
        ilhu    $k_one,0x3f80                           # 3e
        lqa     $m_second,transpose+48                  # 3o
        nop     $127                                    # 4e pairing
        brz     $rows_2,next_row_short                  # 4o too few passes
        ori     $a_surfaces_2,$a_surfaces,0             # 5e copy
        lqd     $patch,448($a_rays)                     # 5o
        ai      $rows,$rows,-1                          # 6e
        lqd     $py,64($a_surfaces)                     # 6o
        nop     $127                                    # 7e pairing
        lqd     $gz,512($a_surfaces)                    # 7o
        ai      $rows,$rows,-1                          # 8e
        lqd     $pz,128($a_surfaces)                    # 8o
        lqd     $px,0($a_surfaces)                      # 9o
        lqd     $gx,384($a_surfaces)                    # 10o
        rotqbyi $patch+3,$patch,12                      # 11o
        rotqbyi $patch+2,$patch,8                       # 12o
        ori     $gz_2,$gz,0                             # 13e copy
        rotqbyi $patch+1,$patch,4                       # 13o
        lqd     $quad_2,64($patch)                      # 14o
        lqd     $quad3_2,64($patch+3)                   # 15o
        ori     $gx_2,$gx,0                             # 16e copy
        lqd     $quad+2,64($patch+2)                    # 16o
        lqd     $quad+1,64($patch+1)                    # 17o
        lqd     $quad_3,80($patch)                      # 18o
        lqd     $quad2_2,80($patch+2)                   # 19o
        lqd     $quad1_2,80($patch+1)                   # 20o
        lqd     $quad3_3,80($patch+3)                   # 21o
        shufb   $high_2,$quad+2,$quad3_2,$m_xy          # 22o
        shufb   $low_2,$quad_2,$quad+1,$m_xy            # 23o
        lqd     $quad3_4,48($patch+3)                   # 24o
        lqd     $quad_4,48($patch)                      # 25o
        shufb   $high_3,$quad+2,$quad3_2,$m_zw          # 26o
        shufb   $by_2,$low_2,$high_2,$m_second          # 27o
        lqd     $quad1_3,48($patch+1)                   # 28o
        lqd     $quad2_3,48($patch+2)                   # 29o
        shufb   $low_3,$quad_3,$quad1_2,$m_xy           # 30o
        fs      $by_2,$by_2,$py                         # 31e
        shufb   $low_4,$quad_2,$quad+1,$m_zw            # 31o
        shufb   $high_4,$quad2_2,$quad3_3,$m_xy         # 32o
        shufb   $high_5,$quad2_2,$quad3_3,$m_zw         # 33o
        shufb   $low_5,$quad_4,$quad1_3,$m_xy           # 34o
        shufb   $bz_2,$low_4,$high_3,$m_first           # 35o
        nop     $127                                    # 36e pairing
        shufb   $cy,$low_3,$high_4,$m_second            # 36o
        fm      $turn_x,$gz,$by_2                       # 37e
        shufb   $high_6,$quad2_3,$quad3_4,$m_xy         # 37o
        nop     $127                                    # 38e pairing
        shufb   $low_6,$quad_3,$quad1_2,$m_zw           # 38o
        fs      $bz_2,$bz_2,$pz                         # 39e
        lqd     $gy,448($a_surfaces)                    # 39o
        fs      $cy,$cy,$py                             # 40e
        shufb   $bx_2,$low_2,$high_2,$m_first           # 40o
        shufb   $ay_2,$low_5,$high_6,$m_second          # 41o
        shufb   $cx,$low_3,$high_4,$m_first             # 42o
        nop     $127                                    # 43e pairing
        shufb   $cz,$low_6,$high_5,$m_first             # 43o
        fs      $bx_3,$bx_2,$px                         # 44e
        shufb   $high,$quad2_3,$quad3_4,$m_zw           # 44o
        fs      $ay_3,$ay_2,$py                         # 45e
        shufb   $low,$quad_4,$quad1_3,$m_zw             # 45o
        fm      $turn_y,$gx,$bz_2                       # 46e
        shufb   $ax_2,$low_5,$high_6,$m_first           # 46o
        fs      $cx,$cx,$px                             # 47e
        lqd     $quad,96($patch)                        # 47o
        fms     $turn_x,$gy,$bz_2,$turn_x               # 48e
        lqd     $quad+1,96($patch+1)                    # 48o
        fs      $cz,$cz,$pz                             # 49e
        shufb   $az,$low,$high,$m_first                 # 49o
        fm      $turn_x_2,$gz,$cy                       # 50e
        lqd     $quad2_4,96($patch+2)                   # 50o
        fm      $turn_z,$gy,$bx_3                       # 51e
        lqd     $quad3_4,96($patch+3)                   # 51o
        fs      $ax,$ax_2,$px                           # 52e
        lqd     $quad3_5,112($patch+3)                  # 52o
        fs      $az,$az,$pz                             # 53e
        lqd     $quad2_5,112($patch+2)                  # 53o
        fms     $turn_y,$gz,$bx_3,$turn_y               # 54e
        lqd     $quad1_4,112($patch+1)                  # 54o
        fm      $turn_x_3,$gz,$ay_3                     # 55e
        shufb   $low_7,$quad,$quad+1,$m_xy              # 55o
        fm      $share_a,$turn_x,$cx                    # 56e
        lqd     $quad_5,112($patch)                     # 56o
        fm      $turn_y_2,$gx,$cz                       # 57e
        shufb   $high_7,$quad2_4,$quad3_4,$m_xy         # 57o
        fms     $turn_x_4,$gy,$cz,$turn_x_2             # 58e
        lqd     $quad1_5,128($patch+1)                  # 58o
        fms     $turn_z,$gx,$by_2,$turn_z               # 59e
        shufb   $high_8,$quad2_5,$quad3_5,$m_xy         # 59o
        fm      $turn_y_3,$gx,$az                       # 60e
        lqd     $quad_6,128($patch)                     # 60o
        fm      $turn_z_2,$gy,$cx                       # 61e
        shufb   $ax_3,$low_7,$high_7,$m_first           # 61o
        fma     $share_a,$turn_y,$cy,$share_a           # 62e
        lqd     $quad2_6,128($patch+2)                  # 62o
        fms     $turn_x_3,$gy,$az,$turn_x_3             # 63e
        lqd     $quad3_6,128($patch+3)                  # 63o
        fm      $share_b_2,$turn_x_4,$ax                # 64e
        shufb   $low_8,$quad_5,$quad1_4,$m_xy           # 64o
        fms     $turn_y_2,$gz,$cx,$turn_y_2             # 65e
        lqd     $dz_2,320($a_rays)                      # 65o
        fm      $turn_z_3,$gy,$ax                       # 66e
        lqd     $dx_2,192($a_rays)                      # 66o
        fms     $turn_y_3,$gz,$ax,$turn_y_3             # 67e
        lqd     $dy_2,256($a_rays)                      # 67o
        fma     $share_a,$turn_z,$cz,$share_a           # 68e
        shufb   $ay_4,$low_7,$high_7,$m_second          # 68o
        fm      $share_c_2,$turn_x_3,$bx_3              # 69e
        shufb   $bx,$low_8,$high_8,$m_first             # 69o
        fms     $turn_z,$gx,$cy,$turn_z_2               # 70e
        shufb   $high_9,$quad2_4,$quad3_4,$m_zw         # 70o
        fma     $share_b_3,$turn_y_2,$ay_3,$share_b_2   # 71e
        shufb   $low_6,$quad,$quad+1,$m_zw              # 71o
        fms     $turn_z_3,$gx,$ay_3,$turn_z_3           # 72e
        shufb   $low_9,$quad_6,$quad1_5,$m_xy           # 72o
        ai      $a_rays,$a_rays,16                      # 73e
        shufb   $high_10,$quad2_6,$quad3_6,$m_xy        # 73o
        fm      $nx,$share_a,$ax_3                      # 74e
        shufb   $by,$low_8,$high_8,$m_second            # 74o
        fma     $share_c_3,$turn_y_3,$by_2,$share_c_2   # 75e
        lqd     $patch_2,448($a_rays)                   # 75o
        fm      $ny_2,$share_a,$ay_4                    # 76e
        shufb   $az_2,$low_6,$high_9,$m_first           # 76o
        fma     $share_b_4,$turn_z,$az,$share_b_3       # 77e
        shufb   $cx_2,$low_9,$high_10,$m_first          # 77o
        ori     $gy_2,$gy,0                             # 78e copy
        shufb   $high,$quad2_5,$quad3_5,$m_zw           # 78o
        nop     $127                                    # 79e pairing
        shufb   $low_10,$quad_5,$quad1_4,$m_zw          # 79o
        fm      $nz_2,$share_a,$az_2                    # 80e
        shufb   $cy,$low_9,$high_10,$m_second           # 80o
        fma     $share_c,$turn_z_3,$bz_2,$share_c_3     # 81e
        rotqbyi $patch3_2,$patch_2,12                   # 81o
        nop     $127                                    # 82e pairing
        rotqbyi $patch2_2,$patch_2,8                    # 82o
        fma     $nx,$share_b_4,$bx,$nx                  # 83e
        rotqbyi $patch1_2,$patch_2,4                    # 83o
        fma     $ny_3,$share_b_4,$by,$ny_2              # 84e
        shufb   $bz_3,$low_10,$high,$m_first            # 84o
        lqd     $quad_7,64($patch_2)                    # 85o
        lqd     $quad3_7,64($patch3_2)                  # 86o
        nop     $127                                    # 87e pairing
        lqd     $quad2_7,64($patch2_2)                  # 87o
        fma     $nz_2,$share_b_4,$bz_3,$nz_2            # 88e
        lqd     $quad1_6,64($patch1_2)                  # 88o
        fma     $nx_2,$share_c,$cx_2,$nx                # 89e
        shufb   $low,$quad_6,$quad1_5,$m_zw             # 89o
        fma     $ny_3,$share_c,$cy,$ny_3                # 90e
        shufb   $high,$quad2_6,$quad3_6,$m_zw           # 90o
        lqd     $old_z,320($a_surfaces)                 # 91o
        lqd     $old_x_2,192($a_surfaces)               # 92o
        nop     $127                                    # 93e pairing
        lqd     $old_y_2,256($a_surfaces)               # 93o
        ai      $a_surfaces,$a_surfaces,16              # 94e
        shufb   $cz,$low,$high,$m_first                 # 94o
        fm      $square,$nx_2,$nx_2                     # 95e
        lqd     $quad_3,80($patch_2)                    # 95o
        fm      $along,$nx_2,$dx_2                      # 96e
        lqd     $quad2_8,80($patch2_2)                  # 96o
        nop     $127                                    # 97e pairing
        lqd     $quad1_7,80($patch1_2)                  # 97o
        fma     $nz,$share_c,$cz,$nz_2                  # 98e
        shufb   $high_11,$quad2_7,$quad3_7,$m_xy        # 98o
        shufb   $low_2,$quad_7,$quad1_6,$m_xy           # 99o
        lqd     $quad3_3,80($patch3_2)                  # 100o
        fma     $square,$ny_3,$ny_3,$square             # 101e
        lqd     $py_2,64($a_surfaces)                   # 101o
        fma     $along,$ny_3,$dy_2,$along               # 102e
        lqd     $quad3_8,48($patch3_2)                  # 102o
        shufb   $by_3,$low_2,$high_11,$m_second         # 103o
        lqd     $quad_8,48($patch_2)                    # 104o
        shufb   $high_12,$quad2_7,$quad3_7,$m_zw        # 105o
        lqd     $quad1_4,48($patch1_2)                  # 106o
        fs      $by,$by_3,$py_2                         # 107e
        lqd     $quad2_9,48($patch2_2)                  # 107o
        fma     $square,$nz,$nz,$square                 # 108e
        shufb   $low_11,$quad_3,$quad1_7,$m_xy          # 108o
        fma     $along,$nz,$dz_2,$along                 # 109e
        shufb   $low_12,$quad_7,$quad1_6,$m_zw          # 109o
        shufb   $high_4,$quad2_8,$quad3_3,$m_xy         # 110o
        lqd     $gz,512($a_surfaces)                    # 111o
        lqd     $pz_2,128($a_surfaces)                  # 112o
        shufb   $bz_4,$low_12,$high_12,$m_first         # 113o
        nop     $127                                    # 114e pairing
        shufb   $cy_2,$low_11,$high_4,$m_second         # 114o
        rotmai  $along,$along,-31                       # 115e
        shufb   $low_13,$quad_8,$quad1_4,$m_xy          # 115o
        nop     $127                                    # 116e pairing
        shufb   $high_8,$quad2_9,$quad3_8,$m_xy         # 116o
        fm      $turn_x_5,$gz,$by                       # 117e
        shufb   $high_13,$quad2_8,$quad3_3,$m_zw        # 117o
        fs      $bz_4,$bz_4,$pz_2                       # 118e
        shufb   $low_14,$quad_3,$quad1_7,$m_zw          # 118o
        fs      $cy_2,$cy_2,$py_2                       # 119e
        lqd     $px_2,0($a_surfaces)                    # 119o
        lqd     $gx,384($a_surfaces)                    # 120o
        lqd     $gy,448($a_surfaces)                    # 121o
        frsqest $t_y,$square                            # 122o
        shufb   $bx_4,$low_2,$high_11,$m_first          # 123o
        nop     $127                                    # 124e pairing
        shufb   $ay,$low_13,$high_8,$m_second           # 124o
        fm      $turn_x_6,$gz,$cy_2                     # 125e
        shufb   $cx,$low_11,$high_4,$m_first            # 125o
        fi      $t_y,$square,$t_y                       # 126e
        shufb   $cz_2,$low_14,$high_13,$m_first         # 126o
        nop     $127                                    # 127e pairing
        shufb   $high,$quad2_9,$quad3_8,$m_zw           # 127o
        fs      $bx_4,$bx_4,$px_2                       # 128e
        shufb   $low_15,$quad_8,$quad1_4,$m_zw          # 128o
        fs      $ay_5,$ay,$py_2                         # 129e
        shufb   $ax_2,$low_13,$high_8,$m_first          # 129o
        fm      $turn_y_4,$gx,$bz_4                     # 130e
        lqd     $quad_8,96($patch_2)                    # 130o
        fs      $cx,$cx,$px_2                           # 131e
        lqd     $quad1_8,96($patch1_2)                  # 131o
        fms     $turn_x,$gy,$bz_4,$turn_x_5             # 132e
        shufb   $az_3,$low_15,$high,$m_first            # 132o
        fs      $cz,$cz_2,$pz_2                         # 133e
        lqd     $quad2_8,96($patch2_2)                  # 133o
        fm      $turn_z_4,$gy,$bx_4                     # 134e
        lqd     $quad3_9,96($patch3_2)                  # 134o
        fs      $ax_2,$ax_2,$px_2                       # 135e
        lqd     $quad_9,32($patch)                      # 135o
        fs      $az_3,$az_3,$pz_2                       # 136e
        lqd     $quad2_10,32($patch+2)                  # 136o
        fms     $turn_y,$gz,$bx_4,$turn_y_4             # 137e
        lqd     $quad1_9,32($patch+1)                   # 137o
        fm      $turn_x_7,$gz,$ay_5                     # 138e
        lqd     $quad3_10,32($patch+3)                  # 138o
        fm      $share_a,$turn_x,$cx                    # 139e
        lqd     $quad3_11,112($patch3_2)                # 139o
        fm      $turn_y_5,$gx,$cz                       # 140e
        lqd     $quad2_11,112($patch2_2)                # 140o
        fms     $turn_x_6,$gy,$cz,$turn_x_6             # 141e
        lqd     $quad1_10,112($patch1_2)                # 141o
        fm      $t_e,$square,$t_y                       # 142e
        shufb   $low_16,$quad_8,$quad1_8,$m_xy          # 142o
        fms     $turn_z_4,$gx,$by,$turn_z_4             # 143e
        lqd     $quad_10,112($patch_2)                  # 143o
        fm      $turn_y_6,$gx,$az_3                     # 144e
        shufb   $high_14,$quad2_8,$quad3_9,$m_xy        # 144o
        fm      $turn_z_5,$gy,$cx                       # 145e
        shufb   $low_17,$quad_9,$quad1_9,$m_zw          # 145o
        fma     $share_a,$turn_y,$cy_2,$share_a         # 146e
        shufb   $high_15,$quad2_10,$quad3_10,$m_zw      # 146o
        fms     $turn_x_8,$gy,$az_3,$turn_x_7           # 147e
        lqd     $quad1_11,128($patch1_2)                # 147o
        fm      $share_b_5,$turn_x_6,$ax_2              # 148e
        shufb   $ax_4,$low_16,$high_14,$m_first         # 148o
        fms     $turn_y_5,$gz,$cx,$turn_y_5             # 149e
        shufb   $high_4,$quad2_11,$quad3_11,$m_xy       # 149o
        fm      $inverse_2,$t_y,$k_half                 # 150e
        shufb   $smooth_2,$low_17,$high_15,$m_second    # 150o
        fnms    $t_e,$t_e,$t_y,$k_one                   # 151e
        lqd     $quad_11,128($patch_2)                  # 151o
        fm      $turn_z_6,$gy,$ax_2                     # 152e
        shufb   $high_13,$quad2_8,$quad3_9,$m_zw        # 152o
        fms     $turn_y_7,$gz,$ax_2,$turn_y_6           # 153e
        lqd     $quad2_12,128($patch2_2)                # 153o
        fma     $share_a,$turn_z_4,$cz,$share_a         # 154e
        shufb   $low_15,$quad_8,$quad1_8,$m_zw          # 154o
        fm      $share_c_4,$turn_x_8,$bx_4              # 155e
        lqd     $quad3_12,128($patch3_2)                # 155o
        fms     $turn_z_7,$gx,$cy_2,$turn_z_5           # 156e
        shufb   $low_18,$quad_10,$quad1_10,$m_xy        # 156o
        fma     $share_b_5,$turn_y_5,$ay_5,$share_b_5   # 157e
        shufb   $ay_6,$low_16,$high_14,$m_second        # 157o
        fma     $inverse,$t_e,$inverse_2,$t_y           # 158e
        shufb   $az_4,$low_15,$high_13,$m_first         # 158o
        fms     $turn_z_3,$gx,$ay_5,$turn_z_6           # 159e
        shufb   $low_15,$quad_11,$quad1_11,$m_xy        # 159o
        fm      $nx_3,$share_a,$ax_4                    # 160e
        shufb   $bx_5,$low_18,$high_4,$m_first          # 160o
        fma     $share_c_4,$turn_y_7,$by,$share_c_4     # 161e
        shufb   $high_3,$quad2_11,$quad3_11,$m_zw       # 161o
        shli    $smooth_2,$smooth_2,2                   # 162e SIDES_SMOOTH becomes the sign
        shufb   $high_16,$quad2_12,$quad3_12,$m_xy      # 162o
        fma     $share_b_6,$turn_z_7,$az_3,$share_b_5   # 163e
        shufb   $low_10,$quad_10,$quad1_10,$m_zw        # 163o
        fm      $nz,$nz,$inverse                        # 164e
        shufb   $by,$low_18,$high_4,$m_second           # 164o
        fm      $ny_2,$share_a,$ay_6                    # 165e
        lqd     $quad_12,32($patch_2)                   # 165o
        rotmai  $smooth_2,$smooth_2,-31                 # 166e
        lqd     $quad2_3,32($patch2_2)                  # 166o
        fm      $nz_3,$share_a,$az_4                    # 167e
        shufb   $bz_5,$low_10,$high_3,$m_first          # 167o
        fma     $share_c,$turn_z_3,$bz_4,$share_c_4     # 168e
        lqd     $quad1_12,32($patch1_2)                 # 168o
        fma     $nx,$share_b_6,$bx_5,$nx_3              # 169e
        lqd     $quad3_13,32($patch3_2)                 # 169o
        selb    $nz,$gz_2,$nz,$along                    # 170e
        shufb   $cx_3,$low_15,$high_16,$m_first         # 170o
        fm      $nx_4,$nx_2,$inverse                    # 171e
        shufb   $low_19,$quad_11,$quad1_11,$m_zw        # 171o
        fm      $ny,$ny_3,$inverse                      # 172e
        shufb   $high_15,$quad2_12,$quad3_12,$m_zw      # 172o
        selb    $nz,$old_z,$nz,$smooth_2                # 173e
        lqd     $dz,320($a_rays)                        # 173o
        fma     $ny_4,$share_b_6,$by,$ny_2              # 174e
        lqd     $dx_3,192($a_rays)                      # 174o
        fma     $nz_3,$share_b_6,$bz_5,$nz_3            # 175e
        lqd     $dy,256($a_rays)                        # 175o
        fma     $nx_2,$share_c,$cx_3,$nx                # 176e
        lqd     $old_z,320($a_surfaces)                 # 176o
        selb    $nx_5,$gx_2,$nx_4,$along                # 177e
        stqd    $nz,320($a_surfaces_2)                  # 177o
        selb    $ny,$gy_2,$ny,$along                    # 178e
        lqd     $old_x_3,192($a_surfaces)               # 178o
        selb    $nx_5,$old_x_2,$nx_5,$smooth_2          # 179e
        lqd     $old_y_3,256($a_surfaces)               # 179o
        selb    $ny,$old_y_2,$ny,$smooth_2              # 180e
        shufb   $cz,$low_19,$high_15,$m_first           # 180o
        shufb   $cy,$low_15,$high_16,$m_second          # 181o
        shufb   $low_20,$quad_12,$quad1_12,$m_zw        # 182o
        nop     $127                                    # 183e pairing
        shufb   $high,$quad2_3,$quad3_13,$m_zw          # 183o
next_row:
            ai      $a_rays,$a_rays,16                  # 0e
            stqd    $ny,256($a_surfaces_2)              # 0o
            fma     $ny,$share_c,$cy,$ny_4              # 1e
            stqd    $nx_5,192($a_surfaces_2)            # 1o
            ori     $a_surfaces_2,$a_surfaces,0         # 2e copy
            shufb   $smooth,$low_20,$high,$m_second     # 2o
            ai      $a_surfaces,$a_surfaces,16          # 3e
        lqd     $patch,448($a_rays)                     # 3o
            ori     $gz_2,$gz,0                         # 4e copy
        hbrr    next_row_back,next_row                  # 4o hint
            fm      $square,$nx_2,$nx_2                 # 5e
        lqd     $px,0($a_surfaces)                      # 5o
            shli    $smooth,$smooth,2                   # 6e SIDES_SMOOTH becomes the sign
        lqd     $gz,512($a_surfaces)                    # 6o
            ori     $gx_2,$gx,0                         # 7e copy
        lqd     $gx,384($a_surfaces)                    # 7o
            ori     $gy_3,$gy,0                         # 8e copy
        lqd     $gy,448($a_surfaces)                    # 8o
            fma     $nz,$share_c,$cz,$nz_3              # 9e
        lqd     $py,64($a_surfaces)                     # 9o
            fm      $along,$nx_2,$dx_3                  # 10e
        lqd     $pz,128($a_surfaces)                    # 10o
            fma     $square,$ny,$ny,$square             # 11e
        lqd     $quad,96($patch)                        # 11o
            rotmai  $smooth,$smooth,-31                 # 12e
        rotqbyi $patch+3,$patch,12                      # 12o
        ai      $rows,$rows,-1                          # 13e
        rotqbyi $patch+2,$patch,8                       # 13o
        rotqbyi $patch+1,$patch,4                       # 14o
        lqd     $quad_2,64($patch)                      # 15o
            fma     $along,$ny,$dy,$along               # 16e
        lqd     $quad+3,112($patch+3)                   # 16o
            fma     $square,$nz,$nz,$square             # 17e
        lqd     $quad3_2,64($patch+3)                   # 17o
        lqd     $quad+2,64($patch+2)                    # 18o
        lqd     $quad+1,64($patch+1)                    # 19o
        lqd     $quad3_4,48($patch+3)                   # 20o
        lqd     $quad_3,80($patch)                      # 21o
            fma     $along,$nz,$dz,$along               # 22e
        lqd     $quad2_2,80($patch+2)                   # 22o
            frsqest $t_y,$square                        # 23o
        lqd     $quad_4,48($patch)                      # 24o
        shufb   $high_3,$quad+2,$quad3_2,$m_zw          # 25o
        lqd     $quad1_2,80($patch+1)                   # 26o
            fi      $t_y,$square,$t_y                   # 27e
        shufb   $high_17,$quad+2,$quad3_2,$m_xy         # 27o
            rotmai  $along,$along,-31                   # 28e
        lqd     $quad1_3,48($patch+1)                   # 28o
        shufb   $low_2,$quad_2,$quad+1,$m_xy            # 29o
        lqd     $quad2_3,48($patch+2)                   # 30o
        lqd     $quad3_3,80($patch+3)                   # 31o
        shufb   $low_3,$quad_3,$quad1_2,$m_xy           # 32o
        nop     $127                                    # 33e pairing
        shufb   $bx_5,$low_2,$high_17,$m_first          # 33o
            fm      $t_e,$square,$t_y                   # 34e
        shufb   $low_4,$quad_2,$quad+1,$m_zw            # 34o
            fm      $inverse,$t_y,$k_half               # 35e
        shufb   $by_2,$low_2,$high_17,$m_second         # 35o
        nop     $127                                    # 36e pairing
        shufb   $low_5,$quad_4,$quad1_3,$m_xy           # 36o
        fs      $bx_3,$bx_5,$px                         # 37e
        shufb   $high_6,$quad2_3,$quad3_4,$m_xy         # 37o
        nop     $127                                    # 38e pairing
        shufb   $high_4,$quad2_2,$quad3_3,$m_xy         # 38o
        fs      $by_2,$by_2,$py                         # 39e
        shufb   $bz_2,$low_4,$high_3,$m_first           # 39o
            fnms    $t_e,$t_e,$t_y,$k_one               # 40e
        shufb   $high_5,$quad2_2,$quad3_3,$m_zw         # 40o
        shufb   $ax_2,$low_5,$high_6,$m_first           # 41o
        shufb   $ay_7,$low_5,$high_6,$m_second          # 42o
        fs      $bz,$bz_2,$pz                           # 43e
        shufb   $cy,$low_3,$high_4,$m_second            # 43o
        fm      $turn_z,$gy,$bx_3                       # 44e
        shufb   $low_4,$quad_3,$quad1_2,$m_zw           # 44o
        fm      $turn_x,$gz,$by_2                       # 45e
        shufb   $high,$quad2_3,$quad3_4,$m_zw           # 45o
        fs      $ax,$ax_2,$px                           # 46e
        shufb   $cx,$low_3,$high_4,$m_first             # 46o
        fs      $cy,$cy,$py                             # 47e
        shufb   $low,$quad_4,$quad1_3,$m_zw             # 47o
        fs      $ay_7,$ay_7,$py                         # 48e
        shufb   $cz,$low_4,$high_5,$m_first             # 48o
        fm      $turn_y,$gx,$bz                         # 49e
        lqd     $quad1_13,96($patch+1)                  # 49o
        fms     $turn_z,$gx,$by_2,$turn_z               # 50e
        lqd     $quad+2,96($patch+2)                    # 50o
        fs      $cx,$cx,$px                             # 51e
        shufb   $az,$low,$high,$m_first                 # 51o
        fms     $turn_x,$gy,$bz,$turn_x                 # 52e
        lqd     $quad3_4,96($patch+3)                   # 52o
        fs      $cz,$cz,$pz                             # 53e
        lqd     $quad2_13,112($patch+2)                 # 53o
        fm      $turn_x_4,$gz,$cy                       # 54e
        lqd     $quad1_4,112($patch+1)                  # 54o
        fs      $az,$az,$pz                             # 55e
        shufb   $low_7,$quad,$quad1_13,$m_xy            # 55o
        fms     $turn_y,$gz,$bx_3,$turn_y               # 56e
        lqd     $quad1_5,128($patch+1)                  # 56o
        fm      $turn_x_3,$gz,$ay_7                     # 57e
        lqd     $quad_5,112($patch)                     # 57o
        fm      $share_a,$turn_x,$cx                    # 58e
        shufb   $high_7,$quad+2,$quad3_4,$m_xy          # 58o
        fm      $turn_y_2,$gx,$cz                       # 59e
        shufb   $high_8,$quad2_13,$quad+3,$m_xy         # 59o
        fms     $turn_x_4,$gy,$cz,$turn_x_4             # 60e
        lqd     $quad_6,128($patch)                     # 60o
        fm      $turn_z_3,$gy,$ax                       # 61e
        shufb   $high_18,$quad+2,$quad3_4,$m_zw         # 61o
        fm      $turn_y_8,$gx,$az                       # 62e
        shufb   $ax_3,$low_7,$high_7,$m_first           # 62o
        fm      $turn_z_2,$gy,$cx                       # 63e
        lqd     $quad2_6,128($patch+2)                  # 63o
        fma     $share_a,$turn_y,$cy,$share_a           # 64e
        shufb   $low_4,$quad,$quad1_13,$m_zw            # 64o
        fms     $turn_x_9,$gy,$az,$turn_x_3             # 65e
        lqd     $quad3_14,128($patch+3)                 # 65o
        fm      $share_b_2,$turn_x_4,$ax                # 66e
        shufb   $low_8,$quad_5,$quad1_4,$m_xy           # 66o
        fms     $turn_y_2,$gz,$cx,$turn_y_2             # 67e
        shufb   $low_19,$quad_6,$quad1_5,$m_zw          # 67o
        fms     $turn_z_3,$gx,$ay_7,$turn_z_3           # 68e
        shufb   $low_21,$quad_6,$quad1_5,$m_xy          # 68o
        fms     $turn_y_8,$gz,$ax,$turn_y_8             # 69e
        shufb   $ay_4,$low_7,$high_7,$m_second          # 69o
        fma     $share_a,$turn_z,$cz,$share_a           # 70e
        shufb   $high,$quad2_13,$quad+3,$m_zw           # 70o
        fm      $share_c_4,$turn_x_9,$bx_3              # 71e
        shufb   $az_5,$low_4,$high_18,$m_first          # 71o
        fms     $turn_z,$gx,$cy,$turn_z_2               # 72e
        shufb   $high_18,$quad2_6,$quad3_14,$m_xy       # 72o
        fma     $share_b,$turn_y_2,$ay_7,$share_b_2     # 73e
        shufb   $low_5,$quad_5,$quad1_4,$m_zw           # 73o
            fma     $inverse,$t_e,$inverse,$t_y         # 74e
        shufb   $by,$low_8,$high_8,$m_second            # 74o
        nop     $127                                    # 75e pairing
        shufb   $high_9,$quad2_6,$quad3_14,$m_zw        # 75o
        fm      $ny_2,$share_a,$ay_4                    # 76e
        shufb   $bx,$low_8,$high_8,$m_first             # 76o
        fma     $share_c_3,$turn_y_8,$by_2,$share_c_4   # 77e
        lqd     $quad,32($patch)                        # 77o
        fm      $nx,$share_a,$ax_3                      # 78e
        lqd     $dz,320($a_rays)                        # 78o
        fma     $share_b,$turn_z,$az,$share_b           # 79e
        lqd     $dx_3,192($a_rays)                      # 79o
        fm      $nz_3,$share_a,$az_5                    # 80e
        shufb   $bz_6,$low_5,$high,$m_first             # 80o
            fm      $nz,$nz,$inverse                    # 81e
        lqd     $quad2_10,32($patch+2)                  # 81o
            fm      $nx_6,$nx_2,$inverse                # 82e
        lqd     $quad1_9,32($patch+1)                   # 82o
        fma     $share_c,$turn_z_3,$bz,$share_c_3       # 83e
        lqd     $quad3_2,32($patch+3)                   # 83o
            fm      $ny,$ny,$inverse                    # 84e
        shufb   $cx_4,$low_21,$high_18,$m_first         # 84o
        fma     $nx,$share_b,$bx,$nx                    # 85e
        shufb   $cz,$low_19,$high_9,$m_first            # 85o
        fma     $ny_4,$share_b,$by,$ny_2                # 86e
        shufb   $cy,$low_21,$high_18,$m_second          # 86o
            selb    $nz,$gz_2,$nz,$along                # 87e
        lqd     $dy,256($a_rays)                        # 87o
        fma     $nz_3,$share_b,$bz_6,$nz_3              # 88e
        shufb   $low_20,$quad,$quad1_9,$m_zw            # 88o
            selb    $nz,$old_z,$nz,$smooth              # 89e
        shufb   $high,$quad2_10,$quad3_2,$m_zw          # 89o
            selb    $nx_5,$gx_2,$nx_6,$along            # 90e
        lqd     $old_z,320($a_surfaces)                 # 90o
            selb    $ny,$gy_3,$ny,$along                # 91e
            stqd    $nz,320($a_surfaces_2)              # 91o
            selb    $nx_5,$old_x_3,$nx_5,$smooth        # 92e
        lqd     $old_x_3,192($a_surfaces)               # 92o
            selb    $ny,$old_y_3,$ny,$smooth            # 93e
        lqd     $old_y_3,256($a_surfaces)               # 93o
        fma     $nx_2,$share_c,$cx_4,$nx                # 94e
next_row_back:
        brnz    $rows,next_row                          # 94o
next_row_drain:
        fma     $ny_5,$share_c,$cy,$ny_4                # 0e
        shufb   $smooth,$low_20,$high,$m_second         # 0o
        fm      $square,$nx_2,$nx_2                     # 1e
        hbr     smooth_r16_return,$lr                   # 1o hint
        fma     $nz,$share_c,$cz,$nz_3                  # 2e
        stqd    $ny,256($a_surfaces_2)                  # 2o
        fm      $along,$nx_2,$dx_3                      # 3e
        stqd    $nx_5,192($a_surfaces_2)                # 3o
        shli    $smooth,$smooth,2                       # 4e SIDES_SMOOTH becomes the sign
        ori     $gz_2,$gz,0                             # 5e copy
        ori     $gy_4,$gy,0                             # 6e copy
        fma     $square,$ny_5,$ny_5,$square             # 7e
        rotmai  $smooth,$smooth,-31                     # 8e
        fma     $along,$ny_5,$dy,$along                 # 9e
        ori     $gx_2,$gx,0                             # 10e copy
        ori     $a_surfaces_3,$a_surfaces,0             # 11e copy
        ai      $a_rays,$a_rays,16                      # 12e
        fma     $square,$nz,$nz,$square                 # 13e
        ai      $a_surfaces,$a_surfaces,16              # 14e
        fma     $along,$nz,$dz,$along                   # 15e
        frsqest $t_y,$square                            # 19o
        rotmai  $along,$along,-31                       # 21e
        fi      $t_y,$square,$t_y                       # 23e
        fm      $t_e,$square,$t_y                       # 30e
        fm      $inverse,$t_y,$k_half                   # 31e
        fnms    $t_e,$t_e,$t_y,$k_one                   # 36e
        fma     $inverse,$t_e,$inverse,$t_y             # 42e
        fm      $nz,$nz,$inverse                        # 48e
        fm      $ny,$ny_5,$inverse                      # 49e
        fm      $nx_6,$nx_2,$inverse                    # 50e
        selb    $nz,$gz_2,$nz,$along                    # 54e
        selb    $ny,$gy_4,$ny,$along                    # 55e
        selb    $nz,$old_z,$nz,$smooth                  # 56e
        selb    $nx_5,$gx_2,$nx_6,$along                # 57e
        selb    $ny,$old_y_3,$ny,$smooth                # 58e
        stqd    $nz,320($a_surfaces_3)                  # 58o
        selb    $nx_5,$old_x_3,$nx_5,$smooth            # 59e
        stqd    $ny,256($a_surfaces_3)                  # 60o
        stqd    $nx_5,192($a_surfaces_3)                # 61o
smooth_r16_return:
        bi      $lr                                     # 62o
next_row_short:
        ai      $rows,$rows,-1                          # 0e
        lqd     $patch,448($a_rays)                     # 0o
        lqd     $py,64($a_surfaces)                     # 1o
        lqd     $gz,512($a_surfaces)                    # 2o
        lqd     $pz,128($a_surfaces)                    # 3o
        lqd     $gx,384($a_surfaces)                    # 4o
        lqd     $px,0($a_surfaces)                      # 5o
        rotqbyi $patch+2,$patch,8                       # 6o
        rotqbyi $patch+3,$patch,12                      # 7o
        rotqbyi $patch+1,$patch,4                       # 8o
        lqd     $quad,64($patch)                        # 9o
        lqd     $quad+2,64($patch+2)                    # 10o
        lqd     $quad+3,64($patch+3)                    # 11o
        lqd     $quad+1,64($patch+1)                    # 12o
        lqd     $quad_13,80($patch)                     # 13o
        lqd     $quad3_15,80($patch+3)                  # 14o
        lqd     $quad2_14,80($patch+2)                  # 15o
        lqd     $quad_14,48($patch)                     # 16o
        shufb   $high,$quad+2,$quad+3,$m_xy             # 17o
        shufb   $low,$quad,$quad+1,$m_xy                # 18o
        lqd     $quad1_13,48($patch+1)                  # 19o
        lqd     $quad1_12,80($patch+1)                  # 20o
        shufb   $low_6,$quad,$quad+1,$m_zw              # 21o
        shufb   $by,$low,$high,$m_second                # 22o
        shufb   $high_10,$quad2_14,$quad3_15,$m_xy      # 23o
        lqd     $quad3_16,48($patch+3)                  # 24o
        nop     $127                                    # 25e pairing
        shufb   $high_18,$quad+2,$quad+3,$m_zw          # 25o
        fs      $by,$by,$py                             # 26e
        shufb   $low_12,$quad_13,$quad1_12,$m_xy        # 26o
        shufb   $high_19,$quad2_14,$quad3_15,$m_zw      # 27o
        lqd     $quad2_14,48($patch+2)                  # 28o
        shufb   $bz,$low_6,$high_18,$m_first            # 29o
        shufb   $cy,$low_12,$high_10,$m_second          # 30o
        nop     $127                                    # 31e pairing
        shufb   $bx,$low,$high,$m_first                 # 31o
        fm      $turn_x,$gz,$by                         # 32e
        shufb   $low,$quad_14,$quad1_13,$m_xy           # 32o
        fs      $bz,$bz,$pz                             # 33e
        shufb   $cx,$low_12,$high_10,$m_first           # 33o
        fs      $cy,$cy,$py                             # 34e
        lqd     $gy,448($a_surfaces)                    # 34o
        fs      $bx,$bx,$px                             # 35e
        shufb   $high,$quad2_14,$quad3_16,$m_xy         # 35o
        nop     $127                                    # 36e pairing
        shufb   $low_22,$quad_13,$quad1_12,$m_zw        # 36o
        fs      $cx,$cx,$px                             # 37e
        shufb   $low_9,$quad_14,$quad1_13,$m_zw         # 37o
        nop     $127                                    # 38e pairing
        shufb   $high_20,$quad2_14,$quad3_16,$m_zw      # 38o
        fm      $turn_y,$gx,$bz                         # 39e
        shufb   $ay,$low,$high,$m_second                # 39o
        fm      $turn_x_10,$gz,$cy                      # 40e
        shufb   $cz,$low_22,$high_19,$m_first           # 40o
        fms     $turn_x,$gy,$bz,$turn_x                 # 41e
        shufb   $ax,$low,$high,$m_first                 # 41o
        fm      $turn_z,$gy,$bx                         # 42e
        shufb   $az,$low_9,$high_20,$m_first            # 42o
        fs      $ay,$ay,$py                             # 43e
        lqd     $quad+1,96($patch+1)                    # 43o
        fs      $cz,$cz,$pz                             # 44e
        lqd     $quad+3,96($patch+3)                    # 44o
        fs      $ax,$ax,$px                             # 45e
        lqd     $quad,96($patch)                        # 45o
        fms     $turn_y,$gz,$bx,$turn_y                 # 46e
        lqd     $quad+2,96($patch+2)                    # 46o
        fm      $share_a,$turn_x,$cx                    # 47e
        lqd     $quad_13,112($patch)                    # 47o
        fs      $az,$az,$pz                             # 48e
        lqd     $quad1_14,112($patch+1)                 # 48o
        fm      $turn_x,$gz,$ay                         # 49e
        lqd     $quad2_14,112($patch+2)                 # 49o
        fms     $turn_x_11,$gy,$cz,$turn_x_10           # 50e
        lqd     $quad3_17,128($patch+3)                 # 50o
        fm      $turn_y_9,$gx,$cz                       # 51e
        shufb   $low,$quad,$quad+1,$m_xy                # 51o
        fms     $turn_z,$gx,$by,$turn_z                 # 52e
        lqd     $quad3_5,112($patch+3)                  # 52o
        fma     $share_a,$turn_y,$cy,$share_a           # 53e
        shufb   $high_21,$quad+2,$quad+3,$m_xy          # 53o
        fm      $turn_z_7,$gy,$cx                       # 54e
        shufb   $low_15,$quad_13,$quad1_14,$m_xy        # 54o
        fms     $turn_x,$gy,$az,$turn_x                 # 55e
        lqd     $quad_15,128($patch)                    # 55o
        fm      $share_b,$turn_x_11,$ax                 # 56e
        lqd     $quad1_15,128($patch+1)                 # 56o
        fms     $turn_y,$gz,$cx,$turn_y_9               # 57e
        shufb   $ax_5,$low,$high_21,$m_first            # 57o
        fm      $turn_y_10,$gx,$az                      # 58e
        shufb   $high_22,$quad2_14,$quad3_5,$m_xy       # 58o
        fma     $share_a,$turn_z,$cz,$share_a           # 59e
        shufb   $high_18,$quad+2,$quad+3,$m_zw          # 59o
        fms     $turn_z,$gx,$cy,$turn_z_7               # 60e
        lqd     $quad2_4,128($patch+2)                  # 60o
        fm      $turn_z_7,$gy,$ax                       # 61e
        shufb   $ay_8,$low,$high_21,$m_second           # 61o
        fm      $share_c,$turn_x,$bx                    # 62e
        shufb   $bx,$low_15,$high_22,$m_first           # 62o
        fma     $share_b,$turn_y,$ay,$share_b           # 63e
        shufb   $low_6,$quad,$quad+1,$m_zw              # 63o
        fms     $turn_y,$gz,$ax,$turn_y_10              # 64e
        shufb   $low_5,$quad_15,$quad1_15,$m_xy         # 64o
        fm      $nx,$share_a,$ax_5                      # 65e
        shufb   $high,$quad2_14,$quad3_5,$m_zw          # 65o
        fm      $ny,$share_a,$ay_8                      # 66e
        shufb   $high_20,$quad2_4,$quad3_17,$m_xy       # 66o
        fms     $turn_z_8,$gx,$ay,$turn_z_7             # 67e
        shufb   $az_2,$low_6,$high_18,$m_first          # 67o
        nop     $127                                    # 68e pairing
        shufb   $by_4,$low_15,$high_22,$m_second        # 68o
        fma     $share_b,$turn_z,$az,$share_b           # 69e
        shufb   $low,$quad_13,$quad1_14,$m_zw           # 69o
        fma     $share_c,$turn_y,$by,$share_c           # 70e
        shufb   $cx,$low_5,$high_20,$m_first            # 70o
        fm      $nz,$share_a,$az_2                      # 71e
        shufb   $high_23,$quad2_4,$quad3_17,$m_zw       # 71o
        shufb   $cy,$low_5,$high_20,$m_second           # 72o
        shufb   $bz_7,$low,$high,$m_first               # 73o
        nop     $127                                    # 74e pairing
        shufb   $low,$quad_15,$quad1_15,$m_zw           # 74o
        fma     $nx,$share_b,$bx,$nx                    # 75e
        lqd     $quad2_14,32($patch+2)                  # 75o
        fma     $share_c,$turn_z_8,$bz,$share_c         # 76e
        lqd     $quad+3,32($patch+3)                    # 76o
        fma     $ny,$share_b,$by_4,$ny                  # 77e
        lqd     $quad+1,32($patch+1)                    # 77o
        fma     $nz,$share_b,$bz_7,$nz                  # 78e
        shufb   $cz,$low,$high_23,$m_first              # 78o
        lqd     $dx,192($a_rays)                        # 79o
        lqd     $dy,256($a_rays)                        # 80o
        nop     $127                                    # 81e pairing
        lqd     $quad,32($patch)                        # 81o
        fma     $nx,$share_c,$cx,$nx                    # 82e
        shufb   $high,$quad2_14,$quad+3,$m_zw           # 82o
        fma     $ny,$share_c,$cy,$ny                    # 83e
        lqd     $dz,320($a_rays)                        # 83o
        fma     $nz,$share_c,$cz,$nz                    # 84e
        lqd     $old_x,192($a_surfaces)                 # 84o
        ai      $a_rays,$a_rays,16                      # 85e
        lqd     $old_y,256($a_surfaces)                 # 85o
        lqd     $old_z,320($a_surfaces)                 # 86o
        shufb   $low,$quad,$quad+1,$m_zw                # 87o
        fm      $square,$nx,$nx                         # 88e
        fm      $along,$nx,$dx                          # 89e
        shufb   $smooth,$low,$high,$m_second            # 91o
        fma     $square,$ny,$ny,$square                 # 94e
        shli    $smooth,$smooth,2                       # 95e SIDES_SMOOTH becomes the sign
        fma     $along,$ny,$dy,$along                   # 96e
        rotmai  $smooth,$smooth,-31                     # 99e
        hbrr    next_row_short_back,next_row_short      # 99o hint
        fma     $square,$nz,$nz,$square                 # 100e
        fma     $along,$nz,$dz,$along                   # 102e
        frsqest $t_y,$square                            # 106o
        rotmai  $along,$along,-31                       # 108e
        fi      $t_y,$square,$t_y                       # 110e
        fm      $t_e,$square,$t_y                       # 117e
        fm      $inverse,$t_y,$k_half                   # 118e
        fnms    $t_e,$t_e,$t_y,$k_one                   # 123e
        fma     $inverse,$t_e,$inverse,$t_y             # 129e
        fm      $ny,$ny,$inverse                        # 135e
        fm      $nx,$nx,$inverse                        # 136e
        fm      $nz,$nz,$inverse                        # 137e
        selb    $ny,$gy,$ny,$along                      # 141e
        selb    $nx,$gx,$nx,$along                      # 142e
        selb    $ny,$old_y,$ny,$smooth                  # 143e
        selb    $nz,$gz,$nz,$along                      # 144e
        selb    $nx,$old_x,$nx,$smooth                  # 145e
        stqd    $ny,256($a_surfaces)                    # 145o
        selb    $nz,$old_z,$nz,$smooth                  # 146e
        stqd    $nx,192($a_surfaces)                    # 147o
        nop     $127                                    # 148e pairing
        stqd    $nz,320($a_surfaces)                    # 148o
        ai      $a_surfaces,$a_surfaces,16              # 149e
next_row_short_back:
        brnz    $rows,next_row_short                    # 149o
        nop     $127                                    # 150e pairing
        bi      $lr                                     # 150o
endfunction smooth_r16
