# Lists of elements of one size, each list waited for.
        .include "clock.inc"

        .set    element, 20
        .set    ea, 21
        .set    left, 22
        .set    bytes, 23
        .set    m_pair, 24
        .set    pair, 25
        .set    word, 26
        .set    one, 27

        .text
        .global list
list:   # An element is a word with the size and one with the low part of the address.
        ila     $element,LIST
        ori     $ea,$ea_low,0
        ori     $left,$depth,0
1:      cwd     $m_pair,0($element)
        lqd     $pair,0($element)
        shufb   $pair,$size,$pair,$m_pair
        cwd     $m_pair,4($element)
        shufb   $pair,$ea,$pair,$m_pair
        stqd    $pair,0($element)
        ai      $element,$element,8
        a       $ea,$ea,$size
        ai      $left,$left,-1
        brnz    $left,1b
        shli    $bytes,$depth,3
        il      $one,1
        begins
2:      ila     $word,BUFFERS
        wrch    $ch16,$word
        wrch    $ch17,$ea_high
        ila     $word,LIST
        wrch    $ch18,$word
        wrch    $ch19,$bytes
        il      $word,0
        wrch    $ch20,$word
        il      $word,GETL
        wrch    $ch21,$word
        wait_tags $one,$word
        ai      $passes,$passes,-1
        brnz    $passes,2b
        ends
        bi      $0
