//! Depth shading, the paper's model: nearer spheres are brighter. It draws only spheres.
//!
//! A sphere is one-sided: a ray hits it only where it enters, in front of the eye. So an eye
//! inside a sphere sees through it. The colour of a pixel is the material's colour times
//! [`DepthShading::brightness`], or the background if nothing is hit.
//!
//! Invariant: the brightness is from 0 to 1 for every scene and distance.

mod not_drawn;

use glam::DVec3;

use crate::{Object, Scene, Shape};

pub use not_drawn::{Kind, NotDrawn, not_drawn};

/// The distances from the eye between which brightness falls from 1 to 0.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DepthShading {
    /// The distance of brightness 1: the smallest distance of a drawn sphere from the eye, at least
    /// 0.
    pub near: f64,
    /// The distance of brightness 0: the largest distance of a drawn sphere from the eye.
    pub far: f64,
}

/// A sphere that the model draws.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DrawnSphere {
    /// Centre.
    pub centre: DVec3,
    /// Radius, more than 0.
    pub radius: f64,
    /// Index of its material in [`Scene::materials`].
    pub material: u32,
}

/// The spheres that the model draws, in file order.
pub fn drawn(scene: &Scene) -> impl Iterator<Item = DrawnSphere> {
    scene.objects.iter().filter_map(|object| match *object {
        Object { material, shape: Shape::Sphere { centre, radius }, .. } if radius > 0.0 => {
            Some(DrawnSphere { centre, radius, material })
        }
        _ => None,
    })
}

impl DepthShading {
    /// The range of a scene; from 0 to 0 without drawn spheres.
    #[must_use]
    pub fn of(scene: &Scene) -> Self {
        let spheres = drawn(scene).map(|sphere| (sphere.centre, sphere.radius));
        Self::around(scene.view.from, spheres)
    }

    /// The range of spheres, given by centres and radii, relative to an eye; from 0 to 0 without
    /// spheres.
    pub fn around(eye: DVec3, spheres: impl Iterator<Item = (DVec3, f64)>) -> Self {
        let start = (f64::INFINITY, 0.0f64);
        let (near, far) = spheres.fold(start, |(near, far), (centre, radius)| {
            let distance = centre.distance(eye);
            (near.min(distance - radius), far.max(distance + radius))
        });
        Self { near: near.clamp(0.0, far), far }
    }

    /// The brightness of a hit at `distance` from the eye. If the range has no width, as the
    /// rounding of a small scene far away can cause, the brightness is 1.
    #[must_use]
    pub fn brightness(&self, distance: f64) -> f64 {
        let range = self.far - self.near;
        if range > 0.0 { ((self.far - distance) / range).clamp(0.0, 1.0) } else { 1.0 }
    }
}

/// The bytes red, green and blue of a colour.
#[must_use]
pub fn bytes(colour: DVec3) -> [u8; 3] {
    colour.to_array().map(|channel| (channel.clamp(0.0, 1.0) * 255.0 + 0.5).floor() as u8)
}
