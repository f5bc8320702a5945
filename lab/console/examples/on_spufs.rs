//! The program for consoles with a stand-in for spufs linked in, because nothing can be preloaded
//! into a static program. `LIBSPE2_BACKEND=spufs` makes it use the stand-in.

use std::hint::black_box;
use std::process::ExitCode;

fn main() -> ExitCode {
    black_box(spufs::linked());
    console::main()
}
