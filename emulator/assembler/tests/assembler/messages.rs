//! Messages name the place and the correction.

use spu_assembler::assemble;

fn message(source: &str) -> String {
    assemble("x.s", source).unwrap_err().to_string()
}

#[test]
fn errors_name_the_place_and_the_reason() {
    let cases = [
        (" a $3,$4\n", "x.s:1:4: the operands of a are rt, ra, rb; 2 are given"),
        ("\n\tshufbb $3,$4,$5,$6", "x.s:2:2: there is no instruction shufbb; did you mean shufb?"),
        (" .aling 3", "x.s:1:2: there is no directive .aling; did you mean .align?"),
        (" il $3,40000", "x.s:1:8: 40000 is outside -32768 to 32767"),
        (" ai $3,$4,512", "x.s:1:11: 512 is outside -512 to 511"),
        (" il $128,1", "x.s:1:5: 128 is no register: they are numbered 0 to 127"),
        (" .set sum,5\n il $sun,1", "x.s:2:5: there is no register sun; did you mean sum?"),
        (
            " rdch $3,$SPU_RdInMBoxx",
            "x.s:1:10: there is no channel SPU_RdInMBoxx; did you mean SPU_RdInMbox?",
        ),
        (" lqd $3,$4", "x.s:1:9: `$4` where a constant should be"),
        (" lqd $3,0[$4]", "x.s:1:10: `[$4]` where `(` should be"),
        ("f: nop\nf: nop", "x.s:2:1: f is defined already"),
        (" br 1b", "x.s:1:5: there is no label 1: before this line"),
        (" br 1f", "x.s:1:5: there is no label 1f here"),
        (" .long 1/0", "x.s:1:8: division by 0"),
        (" .long 5*", "x.s:1:10: the statement's end where a constant or a symbol should be"),
        (" .byte foo", "x.s:1:8: the address of a symbol does not fit here"),
        (" .long a-b", "x.s:1:8: the distance between these places is not known"),
        (
            " .set a,b+1\n .set b,a+1",
            "x.s:1:7: a is defined by itself\nx.s:2:7: b is defined by itself",
        ),
        (" .float inf", "x.s:1:9: inf is no number that this type has"),
        (" .float 3.5e38", "x.s:1:9: 3.5e38 is no number that this type has"),
        (" .ascii \"abc", "x.s:1:9: this string has no end"),
        (" /* never", "x.s:1:2: this comment has no end"),
        (" .balign 12", "x.s:1:10: 12 is no alignment: at most 256 KB, and a power of two"),
        (" .section .t,\"aZ\"", "x.s:1:14: the flag Z of a section is not one of awxMSG"),
        (" .skip 0x7fffffffffff", "x.s:1:2: 140737488355327 is no size of at most 16 MB"),
        (" .skip later\n .set later,4", "x.s:1:8: this number must be known here"),
        (" nop é\n ai $3,$4,é,5\n", "x.s:1:6: `é` where a constant or a symbol should be"),
    ];
    for (source, expected) in cases {
        let found = message(source);
        assert!(found.starts_with(expected), "{source}\n{found}\n{expected}");
    }
    let found = message(" a\n b\n;  il $3,1 ; il $3\n");
    let places: Vec<&str> = found.lines().map(|line| &line[..7]).collect();
    assert_eq!(places, ["x.s:1:3", "x.s:2:2", "x.s:3:1"], "{found}");
}

#[test]
fn macros_are_left_to_the_binutils() {
    for source in
        [" .macro m\n .endm", " .include \"x.inc\"", " .rept 3\n nop\n .endr", " .if 1\n .endif"]
    {
        let errors = assemble("x.s", source).unwrap_err();
        assert!(errors.uses_macros, "{errors}");
    }
    assert!(!assemble("x.s", " foo").unwrap_err().uses_macros);
}

#[test]
fn unusual_numbers_are_warned_of() {
    let program = assemble("x.s", " shli $3,$4,64\n .byte 256\n .long later\n .set later,1<<32\n");
    let warnings: Vec<String> = program.unwrap().warnings.iter().map(ToString::to_string).collect();
    assert_eq!(
        warnings,
        [
            "x.s:1:13: 64 is outside 0 to 63",
            "x.s:2:8: of 0x100 only the low 8 bits are stored",
            "x.s:3:8: of 0x100000000 only the low 32 bits are stored",
        ]
    );
}

#[test]
fn a_program_that_needs_other_files_is_not_linked() {
    let program = assemble("x.s", "_start: brsl $lr,doubel\n nop\ndouble: bi $lr\n").unwrap();
    let errors = program.link(0).unwrap_err();
    let expected = "x.s:1:18: doubel is not defined; did you mean double?";
    assert_eq!(errors.to_string(), expected);
    let large = assemble("x.s", " .data\n .skip 0x40000\n nop").unwrap();
    let errors = large.link(0x80).unwrap_err().to_string();
    assert_eq!(errors, "x.s:1:1: from 0x80 on, the program does not fit into local store");
}

/// Neither truncated sources nor wrong characters panic, and each error is in the source.
#[test]
fn damaged_sources_are_refused() {
    let source =
        "f:\tlqd $3,(1+2)*16($4) ; .ascii \"é\\x41\" # é\n .set a,'\\n'+f-. /* é */\n.byte a\n";
    let ends = (0..=source.len()).filter(|&end| source.is_char_boundary(end));
    for end in ends {
        for inserted in ["", "\"", "'", "\\", "(", "é", "/*", "$", "@", "-", "\u{0}", "1f", ":"] {
            let damaged = format!("{}{inserted}{}", &source[..end], &source[end..]);
            for text in [&damaged, &damaged[..end + inserted.len()]] {
                if let Err(errors) = assemble("x.s", text) {
                    let lines = text.matches('\n').count() as u32 + 1;
                    assert!(errors.errors.iter().all(|error| error.position.line <= lines));
                }
            }
        }
    }
    let deep = format!(" .long {}1", "(".repeat(100_000));
    assert!(message(&deep).contains("too deep"));
    let long = format!(" .long 1{}", "+f".repeat(100_000));
    assert!(message(&long).contains("too long"));
    let sum = format!(" .long 1{}", "+1".repeat(100_000));
    assert!(assemble("x.s", &sum).is_ok());
}
