//! The common interface of all shapes' kernels: a record, a twin and an exact result.

use std::fmt::Debug;

use twins::pairs::Sides;
use twins::sphere_ray::Ray;
use zerocopy::Immutable;

use crate::prelude::*;
use protocol::layout::{Object, SIDES_BOTH, SIDES_EXIT};

/// A shape with a kernel that intersects candidates.
pub trait Shape: Copy + Debug {
    /// The kernel.
    const KERNEL: &'static str;
    /// Whether the kernel takes shears.
    const SHEARED: bool = false;
    /// The record in local store.
    type Record: IntoBytes + Immutable;

    /// The record. `anything` fills the fields that the kernel ignores.
    fn record(&self, anything: u32) -> Self::Record;
    /// The ray after it was tested with the object whose record is at `object`.
    fn twin(&self, ray: Ray, object: u32) -> Ray;
    /// The exact result in f64, from the same singles that the kernel gets.
    fn truth(&self, ray: &Ray) -> Truth;
    /// An object that is about 1 wide, with its centre at this x and at this distance in front of
    /// the rays of the cases, and visible from there.
    fn ahead(x: f64, distance: f64) -> Self;
    /// An object from the stated domain, and rays towards it, past it and from inside, multiplied
    /// by `scale`.
    fn around(random: &mut ChaCha8Rng, scale: f64) -> (Self, [Ray; 16]);
    /// Random bits.
    fn junk(random: &mut ChaCha8Rng) -> Self;
}

/// The exact result for a ray and an object.
#[derive(Clone, Copy, Debug)]
pub struct Truth {
    /// The distance of the first hit, if the ray hits.
    pub t: Option<f64>,
    /// The unit of the error of `t`.
    pub unit: f64,
    /// Whether the error of `t` counts. It does not where the header excludes it.
    pub counts: bool,
    /// Whether the verdict is certain. It is not where the rounding of the inputs decides.
    pub sure: bool,
}

/// A random combination of sides.
pub fn any_sides(random: &mut ChaCha8Rng) -> Sides {
    Sides { both: random.random(), exit: random.random() }
}

/// The word of the sides. Its other bits come from `anything`.
fn sides_word(sides: Sides, anything: u32) -> u32 {
    let bit = |set: bool, bit: u32| if set { bit } else { 0 };
    anything & !(SIDES_BOTH | SIDES_EXIT)
        | bit(sides.both, SIDES_BOTH)
        | bit(sides.exit, SIDES_EXIT)
}

/// The sides of a shape without an inside. Everything except `both` is arbitrary.
#[must_use]
pub fn one_sided(both: bool, anything: u32) -> Sides {
    Sides { both, exit: anything & 1 != 0 }
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

/// The same head in the form that other records use.
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
