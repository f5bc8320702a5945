//! The options that several command lines have: cellray's, and those of games. Their help is
//! written here because it addresses the users of command lines. The words of a choice are the
//! variants of the library's own types.

use std::ops::RangeInclusive;
use std::path::PathBuf;
use std::time::Duration;

use clap::Args;

use crate::scene::{CONTRAST, Colour, Look, Model, RenderOptions, Samples};
use crate::spe::{Program, ProgramError};

/// A scene, and how light is traced in it.
#[derive(Args, Debug)]
pub struct SceneChoices {
    /// Scene: an NFF file, a mesh (.obj, .ply or .glb), or a generated one: sphereflake:LEVEL,
    /// tetra:LEVEL, terrain:LEVEL, or gears, mount, rings, teapot, tree, lattice, jacks, shells or
    /// sombrero, with :SIZE if it is not to have SPD's
    pub scene: PathBuf,
    /// Model that the scene is rendered with
    #[arg(long, value_enum, default_value_t)]
    model: Model,
    /// Longest chain of reflected and refracted rays, including the primary ray, 1 to 16
    #[arg(long, default_value_t = 5, value_name = "N", allow_negative_numbers = true, value_parser = whole::<u32>(1..=16))]
    ray_depth: u32,
    /// Let glass reflect by Schlick's approximation, in addition to its Ks
    #[arg(long)]
    fresnel: bool,
    /// Trace no shadows
    #[arg(long)]
    no_shadows: bool,
}

impl SceneChoices {
    /// The model and its settings; all others are the library's defaults.
    #[must_use]
    pub fn render_options(&self) -> RenderOptions {
        RenderOptions {
            model: self.model,
            ray_depth: self.ray_depth,
            fresnel: self.fresnel,
            shadows: !self.no_shadows,
            ..RenderOptions::default()
        }
    }
}

/// How pictures look.
#[derive(Args, Debug)]
pub struct LookChoices {
    /// Trace this many samples of a pixel that differs from a neighbour; in a window and a terminal
    /// as soon as the picture is at rest [default: 4; 1 with render's --corners, and to play or view
    /// on a framebuffer]
    #[arg(long, value_enum, value_name = "N")]
    antialias: Option<Samples>,
    /// How much such a pixel differs in a channel at least, in 1/255; 0: antialias every pixel
    #[arg(long, default_value_t = CONTRAST, value_name = "N", allow_negative_numbers = true, value_parser = whole::<u8>(0..=255))]
    contrast: u8,
    /// What the channels of the scene's colours and of pixels say about light [default: srgb;
    /// linear by depth shading, whose shades are distances, and with render's --corners]
    #[arg(long, value_enum)]
    colour: Option<Colour>,
    /// Limit light that is nearly white or brighter without a step
    #[arg(long)]
    roll_off: bool,
}

impl LookChoices {
    /// The look; `samples` and `colour` are what it has without the options.
    #[must_use]
    pub fn look(&self, samples: Samples, colour: Option<Colour>) -> Look {
        Look {
            samples: self.antialias.unwrap_or(samples),
            contrast: self.contrast,
            colour: self.colour.or(colour),
            roll_off: self.roll_off,
        }
    }
}

/// The SPU program.
#[derive(Args, Debug)]
pub struct ProgramChoices {
    /// SPU program to trace with, such as one with a game's own shaders [default: the built-in
    /// one]
    #[arg(long, value_name = "F.elf")]
    pub program: Option<PathBuf>,
    /// Shader in SPU assembly to link into the SPU program; needs an SPU assembler
    #[arg(long = "shader", value_name = "F.s", conflicts_with = "program")]
    pub shaders: Vec<PathBuf>,
    /// Check at every call of a shader that it keeps the rules for shaders
    #[arg(long)]
    pub check_shaders: bool,
    /// Seconds after which SPUs count as lost if none takes work, finishes any or answers
    #[arg(long, default_value_t = 600, value_name = "S", allow_negative_numbers = true, value_parser = whole::<u64>(1..=86_400))]
    timeout: u64,
}

/// Why a chosen SPU program can't be used.
#[derive(Debug, thiserror::Error)]
pub enum ProgramChoiceError {
    /// It can't be read, or is not valid.
    #[error(transparent)]
    Program(#[from] ProgramError),
    /// A shader can't be assembled or linked.
    #[error(transparent)]
    Build(#[from] spu_build::Error),
}

impl ProgramChoices {
    /// The chosen SPU program; `None` if there is none, for the built-in one.
    ///
    /// # Errors
    /// It can't be read or is not valid, or a shader can't be built.
    pub fn program(&self) -> Result<Option<Program>, ProgramChoiceError> {
        match &self.program {
            Some(file) => Ok(Some(Program::from_file(file)?)),
            None if self.shaders.is_empty() => Ok(None),
            None => Ok(Some(Program::from_image(&spu_build::tracer_with(&self.shaders)?)?)),
        }
    }

    /// The files that the chosen SPU program is made of.
    pub fn files(&self) -> impl Iterator<Item = PathBuf> {
        self.program.iter().chain(&self.shaders).cloned()
    }

    /// How long SPUs may be silent.
    #[must_use]
    pub fn timeout(&self) -> Duration {
        Duration::from_secs(self.timeout)
    }
}

/// A parser of an option's whole numbers.
pub fn whole<N: TryFrom<u64>>(
    range: RangeInclusive<u64>,
) -> impl Fn(&str) -> Result<N, String> + Clone {
    move |text| {
        let number = text.parse().ok().filter(|number| range.contains(number));
        number.and_then(|number| N::try_from(number).ok()).ok_or_else(|| {
            let least = range.start();
            match *range.end() {
                most if most >= u64::from(u32::MAX) => {
                    format!("it is not a whole number from {least}")
                }
                most => format!("it is not a whole number from {least} to {most}"),
            }
        })
    }
}
