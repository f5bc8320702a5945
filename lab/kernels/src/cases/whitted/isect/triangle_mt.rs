//! Triangles as objects of a scene, for the kernel with Möller and Trumbore's test.

use twins::sphere_ray::Ray;
use twins::triangle_mt_pairs::isect_triangle;

use super::shape::{Shape, Truth};
use super::triangle::{TriangleObject, truth};
use crate::prelude::*;

/// The smallest distance of a point from an edge, in barycentric coordinates, on either side.
const EDGE: f64 = 2e-4;

/// A triangle for Möller and Trumbore's test.
#[derive(Clone, Copy, Debug)]
pub struct MoellerTrumbore(pub TriangleObject);

impl Shape for MoellerTrumbore {
    const KERNEL: &'static str = "isect_triangle_mt_pairs_r16";
    type Record = layout::Triangle;

    fn record(&self, anything: u32) -> layout::Triangle {
        self.0.record(anything)
    }

    fn twin(&self, ray: Ray, object: u32) -> Ray {
        isect_triangle(ray, &self.0, object)
    }

    fn truth(&self, ray: &Ray) -> Truth {
        truth(&self.0, ray, EDGE)
    }

    fn ahead(x: f64, distance: f64) -> Self {
        Self(TriangleObject::ahead(x, distance))
    }

    fn around(random: &mut ChaCha8Rng, scale: f64) -> (Self, [Ray; 16]) {
        let (triangle, rays) = TriangleObject::around(random, scale);
        (Self(triangle), rays)
    }

    fn junk(random: &mut ChaCha8Rng) -> Self {
        Self(TriangleObject::junk(random))
    }
}
