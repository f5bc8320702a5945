# isect_sphere_r1   nearest hit of one ray with one sphere
#   C       void isect_sphere_r1(struct ray *, const struct sphere *, int object);
#   In      $3 ray, $4 sphere, $5 object number; pointers 16-aligned
#   Out     ray: t, object, if a hit is at 0 < t < the t that was there
#   Uses    $3-$40   Saves  -   Stack  0   Calls  -
#   Domain  |d| = 1 within 4 ulp; radius > 0; coordinates and radius below 2^62; t not below 0 (0
#           leaves the ray alone)
#   Error   40 ulp of the larger of t and r, origin up to 30 radii from the centre, ray within
#           0.995 r of it
#   Twin    lab/twins/src/sphere_ray.rs
#
# Returns the same bits as isect_sphere_r16, by using its formulas and its order of sums
# (sphere_ray_tmpl.inc). Only latency matters here. Vectors stay in one register where lanes are
# independent. Sums are computed from splats, so that they need no rotation and are in all lanes,
# ready for the next vector.

        .include "work_unit.inc"
        .include "macros.inc"
        .include "rays.inc"

        .set    NEXT,3
        registers a_ray,a_sphere,object
        # constants
        registers k_half,k_one,m_sign,m_x,m_y,m_z,m_radius2
        # the ray and the sphere
        registers origin,direction,dx,dy,dz,t_best,nearest,quadword,radius2
        # from the origin to the centre, and from the ray's nearest point to it
        registers centre,cx,cy,cz,l,lx,ly,lz
        # temporaries, the same in all lanes
        registers b,disc,out,y,s,e,t,c_meets,c_hit,minus_t
        registers limit                                 # -t of the nearest hit so far

function isect_sphere_r1
        lqd     $quadword,0($a_sphere)
        lqd     $origin,RAY_origin($a_ray)
        lqd     $direction,RAY_direction($a_ray)
        lqd     $t_best,RAY_t($a_ray)
        lqd     $nearest,RAY_object($a_ray)
        load_constant $m_x,0x00010203
        load_constant $m_y,0x04050607
        load_constant $m_z,0x08090a0b
        load_constant $m_radius2,0x0c0d0e0f
        ilhu    $k_half,0x3f00
        ilhu    $k_one,0x3f80
        ilhu    $m_sign,0x8000
        xor     $limit,$t_best,$m_sign
        fs      $centre,$quadword,$origin
        shufb   $dx,$direction,$direction,$m_x
        shufb   $dy,$direction,$direction,$m_y
        shufb   $dz,$direction,$direction,$m_z
        shufb   $radius2,$quadword,$quadword,$m_radius2
        shufb   $cx,$centre,$centre,$m_x
        shufb   $cy,$centre,$centre,$m_y
        shufb   $cz,$centre,$centre,$m_z
        fm      $b,$cx,$dx
        fma     $b,$cy,$dy,$b
        fma     $b,$cz,$dz,$b
        fnms    $l,$b,$direction,$centre
        shufb   $lx,$l,$l,$m_x
        shufb   $ly,$l,$l,$m_y
        shufb   $lz,$l,$l,$m_z
        fnms    $disc,$lx,$lx,$radius2
        fnms    $disc,$ly,$ly,$disc
        fnms    $disc,$lz,$lz,$disc
        frsqest $y,$disc
        fi      $y,$disc,$y
        fms     $out,$b,$b,$disc
        fm      $s,$disc,$y
        cgti    $c_meets,$disc,-1
        fnms    $e,$s,$y,$k_one                         # 1 - s y
        selb    $s,$s,$out,$m_sign
        fma     $e,$e,$k_half,$k_one
        fms     $minus_t,$s,$e,$b
        fnms    $t,$s,$e,$b
        cgt     $c_hit,$limit,$minus_t
        and     $c_hit,$c_hit,$c_meets
        selb    $t_best,$t_best,$t,$c_hit
        selb    $nearest,$nearest,$object,$c_hit
        stqd    $t_best,RAY_t($a_ray)
        stqd    $nearest,RAY_object($a_ray)
        bi      $lr
endfunction isect_sphere_r1
