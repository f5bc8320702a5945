# any_triangles_r16   which of sixteen rays the triangles of an array stand in the way of
#   C       unsigned any_triangles_r16(const struct rays *, const struct shear *,
#                                      const struct triangle *, int count);
#   In      $3 rays, $4 what shear_r16 made of them, $5 triangles, $6 count (0 is none); pointers
#           16-aligned
#   Out     $3 a bit a ray, 0x8000 of the first: a triangle is hit with 0 < t < rays.t
#   Uses    $3-$6, $10-$55   Saves  -   Stack  0   Calls  -
#   Domain  as isect_triangles_r16
#   Error   no rounding of its own: hits exactly what isect_triangles_r16 hits
#   Twin    lab/twins/src/triangle.rs
#
# Between chunks of CHUNK triangles, the kernel returns if every ray is blocked. Within a chunk the
# loop has no exits, as a pipelined loop must. Rays whose t is not above 0 are ignored.

        .include "work_unit.inc"
        .include "macros.inc"
        .include "rays.inc"
        .include "flat.inc"
        .include "triangle_tmpl.inc"

        .set    CHUNK,8

        .set    code,3
        .set    NEXT,3
        registers a_rays,a_shear,a_triangle,count
        # constants
        .set    NEXT,10
        registers k_above_one,k_sign
        registers n_far                                 # -t of the farthest
        # results, carried from triangle to triangle: a row each, the signs count
        .set    blocked,16
        # the triangle
        .set    NEXT,20
        registers vertex_a,vertex_b,vertex_c
        # temporaries
        registers xa,ya,za,xb,yb,zb,xc,yc,zc,axis,origin,slope,p,q,u,v,w,det,inverse,t_y,t_e,n
        registers outside,hit,low,m_rows,m_code,chunk,c_part,clear
        registers idle                                  # bits: t not above 0
        registers done                                  # bits: blocked or idle
        registers k_zero

        sign_gathers_table

function any_triangles_r16
        load_above_one $k_above_one
        ilhu    $k_sign,0x8000
        lqa     $m_rows,sign_gathers
        lqa     $m_code,sign_gathers+16
        il      $k_zero,0
    .irp row, 0,1,2,3
        lqd     $n_far+\row,RAYS_t+16*\row($a_rays)
        fcgt    $blocked+\row,$n_far+\row,$k_zero
        nor     $blocked+\row,$blocked+\row,$blocked+\row
        xor     $n_far+\row,$n_far+\row,$k_sign
    .endr
        code_of_signs $idle,blocked,$low,$m_rows,$m_code
        lr      $done,$idle
next_chunk:
        ai      $clear,$done,1                          # 0x10000 if no ray is left
        rotmi   $clear,$clear,-16
        brnz    $clear,return
        brz     $count,return
        il      $chunk,CHUNK
        cgt     $c_part,$chunk,$count
        selb    $chunk,$chunk,$count,$c_part
        sf      $count,$chunk,$count
next_triangle:
        lqd     $vertex_a,TRIANGLE_a($a_triangle)
        lqd     $vertex_b,TRIANGLE_b($a_triangle)
        lqd     $vertex_c,TRIANGLE_c($a_triangle)
    .irp row, 0,1,2,3
        triangle_row \row
        cgt     $hit,$n_far+\row,$n                     # 0 < t < t_far
        andc    $hit,$hit,$outside
        or      $blocked+\row,$blocked+\row,$hit
    .endr
        ai      $a_triangle,$a_triangle,TRIANGLE_SIZE
        ai      $chunk,$chunk,-1
        brnz    $chunk,next_triangle
        code_of_signs $done,blocked,$low,$m_rows,$m_code
        br      next_chunk
return:
        xor     $code,$done,$idle
        bi      $lr
endfunction any_triangles_r16
