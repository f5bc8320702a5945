//! From which weight on a ray is worth starting.
//!
//! By `docs/numerics.md`: what a ray adds to its pixel is at most its weight times the greatest
//! brightness that a ray can see, and one that can't add a sixteenth of a byte's step is not
//! started.

use glam::DVec3;
use nff::{LightKind, Material, Scene, Shader};

/// Part of a step between bytes that a ray has to be able to add.
const STEP: f64 = 1.0 / 255.0 / 16.0;

/// The least weight of a ray that is started, in a scene of these materials and lights.
pub(super) fn least(
    scene: &Scene,
    materials: &[&Material],
    lights: &[(LightKind, DVec3)],
    depth: u32,
) -> f64 {
    let lit: f64 = lights
        .iter()
        .map(|(_, brightness)| brightness.max_element().max(0.0))
        .sum();
    let everywhere = scene.ambient.max_element().max(0.0);
    let background = scene.background.max_element().max(0.0);
    let seen = (0..depth).fold(0.0, |beyond, _| {
        let surfaces = materials.iter().map(|material| {
            let own = material.colour.max_element();
            let diffuse = |colour: f64| material.diffuse * colour * (lit + everywhere);
            let others = (material.specular + material.transmittance) * beyond;
            match &material.shader {
                Shader::Flat | Shader::Depth { .. } => own,
                Shader::Lambert => diffuse(own) + others,
                Shader::Checker { other, .. } => {
                    diffuse(own.max(other.max_element())) + material.specular * lit + others
                }
                Shader::Phong | Shader::Own { .. } => {
                    diffuse(own) + material.specular * lit + others
                }
            }
        });
        surfaces.fold(background, f64::max)
    });
    if seen > 0.0 {
        STEP / seen
    } else {
        f64::INFINITY
    }
}
