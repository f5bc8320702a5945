//! Triangles with difficult inputs: needles, triangles without area, rays within ulps of edges.
//!
//! The watertight kernel's distance is a mean of the vertices' distances with weights that are not
//! below 0. However thin a triangle is, its hits are therefore between its vertices.

use crate::stability::family::Judgement;
use crate::stability::prelude::*;
use crate::stability::random::nearby;
use crate::truth::triangle::Triangle;

/// The kernel whose error the watertight one's header refers to.
const STATED: &str = "isect_triangles_r16";
/// How far from an edge a verdict may be wrong, in ulps of the farthest vertex's distance. Each
/// coordinate of the vertices is rounded twice, and the ray's slopes once.
pub const EDGE: f64 = 8.0;
/// The number of triangles in a round.
const TRIANGLES: u32 = 16;

/// A kind of cases.
struct Triangles {
    make: fn(&mut Generator) -> Aimed,
    judge: fn(&Case) -> Judgement,
}

/// A triangle and the rays to it.
struct Aimed {
    vertices: [Point; 3],
    rays: [Ray; 16],
}

/// A ray, a triangle, and the distance that the kernel found.
struct Case {
    line: Line,
    vertices: [Point; 3],
    found: Option<f64>,
}

/// A family for each kind.
pub fn families() -> Families {
    let family = |name, unit, bound, make, judge| Family {
        name,
        subject: TriangleObject::KERNEL.to_owned(),
        unit,
        bound,
        rounds: 400,
        cases: Box::new(Triangles { make, judge }),
    };
    Ok(vec![
        family(
            "triangle-needles",
            "ulp of the farthest vertex, beyond the vertices",
            Bound::of(STATED)?,
            needle,
            beyond_vertices,
        ),
        family(
            "triangle-degenerate",
            "hits",
            Bound::none("edges of one point have no area"),
            repeated,
            |case| case.found.map_or(Judgement::Error(0.0), |_| Judgement::Wrong),
        ),
        family(
            "triangle-edges",
            "ulp of the farthest vertex, off the edge",
            Bound { value: EDGE, source: "roundings of vertices and slopes".to_owned() },
            near_edge,
            off_edge,
        ),
    ])
}

/// The distance of the line between two points from the line of the triangle's nearest edge.
pub fn off_edges(vertices: &[Point; 3], from: Vector, way: Vector) -> f64 {
    let corners = vertices.map(|vertex| sub(vertex.map(to_f64), from));
    let off = (0..3).map(|k| {
        let (a, edge) = (corners[k], sub(corners[(k + 1) % 3], corners[k]));
        let across = cross(way, edge);
        dot(a, across).abs() / length(across)
    });
    off.fold(f64::INFINITY, f64::min)
}

/// The distance of the farthest vertex from the ray's origin.
fn farthest(case: &Case) -> f64 {
    let distance = |vertex: &Point| length(sub(vertex.map(to_f64), case.line.origin));
    case.vertices.iter().map(distance).fold(0.0, f64::max)
}

fn beyond_vertices(case: &Case) -> Judgement {
    let Some(found) = case.found else {
        return Judgement::Uncounted;
    };
    let way = unit(case.line.direction);
    let along = case.vertices.map(|vertex| dot(sub(vertex.map(to_f64), case.line.origin), way));
    let near = along.iter().copied().fold(f64::INFINITY, f64::min);
    let far = along.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let beyond = (near - found).max(found - far).max(0.0);
    Judgement::Error(beyond / spacing(farthest(case)))
}

fn off_edge(case: &Case) -> Judgement {
    let Some(meeting) = Triangle::new(case.vertices).meeting(&case.line) else {
        return Judgement::Uncounted;
    };
    // Almost parallel to the plane, the sign of the distance has no correct digit.
    let hit = meeting.side().is_ge() && meeting.distance > 0.0;
    Judgement::unless(hit == case.found.is_some(), || {
        let off = off_edges(&case.vertices, case.line.origin, case.line.direction);
        off / spacing(farthest(case))
    })
}

/// A ray towards a point from this distance, with almost the direction to the point.
fn aimed_at(target: Vector, back: Vector, distance: f64, random: &mut Generator) -> Ray {
    let origin = rounded(add_scaled(target, distance, back));
    let way = towards(origin, target, [0.0, 0.0, 1.0]);
    fresh(origin.map(from_f64), nearby(way, random))
}

/// A triangle that is as thin as singles allow, or whose vertices are in line, and rays to points
/// along it.
fn needle(random: &mut Generator) -> Aimed {
    let size = magnitude(-10, 10, random);
    let a = rounded(in_cube(4.0 * size, random));
    let axis = direction(random);
    let [aside, _] = across(axis, random);
    let width = if random.random_ratio(1, 4) { 0.0 } else { size * magnitude(-30, 0, random) };
    let share = random.random_range(-0.5..1.5);
    let b = add_scaled(a, size, axis);
    let c = add_scaled(add_scaled(a, share * size, axis), width, aside);
    let rays = [(); 16].map(|()| {
        let [u, v] = [(); 2].map(|()| random.random_range(0.0..0.5));
        let target = add_scaled(add_scaled(a, u, sub(b, a)), v, sub(c, a));
        // For half of the rays, all points of the triangle are at one distance.
        let [aside, _] = across(axis, random);
        let back = if random.random() { aside } else { direction(random) };
        let distance = size * magnitude(-4, 7, random);
        aimed_at(target, back, distance, random)
    });
    Aimed::new([a, b, c], rays)
}

/// A triangle of which two or three vertices coincide, and rays to that point and to the edge.
fn repeated(random: &mut Generator) -> Aimed {
    let size = magnitude(-10, 10, random);
    let a = rounded(in_cube(4.0 * size, random));
    let b = rounded(add_scaled(a, size, direction(random)));
    let mut vertices = [a, a, if random.random_ratio(1, 4) { a } else { b }];
    vertices.rotate_left(random.random_range(0..3));
    let rays = [(); 16].map(|()| {
        let share = match random.random_range(0..4) {
            0 => 0.0,
            1 => 1.0,
            _ => random.random_range(0.0..1.0),
        };
        let distance = size * magnitude(-4, 7, random);
        let back = direction(random);
        aimed_at(add_scaled(a, share, sub(b, a)), back, distance, random)
    });
    Aimed::new(vertices, rays)
}

/// Any triangle, and rays to points on its edges and within ulps of them.
fn near_edge(random: &mut Generator) -> Aimed {
    let size = magnitude(-10, 10, random);
    let place = in_cube(4.0 * size, random);
    let corners = [(); 3].map(|()| rounded(add_scaled(place, 1.0, in_cube(size, random))));
    let rays = [(); 16].map(|()| {
        let from = random.random_range(0..3_usize);
        let (a, b) = (corners[from], corners[(from + 1) % 3]);
        let share = match random.random_range(0..4) {
            0 => 0.0,
            _ => random.random_range(0.0..1.0),
        };
        let distance = size * magnitude(-2, 7, random);
        let back = direction(random);
        aimed_at(add_scaled(a, share, sub(b, a)), back, distance, random)
    });
    Aimed::new(corners, rays)
}

impl Aimed {
    fn new(vertices: [Vector; 3], rays: [Ray; 16]) -> Self {
        let vertices = vertices.map(|v| v.map(from_f64));
        Self { vertices, rays }
    }
}

impl Triangles {
    fn shoot(&self, bench: &mut Bench, aimed: &Aimed, tally: &mut Tally) {
        let object = two_sided(aimed.vertices);
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
            tally.judged((self.judge)(&case), input);
        }
    }
}

impl Cases for Triangles {
    fn round(&self, bench: &mut Bench, random: &mut Generator, tally: &mut Tally) {
        for _ in 0..TRIANGLES {
            let aimed = (self.make)(random);
            self.shoot(bench, &aimed, tally);
        }
    }

    fn replay(&self, bench: &mut Bench, words: &[u32], tally: &mut Tally) -> Replayed {
        let [a, b, c, origin, direction] = points_of(words)?;
        let aimed = Aimed { vertices: [a, b, c], rays: [fresh(origin, direction); 16] };
        self.shoot(bench, &aimed, tally);
        Ok(())
    }
}
