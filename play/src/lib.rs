//! Games and scenes before a player: in a window, a terminal, on the console's framebuffer, or as pictures.
//!
//! Owns displays, input devices and the command line of `cellray-play`; what is played it is given, as a table of
//! [`Entry`]s. A program of one's own needs no more than
//!
//! ```no_run
//! use cellray::game::{Game, Moment, Start, World, WorldError};
//!
//! struct Empty;
//!
//! impl Game for Empty {
//!     fn set_up(&mut self, _: &mut World, _: &Start) -> Result<(), WorldError> {
//!         Ok(())
//!     }
//!     fn frame(&mut self, _: &mut World, _: &Moment<'_>) -> Result<(), WorldError> {
//!         Ok(())
//!     }
//! }
//!
//! fn main() -> std::process::ExitCode {
//!     cellray_play::main(&[cellray_play::Entry {
//!         name: "empty",
//!         line: "nothing to see",
//!         controls: &[],
//!         new: || Box::new(Empty),
//!     }])
//! }
//! ```

mod arguments;
mod canvas;
mod display;
mod error;
mod frames;
mod front;
mod images;
pub mod input;
mod interactive;
mod meter;
mod overlay;
mod pace;
mod recording;
mod screenshot;
mod viewer;

use std::fmt::Write as _;
use std::process::ExitCode;
use std::sync::Arc;
use std::sync::atomic::AtomicBool;
use std::time::{SystemTime, UNIX_EPOCH};

use cellray::framebuffer::Geometry;
use cellray::game::{Clock, FixedSteps, Game, RealTime, SessionReport};
use clap::Parser as _;

use self::arguments::{Arguments, Command, DisplayKind, Options};
use self::display::{Nowhere, Screen, Terminal, Window};
use self::error::PlayError;
use self::front::Ending;
use self::input::{Hub, SystemDevices, Wanted};
use self::interactive::Player;
use self::viewer::Viewer;

/// Size of a window at first, and of pictures.
const SIZE: Geometry = Geometry {
    width: 960,
    height: 540,
};

/// A game that can be played.
#[derive(Clone, Copy)]
pub struct Entry {
    /// What it is called on the command line.
    pub name: &'static str,
    /// What it is, in a line.
    pub line: &'static str,
    /// What the player can do, a line each.
    pub controls: &'static [&'static str],
    /// Makes it.
    pub new: fn() -> Box<dyn Game>,
}

/// The program, with these games.
pub fn main(games: &[Entry]) -> ExitCode {
    // A file that may not grow is an error to tell of, and no reason to be killed.
    let ignored = Arc::new(AtomicBool::new(false));
    if let Err(error) = signal_hook::flag::register(libc::SIGXFSZ, ignored) {
        eprintln!("cellray-play: error: signals: {error}");
        return ExitCode::FAILURE;
    }
    match run(games, &Arguments::parse()) {
        Ok(Ending::Over | Ending::Closed) => ExitCode::SUCCESS,
        Ok(Ending::Signal(signal)) => {
            eprintln!("cellray-play: ended by signal {signal}");
            // As shells tell of it.
            u8::try_from(128 + signal).map_or(ExitCode::FAILURE, ExitCode::from)
        }
        Err(error) => {
            eprintln!("cellray-play: error: {error}");
            ExitCode::FAILURE
        }
    }
}

fn run(games: &[Entry], arguments: &Arguments) -> Result<Ending, PlayError> {
    match &arguments.command {
        Command::Play(play) => {
            let Some(name) = &play.name else {
                print!("{}", list(games));
                return Ok(Ending::Over);
            };
            let entry = games.iter().find(|entry| entry.name == name.as_str());
            let entry = entry.ok_or_else(|| PlayError::NoGame {
                name: name.clone(),
                known: games
                    .iter()
                    .map(|entry| entry.name)
                    .collect::<Vec<_>>()
                    .join(", "),
            })?;
            for line in entry.controls {
                eprintln!("cellray-play: {line}");
            }
            session((entry.new)(), play.seed, SIZE, &play.options)
        }
        Command::View(view) => {
            let scene = nff::load(&view.scene)?;
            let (width, height) = scene.view.resolution;
            let size = Geometry { width, height };
            size.check()?;
            let viewer = Viewer::new(scene, view.look());
            session(Box::new(viewer), Some(0), size, &view.options)
        }
    }
}

fn list(games: &[Entry]) -> String {
    let mut text = String::new();
    for entry in games {
        // Writing to a string can't fail.
        let _ = writeln!(text, "{:12} {}", entry.name, entry.line);
    }
    text
}

/// The display that was asked for, or the first that there is.
fn display_kind(options: &Options) -> Result<DisplayKind, PlayError> {
    match options.display {
        Some(kind) => Ok(kind),
        None if options.out.is_some() => Ok(DisplayKind::Images),
        None if Window::is_possible() => Ok(DisplayKind::Window),
        None if Terminal::is_possible() => Ok(DisplayKind::Terminal),
        None => Err(PlayError::NoDisplay),
    }
}

fn session(
    game: Box<dyn Game>,
    seed: Option<u64>,
    usual: Geometry,
    options: &Options,
) -> Result<Ending, PlayError> {
    let kind = display_kind(options)?;
    let size = options.size.unwrap_or(usual);
    if kind != DisplayKind::Images {
        if options.out.is_some() {
            return Err(PlayError::Options("--out goes with --display images alone"));
        }
        if options.frames.is_some_and(|range| range.first != 0) {
            return Err(PlayError::Options(
                "--frames A..B with an A over 0 goes with --out alone: a session begins with frame 0",
            ));
        }
    }
    let device_hub = |wanted| Some(Hub::new(Box::new(SystemDevices), wanted));
    let real: Box<dyn Clock> = Box::new(RealTime::default());
    let fixed: Box<dyn Clock> = Box::new(FixedSteps(options.step()));
    let title = format!("cellray: {}", game.name());
    let (clock, player) = match kind {
        DisplayKind::Images => return pictures(game, seed.unwrap_or(0), size, options),
        DisplayKind::Window => {
            let player = Player {
                display: Box::new(Window::open(&title, size)?),
                devices: device_hub(Wanted::Pads),
                keys: None,
                may_talk: true,
            };
            (real, player)
        }
        DisplayKind::Terminal => {
            let player = Player {
                display: Box::new(Terminal::open()?),
                devices: device_hub(Wanted::Pads),
                keys: None,
                may_talk: false,
            };
            (real, player)
        }
        DisplayKind::Fb => {
            let keys = match Terminal::is_possible() {
                true => Some(Box::new(Terminal::keys_only()?) as _),
                false => None,
            };
            let screen = Screen::open(&options.device, options.size)?;
            let player = Player {
                display: Box::new(screen),
                devices: device_hub(Wanted::All),
                keys,
                may_talk: true,
            };
            (real, player)
        }
        DisplayKind::None => {
            if options.frames.is_none() && options.replay.is_none() {
                return Err(PlayError::Options(
                    "--display none needs --frames or --replay",
                ));
            }
            let player = Player {
                display: Box::new(Nowhere::new(size)),
                devices: None,
                keys: None,
                may_talk: true,
            };
            (fixed, player)
        }
    };
    let seed = seed.unwrap_or_else(|| {
        if kind == DisplayKind::None {
            0
        } else {
            any_seed()
        }
    });
    let played = interactive::play(game, seed, options, clock, player)?;
    for message in &played.messages {
        eprintln!("cellray-play: {message}");
    }
    tell(&played.report);
    Ok(played.ending)
}

fn pictures(
    game: Box<dyn Game>,
    seed: u64,
    size: Geometry,
    options: &Options,
) -> Result<Ending, PlayError> {
    let (Some(range), Some(paths)) = (options.frames, &options.out) else {
        return Err(PlayError::Options(
            "pictures need --frames A..B and --out 'f-%05d.png'",
        ));
    };
    let pictures = images::write(game, seed, options, range, paths, size)?;
    tell(&pictures.report);
    eprintln!(
        "cellray-play: {} picture(s) written, {} there already",
        pictures.written, pictures.kept
    );
    Ok(pictures.ending)
}

fn tell(report: &SessionReport) {
    for line in report.to_string().lines() {
        eprintln!("cellray-play: {line}");
    }
}

/// Another number at each start.
fn any_seed() -> u64 {
    let now = SystemTime::now().duration_since(UNIX_EPOCH);
    now.map_or(0, |now| now.as_nanos() as u64)
}
