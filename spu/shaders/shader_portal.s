# shader_portal   sends rays on from another place: turned around the y axis, and moved
#   C       void shader_portal(struct surfaces *, struct rays16 *, const vec_uint4 *mask,
#                              const struct material *, const struct shading *);
#   In      $3 surfaces, $4 rays, $5 four quadwords of lanes to shade, $6 material, $7 shading;
#           pointers 16-aligned
#   Out     points, both normals, and the directions of the rays
#   Uses    $3-$5, $10-$33   Saves  -   Stack  0   Calls  -
#   Domain  h within -2^31 and 2^31
#   Error   8 ulp of the largest coordinate that is used: of a vector, or of a point, the eye and
#           the move
#   Twin    lab/twins/src/shader.rs
#
# The first three parameters are the move, and the fourth is the tangent h of half the angle:
#   c = (1 - h^2)/(1 + h^2)   s = 2 h/(1 + h^2)   x' = c x + s z   z' = c z - s x
# A point is relative to the eye, so it moves by the turned eye less the eye, too. The material lets
# all light through, so refract_r16 sends the rays on in the directions that are left here.
#
# The loop is not counted down, so the scheduler does not pipeline it. That would take 240 bytes
# more of the memory for games' own shaders.

        .include "work_unit.inc"
        .include "macros.inc"
        .include "reciprocal.inc"
        .include "shader.inc"

        .set    NEXT,3
        registers a_surfaces,a_rays,a_mask,a_material,a_shading
        .set    NEXT,10
        registers parameters,eye,m_word,k_one,h,eye_x,eye_z,by_x,by_y,by_z
        registers squared,inverse,t_y,t_e,cosine,sine,a_end,c_last
        # a row
        registers mask,x,z,turned_x,turned_z,y,moved_y

# Turns the x and the z of a vector. With `by` it is a point, which moves as well.
.macro  turn at:req, vector:req, by
        lqd     $x,\vector\()_x(\at)
        lqd     $z,\vector\()_z(\at)
    .ifb \by
        fm      $turned_x,$cosine,$x
        fm      $turned_z,$cosine,$z
    .else
        fma     $turned_x,$cosine,$x,$by_x
        fma     $turned_z,$cosine,$z,$by_z
    .endif
        fma     $turned_x,$sine,$z,$turned_x
        fnms    $turned_z,$sine,$x,$turned_z
        selb    $x,$x,$turned_x,$mask
        selb    $z,$z,$turned_z,$mask
        stqd    $x,\vector\()_x(\at)
        stqd    $z,\vector\()_z(\at)
.endm

        shader_entry portal

function shader_portal
        lqd     $parameters,MATERIAL_parameters($a_material)
        lqd     $eye,SHADING_eye($a_shading)
        ilhu    $k_one,0x3f80
        ai      $a_end,$a_mask,64
        splat_mask $m_word
        splat   $by_x,$parameters,$m_word
        splat   $eye_x,$eye,$m_word
        load_constant $m_word,0x04050607
        splat   $by_y,$parameters,$m_word
        load_constant $m_word,0x08090a0b
        splat   $by_z,$parameters,$m_word
        splat   $eye_z,$eye,$m_word
        load_constant $m_word,0x0c0d0e0f
        splat   $h,$parameters,$m_word
        fma     $squared,$h,$h,$k_one
        reciprocal_f4 $inverse,$squared,$t_y,$t_e,$k_one
        fnms    $cosine,$h,$h,$k_one
        fa      $sine,$h,$h
        fm      $cosine,$cosine,$inverse
        fm      $sine,$sine,$inverse
        # Near to the eye's own place, the difference of the two is exact.
        fs      $by_x,$by_x,$eye_x
        fs      $by_z,$by_z,$eye_z
        fma     $by_x,$cosine,$eye_x,$by_x
        fma     $by_z,$cosine,$eye_z,$by_z
        fma     $by_x,$sine,$eye_z,$by_x
        fnms    $by_z,$sine,$eye_x,$by_z
next_row:
        lqd     $mask,0($a_mask)
        turn    $a_surfaces,SURFACES_normal
        turn    $a_surfaces,SURFACES_plane
        turn    $a_surfaces,SURFACES_point,by
        turn    $a_rays,RAYS16_direction
        lqd     $y,SURFACES_point_y($a_surfaces)
        fa      $moved_y,$y,$by_y
        selb    $y,$y,$moved_y,$mask
        stqd    $y,SURFACES_point_y($a_surfaces)
        ai      $a_surfaces,$a_surfaces,16
        ai      $a_rays,$a_rays,16
        ai      $a_mask,$a_mask,16
        ceq     $c_last,$a_mask,$a_end
        brz     $c_last,next_row
        bi      $lr
endfunction shader_portal
