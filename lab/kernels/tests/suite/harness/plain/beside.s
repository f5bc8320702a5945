# beside   writes after its buffer of a quadword
#   C       void beside(int *);
        .text
        .align  3
        .global beside
beside:
        stqd    $3,16($3)
        bi      $lr
