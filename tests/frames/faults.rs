//! SPU programs that go wrong: each becomes an error that says which SPU, where and why, in time, and
//! no picture is passed off as whole.

use std::fs;
use std::path::Path;
use std::time::{Duration, Instant};

use crate::recorder::nff_scene;
use cellray::framebuffer::{Geometry, Png};
use cellray::spe::Program;
use cellray::{Engine, EngineError, Scene, Settings};
use spu_build::{Image, Tools};

/// Assembles a program whose frame loop is `body`: it has taken a mail when it gets there.
fn program(body: &str) -> Program {
    let folder = tempfile::tempdir().unwrap();
    let source = format!(
        "        .text\n        .global _start\n_start:\n        rdch $3,$SPU_RdInMbox\n        \
         rdch $4,$SPU_RdInMbox\n        or $5,$3,$4\n        brz $5,quit\n{body}\n        \
         br _start\nquit:\n        stop 0x2000\n"
    );
    fs::write(folder.path().join("fault.s"), source).unwrap();
    let script = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/frames/program.ld");
    let elf = folder.path().join("fault.elf");
    Image::from_folder(folder.path(), &script)
        .and_then(|image| image.build(&Tools::find()?, folder.path(), &elf))
        .unwrap();
    let image = fs::read(elf).unwrap().leak();
    // SAFETY: the linker made it.
    unsafe { Program::from_elf(image) }
}

/// Renders with a program that goes wrong; gives the error after checking that it came in time and
/// that nothing was written.
fn render(body: &str, timeout: Duration) -> EngineError {
    let folder = tempfile::tempdir().unwrap();
    let picture = folder.path().join("picture.png");
    let framebuffer = Png::new(
        &picture,
        Geometry {
            width: 64,
            height: 64,
        },
    )
    .unwrap();
    let settings = Settings {
        spus: 3,
        timeout,
        program: program(body),
        ..Settings::default()
    };
    let mut engine = Engine::start(settings, Box::new(framebuffer)).unwrap();
    let scene = Scene::from_nff(&nff_scene("paper16.nff")).unwrap();
    let start = Instant::now();
    let error = engine.render(&scene, &mut |_| ()).unwrap_err();
    drop(engine);
    assert!(
        start.elapsed() < timeout + Duration::from_secs(20),
        "{error} took its time"
    );
    let left: Vec<_> = fs::read_dir(folder.path()).unwrap().collect();
    assert!(
        left.is_empty(),
        "{left:?} is left of a picture that never was"
    );
    error
}

fn check(body: &str, parts: &[&str]) {
    let error = render(body, Duration::from_secs(60));
    assert!(matches!(error, EngineError::Ended { .. }), "{error}");
    let text = error.to_string();
    for part in parts {
        assert!(text.contains(part), "no {part:?} in: {text}");
    }
}

const DMA: &str = "
        il $10,0x1000
        wrch $MFC_LSA,$10
        wrch $MFC_EAH,$3
        wrch $MFC_EAL,$4
        il $11,0
        wrch $MFC_TagID,$11";

#[test]
fn an_unknown_stop_code() {
    check(
        "        stop 0x1234",
        &["SPU ", "unknown code 0x1234", "0x00010", "0x00001234"],
    );
}

#[test]
fn an_exit_in_the_middle() {
    check("        stop 0x2007", &["exited with code 7"]);
}

#[test]
fn a_halt() {
    check("        heq $3,$3", &["halt"]);
}

#[test]
fn an_invalid_instruction() {
    check("        .long 0x00800000", &["invalid instruction"]);
}

#[test]
fn a_dma_of_an_impossible_size() {
    let body = format!(
        "{DMA}\n        il $12,24\n        wrch $MFC_Size,$12\n        il $13,0x40\n        wrch $MFC_Cmd,$13"
    );
    check(&body, &["DMA alignment", "0x0008"]);
}

#[test]
fn a_dma_over_16_kb() {
    let body = format!(
        "{DMA}\n        ila $12,0x8000\n        wrch $MFC_Size,$12\n        il $13,0x40\n        wrch $MFC_Cmd,$13"
    );
    check(&body, &["DMA alignment"]);
}

#[test]
fn an_unknown_dma_command() {
    let body = format!(
        "{DMA}\n        il $12,16\n        wrch $MFC_Size,$12\n        il $13,0x13\n        wrch $MFC_Cmd,$13"
    );
    check(&body, &["invalid DMA command", "0x0800"]);
}

#[test]
fn a_dma_to_memory_that_is_not_there() {
    let body = format!(
        "{DMA}\n        il $10,64\n        wrch $MFC_LSA,$10\n        wrch $MFC_EAH,$11\n        \
         wrch $MFC_EAL,$10\n        il $12,16\n        wrch $MFC_Size,$12\n        \
         wrch $MFC_TagID,$11\n        il $13,0x20\n        wrch $MFC_Cmd,$13\n        \
         il $14,1\n        wrch $MFC_WrTagMask,$14\n        il $14,2\n        \
         wrch $MFC_WrTagUpdate,$14\n        rdch $15,$MFC_RdTagStat"
    );
    check(&body, &["memory that is not there", "0x0040"]);
}

#[test]
fn a_program_that_never_answers() {
    let error = render("        rdch $5,$SPU_RdSigNotify1", Duration::from_secs(1));
    assert!(
        matches!(error, EngineError::Silent { spu: 0, .. }),
        "{error}"
    );
    assert_eq!(error.to_string(), "SPU 0 has not answered within 1 s");
}

#[test]
fn an_answer_that_means_nothing() {
    let error = render(
        "        il $6,999\n        wrch $SPU_WrOutIntrMbox,$6",
        Duration::from_secs(60),
    );
    assert!(error.to_string().contains("unknown status 999"), "{error}");
}

#[test]
fn a_program_that_says_done_and_has_done_nothing() {
    let error = render(
        "        il $6,0\n        wrch $SPU_WrOutIntrMbox,$6",
        Duration::from_secs(60),
    );
    assert!(
        matches!(
            error,
            EngineError::Incomplete {
                traced: 0,
                wanted: 4096
            }
        ),
        "{error}"
    );
}
