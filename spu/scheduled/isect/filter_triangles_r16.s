# filter_triangles_r16   of runs of a mesh's triangles, the rows of packets that may hit each one
#   C       vec_uint4 filter_triangles_r16(const struct mesh_candidate *, int count,
#                                          const struct mesh_header *, struct mesh_rows *,
#                                          const struct mesh_window *);
#   In      $3 candidates of runs of triangles, $4 count (0 is none), $5 the runs' block, in local
#           store and relative to the eye, $6 where the list goes, $7 the packets' windows, that of
#           packet 0 first; the last three bits of a candidate's packet are its number; pointers
#           16-aligned
#   Out     $3 behind the list, how many rows are in it, how many triangles were tested with a
#           packet, and anything. The list has each triangle and packet with a row that may hit it,
#           run by run; one more record may be written
#   Uses    $2-$5, $7-$71, $79   Saves  -   Stack  0   Calls  -
#   Domain  rays from the eye; coordinates below 2^60; runs of at least one triangle
#   Error   0: no row is left out that has a ray through the triangle
#   Twin    lab/twins/src/mesh_rows.rs
#
# Four triangles of a run are in the four lanes. Their vertices are projected on the plane that the
# packet's window lies in, by a division. A row may hit a triangle if the box around its vertices
# there meets the row's window. A triangle with vertices on both sides of the eye may be anywhere.
# One behind the eye may pass, since it can't be hit.
# Scheduled by spu schedule from filter_triangles_r16.s

        .include "work_unit.inc"
        .include "macros.inc"
        .include "reciprocal.inc"

        .set    NEXT,3
        registers a_first                               # candidate
        registers count,a_block,a_list,a_windows
        # constants
        .set    NEXT,10
        registers k_one,k_step,k_lanes,k_places,m_upper,m_lower,m_splat
        registers m_record                              # to 20
        .set    NEXT,m_record+4
        # the block
        registers a_vertices,a_faces,a_more_faces
        # state
        registers a_candidate,at
        registers found                                 # bytes of the list so far
        registers rows,chunks
        # the candidate
        registers candidate,a_window,index,length,left
        # four triangles
        registers faces,more_faces,shift,t_index
        registers vertex                                # to 44
        .set    NEXT,vertex+4
        registers m_order,m_depth
        registers upper,lower                           # of the transposition
        registers xa,ya,za,xb,yb,zb,xc,yc,zc,t_y,t_e
        registers c_more
        registers low_x,high_x,low_y,high_y
        registers limit,outside,row,crosses,word,record,steps
        registers triangles
        # only before the loop
        .set    rest,xa

        .section .rodata.mesh,"a",@progbits
        .align  4
# A record's first word is one of four, the rest is the candidate's.
record_words:
    .irp triangle, 0,1,2,3
        .int    0x00010203+0x04040404*\triangle,0x14151617,0x18191a1b,0x1c1d1e1f
    .endr
four_times:                             # the lanes' numbers
        .int    0,4,8,12
upper_halves:
        .int    0x00010203,0x04050607,0x10111213,0x14151617
lower_halves:
        .int    0x08090a0b,0x0c0d0e0f,0x18191a1b,0x1c1d1e1f

# The components of four vertices, whose offsets are in words of t_index.
.macro  load_vertices x:req, y:req, z:req
        lqx     $vertex,$a_vertices,$t_index
    .irp triangle, 1,2,3
        rotqbyi $vertex+\triangle,$t_index,4*\triangle
        lqx     $vertex+\triangle,$a_vertices,$vertex+\triangle
    .endr
        shufb   $upper,$vertex,$vertex+1,$m_order
        shufb   $lower,$vertex+2,$vertex+3,$m_order
        shufb   \x,$upper,$lower,$m_upper
        shufb   \y,$upper,$lower,$m_lower
        shufb   $upper,$vertex,$vertex+1,$m_depth
        shufb   $lower,$vertex+2,$vertex+3,$m_depth
        shufb   \z,$upper,$lower,$m_upper
.endm

# The least and the greatest of three.
.macro  limits low:req, high:req, a:req, b:req, c:req
        fcgt    $c_more,\a,\b
        selb    \low,\a,\b,$c_more
        selb    \high,\b,\a,$c_more
        fcgt    $c_more,\low,\c
        selb    \low,\low,\c,$c_more
        fcgt    $c_more,\c,\high
        selb    \high,\high,\c,$c_more
.endm

function filter_triangles_r16
        .set count_2,79; .set record_2,2; .set word_2,2; .set word_3,8; .set word_4,3
        .set word_5,4; .set chunks_2,79; .set at_2,9; .set outside_2,2; .set outside_3,65
        .set candidate_2,8; .set shift_2,44; .set more_faces_2,45; .set faces_2,35; .set shift_3,46
        .set word_6,31; .set left_2,32; .set c_more_2,33; .set a_window_2,3; .set m_depth_2,4
        .set t_index_2,30; .set m_order_2,35; .set limit_2,38; .set t_index_3,34; .set limit_3,5
        .set index_2,9; .set a_window_3,33; .set limit_4,36; .set vertex3_2,46; .set vertex2_2,45
        .set vertex2_3,53; .set shift_4,40; .set vertex3_3,47; .set vertex1_2,43; .set length_2,41
        .set vertex_2,37; .set left_3,71; .set at_3,32; .set vertex3_4,51; .set left_4,31
        .set vertex_3,30; .set vertex2_4,41; .set a_window_4,55; .set vertex1_3,33
        .set c_more_3,39; .set vertex2_5,32; .set vertex1_4,49; .set vertex3_5,42; .set vertex_4,50
        .set vertex1_5,34; .set upper_2,39; .set lower_2,52; .set lower_3,48; .set upper_3,49
        .set upper_4,51; .set za_2,39; .set lower_4,4; .set zb_2,48; .set faces_3,49; .set t_y_2,52
        .set crosses_2,4; .set t_y_3,51; .set more_faces_3,53; .set upper_5,30; .set outside_4,43
        .set t_y_4,56; .set faces_4,44; .set lower_5,32; .set t_y_5,43; .set more_faces_4,40
        .set crosses_3,70; .set upper_6,4; .set upper_7,37; .set t_e_2,33; .set lower_6,34
        .set t_e_3,4; .set m_depth_3,32; .set limit_5,33; .set t_index_4,35; .set limit_6,37
        .set vertex1_6,44; .set vertex3_6,4; .set vertex3_7,39; .set c_more_4,40; .set upper_8,42
        .set lower_7,40; .set c_more_5,46; .set c_more_6,48; .set vertex2_6,54; .set limit_7,46
        .set za_3,40; .set c_more_7,42; .set limit_8,48; .set limit_9,47; .set row_2,36
        .set vertex3_8,34; .set vertex2_7,39; .set limit_10,51; .set row_3,46; .set vertex_5,35
        .set row_4,5; .set limit_11,52; .set row_5,48; .set limit_12,53; .set row_6,33
        .set t_y_6,54; .set row_7,37; .set limit_13,3; .set lower_8,47; .set upper_9,48
        .set upper_10,56; .set t_y_7,57; .set m_order_3,38; .set limit_14,58; .set row_8,32
        .set word_7,9; .set t_y_8,48; .set t_y_9,53; .set lower_9,2; .set lower_10,30; .set row_9,4
        .set row_10,39; .set crosses_4,2; .set outside_5,3; .set t_y_10,34; .set t_y_11,33
        .set word_8,5; .set t_e_4,2; .set record_3,3; .set record_4,4; .set record_5,5
        .set record_6,33; .set record_7,34; .set found_2,5; .set c_more_8,35; .set record_8,36
        .set c_more_9,4; .set limit_15,35; .set limit_16,4; .set limit_17,39; .set row_11,35
        .set limit_18,40; .set limit_19,41; .set limit_20,42; .set limit_21,43; .set limit_22,9
        .set found_3,2; .set limit_23,2; .set m_depth_4,3; .set upper_11,40; .set vertex1_7,37
        .set vertex2_8,34; .set t_y_12,4; .set upper_12,33; .set lower_11,3; .set t_y_13,3
        .set t_y_14,5; .set outside_6,9; .set record_9,7; .set found_4,3; .set c_more_10,7
        .set limit_24,7; .set c_more_11,10; .set c_more_12,11; .set limit_25,11; .set limit_26,10
        .set candidate_3,12; .set limit_27,8; .set row_12,3; .set found_5,7; .set record_10,8
        .set record_11,9; .set found_6,4; .set row_13,10; .set found_7,11; .set a_first_2,7
        .set at_4,2; .set shift_5,3; .set t_index_5,2; .set t_index_6,3; .set vertex1_8,4
        .set vertex2_9,31; .set vertex3_9,32; .set vertex3_10,35; .set vertex_6,2
        .set vertex2_10,36; .set vertex_7,3; .set lower_12,46; .set upper_13,47; .set t_y_15,2
        .set outside_7,37; .set t_y_16,38; .set lower_13,31; .set t_y_17,35; .set t_e_5,3
        .set limit_28,31; .set limit_29,34; .set t_e_6,36; .set limit_30,32; .set limit_31,30
        .set c_more_13,41; .set row_14,8; .set row_15,2
        ori     $a_candidate,$a_first,0                 # 0e
        fsmbi   $record,0xf000                          # 0o
        il      $chunks,0                               # 1e
        il      $triangles,0                            # 2e
        and     $a_first,$a_list,$record                # 4e
        biz     $count,$lr                              # 4o
        clgti   $count_2,$count,2                       # 5e at least as many passes as overlap
        ori     $record,$a_candidate,0                  # 6e
        nop     $127                                    # 7e pairing
        brz     $count_2,next_run_short                 # 7o too few passes
        ai      $record_2,$record,16                    # 8e
        lqd     $word,0($record)                        # 8o
        ai      $count,$count,-1                        # 9e
        hbrr    next_run_back,next_run                  # 9o hint
        ai      $record,$record_2,16                    # 10e
        lqd     $word_2,0($record_2)                    # 10o
        ai      $count,$count,-1                        # 11e
        rotmi   $word_3,$word,-16                       # 14e
        rotmi   $word_4,$word_2,-16                     # 16e
        ai      $word_2,$word_3,3                       # 18e
        a       $triangles,$triangles,$word_3           # 19e
        rotmi   $word_2,$word_2,-2                      # 20e
next_run:
        ai      $count,$count,-1                        # 0e
        lqd     $word,0($record)                        # 0o
        ai      $record,$record,16                      # 1e
            a       $chunks,$chunks,$word_2             # 2e
            ai      $word_2,$word_4,3                   # 3e
            a       $triangles,$triangles,$word_4       # 4e
            rotmi   $word_2,$word_2,-2                  # 5e
            lnop                                        # 5o pairing
        rotmi   $word_4,$word,-16                       # 6e
next_run_back:
        brnz    $count,next_run                         # 6o
next_run_drain:
        ai      $word_5,$word_4,3                       # 0e
        a       $chunks,$chunks,$word_2                 # 1e
        rotmi   $word_2,$word_5,-2                      # 2e
        a       $triangles,$triangles,$word_4           # 3e
        a       $chunks,$chunks,$word_2                 # 6e
        lnop                                            # 6o pairing
filter_triangles_r16_block:
        clgti   $chunks_2,$chunks,2                     # 0e at least as many passes as overlap
        lqd     $rest,16($a_block)                      # 0o
        ilhu    $k_one,0x3f80                           # 1e
        lqa     $k_lanes,four_times                     # 1o
        il      $k_step,16                              # 2e
        lqa     $m_upper,upper_halves                   # 2o
        il      $k_places,0xff0                         # 3e
        lqa     $m_lower,lower_halves                   # 3o
        ila     $m_splat,0x10203                        # 4e
        lqa     $m_record,record_words                  # 4o
        il      $at,0                                   # 5e
        lqa     $m_record+1,record_words+16             # 5o
        mpyi    $a_vertices,$rest,112                   # 6e
        rotqbyi $a_faces,$rest,8                        # 6o
        il      $rows,0                                 # 7e
        lqa     $m_record+2,record_words+32             # 7o
        il      $found,0                                # 8e
        lqa     $m_record+3,record_words+48             # 8o
        shli    $a_faces,$a_faces,4                     # 10e
        a       $a_vertices,$a_vertices,$a_block        # 13e
        ai      $a_vertices,$a_vertices,32              # 15e
        a       $a_faces,$a_faces,$a_vertices           # 17e
        ai      $a_more_faces,$a_faces,16               # 19e
        brz     $chunks_2,next_chunk_short              # 19o too few passes
        ai      $at_2,$at,16                            # 20e
        lqd     $candidate,0($a_candidate)              # 20o
        il      $outside_2,0                            # 21e
        ai      $chunks,$chunks,-1                      # 22e
        il      $outside_3,0                            # 23e
        ai      $chunks,$chunks,-1                      # 24e
        andi    $index,$candidate,511                   # 26e 4 times it
        rotqbyi $a_window,$candidate,4                  # 26o
        rotmi   $length,$candidate,-14                  # 27e 4 times it
        shlqbyi $candidate_2,$candidate,0               # 27o copy
        a       $index,$index,$at                       # 28e
        lnop                                            # 28o pairing
        andi    $shift_2,$index,15                      # 30e
        lqx     $more_faces_2,$a_more_faces,$index      # 30o
        andi    $a_window,$a_window,7                   # 31e
        lqx     $faces_2,$a_faces,$index                # 31o
        ai      $shift_3,$shift_2,-16                   # 32e
        shufb   $word_6,$index,$index,$m_splat          # 32o
        mpyi    $a_window,$a_window,288                 # 33e
        cgt     $c_more,$length,$at_2                   # 34e
        sf      $left_2,$at,$length                     # 35e
        lnop                                            # 35o pairing
        andc    $c_more_2,$k_step,$c_more               # 36e
        rotqmby $more_faces_2,$more_faces_2,$shift_3    # 36o
        and     $at,$at_2,$c_more                       # 37e
        shlqby  $faces_2,$faces_2,$shift_2              # 37o
        a       $a_candidate,$a_candidate,$c_more_2     # 38e
        shufb   $left_2,$left_2,$left_2,$m_splat        # 38o
        a       $word_6,$word_6,$k_lanes                # 39e
        lnop                                            # 39o pairing
        a       $a_window_2,$a_window,$a_windows        # 40e
        lqd     $candidate,0($a_candidate)              # 40o
        or      $faces,$faces_2,$more_faces_2           # 41e
        lnop                                            # 41o pairing
        cgt     $left_2,$left_2,$k_lanes                # 42e
        lqd     $m_depth_2,272($a_window_2)             # 42o
        rotmi   $t_index_2,$faces,-12                   # 43e
        lqd     $m_order_2,256($a_window_2)             # 43o
        rotmi   $t_index,$faces,-20                     # 44e
        lqd     $limit_2,64($a_window_2)                # 44o
        rotmi   $t_index_3,$faces,-4                    # 45e
        lqd     $limit_3,80($a_window_2)                # 45o
        andi    $index_2,$candidate,511                 # 46e 4 times it
        rotqbyi $a_window_3,$candidate,4                # 46o
        and     $t_index_2,$t_index_2,$k_places         # 47e
        lqd     $limit_4,0($a_window_2)                 # 47o
        a       $index_2,$index_2,$at                   # 48e
        rotqbyi $vertex3_2,$t_index,12                  # 48o
        and     $t_index_3,$t_index_3,$k_places         # 49e
        rotqbyi $vertex2_2,$t_index,8                   # 49o
        andi    $shift_2,$index_2,15                    # 50e
        rotqbyi $vertex2_3,$t_index_2,8                 # 50o
        andi    $a_window_3,$a_window_3,7               # 51e
        rotqbyi $vertex+1,$t_index,4                    # 51o
        ai      $shift_4,$shift_2,-16                   # 52e
        rotqbyi $vertex3_3,$t_index_2,12                # 52o
        mpyi    $a_window_3,$a_window_3,288             # 53e
        rotqbyi $vertex1_2,$t_index_2,4                 # 53o
        rotmi   $length_2,$candidate,-14                # 54e 4 times it
        lqx     $vertex_2,$a_vertices,$t_index          # 54o
        andi    $left_3,$left_2,15                      # 55e
        lqx     $vertex2_2,$a_vertices,$vertex2_2       # 55o
        ai      $at_3,$at,16                            # 56e
        lqx     $vertex3_2,$a_vertices,$vertex3_2       # 56o
        shli    $word,$word_6,8                         # 57e
        rotqbyi $vertex3_4,$t_index_3,12                # 57o
        sf      $left_4,$at,$length_2                   # 58e
        lqx     $vertex_3,$a_vertices,$t_index_2        # 58o
        cgt     $c_more,$length_2,$at_3                 # 59e
        rotqbyi $vertex2_4,$t_index_3,8                 # 59o
        a       $a_window_4,$a_window_3,$a_windows      # 60e
        lqx     $vertex1_3,$a_vertices,$vertex+1        # 60o
        andc    $c_more_3,$k_step,$c_more               # 61e
        lqx     $vertex1_2,$a_vertices,$vertex1_2       # 61o
        and     $at,$at_3,$c_more                       # 62e
        lqx     $vertex2_5,$a_vertices,$vertex2_3       # 62o
        a       $a_candidate,$a_candidate,$c_more_3     # 63e
        rotqbyi $vertex1_4,$t_index_3,4                 # 63o
        lqx     $vertex3_3,$a_vertices,$vertex3_3       # 64o
        lqx     $vertex3_5,$a_vertices,$vertex3_4       # 65o
        lqx     $vertex_4,$a_vertices,$t_index_3        # 66o
        lqx     $vertex1_5,$a_vertices,$vertex1_4       # 67o
        shufb   $upper_2,$vertex_2,$vertex1_3,$m_depth_2 # 68o
        lqx     $vertex2_4,$a_vertices,$vertex2_4       # 69o
        shufb   $lower_2,$vertex2_2,$vertex3_2,$m_depth_2 # 70o
        shufb   $lower_3,$vertex2_5,$vertex3_3,$m_depth_2 # 71o
        shufb   $upper_3,$vertex_3,$vertex1_2,$m_depth_2 # 72o
        shufb   $upper_4,$vertex_4,$vertex1_5,$m_depth_2 # 73o
        shufb   $za_2,$upper_2,$lower_2,$m_upper        # 74o
        shufb   $lower_4,$vertex2_4,$vertex3_5,$m_depth_2 # 75o
        shufb   $zb_2,$upper_3,$lower_3,$m_upper        # 76o
        lqx     $faces_3,$a_faces,$index_2              # 77o
        frest   $t_y_2,$za_2                            # 78o
        shufb   $zc,$upper_4,$lower_4,$m_upper          # 79o
        xor     $crosses_2,$za_2,$zb_2                  # 80e
        frest   $t_y_3,$zb_2                            # 80o
        nop     $127                                    # 81e pairing
        lqx     $more_faces_3,$a_more_faces,$index_2    # 81o
        fi      $t_y_2,$za_2,$t_y_2                     # 82e
        shufb   $upper_5,$vertex_3,$vertex1_2,$m_order_2 # 82o
        xor     $outside_4,$za_2,$zc                    # 83e
        frest   $t_y_4,$zc                              # 83o
        fi      $t_y_3,$zb_2,$t_y_3                     # 84e
        shlqby  $faces_4,$faces_3,$shift_2              # 84o
        or      $crosses_2,$crosses_2,$outside_4        # 85e
        shufb   $lower_5,$vertex2_5,$vertex3_3,$m_order_2 # 85o
        nop     $127                                    # 86e pairing
        shufb   $lower,$vertex2_2,$vertex3_2,$m_order_2 # 86o
        fi      $t_y_5,$zc,$t_y_4                       # 87e
        rotqmby $more_faces_4,$more_faces_3,$shift_4    # 87o
        rotmai  $crosses_3,$crosses_2,-31               # 88e
        shufb   $upper_6,$vertex_2,$vertex1_3,$m_order_2 # 88o
        fnms    $t_e,$za_2,$t_y_2,$k_one                # 89e
        shufb   $xb,$upper_5,$lower_5,$m_upper          # 89o
        nop     $127                                    # 90e pairing
        shufb   $upper_7,$vertex_4,$vertex1_5,$m_order_2 # 90o
        fnms    $t_e_2,$zb_2,$t_y_3,$k_one              # 91e
        shufb   $lower_6,$vertex2_4,$vertex3_5,$m_order_2 # 91o
        or      $faces_2,$faces_4,$more_faces_4         # 92e
        shufb   $rest,$upper_6,$lower,$m_upper          # 92o
        nop     $127                                    # 93e pairing
        shufb   $ya,$upper_6,$lower,$m_lower            # 93o
        fnms    $t_e_3,$zc,$t_y_5,$k_one                # 94e
        shufb   $yb,$upper_5,$lower_5,$m_lower          # 94o
        fma     $za,$t_e,$t_y_2,$t_y_2                  # 95e
        shufb   $xc,$upper_7,$lower_6,$m_upper          # 95o
        rotmi   $t_index_2,$faces_2,-20                 # 96e
        lqd     $m_depth_3,272($a_window_4)             # 96o
        fma     $zb,$t_e_2,$t_y_3,$t_y_3                # 97e
        shufb   $yc,$upper_7,$lower_6,$m_lower          # 97o
        rotmi   $t_index_3,$faces_2,-4                  # 98e
        lqd     $limit_5,128($a_window_2)               # 98o
        rotmi   $t_index_4,$faces_2,-12                 # 99e
        lqd     $limit_6,96($a_window_2)                # 99o
        fma     $zc,$t_e_3,$t_y_5,$t_y_5                # 100e
        rotqbyi $vertex1_6,$t_index_2,4                 # 100o
        fm      $rest,$rest,$za                         # 101e
        rotqbyi $vertex2_2,$t_index_2,8                 # 101o
        fm      $ya,$ya,$za                             # 102e
        rotqbyi $vertex3_6,$t_index_2,12                # 102o
        fm      $xb,$xb,$zb                             # 103e
        lqx     $vertex_3,$a_vertices,$t_index_2        # 103o
        fm      $yb,$yb,$zb                             # 104e
        lqx     $vertex1_6,$a_vertices,$vertex1_6       # 104o
        and     $t_index_4,$t_index_4,$k_places         # 105e
        lqx     $vertex2_2,$a_vertices,$vertex2_2       # 105o
        fm      $xc,$xc,$zc                             # 106e
        lqx     $vertex3_6,$a_vertices,$vertex3_6       # 106o
        fm      $yc,$yc,$zc                             # 107e
        rotqbyi $vertex1_2,$t_index_4,4                 # 107o
        and     $t_index_3,$t_index_3,$k_places         # 108e
        rotqbyi $vertex3_7,$t_index_4,12                # 108o
        fcgt    $c_more_4,$rest,$xb                     # 109e
        rotqbyi $vertex2_4,$t_index_4,8                 # 109o
        fcgt    $c_more,$ya,$yb                         # 110e
        rotqbyi $vertex3_4,$t_index_3,12                # 110o
        selb    $high_x,$xb,$rest,$c_more_4             # 111e
        shufb   $upper_8,$vertex_3,$vertex1_6,$m_depth_3 # 111o
        selb    $low_x,$rest,$xb,$c_more_4              # 112e
        shufb   $lower_7,$vertex2_2,$vertex3_6,$m_depth_3 # 112o
        fcgt    $c_more_5,$xc,$high_x                   # 113e
        rotqbyi $vertex1_4,$t_index_3,4                 # 113o
        fcgt    $c_more_6,$low_x,$xc                    # 114e
        rotqbyi $vertex2_6,$t_index_3,8                 # 114o
        selb    $high_x,$high_x,$xc,$c_more_5           # 115e
        lqd     $limit_7,16($a_window_2)                # 115o
        selb    $high_y,$yb,$ya,$c_more                 # 116e
        shufb   $za_3,$upper_8,$lower_7,$m_upper        # 116o
        selb    $low_x,$low_x,$xc,$c_more_6             # 117e
        lqd     $limit,144($a_window_2)                 # 117o
        fcgt    $c_more_7,$yc,$high_y                   # 118e
        lqd     $limit_8,32($a_window_2)                # 118o
        selb    $low_y,$ya,$yb,$c_more                  # 119e
        lqd     $limit_9,192($a_window_2)               # 119o
        fcgt    $row_2,$limit_4,$high_x                 # 120e
        lqx     $vertex_4,$a_vertices,$t_index_3        # 120o
        fcgt    $c_more,$low_y,$yc                      # 121e
        lqx     $vertex3_8,$a_vertices,$vertex3_7       # 121o
        selb    $high_y,$high_y,$yc,$c_more_7           # 122e
        lqx     $vertex3_5,$a_vertices,$vertex3_4       # 122o
        fcgt    $limit_2,$low_x,$limit_2                # 123e
        lqx     $vertex1_2,$a_vertices,$vertex1_2       # 123o
        selb    $low_y,$low_y,$yc,$c_more               # 124e
        lqx     $vertex2_7,$a_vertices,$vertex2_6       # 124o
        fcgt    $limit_3,$low_x,$limit_3                # 125e
        lqd     $limit_10,160($a_window_2)              # 125o
        fcgt    $row_3,$limit_7,$high_x                 # 126e
        lqx     $vertex1_4,$a_vertices,$vertex1_4       # 126o
        or      $row_2,$row_2,$limit_2                  # 127e
        lqx     $vertex_5,$a_vertices,$t_index_4        # 127o
        fcgt    $limit_5,$limit_5,$high_y               # 128e
        lqx     $vertex2_4,$a_vertices,$vertex2_4       # 128o
        or      $row_4,$row_3,$limit_3                  # 129e
        lqd     $limit_2,48($a_window_2)                # 129o
        fcgt    $limit,$limit,$high_y                   # 130e
        lqd     $limit_7,112($a_window_2)               # 130o
        fcgt    $limit_6,$low_x,$limit_6                # 131e
        lqd     $limit_11,176($a_window_2)              # 131o
        fcgt    $row_5,$limit_8,$high_x                 # 132e
        lqd     $limit_12,208($a_window_2)              # 132o
        or      $row_6,$row_2,$limit_5                  # 133e
        lqd     $limit_4,224($a_window_2)               # 133o
        fcgt    $limit_9,$low_y,$limit_9                # 134e
        frest   $t_y_6,$za_3                            # 134o
        or      $row_7,$row_5,$limit_6                  # 135e
        lqd     $limit_13,240($a_window_2)              # 135o
        or      $row_6,$row_6,$limit_9                  # 136e
        shufb   $lower_8,$vertex2_4,$vertex3_8,$m_depth_3 # 136o
        or      $row_4,$row_4,$limit                    # 137e
        shufb   $upper_9,$vertex_4,$vertex1_4,$m_depth_3 # 137o
        fcgt    $limit_12,$low_y,$limit_12              # 138e
        shufb   $upper_10,$vertex_5,$vertex1_2,$m_depth_3 # 138o
        fi      $t_y_7,$za_3,$t_y_6                     # 139e
        shufb   $lower_5,$vertex2_7,$vertex3_5,$m_depth_3 # 139o
        fcgt    $row,$limit_2,$high_x                   # 140e
        lqd     $m_order_3,256($a_window_4)             # 140o
        fcgt    $limit_7,$low_x,$limit_7                # 141e
        shufb   $left_4,$left_4,$left_4,$m_splat        # 141o
        fcgt    $limit_14,$limit_10,$high_y             # 142e
        shufb   $zb,$upper_10,$lower_8,$m_upper         # 142o
        or      $row_4,$row_4,$limit_12                 # 143e
        shufb   $zc,$upper_9,$lower_5,$m_upper          # 143o
        andi    $row_8,$row_6,8                         # 144e
        shufb   $word_7,$index_2,$index_2,$m_splat      # 144o
        or      $row_6,$row_7,$limit_14                 # 145e
        lnop                                            # 145o pairing
        fcgt    $limit_13,$low_y,$limit_13              # 146e
        frest   $t_y_8,$zb                              # 146o
        fcgt    $limit_4,$low_y,$limit_4                # 147e
        frest   $t_y_9,$zc                              # 147o
        fcgt    $limit_9,$limit_11,$high_y              # 148e
        shufb   $upper_7,$vertex_4,$vertex1_4,$m_order_3 # 148o
        andi    $row_4,$row_4,4                         # 149e
        shufb   $upper_3,$vertex_3,$vertex1_6,$m_order_3 # 149o
        or      $outside,$outside_2,$row_8              # 150e
        shufb   $lower_9,$vertex2_2,$vertex3_6,$m_order_3 # 150o
        or      $row,$row,$limit_7                      # 151e
        shufb   $lower_10,$vertex2_4,$vertex3_8,$m_order_3 # 151o
        or      $row_9,$row_6,$limit_4                  # 152e
        shufb   $lower,$vertex2_7,$vertex3_5,$m_order_3 # 152o
        or      $row,$row,$limit_9                      # 153e
        shufb   $upper,$vertex_5,$vertex1_2,$m_order_3  # 153o
        or      $outside,$outside,$row_4                # 154e
        shufb   $ya,$upper_3,$lower_9,$m_lower          # 154o
        fnms    $t_e,$za_3,$t_y_7,$k_one                # 155e
        shufb   $rest,$upper_3,$lower_9,$m_upper        # 155o
        andi    $row_10,$row_9,2                        # 156e
        shufb   $xc,$upper_7,$lower,$m_upper            # 156o
        or      $row,$row,$limit_13                     # 157e
        shufb   $xb,$upper,$lower_10,$m_upper           # 157o
        or      $outside,$outside,$row_10               # 158e
        andi    $row,$row,1                             # 159e
        xor     $crosses_4,$za_3,$zb                    # 160e
        or      $outside,$outside,$row                  # 161e
        xor     $outside_5,$za_3,$zc                    # 162e
        andc    $outside,$outside,$crosses_3            # 163e
        fi      $t_y_10,$zc,$t_y_9                      # 164e
        fi      $t_y_11,$zb,$t_y_8                      # 165e
        or      $crosses_4,$crosses_4,$outside_5        # 166e
        fma     $za,$t_e,$t_y_7,$t_y_7                  # 167e
        rotmai  $crosses_3,$crosses_4,-31               # 168e
        cgt     $left_2,$left_4,$k_lanes                # 169e
        andc    $outside,$left_3,$outside               # 170e now inside
        andi    $left_3,$left_2,15                      # 171e
        cgti    $steps,$outside,0                       # 172e
        a       $word_6,$word_7,$k_lanes                # 173e
        or      $word_8,$word,$outside                  # 174e
        lnop                                            # 174o pairing
next_chunk:
            fnms    $t_e,$zb,$t_y_11,$k_one             # 0e
            shufb   $record,$word_8,$candidate_2,$m_record+2 # 0o
            fnms    $t_e_4,$zc,$t_y_10,$k_one           # 1e
            shufb   $record_3,$word_8,$candidate_2,$m_record+3 # 1o
            cntb    $word,$outside                      # 2e
            shufb   $record_4,$word_8,$candidate_2,$m_record+1 # 2o
            fm      $rest,$rest,$za                     # 3e
            shufb   $record_5,$word_8,$candidate_2,$m_record # 3o
            andi    $steps,$steps,16                    # 4e
            shlqbyi $candidate_2,$candidate,0           # 4o copy
        ai      $at_2,$at,16                            # 5e
        lqd     $candidate,0($a_candidate)              # 5o
            fma     $zb,$t_e,$t_y_11,$t_y_11            # 6e
            lnop                                        # 6o pairing
            fma     $zc,$t_e_4,$t_y_10,$t_y_10          # 7e
            shufb   $yc,$upper_7,$lower,$m_lower        # 7o
            a       $rows,$rows,$word                   # 8e
            shufb   $yb,$upper,$lower_10,$m_lower       # 8o
            fm      $ya,$ya,$za                         # 9e
            shli    $word,$word_6,8                     # 10e
        andi    $index,$candidate,511                   # 11e 4 times it
        rotqbyi $a_window,$candidate,4                  # 11o
        rotmi   $length,$candidate,-14                  # 12e 4 times it
        lnop                                            # 12o pairing
            fm      $xb,$xb,$zb                         # 13e
            rotqbyi $record_2,$steps,4                  # 13o
            fm      $xc,$xc,$zc                         # 14e
            rotqbyi $record_6,$steps,0                  # 14o
            fm      $yc,$yc,$zc                         # 15e
            fm      $yb,$yb,$zb                         # 16e
        cgt     $c_more,$length,$at_2                   # 17e
            rotqbyi $record_7,$steps,8                  # 17o
        sf      $left_2,$at,$length                     # 18e
            stqx    $record_5,$a_list,$found            # 18o
            a       $found_2,$found,$record_6           # 19e
            lnop                                        # 19o pairing
        andc    $c_more_2,$k_step,$c_more               # 20e
        shufb   $left_2,$left_2,$left_2,$m_splat        # 20o
            fcgt    $c_more_8,$rest,$xb                 # 21e
            rotqbyi $record_8,$steps,12                 # 21o
        a       $a_candidate,$a_candidate,$c_more_2     # 22e
            stqx    $record_4,$a_list,$found_2          # 22o
            selb    $low_x,$rest,$xb,$c_more_8          # 23e
            lnop                                        # 23o pairing
            selb    $high_x,$xb,$rest,$c_more_8         # 24e
            lqd     $limit,48($a_window_4)              # 24o
            fcgt    $c_more_9,$low_x,$xc                # 25e
            lqd     $limit_5,96($a_window_4)            # 25o
            fcgt    $c_more_8,$xc,$high_x               # 26e
            lqd     $limit_6,80($a_window_4)            # 26o
        andi    $a_window,$a_window,7                   # 27e
            lqd     $limit_2,64($a_window_4)            # 27o
            selb    $high_x,$high_x,$xc,$c_more_8       # 28e
            lqd     $limit_15,16($a_window_4)           # 28o
            selb    $low_x,$low_x,$xc,$c_more_9         # 29e
            lqd     $limit_16,0($a_window_4)            # 29o
            fcgt    $row,$limit,$high_x                 # 30e
            fcgt    $limit,$low_x,$limit_5              # 31e
            fcgt    $limit_5,$low_x,$limit_6            # 32e
            lqd     $limit_6,112($a_window_4)           # 32o
            fcgt    $limit_2,$low_x,$limit_2            # 33e
            lqd     $limit_17,32($a_window_4)           # 33o
            fcgt    $row_11,$limit_15,$high_x           # 34e
            lqd     $limit_18,192($a_window_4)          # 34o
            fcgt    $row_9,$limit_16,$high_x            # 35e
            lqd     $limit_19,160($a_window_4)          # 35o
        a       $index,$index,$at                       # 36e
            lqd     $limit_20,224($a_window_4)          # 36o
        mpyi    $a_window,$a_window,288                 # 37e
            lqd     $limit_21,128($a_window_4)          # 37o
        andi    $shift_2,$index,15                      # 38e
        lqx     $more_faces_2,$a_more_faces,$index      # 38o
            or      $row_6,$row_11,$limit_5             # 39e
        lqx     $faces_2,$a_faces,$index                # 39o
        ai      $shift_3,$shift_2,-16                   # 40e
        shufb   $word_6,$index,$index,$m_splat          # 40o
            or      $row_9,$row_9,$limit_2              # 41e
            lqd     $limit_2,176($a_window_4)           # 41o
            fcgt    $row_10,$limit_17,$high_x           # 42e
            lqd     $limit_8,208($a_window_4)           # 42o
        and     $at,$at_2,$c_more                       # 43e
            lqd     $limit_22,240($a_window_4)          # 43o
        a       $word_6,$word_6,$k_lanes                # 44e
        rotqmby $more_faces_2,$more_faces_2,$shift_3    # 44o
            or      $row_10,$row_10,$limit              # 45e
        shlqby  $faces_2,$faces_2,$shift_2              # 45o
            a       $found_3,$found_2,$record_2         # 46e
            lqd     $limit,144($a_window_4)             # 46o
        a       $a_window_4,$a_window,$a_windows        # 47e
        lnop                                            # 47o pairing
            a       $found_2,$found_3,$record_7         # 48e
            stqx    $record,$a_list,$found_3            # 48o
            fcgt    $limit_23,$low_x,$limit_6           # 49e
            lnop                                        # 49o pairing
        or      $faces,$faces_2,$more_faces_2           # 50e
            stqx    $record_3,$a_list,$found_2          # 50o
            fcgt    $c_more,$ya,$yb                     # 51e
        rotmi   $t_index,$faces,-20                     # 52e
            selb    $low_y,$ya,$yb,$c_more              # 53e
        hbrr    next_chunk_back,next_chunk              # 53o hint
            selb    $high_y,$yb,$ya,$c_more             # 54e
        lqd     $m_depth_4,272($a_window_4)             # 54o
        rotmi   $t_index_2,$faces,-12                   # 55e
        lqd     $m_order_2,256($a_window_4)             # 55o
            fcgt    $c_more,$yc,$high_y                 # 56e
        rotqbyi $vertex1_6,$t_index,4                   # 56o
        rotmi   $t_index_3,$faces,-4                    # 57e
        rotqbyi $vertex2_2,$t_index,8                   # 57o
            selb    $high_y,$high_y,$yc,$c_more         # 58e
        rotqbyi $vertex3_2,$t_index,12                  # 58o
        and     $t_index_2,$t_index_2,$k_places         # 59e
        lqx     $vertex_2,$a_vertices,$t_index          # 59o
            fcgt    $limit,$limit,$high_y               # 60e
        lqx     $vertex1_6,$a_vertices,$vertex1_6       # 60o
        and     $t_index_3,$t_index_3,$k_places         # 61e
        rotqbyi $vertex3_3,$t_index_2,12                # 61o
            fcgt    $c_more,$low_y,$yc                  # 62e
        lqx     $vertex2_2,$a_vertices,$vertex2_2       # 62o
            fcgt    $limit_21,$limit_21,$high_y         # 63e
        rotqbyi $vertex1_4,$t_index_3,4                 # 63o
            selb    $low_y,$low_y,$yc,$c_more           # 64e
        lqx     $vertex3_2,$a_vertices,$vertex3_2       # 64o
            or      $row_9,$row_9,$limit_21             # 65e
        rotqbyi $vertex1_2,$t_index_2,4                 # 65o
            fcgt    $limit_22,$low_y,$limit_22          # 66e
        lqx     $vertex_4,$a_vertices,$t_index_3        # 66o
            fcgt    $limit_20,$low_y,$limit_20          # 67e
        lqx     $vertex3_3,$a_vertices,$vertex3_3       # 67o
            fcgt    $limit_2,$limit_2,$high_y           # 68e
        rotqbyi $vertex3_4,$t_index_3,12                # 68o
            fcgt    $limit_8,$low_y,$limit_8            # 69e
        lqx     $vertex1_2,$a_vertices,$vertex1_2       # 69o
            fcgt    $limit_18,$low_y,$limit_18          # 70e
        shufb   $lower_2,$vertex2_2,$vertex3_2,$m_depth_4 # 70o
            fcgt    $limit_19,$limit_19,$high_y         # 71e
        rotqbyi $vertex2_3,$t_index_2,8                 # 71o
            or      $row_9,$row_9,$limit_18             # 72e
        shufb   $upper_11,$vertex_2,$vertex1_6,$m_order_2 # 72o
            or      $row_10,$row_10,$limit_19           # 73e
        shufb   $upper,$vertex_2,$vertex1_6,$m_depth_4  # 73o
            or      $row_6,$row_6,$limit                # 74e
        lqx     $vertex1_7,$a_vertices,$vertex1_4       # 74o
            or      $row_10,$row_10,$limit_20           # 75e
        lqx     $vertex_3,$a_vertices,$t_index_2        # 75o
            or      $row_6,$row_6,$limit_8              # 76e
        rotqbyi $vertex2_8,$t_index_3,8                 # 76o
            andi    $row_10,$row_10,2                   # 77e
        lqx     $vertex2_4,$a_vertices,$vertex2_3       # 77o
            andi    $row_6,$row_6,4                     # 78e
        shufb   $za,$upper,$lower_2,$m_upper            # 78o
            andi    $row_9,$row_9,8                     # 79e
        lqx     $vertex3_5,$a_vertices,$vertex3_4       # 79o
        cgt     $left_2,$left_2,$k_lanes                # 80e
        lqx     $vertex2_8,$a_vertices,$vertex2_8       # 80o
            or      $outside,$outside_3,$row_9          # 81e
        shufb   $upper,$vertex_4,$vertex1_7,$m_depth_4  # 81o
        il      $outside_3,0                            # 82e
        frest   $t_y_12,$za                             # 82o
            or      $outside,$outside,$row_6            # 83e
        shufb   $upper_12,$vertex_3,$vertex1_2,$m_depth_4 # 83o
            or      $row,$row,$limit_23                 # 84e
        shufb   $lower_9,$vertex2_4,$vertex3_3,$m_depth_4 # 84o
            or      $outside,$outside,$row_10           # 85e
        shufb   $lower,$vertex2_2,$vertex3_2,$m_order_2 # 85o
            or      $row,$row,$limit_2                  # 86e
        shufb   $lower_11,$vertex2_8,$vertex3_5,$m_depth_4 # 86o
        fi      $t_y_12,$za,$t_y_12                     # 87e
        shufb   $upper_7,$vertex_4,$vertex1_7,$m_order_2 # 87o
            or      $row,$row,$limit_22                 # 88e
        shufb   $zb,$upper_12,$lower_9,$m_upper         # 88o
            a       $found,$found_2,$record_8           # 89e
        shufb   $rest,$upper_11,$lower,$m_upper         # 89o
            andi    $row,$row,1                         # 90e
        shufb   $zc,$upper,$lower_11,$m_upper           # 90o
        ai      $chunks,$chunks,-1                      # 91e
        shufb   $upper,$vertex_3,$vertex1_2,$m_order_2  # 91o
        xor     $crosses_4,$za,$zb                      # 92e
        frest   $t_y_13,$zb                             # 92o
            or      $outside,$outside,$row              # 93e
        shufb   $lower_10,$vertex2_4,$vertex3_3,$m_order_2 # 93o
        fnms    $t_e,$za,$t_y_12,$k_one                 # 94e
        frest   $t_y_14,$zc                             # 94o
            andc    $outside,$outside,$crosses_3        # 95e
        shufb   $ya,$upper_11,$lower,$m_lower           # 95o
        xor     $outside_6,$za,$zc                      # 96e
        shufb   $lower,$vertex2_8,$vertex3_5,$m_order_2 # 96o
        fi      $t_y_11,$zb,$t_y_13                     # 97e
        shufb   $xb,$upper,$lower_10,$m_upper           # 97o
        or      $crosses_4,$crosses_4,$outside_6        # 98e
        fi      $t_y_10,$zc,$t_y_14                     # 99e
        rotmai  $crosses_3,$crosses_4,-31               # 100e
        fma     $za,$t_e,$t_y_12,$t_y_12                # 101e
            andc    $outside,$left_3,$outside           # 102e now inside
        andi    $left_3,$left_2,15                      # 103e
            or      $word_8,$word,$outside              # 104e
        shufb   $xc,$upper_7,$lower,$m_upper            # 104o
            cgti    $steps,$outside,0                   # 105e
next_chunk_back:
        brnz    $chunks,next_chunk                      # 105o
next_chunk_drain:
        fnms    $t_e,$zb,$t_y_11,$k_one                 # 0e
        shufb   $yb,$upper,$lower_10,$m_lower           # 0o
        fnms    $t_e_4,$zc,$t_y_10,$k_one               # 1e
        shufb   $record_3,$word_8,$candidate_2,$m_record # 1o
        andi    $steps,$steps,16                        # 2e
        shufb   $yc,$upper_7,$lower,$m_lower            # 2o
        fm      $rest,$rest,$za                         # 3e
        shufb   $record_4,$word_8,$candidate_2,$m_record+1 # 3o
        fm      $ya,$ya,$za                             # 4e
        rotqbyi $record_9,$steps,0                      # 4o
        cntb    $word,$outside                          # 5e
        stqx    $record_3,$a_list,$found                # 5o
        fma     $zb,$t_e,$t_y_11,$t_y_11                # 6e
        rotqbyi $record_3,$steps,4                      # 6o
        fma     $zc,$t_e_4,$t_y_10,$t_y_10              # 7e
        rotqbyi $record_7,$steps,8                      # 7o
        a       $found_3,$found,$record_9               # 8e
        rotqbyi $record_8,$steps,12                     # 8o
        a       $rows,$rows,$word                       # 9e
        hbr     filter_triangles_r16_return,$lr         # 9o hint
        a       $found_4,$found_3,$record_3             # 10e
        stqx    $record_4,$a_list,$found_3              # 10o
        shli    $word,$word_6,8                         # 11e
        lqd     $limit_2,64($a_window_4)                # 11o
        fm      $xb,$xb,$zb                             # 12e
        lqd     $limit_16,0($a_window_4)                # 12o
        fm      $yb,$yb,$zb                             # 13e
        lqd     $limit_6,80($a_window_4)                # 13o
        fm      $xc,$xc,$zc                             # 14e
        lqd     $limit_15,16($a_window_4)               # 14o
        fm      $yc,$yc,$zc                             # 15e
        lqd     $limit_21,128($a_window_4)              # 15o
        a       $found_3,$found_4,$record_7             # 16e
        lqd     $limit_5,96($a_window_4)                # 16o
        nop     $127                                    # 17e pairing
        lqd     $limit_17,32($a_window_4)               # 17o
        fcgt    $c_more_10,$rest,$xb                    # 18e
        lqd     $limit_18,192($a_window_4)              # 18o
        fcgt    $c_more,$ya,$yb                         # 19e
        lqd     $limit,144($a_window_4)                 # 19o
        selb    $low_x,$rest,$xb,$c_more_10             # 20e
        lqd     $limit_22,48($a_window_4)               # 20o
        selb    $high_x,$xb,$rest,$c_more_10            # 21e
        lqd     $limit_24,112($a_window_4)              # 21o
        fcgt    $c_more_11,$low_x,$xc                   # 22e
        lqd     $limit_19,160($a_window_4)              # 22o
        fcgt    $c_more_12,$xc,$high_x                  # 23e
        lqd     $limit_8,208($a_window_4)               # 23o
        selb    $high_y,$yb,$ya,$c_more                 # 24e
        lqd     $limit_20,224($a_window_4)              # 24o
        selb    $high_x,$high_x,$xc,$c_more_12          # 25e
        lqd     $limit_25,176($a_window_4)              # 25o
        selb    $low_x,$low_x,$xc,$c_more_11            # 26e
        lqd     $limit_26,240($a_window_4)              # 26o
        selb    $low_y,$ya,$yb,$c_more                  # 27e
        shlqbyi $candidate_3,$candidate,0               # 27o copy
        fcgt    $c_more,$yc,$high_y                     # 28e
        shufb   $record,$word_8,$candidate_2,$m_record+2 # 28o
        fcgt    $limit_2,$low_x,$limit_2                # 29e
        shufb   $record_5,$word_8,$candidate_2,$m_record+3 # 29o
        fcgt    $row_9,$limit_16,$high_x                # 30e
        fsmbi   $row,0xf00                              # 30o
        selb    $high_y,$high_y,$yc,$c_more             # 31e
        rotqbyi $triangles,$triangles,8                 # 31o
        fcgt    $c_more,$low_y,$yc                      # 32e
        stqx    $record,$a_list,$found_4                # 32o
        fcgt    $limit_13,$low_x,$limit_6               # 33e
        stqx    $record_5,$a_list,$found_3              # 33o
        fcgt    $row_11,$limit_15,$high_x               # 34e
        fsmbi   $row_4,240                              # 34o
        or      $row_9,$row_9,$limit_2                  # 35e
        fcgt    $limit_21,$limit_21,$high_y             # 36e
        selb    $low_y,$low_y,$yc,$c_more               # 37e
        fcgt    $limit_27,$low_x,$limit_5               # 38e
        or      $row_6,$row_11,$limit_13                # 39e
        fcgt    $row_10,$limit_17,$high_x               # 40e
        fcgt    $limit,$limit,$high_y                   # 41e
        or      $row_9,$row_9,$limit_21                 # 42e
        fcgt    $limit_18,$low_y,$limit_18              # 43e
        fcgt    $row_12,$limit_22,$high_x               # 44e
        or      $row_10,$row_10,$limit_27               # 45e
        fcgt    $limit_24,$low_x,$limit_24              # 46e
        fcgt    $limit_8,$low_y,$limit_8                # 47e
        fcgt    $limit_19,$limit_19,$high_y             # 48e
        or      $row_9,$row_9,$limit_18                 # 49e
        or      $row_6,$row_6,$limit                    # 50e
        fcgt    $limit_20,$low_y,$limit_20              # 51e
        fcgt    $limit_2,$limit_25,$high_y              # 52e
        or      $row_10,$row_10,$limit_19               # 53e
        or      $row_6,$row_6,$limit_8                  # 54e
        andi    $row_9,$row_9,8                         # 55e
        or      $row_12,$row_12,$limit_24               # 56e
        fcgt    $limit_22,$low_y,$limit_26              # 57e
        or      $row_10,$row_10,$limit_20               # 58e
        andi    $row_6,$row_6,4                         # 59e
        or      $outside,$outside_3,$row_9              # 60e
        or      $row_12,$row_12,$limit_2                # 61e
        andi    $row_10,$row_10,2                       # 62e
        or      $outside,$outside,$row_6                # 63e
        or      $row_12,$row_12,$limit_22               # 64e
        or      $outside,$outside,$row_10               # 65e
        andi    $row_12,$row_12,1                       # 66e
        a       $found,$found_3,$record_8               # 67e
        or      $outside,$outside,$row_12               # 68e
        andc    $outside,$outside,$crosses_3            # 70e
        andc    $outside,$left_3,$outside               # 72e now inside
        cgti    $steps,$outside,0                       # 74e
        cntb    $word_2,$outside                        # 75e
        andi    $steps,$steps,16                        # 76e
        or      $word_4,$word,$outside                  # 77e
        nop     $127                                    # 78e pairing
        rotqbyi $record_6,$steps,0                      # 78o
        a       $rows,$rows,$word_2                     # 79e
        rotqbyi $record_2,$steps,4                      # 79o
        rotqbyi $record_7,$steps,8                      # 80o
        rotqbyi $row_9,$rows,8                          # 81o
        a       $found_5,$found,$record_6               # 82e
        rotqbyi $record_8,$steps,12                     # 82o
        nop     $127                                    # 83e pairing
        shufb   $record_10,$word_4,$candidate_3,$m_record # 83o
        a       $found_3,$found_5,$record_2             # 84e
        shufb   $record_11,$word_4,$candidate_3,$m_record+1 # 84o
        a       $rows,$rows,$row_9                      # 85e
        shufb   $record,$word_4,$candidate_3,$m_record+2 # 85o
        a       $found_6,$found_3,$record_7             # 86e
        shufb   $record_3,$word_4,$candidate_3,$m_record+3 # 86o
        nop     $127                                    # 87e pairing
        rotqbyi $row_13,$rows,4                         # 87o
        a       $found_7,$found_6,$record_8             # 88e
        stqx    $record_10,$a_list,$found               # 88o
        nop     $127                                    # 89e pairing
        stqx    $record_11,$a_list,$found_5             # 89o
        a       $a_first_2,$a_list,$found_7             # 90e
        stqx    $record,$a_list,$found_3                # 90o
        a       $rows,$rows,$row_13                     # 91e in all lanes
        stqx    $record_3,$a_list,$found_6              # 91o
        selb    $a_first,$a_first_2,$rows,$row          # 93e
        lnop                                            # 93o pairing
        selb    $a_first,$a_first,$triangles,$row_4     # 95e
filter_triangles_r16_return:
        bi      $lr                                     # 95o
next_run_short:
        ai      $count,$count,-1                        # 0e
        lqd     $word,0($record)                        # 0o
        ai      $record,$record,16                      # 1e
        rotmi   $word,$word,-16                         # 6e
        ai      $word_2,$word,3                         # 10e
        a       $triangles,$triangles,$word             # 11e
        rotmi   $word,$word_2,-2                        # 12e
        lnop                                            # 12o pairing
        a       $chunks,$chunks,$word                   # 16e
        brnz    $count,next_run_short                   # 16o
        nop     $127                                    # 17e pairing
        br      filter_triangles_r16_block              # 17o
next_chunk_short:
        il      $outside,0                              # 0e
        lqd     $candidate,0($a_candidate)              # 0o
        ai      $at_4,$at,16                            # 1e
        ai      $chunks,$chunks,-1                      # 2e
        andi    $index,$candidate,511                   # 6e 4 times it
        rotqbyi $a_window,$candidate,4                  # 6o
        rotmi   $length,$candidate,-14                  # 7e 4 times it
        a       $index,$index,$at                       # 8e
        andi    $shift,$index,15                        # 10e
        lqx     $faces,$a_faces,$index                  # 10o
        andi    $a_window,$a_window,7                   # 11e
        lqx     $more_faces,$a_more_faces,$index        # 11o
        ai      $shift_5,$shift,-16                     # 12e
        shufb   $word,$index,$index,$m_splat            # 12o
        mpyi    $a_window,$a_window,288                 # 13e
        sf      $left,$at,$length                       # 14e
        cgt     $c_more,$length,$at_4                   # 15e
        lnop                                            # 15o pairing
        a       $word,$word,$k_lanes                    # 16e
        shlqby  $faces,$faces,$shift                    # 16o
        andc    $c_more_9,$k_step,$c_more               # 17e
        rotqmby $more_faces,$more_faces,$shift_5        # 17o
        shli    $word,$word,8                           # 18e
        shufb   $left,$left,$left,$m_splat              # 18o
        and     $at,$at_4,$c_more                       # 19e
        a       $a_window,$a_window,$a_windows          # 20e
        or      $faces,$faces,$more_faces               # 21e
        lnop                                            # 21o pairing
        cgt     $left,$left,$k_lanes                    # 22e
        lqd     $m_depth,272($a_window)                 # 22o
        rotmi   $t_index,$faces,-12                     # 23e
        lqd     $m_order,256($a_window)                 # 23o
        rotmi   $t_index_5,$faces,-20                   # 24e
        lqd     $limit,64($a_window)                    # 24o
        rotmi   $t_index_6,$faces,-4                    # 25e
        lqd     $limit_3,0($a_window)                   # 25o
        andi    $left,$left,15                          # 26e
        lqd     $limit_27,80($a_window)                 # 26o
        and     $t_index,$t_index,$k_places             # 27e
        lqd     $limit_22,128($a_window)                # 27o
        a       $a_candidate,$a_candidate,$c_more_9     # 28e
        rotqbyi $vertex+2,$t_index_5,8                  # 28o
        and     $t_index_6,$t_index_6,$k_places         # 29e
        rotqbyi $vertex+1,$t_index,4                    # 29o
        rotqbyi $vertex1_8,$t_index_5,4                 # 30o
        rotqbyi $vertex+3,$t_index_5,12                 # 31o
        rotqbyi $vertex2_9,$t_index,8                   # 32o
        rotqbyi $vertex3_9,$t_index,12                  # 33o
        lqx     $vertex1_8,$a_vertices,$vertex1_8       # 34o
        lqx     $vertex+3,$a_vertices,$vertex+3         # 35o
        lqx     $vertex,$a_vertices,$t_index            # 36o
        lqx     $vertex2_9,$a_vertices,$vertex2_9       # 37o
        lqx     $vertex3_9,$a_vertices,$vertex3_9       # 38o
        rotqbyi $vertex1_5,$t_index_6,4                 # 39o
        rotqbyi $vertex3_10,$t_index_6,12               # 40o
        lqx     $vertex_6,$a_vertices,$t_index_5        # 41o
        lqx     $vertex+2,$a_vertices,$vertex+2         # 42o
        lqx     $vertex+1,$a_vertices,$vertex+1         # 43o
        rotqbyi $vertex2_10,$t_index_6,8                # 44o
        lqx     $vertex1_5,$a_vertices,$vertex1_5       # 45o
        lqx     $vertex_7,$a_vertices,$t_index_6        # 46o
        lqx     $vertex3_10,$a_vertices,$vertex3_10     # 47o
        lqx     $vertex2_10,$a_vertices,$vertex2_10     # 48o
        shufb   $upper,$vertex,$vertex+1,$m_depth       # 49o
        shufb   $lower,$vertex2_9,$vertex3_9,$m_depth   # 50o
        shufb   $upper_7,$vertex_6,$vertex1_8,$m_depth  # 51o
        shufb   $lower_12,$vertex+2,$vertex+3,$m_depth  # 52o
        shufb   $upper_13,$vertex_7,$vertex1_5,$m_depth # 53o
        shufb   $zb,$upper,$lower,$m_upper              # 54o
        shufb   $lower,$vertex2_10,$vertex3_10,$m_depth # 55o
        shufb   $za,$upper_7,$lower_12,$m_upper         # 56o
        shufb   $upper,$vertex_6,$vertex1_8,$m_order    # 57o
        frest   $t_y,$zb                                # 58o
        shufb   $zc,$upper_13,$lower,$m_upper           # 59o
        xor     $crosses,$za,$zb                        # 60e
        frest   $t_y_15,$za                             # 60o
        nop     $127                                    # 61e pairing
        shufb   $lower,$vertex+2,$vertex+3,$m_order     # 61o
        fi      $t_y,$zb,$t_y                           # 62e
        shufb   $upper_6,$vertex,$vertex+1,$m_order     # 62o
        xor     $outside_7,$za,$zc                      # 63e
        frest   $t_y_16,$zc                             # 63o
        fi      $t_y_15,$za,$t_y_15                     # 64e
        shufb   $lower_13,$vertex2_9,$vertex3_9,$m_order # 64o
        or      $crosses,$crosses,$outside_7            # 65e
        shufb   $rest,$upper,$lower,$m_upper            # 65o
        nop     $127                                    # 66e pairing
        shufb   $lower_5,$vertex2_10,$vertex3_10,$m_order # 66o
        fi      $t_y_17,$zc,$t_y_16                     # 67e
        shufb   $ya,$upper,$lower,$m_lower              # 67o
        rotmai  $crosses,$crosses,-31                   # 68e
        shufb   $xb,$upper_6,$lower_13,$m_upper         # 68o
        fnms    $t_e,$zb,$t_y,$k_one                    # 69e
        shufb   $yb,$upper_6,$lower_13,$m_lower         # 69o
        nop     $127                                    # 70e pairing
        shufb   $upper,$vertex_7,$vertex1_5,$m_order    # 70o
        fnms    $t_e_5,$za,$t_y_15,$k_one               # 71e
        lqd     $limit_16,16($a_window)                 # 71o
        lqd     $limit_28,144($a_window)                # 72o
        lqd     $limit_29,192($a_window)                # 73o
        fnms    $t_e_6,$zc,$t_y_17,$k_one               # 74e
        shufb   $xc,$upper,$lower_5,$m_upper            # 74o
        fma     $zb,$t_e,$t_y,$t_y                      # 75e
        shufb   $yc,$upper,$lower_5,$m_lower            # 75o
        nop     $127                                    # 76e pairing
        lqd     $limit_30,32($a_window)                 # 76o
        fma     $za,$t_e_5,$t_y_15,$t_y_15              # 77e
        lqd     $limit_23,96($a_window)                 # 77o
        lqd     $limit_13,112($a_window)                # 78o
        lqd     $limit_6,160($a_window)                 # 79o
        fma     $zc,$t_e_6,$t_y_17,$t_y_17              # 80e
        lqd     $limit_15,208($a_window)                # 80o
        fm      $xb,$xb,$zb                             # 81e
        lqd     $limit_4,48($a_window)                  # 81o
        fm      $yb,$yb,$zb                             # 82e
        lqd     $limit_2,224($a_window)                 # 82o
        fm      $rest,$rest,$za                         # 83e
        lqd     $limit_17,176($a_window)                # 83o
        fm      $ya,$ya,$za                             # 84e
        lqd     $limit_31,240($a_window)                # 84o
        fm      $xc,$xc,$zc                             # 86e
        fm      $yc,$yc,$zc                             # 87e
        fcgt    $c_more,$rest,$xb                       # 89e
        fcgt    $c_more_4,$ya,$yb                       # 90e
        selb    $high_x,$xb,$rest,$c_more               # 91e
        selb    $low_x,$rest,$xb,$c_more                # 92e
        fcgt    $c_more,$xc,$high_x                     # 93e
        fcgt    $c_more_13,$low_x,$xc                   # 94e
        selb    $high_y,$yb,$ya,$c_more_4               # 95e
        selb    $low_x,$low_x,$xc,$c_more_13            # 96e
        selb    $low_y,$ya,$yb,$c_more_4                # 97e
        selb    $high_x,$high_x,$xc,$c_more             # 98e
        fcgt    $c_more,$yc,$high_y                     # 99e
        fcgt    $row,$limit_3,$high_x                   # 100e
        selb    $high_y,$high_y,$yc,$c_more             # 101e
        fcgt    $c_more,$low_y,$yc                      # 102e
        fcgt    $limit,$low_x,$limit                    # 103e
        fcgt    $limit_3,$limit_22,$high_y              # 104e
        fcgt    $limit_27,$low_x,$limit_27              # 105e
        selb    $low_y,$low_y,$yc,$c_more               # 106e
        or      $row,$row,$limit                        # 107e
        fcgt    $row_9,$limit_16,$high_x                # 108e
        fcgt    $limit,$limit_28,$high_y                # 109e
        or      $row_9,$row_9,$limit_27                 # 110e
        fcgt    $limit_23,$low_x,$limit_23              # 111e
        or      $row,$row,$limit_3                      # 112e
        fcgt    $limit_3,$low_y,$limit_29               # 113e
        or      $row_9,$row_9,$limit                    # 114e
        fcgt    $row_14,$limit_30,$high_x               # 115e
        fcgt    $limit,$low_x,$limit_13                 # 116e
        or      $row,$row,$limit_3                      # 117e
        fcgt    $limit_13,$limit_6,$high_y              # 118e
        fcgt    $row_4,$limit_4,$high_x                 # 119e
        fcgt    $limit_22,$low_y,$limit_15              # 120e
        or      $row_15,$row_14,$limit_23               # 121e
        or      $row_4,$row_4,$limit                    # 122e
        fcgt    $limit,$limit_17,$high_y                # 123e
        or      $row_15,$row_15,$limit_13               # 124e
        fcgt    $limit_13,$low_y,$limit_2               # 125e
        andi    $row,$row,8                             # 126e
        or      $row_9,$row_9,$limit_22                 # 127e
        lnop                                            # 127o pairing
        or      $outside,$outside,$row                  # 128e
        hbrr    next_chunk_short_back,next_chunk_short  # 128o hint
        andi    $row,$row_9,4                           # 129e
        or      $row_15,$row_15,$limit_13               # 130e
        or      $row_12,$row_4,$limit                   # 131e
        andi    $row_15,$row_15,2                       # 132e
        fcgt    $limit,$low_y,$limit_31                 # 133e
        or      $outside,$outside,$row                  # 134e
        or      $row,$row_12,$limit                     # 135e
        or      $outside,$outside,$row_15               # 136e
        andi    $row,$row,1                             # 137e
        or      $outside,$outside,$row                  # 139e
        andc    $outside,$outside,$crosses              # 141e
        andc    $outside,$left,$outside                 # 143e now inside
        cgti    $steps,$outside,0                       # 145e
        or      $word,$word,$outside                    # 146e
        andi    $steps,$steps,16                        # 147e
        lnop                                            # 147o pairing
        cntb    $word_2,$outside                        # 148e
        shufb   $record,$word,$candidate,$m_record      # 148o
        rotqbyi $record_3,$steps,0                      # 149o
        rotqbyi $record_4,$steps,4                      # 150o
        nop     $127                                    # 151e pairing
        shufb   $record_5,$word,$candidate,$m_record+1  # 151o
        a       $rows,$rows,$word_2                     # 152e
        rotqbyi $record_2,$steps,8                      # 152o
        a       $found_4,$found,$record_3               # 153e
        shufb   $record_10,$word,$candidate,$m_record+2 # 153o
        nop     $127                                    # 154e pairing
        stqx    $record,$a_list,$found                  # 154o
        a       $found,$found_4,$record_4               # 155e
        shufb   $record,$word,$candidate,$m_record+3    # 155o
        nop     $127                                    # 156e pairing
        rotqbyi $record_4,$steps,12                     # 156o
        a       $found_3,$found,$record_2               # 157e
        stqx    $record_5,$a_list,$found_4              # 157o
        stqx    $record_10,$a_list,$found               # 158o
        stqx    $record,$a_list,$found_3                # 159o
        a       $found,$found_3,$record_4               # 160e
next_chunk_short_back:
        brnz    $chunks,next_chunk_short                # 160o
        a       $a_first,$a_list,$found                 # 162e
        hbr     filter_triangles_r16_return_2,$lr       # 162o hint
        rotqbyi $row,$rows,8                            # 163o
        fsmbi   $row_15,0xf00                           # 164o
        rotqbyi $triangles,$triangles,8                 # 165o
        fsmbi   $row_9,240                              # 166o
        a       $rows,$rows,$row                        # 167e
        rotqbyi $row,$rows,4                            # 169o
        a       $rows,$rows,$row                        # 173e in all lanes
        selb    $a_first,$a_first,$rows,$row_15         # 175e
        selb    $a_first,$a_first,$triangles,$row_9     # 177e
filter_triangles_r16_return_2:
        bi      $lr                                     # 177o
endfunction filter_triangles_r16
