//! The command line.

use std::path::PathBuf;
use std::time::Duration;

use cellray::Settings;
use cellray::choices::{Antialias, Colour, Model};
use cellray::framebuffer::{Geometry, NumberedPath};
use cellray::game::FrameRange;
use cellray::scene::{CONTRAST, Look, RenderOptions, Samples};
use cellray::spe::Program;
use clap::builder::{OsStringValueParser, TypedValueParser as _};
use clap::{Args, Parser, Subcommand, ValueEnum};

use crate::error::PlayError;
use crate::keys;
use crate::spu_clock::SpuClock;

/// Play games and look at scenes, traced by SPUs.
#[derive(Debug, Parser)]
#[command(name = "cellray-play", version, after_help = more_help(), after_long_help = more_help())]
pub struct Arguments {
    /// The command.
    #[command(subcommand)]
    pub command: Command,
}

const MORE: &str = "
  view: arrows or a drag turn, wheel or page keys zoom, Home goes back

Examples:
  cellray-play play billiards
  cellray-play view scenes/whitted16.nff --display terminal
  cellray-play play orrery --frames 0..250 --out 'f-%05d.png' --size 1280x720";

/// The help after the options.
fn more_help() -> String {
    keys::table() + MORE
}

/// The commands.
#[derive(Debug, Subcommand)]
pub enum Command {
    /// Play a game; without a name, list the games
    Play(PlayArguments),
    /// Look at a scene from all sides
    View(ViewArguments),
    /// Write man pages and shell completions
    #[command(hide = true)]
    Pages(talk::manual::Arguments),
    /// Show a PNG file in the terminal
    Show {
        /// The picture
        picture: PathBuf,
    },
}

/// `play`.
#[derive(Debug, Args)]
pub struct PlayArguments {
    /// Name of the game
    pub name: Option<String>,
    /// Options of the game.
    #[command(flatten)]
    pub options: GameOptions,
}

/// The command line of a program of one game.
#[derive(Debug, Parser)]
#[command(about = "A game, traced by SPUs", after_help = keys::table(), after_long_help = keys::table())]
pub struct OneGame {
    /// Options of the game.
    #[command(flatten)]
    pub options: GameOptions,
}

/// Options of a game.
#[derive(Debug, Args)]
pub struct GameOptions {
    /// Random seed of the game [default: a different one each time, but 0 for pictures]
    #[arg(long, value_name = "N", allow_negative_numbers = true)]
    pub seed: Option<u64>,
    /// Options of the session.
    #[command(flatten)]
    pub session: Options,
}

/// `view`.
#[derive(Debug, Args)]
pub struct ViewArguments {
    /// Scene: an NFF file, a mesh (.obj, .ply or .glb), or a generated one: sphereflake:LEVEL,
    /// tetra:LEVEL, terrain:LEVEL, or gears, mount, rings, teapot, tree, lattice, jacks, shells or
    /// sombrero, with :SIZE if it is not to have SPD's
    pub scene: PathBuf,
    /// Model that the scene is rendered with
    #[arg(long, value_enum, default_value_t)]
    model: Model,
    /// Longest chain of reflected and refracted rays, including the primary ray, 1 to 16
    #[arg(long, default_value_t = 5, value_name = "N", allow_negative_numbers = true, value_parser = clap::value_parser!(u32).range(1..=16))]
    ray_depth: u32,
    /// Let glass reflect by Schlick's approximation, in addition to its Ks
    #[arg(long)]
    fresnel: bool,
    /// Trace no shadows
    #[arg(long)]
    no_shadows: bool,
    /// Load the scene, the SPU program and its shaders again whenever their files change
    #[arg(long, conflicts_with_all = ["record", "replay", "out"])]
    pub watch: bool,
    /// Options of the session.
    #[command(flatten)]
    pub options: Options,
}

impl ViewArguments {
    /// The model and its settings.
    #[must_use]
    pub fn render_options(&self) -> RenderOptions {
        RenderOptions {
            model: self.model.into(),
            ray_depth: self.ray_depth,
            fresnel: self.fresnel,
            shadows: !self.no_shadows,
            ..RenderOptions::default()
        }
    }
}

/// The kind of display.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum DisplayKind {
    /// A window on a desktop.
    Window,
    /// The terminal, with coloured characters.
    Terminal,
    /// The console's framebuffer.
    Fb,
    /// Numbered pictures: needs --frames and --out.
    Images,
    /// No display: frames are only traced and measured; needs --frames or --replay.
    None,
}

/// Options of a session.
#[derive(Debug, Args)]
pub struct Options {
    /// Display to use [default: images with --out; otherwise a window if there is a display server,
    /// otherwise the terminal]
    #[arg(long, value_enum)]
    pub display: Option<DisplayKind>,
    /// Width and height in pixels [default: in a window or terminal, as many as run smoothly, and
    /// all of them at rest]
    #[arg(long, value_name = "WxH", allow_hyphen_values = true)]
    pub size: Option<Geometry>,
    /// Framebuffer device, or a regular file that is written like one
    #[arg(long, default_value = "/dev/fb0", value_name = "PATH")]
    pub device: PathBuf,
    /// Frames: A..B for frames A to B - 1, or N for the first N
    #[arg(long, value_name = "A..B", allow_hyphen_values = true)]
    pub frames: Option<FrameRange>,
    /// Numbered pictures to write, such as f-%05d.png; pictures that exist are kept
    #[arg(long, value_name = "F-%05d.png", value_parser = OsStringValueParser::new().try_map(NumberedPath::new))]
    pub out: Option<NumberedPath>,
    /// Frames a second of game time, for pictures
    #[arg(long, default_value_t = 25, value_name = "N", allow_negative_numbers = true, value_parser = clap::value_parser!(u32).range(1..=1000))]
    pub fps: u32,
    /// Record the session to a new file
    #[arg(long, value_name = "F")]
    pub record: Option<PathBuf>,
    /// Play a recorded session back
    #[arg(long, value_name = "F", conflicts_with = "record")]
    pub replay: Option<PathBuf>,
    /// Folder for the pictures that F12 takes
    #[arg(long, default_value = ".", value_name = "FOLDER")]
    pub screenshots: PathBuf,
    /// Trace this many samples of a pixel that differs from a neighbour; in a window and a terminal
    /// as soon as the picture is at rest [default: 4; 1 on a framebuffer]
    #[arg(long, value_enum, value_name = "N")]
    antialias: Option<Antialias>,
    /// How much such a pixel differs in a channel at least, in 1/255; 0: antialias every pixel
    #[arg(long, default_value_t = CONTRAST, value_name = "N", allow_negative_numbers = true)]
    contrast: u8,
    /// What the channels of the scene's colours and of pixels say about light [default: srgb;
    /// linear by depth shading, whose shades are distances]
    #[arg(long, value_enum)]
    colour: Option<Colour>,
    /// Limit light that is nearly white or brighter without a step
    #[arg(long)]
    roll_off: bool,
    /// Start without text on the screen; F1 shows it, and then statistics
    #[arg(long)]
    pub no_overlay: bool,
    /// Print statistics at the end: rays, tests, tiles, what each SPU did
    #[arg(long, short)]
    pub verbose: bool,
    /// SPUs to use [default: 6, but no more than the computer has processors, unless it is a
    /// console or time is simulated]
    #[arg(long, value_name = "N", allow_negative_numbers = true)]
    spus: Option<u32>,
    /// SPU program to trace with, such as one with shaders of its own [default: the built-in one]
    #[arg(long, value_name = "F.elf")]
    program: Option<PathBuf>,
    /// Shader in SPU assembly to link into the SPU program; needs an SPU assembler
    #[arg(long = "shader", value_name = "F.s", conflicts_with = "program")]
    shaders: Vec<PathBuf>,
    /// Check at every call of a shader that it keeps the rules for shaders
    #[arg(long)]
    check_shaders: bool,
    /// Seconds after which SPUs count as lost if none takes work, finishes any or answers
    #[arg(long, default_value_t = 600, value_name = "S", allow_negative_numbers = true, value_parser = clap::value_parser!(u64).range(1..=86_400))]
    timeout: u64,
}

impl Options {
    /// Whether `--program` selects an SPU program.
    #[must_use]
    pub fn has_program(&self) -> bool {
        self.program.is_some() || !self.shaders.is_empty()
    }

    /// The files that the SPU program is made of, if it is not the built-in one.
    pub fn program_files(&self) -> impl Iterator<Item = PathBuf> {
        self.program.iter().chain(&self.shaders).cloned()
    }

    /// The engine's settings.
    ///
    /// # Errors
    /// The SPU program of `--program` can't be read or is not valid, or a shader can't be built.
    pub fn settings(&self) -> Result<Settings, PlayError> {
        Ok(Settings {
            spus: self.spus.unwrap_or_else(|| SpuClock::here().usual_spus()),
            check_shaders: self.check_shaders,
            timeout: Duration::from_secs(self.timeout),
            program: match &self.program {
                Some(file) => Program::from_file(file)?,
                None if self.shaders.is_empty() => Program::tracer(),
                None => Program::from_image(&spu_build::tracer_with(&self.shaders)?)?,
            },
            ..Settings::default()
        })
    }

    /// How the pictures on this kind of display look.
    #[must_use]
    pub fn look(&self, kind: DisplayKind) -> Look {
        let usual = match kind {
            // Every frame is traced at once, and has to be fast.
            DisplayKind::Fb => Samples::One,
            _ => Samples::Four,
        };
        Look {
            samples: self.antialias.map_or(usual, Into::into),
            contrast: self.contrast,
            colour: self.colour.map(Into::into),
            roll_off: self.roll_off,
        }
    }

    /// The game's time from one picture to the next.
    #[must_use]
    pub fn step(&self) -> Duration {
        Duration::from_secs(1) / self.fps
    }
}
