//! Records of `spu/include/flat.inc`, their packing, and random rays: what the tests of triangles and
//! of rectangles share.

use kernels::Bench;
use kernels::single::{bits, single};
use oracle::twin::flat::FlatHit;
use oracle::twin::triangle::Shear;
use oracle::twin::{FARTHEST, Single};
use rand::Rng;
use spu_emulator::float::single::from_f64;
use zerocopy::big_endian::{F32, U32};
use zerocopy::{FromBytes, FromZeros as _, Immutable, IntoBytes, KnownLayout, Unaligned};

pub type Point = [Single; 3];

/// Sixteen rays, with where they hit.
#[derive(Clone, Copy, FromBytes, IntoBytes, Immutable, KnownLayout, Unaligned)]
#[repr(C)]
pub struct Rays {
    pub origin: [[F32; 16]; 3],
    pub direction: [[F32; 16]; 3],
    pub t: [F32; 16],
    pub object: [U32; 16],
    pub u: [F32; 16],
    pub v: [F32; 16],
}

/// What `shear_r16` makes of them.
#[derive(FromBytes, IntoBytes, Immutable, KnownLayout, Unaligned)]
#[repr(C)]
pub struct ShearRecord {
    axes: [[U32; 16]; 3],
    origin: [[F32; 16]; 3],
    slopes: [[F32; 16]; 2],
    minus_per_z: [F32; 16],
}

impl ShearRecord {
    pub fn lane(&self, lane: usize) -> Shear {
        // The shuffle of component k takes bytes 4k to 4k + 3.
        let axes = self.axes.map(|axis| axis[lane].get());
        for axis in axes {
            assert_eq!(axis, 0x0001_0203 + 0x0101_0101 * (axis >> 24), "{axis:x}");
        }
        Shear {
            axes: axes.map(|axis| (axis >> 24) as usize / 4),
            origin: self.origin.map(|axis| bits(axis[lane])),
            slopes: self.slopes.map(|axis| bits(axis[lane])),
            minus_per_z: bits(self.minus_per_z[lane]),
        }
    }
}

/// The packets' shears. Leaves the bench empty: what one kernel of a bench writes is not there for
/// every version of the next.
pub fn sheared(bench: &mut Bench, packets: &[Rays]) -> Vec<ShearRecord> {
    bench.reset();
    let records = packets
        .iter()
        .map(|rays| {
            let rays = bench.place(rays.as_bytes());
            let record = bench.junk::<ShearRecord>();
            bench.call("shear_r16", &[rays.address, record.address]);
            bench.read(record)
        })
        .collect();
    bench.reset();
    records
}

/// A ray and what it has hit so far.
#[derive(Clone, Copy, Debug)]
pub struct Ray {
    pub origin: Point,
    pub direction: Point,
    pub hit: FlatHit,
}

pub const NO_HIT: FlatHit = FlatHit {
    t: FARTHEST,
    object: 0,
    u: 0,
    v: 0,
};

impl Ray {
    pub fn new(origin: Point, direction: Point) -> Self {
        Self {
            origin,
            direction,
            hit: NO_HIT,
        }
    }

    /// Any bits at all.
    pub fn junk(random: &mut impl Rng) -> Self {
        Self {
            origin: random.random(),
            direction: random.random(),
            hit: FlatHit {
                t: random.random(),
                object: random.random(),
                u: random.random(),
                v: random.random(),
            },
        }
    }
}

impl Rays {
    pub fn pack(rays: &[Ray; 16]) -> Self {
        let mut packed = Self::new_zeroed();
        for (lane, ray) in rays.iter().enumerate() {
            for axis in 0..3 {
                packed.origin[axis][lane] = single(ray.origin[axis]);
                packed.direction[axis][lane] = single(ray.direction[axis]);
            }
            packed.t[lane] = single(ray.hit.t);
            packed.object[lane] = ray.hit.object.into();
            packed.u[lane] = single(ray.hit.u);
            packed.v[lane] = single(ray.hit.v);
        }
        packed
    }

    pub fn hits(&self) -> [FlatHit; 16] {
        std::array::from_fn(|lane| FlatHit {
            t: bits(self.t[lane]),
            object: self.object[lane].get(),
            u: bits(self.u[lane]),
            v: bits(self.v[lane]),
        })
    }
}

/// A vector of a record: its fourth word counts for nothing.
pub fn quad(vector: Point, random: &mut impl Rng) -> [F32; 4] {
    let [x, y, z] = vector;
    [x, y, z, random.random()].map(single)
}

/// The bits of sixteen rays for which something is true, as the any-hit kernels return them.
pub fn code(blocked: [bool; 16]) -> u32 {
    blocked
        .into_iter()
        .fold(0, |code, blocked| code << 1 | u32::from(blocked))
}

pub fn point(values: [f64; 3]) -> Point {
    values.map(from_f64)
}

pub fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    std::array::from_fn(|k| a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3])
}

pub fn less(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    std::array::from_fn(|axis| a[axis] - b[axis])
}

pub fn unit(a: [f64; 3]) -> [f64; 3] {
    let length = dot(a, a).sqrt();
    a.map(|component| component / length)
}

/// Within the cube of that half side.
pub fn in_cube(half: f64, random: &mut impl Rng) -> [f64; 3] {
    std::array::from_fn(|_| random.random_range(-half..half))
}

/// Evenly spread over orders of magnitude.
pub fn magnitude(range: std::ops::Range<f64>, random: &mut impl Rng) -> f64 {
    random.random_range(range.start.ln()..range.end.ln()).exp()
}

/// Ulps of a single at `exact` by which `found` is off.
pub fn ulps(found: f64, exact: f64) -> f64 {
    (found - exact).abs() / exact.abs() * 2_f64.powi(23)
}

/// Holds a kernel to the numbers after `Error` in its header, which are what its author promises.
pub fn keeps_stated_errors(kernel: &str, worst: &[f64]) {
    let source = kernels::source::Source::find(kernel).expect("a kernel");
    let header = source.header().expect("a header");
    let words = header
        .error
        .split_whitespace()
        .filter_map(|word| word.parse().ok());
    let stated: Vec<f64> = words.take(worst.len()).collect();
    println!("{kernel}: worst errors {worst:?}, stated {stated:?}");
    assert_eq!(stated.len(), worst.len(), "{}", header.error);
    for (worst, stated) in worst.iter().zip(stated) {
        assert!(*worst <= stated, "{kernel}: error {worst}, stated {stated}");
    }
}
