//! The transforms compared with their twin, with f64, and with the page that has their speed. It
//! sets the whole process's environment, so it is a program of its own. `MAKE_REF=1` writes the page
//! instead of comparing.

#![allow(clippy::print_stdout, reason = "a test has nothing to lose but its output")]

use std::fs;
use std::path::Path;

use fft::document::{errors, page, reference, rows};
use fft::{Complex, Size, example, transform, twin};

const HERE: &str = env!("CARGO_MANIFEST_DIR");
/// Largest errors allowed: of the root of the mean square, and of any number.
const MEAN_ERROR: f64 = 1e-6;
const LARGEST_ERROR: f64 = 5e-6;

fn main() {
    // SAFETY: this is the first statement of a program that has only one thread.
    unsafe { std::env::set_var("LIBSPE2_TIMING", "1") };
    // First, because the program that writes the page runs nothing before it, and what ran before
    // shifts the decrementer's ticks.
    let rows = rows().expect("libspe2 runs it");
    for row in &rows {
        println!("{row:?}");
        assert!(row.cycles > row.bound, "{row:?}");
    }
    compare(&Path::new(HERE).join("README.md"), &page(&rows));
    an_impulse_gives_the_roots_of_unity();
    for (size, spus) in [(Size::Small, 1), (Size::Large, 1), (Size::Large, 6), (Size::Large, 16)] {
        agrees_with_twin_and_f64(size, spus);
    }
}

/// Compares a file with what it should be, or writes it.
fn compare(path: &Path, text: &str) {
    if std::env::var_os("MAKE_REF").is_some() {
        fs::write(path, text).expect("the working copy can be written");
    }
    let found = fs::read_to_string(path).expect("the file is there");
    let path = path.display();
    assert!(found == text, "{path} is stale: MAKE_REF=1 cargo test -p fft");
}

fn agrees_with_twin_and_f64(size: Size, spus: u32) {
    for seed in 1..3 {
        let input = example(size, seed);
        let done = transform(size, &input, spus, 1).expect("libspe2 runs it");
        assert!(done.output == twin::transform(size, &input), "{size:?} on {spus}: other bits");
        let (mean, largest) = errors(&done.output, &reference(&input));
        assert!(mean < MEAN_ERROR && largest < LARGEST_ERROR, "{mean:e} {largest:e}");
    }
}

/// One number that is not 0 has a transform of numbers of its size.
fn an_impulse_gives_the_roots_of_unity() {
    let mut input: Vec<Complex> = vec![[0.0; 2]; Size::Small.numbers()];
    input[1] = [1.0, 0.0];
    let output = transform(Size::Small, &input, 1, 1).expect("libspe2 runs it").output;
    for (k, [real, imaginary]) in output.into_iter().enumerate() {
        let (sine, cosine) = libm::sincos(std::f64::consts::TAU * k as f64 / 4096.0);
        let error = libm::hypot(f64::from(real) - cosine, f64::from(imaginary) + sine);
        assert!(error < 1e-6, "{k}: {error:e}");
    }
}
