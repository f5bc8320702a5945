//! Ways to call each kernel, and how its error is measured.

use rand_chacha::ChaCha8Rng;

use crate::bench::Bench;
use crate::cases::{ball, eye, flat, math, whitted};

/// A kernel as the table knows it.
pub struct Kernel {
    /// Its name.
    pub name: &'static str,
    /// Rays that a call tests with each object.
    pub rays: u32,
    /// Ways to call it.
    pub cases: &'static [Case],
    /// Largest error of many calls with random inputs from its domain, against f64, in what the
    /// header counts it in.
    pub error: Option<fn(&mut Bench, &mut ChaCha8Rng) -> f64>,
}

/// A way to call a kernel.
pub struct Case {
    /// What it shows.
    pub name: &'static str,
    /// How many objects the rays are tested with.
    pub objects: Objects,
    /// Places the records for so many objects; gives the arguments.
    pub place: fn(&mut Bench, u32) -> Vec<u32>,
}

/// How many objects a call is given.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Objects {
    /// Always so many.
    Fixed(u32),
    /// A list: the lengths to be timed. What the longer takes beyond the shorter is the cost in
    /// stream.
    List(u32, u32),
}

/// Every kernel that there are cases for.
pub fn kernels() -> impl Iterator<Item = &'static Kernel> {
    [
        eye::KERNELS,
        eye::formulation::KERNELS,
        ball::KERNELS,
        flat::KERNELS,
        math::KERNELS,
        whitted::rays::KERNELS,
        whitted::isect::KERNELS,
        whitted::shade::KERNELS,
        whitted::smooth::KERNELS,
        whitted::shaders::KERNELS,
        whitted::bounce::KERNELS,
    ]
    .into_iter()
    .flatten()
}
