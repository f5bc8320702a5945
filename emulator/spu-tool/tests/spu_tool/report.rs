//! Reports on programs of the SPU assembler.
//!
//! Provenance: `model`. The files in `tests/kept` are saved output that was checked by hand.
//! `MAKE_REF=1` writes them again.

use std::env;
use std::fs;
use std::path::{Path, PathBuf};

use spu_isa::timing::{HintDistance, Rules, Verdict};
use spu_scheduler::code::Code;
use spu_tool::report::Report;

pub fn folder(program: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../scheduler/tests/programs").join(program)
}

/// Builds the program of `emulator/scheduler/tests/programs/<program>`, and returns this file of
/// the work folder.
pub fn build(program: &str, file: &str) -> Vec<u8> {
    let work = tempfile::tempdir().unwrap();
    let script = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../linker/spu.ld");
    let image = spu_build::Image::from_folder(&folder(program), &script).unwrap();
    spu_build::for_tests::build(&image, &work.path().join("program"));
    fs::read(work.path().join(file)).unwrap()
}

pub fn program(name: &str) -> Code {
    Code::parse(&build(name, "program")).unwrap()
}

fn kept(file: &str, text: &str) {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/kept").join(file);
    if env::var_os("MAKE_REF").is_some() {
        fs::write(&path, text).unwrap();
    }
    let expected = fs::read_to_string(&path).unwrap();
    assert_eq!(text, expected, "{}", path.display());
}

#[test]
fn listings_are_as_kept() {
    for name in ["saxpy", "straight", "hints"] {
        let code = program(name);
        let report = Report::new(&code, None, Rules::default()).unwrap();
        kept(&format!("{name}.txt"), &report.text());
    }
}

#[test]
fn json_is_as_kept_and_says_what_the_listing_says() {
    let code = program("saxpy");
    let report = Report::new(&code, Some("saxpy"), Rules::default()).unwrap();
    kept("saxpy.json", &report.json());
    let json: serde_json::Value = serde_json::from_str(&report.json()).unwrap();
    let function = &json["functions"][0];
    assert_eq!(function["name"], "saxpy");
    assert_eq!(function["loops"][0]["steady"]["cycles_a_pass"], 9.0);
    assert_eq!(function["instructions"].as_array().unwrap().len(), 25);
}

#[test]
fn one_function_or_none() {
    let code = program("straight");
    let names: Vec<_> = code.functions().iter().map(|f| f.name.as_str()).collect();
    assert_eq!(names, ["_start", "table", "after"]);
    let report = Report::new(&code, Some("after"), Rules::default()).unwrap();
    assert_eq!(report.functions().len(), 1);
    assert!(Report::new(&code, Some("nobody"), Rules::default()).is_none());
}

#[test]
fn a_word_that_is_no_instruction_leaves_no_total() {
    let code = program("straight");
    let report = Report::new(&code, Some("table"), Rules::default()).unwrap();
    let schedule = &report.functions()[0].schedule;
    assert_eq!(schedule.account, None);
    assert!(schedule.lines[0].issued.is_none());
    assert!(report.text().contains("no total"));
}

#[test]
fn hints_are_measured_to_their_branches() {
    let code = program("hints");
    let report = Report::new(&code, Some("_start"), Rules::default()).unwrap();
    let hint = |address, branch, instructions, cycles, verdict| HintDistance {
        address,
        branch,
        instructions,
        cycles,
        verdict,
    };
    // One instruction a cycle, because all are odd: n instructions between take n + 1 cycles.
    assert_eq!(
        report.functions()[0].hints,
        [
            hint(0x00, 0x20, 7, 8, Verdict::NotSeen),
            hint(0x24, 0x48, 8, 9, Verdict::Waits(7)),
            hint(0x4c, 0x88, 14, 15, Verdict::Waits(1)),
            hint(0x8c, 0xd0, 16, 17, Verdict::Replaced(0x90)),
        ]
    );
}

#[test]
fn damaged_files_do_no_harm() {
    for name in ["saxpy", "macros"] {
        for of in ["program".to_owned(), format!("objects/00-{name}.o")] {
            let whole = build(name, &of);
            let mut seed = 1u32;
            for _ in 0..randomness::rounds(1000) {
                let mut damaged = whole.clone();
                for _ in 0..4 {
                    seed = seed.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
                    let at = seed as usize / 7 % damaged.len();
                    damaged[at] = (seed >> 24) as u8;
                }
                if seed & 15 == 0 {
                    damaged.truncate(seed as usize / 31 % damaged.len());
                }
                if let Ok(code) = Code::parse(&damaged) {
                    let report = Report::new(&code, None, Rules::default()).unwrap();
                    assert!(report.json().len() >= report.functions().len());
                    assert!(report.text().len() >= report.functions().len());
                    assert!(report.html(name).ends_with("</html>"));
                }
            }
        }
    }
}
