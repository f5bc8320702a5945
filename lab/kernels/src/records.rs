//! Records of the general intersectors, as `spu/include/rays.inc` lays them out; a test compares
//! the two.

use twins::sphere_ray;
use zerocopy::big_endian::{F32, U32};
use zerocopy::{FromBytes, FromZeros as _, Immutable, IntoBytes, KnownLayout, Unaligned};

use crate::single::{bits, single};

/// Sixteen rays with origins of their own.
#[derive(Clone, Copy, Debug, FromBytes, IntoBytes, Immutable, KnownLayout, Unaligned)]
#[repr(C)]
pub struct Rays {
    /// Origins, x.
    pub origin_x: [F32; 16],
    /// Origins, y.
    pub origin_y: [F32; 16],
    /// Origins, z.
    pub origin_z: [F32; 16],
    /// Unit directions, x.
    pub direction_x: [F32; 16],
    /// Unit directions, y.
    pub direction_y: [F32; 16],
    /// Unit directions, z.
    pub direction_z: [F32; 16],
    /// The farthest distance that counts; then the nearest hit's.
    pub t: [F32; 16],
    /// Number of the object hit.
    pub object: [U32; 16],
}

/// One ray.
#[derive(Clone, Copy, Debug, FromBytes, IntoBytes, Immutable, KnownLayout, Unaligned)]
#[repr(C)]
pub struct Ray {
    /// Origin: x, y, z, anything.
    pub origin: [F32; 4],
    /// Unit direction: x, y, z, anything.
    pub direction: [F32; 4],
    /// In the first word the distance, as of [`Rays`]; else anything.
    pub t: [F32; 4],
    /// In the first word the number of the object hit; else anything.
    pub object: [U32; 4],
}

/// A sphere for rays from anywhere.
#[derive(Clone, Copy, Debug, FromBytes, IntoBytes, Immutable, KnownLayout, Unaligned)]
#[repr(C)]
pub struct BareSphere {
    /// Centre: x, y, z.
    pub centre: [F32; 3],
    /// Radius squared.
    pub radius_squared: F32,
}

impl Rays {
    /// The record of these rays.
    #[must_use]
    pub fn new(rays: &[sphere_ray::Ray; 16]) -> Self {
        let mut record = Self::new_zeroed();
        for (lane, ray) in rays.iter().enumerate() {
            [
                record.origin_x[lane],
                record.origin_y[lane],
                record.origin_z[lane],
            ] = ray.origin.map(single);
            [
                record.direction_x[lane],
                record.direction_y[lane],
                record.direction_z[lane],
            ] = ray.direction.map(single);
            record.t[lane] = single(ray.t);
            record.object[lane] = ray.object.into();
        }
        record
    }

    /// The rays of the record.
    #[must_use]
    pub fn rays(&self) -> [sphere_ray::Ray; 16] {
        std::array::from_fn(|lane| sphere_ray::Ray {
            origin: [self.origin_x, self.origin_y, self.origin_z].map(|axis| bits(axis[lane])),
            direction: [self.direction_x, self.direction_y, self.direction_z]
                .map(|axis| bits(axis[lane])),
            t: bits(self.t[lane]),
            object: self.object[lane].get(),
        })
    }
}

impl Ray {
    /// The record of a ray; `anything` fills what has no meaning.
    #[must_use]
    pub fn new(ray: &sphere_ray::Ray, anything: u32) -> Self {
        let vector = |[x, y, z]: [u32; 3]| [x, y, z, anything].map(single);
        let first = |value| [value, anything, anything, anything];
        Self {
            origin: vector(ray.origin),
            direction: vector(ray.direction),
            t: first(ray.t).map(single),
            object: first(ray.object).map(U32::new),
        }
    }

    /// The ray of the record.
    #[must_use]
    pub fn ray(&self) -> sphere_ray::Ray {
        let vector = |[x, y, z, _]: [F32; 4]| [x, y, z].map(bits);
        sphere_ray::Ray {
            origin: vector(self.origin),
            direction: vector(self.direction),
            t: bits(self.t[0]),
            object: self.object[0].get(),
        }
    }
}

impl BareSphere {
    /// The record of a sphere.
    #[must_use]
    pub fn new(sphere: &sphere_ray::BareSphere) -> Self {
        Self {
            centre: sphere.centre.map(single),
            radius_squared: single(sphere.radius_squared),
        }
    }
}
