//! The command line.

use std::path::PathBuf;
use std::time::Duration;

use cellray::Settings;
use cellray::choices::{LookChoices, ProgramChoices, SceneChoices};
use cellray::framebuffer::{Geometry, NumberedPath};
use cellray::game::FrameRange;
use cellray::scene::{Look, Samples};
use cellray::spe::Program;
use clap::builder::{OsStringValueParser, TypedValueParser as _};
use clap::{Args, Parser, Subcommand, ValueEnum};

use crate::error::PlayError;
use crate::keys;
use crate::spu_clock::SpuClock;

/// Play games and view scenes, rendered by SPUs.
#[derive(Debug, Parser)]
#[command(name = "cellray-play", version, after_help = more_help(), after_long_help = more_help())]
pub struct Arguments {
    /// The command.
    #[command(subcommand)]
    pub command: Command,
}

const MORE: &str = "
  view: arrow keys or dragging rotate, wheel or page keys zoom, Home resets the view

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
    /// View a scene from all sides
    View(ViewArguments),
    /// Write man pages and shell completions
    #[command(hide = true)]
    Pages(messages::manual::Arguments),
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
    /// WAD file with a level to play in; for the game `station`
    #[arg(long, help_heading = "Game", value_name = "FILE", requires = "name")]
    pub wad: Option<PathBuf>,
    /// Name of the level in the WAD file, such as E1M1 or MAP01 [default: the first one]
    #[arg(long, help_heading = "Game", value_name = "NAME", requires = "wad")]
    pub map: Option<String>,
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
    /// Random seed of the game [default: a different one each time; 0 for pictures]
    #[arg(long, help_heading = "Game", value_name = "N", allow_negative_numbers = true)]
    pub seed: Option<u64>,
    /// Options of the session.
    #[command(flatten)]
    pub session: Options,
}

/// `view`.
#[derive(Debug, Args)]
pub struct ViewArguments {
    /// The scene.
    #[command(flatten)]
    pub scene: SceneChoices,
    /// Reload the scene, the SPU program and its shaders whenever a file changes
    #[arg(long, help_heading = "Scene", conflicts_with_all = ["record", "replay", "out"])]
    pub watch: bool,
    /// Options of the session.
    #[command(flatten)]
    pub options: Options,
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
    /// Numbered pictures; needs --frames and --out.
    Images,
    /// No display, to measure; needs --frames or --replay.
    None,
}

/// Options of a session.
#[derive(Debug, Args)]
pub struct Options {
    /// Display [default: a window if possible]
    ///
    /// The default is images with --out. Otherwise it is a window if there is a display server, and
    /// the terminal if there is none.
    #[arg(long, help_heading = "View", value_enum)]
    pub display: Option<DisplayKind>,
    /// Width and height in pixels [default: depends on the display]
    ///
    /// By default a window or a terminal has the largest resolution that runs smoothly, and its
    /// full resolution when the picture is at rest.
    #[arg(long, help_heading = "View", value_name = "WxH", allow_hyphen_values = true)]
    pub size: Option<Geometry>,
    /// Framebuffer device, or a regular file to write
    #[arg(long, help_heading = "View", default_value = "/dev/fb0", value_name = "PATH")]
    pub device: PathBuf,
    /// Number of frames, or a range A..B
    ///
    /// The range ends with frame B - 1.
    #[arg(long, help_heading = "Output", value_name = "A..B", allow_hyphen_values = true)]
    pub frames: Option<FrameRange>,
    /// Numbered pictures to write, such as f-%05d.png; files that exist are kept
    #[arg(long, help_heading = "Output", value_name = "F-%05d.png", value_parser = OsStringValueParser::new().try_map(NumberedPath::new))]
    pub out: Option<NumberedPath>,
    /// Frames per second of game time, for pictures
    #[arg(long, help_heading = "Output", default_value_t = 25, value_name = "N", allow_negative_numbers = true, value_parser = clap::value_parser!(u32).range(1..=1000))]
    pub fps: u32,
    /// Record the session to a new file
    #[arg(long, help_heading = "Output", value_name = "F")]
    pub record: Option<PathBuf>,
    /// Replay a recorded session
    #[arg(long, help_heading = "Output", value_name = "F", conflicts_with = "record")]
    pub replay: Option<PathBuf>,
    /// Folder for the screenshots of F12
    #[arg(long, help_heading = "Output", default_value = ".", value_name = "FOLDER")]
    pub screenshots: PathBuf,
    #[command(flatten)]
    look: LookChoices,
    /// Start without text on the screen; F1 shows it, and then statistics
    #[arg(long, help_heading = "View")]
    pub no_overlay: bool,
    /// Print statistics: rays, tests, tiles, time of each SPU
    #[arg(long, short, help_heading = "Output")]
    pub verbose: bool,
    /// Number of SPUs [default: 6]
    ///
    /// An emulator in real time uses at most as many as the computer has processors.
    #[arg(long, help_heading = "SPUs", value_name = "N", allow_negative_numbers = true)]
    spus: Option<u32>,
    /// The SPU program.
    #[command(flatten)]
    pub program: ProgramChoices,
}

impl Options {
    /// The engine's settings.
    ///
    /// # Errors
    /// The SPU program of `--program` can't be read or is not valid, or a shader can't be built.
    pub fn settings(&self) -> Result<Settings, PlayError> {
        Ok(Settings {
            spus: self.spus.unwrap_or_else(|| SpuClock::here().usual_spus()),
            check_shaders: self.program.check_shaders,
            timeout: self.program.timeout(),
            program: self.program.program()?.unwrap_or_else(Program::tracer),
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
        self.look.look(usual, None)
    }

    /// The game's time from one picture to the next.
    #[must_use]
    pub fn step(&self) -> Duration {
        Duration::from_secs(1) / self.fps
    }
}
