//! The frame loop: input, game, world, SPUs, picture; again.
//!
//! Owns the [`Session`] of a game. Invariant: the game is called in the thread that calls the session, once a
//! frame, and sleeps there while SPUs trace; what it is told comes from the clock and the input source, or from
//! a recording and from nothing else.

mod clock;
mod error;
mod frames;
mod merge;
mod pictures;
mod recording;

pub use clock::{Clock, FixedSteps, RealTime};
pub use error::SessionError;
pub use frames::{FrameRange, FrameRangeError};
pub use pictures::{Made, Pictures};
pub use recording::{Recording, RecordingError};

use std::io::Write;
use std::ops::ControlFlow;
use std::time::Duration;

use self::recording::{FrameRecord, Header, Recorder};
use super::{Game, Input, InputEvent, Moment, Start, World};
use crate::framebuffer::{Framebuffer, Interrupted};
use crate::spe::{Program, ProgramError};
use crate::{Engine, EngineError, LoopTime, Report, Settings};

/// Where input comes from.
pub trait InputSource {
    /// Appends what has happened since the last call; with [`ControlFlow::Break`] the session ends before the
    /// frame at hand.
    fn poll(&mut self, events: &mut Vec<InputEvent>) -> std::io::Result<ControlFlow<()>>;

    /// Told from time to time, while a frame is traced, which part of it is done, 0 to 1. A window answers its
    /// system then.
    fn tracing(&mut self, _part: f64) {}
}

/// No input at all.
#[derive(Clone, Copy, Debug, Default)]
pub struct NoInput;

impl InputSource for NoInput {
    fn poll(&mut self, _events: &mut Vec<InputEvent>) -> std::io::Result<ControlFlow<()>> {
        Ok(ControlFlow::Continue(()))
    }
}

/// No input, up to a signal.
impl InputSource for Interrupted {
    fn poll(&mut self, _events: &mut Vec<InputEvent>) -> std::io::Result<ControlFlow<()>> {
        Ok(match self.signal() {
            Some(_) => ControlFlow::Break(()),
            None => ControlFlow::Continue(()),
        })
    }
}

/// A game, its world and the SPUs that trace it.
///
/// ```
/// use std::time::Duration;
///
/// use cellray::Settings;
/// use cellray::framebuffer::{Geometry, Memory};
/// use cellray::game::{
///     DVec3, FixedSteps, Game, Material, Moment, Session, Start, World, WorldError,
/// };
///
/// struct Still;
///
/// impl Game for Still {
///     fn set_up(&mut self, world: &mut World, _: &Start) -> Result<(), WorldError> {
///         let red = world.add_material(Material::matte(0.9, 0.2, 0.1))?;
///         world.add_sphere(DVec3::ZERO, 1.0, red)?;
///         Ok(())
///     }
///     fn frame(&mut self, _: &mut World, _: &Moment<'_>) -> Result<(), WorldError> {
///         Ok(())
///     }
/// }
///
/// let picture = Memory::new(Geometry::new(32, 16)?)?;
/// let mut session = Session::start(Still, Settings::default(), Box::new(picture))?
///     .with_clock(Box::new(FixedSteps(Duration::from_millis(40))));
/// session.run(Some(3))?;
/// // What stands still is traced once.
/// assert_eq!(session.report().frames_traced, 1);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub struct Session<G> {
    game: G,
    world: World,
    engine: Engine,
    settings: Settings,
    /// Pixels across and down of the framebuffer.
    size: (u32, u32),
    start: Option<Start>,
    seed: u64,
    source: Box<dyn InputSource>,
    clock: Box<dyn Clock>,
    recorder: Option<Recorder>,
    replay: Option<Recording>,
    input: Input,
    /// The frame at hand; its buffers serve for the next.
    record: FrameRecord,
    frame: u64,
    time: Duration,
    report: Report,
}

impl<G: Game> Session<G> {
    /// Starts the SPUs, with the game's own program if it has one. The game is set up at the first frame; until
    /// something else is said there is no input, and at most sixty frames come a second.
    pub fn start(
        game: G,
        mut settings: Settings,
        framebuffer: Box<dyn Framebuffer>,
    ) -> Result<Self, SessionError> {
        if let Some(program) = game.program()? {
            settings.program = program;
        }
        let geometry = framebuffer.geometry();
        let size = (geometry.width, geometry.height);
        // It refuses what can't be: a number of SPUs for which there is no room in a report, either.
        let engine = Engine::start(settings, framebuffer)?;
        let report = Report::new(game.name(), size, settings.spus);
        Ok(Self {
            engine,
            game,
            world: World::new(),
            settings,
            size,
            start: None,
            seed: 0,
            source: Box::new(NoInput),
            clock: Box::new(RealTime::default()),
            recorder: None,
            replay: None,
            input: Input::default(),
            record: FrameRecord::default(),
            frame: 0,
            time: Duration::ZERO,
            report,
        })
    }

    /// Takes its input from there. With a recording that is played back, it is only asked whether to end.
    #[must_use]
    pub fn with_input(self, source: Box<dyn InputSource>) -> Self {
        Self { source, ..self }
    }

    /// Takes the time from there.
    #[must_use]
    pub fn with_clock(self, clock: Box<dyn Clock>) -> Self {
        Self { clock, ..self }
    }

    /// Gives the game another seed than 0.
    #[must_use]
    pub fn with_seed(self, seed: u64) -> Self {
        Self { seed, ..self }
    }

    /// Records the session from its first frame on.
    #[must_use]
    pub fn record_to(self, writer: Box<dyn Write>) -> Self {
        Self {
            recorder: Some(Recorder::new(writer)),
            ..self
        }
    }

    /// Plays a recording back: the game is told of the same seed, sizes, times and events, and after the last of
    /// them the session ends. The framebuffer may be of another size; the game is told the recorded one.
    ///
    /// # Errors
    /// One of another game.
    pub fn replaying(self, recording: Recording) -> Result<Self, SessionError> {
        let (recorded, name) = (recording.game(), self.game.name());
        if recorded != name {
            return Err(SessionError::OtherGame {
                recorded: recorded.to_owned(),
                game: name.to_owned(),
            });
        }
        Ok(Self {
            replay: Some(recording),
            ..self
        })
    }

    /// Runs until the game is over, the input ends, the recording does or so many frames are shown, and
    /// [finishes](Session::finish).
    pub fn run(&mut self, frames: Option<u64>) -> Result<&Report, SessionError> {
        let mut left = frames;
        while left != Some(0) {
            if self.frame()?.is_break() {
                break;
            }
            left = left.map(|left| left - 1);
        }
        self.finish()?;
        Ok(&self.report)
    }

    /// Writes what its recording still lacks. To be called after the last frame: where it isn't, what the disk
    /// refuses then is told to nobody. The session may go on all the same.
    pub fn finish(&mut self) -> Result<(), SessionError> {
        match &mut self.recorder {
            Some(recorder) => Ok(recorder.finish(&self.world)?),
            None => Ok(()),
        }
    }

    /// One frame, from the input to the picture; with [`ControlFlow::Break`], that the session is over. After the
    /// last one comes [`Session::finish`].
    pub fn frame(&mut self) -> Result<ControlFlow<()>, SessionError> {
        let began = LoopTime::now();
        let flow = self.next_frame();
        self.report.add_time_since(began);
        flow
    }

    /// One frame without its picture: the game is called, nothing is traced or shown. So a sequence of pictures
    /// may begin in the middle of a game.
    pub fn pass_over(&mut self) -> Result<ControlFlow<()>, SessionError> {
        Ok(match self.next_moment()? {
            ControlFlow::Continue(()) => self.end_frame(),
            over => over,
        })
    }

    fn next_frame(&mut self) -> Result<ControlFlow<()>, SessionError> {
        if self.next_moment()?.is_break() {
            return Ok(ControlFlow::Break(()));
        }
        let scene = self.world.scene(&self.settings.program)?;
        let source = &mut self.source;
        let statistics = self
            .engine
            .render(scene, &mut |part| source.tracing(part))?;
        self.report.add(statistics);
        Ok(self.end_frame())
    }

    fn end_frame(&mut self) -> ControlFlow<()> {
        self.frame += 1;
        if self.game.is_over() {
            ControlFlow::Break(())
        } else {
            ControlFlow::Continue(())
        }
    }

    /// From the input to the world of the frame at hand.
    fn next_moment(&mut self) -> Result<ControlFlow<()>, SessionError> {
        if self.start.is_none() {
            self.set_up()?;
        }
        self.record.clear();
        let flow = self.source.poll(&mut self.record.events);
        if flow.map_err(SessionError::Input)?.is_break() {
            return Ok(ControlFlow::Break(()));
        }
        // A game would not hear of others, and a recording has no word for them.
        self.record.events.retain(InputEvent::is_finite);
        merge::merge(&mut self.record.events);
        if !self.find_moment()? {
            return Ok(ControlFlow::Break(()));
        }
        self.input.begin_frame();
        for event in &self.record.events {
            self.input.apply(event);
        }
        let step = self.record.step();
        self.time += step;
        let last = (self.frame > 0).then(|| self.engine.statistics());
        let moment = Moment {
            frame: self.frame,
            time: self.time.as_secs_f64(),
            step: step.as_secs_f64(),
            input: &self.input,
            size: self.record.size.unwrap_or(self.size),
            last,
        };
        self.game.frame(&mut self.world, &moment)?;
        self.check_and_record()?;
        Ok(ControlFlow::Continue(()))
    }

    fn set_up(&mut self) -> Result<(), SessionError> {
        let replayed = self.replay.as_ref().map(Recording::start);
        let start = replayed.unwrap_or(Start {
            seed: self.seed,
            size: self.size,
        });
        self.game.set_up(&mut self.world, &start)?;
        if let Some(recorder) = &mut self.recorder {
            recorder.begin(&Header::new(self.game.name(), start))?;
        }
        self.start = Some(start);
        Ok(())
    }

    /// The time, size and events of the frame at hand; `false` where the recording has no more.
    fn find_moment(&mut self) -> Result<bool, SessionError> {
        match &mut self.replay {
            Some(recording) => {
                if !recording.next_frame(&mut self.record)? {
                    return Ok(false);
                }
                self.clock.pace(self.record.step());
            }
            None => {
                let step = self.clock.tick();
                let step = if self.frame == 0 {
                    Duration::ZERO
                } else {
                    step
                };
                self.record.set_step(step);
                self.record.size = Some(self.size);
            }
        }
        Ok(true)
    }

    /// Compares the world with the recorded one, or writes down what it is now.
    fn check_and_record(&mut self) -> Result<(), SessionError> {
        if let Some(expected) = self.record.world.filter(|_| self.replay.is_some())
            && self.world.checksum() != expected.0
        {
            return Err(SessionError::Diverged { frame: self.frame });
        }
        if let Some(recorder) = &mut self.recorder {
            recorder.frame(self.frame, &mut self.record, &self.world)?;
        }
        Ok(())
    }

    /// Shows the game elsewhere from now on, as in another size; gives what it was shown on.
    pub fn show_on(
        &mut self,
        framebuffer: Box<dyn Framebuffer>,
    ) -> Result<Box<dyn Framebuffer>, EngineError> {
        let geometry = framebuffer.geometry();
        let before = self.engine.show_on(framebuffer)?;
        self.size = (geometry.width, geometry.height);
        Ok(before)
    }

    /// What the frames so far have taken.
    #[must_use]
    pub fn report(&self) -> &Report {
        &self.report
    }

    /// The game.
    #[must_use]
    pub fn game(&self) -> &G {
        &self.game
    }

    /// The world, such as for a camera that the player moves beside the game. What is changed here is not in a
    /// recording: one that is made meanwhile is found to be of another world when it is played back.
    pub fn world(&mut self) -> &mut World {
        &mut self.world
    }

    /// What the player does in the frame at hand.
    #[must_use]
    pub fn input(&self) -> &Input {
        &self.input
    }

    /// The SPUs and their framebuffer.
    pub fn engine(&mut self) -> &mut Engine {
        &mut self.engine
    }
}

impl<G: Game + ?Sized> Game for Box<G> {
    fn name(&self) -> &str {
        (**self).name()
    }

    fn program(&self) -> Result<Option<Program>, ProgramError> {
        (**self).program()
    }

    fn set_up(&mut self, world: &mut World, start: &Start) -> Result<(), super::WorldError> {
        (**self).set_up(world, start)
    }

    fn frame(&mut self, world: &mut World, moment: &Moment<'_>) -> Result<(), super::WorldError> {
        (**self).frame(world, moment)
    }

    fn is_over(&self) -> bool {
        (**self).is_over()
    }
}
