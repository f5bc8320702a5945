//! What holds of whole scenes: meshes without leaks, rays that leave cleanly, symmetric shadows.

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
