//! The records of the general intersectors, with the layout of `spu/include/rays.inc`. A test
//! compares the two.

use twins::sphere_ray;
use zerocopy::big_endian::{F32, U32};
use zerocopy::{FromBytes, Immutable, IntoBytes, KnownLayout, Unaligned};

use crate::single::{bits, single};

/// The record whose rows have a word of each lane, in the order of the words.
///
/// # Panics
///
/// Panics if the record has not as many rows as a lane has words.
#[must_use]
pub fn rows<L: IntoBytes + Immutable, R: FromBytes, const LANES: usize>(lanes: &[L; LANES]) -> R {
    let mut record = vec![0; size_of::<[L; LANES]>()];
    for (number, lane) in lanes.iter().enumerate() {
        let words = lane.as_bytes().as_chunks().0.iter();
        for (row, word) in record.chunks_exact_mut(4 * LANES).zip(words) {
            row[4 * number..][..4].copy_from_slice(&u32::from_ne_bytes(*word).to_be_bytes());
        }
    }
    R::read_from_bytes(&record).unwrap_or_else(|_| panic!("a row for each word of a lane"))
}

/// The lanes of such a record with sixteen.
///
/// # Panics
///
/// As [`rows`].
#[must_use]
pub fn lanes<L: FromBytes>(record: &(impl IntoBytes + Immutable)) -> [L; 16] {
    let (words, _) = record.as_bytes().as_chunks();
    std::array::from_fn(|lane| {
        let words = words.iter().skip(lane).step_by(16);
        let bytes: Vec<u8> =
            words.flat_map(|word| u32::from_be_bytes(*word).to_ne_bytes()).collect();
        L::read_from_bytes(&bytes).unwrap_or_else(|_| panic!("a row for each word of a lane"))
    })
}

/// Sixteen rays with separate origins.
#[derive(Clone, Copy, Debug, FromBytes, IntoBytes, Immutable, KnownLayout, Unaligned)]
#[repr(C)]
pub struct Rays {
    /// The x coordinates of the origins.
    pub origin_x: [F32; 16],
    /// The y coordinates of the origins.
    pub origin_y: [F32; 16],
    /// The z coordinates of the origins.
    pub origin_z: [F32; 16],
    /// The x components of the unit directions.
    pub direction_x: [F32; 16],
    /// The y components of the unit directions.
    pub direction_y: [F32; 16],
    /// The z components of the unit directions.
    pub direction_z: [F32; 16],
    /// The distance limit, and then the distance of the nearest hit.
    pub t: [F32; 16],
    /// The number of the object that was hit.
    pub object: [U32; 16],
}

/// One ray.
#[derive(Clone, Copy, Debug, FromBytes, IntoBytes, Immutable, KnownLayout, Unaligned)]
#[repr(C)]
pub struct Ray {
    /// The origin: x, y, z, anything.
    pub origin: [F32; 4],
    /// The unit direction: x, y, z, anything.
    pub direction: [F32; 4],
    /// The distance in the first word, as in [`Rays`]. The other words are arbitrary.
    pub t: [F32; 4],
    /// The number of the object that was hit in the first word. The other words are arbitrary.
    pub object: [U32; 4],
}

/// A sphere for rays from anywhere.
#[derive(Clone, Copy, Debug, FromBytes, IntoBytes, Immutable, KnownLayout, Unaligned)]
#[repr(C)]
pub struct BareSphere {
    /// The centre: x, y, z.
    pub centre: [F32; 3],
    /// The squared radius.
    pub radius_squared: F32,
}

impl Ray {
    /// The record of a ray. `anything` fills the fields without meaning.
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

    /// The ray in the record.
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
        Self { centre: sphere.centre.map(single), radius_squared: single(sphere.radius_squared) }
    }
}
