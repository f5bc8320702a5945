# greedy   loses a register that it must keep
#   C       void greedy(void);
        .text
        .align  3
        .global greedy
greedy:
        ai      $90,$90,1
        bi      $lr
