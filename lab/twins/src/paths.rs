//! Twins of `spu/isect/path_bounds_r16.s` and `paths_meet.s`: what rays have crossed, and whether
//! something has changed there.

use spu_emulator::float::estimate::{fi, frsqest};
use spu_emulator::float::single::{fa, fcgt, fm, fnms};
use zerocopy::FromBytes;

use super::bound::Bound;
use super::cull_nodes::{across, may_meet};
use super::primary_rays::Ray;
use super::{Single, below_zero};

/// 1 - 2^-12.
const NEARER: Single = 0x3f7f_f000;

/// The volume that a packet's rays have crossed, and the subtiles of their pixels.
#[derive(Clone, Copy, Debug, PartialEq, Eq, FromBytes)]
pub struct Path {
    /// The rays' bound, which ends where they do.
    pub bound: Bound,
    /// A bit for each subtile.
    pub subtiles: u32,
}

/// The path of a packet within a bound. With `to_hits` its rays end at their t. `pixels` are the
/// addresses of their pixels' sums, and `sums` is that of the tile's first pixel.
#[must_use]
pub fn path(rays: &[Ray; 16], bound: &Bound, pixels: &[u32; 16], to_hits: bool, sums: u32) -> Path {
    let subtiles = pixels.iter().map(|pixel| {
        let offset = pixel.wrapping_sub(sums);
        1 << ((offset >> 7 & 7) | (offset >> 9 & 0x18))
    });
    let farthest = if to_hits { largest(&rays.map(|ray| ray.t)) } else { bound.farthest };
    Path {
        bound: Bound { farthest, ..*bound },
        subtiles: subtiles.fold(0, |all, subtile| all | subtile),
    }
}

/// The largest of a packet's values, in the order in which the kernel compares them.
fn largest(values: &[Single; 16]) -> Single {
    let larger = |one, other| if fcgt(other, one) != 0 { other } else { one };
    let [first, second, third, fourth] = std::array::from_fn(|lane| {
        let [one, two, three, four] = std::array::from_fn(|row| values[4 * row + lane]);
        larger(larger(one, two), larger(three, four))
    });
    larger(larger(first, third), larger(second, fourth))
}

/// The subtiles with rays that may have crossed one of these spheres, each a centre and a radius.
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
    met.fold(0, |subtiles, path| subtiles | path.subtiles)
}
