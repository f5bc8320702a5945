# Prints its arguments, which crt2.o's start code copies to the top of local store.
        .section .text.start,"ax",@progbits
        .align  3
        .global _start
_start: wrch    $ch16,$4
        rotqbyi $4,$4,4
        wrch    $ch17,$4
        rotqbyi $4,$4,4
        wrch    $ch18,$4
        rotqbyi $4,$4,4
        wrch    $ch19,$4
        rotqbyi $4,$4,4
        il      $0,0
        wrch    $ch20,$0
        il      $0,0x40
        wrch    $ch21,$0
        il      $0,1
        wrch    $ch22,$0
        il      $0,2
        wrch    $ch23,$0
        rdch    $0,$ch24
        il      $0,0
        ai      $sp,$4,-16
        stqd    $0,0($sp)
        stqd    $sp,-32($sp)
        ai      $sp,$sp,-32
        brsl    $lr,main
        brsl    $lr,exit

        .set    own_start,1
        .include "runtime.inc"

        .type   main,@function
main:
        enter
        ori     $80,$3,0
        ori     $81,$4,0
        ai      $82,$3,-1
each:   lqd     $3,0($81)
        rotqby  $3,$3,$81
        brsl    $lr,puts
        ai      $81,$81,4
        ai      $82,$82,-1
        brnz    $82,each
        lqd     $3,0($81)
        rotqby  $3,$3,$81
        brsl    $lr,puts
        ori     $3,$80,0
        leave
