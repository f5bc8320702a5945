# follows   adds 2 to a word, and so does its scheduled version
#   C       int follows(int *);
        .text
        .align  3
        .global follows
follows:
        lqd     $5,0($3)
        ai      $5,$5,2
        stqd    $5,0($3)
        lr      $3,$5
        bi      $lr
