# dot   the dot product of two arrays of floats
#   In      $3 first array, $4 second, 16-aligned; $5 how many quadwords of each, at least 1
#   Out     $3 the product, in the preferred slot
#   Uses    $3-$13
        .text
        .align  3
        .global dot
        .type   dot, @function
dot:
        il      $6,0                            # four sums, one a lane
        ori     $7,$5,0                         # quadwords to go
next:
        lqd     $8,0($3)
        lqd     $9,0($4)
        fma     $6,$8,$9,$6
        ai      $3,$3,16
        ai      $4,$4,16
        ai      $7,$7,-1
        brnz    $7,next
        rotqbyi $10,$6,8                        # the lanes' sum
        fa      $6,$6,$10
        rotqbyi $11,$6,4
        fa      $3,$6,$11
        bi      $lr
        .size   dot, .-dot
