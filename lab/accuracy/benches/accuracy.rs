//! Run time against error of every formulation, like `cellray-bench accuracy`. Files go to
//! target/accuracy, and the formulations that no other beats to standard output.

#![expect(
    clippy::print_stdout,
    clippy::print_stderr,
    reason = "a benchmark has nothing to lose but its output"
)]

use std::error::Error;
use std::path::Path;

use accuracy::output::{self, Document, Origin};
use accuracy::plots::{self, Format};
use accuracy::run::{Extent, Order, run};

fn main() -> Result<(), Box<dyn Error>> {
    // SAFETY: this is the first statement of a program that has only one thread.
    unsafe { accuracy::pictures::simulate_time() };
    let folder = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../target/accuracy"));
    output::folder(folder)?;
    let order = Order {
        extent: Extent::Standard,
        seed: kernels::bench::SEED,
        only: Vec::new(),
        kernels: true,
        pictures: true,
        scenes: Vec::new(),
        programs: Vec::new(),
        host_time: true,
    };
    let results = run(&order, |next| eprintln!("accuracy: {next}"))?;
    let document = Document { origin: Some(Origin::here()), results };
    output::write(&document, folder)?;
    plots::write(&plots::plots(&document.results), folder, "", &[Format::Svg, Format::Png])?;
    for plot in plots::plots(&document.results) {
        if !plot.front.is_empty() {
            println!("{}: not beaten: {}", plot.title, plot.front.join(", "));
        }
    }
    Ok(())
}
