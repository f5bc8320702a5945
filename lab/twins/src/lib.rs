//! Twins of the SPU's kernels: the same operations in the same order, on the SPU's own arithmetic,
//! one lane at a time. A kernel's test compares with its twin bit for bit; the twin, being Rust,
//! is also the clear statement of what the kernel computes.
//!
//! Singles are bit patterns here, as in [`spu_emulator::float`]: the host's `f32` is another
//! format.

pub mod accumulate;
pub mod bounce;
pub mod bound;
pub mod build;
pub mod colour;
pub mod cone;
pub mod cull;
pub mod cull_box_nodes;
pub mod cull_faces;
pub mod cull_nodes;
pub mod cuts;
pub mod display;
pub mod flat;
pub mod height;
pub mod isect_pairs;
pub mod light;
pub mod lists;
pub mod load_rays;
pub mod math;
pub mod mesh;
pub mod mesh_pairs;
pub mod mesh_patches;
pub mod mesh_prepare;
pub mod mesh_rays;
pub mod mesh_rows;
pub mod objects;
pub mod pack;
pub mod pairs;
pub mod paths;
pub mod primary_rays;
pub mod ray_setup;
pub mod rectangle;
pub mod rectangle_pairs;
pub mod refine_hits;
pub mod reflect;
pub mod refract;
pub mod sample_rays;
pub mod shade_depth;
pub mod shader;
pub mod shades;
pub mod shadow_rays;
pub mod smooth;
pub mod sort;
pub mod sphere;
pub mod sphere_pairs;
pub mod sphere_ray;
pub mod surfaces;
pub mod texture;
pub mod triangle;
pub mod triangle_mt_pairs;
pub mod triangle_pairs;

use spu_emulator::float::single::{fm, fma};

/// Bit pattern of a single.
pub type Single = u32;

/// The single 0.
pub const ZERO: Single = 0;
/// The single 1/2.
pub const HALF: Single = 0x3f00_0000;
/// The single 1.
pub const ONE: Single = 0x3f80_0000;
/// The single 2^62: the distance of no hit.
pub const FARTHEST: Single = 0x5e80_0000;

/// The sign of a word.
const SIGN: u32 = 0x8000_0000;

/// a . b
fn dot([ax, ay, az]: [Single; 3], [bx, by, bz]: [Single; 3]) -> Single {
    fma(az, bz, fma(ay, by, fm(ax, bx)))
}

/// The result of the select after a compare: `chosen` where the compare was true.
fn select(otherwise: u32, chosen: u32, condition: bool) -> u32 {
    if condition { chosen } else { otherwise }
}

/// Whether a single has no sign and is not +0: above 0, if it is no denormal.
const fn above_zero(value: Single) -> bool {
    value.cast_signed() > 0
}

/// Whether a single's sign is set, which is all that a mask of signs asks for: -0 is below 0.
const fn below_zero(value: Single) -> bool {
    value >> 31 != 0
}
