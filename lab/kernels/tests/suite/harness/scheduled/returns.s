# returns   its scheduled version returns something else
#   C       int returns(void);
        .text
        .align  3
        .global returns
returns:
        il      $3,2
        bi      $lr
