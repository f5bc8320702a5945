# dot   the dot product of two arrays of floats, four sums at once
#   In      $3 first array, $4 second, 16-aligned; $5 how many quadwords of each, a multiple of 4
#   Out     $3 the product, in the preferred slot
#   Uses    $3-$18
        .text
        .align  3
        .global dot
        .type   dot, @function
dot:
        il      $6,0                            # sixteen sums, four a register
        il      $7,0
        il      $8,0
        il      $9,0
        rotmi   $10,$5,-2                       # passes to go
next:
        lqd     $11,0($3)
        lqd     $12,0($4)
        lqd     $13,16($3)
        lqd     $14,16($4)
        lqd     $15,32($3)
        lqd     $16,32($4)
        lqd     $17,48($3)
        lqd     $18,48($4)
        fma     $6,$11,$12,$6
        fma     $7,$13,$14,$7
        fma     $8,$15,$16,$8
        fma     $9,$17,$18,$9
        ai      $3,$3,64
        ai      $4,$4,64
        ai      $10,$10,-1
        brnz    $10,next
        fa      $6,$6,$7
        fa      $8,$8,$9
        fa      $6,$6,$8
        rotqbyi $11,$6,8                        # the lanes' sum
        fa      $6,$6,$11
        rotqbyi $12,$6,4
        fa      $3,$6,$12
        bi      $lr
        .size   dot, .-dot
