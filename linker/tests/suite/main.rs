//! All tests of this crate except the test of build scripts, which is a build script itself.

mod glibc;
mod image;
