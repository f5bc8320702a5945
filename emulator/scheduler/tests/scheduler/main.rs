//! Tests the static analyser on programs of the SPU assembler: functions, loops, notes.
//!
//! Provenance: `model`. The notes in `saxpy.s` were derived on paper.

use std::fs;
use std::path::{Path, PathBuf};

use spu_isa::timing::{Cause, Rules, find_loops};
use spu_scheduler::check::{self, CheckError, Model, Outcome};
use spu_scheduler::code::{Code, CodeError};

fn folder(program: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/programs").join(program)
}

/// Builds `tests/programs/<program>`, and returns this file of the work folder.
fn build(program: &str, file: &str) -> Vec<u8> {
    let work = tempfile::tempdir().unwrap();
    let script = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../linker/spu.ld");
    let image = spu_build::Image::from_folder(&folder(program), &script).unwrap();
    spu_build::for_tests::build(&image, &work.path().join("program"));
    fs::read(work.path().join(file)).unwrap()
}

fn program(name: &str) -> Code {
    Code::parse(&build(name, "program")).unwrap()
}

fn object(name: &str) -> Code {
    Code::parse(&build(name, &format!("objects/00-{name}.o"))).unwrap()
}

#[test]
fn a_pipelined_loop_reaches_what_its_notes_say() {
    let code = program("saxpy");
    let function = &code.functions()[0];
    let loops = find_loops(&code.words(function.start, function.end), Rules::default());
    let [found] = &loops[..] else { panic!("{loops:?}") };
    // Eight groups of one even and one odd instruction, but r1 is ready one cycle after its store
    // could issue.
    assert_eq!((found.even, found.odd), (8, 8));
    let steady = found.steady.as_ref().unwrap();
    assert_eq!(steady.passes, 1);
    assert_eq!(steady.account.cycles(), 9);
    assert_eq!(steady.account.stalled(), 0);
    assert_eq!((steady.account.dual(), steady.account.single()), (7, 2));
    // The pointers and the counter advance by one `ai` each: latency 2.
    let recurrence = found.recurrence.as_ref().unwrap();
    assert_eq!((recurrence.cycles, recurrence.passes), (2, 1));
    // ai py, then a load of it in the same pass? No: the loads come first. fma, then its store.
    assert_eq!(found.critical_path, 7);
    assert_eq!(found.bound(), 8);
}

#[test]
fn without_its_hint_the_loop_misses_each_time() {
    let code = program("saxpy");
    let function = &code.functions()[0];
    let unhinted = Rules { hints: false, ..Rules::default() };
    let loops = find_loops(&code.words(function.start, function.end), unhinted);
    let steady = loops[0].steady.as_ref().unwrap();
    assert_eq!(steady.account.cycles(), 9 + 18);
    assert_eq!(steady.account.waited(Cause::BranchMiss), 18);
}

#[test]
fn code_without_sizes_is_split_at_global_symbols() {
    let code = program("hints");
    let names: Vec<_> = code.functions().iter().map(|f| f.name.as_str()).collect();
    assert_eq!(names, ["_start", "second"]);
}

fn notes(code: &Code, name: &str, edit: impl Fn(String) -> String) -> Outcome {
    let path = folder(&format!("{name}/{name}.s"));
    let text = edit(fs::read_to_string(&path).unwrap());
    check::check(code, &[(path, text)], Rules::default()).unwrap()
}

#[test]
fn right_notes_pass_in_programs_and_objects() {
    for code in [program("saxpy"), object("saxpy")] {
        let outcome = notes(&code, "saxpy", |text| text);
        assert_eq!(outcome.differences, []);
        assert_eq!(outcome.notes, 25);
    }
}

#[test]
fn the_sections_of_an_object_are_laid_out() {
    for code in [program("sections"), object("sections")] {
        let outcome = notes(&code, "sections", |text| text);
        assert_eq!((outcome.notes, &outcome.differences[..]), (6, &[][..]));
        let names: Vec<_> = code.functions().iter().map(|f| f.name.as_str()).collect();
        assert_eq!(names, ["_start", "other"]);
        // The branch to `other` goes back, even if only a relocation shows that.
        let other = &code.functions()[1];
        let loops = find_loops(&code.words(other.start, other.end), Rules::default());
        assert_eq!(loops.len(), 1);
        assert_eq!((loops[0].start, loops[0].branch), (other.start, other.start + 8));
    }
}

#[test]
fn wrong_notes_are_named() {
    let code = program("saxpy");
    let outcome =
        notes(&code, "saxpy", |text| text.replace("# 6o", "# 5o").replace("# 3e", "# 3o"));
    let shown: Vec<_> = outcome.differences.iter().map(ToString::to_string).collect();
    let file = folder("saxpy/saxpy.s");
    let file = file.display();
    assert_eq!(
        shown,
        [format!("{file}:38: note 3o, model 3e"), format!("{file}:45: note 5o, model 6o"),]
    );
}

#[test]
fn notes_without_an_instruction_are_reported() {
    let outcome = notes(&program("macros"), "macros", |text| text);
    let models: Vec<_> = outcome
        .differences
        .iter()
        .map(|difference| (difference.line, difference.model.clone()))
        .collect();
    assert_eq!(outcome.notes, 4);
    assert_eq!(
        models,
        [(11, Model::Several(2)), (12, Model::NoInstruction), (15, Model::Unknown),]
    );
}

#[test]
fn a_source_that_is_not_in_the_table_is_an_error() {
    let code = program("saxpy");
    let path = PathBuf::from("elsewhere.s");
    let outcome = check::check(&code, &[(path.clone(), String::new())], Rules::default());
    assert_eq!(outcome, Err(CheckError::NotInTable(path)));
    assert_eq!(check::source_files(&code), [folder("saxpy/saxpy.s")]);
}

#[test]
fn file_of_another_format_is_an_error() {
    assert!(matches!(Code::parse(b"no"), Err(CodeError::Elf(_))));
    let mut image = build("straight", "program");
    // e_machine is at offset 18, big-endian.
    image[19] = 20;
    assert!(matches!(Code::parse(&image), Err(CodeError::Machine(20))));
}
