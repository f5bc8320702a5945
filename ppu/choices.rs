//! The library's choices as words of command lines: cellray's, and those of games. Their help is
//! written here because it addresses the users of command lines.

use clap::ValueEnum;

use crate::{quality, scene, work};

/// `--antialias`.
#[derive(Clone, Copy, Debug, ValueEnum)]
pub enum Antialias {
    /// No antialiasing: one ray through the pixel's centre.
    #[value(name = "1")]
    One,
    /// Four samples.
    #[value(name = "4")]
    Four,
    /// Sixteen samples.
    #[value(name = "16")]
    Sixteen,
}

impl From<Antialias> for scene::Samples {
    fn from(antialias: Antialias) -> Self {
        match antialias {
            Antialias::One => Self::One,
            Antialias::Four => Self::Four,
            Antialias::Sixteen => Self::Sixteen,
        }
    }
}

/// `--colour`.
#[derive(Clone, Copy, Debug, ValueEnum)]
pub enum Colour {
    /// They are proportional to it, as in pictures of the Standard Procedural Databases.
    Linear,
    /// They have sRGB's values, which viewers of pictures expect.
    Srgb,
}

impl From<Colour> for scene::Colour {
    fn from(colour: Colour) -> Self {
        match colour {
            Colour::Linear => Self::Linear,
            Colour::Srgb => Self::Srgb,
        }
    }
}

/// `--model`.
#[derive(Clone, Copy, Debug, Default, ValueEnum)]
pub enum Model {
    /// Whitted's model if the scene has lights, otherwise depth shading.
    #[default]
    Scene,
    /// The paper's model: spheres that fade to black with their distance.
    Depth,
    /// Whitted's model: lights, shadows, mirrors, glass, and all shapes.
    Whitted,
}

impl From<Model> for scene::Model {
    fn from(model: Model) -> Self {
        match model {
            Model::Scene => Self::Scene,
            Model::Depth => Self::Depth,
            Model::Whitted => Self::Whitted,
        }
    }
}

/// `--split`.
#[derive(Clone, Copy, Debug, Default, ValueEnum)]
pub enum Split {
    /// An SPU that has finished a work unit takes the next one.
    #[default]
    Units,
    /// Each SPU has its own consecutive part of the picture, as in the paper.
    Slices,
}

impl From<Split> for work::Split {
    fn from(split: Split) -> Self {
        match split {
            Split::Units => Self::Units,
            Split::Slices => Self::Slices,
        }
    }
}

/// `--quality`.
#[derive(Clone, Copy, Debug, Default, ValueEnum)]
pub enum Quality {
    /// The fastest formulations with pictures that are right to a step of a colour.
    Fast,
    /// The fastest formulations with distances that are right to 2 units in the last place.
    #[default]
    Default,
    /// The formulations with the least error, in double precision.
    Exact,
}

impl From<Quality> for quality::Quality {
    fn from(quality: Quality) -> Self {
        match quality {
            Quality::Fast => Self::Fast,
            Quality::Default => Self::Default,
            Quality::Exact => Self::Exact,
        }
    }
}
