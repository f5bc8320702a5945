//! From which weight on a ray is worth starting.
//!
//! As in `docs/whitted.md`, a ray's contribution to its pixel is at most its weight times the
//! largest brightness that a ray can see, and one that can't add a sixteenth of a byte's step is
//! not started.

use glam::DVec3;
use scenes::{LightKind, Material, Scene, Shader};

use super::Options;

/// Part of a step between bytes that a ray has to be able to add.
const STEP: f64 = 1.0 / 255.0 / 16.0;

/// The minimum contribution of a shadow ray that is sent: a little less than [`STEP`].
pub(super) const MIN_LIGHT: f64 = 1.0 / 4096.0;

/// A bound of a colour's channels, as quick to compute as it gets: the single whose bits are those
/// of any channel.
pub(super) fn most(colour: DVec3) -> f64 {
    let bits = colour.to_array().map(|channel| (channel as f32).to_bits());
    f64::from(f32::from_bits(bits[0] | bits[1] | bits[2]))
}

/// The minimum weight of a ray that is started, in a scene of these materials and lights.
pub(super) fn minimum(
    scene: &Scene,
    materials: &[&Material],
    lights: &[(LightKind, DVec3)],
    options: &Options,
) -> f64 {
    let largest_channel = |colour: DVec3| options.pixels.colour.light(colour).max_element();
    let lit: f64 = lights.iter().map(|(_, brightness)| brightness.max_element().max(0.0)).sum();
    let everywhere = scene.ambient.max_element().max(0.0);
    let zenith = scene.sky.map_or(0.0, |sky| largest_channel(sky.zenith));
    let fog = scene.fog.map_or(0.0, |fog| largest_channel(fog.colour));
    let background = largest_channel(scene.background).max(zenith).max(fog).max(0.0);
    let seen = (0..options.depth).fold(0.0, |beyond, _| {
        let surfaces = materials.iter().map(|material| {
            let own = largest_channel(material.colour);
            let diffuse = |colour: f64| material.diffuse * colour * (lit + everywhere);
            let shares = [material.specular, material.transmittance];
            let shares: f64 = shares.map(|share| options.pixels.colour.share(share)).iter().sum();
            let others = shares * beyond;
            match &material.shader {
                Shader::Flat | Shader::Depth { .. } => own,
                Shader::Portal { .. } => beyond,
                Shader::Lambert => diffuse(own) + others,
                Shader::Checker { other, .. } => {
                    diffuse(own.max(largest_channel(*other))) + material.specular * lit + others
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
