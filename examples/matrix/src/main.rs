//! Multiplies two matrices a hundred times, and prints the cycles of one multiplication.
//!
//!     cargo run --release -p matrix
//!
//! On a console they are the console's. Elsewhere they are simulated.

use std::error::Error;

use matrix::{example, multiply};

fn main() -> Result<(), Box<dyn Error>> {
    // SAFETY: this is the first statement of a program that has only one thread.
    unsafe { std::env::set_var("LIBSPE2_TIMING", "1") };
    let product = multiply(&example(1), &example(2), &example(3), 100)?;
    let cycles = product.cycles;
    let flops = 2.0 * 64.0 * 64.0 * 64.0;
    Ok(messages::write_data(format!(
        "{cycles:.0} cycles a multiplication, of at least 65536; {:.2} Gflop/s of 25.54\n",
        flops / cycles * 3.192
    ))?)
}
