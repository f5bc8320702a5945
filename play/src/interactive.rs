//! A session in front of a player: frame by frame, with what is said over the picture, pictures
//! taken of it and a resolution that follows the load.

use std::ops::ControlFlow;
use std::time::Instant;

use cellray::Report;
use cellray::framebuffer::{Geometry, Interrupted};
use cellray::game::{Clock, Game, InputEvent, Session, SessionError};
use image::RgbImage;

use crate::arguments::Options;
use crate::display::Display;
use crate::error::PlayError;
use crate::frontend::{Ending, Frontend};
use crate::input::Hub;
use crate::meter::Meter;
use crate::pace::Pace;
use crate::recording;
use crate::reload::Reload;
use crate::screenshot;
use crate::talk::say;
use crate::viewer::VIEW;

/// Fewer pixels across or down show nothing.
const LEAST_SIDE: u32 = 8;

/// What a session was.
#[derive(Debug)]
pub struct Played {
    /// Why it ended.
    pub ending: Ending,
    /// What its frames took.
    pub report: Report,
    /// What could not be said before: the terminal was the picture's.
    pub messages: Vec<String>,
}

/// What a session is seen and heard by.
pub struct Player {
    /// What is seen.
    pub display: Box<dyn Display>,
    /// Devices, if they are read.
    pub devices: Option<Hub>,
    /// A terminal whose keys are read beside them.
    pub keys: Option<Box<dyn Display>>,
    /// Whether messages may be written while it lasts.
    pub may_talk: bool,
}

/// Plays to an end.
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
    Ok(Played {
        ending,
        report: show.session.report().clone(),
        messages: show.kept,
    })
}

/// A session and what it is seen and heard by.
struct Show<'a> {
    session: Session<Box<dyn Game>>,
    front: Frontend,
    options: &'a Options,
    may_talk: bool,
    /// Pixels across and down that are traced.
    size: Geometry,
    /// What that follows, where no size is asked for.
    pace: Option<Pace>,
    meter: Meter,
    has_overlay: bool,
    /// Messages that are told at the end.
    kept: Vec<String>,
    /// What the session takes with the next step.
    events: Vec<InputEvent>,
    /// The frame that is seen, of a display that is drawn to.
    picture: Option<RgbImage>,
    /// What the names of pictures begin with.
    stem: String,
    /// What is loaded again when its files change.
    reload: Option<Reload<'a>>,
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
        let pace = (display.scales() && options.size.is_none()).then(Pace::new);
        let size = wanted_size(display.area(), pace.as_ref(), options.size);
        let framebuffer = display.framebuffer(size)?;
        let stem = file_stem(game.name());
        let front = Frontend::new(display, player.devices, player.keys, interrupted)
            .map_err(PlayError::Signals)?;
        let session = Session::start(game, options.settings()?, framebuffer)?.with_seed(seed);
        let replay = options.replay.as_deref();
        Ok(Self {
            session: recording::connect(session, options.record.as_deref(), replay)?,
            front,
            options,
            may_talk: player.may_talk,
            size,
            pace,
            meter: Meter::new(Instant::now()),
            has_overlay: !options.no_overlay,
            kept: Vec::new(),
            events: Vec::new(),
            picture: None,
            stem,
            reload: None,
        })
    }

    /// One frame: its time, what the player does, the session's step, what is said over the
    /// picture and done beside the game.
    fn frame(&mut self, clock: &mut dyn Clock) -> Result<ControlFlow<Ending>, PlayError> {
        self.reload()?;
        let step = self.session.wait(clock)?;
        let heard = self.front.poll(&mut self.events);
        let heard = heard.map_err(SessionError::Input)?;
        let began = Instant::now();
        let flow = match step.filter(|_| heard.is_continue()) {
            Some(step) => {
                let front = &mut self.front;
                let mut tracing = |_: f64| front.tracing();
                let events = &mut self.events;
                Some(self.session.step(step, events, &mut tracing)?)
            }
            None => None,
        };
        let requests = self.front.take_requests();
        if flow.is_some() {
            self.has_overlay ^= requests.overlay;
            self.show()?;
        }
        self.tell(requests.screenshot);
        if flow != Some(ControlFlow::Continue(())) {
            return Ok(ControlFlow::Break(requests.ending.unwrap_or(Ending::Over)));
        }
        self.fit(requests.resized, began)?;
        Ok(ControlFlow::Continue(()))
    }

    /// Goes on with the scene as its files have it now, if they have changed. What is wrong with
    /// them is a message, and the scene stays as it was.
    fn reload(&mut self) -> Result<(), PlayError> {
        let Some(reload) = &mut self.reload else {
            return Ok(());
        };
        match reload.viewer(self.session.world().view()) {
            None => Ok(()),
            Some(Err(error)) => {
                self.say(format!("not loaded: {error}"));
                Ok(())
            }
            Some(Ok(viewer)) => {
                let framebuffer = self.front.display.framebuffer(self.size)?;
                let settings = self.options.settings()?;
                self.session = Session::start(Box::new(viewer) as _, settings, framebuffer)?;
                self.say("loaded again".to_owned());
                Ok(())
            }
        }
    }

    /// Brings the frame before the player's eyes.
    fn show(&mut self) -> Result<(), PlayError> {
        let Geometry { width, height } = self.front.display.area();
        let sizes = ((self.size.width, self.size.height), (width, height));
        let report = self.session.report().clone();
        let last = self.session.engine().statistics();
        let overlay = self.meter.frame(Instant::now(), &report, last, sizes);
        let overlay = self.has_overlay.then_some(overlay);
        let display = &mut self.front.display;
        if !display.draws() {
            return Ok(());
        }
        self.picture = self.session.picture();
        match &self.picture {
            Some(picture) => display.show(picture, overlay).map_err(PlayError::Show),
            None => Ok(()),
        }
    }

    /// Says what the devices have to say, and what has become of a picture that was asked for.
    fn tell(&mut self, takes_picture: bool) {
        let mut messages = self.front.take_messages();
        if takes_picture {
            let picture = self.picture.as_ref();
            messages.push(take_picture(picture, self.options, &self.stem));
        }
        for message in messages {
            self.say(message);
        }
    }

    fn say(&mut self, message: String) {
        self.meter.say(message.clone(), Instant::now());
        if self.may_talk {
            say(message);
        } else {
            self.kept.push(message);
        }
    }

    /// Has the next frame as fine as this one's time allows, and as large as the display.
    fn fit(&mut self, is_resized: bool, began: Instant) -> Result<(), PlayError> {
        let is_traced = self.session.engine().statistics().is_traced();
        let took = is_traced.then(|| began.elapsed());
        let is_other = self.pace.as_mut().is_some_and(|pace| pace.frame(took));
        if !is_other && !is_resized {
            return Ok(());
        }
        let display = &mut self.front.display;
        let size = wanted_size(display.area(), self.pace.as_ref(), self.options.size);
        if display.scales() && size != self.size {
            self.size = size;
            self.session.show_on(display.framebuffer(size)?)?;
        }
        Ok(())
    }
}

fn wanted_size(area: Geometry, pace: Option<&Pace>, fixed: Option<Geometry>) -> Geometry {
    let divisor = pace.map_or(1, Pace::divisor);
    let side = |side: u32| (side / divisor).max(LEAST_SIDE).min(side.max(1));
    match (pace, fixed) {
        (None, Some(size)) => size,
        _ => Geometry {
            width: side(area.width),
            height: side(area.height),
        },
    }
}

fn take_picture(picture: Option<&RgbImage>, options: &Options, stem: &str) -> String {
    let Some(picture) = picture else {
        return "no picture can be taken of this display".to_owned();
    };
    match screenshot::write(&options.screenshots, stem, picture) {
        Ok(path) => format!("picture {}", path.display()),
        Err(error) => format!("no picture: {error}"),
    }
}

/// A game's name as the beginning of a file's.
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
    use super::*;

    #[test]
    fn names_become_those_of_files() {
        assert_eq!(file_stem("view paper16.nff"), "paper16-nff");
        assert_eq!(file_stem("view my scene.nff"), "my-scene-nff");
        assert_eq!(file_stem("billiards"), "billiards");
        assert_eq!(file_stem("../.."), "--");
    }

    #[test]
    fn a_size_that_is_asked_for_is_kept() {
        let area = Geometry {
            width: 640,
            height: 360,
        };
        let fixed = Geometry {
            width: 33,
            height: 17,
        };
        assert_eq!(wanted_size(area, None, Some(fixed)), fixed);
        assert_eq!(wanted_size(area, None, None), area);
        let paced = wanted_size(area, Some(&Pace::new()), None);
        assert_eq!((paced.width, paced.height), (160, 90));
        let tiny = Geometry {
            width: 20,
            height: 3,
        };
        let paced = wanted_size(tiny, Some(&Pace::new()), None);
        assert_eq!((paced.width, paced.height), (8, 3));
    }
}
