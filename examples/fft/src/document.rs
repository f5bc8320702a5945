//! The page with the transforms' speed and error, `README.md`.

use std::fmt::Write as _;

use crate::{Complex, FftError, Size, example, transform};

/// The SPU's clock in GHz.
const GIGAHERTZ: f64 = 3.192;
/// How often a measurement repeats the transform.
const TIMES: u32 = 8;

const HEAD: &str = "# A Fourier transform

Complex Fourier transforms of singles in SPU assembly: an example of an SPU program that streams from main memory, with
its speed in simulated time. The design is that of Chow, Fossum and
Brokenshire's large FFT for the Cell. The code is this project's own.

| file | what it has |
|---|---|
| [`kernels/transform.s`](kernels/transform.s) | the loops, as people write them: two kinds of stages of radix 4, and the transposition; the build schedules them |
| [`spu/main.s`](spu/main.s) | the order of stages, lists and transfers, and the barrier of the SPUs |
| [`src/twin.rs`](src/twin.rs) | the same operations in Rust; the test compares the bits |

The 65,536 numbers are a matrix of 256 rows and columns. The first pass transforms its columns, multiplies by twiddle
factors and transposes; the second pass transforms columns again. Each SPU takes batches of 16 columns. A row of a batch
is 128 bytes, which is what main memory moves at once, so a batch is one DMA list of 256 elements. While one batch is
transformed, the next one is fetched and the one before stored. 16 columns also fill four registers, so that no stage
moves anything between lanes.

A butterfly of four numbers takes 24 multiply-adds, because twiddle factors are applied as `cosine (1 - i tangent)`. The
34 operations come to 40 in the usual count of `5 n log2 n`. A loop of four butterflies takes 107 cycles a pass, of which
multiply-adds fill 96.

`cargo run --release -p fft` measures this, on a console or on the emulator, and `-- --write` writes this page:

";

const TAIL: &str = "
`Bound` is the larger of two times. The even pipe needs 107 or 69 cycles for four butterflies, the first stage's being
the cheaper ones. Main memory moves each number four times, twice each way, at the 17.0 cycles a line that the clock has
for reading and 17.4 for writing. Both leave out latencies, the barriers, and the transposition, which takes some 200
cycles for 64 numbers because the scheduler finds too few registers to pipeline it. Nor do 16 batches divide evenly among
six SPUs: three rounds could hold 18. Four SPUs are nearly enough: with six, main memory is busy for 92 % of the time.

The error is against a transform in f64 of the same numbers, parts between -1 and 1. The table has the root of the mean
square and the largest, both divided by the root of the mean square of the result. The SPU truncates where other
processors round. Numbers above 1e22 overflow, because a tangent may be 2e16.

Chow, Fossum and Brokenshire are remembered to have given 46.8 Gflop/s for 16 million points on eight SPUs, with more
passes over main memory. It is another size, so nothing here is compared with it.
";

/// One row of the table.
#[derive(Debug)]
pub struct Row {
    /// Numbers of the transform.
    pub size: Size,
    /// SPUs.
    pub spus: u32,
    /// Cycles of a transform.
    pub cycles: f64,
    /// The minimum cycles that pipes or main memory allow.
    pub bound: f64,
    /// Root of the mean square of the error, relative.
    pub mean_error: f64,
    /// The largest error, relative.
    pub largest_error: f64,
}

/// Measures all rows.
///
/// # Errors
///
/// Fails if libspe2 does.
pub fn rows() -> Result<Vec<Row>, FftError> {
    let all = [
        (Size::Small, 1),
        (Size::Large, 1),
        (Size::Large, 2),
        (Size::Large, 4),
        (Size::Large, 6),
        (Size::Large, 8),
    ];
    all.into_iter().map(|(size, spus)| row(size, spus)).collect()
}

fn row(size: Size, spus: u32) -> Result<Row, FftError> {
    let input = example(size, 1);
    let done = transform(size, &input, spus, TIMES)?;
    let (mean_error, largest_error) = errors(&done.output, &reference(&input));
    Ok(Row { size, spus, cycles: done.cycles, bound: bound(size, spus), mean_error, largest_error })
}

/// The whole page.
#[must_use]
pub fn page(rows: &[Row]) -> String {
    let mut text = HEAD.to_owned();
    text.push_str("| numbers | SPUs | cycles | bound | us | Gflop/s | error | largest |\n");
    text.push_str("|---|---|---|---|---|---|---|---|\n");
    for row in rows {
        // Writing to a string can't fail.
        let _ = writeln!(
            text,
            "| {} | {} | {:.0} | {:.0} | {:.1} | {:.1} | {:.1e} | {:.1e} |",
            row.size.numbers(),
            row.spus,
            row.cycles,
            row.bound,
            row.cycles / GIGAHERTZ / 1e3,
            row.size.operations() / row.cycles * GIGAHERTZ,
            row.mean_error,
            row.largest_error,
        );
    }
    text.push_str(TAIL);
    text
}

/// The minimum cycles of a transform, by its arithmetic on `spus` SPUs and by main memory.
fn bound(size: Size, spus: u32) -> f64 {
    let lines = size.numbers() as f64 / 16.0;
    // Four butterflies are a quarter of 16 numbers' stage.
    let (first, others) = (69.0, 107.0);
    let stages = (size.side().ilog2() / 2) as f64;
    let passes = 2.0 * lines / 4.0;
    let arithmetic = passes * (first + (stages - 1.0) * others) / f64::from(spus);
    match size {
        Size::Small => arithmetic,
        Size::Large => arithmetic.max(2.0 * lines * (17.0 + 17.4)),
    }
}

/// The error's root of the mean square, and the largest, relative to the result's.
#[must_use]
pub fn errors(output: &[Complex], exact: &[[f64; 2]]) -> (f64, f64) {
    let square = |[real, imaginary]: [f64; 2]| real * real + imaginary * imaginary;
    let (mut sum, mut largest, mut scale) = (0.0, 0.0_f64, 0.0);
    for (output, exact) in output.iter().zip(exact) {
        let error = square([f64::from(output[0]) - exact[0], f64::from(output[1]) - exact[1]]);
        sum += error;
        largest = largest.max(error);
        scale += square(*exact);
    }
    let mean = scale / exact.len() as f64;
    ((sum / scale).sqrt(), (largest / mean).sqrt())
}

/// The transform by f64 and by another algorithm: halves of even and odd numbers.
#[must_use]
pub fn reference(input: &[Complex]) -> Vec<[f64; 2]> {
    halves(&input.iter().map(|number| number.map(f64::from)).collect::<Vec<_>>())
}

fn halves(input: &[[f64; 2]]) -> Vec<[f64; 2]> {
    if input.len() == 1 {
        return input.to_vec();
    }
    let every_second = |first| input.iter().skip(first).step_by(2).copied().collect::<Vec<_>>();
    let (even, odd) = (halves(&every_second(0)), halves(&every_second(1)));
    let mut result = vec![[0.0; 2]; input.len()];
    for (k, (even, odd)) in even.iter().zip(&odd).enumerate() {
        let (sine, cosine) = libm::sincos(-std::f64::consts::TAU * k as f64 / input.len() as f64);
        let turned = [cosine * odd[0] - sine * odd[1], cosine * odd[1] + sine * odd[0]];
        for part in 0..2 {
            result[k][part] = even[part] + turned[part];
            result[k + input.len() / 2][part] = even[part] - turned[part];
        }
    }
    result
}
