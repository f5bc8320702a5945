# cuts_cells   makes cells of the samples of a height field
#   C       void cuts_cells(const vec_uint4 *samples, const struct level *, int column, int row,
#                             vec_uint4 *cells);
#   In      $3 nine rows of twelve samples, and five rows of eight samples of the next level;
#           $4 the level; $5 $6 the first column and row, multiples of CELL_SIDE; $7 CELLS by CELLS
#           heights, and the colours after them; pointers 16-aligned
#   Out     CELL_SIDE by CELL_SIDE cells
#   Uses    $3-$79   Saves  -   Stack  0   Calls  -
#   Domain  any samples; columns and rows from 0 to MAX_HEIGHT_SIDE
#   Error   0.02 of the length of a height of 1, where levels fade over no less than a step
#   Twin    lab/twins/src/cuts.rs
#
# A height is relative to the eye. Near the eye it is that of the sample, far from it that of the
# next level at the same place, and in between a part of either that depends on the distance alone.
# So it is with colours, whose parts get ten bits.

        .include "work_unit.inc"
        .include "macros.inc"
        .include "extremes.inc"
        .include "height.inc"

        .set    NEXT,3
        registers a_own,a_level,column,row,a_cells
        registers m_low_first,m_high_first,m_low_second,m_high_second
        registers m_pair0,m_pair1,m_pair2,m_pair3
        registers m_first,m_red,m_green,m_red_blue,m_ten0,m_ten1,m_ten2,k_five,k_six,k_one,k_zero
        registers side,corner_y,corner_z,above,from,fade,unit,across0,across1,across2
        registers a_coarse,a_colours,down,index,step,z
        registers heights0,heights1,red_blue0,red_blue1,green0,green1
        registers old_y0,old_y1,old_y2,old_c0,old_c1,old_c2,y0,y1,y2,c0,c1,c2
        registers word,height,red,green,blue,part,one,two,next
        .set    t_c,next
        .set    corner_x,z
        .set    coarse0,word
        .set    coarse1,height
        .set    coarse2,red
        .set    coarse3,green
    .if NEXT > 80
        .error  "too many registers"
    .endif

        .section .rodata.cuts,"a",@progbits
        .align  4
lanes:  .int    0,1,2,3
# Of five samples of the next level, in two quadwords, those on either side of a sample.
sides:  .int    0x00010203,0x00010203,0x04050607,0x04050607
        .int    0x00010203,0x04050607,0x04050607,0x08090a0b
        .int    0x08090a0b,0x08090a0b,0x0c0d0e0f,0x0c0d0e0f
        .int    0x08090a0b,0x0c0d0e0f,0x0c0d0e0f,0x10111213
# Neighbours in a row and in the next, and those at the end of a quadword.
pairs:  .int    0x00010203,0x04050607,0x10111213,0x14151617
        .int    0x04050607,0x08090a0b,0x14151617,0x18191a1b
        .int    0x08090a0b,0x0c0d0e0f,0x18191a1b,0x1c1d1e1f
        .int    0x0c0d0e0f,0x10111213,0x80808080,0x80808080

.macro  level_number name:req
        lqd     $\name,LEVEL_\name($a_level)
.endm

# The sum of four samples of the next level around each of four samples.
.macro  around out:req, of:req, quad:req
    .if \quad == 1
        shufb   \out,$\of\()0,$\of\()1,$m_low_second
        shufb   $one,$\of\()0,$\of\()1,$m_high_second
    .elseif \quad == 0
        shufb   \out,$\of\()0,$\of\()0,$m_low_first
        shufb   $one,$\of\()0,$\of\()0,$m_high_first
    .else
        shufb   \out,$\of\()1,$\of\()1,$m_low_first
        shufb   $one,$\of\()1,$\of\()1,$m_high_first
    .endif
        a       \out,\out,$one
.endm

.macro  faded number:req, other:req
        fs      \other,\other,\number
        fma     \number,$part,\other,\number
.endm

# Height and colour of four vertices of a row.
.macro  vertices quad:req
        lqd     $word,16*\quad($a_own)
        fa      $part,$across\quad,$z
        fs      $part,$part,$from
        fm      $part,$part,$fade
        maximum $part,$k_zero,$t_c
        minimum_f4 $part,$k_one,$t_c
        rotmi   $height,$word,-16
        and     $red,$word,$m_red
        and     $green,$word,$m_green
        andi    $blue,$word,31
        csflt   $height,$height,0
        csflt   $red,$red,11
        csflt   $green,$green,5
        csflt   $blue,$blue,0
        around  $two,heights,\quad
        csflt   $two,$two,2
        faded   $height,$two
        fma     $y\quad,$height,$unit,$corner_y
        around  $two,green,\quad
        csflt   $two,$two,7
        faded   $green,$two
        around  $two,red_blue,\quad
        andi    $next,$two,127
        rotmi   $two,$two,-11
        csflt   $next,$next,2
        csflt   $two,$two,2
        faded   $blue,$next
        faded   $red,$two
        fm      $red,$red,$k_five
        fm      $green,$green,$k_six
        fm      $blue,$blue,$k_five
        cfltu   $red,$red,22
        cfltu   $green,$green,12
        cfltu   $blue,$blue,2
        and     $red,$red,$m_ten0
        and     $green,$green,$m_ten1
        and     $blue,$blue,$m_ten2
        or      $red,$red,$green
        or      $c\quad,$red,$blue
.endm

# Four cells between the previous row and this one.
.macro  cells of:req, address:req, quad:req, after:req
    .irp pair, 0,1,2
        shufb   $one,$old_\of\quad,$\of\quad,$m_pair\pair
        stqd    $one,64*\quad+16*\pair(\address)
    .endr
        shufb   $one,$old_\of\quad,$old_\of\after,$m_pair3
        shufb   $two,$\of\quad,$\of\after,$m_pair3
        shufb   $one,$one,$two,$m_pair0
        stqd    $one,64*\quad+48(\address)
.endm

function cuts_cells
        splat_mask $m_first
        lqa     $m_low_first,sides
        lqa     $m_high_first,sides+16
        lqa     $m_low_second,sides+32
        lqa     $m_high_second,sides+48
    .irp pair, 0,1,2,3
        lqa     $m_pair\pair,pairs+16*\pair
    .endr
        ila     $m_red,0xf800
        il      $m_green,0x7e0
        ila     $m_red_blue,0xf81f
        ilhu    $m_ten0,0xffc0
        rotmi   $m_ten1,$m_ten0,-10
        rotmi   $m_ten2,$m_ten0,-20
        ilhu    $k_five,0x4204                          # 1023 / 31
        load_constant $k_six,0x4181e7a0                 # above 1023 / 63
        ilhu    $k_one,0x3f80
        il      $k_zero,0
    .irp name, side,corner_x,corner_y,above,from,fade,unit
        level_number \name
    .endr
        # Where the cells are.
        andi    $one,$column,CELLS-1
        andi    $two,$row,CELLS-1
        shli    $one,$one,4
        shli    $two,$two,4+CELLS_LOG2
        a       $a_cells,$a_cells,$one
        a       $a_cells,$a_cells,$two
        il      $one,CELLS_BYTES
        a       $a_colours,$a_cells,$one
        # The squares of the columns' distances.
        splat   $column,$column,$m_first
        splat   $row,$row,$m_first
        lqa     $one,lanes
        a       $column,$column,$one
    .irp quad, 0,1,2
        ai      $one,$column,4*\quad
        csflt   $one,$one,0
        fma     $one,$one,$side,$corner_x
        fma     $across\quad,$one,$one,$above
    .endr
        level_number corner_z
        ai      $a_coarse,$a_own,CELL_COARSE_AT
        il      $down,0
        il      $step,0
next_row:
        # The samples of the next level above and below this row.
        rotmi   $index,$down,-1
        shli    $index,$index,5
        a       $index,$a_coarse,$index
        lqd     $coarse0,0($index)
        lqd     $coarse1,16($index)
        ai      $index,$down,1
        rotmi   $index,$index,-1
        shli    $index,$index,5
        a       $index,$a_coarse,$index
        lqd     $coarse2,0($index)
        lqd     $coarse3,16($index)
    .irp half, 0,1
        rotmi   $one,$coarse0+\half,-16
        rotmi   $two,$coarse2+\half,-16
        a       $heights\half,$one,$two
        and     $one,$coarse0+\half,$m_red_blue
        and     $two,$coarse2+\half,$m_red_blue
        a       $red_blue\half,$one,$two
        and     $one,$coarse0+\half,$m_green
        and     $two,$coarse2+\half,$m_green
        a       $green\half,$one,$two
    .endr
        a       $z,$row,$down
        csflt   $z,$z,0
        fma     $z,$z,$side,$corner_z
        fm      $z,$z,$z
        vertices 0
        vertices 1
        vertices 2
        # Stores before the second row are repeated after it.
        cells   y,$a_cells,0,1
        cells   y,$a_cells,1,2
        cells   c,$a_colours,0,1
        cells   c,$a_colours,1,2
    .irp quad, 0,1,2
        ori     $old_y\quad,$y\quad,0
        ori     $old_c\quad,$c\quad,0
    .endr
        a       $a_cells,$a_cells,$step
        a       $a_colours,$a_colours,$step
        il      $step,16*CELLS
        ai      $a_own,$a_own,CELL_PITCH
        ai      $down,$down,1
        cgti    $one,$down,CELL_SIDE
        brz     $one,next_row
        bi      $lr
endfunction cuts_cells
