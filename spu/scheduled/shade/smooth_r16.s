# smooth_r16   normals that shade, of those of sixteen hits that are on patches
#   C       void smooth_r16(const struct ray_packet *, struct surfaces *);
#   In      $3 rays, $4 surfaces; pointers 16-aligned. What a ray has hit is an address, of any
#           record
#   Out     surfaces: normal, where the object has SIDES_SMOOTH and so is a patch
#   Uses    $2-$63, $79   Saves  -   Stack  0   Calls  -
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
        .set rows_2,79; .set a_surfaces_2,7; .set patch_2,8; .set patch1_2,9; .set gz_2,5
        .set gx_2,6; .set quad3_2,2; .set quad1_2,17; .set quad_2,25; .set quad2_2,26
        .set low_2,35; .set high_2,36; .set quad1_3,34; .set quad2_3,37; .set low_3,38
        .set high_3,39; .set quad3_3,40; .set high_4,2; .set low_4,21; .set quad_3,22
        .set high_5,23; .set low_5,2; .set bx_2,17; .set turn_x_2,18; .set high_6,22; .set quad_4,2
        .set quad1_4,25; .set quad2_4,21; .set quad3_4,22; .set quad1_5,26; .set turn_y_2,30
        .set quad_5,29; .set high_7,28; .set turn_x_3,35; .set low_6,18; .set turn_z_2,50
        .set quad2_5,27; .set turn_y_3,51; .set ax_2,40; .set share_b_2,46; .set low_7,47
        .set quad3_5,52; .set quad_6,56; .set turn_z_3,43; .set ay_2,18; .set bx_3,28; .set dz_2,44
        .set turn_y_4,37; .set dx_2,33; .set turn_z_4,24; .set nx_2,30; .set high_8,31
        .set ny_2,40; .set by_2,43; .set gy_2,2; .set cx_2,36; .set high_9,21; .set cy_2,22
        .set patch2_2,23; .set nx_3,24; .set patch3_2,25; .set bz_2,21; .set quad_7,26
        .set quad1_6,28; .set quad2_6,29; .set quad3_6,30; .set low_8,22; .set quad3_7,21
        .set quad_8,27; .set quad2_7,31; .set low_9,36; .set high_10,37; .set quad2_8,32
        .set quad_9,35; .set py_2,38; .set low_10,39; .set high_11,42; .set high_12,29
        .set low_11,26; .set low_12,30; .set pz_2,43; .set bz_3,26; .set ay_3,29; .set low_13,27
        .set bz_4,34; .set px_2,29; .set cx_3,39; .set turn_x_4,36; .set az_2,26; .set cx_4,21
        .set quad2_9,19; .set quad3_8,20; .set quad_10,8; .set quad_11,9; .set quad3_9,26
        .set high_13,19; .set low_14,8; .set quad2_10,20; .set quad1_7,29; .set quad1_8,43
        .set quad2_11,50; .set turn_z_5,52; .set low_15,56; .set quad3_10,47; .set quad_12,63
        .set smooth_2,8; .set ay_4,21; .set turn_z_6,19; .set ax_3,42; .set high_14,56
        .set share_b_3,20; .set high_15,40; .set low_16,44; .set turn_z_7,9; .set low_17,29
        .set ny_3,21; .set high_16,41; .set ny_4,28; .set dz_3,37; .set nz_2,23; .set bx_4,8
        .set bz_5,9; .set ny_5,2; .set nz_3,5; .set nx_4,6; .set nz_4,2; .set nx_5,5
        .set quad3_11,8; .set quad1_9,9; .set high_17,8; .set low_18,9; .set turn_x_5,22
        .set quad2_12,8; .set quad3_12,9; .set quad2_13,22; .set share_b_4,29; .set quad3_13,46
        .set gy_3,5; .set old_x_2,2; .set gz_3,9; .set gx_3,10; .set ny_6,3; .set nz_5,4
        .set quad3_14,5; .set quad2_14,6; .set quad_13,7; .set quad1_10,8; .set quad3_15,27
        .set low_19,24; .set high_18,5; .set low_20,7; .set high_19,6; .set turn_x_6,8
        .set quad1_11,5; .set turn_x_7,7; .set turn_y_5,9; .set high_20,27; .set turn_z_8,28
        .set quad_14,30; .set quad1_12,7; .set ax_4,9; .set turn_y_6,34; .set high_21,35
        .set quad2_15,24; .set ay_5,25; .set az_3,21; .set by_3,23; .set bz_6,5
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
        lqd     $patch_2,448($a_rays)                   # 5o
        ai      $rows,$rows,-1                          # 6e
        lqd     $py,64($a_surfaces)                     # 6o
        nop     $127                                    # 7e pairing
        lqd     $gz,512($a_surfaces)                    # 7o
        ai      $rows,$rows,-1                          # 8e
        lqd     $pz,128($a_surfaces)                    # 8o
        lqd     $px,0($a_surfaces)                      # 9o
        lqd     $gx,384($a_surfaces)                    # 10o
        rotqbyi $patch+2,$patch_2,8                     # 11o
        rotqbyi $patch1_2,$patch_2,4                    # 12o
        ori     $gz_2,$gz,0                             # 13e copy
        rotqbyi $patch+3,$patch_2,12                    # 13o
        lqd     $quad,64($patch_2)                      # 14o
        lqd     $quad+2,64($patch+2)                    # 15o
        ori     $gx_2,$gx,0                             # 16e copy
        lqd     $quad+1,64($patch1_2)                   # 16o
        lqd     $quad3_2,64($patch+3)                   # 17o
        lqd     $quad+3,80($patch+3)                    # 18o
        lqd     $quad1_2,80($patch1_2)                  # 19o
        lqd     $quad_2,80($patch_2)                    # 20o
        lqd     $quad2_2,80($patch+2)                   # 21o
        shufb   $low_2,$quad,$quad+1,$m_xy              # 22o
        shufb   $high_2,$quad+2,$quad3_2,$m_xy          # 23o
        lqd     $quad1_3,48($patch1_2)                  # 24o
        lqd     $quad2_3,48($patch+2)                   # 25o
        shufb   $low_3,$quad_2,$quad1_2,$m_xy           # 26o
        shufb   $by,$low_2,$high_2,$m_second            # 27o
        shufb   $high_3,$quad2_2,$quad+3,$m_xy          # 28o
        lqd     $quad3_3,48($patch+3)                   # 29o
        shufb   $high_4,$quad+2,$quad3_2,$m_zw          # 30o
        fs      $by,$by,$py                             # 31e
        shufb   $low_4,$quad,$quad+1,$m_zw              # 31o
        lqd     $quad_3,48($patch_2)                    # 32o
        shufb   $cy,$low_3,$high_3,$m_second            # 33o
        shufb   $high,$quad2_2,$quad+3,$m_zw            # 34o
        shufb   $bz,$low_4,$high_4,$m_first             # 35o
        nop     $127                                    # 36e pairing
        shufb   $high_5,$quad2_3,$quad3_3,$m_xy         # 36o
        fs      $cy,$cy,$py                             # 37e
        shufb   $low,$quad_2,$quad1_2,$m_zw             # 37o
        fm      $turn_x,$gz,$by                         # 38e
        shufb   $low_5,$quad_3,$quad1_3,$m_xy           # 38o
        fs      $bz,$bz,$pz                             # 39e
        lqd     $gy,448($a_surfaces)                    # 39o
        shufb   $cx,$low_3,$high_3,$m_first             # 40o
        shufb   $bx_2,$low_2,$high_2,$m_first           # 41o
        nop     $127                                    # 42e pairing
        shufb   $ay,$low_5,$high_5,$m_second            # 42o
        fm      $turn_x_2,$gz,$cy                       # 43e
        shufb   $cz,$low,$high,$m_first                 # 43o
        fs      $cx,$cx,$px                             # 44e
        shufb   $low_4,$quad_3,$quad1_3,$m_zw           # 44o
        fs      $bx_2,$bx_2,$px                         # 45e
        shufb   $high_6,$quad2_3,$quad3_3,$m_zw         # 45o
        fm      $turn_y,$gx,$bz                         # 46e
        shufb   $ax,$low_5,$high_5,$m_first             # 46o
        fms     $turn_x,$gy,$bz,$turn_x                 # 47e
        lqd     $quad_4,96($patch_2)                    # 47o
        fs      $ay,$ay,$py                             # 48e
        lqd     $quad+3,96($patch+3)                    # 48o
        fs      $cz,$cz,$pz                             # 49e
        shufb   $az,$low_4,$high_6,$m_first             # 49o
        fs      $ax,$ax,$px                             # 50e
        lqd     $quad+2,96($patch+2)                    # 50o
        fm      $turn_z,$gy,$bx_2                       # 51e
        lqd     $quad1_4,96($patch1_2)                  # 51o
        fms     $turn_y,$gz,$bx_2,$turn_y               # 52e
        lqd     $quad2_4,112($patch+2)                  # 52o
        fs      $az,$az,$pz                             # 53e
        lqd     $quad3_4,112($patch+3)                  # 53o
        fm      $share_a,$turn_x,$cx                    # 54e
        lqd     $quad1_5,112($patch1_2)                 # 54o
        fm      $turn_y_2,$gx,$cz                       # 55e
        lqd     $quad_5,112($patch_2)                   # 55o
        fms     $turn_x,$gy,$cz,$turn_x_2               # 56e
        shufb   $high_7,$quad+2,$quad+3,$m_xy           # 56o
        fm      $turn_x_3,$gz,$ay                       # 57e
        shufb   $low_6,$quad_4,$quad1_4,$m_xy           # 57o
        fm      $turn_z_2,$gy,$cx                       # 58e
        lqd     $quad1_3,128($patch1_2)                 # 58o
        fms     $turn_z,$gx,$by,$turn_z                 # 59e
        lqd     $quad2_5,128($patch+2)                  # 59o
        fma     $share_a,$turn_y,$cy,$share_a           # 60e
        shufb   $high_2,$quad2_4,$quad3_4,$m_xy         # 60o
        fm      $turn_y_3,$gx,$az                       # 61e
        shufb   $ax_2,$low_6,$high_7,$m_first           # 61o
        fm      $share_b_2,$turn_x,$ax                  # 62e
        shufb   $low_7,$quad_5,$quad1_5,$m_xy           # 62o
        fms     $turn_x_3,$gy,$az,$turn_x_3             # 63e
        lqd     $quad3_5,128($patch+3)                  # 63o
        fms     $turn_y_2,$gz,$cx,$turn_y_2             # 64e
        lqd     $quad_6,128($patch_2)                   # 64o
        fm      $turn_z_3,$gy,$ax                       # 65e
        shufb   $ay_2,$low_6,$high_7,$m_second          # 65o
        fma     $share_a,$turn_z,$cz,$share_a           # 66e
        shufb   $bx_3,$low_7,$high_2,$m_first           # 66o
        fms     $turn_z,$gx,$cy,$turn_z_2               # 67e
        lqd     $dz_2,320($a_rays)                      # 67o
        fms     $turn_y_4,$gz,$ax,$turn_y_3             # 68e
        lqd     $dx_2,192($a_rays)                      # 68o
        fm      $share_c,$turn_x_3,$bx_2                # 69e
        lqd     $dy,256($a_rays)                        # 69o
        fma     $share_b,$turn_y_2,$ay,$share_b_2       # 70e
        shufb   $high_5,$quad+2,$quad+3,$m_zw           # 70o
        fms     $turn_z_4,$gx,$ay,$turn_z_3             # 71e
        shufb   $low,$quad_4,$quad1_4,$m_zw             # 71o
        fm      $nx_2,$share_a,$ax_2                    # 72e
        shufb   $high_8,$quad2_5,$quad3_5,$m_xy         # 72o
        ai      $a_rays,$a_rays,16                      # 73e
        shufb   $low_3,$quad_6,$quad1_3,$m_xy           # 73o
        fm      $ny_2,$share_a,$ay_2                    # 74e
        shufb   $by_2,$low_7,$high_2,$m_second          # 74o
        fma     $share_c,$turn_y_4,$by,$share_c         # 75e
        lqd     $patch,448($a_rays)                     # 75o
        fma     $share_b,$turn_z,$az,$share_b           # 76e
        shufb   $az,$low,$high_5,$m_first               # 76o
        ori     $gy_2,$gy,0                             # 77e copy
        shufb   $cx_2,$low_3,$high_8,$m_first           # 77o
        shufb   $high_9,$quad2_4,$quad3_4,$m_zw         # 78o
        shufb   $low_7,$quad_5,$quad1_5,$m_zw           # 79o
        fm      $nz,$share_a,$az                        # 80e
        shufb   $cy_2,$low_3,$high_8,$m_second          # 80o
        fma     $share_c,$turn_z_4,$bz,$share_c         # 81e
        rotqbyi $patch2_2,$patch,8                      # 81o
        fma     $nx_3,$share_b,$bx_3,$nx_2              # 82e
        rotqbyi $patch+1,$patch,4                       # 82o
        fma     $ny,$share_b,$by_2,$ny_2                # 83e
        rotqbyi $patch3_2,$patch,12                     # 83o
        shufb   $bz_2,$low_7,$high_9,$m_first           # 84o
        lqd     $quad_7,64($patch)                      # 85o
        lqd     $quad1_6,64($patch+1)                   # 86o
        lqd     $quad2_6,64($patch2_2)                  # 87o
        fma     $nx_3,$share_c,$cx_2,$nx_3              # 88e
        lqd     $quad3_6,64($patch3_2)                  # 88o
        fma     $ny,$share_c,$cy_2,$ny                  # 89e
        shufb   $low_8,$quad_6,$quad1_3,$m_zw           # 89o
        fma     $nz,$share_b,$bz_2,$nz                  # 90e
        shufb   $high_9,$quad2_5,$quad3_5,$m_zw         # 90o
        lqd     $old_y,256($a_surfaces)                 # 91o
        lqd     $old_z,320($a_surfaces)                 # 92o
        nop     $127                                    # 93e pairing
        lqd     $old_x,192($a_surfaces)                 # 93o
        fm      $square,$nx_3,$nx_3                     # 94e
        shufb   $cz,$low_8,$high_9,$m_first             # 94o
        ai      $a_surfaces,$a_surfaces,16              # 95e
        lqd     $quad3_7,80($patch3_2)                  # 95o
        fm      $along,$nx_3,$dx_2                      # 96e
        lqd     $quad+1,80($patch+1)                    # 96o
        nop     $127                                    # 97e pairing
        lqd     $quad_8,80($patch)                      # 97o
        fma     $nz,$share_c,$cz,$nz                    # 98e
        lqd     $quad2_7,80($patch2_2)                  # 98o
        nop     $127                                    # 99e pairing
        lqd     $quad1_3,48($patch+1)                   # 99o
        fma     $square,$ny,$ny,$square                 # 100e
        shufb   $low_9,$quad_7,$quad1_6,$m_xy           # 100o
        nop     $127                                    # 101e pairing
        shufb   $high_10,$quad2_6,$quad3_6,$m_xy        # 101o
        fma     $along,$ny,$dy,$along                   # 102e
        lqd     $quad2_8,48($patch2_2)                  # 102o
        lqd     $quad3_3,48($patch3_2)                  # 103o
        lqd     $quad_9,48($patch)                      # 104o
        nop     $127                                    # 105e pairing
        lqd     $py_2,64($a_surfaces)                   # 105o
        fma     $square,$nz,$nz,$square                 # 106e
        shufb   $by,$low_9,$high_10,$m_second           # 106o
        nop     $127                                    # 107e pairing
        shufb   $low_10,$quad_8,$quad+1,$m_xy           # 107o
        fma     $along,$nz,$dz_2,$along                 # 108e
        shufb   $high_11,$quad2_7,$quad3_7,$m_xy        # 108o
        shufb   $high_12,$quad2_6,$quad3_6,$m_zw        # 109o
        shufb   $low_11,$quad_7,$quad1_6,$m_zw          # 110o
        fs      $by,$by,$py_2                           # 111e
        shufb   $high_7,$quad2_8,$quad3_3,$m_xy         # 111o
        shufb   $low_12,$quad_9,$quad1_3,$m_xy          # 112o
        lqd     $gz,512($a_surfaces)                    # 113o
        rotmai  $along,$along,-31                       # 114e
        lqd     $pz_2,128($a_surfaces)                  # 114o
        shufb   $cy,$low_10,$high_11,$m_second          # 115o
        shufb   $bz_3,$low_11,$high_12,$m_first         # 116o
        shufb   $ay_3,$low_12,$high_7,$m_second         # 117o
        shufb   $high_9,$quad2_7,$quad3_7,$m_zw         # 118o
        fs      $cy,$cy,$py_2                           # 119e
        shufb   $low_8,$quad_8,$quad+1,$m_zw            # 119o
        fm      $turn_x,$gz,$by                         # 120e
        shufb   $low_13,$quad_9,$quad1_3,$m_zw          # 120o
        fs      $bz_4,$bz_3,$pz_2                       # 121e
        shufb   $high,$quad2_8,$quad3_3,$m_zw           # 121o
        fs      $ay,$ay_3,$py_2                         # 122e
        lqd     $px_2,0($a_surfaces)                    # 122o
        lqd     $gx,384($a_surfaces)                    # 123o
        lqd     $gy,448($a_surfaces)                    # 124o
        fm      $turn_x_3,$gz,$cy                       # 125e
        frsqest $t_y,$square                            # 125o
        shufb   $cx_3,$low_10,$high_11,$m_first         # 126o
        shufb   $bx,$low_9,$high_10,$m_first            # 127o
        fm      $turn_x_4,$gz,$ay                       # 128e
        shufb   $az_2,$low_13,$high,$m_first            # 128o
        fi      $t_y,$square,$t_y                       # 129e
        shufb   $cz,$low_8,$high_9,$m_first             # 129o
        nop     $127                                    # 130e pairing
        shufb   $ax,$low_12,$high_7,$m_first            # 130o
        fs      $cx_4,$cx_3,$px_2                       # 131e
        lqd     $quad2_9,32($patch+2)                   # 131o
        fs      $bx,$bx,$px_2                           # 132e
        lqd     $quad3_8,32($patch+3)                   # 132o
        fm      $turn_y,$gx,$bz_4                       # 133e
        lqd     $quad+1,32($patch1_2)                   # 133o
        fms     $turn_x,$gy,$bz_4,$turn_x               # 134e
        lqd     $quad_10,32($patch_2)                   # 134o
        fs      $cz,$cz,$pz_2                           # 135e
        lqd     $quad_11,96($patch)                     # 135o
        fs      $az,$az_2,$pz_2                         # 136e
        lqd     $quad3_9,96($patch3_2)                  # 136o
        fm      $t_e,$square,$t_y                       # 137e
        lqd     $quad2_5,96($patch2_2)                  # 137o
        fm      $turn_z,$gy,$bx                         # 138e
        lqd     $quad1_6,96($patch+1)                   # 138o
        fms     $turn_y,$gz,$bx,$turn_y                 # 139e
        shufb   $high_13,$quad2_9,$quad3_8,$m_zw        # 139o
        fm      $share_a,$turn_x,$cx_4                  # 140e
        shufb   $low_14,$quad_10,$quad+1,$m_zw          # 140o
        fs      $ax,$ax,$px_2                           # 141e
        lqd     $quad2_10,112($patch2_2)                # 141o
        fm      $turn_y_2,$gx,$cz                       # 142e
        lqd     $quad3_4,112($patch3_2)                 # 142o
        fms     $turn_x,$gy,$cz,$turn_x_3               # 143e
        lqd     $quad1_7,112($patch+1)                  # 143o
        fm      $turn_y_3,$gx,$az                       # 144e
        lqd     $quad_9,112($patch)                     # 144o
        fms     $turn_x_4,$gy,$az,$turn_x_4             # 145e
        shufb   $high_11,$quad2_5,$quad3_9,$m_xy        # 145o
        fm      $inverse,$t_y,$k_half                   # 146e
        lqd     $quad1_8,128($patch+1)                  # 146o
        fnms    $t_e,$t_e,$t_y,$k_one                   # 147e
        lqd     $quad2_11,128($patch2_2)                # 147o
        fm      $turn_z_5,$gy,$cx_4                     # 148e
        shufb   $low_15,$quad_11,$quad1_6,$m_xy         # 148o
        fma     $share_a,$turn_y,$cy,$share_a           # 149e
        lqd     $quad3_10,128($patch3_2)                # 149o
        fms     $turn_z,$gx,$by,$turn_z                 # 150e
        lqd     $quad_12,128($patch)                    # 150o
        fm      $share_b_2,$turn_x,$ax                  # 151e
        shufb   $smooth_2,$low_14,$high_13,$m_second    # 151o
        fms     $turn_y_2,$gz,$cx_4,$turn_y_2           # 152e
        shufb   $ay_4,$low_15,$high_11,$m_second        # 152o
        fm      $turn_z_6,$gy,$ax                       # 153e
        shufb   $ax_3,$low_15,$high_11,$m_first         # 153o
        fms     $turn_y_4,$gz,$ax,$turn_y_3             # 154e
        shufb   $high_14,$quad2_10,$quad3_4,$m_zw       # 154o
        fm      $share_c,$turn_x_4,$bx                  # 155e
        shufb   $high_6,$quad2_10,$quad3_4,$m_xy        # 155o
        fma     $share_a,$turn_z,$cz,$share_a           # 156e
        shufb   $low_9,$quad_9,$quad1_7,$m_zw           # 156o
        fms     $turn_z,$gx,$cy,$turn_z_5               # 157e
        shufb   $low_2,$quad_9,$quad1_7,$m_xy           # 157o
        fma     $share_b_3,$turn_y_2,$ay,$share_b_2     # 158e
        shufb   $high_15,$quad2_5,$quad3_9,$m_zw        # 158o
        fma     $inverse,$t_e,$inverse,$t_y             # 159e
        shufb   $low_16,$quad_11,$quad1_6,$m_zw         # 159o
        fms     $turn_z_7,$gx,$ay,$turn_z_6             # 160e
        shufb   $high,$quad2_11,$quad3_10,$m_xy         # 160o
        fma     $share_c,$turn_y_4,$by,$share_c         # 161e
        shufb   $low_17,$quad_12,$quad1_8,$m_xy         # 161o
        shli    $smooth,$smooth_2,2                     # 162e SIDES_SMOOTH becomes the sign
        shufb   $low_3,$quad_12,$quad1_8,$m_zw          # 162o
        fm      $ny_3,$share_a,$ay_4                    # 163e
        shufb   $high_16,$quad2_11,$quad3_10,$m_zw      # 163o
        fma     $share_b,$turn_z,$az,$share_b_3         # 164e
        lqd     $quad2_9,32($patch2_2)                  # 164o
        fm      $ny_4,$ny,$inverse                      # 165e
        lqd     $quad3_8,32($patch3_2)                  # 165o
        fm      $nx_2,$nx_3,$inverse                    # 166e
        lqd     $dz_3,320($a_rays)                      # 166o
        fm      $nx,$share_a,$ax_3                      # 167e
        shufb   $by_2,$low_2,$high_6,$m_second          # 167o
        fm      $nz_2,$nz,$inverse                      # 168e
        shufb   $bx_4,$low_2,$high_6,$m_first           # 168o
        fma     $share_c,$turn_z_7,$bz_4,$share_c       # 169e
        shufb   $bz_5,$low_9,$high_14,$m_first          # 169o
        rotmai  $smooth,$smooth,-31                     # 170e
        shufb   $cz,$low_3,$high_16,$m_first            # 170o
        shufb   $cx_2,$low_17,$high,$m_first            # 171o
        shufb   $az,$low_16,$high_15,$m_first           # 172o
next_row:
            fma     $ny,$share_b,$by_2,$ny_3            # 0e
            shufb   $cy,$low_17,$high,$m_second         # 0o
            selb    $ny_5,$gy_2,$ny_4,$along            # 1e
        hbrr    next_row_back,next_row                  # 1o hint
            fm      $nz,$share_a,$az                    # 2e
            lqd     $dx,192($a_rays)                    # 2o
            selb    $ny_5,$old_y,$ny_5,$smooth          # 3e
            lqd     $dy,256($a_rays)                    # 3o
            fma     $nx,$share_b,$bx_4,$nx              # 4e
            lqd     $quad+1,32($patch+1)                # 4o
            ai      $a_rays,$a_rays,16                  # 5e
            lqd     $quad,32($patch)                    # 5o
            fma     $ny,$share_c,$cy,$ny                # 6e
            lqd     $old_y,256($a_surfaces)             # 6o
            selb    $nz_3,$gz_2,$nz_2,$along            # 7e
        lqd     $patch,448($a_rays)                     # 7o
            selb    $nx_4,$gx_2,$nx_2,$along            # 8e
            stqd    $ny_5,256($a_surfaces_2)            # 8o
            selb    $nz_4,$old_z,$nz_3,$smooth          # 9e
            lqd     $old_z,320($a_surfaces)             # 9o
            fma     $nz,$share_b,$bz_5,$nz              # 10e
            shufb   $high,$quad2_9,$quad3_8,$m_zw       # 10o
            selb    $nx_5,$old_x,$nx_4,$smooth          # 11e
            stqd    $nz_4,320($a_surfaces_2)            # 11o
            fma     $nx,$share_c,$cx_2,$nx              # 12e
            lqd     $old_x,192($a_surfaces)             # 12o
        ai      $rows,$rows,-1                          # 13e
            shufb   $low,$quad,$quad+1,$m_zw            # 13o
            nop     $127                                # 14e pairing
            stqd    $nx_5,192($a_surfaces_2)            # 14o
            ori     $a_surfaces_2,$a_surfaces,0         # 15e copy
        rotqbyi $patch+2,$patch,8                       # 15o
            ai      $a_surfaces,$a_surfaces,16          # 16e
        rotqbyi $patch+1,$patch,4                       # 16o
            ori     $gz_2,$gz,0                         # 17e copy
        rotqbyi $patch+3,$patch,12                      # 17o
            fm      $square,$nx,$nx                     # 18e
            shufb   $smooth,$low,$high,$m_second        # 18o
            fm      $along,$nx,$dx                      # 19e
        lqd     $px,0($a_surfaces)                      # 19o
            ori     $gx_2,$gx,0                         # 20e copy
        lqd     $gz,512($a_surfaces)                    # 20o
            ori     $gy_2,$gy,0                         # 21e copy
        lqd     $py,64($a_surfaces)                     # 21o
            fma     $nz,$share_c,$cz,$nz                # 22e
        lqd     $pz,128($a_surfaces)                    # 22o
            shli    $smooth,$smooth,2                   # 23e SIDES_SMOOTH becomes the sign
        lqd     $gx,384($a_surfaces)                    # 23o
            fma     $square,$ny,$ny,$square             # 24e
        lqd     $gy,448($a_surfaces)                    # 24o
            fma     $along,$ny,$dy,$along               # 25e
        lqd     $quad,64($patch)                        # 25o
        nop     $127                                    # 26e pairing
        lqd     $quad+1,64($patch+1)                    # 26o
            rotmai  $smooth,$smooth,-31                 # 27e
        lqd     $quad+2,64($patch+2)                    # 27o
        lqd     $quad+3,80($patch+3)                    # 28o
        lqd     $quad3_11,64($patch+3)                  # 29o
            fma     $square,$nz,$nz,$square             # 30e
        lqd     $quad1_9,80($patch+1)                   # 30o
            fma     $along,$nz,$dz_3,$along             # 31e
        lqd     $quad_2,80($patch)                      # 31o
        lqd     $quad2_2,80($patch+2)                   # 32o
        lqd     $quad1_3,48($patch+1)                   # 33o
        shufb   $low_2,$quad,$quad+1,$m_xy              # 34o
        shufb   $high_2,$quad+2,$quad3_11,$m_xy         # 35o
        nop     $127                                    # 36e pairing
        lqd     $quad2_3,48($patch+2)                   # 36o
            rotmai  $along,$along,-31                   # 37e
        shufb   $low_3,$quad_2,$quad1_9,$m_xy           # 37o
            frsqest $t_y,$square                        # 38o
        shufb   $high_3,$quad2_2,$quad+3,$m_xy          # 39o
        shufb   $by,$low_2,$high_2,$m_second            # 40o
        lqd     $quad3_3,48($patch+3)                   # 41o
            fi      $t_y,$square,$t_y                   # 42e
        shufb   $high_17,$quad+2,$quad3_11,$m_zw        # 42o
        nop     $127                                    # 43e pairing
        shufb   $low_4,$quad,$quad+1,$m_zw              # 43o
        fs      $by,$by,$py                             # 44e
        lqd     $quad_3,48($patch)                      # 44o
        shufb   $cy,$low_3,$high_3,$m_second            # 45o
        shufb   $high,$quad2_2,$quad+3,$m_zw            # 46o
        shufb   $high_5,$quad2_3,$quad3_3,$m_xy         # 47o
        shufb   $low,$quad_2,$quad1_9,$m_zw             # 48o
        fs      $cy,$cy,$py                             # 49e
        shufb   $bz,$low_4,$high_17,$m_first            # 49o
        fm      $turn_x,$gz,$by                         # 50e
        shufb   $cx,$low_3,$high_3,$m_first             # 50o
            fm      $t_e,$square,$t_y                   # 51e
        shufb   $low_14,$quad_3,$quad1_3,$m_xy          # 51o
            fm      $inverse,$t_y,$k_half               # 52e
        shufb   $low_18,$quad_3,$quad1_3,$m_zw          # 52o
        fs      $bz,$bz,$pz                             # 53e
        shufb   $high_9,$quad2_3,$quad3_3,$m_zw         # 53o
        fs      $cx,$cx,$px                             # 54e
        shufb   $bx,$low_2,$high_2,$m_first             # 54o
        fm      $turn_x_5,$gz,$cy                       # 55e
        shufb   $ay,$low_14,$high_5,$m_second           # 55o
        nop     $127                                    # 56e pairing
        shufb   $ax,$low_14,$high_5,$m_first            # 56o
            fnms    $t_e,$t_e,$t_y,$k_one               # 57e
        shufb   $az,$low_18,$high_9,$m_first            # 57o
        fs      $bx,$bx,$px                             # 58e
        shufb   $cz,$low,$high,$m_first                 # 58o
        fm      $turn_y,$gx,$bz                         # 59e
        lqd     $quad,96($patch)                        # 59o
        fms     $turn_x,$gy,$bz,$turn_x                 # 60e
        lqd     $quad+3,96($patch+3)                    # 60o
        fs      $ay,$ay,$py                             # 61e
        lqd     $quad+2,96($patch+2)                    # 61o
        fs      $cz,$cz,$pz                             # 62e
        lqd     $quad2_12,112($patch+2)                 # 62o
        fs      $az,$az,$pz                             # 63e
        lqd     $quad3_12,112($patch+3)                 # 63o
        fm      $turn_z,$gy,$bx                         # 64e
        lqd     $quad1_4,96($patch+1)                   # 64o
        fms     $turn_y,$gz,$bx,$turn_y                 # 65e
        lqd     $quad1_5,112($patch+1)                  # 65o
        fm      $share_a,$turn_x,$cx                    # 66e
        lqd     $quad_5,112($patch)                     # 66o
        fs      $ax,$ax,$px                             # 67e
        shufb   $high_7,$quad+2,$quad+3,$m_xy           # 67o
        fm      $turn_y_2,$gx,$cz                       # 68e
        lqd     $quad1_3,128($patch+1)                  # 68o
        fms     $turn_x,$gy,$cz,$turn_x_5               # 69e
        lqd     $quad2_13,128($patch+2)                 # 69o
        fm      $turn_x_3,$gz,$ay                       # 70e
        shufb   $high_2,$quad2_12,$quad3_12,$m_zw       # 70o
        fm      $turn_z_2,$gy,$cx                       # 71e
        shufb   $high_17,$quad2_12,$quad3_12,$m_xy      # 71o
        fma     $share_a,$turn_y,$cy,$share_a           # 72e
        shufb   $low_18,$quad,$quad1_4,$m_xy            # 72o
        fms     $turn_z,$gx,$by,$turn_z                 # 73e
        shufb   $low_7,$quad_5,$quad1_5,$m_zw           # 73o
        fm      $turn_y_3,$gx,$az                       # 74e
        shufb   $low_11,$quad_5,$quad1_5,$m_xy          # 74o
        fm      $share_b_4,$turn_x,$ax                  # 75e
        lqd     $quad3_13,128($patch+3)                 # 75o
        fms     $turn_x_3,$gy,$az,$turn_x_3             # 76e
        lqd     $quad_6,128($patch)                     # 76o
        fms     $turn_y_2,$gz,$cx,$turn_y_2             # 77e
        shufb   $high_5,$quad+2,$quad+3,$m_zw           # 77o
        fm      $turn_z_4,$gy,$ax                       # 78e
        shufb   $by_2,$low_11,$high_17,$m_second        # 78o
        fma     $share_a,$turn_z,$cz,$share_a           # 79e
        shufb   $low,$quad,$quad1_4,$m_zw               # 79o
        fms     $turn_z,$gx,$cy,$turn_z_2               # 80e
        shufb   $ay_4,$low_18,$high_7,$m_second         # 80o
        fms     $turn_y_4,$gz,$ax,$turn_y_3             # 81e
        shufb   $bx_4,$low_11,$high_17,$m_first         # 81o
        fm      $share_c,$turn_x_3,$bx                  # 82e
        shufb   $high,$quad2_13,$quad3_13,$m_xy         # 82o
        fma     $share_b,$turn_y_2,$ay,$share_b_4       # 83e
        shufb   $low_17,$quad_6,$quad1_3,$m_xy          # 83o
            fma     $inverse,$t_e,$inverse,$t_y         # 84e
        shufb   $low_12,$quad_6,$quad1_3,$m_zw          # 84o
        fm      $ny_3,$share_a,$ay_4                    # 85e
        shufb   $high_6,$quad2_13,$quad3_13,$m_zw       # 85o
        fms     $turn_z_4,$gx,$ay,$turn_z_4             # 86e
        lqd     $quad2_9,32($patch+2)                   # 86o
        nop     $127                                    # 87e pairing
        lqd     $quad3_8,32($patch+3)                   # 87o
        fma     $share_c,$turn_y_4,$by,$share_c         # 88e
        shufb   $ax,$low_18,$high_7,$m_first            # 88o
        fma     $share_b,$turn_z,$az,$share_b           # 89e
        shufb   $bz_5,$low_7,$high_2,$m_first           # 89o
            fm      $ny_4,$ny,$inverse                  # 90e
        shufb   $cz,$low_12,$high_6,$m_first            # 90o
            fm      $nx_2,$nx,$inverse                  # 91e
        shufb   $cx_2,$low_17,$high,$m_first            # 91o
        fm      $nx,$share_a,$ax                        # 92e
        shufb   $az,$low,$high_5,$m_first               # 92o
            fm      $nz_2,$nz,$inverse                  # 93e
        lqd     $dz_3,320($a_rays)                      # 93o
        fma     $share_c,$turn_z_4,$bz,$share_c         # 94e
next_row_back:
        brnz    $rows,next_row                          # 94o
next_row_drain:
        fma     $nx,$share_b,$bx_4,$nx                  # 0e
        shufb   $cy,$low_17,$high,$m_second             # 0o
        fma     $ny,$share_b,$by_2,$ny_3                # 1e
        lqd     $dx,192($a_rays)                        # 1o
        fm      $nz,$share_a,$az                        # 2e
        lqd     $dy,256($a_rays)                        # 2o
        selb    $ny_5,$gy_2,$ny_4,$along                # 3e
        lqd     $quad+1,32($patch+1)                    # 3o
        selb    $nz_3,$gz_2,$nz_2,$along                # 4e
        lqd     $quad,32($patch)                        # 4o
        selb    $ny_5,$old_y,$ny_5,$smooth              # 5e
        shufb   $high,$quad2_9,$quad3_8,$m_zw           # 5o
        fma     $nx,$share_c,$cx_2,$nx                  # 6e
        hbr     smooth_r16_return,$lr                   # 6o hint
        fma     $ny,$share_c,$cy,$ny                    # 7e
        lqd     $old_y,256($a_surfaces)                 # 7o
        fma     $nz,$share_b,$bz_5,$nz                  # 8e
        stqd    $ny_5,256($a_surfaces_2)                # 8o
        selb    $nz_4,$old_z,$nz_3,$smooth              # 9e
        lqd     $old_z,320($a_surfaces)                 # 9o
        ori     $gy_3,$gy,0                             # 10e copy
        shufb   $low,$quad,$quad+1,$m_zw                # 10o
        selb    $nx_4,$gx_2,$nx_2,$along                # 11e
        stqd    $nz_4,320($a_surfaces_2)                # 11o
        fm      $square,$nx,$nx                         # 12e
        lqd     $old_x_2,192($a_surfaces)               # 12o
        fm      $along,$nx,$dx                          # 13e
        lnop                                            # 13o pairing
        fma     $nz,$share_c,$cz,$nz                    # 14e
        shufb   $smooth_2,$low,$high,$m_second          # 14o
        ori     $gz_3,$gz,0                             # 15e copy
        ori     $gx_3,$gx,0                             # 16e copy
        selb    $nx_4,$old_x,$nx_4,$smooth              # 17e
        fma     $square,$ny,$ny,$square                 # 18e
        fma     $along,$ny,$dy,$along                   # 19e
        stqd    $nx_4,192($a_surfaces_2)                # 19o
        shli    $smooth,$smooth_2,2                     # 20e SIDES_SMOOTH becomes the sign
        ori     $a_surfaces_2,$a_surfaces,0             # 21e copy
        ai      $a_rays,$a_rays,16                      # 22e
        ai      $a_surfaces,$a_surfaces,16              # 23e
        fma     $square,$nz,$nz,$square                 # 24e
        fma     $along,$nz,$dz_3,$along                 # 25e
        rotmai  $smooth,$smooth,-31                     # 26e
        frsqest $t_y,$square                            # 30o
        rotmai  $along,$along,-31                       # 31e
        fi      $t_y,$square,$t_y                       # 34e
        fm      $t_e,$square,$t_y                       # 41e
        fm      $inverse,$t_y,$k_half                   # 42e
        fnms    $t_e,$t_e,$t_y,$k_one                   # 47e
        fma     $inverse,$t_e,$inverse,$t_y             # 53e
        fm      $ny_4,$ny,$inverse                      # 59e
        fm      $nz_2,$nz,$inverse                      # 60e
        fm      $nx_2,$nx,$inverse                      # 61e
        selb    $ny_6,$gy_3,$ny_4,$along                # 65e
        selb    $nz_3,$gz_3,$nz_2,$along                # 66e
        selb    $ny_6,$old_y,$ny_6,$smooth              # 67e
        selb    $nx_4,$gx_3,$nx_2,$along                # 68e
        lnop                                            # 68o pairing
        selb    $nz_5,$old_z,$nz_3,$smooth              # 69e
        stqd    $ny_6,256($a_surfaces_2)                # 69o
        selb    $nx_5,$old_x_2,$nx_4,$smooth            # 70e
        stqd    $nz_5,320($a_surfaces_2)                # 71o
        stqd    $nx_5,192($a_surfaces_2)                # 72o
smooth_r16_return:
        bi      $lr                                     # 73o
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
        lqd     $quad_4,80($patch)                      # 13o
        lqd     $quad3_14,80($patch+3)                  # 14o
        lqd     $quad2_14,80($patch+2)                  # 15o
        lqd     $quad_13,48($patch)                     # 16o
        shufb   $high,$quad+2,$quad+3,$m_xy             # 17o
        shufb   $low,$quad,$quad+1,$m_xy                # 18o
        lqd     $quad1_10,48($patch+1)                  # 19o
        lqd     $quad1_9,80($patch+1)                   # 20o
        shufb   $low_4,$quad,$quad+1,$m_zw              # 21o
        shufb   $by,$low,$high,$m_second                # 22o
        shufb   $high_6,$quad2_14,$quad3_14,$m_xy       # 23o
        lqd     $quad3_15,48($patch+3)                  # 24o
        nop     $127                                    # 25e pairing
        shufb   $high_5,$quad+2,$quad+3,$m_zw           # 25o
        fs      $by,$by,$py                             # 26e
        shufb   $low_19,$quad_4,$quad1_9,$m_xy          # 26o
        shufb   $high_18,$quad2_14,$quad3_14,$m_zw      # 27o
        lqd     $quad2_14,48($patch+2)                  # 28o
        shufb   $bz,$low_4,$high_5,$m_first             # 29o
        shufb   $cy,$low_19,$high_6,$m_second           # 30o
        nop     $127                                    # 31e pairing
        shufb   $bx,$low,$high,$m_first                 # 31o
        fm      $turn_x,$gz,$by                         # 32e
        shufb   $low,$quad_13,$quad1_10,$m_xy           # 32o
        fs      $bz,$bz,$pz                             # 33e
        shufb   $cx,$low_19,$high_6,$m_first            # 33o
        fs      $cy,$cy,$py                             # 34e
        lqd     $gy,448($a_surfaces)                    # 34o
        fs      $bx,$bx,$px                             # 35e
        shufb   $high,$quad2_14,$quad3_15,$m_xy         # 35o
        nop     $127                                    # 36e pairing
        shufb   $low_5,$quad_4,$quad1_9,$m_zw           # 36o
        fs      $cx,$cx,$px                             # 37e
        shufb   $low_20,$quad_13,$quad1_10,$m_zw        # 37o
        nop     $127                                    # 38e pairing
        shufb   $high_19,$quad2_14,$quad3_15,$m_zw      # 38o
        fm      $turn_y,$gx,$bz                         # 39e
        shufb   $ay,$low,$high,$m_second                # 39o
        fm      $turn_x_6,$gz,$cy                       # 40e
        shufb   $cz,$low_5,$high_18,$m_first            # 40o
        fms     $turn_x,$gy,$bz,$turn_x                 # 41e
        shufb   $ax,$low,$high,$m_first                 # 41o
        fm      $turn_z,$gy,$bx                         # 42e
        shufb   $az,$low_20,$high_19,$m_first           # 42o
        fs      $ay,$ay,$py                             # 43e
        lqd     $quad+1,96($patch+1)                    # 43o
        fs      $cz,$cz,$pz                             # 44e
        lqd     $quad+3,96($patch+3)                    # 44o
        fs      $ax,$ax,$px                             # 45e
        lqd     $quad,96($patch)                        # 45o
        fms     $turn_y,$gz,$bx,$turn_y                 # 46e
        lqd     $quad+2,96($patch+2)                    # 46o
        fm      $share_a,$turn_x,$cx                    # 47e
        lqd     $quad_4,112($patch)                     # 47o
        fs      $az,$az,$pz                             # 48e
        lqd     $quad1_11,112($patch+1)                 # 48o
        fm      $turn_x,$gz,$ay                         # 49e
        lqd     $quad2_14,112($patch+2)                 # 49o
        fms     $turn_x_7,$gy,$cz,$turn_x_6             # 50e
        lqd     $quad3_11,128($patch+3)                 # 50o
        fm      $turn_y_5,$gx,$cz                       # 51e
        shufb   $low,$quad,$quad+1,$m_xy                # 51o
        fms     $turn_z,$gx,$by,$turn_z                 # 52e
        lqd     $quad3_9,112($patch+3)                  # 52o
        fma     $share_a,$turn_y,$cy,$share_a           # 53e
        shufb   $high_20,$quad+2,$quad+3,$m_xy          # 53o
        fm      $turn_z_8,$gy,$cx                       # 54e
        shufb   $low_17,$quad_4,$quad1_11,$m_xy         # 54o
        fms     $turn_x,$gy,$az,$turn_x                 # 55e
        lqd     $quad_14,128($patch)                    # 55o
        fm      $share_b,$turn_x_7,$ax                  # 56e
        lqd     $quad1_12,128($patch+1)                 # 56o
        fms     $turn_y,$gz,$cx,$turn_y_5               # 57e
        shufb   $ax_4,$low,$high_20,$m_first            # 57o
        fm      $turn_y_6,$gx,$az                       # 58e
        shufb   $high_21,$quad2_14,$quad3_9,$m_xy       # 58o
        fma     $share_a,$turn_z,$cz,$share_a           # 59e
        shufb   $high_5,$quad+2,$quad+3,$m_zw           # 59o
        fms     $turn_z,$gx,$cy,$turn_z_8               # 60e
        lqd     $quad2_15,128($patch+2)                 # 60o
        fm      $turn_z_8,$gy,$ax                       # 61e
        shufb   $ay_5,$low,$high_20,$m_second           # 61o
        fm      $share_c,$turn_x,$bx                    # 62e
        shufb   $bx,$low_17,$high_21,$m_first           # 62o
        fma     $share_b,$turn_y,$ay,$share_b           # 63e
        shufb   $low_4,$quad,$quad+1,$m_zw              # 63o
        fms     $turn_y,$gz,$ax,$turn_y_6               # 64e
        shufb   $low_8,$quad_14,$quad1_12,$m_xy         # 64o
        fm      $nx,$share_a,$ax_4                      # 65e
        shufb   $high,$quad2_14,$quad3_9,$m_zw          # 65o
        fm      $ny,$share_a,$ay_5                      # 66e
        shufb   $high_19,$quad2_15,$quad3_11,$m_xy      # 66o
        fms     $turn_z_7,$gx,$ay,$turn_z_8             # 67e
        shufb   $az_3,$low_4,$high_5,$m_first           # 67o
        nop     $127                                    # 68e pairing
        shufb   $by_3,$low_17,$high_21,$m_second        # 68o
        fma     $share_b,$turn_z,$az,$share_b           # 69e
        shufb   $low,$quad_4,$quad1_11,$m_zw            # 69o
        fma     $share_c,$turn_y,$by,$share_c           # 70e
        shufb   $cx,$low_8,$high_19,$m_first            # 70o
        fm      $nz,$share_a,$az_3                      # 71e
        shufb   $high_4,$quad2_15,$quad3_11,$m_zw       # 71o
        shufb   $cy,$low_8,$high_19,$m_second           # 72o
        shufb   $bz_6,$low,$high,$m_first               # 73o
        nop     $127                                    # 74e pairing
        shufb   $low,$quad_14,$quad1_12,$m_zw           # 74o
        fma     $nx,$share_b,$bx,$nx                    # 75e
        lqd     $quad2_14,32($patch+2)                  # 75o
        fma     $share_c,$turn_z_7,$bz,$share_c         # 76e
        lqd     $quad+3,32($patch+3)                    # 76o
        fma     $ny,$share_b,$by_3,$ny                  # 77e
        lqd     $quad+1,32($patch+1)                    # 77o
        fma     $nz,$share_b,$bz_6,$nz                  # 78e
        shufb   $cz,$low,$high_4,$m_first               # 78o
        lqd     $quad,32($patch)                        # 79o
        lqd     $dx,192($a_rays)                        # 80o
        nop     $127                                    # 81e pairing
        lqd     $dy,256($a_rays)                        # 81o
        fma     $nx,$share_c,$cx,$nx                    # 82e
        shufb   $high,$quad2_14,$quad+3,$m_zw           # 82o
        fma     $ny,$share_c,$cy,$ny                    # 83e
        lqd     $dz,320($a_rays)                        # 83o
        fma     $nz,$share_c,$cz,$nz                    # 84e
        lqd     $old_x,192($a_surfaces)                 # 84o
        ai      $a_rays,$a_rays,16                      # 85e
        shufb   $low,$quad,$quad+1,$m_zw                # 85o
        lqd     $old_y,256($a_surfaces)                 # 86o
        lqd     $old_z,320($a_surfaces)                 # 87o
        fm      $square,$nx,$nx                         # 88e
        lnop                                            # 88o pairing
        fm      $along,$nx,$dx                          # 89e
        shufb   $smooth,$low,$high,$m_second            # 89o
        shli    $smooth,$smooth,2                       # 93e SIDES_SMOOTH becomes the sign
        fma     $square,$ny,$ny,$square                 # 94e
        fma     $along,$ny,$dy,$along                   # 95e
        lnop                                            # 95o pairing
        rotmai  $smooth,$smooth,-31                     # 97e
        hbrr    next_row_short_back,next_row_short      # 97o hint
        fma     $square,$nz,$nz,$square                 # 100e
        fma     $along,$nz,$dz,$along                   # 101e
        frsqest $t_y,$square                            # 106o
        rotmai  $along,$along,-31                       # 107e
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
