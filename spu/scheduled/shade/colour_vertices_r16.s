# colour_vertices_r16   multiplies sixteen surfaces' colours by those of their triangles' vertices
#   C       void colour_vertices_r16(const struct rays16 *, struct surfaces *,
#                                    const vec_uint4 *colours, const struct patch *, int are_roots);
#   In      $3 rays, $4 their surfaces, $5 the packed colours of the vertices of each patch, $6 the
#           first patch; pointers 16-aligned; $7 -1 if colours are square roots of light, 0 if they
#           are light. What a ray has hit is an address, of any record
#   Out     surfaces: red, green and blue, where the object is a patch with SIDES_COLOURED
#   Uses    $2-$68   Saves  -   Stack  0   Calls  -
#   Domain  points in their triangles; edges from 2^-30 to 2^30, and from 1/100 of the points'
#           distance from the eye on; |plane| about 1; up to 128 patches
#   Error   1e-6 of 1, for a colour of 1; for the point as it is given
#   Twin    lab/twins/src/colour.rs
#
# The light of the vertices is interpolated with the shares of the triangle's area that
# texture_places_r16 computes, too.
#
# The loop counts up, so that it isn't pipelined, which would take as much room again.
# Scheduled by spu schedule from colour_vertices_r16.s

        .include "work_unit.inc"
        .include "macros.inc"
        .include "barycentric.inc"
        .include "reciprocal.inc"

        .set    NEXT,3
        registers a_rays,a_surfaces,a_table,a_first,are_roots
        # constants
        .set    NEXT,10
        registers m_xy,m_zw,m_first,m_second,k_one,k_bits,k_scale,k_light,k_square,k_index,rows
        # the lanes' records
        .set    patch,NEXT                              # to 24
        .set    quad,patch+4                            # to 28
        .set    place,quad+4                            # to 32
        .set    NEXT,place+4
        registers low,high,coloured
        # the row
        registers px,py,pz,gx,gy,gz
        registers ax                                    # the vertices, relative to the point
        registers ay,az,bx,by,bz,cx,cy,cz,rest
        registers turn_x,turn_y,turn_z,share_a,share_b,share_c,inverse,t_y,t_e
        registers packed_a,packed_b,packed_c
        registers part_a,part_b,part_c,factor,old

        .section .rodata.colour,"a",@progbits
        .align  4
transpose:
        transpose_shuffles

# Interpolates a channel, whose bits are moved to the end, and multiplies the colour.
.macro  channel name:req, shift:req
    .irp corner, a,b,c
        rotmi   $part_\corner,$packed_\corner,-\shift
        and     $part_\corner,$part_\corner,$k_bits
        csflt   $part_\corner,$part_\corner,0
        fma     $factor,$part_\corner,$k_square,$k_light
        fm      $part_\corner,$part_\corner,$factor
    .endr
        fs      $part_b,$part_b,$part_a
        fs      $part_c,$part_c,$part_a
        fma     $part_a,$share_b,$part_b,$part_a
        fma     $part_a,$share_c,$part_c,$part_a
        lqd     $old,SURFACES_\name($a_surfaces)
        fm      $part_a,$part_a,$k_scale
        fm      $part_a,$part_a,$old
        selb    $old,$old,$part_a,$coloured
        stqd    $old,SURFACES_\name($a_surfaces)
.endm

function colour_vertices_r16
        .set rows8_2,2; .set rows6_2,7; .set rows5_2,8; .set rows7_2,9; .set rows5_3,30
        .set rows8_3,31; .set rows7_3,32; .set rows6_3,34; .set high_2,35; .set low_2,40
        .set high_3,42; .set high_4,43; .set low_3,7; .set high_5,2; .set low_4,25; .set low_5,8
        .set high_6,9; .set ay_2,26; .set low_6,27; .set ax_2,25; .set gy_2,28; .set turn_x_2,30
        .set turn_x_3,25; .set rows10_2,33; .set rows5_4,29; .set rows8_4,32; .set turn_y_2,35
        .set rows7_4,31; .set rows6_4,33; .set rows8_5,24; .set rows5_5,21; .set rows6_5,22
        .set rows7_5,23; .set turn_z_2,30; .set high_7,36; .set low_7,37; .set high_8,31
        .set turn_y_3,32; .set turn_y_4,29; .set low_8,35; .set turn_z_3,28; .set high_9,23
        .set low_9,21; .set coloured_2,8; .set part_a_2,2; .set part_a_3,7; .set part_b_2,9
        .set old_2,21; .set old_3,22; .set part_b_3,23; .set part_c_2,24; .set part_c_3,25
        .set factor_2,8; .set factor_3,26; .set factor_4,27; .set factor_5,28; .set factor_6,29
        .set factor_7,30; .set part_c_4,8; .set part_a_4,25; .set part_c_5,7; .set old_4,2
        .set old_5,7
        ilhu    $k_scale,0x3a80                         # 0e 1 / 1023, rounded up
        lqa     $m_zw,transpose+16                      # 0o
        ila     $low,0x10203                            # 1e
        lqa     $m_first,transpose+32                   # 1o
        iohl    $k_scale,0x2009                         # 2e 1 / 1023, rounded up
        fsm     $are_roots,$are_roots                   # 2o
        ilhu    $k_one,0x3f80                           # 3e
        lqa     $m_xy,transpose                         # 3o
        il      $k_bits,1023                            # 4e
        lqa     $m_second,transpose+48                  # 4o
        il      $k_index,456                            # 5e exact for 128 patches
        shufb   $a_table,$a_table,$a_table,$low         # 5o
        and     $k_square,$k_scale,$are_roots           # 6e
        shufb   $a_first,$a_first,$a_first,$low         # 6o
        andc    $k_light,$k_one,$are_roots              # 7e
        il      $rows,-4                                # 8e
next_row:
        ai      $rows,$rows,1                           # 0e
        lqd     $rows+1,448($a_rays)                    # 0o
        ai      $a_rays,$a_rays,16                      # 1e
        lqd     $py,64($a_surfaces)                     # 1o
        lqd     $gz,512($a_surfaces)                    # 2o
        lqd     $pz,128($a_surfaces)                    # 3o
        lqd     $px,0($a_surfaces)                      # 4o
        lqd     $gx,384($a_surfaces)                    # 5o
        sf      $rows+9,$a_first,$rows+1                # 6e
        rotqbyi $rows+3,$rows+1,8                       # 6o
        nop     $127                                    # 7e pairing
        rotqbyi $rows+4,$rows+1,12                      # 7o
        mpyu    $rows+9,$rows+9,$k_index                # 8e
        rotqbyi $rows+2,$rows+1,4                       # 8o
        lqd     $rows+5,80($rows+1)                     # 9o
        lqd     $rows+7,80($rows+3)                     # 10o
        lqd     $rows+8,64($rows+4)                     # 11o
        lqd     $rows+6,64($rows+2)                     # 12o
        lqd     $rows8_2,80($rows+4)                    # 13o
        lqd     $rows6_2,80($rows+2)                    # 14o
        rotmi   $rows+9,$rows+9,-16                     # 15e
        lqd     $rows5_2,64($rows+1)                    # 15o
        lqd     $rows7_2,64($rows+3)                    # 16o
        lqd     $rows5_3,48($rows+1)                    # 17o
        nop     $127                                    # 18e pairing
        lqd     $rows8_3,48($rows+4)                    # 18o
        shli    $rows+9,$rows+9,4                       # 19e
        lqd     $rows7_3,48($rows+3)                    # 19o
        shufb   $low,$rows+5,$rows6_2,$m_xy             # 20o
        lqd     $rows6_3,48($rows+2)                    # 21o
        nop     $127                                    # 22e pairing
        shufb   $high_2,$rows7_2,$rows+8,$m_xy          # 22o
        a       $rows+9,$rows+9,$a_table                # 23e
        shufb   $low_2,$rows5_2,$rows+6,$m_xy           # 23o
        shufb   $high_3,$rows+7,$rows8_2,$m_xy          # 24o
        shufb   $high_4,$rows7_3,$rows8_3,$m_xy         # 25o
        shufb   $low_3,$rows+5,$rows6_2,$m_zw           # 26o
        shufb   $high_5,$rows+7,$rows8_2,$m_zw          # 27o
        shufb   $by,$low_2,$high_2,$m_second            # 28o
        shufb   $cy,$low,$high_3,$m_second              # 29o
        shufb   $low_4,$rows5_3,$rows6_3,$m_xy          # 30o
        shufb   $low_5,$rows5_2,$rows+6,$m_zw           # 31o
        fs      $by,$by,$py                             # 32e
        shufb   $high_6,$rows7_2,$rows+8,$m_zw          # 32o
        fs      $cy,$cy,$py                             # 33e
        shufb   $cz,$low_3,$high_5,$m_first             # 33o
        shufb   $ay_2,$low_4,$high_4,$m_second          # 34o
        shufb   $low_6,$rows5_3,$rows6_3,$m_zw          # 35o
        nop     $127                                    # 36e pairing
        shufb   $bz,$low_5,$high_6,$m_first             # 36o
        fs      $cz,$cz,$pz                             # 37e
        shufb   $high,$rows7_3,$rows8_3,$m_zw           # 37o
        fs      $ay_2,$ay_2,$py                         # 38e
        shufb   $ax_2,$low_4,$high_4,$m_first           # 38o
        fm      $turn_x,$gz,$by                         # 39e
        shufb   $cx,$low,$high_3,$m_first               # 39o
        fs      $bz,$bz,$pz                             # 40e
        lqd     $gy_2,448($a_surfaces)                  # 40o
        fm      $turn_x_2,$gz,$cy                       # 41e
        shufb   $az,$low_6,$high,$m_first               # 41o
        fs      $ax,$ax_2,$px                           # 42e
        shufb   $bx,$low_2,$high_2,$m_first             # 42o
        fs      $cx,$cx,$px                             # 43e
        rotqbyi $rows+12,$rows+9,12                     # 43o
        fm      $turn_y,$gx,$cz                         # 44e
        rotqbyi $rows+11,$rows+9,8                      # 44o
        fm      $turn_x_3,$gz,$ay_2                     # 45e
        rotqbyi $rows10_2,$rows+9,4                     # 45o
        fs      $bx,$bx,$px                             # 46e
        lqd     $rows5_4,0($rows+9)                     # 46o
        fms     $turn_x_2,$gy_2,$cz,$turn_x_2           # 47e
        lqd     $rows8_4,0($rows+12)                    # 47o
        fm      $turn_y_2,$gx,$bz                       # 48e
        lqd     $rows7_4,0($rows+11)                    # 48o
        fs      $az,$az,$pz                             # 49e
        lqd     $rows6_4,0($rows10_2)                   # 49o
        fms     $turn_x,$gy_2,$bz,$turn_x               # 50e
        lqd     $rows8_5,32($rows+4)                    # 50o
        fm      $turn_z,$gy_2,$cx                       # 51e
        lqd     $rows5_5,32($rows+1)                    # 51o
        fms     $turn_y,$gz,$cx,$turn_y                 # 52e
        lqd     $rows6_5,32($rows+2)                    # 52o
        fm      $share_b,$turn_x_2,$ax                  # 53e
        lqd     $rows7_5,32($rows+3)                    # 53o
        fm      $turn_z_2,$gy_2,$bx                     # 54e
        shufb   $high_7,$rows7_4,$rows8_4,$m_xy         # 54o
        fms     $turn_x_3,$gy_2,$az,$turn_x_3           # 55e
        shufb   $low_7,$rows5_4,$rows6_4,$m_xy          # 55o
        fm      $share_a,$turn_x,$cx                    # 56e
        shufb   $high_8,$rows7_4,$rows8_4,$m_zw         # 56o
        fms     $turn_y_3,$gz,$bx,$turn_y_2             # 57e
        shufb   $low,$rows5_4,$rows6_4,$m_zw            # 57o
        fm      $turn_y_4,$gx,$az                       # 58e
        shufb   $low_8,$rows5_5,$rows6_5,$m_zw          # 58o
        fms     $turn_z,$gx,$cy,$turn_z                 # 59e
        shufb   $packed_b,$low_7,$high_7,$m_second      # 59o
        fms     $turn_z_2,$gx,$by,$turn_z_2             # 60e
        shufb   $packed_a,$low_7,$high_7,$m_first       # 60o
        fma     $share_b,$turn_y,$ay_2,$share_b         # 61e
        shufb   $packed_c,$low,$high_8,$m_first         # 61o
        fm      $turn_z_3,$gy_2,$ax                     # 62e
        shufb   $high_7,$rows7_5,$rows8_5,$m_zw         # 62o
        fma     $share_a,$turn_y_3,$cy,$share_a         # 63e
        shufb   $high_9,$rows7_5,$rows8_5,$m_xy         # 63o
        fms     $turn_y,$gz,$ax,$turn_y_4               # 64e
        shufb   $low_9,$rows5_5,$rows6_5,$m_xy          # 64o
        fm      $share_c,$turn_x_3,$bx                  # 65e
        shufb   $rest,$low_5,$high_6,$m_second          # 65o
        rotmi   $part_a,$packed_a,-22                   # 66e
        shufb   $coloured_2,$low_8,$high_7,$m_second    # 66o
        fma     $share_b,$turn_z,$az,$share_b           # 67e
        shufb   $rest,$low_3,$high_5,$m_second          # 67o
        fms     $turn_z,$gx,$ay_2,$turn_z_3             # 68e
        shufb   $rest,$low,$high_8,$m_second            # 68o
        fma     $share_a,$turn_z_2,$cz,$share_a         # 69e
        shufb   $rest,$low_9,$high_9,$m_second          # 69o
        rotmi   $part_a_2,$packed_a,-12                 # 70e
        shufb   $rest,$low_8,$high_7,$m_first           # 70o
        fma     $share_c,$turn_y,$by,$share_c           # 71e
        shufb   $rest,$low_6,$high,$m_second            # 71o
        rotmi   $part_a_3,$packed_a,-2                  # 72e
        lqd     $old,640($a_surfaces)                   # 72o
        rotmi   $part_b,$packed_b,-2                    # 73e
        shufb   $rest,$low_9,$high_9,$m_first           # 73o
        rotmi   $part_b_2,$packed_b,-22                 # 74e
        lqd     $old_2,768($a_surfaces)                 # 74o
        fa      $share_a,$share_a,$share_b              # 75e
        lqd     $old_3,704($a_surfaces)                 # 75o
        and     $part_a,$part_a,$k_bits                 # 76e
        fma     $share_c,$turn_z,$bz,$share_c           # 77e
        and     $part_a_2,$part_a_2,$k_bits             # 78e
        rotmi   $part_b_3,$packed_b,-12                 # 79e
        and     $part_b,$part_b,$k_bits                 # 80e
        and     $part_a_3,$part_a_3,$k_bits             # 81e
        csflt   $part_a_2,$part_a_2,0                   # 82e
        and     $part_b_3,$part_b_3,$k_bits             # 83e
        fa      $share_a,$share_a,$share_c              # 84e
        csflt   $part_b_3,$part_b_3,0                   # 85e
        csflt   $part_b,$part_b,0                       # 86e
        and     $part_b_2,$part_b_2,$k_bits             # 87e
        rotmi   $part_c,$packed_c,-12                   # 88e
        csflt   $part_b_2,$part_b_2,0                   # 89e
        rotmi   $part_c_2,$packed_c,-2                  # 90e
        frest   $t_y,$share_a                           # 90o
        csflt   $part_a,$part_a,0                       # 91e
        rotmi   $part_c_3,$packed_c,-22                 # 92e
        csflt   $part_a_3,$part_a_3,0                   # 93e
        fi      $t_y,$share_a,$t_y                      # 94e
        and     $part_c_2,$part_c_2,$k_bits             # 95e
        and     $part_c_3,$part_c_3,$k_bits             # 96e
        and     $part_c,$part_c,$k_bits                 # 97e
        fma     $factor,$part_a,$k_square,$k_light      # 98e
        csflt   $part_c_3,$part_c_3,0                   # 99e
        csflt   $part_c,$part_c,0                       # 100e
        csflt   $part_c_2,$part_c_2,0                   # 101e
        shli    $coloured,$coloured_2,5                 # 102e SIDES_COLOURED becomes the sign
        fnms    $t_e,$share_a,$t_y,$k_one               # 103e
        fma     $factor_2,$part_a_3,$k_square,$k_light  # 104e
        fma     $factor_3,$part_b_2,$k_square,$k_light  # 105e
        fma     $factor_4,$part_a_2,$k_square,$k_light  # 106e
        fma     $factor_5,$part_b,$k_square,$k_light    # 107e
        fma     $factor_6,$part_b_3,$k_square,$k_light  # 108e
        fma     $factor_7,$part_c,$k_square,$k_light    # 109e
        fm      $part_a,$part_a,$factor                 # 110e
        fm      $part_b_2,$part_b_2,$factor_3           # 111e
        fm      $part_a_2,$part_a_2,$factor_4           # 112e
        fma     $factor,$part_c_3,$k_square,$k_light    # 113e
        fm      $part_b_3,$part_b_3,$factor_6           # 114e
        fm      $part_a_3,$part_a_3,$factor_2           # 115e
        fm      $part_b,$part_b,$factor_5               # 116e
        fma     $inverse,$t_e,$t_y,$t_y                 # 117e
        fma     $factor_2,$part_c_2,$k_square,$k_light  # 118e
        fm      $part_c_3,$part_c_3,$factor             # 119e
        fm      $part_c,$part_c,$factor_7               # 120e
        fs      $part_b_2,$part_b_2,$part_a             # 121e
        fs      $part_b,$part_b,$part_a_3               # 122e
        fm      $share_b,$share_b,$inverse              # 123e
        fm      $part_c_4,$part_c_2,$factor_2           # 124e
        fs      $part_b_3,$part_b_3,$part_a_2           # 125e
        fs      $part_c,$part_c,$part_a_2               # 126e
        fm      $share_c,$share_c,$inverse              # 127e
        fs      $part_c_2,$part_c_3,$part_a             # 128e
        fma     $part_a_4,$share_b,$part_b,$part_a_3    # 129e
        fma     $part_a,$share_b,$part_b_2,$part_a      # 130e
        fma     $part_a_2,$share_b,$part_b_3,$part_a_2  # 131e
        fs      $part_c_5,$part_c_4,$part_a_3           # 132e
        rotmai  $coloured,$coloured,-31                 # 133e
        hbrr    next_row_back,next_row                  # 133o hint
        fma     $part_a,$share_c,$part_c_2,$part_a      # 136e
        fma     $part_a_2,$share_c,$part_c,$part_a_2    # 137e
        fma     $part_a_3,$share_c,$part_c_5,$part_a_4  # 138e
        fm      $part_a,$part_a,$k_scale                # 142e
        fm      $part_a_2,$part_a_2,$k_scale            # 143e
        fm      $part_a_3,$part_a_3,$k_scale            # 144e
        fm      $part_a,$part_a,$old                    # 148e
        fm      $part_a_2,$part_a_2,$old_3              # 149e
        fm      $part_a_3,$part_a_3,$old_2              # 150e
        selb    $old,$old,$part_a,$coloured             # 154e
        selb    $old_4,$old_3,$part_a_2,$coloured       # 155e
        lnop                                            # 155o pairing
        selb    $old_5,$old_2,$part_a_3,$coloured       # 156e
        stqd    $old,640($a_surfaces)                   # 156o
        stqd    $old_4,704($a_surfaces)                 # 157o
        stqd    $old_5,768($a_surfaces)                 # 158o
        ai      $a_surfaces,$a_surfaces,16              # 159e
next_row_back:
        brnz    $rows,next_row                          # 159o
        nop     $127                                    # 160e pairing
        bi      $lr                                     # 160o
endfunction colour_vertices_r16
