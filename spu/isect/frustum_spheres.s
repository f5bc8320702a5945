# frustum_spheres   of an array of spheres, those that reach into a frustum
#   C       struct pair *frustum_spheres(const struct frustum *, const struct sphere *, int count,
#                                        struct pair *);
#   In      $3 frustum, $4 spheres, $5 count (0 is none), $6 where the list goes; 16-aligned
#   Out     a quadword for each such sphere, in order, whose first word is its address; one more
#           quadword may be written
#           $3 end of the list
#   Uses    $3-$6, $10-$39   Saves  -   Stack  0   Calls  -
#   Domain  unit normals, within 4 ulp; reach as the PPU makes it
#   Error   0: no sphere is left out that has a point in the frustum
#   Twin    lab/twins/src/cull.rs
#
# The four planes are in the four lanes, so one sphere needs three products:
#   s = reach + n.c, which is negative in a lane if the whole sphere is outside that plane

        .include "work_unit.inc"
        .include "macros.inc"

        .set    NEXT,3
        registers a_frustum,a_sphere,count,a_list
        # constants
        .set    NEXT,10
        registers m_x,m_y,m_z,m_reach,nx,ny,nz
        # the sphere
        .set    NEXT,20
        registers quad,more,cx,cy,cz,s
        # temporaries
        registers outside,step

function frustum_spheres
        load_constant $m_x,0x00010203
        load_constant $m_y,0x04050607
        load_constant $m_z,0x08090a0b
        load_constant $m_reach,(SPHERE_reach-16)*0x01010101+0x00010203
        lqd     $nx,FRUSTUM_normal_x($a_frustum)
        lqd     $ny,FRUSTUM_normal_y($a_frustum)
        lqd     $nz,FRUSTUM_normal_z($a_frustum)
        ori     $3,$a_list,0
        biz     $count,$lr
next_sphere:
        lqd     $quad,0($a_sphere)
        lqd     $more,16($a_sphere)
        shufb   $cx,$quad,$quad,$m_x
        shufb   $cy,$quad,$quad,$m_y
        shufb   $cz,$quad,$quad,$m_z
        shufb   $s,$more,$more,$m_reach
        fma     $s,$cx,$nx,$s
        fma     $s,$cy,$ny,$s
        fma     $s,$cz,$nz,$s
        rotqbii $outside,$s,1                           # signs to the words' last bits
        gb      $outside,$outside
        stqd    $a_sphere,0($3)
        ceqi    $step,$outside,0
        andi    $step,$step,PAIR_SIZE
        a       $3,$3,$step
        ai      $a_sphere,$a_sphere,SPHERE_SIZE
        ai      $count,$count,-1
        brnz    $count,next_sphere
        bi      $lr
endfunction frustum_spheres
