# The blocks of cells with the ground's own shadow, for the rays to a light that is infinitely far.
# Its kernels are in local store only in frames with FEATURE_CUTS.

        .include "work_unit.inc"
        .include "macros.inc"
        .include "driver.inc"
        .include "whitted.inc"
        .include "height.inc"
        .include "shades.inc"

        # No list of candidates is needed meanwhile.
        .set    SHADE_NUMBERS,OBJECT_LIST
        .set    SHADE_CELLS,SHADE_NUMBERS+SHADES_SIZE
        .set    SHADE_EXTENT,SHADE_CELLS+16*SHADE_BLOCKS*SHADE_BLOCKS

        .set    NEXT,10
        registers m_first,a_field,quad,one,two,left,word,a_to
        registers extent,last_line,first_line,last_lane,first_lane,level,rows,width,before
        registers high,low,at,size,tag,command,slant,a_cell
    .if NEXT > 80
        .error  "too many registers"
    .endif

# shades_look   takes the shadow rays out of packets of which it is known whether the ground blocks
#               them, in frames with FEATURE_CUTS
#   In      w_packets, w_traced as packets_trace has them; the light
#   Out     $3 0 if no ray is left
#   Uses    $3-$79
function shades_look
        enter
        # Whether they are this light's.
        ila     $a_field,field
        ila     $one,frame
        load_word $one,FRAME_lights,$one
        load_word $two,HEIGHTS_shades_light,$a_field
        shli    $two,$two,LIGHT_SIZE_LOG2
        a       $one,$one,$two
        ceq     $one,$one,$w_light
        lqd     $quad,HEIGHTS_shades($a_field)
        brz     $one,unknown
        fsmbi   $two,0xff00
        and     $two,$quad,$two
        orx     $two,$two
        brz     $two,unknown
        # Each number in all lanes.
        splat_mask $m_first
        ila     $word,field+HEIGHTS_shades_line
        ila     $a_to,arena+SHADE_NUMBERS
        il      $left,-SHADES_SIZE/64
next_numbers:
        hbrr    last_numbers,next_numbers
        # Four numbers are in a quadword, which all begin at a multiple of 16.
        lqd     $quad,0($word)
        rotqbyi $one,$quad,4
        rotqbyi $two,$quad,8
        rotqbyi $extent,$quad,12
    .set    number_at,0
    .irp number, quad,one,two,extent
        splat   $\number,$\number,$m_first
    .endr
    .irp number, quad,one,two,extent
        stqd    $\number,number_at($a_to)
    .set    number_at,number_at+16
    .endr
        ai      $word,$word,16
        ai      $a_to,$a_to,4*16
        ai      $left,$left,1
last_numbers:
        brnz    $left,next_numbers
        lqa     $3,shadow_rays_at
        ori     $4,$w_traced,0
        ila     $5,arena+SHADE_NUMBERS
        ila     $6,arena+SHADE_EXTENT
        brsl    $lr,cuts_extent_r16
        # The blocks between there, of the first level of which few enough are.
        ila     $a_field,field
        lqa     $extent,arena+SHADE_EXTENT
        cflts   $extent,$extent,0
        rotmai  $extent,$extent,-SHADE_SIDE_LOG2
        load_word $rows,HEIGHTS_shades_rows,$a_field
        load_word $width,HEIGHTS_shades_columns,$a_field
        load_word $high,HEIGHTS_shades,$a_field
        load_word $low,HEIGHTS_shades+4,$a_field
        il      $level,0
next_half:
        rotqbyi $last_line,$extent,4
        rotqbyi $first_lane,$extent,8
        rotqbyi $last_lane,$extent,12
        sf      $one,$extent,$last_line
        sf      $two,$first_lane,$last_lane
        clgti   $one,$one,SHADE_BLOCKS-1
        clgti   $two,$two,SHADE_BLOCKS-1
        or      $one,$one,$two
        brz     $one,few_enough
        # Rows and blocks of a row have no more than 16 bits.
        ai      $one,$width,SHADES_BESIDE
        mpyu    $one,$one,$rows
        shli    $one,$one,4
        a       $low,$low,$one
        rotmi   $rows,$rows,-1
        rotmi   $width,$width,-1
        rotmai  $extent,$extent,-1
        ai      $level,$level,1
        ceqi    $one,$level,SHADE_LEVELS
        brz     $one,next_half
unknown:
        il      $3,-1
        leave
few_enough:
        ai      $width,$width,SHADES_BESIDE
        load_word $slant,HEIGHTS_shades_slant,$a_field
        ori     $first_line,$extent,0
        sf      $size,$first_lane,$last_lane
        ai      $size,$size,1
        shli    $size,$size,4
        il      $tag,TAG_MESH
        il      $command,MFC_GET
        ila     $a_cell,arena+SHADE_CELLS
next_blocks:
        # Rows begin where the field does.
        sf      $before,$first_line,$rows
        ai      $before,$before,-1
        mpyu    $before,$before,$slant
        rotmi   $before,$before,-16
        mpyu    $at,$first_line,$width
        sf      $at,$before,$at
        a       $at,$at,$first_lane
        ai      $at,$at,1
        shli    $at,$at,4
        a       $at,$at,$low
        mfc_command $a_cell,$high,$at,$size,$tag,$command
        ai      $a_cell,$a_cell,16*SHADE_BLOCKS
        ceq     $one,$first_line,$last_line
        ai      $first_line,$first_line,1
        brz     $one,next_blocks
        # The level, the first line and the first lane, and the length from line to line.
        load_word $high,HEIGHTS_shades_length,$a_field
        shli    $low,$level,23
        a       $high,$high,$low
        shli    $one,$extent,SHADE_SIDE_LOG2
        shli    $two,$first_lane,SHADE_SIDE_LOG2
        cwd     $quad,4($sp)
        shufb   $level,$one,$level,$quad
        cwd     $quad,8($sp)
        shufb   $level,$two,$level,$quad
        cwd     $quad,12($sp)
        shufb   $level,$high,$level,$quad
        stqa    $level,arena+SHADE_EXTENT
        il      $3,1<<TAG_MESH
        brsl    $lr,dma_wait
        lqa     $3,shadow_rays_at
        ori     $4,$w_traced,0
        ila     $5,arena+SHADE_NUMBERS
        ila     $6,arena+SHADE_CELLS
        ila     $7,arena+SHADE_EXTENT
        ila     $8,ground
        brsl    $lr,cuts_shades_r16
        leave
endfunction shades_look

        .set    NEXT,10
        registers a_row,packets_left,k_no_ray,k_beyond
        registers t                                     # to t+3, like c_ray
        .set    c_ray,t+4

# shades_end   gives the rays that reach the light its distance
#   Uses    $10-$21
function shades_end
        lqa     $a_row,shadow_rays_at
        ori     $packets_left,$w_traced,0
        ilhu    $k_no_ray,0xbf80                        # -1: fewer bits than those of SHADE_LIT
        ilhu    $k_beyond,FARTHEST>>16
next_packet:
        hbrr    last_packet,next_packet
    .irp row, 0,1,2,3
        lqd     $t+\row,RAYS16_t+16*\row($a_row)
    .endr
    .irp row, 0,1,2,3
        cgt     $c_ray+\row,$t+\row,$k_no_ray
    .endr
    .irp row, 0,1,2,3
        selb    $t+\row,$t+\row,$k_beyond,$c_ray+\row
    .endr
    .irp row, 0,1,2,3
        stqd    $t+\row,RAYS16_t+16*\row($a_row)
    .endr
        ai      $packets_left,$packets_left,-1
        il      $t,RAYS16_SIZE
        a       $a_row,$a_row,$t
last_packet:
        brnz    $packets_left,next_packet
        bi      $lr
endfunction shades_end
