//! SPUs that do not answer: they are reported in time, even if libspe2 counts time by a clock that
//! is slower than ours.

use std::fs;
use std::path::Path;
use std::process::Command;
use std::time::{Duration, Instant};

use spu_build::{Image, Tools};

use crate::command_line::support::text;

/// Takes its mail and never answers. Two instructions in each cycle make it slow to emulate.
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
fn the_time_allowed_is_the_hosts_where_time_is_simulated() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("silent.s"), SILENT).unwrap();
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let elf = folder.path().join("silent.elf");
    Image::from_folder(folder.path(), &root.join("tests/suite/frames/program.ld"))
        .and_then(|image| image.build(&Tools::find()?, folder.path(), &elf))
        .unwrap();

    let start = Instant::now();
    let output = Command::new(env!("CARGO_BIN_EXE_cellray"))
        .current_dir(root)
        .env("LIBSPE2_TIMING", "1")
        .args(["render", "scenes/paper16.nff", "--size", "160x90"])
        .args(["--timeout", "1", "--program"])
        .arg(&elf)
        .output()
        .unwrap();
    let took = start.elapsed();
    let err = text(&output.stderr);
    assert_eq!(output.status.code(), Some(1), "{err}");
    let parts = ["SPU 0 has not answered, and for 1 s", ", circle"];
    for part in parts {
        assert!(err.contains(part), "no {part:?} in: {err}");
    }
    assert!(took < Duration::from_secs(20), "it took {took:?}");
}
