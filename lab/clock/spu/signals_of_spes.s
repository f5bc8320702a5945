# Signals that two SPUs send each other by sndsig. SPU 0 sends first, the other one replies.
        .include "clock.inc"

        .text
        .global signals_of_spes
signals_of_spes:
        il      $20,1
        stqa    $20,LINE                # the word that is sent, in every slot
        begins
        brnz    $number,2f
1:      brsl    $2,send
        rdch    $20,$ch3
        ai      $passes,$passes,-1
        brnz    $passes,1b
        br      3f
2:      rdch    $20,$ch3
        brsl    $2,send
        ai      $passes,$passes,-1
        brnz    $passes,2b
3:      il      $20,1
        wait_tags $20,$21
        ends
        bi      $0

# Sends the word that has the register's place in its quadword.
send:   andi    $20,$ea_low,12
        ila     $21,LINE
        a       $20,$20,$21
        wrch    $ch16,$20
        wrch    $ch17,$ea_high
        wrch    $ch18,$ea_low
        il      $20,4
        wrch    $ch19,$20
        il      $20,0
        wrch    $ch20,$20
        il      $20,SNDSIG
        wrch    $ch21,$20
        bi      $2
