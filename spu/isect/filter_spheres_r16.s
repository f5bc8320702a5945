# filter_spheres_r16   of an array of spheres, those that some ray of each packet may enter
#   C       struct pair *filter_spheres_r16(const struct place *, int count, const struct sphere *,
#                                           int fours, struct pair *);
#   In      $3 places, $4 count (at least 1), $5 spheres, $6 spheres in fours (at least 1), $7
#           where pairs go; pointers 16-aligned
#   Out     pairs of each of the places' packets with such spheres, packet by packet, spheres in
#           order; one more quadword may be written
#           $3 end of the pairs
#   Uses    $3-$7, $10-$61   Saves  -   Stack  0   Calls  -
#   Domain  |d| = 1 within 4 ulp; limits as the PPU makes them
#   Error   0: no sphere is left out that a ray enters
#   Twin    lab/twins/src/cull.rs
#
# A unit direction d enters the sphere around c if c.d is above |c| times the cosine of the
# sphere's cone. The limit is slightly less than that, so that rounding never loses a sphere.
# isect_pairs_r16 makes the exact test of the pairs that pass. For each ray,
#   s = limit - c.d, which is negative if the ray may enter the sphere
# and the signs of all sixteen rays are gathered on the odd pipe.
#
# One loop runs over packets and spheres, with four spheres in each pass. Two nested loops would
# drain and fill the pipeline for every packet.

        .include "work_unit.inc"
        .include "macros.inc"
        .include "sizes.inc"

        .set    NEXT,3
        registers a_place,count,first,fours,a_pairs
        # constants
        .set    NEXT,10
        registers m_x,m_y,m_z,m_limit
        registers m_signs                               # top bytes of two quadwords' words
        registers m_halves                              # the first half of one, the last of another
        registers m_pair                                # the first word of one, then another's
        registers k_all
        # state
        registers a_four                                # the current spheres
        registers left                                  # groups of four left for the packet
        registers found                                 # pairs found so far
        # the packet
        registers place
        registers dx                                    # to 25, a row each
        .set    dy,26
        .set    dz,30
        # the sphere
        .set    NEXT,34
        registers a_sphere,pair,quad,more,cx,cy,cz,limit
        # temporaries
        registers s                                     # to 45
        .set    NEXT,46
        registers signs,signs_low,any,offset,c_last

        quadword_constants
signs_of_two:
        .int    0x0004080c,0x1014181c,0x0004080c,0x1014181c
halves: .int    0x00010203,0x04050607,0x18191a1b,0x1c1d1e1f
pair_of_object_and_place:
        .int    0x00010203,0x10111213,0x14151617,0x18191a1b

function filter_spheres_r16
        load_constant $m_x,0x00010203
        load_constant $m_y,0x04050607
        load_constant $m_z,0x08090a0b
        load_constant $m_limit,(SPHERE_ray_limit-16)*0x01010101+0x00010203
        lqa     $m_signs,signs_of_two
        lqa     $m_halves,halves
        lqa     $m_pair,pair_of_object_and_place
        il      $k_all,-1
        il      $found,0
        ori     $a_four,$first,0
        ori     $left,$fours,0
        mpyu    $count,$count,$fours                    # passes
next_four:
        lqd     $place,0($a_place)
    .irp row, 0,1,2,3
        lqd     $dx+\row,PACKET_direction_x+16*\row($place)
        lqd     $dy+\row,PACKET_direction_y+16*\row($place)
        lqd     $dz+\row,PACKET_direction_z+16*\row($place)
    .endr
    .irp sphere, 0,1,2,3
        lqd     $quad,SPHERE_SIZE*\sphere($a_four)
        lqd     $more,SPHERE_SIZE*\sphere+16($a_four)
        shufb   $cx,$quad,$quad,$m_x
        shufb   $cy,$quad,$quad,$m_y
        shufb   $cz,$quad,$quad,$m_z
        shufb   $limit,$more,$more,$m_limit
    .irp row, 0,1,2,3
        fnms    $s+\row,$cx,$dx+\row,$limit
        fnms    $s+\row,$cy,$dy+\row,$s+\row
        fnms    $s+\row,$cz,$dz+\row,$s+\row
    .endr
        shufb   $signs,$s,$s+1,$m_signs
        shufb   $signs_low,$s+2,$s+3,$m_signs
        shufb   $signs,$signs,$signs_low,$m_halves
        rotqbii $signs,$signs,1                         # signs to the bytes' last bits
        gbb     $signs,$signs
        ai      $a_sphere,$a_four,SPHERE_SIZE*\sphere
        shufb   $pair,$a_sphere,$place,$m_pair
        shlqbii $offset,$found,PAIR_SIZE_LOG2
        stqx    $pair,$a_pairs,$offset
        cg      $any,$signs,$k_all                      # 1 if any, else 0
        a       $found,$found,$any
    .endr
        # After the last sphere, the first one and the next packet.
        ai      $left,$left,-1
        ceqi    $c_last,$left,0
        ai      $a_four,$a_four,4*SPHERE_SIZE
        selb    $a_four,$a_four,$first,$c_last
        selb    $left,$left,$fours,$c_last
        andi    $c_last,$c_last,PLACE_SIZE
        a       $a_place,$a_place,$c_last
        ai      $count,$count,-1
        brnz    $count,next_four
        shli    $found,$found,PAIR_SIZE_LOG2
        a       $3,$a_pairs,$found
        bi      $lr
endfunction filter_spheres_r16
