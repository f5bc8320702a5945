# filter_spheres_r16   of an array of spheres, those that some ray of each packet may enter
#   C       struct pair *filter_spheres_r16(const struct place *, int count, const struct sphere *,
#                                           int fours, struct pair *);
#   In      $3 places, $4 count (at least 1), $5 spheres, $6 spheres in fours (at least 1), $7
#           where pairs go; pointers 16-aligned
#   Out     pairs of each of the places' packets with such spheres, packet by packet, spheres in
#           order; one more quadword may be written
#           $3 behind the last pair
#   Uses    $2-$6, $8-$79   Saves  -   Stack  0   Calls  -
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
# Scheduled by spu schedule from filter_spheres_r16.s

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

        .section .rodata
        .align  4
signs_of_two:
        .int    0x0004080c,0x1014181c,0x0004080c,0x1014181c
halves: .int    0x00010203,0x04050607,0x18191a1b,0x1c1d1e1f
pair_of_object_and_place:
        .int    0x00010203,0x10111213,0x14151617,0x18191a1b

function filter_spheres_r16
        .set count_2,79; .set left_2,2; .set place_2,8; .set a_four_2,9; .set more_2,30
        .set quad_2,62; .set quad_3,2; .set a_sphere_2,68; .set c_last_2,21; .set limit_2,49
        .set a_sphere_3,75; .set cx_2,55; .set a_sphere_4,26; .set more_3,59; .set cx_3,63
        .set limit_3,65; .set s1_2,31; .set dy_2,21; .set s_2,40; .set dy1_2,38; .set s2_2,28
        .set s3_2,48; .set dy2_2,39; .set s_3,30; .set cy_2,67; .set s2_3,27; .set quad_4,51
        .set s1_3,32; .set cx_4,61; .set limit_4,64; .set cy_3,69; .set dz1_2,54; .set s2_4,18
        .set dz_2,57; .set dz2_2,37; .set cz_2,60; .set cz_3,70; .set limit_5,71; .set cx_5,72
        .set cy_4,52; .set more_4,36; .set quad_5,41; .set more_5,24; .set quad_6,53; .set cz_4,74
        .set s2_5,2; .set cy_5,76; .set s_4,22; .set s3_3,58; .set cz_5,46; .set s3_4,25
        .set s1_4,23; .set a_four_3,24; .set c_last_3,47; .set pair_2,66; .set signs_2,18
        .set s_5,21; .set signs_3,22; .set s3_5,29; .set signs_low_2,2; .set place_3,79
        .set s_6,39; .set s1_5,56; .set signs_low_3,28; .set s_7,52; .set signs_4,21
        .set pair_3,73; .set signs_5,57; .set a_sphere_5,78; .set pair_4,77; .set offset_2,9
        .set a_four_4,8; .set found_2,9; .set c_last_4,2; .set signs_low_4,21; .set cz_6,41
        .set signs_6,51; .set s2_6,24; .set signs_7,47; .set s1_6,55; .set signs_8,56; .set s1_7,21
        .set offset_3,55; .set any_2,37; .set any_3,39; .set signs_9,31; .set offset_4,26
        .set signs_low_5,24; .set s1_8,22; .set offset_5,23; .set dx3_2,2; .set s2_7,3
        .set dy2_3,4; .set s1_9,5; .set cy_6,6; .set s3_6,8; .set s1_10,10; .set dz_3,11
        .set s2_8,13; .set pair_5,2; .set pair_6,3; .set s3_7,4; .set s1_11,6; .set signs_low_6,8
        .set any_4,10; .set signs_low_7,11; .set found_3,6; .set signs_10,4; .set offset_6,4
        .set found_4,5; .set a_sphere_6,2; .set a_sphere_7,8; .set a_sphere_8,9; .set quad_7,22
        .set more_6,23; .set quad_8,25; .set dx_2,26; .set dx1_2,27; .set c_last_5,28
        .set dx2_2,29; .set dx3_3,30; .set more_7,28; .set cx_6,31; .set limit_6,23; .set dy_3,32
        .set dy1_3,33; .set dy2_4,35; .set dy3_2,37; .set s1_12,28; .set cy_7,40; .set s2_9,46
        .set quad_9,47; .set s3_8,23; .set more_8,18; .set s_8,31; .set cy_8,48; .set s1_13,49
        .set dz_4,51; .set s2_10,52; .set dz1_3,53; .set s3_9,38; .set dz2_3,41; .set dz3_2,54
        .set cy_9,55; .set cz_7,36; .set cx_7,40; .set limit_7,18; .set cz_8,22; .set cz_9,25
        .set cz_10,47; .set pair_7,34; .set offset_7,56; .set pair_8,8; .set pair_9,9
        .set s1_14,26; .set s3_10,18; .set signs_11,29; .set signs_low_8,23; .set any_5,21
        .set found_5,2; .set offset_8,20
        mpyu    $count,$count,$fours                    # 0e passes
        lqa     $m_signs,signs_of_two                   # 0o
        ilhu    $m_x,1                                  # 1e
        lqa     $m_halves,halves                        # 1o
        ilhu    $m_y,0x405                              # 2e
        lqa     $m_pair,pair_of_object_and_place        # 2o
        ilhu    $m_z,0x809                              # 3e
        ilhu    $m_limit,0x405                          # 4e
        iohl    $m_x,515                                # 5e
        iohl    $m_y,0x607                              # 6e
        clgti   $count_2,$count,2                       # 7e at least as many passes as overlap
        iohl    $m_z,0xa0b                              # 8e
        iohl    $m_limit,0x607                          # 9e
        il      $k_all,-1                               # 10e
        il      $found,0                                # 11e
        ori     $a_four,$first,0                        # 12e
        ori     $left,$fours,0                          # 13e
        brz     $count_2,next_four_short                # 13o too few passes
        ai      $left_2,$left,-1                        # 15e
        lqd     $place_2,0($a_place)                    # 15o
        ai      $a_four_2,$a_four,192                   # 16e
        lqd     $more_2,64($a_four)                     # 16o
        ceqi    $c_last,$left_2,0                       # 17e
        lqd     $quad_2,48($a_four)                     # 17o
        ai      $a_sphere,$a_four,0                     # 18e
        lqd     $more,16($a_four)                       # 18o
        selb    $a_four_2,$a_four_2,$first,$c_last      # 19e
        lqd     $quad,0($a_four)                        # 19o
        selb    $left,$left_2,$fours,$c_last            # 20e
        lqd     $quad_3,96($a_four)                     # 20o
        ai      $a_sphere_2,$a_four,48                  # 21e
        lqd     $dx+1,16($place_2)                      # 21o
        ai      $left,$left,-1                          # 22e
        lqd     $dx,0($place_2)                         # 22o
        ai      $count,$count,-1                        # 23e
        lqd     $dx+2,32($place_2)                      # 23o
        andi    $c_last_2,$c_last,16                    # 24e
        lqd     $dx+3,48($place_2)                      # 24o
        ceqi    $c_last,$left,0                         # 25e
        shufb   $limit_2,$more_2,$more_2,$m_limit       # 25o
        ai      $a_sphere_3,$a_four,96                  # 26e
        shufb   $cx_2,$quad_2,$quad_2,$m_x              # 26o
        ai      $a_sphere_4,$a_four,144                 # 27e
        lqd     $more_3,112($a_four)                    # 27o
        a       $a_place,$a_place,$c_last_2             # 28e
        shufb   $cx_3,$quad,$quad,$m_x                  # 28o
        ai      $count,$count,-1                        # 29e
        shufb   $limit_3,$more,$more,$m_limit           # 29o
        fnms    $s1_2,$cx_2,$dx+1,$limit_2              # 30e
        lqd     $dy_2,64($place_2)                      # 30o
        fnms    $s_2,$cx_2,$dx,$limit_2                 # 31e
        lqd     $dy1_2,80($place_2)                     # 31o
        fnms    $s2_2,$cx_2,$dx+2,$limit_2              # 32e
        lqd     $dy+3,112($place_2)                     # 32o
        fnms    $s3_2,$cx_3,$dx+3,$limit_3              # 33e
        lqd     $dy2_2,96($place_2)                     # 33o
        fnms    $s_3,$cx_3,$dx,$limit_3                 # 34e
        shufb   $cy_2,$quad_2,$quad_2,$m_y              # 34o
        fnms    $s2_3,$cx_3,$dx+2,$limit_3              # 35e
        lqd     $quad_4,144($a_four)                    # 35o
        fnms    $s1_3,$cx_3,$dx+1,$limit_3              # 36e
        shufb   $cx_4,$quad_3,$quad_3,$m_x              # 36o
        fnms    $s+3,$cx_2,$dx+3,$limit_2               # 37e
        shufb   $limit_4,$more_3,$more_3,$m_limit       # 37o
        fnms    $s_2,$cy_2,$dy_2,$s_2                   # 38e
        lqd     $more_3,160($a_four)                    # 38o
        fnms    $s1_2,$cy_2,$dy1_2,$s1_2                # 39e
        shufb   $cy_3,$quad,$quad,$m_y                  # 39o
        fnms    $s2_2,$cy_2,$dy2_2,$s2_2                # 40e
        lqd     $dz1_2,144($place_2)                    # 40o
        fnms    $s2_4,$cx_4,$dx+2,$limit_4              # 41e
        lqd     $dz_2,128($place_2)                     # 41o
        fnms    $s+1,$cx_4,$dx+1,$limit_4               # 42e
        lqd     $dz+3,176($place_2)                     # 42o
        fnms    $s3_2,$cy_3,$dy+3,$s3_2                 # 43e
        lqd     $dz2_2,160($place_2)                    # 43o
        fnms    $s_3,$cy_3,$dy_2,$s_3                   # 44e
        shufb   $cz_2,$quad_2,$quad_2,$m_z              # 44o
        fnms    $s1_3,$cy_3,$dy1_2,$s1_3                # 45e
        shufb   $cz_3,$quad,$quad,$m_z                  # 45o
        fnms    $s2_3,$cy_3,$dy2_2,$s2_3                # 46e
        shufb   $limit_5,$more_3,$more_3,$m_limit       # 46o
        fnms    $s+3,$cy_2,$dy+3,$s+3                   # 47e
        shufb   $cx_5,$quad_4,$quad_4,$m_x              # 47o
        fnms    $s_2,$cz_2,$dz_2,$s_2                   # 48e
        shufb   $cy_4,$quad_3,$quad_3,$m_y              # 48o
        fnms    $s1_2,$cz_2,$dz1_2,$s1_2                # 49e
        lqd     $more_4,16($a_four_2)                   # 49o
        fnms    $s3_2,$cz_3,$dz+3,$s3_2                 # 50e
        lqd     $quad_5,0($a_four_2)                    # 50o
        fnms    $s+2,$cx_5,$dx+2,$limit_5               # 51e
        lqd     $more_5,64($a_four_2)                   # 51o
        fnms    $s,$cx_5,$dx,$limit_5                   # 52e
        lqd     $quad_6,96($a_four_2)                   # 52o
        fnms    $s2_4,$cy_4,$dy2_2,$s2_4                # 53e
        lqd     $more_3,112($a_four_2)                  # 53o
        fnms    $s_3,$cz_3,$dz_2,$s_3                   # 54e
        lqd     $quad_2,48($a_four_2)                   # 54o
        fnms    $s1_3,$cz_3,$dz1_2,$s1_3                # 55e
        shufb   $cz_4,$quad_3,$quad_3,$m_z              # 55o
        fnms    $s2_5,$cz_3,$dz2_2,$s2_3                # 56e
        shufb   $cy_5,$quad_4,$quad_4,$m_y              # 56o
        fnms    $s_4,$cx_4,$dx,$limit_4                 # 57e
        shufb   $pair,$a_sphere,$place_2,$m_pair        # 57o
        fnms    $s3_3,$cx_5,$dx+3,$limit_5              # 58e
        shufb   $cz_5,$quad_4,$quad_4,$m_z              # 58o
        fnms    $s3_4,$cx_4,$dx+3,$limit_4              # 59e
        shufb   $limit_2,$more_5,$more_5,$m_limit       # 59o
        fnms    $s1_4,$cx_5,$dx+1,$limit_5              # 60e
        lqd     $quad_4,144($a_four_2)                  # 60o
        ai      $a_four_3,$a_four_2,192                 # 61e
        shufb   $cx_4,$quad_6,$quad_6,$m_x              # 61o
        ai      $a_sphere,$a_four_2,0                   # 62e
        shufb   $cx_3,$quad_5,$quad_5,$m_x              # 62o
        selb    $left,$left,$fours,$c_last              # 63e
        shufb   $limit_4,$more_3,$more_3,$m_limit       # 63o
        andi    $c_last_3,$c_last,16                    # 64e
        lqd     $more_3,160($a_four_2)                  # 64o
        fnms    $s,$cy_5,$dy_2,$s                       # 65e
        shufb   $limit_3,$more_4,$more_4,$m_limit       # 65o
        fnms    $s+1,$cy_4,$dy1_2,$s+1                  # 66e
        shufb   $pair_2,$a_sphere_2,$place_2,$m_pair    # 66o
        fnms    $s2_3,$cz_4,$dz2_2,$s2_4                # 67e
        shufb   $cy_2,$quad_2,$quad_2,$m_y              # 67o
        fnms    $s+2,$cy_5,$dy2_2,$s+2                  # 68e
        shufb   $cx_2,$quad_2,$quad_2,$m_x              # 68o
        fnms    $s+3,$cz_2,$dz+3,$s+3                   # 69e
        shufb   $cy_3,$quad_5,$quad_5,$m_y              # 69o
        ai      $a_sphere_2,$a_four_2,48                # 70e
        shufb   $signs_2,$s_2,$s1_2,$m_signs            # 70o
        fnms    $s2_2,$cz_2,$dz2_2,$s2_2                # 71e
        shufb   $cz_3,$quad_5,$quad_5,$m_z              # 71o
        fnms    $s_5,$cy_4,$dy_2,$s_4                   # 72e
        hbrr    next_four_back,next_four                # 72o hint
        fnms    $s3_4,$cy_4,$dy+3,$s3_4                 # 73e
        shufb   $signs_3,$s_3,$s1_3,$m_signs            # 73o
        fnms    $s3_5,$cy_5,$dy+3,$s3_3                 # 74e
        shufb   $signs_low_2,$s2_5,$s3_2,$m_signs       # 74o
        fnms    $s1_4,$cy_5,$dy1_2,$s1_4                # 75e
        lqd     $place_3,0($a_place)                    # 75o
        fnms    $s_6,$cz_5,$dz_2,$s                     # 76e
        shufb   $limit_5,$more_3,$more_3,$m_limit       # 76o
        fnms    $s1_5,$cz_4,$dz1_2,$s+1                 # 77e
        shufb   $signs_low_3,$s2_2,$s+3,$m_signs        # 77o
        fnms    $s_7,$cz_4,$dz_2,$s_5                   # 78e
        shufb   $signs_4,$signs_3,$signs_low_2,$m_halves # 78o
        fnms    $s3_4,$cz_4,$dz+3,$s3_4                 # 79e
        shufb   $cx_5,$quad_4,$quad_4,$m_x              # 79o
        fnms    $s+3,$cz_5,$dz+3,$s3_5                  # 80e
        shufb   $pair_3,$a_sphere_3,$place_2,$m_pair    # 80o
        fnms    $s+2,$cz_5,$dz2_2,$s+2                  # 81e
        shufb   $cz_4,$quad_6,$quad_6,$m_z              # 81o
        fnms    $s1_2,$cz_5,$dz1_2,$s1_4                # 82e
        rotqbii $signs,$signs_4,1                       # 82o signs to the bytes' last bits
        ai      $a_sphere_3,$a_four_2,96                # 83e
        shufb   $signs_5,$signs_2,$signs_low_3,$m_halves # 83o
        ai      $a_sphere_5,$a_four_2,144               # 84e
        shufb   $cy_5,$quad_4,$quad_4,$m_y              # 84o
        selb    $a_four,$a_four_3,$first,$c_last        # 85e
        shufb   $pair_4,$a_sphere_4,$place_2,$m_pair    # 85o
        a       $a_place,$a_place,$c_last_3             # 86e
        shlqbii $offset_2,$found,4                      # 86o
        nop     $127                                    # 87e pairing
        gbb     $signs,$signs                           # 87o
next_four:
        ai      $left_2,$left,-1                        # 0e
            stqx    $pair,$a_pairs,$offset_2            # 0o
        ai      $count,$count,-1                        # 1e
        lqd     $more,16($a_four)                       # 1o
            cg      $any,$signs,$k_all                  # 2e 1 if any, else 0
            shufb   $signs_low,$s2_3,$s3_4,$m_signs     # 2o
        ceqi    $c_last,$left_2,0                       # 3e
            shufb   $pair,$a_sphere,$place_3,$m_pair    # 3o
        ai      $a_four_4,$a_four,192                   # 4e
            lqd     $dy,64($place_3)                    # 4o
        ai      $a_sphere,$a_four,0                     # 5e
            lqd     $dx+2,32($place_3)                  # 5o
            a       $found_2,$found,$any                # 6e
            lqd     $dx+3,48($place_3)                  # 6o
        selb    $left,$left_2,$fours,$c_last            # 7e
            lqd     $dx+1,16($place_3)                  # 7o
        andi    $c_last_4,$c_last,16                    # 8e
            lqd     $dx,0($place_3)                     # 8o
        lqd     $quad,0($a_four)                        # 9o
            shufb   $signs_low_4,$s+2,$s+3,$m_signs     # 10o
            fnms    $s+2,$cx_5,$dx+2,$limit_5           # 11e
            lqd     $dy+3,112($place_3)                 # 11o
            fnms    $s2_3,$cx_4,$dx+2,$limit_4          # 12e
            lqd     $dz+3,176($place_3)                 # 12o
            fnms    $s2_2,$cx_2,$dx+2,$limit_2          # 13e
        lqd     $more_2,64($a_four)                     # 13o
            fnms    $s+1,$cx_4,$dx+1,$limit_4           # 14e
            shufb   $signs,$s_6,$s1_2,$m_signs          # 14o
            fnms    $s+3,$cx_2,$dx+3,$limit_2           # 15e
            lqd     $dz+2,160($place_3)                 # 15o
            fnms    $s1_2,$cx_2,$dx+1,$limit_2          # 16e
            lqd     $dy1_2,80($place_3)                 # 16o
            fnms    $s,$cx_4,$dx,$limit_4               # 17e
            lqd     $dy2_2,96($place_3)                 # 17o
            fnms    $s_2,$cx_2,$dx,$limit_2             # 18e
            shufb   $cz_6,$quad_4,$quad_4,$m_z          # 18o
            fnms    $s3_2,$cx_3,$dx+3,$limit_3          # 19e
        shufb   $limit_2,$more_2,$more_2,$m_limit       # 19o
            fnms    $s_3,$cx_3,$dx,$limit_3             # 20e
            shufb   $signs_6,$s_7,$s1_5,$m_signs        # 20o
            fnms    $s_4,$cx_5,$dx,$limit_5             # 21e
            shufb   $cy_4,$quad_6,$quad_6,$m_y          # 21o
            fnms    $s2_6,$cx_3,$dx+2,$limit_3          # 22e
        lqd     $quad_6,96($a_four)                     # 22o
            fnms    $s+3,$cy_2,$dy+3,$s+3               # 23e
            lqd     $dz1_2,144($place_3)                # 23o
            fnms    $s_2,$cy_2,$dy,$s_2                 # 24e
            shufb   $signs_7,$signs_6,$signs_low,$m_halves # 24o
            fnms    $s3_2,$cy_3,$dy+3,$s3_2             # 25e
        lqd     $quad_4,144($a_four)                    # 25o
            fnms    $s1_6,$cx_3,$dx+1,$limit_3          # 26e
            rotqbii $signs_8,$signs_5,1                 # 26o signs to the bytes' last bits
            fnms    $s_4,$cy_5,$dy,$s_4                 # 27e
            lqd     $dz_2,128($place_3)                 # 27o
            fnms    $s3_3,$cx_5,$dx+3,$limit_5          # 28e
            rotqbii $signs_7,$signs_7,1                 # 28o signs to the bytes' last bits
            fnms    $s+1,$cy_4,$dy1_2,$s+1              # 29e
        lqd     $more_3,112($a_four)                    # 29o
            fnms    $s_3,$cy_3,$dy,$s_3                 # 30e
            shufb   $cz_2,$quad_2,$quad_2,$m_z          # 30o
            fnms    $s3_4,$cx_4,$dx+3,$limit_4          # 31e
        shufb   $cx_4,$quad_6,$quad_6,$m_x              # 31o
            fnms    $s3_2,$cz_3,$dz+3,$s3_2             # 32e
        lqd     $quad_2,48($a_four)                     # 32o
            fnms    $s2_3,$cy_4,$dy2_2,$s2_3            # 33e
        shufb   $cx_3,$quad,$quad,$m_x                  # 33o
            fnms    $s1_2,$cy_2,$dy1_2,$s1_2            # 34e
            shufb   $signs,$signs,$signs_low_4,$m_halves # 34o
            fnms    $s1_7,$cy_3,$dy1_2,$s1_6            # 35e
        shufb   $limit_4,$more_3,$more_3,$m_limit       # 35o
            fnms    $s2_6,$cy_3,$dy2_2,$s2_6            # 36e
            gbb     $signs_7,$signs_7                   # 36o
            fnms    $s_2,$cz_2,$dz_2,$s_2               # 37e
            shlqbii $offset_3,$found_2,4                # 37o
            fnms    $s2_2,$cy_2,$dy2_2,$s2_2            # 38e
            rotqbii $signs,$signs,1                     # 38o signs to the bytes' last bits
            fnms    $s2_3,$cz_4,$dz+2,$s2_3             # 39e
        lqd     $more_3,160($a_four)                    # 39o
            fnms    $s1_2,$cz_2,$dz1_2,$s1_2            # 40e
            gbb     $signs_8,$signs_8                   # 40o
            fnms    $s_3,$cz_3,$dz_2,$s_3               # 41e
        shufb   $limit_3,$more,$more,$m_limit           # 41o
            fnms    $s+2,$cy_5,$dy2_2,$s+2              # 42e
            stqx    $pair_2,$a_pairs,$offset_3          # 42o
            fnms    $s+3,$cz_2,$dz+3,$s+3               # 43e
            gbb     $signs,$signs                       # 43o
            fnms    $s1_7,$cz_3,$dz1_2,$s1_7            # 44e
            shufb   $pair_2,$a_sphere_2,$place_3,$m_pair # 44o
            cg      $any_2,$signs_7,$k_all              # 45e 1 if any, else 0
        shufb   $cy_2,$quad_2,$quad_2,$m_y              # 45o
        ai      $a_sphere_2,$a_four,48                  # 46e
        shufb   $cx_2,$quad_2,$quad_2,$m_x              # 46o
            fnms    $s2_2,$cz_2,$dz+2,$s2_2             # 47e
        shufb   $cy_3,$quad,$quad,$m_y                  # 47o
            cg      $any_3,$signs_8,$k_all              # 48e 1 if any, else 0
            shufb   $signs_9,$s_2,$s1_2,$m_signs        # 48o
            fnms    $s2_6,$cz_3,$dz+2,$s2_6             # 49e
        shufb   $cz_3,$quad,$quad,$m_z                  # 49o
            a       $found_2,$found_2,$any_3            # 50e
            shufb   $signs_4,$s_3,$s1_7,$m_signs        # 50o
            fnms    $s1_4,$cx_5,$dx+1,$limit_5          # 51e
        shufb   $limit_5,$more_3,$more_3,$m_limit       # 51o
            fnms    $s,$cy_4,$dy,$s                     # 52e
            shlqbii $offset_4,$found_2,4                # 52o
            fnms    $s3_4,$cy_4,$dy+3,$s3_4             # 53e
            shufb   $signs_low,$s2_2,$s+3,$m_signs      # 53o
            a       $found_2,$found_2,$any_2            # 54e
        shufb   $cx_5,$quad_4,$quad_4,$m_x              # 54o
            fnms    $s+3,$cy_5,$dy+3,$s3_3              # 55e
            shufb   $signs_low_5,$s2_6,$s3_2,$m_signs   # 55o
            fnms    $s_6,$cz_6,$dz_2,$s_4               # 56e
            stqx    $pair_3,$a_pairs,$offset_4          # 56o
            fnms    $s1_8,$cy_5,$dy1_2,$s1_4            # 57e
            shufb   $pair_3,$a_sphere_3,$place_3,$m_pair # 57o
            fnms    $s_7,$cz_4,$dz_2,$s                 # 58e
            shlqbii $offset_5,$found_2,4                # 58o
            fnms    $s3_4,$cz_4,$dz+3,$s3_4             # 59e
            shufb   $signs_4,$signs_4,$signs_low_5,$m_halves # 59o
            fnms    $s1_5,$cz_4,$dz1_2,$s+1             # 60e
        shufb   $cz_4,$quad_6,$quad_6,$m_z              # 60o
            cg      $any,$signs,$k_all                  # 61e 1 if any, else 0
            shufb   $signs_5,$signs_9,$signs_low,$m_halves # 61o
        ai      $a_sphere_3,$a_four,96                  # 62e
            stqx    $pair_4,$a_pairs,$offset_5          # 62o
            a       $found,$found_2,$any                # 63e
        shufb   $cy_5,$quad_4,$quad_4,$m_y              # 63o
            fnms    $s+3,$cz_6,$dz+3,$s+3               # 64e
            rotqbii $signs,$signs_4,1                   # 64o signs to the bytes' last bits
            fnms    $s+2,$cz_6,$dz+2,$s+2               # 65e
            shufb   $pair_4,$a_sphere_5,$place_3,$m_pair # 65o
        ai      $a_sphere_5,$a_four,144                 # 66e
            shlqbii $offset_2,$found,4                  # 66o
        selb    $a_four,$a_four_4,$first,$c_last        # 67e
        lqd     $place_3,0($a_place)                    # 67o
        a       $a_place,$a_place,$c_last_4             # 68e
            gbb     $signs,$signs                       # 68o
            fnms    $s1_2,$cz_6,$dz1_2,$s1_8            # 69e
next_four_back:
        brnz    $count,next_four                        # 69o
next_four_drain:
        cg      $any,$signs,$k_all                      # 0e 1 if any, else 0
        stqx    $pair,$a_pairs,$offset_2                # 0o
        nop     $127                                    # 1e pairing
        lqd     $dx+2,32($place_3)                      # 1o
        a       $found_2,$found,$any                    # 2e
        lqd     $dx3_2,48($place_3)                     # 2o
        lqd     $dx+1,16($place_3)                      # 3o
        lqd     $dx,0($place_3)                         # 4o
        lqd     $dy,64($place_3)                        # 5o
        lqd     $dy+3,112($place_3)                     # 6o
        fnms    $s2_7,$cx_3,$dx+2,$limit_3              # 7e
        lqd     $dy1_2,80($place_3)                     # 7o
        fnms    $s3_2,$cx_3,$dx3_2,$limit_3             # 8e
        lqd     $dy2_3,96($place_3)                     # 8o
        fnms    $s1_9,$cx_3,$dx+1,$limit_3              # 9e
        lqd     $dz+3,176($place_3)                     # 9o
        fnms    $s_3,$cx_3,$dx,$limit_3                 # 10e
        lqd     $dz+2,160($place_3)                     # 10o
        fnms    $s2_2,$cx_2,$dx+2,$limit_2              # 11e
        shufb   $cy_6,$quad_6,$quad_6,$m_y              # 11o
        fnms    $s3_6,$cx_2,$dx3_2,$limit_2             # 12e
        lqd     $dz1_2,144($place_3)                    # 12o
        fnms    $s1_10,$cx_2,$dx+1,$limit_2             # 13e
        lqd     $dz_3,128($place_3)                     # 13o
        fnms    $s_2,$cx_2,$dx,$limit_2                 # 14e
        shufb   $cz_2,$quad_2,$quad_2,$m_z              # 14o
        fnms    $s2_8,$cx_4,$dx+2,$limit_4              # 15e
        shufb   $signs_low,$s2_3,$s3_4,$m_signs         # 15o
        fnms    $s+1,$cx_4,$dx+1,$limit_4               # 16e
        shufb   $cz_6,$quad_4,$quad_4,$m_z              # 16o
        fnms    $s,$cx_4,$dx,$limit_4                   # 17e
        shufb   $signs_6,$s_7,$s1_5,$m_signs            # 17o
        fnms    $s3_4,$cx_4,$dx3_2,$limit_4             # 18e
        shufb   $signs_low_4,$s+2,$s+3,$m_signs         # 18o
        fnms    $s+2,$cx_5,$dx+2,$limit_5               # 19e
        shufb   $signs,$s_6,$s1_2,$m_signs              # 19o
        fnms    $s_4,$cx_5,$dx,$limit_5                 # 20e
        rotqbii $signs_8,$signs_5,1                     # 20o signs to the bytes' last bits
        fnms    $s3_2,$cy_3,$dy+3,$s3_2                 # 21e
        shufb   $signs_7,$signs_6,$signs_low,$m_halves  # 21o
        fnms    $s3_3,$cx_5,$dx3_2,$limit_5             # 22e
        hbr     filter_spheres_r16_return,$lr           # 22o hint
        fnms    $s_3,$cy_3,$dy,$s_3                     # 23e
        shufb   $signs,$signs,$signs_low_4,$m_halves    # 23o
        fnms    $s1_7,$cy_3,$dy1_2,$s1_9                # 24e
        gbb     $signs_8,$signs_8                       # 24o
        fnms    $s2_6,$cy_3,$dy2_3,$s2_7                # 25e
        rotqbii $signs_7,$signs_7,1                     # 25o signs to the bytes' last bits
        fnms    $s1_4,$cx_5,$dx+1,$limit_5              # 26e
        shlqbii $offset_3,$found_2,4                    # 26o
        fnms    $s+3,$cy_2,$dy+3,$s3_6                  # 27e
        rotqbii $signs,$signs,1                         # 27o signs to the bytes' last bits
        fnms    $s_2,$cy_2,$dy,$s_2                     # 28e
        shufb   $pair,$a_sphere,$place_3,$m_pair        # 28o
        fnms    $s1_2,$cy_2,$dy1_2,$s1_10               # 29e
        gbb     $signs_7,$signs_7                       # 29o
        fnms    $s2_2,$cy_2,$dy2_3,$s2_2                # 30e
        stqx    $pair_2,$a_pairs,$offset_3              # 30o
        fnms    $s+1,$cy_6,$dy1_2,$s+1                  # 31e
        gbb     $signs,$signs                           # 31o
        fnms    $s2_3,$cy_6,$dy2_3,$s2_8                # 32e
        shufb   $pair_2,$a_sphere_2,$place_3,$m_pair    # 32o
        fnms    $s,$cy_6,$dy,$s                         # 33e
        shufb   $pair_5,$a_sphere_3,$place_3,$m_pair    # 33o
        fnms    $s3_4,$cy_6,$dy+3,$s3_4                 # 34e
        shufb   $pair_6,$a_sphere_5,$place_3,$m_pair    # 34o
        fnms    $s_4,$cy_5,$dy,$s_4                     # 35e
        fnms    $s3_2,$cz_3,$dz+3,$s3_2                 # 36e
        fnms    $s_3,$cz_3,$dz_3,$s_3                   # 37e
        fnms    $s+2,$cy_5,$dy2_3,$s+2                  # 38e
        fnms    $s1_7,$cz_3,$dz1_2,$s1_7                # 39e
        fnms    $s2_6,$cz_3,$dz+2,$s2_6                 # 40e
        fnms    $s3_7,$cy_5,$dy+3,$s3_3                 # 41e
        fnms    $s1_9,$cy_5,$dy1_2,$s1_4                # 42e
        fnms    $s_2,$cz_2,$dz_3,$s_2                   # 43e
        fnms    $s1_2,$cz_2,$dz1_2,$s1_2                # 44e
        fnms    $s+3,$cz_2,$dz+3,$s+3                   # 45e
        shufb   $signs_4,$s_3,$s1_7,$m_signs            # 45o
        fnms    $s2_2,$cz_2,$dz+2,$s2_2                 # 46e
        shufb   $signs_low_5,$s2_6,$s3_2,$m_signs       # 46o
        fnms    $s2_3,$cz_4,$dz+2,$s2_3                 # 47e
        fnms    $s_7,$cz_4,$dz_3,$s                     # 48e
        fnms    $s3_4,$cz_4,$dz+3,$s3_4                 # 49e
        lnop                                            # 49o pairing
        fnms    $s1_11,$cz_4,$dz1_2,$s+1                # 50e
        shufb   $signs_9,$s_2,$s1_2,$m_signs            # 50o
        fnms    $s_6,$cz_6,$dz_3,$s_4                   # 51e
        shufb   $signs_4,$signs_4,$signs_low_5,$m_halves # 51o
        fnms    $s3_7,$cz_6,$dz+3,$s3_7                 # 52e
        shufb   $signs_low_6,$s2_2,$s+3,$m_signs        # 52o
        fnms    $s+2,$cz_6,$dz+2,$s+2                   # 53e
        fnms    $s1_9,$cz_6,$dz1_2,$s1_9                # 54e
        cg      $any_4,$signs_8,$k_all                  # 55e 1 if any, else 0
        shufb   $signs_low_7,$s2_3,$s3_4,$m_signs       # 55o
        cg      $any_2,$signs_7,$k_all                  # 56e 1 if any, else 0
        shufb   $signs_6,$s_7,$s1_11,$m_signs           # 56o
        a       $found_2,$found_2,$any_4                # 57e
        shufb   $signs_5,$signs_9,$signs_low_6,$m_halves # 57o
        cg      $any,$signs,$k_all                      # 58e 1 if any, else 0
        rotqbii $signs,$signs_4,1                       # 58o signs to the bytes' last bits
        a       $found_3,$found_2,$any_2                # 59e
        shufb   $signs_low_4,$s+2,$s3_7,$m_signs        # 59o
        nop     $127                                    # 60e pairing
        shufb   $signs_10,$s_6,$s1_9,$m_signs           # 60o
        a       $found,$found_3,$any                    # 61e
        shufb   $signs_7,$signs_6,$signs_low_7,$m_halves # 61o
        rotqbii $signs_8,$signs_5,1                     # 62o signs to the bytes' last bits
        gbb     $signs,$signs                           # 63o
        shufb   $signs_10,$signs_10,$signs_low_4,$m_halves # 64o
        rotqbii $signs_7,$signs_7,1                     # 65o signs to the bytes' last bits
        nop     $127                                    # 66e pairing
        gbb     $signs_8,$signs_8                       # 66o
        cg      $any,$signs,$k_all                      # 67e 1 if any, else 0
        shlqbii $offset_4,$found_2,4                    # 67o
        nop     $127                                    # 68e pairing
        rotqbii $signs,$signs_10,1                      # 68o signs to the bytes' last bits
        a       $found_2,$found,$any                    # 69e
        gbb     $signs_7,$signs_7                       # 69o
        cg      $any_3,$signs_8,$k_all                  # 70e 1 if any, else 0
        shlqbii $offset_5,$found_3,4                    # 70o
        nop     $127                                    # 71e pairing
        shlqbii $offset_6,$found,4                      # 71o
        a       $found_4,$found_2,$any_3                # 72e
        gbb     $signs,$signs                           # 72o
        cg      $any_2,$signs_7,$k_all                  # 73e 1 if any, else 0
        shlqbii $offset_3,$found_2,4                    # 73o
        nop     $127                                    # 74e pairing
        stqx    $pair_3,$a_pairs,$offset_4              # 74o
        a       $found_2,$found_4,$any_2                # 75e
        shlqbii $offset_4,$found_4,4                    # 75o
        cg      $any,$signs,$k_all                      # 76e 1 if any, else 0
        stqx    $pair_4,$a_pairs,$offset_5              # 76o
        nop     $127                                    # 77e pairing
        shlqbii $offset_5,$found_2,4                    # 77o
        a       $found,$found_2,$any                    # 78e
        stqx    $pair,$a_pairs,$offset_6                # 78o
        nop     $127                                    # 79e pairing
        stqx    $pair_2,$a_pairs,$offset_3              # 79o
        shli    $found,$found,4                         # 80e
        stqx    $pair_5,$a_pairs,$offset_4              # 80o
        nop     $127                                    # 81e pairing
        stqx    $pair_6,$a_pairs,$offset_5              # 81o
        a       $a_place,$a_pairs,$found                # 84e
filter_spheres_r16_return:
        bi      $lr                                     # 84o
next_four_short:
        ai      $a_sphere,$a_four,0                     # 0e
        lqd     $place,0($a_place)                      # 0o
        ai      $a_sphere_6,$a_four,48                  # 1e
        lqd     $quad,0($a_four)                        # 1o
        ai      $a_sphere_7,$a_four,96                  # 2e
        lqd     $more,16($a_four)                       # 2o
        ai      $a_sphere_8,$a_four,144                 # 3e
        lqd     $quad_7,48($a_four)                     # 3o
        ai      $left,$left,-1                          # 4e
        lqd     $more_6,64($a_four)                     # 4o
        ai      $a_four_3,$a_four,192                   # 5e
        lqd     $quad_8,96($a_four)                     # 5o
        ceqi    $c_last,$left,0                         # 6e
        lqd     $dx_2,0($place)                         # 6o
        ai      $count,$count,-1                        # 7e
        lqd     $dx1_2,16($place)                       # 7o
        andi    $c_last_5,$c_last,16                    # 8e
        lqd     $dx2_2,32($place)                       # 8o
        selb    $left,$left,$fours,$c_last              # 9e
        lqd     $dx3_3,48($place)                       # 9o
        a       $a_place,$a_place,$c_last_5             # 10e
        lqd     $more_7,112($a_four)                    # 10o
        shufb   $cx,$quad,$quad,$m_x                    # 11o
        shufb   $limit,$more,$more,$m_limit             # 12o
        shufb   $cx_6,$quad_7,$quad_7,$m_x              # 13o
        shufb   $limit_6,$more_6,$more_6,$m_limit       # 14o
        nop     $127                                    # 15e pairing
        lqd     $dy_3,64($place)                        # 15o
        fnms    $s,$cx,$dx_2,$limit                     # 16e
        lqd     $dy1_3,80($place)                       # 16o
        fnms    $s+1,$cx,$dx1_2,$limit                  # 17e
        lqd     $dy2_4,96($place)                       # 17o
        fnms    $s+2,$cx,$dx2_2,$limit                  # 18e
        lqd     $dy3_2,112($place)                      # 18o
        fnms    $s+3,$cx,$dx3_3,$limit                  # 19e
        shufb   $cx,$quad_8,$quad_8,$m_x                # 19o
        fnms    $s_6,$cx_6,$dx_2,$limit_6               # 20e
        shufb   $limit,$more_7,$more_7,$m_limit         # 20o
        fnms    $s1_12,$cx_6,$dx1_2,$limit_6            # 21e
        shufb   $cy_7,$quad,$quad,$m_y                  # 21o
        fnms    $s2_9,$cx_6,$dx2_2,$limit_6             # 22e
        lqd     $quad_9,144($a_four)                    # 22o
        fnms    $s3_8,$cx_6,$dx3_3,$limit_6             # 23e
        lqd     $more_8,160($a_four)                    # 23o
        fnms    $s_8,$cx,$dx_2,$limit                   # 24e
        shufb   $cy_8,$quad_7,$quad_7,$m_y              # 24o
        fnms    $s1_13,$cx,$dx1_2,$limit                # 25e
        lqd     $dz_4,128($place)                       # 25o
        fnms    $s2_10,$cx,$dx2_2,$limit                # 26e
        lqd     $dz1_3,144($place)                      # 26o
        fnms    $s3_9,$cx,$dx3_3,$limit                 # 27e
        lqd     $dz2_3,160($place)                      # 27o
        fnms    $s,$cy_7,$dy_3,$s                       # 28e
        lqd     $dz3_2,176($place)                      # 28o
        fnms    $s+1,$cy_7,$dy1_3,$s+1                  # 29e
        shufb   $cy_9,$quad_8,$quad_8,$m_y              # 29o
        fnms    $s+2,$cy_7,$dy2_4,$s+2                  # 30e
        shufb   $cz_7,$quad,$quad,$m_z                  # 30o
        fnms    $s+3,$cy_7,$dy3_2,$s+3                  # 31e
        shufb   $cx_7,$quad_9,$quad_9,$m_x              # 31o
        fnms    $s_6,$cy_8,$dy_3,$s_6                   # 32e
        shufb   $limit_7,$more_8,$more_8,$m_limit       # 32o
        fnms    $s1_12,$cy_8,$dy1_3,$s1_12              # 33e
        shufb   $cz_8,$quad_7,$quad_7,$m_z              # 33o
        fnms    $s2_9,$cy_8,$dy2_4,$s2_9                # 34e
        shufb   $cz_9,$quad_8,$quad_8,$m_z              # 34o
        fnms    $s3_8,$cy_8,$dy3_2,$s3_8                # 35e
        shufb   $cy_8,$quad_9,$quad_9,$m_y              # 35o
        fnms    $s_8,$cy_9,$dy_3,$s_8                   # 36e
        shufb   $cz_10,$quad_9,$quad_9,$m_z             # 36o
        fnms    $s1_13,$cy_9,$dy1_3,$s1_13              # 37e
        shufb   $pair_7,$a_sphere,$place,$m_pair        # 37o
        fnms    $s2_10,$cy_9,$dy2_4,$s2_10              # 38e
        shlqbii $offset_7,$found,4                      # 38o
        fnms    $s3_9,$cy_9,$dy3_2,$s3_9                # 39e
        shufb   $pair_5,$a_sphere_6,$place,$m_pair      # 39o
        fnms    $s,$cz_7,$dz_4,$s                       # 40e
        shufb   $pair_8,$a_sphere_7,$place,$m_pair      # 40o
        fnms    $s+1,$cz_7,$dz1_3,$s+1                  # 41e
        shufb   $pair_9,$a_sphere_8,$place,$m_pair      # 41o
        fnms    $s+2,$cz_7,$dz2_3,$s+2                  # 42e
        stqx    $pair_7,$a_pairs,$offset_7              # 42o
        fnms    $s+3,$cz_7,$dz3_2,$s+3                  # 43e
        fnms    $s_5,$cx_7,$dx_2,$limit_7               # 44e
        fnms    $s1_14,$cx_7,$dx1_2,$limit_7            # 45e
        fnms    $s2_3,$cx_7,$dx2_2,$limit_7             # 46e
        fnms    $s3_10,$cx_7,$dx3_3,$limit_7            # 47e
        shufb   $signs_11,$s,$s+1,$m_signs              # 47o
        fnms    $s,$cz_8,$dz_4,$s_6                     # 48e
        lnop                                            # 48o pairing
        fnms    $s+1,$cz_8,$dz1_3,$s1_12                # 49e
        shufb   $signs_low_3,$s+2,$s+3,$m_signs         # 49o
        fnms    $s+2,$cz_8,$dz2_3,$s2_9                 # 50e
        fnms    $s+3,$cz_8,$dz3_2,$s3_8                 # 51e
        fnms    $s_4,$cz_9,$dz_4,$s_8                   # 52e
        lnop                                            # 52o pairing
        fnms    $s1_4,$cz_9,$dz1_3,$s1_13               # 53e
        shufb   $signs,$signs_11,$signs_low_3,$m_halves # 53o
        fnms    $s2_2,$cz_9,$dz2_3,$s2_10               # 54e
        lnop                                            # 54o pairing
        fnms    $s3_4,$cz_9,$dz3_2,$s3_9                # 55e
        shufb   $signs_11,$s,$s+1,$m_signs              # 55o
        fnms    $s,$cy_8,$dy_3,$s_5                     # 56e
        lnop                                            # 56o pairing
        fnms    $s+1,$cy_8,$dy1_3,$s1_14                # 57e
        shufb   $signs_low_4,$s+2,$s+3,$m_signs         # 57o
        fnms    $s+2,$cy_8,$dy2_4,$s2_3                 # 58e
        rotqbii $signs,$signs,1                         # 58o signs to the bytes' last bits
        fnms    $s+3,$cy_8,$dy3_2,$s3_10                # 59e
        shufb   $signs_3,$s_4,$s1_4,$m_signs            # 59o
        selb    $a_four,$a_four_3,$first,$c_last        # 60e
        shufb   $signs_low_8,$s2_2,$s3_4,$m_signs       # 61o
        fnms    $s,$cz_10,$dz_4,$s                      # 62e
        shufb   $signs_4,$signs_11,$signs_low_4,$m_halves # 62o
        fnms    $s+1,$cz_10,$dz1_3,$s+1                 # 63e
        gbb     $signs,$signs                           # 63o
        fnms    $s+2,$cz_10,$dz2_3,$s+2                 # 64e
        lnop                                            # 64o pairing
        fnms    $s+3,$cz_10,$dz3_2,$s+3                 # 65e
        shufb   $signs_3,$signs_3,$signs_low_8,$m_halves # 65o
        rotqbii $signs_4,$signs_4,1                     # 66o signs to the bytes' last bits
        cg      $any,$signs,$k_all                      # 67e 1 if any, else 0
        a       $found,$found,$any                      # 69e
        rotqbii $signs,$signs_3,1                       # 69o signs to the bytes' last bits
        shufb   $signs_3,$s,$s+1,$m_signs               # 70o
        shufb   $signs_low,$s+2,$s+3,$m_signs           # 71o
        gbb     $signs_4,$signs_4                       # 72o
        gbb     $signs,$signs                           # 73o
        shlqbii $offset,$found,4                        # 74o
        shufb   $signs_3,$signs_3,$signs_low,$m_halves  # 75o
        cg      $any,$signs_4,$k_all                    # 76e 1 if any, else 0
        cg      $any_5,$signs,$k_all                    # 77e 1 if any, else 0
        a       $found,$found,$any                      # 78e
        stqx    $pair_5,$a_pairs,$offset                # 78o
        nop     $127                                    # 79e pairing
        rotqbii $signs,$signs_3,1                       # 79o signs to the bytes' last bits
        a       $found_5,$found,$any_5                  # 80e
        shlqbii $offset,$found,4                        # 80o
        shlqbii $offset_8,$found_5,4                    # 82o
        gbb     $signs,$signs                           # 83o
        stqx    $pair_8,$a_pairs,$offset                # 84o
        stqx    $pair_9,$a_pairs,$offset_8              # 86o
        cg      $any,$signs,$k_all                      # 87e 1 if any, else 0
        lnop                                            # 87o pairing
        a       $found,$found_5,$any                    # 89e
        brnz    $count,next_four_short                  # 89o
        shli    $found,$found,4                         # 91e
        lnop                                            # 91o pairing
        a       $a_place,$a_pairs,$found                # 95e
        bi      $lr                                     # 95o
endfunction filter_spheres_r16
