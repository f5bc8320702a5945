//! The tutorial's text: the code that it shows is in its programs, and the commands that it shows
//! are valid.

use std::fs;
use std::path::{Path, PathBuf};

use crate::program::{BALL, STEER, STRIPES, good};

const TUTORIAL: &str = include_str!("../../../../docs/tutorial.md");

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

/// The code blocks: the file that the line above names in backquotes, and the text.
fn blocks() -> Vec<(String, String)> {
    let mut blocks = Vec::new();
    let mut above = "";
    let mut lines = TUTORIAL.lines();
    while let Some(line) = lines.next() {
        if line.starts_with("```") {
            let text: Vec<_> = lines.by_ref().take_while(|line| *line != "```").collect();
            let file = above.split('`').nth(1).unwrap_or_default();
            blocks.push((file.to_owned(), text.join("\n")));
        }
        if !line.is_empty() {
            above = line;
        }
    }
    blocks
}

#[test]
fn shown_code_is_in_the_programs() {
    let mut shown = Vec::new();
    for (file, text) in blocks() {
        let source = fs::read_to_string(root().join(&file));
        let source = source.unwrap_or_else(|error| panic!("{file}, before {text}: {error}"));
        let source = format!("\n{source}");
        assert!(source.contains(&format!("\n{text}\n")), "{file} has no {text}");
        shown.push(file);
    }
    for file in [
        "src/bin/ball.rs",
        "src/bin/steer.rs",
        "src/bin/stripes.rs",
        "shaders/stripes.s",
        "build.rs",
    ] {
        let file = format!("examples/tutorial/{file}");
        assert!(shown.contains(&file), "{file} is not shown");
    }
}

/// The words of a command line, some of them in single quotes.
fn words(line: &str) -> Vec<&str> {
    line.split_whitespace().map(|word| word.trim_matches('\'')).collect()
}

#[test]
fn shown_commands_are_valid() {
    let folder = tempfile::tempdir().unwrap();
    let mut typed = 0;
    let joined = TUTORIAL.replace("\\\n", "");
    let mut program = None;
    for line in joined.lines() {
        // The game to which the following commands belong.
        if let Some(line) = line.strip_prefix("    cellray new ") {
            program = Some(match words(line)[..] {
                ["ball"] => BALL,
                ["steer", "--template", "steer"] => STEER,
                ["stripes", "--template", "stripes"] => STRIPES,
                ref other => panic!("no game {other:?}"),
            });
        }
        let Some(line) = line.strip_prefix("    cargo run --release") else {
            continue;
        };
        let program = program.expect("a game was made");
        let words = words(line.split(" #").next().unwrap()).into_iter();
        let mut arguments: Vec<_> = words.filter(|word| *word != "--").collect();
        // The tests have no display, and small pictures are enough.
        for option in ["--display", "--size"] {
            if let Some(at) = arguments.iter().position(|word| *word == option) {
                arguments.drain(at..at + 2);
            }
        }
        arguments.extend(["--size", "64x36"]);
        let has = |arguments: &[&str], name| arguments.contains(&name);
        if !has(&arguments, "--out") {
            arguments.extend(["--display", "none"]);
        }
        if !has(&arguments, "--frames") && !has(&arguments, "--replay") {
            arguments.extend(["--frames", "8"]);
        }
        let repository = root();
        let recorded = repository.join("examples/tutorial/played.session");
        for argument in &mut arguments {
            if *argument == "played.session" {
                *argument = recorded.to_str().unwrap();
            }
        }
        good(program, folder.path(), &arguments);
        typed += 1;
    }
    assert!(typed >= 8, "{typed} command lines");
}

#[test]
fn pictures_of_document_exist() {
    let mut seen = 0;
    for part in TUTORIAL.split("](tutorial/").skip(1) {
        let name = part.split(')').next().unwrap();
        let picture = image::open(root().join("docs/tutorial").join(name)).unwrap();
        assert_eq!((picture.width(), picture.height()), (480, 270), "{name}");
        seen += 1;
    }
    assert_eq!(seen, 3);
}
