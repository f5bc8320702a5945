# A word to the PPE by the interrupt mailbox, and its reply: by the inbound mailbox, or as a
# signal.
        .include "clock.inc"

        .macro  round_trips channel:req
        begins
1:      wrch    $ch30,$passes
        rdch    $20,$ch\channel
        ai      $passes,$passes,-1
        brnz    $passes,1b
        ends
        bi      $0
        .endm

        .text
        .global mail
mail:   round_trips 29

        .global signals
signals:
        round_trips 3
