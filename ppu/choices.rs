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
    /// Scene file, or a generated scene such as sphereflake:4
    ///
    /// Files are NFF scenes and meshes in the formats OBJ, PLY, STL and glTF. Generated scenes are
    /// sphereflake:LEVEL, tetra:LEVEL, terrain:LEVEL and mountains:LEVEL, and gears, mount, rings,
    /// teapot, tree, lattice, jacks, shells and sombrero. The latter have the size of the Standard
    /// Procedural Databases unless :SIZE follows the name.
    pub scene: PathBuf,
    /// Animation of a glTF file, by name or number, or none [default: the first one]
    ///
    /// Numbers begin with 0. A still picture shows the beginning of the animation.
    #[arg(long, help_heading = "Scene", value_name = "NAME")]
    pub animation: Option<String>,
    /// Lighting model
    #[arg(long, help_heading = "Scene", value_enum, default_value_t)]
    model: Model,
    /// Maximum ray depth (1-16)
    ///
    /// The number of rays in a chain of reflected and refracted rays, including the primary ray.
    #[arg(long, help_heading = "Scene", default_value_t = 5, value_name = "N", allow_negative_numbers = true, value_parser = whole::<u32>(1..=16))]
    ray_depth: u32,
    /// Add Fresnel reflection to glass
    ///
    /// The reflection follows Schlick's approximation, and is added to that of the glass's Ks.
    #[arg(long, help_heading = "Scene")]
    fresnel: bool,
    /// Render without shadows
    #[arg(long, help_heading = "Scene")]
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
#[command(next_help_heading = "Quality")]
pub struct LookChoices {
    /// Samples per pixel along edges [default: 4]
    ///
    /// A window and a terminal antialias as soon as the picture is at rest. The default is 1 on a
    /// framebuffer for play and view, and with render's --corners.
    #[arg(long, value_enum, value_name = "N")]
    antialias: Option<Samples>,
    /// Edge threshold (0-255)
    ///
    /// A pixel is antialiased if a channel differs by at least this number from a neighbour. With
    /// 0, every pixel is antialiased.
    #[arg(long, default_value_t = CONTRAST, value_name = "N", allow_negative_numbers = true, value_parser = whole::<u8>(0..=255))]
    contrast: u8,
    /// Colour space of scene and output
    ///
    /// The default is srgb, but linear for depth shading, whose shades are distances, and with
    /// render's --corners.
    #[arg(long, value_enum)]
    colour: Option<Colour>,
    /// Roll off highlights smoothly
    ///
    /// Light that is nearly white or brighter approaches white gradually instead of being clamped.
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
#[command(next_help_heading = "SPUs")]
pub struct ProgramChoices {
    /// SPU program to run [default: the built-in one]
    ///
    /// For example one with a game's own shaders, linked by cellray shader build.
    #[arg(long, value_name = "F.elf")]
    pub program: Option<PathBuf>,
    /// Shader in SPU assembly to link into the SPU program
    ///
    /// Needs an SPU assembler. Give the option once for each shader.
    #[arg(long = "shader", value_name = "F.s", conflicts_with = "program")]
    pub shaders: Vec<PathBuf>,
    /// Check the rules for shaders at every call of a shader
    #[arg(long, hide_short_help = true)]
    pub check_shaders: bool,
    /// Time-out in seconds without progress by any SPU
    ///
    /// Afterwards the SPUs count as lost. Progress is to take a work unit, to finish one, or to
    /// finish the frame.
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

    /// How long SPUs may make no progress.
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
            let minimum = range.start();
            match *range.end() {
                maximum if maximum >= u64::from(u32::MAX) => {
                    format!("it is not a whole number from {minimum}")
                }
                maximum => format!("it is not a whole number from {minimum} to {maximum}"),
            }
        })
    }
}
