# pack_r16   colours of 4x4 pixels to the framebuffer's 32-bit words
#   C       void pack_r16(const struct place *, int count, const struct colours *,
#                         const struct pixel_shuffle *, int pitch);
#   In      $3 places, $4 count (at least 1), $5 their colours, in order, $6 shuffle, $7 bytes from
#           row to row of the tile buffer; pointers and pitch multiples of 16
#   Out     the places' pixels, four rows of a quadword each
#   Uses    $2-$6, $8-$34, $79   Saves  -   Stack  0   Calls  -
#   Domain  any colour: below 0 is 0, above 1 is 1
#   Error   0.50001 of 255, each channel
#   Twin    lab/twins/src/pack.rs
#
#   channel = floor(min(c, 1) 255 + 1/2)
# The conversion to an unsigned integer saturates, so after scaling by 2^32 / 256 it also clamps.
# The channel is the highest byte of floor((c 255/256 + 1/512) 2^32).
# Scheduled by spu schedule from pack_r16.s

        .include "work_unit.inc"
        .include "macros.inc"

        .set    NEXT,3
        registers a_place,count,a_colours,a_shuffle,pitch
        # constants
        .set    NEXT,10
        registers k_scale,k_half,m_red_green,m_blue
        # a row
        .set    NEXT,15
        registers a_row,red,green,blue,pixels

.macro  channel name:req, row:req
        lqd     $\name,COLOURS_\name+16*\row($a_colours)
        fma     $\name,$\name,$k_scale,$k_half
        cfltu   $\name,$\name,32
.endm

function pack_r16
        .set count_2,79; .set red_2,9; .set green_2,14; .set green_3,20; .set red_3,21
        .set green_4,24; .set blue_2,26; .set red_4,27; .set green_5,23; .set blue_3,25
        .set blue_4,28; .set blue_5,29; .set red_5,6; .set a_row_2,26; .set red_6,30
        .set green_6,32; .set a_row_3,31; .set red_7,33; .set blue_6,34; .set blue_7,27
        .set blue_8,17; .set blue_9,2; .set pixels_2,6; .set blue_10,8; .set a_row_4,22
        .set pixels_3,30; .set pixels_4,17; .set pixels_5,2; .set pixels_6,8; .set green_7,2
        .set blue_11,4; .set a_row_5,2; .set pixels_7,3; .set red_8,2; .set green_8,6; .set red_9,8
        .set green_9,9; .set red_10,14; .set green_10,15; .set blue_12,19; .set blue_13,20
        .set blue_14,21; .set pixels_8,16; .set blue_15,6; .set a_row_6,20; .set a_row_7,9
        .set pixels_9,14; .set pixels_10,15; .set a_row_8,16
        clgti   $count_2,$count,1                       # 0e at least as many passes as overlap
        lqd     $m_red_green,0($a_shuffle)              # 0o
        ilhu    $k_scale,0x3f7f                         # 1e 255/256
        lqd     $m_blue,16($a_shuffle)                  # 1o
        ilhu    $k_half,0x3b00                          # 2e 1/512
        brz     $count_2,next_packet_short              # 2o too few passes
        ai      $count,$count,-1                        # 3e
        lqd     $red,16($a_colours)                     # 3o
        lqd     $red_2,32($a_colours)                   # 4o
        lqd     $green_2,112($a_colours)                # 5o
        lqd     $green_3,80($a_colours)                 # 6o
        lqd     $red_3,48($a_colours)                   # 7o
        nop     $127                                    # 8e pairing
        lqd     $green_4,96($a_colours)                 # 8o
        fma     $red,$red,$k_scale,$k_half              # 9e
        lqd     $blue_2,128($a_colours)                 # 9o
        fma     $red_2,$red_2,$k_scale,$k_half          # 10e
        lqd     $red_4,0($a_colours)                    # 10o
        fma     $green_2,$green_2,$k_scale,$k_half      # 11e
        hbrr    next_packet_back,next_packet            # 11o hint
        fma     $green_3,$green_3,$k_scale,$k_half      # 12e
        lqd     $green_5,64($a_colours)                 # 12o
        fma     $red_3,$red_3,$k_scale,$k_half          # 13e
        lqd     $blue_3,160($a_colours)                 # 13o
        fma     $green_4,$green_4,$k_scale,$k_half      # 14e
        lqd     $blue_4,144($a_colours)                 # 14o
        fma     $blue,$blue_2,$k_scale,$k_half          # 15e
        lqd     $blue_5,176($a_colours)                 # 15o
        fma     $red_5,$red_4,$k_scale,$k_half          # 16e
        lqd     $a_row_2,0($a_place)                    # 16o
        cfltu   $red_2,$red_2,32                        # 17e
        cfltu   $green_3,$green_3,32                    # 18e
        cfltu   $red,$red,32                            # 19e
        cfltu   $green_4,$green_4,32                    # 20e
        cfltu   $red_6,$red_3,32                        # 21e
        lnop                                            # 21o pairing
        cfltu   $green_6,$green_2,32                    # 22e
        rotqbyi $a_row_3,$a_row_2,4                     # 22o
        cfltu   $red_7,$red_5,32                        # 23e
        cfltu   $blue_6,$blue,32                        # 24e
        ai      $a_colours,$a_colours,192               # 25e
        fma     $green_5,$green_5,$k_scale,$k_half      # 26e
        fma     $blue_3,$blue_3,$k_scale,$k_half        # 27e
        fma     $blue_7,$blue_4,$k_scale,$k_half        # 28e
        fma     $blue_8,$blue_5,$k_scale,$k_half        # 29e
        lnop                                            # 29o pairing
next_packet:
            cfltu   $blue,$blue_3,32                    # 0e
            shufb   $pixels,$red_2,$green_4,$m_red_green # 0o
            cfltu   $blue_9,$blue_7,32                  # 1e
            shufb   $pixels_2,$red,$green_3,$m_red_green # 1o
            cfltu   $blue_10,$blue_8,32                 # 2e
        lqd     $red,16($a_colours)                     # 2o
            ai      $a_place,$a_place,16                # 3e
        lqd     $red_2,32($a_colours)                   # 3o
            cfltu   $green,$green_5,32                  # 4e
        lqd     $green_2,112($a_colours)                # 4o
            a       $a_row,$a_row_3,$pitch              # 5e
        lqd     $green_3,80($a_colours)                 # 5o
        ai      $count,$count,-1                        # 6e
        lqd     $red_3,48($a_colours)                   # 6o
            a       $a_row_4,$a_row,$pitch              # 7e
        lqd     $green_5,64($a_colours)                 # 7o
        fma     $red,$red,$k_scale,$k_half              # 8e
        lqd     $green_4,96($a_colours)                 # 8o
        fma     $red_2,$red_2,$k_scale,$k_half          # 9e
        lqd     $blue_3,160($a_colours)                 # 9o
        fma     $green_2,$green_2,$k_scale,$k_half      # 10e
        lqd     $blue_2,128($a_colours)                 # 10o
        fma     $green_3,$green_3,$k_scale,$k_half      # 11e
        lqd     $red_4,0($a_colours)                    # 11o
        fma     $red_3,$red_3,$k_scale,$k_half          # 12e
        lqd     $blue_4,144($a_colours)                 # 12o
        fma     $green_5,$green_5,$k_scale,$k_half      # 13e
        lqd     $blue_5,176($a_colours)                 # 13o
        ai      $a_colours,$a_colours,192               # 14e
            shufb   $pixels_3,$red_6,$green_6,$m_red_green # 14o
        fma     $green_4,$green_4,$k_scale,$k_half      # 15e
            shufb   $pixels_4,$red_7,$green,$m_red_green # 15o
        fma     $blue_3,$blue_3,$k_scale,$k_half        # 16e
            shufb   $pixels,$pixels,$blue,$m_blue       # 16o
        fma     $blue,$blue_2,$k_scale,$k_half          # 17e
            shufb   $pixels_5,$pixels_2,$blue_9,$m_blue # 17o
        fma     $red_5,$red_4,$k_scale,$k_half          # 18e
        lqd     $a_row_2,0($a_place)                    # 18o
        fma     $blue_7,$blue_4,$k_scale,$k_half        # 19e
            shufb   $pixels_6,$pixels_3,$blue_10,$m_blue # 19o
        cfltu   $green_3,$green_3,32                    # 20e
            shufb   $pixels_4,$pixels_4,$blue_6,$m_blue # 20o
        cfltu   $green_4,$green_4,32                    # 21e
            stqd    $pixels,0($a_row_4)                 # 21o
        cfltu   $red_2,$red_2,32                        # 22e
            stqd    $pixels_5,0($a_row)                 # 22o
        cfltu   $red,$red,32                            # 23e
        lnop                                            # 23o pairing
        cfltu   $red_6,$red_3,32                        # 24e
            stqd    $pixels_4,0($a_row_3)               # 24o
            a       $a_row,$a_row_4,$pitch              # 25e
        rotqbyi $a_row_3,$a_row_2,4                     # 25o
        fma     $blue_8,$blue_5,$k_scale,$k_half        # 26e
        lnop                                            # 26o pairing
        cfltu   $green_6,$green_2,32                    # 27e
            stqd    $pixels_6,0($a_row)                 # 27o
        cfltu   $red_7,$red_5,32                        # 28e
        lnop                                            # 28o pairing
        cfltu   $blue_6,$blue,32                        # 29e
next_packet_back:
        brnz    $count,next_packet                      # 29o
next_packet_drain:
        cfltu   $green_7,$green_5,32                    # 0e
        hbr     pack_r16_return,$lr                     # 0o hint
        cfltu   $blue,$blue_3,32                        # 1e
        shufb   $pixels,$red_2,$green_4,$m_red_green    # 1o
        cfltu   $blue_11,$blue_7,32                     # 2e
        shufb   $pixels_2,$red,$green_3,$m_red_green    # 2o
        cfltu   $blue_10,$blue_8,32                     # 3e
        shufb   $pixels_3,$red_6,$green_6,$m_red_green  # 3o
        a       $a_row,$a_row_3,$pitch                  # 4e
        ai      $a_place,$a_place,16                    # 5e
        a       $a_row_4,$a_row,$pitch                  # 6e
        shufb   $pixels_4,$red_7,$green_7,$m_red_green  # 7o
        a       $a_row_5,$a_row_4,$pitch                # 8e
        shufb   $pixels,$pixels,$blue,$m_blue           # 8o
        shufb   $pixels_7,$pixels_2,$blue_11,$m_blue    # 9o
        shufb   $pixels_6,$pixels_3,$blue_10,$m_blue    # 10o
        shufb   $pixels_4,$pixels_4,$blue_6,$m_blue     # 11o
        stqd    $pixels,0($a_row_4)                     # 12o
        stqd    $pixels_7,0($a_row)                     # 13o
        stqd    $pixels_4,0($a_row_3)                   # 15o
        stqd    $pixels_6,0($a_row_5)                   # 16o
pack_r16_return:
        bi      $lr                                     # 17o
next_packet_short:
        ai      $count,$count,-1                        # 0e
        lqd     $red,0($a_colours)                      # 0o
        lqd     $green,64($a_colours)                   # 1o
        lqd     $red_8,16($a_colours)                   # 2o
        lqd     $green_8,80($a_colours)                 # 3o
        lqd     $red_9,32($a_colours)                   # 4o
        nop     $127                                    # 5e pairing
        lqd     $green_9,96($a_colours)                 # 5o
        fma     $red,$red,$k_scale,$k_half              # 6e
        lqd     $red_10,48($a_colours)                  # 6o
        fma     $green,$green,$k_scale,$k_half          # 7e
        lqd     $green_10,112($a_colours)               # 7o
        fma     $red_8,$red_8,$k_scale,$k_half          # 8e
        lqd     $blue,128($a_colours)                   # 8o
        fma     $green_8,$green_8,$k_scale,$k_half      # 9e
        lqd     $blue_12,144($a_colours)                # 9o
        fma     $red_9,$red_9,$k_scale,$k_half          # 10e
        lqd     $blue_13,160($a_colours)                # 10o
        fma     $green_9,$green_9,$k_scale,$k_half      # 11e
        lqd     $blue_14,176($a_colours)                # 11o
        fma     $red_10,$red_10,$k_scale,$k_half        # 12e
        lqd     $a_row_4,0($a_place)                    # 12o
        fma     $green_10,$green_10,$k_scale,$k_half    # 13e
        fma     $blue,$blue,$k_scale,$k_half            # 14e
        fma     $blue_12,$blue_12,$k_scale,$k_half      # 15e
        fma     $blue_13,$blue_13,$k_scale,$k_half      # 16e
        fma     $blue_14,$blue_14,$k_scale,$k_half      # 17e
        lnop                                            # 17o pairing
        cfltu   $red,$red,32                            # 18e
        rotqbyi $a_row_4,$a_row_4,4                     # 18o
        cfltu   $green,$green,32                        # 19e
        cfltu   $red_8,$red_8,32                        # 20e
        cfltu   $green_8,$green_8,32                    # 21e
        cfltu   $red_9,$red_9,32                        # 22e
        cfltu   $green_9,$green_9,32                    # 23e
        cfltu   $red_10,$red_10,32                      # 24e
        cfltu   $green_10,$green_10,32                  # 25e
        lnop                                            # 25o pairing
        cfltu   $blue,$blue,32                          # 26e
        shufb   $pixels_8,$red,$green,$m_red_green      # 26o
        cfltu   $blue_8,$blue_12,32                     # 27e
        lnop                                            # 27o pairing
        cfltu   $blue_12,$blue_13,32                    # 28e
        shufb   $pixels_5,$red_8,$green_8,$m_red_green  # 28o
        cfltu   $blue_15,$blue_14,32                    # 29e
        lnop                                            # 29o pairing
        a       $a_row_6,$a_row_4,$pitch                # 30e
        shufb   $pixels_6,$red_9,$green_9,$m_red_green  # 30o
        ai      $a_place,$a_place,16                    # 31e
        lnop                                            # 31o pairing
        a       $a_row_7,$a_row_6,$pitch                # 32e
        shufb   $pixels_9,$red_10,$green_10,$m_red_green # 32o
        ai      $a_colours,$a_colours,192               # 33e
        shufb   $pixels_10,$pixels_8,$blue,$m_blue      # 33o
        a       $a_row_8,$a_row_7,$pitch                # 34e
        shufb   $pixels_5,$pixels_5,$blue_8,$m_blue     # 34o
        shufb   $pixels,$pixels_6,$blue_12,$m_blue      # 35o
        shufb   $pixels_2,$pixels_9,$blue_15,$m_blue    # 36o
        stqd    $pixels_10,0($a_row_4)                  # 37o
        stqd    $pixels_5,0($a_row_6)                   # 38o
        stqd    $pixels,0($a_row_7)                     # 39o
        stqd    $pixels_2,0($a_row_8)                   # 40o
        nop     $127                                    # 41e pairing
        brnz    $count,next_packet_short                # 41o
        nop     $127                                    # 42e pairing
        bi      $lr                                     # 42o
endfunction pack_r16
