# Antialiasing by depth shading: pixels of the current tile that differ from a neighbour are traced
# again through their samples, which are tested with every sphere in the tile's frustum.
# refine.s chooses the pixels.

        .include "work_unit.inc"
        .include "macros.inc"
        .include "driver.inc"
        .include "whitted.inc"

# The rays of samples are RAYS16, of which the part from the direction on is a PACKET.
    .if RAYS16_direction_y-RAYS16_direction_x != PACKET_direction_y || RAYS16_direction_z-RAYS16_direction_x != PACKET_direction_z || RAYS16_t-RAYS16_direction_x != PACKET_t || RAYS16_object-RAYS16_direction_x != PACKET_object || PACKET_direction_x != 0
        .error  "a packet of samples is no PACKET"
    .endif
# The maximum number of packets of a list of samples.
        .set    MAX_PACKETS,TILE_PACKETS/4

        .section .bss
        .align  4
spheres_here:                           # how many spheres are in the tile's frustum
        .skip   16
packet_places:                          # of which only the packet is used
        .skip   MAX_PACKETS*PLACE_SIZE

        quadword_constants
first_packet:
        .int    packets+RAYS16_direction_x,0,0,0
packet_step:
        .int    RAYS16_SIZE,0,0,0

        .set    NEXT,10
        registers a_place,place,step,left,amount,a_sphere,a_object,pair,m_packet,a_pair,c_full,most
        registers red,green,blue,sum,t_red,t_green,t_blue,m_second,m_third,a_colours

# tile_samples   traces the samples of the current tile's pixels by depth shading
#   Uses    $3-$79, the tile's driver registers
function tile_samples
        enter
        phase_begins
        brnz    $g_skip,culled
        # Without skipping, all spheres count as in the frustum.
        ila     $a_object,active
        ila     $a_sphere,spheres
        ori     $g_active,$g_spheres,0
        ori     $left,$g_spheres,0
next_sphere:
        stqd    $a_sphere,0($a_object)
        ai      $a_sphere,$a_sphere,SPHERE_SIZE
        ai      $a_object,$a_object,PAIR_SIZE
        ai      $left,$left,-1
        brnz    $left,next_sphere
culled:
        stqa    $g_active,spheres_here
        lqa     $place,first_packet
        lqa     $step,packet_step
        .set    line,0
    .rept   MAX_PACKETS
        stqa    $place,packet_places+line
        a       $place,$place,$step
        .set    line,line+PLACE_SIZE
    .endr
        brsl    $lr,samples_begin
next_samples:
        brsl    $lr,samples_list
        brz     $w_eye_left,traced
        lqa     $3,sample_places
        ori     $4,$w_eye_left,0
        ila     $5,basis
        ila     $6,background
        ila     $7,frame
        load_word $7,FRAME_samples,$7
        ila     $8,packets
        brsl    $lr,sample_rays_r16
        phase_ends $g_ticks_rays,$amount
        mpyu    $amount,$w_eye_left,$g_spheres
        count   tests_possible,$amount,$t_red,$t_green,$t_blue

        # Pairs of each packet with all spheres, tested whenever more might not fit.
        ila     $g_mask,packet_places
        ori     $g_left,$w_eye_left,0
        ila     $g_again_end,pairs
next_packet:
        lqa     $amount,spheres_here
        shli    $amount,$amount,PAIR_SIZE_LOG2
        ila     $most,pairs+MAX_PAIRS*PAIR_SIZE
        sf      $most,$amount,$most
        cgt     $c_full,$g_again_end,$most
        brz     $c_full,pairs_fit
        brsl    $lr,samples_test
pairs_fit:
        cwd     $m_packet,PAIR_packet($sp)
        lqd     $place,0($g_mask)
        ila     $a_object,active
        lqa     $left,spheres_here
        ori     $a_pair,$g_again_end,0
next_pair:
        hbrr    last_pair,next_pair
        lqd     $pair,0($a_object)
        shufb   $pair,$place,$pair,$m_packet
        stqd    $pair,0($a_pair)
        ai      $a_object,$a_object,PAIR_SIZE
        ai      $a_pair,$a_pair,PAIR_SIZE
        ai      $left,$left,-1
last_pair:
        brnz    $left,next_pair
        ori     $g_again_end,$a_pair,0
        ai      $g_mask,$g_mask,PLACE_SIZE
        ai      $g_left,$g_left,-1
        brnz    $g_left,next_packet
        brsl    $lr,samples_test
        phase_ends $g_ticks_isect,$amount

        ila     $3,packet_places
        ori     $4,$w_eye_left,0
        ila     $5,depth
        ila     $6,colours
        ila     $7,background
        brsl    $lr,shade_depth_r16
        a       $g_n_hits,$g_n_hits,$3

        # Each row of a packet is added to the sum of its pixel.
        fsmbi   $m_second,0x0f00
        fsmbi   $m_third,0x00f0
        ila     $a_colours,colours
        lqa     $a_place,sample_places
        ori     $left,$w_eye_left,0
next_colours:
    .irp row, 0,1,2,3
        lqd     $place,PLACE_SIZE*\row($a_place)
        rotqbyi $place,$place,PLACE_pixels
        lqd     $sum,0($place)
    .irp channel, red,green,blue
        lqd     $\channel,COLOURS_\channel+16*\row($a_colours)
        rotqbyi $t_\channel,$\channel,8
        fa      $\channel,$\channel,$t_\channel
        rotqbyi $t_\channel,$\channel,4
        fa      $\channel,$\channel,$t_\channel
    .endr
        selb    $red,$red,$green,$m_second
        selb    $red,$red,$blue,$m_third
        fa      $sum,$sum,$red
        stqd    $sum,0($place)
    .endr
        ai      $a_colours,$a_colours,COLOURS_SIZE
        ai      $a_place,$a_place,4*PLACE_SIZE
        ai      $left,$left,-1
        brnz    $left,next_colours
        phase_ends $g_ticks_shade,$amount
        br      next_samples
traced:
        brsl    $lr,samples_end
        phase_ends $g_ticks_shade,$amount
        leave
endfunction tile_samples

# samples_test   looks for hits in the pairs, and empties their list
#   Uses    $3-$79, g_again_end
function samples_test
        enter
        ila     $3,pairs
        sf      $4,$3,$g_again_end
        ori     $g_again_end,$3,0
        brnz    $g_skip,counted
        # listed_test counts these tests only with skipping.
        rotmi   $amount,$4,-PAIR_SIZE_LOG2
        count   tests_made,$amount,$t_red,$t_green,$t_blue
counted:
        brsl    $lr,listed_test
        leave
endfunction samples_test
