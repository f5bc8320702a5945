# Gets 128 bytes from the effective address in $3, adds the word in $4 to each word, and puts them
# 128 bytes further on.
        .text
        .global _start
_start: rotqbyi $5,$3,4
        ila     $6,buffer
        il      $7,0x40
        brsl    $lr,transfer
        il      $8,112
        lqr     $10,splat
        shufb   $4,$4,$4,$10
each:   lqx     $11,$6,$8
        a       $11,$11,$4
        stqx    $11,$6,$8
        ai      $8,$8,-16
        brnz    $8,each
        lqx     $11,$6,$8
        a       $11,$11,$4
        stqx    $11,$6,$8
        ai      $5,$5,128
        il      $7,0x20
        brsl    $lr,transfer
        stop    0x2000

transfer:
        wrch    $ch16,$6
        wrch    $ch17,$3
        wrch    $ch18,$5
        il      $12,128
        wrch    $ch19,$12
        il      $12,3
        wrch    $ch20,$12
        wrch    $ch21,$7
        il      $12,8
        wrch    $ch22,$12
        il      $12,2
        wrch    $ch23,$12
        rdch    $12,$ch24
        bi      $lr

        .align  4
splat:  .long   0x00010203, 0x00010203, 0x00010203, 0x00010203
        .data
        .align  7
buffer: .space  128
