# mesh_rays_r16   records of the rays of packets one by one, for mesh_filter_rays
#   C       void mesh_rays_r16(const struct rays16 *, int count, struct mesh_ray *);
#   In      $3 RAYS16, one behind the other, $4 count (0 is none, at most 8), $5 where 16 records
#           for each packet go; pointers 16-aligned
#   Out     the records
#   Uses    $2-$49, $79   Saves  -   Stack  0   Calls  -
#   Domain  origins below 2^60; components of directions up to 1
#   Error   0: no ray meets a plane earlier or later than its record says
#   Twin    lab/twins/src/mesh_rays.rs
#
# A ray meets a plane at p of an axis at (p - o) / d. A component of a direction below 2^-60
# becomes 2^-60, which moves the ray by less than the slacks: as in filter_boxes_r16, each box has
# one, and the origin moves by 2^-19 of its largest coordinate, forwards for the planes that are
# met first and backwards for the others.
# Scheduled by spu schedule from mesh_rays_r16.s

        .include "work_unit.inc"
        .include "macros.inc"
        .include "transpose.inc"
        .include "reciprocal.inc"
        .include "extremes.inc"

        .set    NEXT,3
        registers a_row,count,a_record
        .set    NEXT,10
        # constants
        registers m_first,m_last,m_sign,k_tiny,k_one,k_slack,k_zero,k_to_next
        # state
        registers number                                # 127 - the row's rays' numbers
        # a row
        registers o_x,o_y,o_z,size,other,c_greater,slack,last,step
        registers d_x,d_y,d_z,t_y,t_e,signed
        # the records of the row by field, later by ray
        registers first                                 # to 36: the first quadwords
        .set    NEXT,first+4
        registers second                                # to 40
        .set    NEXT,second+4
        registers third                                 # to 44
        .set    NEXT,third+4
        registers words                                 # to 48
        .set    NEXT,words+4
        .set    inverse_x,first+1
        .set    inverse_y,first+2
        .set    inverse_z,first+3

        transpose_table .rodata.mesh
numbers:
        .int    127,126,125,124

function mesh_rays_r16
        .set a_row1_2,79; .set other_2,2; .set o_x_2,20; .set o_y_2,22; .set c_greater_2,9
        .set c_greater_3,19; .set size_2,25; .set t_y_2,19; .set other_3,33; .set t_y_3,24
        .set c_greater_4,36; .set t_e_2,28; .set c_greater_5,6; .set t_e_3,9; .set size_3,6
        .set inverse_x_2,6; .set inverse_z_2,7; .set signed_2,9; .set other_4,20; .set words1_2,37
        .set words3_2,40; .set o_y_3,9; .set o_z_2,22; .set other_5,8; .set second2_2,25
        .set other_6,9; .set words_2,6; .set words_3,7; .set words2_2,8; .set words2_3,9
        .set words1_3,32; .set words3_3,34; .set first_2,35; .set inverse_x_3,7
        .set inverse_y_2,37; .set inverse_z_3,8; .set third_2,26; .set words3_4,3
        .set a_record_2,2; .set second2_3,2; .set c_greater_6,2; .set other_7,6; .set t_y_4,7
        .set t_y_5,2; .set t_e_4,6; .set t_e_5,8; .set signed_3,2; .set o_y_4,6; .set o_z_3,7
        .set signed_4,8; .set words1_4,7; .set words3_5,8; .set words_4,2; .set words1_5,6
        .set words3_6,7; .set first_3,2; .set words2_4,2
        nop     $127                                    # 0e pairing
        biz     $a_row+1,$lr                            # 0o
        shli    $a_row+1,$a_row+1,2                     # 1e
        lqa     $m_first,transpose_first                # 1o
        ilhu    $m_sign,0x8000                          # 2e
        lqa     $m_last,transpose_last                  # 2o
        ilhu    $k_tiny,0x2180                          # 3e 2^-60
        lqa     $number,numbers                         # 3o
        ilhu    $k_one,0x3f80                           # 4e
        clgti   $a_row1_2,$a_row+1,1                    # 5e at least as many passes as overlap
        ilhu    $k_slack,0x3600                         # 6e 2^-19
        il      $k_zero,0                               # 7e
        il      $k_to_next,592                          # 8e
        brz     $a_row1_2,next_row_short                # 8o too few passes
        shli    $other_2,$number,24                     # 9e
        lqd     $d_x,192($a_row)                        # 9o
        andi    $last,$number,12                        # 10e
        lqd     $d_y,256($a_row)                        # 10o
        il      $step,16                                # 11e
        lqd     $d_z,320($a_row)                        # 11o
        ceqi    $last,$last,0                           # 12e
        lqd     $o_x_2,0($a_row)                        # 12o
        ai      $number,$number,-4                      # 13e
        lqd     $o_y_2,64($a_row)                       # 13o
        selb    $step,$step,$k_to_next,$last            # 14e
        lqd     $o_z,128($a_row)                        # 14o
        fcmgt   $c_greater,$k_tiny,$d_x                 # 15e
        lqd     $third,384($a_row)                      # 15o
        fcmgt   $c_greater_2,$k_tiny,$d_y               # 16e
        selb    $d_x,$d_x,$k_tiny,$c_greater            # 17e
        fcmgt   $c_greater_3,$k_tiny,$d_z               # 18e
        lnop                                            # 18o pairing
        selb    $d_y,$d_y,$k_tiny,$c_greater_2          # 19e
        frest   $t_y,$d_x                               # 19o
        selb    $d_z,$d_z,$k_tiny,$c_greater_3          # 20e
        hbrr    next_row_back,next_row                  # 20o hint
        andc    $size_2,$o_x_2,$m_sign                  # 21e
        frest   $t_y_2,$d_y                             # 21o
        andc    $other_3,$o_y_2,$m_sign                 # 22e
        frest   $t_y_3,$d_z                             # 22o
        fi      $t_y,$d_x,$t_y                          # 23e
        fcgt    $c_greater_4,$other_3,$size_2           # 24e
        fi      $t_y_2,$d_y,$t_y_2                      # 25e
        fi      $t_y_3,$d_z,$t_y_3                      # 26e
        andc    $other,$o_z,$m_sign                     # 27e
        selb    $size_2,$size_2,$other_3,$c_greater_4   # 28e
        a       $a_row,$a_row,$step                     # 29e
        fnms    $t_e_2,$d_x,$t_y,$k_one                 # 30e
        fcgt    $c_greater_5,$other,$size_2             # 31e
        fnms    $t_e_3,$d_y,$t_y_2,$k_one               # 32e
        selb    $size_3,$size_2,$other,$c_greater_5     # 33e
        fnms    $t_e,$d_z,$t_y_3,$k_one                 # 34e
        fm      $slack,$size_3,$k_slack                 # 35e
        fma     $inverse_x_2,$t_e_2,$t_y,$t_y           # 36e
        ai      $a_row+1,$a_row+1,-1                    # 37e
        fma     $inverse_y,$t_e_3,$t_y_2,$t_y_2         # 38e
        fma     $inverse_z_2,$t_e,$t_y_3,$t_y_3         # 40e
        selb    $signed,$slack,$inverse_x_2,$m_sign     # 42e
        rotmai  $first,$inverse_x_2,-31                 # 43e
        selb    $signed_2,$slack,$inverse_y,$m_sign     # 44e
        fs      $o_x,$o_x_2,$signed                     # 45e
        lnop                                            # 45o pairing
        fa      $other_4,$o_x_2,$signed                 # 46e
        shufb   $words1_2,$inverse_x_2,$inverse_z_2,$m_first # 46o
        fa      $other,$o_y_2,$signed_2                 # 47e
        shufb   $words3_2,$inverse_x_2,$inverse_z_2,$m_last # 47o
        selb    $signed,$slack,$inverse_z_2,$m_sign     # 48e
        fs      $o_y_3,$o_y_2,$signed_2                 # 49e
        fs      $o_z_2,$o_z,$signed                     # 50e
        rotmai  $other_5,$inverse_z_2,-31               # 51e
        fnms    $third+1,$o_x,$inverse_x_2,$k_zero      # 52e
        fnms    $second2_2,$other,$inverse_y,$k_zero    # 53e
        rotmai  $second,$inverse_y,-31                  # 54e
        fnms    $third+2,$o_y_3,$inverse_y,$k_zero      # 55e
        fa      $other_6,$o_z,$signed                   # 56e
        fnms    $third+3,$o_z_2,$inverse_z_2,$k_zero    # 57e
        andi    $other,$other_5,48                      # 58e
        andi    $first,$first,48                        # 59e
        ai      $other,$other,32                        # 60e
        lnop                                            # 60o pairing
next_row:
            andi    $second,$second,48                  # 0e
            shufb   $words+2,$third,$third+2,$m_last    # 0o
            shli    $other,$other,24                    # 1e
            shufb   $words,$third,$third+2,$m_first     # 1o
            fnms    $second+3,$other_6,$inverse_z_2,$k_zero # 2e
        lqd     $d_x,192($a_row)                        # 2o
            ai      $second,$second,16                  # 3e
        lqd     $d_y,256($a_row)                        # 3o
            fnms    $second+1,$other_4,$inverse_x_2,$k_zero # 4e
        lqd     $d_z,320($a_row)                        # 4o
            or      $second,$second,$other_2            # 5e
        lqd     $o_z,128($a_row)                        # 5o
            or      $first,$first,$other                # 6e
        lqd     $third,384($a_row)                      # 6o
        shli    $other_2,$number,24                     # 7e
            shufb   $words_2,$second,$second2_2,$m_first # 7o
        andi    $last,$number,12                        # 8e
            shufb   $words_3,$first,$inverse_y,$m_first # 8o
        fcmgt   $c_greater,$k_tiny,$d_x                 # 9e
            shufb   $words2_2,$first,$inverse_y,$m_last # 9o
        fcmgt   $c_greater_2,$k_tiny,$d_y               # 10e
            shufb   $words+1,$second+1,$second+3,$m_first # 10o
        fcmgt   $c_greater_3,$k_tiny,$d_z               # 11e
        lqd     $o_x_2,0($a_row)                        # 11o
        selb    $d_x,$d_x,$k_tiny,$c_greater            # 12e
        lqd     $o_y_2,64($a_row)                       # 12o
        selb    $d_y,$d_y,$k_tiny,$c_greater_2          # 13e
            shufb   $words2_3,$second,$second2_2,$m_last # 13o
        selb    $d_z,$d_z,$k_tiny,$c_greater_3          # 14e
        frest   $t_y,$d_x                               # 14o
        andc    $other,$o_z,$m_sign                     # 15e
        frest   $t_y_2,$d_y                             # 15o
        il      $step,16                                # 16e
        frest   $t_y_3,$d_z                             # 16o
        andc    $size_2,$o_x_2,$m_sign                  # 17e
            shufb   $words1_3,$third+1,$third+3,$m_first # 17o
        fi      $t_y,$d_x,$t_y                          # 18e
            shufb   $words+3,$second+1,$second+3,$m_last # 18o
        andc    $other_3,$o_y_2,$m_sign                 # 19e
            shufb   $words3_3,$third+1,$third+3,$m_last # 19o
        fi      $t_y_2,$d_y,$t_y_2                      # 20e
            shufb   $first_2,$words_3,$words1_2,$m_first # 20o
        fcgt    $c_greater_4,$other_3,$size_2           # 21e
            shufb   $inverse_x_3,$words_3,$words1_2,$m_last # 21o
        fi      $t_y_3,$d_z,$t_y_3                      # 22e
            shufb   $inverse_y_2,$words2_2,$words3_2,$m_first # 22o
        selb    $size_2,$size_2,$other_3,$c_greater_4   # 23e
            shufb   $inverse_z_3,$words2_2,$words3_2,$m_last # 23o
        ceqi    $last,$last,0                           # 24e
            shufb   $second,$words_2,$words+1,$m_first  # 24o
        fnms    $t_e_2,$d_x,$t_y,$k_one                 # 25e
            shufb   $second+1,$words_2,$words+1,$m_last # 25o
        fcgt    $c_greater_5,$other,$size_2             # 26e
            shufb   $second+2,$words2_3,$words+3,$m_first # 26o
        selb    $step,$step,$k_to_next,$last            # 27e
            shufb   $second+3,$words2_3,$words+3,$m_last # 27o
        fnms    $t_e_3,$d_y,$t_y_2,$k_one               # 28e
            shufb   $third_2,$words,$words1_3,$m_first  # 28o
        selb    $size_3,$size_2,$other,$c_greater_5     # 29e
            shufb   $third+1,$words,$words1_3,$m_last   # 29o
        fnms    $t_e,$d_z,$t_y_3,$k_one                 # 30e
            shufb   $third+2,$words+2,$words3_3,$m_first # 30o
        fm      $slack,$size_3,$k_slack                 # 31e
            shufb   $third+3,$words+2,$words3_3,$m_last # 31o
        fma     $inverse_x_2,$t_e_2,$t_y,$t_y           # 32e
            stqd    $first_2,0($a_record)               # 32o
        a       $a_row,$a_row,$step                     # 33e
            stqd    $second,16($a_record)               # 33o
        fma     $inverse_y,$t_e_3,$t_y_2,$t_y_2         # 34e
            stqd    $third_2,32($a_record)              # 34o
        ai      $number,$number,-4                      # 35e
            stqd    $inverse_x_3,48($a_record)          # 35o
        ai      $a_row+1,$a_row+1,-1                    # 36e
            stqd    $second+1,64($a_record)             # 36o
        fma     $inverse_z_2,$t_e,$t_y_3,$t_y_3         # 37e
            stqd    $third+1,80($a_record)              # 37o
        selb    $signed,$slack,$inverse_x_2,$m_sign     # 38e
            stqd    $inverse_y_2,96($a_record)          # 38o
        rotmai  $first,$inverse_x_2,-31                 # 39e
            stqd    $second+2,112($a_record)            # 39o
        selb    $signed_2,$slack,$inverse_y,$m_sign     # 40e
            stqd    $third+2,128($a_record)             # 40o
        fs      $o_x,$o_x_2,$signed                     # 41e
            stqd    $inverse_z_3,144($a_record)         # 41o
        fa      $other,$o_y_2,$signed_2                 # 42e
            stqd    $second+3,160($a_record)            # 42o
        rotmai  $other_5,$inverse_z_2,-31               # 43e
        shufb   $words1_2,$inverse_x_2,$inverse_z_2,$m_first # 43o
        fs      $o_y_3,$o_y_2,$signed_2                 # 44e
        shufb   $words3_2,$inverse_x_2,$inverse_z_2,$m_last # 44o
        fa      $other_4,$o_x_2,$signed                 # 45e
            stqd    $third+3,176($a_record)             # 45o
            ai      $a_record,$a_record,192             # 46e
        selb    $signed,$slack,$inverse_z_2,$m_sign     # 47e
        rotmai  $second,$inverse_y,-31                  # 48e
        fs      $o_z_2,$o_z,$signed                     # 49e
        fnms    $second2_2,$other,$inverse_y,$k_zero    # 50e
        fnms    $third+2,$o_y_3,$inverse_y,$k_zero      # 51e
        fa      $other_6,$o_z,$signed                   # 52e
        andi    $other,$other_5,48                      # 53e
        fnms    $third+1,$o_x,$inverse_x_2,$k_zero      # 54e
        fnms    $third+3,$o_z_2,$inverse_z_2,$k_zero    # 55e
        ai      $other,$other,32                        # 56e
        lnop                                            # 56o pairing
        andi    $first,$first,48                        # 57e
next_row_back:
        brnz    $a_row+1,next_row                       # 57o
next_row_drain:
        shli    $other,$other,24                        # 0e
        shufb   $words,$third,$third+2,$m_first         # 0o
        andi    $second,$second,48                      # 1e
        shufb   $words1_3,$third+1,$third+3,$m_first    # 1o
        fnms    $second+3,$other_6,$inverse_z_2,$k_zero # 2e
        hbr     mesh_rays_r16_return,$lr                # 2o hint
        fnms    $second+1,$other_4,$inverse_x_2,$k_zero # 3e
        shufb   $words+2,$third,$third+2,$m_last        # 3o
        ai      $second,$second,16                      # 4e
        shufb   $words3_4,$third+1,$third+3,$m_last     # 4o
        or      $first,$first,$other                    # 5e
        shufb   $third_2,$words,$words1_3,$m_first      # 5o
        or      $second,$second,$other_2                # 6e
        shufb   $third+1,$words,$words1_3,$m_last       # 6o
        ai      $a_record_2,$a_record,192               # 7e
        shufb   $words_3,$first,$inverse_y,$m_first     # 7o
        shufb   $words_2,$second,$second2_2,$m_first    # 8o
        shufb   $words+1,$second+1,$second+3,$m_first   # 9o
        shufb   $words2_2,$first,$inverse_y,$m_last     # 10o
        shufb   $first_2,$words_3,$words1_2,$m_first    # 11o
        shufb   $words2_3,$second,$second2_2,$m_last    # 12o
        shufb   $second,$words_2,$words+1,$m_first      # 13o
        shufb   $words+3,$second+1,$second+3,$m_last    # 14o
        shufb   $inverse_x_3,$words_3,$words1_2,$m_last # 15o
        shufb   $second+1,$words_2,$words+1,$m_last     # 16o
        stqd    $first_2,0($a_record)                   # 17o
        stqd    $second,16($a_record)                   # 18o
        shufb   $inverse_y_2,$words2_2,$words3_2,$m_first # 19o
        stqd    $third_2,32($a_record)                  # 20o
        shufb   $second2_3,$words2_3,$words+3,$m_first  # 21o
        stqd    $inverse_x_3,48($a_record)              # 22o
        shufb   $third+2,$words+2,$words3_4,$m_first    # 23o
        stqd    $second+1,64($a_record)                 # 24o
        shufb   $inverse_z_3,$words2_2,$words3_2,$m_last # 25o
        stqd    $third+1,80($a_record)                  # 26o
        shufb   $second+3,$words2_3,$words+3,$m_last    # 27o
        stqd    $inverse_y_2,96($a_record)              # 28o
        shufb   $third+3,$words+2,$words3_4,$m_last     # 29o
        stqd    $second2_3,112($a_record)               # 30o
        stqd    $third+2,128($a_record)                 # 31o
        stqd    $inverse_z_3,144($a_record)             # 32o
        stqd    $second+3,160($a_record)                # 33o
        stqd    $third+3,176($a_record)                 # 34o
mesh_rays_r16_return:
        bi      $lr                                     # 35o
next_row_short:
        shli    $other,$number,24                       # 0e
        lqd     $d_y,256($a_row)                        # 0o
        ai      $a_row+1,$a_row+1,-1                    # 1e
        lqd     $d_x,192($a_row)                        # 1o
        il      $step,16                                # 2e
        lqd     $d_z,320($a_row)                        # 2o
        andi    $last,$number,12                        # 3e
        lqd     $o_x,0($a_row)                          # 3o
        ai      $number,$number,-4                      # 4e
        lqd     $o_z,128($a_row)                        # 4o
        ceqi    $last,$last,0                           # 5e
        lqd     $o_y,64($a_row)                         # 5o
        fcmgt   $c_greater,$k_tiny,$d_y                 # 6e
        lqd     $third,384($a_row)                      # 6o
        fcmgt   $c_greater_6,$k_tiny,$d_x               # 7e
        fcmgt   $c_greater_5,$k_tiny,$d_z               # 8e
        selb    $d_y,$d_y,$k_tiny,$c_greater            # 9e
        selb    $d_z,$d_z,$k_tiny,$c_greater_5          # 10e
        andc    $other_7,$o_y,$m_sign                   # 11e
        frest   $t_y,$d_y                               # 11o
        andc    $size,$o_x,$m_sign                      # 12e
        frest   $t_y_4,$d_z                             # 12o
        selb    $d_x,$d_x,$k_tiny,$c_greater_6          # 13e
        fcgt    $c_greater,$other_7,$size               # 14e
        fi      $t_y,$d_y,$t_y                          # 15e
        frest   $t_y_5,$d_x                             # 15o
        fi      $t_y_4,$d_z,$t_y_4                      # 16e
        andc    $other_5,$o_z,$m_sign                   # 17e
        selb    $size,$size,$other_7,$c_greater         # 18e
        fi      $t_y_5,$d_x,$t_y_5                      # 19e
        fcgt    $c_greater,$other_5,$size               # 20e
        selb    $step,$step,$k_to_next,$last            # 21e
        fnms    $t_e,$d_y,$t_y,$k_one                   # 22e
        fnms    $t_e_4,$d_z,$t_y_4,$k_one               # 23e
        selb    $size,$size,$other_5,$c_greater         # 24e
        a       $a_row,$a_row,$step                     # 25e
        fnms    $t_e_5,$d_x,$t_y_5,$k_one               # 26e
        fm      $slack,$size,$k_slack                   # 27e
        fma     $inverse_y,$t_e,$t_y,$t_y               # 28e
        fma     $inverse_z,$t_e_4,$t_y_4,$t_y_4         # 29e
        fma     $inverse_x,$t_e_5,$t_y_5,$t_y_5         # 32e
        selb    $signed,$slack,$inverse_y,$m_sign       # 34e
        selb    $signed_3,$slack,$inverse_z,$m_sign     # 35e
        fs      $o_y_4,$o_y,$signed                     # 36e
        fs      $o_z_3,$o_z,$signed_3                   # 37e
        lnop                                            # 37o pairing
        selb    $signed_4,$slack,$inverse_x,$m_sign     # 38e
        shufb   $words+3,$inverse_x,$inverse_z,$m_last  # 38o
        fa      $other_6,$o_y,$signed                   # 39e
        shufb   $words+1,$inverse_x,$inverse_z,$m_first # 39o
        fs      $o_x_2,$o_x,$signed_4                   # 40e
        fa      $other_5,$o_x,$signed_4                 # 41e
        fnms    $third+2,$o_y_4,$inverse_y,$k_zero      # 42e
        fnms    $third+3,$o_z_3,$inverse_z,$k_zero      # 43e
        rotmai  $first,$inverse_x,-31                   # 44e
        fnms    $second+2,$other_6,$inverse_y,$k_zero   # 45e
        fnms    $third+1,$o_x_2,$inverse_x,$k_zero      # 46e
        fnms    $second+1,$other_5,$inverse_x,$k_zero   # 47e
        andi    $first,$first,48                        # 48e
        shufb   $words,$third,$third+2,$m_first         # 48o
        rotmai  $other_7,$inverse_z,-31                 # 49e
        shufb   $words+2,$third,$third+2,$m_last        # 49o
        fa      $other_2,$o_z,$signed_3                 # 50e
        rotmai  $second,$inverse_y,-31                  # 51e
        nop     $127                                    # 52e pairing
        shufb   $words1_4,$third+1,$third+3,$m_first    # 52o
        andi    $other_7,$other_7,48                    # 53e
        shufb   $words3_5,$third+1,$third+3,$m_last     # 53o
        andi    $second,$second,48                      # 55e
        lnop                                            # 55o pairing
        ai      $other_7,$other_7,32                    # 56e
        shufb   $third+1,$words,$words1_4,$m_last       # 56o
        ai      $second,$second,16                      # 57e
        shufb   $third,$words,$words1_4,$m_first        # 57o
        shli    $other_7,$other_7,24                    # 58e
        shufb   $third+2,$words+2,$words3_5,$m_first    # 58o
        fnms    $second+3,$other_2,$inverse_z,$k_zero   # 59e
        shufb   $third+3,$words+2,$words3_5,$m_last     # 59o
        or      $second,$second,$other                  # 60e
        stqd    $third+1,80($a_record)                  # 60o
        nop     $127                                    # 61e pairing
        stqd    $third,32($a_record)                    # 61o
        or      $first,$first,$other_7                  # 62e
        shufb   $words+2,$second,$second+2,$m_last      # 62o
        shufb   $words,$second,$second+2,$m_first       # 63o
        shufb   $words_4,$first,$inverse_y,$m_first     # 64o
        stqd    $third+2,128($a_record)                 # 65o
        shufb   $words1_5,$second+1,$second+3,$m_first  # 66o
        shufb   $words3_6,$second+1,$second+3,$m_last   # 67o
        shufb   $inverse_x,$words_4,$words+1,$m_last    # 68o
        shufb   $first_3,$words_4,$words+1,$m_first     # 69o
        shufb   $second,$words,$words1_5,$m_first       # 70o
        shufb   $second+3,$words+2,$words3_6,$m_last    # 71o
        stqd    $inverse_x,48($a_record)                # 72o
        stqd    $first_3,0($a_record)                   # 73o
        shufb   $words2_4,$first,$inverse_y,$m_last     # 74o
        stqd    $second+3,160($a_record)                # 75o
        stqd    $third+3,176($a_record)                 # 76o
        stqd    $second,16($a_record)                   # 77o
        shufb   $inverse_z,$words2_4,$words+3,$m_last   # 78o
        shufb   $inverse_y,$words2_4,$words+3,$m_first  # 79o
        shufb   $second+1,$words,$words1_5,$m_last      # 80o
        shufb   $second+2,$words+2,$words3_6,$m_first   # 81o
        stqd    $inverse_z,144($a_record)               # 82o
        stqd    $inverse_y,96($a_record)                # 83o
        stqd    $second+1,64($a_record)                 # 84o
        nop     $127                                    # 85e pairing
        stqd    $second+2,112($a_record)                # 85o
        ai      $a_record,$a_record,192                 # 86e
        brnz    $a_row+1,next_row_short                 # 86o
        nop     $127                                    # 87e pairing
        bi      $lr                                     # 87o
endfunction mesh_rays_r16
