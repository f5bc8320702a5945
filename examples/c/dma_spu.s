# Adds a number to each word of an array in main memory, piece by piece, in two buffers: while one
# is in work, the other's piece is fetched. Each buffer has its own tag. A get with a fence waits
# for the put of the buffer's last piece.
#   In      $4 the effective address of a job: from, to (64 bits each), bytes, number to add
        .set    PIECE,8192
        .set    PUT,0x20
        .set    GET,0x40
        .set    GETF,0x42

# Gives a command for the buffer at $buffer with tag $tag, and the effective address {$high, $low}.
        .macro  transfer command, size
        wrch    $ch16,$buffer
        wrch    $ch17,$high
        wrch    $ch18,$low
        il      $70,\size
        wrch    $ch19,$70
        wrch    $ch20,$tag
        il      $70,\command
        wrch    $ch21,$70
        .endm

# Waits until tag $tag has nothing left to do.
        .macro  wait
        il      $70,1
        shl     $70,$70,$tag
        wrch    $ch22,$70
        il      $70,2
        wrch    $ch23,$70
        rdch    $71,$ch24
        .endm

# {$high, $low} = the 64-bit address in \base plus the offset in \offset.
        .macro  address base, offset
        rotqbyi $low,\base,4
        cg      $70,$low,\offset
        a       $low,$low,\offset
        a       $high,\base,$70
        .endm

        .set    high,10
        .set    low,11
        .set    buffer,12
        .set    tag,13
        .set    from,20
        .set    to,21
        .set    bytes,22
        .set    add,23
        .set    done,24                 # offset of the piece in work
        .set    next,25                 # offset of the piece that is fetched meanwhile

        .text
        .global _start
_start: ila     $buffer,job
        il      $tag,0
        ori     $high,$4,0
        rotqbyi $low,$4,4
        transfer GET,32
        wait
        lqa     $from,job
        rotqbyi $to,$from,8
        lqa     $bytes,job+16
        ila     $70,0x10203             # one word to all four
        rotqbyi $add,$bytes,4
        shufb   $add,$add,$add,$70
        il      $done,0
        ila     $buffer,buffers
        il      $tag,0
        address $from,$done
        transfer GET,PIECE

piece:  ila     $70,PIECE
        a       $next,$done,$70
        cgt     $71,$bytes,$next
        brz     $71,work
        # The other buffer and the other tag.
        ila     $72,buffers
        a       $72,$72,$72
        ila     $73,PIECE
        a       $72,$72,$73
        sf      $buffer,$buffer,$72
        xori    $tag,$tag,1
        address $from,$next
        transfer GETF,PIECE
        sf      $buffer,$buffer,$72
        xori    $tag,$tag,1

work:   wait
        ori     $30,$buffer,0
        il      $31,PIECE/16
quad:   lqd     $32,0($30)
        a       $32,$32,$add
        stqd    $32,0($30)
        ai      $30,$30,16
        ai      $31,$31,-1
        brnz    $31,quad
        address $to,$done
        transfer PUT,PIECE
        ila     $72,buffers
        a       $72,$72,$72
        ila     $73,PIECE
        a       $72,$72,$73
        sf      $buffer,$buffer,$72
        xori    $tag,$tag,1
        ori     $done,$next,0
        cgt     $71,$bytes,$done
        brnz    $71,piece

        # Both tags' last puts.
        wait
        xori    $tag,$tag,1
        wait
        stop    0x2000

        .section .bss,"aw",@nobits
        .align  7
buffers: .space 2*PIECE
job:    .space  32
