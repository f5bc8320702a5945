# Materials in main memory: those of the triangles and spheres that a batch's rays have hit are
# fetched when these have become records. They are there until the batch is shaded.

        .include "work_unit.inc"
        .include "macros.inc"
        .include "driver.inc"
        .include "whitted.inc"
        .include "mesh.inc"

        .section .data.mesh,"aw",@progbits
        .align  4
        .global after_hits
after_hits:                             # the function that follows mesh_hits, or 0
        .int    0,0,0,0
current_block:                                          # its number
        .skip   16

        # The registers of mesh_hits, which is done.
        .set    h_list,89                               # the hits
        .set    h_block,92                              # address of the block
        .set    h_end,109                               # the list's

        .set    NEXT,10
        registers hit,number,is_same,c_end,index,header,counts,address,offset
        registers material,upper,count,quad,m_lane,place,delta
        registers high,low,size,tag,command,t_carry

# mesh_materials   lets the records of a batch's hits have the addresses of their materials, and
#                  fetches these; gives up if a block has a number that no material has
#   In      h_end, MESH_HIT_LIST: all of the batch's hits
#   Out     OBJECT_material of their records
#   Uses    $3-$79, w_plan, w_first, w_here
#
# A material's slot is that of the last bits of its number, or the next one that is free: there is
# one for each ray.
function mesh_materials
        hbrr    last_free,next_free
        enter
        il      $number,-1
        ila     $address,arena+MATERIAL_NUMBERS
        il      $count,-MATERIAL_SLOTS/16
next_free:
    .irp quad, 0,1,2,3
        stqd    $number,16*\quad($address)
    .endr
        ai      $address,$address,64
        ai      $count,$count,1
last_free:
        brnz    $count,next_free
        ila     $h_list,arena+MESH_HIT_LIST
next_hit:
        hbrr    same_block,of_block
        ceq     $c_end,$h_list,$h_end
        brnz    $c_end,all_known
        lqd     $hit,0($h_list)
        shli    $3,$hit,1
        rotmi   $3,$3,-8
        nop     $2                                      # a hint must be eight instructions ahead
        lnop
        ceq     $is_same,$number,$3
same_block:
        brnz    $is_same,of_block
        stqa    $3,current_block
        brsl    $lr,mesh_block
        ori     $h_block,$3,0
        lqa     $number,current_block
        lqd     $hit,0($h_list)
of_block:
        andi    $index,$hit,(1<<7)-1
        lqd     $header,MESH_HEADER_kind&~15($h_block)
        rotqbyi $header,$header,MESH_HEADER_kind&15
        ceqi    $is_same,$header,MESH_LEAF
        brz     $is_same,object
        # Two bytes of a triangle, which are in different places.
        lqd     $counts,MESH_HEADER_nodes&~15($h_block)
        mpyi    $address,$counts,BOXES_SIZE
        rotqbyi $offset,$counts,MESH_HEADER_vertices&15
        a       $address,$address,$h_block
        shli    $offset,$offset,4
        a       $address,$address,$offset
        shli    $offset,$index,2
        a       $address,$address,$offset
        lqd     $material,MESH_HEADER_SIZE($address)
        rotqby  $material,$material,$address
        a       $address,$h_block,$index
        lqd     $upper,MESH_UPPER($address)
        rotqby  $upper,$upper,$address
        andi    $material,$material,0xff
        rotmi   $upper,$upper,-24
        shli    $upper,$upper,8
        or      $material,$material,$upper
has_number:
        ila     $address,frame
        load_word $count,FRAME_mesh_material_count,$address
        clgt    $count,$count,$material
        brz     $count,no_material

        # Its slot.
        andi    $index,$material,MATERIAL_SLOTS-1
        ila     $place,arena+MATERIAL_NUMBERS
next_slot:
        shli    $offset,$index,2
        a       $address,$place,$offset
        lqd     $quad,0($address)
        rotqby  $count,$quad,$address
        ceq     $is_same,$count,$material
        cgti    $c_end,$count,-1
        orc     $is_same,$is_same,$c_end
        brz     $is_same,occupied
        hbrr    listed,next_hit
        cgti    $m_lane,$index,MATERIAL_SLOTS/2-1
        load_constant $delta,MATERIAL_SECOND-MATERIAL_FIRST-MATERIAL_SLOTS/2*MATERIAL_SIZE
        and     $delta,$delta,$m_lane
        mpyi    $place,$index,MATERIAL_SIZE
        a       $place,$place,$delta
        ila     $delta,arena+MATERIAL_FIRST
        a       $place,$place,$delta
        brz     $c_end,fetch
fetched:
        rotqbyi $address,$hit,4
        ai      $h_list,$h_list,MESH_HITS_SIZE
        store_word $place,OBJECT_material,$address,$quad,$m_lane
listed: br      next_hit

occupied:
        ai      $index,$index,1
        andi    $index,$index,MATERIAL_SLOTS-1
        br      next_slot

fetch:  cwd     $m_lane,0($address)
        shufb   $quad,$material,$quad,$m_lane
        stqd    $quad,0($address)
        ila     $address,frame
        load_word $high,FRAME_materials,$address
        load_word $low,FRAME_materials+4,$address
        shli    $offset,$material,MATERIAL_STRIDE_LOG2
        add_effective $high,$low,$offset,$t_carry
        il      $size,MATERIAL_SIZE
        il      $tag,TAG_MATERIAL
        il      $command,MFC_GET
        mfc_command $place,$high,$low,$size,$tag,$command
        br      fetched

        # The record of a sphere has the number.
object: shli    $offset,$index,4
        a       $address,$h_block,$offset
        load_word $material,OBJECT_material,$address
        br      has_number

all_known:
        phase_ends $g_ticks_shade,$count
        load_constant $3,1<<TAG_MATERIAL
        brsl    $lr,dma_wait
        phase_begins
        leave

no_material:
        shli    $3,$number,8
        ori     $3,$3,STATUS_MeshBlock
        br      give_up
endfunction mesh_materials
