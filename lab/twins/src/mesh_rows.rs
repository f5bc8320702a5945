//! Twin of `spu/isect/mesh_eye_bounds_r16.s`, `filter_triangles_r16.s` and `isect_mesh_rows_r4.s`:
//! rays from the eye and the triangles of a mesh.
//!
//! Edges are not tested as planes through the eye: the cross product of two vertices has no digits
//! left for a small and distant triangle, whose edges move by a sixteenth of a pixel. Testing the
//! lowest boxes with the rays themselves leaves out 17 % of the triangles, and costs more than
//! that.

use spu_emulator::float::single::{fa, fcgt, fcmgt, fm, fs};

use super::flat::over;
use super::math::reciprocal;
use super::mesh::{MeshBound, maximum, minimum, slab};
use super::mesh_pairs::MeshBlock;
use super::sphere_ray::Ray;
use super::triangle::Triangle;
use super::triangle_pairs::isect_triangle;
use super::{ONE, SIGN, Single, ZERO, below_zero, select};

/// The largest single.
const LARGEST: Single = 0x7fff_ffff;
/// Less the largest single.
const SMALLEST: Single = 0xffff_ffff;
/// -1: the farthest distance of a packet without rays.
const ABSENT: Single = 0xbf80_0000;
/// The single before 1/2.
const BELOW_HALF: Single = 0x3eff_ffff;
/// 2^-18.
const SLACK: Single = 0x3680_0000;

/// The limits of a row's slopes: of direction x/z, and of direction y/z.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct RowWindow {
    /// The smallest values.
    pub low: [Single; 2],
    /// The largest values.
    pub high: [Single; 2],
}

/// Where the rays of a packet from the eye go.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct MeshWindow {
    /// Which component of a point is x, y, z here.
    pub axes: [usize; 3],
    /// The rows.
    pub rows: [RowWindow; 4],
}

/// The extreme of four lanes.
fn extreme(lanes: [Single; 4], extreme: fn(Single, Single) -> Single) -> Single {
    extreme(extreme(lanes[0], lanes[1]), extreme(lanes[2], lanes[3]))
}

/// Two numbers in order.
fn ordered(a: Single, b: Single) -> [Single; 2] {
    if fcgt(a, b) != 0 { [b, a] } else { [a, b] }
}

/// The extremes of rays' directions along each axis, and of their distances.
#[derive(Clone, Copy, Debug)]
struct EyeExtremes {
    directions: [[Single; 2]; 3],
    farthest: Single,
}

fn eye_extremes(rays: &[Ray; 16]) -> EyeExtremes {
    let over = |value: &dyn Fn(&Ray) -> Single, over_rows: fn(Single, Single) -> Single| {
        std::array::from_fn(|lane| {
            let mut rows = (0..4).map(|row| value(&rays[4 * row + lane]));
            let first = rows.next().unwrap_or(ABSENT);
            rows.fold(first, over_rows)
        })
    };
    let later = |a: Single, b: Single| select(a, b, b as i32 > a as i32);
    let directions = std::array::from_fn(|axis| {
        let along = |ray: &Ray| ray.direction[axis];
        let min = extreme(over(&along, minimum), minimum);
        [min, extreme(over(&along, maximum), maximum)]
    });
    let farthest = over(&|ray| later(ABSENT, ray.t), later);
    EyeExtremes { directions, farthest: extreme(farthest, maximum) }
}

impl EyeExtremes {
    /// Those of two.
    fn with(self, other: Self) -> Self {
        let [own, others] = [self.directions, other.directions];
        let both = |axis: usize| {
            let ([min, max], [other_min, other_max]) = (own[axis], others[axis]);
            [minimum(min, other_min), maximum(max, other_max)]
        };
        let farthest = maximum(self.farthest, other.farthest);
        Self { directions: [0, 1, 2].map(both), farthest }
    }

    fn bound(self) -> MeshBound {
        let slabs = self.directions.map(|extremes| slab([ZERO; 2], extremes));
        MeshBound { slabs, slack: 0, farthest: self.farthest }
    }
}

/// The bound of a packet's rays from the eye, by `mesh_eye_bounds_r16`.
#[must_use]
pub fn mesh_eye_bound(rays: &[Ray; 16]) -> MeshBound {
    eye_extremes(rays).bound()
}

/// The bound of all packets' rays, by `mesh_eye_bounds_r16`.
#[must_use]
pub fn mesh_eye_bound_of_all(packets: &[[Ray; 16]]) -> MeshBound {
    let none = EyeExtremes { directions: [[LARGEST, SMALLEST]; 3], farthest: SMALLEST };
    packets.iter().map(eye_extremes).fold(none, EyeExtremes::with).bound()
}

/// The window of a packet's rays, by `mesh_eye_bounds_r16`.
#[must_use]
pub fn mesh_window(rays: &[Ray; 16]) -> MeshWindow {
    let [dx, dy, dz] = rays[0].direction;
    let of_two = usize::from(fcmgt(dy, dx) != 0);
    let longest = if fcmgt(dz, [dx, dy][of_two]) != 0 { 2 } else { of_two };
    let axes = [(longest + 1) % 3, (longest + 2) % 3, longest];
    let sign = rays[0].direction[longest] & SIGN;
    let is_wide = rays.iter().any(|ray| fcgt(ray.direction[longest] ^ sign, BELOW_HALF) == 0);
    let limits = |row: usize, axis: usize| {
        let slopes: [Single; 4] = std::array::from_fn(|lane| {
            let direction = rays[4 * row + lane].direction;
            fm(direction[axes[axis]], reciprocal(direction[longest]))
        });
        let [low, high] = ordered(slopes[0], slopes[1]);
        let [other_low, other_high] = ordered(slopes[2], slopes[3]);
        if is_wide {
            [SMALLEST, LARGEST]
        } else {
            [fs(minimum(low, other_low), SLACK), fa(maximum(high, other_high), SLACK)]
        }
    };
    let window = |row| {
        let [x, y] = [0, 1].map(|axis| limits(row, axis));
        RowWindow { low: [x[0], y[0]], high: [x[1], y[1]] }
    };
    MeshWindow { axes, rows: [0, 1, 2, 3].map(window) }
}

impl MeshWindow {
    /// Whether each row may hit a triangle, by `filter_triangles_r16`.
    #[must_use]
    pub fn may_hit(&self, triangle: &Triangle) -> [bool; 4] {
        let seen = triangle.map(|vertex| self.axes.map(|axis| vertex[axis]));
        let [depth_a, depth_b, depth_c] = seen.map(|[_, _, z]| z);
        let crosses = below_zero((depth_a ^ depth_b) | (depth_a ^ depth_c));
        let projected = seen.map(|[x, y, z]| [x, y].map(|across| fm(across, over(ONE, z))));
        let limits = [0, 1].map(|axis| {
            let [a, b, c] = projected.map(|vertex| vertex[axis]);
            let [low, high] = ordered(a, b);
            [minimum(low, c), maximum(high, c)]
        });
        self.rows.map(|row| {
            let outside = (0..2).any(|axis| {
                let [low, high] = limits[axis];
                fcgt(row.low[axis], high) != 0 || fcgt(low, row.high[axis]) != 0
            });
            crosses || !outside
        })
    }
}

impl MeshBlock {
    /// A row of rays after its test with a triangle, by `isect_mesh_rows_r4`.
    pub fn isect_row(&self, rays: &mut [Ray], index: usize) {
        for ray in rays {
            *ray = isect_triangle(*ray, &self.triangle(index), self.hit(index));
        }
    }
}
