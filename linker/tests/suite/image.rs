//! Builds images and checks the results and the error messages.
//!
//! The variables that name tools belong to the process, so the tests that set them run this test
//! program again as a child.

use std::fs;
use std::os::unix::fs::PermissionsExt as _;
use std::path::{Path, PathBuf};
use std::process::Command;

use object::{Object as _, ObjectSection as _, ObjectSymbol as _};
use spu_build::{Error, Image, Tools, stub, tracer};

const SCRIPT: &str =
    "OUTPUT_FORMAT(\"elf32-spu\")\nENTRY(_start)\nSECTIONS { . = 0; .text : { *(.text) } }\n";

fn folder(source: &str) -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("program.s"), source).unwrap();
    fs::write(folder.path().join("script.ld"), SCRIPT).unwrap();
    folder
}

fn build(folder: &Path, tools: &Tools) -> Result<PathBuf, Error> {
    let elf = folder.join("out.elf");
    Image::from_folder(folder, &folder.join("script.ld"))?.build(
        tools,
        &folder.join("work"),
        &elf,
    )?;
    Ok(elf)
}

fn failure(source: &str) -> String {
    build(folder(source).path(), &Tools::find().unwrap()).unwrap_err().to_string()
}

#[test]
fn program_is_linked_as_spu_executable() {
    let folder = folder(" .text\n .global _start\n_start:\n il $3,1\nlast:\n stop 0x2000\n");
    let elf = fs::read(build(folder.path(), &Tools::find().unwrap()).unwrap()).unwrap();
    let elf = object::File::parse(&*elf).unwrap();
    assert!(!elf.is_little_endian());
    let last = elf.symbols().find(|symbol| symbol.name() == Ok("last")).unwrap();
    assert_eq!(last.address(), 4);
}

#[test]
fn source_error_has_file_line_and_command() {
    let text = failure(" .text\n il $3,99999\n");
    assert!(text.contains("program.s:2") && text.contains("--fatal-warnings"), "{text}");
    let text = failure(" .text\n bogus $3\n");
    assert!(text.contains("program.s:2") && text.contains("bogus"), "{text}");
}

#[test]
fn warning_is_error() {
    // For an operand outside the useful range, the assembler only warns.
    let text = failure(" .text\n shli $3,$4,70\n");
    assert!(text.contains("program.s:2"), "{text}");
}

#[test]
fn undefined_symbol_is_a_linker_error() {
    let text = failure(" .text\n .global _start\n_start:\n brsl $0,nowhere\n");
    assert!(text.contains("nowhere"), "{text}");
}

#[test]
fn folder_without_sources_is_an_error() {
    let empty = tempfile::tempdir().unwrap();
    let error = build(empty.path(), &Tools::find().unwrap()).unwrap_err();
    assert!(matches!(error, Error::NoSources(_)), "{error}");
}

/// Runs the test below in a child with its own variables, and returns the output.
fn find_with(variables: &[(&str, &str)]) -> String {
    let mut child = Command::new(std::env::current_exe().unwrap());
    child.args(["--exact", "image::child_finds_tools", "--nocapture"]).env("IN_CHILD", "1");
    child.env_remove("SPU_AS").env_remove("SPU_LD");
    for (name, value) in variables {
        child.env(name, value);
    }
    String::from_utf8(child.output().unwrap().stdout).unwrap()
}

#[test]
fn child_finds_tools() {
    if std::env::var_os("IN_CHILD").is_some() {
        match Tools::find() {
            Ok(tools) => {
                println!("{tools:?}");
                if let Some(folder) = std::env::var_os("BUILD") {
                    build(Path::new(&folder), &tools).unwrap();
                    println!("built");
                }
            }
            Err(error) => println!("{error}"),
        }
    }
}

#[test]
fn missing_tools_are_named_with_the_remedy() {
    let none = [("PATH", "/nonexistent"), ("XDG_CACHE_HOME", "/nonexistent/cache")];
    let text = find_with(&none);
    for part in ["no SPU assembler", "spu-elf-as", "/nonexistent/cache", "ci/setup", "SPU_AS"] {
        assert!(text.contains(part), "no {part:?} in: {text}");
    }
    let text = find_with(&[("SPU_AS", "/nonexistent/spu-as")]);
    assert!(text.contains("SPU_AS=/nonexistent/spu-as"), "{text}");
}

#[test]
fn tools_are_taken_from_path_under_either_name() {
    for name in ["spu-elf", "spu"] {
        let bin = tempfile::tempdir().unwrap();
        for tool in ["as", "ld"] {
            fs::write(bin.path().join(format!("{name}-{tool}")), "").unwrap();
        }
        let text = find_with(&[("PATH", bin.path().to_str().unwrap())]);
        assert!(text.contains(&format!("{}/{name}-as", bin.path().display())), "{text}");
    }
}

/// A compiler driver can replace both tools, on `PATH` or named by the variables. This one handles
/// `-Wa,` and `-Wl,` like gcc and calls the real tools.
#[test]
fn compiler_driver_assembles_and_links() {
    const DRIVER: &str = r#"#!/bin/sh
tool=$LD
for argument do
    shift
    case $argument in
    -c) tool=$AS ;;
    -nostdlib) ;;
    -Wa,*|-Wl,*) set -- "$@" "${argument#-W?,}" ;;
    *) set -- "$@" "$argument" ;;
    esac
done
exec "$tool" "$@"
"#;
    let real = find_with(&[]);
    let paths: Vec<&str> = real.split('"').filter(|word| word.starts_with('/')).collect();
    let [assembler, linker] = paths[..] else { panic!("{real}") };

    let bin = tempfile::tempdir().unwrap();
    let driver = bin.path().join("spu-gcc");
    fs::write(&driver, DRIVER).unwrap();
    fs::set_permissions(&driver, fs::Permissions::from_mode(0o755)).unwrap();
    let driver = driver.to_str().unwrap();
    let program = folder(" .text\n .global _start\n_start:\n stop 0x2000\n");
    for tools in [
        [("SPU_AS", driver), ("SPU_LD", driver)],
        [("PATH", bin.path().to_str().unwrap()), ("XDG_CACHE_HOME", "/nonexistent")],
    ] {
        let folder = program.path().to_str().unwrap();
        let text = find_with(
            &[&tools[..], &[("AS", assembler), ("LD", linker), ("BUILD", folder)]].concat(),
        );
        assert!(text.contains("spu-gcc") && text.contains("built"), "{text}");
        fs::remove_file(program.path().join("out.elf")).unwrap();
    }
}

#[test]
fn stub_has_its_soname_and_its_names() {
    let folder = tempfile::tempdir().unwrap();
    let library = folder.path().join("libthing.so");
    let names = stub::names("# a list\nthing_one\nthing_two # the second\n\n");
    assert_eq!(names, ["thing_one", "thing_two"]);
    stub::build(Path::new("cc"), "libthing.so.7", &names, &library).unwrap();
    let bytes = fs::read(library).unwrap();
    let library = object::File::parse(&*bytes).unwrap();
    let exported: Vec<_> =
        library.dynamic_symbols().filter_map(|symbol| symbol.name().ok()).collect();
    assert!(exported.contains(&"thing_one") && exported.contains(&"thing_two"), "{exported:?}");
    assert!(bytes.windows(13).any(|window| window == b"libthing.so.7"));
}

#[test]
fn tracer_takes_further_shaders() {
    let folder = tempfile::tempdir().unwrap();
    let source = folder.path().join("own.s");
    let elf = folder.path().join("tracer.elf");
    let shader = "\t.include \"macros.inc\"\n\t.include \"shader.inc\"\nshader own\n\tbi $lr\nendshader own\n";
    fs::write(&source, shader).unwrap();
    let build = || {
        let image = tracer().unwrap().folder(folder.path()).unwrap();
        image.build(&Tools::find().unwrap(), &folder.path().join("work"), &elf)
    };
    build().unwrap_or_else(|error| panic!("{error}"));
    let image = fs::read(&elf).unwrap();
    let image = object::File::parse(&*image).unwrap();
    let table = image.section_by_name(".shaders").unwrap().data().unwrap();
    let names: Vec<&[u8]> = table.chunks(32).map(|entry| &entry[16..]).collect();
    let padded = |name: &[u8]| [name, &[0; 16][name.len()..]].concat();
    let expected = ["checker", "depth", "own", "portal", "sky"];
    assert_eq!(names, expected.map(|name| padded(name.as_bytes())));
    let symbol = image.symbols().find(|s| s.name() == Ok("shader_own")).unwrap();
    let address = u32::from_be_bytes(table[64..68].try_into().unwrap());
    assert_eq!(u64::from(address), symbol.address());

    // A shader that is too large.
    fs::write(&source, shader.replace("\tbi", "\t.skip 0x40000\n\tbi")).unwrap();
    let text = build().unwrap_err().to_string();
    assert!(text.contains("too large for the local store"), "{text}");
    // Two shaders with the same name, and a name that is too long.
    fs::write(&source, shader.replace("own", "depth")).unwrap();
    let text = build().unwrap_err().to_string();
    assert!(text.contains("multiple definition of `shader_depth'"), "{text}");
    fs::write(&source, shader.replace("own", "sixteen_and_a_bit")).unwrap();
    let text = build().unwrap_err().to_string();
    assert!(text.contains("at most 16 characters"), "{text}");
}
