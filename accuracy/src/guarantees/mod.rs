//! What holds of whole scenes: meshes without leaks, rays that leave cleanly, symmetric shadows.

pub mod leaving;
pub mod mesh;
pub mod product;
pub mod shadows;
pub mod steps;
pub mod watertight;

use crate::stability::family::Family;

/// The families of this section.
#[must_use]
pub fn families() -> Vec<Box<dyn Family>> {
    let mut families: Vec<Box<dyn Family>> = Vec::new();
    families.extend(watertight::families());
    families.extend(leaving::families());
    families.extend(shadows::families());
    families
}
