# isect_triangle_r1   nearest hit of one ray with one triangle, from both sides
#   C       void isect_triangle_r1(struct ray *, const struct triangle *, int object);
#   In      $3 ray, $4 triangle, $5 object number; pointers 16-aligned
#   Out     ray: t, object, u, v, if a hit has 0 < t < what was there
#   Uses    $2, $5, $10-$68   Saves  -   Stack  0   Calls  -
#   Domain  as isect_triangles_r16; direction as shear_r16
#   Error   none of its own: the bits of shear_r16 and isect_triangles_r16
#   Twin    oracle/src/twin/triangle.rs
#
# The vertices, then the edges, lie in lanes 0 to 2, while isect_triangles_r16 has a ray a lane.
# Scheduled by spu schedule from isect_triangle_r1.s

        .include "macros.inc"
        .include "rays.inc"
        .include "flat.inc"
        .include "shear_tmpl.inc"
        .include "triangle_tmpl.inc"

        .set    a_ray,3
        .set    a_triangle,4
        .set    object,5
        # constants; k_x, k_y, k_z take word 0, 1, 2 into every lane
        .set    k_x,10
        .set    k_y,11
        .set    k_z,12
        .set    k_one,13
        .set    k_above_one,14
        .set    k_sign,15
        .set    m_pair_xy,16
        .set    m_pair_z,17
        .set    m_third_x,18
        .set    m_third_y,19
        .set    m_third_z,20
        .set    m_next,21
        .set    m_last,22
        # the ray
        .set    ray_origin,23
        .set    ray_direction,24
        .set    origin_x,25
        .set    origin_y,26
        .set    origin_z,27
        .set    direction_x,28
        .set    direction_y,29
        .set    direction_z,30
        .set    n_best,31
        .set    nearest,32
        .set    u_best,33
        .set    v_best,34
        # its shear
        .set    c_y,35
        .set    c_z,36
        .set    slope_x,37
        .set    slope_y,38
        .set    minus_per_z,39
        .set    x,40
        .set    y,41
        .set    z,42
        .set    inverse,43
        .set    t_y,44
        .set    t_e,45
        # the triangle: a vertex a register, then a vertex a lane
        .set    vertex_a,46
        .set    vertex_b,47
        .set    vertex_c,48
        .set    all_x,49
        .set    all_y,50
        .set    all_z,51
        .set    own_x,52
        .set    own_y,53
        .set    own_z,54
        .set    za,55
        .set    zb,56
        .set    zc,57
        # edges: opposite to a, b, c
        .set    p,58
        .set    q,59
        .set    last_x,60
        .set    last_y,61
        .set    next_x,62
        .set    next_y,63
        .set    edges,64
        .set    u,65
        .set    v,66
        .set    w,67
        .set    det,68
        .set    n,58                                    # reused
        .set    outside,59                              # reused
        .set    hit,64                                  # reused

        .section .rodata
        .align  4
# From vertices to coordinates: those of a and b, then c's beside them.
pair_xy:
        .int    0x00010203,0x10111213,0x04050607,0x14151617
pair_z: .int    0x08090a0b,0x18191a1b,0x80808080,0x80808080
third_x:
        .int    0x00010203,0x04050607,0x10111213,0x80808080
third_y:
        .int    0x08090a0b,0x0c0d0e0f,0x14151617,0x80808080
third_z:
        .int    0x00010203,0x04050607,0x18191a1b,0x80808080
# Of the lane after and before, of three.
next:   .int    0x04050607,0x08090a0b,0x00010203,0x80808080
last:   .int    0x08090a0b,0x00010203,0x04050607,0x80808080

function isect_triangle_r1
        .set    t_e_2,2
        ilhu    $k_y,0x405                              # 0e
        lqd     $ray_direction,16($a_ray)               # 0o

        ila     $k_x,0x10203                            # 1e
        lqd     $vertex_a,0($a_triangle)                # 1o

        iohl    $k_y,0x607                              # 2e
        lqd     $vertex_b,16($a_triangle)               # 2o

        ilhu    $k_z,0x809                              # 3e
        lqa     $m_pair_xy,pair_xy                      # 3o

        ilhu    $k_one,0x3f80                           # 4e
        lqa     $m_pair_z,pair_z                        # 4o

        iohl    $k_z,0xa0b                              # 5e
        lqd     $ray_origin,0($a_ray)                   # 5o

        ilhu    $k_above_one,0x3f80                     # 6e
        shufb   $direction_x,$ray_direction,$ray_direction,$k_x # 6o

        ilhu    $k_sign,0x8000                          # 7e
        shufb   $direction_y,$ray_direction,$ray_direction,$k_y # 7o

        iohl    $k_above_one,2                          # 8e
        shufb   $direction_z,$ray_direction,$ray_direction,$k_z # 8o

        lqd     $vertex_c,32($a_triangle)               # 9o
        lqa     $m_third_x,third_x                      # 10o

        fcmgt   $c_y,$direction_y,$direction_x          # 11e
        lqa     $m_third_y,third_y                      # 11o

        nop     $127                                    # 12e pairing
        lqa     $m_third_z,third_z                      # 12o

        selb    $z,$direction_x,$direction_y,$c_y       # 13e
        shufb   $n,$vertex_a,$vertex_b,$m_pair_xy       # 13o

        selb    $x,$direction_y,$direction_z,$c_y       # 14e
        shufb   $outside,$vertex_a,$vertex_b,$m_pair_z  # 14o

        fcmgt   $c_z,$direction_z,$z                    # 15e
        shufb   $origin_x,$ray_origin,$ray_origin,$k_x  # 15o

        selb    $y,$direction_z,$direction_x,$c_y       # 16e
        shufb   $origin_y,$ray_origin,$ray_origin,$k_y  # 16o

        selb    $z,$z,$direction_z,$c_z                 # 17e
        shufb   $origin_z,$ray_origin,$ray_origin,$k_z  # 17o

        selb    $x,$x,$direction_x,$c_z                 # 18e
        shufb   $all_x,$n,$vertex_c,$m_third_x          # 18o

        selb    $y,$y,$direction_y,$c_z                 # 19e
        frest   $t_y,$z                                 # 19o

        shufb   $all_y,$n,$vertex_c,$m_third_y          # 20o
        shufb   $all_z,$outside,$vertex_c,$m_third_z    # 21o

        fs      $all_x,$all_x,$origin_x                 # 22e
        lqa     $m_next,next                            # 22o

        fi      $t_y,$z,$t_y                            # 23e
        lqa     $m_last,last                            # 23o

        nop     $127                                    # 24e pairing
        lqd     $n_best,32($a_ray)                      # 24o

        fs      $all_y,$all_y,$origin_y                 # 25e
        hbr     isect_triangle_r1_return,$lr            # 25o hint

        fs      $all_z,$all_z,$origin_z                 # 26e
        lqd     $nearest,48($a_ray)                     # 26o

        lqd     $u_best,64($a_ray)                      # 27o
        lqd     $v_best,80($a_ray)                      # 28o

        shufb   $object,$object,$object,$k_x            # 29o
        fnms    $t_e,$z,$t_y,$k_one                     # 30e

        selb    $own_z,$all_x,$all_y,$c_y               # 31e
        selb    $own_x,$all_y,$all_z,$c_y               # 32e

        selb    $own_y,$all_z,$all_x,$c_y               # 33e
        selb    $own_x,$own_x,$all_x,$c_z               # 34e

        selb    $own_y,$own_y,$all_y,$c_z               # 35e
        fma     $inverse,$t_e,$t_y,$t_y                 # 36e

        selb    $own_z,$own_z,$all_z,$c_z               # 37e
        xor     $n_best,$n_best,$k_sign                 # 38e

        shufb   $za,$own_z,$own_z,$k_x                  # 39o
        shufb   $zb,$own_z,$own_z,$k_y                  # 40o

        shufb   $zc,$own_z,$own_z,$k_z                  # 41o
        fm      $slope_x,$x,$inverse                    # 42e

        fm      $slope_y,$y,$inverse                    # 43e
        xor     $minus_per_z,$inverse,$k_sign           # 44e

        fnms    $t_e,$slope_x,$z,$x                     # 48e
        fnms    $t_e_2,$slope_y,$z,$y                   # 49e

        fma     $slope_x,$t_e,$inverse,$slope_x         # 54e
        fma     $slope_y,$t_e_2,$inverse,$slope_y       # 55e

        fnms    $own_x,$slope_x,$own_z,$own_x           # 60e
        fnms    $own_y,$slope_y,$own_z,$own_y           # 61e

        shufb   $next_x,$own_x,$own_x,$m_next           # 66o
        shufb   $last_y,$own_y,$own_y,$m_last           # 67o

        shufb   $last_x,$own_x,$own_x,$m_last           # 68o
        shufb   $next_y,$own_y,$own_y,$m_next           # 69o

        fm      $n,$last_y,$next_x                      # 71e
        fms     $outside,$last_y,$next_x,$n             # 77e

        fms     $hit,$last_x,$next_y,$n                 # 78e
        fs      $hit,$hit,$outside                      # 84e

        shufb   $u,$hit,$hit,$k_x                       # 90o
        shufb   $v,$hit,$hit,$k_y                       # 91o

        shufb   $w,$hit,$hit,$k_z                       # 92o
        fa      $det,$u,$v                              # 95e

        fa      $det,$det,$w                            # 101e
        frest   $t_y,$det                               # 107o

        fi      $t_y,$det,$t_y                          # 111e
        fnms    $t_e,$det,$t_y,$k_above_one             # 118e

        fma     $inverse,$t_e,$t_y,$t_y                 # 124e
        fm      $u,$u,$inverse                          # 130e

        fm      $v,$v,$inverse                          # 131e
        fm      $w,$w,$inverse                          # 132e

        fm      $n,$u,$za                               # 136e
        or      $outside,$u,$v                          # 137e

        or      $outside,$outside,$w                    # 139e
        fma     $n,$v,$zb,$n                            # 142e

        fma     $n,$w,$zc,$n                            # 148e
        fm      $n,$n,$minus_per_z                      # 154e

        cgt     $hit,$n_best,$n                         # 160e 0 < t < t_best
        andc    $hit,$hit,$outside                      # 162e

        rotmai  $hit,$hit,-31                           # 164e the sign's mask
        selb    $n_best,$n_best,$n,$hit                 # 168e

        selb    $nearest,$nearest,$object,$hit          # 169e
        selb    $u_best,$u_best,$u,$hit                 # 170e

        selb    $v_best,$v_best,$v,$hit                 # 171e
        stqd    $nearest,48($a_ray)                     # 171o

        xor     $n_best,$n_best,$k_sign                 # 172e
        stqd    $u_best,64($a_ray)                      # 172o

        stqd    $v_best,80($a_ray)                      # 173o
        stqd    $n_best,32($a_ray)                      # 174o

        nop     $127                                    # 175e pairing
isect_triangle_r1_return:
        bi      $lr                                     # 175o
endfunction isect_triangle_r1
