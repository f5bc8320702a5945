//! Triangles under stress: needles, triangles without area, rays within ulps of edges.
//!
//! The watertight kernel's distance is a mean of the vertices', by weights that are not below 0: however thin a
//! triangle is, its hits lie between its vertices.

use crate::generator::Generator;
use kernels::Bench;
use kernels::cases::whitted::isect::call;
use kernels::cases::whitted::isect::shape::Shape as _;
use kernels::cases::whitted::isect::triangle::TriangleObject;
use kernels::flat_records::Point;
use kernels::vector::{Vector, cross, dot, in_cube, less, unit};
use rand::Rng as _;
use spu_emulator::float::single::{from_f64, to_f64};
use twins::FARTHEST;
use twins::ball::Ray;

use super::family::{Family, NoCaseError, Tally, words_of};
use super::random::{across, magnitude, nearby, rounded};
use super::statement::{Bound, StatementError};
use crate::families::space::direction;
use crate::truth::triangle::Triangle;
use crate::truth::{Line, spacing};

/// The kernel whose error the header of the watertight one is about.
const STATED: &str = "isect_triangles_r16";
/// How far from an edge a verdict may be wrong, in ulps of the farthest vertex' distance: of the vertices each
/// coordinate is rounded twice, and the ray's slopes once.
pub const EDGE: f64 = 8.0;
/// Triangles of a round.
const TRIANGLES: u32 = 16;

/// What is asked of a hit.
struct Kind {
    name: &'static str,
    unit: &'static str,
    make: fn(&mut Generator) -> Aimed,
    /// The error of a ray, if anything is asked of it; infinite if it is wrong.
    judge: fn(&Case) -> Option<f64>,
}

struct Triangles {
    kind: &'static Kind,
    bound: Bound,
}

/// A triangle and rays to it.
struct Aimed {
    vertices: [Point; 3],
    rays: [Ray; 16],
}

/// A ray and a triangle, and the distance that the kernel says.
struct Case {
    line: Line,
    vertices: [Point; 3],
    found: Option<f64>,
}

const KINDS: [Kind; 3] = [
    Kind {
        name: "triangle-needles",
        unit: "ulp of the farthest vertex, beyond the vertices",
        make: needle,
        judge: beyond_vertices,
    },
    Kind {
        name: "triangle-degenerate",
        unit: "hits",
        make: repeated,
        judge: |case| {
            Some(if case.found.is_some() {
                f64::INFINITY
            } else {
                0.0
            })
        },
    },
    Kind {
        name: "triangle-edges",
        unit: "ulp of the farthest vertex, off the edge",
        make: near_edge,
        judge: off_edge,
    },
];

/// All kinds.
///
/// # Errors
/// The header does not state the error.
pub fn families() -> Result<Vec<Box<dyn Family>>, StatementError> {
    let error = Bound::of(STATED)?;
    let bounds = [
        error,
        Bound::none("edges of one point have no area"),
        Bound {
            value: EDGE,
            source: "roundings of vertices and slopes".to_owned(),
        },
    ];
    let mut families: Vec<Box<dyn Family>> = Vec::new();
    for (kind, bound) in KINDS.iter().zip(bounds) {
        families.push(Box::new(Triangles { kind, bound }));
    }
    Ok(families)
}

/// How far the line between two points passes from the line of a triangle's nearest edge.
#[must_use]
pub fn off_edges(vertices: &[Point; 3], from: Vector, way: Vector) -> f64 {
    let corners = vertices.map(|vertex| less(vertex.map(to_f64), from));
    let off = (0..3).map(|k| {
        let (a, edge) = (corners[k], less(corners[(k + 1) % 3], corners[k]));
        let across = cross(way, edge);
        dot(a, across).abs() / dot(across, across).sqrt()
    });
    off.fold(f64::INFINITY, f64::min)
}

/// The distance of the farthest vertex from the ray's origin.
fn farthest(case: &Case) -> f64 {
    let distance = |vertex: &Point| {
        let to = less(vertex.map(to_f64), case.line.origin);
        dot(to, to).sqrt()
    };
    case.vertices.iter().map(distance).fold(0.0, f64::max)
}

fn beyond_vertices(case: &Case) -> Option<f64> {
    let found = case.found?;
    let way = unit(case.line.direction);
    let along = case
        .vertices
        .map(|vertex| dot(less(vertex.map(to_f64), case.line.origin), way));
    let near = along.iter().copied().fold(f64::INFINITY, f64::min);
    let far = along.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let beyond = (near - found).max(found - far).max(0.0);
    Some(beyond / spacing(farthest(case)))
}

fn off_edge(case: &Case) -> Option<f64> {
    let meeting = Triangle::new(case.vertices).meeting(&case.line)?;
    // Nearly along the plane there is no digit left of the distance's sign.
    let hit = meeting.side().is_ge() && meeting.distance > 0.0;
    if hit == case.found.is_some() {
        return Some(0.0);
    }
    let off = off_edges(&case.vertices, case.line.origin, case.line.direction);
    Some(off / spacing(farthest(case)))
}

/// A ray towards a point, from this far back.
fn towards(target: Vector, back: Vector, distance: f64, random: &mut Generator) -> Ray {
    let origin = rounded(std::array::from_fn(|k| target[k] + distance * back[k]));
    let way = less(target, origin);
    let way = if way == [0.0; 3] {
        [0.0, 0.0, 1.0]
    } else {
        unit(way)
    };
    Ray {
        origin: origin.map(from_f64),
        direction: nearby(way, random),
        t: FARTHEST,
        object: 0,
    }
}

/// As thin as singles let a triangle be, or in line altogether; rays to points along it.
fn needle(random: &mut Generator) -> Aimed {
    let size = magnitude(-10, 10, random);
    let a = rounded(in_cube(4.0 * size, random));
    let along = direction(random);
    let [aside, _] = across(along, random);
    let width = if random.random_ratio(1, 4) {
        0.0
    } else {
        size * magnitude(-30, 0, random)
    };
    let share = random.random_range(-0.5..1.5);
    let b: Vector = std::array::from_fn(|k| a[k] + size * along[k]);
    let c: Vector = std::array::from_fn(|k| a[k] + share * size * along[k] + width * aside[k]);
    let rays = [(); 16].map(|()| {
        let [u, v] = [(); 2].map(|()| random.random_range(0.0..0.5));
        let target = std::array::from_fn(|k| a[k] + u * (b[k] - a[k]) + v * (c[k] - a[k]));
        // Half of them see it at one distance from end to end.
        let [aside, _] = across(along, random);
        let back = if random.random() {
            aside
        } else {
            direction(random)
        };
        let distance = size * magnitude(-4, 7, random);
        towards(target, back, distance, random)
    });
    Aimed {
        vertices: [a, b, c].map(|v| v.map(from_f64)),
        rays,
    }
}

/// Two or three vertices that are one point; rays to it and to the edge.
fn repeated(random: &mut Generator) -> Aimed {
    let size = magnitude(-10, 10, random);
    let a = rounded(in_cube(4.0 * size, random));
    let along = direction(random);
    let b: Vector = rounded(std::array::from_fn(|k| a[k] + size * along[k]));
    let mut vertices = [a, a, if random.random_ratio(1, 4) { a } else { b }];
    vertices.rotate_left(random.random_range(0..3));
    let rays = [(); 16].map(|()| {
        let share = match random.random_range(0..4) {
            0 => 0.0,
            1 => 1.0,
            _ => random.random_range(0.0..1.0),
        };
        let target = std::array::from_fn(|k| a[k] + share * (b[k] - a[k]));
        let distance = size * magnitude(-4, 7, random);
        {
            let back = direction(random);
            towards(target, back, distance, random)
        }
    });
    Aimed {
        vertices: vertices.map(|v| v.map(from_f64)),
        rays,
    }
}

/// Any triangle, rays to points on its edges and within ulps of them.
fn near_edge(random: &mut Generator) -> Aimed {
    let size = magnitude(-10, 10, random);
    let place = in_cube(4.0 * size, random);
    let corners = [(); 3].map(|()| {
        let offset = in_cube(size, random);
        rounded(std::array::from_fn(|k| place[k] + offset[k]))
    });
    let rays = [(); 16].map(|()| {
        let from = random.random_range(0..3_usize);
        let (a, b) = (corners[from], corners[(from + 1) % 3]);
        let share = match random.random_range(0..4) {
            0 => 0.0,
            _ => random.random_range(0.0..1.0),
        };
        let target = std::array::from_fn(|k| a[k] + share * (b[k] - a[k]));
        let distance = size * magnitude(-2, 7, random);
        {
            let back = direction(random);
            towards(target, back, distance, random)
        }
    });
    Aimed {
        vertices: corners.map(|v| v.map(from_f64)),
        rays,
    }
}

impl Triangles {
    fn shoot(&self, bench: &mut Bench, aimed: &Aimed, tally: &mut Tally) {
        let object = TriangleObject {
            vertices: aimed.vertices,
            both: true,
        };
        let packets = [call::packet(&aimed.rays, 0)];
        let (after, objects) = call::pairs(bench, &packets, &[object], &[[0, 0]], 0);
        for (ray, after) in aimed.rays.iter().zip(call::rays(&after[0])) {
            let case = Case {
                line: Line::new(ray.origin, ray.direction),
                vertices: aimed.vertices,
                found: (after.object == objects[0]).then(|| to_f64(after.t)),
            };
            let input = || {
                let vertices = aimed.vertices.as_flattened();
                [vertices, &ray.origin, &ray.direction].concat()
            };
            match (self.kind.judge)(&case) {
                None => tally.uncounted(),
                Some(f64::INFINITY) => tally.wrong(input),
                Some(error) => tally.error(error, input),
            }
        }
    }
}

impl Family for Triangles {
    fn name(&self) -> &'static str {
        self.kind.name
    }

    fn subject(&self) -> &str {
        TriangleObject::KERNEL
    }

    fn unit(&self) -> &'static str {
        self.kind.unit
    }

    fn bound(&self) -> Bound {
        self.bound.clone()
    }

    fn rounds(&self) -> u32 {
        400
    }

    fn round(&self, bench: &mut Bench, random: &mut Generator, tally: &mut Tally) {
        for _ in 0..TRIANGLES {
            let aimed = (self.kind.make)(random);
            self.shoot(bench, &aimed, tally);
        }
    }

    fn replay(
        &self,
        bench: &mut Bench,
        words: &[u32],
        tally: &mut Tally,
    ) -> Result<(), NoCaseError> {
        let words: [u32; 15] = words_of(words)?;
        let point = |at: usize| [words[at], words[at + 1], words[at + 2]];
        let ray = Ray {
            origin: point(9),
            direction: point(12),
            t: FARTHEST,
            object: 0,
        };
        let aimed = Aimed {
            vertices: [point(0), point(3), point(6)],
            rays: [ray; 16],
        };
        self.shoot(bench, &aimed, tally);
        Ok(())
    }
}
