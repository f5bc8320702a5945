# pack_sums   sums of a tile's pixels to the framebuffer's 32-bit words
#   C       void pack_sums(const vec_float4 *sums, void *pixels, int rows, int row_bytes,
#                          const struct pixel_shuffle *);
#   In      $3 sums: red, green, blue, anything, in rows of TILE_WIDTH, $4 pixels, row after row,
#           $5 rows (1 to 16), $6 bytes of a row of pixels (16 to 4 TILE_WIDTH, a multiple of 16),
#           $7 shuffle; pointers 16-aligned
#   Out     the pixels
#   Uses    $3-$5, $10-$40   Saves  -   Stack  0   Calls  -
#   Domain  any sum: below 0 is 0, above 1 is 1
#   Error   0.50001 of 255, each channel
#   Twin    lab/twins/src/pack.rs
#
# The conversion is that of pack_r16.

        .include "work_unit.inc"
        .include "macros.inc"
        .include "sizes.inc"

        .set    NEXT,3
        registers a_sums,a_pixels,rows,row_bytes,a_shuffle
        # constants
        .set    NEXT,10
        registers k_scale,k_half,m_red_green,m_blue,m_interleave,m_low,m_high,m_third
        registers skip                                  # sums beyond a row's end
        # state
        registers count                                 # groups of four pixels
        registers left                                  # bytes of the row
        # a group
        registers sum0,sum1,sum2,sum3,rg01,rg23,b01,b23,red,green,blue,pixels,c_end,t_step

        quadword_constants
        # words of two quadwords A and B
interleave:
        .int    0x00010203,0x10111213,0x04050607,0x14151617 # A0 B0 A1 B1
low:    .int    0x00010203,0x04050607,0x10111213,0x14151617 # A0 A1 B0 B1
high:   .int    0x08090a0b,0x0c0d0e0f,0x18191a1b,0x1c1d1e1f # A2 A3 B2 B3
third:  .int    0x08090a0b,0x18191a1b,0x08090a0b,0x18191a1b # A2 B2 A2 B2

function pack_sums
        lqa     $m_interleave,interleave
        lqa     $m_low,low
        lqa     $m_high,high
        lqa     $m_third,third
        ilhu    $k_scale,0x3f7f                         # 255/256
        ilhu    $k_half,0x3b00                          # 1/512
        lqd     $m_red_green,PIXELS_red_green($a_shuffle)
        lqd     $m_blue,PIXELS_blue($a_shuffle)
        mpyu    $count,$rows,$row_bytes
        rotmi   $count,$count,-4
        shli    $skip,$row_bytes,2
        sfi     $skip,$skip,0
        il      $t_step,16*TILE_WIDTH
        a       $skip,$skip,$t_step
        ori     $left,$row_bytes,0
next_group:
    .irp lane, 0,1,2,3
        lqd     $sum\lane,16*\lane($a_sums)
    .endr
        shufb   $rg01,$sum0,$sum1,$m_interleave
        shufb   $rg23,$sum2,$sum3,$m_interleave
        shufb   $b01,$sum0,$sum1,$m_third
        shufb   $b23,$sum2,$sum3,$m_third
        shufb   $red,$rg01,$rg23,$m_low
        shufb   $green,$rg01,$rg23,$m_high
        shufb   $blue,$b01,$b23,$m_low
    .irp channel, red,green,blue
        fma     $\channel,$\channel,$k_scale,$k_half
        cfltu   $\channel,$\channel,32
    .endr
        shufb   $pixels,$red,$green,$m_red_green
        shufb   $pixels,$pixels,$blue,$m_blue
        stqd    $pixels,0($a_pixels)
        ai      $a_pixels,$a_pixels,16
        ai      $left,$left,-16
        ceqi    $c_end,$left,0
        and     $t_step,$c_end,$skip
        ai      $a_sums,$a_sums,64
        a       $a_sums,$a_sums,$t_step
        and     $t_step,$c_end,$row_bytes
        a       $left,$left,$t_step
        ai      $count,$count,-1
        brnz    $count,next_group
        bi      $lr
endfunction pack_sums
