# surfaces_same_r16   surfaces_r16 for packets whose sixteen rays have all hit the same object
#   C       vec_uint4 surfaces_same_r16(const struct rays16 *, int count, struct surfaces *,
#                                       const struct object *background);
#   In      $3 rays, $4 packets (at least 1), $5 surfaces; rays and surfaces both consecutive
#           $6 the background's object; pointers 16-aligned
#   Out     the packets' surfaces, the bits that surfaces_r16 gives
#           $3 rays that hit something, a count a lane
#   Uses    $3-$6, $7-$77   Saves  -   Stack  0   Calls  -
#   Domain  that of surfaces_r16; in a packet all rays have the same object, also those that are
#           not there
#   Error   0.6 of SURFACES_leave, distance of a point from its surface
#   Twin    lab/twins/src/surfaces.rs
#
# Splats replace the gathers. same_objects_r16 finds the packets for which this is possible.

        .include "surface_tmpl.inc"

        # shuffles
        .set    m_x,54
        .set    m_y,55
        .set    m_z,56
        .set    m_w,57
        .set    m_index,58
        # the object and its material
        .set    quad,59
        .set    quad_sides,60
        .set    a_material,61
        .set    row0,62

# A word of a quadword, in every lane.
.macro  splats out0:req, out1:req, out2:req
        shufb   \out0,$quad,$quad,$m_x
        shufb   \out1,$quad,$quad,$m_y
        shufb   \out2,$quad,$quad,$m_z
.endm

.macro  keep_splat word:req, field:req
        shufb   $row0,$quad,$quad,$m_\word
        keep    $row0,\field
.endm

.macro  keep_splat_share word:req, field:req
        shufb   $row0,$quad,$quad,$m_\word
        keep_share row0,\field
.endm

function surfaces_same_r16
        load_constant $m_x,0x00010203
        load_constant $m_y,0x04050607
        load_constant $m_z,0x08090a0b
        load_constant $m_w,0x0c0d0e0f
        surface_constants
next_row:
        surface_rays
        lqd     $quad,OBJECT_centre($object)
        splats  $centre_x,$centre_y,$centre_z
        shufb   $gain,$quad,$quad,$m_w
        lqd     $quad,OBJECT_axis($object)
        splats  $axis_x,$axis_y,$axis_z
        shufb   $slope,$quad,$quad,$m_w
        lqd     $quad_sides,OBJECT_offset($object)
        shufb   $offset,$quad_sides,$quad_sides,$m_x
        shufb   $leave_object,$quad_sides,$quad_sides,$m_y
        surface_place

        shufb   $a_material,$quad_sides,$quad_sides,$m_z
        keep    $a_material,material
        lqd     $quad,MATERIAL_colour($a_material)
        keep_splat x,red
        keep_splat y,green
        keep_splat z,blue
        keep_splat_share w,diffuse
        lqd     $quad,MATERIAL_highlight($a_material)
        keep_splat_share x,highlight
        keep_splat y,exponent
        keep_splat_share z,mirror
        keep_splat_share w,transmittance
        lqd     $quad,MATERIAL_inverse_index($a_material)
        selb    $m_index,$m_y,$m_x,$front
        keep_splat index,ratio
        keep_splat z,schlick
        keep_splat w,grazing
        lqd     $quad,MATERIAL_emission($a_material)
        keep_splat x,lit_red
        keep_splat y,lit_green
        keep_splat z,lit_blue
        or      $quad,$quad,$quad_sides
        shufb   $flags,$quad,$quad,$m_w
        surface_next
        brnz    $count,next_row                         # at least 4 passes: a packet has four rows
        ori     $3,$hits,0
        bi      $lr
endfunction surfaces_same_r16
