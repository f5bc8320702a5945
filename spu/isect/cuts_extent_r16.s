# cuts_extent_r16   between which lines and lanes of the ground's shadows rays start
#   C       void cuts_extent_r16(const struct rays16 *, int count, const struct shades *,
#                                vec_float4 *);
#   In      $3 rays, consecutive; $4 packets (at least 1); $5 numbers of the shadows; $6 where the
#           result goes; pointers 16-aligned
#   Out     the smallest line, the largest, the smallest lane, the largest, of the rays that are
#           there and start above the field; FARTHEST and -FARTHEST if there is none
#   Uses    $3-$40   Saves  -   Stack  0   Calls  -
#   Domain  any
#   Error   0
#   Twin    lab/twins/src/shades.rs

        .include "work_unit.inc"
        .include "macros.inc"
        .include "extremes.inc"
        .include "transpose.inc"
        .include "height.inc"
        .include "shades.inc"

        .set    NEXT,3
        registers a_row,rows,a_shades,a_out
        registers line_x,line_0,line_z,line_last,place_x,place_0,place_z,place_last,slant,shift
        registers zero,line,lane,outside,x,z,t,one,two
        registers smallest                                 # lines, -lines, lanes, -lanes
        .set    NEXT,smallest+4
        registers turned                                # to turned+3
        .set    NEXT,turned+4
        .set    m_first,line_x
        .set    m_last,line_z

        transpose_table .rodata.cuts

.macro  lower nth:req, value:req
        fcgt    $one,$smallest+\nth,\value
        andc    $one,$one,$outside
        selb    $smallest+\nth,$smallest+\nth,\value,$one
.endm

function cuts_extent_r16
        load_shades line_x,line_0,line_z,line_last,place_x,place_0,place_z,place_last,slant,shift
        shli    $rows,$rows,2
        sfi     $rows,$rows,0
        il      $zero,0
    .irp nth, 0,1,2,3
        ilhu    $smallest+\nth,FARTHEST>>16
    .endr
next_row:
        shade_places $line,$lane,$outside,$x,$z,$t,$one
        lower   0,$line
        lower   2,$lane
        fs      $line,$zero,$line
        fs      $lane,$zero,$lane
        lower   1,$line
        lower   3,$lane
        next_shade_row $one,$two
        brnz    $rows,next_row
        lqa     $m_first,transpose_first
        lqa     $m_last,transpose_last
        transpose smallest,smallest,turned,$m_first,$m_last
        minimum_f4 $smallest,$smallest+1,$one
        minimum_f4 $smallest+2,$smallest+3,$one
        minimum_f4 $smallest,$smallest+2,$one
        # Every other one is the smallest of the numbers with the other sign.
        fsmbi   $one,0x0f0f
        fs      $two,$zero,$smallest
        selb    $smallest,$smallest,$two,$one
        stqd    $smallest,0($a_out)
        bi      $lr
endfunction cuts_extent_r16
