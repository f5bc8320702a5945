//! Runs a session for a player, frame by frame, with an overlay, screenshots, and a resolution
//! that adapts to the load and becomes the display's when the picture is at rest.

use std::ops::ControlFlow;
use std::time::{Duration, Instant};

use cellray::Report;
use cellray::framebuffer::{Framebuffer, Geometry, Interrupted, Memory};
use cellray::game::{Clock, Game, InputEvent, Session, SessionError};
use cellray::scene::{Look, Samples};
use image::RgbImage;

use crate::arguments::Options;
use crate::display::{Display, Enlarged};
use crate::error::PlayError;
use crate::frontend::{Ending, Frontend, Requests};
use crate::input::InputDevices;
use crate::meter::{Meter, Quality};
use crate::overlay::Overlay;
use crate::pace::{Divisor, Pace, Traced};
use crate::print_line;
use crate::recording;
use crate::reload::Reload;
use crate::screenshot;
use crate::texts::Texts;
use crate::viewer::VIEW;
use crate::waiting::Waiting;

/// The minimum width and height in pixels; smaller pictures show nothing useful.
const MIN_SIDE: u32 = 8;
/// While a picture is refined, it is drawn once in this time, because drawing takes as long as
/// tracing a tile or two.
const REFINED_EVERY: Duration = Duration::from_millis(80);

const PAUSED: &str = "Paused - press P to resume";
/// The notice at the end of a game.
const OVER: &str = "Game over - press Q to close";

#[derive(Debug)]
pub struct Played {
    pub ending: Ending,
    /// The statistics of its frames.
    pub report: Report,
    /// Messages that could not be printed before, because the terminal showed the picture.
    pub messages: Vec<String>,
}

/// The display and the devices of a player.
pub struct Player {
    /// The display that shows the frames.
    pub display: Box<dyn Display>,
    /// The input devices, if they are read.
    pub devices: Option<InputDevices>,
    /// A terminal whose keys are read in addition.
    pub keys: Option<Box<dyn Display>>,
    /// Whether messages may be printed during the session.
    pub may_print: bool,
    /// How pictures look; on a display that shows coarse ones first, those at rest.
    pub look: Look,
}

/// Runs a session until it ends.
///
/// # Errors
/// The session, the display or an input device fails.
pub fn play(
    game: Box<dyn Game>,
    seed: u64,
    options: &Options,
    mut clock: Box<dyn Clock>,
    player: Player,
    reload: Option<Reload<'_>>,
) -> Result<Played, PlayError> {
    let mut show = Show::start(game, seed, options, player)?;
    show.reload = reload;
    let mut left = options.frames.map(|range| range.end);
    let mut ending = Ending::Over;
    while left != Some(0) {
        if let ControlFlow::Break(end) = show.frame(clock.as_mut())? {
            ending = end;
            break;
        }
        left = left.map(|left| left - 1);
    }
    show.session.finish()?;
    Ok(Played { ending, report: show.session.report().clone(), messages: show.kept })
}

/// A session with its frontend.
struct Show<'a> {
    session: Session<Box<dyn Game>>,
    front: Frontend,
    options: &'a Options,
    may_print: bool,
    look: Look,
    size: Geometry,
    /// Chooses the size, if none was requested.
    pace: Option<Pace>,
    meter: Meter,
    waiting: Waiting,
    /// When a frame was last drawn.
    drawn: Option<Instant>,
    texts: Texts,
    overlay: Overlay,
    /// Messages to print at the end.
    kept: Vec<String>,
    /// The events for the session's next step.
    events: Vec<InputEvent>,
    /// The visible frame, if the display is drawn to.
    picture: Option<RgbImage>,
    /// The beginning of screenshots' names.
    stem: String,
    /// What is loaded again when its files change.
    reload: Option<Reload<'a>>,
    /// Whether the game is over. Its last picture and its status stay until the player has seen
    /// them.
    is_over: bool,
}

impl<'a> Show<'a> {
    fn start(
        game: Box<dyn Game>,
        seed: u64,
        options: &'a Options,
        player: Player,
    ) -> Result<Self, PlayError> {
        let interrupted = Interrupted::install().map_err(PlayError::Signals)?;
        let mut display = player.display;
        let is_smooth = player.look.samples > Samples::One;
        let is_paced = display.scales() && options.size.is_none();
        let pace = is_paced.then(|| Pace::new(is_smooth));
        let size = wanted_size(display.area(), pace.as_ref(), options.size);
        let framebuffer = display.framebuffer(size)?;
        let stem = file_stem(game.name());
        let mut front = Frontend::new(display, player.devices, player.keys, interrupted)
            .map_err(PlayError::Signals)?;
        let session = Session::start(game, options.settings()?, framebuffer)?;
        let mut session = session.with_seed(seed);
        session.set_look(Some(look_now(player.look, pace.as_ref())));
        let input_size = input_size(front.display.area(), pace.as_ref(), size);
        session.set_input_size(input_size);
        front.display.measure_in(input_size);
        let replay = options.replay.as_deref();
        Ok(Self {
            session: recording::connect(session, options.record.as_deref(), replay)?,
            front,
            options,
            may_print: player.may_print,
            look: player.look,
            size,
            pace,
            meter: Meter::new(Instant::now()),
            waiting: Waiting::new(Instant::now()),
            drawn: None,
            texts: Texts::new(!options.no_overlay),
            overlay: Overlay::default(),
            kept: Vec::new(),
            events: Vec::new(),
            picture: None,
            stem,
            reload: None,
            is_over: false,
        })
    }

    /// Runs one frame: waits for its time, reads the input, steps the session, shows the picture
    /// with the overlay, and handles the player's requests.
    fn frame(&mut self, clock: &mut dyn Clock) -> Result<ControlFlow<Ending>, PlayError> {
        self.reload()?;
        let stands_still = self.notice().is_some();
        let step = if stands_still {
            // The game's time stands still.
            clock.tick();
            Some(Duration::ZERO)
        } else {
            self.session.wait(clock)?
        };
        let polled = self.front.poll(&mut self.events);
        let polled = polled.map_err(SessionError::Input)?;
        let began = Instant::now();
        let mut flow = match step.filter(|_| polled.is_continue()) {
            Some(_) if stands_still => {
                if self.is_over {
                    // Nobody takes them any more.
                    self.events.clear();
                }
                self.redraw()?;
                Some(ControlFlow::Continue(()))
            }
            Some(step) => Some(self.step(step)?),
            None => None,
        };
        let requests = self.front.take_requests();
        let is_watched = self.options.frames.is_none() && self.options.replay.is_none();
        if flow == Some(ControlFlow::Break(())) && is_watched && self.session.game().is_over() {
            self.is_over = true;
            flow = Some(ControlFlow::Continue(()));
        }
        if flow.is_some() {
            let is_said = self.change_texts(requests);
            self.show(is_said || requests.screenshot)?;
        }
        if requests.full_screen {
            self.front.display.change_full_screen();
        }
        self.report_messages(requests.screenshot);
        if flow != Some(ControlFlow::Continue(())) {
            return Ok(ControlFlow::Break(requests.ending.unwrap_or(Ending::Over)));
        }
        self.fit(requests.resized, began)?;
        Ok(ControlFlow::Continue(()))
    }

    /// Steps the session. If something has moved while the picture was refined, it is coarse again.
    fn step(&mut self, step: Duration) -> Result<ControlFlow<()>, PlayError> {
        let flow = self.traced(|session, events, tracing| session.step(step, events, tracing))?;
        if self.session.engine().statistics().is_put_off {
            self.coarsen()?;
            self.redraw()?;
        }
        Ok(flow)
    }

    /// Traces the last step's world again. In a pause that refines the picture, and shows the text
    /// where the SPUs write to the screen.
    fn redraw(&mut self) -> Result<(), PlayError> {
        self.traced(|session, _, tracing| session.redraw(tracing))
    }

    /// Has the session trace a frame, as many tiles as the pace allows. It is given the events for
    /// its next step, and what keeps the display responsive meanwhile.
    fn traced<T>(
        &mut self,
        trace: impl FnOnce(
            &mut Session<Box<dyn Game>>,
            &mut Vec<InputEvent>,
            &mut dyn FnMut(f64),
        ) -> Result<T, SessionError>,
    ) -> Result<T, PlayError> {
        let tiles = self.pace.as_ref().and_then(Pace::tiles);
        self.session.engine().limit_tiles(tiles);
        let mut tracing = |part| {
            keep_responsive(
                &mut self.front,
                &mut self.waiting,
                self.picture.as_ref(),
                &self.overlay,
                part,
            )
        };
        Ok(trace(&mut self.session, &mut self.events, &mut tracing)?)
    }

    /// Whether the game's time stands still. There is nothing to show before the first frame.
    fn is_paused(&self) -> bool {
        self.front.is_paused() && self.session.next_frame() > 0
    }

    /// The notice of a game whose time stands still.
    fn notice(&self) -> Option<&'static str> {
        if self.is_over { Some(OVER) } else { self.is_paused().then_some(PAUSED) }
    }

    /// Shows other texts if the player wants them. Returns whether they have changed.
    fn change_texts(&mut self, requests: Requests) -> bool {
        if requests.overlay {
            let game = self.session.game();
            let has_words = !game.status().is_empty() || !game.labels().is_empty();
            self.texts.change_level(has_words);
        }
        if requests.help {
            self.texts.change_help();
        }
        requests.overlay || requests.help || self.overlay.notice.as_deref() != self.notice()
    }

    /// Ends the refinement of a picture.
    fn coarsen(&mut self) -> Result<(), PlayError> {
        if let Some(pace) = &mut self.pace {
            pace.moves();
        }
        self.session.engine().limit_tiles(None);
        let framebuffer = self.framebuffer()?;
        self.show_on(framebuffer)
    }

    /// Chooses the picture's size, and makes a framebuffer for it.
    fn framebuffer(&mut self) -> Result<Box<dyn Framebuffer>, PlayError> {
        self.session.set_look(Some(self.look_now()));
        let display = &mut self.front.display;
        self.size = wanted_size(display.area(), self.pace.as_ref(), self.options.size);
        let refined = self.pace.as_ref().and_then(Pace::tiles);
        Ok(match refined.and(self.session.picture()) {
            // A display that scales shows any framebuffer that can be read back.
            Some(coarse) => {
                let size = (self.size.width, self.size.height);
                Box::new(Memory::showing(&Enlarged::new(&coarse, size).all())?)
            }
            None => display.framebuffer(self.size)?,
        })
    }

    fn look_now(&self) -> Look {
        look_now(self.look, self.pace.as_ref())
    }

    fn show_on(&mut self, framebuffer: Box<dyn Framebuffer>) -> Result<(), PlayError> {
        self.session.show_on(framebuffer)?;
        self.set_input_size();
        Ok(())
    }

    /// Sets the size in whose pixels the game and the display get the mouse's positions.
    fn set_input_size(&mut self) {
        let display = &mut self.front.display;
        let size = input_size(display.area(), self.pace.as_ref(), self.size);
        display.measure_in(size);
        self.session.set_input_size(size);
    }

    /// Loads the scene again if its files have changed. If that fails, it shows a message, and the
    /// scene stays as it was.
    fn reload(&mut self) -> Result<(), PlayError> {
        let Some(reload) = &mut self.reload else {
            return Ok(());
        };
        match reload.viewer(self.session.world().view()) {
            None => Ok(()),
            Some(Err(error)) => {
                self.show_message(format!("not loaded: {error}"));
                Ok(())
            }
            Some(Ok(viewer)) => {
                if let Some(pace) = &mut self.pace {
                    pace.moves();
                }
                let framebuffer = self.framebuffer()?;
                let settings = self.options.settings()?;
                self.session = Session::start(Box::new(viewer) as _, settings, framebuffer)?;
                self.session.set_look(Some(self.look_now()));
                self.set_input_size();
                // It compares reports, and the session's begins anew.
                self.meter = Meter::new(Instant::now());
                self.show_message("loaded again".to_owned());
                Ok(())
            }
        }
    }

    /// Shows the frame on the display, if it is drawn to. While a picture is refined, not every
    /// frame is shown unless `must` is set.
    fn show(&mut self, must: bool) -> Result<(), PlayError> {
        let notice = self.notice();
        let Geometry { width, height } = self.front.display.area();
        let look = self.look_now();
        let quality = Quality {
            picture: (self.size.width, self.size.height),
            area: (width, height),
            samples: look.samples as u32,
            is_full: look == self.look
                && self.pace.as_ref().is_none_or(|pace| pace.divisor() == Divisor::ONE),
        };
        let now = Instant::now();
        let report = self.session.report().clone();
        let last = self.session.engine().statistics();
        let (is_partial, is_traced) = (last.tiles_left > 0, last.is_traced());
        let measured = self.meter.frame(now, &report, last, quality);
        let game = self.session.game().as_ref();
        let labels = self.session.labels();
        let texts = &mut self.texts;
        self.overlay = texts.overlay(measured, game, labels, notice, now);
        let display = &mut self.front.display;
        display.print(&self.overlay);
        let is_recent = |drawn| now.duration_since(drawn) < REFINED_EVERY;
        if !display.draws() || is_partial && !must && self.drawn.is_some_and(is_recent) {
            return Ok(());
        }
        if is_traced || self.picture.is_none() {
            self.picture = self.session.picture();
        }
        if let Some(picture) = &self.picture {
            display.show(picture, &self.overlay).map_err(PlayError::Show)?;
            self.drawn = Some(now);
            self.waiting.is_over(now);
        }
        Ok(())
    }

    /// Prints messages about devices, and takes a screenshot if one was requested.
    fn report_messages(&mut self, takes_picture: bool) {
        let mut messages = self.front.take_messages();
        if takes_picture {
            let picture = self.picture.as_ref();
            messages.push(take_picture(picture, self.options, &self.stem));
        }
        for message in messages {
            self.show_message(message);
        }
    }

    fn show_message(&mut self, message: String) {
        self.texts.show_message(message.clone(), Instant::now());
        if self.may_print {
            print_line(message);
        } else {
            self.kept.push(message);
        }
    }

    /// Adapts the size of the next frame to this one's time and to the display's size.
    fn fit(&mut self, is_resized: bool, began: Instant) -> Result<(), PlayError> {
        if is_resized {
            // A size that was requested stays.
            if self.pace.is_some() {
                self.coarsen()?;
            }
            return Ok(());
        }
        let last = self.session.engine().statistics();
        let traced = Traced {
            took: began.elapsed(),
            tiles: last.spus.iter().map(|spu| spu.tiles).sum(),
            left: last.tiles_left,
        };
        if self.pace.as_mut().is_some_and(|pace| pace.frame(traced)) {
            let framebuffer = self.framebuffer()?;
            self.show_on(framebuffer)?;
        }
        Ok(())
    }
}

/// Keeps the display responsive while a frame is traced, and shows a notice if that takes long.
fn keep_responsive(
    front: &mut Frontend,
    waiting: &mut Waiting,
    picture: Option<&RgbImage>,
    overlay: &Overlay,
    part: f64,
) {
    front.tracing();
    if let Some(text) = waiting.text(Instant::now(), part) {
        let overlay = Overlay { message: Some((text, 1.0)), ..overlay.clone() };
        front.show_overlay(picture, &overlay);
    }
}

/// The size in whose pixels the mouse moves. It is the display's if that is divided, so that it
/// stays the same when the divisor changes.
fn input_size(area: Geometry, pace: Option<&Pace>, picture: Geometry) -> Geometry {
    match pace {
        Some(_) => area,
        None => picture,
    }
}

/// How the current picture looks. While something moves, a picture of a divided size has one sample
/// a pixel; at rest, antialiasing is the last thing that refines it.
fn look_now(look: Look, pace: Option<&Pace>) -> Look {
    let is_coarse =
        pace.is_some_and(|pace| pace.tiles().is_none() || pace.divisor() > Divisor::ONE);
    match is_coarse {
        true => Look { samples: Samples::One, ..look },
        false => look,
    }
}

fn wanted_size(area: Geometry, pace: Option<&Pace>, fixed: Option<Geometry>) -> Geometry {
    let divisor = pace.map_or(Divisor::ONE, Pace::divisor);
    // Both sides are divided by the same, so that the proportions stay.
    let most = area.width.min(area.height) / MIN_SIDE;
    let side = |side: u32| divisor.of(side).max(side / most.max(1));
    match (pace, fixed) {
        (None, Some(size)) => size,
        _ => Geometry { width: side(area.width), height: side(area.height) },
    }
}

fn take_picture(picture: Option<&RgbImage>, options: &Options, stem: &str) -> String {
    let Some(picture) = picture else {
        return "this display can't be read back as a picture".to_owned();
    };
    match screenshot::write(&options.screenshots, stem, picture) {
        Ok(path) => format!("picture {}", path.display()),
        Err(error) => format!("no picture: {error}"),
    }
}

/// Converts a game's name to the beginning of a file's name.
fn file_stem(name: &str) -> String {
    let file = name.strip_prefix(VIEW).unwrap_or(name);
    let file = file.rsplit('/').next().unwrap_or_default();
    let letter = |letter: char| match letter {
        letter if letter.is_ascii_alphanumeric() => letter,
        _ => '-',
    };
    file.chars().map(letter).collect()
}

#[cfg(test)]
mod tests {
    use std::io;

    use cellray::framebuffer::FramebufferError;
    use cellray::game::{FixedSteps, Frame, Start, World, WorldError};
    use clap::Parser as _;

    use super::*;
    use crate::arguments::OneGame;
    use crate::display::DisplayEvent;

    /// A game that is over after three frames.
    #[derive(Default)]
    struct Short(u32);

    impl Game for Short {
        fn set_up(&mut self, _: &mut World, _: &Start) -> Result<(), WorldError> {
            Ok(())
        }
        fn update(&mut self, _: &mut World, _: &Frame<'_>) -> Result<(), WorldError> {
            self.0 += 1;
            Ok(())
        }
        fn status(&self) -> String {
            format!("{} points", self.0)
        }
        fn is_over(&self) -> bool {
            self.0 == 3
        }
    }

    /// A display that is closed once it has shown the end of the game twice.
    struct Watched {
        ends: u32,
    }

    impl Display for Watched {
        fn area(&self) -> Geometry {
            Geometry { width: 32, height: 18 }
        }
        fn scales(&self) -> bool {
            false
        }
        fn measure_in(&mut self, _: Geometry) {}
        fn framebuffer(
            &mut self,
            size: Geometry,
        ) -> Result<Box<dyn Framebuffer>, FramebufferError> {
            Ok(Box::new(Memory::new(size)?))
        }
        fn poll(&mut self, events: &mut Vec<DisplayEvent>) -> io::Result<()> {
            if self.ends == 2 {
                events.push(DisplayEvent::Closed);
            }
            Ok(())
        }
        fn draws(&self) -> bool {
            true
        }
        fn show(&mut self, _: &RgbImage, overlay: &Overlay) -> io::Result<()> {
            if overlay.notice.as_deref() == Some(OVER) {
                assert_eq!(overlay.status, ["3 points"]);
                self.ends += 1;
            }
            Ok(())
        }
    }

    fn played(arguments: &[&str]) -> Played {
        let options = OneGame::parse_from([&["game"], arguments].concat()).options;
        let player = Player {
            display: Box::new(Watched { ends: 0 }),
            devices: None,
            keys: None,
            may_print: false,
            look: Look::default(),
        };
        let clock = Box::new(FixedSteps(Duration::from_millis(20)));
        play(Box::new(Short::default()), 0, &options.session, clock, player, None)
            .expect("a session")
    }

    /// Else nobody could read the score.
    #[test]
    fn finished_game_stays_until_display_closes() {
        let watched = played(&[]);
        assert_eq!(watched.ending, Ending::Closed);
        // Nobody waits for a reader where a number of frames was asked for.
        assert_eq!(played(&["--frames", "9"]).ending, Ending::Over);
    }

    #[test]
    fn game_names_become_file_names() {
        assert_eq!(file_stem("view paper16.nff"), "paper16-nff");
        assert_eq!(file_stem("view my scene.nff"), "my-scene-nff");
        assert_eq!(file_stem("billiards"), "billiards");
        assert_eq!(file_stem("../.."), "--");
    }

    #[test]
    fn requested_size_is_kept() {
        let area = Geometry { width: 640, height: 360 };
        let fixed = Geometry { width: 33, height: 17 };
        assert_eq!(wanted_size(area, None, Some(fixed)), fixed);
        assert_eq!(wanted_size(area, None, None), area);
        let paced = wanted_size(area, Some(&Pace::new(false)), None);
        assert_eq!((paced.width, paced.height), (40, 22));
        let tiny = Geometry { width: 20, height: 3 };
        let paced = wanted_size(tiny, Some(&Pace::new(false)), None);
        assert_eq!((paced.width, paced.height), (20, 3));
        let small = Geometry { width: 80, height: 48 };
        let paced = wanted_size(small, Some(&Pace::new(false)), None);
        assert_eq!((paced.width, paced.height), (13, 8));
    }
}
