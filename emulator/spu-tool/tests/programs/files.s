# Writes a file through a stream, reads it through a descriptor, and writes the data to standard
# output.
        .include "runtime.inc"

        .type   main,@function
main:
        enter
        ila     $3,name
        ila     $4,mode
        brsl    $lr,fopen
        ori     $80,$3,0
        ori     $4,$3,0
        ila     $3,text
        brsl    $lr,fputs
        ori     $3,$80,0
        brsl    $lr,fclose
        ila     $3,name
        il      $4,0
        brsl    $lr,open
        ori     $80,$3,0
        ila     $4,buffer
        il      $5,100
        brsl    $lr,read
        ori     $81,$3,0
        ori     $3,$80,0
        brsl    $lr,close
        il      $3,1
        ila     $4,buffer
        ori     $5,$81,0
        brsl    $lr,write
        # Opens a file that does not exist. The error number is the result.
        ila     $3,missing
        il      $4,0
        brsl    $lr,open
        ori     $3,$4,0
        leave

        .section .rodata
        .align  4
name:   .asciz  "written.txt"
missing: .asciz "missing.txt"
mode:   .asciz  "w"
text:   .asciz  "through a file\n"
        .section .bss,"aw",@nobits
        .align  4
buffer: .space  128
