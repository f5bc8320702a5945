# A group of sixteen packets: culled together, then traced in stages, each over all packets that have
# work to do there. So the stages are loops long enough to be pipelined, and no packet waits alone
# for its latencies.

        .include "work_unit.inc"
        .include "macros.inc"
        .include "driver.inc"

        .set    GROUP_PACKETS,16

        .section .bss
        .align  7
packets:
        .skip   GROUP_PACKETS*PACKET_SIZE
middles:                                # of the group's packets, as a packet
        .skip   PACKET_SIZE
colours:
        .skip   GROUP_PACKETS*COLOURS_SIZE
group_places:                           # of a group at the origin of picture and tile buffer
        .skip   GROUP_PACKETS*PLACE_SIZE
group_origin:
        .skip   PLACE_SIZE
places:                                 # of the packets at hand; lists are written one too far
        .skip   (GROUP_PACKETS+1)*PLACE_SIZE
pairs:
        .skip   (MAX_PAIRS+1)*PAIR_SIZE
        .global active
active:                                 # spheres of the tile's frustum
        .skip   (MAX_SPHERES+1)*PAIR_SIZE
masks:                                  # a quadword each: packets that it may be seen from
        .skip   MAX_SPHERES*16

        .section .rodata
        .align  4
lanes:  .int    0,1,2,3
column_step:
        .int    PACKET_SIZE,16,4,0
row_step_without_pixels:
        .int    4*PACKET_SIZE,0,0,4
middle_template:
        .int    middles,0,0,0

        .set    a_place,10
        .set    place,11
        .set    step,12
        .set    left,13
        .set    row,14
        .set    row_step,15
        .set    quad,16
        .set    m_splat,17

# groups_prepare   what the groups of the frame share: the background's pixels, and the buffer of empty
# tiles full of them
#   Uses    $3-$79, g_background, g_pitch
function groups_prepare
        enter
        il      $g_pitch,0                              # of no tile
        # The background goes through the pixel format as any colour does.
        lqa     $quad,background+SPHERE_colour
        splat_mask $m_splat
    .irp channel, red,green,blue
        splat   $place,$quad,$m_splat
    .irp line, 0,16,32,48
        stqa    $place,colours+COLOURS_\channel+\line
    .endr
        rotqbyi $quad,$quad,4
    .endr
        ila     $place,pairs                            # room for four rows of pixels
        rotqbyi $place,$place,16-PLACE_pixels
        stqa    $place,places
        ila     $3,places
        il      $4,1
        ila     $5,colours
        ila     $6,pixel_shuffle
        il      $7,16
        brsl    $lr,pack_r16
        lqa     $g_background,pairs

        ila     $a_place,tile_buffers+2*TILE_BYTES
        il      $left,TILE_BYTES/128
next_line:
    .irp part, 0,16,32,48,64,80,96,112
        stqd    $g_background,\part($a_place)
    .endr
        ai      $a_place,$a_place,128
        ai      $left,$left,-1
        brnz    $left,next_line
        leave
endfunction groups_prepare

# places_prepare   the places of a group at the origin, for the row bytes of the tile at hand
#   Uses    $10-$17, g_pitch
function places_prepare
        ori     $g_pitch,$g_row_bytes,0
        ila     $row,packets
        fsmbi   $quad,0xf000
        and     $row,$row,$quad                         # 0 but for the packet
        lqa     $step,column_step
        lqa     $row_step,row_step_without_pixels
        shli    $left,$g_row_bytes,2
        rotqbyi $left,$left,16-PLACE_pixels
        fsmbi   $quad,0x0f00
        selb    $row_step,$row_step,$left,$quad
        ila     $a_place,group_places
        il      $left,4
next_row:
        ori     $place,$row,0
    .irp column, 0,1,2,3
        stqd    $place,PLACE_SIZE*\column($a_place)
        a       $place,$place,$step
    .endr
        a       $row,$row,$row_step
        ai      $a_place,$a_place,4*PLACE_SIZE
        ai      $left,$left,-1
        brnz    $left,next_row
        bi      $lr
endfunction places_prepare

        .set    mask,3
        .set    columns,20
        .set    rows,21
        .set    four,22
        .set    c_over,23
        .set    bits,24
        .set    origin,25
        .set    x,26
        .set    y,27
        .set    offset,28
        .set    a_mask,29
        .set    seen,30
        .set    a_end,31
        .set    object,32
        .set    t_sum,33
        .set    t_add,34
        .set    t_carry,35
        .set    amount,36
        .set    near,37

# Bits that are 1 in a mask of a group.
.macro  count_bits out:req, bits:req
        cntb    \out,\bits
        sumb    \out,\out,\out
        andi    \out,\out,0x1f
.endm

# group_trace   makes the pixels of the group at hand
#   Uses    $3-$79, the group's driver registers
function group_trace
        enter
        # Packets within the picture: columns from the left, rows from the top.
        il      $four,4
        sf      $columns,$g_group_x,$g_tile_width
        ai      $columns,$columns,3
        rotmi   $columns,$columns,-2
        minimum $columns,$columns,$four,$c_over
        ai      $rows,$g_tile_height,3
        rotmi   $rows,$rows,-2
        il      $bits,0xf0
        sfi     $columns,$columns,0
        rotm    $bits,$bits,$columns
        andi    $bits,$bits,0xf
        il      $g_inside,0x1111
        mpyu    $g_inside,$bits,$g_inside
        ilhu    $bits,0xffff
        shli    $rows,$rows,2
        sfi     $rows,$rows,0
        rotm    $bits,$bits,$rows
        and     $g_inside,$g_inside,$bits
        ilhu    $bits,0
        iohl    $bits,0xffff
        and     $g_inside,$g_inside,$bits
        ori     $g_seen,$g_inside,0
        brz     $g_skip,trace

        # What may be seen from each packet, by the cones around packets' middles.
        a       $x,$g_tile_x,$g_group_x
        rotmi   $x,$x,-2
        rotmi   $y,$g_tile_y,-2
        lqa     $origin,middle_template
        cwd     $c_over,PLACE_x($sp)
        shufb   $origin,$x,$origin,$c_over
        cwd     $c_over,PLACE_y($sp)
        shufb   $origin,$y,$origin,$c_over
        stqa    $origin,places
        ila     $3,basis_middles
        ila     $4,places
        il      $5,1
        ila     $6,background
        brsl    $lr,ray_setup_r16
        ila     $3,middles
        ila     $4,active
        ori     $5,$g_active,0
        ila     $6,masks
        brsl    $lr,cull_spheres_p16
        count   cull_tests,$g_active,$t_sum,$t_add,$t_carry
        ila     $a_mask,masks
        ori     $g_left,$g_active,0
        il      $g_seen,0
next_mask:
        lqd     $bits,0($a_mask)
        or      $g_seen,$g_seen,$bits
        ai      $a_mask,$a_mask,16
        ai      $g_left,$g_left,-1
        brnz    $g_left,next_mask
        and     $g_seen,$g_seen,$g_inside
        xor     $bits,$g_seen,$g_inside
        brz     $bits,culled
        count_bits $amount,$bits
        count   packets_empty,$amount,$t_sum,$t_add,$t_carry
        brsl    $lr,group_fill
culled:
        phase_ends $g_ticks_cull,$amount
        brz     $g_seen,done
trace:
        xor     $offset,$g_pitch,$g_row_bytes
        brz     $offset,placed
        brsl    $lr,places_prepare
placed:
        # The group's origin: nothing for the packet, pixels, x, y.
        il      $offset,TILE_BYTES
        mpyu    $offset,$offset,$g_parity
        ila     $a_end,tile_buffers
        a       $offset,$offset,$a_end
        shli    $x,$g_group_x,2
        a       $offset,$offset,$x
        a       $x,$g_tile_x,$g_group_x
        il      $origin,0
        cwd     $c_over,PLACE_pixels($sp)
        shufb   $origin,$offset,$origin,$c_over
        cwd     $c_over,PLACE_x($sp)
        shufb   $origin,$x,$origin,$c_over
        cwd     $c_over,PLACE_y($sp)
        shufb   $origin,$g_tile_y,$origin,$c_over
        stqa    $origin,group_origin
        ori     $3,$g_seen,0
        ila     $4,group_places
        ila     $5,group_origin
        ila     $6,places
        brsl    $lr,list_places_p16
        ila     $g_places,places
        sf      $g_places,$g_places,$3
        rotmi   $g_places,$g_places,-PLACE_SIZE_LOG2
        ila     $3,basis
        ila     $4,places
        ori     $5,$g_places,0
        ila     $6,background
        brsl    $lr,ray_setup_r16
        phase_ends $g_ticks_rays,$amount

        brz     $g_skip,all
        brsl    $lr,seen_pairs
        br      tested_all
all:    brsl    $lr,all_pairs
        # What no ray of a packet has come near to is shaded without shader.
        xor     $bits,$g_touched,$g_inside
        brz     $bits,tested_all
        count_bits $amount,$bits
        count   packets_empty,$amount,$t_sum,$t_add,$t_carry
        brsl    $lr,group_fill
        brz     $g_touched,nothing_near
        ori     $3,$g_touched,0
        ila     $4,group_places
        ila     $5,group_origin
        ila     $6,places
        brsl    $lr,list_places_p16
        ila     $g_places,places
        sf      $g_places,$g_places,$3
        rotmi   $g_places,$g_places,-PLACE_SIZE_LOG2
tested_all:
        phase_ends $g_ticks_isect,$amount
        ila     $3,places
        ori     $4,$g_places,0
        ila     $5,depth
        ila     $6,colours
        ila     $7,background
        brsl    $lr,shade_depth_r16
        a       $g_n_hits,$g_n_hits,$3
        or      $bits,$g_width,$g_height
        andi    $bits,$bits,3
        brz     $bits,whole
        brsl    $lr,hits_outside
whole:
        ila     $3,places
        ori     $4,$g_places,0
        ila     $5,colours
        ila     $6,pixel_shuffle
        ori     $7,$g_row_bytes,0
        brsl    $lr,pack_r16
        phase_ends $g_ticks_shade,$amount
        leave
nothing_near:
        phase_ends $g_ticks_isect,$amount
done:
        leave
endfunction group_trace

# seen_pairs   tests the packets with the spheres that may be seen from them, front to back
#   Uses    $3-$79, g_left, g_mask, g_touched, g_pairs_end
#
# As long as no packet comes twice, pairs are gathered. When one does, those before it are tested, and
# it is left out if all its rays have hit something in front of the sphere.
function seen_pairs
        enter
        ori     $g_left,$g_active,0
        ila     $g_mask,masks
        il      $g_touched,0
        ila     $g_pairs_end,pairs
next_object:
        lqd     $mask,0($g_mask)
        and     $mask,$mask,$g_inside
        brz     $mask,none
        and     $bits,$mask,$g_touched
        or      $g_touched,$g_touched,$mask
        brnz    $bits,again
        ila     $a_end,pairs+(MAX_PAIRS-GROUP_PACKETS)*PAIR_SIZE
        cgt     $bits,$g_pairs_end,$a_end
        brz     $bits,room
        brsl    $lr,pairs_test
room:   brsl    $lr,object_pairs
        br      none
again:
        brsl    $lr,pairs_test
        brsl    $lr,object_pairs
        brsl    $lr,pairs_hide
none:
        ai      $g_mask,$g_mask,16
        ai      $g_left,$g_left,-1
        brnz    $g_left,next_object
        brsl    $lr,pairs_test
        leave
endfunction seen_pairs

# object_pairs   pairs of the sphere at hand, behind the others
#   Out     $5 its record; g_pairs_end
#   Uses    $3-$6, $10-$36
function object_pairs
        enter
        lqd     $3,0($g_mask)
        and     $3,$3,$g_inside
        ila     $4,group_places
        ila     $5,masks-active
        sf      $5,$5,$g_mask
        lqd     $5,0($5)
        ori     $6,$g_pairs_end,0
        brsl    $lr,list_pairs_p16
        ori     $g_pairs_end,$3,0
        leave
endfunction object_pairs

# pairs_hide   drops those of the pairs whose rays all end in front of their sphere
#   In      $5 the sphere's record
#   Out     g_pairs_end
#   Uses    $3-$5, $10-$36
function pairs_hide
        enter
        lqd     $near,SPHERE_near&~15($5)
        rotqbyi $near,$near,SPHERE_near&15
        ila     $3,pairs
        sf      $4,$3,$g_pairs_end
        rotmi   $4,$4,-PAIR_SIZE_LOG2
        ori     $5,$near,0
        brsl    $lr,hidden_pairs_r16
        sf      $amount,$3,$g_pairs_end
        ori     $g_pairs_end,$3,0
        rotmi   $amount,$amount,-PAIR_SIZE_LOG2
        count   tests_hidden,$amount,$t_sum,$t_add,$t_carry
        leave
endfunction pairs_hide

# all_pairs   tests all packets with all spheres
#   Out     g_touched: the packets some rays of which may enter one
#   Uses    $3-$79, g_left, g_mask, g_pairs_end
function all_pairs
        enter
        mpyu    $amount,$g_places,$g_spheres
        count   tests_made,$amount,$t_sum,$t_add,$t_carry
        il      $g_touched,0
        brz     $g_spheres,nothing
        # As many packets at once as all have room for their pairs.
        ori     $g_left,$g_places,0
        ila     $g_mask,places
        il      $bits,MAX_PAIRS/GROUP_PACKETS
        cgt     $bits,$g_spheres,$bits
        brz     $bits,all_at_once
next_place:
        il      $4,1
        brsl    $lr,places_filter
        ai      $g_mask,$g_mask,PLACE_SIZE
        ai      $g_left,$g_left,-1
        brnz    $g_left,next_place
        leave
all_at_once:
        ori     $4,$g_left,0
        brsl    $lr,places_filter
nothing:
        leave
endfunction all_pairs

# places_filter   tests packets with all spheres
#   In      $4 how many, from the place at g_mask on
#   Out     g_touched
#   Uses    $3-$79, g_pairs_end
function places_filter
        enter
        ori     $3,$g_mask,0
        ila     $5,spheres
        ai      $6,$g_spheres,3
        rotmi   $6,$6,-2
        ila     $7,pairs
        brsl    $lr,filter_spheres_r16
        ori     $g_pairs_end,$3,0
        ila     $3,pairs
        sf      $4,$3,$g_pairs_end
        rotmi   $4,$4,-PAIR_SIZE_LOG2
        ila     $5,packets
        brsl    $lr,mask_pairs_p16
        or      $g_touched,$g_touched,$3
        brsl    $lr,pairs_test
        leave
endfunction places_filter

# pairs_test   looks for hits in all pairs
#   Out     no pairs
#   Uses    $3-$79, g_pairs_end
function pairs_test
        enter
        ila     $3,pairs
        sf      $amount,$3,$g_pairs_end
        ori     $g_pairs_end,$3,0
        rotmi   $amount,$amount,-PAIR_SIZE_LOG2
        brz     $amount,tested
        count   hits_looked_for,$amount,$t_sum,$t_add,$t_carry
        # Without skipping, filter_spheres_r16 has made the tests, and these are part of them.
        sfi     $bits,$g_skip,0
        and     $bits,$bits,$amount
        count   tests_made,$bits,$t_sum,$t_add,$t_carry
        ori     $4,$amount,0
        brsl    $lr,isect_pairs_r16
tested: leave
endfunction pairs_test

# group_fill   fills the group with the background
#   Uses    $10-$36
        .set    a_column,10
        .set    a_row,11

function group_fill
        il      $offset,TILE_BYTES
        mpyu    $offset,$offset,$g_parity
        ila     $a_column,tile_buffers
        a       $a_column,$a_column,$offset
        shli    $offset,$g_group_x,2
        a       $a_column,$a_column,$offset
        sf      $columns,$g_group_x,$g_tile_width
        il      $four,GROUP_SIDE
        minimum $columns,$columns,$four,$c_over
        ai      $columns,$columns,3
        rotmi   $columns,$columns,-2
next_column:
        # Rows below the picture are room of the buffer that is not sent.
        ori     $a_row,$a_column,0
    .rept   TILE_HEIGHT
        stqd    $g_background,0($a_row)
        a       $a_row,$a_row,$g_row_bytes
    .endr
        ai      $a_column,$a_column,16
        ai      $columns,$columns,-1
        brnz    $columns,next_column
        bi      $lr
endfunction group_fill

# hits_outside   takes the rays beside the picture out of the count of hits
#   Uses    $10-$36, g_n_hits
        .set    beside,40
        .set    below,41
        .set    a_packet,42
        .set    k_background,43
        .set    lane,44
        .set    outside,45
        .set    hit,46

function hits_outside
        splat_mask $m_splat
        ila     $k_background,background
        lqa     $lane,lanes
        ila     $a_place,places
        ori     $left,$g_places,0
next_place_outside:
        lqd     $a_packet,0($a_place)
        rotqbyi $x,$a_packet,PLACE_x
        sf      $x,$x,$g_width
        splat   $x,$x,$m_splat
        cgt     $beside,$x,$lane
        nor     $beside,$beside,$beside
        rotqbyi $y,$a_packet,PLACE_y
        sf      $y,$y,$g_height
        splat   $y,$y,$m_splat
    .irp row, 0,1,2,3
        cgti    $below,$y,\row
        nor     $below,$below,$below
        or      $outside,$beside,$below
        lqd     $hit,PACKET_object+16*\row($a_packet)
        ceq     $hit,$hit,$k_background
        andc    $hit,$outside,$hit
        a       $g_n_hits,$g_n_hits,$hit                # true is -1
    .endr
        ai      $a_place,$a_place,PLACE_SIZE
        ai      $left,$left,-1
        brnz    $left,next_place_outside
        bi      $lr
endfunction hits_outside
