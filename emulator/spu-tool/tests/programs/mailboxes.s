# Doubles each inbound word and writes it to the outbound mailbox. A 0 ends it, with the count in
# the interrupt mailbox.
        .text
        .global _start
_start: il      $4,0
next:   rdch    $3,$ch29
        brz     $3,done
        a       $3,$3,$3
        wrch    $ch28,$3
        ai      $4,$4,1
        br      next
done:   wrch    $ch30,$4
        stop    0x2000
