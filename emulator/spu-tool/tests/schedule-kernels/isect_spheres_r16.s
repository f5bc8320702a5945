# isect_spheres_r16   nearest entry of sixteen primary rays into the spheres of an array
#   C       void isect_spheres_r16(struct packet *, const struct eye_sphere *, int count,
#                                  int object);
#   In      $3 packet, $4 spheres, $5 count (0 is none), $6 object number of the first;
#           pointers 16-aligned
#   Out     packet: t, object, where an entry is nearer than what was there
#   Uses    $5-$6, $10-$49   Saves  -   Stack  0   Calls  -
#
# For the centre c as the eye sees it and the unit direction d:
#   b = c.d             where the ray passes the centre
#   l = c - b d         from there to the centre
#   disc = r^2 - l.l    below 0: the ray passes by
#   t = b - sqrt(disc)  the entry; behind the eye: no hit (an opaque sphere has no inside)
# The perpendicular l keeps the digits that the b^2 - c of a distant sphere loses (Hearn and
# Baker). There is no NaN that a compare could fail on, so disc < 0 is looked for.

        .include "kernel.inc"

        .set    a_packet,3
        .set    a_sphere,4
        .set    count,5
        .set    object,6
        # constants
        .set    k_half,10
        .set    k_zero,11
        .set    m_splat,12
        # the rays: rows 0 to 3 of the packet
        .set    dx,13
        .set    dy,17
        .set    dz,21
        # results, carried from sphere to sphere
        .set    t_best,25
        .set    nearest,29
        # the sphere
        .set    cx,33
        .set    cy,34
        .set    cz,35
        .set    radius2,36
        # temporaries
        .set    b,37
        .set    lx,38
        .set    ly,39
        .set    lz,40
        .set    disc,41
        .set    root,42
        .set    t,43
        .set    t_y,44
        .set    t_s,45
        .set    c_nearer,46
        .set    c_ahead,47
        .set    c_past,48
        .set    c_hit,49

function isect_spheres_r16
        biz     $count,$lr
        splat_mask $m_splat
        splat   $object,$object,$m_splat
        ilhu    $k_half,0x3f00
        il      $k_zero,0
    .irp row, 0,1,2,3
        lqd     $dx+\row,PACKET_direction_x+16*\row($a_packet)
        lqd     $dy+\row,PACKET_direction_y+16*\row($a_packet)
        lqd     $dz+\row,PACKET_direction_z+16*\row($a_packet)
        lqd     $t_best+\row,PACKET_t+16*\row($a_packet)
        lqd     $nearest+\row,PACKET_object+16*\row($a_packet)
    .endr
next_sphere:
        lqd     $cx,EYESPHERE_centre($a_sphere)
        lqd     $cy,EYESPHERE_centre+16($a_sphere)
        lqd     $cz,EYESPHERE_centre+32($a_sphere)
        lqd     $radius2,EYESPHERE_radius_squared($a_sphere)
    .irp row, 0,1,2,3
        fm      $b,$cx,$dx+\row
        fma     $b,$cy,$dy+\row,$b
        fma     $b,$cz,$dz+\row,$b
        fnms    $lx,$b,$dx+\row,$cx
        fnms    $ly,$b,$dy+\row,$cy
        fnms    $lz,$b,$dz+\row,$cz
        fm      $disc,$lx,$lx
        fma     $disc,$ly,$ly,$disc
        fma     $disc,$lz,$lz,$disc                     # l.l
        fs      $disc,$radius2,$disc
        sqrt_f4 $root,$disc,$t_y,$t_s,$k_half
        fs      $t,$b,$root
        fcgt    $c_nearer,$t_best+\row,$t
        fcgt    $c_ahead,$t,$k_zero
        fcgt    $c_past,$k_zero,$disc
        and     $c_hit,$c_nearer,$c_ahead
        andc    $c_hit,$c_hit,$c_past
        selb    $t_best+\row,$t_best+\row,$t,$c_hit
        selb    $nearest+\row,$nearest+\row,$object,$c_hit
    .endr
        ai      $object,$object,1
        ai      $a_sphere,$a_sphere,EYESPHERE_SIZE
        ai      $count,$count,-1
        brnz    $count,next_sphere
    .irp row, 0,1,2,3
        stqd    $t_best+\row,PACKET_t+16*\row($a_packet)
        stqd    $nearest+\row,PACKET_object+16*\row($a_packet)
    .endr
        bi      $lr
endfunction isect_spheres_r16
