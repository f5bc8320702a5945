//! Parallelograms as objects of a scene.

use twins::rectangle::Rectangle;
pub use twins::rectangle_pairs::RectangleObject;
use twins::rectangle_pairs::isect_rectangle;
use twins::sphere_ray::Ray;

use super::shape::{Shape, Truth, head_words, one_sided};
use crate::cases::flat::{around_rectangle, on_plane, rectangle};
use crate::flat_records;
use crate::prelude::*;

/// The smallest distance of a point from an edge, in u and v, on either side.
const EDGE: f64 = 5e-4;
/// The smallest cosine of a ray's incidence, which limits how parallel to the plane it may be.
const INCIDENCE: f64 = 0.1;

impl Shape for RectangleObject {
    const KERNEL: &'static str = "isect_rectangle_pairs_r16";
    type Record = layout::Rectangle;

    fn record(&self, anything: u32) -> layout::Rectangle {
        let Rectangle { point, normal, dual_u, dual_v } = self.rectangle;
        let sides = one_sided(self.both, anything);
        layout::Rectangle {
            object: head_words(point, normal, anything, sides, anything),
            dual_u: quad(dual_u, anything),
            dual_v: quad(dual_v, anything),
        }
    }

    fn twin(&self, ray: Ray, object: u32) -> Ray {
        isect_rectangle(ray, self, object)
    }

    fn truth(&self, ray: &Ray) -> Truth {
        let flat = flat_records::Ray::new(ray.origin, ray.direction);
        let ([t, u, v], incidence) = on_plane(&flat, &self.rectangle);
        let from_corner = sub(self.rectangle.point.map(to_f64), ray.origin.map(to_f64));
        let normal = self.rectangle.normal.map(to_f64);
        let seen = self.both || dot(normal, ray.direction.map(to_f64)) < 0.0;
        let within = [u, v].iter().all(|on| (0.0..=1.0).contains(on));
        let off_edges = [u, v, 1.0 - u, 1.0 - v].iter().all(|on| on.abs() > EDGE);
        let far = dot(from_corner, from_corner).sqrt() / 2.0;
        let counts = incidence > INCIDENCE && t.abs() > far;
        Truth {
            t: (t > 0.0 && seen && within).then_some(t),
            unit: t.abs() * 2_f64.powi(-23),
            counts,
            sure: counts && off_edges,
        }
    }

    fn ahead(x: f64, distance: f64) -> Self {
        let corner = [x - 1.0, -1.0, -distance];
        Self { rectangle: rectangle(corner, [2.0, 0.0, 0.0], [0.0, 2.0, 0.0]), both: false }
    }

    fn around(random: &mut ChaCha8Rng, scale: f64) -> (Self, [Ray; 16]) {
        let (mut rectangle, rays, _) = around_rectangle(random);
        let scaled = |point: [u32; 3], by: f64| point.map(|c| from_f64(to_f64(c) * by));
        rectangle.point = scaled(rectangle.point, scale);
        rectangle.dual_u = scaled(rectangle.dual_u, 1.0 / scale);
        rectangle.dual_v = scaled(rectangle.dual_v, 1.0 / scale);
        // A quarter of the rays points away from it.
        let rays = std::array::from_fn(|lane| Ray {
            origin: scaled(rays[lane].origin, scale),
            direction: scaled(rays[lane].direction, if lane % 4 == 3 { -1.0 } else { 1.0 }),
            t: FARTHEST,
            object: 0,
        });
        let both = random.random();
        (Self { rectangle, both }, rays)
    }

    fn junk(random: &mut ChaCha8Rng) -> Self {
        Self { rectangle: any_bits(random), both: random.random() }
    }
}
