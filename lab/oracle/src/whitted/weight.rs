//! From which weight on a ray is worth starting.
//!
//! By `docs/numerics.md`: what a ray adds to its pixel is at most its weight times the greatest
//! brightness that a ray can see, and one that can't add a sixteenth of a byte's step is not
//! started.

use glam::DVec3;
use scenes::{LightKind, Material, Scene, Shader};

use super::Options;

/// Part of a step between bytes that a ray has to be able to add.
const STEP: f64 = 1.0 / 255.0 / 16.0;

/// What a shadow ray has to be able to add: a little less than [`STEP`].
pub(super) const LEAST_LIGHT: f64 = 1.0 / 4096.0;

/// A bound of a colour's channels, as quick to compute as it gets: the single whose bits are those
/// of any channel.
pub(super) fn most(colour: DVec3) -> f64 {
    let bits = colour.to_array().map(|channel| (channel as f32).to_bits());
    f64::from(f32::from_bits(bits[0] | bits[1] | bits[2]))
}

/// The least weight of a ray that is started, in a scene of these materials and lights.
pub(super) fn least(
    scene: &Scene,
    materials: &[&Material],
    lights: &[(LightKind, DVec3)],
    options: &Options,
) -> f64 {
    let greatest = |colour: DVec3| options.pixels.colour.light(colour).max_element();
    let lit: f64 = lights.iter().map(|(_, brightness)| brightness.max_element().max(0.0)).sum();
    let everywhere = scene.ambient.max_element().max(0.0);
    let zenith = scene.sky.map_or(0.0, |sky| greatest(sky.zenith));
    let background = greatest(scene.background).max(zenith).max(0.0);
    let seen = (0..options.depth).fold(0.0, |beyond, _| {
        let surfaces = materials.iter().map(|material| {
            let own = greatest(material.colour);
            let diffuse = |colour: f64| material.diffuse * colour * (lit + everywhere);
            let shares = [material.specular, material.transmittance];
            let shares: f64 = shares.map(|share| options.pixels.colour.share(share)).iter().sum();
            let others = shares * beyond;
            match &material.shader {
                Shader::Flat | Shader::Depth { .. } => own,
                Shader::Lambert => diffuse(own) + others,
                Shader::Checker { other, .. } => {
                    diffuse(own.max(greatest(*other))) + material.specular * lit + others
                }
                Shader::Phong | Shader::Own { .. } => {
                    diffuse(own) + material.specular * lit + others
                }
            }
        });
        surfaces.fold(background, f64::max)
    });
    if seen > 0.0 { STEP / seen } else { f64::INFINITY }
}
