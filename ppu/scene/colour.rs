//! Colour spaces.

use glam::DVec3;

/// The colour space of the channels of a scene's materials and background, and
/// of pixels. The shares of what mirrors and glass show follow the colours, so that a share
/// of a colour looks like that. Lights, ambient light, Kd and highlights are linear in any case.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "choices", derive(clap::ValueEnum))]
pub enum Colour {
    /// Channels are proportional to light, as in pictures of the Standard Procedural Databases.
    #[default]
    Linear,
    /// Channels have sRGB's values, which displays and viewers of pictures expect.
    Srgb,
}

impl Colour {
    /// The light that a colour of a scene stands for.
    pub(crate) fn light(self, colour: DVec3) -> DVec3 {
        match self {
            Self::Linear => colour,
            Self::Srgb => DVec3::from_array(colour.to_array().map(decoded)),
        }
    }

    /// The share of light with which a surface shows the colours that it reflects or lets through,
    /// if that is the share of them in the material.
    pub(crate) fn seen(self, share: f64) -> f64 {
        match self {
            Self::Linear => share,
            Self::Srgb => decoded(share),
        }
    }
}

/// The linear light of an sRGB value.
fn decoded(value: f64) -> f64 {
    if value <= 0.04045 { value / 12.92 } else { libm::pow((value + 0.055) / 1.055, 2.4) }
}
