# cuts_shades_r16   takes the shadow rays of which it is known whether the ground blocks them out
#   C       vec_uint4 cuts_shades_r16(struct rays16 *, int count, const struct shades *,
#                                     const vec_uint4 *blocks, const vec_int4 *first,
#                                     unsigned ground);
#   In      $3 rays to the light, consecutive; $4 packets (at least 1); $5 numbers of the shadows;
#           $6 SHADE_BLOCKS by SHADE_BLOCKS blocks: bits of lit cells in two words, and the bounds
#           of the shadow, of which the upper one ends with how many lines before this block
#           ground may be high enough; $7 the level, the first line of the blocks, the first lane,
#           and the length of a ray from line to line; $8 the ground's OBJECT; pointers 16-aligned
#   Out     t: SHADE_LIT for rays that reach the light, -1 for those that the ground blocks; object:
#           the ground for these; for other rays in the field, t is how far they may be blocked
#           $3 not 0 if other rays are left
#   Uses    $3-$50   Saves  -   Stack  0   Calls  -
#   Domain  any; rays in cells of other blocks get those of one that is there
#   Error   0
#   Twin    lab/twins/src/shades.rs

        .include "work_unit.inc"
        .include "macros.inc"
        .include "transpose.inc"
        .include "height.inc"
        .include "shades.inc"

        .set    NEXT,3
        registers a_row,rows,a_shades,a_blocks,a_first,ground
        registers line_x,line_0,line_z,line_last,place_x,place_0,place_z,place_last,slant,shift
        registers fall,base,zero,k_no_ray,k_lit,level,first_line,first_lane,length,any,m_first,m_last
        registers line,lane,outside,x,z,t,one,two,height,known,endless
        registers cell                                  # to cell+3: bits, bits, bounds
        .set    NEXT,cell+4
        registers turned                                # to turned+3
        .set    NEXT,turned+4

        transpose_table .rodata.cuts

function cuts_shades_r16
        load_shades line_x,line_0,line_z,line_last,place_x,place_0,place_z,place_last,slant,shift
        load_shades fall,base
        splat_mask $one
        lqd     $level,0($a_first)
        rotqbyi $first_line,$level,4
        rotqbyi $first_lane,$level,8
        rotqbyi $length,$level,12
        splat   $level,$level,$one
        splat   $first_line,$first_line,$one
        splat   $first_lane,$first_lane,$one
        splat   $length,$length,$one
        splat   $ground,$ground,$one
        sfi     $level,$level,0
        lqa     $m_first,transpose_first
        lqa     $m_last,transpose_last
        ilhu    $k_no_ray,0xbf80                        # -1
        ilhu    $k_lit,SHADE_LIT>>16
        shli    $rows,$rows,2
        sfi     $rows,$rows,0
        il      $zero,0
        il      $any,0
next_row:
        shade_places $line,$lane,$outside,$x,$z,$t,$one
        lqd     $height,RAYS16_origin_y($a_row)
        fma     $height,$line,$fall,$height
        fa      $height,$height,$base
        cflts   $line,$line,0
        cflts   $lane,$lane,0
        rotm    $line,$line,$level
        rotm    $lane,$lane,$level
        sf      $line,$first_line,$line
        sf      $lane,$first_lane,$lane
        andi    $x,$line,(SHADE_BLOCKS-1)<<SHADE_SIDE_LOG2
        andi    $z,$lane,(SHADE_BLOCKS-1)<<SHADE_SIDE_LOG2
        shli    $x,$x,4+SHADE_BLOCKS_LOG2-SHADE_SIDE_LOG2
        shli    $z,$z,4-SHADE_SIDE_LOG2
        or      $x,$x,$z
        lqx     $cell,$a_blocks,$x
    .irp nth, 1,2,3
        rotqbyi $z,$x,4*\nth
        lqx     $cell+\nth,$a_blocks,$z
    .endr
        transpose cell,cell,turned,$m_first,$m_last
        andi    $line,$line,7
        andi    $lane,$lane,7
        # How far before the ray ground may be high enough.
        andi    $x,$cell+3,SHADE_ENDLESS
        ceqi    $endless,$x,SHADE_ENDLESS
        a       $x,$x,$line
        csflt   $x,$x,0
        fma     $x,$x,$length,$length
        cgti    $one,$line,3
        selb    $cell,$cell,$cell+1,$one
        andi    $line,$line,3
        shli    $line,$line,SHADE_SIDE_LOG2
        or      $line,$line,$lane
        shl     $cell,$cell,$line
        rotmai  $cell,$cell,-31                         # lit
        fcgt    $one,$height,$cell+3
        or      $cell,$cell,$one
        fcgt    $one,$cell+2,$height
        andc    $one,$one,$cell                         # dark
        or      $known,$cell,$one
        andc    $known,$known,$outside
        and     $one,$one,$known
        or      $endless,$endless,$outside
        selb    $t,$x,$t,$endless
        lqd     $two,RAYS16_object($a_row)
        selb    $two,$two,$ground,$one
        stqd    $two,RAYS16_object($a_row)
        selb    $t,$t,$k_lit,$known
        selb    $t,$t,$k_no_ray,$one
        stqd    $t,RAYS16_t($a_row)
        rotmai  $t,$t,-31
        orc     $any,$any,$t
        next_shade_row $one,$two
        brnz    $rows,next_row
        orx     $3,$any
        bi      $lr
endfunction cuts_shades_r16
