# The light of all lights on the surfaces of a batch.

        .include "work_unit.inc"
        .include "macros.inc"
        .include "driver.inc"
        .include "whitted.inc"

        .set    NEXT,3
        registers a_site,mask,value,a_shadow
        .set    NEXT,10
        registers amount
        registers t_sum,t_add,t_carry,a_surfaces,a_rays,left,flags,step_surfaces,step_rays,site
        registers m_pair,m_third,next_flags,listed,further

        .section .rodata
        .align  4
pair:   .int    0x00010203,0x10111213,0x80808080,0x80808080
third:  .int    0x00010203,0x04050607,0x10111213,0x80808080

# sites_list   lists the surfaces of the batch whose flags, masked, have a given value
#   In      $3 where the sites go, $4 mask, $5 the masked flags' value, $6 packet of
#           shadow rays of the first site
#   Out     $3 behind the last site
#   Uses    $3, $6, $14-$27
        .global sites_list
function sites_list
        ila     $a_surfaces,arena+BATCH_SURFACES
        ila     $a_rays,arena+BATCH_RAYS
        il      $step_surfaces,SURFACES_SIZE
        il      $step_rays,RAYS16_SIZE
        lqa     $m_pair,pair
        lqa     $m_third,third
        ori     $left,$w_count,0
        hbrr    last_surfaces,next_surfaces
        lqd     $flags,SURFACES_flags($a_surfaces)
next_surfaces:
        # The next surfaces' flags are loaded early; after the last ones, they are anything.
        and     $flags,$flags,$mask
        shufb   $site,$a_surfaces,$a_rays,$m_pair
        a       $a_surfaces,$a_surfaces,$step_surfaces
        lqd     $next_flags,SURFACES_flags($a_surfaces)
        ceq     $flags,$flags,$value
        shufb   $site,$site,$a_shadow,$m_third
        andi    $listed,$flags,SITE_SIZE
        and     $further,$flags,$step_rays
        a       $a_rays,$a_rays,$step_rays
        ai      $left,$left,-1
        stqd    $site,0($a_site)
        a       $a_site,$a_site,$listed
        a       $a_shadow,$a_shadow,$further
        ori     $flags,$next_flags,0
last_surfaces:
        brnz    $left,next_surfaces
        bi      $lr
endfunction sites_list

# batch_light   adds the light of every light
#   Uses    $3-$79, w_sites, w_shining, w_light
        .set    lights,10
        .set    end,11

function batch_light
        enter
        lqa     $value,generation
        ai      $value,$value,GENERATION_SIZE           # these rays' shadow rays
        stqa    $value,generation
        # Surfaces with highlights come first; the others have a shorter kernel.
        il      $w_shining,0
        ila     $a_site,arena+BATCH_SITES
        il      $mask,MATERIAL_LIT|MATERIAL_SHINES
        ila     $a_shadow,arena+SHADOW_RAYS
        lqa     $value,batch_flags
        andi    $value,$value,MATERIAL_SHINES
        brz     $value,none_shines
        ori     $value,$mask,0
        brsl    $lr,sites_list
        ila     $value,arena+BATCH_SITES
        sf      $w_shining,$value,$a_site
        rotmi   $w_shining,$w_shining,-SITE_SIZE_LOG2
        ceq     $value,$w_shining,$w_count
        ori     $w_sites,$w_shining,0
        brnz    $value,sites_listed
none_shines:
        il      $value,MATERIAL_LIT
        brsl    $lr,sites_list
        ila     $value,arena+BATCH_SITES
        sf      $w_sites,$value,$a_site
        rotmi   $w_sites,$w_sites,-SITE_SIZE_LOG2
sites_listed:
        ila     $w_light,frame
        load_word $w_light,FRAME_lights,$w_light
next_light:
        hbrr    rays_call,shadow_rays_r16
        ila     $lights,frame
        load_word $end,FRAME_lights,$lights
        load_word $lights,FRAME_light_count,$lights
        shli    $lights,$lights,LIGHT_SIZE_LOG2
        a       $end,$end,$lights
        ceq     $end,$end,$w_light
        brnz    $end,lit
        ila     $3,arena+BATCH_SITES
        ori     $4,$w_sites,0
        ori     $5,$w_light,0
        ila     $6,SCENE_ADDRESS
rays_call:
        brsl    $lr,shadow_rays_r16
        hbrr    trace_call,packets_trace
        sum_lanes $3,$amount
        brz     $3,dark
        lqa     $amount,frame
        rotqbyi $amount,$amount,FRAME_features
        andi    $amount,$amount,FEATURE_NO_SHADOWS
        brnz    $amount,unshadowed
        count   shadow,$3,$t_sum,$t_add,$t_carry
        phase_ends $g_ticks_shade,$amount
        ori     $6,$3,0
        ila     $3,arena+SHADOW_RAYS
        ori     $4,$w_sites,0
        load_word $5,LIGHT_directional,$w_light
        andc    $lights,$w_light,$5
        or      $5,$lights,$5                           # -1 if the light is infinitely far away
trace_call:
        brsl    $lr,packets_trace
unshadowed:
        hbrr    matt_call,lambert_r16
        brz     $w_shining,matt
        hbrr    light_call,light_r16
        ila     $3,arena+BATCH_SITES
        ori     $4,$w_shining,0
        ori     $5,$w_light,0
        ila     $6,SCENE_ADDRESS
light_call:
        brsl    $lr,light_r16
matt:   sf      $4,$w_shining,$w_sites
        brz     $4,dark
        ila     $3,arena+BATCH_SITES
        shli    $5,$w_shining,SITE_SIZE_LOG2
        a       $3,$3,$5
        ori     $5,$w_light,0
        ila     $6,SCENE_ADDRESS
matt_call:
        brsl    $lr,lambert_r16
dark:   ai      $w_light,$w_light,LIGHT_SIZE
        br      next_light
lit:
        phase_ends $g_ticks_shade,$amount
        leave
endfunction batch_light
