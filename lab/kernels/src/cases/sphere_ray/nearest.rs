//! The general sphere kernels: their inputs, calls and twins.

use twins::sphere_ray::{self as twin, BareSphere, Ray};

use super::{any_direction, around_a_sphere, bare_sphere, ray, truth};
use crate::prelude::*;
use crate::records;

fn put_spheres(bench: &mut Bench, spheres: &[BareSphere]) -> u32 {
    let spheres: Vec<records::BareSphere> = spheres.iter().map(records::BareSphere::new).collect();
    put(bench, &spheres).address
}

/// Spheres around the origin, and rays among them with limits.
fn among_spheres(count: usize, random: &mut ChaCha8Rng) -> ([Ray; 16], Vec<BareSphere>) {
    let mut sphere = || bare_sphere(in_cube(3.0, random), random.random_range(0.1..1.5));
    let spheres = (0..count).map(|_| sphere()).collect();
    let rays = std::array::from_fn(|_| {
        let (origin, t) = (in_cube(4.0, random), from_f64(random.random_range(0.0..20.0)));
        Ray { object: 5, ..ray(origin, any_direction(random), t) }
    });
    (rays, spheres)
}

/// A sphere, and rays around it. Half of their limits are before the hit and half after it, and
/// some rays are absent.
fn around_with_limits(random: &mut ChaCha8Rng) -> ([Ray; 16], BareSphere) {
    let (mut rays, sphere) = around_a_sphere(random);
    for ray in &mut rays {
        ray.t = match random.random_range(0..8) {
            0 => from_f64(random.random_range(-1.0..0.0)),
            1 => FARTHEST,
            _ => from_f64(truth(ray, &sphere).t.unwrap_or(1.0) * random.random_range(0.5..1.5)),
        };
    }
    (rays, sphere)
}

/// One ray and one sphere.
#[derive(Clone, Debug)]
pub struct One {
    /// The ray.
    pub ray: Ray,
    /// The sphere.
    pub sphere: BareSphere,
    /// The sphere's number.
    pub object: u32,
    /// Fills the fields without meaning.
    pub anything: u32,
}

impl Description for One {
    const KERNEL: &'static str = "isect_sphere_r1";
    const ROUNDS: [usize; 2] = [4000, 4000];
    const LENGTHS: &'static [usize] = &[1];
    const SHARES: [Range<f64>; 2] = [0.2..0.9, ANY_SHARE];
    type Placed = Place;
    type Found = Ray;

    fn sensible(_: usize, random: &mut ChaCha8Rng) -> Self {
        let (rays, sphere) = around_a_sphere(random);
        let ray = rays[random.random_range(0..16)];
        Self { ray, sphere, object: random.random(), anything: random.random() }
    }

    fn any(_: usize, random: &mut ChaCha8Rng) -> Self {
        let (ray, sphere) = (any_bits(random), any_bits(random));
        Self { ray, sphere, object: random.random(), anything: random.random() }
    }

    fn place(&self, bench: &mut Bench) -> (Place, Vec<u32>) {
        let ray = put(bench, &[records::Ray::new(&self.ray, self.anything)]);
        let sphere = put_spheres(bench, &[self.sphere]);
        (ray, vec![ray.address, sphere, self.object])
    }

    fn found(&self, bench: &Bench, placed: &Place, _: u32) -> Ray {
        bench.read::<records::Ray>(*placed).ray()
    }

    fn twin(&self, _: &Place) -> Ray {
        twin::nearest(self.ray, &self.sphere, self.object)
    }

    fn part(&self, found: &Ray) -> [usize; 2] {
        [usize::from(found.t != self.ray.t), 1]
    }
}

/// Sixteen rays, and one sphere or sixteen.
#[derive(Clone, Debug)]
pub struct Nearest<const COUNT: usize> {
    /// The rays.
    pub rays: [Ray; 16],
    /// The spheres.
    pub spheres: Vec<BareSphere>,
    /// The first sphere's number.
    pub first: u32,
}

impl<const COUNT: usize> Description for Nearest<COUNT> {
    const KERNEL: &'static str =
        if COUNT == 1 { "isect_sphere_r16" } else { "isect_spheres16_r16" };
    const ROUNDS: [usize; 2] = [1000, 1000];
    const LENGTHS: &'static [usize] = &[COUNT];
    const SHARES: [Range<f64>; 2] = [0.2..0.9, ANY_SHARE];
    type Placed = Place;
    type Found = [Ray; 16];

    fn sensible(count: usize, random: &mut ChaCha8Rng) -> Self {
        let (rays, spheres) = if count == 1 {
            let (rays, sphere) = around_a_sphere(random);
            (rays, vec![sphere])
        } else {
            among_spheres(count, random)
        };
        Self { rays, spheres, first: random.random() }
    }

    fn any(_: usize, random: &mut ChaCha8Rng) -> Self {
        let spheres = (0..COUNT).map(|_| any_bits(random)).collect();
        Self { rays: any_bits(random), spheres, first: random.random() }
    }

    fn place(&self, bench: &mut Bench) -> (Place, Vec<u32>) {
        let rays = put(bench, &[records::rows::<_, records::Rays, 16>(&self.rays)]);
        let spheres = put_spheres(bench, &self.spheres);
        (rays, vec![rays.address, spheres, self.first])
    }

    fn found(&self, bench: &Bench, placed: &Place, _: u32) -> [Ray; 16] {
        records::lanes(&bench.read::<records::Rays>(*placed))
    }

    fn twin(&self, _: &Place) -> [Ray; 16] {
        let number = |at: usize| self.first.wrapping_add(at as u32);
        self.rays.map(|ray| {
            let spheres = self.spheres.iter().enumerate();
            spheres.fold(ray, |ray, (at, sphere)| twin::nearest(ray, sphere, number(at)))
        })
    }

    fn part(&self, found: &[Ray; 16]) -> [usize; 2] {
        [self.rays.iter().zip(found).filter(|(before, after)| before.t != after.t).count(), 16]
    }
}

/// Sixteen rays that spheres may block: one sphere, or an array of them.
#[derive(Clone, Debug)]
pub struct Blocked<const ARRAY: bool> {
    /// The rays.
    pub rays: [Ray; 16],
    /// The spheres.
    pub spheres: Vec<BareSphere>,
}

impl<const ARRAY: bool> Description for Blocked<ARRAY> {
    const KERNEL: &'static str = if ARRAY { "any_spheres_r16" } else { "any_sphere_r16" };
    const ROUNDS: [usize; 2] = [if ARRAY { 40 } else { 1000 }, 1000];
    const SHARES: [Range<f64>; 2] = [0.1..0.9, ANY_SHARE];
    type Placed = ();
    /// A bit for each ray.
    type Found = u32;

    fn lengths() -> impl Iterator<Item = usize> {
        if ARRAY { 0..=26 } else { 1..=1 }
    }

    fn sensible(count: usize, random: &mut ChaCha8Rng) -> Self {
        let (rays, spheres) = if count == 1 {
            let (rays, sphere) = around_with_limits(random);
            (rays, vec![sphere])
        } else {
            among_spheres(count, random)
        };
        Self { rays, spheres }
    }

    fn any(count: usize, random: &mut ChaCha8Rng) -> Self {
        let spheres = (0..count).map(|_| any_bits(random)).collect();
        Self { rays: any_bits(random), spheres }
    }

    fn place(&self, bench: &mut Bench) -> ((), Vec<u32>) {
        let rays = put(bench, &[records::rows::<_, records::Rays, 16>(&self.rays)]).address;
        let mut arguments = vec![rays, put_spheres(bench, &self.spheres)];
        if ARRAY {
            arguments.push(self.spheres.len() as u32);
        }
        ((), arguments)
    }

    fn found(&self, _: &Bench, (): &(), returned: u32) -> u32 {
        returned
    }

    fn twin(&self, (): &()) -> u32 {
        let blocked = |ray: &Ray| self.spheres.iter().any(|sphere| twin::any(ray, sphere));
        self.rays.iter().fold(0, |bits, ray| bits << 1 | u32::from(blocked(ray)))
    }

    fn part(&self, found: &u32) -> [usize; 2] {
        [found.count_ones() as usize, 16]
    }
}
