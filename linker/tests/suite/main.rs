//! All tests of this crate except the test of build scripts, which is a build script itself.

#![allow(clippy::print_stdout, reason = "the harness shows it with a failed test")]

mod glibc;
mod image;
