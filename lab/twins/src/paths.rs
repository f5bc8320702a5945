//! Twins of `spu/isect/path_bounds_r16.s` and `paths_meet.s`: what rays have crossed, and whether
//! something has changed there.

use spu_emulator::float::estimate::{fi, frsqest};
use spu_emulator::float::single::{fa, fm, fnms};
use zerocopy::FromBytes;

use super::bound::Bound;
use super::cull_nodes::{across, may_meet};
use super::primary_rays::Ray;
use super::{Single, below_zero};

/// 1 - 2^-12.
const NEARER: Single = 0x3f7f_f000;

/// The volume that a packet's rays have crossed, and the blocks of their pixels.
#[derive(Clone, Copy, Debug, PartialEq, Eq, FromBytes)]
pub struct Path {
    /// The rays' bound, which ends where they do.
    pub bound: Bound,
    /// A bit for each block.
    pub blocks: u32,
}

/// The path of a packet within a bound. With `to_hits` its rays end at their t. `pixels` are the
/// addresses of their pixels' sums, and `sums` is that of the tile's first pixel.
#[must_use]
pub fn path(rays: &[Ray; 16], bound: &Bound, pixels: &[u32; 16], to_hits: bool, sums: u32) -> Path {
    let farthest = rays.iter().map(|ray| ray.t.cast_signed()).max().unwrap_or_default();
    let blocks = pixels.iter().map(|pixel| {
        let offset = pixel.wrapping_sub(sums);
        1 << ((offset >> 7 & 7) | (offset >> 9 & 0x18))
    });
    let farthest = if to_hits { farthest.cast_unsigned() } else { bound.farthest };
    Path { bound: Bound { farthest, ..*bound }, blocks: blocks.fold(0, |all, block| all | block) }
}

/// The blocks with rays that may have crossed one of these spheres, each a centre and a radius.
#[must_use]
pub fn meet(paths: &[Path], spheres: &[([Single; 3], Single)]) -> u32 {
    let meets = |bound: &Bound, centre, radius| {
        let perp = across(bound, centre);
        let perp = fm(perp, fi(perp, frsqest(perp)));
        let reach = fa(fa(radius, bound.radius), bound.farthest);
        may_meet(bound, centre, radius) && !below_zero(fnms(perp, NEARER, reach))
    };
    let met = paths
        .iter()
        .filter(|path| spheres.iter().any(|&(centre, radius)| meets(&path.bound, centre, radius)));
    met.fold(0, |blocks, path| blocks | path.blocks)
}
