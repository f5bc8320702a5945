# Antialiasing. After a tile has been traced with one ray a pixel, pixels that differ from a
# neighbour get the rays of their samples, whose mean replaces the first one. With Whitted's model,
# with a contrast of 0, there are no first rays, and every pixel gets samples.
#
# Pixels are compared as bytes, as the framebuffer would show them, with their neighbours to the
# left, to the right, above and below. Neighbours in another tile are not compared: the picture
# then depends on nothing but the frame, whichever SPU traces the tile.

        .include "work_unit.inc"
        .include "macros.inc"
        .include "driver.inc"
        .include "whitted.inc"

        .section .bss
        .align  4
        .global contrast, converting, refining, sample_places, sample_sums
contrast:                               # the frame's; below 0 if it has one sample a pixel
        .skip   16
converting:                             # the frame's features with which light is converted
        .skip   16
without_first:                          # -1 if pixels with samples have no first ray, otherwise 0
        .skip   16
sample_places:                          # the address of the list of pixels with samples
        .skip   16
sample_sums:                            # the address of the sums of samples
        .skip   16
refining:                               # not 0 while the listed packets are samples of pixels
        .skip   16
next_row:                               # where the search for pixels goes on
        .skip   16
next_column:                            # in bytes of the tile buffer's rows
        .skip   16
no_pixel:                               # the sum for absent rays
        .skip   16
packed: .skip   16                      # four pixels
chosen:                                 # a row in a quadword: each byte the bits of four pixels
        .skip   TILE_HEIGHT*16

        quadword_constants
lanes:  .int    0,1,2,3
pixel_step:                             # from a pixel's place to that of the next
        .int    0,16,1,0
        # words of two quadwords A and B
from_left:
        .int    0x0c0d0e0f,0x10111213,0x14151617,0x18191a1b # A3 B0 B1 B2
from_right:
        .int    0x04050607,0x08090a0b,0x0c0d0e0f,0x10111213 # A1 A2 A3 B0

        .set    NEXT,10
        registers a_frame,value,c_one,c_whitted

# refine_prepare   looks up whether and where the frame's pixels have several samples
#   Uses    $10-$13
function refine_prepare
        ila     $a_frame,frame
        load_word $c_one,FRAME_samples,$a_frame
        ceqi    $c_one,$c_one,1
        load_word $value,FRAME_contrast,$a_frame
        or      $value,$value,$c_one
        stqa    $value,contrast
        load_word $c_whitted,FRAME_features,$a_frame
        andi    $c_one,$c_whitted,FEATURE_SRGB+FEATURE_ROLL_OFF
        stqa    $c_one,converting
        andi    $c_whitted,$c_whitted,FEATURE_WHITTED
        cgti    $c_whitted,$c_whitted,0
        ceqi    $value,$value,0
        and     $value,$value,$c_whitted
        stqa    $value,without_first
        ila     $value,places
        ila     $c_one,arena+EYE_PLACES
        selb    $value,$value,$c_one,$c_whitted
        stqa    $value,sample_places
        ila     $value,masks
        ila     $c_one,arena+PIXEL_SUMS
        selb    $value,$value,$c_one,$c_whitted
        stqa    $value,sample_sums
        il      $value,0
        stqa    $value,refining
        bi      $lr
endfunction refine_prepare

# tile_refine   traces the samples of the current tile's pixels with Whitted's model
#   Uses    $3-$79, Whitted's driver registers
function tile_refine
        enter
        brsl    $lr,samples_begin
        il      $3,1
        stqa    $3,refining
        brsl    $lr,tile_rays
        il      $3,0
        stqa    $3,refining
        brsl    $lr,samples_end
        phase_ends $g_ticks_shade,$3
        leave
endfunction tile_refine

# light_convert   converts light to what the frame's pixels are to show of it
#   In      $3 values, $4 quadwords (a multiple of 4, at least 4)
#   Uses    $2-$34, $77-$79
function light_convert
        lqa     $5,converting
        biz     $5,$lr
        enter
        ori     $77,$3,0
        ori     $78,$4,0
        andi    $6,$5,FEATURE_ROLL_OFF
        brz     $6,rolled_off
        brsl    $lr,roll_off
rolled_off:
        ori     $3,$77,0
        ori     $4,$78,0
        lqa     $5,converting
        andi    $6,$5,FEATURE_SRGB
        brz     $6,converted
        brsl    $lr,encode_srgb
converted:
        leave
endfunction light_convert

        .set    NEXT,3
        registers t

# samples_begin   begins the search of the current tile
#   Out     w_eye_left is 0
#   Uses    $3
function samples_begin
        il      $t,0
        stqa    $t,next_row
        stqa    $t,next_column
        il      $w_eye_left,0
        .set    line,0
    .rept   TILE_HEIGHT
        stqa    $t,chosen+16*line
        .set    line,line+1
    .endr
        bi      $lr
endfunction samples_begin

        .set    NEXT,60
        registers a_sum,a_next_row,a_chosen,a_chosen_end,bits,sum,share,k_one,k_share
        registers chosen_row,m_splat,factor,a_quad,row_bytes,a_next_quads,t_end,of_four

# samples_end   makes the chosen pixels of the sums of their samples
#   Uses    $2-$7, $10-$40, $60-$79
function samples_end
        enter
        ila     $a_sum,frame
        load_word $of_four,FRAME_samples,$a_sum
        splat_mask $m_splat
        splat   $of_four,$of_four,$m_splat
        ceqi    $of_four,$of_four,4
        ilhu    $k_share,0x3d80                         # 1/16
        ilhu    $k_one,0x3e80                           # 1/4
        selb    $k_share,$k_share,$k_one,$of_four
        lqa     $a_sum,sample_sums
        il      $a_quad,TILE_BYTES
        mpyu    $a_quad,$a_quad,$g_parity
        ila     $a_chosen,tile_buffers
        a       $a_quad,$a_quad,$a_chosen
        ila     $a_chosen,chosen
        ila     $a_chosen_end,chosen+16*TILE_HEIGHT
next_chosen_row:
        lqd     $chosen_row,0($a_chosen)
        il      $a_next_row,SUMS_PITCH
        a       $a_next_row,$a_next_row,$a_sum
        a       $a_next_quads,$a_quad,$g_row_bytes
next_bits:
        orx     $t_end,$chosen_row
        brz     $t_end,row_packed
        rotqbyi $bits,$chosen_row,13                    # the first byte to the lowest
        fsm     $bits,$bits
        orx     $t_end,$bits
        brz     $t_end,none
    .irp lane, 0,1,2,3
        lqd     $sum,16*\lane($a_sum)
        fm      $sum,$sum,$k_share
        stqd    $sum,16*\lane($a_sum)
    .endr
        ori     $3,$a_sum,0
        il      $4,4
        brsl    $lr,light_convert
        ori     $3,$a_sum,0
        ila     $4,packed
        il      $5,1
        il      $6,16
        ila     $7,pixel_shuffle
        brsl    $lr,pack_sums
        lqa     $sum,packed
        lqd     $share,0($a_quad)
        selb    $share,$share,$sum,$bits
        stqd    $share,0($a_quad)
none:
        ai      $a_sum,$a_sum,64
        ai      $a_quad,$a_quad,16
        shlqbyi $chosen_row,$chosen_row,1
        br      next_bits
row_packed:
        ori     $a_sum,$a_next_row,0
        ori     $a_quad,$a_next_quads,0
        ai      $a_chosen,$a_chosen,16
        ceq     $t_end,$a_chosen,$a_chosen_end
        brz     $t_end,next_chosen_row
        leave
endfunction samples_end

        .set    NEXT,10
        registers row,column,a_quad,here,beside,differs,c_inside,t_step
        registers k_least,k_lanes,m_left,m_right,across,columns,bits,lane_bit
        registers place,k_step,a_place,samples,most,c_more,k_all
        registers m_pixels,m_x,m_y,zero,t_sum,t_add,t_carry,m_splat
        registers width,height,rows,value,c_end

# Adds the lanes in which a neighbour differs, unless the neighbour is outside of the tile.
.macro  compare neighbour:req, inside:req
        absdb   \neighbour,$here,\neighbour
        clgtb   \neighbour,\neighbour,$k_least
        and     \neighbour,\neighbour,\inside
        or      $differs,$differs,\neighbour
.endm

# samples_list   lists the samples of the next pixels that differ from a neighbour
#   Out     the list, w_eye_next, w_eye_left: packets; all pixels have been listed if that is 0
#   Uses    $10-$46
function samples_list
        splat_mask $m_splat
        lqa     $a_place,sample_places
        ori     $w_eye_next,$a_place,0
        il      $zero,0
        ila     $samples,frame
        load_word $samples,FRAME_samples,$samples
        ai      $most,$a_place,TILE_PACKETS*PLACE_SIZE/4
        ai      $most,$most,TILE_PACKETS*PLACE_SIZE/4
        ai      $most,$most,TILE_PACKETS*PLACE_SIZE/4
        ai      $most,$most,TILE_PACKETS*PLACE_SIZE/4
        shli    $value,$samples,PLACE_SIZE_LOG2
        sf      $most,$value,$most                      # space for four pixels
        ceqi    $c_more,$samples,16
        lqa     $k_least,contrast
        ceqi    $k_all,$k_least,0
        ai      $k_least,$k_least,-1
        load_constant $across,0x03030303
        shufb   $k_least,$k_least,$k_least,$across
        splat   $k_all,$k_all,$m_splat
        lqa     $k_lanes,lanes
        lqa     $m_left,from_left
        lqa     $m_right,from_right
        lqa     $k_step,pixel_step
        cwd     $m_pixels,PLACE_pixels($sp)
        cwd     $m_x,PLACE_x($sp)
        cwd     $m_y,PLACE_y($sp)
        splat   $width,$g_tile_width,$m_splat
        splat   $height,$g_tile_height,$m_splat

        lqa     $row,next_row
        lqa     $column,next_column
        il      $a_quad,TILE_BYTES
        mpyu    $a_quad,$a_quad,$g_parity
        ila     $value,tile_buffers
        a       $a_quad,$a_quad,$value
        a       $a_quad,$a_quad,$column
        mpyu    $value,$row,$g_row_bytes
        a       $a_quad,$a_quad,$value
next_quad:
        hbrr    last_quad,next_quad
        ceq     $c_end,$row,$g_tile_height
        brnz    $c_end,listed
        lqd     $here,0($a_quad)
        rotmi   $across,$column,-2
        splat   $columns,$across,$m_splat
        a       $columns,$columns,$k_lanes
        splat   $rows,$row,$m_splat
        lqd     $beside,-16($a_quad)
        shufb   $beside,$beside,$here,$m_left
        cgti    $c_inside,$columns,0
        ori     $differs,$k_all,0
        compare $beside,$c_inside
        lqd     $beside,16($a_quad)
        shufb   $beside,$here,$beside,$m_right
        ai      $c_inside,$columns,1
        cgt     $c_inside,$width,$c_inside
        compare $beside,$c_inside
        sf      $t_step,$g_row_bytes,$a_quad
        lqd     $beside,0($t_step)
        cgti    $c_inside,$rows,0
        compare $beside,$c_inside
        lqx     $beside,$a_quad,$g_row_bytes
        ai      $c_inside,$rows,1
        cgt     $c_inside,$height,$c_inside
        compare $beside,$c_inside
        cgt     $c_inside,$width,$columns
        and     $differs,$differs,$c_inside
        ceqi    $differs,$differs,0
        gb      $bits,$differs                          # 1 for a pixel like its neighbours
        xori    $bits,$bits,15
        brnz    $bits,differ
alike:
        ai      $a_quad,$a_quad,16
        ai      $column,$column,16
        ceq     $c_end,$column,$g_row_bytes
        sf      $row,$c_end,$row                        # true is -1
        andc    $column,$column,$c_end
        cgt     $c_end,$a_place,$most
last_quad:
        brz     $c_end,next_quad
listed:
        stqa    $row,next_row
        stqa    $column,next_column
        sf      $w_eye_left,$w_eye_next,$a_place
        rotmi   $w_eye_left,$w_eye_left,-PLACE_SIZE_LOG2
        # Where there was no first ray, a pixel's first sample counts as that.
        rotmi   $value,$w_eye_left,-2
        selb    $value,$w_eye_left,$value,$c_more       # pixels
        lqa     $across,without_first
        and     $value,$value,$across
        shli    $across,$w_eye_left,2
        sf      $value,$value,$across
        count   samples,$value,$t_sum,$t_add,$t_carry
        # The last packet is filled up with absent rays.
        ila     $value,no_pixel
        shufb   $place,$value,$zero,$m_pixels
        il      $value,-1
        shufb   $place,$value,$place,$m_x
next_absent:
        andi    $value,$w_eye_left,3
        brz     $value,whole
        stqd    $place,0($a_place)
        ai      $a_place,$a_place,PLACE_SIZE
        ai      $w_eye_left,$w_eye_left,1
        br      next_absent
whole:
        rotmi   $w_eye_left,$w_eye_left,-2              # packets
        bi      $lr

differ: shli    $place,$row,4
        rotmi   $value,$column,-4
        a       $place,$place,$value
        ila     $value,chosen
        a       $place,$place,$value
        lqd     $value,0($place)
        cbd     $t_sum,0($place)
        shufb   $value,$bits,$value,$t_sum
        stqd    $value,0($place)

        # The place of the first of the four pixels.
        shli    $value,$row,10
        shli    $place,$column,2
        a       $value,$value,$place
        lqa     $place,sample_sums
        a       $value,$value,$place
        shufb   $place,$value,$zero,$m_pixels
        a       $value,$across,$g_tile_x
        shufb   $place,$value,$place,$m_x
        a       $value,$row,$g_tile_y
        shufb   $place,$value,$place,$m_y
    .irp lane, 0,1,2,3
        andi    $lane_bit,$bits,8>>\lane
        brz     $lane_bit,not_\lane
        rotqbyi $value,$place,PLACE_pixels
        stqd    $zero,0($value)
        stqd    $place,0($a_place)
        ai      $a_place,$a_place,PLACE_SIZE
        brz     $c_more,not_\lane
        stqd    $place,0($a_place)
        stqd    $place,PLACE_SIZE($a_place)
        stqd    $place,2*PLACE_SIZE($a_place)
        ai      $a_place,$a_place,3*PLACE_SIZE
not_\lane:
        a       $place,$place,$k_step
    .endr
        br      alike
endfunction samples_list
    .if SUMS_PITCH != 1<<10
        .error  "a row of sums has another size"
    .endif
