//! Compares what the analyser reads from our objects with what it reads from those of the SPU
//! binutils: words, labels, functions and source lines.

use std::fs;
use std::path::Path;

use spu_build::Tools;
use spu_scheduler::code::Code;

/// The lines of all words that are no filler.
fn lines(code: &Code) -> Vec<(u32, u64)> {
    let sources = code.sources().into_iter();
    let known = sources.filter(|(address, _)| !code.is_filler(*address));
    known.map(|(address, source)| (address, source.line)).collect()
}

#[test]
fn the_analyser_reads_the_same_from_our_objects() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let tools = Tools::find().expect("ci/setup builds the SPU binutils");
    let folder = tempfile::tempdir().expect("a folder");
    let mut compared = 0;
    for place in ["emulator/playground/page/examples", "examples/spu"] {
        for entry in fs::read_dir(root.join(place)).expect("a folder of examples") {
            let path = entry.expect("an entry").path();
            let object = folder.path().join("object.o");
            tools.assemble(&[], &[], &object, &path).expect("the binutils assemble it");
            let theirs = Code::parse(&fs::read(&object).expect("an object")).expect("code");
            let text = fs::read_to_string(&path).expect("a source");
            let program = spu_assembler::assemble("example.s", &text).expect("we assemble it");
            let ours = Code::parse(&program.elf()).expect("code");

            let path = path.display();
            assert_eq!(ours.functions(), theirs.functions(), "{path}");
            assert_eq!(ours.words(0, 0x4_0000), theirs.words(0, 0x4_0000), "{path}");
            let labels = |code: &Code| {
                let of = |address| code.label(address).map(str::to_owned);
                code.labels().map(|address| (address, of(address))).collect::<Vec<_>>()
            };
            assert_eq!(labels(&ours), labels(&theirs), "{path}");
            assert_eq!(lines(&ours), lines(&theirs), "{path}");
            assert!(!lines(&ours).is_empty(), "{path}");
            compared += 1;
        }
    }
    assert_eq!(compared, 7);
}
