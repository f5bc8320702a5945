//! The kernels for triangles, rectangles and planes: cases, and inputs from the stated domains.

pub mod error;

use rand::{Rng, SeedableRng as _};
use rand_chacha::ChaCha8Rng;
use spu_emulator::float::single::to_f64;
use twins::rectangle::Rectangle;
use twins::triangle::Triangle;
use zerocopy::IntoBytes as _;
use zerocopy::big_endian::F32;

use crate::bench::{Bench, Place, SEED};
use crate::cases::sphere_ray::case_rays;
use crate::catalogue::{Case, Kernel, Objects};
use crate::flat_records::{OneRay, Ray, Rays, Shears, point, quad};
use crate::vector::{Vector, cross, dot, in_cube, magnitude, sub, unit};

/// A short array of triangles, and a long one.
const TRIANGLES: Objects = Objects::List(16, 48);
/// The number of the first object.
const OBJECT: u32 = 7;

/// The kernels in this file.
pub const KERNELS: &[Kernel] = &[
    Kernel {
        name: "shear_r16",
        rays: 16,
        cases: &[Case {
            name: "a packet",
            objects: Objects::Fixed(1),
            place: |bench, _| {
                let rays = put_rays(bench);
                vec![rays.address, bench.junk::<Shears>().address]
            },
        }],
        error: Some(error::shear),
        equal: None,
    },
    Kernel {
        name: "isect_triangles_r16",
        rays: 16,
        cases: &[
            Case {
                name: "all miss",
                objects: TRIANGLES,
                place: |bench, count| triangles(bench, beside, count, &[OBJECT]),
            },
            Case {
                name: "all hit, each nearer",
                objects: TRIANGLES,
                place: |bench, count| triangles(bench, ahead, count, &[OBJECT]),
            },
        ],
        error: Some(error::isect_triangles),
        equal: None,
    },
    Kernel {
        name: "isect_triangle_r1",
        rays: 1,
        cases: &[
            Case {
                name: "miss",
                objects: Objects::Fixed(1),
                place: |bench, _| one_ray(bench, &beside(1)),
            },
            Case {
                name: "hit",
                objects: Objects::Fixed(1),
                place: |bench, _| one_ray(bench, &ahead(1)),
            },
        ],
        error: None,
        equal: None,
    },
    Kernel {
        name: "any_triangles_r16",
        rays: 16,
        cases: &[
            Case {
                name: "nothing blocks",
                objects: TRIANGLES,
                place: |bench, count| triangles(bench, beside, count, &[]),
            },
            Case {
                name: "all blocked by the first",
                objects: TRIANGLES,
                place: |bench, count| triangles(bench, ahead, count, &[]),
            },
        ],
        error: None,
        equal: None,
    },
    Kernel {
        name: "isect_rectangle_r16",
        rays: 16,
        cases: &[
            Case {
                name: "all miss",
                objects: Objects::Fixed(1),
                place: |bench, _| with_rectangle(bench, 9.0, &[OBJECT]),
            },
            Case {
                name: "all hit",
                objects: Objects::Fixed(1),
                place: |bench, _| with_rectangle(bench, -1.0, &[OBJECT]),
            },
        ],
        error: Some(error::isect_rectangle),
        equal: None,
    },
    Kernel {
        name: "any_rectangle_r16",
        rays: 16,
        cases: &[
            Case {
                name: "nothing blocks",
                objects: Objects::Fixed(1),
                place: |bench, _| with_rectangle(bench, 9.0, &[]),
            },
            Case {
                name: "all blocked",
                objects: Objects::Fixed(1),
                place: |bench, _| with_rectangle(bench, -1.0, &[]),
            },
        ],
        error: None,
        equal: None,
    },
    Kernel {
        name: "isect_plane_r16",
        rays: 16,
        cases: &[Case {
            name: "all hit",
            objects: Objects::Fixed(1),
            place: |bench, _| with_rectangle(bench, 9.0, &[OBJECT]),
        }],
        error: Some(error::isect_plane),
        equal: None,
    },
];

/// A triangle across the rays of the cases. The smaller its place, the nearer it is.
fn ahead(place: u32) -> Triangle {
    let z = -5.0 * f64::from(place);
    [[-9.0, -9.0, z], [9.0, -9.0, z], [0.0, 9.0, z]].map(point)
}

fn beside(place: u32) -> Triangle {
    let z = -5.0 * f64::from(place);
    [[90.0, -9.0, z], [99.0, -9.0, z], [95.0, 9.0, z]].map(point)
}

fn put_rays(bench: &mut Bench) -> Place {
    let rays = case_rays().map(|ray| Ray::new(ray.origin, ray.direction));
    bench.place(Rays::pack(&rays).as_bytes())
}

/// Rays, their shears, and this many triangles, the farthest first.
fn triangles(
    bench: &mut Bench,
    triangle: fn(u32) -> Triangle,
    count: u32,
    further: &[u32],
) -> Vec<u32> {
    let rays = put_rays(bench);
    let shears = bench.junk::<Shears>();
    bench.call("shear_r16", &[rays.address, shears.address]);
    let triangles = (0..count).rev().map(|place| triangle(place + 1));
    let triangles = put_triangles(bench, triangles, || 0);
    let arguments = [rays.address, shears.address, triangles.address, count];
    [&arguments, further].concat()
}

fn one_ray(bench: &mut Bench, triangle: &Triangle) -> Vec<u32> {
    let ray = case_rays()[0];
    let ray = Ray::new(ray.origin, ray.direction);
    let record = OneRay::new(&ray, &mut ChaCha8Rng::seed_from_u64(SEED));
    let ray = bench.place(record.as_bytes());
    let triangle = put_triangles(bench, [*triangle], || 0);
    vec![ray.address, triangle.address, OBJECT]
}

/// Rays, and a rectangle in front of them whose corner is at this x.
fn with_rectangle(bench: &mut Bench, x: f64, further: &[u32]) -> Vec<u32> {
    let rays = put_rays(bench);
    let shape = rectangle([x, -1.0, -5.0], [2.0, 0.0, 0.0], [0.0, 2.0, 0.0]);
    let shape = put_rectangle(bench, &shape, || 0);
    [&[rays.address, shape.address], further].concat()
}

/// Puts the record of triangles into local store. Their fourth words are `anything`.
pub fn put_triangles(
    bench: &mut Bench,
    triangles: impl IntoIterator<Item = Triangle>,
    mut anything: impl FnMut() -> u32,
) -> Place {
    let mut record = |triangle: Triangle| triangle.map(|vertex| quad(vertex, anything()));
    let records: Vec<[[F32; 4]; 3]> = triangles.into_iter().map(&mut record).collect();
    bench.place(records.as_bytes())
}

/// Puts the record of a rectangle into local store. Its fourth words are `anything`.
pub fn put_rectangle(
    bench: &mut Bench,
    rectangle: &Rectangle,
    mut anything: impl FnMut() -> u32,
) -> Place {
    let Rectangle { point, normal, dual_u, dual_v } = *rectangle;
    let record = [point, normal, dual_u, dual_v].map(|vector| quad(vector, anything()));
    bench.place(record.as_bytes())
}

/// A parallelogram with these edges, made like those of scenes: in f64, and then rounded.
#[must_use]
pub fn rectangle(corner: Vector, first: Vector, second: Vector) -> Rectangle {
    let across = cross(first, second);
    let square = dot(across, across);
    Rectangle {
        point: point(corner),
        normal: point(unit(across)),
        dual_u: point(cross(second, across).map(|component| component / square)),
        dual_v: point(cross(across, first).map(|component| component / square)),
    }
}

/// A triangle from the stated domain, and a ray to a point in it.
pub fn aimed_at_triangle(random: &mut impl Rng) -> (Ray, Triangle) {
    let origin = point(in_cube(10.0, random));
    loop {
        let distance = magnitude(1.0..100.0, random);
        let size = distance * magnitude(0.01..1.0, random);
        let towards = unit(in_cube(1.0, random));
        let triangle: Triangle = std::array::from_fn(|_| {
            let offset = in_cube(size / 2.0, random);
            point(std::array::from_fn(|axis| {
                to_f64(origin[axis]) + distance * towards[axis] + offset[axis]
            }))
        });
        let [a, b, c] = triangle.map(|vertex| vertex.map(to_f64));
        let mut weights: Vector = std::array::from_fn(|_| random.random_range(0.01..1.0));
        let sum: f64 = weights.iter().sum();
        weights = weights.map(|weight| weight / sum);
        let target: Vector = std::array::from_fn(|axis| {
            weights[0] * a[axis] + weights[1] * b[axis] + weights[2] * c[axis]
        });
        let direction = unit(sub(target, origin.map(to_f64)));
        // Its apparent size: twice its area across the ray, relative to its size.
        let seen = dot(cross(sub(a, c), sub(b, c)), direction).abs();
        if seen > 0.1 * size * size {
            return (Ray::new(origin, point(direction)), triangle);
        }
    }
}

/// t, u and v of the point where the ray meets the triangle's plane, in f64 from the same singles
/// that a kernel gets (Möller and Trumbore).
#[must_use]
pub fn on_triangle(ray: &Ray, triangle: &Triangle) -> Vector {
    let [a, b, c] = triangle.map(|vertex| vertex.map(to_f64));
    let direction = ray.direction.map(to_f64);
    let (first, second) = (sub(a, c), sub(b, c));
    let beside = sub(ray.origin.map(to_f64), c);
    let across = cross(direction, second);
    let turned = cross(beside, first);
    let determinant = dot(first, across);
    [
        dot(second, turned) / determinant,
        dot(beside, across) / determinant,
        dot(direction, turned) / determinant,
    ]
}

/// A rectangle, rays to points in it and around it, and its approximate distance.
pub fn around_rectangle(random: &mut impl Rng) -> (Rectangle, [Ray; 16], f64) {
    let origin = in_cube(10.0, random);
    let distance = magnitude(1.0..100.0, random);
    let size = distance * magnitude(0.01..1.0, random);
    let towards = unit(in_cube(1.0, random));
    let corner: Vector = std::array::from_fn(|axis| origin[axis] + distance * towards[axis]);
    let [first, second] = loop {
        let edges = [(); 2].map(|()| in_cube(size, random));
        let lengths = edges.map(|edge| dot(edge, edge).sqrt());
        let across = cross(edges[0], edges[1]);
        let sine = dot(across, across).sqrt() / (lengths[0] * lengths[1]);
        if sine > 0.5 && lengths.iter().all(|length| *length > size / 2.0) {
            break edges;
        }
    };
    let rays = std::array::from_fn(|_| {
        let [u, v] = [(); 2].map(|()| random.random_range(-0.5..1.5));
        let target: Vector =
            std::array::from_fn(|axis| corner[axis] + u * first[axis] + v * second[axis]);
        Ray::new(point(origin), point(unit(sub(target, origin))))
    });
    (rectangle(corner, first, second), rays, distance)
}

/// t, u and v of the point where the ray meets the plane, in f64 from the same singles that a
/// kernel gets, and the cosine of its incidence.
#[must_use]
pub fn on_plane(ray: &Ray, rectangle: &Rectangle) -> (Vector, f64) {
    let origin = ray.origin.map(to_f64);
    let direction = ray.direction.map(to_f64);
    let normal = rectangle.normal.map(to_f64);
    let beside = sub(origin, rectangle.point.map(to_f64));
    let along = dot(normal, direction);
    let t = -dot(normal, beside) / along;
    let hit: Vector = std::array::from_fn(|axis| beside[axis] + t * direction[axis]);
    let [u, v] = [rectangle.dual_u, rectangle.dual_v].map(|dual| dot(dual.map(to_f64), hit));
    ([t, u, v], along.abs())
}
