# sort_codes   the codes of triangles by which they are sorted
#   C       void sort_codes(void *triangles, int fours, const void *corners,
#                           const struct build *);
#   In      $3 BUILD_TRIANGLE records, $4 fours of them, at least 2, $5 their corners' MESH_VERTEX
#           records, $6 the BUILD; pointers 16-aligned
#   Out     the codes
#   Uses    $3-$6, $10-$37
#   Domain  any
#   Error   0
#   Twin    lab/twins/src/sort.rs
#
# Each coordinate becomes a whole number before the corners' are added, and the scale is a power of
# 2. So nothing is rounded that another processor would round otherwise.
#
# A code is the place of its cell's Morton code among the Gray codes. Neighbours in this order lie
# next to each other along one axis more often, so the boxes around them are smaller.

        .include "work_unit.inc"
        .include "macros.inc"
        .include "transpose.inc"

        .set    NEXT,3
        registers a_triangle,fours,a_corner,a_build
        .set    NEXT,10
        registers m_first,m_last,m_splat,scale,low,shift,k_sides,k_cell,m_code
        registers k_spread                              # to 21
        .set    NEXT,k_spread+4
        registers corner                                # to 24
        .set    NEXT,corner+3
        registers cell                                  # to 28
        .set    NEXT,cell+4
        registers t                                     # to 32
        .set    NEXT,t+4
        registers triangle,turned,code,axis

        transpose_table .rodata.sort
spread_masks:
        .int    0x030000ff,0x030000ff,0x030000ff,0x030000ff
        .int    0x0300f00f,0x0300f00f,0x0300f00f,0x0300f00f
        .int    0x030c30c3,0x030c30c3,0x030c30c3,0x030c30c3
        .int    0x09249249,0x09249249,0x09249249,0x09249249

# Puts two zeros in front of each of the last ten bits.
.macro  spread value:req, t:req
    .irp step, 0,1,2,3
        shli    \t,\value,16>>\step
        or      \value,\value,\t
        and     \value,\value,$k_spread+\step
    .endr
.endm

function sort_codes
        lqa     $m_first,transpose_first
        lqa     $m_last,transpose_last
    .irp step, 0,1,2,3
        lqa     $k_spread+\step,spread_masks+16*\step
    .endr
        splat_mask $m_splat
        load_word $scale,BUILD_scale,$a_build
        load_word $shift,BUILD_shift,$a_build
    .if BUILD_low & 15
        .error  "the smallest cell is not in a quadword of its own"
    .endif
        lqd     $low,BUILD_low($a_build)
        splat   $scale,$scale,$m_splat
        splat   $shift,$shift,$m_splat
        sfi     $shift,$shift,0
        ilhu    $k_sides,(SIDES_BOTH|SIDES_SMOOTH)>>15
        il      $k_cell,0x3ff
        fsmbi   $m_code,0xf000
next_four:
    .irp of, 0,1,2,3
      .irp which, 0,1,2
        lqd     $corner+\which,48*\of+16*\which($a_corner)
        fm      $corner+\which,$corner+\which,$scale
        cflts   $corner+\which,$corner+\which,0
      .endr
        a       $cell+\of,$corner,$corner+1
        a       $cell+\of,$cell+\of,$corner+2
        sf      $cell+\of,$low,$cell+\of
    .endr
        transpose cell,cell,t,$m_first,$m_last
    .irp which, 0,1,2
        rotm    $cell+\which,$cell+\which,$shift
        and     $cell+\which,$cell+\which,$k_cell
        spread  $cell+\which,$axis
    .endr
        shli    $code,$cell,2
        shli    $axis,$cell+1,1
        or      $code,$code,$axis
        or      $code,$code,$cell+2
    .irp bits, 1,2,4,8,16
        rotmi   $axis,$code,-\bits
        xor     $code,$code,$axis
    .endr
    .irp of, 0,1,2,3
        lqd     $triangle,16*\of($a_triangle)
        shlqbyi $turned,$triangle,8
        shli    $turned,$turned,1
        and     $turned,$turned,$k_sides
        rotqbyi $axis,$code,4*\of
        or      $turned,$turned,$axis
        selb    $triangle,$triangle,$turned,$m_code
        stqd    $triangle,16*\of($a_triangle)
    .endr
        ai      $a_triangle,$a_triangle,64
        ai      $a_corner,$a_corner,192
        ai      $fours,$fours,-1
        brnz    $fours,next_four                        # at least 2 passes
        bi      $lr
endfunction sort_codes
