# The tracer's kernel pack_r16, its macros written out: colours of 4x4 pixels become words of the
# framebuffer. Schedule it, and compare the cycles of a pass.
        .text
        .align  3
        .global _start
        .type   _start, @function
_start:
        ila     $3,places
        il      $4,2
        ila     $5,colours
        ila     $6,shuffle
        il      $7,16
        brsl    $lr,pack_r16
        stop    0x2000
        .size   _start, .-_start

# pack_r16   colours of 4x4 pixels to the framebuffer's 32-bit words
#   In      $3 places, $4 count (at least 1), $5 their colours, $6 shuffle, $7 bytes from row to row
#   Out     four rows of a quadword each, for each place
#   Uses    $3-$5, $10-$27
        .align  3
        .global pack_r16
        .type   pack_r16, @function
pack_r16:
        ilhu    $10,0x3f7f                      # 255/256
        ilhu    $11,0x3b00                      # 1/512
        lqd     $12,0($6)
        lqd     $13,16($6)
next_packet:
        lqd     $15,0($3)
        rotqbyi $15,$15,4
        lqd     $16,0($5)                # red
        fma     $16,$16,$10,$11
        cfltu   $16,$16,32
        lqd     $17,64($5)                # green
        fma     $17,$17,$10,$11
        cfltu   $17,$17,32
        lqd     $18,128($5)                # blue
        fma     $18,$18,$10,$11
        cfltu   $18,$18,32
        shufb   $19,$16,$17,$12
        shufb   $19,$19,$18,$13
        stqd    $19,0($15)
        a       $15,$15,$7
        lqd     $16,16($5)                # red
        fma     $16,$16,$10,$11
        cfltu   $16,$16,32
        lqd     $17,80($5)                # green
        fma     $17,$17,$10,$11
        cfltu   $17,$17,32
        lqd     $18,144($5)                # blue
        fma     $18,$18,$10,$11
        cfltu   $18,$18,32
        shufb   $19,$16,$17,$12
        shufb   $19,$19,$18,$13
        stqd    $19,0($15)
        a       $15,$15,$7
        lqd     $16,32($5)                # red
        fma     $16,$16,$10,$11
        cfltu   $16,$16,32
        lqd     $17,96($5)                # green
        fma     $17,$17,$10,$11
        cfltu   $17,$17,32
        lqd     $18,160($5)                # blue
        fma     $18,$18,$10,$11
        cfltu   $18,$18,32
        shufb   $19,$16,$17,$12
        shufb   $19,$19,$18,$13
        stqd    $19,0($15)
        a       $15,$15,$7
        lqd     $16,48($5)                # red
        fma     $16,$16,$10,$11
        cfltu   $16,$16,32
        lqd     $17,112($5)                # green
        fma     $17,$17,$10,$11
        cfltu   $17,$17,32
        lqd     $18,176($5)                # blue
        fma     $18,$18,$10,$11
        cfltu   $18,$18,32
        shufb   $19,$16,$17,$12
        shufb   $19,$19,$18,$13
        stqd    $19,0($15)
        ai      $3,$3,16
        ai      $5,$5,192
        ai      $4,$4,-1
        brnz    $4,next_packet
        bi      $lr
        .size   pack_r16, .-pack_r16

        .data
        .align  4
places:                                         # a packet, its pixels, column, row
        .long   0,pixels,0,0
        .long   0,pixels+64,4,0
shuffle:
        .long   0x80001080,0x80041480,0x80081880,0x800c1c80
        .long   0x00010210,0x04050614,0x08090a18,0x0c0d0e1c
colours:                                        # red, green and blue of 16 pixels, twice
        .float  0,0.125,0.25,0.375
        .float  0,0.125,0.25,0.375
        .float  0,0.125,0.25,0.375
        .float  0,0.125,0.25,0.375
        .float  0,0,0,0
        .float  0.25,0.25,0.25,0.25
        .float  0.5,0.5,0.5,0.5
        .float  0.75,0.75,0.75,0.75
        .float  1,0.75,0.5,0.25
        .float  1,0.75,0.5,0.25
        .float  1,0.75,0.5,0.25
        .float  1,0.75,0.5,0.25
        .float  0.5,0.625,0.75,0.875
        .float  0.5,0.625,0.75,0.875
        .float  0.5,0.625,0.75,0.875
        .float  0.5,0.625,0.75,0.875
        .float  0,0,0,0
        .float  0.25,0.25,0.25,0.25
        .float  0.5,0.5,0.5,0.5
        .float  0.75,0.75,0.75,0.75
        .float  0,0,0,0
        .float  0,0,0,0
        .float  0,0,0,0
        .float  0,0,0,0
pixels: .space  128
