//! The common imports of the descriptions of kernels and of their tests.

pub use std::ops::Range;

pub use protocol::layout;
pub use protocol::layout::{RayPacket, Surfaces};
pub use rand::{Rng, SeedableRng};
pub use rand_chacha::ChaCha8Rng;
pub use spu_emulator::float::single::{from_f64, to_f64};
pub use twins::{FARTHEST, ONE, Single, ZERO};
pub use zerocopy::big_endian::{F32, U32};
pub use zerocopy::{FromBytes, FromZeros, IntoBytes};

pub use crate::bench::{Bench, Place, SEED, random};
pub use crate::cases::eye::call::{address, put};
pub use crate::cases::sphere_ray::any_direction;
pub use crate::catalogue::{Kernel, Objects, case};
pub use crate::description::{ANY_SHARE, Bits, Description, LENGTHS_FROM_0, any_bits};
pub use crate::eye_records::Vectors;
pub use crate::flat_records::{point, quad};
pub use crate::records::{lanes, rows};
pub use crate::single::{bits, single};
pub use crate::vector::{Vector, cross, dot, in_cube, magnitude, sub, unit};
