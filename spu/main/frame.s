# The frame descriptor: fetched, checked, its values spread to where the kernels want them.

        .include "work_unit.inc"
        .include "macros.inc"
        .include "driver.inc"

        .section .bss
        .align  7
        .global frame, basis, depth, shifts
frame:  .skip   FRAME_SIZE
basis:  .skip   BASIS_SIZE
depth:  .skip   DEPTH_SIZE
shifts: .skip   SHIFTS_SIZE

        .set    status,3
        .set    high,4
        .set    low,5
        .set    a_frame,15
        .set    value,16
        .set    limit,17
        .set    bad,18
        .set    m_splat,19
        .set    a_spread,20
        .set    vector,21

# Leaves frame_fetch with a status unless the register is 0.
.macro  refuse_if bad_register:req, code:req
        il      $status,STATUS_\code
        brnz    \bad_register,refused
.endm

.macro  require_equal field:req, wanted:req, code:req
        load_word $value,FRAME_\field,$a_frame
        load_constant $limit,\wanted
        xor     $bad,$value,$limit
        refuse_if $bad,\code
.endm

.macro  require_at_most field:req, most:req, code:req
        load_word $value,FRAME_\field,$a_frame
        load_constant $limit,\most
        clgt    $bad,$value,$limit
        refuse_if $bad,\code
.endm

.macro  require_from_one field:req, most:req, code:req
        load_word $value,FRAME_\field,$a_frame
        load_constant $limit,\most-1
        ai      $bad,$value,-1                          # 0 becomes the largest
        clgt    $bad,$bad,$limit
        refuse_if $bad,\code
.endm

# An effective address: its low word tells.
.macro  require_aligned field:req, alignment:req, code:req
        load_word $value,FRAME_\field+4,$a_frame
        andi    $bad,$value,\alignment-1
        refuse_if $bad,\code
.endm

# A word of the frame into all lanes of the next quadword of a record.
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

# frame_fetch   fetches the descriptor, checks every field that could lead astray, sets up the frame
#   In      $4 and $5 effective address, high word first
#   Out     $3 STATUS_ value
#   Uses    $3-$7, $10-$21, the frame's and the counts' driver registers
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
        clgt    $bad,$value,$g_number                   # more SPUs than this one's number
        xori    $bad,$bad,-1
        refuse_if $bad,Spus
        require_at_most split,SPLIT_SLICES,Split
        ori     $g_split,$value,0
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
        require_aligned tile_counter,LINE,TileCounter
        require_aligned statistics,LINE,Statistics
        require_at_most sphere_count,MAX_SPHERES,SphereCount
        ori     $g_spheres,$value,0
        load_word $limit,FRAME_features,$a_frame
        andi    $limit,$limit,FEATURE_SPHERES
        ceqi    $limit,$limit,0
        and     $bad,$g_spheres,$limit
        refuse_if $bad,SphereCount
        require_at_most red_shift,MAX_SHIFT,PixelFormat
        require_at_most green_shift,MAX_SHIFT,PixelFormat
        require_at_most blue_shift,MAX_SHIFT,PixelFormat

        load_word $g_buffer_high,FRAME_framebuffer,$a_frame
        load_word $g_buffer_low,FRAME_framebuffer+4,$a_frame
        splat_mask $m_splat
        ila     $a_spread,basis
        spread_vector FRAME_corner
        spread_vector FRAME_right
        spread_vector FRAME_down
        ila     $a_spread,depth
        spread_word FRAME_depth_far
        spread_word FRAME_depth_scale
        ila     $a_spread,shifts
        spread_word FRAME_red_shift
        spread_word FRAME_green_shift
        spread_word FRAME_blue_shift
        il      $g_n_tiles,0
        il      $g_n_packets,0
        il      $g_n_rays,0
        il      $g_n_hits,0
        il      $g_tests_high,0
        il      $g_tests_low,0
        il      $status,STATUS_Done
refused:
        leave
endfunction frame_fetch
