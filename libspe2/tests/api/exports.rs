//! The shared library exports the 38 public names and nothing else, under the console's soname. The
//! documents list its variables.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

use object::{Object, ObjectSymbol};

#[test]
fn shared_library_exports_libspe2_symbols() {
    let own = std::env::current_exe().unwrap();
    let library = own.with_file_name("libspe2.so");
    let bytes = fs::read(&library).unwrap_or_else(|error| panic!("{}: {error}", library.display()));
    let file = object::File::parse(&*bytes).unwrap();
    let exported: BTreeSet<String> = file
        .dynamic_symbols()
        .filter(ObjectSymbol::is_definition)
        .map(|symbol| symbol.name().unwrap().to_owned())
        .collect();
    let list = Path::new(env!("CARGO_MANIFEST_DIR")).join("../linker/libspe2.symbols");
    let public = fs::read_to_string(list).unwrap();
    let public: BTreeSet<String> = public.lines().map(str::to_owned).collect();
    assert_eq!(public.len(), 38);
    assert_eq!(exported, public);
    let soname = b"\0libspe2.so.2\0";
    assert!(bytes.windows(soname.len()).any(|window| window == soname));
}

/// The names of variables in a text.
fn variables(text: &str) -> BTreeSet<String> {
    let is_part = |letter: char| letter.is_ascii_uppercase() || letter.is_ascii_digit();
    text.match_indices("LIBSPE2_")
        .map(|(at, _)| {
            let name = &text[at..];
            let end = name.find(|letter| letter != '_' && !is_part(letter));
            name[..end.unwrap_or(name.len())].to_owned()
        })
        .collect()
}

/// All files of Rust below a folder, one after the other.
fn sources(folder: &Path) -> String {
    let entries = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
    entries
        .map(|path| if path.is_dir() { sources(&path) } else { fs::read_to_string(path).unwrap() })
        .collect()
}

#[test]
fn document_lists_each_variable() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let code = sources(&root.join("src"));
    let strings = code.split('"').filter(|text| text.starts_with("LIBSPE2_"));
    let read = variables(&strings.collect::<Vec<_>>().join(" "));
    assert!(read.contains("LIBSPE2_TIMING"), "{read:?}");
    let comments = code.lines().filter(|line| line.starts_with("//! - `LIBSPE2_"));
    let comments: Vec<_> = comments.collect();
    assert_eq!(variables(&comments.join(" ")), read, "lib.rs");
    let text = fs::read_to_string(root.join("../docs/libspe2.md")).unwrap();
    let rows = text.lines().filter(|line| line.starts_with("| `LIBSPE2_"));
    let first_cells: Vec<_> = rows.filter_map(|row| row.split('|').nth(1)).collect();
    assert_eq!(variables(&first_cells.join(" ")), read, "libspe2.md");
}
