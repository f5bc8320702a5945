//! glTF's materials as those of Whitted's model.
//!
//! Base colour becomes the colour, encoded for the screen, because this tracer's colours are those
//! of pixels. A smooth surface reflects: with s = (1 - roughness)^2, the specular share is
//! s (0.04 + 0.56 metallic), and the diffuse share is the rest. A metal keeps some diffuse light,
//! because its reflection is not coloured in Whitted's model, and its colour would not show
//! otherwise.

use glam::DVec3;
use scenes::{Material, Shader};

use super::json;
use crate::colours::encoded;
use crate::notes::Notes;

/// Share that a smooth surface reflects head-on, as in glTF's own model.
const DIELECTRIC: f64 = 0.04;
/// The additional reflectance of metal.
const METAL: f64 = 0.56;
/// A share that can't change a byte of the picture.
const NOTHING: f64 = 1.0 / 512.0;
/// Index of refraction of transmitting materials that state none.
const GLASS: f64 = 1.5;
/// The alpha from which on a surface with holes is there, if a material states none.
const CUTOFF: f64 = 0.5;
/// The maximum light that a surface emits: it is white for all eyes.
const BRIGHTEST: f64 = 16.0;

/// The effect of alpha.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Alpha {
    Opaque,
    /// The surface is where alpha is at least this.
    Mask(f64),
    /// Alpha mixes the surface with the background.
    Blend,
}

impl Alpha {
    pub fn of(material: &json::Material) -> Self {
        match material.alpha_mode.as_str() {
            "MASK" => Self::Mask(material.alpha_cutoff.unwrap_or(CUTOFF)),
            "BLEND" => Self::Blend,
            _ => Self::Opaque,
        }
    }
}

/// The material without its texture, and notes on what is left out.
pub(super) fn of(material: &json::Material, notes: &mut Notes) -> Material {
    let model = &material.pbr_metallic_roughness;
    let [red, green, blue, alpha] = model.base_color_factor;
    let is_textured = model.metallic_roughness_texture.is_some()
        || material.normal_texture.is_some()
        || material.occlusion_texture.is_some();
    if is_textured {
        notes.add("textures other than those of base colours are ignored");
    }
    let metallic = model.metallic_factor.clamp(0.0, 1.0);
    let roughness = model.roughness_factor.clamp(0.0, 1.0);
    let smoothness = (1.0 - roughness) * (1.0 - roughness);
    let specular = smoothness * (DIELECTRIC + METAL * metallic);
    let specular = if specular < NOTHING { 0.0 } else { specular };
    let extensions = &material.extensions;
    let transmission = extensions.transmission.as_ref();
    let transmission = transmission.map_or(0.0, |it| it.transmission_factor);
    let (transmittance, index) = match Alpha::of(material) {
        _ if transmission > 0.0 => {
            let index = extensions.ior.as_ref().map_or(GLASS, |it| it.ior);
            (transmission, index)
        }
        Alpha::Blend => (1.0 - alpha, 1.0),
        Alpha::Opaque | Alpha::Mask(_) => (0.0, 1.0),
    };
    let transmittance = transmittance.clamp(0.0, 1.0);
    let width = (roughness * roughness).max(0.02);
    let colour = DVec3::new(red, green, blue).clamp(DVec3::ZERO, DVec3::ONE);
    let shader = if extensions.unlit.is_some() {
        notes.add(
            "unlit materials (KHR_materials_unlit) have their colours without light and shadow",
        );
        Shader::Flat
    } else {
        Shader::Phong
    };
    Material {
        diffuse: (1.0 - specular) * (1.0 - transmittance),
        specular,
        // Blinn's exponent for this roughness is 2 / width^2 - 2, and Phong's a quarter of it.
        shine: ((2.0 / (width * width) - 2.0) / 4.0).clamp(1.0, 1000.0),
        transmittance,
        refraction_index: index.clamp(1.0, 10.0),
        emission: emission(material, notes),
        shader,
        ..Material::matte(colour.map(encoded))
    }
}

/// The light that a surface emits. Without its texture, the factor would make all of it shine.
fn emission(material: &json::Material, notes: &mut Notes) -> DVec3 {
    let strength = material.extensions.emissive_strength.as_ref();
    let strength = strength.map_or(1.0, |it| it.emissive_strength);
    let light = strength * DVec3::from(material.emissive_factor);
    if light == DVec3::ZERO || material.extensions.unlit.is_some() {
        return DVec3::ZERO;
    }
    if material.emissive_texture.is_some() {
        notes.add("light that emissive textures send is ignored");
        return DVec3::ZERO;
    }
    light.clamp(DVec3::ZERO, DVec3::splat(BRIGHTEST)).map(encoded)
}
