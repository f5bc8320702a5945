//! Gives the shared library the console's soname, so that a program linked against it, or against
//! the import stub, runs with either library.

use std::env;

fn main() {
    println!("cargo:rerun-if-changed=build.rs");
    if env::var("CARGO_CFG_TARGET_OS").as_deref() == Ok("linux") {
        println!("cargo:rustc-cdylib-link-arg=-Wl,-soname,libspe2.so.2");
    }
}
