//! The command line: made-up reports and systems.

use std::fs;
use std::path::Path;
use std::process::{Command, Output};

use clock::results::model;
use console::compare::{compare, facts};
use console::corners::{FACTS, on_each};
use console::report::{CHECKSUM, TITLE};

fn sources() -> &'static Path {
    Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../.."))
}

fn sealed(body: &str) -> String {
    let body = format!("{TITLE}, made up\n{body}");
    format!("{body}{CHECKSUM}{:08x}\n", crc32fast::hash(body.as_bytes()))
}

/// The model's rows and the list of facts, as a console would report them.
fn model_report() -> String {
    let rows = model();
    let rows = rows.iter().map(|row| format!("clock {} {} cycles\n", row.row, row.value));
    let corners = FACTS.lines().map(|fact| format!("corner {fact}\n"));
    rows.chain(corners).collect()
}

#[test]
fn emulator_has_the_results_of_the_list_of_facts() {
    let results = facts().unwrap();
    if std::env::var_os("MAKE_REF").is_some() {
        fs::write(concat!(env!("CARGO_MANIFEST_DIR"), "/corners.txt"), results).unwrap();
        return;
    }
    assert_eq!(results, FACTS, "write it with MAKE_REF=1");
    let names: std::collections::BTreeSet<_> =
        FACTS.lines().map(|fact| fact.split(':').next()).collect();
    assert_eq!(names.len(), FACTS.lines().count(), "each corner has a name of its own");
}

#[test]
fn all_spus_have_the_same_results() {
    let results = on_each(6, std::time::Duration::from_secs(600));
    assert_eq!(results.len(), 6);
    for result in &results {
        assert_eq!(result, &results[0]);
        assert!(result.is_ok());
    }
}

#[test]
fn report_like_the_model_has_no_differences() {
    let found = compare(&sealed(&model_report()), sources(), false).unwrap();
    assert_eq!(found.differences, 0, "{}", found.text);
}

#[test]
fn three_rows_and_two_corners_that_differ_are_found() {
    let mut report = model_report();
    // Those with a published band, and one without.
    for (name, factor) in [("hint", 1.3), ("putlluc", 0.5), ("mail", 2.0)] {
        let value = model().into_iter().find(|row| row.row == name).unwrap().value;
        let line = format!("clock {name} {value} ");
        assert!(report.contains(&line), "{line}");
        report = report.replace(&line, &format!("clock {name} {} ", value * factor));
    }
    let fesd = "fesd of negative denormals: 80000000";
    let start = "FPSCR at the start: 00000000 00000000 00000000 00000000, FPSCR 00000000";
    for (old, new) in
        [(fesd, fesd.replace("80000000", "00000000")), (start, start.replace("FPSCR 0", "FPSCR 1"))]
    {
        assert!(report.contains(old));
        report = report.replace(old, &new);
    }
    let found = compare(&sealed(&report), sources(), false).unwrap();
    assert_eq!(found.differences, 5, "{}", found.text);
    let marked: Vec<_> = found.text.lines().filter(|line| line.starts_with("DIFFERS")).collect();
    assert_eq!(marked.len(), 3);
    for (name, line) in ["hint", "putlluc", "mail"].iter().zip(&marked) {
        assert!(line.contains(name), "{line}");
    }
    // The patch applies to the list of facts.
    let folder = tempfile::tempdir().unwrap();
    let list = folder.path().join("lab/console/corners.txt");
    fs::create_dir_all(list.parent().unwrap()).unwrap();
    fs::write(&list, FACTS).unwrap();
    let patch = folder.path().join("patch");
    let at = found.text.find("--- a/").unwrap();
    let end = found.text.rfind("5 differences").unwrap();
    fs::write(&patch, &found.text[at..end]).unwrap();
    let arguments = ["apply", "--unidiff-zero", "patch"];
    let status = Command::new("git").args(arguments).current_dir(&folder).status().unwrap();
    assert!(status.success(), "{}", found.text);
    let corrected = fs::read_to_string(&list).unwrap();
    assert!(corrected.contains("fesd of negative denormals: 00000000"), "{corrected}");
    assert!(
        corrected.starts_with("FPSCR at the start: 00000000 00000000 00000000 00000000, FPSCR 1")
    );
}

#[test]
fn frames_of_scenes_stand_beside_the_models() {
    let frames = |line: &str| {
        let report = sealed(&format!("frames {line}: 1000000.00 frames/s, 2 frames\n"));
        compare(&report, sources(), true)
    };
    let found = frames("paper1.nff, in memory, 64x36").unwrap();
    assert_eq!(found.differences, 1, "{}", found.text);
    assert!(found.text.starts_with("DIFFERS  paper1.nff"), "{}", found.text);
    for other in ["paper1.nff, vsync, 64x36", "of orrery, in memory, 64x36"] {
        assert_eq!(frames(other).unwrap().differences, 0);
    }
    let refused = |line| frames(line).err().unwrap().to_string();
    assert!(refused("paper1.nff").contains("line 2: no frames of a scene"));
    assert!(refused("none.nff, in memory, 64x36").contains("none.nff"));
    assert!(refused("paper1.nff, in memory, 64").contains("64"));
}

#[test]
fn damaged_reports_are_refused() {
    let whole = sealed(&model_report());
    let refused = |report: &str| compare(report, sources(), false).err().unwrap().to_string();
    assert!(refused("").contains("does not begin with"));
    assert!(refused(&whole.replace("clock hint 17", "clock hint 18")).contains("its checksum is"));
    assert!(refused(&whole[..whole.len() / 2]).contains("its end is missing"));
    assert!(refused(&sealed("clock nothing 1 x\n")).contains("line 2: the model has no such row"));
    assert!(refused(&sealed("clock hint fast\n")).contains("a row without a figure"));
    assert!(refused(&sealed("corner of a table: 0\n")).contains("no such corner"));
}

fn start(root: &Path, options: &[&str], path: Option<&Path>) -> (Output, String) {
    let mut command = Command::new(env!("CARGO_BIN_EXE_cellray-console"));
    command.arg("start").arg("--check").arg("--root").arg(root).args(options);
    if let Some(path) = path {
        let old = std::env::var("PATH").unwrap();
        command.env("PATH", format!("{}:{old}", path.display()));
    }
    let output = command.output().unwrap();
    let text = String::from_utf8_lossy(&output.stderr).into_owned();
    (output, text)
}

/// Writes files, with their folders.
fn system(files: &[(&str, &str)]) -> tempfile::TempDir {
    let root = tempfile::tempdir().unwrap();
    for (path, text) in files {
        let path = root.path().join(path);
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(path, text).unwrap();
    }
    root
}

#[test]
fn start_names_what_is_missing_and_the_command() {
    let (output, text) = start(system(&[]).path(), &[], None);
    assert!(!output.status.success());
    for line in
        ["as root: modprobe spufs", "there is no /dev/fb0", "as root: mkdir -p /spu && mount"]
    {
        assert!(text.contains(line), "no {line:?} in {text}");
    }
    let root = system(&[
        ("proc/filesystems", "nodev\tspufs\n"),
        ("proc/self/mounts", "none /spu spufs rw 0 0\n"),
        ("proc/meminfo", "MemTotal: 200000 kB\nMemAvailable: 20480 kB\n"),
        ("spu/context", ""),
        ("sys/devices/system/spu/spu0/x", ""),
        ("sys/devices/system/spu/spu1/x", ""),
        ("sys/devices/system/spu/power", ""),
        ("dev/input/event0", ""),
        ("dev/fb0", ""),
    ]);
    let (output, text) = start(root.path(), &[], None);
    // A file instead of the framebuffer is the only thing that is left.
    assert!(!output.status.success());
    for line in [
        "ok       spufs is mounted",
        "ok       you may use the SPUs",
        "2 SPEs instead of 6",
        "20 MiB of memory are free",
        "you may use 1 input devices",
    ] {
        assert!(text.contains(line), "no {line:?} in {text}");
    }
    assert_eq!(text.matches("MISSING").count(), 1, "{text}");
}

#[test]
fn fix_runs_the_command_and_looks_again() {
    let root = system(&[("proc/filesystems", "nodev\ttmpfs\n")]);
    let tools = system(&[("modprobe", ""), ("mount", "#!/bin/sh\nexit 32\n")]);
    let known = root.path().join("proc/filesystems");
    let script = format!("#!/bin/sh\necho \"nodev\t$1\" >>{}\n", known.display());
    fs::write(tools.path().join("modprobe"), script).unwrap();
    // Nothing of this machine may be mounted or made.
    fs::write(tools.path().join("mkdir"), "#!/bin/sh\nexit 0\n").unwrap();
    for tool in ["modprobe", "mount", "mkdir"] {
        use std::os::unix::fs::PermissionsExt as _;
        fs::set_permissions(tools.path().join(tool), fs::Permissions::from_mode(0o755)).unwrap();
    }
    let (_, text) = start(root.path(), &["--fix"], Some(tools.path()));
    assert!(text.contains("ok       the kernel has spufs"), "{text}");
    assert!(text.contains("MISSING  spufs is not mounted"), "{text}");
    assert!(text.contains("it failed: exit status: 32"), "{text}");
}
