# Adds a word of the inbound mailbox and one of the first signal register, and sends the sum.
        .text
        .global _start
_start: rdch    $3,$ch29
        rdch    $4,$ch3
        a       $5,$3,$4
        wrch    $ch28,$5
        stop    0x2000
