# isect_mesh_pairs_r16   nearest hit of packets' rays with runs of a mesh's triangles
#   C       int isect_mesh_pairs_r16(const struct mesh_candidate *, int count,
#                                    const struct mesh_header *);
#   In      $3 candidates of runs of triangles, $4 count (0 is none), $5 the runs' block, in local
#           store and relative to the eye; pointers 16-aligned
#   Out     the candidates' packets: t, object, where a hit has 0 < t < what was there; object is
#           MESH_HIT, plus 128 times the block's number, plus the triangle's index
#           $3 how many triangles were tested with a packet
#   Uses    $3-$5, $10-$62   Saves  -   Stack  0   Calls  -
#   Domain  distances from the origin below 2^60; triangles higher than 2^-50 across the ray; runs
#           of at least one triangle
#   Error   6 ulp of t, 8e-5 in barycentric coordinates; edges from 1/100 of the distance to all of
#           it, area across the ray above 1/20 of their square
#   Twin    lab/twins/src/mesh_pairs.rs
#
# As watertight as isect_triangle_pairs_r16, with the same steps: triangles that share a vertex get
# the same bits for it. The loop goes over triangles, not over runs, so that short runs cost no
# branches. Pipelined, it takes 251 cycles a triangle instead of 281, and 2.8 KB more of local
# store, where the cache loses a block and a half.

        .include "work_unit.inc"
        .include "macros.inc"
        .include "pairs.inc"
        .include "triangle_tmpl.inc"

        .set    NEXT,3
        registers a_first                               # candidate
        registers count,a_block
        # constants
        .set    NEXT,10
        registers k_above_one,k_sign,a_controls,m_splat,m_indices,k_step
        # the block
        registers a_vertices,a_faces,hit,both
        # state
        registers a_candidate,a_run
        registers triangles                             # minus those that are left
        registers at                                    # in the run: 4 times the index
        # the candidate
        registers candidate,a_packet,a_shear
        # the triangle
        registers face,index,object,vertex_a,vertex_b,vertex_c
        # temporaries
        registers xa,ya,za,xb,yb,zb,xc,yc,zc,axis,origin,slope
        registers p,q
        registers u,v,w,det,inverse,t_y,t_e,n
        registers outside,seen,t,t_best,nearest,control
        registers ends,more
        .set    ahead,n
        # only before the loop
        .set    sum,p
        .set    header,q
        .set    rest,u

        sign_controls_table .rodata.mesh
vertex_indices:                                         # three bytes to the ends of three words
        .int    0x80808000,0x80808001,0x80808002,0x80808080

function isect_mesh_pairs_r16
        ori     $a_candidate,$a_first,0
        ori     $a_run,$a_first,0
        il      $3,0
        biz     $count,$lr
next_run:
        lqd     $candidate,0($a_run)
        rotmi   $candidate,$candidate,-16
        a       $3,$3,$candidate
        ai      $a_run,$a_run,MESH_CANDIDATE_SIZE
        ai      $count,$count,-1
        brnz    $count,next_run

        ori     $triangles,$3,0
        splat_mask $m_splat
        load_above_one $k_above_one
        ilhu    $k_sign,0x8000
        ila     $a_controls,sign_controls
        lqa     $m_indices,vertex_indices
        il      $k_step,MESH_CANDIDATE_SIZE
        lqd     $header,MESH_HEADER_magic($a_block)
        rotqbyi $hit,$header,MESH_HEADER_number
        shli    $hit,$hit,7
        or      $hit,$hit,$k_sign
        splat   $hit,$hit,$m_splat
        lqd     $rest,MESH_HEADER_nodes&~15($a_block)
        mpyi    $a_vertices,$rest,BOXES_SIZE
        a       $a_vertices,$a_vertices,$a_block
        ai      $a_vertices,$a_vertices,MESH_HEADER_SIZE
        rotqbyi $a_faces,$rest,MESH_HEADER_vertices&15
        shli    $a_faces,$a_faces,4
        a       $a_faces,$a_faces,$a_vertices
        rotqbyi $both,$rest,MESH_HEADER_sides&15
        shli    $both,$both,1                           # SIDES_BOTH to the sign
        splat   $both,$both,$m_splat
        il      $at,0
next_triangle:
        lqd     $candidate,0($a_candidate)
        rotqbyi $a_packet,$candidate,MESH_CANDIDATE_packet
        rotqbyi $a_shear,$candidate,MESH_CANDIDATE_bound
        lqd     $a_shear,MESH_BOUND_shears&~15($a_shear)
        rotqbyi $a_shear,$a_shear,MESH_BOUND_shears&15
        andi    $index,$candidate,4*MESH_FACES|3        # 4 times it
        a       $index,$index,$at
        lqx     $face,$a_faces,$index
        a       $vertex_a,$a_faces,$index
        rotqby  $face,$face,$vertex_a
        rotqmbii $index,$index,-2
        splat   $index,$index,$m_splat
        or      $object,$index,$hit
        shufb   $face,$face,$face,$m_indices
        shlqbii $face,$face,4
        rotqbyi $vertex_b,$face,4
        rotqbyi $vertex_c,$face,8
        lqx     $vertex_a,$a_vertices,$face
        lqx     $vertex_b,$a_vertices,$vertex_b
        lqx     $vertex_c,$a_vertices,$vertex_c
        # After the run's last triangle, the next candidate.
        ai      $at,$at,4
        rotqmbyi $ends,$candidate,-1                    # 4 times the run's length
        rotqmbii $ends,$ends,8+2-16
        cgt     $more,$ends,$at
        and     $at,$at,$more
        andc    $ends,$k_step,$more
        a       $a_candidate,$a_candidate,$ends
    .irp row, 0,1,2,3
        triangle_row \row
        xor     $seen,$det,$slope                       # of -1 / direction z
        outside_if_behind $seen
        xor     $t,$n,$k_sign
        keep_nearer \row
    .endr
        ai      $triangles,$triangles,-1
        brnz    $triangles,next_triangle
        bi      $lr
endfunction isect_mesh_pairs_r16
