//! How fast the emulator runs the tracer's own frame: SPU instructions a second on one host
//! thread.
//!
//!     cargo bench --bench frame
//!
//! The instructions are counted once, in timing mode; the time is the processor's, the least of
//! several runs without it, so that a busy machine matters little.

use std::path::Path;
use std::process::Command;

use serde_json::Value;

const RUNS: u32 = 5;
const SCENE: &str = "scenes/paper16.nff";
const SIZE: &str = "640x360";

/// Renders the frame on one SPU; gives the statistics.
fn render(variables: &[(&str, &Path)]) -> Value {
    let output = Command::new(env!("CARGO_BIN_EXE_cellray"))
        .args([
            "render", SCENE, "--size", SIZE, "--spus", "1", "--stats", "-",
        ])
        .envs(variables.iter().copied())
        .current_dir(env!("CARGO_MANIFEST_DIR"))
        .output()
        .expect("cellray runs");
    assert!(
        output.status.success(),
        "{}",
        String::from_utf8_lossy(&output.stderr)
    );
    serde_json::from_slice(&output.stdout).expect("statistics are JSON")
}

/// Processor time, in user mode, of all children that have ended.
fn children_seconds() -> f64 {
    // SAFETY: an all-zero rusage is a valid one.
    let mut usage: libc::rusage = unsafe { std::mem::zeroed() };
    // SAFETY: usage is valid for writing.
    let result = unsafe { libc::getrusage(libc::RUSAGE_CHILDREN, &raw mut usage) };
    assert_eq!(result, 0, "{}", std::io::Error::last_os_error());
    usage.ru_utime.tv_sec as f64 + usage.ru_utime.tv_usec as f64 / 1e6
}

fn main() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let report = folder.path().join("report.json");
    render(&[
        ("LIBSPE2_TIMING", Path::new("1")),
        ("LIBSPE2_REPORT", &report),
    ]);
    let report = std::fs::read(&report).expect("libspe2 wrote its report");
    let report: Value = serde_json::from_slice(&report).expect("the report is JSON");
    let instructions = report["totals"]["instructions"]
        .as_f64()
        .expect("a count of instructions");

    let seconds = (0..RUNS)
        .map(|_| {
            let before = children_seconds();
            render(&[]);
            children_seconds() - before
        })
        .fold(f64::INFINITY, f64::min);
    println!("{SCENE}, {SIZE}, one SPU: {instructions:.0} instructions, {seconds:.3} s");
    println!(
        "{:.0} million instructions a second",
        instructions / seconds / 1e6
    );
}
