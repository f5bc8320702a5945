# Reads words from the PPE until a 0, and sends back how long each took, in ticks of the
# decrementer. Type the PPE's words into "Mailboxes", below: with none, the SPU waits.
next:   rdch    $3,$SPU_RdInMbox
        brz     $3,done
        il      $4,-1
        wrch    $SPU_WrDec,$4
work:   ai      $3,$3,-1
        brnz    $3,work
        rdch    $5,$SPU_RdDec
        sf      $5,$5,$4
        wrch    $SPU_WrOutMbox,$5
        br      next
done:   stop    0x2000
