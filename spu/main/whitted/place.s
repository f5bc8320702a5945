# Where the buffers of a batch are. Those of a small batch are in the arena. A batch is larger
# where the scene leaves memory: then its rays and shears are at the end of the scene's memory, and
# the queue of rays ends in front of them.

        .include "work_unit.inc"
        .include "macros.inc"
        .include "driver.inc"
        .include "whitted.inc"

        .section .bss
        .align  4
# The addresses, in all words.
    .irp name, rays_at,shadow_rays_at,bounds_at,shears_at,surfaces_at,sites_at,roots_at
        .global \name
\name: .skip   16
    .endr
        .global shadow_candidates
shadow_candidates:                      # bytes from a tree's top with rays to that with shadow rays
        .skip   16
        .global object_list_nodes
object_list_nodes:                      # the number of nodes whose children fit OBJECT_LIST
        .skip   16

        .set    NEXT,10
        registers at,size,packets,c_none,every

.macro  place name:req, address:req
        ila     $at,arena+\address
        stqa    $at,\name
.endm

# The same before the last one.
.macro  place_before name:req, bytes:req
        sf      $at,\bytes,$at
        shufb   $at,$at,$at,$every
        stqa    $at,\name
.endm

# batch_place   places the buffers of the frame's batches
#   In      w_most; queue_prepare has set up the queue
#   Uses    $10-$14
function batch_place
        rotmi   $packets,$w_most,-4
        cgti    $size,$packets,SMALL_BATCH
        brnz    $size,large
        place   rays_at,BATCH_RAYS
        place   shadow_rays_at,SHADOW_RAYS
        place   bounds_at,BATCH_BOUNDS
        place   shears_at,BATCH_SHEARS
        place   surfaces_at,BATCH_SURFACES
        place   sites_at,BATCH_SITES
        place   roots_at,ROOT_LISTS
        il      $size,SMALL_BATCH*MAX_ROOTS*CANDIDATE_SIZE
        stqa    $size,shadow_candidates
        il      $size,MAX_CANDIDATES/4
        stqa    $size,object_list_nodes
        bi      $lr
large:
        place   surfaces_at,LARGE_SURFACES
        place   bounds_at,LARGE_BOUNDS
        place   sites_at,LARGE_SITES
        place   roots_at,LARGE_ROOTS
        load_constant $at,SCENE_ADDRESS+SCENE_CAPACITY
        ila     $every,0x10203
        il      $size,RAYS16_SIZE
        mpyu    $size,$size,$packets
        place_before rays_at,$size
        place_before shadow_rays_at,$size
        # Only triangles need the packets' shears.
        lqa     $c_none,frame+FRAME_trees+BVH_SIZE*BVH_TRIANGLES
        rotqbyi $c_none,$c_none,BVH_objects
        ceqi    $c_none,$c_none,0
        il      $size,SHEARS_SIZE
        mpyu    $size,$size,$packets
        andc    $size,$size,$c_none
        place_before shears_at,$size
        stqa    $at,queue_end
        il      $size,MAX_BATCH*MAX_ROOTS*CANDIDATE_SIZE
        stqa    $size,shadow_candidates
        il      $size,LARGE_OBJECTS/4
        stqa    $size,object_list_nodes
        bi      $lr
endfunction batch_place
