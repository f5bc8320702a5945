//! Checks that manifests name the libraries without tests or without examples. Cargo otherwise
//! compiles the library a second time for a program without tests, and starts rustdoc for it.

use crate::links::{files, read};
use crate::prelude::*;

/// The lines of a manifest's section `[lib]`.
fn library_section(manifest: &str) -> Vec<&str> {
    let lines = manifest.lines().skip_while(|&line| line != "[lib]").skip(1);
    lines.take_while(|line| !line.starts_with('[')).collect()
}

/// Whether a source file has such a line.
fn any(sources: &[String], has: impl Fn(&str) -> bool) -> bool {
    sources.iter().flat_map(|source| source.lines()).any(|line| has(line.trim_start()))
}

#[test]
fn manifests_name_libraries_without_tests_or_examples() {
    let mut wrong = Vec::new();
    for manifest in files(Path::new("")).iter().filter(|path| path.ends_with("Cargo.toml")) {
        let sources = manifest.with_file_name("src");
        if !Path::new(env!("CARGO_MANIFEST_DIR")).join(&sources).join("lib.rs").exists() {
            continue;
        }
        let sources = files(&sources);
        let sources = sources.iter().filter(|path| path.extension().is_some_and(|e| e == "rs"));
        let sources: Vec<String> = sources.map(|path| read(path)).collect();
        let manifest_text = read(manifest);
        let section = library_section(&manifest_text);
        let tests = any(&sources, |line| line.starts_with("#[test]"));
        let examples = any(&sources, |line| {
            ["//! ```", "/// ```", "#[doc = include_str", "#![doc = include_str"]
                .iter()
                .any(|start| line.starts_with(start))
        });
        for (key, has) in [("test", tests), ("doctest", examples)] {
            if section.contains(&format!("{key} = false").as_str()) == has {
                let must = if has { "must not have" } else { "must have" };
                wrong.push(format!("{}: [lib] {must} {key} = false", manifest.display()));
            }
        }
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
}
