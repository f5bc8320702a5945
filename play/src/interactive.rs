//! A session in front of a player: frame by frame, with what is said over the picture, pictures taken of it and a
//! resolution that follows the load.

use std::cell::{Cell, RefCell};
use std::rc::Rc;
use std::time::{Duration, Instant};

use cellray::Report;
use cellray::framebuffer::{Geometry, Interrupted};
use cellray::game::{Clock, Game, Session};

use crate::arguments::Options;
use crate::display::Display;
use crate::error::PlayError;
use crate::front::{Ending, Front, FrontInput};
use crate::input::Hub;
use crate::meter::Meter;
use crate::pace::Pace;
use crate::recording;
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
    clock: Box<dyn Clock>,
    player: Player,
) -> Result<Played, PlayError> {
    let interrupted = Interrupted::install().map_err(PlayError::Signals)?;
    let mut display = player.display;
    let mut pace = (display.scales() && options.size.is_none()).then(Pace::new);
    let size = wanted_size(display.area(), pace.as_ref(), options.size);
    let framebuffer = display.framebuffer(size)?;
    let stem = file_stem(game.name());
    let traced_from = Rc::new(Cell::new(Instant::now()));
    let clock = Noted {
        clock,
        ticked: Rc::clone(&traced_from),
    };
    let front = Front::new(display, player.devices, player.keys, interrupted)
        .map_err(PlayError::Signals)?;
    let front = Rc::new(RefCell::new(front));
    let session = Session::start(game, options.settings()?, framebuffer)?
        .with_seed(seed)
        .with_clock(Box::new(clock))
        .with_input(Box::new(FrontInput(Rc::clone(&front))));
    let replay = options.replay.as_deref();
    let mut session = recording::connect(session, options.record.as_deref(), replay)?;
    let mut picture = (size.width, size.height);
    let mut meter = Meter::new(Instant::now());
    let mut has_overlay = !options.no_overlay;
    let mut kept = Vec::new();
    let mut left = options.frames.map(|range| range.end);
    let mut ending = Ending::Over;
    while left != Some(0) {
        let shown_before = session.report().frames;
        let flow = session.frame()?;
        let mut front = front.borrow_mut();
        let wishes = front.take_wishes();
        let mut messages = front.take_messages();
        if session.report().frames > shown_before {
            has_overlay ^= wishes.overlay;
            let area = front.display.area();
            let report = session.report().clone();
            let last = session.engine().statistics();
            let sizes = (picture, (area.width, area.height));
            let overlay = meter.frame(Instant::now(), &report, last, sizes);
            let overlay = has_overlay.then_some(overlay);
            front.display.show(overlay).map_err(PlayError::Show)?;
        }
        if wishes.screenshot {
            messages.push(take_picture(front.display.as_ref(), options, &stem));
        }
        for message in messages {
            meter.say(message.clone(), Instant::now());
            if player.may_talk {
                say(message);
            } else {
                kept.push(message);
            }
        }
        if flow.is_break() {
            ending = wishes.ending.unwrap_or(Ending::Over);
            break;
        }
        left = left.map(|left| left - 1);
        let is_traced = session.engine().statistics().is_traced();
        let took = is_traced.then(|| traced_from.get().elapsed());
        let is_other = pace.as_mut().is_some_and(|pace| pace.frame(took));
        if is_other || wishes.resized {
            let size = wanted_size(front.display.area(), pace.as_ref(), options.size);
            if front.display.scales() && (size.width, size.height) != picture {
                picture = (size.width, size.height);
                session.show_on(front.display.framebuffer(size)?)?;
            }
        }
    }
    session.finish()?;
    Ok(Played {
        ending,
        report: session.report().clone(),
        messages: kept,
    })
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

fn take_picture(display: &dyn Display, options: &Options, stem: &str) -> String {
    let Some(picture) = display.picture() else {
        return "no picture can be taken of this display".to_owned();
    };
    match screenshot::write(&options.screenshots, stem, &picture.to_image()) {
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

/// A clock that keeps in mind when it was last asked: the frame's work begins then.
struct Noted {
    clock: Box<dyn Clock>,
    ticked: Rc<Cell<Instant>>,
}

impl Clock for Noted {
    fn tick(&mut self) -> Duration {
        let step = self.clock.tick();
        self.ticked.set(Instant::now());
        step
    }

    fn pace(&mut self, step: Duration) {
        self.clock.pace(step);
        self.ticked.set(Instant::now());
    }
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
