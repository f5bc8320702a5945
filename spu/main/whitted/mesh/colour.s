# Multiplies the colours of surfaces by those at the vertices of the mesh. Takes shadow rays out of
# their packets if the mesh has the visibility of their light.
#
# This file and its kernel are in local store only in frames with FEATURE_COLOURS, at COLOUR_CODE.

        .include "work_unit.inc"
        .include "macros.inc"
        .include "driver.inc"
        .include "checks.inc"
        .include "whitted.inc"
        .include "mesh.inc"
        .include "flat_light.inc"

        .section .data.colour,"aw",@progbits
        .align  4
after_colours:                          # what follows colour_hits, or 0
        .skip   16
surfaces:
        .skip   16
rays:   .skip   16
has_shader:                             # -1 if a surface of the packet has a shader of its own
        .skip   16
current_block:                          # its number
        .skip   16

        # Where visibility goes that is not kept: texels were there.
        .set    NOT_KEPT,BATCH_SHEARS
    .if RAYS16_origin_x != 0
        .error  "the rays do not begin with the place of the visibility"
    .endif

        .set    status,3
        .set    NEXT,15
        registers a_frame,value,limit,bad

# colour_begin   checks that the mesh's cache ends before this code, and puts its functions where
#                they are called from; gives up if the cache is longer
#   Uses    $3, $15-$18
function colour_begin
        ila     $a_frame,frame
        load_word $value,FRAME_mesh_slots,$a_frame
        shli    $value,$value,MESH_BLOCK_LOG2
        load_word $limit,FRAME_mesh_cache,$a_frame
        a       $value,$value,$limit
        ila     $limit,COLOUR_CODE
        clgt    $bad,$value,$limit
        refuse_if $bad,MeshCache
        lqa     $value,after_hits
        ila     $limit,colour_hits
        stqa    $value,after_colours
        stqa    $limit,after_hits
        ila     $value,colour_packet
        stqa    $value,surface_way
        load_word $value,FRAME_features,$a_frame
        il      $limit,FEATURE_VISIBILITY
        and     $value,$value,$limit
        stqa    $value,visibility
        bi      $lr
refused:
        br      give_up
endfunction colour_begin

        # The registers of mesh_hits, which is done.
        .set    h_list,89                               # the hits
        .set    h_block,92                              # address of the block
        .set    h_end,109                               # the list's

        .set    NEXT,10
        registers hit,number,is_same,c_end,index,counts,header,sides,address
        registers a_faces,a_colours,size,face,textured,m_two,m_third,place
        registers known,a_known
        registers colour                                # to 31
        .set    NEXT,colour+3

# colour_hits   lists the vertices' colours of the triangles that a batch's rays have hit, and their
#               visibility, by the places of their records in MESH_POOL
#   In      h_end, MESH_HIT_LIST: all of the batch's hits
#   Out     COLOUR_TABLE
#   Uses    $3-$79, w_plan, w_first, w_here
#
# Where a damaged block has its colours, there is nothing but local store; any bits are colours and
# visibility.
function colour_hits
        enter
        il      $number,-1
        ila     $h_list,arena+MESH_HIT_LIST
next_hit:
        ceq     $c_end,$h_list,$h_end
        brnz    $c_end,all_listed
        hbrr    same_block,of_block
        lqd     $hit,0($h_list)
        shli    $3,$hit,1
        rotmi   $3,$3,-8
        ceq     $is_same,$number,$3
same_block:
        brnz    $is_same,of_block
        stqa    $3,current_block
        brsl    $lr,mesh_block
        ori     $h_block,$3,0
        lqa     $number,current_block
        lqd     $hit,0($h_list)
of_block:
        lqd     $counts,MESH_HEADER_nodes&~15($h_block)
        ai      $h_list,$h_list,MESH_HITS_SIZE
        rotqbyi $sides,$counts,MESH_HEADER_sides&15
        ilhu    $size,SIDES_COLOURED>>16
        and     $size,$size,$sides
        brz     $size,next_hit
        # Its vertices' indices.
        mpyi    $a_faces,$counts,BOXES_SIZE
        rotqbyi $face,$counts,MESH_HEADER_vertices&15
        a       $a_faces,$a_faces,$h_block
        shli    $size,$face,4
        ai      $a_faces,$a_faces,MESH_HEADER_SIZE
        a       $a_faces,$a_faces,$size
        andi    $index,$hit,(1<<7)-1
        shli    $index,$index,2
        a       $address,$a_faces,$index
        # Colours follow the faces, or the texture coordinates, from the next quadword on.
        ilhu    $textured,SIDES_TEXTURED>>16
        and     $textured,$textured,$sides
        cgti    $textured,$textured,0
        shli    $size,$face,3
        and     $size,$size,$textured
        ai      $size,$size,15
        andi    $size,$size,-16
        rotqbyi $a_colours,$counts,MESH_HEADER_triangles&15
        ai      $a_colours,$a_colours,3
        andi    $a_colours,$a_colours,-4
        shli    $a_colours,$a_colours,2
        a       $a_colours,$a_colours,$a_faces
        a       $a_colours,$a_colours,$size
        # The visibility follows the colours, from the next quadword on.
        shli    $size,$face,2
        ai      $size,$size,15
        andi    $size,$size,-16
        a       $a_known,$a_colours,$size
        a       $a_known,$a_known,$index
        lqd     $known,0($a_known)
        rotqby  $known,$known,$a_known
        lqd     $face,0($address)
        rotqby  $face,$face,$address
    .set    corner,0
    .rept   3
        rotmi   $index,$face,8*corner-24
        andi    $index,$index,0xff
        shli    $index,$index,2
        a       $address,$a_colours,$index
        lqd     $colour+corner,0($address)
        rotqby  $colour+corner,$colour+corner,$address
    .set    corner,corner+1
    .endr
        lqa     $m_two,transpose_first
        cwd     $m_third,8($sp)
        shufb   $colour,$colour,$colour+1,$m_two        # in the first two words
        shufb   $colour,$colour+2,$colour,$m_third
        cwd     $m_third,12($sp)
        shufb   $colour,$known,$colour,$m_third
        rotqbyi $place,$hit,4
        ila     $address,arena+MESH_POOL
        sf      $place,$address,$place
        il      $size,0x10000/PATCH_SIZE+1              # exact for as many as there may be
        mpyu    $place,$place,$size
        rotmi   $place,$place,-16
        shli    $place,$place,4
        ila     $address,arena+COLOUR_TABLE
        stqx    $colour,$address,$place
        br      next_hit

all_listed:
        lqa     $address,after_colours
        ai      $sp,$sp,32
        lqd     $lr,16($sp)
        binz    $address,$address
        bi      $lr
endfunction colour_hits

# colour_packet   multiplies the colours of a packet's surfaces by those of textures and vertices
#   In      $3 rays, $4 surfaces
#   Out     $3 and $4 the same, $14 the surfaces' flags; the visibility
#   Uses    $3-$79
        .set    NEXT,10
        registers has_textures,shaded,flags,m_second

function colour_packet
        enter
        stqa    $3,rays
        stqa    $4,surfaces
        lqa     $has_textures,streamed
        andi    $has_textures,$has_textures,FEATURE_TEXTURES
        brz     $has_textures,textured_packet
        brsl    $lr,texture_packet
textured_packet:
        hbrr    vertices_call,colour_vertices_r16
        lqa     $3,rays
        lqa     $4,surfaces
        # Colours are square roots of light where pixels have sRGB's values.
        ila     $5,frame
        load_word $7,FRAME_features,$5
        andi    $7,$7,FEATURE_SRGB
        ceqi    $7,$7,0
        nor     $7,$7,$7
        ila     $5,arena+COLOUR_TABLE
        ila     $6,arena+MESH_POOL
        # Shaders get the rays as they were, so what is known of their packets is not kept.
        lqd     $flags,SURFACES_flags($4)
        ila     $8,arena+NOT_KEPT
        andi    $shaded,$flags,MATERIAL_SHADED
        cgti    $shaded,$shaded,0
        selb    $8,$3,$8,$shaded
        stqa    $shaded,has_shader
vertices_call:
        brsl    $lr,colour_vertices_r16
        lqa     $4,surfaces
        lqa     $shaded,has_shader
        lqd     $14,SURFACES_flags($4)
        andc    $3,$3,$shaded
        cwd     $m_second,4($sp)
        shufb   $14,$3,$14,$m_second
        stqd    $14,SURFACES_flags($4)
        andi    $has_textures,$14,MATERIAL_FLAT
        brz     $has_textures,lit
        brsl    $lr,colour_flat
lit:    lqa     $3,rays
        lqd     $14,SURFACES_flags($4)
        leave
endfunction colour_packet

        .set    NEXT,10
        registers a_site,a_shadow,packets,k_lit,k_dark,k_sign,k_one,k_none,m_splat,site,a_rays,any
        registers step,left,any_lit,is_dark
    .irp row, 0,1,2,3
        registers known\row,t\row,is\row
    .endr

# colour_take   takes the shadow rays to a light that need not be traced out of their packets
#   In      w_traced, w_light, light_sites, SHADOW_RAYS
#   Out     $3 how many rays are left, $4 0 if the light does not reach any of the others. Their t
#           has the sign bit set; those that do not reach the light are no rays any more
#   Uses    $3-$4, $10-$37
function colour_take
        ila     $a_site,frame
        load_word $k_lit,FRAME_lights,$a_site
        sf      $k_lit,$k_lit,$w_light
        rotmi   $k_lit,$k_lit,-LIGHT_SIZE_LOG2
        andi    $k_lit,$k_lit,15
        il      $left,1
        shl     $k_lit,$left,$k_lit
        splat_mask $m_splat
        splat   $k_lit,$k_lit,$m_splat
        shli    $k_dark,$k_lit,16
        ilhu    $k_sign,0x8000
        ilhu    $k_one,0x3f80
        or      $k_none,$k_one,$k_sign
        ila     $a_site,light_sites
        ila     $a_shadow,arena+SHADOW_RAYS
        il      $step,RAYS16_SIZE
        il      $left,0
        il      $any_lit,0
        ori     $packets,$w_traced,0
next_taken:
        hbrr    last_taken,next_taken
        lqd     $site,0($a_site)
        rotqbyi $a_rays,$site,SITE_rays
        lqd     $any,SURFACES_flags($site)
    .irp row, 0,1,2,3
        lqd     $t\row,RAYS16_t+16*\row($a_shadow)
    .endr
    .irp row, 0,1,2,3
        lqd     $known\row,RAYS16_origin_x+16*\row($a_rays)
    .endr
        # Without any bit, origin_x has something else.
        rotqbyi $any,$any,4
        splat   $any,$any,$m_splat
        and     $is_dark,$any,$k_dark
        and     $any,$any,$k_lit
    .irp row, 0,1,2,3
        and     $is\row,$known\row,$is_dark
    .endr
    .irp row, 0,1,2,3
        and     $known\row,$known\row,$any
    .endr
    .irp row, 0,1,2,3
        clgti   $is\row,$is\row,0
    .endr
    .irp row, 0,1,2,3
        clgti   $known\row,$known\row,0
    .endr
    .irp row, 0,1,2,3
        selb    $t\row,$t\row,$k_none,$is\row
    .endr
        # One of the length 1 would be taken for no ray.
    .irp row, 0,1,2,3
        ceq     $is\row,$t\row,$k_one
    .endr
    .irp row, 0,1,2,3
        andc    $known\row,$known\row,$is\row
    .endr
    .irp row, 0,1,2,3
        or      $any_lit,$any_lit,$known\row
        and     $known\row,$known\row,$k_sign
    .endr
    .irp row, 0,1,2,3
        or      $t\row,$t\row,$known\row
    .endr
    .irp row, 0,1,2,3
        cgti    $is\row,$t\row,-1
        stqd    $t\row,RAYS16_t+16*\row($a_shadow)
    .endr
    .irp row, 0,1,2,3
        sf      $left,$is\row,$left                     # true is -1
    .endr
        ai      $packets,$packets,-1
        ai      $a_site,$a_site,SITE_SIZE
        a       $a_shadow,$a_shadow,$step
last_taken:
        brnz    $packets,next_taken
        sum_lanes $left,$any
        ori     $3,$left,0
        orx     $4,$any_lit
        bi      $lr
endfunction colour_take

# colour_return   puts these rays back, as rays that have met nothing
#   In      w_traced, SHADOW_RAYS
#   Uses    $10-$37
function colour_return
        ila     $a_shadow,arena+SHADOW_RAYS
        il      $step,RAYS16_SIZE
        ilhu    $k_sign,0x8000
        ilhu    $k_none,0xbf80
        ori     $packets,$w_traced,0
next_returned:
        hbrr    last_returned,next_returned
    .irp row, 0,1,2,3
        lqd     $t\row,RAYS16_t+16*\row($a_shadow)
    .endr
    .irp row, 0,1,2,3
        ceq     $is\row,$t\row,$k_none
    .endr
    .irp row, 0,1,2,3
        andc    $known\row,$t\row,$k_sign
    .endr
    .irp row, 0,1,2,3
        selb    $t\row,$known\row,$t\row,$is\row
    .endr
    .irp row, 0,1,2,3
        stqd    $t\row,RAYS16_t+16*\row($a_shadow)
    .endr
        ai      $packets,$packets,-1
        a       $a_shadow,$a_shadow,$step
last_returned:
        brnz    $packets,next_returned
        bi      $lr
endfunction colour_return

        transpose_table .rodata.colour
        flat_light colour_flat
