//! The cases in which each kernel is called, and how its error is measured.

use rand_chacha::ChaCha8Rng;

use crate::bench::Bench;
use crate::cases::{eye, flat, math, sphere_ray, whitted};
use crate::description::{Description, Equal, equal};

/// A kernel's entry in the catalogue.
pub struct Kernel {
    /// Its name.
    pub name: &'static str,
    /// The number of rays that a call tests with each object.
    pub rays: u32,
    /// The cases in which it is called.
    pub cases: &'static [Case],
    /// Measures the largest error of many calls with random inputs from its domain against f64, in
    /// the header's unit.
    pub error: Option<fn(&mut Bench, &mut ChaCha8Rng) -> f64>,
    /// Compares it with its twin; see [`Description`].
    pub equal: Equal,
}

impl Kernel {
    /// A described kernel for packets, without cases and without an error.
    #[must_use]
    pub const fn of<D: Description>() -> Self {
        Self { name: D::KERNEL, rays: 16, cases: &[], error: None, equal: equal::<D> }
    }
}

/// A case in which a kernel is called.
pub struct Case {
    /// The name of the case.
    pub name: &'static str,
    /// The number of objects with which the rays are tested.
    pub objects: Objects,
    /// Puts the records for this many objects into local store and returns the arguments.
    pub place: fn(&mut Bench, u32) -> Vec<u32>,
}

/// The number of objects in a call.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Objects {
    /// Always this number.
    Fixed(u32),
    /// A list with the two lengths to be timed. The difference of their times is the cost in
    /// stream.
    List(u32, u32),
}

/// The families of kernels.
const FAMILIES: [&[Kernel]; 18] = [
    eye::KERNELS,
    eye::formulation::KERNELS,
    sphere_ray::KERNELS,
    flat::KERNELS,
    math::KERNELS,
    whitted::rays::KERNELS,
    whitted::isect::KERNELS,
    whitted::shade::KERNELS,
    whitted::smooth::KERNELS,
    whitted::texture::KERNELS,
    whitted::colour::KERNELS,
    whitted::shaders::KERNELS,
    whitted::portal::KERNELS,
    whitted::bounce::KERNELS,
    whitted::mesh::KERNELS,
    whitted::cuts::KERNELS,
    whitted::height::KERNELS,
    whitted::shades::KERNELS,
];

/// All kernels that have cases.
pub fn kernels() -> impl Iterator<Item = &'static Kernel> {
    FAMILIES.into_iter().flatten()
}
