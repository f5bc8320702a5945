# Two instructions issue in one cycle if the first, at a multiple of 8, belongs to the even pipe
# and the second to the odd one. Exchange the two lines of a pair, and see what that costs.
_start:
        ila     $3,numbers
        nop
        il      $10,1                   # even
        lqd     $4,0($3)                # odd: both issue in one cycle
        il      $11,2
        lqd     $5,16($3)
        a       $6,$4,$5                # waits for the loads, which take 6 cycles
        stqd    $6,32($3)               # waits for the sum
        stop    0x2000

        .data
        .align  4
numbers:
        .long   1,2,3,4
        .long   10,20,30,40
        .space  16
