# smooth_r16   normals that shade, of those of sixteen hits that are on patches
#   C       void smooth_r16(const struct ray_packet *, struct surfaces *);
#   In      $3 rays, $4 surfaces; pointers 16-aligned. What a ray has hit is an address, of any
#           record
#   Out     surfaces: normal, where the object has SIDES_SMOOTH and so is a patch
#   Uses    $2-$62   Saves  -   Stack  0   Calls  -
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
#
# The loop counts up, so that it isn't pipelined. Pipelined it would take 2 KB more of local store,
# and 0.1 % less time in a scene with many patches.
# Scheduled by spu schedule from smooth_r16.s

        .include "work_unit.inc"
        .include "macros.inc"
        .include "barycentric.inc"
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
transpose:
        transpose_shuffles

function smooth_r16
        .set quad_2,2; .set quad3_2,5; .set quad2_2,6; .set quad_3,7; .set quad1_2,8
        .set quad1_3,9; .set low_2,21; .set high_2,22; .set quad3_3,27; .set high_3,23
        .set low_3,24; .set high_4,5; .set low_4,2; .set low_5,7; .set high_5,6; .set turn_x_2,8
        .set quad1_4,5; .set turn_x_3,7; .set quad3_4,8; .set turn_y_2,9; .set quad3_5,26
        .set high_6,27; .set turn_z_2,28; .set low_6,29; .set quad_4,30; .set quad1_5,7
        .set ax_2,9; .set turn_y_3,34; .set high_7,35; .set quad2_3,24; .set ay_2,25; .set low_7,22
        .set turn_z_3,9; .set az_2,21; .set by_2,23; .set high_8,2; .set bz_2,5
        ilhu    $k_half,0x3f00                          # 0e
        lqa     $m_xy,transpose                         # 0o
        ilhu    $k_one,0x3f80                           # 1e
        lqa     $m_zw,transpose+16                      # 1o
        il      $rows,-4                                # 2e
        lqa     $m_first,transpose+32                   # 2o
        nop     $127                                    # 3e pairing
        lqa     $m_second,transpose+48                  # 3o
next_row:
        ai      $rows,$rows,1                           # 0e
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
        lqd     $quad_2,80($patch)                      # 13o
        lqd     $quad3_2,80($patch+3)                   # 14o
        lqd     $quad2_2,80($patch+2)                   # 15o
        lqd     $quad_3,48($patch)                      # 16o
        shufb   $high,$quad+2,$quad+3,$m_xy             # 17o
        shufb   $low,$quad,$quad+1,$m_xy                # 18o
        lqd     $quad1_2,48($patch+1)                   # 19o
        lqd     $quad1_3,80($patch+1)                   # 20o
        shufb   $low_2,$quad,$quad+1,$m_zw              # 21o
        shufb   $by,$low,$high,$m_second                # 22o
        shufb   $high_2,$quad2_2,$quad3_2,$m_xy         # 23o
        lqd     $quad3_3,48($patch+3)                   # 24o
        nop     $127                                    # 25e pairing
        shufb   $high_3,$quad+2,$quad+3,$m_zw           # 25o
        fs      $by,$by,$py                             # 26e
        shufb   $low_3,$quad_2,$quad1_3,$m_xy           # 26o
        shufb   $high_4,$quad2_2,$quad3_2,$m_zw         # 27o
        lqd     $quad2_2,48($patch+2)                   # 28o
        shufb   $bz,$low_2,$high_3,$m_first             # 29o
        shufb   $cy,$low_3,$high_2,$m_second            # 30o
        nop     $127                                    # 31e pairing
        shufb   $bx,$low,$high,$m_first                 # 31o
        fm      $turn_x,$gz,$by                         # 32e
        shufb   $low,$quad_3,$quad1_2,$m_xy             # 32o
        fs      $bz,$bz,$pz                             # 33e
        shufb   $cx,$low_3,$high_2,$m_first             # 33o
        fs      $cy,$cy,$py                             # 34e
        lqd     $gy,448($a_surfaces)                    # 34o
        fs      $bx,$bx,$px                             # 35e
        shufb   $high,$quad2_2,$quad3_3,$m_xy           # 35o
        nop     $127                                    # 36e pairing
        shufb   $low_4,$quad_2,$quad1_3,$m_zw           # 36o
        fs      $cx,$cx,$px                             # 37e
        shufb   $low_5,$quad_3,$quad1_2,$m_zw           # 37o
        nop     $127                                    # 38e pairing
        shufb   $high_5,$quad2_2,$quad3_3,$m_zw         # 38o
        fm      $turn_y,$gx,$bz                         # 39e
        shufb   $ay,$low,$high,$m_second                # 39o
        fm      $turn_x_2,$gz,$cy                       # 40e
        shufb   $cz,$low_4,$high_4,$m_first             # 40o
        fms     $turn_x,$gy,$bz,$turn_x                 # 41e
        shufb   $ax,$low,$high,$m_first                 # 41o
        fm      $turn_z,$gy,$bx                         # 42e
        shufb   $az,$low_5,$high_5,$m_first             # 42o
        fs      $ay,$ay,$py                             # 43e
        lqd     $quad+1,96($patch+1)                    # 43o
        fs      $cz,$cz,$pz                             # 44e
        lqd     $quad+3,96($patch+3)                    # 44o
        fs      $ax,$ax,$px                             # 45e
        lqd     $quad,96($patch)                        # 45o
        fms     $turn_y,$gz,$bx,$turn_y                 # 46e
        lqd     $quad+2,96($patch+2)                    # 46o
        fm      $share_a,$turn_x,$cx                    # 47e
        lqd     $quad_2,112($patch)                     # 47o
        fs      $az,$az,$pz                             # 48e
        lqd     $quad1_4,112($patch+1)                  # 48o
        fm      $turn_x,$gz,$ay                         # 49e
        lqd     $quad2_2,112($patch+2)                  # 49o
        fms     $turn_x_3,$gy,$cz,$turn_x_2             # 50e
        lqd     $quad3_4,128($patch+3)                  # 50o
        fm      $turn_y_2,$gx,$cz                       # 51e
        shufb   $low,$quad,$quad+1,$m_xy                # 51o
        fms     $turn_z,$gx,$by,$turn_z                 # 52e
        lqd     $quad3_5,112($patch+3)                  # 52o
        fma     $share_a,$turn_y,$cy,$share_a           # 53e
        shufb   $high_6,$quad+2,$quad+3,$m_xy           # 53o
        fm      $turn_z_2,$gy,$cx                       # 54e
        shufb   $low_6,$quad_2,$quad1_4,$m_xy           # 54o
        fms     $turn_x,$gy,$az,$turn_x                 # 55e
        lqd     $quad_4,128($patch)                     # 55o
        fm      $share_b,$turn_x_3,$ax                  # 56e
        lqd     $quad1_5,128($patch+1)                  # 56o
        fms     $turn_y,$gz,$cx,$turn_y_2               # 57e
        shufb   $ax_2,$low,$high_6,$m_first             # 57o
        fm      $turn_y_3,$gx,$az                       # 58e
        shufb   $high_7,$quad2_2,$quad3_5,$m_xy         # 58o
        fma     $share_a,$turn_z,$cz,$share_a           # 59e
        shufb   $high_3,$quad+2,$quad+3,$m_zw           # 59o
        fms     $turn_z,$gx,$cy,$turn_z_2               # 60e
        lqd     $quad2_3,128($patch+2)                  # 60o
        fm      $turn_z_2,$gy,$ax                       # 61e
        shufb   $ay_2,$low,$high_6,$m_second            # 61o
        fm      $share_c,$turn_x,$bx                    # 62e
        shufb   $bx,$low_6,$high_7,$m_first             # 62o
        fma     $share_b,$turn_y,$ay,$share_b           # 63e
        shufb   $low_2,$quad,$quad+1,$m_zw              # 63o
        fms     $turn_y,$gz,$ax,$turn_y_3               # 64e
        shufb   $low_7,$quad_4,$quad1_5,$m_xy           # 64o
        fm      $nx,$share_a,$ax_2                      # 65e
        shufb   $high,$quad2_2,$quad3_5,$m_zw           # 65o
        fm      $ny,$share_a,$ay_2                      # 66e
        shufb   $high_5,$quad2_3,$quad3_4,$m_xy         # 66o
        fms     $turn_z_3,$gx,$ay,$turn_z_2             # 67e
        shufb   $az_2,$low_2,$high_3,$m_first           # 67o
        nop     $127                                    # 68e pairing
        shufb   $by_2,$low_6,$high_7,$m_second          # 68o
        fma     $share_b,$turn_z,$az,$share_b           # 69e
        shufb   $low,$quad_2,$quad1_4,$m_zw             # 69o
        fma     $share_c,$turn_y,$by,$share_c           # 70e
        shufb   $cx,$low_7,$high_5,$m_first             # 70o
        fm      $nz,$share_a,$az_2                      # 71e
        shufb   $high_8,$quad2_3,$quad3_4,$m_zw         # 71o
        shufb   $cy,$low_7,$high_5,$m_second            # 72o
        shufb   $bz_2,$low,$high,$m_first               # 73o
        nop     $127                                    # 74e pairing
        shufb   $low,$quad_4,$quad1_5,$m_zw             # 74o
        fma     $nx,$share_b,$bx,$nx                    # 75e
        lqd     $quad2_2,32($patch+2)                   # 75o
        fma     $share_c,$turn_z_3,$bz,$share_c         # 76e
        lqd     $quad+3,32($patch+3)                    # 76o
        fma     $ny,$share_b,$by_2,$ny                  # 77e
        lqd     $quad+1,32($patch+1)                    # 77o
        fma     $nz,$share_b,$bz_2,$nz                  # 78e
        shufb   $cz,$low,$high_8,$m_first               # 78o
        lqd     $quad,32($patch)                        # 79o
        lqd     $dx,192($a_rays)                        # 80o
        nop     $127                                    # 81e pairing
        lqd     $dy,256($a_rays)                        # 81o
        fma     $nx,$share_c,$cx,$nx                    # 82e
        shufb   $high,$quad2_2,$quad+3,$m_zw            # 82o
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
        hbrr    next_row_back,next_row                  # 97o hint
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
next_row_back:
        brnz    $rows,next_row                          # 149o
        nop     $127                                    # 150e pairing
        bi      $lr                                     # 150o
endfunction smooth_r16
