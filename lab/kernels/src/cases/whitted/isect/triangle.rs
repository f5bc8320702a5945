//! Triangles as objects of a scene.

use twins::sphere_ray::Ray;
pub use twins::triangle_pairs::TriangleObject;
use twins::triangle_pairs::isect_triangle;

use super::call;
use super::shape::{Shape, Truth, head_words, one_sided};
use crate::cases::flat::{aimed_at_triangle, on_triangle};
use crate::flat_records;
use crate::prelude::*;

/// The smallest distance of a point from an edge, in barycentric coordinates, on either side.
const EDGE: f64 = 8e-5;
/// The smallest area that counts: twice the area across the ray, relative to the square of the
/// longest edge.
const AREA: f64 = 0.1;

/// The exact result for a ray and a triangle. The verdict is not certain for points within `edge`
/// of an edge, on either side.
pub(super) fn truth(shape: &TriangleObject, ray: &Ray, edge: f64) -> Truth {
    let flat = flat_records::Ray::new(ray.origin, ray.direction);
    let [t, u, v] = on_triangle(&flat, &shape.vertices);
    let w = 1.0 - u - v;
    let [a, b, c] = shape.vertices.map(|vertex| vertex.map(to_f64));
    let edges = [sub(b, a), sub(c, b), sub(a, c)];
    let longest = edges.map(|edge| dot(edge, edge)).into_iter();
    let normal = cross(edges[0], edges[1]);
    let along = dot(normal, ray.direction.map(to_f64));
    let counts = along.abs() > AREA * longest.fold(0.0, f64::max);
    let within = [u, v, w].iter().all(|on| *on >= 0.0);
    Truth {
        t: (t > 0.0 && within && (shape.both || along < 0.0)).then_some(t),
        unit: t.abs() * 2_f64.powi(-23),
        counts,
        sure: counts && [u, v, w].iter().all(|on| on.abs() > edge),
    }
}

/// Calls a kernel that intersects candidates of triangles, by name, with one triangle and each of
/// the packets. Returns the packets after the call, and the address of the triangle's record,
/// which is the object of the rays that hit it. `anything` fills the fields that kernels ignore.
///
/// # Panics
///
/// Panics if there is no such kernel, or if the packets do not fit; there is capacity for 40.
pub fn pairs_by(
    bench: &mut Bench,
    kernel: &str,
    packets: &[RayPacket],
    triangle: &TriangleObject,
    anything: u32,
) -> (Vec<RayPacket>, u32) {
    bench.reset();
    let list: Vec<[usize; 2]> = (0..packets.len()).map(|packet| [0, packet]).collect();
    let placed = call::place(bench, packets, &[*triangle], &list, anything);
    bench.call(kernel, &[placed.candidates, list.len() as u32]);
    (bench.read_all(placed.packets), placed.objects[0])
}

impl Shape for TriangleObject {
    const KERNEL: &'static str = "isect_triangle_pairs_r16";
    const SHEARED: bool = true;
    type Record = layout::Triangle;

    fn record(&self, anything: u32) -> layout::Triangle {
        let [a, b, c] = self.vertices.map(|vertex| quad(vertex, anything));
        let sides = one_sided(self.both, anything);
        layout::Triangle {
            object: head_words([anything; 3], [anything; 3], anything, sides, anything),
            a,
            b,
            c,
        }
    }

    fn twin(&self, ray: Ray, object: u32) -> Ray {
        isect_triangle(ray, self, object)
    }

    fn truth(&self, ray: &Ray) -> Truth {
        truth(self, ray, EDGE)
    }

    fn ahead(x: f64, distance: f64) -> Self {
        let corners = [[-1.0, -1.0], [1.0, -1.0], [0.0, 1.0]];
        Self {
            vertices: corners.map(|[across, up]| point([x + across, up, -distance])),
            both: false,
        }
    }

    fn around(random: &mut ChaCha8Rng, scale: f64) -> (Self, [Ray; 16]) {
        let (aimed, vertices) = aimed_at_triangle(random);
        let scaled = |point: [u32; 3]| point.map(|c| from_f64(to_f64(c) * scale));
        let (origin, vertices) = (scaled(aimed.origin), vertices.map(scaled));
        let corners = vertices.map(|vertex| vertex.map(to_f64));
        let rays = std::array::from_fn(|lane| {
            let [u, v] = [(); 2].map(|()| random.random_range(-0.2..0.8));
            let weights: Vector = [u, v, 1.0 - u - v];
            let target: Vector = std::array::from_fn(|axis| {
                (0..3).map(|corner| weights[corner] * corners[corner][axis]).sum()
            });
            let towards = unit(sub(target, origin.map(to_f64)));
            // A quarter of the rays points away from it.
            let way = if lane % 4 == 3 { -1.0 } else { 1.0 };
            Ray {
                origin,
                direction: point(towards.map(|component| way * component)),
                t: FARTHEST,
                object: 0,
            }
        });
        let both = random.random();
        (Self { vertices, both }, rays)
    }

    fn junk(random: &mut ChaCha8Rng) -> Self {
        Self { vertices: random.random(), both: random.random() }
    }
}
