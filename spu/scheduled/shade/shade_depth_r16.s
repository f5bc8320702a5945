# shade_depth_r16   the paper's shader: colours that fade to black with the distance of the hit
#   C       vec_uint4 shade_depth_r16(const struct place *, int count, const struct depth *,
#                                     struct colours *, const void *background);
#   In      $3 places, $4 count (at least 1), $5 depth, $6 colours, $7 the background's record;
#           pointers 16-aligned
#   Out     colours of the places' packets, in order
#           $3 rays that hit something, a count a lane
#   Uses    $2-$42, $79   Saves  -   Stack  0   Calls  -
#   Domain  the packets' objects are addresses of records with a colour
#   Error   2 ulp of 1, each channel
#   Twin    lab/twins/src/shade_depth.rs
#
#   brightness = clamp((far - t) scale, 0, 1), or 1 for a miss
#   colour = the record's colour brightness
# Scheduled by spu schedule from shade_depth_r16.s

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

        .section .rodata
        .align  4
        # words of two quadwords A and B
interleave:
        .int    0x00010203,0x10111213,0x04050607,0x14151617 # A0 B0 A1 B1
low:    .int    0x00010203,0x04050607,0x10111213,0x14151617 # A0 A1 B0 B1
high:   .int    0x08090a0b,0x0c0d0e0f,0x18191a1b,0x1c1d1e1f # A2 A3 B2 B3
third:  .int    0x08090a0b,0x18191a1b,0x08090a0b,0x18191a1b # A2 B2 A2 B2

function shade_depth_r16
        .set count_2,79; .set t_2,2; .set object_2,5; .set t_3,8; .set t_4,9; .set object_3,22
        .set bright_2,2; .set object_4,20; .set c_none_2,25; .set bright_3,8; .set bright_4,9
        .set object3_2,29; .set c_none_3,30; .set object1_2,31; .set object2_2,28; .set c_none_4,33
        .set object1_3,34; .set object1_4,35; .set colour0_2,36; .set missed_2,37
        .set colour0_3,21; .set c_over_2,38; .set colour1_2,34; .set c_over_3,39; .set object2_3,5
        .set object3_3,38; .set colour2_2,28; .set colour1_3,26; .set c_over_4,40
        .set colour2_3,27; .set c_over_5,41; .set colour1_4,35; .set object2_4,40
        .set colour0_4,41; .set c_over_6,42; .set colour3_2,29; .set colour0_5,22; .set colour2_4,5
        .set colour1_5,31; .set colour3_3,38; .set b01_2,39; .set rg01_2,34; .set rg23_2,41
        .set object3_4,20; .set missed_3,25; .set rg23_3,42; .set rg01_3,37; .set rg01_4,24
        .set colour2_5,30; .set colour3_4,20; .set b23_2,5; .set b01_3,21; .set rg23_4,25
        .set rg23_5,26; .set green_2,20; .set red_2,24; .set red_3,28; .set green_3,32
        .set red_4,27; .set green_4,28; .set b01_4,22; .set green_5,29; .set b23_3,30
        .set blue_2,21; .set blue_3,20; .set red_5,26; .set green_6,22; .set blue_4,5; .set red_6,8
        .set blue_5,2; .set object_5,9; .set bright_5,22; .set colour0_6,9; .set b01_5,9
        .set blue_6,9; .set red_7,21; .set a_colours_2,3; .set t_5,5; .set bright_6,5
        .set object1_5,29; .set object1_6,30; .set c_none_5,31; .set object3_5,32
        .set object2_5,33; .set colour3_5,28; .set object2_6,34; .set c_none_6,35; .set c_over_7,36
        .set colour2_6,33; .set object3_6,37; .set object1_7,40; .set object3_7,42
        .set object2_7,39; .set colour1_6,38; .set colour0_7,20; .set colour2_7,34
        .set colour2_8,36; .set colour3_6,41; .set colour3_7,37; .set colour1_7,29; .set b23_4,24
        .set rg01_5,39; .set rg23_6,40; .set b23_5,42; .set b01_6,31; .set b23_6,27; .set b01_7,25
        .set b23_7,28; .set rg01_6,9; .set blue_7,24; .set rg23_7,29; .set rg01_7,20
        .set green_7,24; .set green_8,30; .set green_9,9; .set red_8,25; .set blue_8,26
        .set green_10,27; .set blue_9,22; .set red_9,5; .set red_10,2
        shli    $rays,$count,2                          # 0e a lane
        lqa     $m_interleave,interleave                # 0o
        ila     $c_none,0x10203                         # 1e
        lqa     $m_low,low                              # 1o
        clgti   $count_2,$count,1                       # 2e at least as many passes as overlap
        lqa     $m_high,high                            # 2o
        il      $k_zero,0                               # 3e
        lqa     $m_third,third                          # 3o
        ilhu    $k_one,0x3f80                           # 4e
        lqd     $k_far,0($a_depth)                      # 4o
        il      $missed,0                               # 5e
        lqd     $k_scale,16($a_depth)                   # 5o
        shufb   $rays,$rays,$rays,$c_none               # 6o
        shufb   $background,$background,$background,$c_none # 7o
        nop     $127                                    # 8e pairing
        brz     $count_2,next_packet_short              # 8o too few passes
        ai      $count,$count,-1                        # 9e
        lqd     $a_packet,0($a_place)                   # 9o
        ai      $a_place,$a_place,16                    # 10e
        lqd     $t,224($a_packet)                       # 15o
        lqd     $t_2,208($a_packet)                     # 16o
        lqd     $object,256($a_packet)                  # 17o
        lqd     $object_2,272($a_packet)                # 18o
        lqd     $t_3,240($a_packet)                     # 19o
        nop     $127                                    # 20e pairing
        lqd     $t_4,192($a_packet)                     # 20o
        fs      $bright,$k_far,$t                       # 21e
        lqd     $object_3,288($a_packet)                # 21o
        fs      $bright_2,$k_far,$t_2                   # 22e
        lqd     $object_4,304($a_packet)                # 22o
        ceq     $c_none,$object,$background             # 23e
        rotqbyi $object2,$object,8                      # 23o
        ceq     $c_none_2,$object_2,$background         # 24e
        rotqbyi $object3,$object_2,12                   # 24o
        fs      $bright_3,$k_far,$t_3                   # 25e
        rotqbyi $object1,$object,4                      # 25o
        fs      $bright_4,$k_far,$t_4                   # 26e
        rotqbyi $object3_2,$object,12                   # 26o
        ceq     $c_none_3,$object_3,$background         # 27e
        rotqbyi $object1_2,$object_3,4                  # 27o
        fm      $bright,$bright,$k_scale                # 28e
        lqd     $colour3,32($object3)                   # 28o
        fm      $bright_2,$bright_2,$k_scale            # 29e
        rotqbyi $object2_2,$object_4,8                  # 29o
        ceq     $c_none_4,$object_4,$background         # 30e
        rotqbyi $object1_3,$object_4,4                  # 30o
        fm      $bright_3,$bright_3,$k_scale            # 31e
        rotqbyi $object1_4,$object_2,4                  # 31o
        fm      $bright_4,$bright_4,$k_scale            # 32e
        lqd     $colour0_2,32($object_2)                # 32o
        a       $missed_2,$missed,$c_none               # 33e true is -1
        lqd     $colour0_3,32($object)                  # 33o
        fcgt    $c_over_2,$k_zero,$bright               # 34e
        lqd     $colour1_2,32($object1_3)               # 34o
        fcgt    $c_over_3,$k_zero,$bright_2             # 35e
        rotqbyi $object2_3,$object_2,8                  # 35o
        selb    $bright,$bright,$k_zero,$c_over_2       # 36e
        rotqbyi $object3_3,$object_3,12                 # 36o
        selb    $bright_2,$bright_2,$k_zero,$c_over_3   # 37e
        lqd     $colour2_2,32($object2_2)               # 37o
        fcgt    $c_over_3,$bright,$k_one                # 38e
        lqd     $colour1_3,32($object1)                 # 38o
        fcgt    $c_over_4,$k_zero,$bright_3             # 39e
        lqd     $colour2_3,32($object2)                 # 39o
        fcgt    $c_over_5,$k_zero,$bright_4             # 40e
        lqd     $colour1_4,32($object1_4)               # 40o
        selb    $bright_3,$bright_3,$k_zero,$c_over_4   # 41e
        rotqbyi $object2_4,$object_3,8                  # 41o
        selb    $bright_4,$bright_4,$k_zero,$c_over_5   # 42e
        lqd     $colour0_4,32($object_4)                # 42o
        fcgt    $c_over_6,$bright_2,$k_one              # 43e
        lqd     $colour3_2,32($object3_2)               # 43o
        selb    $bright,$bright,$k_one,$c_over_3        # 44e
        lqd     $colour0_5,32($object_3)                # 44o
        selb    $bright_2,$bright_2,$k_one,$c_over_6    # 45e
        lqd     $colour2_4,32($object2_3)               # 45o
        fcgt    $c_over_3,$bright_4,$k_one              # 46e
        lqd     $colour1_5,32($object1_2)               # 46o
        selb    $bright,$bright,$k_one,$c_none_3        # 47e
        lqd     $colour3_3,32($object3_3)               # 47o
        selb    $bright_4,$bright_4,$k_one,$c_over_3    # 48e
        shufb   $b01_2,$colour0_4,$colour1_2,$m_third   # 48o
        fcgt    $c_over_6,$bright_3,$k_one              # 49e
        shufb   $rg01_2,$colour0_4,$colour1_2,$m_interleave # 49o
        selb    $bright_2,$bright_2,$k_one,$c_none_2    # 50e
        shufb   $rg23_2,$colour2_3,$colour3_2,$m_interleave # 50o
        selb    $bright_3,$bright_3,$k_one,$c_over_6    # 51e
        rotqbyi $object3_4,$object_4,12                 # 51o
        a       $missed_3,$missed_2,$c_none_2           # 52e true is -1
        shufb   $rg23_3,$colour2_4,$colour3,$m_interleave # 52o
        selb    $bright_4,$bright_4,$k_one,$c_none      # 53e
        shufb   $rg01_3,$colour0_5,$colour1_5,$m_interleave # 53o
        a       $missed_3,$missed_3,$c_none_3           # 54e true is -1
        shufb   $rg01_4,$colour0_2,$colour1_4,$m_interleave # 54o
        selb    $bright_3,$bright_3,$k_one,$c_none_4    # 55e
        lqd     $colour2_5,32($object2_4)               # 55o
        a       $missed,$missed_3,$c_none_4             # 56e true is -1
        lqd     $colour3_4,32($object3_4)               # 56o
        shufb   $b23_2,$colour2_4,$colour3,$m_third     # 57o
        shufb   $rg01,$colour0_3,$colour1_3,$m_interleave # 58o
        shufb   $b01_3,$colour0_3,$colour1_3,$m_third   # 59o
        shufb   $b01,$colour0_2,$colour1_4,$m_third     # 60o
        hbrr    next_packet_back,next_packet            # 61o hint
        shufb   $rg23_4,$colour2_5,$colour3_3,$m_interleave # 62o
        shufb   $rg23_5,$colour2_2,$colour3_4,$m_interleave # 63o
        shufb   $b23,$colour2_2,$colour3_4,$m_third     # 64o
        shufb   $green_2,$rg01_4,$rg23_3,$m_high        # 65o
        shufb   $red_2,$rg01_4,$rg23_3,$m_low           # 66o
        shufb   $red_3,$rg01,$rg23_2,$m_low             # 67o
        shufb   $blue,$b01_2,$b23,$m_low                # 68o
        fm      $green_2,$green_2,$bright_2             # 69e
        shufb   $green_3,$rg01_2,$rg23_5,$m_high        # 69o
        fm      $red_2,$red_2,$bright_2                 # 70e
        shufb   $b23,$colour2_3,$colour3_2,$m_third     # 70o
        fm      $red_4,$red_3,$bright_4                 # 71e
        shufb   $green_4,$rg01_3,$rg23_4,$m_high        # 71o
        fm      $blue,$blue,$bright_3                   # 72e
        shufb   $b01_4,$colour0_5,$colour1_5,$m_third   # 72o
        fm      $green_5,$green_3,$bright_3             # 73e
        shufb   $b23_3,$colour2_5,$colour3_3,$m_third   # 73o
        nop     $127                                    # 74e pairing
        shufb   $blue_2,$b01_3,$b23,$m_low              # 74o
        fm      $green,$green_4,$bright                 # 75e
        shufb   $green_4,$rg01,$rg23_2,$m_high          # 75o
        stqd    $green_2,80($a_colours)                 # 76o
        shufb   $blue_3,$b01_4,$b23_3,$m_low            # 77o
        fm      $blue_2,$blue_2,$bright_4               # 78e
        shufb   $red_5,$rg01_2,$rg23_5,$m_low           # 78o
        fm      $green_6,$green_4,$bright_4             # 79e
        shufb   $blue_4,$b01,$b23_2,$m_low              # 79o
        nop     $127                                    # 80e pairing
        stqd    $blue,176($a_colours)                   # 80o
        fm      $blue,$blue_3,$bright                   # 81e
        stqd    $green_5,112($a_colours)                # 81o
        fm      $red_6,$red_5,$bright_3                 # 82e
        stqd    $red_2,16($a_colours)                   # 82o
        fm      $blue_5,$blue_4,$bright_2               # 83e
        stqd    $green,96($a_colours)                   # 83o
        shufb   $red,$rg01_3,$rg23_4,$m_low             # 84o
        stqd    $blue_2,128($a_colours)                 # 85o
next_packet:
        ai      $count,$count,-1                        # 0e
        lqd     $a_packet,0($a_place)                   # 0o
            fm      $red,$red,$bright                   # 1e
            stqd    $red_4,0($a_colours)                # 1o
        ai      $a_place,$a_place,16                    # 2e
            stqd    $blue_5,144($a_colours)             # 2o
            stqd    $red_6,48($a_colours)               # 3o
            stqd    $green_6,64($a_colours)             # 4o
            stqd    $blue,160($a_colours)               # 5o
        lqd     $t,224($a_packet)                       # 6o
            nop     $127                                # 7e pairing
            stqd    $red,32($a_colours)                 # 7o
            ai      $a_colours,$a_colours,192           # 8e
        lqd     $t_2,208($a_packet)                     # 8o
        lqd     $object,256($a_packet)                  # 9o
        lqd     $object_2,272($a_packet)                # 10o
        nop     $127                                    # 11e pairing
        lqd     $t_3,240($a_packet)                     # 11o
        fs      $bright,$k_far,$t                       # 12e
        lqd     $t,192($a_packet)                       # 12o
        nop     $127                                    # 13e pairing
        lqd     $object_5,288($a_packet)                # 13o
        fs      $bright_2,$k_far,$t_2                   # 14e
        lqd     $object_4,304($a_packet)                # 14o
        ceq     $c_none,$object,$background             # 15e
        rotqbyi $object2,$object,8                      # 15o
        ceq     $c_none_2,$object_2,$background         # 16e
        rotqbyi $object3,$object_2,12                   # 16o
        fs      $bright_3,$k_far,$t_3                   # 17e
        rotqbyi $object1,$object,4                      # 17o
        fs      $bright_5,$k_far,$t                     # 18e
        rotqbyi $object3_2,$object,12                   # 18o
        ceq     $c_none_3,$object_5,$background         # 19e
        rotqbyi $object1_2,$object_5,4                  # 19o
        fm      $bright,$bright,$k_scale                # 20e
        lqd     $colour3,32($object3)                   # 20o
        fm      $bright_2,$bright_2,$k_scale            # 21e
        rotqbyi $object2_2,$object_4,8                  # 21o
        ceq     $c_none_4,$object_4,$background         # 22e
        rotqbyi $object1_3,$object_4,4                  # 22o
        fm      $bright_3,$bright_3,$k_scale            # 23e
        rotqbyi $object1_4,$object_2,4                  # 23o
        fm      $bright_5,$bright_5,$k_scale            # 24e
        lqd     $colour0_2,32($object_2)                # 24o
        a       $missed_2,$missed,$c_none               # 25e true is -1
        lqd     $colour0_3,32($object)                  # 25o
        fcgt    $c_over_2,$k_zero,$bright               # 26e
        lqd     $colour1_2,32($object1_3)               # 26o
        fcgt    $c_over_3,$k_zero,$bright_2             # 27e
        rotqbyi $object2_3,$object_2,8                  # 27o
        selb    $bright,$bright,$k_zero,$c_over_2       # 28e
        rotqbyi $object3_3,$object_5,12                 # 28o
        selb    $bright_2,$bright_2,$k_zero,$c_over_3   # 29e
        lqd     $colour2_2,32($object2_2)               # 29o
        fcgt    $c_over_3,$bright,$k_one                # 30e
        lqd     $colour1_3,32($object1)                 # 30o
        fcgt    $c_over_4,$k_zero,$bright_3             # 31e
        lqd     $colour2_3,32($object2)                 # 31o
        fcgt    $c_over_5,$k_zero,$bright_5             # 32e
        lqd     $colour1_4,32($object1_4)               # 32o
        selb    $bright_3,$bright_3,$k_zero,$c_over_4   # 33e
        rotqbyi $object2_4,$object_5,8                  # 33o
        selb    $bright_5,$bright_5,$k_zero,$c_over_5   # 34e
        lqd     $colour0_4,32($object_4)                # 34o
        fcgt    $c_over_6,$bright_2,$k_one              # 35e
        lqd     $colour3_2,32($object3_2)               # 35o
        selb    $bright,$bright,$k_one,$c_over_3        # 36e
        lqd     $colour0_6,32($object_5)                # 36o
        selb    $bright_2,$bright_2,$k_one,$c_over_6    # 37e
        lqd     $colour2_4,32($object2_3)               # 37o
        fcgt    $c_over_3,$bright_5,$k_one              # 38e
        lqd     $colour1_5,32($object1_2)               # 38o
        selb    $bright,$bright,$k_one,$c_none_3        # 39e
        lqd     $colour3_3,32($object3_3)               # 39o
        selb    $bright_5,$bright_5,$k_one,$c_over_3    # 40e
        shufb   $b01_2,$colour0_4,$colour1_2,$m_third   # 40o
        fcgt    $c_over_6,$bright_3,$k_one              # 41e
        shufb   $rg01_2,$colour0_4,$colour1_2,$m_interleave # 41o
        selb    $bright_2,$bright_2,$k_one,$c_none_2    # 42e
        shufb   $rg23_2,$colour2_3,$colour3_2,$m_interleave # 42o
        selb    $bright_3,$bright_3,$k_one,$c_over_6    # 43e
        rotqbyi $object3_4,$object_4,12                 # 43o
        nop     $127                                    # 44e pairing
        shufb   $rg23_3,$colour2_4,$colour3,$m_interleave # 44o
        a       $missed_3,$missed_2,$c_none_2           # 45e true is -1
        shufb   $rg01_3,$colour0_6,$colour1_5,$m_interleave # 45o
        selb    $bright_5,$bright_5,$k_one,$c_none      # 46e
        shufb   $rg01_4,$colour0_2,$colour1_4,$m_interleave # 46o
        a       $missed_3,$missed_3,$c_none_3           # 47e true is -1
        lqd     $colour2_5,32($object2_4)               # 47o
        selb    $bright_3,$bright_3,$k_one,$c_none_4    # 48e
        lqd     $colour3_4,32($object3_4)               # 48o
        a       $missed,$missed_3,$c_none_4             # 49e true is -1
        shufb   $b23_2,$colour2_4,$colour3,$m_third     # 49o
        shufb   $rg01,$colour0_3,$colour1_3,$m_interleave # 50o
        shufb   $b01_3,$colour0_3,$colour1_3,$m_third   # 51o
        shufb   $b01,$colour0_2,$colour1_4,$m_third     # 52o
        shufb   $rg23_4,$colour2_5,$colour3_3,$m_interleave # 53o
        shufb   $rg23_5,$colour2_2,$colour3_4,$m_interleave # 54o
        shufb   $b23,$colour2_2,$colour3_4,$m_third     # 55o
        shufb   $green_2,$rg01_4,$rg23_3,$m_high        # 56o
        shufb   $red_2,$rg01_4,$rg23_3,$m_low           # 57o
        shufb   $red_3,$rg01,$rg23_2,$m_low             # 58o
        shufb   $blue,$b01_2,$b23,$m_low                # 59o
        fm      $green_2,$green_2,$bright_2             # 60e
        shufb   $green_3,$rg01_2,$rg23_5,$m_high        # 60o
        fm      $red_2,$red_2,$bright_2                 # 61e
        shufb   $b23,$colour2_3,$colour3_2,$m_third     # 61o
        fm      $red_4,$red_3,$bright_5                 # 62e
        shufb   $green_4,$rg01_3,$rg23_4,$m_high        # 62o
        fm      $blue,$blue,$bright_3                   # 63e
        shufb   $b01_5,$colour0_6,$colour1_5,$m_third   # 63o
        fm      $green_5,$green_3,$bright_3             # 64e
        shufb   $b23_3,$colour2_5,$colour3_3,$m_third   # 64o
        nop     $127                                    # 65e pairing
        shufb   $blue_2,$b01_3,$b23,$m_low              # 65o
        fm      $green,$green_4,$bright                 # 66e
        shufb   $green_4,$rg01,$rg23_2,$m_high          # 66o
        stqd    $green_2,80($a_colours)                 # 67o
        shufb   $blue_6,$b01_5,$b23_3,$m_low            # 68o
        fm      $blue_3,$blue_2,$bright_5               # 69e
        shufb   $red_7,$rg01_2,$rg23_5,$m_low           # 69o
        fm      $green_6,$green_4,$bright_5             # 70e
        shufb   $blue_4,$b01,$b23_2,$m_low              # 70o
        nop     $127                                    # 71e pairing
        stqd    $blue,176($a_colours)                   # 71o
        fm      $blue,$blue_6,$bright                   # 72e
        stqd    $green_5,112($a_colours)                # 72o
        fm      $red_6,$red_7,$bright_3                 # 73e
        stqd    $red_2,16($a_colours)                   # 73o
        fm      $blue_5,$blue_4,$bright_2               # 74e
        stqd    $green,96($a_colours)                   # 74o
        shufb   $red,$rg01_3,$rg23_4,$m_low             # 75o
        stqd    $blue_3,128($a_colours)                 # 76o
        nop     $127                                    # 77e pairing
next_packet_back:
        brnz    $count,next_packet                      # 77o
next_packet_drain:
        fm      $red,$red,$bright                       # 0e
        hbr     shade_depth_r16_return,$lr              # 0o hint
        ai      $a_colours_2,$a_colours,192             # 1e
        stqd    $red_4,0($a_colours)                    # 1o
        a       $a_place,$rays,$missed                  # 2e
        stqd    $blue_5,144($a_colours)                 # 2o
        stqd    $red_6,48($a_colours)                   # 3o
        stqd    $green_6,64($a_colours)                 # 4o
        stqd    $blue,160($a_colours)                   # 5o
        stqd    $red,32($a_colours)                     # 6o
        nop     $127                                    # 7e pairing
shade_depth_r16_return:
        bi      $lr                                     # 7o
next_packet_short:
        ai      $count,$count,-1                        # 0e
        lqd     $a_packet,0($a_place)                   # 0o
        ai      $a_place,$a_place,16                    # 1e
        lqd     $t,224($a_packet)                       # 6o
        lqd     $object,256($a_packet)                  # 7o
        lqd     $t_2,208($a_packet)                     # 8o
        lqd     $t_5,240($a_packet)                     # 9o
        lqd     $t_3,192($a_packet)                     # 10o
        nop     $127                                    # 11e pairing
        lqd     $object_5,304($a_packet)                # 11o
        fs      $bright,$k_far,$t                       # 12e
        lqd     $object_3,288($a_packet)                # 12o
        ceq     $c_none,$object,$background             # 13e
        lqd     $object_4,272($a_packet)                # 13o
        fs      $bright_2,$k_far,$t_2                   # 14e
        rotqbyi $object3,$object,12                     # 14o
        fs      $bright_6,$k_far,$t_5                   # 15e
        rotqbyi $object1,$object,4                      # 15o
        fs      $bright_3,$k_far,$t_3                   # 16e
        rotqbyi $object2,$object,8                      # 16o
        ceq     $c_none_2,$object_5,$background         # 17e
        rotqbyi $object1_5,$object_5,4                  # 17o
        fm      $bright,$bright,$k_scale                # 18e
        rotqbyi $object1_6,$object_3,4                  # 18o
        ceq     $c_none_5,$object_3,$background         # 19e
        rotqbyi $object3_5,$object_4,12                 # 19o
        fm      $bright_2,$bright_2,$k_scale            # 20e
        rotqbyi $object2_5,$object_4,8                  # 20o
        fm      $bright_6,$bright_6,$k_scale            # 21e
        lqd     $colour3_5,32($object3)                 # 21o
        fm      $bright_3,$bright_3,$k_scale            # 22e
        rotqbyi $object2_6,$object_3,8                  # 22o
        ceq     $c_none_6,$object_4,$background         # 23e
        lqd     $colour1,32($object1_6)                 # 23o
        fcgt    $c_over_7,$k_zero,$bright               # 24e
        lqd     $colour2_6,32($object2_5)               # 24o
        a       $missed,$missed,$c_none                 # 25e true is -1
        rotqbyi $object3_6,$object_5,12                 # 25o
        fcgt    $c_over_2,$k_zero,$bright_2             # 26e
        lqd     $colour2_3,32($object2)                 # 26o
        fcgt    $c_over_3,$k_zero,$bright_6             # 27e
        rotqbyi $object1_7,$object_4,4                  # 27o
        fcgt    $c_over_5,$k_zero,$bright_3             # 28e
        rotqbyi $object3_7,$object_3,12                 # 28o
        selb    $bright_6,$bright_6,$k_zero,$c_over_3   # 29e
        lqd     $colour0_5,32($object_3)                # 29o
        selb    $bright_3,$bright_3,$k_zero,$c_over_5   # 30e
        rotqbyi $object2_7,$object_5,8                  # 30o
        selb    $bright_2,$bright_2,$k_zero,$c_over_2   # 31e
        lqd     $colour1_6,32($object1_7)               # 31o
        fcgt    $c_over_4,$bright_3,$k_one              # 32e
        lqd     $colour1_3,32($object1)                 # 32o
        fcgt    $c_over_5,$bright_2,$k_one              # 33e
        lqd     $colour0_7,32($object_4)                # 33o
        selb    $bright,$bright,$k_zero,$c_over_7       # 34e
        lqd     $colour2_7,32($object2_6)               # 34o
        selb    $bright_2,$bright_2,$k_one,$c_over_5    # 35e
        lqd     $colour2_8,32($object2_7)               # 35o
        fcgt    $c_over_3,$bright,$k_one                # 36e
        lqd     $colour3,32($object3_5)                 # 36o
        selb    $bright_2,$bright_2,$k_one,$c_none_6    # 37e
        lqd     $colour3_6,32($object3_7)               # 37o
        fcgt    $c_over_6,$bright_6,$k_one              # 38e
        lqd     $colour3_7,32($object3_6)               # 38o
        selb    $bright_3,$bright_3,$k_one,$c_over_4    # 39e
        lqd     $colour0_3,32($object)                  # 39o
        selb    $bright_6,$bright_6,$k_one,$c_over_6    # 40e
        lqd     $colour0_6,32($object_5)                # 40o
        selb    $bright,$bright,$k_one,$c_over_3        # 41e
        lqd     $colour1_7,32($object1_5)               # 41o
        selb    $bright_3,$bright_3,$k_one,$c_none      # 42e
        shufb   $b23_4,$colour2_6,$colour3,$m_third     # 42o
        selb    $bright,$bright,$k_one,$c_none_5        # 43e
        shufb   $rg01_5,$colour0_5,$colour1,$m_interleave # 43o
        selb    $bright_6,$bright_6,$k_one,$c_none_2    # 44e
        shufb   $rg23_6,$colour2_3,$colour3_5,$m_interleave # 44o
        a       $missed,$missed,$c_none_6               # 45e true is -1
        shufb   $b01,$colour0_3,$colour1_3,$m_third     # 45o
        nop     $127                                    # 46e pairing
        shufb   $b23_5,$colour2_8,$colour3_7,$m_third   # 46o
        a       $missed,$missed,$c_none_5               # 47e true is -1
        shufb   $b01_6,$colour0_6,$colour1_7,$m_third   # 47o
        nop     $127                                    # 48e pairing
        shufb   $b23_6,$colour2_3,$colour3_5,$m_third   # 48o
        a       $missed,$missed,$c_none_2               # 49e true is -1
        shufb   $b01_7,$colour0_7,$colour1_6,$m_third   # 49o
        shufb   $b01_4,$colour0_5,$colour1,$m_third     # 50o
        shufb   $b23_7,$colour2_7,$colour3_6,$m_third   # 51o
        shufb   $rg01_6,$colour0_6,$colour1_7,$m_interleave # 52o
        shufb   $blue_7,$b01_7,$b23_4,$m_low            # 53o
        shufb   $rg23_4,$colour2_8,$colour3_7,$m_interleave # 54o
        shufb   $rg23_7,$colour2_6,$colour3,$m_interleave # 55o
        nop     $127                                    # 56e pairing
        shufb   $rg01,$colour0_3,$colour1_3,$m_interleave # 56o
        fm      $blue_2,$blue_7,$bright_2               # 57e
        shufb   $rg01_7,$colour0_7,$colour1_6,$m_interleave # 57o
        shufb   $rg23,$colour2_7,$colour3_6,$m_interleave # 58o
        shufb   $red,$rg01_6,$rg23_4,$m_low             # 59o
        shufb   $green,$rg01,$rg23_6,$m_high            # 60o
        shufb   $green_7,$rg01_7,$rg23_7,$m_high        # 61o
        nop     $127                                    # 62e pairing
        shufb   $red_5,$rg01_5,$rg23,$m_low             # 62o
        fm      $red,$red,$bright_6                     # 63e
        shufb   $green_8,$rg01_5,$rg23,$m_high          # 63o
        fm      $green,$green,$bright_3                 # 64e
        shufb   $green_9,$rg01_6,$rg23_4,$m_high        # 64o
        fm      $green_7,$green_7,$bright_2             # 65e
        shufb   $blue,$b01_6,$b23_5,$m_low              # 65o
        fm      $red_8,$red_5,$bright                   # 66e
        shufb   $blue_8,$b01,$b23_6,$m_low              # 66o
        fm      $green_10,$green_8,$bright              # 67e
        shufb   $blue_9,$b01_4,$b23_7,$m_low            # 67o
        fm      $green_9,$green_9,$bright_6             # 68e
        shufb   $red_3,$rg01,$rg23_6,$m_low             # 68o
        fm      $blue,$blue,$bright_6                   # 69e
        shufb   $red_9,$rg01_7,$rg23_7,$m_low           # 69o
        fm      $blue_3,$blue_8,$bright_3               # 70e
        stqd    $red,48($a_colours)                     # 70o
        fm      $blue_9,$blue_9,$bright                 # 71e
        stqd    $blue_2,144($a_colours)                 # 71o
        fm      $red,$red_3,$bright_3                   # 72e
        stqd    $green_7,80($a_colours)                 # 72o
        fm      $red_10,$red_9,$bright_2                # 73e
        stqd    $red_8,32($a_colours)                   # 73o
        stqd    $green,64($a_colours)                   # 74o
        stqd    $green_10,96($a_colours)                # 75o
        stqd    $blue_3,128($a_colours)                 # 76o
        stqd    $blue_9,160($a_colours)                 # 77o
        stqd    $red,0($a_colours)                      # 78o
        stqd    $red_10,16($a_colours)                  # 79o
        stqd    $green_9,112($a_colours)                # 80o
        stqd    $blue,176($a_colours)                   # 81o
        ai      $a_colours,$a_colours,192               # 82e
        brnz    $count,next_packet_short                # 82o
        a       $a_place,$rays,$missed                  # 83e
        bi      $lr                                     # 83o
endfunction shade_depth_r16
