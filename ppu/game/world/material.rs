//! Materials and lights.

use std::sync::Arc;

use glam::DVec3;
use scenes::{LightKind, Shader, Texture};

/// How an object looks. The fields are those of NFF's `f` and `#cellray shader`.
///
/// ```
/// use cellray::game::{DVec3, Material, Shader};
///
/// let gold = Material { shine: 40.0, ..Material::shiny(1.0, 0.8, 0.3) };
/// let tiles = Material {
///     shader: Shader::Checker { other: DVec3::splat(0.1), size: 1.0 },
///     ..Material::matte(0.9, 0.9, 0.9)
/// };
/// assert_eq!(gold.specular, 0.3);
/// assert_ne!(gold, tiles);
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Material {
    /// Red, green and blue, from 0 to 1.
    pub colour: DVec3,
    /// Diffuse share, Kd.
    pub diffuse: f64,
    /// Specular share, Ks: of the highlight and of the reflected light.
    pub specular: f64,
    /// Exponent of Phong's highlight.
    pub shine: f64,
    /// Share of the light that passes through, T; 0 is opaque.
    pub transmittance: f64,
    /// Index of refraction.
    pub refraction_index: f64,
    /// Light that it sends by itself, in addition to what other light does there.
    pub emission: DVec3,
    /// The shader that computes the colour; [`Shader::Own`] names one of the SPU program's.
    pub shader: Shader,
    /// A factor of the colour on meshes with texture coordinates.
    pub texture: Option<Arc<Texture>>,
}

impl Material {
    /// A material without highlight and reflection. Colours are from 0 to 1.
    #[must_use]
    pub fn matte(red: f64, green: f64, blue: f64) -> Self {
        Self {
            colour: DVec3::new(red, green, blue),
            diffuse: 1.0,
            specular: 0.0,
            shine: 1.0,
            transmittance: 0.0,
            refraction_index: 1.0,
            emission: DVec3::ZERO,
            shader: Shader::Phong,
            texture: None,
        }
    }

    /// A material with a highlight, which reflects three tenths of the light.
    #[must_use]
    pub fn shiny(red: f64, green: f64, blue: f64) -> Self {
        Self { diffuse: 0.7, specular: 0.3, shine: 20.0, ..Self::matte(red, green, blue) }
    }

    /// A mirror that reflects nearly all light.
    #[must_use]
    pub fn mirror() -> Self {
        Self { diffuse: 0.1, specular: 0.9, shine: 100.0, ..Self::matte(1.0, 1.0, 1.0) }
    }

    /// Glass that lets nearly all light through, with the refraction of crown glass.
    #[must_use]
    pub fn glass() -> Self {
        Self {
            diffuse: 0.0,
            specular: 0.1,
            shine: 100.0,
            transmittance: 0.9,
            refraction_index: 1.5,
            ..Self::matte(1.0, 1.0, 1.0)
        }
    }

    /// A material that shows its colour unchanged, whatever the light.
    #[must_use]
    pub fn flat(red: f64, green: f64, blue: f64) -> Self {
        Self { shader: Shader::Flat, ..Self::matte(red, green, blue) }
    }
}

impl Material {
    /// The same material in a scene; error messages name `line`.
    pub(super) fn into_nff(self, line: u32) -> scenes::Material {
        scenes::Material {
            line,
            colour: self.colour,
            diffuse: self.diffuse,
            specular: self.specular,
            shine: self.shine,
            transmittance: self.transmittance,
            refraction_index: self.refraction_index,
            emission: self.emission,
            shader: self.shader,
            texture: self.texture,
        }
    }
}

impl From<&scenes::Material> for Material {
    fn from(material: &scenes::Material) -> Self {
        Self {
            colour: material.colour,
            diffuse: material.diffuse,
            specular: material.specular,
            shine: material.shine,
            transmittance: material.transmittance,
            refraction_index: material.refraction_index,
            emission: material.emission,
            shader: material.shader.clone(),
            texture: material.texture.clone(),
        }
    }
}

/// A point light or a directional light.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Light {
    /// The light's position or direction.
    pub kind: LightKind,
    /// The light's colour. Without one it is a grey that depends on the number of lights (see
    /// [`scenes::Scene::brightness`]).
    pub colour: Option<DVec3>,
}

impl Light {
    /// A point light at a position.
    #[must_use]
    pub fn at(position: impl Into<DVec3>) -> Self {
        let position = position.into();
        Self { kind: LightKind::Point { position, range: f64::INFINITY }, colour: None }
    }

    /// A directional light, infinitely far away in the direction `to_light`.
    #[must_use]
    pub fn sun(to_light: impl Into<DVec3>) -> Self {
        let to_light = to_light.into();
        Self { kind: LightKind::Directional { to_light }, colour: None }
    }

    /// The same light, which fades towards a distance and lights nothing beyond it. A light that is
    /// infinitely far stays as it is.
    #[must_use]
    pub fn within(self, range: f64) -> Self {
        match self.kind {
            LightKind::Point { position, .. } => {
                Self { kind: LightKind::Point { position, range }, ..self }
            }
            LightKind::Directional { .. } => self,
        }
    }

    /// The same light with a colour.
    #[must_use]
    pub fn coloured(self, red: f64, green: f64, blue: f64) -> Self {
        Self { colour: Some(DVec3::new(red, green, blue)), ..self }
    }
}
