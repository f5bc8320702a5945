//! Sources that use each part of the language, and the repository's own without macros.

use std::fs;
use std::path::{Path, PathBuf};

use crate::binutils::{Bench, contents};

fn compare(source: &str) {
    Bench::new().compare("source.s", source);
}

#[test]
fn references_get_the_same_relocations() {
    compare(
        "        .text
        .global g
        .align  3
        .type   h, @function
        .weak   w
f:      il      $3,ext
        ilhu    $3,ext@h
        iohl    $3,ext@l
        ila     $3,ext+8
        lqa     $3,ext
        lqr     $3,ext
        lqr     $3,d
        lqd     $3,ext($4)
        ai      $3,$4,ext
        cwd     $3,ext($4)
        shli    $3,$4,ext
        heqi    $3,ext
        br      ext
        br      f
        br      g
        br      h
        br      h+4
        brz     $3,h
        brnz    $3,g+4
g:      brsl    $0,f
        brsl    $0,g
        brsl    $0,h
        brasl   $0,f
        brasl   $0,h
        brnz    $3,1f
1:      br      1b
1:      brhz    $4,1b
        bra     f
        bra     h
h:      hbrr    2f,f
        hbrr    2f,ext
        hbrr    2f,h
        hbrr    g,ext
        hbrr    ext,g
        hbra    2f,f
        hbra    2f,h
        hbr     2f,$3
        hbr     ext,$3
        hbr     f,$3
2:      lqr     $3,h
        lqr     $3,w
w:      br      w
        ila     $3,f
        ila     $3,d
        ila     $3,g
        ila     $3,h
        ila     $3,o
        lqa     $3,g
        lqa     $3,d+16
        ai      $3,$3,e-d
        il      $3,e-d
        ilhu    $3,f@h
        iohl    $3,d+8@l
        il      $3,later
        .set    later,55
        .set    place,.
        .set    after,place+4
        br      place
        bra     after
        br      .+8
        lqr     $3,.-4
        il      $3,(e-d)*2
        .data
        .type   o, @object
        .size   o, e-o
d:      .long   f, g, ext, ext-., f-., ext-d, 1, h, .-d, after
o:      .long   e-d
        .short  e-d
        .byte   e-d
        .quad   e-d
e:      .long   ext@ppu
        .quad   ext@ppu
        .comm   shared,16,16
        .section .bss
        .align  4
        .skip   5
        .size   f, g-f
",
    );
}

#[test]
fn data_and_alignment_are_the_same() {
    compare(
        r#"        .text
        lnop
        .align  4
        .byte   1
        .align  3
        nop
        .balign 32,,8
        .balign 8,0
        stop
        .p2align 4
        .data
        .float 1.5, 1e-40, -0.1, 3.4028235e38, 0f2.5, -0.0, 0e-50, +2
        .single 2
        .double 1.5,1e308,5e-324,-0.1,0d3
        .ascii "a\n\101\x41\"\\\t\r\b\f",  "b # ; c"
        .asciz "x"
        .string "y","z", ""
        .space 3
        .skip 2,7
        .zero 2
        .fill 2,4,5
        .fill 3
        .fill 2,2
        .fill 2,8,0x11223344
        .fill 1,8,-1
        .fill 1,3,-2
        .space 2,-1
        .byte 'a, -1,255,'\n, 'b','"','#',';', '''
        .hword -1, 65535
        .2byte 3
        .short 1 ; .int 5 ; .4byte 6
        .quad 'x'+1, -1, 0x8000000000000000, 18446744073709551615
        .8byte 7
word:   .word   word-word+4
        .align  2
        byte 9
        long 10
        .section .rodata
        .byte   1
        .align  4
        .byte   2
        .balign 8,7
        .byte   3
        .section .rodata.text,"aMS",@progbits,1
p:      .asciz  "x"
q:      .ascii  "y"
        .section note,"",@progbits
        .long   p, q
        .section "own.code","ax",@progbits
        .align  3
        nop
        .pushsection .data
        .long   11
        .popsection
        lnop
        .previous
        .long   12
        .section .rodata.k,"aG",@progbits,key,comdat
        .align  4
key:    .long   1
        .text
        ila     $3,key
        .ident  "one"
        .ident  "two"
        .file   "name.s"
"#,
    );
}

#[test]
fn expressions_have_the_same_values() {
    compare(
        "x=5
        .set    x,6
        .equ    z,x+1
        .equiv  q,9
y = 8
        .set    o,32
        .set    base,5
        .long   1+2*3, 10/3, -7/2, -7%3, 1<<4|1, 6&3^1, 5!1, ~1, !0, !5, 1==1, 2<1, 2<>3, 2>=1
        .long   3&&0, 3||0, 0b101, 017, 0x1F, 1|2&3, 1+2|4, 1|4+2, 2*3|1, 8/2&3, 3&4*5, 1<<2+1
        .long   1+1<<2, 2*1<<2, 1+2==3, 1==1+2, 4-2<3, 1&&2==2, 3>2-1, 1|2==3, 2==3|1, !1+1
        .long   -2*3, ~1&3, - - 3, 5-3-1, 1<<2<<1, 7&3|4, 1<2==1, 1||0&&0, 1 != 2, 3!=3, (1+2)*3
        .quad   -1>>1, 1<<63, 5-7, 0-1>>60
        .long   x,y,z,q
        .set    x,10
        .long   x,z
        lqd     $3,(16)+16($4)
        lqd     $3,o+(1<<4)($4)
        lqd     $3,(o)&~15($base)
        lqd     $base,o-16($base+1)
        lqd     $3,o($(base+2))
        a       $3,$base+1,$base*2
        il      base,3
        il      $(base+1),3
        rdch    $base,$base
        wrch    base,$base
        .set    y,forward
        ila     $3,y
        .set    forward,12
        .set    forward,13
        ila     $3,y
start:  .long   end-start, (end-start)/4, end>start, end==start
end:
",
    );
}

#[test]
fn all_forms_of_instructions_are_the_same() {
    compare(
        "        br 8\n br -262144\n br 262143\n bra -131072\n bra 262143\n hbrr -1024,8
        hbrr 1020,262143\n lqa $3,-16\n hbr 1023,$3\n lqa $3,0x20004\n lqr $3,16\n stop 0x3fff
        stop\n heq $3,$4\n heq $3,$4,$5\n hgti $3,5\n hlgti $3,$4,5\n iret\n iret $5\n iretd
        fscrwr $3\n fscrwr $3,$4\n fscrrd $3\n nop\n nop $7\n nop $127\n lnop\n sync\n syncc
        dsync\n hbrp\n lr $3,$4\n bisled $3,$4\n bisledd $3,$4\n bisle $lr,$4\n bif $3,$4
        bitd $3,$4\n bihfe $3,$4\n biht $3,$4\n bie $lr\n bizd $3,$4\n rdch $3,$ch4\n rdch $3,4
        rdch 3,SPU_RdInMbox\n rdch $3,$SPU_RdInMbox\n wrch $MFC_EAL,$4\n wrch MFC_Cmd,4
        rchcnt $5,$MFC_RdTagStat\n il 3,4\n il lr,4\n il sp,5\n il $LR,5\n mfspr $3,$sp4
        mfspr 3,4\n mtspr $sp5,$3\n il fp,3\n il rp,3\n IL $3,1\n lqd $3, 16 ( $4 )
        stqd $lr,16($sp)\n lqd $3,17($4)\n lqd $3,-8192($sp)\n cbd $3,127($4)\n cbd $3,200($4)
        cbd $3,-64($4)\n roti $3,$4,300\n rotqbyi $3,$4,-1\n andbi $3,$4,255\n andbi $3,$4,-128
        ilh $3,-1\n ilh $3,65535\n fsmbi $3,0xffff\n iohl $3,-32768\n il $3,-32768
        cflts $3,$4,127\n csflt $3,$4,0\n rotqmbii $3,$4,-300\n shlqbii $3,$4,9\n shli $3,$4,63
        rothmi $3,$4,-31\n dftsv $3,$4,127\n ilhu $3,0x12345678@h\n iohl $3,0x12345678@l
        ila $3,0x3ffff; ai $3,$3,-512 /* two
        lines */ ; ai $3,$3,511 # the last
",
    );
}

fn repository() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

/// All assembly sources below a folder.
fn sources(folder: &Path, found: &mut Vec<PathBuf>) {
    let mut entries: Vec<PathBuf> =
        fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()).collect();
    entries.sort();
    for path in entries {
        if path.is_dir() {
            sources(&path, found);
        } else if path.extension().is_some_and(|extension| extension == "s") {
            found.push(path);
        }
    }
}

#[test]
fn the_repositorys_sources_without_macros_are_the_same() {
    let mut found = Vec::new();
    for folder in ["examples", "emulator", "lab/spu", "spu", "tests"] {
        sources(&repository().join(folder), &mut found);
    }
    let bench = Bench::new();
    let mut compared = 0;
    for path in found {
        let text = fs::read_to_string(&path).unwrap();
        let name = path.display().to_string();
        match spu_assembler::assemble(&name, &text) {
            // Sources for the PPE's assembler, too, are below these folders.
            // Of its repetitions, the binutils' listing shows what they expand to.
            Err(_) if path.ends_with("examples/spu/main.s") => {
                bench.compare(&name, &bench.expand(&path, &[]));
                compared += 1;
            }
            Err(errors) => assert!(errors.uses_macros || !name.contains("spu"), "{errors}"),
            Ok(_) => {
                bench.compare(&name, &text);
                compared += 1;
            }
        }
    }
    assert!(compared >= 10, "{compared} sources have no macros");
}

/// The bytes from address 0 on of the program that the linker of the binutils makes.
#[test]
fn a_linked_program_is_the_linkers() {
    let source = "
        .data
        .balign 16
values: .long   1, 2, limit, values, 4
        .text
        .global _start
_start: ila     $3,values
        brsl    $lr,double
        ilhu    $4,table@h
        iohl    $4,table@l
        lqa     $5,table
        hbrr    1f,_start
        brasl   $lr,double
1:      stop    0x2000
        .set    limit,9
        .type   double, @function
double: lqr     $6,values
        ila     $7,zeroed
        ila     $8,_end
        bi      $lr
        .size   double, .-double
        .section .rodata
        .balign 16
table:  .quad   5
        .long   double-., table, shared
        .bss
        .balign 16
zeroed:   .skip   40
        .comm   shared,16,16
";
    let bench = Bench::new();
    let their_source = source.replace(".bss\n", ".section .bss\n");
    bench.assemble(&their_source);
    let image = bench.path("image");
    let linker = linker();
    let mut command = std::process::Command::new(&linker);
    command.arg(bench.path("source.o")).arg("-o").arg(&image);
    let output = command.output().unwrap_or_else(|error| panic!("{}: {error}", linker.display()));
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let theirs = contents(&fs::read(&image).unwrap());
    let ours = spu_assembler::assemble("source.s", source).unwrap().link(0).unwrap();
    for (name, (_, _, size, bytes)) in &theirs.sections {
        if [".text", ".rodata", ".data"].contains(&name.as_str()) {
            let found = ours.bytes.windows(bytes.len()).position(|window| window == bytes);
            assert!(found.is_some(), "{name}: {size} bytes");
        }
    }
    let symbols = theirs.symbols.iter().map(|symbol| (symbol.0.as_str(), symbol.2));
    let theirs: std::collections::BTreeMap<&str, u64> = symbols.collect();
    for symbol in &ours.symbols {
        assert_eq!(theirs[symbol.name.as_str()], u64::from(symbol.address), "{}", symbol.name);
    }
}

/// The linker that belongs to the assembler.
fn linker() -> PathBuf {
    if let Some(path) = std::env::var_os("SPU_LD") {
        return path.into();
    }
    let home = std::env::var_os("HOME").map(|home| Path::new(&home).join(".cache"));
    let cache = std::env::var_os("XDG_CACHE_HOME").map(PathBuf::from).or(home);
    let path = std::env::var_os("PATH").unwrap_or_default();
    let cached = cache.map(|cache| cache.join("cellray/spu-binutils/bin"));
    let folders = std::env::split_paths(&path).chain(cached);
    let all = folders.flat_map(|folder| ["spu-elf-ld", "spu-ld"].map(|name| folder.join(name)));
    let found = all.into_iter().find(|file| file.is_file());
    found.expect("spu-elf-ld not found: run ci/setup, or set SPU_LD")
}
