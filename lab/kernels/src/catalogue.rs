//! Ways to call each kernel, and how its error is measured.

use rand_chacha::ChaCha8Rng;

use crate::bench::Bench;
use crate::cases::{eye, flat, math, sphere_ray, whitted};

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

/// Families of kernels, each with the modules of `tests/suite` that compare it with its twins.
const FAMILIES: [(&[Kernel], &[&str]); 11] = [
    (eye::KERNELS, &["eye::"]),
    (
        eye::formulation::KERNELS,
        &["eye::isect_pairs", "spheres::"],
    ),
    (sphere_ray::KERNELS, &["sphere_ray::"]),
    (flat::KERNELS, &["flat::"]),
    (math::KERNELS, &["math::"]),
    (whitted::rays::KERNELS, &["rays::"]),
    (whitted::isect::KERNELS, &["pairs::"]),
    (whitted::shade::KERNELS, &["surfaces::"]),
    (whitted::smooth::KERNELS, &["pairs::smooth"]),
    (whitted::shaders::KERNELS, &["shaders::"]),
    (whitted::bounce::KERNELS, &["bounce::"]),
];

/// Every kernel that there are cases for.
pub fn kernels() -> impl Iterator<Item = &'static Kernel> {
    FAMILIES.iter().flat_map(|(kernels, _)| *kernels)
}

/// The tests of a kernel's family, as `cargo test` filters them.
#[must_use]
pub fn tests(kernel: &str) -> &'static [&'static str] {
    let mut families = FAMILIES.iter();
    let family = families.find(|(kernels, _)| kernels.iter().any(|found| found.name == kernel));
    family.map_or(&[], |(_, tests)| tests)
}
