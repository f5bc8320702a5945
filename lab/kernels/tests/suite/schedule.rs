//! The schedules of kernels: their notes and their headers are right, and an edit costs no more than
//! the kernels that it concerns.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

use kernels::set::Kernels;
use kernels::source::Source;
use kernels::workshop::{Workshop, WorkshopError};
use spu_build::{Error, Schedules};
use spu_isa::{Instruction, Target};
use spu_scheduler::code::Code;

#[test]
fn notes_agree_with_the_model() {
    let workshop = Workshop::here().unwrap_or_else(|error| panic!("{error}"));
    for kernel in &workshop.sources().expect("kernels") {
        let outcome = workshop.notes(kernel);
        let outcome = outcome.unwrap_or_else(|error| panic!("{error}"));
        assert!(outcome.notes > 0, "{}: no notes", kernel.name);
        let wrong: Vec<String> = outcome.differences.iter().map(ToString::to_string).collect();
        assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    }
}

#[test]
fn headers_name_the_registers_that_are_written() {
    let workshop = Workshop::here().unwrap_or_else(|error| panic!("{error}"));
    let kernels = Kernels::here().unwrap_or_else(|error| panic!("{error}"));
    let code = Code::parse(kernels.scheduled).expect("an image");
    let functions = code.functions();
    for kernel in &kernels.sources {
        let text = workshop.schedule(kernel).expect("a schedule").text;
        let mut functions = functions.iter();
        let function = functions.find(|function| function.name == kernel.name);
        let function = function.expect("a function");
        let words = code.words(function.start, function.end);
        let written: BTreeSet<u8> = words
            .iter()
            .filter_map(|&(_, word)| Instruction::decode(word))
            .filter(|i| i.op.row().target == Target::Rt)
            .map(|i| i.rt)
            .collect();
        assert_eq!(used(&text), written, "{}", kernel.name);
    }
}

/// The registers that a header's `Uses` lists.
fn used(source: &str) -> BTreeSet<u8> {
    let lines = source.lines().take_while(|line| line.starts_with('#'));
    let mut lines = lines.skip_while(|line| !line.starts_with("#   Uses "));
    let first = lines.next().expect("a header lists the registers used");
    let further = lines.take_while(|line| line.starts_with("#           "));
    let text: Vec<&str> = std::iter::once(first).chain(further).collect();
    let text = text.join(" ");
    let list = text.trim_start_matches("#   Uses").trim_start();
    let list = list.split("   Saves").next().expect("a list");
    let number = |text: &str| text.trim().trim_start_matches('$').parse::<u8>();
    let words = list.split([',', '#']).map(str::trim).filter(|word| !word.is_empty());
    words
        .flat_map(|range| {
            let (first, last) = range.split_once('-').unwrap_or((range, range));
            number(first).expect("a register")..=number(last).expect("a register")
        })
        .collect()
}

#[test]
fn a_plain_source_with_a_fault_is_named() {
    let folder = tempfile::tempdir().expect("a folder");
    let kernel = *Source::find("pack_r16").expect("a kernel");
    let file = folder.path().join(kernel.file);
    for includes in ["spu/include", "lab/spu/include"] {
        fs::create_dir_all(folder.path().join(includes)).expect("made");
    }
    let made = folder.path().join("made");
    let workshop = workshop(folder.path(), &made);
    let missing = workshop.schedule(&kernel).expect_err("there is none");
    assert!(matches!(missing, WorkshopError::Build(Error::File { .. })), "{missing}");
    fs::create_dir_all(file.parent().expect("a folder")).expect("made");
    fs::write(&file, "        ai      $3,$3,5000\n").expect("written");
    let refused = workshop.schedule(&kernel).expect_err("out of range");
    assert!(matches!(refused, WorkshopError::Build(Error::Failed { .. })), "{refused}");
    assert!(refused.to_string().contains("pack_r16.s"), "{refused}");
    fs::write(&file, "        ai      $3,$3,5\n").expect("written");
    let refused = workshop.schedule(&kernel).expect_err("no function");
    assert!(matches!(refused, WorkshopError::Build(Error::Scheduler { .. })), "{refused}");
}

#[test]
fn changed_include_reschedules_its_includers() {
    let folder = with_includes();
    let here = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let includes = folder.path().join("spu/include");
    let kernels = ["list_pairs_p64", "pack_r16"].map(|name| *Source::find(name).expect("a kernel"));
    for kernel in &kernels {
        let to = folder.path().join(kernel.file);
        fs::create_dir_all(to.parent().expect("a folder")).expect("made");
        fs::copy(here.join(kernel.file), to).expect("copied");
    }
    let lists = fs::read_to_string(includes.join("lists.inc")).expect("an include");
    fs::write(includes.join("lists.inc"), lists + "        .include \"further.inc\"\n")
        .expect("written");

    let made = folder.path().join("made");
    let kept = |name: &str| {
        let entries = fs::read_dir(&made).expect("a folder");
        let folders = entries.map(|entry| entry.expect("a folder").path());
        folders.filter(|folder| folder.join(name).is_file()).count()
    };
    let register = |number| format!(".set further_register,{number}  # its number is {number}\n");
    let again = format!("# More comments.\n\n{}", register(5).replace("its", "a comment: its"));
    for (text, times) in [(register(5), 1), (register(6), 2), (again, 2)] {
        fs::write(includes.join("further.inc"), &text).expect("written");
        let workshop = workshop(folder.path(), &made);
        for kernel in &kernels {
            workshop.schedule(kernel).expect("a schedule");
        }
        let found = ["list_pairs_p64.s", "pack_r16.s"].map(kept);
        assert_eq!(found, [times, 1], "{text}");
    }
}

/// A workshop that keeps its schedules in a folder of its own.
fn workshop(root: &Path, made: &Path) -> Workshop {
    let keep = |tools: &_, includes: &[_]| Ok(Schedules::kept_in(made, tools, includes));
    Workshop::new(root, &made.join("constants"), keep).expect("a workshop")
}

/// A folder of a repository with only the files that sources include.
fn with_includes() -> tempfile::TempDir {
    let folder = tempfile::tempdir().expect("a folder");
    let here = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    for includes in ["spu/include", "lab/spu/include"] {
        copy(&here.join(includes), &folder.path().join(includes));
    }
    folder
}

fn copy(from: &Path, to: &Path) {
    fs::create_dir_all(to).expect("made");
    for entry in fs::read_dir(from).expect("a folder") {
        let entry = entry.expect("a file");
        fs::copy(entry.path(), to.join(entry.file_name())).expect("copied");
    }
}
