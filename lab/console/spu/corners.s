# Runs the instructions whose results docs/emulator.md calls open or fair, and stores for each the
# result, the FPSCR and a name. Argument: the effective address of 12 KB.
        .set    NAMES_AT, 0x1000        # the offset of the names from the argument
        .set    PUT, 0x20
        .set    GETL, 0x44
        .set    SDCRZ, 0x89

        # A name has 64 bytes, a result 32: the value and the FPSCR.
        .section .rodata
        .balign 128
names:
        .section .data
        .balign 128
results:
        .fill   128*32,1,0

# A constant of four words.
        .macro  words register:req, a:req, b:req, c:req, d:req
        .section .data
        .balign 16
9:      .word   \a,\b,\c,\d
        .text
        lqa     \register,9b
        .endm

# Clears the flags and sets the rounding mode of double precision: 0 nearest, 1 to zero, 2 up, 3
# down.
        .macro  clear mode=0
        words   $60,(\mode)*0x500,0,0,0
        fscrwr  $60
        .endm

# Stores $80, the FPSCR in $81, and a name.
        .macro  store name:req
        .section .rodata
8:      .ascii  "\name"
        .fill   64-(.-8b),1,0
        .text
        stqd    $80,0($70)
        stqd    $81,16($70)
        ai      $70,$70,32
        .endm

# Stores a list whose four elements are 16 bytes at these offsets from the argument. `first` is the
# size of the first one and its stall bit.
        .macro  elements first:req, a:req, b:req, c:req, d:req
        words   $63,\first,\a,0x10,\b
        words   $64,0x10,\c,0x10,\d
        a       $63,$63,$66
        a       $64,$64,$66
        stqa    $63,list
        stqa    $64,list+16
        .endm

# Begins to load the elements.
        .macro  load_list
        ila     $20,list
        ila     $21,loaded
        il      $22,32
        il      $23,GETL
        brsl    $0,transfer
        .endm

        .macro  corner name:req
        fscrrd  $81
        store   "\name"
        .endm

        .text
        .global _start
_start: fscrrd  $81
        ori     $5,$4,0
        rotqbyi $6,$4,4
        ila     $70,results
        il      $80,0
        store   "FPSCR at the start"

        clear
        words   $61,0x80000001,0,0x807fffff,0
        fesd    $80,$61
        corner  "fesd of negative denormals"

        .irp    mode,0,1,2,3
        clear   \mode
        words   $61,0x00000000,0x00000001,0x800fffff,0xffffffff
        frds    $80,$61
        corner  "frds of denormals, rounding mode \mode"
        .endr

        .irp    scale,0,126,127
        clear
        words   $61,0x00400000,0x007fffff,0x80400000,0x807fffff
        cflts   $80,$61,\scale
        corner  "cflts of denormals, scale \scale"
        clear
        cfltu   $80,$61,\scale
        corner  "cfltu of denormals, scale \scale"
        .endr

        # A result of at least Smax before truncation, and sums that exceed it by little.
        clear
        words   $61,0x7fffffff,0x7fffffff,0xffffffff,0x7ffffffe
        words   $62,0x3f800000,0x3f800001,0x3f800001,0x3f800001
        fm      $80,$61,$62
        corner  "fm about the largest single"
        clear
        words   $62,0x3f800000,0x00800000,0xbf800000,0x7f000000
        fa      $80,$61,$62
        corner  "fa about the largest single"
        clear
        words   $63,0x3f800000,0x3f800000,0x3f800000,0x3f800000
        fma     $80,$61,$63,$62
        corner  "fma about the largest single"

        # Sums of far-apart exponents and unlike signs.
        clear
        words   $61,0x3f800000,0x3f800000,0xbf800000,0x4b800000
        words   $62,0xb0000000,0x80800000,0x2f800001,0xbf7fffff
        fa      $80,$61,$62
        corner  "fa of far-apart exponents of unlike sign"
        clear
        fs      $80,$62,$61
        corner  "fs of far-apart exponents"

        # fi with an estimate of another operand, of zero, of a denormal pattern, and at underflow.
        clear
        words   $61,0x40490fdb,0x00000000,0x7e800000,0x3f800000
        frest   $62,$61
        fi      $80,$61,$62
        corner  "fi after frest of pi, 0, 2^126, 1"
        clear
        words   $61,0x00000000,0x0007ffff,0x7fffffff,0x80000000
        words   $62,0x3ea2fb55,0x3ea2fb55,0x3ea2fb55,0x3ea2fb55
        fi      $80,$61,$62
        corner  "fi of positions that are no ordinary numbers"
        clear
        words   $61,0x00000001,0x00000000,0x7e800000,0x00000001
        words   $62,0x00800001,0x00000000,0x7fffffff,0x80800001
        fi      $80,$61,$62
        corner  "fi that underflows, of 0, and of exponent 255"

        # Tiny before rounding and not after it: 2^-1022 (1 - 2^-106).
        words   $61,0x20000000,0x00000001,0x20000000,0x00000001
        words   $62,0x1fffffff,0xfffffffe,0x1fffffff,0xfffffffe
        clear
        il      $80,0
        dfma    $80,$61,$62
        corner  "dfma, tiny before rounding"
        clear
        il      $80,0
        dfnms   $80,$61,$62
        corner  "dfnms, tiny before rounding"
        clear
        dfm     $80,$61,$62
        corner  "dfm, tiny before rounding"
        clear
        words   $61,0x7ff00000,0x00000001,0xfff80000,0x00000000
        dfa     $80,$61,$61
        corner  "dfa of a signalling and a quiet NaN"

        # Branches with both feature bits: the machine's state shows whether interrupts are enabled.
        clear
        ila     $62,1f
        .long   0x350c0000|62<<7
1:      rdch    $80,$ch13
        corner  "bi with both feature bits, interrupts disabled before"
        ila     $62,2f
        bie     $62
2:      ila     $62,3f
        .long   0x350c0000|62<<7
3:      rdch    $80,$ch13
        corner  "bi with both feature bits, interrupts enabled before"
        ila     $62,4f
        bid     $62
4:

        # Elements of a list that the program changes while the list stalls: the first 16 bytes of
        # each show whether the MFC had read it before. The pattern's word N is N + 1.
        ila     $20,pattern
        ori     $21,$6,0
        il      $22,512
        brsl    $0,put
        words   $66,0x80808080,0x00010203,0x80808080,0x00010203
        shufb   $66,$6,$6,$66
        elements 0x80000010,0,16,16,16
        load_list
        rdch    $24,$ch25
        # The MFC has time to read as far ahead as it does.
        il      $25,20000
5:      ai      $25,$25,-1
        brnz    $25,5b
        elements 0x80000010,0,256,256,256
        dsync
        il      $24,0
        wrch    $ch26,$24
        brsl    $0,wait
        brsl    $0,first_words
        clear
        corner  "list elements that change while it stalls"

        # One line of three is set to zero.
        ai      $20,$6,128
        il      $21,0
        il      $22,128
        il      $23,SDCRZ
        brsl    $0,transfer
        brsl    $0,wait
        elements 0x10,112,128,240,256
        load_list
        brsl    $0,wait
        brsl    $0,first_words
        clear
        corner  "sdcrz of the second line"

        # The tag mask changes after the status that it asked for is there: counts of the status and
        # of events, the event, and the status.
        il      $24,1
        wrch    $ch1,$24
        wrch    $ch2,$24
        wrch    $ch22,$24
        il      $24,2
        wrch    $ch23,$24
        wrch    $ch22,$24
        rchcnt  $61,$ch24
        rchcnt  $62,$ch0
        il      $63,-1
        brz     $62,6f
        rdch    $63,$ch0
6:      il      $64,-1
        brz     $61,7f
        rdch    $64,$ch24
7:      brsl    $0,in_one
        il      $24,0
        wrch    $ch1,$24
        il      $24,1
        wrch    $ch2,$24
        # An update at once takes away a status that is left.
        il      $24,0
        wrch    $ch23,$24
        rdch    $24,$ch24
        clear
        corner  "tag status and its event with a changing mask"

        # Each entry of both tables of estimates.
        .irp    step,00,04,08,0c,10,14,18,1c
        clear
        words   $61,0x3f800000+0x\step*0x40000,0x3f840000+0x\step*0x40000,0x3f880000+0x\step*0x40000,0x3f8c0000+0x\step*0x40000
        frest   $80,$61
        corner  "frest, table entries from \step"
        .endr
        .irp    step,00,04,08,0c,10,14,18,1c,20,24,28,2c,30,34,38,3c
        clear
        words   $61,0x3f000000+0x\step*0x40000,0x3f040000+0x\step*0x40000,0x3f080000+0x\step*0x40000,0x3f0c0000+0x\step*0x40000
        frsqest $80,$61
        corner  "frsqest, table entries from \step"
        .endr

        ila     $20,results
        ori     $21,$6,0
        il      $22,0x1000
        brsl    $0,put
        ila     $20,names
        il      $21,NAMES_AT
        a       $21,$6,$21
        il      $22,0x2000
        brsl    $0,put
        stop    0x2000

# Stores $22 bytes of local store at $20 to the effective address $5, $21, and waits.
put:    il      $23,PUT
        ori     $24,$20,0
        ori     $20,$21,0
        ori     $21,$24,0
        ori     $25,$0,0
        brsl    $0,transfer
        ori     $0,$25,0
# Waits for the transfers of tag 0.
wait:   il      $24,1
        wrch    $ch22,$24
        il      $24,2
        wrch    $ch23,$24
        rdch    $24,$ch24
        bi      $0

# Issues the command $23 with tag 0 for $22 bytes, between local store at $21 and the low word $20
# of the effective address, or the address of a list.
transfer:
        il      $24,0
        wrch    $ch16,$21
        wrch    $ch17,$5
        wrch    $ch18,$20
        wrch    $ch19,$22
        wrch    $ch20,$24
        wrch    $ch21,$23
        bi      $0

# $80 from the first words of the four quadwords at `loaded`, or of $61 to $64.
first_words:
        lqa     $61,loaded
        lqa     $62,loaded+16
        lqa     $63,loaded+32
        lqa     $64,loaded+48
in_one: fsmbi   $65,0x0f00
        rotqbyi $62,$62,12
        selb    $80,$61,$62,$65
        fsmbi   $65,0x00f0
        rotqbyi $63,$63,8
        selb    $80,$80,$63,$65
        fsmbi   $65,0x000f
        rotqbyi $64,$64,4
        selb    $80,$80,$64,$65
        bi      $0

        .section .data
        .balign 128
pattern:
        .set    word,0
        .rept   128
        .set    word,word+1
        .word   word
        .endr
list:   .fill   32,1,0
loaded: .fill   64,1,0

# 128 names, the rest of them empty.
        .section .rodata
        .fill   128*64-(.-names),1,0
