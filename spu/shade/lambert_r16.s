# lambert_r16   what a light adds to surfaces without a highlight
#   C       void lambert_r16(const struct site *, int count, const struct light *,
#                            const struct object *background, const struct ray_packet *);
#   In      $3 sites, $4 count (at least 1), $5 light, $6 the background's object, $7 the
#           sites' packets of shadow rays, consecutive; pointers 16-aligned
#   Out     the sites' surfaces: lit, in lanes whose shadow ray is there (t >= 0) and has met
#           nothing
#   Uses    $3-$4, $6-$27, $58-$59   Saves  -   Stack  0   Calls  -
#   Domain  N.L >= 0 where there is a shadow ray; shares from 0 to 1
#   Error   4 ulp of the brightness
#   Twin    lab/twins/src/light.rs
#
#   lit += brightness fade diffuse (N.L) colour, with light_r16's fade
# The result has the same bits as that of light_r16 with a highlight of 0.

        .include "light_tmpl.inc"

        .set    step,12                                 # from packet to packet

function lambert_r16
        light_begin
        il      $step,RAYS16_SIZE
next_site:
        lqd     $a_surfaces,SITE_surfaces($a_site)
    .irp row, 0,1,2,3
        light_row \row
        light_add \row
    .endr
        a       $a_shadow,$a_shadow,$step
        light_next
        brnz    $count,next_site
        bi      $lr
endfunction lambert_r16
