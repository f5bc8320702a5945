//! The finish of a surface at a point: its material after its shader.
//!
//! Invariant: with NFF's default shader the finish equals the material in the file.

use glam::{DAffine3, DQuat, DVec3};
use scenes::{Material, Shader};

use crate::Colour;

/// By how much the faces of a checker's cubes are moved, relative to a cube, so that a surface on
/// a face of the grid has one colour in spite of rounding.
const OFF_GRID: f64 = 1.0 / 1024.0;

/// A material at a point.
#[derive(Debug, Clone, Copy)]
pub(super) struct Finish {
    pub colour: DVec3,
    /// Diffuse share.
    pub diffuse: f64,
    /// Share of the highlight.
    pub highlight: f64,
    /// Exponent of Phong's highlight.
    pub shine: f64,
    /// Share that is reflected.
    pub mirror: f64,
    /// Share that is let through.
    pub transmittance: f64,
    pub refraction_index: f64,
    /// The emitted light.
    pub emission: DVec3,
    /// Whether the emitted light has the colour in it.
    pub is_flat: bool,
    /// Whether lights illuminate it.
    pub is_lit: bool,
    /// Whether it has the second colour of a checker.
    pub other: bool,
    /// Where rays go on from a portal.
    pub portal: Option<DAffine3>,
}

impl Finish {
    /// The material at a point, `distance` from the ray's origin. A game's own shader is ignored
    /// here, because the caller has refused it.
    pub(super) fn of(material: &Material, point: DVec3, distance: f64, meaning: Colour) -> Self {
        let own = meaning.light(material.colour);
        let plain = Self {
            colour: own,
            diffuse: material.diffuse,
            highlight: material.specular,
            shine: material.shine,
            mirror: meaning.share(material.specular),
            transmittance: meaning.share(material.transmittance),
            refraction_index: material.refraction_index,
            emission: meaning.light(material.emission),
            is_flat: false,
            is_lit: true,
            other: false,
            portal: None,
        };
        match material.shader {
            Shader::Phong | Shader::Own { .. } => plain,
            Shader::Lambert => Self { highlight: 0.0, ..plain },
            Shader::Flat => Self { is_flat: true, ..plain.sends(own + plain.emission) },
            Shader::Depth { far, near } => {
                let brightness = ((far - distance) / (far - near)).clamp(0.0, 1.0);
                plain.sends(brightness * own)
            }
            Shader::Portal { by, turn } => {
                let turn = DQuat::from_rotation_y(turn.to_radians());
                let portal = Some(DAffine3::from_rotation_translation(turn, by));
                Self { portal, ..plain.sends(DVec3::ZERO) }
            }
            Shader::Checker { other, size } => {
                let cube = (point / size + OFF_GRID).floor();
                let odd = cube.element_sum().rem_euclid(2.0) != 0.0;
                Self { colour: if odd { meaning.light(other) } else { own }, other: odd, ..plain }
            }
        }
    }

    /// The same finish with its colour multiplied, also where that is the light it emits.
    pub(super) fn tinted(self, factor: DVec3) -> Self {
        let colour = self.colour * factor;
        let emission = match self.is_flat {
            true => self.emission + colour - self.colour,
            false => self.emission,
        };
        Self { colour, emission, ..self }
    }

    /// The same finish, but it only emits a colour.
    fn sends(self, emission: DVec3) -> Self {
        Self {
            diffuse: 0.0,
            highlight: 0.0,
            mirror: 0.0,
            transmittance: 0.0,
            emission,
            is_lit: false,
            ..self
        }
    }
}
