# isect_mesh_rows_r4   nearest hit of rows of rays from the eye with a mesh's triangles
#   C       void isect_mesh_rows_r4(const struct mesh_rows *, int rows,
#                                   const struct mesh_header *);
#   In      $3 triangles and packets' rows, $4 how many rows they have (0 is none), $5 the
#           triangles' block, in local store and relative to the eye; pointers 16-aligned
#   Out     the rows: t, object, where a hit has 0 < t < what was there; object is MESH_HIT, plus
#           128 times the block's number, plus the triangle's index
#   Uses    $3-$5, $10-$62   Saves  -   Stack  0   Calls  -
#   Domain  as isect_mesh_pairs_r16; rays from the eye, whose origins are 0; each triangle has a
#           row
#   Error   6 ulp of t, 8e-5 in barycentric coordinates; edges from 1/100 of the distance to all of
#           it, area across the ray above 1/20 of their square
#   Twin    lab/twins/src/mesh_rows.rs
#
# The steps are those of isect_mesh_pairs_r16, of which the origin's are left out, so the hits have
# the same bits. A pass of the loop is a row, not a triangle.

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
        ori     $a_rows,$a_first,0
        biz     $rows,$lr
        splat_mask $m_splat
        load_above_one $k_above_one
        ilhu    $k_sign,0x8000
        ila     $a_controls,sign_controls
        lqa     $m_indices,vertex_indices
        il      $k_step,MESH_ROWS_SIZE
        il      $k_all,15
        load_constant $k_below,0x7fffffff
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
        ori     $ahead_rows,$k_all,0
next_row:
        lqd     $word,0($a_rows)
        rotqbyi $a_packet,$word,MESH_ROWS_packet
        rotqbyi $a_bound,$word,MESH_ROWS_bound
        lqd     $a_shear,MESH_BOUND_shears&~15($a_bound)
        rotqbyi $a_shear,$a_shear,MESH_BOUND_shears&15
        # The first row that is left, which is 28 less than this number of zeros before its bit.
        and     $bits,$word,$ahead_rows
        clz     $lead,$bits
        shli    $place,$lead,4
        a       $a_packet,$a_packet,$place
        a       $a_shear,$a_shear,$place
        sfi     $lead,$lead,0
        rotm    $ahead_rows,$k_below,$lead
        and     $more,$word,$ahead_rows
        andi    $more,$more,15
        cgti    $more,$more,0
        selb    $ahead_rows,$k_all,$ahead_rows,$more
        andc    $more,$k_step,$more
        rotmi   $index,$word,-8                         # 4 times it
        lqx     $face,$a_faces,$index
        a       $vertex_a,$a_faces,$index
        rotqby  $face,$face,$vertex_a
        rotmi   $index,$word,-10
        splat   $index,$index,$m_splat
        or      $object,$index,$hit
        shufb   $face,$face,$face,$m_indices
        shlqbii $face,$face,4
        rotqbyi $vertex_b,$face,4
        rotqbyi $vertex_c,$face,8
        lqx     $vertex_a,$a_vertices,$face
        lqx     $vertex_b,$a_vertices,$vertex_b
        lqx     $vertex_c,$a_vertices,$vertex_c
        a       $a_rows,$a_rows,$more
        triangle_row -28, eye
        xor     $seen,$det,$slope                       # of -1 / direction z
        outside_if_behind $seen
        xor     $t,$n,$k_sign
        keep_nearer -28
        ai      $rows,$rows,-1
        brnz    $rows,next_row
        bi      $lr
endfunction isect_mesh_rows_r4
