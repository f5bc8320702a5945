# writes   its scheduled version writes something else
#   C       void writes(int *);
        .text
        .align  3
        .global writes
writes:
        il      $4,1
        stqd    $4,0($3)
        bi      $lr
