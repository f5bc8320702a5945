//! Guarantees about whole scenes: meshes do not leak, rays leave surfaces without hitting them,
//! and shadows are symmetric.

mod leaving;
mod mesh;
mod shadows;
mod watertight;

use super::family::Families;

/// The families of this section.
pub fn families() -> Families {
    let mut families = Vec::from(watertight::families());
    families.extend(leaving::families());
    families.extend(shadows::families()?);
    Ok(families)
}
