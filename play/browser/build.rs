//! Has the page put compiled units into the program's table of functions.

fn main() {
    println!("cargo::rerun-if-changed=build.rs");
    // Elsewhere than in a browser, the library is empty.
    if std::env::var("CARGO_CFG_TARGET_FAMILY").as_deref() == Ok("wasm") {
        println!("cargo::rustc-link-arg-cdylib=--export-table");
        println!("cargo::rustc-link-arg-cdylib=--growable-table");
    }
}
