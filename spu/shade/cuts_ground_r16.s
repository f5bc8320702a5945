# cuts_ground_r16   makes the surfaces of ground that cuts have found, and clears pixels' sums
#   C       void cuts_ground_r16(const struct rays16 *, struct surfaces *, int count,
#                                  unsigned ground, vec_uint4 is_root);
#   In      $3 primary rays, $4 surfaces, $5 packets (at least 1), all consecutive; $6 address of
#           the ground's OBJECT; $7 -1 if colours are square roots of light, 0 if they are light;
#           pointers 16-aligned
#   Out     normals, colours and leave where a ray has hit the ground; 0 in all sums of the rays'
#           pixels
#   Uses    $3-$40   Saves  -   Stack  0   Calls  -
#   Domain  the four pixels of a row are one after the other
#   Error   3 ulp of 1, each part of a normal; 2 ulp of a colour
#   Twin    lab/twins/src/cuts.rs
#
# The loop counts up, so that it isn't pipelined, which would take more local store.
#
# A shadow ray meets the ground's triangles, which are not exactly where the cut's patches are. So
# it starts above them, as far as 1/LEAVE of the distance.

        .include "work_unit.inc"
        .include "macros.inc"
        .include "math.inc"
        .include "transpose.inc"
        .include "height.inc"

        .set    NEXT,3
        registers a_rays,a_surfaces,count,ground,is_root
        registers m_first,m_last,k_one,k_half,k_sign,k_leave,k_scale,k_square,k_light
        registers m_red,zero,m_splat
        registers a_pixels,is_ground
        registers quad                                  # to quad+3
        .set    NEXT,quad+4
        registers words                                 # to words+3
        .set    NEXT,words+4
        registers x,y,z,t_y,t_e,squared,old

        transpose_table .rodata.cuts

.macro  put value:req, field:req, row:req
        lqd     $old,SURFACES_\field+16*\row($a_surfaces)
        selb    $old,$old,\value,$is_ground
        stqd    $old,SURFACES_\field+16*\row($a_surfaces)
.endm

.macro  tint channel:req, row:req
        and     $t_y,$quad+3,$m_red
        cuflt   $t_y,$t_y,32
        shli    $quad+3,$quad+3,10
        lqd     $old,SURFACES_\channel+16*\row($a_surfaces)
        fm      $t_y,$t_y,$k_scale
        fma     $t_e,$t_y,$k_square,$k_light
        fm      $t_y,$t_y,$t_e
        fm      $t_y,$t_y,$old
        selb    $old,$old,$t_y,$is_ground
        stqd    $old,SURFACES_\channel+16*\row($a_surfaces)
.endm

function cuts_ground_r16
        lqa     $m_first,transpose_first
        lqa     $m_last,transpose_last
        splat_mask $m_splat
        splat   $ground,$ground,$m_splat
        ilhu    $k_one,0x3f80
        ilhu    $k_half,0x3f00
        ilhu    $k_sign,0x8000
        ilhu    $k_leave,0x3b00                         # 1/512
        splat   $is_root,$is_root,$m_splat
        and     $k_square,$k_one,$is_root
        andc    $k_light,$k_one,$is_root
        load_constant $k_scale,0x3f802008               # 1024/1023
        ilhu    $m_red,0xffc0
        il      $zero,0
        sfi     $count,$count,0
next_packet:
    .irp row, 0,1,2,3
        lqd     $a_pixels,RAYS16_pixel+16*\row($a_rays)
        lqd     $is_ground,RAYS16_object+16*\row($a_rays)
        lqd     $squared,RAYS16_t+16*\row($a_rays)
        ceq     $is_ground,$is_ground,$ground
    .irp lane, 0,1,2,3
        lqd     $quad+\lane,16*\lane($a_pixels)
        stqd    $zero,16*\lane($a_pixels)
    .endr
        fm      $squared,$squared,$k_leave
        put     $squared,leave,\row
        transpose quad,quad,words,$m_first,$m_last
        fma     $squared,$quad+1,$quad+1,$k_one
        fma     $squared,$quad+2,$quad+2,$squared
        rsqrt_f4 $y,$squared,$t_y,$t_e,$k_half,$k_one
        fm      $x,$quad+1,$y
        fm      $z,$quad+2,$y
        xor     $x,$x,$k_sign
        xor     $z,$z,$k_sign
    .irp axis, x,y,z
        put     $\axis,normal_\axis,\row
        put     $\axis,plane_\axis,\row
    .endr
        tint    red,\row
        tint    green,\row
        tint    blue,\row
    .endr
        il      $t_y,RAYS16_SIZE
        a       $a_rays,$a_rays,$t_y
        il      $t_y,SURFACES_SIZE
        a       $a_surfaces,$a_surfaces,$t_y
        ai      $count,$count,1
        brnz    $count,next_packet
        bi      $lr
endfunction cuts_ground_r16
