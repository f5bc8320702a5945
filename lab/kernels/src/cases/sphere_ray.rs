//! The general sphere kernels, for rays from anywhere: the exact result in f64, cases and errors.

pub mod nearest;

use twins::sphere_ray::{BareSphere, Ray};

use crate::prelude::*;
use crate::records;
pub use crate::vector::{Vector, unit};
use nearest::{Blocked, Nearest, One};

/// A short array of spheres, and a long one.
const SPHERES: Objects = Objects::List(16, 48);
/// The number of packets over which an error is measured.
const PACKETS: u32 = 4000;
/// The smallest distance between a ray and the sphere's outline, as disc / r^2, for which the root
/// counts.
const OUTLINE: f64 = 0.01;
/// The same for which the verdict counts.
const TANGENT: f64 = 1e-4;
/// The smallest distance of an origin from the surface, in radii, for which its side counts.
const SURFACE: f64 = 1e-5;

/// The kernels in this file.
pub fn kernels() -> Vec<Kernel> {
    vec![
        Kernel::of([
            case("miss", Objects::Fixed(1), |_| one_ray(beside())),
            case("hit", Objects::Fixed(1), |_| one_ray(ahead(1))),
        ])
        .rays(1)
        .error(|bench, random| nearest_error(bench, random, one_by_one)),
        Kernel::of([
            case("all miss", Objects::Fixed(1), |_| nearest([beside()])),
            case("all hit", Objects::Fixed(1), |_| nearest([ahead(1)])),
        ])
        .error(|bench, random| nearest_error(bench, random, together)),
        Kernel::of([
            case("all miss", Objects::Fixed(16), |_| nearest([beside(); 16])),
            case("all hit, each nearer", Objects::Fixed(16), |_| nearest(nearer_and_nearer())),
        ])
        .error(|bench, random| nearest_error(bench, random, among_sixteen)),
        Kernel::of([
            case("nothing blocks", Objects::Fixed(1), |_| blocked::<false>(beside(), 1)),
            case("all blocked", Objects::Fixed(1), |_| blocked(ahead(1), 1)),
        ])
        .error(|bench, random| any_error(bench, random, "any_sphere_r16", &[])),
        Kernel::of([
            case("nothing blocks", SPHERES, |count| blocked::<true>(beside(), count)),
            case("all blocked by the first", SPHERES, |count| blocked(ahead(1), count)),
        ])
        .error(|bench, random| any_error(bench, random, "any_spheres_r16", &[1])),
    ]
}

/// The rays of the cases: from near the origin towards -z.
#[must_use]
pub fn case_rays() -> [Ray; 16] {
    std::array::from_fn(|lane| {
        let (x, y) = ((lane % 4) as f64, (lane / 4) as f64);
        let step = |at: f64| (at - 1.5) * 0.01;
        ray([step(x), step(y), 0.0], unit([step(y), step(x), -1.0]), FARTHEST)
    })
}

/// A ray that has hit nothing.
#[must_use]
pub fn ray(origin: Vector, direction: Vector, t: Single) -> Ray {
    Ray { origin: origin.map(from_f64), direction: direction.map(from_f64), t, object: 0 }
}

/// A sphere.
#[must_use]
pub fn bare_sphere(centre: Vector, radius: f64) -> BareSphere {
    BareSphere { centre: centre.map(from_f64), radius_squared: from_f64(radius * radius) }
}

fn beside() -> BareSphere {
    bare_sphere([9.0, 0.0, -5.0], 1.0)
}

fn ahead(place: u32) -> BareSphere {
    bare_sphere([0.0, 0.0, -5.0 * f64::from(place)], 1.0)
}

fn nearer_and_nearer() -> [BareSphere; 16] {
    std::array::from_fn(|number| ahead(16 - number as u32))
}

/// The first ray of the cases and a sphere.
fn one_ray(sphere: BareSphere) -> One {
    One { ray: case_rays()[0], sphere, object: 7, anything: 0 }
}

fn nearest<const COUNT: usize>(spheres: [BareSphere; COUNT]) -> Nearest<COUNT> {
    Nearest { rays: case_rays(), spheres: spheres.into(), first: 7 }
}

fn blocked<const ARRAY: bool>(sphere: BareSphere, count: u32) -> Blocked<ARRAY> {
    Blocked { rays: case_rays(), spheres: vec![sphere; count as usize] }
}

/// A random direction, uniformly distributed.
#[must_use]
pub fn any_direction(random: &mut ChaCha8Rng) -> Vector {
    loop {
        let vector: Vector = std::array::from_fn(|_| random.random_range(-1.0..1.0));
        if (0.01..1.0).contains(&dot(vector, vector)) {
            return unit(vector);
        }
    }
}

/// The exact intersection of a ray with a sphere, in f64 and with the direction normalised, from
/// the same singles that a kernel gets.
#[derive(Clone, Copy, Debug)]
pub struct Truth {
    /// The first hit: the entry, or the exit for a ray from inside.
    pub t: Option<f64>,
    /// disc / r^2, which is 0 for a tangent.
    pub depth: f64,
    /// The distance of the origin from the surface, in radii. Below 0 inside.
    pub height: f64,
    /// The radius.
    pub radius: f64,
}

/// The exact intersection of a ray with a sphere.
#[must_use]
pub fn truth(ray: &Ray, sphere: &BareSphere) -> Truth {
    let direction = unit(ray.direction.map(to_f64));
    let centre: Vector =
        std::array::from_fn(|axis| to_f64(sphere.centre[axis]) - to_f64(ray.origin[axis]));
    let radius_squared = to_f64(sphere.radius_squared);
    let b = dot(centre, direction);
    let l: Vector = std::array::from_fn(|axis| centre[axis] - b * direction[axis]);
    let disc = radius_squared - dot(l, l);
    let root = disc.max(0.0).sqrt();
    let inside = dot(centre, centre) < radius_squared;
    let t = if inside { b + root } else { b - root };
    let radius = radius_squared.sqrt();
    Truth {
        t: (disc >= 0.0 && t > 0.0).then_some(t),
        depth: disc / radius_squared,
        height: dot(centre, centre).sqrt() / radius - 1.0,
        radius,
    }
}

/// A sphere, and rays towards points within 2 radii of its centre: from up to 30 radii away, from
/// near its surface, and from inside.
#[must_use]
pub fn around_a_sphere(random: &mut ChaCha8Rng) -> ([Ray; 16], BareSphere) {
    let radius = random.random_range(0.1..10.0);
    let around: Vector = std::array::from_fn(|_| random.random_range(-3.0..3.0));
    let sphere = bare_sphere(around, radius);
    let rays = std::array::from_fn(|lane| {
        let distance = radius
            * match lane % 4 {
                0 => random.random_range(0.0..0.999),
                1 => random.random_range(1.001..1.5),
                _ => random.random_range(1.5..30.0),
            };
        let (from, to) = (any_direction(random), any_direction(random));
        let reach = radius * random.random_range(0.0..2.0);
        let origin: Vector = std::array::from_fn(|axis| around[axis] + distance * from[axis]);
        let towards = std::array::from_fn(|axis| around[axis] + reach * to[axis] - origin[axis]);
        ray(origin, unit(towards), FARTHEST)
    });
    (rays, sphere)
}

/// The distance from a single to the next, at the larger of t and r.
#[must_use]
pub fn ulp(t: f64, radius: f64) -> f64 {
    libm::exp2(libm::log2(t.max(radius)).floor() - 23.0)
}

/// The object number that the measured calls pass.
const OBJECT: u32 = 77;

type Call = fn(&mut Bench, &[Ray; 16], &BareSphere) -> [Ray; 16];

/// Calls `isect_sphere_r1` with each ray.
pub fn one_by_one(bench: &mut Bench, rays: &[Ray; 16], sphere: &BareSphere) -> [Ray; 16] {
    let one = |ray: Ray| One { ray, sphere: *sphere, object: OBJECT, anything: ray.t };
    rays.map(|ray| one(ray).call(bench))
}

/// Calls `isect_sphere_r16`.
pub fn together(bench: &mut Bench, rays: &[Ray; 16], sphere: &BareSphere) -> [Ray; 16] {
    Nearest::<1> { rays: *rays, spheres: vec![*sphere], first: OBJECT }.call(bench)
}

/// Calls `isect_spheres16_r16` with fifteen more spheres that no ray comes near.
pub fn among_sixteen(bench: &mut Bench, rays: &[Ray; 16], sphere: &BareSphere) -> [Ray; 16] {
    const PLACE: usize = 5;
    let mut spheres = vec![bare_sphere([1e6, 1e6, 1e6], 1e-3); 16];
    spheres[PLACE] = *sphere;
    Nearest::<16> { rays: *rays, spheres, first: OBJECT - PLACE as u32 }.call(bench)
}

/// The largest error of t. Infinite for a missed or a false hit.
fn nearest_error(bench: &mut Bench, random: &mut ChaCha8Rng, call: Call) -> f64 {
    let mut worst = 0.0_f64;
    for _ in 0..PACKETS {
        let (rays, sphere) = around_a_sphere(random);
        for (ray, after) in rays.iter().zip(call(bench, &rays, &sphere)) {
            let truth = truth(ray, &sphere);
            let found = (after.object == OBJECT).then(|| to_f64(after.t));
            match (found, truth.t) {
                (Some(found), Some(t)) if truth.depth > OUTLINE && truth.height.abs() > SURFACE => {
                    worst = worst.max((found - t).abs() / ulp(t, truth.radius));
                }
                (None, Some(_)) | (Some(_), None)
                    if truth.depth.abs() > TANGENT && truth.height.abs() > SURFACE =>
                {
                    worst = f64::INFINITY;
                }
                _ => {}
            }
        }
    }
    worst
}

/// The largest distance between t and the hit for which the result was wrong.
fn any_error(bench: &mut Bench, random: &mut ChaCha8Rng, kernel: &str, further: &[u32]) -> f64 {
    let mut worst = 0.0_f64;
    for _ in 0..PACKETS {
        let (mut rays, sphere) = around_a_sphere(random);
        let mut expected = [None; 16];
        for (ray, expected) in rays.iter_mut().zip(&mut expected) {
            let truth = truth(ray, &sphere);
            if let Some(t) = truth.t.filter(|_| truth.depth > OUTLINE) {
                let ulp = ulp(t, truth.radius);
                ray.t = from_f64(t + random.random_range(-40.0..40.0) * ulp);
                let beyond = (to_f64(ray.t) - t) / ulp;
                *expected = Some((beyond > 0.0, beyond.abs()));
            } else if truth.t.is_none() && truth.depth.abs() > TANGENT {
                *expected = Some((false, f64::INFINITY));
            }
        }
        bench.reset();
        let record = bench.place(records::rows::<_, records::Rays, 16>(&rays).as_bytes());
        let sphere = bench.place(records::BareSphere::new(&sphere).as_bytes());
        let arguments = [&[record.address, sphere.address], further].concat();
        let blocked = bench.call(kernel, &arguments).value;
        for (lane, expected) in expected.iter().enumerate() {
            if let Some((block, error)) = expected
                && (blocked & 0x8000 >> lane != 0) != *block
            {
                worst = worst.max(*error);
            }
        }
    }
    worst
}
