//! SPU programs that fail. Each becomes an error that names the SPU that failed, where and why, and
//! no incomplete picture is presented as complete.

use std::time::Instant;

use crate::prelude::*;
use cellray::framebuffer::PictureFile;
use spu_build::{Image, Tools};

/// Assembles a program with `body` as its frame loop, which starts after the program has taken a
/// mail.
fn program(body: &str) -> Program {
    let taking = "        rdch $3,$SPU_RdInMbox\n        rdch $4,$SPU_RdInMbox\n        or $5,$3,$4\n        \
                  brz $5,quit\n";
    assemble(&format!("{taking}{body}\n        br _start\nquit:\n        stop 0x2000\n"))
}

/// Assembles a program from these instructions.
fn assemble(source: &str) -> Program {
    let folder = tempfile::tempdir().unwrap();
    let source = format!(
        "        .include \"work_unit.inc\"\n        .text\n        .global _start\n_start:\n{source}"
    );
    fs::write(folder.path().join("fault.s"), source).unwrap();
    let script = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/suite/frames/program.ld");
    let elf = folder.path().join("fault.elf");
    Image::from_folder(folder.path(), &script)
        .and_then(|image| {
            let image = image.constants();
            image.build(&Tools::find()?, folder.path(), &elf)
        })
        .unwrap();
    let image = fs::read(elf).unwrap().leak();
    // SAFETY: the image comes from the linker.
    unsafe { Program::from_elf(image) }
}

/// How long SPUs may be silent in programs that are never silent for long. The machine may be busy
/// with other things.
const PATIENCE: Duration = Duration::from_secs(600);

/// Renders with a program that fails, and returns the error. Checks that nothing was presented,
/// and, if SPUs are lost, that the engine refuses another frame and can be dropped without them.
fn render(body: &str, timeout: Duration) -> EngineError {
    render_with(program(body), timeout)
}

fn render_with(program: Program, timeout: Duration) -> EngineError {
    let folder = tempfile::tempdir().unwrap();
    let picture = folder.path().join("picture.png");
    let framebuffer = PictureFile::new(&picture, Geometry { width: 64, height: 64 }).unwrap();
    let settings = Settings { spus: 3, timeout, program, ..Settings::default() };
    let mut engine = Engine::start(settings, Box::new(framebuffer)).unwrap();
    let scene = Scene::from_nff(&nff_scene("paper16.nff")).unwrap();
    let error = engine.render(&scene, &mut |_| ()).unwrap_err();
    if let EngineError::Silent { .. } | EngineError::Ended { .. } = error {
        let again = engine.render(&scene, &mut |_| ()).unwrap_err();
        assert!(matches!(again, EngineError::Lost), "{again}");
    }
    drop(engine);
    let left: Vec<_> = fs::read_dir(folder.path()).unwrap().collect();
    assert!(left.is_empty(), "{left:?} is left of an incomplete picture");
    error
}

fn check(body: &str, parts: &[&str]) {
    let error = render(body, PATIENCE);
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
fn unknown_stop_code_is_an_error() {
    check("        stop 0x1234", &["SPU ", "unknown code 0x1234", "0x00010", "0x00001234"]);
}

#[test]
fn early_exit_is_an_error() {
    check("        stop 0x2007", &["exited with code 7"]);
}

#[test]
fn halt_is_an_error() {
    check("        heq $3,$3", &["halt"]);
}

#[test]
fn invalid_instruction_is_an_error() {
    check("        .long 0x00800000", &["invalid instruction"]);
}

#[test]
fn dma_of_invalid_size_is_an_error() {
    let body = format!(
        "{DMA}\n        il $12,24\n        wrch $MFC_Size,$12\n        il $13,0x40\n        wrch $MFC_Cmd,$13"
    );
    check(&body, &["DMA alignment", "0x0008"]);
}

#[test]
fn dma_over_16_kb_is_an_error() {
    let body = format!(
        "{DMA}\n        ila $12,0x8000\n        wrch $MFC_Size,$12\n        il $13,0x40\n        wrch $MFC_Cmd,$13"
    );
    check(&body, &["DMA alignment"]);
}

#[test]
fn unknown_dma_command_is_an_error() {
    let body = format!(
        "{DMA}\n        il $12,16\n        wrch $MFC_Size,$12\n        il $13,0x13\n        wrch $MFC_Cmd,$13"
    );
    check(&body, &["invalid DMA command", "0x0800"]);
}

#[test]
fn dma_to_unmapped_memory_is_an_error() {
    let body = format!(
        "{DMA}\n        il $10,64\n        wrch $MFC_LSA,$10\n        wrch $MFC_EAH,$11\n        \
         wrch $MFC_EAL,$10\n        il $12,16\n        wrch $MFC_Size,$12\n        \
         wrch $MFC_TagID,$11\n        il $13,0x20\n        wrch $MFC_Cmd,$13\n        \
         il $14,1\n        wrch $MFC_WrTagMask,$14\n        il $14,2\n        \
         wrch $MFC_WrTagUpdate,$14\n        rdch $15,$MFC_RdTagStat"
    );
    check(&body, &["unmapped memory", "0x0040"]);
}

const HAS_MAIL: &str = "has not read its mailbox";

/// The message about SPUs that do not reply for this number of seconds.
fn silent_for(seconds: u64, program: Program) -> String {
    let error = render_with(program, Duration::from_secs(seconds));
    assert!(matches!(error, EngineError::Silent { spu: 0, .. }), "{error}");
    let text = error.to_string();
    let begin = format!(
        "SPU 0 has not replied, and for {seconds} s no SPU has taken or finished any work (0 of 4 work units"
    );
    assert!(text.starts_with(&begin) && text.contains("--timeout"), "{text}");
    text
}

/// The message about SPUs that do not reply though they have read their mail. On a machine that
/// is too busy to run them so far, they get twice the time.
fn silence(program: Program) -> String {
    let mut texts = (0..8).map(|power| silent_for(1 << power, program));
    let text = texts.find(|text| !text.contains(HAS_MAIL));
    text.expect("SPUs that read their mail")
}

#[test]
fn sleeping_program_times_out() {
    let text = silence(program("        rdch $5,$SPU_RdSigNotify1"));
    assert!(text.contains("waited for a channel"), "{text}");
}

#[test]
fn looping_program_times_out() {
    let text = silence(program("        nop\ncircle: nop\n        br circle"));
    // Taking the mail needs four instructions.
    let places = ["was at 0x00014, circle;", "was at 0x00018, circle+0x4;"];
    assert!(places.iter().any(|place| text.contains(place)), "{text}");
}

#[test]
fn mail_ignoring_program_times_out() {
    // The engine can't end it. It sleeps, because an endless loop would keep the processors busy
    // until the last of the other tests has ended.
    let text = silent_for(1, assemble("        rdch $5,$SPU_RdSigNotify1\n"));
    assert!(text.contains(HAS_MAIL), "{text}");
}

/// How long SPUs may be silent while [`SLOWLY`] runs: four seconds longer than they are on a
/// machine that is idle. That is rather the machine's time than theirs, because they sleep.
const UNIT_PATIENCE: Duration = Duration::from_secs(5);

/// Takes six units, each after sleeping for a second by the decrementer, and replies that all is
/// done. It takes longer than [`UNIT_PATIENCE`] in total, but never as long without taking a unit.
const SLOWLY: &str = "
        ila $10,0x1000
        wrch $MFC_LSA,$10
        wrch $MFC_EAH,$3
        wrch $MFC_EAL,$4
        il $11,0
        wrch $MFC_TagID,$11
        il $12,FRAME_SIZE
        wrch $MFC_Size,$12
        il $13,0x40
        wrch $MFC_Cmd,$13
        il $14,1
        wrch $MFC_WrTagMask,$14
        il $14,2
        wrch $MFC_WrTagUpdate,$14
        rdch $15,$MFC_RdTagStat
        lqa $20,0x1000 + (FRAME_unit_counter & -16)
        rotqbyi $20,$20,FRAME_unit_counter & 15
        rotqbyi $21,$20,4
        il $30,6
        il $16,0x20
        wrch $SPU_WrEventMask,$16
        ilhu $31,0x4c1
next:   wrch $SPU_WrDec,$31
        rdch $17,$SPU_RdEventStat
        wrch $SPU_WrEventAck,$17
take:   ila $10,0x2000
        wrch $MFC_LSA,$10
        wrch $MFC_EAH,$20
        wrch $MFC_EAL,$21
        il $13,0xd0
        wrch $MFC_Cmd,$13
        rdch $15,$MFC_RdAtomicStat
        lqa $22,0x2000
        ai $22,$22,1
        stqa $22,0x2000
        wrch $MFC_LSA,$10
        wrch $MFC_EAH,$20
        wrch $MFC_EAL,$21
        il $13,0xb4
        wrch $MFC_Cmd,$13
        rdch $15,$MFC_RdAtomicStat
        brnz $15,take
        ai $30,$30,-1
        brnz $30,next
        il $6,0
        wrch $SPU_WrOutIntrMbox,$6";

#[test]
fn slow_program_is_waited_for() {
    let began = Instant::now();
    let error = render(SLOWLY, UNIT_PATIENCE);
    let incomplete = matches!(error, EngineError::Incomplete { .. });
    assert!(incomplete, "{error}");
    assert!(began.elapsed() > UNIT_PATIENCE, "it was not slow");
}

#[test]
fn unknown_reply_is_an_error() {
    let error = render("        il $6,999\n        wrch $SPU_WrOutIntrMbox,$6", PATIENCE);
    assert!(error.to_string().contains("unknown status 999"), "{error}");
}

#[test]
fn false_completion_is_an_error() {
    let error = render("        il $6,0\n        wrch $SPU_WrOutIntrMbox,$6", PATIENCE);
    assert!(matches!(error, EngineError::Incomplete { traced: 0, wanted: 4096, .. }), "{error}");
}
