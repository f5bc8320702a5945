# refine_hits_r16   moves hits on spheres and cones along their rays onto the surfaces
#   C       void refine_hits_r16(const struct ray_packet *, int count, struct surfaces *);
#   In      $3 rays, $4 packets (at least 1), $5 surfaces, as surfaces_r16 has made them; rays and
#           surfaces both consecutive; pointers 16-aligned
#   Out     surfaces: point, normal and plane, where the object is round and the ray does not graze
#           it: the cosine to the normal is above 1/64
#   Uses    $3-$5, $10-$76   Saves  -   Stack  0   Calls  -
#   Domain  that of surfaces_r16
#   Error   0.4 of SURFACES_leave, distance of a point from its surface
#   Twin    lab/twins/src/refine_hits.rs
#
# A distance is a single, and off by an ulp or more. surfaces_r16 puts the point back on the surface
# along the normal, so it is beside the ray, and the normal is turned by that over the radius. Rays
# from one small mirror to the next multiply this error. Here a Newton step corrects the distance
# instead. It is relative to the centre, where a single has more digits for small objects. With the
# names of surface_tmpl.inc, for the height e of w above the surface:
#   k = e / (normal.d)
#   a = a - k (d - (d.axis) axis), normal = gain a/|a| + slope axis, point = P - k d
# The rounding of P is then put right along the normal, as there.
#
# The loop counts up, so that it isn't pipelined, which would take 1 KB more of local store.

        .include "work_unit.inc"
        .include "macros.inc"
        .include "barycentric.inc"
        .include "math.inc"
        .include "reciprocal.inc"
        .include "vectors.inc"

        .set    NEXT,3
        registers a_rays,count,a_surfaces
        # constants
        .set    NEXT,10
        registers m_xy,m_zw,m_first,m_second,k_half,k_one,k_sign,k_grazing,rows
        # the lanes' objects
        registers object                                # to 22
        .set    quad,23                                 # to 26
        .set    NEXT,27
        registers low,high,any
        registers centre_x,centre_y,centre_z,gain,axis_x,axis_y,axis_z,slope,offset
        # the row
        registers t,point_x,point_y,point_z,direction_x,direction_y,direction_z
        registers off_x,off_y,off_z,along,rise,across_x,across_y,across_z
        registers squared,scale,height,against,steep,flip,step,t_y,t_e
        registers normal_x,normal_y,normal_z,old_x,old_y,old_z

# From off, the vector from the centre, along the axis and across it, and the height.
.macro  height_of_off
        dot_f4  $along,off,axis
    .irp axis, x,y,z
        fnms    $off_\axis,$along,$axis_\axis,$off_\axis
    .endr
        scale_of_off
        fms     $height,$squared,$scale,$offset
        fma     $height,$slope,$along,$height
.endm

# scale = gain / |off|
.macro  scale_of_off
        dot_f4  $squared,off,off
        rsqrt_f4 $scale,$squared,$t_y,$t_e,$k_half,$k_one
        fm      $scale,$scale,$gain
.endm

function refine_hits_r16
        lqa     $m_xy,transpose                         # of smooth_r16
        lqa     $m_zw,transpose+16
        lqa     $m_first,transpose+32
        lqa     $m_second,transpose+48
        ilhu    $k_half,0x3f00
        ilhu    $k_one,0x3f80
        ilhu    $k_sign,0x8000
        ilhu    $k_grazing,0x3c80                       # 1/64
next_packet:
        il      $rows,-4
next_row:
        lqd     $object,RAYS16_object($a_rays)
        spread_lanes object
        gather  object,OBJECT_centre,$centre_x,$centre_y,$centre_z,$gain
        orx     $any,$gain
        brz     $any,row_done                           # all are flat
        gather  object,OBJECT_axis,$axis_x,$axis_y,$axis_z,$slope
    .irp lane, 0,1,2,3
        lqd     $quad+\lane,OBJECT_offset($object+\lane)
    .endr
        shufb   $low,$quad,$quad+1,$m_xy
        shufb   $high,$quad+2,$quad+3,$m_xy
        shufb   $offset,$low,$high,$m_first
        lqd     $t,RAYS16_t($a_rays)
    .irp axis, x,y,z
        lqd     $point_\axis,RAYS16_origin_\axis($a_rays)
        lqd     $direction_\axis,RAYS16_direction_\axis($a_rays)
        fs      $off_\axis,$point_\axis,$centre_\axis
        fma     $off_\axis,$t,$direction_\axis,$off_\axis
        fma     $point_\axis,$t,$direction_\axis,$point_\axis
    .endr
        height_of_off
        dot_f4  $rise,direction,axis
    .irp axis, x,y,z
        fnms    $across_\axis,$rise,$axis_\axis,$direction_\axis
    .endr
        dot_f4  $against,off,across
        fm      $rise,$slope,$rise
        fma     $against,$scale,$against,$rise
        fcmgt   $steep,$against,$k_grazing
        ceqi    $flip,$gain,0
        andc    $steep,$steep,$flip
        recip_interpolated_f4 $step,$against
        fm      $step,$height,$step
    .irp axis, x,y,z
        fnms    $off_\axis,$step,$across_\axis,$off_\axis
        fnms    $point_\axis,$step,$direction_\axis,$point_\axis
    .endr
        scale_of_off
    .irp axis, x,y,z
        fm      $normal_\axis,$slope,$axis_\axis
        fma     $normal_\axis,$scale,$off_\axis,$normal_\axis
        fs      $off_\axis,$point_\axis,$centre_\axis
    .endr
        height_of_off
        andc    $flip,$k_sign,$against
    .irp axis, x,y,z
        fnms    $point_\axis,$height,$normal_\axis,$point_\axis
        xor     $normal_\axis,$normal_\axis,$flip
        lqd     $old_\axis,SURFACES_point_\axis($a_surfaces)
        selb    $point_\axis,$old_\axis,$point_\axis,$steep
        stqd    $point_\axis,SURFACES_point_\axis($a_surfaces)
        lqd     $old_\axis,SURFACES_plane_\axis($a_surfaces)
        selb    $normal_\axis,$old_\axis,$normal_\axis,$steep
        stqd    $normal_\axis,SURFACES_plane_\axis($a_surfaces)
        stqd    $normal_\axis,SURFACES_normal_\axis($a_surfaces)
    .endr
row_done:
        ai      $a_rays,$a_rays,16
        ai      $a_surfaces,$a_surfaces,16
        ai      $rows,$rows,1
        brnz    $rows,next_row
        ai      $a_rays,$a_rays,RAYS16_SIZE/2-32
        ai      $a_rays,$a_rays,RAYS16_SIZE/2-32
        ai      $a_surfaces,$a_surfaces,SURFACES_SIZE/4-16
        ai      $a_surfaces,$a_surfaces,SURFACES_SIZE/4-16
        ai      $a_surfaces,$a_surfaces,SURFACES_SIZE/4-16
        ai      $a_surfaces,$a_surfaces,SURFACES_SIZE/4-16
        ai      $count,$count,-1
        brnz    $count,next_packet
        bi      $lr
endfunction refine_hits_r16
