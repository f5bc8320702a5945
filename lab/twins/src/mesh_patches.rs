//! Twin of `spu/isect/mesh_list_hits_r16.s` and `mesh_flat_patches.s`: the triangles of a mesh
//! that packets have hit, and their surfaces.

use spu_emulator::float::single::{fa, fm, fms, fs};

use super::math::{recip_interpolated, rsqrt};
use super::triangle::Triangle;
use super::{SIGN, Single};

/// 2^-19, as large as the slack of boxes.
const LEAVE: Single = 0x3600_0000;

/// Gives each triangle of a mesh that a packet's rays have hit a patch. Returns what the rays have
/// as their objects after that, and the objects of the patches, which are `size` apart from `first`
/// on.
#[must_use]
pub fn list_hits(objects: &[u32; 16], first: u32, size: u32) -> ([u32; 16], Vec<u32>) {
    let mut patches = *objects;
    let mut listed = Vec::new();
    for at in 0..16 {
        let object = objects[at];
        let is_same = |other: usize| objects[other] == object;
        if object & SIGN == 0 {
            continue;
        }
        patches[at] = if at % 4 > 0 && is_same(at - 1) {
            patches[at - 1]
        } else if at >= 4 && is_same(at - 4) {
            patches[at - 4]
        } else {
            listed.push(object);
            first + size * (listed.len() as u32 - 1)
        };
    }
    (patches, listed)
}

/// The surface of a triangle without normals at its vertices.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct FlatPatch {
    /// A point of it.
    pub centre: [Single; 3],
    /// Its unit normal.
    pub normal: [Single; 3],
    /// The part of `leave` that comes from its own numbers.
    pub leave: Single,
}

/// |x| + |y| + |z|
fn taxicab(vector: [Single; 3]) -> Single {
    let [x, y, z] = vector.map(|axis| axis & !SIGN);
    fa(fa(x, y), z)
}

/// The surface of a triangle.
#[must_use]
pub fn flat_patch(triangle: &Triangle) -> FlatPatch {
    let [a, b, c] = *triangle;
    let edge = |to: [Single; 3]| std::array::from_fn(|axis| fs(to[axis], a[axis]));
    let edges: [[Single; 3]; 2] = [edge(b), edge(c)];
    let [size_b, size_c] = edges.map(taxicab);
    let size = if size_c as i32 > size_b as i32 { size_c } else { size_b };
    let inverse = recip_interpolated(size);
    let [to_b, to_c] = edges.map(|edge| edge.map(|axis| fm(axis, inverse)));
    let across = |first: usize, second: usize| {
        let product = fm(to_b[second], to_c[first]);
        fms(to_b[first], to_c[second], product)
    };
    let [x, y, z] = [across(1, 2), across(2, 0), across(0, 1)];
    let square = fa(fa(fm(x, x), fm(y, y)), fm(z, z));
    let inverse = rsqrt(square);
    FlatPatch {
        centre: a,
        normal: [x, y, z].map(|axis| fm(axis, inverse)),
        leave: fm(fa(taxicab(a), size), LEAVE),
    }
}
