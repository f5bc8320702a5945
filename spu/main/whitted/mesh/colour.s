# Colours at the vertices of the mesh: multiplies the colours of surfaces by them.
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
current_block:                          # its number
        .skip   16

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
        registers colour                                # to 29
        .set    NEXT,colour+3

# colour_hits   lists the vertices' colours of the triangles that a batch's rays have hit, by the
#               places of their records in MESH_POOL
#   In      h_end, MESH_HIT_LIST: all of the batch's hits
#   Out     COLOUR_TABLE
#   Uses    $3-$79, w_plan, w_first, w_here
#
# Where a damaged block has its colours, there is nothing but local store; any bits are colours.
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
#   Out     $3 and $4 the same, $14 the surfaces' flags
#   Uses    $3-$79
        .set    NEXT,10
        registers has_textures

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
vertices_call:
        brsl    $lr,colour_vertices_r16
        lqa     $4,surfaces
        lqd     $14,SURFACES_flags($4)
        andi    $has_textures,$14,MATERIAL_FLAT
        brz     $has_textures,lit
        brsl    $lr,colour_flat
lit:    lqa     $3,rays
        lqd     $14,SURFACES_flags($4)
        leave
endfunction colour_packet

        transpose_table .rodata.colour
        flat_light colour_flat
