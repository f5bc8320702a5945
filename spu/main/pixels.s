# The pixels of a tile. Groups of sixteen packets are culled together. Then the packets of all
# groups go through the same stages. Each stage is a loop over all packets that need it, which is
# long enough to be pipelined, so no packet waits for its own latencies.

        .include "work_unit.inc"
        .include "macros.inc"
        .include "driver.inc"

        .section .arena,"aw",@nobits
        .align  7
        .global empty_tile, packets, colours, places, pairs, masks
empty_tile:                             # the buffer of all empty tiles
        .skip   TILE_BYTES
packets:
        .skip   TILE_PACKETS*PACKET_SIZE
middles:                                # the middles of a group's packets, in a packet's format
        .skip   TILE_GROUPS*PACKET_SIZE
tile_places:                            # of a tile at the origin of the picture and the buffer
        .skip   TILE_PACKETS*PLACE_SIZE
origin: .skip   PLACE_SIZE              # the current tile's offset to tile_places
places:                                 # the current packets; one entry more may be written
        .skip   (TILE_PACKETS+1)*PLACE_SIZE
first_pairs:                            # packets, each with the first sphere that it may hit
        .skip   (TILE_PACKETS+1)*PAIR_SIZE
colours:                                # of the packets, when no pairs are left to test
pairs:                                  # packets with further spheres; without skipping, with all
        .skip   (MAX_PAIRS+1)*PAIR_SIZE
        .global active
active:                                 # the spheres in the tile's frustum
        .skip   (MAX_SPHERES+1)*PAIR_SIZE
packets_at_once:                        # how many packets' pairs with all spheres fit
        .skip   16
named:                                  # masks for a list
        .skip   16
named_again:
        .skip   16
masks:                                  # the packets that may hit each sphere, a word a group;
                                        # linker/spu.ld reserves the memory
        .global masks_size
        .set    masks_size,MAX_SPHERES*16
    .if TILE_PACKETS*COLOURS_SIZE > MAX_PAIRS*PAIR_SIZE
        .error  "the colours don't fit into the pairs"
    .endif
    .if TILE_GROUPS != 4 || TILE_HEIGHT != GROUP_SIDE
        .error  "a tile has four groups in a row: their masks are the words of a quadword"
    .endif

        .section .rodata
        .align  4
lanes:  .int    0,1,2,3
group_columns:
        .int    0,4,8,12
column_step:
        .int    PACKET_SIZE,16,4,0
middle_templates:
    .irp group, 0,1,2,3
        .int    middles+\group*PACKET_SIZE,0,\group*4,0
    .endr
        # makes places from buffer address, x and y
origin_of_pixels_and_x:
        .int    0x80808080,0x00010203,0x10111213,0x80808080
origin_with_y:
        .int    0x00010203,0x04050607,0x08090a0b,0x10111213

        .set    a_place,10
        .set    place,11
        .set    step,12
        .set    left,13
        .set    row,14
        .set    group,15
        .set    quad,16
        .set    m_splat,17

# pixels_prepare   prepares data for all tiles of the frame: the background's pixels, the buffer of
# empty tiles, which is filled with them, and how many packets are filtered at once
#   Uses    $3-$79, g_background, g_pitch
function pixels_prepare
        enter
        il      $g_pitch,0                              # no tile's
        # The background is converted to the pixel format like any colour.
        lqa     $quad,background+SPHERE_colour
        splat_mask $m_splat
    .irp channel, red,green,blue
        splat   $place,$quad,$m_splat
    .irp line, 0,16,32,48
        stqa    $place,colours+COLOURS_\channel+\line
    .endr
        rotqbyi $quad,$quad,4
    .endr
        ila     $place,masks                            # memory of four rows of pixels
        rotqbyi $place,$place,16-PLACE_pixels
        stqa    $place,places
        ila     $3,colours
        il      $4,COLOURS_SIZE/16
        brsl    $lr,light_convert
        ila     $3,places
        il      $4,1
        ila     $5,colours
        ila     $6,pixel_shuffle
        il      $7,16
        brsl    $lr,pack_r16
        lqa     $g_background,masks

        il      $place,0
        il      $quad,MAX_PAIRS
next_packet_at_once:
        sf      $quad,$g_spheres,$quad
        cgti    $step,$quad,-1
        sf      $place,$step,$place                     # true is -1
        cgti    $left,$place,TILE_PACKETS-1
        andc    $step,$step,$left
        brnz    $step,next_packet_at_once
        stqa    $place,packets_at_once

        ila     $a_place,empty_tile
        il      $left,TILE_BYTES/128
next_line:
    .irp part, 0,16,32,48,64,80,96,112
        stqd    $g_background,\part($a_place)
    .endr
        ai      $a_place,$a_place,128
        ai      $left,$left,-1
        brnz    $left,next_line
        leave
endfunction pixels_prepare

# places_prepare   makes the places of a tile at the origin, for the current tile's row bytes
#   Uses    $10-$17, g_pitch
#
# The packets of a group are ordered row by row, as in its mask.
function places_prepare
        ori     $g_pitch,$g_row_bytes,0
        lqa     $step,column_step
        ila     $a_place,tile_places
        ila     $group,packets
        fsmbi   $quad,0xf000
        and     $group,$group,$quad                     # 0 except for the packet
        il      $left,TILE_GROUPS
next_group_places:
        ori     $row,$group,0
    .irp line, 0,1,2,3
        ori     $place,$row,0
    .irp column, 0,1,2,3
        stqd    $place,PLACE_SIZE*\column($a_place)
        a       $place,$place,$step
    .endr
        # The step to the next row: the packets of this row, and four rows of pixels.
        ori     $row,$place,0
        shli    $quad,$step,2
        sf      $row,$quad,$row
        fsmbi   $m_splat,0xf000
        selb    $row,$row,$place,$m_splat
        shli    $quad,$g_row_bytes,2
        fsmbi   $m_splat,0x0f00
        rotqbyi $quad,$quad,16-PLACE_pixels
        and     $quad,$quad,$m_splat
        a       $row,$row,$quad
        fsmbi   $m_splat,0x000f
        il      $quad,4
        and     $quad,$quad,$m_splat
        a       $row,$row,$quad
        ai      $a_place,$a_place,4*PLACE_SIZE
    .endr
        # The step to the next group: the current packet, and four columns.
        shli    $quad,$step,2
        a       $group,$group,$quad
        fsmbi   $m_splat,0xf000
        selb    $group,$group,$row,$m_splat
        ai      $left,$left,-1
        brnz    $left,next_group_places
        bi      $lr
endfunction places_prepare

        .set    columns,20
        .set    rows,21
        .set    limit,22
        .set    c_over,23
        .set    bits,24
        .set    at,25
        .set    x,26
        .set    y,27
        .set    offset,28
        .set    a_mask,29
        .set    again,30
        .set    a_end,31
        .set    t_sum,33
        .set    t_add,34
        .set    t_carry,35
        .set    amount,36
        .set    m_origin,37

# Counts the bits that are 1 in the masks of a tile's groups.
.macro  count_bits out:req, bits:req, t_more:req
        cntb    \out,\bits
        sumb    \out,\out,\out
        andi    \out,\out,0x1f
        rotqbyi \t_more,\out,8
        a       \out,\out,\t_more
        rotqbyi \t_more,\out,4
        a       \out,\out,\t_more
.endm

# tile_pixels   makes the current tile's pixels, unless all of them are the background's
#   Out     $3 whether there are any other pixels
#   Uses    $3-$79, the tile's driver registers
function tile_pixels
        enter
        phase_begins
        xor     $offset,$g_pitch,$g_row_bytes
        brz     $offset,placed
        brsl    $lr,places_prepare
placed:
        # The packets within the picture: a group's columns from the left, its rows from the top.
        splat_mask $m_splat
        ai      $columns,$g_tile_width,3
        rotmi   $columns,$columns,-2
        splat   $columns,$columns,$m_splat
        lqa     $limit,group_columns
        sf      $columns,$limit,$columns
        il      $limit,4
        minimum $columns,$columns,$limit,$c_over
        cgti    $c_over,$columns,0
        and     $columns,$columns,$c_over
        il      $bits,0xf0
        sfi     $columns,$columns,0
        rotm    $bits,$bits,$columns
        andi    $bits,$bits,0xf
        il      $g_inside,0x1111
        mpyu    $g_inside,$bits,$g_inside
        ai      $rows,$g_tile_height,3
        andi    $rows,$rows,-4                          # four bits for each row
        sfi     $rows,$rows,0
        ilhu    $bits,0xffff
        rotm    $bits,$bits,$rows
        splat   $bits,$bits,$m_splat
        ilhu    $limit,0
        iohl    $limit,0xffff
        and     $bits,$bits,$limit
        and     $g_inside,$g_inside,$bits
        ai      $g_groups,$g_tile_width,GROUP_SIDE-1
        rotmi   $g_groups,$g_groups,-4

        # The tile's offsets to the places: pixels, x, y.
        il      $offset,TILE_BYTES
        mpyu    $offset,$offset,$g_parity
        ila     $at,tile_buffers
        a       $offset,$offset,$at
        lqa     $m_origin,origin_of_pixels_and_x
        shufb   $at,$offset,$g_tile_x,$m_origin
        lqa     $m_origin,origin_with_y
        shufb   $at,$at,$g_tile_y,$m_origin
        stqa    $at,origin

        ori     $g_seen,$g_inside,0
        brz     $g_skip,culled
        brsl    $lr,tile_cull
culled:
        phase_ends $g_ticks_cull,$amount
        orx     $3,$g_seen
        brz     $3,done
        brsl    $lr,seen_places
        ila     $3,basis
        ila     $4,places
        ori     $5,$g_places,0
        ila     $6,background
        brsl    $lr,ray_setup_r16
        phase_ends $g_ticks_rays,$amount

        ila     $g_first_end,first_pairs
        ila     $g_again_end,pairs
        brz     $g_skip,all
        brsl    $lr,seen_pairs
        br      tested
all:    brsl    $lr,all_pairs
        # Packets without any near sphere are filled, not shaded.
        xor     $bits,$g_touched,$g_inside
        count_bits $amount,$bits,$c_over
        brz     $amount,tested
        ori     $g_seen,$g_touched,0
        brsl    $lr,seen_places
tested:
        phase_ends $g_ticks_isect,$amount
        brz     $g_places,no_hits
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
        lqa     $bits,converting
        brnz    $bits,convert
converted:
        ila     $3,places
        ori     $4,$g_places,0
        ila     $5,colours
        ila     $6,pixel_shuffle
        ori     $7,$g_row_bytes,0
        brsl    $lr,pack_r16
        phase_ends $g_ticks_shade,$amount
no_hits:
        il      $3,1
done:
        leave

convert:
        ila     $3,colours
        mpyi    $4,$g_places,COLOURS_SIZE/16
        brsl    $lr,light_convert
        br      converted
endfunction tile_pixels

# tile_cull   finds the packets that may hit something, with the cones around their middles
#   Out     g_seen, masks
#   Uses    $3-$79, g_left
function tile_cull
        enter
        rotmi   $x,$g_tile_x,-2
        rotmi   $y,$g_tile_y,-2
        il      $offset,0
        lqa     $m_origin,origin_of_pixels_and_x
        shufb   $at,$offset,$x,$m_origin
        lqa     $m_origin,origin_with_y
        shufb   $at,$at,$y,$m_origin
    .irp group, 0,1,2,3
        lqa     $x,middle_templates+PLACE_SIZE*\group
        a       $x,$x,$at
        stqa    $x,places+PLACE_SIZE*\group
    .endr
        ila     $3,basis_middles
        ila     $4,places
        ori     $5,$g_groups,0
        ila     $6,background
        brsl    $lr,ray_setup_r16

        # The masks of groups outside of the picture are not used, because g_inside does not
        # have their packets.
        ila     $3,middles
        ila     $4,active
        ori     $5,$g_active,0
        ila     $6,masks
        brsl    $lr,cull_spheres_p64
        mpyu    $amount,$g_active,$g_groups
        count   cull_tests,$amount,$t_sum,$t_add,$t_carry

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
        leave
endfunction tile_cull

# seen_places   lists the packets that may hit something, and fills the groups without any
#   Out     places, g_places
#   Uses    $3-$6, $10-$37, g_left
function seen_places
        enter
        xor     $bits,$g_seen,$g_inside
        count_bits $amount,$bits,$c_over
        brz     $amount,filled
        count   packets_empty,$amount,$t_sum,$t_add,$t_carry
    .irp group, 0,1,2,3
        xor     $bits,$g_seen,$g_inside
        rotqbyi $bits,$bits,4*\group
        brz     $bits,full_\group
        il      $3,\group
        brsl    $lr,group_fill
full_\group:
    .endr
filled:
        ila     $6,places
        stqa    $g_seen,named
        ila     $3,named
        ila     $4,tile_places
        ila     $5,origin
        ila     $6,places
        brsl    $lr,list_places_p64
        ila     $g_places,places
        sf      $g_places,$g_places,$3
        rotmi   $g_places,$g_places,-PLACE_SIZE_LOG2
        leave
endfunction seen_places

# seen_pairs   tests the packets with the spheres that they may hit, front to back
#   Uses    $3-$79, g_left, g_mask, g_touched
#
# Each packet is tested with its first sphere. Then it is tested with the others, unless all its
# rays have hit something in front of them.
function seen_pairs
        enter
        ori     $g_left,$g_active,0
        ila     $g_mask,masks
        il      $g_touched,0
next_object:
        # Every group may have a pair for each of its packets.
        ila     $a_end,pairs+(MAX_PAIRS-TILE_PACKETS)*PAIR_SIZE
        cgt     $bits,$g_again_end,$a_end
        brz     $bits,pairs_fit
        brsl    $lr,pairs_test
pairs_fit:
        lqd     $bits,0($g_mask)
        and     $bits,$bits,$g_inside
        and     $again,$bits,$g_touched
        andc    $bits,$bits,$g_touched
        stqa    $bits,named
        stqa    $again,named_again
        or      $g_touched,$g_touched,$bits
        orx     $again,$again
        ila     $3,named
        ila     $4,tile_places
        ila     $5,masks-active
        sf      $5,$5,$g_mask
        lqd     $5,0($5)
        ori     $6,$g_first_end,0
        brnz    $again,both
        brsl    $lr,list_pairs_p64
        ori     $g_first_end,$3,0
listed:
        ai      $g_mask,$g_mask,16
        ai      $g_left,$g_left,-1
        brnz    $g_left,next_object
        brsl    $lr,pairs_test
        leave
both:
        brsl    $lr,list_pairs_p64
        ori     $g_first_end,$3,0
        ila     $3,named_again
        ila     $4,tile_places
        ila     $5,masks-active
        sf      $5,$5,$g_mask
        lqd     $5,0($5)
        ori     $6,$g_again_end,0
        brsl    $lr,list_pairs_p64
        ori     $g_again_end,$3,0
        br      listed
endfunction seen_pairs

# pairs_test   looks for hits in the pairs with first spheres, then in those with further spheres
# that are not hidden
#   Out     empties both lists
#   Uses    $3-$79, g_first_end, g_again_end
function pairs_test
        enter
        ila     $3,first_pairs
        sf      $4,$3,$g_first_end
        ori     $g_first_end,$3,0
        brsl    $lr,listed_test
        ila     $3,pairs
        sf      $4,$3,$g_again_end
        brz     $4,nothing_again
        rotmi   $4,$4,-PAIR_SIZE_LOG2
        brsl    $lr,hidden_pairs_r16
        sf      $amount,$3,$g_again_end
        rotmi   $amount,$amount,-PAIR_SIZE_LOG2
        count   tests_hidden,$amount,$t_sum,$t_add,$t_carry
        ori     $4,$3,0
        ila     $3,pairs
        sf      $4,$3,$4
        ori     $g_again_end,$3,0
        brsl    $lr,listed_test
nothing_again:
        leave
endfunction pairs_test

# listed_test   looks for hits in pairs
#   In      $3 pairs, $4 their bytes
#   Uses    $3-$79
function listed_test
        rotmi   $4,$4,-PAIR_SIZE_LOG2
        count   intersections_computed,$4,$t_sum,$t_add,$t_carry
        # Without skipping, filter_spheres_r16 has already counted these tests.
        sfi     $bits,$g_skip,0
        and     $bits,$bits,$4
        count   tests_made,$bits,$t_sum,$t_add,$t_carry
        br      isect_eye_spheres
endfunction listed_test

# all_pairs   tests all packets with all spheres
#   Out     g_touched: the packets with a ray that may enter a sphere
#   Uses    $3-$79, g_left, g_mask, g_again_end
function all_pairs
        enter
        mpyu    $amount,$g_places,$g_spheres
        count   tests_made,$amount,$t_sum,$t_add,$t_carry
        il      $g_touched,0
        brz     $g_spheres,all_filtered
        ila     $g_mask,places
        ori     $g_left,$g_places,0
next_places:
        lqa     $4,packets_at_once
        minimum $4,$4,$g_left,$bits
        sf      $g_left,$4,$g_left
        ori     $3,$g_mask,0
        shli    $bits,$4,PLACE_SIZE_LOG2
        a       $g_mask,$g_mask,$bits
        ila     $5,spheres
        ai      $6,$g_spheres,3
        rotmi   $6,$6,-2
        ila     $7,pairs
        brsl    $lr,filter_spheres_r16
        ori     $g_again_end,$3,0
        ila     $3,pairs
        sf      $4,$3,$g_again_end
        rotmi   $4,$4,-PAIR_SIZE_LOG2
        ila     $5,packets
        brsl    $lr,mask_pairs_p64
        or      $g_touched,$g_touched,$3
        ila     $3,pairs
        sf      $4,$3,$g_again_end
        brsl    $lr,listed_test
        brnz    $g_left,next_places
all_filtered:
        leave
endfunction all_pairs

# group_fill   fills a group with the background
#   In      $3 its number in the tile
#   Uses    $3, $10-$29
        .set    a_column,10
        .set    a_row,11

function group_fill
        il      $offset,TILE_BYTES
        mpyu    $offset,$offset,$g_parity
        ila     $a_column,tile_buffers
        a       $a_column,$a_column,$offset
        shli    $offset,$3,6
    .if GROUP_SIDE*4 != 1<<6
        .error  "the shift above is of other groups"
    .endif
        a       $a_column,$a_column,$offset
        shli    $columns,$3,4
        sf      $columns,$columns,$g_tile_width
        il      $limit,GROUP_SIDE
        minimum $columns,$columns,$limit,$c_over
        ai      $columns,$columns,3
        rotmi   $columns,$columns,-2
        # Rows below the picture are in the buffer, but are not sent.
        ceqi    $c_over,$columns,4
        brz     $c_over,next_column
    .rept   TILE_HEIGHT
        stqd    $g_background,0($a_column)
        stqd    $g_background,16($a_column)
        stqd    $g_background,32($a_column)
        stqd    $g_background,48($a_column)
        a       $a_column,$a_column,$g_row_bytes
    .endr
        bi      $lr

next_column:
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

# hits_outside   subtracts the hits of rays outside of the picture from the count
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
