# Calls three deep for the debugger: main calls outer, which calls inner twice and adds 1. The
# status is 2 * 3 + 1.
        .include "runtime.inc"

        .type   main,@function
main:
        enter
        il      $3,3
        brsl    $lr,outer
        leave
        .size   main,.-main

        .type   outer,@function
outer:
        enter
        stqd    $3,32($sp)
        brsl    $lr,inner
        lqd     $4,32($sp)
        stqd    $3,48($sp)
        ori     $3,$4,0
        brsl    $lr,inner
        lqd     $4,48($sp)
        a       $3,$3,$4
        ai      $3,$3,1
        leave
        .size   outer,.-outer

# A function without a frame.
        .type   inner,@function
inner:
        ori     $5,$3,0
        bi      $lr
        .size   inner,.-inner
