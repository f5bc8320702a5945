# The loops of the transform. They work on 256 lines of 128 bytes. A line is 16 complex numbers: 16
# real parts, then 16 imaginary parts. Each of the 16 belongs to a transform of its own, so that no
# loop but `turn` moves anything from lane to lane.

# The lines of a quarter, in bytes.
        .set    QUARTER, 64*128
# From a line's real parts to its imaginary ones.
        .set    IMAGINARY, 64

# Loads quadword q of the four lines at line_0 to line_3.
        .macro  load_four q:req, line_0:req, line_1:req, line_2:req, line_3:req
        lqd     $x0r,\q*16+\line_0
        lqd     $x0i,\q*16+IMAGINARY+\line_0
        lqd     $x1r,\q*16+\line_1
        lqd     $x1i,\q*16+IMAGINARY+\line_1
        lqd     $x2r,\q*16+\line_2
        lqd     $x2i,\q*16+IMAGINARY+\line_2
        lqd     $x3r,\q*16+\line_3
        lqd     $x3i,\q*16+IMAGINARY+\line_3
        .endm

# Stores the results. Those of a stage go a quarter apart: a pointer in the middle of two quarters
# reaches both.
        .macro  store_four q:req
        stqd    $y0r,\q*16-QUARTER($out_low)
        stqd    $y0i,\q*16-QUARTER+IMAGINARY($out_low)
        stqd    $y1r,\q*16($out_low)
        stqd    $y1i,\q*16+IMAGINARY($out_low)
        stqd    $y2r,\q*16-QUARTER($out_high)
        stqd    $y2i,\q*16-QUARTER+IMAGINARY($out_high)
        stqd    $y3r,\q*16($out_high)
        stqd    $y3i,\q*16+IMAGINARY($out_high)
        .endm

# plus and minus get x + w z and x - w z, for w = cosine (1 - i tangent). Without a multiplication
# of its own: six multiply-adds.
        .macro  twiddle plus_r:req, plus_i:req, minus_r:req, minus_i:req, x_r:req, x_i:req, z_r:req, z_i:req, tangent:req, cosine:req
        fma     $u,$\z_i,$\tangent,$\z_r
        fnms    $v,$\z_r,$\tangent,$\z_i
        fma     $\plus_r,$u,$\cosine,$\x_r
        fma     $\plus_i,$v,$\cosine,$\x_i
        fnms    $\minus_r,$u,$\cosine,$\x_r
        fnms    $\minus_i,$v,$\cosine,$\x_i
        .endm

        .set    x0r, 40
        .set    x0i, 41
        .set    x1r, 42
        .set    x1i, 43
        .set    x2r, 44
        .set    x2i, 45
        .set    x3r, 46
        .set    x3i, 47
        .set    apr, 48                         # x0 + w2 x2
        .set    api, 49
        .set    amr, 50                         # x0 - w2 x2
        .set    ami, 51
        .set    bpr, 52                         # x1 + w2 x3
        .set    bpi, 53
        .set    bmr, 54                         # x1 - w2 x3
        .set    bmi, 55
        .set    u, 56
        .set    v, 57
        .set    y0r, 58
        .set    y0i, 59
        .set    y1r, 60
        .set    y1i, 61
        .set    y2r, 62
        .set    y2i, 63
        .set    y3r, 64
        .set    y3i, 65
        .set    out_low, 20
        .set    out_high, 21
        .set    left, 22

# stage_first   transforms of four numbers: the first stage, which needs no twiddle factors
#   In      $3 256 lines, $4 where 256 lines go
#   Out     nothing
#   Twin    examples/fft/src/twin.rs, stage, with lines of 64
        .set    in_low, 23
        .set    in_high, 24

        .text
        .align  3
        .global stage_first
        .type   stage_first, @function
stage_first:
        ila     $in_high,3*QUARTER
        ila     $out_high,3*QUARTER
        ila     $in_low,QUARTER
        ila     $out_low,QUARTER
        a       $in_high,$in_high,$3
        a       $in_low,$in_low,$3
        a       $out_high,$out_high,$4
        a       $out_low,$out_low,$4
        il      $left,64
first_line:
        .irp    q, 0,1,2,3
        load_four \q, -QUARTER($in_low), 0($in_low), -QUARTER($in_high), 0($in_high)
        fa      $apr,$x0r,$x2r
        fa      $api,$x0i,$x2i
        fs      $amr,$x0r,$x2r
        fs      $ami,$x0i,$x2i
        fa      $bpr,$x1r,$x3r
        fa      $bpi,$x1i,$x3i
        fs      $bmr,$x1r,$x3r
        fs      $bmi,$x1i,$x3i
        fa      $y0r,$apr,$bpr
        fa      $y0i,$api,$bpi
        fs      $y2r,$apr,$bpr
        fs      $y2i,$api,$bpi
        fa      $y1r,$amr,$bmi                  # - i times the other difference
        fs      $y1i,$ami,$bmr
        fs      $y3r,$amr,$bmi
        fa      $y3i,$ami,$bmr
        store_four \q
        .endr
        ai      $in_low,$in_low,128
        ai      $in_high,$in_high,128
        ai      $out_low,$out_low,128
        ai      $out_high,$out_high,128
        ai      $left,$left,-1
        brnz    $left,first_line
        bi      $lr
        .size   stage_first, .-stage_first

# stage   the stage that joins four transforms of a length to one of four times that length
#   In      $3 256 lines, $4 where 256 lines go, $5 twiddle factors, $6 bytes from a line to the
#           next one of the same transform, $7 how far to the right to shift multiples of that, as
#           a negative number, to get an offset in the twiddle factors
#   Out     nothing
#   Twin    examples/fft/src/twin.rs, stage
#
# Line i belongs to butterfly p = i / s, where s is the distance. It takes the lines i + 3 p s and
# s, 2 s and 3 s after that. A record of twiddle factors has four quadwords: tangent and cosine of
# the square of w, tangent and cosine of w.
        .set    m_butterfly, 23                 # the part of an offset that is p s
        .set    three, 24
        .set    i, 25
        .set    base_0, 26
        .set    base_1, 27
        .set    base_2, 28
        .set    base_3, 29
        .set    factors_1, 30
        .set    factors_2, 31
        .set    factors_3, 32
        .set    line_0, 33
        .set    line_1, 34
        .set    line_2, 35
        .set    line_3, 36
        .set    butterfly, 37
        .set    t2, 66
        .set    c2, 67
        .set    t1, 68
        .set    c1, 69

        .align  3
        .global stage
        .type   stage, @function
stage:
        ila     $out_high,3*QUARTER
        ila     $out_low,QUARTER
        a       $out_high,$out_high,$4
        a       $out_low,$out_low,$4
        sfi     $m_butterfly,$6,0
        ori     $base_0,$3,0
        a       $base_1,$base_0,$6
        a       $base_2,$base_1,$6
        a       $base_3,$base_2,$6
        ai      $factors_1,$5,16
        ai      $factors_2,$5,32
        ai      $factors_3,$5,48
        il      $three,3
        il      $i,0
        il      $left,64
stage_line:
        and     $butterfly,$i,$m_butterfly
        mpya    $line_3,$butterfly,$three,$i
        rotm    $butterfly,$butterfly,$7
        a       $line_0,$base_0,$line_3
        a       $line_1,$base_1,$line_3
        a       $line_2,$base_2,$line_3
        a       $line_3,$base_3,$line_3
        lqx     $t2,$5,$butterfly
        lqx     $c2,$factors_1,$butterfly
        lqx     $t1,$factors_2,$butterfly
        lqx     $c1,$factors_3,$butterfly
        .irp    q, 0,1,2,3
        load_four \q, 0($line_0), 0($line_1), 0($line_2), 0($line_3)
        twiddle apr, api, amr, ami, x0r, x0i, x2r, x2i, t2, c2
        twiddle bpr, bpi, bmr, bmi, x1r, x1i, x3r, x3i, t2, c2
        twiddle y0r, y0i, y2r, y2i, apr, api, bpr, bpi, t1, c1
        fma     $u,$bmi,$t1,$bmr
        fnms    $v,$bmr,$t1,$bmi
        fma     $y1r,$v,$c1,$amr                # - i times the other difference
        fnms    $y1i,$u,$c1,$ami
        fnms    $y3r,$v,$c1,$amr
        fma     $y3i,$u,$c1,$ami
        store_four \q
        .endr
        ai      $i,$i,128
        ai      $out_low,$out_low,128
        ai      $out_high,$out_high,128
        ai      $left,$left,-1
        brnz    $left,stage_line
        bi      $lr
        .size   stage, .-stage

# turn_NAME   multiplies four lines at a time by twiddle factors, and transposes them
#   In      $3 lines, $4 where columns go, $5 fine factors: a line for each line; $6 coarse factors:
#           two quadwords for four lines, their real and imaginary parts; $7 how many times four
#           lines
#   Out     nothing
#   Twin    examples/fft/src/twin.rs, turn
#
# The factor of a number is the product of its fine one and its line's coarse one. The 16 numbers of
# a line go to 16 lines, `column` bytes apart; lines are `line` bytes apart.
        .set    fine, 5
        .set    coarse, 6
        .set    place, 23
        .set    row, 24
        .set    column_low, 25
        .set    column_high, 26
        .set    to_low, 27
        .set    to_high, 28
        .set    m_first, 29
        .set    m_last, 30
        .set    m_word, 31                      # to 34: copies of word 0 to 3
        .set    coarse_r, 35
        .set    coarse_i, 36
        .set    copy_r, 37                     # to 40
        .set    copy_i, 41                     # to 44
        .set    xr, 45
        .set    xi, 46
        .set    fr, 47
        .set    fi, 48
        .set    hr, 49
        .set    hi, 50
        .set    zr, 51                          # to 54
        .set    zi, 55                          # to 58
        .set    s0, 59
        .set    s1, 60
        .set    s2, 61
        .set    s3, 62
        .set    d0, 63
        .set    d1, 64
        .set    d2, 65
        .set    d3, 66
        .set    lines, 67
        .set    fine_lines, 68

# Transposes the four registers from z on, and stores them in the columns 4 q to 4 q + 3.
        .macro  put_columns z:req, q:req, pointer:req, first:req, column:req, part:req
        shufb   $s0,$\z,$\z+2,$m_first
        shufb   $s1,$\z+1,$\z+3,$m_first
        shufb   $s2,$\z,$\z+2,$m_last
        shufb   $s3,$\z+1,$\z+3,$m_last
        shufb   $d0,$s0,$s1,$m_first
        shufb   $d1,$s0,$s1,$m_last
        shufb   $d2,$s2,$s3,$m_first
        shufb   $d3,$s2,$s3,$m_last
        stqd    $d0,(\first)*\column+\part($\pointer)
        stqd    $d1,(\first+1)*\column+\part($\pointer)
        stqd    $d2,(\first+2)*\column+\part($\pointer)
        stqd    $d3,(\first+3)*\column+\part($\pointer)
        .endm

        .macro  turn_constants line:req, column:req
        lqa     $m_first,turn_shuffles
        lqa     $m_last,turn_shuffles+16
        .irp    word, 0,1,2,3
        lqa     $m_word+\word,turn_shuffles+32+16*\word
        .endr
        ila     $column_low,4*\column
        ila     $column_high,12*\column
        a       $column_low,$column_low,$4
        a       $column_high,$column_high,$4
        il      $lines,4*\line
        il      $fine_lines,4*128
        ori     $left,$7,0
        il      $place,0
        .endm

        .macro  turn_lines line:req, column:req
        andi    $row,$place,-64                 # 16 lines of 128 bytes, four at a time
        a       $row,$row,$place
        a       $to_low,$column_low,$row
        a       $to_high,$column_high,$row
        lqd     $coarse_r,0($coarse)
        lqd     $coarse_i,16($coarse)
        .irp    l, 0,1,2,3
        shufb   $copy_r+\l,$coarse_r,$coarse_r,$m_word+\l
        shufb   $copy_i+\l,$coarse_i,$coarse_i,$m_word+\l
        .endr
        .irp    q, 0,1,2,3
        .irp    l, 0,1,2,3
        lqd     $xr,\l*\line+16*\q($3)
        lqd     $xi,\l*\line+16*\q+IMAGINARY($3)
        lqd     $fr,\l*128+16*\q($fine)
        lqd     $fi,\l*128+16*\q+IMAGINARY($fine)
        fm      $hr,$fi,$copy_i+\l
        fm      $hi,$fi,$copy_r+\l
        fms     $hr,$fr,$copy_r+\l,$hr
        fma     $hi,$fr,$copy_i+\l,$hi
        fm      $zr+\l,$xi,$hi
        fm      $zi+\l,$xi,$hr
        fms     $zr+\l,$xr,$hr,$zr+\l
        fma     $zi+\l,$xr,$hi,$zi+\l
        .endr
        .if     \q<2
        put_columns zr, \q, to_low, 4*\q-4, \column, 0
        put_columns zi, \q, to_low, 4*\q-4, \column, IMAGINARY
        .else
        put_columns zr, \q, to_high, 4*\q-12, \column, 0
        put_columns zi, \q, to_high, 4*\q-12, \column, IMAGINARY
        .endif
        .endr
        a       $3,$3,$lines
        a       $fine,$fine,$fine_lines
        ai      $coarse,$coarse,32
        ai      $place,$place,16
        ai      $left,$left,-1
        .endm

# 16 columns of 256 lines, which become 16 rows of 16 lines.
        .align  3
        .global turn_batch
        .type   turn_batch, @function
turn_batch:
        turn_constants 128, 2048
batch_lines:
        turn_lines 128, 2048
        brnz    $left,batch_lines
        bi      $lr
        .size   turn_batch, .-turn_batch

# 16 columns of a matrix with 64 rows of 4 lines, which become 16 rows of 4 lines.
        .align  3
        .global turn_square
        .type   turn_square, @function
turn_square:
        turn_constants 512, 512
square_lines:
        turn_lines 512, 512
        brnz    $left,square_lines
        bi      $lr
        .size   turn_square, .-turn_square

        .section .rodata
        .align  4
turn_shuffles:
        .int    0x00010203,0x10111213,0x04050607,0x14151617
        .int    0x08090a0b,0x18191a1b,0x0c0d0e0f,0x1c1d1e1f
        .irp    word, 0x00010203,0x04050607,0x08090a0b,0x0c0d0e0f
        .int    \word,\word,\word,\word
        .endr
