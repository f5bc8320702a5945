# isect_mesh_rows_r4   nearest hit of rows of rays from the eye with a mesh's triangles
#   C       void isect_mesh_rows_r4(const struct mesh_rows *, int rows,
#                                   const struct mesh_header *);
#   In      $3 triangles and packets' rows, $4 how many rows they have (0 is none), $5 the
#           triangles' block, in local store and relative to the eye; pointers 16-aligned
#   Out     the rows: t, object, where a hit has 0 < t < what was there; object is MESH_HIT, plus
#           128 times the block's number, plus the triangle's index
#   Uses    $2-$72, $79   Saves  -   Stack  0   Calls  -
#   Domain  as isect_mesh_pairs_r16; rays from the eye, whose origins are 0; each triangle has a
#           row
#   Error   6 ulp of t, 8e-5 in barycentric coordinates; edges from 1/100 of the distance to all of
#           it, area across the ray above 1/20 of their square
#   Twin    lab/twins/src/mesh_rows.rs
#
# The steps are those of isect_mesh_pairs_r16, of which the origin's are left out, so the hits have
# the same bits. A pass of the loop is a row, not a triangle.
# Scheduled by spu schedule from isect_mesh_rows_r4.s

        .include "work_unit.inc"
        .include "macros.inc"
        .include "pairs.inc"
        .include "triangle_tmpl.inc"

        .set    NEXT,3
        registers a_first                               # triangle
        registers rows,a_block
        # constants
        .set    NEXT,10
        registers k_above_one,k_sign,a_controls,m_splat,m_indices,k_step
        registers k_all                                 # the bits of four rows
        registers k_below                               # the bits below the first
        # the block
        registers a_vertices,a_faces,hit,both
        # state
        registers a_rows
        registers ahead_rows                            # the bits of rows that are not done
        # the triangle's rows
        registers word,bits,lead,place,a_packet,a_bound,a_shear
        # the triangle
        registers face,index,object,vertex_a,vertex_b,vertex_c
        # temporaries
        registers xa,ya,za,xb,yb,zb,xc,yc,zc,axis,slope
        registers p,q
        registers u,v,w,det,inverse,t_y,t_e,n
        registers outside,seen,t,t_best,nearest,control
        registers more
        .set    ahead,n
        # only before the loop
        .set    header,q
        .set    rest,u

        sign_controls_table .rodata.mesh
vertex_indices:                                         # three bytes to the ends of three words
        .int    0x80808000,0x80808001,0x80808002,0x80808080

function isect_mesh_rows_r4
        .set rows_2,79; .set index_2,66; .set lead_2,5; .set index_3,35; .set ahead_rows_2,5
        .set a_packet_2,70; .set a_packet_3,38; .set a_packet_4,45; .set a_shear_2,6
        .set a_packet_5,36; .set more_2,2; .set axis_2,9; .set axis_3,30; .set slope_2,26
        .set vertex_c_2,3; .set vertex_b_2,7; .set slope_3,31; .set slope_4,2; .set za_2,67
        .set ya_2,8; .set zc_2,71; .set ya_3,72; .set face_2,3; .set za_3,5; .set zb_2,8
        .set p_2,3; .set zc_3,23; .set lead_3,6; .set slope_5,25; .set p_3,7; .set v_2,9
        .set ahead_rows_3,6; .set header_2,3; .set header_3,29; .set v_3,39; .set vertex_c_3,7
        .set vertex_b_3,9; .set rest_2,53; .set w_2,65; .set a_shear_3,9; .set more_3,24
        .set det_2,26; .set axis_4,24; .set word_2,27; .set slope_6,28; .set det_3,29; .set ya_4,26
        .set bits_2,6; .set a_bound_2,6; .set a_packet_6,24; .set place_2,28; .set za_4,52
        .set zb_3,68; .set v_4,32; .set zc_4,69; .set ahead_rows_4,42; .set header_4,37
        .set rest_3,41; .set w_3,7; .set w_4,40; .set vertex_c_4,32; .set vertex_b_4,3
        .set vertex_c_5,2; .set ya_5,5; .set det_4,27; .set more_4,3; .set rest_4,8; .set v_5,25
        .set w_5,5; .set det_5,24; .set slope_7,3; .set za_5,4; .set zb_4,5; .set zc_5,6
        .set a_packet_7,7; .set p_4,8; .set a_packet_8,9; .set slope_8,14; .set index_4,13
        .set p_5,15; .set header_5,8; .set a_packet_9,16; .set v_6,17; .set w_6,15; .set rest_5,18
        .set w_7,19; .set object_2,13; .set w_8,2; .set index_5,2; .set axis_5,3; .set axis_6,2
        .set slope_9,5; .set slope_10,6; .set p_6,2; .set header_6,2; .set header_7,5
        ori     $a_rows,$a_first,0                      # 0e
        biz     $rows,$lr                               # 0o
        ilhu    $k_sign,0x8000                          # 1e
        lqd     $header,0($a_block)                     # 1o
        ila     $m_splat,0x10203                        # 2e
        lqd     $rest,16($a_block)                      # 2o
        ilhu    $k_above_one,0x3f80                     # 3e
        lqa     $m_indices,vertex_indices               # 3o
        il      $k_all,15                               # 4e
        ilhu    $k_below,0x7fff                         # 5e
        clgti   $rows_2,$rows,3                         # 6e at least as many passes as overlap
        lnop                                            # 6o pairing
        iohl    $k_above_one,2                          # 7e
        rotqbyi $hit,$header,4                          # 7o
        mpyi    $a_vertices,$rest,112                   # 8e
        rotqbyi $both,$rest,12                          # 8o
        ila     $a_controls,sign_controls               # 9e
        rotqbyi $a_faces,$rest,8                        # 9o
        il      $k_step,16                              # 10e
        shli    $hit,$hit,7                             # 11e
        shli    $both,$both,1                           # 12e SIDES_BOTH to the sign
        shli    $a_faces,$a_faces,4                     # 13e
        iohl    $k_below,0xffff                         # 14e
        a       $a_vertices,$a_vertices,$a_block        # 15e
        or      $hit,$hit,$k_sign                       # 16e
        shufb   $both,$both,$both,$m_splat              # 16o
        ai      $a_vertices,$a_vertices,32              # 17e
        lnop                                            # 17o pairing
        ori     $ahead_rows,$k_all,0                    # 18e
        shufb   $hit,$hit,$hit,$m_splat                 # 18o
        a       $a_faces,$a_faces,$a_vertices           # 19e
        brz     $rows_2,next_row_short                  # 19o too few passes
        ai      $rows,$rows,-1                          # 20e
        lqd     $word,0($a_rows)                        # 20o
        ai      $rows,$rows,-1                          # 22e
        ai      $rows,$rows,-1                          # 24e
        rotmi   $index,$word,-8                         # 26e 4 times it
        rotqbyi $a_bound,$word,8                        # 26o
        and     $bits,$word,$ahead_rows                 # 27e
        rotqbyi $a_packet,$word,4                       # 27o
        rotmi   $index_2,$word,-10                      # 28e
        clz     $lead,$bits                             # 29e
        a       $vertex_a,$a_faces,$index               # 30e
        lqx     $face,$a_faces,$index                   # 30o
        shli    $place,$lead,4                          # 31e
        lqd     $a_shear,192($a_bound)                  # 31o
        sfi     $lead_2,$lead,0                         # 32e
        shufb   $index_3,$index_2,$index_2,$m_splat     # 32o
        rotm    $ahead_rows_2,$k_below,$lead_2          # 34e
        a       $a_packet_2,$a_packet,$place            # 35e
        or      $object,$index_3,$hit                   # 36e
        rotqby  $face,$face,$vertex_a                   # 36o
        nop     $127                                    # 37e pairing
        rotqbyi $a_shear,$a_shear,8                     # 37o
        and     $more,$word,$ahead_rows_2               # 38e
        shlqbyi $a_packet_3,$a_packet_2,0               # 38o copy
        nop     $127                                    # 39e pairing
        shlqbyi $a_packet_4,$a_packet_2,0               # 39o copy
        andi    $more,$more,15                          # 40e
        shufb   $face,$face,$face,$m_indices            # 40o
        a       $a_shear_2,$a_shear,$place              # 41e
        lnop                                            # 41o pairing
        cgti    $more,$more,0                           # 42e
        shlqbyi $a_packet_5,$a_packet_3,0               # 42o copy
        nop     $127                                    # 43e pairing
        lqd     $axis,-320($a_shear_2)                  # 43o
        andc    $more_2,$k_step,$more                   # 44e
        shlqbii $face,$face,4                           # 44o
        selb    $ahead_rows,$k_all,$ahead_rows_2,$more  # 45e
        lqd     $axis_2,-448($a_shear_2)                # 45o
        a       $a_rows,$a_rows,$more_2                 # 46e
        lqd     $axis_3,-384($a_shear_2)                # 46o
        lqd     $slope_2,0($a_shear_2)                  # 47o
        rotqbyi $vertex_c_2,$face,8                     # 48o
        rotqbyi $vertex_b_2,$face,4                     # 49o
        lqx     $vertex_a,$a_vertices,$face             # 50o
        lqd     $slope_3,-64($a_shear_2)                # 51o
        lqx     $vertex_c_2,$a_vertices,$vertex_c_2     # 52o
        lqx     $vertex_b_2,$a_vertices,$vertex_b_2     # 53o
        lqd     $word,0($a_rows)                        # 54o
        lqd     $slope_4,64($a_shear_2)                 # 55o
        shufb   $za_2,$vertex_a,$vertex_a,$axis         # 56o
        shufb   $ya_2,$vertex_a,$vertex_a,$axis_3       # 57o
        shufb   $zc_2,$vertex_c_2,$vertex_c_2,$axis     # 58o
        nop     $127                                    # 59e pairing
        shufb   $xc,$vertex_c_2,$vertex_c_2,$axis_2     # 59o
        rotmi   $index,$word,-8                         # 60e 4 times it
        shufb   $yc,$vertex_c_2,$vertex_c_2,$axis_3     # 60o
        fnms    $ya_3,$slope_2,$za_2,$ya_2              # 61e
        shufb   $zb,$vertex_b_2,$vertex_b_2,$axis       # 61o
        and     $bits,$word,$ahead_rows                 # 62e
        shufb   $xb,$vertex_b_2,$vertex_b_2,$axis_2     # 62o
        fnms    $xc,$slope_3,$zc_2,$xc                  # 63e
        shufb   $xa,$vertex_a,$vertex_a,$axis_2         # 63o
        fnms    $yc,$slope_2,$zc_2,$yc                  # 64e
        shufb   $yb,$vertex_b_2,$vertex_b_2,$axis_3     # 64o
        a       $vertex_a,$a_faces,$index               # 65e
        lqx     $face_2,$a_faces,$index                 # 65o
        fnms    $xb,$slope_3,$zb,$xb                    # 66e
        rotqbyi $a_bound,$word,8                        # 66o
        fnms    $xa,$slope_3,$za_2,$xa                  # 67e
        shlqbyi $za_3,$za_2,0                           # 67o copy
        fnms    $yb,$slope_2,$zb,$yb                    # 68e
        shlqbyi $zb_2,$zb,0                             # 68o copy
        fm      $p,$ya_3,$xc                            # 69e
        rotqbyi $a_packet,$word,4                       # 69o
        clz     $lead,$bits                             # 70e
        lqd     $a_shear,192($a_bound)                  # 70o
        rotmi   $index_2,$word,-10                      # 71e
        rotqby  $face,$face_2,$vertex_a                 # 71o
        fm      $p_2,$yc,$xb                            # 72e
        shlqbyi $zc_3,$zc_2,0                           # 72o copy
        sfi     $lead_3,$lead,0                         # 73e
        shlqbyi $slope_5,$slope_4,0                     # 73o copy
        fm      $p_3,$yb,$xa                            # 74e
        lqd     $nearest,0($a_packet_4)                 # 74o
        fms     $header,$ya_3,$xc,$p                    # 75e
        shufb   $face,$face,$face,$m_indices            # 75o
        fms     $v_2,$xa,$yc,$p                         # 76e
        rotqbyi $a_shear,$a_shear,8                     # 76o
        rotm    $ahead_rows_3,$k_below,$lead_3          # 77e
        lqd     $t_best,-64($a_packet_4)                # 77o
        fms     $rest,$xc,$yb,$p_2                      # 78e
        shufb   $index_3,$index_2,$index_2,$m_splat     # 78o
        fms     $header_2,$yc,$xb,$p_2                  # 79e
        shlqbii $face,$face,4                           # 79o
        fms     $header_3,$yb,$xa,$p_3                  # 80e
        fms     $w,$xb,$ya_3,$p_3                       # 81e
        fs      $v_3,$v_2,$header                       # 82e
        lnop                                            # 82o pairing
        and     $more,$word,$ahead_rows_3               # 83e
        rotqbyi $vertex_c_3,$face,8                     # 83o
        shli    $place,$lead,4                          # 84e
        rotqbyi $vertex_b_3,$face,4                     # 84o
        fs      $rest_2,$rest,$header_2                 # 85e
        lqx     $vertex_a,$a_vertices,$face             # 85o
        andi    $more,$more,15                          # 86e
        lnop                                            # 86o pairing
        fs      $w_2,$w,$header_3                       # 87e
        lqx     $vertex_c_2,$a_vertices,$vertex_c_3     # 87o
        cgti    $more,$more,0                           # 88e
        lqx     $vertex_b_2,$a_vertices,$vertex_b_3     # 88o
        a       $a_shear_3,$a_shear,$place              # 89e
        andc    $more_3,$k_step,$more                   # 90e
        fa      $det_2,$rest_2,$v_3                     # 91e
        lqd     $axis,-320($a_shear_3)                  # 91o
        a       $a_rows,$a_rows,$more_3                 # 92e
        lqd     $axis_4,-448($a_shear_3)                # 92o
        selb    $ahead_rows_3,$k_all,$ahead_rows_3,$more # 93e
        lqd     $axis_3,-384($a_shear_3)                # 93o
        a       $a_packet_2,$a_packet,$place            # 94e
        lqd     $word_2,0($a_rows)                      # 94o
        lqd     $slope_6,0($a_shear_3)                  # 95o
        lqd     $slope_3,-64($a_shear_3)                # 96o
        fa      $det_3,$det_2,$w_2                      # 97e
        shufb   $za_2,$vertex_a,$vertex_a,$axis         # 97o
        shufb   $zc_2,$vertex_c_2,$vertex_c_2,$axis     # 98o
        shufb   $ya_4,$vertex_a,$vertex_a,$axis_3       # 99o
        rotmi   $index,$word_2,-8                       # 100e 4 times it
        shufb   $xc,$vertex_c_2,$vertex_c_2,$axis_4     # 100o
        and     $bits_2,$word_2,$ahead_rows_3           # 101e
        shufb   $yc,$vertex_c_2,$vertex_c_2,$axis_3     # 101o
        rotmi   $index_2,$word_2,-10                    # 102e
        shufb   $zb,$vertex_b_2,$vertex_b_2,$axis       # 102o
        fnms    $ya_3,$slope_6,$za_2,$ya_4              # 103e
        frest   $t_y,$det_3                             # 103o
        fnms    $xc,$slope_3,$zc_2,$xc                  # 104e
        shufb   $xb,$vertex_b_2,$vertex_b_2,$axis_4     # 104o
        fnms    $yc,$slope_6,$zc_2,$yc                  # 105e
        shufb   $xa,$vertex_a,$vertex_a,$axis_4         # 105o
        a       $vertex_a,$a_faces,$index               # 106e
        shufb   $yb,$vertex_b_2,$vertex_b_2,$axis_3     # 106o
        fi      $t_y,$det_3,$t_y                        # 107e
        lqx     $face_2,$a_faces,$index                 # 107o
        clz     $lead,$bits_2                           # 108e
        rotqbyi $a_bound_2,$word_2,8                    # 108o
        fnms    $xb,$slope_3,$zb,$xb                    # 109e
        rotqbyi $a_packet_6,$word_2,4                   # 109o
        fm      $p,$ya_3,$xc                            # 110e
        lqd     $slope,64($a_shear_3)                   # 110o
        fnms    $yb,$slope_6,$zb,$yb                    # 111e
        shlqbyi $a_packet_3,$a_packet_2,0               # 111o copy
        fnms    $xa,$slope_3,$za_2,$xa                  # 112e
        lqd     $a_shear,192($a_bound_2)                # 112o
        shli    $place_2,$lead,4                        # 113e
        rotqby  $face,$face_2,$vertex_a                 # 113o
        fnms    $t_e,$det_3,$t_y,$k_above_one           # 114e
        shlqbyi $a_packet_4,$a_packet_2,0               # 114o copy
        fm      $p_2,$yc,$xb                            # 115e
        shlqbyi $za_4,$za_2,0                           # 115o copy
        fms     $header,$ya_3,$xc,$p                    # 116e
        shlqbyi $zb_3,$zb,0                             # 116o copy
        sfi     $lead_3,$lead,0                         # 117e
        shufb   $face,$face,$face,$m_indices            # 117o
        fm      $p_3,$yb,$xa                            # 118e
        rotqbyi $a_shear,$a_shear,8                     # 118o
        fms     $v_4,$xa,$yc,$p                         # 119e
        shlqbyi $zc_4,$zc_2,0                           # 119o copy
        fma     $inverse,$t_e,$t_y,$t_y                 # 120e
        lnop                                            # 120o pairing
        fms     $rest,$xc,$yb,$p_2                      # 121e
        shlqbii $face,$face,4                           # 121o
        fms     $header_2,$yc,$xb,$p_2                  # 122e
        rotm    $ahead_rows_4,$k_below,$lead_3          # 123e
        a       $a_shear_2,$a_shear,$place_2            # 124e
        lnop                                            # 124o pairing
        fms     $header_4,$yb,$xa,$p_3                  # 125e
        lqx     $vertex_a,$a_vertices,$face             # 125o
        fm      $rest_3,$rest_2,$inverse                # 126e
        lqd     $axis,-320($a_shear_2)                  # 126o
        fm      $v,$v_3,$inverse                        # 127e
        lqd     $axis_2,-448($a_shear_2)                # 127o
        fms     $w_3,$xb,$ya_3,$p_3                     # 128e
        lqd     $slope_2,0($a_shear_2)                  # 128o
        fm      $w_4,$w_2,$inverse                      # 129e
        lqd     $axis_3,-384($a_shear_2)                # 129o
        fs      $v_3,$v_4,$header                       # 130e
        rotqbyi $vertex_c_4,$face,8                     # 130o
        fs      $rest_2,$rest,$header_2                 # 131e
        rotqbyi $vertex_b_4,$face,4                     # 131o
        fm      $ahead,$rest_3,$za_3                    # 132e
        shufb   $za_2,$vertex_a,$vertex_a,$axis         # 132o
        xor     $seen,$det_3,$slope_4                   # 133e of -1 / direction z
        lqd     $slope_3,-64($a_shear_2)                # 133o
        and     $more,$word_2,$ahead_rows_4             # 134e
        hbrr    next_row_back,next_row                  # 134o hint
        fs      $w_2,$w_3,$header_4                     # 135e
        lqx     $vertex_c_5,$a_vertices,$vertex_c_4     # 135o
        andi    $more,$more,15                          # 136e
        shufb   $ya_5,$vertex_a,$vertex_a,$axis_3       # 136o
        fa      $det_4,$rest_2,$v_3                     # 137e
        lqx     $vertex_b_2,$a_vertices,$vertex_b_4     # 137o
        fma     $ahead,$v,$zb_2,$ahead                  # 138e
        cgti    $more,$more,0                           # 139e
        fnms    $ya_3,$slope_2,$za_2,$ya_5              # 140e
        lnop                                            # 140o pairing
        andc    $more_4,$k_step,$more                   # 141e
        shufb   $zc_2,$vertex_c_5,$vertex_c_5,$axis     # 141o
        or      $outside,$rest_3,$v                     # 142e
        shufb   $xc,$vertex_c_5,$vertex_c_5,$axis_2     # 142o
        fa      $det_4,$det_4,$w_2                      # 143e
        shufb   $yc,$vertex_c_5,$vertex_c_5,$axis_3     # 143o
        fma     $ahead,$w_4,$zc_3,$ahead                # 144e
        selb    $ahead_rows,$k_all,$ahead_rows_4,$more  # 145e
        a       $a_rows,$a_rows,$more_4                 # 146e
        or      $seen,$seen,$both                       # 147e
        a       $a_packet_2,$a_packet_6,$place_2        # 148e
        or      $outside,$outside,$w_4                  # 149e
        fm      $ahead,$ahead,$slope_5                  # 150e
        lnop                                            # 150o pairing
next_row:
            orc     $outside,$outside,$seen             # 0e
        lqd     $word,0($a_rows)                        # 0o
            fnms    $xc,$slope_3,$zc_2,$xc              # 1e
            shufb   $zb,$vertex_b_2,$vertex_b_2,$axis   # 1o
            xor     $t,$ahead,$k_sign                   # 2e
            shufb   $xa,$vertex_a,$vertex_a,$axis_2     # 2o
            xor     $seen,$det_4,$slope                 # 3e of -1 / direction z
            frest   $t_y,$det_4                         # 3o
            fnms    $yc,$slope_2,$zc_2,$yc              # 4e
            shufb   $xb,$vertex_b_2,$vertex_b_2,$axis_2 # 4o
            cgt     $control,$t_best,$t                 # 5e
            shufb   $yb,$vertex_b_2,$vertex_b_2,$axis_3 # 5o
        rotmi   $index,$word,-8                         # 6e 4 times it
            shlqbyi $slope_4,$slope,0                   # 6o copy
            fm      $p,$ya_3,$xc                        # 7e
            lnop                                        # 7o pairing
            fi      $t_y,$det_4,$t_y                    # 8e
        rotqbyi $a_bound,$word,8                        # 8o
            and     $control,$control,$ahead            # 9e
        rotqbyi $a_packet,$word,4                       # 9o
            fnms    $xb,$slope_3,$zb,$xb                # 10e
            andc    $control,$control,$outside          # 11e
        and     $bits,$word,$ahead_rows                 # 12e
        lqd     $a_shear,192($a_bound)                  # 12o
            fnms    $yb,$slope_2,$zb,$yb                # 13e
            rotqbii $control,$control,1                 # 13o
            fnms    $xa,$slope_3,$za_2,$xa              # 14e
            fnms    $t_e,$det_4,$t_y,$k_above_one       # 15e
        clz     $lead,$bits                             # 16e
        lqx     $face,$a_faces,$index                   # 16o
            fm      $p_2,$yc,$xb                        # 17e
            gb      $control,$control                   # 17o
        a       $vertex_a,$a_faces,$index               # 18e
        rotqbyi $a_shear,$a_shear,8                     # 18o
        sfi     $lead_2,$lead,0                         # 19e
        shli    $place,$lead,4                          # 20e
            fma     $inverse,$t_e,$t_y,$t_y             # 21e
            shlqbii $control,$control,4                 # 21o
        rotm    $ahead_rows_2,$k_below,$lead_2          # 22e
        rotqby  $face,$face,$vertex_a                   # 22o
            fms     $rest,$xc,$yb,$p_2                  # 23e
            lqd     $slope,64($a_shear_2)               # 23o
        a       $a_shear_2,$a_shear,$place              # 24e
        lnop                                            # 24o pairing
            fm      $p_3,$yb,$xa                        # 25e
            lqx     $control,$control,$a_controls       # 25o
            fms     $header,$ya_3,$xc,$p                # 26e
        shufb   $face,$face,$face,$m_indices            # 26o
            fm      $v,$v_3,$inverse                    # 27e
        lqd     $axis,-320($a_shear_2)                  # 27o
            fm      $rest_4,$rest_2,$inverse            # 28e
        lqd     $axis_2,-448($a_shear_2)                # 28o
        and     $more,$word,$ahead_rows_2               # 29e
        lqd     $slope_2,0($a_shear_2)                  # 29o
            fms     $v_5,$xa,$yc,$p                     # 30e
        shlqbii $face,$face,4                           # 30o
        andi    $more,$more,15                          # 31e
            shufb   $nearest,$nearest,$object,$control  # 31o
            or      $object,$index_3,$hit               # 32e
            shufb   $t_best,$t_best,$t,$control         # 32o
            fms     $header_3,$yb,$xa,$p_3              # 33e
        lqd     $axis_3,-384($a_shear_2)                # 33o
            fms     $header_2,$yc,$xb,$p_2              # 34e
            shufb   $index_3,$index_2,$index_2,$m_splat # 34o
            fm      $ahead,$rest_4,$za_4                # 35e
            stqd    $nearest,0($a_packet_5)             # 35o
        cgti    $more,$more,0                           # 36e
            lqd     $nearest,0($a_packet_4)             # 36o
            fms     $w,$xb,$ya_3,$p_3                   # 37e
            stqd    $t_best,-64($a_packet_5)            # 37o
        selb    $ahead_rows,$k_all,$ahead_rows_2,$more  # 38e
            shlqbyi $a_packet_5,$a_packet_3,0           # 38o copy
            fm      $w_5,$w_2,$inverse                  # 39e
            shlqbyi $a_packet_3,$a_packet_2,0           # 39o copy
            fs      $v_3,$v_5,$header                   # 40e
            lqd     $t_best,-64($a_packet_4)            # 40o
            fma     $ahead,$v,$zb_3,$ahead              # 41e
            shlqbyi $a_packet_4,$a_packet_2,0           # 41o copy
            fs      $rest_2,$rest,$header_2             # 42e
        lqx     $vertex_a,$a_vertices,$face             # 42o
        andc    $more,$k_step,$more                     # 43e
        rotqbyi $vertex_c_2,$face,8                     # 43o
            fs      $w_2,$w,$header_3                   # 44e
        rotqbyi $vertex_b_2,$face,4                     # 44o
        a       $a_rows,$a_rows,$more                   # 45e
            shlqbyi $za_4,$za_2,0                       # 45o copy
        rotmi   $index_2,$word,-10                      # 46e
        lqd     $slope_3,-64($a_shear_2)                # 46o
            fma     $ahead,$w_5,$zc_4,$ahead            # 47e
        lqx     $vertex_c_2,$a_vertices,$vertex_c_2     # 47o
            fa      $det_5,$rest_2,$v_3                 # 48e
        shufb   $za_2,$vertex_a,$vertex_a,$axis         # 48o
            or      $outside,$rest_4,$v                 # 49e
            shlqbyi $zb_3,$zb,0                         # 49o copy
            or      $seen,$seen,$both                   # 50e
        lqx     $vertex_b_2,$a_vertices,$vertex_b_2     # 50o
        ai      $rows,$rows,-1                          # 51e
            shlqbyi $zc_4,$zc_2,0                       # 51o copy
        a       $a_packet_2,$a_packet,$place            # 52e
        shufb   $ya_2,$vertex_a,$vertex_a,$axis_3       # 52o
            fm      $ahead,$ahead,$slope_4              # 53e
        shufb   $zc_2,$vertex_c_2,$vertex_c_2,$axis     # 53o
            fa      $det_4,$det_5,$w_2                  # 54e
        shufb   $xc,$vertex_c_2,$vertex_c_2,$axis_2     # 54o
            or      $outside,$outside,$w_5              # 55e
        shufb   $yc,$vertex_c_2,$vertex_c_2,$axis_3     # 55o
        fnms    $ya_3,$slope_2,$za_2,$ya_2              # 56e
next_row_back:
        brnz    $rows,next_row                          # 56o
next_row_drain:
        fnms    $yc,$slope_2,$zc_2,$yc                  # 0e
        shufb   $xb,$vertex_b_2,$vertex_b_2,$axis_2     # 0o
        fnms    $xc,$slope_3,$zc_2,$xc                  # 1e
        shufb   $zb,$vertex_b_2,$vertex_b_2,$axis       # 1o
        xor     $t,$ahead,$k_sign                       # 2e
        frest   $t_y,$det_4                             # 2o
        orc     $outside,$outside,$seen                 # 3e
        shufb   $xa,$vertex_a,$vertex_a,$axis_2         # 3o
        cgt     $control,$t_best,$t                     # 4e
        shufb   $yb,$vertex_b_2,$vertex_b_2,$axis_3     # 4o
        fnms    $xb,$slope_3,$zb,$xb                    # 5e
        shlqbyi $slope_4,$slope,0                       # 5o copy
        fi      $t_y,$det_4,$t_y                        # 6e
        lqd     $slope_7,64($a_shear_2)                 # 6o
        and     $control,$control,$ahead                # 7e
        shlqbyi $za_5,$za_2,0                           # 7o copy
        fm      $p,$ya_3,$xc                            # 8e
        shlqbyi $zb_4,$zb,0                             # 8o copy
        fnms    $xa,$slope_3,$za_2,$xa                  # 9e
        shlqbyi $zc_5,$zc_2,0                           # 9o copy
        fnms    $yb,$slope_2,$zb,$yb                    # 10e
        shlqbyi $a_packet_7,$a_packet_3,0               # 10o copy
        fm      $p_4,$yc,$xb                            # 11e
        shlqbyi $a_packet_8,$a_packet_2,0               # 11o copy
        andc    $control,$control,$outside              # 12e
        shlqbyi $slope_8,$slope_7,0                     # 12o copy
        fnms    $t_e,$det_4,$t_y,$k_above_one           # 13e
        hbr     isect_mesh_rows_r4_return,$lr           # 13o hint
        fms     $header,$ya_3,$xc,$p                    # 14e
        rotqbii $control,$control,1                     # 14o
        fms     $v_5,$xa,$yc,$p                         # 15e
        shufb   $index_4,$index_2,$index_2,$m_splat     # 15o
        fm      $p_5,$yb,$xa                            # 16e
        shlqbyi $a_packet_3,$a_packet_2,0               # 16o copy
        fms     $rest,$xc,$yb,$p_4                      # 17e
        lnop                                            # 17o pairing
        fms     $header_5,$yc,$xb,$p_4                  # 18e
        gb      $control,$control                       # 18o
        fma     $inverse,$t_e,$t_y,$t_y                 # 19e
        lnop                                            # 19o pairing
        xor     $seen,$det_4,$slope                     # 20e of -1 / direction z
        shlqbyi $a_packet_9,$a_packet_3,0               # 20o copy
        fs      $v_6,$v_5,$header                       # 21e
        lnop                                            # 21o pairing
        fms     $header_3,$yb,$xa,$p_5                  # 22e
        shlqbii $control,$control,4                     # 22o
        fms     $w_6,$xb,$ya_3,$p_5                     # 23e
        fs      $rest_4,$rest,$header_5                 # 24e
        fm      $rest_5,$rest_2,$inverse                # 25e
        lnop                                            # 25o pairing
        fm      $v,$v_3,$inverse                        # 26e
        lqx     $control,$control,$a_controls           # 26o
        fm      $w_7,$w_2,$inverse                      # 27e
        or      $seen,$seen,$both                       # 28e
        fs      $w_2,$w_6,$header_3                     # 29e
        fa      $det_5,$rest_4,$v_6                     # 30e
        fm      $ahead,$rest_5,$za_4                    # 31e
        lnop                                            # 31o pairing
        or      $outside,$rest_5,$v                     # 32e
        shufb   $nearest,$nearest,$object,$control      # 32o
        or      $object,$index_3,$hit                   # 33e
        shufb   $t_best,$t_best,$t,$control             # 33o
        or      $outside,$outside,$w_7                  # 34e
        or      $object_2,$index_4,$hit                 # 35e
        fa      $det_4,$det_5,$w_2                      # 36e
        stqd    $nearest,0($a_packet_5)                 # 36o
        fma     $ahead,$v,$zb_3,$ahead                  # 37e
        lqd     $nearest,0($a_packet_4)                 # 37o
        orc     $outside,$outside,$seen                 # 38e
        stqd    $t_best,-64($a_packet_5)                # 38o
        nop     $127                                    # 39e pairing
        lqd     $t_best,-64($a_packet_4)                # 39o
        xor     $seen,$det_4,$slope_7                   # 42e of -1 / direction z
        frest   $t_y,$det_4                             # 42o
        fma     $ahead,$w_7,$zc_4,$ahead                # 43e
        or      $seen,$seen,$both                       # 44e
        fi      $t_y,$det_4,$t_y                        # 46e
        fm      $ahead,$ahead,$slope_4                  # 49e
        fnms    $t_e,$det_4,$t_y,$k_above_one           # 53e
        xor     $t,$ahead,$k_sign                       # 55e
        cgt     $control,$t_best,$t                     # 57e
        fma     $inverse,$t_e,$t_y,$t_y                 # 59e
        and     $control,$control,$ahead                # 60e
        andc    $control,$control,$outside              # 62e
        rotqbii $control,$control,1                     # 64o
        fm      $rest_4,$rest_4,$inverse                # 65e
        fm      $v,$v_6,$inverse                        # 66e
        fm      $w_8,$w_2,$inverse                      # 67e
        gb      $control,$control                       # 68o
        fm      $ahead,$rest_4,$za_5                    # 71e
        or      $outside,$rest_4,$v                     # 72e
        shlqbii $control,$control,4                     # 72o
        or      $outside,$outside,$w_8                  # 74e
        lnop                                            # 74o pairing
        orc     $outside,$outside,$seen                 # 76e
        lqx     $control,$control,$a_controls           # 76o
        fma     $ahead,$v,$zb_4,$ahead                  # 77e
        shufb   $nearest,$nearest,$object,$control      # 82o
        fma     $ahead,$w_8,$zc_5,$ahead                # 83e
        shufb   $t_best,$t_best,$t,$control             # 83o
        stqd    $nearest,0($a_packet_7)                 # 86o
        lqd     $nearest,0($a_packet_8)                 # 87o
        nop     $127                                    # 88e pairing
        stqd    $t_best,-64($a_packet_7)                # 88o
        fm      $ahead,$ahead,$slope_8                  # 89e
        lqd     $t_best,-64($a_packet_8)                # 89o
        xor     $t,$ahead,$k_sign                       # 95e
        cgt     $control,$t_best,$t                     # 97e
        and     $control,$control,$ahead                # 99e
        andc    $control,$control,$outside              # 101e
        rotqbii $control,$control,1                     # 103o
        gb      $control,$control                       # 107o
        shlqbii $control,$control,4                     # 111o
        lqx     $control,$control,$a_controls           # 115o
        shufb   $nearest,$nearest,$object_2,$control    # 121o
        shufb   $t_best,$t_best,$t,$control             # 122o
        stqd    $nearest,0($a_packet_9)                 # 125o
        stqd    $t_best,-64($a_packet_9)                # 126o
        nop     $127                                    # 127e pairing
isect_mesh_rows_r4_return:
        bi      $lr                                     # 127o
next_row_short:
        ai      $rows,$rows,-1                          # 0e
        lqd     $word,0($a_rows)                        # 0o
        rotmi   $index,$word,-8                         # 6e 4 times it
        rotqbyi $a_bound,$word,8                        # 6o
        and     $bits,$word,$ahead_rows                 # 7e
        rotqbyi $a_packet,$word,4                       # 7o
        rotmi   $index_5,$word,-10                      # 8e
        clz     $lead,$bits                             # 9e
        a       $vertex_a,$a_faces,$index               # 10e
        lqx     $face,$a_faces,$index                   # 10o
        shli    $place,$lead,4                          # 11e
        lqd     $a_shear,192($a_bound)                  # 11o
        sfi     $lead,$lead,0                           # 12e
        shufb   $index,$index_5,$index_5,$m_splat       # 12o
        rotm    $ahead_rows,$k_below,$lead              # 14e
        a       $a_packet,$a_packet,$place              # 15e
        or      $object,$index,$hit                     # 16e
        rotqby  $face,$face,$vertex_a                   # 16o
        nop     $127                                    # 17e pairing
        rotqbyi $a_shear,$a_shear,8                     # 17o
        and     $more,$word,$ahead_rows                 # 18e
        lqd     $t_best,-64($a_packet)                  # 18o
        nop     $127                                    # 19e pairing
        lqd     $nearest,0($a_packet)                   # 19o
        andi    $more,$more,15                          # 20e
        shufb   $face,$face,$face,$m_indices            # 20o
        a       $a_shear,$a_shear,$place                # 21e
        cgti    $more,$more,0                           # 22e
        nop     $127                                    # 23e pairing
        lqd     $axis,-448($a_shear)                    # 23o
        andc    $more_2,$k_step,$more                   # 24e
        shlqbii $face,$face,4                           # 24o
        selb    $ahead_rows,$k_all,$ahead_rows,$more    # 25e
        lqd     $axis_5,-384($a_shear)                  # 25o
        a       $a_rows,$a_rows,$more_2                 # 26e
        lqd     $axis_6,-320($a_shear)                  # 26o
        lqd     $slope,0($a_shear)                      # 27o
        rotqbyi $vertex_b,$face,4                       # 28o
        rotqbyi $vertex_c,$face,8                       # 29o
        lqx     $vertex_a,$a_vertices,$face             # 30o
        lqd     $slope_9,-64($a_shear)                  # 31o
        lqx     $vertex_b,$a_vertices,$vertex_b         # 32o
        lqx     $vertex_c,$a_vertices,$vertex_c         # 33o
        lqd     $slope_10,64($a_shear)                  # 34o
        shufb   $ya,$vertex_a,$vertex_a,$axis_5         # 36o
        shufb   $za,$vertex_a,$vertex_a,$axis_6         # 37o
        shufb   $xb,$vertex_b,$vertex_b,$axis           # 38o
        shufb   $yc,$vertex_c,$vertex_c,$axis_5         # 39o
        nop     $127                                    # 40e pairing
        shufb   $zc,$vertex_c,$vertex_c,$axis_6         # 40o
        fnms    $ya,$slope,$za,$ya                      # 41e
        shufb   $xc,$vertex_c,$vertex_c,$axis           # 41o
        shufb   $zb,$vertex_b,$vertex_b,$axis_6         # 42o
        shufb   $xa,$vertex_a,$vertex_a,$axis           # 43o
        fnms    $yc,$slope,$zc,$yc                      # 44e
        shufb   $yb,$vertex_b,$vertex_b,$axis_5         # 44o
        fnms    $xc,$slope_9,$zc,$xc                    # 45e
        fnms    $xb,$slope_9,$zb,$xb                    # 46e
        fnms    $xa,$slope_9,$za,$xa                    # 47e
        fnms    $yb,$slope,$zb,$yb                      # 48e
        fm      $p,$ya,$xc                              # 51e
        fm      $p_6,$yc,$xb                            # 52e
        fm      $p_2,$yb,$xa                            # 54e
        fms     $v,$xa,$yc,$p                           # 57e
        fms     $rest,$xc,$yb,$p_6                      # 58e
        fms     $header,$yc,$xb,$p_6                    # 59e
        fms     $header_6,$ya,$xc,$p                    # 60e
        fms     $header_7,$yb,$xa,$p_2                  # 61e
        fms     $w,$xb,$ya,$p_2                         # 62e
        fs      $rest,$rest,$header                     # 65e
        fs      $v,$v,$header_6                         # 66e
        fs      $w,$w,$header_7                         # 68e
        fa      $det,$rest,$v                           # 72e
        fa      $det,$det,$w                            # 78e
        xor     $seen,$det,$slope_10                    # 84e of -1 / direction z
        frest   $t_y,$det                               # 84o
        or      $seen,$seen,$both                       # 86e
        fi      $t_y,$det,$t_y                          # 88e
        fnms    $t_e,$det,$t_y,$k_above_one             # 95e
        fma     $inverse,$t_e,$t_y,$t_y                 # 101e
        fm      $rest,$rest,$inverse                    # 107e
        fm      $v,$v,$inverse                          # 108e
        fm      $w,$w,$inverse                          # 109e
        fm      $ahead,$rest,$za                        # 113e
        or      $outside,$rest,$v                       # 114e
        or      $outside,$outside,$w                    # 116e
        orc     $outside,$outside,$seen                 # 118e
        fma     $ahead,$v,$zb,$ahead                    # 119e
        fma     $ahead,$w,$zc,$ahead                    # 125e
        fm      $ahead,$ahead,$slope_10                 # 131e
        xor     $t,$ahead,$k_sign                       # 137e
        cgt     $control,$t_best,$t                     # 139e
        and     $control,$control,$ahead                # 141e
        andc    $control,$control,$outside              # 143e
        rotqbii $control,$control,1                     # 145o
        gb      $control,$control                       # 149o
        shlqbii $control,$control,4                     # 153o
        lqx     $control,$control,$a_controls           # 157o
        shufb   $t_best,$t_best,$t,$control             # 163o
        shufb   $nearest,$nearest,$object,$control      # 164o
        stqd    $t_best,-64($a_packet)                  # 167o
        stqd    $nearest,0($a_packet)                   # 168o
        nop     $127                                    # 169e pairing
        brnz    $rows,next_row_short                    # 169o
        nop     $127                                    # 170e pairing
        bi      $lr                                     # 170o
endfunction isect_mesh_rows_r4
