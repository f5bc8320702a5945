# surfaces_r16   where sixteen rays have hit what they hit, and what the surfaces are there
#   C       vec_uint4 surfaces_r16(const struct rays16 *, int count, struct surfaces *,
#                                  const struct object *background);
#   In      $3 rays, $4 packets (at least 1), $5 surfaces; rays and surfaces both consecutive
#           $6 the background's object; pointers 16-aligned
#   Out     the packets' surfaces; of a ray that is not there (t < 0) anything, but shares of 0
#           $3 rays that hit something, a count a lane
#   Uses    $3-$77   Saves  -   Stack  0   Calls  -
#   Domain  the rays' objects are addresses of objects, also of rays that are not there; |d| = 1
#           within 4 ulp, t below 2^20; OBJECT_leave is 2^-22 (|centre x| + |centre y| + |centre z|
#           + |offset|)
#   Error   0.6 of SURFACES_leave, distance of a point from its surface; normals 2^-23 + leave/r,
#           each component, r the distance from the axis or the centre
#   Twin    lab/twins/src/surfaces.rs
#
# leave = OBJECT_leave + 2^-22 (|Px| + |Py| + |Pz|), which is 2 ulp of every number that a hit is
# computed from. In 240000 tries, rays that started at half of it from spheres and planes did not
# meet them again, even along the surface. Of those that started at a quarter, 1 in 2400 did.
#
# The odd pipe is the bound. Of its 111 instructions, 34 load and store rays and surfaces, 28
# gather the quadwords of objects and materials, and 6 compute their addresses. Transposing four
# quadwords takes 6 instructions of the odd and 4 of the even pipe, instead of 8 of the odd.

        .include "surface_tmpl.inc"

        # shuffles
        .set    m_behind,54
        .set    m_first,55
        .set    m_second,56
        .set    m_third,57
        .set    m_fourth,58
        # gathered
        .set    a_lane0,59
        .set    a_lane1,60
        .set    a_lane2,61
        .set    a_lane3,62
        .set    quad0,63
        .set    quad1,64
        .set    quad2,65
        .set    quad3,66
        .set    low02,67
        .set    high02,68
        .set    low13,69
        .set    high13,70
        .set    sides02,71
        .set    sides13,72
        .set    row0,73
        .set    row1,74
        .set    row2,75
        .set    row3,76
        .set    m_ratio,77

# The first half of transposing four quadwords A, B, C, D: A0 A1 C0 C1, C2 C3 A2 A3 and B0 B1 D0
# D1, D2 D3 B2 B3.
.macro  gather offset:req
    .irp lane, 0,1,2,3
        lqd     $quad\lane,\offset($a_lane\lane)
    .endr
        rotqbyi $quad2,$quad2,8
        rotqbyi $quad3,$quad3,8
        selb    $low02,$quad0,$quad2,$m_behind
        selb    $high02,$quad2,$quad0,$m_behind
        selb    $low13,$quad1,$quad3,$m_behind
        selb    $high13,$quad3,$quad1,$m_behind
.endm

# The second half.
.macro  row0_of out:req
        shufb   \out,$low02,$low13,$m_first
.endm
.macro  row1_of out:req
        shufb   \out,$low02,$low13,$m_second
.endm
.macro  row2_of out:req
        shufb   \out,$high02,$high13,$m_third
.endm

.macro  four_rows out0:req, out1:req, out2:req, out3:req
        row0_of \out0
        row1_of \out1
        row2_of \out2
        shufb   \out3,$high02,$high13,$m_fourth
.endm

# Moves the four lanes of a row of addresses to the preferred slots of four registers.
.macro  addresses row:req
        ori     $a_lane0,\row,0
        rotqbyi $a_lane1,\row,4
        rotqbyi $a_lane2,\row,8
        rotqbyi $a_lane3,\row,12
.endm

        quadword_constants
        # words of two quadwords P and Q
first:  .int    0x00010203,0x10111213,0x08090a0b,0x18191a1b # P0 Q0 P2 Q2
second: .int    0x04050607,0x14151617,0x0c0d0e0f,0x1c1d1e1f # P1 Q1 P3 Q3
third:  .int    0x08090a0b,0x18191a1b,0x00010203,0x10111213 # P2 Q2 P0 Q0
fourth: .int    0x0c0d0e0f,0x1c1d1e1f,0x04050607,0x14151617 # P3 Q3 P1 Q1

function surfaces_r16
        lqa     $m_first,first
        lqa     $m_second,second
        lqa     $m_third,third
        lqa     $m_fourth,fourth
        fsmbi   $m_behind,0x00ff
        surface_constants
next_row:
        surface_rays
        addresses $object
        gather  OBJECT_centre
        four_rows $centre_x,$centre_y,$centre_z,$gain
        gather  OBJECT_axis
        four_rows $axis_x,$axis_y,$axis_z,$slope
        gather  OBJECT_offset
        row0_of $offset
        row1_of $leave_object
        row2_of $row2
        ori     $sides02,$high02,0
        ori     $sides13,$high13,0
        surface_place

        keep    $row2,material
        addresses $row2
        gather  MATERIAL_colour
        four_rows $row0,$row1,$row2,$row3
        keep    $row0,red
        keep    $row1,green
        keep    $row2,blue
        keep_share row3,diffuse
        gather  MATERIAL_highlight
        four_rows $row0,$row1,$row2,$row3
        keep_share row0,highlight
        keep    $row1,exponent
        keep_share row2,mirror
        keep_share row3,transmittance
        gather  MATERIAL_inverse_index
        selb    $m_ratio,$m_second,$m_first,$front
        shufb   $row0,$low02,$low13,$m_ratio
        keep    $row0,ratio
        row2_of $row2
        keep    $row2,schlick
        shufb   $row3,$high02,$high13,$m_fourth
        keep    $row3,grazing
        gather  MATERIAL_emission
        row0_of $row0
        keep    $row0,lit_red
        row1_of $row1
        keep    $row1,lit_green
        row2_of $row2
        keep    $row2,lit_blue
        or      $high02,$high02,$sides02
        or      $high13,$high13,$sides13
        shufb   $flags,$high02,$high13,$m_fourth
        surface_next
        brnz    $count,next_row                         # at least 4 passes: a packet has four rows
        ori     $3,$hits,0
        bi      $lr
endfunction surfaces_r16
