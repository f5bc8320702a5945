//! Commands that are programs of their own.

use std::os::unix::fs::symlink;

use crate::command_line::support::text;
use crate::prelude::*;

#[test]
fn commands_run_their_programs() {
    for (command, program, expected) in [
        ("bench", "cellray-bench", "accuracy --seed x y --help\n"),
        ("play", "cellray-play", "play accuracy --seed x y --help\n"),
        ("view", "cellray-play", "view accuracy --seed x y --help\n"),
    ] {
        // Hard links, which must be on the same file system. A program that is being written can't
        // be run.
        let folder = tempfile::tempdir_in(env!("CARGO_TARGET_TMPDIR")).unwrap();
        let elsewhere = tempfile::tempdir().unwrap();
        let cellray = folder.path().join("cellray");
        std::fs::hard_link(env!("CARGO_BIN_EXE_cellray"), &cellray).unwrap();
        let run = || {
            Command::new(&cellray)
                .args([command, "accuracy", "--seed", "x y", "--help"])
                .env("PATH", elsewhere.path())
                .output()
                .unwrap()
        };
        let output = run();
        let err = text(&output.stderr);
        assert!(!output.status.success());
        assert!(err.contains(program) && err.contains("cargo build"), "{err}");
        // First one on PATH, then one in cellray's own folder, which takes precedence.
        symlink("/bin/false", elsewhere.path().join(program)).unwrap();
        assert_eq!(run().status.code(), Some(1));
        symlink("/bin/echo", folder.path().join(program)).unwrap();
        let output = run();
        assert!(output.status.success(), "{}", text(&output.stderr));
        assert_eq!(text(&output.stdout), expected);
    }
}
