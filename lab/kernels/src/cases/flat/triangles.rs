//! The kernels of triangles.

use twins::flat::FlatHit;
use twins::triangle::{Shear, Triangle, any_triangle, isect_triangles, shear};

use super::{Tested, aimed_at_triangle, changed, code, put_rays, put_triangles, tested};
use crate::flat_records;
use crate::flat_records::Ray;
use crate::flat_records::{OneRay, Shears};
use crate::prelude::*;

/// Rays whose shears are made.
#[derive(Clone, Debug)]
pub struct Sheared {
    /// The rays.
    pub rays: [Ray; 16],
}

/// The shears in a record.
#[must_use]
pub fn shears(record: &Shears) -> [Shear; 16] {
    std::array::from_fn(|lane| flat_records::shear(record, lane))
}

impl Description for Sheared {
    const KERNEL: &'static str = "shear_r16";
    const ROUNDS: [usize; 2] = [2000, 3000];
    const LENGTHS: &'static [usize] = &[1];
    type Placed = Place;
    type Found = [Shear; 16];

    fn sensible(_: usize, random: &mut ChaCha8Rng) -> Self {
        Self { rays: [(); 16].map(|()| aimed_at_triangle(random).0) }
    }

    fn any(_: usize, random: &mut ChaCha8Rng) -> Self {
        Self { rays: any_bits(random) }
    }

    fn place(&self, bench: &mut Bench) -> (Place, Vec<u32>) {
        let rays = put_rays(bench, &self.rays);
        let shears = bench.junk::<Shears>();
        (shears, vec![rays.address, shears.address])
    }

    fn found(&self, bench: &Bench, placed: &Place, _: u32) -> [Shear; 16] {
        shears(&bench.read(*placed))
    }

    fn twin(&self, _: &Place) -> [Shear; 16] {
        self.rays.map(|ray| shear(ray.origin, ray.direction))
    }
}

/// Rays and triangles: whether any of these is in their way, or which is the nearest.
#[derive(Clone, Debug)]
pub struct Triangles<const ANY: bool> {
    /// The rays.
    pub rays: [Ray; 16],
    /// The triangles.
    pub triangles: Vec<Triangle>,
    /// The number of the first one as an object.
    pub first: u32,
}

impl<const ANY: bool> Description for Triangles<ANY> {
    const KERNEL: &'static str = if ANY { "any_triangles_r16" } else { "isect_triangles_r16" };
    const ROUNDS: [usize; 2] = [80, 3000];
    const LENGTHS: &'static [usize] = LENGTHS_FROM_0;
    const SHARES: [Range<f64>; 2] = [0.1..0.9, 0.02..0.9];
    type Placed = Place;
    type Found = Tested;

    /// Triangles across the rays at any depth, some before their origins or too far.
    fn sensible(count: usize, random: &mut ChaCha8Rng) -> Self {
        let mut triangle = || {
            let depth = random.random_range(-9.0..9.0);
            [(); 3].map(|()| {
                let [x, y, _] = in_cube(3.0, random);
                point([x, y, depth])
            })
        };
        let triangles = (0..count).map(|_| triangle()).collect();
        let rays = std::array::from_fn(|_| {
            let [x, y, _] = in_cube(1.0, random);
            let mut ray = Ray::new(point([y, x, 0.0]), point(unit([x, y, 3.0])));
            ray.hit.t = from_f64(random.random_range(0.0..20.0));
            ray.hit.object = 7;
            ray
        });
        Self { rays, triangles, first: 100 }
    }

    fn any(count: usize, random: &mut ChaCha8Rng) -> Self {
        let triangles = (0..count).map(|_| any_bits(random)).collect();
        Self { rays: any_bits(random), triangles, first: random.random() }
    }

    fn place(&self, bench: &mut Bench) -> (Place, Vec<u32>) {
        let (shears, _) = Sheared { rays: self.rays }.place(bench);
        let rays = put_rays(bench, &self.rays);
        bench.call("shear_r16", &[rays.address, shears.address]);
        let triangles = put_triangles(bench, &self.triangles, !self.first);
        let count = self.triangles.len() as u32;
        let mut arguments = vec![rays.address, shears.address, triangles.address, count];
        arguments.extend((!ANY).then_some(self.first));
        (rays, arguments)
    }

    fn found(&self, bench: &Bench, placed: &Place, returned: u32) -> Tested {
        tested::<ANY>(bench, *placed, returned)
    }

    fn twin(&self, _: &Place) -> Tested {
        let Self { rays, triangles, first } = self;
        let sheared = rays.map(|ray| (shear(ray.origin, ray.direction), ray.hit));
        if ANY {
            let is_in_way = |(shear, hit): (Shear, FlatHit)| {
                any_triangle(&shear, triangles, hit.t) && to_f64(hit.t) > 0.0
            };
            return (code(sheared.map(is_in_way)), rays.map(|ray| ray.hit));
        }
        (0, sheared.map(|(shear, hit)| isect_triangles(&shear, triangles, *first, hit)))
    }

    fn part(&self, found: &Tested) -> [usize; 2] {
        [changed(&self.rays, found), if self.triangles.is_empty() { 0 } else { 16 }]
    }
}

/// A ray and a triangle.
#[derive(Clone, Debug)]
pub struct One {
    /// The ray.
    pub ray: Ray,
    /// The triangle.
    pub triangle: Triangle,
    /// Its number as an object.
    pub object: u32,
}

impl Description for One {
    const KERNEL: &'static str = "isect_triangle_r1";
    const ROUNDS: [usize; 2] = [2000, 3000];
    const LENGTHS: &'static [usize] = &[1];
    const SHARES: [Range<f64>; 2] = [0.1..0.9, 0.005..0.9];
    type Placed = Place;
    type Found = FlatHit;

    /// Half of the rays go to the triangle.
    fn sensible(count: usize, random: &mut ChaCha8Rng) -> Self {
        let Triangles { rays, triangles, first } = Triangles::<false>::sensible(count, random);
        let aimed = aimed_at_triangle(random);
        let (ray, triangle) = if random.random() { aimed } else { (rays[0], triangles[0]) };
        Self { ray, triangle, object: first }
    }

    fn any(_: usize, random: &mut ChaCha8Rng) -> Self {
        Self { ray: any_bits(random), triangle: any_bits(random), object: random.random() }
    }

    fn place(&self, bench: &mut Bench) -> (Place, Vec<u32>) {
        let record = OneRay::new(&self.ray, &mut ChaCha8Rng::seed_from_u64(SEED));
        let ray = bench.place(record.as_bytes());
        let triangle = put_triangles(bench, &[self.triangle], !self.object);
        (ray, vec![ray.address, triangle.address, self.object])
    }

    fn found(&self, bench: &Bench, placed: &Place, _: u32) -> FlatHit {
        bench.read::<OneRay>(*placed).hit()
    }

    fn twin(&self, _: &Place) -> FlatHit {
        let shear = shear(self.ray.origin, self.ray.direction);
        isect_triangles(&shear, &[self.triangle], self.object, self.ray.hit)
    }

    fn part(&self, found: &FlatHit) -> [usize; 2] {
        [usize::from(*found != self.ray.hit), 1]
    }
}
