# Sends ten numbers by the interrupt mailbox, from the one in the inbound mailbox on. Ends with the
# exit code 10.
        .text
        .global _start
_start: rdch    $3,$ch29
        il      $4,10
next:   wrch    $ch30,$3
        ai      $3,$3,1
        ai      $4,$4,-1
        brnz    $4,next
        stop    0x200a
