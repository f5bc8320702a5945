# good   adds 1 to a word
#   C       int good(int *);
        .text
        .align  3
        .global good
good:
        lqd     $5,0($3)
        ai      $5,$5,1
        stqd    $5,0($3)
        lr      $3,$5
        bi      $lr
