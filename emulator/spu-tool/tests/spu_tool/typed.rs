//! Slips in typed commands, and the messages that suggest the right ones.

use std::path::Path;

use super::support::Bench;

/// The message contains all of this.
fn assert_error(bench: &Bench, arguments: &[&str], status: i32, parts: &[&str]) {
    let outcome = bench.spu(arguments);
    assert_eq!(outcome.status, status, "{arguments:?}: {}", outcome.error);
    let error = &outcome.error;
    assert!(parts.iter().all(|part| error.contains(part)), "{arguments:?}: {error}");
}

#[test]
fn a_file_after_an_option_that_takes_it_by_equals() {
    let bench = Bench::new();
    let program = bench.program("calls");
    let program = program.to_str().unwrap();
    for option in ["--stats", "--timing", "--profile", "--trace", "--dump-regs"] {
        let command = format!("spu run {option}=out.json {program} arg");
        let arguments = ["run", option, "out.json", program, "arg"];
        assert_error(&bench, &arguments, 127, &["out.json is no SPU program", &command]);
    }
    // Also if the file exists already.
    bench.write("out.json", "{}");
    let arguments = ["run", "--stats", "out.json", program];
    assert_error(&bench, &arguments, 127, &["spu run --stats=out.json"]);
    let arguments = ["run", "--stats", "out.json"];
    assert_error(&bench, &arguments, 127, &["spu run --stats=out.json PROGRAM"]);
    // A program may follow such an option.
    assert_error(&bench, &["run", "--dump-regs", program], 7, &["$127"]);
}

#[test]
fn wrong_file_type_is_explained() {
    let bench = Bench::new();
    bench.write("kernel.s", "        ai $3,$3,1\n");
    for command in ["run", "debug", "dump"] {
        let arguments = [command, "kernel.s"];
        let parts =
            ["but text", "spu-elf-as kernel.s -o kernel.o", "spu-elf-ld kernel.o -o kernel.elf"];
        assert_error(&bench, &arguments, 126, &parts);
    }
    let program = bench.program("calls");
    let objects = bench.path("objects");
    let object = std::fs::read_dir(&objects).unwrap().next().unwrap().unwrap();
    let object = object.path();
    let object = object.strip_prefix(bench.folder.path()).unwrap_or(&object);
    let parts = ["it is an object", "spu-elf-ld", "spu time"];
    assert_error(&bench, &["run", object.to_str().unwrap()], 126, &parts);
    let this = std::env::current_exe().unwrap();
    let machine = if cfg!(target_arch = "x86_64") { "it is for x86-64" } else { "it is for" };
    assert_error(&bench, &["run", this.to_str().unwrap()], 126, &[machine]);
    bench.write("data", [0, 1, 2]);
    assert_error(&bench, &["run", "data"], 126, &["data: not an ELF file\n"]);
    assert!(Path::new(&program).exists());
}

#[test]
fn a_wrong_word_for_the_right_one() {
    let bench = Bench::new();
    let program = bench.program("calls");
    let program = program.to_str().unwrap();
    assert_error(&bench, &["runn", program], 127, &["'run'"]);
    assert_error(&bench, &["debgu", program], 127, &["'debug'"]);
    assert_error(&bench, &["run", "--timeing", program], 127, &["'--timing'"]);
    let tip = format!("spu run {program}");
    assert_error(&bench, &[program], 127, &[&tip]);
    let parts = ["at-once", "at-last"];
    assert_error(&bench, &["run", "--mfc", "late", program], 127, &parts);
}
