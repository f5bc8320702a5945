//! A game's frames as numbered pictures: those that are wanted and not there yet.
//!
//! Invariants: a frame's picture depends on the game, its seed, the recording, the size and the frame's number
//! alone, not on which of them one run makes; a picture is whole as soon as it has its name.

use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};

use super::{FrameRange, Session, SessionError};
use crate::framebuffer::{
    Framebuffer, FramebufferError, Geometry, Memory, NumberedPath, Target, write_png,
};
use crate::game::Game;

/// Pictures of frames, by the frames' numbers.
///
/// Runs that make parts of them, on other machines too, make what one run would. The session's clock is to
/// be one of [`FixedSteps`](super::FixedSteps).
///
/// ```
/// use std::time::Duration;
///
/// use cellray::Settings;
/// use cellray::framebuffer::{Geometry, NumberedPath};
/// use cellray::game::{
///     FixedSteps, FrameRange, Game, Moment, Pictures, Session, Start, World, WorldError,
/// };
///
/// struct Dusk;
///
/// impl Game for Dusk {
///     fn set_up(&mut self, _: &mut World, _: &Start) -> Result<(), WorldError> {
///         Ok(())
///     }
///     fn frame(&mut self, world: &mut World, moment: &Moment<'_>) -> Result<(), WorldError> {
///         world.set_background([0.9, 0.4, 0.2].map(|part| part / (1.0 + moment.time)).into())
///     }
/// }
///
/// # let folder = tempfile::tempdir()?;
/// # std::env::set_current_dir(folder.path())?;
/// let pictures = Pictures::new(NumberedPath::new("dusk-%03d.png")?);
/// let picture = pictures.framebuffer(Geometry::new(64, 36)?)?;
/// let mut session = Session::start(Dusk, Settings::default(), picture)?
///     .with_clock(Box::new(FixedSteps(Duration::from_millis(40))));
/// let made = pictures.write(&mut session, "3..5".parse::<FrameRange>()?)?;
/// assert_eq!((made.written, made.kept), (2, 0));
/// # assert!(std::path::Path::new("dusk-004.png").is_file());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct Pictures {
    paths: NumberedPath,
    /// Number of the frame at hand, which the framebuffer is not told of otherwise.
    number: Arc<AtomicU64>,
}

/// What became of the pictures that were wanted.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Made {
    /// Written.
    pub written: u64,
    /// There already.
    pub kept: u64,
}

impl Pictures {
    /// Of these names.
    #[must_use]
    pub fn new(paths: NumberedPath) -> Self {
        Self {
            paths,
            number: Arc::default(),
        }
    }

    /// What the session that is to be written has to be started with.
    pub fn framebuffer(&self, size: Geometry) -> Result<Box<dyn Framebuffer>, FramebufferError> {
        Ok(Box::new(Numbered {
            memory: Memory::new(size)?,
            pictures: self.clone(),
        }))
    }

    /// Plays the session up to the end of a range, and writes those frames of the range that are not there. It
    /// ends earlier where the session does.
    pub fn write<G: Game>(
        &self,
        session: &mut Session<G>,
        frames: FrameRange,
    ) -> Result<Made, SessionError> {
        let mut made = Made::default();
        while session.frame < frames.end {
            let number = session.frame;
            self.number.store(number, Ordering::SeqCst);
            let is_wanted = number >= frames.first;
            let is_there = is_wanted && self.paths.of(number).is_file();
            let before = session.report.frames;
            let flow = if is_wanted && !is_there {
                session.frame()?
            } else {
                session.pass_over()?
            };
            let is_passed = session.frame > number;
            made.kept += u64::from(is_there && is_passed);
            made.written += u64::from(session.report.frames - before);
            if flow.is_break() {
                break;
            }
        }
        session.finish()?;
        Ok(made)
    }
}

/// A framebuffer whose frames become pictures of the numbers that they have in the game.
struct Numbered {
    memory: Memory,
    pictures: Pictures,
}

impl Framebuffer for Numbered {
    fn geometry(&self) -> Geometry {
        self.memory.geometry()
    }

    fn target(&mut self) -> Target {
        self.memory.target()
    }

    fn present(&mut self) -> Result<(), FramebufferError> {
        let Pictures { paths, number } = &self.pictures;
        let path = paths.of(number.load(Ordering::SeqCst));
        write_png(&path, &self.memory.rgb())
    }

    fn keeps_contents(&self) -> bool {
        self.memory.keeps_contents()
    }

    fn describe(&self) -> String {
        format!("PNG pictures, {}", self.geometry())
    }
}
