//! What a surface does with light at a place: its material, seen through its shader.
//!
//! Invariant: with NFF's own shader that is what the file says.

use glam::DVec3;
use nff::{Material, Shader};

/// By how much, in parts of a checker's cube, its faces are moved, so that what lies on a face of
/// the grid but for rounding is of one colour.
const OFF_GRID: f64 = 1.0 / 1024.0;

/// A material at a place.
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
    /// What it sends of itself.
    pub emission: DVec3,
    /// Whether light that falls on it counts.
    pub is_lit: bool,
    /// Whether it has the other of two colours.
    pub other: bool,
}

impl Finish {
    /// The material at a point, `distance` from where the ray started. A game's own shader counts
    /// for nothing: who uses this has refused it.
    pub(super) fn of(material: &Material, point: DVec3, distance: f64) -> Self {
        let plain = Self {
            colour: material.colour,
            diffuse: material.diffuse,
            highlight: material.specular,
            shine: material.shine,
            mirror: material.specular,
            transmittance: material.transmittance,
            refraction_index: material.refraction_index,
            emission: DVec3::ZERO,
            is_lit: true,
            other: false,
        };
        match material.shader {
            Shader::Phong | Shader::Own { .. } => plain,
            Shader::Lambert => Self {
                highlight: 0.0,
                ..plain
            },
            Shader::Flat => plain.sends(material.colour),
            Shader::Depth { far, near } => {
                let brightness = ((far - distance) / (far - near)).clamp(0.0, 1.0);
                plain.sends(brightness * material.colour)
            }
            Shader::Checker { other, size } => {
                let cube = (point / size + OFF_GRID).floor();
                let odd = cube.element_sum().rem_euclid(2.0) != 0.0;
                Self {
                    colour: if odd { other } else { plain.colour },
                    other: odd,
                    ..plain
                }
            }
        }
    }

    /// The same, but that it sends a colour of itself and nothing else.
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
