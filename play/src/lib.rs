//! [`main_of`] is the `main` of a game: it shows the game in a window, in a terminal, on the
//! console's framebuffer, or as pictures.
//!
//! ```no_run
#![doc = include_str!("ball.rs")]
//! ```
//!
//! [`main`] is that of a program with a table of games, as `cellray-play` itself. A game's models
//! come from files by [`meshes::load`], and into its world by `World::add_model`. The crate owns
//! displays, input devices and the command line.

mod arguments;
mod display;
mod error;
mod frontend;
pub mod input;
mod interactive;
mod keys;
mod meter;
mod names;
mod overlay;
mod pace;
mod recording;
mod reload;
mod screenshot;
mod spu_clock;
mod texts;
mod viewer;
mod waiting;

use std::fmt::{Display, Write as _};
use std::io::{self, IsTerminal as _};
use std::path::Path;
use std::process::ExitCode;
use std::time::{SystemTime, UNIX_EPOCH};

pub use meshes;

use cellray::Report;
use cellray::choices::SceneChoices;
use cellray::framebuffer::{Geometry, Interrupted, Memory, refuse_large_files};
use cellray::game::{Clock, Entry, FixedSteps, Game, Pictures, RealTime, Session};
use cellray::scene::mesh::gathered;
use cellray::scene::offset_note;
use clap::{CommandFactory as _, Parser as _};
use meshes::Loaded;

use self::arguments::{Arguments, Command, DisplayKind, GameOptions, OneGame, Options};
use self::display::{Colours, NoDisplay, Screen, Terminal, Window, lines, terminal_size};
use self::error::PlayError;
use self::frontend::Ending;
use self::input::{DeviceSet, InputDevices, SystemDevices};
use self::interactive::Player;
use self::reload::Reload;
use self::viewer::Viewer;

/// The initial size of a window, and the default size of pictures.
const SIZE: Geometry = Geometry { width: 960, height: 540 };

/// Runs `cellray-play` with these games. Returns the exit code.
pub fn main(games: &[Entry]) -> ExitCode {
    end(prepare().and_then(|()| run(games, &Arguments::parse())))
}

/// Runs a program with a single game. Its command line has only the options of `cellray-play
/// play`. Returns the exit code.
pub fn main_of<G: Game + Default + 'static>() -> ExitCode {
    end(prepare().and_then(|()| {
        let OneGame { options } = OneGame::parse();
        play(Box::new(G::default()), &options)
    }))
}

fn prepare() -> Result<(), PlayError> {
    refuse_large_files().map_err(PlayError::Signals)
}

fn end(ending: Result<Ending, PlayError>) -> ExitCode {
    match ending {
        Ok(Ending::Over | Ending::Closed) => ExitCode::SUCCESS,
        Ok(Ending::Signal(signal)) => {
            print_line(format_args!("ended by signal {signal}"));
            // The exit code that shells use for signals.
            u8::try_from(128 + signal).map_or(ExitCode::FAILURE, ExitCode::from)
        }
        Err(error) => {
            print_line(format_args!("error: {error}"));
            ExitCode::FAILURE
        }
    }
}

fn run(games: &[Entry], arguments: &Arguments) -> Result<Ending, PlayError> {
    match &arguments.command {
        Command::Play(play) => {
            let Some(name) = &play.name else {
                return print(list(games).as_bytes());
            };
            let entry = find(games, name)?;
            let game = match (&play.wad, entry.open) {
                (Some(wad), Some(open)) => {
                    open(wad, play.map.as_deref()).map_err(PlayError::Level)?
                }
                (Some(_), None) => {
                    return Err(PlayError::Options("--wad: this game has no levels"));
                }
                (None, _) => (entry.new)(),
            };
            for line in game.controls() {
                print_line(line);
            }
            self::play(game, &play.options)
        }
        Command::Show { picture } => show(picture),
        Command::Pages(pages) => {
            messages::manual::write(Arguments::command(), pages).map_err(PlayError::Pages)?;
            Ok(Ending::Over)
        }
        Command::View(view) => {
            let loaded = load(&view.scene)?;
            for note in &loaded.notes {
                print_line(note);
            }
            let (width, height) = loaded.scene.view.resolution;
            let size = Geometry { width, height };
            size.check()?;
            let render_options = view.scene.render_options();
            if let Some(note) = offset_note(&loaded.scene, render_options) {
                print_line(note);
            }
            let viewer = Viewer::of(loaded, render_options);
            session(Box::new(viewer), Some(0), size, &view.options, Reload::new(view))
        }
    }
}

/// The game with this name, in capitals or not.
fn find<'a>(games: &'a [Entry], name: &str) -> Result<&'a Entry, PlayError> {
    let same = |entry: &&Entry| entry.name.eq_ignore_ascii_case(name);
    games.iter().find(same).ok_or_else(|| PlayError::NoGame {
        name: name.to_owned(),
        meant: names::nearest(name, games.iter().map(|entry| entry.name)),
        known: games.iter().map(|entry| entry.name).collect::<Vec<_>>().join(", "),
    })
}

/// Loads a scene to look at.
fn load(choices: &SceneChoices) -> Result<Loaded, PlayError> {
    let loaded = meshes::load_animated(&choices.scene, choices.animation.as_deref())?;
    Ok(Loaded { scene: gathered(&loaded.scene).into_owned(), ..loaded })
}

/// Writes a picture to standard output, as wide as the terminal.
fn show(path: &Path) -> Result<Ending, PlayError> {
    let picture = image::open(path)
        .map_err(|source| PlayError::Picture { path: path.to_path_buf(), source })?;
    let (columns, _) = terminal_size();
    print(&lines(&picture.to_rgb8(), columns, Colours::of_environment()))
}

fn play(game: Box<dyn Game>, options: &GameOptions) -> Result<Ending, PlayError> {
    session(game, options.seed, SIZE, &options.session, None)
}

fn list(games: &[Entry]) -> String {
    let mut text = String::from("Games; start one with `cellray play NAME`:\n\n");
    for entry in games {
        // Writing to a string can't fail.
        let _ = writeln!(text, "{:12} {}", entry.name, entry.line);
    }
    text
}

fn print(data: &[u8]) -> Result<Ending, PlayError> {
    messages::write_data(data).map_err(PlayError::Output)?;
    Ok(Ending::Over)
}

/// The requested display, or the first possible one.
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
    reload: Option<Reload<'_>>,
) -> Result<Ending, PlayError> {
    if options.program.files().next().is_some() && game.program()?.is_some() {
        return Err(PlayError::Options("--program: the game has an SPU program of its own"));
    }
    // Done before a display is opened, so that a signal meanwhile is a request too.
    let _interrupted = Interrupted::install().map_err(PlayError::Signals)?;
    let kind = display_kind(options)?;
    let size = options.size.unwrap_or(usual);
    if kind != DisplayKind::Images {
        if options.out.is_some() {
            return Err(PlayError::Options("--out can only be used with --display images"));
        }
        if options.frames.is_some_and(|range| range.first != 0) {
            return Err(PlayError::Options(
                "--frames A..B with A above 0 needs --out: a session begins with frame 0",
            ));
        }
    }
    let input_devices = |wanted| Some(InputDevices::new(Box::new(SystemDevices), wanted));
    let real: Box<dyn Clock> = Box::new(RealTime::default());
    let fixed: Box<dyn Clock> = Box::new(FixedSteps(options.step()));
    let title = format!("cellray: {}", game.name());
    let look = options.look(kind);
    let (clock, player) = match kind {
        DisplayKind::Images => return pictures(game, seed.unwrap_or(0), size, options),
        DisplayKind::Window => {
            let player = Player {
                display: Box::new(Window::open(&title, size)?),
                devices: input_devices(DeviceSet::Pads),
                keys: None,
                may_print: true,
                look,
            };
            (real, player)
        }
        DisplayKind::Terminal => {
            let player = Player {
                display: Box::new(Terminal::open()?),
                devices: input_devices(DeviceSet::Pads),
                keys: None,
                may_print: false,
                look,
            };
            (real, player)
        }
        DisplayKind::Fb => {
            let keys = match io::stdin().is_terminal() {
                true => Some(Box::new(Terminal::keys_only()?) as _),
                false => None,
            };
            let screen = Screen::open(&options.device, options.size)?;
            let player = Player {
                display: Box::new(screen),
                devices: input_devices(DeviceSet::All),
                keys,
                may_print: true,
                look,
            };
            (real, player)
        }
        DisplayKind::None => {
            if options.frames.is_none() && options.replay.is_none() {
                return Err(PlayError::Options("--display none needs --frames or --replay"));
            }
            let player = Player {
                display: Box::new(NoDisplay::new(size)),
                devices: None,
                keys: None,
                may_print: true,
                look,
            };
            (fixed, player)
        }
    };
    let seed = seed.unwrap_or_else(|| if kind == DisplayKind::None { 0 } else { any_seed() });
    let played = interactive::play(game, seed, options, clock, player, reload)?;
    for message in &played.messages {
        print_line(message);
    }
    // Without a display, the statistics are what is wanted.
    print_statistics(played.report, options.verbose || kind == DisplayKind::None);
    Ok(played.ending)
}

fn pictures(
    game: Box<dyn Game>,
    seed: u64,
    size: Geometry,
    options: &Options,
) -> Result<Ending, PlayError> {
    let (Some(range), Some(paths)) = (options.frames, &options.out) else {
        return Err(PlayError::Options("pictures need --frames A..B and --out 'f-%05d.png'"));
    };
    let pictures = Pictures::new(paths.clone());
    let mut interrupted = Interrupted::install().map_err(PlayError::Signals)?;
    let picture = Box::new(Memory::new(size)?);
    let mut session = Session::start(game, options.settings()?, picture)?.with_seed(seed);
    session.set_look(Some(options.look(DisplayKind::Images)));
    let replay = options.replay.as_deref();
    let mut session = recording::connect(session, options.record.as_deref(), replay)?;
    let mut clock = FixedSteps(options.step());
    let made = pictures.write(&mut session, range, &mut clock, &mut interrupted)?;
    print_statistics(session.report().clone(), options.verbose);
    print_line(format_args!("{} picture(s) written, {} existed already", made.written, made.kept));
    Ok(interrupted.signal().map_or(Ending::Over, Ending::Signal))
}

/// Prints a line on standard error.
fn print_line(line: impl Display) {
    messages::print!("cellray-play: {line}");
}

/// Prints a line on a run, or all of its statistics.
fn print_statistics(mut report: Report, is_verbose: bool) {
    report.add_memory();
    print_line(report.summary());
    if is_verbose {
        for line in report.to_string().lines().skip(1) {
            print_line(line);
        }
    }
}

/// A seed that differs at each start.
fn any_seed() -> u64 {
    let now = SystemTime::now().duration_since(UNIX_EPOCH);
    now.map_or(0, |now| now.as_nanos() as u64)
}
