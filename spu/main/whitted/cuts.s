# The eye's rays over a height field, by cuts: before the batches of a tile are traced, its cuts are
# followed from where those of the tile below have come to. Their pixels' sums then have where rays
# hit the ground and what is there, until each ray's batch takes it.
#
# This file and its kernels are in local store only in frames with FEATURE_CUTS.

        .include "work_unit.inc"
        .include "macros.inc"
        .include "extremes.inc"
        .include "reciprocal.inc"
        .include "transpose.inc"
        .include "driver.inc"
        .include "whitted.inc"
        .include "height.inc"

        # The columns of cuts that a tile may have, in fours: COLUMNS_BEFORE are left of it.
        .set    COLUMNS_BEFORE,64
        .set    FOURS,(TILE_WIDTH+2*COLUMNS_BEFORE)/4
    .if FOURS != MAX_CUT_FOURS
        .error  "a tile has another number of cuts than a frame allows"
    .endif
        # The blocks that the cells have space for.
        .set    SLOTS,CELLS/CELL_SIDE*CELLS/CELL_SIDE
        .set    SLOT_LIST_BYTES,128
        # The most squares from one side of the cells that are needed to the other.
        .set    MOST_ACROSS,CELLS-CELL_SIDE
        # The queue's rays are elsewhere, and no batch has begun.
        .set    CUT_CELLS,BATCH_RAYS
        .set    CUT_SAMPLES,CUT_CELLS+2*CELLS_BYTES
        .set    CUT_LISTS,CUT_SAMPLES+SLOTS*CELL_SAMPLE_BYTES
        .set    CUT_STATES,CUT_LISTS+SLOTS*SLOT_LIST_BYTES
        .set    CUT_KEYS,CUT_STATES+FOURS*32
        .set    CUT_PARAMETERS,CUT_KEYS+SLOTS*16
        .set    CUT_LEVEL,CUT_PARAMETERS+CUTS_ALL
        .set    CUT_NOWHERE,CUT_LEVEL+LEVEL_SIZE          # pixels that are not in the tile
    .if CUT_NOWHERE+4*16 > ROOT_LISTS
        .error  "the cells reach into the trees' tops"
    .endif

        .section .data.cuts,"aw",@progbits
        .align  4
carried:                                # how far the cuts of the last tile have come
        .skip   FOURS*16+32
carried_tile:                           # its number
        .int    -1,-1,-1,-1
carried_low:                            # the first and the last of them, from COLUMNS_BEFORE on
        .skip   16
carried_high:
        .skip   16
along_x:                                # directions of the first and last cut of those at once
        .skip   16
along_z:
        .skip   16
lowest: .skip   16                                      # slopes of the lowest rays of these
restarts:                               # whether the tile's cuts begin at the eye
        .skip   16
kept_far:
        .skip   16
kept_distance:
        .skip   16
skipping:                               # whether the ground may still be too low for the rays
        .skip   16
        .global ground, ground_material
ground: .skip   OBJECT_SIZE
ground_material:
        .skip   MATERIAL_SIZE

        .section .rodata.cuts,"a",@progbits
        .align  4
four_rows:
        .int    0,1,2,3
        transpose_table .rodata.cuts

        .set    four,89                                 # of the current cuts
        .set    last_four,92                            # the first that is not current
        .set    first_four,109
        .set    end_four,110                            # the tile's last one
        .set    level,111
        .set    a_level,112
        .set    new_slots,113
        .set    slot,115
        .set    block_x,116
        .set    block_z,117
        .set    last_x,118
        .set    last_z,127
        .set    first_x,95

        .set    NEXT,10
        registers m_first,a_cuts,x_0,y_0,y_m
        registers lat,lat_x,lat_y,den,den_x,den_y,num,num_x,num_y
        registers quad,one,two,t_y,t_e,k_one,tilt,value,rows,shift
        registers row                                   # to row+3
        .set    NEXT,row+4
        registers words                                 # to words+3
        .set    NEXT,words+4
        registers low,high,a_from,m_last,m_table,drift,fits,left,far,near
    .if NEXT > 80
        .error  "too many registers"
    .endif

# The numbers of a quadword of the frame, in all lanes.
.macro  spread field:req, x:req, y:req, z:req
        lqa     $quad,frame+FRAME_\field
        splat   \x,$quad,$m_first
        rotqbyi $one,$quad,4
        splat   \y,$one,$m_first
        rotqbyi $one,$quad,8
        splat   \z,$one,$m_first
.endm

.macro  keep value:req, name:req
        stqd    \value,CUTS_\name($a_cuts)
.endm

# Four words at any multiple of four bytes.
.macro  load_any out:req, address:req
        lqd     \out,0(\address)
        lqd     $one,16(\address)
        andi    $two,\address,15
        shlqby  \out,\out,$two
        ai      $two,$two,-16
        rotqmby $one,$one,$two
        or      \out,\out,$one
.endm

# cuts_tile   finds where the rays of the current tile's pixels hit the ground
#   Out     PIXEL_SUMS: distance along the view's axis, slopes and colour, for each such ray
#   Uses    $3-$79, Whitted's driver registers
function cuts_tile
        enter
        splat_mask $m_first
        ila     $a_cuts,arena+CUT_PARAMETERS
        splat   $x_0,$g_tile_x,$m_first
        csflt   $x_0,$x_0,0
        splat   $y_0,$g_tile_y,$m_first
        csflt   $y_0,$y_0,0
        ilhu    $one,0x4100                             # 8: the middle row
        fa      $y_m,$y_0,$one
        spread  cut_lat,$lat,$lat_x,$lat_y
        fma     $lat,$x_0,$lat_x,$lat
        fma     $lat,$y_m,$lat_y,$lat
        keep    $lat,lat
        keep    $lat_x,lat_x
        spread  cut_den,$den,$den_x,$den_y
        fma     $den,$x_0,$den_x,$den
        keep    $den,den
        keep    $den_x,den_x
        fma     $den,$y_m,$den_y,$den
        keep    $den,den_m
        spread  cut_num,$num,$num_x,$num_y
        fma     $num,$x_0,$num_x,$num
        keep    $num,num
        keep    $num_x,num_x
        spread  cut_ahead,$one,$two,$t_y
        rotqbyi $t_e,$quad,12
        splat   $t_e,$t_e,$m_first
        splat   $one,$quad,$m_first
        keep    $one,ahead_x
        keep    $two,ahead_z
        keep    $t_y,aside_x
        keep    $t_e,aside_z
        ila     $one,arena+CUT_NOWHERE
        splat   $one,$one,$m_first
        lqa     $two,four_rows
        shli    $two,$two,4
        a       $one,$one,$two
        keep    $one,nowhere
        # How many pixels a cut is further right in the next row, in the tile's middle.
        ilhu    $k_one,0x3f80
        ilhu    $two,0x4200                             # 32
        fma     $lat,$two,$lat_x,$lat
        fma     $den,$two,$den_x,$den
        reciprocal_f4 $value,$den,$t_y,$t_e,$k_one
        fm      $value,$lat,$value
        fnms    $one,$value,$den_x,$lat_x
        fnms    $two,$value,$den_y,$lat_y
        reciprocal_f4 $value,$one,$t_y,$t_e,$k_one
        fm      $tilt,$two,$value
        ilhu    $one,0x8000
        xor     $tilt,$tilt,$one
        # The rows.
        lqa     $m_table,transpose_first
        lqa     $m_last,transpose_last
        lqa     $rows,four_rows
    .irp quarter, 0,1,2,3
        csflt   $value,$rows,0
        ilhu    $one,0x4100
        fs      $one,$value,$one
        ilhu    $two,0x4380                             # 256
        fm      $one,$one,$tilt
        fa      $one,$one,$two
        ilhu    $two,0x3f00
        fa      $one,$one,$two
        cflts   $shift,$one,0
        ai      $shift,$shift,-256
        csflt   $two,$shift,0
        fa      $value,$value,$y_0
        fm      $row,$value,$num_y
        fma     $row,$two,$num_x,$row
        fm      $row+1,$value,$den_y
        fma     $row+1,$two,$den_x,$row+1
        shli    $row+2,$rows,TILE_WIDTH_LOG2
        a       $row+2,$row+2,$shift
        shli    $row+2,$row+2,4
        ila     $one,arena+PIXEL_SUMS
        splat   $one,$one,$m_first
        a       $row+2,$row+2,$one
        ori     $row+3,$shift,0
        transpose row,row,words,$m_table,$m_last
    .irp lane, 0,1,2,3
        stqd    $row+\lane,CUTS_rows+64*\quarter+16*\lane($a_cuts)
    .endr
        ai      $rows,$rows,4
    .endr
        # The columns of the cuts that have pixels in the tile, and of those that the tiles above
        # it in the unit go on with.
        ilhu    $one,0x8000
        ilhu    $two,0x4100
        andc    $value,$tilt,$one
        fm      $value,$value,$two
        cflts   $value,$value,0
        ai      $value,$value,2
        sfi     $low,$value,COLUMNS_BEFORE
        ai      $high,$value,COLUMNS_BEFORE+TILE_WIDTH-1
        ilhu    $two,0x4180                             # 16: a tile's rows
        fm      $drift,$tilt,$two
        ilhu    $two,0x4380
        fa      $drift,$drift,$two
        cflts   $drift,$drift,0
        ai      $drift,$drift,-256                      # rounded down
        lqd     $one,UNIT_count($g_a_unit)
        sf      $one,$g_index,$one
        ai      $one,$one,-1
        mpy     $value,$one,$drift
        a       $one,$value,$one
        cgti    $two,$one,0
        and     $one,$one,$two
        a       $high,$high,$one
        cgti    $two,$value,0
        andc    $one,$value,$two
        a       $low,$low,$one
        cgti    $one,$low,0
        and     $low,$low,$one
        il      $two,4*FOURS-1
        minimum $high,$high,$two,$one
        rotmi   $first_four,$low,-2
        rotmi   $end_four,$high,-2
        ai      $end_four,$end_four,1
        # Whether the tile before is below this one, and has all of its cuts.
        lqa     $one,carried_tile
        lqa     $two,tile_number
        ilhu    $value,TILE_FLAGS>>16
        andc    $two,$two,$value
        a       $value,$two,$g_across
        ceq     $fits,$one,$value
        stqa    $two,carried_tile
        a       $value,$low,$drift
        lqa     $one,carried_low
        cgt     $one,$one,$value
        andc    $fits,$fits,$one
        a       $value,$high,$drift
        lqa     $one,carried_high
        cgt     $one,$one,$value
        and     $fits,$fits,$one
        splat   $fits,$fits,$m_first
        nor     $one,$fits,$fits
        stqa    $one,restarts
        stqa    $low,carried_low
        stqa    $high,carried_high
        # Each cut goes on where the two that are nearest to it in the tile below have come to.
        ai      $row,$g_tile_height,-1
        splat   $row,$row,$m_first
        ori     $left,$first_four,0
        splat   $low,$low,$m_first
        splat   $high,$high,$m_first
        shli    $shift,$first_four,2
        splat   $rows,$shift,$m_first
        lqa     $one,four_rows
        a       $rows,$rows,$one
        ila     $a_from,carried
        a       $value,$shift,$drift
        shli    $value,$value,2
        a       $a_from,$a_from,$value
        shli    $value,$shift,3
        ila     $a_cuts,arena+CUT_STATES
        a       $a_cuts,$a_cuts,$value
next_state:
        hbrr    last_state,next_state
        load_any $near,$a_from
        ai      $value,$a_from,4
        load_any $far,$value
        minimum_f4 $near,$far,$one
        and     $near,$near,$fits
        stqd    $near,0($a_cuts)
        cgt     $one,$low,$rows
        cgt     $two,$rows,$high
        or      $one,$one,$two
        or      $one,$row,$one                          # -1 in columns without a cut
        stqd    $one,16($a_cuts)
        ai      $rows,$rows,4
        ai      $a_from,$a_from,16
        ai      $a_cuts,$a_cuts,32
        ai      $left,$left,1
        ceq     $one,$left,$end_four
last_state:
        brz     $one,next_state
        # No block is there yet.
        il      $one,-1
        ila     $a_cuts,arena+CUT_KEYS
    .irp number, 0,1,2,3,4,5,6,7,8,9,10,11,12,13,14,15
        stqd    $one,16*\number($a_cuts)
    .endr
        ori     $four,$first_four,0
next_strip:
        ila     $one,frame
        load_word $one,FRAME_cut_fours,$one
        a       $last_four,$four,$one
        minimum $last_four,$last_four,$end_four,$one
        brsl    $lr,cuts_strip
        ori     $four,$last_four,0
        ceq     $3,$four,$end_four
        brz     $3,next_strip
        # The tile above goes on there.
        ori     $four,$first_four,0
        ila     $10,arena+CUT_STATES
        ila     $11,carried
        shli    $12,$four,4
        a       $11,$11,$12
        shli    $12,$four,5
        a       $10,$10,$12
next_carried:
        hbrr    last_carried,next_carried
        lqd     $12,0($10)
        stqd    $12,0($11)
        ai      $10,$10,32
        ai      $11,$11,16
        ai      $four,$four,1
        ceq     $12,$four,$end_four
last_carried:
        brz     $12,next_carried
        leave
endfunction cuts_tile

        .set    NEXT,10
        registers m_first,a_cuts,k_one,column,tangent,x,z,one,two,t_y,t_e,near,far,left,a_state
        registers a_field,side,per_side,above,reach,bits,depth,until,m_half
        registers origin_x,origin_z,at_x,at_z,low_x,high_x,low_z,high_z,c_wide,quad
        registers size,high,low,element,stride,rest,a_list,start,key,a_key,command,tag
        registers slopes,distance,m_pair
    .if NEXT > 80
        .error  "too many registers"
    .endif

# The smallest and largest of four numbers, as squares with a margin.
.macro  range low:req, high:req, of:req
        rotqbyi $one,\of,4
        ori     $two,\of,0
        minimum_f4 \of,$one,$t_y
        maximum $two,$one,$t_y
        rotqbyi $one,\of,8
        minimum_f4 \of,$one,$t_y
        rotqbyi $one,$two,8
        maximum $two,$one,$t_y
        cflts   \low,\of,0
        ai      \low,\low,-2
        cflts   \high,$two,0
        ai      \high,\high,2
.endm

# A number of the height field, in all lanes.
.macro  field_number out:req, offset:req
        lqd     \out,(\offset)&~15($a_field)
        rotqbyi \out,\out,(\offset)&15
        splat   \out,\out,$m_first
.endm

# cuts_strip   follows some of the tile's cuts
#   In      four, last_four
#   Uses    $3-$79, Whitted's driver registers, not four, last_four, first_four and end_four
function cuts_strip
        enter
        splat_mask $m_first
        ila     $a_cuts,arena+CUT_PARAMETERS
        ilhu    $k_one,0x3f80
        # The directions of the first and of the last cut, twice.
        shli    $one,$four,2
        ai      $one,$one,-COLUMNS_BEFORE
        splat   $one,$one,$m_first
        shli    $two,$last_four,2
        ai      $two,$two,-COLUMNS_BEFORE-1
        splat   $two,$two,$m_first
        fsmbi   $column,0x0f0f
        selb    $column,$one,$two,$column
        csflt   $column,$column,0
        lqd     $one,CUTS_den_x($a_cuts)
        lqd     $two,CUTS_den_m($a_cuts)
        fma     $one,$column,$one,$two
        reciprocal_f4 $tangent,$one,$t_y,$t_e,$k_one
        lqd     $one,CUTS_lat_x($a_cuts)
        lqd     $two,CUTS_lat($a_cuts)
        fma     $one,$column,$one,$two
        fm      $tangent,$one,$tangent
    .irp axis, x,z
        lqd     $one,CUTS_aside_\axis($a_cuts)
        lqd     $two,CUTS_ahead_\axis($a_cuts)
        fma     $one,$tangent,$one,$two
        stqa    $one,along_\axis
    .endr
        # The slopes of their lowest rays.
        ai      $one,$g_tile_height,-1
        shli    $one,$one,4
        a       $one,$one,$a_cuts
        lqd     $quad,CUTS_rows($one)
        splat   $x,$quad,$m_first
        rotqbyi $quad,$quad,4
        splat   $z,$quad,$m_first
        lqd     $one,CUTS_num_x($a_cuts)
        lqd     $two,CUTS_num($a_cuts)
        fma     $one,$column,$one,$two
        fa      $x,$x,$one
        lqd     $one,CUTS_den_x($a_cuts)
        lqd     $two,CUTS_den($a_cuts)
        fma     $one,$column,$one,$two
        fa      $z,$z,$one
        reciprocal_f4 $one,$z,$t_y,$t_e,$k_one
        fm      $one,$x,$one
        stqa    $one,lowest
        lqa     $one,restarts
        stqa    $one,skipping
next_depth:
        # The nearest cut that is not done.
        ilhu    $far,FARTHEST>>16
        ori     $near,$far,0
        ori     $left,$four,0
        shli    $one,$four,5
        ila     $a_state,arena+CUT_STATES
        a       $a_state,$a_state,$one
next_cut:
        hbrr    last_cut,next_cut
        lqd     $one,0($a_state)
        lqd     $two,16($a_state)
        cgti    $two,$two,-1
        selb    $one,$far,$one,$two
        minimum_f4 $near,$one,$two
        ai      $a_state,$a_state,32
        ai      $left,$left,1
        ceq     $one,$left,$last_four
last_cut:
        brz     $one,next_cut
    .irp turn, 4,8
        rotqbyi $one,$near,\turn
        minimum_f4 $near,$one,$two
    .endr
        fcgt    $one,$far,$near
        brz     $one,strip_done
        splat_mask $m_first
        ilhu    $k_one,0x3f80
        ila     $a_cuts,arena+CUT_PARAMETERS
        # The level there.
        ila     $a_field,field
        field_number $above,HEIGHTS_above
        fma     $reach,$near,$near,$above
        load_word $left,HEIGHTS_levels,$a_field
        ori     $a_level,$a_field,0
        il      $level,0
next_level:
        ai      $left,$left,-1
        brz     $left,level_found
        load_word $until,HEIGHTS_levels_of+HEIGHT_LEVEL_until,$a_level
        fcgt    $one,$until,$reach
        brnz    $one,level_found
        ai      $a_level,$a_level,HEIGHT_LEVEL_SIZE
        ai      $level,$level,1
        br      next_level
level_found:
        shli    $bits,$level,23
        splat   $bits,$bits,$m_first
        field_number $side,HEIGHTS_step
        reciprocal_f4 $per_side,$side,$t_y,$t_e,$k_one
        a       $side,$side,$bits
        sf      $per_side,$bits,$per_side
        stqd    $per_side,CUTS_per_side($a_cuts)
        ilhu    $one,0x3f00
        fm      $one,$per_side,$one
        stqd    $one,CUTS_slope($a_cuts)
        ila     $t_e,arena+CUT_LEVEL
        stqd    $side,LEVEL_side($t_e)
        stqd    $above,LEVEL_above($t_e)
        field_number $one,HEIGHTS_step+4
        stqd    $one,LEVEL_unit($t_e)
        lqd     $quad,HEIGHTS_levels_of+(HEIGHT_LEVEL_fades_from&~15)($a_level)
        splat   $one,$quad,$m_first
        stqd    $one,LEVEL_from($t_e)
        rotqbyi $one,$quad,4
        splat   $one,$one,$m_first
        stqd    $one,LEVEL_fade($t_e)
        field_number $one,HEIGHTS_corner+4
        stqd    $one,LEVEL_corner_y($t_e)
    .set    axis_at,0
    .irp axis, x,z
        field_number $one,HEIGHTS_corner+axis_at
        stqd    $one,LEVEL_corner_\axis($t_e)
        fm      $one,$one,$per_side
        ilhu    $two,0x8000
        xor     $origin_\axis,$one,$two
        stqd    $origin_\axis,CUTS_origin_\axis($a_cuts)
        field_number $one,HEIGHTS_last+axis_at
        sf      $one,$bits,$one
        stqd    $one,CUTS_end_\axis($a_cuts)
    .set    axis_at,8
    .endr
        # As far as the cells suffice.
        lqa     $x,along_x
        lqa     $z,along_z
        fm      $x,$x,$per_side
        fm      $z,$z,$per_side
        ilhu    $depth,0x4180                           # 16
        il      $left,8
less:   fma     $far,$depth,$side,$near
        fsmbi   $m_half,0x00ff
        selb    $distance,$near,$far,$m_half
        fma     $at_x,$distance,$x,$origin_x
        fma     $at_z,$distance,$z,$origin_z
        range   $low_x,$high_x,$at_x
        range   $low_z,$high_z,$at_z
        sf      $one,$low_x,$high_x
        sf      $two,$low_z,$high_z
        cgti    $one,$one,MOST_ACROSS
        cgti    $two,$two,MOST_ACROSS
        or      $c_wide,$one,$two
        ilhu    $one,0x3f40                             # 3/4
        fm      $depth,$depth,$one
        ai      $left,$left,-1
        brz     $left,deep
        brnz    $c_wide,less
deep:   stqd    $far,CUTS_limit($a_cuts)
        # The blocks between there.
        load_word $last_x,HEIGHTS_levels_of+HEIGHT_LEVEL_across,$a_level
        load_word $last_z,HEIGHTS_levels_of+HEIGHT_LEVEL_down,$a_level
        lqa     $one,skipping
        brnz    $one,skip
not_skipped:
        rotmi   $last_z,$last_z,-1
    .irp axis, x,z
        ai      $last_\axis,$last_\axis,-1
        rotmai  $high_\axis,$high_\axis,-3
        minimum $last_\axis,$last_\axis,$high_\axis,$one
        rotmai  $low_\axis,$low_\axis,-3
        cgti    $one,$low_\axis,0
        and     $low_\axis,$low_\axis,$one
    .endr
        ori     $first_x,$low_x,0
        ori     $block_z,$low_z,0
        il      $new_slots,0
next_row:
        cgt     $one,$block_z,$last_z
        brnz    $one,fetched
        ori     $block_x,$first_x,0
next_block:
        cgt     $one,$block_x,$last_x
        brnz    $one,row_fetched
        andi    $slot,$block_z,CELLS/CELL_SIDE-1
        shli    $slot,$slot,2
        andi    $one,$block_x,CELLS/CELL_SIDE-1
        or      $slot,$slot,$one
        shli    $key,$level,20
        shli    $one,$block_z,10
        or      $key,$key,$one
        or      $key,$key,$block_x
        ila     $a_key,arena+CUT_KEYS
        shli    $one,$slot,4
        a       $a_key,$a_key,$one
        lqd     $one,0($a_key)
        ceq     $one,$one,$key
        brnz    $one,is_there
        stqd    $key,0($a_key)
        il      $one,1
        shl     $one,$one,$slot
        or      $new_slots,$new_slots,$one
        # Nine rows of its own level, and five of the next.
        ila     $a_field,field
        load_word $high,HEIGHTS_samples,$a_field
        load_word $low,HEIGHTS_samples+4,$a_field
        shli    $one,$slot,7
        ila     $start,arena+CUT_LISTS
        a       $start,$start,$one
        lqa     $m_pair,transpose_first
        ori     $a_list,$start,0
        ori     $near,$a_level,0
        shli    $c_wide,$block_z,3
        shli    $depth,$block_x,5
        il      $size,CELL_PITCH
        il      $left,-(CELL_SIDE+1)
next_samples:
        # The first row and the first quadword are in front of the level's own.
        ai      $one,$c_wide,1
        load_word $stride,HEIGHTS_levels_of+HEIGHT_LEVEL_stride,$near
        load_word $two,HEIGHTS_levels_of+HEIGHT_LEVEL_offset,$near
        mpyh    $rest,$stride,$one
        mpyu    $element,$stride,$one
        a       $two,$two,$depth
        a       $element,$element,$rest
        a       $two,$two,$low
        a       $element,$element,$two
        ai      $element,$element,16
next_element:
        hbrr    last_element,next_element
        lqd     $one,0($a_list)
        shufb   $two,$size,$element,$m_pair
        cdd     $rest,0($a_list)
        shufb   $one,$two,$one,$rest
        stqd    $one,0($a_list)
        a       $element,$element,$stride
        ai      $a_list,$a_list,8
        ai      $left,$left,1
last_element:
        brnz    $left,next_element
        ai      $rest,$size,-CELL_PITCH
        ai      $near,$near,HEIGHT_LEVEL_SIZE
        rotmi   $c_wide,$c_wide,-1
        rotmi   $depth,$depth,-1
        il      $size,CELL_COARSE_PITCH
        il      $left,-(CELL_SIDE/2+1)
        brz     $rest,next_samples
        ila     $rest,arena+CUT_SAMPLES
        mpyi    $one,$slot,CELL_SAMPLE_BYTES/4
        shli    $one,$one,2
        a       $rest,$rest,$one
        il      $size,8*(CELL_SIDE+1+CELL_SIDE/2+1)
        il      $command,MFC_GETL
        il      $tag,TAG_MESH
        mfc_command $rest,$high,$start,$size,$tag,$command
is_there:
        ai      $block_x,$block_x,1
        br      next_block
row_fetched:
        ai      $block_z,$block_z,1
        br      next_row

fetched:
        brz     $new_slots,cells_made
        il      $3,1<<TAG_MESH
        brsl    $lr,dma_wait
next_new:
        hbrr    cells_call,cuts_cells
        # The last bit that is set.
        sfi     $10,$new_slots,0
        and     $10,$10,$new_slots
        andc    $new_slots,$new_slots,$10
        clz     $10,$10
        sfi     $slot,$10,31
        ila     $3,arena+CUT_SAMPLES
        mpyi    $10,$slot,CELL_SAMPLE_BYTES/4
        shli    $10,$10,2
        a       $3,$3,$10
        ila     $4,arena+CUT_LEVEL
        ila     $11,arena+CUT_KEYS
        shli    $10,$slot,4
        a       $11,$11,$10
        lqd     $10,0($11)
        il      $11,1023
        and     $5,$10,$11
        rotmi   $6,$10,-10
        and     $6,$6,$11
        shli    $5,$5,3
        shli    $6,$6,3
        ila     $7,arena+CUT_CELLS
cells_call:
        brsl    $lr,cuts_cells
        brnz    $new_slots,next_new
cells_made:
        ori     $slot,$four,0
next_cuts:
        hbrr    follow_call,cuts_follow
        ila     $3,arena+CUT_PARAMETERS
        ila     $4,arena+CUT_STATES
        shli    $5,$slot,5
        a       $4,$4,$5
        shli    $5,$slot,2
        ai      $5,$5,-COLUMNS_BEFORE
        ila     $6,arena+CUT_CELLS
follow_call:
        brsl    $lr,cuts_follow
        ai      $slot,$slot,1
        ceq     $3,$slot,$last_four
        brz     $3,next_cuts
        br      next_depth
strip_done:
        leave

        # Where cuts begin at the eye, the ground is followed only from where it may be as high as
        # the lowest rays. Of the largest heights of blocks, a row has the level's
        # blocks in whole quadwords, and the rows are after the level's samples.
skip:   rotmai  $block_x,$low_x,-3
        rotmai  $first_x,$high_x,-3
        rotmai  $block_z,$low_z,-2
        rotmai  $slot,$high_z,-2
        cgti    $one,$block_x,0
        and     $block_x,$block_x,$one
        cgti    $one,$block_z,0
        and     $block_z,$block_z,$one
        ai      $one,$last_x,-1
        minimum $first_x,$first_x,$one,$two
        ai      $one,$last_z,-1
        minimum $slot,$slot,$one,$two
        cgt     $one,$block_x,$first_x
        cgt     $two,$block_z,$slot
        or      $one,$one,$two
        brnz    $one,beyond
        # Of a row: its first byte that is needed, and the number of bytes.
        rotmi   $depth,$block_x,-2
        shli    $depth,$depth,4
        rotmi   $size,$first_x,-2
        shli    $size,$size,4
        sf      $size,$depth,$size
        ai      $size,$size,16
        ila     $a_field,field
        load_word $high,HEIGHTS_samples,$a_field
        load_word $low,HEIGHTS_samples+4,$a_field
        load_word $stride,HEIGHTS_levels_of+HEIGHT_LEVEL_stride,$a_level
        load_word $element,HEIGHTS_levels_of+HEIGHT_LEVEL_offset,$a_level
        shli    $one,$last_z,2
        ai      $one,$one,3
        mpyh    $rest,$stride,$one
        mpyu    $one,$stride,$one
        a       $one,$one,$rest
        a       $element,$element,$one
        ai      $two,$last_x,3
        rotmi   $two,$two,-2
        shli    $two,$two,4
        mpyu    $one,$two,$block_z
        a       $element,$element,$one
        a       $element,$element,$depth
        a       $element,$element,$low
        ila     $start,arena+CUT_SAMPLES
        ori     $a_list,$start,0
        il      $tag,TAG_MESH
        il      $command,MFC_GET
next_heights:
        hbrr    last_heights,next_heights
        mfc_command $a_list,$high,$element,$size,$tag,$command
        a       $a_list,$a_list,$size
        a       $element,$element,$two
        ai      $block_z,$block_z,1
        cgt     $one,$block_z,$slot
last_heights:
        brz     $one,next_heights
        ori     $new_slots,$a_list,0
        il      $3,1<<TAG_MESH
        stqa    $far,kept_far
        stqa    $distance,kept_distance
        brsl    $lr,dma_wait
        ila     $start,arena+CUT_SAMPLES
        il      $low,0
next_highest:
        hbrr    last_height,next_highest
        lqd     $one,0($start)
        rotmi   $one,$one,-16
        cgt     $two,$one,$low
        selb    $low,$low,$one,$two
        ai      $start,$start,16
        ceq     $one,$start,$new_slots
last_height:
        brz     $one,next_highest
    .irp turn, 4,8
        rotqbyi $one,$low,\turn
        cgt     $two,$one,$low
        selb    $low,$low,$one,$two
    .endr
        ai      $low,$low,1
        csflt   $low,$low,0
        ila     $one,arena+CUT_LEVEL
        lqd     $two,LEVEL_unit($one)
        lqd     $one,LEVEL_corner_y($one)
        fma     $low,$low,$two,$one
        lqa     $one,lowest
        lqa     $distance,kept_distance
        lqa     $far,kept_far
        fm      $one,$one,$distance
        fcgt    $one,$one,$low
        nor     $one,$one,$one
        orx     $one,$one
        brz     $one,too_low
        il      $one,0
        stqa    $one,skipping
        br      next_depth
beyond: ilhu    $far,FARTHEST>>16
too_low:
        ori     $left,$four,0
        shli    $one,$four,5
        ila     $a_state,arena+CUT_STATES
        a       $a_state,$a_state,$one
next_skipped:
        hbrr    last_skipped,next_skipped
        lqd     $one,0($a_state)
        maximum $one,$far,$two
        stqd    $one,0($a_state)
        ai      $a_state,$a_state,32
        ai      $left,$left,1
        ceq     $one,$left,$last_four
last_skipped:
        brz     $one,next_skipped
        br      next_depth
endfunction cuts_strip

        .set    NEXT,10
        registers from,to,value_word,m_word

# cuts_begin   makes the ground's object
#   Uses    $10-$13
#
# It is a plane without a normal, since cuts_surfaces has the rest. Its material is the mesh's first
# one, without what needs a triangle.
function cuts_begin
        ila     $from,frame
        load_word $from,FRAME_mesh_materials,$from
        ila     $to,ground_material
        cwd     $m_word,OBJECT_material&15($sp)
        lqa     $value_word,ground+(OBJECT_material&~15)
        shufb   $value_word,$to,$value_word,$m_word
        stqa    $value_word,ground+(OBJECT_material&~15)
    .set    quad_at,0
    .rept   MATERIAL_SIZE/16
        lqd     $value_word,quad_at($from)
        stqd    $value_word,quad_at($to)
    .set    quad_at,quad_at+16
    .endr
        load_constant $m_word,MATERIAL_TEXTURED|MATERIAL_SHADED
        fsmbi   $from,0x000f
        and     $m_word,$m_word,$from
        lqd     $value_word,MATERIAL_flags&~15($to)
        andc    $value_word,$value_word,$m_word
        stqd    $value_word,MATERIAL_flags&~15($to)
        bi      $lr
endfunction cuts_begin

# cuts_eye   lets the primary rays of a batch hit the ground
#   Uses    $3-$79
function cuts_eye
        lqa     $3,rays_at
        ori     $4,$w_count,0
        ila     $5,frame+FRAME_cut_ahead
        ila     $6,ground
        br      cuts_rays_r16
endfunction cuts_eye

# cuts_surfaces   makes the surfaces where they have hit it
#   Uses    $3-$79
function cuts_surfaces
        lqa     $3,rays_at
        lqa     $4,surfaces_at
        ori     $5,$w_count,0
        ila     $6,ground
        lqa     $7,frame
        rotqbyi $7,$7,FRAME_features
        andi    $7,$7,FEATURE_SRGB
        ceqi    $7,$7,0
        nor     $7,$7,$7
        br      cuts_ground_r16
endfunction cuts_surfaces
