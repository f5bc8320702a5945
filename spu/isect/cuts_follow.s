# cuts_follow   follows four cuts over the ground, and finds where their rays hit it
#   C       void cuts_follow(const struct cuts *, struct cut4 *, int column,
#                            const vec_uint4 *cells);
#   In      $3 cuts and rows; $4 of four cuts their distances, and the rows whose rays are next, -1
#           if none is left; $5 the tile's column of the first cut; $6 CELLS by CELLS heights, and
#           the colours after them; pointers 16-aligned
#   Out     $4 where the cuts are now, FARTHEST if they have left the ground
#           pixels of rays that have hit: distance, slopes along x and z, colour of three times ten
#           bits
#   Uses    $3-$79   Saves  -   Stack  0   Calls  -
#   Domain  directions of cuts not 0, and den above 0; a ground of less than MOST_CELLS squares
#           along a cut
#   Error   1 of a square, from its own patches cut by the plane
#   Twin    lab/twins/src/cuts.rs
#
# A cut is a vertical plane through the eye. Distances are along the horizontal axis of the view, so
# a point at distance s is at the eye + s (ahead + tangent aside), and a ray of slope v is at the
# height s v. A pass takes each cut on to the side where it leaves its square, unless the ground
# between there and the side before is in the next ray's way. Then that ray's pixel is made first,
# and the pass is repeated with the row above.

        .include "work_unit.inc"
        .include "macros.inc"
        .include "extremes.inc"
        .include "reciprocal.inc"
        .include "transpose.inc"
        .include "height.inc"

        .set    MOST_CELLS,4096

        .set    NEXT,3
        registers a_cuts,a_state,column,a_cells
        registers m_first,m_last,zero,k_one,a_colours,a_rows
        # of the cuts
        registers along_x,along_z,per_x,per_z,origin_x,origin_z,step_x,step_z,plus_x,plus_z
        registers num_at,den_at,across,limit,out,state,row,active,left
        registers num,den,pixel,nowhere,next_pixel
        # the square
        registers s0,y0,s1,y1,g,i_x,i_z,c_x,cell_x,cell_z,places
        registers h                                     # to h+3
        .set    NEXT,h+4
        registers f_x,f_z,hit,one,two
        registers quad                                  # to quad+3
        .set    NEXT,quad+4
        registers t                                     # to t+3, for transposes
        .set    NEXT,t+4
        registers s,slope_x,slope_z,colour              # a pixel's quadword
        registers place,part
        .set    part0,place
        .set    lanes_of,colour
        .set    inverse,hit
    .if NEXT > 80
        .error  "too many registers"
    .endif

        transpose_table .rodata.cuts
lanes:  .int    0,1,2,3

.macro  number name:req, out:req
        lqd     \out,CUTS_\name($a_cuts)
.endm

# Four quadwords at places from an address on.
.macro  load_four out:req, address:req, places:req
        lqx     $\out,\address,\places
    .irp lane, 1,2,3
        rotqbyi $\out+\lane,\places,4*\lane
        lqx     $\out+\lane,\address,$\out+\lane
    .endr
.endm

# Where the cells of squares are.
.macro  places_of out:req, x:req, z:req, t:req
        andi    \out,\x,CELLS-1
        andi    \t,\z,CELLS-1
        shli    \out,\out,4
        shli    \t,\t,4+CELLS_LOG2
        or      \out,\out,\t
.endm

# Between four corners.
.macro  bilinear out:req, corners:req, t0:req, t1:req
        fs      \t0,$\corners+1,$\corners
        fs      \t1,$\corners+3,$\corners+2
        fma     \t0,$f_x,\t0,$\corners
        fma     \t1,$f_x,\t1,$\corners+2
        fs      \t1,\t1,\t0
        fma     \out,$f_z,\t1,\t0
.endm

# Between two numbers.
.macro  between out:req, from:req, to:req, part:req
        fs      \out,\to,\from
        fma     \out,\part,\out,\from
.endm

# Where a distance is in the square.
.macro  within distance:req
        fma     $f_x,\distance,$along_x,$origin_x
        fma     $f_z,\distance,$along_z,$origin_z
        fs      $f_x,$f_x,$i_x
        fs      $f_z,$f_z,$i_z
.endm

# The heights of the square's corners.
.macro  square
        cflts   $cell_x,$i_x,0
        cflts   $cell_z,$i_z,0
        places_of $places,$cell_x,$cell_z,$one
        load_four quad,$a_cells,$places
        transpose h,quad,t,$m_first,$m_last
.endm

# How far the ground at the end of the square is above the next ray, times den.
.macro  above_ray
        fm      $one,$s1,$num
        fms     $g,$y1,$den,$one
.endm

# Which cuts' rays the ground is in the way of.
.macro  hits
        fcgt    $hit,$g,$zero
        and     $hit,$hit,$active
        orx     $one,$hit
.endm

# Where the cut leaves the square.
.macro  end_of_square
        fa      $one,$i_x,$plus_x
        fa      $two,$i_z,$plus_z
        fs      $one,$one,$origin_x
        fs      $two,$two,$origin_z
        fm      $one,$one,$per_x
        fm      $two,$two,$per_z
        fcgt    $c_x,$two,$one
        selb    $s1,$two,$one,$c_x
        within  $s1
        bilinear $y1,h,$one,$two
        above_ray
.endm

# The next rays of the cuts.
.macro  next_rays
        shli    $one,$row,4
        andi    $one,$one,16*(TILE_HEIGHT-1)
        load_four quad,$a_rows,$one
        transpose quad,quad,t,$m_first,$m_last
        fa      $num,$num_at,$quad
        fa      $den,$den_at,$quad+1
        shli    $one,$across,4
        a       $next_pixel,$one,$quad+2
        a       $one,$across,$quad+3
        clgti   $one,$one,TILE_WIDTH-1
        selb    $next_pixel,$next_pixel,$nowhere,$one
.endm

# The corners' numbers, in two of four quadwords: the first and third words, and so on.
.macro  words_of_four first:req, second:req, words:req
    .ifc \words,02
        shufb   $t,$quad,$quad+2,$m_first
        shufb   $t+1,$quad+1,$quad+3,$m_first
        shufb   $t+2,$quad,$quad+2,$m_last
        shufb   $t+3,$quad+1,$quad+3,$m_last
        shufb   \first,$t,$t+1,$m_first
        shufb   \second,$t+2,$t+3,$m_first
    .endif
    .ifc \words,13
        shufb   $t,$quad,$quad+2,$m_first
        shufb   $t+1,$quad+1,$quad+3,$m_first
        shufb   $t+2,$quad,$quad+2,$m_last
        shufb   $t+3,$quad+1,$quad+3,$m_last
        shufb   \first,$t,$t+1,$m_last
        shufb   \second,$t+2,$t+3,$m_last
    .endif
    .ifc \words,01
        shufb   $t,$quad,$quad+2,$m_first
        shufb   $t+1,$quad+1,$quad+3,$m_first
        shufb   \first,$t,$t+1,$m_first
        shufb   \second,$t,$t+1,$m_last
    .endif
    .ifc \words,23
        shufb   $t,$quad,$quad+2,$m_last
        shufb   $t+1,$quad+1,$quad+3,$m_last
        shufb   \first,$t,$t+1,$m_first
        shufb   \second,$t,$t+1,$m_last
    .endif
.endm

# The square beside it, or the same at the ground's edge.
.macro  beside x:req, z:req, axis:req, way:req
    .if \way < 0
        cgti    $two,$cell_\axis,0
        a       $place,$cell_\axis,$two
    .else
        number  end_\axis,$one
        cflts   $one,$one,0
        ai      $place,$cell_\axis,1
        cgt     $two,$one,$place
        selb    $place,$cell_\axis,$place,$two
    .endif
        places_of $one,\x,\z,$two
        load_four quad,$a_cells,$one
.endm

# The slope of the ground there, along one axis.
.macro  slope out:req, axis:req, other:req, low_words:req, high_words:req
    .ifc \axis,x
        beside  $place,$cell_z,x,-1
    .else
        beside  $cell_x,$place,z,-1
    .endif
        words_of_four $one,$two,\low_words
        between \out,$one,$two,$f_\other
    .ifc \axis,x
        between $one,$h,$h+2,$f_z
        between $two,$h+1,$h+3,$f_z
    .else
        between $one,$h,$h+1,$f_x
        between $two,$h+2,$h+3,$f_x
    .endif
        fs      \out,$two,\out
        ori     $part,$one,0
    .ifc \axis,x
        beside  $place,$cell_z,x,1
    .else
        beside  $cell_x,$place,z,1
    .endif
        words_of_four $one,$two,\high_words
        between $place,$one,$two,$f_\other
        fs      $place,$place,$part
        fs      $place,$place,\out
        fma     \out,$f_\axis,$place,\out
.endm

# A part of the colour.
.macro  channel out:req, mask:req, scale:req
    .irp corner, 0,1,2,3
        and     $t+\corner,$quad+\corner,\mask
    .endr
    .irp corner, 0,1,2,3
        cuflt   $t+\corner,$t+\corner,\scale
    .endr
        bilinear \out,t,$one,$two
        cfltu   \out,\out,\scale
        and     \out,\out,\mask
.endm

function cuts_follow
        lqa     $m_first,transpose_first
        lqa     $m_last,transpose_last
        splat_mask $one
        ilhu    $k_one,0x3f80
        il      $zero,0
        il      $left,MOST_CELLS
        il      $t,CELLS_BYTES
        a       $a_colours,$a_cells,$t
        il      $t,CUTS_rows
        a       $a_rows,$a_cuts,$t
        lqd     $state,0($a_state)
        lqd     $row,16($a_state)
        lqa     $lanes_of,lanes
        splat   $across,$column,$one
        a       $across,$across,$lanes_of
        csflt   $quad,$across,0
    .irp name, lat,den_m,den,num
        .ifc \name,den_m
        number  den_x,$one
        .else
        number  \name\()_x,$one
        .endif
        number  \name,$two
        .ifc \name,lat
        fma     $s,$quad,$one,$two
        .endif
        .ifc \name,den_m
        fma     $s0,$quad,$one,$two
        .endif
        .ifc \name,den
        fma     $den_at,$quad,$one,$two
        .endif
        .ifc \name,num
        fma     $num_at,$quad,$one,$two
        .endif
    .endr
        reciprocal_f4 $inverse,$s0,$t,$t+1,$k_one
        fm      $s,$s,$inverse                          # the tangent
        number  per_side,$t+2
        load_constant $t+3,0x2b800000                   # 2^-40
    .irp axis, x,z
        number  aside_\axis,$one
        number  ahead_\axis,$two
        fma     $along_\axis,$s,$one,$two
        fm      $along_\axis,$along_\axis,$t+2
        fcmgt   $one,$t+3,$along_\axis
        selb    $along_\axis,$along_\axis,$t+3,$one
        reciprocal_f4 $per_\axis,$along_\axis,$t,$t+1,$k_one
        number  origin_\axis,$origin_\axis
        fcgt    $one,$along_\axis,$zero
        and     $plus_\axis,$one,$k_one
        fa      $step_\axis,$plus_\axis,$plus_\axis
        fs      $step_\axis,$step_\axis,$k_one
        # Where it leaves the ground.
        number  end_\axis,$two
        and     $two,$two,$one
        fs      $two,$two,$origin_\axis
        .ifc \axis,x
        fm      $out,$two,$per_x
        .else
        fm      $two,$two,$per_z
        minimum_f4 $out,$two,$one
        .endif
    .endr
        number  limit,$limit
        number  nowhere,$nowhere
        cgti    $active,$row,-1
        fcgt    $one,$limit,$state
        and     $active,$active,$one
        fcgt    $one,$out,$state
        and     $active,$active,$one
        ori     $s0,$state,0
        # The square where each cut is.
    .irp axis, x,z
        number  end_\axis,$two
        fs      $two,$two,$k_one
        fma     $i_\axis,$s0,$along_\axis,$origin_\axis
        maximum $i_\axis,$zero,$one
        minimum_f4 $i_\axis,$two,$one
        cflts   $i_\axis,$i_\axis,0
        csflt   $i_\axis,$i_\axis,0
    .endr
        next_rays
        ori     $pixel,$next_pixel,0
        square
        within  $s0
        bilinear $y0,h,$one,$two
        end_of_square
        hits
        brnz    $one,pixels
next_square:
        orx     $one,$active
        brz     $one,done
        ori     $s0,$s1,0
        ori     $y0,$y1,0
        selb    $state,$state,$s1,$active
        and     $one,$step_x,$c_x
        andc    $two,$step_z,$c_x
        fa      $i_x,$i_x,$one
        fa      $i_z,$i_z,$two
        fcgt    $one,$limit,$s1
        fcgt    $two,$out,$s1
        and     $active,$active,$one
        and     $active,$active,$two
        ai      $left,$left,-1
        brz     $left,done
        square
        end_of_square
        hits
        # Often a pixel is next, to which no branch leads.
        brz     $one,next_square
pixels:
        ceq     $one,$pixel,$nowhere
        # Where the ray meets the line from the one side to the other.
        fm      $s,$s0,$num
        fms     $s,$y0,$den,$s
        minimum_f4 $s,$zero,$two
        fs      $two,$s,$g
        reciprocal_f4 $part0,$two,$t,$t+1,$k_one
        fm      $s,$s,$part0
        fs      $two,$s1,$s0
        fma     $s,$s,$two,$s0
        selb    $state,$state,$s,$hit
        andc    $part,$hit,$one
        orx     $part,$part
        # The next rays are those of the rows above.
        a       $row,$row,$hit
        cgti    $one,$row,-1
        and     $active,$active,$one
        next_rays
        above_ray
        brz     $part,row_done
        within  $s
        slope   $slope_x,x,z,02,13
        slope   $slope_z,z,x,01,23
        number  slope,$one
        fm      $slope_x,$slope_x,$one
        fm      $slope_z,$slope_z,$one
        load_four quad,$a_colours,$places
        transpose quad,quad,t,$m_first,$m_last
        ilhu    $place,0xffc0
        channel $colour,$place,22
        rotmi   $place,$place,-10
        channel $part,$place,12
        or      $colour,$colour,$part
        rotmi   $place,$place,-10
        channel $part,$place,2
        or      $colour,$colour,$part
        transpose quad,s,t,$m_first,$m_last
        selb    $one,$nowhere,$pixel,$hit
        stqd    $quad,0($one)
    .irp lane, 1,2,3
        rotqbyi $two,$one,4*\lane
        stqd    $quad+\lane,0($two)
    .endr
row_done:
        ori     $pixel,$next_pixel,0
        hits
        brnz    $one,pixels
        br      next_square

done:   fcgt    $one,$out,$state
        ilhu    $two,FARTHEST>>16
        selb    $state,$two,$state,$one
        stqd    $state,0($a_state)
        stqd    $row,16($a_state)
        bi      $lr
endfunction cuts_follow
