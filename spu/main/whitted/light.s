# The light of all lights on the surfaces of a batch.

        .include "work_unit.inc"
        .include "macros.inc"
        .include "driver.inc"
        .include "whitted.inc"

        .set    NEXT,3
        registers a_site,mask,value
        .set    NEXT,10
        registers amount
        registers t_sum,t_add,t_carry,a_surfaces,a_rays,left,flags,step_surfaces,step_rays,site
        registers m_pair,next_flags,listed
        registers from,a_shadow,step_shadow
    .irp row, 0,1,2,3
        registers t\row,object\row,there\row,open\row
    .endr

        .section .bss
        .align  4
        .global light_sites
light_sites:                            # the sites with rays to the light
        .skip   MAX_BATCH*SITE_SIZE
shining_size:                           # how many bytes of these have highlights; they come first
        .skip   16

        quadword_constants
pair:   .int    0x00010203,0x10111213,0x80808080,0x80808080
        # The same with SITE_SHINES.
shining_pair:
        .int    0x00010203,0x10111213,0x808080e0,0x80808080
    .if SITE_SHINES!=0x80
        .error  "a shuffle makes no SITE_SHINES"
    .endif

# sites_list   lists the surfaces of the batch whose flags, masked, have a given value
#   In      $3 where the sites go, $4 mask, $5 the masked flags' value, both in all lanes
#   Out     $3 end of the sites
#   Uses    $3, $14-$23
        .global sites_list
function sites_list
        lqa     $a_surfaces,surfaces_at
        lqa     $a_rays,rays_at
        il      $step_surfaces,SURFACES_SIZE
        il      $step_rays,RAYS16_SIZE
        lqa     $m_pair,pair
        lqa     $site,shining_pair
        andi    $listed,$value,MATERIAL_SHINES
        ori     $left,$w_count,0
        cgti    $listed,$listed,0
        hbrr    last_surfaces,next_surfaces
        lqd     $flags,SURFACES_flags($a_surfaces)
        selb    $m_pair,$m_pair,$site,$listed
next_surfaces:
        # The next surfaces' flags are loaded early; after the last ones, they are anything.
        and     $flags,$flags,$mask
        shufb   $site,$a_surfaces,$a_rays,$m_pair
        a       $a_surfaces,$a_surfaces,$step_surfaces
        lqd     $next_flags,SURFACES_flags($a_surfaces)
        ceq     $flags,$flags,$value
        a       $a_rays,$a_rays,$step_rays
        andi    $listed,$flags,SITE_SIZE
        ai      $left,$left,-1
        stqd    $site,0($a_site)
        a       $a_site,$a_site,$listed
        ori     $flags,$next_flags,0
last_surfaces:
        brnz    $left,next_surfaces
        bi      $lr
endfunction sites_list

# batch_light   adds the light of every light
#   Uses    $3-$79, w_sites, w_shining, w_light, w_here, w_traced
        .set    lights,10
        .set    end,11
        .set    bright,12
        .set    green,13
        .set    blue,14
        .set    weight,15
        .set    inverse,16
        .set    k_least,17

function batch_light
        enter
        lqa     $value,generation
        ai      $value,$value,GENERATION_SIZE           # these rays' shadow rays
        stqa    $value,generation
        il      $w_shining,0
        stqa    $w_shining,reach_known
        # Surfaces with highlights come first; the others have a shorter kernel.
        lqa     $a_site,sites_at
        il      $mask,MATERIAL_LIT|MATERIAL_SHINES
        lqa     $value,batch_flags
        andi    $value,$value,MATERIAL_SHINES
        brz     $value,none_shines
        ori     $value,$mask,0
        brsl    $lr,sites_list
        lqa     $value,sites_at
        sf      $w_shining,$value,$a_site
        rotmi   $w_shining,$w_shining,-SITE_SIZE_LOG2
        ceq     $value,$w_shining,$w_count
        ori     $w_sites,$w_shining,0
        brnz    $value,sites_listed
none_shines:
        il      $value,MATERIAL_LIT
        brsl    $lr,sites_list
        lqa     $value,sites_at
        sf      $w_sites,$value,$a_site
        rotmi   $w_sites,$w_sites,-SITE_SIZE_LOG2
sites_listed:
        ila     $w_light,frame
        load_word $w_light,FRAME_lights,$w_light
        br      next_light
dark:   ai      $w_light,$w_light,LIGHT_SIZE
next_light:
        ila     $lights,frame
        lqd     $bright,LIGHT_brightness($w_light)
        load_word $weight,FRAME_least_weight,$lights
        load_word $end,FRAME_lights,$lights
        load_word $lights,FRAME_light_count,$lights
        # The minimum share that counts is 1/4096, which is below 1/16 of a step of a byte, of the
        # largest channel's brightness, or less; 0 if every ray does.
        rotqbyi $green,$bright,4
        rotqbyi $blue,$bright,8
        shli    $lights,$lights,LIGHT_SIZE_LOG2
        a       $end,$end,$lights
        or      $bright,$bright,$green
        ceq     $end,$end,$w_light
        or      $bright,$bright,$blue
        frest   $inverse,$bright
        ilhu    $k_least,0x3980
        ori     $4,$w_sites,0
        fi      $inverse,$bright,$inverse
        brnz    $end,lit
        load_word $5,LIGHT_falloff,$w_light
        ila     $lr,in_reach
        ila     $3,dark
        cgti    $5,$5,0
        brnz    $5,light_reaches
in_reach:
        hbrr    rays_call,shadow_rays_r16
        ceqi    $weight,$weight,0
        ori     $5,$w_light,0
        ila     $6,SCENE_ADDRESS
        lqa     $8,shadow_rays_at
        fm      $7,$inverse,$k_least
        ila     $9,light_sites
        lqa     $3,sites_at
        andc    $7,$7,$weight
rays_call:
        brsl    $lr,shadow_rays_r16
        ila     $amount,light_sites
        rotqbyi $w_here,$3,4
        sf      $w_traced,$amount,$3
        rotqbyi $value,$3,8
        rotmi   $w_traced,$w_traced,-SITE_SIZE_LOG2
        stqa    $value,shining_size
        lqa     $amount,frame
        brz     $w_traced,dark
        rotqbyi $amount,$amount,FRAME_features
        andi    $amount,$amount,FEATURE_NO_SHADOWS
        brnz    $amount,lit_by
        lqa     $amount,visibility
        brnz    $amount,take
taken:  count   shadow,$w_here,$t_sum,$t_add,$t_carry
        paths_sent
        hbrr    trace_call,packets_trace
        phase_ends $g_ticks_shade,$amount
        ori     $6,$w_here,0
        lqa     $3,shadow_rays_at
        ori     $4,$w_traced,0
        load_word $5,LIGHT_falloff,$w_light
        rotmai  $5,$5,-31                               # -1 if it is infinitely far
        andc    $lights,$w_light,$5
        or      $5,$lights,$5
trace_call:
        brsl    $lr,packets_trace
        lqa     $3,keeps_paths
        brz     $3,paths_kept
        lqa     $3,shadow_rays_at
        ori     $4,$w_traced,0
        il      $5,0
        brsl    $lr,paths_add
paths_kept:
        lqa     $amount,visibility
        brnz    $amount,return
lit_by:
        # Highlights take long, so packets are left out that the light does not reach.
        lqa     $left,shining_size
        lqa     $a_shadow,shadow_rays_at
        rotmi   $left,$left,-SITE_SIZE_LOG2
        brz     $left,none_shone
        ila     $from,light_sites
        ori     $listed,$from,0
        cwd     $m_pair,SITE_shadow($sp)
        ila     $6,SCENE_ADDRESS
        il      $step_shadow,RAYS16_SIZE
        ceq     $next_flags,$left,$w_traced
    .irp row, 0,1,2,3
        lqd     $t\row,RAYS16_t+16*\row($a_shadow)
        lqd     $object\row,RAYS16_object+16*\row($a_shadow)
    .endr
next_shadow:
        hbrr    last_shadow,next_shadow
        lqd     $site,0($from)
        # The next packet's rays are loaded early; after the last one, they are anything.
    .irp row, 0,1,2,3
        cgti    $there\row,$t\row,-1
        lqd     $t\row,RAYS16_SIZE+RAYS16_t+16*\row($a_shadow)
        ceq     $open\row,$object\row,$6
        lqd     $object\row,RAYS16_SIZE+RAYS16_object+16*\row($a_shadow)
    .endr
        and     $there0,$there0,$open0
        shufb   $site,$a_shadow,$site,$m_pair
        and     $there1,$there1,$open1
        and     $there2,$there2,$open2
        and     $there3,$there3,$open3
        or      $there0,$there0,$there1
        stqd    $site,0($listed)
        ai      $from,$from,SITE_SIZE
        or      $there2,$there2,$there3
        a       $a_shadow,$a_shadow,$step_shadow
        or      $there0,$there0,$there2
        ai      $left,$left,-1
        orx     $there0,$there0
        andi    $there0,$there0,SITE_SIZE
        a       $listed,$listed,$there0
last_shadow:
        brnz    $left,next_shadow
        hbrr    light_call,light_r16
        ila     $3,light_sites
        ori     $5,$w_light,0
        sf      $4,$3,$listed
        ila     $lr,none_shone
        ila     $amount,dark
        rotmi   $4,$4,-SITE_SIZE_LOG2
        selb    $lr,$lr,$amount,$next_flags             # straight to the next light if all shine
        biz     $4,$lr
light_call:
        br      light_r16
none_shone:
        hbrr    lambert_call,lambert_r16
        lqa     $7,shining_size
        ila     $3,light_sites
        lqa     $amount,shadow_rays_at
        ori     $5,$w_light,0
        rotmi   $4,$7,-SITE_SIZE_LOG2
        a       $3,$3,$7
        mpyi    $7,$7,RAYS16_SIZE/SITE_SIZE
        sf      $4,$4,$w_traced
        brz     $4,dark
        ila     $6,SCENE_ADDRESS
        a       $7,$7,$amount
lambert_call:
        brsl    $lr,lambert_r16
        br      dark
        # Rays that need not be traced are taken out meanwhile.
take:   brsl    $lr,colour_take
        ori     $w_here,$3,0
        brnz    $w_here,taken
        brz     $4,dark
return: brsl    $lr,colour_return
        br      lit_by
lit:
        phase_ends $g_ticks_shade,$amount
        leave
endfunction batch_light
