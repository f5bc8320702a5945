//! Exact intersection of rays with triangles.

use std::cmp::Ordering;

use spu_emulator::float::single::to_f64;
use twins::Single;

use super::bounded::Bounded;
use super::exact::Exact;
use super::space::{Number, Vector, cross, dot, sub};
use super::{DOUBT, Line, spacing};

/// A triangle's vertices as exact numbers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Triangle {
    vertices: [Vector; 3],
}

/// The point where a ray's line meets the plane of a triangle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Meeting {
    pub distance: f64,
    /// The weights of the vertices at the point. Their sum is 1.
    pub weights: [f64; 3],
    /// On which side of each edge the point is, relative to the opposite vertex: `Greater` inside,
    /// `Equal` on the edge.
    pub sides: [Ordering; 3],
    /// Whether the vertices are in counter-clockwise order as seen by the ray.
    pub front: bool,
}

impl Meeting {
    /// Whether the point is inside the triangle, on its edge, or outside.
    pub fn side(&self) -> Ordering {
        self.sides.into_iter().min().unwrap_or(Ordering::Less)
    }
}

/// The products that decide: of the ray with each edge, of the ray with the plane, and of the
/// plane with the origin.
struct Volumes<T> {
    edges: [T; 3],
    plane: T,
    origin: T,
}

impl<T: Number> Volumes<T> {
    fn new(vertices: [[T; 3]; 3], origin: &[T; 3], direction: &[T; 3]) -> Self {
        let [ab, ac] = [1, 2].map(|other| sub(&vertices[other], &vertices[0]));
        let normal = cross(&ab, &ac);
        let seen = vertices.map(|vertex| sub(&vertex, origin));
        let edge = |from: usize, to: usize| dot(direction, &cross(&seen[from], &seen[to]));
        Self {
            edges: [edge(1, 2), edge(2, 0), edge(0, 1)],
            plane: dot(direction, &normal),
            origin: dot(&seen[0], &normal),
        }
    }
}

impl Triangle {
    /// A triangle that a kernel receives.
    pub fn new(vertices: [[Single; 3]; 3]) -> Self {
        Self { vertices: vertices.map(|vertex| vertex.map(to_f64)) }
    }

    pub fn vertices(&self) -> [Vector; 3] {
        self.vertices
    }

    /// Where a ray's line meets the plane. `None` if they are parallel, or if the vertices define
    /// no plane.
    pub fn meeting(&self, line: &Line) -> Option<Meeting> {
        self.in_double(line).unwrap_or_else(|| self.in_exact(line))
    }

    /// The result in double precision, unless its error is too large.
    fn in_double(&self, line: &Line) -> Option<Option<Meeting>> {
        let volumes = Volumes::new(
            self.vertices.map(|vertex| vertex.map(Bounded::from)),
            &line.origin.map(Bounded::from),
            &line.direction.map(Bounded::from),
        );
        let plane = volumes.plane.sign()?;
        if plane == Ordering::Equal {
            return Some(None);
        }
        let [a, b, c] = volumes.edges.map(|edge| edge.sign().map(|sign| against(sign, plane)));
        let sides = [a?, b?, c?];
        let d = line.direction.map(Bounded::from);
        let distance = volumes.origin / volumes.plane * dot(&d, &d).sqrt();
        let weights = volumes.edges.map(|edge| edge / volumes.plane);
        let sure = distance.error <= DOUBT * spacing(distance.value)
            && weights.iter().all(|on| on.error <= DOUBT * spacing(1.0));
        sure.then(|| {
            Some(Meeting {
                distance: distance.value,
                weights: weights.map(|weight| weight.value),
                sides,
                front: plane == Ordering::Less,
            })
        })
    }

    /// The result with exact numbers.
    fn in_exact(&self, line: &Line) -> Option<Meeting> {
        let d = line.direction.map(Exact::from);
        let volumes = Volumes::new(
            self.vertices.map(|vertex| vertex.map(Exact::from)),
            &line.origin.map(Exact::from),
            &d,
        );
        let plane = volumes.plane.sign();
        if plane == Ordering::Equal {
            return None;
        }
        let distance = volumes.origin / volumes.plane.clone() * dot(&d, &d).sqrt();
        Some(Meeting {
            distance: distance.to_f64(),
            sides: volumes.edges.each_ref().map(|edge| against(edge.sign(), plane)),
            weights: volumes.edges.map(|edge| (edge / volumes.plane.clone()).to_f64()),
            front: plane == Ordering::Less,
        })
    }
}

/// A sign as seen from the ray's side of the plane.
fn against(sign: Ordering, plane: Ordering) -> Ordering {
    match plane {
        Ordering::Less => sign.reverse(),
        _ => sign,
    }
}

#[cfg(test)]
mod tests {
    use crate::generator::Generator;
    use rand::{Rng as _, SeedableRng as _};
    use spu_emulator::float::single::from_f64;

    use super::*;

    fn triangle(vertices: [Vector; 3]) -> Triangle {
        Triangle::new(vertices.map(|vertex| vertex.map(from_f64)))
    }

    fn line(origin: Vector, direction: Vector) -> Line {
        Line::new(origin.map(from_f64), direction.map(from_f64))
    }

    const CORNER: [Vector; 3] = [[0.0; 3], [4.0, 0.0, 0.0], [0.0, 4.0, 0.0]];

    #[test]
    fn whole_numbers_give_exact_results() {
        let corner = triangle(CORNER);
        for (way, front) in [(-2.0, true), (2.0, false)] {
            let line = line([1.0, 2.0, -4.0 * way], [0.0, 0.0, way]);
            let expected = Meeting {
                distance: 8.0,
                weights: [0.25, 0.25, 0.5],
                sides: [Ordering::Greater; 3],
                front,
            };
            assert_eq!(corner.in_double(&line), Some(Some(expected)));
            assert_eq!(corner.in_exact(&line), Some(expected));
        }
    }

    #[test]
    fn edges_and_vertices_are_separated_from_both_sides() {
        let corner = triangle(CORNER);
        let down = |x, y| corner.meeting(&line([x, y, 3.0], [0.0, 0.0, -1.0]));
        let side = |x, y| down(x, y).unwrap().side();
        assert_eq!(side(2.0, 2.0), Ordering::Equal);
        assert_eq!(side(0.0, 4.0), Ordering::Equal);
        assert_eq!(side(2.0, 2.0 + 2_f64.powi(-22)), Ordering::Less);
        assert_eq!(side(2.0, 2.0 - 2_f64.powi(-22)), Ordering::Greater);
        let small = 2_f64.powi(-126);
        assert_eq!(side(1.0, -small), Ordering::Less);
        assert_eq!(side(1.0, small), Ordering::Greater);
    }

    #[test]
    fn degenerate_or_parallel_triangle_is_missed() {
        let along = line([1.0, 1.0, 3.0], [1.0, 3.0, 0.0]);
        assert_eq!(triangle(CORNER).meeting(&along), None);
        let flat = triangle([[0.1, 0.2, 0.3], [0.4, 0.5, 0.6], [0.1, 0.2, 0.3]]);
        assert_eq!(flat.meeting(&line([1.0; 3], [-0.9, -0.8, -0.7])), None);
    }

    #[test]
    fn double_precision_keeps_its_bound() {
        let mut random = Generator::seed_from_u64(8);
        let mut sure = 0;
        for number in 0..4000 {
            let mut point = |half: f64| [0; 3].map(|_| random.random_range(-half..half));
            let mut vertices = [point(1.0), point(1.0), point(1.0)];
            if number % 2 == 0 {
                // A needle.
                vertices[2] = std::array::from_fn(|axis| {
                    vertices[0][axis] + 0.3 * (vertices[1][axis] - vertices[0][axis]) + 3e-3
                });
            }
            let origin = point(100.0);
            let direction = std::array::from_fn(|axis| vertices[2][axis] * 0.9 - origin[axis]);
            let (triangle, line) = (triangle(vertices), line(origin, direction));
            let Some(Some(double)) = triangle.in_double(&line) else {
                continue;
            };
            sure += 1;
            let exact = triangle.in_exact(&line).unwrap();
            assert_eq!((double.sides, double.front), (exact.sides, exact.front));
            let off = (double.distance - exact.distance).abs();
            assert!(off <= 1.01 * DOUBT * spacing(exact.distance));
            for (double, exact) in double.weights.iter().zip(exact.weights) {
                assert!((double - exact).abs() <= 1.01 * DOUBT * spacing(1.0));
            }
        }
        assert!(sure > 3000, "{sure} sure");
    }
}
