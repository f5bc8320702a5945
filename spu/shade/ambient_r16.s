# ambient_r16   what light from everywhere adds to surfaces
#   C       void ambient_r16(struct surfaces *, int count, const float *brightness);
#   In      $3 surfaces, consecutive, $4 packets (at least 1), $5 red, green, blue,
#           anything; pointers 16-aligned
#   Out     the surfaces: lit
#   Uses    $3-$4, $10-$20   Saves  -   Stack  0   Calls  -
#   Domain  shares from 0 to 1
#   Error   3 ulp of the brightness
#   Twin    lab/twins/src/light.rs
#
#   lit += brightness diffuse colour

        .include "work_unit.inc"
        .include "macros.inc"

        .set    NEXT,3
        registers a_surfaces,count,a_bright
        # constants
        registers step,bright_red,bright_green,bright_blue
        # a row
        registers diffuse,colour,lit
        # temporaries
        registers bright,m_lane

function ambient_r16
        lqd     $bright,0($a_bright)
        load_constant $m_lane,0x00010203
        splat   $bright_red,$bright,$m_lane
        load_constant $m_lane,0x04050607
        splat   $bright_green,$bright,$m_lane
        load_constant $m_lane,0x08090a0b
        splat   $bright_blue,$bright,$m_lane
        il      $step,SURFACES_SIZE
next_packet:
    .irp row, 0,1,2,3
        lqd     $diffuse,SURFACES_diffuse+16*\row($a_surfaces)
    .irp channel, red,green,blue
        lqd     $colour,SURFACES_\channel+16*\row($a_surfaces)
        fm      $colour,$colour,$diffuse
        lqd     $lit,SURFACES_lit_\channel+16*\row($a_surfaces)
        fma     $lit,$bright_\channel,$colour,$lit
        stqd    $lit,SURFACES_lit_\channel+16*\row($a_surfaces)
    .endr
    .endr
        a       $a_surfaces,$a_surfaces,$step
        ai      $count,$count,-1
        brnz    $count,next_packet
        bi      $lr
endfunction ambient_r16
