# height_block   makes a leaf block of triangles from the samples of a height field
#   C       void height_block(struct mesh_block *, const struct heights *, int number,
#                             struct height_scratch *);
#   In      $3 the block, in which the samples have arrived at HEIGHT_SAMPLES; $4 the height field;
#           $5 the block's number; $6 space for HEIGHT_SCRATCH bytes; pointers 16-aligned
#   Out     the block: positions relative to the eye, and boxes with the slack of mesh_prepare
#   Uses    $3-$79   Saves  -   Stack  0   Calls  -
#   Domain  any samples; a level below HEIGHT_LEVELS
#   Error   0: boxes hold their triangles, with a slack of 2^-19 of the largest magnitude of their
#           coordinates
#   Twin    lab/twins/src/height.rs
#
# A vertex has the height, the slopes and the colour of its own level near the eye, those of the
# next level far from it, and in between a part of either that depends on its distance alone.
# Every second vertex is missing in the next level, so it moves to the one before it. A block that
# has faded completely has the next level's triangles and others without an area, so where blocks
# of two levels meet they have the same vertices, and no vertex is on another triangle's edge.
#
# A row of vertices has 12 places for 9 vertices, in three quadwords of each number.
#
# The scheduler does not overlap passes, to save 2.3 KB. A block takes 2,539 cycles.

        .include "work_unit.inc"
        .include "macros.inc"
        .include "extremes.inc"
        .include "reciprocal.inc"
        .include "height.inc"

        .set    NEXT,3
        registers a_block,a_field,number,a_scratch
        .set    NEXT,7
        # constants
        registers m_left,m_right,m_height,m_red,m_green,m_low,m_high,m_normal,m_ten,m_twelve
        registers k_zero,k_one,k_sign,k_half,k_five,k_six
        registers step_x,step_y,step_z,corner_x,corner_y,corner_z,from,fade,up
        # loops
        registers a_samples,a_out,a_coarse,a_x,a_z,a_vertex,a_colour,a_passes,bases,left
        # attributes of four samples
        registers quad_left,quad_right,quad_up,quad_down,mid
        registers height,slope_x,slope_z,red,green,blue
        # four vertices
        registers x,z,part,m_first,one,two,t,share,y
        registers sum,t_y,t_e,u,v
        # places of columns and rows, before the loops
        .set    k_lanes,quad_left
        .set    level,quad_right
        .set    level_1,quad_up
        .set    last_x,quad_down
        .set    last_z,mid
        .set    above,height
        .set    row,slope_x
        .set    column,slope_z
        .set    index,red
        .set    a_level,green
    .if NEXT > 80
        .error  "too many registers"
    .endif

        # For the boxes, when the vertices are done.
        .set    NEXT,7
        registers m_even,m_odd,m_next,c_more,lowest,highest,k_no,m_two,size,slack,m_none,k_bit
        .set    root,x                                  # lower corners, upper corners
        .set    node,v+1                                # those of the two nodes below
    .if NEXT > a_samples || node+12 > 80
        .error  "the boxes reach into other registers"
    .endif

        .section .rodata.height,"a",@progbits
        .align  4
# Heights of the samples to the left, to the right, and of four themselves.
heights:
        .int    0x80800c0d,0x80801011,0x80801415,0x80801819
        .int    0x80800405,0x80800809,0x80800c0d,0x80801011
        .int    0x80800001,0x80800405,0x80800809,0x80800c0d
# The lower halves of two words.
halves: .int    0x02031213,0x06071617,0x0a0b1a1b,0x0e0f1e1f
low_and_high:
        .int    0x00010203,0x10111213,0x04050607,0x14151617
        .int    0x08090a0b,0x18191a1b,0x0c0d0e0f,0x1c1d1e1f
lanes:  .int    0,1,2,3
# Of five samples of the next level, in two quadwords, those that four vertices move to.
targets:
        .int    0x00010203,0x00010203,0x04050607,0x04050607
        .int    0x08090a0b,0x08090a0b,0x0c0d0e0f,0x0c0d0e0f
        .int    0x10111213,0x10111213,0x10111213,0x10111213
# For each four vertices, where in the scratch their samples, those of the next level, and the
# places of their columns and of their row are.
# The ones after the last are read, and what they name, but not used.
passes:
    .irp row, 0,1,2,3,4
    .irp quad, 0,1,2
        .int    HEIGHT_PITCH*(1+\row)+16*(1+\quad),COARSE_AT+COARSE_ROW*(\row/2)
        .int    COLUMNS_AT+COLUMN_BYTES*\quad,ROWS_AT+ROW_BYTES*\row
    .endr
    .endr
        .int    HEIGHT_PITCH,COARSE_AT,COLUMNS_AT,ROWS_AT
# Every second one of eight words, from the first or from the second one on; three words after
# the first, and another one.
evens:  .int    0x00010203,0x08090a0b,0x10111213,0x18191a1b
odds:   .int    0x04050607,0x0c0d0e0f,0x14151617,0x1c1d1e1f
next_evens:
        .int    0x04050607,0x08090a0b,0x0c0d0e0f,0x10111213
header:
        .int    MESH_MAGIC,0,MESH_LEAF,2
        .int    3,64,HEIGHT_VERTICES,SIDES_SMOOTH|SIDES_COLOURED
# Of the root, then of the nodes below: runs of eight triangles.
children:
        .int    MESH_HEADER_SIZE+BOXES_SIZE,MESH_HEADER_SIZE+2*BOXES_SIZE,0,0
    .set    run,0
    .rept   8
        .int    8<<16|8*MESH_FACE_SIZE*run
    .set    run,run+1
    .endr
# The triangles of each run: those of two by two squares.
faces:
    .irp row, 0,2
    .irp column, 0,2,4,6
    .irp square, 0,1,12,13
        .set    first,12*\row+\column+\square
        .byte   first,first+12,first+13,0, first,first+13,first+1,0
    .endr
    .endr
    .endr

# Height, slopes and colour of the four samples at $a_samples, whose rows are `pitch` bytes apart.
.macro  attributes pitch:req
        lqd     $mid,0($a_samples)
        lqd     $quad_left,-16($a_samples)
        lqd     $quad_right,16($a_samples)
        lqd     $quad_up,-\pitch($a_samples)
        lqd     $quad_down,\pitch($a_samples)
        shufb   $quad_left,$quad_left,$mid,$m_left
        shufb   $quad_right,$mid,$quad_right,$m_right
        shufb   $height,$mid,$mid,$m_height
        shufb   $quad_up,$quad_up,$quad_up,$m_height
        shufb   $quad_down,$quad_down,$quad_down,$m_height
        csflt   $height,$height,0
        sf      $slope_x,$quad_left,$quad_right
        sf      $slope_z,$quad_up,$quad_down
        csflt   $slope_x,$slope_x,0
        csflt   $slope_z,$slope_z,0
        and     $red,$mid,$m_red
        and     $green,$mid,$m_green
        andi    $blue,$mid,31
        csflt   $red,$red,11
        csflt   $green,$green,5
        csflt   $blue,$blue,0
.endm

# Unpacks the samples of the next four vertices, and finds how far these have faded. It is done
# beside the four before them, which alone would wait for their own results most of the time.
.macro  four_begin
        lqd     $a_samples,0($a_passes)
        ai      $a_passes,$a_passes,16
        a       $a_samples,$a_samples,$bases
        rotqbyi $a_coarse,$a_samples,4
        rotqbyi $a_x,$a_samples,8
        rotqbyi $a_z,$a_samples,12
        attributes HEIGHT_PITCH
        # Slopes of this level are over half of the distance.
        fa      $slope_x,$slope_x,$slope_x
        fa      $slope_z,$slope_z,$slope_z
        lqd     $one,32($a_x)
        lqd     $two,32($a_z)
        fma     $part,$two,$two,$one
        fs      $part,$part,$from
        fm      $part,$part,$fade
        maximum $part,$k_zero,$t
        minimum_f4 $part,$k_one,$t
.endm

# Fades a number to that of the next level.
.macro  faded number:req, attribute:req
        lqd     $one,32*\attribute($a_coarse)
        lqd     $t,32*\attribute+16($a_coarse)
        shufb   $one,$one,$t,$m_first
        fs      $t_y,$one,\number
        fma     \number,$part,$t_y,\number
.endm

# out = the place of a sample's index at a level, in samples of the first level.
.macro  placed out:req, index:req, level:req, last:req
        shl     \out,\index,\level
        csflt   \out,\out,0
        minimum_f4 \out,\last,$t
.endm

# Stores the places of columns or of a row in their level and in the next, and leaves the first one
# relative to the eye in $one.
.macro  places at:req, last:req, step:req, corner:req
        placed  $one,$index,$level,\last
        rotmi   $two,$index,-1
        placed  $two,$two,$level_1,\last
        stqd    $one,\at($a_scratch)
        stqd    $two,\at+16($a_scratch)
        fma     $one,$one,\step,\corner
.endm

# The words of the field's quadword, in all lanes.
.macro  spread_three field:req, x:req, y:req, z:req
        lqd     $t,\field($a_field)
        splat   \x,$t,$m_first
        rotqbyi $one,$t,4
        splat   \y,$one,$m_first
        rotqbyi $one,$t,8
        splat   \z,$one,$m_first
        rotqbyi $one,$t,12
.endm

function height_block
        splat_mask $m_first
        lqa     $m_left,heights
        lqa     $m_right,heights+16
        lqa     $m_height,heights+32
        lqa     $m_normal,halves
        ila     $m_red,0xf800
        il      $m_green,0x7e0
        load_constant $m_ten,(1<<22)-1
        il      $m_twelve,(1<<12)-1
        load_constant $k_half,0x46fffe00                # 32767
        ilhu    $k_five,0x4204                          # 1023 / 31
        load_constant $k_six,0x4181e7a0                 # above 1023 / 63
        il      $k_zero,0
        lqa     $m_low,low_and_high
        lqa     $m_high,low_and_high+16
        lqa     $k_lanes,lanes
        ilhu    $k_one,0x3f80
        ilhu    $k_sign,0x8000
        # The samples make space for the block.
        il      $t,HEIGHT_SAMPLES
        a       $a_samples,$a_block,$t
        ori     $a_out,$a_scratch,0
        .set    left_over,HEIGHT_SAMPLE_BYTES/16%8
        il      $left,-(HEIGHT_SAMPLE_BYTES/16/8)
    .set    quad,0
    .rept   left_over
        lqd     $height,16*quad($a_samples)
        stqd    $height,16*quad($a_out)
    .set    quad,quad+1
    .endr
        ai      $a_samples,$a_samples,16*left_over
        ai      $a_out,$a_out,16*left_over
copy:
    .irp quad, 0,1,2,3,4,5,6,7
        lqd     $height+\quad,16*\quad($a_samples)
    .endr
    .irp quad, 0,1,2,3,4,5,6,7
        stqd    $height+\quad,16*\quad($a_out)
    .endr
        ai      $a_samples,$a_samples,128
        ai      $a_out,$a_out,128
        ai      $left,$left,1
        brnz    $left,copy
        # The number's parts.
        rotmi   $level,$number,-19
        andi    $level,$level,15
        shli    $a_level,$level,5
        a       $a_level,$a_level,$a_field
        lqd     $up,HEIGHTS_levels_of+(HEIGHT_LEVEL_fades_from&~15)($a_level)
        splat   $from,$up,$m_first
        rotqbyi $fade,$up,4
        splat   $fade,$fade,$m_first
        rotqbyi $up,$up,8
        splat   $up,$up,$m_first
        shli    $row,$number,32-19
        rotmi   $row,$row,-(32-10)
        shli    $row,$row,2
        splat   $row,$row,$m_first
        andi    $column,$number,511
        shli    $column,$column,3
        splat   $column,$column,$m_first
        a       $column,$column,$k_lanes
        splat   $level,$level,$m_first
        ai      $level_1,$level,1
        spread_three HEIGHTS_corner,$corner_x,$corner_y,$corner_z
        splat   $above,$one,$m_first
        spread_three HEIGHTS_step,$step_x,$step_y,$step_z
        spread_three HEIGHTS_last,$last_x,$one,$last_z
    .irp quad, 0,1,2
        ai      $index,$column,4*\quad
        places  COLUMNS_AT+COLUMN_BYTES*\quad,$last_x,$step_x,$corner_x
        fma     $one,$one,$one,$above
        stqd    $one,COLUMNS_AT+COLUMN_BYTES*\quad+32($a_scratch)
        lqa     $two,targets+16*\quad
        stqd    $two,COLUMNS_AT+COLUMN_BYTES*\quad+48($a_scratch)
    .endr
    .irp down, 0,1,2,3,4
        ai      $index,$row,\down
        places  ROWS_AT+ROW_BYTES*\down,$last_z,$step_z,$corner_z
        stqd    $one,ROWS_AT+ROW_BYTES*\down+32($a_scratch)
    .endr
        # The next level: three rows of two quadwords.
        il      $t,7*HEIGHT_PITCH+COARSE_PITCH+16
        a       $a_samples,$a_scratch,$t
        il      $t,COARSE_AT
        a       $a_coarse,$a_scratch,$t
        il      $left,-3
coarse_row:
    .irp quad, 0,1
        attributes COARSE_PITCH
        stqd    $height,16*\quad($a_coarse)
        stqd    $slope_x,32+16*\quad($a_coarse)
        stqd    $slope_z,64+16*\quad($a_coarse)
        stqd    $red,96+16*\quad($a_coarse)
        stqd    $green,128+16*\quad($a_coarse)
        stqd    $blue,160+16*\quad($a_coarse)
        ai      $a_samples,$a_samples,16
    .endr
        ai      $a_samples,$a_samples,COARSE_PITCH-32
        ai      $a_coarse,$a_coarse,COARSE_ROW
        ai      $left,$left,1
        brnz    $left,coarse_row

        # The vertices: five rows of three quadwords.
        splat_mask $m_first
        splat   $bases,$a_scratch,$m_first
        ila     $a_passes,passes
        il      $t,PLACES_AT
        a       $a_out,$a_scratch,$t
        ai      $a_vertex,$a_block,HEIGHT_VERTICES_AT
        il      $t,HEIGHT_COLOURS_AT
        a       $a_colour,$a_block,$t
        il      $left,-15
        four_begin
next_four:
        lqd     $x,0($a_x)
        lqd     $one,16($a_x)
        fs      $one,$one,$x
        fma     $x,$part,$one,$x
        lqd     $z,0($a_z)
        lqd     $one,16($a_z)
        fs      $one,$one,$z
        fma     $z,$part,$one,$z
        lqd     $m_first,48($a_x)
        faded   $height,0
        faded   $slope_x,1
        faded   $slope_z,2
        faded   $red,3
        faded   $green,4
        faded   $blue,5
        fma     $x,$x,$step_x,$corner_x
        fma     $y,$height,$step_y,$corner_y
        fma     $z,$z,$step_z,$corner_z
        stqd    $x,0($a_out)
        stqd    $y,5*HEIGHT_ROW_BYTES($a_out)
        stqd    $z,10*HEIGHT_ROW_BYTES($a_out)
        # The normal, (-slope_x, up, -slope_z), on the octahedron.
        andc    $one,$slope_x,$k_sign
        andc    $two,$slope_z,$k_sign
        fa      $sum,$one,$two
        fa      $sum,$sum,$up
        reciprocal_f4 $share,$sum,$t_y,$t_e,$k_one
        fm      $u,$slope_x,$share
        fm      $v,$up,$share
        xor     $u,$u,$k_sign
        # Where z is below 0, it is folded.
        fcgt    $t,$slope_z,$k_zero
        fs      $one,$k_one,$v
        and     $t_y,$u,$k_sign
        andc    $two,$u,$k_sign
        or      $one,$one,$t_y
        fs      $two,$k_one,$two
        selb    $u,$u,$one,$t
        selb    $v,$v,$two,$t
        fm      $u,$u,$k_half
        fm      $v,$v,$k_half
        cflts   $u,$u,0
        cflts   $v,$v,0
        shufb   $u,$u,$v,$m_normal
        # Records of vertices.
        shufb   $one,$x,$z,$m_low
        shufb   $two,$y,$u,$m_low
        shufb   $x,$x,$z,$m_high
        shufb   $y,$y,$u,$m_high
        shufb   $z,$one,$two,$m_low
        shufb   $u,$one,$two,$m_high
        shufb   $v,$x,$y,$m_low
        shufb   $x,$x,$y,$m_high
        stqd    $z,0($a_vertex)
        stqd    $u,16($a_vertex)
        stqd    $v,32($a_vertex)
        stqd    $x,48($a_vertex)
        # Colours of ten bits.
        fm      $red,$red,$k_five
        fm      $green,$green,$k_six
        fm      $blue,$blue,$k_five
        cfltu   $red,$red,22
        cfltu   $green,$green,12
        cfltu   $blue,$blue,0
        shli    $blue,$blue,2
        selb    $red,$red,$green,$m_ten
        selb    $red,$red,$blue,$m_twelve
        stqd    $red,0($a_colour)
        four_begin
        ai      $a_out,$a_out,16
        ai      $a_vertex,$a_vertex,64
        ai      $a_colour,$a_colour,16
        ai      $left,$left,1
        brnz    $left,next_four

        # Everything but the nodes.
        lqa     $one,header
        lqa     $two,header+16
        cwd     $t,MESH_HEADER_number($sp)
        shufb   $one,$number,$one,$t
        stqd    $one,0($a_block)
        stqd    $two,16($a_block)
        ila     $a_samples,faces
        il      $left,-4
copy_faces:
    .irp quad, 0,1,2,3
        lqd     $height+\quad,16*\quad($a_samples)
    .endr
    .irp quad, 0,1,2,3
        stqd    $height+\quad,16*\quad($a_vertex)
    .endr
        ai      $a_samples,$a_samples,64
        ai      $a_vertex,$a_vertex,64
        ai      $left,$left,1
        brnz    $left,copy_faces

        # The boxes.
        lqa     $m_even,evens
        lqa     $m_odd,odds
        lqa     $m_next,next_evens
        il      $t,PLACES_AT
        a       $a_out,$a_scratch,$t
    .irp axis, 0,1,2
    .irp of, 0,1
    .irp quad, 0,1,2
        lqd     $height+\quad,HEIGHT_ROW_BYTES*(5*\axis+2*\of)+16*\quad($a_out)
        ori     $red+\quad,$height+\quad,0
    .irp below, 1,2
        lqd     $t,HEIGHT_ROW_BYTES*(5*\axis+2*\of+\below)+16*\quad($a_out)
        minimum_f4 $height+\quad,$t,$c_more
        maximum $red+\quad,$t,$c_more
    .endr
    .endr
        shufb   $lowest,$height,$height+1,$m_even
        shufb   $t,$height,$height+1,$m_odd
        minimum_f4 $t,$lowest,$c_more
        shufb   $lowest,$lowest,$height+2,$m_next
        minimum_f4 $lowest,$t,$c_more
        shufb   $highest,$red,$red+1,$m_even
        shufb   $t,$red,$red+1,$m_odd
        maximum $t,$highest,$c_more
        shufb   $highest,$highest,$red+2,$m_next
        maximum $highest,$t,$c_more
        ori     $node+6*\of+\axis,$lowest,0
        ori     $node+6*\of+3+\axis,$highest,0
    .endr
    .endr
        # The root has the boxes of both in its first two lanes, and none in the others.
        fsmbi   $m_two,0x0f00
        fsmbi   $m_none,0x00ff
        ilhu    $k_no,NO_BOX>>16
        ilhu    $k_bit,0x8000
        il      $size,0
    .irp plane, 0,1,2,3,4,5
    .irp of, 0,1
        ori     $lowest+\of,$node+6*\of+\plane,0
        rotqbyi $t,$lowest+\of,8
    .if \plane < 3
        minimum_f4 $lowest+\of,$t,$c_more
        rotqbyi $t,$lowest+\of,4
        minimum_f4 $lowest+\of,$t,$c_more
    .else
        maximum $lowest+\of,$t,$c_more
        rotqbyi $t,$lowest+\of,4
        maximum $lowest+\of,$t,$c_more
    .endif
    .endr
        selb    $root+\plane,$lowest,$lowest+1,$m_two
        andc    $t,$lowest,$k_bit
        maximum $size,$t,$c_more
        andc    $t,$lowest+1,$k_bit
        maximum $size,$t,$c_more
        selb    $root+\plane,$root+\plane,$k_no,$m_none
    .if \plane == 2
        ilhu    $k_no,0x8000|NO_BOX>>16
    .endif
    .endr
        ilhu    $slack,0x3600                           # 2^-19
        fm      $slack,$size,$slack
        lqa     $height,children
        lqa     $slope_x,children+16
        lqa     $slope_z,children+32
    .irp plane, 0,1,2,3,4,5
    .if \plane < 3
        fs      $root+\plane,$root+\plane,$slack
        fs      $node+\plane,$node+\plane,$slack
        fs      $node+6+\plane,$node+6+\plane,$slack
    .else
        fa      $root+\plane,$root+\plane,$slack
        fa      $node+\plane,$node+\plane,$slack
        fa      $node+6+\plane,$node+6+\plane,$slack
    .endif
        stqd    $root+\plane,MESH_HEADER_SIZE+16*\plane($a_block)
        stqd    $node+\plane,MESH_HEADER_SIZE+BOXES_SIZE+16*\plane($a_block)
        stqd    $node+6+\plane,MESH_HEADER_SIZE+2*BOXES_SIZE+16*\plane($a_block)
    .endr
        stqd    $height,MESH_HEADER_SIZE+BOXES_child($a_block)
        stqd    $slope_x,MESH_HEADER_SIZE+BOXES_SIZE+BOXES_child($a_block)
        stqd    $slope_z,MESH_HEADER_SIZE+2*BOXES_SIZE+BOXES_child($a_block)
        bi      $lr
endfunction height_block
