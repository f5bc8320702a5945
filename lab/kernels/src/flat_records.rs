//! The records of the kernels for flat shapes, with the layout of `spu/include/flat.inc`. A test
//! compares the two.

use rand::Rng;
use spu_emulator::float::single::from_f64;
use twins::flat::FlatHit;
use twins::triangle::Shear;
use twins::{FARTHEST, Single};
use zerocopy::big_endian::{F32, U32};
use zerocopy::{FromBytes, FromZeros as _, Immutable, IntoBytes, KnownLayout, Unaligned};

use crate::single::{bits, single};
use crate::vector::Vector;
pub use protocol::layout::Shear as Shears;

/// A point or a direction in singles.
pub type Point = [Single; 3];

/// The singles nearest to a vector.
#[must_use]
pub fn point(vector: Vector) -> Point {
    vector.map(from_f64)
}

/// A vector in a record. Its fourth word has no meaning.
#[must_use]
pub fn quad([x, y, z]: Point, anything: u32) -> [F32; 4] {
    [x, y, z, anything].map(single)
}

/// A ray and its hit so far.
#[derive(Clone, Copy, Debug, FromBytes, IntoBytes, Immutable)]
#[repr(C)]
pub struct Ray {
    /// The ray's origin.
    pub origin: Point,
    /// The ray's direction.
    pub direction: Point,
    /// The ray's hit.
    pub hit: FlatHit,
}

/// The hit of a ray that has hit nothing.
pub const NO_HIT: FlatHit = FlatHit { t: FARTHEST, object: 0, u: 0, v: 0 };

impl Ray {
    /// A ray that has hit nothing.
    #[must_use]
    pub fn new(origin: Point, direction: Point) -> Self {
        Self { origin, direction, hit: NO_HIT }
    }
}

/// Sixteen rays and their hits.
#[derive(Clone, Copy, Debug, FromBytes, IntoBytes, Immutable, KnownLayout, Unaligned)]
#[repr(C)]
pub struct Rays {
    /// The origins, one axis after the other.
    pub origin: [[F32; 16]; 3],
    /// The directions.
    pub direction: [[F32; 16]; 3],
    /// The distance limit, and then the distance of the nearest hit.
    pub t: [F32; 16],
    /// The number of the object that was hit.
    pub object: [U32; 16],
    /// The first coordinate of the hit on the object.
    pub u: [F32; 16],
    /// The second coordinate.
    pub v: [F32; 16],
}

/// One ray. In the last four fields, only the first word has a meaning.
#[derive(Clone, Copy, Debug, FromBytes, IntoBytes, Immutable, KnownLayout, Unaligned)]
#[repr(C)]
pub struct OneRay {
    /// The origin: x, y, z, anything.
    pub origin: [F32; 4],
    /// The direction: x, y, z, anything.
    pub direction: [F32; 4],
    /// The distance limit, and then the distance of the nearest hit.
    pub t: [F32; 4],
    /// The number of the object that was hit.
    pub object: [U32; 4],
    /// The first coordinate of the hit on the object.
    pub u: [F32; 4],
    /// The second coordinate.
    pub v: [F32; 4],
}

impl OneRay {
    /// The record of a ray. `random` fills the fields without meaning.
    pub fn new(ray: &Ray, random: &mut impl Rng) -> Self {
        let mut record = Self::new_zeroed();
        random.fill(record.as_mut_bytes());
        record.origin = quad(ray.origin, random.random());
        record.direction = quad(ray.direction, random.random());
        record.t[0] = single(ray.hit.t);
        record.object[0] = ray.hit.object.into();
        record.u[0] = single(ray.hit.u);
        record.v[0] = single(ray.hit.v);
        record
    }

    /// The hit in the record.
    #[must_use]
    pub fn hit(&self) -> FlatHit {
        FlatHit {
            t: bits(self.t[0]),
            object: self.object[0].get(),
            u: bits(self.u[0]),
            v: bits(self.v[0]),
        }
    }
}

/// The shear of one lane's ray in a record.
///
/// # Panics
///
/// Panics if its axes are not components of a vertex.
#[must_use]
pub fn shear(record: &Shears, lane: usize) -> Shear {
    // The shuffle of component k selects bytes 4k to 4k + 3.
    let axes = [record.axis_x, record.axis_y, record.axis_z];
    let axes = axes.map(|axis| axis.as_flattened()[lane].get());
    for axis in axes {
        assert_eq!(axis, 0x0001_0203 + 0x0101_0101 * (axis >> 24), "{axis:x}");
    }
    Shear {
        axes: axes.map(|axis| (axis >> 24) as usize / 4),
        origin: [record.origin_x, record.origin_y, record.origin_z].map(|axis| bits(axis[lane])),
        slopes: [record.slope_x, record.slope_y].map(|axis| bits(axis[lane])),
        minus_per_z: bits(record.minus_per_z[lane]),
    }
}
