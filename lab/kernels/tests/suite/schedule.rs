//! Every kernel that is shipped has a schedule in the repository. It equals the scheduler's
//! present output, and its notes and its header are right.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

use kernels::set::Kernels;
use kernels::source::Source;
use kernels::workshop::{Workshop, WorkshopError};
use spu_isa::{Instruction, Target};
use spu_scheduler::code::Code;

#[test]
fn scheduled_versions_are_up_to_date() {
    let workshop = Workshop::here().unwrap_or_else(|error| panic!("{error}"));
    let sources = workshop.sources().expect("kernels");
    workshop.check(&sources).unwrap_or_else(|error| panic!("{error}"));
}

#[test]
fn every_schedule_is_that_of_a_kernel() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let kernels = Kernels::here().unwrap_or_else(|error| panic!("{error}"));
    let known = kernels.sources.iter().filter_map(Source::scheduled_file);
    let known: BTreeSet<String> = known.collect();
    let mut found = BTreeSet::new();
    for room in fs::read_dir(root.join("spu/scheduled")).expect("a folder") {
        for file in fs::read_dir(room.expect("a room").path()).expect("a room") {
            let path = file.expect("a file").path();
            let path = path.strip_prefix(&root).expect("below the root");
            found.insert(path.display().to_string());
        }
    }
    assert_eq!(found, known);
}

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
    let first = lines.next().expect("a header says what is used");
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
fn missing_and_changed_versions_are_stale() {
    let folder = with_includes();
    let here = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let names = ["list_pairs_p64", "mask_pairs_p64", "pack_r16"];
    let kernels = names.map(|name| *Source::find(name).expect("a kernel"));
    let scheduled_file = |kernel: &Source| kernel.scheduled_file().expect("it is shipped");
    for kernel in &kernels {
        for file in [kernel.file.to_owned(), scheduled_file(kernel)] {
            let to = folder.path().join(&file);
            fs::create_dir_all(to.parent().expect("a folder")).expect("made");
            fs::copy(here.join(&file), to).expect("copied");
        }
    }
    let workshop = Workshop::new(folder.path(), &folder.path().join("made")).expect("a workshop");
    workshop.check(&kernels).expect("all as they are here");

    let [gone, changed, _] = kernels.map(|kernel| folder.path().join(scheduled_file(&kernel)));
    let text = fs::read_to_string(&changed).expect("a kernel");
    fs::remove_file(gone).expect("removed");
    fs::write(&changed, text.replacen("# 1e", "# 2e", 1)).expect("written");
    let error = workshop.check(&kernels).expect_err("two are stale");
    let WorkshopError::Stale(files) = &error else {
        panic!("{error}");
    };
    assert_eq!(*files, kernels[..2].iter().map(scheduled_file).collect::<Vec<_>>());
    let notes = workshop.notes(&kernels[1]).expect("notes");
    assert_eq!(notes.differences.len(), 1, "{:?}", notes.differences);

    workshop.write(&kernels).expect("written anew");
    workshop.check(&kernels).expect("up to date");
    assert_eq!(fs::read_to_string(&changed).expect("a kernel"), text);
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
    let workshop = Workshop::new(folder.path(), &made).expect("a workshop");
    let missing = workshop.schedule(&kernel).expect_err("there is none");
    assert!(matches!(missing, WorkshopError::File { .. }), "{missing}");
    fs::create_dir_all(file.parent().expect("a folder")).expect("made");
    fs::write(&file, "        ai      $3,$3,5000\n").expect("written");
    let refused = workshop.schedule(&kernel).expect_err("out of range");
    assert!(matches!(refused, WorkshopError::Build(_)), "{refused}");
    assert!(refused.to_string().contains("pack_r16.s"), "{refused}");
    fs::write(&file, "        ai      $3,$3,5\n").expect("written");
    let refused = workshop.schedule(&kernel).expect_err("no function");
    assert!(matches!(refused, WorkshopError::Scheduler { .. }), "{refused}");
}

#[test]
fn a_changed_include_costs_those_that_include_it() {
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
        let folders =
            fs::read_dir(&made).expect("a folder").map(|entry| entry.expect("a folder").path());
        folders.filter(|folder| folder.join(name).is_file()).count()
    };
    for (text, times) in [("# one\n", 1), ("# another\n", 2), ("# one\n", 2)] {
        fs::write(includes.join("further.inc"), text).expect("written");
        let workshop = Workshop::new(folder.path(), &made).expect("a workshop");
        workshop.schedules(&kernels).expect("schedules");
        let found = ["list_pairs_p64.json", "pack_r16.json"].map(kept);
        assert_eq!(found, [times, 1], "{text}");
    }
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
