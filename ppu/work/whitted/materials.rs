//! Materials and lights in the SPUs' form.
//!
//! Invariant: a material's flags say all that its shares can do.

use glam::DVec3;
use nff::{Material, Scene};
use zerocopy::FromZeros as _;

use super::BlockError;
use super::objects::single;
use super::range::Place;
use crate::scene::singles;
use crate::work::layout::{
    self, MATERIAL_LIT, MATERIAL_MIRRORS, MATERIAL_SHINES, MATERIAL_TRANSMITS,
};

/// By what the exponent of Phong's highlight is multiplied for Blinn's.
const BLINN: f64 = 4.0;

/// What a scene's background is made of.
pub(super) fn background(scene: &Scene) -> Result<layout::Material, BlockError> {
    let place = Place {
        file: &scene.name,
        line: None,
    };
    place.vector("background", scene.background)?;
    Ok(layout::Material {
        emission: singles(scene.background),
        ..layout::Material::new_zeroed()
    })
}

/// The record of a material.
pub(super) fn record(
    scene: &Scene,
    material: &Material,
    fresnel: bool,
) -> Result<layout::Material, BlockError> {
    let &Material {
        line,
        colour,
        diffuse,
        specular,
        shine,
        transmittance,
        refraction_index,
    } = material;
    let place = Place {
        file: &scene.name,
        line: Some(line),
    };
    place.vector("colour", colour)?;
    for (what, value) in [
        ("Kd", diffuse),
        ("Ks", specular),
        ("shine", shine),
        ("T", transmittance),
    ] {
        place.number(what, value)?;
    }
    // What lets nothing through has no index, whatever the file says.
    let index = if transmittance > 0.0 {
        if refraction_index == 0.0 {
            let file = scene.name.clone();
            return Err(BlockError::RefractionIndex { file, line });
        }
        place.size("index of refraction", refraction_index)?;
        refraction_index
    } else {
        1.0
    };
    let (schlick, grazing) = if fresnel && transmittance > 0.0 {
        let head_on = ((1.0 - index) / (1.0 + index)).powi(2);
        (head_on, 1.0 - head_on)
    } else {
        (0.0, 0.0)
    };
    let flag = |set: bool, flag: u32| if set { flag } else { 0 };
    let flags = flag(transmittance > 0.0, MATERIAL_TRANSMITS)
        // What lets through reflects where it does so totally.
        | flag(specular > 0.0 || transmittance > 0.0, MATERIAL_MIRRORS)
        | flag(diffuse > 0.0 || specular > 0.0, MATERIAL_LIT)
        | flag(specular > 0.0, MATERIAL_SHINES);
    Ok(layout::Material {
        colour: singles(colour),
        diffuse: single(diffuse),
        highlight: single(specular),
        exponent: single(BLINN * shine),
        mirror: single(specular),
        transmittance: single(transmittance),
        inverse_index: single(index.recip()),
        index: single(index),
        schlick: single(schlick),
        grazing: single(grazing),
        flags: flags.into(),
        ..layout::Material::new_zeroed()
    })
}

/// A light as it stands in the scene, with its record but for the place.
pub(super) struct Light {
    position: DVec3,
    record: layout::Light,
}

impl Light {
    /// A light of a scene.
    pub fn of(scene: &Scene, light: &nff::Light) -> Result<Self, BlockError> {
        let place = Place {
            file: &scene.name,
            line: Some(light.line),
        };
        let brightness = scene.brightness(light);
        place.vector("light", light.position)?;
        place.vector("brightness", brightness)?;
        let record = layout::Light {
            brightness: singles(brightness),
            ..layout::Light::new_zeroed()
        };
        Ok(Self {
            position: light.position,
            record,
        })
    }

    /// Its record as seen from `eye`.
    pub fn record(&self, eye: DVec3) -> layout::Light {
        layout::Light {
            position: singles(self.position - eye),
            ..self.record
        }
    }
}
