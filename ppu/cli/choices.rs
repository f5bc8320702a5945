//! The library's choices as words of the command line. Their help is written here: it speaks to
//! those who type.

use cellray::scene;
use cellray::work;
use clap::ValueEnum;

/// `--model`.
#[derive(Clone, Copy, Debug, Default, ValueEnum)]
pub enum Model {
    /// Whitted's if the scene has lights, else depth shading.
    #[default]
    Scene,
    /// The paper's: spheres that fade to black with their distance.
    Depth,
    /// Whitted's: lights, shadows, mirrors, glass, all shapes.
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
    /// Each SPU takes the next work unit when it has finished one.
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
    /// The fastest whose pictures are right to a step of a colour.
    Fast,
    /// The fastest that keeps distances to 2 units in the last place.
    #[default]
    Default,
    /// The least error, in double precision.
    Exact,
}

impl From<Quality> for cellray::Quality {
    fn from(quality: Quality) -> Self {
        match quality {
            Quality::Fast => Self::Fast,
            Quality::Default => Self::Default,
            Quality::Exact => Self::Exact,
        }
    }
}
