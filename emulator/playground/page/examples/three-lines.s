# Three lines: press Step, and watch $3.
        il      $3,40
        ai      $3,$3,2
        stop    0x2000
