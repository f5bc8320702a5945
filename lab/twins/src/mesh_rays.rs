//! Twin of `spu/isect/mesh_rays_r16.s`, `mesh_alive_r16.s`, `mesh_filter_rays.s`,
//! `mesh_candidates.s` and `mesh_few_rays.s`: rays that go through the blocks of a mesh one by
//! one.
//!
//! Rays that stay together go through them as packets: one by one, the rays of a flat mirror make
//! the bunny slower by 4 %, and first shadow rays by 14 %.

use spu_emulator::float::single::{fa, fcgt, fcmgt, fm, fma, fnms, fs};

use super::math::reciprocal;
use super::mesh::{Corners, SLACK, TINY, maximum, minimum};
use super::primary_rays::Ray;
use super::{SIGN, Single, ZERO, below_zero, select};

/// The largest single: when a child is met that no ray meets.
const NEVER: Single = 0x7fff_ffff;

/// A ray, as its record has it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct MeshRay {
    /// Of each axis, whether the upper planes are met first.
    pub down: [bool; 3],
    /// 1 / direction.
    pub inverse: [Single; 3],
    /// Shifts of the planes that are met first.
    pub near_shift: [Single; 3],
    /// Shifts of the opposite ones.
    pub far_shift: [Single; 3],
    /// The farthest distance that counts.
    pub t: Single,
}

/// A child of a node, and the rays that meet its box.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Visit {
    /// The child's word.
    pub child: u32,
    /// When the first of them does.
    pub near: Single,
    /// A bit for each ray: the first ray's is the highest.
    pub rays: u128,
}

/// The record of a ray, by `mesh_rays_r16`.
#[must_use]
pub fn mesh_ray(ray: &Ray) -> MeshRay {
    let size = ray.origin.map(|c| c & !SIGN);
    let size = maximum(maximum(size[0], size[1]), size[2]);
    let slack = fm(size, SLACK);
    let inverse = ray.direction.map(|d| reciprocal(select(d, TINY, fcmgt(TINY, d) != 0)));
    let shift = |moved: fn(Single, Single) -> Single| {
        std::array::from_fn(|axis| {
            let signed = slack & !SIGN | inverse[axis] & SIGN;
            fnms(moved(ray.origin[axis], signed), inverse[axis], ZERO)
        })
    };
    MeshRay {
        down: inverse.map(below_zero),
        inverse,
        near_shift: shift(fa),
        far_shift: shift(fs),
        t: ray.t,
    }
}

/// Those of the rays that count farther than a distance, by `mesh_alive_r16`.
#[must_use]
pub fn alive(packets: &[[Ray; 16]], near: Single, rays: u128) -> u128 {
    let near = maximum(near, ZERO);
    packets
        .iter()
        .flatten()
        .zip(0..)
        .filter(|(ray, _)| fcgt(ray.t, near) != 0)
        .fold(0, |alive, (_, number)| alive | rays & bit(number))
}

/// A ray's bit.
#[must_use]
pub const fn bit(number: u32) -> u128 {
    1 << 127 >> number
}

/// When a ray enters a box, or `None` if it doesn't before it ends.
#[must_use]
pub fn ray_enters(ray: &MeshRay, [lower, upper]: &Corners) -> Option<Single> {
    let times: [[Single; 2]; 3] = std::array::from_fn(|axis| {
        let mut planes = [lower[axis], upper[axis]];
        if ray.down[axis] {
            planes.reverse();
        }
        [
            fma(planes[0], ray.inverse[axis], ray.near_shift[axis]),
            fma(planes[1], ray.inverse[axis], ray.far_shift[axis]),
        ]
    });
    let [[near_x, far_x], [near_y, far_y], [near_z, far_z]] = times;
    let enter = maximum(maximum(near_x, near_y), near_z);
    let leave = minimum(minimum(far_x, far_y), far_z);
    (!below_zero(fs(leave, enter) | fs(ray.t, enter) | leave)).then_some(enter)
}

/// Which rays meet the four boxes of a node, and when the first does, of those that have bits.
#[must_use]
pub fn meet(rays: &[MeshRay], bits: u128, boxes: &[Corners; 4]) -> [(u128, Single); 4] {
    boxes.map(|corners| {
        let mut met = (0, NEVER);
        for number in (0..128).filter(|number| bits & bit(*number) != 0) {
            if let Some(enter) = ray_enters(&rays[number as usize], &corners) {
                met.0 |= bit(number);
                met.1 = select(met.1, enter, fcgt(met.1, enter) != 0);
            }
        }
        met
    })
}

/// The children of a block's lowest nodes that rays meet, and how many tests with nodes that
/// takes, by `mesh_filter_rays`. Each node is four boxes and four words.
#[must_use]
pub fn filter_rays(
    rays: &[MeshRay],
    bits: u128,
    nodes: &[([Corners; 4], [u32; 4])],
) -> (Vec<Visit>, u32) {
    let mut of_nodes = vec![bits];
    let mut visits = Vec::new();
    let mut tests = 0;
    for (number, (boxes, words)) in nodes.iter().enumerate() {
        let bits = of_nodes[number];
        tests += bits.count_ones();
        let met = meet(rays, bits, boxes);
        if of_nodes.len() < nodes.len() {
            let children = words.iter().filter(|word| **word != 0).count();
            of_nodes.extend(met[..children].iter().map(|(rays, _)| rays));
        } else {
            visits.extend(
                words
                    .iter()
                    .zip(met)
                    .filter(|(_, (rays, _))| *rays != 0)
                    .map(|(&child, (rays, near))| Visit { child, near, rays }),
            );
        }
    }
    (visits, tests)
}

/// The children that rays meet, with the ray of each, by `mesh_few_rays`. The rays come in its
/// order: in turn one of each word of bits.
#[must_use]
pub fn few_rays(
    rays: &[MeshRay],
    bits: u128,
    nodes: &[([Corners; 4], [u32; 4])],
) -> Vec<(u32, u32)> {
    let mut left: [Vec<u32>; 4] = std::array::from_fn(|word| {
        let numbers = 32 * word as u32..32 * (word as u32 + 1);
        numbers.rev().filter(|number| bits & bit(*number) != 0).collect()
    });
    let mut found = Vec::new();
    while left.iter().any(|numbers| !numbers.is_empty()) {
        for number in left.iter_mut().filter_map(Vec::pop) {
            for (boxes, words) in nodes {
                for (corners, word) in boxes.iter().zip(words) {
                    if ray_enters(&rays[number as usize], corners).is_some() {
                        found.push((*word, number));
                    }
                }
            }
        }
    }
    found
}
