//! Measures the transforms, and prints the page that README.md is. `--write` writes that file of a
//! working copy.
//!
//!     cargo run --release -p fft
//!
//! On a console the figures are the console's. Elsewhere they are simulated.

use std::error::Error;

use fft::document::{page, rows};

fn main() -> Result<(), Box<dyn Error>> {
    // SAFETY: this is the first statement of a program that has only one thread.
    unsafe { std::env::set_var("LIBSPE2_TIMING", "1") };
    let page = page(&rows()?);
    match std::env::args().nth(1).as_deref() {
        Some("--write") => {
            let path = "examples/fft/README.md";
            std::fs::write(path, page).map_err(|error| format!("{path}: {error}"))?;
        }
        Some(other) => return Err(format!("{other}: the only option is --write").into()),
        None => messages::write_data(page)?,
    }
    Ok(())
}
