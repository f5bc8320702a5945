# The scene: fetched from main memory and laid out as the kernels read it, once a frame.

        .include "work_unit.inc"
        .include "macros.inc"
        .include "driver.inc"

        .set    CHUNK_SPHERES,MAX_TRANSFER/SPHERE_SIZE
        .set    ENTRY_BYTES,16                          # of the colour table

        .section .bss
        .align  7
        .global eye_spheres, colour_table
chunk:  .skip   MAX_TRANSFER
eye_spheres:
        .skip   MAX_SPHERES*EYESPHERE_SIZE
colour_table:                           # the background, then an entry a sphere
        .skip   (MAX_SPHERES+1)*ENTRY_BYTES

# scene_fetch   fetches the spheres, relative to the eye, and the colours of all objects
#   Uses    $3-$7, $10-$31
        .set    a_frame,15
        .set    m_splat,16
        .set    eye,17
        .set    high,18
        .set    low,19
        .set    left,20                                 # spheres not fetched yet
        .set    part,21
        .set    a_out,22
        .set    a_colour,23
        .set    a_in,24
        .set    centre,25
        .set    colour,26
        .set    radius,27
        .set    axis,28
        .set    c_more,29
        .set    bytes,30
        .set    most,31

function scene_fetch
        enter
        ila     $a_frame,frame
        splat_mask $m_splat
        lqd     $eye,FRAME_eye($a_frame)
        load_word $high,FRAME_spheres,$a_frame
        load_word $low,FRAME_spheres+4,$a_frame
        ori     $left,$g_spheres,0
        ila     $a_out,eye_spheres
        ila     $a_colour,colour_table
        lqd     $colour,FRAME_background($a_frame)
        stqd    $colour,0($a_colour)

next_chunk:
        brz     $left,fetched
        il      $most,CHUNK_SPHERES
        minimum $part,$left,$most,$c_more
        sf      $left,$part,$left
        shli    $bytes,$part,5                          # SPHERE_SIZE
    .if SPHERE_SIZE != 1<<5
        .error  "the shift above is of another sphere record"
    .endif
        ila     $3,chunk
        ori     $4,$high,0
        ori     $5,$low,0
        ori     $6,$bytes,0
        il      $7,TAG_FRAME
        brsl    $lr,dma_get
        il      $3,1<<TAG_FRAME
        brsl    $lr,dma_wait
        add_effective $high,$low,$bytes,$c_more

        ila     $a_in,chunk
next_sphere:
        lqd     $centre,SPHERE_centre($a_in)            # x, y, z, radius
        lqd     $colour,SPHERE_colour($a_in)
        rotqbyi $radius,$centre,SPHERE_radius
        fm      $radius,$radius,$radius
        fs      $centre,$centre,$eye
    .irp place, 0,4,8
        rotqbyi $axis,$centre,\place
        splat   $axis,$axis,$m_splat
        stqd    $axis,EYESPHERE_centre+4*\place($a_out)
    .endr
        splat   $radius,$radius,$m_splat
        stqd    $radius,EYESPHERE_radius_squared($a_out)
        stqd    $colour,ENTRY_BYTES($a_colour)
        ai      $a_in,$a_in,SPHERE_SIZE
        ai      $a_out,$a_out,EYESPHERE_SIZE
        ai      $a_colour,$a_colour,ENTRY_BYTES
        ai      $part,$part,-1
        brnz    $part,next_sphere
        br      next_chunk
fetched:
        leave
endfunction scene_fetch
