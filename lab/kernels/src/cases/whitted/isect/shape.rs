//! What the shapes' kernels have in common: a record, a twin, and a truth.

use std::fmt::Debug;

use rand::Rng as _;
use rand_chacha::ChaCha8Rng;
use twins::Single;
use twins::pairs::Sides;
use twins::sphere_ray::Ray;
use zerocopy::big_endian::U32;
use zerocopy::{Immutable, IntoBytes};

use crate::single::single;
use protocol::layout::{Object, SIDES_BOTH, SIDES_EXIT};

/// A shape that has a kernel for candidates.
pub trait Shape: Copy + Debug {
    /// The kernel.
    const KERNEL: &'static str;
    /// Whether it takes shears.
    const SHEARED: bool = false;
    /// The record in local store.
    type Record: IntoBytes + Immutable;

    /// The record; `anything` fills what has no meaning for the kernel.
    fn record(&self, anything: u32) -> Self::Record;
    /// The ray after its test with the object whose record is at `object`.
    fn twin(&self, ray: Ray, object: u32) -> Ray;
    /// What is so, in f64 for the very singles that the kernel is given.
    fn truth(&self, ray: &Ray) -> Truth;
    /// About 1 wide, with its middle at this x and so far ahead of the rays of the cases, seen
    /// from there.
    fn ahead(x: f64, distance: f64) -> Self;
    /// An object of the stated domain and rays towards it, past it and from within, so many times
    /// as large.
    fn around(random: &mut ChaCha8Rng, scale: f64) -> (Self, [Ray; 16]);
    /// Any bits at all.
    fn junk(random: &mut ChaCha8Rng) -> Self;
}

/// What is so of a ray and an object.
#[derive(Clone, Copy, Debug)]
pub struct Truth {
    /// Where it hits first, if it does.
    pub t: Option<f64>,
    /// What the error of `t` is counted in.
    pub unit: f64,
    /// Whether the error of `t` counts: not where the header excludes it.
    pub counts: bool,
    /// Whether there is a hit or none for sure: not where roundings of what is given decide.
    pub sure: bool,
}

/// Any sides.
pub fn any_sides(random: &mut ChaCha8Rng) -> Sides {
    Sides {
        both: random.random(),
        exit: random.random(),
    }
}

/// The word of sides; its other bits are those of `anything`.
fn sides_word(sides: Sides, anything: u32) -> u32 {
    let bit = |set: bool, bit: u32| if set { bit } else { 0 };
    anything & !(SIDES_BOTH | SIDES_EXIT)
        | bit(sides.both, SIDES_BOTH)
        | bit(sides.exit, SIDES_EXIT)
}

/// The sides of what has no inside: all but `both` is anything.
#[must_use]
pub fn one_sided(both: bool, anything: u32) -> Sides {
    Sides {
        both,
        exit: anything & 1 != 0,
    }
}

/// The head of an object's record.
#[must_use]
pub fn head(
    centre: [Single; 3],
    axis: [Single; 3],
    offset: Single,
    sides: Sides,
    anything: u32,
) -> Object {
    Object {
        centre: centre.map(single),
        gain: single(anything),
        axis: axis.map(single),
        slope: single(anything),
        offset: single(offset),
        leave: single(anything),
        material: anything.into(),
        sides: sides_word(sides, anything).into(),
    }
}

/// The same, as other records hold it.
#[must_use]
pub fn head_words(
    centre: [Single; 3],
    axis: [Single; 3],
    offset: Single,
    sides: Sides,
    anything: u32,
) -> [U32; 12] {
    zerocopy::transmute!(head(centre, axis, offset, sides, anything))
}
