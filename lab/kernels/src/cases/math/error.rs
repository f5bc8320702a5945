//! Errors of reciprocals and roots against f64, in ulps of the SPU's format: the distance between
//! singles at the exact result.

use super::{Function, call, operand};
use crate::prelude::*;
use crate::single::spacing;

/// The number of calls over which an error is measured.
const CALLS: u32 = 100;
/// The number of quadwords in each call.
const QUADWORDS: usize = 100;
/// The share of all operands for the high quantile.
const MOST: f64 = 0.999;

/// The errors of a function over all fractions that an operand can have, in ulps.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Accuracy {
    /// The largest.
    pub largest: f64,
    /// The first operand with the largest error.
    pub worst: Single,
    /// The mean.
    pub mean: f64,
    /// The error that 99.9 % of the operands do not exceed.
    pub most: f64,
}

/// The error of a result in ulps.
#[must_use]
pub fn ulps(function: &Function, operand: Single, result: Single) -> f64 {
    let exact = function.quantity.exactly(to_f64(operand));
    (to_f64(result) - exact).abs() / spacing(exact)
}

/// The errors of a function over the 2^23 operands of an octave, or the 2^24 of two octaves for
/// roots. These are all cases, because an exponent does not change a digit of the result. They are
/// computed with the twin, to which the tests compare the kernel bit for bit. This takes about a
/// second.
#[must_use]
pub fn accuracy(function: &Function) -> Accuracy {
    let operands = function.quantity.all_fractions();
    let mut largest = 0.0;
    let mut worst = *operands.start();
    let mut sum = 0.0;
    let mut errors = Vec::with_capacity(operands.clone().count());
    for operand in operands {
        let error = ulps(function, operand, (function.twin)(operand));
        if error > largest {
            (largest, worst) = (error, operand);
        }
        sum += error;
        errors.push(error as f32);
    }
    let mean = sum / errors.len() as f64;
    let place = (MOST * errors.len() as f64).ceil() as usize - 1;
    let (_, most, _) = errors.select_nth_unstable_by(place, f32::total_cmp);
    Accuracy { largest, worst, mean, most: f64::from(*most) }
}

/// The largest error of the kernel over random operands from its domain.
pub fn largest(bench: &mut Bench, random: &mut ChaCha8Rng, function: &Function) -> f64 {
    let mut worst = 0.0_f64;
    for _ in 0..CALLS {
        let operands: Vec<[Single; 4]> =
            (0..QUADWORDS).map(|_| std::array::from_fn(|_| operand(random, function))).collect();
        let results = call(bench, function.kernel, &operands);
        for (operand, result) in operands.iter().zip(&results) {
            for (operand, result) in operand.iter().zip(result) {
                worst = worst.max(ulps(function, *operand, *result));
            }
        }
    }
    worst
}
