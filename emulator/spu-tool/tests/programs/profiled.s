# The work of the run time of a program compiled with -pg, with the PPE and with interrupts:
# it asks /proc/cpuinfo for the time base and Linux for the process, samples the program counter by
# the decrementer's interrupt into a file, and counts calls of _mcount in effective address space.
        .set    own_start,1
        .include "runtime.inc"

        .set    DECREMENTER_EVENT,0x20
        .set    SAMPLES,5

# An interrupt continues at address 0.
        .section .text.start,"ax",@progbits
        br      sample
        .global _start
_start: ila     $sp,__stack
        il      $lr,0
        stqd    $lr,0($sp)
        stqd    $sp,-32($sp)
        ai      $sp,$sp,-32
        brsl    $lr,main
        brsl    $lr,exit

        .text
        library fgets, 0x2100, 8
        library ftruncate, 0x2101, 28
        library pread, 0x2101, 65
        library pwrite, 0x2101, 66
        variadic sscanf, 2, 41

# Adds 1 to the sample's counter in the file. Registers that the library calls change are saved.
sample:
        .irp    register, 0, 3, 4, 5, 6, 75, 76, 77, 78, 79
        stqr    $\register,kept+16*\register
        .endr
        rdch    $3,$ch0
        wrch    $ch2,$3
        lqr     $4,interval
        wrch    $ch7,$4
        rdch    $3,$ch15
        andi    $3,$3,-4
        rotmi   $81,$3,-1
        lqr     $3,file
        ila     $4,count
        il      $5,2
        ori     $6,$81,0
        brsl    $lr,pread
        lqr     $4,count
        ila     $5,0x10000
        a       $4,$4,$5
        stqr    $4,count
        lqr     $3,file
        ila     $4,count
        il      $5,2
        ori     $6,$81,0
        brsl    $lr,pwrite
        lqr     $3,samples
        ai      $3,$3,1
        stqr    $3,samples
        .irp    register, 0, 3, 4, 5, 6, 75, 76, 77, 78, 79
        lqr     $\register,kept+16*\register
        .endr
        irete

# A function that was compiled with -pg begins with this call, by $75.
work:   brsl    $75,_mcount
        bi      $lr

# Counts in effective address space, by DMA, without interrupts.
_mcount:
        ila     $70,counting
        bid     $70
counting:
        ila     $70,arcs
        wrch    $ch16,$70
        lqr     $71,heap
        il      $73,0
        wrch    $ch17,$73
        wrch    $ch18,$71
        il      $72,16
        wrch    $ch19,$72
        wrch    $ch20,$73
        il      $72,0x40
        wrch    $ch21,$72
        il      $72,1
        wrch    $ch22,$72
        il      $72,2
        wrch    $ch23,$72
        rdch    $72,$ch24
        lqr     $72,arcs
        ai      $72,$72,1
        stqr    $72,arcs
        wrch    $ch16,$70
        wrch    $ch17,$73
        wrch    $ch18,$71
        il      $72,16
        wrch    $ch19,$72
        wrch    $ch20,$73
        il      $72,0x20
        wrch    $ch21,$72
        il      $72,2
        wrch    $ch23,$72
        rdch    $72,$ch24
        bie     $75

        .type   main,@function
main:
        enter
        ila     $3,cpuinfo
        ila     $4,read_mode
        brsl    $lr,fopen
        ori     $80,$3,0
line:   ila     $3,buffer
        il      $4,64
        ori     $5,$80,0
        brsl    $lr,fgets
        brz     $3,no_time_base
        ila     $3,buffer
        ila     $4,pattern
        ila     $5,time_base
        brsl    $lr,sscanf
        brz     $3,line
        ori     $3,$80,0
        brsl    $lr,fclose
        stop    0x2104
        .long   getpid
        lqr     $3,quadword
        brsl    $lr,malloc_ea
        # The address is in two words.
        lqd     $3,0($5)
        rotqbyi $3,$3,4
        stqr    $3,heap
        ila     $3,name
        il      $4,0x242
        il      $5,0644
        brsl    $lr,open
        stqr    $3,file
        il      $4,0x1000
        brsl    $lr,ftruncate
        # Some thousand samples a second.
        lqr     $4,time_base
        rotmi   $4,$4,-12
        stqr    $4,interval
        wrch    $ch7,$4
        il      $5,DECREMENTER_EVENT
        wrch    $ch1,$5
        ila     $6,sampled
        bie     $6
sampled:
        brsl    $lr,work
        lqr     $3,samples
        clgti   $3,$3,SAMPLES-1
        brz     $3,sampled
        ila     $6,disabled
        bid     $6
disabled:
        il      $5,0
        wrch    $ch1,$5
        ila     $3,result
        lqr     $4,time_base
        lqr     $5,getpid
        rotqbyi $5,$5,4
        lqr     $6,arcs
        brsl    $lr,printf
        il      $3,0
        leave
no_time_base:
        il      $3,1
        leave

        .section .rodata
        .align  4
quadword: .quad 16, 0
cpuinfo: .asciz "/proc/cpuinfo"
read_mode: .asciz "r"
pattern: .asciz "timebase : %u"
name:   .asciz  "gmon.out"
result: .asciz  "%u %d %d\n"
        .data
        .align  4
getpid: .quad   20, 0, 0, 0, 0, 0, 0
        .section .bss,"aw",@nobits
        .align  4
interval: .space 16
file:   .space  16
count:  .space  16
samples: .space 16
heap:   .space  16
arcs:   .space  16
time_base: .space 16
buffer: .space  64
kept:   .space  16*80
