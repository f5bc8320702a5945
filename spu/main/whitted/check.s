# Checks the fields of a frame that describe the scene of Whitted's model.

        .include "work_unit.inc"
        .include "macros.inc"
        .include "driver.inc"
        .include "whitted.inc"
        .include "checks.inc"

        .section .bss
        .align  4
        .global visibility
visibility:                             # not 0 in frames with FEATURE_VISIBILITY
        .skip   16

        .global streamed
streamed:                               # bits of FEATURE_MESH, FEATURE_TEXTURES,
                                        # FEATURE_MATERIALS, FEATURE_COLOURS and FEATURE_HEIGHTS; 0
                                        # without a mesh
        .skip   16

        .global cuts
cuts:                                   # -1 if rays from the eye find the ground by cuts
        .skip   16

        .global surface_way
surface_way:                            # the function for textures and colours, or 0
        .skip   16

        .set    status,3
        .set    NEXT,15
        registers a_frame,value,limit,bad,a_tree,left,quad,scene_bytes,batch

# Refuses the frame unless a word of the tree, minus `min`, is below `limit`, unsigned.
.macro  require_of_tree word:req, min:req, limit:req
        rotqbyi $value,$quad,\word
        ai      $value,$value,-(\min)
        load_constant $limit,\limit-1
        clgt    $bad,$value,$limit
        refuse_if $bad,Trees
.endm

# whitted_check   checks whether the frame can be traced with Whitted's model
#   In      $15 address of the frame
#   Out     $3 STATUS_ value
#   Uses    $3, $16-$23
function whitted_check
        # mesh_begin checks the rest of the fields of the mesh and its textures, when its code is
        # there.
        load_word $batch,FRAME_features,$a_frame
        il      $value,FEATURE_MESH|FEATURE_TEXTURES|FEATURE_MATERIALS|FEATURE_COLOURS|FEATURE_HEIGHTS
        and     $batch,$batch,$value
        il      $value,0
        stqa    $value,surface_way
        stqa    $value,visibility
        stqa    $value,cuts
        stqa    $batch,streamed
        brz     $batch,no_mesh
        require_aligned code,LINE,Code
        require_at_most code_bytes,EYE_CODE_CAPACITY+MESH_CODE_CAPACITY,Code
        load_constant $limit,MESH_CODE_CAPACITY
        clgt    $bad,$value,$limit
        andi    $batch,$batch,FEATURE_TEXTURES
        ceqi    $batch,$batch,0
        andc    $bad,$bad,$batch
        refuse_if $bad,Code
        andi    $bad,$value,15
        refuse_if $bad,Code
no_mesh:
        require_aligned scene,LINE,Scene
        require_aligned waiting,LINE,Waiting
        require_aligned paths,LINE,Paths
        require_aligned changes,16,Changes
        require_at_most change_count,MAX_CHANGES,Changes
        require_from_one ray_depth,MAX_DEPTH,RayDepth
        require_from_one batch,MAX_BATCH,Batch
        require_at_most light_count,MAX_LIGHTS,LightCount
        require_at_most scene_bytes,SCENE_CAPACITY,SceneBytes
        ori     $scene_bytes,$value,0
        andi    $bad,$value,LINE-1
        refuse_if $bad,SceneBytes
        require_at_most box_trees,(1<<TREES)-1,BoxTrees
        ceqi    $value,$value,0
        load_constant $limit,BOX_CODE+BOX_CODE_CAPACITY-SCENE_ADDRESS
        clgt    $bad,$limit,$scene_bytes
        andc    $bad,$bad,$value
        refuse_if $bad,BoxTrees
        load_word $value,FRAME_lights,$a_frame
        ila     $limit,SCENE_ADDRESS
        sf      $value,$limit,$value
        andi    $bad,$value,15
        refuse_if $bad,LightCount
        clgt    $bad,$value,$scene_bytes
        refuse_if $bad,LightCount
        load_word $limit,FRAME_light_count,$a_frame
        shli    $limit,$limit,LIGHT_SIZE_LOG2
        a       $limit,$limit,$value
        clgt    $bad,$limit,$scene_bytes                # where they end
        refuse_if $bad,LightCount
        queue_size $value,$batch
        a       $value,$value,$scene_bytes
        cgti    $bad,$batch,SMALL_BATCH
        brz     $bad,small
        lqa     $bad,streamed
        refuse_if $bad,Batch
        # The buffers that batch_place puts after the queue.
        lqd     $quad,FRAME_trees+BVH_SIZE*BVH_TRIANGLES($a_frame)
        rotqbyi $quad,$quad,BVH_objects
        ceqi    $quad,$quad,0
        il      $left,SHEARS_SIZE
        andc    $left,$left,$quad
        il      $quad,2*RAYS16_SIZE
        a       $left,$left,$quad
        mpyu    $left,$left,$batch
        a       $value,$value,$left
small:  load_constant $limit,SCENE_CAPACITY
        lqa     $batch,streamed
        brz     $batch,resident
        ila     $limit,EYE_CODE-SCENE_ADDRESS
        andi    $batch,$batch,FEATURE_TEXTURES
        brz     $batch,resident
        ila     $limit,TEXTURE_CODE-SCENE_ADDRESS
resident:
        clgt    $bad,$value,$limit
        refuse_if $bad,SceneBytes

        ai      $a_tree,$a_frame,FRAME_trees
        il      $left,TREES
next_tree:
        lqd     $quad,0($a_tree)
        rotqbyi $value,$quad,BVH_objects
        brz     $value,none
        require_of_tree BVH_objects,1,MAX_OBJECTS
        load_word $limit,FRAME_batch,$a_frame
        cgti    $limit,$limit,SMALL_BATCH
        cgti    $bad,$value,LARGE_OBJECTS-1
        and     $bad,$bad,$limit
        refuse_if $bad,Batch
        require_of_tree BVH_root_count,1,MAX_ROOTS
        require_of_tree BVH_levels,0,MAX_LEVELS+1
        ila     $value,SCENE_ADDRESS
        sf      $value,$value,$quad                     # of the roots
        clgt    $bad,$scene_bytes,$value
        xori    $bad,$bad,-1
        refuse_if $bad,Trees
        andi    $bad,$value,15
        refuse_if $bad,Trees
none:   ai      $a_tree,$a_tree,BVH_SIZE
        ai      $left,$left,-1
        brnz    $left,next_tree
        il      $status,STATUS_Done
refused:
        bi      $lr
endfunction whitted_check
