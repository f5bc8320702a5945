# path_bounds_r16   what the rays of packets have crossed up to where they hit
#   C       void path_bounds_r16(const struct rays16 *, int count, const struct bound *,
#                                const struct site *, int to_hits, struct path *,
#                                const vec_float4 *sums);
#   In      $3 RAYS16, consecutive, $4 count (at least 4), $5 their BOUNDs, $6 SITEs, whose rays
#           have the pixels of these, $7 -1 if the rays end at their t, 0 if where the bound ends,
#           $8 where the PATHs go, also where the bounds are, $9 the sum of the tile's first pixel;
#           pointers 16-aligned
#   Out     the PATHs, consecutive
#   Uses    $3-$6, $8, $10-$45   Saves  -   Stack  0   Calls  -
#   Domain  bounds as bound_fan_r16 or bound_origins_r16 makes them; t at least 0, below 0 in a lane
#           without a ray
#   Error   0
#   Twin    lab/twins/src/paths.rs

        .include "work_unit.inc"
        .include "macros.inc"
        .include "extremes.inc"

        .set    NEXT,3
        registers a_rays,count,a_bound,a_site,to_hits,a_path,sums
        # constants
        .set    NEXT,10
        registers m_apex,m_axis,m_ends,m_subtiles,k_rows,k_one,m_splat,base,c_to_hits,rays_step
        # a packet
        registers site,t0,t1,t2,t3,p0,p1,p2,p3,x0,x1,x2,x3,y0,y1,y2,y3
        registers apex,axis,limits,cosine,farthest,out

        quadword_constants
        # words of two quadwords A and B
apex_radius:
        .int    0x00010203,0x04050607,0x08090a0b,0x14151617 # A0 A1 A2 B1
axis_cosine:
        .int    0x00010203,0x04050607,0x08090a0b,0x10111213 # A0 A1 A2 B0
sine_farthest:
        .int    0x00010203,0x10111213,0x80808080,0x80808080 # A0 B0 0 0
with_subtiles:
        .int    0x00010203,0x04050607,0x10111213,0x80808080 # A0 A1 B0 0

function path_bounds_r16
        lqa     $m_apex,apex_radius
        lqa     $m_axis,axis_cosine
        lqa     $m_ends,sine_farthest
        lqa     $m_subtiles,with_subtiles
        splat_mask $m_splat
        il      $k_rows,0x18
        il      $k_one,1
        splat   $base,$sums,$m_splat
        splat   $c_to_hits,$to_hits,$m_splat
        il      $rays_step,RAYS16_SIZE
next_packet:
        lqd     $site,0($a_site)
        rotqbyi $site,$site,SITE_rays
    .irp row, 0,1,2,3
        lqd     $t\row,RAYS16_t+16*\row($a_rays)
        lqd     $p\row,RAYS16_pixel+16*\row($site)
    .endr
        # A subtile's number is its row times eight and its column; a row of sums has 1024 bytes. A
        # lane without a ray adds some subtile, which is traced again more often than it must be.
    .irp row, 0,1,2,3
        sf      $p\row,$base,$p\row
        rotmi   $x\row,$p\row,-7
        rotmi   $y\row,$p\row,-9
        selb    $x\row,$x\row,$y\row,$k_rows
        rot     $x\row,$k_one,$x\row                    # by the last five bits
    .endr
        or      $x0,$x0,$x1
        or      $x2,$x2,$x3
        or      $x0,$x0,$x2
        orx     $x0,$x0
        maximum $t0,$t1,$y0
        maximum $t2,$t3,$y2
        maximum $t0,$t2,$y1
        rotqbyi $t1,$t0,8
        maximum $t0,$t1,$y3
        rotqbyi $t1,$t0,4
        maximum $t0,$t1,$y1
        lqd     $apex,BOUND_apex($a_bound)
        lqd     $axis,BOUND_axis($a_bound)
        lqd     $limits,BOUND_limits($a_bound)
        lqd     $cosine,BOUND_cosine($a_bound)
        lqd     $farthest,BOUND_farthest($a_bound)
        selb    $farthest,$farthest,$t0,$c_to_hits
        shufb   $apex,$apex,$limits,$m_apex
        shufb   $axis,$axis,$cosine,$m_axis
        shufb   $out,$limits,$farthest,$m_ends
        shufb   $out,$out,$x0,$m_subtiles
        stqd    $apex,0($a_path)
        stqd    $axis,16($a_path)
        stqd    $out,32($a_path)
        ai      $a_site,$a_site,SITE_SIZE
        a       $a_rays,$a_rays,$rays_step
        ai      $a_bound,$a_bound,BOUND_SIZE
        ai      $a_path,$a_path,PATH_SIZE
        ai      $count,$count,-1
        brnz    $count,next_packet                      # at least 4 passes
        bi      $lr
endfunction path_bounds_r16
