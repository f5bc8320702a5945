//! The kernels for triangles, rectangles and planes: cases, and inputs from the stated domains.

pub mod error;
pub mod rectangles;
pub mod triangles;

use twins::flat::FlatHit;
use twins::rectangle::Rectangle;
use twins::triangle::Triangle;

use crate::cases::sphere_ray::case_rays;
use crate::flat_records::Ray;
use crate::flat_records::Rays;
use crate::prelude::*;
use rectangles::{ANY, NEAREST, PLANE, WithRectangle};
use triangles::{One, Sheared, Triangles};

/// A short array of triangles, and a long one.
const TRIANGLES: Objects = Objects::List(16, 48);
/// The number of the first object.
const OBJECT: u32 = 7;

/// The kernels in this file.
pub fn kernels() -> Vec<Kernel> {
    vec![
        Kernel::of([case("a packet", Objects::Fixed(1), |_| Sheared { rays: rays() })])
            .error(error::shear),
        row_of_triangles::<false>().error(error::isect_triangles),
        Kernel::of::<One>([
            case("miss", Objects::Fixed(1), |_| one(beside(1))),
            case("hit", Objects::Fixed(1), |_| one(ahead(1))),
        ])
        .rays(1),
        row_of_triangles::<true>(),
        row_of_rectangle::<NEAREST>().error(error::with_rectangle::<NEAREST>),
        row_of_rectangle::<ANY>(),
        Kernel::of::<WithRectangle<PLANE>>([case("all hit", Objects::Fixed(1), |_| {
            with_rectangle::<PLANE>(9.0)
        })])
        .error(error::with_rectangle::<PLANE>),
    ]
}

/// The row of a kernel for triangles, with those that are missed and those that are hit.
fn row_of_triangles<const ANY: bool>() -> Kernel {
    Kernel::of::<Triangles<ANY>>([
        case(if ANY { "nothing blocks" } else { "all miss" }, TRIANGLES, |count| {
            with_triangles::<ANY>(beside, count)
        }),
        case(
            if ANY { "all blocked by the first" } else { "all hit, each nearer" },
            TRIANGLES,
            |count| with_triangles::<ANY>(ahead, count),
        ),
    ])
}

/// The same for a rectangle.
fn row_of_rectangle<const TEST: usize>() -> Kernel {
    Kernel::of::<WithRectangle<TEST>>([
        case(if TEST == ANY { "nothing blocks" } else { "all miss" }, Objects::Fixed(1), |_| {
            with_rectangle::<TEST>(9.0)
        }),
        case(if TEST == ANY { "all blocked" } else { "all hit" }, Objects::Fixed(1), |_| {
            with_rectangle::<TEST>(-1.0)
        }),
    ])
}

/// A triangle across the rays of the cases. The smaller its place, the nearer it is.
fn ahead(place: u32) -> Triangle {
    let z = -5.0 * f64::from(place);
    [[-9.0, -9.0, z], [9.0, -9.0, z], [0.0, 9.0, z]].map(point)
}

fn beside(place: u32) -> Triangle {
    let z = -5.0 * f64::from(place);
    [[90.0, -9.0, z], [99.0, -9.0, z], [95.0, 9.0, z]].map(point)
}

fn rays() -> [Ray; 16] {
    case_rays().map(|ray| Ray::new(ray.origin, ray.direction))
}

/// Rays and this many triangles, the farthest first.
fn with_triangles<const ANY: bool>(triangle: fn(u32) -> Triangle, count: u32) -> Triangles<ANY> {
    let triangles = (0..count).rev().map(|place| triangle(place + 1)).collect();
    Triangles { rays: rays(), triangles, first: OBJECT }
}

fn one(triangle: Triangle) -> One {
    One { ray: rays()[0], triangle, object: OBJECT }
}

/// Rays, and a rectangle in front of them whose corner is at this x.
fn with_rectangle<const TEST: usize>(x: f64) -> WithRectangle<TEST> {
    let rectangle = rectangle([x, -1.0, -5.0], [2.0, 0.0, 0.0], [0.0, 2.0, 0.0]);
    WithRectangle { rays: rays(), rectangle, object: OBJECT }
}

/// Puts the record of rays into local store.
pub fn put_rays(bench: &mut Bench, rays: &[Ray; 16]) -> Place {
    put(bench, &[rows::<_, Rays, 16>(rays)])
}

/// Puts the record of triangles into local store. Their fourth words are `anything`.
pub fn put_triangles(bench: &mut Bench, triangles: &[Triangle], anything: u32) -> Place {
    let record = |triangle: &Triangle| triangle.map(|vertex| quad(vertex, anything));
    let records: Vec<[[F32; 4]; 3]> = triangles.iter().map(record).collect();
    put(bench, &records)
}

/// Puts the record of a rectangle into local store. Its fourth words are `anything`.
pub fn put_rectangle(bench: &mut Bench, rectangle: &Rectangle, anything: u32) -> Place {
    let Rectangle { point, normal, dual_u, dual_v } = *rectangle;
    let record = [point, normal, dual_u, dual_v].map(|vector| quad(vector, anything));
    put(bench, &record)
}

/// The results of a test of sixteen rays: a bit for each one with something in its way, if that is
/// the question, and their hits.
pub type Tested = (u32, [FlatHit; 16]);

fn tested<const ANY: bool>(bench: &Bench, rays: Place, returned: u32) -> Tested {
    (if ANY { returned } else { 0 }, lanes::<Ray>(&bench.read::<Rays>(rays)).map(|ray| ray.hit))
}

/// The bits for a condition on sixteen rays.
fn code(holds: [bool; 16]) -> u32 {
    holds.into_iter().fold(0, |code, holds| code << 1 | u32::from(holds))
}

/// How many rays have something in their way or have hit something.
fn changed(rays: &[Ray; 16], (code, hits): &Tested) -> usize {
    let hits = rays.iter().zip(hits).filter(|(ray, hit)| ray.hit != **hit);
    code.count_ones() as usize + hits.count()
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
