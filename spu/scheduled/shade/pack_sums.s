# pack_sums   sums of a tile's pixels to the framebuffer's 32-bit words
#   C       void pack_sums(const vec_float4 *sums, void *pixels, int rows, int row_bytes,
#                          const struct pixel_shuffle *);
#   In      $3 sums: red, green, blue, anything, in rows of TILE_WIDTH, $4 pixels, row behind row,
#           $5 rows (1 to 16), $6 bytes of a row of pixels (16 to 4 TILE_WIDTH, a multiple of 16),
#           $7 shuffle; pointers 16-aligned
#   Out     the pixels
#   Uses    $2-$5, $7-$34, $79   Saves  -   Stack  0   Calls  -
#   Domain  any sum: below 0 is 0, above 1 is 1
#   Error   0.50001 of 255, each channel
#   Twin    lab/twins/src/pack.rs
#
# The conversion is that of pack_r16.
# Scheduled by spu schedule from pack_sums.s

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

        .section .rodata
        .align  4
        # words of two quadwords A and B
interleave:
        .int    0x00010203,0x10111213,0x04050607,0x14151617 # A0 B0 A1 B1
low:    .int    0x00010203,0x04050607,0x10111213,0x14151617 # A0 A1 B0 B1
high:   .int    0x08090a0b,0x0c0d0e0f,0x18191a1b,0x1c1d1e1f # A2 A3 B2 B3
third:  .int    0x08090a0b,0x18191a1b,0x08090a0b,0x18191a1b # A2 B2 A2 B2

function pack_sums
        .set count_2,79; .set left_2,2; .set a_sums_2,5; .set t_step_2,9; .set sum0_2,2
        .set left_3,7; .set sum1_2,8; .set sum2_2,9; .set sum3_2,3; .set t_step_3,20; .set b23_2,21
        .set green_2,7; .set a_sums_3,22; .set blue_2,21; .set b23_3,8; .set blue_3,7; .set red_2,2
        .set sum1_3,23; .set red_3,28; .set sum2_3,24; .set green_3,29; .set sum3_3,5
        .set green_4,26; .set blue_4,8; .set a_pixels_2,2; .set green_5,3; .set a_pixels_3,5
        .set a_sums_4,2; .set t_step_4,5
        mpyu    $count,$rows,$row_bytes                 # 0e
        lqa     $m_interleave,interleave                # 0o
        shli    $skip,$row_bytes,2                      # 1e
        lqa     $m_low,low                              # 1o
        il      $t_step,0x400                           # 2e
        lqa     $m_high,high                            # 2o
        ilhu    $k_scale,0x3f7f                         # 3e 255/256
        lqa     $m_third,third                          # 3o
        ilhu    $k_half,0x3b00                          # 4e 1/512
        lqd     $m_red_green,0($a_shuffle)              # 4o
        sfi     $skip,$skip,0                           # 5e
        lqd     $m_blue,16($a_shuffle)                  # 5o
        ori     $left,$row_bytes,0                      # 6e
        rotmi   $count,$count,-4                        # 7e
        a       $skip,$skip,$t_step                     # 8e
        clgti   $count_2,$count,3                       # 11e at least as many passes as overlap
        nop     $127                                    # 12e pairing
        brz     $count_2,next_group_short               # 13o too few passes
        ai      $left_2,$left,-16                       # 14e
        lqd     $sum0,0($a_sums)                        # 14o
        ai      $a_sums_2,$a_sums,64                    # 15e
        lqd     $sum1,16($a_sums)                       # 15o
        ceqi    $c_end,$left_2,0                        # 16e
        lqd     $sum2,32($a_sums)                       # 16o
        ai      $count,$count,-1                        # 17e
        lqd     $sum3,48($a_sums)                       # 17o
        and     $t_step_2,$c_end,$skip                  # 18e
        hbrr    next_group_back,next_group              # 18o hint
        and     $t_step,$c_end,$row_bytes               # 19e
        a       $a_sums,$a_sums_2,$t_step_2             # 20e
        a       $left,$left_2,$t_step                   # 21e
        shufb   $rg01,$sum0,$sum1,$m_interleave         # 21o
        ai      $a_sums_2,$a_sums,64                    # 22e
        lqd     $sum0_2,0($a_sums)                      # 22o
        ai      $left_3,$left,-16                       # 23e
        shufb   $rg23,$sum2,$sum3,$m_interleave         # 23o
        ai      $count,$count,-1                        # 24e
        lqd     $sum1_2,16($a_sums)                     # 24o
        ceqi    $c_end,$left_3,0                        # 25e
        lqd     $sum2_2,32($a_sums)                     # 25o
        ai      $count,$count,-1                        # 26e
        lqd     $sum3_2,48($a_sums)                     # 26o
        and     $t_step_3,$c_end,$skip                  # 27e
        shufb   $b01,$sum0,$sum1,$m_third               # 27o
        and     $t_step,$c_end,$row_bytes               # 28e
        shufb   $b23_2,$sum2,$sum3,$m_third             # 28o
        a       $a_sums_2,$a_sums_2,$t_step_3           # 29e
        shufb   $red,$rg01,$rg23,$m_low                 # 29o
        a       $left,$left_3,$t_step                   # 30e
        shufb   $green_2,$rg01,$rg23,$m_high            # 30o
        ai      $a_sums_3,$a_sums_2,64                  # 31e
        shufb   $rg01,$sum0_2,$sum1_2,$m_interleave     # 31o
        ai      $left,$left,-16                         # 32e
        shufb   $blue_2,$b01,$b23_2,$m_low              # 32o
        fma     $red,$red,$k_scale,$k_half              # 33e
        shufb   $rg23,$sum2_2,$sum3_2,$m_interleave     # 33o
        fma     $green,$green_2,$k_scale,$k_half        # 34e
        shufb   $b01,$sum0_2,$sum1_2,$m_third           # 34o
        ceqi    $c_end,$left,0                          # 35e
        shufb   $b23_3,$sum2_2,$sum3_2,$m_third         # 35o
        fma     $blue_3,$blue_2,$k_scale,$k_half        # 36e
        lqd     $sum0,0($a_sums_2)                      # 36o
        and     $t_step,$c_end,$row_bytes               # 37e
        shufb   $red_2,$rg01,$rg23,$m_low               # 37o
        and     $t_step_2,$c_end,$skip                  # 38e
        lqd     $sum1_3,16($a_sums_2)                   # 38o
        cfltu   $red_3,$red,32                          # 39e
        lqd     $sum2_3,32($a_sums_2)                   # 39o
        cfltu   $green_3,$green,32                      # 40e
        lqd     $sum3_3,48($a_sums_2)                   # 40o
        a       $left,$left,$t_step                     # 41e
        shufb   $green_4,$rg01,$rg23,$m_high            # 41o
        fma     $red_2,$red_2,$k_scale,$k_half          # 42e
        shufb   $blue_4,$b01,$b23_3,$m_low              # 42o
        cfltu   $blue,$blue_3,32                        # 43e
        lnop                                            # 43o pairing
        a       $a_sums,$a_sums_3,$t_step_2             # 44e
        shufb   $rg01,$sum0,$sum1_3,$m_interleave       # 44o
        fma     $green,$green_4,$k_scale,$k_half        # 45e
        shufb   $b01,$sum0,$sum1_3,$m_third             # 45o
        fma     $blue_3,$blue_4,$k_scale,$k_half        # 46e
        shufb   $rg23,$sum2_3,$sum3_3,$m_interleave     # 46o
        nop     $127                                    # 47e pairing
        shufb   $pixels,$red_3,$green_3,$m_red_green    # 47o
        cfltu   $red_3,$red_2,32                        # 48e
        shufb   $b23_3,$sum2_3,$sum3_3,$m_third         # 48o
        nop     $127                                    # 49e pairing
        shufb   $pixels,$pixels,$blue,$m_blue           # 51o
next_group:
        ai      $left_2,$left,-16                       # 0e
            shufb   $red,$rg01,$rg23,$m_low             # 0o
            cfltu   $green,$green,32                    # 1e
            stqd    $pixels,0($a_pixels)                # 1o
            cfltu   $blue,$blue_3,32                    # 2e
        lqd     $sum0,0($a_sums)                        # 2o
        ai      $a_sums_2,$a_sums,64                    # 3e
        lqd     $sum1,16($a_sums)                       # 3o
        ceqi    $c_end,$left_2,0                        # 4e
        lqd     $sum2,32($a_sums)                       # 4o
            fma     $red,$red,$k_scale,$k_half          # 5e
        lqd     $sum3,48($a_sums)                       # 5o
        and     $t_step,$c_end,$row_bytes               # 6e
            shufb   $green_2,$rg01,$rg23,$m_high        # 6o
        ai      $count,$count,-1                        # 7e
            shufb   $blue_4,$b01,$b23_3,$m_low          # 7o
        and     $t_step_2,$c_end,$skip                  # 8e
            shufb   $pixels,$red_3,$green,$m_red_green  # 8o
            ai      $a_pixels,$a_pixels,16              # 9e
        shufb   $rg01,$sum0,$sum1,$m_interleave         # 9o
            fma     $green,$green_2,$k_scale,$k_half    # 10e
        shufb   $b01,$sum0,$sum1,$m_third               # 10o
            fma     $blue_3,$blue_4,$k_scale,$k_half    # 11e
        shufb   $rg23,$sum2,$sum3,$m_interleave         # 11o
        a       $left,$left_2,$t_step                   # 12e
            shufb   $pixels,$pixels,$blue,$m_blue       # 12o
            cfltu   $red_3,$red,32                      # 13e
        shufb   $b23_3,$sum2,$sum3,$m_third             # 13o
        a       $a_sums,$a_sums_2,$t_step_2             # 14e
next_group_back:
        brnz    $count,next_group                       # 14o
next_group_drain:
        cfltu   $green,$green,32                        # 0e
        shufb   $red,$rg01,$rg23,$m_low                 # 0o
        cfltu   $blue,$blue_3,32                        # 1e
        shufb   $green_2,$rg01,$rg23,$m_high            # 1o
        ai      $a_pixels_2,$a_pixels,16                # 2e
        shufb   $blue_4,$b01,$b23_3,$m_low              # 2o
        nop     $127                                    # 3e pairing
        hbr     pack_sums_return,$lr                    # 3o hint
        fma     $red,$red,$k_scale,$k_half              # 4e
        stqd    $pixels,0($a_pixels)                    # 4o
        fma     $green_5,$green_2,$k_scale,$k_half      # 5e
        fma     $blue_3,$blue_4,$k_scale,$k_half        # 6e
        ai      $a_pixels,$a_pixels_2,16                # 7e
        shufb   $pixels,$red_3,$green,$m_red_green      # 7o
        ai      $a_pixels_3,$a_pixels,16                # 9e
        cfltu   $red_3,$red,32                          # 10e
        cfltu   $green,$green_5,32                      # 11e
        shufb   $pixels,$pixels,$blue,$m_blue           # 11o
        cfltu   $blue,$blue_3,32                        # 12e
        stqd    $pixels,0($a_pixels_2)                  # 15o
        shufb   $pixels,$red_3,$green,$m_red_green      # 18o
        shufb   $pixels,$pixels,$blue,$m_blue           # 22o
        stqd    $pixels,0($a_pixels)                    # 26o
pack_sums_return:
        bi      $lr                                     # 27o
next_group_short:
        ai      $left,$left,-16                         # 0e
        lqd     $sum0,0($a_sums)                        # 0o
        ai      $a_sums_4,$a_sums,64                    # 1e
        lqd     $sum1,16($a_sums)                       # 1o
        ceqi    $c_end,$left,0                          # 2e
        lqd     $sum2,32($a_sums)                       # 2o
        ai      $count,$count,-1                        # 3e
        lqd     $sum3,48($a_sums)                       # 3o
        and     $t_step,$c_end,$skip                    # 4e
        and     $t_step_4,$c_end,$row_bytes             # 5e
        a       $a_sums,$a_sums_4,$t_step               # 6e
        lnop                                            # 6o pairing
        a       $left,$left,$t_step_4                   # 7e
        shufb   $rg01,$sum0,$sum1,$m_interleave         # 7o
        shufb   $b01,$sum0,$sum1,$m_third               # 8o
        shufb   $rg23,$sum2,$sum3,$m_interleave         # 9o
        shufb   $b23,$sum2,$sum3,$m_third               # 10o
        shufb   $red,$rg01,$rg23,$m_low                 # 13o
        shufb   $green,$rg01,$rg23,$m_high              # 14o
        shufb   $blue,$b01,$b23,$m_low                  # 15o
        fma     $red,$red,$k_scale,$k_half              # 17e
        fma     $green,$green,$k_scale,$k_half          # 18e
        fma     $blue,$blue,$k_scale,$k_half            # 19e
        cfltu   $red,$red,32                            # 23e
        cfltu   $green,$green,32                        # 24e
        cfltu   $blue,$blue,32                          # 25e
        shufb   $pixels,$red,$green,$m_red_green        # 31o
        shufb   $pixels,$pixels,$blue,$m_blue           # 35o
        nop     $127                                    # 36e pairing
        stqd    $pixels,0($a_pixels)                    # 39o
        ai      $a_pixels,$a_pixels,16                  # 40e
        brnz    $count,next_group_short                 # 40o
        nop     $127                                    # 41e pairing
        bi      $lr                                     # 41o
endfunction pack_sums
