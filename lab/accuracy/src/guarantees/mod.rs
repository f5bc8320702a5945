//! What holds of whole scenes: meshes without leaks, rays that leave cleanly, symmetric shadows.

pub mod leaving;
pub mod mesh;
pub mod product;
pub mod shadows;
pub mod steps;
pub mod watertight;

use crate::stability::family::Family;
use crate::stability::statement::StatementError;

/// The families of this section.
///
/// # Errors
/// A bound is not where it should be.
pub fn families() -> Result<Vec<Box<dyn Family>>, StatementError> {
    let mut families: Vec<Box<dyn Family>> = Vec::new();
    families.extend(watertight::families());
    families.extend(leaving::families());
    families.extend(shadows::families()?);
    Ok(families)
}
