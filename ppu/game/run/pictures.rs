//! Writes a game's frames as numbered pictures, except those that exist already.
//!
//! Invariants: a frame's picture depends only on the game, its seed, the recording, the size and
//! the frame's number, not on which other frames the same run makes. A picture is complete as soon
//! as a file has its name.

use super::{Clock, FrameRange, InputSource, Session, SessionError};
use crate::framebuffer::{FramebufferError, Labels, NumberedPath, write_labelled};
use crate::game::{Game, View};

/// Pictures of frames, named by the frames' numbers.
///
/// With a clock of [`FixedSteps`](super::FixedSteps), several runs that each make a part of a
/// sequence, on several machines too, make the same pictures as a single run.
///
/// ```
/// use std::time::Duration;
///
/// use cellray::Settings;
/// use cellray::framebuffer::{Geometry, Memory, NumberedPath};
/// use cellray::game::{
///     FixedSteps, Frame, FrameRange, Game, NoInput, Pictures, Session, Start, World, WorldError,
/// };
///
/// struct Dusk;
///
/// impl Game for Dusk {
///     fn set_up(&mut self, _: &mut World, _: &Start) -> Result<(), WorldError> {
///         Ok(())
///     }
///     fn update(&mut self, world: &mut World, frame: &Frame<'_>) -> Result<(), WorldError> {
///         world.set_background([0.9, 0.4, 0.2].map(|part| part / (1.0 + frame.time)))
///     }
/// }
///
/// # let folder = tempfile::tempdir()?;
/// # std::env::set_current_dir(folder.path())?;
/// let pictures = Pictures::new(NumberedPath::new("dusk-%03d.png")?);
/// let picture = Memory::new(Geometry::new(64, 36)?)?;
/// let mut session = Session::start(Dusk, Settings::default(), Box::new(picture))?;
/// let frames: FrameRange = "3..5".parse()?;
/// let mut clock = FixedSteps(Duration::from_millis(40));
/// let made = pictures.write(&mut session, frames, &mut clock, &mut NoInput)?;
/// assert_eq!((made.written, made.kept), (2, 0));
/// # assert!(std::path::Path::new("dusk-004.png").is_file());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct Pictures {
    paths: NumberedPath,
    /// Labels, and the view of the scene that they name.
    labels: Option<(Labels, View)>,
    /// Frames per second of an animation.
    rate: Option<u32>,
}

/// How many pictures a run wrote, and how many existed already.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Made {
    /// Pictures that were written.
    pub written: u64,
    /// Pictures that existed already.
    pub kept: u64,
}

impl Pictures {
    /// Pictures with these names.
    #[must_use]
    pub fn new(paths: NumberedPath) -> Self {
        Self { paths, labels: None, rate: None }
    }

    /// The same with these labels in each file, and with the frame's view where it differs from the
    /// scene's own.
    #[must_use]
    pub fn labelled(self, labels: Labels, own_view: View) -> Self {
        Self { labels: Some((labels, own_view)), ..self }
    }

    /// The same, where an animation plays this number of frames per second: labels have its time.
    #[must_use]
    pub fn animated(self, rate: u32) -> Self {
        Self { rate: Some(rate), ..self }
    }

    /// Plays the session up to the end of a range, and writes the frames of the range that don't
    /// exist yet. It ends earlier if the session or the input ends.
    ///
    /// # Errors
    /// - The session's framebuffer can't be read back; [`Memory`](crate::framebuffer::Memory) can.
    /// - A picture can't be written.
    /// - An input device fails, or any error of [`Session::step`].
    pub fn write<G: Game>(
        &self,
        session: &mut Session<G>,
        frames: FrameRange,
        clock: &mut dyn Clock,
        input: &mut dyn InputSource,
    ) -> Result<Made, SessionError> {
        let mut made = Made::default();
        let mut events = Vec::new();
        while session.next_frame() < frames.end {
            let number = session.next_frame();
            let Some(step) = session.wait(clock)? else {
                break;
            };
            let polled = input.poll(&mut events).map_err(SessionError::Input)?;
            if polled.is_break() {
                break;
            }
            let path = self.paths.of(number);
            let is_wanted = number >= frames.first;
            let flow = if !is_wanted || path.is_file() {
                made.kept += u64::from(is_wanted);
                session.skip_frame(step, &mut events)?
            } else {
                let flow = session.step(step, &mut events, &mut |part| input.tracing(part))?;
                let picture = session.picture().ok_or(FramebufferError::NoPicture)?;
                let mut labels = Labels::default();
                if let Some((common, own_view)) = &self.labels {
                    labels = common.clone();
                    labels.set_view(session.world().view(), own_view);
                    if let Some(rate) = self.rate {
                        labels.set("time", number as f64 / f64::from(rate));
                    }
                }
                write_labelled(&path, &picture, &labels)?;
                made.written += 1;
                flow
            };
            if flow.is_break() {
                break;
            }
        }
        session.finish()?;
        Ok(made)
    }
}
