//! glTF's materials as those of Whitted's model.
//!
//! Base colour becomes the colour, encoded for the screen, because this tracer's colours are those
//! of pixels. A smooth surface reflects: with s = (1 - roughness)^2, the specular share is
//! s (0.04 + 0.56 metallic), and the diffuse share is the rest. A metal keeps some diffuse light,
//! because its reflection is not coloured in Whitted's model, and its colour would not show
//! otherwise.

use glam::DVec3;
use gltf::material::AlphaMode;
use nff::Material;

use crate::builder::plain;

/// Share that a smooth surface reflects head-on, as in glTF's own model.
const DIELECTRIC: f64 = 0.04;
/// What metal adds to it.
const METAL: f64 = 0.56;
/// A share that can't change a byte of the picture.
const NOTHING: f64 = 1.0 / 512.0;
/// Index of refraction of transmitting materials that state none.
const GLASS: f32 = 1.5;

/// The material, and notes on what is left out.
pub(super) fn of(material: &gltf::Material<'_>, mut note: impl FnMut(&str)) -> Material {
    let model = material.pbr_metallic_roughness();
    let [red, green, blue, alpha] = model.base_color_factor().map(f64::from);
    let is_textured = model.metallic_roughness_texture().is_some()
        || material.normal_texture().is_some()
        || material.occlusion_texture().is_some()
        || material.emissive_texture().is_some();
    if is_textured {
        note("textures other than those of base colours are ignored");
    }
    if material.emissive_factor() != [0.0; 3] {
        note("emissive colours are ignored");
    }
    let metallic = f64::from(model.metallic_factor()).clamp(0.0, 1.0);
    let roughness = f64::from(model.roughness_factor()).clamp(0.0, 1.0);
    let smoothness = (1.0 - roughness) * (1.0 - roughness);
    let specular = smoothness * (DIELECTRIC + METAL * metallic);
    let specular = if specular < NOTHING { 0.0 } else { specular };
    let transmission = material.transmission();
    let transmission = transmission.map_or(0.0, |it| f64::from(it.transmission_factor()));
    let (transmittance, index) = match material.alpha_mode() {
        _ if transmission > 0.0 => (transmission, material.ior().unwrap_or(GLASS)),
        AlphaMode::Blend => (1.0 - alpha, 1.0),
        AlphaMode::Opaque | AlphaMode::Mask => (0.0, 1.0),
    };
    let transmittance = transmittance.clamp(0.0, 1.0);
    let width = (roughness * roughness).max(0.02);
    Material {
        diffuse: (1.0 - specular) * (1.0 - transmittance),
        specular,
        // Blinn's exponent for this roughness is 2 / width^2 - 2, and Phong's a quarter of it.
        shine: ((2.0 / (width * width) - 2.0) / 4.0).clamp(1.0, 1000.0),
        transmittance,
        refraction_index: f64::from(index).clamp(1.0, 10.0),
        ..plain(DVec3::new(red, green, blue).map(encoded))
    }
}

/// Encodes a linear colour for the screen (sRGB).
fn encoded(linear: f64) -> f64 {
    let linear = linear.clamp(0.0, 1.0);
    if linear <= 0.003_130_8 {
        12.92 * linear
    } else {
        1.055 * libm::pow(linear, 1.0 / 2.4) - 0.055
    }
}
