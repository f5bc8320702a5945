# isect_cone_pairs_r16   nearest hit of packets' rays with open cones, candidate by candidate
#   C       void isect_cone_pairs_r16(const struct candidate *, int count);
#   In      $3 candidates of objects that are cones, $4 count (0 is none); pointers 16-aligned
#   Out     the candidates' packets: t, object, where a hit has 0 < t < what was there
#   Uses    $3-$4, $10-$79   Saves  -   Stack  0   Calls  -
#   Domain  |d| and |axis| = 1 within 4 ulp; distances, height and radius from 2^-30 to 2^30;
#           radius and height not below 0; radii of the body, by growth, not below 0
#   Error   250 ulp of the sum of the distance from the base, the height and the largest radius,
#           where t changes by less than 10 times what the surface is moved by; farther than
#           1e-4 radii and 2e-6 of that sum from outlines, ends and surface, hits are right,
#           but in cones so thin as 1/200 of their height that taper to almost nothing, where
#           one seed in some thirty has shown a hit lost inside
#   Twin    lab/twins/src/cone.rs
#
# Let w be the vector from the base to the ray's point that is nearest to the base. It has the
# component h along the axis and c across it. The direction has the components rise and e. The
# body's radius at that height is k, and it grows along the ray by m. The ray crosses the body, or
# its mirror image beyond the apex, at the roots of
# |c + s e|^2 = (k + m s)^2, whose halved coefficients are
#   a = |e|^2 - m^2
#   b = c.e - k m
#   out = |c|^2 - k^2
#   disc = |k e - m c|^2 - |c x e|^2
# The last equals b^2 - a out, but loses digits only at the outline and near the apex. If the root
# gets the sign of b, q = b + root does not cancel, and the crossings are at s = -q/a and s =
# -out/q. The crossing at -q/a enters the body if b is not below 0, and otherwise leaves it. The
# other crossing does the opposite. This also holds for a below 0. If the direction is parallel to
# the axis of a cylinder, disc would be 0. It is made slightly smaller, so that there is no hit.
#
# Crossings outside the heights or seen from the wrong side get a negative sign, and so do not
# count. As unsigned integers they are larger than the others, and the smaller number is the nearer
# crossing.
#
# A pass is one row of four rays, a quarter of a candidate. All four rows in one pass would leave
# too few registers for passes to overlap (386 cycles instead of 4 times 91) and have four times as
# much code. The odd pipe has free cycles to load the record again. A load ignores the lowest bits
# of an address, so the list pointer advances by quarters of an entry: all four load the same
# candidate, and the low bits select the row.

        .include "work_unit.inc"
        .include "macros.inc"
        .include "pairs.inc"

        .set    NEXT,3
        registers a_candidate,count
        # constants
        .set    NEXT,10
        registers m_x,m_y,m_z,k_half,k_one,k_tiny,m_sign,a_controls,a_if_enters,a_if_leaves
        # the candidate
        registers object
        registers a_packet                              # its row
        registers quad,base_x,base_y,base_z,axis_x,axis_y,axis_z,radius,growth,height,sides
        registers if_enters                             # the sign bit where entries do not count
        registers if_leaves                             # the sign bit where exits do not count
        # a row
        registers x                                     # direction
        registers y,z,wx,wy,wz
        registers near                                  # t of the ray's point nearest to the base
        registers h,rise,cx,cy,cz,ex,ey,ez,k,m,a,b,out
        registers turn_x                                # c x e
        registers turn_y,turn_z
        registers vx                                    # k e - m c
        registers vy,vz
        registers outside                               # disc
        .set    NEXT,61
        registers disc
        registers t_y,s,t_e,q,inverse,first,second,t,t_second,off,off_second,hidden,hidden_second
        registers ahead,t_best,nearest,control,inverse_q
        .set    row,43                                  # reused

        sign_controls_table

# Indexed by SIDES_BOTH, SIDES_EXIT and both.
hidden_if_enters:
    .irp value, 0,0,0x80000000,0
        .int    \value,\value,\value,\value
    .endr
hidden_if_leaves:
    .irp value, 0x80000000,0,0,0
        .int    \value,\value,\value,\value
    .endr

# dot = a . b, where the registers' names are a and b followed by x, y and z.
.macro  dot_f4 dot:req, a:req, b
        fm      \dot,$\a\()x,$\b\()x
        fma     \dot,$\a\()y,$\b\()y,\dot
        fma     \dot,$\a\()z,$\b\()z,\dot
.endm

function isect_cone_pairs_r16
        biz     $count,$lr
        splat_words
        ilhu    $k_half,0x3f00
        ilhu    $k_one,0x3f80
        ilhu    $k_tiny,0x0080
        ilhu    $m_sign,0x8000
        ila     $a_controls,sign_controls
        ila     $a_if_enters,hidden_if_enters
        ila     $a_if_leaves,hidden_if_leaves
        shli    $count,$count,2
next_row:
        load_candidate
        shli    $row,$a_candidate,2
        andi    $row,$row,0x30
        a       $a_packet,$a_packet,$row
        lqd     $sides,OBJECT_sides&~15($object)
        rotqbyi $sides,$sides,OBJECT_sides&15
        rotmi   $sides,$sides,-26                       # the two bits to quadwords' addresses
        shufb   $object,$object,$object,$m_x
        lqd     $quad,OBJECT_centre($object)
        shufb   $base_x,$quad,$quad,$m_x
        shufb   $base_y,$quad,$quad,$m_y
        shufb   $base_z,$quad,$quad,$m_z
        lqd     $quad,OBJECT_axis($object)
        shufb   $axis_x,$quad,$quad,$m_x
        shufb   $axis_y,$quad,$quad,$m_y
        shufb   $axis_z,$quad,$quad,$m_z
        lqd     $quad,CONE_radius($object)
        shufb   $radius,$quad,$quad,$m_x
        shufb   $growth,$quad,$quad,$m_y
        shufb   $height,$quad,$quad,$m_z
    .irp axis, x,y,z
        lqd     $w\axis,RAYS16_origin_\axis($a_packet)
        lqd     $\axis,RAYS16_direction_\axis($a_packet)
        fs      $w\axis,$base_\axis,$w\axis
    .endr
        fm      $near,$wx,$x
        fma     $near,$wy,$y,$near
        fma     $near,$wz,$z,$near
    .irp axis, x,y,z
        fms     $w\axis,$near,$\axis,$w\axis
    .endr
        dot_f4  $h,axis_,w
        dot_f4  $rise,axis_,
    .irp axis, x,y,z
        fnms    $c\axis,$h,$axis_\axis,$w\axis
        fnms    $e\axis,$rise,$axis_\axis,$\axis
    .endr
        fma     $k,$growth,$h,$radius
        fm      $m,$growth,$rise
        dot_f4  $a,e,e
        fnms    $a,$m,$m,$a
        dot_f4  $b,c,e
        fnms    $b,$k,$m,$b
        dot_f4  $out,c,c
        fnms    $out,$k,$k,$out
        fm      $turn_x,$cz,$ey
        fm      $turn_y,$cx,$ez
        fm      $turn_z,$cy,$ex
        fms     $turn_x,$cy,$ez,$turn_x
        fms     $turn_y,$cz,$ex,$turn_y
        fms     $turn_z,$cx,$ey,$turn_z
    .irp axis, x,y,z
        fm      $v\axis,$m,$c\axis
        fms     $v\axis,$k,$e\axis,$v\axis
    .endr
        fms     $disc,$vx,$vx,$k_tiny
        fma     $disc,$vy,$vy,$disc
        fma     $disc,$vz,$vz,$disc
    .irp axis, x,y,z
        fnms    $disc,$turn_\axis,$turn_\axis,$disc
    .endr
        frsqest $t_y,$disc
        fi      $t_y,$disc,$t_y
        fm      $s,$disc,$t_y
        fnms    $t_e,$s,$t_y,$k_one                     # 1 - s y
        fma     $t_e,$t_e,$k_half,$k_one
        selb    $s,$s,$b,$m_sign
        fma     $q,$s,$t_e,$b
        reciprocal_f4 $inverse,$a,$t_y,$t_e,$k_one
        reciprocal_f4 $inverse_q,$q,$t_y,$t_e,$k_one
        fm      $first,$q,$inverse                      # -s
        fm      $second,$out,$inverse_q
        fs      $t,$near,$first
        fs      $t_second,$near,$second
        fnms    $off,$first,$rise,$h                    # the crossing's height
        fnms    $off_second,$second,$rise,$h
        clgt    $off,$off,$height                       # below 0 is above all
        clgt    $off_second,$off_second,$height
        lqx     $if_enters,$a_if_enters,$sides
        lqx     $if_leaves,$a_if_leaves,$sides
        selb    $hidden,$if_enters,$if_leaves,$b
        selb    $hidden_second,$if_leaves,$if_enters,$b
        or      $t,$t,$off
        or      $t,$t,$hidden
        or      $t_second,$t_second,$off_second
        or      $t_second,$t_second,$hidden_second
        clgt    $control,$t,$t_second
        selb    $t,$t,$t_second,$control
        cgti    $ahead,$t,0
        keep_nearer 0
        ai      $a_candidate,$a_candidate,CANDIDATE_SIZE/4
        ai      $count,$count,-1
        brnz    $count,next_row                         # at least 4 passes: a candidate has four rows
        bi      $lr
endfunction isect_cone_pairs_r16
