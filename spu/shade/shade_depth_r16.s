# shade_depth_r16   the paper's shader: colours that fade to black with the distance of the hit
#   C       vec_uint4 shade_depth_r16(const struct place *, int count, const struct depth *,
#                                     struct colours *, const void *background);
#   In      $3 places, $4 count (at least 1), $5 depth, $6 colours, $7 the background's record;
#           pointers 16-aligned
#   Out     colours of the places' packets, in order
#           $3 rays that hit something, a count a lane
#   Uses    $3-$4, $6-$7, $10-$39   Saves  -   Stack  0   Calls  -
#   Domain  the packets' objects are addresses of records with a colour
#   Error   2 ulp of 1, each channel
#   Twin    lab/twins/src/shade_depth.rs
#
#   brightness = clamp((far - t) scale, 0, 1), or 1 for a miss
#   colour = the record's colour brightness

        .include "work_unit.inc"
        .include "macros.inc"

        .set    NEXT,3
        registers a_place,count,a_depth,a_colours,background
        # constants
        .set    NEXT,10
        registers k_zero,k_one,k_far,k_scale,m_interleave,m_low,m_high,m_third
        # state
        registers missed                                # minus the number of misses
        registers rays
        # a row
        registers a_packet,object,t,bright,c_none,c_over,object1,object2,object3,colour0,colour1
        registers colour2,colour3,rg01,rg23,b01,b23,red,green,blue

        quadword_constants
        # words of two quadwords A and B
interleave:
        .int    0x00010203,0x10111213,0x04050607,0x14151617 # A0 B0 A1 B1
low:    .int    0x00010203,0x04050607,0x10111213,0x14151617 # A0 A1 B0 B1
high:   .int    0x08090a0b,0x0c0d0e0f,0x18191a1b,0x1c1d1e1f # A2 A3 B2 B3
third:  .int    0x08090a0b,0x18191a1b,0x08090a0b,0x18191a1b # A2 B2 A2 B2

function shade_depth_r16
        lqa     $m_interleave,interleave
        lqa     $m_low,low
        lqa     $m_high,high
        lqa     $m_third,third
        lqd     $k_far,DEPTH_far($a_depth)
        lqd     $k_scale,DEPTH_scale($a_depth)
        il      $k_zero,0
        ilhu    $k_one,0x3f80
        il      $missed,0
        shli    $rays,$count,2                          # a lane
        splat_mask $c_none
        splat   $rays,$rays,$c_none
        splat   $background,$background,$c_none
next_packet:
        lqd     $a_packet,0($a_place)
    .irp row, 0,1,2,3
        lqd     $object,PACKET_object+16*\row($a_packet)
        lqd     $t,PACKET_t+16*\row($a_packet)

        fs      $bright,$k_far,$t
        fm      $bright,$bright,$k_scale
        fcgt    $c_over,$k_zero,$bright
        selb    $bright,$bright,$k_zero,$c_over
        fcgt    $c_over,$bright,$k_one
        selb    $bright,$bright,$k_one,$c_over
        ceq     $c_none,$object,$background
        selb    $bright,$bright,$k_one,$c_none
        a       $missed,$missed,$c_none                 # true is -1

        # Four colours, one a lane, turned into lanes of red, green and blue.
        rotqbyi $object1,$object,4
        rotqbyi $object2,$object,8
        rotqbyi $object3,$object,12
        lqd     $colour0,SPHERE_colour($object)
        lqd     $colour1,SPHERE_colour($object1)
        lqd     $colour2,SPHERE_colour($object2)
        lqd     $colour3,SPHERE_colour($object3)
        shufb   $rg01,$colour0,$colour1,$m_interleave
        shufb   $rg23,$colour2,$colour3,$m_interleave
        shufb   $b01,$colour0,$colour1,$m_third
        shufb   $b23,$colour2,$colour3,$m_third
        shufb   $red,$rg01,$rg23,$m_low
        shufb   $green,$rg01,$rg23,$m_high
        shufb   $blue,$b01,$b23,$m_low

        fm      $red,$red,$bright
        fm      $green,$green,$bright
        fm      $blue,$blue,$bright
        stqd    $red,COLOURS_red+16*\row($a_colours)
        stqd    $green,COLOURS_green+16*\row($a_colours)
        stqd    $blue,COLOURS_blue+16*\row($a_colours)
    .endr
        ai      $a_place,$a_place,PLACE_SIZE
        ai      $a_colours,$a_colours,COLOURS_SIZE
        ai      $count,$count,-1
        brnz    $count,next_packet
        a       $3,$rays,$missed
        bi      $lr
endfunction shade_depth_r16
