# objects_pack   packs the first of some sorted spheres and cones into a leaf block without records
#                and boxes
#   C       int objects_pack(const void *objects, int count, struct mesh_block *, void *list,
#                            unsigned low, unsigned quads, unsigned number);
#   In      $3 BUILD_TRIANGLE records, and 256 bytes after them, $4 how many, at least 1, $5 the
#           block, $6 where the DMA list of its records goes, 128 bytes, $7 low word of the address
#           of all records, $8 how many quadwords these have, at most 2^24, $9 the block's number;
#           pointers 16-aligned
#   Out     $3 how many objects are in the block; 0 if one of them is not among the records
#   Uses    $3-$9, $10-$69
#   Domain  any
#   Error   0
#   Twin    lab/twins/src/objects.rs
#
# A block has objects of one kind. If there are more of these than it holds, it ends where codes
# differ most, among the places where it is nearly full, because the objects after such a place are
# the farthest.

        .include "work_unit.inc"
        .include "macros.inc"

    .if BUILD_MOST != 16 || BUILD_CONE != 1<<30 || MESH_CONES != MESH_SPHERES+1
        .error  "objects are packed otherwise than this code takes them to be"
    .endif
    .if CONE_SIZE != OBJECT_SIZE+16
        .error  "a cone's record is not a quadword longer than a sphere's"
    .endif

        .set    NEXT,3
        registers a_object,left,a_block,a_list,low,quads,number
        .set    NEXT,10
        registers m_splat,m_pair,m_two_pairs,k_index,k_cone,lanes
        registers object                                # to 32
        .set    NEXT,object+17
        registers kind,same,within,is_in,count,place,end,bad,bytes,length
        registers pair,other,quad,best,differs,better,cut,more
        registers groups,many,levels,nodes,word,t,first,step,child,a_low,a_to

        .section .rodata.objects,"a",@progbits
        .align  4
first_words:                                            # of two quadwords
        .int    0x00010203,0x10111213,0x00010203,0x10111213
two_words:
        .int    0x00010203,0x04050607,0x10111213,0x14151617
numbers:
        .int    0,1,2,3
lower:
    .irp node, 1,2,3,4
        .int    MESH_HEADER_SIZE+\node*BOXES_SIZE
    .endr

# Whether the element \at is there and of the block's kind.
.macro  is_such at:req
        shlqbyi $same,$object+\at,8
        xor     $same,$same,$kind
        and     $same,$same,$k_cone
        ceqi    $same,$same,0
        cgti    $within,$left,\at
        and     $same,$same,$within
        and     $is_in,$is_in,$same
.endm

# Counts the element \at, if it is in the block, and makes the \element of the list that fetches its
# record.
.macro  add at:req, element:req
        is_such \at
        sf      $count,$is_in,$count
        shlqbyi $place,$object+\at,4
        and     $place,$place,$k_index
        a       $end,$place,$length
        clgt    $end,$end,$quads
        and     $end,$end,$is_in
        or      $bad,$bad,$end
        shli    $place,$place,4
        a       $place,$place,$low
        shufb   \element,$bytes,$place,$m_pair
    .if \at >= BUILD_FEWEST-1
        xor     $differs,$object+\at,$object+\at+1
        clgt    $better,$best,$differs
        andc    $better,$is_in,$better
        selb    $best,$best,$differs,$better
        selb    $cut,$cut,$count,$better
    .endif
.endm

function objects_pack
        splat_mask $m_splat
        lqa     $m_pair,first_words
        lqa     $m_two_pairs,two_words
        lqa     $lanes,numbers
        ilhu    $k_index,0xff
        iohl    $k_index,0xffff
        ilhu    $k_cone,BUILD_CONE>>16
    .irp at, 0,1,2,3,4,5,6,7,8,9,10,11,12,13,14,15,16
        lqd     $object+\at,16*\at($a_object)
    .endr
        shlqbyi $kind,$object,8
        and     $length,$kind,$k_cone
        rotmi   $length,$length,-30
        ai      $length,$length,OBJECT_SIZE/16
        shli    $bytes,$length,4
        il      $is_in,-1
        il      $count,0
        il      $bad,0
        il      $best,0
        il      $cut,0
    .irp at, 0,2,4,6,8,10,12,14
        add     \at,$pair
        add     \at+1,$other
        shufb   $quad,$pair,$other,$m_two_pairs
        stqd    $quad,8*\at($a_list)
    .endr
        is_such 16
        selb    $count,$count,$cut,$is_in

        il      $t,0
        ori     $a_to,$a_block,0
        il      $left,MESH_BLOCK/256
next_clear:
    .irp of, 0,1,2,3,4,5,6,7,8,9,10,11,12,13,14,15
        stqd    $t,16*\of($a_to)
    .endr
        ai      $a_to,$a_to,256
        ai      $left,$left,-1
        brnz    $left,next_clear                        # at least 8 passes

        ai      $groups,$count,3
        rotmi   $groups,$groups,-2
        cgti    $many,$count,4
        sfi     $levels,$many,1
        sf      $nodes,$many,$groups
        load_constant $t,MESH_MAGIC
        shufb   $word,$t,$number,$m_pair
        ai      $kind,$length,MESH_SPHERES-OBJECT_SIZE/16
        shufb   $t,$kind,$levels,$m_pair
        shufb   $word,$word,$t,$m_two_pairs
        stqd    $word,0($a_block)
        shufb   $word,$nodes,$count,$m_pair
        il      $t,0
        shufb   $word,$word,$t,$m_two_pairs
        stqd    $word,16($a_block)

        # The root has the nodes below it, if there are any.
        lqa     $child,lower
        splat   $groups,$groups,$m_splat
        cgt     $more,$groups,$lanes
        and     $child,$child,$more
        stqd    $child,MESH_HEADER_SIZE+BOXES_child($a_block)
        mpyi    $first,$nodes,BOXES_SIZE
        ai      $first,$first,MESH_HEADER_SIZE
        splat   $first,$first,$m_splat
        splat   $step,$bytes,$m_splat
        splat   $t,$count,$m_splat
        mpy     $child,$lanes,$step
        a       $first,$first,$child
        shli    $step,$step,2
        andi    $a_low,$many,BOXES_SIZE
        a       $a_low,$a_low,$a_block
    .irp node, 0,1,2,3
        cgt     $more,$t,$lanes
        and     $child,$first,$more
        stqd    $child,MESH_HEADER_SIZE+\node*BOXES_SIZE+BOXES_child($a_low)
      .if \node < 3
        ai      $lanes,$lanes,4
        a       $first,$first,$step
      .endif
    .endr
        ceqi    $t,$bad,0
        and     $3,$count,$t
        bi      $lr
endfunction objects_pack
