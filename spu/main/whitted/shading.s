# The shaders' context: the frame's data for shaders.

        .include "work_unit.inc"
        .include "macros.inc"

        .set    NEXT,10
        registers a_frame,value,lights,m_second

# shading_prepare   fills the shaders' context
#   Uses    $10-$13
function shading_prepare
        ila     $a_frame,frame
        lqd     $value,FRAME_eye($a_frame)
        stqa    $value,shading+SHADING_eye
        load_word $value,FRAME_light_count,$a_frame
        load_word $lights,FRAME_lights,$a_frame
        cwd     $m_second,4($sp)
        shufb   $value,$lights,$value,$m_second
        stqa    $value,shading+SHADING_light_count
        bi      $lr
endfunction shading_prepare
