# filter_triangles_r16   of runs of a mesh's triangles, the rows of packets that may hit each one
#   C       vec_uint4 filter_triangles_r16(const struct mesh_candidate *, int count,
#                                          const struct mesh_header *, struct mesh_rows *,
#                                          const struct mesh_window *);
#   In      $3 candidates of runs of triangles, $4 count (0 is none), $5 the runs' block, in local
#           store and relative to the eye, $6 where the list goes, $7 the packets' windows, that of
#           packet 0 first; the last three bits of a candidate's packet are its number; pointers
#           16-aligned
#   Out     $3 end of the list, how many rows are in it, how many triangles were tested with a
#           packet, and anything. The list has each triangle and packet with a row that may hit it,
#           run by run; one more record may be written
#   Uses    $3-$7, $10-$79   Saves  -   Stack  0   Calls  -
#   Domain  rays from the eye; coordinates below 2^60; runs of at least one triangle
#   Error   0: no row is left out that has a ray through the triangle
#   Twin    lab/twins/src/mesh_rows.rs
#
# Four triangles of a run are in the four lanes. Their vertices are projected on the plane that the
# packet's window lies in, by a division. A row may hit a triangle if the box around its vertices
# there meets the row's window. A triangle with vertices on both sides of the eye may be anywhere.
# One behind the eye may pass, since it can't be hit.

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

# The minimum and the maximum of three.
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
        ori     $a_candidate,$a_first,0
        il      $chunks,0
        il      $triangles,0
        fsmbi   $record,0xf000
        and     $3,$a_list,$record
        biz     $count,$lr
        ori     $record,$a_candidate,0
next_run:
        lqd     $word,0($record)
        rotmi   $word,$word,-16
        a       $triangles,$triangles,$word
        ai      $word,$word,3
        rotmi   $word,$word,-2
        a       $chunks,$chunks,$word
        ai      $record,$record,MESH_CANDIDATE_SIZE
        ai      $count,$count,-1
        brnz    $count,next_run

        ilhu    $k_one,0x3f80
        il      $k_step,MESH_CANDIDATE_SIZE
        il      $k_places,0xff0
        lqa     $k_lanes,four_times
        lqa     $m_upper,upper_halves
        lqa     $m_lower,lower_halves
        splat_mask $m_splat
    .irp triangle, 0,1,2,3
        lqa     $m_record+\triangle,record_words+16*\triangle
    .endr
        lqd     $rest,MESH_HEADER_nodes&~15($a_block)
        mpyi    $a_vertices,$rest,BOXES_SIZE
        a       $a_vertices,$a_vertices,$a_block
        ai      $a_vertices,$a_vertices,MESH_HEADER_SIZE
        rotqbyi $a_faces,$rest,MESH_HEADER_vertices&15
        shli    $a_faces,$a_faces,4
        a       $a_faces,$a_faces,$a_vertices
        ai      $a_more_faces,$a_faces,16
        il      $at,0
        il      $rows,0
        il      $found,0
next_chunk:
        lqd     $candidate,0($a_candidate)
        rotqbyi $a_window,$candidate,MESH_CANDIDATE_packet
        andi    $a_window,$a_window,SMALL_BATCH-1
        mpyi    $a_window,$a_window,MESH_WINDOW_SIZE
        a       $a_window,$a_window,$a_windows
        lqd     $m_order,MESH_WINDOW_order($a_window)
        lqd     $m_depth,MESH_WINDOW_depth($a_window)
        andi    $index,$candidate,4*MESH_FACES|3        # 4 times it
        a       $index,$index,$at
        lqx     $faces,$a_faces,$index
        lqx     $more_faces,$a_more_faces,$index
        andi    $shift,$index,15
        shlqby  $faces,$faces,$shift
        ai      $shift,$shift,-16
        rotqmby $more_faces,$more_faces,$shift
        or      $faces,$faces,$more_faces
        # The address of a quadword ignores the last four bits.
        rotmi   $t_index,$faces,-20
        load_vertices $xa,$ya,$za
        rotmi   $t_index,$faces,-12
        and     $t_index,$t_index,$k_places
        load_vertices $xb,$yb,$zb
        rotmi   $t_index,$faces,-4
        and     $t_index,$t_index,$k_places
        load_vertices $xc,$yc,$zc
        xor     $crosses,$za,$zb
        xor     $outside,$za,$zc
        or      $crosses,$crosses,$outside
        rotmai  $crosses,$crosses,-31
    .irp vertex, a,b,c
        recip_interpolated_f4 $t_y,$z\vertex
        recip_step_f4 $z\vertex,$z\vertex,$t_y,$t_e,$k_one
        fm      $x\vertex,$x\vertex,$z\vertex
        fm      $y\vertex,$y\vertex,$z\vertex
    .endr
        limits  $low_x,$high_x,$xa,$xb,$xc
        limits  $low_y,$high_y,$ya,$yb,$yc
        il      $outside,0
    .irp row, 0,1,2,3
        lqd     $limit,MESH_WINDOW_low_x+16*\row($a_window)
        fcgt    $row,$limit,$high_x
        lqd     $limit,MESH_WINDOW_high_x+16*\row($a_window)
        fcgt    $limit,$low_x,$limit
        or      $row,$row,$limit
        lqd     $limit,MESH_WINDOW_low_y+16*\row($a_window)
        fcgt    $limit,$limit,$high_y
        or      $row,$row,$limit
        lqd     $limit,MESH_WINDOW_high_y+16*\row($a_window)
        fcgt    $limit,$low_y,$limit
        or      $row,$row,$limit
        andi    $row,$row,8>>\row
        or      $outside,$outside,$row
    .endr
        andc    $outside,$outside,$crosses
        # The lanes of the run, with their indices.
        rotmi   $length,$candidate,-14                  # 4 times it
        sf      $left,$at,$length
        splat   $left,$left,$m_splat
        cgt     $left,$left,$k_lanes
        andi    $left,$left,15
        andc    $outside,$left,$outside                 # now inside
        cntb    $word,$outside
        a       $rows,$rows,$word
        splat   $word,$index,$m_splat
        a       $word,$word,$k_lanes
        shli    $word,$word,8
        or      $word,$word,$outside
        cgti    $steps,$outside,0
        andi    $steps,$steps,MESH_ROWS_SIZE
    .irp triangle, 0,1,2,3
        shufb   $record,$word,$candidate,$m_record+\triangle
        stqx    $record,$a_list,$found
        rotqbyi $record,$steps,4*\triangle
        a       $found,$found,$record
    .endr
        # After the run's last triangles, the next candidate.
        ai      $at,$at,16
        cgt     $c_more,$length,$at
        and     $at,$at,$c_more
        andc    $c_more,$k_step,$c_more
        a       $a_candidate,$a_candidate,$c_more
        ai      $chunks,$chunks,-1
        brnz    $chunks,next_chunk
        rotqbyi $row,$rows,8
        a       $rows,$rows,$row
        rotqbyi $row,$rows,4
        a       $rows,$rows,$row                        # in all lanes
        rotqbyi $triangles,$triangles,8
        fsmbi   $row,0x0f00
        a       $3,$a_list,$found
        selb    $3,$3,$rows,$row
        fsmbi   $row,0x00f0
        selb    $3,$3,$triangles,$row
        bi      $lr
endfunction filter_triangles_r16
