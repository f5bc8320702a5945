# Which lights with a range reach a batch.

        .include "work_unit.inc"
        .include "macros.inc"
        .include "driver.inc"
        .include "whitted.inc"

        .section .bss
        .align  4
        .global reach_known
reach_known:                            # whether the box is that of this batch
        .skip   16
        # The box around the batch's lit points: x, y, z, x.
box_low:
        .skip   16
box_high:
        .skip   16

        .set    NEXT,20                                 # batch_light keeps its values below
        registers t_value,c_value,m_y,m_z
        registers a_site,left,site,a_rays,rows,k_farthest,t,hit
    .irp axis, x,y,z
        registers low_\axis,high_\axis,point_\axis,below_\axis,above_\axis
    .endr
        # the test
        registers place,falloff,below,above,part

# Brings the smallest of a register's words to all of them, or the largest.
.macro  of_words value:req, a:req, b:req
    .irp bytes, 8,4
        rotqbyi $t_value,\value,\bytes
        fcgt    $c_value,\a,\b
        selb    \value,\value,$t_value,$c_value
    .endr
.endm

# batch_box   the box around the lit points of the batch
#   In      w_sites
#   Out     box_low, box_high, reach_known
#   Uses    $20-$46
function batch_box
        lqa     $a_site,sites_at
        ori     $left,$w_sites,0
        ilhu    $k_farthest,FARTHEST>>16
    .irp axis, x,y,z
        ilhu    $low_\axis,FARTHEST>>16
        ilhu    $high_\axis,(FARTHEST>>16)+0x8000       # negative
    .endr
next_site:
        lqd     $site,SITE_surfaces($a_site)
        il      $rows,4
        ai      $a_site,$a_site,SITE_SIZE
        rotqbyi $a_rays,$site,SITE_rays
next_row:
        hbrr    last_row,next_row
        lqd     $t,RAYS16_t($a_rays)
    .irp axis, x,y,z
        lqd     $point_\axis,SURFACES_point_\axis($site)
    .endr
        ai      $rows,$rows,-1
        ai      $a_rays,$a_rays,16
        ai      $site,$site,16
        clgt    $hit,$k_farthest,$t                     # neither without a ray nor without a hit
    .irp axis, x,y,z
        fcgt    $below_\axis,$low_\axis,$point_\axis
        fcgt    $above_\axis,$point_\axis,$high_\axis
    .endr
    .irp axis, x,y,z
        and     $below_\axis,$below_\axis,$hit
        and     $above_\axis,$above_\axis,$hit
    .endr
    .irp axis, x,y,z
        selb    $low_\axis,$low_\axis,$point_\axis,$below_\axis
        selb    $high_\axis,$high_\axis,$point_\axis,$above_\axis
    .endr
last_row:
        brnz    $rows,next_row
        ai      $left,$left,-1
        brnz    $left,next_site
    .irp axis, x,y,z
        of_words $low_\axis,$low_\axis,$t_value
        of_words $high_\axis,$t_value,$high_\axis
    .endr
        fsmbi   $m_y,0x0f00
        fsmbi   $m_z,0x00f0
    .irp side, low,high
        selb    $\side\()_x,$\side\()_x,$\side\()_y,$m_y
        selb    $\side\()_x,$\side\()_x,$\side\()_z,$m_z
        stqa    $\side\()_x,box_\side
    .endr
        il      $m_y,-1
        stqa    $m_y,reach_known
        bi      $lr
endfunction batch_box

# light_reaches   returns if a light with a range may reach the batch
#   In      w_light, w_sites, $3 where to go if it reaches no point of the batch
#   Uses    $20-$51
#
# The distance from the light to the box is compared with 1.008 times the range, which is more than
# all roundings: shadow_rays_r16 decides for each point.
function light_reaches
        lqa     $t_value,reach_known
        hbr     out_of_reach,$3                         # as most are
        brz     $t_value,unknown
known:  lqd     $place,LIGHT_position($w_light)
        lqa     $low_x,box_low
        lqa     $high_x,box_high
        rotqbyi $falloff,$place,LIGHT_falloff
        fs      $below,$low_x,$place
        fs      $above,$place,$high_x
        fcgt    $c_value,$below,$above
        selb    $part,$above,$below,$c_value
        rotmai  $c_value,$part,-31
        andc    $part,$part,$c_value
        fm      $part,$part,$part
        rotqbyi $below,$part,4
        rotqbyi $above,$part,8
        fa      $part,$part,$below
        fa      $part,$part,$above
        ilhu    $c_value,0x3f82                         # 1.016, the square
        fm      $part,$part,$falloff
        fcgt    $c_value,$c_value,$part
out_of_reach:
        biz     $c_value,$3
        bi      $lr

unknown:
        enter
        brsl    $lr,batch_box
        ai      $sp,$sp,32
        lqd     $lr,16($sp)
        br      known
endfunction light_reaches
