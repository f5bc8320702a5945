//! All tests of the builder of SPU programs, but for that of build scripts, which is one itself.

mod glibc;
mod image;
