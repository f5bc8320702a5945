# Complex transforms of 4096 numbers in local store, and of 65,536 in main memory by several SPUs.
# The argument is the address of an order: a line with the words below.
#
#   0   which: 0 for 4096 numbers, 1 for 65,536
#   4   how often
#   8   the SPU's number
#   12  how many SPUs there are
#   16  the low half of the address of the data, whose high half is the order's
#
# The program stores the decrementer's ticks in the order's first word. The offsets in the data:
        .set    INPUT, 0                        # line after line, as transform.s has them
        .set    TURNED, 0x80000                 # between the two passes
        .set    OUTPUT, 0x100000
        .set    FACTORS, 0x180000               # of the stages: for 16, 64 and 256 numbers
        .set    FINE, 0x182000
        .set    COARSE, 0x18a000                # 2 KB a batch
        .set    ARRIVED, 0x192000               # how many SPUs have come to the barriers

        .set    LINES, 32768                    # a batch: 256 lines
        .set    BATCHES, 16
        .set    FACTORS_16, factors
        .set    FACTORS_64, factors+4*64
        .set    FACTORS_256, factors+20*64
        .set    FACTORS_SIZE, 84*64
        .set    COARSE_SIZE, 2048

# MFC commands.
        .set    GET, 0x40
        .set    GETL, 0x44
        .set    PUT, 0x20
        .set    PUTL, 0x24
        .set    GETLLAR, 0xd0
        .set    PUTLLC, 0xb4

# Registers that the transform's functions preserve.
        .set    ea_high, 80
        .set    ea_low, 81
        .set    data, 82
        .set    times, 83
        .set    number, 84
        .set    count, 85
        .set    batch, 86
        .set    next, 87
        .set    side, 88                        # 0 or 1: which of two buffers this batch has
        .set    is_second, 89                   # 0 in the first pass, 1 in the second
        .set    source, 90                      # the low address of a pass's input
        .set    arrivals, 91                    # after the next barrier
        .set    began, 92
        .set    input, 93                       # buffers of this batch
        .set    one, 94
        .set    other, 95
        .set    result, 96
        .set    from, 97
        .set    to, 98
        .set    back, 99                        # return addresses
        .set    back_pass, 100
        .set    list, 101
        .set    offset, 102                     # of this batch in main memory
        .set    columns, 103

        .macro  load_constant out:req, value:req
        ilhu    \out,(\value)>>16
        iohl    \out,(\value)&0xffff
        .endm

# Gives a DMA command.
        .macro  dma lsa:req, low:req, size:req, tag:req, command:req
        wrch    $ch16,\lsa
        wrch    $ch17,$ea_high
        wrch    $ch18,\low
        wrch    $ch19,\size
        wrch    $ch20,\tag
        il      $2,\command
        wrch    $ch21,$2
        .endm

# Gives an atomic command on `line`, and waits for its status.
        .macro  atomic low:req, command:req
        ila     $2,line
        wrch    $ch16,$2
        wrch    $ch17,$ea_high
        wrch    $ch18,\low
        il      $2,\command
        wrch    $ch21,$2
        rdch    $2,$ch27
        .endm

# Waits for the transfers of all tags of which the mask has a bit.
        .macro  wait_tags mask:req
        wrch    $ch22,\mask
        il      $2,2
        wrch    $ch23,$2
        rdch    $2,$ch24
        .endm

# Fetches size bytes from an offset in the data, as tag 0.
        .macro  fetch lsa:req, where:req, size:req
        ila     $10,\lsa
        load_constant $11,\where
        a       $11,$11,$data
        ila     $12,\size
        il      $13,0
        dma     $10, $11, $12, $13, GET
        .endm

# The first stage and one of the later ones, by the addresses of lines.
        .macro  call_first from:req, to:req
        ori     $3,\from,0
        ori     $4,\to,0
        brsl    $lr,stage_first
        .endm
        .macro  call_stage from:req, to:req, factors:req, distance:req, shift:req
        ori     $3,\from,0
        ori     $4,\to,0
        ila     $5,\factors
        il      $6,\distance
        il      $7,-\shift
        brsl    $lr,stage
        .endm

        .text
        .global _start
_start: ori     $ea_high,$4,0
        rotqbyi $ea_low,$4,4
        il      $10,128
        ila     $11,order
        il      $12,0
        dma     $11, $ea_low, $10, $12, GET
        il      $12,1
        wait_tags $12
        lqa     $10,order
        lqa     $11,order+16
        rotqbyi $times,$10,4
        rotqbyi $number,$10,8
        rotqbyi $count,$10,12
        ori     $data,$11,0
        fetch   factors, FACTORS, FACTORS_SIZE
        fetch   fine, FINE, 16384
        fetch   fine+16384, FINE+16384, 16384
        il      $12,1
        wait_tags $12
        il      $12,-1
        wrch    $ch7,$12
        rdch    $2,$ch29                        # the word by which the PPE lets all SPUs begin
        lqa     $10,order
        brz     $10,small

# 65,536 numbers: a matrix of 256 rows and columns. A pass transforms its columns, 16 of them at a
# time, and the first pass turns them into rows.
large:  il      $arrivals,0
        brsl    $lr,barrier
        rdch    $began,$ch8
1:      il      $is_second,0
        ori     $source,$data,0
        brsl    $back_pass,pass
        il      $is_second,1
        load_constant $source,TURNED
        a       $source,$source,$data
        brsl    $back_pass,pass
        ai      $times,$times,-1
        brnz    $times,1b
        br      finish

# 4096 numbers: a matrix of 64 rows and columns. Its lines hold 16 columns of a row, so a stage does
# all 64 at once, and the matrix is turned in four parts.
small:  fetch   input_0, INPUT, 16384
        fetch   input_0+16384, INPUT+16384, 16384
        fetch   coarse_0, COARSE, COARSE_SIZE
        il      $12,1
        wait_tags $12
        ila     $input,input_0
        ila     $one,scratch
        ila     $other,result_0
        rdch    $began,$ch8
2:      call_first $input, $one
        call_stage $one, $other, FACTORS_16, 2048, 5
        call_stage $other, $one, FACTORS_64, 512, 3
        il      $columns,0
3:      shli    $3,$columns,7
        a       $3,$3,$one
        shli    $4,$columns,13
        a       $4,$4,$other
        ila     $5,fine
        ila     $6,coarse_0
        shli    $7,$columns,9
        a       $6,$6,$7
        il      $7,16
        brsl    $lr,turn_square
        ai      $columns,$columns,1
        ceqi    $2,$columns,4
        brz     $2,3b
        call_first $other, $one
        call_stage $one, $other, FACTORS_16, 2048, 5
        call_stage $other, $one, FACTORS_64, 512, 3
        ai      $times,$times,-1
        brnz    $times,2b
        rdch    $11,$ch8
        load_constant $offset,OUTPUT
        a       $offset,$offset,$data
        ila     $10,16384
        il      $12,0
        dma     $one, $offset, $10, $12, PUT
        a       $13,$one,$10
        a       $14,$offset,$10
        dma     $13, $14, $10, $12, PUT
        br      4f

finish: rdch    $11,$ch8
4:      sf      $11,$11,$began
        stqa    $11,order
        ila     $11,order
        il      $10,128
        il      $12,0
        dma     $11, $ea_low, $10, $12, PUT
        il      $12,1
        wait_tags $12
        stop    0x2000

# One pass. Buffers and tags come in pairs: one batch is fetched, by tag 0 or 1, while another is
# transformed and a third stored, by tag 2 or 3.
pass:   il      $side,0
        ori     $batch,$number,0
        ori     $next,$number,0
        brsl    $back,get_batch
next_batch:
        a       $next,$batch,$count
        xori    $side,$side,1
        cgti    $2,$next,BATCHES-1
        brnz    $2,1f
        brsl    $back,get_batch
1:      xori    $side,$side,1
        il      $3,5                            # this batch is here, and its buffer is stored
        shl     $3,$3,$side
        wait_tags $3
        shli    $4,$side,15
        ila     $input,input_0
        a       $input,$input,$4
        ila     $result,result_0
        a       $result,$result,$4
# The result has to be in the buffer of its own. Turning takes a step more.
        ila     $10,scratch
        ceqi    $11,$is_second,0
        selb    $one,$10,$result,$11
        selb    $other,$result,$10,$11
        call_first $input, $one
        call_stage $one, $other, FACTORS_16, 2048, 5
        call_stage $other, $one, FACTORS_64, 512, 3
        call_stage $one, $other, FACTORS_256, 128, 1
        shli    $offset,$batch,7
        il      $13,2
        a       $13,$13,$side
        brnz    $is_second,2f
        ori     $3,$other,0
        ori     $4,$one,0
        ila     $5,fine
        ila     $6,coarse_0
        shli    $7,$side,11
        a       $6,$6,$7
        il      $7,64
        brsl    $lr,turn_batch
        shli    $offset,$batch,15
        load_constant $10,TURNED
        a       $offset,$offset,$10
        a       $offset,$offset,$data
        ila     $11,16384
        il      $13,2
        a       $13,$13,$side
        dma     $result, $offset, $11, $13, PUT
        a       $result,$result,$11
        a       $offset,$offset,$11
        dma     $result, $offset, $11, $13, PUT
        br      3f
2:      load_constant $10,OUTPUT
        a       $offset,$offset,$10
        a       $offset,$offset,$data
        ila     $list,put_list
        brsl    $back,make_list
        dma     $result, $list, $11, $13, PUTL
3:      a       $batch,$batch,$count
        xori    $side,$side,1
        cgti    $2,$batch,BATCHES-1
        brz     $2,next_batch
        il      $3,15
        wait_tags $3
        ori     $lr,$back_pass,0
# The next pass reads what all SPUs have stored, so this one ends at the barrier.

# Waits until all SPUs are here. Each adds one to a counter.
barrier:
        a       $arrivals,$arrivals,$count
        load_constant $10,ARRIVED
        a       $10,$10,$data
1:      atomic  $10, GETLLAR
        lqa     $11,line
        ai      $11,$11,1
        stqa    $11,line
        atomic  $10, PUTLLC
        brnz    $2,1b
2:      atomic  $10, GETLLAR
        lqa     $11,line
        cgt     $2,$arrivals,$11
        brnz    $2,2b
        bi      $lr

# Begins to fetch the batch `next` for `side`.
get_batch:
        ori     $from,$back,0
        shli    $offset,$next,7
        a       $offset,$offset,$source
        ila     $list,get_list
        brsl    $back,make_list
        shli    $14,$side,15
        ila     $15,input_0
        a       $15,$15,$14
        dma     $15, $list, $11, $side, GETL
        brnz    $is_second,1f
        ila     $15,coarse_0
        shli    $14,$side,11
        a       $15,$15,$14
        load_constant $16,COARSE
        shli    $14,$next,11
        a       $16,$16,$14
        a       $16,$16,$data
        il      $14,COARSE_SIZE
        dma     $15, $16, $14, $side, GET
1:      bi      $from

# Writes the list of a batch, whose lines are 2048 bytes apart from `offset` on, to one of the two
# lists at `list`. Leaves its address there, and its size in $11.
make_list:
        hbrr    2f,1f
        shli    $10,$side,11
        a       $list,$list,$10
        ila     $11,0x10203
        shufb   $12,$offset,$offset,$11
        lqa     $13,list_addresses
        and     $12,$12,$13
        lqa     $13,list_elements
        a       $12,$12,$13
        lqa     $13,list_step
        ori     $10,$list,0
        il      $14,32
1:      .irp    at, 0,16,32,48
        stqd    $12,\at($10)
        a       $12,$12,$13
        .endr
        ai      $10,$10,64
        ai      $14,$14,-1
2:      brnz    $14,1b
        il      $11,2048
        bi      $back

        .section .rodata
        .align  4
list_addresses:
        .int    0,-1,0,-1
list_elements:
        .int    128,0,128,2048
list_step:
        .int    0,4096,0,4096

        .section .bss,"aw",@nobits
        .balign 128
order:  .skip   128
line:   .skip   128
get_list:
        .skip   2*2048
put_list:
        .skip   2*2048
factors:
        .skip   FACTORS_SIZE
        .balign 128
fine:   .skip   LINES
coarse_0:
        .skip   2*COARSE_SIZE
input_0:
        .skip   2*LINES
scratch:
        .skip   LINES
result_0:
        .skip   2*LINES
