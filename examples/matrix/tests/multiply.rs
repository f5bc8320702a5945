//! The product compared with f64, and the cycles with the pipelines' bound. It sets the environment
//! of the whole process, so it is a program of its own.

#![allow(clippy::print_stdout, reason = "a test has nothing to lose but its output")]

use matrix::{SIDE, example, multiply};

/// A multiply-add in every cycle, four at a time.
const BOUND: f64 = 65_536.0;

fn main() {
    // SAFETY: this is the first statement of a program that has only one thread.
    unsafe { std::env::set_var("LIBSPE2_TIMING", "1") };
    let (a, b, c) = (example(1), example(2), example(3));
    for times in [1_u32, 20] {
        let product = multiply(&a, &b, &c, times).expect("libspe2 runs it");
        for row in 0..SIDE {
            for column in 0..SIDE {
                let at = row * SIDE + column;
                let terms = (0..SIDE)
                    .map(|k| f64::from(a[row * SIDE + k]) * f64::from(b[k * SIDE + column]));
                let (mut sum, mut size) = (0.0, 0.0);
                for term in terms {
                    sum += term;
                    size += term.abs();
                }
                let passes = f64::from(times);
                let exact = f64::from(c[at]) + passes * sum;
                // Each of the sums so far is truncated, by less than an ulp of 2^-23.
                let largest = f64::from(c[at]).abs() + passes * size;
                let bound = passes * SIDE as f64 * largest * f64::powi(2.0, -23);
                let error = (f64::from(product.c[at]) - exact).abs();
                assert!(error <= bound, "row {row}, column {column}: {error} of {bound}");
            }
        }
        if times > 1 {
            let cycles = product.cycles;
            println!("{cycles:.0} cycles, {:.2} % above the bound", 100.0 * (cycles / BOUND - 1.0));
            assert!(cycles < 1.003 * BOUND, "{cycles}");
        }
    }
}
