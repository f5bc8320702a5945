# lost   does not return
#   C       void lost(void);
        .text
        .align  3
        .global lost
lost:
        ila     $4,0x20000
        bi      $4
