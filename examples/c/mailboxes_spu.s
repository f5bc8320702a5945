# Doubles each inbound word and replies by the interrupt mailbox. A 0 is the last word, after which
# the outbound mailbox gets their number.
        .text
        .global _start
_start: il      $4,0
next:   rdch    $3,$ch29
        ai      $4,$4,1
        a       $5,$3,$3
        wrch    $ch30,$5
        brnz    $3,next
        wrch    $ch28,$4
        stop    0x2000
