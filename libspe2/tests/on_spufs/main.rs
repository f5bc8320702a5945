//! The tests of the C API once more, on spufs. A stand-in for the kernel is linked into this
//! program: it takes the place of the C library's functions by which the library calls the kernel.

#![expect(
    clippy::undocumented_unsafe_blocks,
    reason = "each block calls the C API with NULL or with pointers that are valid until their test ends"
)]

#[path = "../api/basic.rs"]
mod basic;
#[path = "../api/event.rs"]
mod event;
#[path = "../api/images.rs"]
mod images;
mod kernel;
#[path = "../api/mfc.rs"]
mod mfc;
#[path = "../api/problem_state.rs"]
mod problem_state;
#[path = "../api/run.rs"]
mod run;
#[path = "../api/support.rs"]
mod support;

/// Chooses spufs before the first test, as a program's environment does.
#[used]
#[unsafe(link_section = ".init_array")]
static CHOOSE: extern "C" fn() = choose;

extern "C" fn choose() {
    std::hint::black_box(spufs::linked());
    let set = unsafe { libc::setenv(c"LIBSPE2_BACKEND".as_ptr(), c"spufs".as_ptr(), 1) };
    assert_eq!(set, 0);
}
