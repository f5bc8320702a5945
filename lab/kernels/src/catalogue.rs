//! The cases in which each kernel is called, and how its error is measured.

use std::sync::LazyLock;

use rand::SeedableRng as _;
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
    pub cases: Vec<Case>,
    /// Measures the largest error of many calls with random inputs from its domain against f64, in
    /// the header's unit.
    pub error: Option<Measure>,
    /// Compares it with its twin; see [`Description`].
    pub equal: Equal,
}

/// Measures the largest error of a kernel.
type Measure = Box<dyn Fn(&mut Bench, &mut ChaCha8Rng) -> f64 + Send + Sync>;

impl Kernel {
    /// A described kernel for packets, without an error.
    #[must_use]
    pub fn of<D: Description + 'static>(cases: impl IntoIterator<Item = CaseOf<D>>) -> Self {
        let cases = cases.into_iter().map(|CaseOf { name, objects, inputs }| Case {
            name,
            objects,
            place: Box::new(move |bench, count| inputs(count).place(bench).1),
        });
        Self { name: D::KERNEL, rays: 16, cases: cases.collect(), error: None, equal: equal::<D> }
    }

    /// The same with calls that test this number of rays with each object.
    #[must_use]
    pub fn rays(self, rays: u32) -> Self {
        Self { rays, ..self }
    }

    /// The same with a measure of its error.
    #[must_use]
    pub fn error(
        self,
        error: impl Fn(&mut Bench, &mut ChaCha8Rng) -> f64 + Send + Sync + 'static,
    ) -> Self {
        Self { error: Some(Box::new(error)), ..self }
    }
}

/// A case in which a kernel is called.
pub struct Case {
    /// The name of the case.
    pub name: &'static str,
    /// The number of objects with which the rays are tested.
    pub objects: Objects,
    /// Puts the inputs for this many objects into local store and returns the arguments.
    pub place: Put,
}

/// Puts the inputs for a number of objects into local store and returns the arguments.
type Put = Box<dyn Fn(&mut Bench, u32) -> Vec<u32> + Send + Sync>;

/// A case by its inputs for a number of objects.
pub struct CaseOf<D> {
    name: &'static str,
    objects: Objects,
    inputs: fn(u32) -> D,
}

/// A case of this name, with `inputs` for a number of objects.
#[must_use]
pub fn case<D>(name: &'static str, objects: Objects, inputs: fn(u32) -> D) -> CaseOf<D> {
    CaseOf { name, objects, inputs }
}

/// A case with sensible inputs, which are always the same.
#[must_use]
pub fn sensible<D: Description>(name: &'static str, objects: Objects) -> CaseOf<D> {
    case(name, objects, |count| D::sensible(count as usize, &mut ChaCha8Rng::seed_from_u64(1)))
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

/// All kernels that have cases.
pub fn kernels() -> impl Iterator<Item = &'static Kernel> {
    static KERNELS: LazyLock<Vec<Kernel>> = LazyLock::new(|| {
        let families = [
            eye::kernels(),
            eye::formulation::kernels(),
            sphere_ray::kernels(),
            flat::kernels(),
            math::kernels(),
            whitted::rays::kernels(),
            whitted::isect::kernels(),
            whitted::shade::kernels(),
            whitted::smooth::kernels(),
            whitted::texture::kernels(),
            whitted::colour::kernels(),
            whitted::shaders::kernels(),
            whitted::portal::kernels(),
            whitted::bounce::kernels(),
            whitted::mesh::kernels(),
            whitted::cuts::kernels(),
            whitted::height::kernels(),
            whitted::shades::kernels(),
        ];
        families.into_iter().flatten().collect()
    });
    KERNELS.iter()
}
