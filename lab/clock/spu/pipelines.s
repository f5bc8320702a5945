# Loops that use no memory: what branches, hints and double precision cost.
        .include "clock.inc"

        .text
        .balign 8
# A hint, and its branch as soon as the hint can be seen: ten odd instructions are between them.
        .global hinted_loop
hinted_loop:
        begins
        lnop
        .balign 8
1:      hbrr    2f,1b
        ai      $passes,$passes,-1
        .rept   9
        lnop
        .endr
2:      brnz    $passes,1b
        ends
        bi      $0

        .balign 8
# A taken branch without a hint, a hundred times a pass. Each jumps over an instruction, because
# the next one is what the SPU fetches anyway.
        .global taken_branches
taken_branches:
        begins
1:      .rept   100
        br      2f
        lnop
2:
        .endr
        ai      $passes,$passes,-1
        brnz    $passes,1b
        ends
        bi      $0

        .balign 8
# A hundred pairs of dfma and lnop a pass. Two sums take turns, so none waits for the one before.
        .global double_pairs
double_pairs:
        begins
        .balign 8
1:      .rept   50
        dfma    $20,$21,$22
        lnop
        dfma    $23,$21,$22
        lnop
        .endr
        ai      $passes,$passes,-1
        brnz    $passes,1b
        ends
        bi      $0
