//! Kernels with the inputs for which single precision is worst.

mod chains;
mod estimates;
mod extremes;
mod refraction;
pub mod spheres;
pub mod triangles;

use super::family::Families;

/// The families of this section.
pub fn families() -> Families {
    let parts = [
        spheres::families()?,
        triangles::families()?,
        refraction::families()?,
        chains::families()?,
        estimates::families()?,
        extremes::families(),
    ];
    Ok(parts.into_iter().flatten().collect())
}
