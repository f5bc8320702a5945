//! Building programs and running `spu`.

use std::ffi::OsStr;
use std::fs;
use std::io::Write as _;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use spu_build::for_tests::build;

pub struct Bench {
    pub folder: tempfile::TempDir,
}

pub struct Outcome {
    pub status: i32,
    pub output: String,
    pub error: String,
}

fn programs() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/programs")
}

impl Bench {
    pub fn new() -> Self {
        Self { folder: tempfile::tempdir().unwrap() }
    }

    pub fn path(&self, name: &str) -> PathBuf {
        self.folder.path().join(name)
    }

    pub fn write(&self, name: &str, contents: impl AsRef<[u8]>) -> PathBuf {
        let path = self.path(name);
        fs::write(&path, contents).unwrap();
        path
    }

    pub fn read(&self, name: &str) -> String {
        fs::read_to_string(self.path(name)).unwrap()
    }

    /// Replaces the folder's name, so that the text is the same in every run.
    pub fn without_folder(&self, text: &str) -> String {
        text.replace(self.folder.path().to_str().unwrap(), "FOLDER")
    }

    /// Builds a program of `tests/programs` and returns its path.
    pub fn program(&self, name: &str) -> PathBuf {
        let source = fs::read_to_string(programs().join(format!("{name}.s"))).unwrap();
        self.assemble(name, &source)
    }

    /// Builds a program of a few instructions that start at `_start`.
    pub fn instructions(&self, text: &str) -> PathBuf {
        let source = format!("        .text\n        .global _start\n_start:\n{text}\n");
        self.assemble("program", &source)
    }

    pub fn assemble(&self, name: &str, source: &str) -> PathBuf {
        let sources = self.path(&format!("{name}-sources"));
        fs::create_dir_all(&sources).unwrap();
        fs::write(sources.join(format!("{name}.s")), source).unwrap();
        let script = programs().join("program.ld");
        let image = spu_build::Image::from_folder(&sources, &script).unwrap();
        let program = self.path(&format!("{name}.elf"));
        build(&image.include(&programs()), &program);
        program
    }

    pub fn spu<S: AsRef<OsStr>>(&self, arguments: &[S]) -> Outcome {
        self.spu_with_input(arguments, "")
    }

    pub fn spu_with_input<S: AsRef<OsStr>>(&self, arguments: &[S], input: &str) -> Outcome {
        let mut child = Command::new(env!("CARGO_BIN_EXE_spu"))
            .args(arguments)
            .current_dir(self.folder.path())
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .unwrap();
        // A program that reads nothing may already have ended.
        let _ = child.stdin.take().unwrap().write_all(input.as_bytes());
        let output = child.wait_with_output().unwrap();
        Outcome {
            status: output.status.code().unwrap(),
            output: String::from_utf8_lossy(&output.stdout).into_owned(),
            error: String::from_utf8_lossy(&output.stderr).into_owned(),
        }
    }

    /// Runs a program with options before its name, and checks that it ends with this status.
    pub fn run(&self, options: &[&str], program: &Path, status: i32) -> Outcome {
        let mut arguments: Vec<&OsStr> = vec!["run".as_ref()];
        arguments.extend(options.iter().map(OsStr::new));
        arguments.push(program.as_os_str());
        let outcome = self.spu(&arguments);
        assert_eq!(outcome.status, status, "{}", outcome.error);
        outcome
    }
}

/// Compares with a saved file. `MAKE_REF=1` writes it again.
pub fn assert_golden(name: &str, found: &str) {
    let path = programs().join(name);
    if std::env::var_os("MAKE_REF").is_some() {
        fs::write(&path, found).unwrap();
    }
    let kept = fs::read_to_string(&path).unwrap();
    assert_eq!(found, kept, "{} differs", path.display());
}
