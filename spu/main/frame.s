# The frame's record: fetches it, checks it, and copies its values to where the kernels expect
# them.

        .include "work_unit.inc"
        .include "macros.inc"
        .include "driver.inc"
        .include "checks.inc"

        .section .bss
        .align  4
        .global inverse_across
inverse_across:                         # one over the number of tiles across
        .skip   16
        .global frame, basis, basis_middles, depth, pixel_shuffle
frame:  .skip   FRAME_SIZE
basis:  .skip   BASIS_SIZE
basis_middles:                          # for the middles of packets instead of pixels
        .skip   BASIS_SIZE
depth:  .skip   DEPTH_SIZE
pixel_shuffle:
        .skip   PIXELS_SIZE

        .set    status,3
        .set    high,4
        .set    low,5
        .set    a_frame,15
        .set    value,16
        .set    limit,17
        .set    bad,18
        .set    m_splat,19
        .set    a_spread,20
        .set    right,22
        .set    down,23
        .set    k_middle,24
        .set    k_side,25
        .set    m_red,22
        .set    m_green,23
        .set    m_blue,24
        .set    lane,25
        .set    shuffle,26
        .set    k_ff,27

        quadword_constants
lane_bytes:
        .int    0x00000000,0x04040404,0x08080808,0x0c0c0c0c
identity:
        .int    0x00010203,0x04050607,0x08090a0b,0x0c0d0e0f

# Copies a word of the frame to all lanes of the next quadword of a record.
.macro  spread_word offset:req
        load_word $value,\offset,$a_frame
        splat   $value,$value,$m_splat
        stqd    $value,0($a_spread)
        ai      $a_spread,$a_spread,16
.endm

.macro  spread_vector offset:req
        spread_word \offset
        spread_word \offset+4
        spread_word \offset+8
.endm

# Finds the bytes of a channel in every pixel's word. Refuses a shift that is not a multiple of 8.
.macro  channel_bytes mask:req, channel:req
        load_word $value,FRAME_\channel\()_shift,$a_frame
        andi    $bad,$value,7
        refuse_if $bad,PixelFormat
        shl     \mask,$k_ff,$value
        splat   \mask,\mask,$m_splat
.endm

# frame_fetch   fetches the record, checks every field that could cause a wrong access, and sets up
# the frame
#   In      $4 and $5 effective address, high word first
#   Out     $3 STATUS_ value
#   Uses    $3-$7, $10-$27, the frame's driver registers
function frame_fetch
        enter
        andi    $bad,$low,LINE-1
        refuse_if $bad,Address
        ila     $3,frame
        il      $6,FRAME_SIZE
        il      $7,TAG_FRAME
        brsl    $lr,dma_get
        il      $3,1<<TAG_FRAME
        brsl    $lr,dma_wait

        ila     $a_frame,frame
        require_equal magic,MAGIC,Magic
        require_equal version,VERSION,Version
        require_equal size,FRAME_SIZE,Size
        require_at_most features,FEATURES_KNOWN,Features
        require_from_one spus,MAX_SPUS,Spus
        clgt    $bad,$value,$g_number                   # must be above this SPU's number
        xori    $bad,$bad,-1
        refuse_if $bad,Spus
        require_at_most split,SPLIT_SLICES,Split
        ori     $g_split,$value,0
        require_at_most skip,SKIP_MISSES,Skip
        ori     $g_skip,$value,0
        require_from_one width,MAX_SIDE,Width
        ori     $g_width,$value,0
        require_from_one height,MAX_SIDE,Height
        ori     $g_height,$value,0
        require_at_most stride,MAX_STRIDE,Stride
        ori     $g_stride,$value,0
        andi    $bad,$value,15
        refuse_if $bad,Stride
        ai      $limit,$g_width,3
        andi    $limit,$limit,-4
        shli    $limit,$limit,2
        clgt    $bad,$limit,$g_stride
        refuse_if $bad,Stride
        require_aligned framebuffer,16,Framebuffer
        require_aligned spheres,LINE,Spheres
        require_aligned unit_counter,LINE,UnitCounter
        require_aligned statistics,LINE,Statistics
        require_aligned units,LINE,Units
        require_aligned costs,LINE,Costs
        require_at_most sphere_count,MAX_SPHERES,SphereCount
        ori     $g_spheres,$value,0
        load_word $limit,FRAME_features,$a_frame
        andi    $limit,$limit,FEATURE_SPHERES
        ceqi    $limit,$limit,0
        and     $bad,$g_spheres,$limit
        refuse_if $bad,SphereCount
        load_word $value,FRAME_features,$a_frame
        andi    $value,$value,FEATURE_WHITTED
        brnz    $value,whitted
        require_aligned code,LINE,Code
        require_at_most code_bytes,DEPTH_CODE_CAPACITY,Code
        andi    $bad,$value,15
        refuse_if $bad,Code
        br      checked
whitted:
        require_equal sphere_count,0,SphereCount
        brsl    $lr,whitted_check
        brnz    $3,refused
checked:
        require_at_most contrast,255,Samples
        load_word $value,FRAME_samples,$a_frame
        ceqi    $bad,$value,1
        ceqi    $limit,$value,4
        or      $bad,$bad,$limit
        ceqi    $limit,$value,16
        nor     $bad,$bad,$limit
        refuse_if $bad,Samples
        require_at_most red_shift,MAX_SHIFT,PixelFormat
        require_at_most green_shift,MAX_SHIFT,PixelFormat
        require_at_most blue_shift,MAX_SHIFT,PixelFormat

        # The number of tiles, and its inverse across, with which a tile's row is computed.
        ai      $g_across,$g_width,TILE_WIDTH-1
        rotmi   $g_across,$g_across,-TILE_WIDTH_LOG2
        ai      $value,$g_height,TILE_HEIGHT-1
        rotmi   $value,$value,-TILE_HEIGHT_LOG2
        mpyu    $g_tiles,$g_across,$value
        csflt   $value,$g_across,0
        frest   $limit,$value
        fi      $value,$value,$limit
        stqa    $value,inverse_across
        load_word $g_units,FRAME_unit_count,$a_frame
        clgt    $bad,$g_units,$g_tiles
        refuse_if $bad,UnitCount

        # The positions of red, green and blue in a pixel's word. No two may have the same byte.
        splat_mask $m_splat
        il      $k_ff,0xff
        channel_bytes $m_red,red
        channel_bytes $m_green,green
        channel_bytes $m_blue,blue
        xor     $bad,$m_red,$m_green
        xor     $bad,$bad,$m_blue
        cntb    $bad,$bad
        sumb    $bad,$bad,$bad
        andi    $bad,$bad,0x1f
        xori    $bad,$bad,24
        refuse_if $bad,PixelFormat
        lqa     $lane,lane_bytes
        ilhu    $shuffle,0x8080
        iohl    $shuffle,0x8080                         # a byte of zeroes
        selb    $shuffle,$shuffle,$lane,$m_red
        orbi    $lane,$lane,0x10
        selb    $shuffle,$shuffle,$lane,$m_green
        stqa    $shuffle,pixel_shuffle+PIXELS_red_green
        lqa     $shuffle,identity
        selb    $shuffle,$shuffle,$lane,$m_blue
        stqa    $shuffle,pixel_shuffle+PIXELS_blue

        load_word $g_buffer_high,FRAME_framebuffer,$a_frame
        load_word $g_buffer_low,FRAME_framebuffer+4,$a_frame
        ila     $a_spread,basis
        spread_vector FRAME_corner
        spread_vector FRAME_right
        spread_vector FRAME_down
        ila     $a_spread,depth
        spread_word FRAME_depth_far
        spread_word FRAME_depth_scale

        # A packet's middle is one and a half pixels from its first pixel, and four from the next
        # middle.
        ila     $a_spread,basis
        ilhu    $k_middle,0x3fc0
        ilhu    $k_side,0x4080
    .irp axis, 0,16,32
        lqd     $value,BASIS_corner+\axis($a_spread)
        lqd     $right,BASIS_right+\axis($a_spread)
        lqd     $down,BASIS_down+\axis($a_spread)
        fma     $value,$right,$k_middle,$value
        fma     $value,$down,$k_middle,$value
        fm      $right,$right,$k_side
        fm      $down,$down,$k_side
        stqd    $value,BASIS_SIZE+BASIS_corner+\axis($a_spread)
        stqd    $right,BASIS_SIZE+BASIS_right+\axis($a_spread)
        stqd    $down,BASIS_SIZE+BASIS_down+\axis($a_spread)
    .endr
        il      $status,STATUS_Done
refused:
        leave
endfunction frame_fetch
