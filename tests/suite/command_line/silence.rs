//! SPUs that do not reply: they are reported in time, even if libspe2's clock is slower than ours.

use spu_build::{Image, Tools};

use crate::command_line::support::text;
use crate::prelude::*;

/// Takes its mail and never replies. Two instructions in each cycle make it slow to emulate.
const SILENT: &str = "        .global _start
_start: rdch $3,$SPU_RdInMbox
        rdch $4,$SPU_RdInMbox
circle:
        .rept 200
        nop
        lnop
        .endr
        br circle
";

#[test]
fn timeout_is_host_time_in_simulation() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("silent.s"), SILENT).unwrap();
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let elf = folder.path().join("silent.elf");
    Image::from_folder(folder.path(), &root.join("tests/suite/frames/program.ld"))
        .and_then(|image| image.build(&Tools::find()?, folder.path(), &elf))
        .unwrap();

    // On a machine that is too busy to run the SPUs so far, they get twice the time.
    for seconds in (0..8).map(|power| 1 << power) {
        let report = folder.path().join("report.json");
        let output = Command::new(env!("CARGO_BIN_EXE_cellray"))
            .current_dir(root)
            .env("LIBSPE2_TIMING", "1")
            .env("LIBSPE2_REPORT", &report)
            .args(["render", "scenes/paper16.nff", "--size", "160x90", "--out", "none"])
            .args(["--timeout", &seconds.to_string(), "--program"])
            .arg(&elf)
            .output()
            .unwrap();
        let err = text(&output.stderr);
        assert_eq!(output.status.code(), Some(1), "{err}");
        let begin = format!("SPU 0 has not replied, and for {seconds} s");
        assert!(err.contains(&begin), "no {begin:?} in: {err}");
        if err.contains("has not read its mailbox") {
            continue;
        }
        assert!(err.contains(", circle"), "{err}");
        let report: serde_json::Value = serde_json::from_slice(&fs::read(report).unwrap()).unwrap();
        let simulated = report["seconds"].as_f64().unwrap();
        assert!(simulated < f64::from(seconds), "{simulated} s were simulated");
        return;
    }
    panic!("the SPUs do not read their mail");
}
