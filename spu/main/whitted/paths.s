# The paths of a tile's rays: the volumes that they have crossed are kept in main memory. When
# objects change, only those subtiles of the tile are traced again whose rays may have crossed a
# place in which something has changed. The others show the same.
#
# This is exact because a ray can only find something else if it crosses such a place before it
# hits. Shadow rays that are stopped may be stopped farther on as well, so they count with their
# whole length.

        .include "work_unit.inc"
        .include "macros.inc"
        .include "driver.inc"
        .include "whitted.inc"
        .include "extremes.inc"

        # Where a tile's paths are tested, while nothing of it has been traced.
        .set    FETCHED,BATCH_RAYS
        # The bytes that are fetched at first.
        .set    FIRST_BYTES,8192
        .set    FIRST_PATHS,(FIRST_BYTES-PATHS_SIZE)/PATH_SIZE
        # Where the changed places are. They are fetched with each tile's paths, since rays take
        # their place, and there is none for good.
        .set    CHANGES,FETCHED+PATHS_CAPACITY
        # The smallest numbers that the kernels take.
        .set    FEWEST_PACKETS,4
        .set    FEWEST_PATHS,8
        .set    THIRD_OF_PATHS_LOG2,13
    .if PATHS_CAPACITY != 3<<THIRD_OF_PATHS_LOG2
        .error  "a tile's paths are not where paths_begin looks for them"
    .endif
    .if CHANGES+MAX_CHANGES*NODE_SIZE > OBJECT_LIST
        .error  "the paths of a tile reach into the lists"
    .endif

        .section .bss
        .align  4
        .global keeps_paths
keeps_paths:                            # whether the frame keeps paths
        .skip   16
        .global tile_subtiles
tile_subtiles:                          # those of the current tile that are traced, in all words
        .skip   16
path_count:                             # the tile's records in main memory; more than MAX_PATHS if
        .skip   16                      # there was no place for some
path_offset:                            # where the next ones go
        .skip   16
path_bytes:                             # the size of these
        .skip   16
paths_high:                             # the effective address of the tile's PATHS
        .skip   16
paths_low:
        .skip   16
header: .skip   PATHS_SIZE

        .section .data.mesh,"aw",@progbits
        .align  4
mesh_paths:                             # of the packets that are traced through a mesh
        .skip   SMALL_BATCH*PATH_SIZE

        .set    NEXT,10
        registers a_frame,t_c,count,high,low,offset,bytes,command,tag,most
        registers a_from,a_to,left,record0,record1,record2,kept,m_subtiles,c_kept,row0,row1,row2,row3

# The effective address of the current tile's PATHS.
.macro  tile_paths_address out_high:req, out_low:req
        lqa     \out_high,paths_high
        lqa     \out_low,paths_low
.endm

# paths_prepare   looks up whether the frame keeps paths
#   Uses    $10-$13
function paths_prepare
        ila     $a_frame,frame
        load_word $count,FRAME_paths,$a_frame
        load_word $high,FRAME_paths+4,$a_frame
        or      $count,$count,$high
        stqa    $count,keeps_paths
        il      $count,-1
        stqa    $count,tile_subtiles
        bi      $lr
endfunction paths_prepare

# paths_begin   finds the subtiles of the current tile that must be traced, and begins its paths
#               with those of the others
#   Out     $3 the subtiles, as in tile_subtiles
#   Uses    $3-$79
function paths_begin
        enter
        il      $3,-1
        lqa     $count,keeps_paths
        stqa    $3,tile_subtiles
        brz     $count,begun
        il      $count,0
        stqa    $count,path_count
        ila     $a_frame,frame
        load_word $high,FRAME_paths,$a_frame
        load_word $low,FRAME_paths+4,$a_frame
        lqa     $offset,tile_number
        a       $bytes,$offset,$offset
        a       $offset,$offset,$bytes
        shli    $offset,$offset,THIRD_OF_PATHS_LOG2
        add_effective $high,$low,$offset,$t_c
        stqa    $high,paths_high
        stqa    $low,paths_low
        lqa     $offset,tile_flags
        shli    $offset,$offset,1                       # TILE_HAS_PATHS is now the sign
        rotmi   $offset,$offset,-31
        brz     $offset,begun
        load_word $count,FRAME_change_count,$a_frame
        il      $3,0
        brz     $count,begun
        mpyi    $6,$count,NODE_SIZE
        load_word $4,FRAME_changes,$a_frame
        load_word $5,FRAME_changes+4,$a_frame
        ila     $3,arena+CHANGES
        il      $7,TAG_PATHS
        brsl    $lr,dma_get
        tile_paths_address $4,$5
        ila     $3,arena+FETCHED
        il      $6,FIRST_BYTES
        brsl    $lr,paths_get
        lqa     $count,arena+FETCHED
        il      $3,-1
        ai      $t_c,$count,-FEWEST_PATHS
        clgti   $t_c,$t_c,MAX_PATHS-FEWEST_PATHS
        brnz    $t_c,begun
        ai      $left,$count,-FIRST_PATHS
        cgti    $t_c,$left,0
        brz     $t_c,fetched
        tile_paths_address $4,$5
        il      $offset,FIRST_BYTES
        add_effective $4,$5,$offset,$t_c
        ila     $3,arena+FETCHED+FIRST_BYTES
        load_constant $6,PATHS_CAPACITY-FIRST_BYTES
        brsl    $lr,paths_get
fetched:
        ila     $3,arena+FETCHED+PATHS_SIZE
        lqa     $4,arena+FETCHED
        ila     $5,arena+CHANGES
        ila     $6,frame
        load_word $6,FRAME_change_count,$6
        # The first node is around all others.
        cgti    $t_c,$6,1
        il      $left,1
        selb    $6,$6,$left,$t_c
        brsl    $lr,paths_meet
        brz     $3,begun
        ila     $6,frame
        load_word $6,FRAME_change_count,$6
        ai      $6,$6,-1
        brz     $6,met
        ila     $3,arena+FETCHED+PATHS_SIZE
        lqa     $4,arena+FETCHED
        ila     $5,arena+CHANGES+NODE_SIZE
        brsl    $lr,paths_meet
        brz     $3,begun
met:
        # An antialiased pixel depends on its neighbours, and a tile at the picture's edge is small.
        # Where chains branch, the batches decide in which order a pixel's light is added, and so
        # how the sum is rounded.
        lqa     $t_c,contrast
        ila     $a_frame,frame
        load_word $count,FRAME_features,$a_frame
        il      $most,FEATURE_BRANCHES
        and     $count,$count,$most
        cgti    $t_c,$t_c,-1
        ceq     $count,$count,$most
        or      $t_c,$t_c,$count
        mpyu    $count,$g_tile_width,$g_tile_height
        il      $most,TILE_WIDTH*TILE_HEIGHT
        cgt     $count,$most,$count
        or      $t_c,$t_c,$count
        or      $3,$3,$t_c
        ila     $t_c,0x10203
        shufb   $3,$3,$3,$t_c
        stqa    $3,tile_subtiles
        ai      $t_c,$3,1
        brz     $t_c,begun
        brsl    $lr,paths_drop
        lqa     $3,tile_subtiles
begun:  leave
endfunction paths_begin

# paths_drop   takes those of the subtiles that are traced out of the fetched paths, and sends the
#              others back
#   In      $3 these subtiles, in all words
#   Out     path_count
#   Uses    $3-$7, $10-$24
function paths_drop
        enter
        fsmbi   $m_subtiles,0x00f0                      # the word PATH_subtiles
        and     $m_subtiles,$m_subtiles,$3
        ila     $a_from,arena+FETCHED+PATHS_SIZE
        ori     $a_to,$a_from,0
        lqa     $left,arena+FETCHED
        il      $count,0
next_path:
        hbrr    last_path,next_path
        lqd     $record0,0($a_from)
        lqd     $record1,16($a_from)
        lqd     $record2,32($a_from)
        ai      $a_from,$a_from,PATH_SIZE
        andc    $record2,$record2,$m_subtiles
        rotqbyi $kept,$record2,PATH_subtiles-32
        stqd    $record0,0($a_to)
        stqd    $record1,16($a_to)
        stqd    $record2,32($a_to)
        clgti   $c_kept,$kept,0
        sf      $count,$c_kept,$count
        andi    $c_kept,$c_kept,PATH_SIZE
        a       $a_to,$a_to,$c_kept
        ai      $left,$left,-1
last_path:
        brnz    $left,next_path
        stqa    $count,path_count
        mpyi    $6,$count,PATH_SIZE
        tile_paths_address $4,$5
        il      $offset,PATHS_SIZE
        add_effective $4,$5,$offset,$t_c
        ila     $3,arena+FETCHED+PATHS_SIZE
        il      $7,TAG_PATHS
        brsl    $lr,dma_put
        load_constant $3,1<<TAG_PATHS
        brsl    $lr,dma_wait
        leave
endfunction paths_drop

# paths_get   fetches some of the tile's paths, and waits
#   In      $3 local store, $4 and $5 effective address, $6 bytes
#   Uses    $3-$7, $10-$14
function paths_get
        enter
        il      $7,TAG_PATHS
        brsl    $lr,dma_get
        load_constant $3,1<<TAG_PATHS
        brsl    $lr,dma_wait
        leave
endfunction paths_get

# paths_make   makes the paths of packets
#   In      $3 RAYS16, consecutive, $4 count, $5 -1 if they end at their t, 0 if where their bounds
#           end, $6 where the paths go
#   Uses    $3-$79
function paths_make
        enter
        lqa     $t_c,rays_at
        ceq     $t_c,$t_c,$3
        ori     $7,$5,0
        ori     $8,$6,0
        ila     $6,light_sites
        brz     $t_c,listed
        # The batch's rays have their own pixels.
        lqa     $3,sites_at
        il      $4,0
        il      $5,0
        brsl    $lr,sites_list                          # keeps $7 and $8
        lqa     $3,rays_at
        ori     $4,$w_count,0
        lqa     $6,sites_at
listed:
        lqa     $5,bounds_at
        ila     $9,arena+PIXEL_SUMS
        # Those of more packets than there are may be anything.
        il      $t_c,FEWEST_PACKETS
        cgt     $most,$t_c,$4
        selb    $4,$4,$t_c,$most
        brsl    $lr,path_bounds_r16
        leave
endfunction paths_make

# paths_before_mesh   makes the paths of packets before a mesh's own bounds take the place of theirs
#   In      $3 RAYS16, consecutive, $4 count
#   Uses    $3-$79
function paths_before_mesh
        lqa     $5,keeps_paths
        biz     $5,$lr
        il      $5,0
        ila     $6,mesh_paths
        br      paths_make
endfunction paths_before_mesh

# paths_add   adds the paths of packets that have been traced
#   In      $3 RAYS16, consecutive, $4 count, $5 -1 if they end at their t, 0 if where their bounds
#           end
#   Uses    $3-$79
function paths_add
        enter
        lqa     $count,path_count
        a       $most,$count,$4
        stqa    $most,path_count
        cgti    $t_c,$most,MAX_PATHS
        brnz    $t_c,added
        mpyi    $count,$count,PATH_SIZE
        ai      $count,$count,PATHS_SIZE
        stqa    $count,path_offset
        mpyi    $count,$4,PATH_SIZE
        stqa    $count,path_bytes
        lqa     $6,bounds_at
        lqa     $t_c,streamed
        brnz    $t_c,made
        brsl    $lr,paths_make
        lqa     $3,bounds_at
send:   tile_paths_address $4,$5
        lqa     $offset,path_offset
        add_effective $4,$5,$offset,$t_c
        lqa     $6,path_bytes
        il      $7,TAG_PATHS
        brsl    $lr,dma_put
added:  leave

        # They were made before the mesh was traced, and end now where the rays do.
made:   ila     $a_to,mesh_paths
        brz     $5,ends_set
        ori     $left,$4,0
        cwd     $m_subtiles,PATH_farthest-32($sp)
next_end:
    .irp row, 0,1,2,3
        lqd     $row\row,RAYS16_t+16*\row($3)
    .endr
        maximum $row0,$row1,$t_c
        maximum $row2,$row3,$t_c
        maximum $row0,$row2,$t_c
        rotqbyi $row1,$row0,8
        maximum $row0,$row1,$t_c
        rotqbyi $row1,$row0,4
        maximum $row0,$row1,$t_c
        lqd     $record2,32($a_to)
        shufb   $record2,$row0,$record2,$m_subtiles
        stqd    $record2,32($a_to)
        ai      $3,$3,RAYS16_SIZE/2
        ai      $3,$3,RAYS16_SIZE/2
        ai      $a_to,$a_to,PATH_SIZE
        ai      $left,$left,-1
        brnz    $left,next_end
ends_set:
        ila     $3,mesh_paths
        br      send
endfunction paths_add

# paths_end   ends the paths of the current tile
#   Out     $3 TILE_HAS_PATHS if all of them are in main memory, otherwise 0
#   Uses    $3-$7, $10-$20
function paths_end
        lqa     $3,keeps_paths
        biz     $3,$lr
        enter
        load_constant $3,1<<TAG_PATHS
        brsl    $lr,dma_wait
        lqa     $count,path_count
        il      $3,0
        cgti    $t_c,$count,MAX_PATHS
        brnz    $t_c,ended
        fsmbi   $m_subtiles,0xf000
        and     $count,$count,$m_subtiles
        stqa    $count,header
        tile_paths_address $4,$5
        ila     $3,header
        il      $6,PATHS_SIZE
        il      $7,TAG_PATHS
        brsl    $lr,dma_put
        ilhu    $3,TILE_HAS_PATHS>>16
ended:  leave
endfunction paths_end
