//! The shared library exports the 38 public names and nothing else, under the console's soname.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

use object::{Object, ObjectSymbol};

#[test]
fn the_shared_library_is_a_drop_in() {
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
