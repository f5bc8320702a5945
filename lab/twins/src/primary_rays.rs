//! Twin of `spu/trace/primary_rays_r16.s`: a ray of a packet, from the eye.

use super::ray_setup::{Basis, ray_setup};
use super::{FARTHEST, ONE, Single, ZERO};
use zerocopy::{FromBytes, Immutable, IntoBytes};

/// The single -1: the distance of a ray that is not there.
pub const ABSENT: Single = 0xbf80_0000;

/// Bytes of a pixel's sum.
const SUM_SIZE: u32 = 16;
/// Bytes of a tile's row of them.
const PITCH: u32 = SUM_SIZE * 64;

/// One lane of a packet.
#[derive(Clone, Copy, Debug, PartialEq, Eq, FromBytes, IntoBytes, Immutable)]
#[repr(C)]
pub struct Ray {
    /// Where it starts.
    pub origin: [Single; 3],
    /// Unit direction.
    pub direction: [Single; 3],
    /// The farthest distance that counts, or [`ABSENT`].
    pub t: Single,
    /// Address of the record of the object hit.
    pub object: u32,
    /// Share that its colour has in its pixel's.
    pub weight: Single,
    /// Address of its pixel's sum.
    pub pixel: u32,
}

/// The camera and picture that the primary rays of a frame share.
#[derive(Clone, Copy, Debug, FromBytes)]
pub struct View {
    /// The camera.
    pub basis: Basis,
    /// Address of the background's record.
    pub background: u32,
    /// Pixels across the picture.
    pub width: i32,
    /// Pixels down.
    pub height: i32,
}

/// The ray through a pixel of a packet; of its top left one `pixels` is the address of the sum.
#[must_use]
pub fn primary_ray(view: &View, pixels: u32, [left, top]: [i32; 2], lane: usize) -> Ray {
    let (column, row) = (lane as i32 % 4, lane as i32 / 4);
    let x = left.wrapping_add(column);
    let within = view.width > x && view.height.wrapping_sub(row) > top;
    let offset = SUM_SIZE * column as u32 + PITCH * row as u32;
    Ray {
        origin: [ZERO; 3],
        direction: ray_setup(&view.basis, x, top.wrapping_add(row)),
        t: if within { FARTHEST } else { ABSENT },
        object: view.background,
        weight: if within { ONE } else { ZERO },
        pixel: pixels.wrapping_add(offset),
    }
}
