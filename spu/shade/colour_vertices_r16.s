# colour_vertices_r16   multiplies sixteen surfaces' colours by those of their triangles' vertices
#   C       int colour_vertices_r16(const struct rays16 *, struct surfaces *,
#                                   const vec_uint4 *colours, const struct patch *, int are_roots,
#                                   vec_uint4 *visibility);
#   In      $3 rays, $4 their surfaces, $5 for each patch the packed colours of the vertices, and
#           its MESH_VISIBILITY, $6 the first patch, $8 where that of the rays goes; pointers
#           16-aligned; $7 -1 if colours are square roots of light, 0 if they are light. A ray's hit
#           is an address, of any record
#   Out     surfaces: red, green and blue, where the object is a patch with SIDES_COLOURED; for each
#           ray the MESH_VISIBILITY, where it is one with SIDES_VISIBILITY, else 0; $3 their OR
#   Uses    $3-$8, $10-$79   Saves  -   Stack  0   Calls  -
#   Domain  points in their triangles; edges from 2^-30 to 2^30, and from 1/100 of the points'
#           distance from the eye on; |plane| about 1; up to 128 patches
#   Error   1e-6 of 1, for a colour of 1; for the point as it is given
#   Twin    lab/twins/src/colour.rs
#
# The light of the vertices is interpolated with the shares of the triangle's area that
# texture_places_r16 computes, too.
#
# The loop counts up, so that it isn't pipelined, which would double its size.

        .include "work_unit.inc"
        .include "macros.inc"
        .include "barycentric.inc"
        .include "reciprocal.inc"

        .set    NEXT,3
        registers a_rays,a_surfaces,a_table,a_first,are_roots,a_known
        # constants
        .set    NEXT,10
        registers m_xy,m_zw,m_first,m_second,k_one,k_bits,k_scale,k_light,k_square,k_index,rows
        # the lanes' records
        .set    patch,NEXT                              # to 24
        .set    quad,patch+4                            # to 28
        .set    place,quad+4                            # to 32
        .set    NEXT,place+4
        registers low,high,coloured
        # the row
        registers px,py,pz,gx,gy,gz
        registers ax                                    # the vertices, relative to the point
        registers ay,az,bx,by,bz,cx,cy,cz,rest
        registers turn_x,turn_y,turn_z,share_a,share_b,share_c,inverse,t_y,t_e
        registers packed_a,packed_b,packed_c
        registers part_a,part_b,part_c,factor,old
        registers known,has_known,any

        .section .rodata.colour,"a",@progbits
        .align  4
transpose:
        transpose_shuffles

# Interpolates a channel, whose bits are moved to the end, and multiplies the colour.
.macro  channel name:req, shift:req
    .irp corner, a,b,c
        rotmi   $part_\corner,$packed_\corner,-\shift
        and     $part_\corner,$part_\corner,$k_bits
        csflt   $part_\corner,$part_\corner,0
        fma     $factor,$part_\corner,$k_square,$k_light
        fm      $part_\corner,$part_\corner,$factor
    .endr
        fs      $part_b,$part_b,$part_a
        fs      $part_c,$part_c,$part_a
        fma     $part_a,$share_b,$part_b,$part_a
        fma     $part_a,$share_c,$part_c,$part_a
        lqd     $old,SURFACES_\name($a_surfaces)
        fm      $part_a,$part_a,$k_scale
        fm      $part_a,$part_a,$old
        selb    $old,$old,$part_a,$coloured
        stqd    $old,SURFACES_\name($a_surfaces)
.endm

function colour_vertices_r16
        lqa     $m_xy,transpose
        lqa     $m_zw,transpose+16
        lqa     $m_first,transpose+32
        lqa     $m_second,transpose+48
        ilhu    $k_one,0x3f80
        il      $k_bits,1023
        il      $k_index,0x10000/PATCH_SIZE+1           # exact for 128 patches
        load_constant $k_scale,0x3a802009               # 1 / 1023, rounded up
        splat_mask $low
        fsm     $are_roots,$are_roots
        and     $k_square,$k_scale,$are_roots
        andc    $k_light,$k_one,$are_roots
        splat   $a_table,$a_table,$low
        splat   $a_first,$a_first,$low
        il      $any,0
        il      $rows,-4
next_row:
        lqd     $patch,RAYS16_object($a_rays)
        sf      $place,$a_first,$patch
        mpyu    $place,$place,$k_index
        rotmi   $place,$place,-16
        shli    $place,$place,4
        a       $place,$place,$a_table
        spread_lanes patch
        spread_lanes place
    .irp axis, x,y,z
        lqd     $p\axis,SURFACES_point_\axis($a_surfaces)
        lqd     $g\axis,SURFACES_plane_\axis($a_surfaces)
    .endr
        gather  patch,OBJECT_sides&~15,$rest,$rest,$rest,$coloured
        shli    $has_known,$coloured,6                 # SIDES_VISIBILITY becomes the sign
        rotmai  $has_known,$has_known,-31
        shli    $coloured,$coloured,5                   # SIDES_COLOURED becomes the sign
        rotmai  $coloured,$coloured,-31
        gather  patch,TRI_a,$ax,$ay,$az,$rest
        gather  patch,TRI_b,$bx,$by,$bz,$rest
        gather  patch,TRI_c,$cx,$cy,$cz,$rest
        gather  place,0,$packed_a,$packed_b,$packed_c,$known
        and     $known,$known,$has_known
        stqd    $known,0($a_known)
        or      $any,$any,$known
        ai      $a_known,$a_known,16
    .irp axis, x,y,z
        fs      $a\axis,$a\axis,$p\axis
        fs      $b\axis,$b\axis,$p\axis
        fs      $c\axis,$c\axis,$p\axis
    .endr
        share_of_area $share_a,b,c
        share_of_area $share_b,c,a
        share_of_area $share_c,a,b
        fa      $share_a,$share_a,$share_b
        fa      $share_a,$share_a,$share_c
        reciprocal_f4 $inverse,$share_a,$t_y,$t_e,$k_one
        fm      $share_b,$share_b,$inverse
        fm      $share_c,$share_c,$inverse
        channel red,22
        channel green,12
        channel blue,2
        ai      $a_rays,$a_rays,16
        ai      $a_surfaces,$a_surfaces,16
        ai      $rows,$rows,1
        brnz    $rows,next_row
        orx     $3,$any
        bi      $lr
endfunction colour_vertices_r16
